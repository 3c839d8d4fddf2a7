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

struct type_22 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_27 {
    member: u32,
}

struct type_28 {
    member: type_7,
    member_1: type_8,
    member_2: type_27,
}

struct type_29 {
    member: type_28,
}

struct type_30 {
    member: u32,
    member_1: f32,
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
    member: type_25,
    member_1: f32,
}

struct type_39 {
    member: type_30,
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
var<storage> params: type_29;
@group(0) @binding(2) 
var<storage> elements: type_22;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: f32) -> array<u32, 2> {
    var phi_15832_: array<u32, 2>;

    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_15832_ = array<u32, 2>(0u, 0u);
    } else {
        phi_15832_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_15832_;
    return _e19;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_15817_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_15817_ = param_2;
    } else {
        phi_15817_ = param_1;
    }
    let _e26 = phi_15817_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_15678_: f32;
    var phi_15679_: f32;
    var phi_15718_: f32;
    var phi_15719_: f32;
    var phi_15764_: f32;
    var phi_15765_: f32;
    var phi_15499_: f32;
    var phi_15500_: f32;
    var phi_15545_: f32;
    var phi_15546_: f32;
    var phi_15588_: f32;
    var phi_15589_: f32;
    var phi_15637_: f32;
    var phi_15638_: f32;
    var phi_15780_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_15499_ = _e157;
            } else {
                phi_15499_ = 1f;
            }
            let _e161 = phi_15499_;
            phi_15500_ = _e161;
        } else {
            phi_15500_ = 0f;
        }
        let _e163 = phi_15500_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_15545_ = _e199;
            } else {
                phi_15545_ = 1f;
            }
            let _e203 = phi_15545_;
            phi_15546_ = _e203;
        } else {
            phi_15546_ = 0f;
        }
        let _e205 = phi_15546_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_15588_ = _e238;
            } else {
                phi_15588_ = 1f;
            }
            let _e242 = phi_15588_;
            phi_15589_ = _e242;
        } else {
            phi_15589_ = 0f;
        }
        let _e244 = phi_15589_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_15637_ = _e283;
            } else {
                phi_15637_ = 1f;
            }
            let _e287 = phi_15637_;
            phi_15638_ = _e287;
        } else {
            phi_15638_ = 0f;
        }
        let _e289 = phi_15638_;
        phi_15780_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_15678_ = _e36;
            } else {
                phi_15678_ = 1f;
            }
            let _e40 = phi_15678_;
            phi_15679_ = _e40;
        } else {
            phi_15679_ = 0f;
        }
        let _e42 = phi_15679_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_15718_ = _e72;
            } else {
                phi_15718_ = 1f;
            }
            let _e76 = phi_15718_;
            phi_15719_ = _e76;
        } else {
            phi_15719_ = 0f;
        }
        let _e78 = phi_15719_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_15764_ = _e114;
            } else {
                phi_15764_ = 1f;
            }
            let _e118 = phi_15764_;
            phi_15765_ = _e118;
        } else {
            phi_15765_ = 0f;
        }
        let _e120 = phi_15765_;
        phi_15780_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_15780_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_15400_: bool;
    var phi_15401_: bool;
    var phi_15402_: bool;
    var phi_15403_: bool;
    var phi_15407_: bool;
    var phi_15380_: bool;
    var phi_15381_: bool;
    var phi_15382_: bool;
    var phi_15383_: bool;
    var phi_15384_: bool;
    var phi_15385_: bool;
    var phi_15389_: bool;
    var phi_15408_: bool;
    var phi_15441_: array<f32, 3>;
    var phi_15442_: bool;
    var phi_15443_: array<f32, 3>;
    var phi_15444_: bool;
    var phi_15449_: array<f32, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                if (_e74 <= 1f) {
                    phi_15380_ = (_e78 <= 1f);
                    phi_15381_ = false;
                } else {
                    phi_15380_ = bool();
                    phi_15381_ = true;
                }
                let _e99 = phi_15380_;
                let _e101 = phi_15381_;
                phi_15382_ = _e99;
                phi_15383_ = _e101;
            } else {
                phi_15382_ = bool();
                phi_15383_ = true;
            }
            let _e103 = phi_15382_;
            let _e105 = phi_15383_;
            phi_15384_ = _e103;
            phi_15385_ = _e105;
        } else {
            phi_15384_ = bool();
            phi_15385_ = true;
        }
        let _e107 = phi_15384_;
        let _e109 = phi_15385_;
        if _e109 {
            phi_15389_ = false;
        } else {
            phi_15389_ = _e107;
        }
        let _e111 = phi_15389_;
        phi_15408_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_15400_ = ((_e74 + _e78) <= 1f);
                phi_15401_ = false;
            } else {
                phi_15400_ = bool();
                phi_15401_ = true;
            }
            let _e85 = phi_15400_;
            let _e87 = phi_15401_;
            phi_15402_ = _e85;
            phi_15403_ = _e87;
        } else {
            phi_15402_ = bool();
            phi_15403_ = true;
        }
        let _e89 = phi_15402_;
        let _e91 = phi_15403_;
        if _e91 {
            phi_15407_ = false;
        } else {
            phi_15407_ = _e89;
        }
        let _e93 = phi_15407_;
        phi_15408_ = _e93;
    }
    let _e113 = phi_15408_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_15441_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_15442_ = false;
        } else {
            phi_15441_ = array<f32, 3>();
            phi_15442_ = true;
        }
        let _e141 = phi_15441_;
        let _e143 = phi_15442_;
        phi_15443_ = _e141;
        phi_15444_ = _e143;
    } else {
        phi_15443_ = array<f32, 3>();
        phi_15444_ = true;
    }
    let _e145 = phi_15443_;
    let _e147 = phi_15444_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_15449_ = _e148;
    } else {
        phi_15449_ = _e145;
    }
    let _e150 = phi_15449_;
    return _e150;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_32;
    var local_1: type_32;
    var local_2: type_26;
    var local_3: type_26;
    var local_4: type_26;
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
    var local_18: type_25;
    var phi_250_: u32;
    var phi_260_: u32;
    var phi_267_: u32;
    var phi_283_: u32;
    var phi_304_: u32;
    var phi_305_: u32;
    var phi_308_: type_12;
    var phi_309_: type_12;
    var phi_332_: type_12;
    var phi_518_: array<u32, 2>;
    var phi_532_: bool;
    var phi_548_: bool;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_627_: f32;
    var phi_633_: f32;
    var phi_638_: f32;
    var phi_644_: f32;
    var phi_650_: f32;
    var phi_655_: f32;
    var phi_661_: f32;
    var phi_666_: f32;
    var phi_671_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_689_: f32;
    var phi_695_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_728_: f32;
    var phi_733_: f32;
    var phi_739_: f32;
    var phi_744_: f32;
    var phi_751_: bool;
    var phi_775_: u32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_820_: type_38;
    var phi_821_: bool;
    var phi_822_: type_38;
    var phi_823_: bool;
    var phi_824_: type_38;
    var phi_825_: bool;
    var phi_830_: type_38;
    var phi_7776_: f32;
    var phi_7783_: f32;
    var phi_7788_: f32;
    var phi_7795_: f32;
    var phi_7800_: f32;
    var phi_7813_: f32;
    var phi_7820_: f32;
    var phi_7825_: f32;
    var phi_7832_: f32;
    var phi_7837_: f32;
    var phi_7842_: f32;
    var phi_7859_: f32;
    var phi_7866_: f32;
    var phi_7871_: f32;
    var phi_7878_: f32;
    var phi_7883_: f32;
    var phi_7897_: f32;
    var phi_7904_: f32;
    var phi_7909_: f32;
    var phi_7916_: f32;
    var phi_7921_: f32;
    var phi_7926_: f32;
    var phi_7943_: f32;
    var phi_7950_: f32;
    var phi_7955_: f32;
    var phi_7962_: f32;
    var phi_7967_: f32;
    var phi_7981_: f32;
    var phi_7988_: f32;
    var phi_7993_: f32;
    var phi_8000_: f32;
    var phi_8005_: f32;
    var phi_8010_: f32;
    var phi_8041_: f32;
    var phi_8047_: f32;
    var phi_8054_: f32;
    var phi_8061_: f32;
    var phi_8067_: f32;
    var phi_8074_: f32;
    var phi_8080_: f32;
    var phi_8086_: f32;
    var phi_8092_: f32;
    var phi_8099_: f32;
    var phi_8106_: f32;
    var phi_8130_: f32;
    var phi_8135_: f32;
    var phi_8140_: f32;
    var phi_8145_: f32;
    var phi_8150_: f32;
    var phi_8155_: f32;
    var phi_8165_: f32;
    var phi_8178_: f32;
    var phi_8184_: f32;
    var phi_8189_: f32;
    var phi_8195_: f32;
    var phi_8201_: f32;
    var phi_8206_: f32;
    var phi_8211_: f32;
    var phi_8219_: bool;
    var phi_8224_: f32;
    var phi_8231_: f32;
    var phi_8237_: f32;
    var phi_8255_: f32;
    var phi_8403_: f32;
    var phi_8410_: f32;
    var phi_8415_: f32;
    var phi_8422_: f32;
    var phi_8427_: f32;
    var phi_8440_: f32;
    var phi_8447_: f32;
    var phi_8452_: f32;
    var phi_8459_: f32;
    var phi_8464_: f32;
    var phi_8469_: f32;
    var phi_8486_: f32;
    var phi_8493_: f32;
    var phi_8498_: f32;
    var phi_8505_: f32;
    var phi_8510_: f32;
    var phi_8524_: f32;
    var phi_8531_: f32;
    var phi_8536_: f32;
    var phi_8543_: f32;
    var phi_8548_: f32;
    var phi_8553_: f32;
    var phi_8570_: f32;
    var phi_8577_: f32;
    var phi_8582_: f32;
    var phi_8589_: f32;
    var phi_8594_: f32;
    var phi_8608_: f32;
    var phi_8615_: f32;
    var phi_8620_: f32;
    var phi_8627_: f32;
    var phi_8632_: f32;
    var phi_8637_: f32;
    var phi_8755_: f32;
    var phi_8762_: f32;
    var phi_8770_: f32;
    var phi_8814_: type_14;
    var phi_8817_: f32;
    var phi_8838_: bool;
    var phi_8844_: type_15;
    var phi_8815_: type_14;
    var phi_8858_: type_15;
    var phi_8818_: f32;
    var local_19: f32;
    var phi_8807_: f32;
    var phi_8871_: f32;
    var phi_8937_: f32;
    var phi_8943_: f32;
    var phi_8952_: f32;
    var phi_8958_: f32;
    var phi_8967_: f32;
    var phi_8973_: f32;
    var phi_8982_: f32;
    var phi_8988_: f32;
    var phi_8994_: type_32;
    var phi_8995_: bool;
    var phi_8996_: type_32;
    var phi_8997_: bool;
    var phi_9005_: type_32;
    var phi_9174_: bool;
    var phi_9175_: bool;
    var phi_9176_: bool;
    var phi_9177_: bool;
    var phi_9178_: bool;
    var phi_9179_: bool;
    var phi_9183_: bool;
    var phi_9210_: f32;
    var phi_9264_: type_14;
    var phi_9267_: f32;
    var phi_9288_: bool;
    var phi_9294_: type_15;
    var phi_9265_: type_14;
    var phi_9308_: type_15;
    var phi_9268_: f32;
    var local_20: f32;
    var phi_9257_: f32;
    var phi_9321_: f32;
    var phi_9387_: f32;
    var phi_9393_: f32;
    var phi_9402_: f32;
    var phi_9408_: f32;
    var phi_9417_: f32;
    var phi_9423_: f32;
    var phi_9432_: f32;
    var phi_9438_: f32;
    var phi_9444_: type_32;
    var phi_9445_: bool;
    var phi_9446_: type_32;
    var phi_9447_: bool;
    var phi_9455_: type_32;
    var phi_9624_: bool;
    var phi_9625_: bool;
    var phi_9626_: bool;
    var phi_9627_: bool;
    var phi_9628_: bool;
    var phi_9629_: bool;
    var phi_9633_: bool;
    var phi_9666_: f32;
    var phi_9714_: type_14;
    var phi_9717_: f32;
    var phi_9738_: bool;
    var phi_9744_: type_15;
    var phi_9715_: type_14;
    var phi_9758_: type_15;
    var phi_9718_: f32;
    var local_21: f32;
    var phi_9707_: f32;
    var phi_9771_: f32;
    var phi_9837_: f32;
    var phi_9843_: f32;
    var phi_9852_: f32;
    var phi_9858_: f32;
    var phi_9867_: f32;
    var phi_9873_: f32;
    var phi_9882_: f32;
    var phi_9888_: f32;
    var phi_9894_: type_32;
    var phi_9895_: bool;
    var phi_9896_: type_32;
    var phi_9897_: bool;
    var phi_9905_: type_32;
    var phi_10074_: bool;
    var phi_10075_: bool;
    var phi_10076_: bool;
    var phi_10077_: bool;
    var phi_10078_: bool;
    var phi_10079_: bool;
    var phi_10083_: bool;
    var phi_10123_: f32;
    var phi_10164_: type_14;
    var phi_10167_: f32;
    var phi_10188_: bool;
    var phi_10194_: type_15;
    var phi_10165_: type_14;
    var phi_10208_: type_15;
    var phi_10168_: f32;
    var local_22: f32;
    var phi_10157_: f32;
    var phi_10221_: f32;
    var phi_10287_: f32;
    var phi_10293_: f32;
    var phi_10302_: f32;
    var phi_10308_: f32;
    var phi_10317_: f32;
    var phi_10323_: f32;
    var phi_10332_: f32;
    var phi_10338_: f32;
    var phi_10344_: type_32;
    var phi_10345_: bool;
    var phi_10346_: type_32;
    var phi_10347_: bool;
    var phi_10355_: type_32;
    var phi_10524_: bool;
    var phi_10525_: bool;
    var phi_10526_: bool;
    var phi_10527_: bool;
    var phi_10528_: bool;
    var phi_10529_: bool;
    var phi_10533_: bool;
    var phi_10534_: bool;
    var phi_10535_: bool;
    var phi_10536_: bool;
    var phi_10537_: bool;
    var phi_10538_: bool;
    var phi_10542_: bool;
    var phi_10548_: type_30;
    var phi_10549_: bool;
    var phi_10550_: type_30;
    var phi_10551_: bool;
    var phi_10594_: type_14;
    var phi_10597_: f32;
    var phi_10618_: bool;
    var phi_10624_: type_15;
    var phi_10595_: type_14;
    var phi_10638_: type_15;
    var phi_10598_: f32;
    var local_23: f32;
    var phi_10587_: f32;
    var phi_10651_: f32;
    var phi_10657_: f32;
    var phi_10682_: type_12;
    var phi_10685_: u32;
    var phi_10683_: type_12;
    var phi_10708_: type_12;
    var phi_10752_: u32;
    var phi_10753_: u32;
    var phi_10686_: u32;
    var phi_10754_: u32;
    var phi_10774_: type_12;
    var phi_10775_: type_12;
    var phi_10798_: type_12;
    var phi_10817_: f32;
    var phi_10830_: f32;
    var phi_10864_: f32;
    var phi_10871_: f32;
    var phi_10882_: bool;
    var phi_10883_: bool;
    var phi_10884_: bool;
    var phi_10885_: bool;
    var phi_10889_: bool;
    var phi_10900_: type_41;
    var phi_10901_: type_41;
    var phi_10902_: bool;
    var phi_10903_: type_41;
    var phi_10904_: bool;
    var phi_10915_: f32;
    var phi_10925_: type_12;
    var phi_10928_: f32;
    var phi_10930_: f32;
    var phi_10932_: f32;
    var phi_10926_: type_12;
    var phi_10955_: type_12;
    var phi_10980_: f32;
    var phi_10981_: f32;
    var phi_11007_: f32;
    var phi_11023_: f32;
    var phi_11030_: bool;
    var phi_11031_: bool;
    var phi_11032_: bool;
    var phi_11038_: f32;
    var phi_11039_: f32;
    var phi_11040_: bool;
    var phi_10929_: f32;
    var phi_10931_: f32;
    var phi_10933_: f32;
    var phi_11041_: f32;
    var phi_11042_: bool;
    var phi_11043_: bool;
    var local_24: bool;
    var phi_11047_: f32;
    var phi_11048_: f32;
    var phi_11056_: f32;
    var phi_11060_: type_12;
    var phi_11063_: f32;
    var phi_11061_: type_12;
    var phi_11086_: type_12;
    var phi_11116_: f32;
    var phi_11117_: bool;
    var phi_11118_: f32;
    var phi_11119_: bool;
    var phi_11120_: bool;
    var phi_11121_: bool;
    var phi_11122_: f32;
    var phi_11064_: f32;
    var phi_11123_: bool;
    var phi_11124_: bool;
    var phi_11125_: bool;
    var phi_11126_: bool;
    var local_25: bool;
    var phi_11130_: bool;
    var phi_11131_: bool;
    var phi_11135_: bool;
    var phi_11139_: f32;
    var phi_11140_: f32;
    var phi_11142_: type_41;
    var phi_11171_: f32;
    var phi_11178_: f32;
    var phi_11183_: f32;
    var phi_11190_: f32;
    var phi_11195_: f32;
    var phi_11208_: f32;
    var phi_11215_: f32;
    var phi_11220_: f32;
    var phi_11227_: f32;
    var phi_11232_: f32;
    var phi_11237_: f32;
    var phi_11296_: f32;
    var phi_11302_: f32;
    var phi_11307_: f32;
    var phi_11313_: f32;
    var phi_11318_: f32;
    var phi_11330_: f32;
    var phi_11336_: f32;
    var phi_11341_: f32;
    var phi_11347_: f32;
    var phi_11352_: f32;
    var phi_11378_: f32;
    var phi_11385_: f32;
    var phi_11390_: f32;
    var phi_11397_: f32;
    var phi_11402_: f32;
    var phi_11415_: f32;
    var phi_11422_: f32;
    var phi_11427_: f32;
    var phi_11434_: f32;
    var phi_11439_: f32;
    var phi_11444_: f32;
    var phi_11503_: f32;
    var phi_11509_: f32;
    var phi_11514_: f32;
    var phi_11520_: f32;
    var phi_11525_: f32;
    var phi_11537_: f32;
    var phi_11543_: f32;
    var phi_11548_: f32;
    var phi_11554_: f32;
    var phi_11559_: f32;
    var phi_11585_: f32;
    var phi_11592_: f32;
    var phi_11597_: f32;
    var phi_11604_: f32;
    var phi_11609_: f32;
    var phi_11622_: f32;
    var phi_11629_: f32;
    var phi_11634_: f32;
    var phi_11641_: f32;
    var phi_11646_: f32;
    var phi_11651_: f32;
    var phi_11710_: f32;
    var phi_11716_: f32;
    var phi_11721_: f32;
    var phi_11727_: f32;
    var phi_11732_: f32;
    var phi_11744_: f32;
    var phi_11750_: f32;
    var phi_11755_: f32;
    var phi_11761_: f32;
    var phi_11766_: f32;
    var phi_11815_: f32;
    var phi_11821_: f32;
    var phi_11849_: f32;
    var phi_11855_: f32;
    var phi_11860_: u32;
    var phi_11861_: u32;
    var phi_11831_: f32;
    var phi_11837_: f32;
    var phi_11842_: u32;
    var phi_11843_: u32;
    var phi_11862_: u32;
    var phi_11863_: u32;
    var phi_11932_: f32;
    var phi_11941_: f32;
    var phi_12076_: f32;
    var phi_12082_: f32;
    var phi_12089_: f32;
    var phi_12144_: type_12;
    var phi_12147_: bool;
    var phi_12145_: type_12;
    var phi_12170_: type_12;
    var phi_12197_: bool;
    var phi_12198_: bool;
    var phi_12148_: bool;
    var phi_12199_: bool;
    var phi_12200_: bool;
    var local_26: bool;
    var phi_12204_: bool;
    var local_27: bool;
    var phi_12211_: u32;
    var phi_12212_: u32;
    var phi_12213_: bool;
    var phi_12214_: u32;
    var phi_12215_: u32;
    var phi_12216_: bool;
    var phi_12220_: u32;
    var phi_12230_: bool;
    var phi_12242_: bool;
    var phi_12243_: bool;
    var phi_12391_: f32;
    var phi_12398_: f32;
    var phi_12403_: f32;
    var phi_12410_: f32;
    var phi_12415_: f32;
    var phi_12428_: f32;
    var phi_12435_: f32;
    var phi_12440_: f32;
    var phi_12447_: f32;
    var phi_12452_: f32;
    var phi_12457_: f32;
    var phi_12474_: f32;
    var phi_12481_: f32;
    var phi_12486_: f32;
    var phi_12493_: f32;
    var phi_12498_: f32;
    var phi_12512_: f32;
    var phi_12519_: f32;
    var phi_12524_: f32;
    var phi_12531_: f32;
    var phi_12536_: f32;
    var phi_12541_: f32;
    var phi_12558_: f32;
    var phi_12565_: f32;
    var phi_12570_: f32;
    var phi_12577_: f32;
    var phi_12582_: f32;
    var phi_12596_: f32;
    var phi_12603_: f32;
    var phi_12608_: f32;
    var phi_12615_: f32;
    var phi_12620_: f32;
    var phi_12625_: f32;
    var phi_12666_: type_12;
    var phi_12669_: f32;
    var phi_12671_: f32;
    var phi_12673_: f32;
    var phi_12675_: f32;
    var phi_12677_: bool;
    var phi_12679_: u32;
    var phi_12667_: type_12;
    var phi_12702_: type_12;
    var phi_12816_: f32;
    var phi_12822_: f32;
    var phi_12828_: f32;
    var phi_12830_: array<f32, 3>;
    var phi_12837_: f32;
    var phi_12844_: f32;
    var phi_12852_: f32;
    var phi_12896_: type_14;
    var phi_12899_: f32;
    var phi_12920_: bool;
    var phi_12926_: type_15;
    var phi_12897_: type_14;
    var phi_12940_: type_15;
    var phi_12900_: f32;
    var local_28: f32;
    var phi_12889_: f32;
    var phi_12953_: f32;
    var phi_13019_: f32;
    var phi_13025_: f32;
    var phi_13034_: f32;
    var phi_13040_: f32;
    var phi_13049_: f32;
    var phi_13055_: f32;
    var phi_13064_: f32;
    var phi_13070_: f32;
    var phi_13076_: type_32;
    var phi_13077_: bool;
    var phi_13078_: type_32;
    var phi_13079_: bool;
    var phi_13087_: type_32;
    var phi_13258_: bool;
    var phi_13259_: bool;
    var phi_13260_: bool;
    var phi_13261_: bool;
    var phi_13262_: bool;
    var phi_13263_: bool;
    var phi_13267_: bool;
    var phi_13564_: bool;
    var phi_13565_: bool;
    var phi_13566_: bool;
    var phi_13567_: bool;
    var phi_13568_: bool;
    var phi_13569_: bool;
    var phi_13573_: bool;
    var phi_13577_: bool;
    var phi_13588_: bool;
    var phi_13589_: bool;
    var phi_13663_: bool;
    var phi_13664_: bool;
    var phi_13684_: f32;
    var phi_13685_: bool;
    var phi_13686_: f32;
    var phi_13687_: bool;
    var phi_13688_: f32;
    var phi_13689_: bool;
    var phi_13690_: bool;
    var phi_13694_: f32;
    var phi_13695_: bool;
    var phi_13699_: f32;
    var phi_13731_: bool;
    var phi_13732_: bool;
    var phi_13752_: f32;
    var phi_13753_: bool;
    var phi_13754_: f32;
    var phi_13755_: bool;
    var phi_13756_: f32;
    var phi_13757_: bool;
    var phi_13758_: bool;
    var phi_13762_: f32;
    var phi_13763_: bool;
    var phi_13767_: f32;
    var phi_13772_: f32;
    var phi_13804_: bool;
    var phi_13805_: bool;
    var phi_13825_: f32;
    var phi_13826_: bool;
    var phi_13827_: f32;
    var phi_13828_: bool;
    var phi_13829_: f32;
    var phi_13830_: bool;
    var phi_13831_: bool;
    var phi_13835_: f32;
    var phi_13836_: bool;
    var phi_13840_: f32;
    var phi_13872_: bool;
    var phi_13873_: bool;
    var phi_13893_: f32;
    var phi_13894_: bool;
    var phi_13895_: f32;
    var phi_13896_: bool;
    var phi_13897_: f32;
    var phi_13898_: bool;
    var phi_13899_: bool;
    var phi_13903_: f32;
    var phi_13904_: bool;
    var phi_13908_: f32;
    var phi_13913_: f32;
    var phi_13918_: f32;
    var phi_13923_: f32;
    var phi_14417_: bool;
    var phi_14418_: bool;
    var phi_14423_: f32;
    var phi_14425_: f32;
    var phi_14428_: f32;
    var phi_14429_: f32;
    var phi_14430_: bool;
    var phi_14432_: f32;
    var phi_14433_: f32;
    var phi_14434_: f32;
    var phi_14436_: bool;
    var phi_14437_: bool;
    var phi_14439_: bool;
    var phi_14440_: f32;
    var phi_14441_: f32;
    var phi_14442_: f32;
    var phi_14444_: bool;
    var phi_14445_: bool;
    var phi_14446_: bool;
    var phi_14448_: bool;
    var phi_14449_: f32;
    var phi_14450_: f32;
    var phi_14451_: f32;
    var phi_14453_: bool;
    var phi_14454_: bool;
    var phi_14455_: bool;
    var phi_14457_: bool;
    var phi_14543_: f32;
    var phi_14616_: f32;
    var phi_14621_: f32;
    var phi_14694_: f32;
    var phi_14767_: f32;
    var phi_14772_: f32;
    var phi_14788_: f32;
    var phi_14789_: f32;
    var phi_14790_: f32;
    var phi_14470_: bool;
    var phi_14792_: u32;
    var phi_14793_: f32;
    var phi_14794_: bool;
    var phi_14795_: bool;
    var phi_14796_: bool;
    var phi_14797_: u32;
    var phi_14798_: f32;
    var phi_14799_: f32;
    var phi_14800_: f32;
    var phi_14801_: f32;
    var phi_14802_: bool;
    var phi_14803_: u32;
    var phi_14804_: bool;
    var phi_14805_: bool;
    var phi_14806_: bool;
    var phi_14807_: bool;
    var phi_14809_: bool;
    var phi_14818_: f32;
    var phi_14823_: f32;
    var phi_14832_: bool;
    var phi_14836_: bool;
    var phi_14837_: f32;
    var phi_14838_: f32;
    var phi_14839_: f32;
    var phi_14840_: f32;
    var phi_14841_: bool;
    var phi_14842_: u32;
    var phi_14843_: bool;
    var phi_14844_: bool;
    var phi_14845_: bool;
    var phi_14846_: bool;
    var phi_14848_: bool;
    var phi_12670_: f32;
    var phi_12672_: f32;
    var phi_12674_: f32;
    var phi_12676_: f32;
    var phi_12678_: bool;
    var phi_12680_: u32;
    var phi_14849_: f32;
    var phi_14851_: bool;
    var phi_14852_: bool;
    var phi_14853_: bool;
    var phi_14854_: bool;
    var phi_14856_: bool;
    var phi_14857_: bool;
    var local_29: bool;
    var phi_14861_: bool;
    var phi_14862_: bool;
    var phi_14864_: bool;
    var phi_14865_: bool;
    var local_30: f32;
    var phi_14870_: type_30;
    var phi_14871_: bool;
    var phi_14873_: bool;
    var phi_14874_: bool;
    var phi_14875_: bool;
    var phi_14880_: type_30;
    var phi_14882_: bool;
    var phi_14883_: bool;
    var phi_14884_: bool;
    var phi_14885_: bool;
    var phi_14897_: f32;
    var phi_14898_: bool;
    var phi_14899_: bool;
    var phi_14900_: bool;
    var phi_14905_: type_30;
    var phi_14906_: bool;
    var phi_14907_: bool;
    var phi_14912_: type_30;
    var phi_14913_: bool;
    var phi_14917_: type_30;
    var phi_14924_: bool;
    var phi_14925_: f32;
    var phi_14926_: bool;
    var phi_14927_: bool;
    var phi_14928_: bool;
    var phi_14929_: bool;
    var phi_14930_: f32;
    var phi_14931_: f32;
    var phi_14932_: bool;
    var phi_14933_: bool;
    var phi_14934_: bool;
    var phi_14935_: bool;
    var phi_14936_: f32;
    var phi_14937_: f32;
    var phi_14938_: bool;
    var phi_14939_: bool;
    var phi_14940_: bool;
    var phi_14941_: bool;
    var phi_14945_: bool;
    var phi_14946_: bool;
    var phi_14947_: bool;
    var phi_14948_: type_41;
    var phi_14949_: bool;
    var phi_14950_: f32;
    var phi_14951_: f32;
    var phi_14952_: type_41;
    var phi_14953_: bool;
    var phi_14954_: bool;
    var phi_14955_: bool;
    var phi_14956_: bool;
    var phi_14960_: bool;
    var phi_14961_: bool;
    var phi_14962_: bool;
    var phi_14963_: type_41;
    var phi_14964_: bool;
    var phi_14965_: f32;
    var phi_14966_: f32;
    var phi_14967_: type_41;
    var phi_14968_: bool;
    var phi_14969_: bool;
    var phi_14970_: bool;
    var phi_14971_: bool;
    var local_31: bool;
    var phi_14976_: type_30;
    var phi_14977_: bool;
    var phi_14978_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_14992_: type_30;
    var phi_14993_: bool;
    var phi_14994_: type_30;
    var phi_14995_: bool;
    var local_37: f32;
    var phi_15000_: type_30;
    var phi_15001_: type_30;
    var phi_15002_: bool;
    var local_38: type_41;
    var phi_15008_: type_30;
    var phi_15009_: bool;
    var phi_15013_: type_30;
    var phi_15014_: type_30;
    var phi_15015_: bool;
    var phi_15019_: type_30;
    var phi_15020_: type_30;
    var phi_15021_: bool;
    var phi_15025_: type_30;
    var phi_15036_: bool;
    var phi_15037_: bool;
    var phi_15041_: bool;
    var phi_15045_: u32;
    var phi_1004_: type_14;
    var phi_1007_: f32;
    var phi_1028_: bool;
    var phi_1034_: type_15;
    var phi_1005_: type_14;
    var phi_1048_: type_15;
    var phi_1008_: f32;
    var local_39: f32;
    var phi_997_: f32;
    var phi_1061_: f32;
    var phi_1077_: f32;
    var phi_1084_: f32;
    var phi_1089_: f32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1114_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1133_: f32;
    var phi_1138_: f32;
    var phi_1143_: f32;
    var phi_1160_: f32;
    var phi_1167_: f32;
    var phi_1172_: f32;
    var phi_1179_: f32;
    var phi_1184_: f32;
    var phi_1198_: f32;
    var phi_1205_: f32;
    var phi_1210_: f32;
    var phi_1217_: f32;
    var phi_1222_: f32;
    var phi_1227_: f32;
    var phi_1244_: f32;
    var phi_1251_: f32;
    var phi_1256_: f32;
    var phi_1263_: f32;
    var phi_1268_: f32;
    var phi_1282_: f32;
    var phi_1289_: f32;
    var phi_1294_: f32;
    var phi_1301_: f32;
    var phi_1306_: f32;
    var phi_1311_: f32;
    var phi_1572_: f32;
    var phi_1579_: f32;
    var phi_1584_: f32;
    var phi_1591_: f32;
    var phi_1596_: f32;
    var phi_1609_: f32;
    var phi_1616_: f32;
    var phi_1621_: f32;
    var phi_1628_: f32;
    var phi_1633_: f32;
    var phi_1638_: f32;
    var phi_1655_: f32;
    var phi_1662_: f32;
    var phi_1667_: f32;
    var phi_1674_: f32;
    var phi_1679_: f32;
    var phi_1693_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1712_: f32;
    var phi_1717_: f32;
    var phi_1722_: f32;
    var phi_1739_: f32;
    var phi_1746_: f32;
    var phi_1751_: f32;
    var phi_1758_: f32;
    var phi_1763_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1789_: f32;
    var phi_1796_: f32;
    var phi_1801_: f32;
    var phi_1806_: f32;
    var phi_1837_: f32;
    var phi_1843_: f32;
    var phi_1850_: f32;
    var phi_1857_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1876_: f32;
    var phi_1882_: f32;
    var phi_1888_: f32;
    var phi_1895_: f32;
    var phi_1902_: f32;
    var phi_1926_: f32;
    var phi_1931_: f32;
    var phi_1936_: f32;
    var phi_1941_: f32;
    var phi_1946_: f32;
    var phi_1951_: f32;
    var phi_1961_: f32;
    var phi_1970_: type_39;
    var phi_1971_: bool;
    var phi_1972_: type_39;
    var phi_1973_: bool;
    var phi_1979_: type_14;
    var phi_1982_: f32;
    var phi_1984_: u32;
    var phi_1986_: f32;
    var phi_2007_: bool;
    var phi_2013_: type_15;
    var phi_1980_: type_14;
    var phi_2027_: type_15;
    var phi_2042_: bool;
    var phi_2043_: bool;
    var phi_2189_: f32;
    var phi_2196_: f32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
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
    var phi_2356_: f32;
    var phi_2363_: f32;
    var phi_2368_: f32;
    var phi_2375_: f32;
    var phi_2380_: f32;
    var phi_2394_: f32;
    var phi_2401_: f32;
    var phi_2406_: f32;
    var phi_2413_: f32;
    var phi_2418_: f32;
    var phi_2423_: f32;
    var phi_2464_: type_12;
    var phi_2467_: f32;
    var phi_2469_: f32;
    var phi_2471_: f32;
    var phi_2473_: f32;
    var phi_2475_: bool;
    var phi_2477_: u32;
    var phi_2465_: type_12;
    var phi_2500_: type_12;
    var phi_2614_: f32;
    var phi_2620_: f32;
    var phi_2626_: f32;
    var phi_2628_: array<f32, 3>;
    var phi_2635_: f32;
    var phi_2642_: f32;
    var phi_2650_: f32;
    var phi_2694_: type_14;
    var phi_2697_: f32;
    var phi_2718_: bool;
    var phi_2724_: type_15;
    var phi_2695_: type_14;
    var phi_2738_: type_15;
    var phi_2698_: f32;
    var local_40: f32;
    var phi_2687_: f32;
    var phi_2751_: f32;
    var phi_2817_: f32;
    var phi_2823_: f32;
    var phi_2832_: f32;
    var phi_2838_: f32;
    var phi_2847_: f32;
    var phi_2853_: f32;
    var phi_2862_: f32;
    var phi_2868_: f32;
    var phi_2874_: type_32;
    var phi_2875_: bool;
    var phi_2876_: type_32;
    var phi_2877_: bool;
    var phi_2885_: type_32;
    var phi_3056_: bool;
    var phi_3057_: bool;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3060_: bool;
    var phi_3061_: bool;
    var phi_3065_: bool;
    var phi_3362_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3371_: bool;
    var phi_3375_: bool;
    var phi_3386_: bool;
    var phi_3387_: bool;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3482_: f32;
    var phi_3483_: bool;
    var phi_3484_: f32;
    var phi_3485_: bool;
    var phi_3486_: f32;
    var phi_3487_: bool;
    var phi_3488_: bool;
    var phi_3492_: f32;
    var phi_3493_: bool;
    var phi_3497_: f32;
    var phi_3529_: bool;
    var phi_3530_: bool;
    var phi_3550_: f32;
    var phi_3551_: bool;
    var phi_3552_: f32;
    var phi_3553_: bool;
    var phi_3554_: f32;
    var phi_3555_: bool;
    var phi_3556_: bool;
    var phi_3560_: f32;
    var phi_3561_: bool;
    var phi_3565_: f32;
    var phi_3570_: f32;
    var phi_3602_: bool;
    var phi_3603_: bool;
    var phi_3623_: f32;
    var phi_3624_: bool;
    var phi_3625_: f32;
    var phi_3626_: bool;
    var phi_3627_: f32;
    var phi_3628_: bool;
    var phi_3629_: bool;
    var phi_3633_: f32;
    var phi_3634_: bool;
    var phi_3638_: f32;
    var phi_3670_: bool;
    var phi_3671_: bool;
    var phi_3691_: f32;
    var phi_3692_: bool;
    var phi_3693_: f32;
    var phi_3694_: bool;
    var phi_3695_: f32;
    var phi_3696_: bool;
    var phi_3697_: bool;
    var phi_3701_: f32;
    var phi_3702_: bool;
    var phi_3706_: f32;
    var phi_3711_: f32;
    var phi_3716_: f32;
    var phi_3721_: f32;
    var phi_3734_: f32;
    var phi_3871_: type_14;
    var phi_3874_: f32;
    var phi_3895_: bool;
    var phi_3901_: type_15;
    var phi_3872_: type_14;
    var phi_3915_: type_15;
    var phi_3875_: f32;
    var local_41: f32;
    var phi_3864_: f32;
    var phi_3928_: f32;
    var phi_3944_: f32;
    var phi_3951_: f32;
    var phi_3956_: f32;
    var phi_3963_: f32;
    var phi_3968_: f32;
    var phi_3981_: f32;
    var phi_3988_: f32;
    var phi_3993_: f32;
    var phi_4000_: f32;
    var phi_4005_: f32;
    var phi_4010_: f32;
    var phi_4027_: f32;
    var phi_4034_: f32;
    var phi_4039_: f32;
    var phi_4046_: f32;
    var phi_4051_: f32;
    var phi_4065_: f32;
    var phi_4072_: f32;
    var phi_4077_: f32;
    var phi_4084_: f32;
    var phi_4089_: f32;
    var phi_4094_: f32;
    var phi_4111_: f32;
    var phi_4118_: f32;
    var phi_4123_: f32;
    var phi_4130_: f32;
    var phi_4135_: f32;
    var phi_4149_: f32;
    var phi_4156_: f32;
    var phi_4161_: f32;
    var phi_4168_: f32;
    var phi_4173_: f32;
    var phi_4178_: f32;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var phi_4200_: bool;
    var phi_4215_: bool;
    var phi_4216_: bool;
    var phi_4221_: f32;
    var phi_4223_: f32;
    var phi_4224_: f32;
    var phi_4225_: bool;
    var phi_4226_: f32;
    var phi_4227_: f32;
    var phi_4228_: bool;
    var phi_4229_: bool;
    var phi_4230_: f32;
    var phi_4231_: f32;
    var phi_4232_: f32;
    var phi_4233_: f32;
    var phi_4234_: bool;
    var phi_4235_: bool;
    var phi_4236_: bool;
    var phi_4237_: bool;
    var phi_4238_: f32;
    var phi_4239_: f32;
    var phi_4240_: f32;
    var phi_4241_: f32;
    var phi_4242_: bool;
    var phi_4243_: bool;
    var phi_4244_: bool;
    var phi_4245_: bool;
    var phi_4246_: bool;
    var phi_4247_: f32;
    var phi_4248_: f32;
    var phi_4249_: f32;
    var phi_4250_: f32;
    var phi_4251_: bool;
    var phi_4252_: bool;
    var phi_4253_: bool;
    var phi_4254_: bool;
    var phi_4255_: bool;
    var phi_4341_: f32;
    var phi_4414_: f32;
    var phi_4419_: f32;
    var phi_4492_: f32;
    var phi_4565_: f32;
    var phi_4570_: f32;
    var phi_4586_: f32;
    var phi_4587_: f32;
    var phi_4588_: f32;
    var phi_4268_: bool;
    var phi_4590_: u32;
    var phi_4591_: f32;
    var phi_4592_: bool;
    var phi_4593_: bool;
    var phi_4594_: bool;
    var phi_4595_: u32;
    var phi_4596_: f32;
    var phi_4597_: f32;
    var phi_4598_: f32;
    var phi_4599_: f32;
    var phi_4600_: bool;
    var phi_4601_: u32;
    var phi_4602_: bool;
    var phi_4603_: bool;
    var phi_4604_: bool;
    var phi_4605_: bool;
    var phi_4606_: bool;
    var phi_4607_: bool;
    var phi_4616_: f32;
    var phi_4621_: f32;
    var phi_4630_: bool;
    var phi_4634_: bool;
    var phi_4635_: f32;
    var phi_4636_: f32;
    var phi_4637_: f32;
    var phi_4638_: f32;
    var phi_4639_: bool;
    var phi_4640_: u32;
    var phi_4641_: bool;
    var phi_4642_: bool;
    var phi_4643_: bool;
    var phi_4644_: bool;
    var phi_4645_: bool;
    var phi_4646_: bool;
    var phi_2468_: f32;
    var phi_2470_: f32;
    var phi_2472_: f32;
    var phi_2474_: f32;
    var phi_2476_: bool;
    var phi_2478_: u32;
    var phi_4647_: f32;
    var phi_4648_: f32;
    var phi_4649_: bool;
    var phi_4650_: bool;
    var phi_4651_: bool;
    var phi_4652_: bool;
    var phi_4653_: bool;
    var phi_4654_: bool;
    var phi_4655_: bool;
    var local_42: bool;
    var phi_4659_: bool;
    var phi_4660_: bool;
    var phi_4661_: bool;
    var phi_4662_: bool;
    var phi_4663_: bool;
    var local_43: f32;
    var phi_4668_: type_30;
    var phi_4669_: bool;
    var phi_4670_: bool;
    var phi_4671_: bool;
    var phi_4672_: bool;
    var phi_4673_: bool;
    var phi_4678_: type_30;
    var phi_4679_: bool;
    var phi_4680_: bool;
    var phi_4681_: bool;
    var phi_4682_: bool;
    var phi_4683_: bool;
    var phi_4687_: f32;
    var phi_4688_: bool;
    var phi_4689_: bool;
    var phi_4690_: bool;
    var phi_4691_: bool;
    var phi_4695_: f32;
    var phi_4696_: bool;
    var phi_4697_: bool;
    var phi_4698_: bool;
    var phi_4703_: type_30;
    var phi_4704_: bool;
    var phi_4705_: bool;
    var phi_4710_: type_30;
    var phi_4711_: bool;
    var phi_4715_: type_30;
    var phi_4722_: f32;
    var phi_4723_: bool;
    var phi_4835_: f32;
    var phi_4842_: f32;
    var phi_4850_: f32;
    var phi_5001_: f32;
    var phi_5008_: f32;
    var phi_5013_: f32;
    var phi_5020_: f32;
    var phi_5025_: f32;
    var phi_5038_: f32;
    var phi_5045_: f32;
    var phi_5050_: f32;
    var phi_5057_: f32;
    var phi_5062_: f32;
    var phi_5067_: f32;
    var phi_5084_: f32;
    var phi_5091_: f32;
    var phi_5096_: f32;
    var phi_5103_: f32;
    var phi_5108_: f32;
    var phi_5122_: f32;
    var phi_5129_: f32;
    var phi_5134_: f32;
    var phi_5141_: f32;
    var phi_5146_: f32;
    var phi_5151_: f32;
    var phi_5168_: f32;
    var phi_5175_: f32;
    var phi_5180_: f32;
    var phi_5187_: f32;
    var phi_5192_: f32;
    var phi_5206_: f32;
    var phi_5213_: f32;
    var phi_5218_: f32;
    var phi_5225_: f32;
    var phi_5230_: f32;
    var phi_5235_: f32;
    var phi_5343_: type_14;
    var phi_5346_: f32;
    var phi_5367_: bool;
    var phi_5373_: type_15;
    var phi_5344_: type_14;
    var phi_5387_: type_15;
    var phi_5347_: f32;
    var local_44: f32;
    var phi_5336_: f32;
    var phi_5400_: f32;
    var phi_5534_: f32;
    var phi_5540_: f32;
    var phi_5549_: f32;
    var phi_5555_: f32;
    var phi_5564_: f32;
    var phi_5570_: f32;
    var phi_5579_: f32;
    var phi_5585_: f32;
    var phi_5635_: type_14;
    var phi_5638_: f32;
    var phi_5659_: bool;
    var phi_5665_: type_15;
    var phi_5636_: type_14;
    var phi_5679_: type_15;
    var phi_5639_: f32;
    var local_45: f32;
    var phi_5628_: f32;
    var phi_5692_: f32;
    var phi_5724_: type_14;
    var phi_5727_: f32;
    var phi_5748_: bool;
    var phi_5754_: type_15;
    var phi_5725_: type_14;
    var phi_5768_: type_15;
    var phi_5728_: f32;
    var local_46: f32;
    var phi_5717_: f32;
    var phi_5781_: f32;
    var phi_5797_: f32;
    var phi_5804_: f32;
    var phi_5809_: f32;
    var phi_5816_: f32;
    var phi_5821_: f32;
    var phi_5834_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5853_: f32;
    var phi_5858_: f32;
    var phi_5863_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5899_: f32;
    var phi_5904_: f32;
    var phi_5918_: f32;
    var phi_5925_: f32;
    var phi_5930_: f32;
    var phi_5937_: f32;
    var phi_5942_: f32;
    var phi_5947_: f32;
    var phi_5964_: f32;
    var phi_5971_: f32;
    var phi_5976_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_6002_: f32;
    var phi_6009_: f32;
    var phi_6014_: f32;
    var phi_6021_: f32;
    var phi_6026_: f32;
    var phi_6031_: f32;
    var phi_6072_: f32;
    var phi_6078_: f32;
    var phi_6089_: type_12;
    var phi_6092_: f32;
    var phi_6090_: type_12;
    var phi_6115_: type_12;
    var phi_6144_: f32;
    var phi_6150_: f32;
    var phi_6163_: f32;
    var phi_6093_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6191_: type_14;
    var phi_6194_: f32;
    var phi_6215_: bool;
    var phi_6221_: type_15;
    var phi_6192_: type_14;
    var phi_6235_: type_15;
    var phi_6195_: f32;
    var local_49: f32;
    var phi_6184_: f32;
    var phi_6248_: f32;
    var phi_6253_: type_12;
    var phi_6256_: f32;
    var phi_6258_: bool;
    var phi_6260_: bool;
    var phi_6254_: type_12;
    var phi_6283_: type_12;
    var phi_6320_: f32;
    var phi_6327_: f32;
    var phi_6335_: f32;
    var phi_6343_: f32;
    var phi_6350_: f32;
    var phi_6358_: f32;
    var phi_6364_: f32;
    var phi_6382_: f32;
    var phi_6388_: f32;
    var phi_6395_: f32;
    var phi_6421_: f32;
    var phi_6427_: f32;
    var phi_6463_: bool;
    var phi_6470_: bool;
    var phi_6483_: f32;
    var phi_6489_: f32;
    var phi_6490_: f32;
    var phi_6491_: f32;
    var phi_6257_: f32;
    var phi_6259_: bool;
    var phi_6261_: bool;
    var local_50: f32;
    var phi_6496_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_6505_: type_40;
    var phi_6506_: type_40;
    var phi_6507_: bool;
    var local_53: bool;
    var phi_6524_: f32;
    var phi_6525_: f32;
    var phi_6528_: type_12;
    var phi_6531_: f32;
    var phi_6533_: f32;
    var phi_6529_: type_12;
    var phi_6556_: type_12;
    var phi_6639_: f32;
    var phi_6640_: f32;
    var phi_6641_: f32;
    var phi_6624_: f32;
    var phi_6642_: f32;
    var phi_6643_: f32;
    var phi_6532_: f32;
    var phi_6534_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_6804_: bool;
    var phi_6805_: bool;
    var phi_6806_: bool;
    var phi_6807_: bool;
    var phi_6808_: bool;
    var phi_6809_: bool;
    var phi_6813_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: bool;
    var phi_6823_: f32;
    var phi_6826_: type_40;
    var phi_6827_: type_40;
    var phi_6828_: bool;
    var phi_6829_: type_40;
    var phi_6830_: type_40;
    var phi_6831_: bool;
    var phi_6836_: type_40;
    var phi_6837_: type_40;
    var phi_6838_: bool;
    var phi_6842_: type_40;
    var phi_6843_: type_40;
    var phi_6844_: bool;
    var phi_6845_: bool;
    var phi_6846_: type_40;
    var phi_6847_: type_40;
    var phi_6848_: bool;
    var phi_6849_: bool;
    var phi_6854_: type_40;
    var phi_6855_: bool;
    var phi_6859_: type_40;
    var phi_6875_: f32;
    var phi_6876_: f32;
    var phi_6877_: bool;
    var phi_6878_: f32;
    var phi_6879_: f32;
    var phi_6880_: bool;
    var phi_6881_: bool;
    var phi_6882_: bool;
    var phi_6883_: f32;
    var phi_6884_: f32;
    var phi_6885_: bool;
    var phi_6886_: bool;
    var phi_6887_: bool;
    var phi_6888_: f32;
    var phi_6889_: u32;
    var phi_6890_: f32;
    var phi_6891_: type_40;
    var phi_6892_: u32;
    var phi_6893_: u32;
    var phi_6894_: bool;
    var phi_6895_: bool;
    var phi_6896_: bool;
    var phi_6897_: f32;
    var phi_6898_: u32;
    var phi_6899_: f32;
    var phi_6900_: type_40;
    var phi_6901_: u32;
    var phi_6902_: u32;
    var phi_6903_: bool;
    var phi_6904_: bool;
    var phi_6905_: bool;
    var phi_6906_: bool;
    var phi_6907_: bool;
    var phi_6908_: f32;
    var phi_1983_: f32;
    var phi_1985_: u32;
    var phi_1987_: f32;
    var phi_6909_: type_40;
    var phi_6910_: u32;
    var phi_6911_: f32;
    var phi_6912_: u32;
    var phi_6913_: bool;
    var phi_6914_: bool;
    var phi_6915_: bool;
    var phi_6916_: bool;
    var phi_6917_: bool;
    var phi_6918_: bool;
    var local_57: bool;
    var phi_6922_: bool;
    var phi_6923_: bool;
    var phi_6924_: bool;
    var phi_6925_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_6942_: u32;
    var local_60: type_40;
    var phi_6947_: type_39;
    var phi_6948_: type_39;
    var phi_6949_: bool;
    var phi_6950_: bool;
    var phi_6951_: bool;
    var phi_6952_: bool;
    var phi_6956_: u32;
    var phi_6957_: f32;
    var phi_6958_: bool;
    var phi_6959_: bool;
    var phi_6960_: bool;
    var phi_6961_: bool;
    var phi_6965_: f32;
    var phi_6966_: u32;
    var phi_6967_: bool;
    var phi_6968_: bool;
    var phi_6969_: bool;
    var phi_6981_: f32;
    var phi_6984_: type_12;
    var phi_6985_: type_12;
    var phi_7008_: type_12;
    var phi_7029_: f32;
    var phi_7159_: type_14;
    var phi_7162_: f32;
    var phi_7183_: bool;
    var phi_7189_: type_15;
    var phi_7160_: type_14;
    var phi_7203_: type_15;
    var phi_7163_: f32;
    var local_61: f32;
    var phi_7152_: f32;
    var phi_7216_: f32;
    var phi_7232_: f32;
    var phi_7239_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7256_: f32;
    var phi_7269_: f32;
    var phi_7276_: f32;
    var phi_7281_: f32;
    var phi_7288_: f32;
    var phi_7293_: f32;
    var phi_7298_: f32;
    var phi_7315_: f32;
    var phi_7322_: f32;
    var phi_7327_: f32;
    var phi_7334_: f32;
    var phi_7339_: f32;
    var phi_7353_: f32;
    var phi_7360_: f32;
    var phi_7365_: f32;
    var phi_7372_: f32;
    var phi_7377_: f32;
    var phi_7382_: f32;
    var phi_7399_: f32;
    var phi_7406_: f32;
    var phi_7411_: f32;
    var phi_7418_: f32;
    var phi_7423_: f32;
    var phi_7437_: f32;
    var phi_7444_: f32;
    var phi_7449_: f32;
    var phi_7456_: f32;
    var phi_7461_: f32;
    var phi_7466_: f32;
    var phi_7486_: bool;
    var phi_7487_: bool;
    var phi_7488_: bool;
    var local_62: bool;
    var phi_7496_: u32;
    var phi_7500_: type_39;
    var phi_7501_: bool;
    var phi_7509_: u32;
    var phi_7513_: type_39;
    var phi_7514_: type_39;
    var phi_7515_: bool;
    var phi_7516_: bool;
    var phi_7523_: type_39;
    var phi_7524_: bool;
    var phi_7528_: type_39;
    var phi_7529_: type_39;
    var phi_7530_: bool;
    var phi_7534_: type_39;
    var phi_15049_: type_39;
    var phi_15064_: type_42;
    var phi_15080_: array<u32, 2>;
    var phi_15101_: array<u32, 2>;
    var phi_15104_: bool;
    var phi_15119_: bool;
    var phi_15120_: bool;
    var phi_15128_: bool;
    var phi_15129_: bool;
    var phi_15134_: u32;
    var phi_15142_: bool;
    var phi_15163_: u32;
    var phi_15167_: type_20;
    var phi_15168_: bool;
    var phi_15169_: bool;
    var phi_15188_: u32;
    var phi_15255_: u32;
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
        phi_250_ = _e140;
    } else {
        phi_250_ = _e142;
    }
    let _e145 = phi_250_;
    let _e147 = params.member.member_1.member_1;
    if (_e145 > _e147) {
        let _e150 = params.member.member_1.member_1;
        phi_260_ = (_e145 - _e150);
    } else {
        phi_260_ = 0u;
    }
    let _e153 = phi_260_;
    let _e155 = params.member.member_1.member;
    if (_e155 < _e153) {
        phi_267_ = _e155;
    } else {
        phi_267_ = _e153;
    }
    let _e158 = phi_267_;
    let _e159 = (_e158 / 64u);
    if ((_e158 % 64u) > 0u) {
        phi_283_ = (_e159 + 1u);
    } else {
        phi_283_ = _e159;
    }
    let _e164 = phi_283_;
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
            phi_304_ = (_e168 + 1u);
        } else {
            phi_304_ = _e168;
        }
        let _e174 = phi_304_;
        phi_305_ = _e174;
    } else {
        phi_305_ = 0u;
    }
    let _e176 = phi_305_;
    phi_308_ = type_12(0u, _e176);
    loop {
        let _e179 = phi_308_;
        if (_e179.member < _e179.member_1) {
            phi_309_ = type_12((_e179.member + 1u), _e179.member_1);
            phi_332_ = type_12(1u, _e179.member);
        } else {
            phi_309_ = _e179;
            phi_332_ = type_12(0u, type_12().member_1);
        }
        let _e191 = phi_309_;
        let _e193 = phi_332_;
        let _e197 = (bitcast<i32>(_e193.member) != 0i);
        if _e197 {
            let _e201 = (((_e134 + (_e193.member_1 * _e137)) * 64u) + _e122);
            if (_e201 < _e158) {
                let _e205 = params.member.member_1.member_1;
                let _e207 = (2u * (_e205 + _e201));
                let _e210 = input.member[(4u + _e207)];
                let _e213 = input.member[(_e207 + 5u)];
                let _e216 = elements.member[_e210];
                let _e218 = elements.member[_e213];
                let _e224 = paths.member[_e216[0]];
                let _e226 = paths.member[_e216[1]];
                let _e232 = paths.member[_e218[0]];
                let _e234 = paths.member[_e218[1]];
                let _e264 = params.member.member.member_4;
                let _e265 = (_e232.member[0] - _e224.member[0]);
                let _e266 = (_e232.member[1] - _e224.member[1]);
                let _e267 = (_e232.member[2] - _e224.member[2]);
                let _e269 = (_e232.member_1[0] - _e224.member_1[0]);
                let _e270 = (_e232.member_1[1] - _e224.member_1[1]);
                let _e271 = (_e232.member_1[2] - _e224.member_1[2]);
                let _e274 = (_e226.member[0] - _e224.member[0]);
                let _e275 = (_e226.member[1] - _e224.member[1]);
                let _e276 = (_e226.member[2] - _e224.member[2]);
                let _e278 = (_e226.member_1[0] - _e224.member_1[0]);
                let _e279 = (_e226.member_1[1] - _e224.member_1[1]);
                let _e280 = (_e226.member_1[2] - _e224.member_1[2]);
                let _e283 = (_e232.member[0] - _e234.member[0]);
                let _e284 = (_e232.member[1] - _e234.member[1]);
                let _e285 = (_e232.member[2] - _e234.member[2]);
                let _e287 = (_e232.member_1[0] - _e234.member_1[0]);
                let _e288 = (_e232.member_1[1] - _e234.member_1[1]);
                let _e289 = (_e232.member_1[2] - _e234.member_1[2]);
                let _e292 = (_e264 + _e264);
                let _e295 = params.member.member.member_12;
                let _e296 = bitcast<u32>(_e295);
                let _e297 = (_e296 & 2147483647u);
                if (_e297 < 8388608u) {
                    phi_518_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_518_ = array<u32, 2>((_e296 << bitcast<u32>(29i)), ((_e296 ^ _e297) | ((_e297 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e308 = phi_518_;
                let _e312 = params.member.member.member_15[0u];
                if (_e308[0] == _e312) {
                    let _e317 = params.member.member.member_15[1u];
                    phi_532_ = (_e308[1] == _e317);
                } else {
                    phi_532_ = false;
                }
                let _e320 = phi_532_;
                let _e322 = params.member.member.member_5;
                let _e324 = params.member.member.member_11;
                let _e326 = params.member.member.member_12;
                let _e328 = params.member.member.member_13;
                let _e330 = params.member.member.member_1;
                if ((_e330 & 64u) != 0u) {
                    phi_548_ = _e320;
                } else {
                    phi_548_ = false;
                }
                let _e334 = phi_548_;
                if (_e265 < 0f) {
                    phi_554_ = -(_e265);
                } else {
                    phi_554_ = _e265;
                }
                let _e338 = phi_554_;
                if (_e266 < 0f) {
                    phi_560_ = -(_e266);
                } else {
                    phi_560_ = _e266;
                }
                let _e342 = phi_560_;
                if (_e338 > _e342) {
                    phi_565_ = _e338;
                } else {
                    phi_565_ = _e342;
                }
                let _e345 = phi_565_;
                if (_e267 < 0f) {
                    phi_571_ = -(_e267);
                } else {
                    phi_571_ = _e267;
                }
                let _e349 = phi_571_;
                if (_e345 > _e349) {
                    phi_576_ = _e345;
                } else {
                    phi_576_ = _e349;
                }
                let _e352 = phi_576_;
                if (_e269 < 0f) {
                    phi_582_ = -(_e269);
                } else {
                    phi_582_ = _e269;
                }
                let _e356 = phi_582_;
                if (_e270 < 0f) {
                    phi_588_ = -(_e270);
                } else {
                    phi_588_ = _e270;
                }
                let _e360 = phi_588_;
                if (_e356 > _e360) {
                    phi_593_ = _e356;
                } else {
                    phi_593_ = _e360;
                }
                let _e363 = phi_593_;
                if (_e271 < 0f) {
                    phi_599_ = -(_e271);
                } else {
                    phi_599_ = _e271;
                }
                let _e367 = phi_599_;
                if (_e363 > _e367) {
                    phi_604_ = _e363;
                } else {
                    phi_604_ = _e367;
                }
                let _e370 = phi_604_;
                if (_e352 > _e370) {
                    phi_609_ = _e352;
                } else {
                    phi_609_ = _e370;
                }
                let _e373 = phi_609_;
                let _e374 = (_e373 + _e292);
                if (_e274 < 0f) {
                    phi_616_ = -(_e274);
                } else {
                    phi_616_ = _e274;
                }
                let _e378 = phi_616_;
                if (_e275 < 0f) {
                    phi_622_ = -(_e275);
                } else {
                    phi_622_ = _e275;
                }
                let _e382 = phi_622_;
                if (_e378 > _e382) {
                    phi_627_ = _e378;
                } else {
                    phi_627_ = _e382;
                }
                let _e385 = phi_627_;
                if (_e276 < 0f) {
                    phi_633_ = -(_e276);
                } else {
                    phi_633_ = _e276;
                }
                let _e389 = phi_633_;
                if (_e385 > _e389) {
                    phi_638_ = _e385;
                } else {
                    phi_638_ = _e389;
                }
                let _e392 = phi_638_;
                if (_e278 < 0f) {
                    phi_644_ = -(_e278);
                } else {
                    phi_644_ = _e278;
                }
                let _e396 = phi_644_;
                if (_e279 < 0f) {
                    phi_650_ = -(_e279);
                } else {
                    phi_650_ = _e279;
                }
                let _e400 = phi_650_;
                if (_e396 > _e400) {
                    phi_655_ = _e396;
                } else {
                    phi_655_ = _e400;
                }
                let _e403 = phi_655_;
                if (_e280 < 0f) {
                    phi_661_ = -(_e280);
                } else {
                    phi_661_ = _e280;
                }
                let _e407 = phi_661_;
                if (_e403 > _e407) {
                    phi_666_ = _e403;
                } else {
                    phi_666_ = _e407;
                }
                let _e410 = phi_666_;
                if (_e392 > _e410) {
                    phi_671_ = _e392;
                } else {
                    phi_671_ = _e410;
                }
                let _e413 = phi_671_;
                let _e414 = (_e413 + _e292);
                if (_e283 < 0f) {
                    phi_678_ = -(_e283);
                } else {
                    phi_678_ = _e283;
                }
                let _e418 = phi_678_;
                if (_e284 < 0f) {
                    phi_684_ = -(_e284);
                } else {
                    phi_684_ = _e284;
                }
                let _e422 = phi_684_;
                if (_e418 > _e422) {
                    phi_689_ = _e418;
                } else {
                    phi_689_ = _e422;
                }
                let _e425 = phi_689_;
                if (_e285 < 0f) {
                    phi_695_ = -(_e285);
                } else {
                    phi_695_ = _e285;
                }
                let _e429 = phi_695_;
                if (_e425 > _e429) {
                    phi_700_ = _e425;
                } else {
                    phi_700_ = _e429;
                }
                let _e432 = phi_700_;
                if (_e287 < 0f) {
                    phi_706_ = -(_e287);
                } else {
                    phi_706_ = _e287;
                }
                let _e436 = phi_706_;
                if (_e288 < 0f) {
                    phi_712_ = -(_e288);
                } else {
                    phi_712_ = _e288;
                }
                let _e440 = phi_712_;
                if (_e436 > _e440) {
                    phi_717_ = _e436;
                } else {
                    phi_717_ = _e440;
                }
                let _e443 = phi_717_;
                if (_e289 < 0f) {
                    phi_723_ = -(_e289);
                } else {
                    phi_723_ = _e289;
                }
                let _e447 = phi_723_;
                if (_e443 > _e447) {
                    phi_728_ = _e443;
                } else {
                    phi_728_ = _e447;
                }
                let _e450 = phi_728_;
                if (_e432 > _e450) {
                    phi_733_ = _e432;
                } else {
                    phi_733_ = _e450;
                }
                let _e453 = phi_733_;
                let _e454 = (_e453 + _e292);
                if (_e374 > _e414) {
                    phi_739_ = _e374;
                } else {
                    phi_739_ = _e414;
                }
                let _e457 = phi_739_;
                if (_e457 > _e454) {
                    phi_744_ = _e457;
                } else {
                    phi_744_ = _e454;
                }
                let _e460 = phi_744_;
                if (_e460 <= 65536f) {
                    phi_751_ = (_e460 >= (1f / 65536f));
                } else {
                    phi_751_ = false;
                }
                let _e465 = phi_751_;
                if _e465 {
                    phi_824_ = type_38();
                    phi_825_ = true;
                } else {
                    if (_e460 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e460) & 2139095040u) != 2139095040u) {
                            let _e472 = (2130706432u - (bitcast<u32>(_e460) & 2139095040u));
                            if (_e472 > 8388608u) {
                                phi_775_ = _e472;
                            } else {
                                phi_775_ = 8388608u;
                            }
                            let _e475 = phi_775_;
                            let _e476 = bitcast<f32>(_e475);
                            let _e477 = (_e322 * _e476);
                            if (_e322 > 0f) {
                                if (_e477 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_786_ = _e477;
                                } else {
                                    phi_786_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e481 = phi_786_;
                                phi_787_ = _e481;
                            } else {
                                phi_787_ = _e477;
                            }
                            let _e483 = phi_787_;
                            phi_820_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e265 * _e476), (_e266 * _e476), (_e267 * _e476)), array<f32, 3>((_e269 * _e476), (_e270 * _e476), (_e271 * _e476))), array<array<f32, 3>, 2>(array<f32, 3>((_e274 * _e476), (_e275 * _e476), (_e276 * _e476)), array<f32, 3>((_e278 * _e476), (_e279 * _e476), (_e280 * _e476))), array<array<f32, 3>, 2>(array<f32, 3>((_e283 * _e476), (_e284 * _e476), (_e285 * _e476)), array<f32, 3>((_e287 * _e476), (_e288 * _e476), (_e289 * _e476))), ((_e292 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e476)), _e483);
                            phi_821_ = false;
                        } else {
                            phi_820_ = type_38();
                            phi_821_ = true;
                        }
                        let _e517 = phi_820_;
                        let _e519 = phi_821_;
                        phi_822_ = _e517;
                        phi_823_ = _e519;
                    } else {
                        phi_822_ = type_38();
                        phi_823_ = true;
                    }
                    let _e521 = phi_822_;
                    let _e523 = phi_823_;
                    phi_824_ = _e521;
                    phi_825_ = _e523;
                }
                let _e525 = phi_824_;
                let _e527 = phi_825_;
                if _e527 {
                    phi_830_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e265, _e266, _e267), array<f32, 3>(_e269, _e270, _e271)), array<array<f32, 3>, 2>(array<f32, 3>(_e274, _e275, _e276), array<f32, 3>(_e278, _e279, _e280)), array<array<f32, 3>, 2>(array<f32, 3>(_e283, _e284, _e285), array<f32, 3>(_e287, _e288, _e289)), _e292), _e322);
                } else {
                    phi_830_ = _e525;
                }
                let _e530 = phi_830_;
                local_18 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e530.member.member[0][0], _e530.member.member[0][1], _e530.member.member[0][2]), array<f32, 3>(_e530.member.member[1][0], _e530.member.member[1][1], _e530.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e530.member.member_1[0][0], _e530.member.member_1[0][1], _e530.member.member_1[0][2]), array<f32, 3>(_e530.member.member_1[1][0], _e530.member.member_1[1][1], _e530.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e530.member.member_2[0][0], _e530.member.member_2[0][1], _e530.member.member_2[0][2]), array<f32, 3>(_e530.member.member_2[1][0], _e530.member.member_2[1][1], _e530.member.member_2[1][2])), _e530.member.member_3);
                if (_e530.member_1 > 0f) {
                    let _e5215 = local_18.member[0u];
                    let _e5221 = local_18.member[1u];
                    let _e5237 = local_18.member_1[0u];
                    let _e5243 = local_18.member_1[1u];
                    let _e5259 = local_18.member_2[0u];
                    let _e5265 = local_18.member_2[1u];
                    let _e5279 = function_3(array<f32, 3>((_e5215[0] + ((_e5221[0] - _e5215[0]) * _e326)), (_e5215[1] + ((_e5221[1] - _e5215[1]) * _e326)), (_e5215[2] + ((_e5221[2] - _e5215[2]) * _e326))), array<f32, 3>((_e5237[0] + ((_e5243[0] - _e5237[0]) * _e326)), (_e5237[1] + ((_e5243[1] - _e5237[1]) * _e326)), (_e5237[2] + ((_e5243[2] - _e5237[2]) * _e326))), array<f32, 3>((_e5259[0] + ((_e5265[0] - _e5259[0]) * _e326)), (_e5259[1] + ((_e5265[1] - _e5259[1]) * _e326)), (_e5259[2] + ((_e5265[2] - _e5259[2]) * _e326))), 1u);
                    let _e5290 = (((_e5279[0] * _e5279[0]) + (_e5279[1] * _e5279[1])) + (_e5279[2] * _e5279[2]));
                    if (_e5290 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5290 > 0f) {
                            phi_997_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_997_ = 0f;
                        }
                        let _e5343 = phi_997_;
                        phi_1061_ = _e5343;
                    } else {
                        phi_1004_ = type_14(0i, 5i);
                        phi_1007_ = bitcast<f32>(((bitcast<u32>(_e5290) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5298 = phi_1004_;
                            let _e5300 = phi_1007_;
                            local_39 = _e5300;
                            if (_e5298.member < _e5298.member_1) {
                                let _e5307 = (_e5298.member + 1i);
                                if ((false == (_e5307 > _e5298.member)) != false) {
                                    phi_1028_ = true;
                                } else {
                                    phi_1028_ = false;
                                }
                                let _e5312 = phi_1028_;
                                if _e5312 {
                                    phi_1034_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1034_ = type_15(1u, _e5307);
                                }
                                let _e5317 = phi_1034_;
                                phi_1005_ = type_14(_e5317.member_1, _e5298.member_1);
                                phi_1048_ = type_15(1u, _e5298.member);
                            } else {
                                phi_1005_ = _e5298;
                                phi_1048_ = type_15(0u, type_15().member_1);
                            }
                            let _e5323 = phi_1005_;
                            let _e5325 = phi_1048_;
                            let _e5328 = (bitcast<i32>(_e5325.member) != 0i);
                            if _e5328 {
                                phi_1008_ = (0.5f * (_e5300 + (_e5290 / _e5300)));
                            } else {
                                phi_1008_ = f32();
                            }
                            let _e5333 = phi_1008_;
                            continue;
                            continuing {
                                phi_1004_ = _e5323;
                                phi_1007_ = _e5333;
                                break if !(_e5328);
                            }
                        }
                        let _e5338 = local_39;
                        phi_1061_ = (_e5338 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5345 = phi_1061_;
                    let _e5351 = local_18.member[0u];
                    if (_e5351[0] < 0f) {
                        phi_1077_ = -(_e5351[0]);
                    } else {
                        phi_1077_ = _e5351[0];
                    }
                    let _e5358 = phi_1077_;
                    if (_e5351[1] < 0f) {
                        phi_1084_ = -(_e5351[1]);
                    } else {
                        phi_1084_ = _e5351[1];
                    }
                    let _e5362 = phi_1084_;
                    if (_e5358 > _e5362) {
                        phi_1089_ = _e5358;
                    } else {
                        phi_1089_ = _e5362;
                    }
                    let _e5365 = phi_1089_;
                    if (_e5351[2] < 0f) {
                        phi_1096_ = -(_e5351[2]);
                    } else {
                        phi_1096_ = _e5351[2];
                    }
                    let _e5369 = phi_1096_;
                    if (_e5365 > _e5369) {
                        phi_1101_ = _e5365;
                    } else {
                        phi_1101_ = _e5369;
                    }
                    let _e5372 = phi_1101_;
                    let _e5375 = local_18.member[1u];
                    if (_e5375[0] < 0f) {
                        phi_1114_ = -(_e5375[0]);
                    } else {
                        phi_1114_ = _e5375[0];
                    }
                    let _e5382 = phi_1114_;
                    if (_e5375[1] < 0f) {
                        phi_1121_ = -(_e5375[1]);
                    } else {
                        phi_1121_ = _e5375[1];
                    }
                    let _e5386 = phi_1121_;
                    if (_e5382 > _e5386) {
                        phi_1126_ = _e5382;
                    } else {
                        phi_1126_ = _e5386;
                    }
                    let _e5389 = phi_1126_;
                    if (_e5375[2] < 0f) {
                        phi_1133_ = -(_e5375[2]);
                    } else {
                        phi_1133_ = _e5375[2];
                    }
                    let _e5393 = phi_1133_;
                    if (_e5389 > _e5393) {
                        phi_1138_ = _e5389;
                    } else {
                        phi_1138_ = _e5393;
                    }
                    let _e5396 = phi_1138_;
                    if (_e5372 > _e5396) {
                        phi_1143_ = _e5372;
                    } else {
                        phi_1143_ = _e5396;
                    }
                    let _e5399 = phi_1143_;
                    let _e5401 = local_18.member_3;
                    let _e5405 = local_18.member_1[0u];
                    if (_e5405[0] < 0f) {
                        phi_1160_ = -(_e5405[0]);
                    } else {
                        phi_1160_ = _e5405[0];
                    }
                    let _e5412 = phi_1160_;
                    if (_e5405[1] < 0f) {
                        phi_1167_ = -(_e5405[1]);
                    } else {
                        phi_1167_ = _e5405[1];
                    }
                    let _e5416 = phi_1167_;
                    if (_e5412 > _e5416) {
                        phi_1172_ = _e5412;
                    } else {
                        phi_1172_ = _e5416;
                    }
                    let _e5419 = phi_1172_;
                    if (_e5405[2] < 0f) {
                        phi_1179_ = -(_e5405[2]);
                    } else {
                        phi_1179_ = _e5405[2];
                    }
                    let _e5423 = phi_1179_;
                    if (_e5419 > _e5423) {
                        phi_1184_ = _e5419;
                    } else {
                        phi_1184_ = _e5423;
                    }
                    let _e5426 = phi_1184_;
                    let _e5429 = local_18.member_1[1u];
                    if (_e5429[0] < 0f) {
                        phi_1198_ = -(_e5429[0]);
                    } else {
                        phi_1198_ = _e5429[0];
                    }
                    let _e5436 = phi_1198_;
                    if (_e5429[1] < 0f) {
                        phi_1205_ = -(_e5429[1]);
                    } else {
                        phi_1205_ = _e5429[1];
                    }
                    let _e5440 = phi_1205_;
                    if (_e5436 > _e5440) {
                        phi_1210_ = _e5436;
                    } else {
                        phi_1210_ = _e5440;
                    }
                    let _e5443 = phi_1210_;
                    if (_e5429[2] < 0f) {
                        phi_1217_ = -(_e5429[2]);
                    } else {
                        phi_1217_ = _e5429[2];
                    }
                    let _e5447 = phi_1217_;
                    if (_e5443 > _e5447) {
                        phi_1222_ = _e5443;
                    } else {
                        phi_1222_ = _e5447;
                    }
                    let _e5450 = phi_1222_;
                    if (_e5426 > _e5450) {
                        phi_1227_ = _e5426;
                    } else {
                        phi_1227_ = _e5450;
                    }
                    let _e5453 = phi_1227_;
                    let _e5455 = local_18.member_3;
                    let _e5459 = local_18.member_2[0u];
                    if (_e5459[0] < 0f) {
                        phi_1244_ = -(_e5459[0]);
                    } else {
                        phi_1244_ = _e5459[0];
                    }
                    let _e5466 = phi_1244_;
                    if (_e5459[1] < 0f) {
                        phi_1251_ = -(_e5459[1]);
                    } else {
                        phi_1251_ = _e5459[1];
                    }
                    let _e5470 = phi_1251_;
                    if (_e5466 > _e5470) {
                        phi_1256_ = _e5466;
                    } else {
                        phi_1256_ = _e5470;
                    }
                    let _e5473 = phi_1256_;
                    if (_e5459[2] < 0f) {
                        phi_1263_ = -(_e5459[2]);
                    } else {
                        phi_1263_ = _e5459[2];
                    }
                    let _e5477 = phi_1263_;
                    if (_e5473 > _e5477) {
                        phi_1268_ = _e5473;
                    } else {
                        phi_1268_ = _e5477;
                    }
                    let _e5480 = phi_1268_;
                    let _e5483 = local_18.member_2[1u];
                    if (_e5483[0] < 0f) {
                        phi_1282_ = -(_e5483[0]);
                    } else {
                        phi_1282_ = _e5483[0];
                    }
                    let _e5490 = phi_1282_;
                    if (_e5483[1] < 0f) {
                        phi_1289_ = -(_e5483[1]);
                    } else {
                        phi_1289_ = _e5483[1];
                    }
                    let _e5494 = phi_1289_;
                    if (_e5490 > _e5494) {
                        phi_1294_ = _e5490;
                    } else {
                        phi_1294_ = _e5494;
                    }
                    let _e5497 = phi_1294_;
                    if (_e5483[2] < 0f) {
                        phi_1301_ = -(_e5483[2]);
                    } else {
                        phi_1301_ = _e5483[2];
                    }
                    let _e5501 = phi_1301_;
                    if (_e5497 > _e5501) {
                        phi_1306_ = _e5497;
                    } else {
                        phi_1306_ = _e5501;
                    }
                    let _e5504 = phi_1306_;
                    if (_e5480 > _e5504) {
                        phi_1311_ = _e5480;
                    } else {
                        phi_1311_ = _e5504;
                    }
                    let _e5507 = phi_1311_;
                    let _e5509 = local_18.member_3;
                    let _e5516 = local_18.member_3;
                    let _e5523 = (((_e5345 * (1f + (0.000000059604645f * 8f))) + (((((((_e5399 + _e5401) + (_e5453 + _e5455)) + (_e5507 + _e5509)) * (0.000000059604645f * 16f)) + (_e5516 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e530.member_1);
                    if _e5523 {
                        phi_1972_ = type_39();
                        phi_1973_ = true;
                    } else {
                        let _e5526 = local_18.member_1[0u];
                        let _e5532 = local_18.member_2[0u];
                        let _e5538 = ((_e5526[1] * _e5532[2]) - (_e5526[2] * _e5532[1]));
                        let _e5541 = ((_e5526[2] * _e5532[0]) - (_e5526[0] * _e5532[2]));
                        let _e5544 = ((_e5526[0] * _e5532[1]) - (_e5526[1] * _e5532[0]));
                        let _e5547 = local_18.member_1[1u];
                        let _e5553 = local_18.member_2[1u];
                        let _e5559 = ((_e5547[1] * _e5553[2]) - (_e5547[2] * _e5553[1]));
                        let _e5562 = ((_e5547[2] * _e5553[0]) - (_e5547[0] * _e5553[2]));
                        let _e5565 = ((_e5547[0] * _e5553[1]) - (_e5547[1] * _e5553[0]));
                        let _e5568 = local_18.member_1[0u];
                        let _e5574 = local_18.member_2[1u];
                        let _e5589 = local_18.member_1[1u];
                        let _e5595 = local_18.member_2[0u];
                        let _e5608 = (((_e5568[1] * _e5574[2]) - (_e5568[2] * _e5574[1])) + ((_e5589[1] * _e5595[2]) - (_e5589[2] * _e5595[1])));
                        let _e5609 = (((_e5568[2] * _e5574[0]) - (_e5568[0] * _e5574[2])) + ((_e5589[2] * _e5595[0]) - (_e5589[0] * _e5595[2])));
                        let _e5610 = (((_e5568[0] * _e5574[1]) - (_e5568[1] * _e5574[0])) + ((_e5589[0] * _e5595[1]) - (_e5589[1] * _e5595[0])));
                        let _e5613 = local_18.member[0u];
                        let _e5624 = local_18.member[1u];
                        let _e5635 = local_18.member[0u];
                        let _e5644 = ((((_e5624[0] * _e5538) + (_e5624[1] * _e5541)) + (_e5624[2] * _e5544)) + (((_e5635[0] * _e5608) + (_e5635[1] * _e5609)) + (_e5635[2] * _e5610)));
                        let _e5647 = local_18.member[0u];
                        let _e5658 = local_18.member[1u];
                        let _e5667 = ((((_e5647[0] * _e5559) + (_e5647[1] * _e5562)) + (_e5647[2] * _e5565)) + (((_e5658[0] * _e5608) + (_e5658[1] * _e5609)) + (_e5658[2] * _e5610)));
                        let _e5670 = local_18.member[1u];
                        let _e5681 = local_18.member[0u];
                        if (_e5681[0] < 0f) {
                            phi_1572_ = -(_e5681[0]);
                        } else {
                            phi_1572_ = _e5681[0];
                        }
                        let _e5688 = phi_1572_;
                        if (_e5681[1] < 0f) {
                            phi_1579_ = -(_e5681[1]);
                        } else {
                            phi_1579_ = _e5681[1];
                        }
                        let _e5692 = phi_1579_;
                        if (_e5688 > _e5692) {
                            phi_1584_ = _e5688;
                        } else {
                            phi_1584_ = _e5692;
                        }
                        let _e5695 = phi_1584_;
                        if (_e5681[2] < 0f) {
                            phi_1591_ = -(_e5681[2]);
                        } else {
                            phi_1591_ = _e5681[2];
                        }
                        let _e5699 = phi_1591_;
                        if (_e5695 > _e5699) {
                            phi_1596_ = _e5695;
                        } else {
                            phi_1596_ = _e5699;
                        }
                        let _e5702 = phi_1596_;
                        let _e5705 = local_18.member[1u];
                        if (_e5705[0] < 0f) {
                            phi_1609_ = -(_e5705[0]);
                        } else {
                            phi_1609_ = _e5705[0];
                        }
                        let _e5712 = phi_1609_;
                        if (_e5705[1] < 0f) {
                            phi_1616_ = -(_e5705[1]);
                        } else {
                            phi_1616_ = _e5705[1];
                        }
                        let _e5716 = phi_1616_;
                        if (_e5712 > _e5716) {
                            phi_1621_ = _e5712;
                        } else {
                            phi_1621_ = _e5716;
                        }
                        let _e5719 = phi_1621_;
                        if (_e5705[2] < 0f) {
                            phi_1628_ = -(_e5705[2]);
                        } else {
                            phi_1628_ = _e5705[2];
                        }
                        let _e5723 = phi_1628_;
                        if (_e5719 > _e5723) {
                            phi_1633_ = _e5719;
                        } else {
                            phi_1633_ = _e5723;
                        }
                        let _e5726 = phi_1633_;
                        if (_e5702 > _e5726) {
                            phi_1638_ = _e5702;
                        } else {
                            phi_1638_ = _e5726;
                        }
                        let _e5729 = phi_1638_;
                        let _e5731 = local_18.member_3;
                        let _e5732 = (_e5729 + _e5731);
                        let _e5735 = local_18.member_1[0u];
                        if (_e5735[0] < 0f) {
                            phi_1655_ = -(_e5735[0]);
                        } else {
                            phi_1655_ = _e5735[0];
                        }
                        let _e5742 = phi_1655_;
                        if (_e5735[1] < 0f) {
                            phi_1662_ = -(_e5735[1]);
                        } else {
                            phi_1662_ = _e5735[1];
                        }
                        let _e5746 = phi_1662_;
                        if (_e5742 > _e5746) {
                            phi_1667_ = _e5742;
                        } else {
                            phi_1667_ = _e5746;
                        }
                        let _e5749 = phi_1667_;
                        if (_e5735[2] < 0f) {
                            phi_1674_ = -(_e5735[2]);
                        } else {
                            phi_1674_ = _e5735[2];
                        }
                        let _e5753 = phi_1674_;
                        if (_e5749 > _e5753) {
                            phi_1679_ = _e5749;
                        } else {
                            phi_1679_ = _e5753;
                        }
                        let _e5756 = phi_1679_;
                        let _e5759 = local_18.member_1[1u];
                        if (_e5759[0] < 0f) {
                            phi_1693_ = -(_e5759[0]);
                        } else {
                            phi_1693_ = _e5759[0];
                        }
                        let _e5766 = phi_1693_;
                        if (_e5759[1] < 0f) {
                            phi_1700_ = -(_e5759[1]);
                        } else {
                            phi_1700_ = _e5759[1];
                        }
                        let _e5770 = phi_1700_;
                        if (_e5766 > _e5770) {
                            phi_1705_ = _e5766;
                        } else {
                            phi_1705_ = _e5770;
                        }
                        let _e5773 = phi_1705_;
                        if (_e5759[2] < 0f) {
                            phi_1712_ = -(_e5759[2]);
                        } else {
                            phi_1712_ = _e5759[2];
                        }
                        let _e5777 = phi_1712_;
                        if (_e5773 > _e5777) {
                            phi_1717_ = _e5773;
                        } else {
                            phi_1717_ = _e5777;
                        }
                        let _e5780 = phi_1717_;
                        if (_e5756 > _e5780) {
                            phi_1722_ = _e5756;
                        } else {
                            phi_1722_ = _e5780;
                        }
                        let _e5783 = phi_1722_;
                        let _e5785 = local_18.member_3;
                        let _e5786 = (_e5783 + _e5785);
                        let _e5789 = local_18.member_2[0u];
                        if (_e5789[0] < 0f) {
                            phi_1739_ = -(_e5789[0]);
                        } else {
                            phi_1739_ = _e5789[0];
                        }
                        let _e5796 = phi_1739_;
                        if (_e5789[1] < 0f) {
                            phi_1746_ = -(_e5789[1]);
                        } else {
                            phi_1746_ = _e5789[1];
                        }
                        let _e5800 = phi_1746_;
                        if (_e5796 > _e5800) {
                            phi_1751_ = _e5796;
                        } else {
                            phi_1751_ = _e5800;
                        }
                        let _e5803 = phi_1751_;
                        if (_e5789[2] < 0f) {
                            phi_1758_ = -(_e5789[2]);
                        } else {
                            phi_1758_ = _e5789[2];
                        }
                        let _e5807 = phi_1758_;
                        if (_e5803 > _e5807) {
                            phi_1763_ = _e5803;
                        } else {
                            phi_1763_ = _e5807;
                        }
                        let _e5810 = phi_1763_;
                        let _e5813 = local_18.member_2[1u];
                        if (_e5813[0] < 0f) {
                            phi_1777_ = -(_e5813[0]);
                        } else {
                            phi_1777_ = _e5813[0];
                        }
                        let _e5820 = phi_1777_;
                        if (_e5813[1] < 0f) {
                            phi_1784_ = -(_e5813[1]);
                        } else {
                            phi_1784_ = _e5813[1];
                        }
                        let _e5824 = phi_1784_;
                        if (_e5820 > _e5824) {
                            phi_1789_ = _e5820;
                        } else {
                            phi_1789_ = _e5824;
                        }
                        let _e5827 = phi_1789_;
                        if (_e5813[2] < 0f) {
                            phi_1796_ = -(_e5813[2]);
                        } else {
                            phi_1796_ = _e5813[2];
                        }
                        let _e5831 = phi_1796_;
                        if (_e5827 > _e5831) {
                            phi_1801_ = _e5827;
                        } else {
                            phi_1801_ = _e5831;
                        }
                        let _e5834 = phi_1801_;
                        if (_e5810 > _e5834) {
                            phi_1806_ = _e5810;
                        } else {
                            phi_1806_ = _e5834;
                        }
                        let _e5837 = phi_1806_;
                        let _e5839 = local_18.member_3;
                        let _e5840 = (_e5837 + _e5839);
                        let _e5842 = ((_e5786 * 8f) * _e5840);
                        let _e5849 = local_18.member_3;
                        if (_e5538 < 0f) {
                            phi_1837_ = -(_e5538);
                        } else {
                            phi_1837_ = _e5538;
                        }
                        let _e5866 = phi_1837_;
                        if (_e5541 < 0f) {
                            phi_1843_ = -(_e5541);
                        } else {
                            phi_1843_ = _e5541;
                        }
                        let _e5870 = phi_1843_;
                        if (_e5544 < 0f) {
                            phi_1850_ = -(_e5544);
                        } else {
                            phi_1850_ = _e5544;
                        }
                        let _e5875 = phi_1850_;
                        let _e5876 = ((_e5866 + _e5870) + _e5875);
                        if (_e5559 < 0f) {
                            phi_1857_ = -(_e5559);
                        } else {
                            phi_1857_ = _e5559;
                        }
                        let _e5880 = phi_1857_;
                        if (_e5562 < 0f) {
                            phi_1863_ = -(_e5562);
                        } else {
                            phi_1863_ = _e5562;
                        }
                        let _e5884 = phi_1863_;
                        if (_e5565 < 0f) {
                            phi_1870_ = -(_e5565);
                        } else {
                            phi_1870_ = _e5565;
                        }
                        let _e5889 = phi_1870_;
                        let _e5890 = ((_e5880 + _e5884) + _e5889);
                        if (_e5876 > _e5890) {
                            phi_1876_ = _e5876;
                        } else {
                            phi_1876_ = _e5890;
                        }
                        let _e5893 = phi_1876_;
                        if (_e5608 < 0f) {
                            phi_1882_ = -(_e5608);
                        } else {
                            phi_1882_ = _e5608;
                        }
                        let _e5897 = phi_1882_;
                        if (_e5609 < 0f) {
                            phi_1888_ = -(_e5609);
                        } else {
                            phi_1888_ = _e5609;
                        }
                        let _e5901 = phi_1888_;
                        if (_e5610 < 0f) {
                            phi_1895_ = -(_e5610);
                        } else {
                            phi_1895_ = _e5610;
                        }
                        let _e5906 = phi_1895_;
                        let _e5908 = (((_e5897 + _e5901) + _e5906) * 0.5f);
                        if (_e5893 > _e5908) {
                            phi_1902_ = _e5893;
                        } else {
                            phi_1902_ = _e5908;
                        }
                        let _e5911 = phi_1902_;
                        let _e5916 = local_18.member_3;
                        let _e5929 = ((((_e5613[0] * _e5538) + (_e5613[1] * _e5541)) + (_e5613[2] * _e5544)) * 3f);
                        let _e5930 = ((((_e5670[0] * _e5559) + (_e5670[1] * _e5562)) + (_e5670[2] * _e5565)) * 3f);
                        if (_e5929 < _e5930) {
                            phi_1926_ = _e5929;
                        } else {
                            phi_1926_ = _e5930;
                        }
                        let _e5933 = phi_1926_;
                        if (_e5644 < _e5667) {
                            phi_1931_ = _e5644;
                        } else {
                            phi_1931_ = _e5667;
                        }
                        let _e5936 = phi_1931_;
                        if (_e5933 < _e5936) {
                            phi_1936_ = _e5933;
                        } else {
                            phi_1936_ = _e5936;
                        }
                        let _e5939 = phi_1936_;
                        if (_e5929 > _e5930) {
                            phi_1941_ = _e5929;
                        } else {
                            phi_1941_ = _e5930;
                        }
                        let _e5942 = phi_1941_;
                        if (_e5644 > _e5667) {
                            phi_1946_ = _e5644;
                        } else {
                            phi_1946_ = _e5667;
                        }
                        let _e5945 = phi_1946_;
                        if (_e5942 > _e5945) {
                            phi_1951_ = _e5942;
                        } else {
                            phi_1951_ = _e5945;
                        }
                        let _e5948 = phi_1951_;
                        let _e5953 = -(_e5948);
                        if (_e5939 > _e5953) {
                            phi_1961_ = _e5939;
                        } else {
                            phi_1961_ = _e5953;
                        }
                        let _e5956 = phi_1961_;
                        if ((_e5956 - ((((((_e5732 * 8f) * _e5842) * (0.000000059604645f * (524f / 64f))) + ((_e5849 * 19f) * ((_e5732 * (_e5786 + _e5840)) + (_e5786 * _e5840)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5732) * ((1f + _e5786) * (1f + _e5840))))) + ((_e530.member_1 * (((_e5911 + (_e5842 * (0.000000059604645f * 8f))) + ((_e5916 * 6f) * (_e5786 + _e5840))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5786) * (1f + _e5840))))) * (3f * 1.0001f)))) > 0f) {
                            phi_1970_ = type_39(type_30(0u, f32()), 0u);
                            phi_1971_ = false;
                        } else {
                            phi_1970_ = type_39();
                            phi_1971_ = true;
                        }
                        let _e5962 = phi_1970_;
                        let _e5964 = phi_1971_;
                        phi_1972_ = _e5962;
                        phi_1973_ = _e5964;
                    }
                    let _e5966 = phi_1972_;
                    let _e5968 = phi_1973_;
                    if _e5968 {
                        phi_1979_ = type_14(0i, 2i);
                        phi_1982_ = _e326;
                        phi_1984_ = 0u;
                        phi_1986_ = _e326;
                        loop {
                            let _e5970 = phi_1979_;
                            let _e5972 = phi_1982_;
                            let _e5974 = phi_1984_;
                            let _e5976 = phi_1986_;
                            local_96 = _e5974;
                            local_99 = _e5972;
                            local_100 = _e5974;
                            if (_e5970.member < _e5970.member_1) {
                                let _e5983 = (_e5970.member + 1i);
                                if ((false == (_e5983 > _e5970.member)) != false) {
                                    phi_2007_ = true;
                                } else {
                                    phi_2007_ = false;
                                }
                                let _e5988 = phi_2007_;
                                if _e5988 {
                                    phi_2013_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_2013_ = type_15(1u, _e5983);
                                }
                                let _e5993 = phi_2013_;
                                phi_1980_ = type_14(_e5993.member_1, _e5970.member_1);
                                phi_2027_ = type_15(1u, _e5970.member);
                            } else {
                                phi_1980_ = _e5970;
                                phi_2027_ = type_15(0u, type_15().member_1);
                            }
                            let _e5999 = phi_1980_;
                            let _e6001 = phi_2027_;
                            if (bitcast<i32>(_e6001.member) != 0i) {
                                if (_e6001.member_1 > 0i) {
                                    phi_2043_ = true;
                                } else {
                                    if _e5523 {
                                        phi_2042_ = false;
                                    } else {
                                        phi_2042_ = true;
                                    }
                                    let _e6008 = phi_2042_;
                                    phi_2043_ = _e6008;
                                }
                                let _e6010 = phi_2043_;
                                if _e6010 {
                                    let _e6013 = local_18.member[0u];
                                    let _e6019 = local_18.member_1[0u];
                                    let _e6025 = local_18.member_2[0u];
                                    let _e6029 = (_e6013[0] - _e6019[0]);
                                    let _e6030 = (_e6013[1] - _e6019[1]);
                                    let _e6031 = (_e6013[2] - _e6019[2]);
                                    let _e6040 = local_18.member[1u];
                                    let _e6046 = local_18.member_1[1u];
                                    let _e6052 = local_18.member_2[1u];
                                    let _e6056 = (_e6040[0] - _e6046[0]);
                                    let _e6057 = (_e6040[1] - _e6046[1]);
                                    let _e6058 = (_e6040[2] - _e6046[2]);
                                    let _e6067 = local_18.member[0u];
                                    if (_e6067[0] < 0f) {
                                        phi_2189_ = -(_e6067[0]);
                                    } else {
                                        phi_2189_ = _e6067[0];
                                    }
                                    let _e6074 = phi_2189_;
                                    if (_e6067[1] < 0f) {
                                        phi_2196_ = -(_e6067[1]);
                                    } else {
                                        phi_2196_ = _e6067[1];
                                    }
                                    let _e6078 = phi_2196_;
                                    if (_e6074 > _e6078) {
                                        phi_2201_ = _e6074;
                                    } else {
                                        phi_2201_ = _e6078;
                                    }
                                    let _e6081 = phi_2201_;
                                    if (_e6067[2] < 0f) {
                                        phi_2208_ = -(_e6067[2]);
                                    } else {
                                        phi_2208_ = _e6067[2];
                                    }
                                    let _e6085 = phi_2208_;
                                    if (_e6081 > _e6085) {
                                        phi_2213_ = _e6081;
                                    } else {
                                        phi_2213_ = _e6085;
                                    }
                                    let _e6088 = phi_2213_;
                                    let _e6091 = local_18.member[1u];
                                    if (_e6091[0] < 0f) {
                                        phi_2226_ = -(_e6091[0]);
                                    } else {
                                        phi_2226_ = _e6091[0];
                                    }
                                    let _e6098 = phi_2226_;
                                    if (_e6091[1] < 0f) {
                                        phi_2233_ = -(_e6091[1]);
                                    } else {
                                        phi_2233_ = _e6091[1];
                                    }
                                    let _e6102 = phi_2233_;
                                    if (_e6098 > _e6102) {
                                        phi_2238_ = _e6098;
                                    } else {
                                        phi_2238_ = _e6102;
                                    }
                                    let _e6105 = phi_2238_;
                                    if (_e6091[2] < 0f) {
                                        phi_2245_ = -(_e6091[2]);
                                    } else {
                                        phi_2245_ = _e6091[2];
                                    }
                                    let _e6109 = phi_2245_;
                                    if (_e6105 > _e6109) {
                                        phi_2250_ = _e6105;
                                    } else {
                                        phi_2250_ = _e6109;
                                    }
                                    let _e6112 = phi_2250_;
                                    if (_e6088 > _e6112) {
                                        phi_2255_ = _e6088;
                                    } else {
                                        phi_2255_ = _e6112;
                                    }
                                    let _e6115 = phi_2255_;
                                    let _e6117 = local_18.member_3;
                                    let _e6121 = local_18.member_1[0u];
                                    if (_e6121[0] < 0f) {
                                        phi_2272_ = -(_e6121[0]);
                                    } else {
                                        phi_2272_ = _e6121[0];
                                    }
                                    let _e6128 = phi_2272_;
                                    if (_e6121[1] < 0f) {
                                        phi_2279_ = -(_e6121[1]);
                                    } else {
                                        phi_2279_ = _e6121[1];
                                    }
                                    let _e6132 = phi_2279_;
                                    if (_e6128 > _e6132) {
                                        phi_2284_ = _e6128;
                                    } else {
                                        phi_2284_ = _e6132;
                                    }
                                    let _e6135 = phi_2284_;
                                    if (_e6121[2] < 0f) {
                                        phi_2291_ = -(_e6121[2]);
                                    } else {
                                        phi_2291_ = _e6121[2];
                                    }
                                    let _e6139 = phi_2291_;
                                    if (_e6135 > _e6139) {
                                        phi_2296_ = _e6135;
                                    } else {
                                        phi_2296_ = _e6139;
                                    }
                                    let _e6142 = phi_2296_;
                                    let _e6145 = local_18.member_1[1u];
                                    if (_e6145[0] < 0f) {
                                        phi_2310_ = -(_e6145[0]);
                                    } else {
                                        phi_2310_ = _e6145[0];
                                    }
                                    let _e6152 = phi_2310_;
                                    if (_e6145[1] < 0f) {
                                        phi_2317_ = -(_e6145[1]);
                                    } else {
                                        phi_2317_ = _e6145[1];
                                    }
                                    let _e6156 = phi_2317_;
                                    if (_e6152 > _e6156) {
                                        phi_2322_ = _e6152;
                                    } else {
                                        phi_2322_ = _e6156;
                                    }
                                    let _e6159 = phi_2322_;
                                    if (_e6145[2] < 0f) {
                                        phi_2329_ = -(_e6145[2]);
                                    } else {
                                        phi_2329_ = _e6145[2];
                                    }
                                    let _e6163 = phi_2329_;
                                    if (_e6159 > _e6163) {
                                        phi_2334_ = _e6159;
                                    } else {
                                        phi_2334_ = _e6163;
                                    }
                                    let _e6166 = phi_2334_;
                                    if (_e6142 > _e6166) {
                                        phi_2339_ = _e6142;
                                    } else {
                                        phi_2339_ = _e6166;
                                    }
                                    let _e6169 = phi_2339_;
                                    let _e6171 = local_18.member_3;
                                    let _e6175 = local_18.member_2[0u];
                                    if (_e6175[0] < 0f) {
                                        phi_2356_ = -(_e6175[0]);
                                    } else {
                                        phi_2356_ = _e6175[0];
                                    }
                                    let _e6182 = phi_2356_;
                                    if (_e6175[1] < 0f) {
                                        phi_2363_ = -(_e6175[1]);
                                    } else {
                                        phi_2363_ = _e6175[1];
                                    }
                                    let _e6186 = phi_2363_;
                                    if (_e6182 > _e6186) {
                                        phi_2368_ = _e6182;
                                    } else {
                                        phi_2368_ = _e6186;
                                    }
                                    let _e6189 = phi_2368_;
                                    if (_e6175[2] < 0f) {
                                        phi_2375_ = -(_e6175[2]);
                                    } else {
                                        phi_2375_ = _e6175[2];
                                    }
                                    let _e6193 = phi_2375_;
                                    if (_e6189 > _e6193) {
                                        phi_2380_ = _e6189;
                                    } else {
                                        phi_2380_ = _e6193;
                                    }
                                    let _e6196 = phi_2380_;
                                    let _e6199 = local_18.member_2[1u];
                                    if (_e6199[0] < 0f) {
                                        phi_2394_ = -(_e6199[0]);
                                    } else {
                                        phi_2394_ = _e6199[0];
                                    }
                                    let _e6206 = phi_2394_;
                                    if (_e6199[1] < 0f) {
                                        phi_2401_ = -(_e6199[1]);
                                    } else {
                                        phi_2401_ = _e6199[1];
                                    }
                                    let _e6210 = phi_2401_;
                                    if (_e6206 > _e6210) {
                                        phi_2406_ = _e6206;
                                    } else {
                                        phi_2406_ = _e6210;
                                    }
                                    let _e6213 = phi_2406_;
                                    if (_e6199[2] < 0f) {
                                        phi_2413_ = -(_e6199[2]);
                                    } else {
                                        phi_2413_ = _e6199[2];
                                    }
                                    let _e6217 = phi_2413_;
                                    if (_e6213 > _e6217) {
                                        phi_2418_ = _e6213;
                                    } else {
                                        phi_2418_ = _e6217;
                                    }
                                    let _e6220 = phi_2418_;
                                    if (_e6196 > _e6220) {
                                        phi_2423_ = _e6196;
                                    } else {
                                        phi_2423_ = _e6220;
                                    }
                                    let _e6223 = phi_2423_;
                                    let _e6225 = local_18.member_3;
                                    let _e6232 = local_18.member_3;
                                    let _e6237 = (_e324 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2464_ = type_12(0u, 96u);
                                    phi_2467_ = _e5976;
                                    phi_2469_ = _e5976;
                                    phi_2471_ = (_e328 - _e5976);
                                    phi_2473_ = _e5976;
                                    phi_2475_ = false;
                                    phi_2477_ = 0u;
                                    loop {
                                        let _e6240 = phi_2464_;
                                        let _e6242 = phi_2467_;
                                        let _e6244 = phi_2469_;
                                        let _e6246 = phi_2471_;
                                        let _e6248 = phi_2473_;
                                        let _e6250 = phi_2475_;
                                        let _e6252 = phi_2477_;
                                        local_43 = _e6242;
                                        local_86 = _e6244;
                                        if (_e6240.member < _e6240.member_1) {
                                            phi_2465_ = type_12((_e6240.member + 1u), _e6240.member_1);
                                            phi_2500_ = type_12(1u, _e6240.member);
                                        } else {
                                            phi_2465_ = _e6240;
                                            phi_2500_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6264 = phi_2465_;
                                        let _e6266 = phi_2500_;
                                        if (bitcast<i32>(_e6266.member) != 0i) {
                                            let _e6272 = local_18.member[0u];
                                            let _e6278 = local_18.member[1u];
                                            let _e6294 = local_18.member_1[0u];
                                            let _e6300 = local_18.member_1[1u];
                                            let _e6316 = local_18.member_2[0u];
                                            let _e6322 = local_18.member_2[1u];
                                            let _e6336 = function_3(array<f32, 3>((_e6272[0] + ((_e6278[0] - _e6272[0]) * _e6242)), (_e6272[1] + ((_e6278[1] - _e6272[1]) * _e6242)), (_e6272[2] + ((_e6278[2] - _e6272[2]) * _e6242))), array<f32, 3>((_e6294[0] + ((_e6300[0] - _e6294[0]) * _e6242)), (_e6294[1] + ((_e6300[1] - _e6294[1]) * _e6242)), (_e6294[2] + ((_e6300[2] - _e6294[2]) * _e6242))), array<f32, 3>((_e6316[0] + ((_e6322[0] - _e6316[0]) * _e6242)), (_e6316[1] + ((_e6322[1] - _e6316[1]) * _e6242)), (_e6316[2] + ((_e6322[2] - _e6316[2]) * _e6242))), 1u);
                                            if (_e6252 == 0u) {
                                                phi_2628_ = _e6336;
                                            } else {
                                                if (_e6252 == 1u) {
                                                    phi_2614_ = _e6336[0];
                                                } else {
                                                    phi_2614_ = 0f;
                                                }
                                                let _e6341 = phi_2614_;
                                                if (_e6252 == 2u) {
                                                    phi_2620_ = _e6336[1];
                                                } else {
                                                    phi_2620_ = 0f;
                                                }
                                                let _e6345 = phi_2620_;
                                                if (_e6252 == 3u) {
                                                    phi_2626_ = _e6336[2];
                                                } else {
                                                    phi_2626_ = 0f;
                                                }
                                                let _e6349 = phi_2626_;
                                                phi_2628_ = array<f32, 3>(_e6341, _e6345, _e6349);
                                            }
                                            let _e6352 = phi_2628_;
                                            if (_e6352[0] < 0f) {
                                                phi_2635_ = -(_e6352[0]);
                                            } else {
                                                phi_2635_ = _e6352[0];
                                            }
                                            let _e6357 = phi_2635_;
                                            if (_e6352[1] < 0f) {
                                                phi_2642_ = -(_e6352[1]);
                                            } else {
                                                phi_2642_ = _e6352[1];
                                            }
                                            let _e6362 = phi_2642_;
                                            if (_e6352[2] < 0f) {
                                                phi_2650_ = -(_e6352[2]);
                                            } else {
                                                phi_2650_ = _e6352[2];
                                            }
                                            let _e6368 = phi_2650_;
                                            let _e6369 = ((_e6357 + _e6362) + _e6368);
                                            if (_e6369 > 0f) {
                                                if ((bitcast<u32>(_e6369) & 2139095040u) != 2139095040u) {
                                                    let _e6374 = (1f / _e6369);
                                                    let _e6376 = (_e6352[0] * _e6374);
                                                    let _e6378 = (_e6352[1] * _e6374);
                                                    let _e6380 = (_e6352[2] * _e6374);
                                                    let _e6385 = (((_e6376 * _e6376) + (_e6378 * _e6378)) + (_e6380 * _e6380));
                                                    if (_e6385 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6385 > 0f) {
                                                            phi_2687_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_2687_ = 0f;
                                                        }
                                                        let _e6438 = phi_2687_;
                                                        phi_2751_ = _e6438;
                                                    } else {
                                                        phi_2694_ = type_14(0i, 5i);
                                                        phi_2697_ = bitcast<f32>(((bitcast<u32>(_e6385) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6393 = phi_2694_;
                                                            let _e6395 = phi_2697_;
                                                            local_40 = _e6395;
                                                            if (_e6393.member < _e6393.member_1) {
                                                                let _e6402 = (_e6393.member + 1i);
                                                                if ((false == (_e6402 > _e6393.member)) != false) {
                                                                    phi_2718_ = true;
                                                                } else {
                                                                    phi_2718_ = false;
                                                                }
                                                                let _e6407 = phi_2718_;
                                                                if _e6407 {
                                                                    phi_2724_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_2724_ = type_15(1u, _e6402);
                                                                }
                                                                let _e6412 = phi_2724_;
                                                                phi_2695_ = type_14(_e6412.member_1, _e6393.member_1);
                                                                phi_2738_ = type_15(1u, _e6393.member);
                                                            } else {
                                                                phi_2695_ = _e6393;
                                                                phi_2738_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6418 = phi_2695_;
                                                            let _e6420 = phi_2738_;
                                                            let _e6423 = (bitcast<i32>(_e6420.member) != 0i);
                                                            if _e6423 {
                                                                phi_2698_ = (0.5f * (_e6395 + (_e6385 / _e6395)));
                                                            } else {
                                                                phi_2698_ = f32();
                                                            }
                                                            let _e6428 = phi_2698_;
                                                            continue;
                                                            continuing {
                                                                phi_2694_ = _e6418;
                                                                phi_2697_ = _e6428;
                                                                break if !(_e6423);
                                                            }
                                                        }
                                                        let _e6433 = local_40;
                                                        phi_2751_ = (_e6433 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6440 = phi_2751_;
                                                    let _e6441 = (0.000000059604645f * 12f);
                                                    let _e6446 = ((((((((_e6115 + _e6117) + (_e6169 + _e6171)) + (_e6223 + _e6225)) * (0.000000059604645f * 16f)) + (_e6232 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e530.member_1 * _e6440) * (1f + _e6441)));
                                                    let _e6451 = (((_e6376 * _e6013[0]) + (_e6378 * _e6013[1])) + (_e6380 * _e6013[2]));
                                                    let _e6456 = (((_e6376 * _e6029) + (_e6378 * _e6030)) + (_e6380 * _e6031));
                                                    let _e6461 = (((_e6376 * (_e6013[0] - _e6025[0])) + (_e6378 * (_e6013[1] - _e6025[1]))) + (_e6380 * (_e6013[2] - _e6025[2])));
                                                    let _e6466 = (((_e6376 * (_e6029 - _e6025[0])) + (_e6378 * (_e6030 - _e6025[1]))) + (_e6380 * (_e6031 - _e6025[2])));
                                                    let _e6472 = (((_e6376 * _e6040[0]) + (_e6378 * _e6040[1])) + (_e6380 * _e6040[2]));
                                                    let _e6477 = (((_e6376 * _e6056) + (_e6378 * _e6057)) + (_e6380 * _e6058));
                                                    let _e6482 = (((_e6376 * (_e6040[0] - _e6052[0])) + (_e6378 * (_e6040[1] - _e6052[1]))) + (_e6380 * (_e6040[2] - _e6052[2])));
                                                    let _e6487 = (((_e6376 * (_e6056 - _e6052[0])) + (_e6378 * (_e6057 - _e6052[1]))) + (_e6380 * (_e6058 - _e6052[2])));
                                                    if (_e6451 < 0f) {
                                                        phi_2817_ = -(_e6451);
                                                    } else {
                                                        phi_2817_ = _e6451;
                                                    }
                                                    let _e6492 = phi_2817_;
                                                    if (_e6472 < 0f) {
                                                        phi_2823_ = -(_e6472);
                                                    } else {
                                                        phi_2823_ = _e6472;
                                                    }
                                                    let _e6496 = phi_2823_;
                                                    if (_e6456 < 0f) {
                                                        phi_2832_ = -(_e6456);
                                                    } else {
                                                        phi_2832_ = _e6456;
                                                    }
                                                    let _e6503 = phi_2832_;
                                                    if (_e6477 < 0f) {
                                                        phi_2838_ = -(_e6477);
                                                    } else {
                                                        phi_2838_ = _e6477;
                                                    }
                                                    let _e6507 = phi_2838_;
                                                    if (_e6461 < 0f) {
                                                        phi_2847_ = -(_e6461);
                                                    } else {
                                                        phi_2847_ = _e6461;
                                                    }
                                                    let _e6514 = phi_2847_;
                                                    if (_e6482 < 0f) {
                                                        phi_2853_ = -(_e6482);
                                                    } else {
                                                        phi_2853_ = _e6482;
                                                    }
                                                    let _e6518 = phi_2853_;
                                                    if (_e6466 < 0f) {
                                                        phi_2862_ = -(_e6466);
                                                    } else {
                                                        phi_2862_ = _e6466;
                                                    }
                                                    let _e6525 = phi_2862_;
                                                    if (_e6487 < 0f) {
                                                        phi_2868_ = -(_e6487);
                                                    } else {
                                                        phi_2868_ = _e6487;
                                                    }
                                                    let _e6529 = phi_2868_;
                                                    phi_2874_ = type_32(array<f32, 4>(_e6451, _e6456, _e6461, _e6466), array<f32, 4>(_e6472, _e6477, _e6482, _e6487), array<f32, 4>((_e6446 + ((_e6492 + _e6496) * _e6441)), (_e6446 + ((_e6503 + _e6507) * _e6441)), (_e6446 + ((_e6514 + _e6518) * _e6441)), (_e6446 + ((_e6525 + _e6529) * _e6441))));
                                                    phi_2875_ = false;
                                                } else {
                                                    phi_2874_ = type_32();
                                                    phi_2875_ = true;
                                                }
                                                let _e6536 = phi_2874_;
                                                let _e6538 = phi_2875_;
                                                phi_2876_ = _e6536;
                                                phi_2877_ = _e6538;
                                            } else {
                                                phi_2876_ = type_32();
                                                phi_2877_ = true;
                                            }
                                            let _e6540 = phi_2876_;
                                            let _e6542 = phi_2877_;
                                            if _e6542 {
                                                phi_2885_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_2885_ = _e6540;
                                            }
                                            let _e6544 = phi_2885_;
                                            local_17 = type_32(array<f32, 4>(_e6544.member[0], _e6544.member[1], _e6544.member[2], _e6544.member[3]), array<f32, 4>(_e6544.member_1[0], _e6544.member_1[1], _e6544.member_1[2], _e6544.member_1[3]), array<f32, 4>(_e6544.member_2[0], _e6544.member_2[1], _e6544.member_2[2], _e6544.member_2[3]));
                                            let _e6564 = (_e6242 - _e6248);
                                            let _e6568 = local_17.member[0u];
                                            let _e6571 = local_17.member_1[0u];
                                            let _e6574 = local_17.member[0u];
                                            let _e6580 = local_17.member_2[0u];
                                            if (((_e6568 + ((_e6571 - _e6574) * _e6242)) - _e6580) > 0f) {
                                                let _e6585 = local_17.member[1u];
                                                let _e6588 = local_17.member_1[1u];
                                                let _e6591 = local_17.member[1u];
                                                let _e6597 = local_17.member_2[1u];
                                                if (((_e6585 + ((_e6588 - _e6591) * _e6242)) - _e6597) > 0f) {
                                                    let _e6602 = local_17.member[2u];
                                                    let _e6605 = local_17.member_1[2u];
                                                    let _e6608 = local_17.member[2u];
                                                    let _e6614 = local_17.member_2[2u];
                                                    if (((_e6602 + ((_e6605 - _e6608) * _e6242)) - _e6614) > 0f) {
                                                        let _e6619 = local_17.member[3u];
                                                        let _e6622 = local_17.member_1[3u];
                                                        let _e6625 = local_17.member[3u];
                                                        let _e6631 = local_17.member_2[3u];
                                                        phi_3056_ = (((_e6619 + ((_e6622 - _e6625) * _e6242)) - _e6631) > 0f);
                                                        phi_3057_ = false;
                                                    } else {
                                                        phi_3056_ = bool();
                                                        phi_3057_ = true;
                                                    }
                                                    let _e6635 = phi_3056_;
                                                    let _e6637 = phi_3057_;
                                                    phi_3058_ = _e6635;
                                                    phi_3059_ = _e6637;
                                                } else {
                                                    phi_3058_ = bool();
                                                    phi_3059_ = true;
                                                }
                                                let _e6639 = phi_3058_;
                                                let _e6641 = phi_3059_;
                                                phi_3060_ = _e6639;
                                                phi_3061_ = _e6641;
                                            } else {
                                                phi_3060_ = bool();
                                                phi_3061_ = true;
                                            }
                                            let _e6643 = phi_3060_;
                                            let _e6645 = phi_3061_;
                                            if _e6645 {
                                                phi_3065_ = false;
                                            } else {
                                                phi_3065_ = _e6643;
                                            }
                                            let _e6647 = phi_3065_;
                                            if _e6647 {
                                                if (_e6242 <= _e6244) {
                                                    phi_3375_ = true;
                                                } else {
                                                    let _e6651 = local_16.member[0u];
                                                    let _e6654 = local_16.member_1[0u];
                                                    let _e6657 = local_16.member[0u];
                                                    let _e6663 = local_16.member_2[0u];
                                                    let _e6667 = local_17.member[0u];
                                                    let _e6670 = local_17.member_1[0u];
                                                    let _e6673 = local_17.member[0u];
                                                    let _e6679 = local_17.member_2[0u];
                                                    if ((((_e6651 + ((_e6654 - _e6657) * _e6242)) - _e6663) + ((_e6667 + ((_e6670 - _e6673) * _e6248)) - _e6679)) > 0f) {
                                                        let _e6685 = local_16.member[1u];
                                                        let _e6688 = local_16.member_1[1u];
                                                        let _e6691 = local_16.member[1u];
                                                        let _e6697 = local_16.member_2[1u];
                                                        let _e6701 = local_17.member[1u];
                                                        let _e6704 = local_17.member_1[1u];
                                                        let _e6707 = local_17.member[1u];
                                                        let _e6713 = local_17.member_2[1u];
                                                        if ((((_e6685 + ((_e6688 - _e6691) * _e6242)) - _e6697) + ((_e6701 + ((_e6704 - _e6707) * _e6248)) - _e6713)) > 0f) {
                                                            let _e6719 = local_16.member[2u];
                                                            let _e6722 = local_16.member_1[2u];
                                                            let _e6725 = local_16.member[2u];
                                                            let _e6731 = local_16.member_2[2u];
                                                            let _e6735 = local_17.member[2u];
                                                            let _e6738 = local_17.member_1[2u];
                                                            let _e6741 = local_17.member[2u];
                                                            let _e6747 = local_17.member_2[2u];
                                                            if ((((_e6719 + ((_e6722 - _e6725) * _e6242)) - _e6731) + ((_e6735 + ((_e6738 - _e6741) * _e6248)) - _e6747)) > 0f) {
                                                                let _e6753 = local_16.member[3u];
                                                                let _e6756 = local_16.member_1[3u];
                                                                let _e6759 = local_16.member[3u];
                                                                let _e6765 = local_16.member_2[3u];
                                                                let _e6769 = local_17.member[3u];
                                                                let _e6772 = local_17.member_1[3u];
                                                                let _e6775 = local_17.member[3u];
                                                                let _e6781 = local_17.member_2[3u];
                                                                phi_3362_ = ((((_e6753 + ((_e6756 - _e6759) * _e6242)) - _e6765) + ((_e6769 + ((_e6772 - _e6775) * _e6248)) - _e6781)) > 0f);
                                                                phi_3363_ = false;
                                                            } else {
                                                                phi_3362_ = bool();
                                                                phi_3363_ = true;
                                                            }
                                                            let _e6786 = phi_3362_;
                                                            let _e6788 = phi_3363_;
                                                            phi_3364_ = _e6786;
                                                            phi_3365_ = _e6788;
                                                        } else {
                                                            phi_3364_ = bool();
                                                            phi_3365_ = true;
                                                        }
                                                        let _e6790 = phi_3364_;
                                                        let _e6792 = phi_3365_;
                                                        phi_3366_ = _e6790;
                                                        phi_3367_ = _e6792;
                                                    } else {
                                                        phi_3366_ = bool();
                                                        phi_3367_ = true;
                                                    }
                                                    let _e6794 = phi_3366_;
                                                    let _e6796 = phi_3367_;
                                                    if _e6796 {
                                                        phi_3371_ = false;
                                                    } else {
                                                        phi_3371_ = _e6794;
                                                    }
                                                    let _e6798 = phi_3371_;
                                                    phi_3375_ = _e6798;
                                                }
                                                let _e6800 = phi_3375_;
                                                if _e6800 {
                                                    if _e6250 {
                                                        if (_e6242 >= _e328) {
                                                            phi_3386_ = false;
                                                        } else {
                                                            phi_3386_ = true;
                                                        }
                                                        let _e6803 = phi_3386_;
                                                        phi_3387_ = _e6803;
                                                    } else {
                                                        phi_3387_ = true;
                                                    }
                                                    let _e6805 = phi_3387_;
                                                    if _e6805 {
                                                        local_16 = type_32(array<f32, 4>(_e6544.member[0], _e6544.member[1], _e6544.member[2], _e6544.member[3]), array<f32, 4>(_e6544.member_1[0], _e6544.member_1[1], _e6544.member_1[2], _e6544.member_1[3]), array<f32, 4>(_e6544.member_2[0], _e6544.member_2[1], _e6544.member_2[2], _e6544.member_2[3]));
                                                        let _e6827 = local_16.member[0u];
                                                        let _e6830 = local_16.member_1[0u];
                                                        let _e6833 = local_16.member_2[0u];
                                                        if (_e6827 > _e6833) {
                                                            if (_e6830 > _e6833) {
                                                                phi_3461_ = false;
                                                            } else {
                                                                phi_3461_ = true;
                                                            }
                                                            let _e6837 = phi_3461_;
                                                            phi_3462_ = _e6837;
                                                        } else {
                                                            phi_3462_ = true;
                                                        }
                                                        let _e6839 = phi_3462_;
                                                        if _e6839 {
                                                            let _e6840 = (_e6830 >= _e6827);
                                                            if _e6840 {
                                                                phi_3484_ = f32();
                                                                phi_3485_ = false;
                                                            } else {
                                                                if ((_e6827 - _e6830) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3482_ = (((_e6827 - _e6833) / (_e6827 - _e6830)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3483_ = false;
                                                                } else {
                                                                    phi_3482_ = f32();
                                                                    phi_3483_ = true;
                                                                }
                                                                let _e6851 = phi_3482_;
                                                                let _e6853 = phi_3483_;
                                                                phi_3484_ = _e6851;
                                                                phi_3485_ = _e6853;
                                                            }
                                                            let _e6855 = phi_3484_;
                                                            let _e6857 = phi_3485_;
                                                            phi_3486_ = _e6855;
                                                            phi_3487_ = _e6840;
                                                            phi_3488_ = _e6857;
                                                        } else {
                                                            phi_3486_ = f32();
                                                            phi_3487_ = true;
                                                            phi_3488_ = false;
                                                        }
                                                        let _e6859 = phi_3486_;
                                                        let _e6861 = phi_3487_;
                                                        let _e6863 = phi_3488_;
                                                        if _e6861 {
                                                            phi_3492_ = 2f;
                                                            phi_3493_ = true;
                                                        } else {
                                                            phi_3492_ = _e6242;
                                                            phi_3493_ = _e6863;
                                                        }
                                                        let _e6865 = phi_3492_;
                                                        let _e6867 = phi_3493_;
                                                        if _e6867 {
                                                            phi_3497_ = _e6865;
                                                        } else {
                                                            phi_3497_ = _e6859;
                                                        }
                                                        let _e6869 = phi_3497_;
                                                        let _e6872 = local_16.member[1u];
                                                        let _e6875 = local_16.member_1[1u];
                                                        let _e6878 = local_16.member_2[1u];
                                                        if (_e6872 > _e6878) {
                                                            if (_e6875 > _e6878) {
                                                                phi_3529_ = false;
                                                            } else {
                                                                phi_3529_ = true;
                                                            }
                                                            let _e6882 = phi_3529_;
                                                            phi_3530_ = _e6882;
                                                        } else {
                                                            phi_3530_ = true;
                                                        }
                                                        let _e6884 = phi_3530_;
                                                        if _e6884 {
                                                            let _e6885 = (_e6875 >= _e6872);
                                                            if _e6885 {
                                                                phi_3552_ = f32();
                                                                phi_3553_ = false;
                                                            } else {
                                                                if ((_e6872 - _e6875) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3550_ = (((_e6872 - _e6878) / (_e6872 - _e6875)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3551_ = false;
                                                                } else {
                                                                    phi_3550_ = f32();
                                                                    phi_3551_ = true;
                                                                }
                                                                let _e6896 = phi_3550_;
                                                                let _e6898 = phi_3551_;
                                                                phi_3552_ = _e6896;
                                                                phi_3553_ = _e6898;
                                                            }
                                                            let _e6900 = phi_3552_;
                                                            let _e6902 = phi_3553_;
                                                            phi_3554_ = _e6900;
                                                            phi_3555_ = _e6885;
                                                            phi_3556_ = _e6902;
                                                        } else {
                                                            phi_3554_ = f32();
                                                            phi_3555_ = true;
                                                            phi_3556_ = false;
                                                        }
                                                        let _e6904 = phi_3554_;
                                                        let _e6906 = phi_3555_;
                                                        let _e6908 = phi_3556_;
                                                        if _e6906 {
                                                            phi_3560_ = 2f;
                                                            phi_3561_ = true;
                                                        } else {
                                                            phi_3560_ = _e6242;
                                                            phi_3561_ = _e6908;
                                                        }
                                                        let _e6910 = phi_3560_;
                                                        let _e6912 = phi_3561_;
                                                        if _e6912 {
                                                            phi_3565_ = _e6910;
                                                        } else {
                                                            phi_3565_ = _e6904;
                                                        }
                                                        let _e6914 = phi_3565_;
                                                        if (_e6869 < _e6914) {
                                                            phi_3570_ = _e6869;
                                                        } else {
                                                            phi_3570_ = _e6914;
                                                        }
                                                        let _e6917 = phi_3570_;
                                                        let _e6920 = local_16.member[2u];
                                                        let _e6923 = local_16.member_1[2u];
                                                        let _e6926 = local_16.member_2[2u];
                                                        if (_e6920 > _e6926) {
                                                            if (_e6923 > _e6926) {
                                                                phi_3602_ = false;
                                                            } else {
                                                                phi_3602_ = true;
                                                            }
                                                            let _e6930 = phi_3602_;
                                                            phi_3603_ = _e6930;
                                                        } else {
                                                            phi_3603_ = true;
                                                        }
                                                        let _e6932 = phi_3603_;
                                                        if _e6932 {
                                                            let _e6933 = (_e6923 >= _e6920);
                                                            if _e6933 {
                                                                phi_3625_ = f32();
                                                                phi_3626_ = false;
                                                            } else {
                                                                if ((_e6920 - _e6923) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3623_ = (((_e6920 - _e6926) / (_e6920 - _e6923)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3624_ = false;
                                                                } else {
                                                                    phi_3623_ = f32();
                                                                    phi_3624_ = true;
                                                                }
                                                                let _e6944 = phi_3623_;
                                                                let _e6946 = phi_3624_;
                                                                phi_3625_ = _e6944;
                                                                phi_3626_ = _e6946;
                                                            }
                                                            let _e6948 = phi_3625_;
                                                            let _e6950 = phi_3626_;
                                                            phi_3627_ = _e6948;
                                                            phi_3628_ = _e6933;
                                                            phi_3629_ = _e6950;
                                                        } else {
                                                            phi_3627_ = f32();
                                                            phi_3628_ = true;
                                                            phi_3629_ = false;
                                                        }
                                                        let _e6952 = phi_3627_;
                                                        let _e6954 = phi_3628_;
                                                        let _e6956 = phi_3629_;
                                                        if _e6954 {
                                                            phi_3633_ = 2f;
                                                            phi_3634_ = true;
                                                        } else {
                                                            phi_3633_ = _e6242;
                                                            phi_3634_ = _e6956;
                                                        }
                                                        let _e6958 = phi_3633_;
                                                        let _e6960 = phi_3634_;
                                                        if _e6960 {
                                                            phi_3638_ = _e6958;
                                                        } else {
                                                            phi_3638_ = _e6952;
                                                        }
                                                        let _e6962 = phi_3638_;
                                                        let _e6965 = local_16.member[3u];
                                                        let _e6968 = local_16.member_1[3u];
                                                        let _e6971 = local_16.member_2[3u];
                                                        if (_e6965 > _e6971) {
                                                            if (_e6968 > _e6971) {
                                                                phi_3670_ = false;
                                                            } else {
                                                                phi_3670_ = true;
                                                            }
                                                            let _e6975 = phi_3670_;
                                                            phi_3671_ = _e6975;
                                                        } else {
                                                            phi_3671_ = true;
                                                        }
                                                        let _e6977 = phi_3671_;
                                                        if _e6977 {
                                                            let _e6978 = (_e6968 >= _e6965);
                                                            if _e6978 {
                                                                phi_3693_ = f32();
                                                                phi_3694_ = false;
                                                            } else {
                                                                if ((_e6965 - _e6968) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3691_ = (((_e6965 - _e6971) / (_e6965 - _e6968)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3692_ = false;
                                                                } else {
                                                                    phi_3691_ = f32();
                                                                    phi_3692_ = true;
                                                                }
                                                                let _e6989 = phi_3691_;
                                                                let _e6991 = phi_3692_;
                                                                phi_3693_ = _e6989;
                                                                phi_3694_ = _e6991;
                                                            }
                                                            let _e6993 = phi_3693_;
                                                            let _e6995 = phi_3694_;
                                                            phi_3695_ = _e6993;
                                                            phi_3696_ = _e6978;
                                                            phi_3697_ = _e6995;
                                                        } else {
                                                            phi_3695_ = f32();
                                                            phi_3696_ = true;
                                                            phi_3697_ = false;
                                                        }
                                                        let _e6997 = phi_3695_;
                                                        let _e6999 = phi_3696_;
                                                        let _e7001 = phi_3697_;
                                                        if _e6999 {
                                                            phi_3701_ = 2f;
                                                            phi_3702_ = true;
                                                        } else {
                                                            phi_3701_ = _e6242;
                                                            phi_3702_ = _e7001;
                                                        }
                                                        let _e7003 = phi_3701_;
                                                        let _e7005 = phi_3702_;
                                                        if _e7005 {
                                                            phi_3706_ = _e7003;
                                                        } else {
                                                            phi_3706_ = _e6997;
                                                        }
                                                        let _e7007 = phi_3706_;
                                                        if (_e6962 < _e7007) {
                                                            phi_3711_ = _e6962;
                                                        } else {
                                                            phi_3711_ = _e7007;
                                                        }
                                                        let _e7010 = phi_3711_;
                                                        if (_e6917 < _e7010) {
                                                            phi_3716_ = _e6917;
                                                        } else {
                                                            phi_3716_ = _e7010;
                                                        }
                                                        let _e7013 = phi_3716_;
                                                        if (_e7013 > _e6242) {
                                                            phi_3721_ = _e7013;
                                                        } else {
                                                            phi_3721_ = _e6242;
                                                        }
                                                        let _e7016 = phi_3721_;
                                                        let _e7017 = (_e7016 > _e328);
                                                        if _e7017 {
                                                            phi_4226_ = f32();
                                                            phi_4227_ = f32();
                                                            phi_4228_ = false;
                                                            phi_4229_ = false;
                                                        } else {
                                                            let _e7018 = (_e7016 - _e6242);
                                                            let _e7019 = (_e7018 <= _e6237);
                                                            let _e7021 = (_e7016 + (_e324 * 0.01f));
                                                            if (_e7021 < _e328) {
                                                                phi_3734_ = _e7021;
                                                            } else {
                                                                phi_3734_ = _e328;
                                                            }
                                                            let _e7024 = phi_3734_;
                                                            if _e7019 {
                                                                if (_e530.member_1 > 0f) {
                                                                    let _e7028 = local_18.member[0u];
                                                                    let _e7034 = local_18.member[1u];
                                                                    let _e7050 = local_18.member_1[0u];
                                                                    let _e7056 = local_18.member_1[1u];
                                                                    let _e7072 = local_18.member_2[0u];
                                                                    let _e7078 = local_18.member_2[1u];
                                                                    let _e7092 = function_3(array<f32, 3>((_e7028[0] + ((_e7034[0] - _e7028[0]) * _e7024)), (_e7028[1] + ((_e7034[1] - _e7028[1]) * _e7024)), (_e7028[2] + ((_e7034[2] - _e7028[2]) * _e7024))), array<f32, 3>((_e7050[0] + ((_e7056[0] - _e7050[0]) * _e7024)), (_e7050[1] + ((_e7056[1] - _e7050[1]) * _e7024)), (_e7050[2] + ((_e7056[2] - _e7050[2]) * _e7024))), array<f32, 3>((_e7072[0] + ((_e7078[0] - _e7072[0]) * _e7024)), (_e7072[1] + ((_e7078[1] - _e7072[1]) * _e7024)), (_e7072[2] + ((_e7078[2] - _e7072[2]) * _e7024))), 1u);
                                                                    let _e7103 = (((_e7092[0] * _e7092[0]) + (_e7092[1] * _e7092[1])) + (_e7092[2] * _e7092[2]));
                                                                    if (_e7103 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7103 > 0f) {
                                                                            phi_3864_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_3864_ = 0f;
                                                                        }
                                                                        let _e7156 = phi_3864_;
                                                                        phi_3928_ = _e7156;
                                                                    } else {
                                                                        phi_3871_ = type_14(0i, 5i);
                                                                        phi_3874_ = bitcast<f32>(((bitcast<u32>(_e7103) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7111 = phi_3871_;
                                                                            let _e7113 = phi_3874_;
                                                                            local_41 = _e7113;
                                                                            if (_e7111.member < _e7111.member_1) {
                                                                                let _e7120 = (_e7111.member + 1i);
                                                                                if ((false == (_e7120 > _e7111.member)) != false) {
                                                                                    phi_3895_ = true;
                                                                                } else {
                                                                                    phi_3895_ = false;
                                                                                }
                                                                                let _e7125 = phi_3895_;
                                                                                if _e7125 {
                                                                                    phi_3901_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_3901_ = type_15(1u, _e7120);
                                                                                }
                                                                                let _e7130 = phi_3901_;
                                                                                phi_3872_ = type_14(_e7130.member_1, _e7111.member_1);
                                                                                phi_3915_ = type_15(1u, _e7111.member);
                                                                            } else {
                                                                                phi_3872_ = _e7111;
                                                                                phi_3915_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7136 = phi_3872_;
                                                                            let _e7138 = phi_3915_;
                                                                            let _e7141 = (bitcast<i32>(_e7138.member) != 0i);
                                                                            if _e7141 {
                                                                                phi_3875_ = (0.5f * (_e7113 + (_e7103 / _e7113)));
                                                                            } else {
                                                                                phi_3875_ = f32();
                                                                            }
                                                                            let _e7146 = phi_3875_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3871_ = _e7136;
                                                                                phi_3874_ = _e7146;
                                                                                break if !(_e7141);
                                                                            }
                                                                        }
                                                                        let _e7151 = local_41;
                                                                        phi_3928_ = (_e7151 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7158 = phi_3928_;
                                                                    let _e7164 = local_18.member[0u];
                                                                    if (_e7164[0] < 0f) {
                                                                        phi_3944_ = -(_e7164[0]);
                                                                    } else {
                                                                        phi_3944_ = _e7164[0];
                                                                    }
                                                                    let _e7171 = phi_3944_;
                                                                    if (_e7164[1] < 0f) {
                                                                        phi_3951_ = -(_e7164[1]);
                                                                    } else {
                                                                        phi_3951_ = _e7164[1];
                                                                    }
                                                                    let _e7175 = phi_3951_;
                                                                    if (_e7171 > _e7175) {
                                                                        phi_3956_ = _e7171;
                                                                    } else {
                                                                        phi_3956_ = _e7175;
                                                                    }
                                                                    let _e7178 = phi_3956_;
                                                                    if (_e7164[2] < 0f) {
                                                                        phi_3963_ = -(_e7164[2]);
                                                                    } else {
                                                                        phi_3963_ = _e7164[2];
                                                                    }
                                                                    let _e7182 = phi_3963_;
                                                                    if (_e7178 > _e7182) {
                                                                        phi_3968_ = _e7178;
                                                                    } else {
                                                                        phi_3968_ = _e7182;
                                                                    }
                                                                    let _e7185 = phi_3968_;
                                                                    let _e7188 = local_18.member[1u];
                                                                    if (_e7188[0] < 0f) {
                                                                        phi_3981_ = -(_e7188[0]);
                                                                    } else {
                                                                        phi_3981_ = _e7188[0];
                                                                    }
                                                                    let _e7195 = phi_3981_;
                                                                    if (_e7188[1] < 0f) {
                                                                        phi_3988_ = -(_e7188[1]);
                                                                    } else {
                                                                        phi_3988_ = _e7188[1];
                                                                    }
                                                                    let _e7199 = phi_3988_;
                                                                    if (_e7195 > _e7199) {
                                                                        phi_3993_ = _e7195;
                                                                    } else {
                                                                        phi_3993_ = _e7199;
                                                                    }
                                                                    let _e7202 = phi_3993_;
                                                                    if (_e7188[2] < 0f) {
                                                                        phi_4000_ = -(_e7188[2]);
                                                                    } else {
                                                                        phi_4000_ = _e7188[2];
                                                                    }
                                                                    let _e7206 = phi_4000_;
                                                                    if (_e7202 > _e7206) {
                                                                        phi_4005_ = _e7202;
                                                                    } else {
                                                                        phi_4005_ = _e7206;
                                                                    }
                                                                    let _e7209 = phi_4005_;
                                                                    if (_e7185 > _e7209) {
                                                                        phi_4010_ = _e7185;
                                                                    } else {
                                                                        phi_4010_ = _e7209;
                                                                    }
                                                                    let _e7212 = phi_4010_;
                                                                    let _e7214 = local_18.member_3;
                                                                    let _e7218 = local_18.member_1[0u];
                                                                    if (_e7218[0] < 0f) {
                                                                        phi_4027_ = -(_e7218[0]);
                                                                    } else {
                                                                        phi_4027_ = _e7218[0];
                                                                    }
                                                                    let _e7225 = phi_4027_;
                                                                    if (_e7218[1] < 0f) {
                                                                        phi_4034_ = -(_e7218[1]);
                                                                    } else {
                                                                        phi_4034_ = _e7218[1];
                                                                    }
                                                                    let _e7229 = phi_4034_;
                                                                    if (_e7225 > _e7229) {
                                                                        phi_4039_ = _e7225;
                                                                    } else {
                                                                        phi_4039_ = _e7229;
                                                                    }
                                                                    let _e7232 = phi_4039_;
                                                                    if (_e7218[2] < 0f) {
                                                                        phi_4046_ = -(_e7218[2]);
                                                                    } else {
                                                                        phi_4046_ = _e7218[2];
                                                                    }
                                                                    let _e7236 = phi_4046_;
                                                                    if (_e7232 > _e7236) {
                                                                        phi_4051_ = _e7232;
                                                                    } else {
                                                                        phi_4051_ = _e7236;
                                                                    }
                                                                    let _e7239 = phi_4051_;
                                                                    let _e7242 = local_18.member_1[1u];
                                                                    if (_e7242[0] < 0f) {
                                                                        phi_4065_ = -(_e7242[0]);
                                                                    } else {
                                                                        phi_4065_ = _e7242[0];
                                                                    }
                                                                    let _e7249 = phi_4065_;
                                                                    if (_e7242[1] < 0f) {
                                                                        phi_4072_ = -(_e7242[1]);
                                                                    } else {
                                                                        phi_4072_ = _e7242[1];
                                                                    }
                                                                    let _e7253 = phi_4072_;
                                                                    if (_e7249 > _e7253) {
                                                                        phi_4077_ = _e7249;
                                                                    } else {
                                                                        phi_4077_ = _e7253;
                                                                    }
                                                                    let _e7256 = phi_4077_;
                                                                    if (_e7242[2] < 0f) {
                                                                        phi_4084_ = -(_e7242[2]);
                                                                    } else {
                                                                        phi_4084_ = _e7242[2];
                                                                    }
                                                                    let _e7260 = phi_4084_;
                                                                    if (_e7256 > _e7260) {
                                                                        phi_4089_ = _e7256;
                                                                    } else {
                                                                        phi_4089_ = _e7260;
                                                                    }
                                                                    let _e7263 = phi_4089_;
                                                                    if (_e7239 > _e7263) {
                                                                        phi_4094_ = _e7239;
                                                                    } else {
                                                                        phi_4094_ = _e7263;
                                                                    }
                                                                    let _e7266 = phi_4094_;
                                                                    let _e7268 = local_18.member_3;
                                                                    let _e7272 = local_18.member_2[0u];
                                                                    if (_e7272[0] < 0f) {
                                                                        phi_4111_ = -(_e7272[0]);
                                                                    } else {
                                                                        phi_4111_ = _e7272[0];
                                                                    }
                                                                    let _e7279 = phi_4111_;
                                                                    if (_e7272[1] < 0f) {
                                                                        phi_4118_ = -(_e7272[1]);
                                                                    } else {
                                                                        phi_4118_ = _e7272[1];
                                                                    }
                                                                    let _e7283 = phi_4118_;
                                                                    if (_e7279 > _e7283) {
                                                                        phi_4123_ = _e7279;
                                                                    } else {
                                                                        phi_4123_ = _e7283;
                                                                    }
                                                                    let _e7286 = phi_4123_;
                                                                    if (_e7272[2] < 0f) {
                                                                        phi_4130_ = -(_e7272[2]);
                                                                    } else {
                                                                        phi_4130_ = _e7272[2];
                                                                    }
                                                                    let _e7290 = phi_4130_;
                                                                    if (_e7286 > _e7290) {
                                                                        phi_4135_ = _e7286;
                                                                    } else {
                                                                        phi_4135_ = _e7290;
                                                                    }
                                                                    let _e7293 = phi_4135_;
                                                                    let _e7296 = local_18.member_2[1u];
                                                                    if (_e7296[0] < 0f) {
                                                                        phi_4149_ = -(_e7296[0]);
                                                                    } else {
                                                                        phi_4149_ = _e7296[0];
                                                                    }
                                                                    let _e7303 = phi_4149_;
                                                                    if (_e7296[1] < 0f) {
                                                                        phi_4156_ = -(_e7296[1]);
                                                                    } else {
                                                                        phi_4156_ = _e7296[1];
                                                                    }
                                                                    let _e7307 = phi_4156_;
                                                                    if (_e7303 > _e7307) {
                                                                        phi_4161_ = _e7303;
                                                                    } else {
                                                                        phi_4161_ = _e7307;
                                                                    }
                                                                    let _e7310 = phi_4161_;
                                                                    if (_e7296[2] < 0f) {
                                                                        phi_4168_ = -(_e7296[2]);
                                                                    } else {
                                                                        phi_4168_ = _e7296[2];
                                                                    }
                                                                    let _e7314 = phi_4168_;
                                                                    if (_e7310 > _e7314) {
                                                                        phi_4173_ = _e7310;
                                                                    } else {
                                                                        phi_4173_ = _e7314;
                                                                    }
                                                                    let _e7317 = phi_4173_;
                                                                    if (_e7293 > _e7317) {
                                                                        phi_4178_ = _e7293;
                                                                    } else {
                                                                        phi_4178_ = _e7317;
                                                                    }
                                                                    let _e7320 = phi_4178_;
                                                                    let _e7322 = local_18.member_3;
                                                                    let _e7329 = local_18.member_3;
                                                                    if (((_e7158 * (1f + (0.000000059604645f * 8f))) + (((((((_e7212 + _e7214) + (_e7266 + _e7268)) + (_e7320 + _e7322)) * (0.000000059604645f * 16f)) + (_e7329 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e530.member_1) {
                                                                        phi_4198_ = false;
                                                                    } else {
                                                                        phi_4198_ = true;
                                                                    }
                                                                    let _e7338 = phi_4198_;
                                                                    phi_4199_ = _e7338;
                                                                } else {
                                                                    phi_4199_ = true;
                                                                }
                                                                let _e7340 = phi_4199_;
                                                                phi_4200_ = _e7340;
                                                            } else {
                                                                phi_4200_ = true;
                                                            }
                                                            let _e7342 = phi_4200_;
                                                            if _e7342 {
                                                                if _e6250 {
                                                                    if _e7019 {
                                                                        phi_4216_ = true;
                                                                    } else {
                                                                        if (_e7018 <= (_e6246 * 0.25f)) {
                                                                            phi_4215_ = false;
                                                                        } else {
                                                                            phi_4215_ = true;
                                                                        }
                                                                        let _e7347 = phi_4215_;
                                                                        phi_4216_ = _e7347;
                                                                    }
                                                                    let _e7349 = phi_4216_;
                                                                    if _e7349 {
                                                                        phi_4221_ = (_e6564 + _e6564);
                                                                    } else {
                                                                        phi_4221_ = 0f;
                                                                    }
                                                                    let _e7352 = phi_4221_;
                                                                    phi_4223_ = _e7352;
                                                                } else {
                                                                    phi_4223_ = (_e328 - _e6242);
                                                                }
                                                                let _e7354 = phi_4223_;
                                                                phi_4224_ = _e7354;
                                                                phi_4225_ = false;
                                                            } else {
                                                                phi_4224_ = f32();
                                                                phi_4225_ = true;
                                                            }
                                                            let _e7356 = phi_4224_;
                                                            let _e7358 = phi_4225_;
                                                            phi_4226_ = _e7356;
                                                            phi_4227_ = _e7018;
                                                            phi_4228_ = _e7342;
                                                            phi_4229_ = _e7358;
                                                        }
                                                        let _e7360 = phi_4226_;
                                                        let _e7362 = phi_4227_;
                                                        let _e7364 = phi_4228_;
                                                        let _e7366 = phi_4229_;
                                                        phi_4230_ = _e7016;
                                                        phi_4231_ = _e7360;
                                                        phi_4232_ = _e7362;
                                                        phi_4233_ = _e7016;
                                                        phi_4234_ = _e7364;
                                                        phi_4235_ = _e7017;
                                                        phi_4236_ = _e7366;
                                                        phi_4237_ = false;
                                                    } else {
                                                        phi_4230_ = f32();
                                                        phi_4231_ = f32();
                                                        phi_4232_ = f32();
                                                        phi_4233_ = f32();
                                                        phi_4234_ = false;
                                                        phi_4235_ = false;
                                                        phi_4236_ = false;
                                                        phi_4237_ = true;
                                                    }
                                                    let _e7368 = phi_4230_;
                                                    let _e7370 = phi_4231_;
                                                    let _e7372 = phi_4232_;
                                                    let _e7374 = phi_4233_;
                                                    let _e7376 = phi_4234_;
                                                    let _e7378 = phi_4235_;
                                                    let _e7380 = phi_4236_;
                                                    let _e7382 = phi_4237_;
                                                    phi_4238_ = _e7368;
                                                    phi_4239_ = _e7370;
                                                    phi_4240_ = _e7372;
                                                    phi_4241_ = _e7374;
                                                    phi_4242_ = false;
                                                    phi_4243_ = _e7376;
                                                    phi_4244_ = _e7378;
                                                    phi_4245_ = _e7380;
                                                    phi_4246_ = _e7382;
                                                } else {
                                                    phi_4238_ = f32();
                                                    phi_4239_ = f32();
                                                    phi_4240_ = f32();
                                                    phi_4241_ = f32();
                                                    phi_4242_ = true;
                                                    phi_4243_ = false;
                                                    phi_4244_ = false;
                                                    phi_4245_ = false;
                                                    phi_4246_ = false;
                                                }
                                                let _e7384 = phi_4238_;
                                                let _e7386 = phi_4239_;
                                                let _e7388 = phi_4240_;
                                                let _e7390 = phi_4241_;
                                                let _e7392 = phi_4242_;
                                                let _e7394 = phi_4243_;
                                                let _e7396 = phi_4244_;
                                                let _e7398 = phi_4245_;
                                                let _e7400 = phi_4246_;
                                                phi_4247_ = _e7384;
                                                phi_4248_ = _e7386;
                                                phi_4249_ = _e7388;
                                                phi_4250_ = _e7390;
                                                phi_4251_ = _e7392;
                                                phi_4252_ = _e7394;
                                                phi_4253_ = _e7396;
                                                phi_4254_ = _e7398;
                                                phi_4255_ = _e7400;
                                            } else {
                                                phi_4247_ = f32();
                                                phi_4248_ = f32();
                                                phi_4249_ = f32();
                                                phi_4250_ = f32();
                                                phi_4251_ = true;
                                                phi_4252_ = false;
                                                phi_4253_ = false;
                                                phi_4254_ = false;
                                                phi_4255_ = false;
                                            }
                                            let _e7402 = phi_4247_;
                                            let _e7404 = phi_4248_;
                                            let _e7406 = phi_4249_;
                                            let _e7408 = phi_4250_;
                                            let _e7410 = phi_4251_;
                                            let _e7412 = phi_4252_;
                                            let _e7414 = phi_4253_;
                                            let _e7416 = phi_4254_;
                                            let _e7418 = phi_4255_;
                                            if _e7410 {
                                                if (_e6242 <= _e6244) {
                                                    let _e7579 = (_e6252 + 1u);
                                                    let _e7580 = (_e7579 > 3u);
                                                    if _e7580 {
                                                        phi_4268_ = false;
                                                    } else {
                                                        phi_4268_ = true;
                                                    }
                                                    let _e7582 = phi_4268_;
                                                    phi_4590_ = _e7579;
                                                    phi_4591_ = f32();
                                                    phi_4592_ = false;
                                                    phi_4593_ = _e7582;
                                                    phi_4594_ = _e7580;
                                                } else {
                                                    let _e7422 = local_16.member[0u];
                                                    let _e7425 = local_16.member_1[0u];
                                                    let _e7428 = local_16.member[0u];
                                                    let _e7434 = local_16.member_2[0u];
                                                    let _e7435 = ((_e7422 + ((_e7425 - _e7428) * _e6248)) - _e7434);
                                                    let _e7438 = local_16.member[1u];
                                                    let _e7441 = local_16.member_1[1u];
                                                    let _e7444 = local_16.member[1u];
                                                    let _e7450 = local_16.member_2[1u];
                                                    let _e7451 = ((_e7438 + ((_e7441 - _e7444) * _e6248)) - _e7450);
                                                    if (_e7435 < _e7451) {
                                                        phi_4341_ = _e7435;
                                                    } else {
                                                        phi_4341_ = _e7451;
                                                    }
                                                    let _e7454 = phi_4341_;
                                                    let _e7457 = local_16.member[2u];
                                                    let _e7460 = local_16.member_1[2u];
                                                    let _e7463 = local_16.member[2u];
                                                    let _e7469 = local_16.member_2[2u];
                                                    let _e7470 = ((_e7457 + ((_e7460 - _e7463) * _e6248)) - _e7469);
                                                    let _e7473 = local_16.member[3u];
                                                    let _e7476 = local_16.member_1[3u];
                                                    let _e7479 = local_16.member[3u];
                                                    let _e7485 = local_16.member_2[3u];
                                                    let _e7486 = ((_e7473 + ((_e7476 - _e7479) * _e6248)) - _e7485);
                                                    if (_e7470 < _e7486) {
                                                        phi_4414_ = _e7470;
                                                    } else {
                                                        phi_4414_ = _e7486;
                                                    }
                                                    let _e7489 = phi_4414_;
                                                    if (_e7454 < _e7489) {
                                                        phi_4419_ = _e7454;
                                                    } else {
                                                        phi_4419_ = _e7489;
                                                    }
                                                    let _e7492 = phi_4419_;
                                                    let _e7495 = local_17.member[0u];
                                                    let _e7498 = local_17.member_1[0u];
                                                    let _e7501 = local_17.member[0u];
                                                    let _e7507 = local_17.member_2[0u];
                                                    let _e7508 = ((_e7495 + ((_e7498 - _e7501) * _e6242)) - _e7507);
                                                    let _e7511 = local_17.member[1u];
                                                    let _e7514 = local_17.member_1[1u];
                                                    let _e7517 = local_17.member[1u];
                                                    let _e7523 = local_17.member_2[1u];
                                                    let _e7524 = ((_e7511 + ((_e7514 - _e7517) * _e6242)) - _e7523);
                                                    if (_e7508 < _e7524) {
                                                        phi_4492_ = _e7508;
                                                    } else {
                                                        phi_4492_ = _e7524;
                                                    }
                                                    let _e7527 = phi_4492_;
                                                    let _e7530 = local_17.member[2u];
                                                    let _e7533 = local_17.member_1[2u];
                                                    let _e7536 = local_17.member[2u];
                                                    let _e7542 = local_17.member_2[2u];
                                                    let _e7543 = ((_e7530 + ((_e7533 - _e7536) * _e6242)) - _e7542);
                                                    let _e7546 = local_17.member[3u];
                                                    let _e7549 = local_17.member_1[3u];
                                                    let _e7552 = local_17.member[3u];
                                                    let _e7558 = local_17.member_2[3u];
                                                    let _e7559 = ((_e7546 + ((_e7549 - _e7552) * _e6242)) - _e7558);
                                                    if (_e7543 < _e7559) {
                                                        phi_4565_ = _e7543;
                                                    } else {
                                                        phi_4565_ = _e7559;
                                                    }
                                                    let _e7562 = phi_4565_;
                                                    if (_e7527 < _e7562) {
                                                        phi_4570_ = _e7527;
                                                    } else {
                                                        phi_4570_ = _e7562;
                                                    }
                                                    let _e7565 = phi_4570_;
                                                    if (_e7565 > 0f) {
                                                        phi_4588_ = 0.5f;
                                                    } else {
                                                        let _e7569 = (0.95f * (_e7492 / (_e7492 - _e7565)));
                                                        if (_e7569 > 0.0625f) {
                                                            if (_e7569 < 0.9f) {
                                                                phi_4586_ = _e7569;
                                                            } else {
                                                                phi_4586_ = 0.9f;
                                                            }
                                                            let _e7573 = phi_4586_;
                                                            phi_4587_ = _e7573;
                                                        } else {
                                                            phi_4587_ = 0.0625f;
                                                        }
                                                        let _e7575 = phi_4587_;
                                                        phi_4588_ = _e7575;
                                                    }
                                                    let _e7577 = phi_4588_;
                                                    phi_4590_ = u32();
                                                    phi_4591_ = (_e6564 * _e7577);
                                                    phi_4592_ = true;
                                                    phi_4593_ = false;
                                                    phi_4594_ = false;
                                                }
                                                let _e7584 = phi_4590_;
                                                let _e7586 = phi_4591_;
                                                let _e7588 = phi_4592_;
                                                let _e7590 = phi_4593_;
                                                let _e7592 = phi_4594_;
                                                phi_4595_ = _e7584;
                                                phi_4596_ = _e6244;
                                                phi_4597_ = _e7586;
                                                phi_4598_ = _e6246;
                                                phi_4599_ = _e6248;
                                                phi_4600_ = _e6250;
                                                phi_4601_ = _e6252;
                                                phi_4602_ = _e7588;
                                                phi_4603_ = _e7590;
                                                phi_4604_ = _e7592;
                                                phi_4605_ = false;
                                                phi_4606_ = false;
                                                phi_4607_ = false;
                                            } else {
                                                phi_4595_ = u32();
                                                phi_4596_ = _e7402;
                                                phi_4597_ = _e7404;
                                                phi_4598_ = _e7406;
                                                phi_4599_ = _e6242;
                                                phi_4600_ = true;
                                                phi_4601_ = 0u;
                                                phi_4602_ = _e7412;
                                                phi_4603_ = false;
                                                phi_4604_ = false;
                                                phi_4605_ = _e7414;
                                                phi_4606_ = _e7416;
                                                phi_4607_ = _e7418;
                                            }
                                            let _e7594 = phi_4595_;
                                            let _e7596 = phi_4596_;
                                            let _e7598 = phi_4597_;
                                            let _e7600 = phi_4598_;
                                            let _e7602 = phi_4599_;
                                            let _e7604 = phi_4600_;
                                            let _e7606 = phi_4601_;
                                            let _e7608 = phi_4602_;
                                            let _e7610 = phi_4603_;
                                            let _e7612 = phi_4604_;
                                            let _e7614 = phi_4605_;
                                            let _e7616 = phi_4606_;
                                            let _e7618 = phi_4607_;
                                            if _e7608 {
                                                let _e7619 = (_e7602 + _e7598);
                                                if (_e7619 > _e7596) {
                                                    phi_4616_ = _e7619;
                                                } else {
                                                    phi_4616_ = _e7596;
                                                }
                                                let _e7622 = phi_4616_;
                                                if (_e7622 < _e328) {
                                                    phi_4621_ = _e7622;
                                                } else {
                                                    phi_4621_ = _e328;
                                                }
                                                let _e7625 = phi_4621_;
                                                if !(_e6250) {
                                                    phi_4630_ = true;
                                                } else {
                                                    phi_4630_ = ((_e7625 - _e7602) > _e6237);
                                                }
                                                let _e7629 = phi_4630_;
                                                if _e7629 {
                                                    phi_4634_ = false;
                                                } else {
                                                    phi_4634_ = true;
                                                }
                                                let _e7631 = phi_4634_;
                                                phi_4635_ = _e7625;
                                                phi_4636_ = _e7596;
                                                phi_4637_ = _e7600;
                                                phi_4638_ = _e7602;
                                                phi_4639_ = _e7604;
                                                phi_4640_ = _e7606;
                                                phi_4641_ = _e7629;
                                                phi_4642_ = _e7631;
                                                phi_4643_ = false;
                                                phi_4644_ = false;
                                                phi_4645_ = false;
                                                phi_4646_ = false;
                                            } else {
                                                phi_4635_ = _e6242;
                                                phi_4636_ = _e6244;
                                                phi_4637_ = _e6246;
                                                phi_4638_ = _e6248;
                                                phi_4639_ = _e6250;
                                                phi_4640_ = _e7594;
                                                phi_4641_ = _e7610;
                                                phi_4642_ = false;
                                                phi_4643_ = _e7612;
                                                phi_4644_ = _e7614;
                                                phi_4645_ = _e7616;
                                                phi_4646_ = _e7618;
                                            }
                                            let _e7633 = phi_4635_;
                                            let _e7635 = phi_4636_;
                                            let _e7637 = phi_4637_;
                                            let _e7639 = phi_4638_;
                                            let _e7641 = phi_4639_;
                                            let _e7643 = phi_4640_;
                                            let _e7645 = phi_4641_;
                                            let _e7647 = phi_4642_;
                                            let _e7649 = phi_4643_;
                                            let _e7651 = phi_4644_;
                                            let _e7653 = phi_4645_;
                                            let _e7655 = phi_4646_;
                                            phi_2468_ = _e7633;
                                            phi_2470_ = _e7635;
                                            phi_2472_ = _e7637;
                                            phi_2474_ = _e7639;
                                            phi_2476_ = _e7641;
                                            phi_2478_ = _e7643;
                                            phi_4647_ = _e7596;
                                            phi_4648_ = _e7408;
                                            phi_4649_ = _e7645;
                                            phi_4650_ = _e7647;
                                            phi_4651_ = _e7649;
                                            phi_4652_ = _e7651;
                                            phi_4653_ = _e7653;
                                            phi_4654_ = false;
                                            phi_4655_ = _e7655;
                                        } else {
                                            phi_2468_ = f32();
                                            phi_2470_ = f32();
                                            phi_2472_ = f32();
                                            phi_2474_ = f32();
                                            phi_2476_ = bool();
                                            phi_2478_ = u32();
                                            phi_4647_ = f32();
                                            phi_4648_ = f32();
                                            phi_4649_ = false;
                                            phi_4650_ = false;
                                            phi_4651_ = false;
                                            phi_4652_ = false;
                                            phi_4653_ = false;
                                            phi_4654_ = true;
                                            phi_4655_ = false;
                                        }
                                        let _e7657 = phi_2468_;
                                        let _e7659 = phi_2470_;
                                        let _e7661 = phi_2472_;
                                        let _e7663 = phi_2474_;
                                        let _e7665 = phi_2476_;
                                        let _e7667 = phi_2478_;
                                        let _e7669 = phi_4647_;
                                        let _e7671 = phi_4648_;
                                        let _e7673 = phi_4649_;
                                        let _e7675 = phi_4650_;
                                        let _e7677 = phi_4651_;
                                        let _e7679 = phi_4652_;
                                        let _e7681 = phi_4653_;
                                        let _e7683 = phi_4654_;
                                        let _e7685 = phi_4655_;
                                        local_42 = _e7675;
                                        local_78 = _e7677;
                                        local_79 = _e7679;
                                        local_80 = _e7681;
                                        local_81 = _e7683;
                                        local_82 = _e7685;
                                        local_83 = _e7675;
                                        local_84 = _e7671;
                                        local_85 = _e7669;
                                        continue;
                                        continuing {
                                            phi_2464_ = _e6264;
                                            phi_2467_ = _e7657;
                                            phi_2469_ = _e7659;
                                            phi_2471_ = _e7661;
                                            phi_2473_ = _e7663;
                                            phi_2475_ = _e7665;
                                            phi_2477_ = _e7667;
                                            break if !(_e7673);
                                        }
                                    }
                                    let _e7688 = local_42;
                                    if _e7688 {
                                        phi_4659_ = false;
                                        phi_4660_ = false;
                                        phi_4661_ = false;
                                        phi_4662_ = false;
                                        phi_4663_ = false;
                                    } else {
                                        let _e11130 = local_78;
                                        phi_4659_ = _e11130;
                                        let _e11133 = local_79;
                                        phi_4660_ = _e11133;
                                        let _e11136 = local_80;
                                        phi_4661_ = _e11136;
                                        let _e11139 = local_81;
                                        phi_4662_ = _e11139;
                                        let _e11142 = local_82;
                                        phi_4663_ = _e11142;
                                    }
                                    let _e7690 = phi_4659_;
                                    let _e7692 = phi_4660_;
                                    let _e7694 = phi_4661_;
                                    let _e7696 = phi_4662_;
                                    let _e7698 = phi_4663_;
                                    if _e7690 {
                                        let _e7700 = local_43;
                                        phi_4668_ = type_30(1u, _e7700);
                                        phi_4669_ = false;
                                        phi_4670_ = false;
                                        phi_4671_ = false;
                                        phi_4672_ = false;
                                        phi_4673_ = false;
                                    } else {
                                        phi_4668_ = type_30();
                                        phi_4669_ = _e7692;
                                        phi_4670_ = _e7694;
                                        let _e11149 = local_83;
                                        phi_4671_ = _e11149;
                                        phi_4672_ = _e7696;
                                        phi_4673_ = _e7698;
                                    }
                                    let _e7703 = phi_4668_;
                                    let _e7705 = phi_4669_;
                                    let _e7707 = phi_4670_;
                                    let _e7709 = phi_4671_;
                                    let _e7711 = phi_4672_;
                                    let _e7713 = phi_4673_;
                                    if _e7705 {
                                        phi_4678_ = type_30(0u, type_30().member_1);
                                        phi_4679_ = false;
                                        phi_4680_ = false;
                                        phi_4681_ = false;
                                        phi_4682_ = false;
                                        phi_4683_ = true;
                                    } else {
                                        phi_4678_ = _e7703;
                                        phi_4679_ = _e7707;
                                        phi_4680_ = _e7709;
                                        phi_4681_ = _e7711;
                                        phi_4682_ = _e7713;
                                        phi_4683_ = _e7690;
                                    }
                                    let _e7717 = phi_4678_;
                                    let _e7719 = phi_4679_;
                                    let _e7721 = phi_4680_;
                                    let _e7723 = phi_4681_;
                                    let _e7725 = phi_4682_;
                                    let _e7727 = phi_4683_;
                                    if _e7719 {
                                        let _e11160 = local_84;
                                        phi_4687_ = _e11160;
                                        phi_4688_ = true;
                                        phi_4689_ = false;
                                        phi_4690_ = false;
                                        phi_4691_ = false;
                                    } else {
                                        let _e11162 = local_85;
                                        phi_4687_ = _e11162;
                                        phi_4688_ = _e7721;
                                        phi_4689_ = _e7723;
                                        phi_4690_ = _e7725;
                                        phi_4691_ = _e7727;
                                    }
                                    let _e7729 = phi_4687_;
                                    let _e7731 = phi_4688_;
                                    let _e7733 = phi_4689_;
                                    let _e7735 = phi_4690_;
                                    let _e7737 = phi_4691_;
                                    if _e7731 {
                                        phi_4695_ = _e7729;
                                        phi_4696_ = true;
                                        phi_4697_ = false;
                                        phi_4698_ = false;
                                    } else {
                                        let _e11169 = local_86;
                                        phi_4695_ = _e11169;
                                        phi_4696_ = _e7733;
                                        phi_4697_ = _e7735;
                                        phi_4698_ = _e7737;
                                    }
                                    let _e7739 = phi_4695_;
                                    let _e7741 = phi_4696_;
                                    let _e7743 = phi_4697_;
                                    let _e7745 = phi_4698_;
                                    if _e7741 {
                                        phi_4703_ = type_30(1u, _e7739);
                                        phi_4704_ = false;
                                        phi_4705_ = false;
                                    } else {
                                        phi_4703_ = type_30();
                                        phi_4704_ = _e7743;
                                        phi_4705_ = _e7745;
                                    }
                                    let _e7748 = phi_4703_;
                                    let _e7750 = phi_4704_;
                                    let _e7752 = phi_4705_;
                                    if _e7750 {
                                        phi_4710_ = type_30(0u, type_30().member_1);
                                        phi_4711_ = true;
                                    } else {
                                        phi_4710_ = _e7717;
                                        phi_4711_ = _e7752;
                                    }
                                    let _e7756 = phi_4710_;
                                    let _e7758 = phi_4711_;
                                    if _e7758 {
                                        phi_4715_ = _e7756;
                                    } else {
                                        phi_4715_ = _e7748;
                                    }
                                    let _e7760 = phi_4715_;
                                    phi_4722_ = _e7760.member_1;
                                    phi_4723_ = (_e7760.member != 0u);
                                } else {
                                    phi_4722_ = _e5972;
                                    phi_4723_ = true;
                                }
                                let _e7765 = phi_4722_;
                                let _e7767 = phi_4723_;
                                if _e7767 {
                                    let _e7768 = (_e7765 > _e326);
                                    if _e7768 {
                                        phi_6888_ = f32();
                                        phi_6889_ = u32();
                                        phi_6890_ = f32();
                                        phi_6891_ = type_40();
                                        phi_6892_ = u32();
                                        phi_6893_ = u32();
                                        phi_6894_ = false;
                                        phi_6895_ = false;
                                        phi_6896_ = false;
                                    } else {
                                        let _e7771 = local_18.member[0u];
                                        let _e7777 = local_18.member[1u];
                                        let _e7793 = local_18.member_1[0u];
                                        let _e7799 = local_18.member_1[1u];
                                        let _e7815 = local_18.member_2[0u];
                                        let _e7821 = local_18.member_2[1u];
                                        let _e7835 = function_3(array<f32, 3>((_e7771[0] + ((_e7777[0] - _e7771[0]) * _e5976)), (_e7771[1] + ((_e7777[1] - _e7771[1]) * _e5976)), (_e7771[2] + ((_e7777[2] - _e7771[2]) * _e5976))), array<f32, 3>((_e7793[0] + ((_e7799[0] - _e7793[0]) * _e5976)), (_e7793[1] + ((_e7799[1] - _e7793[1]) * _e5976)), (_e7793[2] + ((_e7799[2] - _e7793[2]) * _e5976))), array<f32, 3>((_e7815[0] + ((_e7821[0] - _e7815[0]) * _e5976)), (_e7815[1] + ((_e7821[1] - _e7815[1]) * _e5976)), (_e7815[2] + ((_e7821[2] - _e7815[2]) * _e5976))), 1u);
                                        if (_e7835[0] < 0f) {
                                            phi_4835_ = -(_e7835[0]);
                                        } else {
                                            phi_4835_ = _e7835[0];
                                        }
                                        let _e7840 = phi_4835_;
                                        if (_e7835[1] < 0f) {
                                            phi_4842_ = -(_e7835[1]);
                                        } else {
                                            phi_4842_ = _e7835[1];
                                        }
                                        let _e7845 = phi_4842_;
                                        if (_e7835[2] < 0f) {
                                            phi_4850_ = -(_e7835[2]);
                                        } else {
                                            phi_4850_ = _e7835[2];
                                        }
                                        let _e7851 = phi_4850_;
                                        let _e7852 = ((_e7840 + _e7845) + _e7851);
                                        let _e7855 = local_18.member[0u];
                                        let _e7861 = local_18.member_1[0u];
                                        let _e7867 = local_18.member_2[0u];
                                        let _e7871 = (_e7855[0] - _e7861[0]);
                                        let _e7872 = (_e7855[1] - _e7861[1]);
                                        let _e7873 = (_e7855[2] - _e7861[2]);
                                        let _e7882 = local_18.member[1u];
                                        let _e7888 = local_18.member_1[1u];
                                        let _e7894 = local_18.member_2[1u];
                                        let _e7898 = (_e7882[0] - _e7888[0]);
                                        let _e7899 = (_e7882[1] - _e7888[1]);
                                        let _e7900 = (_e7882[2] - _e7888[2]);
                                        let _e7909 = local_18.member[0u];
                                        if (_e7909[0] < 0f) {
                                            phi_5001_ = -(_e7909[0]);
                                        } else {
                                            phi_5001_ = _e7909[0];
                                        }
                                        let _e7916 = phi_5001_;
                                        if (_e7909[1] < 0f) {
                                            phi_5008_ = -(_e7909[1]);
                                        } else {
                                            phi_5008_ = _e7909[1];
                                        }
                                        let _e7920 = phi_5008_;
                                        if (_e7916 > _e7920) {
                                            phi_5013_ = _e7916;
                                        } else {
                                            phi_5013_ = _e7920;
                                        }
                                        let _e7923 = phi_5013_;
                                        if (_e7909[2] < 0f) {
                                            phi_5020_ = -(_e7909[2]);
                                        } else {
                                            phi_5020_ = _e7909[2];
                                        }
                                        let _e7927 = phi_5020_;
                                        if (_e7923 > _e7927) {
                                            phi_5025_ = _e7923;
                                        } else {
                                            phi_5025_ = _e7927;
                                        }
                                        let _e7930 = phi_5025_;
                                        let _e7933 = local_18.member[1u];
                                        if (_e7933[0] < 0f) {
                                            phi_5038_ = -(_e7933[0]);
                                        } else {
                                            phi_5038_ = _e7933[0];
                                        }
                                        let _e7940 = phi_5038_;
                                        if (_e7933[1] < 0f) {
                                            phi_5045_ = -(_e7933[1]);
                                        } else {
                                            phi_5045_ = _e7933[1];
                                        }
                                        let _e7944 = phi_5045_;
                                        if (_e7940 > _e7944) {
                                            phi_5050_ = _e7940;
                                        } else {
                                            phi_5050_ = _e7944;
                                        }
                                        let _e7947 = phi_5050_;
                                        if (_e7933[2] < 0f) {
                                            phi_5057_ = -(_e7933[2]);
                                        } else {
                                            phi_5057_ = _e7933[2];
                                        }
                                        let _e7951 = phi_5057_;
                                        if (_e7947 > _e7951) {
                                            phi_5062_ = _e7947;
                                        } else {
                                            phi_5062_ = _e7951;
                                        }
                                        let _e7954 = phi_5062_;
                                        if (_e7930 > _e7954) {
                                            phi_5067_ = _e7930;
                                        } else {
                                            phi_5067_ = _e7954;
                                        }
                                        let _e7957 = phi_5067_;
                                        let _e7959 = local_18.member_3;
                                        let _e7963 = local_18.member_1[0u];
                                        if (_e7963[0] < 0f) {
                                            phi_5084_ = -(_e7963[0]);
                                        } else {
                                            phi_5084_ = _e7963[0];
                                        }
                                        let _e7970 = phi_5084_;
                                        if (_e7963[1] < 0f) {
                                            phi_5091_ = -(_e7963[1]);
                                        } else {
                                            phi_5091_ = _e7963[1];
                                        }
                                        let _e7974 = phi_5091_;
                                        if (_e7970 > _e7974) {
                                            phi_5096_ = _e7970;
                                        } else {
                                            phi_5096_ = _e7974;
                                        }
                                        let _e7977 = phi_5096_;
                                        if (_e7963[2] < 0f) {
                                            phi_5103_ = -(_e7963[2]);
                                        } else {
                                            phi_5103_ = _e7963[2];
                                        }
                                        let _e7981 = phi_5103_;
                                        if (_e7977 > _e7981) {
                                            phi_5108_ = _e7977;
                                        } else {
                                            phi_5108_ = _e7981;
                                        }
                                        let _e7984 = phi_5108_;
                                        let _e7987 = local_18.member_1[1u];
                                        if (_e7987[0] < 0f) {
                                            phi_5122_ = -(_e7987[0]);
                                        } else {
                                            phi_5122_ = _e7987[0];
                                        }
                                        let _e7994 = phi_5122_;
                                        if (_e7987[1] < 0f) {
                                            phi_5129_ = -(_e7987[1]);
                                        } else {
                                            phi_5129_ = _e7987[1];
                                        }
                                        let _e7998 = phi_5129_;
                                        if (_e7994 > _e7998) {
                                            phi_5134_ = _e7994;
                                        } else {
                                            phi_5134_ = _e7998;
                                        }
                                        let _e8001 = phi_5134_;
                                        if (_e7987[2] < 0f) {
                                            phi_5141_ = -(_e7987[2]);
                                        } else {
                                            phi_5141_ = _e7987[2];
                                        }
                                        let _e8005 = phi_5141_;
                                        if (_e8001 > _e8005) {
                                            phi_5146_ = _e8001;
                                        } else {
                                            phi_5146_ = _e8005;
                                        }
                                        let _e8008 = phi_5146_;
                                        if (_e7984 > _e8008) {
                                            phi_5151_ = _e7984;
                                        } else {
                                            phi_5151_ = _e8008;
                                        }
                                        let _e8011 = phi_5151_;
                                        let _e8013 = local_18.member_3;
                                        let _e8017 = local_18.member_2[0u];
                                        if (_e8017[0] < 0f) {
                                            phi_5168_ = -(_e8017[0]);
                                        } else {
                                            phi_5168_ = _e8017[0];
                                        }
                                        let _e8024 = phi_5168_;
                                        if (_e8017[1] < 0f) {
                                            phi_5175_ = -(_e8017[1]);
                                        } else {
                                            phi_5175_ = _e8017[1];
                                        }
                                        let _e8028 = phi_5175_;
                                        if (_e8024 > _e8028) {
                                            phi_5180_ = _e8024;
                                        } else {
                                            phi_5180_ = _e8028;
                                        }
                                        let _e8031 = phi_5180_;
                                        if (_e8017[2] < 0f) {
                                            phi_5187_ = -(_e8017[2]);
                                        } else {
                                            phi_5187_ = _e8017[2];
                                        }
                                        let _e8035 = phi_5187_;
                                        if (_e8031 > _e8035) {
                                            phi_5192_ = _e8031;
                                        } else {
                                            phi_5192_ = _e8035;
                                        }
                                        let _e8038 = phi_5192_;
                                        let _e8041 = local_18.member_2[1u];
                                        if (_e8041[0] < 0f) {
                                            phi_5206_ = -(_e8041[0]);
                                        } else {
                                            phi_5206_ = _e8041[0];
                                        }
                                        let _e8048 = phi_5206_;
                                        if (_e8041[1] < 0f) {
                                            phi_5213_ = -(_e8041[1]);
                                        } else {
                                            phi_5213_ = _e8041[1];
                                        }
                                        let _e8052 = phi_5213_;
                                        if (_e8048 > _e8052) {
                                            phi_5218_ = _e8048;
                                        } else {
                                            phi_5218_ = _e8052;
                                        }
                                        let _e8055 = phi_5218_;
                                        if (_e8041[2] < 0f) {
                                            phi_5225_ = -(_e8041[2]);
                                        } else {
                                            phi_5225_ = _e8041[2];
                                        }
                                        let _e8059 = phi_5225_;
                                        if (_e8055 > _e8059) {
                                            phi_5230_ = _e8055;
                                        } else {
                                            phi_5230_ = _e8059;
                                        }
                                        let _e8062 = phi_5230_;
                                        if (_e8038 > _e8062) {
                                            phi_5235_ = _e8038;
                                        } else {
                                            phi_5235_ = _e8062;
                                        }
                                        let _e8065 = phi_5235_;
                                        let _e8067 = local_18.member_3;
                                        let _e8074 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7855, array<f32, 3>(_e7871, _e7872, _e7873), array<f32, 3>((_e7855[0] - _e7867[0]), (_e7855[1] - _e7867[1]), (_e7855[2] - _e7867[2])), array<f32, 3>((_e7871 - _e7867[0]), (_e7872 - _e7867[1]), (_e7873 - _e7867[2]))), array<array<f32, 3>, 4>(_e7882, array<f32, 3>(_e7898, _e7899, _e7900), array<f32, 3>((_e7882[0] - _e7894[0]), (_e7882[1] - _e7894[1]), (_e7882[2] - _e7894[2])), array<f32, 3>((_e7898 - _e7894[0]), (_e7899 - _e7894[1]), (_e7900 - _e7894[2])))), ((((((_e7957 + _e7959) + (_e8011 + _e8013)) + (_e8065 + _e8067)) * (0.000000059604645f * 16f)) + (_e8074 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e530.member_1);
                                        let _e8090 = local_14.member_1;
                                        if (_e7852 > _e8090) {
                                            if ((bitcast<u32>(_e7852) & 2139095040u) != 2139095040u) {
                                                let _e8095 = (1f / _e7852);
                                                let _e8097 = (_e7835[0] * _e8095);
                                                let _e8099 = (_e7835[1] * _e8095);
                                                let _e8101 = (_e7835[2] * _e8095);
                                                let _e8106 = (((_e8097 * _e8097) + (_e8099 * _e8099)) + (_e8101 * _e8101));
                                                if (_e8106 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8106 > 0f) {
                                                        phi_5336_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5336_ = 0f;
                                                    }
                                                    let _e8159 = phi_5336_;
                                                    phi_5400_ = _e8159;
                                                } else {
                                                    phi_5343_ = type_14(0i, 5i);
                                                    phi_5346_ = bitcast<f32>(((bitcast<u32>(_e8106) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8114 = phi_5343_;
                                                        let _e8116 = phi_5346_;
                                                        local_44 = _e8116;
                                                        if (_e8114.member < _e8114.member_1) {
                                                            let _e8123 = (_e8114.member + 1i);
                                                            if ((false == (_e8123 > _e8114.member)) != false) {
                                                                phi_5367_ = true;
                                                            } else {
                                                                phi_5367_ = false;
                                                            }
                                                            let _e8128 = phi_5367_;
                                                            if _e8128 {
                                                                phi_5373_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5373_ = type_15(1u, _e8123);
                                                            }
                                                            let _e8133 = phi_5373_;
                                                            phi_5344_ = type_14(_e8133.member_1, _e8114.member_1);
                                                            phi_5387_ = type_15(1u, _e8114.member);
                                                        } else {
                                                            phi_5344_ = _e8114;
                                                            phi_5387_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8139 = phi_5344_;
                                                        let _e8141 = phi_5387_;
                                                        let _e8144 = (bitcast<i32>(_e8141.member) != 0i);
                                                        if _e8144 {
                                                            phi_5347_ = (0.5f * (_e8116 + (_e8106 / _e8116)));
                                                        } else {
                                                            phi_5347_ = f32();
                                                        }
                                                        let _e8149 = phi_5347_;
                                                        continue;
                                                        continuing {
                                                            phi_5343_ = _e8139;
                                                            phi_5346_ = _e8149;
                                                            break if !(_e8144);
                                                        }
                                                    }
                                                    let _e8154 = local_44;
                                                    phi_5400_ = (_e8154 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8161 = phi_5400_;
                                                let _e8162 = (0.000000059604645f * 12f);
                                                let _e8164 = local_14.member_1;
                                                let _e8167 = local_14.member_2;
                                                let _e8171 = ((_e8164 * 1.01f) + ((_e8167 * _e8161) * (1f + _e8162)));
                                                let _e8175 = local_14.member[0u][0u];
                                                let _e8183 = (((_e8097 * _e8175[0]) + (_e8099 * _e8175[1])) + (_e8101 * _e8175[2]));
                                                let _e8187 = local_14.member[0u][1u];
                                                let _e8195 = (((_e8097 * _e8187[0]) + (_e8099 * _e8187[1])) + (_e8101 * _e8187[2]));
                                                let _e8199 = local_14.member[0u][2u];
                                                let _e8207 = (((_e8097 * _e8199[0]) + (_e8099 * _e8199[1])) + (_e8101 * _e8199[2]));
                                                let _e8211 = local_14.member[0u][3u];
                                                let _e8219 = (((_e8097 * _e8211[0]) + (_e8099 * _e8211[1])) + (_e8101 * _e8211[2]));
                                                let _e8223 = local_14.member[1u][0u];
                                                let _e8231 = (((_e8097 * _e8223[0]) + (_e8099 * _e8223[1])) + (_e8101 * _e8223[2]));
                                                let _e8235 = local_14.member[1u][1u];
                                                let _e8243 = (((_e8097 * _e8235[0]) + (_e8099 * _e8235[1])) + (_e8101 * _e8235[2]));
                                                let _e8247 = local_14.member[1u][2u];
                                                let _e8255 = (((_e8097 * _e8247[0]) + (_e8099 * _e8247[1])) + (_e8101 * _e8247[2]));
                                                let _e8259 = local_14.member[1u][3u];
                                                let _e8267 = (((_e8097 * _e8259[0]) + (_e8099 * _e8259[1])) + (_e8101 * _e8259[2]));
                                                if (_e8183 < 0f) {
                                                    phi_5534_ = -(_e8183);
                                                } else {
                                                    phi_5534_ = _e8183;
                                                }
                                                let _e8271 = phi_5534_;
                                                if (_e8231 < 0f) {
                                                    phi_5540_ = -(_e8231);
                                                } else {
                                                    phi_5540_ = _e8231;
                                                }
                                                let _e8275 = phi_5540_;
                                                if (_e8195 < 0f) {
                                                    phi_5549_ = -(_e8195);
                                                } else {
                                                    phi_5549_ = _e8195;
                                                }
                                                let _e8282 = phi_5549_;
                                                if (_e8243 < 0f) {
                                                    phi_5555_ = -(_e8243);
                                                } else {
                                                    phi_5555_ = _e8243;
                                                }
                                                let _e8286 = phi_5555_;
                                                if (_e8207 < 0f) {
                                                    phi_5564_ = -(_e8207);
                                                } else {
                                                    phi_5564_ = _e8207;
                                                }
                                                let _e8293 = phi_5564_;
                                                if (_e8255 < 0f) {
                                                    phi_5570_ = -(_e8255);
                                                } else {
                                                    phi_5570_ = _e8255;
                                                }
                                                let _e8297 = phi_5570_;
                                                if (_e8219 < 0f) {
                                                    phi_5579_ = -(_e8219);
                                                } else {
                                                    phi_5579_ = _e8219;
                                                }
                                                let _e8304 = phi_5579_;
                                                if (_e8267 < 0f) {
                                                    phi_5585_ = -(_e8267);
                                                } else {
                                                    phi_5585_ = _e8267;
                                                }
                                                let _e8308 = phi_5585_;
                                                local_15 = type_32(array<f32, 4>(_e8183, _e8195, _e8207, _e8219), array<f32, 4>(_e8231, _e8243, _e8255, _e8267), array<f32, 4>((_e8171 + ((_e8271 + _e8275) * _e8162)), (_e8171 + ((_e8282 + _e8286) * _e8162)), (_e8171 + ((_e8293 + _e8297) * _e8162)), (_e8171 + ((_e8304 + _e8308) * _e8162))));
                                                let _e8320 = (((_e8097 * _e8097) + (_e8099 * _e8099)) + (_e8101 * _e8101));
                                                if (_e8320 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8320 > 0f) {
                                                        phi_5628_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5628_ = 0f;
                                                    }
                                                    let _e8373 = phi_5628_;
                                                    phi_5692_ = _e8373;
                                                } else {
                                                    phi_5635_ = type_14(0i, 5i);
                                                    phi_5638_ = bitcast<f32>(((bitcast<u32>(_e8320) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8328 = phi_5635_;
                                                        let _e8330 = phi_5638_;
                                                        local_45 = _e8330;
                                                        if (_e8328.member < _e8328.member_1) {
                                                            let _e8337 = (_e8328.member + 1i);
                                                            if ((false == (_e8337 > _e8328.member)) != false) {
                                                                phi_5659_ = true;
                                                            } else {
                                                                phi_5659_ = false;
                                                            }
                                                            let _e8342 = phi_5659_;
                                                            if _e8342 {
                                                                phi_5665_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5665_ = type_15(1u, _e8337);
                                                            }
                                                            let _e8347 = phi_5665_;
                                                            phi_5636_ = type_14(_e8347.member_1, _e8328.member_1);
                                                            phi_5679_ = type_15(1u, _e8328.member);
                                                        } else {
                                                            phi_5636_ = _e8328;
                                                            phi_5679_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8353 = phi_5636_;
                                                        let _e8355 = phi_5679_;
                                                        let _e8358 = (bitcast<i32>(_e8355.member) != 0i);
                                                        if _e8358 {
                                                            phi_5639_ = (0.5f * (_e8330 + (_e8320 / _e8330)));
                                                        } else {
                                                            phi_5639_ = f32();
                                                        }
                                                        let _e8363 = phi_5639_;
                                                        continue;
                                                        continuing {
                                                            phi_5635_ = _e8353;
                                                            phi_5638_ = _e8363;
                                                            break if !(_e8358);
                                                        }
                                                    }
                                                    let _e8368 = local_45;
                                                    phi_5692_ = (_e8368 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8375 = phi_5692_;
                                                let _e8386 = (((_e7835[0] * _e7835[0]) + (_e7835[1] * _e7835[1])) + (_e7835[2] * _e7835[2]));
                                                if (_e8386 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8386 > 0f) {
                                                        phi_5717_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5717_ = 0f;
                                                    }
                                                    let _e8439 = phi_5717_;
                                                    phi_5781_ = _e8439;
                                                } else {
                                                    phi_5724_ = type_14(0i, 5i);
                                                    phi_5727_ = bitcast<f32>(((bitcast<u32>(_e8386) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8394 = phi_5724_;
                                                        let _e8396 = phi_5727_;
                                                        local_46 = _e8396;
                                                        if (_e8394.member < _e8394.member_1) {
                                                            let _e8403 = (_e8394.member + 1i);
                                                            if ((false == (_e8403 > _e8394.member)) != false) {
                                                                phi_5748_ = true;
                                                            } else {
                                                                phi_5748_ = false;
                                                            }
                                                            let _e8408 = phi_5748_;
                                                            if _e8408 {
                                                                phi_5754_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5754_ = type_15(1u, _e8403);
                                                            }
                                                            let _e8413 = phi_5754_;
                                                            phi_5725_ = type_14(_e8413.member_1, _e8394.member_1);
                                                            phi_5768_ = type_15(1u, _e8394.member);
                                                        } else {
                                                            phi_5725_ = _e8394;
                                                            phi_5768_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8419 = phi_5725_;
                                                        let _e8421 = phi_5768_;
                                                        let _e8424 = (bitcast<i32>(_e8421.member) != 0i);
                                                        if _e8424 {
                                                            phi_5728_ = (0.5f * (_e8396 + (_e8386 / _e8396)));
                                                        } else {
                                                            phi_5728_ = f32();
                                                        }
                                                        let _e8429 = phi_5728_;
                                                        continue;
                                                        continuing {
                                                            phi_5724_ = _e8419;
                                                            phi_5727_ = _e8429;
                                                            break if !(_e8424);
                                                        }
                                                    }
                                                    let _e8434 = local_46;
                                                    phi_5781_ = (_e8434 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8441 = phi_5781_;
                                                let _e8447 = local_18.member[0u];
                                                if (_e8447[0] < 0f) {
                                                    phi_5797_ = -(_e8447[0]);
                                                } else {
                                                    phi_5797_ = _e8447[0];
                                                }
                                                let _e8454 = phi_5797_;
                                                if (_e8447[1] < 0f) {
                                                    phi_5804_ = -(_e8447[1]);
                                                } else {
                                                    phi_5804_ = _e8447[1];
                                                }
                                                let _e8458 = phi_5804_;
                                                if (_e8454 > _e8458) {
                                                    phi_5809_ = _e8454;
                                                } else {
                                                    phi_5809_ = _e8458;
                                                }
                                                let _e8461 = phi_5809_;
                                                if (_e8447[2] < 0f) {
                                                    phi_5816_ = -(_e8447[2]);
                                                } else {
                                                    phi_5816_ = _e8447[2];
                                                }
                                                let _e8465 = phi_5816_;
                                                if (_e8461 > _e8465) {
                                                    phi_5821_ = _e8461;
                                                } else {
                                                    phi_5821_ = _e8465;
                                                }
                                                let _e8468 = phi_5821_;
                                                let _e8471 = local_18.member[1u];
                                                if (_e8471[0] < 0f) {
                                                    phi_5834_ = -(_e8471[0]);
                                                } else {
                                                    phi_5834_ = _e8471[0];
                                                }
                                                let _e8478 = phi_5834_;
                                                if (_e8471[1] < 0f) {
                                                    phi_5841_ = -(_e8471[1]);
                                                } else {
                                                    phi_5841_ = _e8471[1];
                                                }
                                                let _e8482 = phi_5841_;
                                                if (_e8478 > _e8482) {
                                                    phi_5846_ = _e8478;
                                                } else {
                                                    phi_5846_ = _e8482;
                                                }
                                                let _e8485 = phi_5846_;
                                                if (_e8471[2] < 0f) {
                                                    phi_5853_ = -(_e8471[2]);
                                                } else {
                                                    phi_5853_ = _e8471[2];
                                                }
                                                let _e8489 = phi_5853_;
                                                if (_e8485 > _e8489) {
                                                    phi_5858_ = _e8485;
                                                } else {
                                                    phi_5858_ = _e8489;
                                                }
                                                let _e8492 = phi_5858_;
                                                if (_e8468 > _e8492) {
                                                    phi_5863_ = _e8468;
                                                } else {
                                                    phi_5863_ = _e8492;
                                                }
                                                let _e8495 = phi_5863_;
                                                let _e8497 = local_18.member_3;
                                                let _e8501 = local_18.member_1[0u];
                                                if (_e8501[0] < 0f) {
                                                    phi_5880_ = -(_e8501[0]);
                                                } else {
                                                    phi_5880_ = _e8501[0];
                                                }
                                                let _e8508 = phi_5880_;
                                                if (_e8501[1] < 0f) {
                                                    phi_5887_ = -(_e8501[1]);
                                                } else {
                                                    phi_5887_ = _e8501[1];
                                                }
                                                let _e8512 = phi_5887_;
                                                if (_e8508 > _e8512) {
                                                    phi_5892_ = _e8508;
                                                } else {
                                                    phi_5892_ = _e8512;
                                                }
                                                let _e8515 = phi_5892_;
                                                if (_e8501[2] < 0f) {
                                                    phi_5899_ = -(_e8501[2]);
                                                } else {
                                                    phi_5899_ = _e8501[2];
                                                }
                                                let _e8519 = phi_5899_;
                                                if (_e8515 > _e8519) {
                                                    phi_5904_ = _e8515;
                                                } else {
                                                    phi_5904_ = _e8519;
                                                }
                                                let _e8522 = phi_5904_;
                                                let _e8525 = local_18.member_1[1u];
                                                if (_e8525[0] < 0f) {
                                                    phi_5918_ = -(_e8525[0]);
                                                } else {
                                                    phi_5918_ = _e8525[0];
                                                }
                                                let _e8532 = phi_5918_;
                                                if (_e8525[1] < 0f) {
                                                    phi_5925_ = -(_e8525[1]);
                                                } else {
                                                    phi_5925_ = _e8525[1];
                                                }
                                                let _e8536 = phi_5925_;
                                                if (_e8532 > _e8536) {
                                                    phi_5930_ = _e8532;
                                                } else {
                                                    phi_5930_ = _e8536;
                                                }
                                                let _e8539 = phi_5930_;
                                                if (_e8525[2] < 0f) {
                                                    phi_5937_ = -(_e8525[2]);
                                                } else {
                                                    phi_5937_ = _e8525[2];
                                                }
                                                let _e8543 = phi_5937_;
                                                if (_e8539 > _e8543) {
                                                    phi_5942_ = _e8539;
                                                } else {
                                                    phi_5942_ = _e8543;
                                                }
                                                let _e8546 = phi_5942_;
                                                if (_e8522 > _e8546) {
                                                    phi_5947_ = _e8522;
                                                } else {
                                                    phi_5947_ = _e8546;
                                                }
                                                let _e8549 = phi_5947_;
                                                let _e8551 = local_18.member_3;
                                                let _e8555 = local_18.member_2[0u];
                                                if (_e8555[0] < 0f) {
                                                    phi_5964_ = -(_e8555[0]);
                                                } else {
                                                    phi_5964_ = _e8555[0];
                                                }
                                                let _e8562 = phi_5964_;
                                                if (_e8555[1] < 0f) {
                                                    phi_5971_ = -(_e8555[1]);
                                                } else {
                                                    phi_5971_ = _e8555[1];
                                                }
                                                let _e8566 = phi_5971_;
                                                if (_e8562 > _e8566) {
                                                    phi_5976_ = _e8562;
                                                } else {
                                                    phi_5976_ = _e8566;
                                                }
                                                let _e8569 = phi_5976_;
                                                if (_e8555[2] < 0f) {
                                                    phi_5983_ = -(_e8555[2]);
                                                } else {
                                                    phi_5983_ = _e8555[2];
                                                }
                                                let _e8573 = phi_5983_;
                                                if (_e8569 > _e8573) {
                                                    phi_5988_ = _e8569;
                                                } else {
                                                    phi_5988_ = _e8573;
                                                }
                                                let _e8576 = phi_5988_;
                                                let _e8579 = local_18.member_2[1u];
                                                if (_e8579[0] < 0f) {
                                                    phi_6002_ = -(_e8579[0]);
                                                } else {
                                                    phi_6002_ = _e8579[0];
                                                }
                                                let _e8586 = phi_6002_;
                                                if (_e8579[1] < 0f) {
                                                    phi_6009_ = -(_e8579[1]);
                                                } else {
                                                    phi_6009_ = _e8579[1];
                                                }
                                                let _e8590 = phi_6009_;
                                                if (_e8586 > _e8590) {
                                                    phi_6014_ = _e8586;
                                                } else {
                                                    phi_6014_ = _e8590;
                                                }
                                                let _e8593 = phi_6014_;
                                                if (_e8579[2] < 0f) {
                                                    phi_6021_ = -(_e8579[2]);
                                                } else {
                                                    phi_6021_ = _e8579[2];
                                                }
                                                let _e8597 = phi_6021_;
                                                if (_e8593 > _e8597) {
                                                    phi_6026_ = _e8593;
                                                } else {
                                                    phi_6026_ = _e8597;
                                                }
                                                let _e8600 = phi_6026_;
                                                if (_e8576 > _e8600) {
                                                    phi_6031_ = _e8576;
                                                } else {
                                                    phi_6031_ = _e8600;
                                                }
                                                let _e8603 = phi_6031_;
                                                let _e8605 = local_18.member_3;
                                                let _e8612 = local_18.member_3;
                                                let _e8622 = ((((_e8441 * (1f + (0.000000059604645f * 8f))) + (((((((_e8495 + _e8497) + (_e8549 + _e8551)) + (_e8603 + _e8605)) * (0.000000059604645f * 16f)) + (_e8612 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8375) * (1f + (0.000000059604645f * 64f)));
                                                let _e8625 = local_15.member[0u];
                                                let _e8628 = local_15.member_1[0u];
                                                if (_e8625 < 0f) {
                                                    phi_6072_ = -(_e8625);
                                                } else {
                                                    phi_6072_ = _e8625;
                                                }
                                                let _e8633 = phi_6072_;
                                                if (_e8628 < 0f) {
                                                    phi_6078_ = -(_e8628);
                                                } else {
                                                    phi_6078_ = _e8628;
                                                }
                                                let _e8637 = phi_6078_;
                                                phi_6089_ = type_12(1u, 4u);
                                                phi_6092_ = ((_e8625 + ((_e8628 - _e8625) * _e5976)) - ((_e8090 * 1.01f) + ((_e8633 + _e8637) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8647 = phi_6089_;
                                                    let _e8649 = phi_6092_;
                                                    local_47 = _e8649;
                                                    local_48 = _e8649;
                                                    if (_e8647.member < _e8647.member_1) {
                                                        phi_6090_ = type_12((_e8647.member + 1u), _e8647.member_1);
                                                        phi_6115_ = type_12(1u, _e8647.member);
                                                    } else {
                                                        phi_6090_ = _e8647;
                                                        phi_6115_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8661 = phi_6090_;
                                                    let _e8663 = phi_6115_;
                                                    let _e8667 = (bitcast<i32>(_e8663.member) != 0i);
                                                    if _e8667 {
                                                        let _e8670 = local_15.member[_e8663.member_1];
                                                        let _e8673 = local_15.member_1[_e8663.member_1];
                                                        if (_e8670 < 0f) {
                                                            phi_6144_ = -(_e8670);
                                                        } else {
                                                            phi_6144_ = _e8670;
                                                        }
                                                        let _e8678 = phi_6144_;
                                                        if (_e8673 < 0f) {
                                                            phi_6150_ = -(_e8673);
                                                        } else {
                                                            phi_6150_ = _e8673;
                                                        }
                                                        let _e8682 = phi_6150_;
                                                        let _e8690 = ((_e8670 + ((_e8673 - _e8670) * _e5976)) - ((_e8090 * 1.01f) + ((_e8678 + _e8682) * (0.000000059604645f * 12f))));
                                                        if (_e8649 < _e8690) {
                                                            phi_6163_ = _e8649;
                                                        } else {
                                                            phi_6163_ = _e8690;
                                                        }
                                                        let _e8693 = phi_6163_;
                                                        phi_6093_ = _e8693;
                                                    } else {
                                                        phi_6093_ = f32();
                                                    }
                                                    let _e8695 = phi_6093_;
                                                    continue;
                                                    continuing {
                                                        phi_6089_ = _e8661;
                                                        phi_6092_ = _e8695;
                                                        break if !(_e8667);
                                                    }
                                                }
                                                let _e8698 = local_47;
                                                if (_e8698 > 0f) {
                                                    let _e8702 = local_48;
                                                    let _e8705 = (((_e8622 - _e8702) / _e8622) * 2.02f);
                                                    if (_e8705 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8705 > 0f) {
                                                            phi_6184_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6184_ = 0f;
                                                        }
                                                        let _e8758 = phi_6184_;
                                                        phi_6248_ = _e8758;
                                                    } else {
                                                        phi_6191_ = type_14(0i, 5i);
                                                        phi_6194_ = bitcast<f32>(((bitcast<u32>(_e8705) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8713 = phi_6191_;
                                                            let _e8715 = phi_6194_;
                                                            local_49 = _e8715;
                                                            if (_e8713.member < _e8713.member_1) {
                                                                let _e8722 = (_e8713.member + 1i);
                                                                if ((false == (_e8722 > _e8713.member)) != false) {
                                                                    phi_6215_ = true;
                                                                } else {
                                                                    phi_6215_ = false;
                                                                }
                                                                let _e8727 = phi_6215_;
                                                                if _e8727 {
                                                                    phi_6221_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6221_ = type_15(1u, _e8722);
                                                                }
                                                                let _e8732 = phi_6221_;
                                                                phi_6192_ = type_14(_e8732.member_1, _e8713.member_1);
                                                                phi_6235_ = type_15(1u, _e8713.member);
                                                            } else {
                                                                phi_6192_ = _e8713;
                                                                phi_6235_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8738 = phi_6192_;
                                                            let _e8740 = phi_6235_;
                                                            let _e8743 = (bitcast<i32>(_e8740.member) != 0i);
                                                            if _e8743 {
                                                                phi_6195_ = (0.5f * (_e8715 + (_e8705 / _e8715)));
                                                            } else {
                                                                phi_6195_ = f32();
                                                            }
                                                            let _e8748 = phi_6195_;
                                                            continue;
                                                            continuing {
                                                                phi_6191_ = _e8738;
                                                                phi_6194_ = _e8748;
                                                                break if !(_e8743);
                                                            }
                                                        }
                                                        let _e8753 = local_49;
                                                        phi_6248_ = (_e8753 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8760 = phi_6248_;
                                                    let _e8762 = ((_e8760 * _e8375) * 1.01f);
                                                    phi_6253_ = type_12(0u, 4u);
                                                    phi_6256_ = 2f;
                                                    phi_6258_ = true;
                                                    phi_6260_ = true;
                                                    loop {
                                                        let _e8764 = phi_6253_;
                                                        let _e8766 = phi_6256_;
                                                        let _e8768 = phi_6258_;
                                                        let _e8770 = phi_6260_;
                                                        local_50 = _e8766;
                                                        local_87 = _e8766;
                                                        local_51 = _e8768;
                                                        local_52 = _e8770;
                                                        local_88 = _e8770;
                                                        local_53 = _e8770;
                                                        if (_e8764.member < _e8764.member_1) {
                                                            phi_6254_ = type_12((_e8764.member + 1u), _e8764.member_1);
                                                            phi_6283_ = type_12(1u, _e8764.member);
                                                        } else {
                                                            phi_6254_ = _e8764;
                                                            phi_6283_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8782 = phi_6254_;
                                                        let _e8784 = phi_6283_;
                                                        let _e8788 = (bitcast<i32>(_e8784.member) != 0i);
                                                        if _e8788 {
                                                            let _e8792 = local_14.member[0u][_e8784.member_1];
                                                            let _e8799 = local_14.member[1u][_e8784.member_1];
                                                            if (_e8792[0] < 0f) {
                                                                phi_6320_ = -(_e8792[0]);
                                                            } else {
                                                                phi_6320_ = _e8792[0];
                                                            }
                                                            let _e8806 = phi_6320_;
                                                            if (_e8792[1] < 0f) {
                                                                phi_6327_ = -(_e8792[1]);
                                                            } else {
                                                                phi_6327_ = _e8792[1];
                                                            }
                                                            let _e8810 = phi_6327_;
                                                            if (_e8792[2] < 0f) {
                                                                phi_6335_ = -(_e8792[2]);
                                                            } else {
                                                                phi_6335_ = _e8792[2];
                                                            }
                                                            let _e8815 = phi_6335_;
                                                            let _e8816 = ((_e8806 + _e8810) + _e8815);
                                                            if (_e8799[0] < 0f) {
                                                                phi_6343_ = -(_e8799[0]);
                                                            } else {
                                                                phi_6343_ = _e8799[0];
                                                            }
                                                            let _e8820 = phi_6343_;
                                                            if (_e8799[1] < 0f) {
                                                                phi_6350_ = -(_e8799[1]);
                                                            } else {
                                                                phi_6350_ = _e8799[1];
                                                            }
                                                            let _e8824 = phi_6350_;
                                                            if (_e8799[2] < 0f) {
                                                                phi_6358_ = -(_e8799[2]);
                                                            } else {
                                                                phi_6358_ = _e8799[2];
                                                            }
                                                            let _e8829 = phi_6358_;
                                                            let _e8830 = ((_e8820 + _e8824) + _e8829);
                                                            if (_e8816 > _e8830) {
                                                                phi_6364_ = _e8816;
                                                            } else {
                                                                phi_6364_ = _e8830;
                                                            }
                                                            let _e8833 = phi_6364_;
                                                            let _e8837 = (_e8799[0] - _e8792[0]);
                                                            let _e8838 = (_e8799[1] - _e8792[1]);
                                                            let _e8839 = (_e8799[2] - _e8792[2]);
                                                            if (_e8837 < 0f) {
                                                                phi_6382_ = -(_e8837);
                                                            } else {
                                                                phi_6382_ = _e8837;
                                                            }
                                                            let _e8843 = phi_6382_;
                                                            if (_e8838 < 0f) {
                                                                phi_6388_ = -(_e8838);
                                                            } else {
                                                                phi_6388_ = _e8838;
                                                            }
                                                            let _e8847 = phi_6388_;
                                                            if (_e8839 < 0f) {
                                                                phi_6395_ = -(_e8839);
                                                            } else {
                                                                phi_6395_ = _e8839;
                                                            }
                                                            let _e8852 = phi_6395_;
                                                            let _e8859 = local_15.member[_e8784.member_1];
                                                            let _e8862 = local_15.member_1[_e8784.member_1];
                                                            if (_e8859 < 0f) {
                                                                phi_6421_ = -(_e8859);
                                                            } else {
                                                                phi_6421_ = _e8859;
                                                            }
                                                            let _e8867 = phi_6421_;
                                                            if (_e8862 < 0f) {
                                                                phi_6427_ = -(_e8862);
                                                            } else {
                                                                phi_6427_ = _e8862;
                                                            }
                                                            let _e8871 = phi_6427_;
                                                            let _e8875 = ((_e8090 * 1.01f) + ((_e8867 + _e8871) * (0.000000059604645f * 12f)));
                                                            let _e8882 = local_15.member_1[_e8784.member_1];
                                                            let _e8885 = local_15.member[_e8784.member_1];
                                                            let _e8886 = (_e8882 - _e8885);
                                                            let _e8889 = ((_e8875 + _e8875) + (_e8762 * ((((_e8843 + _e8847) + _e8852) + (_e8090 * 6f)) * 1.01f)));
                                                            let _e8892 = ((((_e8859 + ((_e8862 - _e8859) * _e5976)) - _e8875) - (_e8762 * ((_e8833 + (_e8090 * 3f)) * 1.01f))) - _e8622);
                                                            let _e8893 = (_e8892 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8894 = (_e8886 > _e8889);
                                                            if _e8894 {
                                                                phi_6463_ = true;
                                                            } else {
                                                                phi_6463_ = _e8893;
                                                            }
                                                            let _e8896 = phi_6463_;
                                                            if (_e8886 < -(_e8889)) {
                                                                phi_6470_ = true;
                                                            } else {
                                                                phi_6470_ = _e8893;
                                                            }
                                                            let _e8901 = phi_6470_;
                                                            if _e8894 {
                                                                phi_6491_ = _e8766;
                                                            } else {
                                                                if _e8893 {
                                                                    let _e8903 = (_e8889 - _e8886);
                                                                    if (_e8903 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_6483_ = _e8903;
                                                                    } else {
                                                                        phi_6483_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8906 = phi_6483_;
                                                                    let _e8907 = (_e8892 / _e8906);
                                                                    if (_e8766 < _e8907) {
                                                                        phi_6489_ = _e8766;
                                                                    } else {
                                                                        phi_6489_ = _e8907;
                                                                    }
                                                                    let _e8910 = phi_6489_;
                                                                    phi_6490_ = _e8910;
                                                                } else {
                                                                    phi_6490_ = _e8766;
                                                                }
                                                                let _e8912 = phi_6490_;
                                                                phi_6491_ = _e8912;
                                                            }
                                                            let _e8914 = phi_6491_;
                                                            phi_6257_ = _e8914;
                                                            phi_6259_ = (_e8768 && _e8901);
                                                            phi_6261_ = (_e8770 && _e8896);
                                                        } else {
                                                            phi_6257_ = f32();
                                                            phi_6259_ = bool();
                                                            phi_6261_ = bool();
                                                        }
                                                        let _e8916 = phi_6257_;
                                                        let _e8918 = phi_6259_;
                                                        let _e8920 = phi_6261_;
                                                        continue;
                                                        continuing {
                                                            phi_6253_ = _e8782;
                                                            phi_6256_ = _e8916;
                                                            phi_6258_ = _e8918;
                                                            phi_6260_ = _e8920;
                                                            break if !(_e8788);
                                                        }
                                                    }
                                                    let _e8923 = local_50;
                                                    if (_e8923 < 2f) {
                                                        let _e11340 = local_87;
                                                        phi_6496_ = _e11340;
                                                    } else {
                                                        phi_6496_ = 2f;
                                                    }
                                                    let _e8926 = phi_6496_;
                                                    let _e8927 = (_e8926 * 0.999f);
                                                    let _e8929 = local_51;
                                                    if _e8929 {
                                                        let _e8931 = local_52;
                                                        if _e8931 {
                                                            phi_6505_ = type_40();
                                                        } else {
                                                            phi_6505_ = type_40(1u, _e5976, 2f);
                                                        }
                                                        let _e8934 = phi_6505_;
                                                        phi_6506_ = _e8934;
                                                        let _e11347 = local_88;
                                                        phi_6507_ = _e11347;
                                                    } else {
                                                        phi_6506_ = type_40();
                                                        phi_6507_ = true;
                                                    }
                                                    let _e8936 = phi_6506_;
                                                    let _e8938 = phi_6507_;
                                                    if _e8938 {
                                                        let _e8940 = local_53;
                                                        if _e8940 {
                                                            if (_e8927 > (0.000000059604645f * 4096f)) {
                                                                let _e8944 = (_e5976 + _e8927);
                                                                if (_e8944 < _e328) {
                                                                    phi_6524_ = _e8944;
                                                                } else {
                                                                    phi_6524_ = _e328;
                                                                }
                                                                let _e8947 = phi_6524_;
                                                                phi_6525_ = _e8947;
                                                            } else {
                                                                phi_6525_ = _e5976;
                                                            }
                                                            let _e8949 = phi_6525_;
                                                            phi_6528_ = type_12(0u, 4u);
                                                            phi_6531_ = _e8949;
                                                            phi_6533_ = _e5976;
                                                            loop {
                                                                let _e8951 = phi_6528_;
                                                                let _e8953 = phi_6531_;
                                                                let _e8955 = phi_6533_;
                                                                local_54 = _e8953;
                                                                local_55 = _e8955;
                                                                local_56 = _e8955;
                                                                if (_e8951.member < _e8951.member_1) {
                                                                    phi_6529_ = type_12((_e8951.member + 1u), _e8951.member_1);
                                                                    phi_6556_ = type_12(1u, _e8951.member);
                                                                } else {
                                                                    phi_6529_ = _e8951;
                                                                    phi_6556_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8967 = phi_6529_;
                                                                let _e8969 = phi_6556_;
                                                                let _e8973 = (bitcast<i32>(_e8969.member) != 0i);
                                                                if _e8973 {
                                                                    let _e8976 = local_15.member[_e8969.member_1];
                                                                    let _e8979 = local_15.member_1[_e8969.member_1];
                                                                    let _e8982 = local_15.member[_e8969.member_1];
                                                                    let _e8988 = local_15.member_2[_e8969.member_1];
                                                                    let _e8989 = ((_e8976 + ((_e8979 - _e8982) * _e5976)) - _e8988);
                                                                    let _e8992 = local_15.member_1[_e8969.member_1];
                                                                    let _e8995 = local_15.member[_e8969.member_1];
                                                                    let _e8996 = (_e8992 - _e8995);
                                                                    if (_e8996 > 0f) {
                                                                        let _e9010 = (_e5976 - (_e8989 / _e8996));
                                                                        if (_e8955 > _e9010) {
                                                                            phi_6624_ = _e8955;
                                                                        } else {
                                                                            phi_6624_ = _e9010;
                                                                        }
                                                                        let _e9013 = phi_6624_;
                                                                        phi_6642_ = _e8953;
                                                                        phi_6643_ = _e9013;
                                                                    } else {
                                                                        if (_e8989 > 0f) {
                                                                            if (_e8996 < 0f) {
                                                                                let _e9001 = (_e5976 - (_e8989 / _e8996));
                                                                                if (_e8953 < _e9001) {
                                                                                    phi_6639_ = _e8953;
                                                                                } else {
                                                                                    phi_6639_ = _e9001;
                                                                                }
                                                                                let _e9004 = phi_6639_;
                                                                                phi_6640_ = _e9004;
                                                                            } else {
                                                                                phi_6640_ = _e8953;
                                                                            }
                                                                            let _e9006 = phi_6640_;
                                                                            phi_6641_ = _e9006;
                                                                        } else {
                                                                            phi_6641_ = _e8953;
                                                                        }
                                                                        let _e9008 = phi_6641_;
                                                                        phi_6642_ = _e9008;
                                                                        phi_6643_ = _e8955;
                                                                    }
                                                                    let _e9015 = phi_6642_;
                                                                    let _e9017 = phi_6643_;
                                                                    phi_6532_ = _e9015;
                                                                    phi_6534_ = _e9017;
                                                                } else {
                                                                    phi_6532_ = f32();
                                                                    phi_6534_ = f32();
                                                                }
                                                                let _e9019 = phi_6532_;
                                                                let _e9021 = phi_6534_;
                                                                continue;
                                                                continuing {
                                                                    phi_6528_ = _e8967;
                                                                    phi_6531_ = _e9019;
                                                                    phi_6533_ = _e9021;
                                                                    break if !(_e8973);
                                                                }
                                                            }
                                                            let _e9024 = local_54;
                                                            let _e9026 = local_55;
                                                            let _e9030 = local_56;
                                                            let _e9031 = (_e9030 + ((_e9024 - _e9026) * 0.5f));
                                                            if (_e9031 > _e5976) {
                                                                if (_e9031 <= _e8949) {
                                                                    let _e9036 = local_15.member[0u];
                                                                    let _e9039 = local_15.member_1[0u];
                                                                    let _e9042 = local_15.member[0u];
                                                                    let _e9048 = local_15.member_2[0u];
                                                                    if (((_e9036 + ((_e9039 - _e9042) * _e9031)) - _e9048) > 0f) {
                                                                        let _e9053 = local_15.member[1u];
                                                                        let _e9056 = local_15.member_1[1u];
                                                                        let _e9059 = local_15.member[1u];
                                                                        let _e9065 = local_15.member_2[1u];
                                                                        if (((_e9053 + ((_e9056 - _e9059) * _e9031)) - _e9065) > 0f) {
                                                                            let _e9070 = local_15.member[2u];
                                                                            let _e9073 = local_15.member_1[2u];
                                                                            let _e9076 = local_15.member[2u];
                                                                            let _e9082 = local_15.member_2[2u];
                                                                            if (((_e9070 + ((_e9073 - _e9076) * _e9031)) - _e9082) > 0f) {
                                                                                let _e9087 = local_15.member[3u];
                                                                                let _e9090 = local_15.member_1[3u];
                                                                                let _e9093 = local_15.member[3u];
                                                                                let _e9099 = local_15.member_2[3u];
                                                                                phi_6804_ = (((_e9087 + ((_e9090 - _e9093) * _e9031)) - _e9099) > 0f);
                                                                                phi_6805_ = false;
                                                                            } else {
                                                                                phi_6804_ = bool();
                                                                                phi_6805_ = true;
                                                                            }
                                                                            let _e9103 = phi_6804_;
                                                                            let _e9105 = phi_6805_;
                                                                            phi_6806_ = _e9103;
                                                                            phi_6807_ = _e9105;
                                                                        } else {
                                                                            phi_6806_ = bool();
                                                                            phi_6807_ = true;
                                                                        }
                                                                        let _e9107 = phi_6806_;
                                                                        let _e9109 = phi_6807_;
                                                                        phi_6808_ = _e9107;
                                                                        phi_6809_ = _e9109;
                                                                    } else {
                                                                        phi_6808_ = bool();
                                                                        phi_6809_ = true;
                                                                    }
                                                                    let _e9111 = phi_6808_;
                                                                    let _e9113 = phi_6809_;
                                                                    if _e9113 {
                                                                        phi_6813_ = false;
                                                                    } else {
                                                                        phi_6813_ = _e9111;
                                                                    }
                                                                    let _e9115 = phi_6813_;
                                                                    if _e9115 {
                                                                        phi_6817_ = false;
                                                                    } else {
                                                                        phi_6817_ = true;
                                                                    }
                                                                    let _e9117 = phi_6817_;
                                                                    phi_6818_ = _e9117;
                                                                } else {
                                                                    phi_6818_ = true;
                                                                }
                                                                let _e9119 = phi_6818_;
                                                                phi_6819_ = _e9119;
                                                            } else {
                                                                phi_6819_ = true;
                                                            }
                                                            let _e9121 = phi_6819_;
                                                            if _e9121 {
                                                                phi_6823_ = 2f;
                                                            } else {
                                                                phi_6823_ = _e9031;
                                                            }
                                                            let _e9123 = phi_6823_;
                                                            phi_6826_ = type_40(2u, _e8949, _e9123);
                                                            phi_6827_ = type_40();
                                                            phi_6828_ = false;
                                                        } else {
                                                            phi_6826_ = type_40();
                                                            phi_6827_ = type_40(0u, _e5976, 2f);
                                                            phi_6828_ = true;
                                                        }
                                                        let _e9126 = phi_6826_;
                                                        let _e9128 = phi_6827_;
                                                        let _e9130 = phi_6828_;
                                                        phi_6829_ = _e9126;
                                                        phi_6830_ = _e9128;
                                                        phi_6831_ = _e9130;
                                                    } else {
                                                        phi_6829_ = type_40();
                                                        phi_6830_ = _e8936;
                                                        phi_6831_ = true;
                                                    }
                                                    let _e9132 = phi_6829_;
                                                    let _e9134 = phi_6830_;
                                                    let _e9136 = phi_6831_;
                                                    phi_6836_ = _e9134;
                                                    phi_6837_ = _e9132;
                                                    phi_6838_ = _e9136;
                                                } else {
                                                    phi_6836_ = type_40(0u, _e5976, 2f);
                                                    phi_6837_ = type_40();
                                                    phi_6838_ = true;
                                                }
                                                let _e9138 = phi_6836_;
                                                let _e9140 = phi_6837_;
                                                let _e9142 = phi_6838_;
                                                phi_6842_ = _e9138;
                                                phi_6843_ = _e9140;
                                                phi_6844_ = false;
                                                phi_6845_ = _e9142;
                                            } else {
                                                phi_6842_ = type_40();
                                                phi_6843_ = type_40();
                                                phi_6844_ = true;
                                                phi_6845_ = false;
                                            }
                                            let _e9144 = phi_6842_;
                                            let _e9146 = phi_6843_;
                                            let _e9148 = phi_6844_;
                                            let _e9150 = phi_6845_;
                                            phi_6846_ = _e9144;
                                            phi_6847_ = _e9146;
                                            phi_6848_ = _e9148;
                                            phi_6849_ = _e9150;
                                        } else {
                                            phi_6846_ = type_40();
                                            phi_6847_ = type_40();
                                            phi_6848_ = true;
                                            phi_6849_ = false;
                                        }
                                        let _e9152 = phi_6846_;
                                        let _e9154 = phi_6847_;
                                        let _e9156 = phi_6848_;
                                        let _e9158 = phi_6849_;
                                        if _e9156 {
                                            phi_6854_ = type_40(0u, _e5976, 2f);
                                            phi_6855_ = true;
                                        } else {
                                            phi_6854_ = _e9152;
                                            phi_6855_ = _e9158;
                                        }
                                        let _e9161 = phi_6854_;
                                        let _e9163 = phi_6855_;
                                        if _e9163 {
                                            phi_6859_ = _e9161;
                                        } else {
                                            phi_6859_ = _e9154;
                                        }
                                        let _e9165 = phi_6859_;
                                        if _e334 {
                                            if (_e9165.member == 2u) {
                                                let _e9169 = (_e9165.member_2 <= _e328);
                                                if _e9169 {
                                                    phi_6875_ = _e9165.member_2;
                                                    phi_6876_ = _e9165.member_2;
                                                    phi_6877_ = false;
                                                } else {
                                                    phi_6875_ = f32();
                                                    phi_6876_ = f32();
                                                    phi_6877_ = true;
                                                }
                                                let _e9173 = phi_6875_;
                                                let _e9175 = phi_6876_;
                                                let _e9177 = phi_6877_;
                                                phi_6878_ = _e9173;
                                                phi_6879_ = _e9175;
                                                phi_6880_ = _e9169;
                                                phi_6881_ = _e9177;
                                                phi_6882_ = false;
                                            } else {
                                                phi_6878_ = f32();
                                                phi_6879_ = f32();
                                                phi_6880_ = false;
                                                phi_6881_ = false;
                                                phi_6882_ = true;
                                            }
                                            let _e9179 = phi_6878_;
                                            let _e9181 = phi_6879_;
                                            let _e9183 = phi_6880_;
                                            let _e9185 = phi_6881_;
                                            let _e9187 = phi_6882_;
                                            phi_6883_ = _e9179;
                                            phi_6884_ = _e9181;
                                            phi_6885_ = _e9183;
                                            phi_6886_ = _e9185;
                                            phi_6887_ = _e9187;
                                        } else {
                                            phi_6883_ = f32();
                                            phi_6884_ = f32();
                                            phi_6885_ = false;
                                            phi_6886_ = false;
                                            phi_6887_ = true;
                                        }
                                        let _e9189 = phi_6883_;
                                        let _e9191 = phi_6884_;
                                        let _e9193 = phi_6885_;
                                        let _e9195 = phi_6886_;
                                        let _e9197 = phi_6887_;
                                        phi_6888_ = _e9189;
                                        phi_6889_ = _e9165.member;
                                        phi_6890_ = _e9191;
                                        phi_6891_ = _e9165;
                                        phi_6892_ = _e9165.member;
                                        phi_6893_ = _e9165.member;
                                        phi_6894_ = _e9193;
                                        phi_6895_ = _e9195;
                                        phi_6896_ = _e9197;
                                    }
                                    let _e9199 = phi_6888_;
                                    let _e9201 = phi_6889_;
                                    let _e9203 = phi_6890_;
                                    let _e9205 = phi_6891_;
                                    let _e9207 = phi_6892_;
                                    let _e9209 = phi_6893_;
                                    let _e9211 = phi_6894_;
                                    let _e9213 = phi_6895_;
                                    let _e9215 = phi_6896_;
                                    phi_6897_ = _e9199;
                                    phi_6898_ = _e9201;
                                    phi_6899_ = _e9203;
                                    phi_6900_ = _e9205;
                                    phi_6901_ = _e9207;
                                    phi_6902_ = _e9209;
                                    phi_6903_ = _e9211;
                                    phi_6904_ = _e7768;
                                    phi_6905_ = _e9213;
                                    phi_6906_ = _e9215;
                                    phi_6907_ = false;
                                } else {
                                    phi_6897_ = f32();
                                    phi_6898_ = u32();
                                    phi_6899_ = f32();
                                    phi_6900_ = type_40();
                                    phi_6901_ = u32();
                                    phi_6902_ = u32();
                                    phi_6903_ = false;
                                    phi_6904_ = false;
                                    phi_6905_ = false;
                                    phi_6906_ = false;
                                    phi_6907_ = true;
                                }
                                let _e9217 = phi_6897_;
                                let _e9219 = phi_6898_;
                                let _e9221 = phi_6899_;
                                let _e9223 = phi_6900_;
                                let _e9225 = phi_6901_;
                                let _e9227 = phi_6902_;
                                let _e9229 = phi_6903_;
                                let _e9231 = phi_6904_;
                                let _e9233 = phi_6905_;
                                let _e9235 = phi_6906_;
                                let _e9237 = phi_6907_;
                                phi_6908_ = _e7765;
                                phi_1983_ = _e9217;
                                phi_1985_ = _e9219;
                                phi_1987_ = _e9221;
                                phi_6909_ = _e9223;
                                phi_6910_ = _e9225;
                                phi_6911_ = _e7765;
                                phi_6912_ = _e9227;
                                phi_6913_ = _e9229;
                                phi_6914_ = _e9231;
                                phi_6915_ = _e9233;
                                phi_6916_ = _e9235;
                                phi_6917_ = false;
                                phi_6918_ = _e9237;
                            } else {
                                phi_6908_ = f32();
                                phi_1983_ = f32();
                                phi_1985_ = u32();
                                phi_1987_ = f32();
                                phi_6909_ = type_40();
                                phi_6910_ = u32();
                                phi_6911_ = f32();
                                phi_6912_ = u32();
                                phi_6913_ = false;
                                phi_6914_ = false;
                                phi_6915_ = false;
                                phi_6916_ = false;
                                phi_6917_ = true;
                                phi_6918_ = false;
                            }
                            let _e9239 = phi_6908_;
                            let _e9241 = phi_1983_;
                            let _e9243 = phi_1985_;
                            let _e9245 = phi_1987_;
                            let _e9247 = phi_6909_;
                            let _e9249 = phi_6910_;
                            let _e9251 = phi_6911_;
                            let _e9253 = phi_6912_;
                            let _e9255 = phi_6913_;
                            let _e9257 = phi_6914_;
                            let _e9259 = phi_6915_;
                            let _e9261 = phi_6916_;
                            let _e9263 = phi_6917_;
                            let _e9265 = phi_6918_;
                            local_57 = _e9257;
                            local_89 = _e9259;
                            local_90 = _e9261;
                            local_91 = _e9263;
                            local_92 = _e9265;
                            local_58 = _e9247;
                            local_59 = _e9247;
                            local_93 = _e9249;
                            local_60 = _e9247;
                            local_94 = _e9257;
                            local_95 = _e9253;
                            local_97 = _e9251;
                            local_98 = _e9239;
                            continue;
                            continuing {
                                phi_1979_ = _e5999;
                                phi_1982_ = _e9241;
                                phi_1984_ = _e9243;
                                phi_1986_ = _e9245;
                                break if !(_e9255);
                            }
                        }
                        let _e9268 = local_57;
                        if _e9268 {
                            phi_6922_ = false;
                            phi_6923_ = false;
                            phi_6924_ = false;
                            phi_6925_ = false;
                        } else {
                            let _e11448 = local_89;
                            phi_6922_ = _e11448;
                            let _e11451 = local_90;
                            phi_6923_ = _e11451;
                            let _e11454 = local_91;
                            phi_6924_ = _e11454;
                            let _e11457 = local_92;
                            phi_6925_ = _e11457;
                        }
                        let _e9270 = phi_6922_;
                        let _e9272 = phi_6923_;
                        let _e9274 = phi_6924_;
                        let _e9276 = phi_6925_;
                        if _e9270 {
                            let _e9278 = local_58;
                            if (_e9278.member_1 >= _e328) {
                                phi_6947_ = type_39(type_30(0u, f32()), 0u);
                            } else {
                                let _e9282 = local_59;
                                if (_e9282.member_1 > _e326) {
                                    phi_6942_ = 0u;
                                } else {
                                    let _e11462 = local_93;
                                    phi_6942_ = _e11462;
                                }
                                let _e9286 = phi_6942_;
                                let _e9288 = local_60;
                                phi_6947_ = type_39(type_30(2u, _e9288.member_1), _e9286);
                            }
                            let _e9295 = phi_6947_;
                            phi_6948_ = _e9295;
                            phi_6949_ = false;
                            phi_6950_ = false;
                            phi_6951_ = false;
                            phi_6952_ = false;
                        } else {
                            phi_6948_ = type_39();
                            phi_6949_ = _e9272;
                            let _e11469 = local_94;
                            phi_6950_ = _e11469;
                            phi_6951_ = _e9274;
                            phi_6952_ = _e9276;
                        }
                        let _e9297 = phi_6948_;
                        let _e9299 = phi_6949_;
                        let _e9301 = phi_6950_;
                        let _e9303 = phi_6951_;
                        let _e9305 = phi_6952_;
                        if _e9299 {
                            let _e11474 = local_95;
                            phi_6956_ = _e11474;
                            let _e11479 = local_97;
                            phi_6957_ = _e11479;
                            phi_6958_ = true;
                            phi_6959_ = false;
                            phi_6960_ = false;
                            phi_6961_ = false;
                        } else {
                            let _e11476 = local_96;
                            phi_6956_ = _e11476;
                            let _e11481 = local_98;
                            phi_6957_ = _e11481;
                            phi_6958_ = _e9301;
                            phi_6959_ = _e9303;
                            phi_6960_ = _e9305;
                            phi_6961_ = _e9270;
                        }
                        let _e9307 = phi_6956_;
                        let _e9309 = phi_6957_;
                        let _e9311 = phi_6958_;
                        let _e9313 = phi_6959_;
                        let _e9315 = phi_6960_;
                        let _e9317 = phi_6961_;
                        if _e9311 {
                            phi_6965_ = _e9309;
                            phi_6966_ = _e9307;
                            phi_6967_ = true;
                            phi_6968_ = false;
                            phi_6969_ = false;
                        } else {
                            let _e11488 = local_99;
                            phi_6965_ = _e11488;
                            let _e11491 = local_100;
                            phi_6966_ = _e11491;
                            phi_6967_ = _e9313;
                            phi_6968_ = _e9315;
                            phi_6969_ = _e9317;
                        }
                        let _e9319 = phi_6965_;
                        let _e9321 = phi_6966_;
                        let _e9323 = phi_6967_;
                        let _e9325 = phi_6968_;
                        let _e9327 = phi_6969_;
                        if _e9323 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e324 >= (0.000000059604645f * 8f)) {
                                phi_6981_ = _e324;
                            } else {
                                phi_6981_ = 0f;
                            }
                            let _e9334 = phi_6981_;
                            phi_6984_ = type_12(0u, 3u);
                            loop {
                                let _e9336 = phi_6984_;
                                if (_e9336.member < _e9336.member_1) {
                                    phi_6985_ = type_12((_e9336.member + 1u), _e9336.member_1);
                                    phi_7008_ = type_12(1u, _e9336.member);
                                } else {
                                    phi_6985_ = _e9336;
                                    phi_7008_ = type_12(0u, type_12().member_1);
                                }
                                let _e9348 = phi_6985_;
                                let _e9350 = phi_7008_;
                                if (bitcast<i32>(_e9350.member) != 0i) {
                                    let _e9356 = local_13[_e9350.member_1];
                                    let _e9358 = (_e9319 + (_e9334 * _e9356));
                                    if (_e9358 < _e328) {
                                        phi_7029_ = _e9358;
                                    } else {
                                        phi_7029_ = _e328;
                                    }
                                    let _e9361 = phi_7029_;
                                    let _e9364 = local_18.member[0u];
                                    let _e9370 = local_18.member[1u];
                                    let _e9386 = local_18.member_1[0u];
                                    let _e9392 = local_18.member_1[1u];
                                    let _e9408 = local_18.member_2[0u];
                                    let _e9414 = local_18.member_2[1u];
                                    let _e9428 = function_3(array<f32, 3>((_e9364[0] + ((_e9370[0] - _e9364[0]) * _e9361)), (_e9364[1] + ((_e9370[1] - _e9364[1]) * _e9361)), (_e9364[2] + ((_e9370[2] - _e9364[2]) * _e9361))), array<f32, 3>((_e9386[0] + ((_e9392[0] - _e9386[0]) * _e9361)), (_e9386[1] + ((_e9392[1] - _e9386[1]) * _e9361)), (_e9386[2] + ((_e9392[2] - _e9386[2]) * _e9361))), array<f32, 3>((_e9408[0] + ((_e9414[0] - _e9408[0]) * _e9361)), (_e9408[1] + ((_e9414[1] - _e9408[1]) * _e9361)), (_e9408[2] + ((_e9414[2] - _e9408[2]) * _e9361))), 1u);
                                    let _e9439 = (((_e9428[0] * _e9428[0]) + (_e9428[1] * _e9428[1])) + (_e9428[2] * _e9428[2]));
                                    if (_e9439 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9439 > 0f) {
                                            phi_7152_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7152_ = 0f;
                                        }
                                        let _e9492 = phi_7152_;
                                        phi_7216_ = _e9492;
                                    } else {
                                        phi_7159_ = type_14(0i, 5i);
                                        phi_7162_ = bitcast<f32>(((bitcast<u32>(_e9439) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9447 = phi_7159_;
                                            let _e9449 = phi_7162_;
                                            local_61 = _e9449;
                                            if (_e9447.member < _e9447.member_1) {
                                                let _e9456 = (_e9447.member + 1i);
                                                if ((false == (_e9456 > _e9447.member)) != false) {
                                                    phi_7183_ = true;
                                                } else {
                                                    phi_7183_ = false;
                                                }
                                                let _e9461 = phi_7183_;
                                                if _e9461 {
                                                    phi_7189_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7189_ = type_15(1u, _e9456);
                                                }
                                                let _e9466 = phi_7189_;
                                                phi_7160_ = type_14(_e9466.member_1, _e9447.member_1);
                                                phi_7203_ = type_15(1u, _e9447.member);
                                            } else {
                                                phi_7160_ = _e9447;
                                                phi_7203_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9472 = phi_7160_;
                                            let _e9474 = phi_7203_;
                                            let _e9477 = (bitcast<i32>(_e9474.member) != 0i);
                                            if _e9477 {
                                                phi_7163_ = (0.5f * (_e9449 + (_e9439 / _e9449)));
                                            } else {
                                                phi_7163_ = f32();
                                            }
                                            let _e9482 = phi_7163_;
                                            continue;
                                            continuing {
                                                phi_7159_ = _e9472;
                                                phi_7162_ = _e9482;
                                                break if !(_e9477);
                                            }
                                        }
                                        let _e9487 = local_61;
                                        phi_7216_ = (_e9487 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9494 = phi_7216_;
                                    let _e9500 = local_18.member[0u];
                                    if (_e9500[0] < 0f) {
                                        phi_7232_ = -(_e9500[0]);
                                    } else {
                                        phi_7232_ = _e9500[0];
                                    }
                                    let _e9507 = phi_7232_;
                                    if (_e9500[1] < 0f) {
                                        phi_7239_ = -(_e9500[1]);
                                    } else {
                                        phi_7239_ = _e9500[1];
                                    }
                                    let _e9511 = phi_7239_;
                                    if (_e9507 > _e9511) {
                                        phi_7244_ = _e9507;
                                    } else {
                                        phi_7244_ = _e9511;
                                    }
                                    let _e9514 = phi_7244_;
                                    if (_e9500[2] < 0f) {
                                        phi_7251_ = -(_e9500[2]);
                                    } else {
                                        phi_7251_ = _e9500[2];
                                    }
                                    let _e9518 = phi_7251_;
                                    if (_e9514 > _e9518) {
                                        phi_7256_ = _e9514;
                                    } else {
                                        phi_7256_ = _e9518;
                                    }
                                    let _e9521 = phi_7256_;
                                    let _e9524 = local_18.member[1u];
                                    if (_e9524[0] < 0f) {
                                        phi_7269_ = -(_e9524[0]);
                                    } else {
                                        phi_7269_ = _e9524[0];
                                    }
                                    let _e9531 = phi_7269_;
                                    if (_e9524[1] < 0f) {
                                        phi_7276_ = -(_e9524[1]);
                                    } else {
                                        phi_7276_ = _e9524[1];
                                    }
                                    let _e9535 = phi_7276_;
                                    if (_e9531 > _e9535) {
                                        phi_7281_ = _e9531;
                                    } else {
                                        phi_7281_ = _e9535;
                                    }
                                    let _e9538 = phi_7281_;
                                    if (_e9524[2] < 0f) {
                                        phi_7288_ = -(_e9524[2]);
                                    } else {
                                        phi_7288_ = _e9524[2];
                                    }
                                    let _e9542 = phi_7288_;
                                    if (_e9538 > _e9542) {
                                        phi_7293_ = _e9538;
                                    } else {
                                        phi_7293_ = _e9542;
                                    }
                                    let _e9545 = phi_7293_;
                                    if (_e9521 > _e9545) {
                                        phi_7298_ = _e9521;
                                    } else {
                                        phi_7298_ = _e9545;
                                    }
                                    let _e9548 = phi_7298_;
                                    let _e9550 = local_18.member_3;
                                    let _e9554 = local_18.member_1[0u];
                                    if (_e9554[0] < 0f) {
                                        phi_7315_ = -(_e9554[0]);
                                    } else {
                                        phi_7315_ = _e9554[0];
                                    }
                                    let _e9561 = phi_7315_;
                                    if (_e9554[1] < 0f) {
                                        phi_7322_ = -(_e9554[1]);
                                    } else {
                                        phi_7322_ = _e9554[1];
                                    }
                                    let _e9565 = phi_7322_;
                                    if (_e9561 > _e9565) {
                                        phi_7327_ = _e9561;
                                    } else {
                                        phi_7327_ = _e9565;
                                    }
                                    let _e9568 = phi_7327_;
                                    if (_e9554[2] < 0f) {
                                        phi_7334_ = -(_e9554[2]);
                                    } else {
                                        phi_7334_ = _e9554[2];
                                    }
                                    let _e9572 = phi_7334_;
                                    if (_e9568 > _e9572) {
                                        phi_7339_ = _e9568;
                                    } else {
                                        phi_7339_ = _e9572;
                                    }
                                    let _e9575 = phi_7339_;
                                    let _e9578 = local_18.member_1[1u];
                                    if (_e9578[0] < 0f) {
                                        phi_7353_ = -(_e9578[0]);
                                    } else {
                                        phi_7353_ = _e9578[0];
                                    }
                                    let _e9585 = phi_7353_;
                                    if (_e9578[1] < 0f) {
                                        phi_7360_ = -(_e9578[1]);
                                    } else {
                                        phi_7360_ = _e9578[1];
                                    }
                                    let _e9589 = phi_7360_;
                                    if (_e9585 > _e9589) {
                                        phi_7365_ = _e9585;
                                    } else {
                                        phi_7365_ = _e9589;
                                    }
                                    let _e9592 = phi_7365_;
                                    if (_e9578[2] < 0f) {
                                        phi_7372_ = -(_e9578[2]);
                                    } else {
                                        phi_7372_ = _e9578[2];
                                    }
                                    let _e9596 = phi_7372_;
                                    if (_e9592 > _e9596) {
                                        phi_7377_ = _e9592;
                                    } else {
                                        phi_7377_ = _e9596;
                                    }
                                    let _e9599 = phi_7377_;
                                    if (_e9575 > _e9599) {
                                        phi_7382_ = _e9575;
                                    } else {
                                        phi_7382_ = _e9599;
                                    }
                                    let _e9602 = phi_7382_;
                                    let _e9604 = local_18.member_3;
                                    let _e9608 = local_18.member_2[0u];
                                    if (_e9608[0] < 0f) {
                                        phi_7399_ = -(_e9608[0]);
                                    } else {
                                        phi_7399_ = _e9608[0];
                                    }
                                    let _e9615 = phi_7399_;
                                    if (_e9608[1] < 0f) {
                                        phi_7406_ = -(_e9608[1]);
                                    } else {
                                        phi_7406_ = _e9608[1];
                                    }
                                    let _e9619 = phi_7406_;
                                    if (_e9615 > _e9619) {
                                        phi_7411_ = _e9615;
                                    } else {
                                        phi_7411_ = _e9619;
                                    }
                                    let _e9622 = phi_7411_;
                                    if (_e9608[2] < 0f) {
                                        phi_7418_ = -(_e9608[2]);
                                    } else {
                                        phi_7418_ = _e9608[2];
                                    }
                                    let _e9626 = phi_7418_;
                                    if (_e9622 > _e9626) {
                                        phi_7423_ = _e9622;
                                    } else {
                                        phi_7423_ = _e9626;
                                    }
                                    let _e9629 = phi_7423_;
                                    let _e9632 = local_18.member_2[1u];
                                    if (_e9632[0] < 0f) {
                                        phi_7437_ = -(_e9632[0]);
                                    } else {
                                        phi_7437_ = _e9632[0];
                                    }
                                    let _e9639 = phi_7437_;
                                    if (_e9632[1] < 0f) {
                                        phi_7444_ = -(_e9632[1]);
                                    } else {
                                        phi_7444_ = _e9632[1];
                                    }
                                    let _e9643 = phi_7444_;
                                    if (_e9639 > _e9643) {
                                        phi_7449_ = _e9639;
                                    } else {
                                        phi_7449_ = _e9643;
                                    }
                                    let _e9646 = phi_7449_;
                                    if (_e9632[2] < 0f) {
                                        phi_7456_ = -(_e9632[2]);
                                    } else {
                                        phi_7456_ = _e9632[2];
                                    }
                                    let _e9650 = phi_7456_;
                                    if (_e9646 > _e9650) {
                                        phi_7461_ = _e9646;
                                    } else {
                                        phi_7461_ = _e9650;
                                    }
                                    let _e9653 = phi_7461_;
                                    if (_e9629 > _e9653) {
                                        phi_7466_ = _e9629;
                                    } else {
                                        phi_7466_ = _e9653;
                                    }
                                    let _e9656 = phi_7466_;
                                    let _e9658 = local_18.member_3;
                                    let _e9665 = local_18.member_3;
                                    let _e9672 = (((_e9494 * (1f + (0.000000059604645f * 8f))) + (((((((_e9548 + _e9550) + (_e9602 + _e9604)) + (_e9656 + _e9658)) * (0.000000059604645f * 16f)) + (_e9665 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e530.member_1);
                                    if _e9672 {
                                        phi_7486_ = false;
                                    } else {
                                        phi_7486_ = true;
                                    }
                                    let _e9674 = phi_7486_;
                                    phi_7487_ = _e9674;
                                    phi_7488_ = _e9672;
                                } else {
                                    phi_7487_ = false;
                                    phi_7488_ = false;
                                }
                                let _e9676 = phi_7487_;
                                let _e9678 = phi_7488_;
                                local_62 = _e9678;
                                continue;
                                continuing {
                                    phi_6984_ = _e9348;
                                    break if !(_e9676);
                                }
                            }
                            let _e9681 = local_62;
                            if _e9681 {
                                if (_e9319 > _e326) {
                                    phi_7496_ = 1u;
                                } else {
                                    phi_7496_ = _e9321;
                                }
                                let _e9684 = phi_7496_;
                                phi_7500_ = type_39(type_30(1u, _e9319), _e9684);
                                phi_7501_ = false;
                            } else {
                                phi_7500_ = type_39();
                                phi_7501_ = true;
                            }
                            let _e9688 = phi_7500_;
                            let _e9690 = phi_7501_;
                            if _e9690 {
                                if (_e9319 > _e326) {
                                    phi_7509_ = 0u;
                                } else {
                                    phi_7509_ = _e9321;
                                }
                                let _e9693 = phi_7509_;
                                phi_7513_ = type_39(type_30(2u, _e9319), _e9693);
                            } else {
                                phi_7513_ = _e9688;
                            }
                            let _e9697 = phi_7513_;
                            phi_7514_ = _e9697;
                            phi_7515_ = false;
                            phi_7516_ = false;
                        } else {
                            phi_7514_ = type_39();
                            phi_7515_ = _e9325;
                            phi_7516_ = _e9327;
                        }
                        let _e9699 = phi_7514_;
                        let _e9701 = phi_7515_;
                        let _e9703 = phi_7516_;
                        if _e9701 {
                            phi_7523_ = type_39(type_30(0u, f32()), 0u);
                            phi_7524_ = true;
                        } else {
                            phi_7523_ = _e9297;
                            phi_7524_ = _e9703;
                        }
                        let _e9707 = phi_7523_;
                        let _e9709 = phi_7524_;
                        phi_7528_ = _e9707;
                        phi_7529_ = _e9699;
                        phi_7530_ = _e9709;
                    } else {
                        phi_7528_ = _e5966;
                        phi_7529_ = type_39();
                        phi_7530_ = true;
                    }
                    let _e9711 = phi_7528_;
                    let _e9713 = phi_7529_;
                    let _e9715 = phi_7530_;
                    if _e9715 {
                        phi_7534_ = _e9711;
                    } else {
                        phi_7534_ = _e9713;
                    }
                    let _e9717 = phi_7534_;
                    phi_15049_ = _e9717;
                } else {
                    let _e574 = local_18.member_1[0u];
                    let _e580 = local_18.member_2[0u];
                    let _e586 = ((_e574[1] * _e580[2]) - (_e574[2] * _e580[1]));
                    let _e589 = ((_e574[2] * _e580[0]) - (_e574[0] * _e580[2]));
                    let _e592 = ((_e574[0] * _e580[1]) - (_e574[1] * _e580[0]));
                    let _e595 = local_18.member_1[1u];
                    let _e601 = local_18.member_2[1u];
                    let _e607 = ((_e595[1] * _e601[2]) - (_e595[2] * _e601[1]));
                    let _e610 = ((_e595[2] * _e601[0]) - (_e595[0] * _e601[2]));
                    let _e613 = ((_e595[0] * _e601[1]) - (_e595[1] * _e601[0]));
                    let _e616 = local_18.member_1[0u];
                    let _e622 = local_18.member_2[1u];
                    let _e637 = local_18.member_1[1u];
                    let _e643 = local_18.member_2[0u];
                    let _e656 = (((_e616[1] * _e622[2]) - (_e616[2] * _e622[1])) + ((_e637[1] * _e643[2]) - (_e637[2] * _e643[1])));
                    let _e657 = (((_e616[2] * _e622[0]) - (_e616[0] * _e622[2])) + ((_e637[2] * _e643[0]) - (_e637[0] * _e643[2])));
                    let _e658 = (((_e616[0] * _e622[1]) - (_e616[1] * _e622[0])) + ((_e637[0] * _e643[1]) - (_e637[1] * _e643[0])));
                    let _e661 = local_18.member[0u];
                    let _e669 = (((_e661[0] * _e586) + (_e661[1] * _e589)) + (_e661[2] * _e592));
                    let _e672 = local_18.member[1u];
                    let _e683 = local_18.member[0u];
                    let _e692 = ((((_e672[0] * _e586) + (_e672[1] * _e589)) + (_e672[2] * _e592)) + (((_e683[0] * _e656) + (_e683[1] * _e657)) + (_e683[2] * _e658)));
                    let _e695 = local_18.member[0u];
                    let _e706 = local_18.member[1u];
                    let _e715 = ((((_e695[0] * _e607) + (_e695[1] * _e610)) + (_e695[2] * _e613)) + (((_e706[0] * _e656) + (_e706[1] * _e657)) + (_e706[2] * _e658)));
                    let _e718 = local_18.member[1u];
                    let _e726 = (((_e718[0] * _e607) + (_e718[1] * _e610)) + (_e718[2] * _e613));
                    let _e729 = local_18.member[0u];
                    if (_e729[0] < 0f) {
                        phi_7776_ = -(_e729[0]);
                    } else {
                        phi_7776_ = _e729[0];
                    }
                    let _e736 = phi_7776_;
                    if (_e729[1] < 0f) {
                        phi_7783_ = -(_e729[1]);
                    } else {
                        phi_7783_ = _e729[1];
                    }
                    let _e740 = phi_7783_;
                    if (_e736 > _e740) {
                        phi_7788_ = _e736;
                    } else {
                        phi_7788_ = _e740;
                    }
                    let _e743 = phi_7788_;
                    if (_e729[2] < 0f) {
                        phi_7795_ = -(_e729[2]);
                    } else {
                        phi_7795_ = _e729[2];
                    }
                    let _e747 = phi_7795_;
                    if (_e743 > _e747) {
                        phi_7800_ = _e743;
                    } else {
                        phi_7800_ = _e747;
                    }
                    let _e750 = phi_7800_;
                    let _e753 = local_18.member[1u];
                    if (_e753[0] < 0f) {
                        phi_7813_ = -(_e753[0]);
                    } else {
                        phi_7813_ = _e753[0];
                    }
                    let _e760 = phi_7813_;
                    if (_e753[1] < 0f) {
                        phi_7820_ = -(_e753[1]);
                    } else {
                        phi_7820_ = _e753[1];
                    }
                    let _e764 = phi_7820_;
                    if (_e760 > _e764) {
                        phi_7825_ = _e760;
                    } else {
                        phi_7825_ = _e764;
                    }
                    let _e767 = phi_7825_;
                    if (_e753[2] < 0f) {
                        phi_7832_ = -(_e753[2]);
                    } else {
                        phi_7832_ = _e753[2];
                    }
                    let _e771 = phi_7832_;
                    if (_e767 > _e771) {
                        phi_7837_ = _e767;
                    } else {
                        phi_7837_ = _e771;
                    }
                    let _e774 = phi_7837_;
                    if (_e750 > _e774) {
                        phi_7842_ = _e750;
                    } else {
                        phi_7842_ = _e774;
                    }
                    let _e777 = phi_7842_;
                    let _e779 = local_18.member_3;
                    let _e780 = (_e777 + _e779);
                    let _e783 = local_18.member_1[0u];
                    if (_e783[0] < 0f) {
                        phi_7859_ = -(_e783[0]);
                    } else {
                        phi_7859_ = _e783[0];
                    }
                    let _e790 = phi_7859_;
                    if (_e783[1] < 0f) {
                        phi_7866_ = -(_e783[1]);
                    } else {
                        phi_7866_ = _e783[1];
                    }
                    let _e794 = phi_7866_;
                    if (_e790 > _e794) {
                        phi_7871_ = _e790;
                    } else {
                        phi_7871_ = _e794;
                    }
                    let _e797 = phi_7871_;
                    if (_e783[2] < 0f) {
                        phi_7878_ = -(_e783[2]);
                    } else {
                        phi_7878_ = _e783[2];
                    }
                    let _e801 = phi_7878_;
                    if (_e797 > _e801) {
                        phi_7883_ = _e797;
                    } else {
                        phi_7883_ = _e801;
                    }
                    let _e804 = phi_7883_;
                    let _e807 = local_18.member_1[1u];
                    if (_e807[0] < 0f) {
                        phi_7897_ = -(_e807[0]);
                    } else {
                        phi_7897_ = _e807[0];
                    }
                    let _e814 = phi_7897_;
                    if (_e807[1] < 0f) {
                        phi_7904_ = -(_e807[1]);
                    } else {
                        phi_7904_ = _e807[1];
                    }
                    let _e818 = phi_7904_;
                    if (_e814 > _e818) {
                        phi_7909_ = _e814;
                    } else {
                        phi_7909_ = _e818;
                    }
                    let _e821 = phi_7909_;
                    if (_e807[2] < 0f) {
                        phi_7916_ = -(_e807[2]);
                    } else {
                        phi_7916_ = _e807[2];
                    }
                    let _e825 = phi_7916_;
                    if (_e821 > _e825) {
                        phi_7921_ = _e821;
                    } else {
                        phi_7921_ = _e825;
                    }
                    let _e828 = phi_7921_;
                    if (_e804 > _e828) {
                        phi_7926_ = _e804;
                    } else {
                        phi_7926_ = _e828;
                    }
                    let _e831 = phi_7926_;
                    let _e833 = local_18.member_3;
                    let _e834 = (_e831 + _e833);
                    let _e837 = local_18.member_2[0u];
                    if (_e837[0] < 0f) {
                        phi_7943_ = -(_e837[0]);
                    } else {
                        phi_7943_ = _e837[0];
                    }
                    let _e844 = phi_7943_;
                    if (_e837[1] < 0f) {
                        phi_7950_ = -(_e837[1]);
                    } else {
                        phi_7950_ = _e837[1];
                    }
                    let _e848 = phi_7950_;
                    if (_e844 > _e848) {
                        phi_7955_ = _e844;
                    } else {
                        phi_7955_ = _e848;
                    }
                    let _e851 = phi_7955_;
                    if (_e837[2] < 0f) {
                        phi_7962_ = -(_e837[2]);
                    } else {
                        phi_7962_ = _e837[2];
                    }
                    let _e855 = phi_7962_;
                    if (_e851 > _e855) {
                        phi_7967_ = _e851;
                    } else {
                        phi_7967_ = _e855;
                    }
                    let _e858 = phi_7967_;
                    let _e861 = local_18.member_2[1u];
                    if (_e861[0] < 0f) {
                        phi_7981_ = -(_e861[0]);
                    } else {
                        phi_7981_ = _e861[0];
                    }
                    let _e868 = phi_7981_;
                    if (_e861[1] < 0f) {
                        phi_7988_ = -(_e861[1]);
                    } else {
                        phi_7988_ = _e861[1];
                    }
                    let _e872 = phi_7988_;
                    if (_e868 > _e872) {
                        phi_7993_ = _e868;
                    } else {
                        phi_7993_ = _e872;
                    }
                    let _e875 = phi_7993_;
                    if (_e861[2] < 0f) {
                        phi_8000_ = -(_e861[2]);
                    } else {
                        phi_8000_ = _e861[2];
                    }
                    let _e879 = phi_8000_;
                    if (_e875 > _e879) {
                        phi_8005_ = _e875;
                    } else {
                        phi_8005_ = _e879;
                    }
                    let _e882 = phi_8005_;
                    if (_e858 > _e882) {
                        phi_8010_ = _e858;
                    } else {
                        phi_8010_ = _e882;
                    }
                    let _e885 = phi_8010_;
                    let _e887 = local_18.member_3;
                    let _e888 = (_e885 + _e887);
                    let _e890 = ((_e834 * 8f) * _e888);
                    let _e897 = local_18.member_3;
                    if (_e586 < 0f) {
                        phi_8041_ = -(_e586);
                    } else {
                        phi_8041_ = _e586;
                    }
                    let _e914 = phi_8041_;
                    if (_e589 < 0f) {
                        phi_8047_ = -(_e589);
                    } else {
                        phi_8047_ = _e589;
                    }
                    let _e918 = phi_8047_;
                    if (_e592 < 0f) {
                        phi_8054_ = -(_e592);
                    } else {
                        phi_8054_ = _e592;
                    }
                    let _e923 = phi_8054_;
                    let _e924 = ((_e914 + _e918) + _e923);
                    if (_e607 < 0f) {
                        phi_8061_ = -(_e607);
                    } else {
                        phi_8061_ = _e607;
                    }
                    let _e928 = phi_8061_;
                    if (_e610 < 0f) {
                        phi_8067_ = -(_e610);
                    } else {
                        phi_8067_ = _e610;
                    }
                    let _e932 = phi_8067_;
                    if (_e613 < 0f) {
                        phi_8074_ = -(_e613);
                    } else {
                        phi_8074_ = _e613;
                    }
                    let _e937 = phi_8074_;
                    let _e938 = ((_e928 + _e932) + _e937);
                    if (_e924 > _e938) {
                        phi_8080_ = _e924;
                    } else {
                        phi_8080_ = _e938;
                    }
                    let _e941 = phi_8080_;
                    if (_e656 < 0f) {
                        phi_8086_ = -(_e656);
                    } else {
                        phi_8086_ = _e656;
                    }
                    let _e945 = phi_8086_;
                    if (_e657 < 0f) {
                        phi_8092_ = -(_e657);
                    } else {
                        phi_8092_ = _e657;
                    }
                    let _e949 = phi_8092_;
                    if (_e658 < 0f) {
                        phi_8099_ = -(_e658);
                    } else {
                        phi_8099_ = _e658;
                    }
                    let _e954 = phi_8099_;
                    let _e956 = (((_e945 + _e949) + _e954) * 0.5f);
                    if (_e941 > _e956) {
                        phi_8106_ = _e941;
                    } else {
                        phi_8106_ = _e956;
                    }
                    let _e959 = phi_8106_;
                    let _e964 = local_18.member_3;
                    let _e976 = (((((_e780 * 8f) * _e890) * (0.000000059604645f * (524f / 64f))) + ((_e897 * 19f) * ((_e780 * (_e834 + _e888)) + (_e834 * _e888)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e780) * ((1f + _e834) * (1f + _e888)))));
                    let _e977 = (_e669 * 3f);
                    let _e978 = (_e726 * 3f);
                    if (_e977 < _e978) {
                        phi_8130_ = _e977;
                    } else {
                        phi_8130_ = _e978;
                    }
                    let _e981 = phi_8130_;
                    if (_e692 < _e715) {
                        phi_8135_ = _e692;
                    } else {
                        phi_8135_ = _e715;
                    }
                    let _e984 = phi_8135_;
                    if (_e981 < _e984) {
                        phi_8140_ = _e981;
                    } else {
                        phi_8140_ = _e984;
                    }
                    let _e987 = phi_8140_;
                    if (_e977 > _e978) {
                        phi_8145_ = _e977;
                    } else {
                        phi_8145_ = _e978;
                    }
                    let _e990 = phi_8145_;
                    if (_e692 > _e715) {
                        phi_8150_ = _e692;
                    } else {
                        phi_8150_ = _e715;
                    }
                    let _e993 = phi_8150_;
                    if (_e990 > _e993) {
                        phi_8155_ = _e990;
                    } else {
                        phi_8155_ = _e993;
                    }
                    let _e996 = phi_8155_;
                    let _e1001 = -(_e996);
                    if (_e987 > _e1001) {
                        phi_8165_ = _e987;
                    } else {
                        phi_8165_ = _e1001;
                    }
                    let _e1004 = phi_8165_;
                    if ((_e1004 - (_e976 + ((0f * (((_e959 + (_e890 * (0.000000059604645f * 8f))) + ((_e964 * 6f) * (_e834 + _e888))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e834) * (1f + _e888))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15019_ = type_30(0u, type_30().member_1);
                        phi_15020_ = type_30();
                        phi_15021_ = true;
                    } else {
                        if (_e669 < 0f) {
                            phi_8178_ = -(_e669);
                        } else {
                            phi_8178_ = _e669;
                        }
                        let _e1011 = phi_8178_;
                        if (_e692 < 0f) {
                            phi_8184_ = -(_e692);
                        } else {
                            phi_8184_ = _e692;
                        }
                        let _e1015 = phi_8184_;
                        if (_e1011 > _e1015) {
                            phi_8189_ = _e1011;
                        } else {
                            phi_8189_ = _e1015;
                        }
                        let _e1018 = phi_8189_;
                        if (_e715 < 0f) {
                            phi_8195_ = -(_e715);
                        } else {
                            phi_8195_ = _e715;
                        }
                        let _e1022 = phi_8195_;
                        if (_e726 < 0f) {
                            phi_8201_ = -(_e726);
                        } else {
                            phi_8201_ = _e726;
                        }
                        let _e1026 = phi_8201_;
                        if (_e1022 > _e1026) {
                            phi_8206_ = _e1022;
                        } else {
                            phi_8206_ = _e1026;
                        }
                        let _e1029 = phi_8206_;
                        if (_e1018 > _e1029) {
                            phi_8211_ = _e1018;
                        } else {
                            phi_8211_ = _e1029;
                        }
                        let _e1032 = phi_8211_;
                        let _e1033 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1032 >= _e1033) {
                            phi_8219_ = (_e1032 <= (1f / _e1033));
                        } else {
                            phi_8219_ = false;
                        }
                        let _e1038 = phi_8219_;
                        if _e1038 {
                            phi_8224_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8224_ = 2f;
                        }
                        let _e1041 = phi_8224_;
                        let _e1043 = ((_e976 * 0.34f) + (_e1032 * _e1041));
                        if _e1038 {
                            phi_8231_ = (1f / _e1032);
                        } else {
                            phi_8231_ = 0f;
                        }
                        let _e1046 = phi_8231_;
                        let _e1047 = (_e324 * 0.0625f);
                        if (0.00000000000022737368f < _e1047) {
                            phi_8237_ = 0.00000000000022737368f;
                        } else {
                            phi_8237_ = _e1047;
                        }
                        let _e1050 = phi_8237_;
                        let _e1051 = (1f - _e326);
                        let _e1062 = ((((_e669 * _e1051) + (_e692 * _e326)) * (_e1051 * _e1051)) + (((_e715 * _e1051) + (_e726 * _e326)) * (_e326 * _e326)));
                        if (_e1062 < 0f) {
                            phi_8255_ = -(_e1062);
                        } else {
                            phi_8255_ = _e1062;
                        }
                        let _e1066 = phi_8255_;
                        if !((_e1066 > _e1043)) {
                            let _e1071 = local_18.member[0u];
                            let _e1077 = local_18.member_1[0u];
                            let _e1083 = local_18.member_2[0u];
                            let _e1087 = (_e1071[0] - _e1077[0]);
                            let _e1088 = (_e1071[1] - _e1077[1]);
                            let _e1089 = (_e1071[2] - _e1077[2]);
                            let _e1090 = (_e1087 - _e1083[0]);
                            let _e1091 = (_e1088 - _e1083[1]);
                            let _e1092 = (_e1089 - _e1083[2]);
                            let _e1093 = (_e1071[0] - _e1083[0]);
                            let _e1094 = (_e1071[1] - _e1083[1]);
                            let _e1095 = (_e1071[2] - _e1083[2]);
                            let _e1098 = local_18.member[1u];
                            let _e1104 = local_18.member_1[1u];
                            let _e1110 = local_18.member_2[1u];
                            let _e1114 = (_e1098[0] - _e1104[0]);
                            let _e1115 = (_e1098[1] - _e1104[1]);
                            let _e1116 = (_e1098[2] - _e1104[2]);
                            let _e1117 = (_e1114 - _e1110[0]);
                            let _e1118 = (_e1115 - _e1110[1]);
                            let _e1119 = (_e1116 - _e1110[2]);
                            let _e1120 = (_e1098[0] - _e1110[0]);
                            let _e1121 = (_e1098[1] - _e1110[1]);
                            let _e1122 = (_e1098[2] - _e1110[2]);
                            let _e1125 = local_18.member[0u];
                            if (_e1125[0] < 0f) {
                                phi_8403_ = -(_e1125[0]);
                            } else {
                                phi_8403_ = _e1125[0];
                            }
                            let _e1132 = phi_8403_;
                            if (_e1125[1] < 0f) {
                                phi_8410_ = -(_e1125[1]);
                            } else {
                                phi_8410_ = _e1125[1];
                            }
                            let _e1136 = phi_8410_;
                            if (_e1132 > _e1136) {
                                phi_8415_ = _e1132;
                            } else {
                                phi_8415_ = _e1136;
                            }
                            let _e1139 = phi_8415_;
                            if (_e1125[2] < 0f) {
                                phi_8422_ = -(_e1125[2]);
                            } else {
                                phi_8422_ = _e1125[2];
                            }
                            let _e1143 = phi_8422_;
                            if (_e1139 > _e1143) {
                                phi_8427_ = _e1139;
                            } else {
                                phi_8427_ = _e1143;
                            }
                            let _e1146 = phi_8427_;
                            let _e1149 = local_18.member[1u];
                            if (_e1149[0] < 0f) {
                                phi_8440_ = -(_e1149[0]);
                            } else {
                                phi_8440_ = _e1149[0];
                            }
                            let _e1156 = phi_8440_;
                            if (_e1149[1] < 0f) {
                                phi_8447_ = -(_e1149[1]);
                            } else {
                                phi_8447_ = _e1149[1];
                            }
                            let _e1160 = phi_8447_;
                            if (_e1156 > _e1160) {
                                phi_8452_ = _e1156;
                            } else {
                                phi_8452_ = _e1160;
                            }
                            let _e1163 = phi_8452_;
                            if (_e1149[2] < 0f) {
                                phi_8459_ = -(_e1149[2]);
                            } else {
                                phi_8459_ = _e1149[2];
                            }
                            let _e1167 = phi_8459_;
                            if (_e1163 > _e1167) {
                                phi_8464_ = _e1163;
                            } else {
                                phi_8464_ = _e1167;
                            }
                            let _e1170 = phi_8464_;
                            if (_e1146 > _e1170) {
                                phi_8469_ = _e1146;
                            } else {
                                phi_8469_ = _e1170;
                            }
                            let _e1173 = phi_8469_;
                            let _e1175 = local_18.member_3;
                            let _e1179 = local_18.member_1[0u];
                            if (_e1179[0] < 0f) {
                                phi_8486_ = -(_e1179[0]);
                            } else {
                                phi_8486_ = _e1179[0];
                            }
                            let _e1186 = phi_8486_;
                            if (_e1179[1] < 0f) {
                                phi_8493_ = -(_e1179[1]);
                            } else {
                                phi_8493_ = _e1179[1];
                            }
                            let _e1190 = phi_8493_;
                            if (_e1186 > _e1190) {
                                phi_8498_ = _e1186;
                            } else {
                                phi_8498_ = _e1190;
                            }
                            let _e1193 = phi_8498_;
                            if (_e1179[2] < 0f) {
                                phi_8505_ = -(_e1179[2]);
                            } else {
                                phi_8505_ = _e1179[2];
                            }
                            let _e1197 = phi_8505_;
                            if (_e1193 > _e1197) {
                                phi_8510_ = _e1193;
                            } else {
                                phi_8510_ = _e1197;
                            }
                            let _e1200 = phi_8510_;
                            let _e1203 = local_18.member_1[1u];
                            if (_e1203[0] < 0f) {
                                phi_8524_ = -(_e1203[0]);
                            } else {
                                phi_8524_ = _e1203[0];
                            }
                            let _e1210 = phi_8524_;
                            if (_e1203[1] < 0f) {
                                phi_8531_ = -(_e1203[1]);
                            } else {
                                phi_8531_ = _e1203[1];
                            }
                            let _e1214 = phi_8531_;
                            if (_e1210 > _e1214) {
                                phi_8536_ = _e1210;
                            } else {
                                phi_8536_ = _e1214;
                            }
                            let _e1217 = phi_8536_;
                            if (_e1203[2] < 0f) {
                                phi_8543_ = -(_e1203[2]);
                            } else {
                                phi_8543_ = _e1203[2];
                            }
                            let _e1221 = phi_8543_;
                            if (_e1217 > _e1221) {
                                phi_8548_ = _e1217;
                            } else {
                                phi_8548_ = _e1221;
                            }
                            let _e1224 = phi_8548_;
                            if (_e1200 > _e1224) {
                                phi_8553_ = _e1200;
                            } else {
                                phi_8553_ = _e1224;
                            }
                            let _e1227 = phi_8553_;
                            let _e1229 = local_18.member_3;
                            let _e1233 = local_18.member_2[0u];
                            if (_e1233[0] < 0f) {
                                phi_8570_ = -(_e1233[0]);
                            } else {
                                phi_8570_ = _e1233[0];
                            }
                            let _e1240 = phi_8570_;
                            if (_e1233[1] < 0f) {
                                phi_8577_ = -(_e1233[1]);
                            } else {
                                phi_8577_ = _e1233[1];
                            }
                            let _e1244 = phi_8577_;
                            if (_e1240 > _e1244) {
                                phi_8582_ = _e1240;
                            } else {
                                phi_8582_ = _e1244;
                            }
                            let _e1247 = phi_8582_;
                            if (_e1233[2] < 0f) {
                                phi_8589_ = -(_e1233[2]);
                            } else {
                                phi_8589_ = _e1233[2];
                            }
                            let _e1251 = phi_8589_;
                            if (_e1247 > _e1251) {
                                phi_8594_ = _e1247;
                            } else {
                                phi_8594_ = _e1251;
                            }
                            let _e1254 = phi_8594_;
                            let _e1257 = local_18.member_2[1u];
                            if (_e1257[0] < 0f) {
                                phi_8608_ = -(_e1257[0]);
                            } else {
                                phi_8608_ = _e1257[0];
                            }
                            let _e1264 = phi_8608_;
                            if (_e1257[1] < 0f) {
                                phi_8615_ = -(_e1257[1]);
                            } else {
                                phi_8615_ = _e1257[1];
                            }
                            let _e1268 = phi_8615_;
                            if (_e1264 > _e1268) {
                                phi_8620_ = _e1264;
                            } else {
                                phi_8620_ = _e1268;
                            }
                            let _e1271 = phi_8620_;
                            if (_e1257[2] < 0f) {
                                phi_8627_ = -(_e1257[2]);
                            } else {
                                phi_8627_ = _e1257[2];
                            }
                            let _e1275 = phi_8627_;
                            if (_e1271 > _e1275) {
                                phi_8632_ = _e1271;
                            } else {
                                phi_8632_ = _e1275;
                            }
                            let _e1278 = phi_8632_;
                            if (_e1254 > _e1278) {
                                phi_8637_ = _e1254;
                            } else {
                                phi_8637_ = _e1278;
                            }
                            let _e1281 = phi_8637_;
                            let _e1283 = local_18.member_3;
                            let _e1290 = local_18.member_3;
                            let _e1294 = ((((((_e1173 + _e1175) + (_e1227 + _e1229)) + (_e1281 + _e1283)) * (0.000000059604645f * 16f)) + (_e1290 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1297 = local_18.member[0u];
                            let _e1303 = local_18.member[1u];
                            let _e1319 = local_18.member_1[0u];
                            let _e1325 = local_18.member_1[1u];
                            let _e1341 = local_18.member_2[0u];
                            let _e1347 = local_18.member_2[1u];
                            let _e1361 = function_3(array<f32, 3>((_e1297[0] + ((_e1303[0] - _e1297[0]) * _e326)), (_e1297[1] + ((_e1303[1] - _e1297[1]) * _e326)), (_e1297[2] + ((_e1303[2] - _e1297[2]) * _e326))), array<f32, 3>((_e1319[0] + ((_e1325[0] - _e1319[0]) * _e326)), (_e1319[1] + ((_e1325[1] - _e1319[1]) * _e326)), (_e1319[2] + ((_e1325[2] - _e1319[2]) * _e326))), array<f32, 3>((_e1341[0] + ((_e1347[0] - _e1341[0]) * _e326)), (_e1341[1] + ((_e1347[1] - _e1341[1]) * _e326)), (_e1341[2] + ((_e1347[2] - _e1341[2]) * _e326))), 1u);
                            if (_e1361[0] < 0f) {
                                phi_8755_ = -(_e1361[0]);
                            } else {
                                phi_8755_ = _e1361[0];
                            }
                            let _e1366 = phi_8755_;
                            if (_e1361[1] < 0f) {
                                phi_8762_ = -(_e1361[1]);
                            } else {
                                phi_8762_ = _e1361[1];
                            }
                            let _e1371 = phi_8762_;
                            if (_e1361[2] < 0f) {
                                phi_8770_ = -(_e1361[2]);
                            } else {
                                phi_8770_ = _e1361[2];
                            }
                            let _e1377 = phi_8770_;
                            let _e1378 = ((_e1366 + _e1371) + _e1377);
                            if (_e1378 > 0f) {
                                if ((bitcast<u32>(_e1378) & 2139095040u) != 2139095040u) {
                                    let _e1383 = (1f / _e1378);
                                    let _e1385 = (_e1361[0] * _e1383);
                                    let _e1387 = (_e1361[1] * _e1383);
                                    let _e1389 = (_e1361[2] * _e1383);
                                    let _e1394 = (((_e1385 * _e1385) + (_e1387 * _e1387)) + (_e1389 * _e1389));
                                    if (_e1394 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1394 > 0f) {
                                            phi_8807_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_8807_ = 0f;
                                        }
                                        let _e1447 = phi_8807_;
                                        phi_8871_ = _e1447;
                                    } else {
                                        phi_8814_ = type_14(0i, 5i);
                                        phi_8817_ = bitcast<f32>(((bitcast<u32>(_e1394) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1402 = phi_8814_;
                                            let _e1404 = phi_8817_;
                                            local_19 = _e1404;
                                            if (_e1402.member < _e1402.member_1) {
                                                let _e1411 = (_e1402.member + 1i);
                                                if ((false == (_e1411 > _e1402.member)) != false) {
                                                    phi_8838_ = true;
                                                } else {
                                                    phi_8838_ = false;
                                                }
                                                let _e1416 = phi_8838_;
                                                if _e1416 {
                                                    phi_8844_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_8844_ = type_15(1u, _e1411);
                                                }
                                                let _e1421 = phi_8844_;
                                                phi_8815_ = type_14(_e1421.member_1, _e1402.member_1);
                                                phi_8858_ = type_15(1u, _e1402.member);
                                            } else {
                                                phi_8815_ = _e1402;
                                                phi_8858_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1427 = phi_8815_;
                                            let _e1429 = phi_8858_;
                                            let _e1432 = (bitcast<i32>(_e1429.member) != 0i);
                                            if _e1432 {
                                                phi_8818_ = (0.5f * (_e1404 + (_e1394 / _e1404)));
                                            } else {
                                                phi_8818_ = f32();
                                            }
                                            let _e1437 = phi_8818_;
                                            continue;
                                            continuing {
                                                phi_8814_ = _e1427;
                                                phi_8817_ = _e1437;
                                                break if !(_e1432);
                                            }
                                        }
                                        let _e1442 = local_19;
                                        phi_8871_ = (_e1442 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1449 = phi_8871_;
                                    let _e1450 = (0.000000059604645f * 12f);
                                    let _e1455 = ((_e1294 * 1.01f) + ((0f * _e1449) * (1f + _e1450)));
                                    let _e1460 = (((_e1385 * _e1071[0]) + (_e1387 * _e1071[1])) + (_e1389 * _e1071[2]));
                                    let _e1465 = (((_e1385 * _e1087) + (_e1387 * _e1088)) + (_e1389 * _e1089));
                                    let _e1470 = (((_e1385 * _e1093) + (_e1387 * _e1094)) + (_e1389 * _e1095));
                                    let _e1475 = (((_e1385 * _e1090) + (_e1387 * _e1091)) + (_e1389 * _e1092));
                                    let _e1481 = (((_e1385 * _e1098[0]) + (_e1387 * _e1098[1])) + (_e1389 * _e1098[2]));
                                    let _e1486 = (((_e1385 * _e1114) + (_e1387 * _e1115)) + (_e1389 * _e1116));
                                    let _e1491 = (((_e1385 * _e1120) + (_e1387 * _e1121)) + (_e1389 * _e1122));
                                    let _e1496 = (((_e1385 * _e1117) + (_e1387 * _e1118)) + (_e1389 * _e1119));
                                    if (_e1460 < 0f) {
                                        phi_8937_ = -(_e1460);
                                    } else {
                                        phi_8937_ = _e1460;
                                    }
                                    let _e1501 = phi_8937_;
                                    if (_e1481 < 0f) {
                                        phi_8943_ = -(_e1481);
                                    } else {
                                        phi_8943_ = _e1481;
                                    }
                                    let _e1505 = phi_8943_;
                                    if (_e1465 < 0f) {
                                        phi_8952_ = -(_e1465);
                                    } else {
                                        phi_8952_ = _e1465;
                                    }
                                    let _e1512 = phi_8952_;
                                    if (_e1486 < 0f) {
                                        phi_8958_ = -(_e1486);
                                    } else {
                                        phi_8958_ = _e1486;
                                    }
                                    let _e1516 = phi_8958_;
                                    if (_e1470 < 0f) {
                                        phi_8967_ = -(_e1470);
                                    } else {
                                        phi_8967_ = _e1470;
                                    }
                                    let _e1523 = phi_8967_;
                                    if (_e1491 < 0f) {
                                        phi_8973_ = -(_e1491);
                                    } else {
                                        phi_8973_ = _e1491;
                                    }
                                    let _e1527 = phi_8973_;
                                    if (_e1475 < 0f) {
                                        phi_8982_ = -(_e1475);
                                    } else {
                                        phi_8982_ = _e1475;
                                    }
                                    let _e1534 = phi_8982_;
                                    if (_e1496 < 0f) {
                                        phi_8988_ = -(_e1496);
                                    } else {
                                        phi_8988_ = _e1496;
                                    }
                                    let _e1538 = phi_8988_;
                                    phi_8994_ = type_32(array<f32, 4>(_e1460, _e1465, _e1470, _e1475), array<f32, 4>(_e1481, _e1486, _e1491, _e1496), array<f32, 4>((_e1455 + ((_e1501 + _e1505) * _e1450)), (_e1455 + ((_e1512 + _e1516) * _e1450)), (_e1455 + ((_e1523 + _e1527) * _e1450)), (_e1455 + ((_e1534 + _e1538) * _e1450))));
                                    phi_8995_ = false;
                                } else {
                                    phi_8994_ = type_32();
                                    phi_8995_ = true;
                                }
                                let _e1545 = phi_8994_;
                                let _e1547 = phi_8995_;
                                phi_8996_ = _e1545;
                                phi_8997_ = _e1547;
                            } else {
                                phi_8996_ = type_32();
                                phi_8997_ = true;
                            }
                            let _e1549 = phi_8996_;
                            let _e1551 = phi_8997_;
                            if _e1551 {
                                phi_9005_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_9005_ = _e1549;
                            }
                            let _e1553 = phi_9005_;
                            local_8 = type_32(array<f32, 4>(_e1553.member[0], _e1553.member[1], _e1553.member[2], _e1553.member[3]), array<f32, 4>(_e1553.member_1[0], _e1553.member_1[1], _e1553.member_1[2], _e1553.member_1[3]), array<f32, 4>(_e1553.member_2[0], _e1553.member_2[1], _e1553.member_2[2], _e1553.member_2[3]));
                            let _e1575 = local_8.member[0u];
                            let _e1578 = local_8.member_1[0u];
                            let _e1581 = local_8.member[0u];
                            let _e1587 = local_8.member_2[0u];
                            if (((_e1575 + ((_e1578 - _e1581) * _e326)) - _e1587) > 0f) {
                                let _e1592 = local_8.member[1u];
                                let _e1595 = local_8.member_1[1u];
                                let _e1598 = local_8.member[1u];
                                let _e1604 = local_8.member_2[1u];
                                if (((_e1592 + ((_e1595 - _e1598) * _e326)) - _e1604) > 0f) {
                                    let _e1609 = local_8.member[2u];
                                    let _e1612 = local_8.member_1[2u];
                                    let _e1615 = local_8.member[2u];
                                    let _e1621 = local_8.member_2[2u];
                                    if (((_e1609 + ((_e1612 - _e1615) * _e326)) - _e1621) > 0f) {
                                        let _e1626 = local_8.member[3u];
                                        let _e1629 = local_8.member_1[3u];
                                        let _e1632 = local_8.member[3u];
                                        let _e1638 = local_8.member_2[3u];
                                        phi_9174_ = (((_e1626 + ((_e1629 - _e1632) * _e326)) - _e1638) > 0f);
                                        phi_9175_ = false;
                                    } else {
                                        phi_9174_ = bool();
                                        phi_9175_ = true;
                                    }
                                    let _e1642 = phi_9174_;
                                    let _e1644 = phi_9175_;
                                    phi_9176_ = _e1642;
                                    phi_9177_ = _e1644;
                                } else {
                                    phi_9176_ = bool();
                                    phi_9177_ = true;
                                }
                                let _e1646 = phi_9176_;
                                let _e1648 = phi_9177_;
                                phi_9178_ = _e1646;
                                phi_9179_ = _e1648;
                            } else {
                                phi_9178_ = bool();
                                phi_9179_ = true;
                            }
                            let _e1650 = phi_9178_;
                            let _e1652 = phi_9179_;
                            if _e1652 {
                                phi_9183_ = false;
                            } else {
                                phi_9183_ = _e1650;
                            }
                            let _e1654 = phi_9183_;
                            if _e1654 {
                                phi_10537_ = bool();
                                phi_10538_ = true;
                            } else {
                                if (_e1361[0] < 0f) {
                                    phi_9210_ = -(_e1361[0]);
                                } else {
                                    phi_9210_ = _e1361[0];
                                }
                                let _e1659 = phi_9210_;
                                let _e1661 = ((_e1659 + 0f) + 0f);
                                if (_e1661 > 0f) {
                                    if ((bitcast<u32>(_e1661) & 2139095040u) != 2139095040u) {
                                        let _e1666 = (1f / _e1661);
                                        let _e1667 = (_e1361[0] * _e1666);
                                        let _e1668 = (0f * _e1666);
                                        let _e1669 = (0f * _e1666);
                                        let _e1674 = (((_e1667 * _e1667) + (_e1668 * _e1668)) + (_e1669 * _e1669));
                                        if (_e1674 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1674 > 0f) {
                                                phi_9257_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9257_ = 0f;
                                            }
                                            let _e1727 = phi_9257_;
                                            phi_9321_ = _e1727;
                                        } else {
                                            phi_9264_ = type_14(0i, 5i);
                                            phi_9267_ = bitcast<f32>(((bitcast<u32>(_e1674) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1682 = phi_9264_;
                                                let _e1684 = phi_9267_;
                                                local_20 = _e1684;
                                                if (_e1682.member < _e1682.member_1) {
                                                    let _e1691 = (_e1682.member + 1i);
                                                    if ((false == (_e1691 > _e1682.member)) != false) {
                                                        phi_9288_ = true;
                                                    } else {
                                                        phi_9288_ = false;
                                                    }
                                                    let _e1696 = phi_9288_;
                                                    if _e1696 {
                                                        phi_9294_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9294_ = type_15(1u, _e1691);
                                                    }
                                                    let _e1701 = phi_9294_;
                                                    phi_9265_ = type_14(_e1701.member_1, _e1682.member_1);
                                                    phi_9308_ = type_15(1u, _e1682.member);
                                                } else {
                                                    phi_9265_ = _e1682;
                                                    phi_9308_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1707 = phi_9265_;
                                                let _e1709 = phi_9308_;
                                                let _e1712 = (bitcast<i32>(_e1709.member) != 0i);
                                                if _e1712 {
                                                    phi_9268_ = (0.5f * (_e1684 + (_e1674 / _e1684)));
                                                } else {
                                                    phi_9268_ = f32();
                                                }
                                                let _e1717 = phi_9268_;
                                                continue;
                                                continuing {
                                                    phi_9264_ = _e1707;
                                                    phi_9267_ = _e1717;
                                                    break if !(_e1712);
                                                }
                                            }
                                            let _e1722 = local_20;
                                            phi_9321_ = (_e1722 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1729 = phi_9321_;
                                        let _e1730 = (0.000000059604645f * 12f);
                                        let _e1735 = ((_e1294 * 1.01f) + ((0f * _e1729) * (1f + _e1730)));
                                        let _e1740 = (((_e1667 * _e1071[0]) + (_e1668 * _e1071[1])) + (_e1669 * _e1071[2]));
                                        let _e1745 = (((_e1667 * _e1087) + (_e1668 * _e1088)) + (_e1669 * _e1089));
                                        let _e1750 = (((_e1667 * _e1093) + (_e1668 * _e1094)) + (_e1669 * _e1095));
                                        let _e1755 = (((_e1667 * _e1090) + (_e1668 * _e1091)) + (_e1669 * _e1092));
                                        let _e1761 = (((_e1667 * _e1098[0]) + (_e1668 * _e1098[1])) + (_e1669 * _e1098[2]));
                                        let _e1766 = (((_e1667 * _e1114) + (_e1668 * _e1115)) + (_e1669 * _e1116));
                                        let _e1771 = (((_e1667 * _e1120) + (_e1668 * _e1121)) + (_e1669 * _e1122));
                                        let _e1776 = (((_e1667 * _e1117) + (_e1668 * _e1118)) + (_e1669 * _e1119));
                                        if (_e1740 < 0f) {
                                            phi_9387_ = -(_e1740);
                                        } else {
                                            phi_9387_ = _e1740;
                                        }
                                        let _e1781 = phi_9387_;
                                        if (_e1761 < 0f) {
                                            phi_9393_ = -(_e1761);
                                        } else {
                                            phi_9393_ = _e1761;
                                        }
                                        let _e1785 = phi_9393_;
                                        if (_e1745 < 0f) {
                                            phi_9402_ = -(_e1745);
                                        } else {
                                            phi_9402_ = _e1745;
                                        }
                                        let _e1792 = phi_9402_;
                                        if (_e1766 < 0f) {
                                            phi_9408_ = -(_e1766);
                                        } else {
                                            phi_9408_ = _e1766;
                                        }
                                        let _e1796 = phi_9408_;
                                        if (_e1750 < 0f) {
                                            phi_9417_ = -(_e1750);
                                        } else {
                                            phi_9417_ = _e1750;
                                        }
                                        let _e1803 = phi_9417_;
                                        if (_e1771 < 0f) {
                                            phi_9423_ = -(_e1771);
                                        } else {
                                            phi_9423_ = _e1771;
                                        }
                                        let _e1807 = phi_9423_;
                                        if (_e1755 < 0f) {
                                            phi_9432_ = -(_e1755);
                                        } else {
                                            phi_9432_ = _e1755;
                                        }
                                        let _e1814 = phi_9432_;
                                        if (_e1776 < 0f) {
                                            phi_9438_ = -(_e1776);
                                        } else {
                                            phi_9438_ = _e1776;
                                        }
                                        let _e1818 = phi_9438_;
                                        phi_9444_ = type_32(array<f32, 4>(_e1740, _e1745, _e1750, _e1755), array<f32, 4>(_e1761, _e1766, _e1771, _e1776), array<f32, 4>((_e1735 + ((_e1781 + _e1785) * _e1730)), (_e1735 + ((_e1792 + _e1796) * _e1730)), (_e1735 + ((_e1803 + _e1807) * _e1730)), (_e1735 + ((_e1814 + _e1818) * _e1730))));
                                        phi_9445_ = false;
                                    } else {
                                        phi_9444_ = type_32();
                                        phi_9445_ = true;
                                    }
                                    let _e1825 = phi_9444_;
                                    let _e1827 = phi_9445_;
                                    phi_9446_ = _e1825;
                                    phi_9447_ = _e1827;
                                } else {
                                    phi_9446_ = type_32();
                                    phi_9447_ = true;
                                }
                                let _e1829 = phi_9446_;
                                let _e1831 = phi_9447_;
                                if _e1831 {
                                    phi_9455_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9455_ = _e1829;
                                }
                                let _e1833 = phi_9455_;
                                local_9 = type_32(array<f32, 4>(_e1833.member[0], _e1833.member[1], _e1833.member[2], _e1833.member[3]), array<f32, 4>(_e1833.member_1[0], _e1833.member_1[1], _e1833.member_1[2], _e1833.member_1[3]), array<f32, 4>(_e1833.member_2[0], _e1833.member_2[1], _e1833.member_2[2], _e1833.member_2[3]));
                                let _e1855 = local_9.member[0u];
                                let _e1858 = local_9.member_1[0u];
                                let _e1861 = local_9.member[0u];
                                let _e1867 = local_9.member_2[0u];
                                if (((_e1855 + ((_e1858 - _e1861) * _e326)) - _e1867) > 0f) {
                                    let _e1872 = local_9.member[1u];
                                    let _e1875 = local_9.member_1[1u];
                                    let _e1878 = local_9.member[1u];
                                    let _e1884 = local_9.member_2[1u];
                                    if (((_e1872 + ((_e1875 - _e1878) * _e326)) - _e1884) > 0f) {
                                        let _e1889 = local_9.member[2u];
                                        let _e1892 = local_9.member_1[2u];
                                        let _e1895 = local_9.member[2u];
                                        let _e1901 = local_9.member_2[2u];
                                        if (((_e1889 + ((_e1892 - _e1895) * _e326)) - _e1901) > 0f) {
                                            let _e1906 = local_9.member[3u];
                                            let _e1909 = local_9.member_1[3u];
                                            let _e1912 = local_9.member[3u];
                                            let _e1918 = local_9.member_2[3u];
                                            phi_9624_ = (((_e1906 + ((_e1909 - _e1912) * _e326)) - _e1918) > 0f);
                                            phi_9625_ = false;
                                        } else {
                                            phi_9624_ = bool();
                                            phi_9625_ = true;
                                        }
                                        let _e1922 = phi_9624_;
                                        let _e1924 = phi_9625_;
                                        phi_9626_ = _e1922;
                                        phi_9627_ = _e1924;
                                    } else {
                                        phi_9626_ = bool();
                                        phi_9627_ = true;
                                    }
                                    let _e1926 = phi_9626_;
                                    let _e1928 = phi_9627_;
                                    phi_9628_ = _e1926;
                                    phi_9629_ = _e1928;
                                } else {
                                    phi_9628_ = bool();
                                    phi_9629_ = true;
                                }
                                let _e1930 = phi_9628_;
                                let _e1932 = phi_9629_;
                                if _e1932 {
                                    phi_9633_ = false;
                                } else {
                                    phi_9633_ = _e1930;
                                }
                                let _e1934 = phi_9633_;
                                if _e1934 {
                                    phi_10535_ = bool();
                                    phi_10536_ = true;
                                } else {
                                    if (_e1361[1] < 0f) {
                                        phi_9666_ = -(_e1361[1]);
                                    } else {
                                        phi_9666_ = _e1361[1];
                                    }
                                    let _e1939 = phi_9666_;
                                    let _e1941 = ((0f + _e1939) + 0f);
                                    if (_e1941 > 0f) {
                                        if ((bitcast<u32>(_e1941) & 2139095040u) != 2139095040u) {
                                            let _e1946 = (1f / _e1941);
                                            let _e1947 = (0f * _e1946);
                                            let _e1948 = (_e1361[1] * _e1946);
                                            let _e1949 = (0f * _e1946);
                                            let _e1954 = (((_e1947 * _e1947) + (_e1948 * _e1948)) + (_e1949 * _e1949));
                                            if (_e1954 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1954 > 0f) {
                                                    phi_9707_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_9707_ = 0f;
                                                }
                                                let _e2007 = phi_9707_;
                                                phi_9771_ = _e2007;
                                            } else {
                                                phi_9714_ = type_14(0i, 5i);
                                                phi_9717_ = bitcast<f32>(((bitcast<u32>(_e1954) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1962 = phi_9714_;
                                                    let _e1964 = phi_9717_;
                                                    local_21 = _e1964;
                                                    if (_e1962.member < _e1962.member_1) {
                                                        let _e1971 = (_e1962.member + 1i);
                                                        if ((false == (_e1971 > _e1962.member)) != false) {
                                                            phi_9738_ = true;
                                                        } else {
                                                            phi_9738_ = false;
                                                        }
                                                        let _e1976 = phi_9738_;
                                                        if _e1976 {
                                                            phi_9744_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_9744_ = type_15(1u, _e1971);
                                                        }
                                                        let _e1981 = phi_9744_;
                                                        phi_9715_ = type_14(_e1981.member_1, _e1962.member_1);
                                                        phi_9758_ = type_15(1u, _e1962.member);
                                                    } else {
                                                        phi_9715_ = _e1962;
                                                        phi_9758_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1987 = phi_9715_;
                                                    let _e1989 = phi_9758_;
                                                    let _e1992 = (bitcast<i32>(_e1989.member) != 0i);
                                                    if _e1992 {
                                                        phi_9718_ = (0.5f * (_e1964 + (_e1954 / _e1964)));
                                                    } else {
                                                        phi_9718_ = f32();
                                                    }
                                                    let _e1997 = phi_9718_;
                                                    continue;
                                                    continuing {
                                                        phi_9714_ = _e1987;
                                                        phi_9717_ = _e1997;
                                                        break if !(_e1992);
                                                    }
                                                }
                                                let _e2002 = local_21;
                                                phi_9771_ = (_e2002 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e2009 = phi_9771_;
                                            let _e2010 = (0.000000059604645f * 12f);
                                            let _e2015 = ((_e1294 * 1.01f) + ((0f * _e2009) * (1f + _e2010)));
                                            let _e2020 = (((_e1947 * _e1071[0]) + (_e1948 * _e1071[1])) + (_e1949 * _e1071[2]));
                                            let _e2025 = (((_e1947 * _e1087) + (_e1948 * _e1088)) + (_e1949 * _e1089));
                                            let _e2030 = (((_e1947 * _e1093) + (_e1948 * _e1094)) + (_e1949 * _e1095));
                                            let _e2035 = (((_e1947 * _e1090) + (_e1948 * _e1091)) + (_e1949 * _e1092));
                                            let _e2041 = (((_e1947 * _e1098[0]) + (_e1948 * _e1098[1])) + (_e1949 * _e1098[2]));
                                            let _e2046 = (((_e1947 * _e1114) + (_e1948 * _e1115)) + (_e1949 * _e1116));
                                            let _e2051 = (((_e1947 * _e1120) + (_e1948 * _e1121)) + (_e1949 * _e1122));
                                            let _e2056 = (((_e1947 * _e1117) + (_e1948 * _e1118)) + (_e1949 * _e1119));
                                            if (_e2020 < 0f) {
                                                phi_9837_ = -(_e2020);
                                            } else {
                                                phi_9837_ = _e2020;
                                            }
                                            let _e2061 = phi_9837_;
                                            if (_e2041 < 0f) {
                                                phi_9843_ = -(_e2041);
                                            } else {
                                                phi_9843_ = _e2041;
                                            }
                                            let _e2065 = phi_9843_;
                                            if (_e2025 < 0f) {
                                                phi_9852_ = -(_e2025);
                                            } else {
                                                phi_9852_ = _e2025;
                                            }
                                            let _e2072 = phi_9852_;
                                            if (_e2046 < 0f) {
                                                phi_9858_ = -(_e2046);
                                            } else {
                                                phi_9858_ = _e2046;
                                            }
                                            let _e2076 = phi_9858_;
                                            if (_e2030 < 0f) {
                                                phi_9867_ = -(_e2030);
                                            } else {
                                                phi_9867_ = _e2030;
                                            }
                                            let _e2083 = phi_9867_;
                                            if (_e2051 < 0f) {
                                                phi_9873_ = -(_e2051);
                                            } else {
                                                phi_9873_ = _e2051;
                                            }
                                            let _e2087 = phi_9873_;
                                            if (_e2035 < 0f) {
                                                phi_9882_ = -(_e2035);
                                            } else {
                                                phi_9882_ = _e2035;
                                            }
                                            let _e2094 = phi_9882_;
                                            if (_e2056 < 0f) {
                                                phi_9888_ = -(_e2056);
                                            } else {
                                                phi_9888_ = _e2056;
                                            }
                                            let _e2098 = phi_9888_;
                                            phi_9894_ = type_32(array<f32, 4>(_e2020, _e2025, _e2030, _e2035), array<f32, 4>(_e2041, _e2046, _e2051, _e2056), array<f32, 4>((_e2015 + ((_e2061 + _e2065) * _e2010)), (_e2015 + ((_e2072 + _e2076) * _e2010)), (_e2015 + ((_e2083 + _e2087) * _e2010)), (_e2015 + ((_e2094 + _e2098) * _e2010))));
                                            phi_9895_ = false;
                                        } else {
                                            phi_9894_ = type_32();
                                            phi_9895_ = true;
                                        }
                                        let _e2105 = phi_9894_;
                                        let _e2107 = phi_9895_;
                                        phi_9896_ = _e2105;
                                        phi_9897_ = _e2107;
                                    } else {
                                        phi_9896_ = type_32();
                                        phi_9897_ = true;
                                    }
                                    let _e2109 = phi_9896_;
                                    let _e2111 = phi_9897_;
                                    if _e2111 {
                                        phi_9905_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_9905_ = _e2109;
                                    }
                                    let _e2113 = phi_9905_;
                                    local_10 = type_32(array<f32, 4>(_e2113.member[0], _e2113.member[1], _e2113.member[2], _e2113.member[3]), array<f32, 4>(_e2113.member_1[0], _e2113.member_1[1], _e2113.member_1[2], _e2113.member_1[3]), array<f32, 4>(_e2113.member_2[0], _e2113.member_2[1], _e2113.member_2[2], _e2113.member_2[3]));
                                    let _e2135 = local_10.member[0u];
                                    let _e2138 = local_10.member_1[0u];
                                    let _e2141 = local_10.member[0u];
                                    let _e2147 = local_10.member_2[0u];
                                    if (((_e2135 + ((_e2138 - _e2141) * _e326)) - _e2147) > 0f) {
                                        let _e2152 = local_10.member[1u];
                                        let _e2155 = local_10.member_1[1u];
                                        let _e2158 = local_10.member[1u];
                                        let _e2164 = local_10.member_2[1u];
                                        if (((_e2152 + ((_e2155 - _e2158) * _e326)) - _e2164) > 0f) {
                                            let _e2169 = local_10.member[2u];
                                            let _e2172 = local_10.member_1[2u];
                                            let _e2175 = local_10.member[2u];
                                            let _e2181 = local_10.member_2[2u];
                                            if (((_e2169 + ((_e2172 - _e2175) * _e326)) - _e2181) > 0f) {
                                                let _e2186 = local_10.member[3u];
                                                let _e2189 = local_10.member_1[3u];
                                                let _e2192 = local_10.member[3u];
                                                let _e2198 = local_10.member_2[3u];
                                                phi_10074_ = (((_e2186 + ((_e2189 - _e2192) * _e326)) - _e2198) > 0f);
                                                phi_10075_ = false;
                                            } else {
                                                phi_10074_ = bool();
                                                phi_10075_ = true;
                                            }
                                            let _e2202 = phi_10074_;
                                            let _e2204 = phi_10075_;
                                            phi_10076_ = _e2202;
                                            phi_10077_ = _e2204;
                                        } else {
                                            phi_10076_ = bool();
                                            phi_10077_ = true;
                                        }
                                        let _e2206 = phi_10076_;
                                        let _e2208 = phi_10077_;
                                        phi_10078_ = _e2206;
                                        phi_10079_ = _e2208;
                                    } else {
                                        phi_10078_ = bool();
                                        phi_10079_ = true;
                                    }
                                    let _e2210 = phi_10078_;
                                    let _e2212 = phi_10079_;
                                    if _e2212 {
                                        phi_10083_ = false;
                                    } else {
                                        phi_10083_ = _e2210;
                                    }
                                    let _e2214 = phi_10083_;
                                    if _e2214 {
                                        phi_10534_ = bool();
                                    } else {
                                        if (_e1361[2] < 0f) {
                                            phi_10123_ = -(_e1361[2]);
                                        } else {
                                            phi_10123_ = _e1361[2];
                                        }
                                        let _e2220 = phi_10123_;
                                        let _e2221 = ((0f + 0f) + _e2220);
                                        if (_e2221 > 0f) {
                                            if ((bitcast<u32>(_e2221) & 2139095040u) != 2139095040u) {
                                                let _e2226 = (1f / _e2221);
                                                let _e2227 = (0f * _e2226);
                                                let _e2228 = (0f * _e2226);
                                                let _e2229 = (_e1361[2] * _e2226);
                                                let _e2234 = (((_e2227 * _e2227) + (_e2228 * _e2228)) + (_e2229 * _e2229));
                                                if (_e2234 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2234 > 0f) {
                                                        phi_10157_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10157_ = 0f;
                                                    }
                                                    let _e2287 = phi_10157_;
                                                    phi_10221_ = _e2287;
                                                } else {
                                                    phi_10164_ = type_14(0i, 5i);
                                                    phi_10167_ = bitcast<f32>(((bitcast<u32>(_e2234) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2242 = phi_10164_;
                                                        let _e2244 = phi_10167_;
                                                        local_22 = _e2244;
                                                        if (_e2242.member < _e2242.member_1) {
                                                            let _e2251 = (_e2242.member + 1i);
                                                            if ((false == (_e2251 > _e2242.member)) != false) {
                                                                phi_10188_ = true;
                                                            } else {
                                                                phi_10188_ = false;
                                                            }
                                                            let _e2256 = phi_10188_;
                                                            if _e2256 {
                                                                phi_10194_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10194_ = type_15(1u, _e2251);
                                                            }
                                                            let _e2261 = phi_10194_;
                                                            phi_10165_ = type_14(_e2261.member_1, _e2242.member_1);
                                                            phi_10208_ = type_15(1u, _e2242.member);
                                                        } else {
                                                            phi_10165_ = _e2242;
                                                            phi_10208_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2267 = phi_10165_;
                                                        let _e2269 = phi_10208_;
                                                        let _e2272 = (bitcast<i32>(_e2269.member) != 0i);
                                                        if _e2272 {
                                                            phi_10168_ = (0.5f * (_e2244 + (_e2234 / _e2244)));
                                                        } else {
                                                            phi_10168_ = f32();
                                                        }
                                                        let _e2277 = phi_10168_;
                                                        continue;
                                                        continuing {
                                                            phi_10164_ = _e2267;
                                                            phi_10167_ = _e2277;
                                                            break if !(_e2272);
                                                        }
                                                    }
                                                    let _e2282 = local_22;
                                                    phi_10221_ = (_e2282 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2289 = phi_10221_;
                                                let _e2290 = (0.000000059604645f * 12f);
                                                let _e2295 = ((_e1294 * 1.01f) + ((0f * _e2289) * (1f + _e2290)));
                                                let _e2300 = (((_e2227 * _e1071[0]) + (_e2228 * _e1071[1])) + (_e2229 * _e1071[2]));
                                                let _e2305 = (((_e2227 * _e1087) + (_e2228 * _e1088)) + (_e2229 * _e1089));
                                                let _e2310 = (((_e2227 * _e1093) + (_e2228 * _e1094)) + (_e2229 * _e1095));
                                                let _e2315 = (((_e2227 * _e1090) + (_e2228 * _e1091)) + (_e2229 * _e1092));
                                                let _e2321 = (((_e2227 * _e1098[0]) + (_e2228 * _e1098[1])) + (_e2229 * _e1098[2]));
                                                let _e2326 = (((_e2227 * _e1114) + (_e2228 * _e1115)) + (_e2229 * _e1116));
                                                let _e2331 = (((_e2227 * _e1120) + (_e2228 * _e1121)) + (_e2229 * _e1122));
                                                let _e2336 = (((_e2227 * _e1117) + (_e2228 * _e1118)) + (_e2229 * _e1119));
                                                if (_e2300 < 0f) {
                                                    phi_10287_ = -(_e2300);
                                                } else {
                                                    phi_10287_ = _e2300;
                                                }
                                                let _e2341 = phi_10287_;
                                                if (_e2321 < 0f) {
                                                    phi_10293_ = -(_e2321);
                                                } else {
                                                    phi_10293_ = _e2321;
                                                }
                                                let _e2345 = phi_10293_;
                                                if (_e2305 < 0f) {
                                                    phi_10302_ = -(_e2305);
                                                } else {
                                                    phi_10302_ = _e2305;
                                                }
                                                let _e2352 = phi_10302_;
                                                if (_e2326 < 0f) {
                                                    phi_10308_ = -(_e2326);
                                                } else {
                                                    phi_10308_ = _e2326;
                                                }
                                                let _e2356 = phi_10308_;
                                                if (_e2310 < 0f) {
                                                    phi_10317_ = -(_e2310);
                                                } else {
                                                    phi_10317_ = _e2310;
                                                }
                                                let _e2363 = phi_10317_;
                                                if (_e2331 < 0f) {
                                                    phi_10323_ = -(_e2331);
                                                } else {
                                                    phi_10323_ = _e2331;
                                                }
                                                let _e2367 = phi_10323_;
                                                if (_e2315 < 0f) {
                                                    phi_10332_ = -(_e2315);
                                                } else {
                                                    phi_10332_ = _e2315;
                                                }
                                                let _e2374 = phi_10332_;
                                                if (_e2336 < 0f) {
                                                    phi_10338_ = -(_e2336);
                                                } else {
                                                    phi_10338_ = _e2336;
                                                }
                                                let _e2378 = phi_10338_;
                                                phi_10344_ = type_32(array<f32, 4>(_e2300, _e2305, _e2310, _e2315), array<f32, 4>(_e2321, _e2326, _e2331, _e2336), array<f32, 4>((_e2295 + ((_e2341 + _e2345) * _e2290)), (_e2295 + ((_e2352 + _e2356) * _e2290)), (_e2295 + ((_e2363 + _e2367) * _e2290)), (_e2295 + ((_e2374 + _e2378) * _e2290))));
                                                phi_10345_ = false;
                                            } else {
                                                phi_10344_ = type_32();
                                                phi_10345_ = true;
                                            }
                                            let _e2385 = phi_10344_;
                                            let _e2387 = phi_10345_;
                                            phi_10346_ = _e2385;
                                            phi_10347_ = _e2387;
                                        } else {
                                            phi_10346_ = type_32();
                                            phi_10347_ = true;
                                        }
                                        let _e2389 = phi_10346_;
                                        let _e2391 = phi_10347_;
                                        if _e2391 {
                                            phi_10355_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10355_ = _e2389;
                                        }
                                        let _e2393 = phi_10355_;
                                        local_11 = type_32(array<f32, 4>(_e2393.member[0], _e2393.member[1], _e2393.member[2], _e2393.member[3]), array<f32, 4>(_e2393.member_1[0], _e2393.member_1[1], _e2393.member_1[2], _e2393.member_1[3]), array<f32, 4>(_e2393.member_2[0], _e2393.member_2[1], _e2393.member_2[2], _e2393.member_2[3]));
                                        let _e2415 = local_11.member[0u];
                                        let _e2418 = local_11.member_1[0u];
                                        let _e2421 = local_11.member[0u];
                                        let _e2427 = local_11.member_2[0u];
                                        if (((_e2415 + ((_e2418 - _e2421) * _e326)) - _e2427) > 0f) {
                                            let _e2432 = local_11.member[1u];
                                            let _e2435 = local_11.member_1[1u];
                                            let _e2438 = local_11.member[1u];
                                            let _e2444 = local_11.member_2[1u];
                                            if (((_e2432 + ((_e2435 - _e2438) * _e326)) - _e2444) > 0f) {
                                                let _e2449 = local_11.member[2u];
                                                let _e2452 = local_11.member_1[2u];
                                                let _e2455 = local_11.member[2u];
                                                let _e2461 = local_11.member_2[2u];
                                                if (((_e2449 + ((_e2452 - _e2455) * _e326)) - _e2461) > 0f) {
                                                    let _e2466 = local_11.member[3u];
                                                    let _e2469 = local_11.member_1[3u];
                                                    let _e2472 = local_11.member[3u];
                                                    let _e2478 = local_11.member_2[3u];
                                                    phi_10524_ = (((_e2466 + ((_e2469 - _e2472) * _e326)) - _e2478) > 0f);
                                                    phi_10525_ = false;
                                                } else {
                                                    phi_10524_ = bool();
                                                    phi_10525_ = true;
                                                }
                                                let _e2482 = phi_10524_;
                                                let _e2484 = phi_10525_;
                                                phi_10526_ = _e2482;
                                                phi_10527_ = _e2484;
                                            } else {
                                                phi_10526_ = bool();
                                                phi_10527_ = true;
                                            }
                                            let _e2486 = phi_10526_;
                                            let _e2488 = phi_10527_;
                                            phi_10528_ = _e2486;
                                            phi_10529_ = _e2488;
                                        } else {
                                            phi_10528_ = bool();
                                            phi_10529_ = true;
                                        }
                                        let _e2490 = phi_10528_;
                                        let _e2492 = phi_10529_;
                                        if _e2492 {
                                            phi_10533_ = false;
                                        } else {
                                            phi_10533_ = _e2490;
                                        }
                                        let _e2494 = phi_10533_;
                                        phi_10534_ = _e2494;
                                    }
                                    let _e2496 = phi_10534_;
                                    phi_10535_ = _e2496;
                                    phi_10536_ = _e2214;
                                }
                                let _e2498 = phi_10535_;
                                let _e2500 = phi_10536_;
                                phi_10537_ = _e2498;
                                phi_10538_ = _e2500;
                            }
                            let _e2502 = phi_10537_;
                            let _e2504 = phi_10538_;
                            if _e2504 {
                                phi_10542_ = true;
                            } else {
                                phi_10542_ = _e2502;
                            }
                            let _e2506 = phi_10542_;
                            if !(_e2506) {
                                phi_10548_ = type_30(2u, _e326);
                                phi_10549_ = false;
                            } else {
                                phi_10548_ = type_30();
                                phi_10549_ = true;
                            }
                            let _e2510 = phi_10548_;
                            let _e2512 = phi_10549_;
                            phi_10550_ = _e2510;
                            phi_10551_ = _e2512;
                        } else {
                            phi_10550_ = type_30();
                            phi_10551_ = true;
                        }
                        let _e2514 = phi_10550_;
                        let _e2516 = phi_10551_;
                        if _e2516 {
                            let _e2522 = ((_e692 - (3f * _e669)) * _e1046);
                            let _e2523 = ((_e715 - _e692) * _e1046);
                            let _e2524 = (((3f * _e726) - _e715) * _e1046);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2531 = ((_e2523 * _e2523) - (_e2522 * _e2524));
                            if (_e2531 > 0f) {
                                if (_e2531 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2531 > 0f) {
                                        phi_10587_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_10587_ = 0f;
                                    }
                                    let _e2585 = phi_10587_;
                                    phi_10651_ = _e2585;
                                } else {
                                    phi_10594_ = type_14(0i, 5i);
                                    phi_10597_ = bitcast<f32>(((bitcast<u32>(_e2531) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2540 = phi_10594_;
                                        let _e2542 = phi_10597_;
                                        local_23 = _e2542;
                                        if (_e2540.member < _e2540.member_1) {
                                            let _e2549 = (_e2540.member + 1i);
                                            if ((false == (_e2549 > _e2540.member)) != false) {
                                                phi_10618_ = true;
                                            } else {
                                                phi_10618_ = false;
                                            }
                                            let _e2554 = phi_10618_;
                                            if _e2554 {
                                                phi_10624_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_10624_ = type_15(1u, _e2549);
                                            }
                                            let _e2559 = phi_10624_;
                                            phi_10595_ = type_14(_e2559.member_1, _e2540.member_1);
                                            phi_10638_ = type_15(1u, _e2540.member);
                                        } else {
                                            phi_10595_ = _e2540;
                                            phi_10638_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2565 = phi_10595_;
                                        let _e2567 = phi_10638_;
                                        let _e2570 = (bitcast<i32>(_e2567.member) != 0i);
                                        if _e2570 {
                                            phi_10598_ = (0.5f * (_e2542 + (_e2531 / _e2542)));
                                        } else {
                                            phi_10598_ = f32();
                                        }
                                        let _e2575 = phi_10598_;
                                        continue;
                                        continuing {
                                            phi_10594_ = _e2565;
                                            phi_10597_ = _e2575;
                                            break if !(_e2570);
                                        }
                                    }
                                    let _e2580 = local_23;
                                    phi_10651_ = (_e2580 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2587 = phi_10651_;
                                if (_e2523 < 0f) {
                                    phi_10657_ = -(_e2587);
                                } else {
                                    phi_10657_ = _e2587;
                                }
                                let _e2591 = phi_10657_;
                                let _e2593 = -((_e2523 + _e2591));
                                local_7[0u] = (_e2593 / (_e2593 + _e2524));
                                local_7[1u] = (_e2522 / (_e2522 + _e2593));
                                let _e2602 = local_7[1u];
                                let _e2603 = local_7[0u];
                                if (_e2602 < _e2603) {
                                    let _e2606 = local_7[1u];
                                    let _e2608 = local_7[0u];
                                    local_7[0u] = _e2606;
                                    local_7[1u] = _e2608;
                                }
                                phi_10682_ = type_12(0u, 2u);
                                phi_10685_ = 1u;
                                loop {
                                    let _e2612 = phi_10682_;
                                    let _e2614 = phi_10685_;
                                    local_63 = _e2614;
                                    if (_e2612.member < _e2612.member_1) {
                                        phi_10683_ = type_12((_e2612.member + 1u), _e2612.member_1);
                                        phi_10708_ = type_12(1u, _e2612.member);
                                    } else {
                                        phi_10683_ = _e2612;
                                        phi_10708_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2626 = phi_10683_;
                                    let _e2628 = phi_10708_;
                                    let _e2632 = (bitcast<i32>(_e2628.member) != 0i);
                                    if _e2632 {
                                        let _e2634 = local_7[_e2628.member_1];
                                        if (_e2634 > 0f) {
                                            let _e2637 = local_7[_e2628.member_1];
                                            if (_e2637 < 1f) {
                                                let _e2640 = local_7[_e2628.member_1];
                                                local_6[_e2614] = _e2640;
                                                phi_10752_ = (_e2614 + 1u);
                                            } else {
                                                phi_10752_ = _e2614;
                                            }
                                            let _e2644 = phi_10752_;
                                            phi_10753_ = _e2644;
                                        } else {
                                            phi_10753_ = _e2614;
                                        }
                                        let _e2646 = phi_10753_;
                                        phi_10686_ = _e2646;
                                    } else {
                                        phi_10686_ = u32();
                                    }
                                    let _e2648 = phi_10686_;
                                    continue;
                                    continuing {
                                        phi_10682_ = _e2626;
                                        phi_10685_ = _e2648;
                                        break if !(_e2632);
                                    }
                                }
                                let _e10216 = local_63;
                                phi_10754_ = _e10216;
                            } else {
                                phi_10754_ = 1u;
                            }
                            let _e2651 = phi_10754_;
                            local_6[_e2651] = 1f;
                            let _e2653 = local_6;
                            local_12 = _e2653;
                            phi_10774_ = type_12(0u, _e2651);
                            loop {
                                let _e2656 = phi_10774_;
                                if (_e2656.member < _e2656.member_1) {
                                    phi_10775_ = type_12((_e2656.member + 1u), _e2656.member_1);
                                    phi_10798_ = type_12(1u, _e2656.member);
                                } else {
                                    phi_10775_ = _e2656;
                                    phi_10798_ = type_12(0u, type_12().member_1);
                                }
                                let _e2668 = phi_10775_;
                                let _e2670 = phi_10798_;
                                if (bitcast<i32>(_e2670.member) != 0i) {
                                    let _e2676 = local_12[_e2670.member_1];
                                    if (_e2676 > _e326) {
                                        phi_10817_ = _e2676;
                                    } else {
                                        phi_10817_ = _e326;
                                    }
                                    let _e2679 = phi_10817_;
                                    let _e2682 = local_12[(_e2670.member_1 + 1u)];
                                    if (_e2682 < _e328) {
                                        phi_10830_ = _e2682;
                                    } else {
                                        phi_10830_ = _e328;
                                    }
                                    let _e2685 = phi_10830_;
                                    if (_e2679 <= _e2685) {
                                        let _e2687 = (1f - _e2679);
                                        let _e2698 = ((((_e669 * _e2687) + (_e692 * _e2679)) * (_e2687 * _e2687)) + (((_e715 * _e2687) + (_e726 * _e2679)) * (_e2679 * _e2679)));
                                        let _e2699 = (1f - _e2685);
                                        let _e2710 = ((((_e669 * _e2699) + (_e692 * _e2685)) * (_e2699 * _e2699)) + (((_e715 * _e2699) + (_e726 * _e2685)) * (_e2685 * _e2685)));
                                        if (_e2698 < 0f) {
                                            phi_10864_ = -(_e2698);
                                        } else {
                                            phi_10864_ = _e2698;
                                        }
                                        let _e2714 = phi_10864_;
                                        let _e2715 = (_e2714 > _e1043);
                                        if (_e2710 < 0f) {
                                            phi_10871_ = -(_e2710);
                                        } else {
                                            phi_10871_ = _e2710;
                                        }
                                        let _e2719 = phi_10871_;
                                        let _e2720 = (_e2719 > _e1043);
                                        if _e2715 {
                                            if _e2720 {
                                                phi_10882_ = ((_e2698 > 0f) != (_e2710 > 0f));
                                                phi_10883_ = false;
                                            } else {
                                                phi_10882_ = bool();
                                                phi_10883_ = true;
                                            }
                                            let _e2725 = phi_10882_;
                                            let _e2727 = phi_10883_;
                                            phi_10884_ = _e2725;
                                            phi_10885_ = _e2727;
                                        } else {
                                            phi_10884_ = bool();
                                            phi_10885_ = true;
                                        }
                                        let _e2729 = phi_10884_;
                                        let _e2731 = phi_10885_;
                                        if _e2731 {
                                            phi_10889_ = false;
                                        } else {
                                            phi_10889_ = _e2729;
                                        }
                                        let _e2733 = phi_10889_;
                                        if _e2715 {
                                            if _e2720 {
                                                if _e2733 {
                                                    phi_10900_ = type_41();
                                                } else {
                                                    phi_10900_ = type_41(1f, 0f, _e2733);
                                                }
                                                let _e2736 = phi_10900_;
                                                phi_10901_ = _e2736;
                                                phi_10902_ = _e2733;
                                            } else {
                                                phi_10901_ = type_41();
                                                phi_10902_ = true;
                                            }
                                            let _e2738 = phi_10901_;
                                            let _e2740 = phi_10902_;
                                            phi_10903_ = _e2738;
                                            phi_10904_ = _e2740;
                                        } else {
                                            phi_10903_ = type_41();
                                            phi_10904_ = true;
                                        }
                                        let _e2742 = phi_10903_;
                                        let _e2744 = phi_10904_;
                                        if _e2744 {
                                            if _e2715 {
                                                if (_e2698 < 0f) {
                                                    phi_10915_ = -1f;
                                                } else {
                                                    phi_10915_ = 1f;
                                                }
                                                let _e2747 = phi_10915_;
                                                let _e2750 = (_e715 - _e692);
                                                phi_10925_ = type_12(0u, 64u);
                                                phi_10928_ = _e2685;
                                                phi_10930_ = _e2679;
                                                phi_10932_ = (0.5f * (_e2679 + _e2685));
                                                loop {
                                                    let _e2756 = phi_10925_;
                                                    let _e2758 = phi_10928_;
                                                    let _e2760 = phi_10930_;
                                                    let _e2762 = phi_10932_;
                                                    local_65 = _e2760;
                                                    if (_e2756.member < _e2756.member_1) {
                                                        phi_10926_ = type_12((_e2756.member + 1u), _e2756.member_1);
                                                        phi_10955_ = type_12(1u, _e2756.member);
                                                    } else {
                                                        phi_10926_ = _e2756;
                                                        phi_10955_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2774 = phi_10926_;
                                                    let _e2776 = phi_10955_;
                                                    if (bitcast<i32>(_e2776.member) != 0i) {
                                                        let _e2780 = (1f - _e2762);
                                                        let _e2793 = ((_e2747 * ((((_e669 * _e2780) + (_e692 * _e2762)) * (_e2780 * _e2780)) + (((_e715 * _e2780) + (_e726 * _e2762)) * (_e2762 * _e2762)))) - _e1043);
                                                        if (_e2793 > 0f) {
                                                            phi_10980_ = _e2758;
                                                            phi_10981_ = _e2762;
                                                        } else {
                                                            phi_10980_ = _e2762;
                                                            phi_10981_ = _e2760;
                                                        }
                                                        let _e2796 = phi_10980_;
                                                        let _e2798 = phi_10981_;
                                                        let _e2800 = ((_e2796 - _e2798) > _e1050);
                                                        if _e2800 {
                                                            let _e2801 = (1f - _e2762);
                                                            let _e2813 = (-(_e2793) / (_e2747 * (((((_e692 - (3f * _e669)) * _e2801) + (_e2750 * _e2762)) * _e2801) + (((_e2750 * _e2801) + (((3f * _e726) - _e715) * _e2762)) * _e2762))));
                                                            if (_e2793 > 0f) {
                                                                phi_11007_ = (0.5f * _e1050);
                                                            } else {
                                                                phi_11007_ = -((0.5f * _e1050));
                                                            }
                                                            let _e2819 = phi_11007_;
                                                            let _e2821 = ((_e2762 + _e2813) + _e2819);
                                                            if (_e2821 > _e2798) {
                                                                if (_e2821 < _e2796) {
                                                                    if (_e2813 < 0f) {
                                                                        phi_11023_ = -(_e2813);
                                                                    } else {
                                                                        phi_11023_ = _e2813;
                                                                    }
                                                                    let _e2827 = phi_11023_;
                                                                    if (_e2827 < (0.5f * (_e2796 - _e2798))) {
                                                                        phi_11030_ = false;
                                                                    } else {
                                                                        phi_11030_ = true;
                                                                    }
                                                                    let _e2832 = phi_11030_;
                                                                    phi_11031_ = _e2832;
                                                                } else {
                                                                    phi_11031_ = true;
                                                                }
                                                                let _e2834 = phi_11031_;
                                                                phi_11032_ = _e2834;
                                                            } else {
                                                                phi_11032_ = true;
                                                            }
                                                            let _e2836 = phi_11032_;
                                                            if _e2836 {
                                                                phi_11038_ = (0.5f * (_e2798 + _e2796));
                                                            } else {
                                                                phi_11038_ = _e2821;
                                                            }
                                                            let _e2840 = phi_11038_;
                                                            phi_11039_ = _e2840;
                                                            phi_11040_ = false;
                                                        } else {
                                                            phi_11039_ = f32();
                                                            phi_11040_ = true;
                                                        }
                                                        let _e2842 = phi_11039_;
                                                        let _e2844 = phi_11040_;
                                                        phi_10929_ = _e2796;
                                                        phi_10931_ = _e2798;
                                                        phi_10933_ = _e2842;
                                                        phi_11041_ = _e2798;
                                                        phi_11042_ = _e2800;
                                                        phi_11043_ = _e2844;
                                                    } else {
                                                        phi_10929_ = f32();
                                                        phi_10931_ = f32();
                                                        phi_10933_ = f32();
                                                        phi_11041_ = f32();
                                                        phi_11042_ = false;
                                                        phi_11043_ = false;
                                                    }
                                                    let _e2846 = phi_10929_;
                                                    let _e2848 = phi_10931_;
                                                    let _e2850 = phi_10933_;
                                                    let _e2852 = phi_11041_;
                                                    let _e2854 = phi_11042_;
                                                    let _e2856 = phi_11043_;
                                                    local_24 = _e2856;
                                                    local_64 = _e2852;
                                                    continue;
                                                    continuing {
                                                        phi_10925_ = _e2774;
                                                        phi_10928_ = _e2846;
                                                        phi_10930_ = _e2848;
                                                        phi_10932_ = _e2850;
                                                        break if !(_e2854);
                                                    }
                                                }
                                                let _e2859 = local_24;
                                                if _e2859 {
                                                    let _e10260 = local_64;
                                                    phi_11047_ = _e10260;
                                                } else {
                                                    let _e10262 = local_65;
                                                    phi_11047_ = _e10262;
                                                }
                                                let _e2861 = phi_11047_;
                                                phi_11048_ = _e2861;
                                            } else {
                                                phi_11048_ = _e2679;
                                            }
                                            let _e2863 = phi_11048_;
                                            if _e2720 {
                                                if (_e2710 < 0f) {
                                                    phi_11056_ = -1f;
                                                } else {
                                                    phi_11056_ = 1f;
                                                }
                                                let _e2866 = phi_11056_;
                                                phi_11060_ = type_12(0u, 64u);
                                                phi_11063_ = (_e1050 + _e1050);
                                                loop {
                                                    let _e2869 = phi_11060_;
                                                    let _e2871 = phi_11063_;
                                                    if (_e2869.member < _e2869.member_1) {
                                                        phi_11061_ = type_12((_e2869.member + 1u), _e2869.member_1);
                                                        phi_11086_ = type_12(1u, _e2869.member);
                                                    } else {
                                                        phi_11061_ = _e2869;
                                                        phi_11086_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2883 = phi_11061_;
                                                    let _e2885 = phi_11086_;
                                                    if (bitcast<i32>(_e2885.member) != 0i) {
                                                        let _e2889 = (_e2863 + _e2871);
                                                        if (_e2889 < _e2685) {
                                                            let _e2891 = (1f - _e2889);
                                                            let _e2904 = ((_e2866 * ((((_e669 * _e2891) + (_e692 * _e2889)) * (_e2891 * _e2891)) + (((_e715 * _e2891) + (_e726 * _e2889)) * (_e2889 * _e2889)))) > _e1043);
                                                            if _e2904 {
                                                                phi_11116_ = f32();
                                                                phi_11117_ = false;
                                                            } else {
                                                                phi_11116_ = (_e2871 + _e2871);
                                                                phi_11117_ = true;
                                                            }
                                                            let _e2907 = phi_11116_;
                                                            let _e2909 = phi_11117_;
                                                            phi_11118_ = _e2907;
                                                            phi_11119_ = _e2909;
                                                            phi_11120_ = _e2904;
                                                            phi_11121_ = false;
                                                        } else {
                                                            phi_11118_ = f32();
                                                            phi_11119_ = false;
                                                            phi_11120_ = false;
                                                            phi_11121_ = true;
                                                        }
                                                        let _e2911 = phi_11118_;
                                                        let _e2913 = phi_11119_;
                                                        let _e2915 = phi_11120_;
                                                        let _e2917 = phi_11121_;
                                                        phi_11122_ = _e2889;
                                                        phi_11064_ = _e2911;
                                                        phi_11123_ = _e2913;
                                                        phi_11124_ = _e2915;
                                                        phi_11125_ = _e2917;
                                                        phi_11126_ = false;
                                                    } else {
                                                        phi_11122_ = f32();
                                                        phi_11064_ = f32();
                                                        phi_11123_ = false;
                                                        phi_11124_ = false;
                                                        phi_11125_ = false;
                                                        phi_11126_ = true;
                                                    }
                                                    let _e2919 = phi_11122_;
                                                    let _e2921 = phi_11064_;
                                                    let _e2923 = phi_11123_;
                                                    let _e2925 = phi_11124_;
                                                    let _e2927 = phi_11125_;
                                                    let _e2929 = phi_11126_;
                                                    local_25 = _e2925;
                                                    local_66 = _e2927;
                                                    local_67 = _e2929;
                                                    local_68 = _e2919;
                                                    continue;
                                                    continuing {
                                                        phi_11060_ = _e2883;
                                                        phi_11063_ = _e2921;
                                                        break if !(_e2923);
                                                    }
                                                }
                                                let _e2932 = local_25;
                                                if _e2932 {
                                                    phi_11130_ = false;
                                                    phi_11131_ = false;
                                                } else {
                                                    let _e10284 = local_66;
                                                    phi_11130_ = _e10284;
                                                    let _e10287 = local_67;
                                                    phi_11131_ = _e10287;
                                                }
                                                let _e2934 = phi_11130_;
                                                let _e2936 = phi_11131_;
                                                if _e2934 {
                                                    phi_11135_ = true;
                                                } else {
                                                    phi_11135_ = _e2936;
                                                }
                                                let _e2938 = phi_11135_;
                                                if _e2938 {
                                                    phi_11139_ = _e2685;
                                                } else {
                                                    let _e10291 = local_68;
                                                    phi_11139_ = _e10291;
                                                }
                                                let _e2940 = phi_11139_;
                                                phi_11140_ = _e2940;
                                            } else {
                                                phi_11140_ = _e2685;
                                            }
                                            let _e2942 = phi_11140_;
                                            phi_11142_ = type_41(_e2863, _e2942, _e2733);
                                        } else {
                                            phi_11142_ = _e2742;
                                        }
                                        let _e2945 = phi_11142_;
                                        if (_e2945.member > _e2945.member_1) {
                                            phi_14935_ = bool();
                                            phi_14936_ = f32();
                                            phi_14937_ = f32();
                                            phi_14938_ = true;
                                            phi_14939_ = false;
                                            phi_14940_ = false;
                                            phi_14941_ = false;
                                        } else {
                                            let _e2952 = ((_e2945.member_1 - _e2945.member) * 0.5f);
                                            let _e2953 = (_e2945.member + _e2952);
                                            let _e2955 = (_e2952 + (0.000000059604645f * 4f));
                                            let _e2957 = local_18.member_3;
                                            let _e2960 = local_18.member[0u];
                                            if (_e2960[0] < 0f) {
                                                phi_11171_ = -(_e2960[0]);
                                            } else {
                                                phi_11171_ = _e2960[0];
                                            }
                                            let _e2967 = phi_11171_;
                                            if (_e2960[1] < 0f) {
                                                phi_11178_ = -(_e2960[1]);
                                            } else {
                                                phi_11178_ = _e2960[1];
                                            }
                                            let _e2971 = phi_11178_;
                                            if (_e2967 > _e2971) {
                                                phi_11183_ = _e2967;
                                            } else {
                                                phi_11183_ = _e2971;
                                            }
                                            let _e2974 = phi_11183_;
                                            if (_e2960[2] < 0f) {
                                                phi_11190_ = -(_e2960[2]);
                                            } else {
                                                phi_11190_ = _e2960[2];
                                            }
                                            let _e2978 = phi_11190_;
                                            if (_e2974 > _e2978) {
                                                phi_11195_ = _e2974;
                                            } else {
                                                phi_11195_ = _e2978;
                                            }
                                            let _e2981 = phi_11195_;
                                            let _e2983 = local_18.member[1u];
                                            if (_e2983[0] < 0f) {
                                                phi_11208_ = -(_e2983[0]);
                                            } else {
                                                phi_11208_ = _e2983[0];
                                            }
                                            let _e2990 = phi_11208_;
                                            if (_e2983[1] < 0f) {
                                                phi_11215_ = -(_e2983[1]);
                                            } else {
                                                phi_11215_ = _e2983[1];
                                            }
                                            let _e2994 = phi_11215_;
                                            if (_e2990 > _e2994) {
                                                phi_11220_ = _e2990;
                                            } else {
                                                phi_11220_ = _e2994;
                                            }
                                            let _e2997 = phi_11220_;
                                            if (_e2983[2] < 0f) {
                                                phi_11227_ = -(_e2983[2]);
                                            } else {
                                                phi_11227_ = _e2983[2];
                                            }
                                            let _e3001 = phi_11227_;
                                            if (_e2997 > _e3001) {
                                                phi_11232_ = _e2997;
                                            } else {
                                                phi_11232_ = _e3001;
                                            }
                                            let _e3004 = phi_11232_;
                                            if (_e2981 > _e3004) {
                                                phi_11237_ = _e2981;
                                            } else {
                                                phi_11237_ = _e3004;
                                            }
                                            let _e3007 = phi_11237_;
                                            let _e3010 = local_18.member[0u];
                                            let _e3015 = local_18.member[1u];
                                            let _e3025 = (_e3010[0] + ((_e3015[0] - _e3010[0]) * _e2953));
                                            let _e3026 = (_e3010[1] + ((_e3015[1] - _e3010[1]) * _e2953));
                                            let _e3027 = (_e3010[2] + ((_e3015[2] - _e3010[2]) * _e2953));
                                            let _e3029 = local_18.member[1u];
                                            let _e3034 = local_18.member[0u];
                                            let _e3038 = (_e3029[0] - _e3034[0]);
                                            let _e3039 = (_e3029[1] - _e3034[1]);
                                            let _e3040 = (_e3029[2] - _e3034[2]);
                                            if (_e3038 < 0f) {
                                                phi_11296_ = -(_e3038);
                                            } else {
                                                phi_11296_ = _e3038;
                                            }
                                            let _e3044 = phi_11296_;
                                            if (_e3039 < 0f) {
                                                phi_11302_ = -(_e3039);
                                            } else {
                                                phi_11302_ = _e3039;
                                            }
                                            let _e3048 = phi_11302_;
                                            if (_e3044 > _e3048) {
                                                phi_11307_ = _e3044;
                                            } else {
                                                phi_11307_ = _e3048;
                                            }
                                            let _e3051 = phi_11307_;
                                            if (_e3040 < 0f) {
                                                phi_11313_ = -(_e3040);
                                            } else {
                                                phi_11313_ = _e3040;
                                            }
                                            let _e3055 = phi_11313_;
                                            if (_e3051 > _e3055) {
                                                phi_11318_ = _e3051;
                                            } else {
                                                phi_11318_ = _e3055;
                                            }
                                            let _e3058 = phi_11318_;
                                            let _e3064 = ((((_e2955 * _e3058) * 1.01f) + ((_e3007 + _e2957) * (0.000000059604645f * 8f))) + _e2957);
                                            if (_e3025 < 0f) {
                                                phi_11330_ = -(_e3025);
                                            } else {
                                                phi_11330_ = _e3025;
                                            }
                                            let _e3068 = phi_11330_;
                                            if (_e3026 < 0f) {
                                                phi_11336_ = -(_e3026);
                                            } else {
                                                phi_11336_ = _e3026;
                                            }
                                            let _e3072 = phi_11336_;
                                            if (_e3068 > _e3072) {
                                                phi_11341_ = _e3068;
                                            } else {
                                                phi_11341_ = _e3072;
                                            }
                                            let _e3075 = phi_11341_;
                                            if (_e3027 < 0f) {
                                                phi_11347_ = -(_e3027);
                                            } else {
                                                phi_11347_ = _e3027;
                                            }
                                            let _e3079 = phi_11347_;
                                            if (_e3075 > _e3079) {
                                                phi_11352_ = _e3075;
                                            } else {
                                                phi_11352_ = _e3079;
                                            }
                                            let _e3082 = phi_11352_;
                                            local_2 = type_26(array<f32, 3>(_e3025, _e3026, _e3027), _e3064, (_e3082 + _e3064));
                                            let _e3088 = local_18.member_3;
                                            let _e3090 = local_18.member_1[0u];
                                            if (_e3090[0] < 0f) {
                                                phi_11378_ = -(_e3090[0]);
                                            } else {
                                                phi_11378_ = _e3090[0];
                                            }
                                            let _e3097 = phi_11378_;
                                            if (_e3090[1] < 0f) {
                                                phi_11385_ = -(_e3090[1]);
                                            } else {
                                                phi_11385_ = _e3090[1];
                                            }
                                            let _e3101 = phi_11385_;
                                            if (_e3097 > _e3101) {
                                                phi_11390_ = _e3097;
                                            } else {
                                                phi_11390_ = _e3101;
                                            }
                                            let _e3104 = phi_11390_;
                                            if (_e3090[2] < 0f) {
                                                phi_11397_ = -(_e3090[2]);
                                            } else {
                                                phi_11397_ = _e3090[2];
                                            }
                                            let _e3108 = phi_11397_;
                                            if (_e3104 > _e3108) {
                                                phi_11402_ = _e3104;
                                            } else {
                                                phi_11402_ = _e3108;
                                            }
                                            let _e3111 = phi_11402_;
                                            let _e3113 = local_18.member_1[1u];
                                            if (_e3113[0] < 0f) {
                                                phi_11415_ = -(_e3113[0]);
                                            } else {
                                                phi_11415_ = _e3113[0];
                                            }
                                            let _e3120 = phi_11415_;
                                            if (_e3113[1] < 0f) {
                                                phi_11422_ = -(_e3113[1]);
                                            } else {
                                                phi_11422_ = _e3113[1];
                                            }
                                            let _e3124 = phi_11422_;
                                            if (_e3120 > _e3124) {
                                                phi_11427_ = _e3120;
                                            } else {
                                                phi_11427_ = _e3124;
                                            }
                                            let _e3127 = phi_11427_;
                                            if (_e3113[2] < 0f) {
                                                phi_11434_ = -(_e3113[2]);
                                            } else {
                                                phi_11434_ = _e3113[2];
                                            }
                                            let _e3131 = phi_11434_;
                                            if (_e3127 > _e3131) {
                                                phi_11439_ = _e3127;
                                            } else {
                                                phi_11439_ = _e3131;
                                            }
                                            let _e3134 = phi_11439_;
                                            if (_e3111 > _e3134) {
                                                phi_11444_ = _e3111;
                                            } else {
                                                phi_11444_ = _e3134;
                                            }
                                            let _e3137 = phi_11444_;
                                            let _e3140 = local_18.member_1[0u];
                                            let _e3145 = local_18.member_1[1u];
                                            let _e3155 = (_e3140[0] + ((_e3145[0] - _e3140[0]) * _e2953));
                                            let _e3156 = (_e3140[1] + ((_e3145[1] - _e3140[1]) * _e2953));
                                            let _e3157 = (_e3140[2] + ((_e3145[2] - _e3140[2]) * _e2953));
                                            let _e3159 = local_18.member_1[1u];
                                            let _e3164 = local_18.member_1[0u];
                                            let _e3168 = (_e3159[0] - _e3164[0]);
                                            let _e3169 = (_e3159[1] - _e3164[1]);
                                            let _e3170 = (_e3159[2] - _e3164[2]);
                                            if (_e3168 < 0f) {
                                                phi_11503_ = -(_e3168);
                                            } else {
                                                phi_11503_ = _e3168;
                                            }
                                            let _e3174 = phi_11503_;
                                            if (_e3169 < 0f) {
                                                phi_11509_ = -(_e3169);
                                            } else {
                                                phi_11509_ = _e3169;
                                            }
                                            let _e3178 = phi_11509_;
                                            if (_e3174 > _e3178) {
                                                phi_11514_ = _e3174;
                                            } else {
                                                phi_11514_ = _e3178;
                                            }
                                            let _e3181 = phi_11514_;
                                            if (_e3170 < 0f) {
                                                phi_11520_ = -(_e3170);
                                            } else {
                                                phi_11520_ = _e3170;
                                            }
                                            let _e3185 = phi_11520_;
                                            if (_e3181 > _e3185) {
                                                phi_11525_ = _e3181;
                                            } else {
                                                phi_11525_ = _e3185;
                                            }
                                            let _e3188 = phi_11525_;
                                            let _e3194 = ((((_e2955 * _e3188) * 1.01f) + ((_e3137 + _e3088) * (0.000000059604645f * 8f))) + _e3088);
                                            if (_e3155 < 0f) {
                                                phi_11537_ = -(_e3155);
                                            } else {
                                                phi_11537_ = _e3155;
                                            }
                                            let _e3198 = phi_11537_;
                                            if (_e3156 < 0f) {
                                                phi_11543_ = -(_e3156);
                                            } else {
                                                phi_11543_ = _e3156;
                                            }
                                            let _e3202 = phi_11543_;
                                            if (_e3198 > _e3202) {
                                                phi_11548_ = _e3198;
                                            } else {
                                                phi_11548_ = _e3202;
                                            }
                                            let _e3205 = phi_11548_;
                                            if (_e3157 < 0f) {
                                                phi_11554_ = -(_e3157);
                                            } else {
                                                phi_11554_ = _e3157;
                                            }
                                            let _e3209 = phi_11554_;
                                            if (_e3205 > _e3209) {
                                                phi_11559_ = _e3205;
                                            } else {
                                                phi_11559_ = _e3209;
                                            }
                                            let _e3212 = phi_11559_;
                                            local_3 = type_26(array<f32, 3>(_e3155, _e3156, _e3157), _e3194, (_e3212 + _e3194));
                                            let _e3218 = local_18.member_3;
                                            let _e3220 = local_18.member_2[0u];
                                            if (_e3220[0] < 0f) {
                                                phi_11585_ = -(_e3220[0]);
                                            } else {
                                                phi_11585_ = _e3220[0];
                                            }
                                            let _e3227 = phi_11585_;
                                            if (_e3220[1] < 0f) {
                                                phi_11592_ = -(_e3220[1]);
                                            } else {
                                                phi_11592_ = _e3220[1];
                                            }
                                            let _e3231 = phi_11592_;
                                            if (_e3227 > _e3231) {
                                                phi_11597_ = _e3227;
                                            } else {
                                                phi_11597_ = _e3231;
                                            }
                                            let _e3234 = phi_11597_;
                                            if (_e3220[2] < 0f) {
                                                phi_11604_ = -(_e3220[2]);
                                            } else {
                                                phi_11604_ = _e3220[2];
                                            }
                                            let _e3238 = phi_11604_;
                                            if (_e3234 > _e3238) {
                                                phi_11609_ = _e3234;
                                            } else {
                                                phi_11609_ = _e3238;
                                            }
                                            let _e3241 = phi_11609_;
                                            let _e3243 = local_18.member_2[1u];
                                            if (_e3243[0] < 0f) {
                                                phi_11622_ = -(_e3243[0]);
                                            } else {
                                                phi_11622_ = _e3243[0];
                                            }
                                            let _e3250 = phi_11622_;
                                            if (_e3243[1] < 0f) {
                                                phi_11629_ = -(_e3243[1]);
                                            } else {
                                                phi_11629_ = _e3243[1];
                                            }
                                            let _e3254 = phi_11629_;
                                            if (_e3250 > _e3254) {
                                                phi_11634_ = _e3250;
                                            } else {
                                                phi_11634_ = _e3254;
                                            }
                                            let _e3257 = phi_11634_;
                                            if (_e3243[2] < 0f) {
                                                phi_11641_ = -(_e3243[2]);
                                            } else {
                                                phi_11641_ = _e3243[2];
                                            }
                                            let _e3261 = phi_11641_;
                                            if (_e3257 > _e3261) {
                                                phi_11646_ = _e3257;
                                            } else {
                                                phi_11646_ = _e3261;
                                            }
                                            let _e3264 = phi_11646_;
                                            if (_e3241 > _e3264) {
                                                phi_11651_ = _e3241;
                                            } else {
                                                phi_11651_ = _e3264;
                                            }
                                            let _e3267 = phi_11651_;
                                            let _e3270 = local_18.member_2[0u];
                                            let _e3275 = local_18.member_2[1u];
                                            let _e3285 = (_e3270[0] + ((_e3275[0] - _e3270[0]) * _e2953));
                                            let _e3286 = (_e3270[1] + ((_e3275[1] - _e3270[1]) * _e2953));
                                            let _e3287 = (_e3270[2] + ((_e3275[2] - _e3270[2]) * _e2953));
                                            let _e3289 = local_18.member_2[1u];
                                            let _e3294 = local_18.member_2[0u];
                                            let _e3298 = (_e3289[0] - _e3294[0]);
                                            let _e3299 = (_e3289[1] - _e3294[1]);
                                            let _e3300 = (_e3289[2] - _e3294[2]);
                                            if (_e3298 < 0f) {
                                                phi_11710_ = -(_e3298);
                                            } else {
                                                phi_11710_ = _e3298;
                                            }
                                            let _e3304 = phi_11710_;
                                            if (_e3299 < 0f) {
                                                phi_11716_ = -(_e3299);
                                            } else {
                                                phi_11716_ = _e3299;
                                            }
                                            let _e3308 = phi_11716_;
                                            if (_e3304 > _e3308) {
                                                phi_11721_ = _e3304;
                                            } else {
                                                phi_11721_ = _e3308;
                                            }
                                            let _e3311 = phi_11721_;
                                            if (_e3300 < 0f) {
                                                phi_11727_ = -(_e3300);
                                            } else {
                                                phi_11727_ = _e3300;
                                            }
                                            let _e3315 = phi_11727_;
                                            if (_e3311 > _e3315) {
                                                phi_11732_ = _e3311;
                                            } else {
                                                phi_11732_ = _e3315;
                                            }
                                            let _e3318 = phi_11732_;
                                            let _e3324 = ((((_e2955 * _e3318) * 1.01f) + ((_e3267 + _e3218) * (0.000000059604645f * 8f))) + _e3218);
                                            if (_e3285 < 0f) {
                                                phi_11744_ = -(_e3285);
                                            } else {
                                                phi_11744_ = _e3285;
                                            }
                                            let _e3328 = phi_11744_;
                                            if (_e3286 < 0f) {
                                                phi_11750_ = -(_e3286);
                                            } else {
                                                phi_11750_ = _e3286;
                                            }
                                            let _e3332 = phi_11750_;
                                            if (_e3328 > _e3332) {
                                                phi_11755_ = _e3328;
                                            } else {
                                                phi_11755_ = _e3332;
                                            }
                                            let _e3335 = phi_11755_;
                                            if (_e3287 < 0f) {
                                                phi_11761_ = -(_e3287);
                                            } else {
                                                phi_11761_ = _e3287;
                                            }
                                            let _e3339 = phi_11761_;
                                            if (_e3335 > _e3339) {
                                                phi_11766_ = _e3335;
                                            } else {
                                                phi_11766_ = _e3339;
                                            }
                                            let _e3342 = phi_11766_;
                                            local_4 = type_26(array<f32, 3>(_e3285, _e3286, _e3287), _e3324, (_e3342 + _e3324));
                                            let _e3347 = local_3.member;
                                            let _e3352 = local_4.member;
                                            let _e3358 = ((_e3347[1] * _e3352[2]) - (_e3347[2] * _e3352[1]));
                                            let _e3361 = ((_e3347[2] * _e3352[0]) - (_e3347[0] * _e3352[2]));
                                            let _e3364 = ((_e3347[0] * _e3352[1]) - (_e3347[1] * _e3352[0]));
                                            if (_e3358 < 0f) {
                                                phi_11815_ = -(_e3358);
                                            } else {
                                                phi_11815_ = _e3358;
                                            }
                                            let _e3368 = phi_11815_;
                                            if (_e3361 < 0f) {
                                                phi_11821_ = -(_e3361);
                                            } else {
                                                phi_11821_ = _e3361;
                                            }
                                            let _e3372 = phi_11821_;
                                            if (_e3368 > _e3372) {
                                                if (_e3358 < 0f) {
                                                    phi_11831_ = -(_e3358);
                                                } else {
                                                    phi_11831_ = _e3358;
                                                }
                                                let _e3390 = phi_11831_;
                                                if (_e3364 < 0f) {
                                                    phi_11837_ = -(_e3364);
                                                } else {
                                                    phi_11837_ = _e3364;
                                                }
                                                let _e3394 = phi_11837_;
                                                if (_e3390 > _e3394) {
                                                    phi_11842_ = 2u;
                                                    phi_11843_ = 1u;
                                                } else {
                                                    phi_11842_ = 1u;
                                                    phi_11843_ = 0u;
                                                }
                                                let _e3397 = phi_11842_;
                                                let _e3399 = phi_11843_;
                                                phi_11862_ = _e3397;
                                                phi_11863_ = _e3399;
                                            } else {
                                                if (_e3361 < 0f) {
                                                    phi_11849_ = -(_e3361);
                                                } else {
                                                    phi_11849_ = _e3361;
                                                }
                                                let _e3377 = phi_11849_;
                                                if (_e3364 < 0f) {
                                                    phi_11855_ = -(_e3364);
                                                } else {
                                                    phi_11855_ = _e3364;
                                                }
                                                let _e3381 = phi_11855_;
                                                if (_e3377 > _e3381) {
                                                    phi_11860_ = 0u;
                                                    phi_11861_ = 2u;
                                                } else {
                                                    phi_11860_ = 1u;
                                                    phi_11861_ = 0u;
                                                }
                                                let _e3384 = phi_11860_;
                                                let _e3386 = phi_11861_;
                                                phi_11862_ = _e3384;
                                                phi_11863_ = _e3386;
                                            }
                                            let _e3401 = phi_11862_;
                                            let _e3403 = phi_11863_;
                                            let _e3406 = local_3.member[_e3403];
                                            let _e3409 = local_4.member[_e3401];
                                            let _e3413 = local_3.member[_e3401];
                                            let _e3416 = local_4.member[_e3403];
                                            let _e3418 = ((_e3406 * _e3409) - (_e3413 * _e3416));
                                            let _e3420 = local_3.member_1;
                                            let _e3422 = local_4.member_2;
                                            let _e3425 = local_3.member_2;
                                            let _e3427 = local_4.member_1;
                                            let _e3432 = local_3.member_2;
                                            let _e3435 = local_4.member_2;
                                            let _e3443 = local_3.member_2;
                                            let _e3446 = local_4.member_2;
                                            let _e3450 = (((((_e3420 * _e3422) + (_e3425 * _e3427)) * 2.01f) + (((_e3432 * 2f) * (_e3435 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3443) * (1f + _e3446))));
                                            if (_e3418 < 0f) {
                                                phi_11932_ = -(_e3418);
                                            } else {
                                                phi_11932_ = _e3418;
                                            }
                                            let _e3454 = phi_11932_;
                                            if (_e3454 > _e3450) {
                                                if (_e3418 < 0f) {
                                                    phi_11941_ = -1f;
                                                } else {
                                                    phi_11941_ = 1f;
                                                }
                                                let _e3458 = phi_11941_;
                                                let _e3461 = local_2.member[_e3403];
                                                let _e3464 = local_4.member[_e3401];
                                                let _e3468 = local_2.member[_e3401];
                                                let _e3471 = local_4.member[_e3403];
                                                let _e3475 = local_2.member_1;
                                                let _e3477 = local_4.member_2;
                                                let _e3480 = local_2.member_2;
                                                let _e3482 = local_4.member_1;
                                                let _e3487 = local_2.member_2;
                                                let _e3490 = local_4.member_2;
                                                let _e3498 = local_2.member_2;
                                                let _e3501 = local_4.member_2;
                                                let _e3505 = (((((_e3475 * _e3477) + (_e3480 * _e3482)) * 2.01f) + (((_e3487 * 2f) * (_e3490 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3498) * (1f + _e3501))));
                                                let _e3508 = local_3.member[_e3403];
                                                let _e3511 = local_2.member[_e3401];
                                                let _e3515 = local_3.member[_e3401];
                                                let _e3518 = local_2.member[_e3403];
                                                let _e3522 = local_3.member_1;
                                                let _e3524 = local_2.member_2;
                                                let _e3527 = local_3.member_2;
                                                let _e3529 = local_2.member_1;
                                                let _e3534 = local_3.member_2;
                                                let _e3537 = local_2.member_2;
                                                let _e3545 = local_3.member_2;
                                                let _e3548 = local_2.member_2;
                                                let _e3552 = (((((_e3522 * _e3524) + (_e3527 * _e3529)) * 2.01f) + (((_e3534 * 2f) * (_e3537 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3545) * (1f + _e3548))));
                                                let _e3553 = (_e3418 * _e3458);
                                                let _e3554 = (((_e3461 * _e3464) - (_e3468 * _e3471)) * _e3458);
                                                let _e3555 = (((_e3508 * _e3511) - (_e3515 * _e3518)) * _e3458);
                                                if (_e3553 < 0f) {
                                                    phi_12076_ = -(_e3553);
                                                } else {
                                                    phi_12076_ = _e3553;
                                                }
                                                let _e3559 = phi_12076_;
                                                if (_e3554 < 0f) {
                                                    phi_12082_ = -(_e3554);
                                                } else {
                                                    phi_12082_ = _e3554;
                                                }
                                                let _e3563 = phi_12082_;
                                                if (_e3555 < 0f) {
                                                    phi_12089_ = -(_e3555);
                                                } else {
                                                    phi_12089_ = _e3555;
                                                }
                                                let _e3568 = phi_12089_;
                                                let _e3571 = (((_e3559 + _e3563) + _e3568) * (0.000000059604645f * 4f));
                                                local_5 = array<type_33, 4>(type_33(_e3554, _e3505), type_33(_e3555, _e3552), type_33((_e3553 - _e3554), ((_e3450 + _e3505) + _e3571)), type_33((_e3553 - _e3555), ((_e3450 + _e3552) + _e3571)));
                                                phi_12144_ = type_12(0u, 4u);
                                                phi_12147_ = true;
                                                loop {
                                                    let _e3584 = phi_12144_;
                                                    let _e3586 = phi_12147_;
                                                    local_27 = _e3586;
                                                    if (_e3584.member < _e3584.member_1) {
                                                        phi_12145_ = type_12((_e3584.member + 1u), _e3584.member_1);
                                                        phi_12170_ = type_12(1u, _e3584.member);
                                                    } else {
                                                        phi_12145_ = _e3584;
                                                        phi_12170_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3598 = phi_12145_;
                                                    let _e3600 = phi_12170_;
                                                    if (bitcast<i32>(_e3600.member) != 0i) {
                                                        let _e3607 = local_5[_e3600.member_1].member;
                                                        let _e3610 = local_5[_e3600.member_1].member_1;
                                                        let _e3612 = (_e3607 < -(_e3610));
                                                        if _e3612 {
                                                            phi_12197_ = bool();
                                                            phi_12198_ = false;
                                                        } else {
                                                            phi_12197_ = (_e3586 && (_e3607 > _e3610));
                                                            phi_12198_ = true;
                                                        }
                                                        let _e3616 = phi_12197_;
                                                        let _e3618 = phi_12198_;
                                                        phi_12148_ = _e3616;
                                                        phi_12199_ = _e3618;
                                                        phi_12200_ = _e3612;
                                                    } else {
                                                        phi_12148_ = bool();
                                                        phi_12199_ = false;
                                                        phi_12200_ = false;
                                                    }
                                                    let _e3620 = phi_12148_;
                                                    let _e3622 = phi_12199_;
                                                    let _e3624 = phi_12200_;
                                                    local_26 = _e3624;
                                                    continue;
                                                    continuing {
                                                        phi_12144_ = _e3598;
                                                        phi_12147_ = _e3620;
                                                        break if !(_e3622);
                                                    }
                                                }
                                                let _e3627 = local_26;
                                                if _e3627 {
                                                    phi_12204_ = false;
                                                } else {
                                                    phi_12204_ = true;
                                                }
                                                let _e3629 = phi_12204_;
                                                if _e3629 {
                                                    let _e3631 = local_27;
                                                    if _e3631 {
                                                        phi_12211_ = 1u;
                                                    } else {
                                                        phi_12211_ = 2u;
                                                    }
                                                    let _e3633 = phi_12211_;
                                                    phi_12212_ = _e3633;
                                                    phi_12213_ = false;
                                                } else {
                                                    phi_12212_ = u32();
                                                    phi_12213_ = true;
                                                }
                                                let _e3635 = phi_12212_;
                                                let _e3637 = phi_12213_;
                                                phi_12214_ = _e3635;
                                                phi_12215_ = 0u;
                                                phi_12216_ = _e3637;
                                            } else {
                                                phi_12214_ = u32();
                                                phi_12215_ = 2u;
                                                phi_12216_ = true;
                                            }
                                            let _e3639 = phi_12214_;
                                            let _e3641 = phi_12215_;
                                            let _e3643 = phi_12216_;
                                            if _e3643 {
                                                phi_12220_ = _e3641;
                                            } else {
                                                phi_12220_ = _e3639;
                                            }
                                            let _e3645 = phi_12220_;
                                            let _e3646 = (_e3645 == 0u);
                                            if _e3646 {
                                                phi_14929_ = bool();
                                                phi_14930_ = f32();
                                                phi_14931_ = f32();
                                                phi_14932_ = false;
                                                phi_14933_ = false;
                                                phi_14934_ = false;
                                            } else {
                                                if (_e3645 == 1u) {
                                                    phi_12230_ = _e2945.member_2;
                                                } else {
                                                    phi_12230_ = false;
                                                }
                                                let _e3650 = phi_12230_;
                                                let _e3651 = (_e324 * 0.99f);
                                                if _e3650 {
                                                    if ((_e2945.member_1 - _e2945.member) <= _e3651) {
                                                        phi_12242_ = false;
                                                    } else {
                                                        phi_12242_ = true;
                                                    }
                                                    let _e3657 = phi_12242_;
                                                    phi_12243_ = _e3657;
                                                } else {
                                                    phi_12243_ = true;
                                                }
                                                let _e3659 = phi_12243_;
                                                if _e3659 {
                                                    let _e3664 = local_18.member[0u];
                                                    let _e3670 = local_18.member_1[0u];
                                                    let _e3676 = local_18.member_2[0u];
                                                    let _e3680 = (_e3664[0] - _e3670[0]);
                                                    let _e3681 = (_e3664[1] - _e3670[1]);
                                                    let _e3682 = (_e3664[2] - _e3670[2]);
                                                    let _e3691 = local_18.member[1u];
                                                    let _e3697 = local_18.member_1[1u];
                                                    let _e3703 = local_18.member_2[1u];
                                                    let _e3707 = (_e3691[0] - _e3697[0]);
                                                    let _e3708 = (_e3691[1] - _e3697[1]);
                                                    let _e3709 = (_e3691[2] - _e3697[2]);
                                                    let _e3718 = local_18.member[0u];
                                                    if (_e3718[0] < 0f) {
                                                        phi_12391_ = -(_e3718[0]);
                                                    } else {
                                                        phi_12391_ = _e3718[0];
                                                    }
                                                    let _e3725 = phi_12391_;
                                                    if (_e3718[1] < 0f) {
                                                        phi_12398_ = -(_e3718[1]);
                                                    } else {
                                                        phi_12398_ = _e3718[1];
                                                    }
                                                    let _e3729 = phi_12398_;
                                                    if (_e3725 > _e3729) {
                                                        phi_12403_ = _e3725;
                                                    } else {
                                                        phi_12403_ = _e3729;
                                                    }
                                                    let _e3732 = phi_12403_;
                                                    if (_e3718[2] < 0f) {
                                                        phi_12410_ = -(_e3718[2]);
                                                    } else {
                                                        phi_12410_ = _e3718[2];
                                                    }
                                                    let _e3736 = phi_12410_;
                                                    if (_e3732 > _e3736) {
                                                        phi_12415_ = _e3732;
                                                    } else {
                                                        phi_12415_ = _e3736;
                                                    }
                                                    let _e3739 = phi_12415_;
                                                    let _e3742 = local_18.member[1u];
                                                    if (_e3742[0] < 0f) {
                                                        phi_12428_ = -(_e3742[0]);
                                                    } else {
                                                        phi_12428_ = _e3742[0];
                                                    }
                                                    let _e3749 = phi_12428_;
                                                    if (_e3742[1] < 0f) {
                                                        phi_12435_ = -(_e3742[1]);
                                                    } else {
                                                        phi_12435_ = _e3742[1];
                                                    }
                                                    let _e3753 = phi_12435_;
                                                    if (_e3749 > _e3753) {
                                                        phi_12440_ = _e3749;
                                                    } else {
                                                        phi_12440_ = _e3753;
                                                    }
                                                    let _e3756 = phi_12440_;
                                                    if (_e3742[2] < 0f) {
                                                        phi_12447_ = -(_e3742[2]);
                                                    } else {
                                                        phi_12447_ = _e3742[2];
                                                    }
                                                    let _e3760 = phi_12447_;
                                                    if (_e3756 > _e3760) {
                                                        phi_12452_ = _e3756;
                                                    } else {
                                                        phi_12452_ = _e3760;
                                                    }
                                                    let _e3763 = phi_12452_;
                                                    if (_e3739 > _e3763) {
                                                        phi_12457_ = _e3739;
                                                    } else {
                                                        phi_12457_ = _e3763;
                                                    }
                                                    let _e3766 = phi_12457_;
                                                    let _e3768 = local_18.member_3;
                                                    let _e3772 = local_18.member_1[0u];
                                                    if (_e3772[0] < 0f) {
                                                        phi_12474_ = -(_e3772[0]);
                                                    } else {
                                                        phi_12474_ = _e3772[0];
                                                    }
                                                    let _e3779 = phi_12474_;
                                                    if (_e3772[1] < 0f) {
                                                        phi_12481_ = -(_e3772[1]);
                                                    } else {
                                                        phi_12481_ = _e3772[1];
                                                    }
                                                    let _e3783 = phi_12481_;
                                                    if (_e3779 > _e3783) {
                                                        phi_12486_ = _e3779;
                                                    } else {
                                                        phi_12486_ = _e3783;
                                                    }
                                                    let _e3786 = phi_12486_;
                                                    if (_e3772[2] < 0f) {
                                                        phi_12493_ = -(_e3772[2]);
                                                    } else {
                                                        phi_12493_ = _e3772[2];
                                                    }
                                                    let _e3790 = phi_12493_;
                                                    if (_e3786 > _e3790) {
                                                        phi_12498_ = _e3786;
                                                    } else {
                                                        phi_12498_ = _e3790;
                                                    }
                                                    let _e3793 = phi_12498_;
                                                    let _e3796 = local_18.member_1[1u];
                                                    if (_e3796[0] < 0f) {
                                                        phi_12512_ = -(_e3796[0]);
                                                    } else {
                                                        phi_12512_ = _e3796[0];
                                                    }
                                                    let _e3803 = phi_12512_;
                                                    if (_e3796[1] < 0f) {
                                                        phi_12519_ = -(_e3796[1]);
                                                    } else {
                                                        phi_12519_ = _e3796[1];
                                                    }
                                                    let _e3807 = phi_12519_;
                                                    if (_e3803 > _e3807) {
                                                        phi_12524_ = _e3803;
                                                    } else {
                                                        phi_12524_ = _e3807;
                                                    }
                                                    let _e3810 = phi_12524_;
                                                    if (_e3796[2] < 0f) {
                                                        phi_12531_ = -(_e3796[2]);
                                                    } else {
                                                        phi_12531_ = _e3796[2];
                                                    }
                                                    let _e3814 = phi_12531_;
                                                    if (_e3810 > _e3814) {
                                                        phi_12536_ = _e3810;
                                                    } else {
                                                        phi_12536_ = _e3814;
                                                    }
                                                    let _e3817 = phi_12536_;
                                                    if (_e3793 > _e3817) {
                                                        phi_12541_ = _e3793;
                                                    } else {
                                                        phi_12541_ = _e3817;
                                                    }
                                                    let _e3820 = phi_12541_;
                                                    let _e3822 = local_18.member_3;
                                                    let _e3826 = local_18.member_2[0u];
                                                    if (_e3826[0] < 0f) {
                                                        phi_12558_ = -(_e3826[0]);
                                                    } else {
                                                        phi_12558_ = _e3826[0];
                                                    }
                                                    let _e3833 = phi_12558_;
                                                    if (_e3826[1] < 0f) {
                                                        phi_12565_ = -(_e3826[1]);
                                                    } else {
                                                        phi_12565_ = _e3826[1];
                                                    }
                                                    let _e3837 = phi_12565_;
                                                    if (_e3833 > _e3837) {
                                                        phi_12570_ = _e3833;
                                                    } else {
                                                        phi_12570_ = _e3837;
                                                    }
                                                    let _e3840 = phi_12570_;
                                                    if (_e3826[2] < 0f) {
                                                        phi_12577_ = -(_e3826[2]);
                                                    } else {
                                                        phi_12577_ = _e3826[2];
                                                    }
                                                    let _e3844 = phi_12577_;
                                                    if (_e3840 > _e3844) {
                                                        phi_12582_ = _e3840;
                                                    } else {
                                                        phi_12582_ = _e3844;
                                                    }
                                                    let _e3847 = phi_12582_;
                                                    let _e3850 = local_18.member_2[1u];
                                                    if (_e3850[0] < 0f) {
                                                        phi_12596_ = -(_e3850[0]);
                                                    } else {
                                                        phi_12596_ = _e3850[0];
                                                    }
                                                    let _e3857 = phi_12596_;
                                                    if (_e3850[1] < 0f) {
                                                        phi_12603_ = -(_e3850[1]);
                                                    } else {
                                                        phi_12603_ = _e3850[1];
                                                    }
                                                    let _e3861 = phi_12603_;
                                                    if (_e3857 > _e3861) {
                                                        phi_12608_ = _e3857;
                                                    } else {
                                                        phi_12608_ = _e3861;
                                                    }
                                                    let _e3864 = phi_12608_;
                                                    if (_e3850[2] < 0f) {
                                                        phi_12615_ = -(_e3850[2]);
                                                    } else {
                                                        phi_12615_ = _e3850[2];
                                                    }
                                                    let _e3868 = phi_12615_;
                                                    if (_e3864 > _e3868) {
                                                        phi_12620_ = _e3864;
                                                    } else {
                                                        phi_12620_ = _e3868;
                                                    }
                                                    let _e3871 = phi_12620_;
                                                    if (_e3847 > _e3871) {
                                                        phi_12625_ = _e3847;
                                                    } else {
                                                        phi_12625_ = _e3871;
                                                    }
                                                    let _e3874 = phi_12625_;
                                                    let _e3876 = local_18.member_3;
                                                    let _e3883 = local_18.member_3;
                                                    let _e3888 = (_e324 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_12666_ = type_12(0u, 96u);
                                                    phi_12669_ = _e2945.member;
                                                    phi_12671_ = _e2945.member;
                                                    phi_12673_ = (_e2945.member_1 - _e2945.member);
                                                    phi_12675_ = _e2945.member;
                                                    phi_12677_ = false;
                                                    phi_12679_ = 0u;
                                                    loop {
                                                        let _e3891 = phi_12666_;
                                                        let _e3893 = phi_12669_;
                                                        let _e3895 = phi_12671_;
                                                        let _e3897 = phi_12673_;
                                                        let _e3899 = phi_12675_;
                                                        let _e3901 = phi_12677_;
                                                        let _e3903 = phi_12679_;
                                                        local_30 = _e3893;
                                                        local_75 = _e3895;
                                                        if (_e3891.member < _e3891.member_1) {
                                                            phi_12667_ = type_12((_e3891.member + 1u), _e3891.member_1);
                                                            phi_12702_ = type_12(1u, _e3891.member);
                                                        } else {
                                                            phi_12667_ = _e3891;
                                                            phi_12702_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3915 = phi_12667_;
                                                        let _e3917 = phi_12702_;
                                                        if (bitcast<i32>(_e3917.member) != 0i) {
                                                            let _e3923 = local_18.member[0u];
                                                            let _e3929 = local_18.member[1u];
                                                            let _e3945 = local_18.member_1[0u];
                                                            let _e3951 = local_18.member_1[1u];
                                                            let _e3967 = local_18.member_2[0u];
                                                            let _e3973 = local_18.member_2[1u];
                                                            let _e3987 = function_3(array<f32, 3>((_e3923[0] + ((_e3929[0] - _e3923[0]) * _e3893)), (_e3923[1] + ((_e3929[1] - _e3923[1]) * _e3893)), (_e3923[2] + ((_e3929[2] - _e3923[2]) * _e3893))), array<f32, 3>((_e3945[0] + ((_e3951[0] - _e3945[0]) * _e3893)), (_e3945[1] + ((_e3951[1] - _e3945[1]) * _e3893)), (_e3945[2] + ((_e3951[2] - _e3945[2]) * _e3893))), array<f32, 3>((_e3967[0] + ((_e3973[0] - _e3967[0]) * _e3893)), (_e3967[1] + ((_e3973[1] - _e3967[1]) * _e3893)), (_e3967[2] + ((_e3973[2] - _e3967[2]) * _e3893))), 1u);
                                                            if (_e3903 == 0u) {
                                                                phi_12830_ = _e3987;
                                                            } else {
                                                                if (_e3903 == 1u) {
                                                                    phi_12816_ = _e3987[0];
                                                                } else {
                                                                    phi_12816_ = 0f;
                                                                }
                                                                let _e3992 = phi_12816_;
                                                                if (_e3903 == 2u) {
                                                                    phi_12822_ = _e3987[1];
                                                                } else {
                                                                    phi_12822_ = 0f;
                                                                }
                                                                let _e3996 = phi_12822_;
                                                                if (_e3903 == 3u) {
                                                                    phi_12828_ = _e3987[2];
                                                                } else {
                                                                    phi_12828_ = 0f;
                                                                }
                                                                let _e4000 = phi_12828_;
                                                                phi_12830_ = array<f32, 3>(_e3992, _e3996, _e4000);
                                                            }
                                                            let _e4003 = phi_12830_;
                                                            if (_e4003[0] < 0f) {
                                                                phi_12837_ = -(_e4003[0]);
                                                            } else {
                                                                phi_12837_ = _e4003[0];
                                                            }
                                                            let _e4008 = phi_12837_;
                                                            if (_e4003[1] < 0f) {
                                                                phi_12844_ = -(_e4003[1]);
                                                            } else {
                                                                phi_12844_ = _e4003[1];
                                                            }
                                                            let _e4013 = phi_12844_;
                                                            if (_e4003[2] < 0f) {
                                                                phi_12852_ = -(_e4003[2]);
                                                            } else {
                                                                phi_12852_ = _e4003[2];
                                                            }
                                                            let _e4019 = phi_12852_;
                                                            let _e4020 = ((_e4008 + _e4013) + _e4019);
                                                            if (_e4020 > 0f) {
                                                                if ((bitcast<u32>(_e4020) & 2139095040u) != 2139095040u) {
                                                                    let _e4025 = (1f / _e4020);
                                                                    let _e4027 = (_e4003[0] * _e4025);
                                                                    let _e4029 = (_e4003[1] * _e4025);
                                                                    let _e4031 = (_e4003[2] * _e4025);
                                                                    let _e4036 = (((_e4027 * _e4027) + (_e4029 * _e4029)) + (_e4031 * _e4031));
                                                                    if (_e4036 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e4036 > 0f) {
                                                                            phi_12889_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_12889_ = 0f;
                                                                        }
                                                                        let _e4089 = phi_12889_;
                                                                        phi_12953_ = _e4089;
                                                                    } else {
                                                                        phi_12896_ = type_14(0i, 5i);
                                                                        phi_12899_ = bitcast<f32>(((bitcast<u32>(_e4036) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e4044 = phi_12896_;
                                                                            let _e4046 = phi_12899_;
                                                                            local_28 = _e4046;
                                                                            if (_e4044.member < _e4044.member_1) {
                                                                                let _e4053 = (_e4044.member + 1i);
                                                                                if ((false == (_e4053 > _e4044.member)) != false) {
                                                                                    phi_12920_ = true;
                                                                                } else {
                                                                                    phi_12920_ = false;
                                                                                }
                                                                                let _e4058 = phi_12920_;
                                                                                if _e4058 {
                                                                                    phi_12926_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_12926_ = type_15(1u, _e4053);
                                                                                }
                                                                                let _e4063 = phi_12926_;
                                                                                phi_12897_ = type_14(_e4063.member_1, _e4044.member_1);
                                                                                phi_12940_ = type_15(1u, _e4044.member);
                                                                            } else {
                                                                                phi_12897_ = _e4044;
                                                                                phi_12940_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4069 = phi_12897_;
                                                                            let _e4071 = phi_12940_;
                                                                            let _e4074 = (bitcast<i32>(_e4071.member) != 0i);
                                                                            if _e4074 {
                                                                                phi_12900_ = (0.5f * (_e4046 + (_e4036 / _e4046)));
                                                                            } else {
                                                                                phi_12900_ = f32();
                                                                            }
                                                                            let _e4079 = phi_12900_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_12896_ = _e4069;
                                                                                phi_12899_ = _e4079;
                                                                                break if !(_e4074);
                                                                            }
                                                                        }
                                                                        let _e4084 = local_28;
                                                                        phi_12953_ = (_e4084 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4091 = phi_12953_;
                                                                    let _e4092 = (0.000000059604645f * 12f);
                                                                    let _e4097 = ((((((((_e3766 + _e3768) + (_e3820 + _e3822)) + (_e3874 + _e3876)) * (0.000000059604645f * 16f)) + (_e3883 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4091) * (1f + _e4092)));
                                                                    let _e4102 = (((_e4027 * _e3664[0]) + (_e4029 * _e3664[1])) + (_e4031 * _e3664[2]));
                                                                    let _e4107 = (((_e4027 * _e3680) + (_e4029 * _e3681)) + (_e4031 * _e3682));
                                                                    let _e4112 = (((_e4027 * (_e3664[0] - _e3676[0])) + (_e4029 * (_e3664[1] - _e3676[1]))) + (_e4031 * (_e3664[2] - _e3676[2])));
                                                                    let _e4117 = (((_e4027 * (_e3680 - _e3676[0])) + (_e4029 * (_e3681 - _e3676[1]))) + (_e4031 * (_e3682 - _e3676[2])));
                                                                    let _e4123 = (((_e4027 * _e3691[0]) + (_e4029 * _e3691[1])) + (_e4031 * _e3691[2]));
                                                                    let _e4128 = (((_e4027 * _e3707) + (_e4029 * _e3708)) + (_e4031 * _e3709));
                                                                    let _e4133 = (((_e4027 * (_e3691[0] - _e3703[0])) + (_e4029 * (_e3691[1] - _e3703[1]))) + (_e4031 * (_e3691[2] - _e3703[2])));
                                                                    let _e4138 = (((_e4027 * (_e3707 - _e3703[0])) + (_e4029 * (_e3708 - _e3703[1]))) + (_e4031 * (_e3709 - _e3703[2])));
                                                                    if (_e4102 < 0f) {
                                                                        phi_13019_ = -(_e4102);
                                                                    } else {
                                                                        phi_13019_ = _e4102;
                                                                    }
                                                                    let _e4143 = phi_13019_;
                                                                    if (_e4123 < 0f) {
                                                                        phi_13025_ = -(_e4123);
                                                                    } else {
                                                                        phi_13025_ = _e4123;
                                                                    }
                                                                    let _e4147 = phi_13025_;
                                                                    if (_e4107 < 0f) {
                                                                        phi_13034_ = -(_e4107);
                                                                    } else {
                                                                        phi_13034_ = _e4107;
                                                                    }
                                                                    let _e4154 = phi_13034_;
                                                                    if (_e4128 < 0f) {
                                                                        phi_13040_ = -(_e4128);
                                                                    } else {
                                                                        phi_13040_ = _e4128;
                                                                    }
                                                                    let _e4158 = phi_13040_;
                                                                    if (_e4112 < 0f) {
                                                                        phi_13049_ = -(_e4112);
                                                                    } else {
                                                                        phi_13049_ = _e4112;
                                                                    }
                                                                    let _e4165 = phi_13049_;
                                                                    if (_e4133 < 0f) {
                                                                        phi_13055_ = -(_e4133);
                                                                    } else {
                                                                        phi_13055_ = _e4133;
                                                                    }
                                                                    let _e4169 = phi_13055_;
                                                                    if (_e4117 < 0f) {
                                                                        phi_13064_ = -(_e4117);
                                                                    } else {
                                                                        phi_13064_ = _e4117;
                                                                    }
                                                                    let _e4176 = phi_13064_;
                                                                    if (_e4138 < 0f) {
                                                                        phi_13070_ = -(_e4138);
                                                                    } else {
                                                                        phi_13070_ = _e4138;
                                                                    }
                                                                    let _e4180 = phi_13070_;
                                                                    phi_13076_ = type_32(array<f32, 4>(_e4102, _e4107, _e4112, _e4117), array<f32, 4>(_e4123, _e4128, _e4133, _e4138), array<f32, 4>((_e4097 + ((_e4143 + _e4147) * _e4092)), (_e4097 + ((_e4154 + _e4158) * _e4092)), (_e4097 + ((_e4165 + _e4169) * _e4092)), (_e4097 + ((_e4176 + _e4180) * _e4092))));
                                                                    phi_13077_ = false;
                                                                } else {
                                                                    phi_13076_ = type_32();
                                                                    phi_13077_ = true;
                                                                }
                                                                let _e4187 = phi_13076_;
                                                                let _e4189 = phi_13077_;
                                                                phi_13078_ = _e4187;
                                                                phi_13079_ = _e4189;
                                                            } else {
                                                                phi_13078_ = type_32();
                                                                phi_13079_ = true;
                                                            }
                                                            let _e4191 = phi_13078_;
                                                            let _e4193 = phi_13079_;
                                                            if _e4193 {
                                                                phi_13087_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13087_ = _e4191;
                                                            }
                                                            let _e4195 = phi_13087_;
                                                            local_1 = type_32(array<f32, 4>(_e4195.member[0], _e4195.member[1], _e4195.member[2], _e4195.member[3]), array<f32, 4>(_e4195.member_1[0], _e4195.member_1[1], _e4195.member_1[2], _e4195.member_1[3]), array<f32, 4>(_e4195.member_2[0], _e4195.member_2[1], _e4195.member_2[2], _e4195.member_2[3]));
                                                            let _e4215 = (_e3893 - _e3899);
                                                            let _e4219 = local_1.member[0u];
                                                            let _e4222 = local_1.member_1[0u];
                                                            let _e4225 = local_1.member[0u];
                                                            let _e4231 = local_1.member_2[0u];
                                                            if (((_e4219 + ((_e4222 - _e4225) * _e3893)) - _e4231) > 0f) {
                                                                let _e4236 = local_1.member[1u];
                                                                let _e4239 = local_1.member_1[1u];
                                                                let _e4242 = local_1.member[1u];
                                                                let _e4248 = local_1.member_2[1u];
                                                                if (((_e4236 + ((_e4239 - _e4242) * _e3893)) - _e4248) > 0f) {
                                                                    let _e4253 = local_1.member[2u];
                                                                    let _e4256 = local_1.member_1[2u];
                                                                    let _e4259 = local_1.member[2u];
                                                                    let _e4265 = local_1.member_2[2u];
                                                                    if (((_e4253 + ((_e4256 - _e4259) * _e3893)) - _e4265) > 0f) {
                                                                        let _e4270 = local_1.member[3u];
                                                                        let _e4273 = local_1.member_1[3u];
                                                                        let _e4276 = local_1.member[3u];
                                                                        let _e4282 = local_1.member_2[3u];
                                                                        phi_13258_ = (((_e4270 + ((_e4273 - _e4276) * _e3893)) - _e4282) > 0f);
                                                                        phi_13259_ = false;
                                                                    } else {
                                                                        phi_13258_ = bool();
                                                                        phi_13259_ = true;
                                                                    }
                                                                    let _e4286 = phi_13258_;
                                                                    let _e4288 = phi_13259_;
                                                                    phi_13260_ = _e4286;
                                                                    phi_13261_ = _e4288;
                                                                } else {
                                                                    phi_13260_ = bool();
                                                                    phi_13261_ = true;
                                                                }
                                                                let _e4290 = phi_13260_;
                                                                let _e4292 = phi_13261_;
                                                                phi_13262_ = _e4290;
                                                                phi_13263_ = _e4292;
                                                            } else {
                                                                phi_13262_ = bool();
                                                                phi_13263_ = true;
                                                            }
                                                            let _e4294 = phi_13262_;
                                                            let _e4296 = phi_13263_;
                                                            if _e4296 {
                                                                phi_13267_ = false;
                                                            } else {
                                                                phi_13267_ = _e4294;
                                                            }
                                                            let _e4298 = phi_13267_;
                                                            if _e4298 {
                                                                if (_e3893 <= _e3895) {
                                                                    phi_13577_ = true;
                                                                } else {
                                                                    let _e4302 = local.member[0u];
                                                                    let _e4305 = local.member_1[0u];
                                                                    let _e4308 = local.member[0u];
                                                                    let _e4314 = local.member_2[0u];
                                                                    let _e4318 = local_1.member[0u];
                                                                    let _e4321 = local_1.member_1[0u];
                                                                    let _e4324 = local_1.member[0u];
                                                                    let _e4330 = local_1.member_2[0u];
                                                                    if ((((_e4302 + ((_e4305 - _e4308) * _e3893)) - _e4314) + ((_e4318 + ((_e4321 - _e4324) * _e3899)) - _e4330)) > 0f) {
                                                                        let _e4336 = local.member[1u];
                                                                        let _e4339 = local.member_1[1u];
                                                                        let _e4342 = local.member[1u];
                                                                        let _e4348 = local.member_2[1u];
                                                                        let _e4352 = local_1.member[1u];
                                                                        let _e4355 = local_1.member_1[1u];
                                                                        let _e4358 = local_1.member[1u];
                                                                        let _e4364 = local_1.member_2[1u];
                                                                        if ((((_e4336 + ((_e4339 - _e4342) * _e3893)) - _e4348) + ((_e4352 + ((_e4355 - _e4358) * _e3899)) - _e4364)) > 0f) {
                                                                            let _e4370 = local.member[2u];
                                                                            let _e4373 = local.member_1[2u];
                                                                            let _e4376 = local.member[2u];
                                                                            let _e4382 = local.member_2[2u];
                                                                            let _e4386 = local_1.member[2u];
                                                                            let _e4389 = local_1.member_1[2u];
                                                                            let _e4392 = local_1.member[2u];
                                                                            let _e4398 = local_1.member_2[2u];
                                                                            if ((((_e4370 + ((_e4373 - _e4376) * _e3893)) - _e4382) + ((_e4386 + ((_e4389 - _e4392) * _e3899)) - _e4398)) > 0f) {
                                                                                let _e4404 = local.member[3u];
                                                                                let _e4407 = local.member_1[3u];
                                                                                let _e4410 = local.member[3u];
                                                                                let _e4416 = local.member_2[3u];
                                                                                let _e4420 = local_1.member[3u];
                                                                                let _e4423 = local_1.member_1[3u];
                                                                                let _e4426 = local_1.member[3u];
                                                                                let _e4432 = local_1.member_2[3u];
                                                                                phi_13564_ = ((((_e4404 + ((_e4407 - _e4410) * _e3893)) - _e4416) + ((_e4420 + ((_e4423 - _e4426) * _e3899)) - _e4432)) > 0f);
                                                                                phi_13565_ = false;
                                                                            } else {
                                                                                phi_13564_ = bool();
                                                                                phi_13565_ = true;
                                                                            }
                                                                            let _e4437 = phi_13564_;
                                                                            let _e4439 = phi_13565_;
                                                                            phi_13566_ = _e4437;
                                                                            phi_13567_ = _e4439;
                                                                        } else {
                                                                            phi_13566_ = bool();
                                                                            phi_13567_ = true;
                                                                        }
                                                                        let _e4441 = phi_13566_;
                                                                        let _e4443 = phi_13567_;
                                                                        phi_13568_ = _e4441;
                                                                        phi_13569_ = _e4443;
                                                                    } else {
                                                                        phi_13568_ = bool();
                                                                        phi_13569_ = true;
                                                                    }
                                                                    let _e4445 = phi_13568_;
                                                                    let _e4447 = phi_13569_;
                                                                    if _e4447 {
                                                                        phi_13573_ = false;
                                                                    } else {
                                                                        phi_13573_ = _e4445;
                                                                    }
                                                                    let _e4449 = phi_13573_;
                                                                    phi_13577_ = _e4449;
                                                                }
                                                                let _e4451 = phi_13577_;
                                                                if _e4451 {
                                                                    if _e3901 {
                                                                        if (_e3893 >= _e2945.member_1) {
                                                                            phi_13588_ = false;
                                                                        } else {
                                                                            phi_13588_ = true;
                                                                        }
                                                                        let _e4454 = phi_13588_;
                                                                        phi_13589_ = _e4454;
                                                                    } else {
                                                                        phi_13589_ = true;
                                                                    }
                                                                    let _e4456 = phi_13589_;
                                                                    if _e4456 {
                                                                        local = type_32(array<f32, 4>(_e4195.member[0], _e4195.member[1], _e4195.member[2], _e4195.member[3]), array<f32, 4>(_e4195.member_1[0], _e4195.member_1[1], _e4195.member_1[2], _e4195.member_1[3]), array<f32, 4>(_e4195.member_2[0], _e4195.member_2[1], _e4195.member_2[2], _e4195.member_2[3]));
                                                                        let _e4478 = local.member[0u];
                                                                        let _e4481 = local.member_1[0u];
                                                                        let _e4484 = local.member_2[0u];
                                                                        if (_e4478 > _e4484) {
                                                                            if (_e4481 > _e4484) {
                                                                                phi_13663_ = false;
                                                                            } else {
                                                                                phi_13663_ = true;
                                                                            }
                                                                            let _e4488 = phi_13663_;
                                                                            phi_13664_ = _e4488;
                                                                        } else {
                                                                            phi_13664_ = true;
                                                                        }
                                                                        let _e4490 = phi_13664_;
                                                                        if _e4490 {
                                                                            let _e4491 = (_e4481 >= _e4478);
                                                                            if _e4491 {
                                                                                phi_13686_ = f32();
                                                                                phi_13687_ = false;
                                                                            } else {
                                                                                if ((_e4478 - _e4481) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13684_ = (((_e4478 - _e4484) / (_e4478 - _e4481)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13685_ = false;
                                                                                } else {
                                                                                    phi_13684_ = f32();
                                                                                    phi_13685_ = true;
                                                                                }
                                                                                let _e4502 = phi_13684_;
                                                                                let _e4504 = phi_13685_;
                                                                                phi_13686_ = _e4502;
                                                                                phi_13687_ = _e4504;
                                                                            }
                                                                            let _e4506 = phi_13686_;
                                                                            let _e4508 = phi_13687_;
                                                                            phi_13688_ = _e4506;
                                                                            phi_13689_ = _e4491;
                                                                            phi_13690_ = _e4508;
                                                                        } else {
                                                                            phi_13688_ = f32();
                                                                            phi_13689_ = true;
                                                                            phi_13690_ = false;
                                                                        }
                                                                        let _e4510 = phi_13688_;
                                                                        let _e4512 = phi_13689_;
                                                                        let _e4514 = phi_13690_;
                                                                        if _e4512 {
                                                                            phi_13694_ = 2f;
                                                                            phi_13695_ = true;
                                                                        } else {
                                                                            phi_13694_ = _e3893;
                                                                            phi_13695_ = _e4514;
                                                                        }
                                                                        let _e4516 = phi_13694_;
                                                                        let _e4518 = phi_13695_;
                                                                        if _e4518 {
                                                                            phi_13699_ = _e4516;
                                                                        } else {
                                                                            phi_13699_ = _e4510;
                                                                        }
                                                                        let _e4520 = phi_13699_;
                                                                        let _e4523 = local.member[1u];
                                                                        let _e4526 = local.member_1[1u];
                                                                        let _e4529 = local.member_2[1u];
                                                                        if (_e4523 > _e4529) {
                                                                            if (_e4526 > _e4529) {
                                                                                phi_13731_ = false;
                                                                            } else {
                                                                                phi_13731_ = true;
                                                                            }
                                                                            let _e4533 = phi_13731_;
                                                                            phi_13732_ = _e4533;
                                                                        } else {
                                                                            phi_13732_ = true;
                                                                        }
                                                                        let _e4535 = phi_13732_;
                                                                        if _e4535 {
                                                                            let _e4536 = (_e4526 >= _e4523);
                                                                            if _e4536 {
                                                                                phi_13754_ = f32();
                                                                                phi_13755_ = false;
                                                                            } else {
                                                                                if ((_e4523 - _e4526) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13752_ = (((_e4523 - _e4529) / (_e4523 - _e4526)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13753_ = false;
                                                                                } else {
                                                                                    phi_13752_ = f32();
                                                                                    phi_13753_ = true;
                                                                                }
                                                                                let _e4547 = phi_13752_;
                                                                                let _e4549 = phi_13753_;
                                                                                phi_13754_ = _e4547;
                                                                                phi_13755_ = _e4549;
                                                                            }
                                                                            let _e4551 = phi_13754_;
                                                                            let _e4553 = phi_13755_;
                                                                            phi_13756_ = _e4551;
                                                                            phi_13757_ = _e4536;
                                                                            phi_13758_ = _e4553;
                                                                        } else {
                                                                            phi_13756_ = f32();
                                                                            phi_13757_ = true;
                                                                            phi_13758_ = false;
                                                                        }
                                                                        let _e4555 = phi_13756_;
                                                                        let _e4557 = phi_13757_;
                                                                        let _e4559 = phi_13758_;
                                                                        if _e4557 {
                                                                            phi_13762_ = 2f;
                                                                            phi_13763_ = true;
                                                                        } else {
                                                                            phi_13762_ = _e3893;
                                                                            phi_13763_ = _e4559;
                                                                        }
                                                                        let _e4561 = phi_13762_;
                                                                        let _e4563 = phi_13763_;
                                                                        if _e4563 {
                                                                            phi_13767_ = _e4561;
                                                                        } else {
                                                                            phi_13767_ = _e4555;
                                                                        }
                                                                        let _e4565 = phi_13767_;
                                                                        if (_e4520 < _e4565) {
                                                                            phi_13772_ = _e4520;
                                                                        } else {
                                                                            phi_13772_ = _e4565;
                                                                        }
                                                                        let _e4568 = phi_13772_;
                                                                        let _e4571 = local.member[2u];
                                                                        let _e4574 = local.member_1[2u];
                                                                        let _e4577 = local.member_2[2u];
                                                                        if (_e4571 > _e4577) {
                                                                            if (_e4574 > _e4577) {
                                                                                phi_13804_ = false;
                                                                            } else {
                                                                                phi_13804_ = true;
                                                                            }
                                                                            let _e4581 = phi_13804_;
                                                                            phi_13805_ = _e4581;
                                                                        } else {
                                                                            phi_13805_ = true;
                                                                        }
                                                                        let _e4583 = phi_13805_;
                                                                        if _e4583 {
                                                                            let _e4584 = (_e4574 >= _e4571);
                                                                            if _e4584 {
                                                                                phi_13827_ = f32();
                                                                                phi_13828_ = false;
                                                                            } else {
                                                                                if ((_e4571 - _e4574) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13825_ = (((_e4571 - _e4577) / (_e4571 - _e4574)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13826_ = false;
                                                                                } else {
                                                                                    phi_13825_ = f32();
                                                                                    phi_13826_ = true;
                                                                                }
                                                                                let _e4595 = phi_13825_;
                                                                                let _e4597 = phi_13826_;
                                                                                phi_13827_ = _e4595;
                                                                                phi_13828_ = _e4597;
                                                                            }
                                                                            let _e4599 = phi_13827_;
                                                                            let _e4601 = phi_13828_;
                                                                            phi_13829_ = _e4599;
                                                                            phi_13830_ = _e4584;
                                                                            phi_13831_ = _e4601;
                                                                        } else {
                                                                            phi_13829_ = f32();
                                                                            phi_13830_ = true;
                                                                            phi_13831_ = false;
                                                                        }
                                                                        let _e4603 = phi_13829_;
                                                                        let _e4605 = phi_13830_;
                                                                        let _e4607 = phi_13831_;
                                                                        if _e4605 {
                                                                            phi_13835_ = 2f;
                                                                            phi_13836_ = true;
                                                                        } else {
                                                                            phi_13835_ = _e3893;
                                                                            phi_13836_ = _e4607;
                                                                        }
                                                                        let _e4609 = phi_13835_;
                                                                        let _e4611 = phi_13836_;
                                                                        if _e4611 {
                                                                            phi_13840_ = _e4609;
                                                                        } else {
                                                                            phi_13840_ = _e4603;
                                                                        }
                                                                        let _e4613 = phi_13840_;
                                                                        let _e4616 = local.member[3u];
                                                                        let _e4619 = local.member_1[3u];
                                                                        let _e4622 = local.member_2[3u];
                                                                        if (_e4616 > _e4622) {
                                                                            if (_e4619 > _e4622) {
                                                                                phi_13872_ = false;
                                                                            } else {
                                                                                phi_13872_ = true;
                                                                            }
                                                                            let _e4626 = phi_13872_;
                                                                            phi_13873_ = _e4626;
                                                                        } else {
                                                                            phi_13873_ = true;
                                                                        }
                                                                        let _e4628 = phi_13873_;
                                                                        if _e4628 {
                                                                            let _e4629 = (_e4619 >= _e4616);
                                                                            if _e4629 {
                                                                                phi_13895_ = f32();
                                                                                phi_13896_ = false;
                                                                            } else {
                                                                                if ((_e4616 - _e4619) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13893_ = (((_e4616 - _e4622) / (_e4616 - _e4619)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13894_ = false;
                                                                                } else {
                                                                                    phi_13893_ = f32();
                                                                                    phi_13894_ = true;
                                                                                }
                                                                                let _e4640 = phi_13893_;
                                                                                let _e4642 = phi_13894_;
                                                                                phi_13895_ = _e4640;
                                                                                phi_13896_ = _e4642;
                                                                            }
                                                                            let _e4644 = phi_13895_;
                                                                            let _e4646 = phi_13896_;
                                                                            phi_13897_ = _e4644;
                                                                            phi_13898_ = _e4629;
                                                                            phi_13899_ = _e4646;
                                                                        } else {
                                                                            phi_13897_ = f32();
                                                                            phi_13898_ = true;
                                                                            phi_13899_ = false;
                                                                        }
                                                                        let _e4648 = phi_13897_;
                                                                        let _e4650 = phi_13898_;
                                                                        let _e4652 = phi_13899_;
                                                                        if _e4650 {
                                                                            phi_13903_ = 2f;
                                                                            phi_13904_ = true;
                                                                        } else {
                                                                            phi_13903_ = _e3893;
                                                                            phi_13904_ = _e4652;
                                                                        }
                                                                        let _e4654 = phi_13903_;
                                                                        let _e4656 = phi_13904_;
                                                                        if _e4656 {
                                                                            phi_13908_ = _e4654;
                                                                        } else {
                                                                            phi_13908_ = _e4648;
                                                                        }
                                                                        let _e4658 = phi_13908_;
                                                                        if (_e4613 < _e4658) {
                                                                            phi_13913_ = _e4613;
                                                                        } else {
                                                                            phi_13913_ = _e4658;
                                                                        }
                                                                        let _e4661 = phi_13913_;
                                                                        if (_e4568 < _e4661) {
                                                                            phi_13918_ = _e4568;
                                                                        } else {
                                                                            phi_13918_ = _e4661;
                                                                        }
                                                                        let _e4664 = phi_13918_;
                                                                        if (_e4664 > _e3893) {
                                                                            phi_13923_ = _e4664;
                                                                        } else {
                                                                            phi_13923_ = _e3893;
                                                                        }
                                                                        let _e4667 = phi_13923_;
                                                                        let _e4668 = (_e4667 > _e2945.member_1);
                                                                        if _e4668 {
                                                                            phi_14428_ = f32();
                                                                            phi_14429_ = f32();
                                                                            phi_14430_ = false;
                                                                        } else {
                                                                            let _e4669 = (_e4667 - _e3893);
                                                                            if _e3901 {
                                                                                if (_e4669 <= _e3888) {
                                                                                    phi_14418_ = true;
                                                                                } else {
                                                                                    if (_e4669 <= (_e3897 * 0.25f)) {
                                                                                        phi_14417_ = false;
                                                                                    } else {
                                                                                        phi_14417_ = true;
                                                                                    }
                                                                                    let _e4675 = phi_14417_;
                                                                                    phi_14418_ = _e4675;
                                                                                }
                                                                                let _e4677 = phi_14418_;
                                                                                if _e4677 {
                                                                                    phi_14423_ = (_e4215 + _e4215);
                                                                                } else {
                                                                                    phi_14423_ = 0f;
                                                                                }
                                                                                let _e4680 = phi_14423_;
                                                                                phi_14425_ = _e4680;
                                                                            } else {
                                                                                phi_14425_ = (_e2945.member_1 - _e3893);
                                                                            }
                                                                            let _e4682 = phi_14425_;
                                                                            phi_14428_ = _e4682;
                                                                            phi_14429_ = _e4669;
                                                                            phi_14430_ = true;
                                                                        }
                                                                        let _e4684 = phi_14428_;
                                                                        let _e4686 = phi_14429_;
                                                                        let _e4688 = phi_14430_;
                                                                        phi_14432_ = _e4667;
                                                                        phi_14433_ = _e4684;
                                                                        phi_14434_ = _e4686;
                                                                        phi_14436_ = _e4688;
                                                                        phi_14437_ = _e4668;
                                                                        phi_14439_ = false;
                                                                    } else {
                                                                        phi_14432_ = f32();
                                                                        phi_14433_ = f32();
                                                                        phi_14434_ = f32();
                                                                        phi_14436_ = false;
                                                                        phi_14437_ = false;
                                                                        phi_14439_ = true;
                                                                    }
                                                                    let _e4690 = phi_14432_;
                                                                    let _e4692 = phi_14433_;
                                                                    let _e4694 = phi_14434_;
                                                                    let _e4696 = phi_14436_;
                                                                    let _e4698 = phi_14437_;
                                                                    let _e4700 = phi_14439_;
                                                                    phi_14440_ = _e4690;
                                                                    phi_14441_ = _e4692;
                                                                    phi_14442_ = _e4694;
                                                                    phi_14444_ = false;
                                                                    phi_14445_ = _e4696;
                                                                    phi_14446_ = _e4698;
                                                                    phi_14448_ = _e4700;
                                                                } else {
                                                                    phi_14440_ = f32();
                                                                    phi_14441_ = f32();
                                                                    phi_14442_ = f32();
                                                                    phi_14444_ = true;
                                                                    phi_14445_ = false;
                                                                    phi_14446_ = false;
                                                                    phi_14448_ = false;
                                                                }
                                                                let _e4702 = phi_14440_;
                                                                let _e4704 = phi_14441_;
                                                                let _e4706 = phi_14442_;
                                                                let _e4708 = phi_14444_;
                                                                let _e4710 = phi_14445_;
                                                                let _e4712 = phi_14446_;
                                                                let _e4714 = phi_14448_;
                                                                phi_14449_ = _e4702;
                                                                phi_14450_ = _e4704;
                                                                phi_14451_ = _e4706;
                                                                phi_14453_ = _e4708;
                                                                phi_14454_ = _e4710;
                                                                phi_14455_ = _e4712;
                                                                phi_14457_ = _e4714;
                                                            } else {
                                                                phi_14449_ = f32();
                                                                phi_14450_ = f32();
                                                                phi_14451_ = f32();
                                                                phi_14453_ = true;
                                                                phi_14454_ = false;
                                                                phi_14455_ = false;
                                                                phi_14457_ = false;
                                                            }
                                                            let _e4716 = phi_14449_;
                                                            let _e4718 = phi_14450_;
                                                            let _e4720 = phi_14451_;
                                                            let _e4722 = phi_14453_;
                                                            let _e4724 = phi_14454_;
                                                            let _e4726 = phi_14455_;
                                                            let _e4728 = phi_14457_;
                                                            if _e4722 {
                                                                if (_e3893 <= _e3895) {
                                                                    let _e4889 = (_e3903 + 1u);
                                                                    let _e4890 = (_e4889 > 3u);
                                                                    if _e4890 {
                                                                        phi_14470_ = false;
                                                                    } else {
                                                                        phi_14470_ = true;
                                                                    }
                                                                    let _e4892 = phi_14470_;
                                                                    phi_14792_ = _e4889;
                                                                    phi_14793_ = f32();
                                                                    phi_14794_ = false;
                                                                    phi_14795_ = _e4892;
                                                                    phi_14796_ = _e4890;
                                                                } else {
                                                                    let _e4732 = local.member[0u];
                                                                    let _e4735 = local.member_1[0u];
                                                                    let _e4738 = local.member[0u];
                                                                    let _e4744 = local.member_2[0u];
                                                                    let _e4745 = ((_e4732 + ((_e4735 - _e4738) * _e3899)) - _e4744);
                                                                    let _e4748 = local.member[1u];
                                                                    let _e4751 = local.member_1[1u];
                                                                    let _e4754 = local.member[1u];
                                                                    let _e4760 = local.member_2[1u];
                                                                    let _e4761 = ((_e4748 + ((_e4751 - _e4754) * _e3899)) - _e4760);
                                                                    if (_e4745 < _e4761) {
                                                                        phi_14543_ = _e4745;
                                                                    } else {
                                                                        phi_14543_ = _e4761;
                                                                    }
                                                                    let _e4764 = phi_14543_;
                                                                    let _e4767 = local.member[2u];
                                                                    let _e4770 = local.member_1[2u];
                                                                    let _e4773 = local.member[2u];
                                                                    let _e4779 = local.member_2[2u];
                                                                    let _e4780 = ((_e4767 + ((_e4770 - _e4773) * _e3899)) - _e4779);
                                                                    let _e4783 = local.member[3u];
                                                                    let _e4786 = local.member_1[3u];
                                                                    let _e4789 = local.member[3u];
                                                                    let _e4795 = local.member_2[3u];
                                                                    let _e4796 = ((_e4783 + ((_e4786 - _e4789) * _e3899)) - _e4795);
                                                                    if (_e4780 < _e4796) {
                                                                        phi_14616_ = _e4780;
                                                                    } else {
                                                                        phi_14616_ = _e4796;
                                                                    }
                                                                    let _e4799 = phi_14616_;
                                                                    if (_e4764 < _e4799) {
                                                                        phi_14621_ = _e4764;
                                                                    } else {
                                                                        phi_14621_ = _e4799;
                                                                    }
                                                                    let _e4802 = phi_14621_;
                                                                    let _e4805 = local_1.member[0u];
                                                                    let _e4808 = local_1.member_1[0u];
                                                                    let _e4811 = local_1.member[0u];
                                                                    let _e4817 = local_1.member_2[0u];
                                                                    let _e4818 = ((_e4805 + ((_e4808 - _e4811) * _e3893)) - _e4817);
                                                                    let _e4821 = local_1.member[1u];
                                                                    let _e4824 = local_1.member_1[1u];
                                                                    let _e4827 = local_1.member[1u];
                                                                    let _e4833 = local_1.member_2[1u];
                                                                    let _e4834 = ((_e4821 + ((_e4824 - _e4827) * _e3893)) - _e4833);
                                                                    if (_e4818 < _e4834) {
                                                                        phi_14694_ = _e4818;
                                                                    } else {
                                                                        phi_14694_ = _e4834;
                                                                    }
                                                                    let _e4837 = phi_14694_;
                                                                    let _e4840 = local_1.member[2u];
                                                                    let _e4843 = local_1.member_1[2u];
                                                                    let _e4846 = local_1.member[2u];
                                                                    let _e4852 = local_1.member_2[2u];
                                                                    let _e4853 = ((_e4840 + ((_e4843 - _e4846) * _e3893)) - _e4852);
                                                                    let _e4856 = local_1.member[3u];
                                                                    let _e4859 = local_1.member_1[3u];
                                                                    let _e4862 = local_1.member[3u];
                                                                    let _e4868 = local_1.member_2[3u];
                                                                    let _e4869 = ((_e4856 + ((_e4859 - _e4862) * _e3893)) - _e4868);
                                                                    if (_e4853 < _e4869) {
                                                                        phi_14767_ = _e4853;
                                                                    } else {
                                                                        phi_14767_ = _e4869;
                                                                    }
                                                                    let _e4872 = phi_14767_;
                                                                    if (_e4837 < _e4872) {
                                                                        phi_14772_ = _e4837;
                                                                    } else {
                                                                        phi_14772_ = _e4872;
                                                                    }
                                                                    let _e4875 = phi_14772_;
                                                                    if (_e4875 > 0f) {
                                                                        phi_14790_ = 0.5f;
                                                                    } else {
                                                                        let _e4879 = (0.95f * (_e4802 / (_e4802 - _e4875)));
                                                                        if (_e4879 > 0.0625f) {
                                                                            if (_e4879 < 0.9f) {
                                                                                phi_14788_ = _e4879;
                                                                            } else {
                                                                                phi_14788_ = 0.9f;
                                                                            }
                                                                            let _e4883 = phi_14788_;
                                                                            phi_14789_ = _e4883;
                                                                        } else {
                                                                            phi_14789_ = 0.0625f;
                                                                        }
                                                                        let _e4885 = phi_14789_;
                                                                        phi_14790_ = _e4885;
                                                                    }
                                                                    let _e4887 = phi_14790_;
                                                                    phi_14792_ = u32();
                                                                    phi_14793_ = (_e4215 * _e4887);
                                                                    phi_14794_ = true;
                                                                    phi_14795_ = false;
                                                                    phi_14796_ = false;
                                                                }
                                                                let _e4894 = phi_14792_;
                                                                let _e4896 = phi_14793_;
                                                                let _e4898 = phi_14794_;
                                                                let _e4900 = phi_14795_;
                                                                let _e4902 = phi_14796_;
                                                                phi_14797_ = _e4894;
                                                                phi_14798_ = _e3895;
                                                                phi_14799_ = _e4896;
                                                                phi_14800_ = _e3897;
                                                                phi_14801_ = _e3899;
                                                                phi_14802_ = _e3901;
                                                                phi_14803_ = _e3903;
                                                                phi_14804_ = _e4898;
                                                                phi_14805_ = _e4900;
                                                                phi_14806_ = _e4902;
                                                                phi_14807_ = false;
                                                                phi_14809_ = false;
                                                            } else {
                                                                phi_14797_ = u32();
                                                                phi_14798_ = _e4716;
                                                                phi_14799_ = _e4718;
                                                                phi_14800_ = _e4720;
                                                                phi_14801_ = _e3893;
                                                                phi_14802_ = true;
                                                                phi_14803_ = 0u;
                                                                phi_14804_ = _e4724;
                                                                phi_14805_ = false;
                                                                phi_14806_ = false;
                                                                phi_14807_ = _e4726;
                                                                phi_14809_ = _e4728;
                                                            }
                                                            let _e4904 = phi_14797_;
                                                            let _e4906 = phi_14798_;
                                                            let _e4908 = phi_14799_;
                                                            let _e4910 = phi_14800_;
                                                            let _e4912 = phi_14801_;
                                                            let _e4914 = phi_14802_;
                                                            let _e4916 = phi_14803_;
                                                            let _e4918 = phi_14804_;
                                                            let _e4920 = phi_14805_;
                                                            let _e4922 = phi_14806_;
                                                            let _e4924 = phi_14807_;
                                                            let _e4926 = phi_14809_;
                                                            if _e4918 {
                                                                let _e4927 = (_e4912 + _e4908);
                                                                if (_e4927 > _e4906) {
                                                                    phi_14818_ = _e4927;
                                                                } else {
                                                                    phi_14818_ = _e4906;
                                                                }
                                                                let _e4930 = phi_14818_;
                                                                if (_e4930 < _e2945.member_1) {
                                                                    phi_14823_ = _e4930;
                                                                } else {
                                                                    phi_14823_ = _e2945.member_1;
                                                                }
                                                                let _e4933 = phi_14823_;
                                                                if !(_e3901) {
                                                                    phi_14832_ = true;
                                                                } else {
                                                                    phi_14832_ = ((_e4933 - _e4912) > _e3888);
                                                                }
                                                                let _e4937 = phi_14832_;
                                                                if _e4937 {
                                                                    phi_14836_ = false;
                                                                } else {
                                                                    phi_14836_ = true;
                                                                }
                                                                let _e4939 = phi_14836_;
                                                                phi_14837_ = _e4933;
                                                                phi_14838_ = _e4906;
                                                                phi_14839_ = _e4910;
                                                                phi_14840_ = _e4912;
                                                                phi_14841_ = _e4914;
                                                                phi_14842_ = _e4916;
                                                                phi_14843_ = _e4937;
                                                                phi_14844_ = _e4939;
                                                                phi_14845_ = false;
                                                                phi_14846_ = false;
                                                                phi_14848_ = false;
                                                            } else {
                                                                phi_14837_ = _e3893;
                                                                phi_14838_ = _e3895;
                                                                phi_14839_ = _e3897;
                                                                phi_14840_ = _e3899;
                                                                phi_14841_ = _e3901;
                                                                phi_14842_ = _e4904;
                                                                phi_14843_ = _e4920;
                                                                phi_14844_ = false;
                                                                phi_14845_ = _e4922;
                                                                phi_14846_ = _e4924;
                                                                phi_14848_ = _e4926;
                                                            }
                                                            let _e4941 = phi_14837_;
                                                            let _e4943 = phi_14838_;
                                                            let _e4945 = phi_14839_;
                                                            let _e4947 = phi_14840_;
                                                            let _e4949 = phi_14841_;
                                                            let _e4951 = phi_14842_;
                                                            let _e4953 = phi_14843_;
                                                            let _e4955 = phi_14844_;
                                                            let _e4957 = phi_14845_;
                                                            let _e4959 = phi_14846_;
                                                            let _e4961 = phi_14848_;
                                                            phi_12670_ = _e4941;
                                                            phi_12672_ = _e4943;
                                                            phi_12674_ = _e4945;
                                                            phi_12676_ = _e4947;
                                                            phi_12678_ = _e4949;
                                                            phi_12680_ = _e4951;
                                                            phi_14849_ = _e4906;
                                                            phi_14851_ = _e4953;
                                                            phi_14852_ = _e4955;
                                                            phi_14853_ = _e4957;
                                                            phi_14854_ = _e4959;
                                                            phi_14856_ = false;
                                                            phi_14857_ = _e4961;
                                                        } else {
                                                            phi_12670_ = f32();
                                                            phi_12672_ = f32();
                                                            phi_12674_ = f32();
                                                            phi_12676_ = f32();
                                                            phi_12678_ = bool();
                                                            phi_12680_ = u32();
                                                            phi_14849_ = f32();
                                                            phi_14851_ = false;
                                                            phi_14852_ = false;
                                                            phi_14853_ = false;
                                                            phi_14854_ = false;
                                                            phi_14856_ = true;
                                                            phi_14857_ = false;
                                                        }
                                                        let _e4963 = phi_12670_;
                                                        let _e4965 = phi_12672_;
                                                        let _e4967 = phi_12674_;
                                                        let _e4969 = phi_12676_;
                                                        let _e4971 = phi_12678_;
                                                        let _e4973 = phi_12680_;
                                                        let _e4975 = phi_14849_;
                                                        let _e4977 = phi_14851_;
                                                        let _e4979 = phi_14852_;
                                                        let _e4981 = phi_14853_;
                                                        let _e4983 = phi_14854_;
                                                        let _e4985 = phi_14856_;
                                                        let _e4987 = phi_14857_;
                                                        local_29 = _e4979;
                                                        local_69 = _e4981;
                                                        local_70 = _e4983;
                                                        local_71 = _e4985;
                                                        local_72 = _e4987;
                                                        local_73 = _e4979;
                                                        local_74 = _e4975;
                                                        continue;
                                                        continuing {
                                                            phi_12666_ = _e3915;
                                                            phi_12669_ = _e4963;
                                                            phi_12671_ = _e4965;
                                                            phi_12673_ = _e4967;
                                                            phi_12675_ = _e4969;
                                                            phi_12677_ = _e4971;
                                                            phi_12679_ = _e4973;
                                                            break if !(_e4977);
                                                        }
                                                    }
                                                    let _e4990 = local_29;
                                                    if _e4990 {
                                                        phi_14861_ = false;
                                                        phi_14862_ = false;
                                                        phi_14864_ = false;
                                                        phi_14865_ = false;
                                                    } else {
                                                        let _e10622 = local_69;
                                                        phi_14861_ = _e10622;
                                                        let _e10625 = local_70;
                                                        phi_14862_ = _e10625;
                                                        let _e10628 = local_71;
                                                        phi_14864_ = _e10628;
                                                        let _e10631 = local_72;
                                                        phi_14865_ = _e10631;
                                                    }
                                                    let _e4992 = phi_14861_;
                                                    let _e4994 = phi_14862_;
                                                    let _e4996 = phi_14864_;
                                                    let _e4998 = phi_14865_;
                                                    if _e4992 {
                                                        let _e5000 = local_30;
                                                        phi_14870_ = type_30(1u, _e5000);
                                                        phi_14871_ = false;
                                                        phi_14873_ = false;
                                                        phi_14874_ = false;
                                                        phi_14875_ = false;
                                                    } else {
                                                        phi_14870_ = type_30();
                                                        phi_14871_ = _e4994;
                                                        let _e10637 = local_73;
                                                        phi_14873_ = _e10637;
                                                        phi_14874_ = _e4996;
                                                        phi_14875_ = _e4998;
                                                    }
                                                    let _e5003 = phi_14870_;
                                                    let _e5005 = phi_14871_;
                                                    let _e5007 = phi_14873_;
                                                    let _e5009 = phi_14874_;
                                                    let _e5011 = phi_14875_;
                                                    if _e5005 {
                                                        phi_14880_ = type_30(0u, type_30().member_1);
                                                        phi_14882_ = false;
                                                        phi_14883_ = false;
                                                        phi_14884_ = false;
                                                        phi_14885_ = true;
                                                    } else {
                                                        phi_14880_ = _e5003;
                                                        phi_14882_ = _e5007;
                                                        phi_14883_ = _e5009;
                                                        phi_14884_ = _e5011;
                                                        phi_14885_ = _e4992;
                                                    }
                                                    let _e5015 = phi_14880_;
                                                    let _e5017 = phi_14882_;
                                                    let _e5019 = phi_14883_;
                                                    let _e5021 = phi_14884_;
                                                    let _e5023 = phi_14885_;
                                                    if _e5017 {
                                                        let _e10647 = local_74;
                                                        phi_14897_ = _e10647;
                                                        phi_14898_ = true;
                                                        phi_14899_ = false;
                                                        phi_14900_ = false;
                                                    } else {
                                                        let _e10649 = local_75;
                                                        phi_14897_ = _e10649;
                                                        phi_14898_ = _e5019;
                                                        phi_14899_ = _e5021;
                                                        phi_14900_ = _e5023;
                                                    }
                                                    let _e5025 = phi_14897_;
                                                    let _e5027 = phi_14898_;
                                                    let _e5029 = phi_14899_;
                                                    let _e5031 = phi_14900_;
                                                    if _e5027 {
                                                        phi_14905_ = type_30(1u, _e5025);
                                                        phi_14906_ = false;
                                                        phi_14907_ = false;
                                                    } else {
                                                        phi_14905_ = type_30();
                                                        phi_14906_ = _e5029;
                                                        phi_14907_ = _e5031;
                                                    }
                                                    let _e5034 = phi_14905_;
                                                    let _e5036 = phi_14906_;
                                                    let _e5038 = phi_14907_;
                                                    if _e5036 {
                                                        phi_14912_ = type_30(0u, type_30().member_1);
                                                        phi_14913_ = true;
                                                    } else {
                                                        phi_14912_ = _e5015;
                                                        phi_14913_ = _e5038;
                                                    }
                                                    let _e5042 = phi_14912_;
                                                    let _e5044 = phi_14913_;
                                                    if _e5044 {
                                                        phi_14917_ = _e5042;
                                                    } else {
                                                        phi_14917_ = _e5034;
                                                    }
                                                    let _e5046 = phi_14917_;
                                                    let _e5049 = (_e5046.member != 0u);
                                                    if _e5049 {
                                                        phi_14924_ = false;
                                                    } else {
                                                        phi_14924_ = true;
                                                    }
                                                    let _e5051 = phi_14924_;
                                                    phi_14925_ = _e5046.member_1;
                                                    phi_14926_ = _e5051;
                                                    phi_14927_ = _e5049;
                                                    phi_14928_ = false;
                                                } else {
                                                    phi_14925_ = f32();
                                                    phi_14926_ = false;
                                                    phi_14927_ = false;
                                                    phi_14928_ = true;
                                                }
                                                let _e5053 = phi_14925_;
                                                let _e5055 = phi_14926_;
                                                let _e5057 = phi_14927_;
                                                let _e5059 = phi_14928_;
                                                phi_14929_ = _e3650;
                                                phi_14930_ = _e3651;
                                                phi_14931_ = _e5053;
                                                phi_14932_ = _e5055;
                                                phi_14933_ = _e5057;
                                                phi_14934_ = _e5059;
                                            }
                                            let _e5061 = phi_14929_;
                                            let _e5063 = phi_14930_;
                                            let _e5065 = phi_14931_;
                                            let _e5067 = phi_14932_;
                                            let _e5069 = phi_14933_;
                                            let _e5071 = phi_14934_;
                                            phi_14935_ = _e5061;
                                            phi_14936_ = _e5063;
                                            phi_14937_ = _e5065;
                                            phi_14938_ = _e3646;
                                            phi_14939_ = _e5067;
                                            phi_14940_ = _e5069;
                                            phi_14941_ = _e5071;
                                        }
                                        let _e5073 = phi_14935_;
                                        let _e5075 = phi_14936_;
                                        let _e5077 = phi_14937_;
                                        let _e5079 = phi_14938_;
                                        let _e5081 = phi_14939_;
                                        let _e5083 = phi_14940_;
                                        let _e5085 = phi_14941_;
                                        if _e5079 {
                                            phi_14945_ = false;
                                            phi_14946_ = false;
                                            phi_14947_ = false;
                                        } else {
                                            phi_14945_ = _e5081;
                                            phi_14946_ = _e5083;
                                            phi_14947_ = _e5085;
                                        }
                                        let _e5087 = phi_14945_;
                                        let _e5089 = phi_14946_;
                                        let _e5091 = phi_14947_;
                                        phi_14948_ = _e2945;
                                        phi_14949_ = _e5073;
                                        phi_14950_ = _e5075;
                                        phi_14951_ = _e5077;
                                        phi_14952_ = _e2945;
                                        phi_14953_ = _e5079;
                                        phi_14954_ = _e5087;
                                        phi_14955_ = _e5089;
                                        phi_14956_ = _e5091;
                                    } else {
                                        phi_14948_ = type_41();
                                        phi_14949_ = bool();
                                        phi_14950_ = f32();
                                        phi_14951_ = f32();
                                        phi_14952_ = type_41();
                                        phi_14953_ = true;
                                        phi_14954_ = false;
                                        phi_14955_ = false;
                                        phi_14956_ = false;
                                    }
                                    let _e5093 = phi_14948_;
                                    let _e5095 = phi_14949_;
                                    let _e5097 = phi_14950_;
                                    let _e5099 = phi_14951_;
                                    let _e5101 = phi_14952_;
                                    let _e5103 = phi_14953_;
                                    let _e5105 = phi_14954_;
                                    let _e5107 = phi_14955_;
                                    let _e5109 = phi_14956_;
                                    if _e5103 {
                                        phi_14960_ = true;
                                        phi_14961_ = false;
                                        phi_14962_ = false;
                                    } else {
                                        phi_14960_ = _e5105;
                                        phi_14961_ = _e5107;
                                        phi_14962_ = _e5109;
                                    }
                                    let _e5111 = phi_14960_;
                                    let _e5113 = phi_14961_;
                                    let _e5115 = phi_14962_;
                                    phi_14963_ = _e5093;
                                    phi_14964_ = _e5095;
                                    phi_14965_ = _e5097;
                                    phi_14966_ = _e5099;
                                    phi_14967_ = _e5101;
                                    phi_14968_ = _e5111;
                                    phi_14969_ = false;
                                    phi_14970_ = _e5113;
                                    phi_14971_ = _e5115;
                                } else {
                                    phi_14963_ = type_41();
                                    phi_14964_ = bool();
                                    phi_14965_ = f32();
                                    phi_14966_ = f32();
                                    phi_14967_ = type_41();
                                    phi_14968_ = false;
                                    phi_14969_ = true;
                                    phi_14970_ = false;
                                    phi_14971_ = false;
                                }
                                let _e5117 = phi_14963_;
                                let _e5119 = phi_14964_;
                                let _e5121 = phi_14965_;
                                let _e5123 = phi_14966_;
                                let _e5125 = phi_14967_;
                                let _e5127 = phi_14968_;
                                let _e5129 = phi_14969_;
                                let _e5131 = phi_14970_;
                                let _e5133 = phi_14971_;
                                local_31 = _e5129;
                                local_76 = _e5131;
                                local_77 = _e5133;
                                local_32 = _e5119;
                                local_33 = _e5117;
                                local_34 = _e5123;
                                local_35 = _e5121;
                                local_36 = _e5123;
                                local_37 = _e5123;
                                local_38 = _e5125;
                                continue;
                                continuing {
                                    phi_10774_ = _e2668;
                                    break if !(_e5127);
                                }
                            }
                            let _e5136 = local_31;
                            if _e5136 {
                                phi_14976_ = type_30(0u, type_30().member_1);
                                phi_14977_ = false;
                                phi_14978_ = false;
                            } else {
                                phi_14976_ = type_30();
                                let _e10705 = local_76;
                                phi_14977_ = _e10705;
                                let _e10708 = local_77;
                                phi_14978_ = _e10708;
                            }
                            let _e5140 = phi_14976_;
                            let _e5142 = phi_14977_;
                            let _e5144 = phi_14978_;
                            if _e5142 {
                                let _e5146 = local_32;
                                if _e5146 {
                                    let _e5148 = local_33;
                                    let _e5151 = local_34;
                                    let _e5154 = local_35;
                                    if ((_e5148.member_1 - _e5151) <= _e5154) {
                                        let _e5157 = local_36;
                                        phi_14992_ = type_30(1u, _e5157);
                                        phi_14993_ = false;
                                    } else {
                                        phi_14992_ = type_30();
                                        phi_14993_ = true;
                                    }
                                    let _e5160 = phi_14992_;
                                    let _e5162 = phi_14993_;
                                    phi_14994_ = _e5160;
                                    phi_14995_ = _e5162;
                                } else {
                                    phi_14994_ = type_30();
                                    phi_14995_ = true;
                                }
                                let _e5164 = phi_14994_;
                                let _e5166 = phi_14995_;
                                if _e5166 {
                                    let _e5168 = local_37;
                                    phi_15000_ = type_30(2u, _e5168);
                                } else {
                                    phi_15000_ = _e5164;
                                }
                                let _e5171 = phi_15000_;
                                phi_15001_ = _e5171;
                                phi_15002_ = false;
                            } else {
                                phi_15001_ = type_30();
                                phi_15002_ = _e5144;
                            }
                            let _e5173 = phi_15001_;
                            let _e5175 = phi_15002_;
                            if _e5175 {
                                let _e5177 = local_38;
                                phi_15008_ = type_30(1u, _e5177.member);
                                phi_15009_ = true;
                            } else {
                                phi_15008_ = _e5173;
                                phi_15009_ = _e5142;
                            }
                            let _e5181 = phi_15008_;
                            let _e5183 = phi_15009_;
                            phi_15013_ = _e5181;
                            phi_15014_ = _e5140;
                            phi_15015_ = _e5183;
                        } else {
                            phi_15013_ = _e2514;
                            phi_15014_ = type_30();
                            phi_15015_ = true;
                        }
                        let _e5185 = phi_15013_;
                        let _e5187 = phi_15014_;
                        let _e5189 = phi_15015_;
                        phi_15019_ = _e5185;
                        phi_15020_ = _e5187;
                        phi_15021_ = _e5189;
                    }
                    let _e5193 = phi_15019_;
                    let _e5195 = phi_15020_;
                    let _e5197 = phi_15021_;
                    if _e5197 {
                        phi_15025_ = _e5193;
                    } else {
                        phi_15025_ = _e5195;
                    }
                    let _e5199 = phi_15025_;
                    if (_e5199.member == 1u) {
                        if (_e5199.member_1 > _e326) {
                            phi_15036_ = false;
                        } else {
                            phi_15036_ = true;
                        }
                        let _e5205 = phi_15036_;
                        phi_15037_ = _e5205;
                    } else {
                        phi_15037_ = true;
                    }
                    let _e5207 = phi_15037_;
                    if _e5207 {
                        phi_15041_ = false;
                    } else {
                        phi_15041_ = true;
                    }
                    let _e5209 = phi_15041_;
                    if _e5209 {
                        phi_15045_ = 1u;
                    } else {
                        phi_15045_ = 0u;
                    }
                    let _e5211 = phi_15045_;
                    phi_15049_ = type_39(_e5199, _e5211);
                }
                let _e9719 = phi_15049_;
                switch bitcast<i32>(_e9719.member.member) {
                    case 0: {
                        phi_15064_ = type_42(0u, _e9719.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9730 = function_(_e9719.member.member_1);
                        phi_15064_ = type_42(0u, _e9719.member_1, _e9730, true);
                        break;
                    }
                    case 2: {
                        let _e9726 = function_(_e9719.member.member_1);
                        phi_15064_ = type_42(1u, _e9719.member_1, _e9726, true);
                        break;
                    }
                    default: {
                        phi_15064_ = type_42();
                        break;
                    }
                }
                let _e9734 = phi_15064_;
                let _e9738 = params.member.member.member_12;
                let _e9739 = bitcast<u32>(_e9738);
                let _e9740 = (_e9739 & 2147483647u);
                if (_e9740 < 8388608u) {
                    phi_15080_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15080_ = array<u32, 2>((_e9739 << bitcast<u32>(29i)), ((_e9739 ^ _e9740) | ((_e9740 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e9751 = phi_15080_;
                if (_e9734.member_2[0] == _e9751[0]) {
                    let _e9757 = params.member.member.member_12;
                    let _e9758 = bitcast<u32>(_e9757);
                    let _e9759 = (_e9758 & 2147483647u);
                    if (_e9759 < 8388608u) {
                        phi_15101_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15101_ = array<u32, 2>((_e9758 << bitcast<u32>(29i)), ((_e9758 ^ _e9759) | ((_e9759 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e9770 = phi_15101_;
                    phi_15104_ = (_e9734.member_2[1] == _e9770[1]);
                } else {
                    phi_15104_ = false;
                }
                let _e9774 = phi_15104_;
                let _e9776 = params.member.member.member_1;
                if ((_e9776 & 128u) != 0u) {
                    phi_15120_ = true;
                } else {
                    let _e9780 = params.member.member.member_1;
                    if ((_e9780 & 64u) != 0u) {
                        phi_15119_ = _e9774;
                    } else {
                        phi_15119_ = false;
                    }
                    let _e9784 = phi_15119_;
                    phi_15120_ = _e9784;
                }
                let _e9786 = phi_15120_;
                if _e9734.member_3 {
                    if _e9786 {
                        phi_15128_ = false;
                    } else {
                        phi_15128_ = true;
                    }
                    let _e9789 = phi_15128_;
                    phi_15129_ = _e9789;
                } else {
                    phi_15129_ = true;
                }
                let _e9791 = phi_15129_;
                if _e9791 {
                    phi_15134_ = _e9734.member;
                } else {
                    phi_15134_ = 1u;
                }
                let _e9794 = phi_15134_;
                if _e9734.member_3 {
                    phi_15142_ = (_e9794 == 0u);
                } else {
                    phi_15142_ = false;
                }
                let _e9800 = phi_15142_;
                if _e9800 {
                    let _e9805 = (_e9734.member_2[1] >> bitcast<u32>(20i));
                    if (_e9805 <= 896u) {
                        phi_15163_ = 0u;
                    } else {
                        phi_15163_ = ((((_e9805 - 896u) << bitcast<u32>(23i)) | ((_e9734.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9734.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9820 = phi_15163_;
                    let _e9822 = atomicMin((&earliest.member[0u]), _e9820);
                }
                phi_15167_ = type_20(1u, 0u, _e210, _e213, _e9734.member_2, _e9734.member_1);
                phi_15168_ = _e9800;
                phi_15169_ = (_e9794 != 0u);
            } else {
                phi_15167_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15168_ = false;
                phi_15169_ = false;
            }
            let _e9824 = phi_15167_;
            let _e9826 = phi_15168_;
            let _e9828 = phi_15169_;
            let _e9831 = params.member.member.member_1;
            if ((_e9831 & 16u) != 0u) {
                if (_e122 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9826 {
                    let _e9837 = atomicAdd((&counters[0u]), 1u);
                    phi_15188_ = _e9837;
                } else {
                    phi_15188_ = 0u;
                }
                let _e9839 = phi_15188_;
                workgroupBarrier();
                if (_e122 == 0u) {
                    let _e9842 = atomicLoad((&counters[0u]));
                    if (_e9842 > 0u) {
                        let _e9845 = atomicAdd((&contacts.member[0u]), _e9842);
                        atomicStore((&counters[1u]), _e9845);
                    }
                }
                workgroupBarrier();
                let _e9848 = atomicLoad((&counters[1u]));
                let _e9849 = (_e9848 + _e9839);
                if _e9826 {
                    let _e9852 = params.member.member_1.member_3;
                    if (_e9849 < _e9852) {
                        let _e9854 = (7u * _e9849);
                        atomicStore((&contacts.member[(4u + _e9854)]), _e9824.member);
                        atomicStore((&contacts.member[(_e9854 + 5u)]), _e9824.member_1);
                        atomicStore((&contacts.member[(_e9854 + 6u)]), _e9824.member_2);
                        atomicStore((&contacts.member[(_e9854 + 7u)]), _e9824.member_3);
                        atomicStore((&contacts.member[(_e9854 + 8u)]), _e9824.member_4[0]);
                        atomicStore((&contacts.member[(_e9854 + 9u)]), _e9824.member_4[1]);
                        atomicStore((&contacts.member[(_e9854 + 10u)]), _e9824.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e122 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9828 {
                let _e9881 = atomicAdd((&counters[0u]), 1u);
                phi_15255_ = _e9881;
            } else {
                phi_15255_ = 0u;
            }
            let _e9883 = phi_15255_;
            workgroupBarrier();
            if (_e122 == 0u) {
                let _e9886 = atomicLoad((&counters[0u]));
                if (_e9886 > 0u) {
                    let _e9889 = atomicAdd((&undecided.member[0u]), _e9886);
                    atomicStore((&counters[1u]), _e9889);
                }
            }
            workgroupBarrier();
            let _e9892 = atomicLoad((&counters[1u]));
            let _e9893 = (_e9892 + _e9883);
            if _e9828 {
                let _e9896 = params.member.member_2.member;
                if (_e9893 < _e9896) {
                    let _e9900 = (2u * _e9893);
                    atomicStore((&undecided.member[(4u + _e9900)]), _e9824.member_2);
                    atomicStore((&undecided.member[(_e9900 + 5u)]), _e9824.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_308_ = _e191;
            break if !(_e197);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
