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
    var phi_718_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_718_ = param_1;
    } else {
        phi_718_ = param;
    }
    let _e26 = phi_718_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_579_: f32;
    var phi_580_: f32;
    var phi_619_: f32;
    var phi_620_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_400_: f32;
    var phi_401_: f32;
    var phi_446_: f32;
    var phi_447_: f32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_538_: f32;
    var phi_539_: f32;
    var phi_681_: array<array<f32, 3>, 4>;

    let _e9 = (param_2[0] - param_3[0]);
    let _e12 = (param_2[1] - param_3[1]);
    let _e15 = (param_2[2] - param_3[2]);
    if (param_5 != 0u) {
        let _e157 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_400_ = _e157;
            } else {
                phi_400_ = 1f;
            }
            let _e161 = phi_400_;
            phi_401_ = _e161;
        } else {
            phi_401_ = 0f;
        }
        let _e163 = phi_401_;
        let _e199 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_446_ = _e199;
            } else {
                phi_446_ = 1f;
            }
            let _e203 = phi_446_;
            phi_447_ = _e203;
        } else {
            phi_447_ = 0f;
        }
        let _e205 = phi_447_;
        let _e238 = ((((_e9 * param_4[0]) + (_e12 * param_4[1])) + (_e15 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_489_ = _e238;
            } else {
                phi_489_ = 1f;
            }
            let _e242 = phi_489_;
            phi_490_ = _e242;
        } else {
            phi_490_ = 0f;
        }
        let _e244 = phi_490_;
        let _e257 = (param_2[0] - param_4[0]);
        let _e260 = (param_2[1] - param_4[1]);
        let _e263 = (param_2[2] - param_4[2]);
        let _e283 = ((((_e257 * param_3[0]) + (_e260 * param_3[1])) + (_e263 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_538_ = _e283;
            } else {
                phi_538_ = 1f;
            }
            let _e287 = phi_538_;
            phi_539_ = _e287;
        } else {
            phi_539_ = 0f;
        }
        let _e289 = phi_539_;
        phi_681_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e163)), (param_2[1] - (param_3[1] * _e163)), (param_2[2] - (param_3[2] * _e163))), array<f32, 3>((param_2[0] - (param_4[0] * _e205)), (param_2[1] - (param_4[1] * _e205)), (param_2[2] - (param_4[2] * _e205))), array<f32, 3>((_e9 - (param_4[0] * _e244)), (_e12 - (param_4[1] * _e244)), (_e15 - (param_4[2] * _e244))), array<f32, 3>((_e257 - (param_3[0] * _e289)), (_e260 - (param_3[1] * _e289)), (_e263 - (param_3[2] * _e289))));
    } else {
        let _e19 = (param_4[0] - param_3[0]);
        let _e22 = (param_4[1] - param_3[1]);
        let _e25 = (param_4[2] - param_3[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_579_ = _e36;
            } else {
                phi_579_ = 1f;
            }
            let _e40 = phi_579_;
            phi_580_ = _e40;
        } else {
            phi_580_ = 0f;
        }
        let _e42 = phi_580_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_619_ = _e72;
            } else {
                phi_619_ = 1f;
            }
            let _e76 = phi_619_;
            phi_620_ = _e76;
        } else {
            phi_620_ = 0f;
        }
        let _e78 = phi_620_;
        let _e114 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_665_ = _e114;
            } else {
                phi_665_ = 1f;
            }
            let _e118 = phi_665_;
            phi_666_ = _e118;
        } else {
            phi_666_ = 0f;
        }
        let _e120 = phi_666_;
        phi_681_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e78)), (param_2[1] - (param_3[1] * _e78)), (param_2[2] - (param_3[2] * _e78))), array<f32, 3>((param_2[0] - (param_4[0] * _e120)), (param_2[1] - (param_4[1] * _e120)), (param_2[2] - (param_4[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_681_;
    let _e305 = function_(_e302[0], _e302[1]);
    let _e307 = function_(_e305, _e302[2]);
    let _e309 = function_(_e307, _e302[3]);
    return _e309;
}

fn function_2(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_308_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_290_: bool;
    var phi_309_: bool;
    var phi_342_: array<f32, 3>;
    var phi_343_: bool;
    var phi_344_: array<f32, 3>;
    var phi_345_: bool;
    var phi_350_: array<f32, 3>;

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
                    phi_281_ = (_e78 <= 1f);
                    phi_282_ = false;
                } else {
                    phi_281_ = bool();
                    phi_282_ = true;
                }
                let _e99 = phi_281_;
                let _e101 = phi_282_;
                phi_283_ = _e99;
                phi_284_ = _e101;
            } else {
                phi_283_ = bool();
                phi_284_ = true;
            }
            let _e103 = phi_283_;
            let _e105 = phi_284_;
            phi_285_ = _e103;
            phi_286_ = _e105;
        } else {
            phi_285_ = bool();
            phi_286_ = true;
        }
        let _e107 = phi_285_;
        let _e109 = phi_286_;
        if _e109 {
            phi_290_ = false;
        } else {
            phi_290_ = _e107;
        }
        let _e111 = phi_290_;
        phi_309_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_301_ = ((_e74 + _e78) <= 1f);
                phi_302_ = false;
            } else {
                phi_301_ = bool();
                phi_302_ = true;
            }
            let _e85 = phi_301_;
            let _e87 = phi_302_;
            phi_303_ = _e85;
            phi_304_ = _e87;
        } else {
            phi_303_ = bool();
            phi_304_ = true;
        }
        let _e89 = phi_303_;
        let _e91 = phi_304_;
        if _e91 {
            phi_308_ = false;
        } else {
            phi_308_ = _e89;
        }
        let _e93 = phi_308_;
        phi_309_ = _e93;
    }
    let _e113 = phi_309_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_342_ = array<f32, 3>((param_6[0] - ((param_7[0] * _e74) + (param_8[0] * _e78))), (param_6[1] - ((param_7[1] * _e74) + (param_8[1] * _e78))), (param_6[2] - ((param_7[2] * _e74) + (param_8[2] * _e78))));
            phi_343_ = false;
        } else {
            phi_342_ = array<f32, 3>();
            phi_343_ = true;
        }
        let _e141 = phi_342_;
        let _e143 = phi_343_;
        phi_344_ = _e141;
        phi_345_ = _e143;
    } else {
        phi_344_ = array<f32, 3>();
        phi_345_ = true;
    }
    let _e145 = phi_344_;
    let _e147 = phi_345_;
    if _e147 {
        let _e148 = function_1(param_6, param_7, param_8, param_9);
        phi_350_ = _e148;
    } else {
        phi_350_ = _e145;
    }
    let _e150 = phi_350_;
    return _e150;
}

fn function_3(param_10: f32) -> array<u32, 2> {
    var phi_733_: array<u32, 2>;

    let _e7 = bitcast<u32>(param_10);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_733_ = array<u32, 2>(0u, 0u);
    } else {
        phi_733_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_733_;
    return _e19;
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
    var phi_792_: u32;
    var phi_802_: u32;
    var phi_809_: u32;
    var phi_825_: u32;
    var phi_846_: u32;
    var phi_847_: u32;
    var phi_850_: type_12;
    var phi_851_: type_12;
    var phi_874_: type_12;
    var phi_1049_: array<u32, 2>;
    var phi_1063_: bool;
    var phi_1079_: bool;
    var phi_1085_: f32;
    var phi_1091_: f32;
    var phi_1096_: f32;
    var phi_1102_: f32;
    var phi_1107_: f32;
    var phi_1113_: f32;
    var phi_1119_: f32;
    var phi_1124_: f32;
    var phi_1130_: f32;
    var phi_1135_: f32;
    var phi_1140_: f32;
    var phi_1147_: f32;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1175_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1202_: f32;
    var phi_1209_: f32;
    var phi_1215_: f32;
    var phi_1220_: f32;
    var phi_1226_: f32;
    var phi_1231_: f32;
    var phi_1237_: f32;
    var phi_1243_: f32;
    var phi_1248_: f32;
    var phi_1254_: f32;
    var phi_1259_: f32;
    var phi_1264_: f32;
    var phi_1270_: f32;
    var phi_1275_: f32;
    var phi_1282_: bool;
    var phi_1306_: u32;
    var phi_1317_: f32;
    var phi_1318_: f32;
    var phi_1351_: type_38;
    var phi_1352_: bool;
    var phi_1353_: type_38;
    var phi_1354_: bool;
    var phi_1355_: type_38;
    var phi_1356_: bool;
    var phi_1361_: type_38;
    var phi_8307_: f32;
    var phi_8314_: f32;
    var phi_8319_: f32;
    var phi_8326_: f32;
    var phi_8331_: f32;
    var phi_8344_: f32;
    var phi_8351_: f32;
    var phi_8356_: f32;
    var phi_8363_: f32;
    var phi_8368_: f32;
    var phi_8373_: f32;
    var phi_8390_: f32;
    var phi_8397_: f32;
    var phi_8402_: f32;
    var phi_8409_: f32;
    var phi_8414_: f32;
    var phi_8428_: f32;
    var phi_8435_: f32;
    var phi_8440_: f32;
    var phi_8447_: f32;
    var phi_8452_: f32;
    var phi_8457_: f32;
    var phi_8474_: f32;
    var phi_8481_: f32;
    var phi_8486_: f32;
    var phi_8493_: f32;
    var phi_8498_: f32;
    var phi_8512_: f32;
    var phi_8519_: f32;
    var phi_8524_: f32;
    var phi_8531_: f32;
    var phi_8536_: f32;
    var phi_8541_: f32;
    var phi_8572_: f32;
    var phi_8578_: f32;
    var phi_8585_: f32;
    var phi_8592_: f32;
    var phi_8598_: f32;
    var phi_8605_: f32;
    var phi_8611_: f32;
    var phi_8617_: f32;
    var phi_8623_: f32;
    var phi_8630_: f32;
    var phi_8637_: f32;
    var phi_8661_: f32;
    var phi_8666_: f32;
    var phi_8671_: f32;
    var phi_8676_: f32;
    var phi_8681_: f32;
    var phi_8686_: f32;
    var phi_8696_: f32;
    var phi_8709_: f32;
    var phi_8715_: f32;
    var phi_8720_: f32;
    var phi_8726_: f32;
    var phi_8732_: f32;
    var phi_8737_: f32;
    var phi_8742_: f32;
    var phi_8750_: bool;
    var phi_8755_: f32;
    var phi_8762_: f32;
    var phi_8768_: f32;
    var phi_8786_: f32;
    var phi_8934_: f32;
    var phi_8941_: f32;
    var phi_8946_: f32;
    var phi_8953_: f32;
    var phi_8958_: f32;
    var phi_8971_: f32;
    var phi_8978_: f32;
    var phi_8983_: f32;
    var phi_8990_: f32;
    var phi_8995_: f32;
    var phi_9000_: f32;
    var phi_9017_: f32;
    var phi_9024_: f32;
    var phi_9029_: f32;
    var phi_9036_: f32;
    var phi_9041_: f32;
    var phi_9055_: f32;
    var phi_9062_: f32;
    var phi_9067_: f32;
    var phi_9074_: f32;
    var phi_9079_: f32;
    var phi_9084_: f32;
    var phi_9101_: f32;
    var phi_9108_: f32;
    var phi_9113_: f32;
    var phi_9120_: f32;
    var phi_9125_: f32;
    var phi_9139_: f32;
    var phi_9146_: f32;
    var phi_9151_: f32;
    var phi_9158_: f32;
    var phi_9163_: f32;
    var phi_9168_: f32;
    var phi_9286_: f32;
    var phi_9293_: f32;
    var phi_9301_: f32;
    var phi_9345_: type_14;
    var phi_9348_: f32;
    var phi_9369_: bool;
    var phi_9375_: type_15;
    var phi_9346_: type_14;
    var phi_9389_: type_15;
    var phi_9349_: f32;
    var local_19: f32;
    var phi_9338_: f32;
    var phi_9402_: f32;
    var phi_9468_: f32;
    var phi_9474_: f32;
    var phi_9483_: f32;
    var phi_9489_: f32;
    var phi_9498_: f32;
    var phi_9504_: f32;
    var phi_9513_: f32;
    var phi_9519_: f32;
    var phi_9525_: type_32;
    var phi_9526_: bool;
    var phi_9527_: type_32;
    var phi_9528_: bool;
    var phi_9536_: type_32;
    var phi_9705_: bool;
    var phi_9706_: bool;
    var phi_9707_: bool;
    var phi_9708_: bool;
    var phi_9709_: bool;
    var phi_9710_: bool;
    var phi_9714_: bool;
    var phi_9741_: f32;
    var phi_9795_: type_14;
    var phi_9798_: f32;
    var phi_9819_: bool;
    var phi_9825_: type_15;
    var phi_9796_: type_14;
    var phi_9839_: type_15;
    var phi_9799_: f32;
    var local_20: f32;
    var phi_9788_: f32;
    var phi_9852_: f32;
    var phi_9918_: f32;
    var phi_9924_: f32;
    var phi_9933_: f32;
    var phi_9939_: f32;
    var phi_9948_: f32;
    var phi_9954_: f32;
    var phi_9963_: f32;
    var phi_9969_: f32;
    var phi_9975_: type_32;
    var phi_9976_: bool;
    var phi_9977_: type_32;
    var phi_9978_: bool;
    var phi_9986_: type_32;
    var phi_10155_: bool;
    var phi_10156_: bool;
    var phi_10157_: bool;
    var phi_10158_: bool;
    var phi_10159_: bool;
    var phi_10160_: bool;
    var phi_10164_: bool;
    var phi_10197_: f32;
    var phi_10245_: type_14;
    var phi_10248_: f32;
    var phi_10269_: bool;
    var phi_10275_: type_15;
    var phi_10246_: type_14;
    var phi_10289_: type_15;
    var phi_10249_: f32;
    var local_21: f32;
    var phi_10238_: f32;
    var phi_10302_: f32;
    var phi_10368_: f32;
    var phi_10374_: f32;
    var phi_10383_: f32;
    var phi_10389_: f32;
    var phi_10398_: f32;
    var phi_10404_: f32;
    var phi_10413_: f32;
    var phi_10419_: f32;
    var phi_10425_: type_32;
    var phi_10426_: bool;
    var phi_10427_: type_32;
    var phi_10428_: bool;
    var phi_10436_: type_32;
    var phi_10605_: bool;
    var phi_10606_: bool;
    var phi_10607_: bool;
    var phi_10608_: bool;
    var phi_10609_: bool;
    var phi_10610_: bool;
    var phi_10614_: bool;
    var phi_10654_: f32;
    var phi_10695_: type_14;
    var phi_10698_: f32;
    var phi_10719_: bool;
    var phi_10725_: type_15;
    var phi_10696_: type_14;
    var phi_10739_: type_15;
    var phi_10699_: f32;
    var local_22: f32;
    var phi_10688_: f32;
    var phi_10752_: f32;
    var phi_10818_: f32;
    var phi_10824_: f32;
    var phi_10833_: f32;
    var phi_10839_: f32;
    var phi_10848_: f32;
    var phi_10854_: f32;
    var phi_10863_: f32;
    var phi_10869_: f32;
    var phi_10875_: type_32;
    var phi_10876_: bool;
    var phi_10877_: type_32;
    var phi_10878_: bool;
    var phi_10886_: type_32;
    var phi_11055_: bool;
    var phi_11056_: bool;
    var phi_11057_: bool;
    var phi_11058_: bool;
    var phi_11059_: bool;
    var phi_11060_: bool;
    var phi_11064_: bool;
    var phi_11065_: bool;
    var phi_11066_: bool;
    var phi_11067_: bool;
    var phi_11068_: bool;
    var phi_11069_: bool;
    var phi_11073_: bool;
    var phi_11079_: type_28;
    var phi_11080_: bool;
    var phi_11081_: type_28;
    var phi_11082_: bool;
    var phi_11125_: type_14;
    var phi_11128_: f32;
    var phi_11149_: bool;
    var phi_11155_: type_15;
    var phi_11126_: type_14;
    var phi_11169_: type_15;
    var phi_11129_: f32;
    var local_23: f32;
    var phi_11118_: f32;
    var phi_11182_: f32;
    var phi_11188_: f32;
    var phi_11213_: type_12;
    var phi_11216_: u32;
    var phi_11214_: type_12;
    var phi_11239_: type_12;
    var phi_11283_: u32;
    var phi_11284_: u32;
    var phi_11217_: u32;
    var phi_11285_: u32;
    var phi_11305_: type_12;
    var phi_11306_: type_12;
    var phi_11329_: type_12;
    var phi_11348_: f32;
    var phi_11361_: f32;
    var phi_11395_: f32;
    var phi_11402_: f32;
    var phi_11413_: bool;
    var phi_11414_: bool;
    var phi_11415_: bool;
    var phi_11416_: bool;
    var phi_11420_: bool;
    var phi_11431_: type_41;
    var phi_11432_: type_41;
    var phi_11433_: bool;
    var phi_11434_: type_41;
    var phi_11435_: bool;
    var phi_11446_: f32;
    var phi_11456_: type_12;
    var phi_11459_: f32;
    var phi_11461_: f32;
    var phi_11463_: f32;
    var phi_11457_: type_12;
    var phi_11486_: type_12;
    var phi_11511_: f32;
    var phi_11512_: f32;
    var phi_11538_: f32;
    var phi_11554_: f32;
    var phi_11561_: bool;
    var phi_11562_: bool;
    var phi_11563_: bool;
    var phi_11569_: f32;
    var phi_11570_: f32;
    var phi_11571_: bool;
    var phi_11460_: f32;
    var phi_11462_: f32;
    var phi_11464_: f32;
    var phi_11572_: f32;
    var phi_11573_: bool;
    var phi_11574_: bool;
    var local_24: bool;
    var phi_11578_: f32;
    var phi_11579_: f32;
    var phi_11587_: f32;
    var phi_11591_: type_12;
    var phi_11594_: f32;
    var phi_11592_: type_12;
    var phi_11617_: type_12;
    var phi_11647_: f32;
    var phi_11648_: bool;
    var phi_11649_: f32;
    var phi_11650_: bool;
    var phi_11651_: bool;
    var phi_11652_: bool;
    var phi_11653_: f32;
    var phi_11595_: f32;
    var phi_11654_: bool;
    var phi_11655_: bool;
    var phi_11656_: bool;
    var phi_11657_: bool;
    var local_25: bool;
    var phi_11661_: bool;
    var phi_11662_: bool;
    var phi_11666_: bool;
    var phi_11670_: f32;
    var phi_11671_: f32;
    var phi_11673_: type_41;
    var phi_11702_: f32;
    var phi_11709_: f32;
    var phi_11714_: f32;
    var phi_11721_: f32;
    var phi_11726_: f32;
    var phi_11739_: f32;
    var phi_11746_: f32;
    var phi_11751_: f32;
    var phi_11758_: f32;
    var phi_11763_: f32;
    var phi_11768_: f32;
    var phi_11827_: f32;
    var phi_11833_: f32;
    var phi_11838_: f32;
    var phi_11844_: f32;
    var phi_11849_: f32;
    var phi_11861_: f32;
    var phi_11867_: f32;
    var phi_11872_: f32;
    var phi_11878_: f32;
    var phi_11883_: f32;
    var phi_11909_: f32;
    var phi_11916_: f32;
    var phi_11921_: f32;
    var phi_11928_: f32;
    var phi_11933_: f32;
    var phi_11946_: f32;
    var phi_11953_: f32;
    var phi_11958_: f32;
    var phi_11965_: f32;
    var phi_11970_: f32;
    var phi_11975_: f32;
    var phi_12034_: f32;
    var phi_12040_: f32;
    var phi_12045_: f32;
    var phi_12051_: f32;
    var phi_12056_: f32;
    var phi_12068_: f32;
    var phi_12074_: f32;
    var phi_12079_: f32;
    var phi_12085_: f32;
    var phi_12090_: f32;
    var phi_12116_: f32;
    var phi_12123_: f32;
    var phi_12128_: f32;
    var phi_12135_: f32;
    var phi_12140_: f32;
    var phi_12153_: f32;
    var phi_12160_: f32;
    var phi_12165_: f32;
    var phi_12172_: f32;
    var phi_12177_: f32;
    var phi_12182_: f32;
    var phi_12241_: f32;
    var phi_12247_: f32;
    var phi_12252_: f32;
    var phi_12258_: f32;
    var phi_12263_: f32;
    var phi_12275_: f32;
    var phi_12281_: f32;
    var phi_12286_: f32;
    var phi_12292_: f32;
    var phi_12297_: f32;
    var phi_12346_: f32;
    var phi_12352_: f32;
    var phi_12380_: f32;
    var phi_12386_: f32;
    var phi_12391_: u32;
    var phi_12392_: u32;
    var phi_12362_: f32;
    var phi_12368_: f32;
    var phi_12373_: u32;
    var phi_12374_: u32;
    var phi_12393_: u32;
    var phi_12394_: u32;
    var phi_12463_: f32;
    var phi_12472_: f32;
    var phi_12607_: f32;
    var phi_12613_: f32;
    var phi_12620_: f32;
    var phi_12675_: type_12;
    var phi_12678_: bool;
    var phi_12676_: type_12;
    var phi_12701_: type_12;
    var phi_12728_: bool;
    var phi_12729_: bool;
    var phi_12679_: bool;
    var phi_12730_: bool;
    var phi_12731_: bool;
    var local_26: bool;
    var phi_12735_: bool;
    var local_27: bool;
    var phi_12742_: u32;
    var phi_12743_: u32;
    var phi_12744_: bool;
    var phi_12745_: u32;
    var phi_12746_: u32;
    var phi_12747_: bool;
    var phi_12751_: u32;
    var phi_12761_: bool;
    var phi_12773_: bool;
    var phi_12774_: bool;
    var phi_12922_: f32;
    var phi_12929_: f32;
    var phi_12934_: f32;
    var phi_12941_: f32;
    var phi_12946_: f32;
    var phi_12959_: f32;
    var phi_12966_: f32;
    var phi_12971_: f32;
    var phi_12978_: f32;
    var phi_12983_: f32;
    var phi_12988_: f32;
    var phi_13005_: f32;
    var phi_13012_: f32;
    var phi_13017_: f32;
    var phi_13024_: f32;
    var phi_13029_: f32;
    var phi_13043_: f32;
    var phi_13050_: f32;
    var phi_13055_: f32;
    var phi_13062_: f32;
    var phi_13067_: f32;
    var phi_13072_: f32;
    var phi_13089_: f32;
    var phi_13096_: f32;
    var phi_13101_: f32;
    var phi_13108_: f32;
    var phi_13113_: f32;
    var phi_13127_: f32;
    var phi_13134_: f32;
    var phi_13139_: f32;
    var phi_13146_: f32;
    var phi_13151_: f32;
    var phi_13156_: f32;
    var phi_13197_: type_12;
    var phi_13200_: f32;
    var phi_13202_: f32;
    var phi_13204_: f32;
    var phi_13206_: f32;
    var phi_13208_: bool;
    var phi_13210_: u32;
    var phi_13198_: type_12;
    var phi_13233_: type_12;
    var phi_13347_: f32;
    var phi_13353_: f32;
    var phi_13359_: f32;
    var phi_13361_: array<f32, 3>;
    var phi_13368_: f32;
    var phi_13375_: f32;
    var phi_13383_: f32;
    var phi_13427_: type_14;
    var phi_13430_: f32;
    var phi_13451_: bool;
    var phi_13457_: type_15;
    var phi_13428_: type_14;
    var phi_13471_: type_15;
    var phi_13431_: f32;
    var local_28: f32;
    var phi_13420_: f32;
    var phi_13484_: f32;
    var phi_13550_: f32;
    var phi_13556_: f32;
    var phi_13565_: f32;
    var phi_13571_: f32;
    var phi_13580_: f32;
    var phi_13586_: f32;
    var phi_13595_: f32;
    var phi_13601_: f32;
    var phi_13607_: type_32;
    var phi_13608_: bool;
    var phi_13609_: type_32;
    var phi_13610_: bool;
    var phi_13618_: type_32;
    var phi_13789_: bool;
    var phi_13790_: bool;
    var phi_13791_: bool;
    var phi_13792_: bool;
    var phi_13793_: bool;
    var phi_13794_: bool;
    var phi_13798_: bool;
    var phi_14095_: bool;
    var phi_14096_: bool;
    var phi_14097_: bool;
    var phi_14098_: bool;
    var phi_14099_: bool;
    var phi_14100_: bool;
    var phi_14104_: bool;
    var phi_14108_: bool;
    var phi_14119_: bool;
    var phi_14120_: bool;
    var phi_14194_: bool;
    var phi_14195_: bool;
    var phi_14215_: f32;
    var phi_14216_: bool;
    var phi_14217_: f32;
    var phi_14218_: bool;
    var phi_14219_: f32;
    var phi_14220_: bool;
    var phi_14221_: bool;
    var phi_14225_: f32;
    var phi_14226_: bool;
    var phi_14230_: f32;
    var phi_14262_: bool;
    var phi_14263_: bool;
    var phi_14283_: f32;
    var phi_14284_: bool;
    var phi_14285_: f32;
    var phi_14286_: bool;
    var phi_14287_: f32;
    var phi_14288_: bool;
    var phi_14289_: bool;
    var phi_14293_: f32;
    var phi_14294_: bool;
    var phi_14298_: f32;
    var phi_14303_: f32;
    var phi_14335_: bool;
    var phi_14336_: bool;
    var phi_14356_: f32;
    var phi_14357_: bool;
    var phi_14358_: f32;
    var phi_14359_: bool;
    var phi_14360_: f32;
    var phi_14361_: bool;
    var phi_14362_: bool;
    var phi_14366_: f32;
    var phi_14367_: bool;
    var phi_14371_: f32;
    var phi_14403_: bool;
    var phi_14404_: bool;
    var phi_14424_: f32;
    var phi_14425_: bool;
    var phi_14426_: f32;
    var phi_14427_: bool;
    var phi_14428_: f32;
    var phi_14429_: bool;
    var phi_14430_: bool;
    var phi_14434_: f32;
    var phi_14435_: bool;
    var phi_14439_: f32;
    var phi_14444_: f32;
    var phi_14449_: f32;
    var phi_14454_: f32;
    var phi_14948_: bool;
    var phi_14949_: bool;
    var phi_14954_: f32;
    var phi_14956_: f32;
    var phi_14959_: f32;
    var phi_14960_: f32;
    var phi_14961_: bool;
    var phi_14963_: f32;
    var phi_14964_: f32;
    var phi_14965_: f32;
    var phi_14967_: bool;
    var phi_14968_: bool;
    var phi_14970_: bool;
    var phi_14971_: f32;
    var phi_14972_: f32;
    var phi_14973_: f32;
    var phi_14975_: bool;
    var phi_14976_: bool;
    var phi_14977_: bool;
    var phi_14979_: bool;
    var phi_14980_: f32;
    var phi_14981_: f32;
    var phi_14982_: f32;
    var phi_14984_: bool;
    var phi_14985_: bool;
    var phi_14986_: bool;
    var phi_14988_: bool;
    var phi_15074_: f32;
    var phi_15147_: f32;
    var phi_15152_: f32;
    var phi_15225_: f32;
    var phi_15298_: f32;
    var phi_15303_: f32;
    var phi_15319_: f32;
    var phi_15320_: f32;
    var phi_15321_: f32;
    var phi_15001_: bool;
    var phi_15323_: u32;
    var phi_15324_: f32;
    var phi_15325_: bool;
    var phi_15326_: bool;
    var phi_15327_: bool;
    var phi_15328_: u32;
    var phi_15329_: f32;
    var phi_15330_: f32;
    var phi_15331_: f32;
    var phi_15332_: f32;
    var phi_15333_: bool;
    var phi_15334_: u32;
    var phi_15335_: bool;
    var phi_15336_: bool;
    var phi_15337_: bool;
    var phi_15338_: bool;
    var phi_15340_: bool;
    var phi_15349_: f32;
    var phi_15354_: f32;
    var phi_15363_: bool;
    var phi_15367_: bool;
    var phi_15368_: f32;
    var phi_15369_: f32;
    var phi_15370_: f32;
    var phi_15371_: f32;
    var phi_15372_: bool;
    var phi_15373_: u32;
    var phi_15374_: bool;
    var phi_15375_: bool;
    var phi_15376_: bool;
    var phi_15377_: bool;
    var phi_15379_: bool;
    var phi_13201_: f32;
    var phi_13203_: f32;
    var phi_13205_: f32;
    var phi_13207_: f32;
    var phi_13209_: bool;
    var phi_13211_: u32;
    var phi_15380_: f32;
    var phi_15382_: bool;
    var phi_15383_: bool;
    var phi_15384_: bool;
    var phi_15385_: bool;
    var phi_15387_: bool;
    var phi_15388_: bool;
    var local_29: bool;
    var phi_15392_: bool;
    var phi_15393_: bool;
    var phi_15395_: bool;
    var phi_15396_: bool;
    var local_30: f32;
    var phi_15401_: type_28;
    var phi_15402_: bool;
    var phi_15404_: bool;
    var phi_15405_: bool;
    var phi_15406_: bool;
    var phi_15411_: type_28;
    var phi_15413_: bool;
    var phi_15414_: bool;
    var phi_15415_: bool;
    var phi_15416_: bool;
    var phi_15428_: f32;
    var phi_15429_: bool;
    var phi_15430_: bool;
    var phi_15431_: bool;
    var phi_15436_: type_28;
    var phi_15437_: bool;
    var phi_15438_: bool;
    var phi_15443_: type_28;
    var phi_15444_: bool;
    var phi_15448_: type_28;
    var phi_15455_: bool;
    var phi_15456_: f32;
    var phi_15457_: bool;
    var phi_15458_: bool;
    var phi_15459_: bool;
    var phi_15460_: bool;
    var phi_15461_: f32;
    var phi_15462_: f32;
    var phi_15463_: bool;
    var phi_15464_: bool;
    var phi_15465_: bool;
    var phi_15466_: bool;
    var phi_15467_: f32;
    var phi_15468_: f32;
    var phi_15469_: bool;
    var phi_15470_: bool;
    var phi_15471_: bool;
    var phi_15472_: bool;
    var phi_15476_: bool;
    var phi_15477_: bool;
    var phi_15478_: bool;
    var phi_15479_: type_41;
    var phi_15480_: bool;
    var phi_15481_: f32;
    var phi_15482_: f32;
    var phi_15483_: type_41;
    var phi_15484_: bool;
    var phi_15485_: bool;
    var phi_15486_: bool;
    var phi_15487_: bool;
    var phi_15491_: bool;
    var phi_15492_: bool;
    var phi_15493_: bool;
    var phi_15494_: type_41;
    var phi_15495_: bool;
    var phi_15496_: f32;
    var phi_15497_: f32;
    var phi_15498_: type_41;
    var phi_15499_: bool;
    var phi_15500_: bool;
    var phi_15501_: bool;
    var phi_15502_: bool;
    var local_31: bool;
    var phi_15507_: type_28;
    var phi_15508_: bool;
    var phi_15509_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_15523_: type_28;
    var phi_15524_: bool;
    var phi_15525_: type_28;
    var phi_15526_: bool;
    var local_37: f32;
    var phi_15531_: type_28;
    var phi_15532_: type_28;
    var phi_15533_: bool;
    var local_38: type_41;
    var phi_15539_: type_28;
    var phi_15540_: bool;
    var phi_15544_: type_28;
    var phi_15545_: type_28;
    var phi_15546_: bool;
    var phi_15550_: type_28;
    var phi_15551_: type_28;
    var phi_15552_: bool;
    var phi_15556_: type_28;
    var phi_15567_: bool;
    var phi_15568_: bool;
    var phi_15572_: bool;
    var phi_15576_: u32;
    var phi_1535_: type_14;
    var phi_1538_: f32;
    var phi_1559_: bool;
    var phi_1565_: type_15;
    var phi_1536_: type_14;
    var phi_1579_: type_15;
    var phi_1539_: f32;
    var local_39: f32;
    var phi_1528_: f32;
    var phi_1592_: f32;
    var phi_1608_: f32;
    var phi_1615_: f32;
    var phi_1620_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1645_: f32;
    var phi_1652_: f32;
    var phi_1657_: f32;
    var phi_1664_: f32;
    var phi_1669_: f32;
    var phi_1674_: f32;
    var phi_1691_: f32;
    var phi_1698_: f32;
    var phi_1703_: f32;
    var phi_1710_: f32;
    var phi_1715_: f32;
    var phi_1729_: f32;
    var phi_1736_: f32;
    var phi_1741_: f32;
    var phi_1748_: f32;
    var phi_1753_: f32;
    var phi_1758_: f32;
    var phi_1775_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1794_: f32;
    var phi_1799_: f32;
    var phi_1813_: f32;
    var phi_1820_: f32;
    var phi_1825_: f32;
    var phi_1832_: f32;
    var phi_1837_: f32;
    var phi_1842_: f32;
    var phi_2103_: f32;
    var phi_2110_: f32;
    var phi_2115_: f32;
    var phi_2122_: f32;
    var phi_2127_: f32;
    var phi_2140_: f32;
    var phi_2147_: f32;
    var phi_2152_: f32;
    var phi_2159_: f32;
    var phi_2164_: f32;
    var phi_2169_: f32;
    var phi_2186_: f32;
    var phi_2193_: f32;
    var phi_2198_: f32;
    var phi_2205_: f32;
    var phi_2210_: f32;
    var phi_2224_: f32;
    var phi_2231_: f32;
    var phi_2236_: f32;
    var phi_2243_: f32;
    var phi_2248_: f32;
    var phi_2253_: f32;
    var phi_2270_: f32;
    var phi_2277_: f32;
    var phi_2282_: f32;
    var phi_2289_: f32;
    var phi_2294_: f32;
    var phi_2308_: f32;
    var phi_2315_: f32;
    var phi_2320_: f32;
    var phi_2327_: f32;
    var phi_2332_: f32;
    var phi_2337_: f32;
    var phi_2368_: f32;
    var phi_2374_: f32;
    var phi_2381_: f32;
    var phi_2388_: f32;
    var phi_2394_: f32;
    var phi_2401_: f32;
    var phi_2407_: f32;
    var phi_2413_: f32;
    var phi_2419_: f32;
    var phi_2426_: f32;
    var phi_2433_: f32;
    var phi_2457_: f32;
    var phi_2462_: f32;
    var phi_2467_: f32;
    var phi_2472_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2492_: f32;
    var phi_2501_: type_39;
    var phi_2502_: bool;
    var phi_2503_: type_39;
    var phi_2504_: bool;
    var phi_2510_: type_14;
    var phi_2513_: f32;
    var phi_2515_: u32;
    var phi_2517_: f32;
    var phi_2538_: bool;
    var phi_2544_: type_15;
    var phi_2511_: type_14;
    var phi_2558_: type_15;
    var phi_2573_: bool;
    var phi_2574_: bool;
    var phi_2720_: f32;
    var phi_2727_: f32;
    var phi_2732_: f32;
    var phi_2739_: f32;
    var phi_2744_: f32;
    var phi_2757_: f32;
    var phi_2764_: f32;
    var phi_2769_: f32;
    var phi_2776_: f32;
    var phi_2781_: f32;
    var phi_2786_: f32;
    var phi_2803_: f32;
    var phi_2810_: f32;
    var phi_2815_: f32;
    var phi_2822_: f32;
    var phi_2827_: f32;
    var phi_2841_: f32;
    var phi_2848_: f32;
    var phi_2853_: f32;
    var phi_2860_: f32;
    var phi_2865_: f32;
    var phi_2870_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2899_: f32;
    var phi_2906_: f32;
    var phi_2911_: f32;
    var phi_2925_: f32;
    var phi_2932_: f32;
    var phi_2937_: f32;
    var phi_2944_: f32;
    var phi_2949_: f32;
    var phi_2954_: f32;
    var phi_2995_: type_12;
    var phi_2998_: f32;
    var phi_3000_: f32;
    var phi_3002_: f32;
    var phi_3004_: f32;
    var phi_3006_: bool;
    var phi_3008_: u32;
    var phi_2996_: type_12;
    var phi_3031_: type_12;
    var phi_3145_: f32;
    var phi_3151_: f32;
    var phi_3157_: f32;
    var phi_3159_: array<f32, 3>;
    var phi_3166_: f32;
    var phi_3173_: f32;
    var phi_3181_: f32;
    var phi_3225_: type_14;
    var phi_3228_: f32;
    var phi_3249_: bool;
    var phi_3255_: type_15;
    var phi_3226_: type_14;
    var phi_3269_: type_15;
    var phi_3229_: f32;
    var local_40: f32;
    var phi_3218_: f32;
    var phi_3282_: f32;
    var phi_3348_: f32;
    var phi_3354_: f32;
    var phi_3363_: f32;
    var phi_3369_: f32;
    var phi_3378_: f32;
    var phi_3384_: f32;
    var phi_3393_: f32;
    var phi_3399_: f32;
    var phi_3405_: type_32;
    var phi_3406_: bool;
    var phi_3407_: type_32;
    var phi_3408_: bool;
    var phi_3416_: type_32;
    var phi_3587_: bool;
    var phi_3588_: bool;
    var phi_3589_: bool;
    var phi_3590_: bool;
    var phi_3591_: bool;
    var phi_3592_: bool;
    var phi_3596_: bool;
    var phi_3893_: bool;
    var phi_3894_: bool;
    var phi_3895_: bool;
    var phi_3896_: bool;
    var phi_3897_: bool;
    var phi_3898_: bool;
    var phi_3902_: bool;
    var phi_3906_: bool;
    var phi_3917_: bool;
    var phi_3918_: bool;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_4013_: f32;
    var phi_4014_: bool;
    var phi_4015_: f32;
    var phi_4016_: bool;
    var phi_4017_: f32;
    var phi_4018_: bool;
    var phi_4019_: bool;
    var phi_4023_: f32;
    var phi_4024_: bool;
    var phi_4028_: f32;
    var phi_4060_: bool;
    var phi_4061_: bool;
    var phi_4081_: f32;
    var phi_4082_: bool;
    var phi_4083_: f32;
    var phi_4084_: bool;
    var phi_4085_: f32;
    var phi_4086_: bool;
    var phi_4087_: bool;
    var phi_4091_: f32;
    var phi_4092_: bool;
    var phi_4096_: f32;
    var phi_4101_: f32;
    var phi_4133_: bool;
    var phi_4134_: bool;
    var phi_4154_: f32;
    var phi_4155_: bool;
    var phi_4156_: f32;
    var phi_4157_: bool;
    var phi_4158_: f32;
    var phi_4159_: bool;
    var phi_4160_: bool;
    var phi_4164_: f32;
    var phi_4165_: bool;
    var phi_4169_: f32;
    var phi_4201_: bool;
    var phi_4202_: bool;
    var phi_4222_: f32;
    var phi_4223_: bool;
    var phi_4224_: f32;
    var phi_4225_: bool;
    var phi_4226_: f32;
    var phi_4227_: bool;
    var phi_4228_: bool;
    var phi_4232_: f32;
    var phi_4233_: bool;
    var phi_4237_: f32;
    var phi_4242_: f32;
    var phi_4247_: f32;
    var phi_4252_: f32;
    var phi_4265_: f32;
    var phi_4402_: type_14;
    var phi_4405_: f32;
    var phi_4426_: bool;
    var phi_4432_: type_15;
    var phi_4403_: type_14;
    var phi_4446_: type_15;
    var phi_4406_: f32;
    var local_41: f32;
    var phi_4395_: f32;
    var phi_4459_: f32;
    var phi_4475_: f32;
    var phi_4482_: f32;
    var phi_4487_: f32;
    var phi_4494_: f32;
    var phi_4499_: f32;
    var phi_4512_: f32;
    var phi_4519_: f32;
    var phi_4524_: f32;
    var phi_4531_: f32;
    var phi_4536_: f32;
    var phi_4541_: f32;
    var phi_4558_: f32;
    var phi_4565_: f32;
    var phi_4570_: f32;
    var phi_4577_: f32;
    var phi_4582_: f32;
    var phi_4596_: f32;
    var phi_4603_: f32;
    var phi_4608_: f32;
    var phi_4615_: f32;
    var phi_4620_: f32;
    var phi_4625_: f32;
    var phi_4642_: f32;
    var phi_4649_: f32;
    var phi_4654_: f32;
    var phi_4661_: f32;
    var phi_4666_: f32;
    var phi_4680_: f32;
    var phi_4687_: f32;
    var phi_4692_: f32;
    var phi_4699_: f32;
    var phi_4704_: f32;
    var phi_4709_: f32;
    var phi_4729_: bool;
    var phi_4730_: bool;
    var phi_4731_: bool;
    var phi_4746_: bool;
    var phi_4747_: bool;
    var phi_4752_: f32;
    var phi_4754_: f32;
    var phi_4755_: f32;
    var phi_4756_: bool;
    var phi_4757_: f32;
    var phi_4758_: f32;
    var phi_4759_: bool;
    var phi_4760_: bool;
    var phi_4761_: f32;
    var phi_4762_: f32;
    var phi_4763_: f32;
    var phi_4764_: f32;
    var phi_4765_: bool;
    var phi_4766_: bool;
    var phi_4767_: bool;
    var phi_4768_: bool;
    var phi_4769_: f32;
    var phi_4770_: f32;
    var phi_4771_: f32;
    var phi_4772_: f32;
    var phi_4773_: bool;
    var phi_4774_: bool;
    var phi_4775_: bool;
    var phi_4776_: bool;
    var phi_4777_: bool;
    var phi_4778_: f32;
    var phi_4779_: f32;
    var phi_4780_: f32;
    var phi_4781_: f32;
    var phi_4782_: bool;
    var phi_4783_: bool;
    var phi_4784_: bool;
    var phi_4785_: bool;
    var phi_4786_: bool;
    var phi_4872_: f32;
    var phi_4945_: f32;
    var phi_4950_: f32;
    var phi_5023_: f32;
    var phi_5096_: f32;
    var phi_5101_: f32;
    var phi_5117_: f32;
    var phi_5118_: f32;
    var phi_5119_: f32;
    var phi_4799_: bool;
    var phi_5121_: u32;
    var phi_5122_: f32;
    var phi_5123_: bool;
    var phi_5124_: bool;
    var phi_5125_: bool;
    var phi_5126_: u32;
    var phi_5127_: f32;
    var phi_5128_: f32;
    var phi_5129_: f32;
    var phi_5130_: f32;
    var phi_5131_: bool;
    var phi_5132_: u32;
    var phi_5133_: bool;
    var phi_5134_: bool;
    var phi_5135_: bool;
    var phi_5136_: bool;
    var phi_5137_: bool;
    var phi_5138_: bool;
    var phi_5147_: f32;
    var phi_5152_: f32;
    var phi_5161_: bool;
    var phi_5165_: bool;
    var phi_5166_: f32;
    var phi_5167_: f32;
    var phi_5168_: f32;
    var phi_5169_: f32;
    var phi_5170_: bool;
    var phi_5171_: u32;
    var phi_5172_: bool;
    var phi_5173_: bool;
    var phi_5174_: bool;
    var phi_5175_: bool;
    var phi_5176_: bool;
    var phi_5177_: bool;
    var phi_2999_: f32;
    var phi_3001_: f32;
    var phi_3003_: f32;
    var phi_3005_: f32;
    var phi_3007_: bool;
    var phi_3009_: u32;
    var phi_5178_: f32;
    var phi_5179_: f32;
    var phi_5180_: bool;
    var phi_5181_: bool;
    var phi_5182_: bool;
    var phi_5183_: bool;
    var phi_5184_: bool;
    var phi_5185_: bool;
    var phi_5186_: bool;
    var local_42: bool;
    var phi_5190_: bool;
    var phi_5191_: bool;
    var phi_5192_: bool;
    var phi_5193_: bool;
    var phi_5194_: bool;
    var local_43: f32;
    var phi_5199_: type_28;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5204_: bool;
    var phi_5209_: type_28;
    var phi_5210_: bool;
    var phi_5211_: bool;
    var phi_5212_: bool;
    var phi_5213_: bool;
    var phi_5214_: bool;
    var phi_5218_: f32;
    var phi_5219_: bool;
    var phi_5220_: bool;
    var phi_5221_: bool;
    var phi_5222_: bool;
    var phi_5226_: f32;
    var phi_5227_: bool;
    var phi_5228_: bool;
    var phi_5229_: bool;
    var phi_5234_: type_28;
    var phi_5235_: bool;
    var phi_5236_: bool;
    var phi_5241_: type_28;
    var phi_5242_: bool;
    var phi_5246_: type_28;
    var phi_5253_: f32;
    var phi_5254_: bool;
    var phi_5366_: f32;
    var phi_5373_: f32;
    var phi_5381_: f32;
    var phi_5532_: f32;
    var phi_5539_: f32;
    var phi_5544_: f32;
    var phi_5551_: f32;
    var phi_5556_: f32;
    var phi_5569_: f32;
    var phi_5576_: f32;
    var phi_5581_: f32;
    var phi_5588_: f32;
    var phi_5593_: f32;
    var phi_5598_: f32;
    var phi_5615_: f32;
    var phi_5622_: f32;
    var phi_5627_: f32;
    var phi_5634_: f32;
    var phi_5639_: f32;
    var phi_5653_: f32;
    var phi_5660_: f32;
    var phi_5665_: f32;
    var phi_5672_: f32;
    var phi_5677_: f32;
    var phi_5682_: f32;
    var phi_5699_: f32;
    var phi_5706_: f32;
    var phi_5711_: f32;
    var phi_5718_: f32;
    var phi_5723_: f32;
    var phi_5737_: f32;
    var phi_5744_: f32;
    var phi_5749_: f32;
    var phi_5756_: f32;
    var phi_5761_: f32;
    var phi_5766_: f32;
    var phi_5874_: type_14;
    var phi_5877_: f32;
    var phi_5898_: bool;
    var phi_5904_: type_15;
    var phi_5875_: type_14;
    var phi_5918_: type_15;
    var phi_5878_: f32;
    var local_44: f32;
    var phi_5867_: f32;
    var phi_5931_: f32;
    var phi_6065_: f32;
    var phi_6071_: f32;
    var phi_6080_: f32;
    var phi_6086_: f32;
    var phi_6095_: f32;
    var phi_6101_: f32;
    var phi_6110_: f32;
    var phi_6116_: f32;
    var phi_6166_: type_14;
    var phi_6169_: f32;
    var phi_6190_: bool;
    var phi_6196_: type_15;
    var phi_6167_: type_14;
    var phi_6210_: type_15;
    var phi_6170_: f32;
    var local_45: f32;
    var phi_6159_: f32;
    var phi_6223_: f32;
    var phi_6255_: type_14;
    var phi_6258_: f32;
    var phi_6279_: bool;
    var phi_6285_: type_15;
    var phi_6256_: type_14;
    var phi_6299_: type_15;
    var phi_6259_: f32;
    var local_46: f32;
    var phi_6248_: f32;
    var phi_6312_: f32;
    var phi_6328_: f32;
    var phi_6335_: f32;
    var phi_6340_: f32;
    var phi_6347_: f32;
    var phi_6352_: f32;
    var phi_6365_: f32;
    var phi_6372_: f32;
    var phi_6377_: f32;
    var phi_6384_: f32;
    var phi_6389_: f32;
    var phi_6394_: f32;
    var phi_6411_: f32;
    var phi_6418_: f32;
    var phi_6423_: f32;
    var phi_6430_: f32;
    var phi_6435_: f32;
    var phi_6449_: f32;
    var phi_6456_: f32;
    var phi_6461_: f32;
    var phi_6468_: f32;
    var phi_6473_: f32;
    var phi_6478_: f32;
    var phi_6495_: f32;
    var phi_6502_: f32;
    var phi_6507_: f32;
    var phi_6514_: f32;
    var phi_6519_: f32;
    var phi_6533_: f32;
    var phi_6540_: f32;
    var phi_6545_: f32;
    var phi_6552_: f32;
    var phi_6557_: f32;
    var phi_6562_: f32;
    var phi_6603_: f32;
    var phi_6609_: f32;
    var phi_6620_: type_12;
    var phi_6623_: f32;
    var phi_6621_: type_12;
    var phi_6646_: type_12;
    var phi_6675_: f32;
    var phi_6681_: f32;
    var phi_6694_: f32;
    var phi_6624_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6722_: type_14;
    var phi_6725_: f32;
    var phi_6746_: bool;
    var phi_6752_: type_15;
    var phi_6723_: type_14;
    var phi_6766_: type_15;
    var phi_6726_: f32;
    var local_49: f32;
    var phi_6715_: f32;
    var phi_6779_: f32;
    var phi_6784_: type_12;
    var phi_6787_: f32;
    var phi_6789_: bool;
    var phi_6791_: bool;
    var phi_6785_: type_12;
    var phi_6814_: type_12;
    var phi_6851_: f32;
    var phi_6858_: f32;
    var phi_6866_: f32;
    var phi_6874_: f32;
    var phi_6881_: f32;
    var phi_6889_: f32;
    var phi_6895_: f32;
    var phi_6913_: f32;
    var phi_6919_: f32;
    var phi_6926_: f32;
    var phi_6952_: f32;
    var phi_6958_: f32;
    var phi_6994_: bool;
    var phi_7001_: bool;
    var phi_7014_: f32;
    var phi_7020_: f32;
    var phi_7021_: f32;
    var phi_7022_: f32;
    var phi_6788_: f32;
    var phi_6790_: bool;
    var phi_6792_: bool;
    var local_50: f32;
    var phi_7027_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_7036_: type_40;
    var phi_7037_: type_40;
    var phi_7038_: bool;
    var local_53: bool;
    var phi_7055_: f32;
    var phi_7056_: f32;
    var phi_7059_: type_12;
    var phi_7062_: f32;
    var phi_7064_: f32;
    var phi_7060_: type_12;
    var phi_7087_: type_12;
    var phi_7170_: f32;
    var phi_7171_: f32;
    var phi_7172_: f32;
    var phi_7155_: f32;
    var phi_7173_: f32;
    var phi_7174_: f32;
    var phi_7063_: f32;
    var phi_7065_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var phi_7338_: bool;
    var phi_7339_: bool;
    var phi_7340_: bool;
    var phi_7344_: bool;
    var phi_7348_: bool;
    var phi_7349_: bool;
    var phi_7350_: bool;
    var phi_7354_: f32;
    var phi_7357_: type_40;
    var phi_7358_: type_40;
    var phi_7359_: bool;
    var phi_7360_: type_40;
    var phi_7361_: type_40;
    var phi_7362_: bool;
    var phi_7367_: type_40;
    var phi_7368_: type_40;
    var phi_7369_: bool;
    var phi_7373_: type_40;
    var phi_7374_: type_40;
    var phi_7375_: bool;
    var phi_7376_: bool;
    var phi_7377_: type_40;
    var phi_7378_: type_40;
    var phi_7379_: bool;
    var phi_7380_: bool;
    var phi_7385_: type_40;
    var phi_7386_: bool;
    var phi_7390_: type_40;
    var phi_7406_: f32;
    var phi_7407_: f32;
    var phi_7408_: bool;
    var phi_7409_: f32;
    var phi_7410_: f32;
    var phi_7411_: bool;
    var phi_7412_: bool;
    var phi_7413_: bool;
    var phi_7414_: f32;
    var phi_7415_: f32;
    var phi_7416_: bool;
    var phi_7417_: bool;
    var phi_7418_: bool;
    var phi_7419_: f32;
    var phi_7420_: u32;
    var phi_7421_: f32;
    var phi_7422_: type_40;
    var phi_7423_: u32;
    var phi_7424_: u32;
    var phi_7425_: bool;
    var phi_7426_: bool;
    var phi_7427_: bool;
    var phi_7428_: f32;
    var phi_7429_: u32;
    var phi_7430_: f32;
    var phi_7431_: type_40;
    var phi_7432_: u32;
    var phi_7433_: u32;
    var phi_7434_: bool;
    var phi_7435_: bool;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7438_: bool;
    var phi_7439_: f32;
    var phi_2514_: f32;
    var phi_2516_: u32;
    var phi_2518_: f32;
    var phi_7440_: type_40;
    var phi_7441_: u32;
    var phi_7442_: f32;
    var phi_7443_: u32;
    var phi_7444_: bool;
    var phi_7445_: bool;
    var phi_7446_: bool;
    var phi_7447_: bool;
    var phi_7448_: bool;
    var phi_7449_: bool;
    var local_57: bool;
    var phi_7453_: bool;
    var phi_7454_: bool;
    var phi_7455_: bool;
    var phi_7456_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_7473_: u32;
    var local_60: type_40;
    var phi_7478_: type_39;
    var phi_7479_: type_39;
    var phi_7480_: bool;
    var phi_7481_: bool;
    var phi_7482_: bool;
    var phi_7483_: bool;
    var phi_7487_: u32;
    var phi_7488_: f32;
    var phi_7489_: bool;
    var phi_7490_: bool;
    var phi_7491_: bool;
    var phi_7492_: bool;
    var phi_7496_: f32;
    var phi_7497_: u32;
    var phi_7498_: bool;
    var phi_7499_: bool;
    var phi_7500_: bool;
    var phi_7512_: f32;
    var phi_7515_: type_12;
    var phi_7516_: type_12;
    var phi_7539_: type_12;
    var phi_7560_: f32;
    var phi_7690_: type_14;
    var phi_7693_: f32;
    var phi_7714_: bool;
    var phi_7720_: type_15;
    var phi_7691_: type_14;
    var phi_7734_: type_15;
    var phi_7694_: f32;
    var local_61: f32;
    var phi_7683_: f32;
    var phi_7747_: f32;
    var phi_7763_: f32;
    var phi_7770_: f32;
    var phi_7775_: f32;
    var phi_7782_: f32;
    var phi_7787_: f32;
    var phi_7800_: f32;
    var phi_7807_: f32;
    var phi_7812_: f32;
    var phi_7819_: f32;
    var phi_7824_: f32;
    var phi_7829_: f32;
    var phi_7846_: f32;
    var phi_7853_: f32;
    var phi_7858_: f32;
    var phi_7865_: f32;
    var phi_7870_: f32;
    var phi_7884_: f32;
    var phi_7891_: f32;
    var phi_7896_: f32;
    var phi_7903_: f32;
    var phi_7908_: f32;
    var phi_7913_: f32;
    var phi_7930_: f32;
    var phi_7937_: f32;
    var phi_7942_: f32;
    var phi_7949_: f32;
    var phi_7954_: f32;
    var phi_7968_: f32;
    var phi_7975_: f32;
    var phi_7980_: f32;
    var phi_7987_: f32;
    var phi_7992_: f32;
    var phi_7997_: f32;
    var phi_8017_: bool;
    var phi_8018_: bool;
    var phi_8019_: bool;
    var local_62: bool;
    var phi_8027_: u32;
    var phi_8031_: type_39;
    var phi_8032_: bool;
    var phi_8040_: u32;
    var phi_8044_: type_39;
    var phi_8045_: type_39;
    var phi_8046_: bool;
    var phi_8047_: bool;
    var phi_8054_: type_39;
    var phi_8055_: bool;
    var phi_8059_: type_39;
    var phi_8060_: type_39;
    var phi_8061_: bool;
    var phi_8065_: type_39;
    var phi_15580_: type_39;
    var phi_15595_: type_42;
    var phi_15611_: array<u32, 2>;
    var phi_15632_: array<u32, 2>;
    var phi_15635_: bool;
    var phi_15650_: bool;
    var phi_15651_: bool;
    var phi_15659_: bool;
    var phi_15660_: bool;
    var phi_15665_: u32;
    var phi_15673_: bool;
    var phi_15694_: u32;
    var phi_15698_: type_20;
    var phi_15699_: bool;
    var phi_15700_: bool;
    var phi_15719_: u32;
    var phi_15786_: u32;
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
    let _e120 = id_2;
    let _e121 = n_2;
    let _e122 = lane_2;
    let _e134 = ((_e120.y * _e121.x) + _e120.x);
    let _e137 = (_e121.x * _e121.y);
    let _e140 = params.member.member_1.member_2;
    let _e142 = input.member[0u];
    if (_e140 < _e142) {
        phi_792_ = _e140;
    } else {
        phi_792_ = _e142;
    }
    let _e145 = phi_792_;
    let _e147 = params.member.member_1.member_1;
    if (_e145 > _e147) {
        let _e150 = params.member.member_1.member_1;
        phi_802_ = (_e145 - _e150);
    } else {
        phi_802_ = 0u;
    }
    let _e153 = phi_802_;
    let _e155 = params.member.member_1.member;
    if (_e155 < _e153) {
        phi_809_ = _e155;
    } else {
        phi_809_ = _e153;
    }
    let _e158 = phi_809_;
    let _e159 = (_e158 / 64u);
    if ((_e158 % 64u) > 0u) {
        phi_825_ = (_e159 + 1u);
    } else {
        phi_825_ = _e159;
    }
    let _e164 = phi_825_;
    if (_e164 > _e134) {
        let _e166 = (_e164 - _e134);
        if (_e137 == 0u) {
            return;
        }
        let _e168 = (_e166 / _e137);
        if (_e137 == 0u) {
            return;
        }
        if ((_e166 % _e137) > 0u) {
            phi_846_ = (_e168 + 1u);
        } else {
            phi_846_ = _e168;
        }
        let _e174 = phi_846_;
        phi_847_ = _e174;
    } else {
        phi_847_ = 0u;
    }
    let _e176 = phi_847_;
    phi_850_ = type_12(0u, _e176);
    loop {
        let _e179 = phi_850_;
        if (_e179.member < _e179.member_1) {
            phi_851_ = type_12((_e179.member + 1u), _e179.member_1);
            phi_874_ = type_12(1u, _e179.member);
        } else {
            phi_851_ = _e179;
            phi_874_ = type_12(0u, type_12().member_1);
        }
        let _e191 = phi_851_;
        let _e193 = phi_874_;
        let _e197 = (bitcast<i32>(_e193.member) != 0i);
        if _e197 {
            let _e201 = (((_e134 + (_e193.member_1 * _e137)) * 64u) + _e122);
            if (_e201 < _e158) {
                let _e205 = params.member.member_1.member_1;
                let _e207 = (2u * (_e205 + _e201));
                let _e210 = input.member[(4u + _e207)];
                let _e213 = input.member[(_e207 + 5u)];
                let _e216 = elements.member[_e213];
                let _e221 = paths.member[_e210];
                let _e223 = paths.member[_e216[0]];
                let _e229 = paths.member[_e216[1]];
                let _e231 = paths.member[_e216[2]];
                let _e261 = params.member.member.member_4;
                let _e262 = (_e221.member[0] - _e223.member[0]);
                let _e263 = (_e221.member[1] - _e223.member[1]);
                let _e264 = (_e221.member[2] - _e223.member[2]);
                let _e266 = (_e221.member_1[0] - _e223.member_1[0]);
                let _e267 = (_e221.member_1[1] - _e223.member_1[1]);
                let _e268 = (_e221.member_1[2] - _e223.member_1[2]);
                let _e271 = (_e229.member[0] - _e223.member[0]);
                let _e272 = (_e229.member[1] - _e223.member[1]);
                let _e273 = (_e229.member[2] - _e223.member[2]);
                let _e275 = (_e229.member_1[0] - _e223.member_1[0]);
                let _e276 = (_e229.member_1[1] - _e223.member_1[1]);
                let _e277 = (_e229.member_1[2] - _e223.member_1[2]);
                let _e280 = (_e231.member[0] - _e223.member[0]);
                let _e281 = (_e231.member[1] - _e223.member[1]);
                let _e282 = (_e231.member[2] - _e223.member[2]);
                let _e284 = (_e231.member_1[0] - _e223.member_1[0]);
                let _e285 = (_e231.member_1[1] - _e223.member_1[1]);
                let _e286 = (_e231.member_1[2] - _e223.member_1[2]);
                let _e289 = (_e261 + _e261);
                let _e292 = params.member.member.member_12;
                let _e293 = bitcast<u32>(_e292);
                let _e294 = (_e293 & 2147483647u);
                if (_e294 < 8388608u) {
                    phi_1049_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_1049_ = array<u32, 2>((_e293 << bitcast<u32>(29i)), ((_e293 ^ _e294) | ((_e294 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e305 = phi_1049_;
                let _e309 = params.member.member.member_15[0u];
                if (_e305[0] == _e309) {
                    let _e314 = params.member.member.member_15[1u];
                    phi_1063_ = (_e305[1] == _e314);
                } else {
                    phi_1063_ = false;
                }
                let _e317 = phi_1063_;
                let _e319 = params.member.member.member_5;
                let _e321 = params.member.member.member_11;
                let _e323 = params.member.member.member_12;
                let _e325 = params.member.member.member_13;
                let _e327 = params.member.member.member_1;
                if ((_e327 & 64u) != 0u) {
                    phi_1079_ = _e317;
                } else {
                    phi_1079_ = false;
                }
                let _e331 = phi_1079_;
                if (_e262 < 0f) {
                    phi_1085_ = -(_e262);
                } else {
                    phi_1085_ = _e262;
                }
                let _e335 = phi_1085_;
                if (_e263 < 0f) {
                    phi_1091_ = -(_e263);
                } else {
                    phi_1091_ = _e263;
                }
                let _e339 = phi_1091_;
                if (_e335 > _e339) {
                    phi_1096_ = _e335;
                } else {
                    phi_1096_ = _e339;
                }
                let _e342 = phi_1096_;
                if (_e264 < 0f) {
                    phi_1102_ = -(_e264);
                } else {
                    phi_1102_ = _e264;
                }
                let _e346 = phi_1102_;
                if (_e342 > _e346) {
                    phi_1107_ = _e342;
                } else {
                    phi_1107_ = _e346;
                }
                let _e349 = phi_1107_;
                if (_e266 < 0f) {
                    phi_1113_ = -(_e266);
                } else {
                    phi_1113_ = _e266;
                }
                let _e353 = phi_1113_;
                if (_e267 < 0f) {
                    phi_1119_ = -(_e267);
                } else {
                    phi_1119_ = _e267;
                }
                let _e357 = phi_1119_;
                if (_e353 > _e357) {
                    phi_1124_ = _e353;
                } else {
                    phi_1124_ = _e357;
                }
                let _e360 = phi_1124_;
                if (_e268 < 0f) {
                    phi_1130_ = -(_e268);
                } else {
                    phi_1130_ = _e268;
                }
                let _e364 = phi_1130_;
                if (_e360 > _e364) {
                    phi_1135_ = _e360;
                } else {
                    phi_1135_ = _e364;
                }
                let _e367 = phi_1135_;
                if (_e349 > _e367) {
                    phi_1140_ = _e349;
                } else {
                    phi_1140_ = _e367;
                }
                let _e370 = phi_1140_;
                let _e371 = (_e370 + _e289);
                if (_e271 < 0f) {
                    phi_1147_ = -(_e271);
                } else {
                    phi_1147_ = _e271;
                }
                let _e375 = phi_1147_;
                if (_e272 < 0f) {
                    phi_1153_ = -(_e272);
                } else {
                    phi_1153_ = _e272;
                }
                let _e379 = phi_1153_;
                if (_e375 > _e379) {
                    phi_1158_ = _e375;
                } else {
                    phi_1158_ = _e379;
                }
                let _e382 = phi_1158_;
                if (_e273 < 0f) {
                    phi_1164_ = -(_e273);
                } else {
                    phi_1164_ = _e273;
                }
                let _e386 = phi_1164_;
                if (_e382 > _e386) {
                    phi_1169_ = _e382;
                } else {
                    phi_1169_ = _e386;
                }
                let _e389 = phi_1169_;
                if (_e275 < 0f) {
                    phi_1175_ = -(_e275);
                } else {
                    phi_1175_ = _e275;
                }
                let _e393 = phi_1175_;
                if (_e276 < 0f) {
                    phi_1181_ = -(_e276);
                } else {
                    phi_1181_ = _e276;
                }
                let _e397 = phi_1181_;
                if (_e393 > _e397) {
                    phi_1186_ = _e393;
                } else {
                    phi_1186_ = _e397;
                }
                let _e400 = phi_1186_;
                if (_e277 < 0f) {
                    phi_1192_ = -(_e277);
                } else {
                    phi_1192_ = _e277;
                }
                let _e404 = phi_1192_;
                if (_e400 > _e404) {
                    phi_1197_ = _e400;
                } else {
                    phi_1197_ = _e404;
                }
                let _e407 = phi_1197_;
                if (_e389 > _e407) {
                    phi_1202_ = _e389;
                } else {
                    phi_1202_ = _e407;
                }
                let _e410 = phi_1202_;
                let _e411 = (_e410 + _e289);
                if (_e280 < 0f) {
                    phi_1209_ = -(_e280);
                } else {
                    phi_1209_ = _e280;
                }
                let _e415 = phi_1209_;
                if (_e281 < 0f) {
                    phi_1215_ = -(_e281);
                } else {
                    phi_1215_ = _e281;
                }
                let _e419 = phi_1215_;
                if (_e415 > _e419) {
                    phi_1220_ = _e415;
                } else {
                    phi_1220_ = _e419;
                }
                let _e422 = phi_1220_;
                if (_e282 < 0f) {
                    phi_1226_ = -(_e282);
                } else {
                    phi_1226_ = _e282;
                }
                let _e426 = phi_1226_;
                if (_e422 > _e426) {
                    phi_1231_ = _e422;
                } else {
                    phi_1231_ = _e426;
                }
                let _e429 = phi_1231_;
                if (_e284 < 0f) {
                    phi_1237_ = -(_e284);
                } else {
                    phi_1237_ = _e284;
                }
                let _e433 = phi_1237_;
                if (_e285 < 0f) {
                    phi_1243_ = -(_e285);
                } else {
                    phi_1243_ = _e285;
                }
                let _e437 = phi_1243_;
                if (_e433 > _e437) {
                    phi_1248_ = _e433;
                } else {
                    phi_1248_ = _e437;
                }
                let _e440 = phi_1248_;
                if (_e286 < 0f) {
                    phi_1254_ = -(_e286);
                } else {
                    phi_1254_ = _e286;
                }
                let _e444 = phi_1254_;
                if (_e440 > _e444) {
                    phi_1259_ = _e440;
                } else {
                    phi_1259_ = _e444;
                }
                let _e447 = phi_1259_;
                if (_e429 > _e447) {
                    phi_1264_ = _e429;
                } else {
                    phi_1264_ = _e447;
                }
                let _e450 = phi_1264_;
                let _e451 = (_e450 + _e289);
                if (_e371 > _e411) {
                    phi_1270_ = _e371;
                } else {
                    phi_1270_ = _e411;
                }
                let _e454 = phi_1270_;
                if (_e454 > _e451) {
                    phi_1275_ = _e454;
                } else {
                    phi_1275_ = _e451;
                }
                let _e457 = phi_1275_;
                if (_e457 <= 65536f) {
                    phi_1282_ = (_e457 >= (1f / 65536f));
                } else {
                    phi_1282_ = false;
                }
                let _e462 = phi_1282_;
                if _e462 {
                    phi_1355_ = type_38();
                    phi_1356_ = true;
                } else {
                    if (_e457 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e457) & 2139095040u) != 2139095040u) {
                            let _e469 = (2130706432u - (bitcast<u32>(_e457) & 2139095040u));
                            if (_e469 > 8388608u) {
                                phi_1306_ = _e469;
                            } else {
                                phi_1306_ = 8388608u;
                            }
                            let _e472 = phi_1306_;
                            let _e473 = bitcast<f32>(_e472);
                            let _e474 = (_e319 * _e473);
                            if (_e319 > 0f) {
                                if (_e474 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1317_ = _e474;
                                } else {
                                    phi_1317_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e478 = phi_1317_;
                                phi_1318_ = _e478;
                            } else {
                                phi_1318_ = _e474;
                            }
                            let _e480 = phi_1318_;
                            phi_1351_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e262 * _e473), (_e263 * _e473), (_e264 * _e473)), array<f32, 3>((_e266 * _e473), (_e267 * _e473), (_e268 * _e473))), array<array<f32, 3>, 2>(array<f32, 3>((_e271 * _e473), (_e272 * _e473), (_e273 * _e473)), array<f32, 3>((_e275 * _e473), (_e276 * _e473), (_e277 * _e473))), array<array<f32, 3>, 2>(array<f32, 3>((_e280 * _e473), (_e281 * _e473), (_e282 * _e473)), array<f32, 3>((_e284 * _e473), (_e285 * _e473), (_e286 * _e473))), ((_e289 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e473)), _e480);
                            phi_1352_ = false;
                        } else {
                            phi_1351_ = type_38();
                            phi_1352_ = true;
                        }
                        let _e514 = phi_1351_;
                        let _e516 = phi_1352_;
                        phi_1353_ = _e514;
                        phi_1354_ = _e516;
                    } else {
                        phi_1353_ = type_38();
                        phi_1354_ = true;
                    }
                    let _e518 = phi_1353_;
                    let _e520 = phi_1354_;
                    phi_1355_ = _e518;
                    phi_1356_ = _e520;
                }
                let _e522 = phi_1355_;
                let _e524 = phi_1356_;
                if _e524 {
                    phi_1361_ = type_38(type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e262, _e263, _e264), array<f32, 3>(_e266, _e267, _e268)), array<array<f32, 3>, 2>(array<f32, 3>(_e271, _e272, _e273), array<f32, 3>(_e275, _e276, _e277)), array<array<f32, 3>, 2>(array<f32, 3>(_e280, _e281, _e282), array<f32, 3>(_e284, _e285, _e286)), _e289), _e319);
                } else {
                    phi_1361_ = _e522;
                }
                let _e527 = phi_1361_;
                local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e527.member.member[0][0], _e527.member.member[0][1], _e527.member.member[0][2]), array<f32, 3>(_e527.member.member[1][0], _e527.member.member[1][1], _e527.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e527.member.member_1[0][0], _e527.member.member_1[0][1], _e527.member.member_1[0][2]), array<f32, 3>(_e527.member.member_1[1][0], _e527.member.member_1[1][1], _e527.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e527.member.member_2[0][0], _e527.member.member_2[0][1], _e527.member.member_2[0][2]), array<f32, 3>(_e527.member.member_2[1][0], _e527.member.member_2[1][1], _e527.member.member_2[1][2])), _e527.member.member_3);
                if (_e527.member_1 > 0f) {
                    let _e5199 = local_18.member[0u];
                    let _e5205 = local_18.member[1u];
                    let _e5221 = local_18.member_1[0u];
                    let _e5227 = local_18.member_1[1u];
                    let _e5243 = local_18.member_2[0u];
                    let _e5249 = local_18.member_2[1u];
                    let _e5263 = function_2(array<f32, 3>((_e5199[0] + ((_e5205[0] - _e5199[0]) * _e323)), (_e5199[1] + ((_e5205[1] - _e5199[1]) * _e323)), (_e5199[2] + ((_e5205[2] - _e5199[2]) * _e323))), array<f32, 3>((_e5221[0] + ((_e5227[0] - _e5221[0]) * _e323)), (_e5221[1] + ((_e5227[1] - _e5221[1]) * _e323)), (_e5221[2] + ((_e5227[2] - _e5221[2]) * _e323))), array<f32, 3>((_e5243[0] + ((_e5249[0] - _e5243[0]) * _e323)), (_e5243[1] + ((_e5249[1] - _e5243[1]) * _e323)), (_e5243[2] + ((_e5249[2] - _e5243[2]) * _e323))), 0u);
                    let _e5274 = (((_e5263[0] * _e5263[0]) + (_e5263[1] * _e5263[1])) + (_e5263[2] * _e5263[2]));
                    if (_e5274 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5274 > 0f) {
                            phi_1528_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_1528_ = 0f;
                        }
                        let _e5327 = phi_1528_;
                        phi_1592_ = _e5327;
                    } else {
                        phi_1535_ = type_14(0i, 5i);
                        phi_1538_ = bitcast<f32>(((bitcast<u32>(_e5274) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5282 = phi_1535_;
                            let _e5284 = phi_1538_;
                            local_39 = _e5284;
                            if (_e5282.member < _e5282.member_1) {
                                let _e5291 = (_e5282.member + 1i);
                                if ((false == (_e5291 > _e5282.member)) != false) {
                                    phi_1559_ = true;
                                } else {
                                    phi_1559_ = false;
                                }
                                let _e5296 = phi_1559_;
                                if _e5296 {
                                    phi_1565_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1565_ = type_15(1u, _e5291);
                                }
                                let _e5301 = phi_1565_;
                                phi_1536_ = type_14(_e5301.member_1, _e5282.member_1);
                                phi_1579_ = type_15(1u, _e5282.member);
                            } else {
                                phi_1536_ = _e5282;
                                phi_1579_ = type_15(0u, type_15().member_1);
                            }
                            let _e5307 = phi_1536_;
                            let _e5309 = phi_1579_;
                            let _e5312 = (bitcast<i32>(_e5309.member) != 0i);
                            if _e5312 {
                                phi_1539_ = (0.5f * (_e5284 + (_e5274 / _e5284)));
                            } else {
                                phi_1539_ = f32();
                            }
                            let _e5317 = phi_1539_;
                            continue;
                            continuing {
                                phi_1535_ = _e5307;
                                phi_1538_ = _e5317;
                                break if !(_e5312);
                            }
                        }
                        let _e5322 = local_39;
                        phi_1592_ = (_e5322 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5329 = phi_1592_;
                    let _e5335 = local_18.member[0u];
                    if (_e5335[0] < 0f) {
                        phi_1608_ = -(_e5335[0]);
                    } else {
                        phi_1608_ = _e5335[0];
                    }
                    let _e5342 = phi_1608_;
                    if (_e5335[1] < 0f) {
                        phi_1615_ = -(_e5335[1]);
                    } else {
                        phi_1615_ = _e5335[1];
                    }
                    let _e5346 = phi_1615_;
                    if (_e5342 > _e5346) {
                        phi_1620_ = _e5342;
                    } else {
                        phi_1620_ = _e5346;
                    }
                    let _e5349 = phi_1620_;
                    if (_e5335[2] < 0f) {
                        phi_1627_ = -(_e5335[2]);
                    } else {
                        phi_1627_ = _e5335[2];
                    }
                    let _e5353 = phi_1627_;
                    if (_e5349 > _e5353) {
                        phi_1632_ = _e5349;
                    } else {
                        phi_1632_ = _e5353;
                    }
                    let _e5356 = phi_1632_;
                    let _e5359 = local_18.member[1u];
                    if (_e5359[0] < 0f) {
                        phi_1645_ = -(_e5359[0]);
                    } else {
                        phi_1645_ = _e5359[0];
                    }
                    let _e5366 = phi_1645_;
                    if (_e5359[1] < 0f) {
                        phi_1652_ = -(_e5359[1]);
                    } else {
                        phi_1652_ = _e5359[1];
                    }
                    let _e5370 = phi_1652_;
                    if (_e5366 > _e5370) {
                        phi_1657_ = _e5366;
                    } else {
                        phi_1657_ = _e5370;
                    }
                    let _e5373 = phi_1657_;
                    if (_e5359[2] < 0f) {
                        phi_1664_ = -(_e5359[2]);
                    } else {
                        phi_1664_ = _e5359[2];
                    }
                    let _e5377 = phi_1664_;
                    if (_e5373 > _e5377) {
                        phi_1669_ = _e5373;
                    } else {
                        phi_1669_ = _e5377;
                    }
                    let _e5380 = phi_1669_;
                    if (_e5356 > _e5380) {
                        phi_1674_ = _e5356;
                    } else {
                        phi_1674_ = _e5380;
                    }
                    let _e5383 = phi_1674_;
                    let _e5385 = local_18.member_3;
                    let _e5389 = local_18.member_1[0u];
                    if (_e5389[0] < 0f) {
                        phi_1691_ = -(_e5389[0]);
                    } else {
                        phi_1691_ = _e5389[0];
                    }
                    let _e5396 = phi_1691_;
                    if (_e5389[1] < 0f) {
                        phi_1698_ = -(_e5389[1]);
                    } else {
                        phi_1698_ = _e5389[1];
                    }
                    let _e5400 = phi_1698_;
                    if (_e5396 > _e5400) {
                        phi_1703_ = _e5396;
                    } else {
                        phi_1703_ = _e5400;
                    }
                    let _e5403 = phi_1703_;
                    if (_e5389[2] < 0f) {
                        phi_1710_ = -(_e5389[2]);
                    } else {
                        phi_1710_ = _e5389[2];
                    }
                    let _e5407 = phi_1710_;
                    if (_e5403 > _e5407) {
                        phi_1715_ = _e5403;
                    } else {
                        phi_1715_ = _e5407;
                    }
                    let _e5410 = phi_1715_;
                    let _e5413 = local_18.member_1[1u];
                    if (_e5413[0] < 0f) {
                        phi_1729_ = -(_e5413[0]);
                    } else {
                        phi_1729_ = _e5413[0];
                    }
                    let _e5420 = phi_1729_;
                    if (_e5413[1] < 0f) {
                        phi_1736_ = -(_e5413[1]);
                    } else {
                        phi_1736_ = _e5413[1];
                    }
                    let _e5424 = phi_1736_;
                    if (_e5420 > _e5424) {
                        phi_1741_ = _e5420;
                    } else {
                        phi_1741_ = _e5424;
                    }
                    let _e5427 = phi_1741_;
                    if (_e5413[2] < 0f) {
                        phi_1748_ = -(_e5413[2]);
                    } else {
                        phi_1748_ = _e5413[2];
                    }
                    let _e5431 = phi_1748_;
                    if (_e5427 > _e5431) {
                        phi_1753_ = _e5427;
                    } else {
                        phi_1753_ = _e5431;
                    }
                    let _e5434 = phi_1753_;
                    if (_e5410 > _e5434) {
                        phi_1758_ = _e5410;
                    } else {
                        phi_1758_ = _e5434;
                    }
                    let _e5437 = phi_1758_;
                    let _e5439 = local_18.member_3;
                    let _e5443 = local_18.member_2[0u];
                    if (_e5443[0] < 0f) {
                        phi_1775_ = -(_e5443[0]);
                    } else {
                        phi_1775_ = _e5443[0];
                    }
                    let _e5450 = phi_1775_;
                    if (_e5443[1] < 0f) {
                        phi_1782_ = -(_e5443[1]);
                    } else {
                        phi_1782_ = _e5443[1];
                    }
                    let _e5454 = phi_1782_;
                    if (_e5450 > _e5454) {
                        phi_1787_ = _e5450;
                    } else {
                        phi_1787_ = _e5454;
                    }
                    let _e5457 = phi_1787_;
                    if (_e5443[2] < 0f) {
                        phi_1794_ = -(_e5443[2]);
                    } else {
                        phi_1794_ = _e5443[2];
                    }
                    let _e5461 = phi_1794_;
                    if (_e5457 > _e5461) {
                        phi_1799_ = _e5457;
                    } else {
                        phi_1799_ = _e5461;
                    }
                    let _e5464 = phi_1799_;
                    let _e5467 = local_18.member_2[1u];
                    if (_e5467[0] < 0f) {
                        phi_1813_ = -(_e5467[0]);
                    } else {
                        phi_1813_ = _e5467[0];
                    }
                    let _e5474 = phi_1813_;
                    if (_e5467[1] < 0f) {
                        phi_1820_ = -(_e5467[1]);
                    } else {
                        phi_1820_ = _e5467[1];
                    }
                    let _e5478 = phi_1820_;
                    if (_e5474 > _e5478) {
                        phi_1825_ = _e5474;
                    } else {
                        phi_1825_ = _e5478;
                    }
                    let _e5481 = phi_1825_;
                    if (_e5467[2] < 0f) {
                        phi_1832_ = -(_e5467[2]);
                    } else {
                        phi_1832_ = _e5467[2];
                    }
                    let _e5485 = phi_1832_;
                    if (_e5481 > _e5485) {
                        phi_1837_ = _e5481;
                    } else {
                        phi_1837_ = _e5485;
                    }
                    let _e5488 = phi_1837_;
                    if (_e5464 > _e5488) {
                        phi_1842_ = _e5464;
                    } else {
                        phi_1842_ = _e5488;
                    }
                    let _e5491 = phi_1842_;
                    let _e5493 = local_18.member_3;
                    let _e5500 = local_18.member_3;
                    let _e5507 = (((_e5329 * (1f + (0.000000059604645f * 8f))) + (((((((_e5383 + _e5385) + (_e5437 + _e5439)) + (_e5491 + _e5493)) * (0.000000059604645f * 16f)) + (_e5500 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e527.member_1);
                    if _e5507 {
                        phi_2503_ = type_39();
                        phi_2504_ = true;
                    } else {
                        let _e5510 = local_18.member_1[0u];
                        let _e5516 = local_18.member_2[0u];
                        let _e5522 = ((_e5510[1] * _e5516[2]) - (_e5510[2] * _e5516[1]));
                        let _e5525 = ((_e5510[2] * _e5516[0]) - (_e5510[0] * _e5516[2]));
                        let _e5528 = ((_e5510[0] * _e5516[1]) - (_e5510[1] * _e5516[0]));
                        let _e5531 = local_18.member_1[1u];
                        let _e5537 = local_18.member_2[1u];
                        let _e5543 = ((_e5531[1] * _e5537[2]) - (_e5531[2] * _e5537[1]));
                        let _e5546 = ((_e5531[2] * _e5537[0]) - (_e5531[0] * _e5537[2]));
                        let _e5549 = ((_e5531[0] * _e5537[1]) - (_e5531[1] * _e5537[0]));
                        let _e5552 = local_18.member_1[0u];
                        let _e5558 = local_18.member_2[1u];
                        let _e5573 = local_18.member_1[1u];
                        let _e5579 = local_18.member_2[0u];
                        let _e5592 = (((_e5552[1] * _e5558[2]) - (_e5552[2] * _e5558[1])) + ((_e5573[1] * _e5579[2]) - (_e5573[2] * _e5579[1])));
                        let _e5593 = (((_e5552[2] * _e5558[0]) - (_e5552[0] * _e5558[2])) + ((_e5573[2] * _e5579[0]) - (_e5573[0] * _e5579[2])));
                        let _e5594 = (((_e5552[0] * _e5558[1]) - (_e5552[1] * _e5558[0])) + ((_e5573[0] * _e5579[1]) - (_e5573[1] * _e5579[0])));
                        let _e5597 = local_18.member[0u];
                        let _e5608 = local_18.member[1u];
                        let _e5619 = local_18.member[0u];
                        let _e5628 = ((((_e5608[0] * _e5522) + (_e5608[1] * _e5525)) + (_e5608[2] * _e5528)) + (((_e5619[0] * _e5592) + (_e5619[1] * _e5593)) + (_e5619[2] * _e5594)));
                        let _e5631 = local_18.member[0u];
                        let _e5642 = local_18.member[1u];
                        let _e5651 = ((((_e5631[0] * _e5543) + (_e5631[1] * _e5546)) + (_e5631[2] * _e5549)) + (((_e5642[0] * _e5592) + (_e5642[1] * _e5593)) + (_e5642[2] * _e5594)));
                        let _e5654 = local_18.member[1u];
                        let _e5665 = local_18.member[0u];
                        if (_e5665[0] < 0f) {
                            phi_2103_ = -(_e5665[0]);
                        } else {
                            phi_2103_ = _e5665[0];
                        }
                        let _e5672 = phi_2103_;
                        if (_e5665[1] < 0f) {
                            phi_2110_ = -(_e5665[1]);
                        } else {
                            phi_2110_ = _e5665[1];
                        }
                        let _e5676 = phi_2110_;
                        if (_e5672 > _e5676) {
                            phi_2115_ = _e5672;
                        } else {
                            phi_2115_ = _e5676;
                        }
                        let _e5679 = phi_2115_;
                        if (_e5665[2] < 0f) {
                            phi_2122_ = -(_e5665[2]);
                        } else {
                            phi_2122_ = _e5665[2];
                        }
                        let _e5683 = phi_2122_;
                        if (_e5679 > _e5683) {
                            phi_2127_ = _e5679;
                        } else {
                            phi_2127_ = _e5683;
                        }
                        let _e5686 = phi_2127_;
                        let _e5689 = local_18.member[1u];
                        if (_e5689[0] < 0f) {
                            phi_2140_ = -(_e5689[0]);
                        } else {
                            phi_2140_ = _e5689[0];
                        }
                        let _e5696 = phi_2140_;
                        if (_e5689[1] < 0f) {
                            phi_2147_ = -(_e5689[1]);
                        } else {
                            phi_2147_ = _e5689[1];
                        }
                        let _e5700 = phi_2147_;
                        if (_e5696 > _e5700) {
                            phi_2152_ = _e5696;
                        } else {
                            phi_2152_ = _e5700;
                        }
                        let _e5703 = phi_2152_;
                        if (_e5689[2] < 0f) {
                            phi_2159_ = -(_e5689[2]);
                        } else {
                            phi_2159_ = _e5689[2];
                        }
                        let _e5707 = phi_2159_;
                        if (_e5703 > _e5707) {
                            phi_2164_ = _e5703;
                        } else {
                            phi_2164_ = _e5707;
                        }
                        let _e5710 = phi_2164_;
                        if (_e5686 > _e5710) {
                            phi_2169_ = _e5686;
                        } else {
                            phi_2169_ = _e5710;
                        }
                        let _e5713 = phi_2169_;
                        let _e5715 = local_18.member_3;
                        let _e5716 = (_e5713 + _e5715);
                        let _e5719 = local_18.member_1[0u];
                        if (_e5719[0] < 0f) {
                            phi_2186_ = -(_e5719[0]);
                        } else {
                            phi_2186_ = _e5719[0];
                        }
                        let _e5726 = phi_2186_;
                        if (_e5719[1] < 0f) {
                            phi_2193_ = -(_e5719[1]);
                        } else {
                            phi_2193_ = _e5719[1];
                        }
                        let _e5730 = phi_2193_;
                        if (_e5726 > _e5730) {
                            phi_2198_ = _e5726;
                        } else {
                            phi_2198_ = _e5730;
                        }
                        let _e5733 = phi_2198_;
                        if (_e5719[2] < 0f) {
                            phi_2205_ = -(_e5719[2]);
                        } else {
                            phi_2205_ = _e5719[2];
                        }
                        let _e5737 = phi_2205_;
                        if (_e5733 > _e5737) {
                            phi_2210_ = _e5733;
                        } else {
                            phi_2210_ = _e5737;
                        }
                        let _e5740 = phi_2210_;
                        let _e5743 = local_18.member_1[1u];
                        if (_e5743[0] < 0f) {
                            phi_2224_ = -(_e5743[0]);
                        } else {
                            phi_2224_ = _e5743[0];
                        }
                        let _e5750 = phi_2224_;
                        if (_e5743[1] < 0f) {
                            phi_2231_ = -(_e5743[1]);
                        } else {
                            phi_2231_ = _e5743[1];
                        }
                        let _e5754 = phi_2231_;
                        if (_e5750 > _e5754) {
                            phi_2236_ = _e5750;
                        } else {
                            phi_2236_ = _e5754;
                        }
                        let _e5757 = phi_2236_;
                        if (_e5743[2] < 0f) {
                            phi_2243_ = -(_e5743[2]);
                        } else {
                            phi_2243_ = _e5743[2];
                        }
                        let _e5761 = phi_2243_;
                        if (_e5757 > _e5761) {
                            phi_2248_ = _e5757;
                        } else {
                            phi_2248_ = _e5761;
                        }
                        let _e5764 = phi_2248_;
                        if (_e5740 > _e5764) {
                            phi_2253_ = _e5740;
                        } else {
                            phi_2253_ = _e5764;
                        }
                        let _e5767 = phi_2253_;
                        let _e5769 = local_18.member_3;
                        let _e5770 = (_e5767 + _e5769);
                        let _e5773 = local_18.member_2[0u];
                        if (_e5773[0] < 0f) {
                            phi_2270_ = -(_e5773[0]);
                        } else {
                            phi_2270_ = _e5773[0];
                        }
                        let _e5780 = phi_2270_;
                        if (_e5773[1] < 0f) {
                            phi_2277_ = -(_e5773[1]);
                        } else {
                            phi_2277_ = _e5773[1];
                        }
                        let _e5784 = phi_2277_;
                        if (_e5780 > _e5784) {
                            phi_2282_ = _e5780;
                        } else {
                            phi_2282_ = _e5784;
                        }
                        let _e5787 = phi_2282_;
                        if (_e5773[2] < 0f) {
                            phi_2289_ = -(_e5773[2]);
                        } else {
                            phi_2289_ = _e5773[2];
                        }
                        let _e5791 = phi_2289_;
                        if (_e5787 > _e5791) {
                            phi_2294_ = _e5787;
                        } else {
                            phi_2294_ = _e5791;
                        }
                        let _e5794 = phi_2294_;
                        let _e5797 = local_18.member_2[1u];
                        if (_e5797[0] < 0f) {
                            phi_2308_ = -(_e5797[0]);
                        } else {
                            phi_2308_ = _e5797[0];
                        }
                        let _e5804 = phi_2308_;
                        if (_e5797[1] < 0f) {
                            phi_2315_ = -(_e5797[1]);
                        } else {
                            phi_2315_ = _e5797[1];
                        }
                        let _e5808 = phi_2315_;
                        if (_e5804 > _e5808) {
                            phi_2320_ = _e5804;
                        } else {
                            phi_2320_ = _e5808;
                        }
                        let _e5811 = phi_2320_;
                        if (_e5797[2] < 0f) {
                            phi_2327_ = -(_e5797[2]);
                        } else {
                            phi_2327_ = _e5797[2];
                        }
                        let _e5815 = phi_2327_;
                        if (_e5811 > _e5815) {
                            phi_2332_ = _e5811;
                        } else {
                            phi_2332_ = _e5815;
                        }
                        let _e5818 = phi_2332_;
                        if (_e5794 > _e5818) {
                            phi_2337_ = _e5794;
                        } else {
                            phi_2337_ = _e5818;
                        }
                        let _e5821 = phi_2337_;
                        let _e5823 = local_18.member_3;
                        let _e5824 = (_e5821 + _e5823);
                        let _e5826 = ((_e5770 * 8f) * _e5824);
                        let _e5833 = local_18.member_3;
                        if (_e5522 < 0f) {
                            phi_2368_ = -(_e5522);
                        } else {
                            phi_2368_ = _e5522;
                        }
                        let _e5850 = phi_2368_;
                        if (_e5525 < 0f) {
                            phi_2374_ = -(_e5525);
                        } else {
                            phi_2374_ = _e5525;
                        }
                        let _e5854 = phi_2374_;
                        if (_e5528 < 0f) {
                            phi_2381_ = -(_e5528);
                        } else {
                            phi_2381_ = _e5528;
                        }
                        let _e5859 = phi_2381_;
                        let _e5860 = ((_e5850 + _e5854) + _e5859);
                        if (_e5543 < 0f) {
                            phi_2388_ = -(_e5543);
                        } else {
                            phi_2388_ = _e5543;
                        }
                        let _e5864 = phi_2388_;
                        if (_e5546 < 0f) {
                            phi_2394_ = -(_e5546);
                        } else {
                            phi_2394_ = _e5546;
                        }
                        let _e5868 = phi_2394_;
                        if (_e5549 < 0f) {
                            phi_2401_ = -(_e5549);
                        } else {
                            phi_2401_ = _e5549;
                        }
                        let _e5873 = phi_2401_;
                        let _e5874 = ((_e5864 + _e5868) + _e5873);
                        if (_e5860 > _e5874) {
                            phi_2407_ = _e5860;
                        } else {
                            phi_2407_ = _e5874;
                        }
                        let _e5877 = phi_2407_;
                        if (_e5592 < 0f) {
                            phi_2413_ = -(_e5592);
                        } else {
                            phi_2413_ = _e5592;
                        }
                        let _e5881 = phi_2413_;
                        if (_e5593 < 0f) {
                            phi_2419_ = -(_e5593);
                        } else {
                            phi_2419_ = _e5593;
                        }
                        let _e5885 = phi_2419_;
                        if (_e5594 < 0f) {
                            phi_2426_ = -(_e5594);
                        } else {
                            phi_2426_ = _e5594;
                        }
                        let _e5890 = phi_2426_;
                        let _e5892 = (((_e5881 + _e5885) + _e5890) * 0.5f);
                        if (_e5877 > _e5892) {
                            phi_2433_ = _e5877;
                        } else {
                            phi_2433_ = _e5892;
                        }
                        let _e5895 = phi_2433_;
                        let _e5900 = local_18.member_3;
                        let _e5913 = ((((_e5597[0] * _e5522) + (_e5597[1] * _e5525)) + (_e5597[2] * _e5528)) * 3f);
                        let _e5914 = ((((_e5654[0] * _e5543) + (_e5654[1] * _e5546)) + (_e5654[2] * _e5549)) * 3f);
                        if (_e5913 < _e5914) {
                            phi_2457_ = _e5913;
                        } else {
                            phi_2457_ = _e5914;
                        }
                        let _e5917 = phi_2457_;
                        if (_e5628 < _e5651) {
                            phi_2462_ = _e5628;
                        } else {
                            phi_2462_ = _e5651;
                        }
                        let _e5920 = phi_2462_;
                        if (_e5917 < _e5920) {
                            phi_2467_ = _e5917;
                        } else {
                            phi_2467_ = _e5920;
                        }
                        let _e5923 = phi_2467_;
                        if (_e5913 > _e5914) {
                            phi_2472_ = _e5913;
                        } else {
                            phi_2472_ = _e5914;
                        }
                        let _e5926 = phi_2472_;
                        if (_e5628 > _e5651) {
                            phi_2477_ = _e5628;
                        } else {
                            phi_2477_ = _e5651;
                        }
                        let _e5929 = phi_2477_;
                        if (_e5926 > _e5929) {
                            phi_2482_ = _e5926;
                        } else {
                            phi_2482_ = _e5929;
                        }
                        let _e5932 = phi_2482_;
                        let _e5937 = -(_e5932);
                        if (_e5923 > _e5937) {
                            phi_2492_ = _e5923;
                        } else {
                            phi_2492_ = _e5937;
                        }
                        let _e5940 = phi_2492_;
                        if ((_e5940 - ((((((_e5716 * 8f) * _e5826) * (0.000000059604645f * (524f / 64f))) + ((_e5833 * 19f) * ((_e5716 * (_e5770 + _e5824)) + (_e5770 * _e5824)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5716) * ((1f + _e5770) * (1f + _e5824))))) + ((_e527.member_1 * (((_e5895 + (_e5826 * (0.000000059604645f * 8f))) + ((_e5900 * 6f) * (_e5770 + _e5824))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5770) * (1f + _e5824))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2501_ = type_39(type_28(0u, f32()), 0u);
                            phi_2502_ = false;
                        } else {
                            phi_2501_ = type_39();
                            phi_2502_ = true;
                        }
                        let _e5946 = phi_2501_;
                        let _e5948 = phi_2502_;
                        phi_2503_ = _e5946;
                        phi_2504_ = _e5948;
                    }
                    let _e5950 = phi_2503_;
                    let _e5952 = phi_2504_;
                    if _e5952 {
                        phi_2510_ = type_14(0i, 2i);
                        phi_2513_ = _e323;
                        phi_2515_ = 0u;
                        phi_2517_ = _e323;
                        loop {
                            let _e5954 = phi_2510_;
                            let _e5956 = phi_2513_;
                            let _e5958 = phi_2515_;
                            let _e5960 = phi_2517_;
                            local_96 = _e5958;
                            local_99 = _e5956;
                            local_100 = _e5958;
                            if (_e5954.member < _e5954.member_1) {
                                let _e5967 = (_e5954.member + 1i);
                                if ((false == (_e5967 > _e5954.member)) != false) {
                                    phi_2538_ = true;
                                } else {
                                    phi_2538_ = false;
                                }
                                let _e5972 = phi_2538_;
                                if _e5972 {
                                    phi_2544_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_2544_ = type_15(1u, _e5967);
                                }
                                let _e5977 = phi_2544_;
                                phi_2511_ = type_14(_e5977.member_1, _e5954.member_1);
                                phi_2558_ = type_15(1u, _e5954.member);
                            } else {
                                phi_2511_ = _e5954;
                                phi_2558_ = type_15(0u, type_15().member_1);
                            }
                            let _e5983 = phi_2511_;
                            let _e5985 = phi_2558_;
                            if (bitcast<i32>(_e5985.member) != 0i) {
                                if (_e5985.member_1 > 0i) {
                                    phi_2574_ = true;
                                } else {
                                    if _e5507 {
                                        phi_2573_ = false;
                                    } else {
                                        phi_2573_ = true;
                                    }
                                    let _e5992 = phi_2573_;
                                    phi_2574_ = _e5992;
                                }
                                let _e5994 = phi_2574_;
                                if _e5994 {
                                    let _e5997 = local_18.member[0u];
                                    let _e6003 = local_18.member_1[0u];
                                    let _e6009 = local_18.member_2[0u];
                                    let _e6021 = local_18.member[1u];
                                    let _e6027 = local_18.member_1[1u];
                                    let _e6033 = local_18.member_2[1u];
                                    let _e6045 = local_18.member[0u];
                                    if (_e6045[0] < 0f) {
                                        phi_2720_ = -(_e6045[0]);
                                    } else {
                                        phi_2720_ = _e6045[0];
                                    }
                                    let _e6052 = phi_2720_;
                                    if (_e6045[1] < 0f) {
                                        phi_2727_ = -(_e6045[1]);
                                    } else {
                                        phi_2727_ = _e6045[1];
                                    }
                                    let _e6056 = phi_2727_;
                                    if (_e6052 > _e6056) {
                                        phi_2732_ = _e6052;
                                    } else {
                                        phi_2732_ = _e6056;
                                    }
                                    let _e6059 = phi_2732_;
                                    if (_e6045[2] < 0f) {
                                        phi_2739_ = -(_e6045[2]);
                                    } else {
                                        phi_2739_ = _e6045[2];
                                    }
                                    let _e6063 = phi_2739_;
                                    if (_e6059 > _e6063) {
                                        phi_2744_ = _e6059;
                                    } else {
                                        phi_2744_ = _e6063;
                                    }
                                    let _e6066 = phi_2744_;
                                    let _e6069 = local_18.member[1u];
                                    if (_e6069[0] < 0f) {
                                        phi_2757_ = -(_e6069[0]);
                                    } else {
                                        phi_2757_ = _e6069[0];
                                    }
                                    let _e6076 = phi_2757_;
                                    if (_e6069[1] < 0f) {
                                        phi_2764_ = -(_e6069[1]);
                                    } else {
                                        phi_2764_ = _e6069[1];
                                    }
                                    let _e6080 = phi_2764_;
                                    if (_e6076 > _e6080) {
                                        phi_2769_ = _e6076;
                                    } else {
                                        phi_2769_ = _e6080;
                                    }
                                    let _e6083 = phi_2769_;
                                    if (_e6069[2] < 0f) {
                                        phi_2776_ = -(_e6069[2]);
                                    } else {
                                        phi_2776_ = _e6069[2];
                                    }
                                    let _e6087 = phi_2776_;
                                    if (_e6083 > _e6087) {
                                        phi_2781_ = _e6083;
                                    } else {
                                        phi_2781_ = _e6087;
                                    }
                                    let _e6090 = phi_2781_;
                                    if (_e6066 > _e6090) {
                                        phi_2786_ = _e6066;
                                    } else {
                                        phi_2786_ = _e6090;
                                    }
                                    let _e6093 = phi_2786_;
                                    let _e6095 = local_18.member_3;
                                    let _e6099 = local_18.member_1[0u];
                                    if (_e6099[0] < 0f) {
                                        phi_2803_ = -(_e6099[0]);
                                    } else {
                                        phi_2803_ = _e6099[0];
                                    }
                                    let _e6106 = phi_2803_;
                                    if (_e6099[1] < 0f) {
                                        phi_2810_ = -(_e6099[1]);
                                    } else {
                                        phi_2810_ = _e6099[1];
                                    }
                                    let _e6110 = phi_2810_;
                                    if (_e6106 > _e6110) {
                                        phi_2815_ = _e6106;
                                    } else {
                                        phi_2815_ = _e6110;
                                    }
                                    let _e6113 = phi_2815_;
                                    if (_e6099[2] < 0f) {
                                        phi_2822_ = -(_e6099[2]);
                                    } else {
                                        phi_2822_ = _e6099[2];
                                    }
                                    let _e6117 = phi_2822_;
                                    if (_e6113 > _e6117) {
                                        phi_2827_ = _e6113;
                                    } else {
                                        phi_2827_ = _e6117;
                                    }
                                    let _e6120 = phi_2827_;
                                    let _e6123 = local_18.member_1[1u];
                                    if (_e6123[0] < 0f) {
                                        phi_2841_ = -(_e6123[0]);
                                    } else {
                                        phi_2841_ = _e6123[0];
                                    }
                                    let _e6130 = phi_2841_;
                                    if (_e6123[1] < 0f) {
                                        phi_2848_ = -(_e6123[1]);
                                    } else {
                                        phi_2848_ = _e6123[1];
                                    }
                                    let _e6134 = phi_2848_;
                                    if (_e6130 > _e6134) {
                                        phi_2853_ = _e6130;
                                    } else {
                                        phi_2853_ = _e6134;
                                    }
                                    let _e6137 = phi_2853_;
                                    if (_e6123[2] < 0f) {
                                        phi_2860_ = -(_e6123[2]);
                                    } else {
                                        phi_2860_ = _e6123[2];
                                    }
                                    let _e6141 = phi_2860_;
                                    if (_e6137 > _e6141) {
                                        phi_2865_ = _e6137;
                                    } else {
                                        phi_2865_ = _e6141;
                                    }
                                    let _e6144 = phi_2865_;
                                    if (_e6120 > _e6144) {
                                        phi_2870_ = _e6120;
                                    } else {
                                        phi_2870_ = _e6144;
                                    }
                                    let _e6147 = phi_2870_;
                                    let _e6149 = local_18.member_3;
                                    let _e6153 = local_18.member_2[0u];
                                    if (_e6153[0] < 0f) {
                                        phi_2887_ = -(_e6153[0]);
                                    } else {
                                        phi_2887_ = _e6153[0];
                                    }
                                    let _e6160 = phi_2887_;
                                    if (_e6153[1] < 0f) {
                                        phi_2894_ = -(_e6153[1]);
                                    } else {
                                        phi_2894_ = _e6153[1];
                                    }
                                    let _e6164 = phi_2894_;
                                    if (_e6160 > _e6164) {
                                        phi_2899_ = _e6160;
                                    } else {
                                        phi_2899_ = _e6164;
                                    }
                                    let _e6167 = phi_2899_;
                                    if (_e6153[2] < 0f) {
                                        phi_2906_ = -(_e6153[2]);
                                    } else {
                                        phi_2906_ = _e6153[2];
                                    }
                                    let _e6171 = phi_2906_;
                                    if (_e6167 > _e6171) {
                                        phi_2911_ = _e6167;
                                    } else {
                                        phi_2911_ = _e6171;
                                    }
                                    let _e6174 = phi_2911_;
                                    let _e6177 = local_18.member_2[1u];
                                    if (_e6177[0] < 0f) {
                                        phi_2925_ = -(_e6177[0]);
                                    } else {
                                        phi_2925_ = _e6177[0];
                                    }
                                    let _e6184 = phi_2925_;
                                    if (_e6177[1] < 0f) {
                                        phi_2932_ = -(_e6177[1]);
                                    } else {
                                        phi_2932_ = _e6177[1];
                                    }
                                    let _e6188 = phi_2932_;
                                    if (_e6184 > _e6188) {
                                        phi_2937_ = _e6184;
                                    } else {
                                        phi_2937_ = _e6188;
                                    }
                                    let _e6191 = phi_2937_;
                                    if (_e6177[2] < 0f) {
                                        phi_2944_ = -(_e6177[2]);
                                    } else {
                                        phi_2944_ = _e6177[2];
                                    }
                                    let _e6195 = phi_2944_;
                                    if (_e6191 > _e6195) {
                                        phi_2949_ = _e6191;
                                    } else {
                                        phi_2949_ = _e6195;
                                    }
                                    let _e6198 = phi_2949_;
                                    if (_e6174 > _e6198) {
                                        phi_2954_ = _e6174;
                                    } else {
                                        phi_2954_ = _e6198;
                                    }
                                    let _e6201 = phi_2954_;
                                    let _e6203 = local_18.member_3;
                                    let _e6210 = local_18.member_3;
                                    let _e6215 = (_e321 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2995_ = type_12(0u, 96u);
                                    phi_2998_ = _e5960;
                                    phi_3000_ = _e5960;
                                    phi_3002_ = (_e325 - _e5960);
                                    phi_3004_ = _e5960;
                                    phi_3006_ = false;
                                    phi_3008_ = 0u;
                                    loop {
                                        let _e6218 = phi_2995_;
                                        let _e6220 = phi_2998_;
                                        let _e6222 = phi_3000_;
                                        let _e6224 = phi_3002_;
                                        let _e6226 = phi_3004_;
                                        let _e6228 = phi_3006_;
                                        let _e6230 = phi_3008_;
                                        local_43 = _e6220;
                                        local_86 = _e6222;
                                        if (_e6218.member < _e6218.member_1) {
                                            phi_2996_ = type_12((_e6218.member + 1u), _e6218.member_1);
                                            phi_3031_ = type_12(1u, _e6218.member);
                                        } else {
                                            phi_2996_ = _e6218;
                                            phi_3031_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6242 = phi_2996_;
                                        let _e6244 = phi_3031_;
                                        if (bitcast<i32>(_e6244.member) != 0i) {
                                            let _e6250 = local_18.member[0u];
                                            let _e6256 = local_18.member[1u];
                                            let _e6272 = local_18.member_1[0u];
                                            let _e6278 = local_18.member_1[1u];
                                            let _e6294 = local_18.member_2[0u];
                                            let _e6300 = local_18.member_2[1u];
                                            let _e6314 = function_2(array<f32, 3>((_e6250[0] + ((_e6256[0] - _e6250[0]) * _e6220)), (_e6250[1] + ((_e6256[1] - _e6250[1]) * _e6220)), (_e6250[2] + ((_e6256[2] - _e6250[2]) * _e6220))), array<f32, 3>((_e6272[0] + ((_e6278[0] - _e6272[0]) * _e6220)), (_e6272[1] + ((_e6278[1] - _e6272[1]) * _e6220)), (_e6272[2] + ((_e6278[2] - _e6272[2]) * _e6220))), array<f32, 3>((_e6294[0] + ((_e6300[0] - _e6294[0]) * _e6220)), (_e6294[1] + ((_e6300[1] - _e6294[1]) * _e6220)), (_e6294[2] + ((_e6300[2] - _e6294[2]) * _e6220))), 0u);
                                            if (_e6230 == 0u) {
                                                phi_3159_ = _e6314;
                                            } else {
                                                if (_e6230 == 1u) {
                                                    phi_3145_ = _e6314[0];
                                                } else {
                                                    phi_3145_ = 0f;
                                                }
                                                let _e6319 = phi_3145_;
                                                if (_e6230 == 2u) {
                                                    phi_3151_ = _e6314[1];
                                                } else {
                                                    phi_3151_ = 0f;
                                                }
                                                let _e6323 = phi_3151_;
                                                if (_e6230 == 3u) {
                                                    phi_3157_ = _e6314[2];
                                                } else {
                                                    phi_3157_ = 0f;
                                                }
                                                let _e6327 = phi_3157_;
                                                phi_3159_ = array<f32, 3>(_e6319, _e6323, _e6327);
                                            }
                                            let _e6330 = phi_3159_;
                                            if (_e6330[0] < 0f) {
                                                phi_3166_ = -(_e6330[0]);
                                            } else {
                                                phi_3166_ = _e6330[0];
                                            }
                                            let _e6335 = phi_3166_;
                                            if (_e6330[1] < 0f) {
                                                phi_3173_ = -(_e6330[1]);
                                            } else {
                                                phi_3173_ = _e6330[1];
                                            }
                                            let _e6340 = phi_3173_;
                                            if (_e6330[2] < 0f) {
                                                phi_3181_ = -(_e6330[2]);
                                            } else {
                                                phi_3181_ = _e6330[2];
                                            }
                                            let _e6346 = phi_3181_;
                                            let _e6347 = ((_e6335 + _e6340) + _e6346);
                                            if (_e6347 > 0f) {
                                                if ((bitcast<u32>(_e6347) & 2139095040u) != 2139095040u) {
                                                    let _e6352 = (1f / _e6347);
                                                    let _e6354 = (_e6330[0] * _e6352);
                                                    let _e6356 = (_e6330[1] * _e6352);
                                                    let _e6358 = (_e6330[2] * _e6352);
                                                    let _e6363 = (((_e6354 * _e6354) + (_e6356 * _e6356)) + (_e6358 * _e6358));
                                                    if (_e6363 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6363 > 0f) {
                                                            phi_3218_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_3218_ = 0f;
                                                        }
                                                        let _e6416 = phi_3218_;
                                                        phi_3282_ = _e6416;
                                                    } else {
                                                        phi_3225_ = type_14(0i, 5i);
                                                        phi_3228_ = bitcast<f32>(((bitcast<u32>(_e6363) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6371 = phi_3225_;
                                                            let _e6373 = phi_3228_;
                                                            local_40 = _e6373;
                                                            if (_e6371.member < _e6371.member_1) {
                                                                let _e6380 = (_e6371.member + 1i);
                                                                if ((false == (_e6380 > _e6371.member)) != false) {
                                                                    phi_3249_ = true;
                                                                } else {
                                                                    phi_3249_ = false;
                                                                }
                                                                let _e6385 = phi_3249_;
                                                                if _e6385 {
                                                                    phi_3255_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_3255_ = type_15(1u, _e6380);
                                                                }
                                                                let _e6390 = phi_3255_;
                                                                phi_3226_ = type_14(_e6390.member_1, _e6371.member_1);
                                                                phi_3269_ = type_15(1u, _e6371.member);
                                                            } else {
                                                                phi_3226_ = _e6371;
                                                                phi_3269_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6396 = phi_3226_;
                                                            let _e6398 = phi_3269_;
                                                            let _e6401 = (bitcast<i32>(_e6398.member) != 0i);
                                                            if _e6401 {
                                                                phi_3229_ = (0.5f * (_e6373 + (_e6363 / _e6373)));
                                                            } else {
                                                                phi_3229_ = f32();
                                                            }
                                                            let _e6406 = phi_3229_;
                                                            continue;
                                                            continuing {
                                                                phi_3225_ = _e6396;
                                                                phi_3228_ = _e6406;
                                                                break if !(_e6401);
                                                            }
                                                        }
                                                        let _e6411 = local_40;
                                                        phi_3282_ = (_e6411 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6418 = phi_3282_;
                                                    let _e6419 = (0.000000059604645f * 12f);
                                                    let _e6424 = ((((((((_e6093 + _e6095) + (_e6147 + _e6149)) + (_e6201 + _e6203)) * (0.000000059604645f * 16f)) + (_e6210 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e527.member_1 * _e6418) * (1f + _e6419)));
                                                    let _e6429 = (((_e6354 * _e5997[0]) + (_e6356 * _e5997[1])) + (_e6358 * _e5997[2]));
                                                    let _e6434 = (((_e6354 * (_e5997[0] - _e6003[0])) + (_e6356 * (_e5997[1] - _e6003[1]))) + (_e6358 * (_e5997[2] - _e6003[2])));
                                                    let _e6439 = (((_e6354 * (_e5997[0] - _e6009[0])) + (_e6356 * (_e5997[1] - _e6009[1]))) + (_e6358 * (_e5997[2] - _e6009[2])));
                                                    let _e6444 = (((_e6354 * _e5997[0]) + (_e6356 * _e5997[1])) + (_e6358 * _e5997[2]));
                                                    let _e6450 = (((_e6354 * _e6021[0]) + (_e6356 * _e6021[1])) + (_e6358 * _e6021[2]));
                                                    let _e6455 = (((_e6354 * (_e6021[0] - _e6027[0])) + (_e6356 * (_e6021[1] - _e6027[1]))) + (_e6358 * (_e6021[2] - _e6027[2])));
                                                    let _e6460 = (((_e6354 * (_e6021[0] - _e6033[0])) + (_e6356 * (_e6021[1] - _e6033[1]))) + (_e6358 * (_e6021[2] - _e6033[2])));
                                                    let _e6465 = (((_e6354 * _e6021[0]) + (_e6356 * _e6021[1])) + (_e6358 * _e6021[2]));
                                                    if (_e6429 < 0f) {
                                                        phi_3348_ = -(_e6429);
                                                    } else {
                                                        phi_3348_ = _e6429;
                                                    }
                                                    let _e6470 = phi_3348_;
                                                    if (_e6450 < 0f) {
                                                        phi_3354_ = -(_e6450);
                                                    } else {
                                                        phi_3354_ = _e6450;
                                                    }
                                                    let _e6474 = phi_3354_;
                                                    if (_e6434 < 0f) {
                                                        phi_3363_ = -(_e6434);
                                                    } else {
                                                        phi_3363_ = _e6434;
                                                    }
                                                    let _e6481 = phi_3363_;
                                                    if (_e6455 < 0f) {
                                                        phi_3369_ = -(_e6455);
                                                    } else {
                                                        phi_3369_ = _e6455;
                                                    }
                                                    let _e6485 = phi_3369_;
                                                    if (_e6439 < 0f) {
                                                        phi_3378_ = -(_e6439);
                                                    } else {
                                                        phi_3378_ = _e6439;
                                                    }
                                                    let _e6492 = phi_3378_;
                                                    if (_e6460 < 0f) {
                                                        phi_3384_ = -(_e6460);
                                                    } else {
                                                        phi_3384_ = _e6460;
                                                    }
                                                    let _e6496 = phi_3384_;
                                                    if (_e6444 < 0f) {
                                                        phi_3393_ = -(_e6444);
                                                    } else {
                                                        phi_3393_ = _e6444;
                                                    }
                                                    let _e6503 = phi_3393_;
                                                    if (_e6465 < 0f) {
                                                        phi_3399_ = -(_e6465);
                                                    } else {
                                                        phi_3399_ = _e6465;
                                                    }
                                                    let _e6507 = phi_3399_;
                                                    phi_3405_ = type_32(array<f32, 4>(_e6429, _e6434, _e6439, _e6444), array<f32, 4>(_e6450, _e6455, _e6460, _e6465), array<f32, 4>((_e6424 + ((_e6470 + _e6474) * _e6419)), (_e6424 + ((_e6481 + _e6485) * _e6419)), (_e6424 + ((_e6492 + _e6496) * _e6419)), (_e6424 + ((_e6503 + _e6507) * _e6419))));
                                                    phi_3406_ = false;
                                                } else {
                                                    phi_3405_ = type_32();
                                                    phi_3406_ = true;
                                                }
                                                let _e6514 = phi_3405_;
                                                let _e6516 = phi_3406_;
                                                phi_3407_ = _e6514;
                                                phi_3408_ = _e6516;
                                            } else {
                                                phi_3407_ = type_32();
                                                phi_3408_ = true;
                                            }
                                            let _e6518 = phi_3407_;
                                            let _e6520 = phi_3408_;
                                            if _e6520 {
                                                phi_3416_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3416_ = _e6518;
                                            }
                                            let _e6522 = phi_3416_;
                                            local_17 = type_32(array<f32, 4>(_e6522.member[0], _e6522.member[1], _e6522.member[2], _e6522.member[3]), array<f32, 4>(_e6522.member_1[0], _e6522.member_1[1], _e6522.member_1[2], _e6522.member_1[3]), array<f32, 4>(_e6522.member_2[0], _e6522.member_2[1], _e6522.member_2[2], _e6522.member_2[3]));
                                            let _e6542 = (_e6220 - _e6226);
                                            let _e6546 = local_17.member[0u];
                                            let _e6549 = local_17.member_1[0u];
                                            let _e6552 = local_17.member[0u];
                                            let _e6558 = local_17.member_2[0u];
                                            if (((_e6546 + ((_e6549 - _e6552) * _e6220)) - _e6558) > 0f) {
                                                let _e6563 = local_17.member[1u];
                                                let _e6566 = local_17.member_1[1u];
                                                let _e6569 = local_17.member[1u];
                                                let _e6575 = local_17.member_2[1u];
                                                if (((_e6563 + ((_e6566 - _e6569) * _e6220)) - _e6575) > 0f) {
                                                    let _e6580 = local_17.member[2u];
                                                    let _e6583 = local_17.member_1[2u];
                                                    let _e6586 = local_17.member[2u];
                                                    let _e6592 = local_17.member_2[2u];
                                                    if (((_e6580 + ((_e6583 - _e6586) * _e6220)) - _e6592) > 0f) {
                                                        let _e6597 = local_17.member[3u];
                                                        let _e6600 = local_17.member_1[3u];
                                                        let _e6603 = local_17.member[3u];
                                                        let _e6609 = local_17.member_2[3u];
                                                        phi_3587_ = (((_e6597 + ((_e6600 - _e6603) * _e6220)) - _e6609) > 0f);
                                                        phi_3588_ = false;
                                                    } else {
                                                        phi_3587_ = bool();
                                                        phi_3588_ = true;
                                                    }
                                                    let _e6613 = phi_3587_;
                                                    let _e6615 = phi_3588_;
                                                    phi_3589_ = _e6613;
                                                    phi_3590_ = _e6615;
                                                } else {
                                                    phi_3589_ = bool();
                                                    phi_3590_ = true;
                                                }
                                                let _e6617 = phi_3589_;
                                                let _e6619 = phi_3590_;
                                                phi_3591_ = _e6617;
                                                phi_3592_ = _e6619;
                                            } else {
                                                phi_3591_ = bool();
                                                phi_3592_ = true;
                                            }
                                            let _e6621 = phi_3591_;
                                            let _e6623 = phi_3592_;
                                            if _e6623 {
                                                phi_3596_ = false;
                                            } else {
                                                phi_3596_ = _e6621;
                                            }
                                            let _e6625 = phi_3596_;
                                            if _e6625 {
                                                if (_e6220 <= _e6222) {
                                                    phi_3906_ = true;
                                                } else {
                                                    let _e6629 = local_16.member[0u];
                                                    let _e6632 = local_16.member_1[0u];
                                                    let _e6635 = local_16.member[0u];
                                                    let _e6641 = local_16.member_2[0u];
                                                    let _e6645 = local_17.member[0u];
                                                    let _e6648 = local_17.member_1[0u];
                                                    let _e6651 = local_17.member[0u];
                                                    let _e6657 = local_17.member_2[0u];
                                                    if ((((_e6629 + ((_e6632 - _e6635) * _e6220)) - _e6641) + ((_e6645 + ((_e6648 - _e6651) * _e6226)) - _e6657)) > 0f) {
                                                        let _e6663 = local_16.member[1u];
                                                        let _e6666 = local_16.member_1[1u];
                                                        let _e6669 = local_16.member[1u];
                                                        let _e6675 = local_16.member_2[1u];
                                                        let _e6679 = local_17.member[1u];
                                                        let _e6682 = local_17.member_1[1u];
                                                        let _e6685 = local_17.member[1u];
                                                        let _e6691 = local_17.member_2[1u];
                                                        if ((((_e6663 + ((_e6666 - _e6669) * _e6220)) - _e6675) + ((_e6679 + ((_e6682 - _e6685) * _e6226)) - _e6691)) > 0f) {
                                                            let _e6697 = local_16.member[2u];
                                                            let _e6700 = local_16.member_1[2u];
                                                            let _e6703 = local_16.member[2u];
                                                            let _e6709 = local_16.member_2[2u];
                                                            let _e6713 = local_17.member[2u];
                                                            let _e6716 = local_17.member_1[2u];
                                                            let _e6719 = local_17.member[2u];
                                                            let _e6725 = local_17.member_2[2u];
                                                            if ((((_e6697 + ((_e6700 - _e6703) * _e6220)) - _e6709) + ((_e6713 + ((_e6716 - _e6719) * _e6226)) - _e6725)) > 0f) {
                                                                let _e6731 = local_16.member[3u];
                                                                let _e6734 = local_16.member_1[3u];
                                                                let _e6737 = local_16.member[3u];
                                                                let _e6743 = local_16.member_2[3u];
                                                                let _e6747 = local_17.member[3u];
                                                                let _e6750 = local_17.member_1[3u];
                                                                let _e6753 = local_17.member[3u];
                                                                let _e6759 = local_17.member_2[3u];
                                                                phi_3893_ = ((((_e6731 + ((_e6734 - _e6737) * _e6220)) - _e6743) + ((_e6747 + ((_e6750 - _e6753) * _e6226)) - _e6759)) > 0f);
                                                                phi_3894_ = false;
                                                            } else {
                                                                phi_3893_ = bool();
                                                                phi_3894_ = true;
                                                            }
                                                            let _e6764 = phi_3893_;
                                                            let _e6766 = phi_3894_;
                                                            phi_3895_ = _e6764;
                                                            phi_3896_ = _e6766;
                                                        } else {
                                                            phi_3895_ = bool();
                                                            phi_3896_ = true;
                                                        }
                                                        let _e6768 = phi_3895_;
                                                        let _e6770 = phi_3896_;
                                                        phi_3897_ = _e6768;
                                                        phi_3898_ = _e6770;
                                                    } else {
                                                        phi_3897_ = bool();
                                                        phi_3898_ = true;
                                                    }
                                                    let _e6772 = phi_3897_;
                                                    let _e6774 = phi_3898_;
                                                    if _e6774 {
                                                        phi_3902_ = false;
                                                    } else {
                                                        phi_3902_ = _e6772;
                                                    }
                                                    let _e6776 = phi_3902_;
                                                    phi_3906_ = _e6776;
                                                }
                                                let _e6778 = phi_3906_;
                                                if _e6778 {
                                                    if _e6228 {
                                                        if (_e6220 >= _e325) {
                                                            phi_3917_ = false;
                                                        } else {
                                                            phi_3917_ = true;
                                                        }
                                                        let _e6781 = phi_3917_;
                                                        phi_3918_ = _e6781;
                                                    } else {
                                                        phi_3918_ = true;
                                                    }
                                                    let _e6783 = phi_3918_;
                                                    if _e6783 {
                                                        local_16 = type_32(array<f32, 4>(_e6522.member[0], _e6522.member[1], _e6522.member[2], _e6522.member[3]), array<f32, 4>(_e6522.member_1[0], _e6522.member_1[1], _e6522.member_1[2], _e6522.member_1[3]), array<f32, 4>(_e6522.member_2[0], _e6522.member_2[1], _e6522.member_2[2], _e6522.member_2[3]));
                                                        let _e6805 = local_16.member[0u];
                                                        let _e6808 = local_16.member_1[0u];
                                                        let _e6811 = local_16.member_2[0u];
                                                        if (_e6805 > _e6811) {
                                                            if (_e6808 > _e6811) {
                                                                phi_3992_ = false;
                                                            } else {
                                                                phi_3992_ = true;
                                                            }
                                                            let _e6815 = phi_3992_;
                                                            phi_3993_ = _e6815;
                                                        } else {
                                                            phi_3993_ = true;
                                                        }
                                                        let _e6817 = phi_3993_;
                                                        if _e6817 {
                                                            let _e6818 = (_e6808 >= _e6805);
                                                            if _e6818 {
                                                                phi_4015_ = f32();
                                                                phi_4016_ = false;
                                                            } else {
                                                                if ((_e6805 - _e6808) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4013_ = (((_e6805 - _e6811) / (_e6805 - _e6808)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4014_ = false;
                                                                } else {
                                                                    phi_4013_ = f32();
                                                                    phi_4014_ = true;
                                                                }
                                                                let _e6829 = phi_4013_;
                                                                let _e6831 = phi_4014_;
                                                                phi_4015_ = _e6829;
                                                                phi_4016_ = _e6831;
                                                            }
                                                            let _e6833 = phi_4015_;
                                                            let _e6835 = phi_4016_;
                                                            phi_4017_ = _e6833;
                                                            phi_4018_ = _e6818;
                                                            phi_4019_ = _e6835;
                                                        } else {
                                                            phi_4017_ = f32();
                                                            phi_4018_ = true;
                                                            phi_4019_ = false;
                                                        }
                                                        let _e6837 = phi_4017_;
                                                        let _e6839 = phi_4018_;
                                                        let _e6841 = phi_4019_;
                                                        if _e6839 {
                                                            phi_4023_ = 2f;
                                                            phi_4024_ = true;
                                                        } else {
                                                            phi_4023_ = _e6220;
                                                            phi_4024_ = _e6841;
                                                        }
                                                        let _e6843 = phi_4023_;
                                                        let _e6845 = phi_4024_;
                                                        if _e6845 {
                                                            phi_4028_ = _e6843;
                                                        } else {
                                                            phi_4028_ = _e6837;
                                                        }
                                                        let _e6847 = phi_4028_;
                                                        let _e6850 = local_16.member[1u];
                                                        let _e6853 = local_16.member_1[1u];
                                                        let _e6856 = local_16.member_2[1u];
                                                        if (_e6850 > _e6856) {
                                                            if (_e6853 > _e6856) {
                                                                phi_4060_ = false;
                                                            } else {
                                                                phi_4060_ = true;
                                                            }
                                                            let _e6860 = phi_4060_;
                                                            phi_4061_ = _e6860;
                                                        } else {
                                                            phi_4061_ = true;
                                                        }
                                                        let _e6862 = phi_4061_;
                                                        if _e6862 {
                                                            let _e6863 = (_e6853 >= _e6850);
                                                            if _e6863 {
                                                                phi_4083_ = f32();
                                                                phi_4084_ = false;
                                                            } else {
                                                                if ((_e6850 - _e6853) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4081_ = (((_e6850 - _e6856) / (_e6850 - _e6853)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4082_ = false;
                                                                } else {
                                                                    phi_4081_ = f32();
                                                                    phi_4082_ = true;
                                                                }
                                                                let _e6874 = phi_4081_;
                                                                let _e6876 = phi_4082_;
                                                                phi_4083_ = _e6874;
                                                                phi_4084_ = _e6876;
                                                            }
                                                            let _e6878 = phi_4083_;
                                                            let _e6880 = phi_4084_;
                                                            phi_4085_ = _e6878;
                                                            phi_4086_ = _e6863;
                                                            phi_4087_ = _e6880;
                                                        } else {
                                                            phi_4085_ = f32();
                                                            phi_4086_ = true;
                                                            phi_4087_ = false;
                                                        }
                                                        let _e6882 = phi_4085_;
                                                        let _e6884 = phi_4086_;
                                                        let _e6886 = phi_4087_;
                                                        if _e6884 {
                                                            phi_4091_ = 2f;
                                                            phi_4092_ = true;
                                                        } else {
                                                            phi_4091_ = _e6220;
                                                            phi_4092_ = _e6886;
                                                        }
                                                        let _e6888 = phi_4091_;
                                                        let _e6890 = phi_4092_;
                                                        if _e6890 {
                                                            phi_4096_ = _e6888;
                                                        } else {
                                                            phi_4096_ = _e6882;
                                                        }
                                                        let _e6892 = phi_4096_;
                                                        if (_e6847 < _e6892) {
                                                            phi_4101_ = _e6847;
                                                        } else {
                                                            phi_4101_ = _e6892;
                                                        }
                                                        let _e6895 = phi_4101_;
                                                        let _e6898 = local_16.member[2u];
                                                        let _e6901 = local_16.member_1[2u];
                                                        let _e6904 = local_16.member_2[2u];
                                                        if (_e6898 > _e6904) {
                                                            if (_e6901 > _e6904) {
                                                                phi_4133_ = false;
                                                            } else {
                                                                phi_4133_ = true;
                                                            }
                                                            let _e6908 = phi_4133_;
                                                            phi_4134_ = _e6908;
                                                        } else {
                                                            phi_4134_ = true;
                                                        }
                                                        let _e6910 = phi_4134_;
                                                        if _e6910 {
                                                            let _e6911 = (_e6901 >= _e6898);
                                                            if _e6911 {
                                                                phi_4156_ = f32();
                                                                phi_4157_ = false;
                                                            } else {
                                                                if ((_e6898 - _e6901) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4154_ = (((_e6898 - _e6904) / (_e6898 - _e6901)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4155_ = false;
                                                                } else {
                                                                    phi_4154_ = f32();
                                                                    phi_4155_ = true;
                                                                }
                                                                let _e6922 = phi_4154_;
                                                                let _e6924 = phi_4155_;
                                                                phi_4156_ = _e6922;
                                                                phi_4157_ = _e6924;
                                                            }
                                                            let _e6926 = phi_4156_;
                                                            let _e6928 = phi_4157_;
                                                            phi_4158_ = _e6926;
                                                            phi_4159_ = _e6911;
                                                            phi_4160_ = _e6928;
                                                        } else {
                                                            phi_4158_ = f32();
                                                            phi_4159_ = true;
                                                            phi_4160_ = false;
                                                        }
                                                        let _e6930 = phi_4158_;
                                                        let _e6932 = phi_4159_;
                                                        let _e6934 = phi_4160_;
                                                        if _e6932 {
                                                            phi_4164_ = 2f;
                                                            phi_4165_ = true;
                                                        } else {
                                                            phi_4164_ = _e6220;
                                                            phi_4165_ = _e6934;
                                                        }
                                                        let _e6936 = phi_4164_;
                                                        let _e6938 = phi_4165_;
                                                        if _e6938 {
                                                            phi_4169_ = _e6936;
                                                        } else {
                                                            phi_4169_ = _e6930;
                                                        }
                                                        let _e6940 = phi_4169_;
                                                        let _e6943 = local_16.member[3u];
                                                        let _e6946 = local_16.member_1[3u];
                                                        let _e6949 = local_16.member_2[3u];
                                                        if (_e6943 > _e6949) {
                                                            if (_e6946 > _e6949) {
                                                                phi_4201_ = false;
                                                            } else {
                                                                phi_4201_ = true;
                                                            }
                                                            let _e6953 = phi_4201_;
                                                            phi_4202_ = _e6953;
                                                        } else {
                                                            phi_4202_ = true;
                                                        }
                                                        let _e6955 = phi_4202_;
                                                        if _e6955 {
                                                            let _e6956 = (_e6946 >= _e6943);
                                                            if _e6956 {
                                                                phi_4224_ = f32();
                                                                phi_4225_ = false;
                                                            } else {
                                                                if ((_e6943 - _e6946) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_4222_ = (((_e6943 - _e6949) / (_e6943 - _e6946)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_4223_ = false;
                                                                } else {
                                                                    phi_4222_ = f32();
                                                                    phi_4223_ = true;
                                                                }
                                                                let _e6967 = phi_4222_;
                                                                let _e6969 = phi_4223_;
                                                                phi_4224_ = _e6967;
                                                                phi_4225_ = _e6969;
                                                            }
                                                            let _e6971 = phi_4224_;
                                                            let _e6973 = phi_4225_;
                                                            phi_4226_ = _e6971;
                                                            phi_4227_ = _e6956;
                                                            phi_4228_ = _e6973;
                                                        } else {
                                                            phi_4226_ = f32();
                                                            phi_4227_ = true;
                                                            phi_4228_ = false;
                                                        }
                                                        let _e6975 = phi_4226_;
                                                        let _e6977 = phi_4227_;
                                                        let _e6979 = phi_4228_;
                                                        if _e6977 {
                                                            phi_4232_ = 2f;
                                                            phi_4233_ = true;
                                                        } else {
                                                            phi_4232_ = _e6220;
                                                            phi_4233_ = _e6979;
                                                        }
                                                        let _e6981 = phi_4232_;
                                                        let _e6983 = phi_4233_;
                                                        if _e6983 {
                                                            phi_4237_ = _e6981;
                                                        } else {
                                                            phi_4237_ = _e6975;
                                                        }
                                                        let _e6985 = phi_4237_;
                                                        if (_e6940 < _e6985) {
                                                            phi_4242_ = _e6940;
                                                        } else {
                                                            phi_4242_ = _e6985;
                                                        }
                                                        let _e6988 = phi_4242_;
                                                        if (_e6895 < _e6988) {
                                                            phi_4247_ = _e6895;
                                                        } else {
                                                            phi_4247_ = _e6988;
                                                        }
                                                        let _e6991 = phi_4247_;
                                                        if (_e6991 > _e6220) {
                                                            phi_4252_ = _e6991;
                                                        } else {
                                                            phi_4252_ = _e6220;
                                                        }
                                                        let _e6994 = phi_4252_;
                                                        let _e6995 = (_e6994 > _e325);
                                                        if _e6995 {
                                                            phi_4757_ = f32();
                                                            phi_4758_ = f32();
                                                            phi_4759_ = false;
                                                            phi_4760_ = false;
                                                        } else {
                                                            let _e6996 = (_e6994 - _e6220);
                                                            let _e6997 = (_e6996 <= _e6215);
                                                            let _e6999 = (_e6994 + (_e321 * 0.01f));
                                                            if (_e6999 < _e325) {
                                                                phi_4265_ = _e6999;
                                                            } else {
                                                                phi_4265_ = _e325;
                                                            }
                                                            let _e7002 = phi_4265_;
                                                            if _e6997 {
                                                                if (_e527.member_1 > 0f) {
                                                                    let _e7006 = local_18.member[0u];
                                                                    let _e7012 = local_18.member[1u];
                                                                    let _e7028 = local_18.member_1[0u];
                                                                    let _e7034 = local_18.member_1[1u];
                                                                    let _e7050 = local_18.member_2[0u];
                                                                    let _e7056 = local_18.member_2[1u];
                                                                    let _e7070 = function_2(array<f32, 3>((_e7006[0] + ((_e7012[0] - _e7006[0]) * _e7002)), (_e7006[1] + ((_e7012[1] - _e7006[1]) * _e7002)), (_e7006[2] + ((_e7012[2] - _e7006[2]) * _e7002))), array<f32, 3>((_e7028[0] + ((_e7034[0] - _e7028[0]) * _e7002)), (_e7028[1] + ((_e7034[1] - _e7028[1]) * _e7002)), (_e7028[2] + ((_e7034[2] - _e7028[2]) * _e7002))), array<f32, 3>((_e7050[0] + ((_e7056[0] - _e7050[0]) * _e7002)), (_e7050[1] + ((_e7056[1] - _e7050[1]) * _e7002)), (_e7050[2] + ((_e7056[2] - _e7050[2]) * _e7002))), 0u);
                                                                    let _e7081 = (((_e7070[0] * _e7070[0]) + (_e7070[1] * _e7070[1])) + (_e7070[2] * _e7070[2]));
                                                                    if (_e7081 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7081 > 0f) {
                                                                            phi_4395_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_4395_ = 0f;
                                                                        }
                                                                        let _e7134 = phi_4395_;
                                                                        phi_4459_ = _e7134;
                                                                    } else {
                                                                        phi_4402_ = type_14(0i, 5i);
                                                                        phi_4405_ = bitcast<f32>(((bitcast<u32>(_e7081) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7089 = phi_4402_;
                                                                            let _e7091 = phi_4405_;
                                                                            local_41 = _e7091;
                                                                            if (_e7089.member < _e7089.member_1) {
                                                                                let _e7098 = (_e7089.member + 1i);
                                                                                if ((false == (_e7098 > _e7089.member)) != false) {
                                                                                    phi_4426_ = true;
                                                                                } else {
                                                                                    phi_4426_ = false;
                                                                                }
                                                                                let _e7103 = phi_4426_;
                                                                                if _e7103 {
                                                                                    phi_4432_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_4432_ = type_15(1u, _e7098);
                                                                                }
                                                                                let _e7108 = phi_4432_;
                                                                                phi_4403_ = type_14(_e7108.member_1, _e7089.member_1);
                                                                                phi_4446_ = type_15(1u, _e7089.member);
                                                                            } else {
                                                                                phi_4403_ = _e7089;
                                                                                phi_4446_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7114 = phi_4403_;
                                                                            let _e7116 = phi_4446_;
                                                                            let _e7119 = (bitcast<i32>(_e7116.member) != 0i);
                                                                            if _e7119 {
                                                                                phi_4406_ = (0.5f * (_e7091 + (_e7081 / _e7091)));
                                                                            } else {
                                                                                phi_4406_ = f32();
                                                                            }
                                                                            let _e7124 = phi_4406_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4402_ = _e7114;
                                                                                phi_4405_ = _e7124;
                                                                                break if !(_e7119);
                                                                            }
                                                                        }
                                                                        let _e7129 = local_41;
                                                                        phi_4459_ = (_e7129 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7136 = phi_4459_;
                                                                    let _e7142 = local_18.member[0u];
                                                                    if (_e7142[0] < 0f) {
                                                                        phi_4475_ = -(_e7142[0]);
                                                                    } else {
                                                                        phi_4475_ = _e7142[0];
                                                                    }
                                                                    let _e7149 = phi_4475_;
                                                                    if (_e7142[1] < 0f) {
                                                                        phi_4482_ = -(_e7142[1]);
                                                                    } else {
                                                                        phi_4482_ = _e7142[1];
                                                                    }
                                                                    let _e7153 = phi_4482_;
                                                                    if (_e7149 > _e7153) {
                                                                        phi_4487_ = _e7149;
                                                                    } else {
                                                                        phi_4487_ = _e7153;
                                                                    }
                                                                    let _e7156 = phi_4487_;
                                                                    if (_e7142[2] < 0f) {
                                                                        phi_4494_ = -(_e7142[2]);
                                                                    } else {
                                                                        phi_4494_ = _e7142[2];
                                                                    }
                                                                    let _e7160 = phi_4494_;
                                                                    if (_e7156 > _e7160) {
                                                                        phi_4499_ = _e7156;
                                                                    } else {
                                                                        phi_4499_ = _e7160;
                                                                    }
                                                                    let _e7163 = phi_4499_;
                                                                    let _e7166 = local_18.member[1u];
                                                                    if (_e7166[0] < 0f) {
                                                                        phi_4512_ = -(_e7166[0]);
                                                                    } else {
                                                                        phi_4512_ = _e7166[0];
                                                                    }
                                                                    let _e7173 = phi_4512_;
                                                                    if (_e7166[1] < 0f) {
                                                                        phi_4519_ = -(_e7166[1]);
                                                                    } else {
                                                                        phi_4519_ = _e7166[1];
                                                                    }
                                                                    let _e7177 = phi_4519_;
                                                                    if (_e7173 > _e7177) {
                                                                        phi_4524_ = _e7173;
                                                                    } else {
                                                                        phi_4524_ = _e7177;
                                                                    }
                                                                    let _e7180 = phi_4524_;
                                                                    if (_e7166[2] < 0f) {
                                                                        phi_4531_ = -(_e7166[2]);
                                                                    } else {
                                                                        phi_4531_ = _e7166[2];
                                                                    }
                                                                    let _e7184 = phi_4531_;
                                                                    if (_e7180 > _e7184) {
                                                                        phi_4536_ = _e7180;
                                                                    } else {
                                                                        phi_4536_ = _e7184;
                                                                    }
                                                                    let _e7187 = phi_4536_;
                                                                    if (_e7163 > _e7187) {
                                                                        phi_4541_ = _e7163;
                                                                    } else {
                                                                        phi_4541_ = _e7187;
                                                                    }
                                                                    let _e7190 = phi_4541_;
                                                                    let _e7192 = local_18.member_3;
                                                                    let _e7196 = local_18.member_1[0u];
                                                                    if (_e7196[0] < 0f) {
                                                                        phi_4558_ = -(_e7196[0]);
                                                                    } else {
                                                                        phi_4558_ = _e7196[0];
                                                                    }
                                                                    let _e7203 = phi_4558_;
                                                                    if (_e7196[1] < 0f) {
                                                                        phi_4565_ = -(_e7196[1]);
                                                                    } else {
                                                                        phi_4565_ = _e7196[1];
                                                                    }
                                                                    let _e7207 = phi_4565_;
                                                                    if (_e7203 > _e7207) {
                                                                        phi_4570_ = _e7203;
                                                                    } else {
                                                                        phi_4570_ = _e7207;
                                                                    }
                                                                    let _e7210 = phi_4570_;
                                                                    if (_e7196[2] < 0f) {
                                                                        phi_4577_ = -(_e7196[2]);
                                                                    } else {
                                                                        phi_4577_ = _e7196[2];
                                                                    }
                                                                    let _e7214 = phi_4577_;
                                                                    if (_e7210 > _e7214) {
                                                                        phi_4582_ = _e7210;
                                                                    } else {
                                                                        phi_4582_ = _e7214;
                                                                    }
                                                                    let _e7217 = phi_4582_;
                                                                    let _e7220 = local_18.member_1[1u];
                                                                    if (_e7220[0] < 0f) {
                                                                        phi_4596_ = -(_e7220[0]);
                                                                    } else {
                                                                        phi_4596_ = _e7220[0];
                                                                    }
                                                                    let _e7227 = phi_4596_;
                                                                    if (_e7220[1] < 0f) {
                                                                        phi_4603_ = -(_e7220[1]);
                                                                    } else {
                                                                        phi_4603_ = _e7220[1];
                                                                    }
                                                                    let _e7231 = phi_4603_;
                                                                    if (_e7227 > _e7231) {
                                                                        phi_4608_ = _e7227;
                                                                    } else {
                                                                        phi_4608_ = _e7231;
                                                                    }
                                                                    let _e7234 = phi_4608_;
                                                                    if (_e7220[2] < 0f) {
                                                                        phi_4615_ = -(_e7220[2]);
                                                                    } else {
                                                                        phi_4615_ = _e7220[2];
                                                                    }
                                                                    let _e7238 = phi_4615_;
                                                                    if (_e7234 > _e7238) {
                                                                        phi_4620_ = _e7234;
                                                                    } else {
                                                                        phi_4620_ = _e7238;
                                                                    }
                                                                    let _e7241 = phi_4620_;
                                                                    if (_e7217 > _e7241) {
                                                                        phi_4625_ = _e7217;
                                                                    } else {
                                                                        phi_4625_ = _e7241;
                                                                    }
                                                                    let _e7244 = phi_4625_;
                                                                    let _e7246 = local_18.member_3;
                                                                    let _e7250 = local_18.member_2[0u];
                                                                    if (_e7250[0] < 0f) {
                                                                        phi_4642_ = -(_e7250[0]);
                                                                    } else {
                                                                        phi_4642_ = _e7250[0];
                                                                    }
                                                                    let _e7257 = phi_4642_;
                                                                    if (_e7250[1] < 0f) {
                                                                        phi_4649_ = -(_e7250[1]);
                                                                    } else {
                                                                        phi_4649_ = _e7250[1];
                                                                    }
                                                                    let _e7261 = phi_4649_;
                                                                    if (_e7257 > _e7261) {
                                                                        phi_4654_ = _e7257;
                                                                    } else {
                                                                        phi_4654_ = _e7261;
                                                                    }
                                                                    let _e7264 = phi_4654_;
                                                                    if (_e7250[2] < 0f) {
                                                                        phi_4661_ = -(_e7250[2]);
                                                                    } else {
                                                                        phi_4661_ = _e7250[2];
                                                                    }
                                                                    let _e7268 = phi_4661_;
                                                                    if (_e7264 > _e7268) {
                                                                        phi_4666_ = _e7264;
                                                                    } else {
                                                                        phi_4666_ = _e7268;
                                                                    }
                                                                    let _e7271 = phi_4666_;
                                                                    let _e7274 = local_18.member_2[1u];
                                                                    if (_e7274[0] < 0f) {
                                                                        phi_4680_ = -(_e7274[0]);
                                                                    } else {
                                                                        phi_4680_ = _e7274[0];
                                                                    }
                                                                    let _e7281 = phi_4680_;
                                                                    if (_e7274[1] < 0f) {
                                                                        phi_4687_ = -(_e7274[1]);
                                                                    } else {
                                                                        phi_4687_ = _e7274[1];
                                                                    }
                                                                    let _e7285 = phi_4687_;
                                                                    if (_e7281 > _e7285) {
                                                                        phi_4692_ = _e7281;
                                                                    } else {
                                                                        phi_4692_ = _e7285;
                                                                    }
                                                                    let _e7288 = phi_4692_;
                                                                    if (_e7274[2] < 0f) {
                                                                        phi_4699_ = -(_e7274[2]);
                                                                    } else {
                                                                        phi_4699_ = _e7274[2];
                                                                    }
                                                                    let _e7292 = phi_4699_;
                                                                    if (_e7288 > _e7292) {
                                                                        phi_4704_ = _e7288;
                                                                    } else {
                                                                        phi_4704_ = _e7292;
                                                                    }
                                                                    let _e7295 = phi_4704_;
                                                                    if (_e7271 > _e7295) {
                                                                        phi_4709_ = _e7271;
                                                                    } else {
                                                                        phi_4709_ = _e7295;
                                                                    }
                                                                    let _e7298 = phi_4709_;
                                                                    let _e7300 = local_18.member_3;
                                                                    let _e7307 = local_18.member_3;
                                                                    if (((_e7136 * (1f + (0.000000059604645f * 8f))) + (((((((_e7190 + _e7192) + (_e7244 + _e7246)) + (_e7298 + _e7300)) * (0.000000059604645f * 16f)) + (_e7307 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e527.member_1) {
                                                                        phi_4729_ = false;
                                                                    } else {
                                                                        phi_4729_ = true;
                                                                    }
                                                                    let _e7316 = phi_4729_;
                                                                    phi_4730_ = _e7316;
                                                                } else {
                                                                    phi_4730_ = true;
                                                                }
                                                                let _e7318 = phi_4730_;
                                                                phi_4731_ = _e7318;
                                                            } else {
                                                                phi_4731_ = true;
                                                            }
                                                            let _e7320 = phi_4731_;
                                                            if _e7320 {
                                                                if _e6228 {
                                                                    if _e6997 {
                                                                        phi_4747_ = true;
                                                                    } else {
                                                                        if (_e6996 <= (_e6224 * 0.25f)) {
                                                                            phi_4746_ = false;
                                                                        } else {
                                                                            phi_4746_ = true;
                                                                        }
                                                                        let _e7325 = phi_4746_;
                                                                        phi_4747_ = _e7325;
                                                                    }
                                                                    let _e7327 = phi_4747_;
                                                                    if _e7327 {
                                                                        phi_4752_ = (_e6542 + _e6542);
                                                                    } else {
                                                                        phi_4752_ = 0f;
                                                                    }
                                                                    let _e7330 = phi_4752_;
                                                                    phi_4754_ = _e7330;
                                                                } else {
                                                                    phi_4754_ = (_e325 - _e6220);
                                                                }
                                                                let _e7332 = phi_4754_;
                                                                phi_4755_ = _e7332;
                                                                phi_4756_ = false;
                                                            } else {
                                                                phi_4755_ = f32();
                                                                phi_4756_ = true;
                                                            }
                                                            let _e7334 = phi_4755_;
                                                            let _e7336 = phi_4756_;
                                                            phi_4757_ = _e7334;
                                                            phi_4758_ = _e6996;
                                                            phi_4759_ = _e7320;
                                                            phi_4760_ = _e7336;
                                                        }
                                                        let _e7338 = phi_4757_;
                                                        let _e7340 = phi_4758_;
                                                        let _e7342 = phi_4759_;
                                                        let _e7344 = phi_4760_;
                                                        phi_4761_ = _e6994;
                                                        phi_4762_ = _e7338;
                                                        phi_4763_ = _e7340;
                                                        phi_4764_ = _e6994;
                                                        phi_4765_ = _e7342;
                                                        phi_4766_ = _e6995;
                                                        phi_4767_ = _e7344;
                                                        phi_4768_ = false;
                                                    } else {
                                                        phi_4761_ = f32();
                                                        phi_4762_ = f32();
                                                        phi_4763_ = f32();
                                                        phi_4764_ = f32();
                                                        phi_4765_ = false;
                                                        phi_4766_ = false;
                                                        phi_4767_ = false;
                                                        phi_4768_ = true;
                                                    }
                                                    let _e7346 = phi_4761_;
                                                    let _e7348 = phi_4762_;
                                                    let _e7350 = phi_4763_;
                                                    let _e7352 = phi_4764_;
                                                    let _e7354 = phi_4765_;
                                                    let _e7356 = phi_4766_;
                                                    let _e7358 = phi_4767_;
                                                    let _e7360 = phi_4768_;
                                                    phi_4769_ = _e7346;
                                                    phi_4770_ = _e7348;
                                                    phi_4771_ = _e7350;
                                                    phi_4772_ = _e7352;
                                                    phi_4773_ = false;
                                                    phi_4774_ = _e7354;
                                                    phi_4775_ = _e7356;
                                                    phi_4776_ = _e7358;
                                                    phi_4777_ = _e7360;
                                                } else {
                                                    phi_4769_ = f32();
                                                    phi_4770_ = f32();
                                                    phi_4771_ = f32();
                                                    phi_4772_ = f32();
                                                    phi_4773_ = true;
                                                    phi_4774_ = false;
                                                    phi_4775_ = false;
                                                    phi_4776_ = false;
                                                    phi_4777_ = false;
                                                }
                                                let _e7362 = phi_4769_;
                                                let _e7364 = phi_4770_;
                                                let _e7366 = phi_4771_;
                                                let _e7368 = phi_4772_;
                                                let _e7370 = phi_4773_;
                                                let _e7372 = phi_4774_;
                                                let _e7374 = phi_4775_;
                                                let _e7376 = phi_4776_;
                                                let _e7378 = phi_4777_;
                                                phi_4778_ = _e7362;
                                                phi_4779_ = _e7364;
                                                phi_4780_ = _e7366;
                                                phi_4781_ = _e7368;
                                                phi_4782_ = _e7370;
                                                phi_4783_ = _e7372;
                                                phi_4784_ = _e7374;
                                                phi_4785_ = _e7376;
                                                phi_4786_ = _e7378;
                                            } else {
                                                phi_4778_ = f32();
                                                phi_4779_ = f32();
                                                phi_4780_ = f32();
                                                phi_4781_ = f32();
                                                phi_4782_ = true;
                                                phi_4783_ = false;
                                                phi_4784_ = false;
                                                phi_4785_ = false;
                                                phi_4786_ = false;
                                            }
                                            let _e7380 = phi_4778_;
                                            let _e7382 = phi_4779_;
                                            let _e7384 = phi_4780_;
                                            let _e7386 = phi_4781_;
                                            let _e7388 = phi_4782_;
                                            let _e7390 = phi_4783_;
                                            let _e7392 = phi_4784_;
                                            let _e7394 = phi_4785_;
                                            let _e7396 = phi_4786_;
                                            if _e7388 {
                                                if (_e6220 <= _e6222) {
                                                    let _e7557 = (_e6230 + 1u);
                                                    let _e7558 = (_e7557 > 3u);
                                                    if _e7558 {
                                                        phi_4799_ = false;
                                                    } else {
                                                        phi_4799_ = true;
                                                    }
                                                    let _e7560 = phi_4799_;
                                                    phi_5121_ = _e7557;
                                                    phi_5122_ = f32();
                                                    phi_5123_ = false;
                                                    phi_5124_ = _e7560;
                                                    phi_5125_ = _e7558;
                                                } else {
                                                    let _e7400 = local_16.member[0u];
                                                    let _e7403 = local_16.member_1[0u];
                                                    let _e7406 = local_16.member[0u];
                                                    let _e7412 = local_16.member_2[0u];
                                                    let _e7413 = ((_e7400 + ((_e7403 - _e7406) * _e6226)) - _e7412);
                                                    let _e7416 = local_16.member[1u];
                                                    let _e7419 = local_16.member_1[1u];
                                                    let _e7422 = local_16.member[1u];
                                                    let _e7428 = local_16.member_2[1u];
                                                    let _e7429 = ((_e7416 + ((_e7419 - _e7422) * _e6226)) - _e7428);
                                                    if (_e7413 < _e7429) {
                                                        phi_4872_ = _e7413;
                                                    } else {
                                                        phi_4872_ = _e7429;
                                                    }
                                                    let _e7432 = phi_4872_;
                                                    let _e7435 = local_16.member[2u];
                                                    let _e7438 = local_16.member_1[2u];
                                                    let _e7441 = local_16.member[2u];
                                                    let _e7447 = local_16.member_2[2u];
                                                    let _e7448 = ((_e7435 + ((_e7438 - _e7441) * _e6226)) - _e7447);
                                                    let _e7451 = local_16.member[3u];
                                                    let _e7454 = local_16.member_1[3u];
                                                    let _e7457 = local_16.member[3u];
                                                    let _e7463 = local_16.member_2[3u];
                                                    let _e7464 = ((_e7451 + ((_e7454 - _e7457) * _e6226)) - _e7463);
                                                    if (_e7448 < _e7464) {
                                                        phi_4945_ = _e7448;
                                                    } else {
                                                        phi_4945_ = _e7464;
                                                    }
                                                    let _e7467 = phi_4945_;
                                                    if (_e7432 < _e7467) {
                                                        phi_4950_ = _e7432;
                                                    } else {
                                                        phi_4950_ = _e7467;
                                                    }
                                                    let _e7470 = phi_4950_;
                                                    let _e7473 = local_17.member[0u];
                                                    let _e7476 = local_17.member_1[0u];
                                                    let _e7479 = local_17.member[0u];
                                                    let _e7485 = local_17.member_2[0u];
                                                    let _e7486 = ((_e7473 + ((_e7476 - _e7479) * _e6220)) - _e7485);
                                                    let _e7489 = local_17.member[1u];
                                                    let _e7492 = local_17.member_1[1u];
                                                    let _e7495 = local_17.member[1u];
                                                    let _e7501 = local_17.member_2[1u];
                                                    let _e7502 = ((_e7489 + ((_e7492 - _e7495) * _e6220)) - _e7501);
                                                    if (_e7486 < _e7502) {
                                                        phi_5023_ = _e7486;
                                                    } else {
                                                        phi_5023_ = _e7502;
                                                    }
                                                    let _e7505 = phi_5023_;
                                                    let _e7508 = local_17.member[2u];
                                                    let _e7511 = local_17.member_1[2u];
                                                    let _e7514 = local_17.member[2u];
                                                    let _e7520 = local_17.member_2[2u];
                                                    let _e7521 = ((_e7508 + ((_e7511 - _e7514) * _e6220)) - _e7520);
                                                    let _e7524 = local_17.member[3u];
                                                    let _e7527 = local_17.member_1[3u];
                                                    let _e7530 = local_17.member[3u];
                                                    let _e7536 = local_17.member_2[3u];
                                                    let _e7537 = ((_e7524 + ((_e7527 - _e7530) * _e6220)) - _e7536);
                                                    if (_e7521 < _e7537) {
                                                        phi_5096_ = _e7521;
                                                    } else {
                                                        phi_5096_ = _e7537;
                                                    }
                                                    let _e7540 = phi_5096_;
                                                    if (_e7505 < _e7540) {
                                                        phi_5101_ = _e7505;
                                                    } else {
                                                        phi_5101_ = _e7540;
                                                    }
                                                    let _e7543 = phi_5101_;
                                                    if (_e7543 > 0f) {
                                                        phi_5119_ = 0.5f;
                                                    } else {
                                                        let _e7547 = (0.95f * (_e7470 / (_e7470 - _e7543)));
                                                        if (_e7547 > 0.0625f) {
                                                            if (_e7547 < 0.9f) {
                                                                phi_5117_ = _e7547;
                                                            } else {
                                                                phi_5117_ = 0.9f;
                                                            }
                                                            let _e7551 = phi_5117_;
                                                            phi_5118_ = _e7551;
                                                        } else {
                                                            phi_5118_ = 0.0625f;
                                                        }
                                                        let _e7553 = phi_5118_;
                                                        phi_5119_ = _e7553;
                                                    }
                                                    let _e7555 = phi_5119_;
                                                    phi_5121_ = u32();
                                                    phi_5122_ = (_e6542 * _e7555);
                                                    phi_5123_ = true;
                                                    phi_5124_ = false;
                                                    phi_5125_ = false;
                                                }
                                                let _e7562 = phi_5121_;
                                                let _e7564 = phi_5122_;
                                                let _e7566 = phi_5123_;
                                                let _e7568 = phi_5124_;
                                                let _e7570 = phi_5125_;
                                                phi_5126_ = _e7562;
                                                phi_5127_ = _e6222;
                                                phi_5128_ = _e7564;
                                                phi_5129_ = _e6224;
                                                phi_5130_ = _e6226;
                                                phi_5131_ = _e6228;
                                                phi_5132_ = _e6230;
                                                phi_5133_ = _e7566;
                                                phi_5134_ = _e7568;
                                                phi_5135_ = _e7570;
                                                phi_5136_ = false;
                                                phi_5137_ = false;
                                                phi_5138_ = false;
                                            } else {
                                                phi_5126_ = u32();
                                                phi_5127_ = _e7380;
                                                phi_5128_ = _e7382;
                                                phi_5129_ = _e7384;
                                                phi_5130_ = _e6220;
                                                phi_5131_ = true;
                                                phi_5132_ = 0u;
                                                phi_5133_ = _e7390;
                                                phi_5134_ = false;
                                                phi_5135_ = false;
                                                phi_5136_ = _e7392;
                                                phi_5137_ = _e7394;
                                                phi_5138_ = _e7396;
                                            }
                                            let _e7572 = phi_5126_;
                                            let _e7574 = phi_5127_;
                                            let _e7576 = phi_5128_;
                                            let _e7578 = phi_5129_;
                                            let _e7580 = phi_5130_;
                                            let _e7582 = phi_5131_;
                                            let _e7584 = phi_5132_;
                                            let _e7586 = phi_5133_;
                                            let _e7588 = phi_5134_;
                                            let _e7590 = phi_5135_;
                                            let _e7592 = phi_5136_;
                                            let _e7594 = phi_5137_;
                                            let _e7596 = phi_5138_;
                                            if _e7586 {
                                                let _e7597 = (_e7580 + _e7576);
                                                if (_e7597 > _e7574) {
                                                    phi_5147_ = _e7597;
                                                } else {
                                                    phi_5147_ = _e7574;
                                                }
                                                let _e7600 = phi_5147_;
                                                if (_e7600 < _e325) {
                                                    phi_5152_ = _e7600;
                                                } else {
                                                    phi_5152_ = _e325;
                                                }
                                                let _e7603 = phi_5152_;
                                                if !(_e6228) {
                                                    phi_5161_ = true;
                                                } else {
                                                    phi_5161_ = ((_e7603 - _e7580) > _e6215);
                                                }
                                                let _e7607 = phi_5161_;
                                                if _e7607 {
                                                    phi_5165_ = false;
                                                } else {
                                                    phi_5165_ = true;
                                                }
                                                let _e7609 = phi_5165_;
                                                phi_5166_ = _e7603;
                                                phi_5167_ = _e7574;
                                                phi_5168_ = _e7578;
                                                phi_5169_ = _e7580;
                                                phi_5170_ = _e7582;
                                                phi_5171_ = _e7584;
                                                phi_5172_ = _e7607;
                                                phi_5173_ = _e7609;
                                                phi_5174_ = false;
                                                phi_5175_ = false;
                                                phi_5176_ = false;
                                                phi_5177_ = false;
                                            } else {
                                                phi_5166_ = _e6220;
                                                phi_5167_ = _e6222;
                                                phi_5168_ = _e6224;
                                                phi_5169_ = _e6226;
                                                phi_5170_ = _e6228;
                                                phi_5171_ = _e7572;
                                                phi_5172_ = _e7588;
                                                phi_5173_ = false;
                                                phi_5174_ = _e7590;
                                                phi_5175_ = _e7592;
                                                phi_5176_ = _e7594;
                                                phi_5177_ = _e7596;
                                            }
                                            let _e7611 = phi_5166_;
                                            let _e7613 = phi_5167_;
                                            let _e7615 = phi_5168_;
                                            let _e7617 = phi_5169_;
                                            let _e7619 = phi_5170_;
                                            let _e7621 = phi_5171_;
                                            let _e7623 = phi_5172_;
                                            let _e7625 = phi_5173_;
                                            let _e7627 = phi_5174_;
                                            let _e7629 = phi_5175_;
                                            let _e7631 = phi_5176_;
                                            let _e7633 = phi_5177_;
                                            phi_2999_ = _e7611;
                                            phi_3001_ = _e7613;
                                            phi_3003_ = _e7615;
                                            phi_3005_ = _e7617;
                                            phi_3007_ = _e7619;
                                            phi_3009_ = _e7621;
                                            phi_5178_ = _e7574;
                                            phi_5179_ = _e7386;
                                            phi_5180_ = _e7623;
                                            phi_5181_ = _e7625;
                                            phi_5182_ = _e7627;
                                            phi_5183_ = _e7629;
                                            phi_5184_ = _e7631;
                                            phi_5185_ = false;
                                            phi_5186_ = _e7633;
                                        } else {
                                            phi_2999_ = f32();
                                            phi_3001_ = f32();
                                            phi_3003_ = f32();
                                            phi_3005_ = f32();
                                            phi_3007_ = bool();
                                            phi_3009_ = u32();
                                            phi_5178_ = f32();
                                            phi_5179_ = f32();
                                            phi_5180_ = false;
                                            phi_5181_ = false;
                                            phi_5182_ = false;
                                            phi_5183_ = false;
                                            phi_5184_ = false;
                                            phi_5185_ = true;
                                            phi_5186_ = false;
                                        }
                                        let _e7635 = phi_2999_;
                                        let _e7637 = phi_3001_;
                                        let _e7639 = phi_3003_;
                                        let _e7641 = phi_3005_;
                                        let _e7643 = phi_3007_;
                                        let _e7645 = phi_3009_;
                                        let _e7647 = phi_5178_;
                                        let _e7649 = phi_5179_;
                                        let _e7651 = phi_5180_;
                                        let _e7653 = phi_5181_;
                                        let _e7655 = phi_5182_;
                                        let _e7657 = phi_5183_;
                                        let _e7659 = phi_5184_;
                                        let _e7661 = phi_5185_;
                                        let _e7663 = phi_5186_;
                                        local_42 = _e7653;
                                        local_78 = _e7655;
                                        local_79 = _e7657;
                                        local_80 = _e7659;
                                        local_81 = _e7661;
                                        local_82 = _e7663;
                                        local_83 = _e7653;
                                        local_84 = _e7649;
                                        local_85 = _e7647;
                                        continue;
                                        continuing {
                                            phi_2995_ = _e6242;
                                            phi_2998_ = _e7635;
                                            phi_3000_ = _e7637;
                                            phi_3002_ = _e7639;
                                            phi_3004_ = _e7641;
                                            phi_3006_ = _e7643;
                                            phi_3008_ = _e7645;
                                            break if !(_e7651);
                                        }
                                    }
                                    let _e7666 = local_42;
                                    if _e7666 {
                                        phi_5190_ = false;
                                        phi_5191_ = false;
                                        phi_5192_ = false;
                                        phi_5193_ = false;
                                        phi_5194_ = false;
                                    } else {
                                        let _e11100 = local_78;
                                        phi_5190_ = _e11100;
                                        let _e11103 = local_79;
                                        phi_5191_ = _e11103;
                                        let _e11106 = local_80;
                                        phi_5192_ = _e11106;
                                        let _e11109 = local_81;
                                        phi_5193_ = _e11109;
                                        let _e11112 = local_82;
                                        phi_5194_ = _e11112;
                                    }
                                    let _e7668 = phi_5190_;
                                    let _e7670 = phi_5191_;
                                    let _e7672 = phi_5192_;
                                    let _e7674 = phi_5193_;
                                    let _e7676 = phi_5194_;
                                    if _e7668 {
                                        let _e7678 = local_43;
                                        phi_5199_ = type_28(1u, _e7678);
                                        phi_5200_ = false;
                                        phi_5201_ = false;
                                        phi_5202_ = false;
                                        phi_5203_ = false;
                                        phi_5204_ = false;
                                    } else {
                                        phi_5199_ = type_28();
                                        phi_5200_ = _e7670;
                                        phi_5201_ = _e7672;
                                        let _e11119 = local_83;
                                        phi_5202_ = _e11119;
                                        phi_5203_ = _e7674;
                                        phi_5204_ = _e7676;
                                    }
                                    let _e7681 = phi_5199_;
                                    let _e7683 = phi_5200_;
                                    let _e7685 = phi_5201_;
                                    let _e7687 = phi_5202_;
                                    let _e7689 = phi_5203_;
                                    let _e7691 = phi_5204_;
                                    if _e7683 {
                                        phi_5209_ = type_28(0u, type_28().member_1);
                                        phi_5210_ = false;
                                        phi_5211_ = false;
                                        phi_5212_ = false;
                                        phi_5213_ = false;
                                        phi_5214_ = true;
                                    } else {
                                        phi_5209_ = _e7681;
                                        phi_5210_ = _e7685;
                                        phi_5211_ = _e7687;
                                        phi_5212_ = _e7689;
                                        phi_5213_ = _e7691;
                                        phi_5214_ = _e7668;
                                    }
                                    let _e7695 = phi_5209_;
                                    let _e7697 = phi_5210_;
                                    let _e7699 = phi_5211_;
                                    let _e7701 = phi_5212_;
                                    let _e7703 = phi_5213_;
                                    let _e7705 = phi_5214_;
                                    if _e7697 {
                                        let _e11130 = local_84;
                                        phi_5218_ = _e11130;
                                        phi_5219_ = true;
                                        phi_5220_ = false;
                                        phi_5221_ = false;
                                        phi_5222_ = false;
                                    } else {
                                        let _e11132 = local_85;
                                        phi_5218_ = _e11132;
                                        phi_5219_ = _e7699;
                                        phi_5220_ = _e7701;
                                        phi_5221_ = _e7703;
                                        phi_5222_ = _e7705;
                                    }
                                    let _e7707 = phi_5218_;
                                    let _e7709 = phi_5219_;
                                    let _e7711 = phi_5220_;
                                    let _e7713 = phi_5221_;
                                    let _e7715 = phi_5222_;
                                    if _e7709 {
                                        phi_5226_ = _e7707;
                                        phi_5227_ = true;
                                        phi_5228_ = false;
                                        phi_5229_ = false;
                                    } else {
                                        let _e11139 = local_86;
                                        phi_5226_ = _e11139;
                                        phi_5227_ = _e7711;
                                        phi_5228_ = _e7713;
                                        phi_5229_ = _e7715;
                                    }
                                    let _e7717 = phi_5226_;
                                    let _e7719 = phi_5227_;
                                    let _e7721 = phi_5228_;
                                    let _e7723 = phi_5229_;
                                    if _e7719 {
                                        phi_5234_ = type_28(1u, _e7717);
                                        phi_5235_ = false;
                                        phi_5236_ = false;
                                    } else {
                                        phi_5234_ = type_28();
                                        phi_5235_ = _e7721;
                                        phi_5236_ = _e7723;
                                    }
                                    let _e7726 = phi_5234_;
                                    let _e7728 = phi_5235_;
                                    let _e7730 = phi_5236_;
                                    if _e7728 {
                                        phi_5241_ = type_28(0u, type_28().member_1);
                                        phi_5242_ = true;
                                    } else {
                                        phi_5241_ = _e7695;
                                        phi_5242_ = _e7730;
                                    }
                                    let _e7734 = phi_5241_;
                                    let _e7736 = phi_5242_;
                                    if _e7736 {
                                        phi_5246_ = _e7734;
                                    } else {
                                        phi_5246_ = _e7726;
                                    }
                                    let _e7738 = phi_5246_;
                                    phi_5253_ = _e7738.member_1;
                                    phi_5254_ = (_e7738.member != 0u);
                                } else {
                                    phi_5253_ = _e5956;
                                    phi_5254_ = true;
                                }
                                let _e7743 = phi_5253_;
                                let _e7745 = phi_5254_;
                                if _e7745 {
                                    let _e7746 = (_e7743 > _e323);
                                    if _e7746 {
                                        phi_7419_ = f32();
                                        phi_7420_ = u32();
                                        phi_7421_ = f32();
                                        phi_7422_ = type_40();
                                        phi_7423_ = u32();
                                        phi_7424_ = u32();
                                        phi_7425_ = false;
                                        phi_7426_ = false;
                                        phi_7427_ = false;
                                    } else {
                                        let _e7749 = local_18.member[0u];
                                        let _e7755 = local_18.member[1u];
                                        let _e7771 = local_18.member_1[0u];
                                        let _e7777 = local_18.member_1[1u];
                                        let _e7793 = local_18.member_2[0u];
                                        let _e7799 = local_18.member_2[1u];
                                        let _e7813 = function_2(array<f32, 3>((_e7749[0] + ((_e7755[0] - _e7749[0]) * _e5960)), (_e7749[1] + ((_e7755[1] - _e7749[1]) * _e5960)), (_e7749[2] + ((_e7755[2] - _e7749[2]) * _e5960))), array<f32, 3>((_e7771[0] + ((_e7777[0] - _e7771[0]) * _e5960)), (_e7771[1] + ((_e7777[1] - _e7771[1]) * _e5960)), (_e7771[2] + ((_e7777[2] - _e7771[2]) * _e5960))), array<f32, 3>((_e7793[0] + ((_e7799[0] - _e7793[0]) * _e5960)), (_e7793[1] + ((_e7799[1] - _e7793[1]) * _e5960)), (_e7793[2] + ((_e7799[2] - _e7793[2]) * _e5960))), 0u);
                                        if (_e7813[0] < 0f) {
                                            phi_5366_ = -(_e7813[0]);
                                        } else {
                                            phi_5366_ = _e7813[0];
                                        }
                                        let _e7818 = phi_5366_;
                                        if (_e7813[1] < 0f) {
                                            phi_5373_ = -(_e7813[1]);
                                        } else {
                                            phi_5373_ = _e7813[1];
                                        }
                                        let _e7823 = phi_5373_;
                                        if (_e7813[2] < 0f) {
                                            phi_5381_ = -(_e7813[2]);
                                        } else {
                                            phi_5381_ = _e7813[2];
                                        }
                                        let _e7829 = phi_5381_;
                                        let _e7830 = ((_e7818 + _e7823) + _e7829);
                                        let _e7833 = local_18.member[0u];
                                        let _e7839 = local_18.member_1[0u];
                                        let _e7845 = local_18.member_2[0u];
                                        let _e7857 = local_18.member[1u];
                                        let _e7863 = local_18.member_1[1u];
                                        let _e7869 = local_18.member_2[1u];
                                        let _e7881 = local_18.member[0u];
                                        if (_e7881[0] < 0f) {
                                            phi_5532_ = -(_e7881[0]);
                                        } else {
                                            phi_5532_ = _e7881[0];
                                        }
                                        let _e7888 = phi_5532_;
                                        if (_e7881[1] < 0f) {
                                            phi_5539_ = -(_e7881[1]);
                                        } else {
                                            phi_5539_ = _e7881[1];
                                        }
                                        let _e7892 = phi_5539_;
                                        if (_e7888 > _e7892) {
                                            phi_5544_ = _e7888;
                                        } else {
                                            phi_5544_ = _e7892;
                                        }
                                        let _e7895 = phi_5544_;
                                        if (_e7881[2] < 0f) {
                                            phi_5551_ = -(_e7881[2]);
                                        } else {
                                            phi_5551_ = _e7881[2];
                                        }
                                        let _e7899 = phi_5551_;
                                        if (_e7895 > _e7899) {
                                            phi_5556_ = _e7895;
                                        } else {
                                            phi_5556_ = _e7899;
                                        }
                                        let _e7902 = phi_5556_;
                                        let _e7905 = local_18.member[1u];
                                        if (_e7905[0] < 0f) {
                                            phi_5569_ = -(_e7905[0]);
                                        } else {
                                            phi_5569_ = _e7905[0];
                                        }
                                        let _e7912 = phi_5569_;
                                        if (_e7905[1] < 0f) {
                                            phi_5576_ = -(_e7905[1]);
                                        } else {
                                            phi_5576_ = _e7905[1];
                                        }
                                        let _e7916 = phi_5576_;
                                        if (_e7912 > _e7916) {
                                            phi_5581_ = _e7912;
                                        } else {
                                            phi_5581_ = _e7916;
                                        }
                                        let _e7919 = phi_5581_;
                                        if (_e7905[2] < 0f) {
                                            phi_5588_ = -(_e7905[2]);
                                        } else {
                                            phi_5588_ = _e7905[2];
                                        }
                                        let _e7923 = phi_5588_;
                                        if (_e7919 > _e7923) {
                                            phi_5593_ = _e7919;
                                        } else {
                                            phi_5593_ = _e7923;
                                        }
                                        let _e7926 = phi_5593_;
                                        if (_e7902 > _e7926) {
                                            phi_5598_ = _e7902;
                                        } else {
                                            phi_5598_ = _e7926;
                                        }
                                        let _e7929 = phi_5598_;
                                        let _e7931 = local_18.member_3;
                                        let _e7935 = local_18.member_1[0u];
                                        if (_e7935[0] < 0f) {
                                            phi_5615_ = -(_e7935[0]);
                                        } else {
                                            phi_5615_ = _e7935[0];
                                        }
                                        let _e7942 = phi_5615_;
                                        if (_e7935[1] < 0f) {
                                            phi_5622_ = -(_e7935[1]);
                                        } else {
                                            phi_5622_ = _e7935[1];
                                        }
                                        let _e7946 = phi_5622_;
                                        if (_e7942 > _e7946) {
                                            phi_5627_ = _e7942;
                                        } else {
                                            phi_5627_ = _e7946;
                                        }
                                        let _e7949 = phi_5627_;
                                        if (_e7935[2] < 0f) {
                                            phi_5634_ = -(_e7935[2]);
                                        } else {
                                            phi_5634_ = _e7935[2];
                                        }
                                        let _e7953 = phi_5634_;
                                        if (_e7949 > _e7953) {
                                            phi_5639_ = _e7949;
                                        } else {
                                            phi_5639_ = _e7953;
                                        }
                                        let _e7956 = phi_5639_;
                                        let _e7959 = local_18.member_1[1u];
                                        if (_e7959[0] < 0f) {
                                            phi_5653_ = -(_e7959[0]);
                                        } else {
                                            phi_5653_ = _e7959[0];
                                        }
                                        let _e7966 = phi_5653_;
                                        if (_e7959[1] < 0f) {
                                            phi_5660_ = -(_e7959[1]);
                                        } else {
                                            phi_5660_ = _e7959[1];
                                        }
                                        let _e7970 = phi_5660_;
                                        if (_e7966 > _e7970) {
                                            phi_5665_ = _e7966;
                                        } else {
                                            phi_5665_ = _e7970;
                                        }
                                        let _e7973 = phi_5665_;
                                        if (_e7959[2] < 0f) {
                                            phi_5672_ = -(_e7959[2]);
                                        } else {
                                            phi_5672_ = _e7959[2];
                                        }
                                        let _e7977 = phi_5672_;
                                        if (_e7973 > _e7977) {
                                            phi_5677_ = _e7973;
                                        } else {
                                            phi_5677_ = _e7977;
                                        }
                                        let _e7980 = phi_5677_;
                                        if (_e7956 > _e7980) {
                                            phi_5682_ = _e7956;
                                        } else {
                                            phi_5682_ = _e7980;
                                        }
                                        let _e7983 = phi_5682_;
                                        let _e7985 = local_18.member_3;
                                        let _e7989 = local_18.member_2[0u];
                                        if (_e7989[0] < 0f) {
                                            phi_5699_ = -(_e7989[0]);
                                        } else {
                                            phi_5699_ = _e7989[0];
                                        }
                                        let _e7996 = phi_5699_;
                                        if (_e7989[1] < 0f) {
                                            phi_5706_ = -(_e7989[1]);
                                        } else {
                                            phi_5706_ = _e7989[1];
                                        }
                                        let _e8000 = phi_5706_;
                                        if (_e7996 > _e8000) {
                                            phi_5711_ = _e7996;
                                        } else {
                                            phi_5711_ = _e8000;
                                        }
                                        let _e8003 = phi_5711_;
                                        if (_e7989[2] < 0f) {
                                            phi_5718_ = -(_e7989[2]);
                                        } else {
                                            phi_5718_ = _e7989[2];
                                        }
                                        let _e8007 = phi_5718_;
                                        if (_e8003 > _e8007) {
                                            phi_5723_ = _e8003;
                                        } else {
                                            phi_5723_ = _e8007;
                                        }
                                        let _e8010 = phi_5723_;
                                        let _e8013 = local_18.member_2[1u];
                                        if (_e8013[0] < 0f) {
                                            phi_5737_ = -(_e8013[0]);
                                        } else {
                                            phi_5737_ = _e8013[0];
                                        }
                                        let _e8020 = phi_5737_;
                                        if (_e8013[1] < 0f) {
                                            phi_5744_ = -(_e8013[1]);
                                        } else {
                                            phi_5744_ = _e8013[1];
                                        }
                                        let _e8024 = phi_5744_;
                                        if (_e8020 > _e8024) {
                                            phi_5749_ = _e8020;
                                        } else {
                                            phi_5749_ = _e8024;
                                        }
                                        let _e8027 = phi_5749_;
                                        if (_e8013[2] < 0f) {
                                            phi_5756_ = -(_e8013[2]);
                                        } else {
                                            phi_5756_ = _e8013[2];
                                        }
                                        let _e8031 = phi_5756_;
                                        if (_e8027 > _e8031) {
                                            phi_5761_ = _e8027;
                                        } else {
                                            phi_5761_ = _e8031;
                                        }
                                        let _e8034 = phi_5761_;
                                        if (_e8010 > _e8034) {
                                            phi_5766_ = _e8010;
                                        } else {
                                            phi_5766_ = _e8034;
                                        }
                                        let _e8037 = phi_5766_;
                                        let _e8039 = local_18.member_3;
                                        let _e8046 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7833, array<f32, 3>((_e7833[0] - _e7839[0]), (_e7833[1] - _e7839[1]), (_e7833[2] - _e7839[2])), array<f32, 3>((_e7833[0] - _e7845[0]), (_e7833[1] - _e7845[1]), (_e7833[2] - _e7845[2])), _e7833), array<array<f32, 3>, 4>(_e7857, array<f32, 3>((_e7857[0] - _e7863[0]), (_e7857[1] - _e7863[1]), (_e7857[2] - _e7863[2])), array<f32, 3>((_e7857[0] - _e7869[0]), (_e7857[1] - _e7869[1]), (_e7857[2] - _e7869[2])), _e7857)), ((((((_e7929 + _e7931) + (_e7983 + _e7985)) + (_e8037 + _e8039)) * (0.000000059604645f * 16f)) + (_e8046 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e527.member_1);
                                        let _e8060 = local_14.member_1;
                                        if (_e7830 > _e8060) {
                                            if ((bitcast<u32>(_e7830) & 2139095040u) != 2139095040u) {
                                                let _e8065 = (1f / _e7830);
                                                let _e8067 = (_e7813[0] * _e8065);
                                                let _e8069 = (_e7813[1] * _e8065);
                                                let _e8071 = (_e7813[2] * _e8065);
                                                let _e8076 = (((_e8067 * _e8067) + (_e8069 * _e8069)) + (_e8071 * _e8071));
                                                if (_e8076 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8076 > 0f) {
                                                        phi_5867_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5867_ = 0f;
                                                    }
                                                    let _e8129 = phi_5867_;
                                                    phi_5931_ = _e8129;
                                                } else {
                                                    phi_5874_ = type_14(0i, 5i);
                                                    phi_5877_ = bitcast<f32>(((bitcast<u32>(_e8076) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8084 = phi_5874_;
                                                        let _e8086 = phi_5877_;
                                                        local_44 = _e8086;
                                                        if (_e8084.member < _e8084.member_1) {
                                                            let _e8093 = (_e8084.member + 1i);
                                                            if ((false == (_e8093 > _e8084.member)) != false) {
                                                                phi_5898_ = true;
                                                            } else {
                                                                phi_5898_ = false;
                                                            }
                                                            let _e8098 = phi_5898_;
                                                            if _e8098 {
                                                                phi_5904_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5904_ = type_15(1u, _e8093);
                                                            }
                                                            let _e8103 = phi_5904_;
                                                            phi_5875_ = type_14(_e8103.member_1, _e8084.member_1);
                                                            phi_5918_ = type_15(1u, _e8084.member);
                                                        } else {
                                                            phi_5875_ = _e8084;
                                                            phi_5918_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8109 = phi_5875_;
                                                        let _e8111 = phi_5918_;
                                                        let _e8114 = (bitcast<i32>(_e8111.member) != 0i);
                                                        if _e8114 {
                                                            phi_5878_ = (0.5f * (_e8086 + (_e8076 / _e8086)));
                                                        } else {
                                                            phi_5878_ = f32();
                                                        }
                                                        let _e8119 = phi_5878_;
                                                        continue;
                                                        continuing {
                                                            phi_5874_ = _e8109;
                                                            phi_5877_ = _e8119;
                                                            break if !(_e8114);
                                                        }
                                                    }
                                                    let _e8124 = local_44;
                                                    phi_5931_ = (_e8124 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8131 = phi_5931_;
                                                let _e8132 = (0.000000059604645f * 12f);
                                                let _e8134 = local_14.member_1;
                                                let _e8137 = local_14.member_2;
                                                let _e8141 = ((_e8134 * 1.01f) + ((_e8137 * _e8131) * (1f + _e8132)));
                                                let _e8145 = local_14.member[0u][0u];
                                                let _e8153 = (((_e8067 * _e8145[0]) + (_e8069 * _e8145[1])) + (_e8071 * _e8145[2]));
                                                let _e8157 = local_14.member[0u][1u];
                                                let _e8165 = (((_e8067 * _e8157[0]) + (_e8069 * _e8157[1])) + (_e8071 * _e8157[2]));
                                                let _e8169 = local_14.member[0u][2u];
                                                let _e8177 = (((_e8067 * _e8169[0]) + (_e8069 * _e8169[1])) + (_e8071 * _e8169[2]));
                                                let _e8181 = local_14.member[0u][3u];
                                                let _e8189 = (((_e8067 * _e8181[0]) + (_e8069 * _e8181[1])) + (_e8071 * _e8181[2]));
                                                let _e8193 = local_14.member[1u][0u];
                                                let _e8201 = (((_e8067 * _e8193[0]) + (_e8069 * _e8193[1])) + (_e8071 * _e8193[2]));
                                                let _e8205 = local_14.member[1u][1u];
                                                let _e8213 = (((_e8067 * _e8205[0]) + (_e8069 * _e8205[1])) + (_e8071 * _e8205[2]));
                                                let _e8217 = local_14.member[1u][2u];
                                                let _e8225 = (((_e8067 * _e8217[0]) + (_e8069 * _e8217[1])) + (_e8071 * _e8217[2]));
                                                let _e8229 = local_14.member[1u][3u];
                                                let _e8237 = (((_e8067 * _e8229[0]) + (_e8069 * _e8229[1])) + (_e8071 * _e8229[2]));
                                                if (_e8153 < 0f) {
                                                    phi_6065_ = -(_e8153);
                                                } else {
                                                    phi_6065_ = _e8153;
                                                }
                                                let _e8241 = phi_6065_;
                                                if (_e8201 < 0f) {
                                                    phi_6071_ = -(_e8201);
                                                } else {
                                                    phi_6071_ = _e8201;
                                                }
                                                let _e8245 = phi_6071_;
                                                if (_e8165 < 0f) {
                                                    phi_6080_ = -(_e8165);
                                                } else {
                                                    phi_6080_ = _e8165;
                                                }
                                                let _e8252 = phi_6080_;
                                                if (_e8213 < 0f) {
                                                    phi_6086_ = -(_e8213);
                                                } else {
                                                    phi_6086_ = _e8213;
                                                }
                                                let _e8256 = phi_6086_;
                                                if (_e8177 < 0f) {
                                                    phi_6095_ = -(_e8177);
                                                } else {
                                                    phi_6095_ = _e8177;
                                                }
                                                let _e8263 = phi_6095_;
                                                if (_e8225 < 0f) {
                                                    phi_6101_ = -(_e8225);
                                                } else {
                                                    phi_6101_ = _e8225;
                                                }
                                                let _e8267 = phi_6101_;
                                                if (_e8189 < 0f) {
                                                    phi_6110_ = -(_e8189);
                                                } else {
                                                    phi_6110_ = _e8189;
                                                }
                                                let _e8274 = phi_6110_;
                                                if (_e8237 < 0f) {
                                                    phi_6116_ = -(_e8237);
                                                } else {
                                                    phi_6116_ = _e8237;
                                                }
                                                let _e8278 = phi_6116_;
                                                local_15 = type_32(array<f32, 4>(_e8153, _e8165, _e8177, _e8189), array<f32, 4>(_e8201, _e8213, _e8225, _e8237), array<f32, 4>((_e8141 + ((_e8241 + _e8245) * _e8132)), (_e8141 + ((_e8252 + _e8256) * _e8132)), (_e8141 + ((_e8263 + _e8267) * _e8132)), (_e8141 + ((_e8274 + _e8278) * _e8132))));
                                                let _e8290 = (((_e8067 * _e8067) + (_e8069 * _e8069)) + (_e8071 * _e8071));
                                                if (_e8290 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8290 > 0f) {
                                                        phi_6159_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6159_ = 0f;
                                                    }
                                                    let _e8343 = phi_6159_;
                                                    phi_6223_ = _e8343;
                                                } else {
                                                    phi_6166_ = type_14(0i, 5i);
                                                    phi_6169_ = bitcast<f32>(((bitcast<u32>(_e8290) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8298 = phi_6166_;
                                                        let _e8300 = phi_6169_;
                                                        local_45 = _e8300;
                                                        if (_e8298.member < _e8298.member_1) {
                                                            let _e8307 = (_e8298.member + 1i);
                                                            if ((false == (_e8307 > _e8298.member)) != false) {
                                                                phi_6190_ = true;
                                                            } else {
                                                                phi_6190_ = false;
                                                            }
                                                            let _e8312 = phi_6190_;
                                                            if _e8312 {
                                                                phi_6196_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6196_ = type_15(1u, _e8307);
                                                            }
                                                            let _e8317 = phi_6196_;
                                                            phi_6167_ = type_14(_e8317.member_1, _e8298.member_1);
                                                            phi_6210_ = type_15(1u, _e8298.member);
                                                        } else {
                                                            phi_6167_ = _e8298;
                                                            phi_6210_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8323 = phi_6167_;
                                                        let _e8325 = phi_6210_;
                                                        let _e8328 = (bitcast<i32>(_e8325.member) != 0i);
                                                        if _e8328 {
                                                            phi_6170_ = (0.5f * (_e8300 + (_e8290 / _e8300)));
                                                        } else {
                                                            phi_6170_ = f32();
                                                        }
                                                        let _e8333 = phi_6170_;
                                                        continue;
                                                        continuing {
                                                            phi_6166_ = _e8323;
                                                            phi_6169_ = _e8333;
                                                            break if !(_e8328);
                                                        }
                                                    }
                                                    let _e8338 = local_45;
                                                    phi_6223_ = (_e8338 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8345 = phi_6223_;
                                                let _e8356 = (((_e7813[0] * _e7813[0]) + (_e7813[1] * _e7813[1])) + (_e7813[2] * _e7813[2]));
                                                if (_e8356 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8356 > 0f) {
                                                        phi_6248_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_6248_ = 0f;
                                                    }
                                                    let _e8409 = phi_6248_;
                                                    phi_6312_ = _e8409;
                                                } else {
                                                    phi_6255_ = type_14(0i, 5i);
                                                    phi_6258_ = bitcast<f32>(((bitcast<u32>(_e8356) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8364 = phi_6255_;
                                                        let _e8366 = phi_6258_;
                                                        local_46 = _e8366;
                                                        if (_e8364.member < _e8364.member_1) {
                                                            let _e8373 = (_e8364.member + 1i);
                                                            if ((false == (_e8373 > _e8364.member)) != false) {
                                                                phi_6279_ = true;
                                                            } else {
                                                                phi_6279_ = false;
                                                            }
                                                            let _e8378 = phi_6279_;
                                                            if _e8378 {
                                                                phi_6285_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_6285_ = type_15(1u, _e8373);
                                                            }
                                                            let _e8383 = phi_6285_;
                                                            phi_6256_ = type_14(_e8383.member_1, _e8364.member_1);
                                                            phi_6299_ = type_15(1u, _e8364.member);
                                                        } else {
                                                            phi_6256_ = _e8364;
                                                            phi_6299_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8389 = phi_6256_;
                                                        let _e8391 = phi_6299_;
                                                        let _e8394 = (bitcast<i32>(_e8391.member) != 0i);
                                                        if _e8394 {
                                                            phi_6259_ = (0.5f * (_e8366 + (_e8356 / _e8366)));
                                                        } else {
                                                            phi_6259_ = f32();
                                                        }
                                                        let _e8399 = phi_6259_;
                                                        continue;
                                                        continuing {
                                                            phi_6255_ = _e8389;
                                                            phi_6258_ = _e8399;
                                                            break if !(_e8394);
                                                        }
                                                    }
                                                    let _e8404 = local_46;
                                                    phi_6312_ = (_e8404 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8411 = phi_6312_;
                                                let _e8417 = local_18.member[0u];
                                                if (_e8417[0] < 0f) {
                                                    phi_6328_ = -(_e8417[0]);
                                                } else {
                                                    phi_6328_ = _e8417[0];
                                                }
                                                let _e8424 = phi_6328_;
                                                if (_e8417[1] < 0f) {
                                                    phi_6335_ = -(_e8417[1]);
                                                } else {
                                                    phi_6335_ = _e8417[1];
                                                }
                                                let _e8428 = phi_6335_;
                                                if (_e8424 > _e8428) {
                                                    phi_6340_ = _e8424;
                                                } else {
                                                    phi_6340_ = _e8428;
                                                }
                                                let _e8431 = phi_6340_;
                                                if (_e8417[2] < 0f) {
                                                    phi_6347_ = -(_e8417[2]);
                                                } else {
                                                    phi_6347_ = _e8417[2];
                                                }
                                                let _e8435 = phi_6347_;
                                                if (_e8431 > _e8435) {
                                                    phi_6352_ = _e8431;
                                                } else {
                                                    phi_6352_ = _e8435;
                                                }
                                                let _e8438 = phi_6352_;
                                                let _e8441 = local_18.member[1u];
                                                if (_e8441[0] < 0f) {
                                                    phi_6365_ = -(_e8441[0]);
                                                } else {
                                                    phi_6365_ = _e8441[0];
                                                }
                                                let _e8448 = phi_6365_;
                                                if (_e8441[1] < 0f) {
                                                    phi_6372_ = -(_e8441[1]);
                                                } else {
                                                    phi_6372_ = _e8441[1];
                                                }
                                                let _e8452 = phi_6372_;
                                                if (_e8448 > _e8452) {
                                                    phi_6377_ = _e8448;
                                                } else {
                                                    phi_6377_ = _e8452;
                                                }
                                                let _e8455 = phi_6377_;
                                                if (_e8441[2] < 0f) {
                                                    phi_6384_ = -(_e8441[2]);
                                                } else {
                                                    phi_6384_ = _e8441[2];
                                                }
                                                let _e8459 = phi_6384_;
                                                if (_e8455 > _e8459) {
                                                    phi_6389_ = _e8455;
                                                } else {
                                                    phi_6389_ = _e8459;
                                                }
                                                let _e8462 = phi_6389_;
                                                if (_e8438 > _e8462) {
                                                    phi_6394_ = _e8438;
                                                } else {
                                                    phi_6394_ = _e8462;
                                                }
                                                let _e8465 = phi_6394_;
                                                let _e8467 = local_18.member_3;
                                                let _e8471 = local_18.member_1[0u];
                                                if (_e8471[0] < 0f) {
                                                    phi_6411_ = -(_e8471[0]);
                                                } else {
                                                    phi_6411_ = _e8471[0];
                                                }
                                                let _e8478 = phi_6411_;
                                                if (_e8471[1] < 0f) {
                                                    phi_6418_ = -(_e8471[1]);
                                                } else {
                                                    phi_6418_ = _e8471[1];
                                                }
                                                let _e8482 = phi_6418_;
                                                if (_e8478 > _e8482) {
                                                    phi_6423_ = _e8478;
                                                } else {
                                                    phi_6423_ = _e8482;
                                                }
                                                let _e8485 = phi_6423_;
                                                if (_e8471[2] < 0f) {
                                                    phi_6430_ = -(_e8471[2]);
                                                } else {
                                                    phi_6430_ = _e8471[2];
                                                }
                                                let _e8489 = phi_6430_;
                                                if (_e8485 > _e8489) {
                                                    phi_6435_ = _e8485;
                                                } else {
                                                    phi_6435_ = _e8489;
                                                }
                                                let _e8492 = phi_6435_;
                                                let _e8495 = local_18.member_1[1u];
                                                if (_e8495[0] < 0f) {
                                                    phi_6449_ = -(_e8495[0]);
                                                } else {
                                                    phi_6449_ = _e8495[0];
                                                }
                                                let _e8502 = phi_6449_;
                                                if (_e8495[1] < 0f) {
                                                    phi_6456_ = -(_e8495[1]);
                                                } else {
                                                    phi_6456_ = _e8495[1];
                                                }
                                                let _e8506 = phi_6456_;
                                                if (_e8502 > _e8506) {
                                                    phi_6461_ = _e8502;
                                                } else {
                                                    phi_6461_ = _e8506;
                                                }
                                                let _e8509 = phi_6461_;
                                                if (_e8495[2] < 0f) {
                                                    phi_6468_ = -(_e8495[2]);
                                                } else {
                                                    phi_6468_ = _e8495[2];
                                                }
                                                let _e8513 = phi_6468_;
                                                if (_e8509 > _e8513) {
                                                    phi_6473_ = _e8509;
                                                } else {
                                                    phi_6473_ = _e8513;
                                                }
                                                let _e8516 = phi_6473_;
                                                if (_e8492 > _e8516) {
                                                    phi_6478_ = _e8492;
                                                } else {
                                                    phi_6478_ = _e8516;
                                                }
                                                let _e8519 = phi_6478_;
                                                let _e8521 = local_18.member_3;
                                                let _e8525 = local_18.member_2[0u];
                                                if (_e8525[0] < 0f) {
                                                    phi_6495_ = -(_e8525[0]);
                                                } else {
                                                    phi_6495_ = _e8525[0];
                                                }
                                                let _e8532 = phi_6495_;
                                                if (_e8525[1] < 0f) {
                                                    phi_6502_ = -(_e8525[1]);
                                                } else {
                                                    phi_6502_ = _e8525[1];
                                                }
                                                let _e8536 = phi_6502_;
                                                if (_e8532 > _e8536) {
                                                    phi_6507_ = _e8532;
                                                } else {
                                                    phi_6507_ = _e8536;
                                                }
                                                let _e8539 = phi_6507_;
                                                if (_e8525[2] < 0f) {
                                                    phi_6514_ = -(_e8525[2]);
                                                } else {
                                                    phi_6514_ = _e8525[2];
                                                }
                                                let _e8543 = phi_6514_;
                                                if (_e8539 > _e8543) {
                                                    phi_6519_ = _e8539;
                                                } else {
                                                    phi_6519_ = _e8543;
                                                }
                                                let _e8546 = phi_6519_;
                                                let _e8549 = local_18.member_2[1u];
                                                if (_e8549[0] < 0f) {
                                                    phi_6533_ = -(_e8549[0]);
                                                } else {
                                                    phi_6533_ = _e8549[0];
                                                }
                                                let _e8556 = phi_6533_;
                                                if (_e8549[1] < 0f) {
                                                    phi_6540_ = -(_e8549[1]);
                                                } else {
                                                    phi_6540_ = _e8549[1];
                                                }
                                                let _e8560 = phi_6540_;
                                                if (_e8556 > _e8560) {
                                                    phi_6545_ = _e8556;
                                                } else {
                                                    phi_6545_ = _e8560;
                                                }
                                                let _e8563 = phi_6545_;
                                                if (_e8549[2] < 0f) {
                                                    phi_6552_ = -(_e8549[2]);
                                                } else {
                                                    phi_6552_ = _e8549[2];
                                                }
                                                let _e8567 = phi_6552_;
                                                if (_e8563 > _e8567) {
                                                    phi_6557_ = _e8563;
                                                } else {
                                                    phi_6557_ = _e8567;
                                                }
                                                let _e8570 = phi_6557_;
                                                if (_e8546 > _e8570) {
                                                    phi_6562_ = _e8546;
                                                } else {
                                                    phi_6562_ = _e8570;
                                                }
                                                let _e8573 = phi_6562_;
                                                let _e8575 = local_18.member_3;
                                                let _e8582 = local_18.member_3;
                                                let _e8592 = ((((_e8411 * (1f + (0.000000059604645f * 8f))) + (((((((_e8465 + _e8467) + (_e8519 + _e8521)) + (_e8573 + _e8575)) * (0.000000059604645f * 16f)) + (_e8582 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8345) * (1f + (0.000000059604645f * 64f)));
                                                let _e8595 = local_15.member[0u];
                                                let _e8598 = local_15.member_1[0u];
                                                if (_e8595 < 0f) {
                                                    phi_6603_ = -(_e8595);
                                                } else {
                                                    phi_6603_ = _e8595;
                                                }
                                                let _e8603 = phi_6603_;
                                                if (_e8598 < 0f) {
                                                    phi_6609_ = -(_e8598);
                                                } else {
                                                    phi_6609_ = _e8598;
                                                }
                                                let _e8607 = phi_6609_;
                                                phi_6620_ = type_12(1u, 4u);
                                                phi_6623_ = ((_e8595 + ((_e8598 - _e8595) * _e5960)) - ((_e8060 * 1.01f) + ((_e8603 + _e8607) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8617 = phi_6620_;
                                                    let _e8619 = phi_6623_;
                                                    local_47 = _e8619;
                                                    local_48 = _e8619;
                                                    if (_e8617.member < _e8617.member_1) {
                                                        phi_6621_ = type_12((_e8617.member + 1u), _e8617.member_1);
                                                        phi_6646_ = type_12(1u, _e8617.member);
                                                    } else {
                                                        phi_6621_ = _e8617;
                                                        phi_6646_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8631 = phi_6621_;
                                                    let _e8633 = phi_6646_;
                                                    let _e8637 = (bitcast<i32>(_e8633.member) != 0i);
                                                    if _e8637 {
                                                        let _e8640 = local_15.member[_e8633.member_1];
                                                        let _e8643 = local_15.member_1[_e8633.member_1];
                                                        if (_e8640 < 0f) {
                                                            phi_6675_ = -(_e8640);
                                                        } else {
                                                            phi_6675_ = _e8640;
                                                        }
                                                        let _e8648 = phi_6675_;
                                                        if (_e8643 < 0f) {
                                                            phi_6681_ = -(_e8643);
                                                        } else {
                                                            phi_6681_ = _e8643;
                                                        }
                                                        let _e8652 = phi_6681_;
                                                        let _e8660 = ((_e8640 + ((_e8643 - _e8640) * _e5960)) - ((_e8060 * 1.01f) + ((_e8648 + _e8652) * (0.000000059604645f * 12f))));
                                                        if (_e8619 < _e8660) {
                                                            phi_6694_ = _e8619;
                                                        } else {
                                                            phi_6694_ = _e8660;
                                                        }
                                                        let _e8663 = phi_6694_;
                                                        phi_6624_ = _e8663;
                                                    } else {
                                                        phi_6624_ = f32();
                                                    }
                                                    let _e8665 = phi_6624_;
                                                    continue;
                                                    continuing {
                                                        phi_6620_ = _e8631;
                                                        phi_6623_ = _e8665;
                                                        break if !(_e8637);
                                                    }
                                                }
                                                let _e8668 = local_47;
                                                if (_e8668 > 0f) {
                                                    let _e8672 = local_48;
                                                    let _e8675 = (((_e8592 - _e8672) / _e8592) * 2.02f);
                                                    if (_e8675 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8675 > 0f) {
                                                            phi_6715_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6715_ = 0f;
                                                        }
                                                        let _e8728 = phi_6715_;
                                                        phi_6779_ = _e8728;
                                                    } else {
                                                        phi_6722_ = type_14(0i, 5i);
                                                        phi_6725_ = bitcast<f32>(((bitcast<u32>(_e8675) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8683 = phi_6722_;
                                                            let _e8685 = phi_6725_;
                                                            local_49 = _e8685;
                                                            if (_e8683.member < _e8683.member_1) {
                                                                let _e8692 = (_e8683.member + 1i);
                                                                if ((false == (_e8692 > _e8683.member)) != false) {
                                                                    phi_6746_ = true;
                                                                } else {
                                                                    phi_6746_ = false;
                                                                }
                                                                let _e8697 = phi_6746_;
                                                                if _e8697 {
                                                                    phi_6752_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6752_ = type_15(1u, _e8692);
                                                                }
                                                                let _e8702 = phi_6752_;
                                                                phi_6723_ = type_14(_e8702.member_1, _e8683.member_1);
                                                                phi_6766_ = type_15(1u, _e8683.member);
                                                            } else {
                                                                phi_6723_ = _e8683;
                                                                phi_6766_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8708 = phi_6723_;
                                                            let _e8710 = phi_6766_;
                                                            let _e8713 = (bitcast<i32>(_e8710.member) != 0i);
                                                            if _e8713 {
                                                                phi_6726_ = (0.5f * (_e8685 + (_e8675 / _e8685)));
                                                            } else {
                                                                phi_6726_ = f32();
                                                            }
                                                            let _e8718 = phi_6726_;
                                                            continue;
                                                            continuing {
                                                                phi_6722_ = _e8708;
                                                                phi_6725_ = _e8718;
                                                                break if !(_e8713);
                                                            }
                                                        }
                                                        let _e8723 = local_49;
                                                        phi_6779_ = (_e8723 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8730 = phi_6779_;
                                                    let _e8732 = ((_e8730 * _e8345) * 1.01f);
                                                    phi_6784_ = type_12(0u, 4u);
                                                    phi_6787_ = 2f;
                                                    phi_6789_ = true;
                                                    phi_6791_ = true;
                                                    loop {
                                                        let _e8734 = phi_6784_;
                                                        let _e8736 = phi_6787_;
                                                        let _e8738 = phi_6789_;
                                                        let _e8740 = phi_6791_;
                                                        local_50 = _e8736;
                                                        local_87 = _e8736;
                                                        local_51 = _e8738;
                                                        local_52 = _e8740;
                                                        local_88 = _e8740;
                                                        local_53 = _e8740;
                                                        if (_e8734.member < _e8734.member_1) {
                                                            phi_6785_ = type_12((_e8734.member + 1u), _e8734.member_1);
                                                            phi_6814_ = type_12(1u, _e8734.member);
                                                        } else {
                                                            phi_6785_ = _e8734;
                                                            phi_6814_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8752 = phi_6785_;
                                                        let _e8754 = phi_6814_;
                                                        let _e8758 = (bitcast<i32>(_e8754.member) != 0i);
                                                        if _e8758 {
                                                            let _e8762 = local_14.member[0u][_e8754.member_1];
                                                            let _e8769 = local_14.member[1u][_e8754.member_1];
                                                            if (_e8762[0] < 0f) {
                                                                phi_6851_ = -(_e8762[0]);
                                                            } else {
                                                                phi_6851_ = _e8762[0];
                                                            }
                                                            let _e8776 = phi_6851_;
                                                            if (_e8762[1] < 0f) {
                                                                phi_6858_ = -(_e8762[1]);
                                                            } else {
                                                                phi_6858_ = _e8762[1];
                                                            }
                                                            let _e8780 = phi_6858_;
                                                            if (_e8762[2] < 0f) {
                                                                phi_6866_ = -(_e8762[2]);
                                                            } else {
                                                                phi_6866_ = _e8762[2];
                                                            }
                                                            let _e8785 = phi_6866_;
                                                            let _e8786 = ((_e8776 + _e8780) + _e8785);
                                                            if (_e8769[0] < 0f) {
                                                                phi_6874_ = -(_e8769[0]);
                                                            } else {
                                                                phi_6874_ = _e8769[0];
                                                            }
                                                            let _e8790 = phi_6874_;
                                                            if (_e8769[1] < 0f) {
                                                                phi_6881_ = -(_e8769[1]);
                                                            } else {
                                                                phi_6881_ = _e8769[1];
                                                            }
                                                            let _e8794 = phi_6881_;
                                                            if (_e8769[2] < 0f) {
                                                                phi_6889_ = -(_e8769[2]);
                                                            } else {
                                                                phi_6889_ = _e8769[2];
                                                            }
                                                            let _e8799 = phi_6889_;
                                                            let _e8800 = ((_e8790 + _e8794) + _e8799);
                                                            if (_e8786 > _e8800) {
                                                                phi_6895_ = _e8786;
                                                            } else {
                                                                phi_6895_ = _e8800;
                                                            }
                                                            let _e8803 = phi_6895_;
                                                            let _e8807 = (_e8769[0] - _e8762[0]);
                                                            let _e8808 = (_e8769[1] - _e8762[1]);
                                                            let _e8809 = (_e8769[2] - _e8762[2]);
                                                            if (_e8807 < 0f) {
                                                                phi_6913_ = -(_e8807);
                                                            } else {
                                                                phi_6913_ = _e8807;
                                                            }
                                                            let _e8813 = phi_6913_;
                                                            if (_e8808 < 0f) {
                                                                phi_6919_ = -(_e8808);
                                                            } else {
                                                                phi_6919_ = _e8808;
                                                            }
                                                            let _e8817 = phi_6919_;
                                                            if (_e8809 < 0f) {
                                                                phi_6926_ = -(_e8809);
                                                            } else {
                                                                phi_6926_ = _e8809;
                                                            }
                                                            let _e8822 = phi_6926_;
                                                            let _e8829 = local_15.member[_e8754.member_1];
                                                            let _e8832 = local_15.member_1[_e8754.member_1];
                                                            if (_e8829 < 0f) {
                                                                phi_6952_ = -(_e8829);
                                                            } else {
                                                                phi_6952_ = _e8829;
                                                            }
                                                            let _e8837 = phi_6952_;
                                                            if (_e8832 < 0f) {
                                                                phi_6958_ = -(_e8832);
                                                            } else {
                                                                phi_6958_ = _e8832;
                                                            }
                                                            let _e8841 = phi_6958_;
                                                            let _e8845 = ((_e8060 * 1.01f) + ((_e8837 + _e8841) * (0.000000059604645f * 12f)));
                                                            let _e8852 = local_15.member_1[_e8754.member_1];
                                                            let _e8855 = local_15.member[_e8754.member_1];
                                                            let _e8856 = (_e8852 - _e8855);
                                                            let _e8859 = ((_e8845 + _e8845) + (_e8732 * ((((_e8813 + _e8817) + _e8822) + (_e8060 * 6f)) * 1.01f)));
                                                            let _e8862 = ((((_e8829 + ((_e8832 - _e8829) * _e5960)) - _e8845) - (_e8732 * ((_e8803 + (_e8060 * 3f)) * 1.01f))) - _e8592);
                                                            let _e8863 = (_e8862 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8864 = (_e8856 > _e8859);
                                                            if _e8864 {
                                                                phi_6994_ = true;
                                                            } else {
                                                                phi_6994_ = _e8863;
                                                            }
                                                            let _e8866 = phi_6994_;
                                                            if (_e8856 < -(_e8859)) {
                                                                phi_7001_ = true;
                                                            } else {
                                                                phi_7001_ = _e8863;
                                                            }
                                                            let _e8871 = phi_7001_;
                                                            if _e8864 {
                                                                phi_7022_ = _e8736;
                                                            } else {
                                                                if _e8863 {
                                                                    let _e8873 = (_e8859 - _e8856);
                                                                    if (_e8873 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_7014_ = _e8873;
                                                                    } else {
                                                                        phi_7014_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8876 = phi_7014_;
                                                                    let _e8877 = (_e8862 / _e8876);
                                                                    if (_e8736 < _e8877) {
                                                                        phi_7020_ = _e8736;
                                                                    } else {
                                                                        phi_7020_ = _e8877;
                                                                    }
                                                                    let _e8880 = phi_7020_;
                                                                    phi_7021_ = _e8880;
                                                                } else {
                                                                    phi_7021_ = _e8736;
                                                                }
                                                                let _e8882 = phi_7021_;
                                                                phi_7022_ = _e8882;
                                                            }
                                                            let _e8884 = phi_7022_;
                                                            phi_6788_ = _e8884;
                                                            phi_6790_ = (_e8738 && _e8871);
                                                            phi_6792_ = (_e8740 && _e8866);
                                                        } else {
                                                            phi_6788_ = f32();
                                                            phi_6790_ = bool();
                                                            phi_6792_ = bool();
                                                        }
                                                        let _e8886 = phi_6788_;
                                                        let _e8888 = phi_6790_;
                                                        let _e8890 = phi_6792_;
                                                        continue;
                                                        continuing {
                                                            phi_6784_ = _e8752;
                                                            phi_6787_ = _e8886;
                                                            phi_6789_ = _e8888;
                                                            phi_6791_ = _e8890;
                                                            break if !(_e8758);
                                                        }
                                                    }
                                                    let _e8893 = local_50;
                                                    if (_e8893 < 2f) {
                                                        let _e11310 = local_87;
                                                        phi_7027_ = _e11310;
                                                    } else {
                                                        phi_7027_ = 2f;
                                                    }
                                                    let _e8896 = phi_7027_;
                                                    let _e8897 = (_e8896 * 0.999f);
                                                    let _e8899 = local_51;
                                                    if _e8899 {
                                                        let _e8901 = local_52;
                                                        if _e8901 {
                                                            phi_7036_ = type_40();
                                                        } else {
                                                            phi_7036_ = type_40(1u, _e5960, 2f);
                                                        }
                                                        let _e8904 = phi_7036_;
                                                        phi_7037_ = _e8904;
                                                        let _e11317 = local_88;
                                                        phi_7038_ = _e11317;
                                                    } else {
                                                        phi_7037_ = type_40();
                                                        phi_7038_ = true;
                                                    }
                                                    let _e8906 = phi_7037_;
                                                    let _e8908 = phi_7038_;
                                                    if _e8908 {
                                                        let _e8910 = local_53;
                                                        if _e8910 {
                                                            if (_e8897 > (0.000000059604645f * 4096f)) {
                                                                let _e8914 = (_e5960 + _e8897);
                                                                if (_e8914 < _e325) {
                                                                    phi_7055_ = _e8914;
                                                                } else {
                                                                    phi_7055_ = _e325;
                                                                }
                                                                let _e8917 = phi_7055_;
                                                                phi_7056_ = _e8917;
                                                            } else {
                                                                phi_7056_ = _e5960;
                                                            }
                                                            let _e8919 = phi_7056_;
                                                            phi_7059_ = type_12(0u, 4u);
                                                            phi_7062_ = _e8919;
                                                            phi_7064_ = _e5960;
                                                            loop {
                                                                let _e8921 = phi_7059_;
                                                                let _e8923 = phi_7062_;
                                                                let _e8925 = phi_7064_;
                                                                local_54 = _e8923;
                                                                local_55 = _e8925;
                                                                local_56 = _e8925;
                                                                if (_e8921.member < _e8921.member_1) {
                                                                    phi_7060_ = type_12((_e8921.member + 1u), _e8921.member_1);
                                                                    phi_7087_ = type_12(1u, _e8921.member);
                                                                } else {
                                                                    phi_7060_ = _e8921;
                                                                    phi_7087_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8937 = phi_7060_;
                                                                let _e8939 = phi_7087_;
                                                                let _e8943 = (bitcast<i32>(_e8939.member) != 0i);
                                                                if _e8943 {
                                                                    let _e8946 = local_15.member[_e8939.member_1];
                                                                    let _e8949 = local_15.member_1[_e8939.member_1];
                                                                    let _e8952 = local_15.member[_e8939.member_1];
                                                                    let _e8958 = local_15.member_2[_e8939.member_1];
                                                                    let _e8959 = ((_e8946 + ((_e8949 - _e8952) * _e5960)) - _e8958);
                                                                    let _e8962 = local_15.member_1[_e8939.member_1];
                                                                    let _e8965 = local_15.member[_e8939.member_1];
                                                                    let _e8966 = (_e8962 - _e8965);
                                                                    if (_e8966 > 0f) {
                                                                        let _e8980 = (_e5960 - (_e8959 / _e8966));
                                                                        if (_e8925 > _e8980) {
                                                                            phi_7155_ = _e8925;
                                                                        } else {
                                                                            phi_7155_ = _e8980;
                                                                        }
                                                                        let _e8983 = phi_7155_;
                                                                        phi_7173_ = _e8923;
                                                                        phi_7174_ = _e8983;
                                                                    } else {
                                                                        if (_e8959 > 0f) {
                                                                            if (_e8966 < 0f) {
                                                                                let _e8971 = (_e5960 - (_e8959 / _e8966));
                                                                                if (_e8923 < _e8971) {
                                                                                    phi_7170_ = _e8923;
                                                                                } else {
                                                                                    phi_7170_ = _e8971;
                                                                                }
                                                                                let _e8974 = phi_7170_;
                                                                                phi_7171_ = _e8974;
                                                                            } else {
                                                                                phi_7171_ = _e8923;
                                                                            }
                                                                            let _e8976 = phi_7171_;
                                                                            phi_7172_ = _e8976;
                                                                        } else {
                                                                            phi_7172_ = _e8923;
                                                                        }
                                                                        let _e8978 = phi_7172_;
                                                                        phi_7173_ = _e8978;
                                                                        phi_7174_ = _e8925;
                                                                    }
                                                                    let _e8985 = phi_7173_;
                                                                    let _e8987 = phi_7174_;
                                                                    phi_7063_ = _e8985;
                                                                    phi_7065_ = _e8987;
                                                                } else {
                                                                    phi_7063_ = f32();
                                                                    phi_7065_ = f32();
                                                                }
                                                                let _e8989 = phi_7063_;
                                                                let _e8991 = phi_7065_;
                                                                continue;
                                                                continuing {
                                                                    phi_7059_ = _e8937;
                                                                    phi_7062_ = _e8989;
                                                                    phi_7064_ = _e8991;
                                                                    break if !(_e8943);
                                                                }
                                                            }
                                                            let _e8994 = local_54;
                                                            let _e8996 = local_55;
                                                            let _e9000 = local_56;
                                                            let _e9001 = (_e9000 + ((_e8994 - _e8996) * 0.5f));
                                                            if (_e9001 > _e5960) {
                                                                if (_e9001 <= _e8919) {
                                                                    let _e9006 = local_15.member[0u];
                                                                    let _e9009 = local_15.member_1[0u];
                                                                    let _e9012 = local_15.member[0u];
                                                                    let _e9018 = local_15.member_2[0u];
                                                                    if (((_e9006 + ((_e9009 - _e9012) * _e9001)) - _e9018) > 0f) {
                                                                        let _e9023 = local_15.member[1u];
                                                                        let _e9026 = local_15.member_1[1u];
                                                                        let _e9029 = local_15.member[1u];
                                                                        let _e9035 = local_15.member_2[1u];
                                                                        if (((_e9023 + ((_e9026 - _e9029) * _e9001)) - _e9035) > 0f) {
                                                                            let _e9040 = local_15.member[2u];
                                                                            let _e9043 = local_15.member_1[2u];
                                                                            let _e9046 = local_15.member[2u];
                                                                            let _e9052 = local_15.member_2[2u];
                                                                            if (((_e9040 + ((_e9043 - _e9046) * _e9001)) - _e9052) > 0f) {
                                                                                let _e9057 = local_15.member[3u];
                                                                                let _e9060 = local_15.member_1[3u];
                                                                                let _e9063 = local_15.member[3u];
                                                                                let _e9069 = local_15.member_2[3u];
                                                                                phi_7335_ = (((_e9057 + ((_e9060 - _e9063) * _e9001)) - _e9069) > 0f);
                                                                                phi_7336_ = false;
                                                                            } else {
                                                                                phi_7335_ = bool();
                                                                                phi_7336_ = true;
                                                                            }
                                                                            let _e9073 = phi_7335_;
                                                                            let _e9075 = phi_7336_;
                                                                            phi_7337_ = _e9073;
                                                                            phi_7338_ = _e9075;
                                                                        } else {
                                                                            phi_7337_ = bool();
                                                                            phi_7338_ = true;
                                                                        }
                                                                        let _e9077 = phi_7337_;
                                                                        let _e9079 = phi_7338_;
                                                                        phi_7339_ = _e9077;
                                                                        phi_7340_ = _e9079;
                                                                    } else {
                                                                        phi_7339_ = bool();
                                                                        phi_7340_ = true;
                                                                    }
                                                                    let _e9081 = phi_7339_;
                                                                    let _e9083 = phi_7340_;
                                                                    if _e9083 {
                                                                        phi_7344_ = false;
                                                                    } else {
                                                                        phi_7344_ = _e9081;
                                                                    }
                                                                    let _e9085 = phi_7344_;
                                                                    if _e9085 {
                                                                        phi_7348_ = false;
                                                                    } else {
                                                                        phi_7348_ = true;
                                                                    }
                                                                    let _e9087 = phi_7348_;
                                                                    phi_7349_ = _e9087;
                                                                } else {
                                                                    phi_7349_ = true;
                                                                }
                                                                let _e9089 = phi_7349_;
                                                                phi_7350_ = _e9089;
                                                            } else {
                                                                phi_7350_ = true;
                                                            }
                                                            let _e9091 = phi_7350_;
                                                            if _e9091 {
                                                                phi_7354_ = 2f;
                                                            } else {
                                                                phi_7354_ = _e9001;
                                                            }
                                                            let _e9093 = phi_7354_;
                                                            phi_7357_ = type_40(2u, _e8919, _e9093);
                                                            phi_7358_ = type_40();
                                                            phi_7359_ = false;
                                                        } else {
                                                            phi_7357_ = type_40();
                                                            phi_7358_ = type_40(0u, _e5960, 2f);
                                                            phi_7359_ = true;
                                                        }
                                                        let _e9096 = phi_7357_;
                                                        let _e9098 = phi_7358_;
                                                        let _e9100 = phi_7359_;
                                                        phi_7360_ = _e9096;
                                                        phi_7361_ = _e9098;
                                                        phi_7362_ = _e9100;
                                                    } else {
                                                        phi_7360_ = type_40();
                                                        phi_7361_ = _e8906;
                                                        phi_7362_ = true;
                                                    }
                                                    let _e9102 = phi_7360_;
                                                    let _e9104 = phi_7361_;
                                                    let _e9106 = phi_7362_;
                                                    phi_7367_ = _e9104;
                                                    phi_7368_ = _e9102;
                                                    phi_7369_ = _e9106;
                                                } else {
                                                    phi_7367_ = type_40(0u, _e5960, 2f);
                                                    phi_7368_ = type_40();
                                                    phi_7369_ = true;
                                                }
                                                let _e9108 = phi_7367_;
                                                let _e9110 = phi_7368_;
                                                let _e9112 = phi_7369_;
                                                phi_7373_ = _e9108;
                                                phi_7374_ = _e9110;
                                                phi_7375_ = false;
                                                phi_7376_ = _e9112;
                                            } else {
                                                phi_7373_ = type_40();
                                                phi_7374_ = type_40();
                                                phi_7375_ = true;
                                                phi_7376_ = false;
                                            }
                                            let _e9114 = phi_7373_;
                                            let _e9116 = phi_7374_;
                                            let _e9118 = phi_7375_;
                                            let _e9120 = phi_7376_;
                                            phi_7377_ = _e9114;
                                            phi_7378_ = _e9116;
                                            phi_7379_ = _e9118;
                                            phi_7380_ = _e9120;
                                        } else {
                                            phi_7377_ = type_40();
                                            phi_7378_ = type_40();
                                            phi_7379_ = true;
                                            phi_7380_ = false;
                                        }
                                        let _e9122 = phi_7377_;
                                        let _e9124 = phi_7378_;
                                        let _e9126 = phi_7379_;
                                        let _e9128 = phi_7380_;
                                        if _e9126 {
                                            phi_7385_ = type_40(0u, _e5960, 2f);
                                            phi_7386_ = true;
                                        } else {
                                            phi_7385_ = _e9122;
                                            phi_7386_ = _e9128;
                                        }
                                        let _e9131 = phi_7385_;
                                        let _e9133 = phi_7386_;
                                        if _e9133 {
                                            phi_7390_ = _e9131;
                                        } else {
                                            phi_7390_ = _e9124;
                                        }
                                        let _e9135 = phi_7390_;
                                        if _e331 {
                                            if (_e9135.member == 2u) {
                                                let _e9139 = (_e9135.member_2 <= _e325);
                                                if _e9139 {
                                                    phi_7406_ = _e9135.member_2;
                                                    phi_7407_ = _e9135.member_2;
                                                    phi_7408_ = false;
                                                } else {
                                                    phi_7406_ = f32();
                                                    phi_7407_ = f32();
                                                    phi_7408_ = true;
                                                }
                                                let _e9143 = phi_7406_;
                                                let _e9145 = phi_7407_;
                                                let _e9147 = phi_7408_;
                                                phi_7409_ = _e9143;
                                                phi_7410_ = _e9145;
                                                phi_7411_ = _e9139;
                                                phi_7412_ = _e9147;
                                                phi_7413_ = false;
                                            } else {
                                                phi_7409_ = f32();
                                                phi_7410_ = f32();
                                                phi_7411_ = false;
                                                phi_7412_ = false;
                                                phi_7413_ = true;
                                            }
                                            let _e9149 = phi_7409_;
                                            let _e9151 = phi_7410_;
                                            let _e9153 = phi_7411_;
                                            let _e9155 = phi_7412_;
                                            let _e9157 = phi_7413_;
                                            phi_7414_ = _e9149;
                                            phi_7415_ = _e9151;
                                            phi_7416_ = _e9153;
                                            phi_7417_ = _e9155;
                                            phi_7418_ = _e9157;
                                        } else {
                                            phi_7414_ = f32();
                                            phi_7415_ = f32();
                                            phi_7416_ = false;
                                            phi_7417_ = false;
                                            phi_7418_ = true;
                                        }
                                        let _e9159 = phi_7414_;
                                        let _e9161 = phi_7415_;
                                        let _e9163 = phi_7416_;
                                        let _e9165 = phi_7417_;
                                        let _e9167 = phi_7418_;
                                        phi_7419_ = _e9159;
                                        phi_7420_ = _e9135.member;
                                        phi_7421_ = _e9161;
                                        phi_7422_ = _e9135;
                                        phi_7423_ = _e9135.member;
                                        phi_7424_ = _e9135.member;
                                        phi_7425_ = _e9163;
                                        phi_7426_ = _e9165;
                                        phi_7427_ = _e9167;
                                    }
                                    let _e9169 = phi_7419_;
                                    let _e9171 = phi_7420_;
                                    let _e9173 = phi_7421_;
                                    let _e9175 = phi_7422_;
                                    let _e9177 = phi_7423_;
                                    let _e9179 = phi_7424_;
                                    let _e9181 = phi_7425_;
                                    let _e9183 = phi_7426_;
                                    let _e9185 = phi_7427_;
                                    phi_7428_ = _e9169;
                                    phi_7429_ = _e9171;
                                    phi_7430_ = _e9173;
                                    phi_7431_ = _e9175;
                                    phi_7432_ = _e9177;
                                    phi_7433_ = _e9179;
                                    phi_7434_ = _e9181;
                                    phi_7435_ = _e7746;
                                    phi_7436_ = _e9183;
                                    phi_7437_ = _e9185;
                                    phi_7438_ = false;
                                } else {
                                    phi_7428_ = f32();
                                    phi_7429_ = u32();
                                    phi_7430_ = f32();
                                    phi_7431_ = type_40();
                                    phi_7432_ = u32();
                                    phi_7433_ = u32();
                                    phi_7434_ = false;
                                    phi_7435_ = false;
                                    phi_7436_ = false;
                                    phi_7437_ = false;
                                    phi_7438_ = true;
                                }
                                let _e9187 = phi_7428_;
                                let _e9189 = phi_7429_;
                                let _e9191 = phi_7430_;
                                let _e9193 = phi_7431_;
                                let _e9195 = phi_7432_;
                                let _e9197 = phi_7433_;
                                let _e9199 = phi_7434_;
                                let _e9201 = phi_7435_;
                                let _e9203 = phi_7436_;
                                let _e9205 = phi_7437_;
                                let _e9207 = phi_7438_;
                                phi_7439_ = _e7743;
                                phi_2514_ = _e9187;
                                phi_2516_ = _e9189;
                                phi_2518_ = _e9191;
                                phi_7440_ = _e9193;
                                phi_7441_ = _e9195;
                                phi_7442_ = _e7743;
                                phi_7443_ = _e9197;
                                phi_7444_ = _e9199;
                                phi_7445_ = _e9201;
                                phi_7446_ = _e9203;
                                phi_7447_ = _e9205;
                                phi_7448_ = false;
                                phi_7449_ = _e9207;
                            } else {
                                phi_7439_ = f32();
                                phi_2514_ = f32();
                                phi_2516_ = u32();
                                phi_2518_ = f32();
                                phi_7440_ = type_40();
                                phi_7441_ = u32();
                                phi_7442_ = f32();
                                phi_7443_ = u32();
                                phi_7444_ = false;
                                phi_7445_ = false;
                                phi_7446_ = false;
                                phi_7447_ = false;
                                phi_7448_ = true;
                                phi_7449_ = false;
                            }
                            let _e9209 = phi_7439_;
                            let _e9211 = phi_2514_;
                            let _e9213 = phi_2516_;
                            let _e9215 = phi_2518_;
                            let _e9217 = phi_7440_;
                            let _e9219 = phi_7441_;
                            let _e9221 = phi_7442_;
                            let _e9223 = phi_7443_;
                            let _e9225 = phi_7444_;
                            let _e9227 = phi_7445_;
                            let _e9229 = phi_7446_;
                            let _e9231 = phi_7447_;
                            let _e9233 = phi_7448_;
                            let _e9235 = phi_7449_;
                            local_57 = _e9227;
                            local_89 = _e9229;
                            local_90 = _e9231;
                            local_91 = _e9233;
                            local_92 = _e9235;
                            local_58 = _e9217;
                            local_59 = _e9217;
                            local_93 = _e9219;
                            local_60 = _e9217;
                            local_94 = _e9227;
                            local_95 = _e9223;
                            local_97 = _e9221;
                            local_98 = _e9209;
                            continue;
                            continuing {
                                phi_2510_ = _e5983;
                                phi_2513_ = _e9211;
                                phi_2515_ = _e9213;
                                phi_2517_ = _e9215;
                                break if !(_e9225);
                            }
                        }
                        let _e9238 = local_57;
                        if _e9238 {
                            phi_7453_ = false;
                            phi_7454_ = false;
                            phi_7455_ = false;
                            phi_7456_ = false;
                        } else {
                            let _e11418 = local_89;
                            phi_7453_ = _e11418;
                            let _e11421 = local_90;
                            phi_7454_ = _e11421;
                            let _e11424 = local_91;
                            phi_7455_ = _e11424;
                            let _e11427 = local_92;
                            phi_7456_ = _e11427;
                        }
                        let _e9240 = phi_7453_;
                        let _e9242 = phi_7454_;
                        let _e9244 = phi_7455_;
                        let _e9246 = phi_7456_;
                        if _e9240 {
                            let _e9248 = local_58;
                            if (_e9248.member_1 >= _e325) {
                                phi_7478_ = type_39(type_28(0u, f32()), 0u);
                            } else {
                                let _e9252 = local_59;
                                if (_e9252.member_1 > _e323) {
                                    phi_7473_ = 0u;
                                } else {
                                    let _e11432 = local_93;
                                    phi_7473_ = _e11432;
                                }
                                let _e9256 = phi_7473_;
                                let _e9258 = local_60;
                                phi_7478_ = type_39(type_28(2u, _e9258.member_1), _e9256);
                            }
                            let _e9265 = phi_7478_;
                            phi_7479_ = _e9265;
                            phi_7480_ = false;
                            phi_7481_ = false;
                            phi_7482_ = false;
                            phi_7483_ = false;
                        } else {
                            phi_7479_ = type_39();
                            phi_7480_ = _e9242;
                            let _e11439 = local_94;
                            phi_7481_ = _e11439;
                            phi_7482_ = _e9244;
                            phi_7483_ = _e9246;
                        }
                        let _e9267 = phi_7479_;
                        let _e9269 = phi_7480_;
                        let _e9271 = phi_7481_;
                        let _e9273 = phi_7482_;
                        let _e9275 = phi_7483_;
                        if _e9269 {
                            let _e11444 = local_95;
                            phi_7487_ = _e11444;
                            let _e11449 = local_97;
                            phi_7488_ = _e11449;
                            phi_7489_ = true;
                            phi_7490_ = false;
                            phi_7491_ = false;
                            phi_7492_ = false;
                        } else {
                            let _e11446 = local_96;
                            phi_7487_ = _e11446;
                            let _e11451 = local_98;
                            phi_7488_ = _e11451;
                            phi_7489_ = _e9271;
                            phi_7490_ = _e9273;
                            phi_7491_ = _e9275;
                            phi_7492_ = _e9240;
                        }
                        let _e9277 = phi_7487_;
                        let _e9279 = phi_7488_;
                        let _e9281 = phi_7489_;
                        let _e9283 = phi_7490_;
                        let _e9285 = phi_7491_;
                        let _e9287 = phi_7492_;
                        if _e9281 {
                            phi_7496_ = _e9279;
                            phi_7497_ = _e9277;
                            phi_7498_ = true;
                            phi_7499_ = false;
                            phi_7500_ = false;
                        } else {
                            let _e11458 = local_99;
                            phi_7496_ = _e11458;
                            let _e11461 = local_100;
                            phi_7497_ = _e11461;
                            phi_7498_ = _e9283;
                            phi_7499_ = _e9285;
                            phi_7500_ = _e9287;
                        }
                        let _e9289 = phi_7496_;
                        let _e9291 = phi_7497_;
                        let _e9293 = phi_7498_;
                        let _e9295 = phi_7499_;
                        let _e9297 = phi_7500_;
                        if _e9293 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e321 >= (0.000000059604645f * 8f)) {
                                phi_7512_ = _e321;
                            } else {
                                phi_7512_ = 0f;
                            }
                            let _e9304 = phi_7512_;
                            phi_7515_ = type_12(0u, 3u);
                            loop {
                                let _e9306 = phi_7515_;
                                if (_e9306.member < _e9306.member_1) {
                                    phi_7516_ = type_12((_e9306.member + 1u), _e9306.member_1);
                                    phi_7539_ = type_12(1u, _e9306.member);
                                } else {
                                    phi_7516_ = _e9306;
                                    phi_7539_ = type_12(0u, type_12().member_1);
                                }
                                let _e9318 = phi_7516_;
                                let _e9320 = phi_7539_;
                                if (bitcast<i32>(_e9320.member) != 0i) {
                                    let _e9326 = local_13[_e9320.member_1];
                                    let _e9328 = (_e9289 + (_e9304 * _e9326));
                                    if (_e9328 < _e325) {
                                        phi_7560_ = _e9328;
                                    } else {
                                        phi_7560_ = _e325;
                                    }
                                    let _e9331 = phi_7560_;
                                    let _e9334 = local_18.member[0u];
                                    let _e9340 = local_18.member[1u];
                                    let _e9356 = local_18.member_1[0u];
                                    let _e9362 = local_18.member_1[1u];
                                    let _e9378 = local_18.member_2[0u];
                                    let _e9384 = local_18.member_2[1u];
                                    let _e9398 = function_2(array<f32, 3>((_e9334[0] + ((_e9340[0] - _e9334[0]) * _e9331)), (_e9334[1] + ((_e9340[1] - _e9334[1]) * _e9331)), (_e9334[2] + ((_e9340[2] - _e9334[2]) * _e9331))), array<f32, 3>((_e9356[0] + ((_e9362[0] - _e9356[0]) * _e9331)), (_e9356[1] + ((_e9362[1] - _e9356[1]) * _e9331)), (_e9356[2] + ((_e9362[2] - _e9356[2]) * _e9331))), array<f32, 3>((_e9378[0] + ((_e9384[0] - _e9378[0]) * _e9331)), (_e9378[1] + ((_e9384[1] - _e9378[1]) * _e9331)), (_e9378[2] + ((_e9384[2] - _e9378[2]) * _e9331))), 0u);
                                    let _e9409 = (((_e9398[0] * _e9398[0]) + (_e9398[1] * _e9398[1])) + (_e9398[2] * _e9398[2]));
                                    if (_e9409 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9409 > 0f) {
                                            phi_7683_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7683_ = 0f;
                                        }
                                        let _e9462 = phi_7683_;
                                        phi_7747_ = _e9462;
                                    } else {
                                        phi_7690_ = type_14(0i, 5i);
                                        phi_7693_ = bitcast<f32>(((bitcast<u32>(_e9409) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9417 = phi_7690_;
                                            let _e9419 = phi_7693_;
                                            local_61 = _e9419;
                                            if (_e9417.member < _e9417.member_1) {
                                                let _e9426 = (_e9417.member + 1i);
                                                if ((false == (_e9426 > _e9417.member)) != false) {
                                                    phi_7714_ = true;
                                                } else {
                                                    phi_7714_ = false;
                                                }
                                                let _e9431 = phi_7714_;
                                                if _e9431 {
                                                    phi_7720_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7720_ = type_15(1u, _e9426);
                                                }
                                                let _e9436 = phi_7720_;
                                                phi_7691_ = type_14(_e9436.member_1, _e9417.member_1);
                                                phi_7734_ = type_15(1u, _e9417.member);
                                            } else {
                                                phi_7691_ = _e9417;
                                                phi_7734_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9442 = phi_7691_;
                                            let _e9444 = phi_7734_;
                                            let _e9447 = (bitcast<i32>(_e9444.member) != 0i);
                                            if _e9447 {
                                                phi_7694_ = (0.5f * (_e9419 + (_e9409 / _e9419)));
                                            } else {
                                                phi_7694_ = f32();
                                            }
                                            let _e9452 = phi_7694_;
                                            continue;
                                            continuing {
                                                phi_7690_ = _e9442;
                                                phi_7693_ = _e9452;
                                                break if !(_e9447);
                                            }
                                        }
                                        let _e9457 = local_61;
                                        phi_7747_ = (_e9457 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9464 = phi_7747_;
                                    let _e9470 = local_18.member[0u];
                                    if (_e9470[0] < 0f) {
                                        phi_7763_ = -(_e9470[0]);
                                    } else {
                                        phi_7763_ = _e9470[0];
                                    }
                                    let _e9477 = phi_7763_;
                                    if (_e9470[1] < 0f) {
                                        phi_7770_ = -(_e9470[1]);
                                    } else {
                                        phi_7770_ = _e9470[1];
                                    }
                                    let _e9481 = phi_7770_;
                                    if (_e9477 > _e9481) {
                                        phi_7775_ = _e9477;
                                    } else {
                                        phi_7775_ = _e9481;
                                    }
                                    let _e9484 = phi_7775_;
                                    if (_e9470[2] < 0f) {
                                        phi_7782_ = -(_e9470[2]);
                                    } else {
                                        phi_7782_ = _e9470[2];
                                    }
                                    let _e9488 = phi_7782_;
                                    if (_e9484 > _e9488) {
                                        phi_7787_ = _e9484;
                                    } else {
                                        phi_7787_ = _e9488;
                                    }
                                    let _e9491 = phi_7787_;
                                    let _e9494 = local_18.member[1u];
                                    if (_e9494[0] < 0f) {
                                        phi_7800_ = -(_e9494[0]);
                                    } else {
                                        phi_7800_ = _e9494[0];
                                    }
                                    let _e9501 = phi_7800_;
                                    if (_e9494[1] < 0f) {
                                        phi_7807_ = -(_e9494[1]);
                                    } else {
                                        phi_7807_ = _e9494[1];
                                    }
                                    let _e9505 = phi_7807_;
                                    if (_e9501 > _e9505) {
                                        phi_7812_ = _e9501;
                                    } else {
                                        phi_7812_ = _e9505;
                                    }
                                    let _e9508 = phi_7812_;
                                    if (_e9494[2] < 0f) {
                                        phi_7819_ = -(_e9494[2]);
                                    } else {
                                        phi_7819_ = _e9494[2];
                                    }
                                    let _e9512 = phi_7819_;
                                    if (_e9508 > _e9512) {
                                        phi_7824_ = _e9508;
                                    } else {
                                        phi_7824_ = _e9512;
                                    }
                                    let _e9515 = phi_7824_;
                                    if (_e9491 > _e9515) {
                                        phi_7829_ = _e9491;
                                    } else {
                                        phi_7829_ = _e9515;
                                    }
                                    let _e9518 = phi_7829_;
                                    let _e9520 = local_18.member_3;
                                    let _e9524 = local_18.member_1[0u];
                                    if (_e9524[0] < 0f) {
                                        phi_7846_ = -(_e9524[0]);
                                    } else {
                                        phi_7846_ = _e9524[0];
                                    }
                                    let _e9531 = phi_7846_;
                                    if (_e9524[1] < 0f) {
                                        phi_7853_ = -(_e9524[1]);
                                    } else {
                                        phi_7853_ = _e9524[1];
                                    }
                                    let _e9535 = phi_7853_;
                                    if (_e9531 > _e9535) {
                                        phi_7858_ = _e9531;
                                    } else {
                                        phi_7858_ = _e9535;
                                    }
                                    let _e9538 = phi_7858_;
                                    if (_e9524[2] < 0f) {
                                        phi_7865_ = -(_e9524[2]);
                                    } else {
                                        phi_7865_ = _e9524[2];
                                    }
                                    let _e9542 = phi_7865_;
                                    if (_e9538 > _e9542) {
                                        phi_7870_ = _e9538;
                                    } else {
                                        phi_7870_ = _e9542;
                                    }
                                    let _e9545 = phi_7870_;
                                    let _e9548 = local_18.member_1[1u];
                                    if (_e9548[0] < 0f) {
                                        phi_7884_ = -(_e9548[0]);
                                    } else {
                                        phi_7884_ = _e9548[0];
                                    }
                                    let _e9555 = phi_7884_;
                                    if (_e9548[1] < 0f) {
                                        phi_7891_ = -(_e9548[1]);
                                    } else {
                                        phi_7891_ = _e9548[1];
                                    }
                                    let _e9559 = phi_7891_;
                                    if (_e9555 > _e9559) {
                                        phi_7896_ = _e9555;
                                    } else {
                                        phi_7896_ = _e9559;
                                    }
                                    let _e9562 = phi_7896_;
                                    if (_e9548[2] < 0f) {
                                        phi_7903_ = -(_e9548[2]);
                                    } else {
                                        phi_7903_ = _e9548[2];
                                    }
                                    let _e9566 = phi_7903_;
                                    if (_e9562 > _e9566) {
                                        phi_7908_ = _e9562;
                                    } else {
                                        phi_7908_ = _e9566;
                                    }
                                    let _e9569 = phi_7908_;
                                    if (_e9545 > _e9569) {
                                        phi_7913_ = _e9545;
                                    } else {
                                        phi_7913_ = _e9569;
                                    }
                                    let _e9572 = phi_7913_;
                                    let _e9574 = local_18.member_3;
                                    let _e9578 = local_18.member_2[0u];
                                    if (_e9578[0] < 0f) {
                                        phi_7930_ = -(_e9578[0]);
                                    } else {
                                        phi_7930_ = _e9578[0];
                                    }
                                    let _e9585 = phi_7930_;
                                    if (_e9578[1] < 0f) {
                                        phi_7937_ = -(_e9578[1]);
                                    } else {
                                        phi_7937_ = _e9578[1];
                                    }
                                    let _e9589 = phi_7937_;
                                    if (_e9585 > _e9589) {
                                        phi_7942_ = _e9585;
                                    } else {
                                        phi_7942_ = _e9589;
                                    }
                                    let _e9592 = phi_7942_;
                                    if (_e9578[2] < 0f) {
                                        phi_7949_ = -(_e9578[2]);
                                    } else {
                                        phi_7949_ = _e9578[2];
                                    }
                                    let _e9596 = phi_7949_;
                                    if (_e9592 > _e9596) {
                                        phi_7954_ = _e9592;
                                    } else {
                                        phi_7954_ = _e9596;
                                    }
                                    let _e9599 = phi_7954_;
                                    let _e9602 = local_18.member_2[1u];
                                    if (_e9602[0] < 0f) {
                                        phi_7968_ = -(_e9602[0]);
                                    } else {
                                        phi_7968_ = _e9602[0];
                                    }
                                    let _e9609 = phi_7968_;
                                    if (_e9602[1] < 0f) {
                                        phi_7975_ = -(_e9602[1]);
                                    } else {
                                        phi_7975_ = _e9602[1];
                                    }
                                    let _e9613 = phi_7975_;
                                    if (_e9609 > _e9613) {
                                        phi_7980_ = _e9609;
                                    } else {
                                        phi_7980_ = _e9613;
                                    }
                                    let _e9616 = phi_7980_;
                                    if (_e9602[2] < 0f) {
                                        phi_7987_ = -(_e9602[2]);
                                    } else {
                                        phi_7987_ = _e9602[2];
                                    }
                                    let _e9620 = phi_7987_;
                                    if (_e9616 > _e9620) {
                                        phi_7992_ = _e9616;
                                    } else {
                                        phi_7992_ = _e9620;
                                    }
                                    let _e9623 = phi_7992_;
                                    if (_e9599 > _e9623) {
                                        phi_7997_ = _e9599;
                                    } else {
                                        phi_7997_ = _e9623;
                                    }
                                    let _e9626 = phi_7997_;
                                    let _e9628 = local_18.member_3;
                                    let _e9635 = local_18.member_3;
                                    let _e9642 = (((_e9464 * (1f + (0.000000059604645f * 8f))) + (((((((_e9518 + _e9520) + (_e9572 + _e9574)) + (_e9626 + _e9628)) * (0.000000059604645f * 16f)) + (_e9635 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e527.member_1);
                                    if _e9642 {
                                        phi_8017_ = false;
                                    } else {
                                        phi_8017_ = true;
                                    }
                                    let _e9644 = phi_8017_;
                                    phi_8018_ = _e9644;
                                    phi_8019_ = _e9642;
                                } else {
                                    phi_8018_ = false;
                                    phi_8019_ = false;
                                }
                                let _e9646 = phi_8018_;
                                let _e9648 = phi_8019_;
                                local_62 = _e9648;
                                continue;
                                continuing {
                                    phi_7515_ = _e9318;
                                    break if !(_e9646);
                                }
                            }
                            let _e9651 = local_62;
                            if _e9651 {
                                if (_e9289 > _e323) {
                                    phi_8027_ = 1u;
                                } else {
                                    phi_8027_ = _e9291;
                                }
                                let _e9654 = phi_8027_;
                                phi_8031_ = type_39(type_28(1u, _e9289), _e9654);
                                phi_8032_ = false;
                            } else {
                                phi_8031_ = type_39();
                                phi_8032_ = true;
                            }
                            let _e9658 = phi_8031_;
                            let _e9660 = phi_8032_;
                            if _e9660 {
                                if (_e9289 > _e323) {
                                    phi_8040_ = 0u;
                                } else {
                                    phi_8040_ = _e9291;
                                }
                                let _e9663 = phi_8040_;
                                phi_8044_ = type_39(type_28(2u, _e9289), _e9663);
                            } else {
                                phi_8044_ = _e9658;
                            }
                            let _e9667 = phi_8044_;
                            phi_8045_ = _e9667;
                            phi_8046_ = false;
                            phi_8047_ = false;
                        } else {
                            phi_8045_ = type_39();
                            phi_8046_ = _e9295;
                            phi_8047_ = _e9297;
                        }
                        let _e9669 = phi_8045_;
                        let _e9671 = phi_8046_;
                        let _e9673 = phi_8047_;
                        if _e9671 {
                            phi_8054_ = type_39(type_28(0u, f32()), 0u);
                            phi_8055_ = true;
                        } else {
                            phi_8054_ = _e9267;
                            phi_8055_ = _e9673;
                        }
                        let _e9677 = phi_8054_;
                        let _e9679 = phi_8055_;
                        phi_8059_ = _e9677;
                        phi_8060_ = _e9669;
                        phi_8061_ = _e9679;
                    } else {
                        phi_8059_ = _e5950;
                        phi_8060_ = type_39();
                        phi_8061_ = true;
                    }
                    let _e9681 = phi_8059_;
                    let _e9683 = phi_8060_;
                    let _e9685 = phi_8061_;
                    if _e9685 {
                        phi_8065_ = _e9681;
                    } else {
                        phi_8065_ = _e9683;
                    }
                    let _e9687 = phi_8065_;
                    phi_15580_ = _e9687;
                } else {
                    let _e571 = local_18.member_1[0u];
                    let _e577 = local_18.member_2[0u];
                    let _e583 = ((_e571[1] * _e577[2]) - (_e571[2] * _e577[1]));
                    let _e586 = ((_e571[2] * _e577[0]) - (_e571[0] * _e577[2]));
                    let _e589 = ((_e571[0] * _e577[1]) - (_e571[1] * _e577[0]));
                    let _e592 = local_18.member_1[1u];
                    let _e598 = local_18.member_2[1u];
                    let _e604 = ((_e592[1] * _e598[2]) - (_e592[2] * _e598[1]));
                    let _e607 = ((_e592[2] * _e598[0]) - (_e592[0] * _e598[2]));
                    let _e610 = ((_e592[0] * _e598[1]) - (_e592[1] * _e598[0]));
                    let _e613 = local_18.member_1[0u];
                    let _e619 = local_18.member_2[1u];
                    let _e634 = local_18.member_1[1u];
                    let _e640 = local_18.member_2[0u];
                    let _e653 = (((_e613[1] * _e619[2]) - (_e613[2] * _e619[1])) + ((_e634[1] * _e640[2]) - (_e634[2] * _e640[1])));
                    let _e654 = (((_e613[2] * _e619[0]) - (_e613[0] * _e619[2])) + ((_e634[2] * _e640[0]) - (_e634[0] * _e640[2])));
                    let _e655 = (((_e613[0] * _e619[1]) - (_e613[1] * _e619[0])) + ((_e634[0] * _e640[1]) - (_e634[1] * _e640[0])));
                    let _e658 = local_18.member[0u];
                    let _e666 = (((_e658[0] * _e583) + (_e658[1] * _e586)) + (_e658[2] * _e589));
                    let _e669 = local_18.member[1u];
                    let _e680 = local_18.member[0u];
                    let _e689 = ((((_e669[0] * _e583) + (_e669[1] * _e586)) + (_e669[2] * _e589)) + (((_e680[0] * _e653) + (_e680[1] * _e654)) + (_e680[2] * _e655)));
                    let _e692 = local_18.member[0u];
                    let _e703 = local_18.member[1u];
                    let _e712 = ((((_e692[0] * _e604) + (_e692[1] * _e607)) + (_e692[2] * _e610)) + (((_e703[0] * _e653) + (_e703[1] * _e654)) + (_e703[2] * _e655)));
                    let _e715 = local_18.member[1u];
                    let _e723 = (((_e715[0] * _e604) + (_e715[1] * _e607)) + (_e715[2] * _e610));
                    let _e726 = local_18.member[0u];
                    if (_e726[0] < 0f) {
                        phi_8307_ = -(_e726[0]);
                    } else {
                        phi_8307_ = _e726[0];
                    }
                    let _e733 = phi_8307_;
                    if (_e726[1] < 0f) {
                        phi_8314_ = -(_e726[1]);
                    } else {
                        phi_8314_ = _e726[1];
                    }
                    let _e737 = phi_8314_;
                    if (_e733 > _e737) {
                        phi_8319_ = _e733;
                    } else {
                        phi_8319_ = _e737;
                    }
                    let _e740 = phi_8319_;
                    if (_e726[2] < 0f) {
                        phi_8326_ = -(_e726[2]);
                    } else {
                        phi_8326_ = _e726[2];
                    }
                    let _e744 = phi_8326_;
                    if (_e740 > _e744) {
                        phi_8331_ = _e740;
                    } else {
                        phi_8331_ = _e744;
                    }
                    let _e747 = phi_8331_;
                    let _e750 = local_18.member[1u];
                    if (_e750[0] < 0f) {
                        phi_8344_ = -(_e750[0]);
                    } else {
                        phi_8344_ = _e750[0];
                    }
                    let _e757 = phi_8344_;
                    if (_e750[1] < 0f) {
                        phi_8351_ = -(_e750[1]);
                    } else {
                        phi_8351_ = _e750[1];
                    }
                    let _e761 = phi_8351_;
                    if (_e757 > _e761) {
                        phi_8356_ = _e757;
                    } else {
                        phi_8356_ = _e761;
                    }
                    let _e764 = phi_8356_;
                    if (_e750[2] < 0f) {
                        phi_8363_ = -(_e750[2]);
                    } else {
                        phi_8363_ = _e750[2];
                    }
                    let _e768 = phi_8363_;
                    if (_e764 > _e768) {
                        phi_8368_ = _e764;
                    } else {
                        phi_8368_ = _e768;
                    }
                    let _e771 = phi_8368_;
                    if (_e747 > _e771) {
                        phi_8373_ = _e747;
                    } else {
                        phi_8373_ = _e771;
                    }
                    let _e774 = phi_8373_;
                    let _e776 = local_18.member_3;
                    let _e777 = (_e774 + _e776);
                    let _e780 = local_18.member_1[0u];
                    if (_e780[0] < 0f) {
                        phi_8390_ = -(_e780[0]);
                    } else {
                        phi_8390_ = _e780[0];
                    }
                    let _e787 = phi_8390_;
                    if (_e780[1] < 0f) {
                        phi_8397_ = -(_e780[1]);
                    } else {
                        phi_8397_ = _e780[1];
                    }
                    let _e791 = phi_8397_;
                    if (_e787 > _e791) {
                        phi_8402_ = _e787;
                    } else {
                        phi_8402_ = _e791;
                    }
                    let _e794 = phi_8402_;
                    if (_e780[2] < 0f) {
                        phi_8409_ = -(_e780[2]);
                    } else {
                        phi_8409_ = _e780[2];
                    }
                    let _e798 = phi_8409_;
                    if (_e794 > _e798) {
                        phi_8414_ = _e794;
                    } else {
                        phi_8414_ = _e798;
                    }
                    let _e801 = phi_8414_;
                    let _e804 = local_18.member_1[1u];
                    if (_e804[0] < 0f) {
                        phi_8428_ = -(_e804[0]);
                    } else {
                        phi_8428_ = _e804[0];
                    }
                    let _e811 = phi_8428_;
                    if (_e804[1] < 0f) {
                        phi_8435_ = -(_e804[1]);
                    } else {
                        phi_8435_ = _e804[1];
                    }
                    let _e815 = phi_8435_;
                    if (_e811 > _e815) {
                        phi_8440_ = _e811;
                    } else {
                        phi_8440_ = _e815;
                    }
                    let _e818 = phi_8440_;
                    if (_e804[2] < 0f) {
                        phi_8447_ = -(_e804[2]);
                    } else {
                        phi_8447_ = _e804[2];
                    }
                    let _e822 = phi_8447_;
                    if (_e818 > _e822) {
                        phi_8452_ = _e818;
                    } else {
                        phi_8452_ = _e822;
                    }
                    let _e825 = phi_8452_;
                    if (_e801 > _e825) {
                        phi_8457_ = _e801;
                    } else {
                        phi_8457_ = _e825;
                    }
                    let _e828 = phi_8457_;
                    let _e830 = local_18.member_3;
                    let _e831 = (_e828 + _e830);
                    let _e834 = local_18.member_2[0u];
                    if (_e834[0] < 0f) {
                        phi_8474_ = -(_e834[0]);
                    } else {
                        phi_8474_ = _e834[0];
                    }
                    let _e841 = phi_8474_;
                    if (_e834[1] < 0f) {
                        phi_8481_ = -(_e834[1]);
                    } else {
                        phi_8481_ = _e834[1];
                    }
                    let _e845 = phi_8481_;
                    if (_e841 > _e845) {
                        phi_8486_ = _e841;
                    } else {
                        phi_8486_ = _e845;
                    }
                    let _e848 = phi_8486_;
                    if (_e834[2] < 0f) {
                        phi_8493_ = -(_e834[2]);
                    } else {
                        phi_8493_ = _e834[2];
                    }
                    let _e852 = phi_8493_;
                    if (_e848 > _e852) {
                        phi_8498_ = _e848;
                    } else {
                        phi_8498_ = _e852;
                    }
                    let _e855 = phi_8498_;
                    let _e858 = local_18.member_2[1u];
                    if (_e858[0] < 0f) {
                        phi_8512_ = -(_e858[0]);
                    } else {
                        phi_8512_ = _e858[0];
                    }
                    let _e865 = phi_8512_;
                    if (_e858[1] < 0f) {
                        phi_8519_ = -(_e858[1]);
                    } else {
                        phi_8519_ = _e858[1];
                    }
                    let _e869 = phi_8519_;
                    if (_e865 > _e869) {
                        phi_8524_ = _e865;
                    } else {
                        phi_8524_ = _e869;
                    }
                    let _e872 = phi_8524_;
                    if (_e858[2] < 0f) {
                        phi_8531_ = -(_e858[2]);
                    } else {
                        phi_8531_ = _e858[2];
                    }
                    let _e876 = phi_8531_;
                    if (_e872 > _e876) {
                        phi_8536_ = _e872;
                    } else {
                        phi_8536_ = _e876;
                    }
                    let _e879 = phi_8536_;
                    if (_e855 > _e879) {
                        phi_8541_ = _e855;
                    } else {
                        phi_8541_ = _e879;
                    }
                    let _e882 = phi_8541_;
                    let _e884 = local_18.member_3;
                    let _e885 = (_e882 + _e884);
                    let _e887 = ((_e831 * 8f) * _e885);
                    let _e894 = local_18.member_3;
                    if (_e583 < 0f) {
                        phi_8572_ = -(_e583);
                    } else {
                        phi_8572_ = _e583;
                    }
                    let _e911 = phi_8572_;
                    if (_e586 < 0f) {
                        phi_8578_ = -(_e586);
                    } else {
                        phi_8578_ = _e586;
                    }
                    let _e915 = phi_8578_;
                    if (_e589 < 0f) {
                        phi_8585_ = -(_e589);
                    } else {
                        phi_8585_ = _e589;
                    }
                    let _e920 = phi_8585_;
                    let _e921 = ((_e911 + _e915) + _e920);
                    if (_e604 < 0f) {
                        phi_8592_ = -(_e604);
                    } else {
                        phi_8592_ = _e604;
                    }
                    let _e925 = phi_8592_;
                    if (_e607 < 0f) {
                        phi_8598_ = -(_e607);
                    } else {
                        phi_8598_ = _e607;
                    }
                    let _e929 = phi_8598_;
                    if (_e610 < 0f) {
                        phi_8605_ = -(_e610);
                    } else {
                        phi_8605_ = _e610;
                    }
                    let _e934 = phi_8605_;
                    let _e935 = ((_e925 + _e929) + _e934);
                    if (_e921 > _e935) {
                        phi_8611_ = _e921;
                    } else {
                        phi_8611_ = _e935;
                    }
                    let _e938 = phi_8611_;
                    if (_e653 < 0f) {
                        phi_8617_ = -(_e653);
                    } else {
                        phi_8617_ = _e653;
                    }
                    let _e942 = phi_8617_;
                    if (_e654 < 0f) {
                        phi_8623_ = -(_e654);
                    } else {
                        phi_8623_ = _e654;
                    }
                    let _e946 = phi_8623_;
                    if (_e655 < 0f) {
                        phi_8630_ = -(_e655);
                    } else {
                        phi_8630_ = _e655;
                    }
                    let _e951 = phi_8630_;
                    let _e953 = (((_e942 + _e946) + _e951) * 0.5f);
                    if (_e938 > _e953) {
                        phi_8637_ = _e938;
                    } else {
                        phi_8637_ = _e953;
                    }
                    let _e956 = phi_8637_;
                    let _e961 = local_18.member_3;
                    let _e973 = (((((_e777 * 8f) * _e887) * (0.000000059604645f * (524f / 64f))) + ((_e894 * 19f) * ((_e777 * (_e831 + _e885)) + (_e831 * _e885)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e777) * ((1f + _e831) * (1f + _e885)))));
                    let _e974 = (_e666 * 3f);
                    let _e975 = (_e723 * 3f);
                    if (_e974 < _e975) {
                        phi_8661_ = _e974;
                    } else {
                        phi_8661_ = _e975;
                    }
                    let _e978 = phi_8661_;
                    if (_e689 < _e712) {
                        phi_8666_ = _e689;
                    } else {
                        phi_8666_ = _e712;
                    }
                    let _e981 = phi_8666_;
                    if (_e978 < _e981) {
                        phi_8671_ = _e978;
                    } else {
                        phi_8671_ = _e981;
                    }
                    let _e984 = phi_8671_;
                    if (_e974 > _e975) {
                        phi_8676_ = _e974;
                    } else {
                        phi_8676_ = _e975;
                    }
                    let _e987 = phi_8676_;
                    if (_e689 > _e712) {
                        phi_8681_ = _e689;
                    } else {
                        phi_8681_ = _e712;
                    }
                    let _e990 = phi_8681_;
                    if (_e987 > _e990) {
                        phi_8686_ = _e987;
                    } else {
                        phi_8686_ = _e990;
                    }
                    let _e993 = phi_8686_;
                    let _e998 = -(_e993);
                    if (_e984 > _e998) {
                        phi_8696_ = _e984;
                    } else {
                        phi_8696_ = _e998;
                    }
                    let _e1001 = phi_8696_;
                    if ((_e1001 - (_e973 + ((0f * (((_e956 + (_e887 * (0.000000059604645f * 8f))) + ((_e961 * 6f) * (_e831 + _e885))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e831) * (1f + _e885))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15550_ = type_28(0u, type_28().member_1);
                        phi_15551_ = type_28();
                        phi_15552_ = true;
                    } else {
                        if (_e666 < 0f) {
                            phi_8709_ = -(_e666);
                        } else {
                            phi_8709_ = _e666;
                        }
                        let _e1008 = phi_8709_;
                        if (_e689 < 0f) {
                            phi_8715_ = -(_e689);
                        } else {
                            phi_8715_ = _e689;
                        }
                        let _e1012 = phi_8715_;
                        if (_e1008 > _e1012) {
                            phi_8720_ = _e1008;
                        } else {
                            phi_8720_ = _e1012;
                        }
                        let _e1015 = phi_8720_;
                        if (_e712 < 0f) {
                            phi_8726_ = -(_e712);
                        } else {
                            phi_8726_ = _e712;
                        }
                        let _e1019 = phi_8726_;
                        if (_e723 < 0f) {
                            phi_8732_ = -(_e723);
                        } else {
                            phi_8732_ = _e723;
                        }
                        let _e1023 = phi_8732_;
                        if (_e1019 > _e1023) {
                            phi_8737_ = _e1019;
                        } else {
                            phi_8737_ = _e1023;
                        }
                        let _e1026 = phi_8737_;
                        if (_e1015 > _e1026) {
                            phi_8742_ = _e1015;
                        } else {
                            phi_8742_ = _e1026;
                        }
                        let _e1029 = phi_8742_;
                        let _e1030 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1029 >= _e1030) {
                            phi_8750_ = (_e1029 <= (1f / _e1030));
                        } else {
                            phi_8750_ = false;
                        }
                        let _e1035 = phi_8750_;
                        if _e1035 {
                            phi_8755_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8755_ = 2f;
                        }
                        let _e1038 = phi_8755_;
                        let _e1040 = ((_e973 * 0.34f) + (_e1029 * _e1038));
                        if _e1035 {
                            phi_8762_ = (1f / _e1029);
                        } else {
                            phi_8762_ = 0f;
                        }
                        let _e1043 = phi_8762_;
                        let _e1044 = (_e321 * 0.0625f);
                        if (0.00000000000022737368f < _e1044) {
                            phi_8768_ = 0.00000000000022737368f;
                        } else {
                            phi_8768_ = _e1044;
                        }
                        let _e1047 = phi_8768_;
                        let _e1048 = (1f - _e323);
                        let _e1059 = ((((_e666 * _e1048) + (_e689 * _e323)) * (_e1048 * _e1048)) + (((_e712 * _e1048) + (_e723 * _e323)) * (_e323 * _e323)));
                        if (_e1059 < 0f) {
                            phi_8786_ = -(_e1059);
                        } else {
                            phi_8786_ = _e1059;
                        }
                        let _e1063 = phi_8786_;
                        if !((_e1063 > _e1040)) {
                            let _e1068 = local_18.member[0u];
                            let _e1074 = local_18.member_1[0u];
                            let _e1080 = local_18.member_2[0u];
                            let _e1084 = (_e1068[0] - _e1074[0]);
                            let _e1085 = (_e1068[1] - _e1074[1]);
                            let _e1086 = (_e1068[2] - _e1074[2]);
                            let _e1087 = (_e1068[0] - _e1080[0]);
                            let _e1088 = (_e1068[1] - _e1080[1]);
                            let _e1089 = (_e1068[2] - _e1080[2]);
                            let _e1092 = local_18.member[1u];
                            let _e1098 = local_18.member_1[1u];
                            let _e1104 = local_18.member_2[1u];
                            let _e1108 = (_e1092[0] - _e1098[0]);
                            let _e1109 = (_e1092[1] - _e1098[1]);
                            let _e1110 = (_e1092[2] - _e1098[2]);
                            let _e1111 = (_e1092[0] - _e1104[0]);
                            let _e1112 = (_e1092[1] - _e1104[1]);
                            let _e1113 = (_e1092[2] - _e1104[2]);
                            let _e1116 = local_18.member[0u];
                            if (_e1116[0] < 0f) {
                                phi_8934_ = -(_e1116[0]);
                            } else {
                                phi_8934_ = _e1116[0];
                            }
                            let _e1123 = phi_8934_;
                            if (_e1116[1] < 0f) {
                                phi_8941_ = -(_e1116[1]);
                            } else {
                                phi_8941_ = _e1116[1];
                            }
                            let _e1127 = phi_8941_;
                            if (_e1123 > _e1127) {
                                phi_8946_ = _e1123;
                            } else {
                                phi_8946_ = _e1127;
                            }
                            let _e1130 = phi_8946_;
                            if (_e1116[2] < 0f) {
                                phi_8953_ = -(_e1116[2]);
                            } else {
                                phi_8953_ = _e1116[2];
                            }
                            let _e1134 = phi_8953_;
                            if (_e1130 > _e1134) {
                                phi_8958_ = _e1130;
                            } else {
                                phi_8958_ = _e1134;
                            }
                            let _e1137 = phi_8958_;
                            let _e1140 = local_18.member[1u];
                            if (_e1140[0] < 0f) {
                                phi_8971_ = -(_e1140[0]);
                            } else {
                                phi_8971_ = _e1140[0];
                            }
                            let _e1147 = phi_8971_;
                            if (_e1140[1] < 0f) {
                                phi_8978_ = -(_e1140[1]);
                            } else {
                                phi_8978_ = _e1140[1];
                            }
                            let _e1151 = phi_8978_;
                            if (_e1147 > _e1151) {
                                phi_8983_ = _e1147;
                            } else {
                                phi_8983_ = _e1151;
                            }
                            let _e1154 = phi_8983_;
                            if (_e1140[2] < 0f) {
                                phi_8990_ = -(_e1140[2]);
                            } else {
                                phi_8990_ = _e1140[2];
                            }
                            let _e1158 = phi_8990_;
                            if (_e1154 > _e1158) {
                                phi_8995_ = _e1154;
                            } else {
                                phi_8995_ = _e1158;
                            }
                            let _e1161 = phi_8995_;
                            if (_e1137 > _e1161) {
                                phi_9000_ = _e1137;
                            } else {
                                phi_9000_ = _e1161;
                            }
                            let _e1164 = phi_9000_;
                            let _e1166 = local_18.member_3;
                            let _e1170 = local_18.member_1[0u];
                            if (_e1170[0] < 0f) {
                                phi_9017_ = -(_e1170[0]);
                            } else {
                                phi_9017_ = _e1170[0];
                            }
                            let _e1177 = phi_9017_;
                            if (_e1170[1] < 0f) {
                                phi_9024_ = -(_e1170[1]);
                            } else {
                                phi_9024_ = _e1170[1];
                            }
                            let _e1181 = phi_9024_;
                            if (_e1177 > _e1181) {
                                phi_9029_ = _e1177;
                            } else {
                                phi_9029_ = _e1181;
                            }
                            let _e1184 = phi_9029_;
                            if (_e1170[2] < 0f) {
                                phi_9036_ = -(_e1170[2]);
                            } else {
                                phi_9036_ = _e1170[2];
                            }
                            let _e1188 = phi_9036_;
                            if (_e1184 > _e1188) {
                                phi_9041_ = _e1184;
                            } else {
                                phi_9041_ = _e1188;
                            }
                            let _e1191 = phi_9041_;
                            let _e1194 = local_18.member_1[1u];
                            if (_e1194[0] < 0f) {
                                phi_9055_ = -(_e1194[0]);
                            } else {
                                phi_9055_ = _e1194[0];
                            }
                            let _e1201 = phi_9055_;
                            if (_e1194[1] < 0f) {
                                phi_9062_ = -(_e1194[1]);
                            } else {
                                phi_9062_ = _e1194[1];
                            }
                            let _e1205 = phi_9062_;
                            if (_e1201 > _e1205) {
                                phi_9067_ = _e1201;
                            } else {
                                phi_9067_ = _e1205;
                            }
                            let _e1208 = phi_9067_;
                            if (_e1194[2] < 0f) {
                                phi_9074_ = -(_e1194[2]);
                            } else {
                                phi_9074_ = _e1194[2];
                            }
                            let _e1212 = phi_9074_;
                            if (_e1208 > _e1212) {
                                phi_9079_ = _e1208;
                            } else {
                                phi_9079_ = _e1212;
                            }
                            let _e1215 = phi_9079_;
                            if (_e1191 > _e1215) {
                                phi_9084_ = _e1191;
                            } else {
                                phi_9084_ = _e1215;
                            }
                            let _e1218 = phi_9084_;
                            let _e1220 = local_18.member_3;
                            let _e1224 = local_18.member_2[0u];
                            if (_e1224[0] < 0f) {
                                phi_9101_ = -(_e1224[0]);
                            } else {
                                phi_9101_ = _e1224[0];
                            }
                            let _e1231 = phi_9101_;
                            if (_e1224[1] < 0f) {
                                phi_9108_ = -(_e1224[1]);
                            } else {
                                phi_9108_ = _e1224[1];
                            }
                            let _e1235 = phi_9108_;
                            if (_e1231 > _e1235) {
                                phi_9113_ = _e1231;
                            } else {
                                phi_9113_ = _e1235;
                            }
                            let _e1238 = phi_9113_;
                            if (_e1224[2] < 0f) {
                                phi_9120_ = -(_e1224[2]);
                            } else {
                                phi_9120_ = _e1224[2];
                            }
                            let _e1242 = phi_9120_;
                            if (_e1238 > _e1242) {
                                phi_9125_ = _e1238;
                            } else {
                                phi_9125_ = _e1242;
                            }
                            let _e1245 = phi_9125_;
                            let _e1248 = local_18.member_2[1u];
                            if (_e1248[0] < 0f) {
                                phi_9139_ = -(_e1248[0]);
                            } else {
                                phi_9139_ = _e1248[0];
                            }
                            let _e1255 = phi_9139_;
                            if (_e1248[1] < 0f) {
                                phi_9146_ = -(_e1248[1]);
                            } else {
                                phi_9146_ = _e1248[1];
                            }
                            let _e1259 = phi_9146_;
                            if (_e1255 > _e1259) {
                                phi_9151_ = _e1255;
                            } else {
                                phi_9151_ = _e1259;
                            }
                            let _e1262 = phi_9151_;
                            if (_e1248[2] < 0f) {
                                phi_9158_ = -(_e1248[2]);
                            } else {
                                phi_9158_ = _e1248[2];
                            }
                            let _e1266 = phi_9158_;
                            if (_e1262 > _e1266) {
                                phi_9163_ = _e1262;
                            } else {
                                phi_9163_ = _e1266;
                            }
                            let _e1269 = phi_9163_;
                            if (_e1245 > _e1269) {
                                phi_9168_ = _e1245;
                            } else {
                                phi_9168_ = _e1269;
                            }
                            let _e1272 = phi_9168_;
                            let _e1274 = local_18.member_3;
                            let _e1281 = local_18.member_3;
                            let _e1285 = ((((((_e1164 + _e1166) + (_e1218 + _e1220)) + (_e1272 + _e1274)) * (0.000000059604645f * 16f)) + (_e1281 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1288 = local_18.member[0u];
                            let _e1294 = local_18.member[1u];
                            let _e1310 = local_18.member_1[0u];
                            let _e1316 = local_18.member_1[1u];
                            let _e1332 = local_18.member_2[0u];
                            let _e1338 = local_18.member_2[1u];
                            let _e1352 = function_2(array<f32, 3>((_e1288[0] + ((_e1294[0] - _e1288[0]) * _e323)), (_e1288[1] + ((_e1294[1] - _e1288[1]) * _e323)), (_e1288[2] + ((_e1294[2] - _e1288[2]) * _e323))), array<f32, 3>((_e1310[0] + ((_e1316[0] - _e1310[0]) * _e323)), (_e1310[1] + ((_e1316[1] - _e1310[1]) * _e323)), (_e1310[2] + ((_e1316[2] - _e1310[2]) * _e323))), array<f32, 3>((_e1332[0] + ((_e1338[0] - _e1332[0]) * _e323)), (_e1332[1] + ((_e1338[1] - _e1332[1]) * _e323)), (_e1332[2] + ((_e1338[2] - _e1332[2]) * _e323))), 0u);
                            if (_e1352[0] < 0f) {
                                phi_9286_ = -(_e1352[0]);
                            } else {
                                phi_9286_ = _e1352[0];
                            }
                            let _e1357 = phi_9286_;
                            if (_e1352[1] < 0f) {
                                phi_9293_ = -(_e1352[1]);
                            } else {
                                phi_9293_ = _e1352[1];
                            }
                            let _e1362 = phi_9293_;
                            if (_e1352[2] < 0f) {
                                phi_9301_ = -(_e1352[2]);
                            } else {
                                phi_9301_ = _e1352[2];
                            }
                            let _e1368 = phi_9301_;
                            let _e1369 = ((_e1357 + _e1362) + _e1368);
                            if (_e1369 > 0f) {
                                if ((bitcast<u32>(_e1369) & 2139095040u) != 2139095040u) {
                                    let _e1374 = (1f / _e1369);
                                    let _e1376 = (_e1352[0] * _e1374);
                                    let _e1378 = (_e1352[1] * _e1374);
                                    let _e1380 = (_e1352[2] * _e1374);
                                    let _e1385 = (((_e1376 * _e1376) + (_e1378 * _e1378)) + (_e1380 * _e1380));
                                    if (_e1385 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1385 > 0f) {
                                            phi_9338_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_9338_ = 0f;
                                        }
                                        let _e1438 = phi_9338_;
                                        phi_9402_ = _e1438;
                                    } else {
                                        phi_9345_ = type_14(0i, 5i);
                                        phi_9348_ = bitcast<f32>(((bitcast<u32>(_e1385) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1393 = phi_9345_;
                                            let _e1395 = phi_9348_;
                                            local_19 = _e1395;
                                            if (_e1393.member < _e1393.member_1) {
                                                let _e1402 = (_e1393.member + 1i);
                                                if ((false == (_e1402 > _e1393.member)) != false) {
                                                    phi_9369_ = true;
                                                } else {
                                                    phi_9369_ = false;
                                                }
                                                let _e1407 = phi_9369_;
                                                if _e1407 {
                                                    phi_9375_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_9375_ = type_15(1u, _e1402);
                                                }
                                                let _e1412 = phi_9375_;
                                                phi_9346_ = type_14(_e1412.member_1, _e1393.member_1);
                                                phi_9389_ = type_15(1u, _e1393.member);
                                            } else {
                                                phi_9346_ = _e1393;
                                                phi_9389_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1418 = phi_9346_;
                                            let _e1420 = phi_9389_;
                                            let _e1423 = (bitcast<i32>(_e1420.member) != 0i);
                                            if _e1423 {
                                                phi_9349_ = (0.5f * (_e1395 + (_e1385 / _e1395)));
                                            } else {
                                                phi_9349_ = f32();
                                            }
                                            let _e1428 = phi_9349_;
                                            continue;
                                            continuing {
                                                phi_9345_ = _e1418;
                                                phi_9348_ = _e1428;
                                                break if !(_e1423);
                                            }
                                        }
                                        let _e1433 = local_19;
                                        phi_9402_ = (_e1433 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1440 = phi_9402_;
                                    let _e1441 = (0.000000059604645f * 12f);
                                    let _e1446 = ((_e1285 * 1.01f) + ((0f * _e1440) * (1f + _e1441)));
                                    let _e1451 = (((_e1376 * _e1068[0]) + (_e1378 * _e1068[1])) + (_e1380 * _e1068[2]));
                                    let _e1456 = (((_e1376 * _e1084) + (_e1378 * _e1085)) + (_e1380 * _e1086));
                                    let _e1461 = (((_e1376 * _e1087) + (_e1378 * _e1088)) + (_e1380 * _e1089));
                                    let _e1466 = (((_e1376 * _e1068[0]) + (_e1378 * _e1068[1])) + (_e1380 * _e1068[2]));
                                    let _e1472 = (((_e1376 * _e1092[0]) + (_e1378 * _e1092[1])) + (_e1380 * _e1092[2]));
                                    let _e1477 = (((_e1376 * _e1108) + (_e1378 * _e1109)) + (_e1380 * _e1110));
                                    let _e1482 = (((_e1376 * _e1111) + (_e1378 * _e1112)) + (_e1380 * _e1113));
                                    let _e1487 = (((_e1376 * _e1092[0]) + (_e1378 * _e1092[1])) + (_e1380 * _e1092[2]));
                                    if (_e1451 < 0f) {
                                        phi_9468_ = -(_e1451);
                                    } else {
                                        phi_9468_ = _e1451;
                                    }
                                    let _e1492 = phi_9468_;
                                    if (_e1472 < 0f) {
                                        phi_9474_ = -(_e1472);
                                    } else {
                                        phi_9474_ = _e1472;
                                    }
                                    let _e1496 = phi_9474_;
                                    if (_e1456 < 0f) {
                                        phi_9483_ = -(_e1456);
                                    } else {
                                        phi_9483_ = _e1456;
                                    }
                                    let _e1503 = phi_9483_;
                                    if (_e1477 < 0f) {
                                        phi_9489_ = -(_e1477);
                                    } else {
                                        phi_9489_ = _e1477;
                                    }
                                    let _e1507 = phi_9489_;
                                    if (_e1461 < 0f) {
                                        phi_9498_ = -(_e1461);
                                    } else {
                                        phi_9498_ = _e1461;
                                    }
                                    let _e1514 = phi_9498_;
                                    if (_e1482 < 0f) {
                                        phi_9504_ = -(_e1482);
                                    } else {
                                        phi_9504_ = _e1482;
                                    }
                                    let _e1518 = phi_9504_;
                                    if (_e1466 < 0f) {
                                        phi_9513_ = -(_e1466);
                                    } else {
                                        phi_9513_ = _e1466;
                                    }
                                    let _e1525 = phi_9513_;
                                    if (_e1487 < 0f) {
                                        phi_9519_ = -(_e1487);
                                    } else {
                                        phi_9519_ = _e1487;
                                    }
                                    let _e1529 = phi_9519_;
                                    phi_9525_ = type_32(array<f32, 4>(_e1451, _e1456, _e1461, _e1466), array<f32, 4>(_e1472, _e1477, _e1482, _e1487), array<f32, 4>((_e1446 + ((_e1492 + _e1496) * _e1441)), (_e1446 + ((_e1503 + _e1507) * _e1441)), (_e1446 + ((_e1514 + _e1518) * _e1441)), (_e1446 + ((_e1525 + _e1529) * _e1441))));
                                    phi_9526_ = false;
                                } else {
                                    phi_9525_ = type_32();
                                    phi_9526_ = true;
                                }
                                let _e1536 = phi_9525_;
                                let _e1538 = phi_9526_;
                                phi_9527_ = _e1536;
                                phi_9528_ = _e1538;
                            } else {
                                phi_9527_ = type_32();
                                phi_9528_ = true;
                            }
                            let _e1540 = phi_9527_;
                            let _e1542 = phi_9528_;
                            if _e1542 {
                                phi_9536_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_9536_ = _e1540;
                            }
                            let _e1544 = phi_9536_;
                            local_8 = type_32(array<f32, 4>(_e1544.member[0], _e1544.member[1], _e1544.member[2], _e1544.member[3]), array<f32, 4>(_e1544.member_1[0], _e1544.member_1[1], _e1544.member_1[2], _e1544.member_1[3]), array<f32, 4>(_e1544.member_2[0], _e1544.member_2[1], _e1544.member_2[2], _e1544.member_2[3]));
                            let _e1566 = local_8.member[0u];
                            let _e1569 = local_8.member_1[0u];
                            let _e1572 = local_8.member[0u];
                            let _e1578 = local_8.member_2[0u];
                            if (((_e1566 + ((_e1569 - _e1572) * _e323)) - _e1578) > 0f) {
                                let _e1583 = local_8.member[1u];
                                let _e1586 = local_8.member_1[1u];
                                let _e1589 = local_8.member[1u];
                                let _e1595 = local_8.member_2[1u];
                                if (((_e1583 + ((_e1586 - _e1589) * _e323)) - _e1595) > 0f) {
                                    let _e1600 = local_8.member[2u];
                                    let _e1603 = local_8.member_1[2u];
                                    let _e1606 = local_8.member[2u];
                                    let _e1612 = local_8.member_2[2u];
                                    if (((_e1600 + ((_e1603 - _e1606) * _e323)) - _e1612) > 0f) {
                                        let _e1617 = local_8.member[3u];
                                        let _e1620 = local_8.member_1[3u];
                                        let _e1623 = local_8.member[3u];
                                        let _e1629 = local_8.member_2[3u];
                                        phi_9705_ = (((_e1617 + ((_e1620 - _e1623) * _e323)) - _e1629) > 0f);
                                        phi_9706_ = false;
                                    } else {
                                        phi_9705_ = bool();
                                        phi_9706_ = true;
                                    }
                                    let _e1633 = phi_9705_;
                                    let _e1635 = phi_9706_;
                                    phi_9707_ = _e1633;
                                    phi_9708_ = _e1635;
                                } else {
                                    phi_9707_ = bool();
                                    phi_9708_ = true;
                                }
                                let _e1637 = phi_9707_;
                                let _e1639 = phi_9708_;
                                phi_9709_ = _e1637;
                                phi_9710_ = _e1639;
                            } else {
                                phi_9709_ = bool();
                                phi_9710_ = true;
                            }
                            let _e1641 = phi_9709_;
                            let _e1643 = phi_9710_;
                            if _e1643 {
                                phi_9714_ = false;
                            } else {
                                phi_9714_ = _e1641;
                            }
                            let _e1645 = phi_9714_;
                            if _e1645 {
                                phi_11068_ = bool();
                                phi_11069_ = true;
                            } else {
                                if (_e1352[0] < 0f) {
                                    phi_9741_ = -(_e1352[0]);
                                } else {
                                    phi_9741_ = _e1352[0];
                                }
                                let _e1650 = phi_9741_;
                                let _e1652 = ((_e1650 + 0f) + 0f);
                                if (_e1652 > 0f) {
                                    if ((bitcast<u32>(_e1652) & 2139095040u) != 2139095040u) {
                                        let _e1657 = (1f / _e1652);
                                        let _e1658 = (_e1352[0] * _e1657);
                                        let _e1659 = (0f * _e1657);
                                        let _e1660 = (0f * _e1657);
                                        let _e1665 = (((_e1658 * _e1658) + (_e1659 * _e1659)) + (_e1660 * _e1660));
                                        if (_e1665 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1665 > 0f) {
                                                phi_9788_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9788_ = 0f;
                                            }
                                            let _e1718 = phi_9788_;
                                            phi_9852_ = _e1718;
                                        } else {
                                            phi_9795_ = type_14(0i, 5i);
                                            phi_9798_ = bitcast<f32>(((bitcast<u32>(_e1665) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1673 = phi_9795_;
                                                let _e1675 = phi_9798_;
                                                local_20 = _e1675;
                                                if (_e1673.member < _e1673.member_1) {
                                                    let _e1682 = (_e1673.member + 1i);
                                                    if ((false == (_e1682 > _e1673.member)) != false) {
                                                        phi_9819_ = true;
                                                    } else {
                                                        phi_9819_ = false;
                                                    }
                                                    let _e1687 = phi_9819_;
                                                    if _e1687 {
                                                        phi_9825_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9825_ = type_15(1u, _e1682);
                                                    }
                                                    let _e1692 = phi_9825_;
                                                    phi_9796_ = type_14(_e1692.member_1, _e1673.member_1);
                                                    phi_9839_ = type_15(1u, _e1673.member);
                                                } else {
                                                    phi_9796_ = _e1673;
                                                    phi_9839_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1698 = phi_9796_;
                                                let _e1700 = phi_9839_;
                                                let _e1703 = (bitcast<i32>(_e1700.member) != 0i);
                                                if _e1703 {
                                                    phi_9799_ = (0.5f * (_e1675 + (_e1665 / _e1675)));
                                                } else {
                                                    phi_9799_ = f32();
                                                }
                                                let _e1708 = phi_9799_;
                                                continue;
                                                continuing {
                                                    phi_9795_ = _e1698;
                                                    phi_9798_ = _e1708;
                                                    break if !(_e1703);
                                                }
                                            }
                                            let _e1713 = local_20;
                                            phi_9852_ = (_e1713 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1720 = phi_9852_;
                                        let _e1721 = (0.000000059604645f * 12f);
                                        let _e1726 = ((_e1285 * 1.01f) + ((0f * _e1720) * (1f + _e1721)));
                                        let _e1731 = (((_e1658 * _e1068[0]) + (_e1659 * _e1068[1])) + (_e1660 * _e1068[2]));
                                        let _e1736 = (((_e1658 * _e1084) + (_e1659 * _e1085)) + (_e1660 * _e1086));
                                        let _e1741 = (((_e1658 * _e1087) + (_e1659 * _e1088)) + (_e1660 * _e1089));
                                        let _e1746 = (((_e1658 * _e1068[0]) + (_e1659 * _e1068[1])) + (_e1660 * _e1068[2]));
                                        let _e1752 = (((_e1658 * _e1092[0]) + (_e1659 * _e1092[1])) + (_e1660 * _e1092[2]));
                                        let _e1757 = (((_e1658 * _e1108) + (_e1659 * _e1109)) + (_e1660 * _e1110));
                                        let _e1762 = (((_e1658 * _e1111) + (_e1659 * _e1112)) + (_e1660 * _e1113));
                                        let _e1767 = (((_e1658 * _e1092[0]) + (_e1659 * _e1092[1])) + (_e1660 * _e1092[2]));
                                        if (_e1731 < 0f) {
                                            phi_9918_ = -(_e1731);
                                        } else {
                                            phi_9918_ = _e1731;
                                        }
                                        let _e1772 = phi_9918_;
                                        if (_e1752 < 0f) {
                                            phi_9924_ = -(_e1752);
                                        } else {
                                            phi_9924_ = _e1752;
                                        }
                                        let _e1776 = phi_9924_;
                                        if (_e1736 < 0f) {
                                            phi_9933_ = -(_e1736);
                                        } else {
                                            phi_9933_ = _e1736;
                                        }
                                        let _e1783 = phi_9933_;
                                        if (_e1757 < 0f) {
                                            phi_9939_ = -(_e1757);
                                        } else {
                                            phi_9939_ = _e1757;
                                        }
                                        let _e1787 = phi_9939_;
                                        if (_e1741 < 0f) {
                                            phi_9948_ = -(_e1741);
                                        } else {
                                            phi_9948_ = _e1741;
                                        }
                                        let _e1794 = phi_9948_;
                                        if (_e1762 < 0f) {
                                            phi_9954_ = -(_e1762);
                                        } else {
                                            phi_9954_ = _e1762;
                                        }
                                        let _e1798 = phi_9954_;
                                        if (_e1746 < 0f) {
                                            phi_9963_ = -(_e1746);
                                        } else {
                                            phi_9963_ = _e1746;
                                        }
                                        let _e1805 = phi_9963_;
                                        if (_e1767 < 0f) {
                                            phi_9969_ = -(_e1767);
                                        } else {
                                            phi_9969_ = _e1767;
                                        }
                                        let _e1809 = phi_9969_;
                                        phi_9975_ = type_32(array<f32, 4>(_e1731, _e1736, _e1741, _e1746), array<f32, 4>(_e1752, _e1757, _e1762, _e1767), array<f32, 4>((_e1726 + ((_e1772 + _e1776) * _e1721)), (_e1726 + ((_e1783 + _e1787) * _e1721)), (_e1726 + ((_e1794 + _e1798) * _e1721)), (_e1726 + ((_e1805 + _e1809) * _e1721))));
                                        phi_9976_ = false;
                                    } else {
                                        phi_9975_ = type_32();
                                        phi_9976_ = true;
                                    }
                                    let _e1816 = phi_9975_;
                                    let _e1818 = phi_9976_;
                                    phi_9977_ = _e1816;
                                    phi_9978_ = _e1818;
                                } else {
                                    phi_9977_ = type_32();
                                    phi_9978_ = true;
                                }
                                let _e1820 = phi_9977_;
                                let _e1822 = phi_9978_;
                                if _e1822 {
                                    phi_9986_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9986_ = _e1820;
                                }
                                let _e1824 = phi_9986_;
                                local_9 = type_32(array<f32, 4>(_e1824.member[0], _e1824.member[1], _e1824.member[2], _e1824.member[3]), array<f32, 4>(_e1824.member_1[0], _e1824.member_1[1], _e1824.member_1[2], _e1824.member_1[3]), array<f32, 4>(_e1824.member_2[0], _e1824.member_2[1], _e1824.member_2[2], _e1824.member_2[3]));
                                let _e1846 = local_9.member[0u];
                                let _e1849 = local_9.member_1[0u];
                                let _e1852 = local_9.member[0u];
                                let _e1858 = local_9.member_2[0u];
                                if (((_e1846 + ((_e1849 - _e1852) * _e323)) - _e1858) > 0f) {
                                    let _e1863 = local_9.member[1u];
                                    let _e1866 = local_9.member_1[1u];
                                    let _e1869 = local_9.member[1u];
                                    let _e1875 = local_9.member_2[1u];
                                    if (((_e1863 + ((_e1866 - _e1869) * _e323)) - _e1875) > 0f) {
                                        let _e1880 = local_9.member[2u];
                                        let _e1883 = local_9.member_1[2u];
                                        let _e1886 = local_9.member[2u];
                                        let _e1892 = local_9.member_2[2u];
                                        if (((_e1880 + ((_e1883 - _e1886) * _e323)) - _e1892) > 0f) {
                                            let _e1897 = local_9.member[3u];
                                            let _e1900 = local_9.member_1[3u];
                                            let _e1903 = local_9.member[3u];
                                            let _e1909 = local_9.member_2[3u];
                                            phi_10155_ = (((_e1897 + ((_e1900 - _e1903) * _e323)) - _e1909) > 0f);
                                            phi_10156_ = false;
                                        } else {
                                            phi_10155_ = bool();
                                            phi_10156_ = true;
                                        }
                                        let _e1913 = phi_10155_;
                                        let _e1915 = phi_10156_;
                                        phi_10157_ = _e1913;
                                        phi_10158_ = _e1915;
                                    } else {
                                        phi_10157_ = bool();
                                        phi_10158_ = true;
                                    }
                                    let _e1917 = phi_10157_;
                                    let _e1919 = phi_10158_;
                                    phi_10159_ = _e1917;
                                    phi_10160_ = _e1919;
                                } else {
                                    phi_10159_ = bool();
                                    phi_10160_ = true;
                                }
                                let _e1921 = phi_10159_;
                                let _e1923 = phi_10160_;
                                if _e1923 {
                                    phi_10164_ = false;
                                } else {
                                    phi_10164_ = _e1921;
                                }
                                let _e1925 = phi_10164_;
                                if _e1925 {
                                    phi_11066_ = bool();
                                    phi_11067_ = true;
                                } else {
                                    if (_e1352[1] < 0f) {
                                        phi_10197_ = -(_e1352[1]);
                                    } else {
                                        phi_10197_ = _e1352[1];
                                    }
                                    let _e1930 = phi_10197_;
                                    let _e1932 = ((0f + _e1930) + 0f);
                                    if (_e1932 > 0f) {
                                        if ((bitcast<u32>(_e1932) & 2139095040u) != 2139095040u) {
                                            let _e1937 = (1f / _e1932);
                                            let _e1938 = (0f * _e1937);
                                            let _e1939 = (_e1352[1] * _e1937);
                                            let _e1940 = (0f * _e1937);
                                            let _e1945 = (((_e1938 * _e1938) + (_e1939 * _e1939)) + (_e1940 * _e1940));
                                            if (_e1945 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1945 > 0f) {
                                                    phi_10238_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_10238_ = 0f;
                                                }
                                                let _e1998 = phi_10238_;
                                                phi_10302_ = _e1998;
                                            } else {
                                                phi_10245_ = type_14(0i, 5i);
                                                phi_10248_ = bitcast<f32>(((bitcast<u32>(_e1945) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1953 = phi_10245_;
                                                    let _e1955 = phi_10248_;
                                                    local_21 = _e1955;
                                                    if (_e1953.member < _e1953.member_1) {
                                                        let _e1962 = (_e1953.member + 1i);
                                                        if ((false == (_e1962 > _e1953.member)) != false) {
                                                            phi_10269_ = true;
                                                        } else {
                                                            phi_10269_ = false;
                                                        }
                                                        let _e1967 = phi_10269_;
                                                        if _e1967 {
                                                            phi_10275_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_10275_ = type_15(1u, _e1962);
                                                        }
                                                        let _e1972 = phi_10275_;
                                                        phi_10246_ = type_14(_e1972.member_1, _e1953.member_1);
                                                        phi_10289_ = type_15(1u, _e1953.member);
                                                    } else {
                                                        phi_10246_ = _e1953;
                                                        phi_10289_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1978 = phi_10246_;
                                                    let _e1980 = phi_10289_;
                                                    let _e1983 = (bitcast<i32>(_e1980.member) != 0i);
                                                    if _e1983 {
                                                        phi_10249_ = (0.5f * (_e1955 + (_e1945 / _e1955)));
                                                    } else {
                                                        phi_10249_ = f32();
                                                    }
                                                    let _e1988 = phi_10249_;
                                                    continue;
                                                    continuing {
                                                        phi_10245_ = _e1978;
                                                        phi_10248_ = _e1988;
                                                        break if !(_e1983);
                                                    }
                                                }
                                                let _e1993 = local_21;
                                                phi_10302_ = (_e1993 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e2000 = phi_10302_;
                                            let _e2001 = (0.000000059604645f * 12f);
                                            let _e2006 = ((_e1285 * 1.01f) + ((0f * _e2000) * (1f + _e2001)));
                                            let _e2011 = (((_e1938 * _e1068[0]) + (_e1939 * _e1068[1])) + (_e1940 * _e1068[2]));
                                            let _e2016 = (((_e1938 * _e1084) + (_e1939 * _e1085)) + (_e1940 * _e1086));
                                            let _e2021 = (((_e1938 * _e1087) + (_e1939 * _e1088)) + (_e1940 * _e1089));
                                            let _e2026 = (((_e1938 * _e1068[0]) + (_e1939 * _e1068[1])) + (_e1940 * _e1068[2]));
                                            let _e2032 = (((_e1938 * _e1092[0]) + (_e1939 * _e1092[1])) + (_e1940 * _e1092[2]));
                                            let _e2037 = (((_e1938 * _e1108) + (_e1939 * _e1109)) + (_e1940 * _e1110));
                                            let _e2042 = (((_e1938 * _e1111) + (_e1939 * _e1112)) + (_e1940 * _e1113));
                                            let _e2047 = (((_e1938 * _e1092[0]) + (_e1939 * _e1092[1])) + (_e1940 * _e1092[2]));
                                            if (_e2011 < 0f) {
                                                phi_10368_ = -(_e2011);
                                            } else {
                                                phi_10368_ = _e2011;
                                            }
                                            let _e2052 = phi_10368_;
                                            if (_e2032 < 0f) {
                                                phi_10374_ = -(_e2032);
                                            } else {
                                                phi_10374_ = _e2032;
                                            }
                                            let _e2056 = phi_10374_;
                                            if (_e2016 < 0f) {
                                                phi_10383_ = -(_e2016);
                                            } else {
                                                phi_10383_ = _e2016;
                                            }
                                            let _e2063 = phi_10383_;
                                            if (_e2037 < 0f) {
                                                phi_10389_ = -(_e2037);
                                            } else {
                                                phi_10389_ = _e2037;
                                            }
                                            let _e2067 = phi_10389_;
                                            if (_e2021 < 0f) {
                                                phi_10398_ = -(_e2021);
                                            } else {
                                                phi_10398_ = _e2021;
                                            }
                                            let _e2074 = phi_10398_;
                                            if (_e2042 < 0f) {
                                                phi_10404_ = -(_e2042);
                                            } else {
                                                phi_10404_ = _e2042;
                                            }
                                            let _e2078 = phi_10404_;
                                            if (_e2026 < 0f) {
                                                phi_10413_ = -(_e2026);
                                            } else {
                                                phi_10413_ = _e2026;
                                            }
                                            let _e2085 = phi_10413_;
                                            if (_e2047 < 0f) {
                                                phi_10419_ = -(_e2047);
                                            } else {
                                                phi_10419_ = _e2047;
                                            }
                                            let _e2089 = phi_10419_;
                                            phi_10425_ = type_32(array<f32, 4>(_e2011, _e2016, _e2021, _e2026), array<f32, 4>(_e2032, _e2037, _e2042, _e2047), array<f32, 4>((_e2006 + ((_e2052 + _e2056) * _e2001)), (_e2006 + ((_e2063 + _e2067) * _e2001)), (_e2006 + ((_e2074 + _e2078) * _e2001)), (_e2006 + ((_e2085 + _e2089) * _e2001))));
                                            phi_10426_ = false;
                                        } else {
                                            phi_10425_ = type_32();
                                            phi_10426_ = true;
                                        }
                                        let _e2096 = phi_10425_;
                                        let _e2098 = phi_10426_;
                                        phi_10427_ = _e2096;
                                        phi_10428_ = _e2098;
                                    } else {
                                        phi_10427_ = type_32();
                                        phi_10428_ = true;
                                    }
                                    let _e2100 = phi_10427_;
                                    let _e2102 = phi_10428_;
                                    if _e2102 {
                                        phi_10436_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_10436_ = _e2100;
                                    }
                                    let _e2104 = phi_10436_;
                                    local_10 = type_32(array<f32, 4>(_e2104.member[0], _e2104.member[1], _e2104.member[2], _e2104.member[3]), array<f32, 4>(_e2104.member_1[0], _e2104.member_1[1], _e2104.member_1[2], _e2104.member_1[3]), array<f32, 4>(_e2104.member_2[0], _e2104.member_2[1], _e2104.member_2[2], _e2104.member_2[3]));
                                    let _e2126 = local_10.member[0u];
                                    let _e2129 = local_10.member_1[0u];
                                    let _e2132 = local_10.member[0u];
                                    let _e2138 = local_10.member_2[0u];
                                    if (((_e2126 + ((_e2129 - _e2132) * _e323)) - _e2138) > 0f) {
                                        let _e2143 = local_10.member[1u];
                                        let _e2146 = local_10.member_1[1u];
                                        let _e2149 = local_10.member[1u];
                                        let _e2155 = local_10.member_2[1u];
                                        if (((_e2143 + ((_e2146 - _e2149) * _e323)) - _e2155) > 0f) {
                                            let _e2160 = local_10.member[2u];
                                            let _e2163 = local_10.member_1[2u];
                                            let _e2166 = local_10.member[2u];
                                            let _e2172 = local_10.member_2[2u];
                                            if (((_e2160 + ((_e2163 - _e2166) * _e323)) - _e2172) > 0f) {
                                                let _e2177 = local_10.member[3u];
                                                let _e2180 = local_10.member_1[3u];
                                                let _e2183 = local_10.member[3u];
                                                let _e2189 = local_10.member_2[3u];
                                                phi_10605_ = (((_e2177 + ((_e2180 - _e2183) * _e323)) - _e2189) > 0f);
                                                phi_10606_ = false;
                                            } else {
                                                phi_10605_ = bool();
                                                phi_10606_ = true;
                                            }
                                            let _e2193 = phi_10605_;
                                            let _e2195 = phi_10606_;
                                            phi_10607_ = _e2193;
                                            phi_10608_ = _e2195;
                                        } else {
                                            phi_10607_ = bool();
                                            phi_10608_ = true;
                                        }
                                        let _e2197 = phi_10607_;
                                        let _e2199 = phi_10608_;
                                        phi_10609_ = _e2197;
                                        phi_10610_ = _e2199;
                                    } else {
                                        phi_10609_ = bool();
                                        phi_10610_ = true;
                                    }
                                    let _e2201 = phi_10609_;
                                    let _e2203 = phi_10610_;
                                    if _e2203 {
                                        phi_10614_ = false;
                                    } else {
                                        phi_10614_ = _e2201;
                                    }
                                    let _e2205 = phi_10614_;
                                    if _e2205 {
                                        phi_11065_ = bool();
                                    } else {
                                        if (_e1352[2] < 0f) {
                                            phi_10654_ = -(_e1352[2]);
                                        } else {
                                            phi_10654_ = _e1352[2];
                                        }
                                        let _e2211 = phi_10654_;
                                        let _e2212 = ((0f + 0f) + _e2211);
                                        if (_e2212 > 0f) {
                                            if ((bitcast<u32>(_e2212) & 2139095040u) != 2139095040u) {
                                                let _e2217 = (1f / _e2212);
                                                let _e2218 = (0f * _e2217);
                                                let _e2219 = (0f * _e2217);
                                                let _e2220 = (_e1352[2] * _e2217);
                                                let _e2225 = (((_e2218 * _e2218) + (_e2219 * _e2219)) + (_e2220 * _e2220));
                                                if (_e2225 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2225 > 0f) {
                                                        phi_10688_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10688_ = 0f;
                                                    }
                                                    let _e2278 = phi_10688_;
                                                    phi_10752_ = _e2278;
                                                } else {
                                                    phi_10695_ = type_14(0i, 5i);
                                                    phi_10698_ = bitcast<f32>(((bitcast<u32>(_e2225) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2233 = phi_10695_;
                                                        let _e2235 = phi_10698_;
                                                        local_22 = _e2235;
                                                        if (_e2233.member < _e2233.member_1) {
                                                            let _e2242 = (_e2233.member + 1i);
                                                            if ((false == (_e2242 > _e2233.member)) != false) {
                                                                phi_10719_ = true;
                                                            } else {
                                                                phi_10719_ = false;
                                                            }
                                                            let _e2247 = phi_10719_;
                                                            if _e2247 {
                                                                phi_10725_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10725_ = type_15(1u, _e2242);
                                                            }
                                                            let _e2252 = phi_10725_;
                                                            phi_10696_ = type_14(_e2252.member_1, _e2233.member_1);
                                                            phi_10739_ = type_15(1u, _e2233.member);
                                                        } else {
                                                            phi_10696_ = _e2233;
                                                            phi_10739_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2258 = phi_10696_;
                                                        let _e2260 = phi_10739_;
                                                        let _e2263 = (bitcast<i32>(_e2260.member) != 0i);
                                                        if _e2263 {
                                                            phi_10699_ = (0.5f * (_e2235 + (_e2225 / _e2235)));
                                                        } else {
                                                            phi_10699_ = f32();
                                                        }
                                                        let _e2268 = phi_10699_;
                                                        continue;
                                                        continuing {
                                                            phi_10695_ = _e2258;
                                                            phi_10698_ = _e2268;
                                                            break if !(_e2263);
                                                        }
                                                    }
                                                    let _e2273 = local_22;
                                                    phi_10752_ = (_e2273 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2280 = phi_10752_;
                                                let _e2281 = (0.000000059604645f * 12f);
                                                let _e2286 = ((_e1285 * 1.01f) + ((0f * _e2280) * (1f + _e2281)));
                                                let _e2291 = (((_e2218 * _e1068[0]) + (_e2219 * _e1068[1])) + (_e2220 * _e1068[2]));
                                                let _e2296 = (((_e2218 * _e1084) + (_e2219 * _e1085)) + (_e2220 * _e1086));
                                                let _e2301 = (((_e2218 * _e1087) + (_e2219 * _e1088)) + (_e2220 * _e1089));
                                                let _e2306 = (((_e2218 * _e1068[0]) + (_e2219 * _e1068[1])) + (_e2220 * _e1068[2]));
                                                let _e2312 = (((_e2218 * _e1092[0]) + (_e2219 * _e1092[1])) + (_e2220 * _e1092[2]));
                                                let _e2317 = (((_e2218 * _e1108) + (_e2219 * _e1109)) + (_e2220 * _e1110));
                                                let _e2322 = (((_e2218 * _e1111) + (_e2219 * _e1112)) + (_e2220 * _e1113));
                                                let _e2327 = (((_e2218 * _e1092[0]) + (_e2219 * _e1092[1])) + (_e2220 * _e1092[2]));
                                                if (_e2291 < 0f) {
                                                    phi_10818_ = -(_e2291);
                                                } else {
                                                    phi_10818_ = _e2291;
                                                }
                                                let _e2332 = phi_10818_;
                                                if (_e2312 < 0f) {
                                                    phi_10824_ = -(_e2312);
                                                } else {
                                                    phi_10824_ = _e2312;
                                                }
                                                let _e2336 = phi_10824_;
                                                if (_e2296 < 0f) {
                                                    phi_10833_ = -(_e2296);
                                                } else {
                                                    phi_10833_ = _e2296;
                                                }
                                                let _e2343 = phi_10833_;
                                                if (_e2317 < 0f) {
                                                    phi_10839_ = -(_e2317);
                                                } else {
                                                    phi_10839_ = _e2317;
                                                }
                                                let _e2347 = phi_10839_;
                                                if (_e2301 < 0f) {
                                                    phi_10848_ = -(_e2301);
                                                } else {
                                                    phi_10848_ = _e2301;
                                                }
                                                let _e2354 = phi_10848_;
                                                if (_e2322 < 0f) {
                                                    phi_10854_ = -(_e2322);
                                                } else {
                                                    phi_10854_ = _e2322;
                                                }
                                                let _e2358 = phi_10854_;
                                                if (_e2306 < 0f) {
                                                    phi_10863_ = -(_e2306);
                                                } else {
                                                    phi_10863_ = _e2306;
                                                }
                                                let _e2365 = phi_10863_;
                                                if (_e2327 < 0f) {
                                                    phi_10869_ = -(_e2327);
                                                } else {
                                                    phi_10869_ = _e2327;
                                                }
                                                let _e2369 = phi_10869_;
                                                phi_10875_ = type_32(array<f32, 4>(_e2291, _e2296, _e2301, _e2306), array<f32, 4>(_e2312, _e2317, _e2322, _e2327), array<f32, 4>((_e2286 + ((_e2332 + _e2336) * _e2281)), (_e2286 + ((_e2343 + _e2347) * _e2281)), (_e2286 + ((_e2354 + _e2358) * _e2281)), (_e2286 + ((_e2365 + _e2369) * _e2281))));
                                                phi_10876_ = false;
                                            } else {
                                                phi_10875_ = type_32();
                                                phi_10876_ = true;
                                            }
                                            let _e2376 = phi_10875_;
                                            let _e2378 = phi_10876_;
                                            phi_10877_ = _e2376;
                                            phi_10878_ = _e2378;
                                        } else {
                                            phi_10877_ = type_32();
                                            phi_10878_ = true;
                                        }
                                        let _e2380 = phi_10877_;
                                        let _e2382 = phi_10878_;
                                        if _e2382 {
                                            phi_10886_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10886_ = _e2380;
                                        }
                                        let _e2384 = phi_10886_;
                                        local_11 = type_32(array<f32, 4>(_e2384.member[0], _e2384.member[1], _e2384.member[2], _e2384.member[3]), array<f32, 4>(_e2384.member_1[0], _e2384.member_1[1], _e2384.member_1[2], _e2384.member_1[3]), array<f32, 4>(_e2384.member_2[0], _e2384.member_2[1], _e2384.member_2[2], _e2384.member_2[3]));
                                        let _e2406 = local_11.member[0u];
                                        let _e2409 = local_11.member_1[0u];
                                        let _e2412 = local_11.member[0u];
                                        let _e2418 = local_11.member_2[0u];
                                        if (((_e2406 + ((_e2409 - _e2412) * _e323)) - _e2418) > 0f) {
                                            let _e2423 = local_11.member[1u];
                                            let _e2426 = local_11.member_1[1u];
                                            let _e2429 = local_11.member[1u];
                                            let _e2435 = local_11.member_2[1u];
                                            if (((_e2423 + ((_e2426 - _e2429) * _e323)) - _e2435) > 0f) {
                                                let _e2440 = local_11.member[2u];
                                                let _e2443 = local_11.member_1[2u];
                                                let _e2446 = local_11.member[2u];
                                                let _e2452 = local_11.member_2[2u];
                                                if (((_e2440 + ((_e2443 - _e2446) * _e323)) - _e2452) > 0f) {
                                                    let _e2457 = local_11.member[3u];
                                                    let _e2460 = local_11.member_1[3u];
                                                    let _e2463 = local_11.member[3u];
                                                    let _e2469 = local_11.member_2[3u];
                                                    phi_11055_ = (((_e2457 + ((_e2460 - _e2463) * _e323)) - _e2469) > 0f);
                                                    phi_11056_ = false;
                                                } else {
                                                    phi_11055_ = bool();
                                                    phi_11056_ = true;
                                                }
                                                let _e2473 = phi_11055_;
                                                let _e2475 = phi_11056_;
                                                phi_11057_ = _e2473;
                                                phi_11058_ = _e2475;
                                            } else {
                                                phi_11057_ = bool();
                                                phi_11058_ = true;
                                            }
                                            let _e2477 = phi_11057_;
                                            let _e2479 = phi_11058_;
                                            phi_11059_ = _e2477;
                                            phi_11060_ = _e2479;
                                        } else {
                                            phi_11059_ = bool();
                                            phi_11060_ = true;
                                        }
                                        let _e2481 = phi_11059_;
                                        let _e2483 = phi_11060_;
                                        if _e2483 {
                                            phi_11064_ = false;
                                        } else {
                                            phi_11064_ = _e2481;
                                        }
                                        let _e2485 = phi_11064_;
                                        phi_11065_ = _e2485;
                                    }
                                    let _e2487 = phi_11065_;
                                    phi_11066_ = _e2487;
                                    phi_11067_ = _e2205;
                                }
                                let _e2489 = phi_11066_;
                                let _e2491 = phi_11067_;
                                phi_11068_ = _e2489;
                                phi_11069_ = _e2491;
                            }
                            let _e2493 = phi_11068_;
                            let _e2495 = phi_11069_;
                            if _e2495 {
                                phi_11073_ = true;
                            } else {
                                phi_11073_ = _e2493;
                            }
                            let _e2497 = phi_11073_;
                            if !(_e2497) {
                                phi_11079_ = type_28(2u, _e323);
                                phi_11080_ = false;
                            } else {
                                phi_11079_ = type_28();
                                phi_11080_ = true;
                            }
                            let _e2501 = phi_11079_;
                            let _e2503 = phi_11080_;
                            phi_11081_ = _e2501;
                            phi_11082_ = _e2503;
                        } else {
                            phi_11081_ = type_28();
                            phi_11082_ = true;
                        }
                        let _e2505 = phi_11081_;
                        let _e2507 = phi_11082_;
                        if _e2507 {
                            let _e2513 = ((_e689 - (3f * _e666)) * _e1043);
                            let _e2514 = ((_e712 - _e689) * _e1043);
                            let _e2515 = (((3f * _e723) - _e712) * _e1043);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2522 = ((_e2514 * _e2514) - (_e2513 * _e2515));
                            if (_e2522 > 0f) {
                                if (_e2522 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2522 > 0f) {
                                        phi_11118_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_11118_ = 0f;
                                    }
                                    let _e2576 = phi_11118_;
                                    phi_11182_ = _e2576;
                                } else {
                                    phi_11125_ = type_14(0i, 5i);
                                    phi_11128_ = bitcast<f32>(((bitcast<u32>(_e2522) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2531 = phi_11125_;
                                        let _e2533 = phi_11128_;
                                        local_23 = _e2533;
                                        if (_e2531.member < _e2531.member_1) {
                                            let _e2540 = (_e2531.member + 1i);
                                            if ((false == (_e2540 > _e2531.member)) != false) {
                                                phi_11149_ = true;
                                            } else {
                                                phi_11149_ = false;
                                            }
                                            let _e2545 = phi_11149_;
                                            if _e2545 {
                                                phi_11155_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_11155_ = type_15(1u, _e2540);
                                            }
                                            let _e2550 = phi_11155_;
                                            phi_11126_ = type_14(_e2550.member_1, _e2531.member_1);
                                            phi_11169_ = type_15(1u, _e2531.member);
                                        } else {
                                            phi_11126_ = _e2531;
                                            phi_11169_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2556 = phi_11126_;
                                        let _e2558 = phi_11169_;
                                        let _e2561 = (bitcast<i32>(_e2558.member) != 0i);
                                        if _e2561 {
                                            phi_11129_ = (0.5f * (_e2533 + (_e2522 / _e2533)));
                                        } else {
                                            phi_11129_ = f32();
                                        }
                                        let _e2566 = phi_11129_;
                                        continue;
                                        continuing {
                                            phi_11125_ = _e2556;
                                            phi_11128_ = _e2566;
                                            break if !(_e2561);
                                        }
                                    }
                                    let _e2571 = local_23;
                                    phi_11182_ = (_e2571 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2578 = phi_11182_;
                                if (_e2514 < 0f) {
                                    phi_11188_ = -(_e2578);
                                } else {
                                    phi_11188_ = _e2578;
                                }
                                let _e2582 = phi_11188_;
                                let _e2584 = -((_e2514 + _e2582));
                                local_7[0u] = (_e2584 / (_e2584 + _e2515));
                                local_7[1u] = (_e2513 / (_e2513 + _e2584));
                                let _e2593 = local_7[1u];
                                let _e2594 = local_7[0u];
                                if (_e2593 < _e2594) {
                                    let _e2597 = local_7[1u];
                                    let _e2599 = local_7[0u];
                                    local_7[0u] = _e2597;
                                    local_7[1u] = _e2599;
                                }
                                phi_11213_ = type_12(0u, 2u);
                                phi_11216_ = 1u;
                                loop {
                                    let _e2603 = phi_11213_;
                                    let _e2605 = phi_11216_;
                                    local_63 = _e2605;
                                    if (_e2603.member < _e2603.member_1) {
                                        phi_11214_ = type_12((_e2603.member + 1u), _e2603.member_1);
                                        phi_11239_ = type_12(1u, _e2603.member);
                                    } else {
                                        phi_11214_ = _e2603;
                                        phi_11239_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2617 = phi_11214_;
                                    let _e2619 = phi_11239_;
                                    let _e2623 = (bitcast<i32>(_e2619.member) != 0i);
                                    if _e2623 {
                                        let _e2625 = local_7[_e2619.member_1];
                                        if (_e2625 > 0f) {
                                            let _e2628 = local_7[_e2619.member_1];
                                            if (_e2628 < 1f) {
                                                let _e2631 = local_7[_e2619.member_1];
                                                local_6[_e2605] = _e2631;
                                                phi_11283_ = (_e2605 + 1u);
                                            } else {
                                                phi_11283_ = _e2605;
                                            }
                                            let _e2635 = phi_11283_;
                                            phi_11284_ = _e2635;
                                        } else {
                                            phi_11284_ = _e2605;
                                        }
                                        let _e2637 = phi_11284_;
                                        phi_11217_ = _e2637;
                                    } else {
                                        phi_11217_ = u32();
                                    }
                                    let _e2639 = phi_11217_;
                                    continue;
                                    continuing {
                                        phi_11213_ = _e2617;
                                        phi_11216_ = _e2639;
                                        break if !(_e2623);
                                    }
                                }
                                let _e10186 = local_63;
                                phi_11285_ = _e10186;
                            } else {
                                phi_11285_ = 1u;
                            }
                            let _e2642 = phi_11285_;
                            local_6[_e2642] = 1f;
                            let _e2644 = local_6;
                            local_12 = _e2644;
                            phi_11305_ = type_12(0u, _e2642);
                            loop {
                                let _e2647 = phi_11305_;
                                if (_e2647.member < _e2647.member_1) {
                                    phi_11306_ = type_12((_e2647.member + 1u), _e2647.member_1);
                                    phi_11329_ = type_12(1u, _e2647.member);
                                } else {
                                    phi_11306_ = _e2647;
                                    phi_11329_ = type_12(0u, type_12().member_1);
                                }
                                let _e2659 = phi_11306_;
                                let _e2661 = phi_11329_;
                                if (bitcast<i32>(_e2661.member) != 0i) {
                                    let _e2667 = local_12[_e2661.member_1];
                                    if (_e2667 > _e323) {
                                        phi_11348_ = _e2667;
                                    } else {
                                        phi_11348_ = _e323;
                                    }
                                    let _e2670 = phi_11348_;
                                    let _e2673 = local_12[(_e2661.member_1 + 1u)];
                                    if (_e2673 < _e325) {
                                        phi_11361_ = _e2673;
                                    } else {
                                        phi_11361_ = _e325;
                                    }
                                    let _e2676 = phi_11361_;
                                    if (_e2670 <= _e2676) {
                                        let _e2678 = (1f - _e2670);
                                        let _e2689 = ((((_e666 * _e2678) + (_e689 * _e2670)) * (_e2678 * _e2678)) + (((_e712 * _e2678) + (_e723 * _e2670)) * (_e2670 * _e2670)));
                                        let _e2690 = (1f - _e2676);
                                        let _e2701 = ((((_e666 * _e2690) + (_e689 * _e2676)) * (_e2690 * _e2690)) + (((_e712 * _e2690) + (_e723 * _e2676)) * (_e2676 * _e2676)));
                                        if (_e2689 < 0f) {
                                            phi_11395_ = -(_e2689);
                                        } else {
                                            phi_11395_ = _e2689;
                                        }
                                        let _e2705 = phi_11395_;
                                        let _e2706 = (_e2705 > _e1040);
                                        if (_e2701 < 0f) {
                                            phi_11402_ = -(_e2701);
                                        } else {
                                            phi_11402_ = _e2701;
                                        }
                                        let _e2710 = phi_11402_;
                                        let _e2711 = (_e2710 > _e1040);
                                        if _e2706 {
                                            if _e2711 {
                                                phi_11413_ = ((_e2689 > 0f) != (_e2701 > 0f));
                                                phi_11414_ = false;
                                            } else {
                                                phi_11413_ = bool();
                                                phi_11414_ = true;
                                            }
                                            let _e2716 = phi_11413_;
                                            let _e2718 = phi_11414_;
                                            phi_11415_ = _e2716;
                                            phi_11416_ = _e2718;
                                        } else {
                                            phi_11415_ = bool();
                                            phi_11416_ = true;
                                        }
                                        let _e2720 = phi_11415_;
                                        let _e2722 = phi_11416_;
                                        if _e2722 {
                                            phi_11420_ = false;
                                        } else {
                                            phi_11420_ = _e2720;
                                        }
                                        let _e2724 = phi_11420_;
                                        if _e2706 {
                                            if _e2711 {
                                                if _e2724 {
                                                    phi_11431_ = type_41();
                                                } else {
                                                    phi_11431_ = type_41(1f, 0f, _e2724);
                                                }
                                                let _e2727 = phi_11431_;
                                                phi_11432_ = _e2727;
                                                phi_11433_ = _e2724;
                                            } else {
                                                phi_11432_ = type_41();
                                                phi_11433_ = true;
                                            }
                                            let _e2729 = phi_11432_;
                                            let _e2731 = phi_11433_;
                                            phi_11434_ = _e2729;
                                            phi_11435_ = _e2731;
                                        } else {
                                            phi_11434_ = type_41();
                                            phi_11435_ = true;
                                        }
                                        let _e2733 = phi_11434_;
                                        let _e2735 = phi_11435_;
                                        if _e2735 {
                                            if _e2706 {
                                                if (_e2689 < 0f) {
                                                    phi_11446_ = -1f;
                                                } else {
                                                    phi_11446_ = 1f;
                                                }
                                                let _e2738 = phi_11446_;
                                                let _e2741 = (_e712 - _e689);
                                                phi_11456_ = type_12(0u, 64u);
                                                phi_11459_ = _e2676;
                                                phi_11461_ = _e2670;
                                                phi_11463_ = (0.5f * (_e2670 + _e2676));
                                                loop {
                                                    let _e2747 = phi_11456_;
                                                    let _e2749 = phi_11459_;
                                                    let _e2751 = phi_11461_;
                                                    let _e2753 = phi_11463_;
                                                    local_65 = _e2751;
                                                    if (_e2747.member < _e2747.member_1) {
                                                        phi_11457_ = type_12((_e2747.member + 1u), _e2747.member_1);
                                                        phi_11486_ = type_12(1u, _e2747.member);
                                                    } else {
                                                        phi_11457_ = _e2747;
                                                        phi_11486_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2765 = phi_11457_;
                                                    let _e2767 = phi_11486_;
                                                    if (bitcast<i32>(_e2767.member) != 0i) {
                                                        let _e2771 = (1f - _e2753);
                                                        let _e2784 = ((_e2738 * ((((_e666 * _e2771) + (_e689 * _e2753)) * (_e2771 * _e2771)) + (((_e712 * _e2771) + (_e723 * _e2753)) * (_e2753 * _e2753)))) - _e1040);
                                                        if (_e2784 > 0f) {
                                                            phi_11511_ = _e2749;
                                                            phi_11512_ = _e2753;
                                                        } else {
                                                            phi_11511_ = _e2753;
                                                            phi_11512_ = _e2751;
                                                        }
                                                        let _e2787 = phi_11511_;
                                                        let _e2789 = phi_11512_;
                                                        let _e2791 = ((_e2787 - _e2789) > _e1047);
                                                        if _e2791 {
                                                            let _e2792 = (1f - _e2753);
                                                            let _e2804 = (-(_e2784) / (_e2738 * (((((_e689 - (3f * _e666)) * _e2792) + (_e2741 * _e2753)) * _e2792) + (((_e2741 * _e2792) + (((3f * _e723) - _e712) * _e2753)) * _e2753))));
                                                            if (_e2784 > 0f) {
                                                                phi_11538_ = (0.5f * _e1047);
                                                            } else {
                                                                phi_11538_ = -((0.5f * _e1047));
                                                            }
                                                            let _e2810 = phi_11538_;
                                                            let _e2812 = ((_e2753 + _e2804) + _e2810);
                                                            if (_e2812 > _e2789) {
                                                                if (_e2812 < _e2787) {
                                                                    if (_e2804 < 0f) {
                                                                        phi_11554_ = -(_e2804);
                                                                    } else {
                                                                        phi_11554_ = _e2804;
                                                                    }
                                                                    let _e2818 = phi_11554_;
                                                                    if (_e2818 < (0.5f * (_e2787 - _e2789))) {
                                                                        phi_11561_ = false;
                                                                    } else {
                                                                        phi_11561_ = true;
                                                                    }
                                                                    let _e2823 = phi_11561_;
                                                                    phi_11562_ = _e2823;
                                                                } else {
                                                                    phi_11562_ = true;
                                                                }
                                                                let _e2825 = phi_11562_;
                                                                phi_11563_ = _e2825;
                                                            } else {
                                                                phi_11563_ = true;
                                                            }
                                                            let _e2827 = phi_11563_;
                                                            if _e2827 {
                                                                phi_11569_ = (0.5f * (_e2789 + _e2787));
                                                            } else {
                                                                phi_11569_ = _e2812;
                                                            }
                                                            let _e2831 = phi_11569_;
                                                            phi_11570_ = _e2831;
                                                            phi_11571_ = false;
                                                        } else {
                                                            phi_11570_ = f32();
                                                            phi_11571_ = true;
                                                        }
                                                        let _e2833 = phi_11570_;
                                                        let _e2835 = phi_11571_;
                                                        phi_11460_ = _e2787;
                                                        phi_11462_ = _e2789;
                                                        phi_11464_ = _e2833;
                                                        phi_11572_ = _e2789;
                                                        phi_11573_ = _e2791;
                                                        phi_11574_ = _e2835;
                                                    } else {
                                                        phi_11460_ = f32();
                                                        phi_11462_ = f32();
                                                        phi_11464_ = f32();
                                                        phi_11572_ = f32();
                                                        phi_11573_ = false;
                                                        phi_11574_ = false;
                                                    }
                                                    let _e2837 = phi_11460_;
                                                    let _e2839 = phi_11462_;
                                                    let _e2841 = phi_11464_;
                                                    let _e2843 = phi_11572_;
                                                    let _e2845 = phi_11573_;
                                                    let _e2847 = phi_11574_;
                                                    local_24 = _e2847;
                                                    local_64 = _e2843;
                                                    continue;
                                                    continuing {
                                                        phi_11456_ = _e2765;
                                                        phi_11459_ = _e2837;
                                                        phi_11461_ = _e2839;
                                                        phi_11463_ = _e2841;
                                                        break if !(_e2845);
                                                    }
                                                }
                                                let _e2850 = local_24;
                                                if _e2850 {
                                                    let _e10230 = local_64;
                                                    phi_11578_ = _e10230;
                                                } else {
                                                    let _e10232 = local_65;
                                                    phi_11578_ = _e10232;
                                                }
                                                let _e2852 = phi_11578_;
                                                phi_11579_ = _e2852;
                                            } else {
                                                phi_11579_ = _e2670;
                                            }
                                            let _e2854 = phi_11579_;
                                            if _e2711 {
                                                if (_e2701 < 0f) {
                                                    phi_11587_ = -1f;
                                                } else {
                                                    phi_11587_ = 1f;
                                                }
                                                let _e2857 = phi_11587_;
                                                phi_11591_ = type_12(0u, 64u);
                                                phi_11594_ = (_e1047 + _e1047);
                                                loop {
                                                    let _e2860 = phi_11591_;
                                                    let _e2862 = phi_11594_;
                                                    if (_e2860.member < _e2860.member_1) {
                                                        phi_11592_ = type_12((_e2860.member + 1u), _e2860.member_1);
                                                        phi_11617_ = type_12(1u, _e2860.member);
                                                    } else {
                                                        phi_11592_ = _e2860;
                                                        phi_11617_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2874 = phi_11592_;
                                                    let _e2876 = phi_11617_;
                                                    if (bitcast<i32>(_e2876.member) != 0i) {
                                                        let _e2880 = (_e2854 + _e2862);
                                                        if (_e2880 < _e2676) {
                                                            let _e2882 = (1f - _e2880);
                                                            let _e2895 = ((_e2857 * ((((_e666 * _e2882) + (_e689 * _e2880)) * (_e2882 * _e2882)) + (((_e712 * _e2882) + (_e723 * _e2880)) * (_e2880 * _e2880)))) > _e1040);
                                                            if _e2895 {
                                                                phi_11647_ = f32();
                                                                phi_11648_ = false;
                                                            } else {
                                                                phi_11647_ = (_e2862 + _e2862);
                                                                phi_11648_ = true;
                                                            }
                                                            let _e2898 = phi_11647_;
                                                            let _e2900 = phi_11648_;
                                                            phi_11649_ = _e2898;
                                                            phi_11650_ = _e2900;
                                                            phi_11651_ = _e2895;
                                                            phi_11652_ = false;
                                                        } else {
                                                            phi_11649_ = f32();
                                                            phi_11650_ = false;
                                                            phi_11651_ = false;
                                                            phi_11652_ = true;
                                                        }
                                                        let _e2902 = phi_11649_;
                                                        let _e2904 = phi_11650_;
                                                        let _e2906 = phi_11651_;
                                                        let _e2908 = phi_11652_;
                                                        phi_11653_ = _e2880;
                                                        phi_11595_ = _e2902;
                                                        phi_11654_ = _e2904;
                                                        phi_11655_ = _e2906;
                                                        phi_11656_ = _e2908;
                                                        phi_11657_ = false;
                                                    } else {
                                                        phi_11653_ = f32();
                                                        phi_11595_ = f32();
                                                        phi_11654_ = false;
                                                        phi_11655_ = false;
                                                        phi_11656_ = false;
                                                        phi_11657_ = true;
                                                    }
                                                    let _e2910 = phi_11653_;
                                                    let _e2912 = phi_11595_;
                                                    let _e2914 = phi_11654_;
                                                    let _e2916 = phi_11655_;
                                                    let _e2918 = phi_11656_;
                                                    let _e2920 = phi_11657_;
                                                    local_25 = _e2916;
                                                    local_66 = _e2918;
                                                    local_67 = _e2920;
                                                    local_68 = _e2910;
                                                    continue;
                                                    continuing {
                                                        phi_11591_ = _e2874;
                                                        phi_11594_ = _e2912;
                                                        break if !(_e2914);
                                                    }
                                                }
                                                let _e2923 = local_25;
                                                if _e2923 {
                                                    phi_11661_ = false;
                                                    phi_11662_ = false;
                                                } else {
                                                    let _e10254 = local_66;
                                                    phi_11661_ = _e10254;
                                                    let _e10257 = local_67;
                                                    phi_11662_ = _e10257;
                                                }
                                                let _e2925 = phi_11661_;
                                                let _e2927 = phi_11662_;
                                                if _e2925 {
                                                    phi_11666_ = true;
                                                } else {
                                                    phi_11666_ = _e2927;
                                                }
                                                let _e2929 = phi_11666_;
                                                if _e2929 {
                                                    phi_11670_ = _e2676;
                                                } else {
                                                    let _e10261 = local_68;
                                                    phi_11670_ = _e10261;
                                                }
                                                let _e2931 = phi_11670_;
                                                phi_11671_ = _e2931;
                                            } else {
                                                phi_11671_ = _e2676;
                                            }
                                            let _e2933 = phi_11671_;
                                            phi_11673_ = type_41(_e2854, _e2933, _e2724);
                                        } else {
                                            phi_11673_ = _e2733;
                                        }
                                        let _e2936 = phi_11673_;
                                        if (_e2936.member > _e2936.member_1) {
                                            phi_15466_ = bool();
                                            phi_15467_ = f32();
                                            phi_15468_ = f32();
                                            phi_15469_ = true;
                                            phi_15470_ = false;
                                            phi_15471_ = false;
                                            phi_15472_ = false;
                                        } else {
                                            let _e2943 = ((_e2936.member_1 - _e2936.member) * 0.5f);
                                            let _e2944 = (_e2936.member + _e2943);
                                            let _e2946 = (_e2943 + (0.000000059604645f * 4f));
                                            let _e2948 = local_18.member_3;
                                            let _e2951 = local_18.member[0u];
                                            if (_e2951[0] < 0f) {
                                                phi_11702_ = -(_e2951[0]);
                                            } else {
                                                phi_11702_ = _e2951[0];
                                            }
                                            let _e2958 = phi_11702_;
                                            if (_e2951[1] < 0f) {
                                                phi_11709_ = -(_e2951[1]);
                                            } else {
                                                phi_11709_ = _e2951[1];
                                            }
                                            let _e2962 = phi_11709_;
                                            if (_e2958 > _e2962) {
                                                phi_11714_ = _e2958;
                                            } else {
                                                phi_11714_ = _e2962;
                                            }
                                            let _e2965 = phi_11714_;
                                            if (_e2951[2] < 0f) {
                                                phi_11721_ = -(_e2951[2]);
                                            } else {
                                                phi_11721_ = _e2951[2];
                                            }
                                            let _e2969 = phi_11721_;
                                            if (_e2965 > _e2969) {
                                                phi_11726_ = _e2965;
                                            } else {
                                                phi_11726_ = _e2969;
                                            }
                                            let _e2972 = phi_11726_;
                                            let _e2974 = local_18.member[1u];
                                            if (_e2974[0] < 0f) {
                                                phi_11739_ = -(_e2974[0]);
                                            } else {
                                                phi_11739_ = _e2974[0];
                                            }
                                            let _e2981 = phi_11739_;
                                            if (_e2974[1] < 0f) {
                                                phi_11746_ = -(_e2974[1]);
                                            } else {
                                                phi_11746_ = _e2974[1];
                                            }
                                            let _e2985 = phi_11746_;
                                            if (_e2981 > _e2985) {
                                                phi_11751_ = _e2981;
                                            } else {
                                                phi_11751_ = _e2985;
                                            }
                                            let _e2988 = phi_11751_;
                                            if (_e2974[2] < 0f) {
                                                phi_11758_ = -(_e2974[2]);
                                            } else {
                                                phi_11758_ = _e2974[2];
                                            }
                                            let _e2992 = phi_11758_;
                                            if (_e2988 > _e2992) {
                                                phi_11763_ = _e2988;
                                            } else {
                                                phi_11763_ = _e2992;
                                            }
                                            let _e2995 = phi_11763_;
                                            if (_e2972 > _e2995) {
                                                phi_11768_ = _e2972;
                                            } else {
                                                phi_11768_ = _e2995;
                                            }
                                            let _e2998 = phi_11768_;
                                            let _e3001 = local_18.member[0u];
                                            let _e3006 = local_18.member[1u];
                                            let _e3016 = (_e3001[0] + ((_e3006[0] - _e3001[0]) * _e2944));
                                            let _e3017 = (_e3001[1] + ((_e3006[1] - _e3001[1]) * _e2944));
                                            let _e3018 = (_e3001[2] + ((_e3006[2] - _e3001[2]) * _e2944));
                                            let _e3020 = local_18.member[1u];
                                            let _e3025 = local_18.member[0u];
                                            let _e3029 = (_e3020[0] - _e3025[0]);
                                            let _e3030 = (_e3020[1] - _e3025[1]);
                                            let _e3031 = (_e3020[2] - _e3025[2]);
                                            if (_e3029 < 0f) {
                                                phi_11827_ = -(_e3029);
                                            } else {
                                                phi_11827_ = _e3029;
                                            }
                                            let _e3035 = phi_11827_;
                                            if (_e3030 < 0f) {
                                                phi_11833_ = -(_e3030);
                                            } else {
                                                phi_11833_ = _e3030;
                                            }
                                            let _e3039 = phi_11833_;
                                            if (_e3035 > _e3039) {
                                                phi_11838_ = _e3035;
                                            } else {
                                                phi_11838_ = _e3039;
                                            }
                                            let _e3042 = phi_11838_;
                                            if (_e3031 < 0f) {
                                                phi_11844_ = -(_e3031);
                                            } else {
                                                phi_11844_ = _e3031;
                                            }
                                            let _e3046 = phi_11844_;
                                            if (_e3042 > _e3046) {
                                                phi_11849_ = _e3042;
                                            } else {
                                                phi_11849_ = _e3046;
                                            }
                                            let _e3049 = phi_11849_;
                                            let _e3055 = ((((_e2946 * _e3049) * 1.01f) + ((_e2998 + _e2948) * (0.000000059604645f * 8f))) + _e2948);
                                            if (_e3016 < 0f) {
                                                phi_11861_ = -(_e3016);
                                            } else {
                                                phi_11861_ = _e3016;
                                            }
                                            let _e3059 = phi_11861_;
                                            if (_e3017 < 0f) {
                                                phi_11867_ = -(_e3017);
                                            } else {
                                                phi_11867_ = _e3017;
                                            }
                                            let _e3063 = phi_11867_;
                                            if (_e3059 > _e3063) {
                                                phi_11872_ = _e3059;
                                            } else {
                                                phi_11872_ = _e3063;
                                            }
                                            let _e3066 = phi_11872_;
                                            if (_e3018 < 0f) {
                                                phi_11878_ = -(_e3018);
                                            } else {
                                                phi_11878_ = _e3018;
                                            }
                                            let _e3070 = phi_11878_;
                                            if (_e3066 > _e3070) {
                                                phi_11883_ = _e3066;
                                            } else {
                                                phi_11883_ = _e3070;
                                            }
                                            let _e3073 = phi_11883_;
                                            local_2 = type_24(array<f32, 3>(_e3016, _e3017, _e3018), _e3055, (_e3073 + _e3055));
                                            let _e3079 = local_18.member_3;
                                            let _e3081 = local_18.member_1[0u];
                                            if (_e3081[0] < 0f) {
                                                phi_11909_ = -(_e3081[0]);
                                            } else {
                                                phi_11909_ = _e3081[0];
                                            }
                                            let _e3088 = phi_11909_;
                                            if (_e3081[1] < 0f) {
                                                phi_11916_ = -(_e3081[1]);
                                            } else {
                                                phi_11916_ = _e3081[1];
                                            }
                                            let _e3092 = phi_11916_;
                                            if (_e3088 > _e3092) {
                                                phi_11921_ = _e3088;
                                            } else {
                                                phi_11921_ = _e3092;
                                            }
                                            let _e3095 = phi_11921_;
                                            if (_e3081[2] < 0f) {
                                                phi_11928_ = -(_e3081[2]);
                                            } else {
                                                phi_11928_ = _e3081[2];
                                            }
                                            let _e3099 = phi_11928_;
                                            if (_e3095 > _e3099) {
                                                phi_11933_ = _e3095;
                                            } else {
                                                phi_11933_ = _e3099;
                                            }
                                            let _e3102 = phi_11933_;
                                            let _e3104 = local_18.member_1[1u];
                                            if (_e3104[0] < 0f) {
                                                phi_11946_ = -(_e3104[0]);
                                            } else {
                                                phi_11946_ = _e3104[0];
                                            }
                                            let _e3111 = phi_11946_;
                                            if (_e3104[1] < 0f) {
                                                phi_11953_ = -(_e3104[1]);
                                            } else {
                                                phi_11953_ = _e3104[1];
                                            }
                                            let _e3115 = phi_11953_;
                                            if (_e3111 > _e3115) {
                                                phi_11958_ = _e3111;
                                            } else {
                                                phi_11958_ = _e3115;
                                            }
                                            let _e3118 = phi_11958_;
                                            if (_e3104[2] < 0f) {
                                                phi_11965_ = -(_e3104[2]);
                                            } else {
                                                phi_11965_ = _e3104[2];
                                            }
                                            let _e3122 = phi_11965_;
                                            if (_e3118 > _e3122) {
                                                phi_11970_ = _e3118;
                                            } else {
                                                phi_11970_ = _e3122;
                                            }
                                            let _e3125 = phi_11970_;
                                            if (_e3102 > _e3125) {
                                                phi_11975_ = _e3102;
                                            } else {
                                                phi_11975_ = _e3125;
                                            }
                                            let _e3128 = phi_11975_;
                                            let _e3131 = local_18.member_1[0u];
                                            let _e3136 = local_18.member_1[1u];
                                            let _e3146 = (_e3131[0] + ((_e3136[0] - _e3131[0]) * _e2944));
                                            let _e3147 = (_e3131[1] + ((_e3136[1] - _e3131[1]) * _e2944));
                                            let _e3148 = (_e3131[2] + ((_e3136[2] - _e3131[2]) * _e2944));
                                            let _e3150 = local_18.member_1[1u];
                                            let _e3155 = local_18.member_1[0u];
                                            let _e3159 = (_e3150[0] - _e3155[0]);
                                            let _e3160 = (_e3150[1] - _e3155[1]);
                                            let _e3161 = (_e3150[2] - _e3155[2]);
                                            if (_e3159 < 0f) {
                                                phi_12034_ = -(_e3159);
                                            } else {
                                                phi_12034_ = _e3159;
                                            }
                                            let _e3165 = phi_12034_;
                                            if (_e3160 < 0f) {
                                                phi_12040_ = -(_e3160);
                                            } else {
                                                phi_12040_ = _e3160;
                                            }
                                            let _e3169 = phi_12040_;
                                            if (_e3165 > _e3169) {
                                                phi_12045_ = _e3165;
                                            } else {
                                                phi_12045_ = _e3169;
                                            }
                                            let _e3172 = phi_12045_;
                                            if (_e3161 < 0f) {
                                                phi_12051_ = -(_e3161);
                                            } else {
                                                phi_12051_ = _e3161;
                                            }
                                            let _e3176 = phi_12051_;
                                            if (_e3172 > _e3176) {
                                                phi_12056_ = _e3172;
                                            } else {
                                                phi_12056_ = _e3176;
                                            }
                                            let _e3179 = phi_12056_;
                                            let _e3185 = ((((_e2946 * _e3179) * 1.01f) + ((_e3128 + _e3079) * (0.000000059604645f * 8f))) + _e3079);
                                            if (_e3146 < 0f) {
                                                phi_12068_ = -(_e3146);
                                            } else {
                                                phi_12068_ = _e3146;
                                            }
                                            let _e3189 = phi_12068_;
                                            if (_e3147 < 0f) {
                                                phi_12074_ = -(_e3147);
                                            } else {
                                                phi_12074_ = _e3147;
                                            }
                                            let _e3193 = phi_12074_;
                                            if (_e3189 > _e3193) {
                                                phi_12079_ = _e3189;
                                            } else {
                                                phi_12079_ = _e3193;
                                            }
                                            let _e3196 = phi_12079_;
                                            if (_e3148 < 0f) {
                                                phi_12085_ = -(_e3148);
                                            } else {
                                                phi_12085_ = _e3148;
                                            }
                                            let _e3200 = phi_12085_;
                                            if (_e3196 > _e3200) {
                                                phi_12090_ = _e3196;
                                            } else {
                                                phi_12090_ = _e3200;
                                            }
                                            let _e3203 = phi_12090_;
                                            local_3 = type_24(array<f32, 3>(_e3146, _e3147, _e3148), _e3185, (_e3203 + _e3185));
                                            let _e3209 = local_18.member_3;
                                            let _e3211 = local_18.member_2[0u];
                                            if (_e3211[0] < 0f) {
                                                phi_12116_ = -(_e3211[0]);
                                            } else {
                                                phi_12116_ = _e3211[0];
                                            }
                                            let _e3218 = phi_12116_;
                                            if (_e3211[1] < 0f) {
                                                phi_12123_ = -(_e3211[1]);
                                            } else {
                                                phi_12123_ = _e3211[1];
                                            }
                                            let _e3222 = phi_12123_;
                                            if (_e3218 > _e3222) {
                                                phi_12128_ = _e3218;
                                            } else {
                                                phi_12128_ = _e3222;
                                            }
                                            let _e3225 = phi_12128_;
                                            if (_e3211[2] < 0f) {
                                                phi_12135_ = -(_e3211[2]);
                                            } else {
                                                phi_12135_ = _e3211[2];
                                            }
                                            let _e3229 = phi_12135_;
                                            if (_e3225 > _e3229) {
                                                phi_12140_ = _e3225;
                                            } else {
                                                phi_12140_ = _e3229;
                                            }
                                            let _e3232 = phi_12140_;
                                            let _e3234 = local_18.member_2[1u];
                                            if (_e3234[0] < 0f) {
                                                phi_12153_ = -(_e3234[0]);
                                            } else {
                                                phi_12153_ = _e3234[0];
                                            }
                                            let _e3241 = phi_12153_;
                                            if (_e3234[1] < 0f) {
                                                phi_12160_ = -(_e3234[1]);
                                            } else {
                                                phi_12160_ = _e3234[1];
                                            }
                                            let _e3245 = phi_12160_;
                                            if (_e3241 > _e3245) {
                                                phi_12165_ = _e3241;
                                            } else {
                                                phi_12165_ = _e3245;
                                            }
                                            let _e3248 = phi_12165_;
                                            if (_e3234[2] < 0f) {
                                                phi_12172_ = -(_e3234[2]);
                                            } else {
                                                phi_12172_ = _e3234[2];
                                            }
                                            let _e3252 = phi_12172_;
                                            if (_e3248 > _e3252) {
                                                phi_12177_ = _e3248;
                                            } else {
                                                phi_12177_ = _e3252;
                                            }
                                            let _e3255 = phi_12177_;
                                            if (_e3232 > _e3255) {
                                                phi_12182_ = _e3232;
                                            } else {
                                                phi_12182_ = _e3255;
                                            }
                                            let _e3258 = phi_12182_;
                                            let _e3261 = local_18.member_2[0u];
                                            let _e3266 = local_18.member_2[1u];
                                            let _e3276 = (_e3261[0] + ((_e3266[0] - _e3261[0]) * _e2944));
                                            let _e3277 = (_e3261[1] + ((_e3266[1] - _e3261[1]) * _e2944));
                                            let _e3278 = (_e3261[2] + ((_e3266[2] - _e3261[2]) * _e2944));
                                            let _e3280 = local_18.member_2[1u];
                                            let _e3285 = local_18.member_2[0u];
                                            let _e3289 = (_e3280[0] - _e3285[0]);
                                            let _e3290 = (_e3280[1] - _e3285[1]);
                                            let _e3291 = (_e3280[2] - _e3285[2]);
                                            if (_e3289 < 0f) {
                                                phi_12241_ = -(_e3289);
                                            } else {
                                                phi_12241_ = _e3289;
                                            }
                                            let _e3295 = phi_12241_;
                                            if (_e3290 < 0f) {
                                                phi_12247_ = -(_e3290);
                                            } else {
                                                phi_12247_ = _e3290;
                                            }
                                            let _e3299 = phi_12247_;
                                            if (_e3295 > _e3299) {
                                                phi_12252_ = _e3295;
                                            } else {
                                                phi_12252_ = _e3299;
                                            }
                                            let _e3302 = phi_12252_;
                                            if (_e3291 < 0f) {
                                                phi_12258_ = -(_e3291);
                                            } else {
                                                phi_12258_ = _e3291;
                                            }
                                            let _e3306 = phi_12258_;
                                            if (_e3302 > _e3306) {
                                                phi_12263_ = _e3302;
                                            } else {
                                                phi_12263_ = _e3306;
                                            }
                                            let _e3309 = phi_12263_;
                                            let _e3315 = ((((_e2946 * _e3309) * 1.01f) + ((_e3258 + _e3209) * (0.000000059604645f * 8f))) + _e3209);
                                            if (_e3276 < 0f) {
                                                phi_12275_ = -(_e3276);
                                            } else {
                                                phi_12275_ = _e3276;
                                            }
                                            let _e3319 = phi_12275_;
                                            if (_e3277 < 0f) {
                                                phi_12281_ = -(_e3277);
                                            } else {
                                                phi_12281_ = _e3277;
                                            }
                                            let _e3323 = phi_12281_;
                                            if (_e3319 > _e3323) {
                                                phi_12286_ = _e3319;
                                            } else {
                                                phi_12286_ = _e3323;
                                            }
                                            let _e3326 = phi_12286_;
                                            if (_e3278 < 0f) {
                                                phi_12292_ = -(_e3278);
                                            } else {
                                                phi_12292_ = _e3278;
                                            }
                                            let _e3330 = phi_12292_;
                                            if (_e3326 > _e3330) {
                                                phi_12297_ = _e3326;
                                            } else {
                                                phi_12297_ = _e3330;
                                            }
                                            let _e3333 = phi_12297_;
                                            local_4 = type_24(array<f32, 3>(_e3276, _e3277, _e3278), _e3315, (_e3333 + _e3315));
                                            let _e3338 = local_3.member;
                                            let _e3343 = local_4.member;
                                            let _e3349 = ((_e3338[1] * _e3343[2]) - (_e3338[2] * _e3343[1]));
                                            let _e3352 = ((_e3338[2] * _e3343[0]) - (_e3338[0] * _e3343[2]));
                                            let _e3355 = ((_e3338[0] * _e3343[1]) - (_e3338[1] * _e3343[0]));
                                            if (_e3349 < 0f) {
                                                phi_12346_ = -(_e3349);
                                            } else {
                                                phi_12346_ = _e3349;
                                            }
                                            let _e3359 = phi_12346_;
                                            if (_e3352 < 0f) {
                                                phi_12352_ = -(_e3352);
                                            } else {
                                                phi_12352_ = _e3352;
                                            }
                                            let _e3363 = phi_12352_;
                                            if (_e3359 > _e3363) {
                                                if (_e3349 < 0f) {
                                                    phi_12362_ = -(_e3349);
                                                } else {
                                                    phi_12362_ = _e3349;
                                                }
                                                let _e3381 = phi_12362_;
                                                if (_e3355 < 0f) {
                                                    phi_12368_ = -(_e3355);
                                                } else {
                                                    phi_12368_ = _e3355;
                                                }
                                                let _e3385 = phi_12368_;
                                                if (_e3381 > _e3385) {
                                                    phi_12373_ = 2u;
                                                    phi_12374_ = 1u;
                                                } else {
                                                    phi_12373_ = 1u;
                                                    phi_12374_ = 0u;
                                                }
                                                let _e3388 = phi_12373_;
                                                let _e3390 = phi_12374_;
                                                phi_12393_ = _e3388;
                                                phi_12394_ = _e3390;
                                            } else {
                                                if (_e3352 < 0f) {
                                                    phi_12380_ = -(_e3352);
                                                } else {
                                                    phi_12380_ = _e3352;
                                                }
                                                let _e3368 = phi_12380_;
                                                if (_e3355 < 0f) {
                                                    phi_12386_ = -(_e3355);
                                                } else {
                                                    phi_12386_ = _e3355;
                                                }
                                                let _e3372 = phi_12386_;
                                                if (_e3368 > _e3372) {
                                                    phi_12391_ = 0u;
                                                    phi_12392_ = 2u;
                                                } else {
                                                    phi_12391_ = 1u;
                                                    phi_12392_ = 0u;
                                                }
                                                let _e3375 = phi_12391_;
                                                let _e3377 = phi_12392_;
                                                phi_12393_ = _e3375;
                                                phi_12394_ = _e3377;
                                            }
                                            let _e3392 = phi_12393_;
                                            let _e3394 = phi_12394_;
                                            let _e3397 = local_3.member[_e3394];
                                            let _e3400 = local_4.member[_e3392];
                                            let _e3404 = local_3.member[_e3392];
                                            let _e3407 = local_4.member[_e3394];
                                            let _e3409 = ((_e3397 * _e3400) - (_e3404 * _e3407));
                                            let _e3411 = local_3.member_1;
                                            let _e3413 = local_4.member_2;
                                            let _e3416 = local_3.member_2;
                                            let _e3418 = local_4.member_1;
                                            let _e3423 = local_3.member_2;
                                            let _e3426 = local_4.member_2;
                                            let _e3434 = local_3.member_2;
                                            let _e3437 = local_4.member_2;
                                            let _e3441 = (((((_e3411 * _e3413) + (_e3416 * _e3418)) * 2.01f) + (((_e3423 * 2f) * (_e3426 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3434) * (1f + _e3437))));
                                            if (_e3409 < 0f) {
                                                phi_12463_ = -(_e3409);
                                            } else {
                                                phi_12463_ = _e3409;
                                            }
                                            let _e3445 = phi_12463_;
                                            if (_e3445 > _e3441) {
                                                if (_e3409 < 0f) {
                                                    phi_12472_ = -1f;
                                                } else {
                                                    phi_12472_ = 1f;
                                                }
                                                let _e3449 = phi_12472_;
                                                let _e3452 = local_2.member[_e3394];
                                                let _e3455 = local_4.member[_e3392];
                                                let _e3459 = local_2.member[_e3392];
                                                let _e3462 = local_4.member[_e3394];
                                                let _e3466 = local_2.member_1;
                                                let _e3468 = local_4.member_2;
                                                let _e3471 = local_2.member_2;
                                                let _e3473 = local_4.member_1;
                                                let _e3478 = local_2.member_2;
                                                let _e3481 = local_4.member_2;
                                                let _e3489 = local_2.member_2;
                                                let _e3492 = local_4.member_2;
                                                let _e3496 = (((((_e3466 * _e3468) + (_e3471 * _e3473)) * 2.01f) + (((_e3478 * 2f) * (_e3481 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3489) * (1f + _e3492))));
                                                let _e3499 = local_3.member[_e3394];
                                                let _e3502 = local_2.member[_e3392];
                                                let _e3506 = local_3.member[_e3392];
                                                let _e3509 = local_2.member[_e3394];
                                                let _e3513 = local_3.member_1;
                                                let _e3515 = local_2.member_2;
                                                let _e3518 = local_3.member_2;
                                                let _e3520 = local_2.member_1;
                                                let _e3525 = local_3.member_2;
                                                let _e3528 = local_2.member_2;
                                                let _e3536 = local_3.member_2;
                                                let _e3539 = local_2.member_2;
                                                let _e3543 = (((((_e3513 * _e3515) + (_e3518 * _e3520)) * 2.01f) + (((_e3525 * 2f) * (_e3528 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3536) * (1f + _e3539))));
                                                let _e3544 = (_e3409 * _e3449);
                                                let _e3545 = (((_e3452 * _e3455) - (_e3459 * _e3462)) * _e3449);
                                                let _e3546 = (((_e3499 * _e3502) - (_e3506 * _e3509)) * _e3449);
                                                if (_e3544 < 0f) {
                                                    phi_12607_ = -(_e3544);
                                                } else {
                                                    phi_12607_ = _e3544;
                                                }
                                                let _e3550 = phi_12607_;
                                                if (_e3545 < 0f) {
                                                    phi_12613_ = -(_e3545);
                                                } else {
                                                    phi_12613_ = _e3545;
                                                }
                                                let _e3554 = phi_12613_;
                                                if (_e3546 < 0f) {
                                                    phi_12620_ = -(_e3546);
                                                } else {
                                                    phi_12620_ = _e3546;
                                                }
                                                let _e3559 = phi_12620_;
                                                let _e3564 = ((_e3544 - _e3545) - _e3546);
                                                let _e3567 = (((_e3441 + _e3496) + _e3543) + (((_e3550 + _e3554) + _e3559) * (0.000000059604645f * 4f)));
                                                local_5 = array<type_33, 4>(type_33(_e3545, _e3496), type_33(_e3546, _e3543), type_33(_e3564, _e3567), type_33(_e3564, _e3567));
                                                phi_12675_ = type_12(0u, 4u);
                                                phi_12678_ = true;
                                                loop {
                                                    let _e3574 = phi_12675_;
                                                    let _e3576 = phi_12678_;
                                                    local_27 = _e3576;
                                                    if (_e3574.member < _e3574.member_1) {
                                                        phi_12676_ = type_12((_e3574.member + 1u), _e3574.member_1);
                                                        phi_12701_ = type_12(1u, _e3574.member);
                                                    } else {
                                                        phi_12676_ = _e3574;
                                                        phi_12701_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3588 = phi_12676_;
                                                    let _e3590 = phi_12701_;
                                                    if (bitcast<i32>(_e3590.member) != 0i) {
                                                        let _e3597 = local_5[_e3590.member_1].member;
                                                        let _e3600 = local_5[_e3590.member_1].member_1;
                                                        let _e3602 = (_e3597 < -(_e3600));
                                                        if _e3602 {
                                                            phi_12728_ = bool();
                                                            phi_12729_ = false;
                                                        } else {
                                                            phi_12728_ = (_e3576 && (_e3597 > _e3600));
                                                            phi_12729_ = true;
                                                        }
                                                        let _e3606 = phi_12728_;
                                                        let _e3608 = phi_12729_;
                                                        phi_12679_ = _e3606;
                                                        phi_12730_ = _e3608;
                                                        phi_12731_ = _e3602;
                                                    } else {
                                                        phi_12679_ = bool();
                                                        phi_12730_ = false;
                                                        phi_12731_ = false;
                                                    }
                                                    let _e3610 = phi_12679_;
                                                    let _e3612 = phi_12730_;
                                                    let _e3614 = phi_12731_;
                                                    local_26 = _e3614;
                                                    continue;
                                                    continuing {
                                                        phi_12675_ = _e3588;
                                                        phi_12678_ = _e3610;
                                                        break if !(_e3612);
                                                    }
                                                }
                                                let _e3617 = local_26;
                                                if _e3617 {
                                                    phi_12735_ = false;
                                                } else {
                                                    phi_12735_ = true;
                                                }
                                                let _e3619 = phi_12735_;
                                                if _e3619 {
                                                    let _e3621 = local_27;
                                                    if _e3621 {
                                                        phi_12742_ = 1u;
                                                    } else {
                                                        phi_12742_ = 2u;
                                                    }
                                                    let _e3623 = phi_12742_;
                                                    phi_12743_ = _e3623;
                                                    phi_12744_ = false;
                                                } else {
                                                    phi_12743_ = u32();
                                                    phi_12744_ = true;
                                                }
                                                let _e3625 = phi_12743_;
                                                let _e3627 = phi_12744_;
                                                phi_12745_ = _e3625;
                                                phi_12746_ = 0u;
                                                phi_12747_ = _e3627;
                                            } else {
                                                phi_12745_ = u32();
                                                phi_12746_ = 2u;
                                                phi_12747_ = true;
                                            }
                                            let _e3629 = phi_12745_;
                                            let _e3631 = phi_12746_;
                                            let _e3633 = phi_12747_;
                                            if _e3633 {
                                                phi_12751_ = _e3631;
                                            } else {
                                                phi_12751_ = _e3629;
                                            }
                                            let _e3635 = phi_12751_;
                                            let _e3636 = (_e3635 == 0u);
                                            if _e3636 {
                                                phi_15460_ = bool();
                                                phi_15461_ = f32();
                                                phi_15462_ = f32();
                                                phi_15463_ = false;
                                                phi_15464_ = false;
                                                phi_15465_ = false;
                                            } else {
                                                if (_e3635 == 1u) {
                                                    phi_12761_ = _e2936.member_2;
                                                } else {
                                                    phi_12761_ = false;
                                                }
                                                let _e3640 = phi_12761_;
                                                let _e3641 = (_e321 * 0.99f);
                                                if _e3640 {
                                                    if ((_e2936.member_1 - _e2936.member) <= _e3641) {
                                                        phi_12773_ = false;
                                                    } else {
                                                        phi_12773_ = true;
                                                    }
                                                    let _e3647 = phi_12773_;
                                                    phi_12774_ = _e3647;
                                                } else {
                                                    phi_12774_ = true;
                                                }
                                                let _e3649 = phi_12774_;
                                                if _e3649 {
                                                    let _e3654 = local_18.member[0u];
                                                    let _e3660 = local_18.member_1[0u];
                                                    let _e3666 = local_18.member_2[0u];
                                                    let _e3678 = local_18.member[1u];
                                                    let _e3684 = local_18.member_1[1u];
                                                    let _e3690 = local_18.member_2[1u];
                                                    let _e3702 = local_18.member[0u];
                                                    if (_e3702[0] < 0f) {
                                                        phi_12922_ = -(_e3702[0]);
                                                    } else {
                                                        phi_12922_ = _e3702[0];
                                                    }
                                                    let _e3709 = phi_12922_;
                                                    if (_e3702[1] < 0f) {
                                                        phi_12929_ = -(_e3702[1]);
                                                    } else {
                                                        phi_12929_ = _e3702[1];
                                                    }
                                                    let _e3713 = phi_12929_;
                                                    if (_e3709 > _e3713) {
                                                        phi_12934_ = _e3709;
                                                    } else {
                                                        phi_12934_ = _e3713;
                                                    }
                                                    let _e3716 = phi_12934_;
                                                    if (_e3702[2] < 0f) {
                                                        phi_12941_ = -(_e3702[2]);
                                                    } else {
                                                        phi_12941_ = _e3702[2];
                                                    }
                                                    let _e3720 = phi_12941_;
                                                    if (_e3716 > _e3720) {
                                                        phi_12946_ = _e3716;
                                                    } else {
                                                        phi_12946_ = _e3720;
                                                    }
                                                    let _e3723 = phi_12946_;
                                                    let _e3726 = local_18.member[1u];
                                                    if (_e3726[0] < 0f) {
                                                        phi_12959_ = -(_e3726[0]);
                                                    } else {
                                                        phi_12959_ = _e3726[0];
                                                    }
                                                    let _e3733 = phi_12959_;
                                                    if (_e3726[1] < 0f) {
                                                        phi_12966_ = -(_e3726[1]);
                                                    } else {
                                                        phi_12966_ = _e3726[1];
                                                    }
                                                    let _e3737 = phi_12966_;
                                                    if (_e3733 > _e3737) {
                                                        phi_12971_ = _e3733;
                                                    } else {
                                                        phi_12971_ = _e3737;
                                                    }
                                                    let _e3740 = phi_12971_;
                                                    if (_e3726[2] < 0f) {
                                                        phi_12978_ = -(_e3726[2]);
                                                    } else {
                                                        phi_12978_ = _e3726[2];
                                                    }
                                                    let _e3744 = phi_12978_;
                                                    if (_e3740 > _e3744) {
                                                        phi_12983_ = _e3740;
                                                    } else {
                                                        phi_12983_ = _e3744;
                                                    }
                                                    let _e3747 = phi_12983_;
                                                    if (_e3723 > _e3747) {
                                                        phi_12988_ = _e3723;
                                                    } else {
                                                        phi_12988_ = _e3747;
                                                    }
                                                    let _e3750 = phi_12988_;
                                                    let _e3752 = local_18.member_3;
                                                    let _e3756 = local_18.member_1[0u];
                                                    if (_e3756[0] < 0f) {
                                                        phi_13005_ = -(_e3756[0]);
                                                    } else {
                                                        phi_13005_ = _e3756[0];
                                                    }
                                                    let _e3763 = phi_13005_;
                                                    if (_e3756[1] < 0f) {
                                                        phi_13012_ = -(_e3756[1]);
                                                    } else {
                                                        phi_13012_ = _e3756[1];
                                                    }
                                                    let _e3767 = phi_13012_;
                                                    if (_e3763 > _e3767) {
                                                        phi_13017_ = _e3763;
                                                    } else {
                                                        phi_13017_ = _e3767;
                                                    }
                                                    let _e3770 = phi_13017_;
                                                    if (_e3756[2] < 0f) {
                                                        phi_13024_ = -(_e3756[2]);
                                                    } else {
                                                        phi_13024_ = _e3756[2];
                                                    }
                                                    let _e3774 = phi_13024_;
                                                    if (_e3770 > _e3774) {
                                                        phi_13029_ = _e3770;
                                                    } else {
                                                        phi_13029_ = _e3774;
                                                    }
                                                    let _e3777 = phi_13029_;
                                                    let _e3780 = local_18.member_1[1u];
                                                    if (_e3780[0] < 0f) {
                                                        phi_13043_ = -(_e3780[0]);
                                                    } else {
                                                        phi_13043_ = _e3780[0];
                                                    }
                                                    let _e3787 = phi_13043_;
                                                    if (_e3780[1] < 0f) {
                                                        phi_13050_ = -(_e3780[1]);
                                                    } else {
                                                        phi_13050_ = _e3780[1];
                                                    }
                                                    let _e3791 = phi_13050_;
                                                    if (_e3787 > _e3791) {
                                                        phi_13055_ = _e3787;
                                                    } else {
                                                        phi_13055_ = _e3791;
                                                    }
                                                    let _e3794 = phi_13055_;
                                                    if (_e3780[2] < 0f) {
                                                        phi_13062_ = -(_e3780[2]);
                                                    } else {
                                                        phi_13062_ = _e3780[2];
                                                    }
                                                    let _e3798 = phi_13062_;
                                                    if (_e3794 > _e3798) {
                                                        phi_13067_ = _e3794;
                                                    } else {
                                                        phi_13067_ = _e3798;
                                                    }
                                                    let _e3801 = phi_13067_;
                                                    if (_e3777 > _e3801) {
                                                        phi_13072_ = _e3777;
                                                    } else {
                                                        phi_13072_ = _e3801;
                                                    }
                                                    let _e3804 = phi_13072_;
                                                    let _e3806 = local_18.member_3;
                                                    let _e3810 = local_18.member_2[0u];
                                                    if (_e3810[0] < 0f) {
                                                        phi_13089_ = -(_e3810[0]);
                                                    } else {
                                                        phi_13089_ = _e3810[0];
                                                    }
                                                    let _e3817 = phi_13089_;
                                                    if (_e3810[1] < 0f) {
                                                        phi_13096_ = -(_e3810[1]);
                                                    } else {
                                                        phi_13096_ = _e3810[1];
                                                    }
                                                    let _e3821 = phi_13096_;
                                                    if (_e3817 > _e3821) {
                                                        phi_13101_ = _e3817;
                                                    } else {
                                                        phi_13101_ = _e3821;
                                                    }
                                                    let _e3824 = phi_13101_;
                                                    if (_e3810[2] < 0f) {
                                                        phi_13108_ = -(_e3810[2]);
                                                    } else {
                                                        phi_13108_ = _e3810[2];
                                                    }
                                                    let _e3828 = phi_13108_;
                                                    if (_e3824 > _e3828) {
                                                        phi_13113_ = _e3824;
                                                    } else {
                                                        phi_13113_ = _e3828;
                                                    }
                                                    let _e3831 = phi_13113_;
                                                    let _e3834 = local_18.member_2[1u];
                                                    if (_e3834[0] < 0f) {
                                                        phi_13127_ = -(_e3834[0]);
                                                    } else {
                                                        phi_13127_ = _e3834[0];
                                                    }
                                                    let _e3841 = phi_13127_;
                                                    if (_e3834[1] < 0f) {
                                                        phi_13134_ = -(_e3834[1]);
                                                    } else {
                                                        phi_13134_ = _e3834[1];
                                                    }
                                                    let _e3845 = phi_13134_;
                                                    if (_e3841 > _e3845) {
                                                        phi_13139_ = _e3841;
                                                    } else {
                                                        phi_13139_ = _e3845;
                                                    }
                                                    let _e3848 = phi_13139_;
                                                    if (_e3834[2] < 0f) {
                                                        phi_13146_ = -(_e3834[2]);
                                                    } else {
                                                        phi_13146_ = _e3834[2];
                                                    }
                                                    let _e3852 = phi_13146_;
                                                    if (_e3848 > _e3852) {
                                                        phi_13151_ = _e3848;
                                                    } else {
                                                        phi_13151_ = _e3852;
                                                    }
                                                    let _e3855 = phi_13151_;
                                                    if (_e3831 > _e3855) {
                                                        phi_13156_ = _e3831;
                                                    } else {
                                                        phi_13156_ = _e3855;
                                                    }
                                                    let _e3858 = phi_13156_;
                                                    let _e3860 = local_18.member_3;
                                                    let _e3867 = local_18.member_3;
                                                    let _e3872 = (_e321 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_13197_ = type_12(0u, 96u);
                                                    phi_13200_ = _e2936.member;
                                                    phi_13202_ = _e2936.member;
                                                    phi_13204_ = (_e2936.member_1 - _e2936.member);
                                                    phi_13206_ = _e2936.member;
                                                    phi_13208_ = false;
                                                    phi_13210_ = 0u;
                                                    loop {
                                                        let _e3875 = phi_13197_;
                                                        let _e3877 = phi_13200_;
                                                        let _e3879 = phi_13202_;
                                                        let _e3881 = phi_13204_;
                                                        let _e3883 = phi_13206_;
                                                        let _e3885 = phi_13208_;
                                                        let _e3887 = phi_13210_;
                                                        local_30 = _e3877;
                                                        local_75 = _e3879;
                                                        if (_e3875.member < _e3875.member_1) {
                                                            phi_13198_ = type_12((_e3875.member + 1u), _e3875.member_1);
                                                            phi_13233_ = type_12(1u, _e3875.member);
                                                        } else {
                                                            phi_13198_ = _e3875;
                                                            phi_13233_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3899 = phi_13198_;
                                                        let _e3901 = phi_13233_;
                                                        if (bitcast<i32>(_e3901.member) != 0i) {
                                                            let _e3907 = local_18.member[0u];
                                                            let _e3913 = local_18.member[1u];
                                                            let _e3929 = local_18.member_1[0u];
                                                            let _e3935 = local_18.member_1[1u];
                                                            let _e3951 = local_18.member_2[0u];
                                                            let _e3957 = local_18.member_2[1u];
                                                            let _e3971 = function_2(array<f32, 3>((_e3907[0] + ((_e3913[0] - _e3907[0]) * _e3877)), (_e3907[1] + ((_e3913[1] - _e3907[1]) * _e3877)), (_e3907[2] + ((_e3913[2] - _e3907[2]) * _e3877))), array<f32, 3>((_e3929[0] + ((_e3935[0] - _e3929[0]) * _e3877)), (_e3929[1] + ((_e3935[1] - _e3929[1]) * _e3877)), (_e3929[2] + ((_e3935[2] - _e3929[2]) * _e3877))), array<f32, 3>((_e3951[0] + ((_e3957[0] - _e3951[0]) * _e3877)), (_e3951[1] + ((_e3957[1] - _e3951[1]) * _e3877)), (_e3951[2] + ((_e3957[2] - _e3951[2]) * _e3877))), 0u);
                                                            if (_e3887 == 0u) {
                                                                phi_13361_ = _e3971;
                                                            } else {
                                                                if (_e3887 == 1u) {
                                                                    phi_13347_ = _e3971[0];
                                                                } else {
                                                                    phi_13347_ = 0f;
                                                                }
                                                                let _e3976 = phi_13347_;
                                                                if (_e3887 == 2u) {
                                                                    phi_13353_ = _e3971[1];
                                                                } else {
                                                                    phi_13353_ = 0f;
                                                                }
                                                                let _e3980 = phi_13353_;
                                                                if (_e3887 == 3u) {
                                                                    phi_13359_ = _e3971[2];
                                                                } else {
                                                                    phi_13359_ = 0f;
                                                                }
                                                                let _e3984 = phi_13359_;
                                                                phi_13361_ = array<f32, 3>(_e3976, _e3980, _e3984);
                                                            }
                                                            let _e3987 = phi_13361_;
                                                            if (_e3987[0] < 0f) {
                                                                phi_13368_ = -(_e3987[0]);
                                                            } else {
                                                                phi_13368_ = _e3987[0];
                                                            }
                                                            let _e3992 = phi_13368_;
                                                            if (_e3987[1] < 0f) {
                                                                phi_13375_ = -(_e3987[1]);
                                                            } else {
                                                                phi_13375_ = _e3987[1];
                                                            }
                                                            let _e3997 = phi_13375_;
                                                            if (_e3987[2] < 0f) {
                                                                phi_13383_ = -(_e3987[2]);
                                                            } else {
                                                                phi_13383_ = _e3987[2];
                                                            }
                                                            let _e4003 = phi_13383_;
                                                            let _e4004 = ((_e3992 + _e3997) + _e4003);
                                                            if (_e4004 > 0f) {
                                                                if ((bitcast<u32>(_e4004) & 2139095040u) != 2139095040u) {
                                                                    let _e4009 = (1f / _e4004);
                                                                    let _e4011 = (_e3987[0] * _e4009);
                                                                    let _e4013 = (_e3987[1] * _e4009);
                                                                    let _e4015 = (_e3987[2] * _e4009);
                                                                    let _e4020 = (((_e4011 * _e4011) + (_e4013 * _e4013)) + (_e4015 * _e4015));
                                                                    if (_e4020 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e4020 > 0f) {
                                                                            phi_13420_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_13420_ = 0f;
                                                                        }
                                                                        let _e4073 = phi_13420_;
                                                                        phi_13484_ = _e4073;
                                                                    } else {
                                                                        phi_13427_ = type_14(0i, 5i);
                                                                        phi_13430_ = bitcast<f32>(((bitcast<u32>(_e4020) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e4028 = phi_13427_;
                                                                            let _e4030 = phi_13430_;
                                                                            local_28 = _e4030;
                                                                            if (_e4028.member < _e4028.member_1) {
                                                                                let _e4037 = (_e4028.member + 1i);
                                                                                if ((false == (_e4037 > _e4028.member)) != false) {
                                                                                    phi_13451_ = true;
                                                                                } else {
                                                                                    phi_13451_ = false;
                                                                                }
                                                                                let _e4042 = phi_13451_;
                                                                                if _e4042 {
                                                                                    phi_13457_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_13457_ = type_15(1u, _e4037);
                                                                                }
                                                                                let _e4047 = phi_13457_;
                                                                                phi_13428_ = type_14(_e4047.member_1, _e4028.member_1);
                                                                                phi_13471_ = type_15(1u, _e4028.member);
                                                                            } else {
                                                                                phi_13428_ = _e4028;
                                                                                phi_13471_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4053 = phi_13428_;
                                                                            let _e4055 = phi_13471_;
                                                                            let _e4058 = (bitcast<i32>(_e4055.member) != 0i);
                                                                            if _e4058 {
                                                                                phi_13431_ = (0.5f * (_e4030 + (_e4020 / _e4030)));
                                                                            } else {
                                                                                phi_13431_ = f32();
                                                                            }
                                                                            let _e4063 = phi_13431_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13427_ = _e4053;
                                                                                phi_13430_ = _e4063;
                                                                                break if !(_e4058);
                                                                            }
                                                                        }
                                                                        let _e4068 = local_28;
                                                                        phi_13484_ = (_e4068 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4075 = phi_13484_;
                                                                    let _e4076 = (0.000000059604645f * 12f);
                                                                    let _e4081 = ((((((((_e3750 + _e3752) + (_e3804 + _e3806)) + (_e3858 + _e3860)) * (0.000000059604645f * 16f)) + (_e3867 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4075) * (1f + _e4076)));
                                                                    let _e4086 = (((_e4011 * _e3654[0]) + (_e4013 * _e3654[1])) + (_e4015 * _e3654[2]));
                                                                    let _e4091 = (((_e4011 * (_e3654[0] - _e3660[0])) + (_e4013 * (_e3654[1] - _e3660[1]))) + (_e4015 * (_e3654[2] - _e3660[2])));
                                                                    let _e4096 = (((_e4011 * (_e3654[0] - _e3666[0])) + (_e4013 * (_e3654[1] - _e3666[1]))) + (_e4015 * (_e3654[2] - _e3666[2])));
                                                                    let _e4101 = (((_e4011 * _e3654[0]) + (_e4013 * _e3654[1])) + (_e4015 * _e3654[2]));
                                                                    let _e4107 = (((_e4011 * _e3678[0]) + (_e4013 * _e3678[1])) + (_e4015 * _e3678[2]));
                                                                    let _e4112 = (((_e4011 * (_e3678[0] - _e3684[0])) + (_e4013 * (_e3678[1] - _e3684[1]))) + (_e4015 * (_e3678[2] - _e3684[2])));
                                                                    let _e4117 = (((_e4011 * (_e3678[0] - _e3690[0])) + (_e4013 * (_e3678[1] - _e3690[1]))) + (_e4015 * (_e3678[2] - _e3690[2])));
                                                                    let _e4122 = (((_e4011 * _e3678[0]) + (_e4013 * _e3678[1])) + (_e4015 * _e3678[2]));
                                                                    if (_e4086 < 0f) {
                                                                        phi_13550_ = -(_e4086);
                                                                    } else {
                                                                        phi_13550_ = _e4086;
                                                                    }
                                                                    let _e4127 = phi_13550_;
                                                                    if (_e4107 < 0f) {
                                                                        phi_13556_ = -(_e4107);
                                                                    } else {
                                                                        phi_13556_ = _e4107;
                                                                    }
                                                                    let _e4131 = phi_13556_;
                                                                    if (_e4091 < 0f) {
                                                                        phi_13565_ = -(_e4091);
                                                                    } else {
                                                                        phi_13565_ = _e4091;
                                                                    }
                                                                    let _e4138 = phi_13565_;
                                                                    if (_e4112 < 0f) {
                                                                        phi_13571_ = -(_e4112);
                                                                    } else {
                                                                        phi_13571_ = _e4112;
                                                                    }
                                                                    let _e4142 = phi_13571_;
                                                                    if (_e4096 < 0f) {
                                                                        phi_13580_ = -(_e4096);
                                                                    } else {
                                                                        phi_13580_ = _e4096;
                                                                    }
                                                                    let _e4149 = phi_13580_;
                                                                    if (_e4117 < 0f) {
                                                                        phi_13586_ = -(_e4117);
                                                                    } else {
                                                                        phi_13586_ = _e4117;
                                                                    }
                                                                    let _e4153 = phi_13586_;
                                                                    if (_e4101 < 0f) {
                                                                        phi_13595_ = -(_e4101);
                                                                    } else {
                                                                        phi_13595_ = _e4101;
                                                                    }
                                                                    let _e4160 = phi_13595_;
                                                                    if (_e4122 < 0f) {
                                                                        phi_13601_ = -(_e4122);
                                                                    } else {
                                                                        phi_13601_ = _e4122;
                                                                    }
                                                                    let _e4164 = phi_13601_;
                                                                    phi_13607_ = type_32(array<f32, 4>(_e4086, _e4091, _e4096, _e4101), array<f32, 4>(_e4107, _e4112, _e4117, _e4122), array<f32, 4>((_e4081 + ((_e4127 + _e4131) * _e4076)), (_e4081 + ((_e4138 + _e4142) * _e4076)), (_e4081 + ((_e4149 + _e4153) * _e4076)), (_e4081 + ((_e4160 + _e4164) * _e4076))));
                                                                    phi_13608_ = false;
                                                                } else {
                                                                    phi_13607_ = type_32();
                                                                    phi_13608_ = true;
                                                                }
                                                                let _e4171 = phi_13607_;
                                                                let _e4173 = phi_13608_;
                                                                phi_13609_ = _e4171;
                                                                phi_13610_ = _e4173;
                                                            } else {
                                                                phi_13609_ = type_32();
                                                                phi_13610_ = true;
                                                            }
                                                            let _e4175 = phi_13609_;
                                                            let _e4177 = phi_13610_;
                                                            if _e4177 {
                                                                phi_13618_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13618_ = _e4175;
                                                            }
                                                            let _e4179 = phi_13618_;
                                                            local_1 = type_32(array<f32, 4>(_e4179.member[0], _e4179.member[1], _e4179.member[2], _e4179.member[3]), array<f32, 4>(_e4179.member_1[0], _e4179.member_1[1], _e4179.member_1[2], _e4179.member_1[3]), array<f32, 4>(_e4179.member_2[0], _e4179.member_2[1], _e4179.member_2[2], _e4179.member_2[3]));
                                                            let _e4199 = (_e3877 - _e3883);
                                                            let _e4203 = local_1.member[0u];
                                                            let _e4206 = local_1.member_1[0u];
                                                            let _e4209 = local_1.member[0u];
                                                            let _e4215 = local_1.member_2[0u];
                                                            if (((_e4203 + ((_e4206 - _e4209) * _e3877)) - _e4215) > 0f) {
                                                                let _e4220 = local_1.member[1u];
                                                                let _e4223 = local_1.member_1[1u];
                                                                let _e4226 = local_1.member[1u];
                                                                let _e4232 = local_1.member_2[1u];
                                                                if (((_e4220 + ((_e4223 - _e4226) * _e3877)) - _e4232) > 0f) {
                                                                    let _e4237 = local_1.member[2u];
                                                                    let _e4240 = local_1.member_1[2u];
                                                                    let _e4243 = local_1.member[2u];
                                                                    let _e4249 = local_1.member_2[2u];
                                                                    if (((_e4237 + ((_e4240 - _e4243) * _e3877)) - _e4249) > 0f) {
                                                                        let _e4254 = local_1.member[3u];
                                                                        let _e4257 = local_1.member_1[3u];
                                                                        let _e4260 = local_1.member[3u];
                                                                        let _e4266 = local_1.member_2[3u];
                                                                        phi_13789_ = (((_e4254 + ((_e4257 - _e4260) * _e3877)) - _e4266) > 0f);
                                                                        phi_13790_ = false;
                                                                    } else {
                                                                        phi_13789_ = bool();
                                                                        phi_13790_ = true;
                                                                    }
                                                                    let _e4270 = phi_13789_;
                                                                    let _e4272 = phi_13790_;
                                                                    phi_13791_ = _e4270;
                                                                    phi_13792_ = _e4272;
                                                                } else {
                                                                    phi_13791_ = bool();
                                                                    phi_13792_ = true;
                                                                }
                                                                let _e4274 = phi_13791_;
                                                                let _e4276 = phi_13792_;
                                                                phi_13793_ = _e4274;
                                                                phi_13794_ = _e4276;
                                                            } else {
                                                                phi_13793_ = bool();
                                                                phi_13794_ = true;
                                                            }
                                                            let _e4278 = phi_13793_;
                                                            let _e4280 = phi_13794_;
                                                            if _e4280 {
                                                                phi_13798_ = false;
                                                            } else {
                                                                phi_13798_ = _e4278;
                                                            }
                                                            let _e4282 = phi_13798_;
                                                            if _e4282 {
                                                                if (_e3877 <= _e3879) {
                                                                    phi_14108_ = true;
                                                                } else {
                                                                    let _e4286 = local.member[0u];
                                                                    let _e4289 = local.member_1[0u];
                                                                    let _e4292 = local.member[0u];
                                                                    let _e4298 = local.member_2[0u];
                                                                    let _e4302 = local_1.member[0u];
                                                                    let _e4305 = local_1.member_1[0u];
                                                                    let _e4308 = local_1.member[0u];
                                                                    let _e4314 = local_1.member_2[0u];
                                                                    if ((((_e4286 + ((_e4289 - _e4292) * _e3877)) - _e4298) + ((_e4302 + ((_e4305 - _e4308) * _e3883)) - _e4314)) > 0f) {
                                                                        let _e4320 = local.member[1u];
                                                                        let _e4323 = local.member_1[1u];
                                                                        let _e4326 = local.member[1u];
                                                                        let _e4332 = local.member_2[1u];
                                                                        let _e4336 = local_1.member[1u];
                                                                        let _e4339 = local_1.member_1[1u];
                                                                        let _e4342 = local_1.member[1u];
                                                                        let _e4348 = local_1.member_2[1u];
                                                                        if ((((_e4320 + ((_e4323 - _e4326) * _e3877)) - _e4332) + ((_e4336 + ((_e4339 - _e4342) * _e3883)) - _e4348)) > 0f) {
                                                                            let _e4354 = local.member[2u];
                                                                            let _e4357 = local.member_1[2u];
                                                                            let _e4360 = local.member[2u];
                                                                            let _e4366 = local.member_2[2u];
                                                                            let _e4370 = local_1.member[2u];
                                                                            let _e4373 = local_1.member_1[2u];
                                                                            let _e4376 = local_1.member[2u];
                                                                            let _e4382 = local_1.member_2[2u];
                                                                            if ((((_e4354 + ((_e4357 - _e4360) * _e3877)) - _e4366) + ((_e4370 + ((_e4373 - _e4376) * _e3883)) - _e4382)) > 0f) {
                                                                                let _e4388 = local.member[3u];
                                                                                let _e4391 = local.member_1[3u];
                                                                                let _e4394 = local.member[3u];
                                                                                let _e4400 = local.member_2[3u];
                                                                                let _e4404 = local_1.member[3u];
                                                                                let _e4407 = local_1.member_1[3u];
                                                                                let _e4410 = local_1.member[3u];
                                                                                let _e4416 = local_1.member_2[3u];
                                                                                phi_14095_ = ((((_e4388 + ((_e4391 - _e4394) * _e3877)) - _e4400) + ((_e4404 + ((_e4407 - _e4410) * _e3883)) - _e4416)) > 0f);
                                                                                phi_14096_ = false;
                                                                            } else {
                                                                                phi_14095_ = bool();
                                                                                phi_14096_ = true;
                                                                            }
                                                                            let _e4421 = phi_14095_;
                                                                            let _e4423 = phi_14096_;
                                                                            phi_14097_ = _e4421;
                                                                            phi_14098_ = _e4423;
                                                                        } else {
                                                                            phi_14097_ = bool();
                                                                            phi_14098_ = true;
                                                                        }
                                                                        let _e4425 = phi_14097_;
                                                                        let _e4427 = phi_14098_;
                                                                        phi_14099_ = _e4425;
                                                                        phi_14100_ = _e4427;
                                                                    } else {
                                                                        phi_14099_ = bool();
                                                                        phi_14100_ = true;
                                                                    }
                                                                    let _e4429 = phi_14099_;
                                                                    let _e4431 = phi_14100_;
                                                                    if _e4431 {
                                                                        phi_14104_ = false;
                                                                    } else {
                                                                        phi_14104_ = _e4429;
                                                                    }
                                                                    let _e4433 = phi_14104_;
                                                                    phi_14108_ = _e4433;
                                                                }
                                                                let _e4435 = phi_14108_;
                                                                if _e4435 {
                                                                    if _e3885 {
                                                                        if (_e3877 >= _e2936.member_1) {
                                                                            phi_14119_ = false;
                                                                        } else {
                                                                            phi_14119_ = true;
                                                                        }
                                                                        let _e4438 = phi_14119_;
                                                                        phi_14120_ = _e4438;
                                                                    } else {
                                                                        phi_14120_ = true;
                                                                    }
                                                                    let _e4440 = phi_14120_;
                                                                    if _e4440 {
                                                                        local = type_32(array<f32, 4>(_e4179.member[0], _e4179.member[1], _e4179.member[2], _e4179.member[3]), array<f32, 4>(_e4179.member_1[0], _e4179.member_1[1], _e4179.member_1[2], _e4179.member_1[3]), array<f32, 4>(_e4179.member_2[0], _e4179.member_2[1], _e4179.member_2[2], _e4179.member_2[3]));
                                                                        let _e4462 = local.member[0u];
                                                                        let _e4465 = local.member_1[0u];
                                                                        let _e4468 = local.member_2[0u];
                                                                        if (_e4462 > _e4468) {
                                                                            if (_e4465 > _e4468) {
                                                                                phi_14194_ = false;
                                                                            } else {
                                                                                phi_14194_ = true;
                                                                            }
                                                                            let _e4472 = phi_14194_;
                                                                            phi_14195_ = _e4472;
                                                                        } else {
                                                                            phi_14195_ = true;
                                                                        }
                                                                        let _e4474 = phi_14195_;
                                                                        if _e4474 {
                                                                            let _e4475 = (_e4465 >= _e4462);
                                                                            if _e4475 {
                                                                                phi_14217_ = f32();
                                                                                phi_14218_ = false;
                                                                            } else {
                                                                                if ((_e4462 - _e4465) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14215_ = (((_e4462 - _e4468) / (_e4462 - _e4465)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14216_ = false;
                                                                                } else {
                                                                                    phi_14215_ = f32();
                                                                                    phi_14216_ = true;
                                                                                }
                                                                                let _e4486 = phi_14215_;
                                                                                let _e4488 = phi_14216_;
                                                                                phi_14217_ = _e4486;
                                                                                phi_14218_ = _e4488;
                                                                            }
                                                                            let _e4490 = phi_14217_;
                                                                            let _e4492 = phi_14218_;
                                                                            phi_14219_ = _e4490;
                                                                            phi_14220_ = _e4475;
                                                                            phi_14221_ = _e4492;
                                                                        } else {
                                                                            phi_14219_ = f32();
                                                                            phi_14220_ = true;
                                                                            phi_14221_ = false;
                                                                        }
                                                                        let _e4494 = phi_14219_;
                                                                        let _e4496 = phi_14220_;
                                                                        let _e4498 = phi_14221_;
                                                                        if _e4496 {
                                                                            phi_14225_ = 2f;
                                                                            phi_14226_ = true;
                                                                        } else {
                                                                            phi_14225_ = _e3877;
                                                                            phi_14226_ = _e4498;
                                                                        }
                                                                        let _e4500 = phi_14225_;
                                                                        let _e4502 = phi_14226_;
                                                                        if _e4502 {
                                                                            phi_14230_ = _e4500;
                                                                        } else {
                                                                            phi_14230_ = _e4494;
                                                                        }
                                                                        let _e4504 = phi_14230_;
                                                                        let _e4507 = local.member[1u];
                                                                        let _e4510 = local.member_1[1u];
                                                                        let _e4513 = local.member_2[1u];
                                                                        if (_e4507 > _e4513) {
                                                                            if (_e4510 > _e4513) {
                                                                                phi_14262_ = false;
                                                                            } else {
                                                                                phi_14262_ = true;
                                                                            }
                                                                            let _e4517 = phi_14262_;
                                                                            phi_14263_ = _e4517;
                                                                        } else {
                                                                            phi_14263_ = true;
                                                                        }
                                                                        let _e4519 = phi_14263_;
                                                                        if _e4519 {
                                                                            let _e4520 = (_e4510 >= _e4507);
                                                                            if _e4520 {
                                                                                phi_14285_ = f32();
                                                                                phi_14286_ = false;
                                                                            } else {
                                                                                if ((_e4507 - _e4510) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14283_ = (((_e4507 - _e4513) / (_e4507 - _e4510)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14284_ = false;
                                                                                } else {
                                                                                    phi_14283_ = f32();
                                                                                    phi_14284_ = true;
                                                                                }
                                                                                let _e4531 = phi_14283_;
                                                                                let _e4533 = phi_14284_;
                                                                                phi_14285_ = _e4531;
                                                                                phi_14286_ = _e4533;
                                                                            }
                                                                            let _e4535 = phi_14285_;
                                                                            let _e4537 = phi_14286_;
                                                                            phi_14287_ = _e4535;
                                                                            phi_14288_ = _e4520;
                                                                            phi_14289_ = _e4537;
                                                                        } else {
                                                                            phi_14287_ = f32();
                                                                            phi_14288_ = true;
                                                                            phi_14289_ = false;
                                                                        }
                                                                        let _e4539 = phi_14287_;
                                                                        let _e4541 = phi_14288_;
                                                                        let _e4543 = phi_14289_;
                                                                        if _e4541 {
                                                                            phi_14293_ = 2f;
                                                                            phi_14294_ = true;
                                                                        } else {
                                                                            phi_14293_ = _e3877;
                                                                            phi_14294_ = _e4543;
                                                                        }
                                                                        let _e4545 = phi_14293_;
                                                                        let _e4547 = phi_14294_;
                                                                        if _e4547 {
                                                                            phi_14298_ = _e4545;
                                                                        } else {
                                                                            phi_14298_ = _e4539;
                                                                        }
                                                                        let _e4549 = phi_14298_;
                                                                        if (_e4504 < _e4549) {
                                                                            phi_14303_ = _e4504;
                                                                        } else {
                                                                            phi_14303_ = _e4549;
                                                                        }
                                                                        let _e4552 = phi_14303_;
                                                                        let _e4555 = local.member[2u];
                                                                        let _e4558 = local.member_1[2u];
                                                                        let _e4561 = local.member_2[2u];
                                                                        if (_e4555 > _e4561) {
                                                                            if (_e4558 > _e4561) {
                                                                                phi_14335_ = false;
                                                                            } else {
                                                                                phi_14335_ = true;
                                                                            }
                                                                            let _e4565 = phi_14335_;
                                                                            phi_14336_ = _e4565;
                                                                        } else {
                                                                            phi_14336_ = true;
                                                                        }
                                                                        let _e4567 = phi_14336_;
                                                                        if _e4567 {
                                                                            let _e4568 = (_e4558 >= _e4555);
                                                                            if _e4568 {
                                                                                phi_14358_ = f32();
                                                                                phi_14359_ = false;
                                                                            } else {
                                                                                if ((_e4555 - _e4558) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14356_ = (((_e4555 - _e4561) / (_e4555 - _e4558)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14357_ = false;
                                                                                } else {
                                                                                    phi_14356_ = f32();
                                                                                    phi_14357_ = true;
                                                                                }
                                                                                let _e4579 = phi_14356_;
                                                                                let _e4581 = phi_14357_;
                                                                                phi_14358_ = _e4579;
                                                                                phi_14359_ = _e4581;
                                                                            }
                                                                            let _e4583 = phi_14358_;
                                                                            let _e4585 = phi_14359_;
                                                                            phi_14360_ = _e4583;
                                                                            phi_14361_ = _e4568;
                                                                            phi_14362_ = _e4585;
                                                                        } else {
                                                                            phi_14360_ = f32();
                                                                            phi_14361_ = true;
                                                                            phi_14362_ = false;
                                                                        }
                                                                        let _e4587 = phi_14360_;
                                                                        let _e4589 = phi_14361_;
                                                                        let _e4591 = phi_14362_;
                                                                        if _e4589 {
                                                                            phi_14366_ = 2f;
                                                                            phi_14367_ = true;
                                                                        } else {
                                                                            phi_14366_ = _e3877;
                                                                            phi_14367_ = _e4591;
                                                                        }
                                                                        let _e4593 = phi_14366_;
                                                                        let _e4595 = phi_14367_;
                                                                        if _e4595 {
                                                                            phi_14371_ = _e4593;
                                                                        } else {
                                                                            phi_14371_ = _e4587;
                                                                        }
                                                                        let _e4597 = phi_14371_;
                                                                        let _e4600 = local.member[3u];
                                                                        let _e4603 = local.member_1[3u];
                                                                        let _e4606 = local.member_2[3u];
                                                                        if (_e4600 > _e4606) {
                                                                            if (_e4603 > _e4606) {
                                                                                phi_14403_ = false;
                                                                            } else {
                                                                                phi_14403_ = true;
                                                                            }
                                                                            let _e4610 = phi_14403_;
                                                                            phi_14404_ = _e4610;
                                                                        } else {
                                                                            phi_14404_ = true;
                                                                        }
                                                                        let _e4612 = phi_14404_;
                                                                        if _e4612 {
                                                                            let _e4613 = (_e4603 >= _e4600);
                                                                            if _e4613 {
                                                                                phi_14426_ = f32();
                                                                                phi_14427_ = false;
                                                                            } else {
                                                                                if ((_e4600 - _e4603) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14424_ = (((_e4600 - _e4606) / (_e4600 - _e4603)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14425_ = false;
                                                                                } else {
                                                                                    phi_14424_ = f32();
                                                                                    phi_14425_ = true;
                                                                                }
                                                                                let _e4624 = phi_14424_;
                                                                                let _e4626 = phi_14425_;
                                                                                phi_14426_ = _e4624;
                                                                                phi_14427_ = _e4626;
                                                                            }
                                                                            let _e4628 = phi_14426_;
                                                                            let _e4630 = phi_14427_;
                                                                            phi_14428_ = _e4628;
                                                                            phi_14429_ = _e4613;
                                                                            phi_14430_ = _e4630;
                                                                        } else {
                                                                            phi_14428_ = f32();
                                                                            phi_14429_ = true;
                                                                            phi_14430_ = false;
                                                                        }
                                                                        let _e4632 = phi_14428_;
                                                                        let _e4634 = phi_14429_;
                                                                        let _e4636 = phi_14430_;
                                                                        if _e4634 {
                                                                            phi_14434_ = 2f;
                                                                            phi_14435_ = true;
                                                                        } else {
                                                                            phi_14434_ = _e3877;
                                                                            phi_14435_ = _e4636;
                                                                        }
                                                                        let _e4638 = phi_14434_;
                                                                        let _e4640 = phi_14435_;
                                                                        if _e4640 {
                                                                            phi_14439_ = _e4638;
                                                                        } else {
                                                                            phi_14439_ = _e4632;
                                                                        }
                                                                        let _e4642 = phi_14439_;
                                                                        if (_e4597 < _e4642) {
                                                                            phi_14444_ = _e4597;
                                                                        } else {
                                                                            phi_14444_ = _e4642;
                                                                        }
                                                                        let _e4645 = phi_14444_;
                                                                        if (_e4552 < _e4645) {
                                                                            phi_14449_ = _e4552;
                                                                        } else {
                                                                            phi_14449_ = _e4645;
                                                                        }
                                                                        let _e4648 = phi_14449_;
                                                                        if (_e4648 > _e3877) {
                                                                            phi_14454_ = _e4648;
                                                                        } else {
                                                                            phi_14454_ = _e3877;
                                                                        }
                                                                        let _e4651 = phi_14454_;
                                                                        let _e4652 = (_e4651 > _e2936.member_1);
                                                                        if _e4652 {
                                                                            phi_14959_ = f32();
                                                                            phi_14960_ = f32();
                                                                            phi_14961_ = false;
                                                                        } else {
                                                                            let _e4653 = (_e4651 - _e3877);
                                                                            if _e3885 {
                                                                                if (_e4653 <= _e3872) {
                                                                                    phi_14949_ = true;
                                                                                } else {
                                                                                    if (_e4653 <= (_e3881 * 0.25f)) {
                                                                                        phi_14948_ = false;
                                                                                    } else {
                                                                                        phi_14948_ = true;
                                                                                    }
                                                                                    let _e4659 = phi_14948_;
                                                                                    phi_14949_ = _e4659;
                                                                                }
                                                                                let _e4661 = phi_14949_;
                                                                                if _e4661 {
                                                                                    phi_14954_ = (_e4199 + _e4199);
                                                                                } else {
                                                                                    phi_14954_ = 0f;
                                                                                }
                                                                                let _e4664 = phi_14954_;
                                                                                phi_14956_ = _e4664;
                                                                            } else {
                                                                                phi_14956_ = (_e2936.member_1 - _e3877);
                                                                            }
                                                                            let _e4666 = phi_14956_;
                                                                            phi_14959_ = _e4666;
                                                                            phi_14960_ = _e4653;
                                                                            phi_14961_ = true;
                                                                        }
                                                                        let _e4668 = phi_14959_;
                                                                        let _e4670 = phi_14960_;
                                                                        let _e4672 = phi_14961_;
                                                                        phi_14963_ = _e4651;
                                                                        phi_14964_ = _e4668;
                                                                        phi_14965_ = _e4670;
                                                                        phi_14967_ = _e4672;
                                                                        phi_14968_ = _e4652;
                                                                        phi_14970_ = false;
                                                                    } else {
                                                                        phi_14963_ = f32();
                                                                        phi_14964_ = f32();
                                                                        phi_14965_ = f32();
                                                                        phi_14967_ = false;
                                                                        phi_14968_ = false;
                                                                        phi_14970_ = true;
                                                                    }
                                                                    let _e4674 = phi_14963_;
                                                                    let _e4676 = phi_14964_;
                                                                    let _e4678 = phi_14965_;
                                                                    let _e4680 = phi_14967_;
                                                                    let _e4682 = phi_14968_;
                                                                    let _e4684 = phi_14970_;
                                                                    phi_14971_ = _e4674;
                                                                    phi_14972_ = _e4676;
                                                                    phi_14973_ = _e4678;
                                                                    phi_14975_ = false;
                                                                    phi_14976_ = _e4680;
                                                                    phi_14977_ = _e4682;
                                                                    phi_14979_ = _e4684;
                                                                } else {
                                                                    phi_14971_ = f32();
                                                                    phi_14972_ = f32();
                                                                    phi_14973_ = f32();
                                                                    phi_14975_ = true;
                                                                    phi_14976_ = false;
                                                                    phi_14977_ = false;
                                                                    phi_14979_ = false;
                                                                }
                                                                let _e4686 = phi_14971_;
                                                                let _e4688 = phi_14972_;
                                                                let _e4690 = phi_14973_;
                                                                let _e4692 = phi_14975_;
                                                                let _e4694 = phi_14976_;
                                                                let _e4696 = phi_14977_;
                                                                let _e4698 = phi_14979_;
                                                                phi_14980_ = _e4686;
                                                                phi_14981_ = _e4688;
                                                                phi_14982_ = _e4690;
                                                                phi_14984_ = _e4692;
                                                                phi_14985_ = _e4694;
                                                                phi_14986_ = _e4696;
                                                                phi_14988_ = _e4698;
                                                            } else {
                                                                phi_14980_ = f32();
                                                                phi_14981_ = f32();
                                                                phi_14982_ = f32();
                                                                phi_14984_ = true;
                                                                phi_14985_ = false;
                                                                phi_14986_ = false;
                                                                phi_14988_ = false;
                                                            }
                                                            let _e4700 = phi_14980_;
                                                            let _e4702 = phi_14981_;
                                                            let _e4704 = phi_14982_;
                                                            let _e4706 = phi_14984_;
                                                            let _e4708 = phi_14985_;
                                                            let _e4710 = phi_14986_;
                                                            let _e4712 = phi_14988_;
                                                            if _e4706 {
                                                                if (_e3877 <= _e3879) {
                                                                    let _e4873 = (_e3887 + 1u);
                                                                    let _e4874 = (_e4873 > 3u);
                                                                    if _e4874 {
                                                                        phi_15001_ = false;
                                                                    } else {
                                                                        phi_15001_ = true;
                                                                    }
                                                                    let _e4876 = phi_15001_;
                                                                    phi_15323_ = _e4873;
                                                                    phi_15324_ = f32();
                                                                    phi_15325_ = false;
                                                                    phi_15326_ = _e4876;
                                                                    phi_15327_ = _e4874;
                                                                } else {
                                                                    let _e4716 = local.member[0u];
                                                                    let _e4719 = local.member_1[0u];
                                                                    let _e4722 = local.member[0u];
                                                                    let _e4728 = local.member_2[0u];
                                                                    let _e4729 = ((_e4716 + ((_e4719 - _e4722) * _e3883)) - _e4728);
                                                                    let _e4732 = local.member[1u];
                                                                    let _e4735 = local.member_1[1u];
                                                                    let _e4738 = local.member[1u];
                                                                    let _e4744 = local.member_2[1u];
                                                                    let _e4745 = ((_e4732 + ((_e4735 - _e4738) * _e3883)) - _e4744);
                                                                    if (_e4729 < _e4745) {
                                                                        phi_15074_ = _e4729;
                                                                    } else {
                                                                        phi_15074_ = _e4745;
                                                                    }
                                                                    let _e4748 = phi_15074_;
                                                                    let _e4751 = local.member[2u];
                                                                    let _e4754 = local.member_1[2u];
                                                                    let _e4757 = local.member[2u];
                                                                    let _e4763 = local.member_2[2u];
                                                                    let _e4764 = ((_e4751 + ((_e4754 - _e4757) * _e3883)) - _e4763);
                                                                    let _e4767 = local.member[3u];
                                                                    let _e4770 = local.member_1[3u];
                                                                    let _e4773 = local.member[3u];
                                                                    let _e4779 = local.member_2[3u];
                                                                    let _e4780 = ((_e4767 + ((_e4770 - _e4773) * _e3883)) - _e4779);
                                                                    if (_e4764 < _e4780) {
                                                                        phi_15147_ = _e4764;
                                                                    } else {
                                                                        phi_15147_ = _e4780;
                                                                    }
                                                                    let _e4783 = phi_15147_;
                                                                    if (_e4748 < _e4783) {
                                                                        phi_15152_ = _e4748;
                                                                    } else {
                                                                        phi_15152_ = _e4783;
                                                                    }
                                                                    let _e4786 = phi_15152_;
                                                                    let _e4789 = local_1.member[0u];
                                                                    let _e4792 = local_1.member_1[0u];
                                                                    let _e4795 = local_1.member[0u];
                                                                    let _e4801 = local_1.member_2[0u];
                                                                    let _e4802 = ((_e4789 + ((_e4792 - _e4795) * _e3877)) - _e4801);
                                                                    let _e4805 = local_1.member[1u];
                                                                    let _e4808 = local_1.member_1[1u];
                                                                    let _e4811 = local_1.member[1u];
                                                                    let _e4817 = local_1.member_2[1u];
                                                                    let _e4818 = ((_e4805 + ((_e4808 - _e4811) * _e3877)) - _e4817);
                                                                    if (_e4802 < _e4818) {
                                                                        phi_15225_ = _e4802;
                                                                    } else {
                                                                        phi_15225_ = _e4818;
                                                                    }
                                                                    let _e4821 = phi_15225_;
                                                                    let _e4824 = local_1.member[2u];
                                                                    let _e4827 = local_1.member_1[2u];
                                                                    let _e4830 = local_1.member[2u];
                                                                    let _e4836 = local_1.member_2[2u];
                                                                    let _e4837 = ((_e4824 + ((_e4827 - _e4830) * _e3877)) - _e4836);
                                                                    let _e4840 = local_1.member[3u];
                                                                    let _e4843 = local_1.member_1[3u];
                                                                    let _e4846 = local_1.member[3u];
                                                                    let _e4852 = local_1.member_2[3u];
                                                                    let _e4853 = ((_e4840 + ((_e4843 - _e4846) * _e3877)) - _e4852);
                                                                    if (_e4837 < _e4853) {
                                                                        phi_15298_ = _e4837;
                                                                    } else {
                                                                        phi_15298_ = _e4853;
                                                                    }
                                                                    let _e4856 = phi_15298_;
                                                                    if (_e4821 < _e4856) {
                                                                        phi_15303_ = _e4821;
                                                                    } else {
                                                                        phi_15303_ = _e4856;
                                                                    }
                                                                    let _e4859 = phi_15303_;
                                                                    if (_e4859 > 0f) {
                                                                        phi_15321_ = 0.5f;
                                                                    } else {
                                                                        let _e4863 = (0.95f * (_e4786 / (_e4786 - _e4859)));
                                                                        if (_e4863 > 0.0625f) {
                                                                            if (_e4863 < 0.9f) {
                                                                                phi_15319_ = _e4863;
                                                                            } else {
                                                                                phi_15319_ = 0.9f;
                                                                            }
                                                                            let _e4867 = phi_15319_;
                                                                            phi_15320_ = _e4867;
                                                                        } else {
                                                                            phi_15320_ = 0.0625f;
                                                                        }
                                                                        let _e4869 = phi_15320_;
                                                                        phi_15321_ = _e4869;
                                                                    }
                                                                    let _e4871 = phi_15321_;
                                                                    phi_15323_ = u32();
                                                                    phi_15324_ = (_e4199 * _e4871);
                                                                    phi_15325_ = true;
                                                                    phi_15326_ = false;
                                                                    phi_15327_ = false;
                                                                }
                                                                let _e4878 = phi_15323_;
                                                                let _e4880 = phi_15324_;
                                                                let _e4882 = phi_15325_;
                                                                let _e4884 = phi_15326_;
                                                                let _e4886 = phi_15327_;
                                                                phi_15328_ = _e4878;
                                                                phi_15329_ = _e3879;
                                                                phi_15330_ = _e4880;
                                                                phi_15331_ = _e3881;
                                                                phi_15332_ = _e3883;
                                                                phi_15333_ = _e3885;
                                                                phi_15334_ = _e3887;
                                                                phi_15335_ = _e4882;
                                                                phi_15336_ = _e4884;
                                                                phi_15337_ = _e4886;
                                                                phi_15338_ = false;
                                                                phi_15340_ = false;
                                                            } else {
                                                                phi_15328_ = u32();
                                                                phi_15329_ = _e4700;
                                                                phi_15330_ = _e4702;
                                                                phi_15331_ = _e4704;
                                                                phi_15332_ = _e3877;
                                                                phi_15333_ = true;
                                                                phi_15334_ = 0u;
                                                                phi_15335_ = _e4708;
                                                                phi_15336_ = false;
                                                                phi_15337_ = false;
                                                                phi_15338_ = _e4710;
                                                                phi_15340_ = _e4712;
                                                            }
                                                            let _e4888 = phi_15328_;
                                                            let _e4890 = phi_15329_;
                                                            let _e4892 = phi_15330_;
                                                            let _e4894 = phi_15331_;
                                                            let _e4896 = phi_15332_;
                                                            let _e4898 = phi_15333_;
                                                            let _e4900 = phi_15334_;
                                                            let _e4902 = phi_15335_;
                                                            let _e4904 = phi_15336_;
                                                            let _e4906 = phi_15337_;
                                                            let _e4908 = phi_15338_;
                                                            let _e4910 = phi_15340_;
                                                            if _e4902 {
                                                                let _e4911 = (_e4896 + _e4892);
                                                                if (_e4911 > _e4890) {
                                                                    phi_15349_ = _e4911;
                                                                } else {
                                                                    phi_15349_ = _e4890;
                                                                }
                                                                let _e4914 = phi_15349_;
                                                                if (_e4914 < _e2936.member_1) {
                                                                    phi_15354_ = _e4914;
                                                                } else {
                                                                    phi_15354_ = _e2936.member_1;
                                                                }
                                                                let _e4917 = phi_15354_;
                                                                if !(_e3885) {
                                                                    phi_15363_ = true;
                                                                } else {
                                                                    phi_15363_ = ((_e4917 - _e4896) > _e3872);
                                                                }
                                                                let _e4921 = phi_15363_;
                                                                if _e4921 {
                                                                    phi_15367_ = false;
                                                                } else {
                                                                    phi_15367_ = true;
                                                                }
                                                                let _e4923 = phi_15367_;
                                                                phi_15368_ = _e4917;
                                                                phi_15369_ = _e4890;
                                                                phi_15370_ = _e4894;
                                                                phi_15371_ = _e4896;
                                                                phi_15372_ = _e4898;
                                                                phi_15373_ = _e4900;
                                                                phi_15374_ = _e4921;
                                                                phi_15375_ = _e4923;
                                                                phi_15376_ = false;
                                                                phi_15377_ = false;
                                                                phi_15379_ = false;
                                                            } else {
                                                                phi_15368_ = _e3877;
                                                                phi_15369_ = _e3879;
                                                                phi_15370_ = _e3881;
                                                                phi_15371_ = _e3883;
                                                                phi_15372_ = _e3885;
                                                                phi_15373_ = _e4888;
                                                                phi_15374_ = _e4904;
                                                                phi_15375_ = false;
                                                                phi_15376_ = _e4906;
                                                                phi_15377_ = _e4908;
                                                                phi_15379_ = _e4910;
                                                            }
                                                            let _e4925 = phi_15368_;
                                                            let _e4927 = phi_15369_;
                                                            let _e4929 = phi_15370_;
                                                            let _e4931 = phi_15371_;
                                                            let _e4933 = phi_15372_;
                                                            let _e4935 = phi_15373_;
                                                            let _e4937 = phi_15374_;
                                                            let _e4939 = phi_15375_;
                                                            let _e4941 = phi_15376_;
                                                            let _e4943 = phi_15377_;
                                                            let _e4945 = phi_15379_;
                                                            phi_13201_ = _e4925;
                                                            phi_13203_ = _e4927;
                                                            phi_13205_ = _e4929;
                                                            phi_13207_ = _e4931;
                                                            phi_13209_ = _e4933;
                                                            phi_13211_ = _e4935;
                                                            phi_15380_ = _e4890;
                                                            phi_15382_ = _e4937;
                                                            phi_15383_ = _e4939;
                                                            phi_15384_ = _e4941;
                                                            phi_15385_ = _e4943;
                                                            phi_15387_ = false;
                                                            phi_15388_ = _e4945;
                                                        } else {
                                                            phi_13201_ = f32();
                                                            phi_13203_ = f32();
                                                            phi_13205_ = f32();
                                                            phi_13207_ = f32();
                                                            phi_13209_ = bool();
                                                            phi_13211_ = u32();
                                                            phi_15380_ = f32();
                                                            phi_15382_ = false;
                                                            phi_15383_ = false;
                                                            phi_15384_ = false;
                                                            phi_15385_ = false;
                                                            phi_15387_ = true;
                                                            phi_15388_ = false;
                                                        }
                                                        let _e4947 = phi_13201_;
                                                        let _e4949 = phi_13203_;
                                                        let _e4951 = phi_13205_;
                                                        let _e4953 = phi_13207_;
                                                        let _e4955 = phi_13209_;
                                                        let _e4957 = phi_13211_;
                                                        let _e4959 = phi_15380_;
                                                        let _e4961 = phi_15382_;
                                                        let _e4963 = phi_15383_;
                                                        let _e4965 = phi_15384_;
                                                        let _e4967 = phi_15385_;
                                                        let _e4969 = phi_15387_;
                                                        let _e4971 = phi_15388_;
                                                        local_29 = _e4963;
                                                        local_69 = _e4965;
                                                        local_70 = _e4967;
                                                        local_71 = _e4969;
                                                        local_72 = _e4971;
                                                        local_73 = _e4963;
                                                        local_74 = _e4959;
                                                        continue;
                                                        continuing {
                                                            phi_13197_ = _e3899;
                                                            phi_13200_ = _e4947;
                                                            phi_13202_ = _e4949;
                                                            phi_13204_ = _e4951;
                                                            phi_13206_ = _e4953;
                                                            phi_13208_ = _e4955;
                                                            phi_13210_ = _e4957;
                                                            break if !(_e4961);
                                                        }
                                                    }
                                                    let _e4974 = local_29;
                                                    if _e4974 {
                                                        phi_15392_ = false;
                                                        phi_15393_ = false;
                                                        phi_15395_ = false;
                                                        phi_15396_ = false;
                                                    } else {
                                                        let _e10592 = local_69;
                                                        phi_15392_ = _e10592;
                                                        let _e10595 = local_70;
                                                        phi_15393_ = _e10595;
                                                        let _e10598 = local_71;
                                                        phi_15395_ = _e10598;
                                                        let _e10601 = local_72;
                                                        phi_15396_ = _e10601;
                                                    }
                                                    let _e4976 = phi_15392_;
                                                    let _e4978 = phi_15393_;
                                                    let _e4980 = phi_15395_;
                                                    let _e4982 = phi_15396_;
                                                    if _e4976 {
                                                        let _e4984 = local_30;
                                                        phi_15401_ = type_28(1u, _e4984);
                                                        phi_15402_ = false;
                                                        phi_15404_ = false;
                                                        phi_15405_ = false;
                                                        phi_15406_ = false;
                                                    } else {
                                                        phi_15401_ = type_28();
                                                        phi_15402_ = _e4978;
                                                        let _e10607 = local_73;
                                                        phi_15404_ = _e10607;
                                                        phi_15405_ = _e4980;
                                                        phi_15406_ = _e4982;
                                                    }
                                                    let _e4987 = phi_15401_;
                                                    let _e4989 = phi_15402_;
                                                    let _e4991 = phi_15404_;
                                                    let _e4993 = phi_15405_;
                                                    let _e4995 = phi_15406_;
                                                    if _e4989 {
                                                        phi_15411_ = type_28(0u, type_28().member_1);
                                                        phi_15413_ = false;
                                                        phi_15414_ = false;
                                                        phi_15415_ = false;
                                                        phi_15416_ = true;
                                                    } else {
                                                        phi_15411_ = _e4987;
                                                        phi_15413_ = _e4991;
                                                        phi_15414_ = _e4993;
                                                        phi_15415_ = _e4995;
                                                        phi_15416_ = _e4976;
                                                    }
                                                    let _e4999 = phi_15411_;
                                                    let _e5001 = phi_15413_;
                                                    let _e5003 = phi_15414_;
                                                    let _e5005 = phi_15415_;
                                                    let _e5007 = phi_15416_;
                                                    if _e5001 {
                                                        let _e10617 = local_74;
                                                        phi_15428_ = _e10617;
                                                        phi_15429_ = true;
                                                        phi_15430_ = false;
                                                        phi_15431_ = false;
                                                    } else {
                                                        let _e10619 = local_75;
                                                        phi_15428_ = _e10619;
                                                        phi_15429_ = _e5003;
                                                        phi_15430_ = _e5005;
                                                        phi_15431_ = _e5007;
                                                    }
                                                    let _e5009 = phi_15428_;
                                                    let _e5011 = phi_15429_;
                                                    let _e5013 = phi_15430_;
                                                    let _e5015 = phi_15431_;
                                                    if _e5011 {
                                                        phi_15436_ = type_28(1u, _e5009);
                                                        phi_15437_ = false;
                                                        phi_15438_ = false;
                                                    } else {
                                                        phi_15436_ = type_28();
                                                        phi_15437_ = _e5013;
                                                        phi_15438_ = _e5015;
                                                    }
                                                    let _e5018 = phi_15436_;
                                                    let _e5020 = phi_15437_;
                                                    let _e5022 = phi_15438_;
                                                    if _e5020 {
                                                        phi_15443_ = type_28(0u, type_28().member_1);
                                                        phi_15444_ = true;
                                                    } else {
                                                        phi_15443_ = _e4999;
                                                        phi_15444_ = _e5022;
                                                    }
                                                    let _e5026 = phi_15443_;
                                                    let _e5028 = phi_15444_;
                                                    if _e5028 {
                                                        phi_15448_ = _e5026;
                                                    } else {
                                                        phi_15448_ = _e5018;
                                                    }
                                                    let _e5030 = phi_15448_;
                                                    let _e5033 = (_e5030.member != 0u);
                                                    if _e5033 {
                                                        phi_15455_ = false;
                                                    } else {
                                                        phi_15455_ = true;
                                                    }
                                                    let _e5035 = phi_15455_;
                                                    phi_15456_ = _e5030.member_1;
                                                    phi_15457_ = _e5035;
                                                    phi_15458_ = _e5033;
                                                    phi_15459_ = false;
                                                } else {
                                                    phi_15456_ = f32();
                                                    phi_15457_ = false;
                                                    phi_15458_ = false;
                                                    phi_15459_ = true;
                                                }
                                                let _e5037 = phi_15456_;
                                                let _e5039 = phi_15457_;
                                                let _e5041 = phi_15458_;
                                                let _e5043 = phi_15459_;
                                                phi_15460_ = _e3640;
                                                phi_15461_ = _e3641;
                                                phi_15462_ = _e5037;
                                                phi_15463_ = _e5039;
                                                phi_15464_ = _e5041;
                                                phi_15465_ = _e5043;
                                            }
                                            let _e5045 = phi_15460_;
                                            let _e5047 = phi_15461_;
                                            let _e5049 = phi_15462_;
                                            let _e5051 = phi_15463_;
                                            let _e5053 = phi_15464_;
                                            let _e5055 = phi_15465_;
                                            phi_15466_ = _e5045;
                                            phi_15467_ = _e5047;
                                            phi_15468_ = _e5049;
                                            phi_15469_ = _e3636;
                                            phi_15470_ = _e5051;
                                            phi_15471_ = _e5053;
                                            phi_15472_ = _e5055;
                                        }
                                        let _e5057 = phi_15466_;
                                        let _e5059 = phi_15467_;
                                        let _e5061 = phi_15468_;
                                        let _e5063 = phi_15469_;
                                        let _e5065 = phi_15470_;
                                        let _e5067 = phi_15471_;
                                        let _e5069 = phi_15472_;
                                        if _e5063 {
                                            phi_15476_ = false;
                                            phi_15477_ = false;
                                            phi_15478_ = false;
                                        } else {
                                            phi_15476_ = _e5065;
                                            phi_15477_ = _e5067;
                                            phi_15478_ = _e5069;
                                        }
                                        let _e5071 = phi_15476_;
                                        let _e5073 = phi_15477_;
                                        let _e5075 = phi_15478_;
                                        phi_15479_ = _e2936;
                                        phi_15480_ = _e5057;
                                        phi_15481_ = _e5059;
                                        phi_15482_ = _e5061;
                                        phi_15483_ = _e2936;
                                        phi_15484_ = _e5063;
                                        phi_15485_ = _e5071;
                                        phi_15486_ = _e5073;
                                        phi_15487_ = _e5075;
                                    } else {
                                        phi_15479_ = type_41();
                                        phi_15480_ = bool();
                                        phi_15481_ = f32();
                                        phi_15482_ = f32();
                                        phi_15483_ = type_41();
                                        phi_15484_ = true;
                                        phi_15485_ = false;
                                        phi_15486_ = false;
                                        phi_15487_ = false;
                                    }
                                    let _e5077 = phi_15479_;
                                    let _e5079 = phi_15480_;
                                    let _e5081 = phi_15481_;
                                    let _e5083 = phi_15482_;
                                    let _e5085 = phi_15483_;
                                    let _e5087 = phi_15484_;
                                    let _e5089 = phi_15485_;
                                    let _e5091 = phi_15486_;
                                    let _e5093 = phi_15487_;
                                    if _e5087 {
                                        phi_15491_ = true;
                                        phi_15492_ = false;
                                        phi_15493_ = false;
                                    } else {
                                        phi_15491_ = _e5089;
                                        phi_15492_ = _e5091;
                                        phi_15493_ = _e5093;
                                    }
                                    let _e5095 = phi_15491_;
                                    let _e5097 = phi_15492_;
                                    let _e5099 = phi_15493_;
                                    phi_15494_ = _e5077;
                                    phi_15495_ = _e5079;
                                    phi_15496_ = _e5081;
                                    phi_15497_ = _e5083;
                                    phi_15498_ = _e5085;
                                    phi_15499_ = _e5095;
                                    phi_15500_ = false;
                                    phi_15501_ = _e5097;
                                    phi_15502_ = _e5099;
                                } else {
                                    phi_15494_ = type_41();
                                    phi_15495_ = bool();
                                    phi_15496_ = f32();
                                    phi_15497_ = f32();
                                    phi_15498_ = type_41();
                                    phi_15499_ = false;
                                    phi_15500_ = true;
                                    phi_15501_ = false;
                                    phi_15502_ = false;
                                }
                                let _e5101 = phi_15494_;
                                let _e5103 = phi_15495_;
                                let _e5105 = phi_15496_;
                                let _e5107 = phi_15497_;
                                let _e5109 = phi_15498_;
                                let _e5111 = phi_15499_;
                                let _e5113 = phi_15500_;
                                let _e5115 = phi_15501_;
                                let _e5117 = phi_15502_;
                                local_31 = _e5113;
                                local_76 = _e5115;
                                local_77 = _e5117;
                                local_32 = _e5103;
                                local_33 = _e5101;
                                local_34 = _e5107;
                                local_35 = _e5105;
                                local_36 = _e5107;
                                local_37 = _e5107;
                                local_38 = _e5109;
                                continue;
                                continuing {
                                    phi_11305_ = _e2659;
                                    break if !(_e5111);
                                }
                            }
                            let _e5120 = local_31;
                            if _e5120 {
                                phi_15507_ = type_28(0u, type_28().member_1);
                                phi_15508_ = false;
                                phi_15509_ = false;
                            } else {
                                phi_15507_ = type_28();
                                let _e10675 = local_76;
                                phi_15508_ = _e10675;
                                let _e10678 = local_77;
                                phi_15509_ = _e10678;
                            }
                            let _e5124 = phi_15507_;
                            let _e5126 = phi_15508_;
                            let _e5128 = phi_15509_;
                            if _e5126 {
                                let _e5130 = local_32;
                                if _e5130 {
                                    let _e5132 = local_33;
                                    let _e5135 = local_34;
                                    let _e5138 = local_35;
                                    if ((_e5132.member_1 - _e5135) <= _e5138) {
                                        let _e5141 = local_36;
                                        phi_15523_ = type_28(1u, _e5141);
                                        phi_15524_ = false;
                                    } else {
                                        phi_15523_ = type_28();
                                        phi_15524_ = true;
                                    }
                                    let _e5144 = phi_15523_;
                                    let _e5146 = phi_15524_;
                                    phi_15525_ = _e5144;
                                    phi_15526_ = _e5146;
                                } else {
                                    phi_15525_ = type_28();
                                    phi_15526_ = true;
                                }
                                let _e5148 = phi_15525_;
                                let _e5150 = phi_15526_;
                                if _e5150 {
                                    let _e5152 = local_37;
                                    phi_15531_ = type_28(2u, _e5152);
                                } else {
                                    phi_15531_ = _e5148;
                                }
                                let _e5155 = phi_15531_;
                                phi_15532_ = _e5155;
                                phi_15533_ = false;
                            } else {
                                phi_15532_ = type_28();
                                phi_15533_ = _e5128;
                            }
                            let _e5157 = phi_15532_;
                            let _e5159 = phi_15533_;
                            if _e5159 {
                                let _e5161 = local_38;
                                phi_15539_ = type_28(1u, _e5161.member);
                                phi_15540_ = true;
                            } else {
                                phi_15539_ = _e5157;
                                phi_15540_ = _e5126;
                            }
                            let _e5165 = phi_15539_;
                            let _e5167 = phi_15540_;
                            phi_15544_ = _e5165;
                            phi_15545_ = _e5124;
                            phi_15546_ = _e5167;
                        } else {
                            phi_15544_ = _e2505;
                            phi_15545_ = type_28();
                            phi_15546_ = true;
                        }
                        let _e5169 = phi_15544_;
                        let _e5171 = phi_15545_;
                        let _e5173 = phi_15546_;
                        phi_15550_ = _e5169;
                        phi_15551_ = _e5171;
                        phi_15552_ = _e5173;
                    }
                    let _e5177 = phi_15550_;
                    let _e5179 = phi_15551_;
                    let _e5181 = phi_15552_;
                    if _e5181 {
                        phi_15556_ = _e5177;
                    } else {
                        phi_15556_ = _e5179;
                    }
                    let _e5183 = phi_15556_;
                    if (_e5183.member == 1u) {
                        if (_e5183.member_1 > _e323) {
                            phi_15567_ = false;
                        } else {
                            phi_15567_ = true;
                        }
                        let _e5189 = phi_15567_;
                        phi_15568_ = _e5189;
                    } else {
                        phi_15568_ = true;
                    }
                    let _e5191 = phi_15568_;
                    if _e5191 {
                        phi_15572_ = false;
                    } else {
                        phi_15572_ = true;
                    }
                    let _e5193 = phi_15572_;
                    if _e5193 {
                        phi_15576_ = 1u;
                    } else {
                        phi_15576_ = 0u;
                    }
                    let _e5195 = phi_15576_;
                    phi_15580_ = type_39(_e5183, _e5195);
                }
                let _e9689 = phi_15580_;
                switch bitcast<i32>(_e9689.member.member) {
                    case 0: {
                        phi_15595_ = type_42(0u, _e9689.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9700 = function_3(_e9689.member.member_1);
                        phi_15595_ = type_42(0u, _e9689.member_1, _e9700, true);
                        break;
                    }
                    case 2: {
                        let _e9696 = function_3(_e9689.member.member_1);
                        phi_15595_ = type_42(1u, _e9689.member_1, _e9696, true);
                        break;
                    }
                    default: {
                        phi_15595_ = type_42();
                        break;
                    }
                }
                let _e9704 = phi_15595_;
                let _e9708 = params.member.member.member_12;
                let _e9709 = bitcast<u32>(_e9708);
                let _e9710 = (_e9709 & 2147483647u);
                if (_e9710 < 8388608u) {
                    phi_15611_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15611_ = array<u32, 2>((_e9709 << bitcast<u32>(29i)), ((_e9709 ^ _e9710) | ((_e9710 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e9721 = phi_15611_;
                if (_e9704.member_2[0] == _e9721[0]) {
                    let _e9727 = params.member.member.member_12;
                    let _e9728 = bitcast<u32>(_e9727);
                    let _e9729 = (_e9728 & 2147483647u);
                    if (_e9729 < 8388608u) {
                        phi_15632_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15632_ = array<u32, 2>((_e9728 << bitcast<u32>(29i)), ((_e9728 ^ _e9729) | ((_e9729 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e9740 = phi_15632_;
                    phi_15635_ = (_e9704.member_2[1] == _e9740[1]);
                } else {
                    phi_15635_ = false;
                }
                let _e9744 = phi_15635_;
                let _e9746 = params.member.member.member_1;
                if ((_e9746 & 128u) != 0u) {
                    phi_15651_ = true;
                } else {
                    let _e9750 = params.member.member.member_1;
                    if ((_e9750 & 64u) != 0u) {
                        phi_15650_ = _e9744;
                    } else {
                        phi_15650_ = false;
                    }
                    let _e9754 = phi_15650_;
                    phi_15651_ = _e9754;
                }
                let _e9756 = phi_15651_;
                if _e9704.member_3 {
                    if _e9756 {
                        phi_15659_ = false;
                    } else {
                        phi_15659_ = true;
                    }
                    let _e9759 = phi_15659_;
                    phi_15660_ = _e9759;
                } else {
                    phi_15660_ = true;
                }
                let _e9761 = phi_15660_;
                if _e9761 {
                    phi_15665_ = _e9704.member;
                } else {
                    phi_15665_ = 1u;
                }
                let _e9764 = phi_15665_;
                if _e9704.member_3 {
                    phi_15673_ = (_e9764 == 0u);
                } else {
                    phi_15673_ = false;
                }
                let _e9770 = phi_15673_;
                if _e9770 {
                    let _e9775 = (_e9704.member_2[1] >> bitcast<u32>(20i));
                    if (_e9775 <= 896u) {
                        phi_15694_ = 0u;
                    } else {
                        phi_15694_ = ((((_e9775 - 896u) << bitcast<u32>(23i)) | ((_e9704.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9704.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9790 = phi_15694_;
                    let _e9792 = atomicMin((&earliest.member[0u]), _e9790);
                }
                phi_15698_ = type_20(0u, 0u, _e210, _e213, _e9704.member_2, _e9704.member_1);
                phi_15699_ = _e9770;
                phi_15700_ = (_e9764 != 0u);
            } else {
                phi_15698_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15699_ = false;
                phi_15700_ = false;
            }
            let _e9794 = phi_15698_;
            let _e9796 = phi_15699_;
            let _e9798 = phi_15700_;
            let _e9801 = params.member.member.member_1;
            if ((_e9801 & 16u) != 0u) {
                if (_e122 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9796 {
                    let _e9807 = atomicAdd((&counters[0u]), 1u);
                    phi_15719_ = _e9807;
                } else {
                    phi_15719_ = 0u;
                }
                let _e9809 = phi_15719_;
                workgroupBarrier();
                if (_e122 == 0u) {
                    let _e9812 = atomicLoad((&counters[0u]));
                    if (_e9812 > 0u) {
                        let _e9815 = atomicAdd((&contacts.member[0u]), _e9812);
                        atomicStore((&counters[1u]), _e9815);
                    }
                }
                workgroupBarrier();
                let _e9818 = atomicLoad((&counters[1u]));
                let _e9819 = (_e9818 + _e9809);
                if _e9796 {
                    let _e9822 = params.member.member_1.member_3;
                    if (_e9819 < _e9822) {
                        let _e9824 = (7u * _e9819);
                        atomicStore((&contacts.member[(4u + _e9824)]), _e9794.member);
                        atomicStore((&contacts.member[(_e9824 + 5u)]), _e9794.member_1);
                        atomicStore((&contacts.member[(_e9824 + 6u)]), _e9794.member_2);
                        atomicStore((&contacts.member[(_e9824 + 7u)]), _e9794.member_3);
                        atomicStore((&contacts.member[(_e9824 + 8u)]), _e9794.member_4[0]);
                        atomicStore((&contacts.member[(_e9824 + 9u)]), _e9794.member_4[1]);
                        atomicStore((&contacts.member[(_e9824 + 10u)]), _e9794.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e122 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9798 {
                let _e9851 = atomicAdd((&counters[0u]), 1u);
                phi_15786_ = _e9851;
            } else {
                phi_15786_ = 0u;
            }
            let _e9853 = phi_15786_;
            workgroupBarrier();
            if (_e122 == 0u) {
                let _e9856 = atomicLoad((&counters[0u]));
                if (_e9856 > 0u) {
                    let _e9859 = atomicAdd((&undecided.member[0u]), _e9856);
                    atomicStore((&counters[1u]), _e9859);
                }
            }
            workgroupBarrier();
            let _e9862 = atomicLoad((&counters[1u]));
            let _e9863 = (_e9862 + _e9853);
            if _e9798 {
                let _e9866 = params.member.member_2.member;
                if (_e9863 < _e9866) {
                    let _e9870 = (2u * _e9863);
                    atomicStore((&undecided.member[(4u + _e9870)]), _e9794.member_2);
                    atomicStore((&undecided.member[(_e9870 + 5u)]), _e9794.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_850_ = _e191;
            break if !(_e197);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
