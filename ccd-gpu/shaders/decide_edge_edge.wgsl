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

struct type_31 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_32 {
    member: f32,
    member_1: f32,
}

struct type_35 {
    member: type_25,
    member_1: f32,
}

struct type_37 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_38 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_42 {
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
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: f32) -> array<u32, 2> {
    var phi_9797_: array<u32, 2>;
    var phi_9798_: array<u32, 2>;
    var phi_9799_: bool;
    var phi_9803_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_9798_ = array<u32, 2>();
        phi_9799_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_9797_ = array<u32, 2>();
        } else {
            phi_9797_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_9797_;
        phi_9798_ = _e31;
        phi_9799_ = _e17;
    }
    let _e33 = phi_9798_;
    let _e35 = phi_9799_;
    if _e35 {
        phi_9803_ = array<u32, 2>(0u, 0u);
    } else {
        phi_9803_ = _e33;
    }
    let _e37 = phi_9803_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_9776_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_9776_ = param_2;
    } else {
        phi_9776_ = param_1;
    }
    let _e26 = phi_9776_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_9368_: bool;
    var phi_9369_: bool;
    var phi_9370_: bool;
    var phi_9371_: bool;
    var phi_9375_: bool;
    var phi_9348_: bool;
    var phi_9349_: bool;
    var phi_9350_: bool;
    var phi_9351_: bool;
    var phi_9352_: bool;
    var phi_9353_: bool;
    var phi_9357_: bool;
    var phi_9376_: bool;
    var phi_9406_: array<f32, 3>;
    var phi_9407_: bool;
    var phi_9408_: array<f32, 3>;
    var phi_9409_: bool;
    var phi_9636_: f32;
    var phi_9637_: f32;
    var phi_9676_: f32;
    var phi_9677_: f32;
    var phi_9722_: f32;
    var phi_9723_: f32;
    var phi_9457_: f32;
    var phi_9458_: f32;
    var phi_9503_: f32;
    var phi_9504_: f32;
    var phi_9546_: f32;
    var phi_9547_: f32;
    var phi_9595_: f32;
    var phi_9596_: f32;
    var phi_9738_: array<array<f32, 3>, 4>;
    var phi_9746_: array<f32, 3>;

    let _e21 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e32 = (((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2]));
    let _e43 = (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2]));
    let _e54 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e65 = (((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e72 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e76 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_6 != 0u) {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                if (_e72 <= 1f) {
                    phi_9348_ = (_e76 <= 1f);
                    phi_9349_ = false;
                } else {
                    phi_9348_ = bool();
                    phi_9349_ = true;
                }
                let _e97 = phi_9348_;
                let _e99 = phi_9349_;
                phi_9350_ = _e97;
                phi_9351_ = _e99;
            } else {
                phi_9350_ = bool();
                phi_9351_ = true;
            }
            let _e101 = phi_9350_;
            let _e103 = phi_9351_;
            phi_9352_ = _e101;
            phi_9353_ = _e103;
        } else {
            phi_9352_ = bool();
            phi_9353_ = true;
        }
        let _e105 = phi_9352_;
        let _e107 = phi_9353_;
        if _e107 {
            phi_9357_ = false;
        } else {
            phi_9357_ = _e105;
        }
        let _e109 = phi_9357_;
        phi_9376_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_9368_ = ((_e72 + _e76) <= 1f);
                phi_9369_ = false;
            } else {
                phi_9368_ = bool();
                phi_9369_ = true;
            }
            let _e83 = phi_9368_;
            let _e85 = phi_9369_;
            phi_9370_ = _e83;
            phi_9371_ = _e85;
        } else {
            phi_9370_ = bool();
            phi_9371_ = true;
        }
        let _e87 = phi_9370_;
        let _e89 = phi_9371_;
        if _e89 {
            phi_9375_ = false;
        } else {
            phi_9375_ = _e87;
        }
        let _e91 = phi_9375_;
        phi_9376_ = _e91;
    }
    let _e111 = phi_9376_;
    if (_e68 > 0f) {
        if _e111 {
            phi_9406_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_9407_ = false;
        } else {
            phi_9406_ = array<f32, 3>();
            phi_9407_ = true;
        }
        let _e136 = phi_9406_;
        let _e138 = phi_9407_;
        phi_9408_ = _e136;
        phi_9409_ = _e138;
    } else {
        phi_9408_ = array<f32, 3>();
        phi_9409_ = true;
    }
    let _e140 = phi_9408_;
    let _e142 = phi_9409_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_9457_ = _e293;
                } else {
                    phi_9457_ = 1f;
                }
                let _e297 = phi_9457_;
                phi_9458_ = _e297;
            } else {
                phi_9458_ = 0f;
            }
            let _e299 = phi_9458_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_9503_ = _e335;
                } else {
                    phi_9503_ = 1f;
                }
                let _e339 = phi_9503_;
                phi_9504_ = _e339;
            } else {
                phi_9504_ = 0f;
            }
            let _e341 = phi_9504_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_9546_ = _e374;
                } else {
                    phi_9546_ = 1f;
                }
                let _e378 = phi_9546_;
                phi_9547_ = _e378;
            } else {
                phi_9547_ = 0f;
            }
            let _e380 = phi_9547_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_9595_ = _e419;
                } else {
                    phi_9595_ = 1f;
                }
                let _e423 = phi_9595_;
                phi_9596_ = _e423;
            } else {
                phi_9596_ = 0f;
            }
            let _e425 = phi_9596_;
            phi_9738_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_9636_ = _e172;
                } else {
                    phi_9636_ = 1f;
                }
                let _e176 = phi_9636_;
                phi_9637_ = _e176;
            } else {
                phi_9637_ = 0f;
            }
            let _e178 = phi_9637_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_9676_ = _e208;
                } else {
                    phi_9676_ = 1f;
                }
                let _e212 = phi_9676_;
                phi_9677_ = _e212;
            } else {
                phi_9677_ = 0f;
            }
            let _e214 = phi_9677_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_9722_ = _e250;
                } else {
                    phi_9722_ = 1f;
                }
                let _e254 = phi_9722_;
                phi_9723_ = _e254;
            } else {
                phi_9723_ = 0f;
            }
            let _e256 = phi_9723_;
            phi_9738_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_9738_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_9746_ = _e445;
    } else {
        phi_9746_ = _e140;
    }
    let _e447 = phi_9746_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_31;
    var local_1: type_31;
    var local_2: type_26;
    var local_3: type_26;
    var local_4: type_26;
    var local_5: array<type_32, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_31;
    var local_10: type_31;
    var local_11: array<f32, 3>;
    var local_12: type_25;
    var phi_223_: u32;
    var phi_239_: u32;
    var phi_260_: u32;
    var phi_261_: u32;
    var phi_264_: type_12;
    var phi_265_: type_12;
    var phi_288_: type_12;
    var phi_463_: f32;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_518_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_580_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_626_: f32;
    var phi_632_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_653_: f32;
    var phi_660_: bool;
    var phi_684_: u32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_727_: type_35;
    var phi_728_: bool;
    var phi_729_: type_35;
    var phi_730_: bool;
    var phi_731_: type_35;
    var phi_732_: bool;
    var phi_737_: type_35;
    var phi_1019_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1038_: f32;
    var phi_1043_: f32;
    var phi_1056_: f32;
    var phi_1063_: f32;
    var phi_1068_: f32;
    var phi_1075_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1102_: f32;
    var phi_1109_: f32;
    var phi_1114_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1140_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1159_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1186_: f32;
    var phi_1193_: f32;
    var phi_1198_: f32;
    var phi_1205_: f32;
    var phi_1210_: f32;
    var phi_1224_: f32;
    var phi_1231_: f32;
    var phi_1236_: f32;
    var phi_1243_: f32;
    var phi_1248_: f32;
    var phi_1253_: f32;
    var phi_1284_: f32;
    var phi_1290_: f32;
    var phi_1297_: f32;
    var phi_1304_: f32;
    var phi_1310_: f32;
    var phi_1317_: f32;
    var phi_1323_: f32;
    var phi_1329_: f32;
    var phi_1335_: f32;
    var phi_1342_: f32;
    var phi_1349_: f32;
    var phi_1373_: f32;
    var phi_1378_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1398_: f32;
    var phi_1408_: f32;
    var phi_4631_: f32;
    var phi_4637_: f32;
    var phi_4642_: f32;
    var phi_4648_: f32;
    var phi_4654_: f32;
    var phi_4659_: f32;
    var phi_4664_: f32;
    var phi_4672_: bool;
    var phi_4677_: f32;
    var phi_4684_: f32;
    var phi_4724_: type_14;
    var phi_4727_: f32;
    var phi_4748_: bool;
    var phi_4754_: type_15;
    var phi_4725_: type_14;
    var phi_4768_: type_15;
    var phi_4728_: f32;
    var local_13: f32;
    var phi_4717_: f32;
    var phi_4781_: f32;
    var phi_4787_: f32;
    var phi_4812_: type_12;
    var phi_4815_: u32;
    var phi_4813_: type_12;
    var phi_4838_: type_12;
    var phi_4882_: u32;
    var phi_4883_: u32;
    var phi_4816_: u32;
    var phi_4884_: u32;
    var phi_4904_: type_12;
    var phi_4905_: type_12;
    var phi_4928_: type_12;
    var phi_4980_: f32;
    var phi_4987_: f32;
    var phi_4998_: bool;
    var phi_4999_: bool;
    var phi_5000_: bool;
    var phi_5001_: bool;
    var phi_5005_: bool;
    var phi_5016_: type_37;
    var phi_5017_: type_37;
    var phi_5018_: bool;
    var phi_5019_: type_37;
    var phi_5020_: bool;
    var phi_5031_: f32;
    var phi_5041_: type_12;
    var phi_5044_: f32;
    var phi_5046_: f32;
    var phi_5048_: f32;
    var phi_5042_: type_12;
    var phi_5071_: type_12;
    var phi_5096_: f32;
    var phi_5097_: f32;
    var phi_5123_: f32;
    var phi_5139_: f32;
    var phi_5146_: bool;
    var phi_5147_: bool;
    var phi_5148_: bool;
    var phi_5154_: f32;
    var phi_5155_: f32;
    var phi_5156_: bool;
    var phi_5045_: f32;
    var phi_5047_: f32;
    var phi_5049_: f32;
    var phi_5157_: f32;
    var phi_5158_: bool;
    var phi_5159_: bool;
    var local_14: bool;
    var phi_5163_: f32;
    var phi_5164_: f32;
    var phi_5172_: f32;
    var phi_5176_: type_12;
    var phi_5179_: f32;
    var phi_5177_: type_12;
    var phi_5202_: type_12;
    var phi_5232_: f32;
    var phi_5233_: bool;
    var phi_5234_: f32;
    var phi_5235_: bool;
    var phi_5236_: bool;
    var phi_5237_: bool;
    var phi_5238_: f32;
    var phi_5180_: f32;
    var phi_5239_: bool;
    var phi_5240_: bool;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var local_15: bool;
    var phi_5246_: bool;
    var phi_5247_: bool;
    var phi_5251_: bool;
    var phi_5255_: f32;
    var phi_5256_: f32;
    var phi_5258_: type_37;
    var phi_5287_: f32;
    var phi_5294_: f32;
    var phi_5299_: f32;
    var phi_5306_: f32;
    var phi_5311_: f32;
    var phi_5324_: f32;
    var phi_5331_: f32;
    var phi_5336_: f32;
    var phi_5343_: f32;
    var phi_5348_: f32;
    var phi_5353_: f32;
    var phi_5412_: f32;
    var phi_5418_: f32;
    var phi_5423_: f32;
    var phi_5429_: f32;
    var phi_5434_: f32;
    var phi_5446_: f32;
    var phi_5452_: f32;
    var phi_5457_: f32;
    var phi_5463_: f32;
    var phi_5468_: f32;
    var phi_5494_: f32;
    var phi_5501_: f32;
    var phi_5506_: f32;
    var phi_5513_: f32;
    var phi_5518_: f32;
    var phi_5531_: f32;
    var phi_5538_: f32;
    var phi_5543_: f32;
    var phi_5550_: f32;
    var phi_5555_: f32;
    var phi_5560_: f32;
    var phi_5619_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5653_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5670_: f32;
    var phi_5675_: f32;
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5725_: f32;
    var phi_5738_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5757_: f32;
    var phi_5762_: f32;
    var phi_5767_: f32;
    var phi_5826_: f32;
    var phi_5832_: f32;
    var phi_5837_: f32;
    var phi_5843_: f32;
    var phi_5848_: f32;
    var phi_5860_: f32;
    var phi_5866_: f32;
    var phi_5871_: f32;
    var phi_5877_: f32;
    var phi_5882_: f32;
    var phi_5931_: f32;
    var phi_5937_: f32;
    var phi_5965_: f32;
    var phi_5971_: f32;
    var phi_5976_: u32;
    var phi_5977_: u32;
    var phi_5947_: f32;
    var phi_5953_: f32;
    var phi_5958_: u32;
    var phi_5959_: u32;
    var phi_5978_: u32;
    var phi_5979_: u32;
    var phi_6048_: f32;
    var phi_6057_: f32;
    var phi_6192_: f32;
    var phi_6198_: f32;
    var phi_6205_: f32;
    var phi_6260_: type_12;
    var phi_6263_: bool;
    var phi_6261_: type_12;
    var phi_6286_: type_12;
    var phi_6313_: bool;
    var phi_6314_: bool;
    var phi_6264_: bool;
    var phi_6315_: bool;
    var phi_6316_: bool;
    var local_16: bool;
    var phi_6320_: bool;
    var local_17: bool;
    var phi_6327_: u32;
    var phi_6328_: u32;
    var phi_6329_: bool;
    var phi_6330_: u32;
    var phi_6331_: u32;
    var phi_6332_: bool;
    var phi_6336_: u32;
    var phi_6356_: bool;
    var phi_6357_: bool;
    var phi_6358_: bool;
    var phi_6506_: f32;
    var phi_6513_: f32;
    var phi_6518_: f32;
    var phi_6525_: f32;
    var phi_6530_: f32;
    var phi_6543_: f32;
    var phi_6550_: f32;
    var phi_6555_: f32;
    var phi_6562_: f32;
    var phi_6567_: f32;
    var phi_6572_: f32;
    var phi_6589_: f32;
    var phi_6596_: f32;
    var phi_6601_: f32;
    var phi_6608_: f32;
    var phi_6613_: f32;
    var phi_6627_: f32;
    var phi_6634_: f32;
    var phi_6639_: f32;
    var phi_6646_: f32;
    var phi_6651_: f32;
    var phi_6656_: f32;
    var phi_6673_: f32;
    var phi_6680_: f32;
    var phi_6685_: f32;
    var phi_6692_: f32;
    var phi_6697_: f32;
    var phi_6711_: f32;
    var phi_6718_: f32;
    var phi_6723_: f32;
    var phi_6730_: f32;
    var phi_6735_: f32;
    var phi_6740_: f32;
    var phi_6780_: type_12;
    var phi_6783_: f32;
    var phi_6785_: f32;
    var phi_6787_: f32;
    var phi_6789_: f32;
    var phi_6791_: bool;
    var phi_6793_: u32;
    var phi_6781_: type_12;
    var phi_6816_: type_12;
    var phi_6930_: f32;
    var phi_6936_: f32;
    var phi_6942_: f32;
    var phi_6944_: array<f32, 3>;
    var phi_6951_: f32;
    var phi_6958_: f32;
    var phi_6966_: f32;
    var phi_7010_: type_14;
    var phi_7013_: f32;
    var phi_7034_: bool;
    var phi_7040_: type_15;
    var phi_7011_: type_14;
    var phi_7054_: type_15;
    var phi_7014_: f32;
    var local_18: f32;
    var phi_7003_: f32;
    var phi_7067_: f32;
    var phi_7133_: f32;
    var phi_7139_: f32;
    var phi_7148_: f32;
    var phi_7154_: f32;
    var phi_7163_: f32;
    var phi_7169_: f32;
    var phi_7178_: f32;
    var phi_7184_: f32;
    var phi_7190_: type_31;
    var phi_7191_: bool;
    var phi_7192_: type_31;
    var phi_7193_: bool;
    var phi_7201_: type_31;
    var phi_7372_: bool;
    var phi_7373_: bool;
    var phi_7374_: bool;
    var phi_7375_: bool;
    var phi_7376_: bool;
    var phi_7377_: bool;
    var phi_7381_: bool;
    var phi_7678_: bool;
    var phi_7679_: bool;
    var phi_7680_: bool;
    var phi_7681_: bool;
    var phi_7682_: bool;
    var phi_7683_: bool;
    var phi_7687_: bool;
    var phi_7691_: bool;
    var phi_7702_: bool;
    var phi_7703_: bool;
    var phi_7777_: bool;
    var phi_7778_: bool;
    var phi_7798_: f32;
    var phi_7799_: bool;
    var phi_7800_: f32;
    var phi_7801_: bool;
    var phi_7802_: f32;
    var phi_7803_: bool;
    var phi_7804_: bool;
    var phi_7808_: f32;
    var phi_7809_: bool;
    var phi_7813_: f32;
    var phi_7845_: bool;
    var phi_7846_: bool;
    var phi_7866_: f32;
    var phi_7867_: bool;
    var phi_7868_: f32;
    var phi_7869_: bool;
    var phi_7870_: f32;
    var phi_7871_: bool;
    var phi_7872_: bool;
    var phi_7876_: f32;
    var phi_7877_: bool;
    var phi_7881_: f32;
    var phi_7886_: f32;
    var phi_7918_: bool;
    var phi_7919_: bool;
    var phi_7939_: f32;
    var phi_7940_: bool;
    var phi_7941_: f32;
    var phi_7942_: bool;
    var phi_7943_: f32;
    var phi_7944_: bool;
    var phi_7945_: bool;
    var phi_7949_: f32;
    var phi_7950_: bool;
    var phi_7954_: f32;
    var phi_7986_: bool;
    var phi_7987_: bool;
    var phi_8007_: f32;
    var phi_8008_: bool;
    var phi_8009_: f32;
    var phi_8010_: bool;
    var phi_8011_: f32;
    var phi_8012_: bool;
    var phi_8013_: bool;
    var phi_8017_: f32;
    var phi_8018_: bool;
    var phi_8022_: f32;
    var phi_8027_: f32;
    var phi_8032_: f32;
    var phi_8037_: f32;
    var phi_8530_: bool;
    var phi_8531_: bool;
    var phi_8536_: f32;
    var phi_8538_: f32;
    var phi_8541_: f32;
    var phi_8542_: f32;
    var phi_8543_: bool;
    var phi_8545_: f32;
    var phi_8546_: f32;
    var phi_8547_: f32;
    var phi_8549_: bool;
    var phi_8550_: bool;
    var phi_8552_: bool;
    var phi_8553_: f32;
    var phi_8554_: f32;
    var phi_8555_: f32;
    var phi_8557_: bool;
    var phi_8558_: bool;
    var phi_8559_: bool;
    var phi_8561_: bool;
    var phi_8562_: f32;
    var phi_8563_: f32;
    var phi_8564_: f32;
    var phi_8566_: bool;
    var phi_8567_: bool;
    var phi_8568_: bool;
    var phi_8570_: bool;
    var phi_8656_: f32;
    var phi_8729_: f32;
    var phi_8734_: f32;
    var phi_8807_: f32;
    var phi_8880_: f32;
    var phi_8885_: f32;
    var phi_8901_: f32;
    var phi_8902_: f32;
    var phi_8903_: f32;
    var phi_8583_: bool;
    var phi_8905_: u32;
    var phi_8906_: f32;
    var phi_8907_: bool;
    var phi_8908_: bool;
    var phi_8909_: bool;
    var phi_8910_: u32;
    var phi_8911_: f32;
    var phi_8912_: f32;
    var phi_8913_: f32;
    var phi_8914_: f32;
    var phi_8915_: bool;
    var phi_8916_: u32;
    var phi_8917_: bool;
    var phi_8918_: bool;
    var phi_8919_: bool;
    var phi_8920_: bool;
    var phi_8922_: bool;
    var phi_8931_: f32;
    var phi_8936_: f32;
    var phi_8945_: bool;
    var phi_8949_: bool;
    var phi_8950_: f32;
    var phi_8951_: f32;
    var phi_8952_: f32;
    var phi_8953_: f32;
    var phi_8954_: bool;
    var phi_8955_: u32;
    var phi_8956_: bool;
    var phi_8957_: bool;
    var phi_8958_: bool;
    var phi_8959_: bool;
    var phi_8961_: bool;
    var phi_6784_: f32;
    var phi_6786_: f32;
    var phi_6788_: f32;
    var phi_6790_: f32;
    var phi_6792_: bool;
    var phi_6794_: u32;
    var phi_8962_: f32;
    var phi_8964_: bool;
    var phi_8965_: bool;
    var phi_8966_: bool;
    var phi_8967_: bool;
    var phi_8969_: bool;
    var phi_8970_: bool;
    var local_19: bool;
    var phi_8974_: bool;
    var phi_8975_: bool;
    var phi_8977_: bool;
    var phi_8978_: bool;
    var local_20: f32;
    var phi_8983_: type_30;
    var phi_8984_: bool;
    var phi_8986_: bool;
    var phi_8987_: bool;
    var phi_8988_: bool;
    var phi_8993_: type_30;
    var phi_8995_: bool;
    var phi_8996_: bool;
    var phi_8997_: bool;
    var phi_8998_: bool;
    var phi_9010_: f32;
    var phi_9011_: bool;
    var phi_9012_: bool;
    var phi_9013_: bool;
    var phi_9018_: type_30;
    var phi_9019_: bool;
    var phi_9020_: bool;
    var phi_9025_: type_30;
    var phi_9026_: bool;
    var phi_9030_: type_30;
    var phi_9037_: bool;
    var phi_9038_: f32;
    var phi_9039_: bool;
    var phi_9040_: bool;
    var phi_9041_: bool;
    var phi_9042_: f32;
    var phi_9043_: bool;
    var phi_9044_: bool;
    var phi_9045_: bool;
    var phi_9046_: f32;
    var phi_9047_: bool;
    var phi_9048_: bool;
    var phi_9049_: bool;
    var phi_9050_: bool;
    var phi_9054_: bool;
    var phi_9055_: bool;
    var phi_9056_: bool;
    var phi_9057_: f32;
    var phi_9058_: type_37;
    var phi_9059_: bool;
    var phi_9060_: bool;
    var phi_9061_: bool;
    var phi_9062_: bool;
    var local_21: bool;
    var phi_9067_: type_30;
    var phi_9068_: bool;
    var phi_9069_: bool;
    var local_22: f32;
    var phi_9074_: type_30;
    var phi_9075_: bool;
    var local_23: type_37;
    var phi_9081_: type_30;
    var phi_9082_: bool;
    var phi_9086_: type_30;
    var phi_1561_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1598_: f32;
    var phi_1605_: f32;
    var phi_1610_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1627_: f32;
    var phi_1644_: f32;
    var phi_1651_: f32;
    var phi_1656_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1682_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1701_: f32;
    var phi_1706_: f32;
    var phi_1711_: f32;
    var phi_1728_: f32;
    var phi_1735_: f32;
    var phi_1740_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1790_: f32;
    var phi_1795_: f32;
    var phi_1835_: type_12;
    var phi_1838_: f32;
    var phi_1840_: f32;
    var phi_1842_: f32;
    var phi_1844_: f32;
    var phi_1846_: bool;
    var phi_1848_: u32;
    var phi_1836_: type_12;
    var phi_1871_: type_12;
    var phi_1985_: f32;
    var phi_1991_: f32;
    var phi_1997_: f32;
    var phi_1999_: array<f32, 3>;
    var phi_2006_: f32;
    var phi_2013_: f32;
    var phi_2021_: f32;
    var phi_2065_: type_14;
    var phi_2068_: f32;
    var phi_2089_: bool;
    var phi_2095_: type_15;
    var phi_2066_: type_14;
    var phi_2109_: type_15;
    var phi_2069_: f32;
    var local_24: f32;
    var phi_2058_: f32;
    var phi_2122_: f32;
    var phi_2188_: f32;
    var phi_2194_: f32;
    var phi_2203_: f32;
    var phi_2209_: f32;
    var phi_2218_: f32;
    var phi_2224_: f32;
    var phi_2233_: f32;
    var phi_2239_: f32;
    var phi_2245_: type_31;
    var phi_2246_: bool;
    var phi_2247_: type_31;
    var phi_2248_: bool;
    var phi_2256_: type_31;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2436_: bool;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2735_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2742_: bool;
    var phi_2746_: bool;
    var phi_2757_: bool;
    var phi_2758_: bool;
    var phi_2832_: bool;
    var phi_2833_: bool;
    var phi_2853_: f32;
    var phi_2854_: bool;
    var phi_2855_: f32;
    var phi_2856_: bool;
    var phi_2857_: f32;
    var phi_2858_: bool;
    var phi_2859_: bool;
    var phi_2863_: f32;
    var phi_2864_: bool;
    var phi_2868_: f32;
    var phi_2900_: bool;
    var phi_2901_: bool;
    var phi_2921_: f32;
    var phi_2922_: bool;
    var phi_2923_: f32;
    var phi_2924_: bool;
    var phi_2925_: f32;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2931_: f32;
    var phi_2932_: bool;
    var phi_2936_: f32;
    var phi_2941_: f32;
    var phi_2973_: bool;
    var phi_2974_: bool;
    var phi_2994_: f32;
    var phi_2995_: bool;
    var phi_2996_: f32;
    var phi_2997_: bool;
    var phi_2998_: f32;
    var phi_2999_: bool;
    var phi_3000_: bool;
    var phi_3004_: f32;
    var phi_3005_: bool;
    var phi_3009_: f32;
    var phi_3041_: bool;
    var phi_3042_: bool;
    var phi_3062_: f32;
    var phi_3063_: bool;
    var phi_3064_: f32;
    var phi_3065_: bool;
    var phi_3066_: f32;
    var phi_3067_: bool;
    var phi_3068_: bool;
    var phi_3072_: f32;
    var phi_3073_: bool;
    var phi_3077_: f32;
    var phi_3082_: f32;
    var phi_3087_: f32;
    var phi_3092_: f32;
    var phi_3104_: f32;
    var phi_3241_: type_14;
    var phi_3244_: f32;
    var phi_3265_: bool;
    var phi_3271_: type_15;
    var phi_3242_: type_14;
    var phi_3285_: type_15;
    var phi_3245_: f32;
    var local_25: f32;
    var phi_3234_: f32;
    var phi_3298_: f32;
    var phi_3314_: f32;
    var phi_3321_: f32;
    var phi_3326_: f32;
    var phi_3333_: f32;
    var phi_3338_: f32;
    var phi_3351_: f32;
    var phi_3358_: f32;
    var phi_3363_: f32;
    var phi_3370_: f32;
    var phi_3375_: f32;
    var phi_3380_: f32;
    var phi_3397_: f32;
    var phi_3404_: f32;
    var phi_3409_: f32;
    var phi_3416_: f32;
    var phi_3421_: f32;
    var phi_3435_: f32;
    var phi_3442_: f32;
    var phi_3447_: f32;
    var phi_3454_: f32;
    var phi_3459_: f32;
    var phi_3464_: f32;
    var phi_3481_: f32;
    var phi_3488_: f32;
    var phi_3493_: f32;
    var phi_3500_: f32;
    var phi_3505_: f32;
    var phi_3519_: f32;
    var phi_3526_: f32;
    var phi_3531_: f32;
    var phi_3538_: f32;
    var phi_3543_: f32;
    var phi_3548_: f32;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var phi_3570_: bool;
    var phi_3585_: bool;
    var phi_3586_: bool;
    var phi_3591_: f32;
    var phi_3593_: f32;
    var phi_3594_: f32;
    var phi_3595_: bool;
    var phi_3596_: f32;
    var phi_3597_: f32;
    var phi_3598_: bool;
    var phi_3599_: bool;
    var phi_3600_: f32;
    var phi_3601_: f32;
    var phi_3602_: f32;
    var phi_3603_: f32;
    var phi_3604_: bool;
    var phi_3605_: bool;
    var phi_3606_: bool;
    var phi_3607_: bool;
    var phi_3608_: f32;
    var phi_3609_: f32;
    var phi_3610_: f32;
    var phi_3611_: f32;
    var phi_3612_: bool;
    var phi_3613_: bool;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3616_: bool;
    var phi_3617_: f32;
    var phi_3618_: f32;
    var phi_3619_: f32;
    var phi_3620_: f32;
    var phi_3621_: bool;
    var phi_3622_: bool;
    var phi_3623_: bool;
    var phi_3624_: bool;
    var phi_3625_: bool;
    var phi_3711_: f32;
    var phi_3784_: f32;
    var phi_3789_: f32;
    var phi_3862_: f32;
    var phi_3935_: f32;
    var phi_3940_: f32;
    var phi_3956_: f32;
    var phi_3957_: f32;
    var phi_3958_: f32;
    var phi_3638_: bool;
    var phi_3960_: u32;
    var phi_3961_: f32;
    var phi_3962_: bool;
    var phi_3963_: bool;
    var phi_3964_: bool;
    var phi_3965_: u32;
    var phi_3966_: f32;
    var phi_3967_: f32;
    var phi_3968_: f32;
    var phi_3969_: f32;
    var phi_3970_: bool;
    var phi_3971_: u32;
    var phi_3972_: bool;
    var phi_3973_: bool;
    var phi_3974_: bool;
    var phi_3975_: bool;
    var phi_3976_: bool;
    var phi_3977_: bool;
    var phi_3986_: f32;
    var phi_3991_: f32;
    var phi_4000_: bool;
    var phi_4004_: bool;
    var phi_4005_: f32;
    var phi_4006_: f32;
    var phi_4007_: f32;
    var phi_4008_: f32;
    var phi_4009_: bool;
    var phi_4010_: u32;
    var phi_4011_: bool;
    var phi_4012_: bool;
    var phi_4013_: bool;
    var phi_4014_: bool;
    var phi_4015_: bool;
    var phi_4016_: bool;
    var phi_1839_: f32;
    var phi_1841_: f32;
    var phi_1843_: f32;
    var phi_1845_: f32;
    var phi_1847_: bool;
    var phi_1849_: u32;
    var phi_4017_: f32;
    var phi_4018_: f32;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var phi_4022_: bool;
    var phi_4023_: bool;
    var phi_4024_: bool;
    var phi_4025_: bool;
    var local_26: bool;
    var phi_4029_: bool;
    var phi_4030_: bool;
    var phi_4031_: bool;
    var phi_4032_: bool;
    var phi_4033_: bool;
    var local_27: f32;
    var phi_4038_: type_30;
    var phi_4039_: bool;
    var phi_4040_: bool;
    var phi_4041_: bool;
    var phi_4042_: bool;
    var phi_4043_: bool;
    var phi_4048_: type_30;
    var phi_4049_: bool;
    var phi_4050_: bool;
    var phi_4051_: bool;
    var phi_4052_: bool;
    var phi_4053_: bool;
    var phi_4057_: f32;
    var phi_4058_: bool;
    var phi_4059_: bool;
    var phi_4060_: bool;
    var phi_4061_: bool;
    var phi_4065_: f32;
    var phi_4066_: bool;
    var phi_4067_: bool;
    var phi_4068_: bool;
    var phi_4073_: type_30;
    var phi_4074_: bool;
    var phi_4075_: bool;
    var phi_4080_: type_30;
    var phi_4081_: bool;
    var phi_4085_: type_30;
    var phi_4098_: type_12;
    var phi_4099_: type_12;
    var phi_4122_: type_12;
    var phi_4142_: f32;
    var phi_4272_: type_14;
    var phi_4275_: f32;
    var phi_4296_: bool;
    var phi_4302_: type_15;
    var phi_4273_: type_14;
    var phi_4316_: type_15;
    var phi_4276_: f32;
    var local_28: f32;
    var phi_4265_: f32;
    var phi_4329_: f32;
    var phi_4345_: f32;
    var phi_4352_: f32;
    var phi_4357_: f32;
    var phi_4364_: f32;
    var phi_4369_: f32;
    var phi_4382_: f32;
    var phi_4389_: f32;
    var phi_4394_: f32;
    var phi_4401_: f32;
    var phi_4406_: f32;
    var phi_4411_: f32;
    var phi_4428_: f32;
    var phi_4435_: f32;
    var phi_4440_: f32;
    var phi_4447_: f32;
    var phi_4452_: f32;
    var phi_4466_: f32;
    var phi_4473_: f32;
    var phi_4478_: f32;
    var phi_4485_: f32;
    var phi_4490_: f32;
    var phi_4495_: f32;
    var phi_4512_: f32;
    var phi_4519_: f32;
    var phi_4524_: f32;
    var phi_4531_: f32;
    var phi_4536_: f32;
    var phi_4550_: f32;
    var phi_4557_: f32;
    var phi_4562_: f32;
    var phi_4569_: f32;
    var phi_4574_: f32;
    var phi_4579_: f32;
    var phi_4599_: bool;
    var phi_4600_: bool;
    var phi_4601_: bool;
    var local_29: bool;
    var phi_4606_: type_30;
    var phi_4607_: bool;
    var phi_4612_: type_30;
    var phi_4613_: bool;
    var phi_4615_: type_30;
    var phi_4616_: type_30;
    var phi_4617_: bool;
    var phi_4621_: type_30;
    var phi_9090_: type_30;
    var phi_9091_: type_30;
    var phi_9104_: type_38;
    var phi_9111_: bool;
    var phi_9135_: u32;
    var phi_9139_: type_20;
    var phi_9140_: bool;
    var phi_9141_: bool;
    var phi_9160_: u32;
    var phi_9223_: u32;
    var local_30: u32;
    var local_31: f32;
    var local_32: f32;
    var local_33: bool;
    var local_34: bool;
    var local_35: f32;
    var local_36: bool;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: f32;
    var local_42: f32;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: f32;
    var local_52: f32;
    var local_53: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e103 = id_2;
    let _e104 = n_2;
    let _e105 = lane_2;
    let _e117 = ((_e103.y * _e104.x) + _e103.x);
    let _e120 = (_e104.x * _e104.y);
    let _e123 = params.member.member_1.member_2;
    let _e125 = input.member[0u];
    if (_e123 < _e125) {
        phi_223_ = _e123;
    } else {
        phi_223_ = _e125;
    }
    let _e128 = phi_223_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_239_ = (_e129 + 1u);
    } else {
        phi_239_ = _e129;
    }
    let _e134 = phi_239_;
    if (_e134 > _e117) {
        let _e136 = (_e134 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e138 = (_e136 / _e120);
        if (_e120 == 0u) {
            return;
        }
        if ((_e136 % _e120) > 0u) {
            phi_260_ = (_e138 + 1u);
        } else {
            phi_260_ = _e138;
        }
        let _e144 = phi_260_;
        phi_261_ = _e144;
    } else {
        phi_261_ = 0u;
    }
    let _e146 = phi_261_;
    phi_264_ = type_12(0u, _e146);
    loop {
        let _e149 = phi_264_;
        if (_e149.member < _e149.member_1) {
            phi_265_ = type_12((_e149.member + 1u), _e149.member_1);
            phi_288_ = type_12(1u, _e149.member);
        } else {
            phi_265_ = _e149;
            phi_288_ = type_12(0u, type_12().member_1);
        }
        let _e161 = phi_265_;
        let _e163 = phi_288_;
        let _e167 = (bitcast<i32>(_e163.member) != 0i);
        if _e167 {
            let _e171 = (((_e117 + (_e163.member_1 * _e120)) * 64u) + _e105);
            if (_e171 < _e128) {
                let _e173 = (2u * _e171);
                let _e176 = input.member[(4u + _e173)];
                let _e179 = input.member[(_e173 + 5u)];
                let _e182 = elements.member[_e176];
                let _e184 = elements.member[_e179];
                let _e190 = paths.member[_e182[0]];
                let _e192 = paths.member[_e182[1]];
                let _e198 = paths.member[_e184[0]];
                let _e200 = paths.member[_e184[1]];
                let _e230 = params.member.member.member_4;
                let _e231 = (_e198.member[0] - _e190.member[0]);
                let _e232 = (_e198.member[1] - _e190.member[1]);
                let _e233 = (_e198.member[2] - _e190.member[2]);
                let _e235 = (_e198.member_1[0] - _e190.member_1[0]);
                let _e236 = (_e198.member_1[1] - _e190.member_1[1]);
                let _e237 = (_e198.member_1[2] - _e190.member_1[2]);
                let _e240 = (_e192.member[0] - _e190.member[0]);
                let _e241 = (_e192.member[1] - _e190.member[1]);
                let _e242 = (_e192.member[2] - _e190.member[2]);
                let _e244 = (_e192.member_1[0] - _e190.member_1[0]);
                let _e245 = (_e192.member_1[1] - _e190.member_1[1]);
                let _e246 = (_e192.member_1[2] - _e190.member_1[2]);
                let _e249 = (_e198.member[0] - _e200.member[0]);
                let _e250 = (_e198.member[1] - _e200.member[1]);
                let _e251 = (_e198.member[2] - _e200.member[2]);
                let _e253 = (_e198.member_1[0] - _e200.member_1[0]);
                let _e254 = (_e198.member_1[1] - _e200.member_1[1]);
                let _e255 = (_e198.member_1[2] - _e200.member_1[2]);
                let _e258 = (_e230 + _e230);
                let _e261 = params.member.member.member_5;
                if (_e231 < 0f) {
                    phi_463_ = -(_e231);
                } else {
                    phi_463_ = _e231;
                }
                let _e265 = phi_463_;
                if (_e232 < 0f) {
                    phi_469_ = -(_e232);
                } else {
                    phi_469_ = _e232;
                }
                let _e269 = phi_469_;
                if (_e265 > _e269) {
                    phi_474_ = _e265;
                } else {
                    phi_474_ = _e269;
                }
                let _e272 = phi_474_;
                if (_e233 < 0f) {
                    phi_480_ = -(_e233);
                } else {
                    phi_480_ = _e233;
                }
                let _e276 = phi_480_;
                if (_e272 > _e276) {
                    phi_485_ = _e272;
                } else {
                    phi_485_ = _e276;
                }
                let _e279 = phi_485_;
                if (_e235 < 0f) {
                    phi_491_ = -(_e235);
                } else {
                    phi_491_ = _e235;
                }
                let _e283 = phi_491_;
                if (_e236 < 0f) {
                    phi_497_ = -(_e236);
                } else {
                    phi_497_ = _e236;
                }
                let _e287 = phi_497_;
                if (_e283 > _e287) {
                    phi_502_ = _e283;
                } else {
                    phi_502_ = _e287;
                }
                let _e290 = phi_502_;
                if (_e237 < 0f) {
                    phi_508_ = -(_e237);
                } else {
                    phi_508_ = _e237;
                }
                let _e294 = phi_508_;
                if (_e290 > _e294) {
                    phi_513_ = _e290;
                } else {
                    phi_513_ = _e294;
                }
                let _e297 = phi_513_;
                if (_e279 > _e297) {
                    phi_518_ = _e279;
                } else {
                    phi_518_ = _e297;
                }
                let _e300 = phi_518_;
                let _e301 = (_e300 + _e258);
                if (_e240 < 0f) {
                    phi_525_ = -(_e240);
                } else {
                    phi_525_ = _e240;
                }
                let _e305 = phi_525_;
                if (_e241 < 0f) {
                    phi_531_ = -(_e241);
                } else {
                    phi_531_ = _e241;
                }
                let _e309 = phi_531_;
                if (_e305 > _e309) {
                    phi_536_ = _e305;
                } else {
                    phi_536_ = _e309;
                }
                let _e312 = phi_536_;
                if (_e242 < 0f) {
                    phi_542_ = -(_e242);
                } else {
                    phi_542_ = _e242;
                }
                let _e316 = phi_542_;
                if (_e312 > _e316) {
                    phi_547_ = _e312;
                } else {
                    phi_547_ = _e316;
                }
                let _e319 = phi_547_;
                if (_e244 < 0f) {
                    phi_553_ = -(_e244);
                } else {
                    phi_553_ = _e244;
                }
                let _e323 = phi_553_;
                if (_e245 < 0f) {
                    phi_559_ = -(_e245);
                } else {
                    phi_559_ = _e245;
                }
                let _e327 = phi_559_;
                if (_e323 > _e327) {
                    phi_564_ = _e323;
                } else {
                    phi_564_ = _e327;
                }
                let _e330 = phi_564_;
                if (_e246 < 0f) {
                    phi_570_ = -(_e246);
                } else {
                    phi_570_ = _e246;
                }
                let _e334 = phi_570_;
                if (_e330 > _e334) {
                    phi_575_ = _e330;
                } else {
                    phi_575_ = _e334;
                }
                let _e337 = phi_575_;
                if (_e319 > _e337) {
                    phi_580_ = _e319;
                } else {
                    phi_580_ = _e337;
                }
                let _e340 = phi_580_;
                let _e341 = (_e340 + _e258);
                if (_e249 < 0f) {
                    phi_587_ = -(_e249);
                } else {
                    phi_587_ = _e249;
                }
                let _e345 = phi_587_;
                if (_e250 < 0f) {
                    phi_593_ = -(_e250);
                } else {
                    phi_593_ = _e250;
                }
                let _e349 = phi_593_;
                if (_e345 > _e349) {
                    phi_598_ = _e345;
                } else {
                    phi_598_ = _e349;
                }
                let _e352 = phi_598_;
                if (_e251 < 0f) {
                    phi_604_ = -(_e251);
                } else {
                    phi_604_ = _e251;
                }
                let _e356 = phi_604_;
                if (_e352 > _e356) {
                    phi_609_ = _e352;
                } else {
                    phi_609_ = _e356;
                }
                let _e359 = phi_609_;
                if (_e253 < 0f) {
                    phi_615_ = -(_e253);
                } else {
                    phi_615_ = _e253;
                }
                let _e363 = phi_615_;
                if (_e254 < 0f) {
                    phi_621_ = -(_e254);
                } else {
                    phi_621_ = _e254;
                }
                let _e367 = phi_621_;
                if (_e363 > _e367) {
                    phi_626_ = _e363;
                } else {
                    phi_626_ = _e367;
                }
                let _e370 = phi_626_;
                if (_e255 < 0f) {
                    phi_632_ = -(_e255);
                } else {
                    phi_632_ = _e255;
                }
                let _e374 = phi_632_;
                if (_e370 > _e374) {
                    phi_637_ = _e370;
                } else {
                    phi_637_ = _e374;
                }
                let _e377 = phi_637_;
                if (_e359 > _e377) {
                    phi_642_ = _e359;
                } else {
                    phi_642_ = _e377;
                }
                let _e380 = phi_642_;
                let _e381 = (_e380 + _e258);
                if (_e301 > _e341) {
                    phi_648_ = _e301;
                } else {
                    phi_648_ = _e341;
                }
                let _e384 = phi_648_;
                if (_e384 > _e381) {
                    phi_653_ = _e384;
                } else {
                    phi_653_ = _e381;
                }
                let _e387 = phi_653_;
                if (_e387 <= 65536f) {
                    phi_660_ = (_e387 >= (1f / 65536f));
                } else {
                    phi_660_ = false;
                }
                let _e392 = phi_660_;
                if _e392 {
                    phi_731_ = type_35();
                    phi_732_ = true;
                } else {
                    if (_e387 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e387) & 2139095040u) != 2139095040u) {
                            let _e399 = (2130706432u - (bitcast<u32>(_e387) & 2139095040u));
                            if (_e399 > 8388608u) {
                                phi_684_ = _e399;
                            } else {
                                phi_684_ = 8388608u;
                            }
                            let _e402 = phi_684_;
                            let _e403 = bitcast<f32>(_e402);
                            let _e404 = (_e261 * _e403);
                            if (_e261 > 0f) {
                                if (_e404 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_695_ = _e404;
                                } else {
                                    phi_695_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e408 = phi_695_;
                                phi_696_ = _e408;
                            } else {
                                phi_696_ = _e404;
                            }
                            let _e410 = phi_696_;
                            phi_727_ = type_35(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e231 * _e403), (_e232 * _e403), (_e233 * _e403)), array<f32, 3>((_e235 * _e403), (_e236 * _e403), (_e237 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e240 * _e403), (_e241 * _e403), (_e242 * _e403)), array<f32, 3>((_e244 * _e403), (_e245 * _e403), (_e246 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e249 * _e403), (_e250 * _e403), (_e251 * _e403)), array<f32, 3>((_e253 * _e403), (_e254 * _e403), (_e255 * _e403))), (_e258 * _e403)), _e410);
                            phi_728_ = false;
                        } else {
                            phi_727_ = type_35();
                            phi_728_ = true;
                        }
                        let _e442 = phi_727_;
                        let _e444 = phi_728_;
                        phi_729_ = _e442;
                        phi_730_ = _e444;
                    } else {
                        phi_729_ = type_35();
                        phi_730_ = true;
                    }
                    let _e446 = phi_729_;
                    let _e448 = phi_730_;
                    phi_731_ = _e446;
                    phi_732_ = _e448;
                }
                let _e450 = phi_731_;
                let _e452 = phi_732_;
                if _e452 {
                    phi_737_ = type_35(type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e231, _e232, _e233), array<f32, 3>(_e235, _e236, _e237)), array<array<f32, 3>, 2>(array<f32, 3>(_e240, _e241, _e242), array<f32, 3>(_e244, _e245, _e246)), array<array<f32, 3>, 2>(array<f32, 3>(_e249, _e250, _e251), array<f32, 3>(_e253, _e254, _e255)), _e258), _e261);
                } else {
                    phi_737_ = _e450;
                }
                let _e455 = phi_737_;
                local_12 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member[0][0], _e455.member.member[0][1], _e455.member.member[0][2]), array<f32, 3>(_e455.member.member[1][0], _e455.member.member[1][1], _e455.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_1[0][0], _e455.member.member_1[0][1], _e455.member.member_1[0][2]), array<f32, 3>(_e455.member.member_1[1][0], _e455.member.member_1[1][1], _e455.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_2[0][0], _e455.member.member_2[0][1], _e455.member.member_2[0][2]), array<f32, 3>(_e455.member.member_2[1][0], _e455.member.member_2[1][1], _e455.member.member_2[1][2])), _e455.member.member_3);
                let _e498 = local_12.member_1[0u];
                let _e504 = local_12.member_2[0u];
                let _e510 = ((_e498[1] * _e504[2]) - (_e498[2] * _e504[1]));
                let _e513 = ((_e498[2] * _e504[0]) - (_e498[0] * _e504[2]));
                let _e516 = ((_e498[0] * _e504[1]) - (_e498[1] * _e504[0]));
                let _e519 = local_12.member_1[1u];
                let _e525 = local_12.member_2[1u];
                let _e531 = ((_e519[1] * _e525[2]) - (_e519[2] * _e525[1]));
                let _e534 = ((_e519[2] * _e525[0]) - (_e519[0] * _e525[2]));
                let _e537 = ((_e519[0] * _e525[1]) - (_e519[1] * _e525[0]));
                let _e540 = local_12.member_1[0u];
                let _e546 = local_12.member_2[1u];
                let _e561 = local_12.member_1[1u];
                let _e567 = local_12.member_2[0u];
                let _e580 = (((_e540[1] * _e546[2]) - (_e540[2] * _e546[1])) + ((_e561[1] * _e567[2]) - (_e561[2] * _e567[1])));
                let _e581 = (((_e540[2] * _e546[0]) - (_e540[0] * _e546[2])) + ((_e561[2] * _e567[0]) - (_e561[0] * _e567[2])));
                let _e582 = (((_e540[0] * _e546[1]) - (_e540[1] * _e546[0])) + ((_e561[0] * _e567[1]) - (_e561[1] * _e567[0])));
                let _e585 = local_12.member[0u];
                let _e593 = (((_e585[0] * _e510) + (_e585[1] * _e513)) + (_e585[2] * _e516));
                let _e596 = local_12.member[1u];
                let _e607 = local_12.member[0u];
                let _e616 = ((((_e596[0] * _e510) + (_e596[1] * _e513)) + (_e596[2] * _e516)) + (((_e607[0] * _e580) + (_e607[1] * _e581)) + (_e607[2] * _e582)));
                let _e619 = local_12.member[0u];
                let _e630 = local_12.member[1u];
                let _e639 = ((((_e619[0] * _e531) + (_e619[1] * _e534)) + (_e619[2] * _e537)) + (((_e630[0] * _e580) + (_e630[1] * _e581)) + (_e630[2] * _e582)));
                let _e642 = local_12.member[1u];
                let _e650 = (((_e642[0] * _e531) + (_e642[1] * _e534)) + (_e642[2] * _e537));
                let _e653 = local_12.member[0u];
                if (_e653[0] < 0f) {
                    phi_1019_ = -(_e653[0]);
                } else {
                    phi_1019_ = _e653[0];
                }
                let _e660 = phi_1019_;
                if (_e653[1] < 0f) {
                    phi_1026_ = -(_e653[1]);
                } else {
                    phi_1026_ = _e653[1];
                }
                let _e664 = phi_1026_;
                if (_e660 > _e664) {
                    phi_1031_ = _e660;
                } else {
                    phi_1031_ = _e664;
                }
                let _e667 = phi_1031_;
                if (_e653[2] < 0f) {
                    phi_1038_ = -(_e653[2]);
                } else {
                    phi_1038_ = _e653[2];
                }
                let _e671 = phi_1038_;
                if (_e667 > _e671) {
                    phi_1043_ = _e667;
                } else {
                    phi_1043_ = _e671;
                }
                let _e674 = phi_1043_;
                let _e677 = local_12.member[1u];
                if (_e677[0] < 0f) {
                    phi_1056_ = -(_e677[0]);
                } else {
                    phi_1056_ = _e677[0];
                }
                let _e684 = phi_1056_;
                if (_e677[1] < 0f) {
                    phi_1063_ = -(_e677[1]);
                } else {
                    phi_1063_ = _e677[1];
                }
                let _e688 = phi_1063_;
                if (_e684 > _e688) {
                    phi_1068_ = _e684;
                } else {
                    phi_1068_ = _e688;
                }
                let _e691 = phi_1068_;
                if (_e677[2] < 0f) {
                    phi_1075_ = -(_e677[2]);
                } else {
                    phi_1075_ = _e677[2];
                }
                let _e695 = phi_1075_;
                if (_e691 > _e695) {
                    phi_1080_ = _e691;
                } else {
                    phi_1080_ = _e695;
                }
                let _e698 = phi_1080_;
                if (_e674 > _e698) {
                    phi_1085_ = _e674;
                } else {
                    phi_1085_ = _e698;
                }
                let _e701 = phi_1085_;
                let _e703 = local_12.member_3;
                let _e704 = (_e701 + _e703);
                let _e707 = local_12.member_1[0u];
                if (_e707[0] < 0f) {
                    phi_1102_ = -(_e707[0]);
                } else {
                    phi_1102_ = _e707[0];
                }
                let _e714 = phi_1102_;
                if (_e707[1] < 0f) {
                    phi_1109_ = -(_e707[1]);
                } else {
                    phi_1109_ = _e707[1];
                }
                let _e718 = phi_1109_;
                if (_e714 > _e718) {
                    phi_1114_ = _e714;
                } else {
                    phi_1114_ = _e718;
                }
                let _e721 = phi_1114_;
                if (_e707[2] < 0f) {
                    phi_1121_ = -(_e707[2]);
                } else {
                    phi_1121_ = _e707[2];
                }
                let _e725 = phi_1121_;
                if (_e721 > _e725) {
                    phi_1126_ = _e721;
                } else {
                    phi_1126_ = _e725;
                }
                let _e728 = phi_1126_;
                let _e731 = local_12.member_1[1u];
                if (_e731[0] < 0f) {
                    phi_1140_ = -(_e731[0]);
                } else {
                    phi_1140_ = _e731[0];
                }
                let _e738 = phi_1140_;
                if (_e731[1] < 0f) {
                    phi_1147_ = -(_e731[1]);
                } else {
                    phi_1147_ = _e731[1];
                }
                let _e742 = phi_1147_;
                if (_e738 > _e742) {
                    phi_1152_ = _e738;
                } else {
                    phi_1152_ = _e742;
                }
                let _e745 = phi_1152_;
                if (_e731[2] < 0f) {
                    phi_1159_ = -(_e731[2]);
                } else {
                    phi_1159_ = _e731[2];
                }
                let _e749 = phi_1159_;
                if (_e745 > _e749) {
                    phi_1164_ = _e745;
                } else {
                    phi_1164_ = _e749;
                }
                let _e752 = phi_1164_;
                if (_e728 > _e752) {
                    phi_1169_ = _e728;
                } else {
                    phi_1169_ = _e752;
                }
                let _e755 = phi_1169_;
                let _e757 = local_12.member_3;
                let _e758 = (_e755 + _e757);
                let _e761 = local_12.member_2[0u];
                if (_e761[0] < 0f) {
                    phi_1186_ = -(_e761[0]);
                } else {
                    phi_1186_ = _e761[0];
                }
                let _e768 = phi_1186_;
                if (_e761[1] < 0f) {
                    phi_1193_ = -(_e761[1]);
                } else {
                    phi_1193_ = _e761[1];
                }
                let _e772 = phi_1193_;
                if (_e768 > _e772) {
                    phi_1198_ = _e768;
                } else {
                    phi_1198_ = _e772;
                }
                let _e775 = phi_1198_;
                if (_e761[2] < 0f) {
                    phi_1205_ = -(_e761[2]);
                } else {
                    phi_1205_ = _e761[2];
                }
                let _e779 = phi_1205_;
                if (_e775 > _e779) {
                    phi_1210_ = _e775;
                } else {
                    phi_1210_ = _e779;
                }
                let _e782 = phi_1210_;
                let _e785 = local_12.member_2[1u];
                if (_e785[0] < 0f) {
                    phi_1224_ = -(_e785[0]);
                } else {
                    phi_1224_ = _e785[0];
                }
                let _e792 = phi_1224_;
                if (_e785[1] < 0f) {
                    phi_1231_ = -(_e785[1]);
                } else {
                    phi_1231_ = _e785[1];
                }
                let _e796 = phi_1231_;
                if (_e792 > _e796) {
                    phi_1236_ = _e792;
                } else {
                    phi_1236_ = _e796;
                }
                let _e799 = phi_1236_;
                if (_e785[2] < 0f) {
                    phi_1243_ = -(_e785[2]);
                } else {
                    phi_1243_ = _e785[2];
                }
                let _e803 = phi_1243_;
                if (_e799 > _e803) {
                    phi_1248_ = _e799;
                } else {
                    phi_1248_ = _e803;
                }
                let _e806 = phi_1248_;
                if (_e782 > _e806) {
                    phi_1253_ = _e782;
                } else {
                    phi_1253_ = _e806;
                }
                let _e809 = phi_1253_;
                let _e811 = local_12.member_3;
                let _e812 = (_e809 + _e811);
                let _e814 = ((_e758 * 8f) * _e812);
                let _e821 = local_12.member_3;
                if (_e510 < 0f) {
                    phi_1284_ = -(_e510);
                } else {
                    phi_1284_ = _e510;
                }
                let _e838 = phi_1284_;
                if (_e513 < 0f) {
                    phi_1290_ = -(_e513);
                } else {
                    phi_1290_ = _e513;
                }
                let _e842 = phi_1290_;
                if (_e516 < 0f) {
                    phi_1297_ = -(_e516);
                } else {
                    phi_1297_ = _e516;
                }
                let _e847 = phi_1297_;
                let _e848 = ((_e838 + _e842) + _e847);
                if (_e531 < 0f) {
                    phi_1304_ = -(_e531);
                } else {
                    phi_1304_ = _e531;
                }
                let _e852 = phi_1304_;
                if (_e534 < 0f) {
                    phi_1310_ = -(_e534);
                } else {
                    phi_1310_ = _e534;
                }
                let _e856 = phi_1310_;
                if (_e537 < 0f) {
                    phi_1317_ = -(_e537);
                } else {
                    phi_1317_ = _e537;
                }
                let _e861 = phi_1317_;
                let _e862 = ((_e852 + _e856) + _e861);
                if (_e848 > _e862) {
                    phi_1323_ = _e848;
                } else {
                    phi_1323_ = _e862;
                }
                let _e865 = phi_1323_;
                if (_e580 < 0f) {
                    phi_1329_ = -(_e580);
                } else {
                    phi_1329_ = _e580;
                }
                let _e869 = phi_1329_;
                if (_e581 < 0f) {
                    phi_1335_ = -(_e581);
                } else {
                    phi_1335_ = _e581;
                }
                let _e873 = phi_1335_;
                if (_e582 < 0f) {
                    phi_1342_ = -(_e582);
                } else {
                    phi_1342_ = _e582;
                }
                let _e878 = phi_1342_;
                let _e880 = (((_e869 + _e873) + _e878) * 0.5f);
                if (_e865 > _e880) {
                    phi_1349_ = _e865;
                } else {
                    phi_1349_ = _e880;
                }
                let _e883 = phi_1349_;
                let _e888 = local_12.member_3;
                let _e900 = (((((_e704 * 8f) * _e814) * (0.000000059604645f * (524f / 64f))) + ((_e821 * 19f) * ((_e704 * (_e758 + _e812)) + (_e758 * _e812)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e704) * ((1f + _e758) * (1f + _e812)))));
                let _e901 = (_e593 * 3f);
                let _e902 = (_e650 * 3f);
                if (_e901 < _e902) {
                    phi_1373_ = _e901;
                } else {
                    phi_1373_ = _e902;
                }
                let _e905 = phi_1373_;
                if (_e616 < _e639) {
                    phi_1378_ = _e616;
                } else {
                    phi_1378_ = _e639;
                }
                let _e908 = phi_1378_;
                if (_e905 < _e908) {
                    phi_1383_ = _e905;
                } else {
                    phi_1383_ = _e908;
                }
                let _e911 = phi_1383_;
                if (_e901 > _e902) {
                    phi_1388_ = _e901;
                } else {
                    phi_1388_ = _e902;
                }
                let _e914 = phi_1388_;
                if (_e616 > _e639) {
                    phi_1393_ = _e616;
                } else {
                    phi_1393_ = _e639;
                }
                let _e917 = phi_1393_;
                if (_e914 > _e917) {
                    phi_1398_ = _e914;
                } else {
                    phi_1398_ = _e917;
                }
                let _e920 = phi_1398_;
                let _e925 = -(_e920);
                if (_e911 > _e925) {
                    phi_1408_ = _e911;
                } else {
                    phi_1408_ = _e925;
                }
                let _e928 = phi_1408_;
                if ((_e928 - (_e900 + ((_e455.member_1 * (((_e883 + (_e814 * (0.000000059604645f * 8f))) + ((_e888 * 6f) * (_e758 + _e812))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e758) * (1f + _e812))))) * (3f * 1.0001f)))) > 0f) {
                    phi_9091_ = type_30(0u, type_30().member_1);
                } else {
                    if (_e455.member_1 > 0f) {
                        let _e3572 = local_12.member[0u];
                        let _e3578 = local_12.member_1[0u];
                        let _e3584 = local_12.member_2[0u];
                        let _e3588 = (_e3572[0] - _e3578[0]);
                        let _e3589 = (_e3572[1] - _e3578[1]);
                        let _e3590 = (_e3572[2] - _e3578[2]);
                        let _e3599 = local_12.member[1u];
                        let _e3605 = local_12.member_1[1u];
                        let _e3611 = local_12.member_2[1u];
                        let _e3615 = (_e3599[0] - _e3605[0]);
                        let _e3616 = (_e3599[1] - _e3605[1]);
                        let _e3617 = (_e3599[2] - _e3605[2]);
                        let _e3626 = local_12.member[0u];
                        if (_e3626[0] < 0f) {
                            phi_1561_ = -(_e3626[0]);
                        } else {
                            phi_1561_ = _e3626[0];
                        }
                        let _e3633 = phi_1561_;
                        if (_e3626[1] < 0f) {
                            phi_1568_ = -(_e3626[1]);
                        } else {
                            phi_1568_ = _e3626[1];
                        }
                        let _e3637 = phi_1568_;
                        if (_e3633 > _e3637) {
                            phi_1573_ = _e3633;
                        } else {
                            phi_1573_ = _e3637;
                        }
                        let _e3640 = phi_1573_;
                        if (_e3626[2] < 0f) {
                            phi_1580_ = -(_e3626[2]);
                        } else {
                            phi_1580_ = _e3626[2];
                        }
                        let _e3644 = phi_1580_;
                        if (_e3640 > _e3644) {
                            phi_1585_ = _e3640;
                        } else {
                            phi_1585_ = _e3644;
                        }
                        let _e3647 = phi_1585_;
                        let _e3650 = local_12.member[1u];
                        if (_e3650[0] < 0f) {
                            phi_1598_ = -(_e3650[0]);
                        } else {
                            phi_1598_ = _e3650[0];
                        }
                        let _e3657 = phi_1598_;
                        if (_e3650[1] < 0f) {
                            phi_1605_ = -(_e3650[1]);
                        } else {
                            phi_1605_ = _e3650[1];
                        }
                        let _e3661 = phi_1605_;
                        if (_e3657 > _e3661) {
                            phi_1610_ = _e3657;
                        } else {
                            phi_1610_ = _e3661;
                        }
                        let _e3664 = phi_1610_;
                        if (_e3650[2] < 0f) {
                            phi_1617_ = -(_e3650[2]);
                        } else {
                            phi_1617_ = _e3650[2];
                        }
                        let _e3668 = phi_1617_;
                        if (_e3664 > _e3668) {
                            phi_1622_ = _e3664;
                        } else {
                            phi_1622_ = _e3668;
                        }
                        let _e3671 = phi_1622_;
                        if (_e3647 > _e3671) {
                            phi_1627_ = _e3647;
                        } else {
                            phi_1627_ = _e3671;
                        }
                        let _e3674 = phi_1627_;
                        let _e3676 = local_12.member_3;
                        let _e3680 = local_12.member_1[0u];
                        if (_e3680[0] < 0f) {
                            phi_1644_ = -(_e3680[0]);
                        } else {
                            phi_1644_ = _e3680[0];
                        }
                        let _e3687 = phi_1644_;
                        if (_e3680[1] < 0f) {
                            phi_1651_ = -(_e3680[1]);
                        } else {
                            phi_1651_ = _e3680[1];
                        }
                        let _e3691 = phi_1651_;
                        if (_e3687 > _e3691) {
                            phi_1656_ = _e3687;
                        } else {
                            phi_1656_ = _e3691;
                        }
                        let _e3694 = phi_1656_;
                        if (_e3680[2] < 0f) {
                            phi_1663_ = -(_e3680[2]);
                        } else {
                            phi_1663_ = _e3680[2];
                        }
                        let _e3698 = phi_1663_;
                        if (_e3694 > _e3698) {
                            phi_1668_ = _e3694;
                        } else {
                            phi_1668_ = _e3698;
                        }
                        let _e3701 = phi_1668_;
                        let _e3704 = local_12.member_1[1u];
                        if (_e3704[0] < 0f) {
                            phi_1682_ = -(_e3704[0]);
                        } else {
                            phi_1682_ = _e3704[0];
                        }
                        let _e3711 = phi_1682_;
                        if (_e3704[1] < 0f) {
                            phi_1689_ = -(_e3704[1]);
                        } else {
                            phi_1689_ = _e3704[1];
                        }
                        let _e3715 = phi_1689_;
                        if (_e3711 > _e3715) {
                            phi_1694_ = _e3711;
                        } else {
                            phi_1694_ = _e3715;
                        }
                        let _e3718 = phi_1694_;
                        if (_e3704[2] < 0f) {
                            phi_1701_ = -(_e3704[2]);
                        } else {
                            phi_1701_ = _e3704[2];
                        }
                        let _e3722 = phi_1701_;
                        if (_e3718 > _e3722) {
                            phi_1706_ = _e3718;
                        } else {
                            phi_1706_ = _e3722;
                        }
                        let _e3725 = phi_1706_;
                        if (_e3701 > _e3725) {
                            phi_1711_ = _e3701;
                        } else {
                            phi_1711_ = _e3725;
                        }
                        let _e3728 = phi_1711_;
                        let _e3730 = local_12.member_3;
                        let _e3734 = local_12.member_2[0u];
                        if (_e3734[0] < 0f) {
                            phi_1728_ = -(_e3734[0]);
                        } else {
                            phi_1728_ = _e3734[0];
                        }
                        let _e3741 = phi_1728_;
                        if (_e3734[1] < 0f) {
                            phi_1735_ = -(_e3734[1]);
                        } else {
                            phi_1735_ = _e3734[1];
                        }
                        let _e3745 = phi_1735_;
                        if (_e3741 > _e3745) {
                            phi_1740_ = _e3741;
                        } else {
                            phi_1740_ = _e3745;
                        }
                        let _e3748 = phi_1740_;
                        if (_e3734[2] < 0f) {
                            phi_1747_ = -(_e3734[2]);
                        } else {
                            phi_1747_ = _e3734[2];
                        }
                        let _e3752 = phi_1747_;
                        if (_e3748 > _e3752) {
                            phi_1752_ = _e3748;
                        } else {
                            phi_1752_ = _e3752;
                        }
                        let _e3755 = phi_1752_;
                        let _e3758 = local_12.member_2[1u];
                        if (_e3758[0] < 0f) {
                            phi_1766_ = -(_e3758[0]);
                        } else {
                            phi_1766_ = _e3758[0];
                        }
                        let _e3765 = phi_1766_;
                        if (_e3758[1] < 0f) {
                            phi_1773_ = -(_e3758[1]);
                        } else {
                            phi_1773_ = _e3758[1];
                        }
                        let _e3769 = phi_1773_;
                        if (_e3765 > _e3769) {
                            phi_1778_ = _e3765;
                        } else {
                            phi_1778_ = _e3769;
                        }
                        let _e3772 = phi_1778_;
                        if (_e3758[2] < 0f) {
                            phi_1785_ = -(_e3758[2]);
                        } else {
                            phi_1785_ = _e3758[2];
                        }
                        let _e3776 = phi_1785_;
                        if (_e3772 > _e3776) {
                            phi_1790_ = _e3772;
                        } else {
                            phi_1790_ = _e3776;
                        }
                        let _e3779 = phi_1790_;
                        if (_e3755 > _e3779) {
                            phi_1795_ = _e3755;
                        } else {
                            phi_1795_ = _e3779;
                        }
                        let _e3782 = phi_1795_;
                        let _e3784 = local_12.member_3;
                        let _e3791 = local_12.member_3;
                        local_9 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_1835_ = type_12(0u, 96u);
                        phi_1838_ = 0f;
                        phi_1840_ = 0f;
                        phi_1842_ = (1f - 0f);
                        phi_1844_ = 0f;
                        phi_1846_ = false;
                        phi_1848_ = 0u;
                        loop {
                            let _e3798 = phi_1835_;
                            let _e3800 = phi_1838_;
                            let _e3802 = phi_1840_;
                            let _e3804 = phi_1842_;
                            let _e3806 = phi_1844_;
                            let _e3808 = phi_1846_;
                            let _e3810 = phi_1848_;
                            local_27 = _e3800;
                            local_53 = _e3802;
                            if (_e3798.member < _e3798.member_1) {
                                phi_1836_ = type_12((_e3798.member + 1u), _e3798.member_1);
                                phi_1871_ = type_12(1u, _e3798.member);
                            } else {
                                phi_1836_ = _e3798;
                                phi_1871_ = type_12(0u, type_12().member_1);
                            }
                            let _e3822 = phi_1836_;
                            let _e3824 = phi_1871_;
                            if (bitcast<i32>(_e3824.member) != 0i) {
                                let _e3830 = local_12.member[0u];
                                let _e3836 = local_12.member[1u];
                                let _e3852 = local_12.member_1[0u];
                                let _e3858 = local_12.member_1[1u];
                                let _e3874 = local_12.member_2[0u];
                                let _e3880 = local_12.member_2[1u];
                                let _e3894 = function_2(array<f32, 3>((_e3830[0] + ((_e3836[0] - _e3830[0]) * _e3800)), (_e3830[1] + ((_e3836[1] - _e3830[1]) * _e3800)), (_e3830[2] + ((_e3836[2] - _e3830[2]) * _e3800))), array<f32, 3>((_e3852[0] + ((_e3858[0] - _e3852[0]) * _e3800)), (_e3852[1] + ((_e3858[1] - _e3852[1]) * _e3800)), (_e3852[2] + ((_e3858[2] - _e3852[2]) * _e3800))), array<f32, 3>((_e3874[0] + ((_e3880[0] - _e3874[0]) * _e3800)), (_e3874[1] + ((_e3880[1] - _e3874[1]) * _e3800)), (_e3874[2] + ((_e3880[2] - _e3874[2]) * _e3800))), 1u);
                                if (_e3810 == 0u) {
                                    phi_1999_ = _e3894;
                                } else {
                                    if (_e3810 == 1u) {
                                        phi_1985_ = _e3894[0];
                                    } else {
                                        phi_1985_ = 0f;
                                    }
                                    let _e3899 = phi_1985_;
                                    if (_e3810 == 2u) {
                                        phi_1991_ = _e3894[1];
                                    } else {
                                        phi_1991_ = 0f;
                                    }
                                    let _e3903 = phi_1991_;
                                    if (_e3810 == 3u) {
                                        phi_1997_ = _e3894[2];
                                    } else {
                                        phi_1997_ = 0f;
                                    }
                                    let _e3907 = phi_1997_;
                                    phi_1999_ = array<f32, 3>(_e3899, _e3903, _e3907);
                                }
                                let _e3910 = phi_1999_;
                                if (_e3910[0] < 0f) {
                                    phi_2006_ = -(_e3910[0]);
                                } else {
                                    phi_2006_ = _e3910[0];
                                }
                                let _e3915 = phi_2006_;
                                if (_e3910[1] < 0f) {
                                    phi_2013_ = -(_e3910[1]);
                                } else {
                                    phi_2013_ = _e3910[1];
                                }
                                let _e3920 = phi_2013_;
                                if (_e3910[2] < 0f) {
                                    phi_2021_ = -(_e3910[2]);
                                } else {
                                    phi_2021_ = _e3910[2];
                                }
                                let _e3926 = phi_2021_;
                                let _e3927 = ((_e3915 + _e3920) + _e3926);
                                if (_e3927 > 0f) {
                                    if ((bitcast<u32>(_e3927) & 2139095040u) != 2139095040u) {
                                        let _e3932 = (1f / _e3927);
                                        let _e3934 = (_e3910[0] * _e3932);
                                        let _e3936 = (_e3910[1] * _e3932);
                                        let _e3938 = (_e3910[2] * _e3932);
                                        let _e3943 = (((_e3934 * _e3934) + (_e3936 * _e3936)) + (_e3938 * _e3938));
                                        if (_e3943 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3943 > 0f) {
                                                phi_2058_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2058_ = 0f;
                                            }
                                            let _e3996 = phi_2058_;
                                            phi_2122_ = _e3996;
                                        } else {
                                            phi_2065_ = type_14(0i, 5i);
                                            phi_2068_ = bitcast<f32>(((bitcast<u32>(_e3943) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3951 = phi_2065_;
                                                let _e3953 = phi_2068_;
                                                local_24 = _e3953;
                                                if (_e3951.member < _e3951.member_1) {
                                                    let _e3960 = (_e3951.member + 1i);
                                                    if ((false == (_e3960 > _e3951.member)) != false) {
                                                        phi_2089_ = true;
                                                    } else {
                                                        phi_2089_ = false;
                                                    }
                                                    let _e3965 = phi_2089_;
                                                    if _e3965 {
                                                        phi_2095_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2095_ = type_15(1u, _e3960);
                                                    }
                                                    let _e3970 = phi_2095_;
                                                    phi_2066_ = type_14(_e3970.member_1, _e3951.member_1);
                                                    phi_2109_ = type_15(1u, _e3951.member);
                                                } else {
                                                    phi_2066_ = _e3951;
                                                    phi_2109_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3976 = phi_2066_;
                                                let _e3978 = phi_2109_;
                                                let _e3981 = (bitcast<i32>(_e3978.member) != 0i);
                                                if _e3981 {
                                                    phi_2069_ = (0.5f * (_e3953 + (_e3943 / _e3953)));
                                                } else {
                                                    phi_2069_ = f32();
                                                }
                                                let _e3986 = phi_2069_;
                                                continue;
                                                continuing {
                                                    phi_2065_ = _e3976;
                                                    phi_2068_ = _e3986;
                                                    break if !(_e3981);
                                                }
                                            }
                                            let _e3991 = local_24;
                                            phi_2122_ = (_e3991 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3998 = phi_2122_;
                                        let _e3999 = (0.000000059604645f * 12f);
                                        let _e4004 = ((((((((_e3674 + _e3676) + (_e3728 + _e3730)) + (_e3782 + _e3784)) * (0.000000059604645f * 16f)) + (_e3791 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e455.member_1 * _e3998) * (1f + _e3999)));
                                        let _e4009 = (((_e3934 * _e3572[0]) + (_e3936 * _e3572[1])) + (_e3938 * _e3572[2]));
                                        let _e4014 = (((_e3934 * _e3588) + (_e3936 * _e3589)) + (_e3938 * _e3590));
                                        let _e4019 = (((_e3934 * (_e3572[0] - _e3584[0])) + (_e3936 * (_e3572[1] - _e3584[1]))) + (_e3938 * (_e3572[2] - _e3584[2])));
                                        let _e4024 = (((_e3934 * (_e3588 - _e3584[0])) + (_e3936 * (_e3589 - _e3584[1]))) + (_e3938 * (_e3590 - _e3584[2])));
                                        let _e4030 = (((_e3934 * _e3599[0]) + (_e3936 * _e3599[1])) + (_e3938 * _e3599[2]));
                                        let _e4035 = (((_e3934 * _e3615) + (_e3936 * _e3616)) + (_e3938 * _e3617));
                                        let _e4040 = (((_e3934 * (_e3599[0] - _e3611[0])) + (_e3936 * (_e3599[1] - _e3611[1]))) + (_e3938 * (_e3599[2] - _e3611[2])));
                                        let _e4045 = (((_e3934 * (_e3615 - _e3611[0])) + (_e3936 * (_e3616 - _e3611[1]))) + (_e3938 * (_e3617 - _e3611[2])));
                                        if (_e4009 < 0f) {
                                            phi_2188_ = -(_e4009);
                                        } else {
                                            phi_2188_ = _e4009;
                                        }
                                        let _e4050 = phi_2188_;
                                        if (_e4030 < 0f) {
                                            phi_2194_ = -(_e4030);
                                        } else {
                                            phi_2194_ = _e4030;
                                        }
                                        let _e4054 = phi_2194_;
                                        if (_e4014 < 0f) {
                                            phi_2203_ = -(_e4014);
                                        } else {
                                            phi_2203_ = _e4014;
                                        }
                                        let _e4061 = phi_2203_;
                                        if (_e4035 < 0f) {
                                            phi_2209_ = -(_e4035);
                                        } else {
                                            phi_2209_ = _e4035;
                                        }
                                        let _e4065 = phi_2209_;
                                        if (_e4019 < 0f) {
                                            phi_2218_ = -(_e4019);
                                        } else {
                                            phi_2218_ = _e4019;
                                        }
                                        let _e4072 = phi_2218_;
                                        if (_e4040 < 0f) {
                                            phi_2224_ = -(_e4040);
                                        } else {
                                            phi_2224_ = _e4040;
                                        }
                                        let _e4076 = phi_2224_;
                                        if (_e4024 < 0f) {
                                            phi_2233_ = -(_e4024);
                                        } else {
                                            phi_2233_ = _e4024;
                                        }
                                        let _e4083 = phi_2233_;
                                        if (_e4045 < 0f) {
                                            phi_2239_ = -(_e4045);
                                        } else {
                                            phi_2239_ = _e4045;
                                        }
                                        let _e4087 = phi_2239_;
                                        phi_2245_ = type_31(array<f32, 4>(_e4009, _e4014, _e4019, _e4024), array<f32, 4>(_e4030, _e4035, _e4040, _e4045), array<f32, 4>((_e4004 + ((_e4050 + _e4054) * _e3999)), (_e4004 + ((_e4061 + _e4065) * _e3999)), (_e4004 + ((_e4072 + _e4076) * _e3999)), (_e4004 + ((_e4083 + _e4087) * _e3999))));
                                        phi_2246_ = false;
                                    } else {
                                        phi_2245_ = type_31();
                                        phi_2246_ = true;
                                    }
                                    let _e4094 = phi_2245_;
                                    let _e4096 = phi_2246_;
                                    phi_2247_ = _e4094;
                                    phi_2248_ = _e4096;
                                } else {
                                    phi_2247_ = type_31();
                                    phi_2248_ = true;
                                }
                                let _e4098 = phi_2247_;
                                let _e4100 = phi_2248_;
                                if _e4100 {
                                    phi_2256_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2256_ = _e4098;
                                }
                                let _e4102 = phi_2256_;
                                local_10 = type_31(array<f32, 4>(_e4102.member[0], _e4102.member[1], _e4102.member[2], _e4102.member[3]), array<f32, 4>(_e4102.member_1[0], _e4102.member_1[1], _e4102.member_1[2], _e4102.member_1[3]), array<f32, 4>(_e4102.member_2[0], _e4102.member_2[1], _e4102.member_2[2], _e4102.member_2[3]));
                                let _e4122 = (_e3800 - _e3806);
                                let _e4126 = local_10.member[0u];
                                let _e4129 = local_10.member_1[0u];
                                let _e4132 = local_10.member[0u];
                                let _e4138 = local_10.member_2[0u];
                                if (((_e4126 + ((_e4129 - _e4132) * _e3800)) - _e4138) > 0f) {
                                    let _e4143 = local_10.member[1u];
                                    let _e4146 = local_10.member_1[1u];
                                    let _e4149 = local_10.member[1u];
                                    let _e4155 = local_10.member_2[1u];
                                    if (((_e4143 + ((_e4146 - _e4149) * _e3800)) - _e4155) > 0f) {
                                        let _e4160 = local_10.member[2u];
                                        let _e4163 = local_10.member_1[2u];
                                        let _e4166 = local_10.member[2u];
                                        let _e4172 = local_10.member_2[2u];
                                        if (((_e4160 + ((_e4163 - _e4166) * _e3800)) - _e4172) > 0f) {
                                            let _e4177 = local_10.member[3u];
                                            let _e4180 = local_10.member_1[3u];
                                            let _e4183 = local_10.member[3u];
                                            let _e4189 = local_10.member_2[3u];
                                            phi_2427_ = (((_e4177 + ((_e4180 - _e4183) * _e3800)) - _e4189) > 0f);
                                            phi_2428_ = false;
                                        } else {
                                            phi_2427_ = bool();
                                            phi_2428_ = true;
                                        }
                                        let _e4193 = phi_2427_;
                                        let _e4195 = phi_2428_;
                                        phi_2429_ = _e4193;
                                        phi_2430_ = _e4195;
                                    } else {
                                        phi_2429_ = bool();
                                        phi_2430_ = true;
                                    }
                                    let _e4197 = phi_2429_;
                                    let _e4199 = phi_2430_;
                                    phi_2431_ = _e4197;
                                    phi_2432_ = _e4199;
                                } else {
                                    phi_2431_ = bool();
                                    phi_2432_ = true;
                                }
                                let _e4201 = phi_2431_;
                                let _e4203 = phi_2432_;
                                if _e4203 {
                                    phi_2436_ = false;
                                } else {
                                    phi_2436_ = _e4201;
                                }
                                let _e4205 = phi_2436_;
                                if _e4205 {
                                    if (_e3800 <= _e3802) {
                                        phi_2746_ = true;
                                    } else {
                                        let _e4209 = local_9.member[0u];
                                        let _e4212 = local_9.member_1[0u];
                                        let _e4215 = local_9.member[0u];
                                        let _e4221 = local_9.member_2[0u];
                                        let _e4225 = local_10.member[0u];
                                        let _e4228 = local_10.member_1[0u];
                                        let _e4231 = local_10.member[0u];
                                        let _e4237 = local_10.member_2[0u];
                                        if ((((_e4209 + ((_e4212 - _e4215) * _e3800)) - _e4221) + ((_e4225 + ((_e4228 - _e4231) * _e3806)) - _e4237)) > 0f) {
                                            let _e4243 = local_9.member[1u];
                                            let _e4246 = local_9.member_1[1u];
                                            let _e4249 = local_9.member[1u];
                                            let _e4255 = local_9.member_2[1u];
                                            let _e4259 = local_10.member[1u];
                                            let _e4262 = local_10.member_1[1u];
                                            let _e4265 = local_10.member[1u];
                                            let _e4271 = local_10.member_2[1u];
                                            if ((((_e4243 + ((_e4246 - _e4249) * _e3800)) - _e4255) + ((_e4259 + ((_e4262 - _e4265) * _e3806)) - _e4271)) > 0f) {
                                                let _e4277 = local_9.member[2u];
                                                let _e4280 = local_9.member_1[2u];
                                                let _e4283 = local_9.member[2u];
                                                let _e4289 = local_9.member_2[2u];
                                                let _e4293 = local_10.member[2u];
                                                let _e4296 = local_10.member_1[2u];
                                                let _e4299 = local_10.member[2u];
                                                let _e4305 = local_10.member_2[2u];
                                                if ((((_e4277 + ((_e4280 - _e4283) * _e3800)) - _e4289) + ((_e4293 + ((_e4296 - _e4299) * _e3806)) - _e4305)) > 0f) {
                                                    let _e4311 = local_9.member[3u];
                                                    let _e4314 = local_9.member_1[3u];
                                                    let _e4317 = local_9.member[3u];
                                                    let _e4323 = local_9.member_2[3u];
                                                    let _e4327 = local_10.member[3u];
                                                    let _e4330 = local_10.member_1[3u];
                                                    let _e4333 = local_10.member[3u];
                                                    let _e4339 = local_10.member_2[3u];
                                                    phi_2733_ = ((((_e4311 + ((_e4314 - _e4317) * _e3800)) - _e4323) + ((_e4327 + ((_e4330 - _e4333) * _e3806)) - _e4339)) > 0f);
                                                    phi_2734_ = false;
                                                } else {
                                                    phi_2733_ = bool();
                                                    phi_2734_ = true;
                                                }
                                                let _e4344 = phi_2733_;
                                                let _e4346 = phi_2734_;
                                                phi_2735_ = _e4344;
                                                phi_2736_ = _e4346;
                                            } else {
                                                phi_2735_ = bool();
                                                phi_2736_ = true;
                                            }
                                            let _e4348 = phi_2735_;
                                            let _e4350 = phi_2736_;
                                            phi_2737_ = _e4348;
                                            phi_2738_ = _e4350;
                                        } else {
                                            phi_2737_ = bool();
                                            phi_2738_ = true;
                                        }
                                        let _e4352 = phi_2737_;
                                        let _e4354 = phi_2738_;
                                        if _e4354 {
                                            phi_2742_ = false;
                                        } else {
                                            phi_2742_ = _e4352;
                                        }
                                        let _e4356 = phi_2742_;
                                        phi_2746_ = _e4356;
                                    }
                                    let _e4358 = phi_2746_;
                                    if _e4358 {
                                        if _e3808 {
                                            if (_e3800 >= 1f) {
                                                phi_2757_ = false;
                                            } else {
                                                phi_2757_ = true;
                                            }
                                            let _e4361 = phi_2757_;
                                            phi_2758_ = _e4361;
                                        } else {
                                            phi_2758_ = true;
                                        }
                                        let _e4363 = phi_2758_;
                                        if _e4363 {
                                            local_9 = type_31(array<f32, 4>(_e4102.member[0], _e4102.member[1], _e4102.member[2], _e4102.member[3]), array<f32, 4>(_e4102.member_1[0], _e4102.member_1[1], _e4102.member_1[2], _e4102.member_1[3]), array<f32, 4>(_e4102.member_2[0], _e4102.member_2[1], _e4102.member_2[2], _e4102.member_2[3]));
                                            let _e4385 = local_9.member[0u];
                                            let _e4388 = local_9.member_1[0u];
                                            let _e4391 = local_9.member_2[0u];
                                            if (_e4385 > _e4391) {
                                                if (_e4388 > _e4391) {
                                                    phi_2832_ = false;
                                                } else {
                                                    phi_2832_ = true;
                                                }
                                                let _e4395 = phi_2832_;
                                                phi_2833_ = _e4395;
                                            } else {
                                                phi_2833_ = true;
                                            }
                                            let _e4397 = phi_2833_;
                                            if _e4397 {
                                                let _e4398 = (_e4388 >= _e4385);
                                                if _e4398 {
                                                    phi_2855_ = f32();
                                                    phi_2856_ = false;
                                                } else {
                                                    if ((_e4385 - _e4388) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2853_ = (((_e4385 - _e4391) / (_e4385 - _e4388)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2854_ = false;
                                                    } else {
                                                        phi_2853_ = f32();
                                                        phi_2854_ = true;
                                                    }
                                                    let _e4409 = phi_2853_;
                                                    let _e4411 = phi_2854_;
                                                    phi_2855_ = _e4409;
                                                    phi_2856_ = _e4411;
                                                }
                                                let _e4413 = phi_2855_;
                                                let _e4415 = phi_2856_;
                                                phi_2857_ = _e4413;
                                                phi_2858_ = _e4398;
                                                phi_2859_ = _e4415;
                                            } else {
                                                phi_2857_ = f32();
                                                phi_2858_ = true;
                                                phi_2859_ = false;
                                            }
                                            let _e4417 = phi_2857_;
                                            let _e4419 = phi_2858_;
                                            let _e4421 = phi_2859_;
                                            if _e4419 {
                                                phi_2863_ = 2f;
                                                phi_2864_ = true;
                                            } else {
                                                phi_2863_ = _e3800;
                                                phi_2864_ = _e4421;
                                            }
                                            let _e4423 = phi_2863_;
                                            let _e4425 = phi_2864_;
                                            if _e4425 {
                                                phi_2868_ = _e4423;
                                            } else {
                                                phi_2868_ = _e4417;
                                            }
                                            let _e4427 = phi_2868_;
                                            let _e4430 = local_9.member[1u];
                                            let _e4433 = local_9.member_1[1u];
                                            let _e4436 = local_9.member_2[1u];
                                            if (_e4430 > _e4436) {
                                                if (_e4433 > _e4436) {
                                                    phi_2900_ = false;
                                                } else {
                                                    phi_2900_ = true;
                                                }
                                                let _e4440 = phi_2900_;
                                                phi_2901_ = _e4440;
                                            } else {
                                                phi_2901_ = true;
                                            }
                                            let _e4442 = phi_2901_;
                                            if _e4442 {
                                                let _e4443 = (_e4433 >= _e4430);
                                                if _e4443 {
                                                    phi_2923_ = f32();
                                                    phi_2924_ = false;
                                                } else {
                                                    if ((_e4430 - _e4433) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2921_ = (((_e4430 - _e4436) / (_e4430 - _e4433)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2922_ = false;
                                                    } else {
                                                        phi_2921_ = f32();
                                                        phi_2922_ = true;
                                                    }
                                                    let _e4454 = phi_2921_;
                                                    let _e4456 = phi_2922_;
                                                    phi_2923_ = _e4454;
                                                    phi_2924_ = _e4456;
                                                }
                                                let _e4458 = phi_2923_;
                                                let _e4460 = phi_2924_;
                                                phi_2925_ = _e4458;
                                                phi_2926_ = _e4443;
                                                phi_2927_ = _e4460;
                                            } else {
                                                phi_2925_ = f32();
                                                phi_2926_ = true;
                                                phi_2927_ = false;
                                            }
                                            let _e4462 = phi_2925_;
                                            let _e4464 = phi_2926_;
                                            let _e4466 = phi_2927_;
                                            if _e4464 {
                                                phi_2931_ = 2f;
                                                phi_2932_ = true;
                                            } else {
                                                phi_2931_ = _e3800;
                                                phi_2932_ = _e4466;
                                            }
                                            let _e4468 = phi_2931_;
                                            let _e4470 = phi_2932_;
                                            if _e4470 {
                                                phi_2936_ = _e4468;
                                            } else {
                                                phi_2936_ = _e4462;
                                            }
                                            let _e4472 = phi_2936_;
                                            if (_e4427 < _e4472) {
                                                phi_2941_ = _e4427;
                                            } else {
                                                phi_2941_ = _e4472;
                                            }
                                            let _e4475 = phi_2941_;
                                            let _e4478 = local_9.member[2u];
                                            let _e4481 = local_9.member_1[2u];
                                            let _e4484 = local_9.member_2[2u];
                                            if (_e4478 > _e4484) {
                                                if (_e4481 > _e4484) {
                                                    phi_2973_ = false;
                                                } else {
                                                    phi_2973_ = true;
                                                }
                                                let _e4488 = phi_2973_;
                                                phi_2974_ = _e4488;
                                            } else {
                                                phi_2974_ = true;
                                            }
                                            let _e4490 = phi_2974_;
                                            if _e4490 {
                                                let _e4491 = (_e4481 >= _e4478);
                                                if _e4491 {
                                                    phi_2996_ = f32();
                                                    phi_2997_ = false;
                                                } else {
                                                    if ((_e4478 - _e4481) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2994_ = (((_e4478 - _e4484) / (_e4478 - _e4481)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2995_ = false;
                                                    } else {
                                                        phi_2994_ = f32();
                                                        phi_2995_ = true;
                                                    }
                                                    let _e4502 = phi_2994_;
                                                    let _e4504 = phi_2995_;
                                                    phi_2996_ = _e4502;
                                                    phi_2997_ = _e4504;
                                                }
                                                let _e4506 = phi_2996_;
                                                let _e4508 = phi_2997_;
                                                phi_2998_ = _e4506;
                                                phi_2999_ = _e4491;
                                                phi_3000_ = _e4508;
                                            } else {
                                                phi_2998_ = f32();
                                                phi_2999_ = true;
                                                phi_3000_ = false;
                                            }
                                            let _e4510 = phi_2998_;
                                            let _e4512 = phi_2999_;
                                            let _e4514 = phi_3000_;
                                            if _e4512 {
                                                phi_3004_ = 2f;
                                                phi_3005_ = true;
                                            } else {
                                                phi_3004_ = _e3800;
                                                phi_3005_ = _e4514;
                                            }
                                            let _e4516 = phi_3004_;
                                            let _e4518 = phi_3005_;
                                            if _e4518 {
                                                phi_3009_ = _e4516;
                                            } else {
                                                phi_3009_ = _e4510;
                                            }
                                            let _e4520 = phi_3009_;
                                            let _e4523 = local_9.member[3u];
                                            let _e4526 = local_9.member_1[3u];
                                            let _e4529 = local_9.member_2[3u];
                                            if (_e4523 > _e4529) {
                                                if (_e4526 > _e4529) {
                                                    phi_3041_ = false;
                                                } else {
                                                    phi_3041_ = true;
                                                }
                                                let _e4533 = phi_3041_;
                                                phi_3042_ = _e4533;
                                            } else {
                                                phi_3042_ = true;
                                            }
                                            let _e4535 = phi_3042_;
                                            if _e4535 {
                                                let _e4536 = (_e4526 >= _e4523);
                                                if _e4536 {
                                                    phi_3064_ = f32();
                                                    phi_3065_ = false;
                                                } else {
                                                    if ((_e4523 - _e4526) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3062_ = (((_e4523 - _e4529) / (_e4523 - _e4526)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3063_ = false;
                                                    } else {
                                                        phi_3062_ = f32();
                                                        phi_3063_ = true;
                                                    }
                                                    let _e4547 = phi_3062_;
                                                    let _e4549 = phi_3063_;
                                                    phi_3064_ = _e4547;
                                                    phi_3065_ = _e4549;
                                                }
                                                let _e4551 = phi_3064_;
                                                let _e4553 = phi_3065_;
                                                phi_3066_ = _e4551;
                                                phi_3067_ = _e4536;
                                                phi_3068_ = _e4553;
                                            } else {
                                                phi_3066_ = f32();
                                                phi_3067_ = true;
                                                phi_3068_ = false;
                                            }
                                            let _e4555 = phi_3066_;
                                            let _e4557 = phi_3067_;
                                            let _e4559 = phi_3068_;
                                            if _e4557 {
                                                phi_3072_ = 2f;
                                                phi_3073_ = true;
                                            } else {
                                                phi_3072_ = _e3800;
                                                phi_3073_ = _e4559;
                                            }
                                            let _e4561 = phi_3072_;
                                            let _e4563 = phi_3073_;
                                            if _e4563 {
                                                phi_3077_ = _e4561;
                                            } else {
                                                phi_3077_ = _e4555;
                                            }
                                            let _e4565 = phi_3077_;
                                            if (_e4520 < _e4565) {
                                                phi_3082_ = _e4520;
                                            } else {
                                                phi_3082_ = _e4565;
                                            }
                                            let _e4568 = phi_3082_;
                                            if (_e4475 < _e4568) {
                                                phi_3087_ = _e4475;
                                            } else {
                                                phi_3087_ = _e4568;
                                            }
                                            let _e4571 = phi_3087_;
                                            if (_e4571 > _e3800) {
                                                phi_3092_ = _e4571;
                                            } else {
                                                phi_3092_ = _e3800;
                                            }
                                            let _e4574 = phi_3092_;
                                            let _e4575 = (_e4574 > 1f);
                                            if _e4575 {
                                                phi_3596_ = f32();
                                                phi_3597_ = f32();
                                                phi_3598_ = false;
                                                phi_3599_ = false;
                                            } else {
                                                let _e4576 = (_e4574 - _e3800);
                                                let _e4577 = (_e4576 <= 0.0000000037252903f);
                                                let _e4578 = (_e4574 + 0.00000001f);
                                                if (_e4578 < 1f) {
                                                    phi_3104_ = _e4578;
                                                } else {
                                                    phi_3104_ = 1f;
                                                }
                                                let _e4581 = phi_3104_;
                                                if _e4577 {
                                                    if (_e455.member_1 > 0f) {
                                                        let _e4585 = local_12.member[0u];
                                                        let _e4591 = local_12.member[1u];
                                                        let _e4607 = local_12.member_1[0u];
                                                        let _e4613 = local_12.member_1[1u];
                                                        let _e4629 = local_12.member_2[0u];
                                                        let _e4635 = local_12.member_2[1u];
                                                        let _e4649 = function_2(array<f32, 3>((_e4585[0] + ((_e4591[0] - _e4585[0]) * _e4581)), (_e4585[1] + ((_e4591[1] - _e4585[1]) * _e4581)), (_e4585[2] + ((_e4591[2] - _e4585[2]) * _e4581))), array<f32, 3>((_e4607[0] + ((_e4613[0] - _e4607[0]) * _e4581)), (_e4607[1] + ((_e4613[1] - _e4607[1]) * _e4581)), (_e4607[2] + ((_e4613[2] - _e4607[2]) * _e4581))), array<f32, 3>((_e4629[0] + ((_e4635[0] - _e4629[0]) * _e4581)), (_e4629[1] + ((_e4635[1] - _e4629[1]) * _e4581)), (_e4629[2] + ((_e4635[2] - _e4629[2]) * _e4581))), 1u);
                                                        let _e4660 = (((_e4649[0] * _e4649[0]) + (_e4649[1] * _e4649[1])) + (_e4649[2] * _e4649[2]));
                                                        if (_e4660 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e4660 > 0f) {
                                                                phi_3234_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_3234_ = 0f;
                                                            }
                                                            let _e4713 = phi_3234_;
                                                            phi_3298_ = _e4713;
                                                        } else {
                                                            phi_3241_ = type_14(0i, 5i);
                                                            phi_3244_ = bitcast<f32>(((bitcast<u32>(_e4660) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e4668 = phi_3241_;
                                                                let _e4670 = phi_3244_;
                                                                local_25 = _e4670;
                                                                if (_e4668.member < _e4668.member_1) {
                                                                    let _e4677 = (_e4668.member + 1i);
                                                                    if ((false == (_e4677 > _e4668.member)) != false) {
                                                                        phi_3265_ = true;
                                                                    } else {
                                                                        phi_3265_ = false;
                                                                    }
                                                                    let _e4682 = phi_3265_;
                                                                    if _e4682 {
                                                                        phi_3271_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_3271_ = type_15(1u, _e4677);
                                                                    }
                                                                    let _e4687 = phi_3271_;
                                                                    phi_3242_ = type_14(_e4687.member_1, _e4668.member_1);
                                                                    phi_3285_ = type_15(1u, _e4668.member);
                                                                } else {
                                                                    phi_3242_ = _e4668;
                                                                    phi_3285_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e4693 = phi_3242_;
                                                                let _e4695 = phi_3285_;
                                                                let _e4698 = (bitcast<i32>(_e4695.member) != 0i);
                                                                if _e4698 {
                                                                    phi_3245_ = (0.5f * (_e4670 + (_e4660 / _e4670)));
                                                                } else {
                                                                    phi_3245_ = f32();
                                                                }
                                                                let _e4703 = phi_3245_;
                                                                continue;
                                                                continuing {
                                                                    phi_3241_ = _e4693;
                                                                    phi_3244_ = _e4703;
                                                                    break if !(_e4698);
                                                                }
                                                            }
                                                            let _e4708 = local_25;
                                                            phi_3298_ = (_e4708 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e4715 = phi_3298_;
                                                        let _e4721 = local_12.member[0u];
                                                        if (_e4721[0] < 0f) {
                                                            phi_3314_ = -(_e4721[0]);
                                                        } else {
                                                            phi_3314_ = _e4721[0];
                                                        }
                                                        let _e4728 = phi_3314_;
                                                        if (_e4721[1] < 0f) {
                                                            phi_3321_ = -(_e4721[1]);
                                                        } else {
                                                            phi_3321_ = _e4721[1];
                                                        }
                                                        let _e4732 = phi_3321_;
                                                        if (_e4728 > _e4732) {
                                                            phi_3326_ = _e4728;
                                                        } else {
                                                            phi_3326_ = _e4732;
                                                        }
                                                        let _e4735 = phi_3326_;
                                                        if (_e4721[2] < 0f) {
                                                            phi_3333_ = -(_e4721[2]);
                                                        } else {
                                                            phi_3333_ = _e4721[2];
                                                        }
                                                        let _e4739 = phi_3333_;
                                                        if (_e4735 > _e4739) {
                                                            phi_3338_ = _e4735;
                                                        } else {
                                                            phi_3338_ = _e4739;
                                                        }
                                                        let _e4742 = phi_3338_;
                                                        let _e4745 = local_12.member[1u];
                                                        if (_e4745[0] < 0f) {
                                                            phi_3351_ = -(_e4745[0]);
                                                        } else {
                                                            phi_3351_ = _e4745[0];
                                                        }
                                                        let _e4752 = phi_3351_;
                                                        if (_e4745[1] < 0f) {
                                                            phi_3358_ = -(_e4745[1]);
                                                        } else {
                                                            phi_3358_ = _e4745[1];
                                                        }
                                                        let _e4756 = phi_3358_;
                                                        if (_e4752 > _e4756) {
                                                            phi_3363_ = _e4752;
                                                        } else {
                                                            phi_3363_ = _e4756;
                                                        }
                                                        let _e4759 = phi_3363_;
                                                        if (_e4745[2] < 0f) {
                                                            phi_3370_ = -(_e4745[2]);
                                                        } else {
                                                            phi_3370_ = _e4745[2];
                                                        }
                                                        let _e4763 = phi_3370_;
                                                        if (_e4759 > _e4763) {
                                                            phi_3375_ = _e4759;
                                                        } else {
                                                            phi_3375_ = _e4763;
                                                        }
                                                        let _e4766 = phi_3375_;
                                                        if (_e4742 > _e4766) {
                                                            phi_3380_ = _e4742;
                                                        } else {
                                                            phi_3380_ = _e4766;
                                                        }
                                                        let _e4769 = phi_3380_;
                                                        let _e4771 = local_12.member_3;
                                                        let _e4775 = local_12.member_1[0u];
                                                        if (_e4775[0] < 0f) {
                                                            phi_3397_ = -(_e4775[0]);
                                                        } else {
                                                            phi_3397_ = _e4775[0];
                                                        }
                                                        let _e4782 = phi_3397_;
                                                        if (_e4775[1] < 0f) {
                                                            phi_3404_ = -(_e4775[1]);
                                                        } else {
                                                            phi_3404_ = _e4775[1];
                                                        }
                                                        let _e4786 = phi_3404_;
                                                        if (_e4782 > _e4786) {
                                                            phi_3409_ = _e4782;
                                                        } else {
                                                            phi_3409_ = _e4786;
                                                        }
                                                        let _e4789 = phi_3409_;
                                                        if (_e4775[2] < 0f) {
                                                            phi_3416_ = -(_e4775[2]);
                                                        } else {
                                                            phi_3416_ = _e4775[2];
                                                        }
                                                        let _e4793 = phi_3416_;
                                                        if (_e4789 > _e4793) {
                                                            phi_3421_ = _e4789;
                                                        } else {
                                                            phi_3421_ = _e4793;
                                                        }
                                                        let _e4796 = phi_3421_;
                                                        let _e4799 = local_12.member_1[1u];
                                                        if (_e4799[0] < 0f) {
                                                            phi_3435_ = -(_e4799[0]);
                                                        } else {
                                                            phi_3435_ = _e4799[0];
                                                        }
                                                        let _e4806 = phi_3435_;
                                                        if (_e4799[1] < 0f) {
                                                            phi_3442_ = -(_e4799[1]);
                                                        } else {
                                                            phi_3442_ = _e4799[1];
                                                        }
                                                        let _e4810 = phi_3442_;
                                                        if (_e4806 > _e4810) {
                                                            phi_3447_ = _e4806;
                                                        } else {
                                                            phi_3447_ = _e4810;
                                                        }
                                                        let _e4813 = phi_3447_;
                                                        if (_e4799[2] < 0f) {
                                                            phi_3454_ = -(_e4799[2]);
                                                        } else {
                                                            phi_3454_ = _e4799[2];
                                                        }
                                                        let _e4817 = phi_3454_;
                                                        if (_e4813 > _e4817) {
                                                            phi_3459_ = _e4813;
                                                        } else {
                                                            phi_3459_ = _e4817;
                                                        }
                                                        let _e4820 = phi_3459_;
                                                        if (_e4796 > _e4820) {
                                                            phi_3464_ = _e4796;
                                                        } else {
                                                            phi_3464_ = _e4820;
                                                        }
                                                        let _e4823 = phi_3464_;
                                                        let _e4825 = local_12.member_3;
                                                        let _e4829 = local_12.member_2[0u];
                                                        if (_e4829[0] < 0f) {
                                                            phi_3481_ = -(_e4829[0]);
                                                        } else {
                                                            phi_3481_ = _e4829[0];
                                                        }
                                                        let _e4836 = phi_3481_;
                                                        if (_e4829[1] < 0f) {
                                                            phi_3488_ = -(_e4829[1]);
                                                        } else {
                                                            phi_3488_ = _e4829[1];
                                                        }
                                                        let _e4840 = phi_3488_;
                                                        if (_e4836 > _e4840) {
                                                            phi_3493_ = _e4836;
                                                        } else {
                                                            phi_3493_ = _e4840;
                                                        }
                                                        let _e4843 = phi_3493_;
                                                        if (_e4829[2] < 0f) {
                                                            phi_3500_ = -(_e4829[2]);
                                                        } else {
                                                            phi_3500_ = _e4829[2];
                                                        }
                                                        let _e4847 = phi_3500_;
                                                        if (_e4843 > _e4847) {
                                                            phi_3505_ = _e4843;
                                                        } else {
                                                            phi_3505_ = _e4847;
                                                        }
                                                        let _e4850 = phi_3505_;
                                                        let _e4853 = local_12.member_2[1u];
                                                        if (_e4853[0] < 0f) {
                                                            phi_3519_ = -(_e4853[0]);
                                                        } else {
                                                            phi_3519_ = _e4853[0];
                                                        }
                                                        let _e4860 = phi_3519_;
                                                        if (_e4853[1] < 0f) {
                                                            phi_3526_ = -(_e4853[1]);
                                                        } else {
                                                            phi_3526_ = _e4853[1];
                                                        }
                                                        let _e4864 = phi_3526_;
                                                        if (_e4860 > _e4864) {
                                                            phi_3531_ = _e4860;
                                                        } else {
                                                            phi_3531_ = _e4864;
                                                        }
                                                        let _e4867 = phi_3531_;
                                                        if (_e4853[2] < 0f) {
                                                            phi_3538_ = -(_e4853[2]);
                                                        } else {
                                                            phi_3538_ = _e4853[2];
                                                        }
                                                        let _e4871 = phi_3538_;
                                                        if (_e4867 > _e4871) {
                                                            phi_3543_ = _e4867;
                                                        } else {
                                                            phi_3543_ = _e4871;
                                                        }
                                                        let _e4874 = phi_3543_;
                                                        if (_e4850 > _e4874) {
                                                            phi_3548_ = _e4850;
                                                        } else {
                                                            phi_3548_ = _e4874;
                                                        }
                                                        let _e4877 = phi_3548_;
                                                        let _e4879 = local_12.member_3;
                                                        let _e4886 = local_12.member_3;
                                                        if (((_e4715 * (1f + (0.000000059604645f * 8f))) + (((((((_e4769 + _e4771) + (_e4823 + _e4825)) + (_e4877 + _e4879)) * (0.000000059604645f * 16f)) + (_e4886 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e455.member_1) {
                                                            phi_3568_ = false;
                                                        } else {
                                                            phi_3568_ = true;
                                                        }
                                                        let _e4895 = phi_3568_;
                                                        phi_3569_ = _e4895;
                                                    } else {
                                                        phi_3569_ = true;
                                                    }
                                                    let _e4897 = phi_3569_;
                                                    phi_3570_ = _e4897;
                                                } else {
                                                    phi_3570_ = true;
                                                }
                                                let _e4899 = phi_3570_;
                                                if _e4899 {
                                                    if _e3808 {
                                                        if _e4577 {
                                                            phi_3586_ = true;
                                                        } else {
                                                            if (_e4576 <= (_e3804 * 0.25f)) {
                                                                phi_3585_ = false;
                                                            } else {
                                                                phi_3585_ = true;
                                                            }
                                                            let _e4904 = phi_3585_;
                                                            phi_3586_ = _e4904;
                                                        }
                                                        let _e4906 = phi_3586_;
                                                        if _e4906 {
                                                            phi_3591_ = (_e4122 + _e4122);
                                                        } else {
                                                            phi_3591_ = 0f;
                                                        }
                                                        let _e4909 = phi_3591_;
                                                        phi_3593_ = _e4909;
                                                    } else {
                                                        phi_3593_ = (1f - _e3800);
                                                    }
                                                    let _e4911 = phi_3593_;
                                                    phi_3594_ = _e4911;
                                                    phi_3595_ = false;
                                                } else {
                                                    phi_3594_ = f32();
                                                    phi_3595_ = true;
                                                }
                                                let _e4913 = phi_3594_;
                                                let _e4915 = phi_3595_;
                                                phi_3596_ = _e4913;
                                                phi_3597_ = _e4576;
                                                phi_3598_ = _e4899;
                                                phi_3599_ = _e4915;
                                            }
                                            let _e4917 = phi_3596_;
                                            let _e4919 = phi_3597_;
                                            let _e4921 = phi_3598_;
                                            let _e4923 = phi_3599_;
                                            phi_3600_ = _e4574;
                                            phi_3601_ = _e4917;
                                            phi_3602_ = _e4919;
                                            phi_3603_ = _e4574;
                                            phi_3604_ = _e4921;
                                            phi_3605_ = _e4575;
                                            phi_3606_ = _e4923;
                                            phi_3607_ = false;
                                        } else {
                                            phi_3600_ = f32();
                                            phi_3601_ = f32();
                                            phi_3602_ = f32();
                                            phi_3603_ = f32();
                                            phi_3604_ = false;
                                            phi_3605_ = false;
                                            phi_3606_ = false;
                                            phi_3607_ = true;
                                        }
                                        let _e4925 = phi_3600_;
                                        let _e4927 = phi_3601_;
                                        let _e4929 = phi_3602_;
                                        let _e4931 = phi_3603_;
                                        let _e4933 = phi_3604_;
                                        let _e4935 = phi_3605_;
                                        let _e4937 = phi_3606_;
                                        let _e4939 = phi_3607_;
                                        phi_3608_ = _e4925;
                                        phi_3609_ = _e4927;
                                        phi_3610_ = _e4929;
                                        phi_3611_ = _e4931;
                                        phi_3612_ = false;
                                        phi_3613_ = _e4933;
                                        phi_3614_ = _e4935;
                                        phi_3615_ = _e4937;
                                        phi_3616_ = _e4939;
                                    } else {
                                        phi_3608_ = f32();
                                        phi_3609_ = f32();
                                        phi_3610_ = f32();
                                        phi_3611_ = f32();
                                        phi_3612_ = true;
                                        phi_3613_ = false;
                                        phi_3614_ = false;
                                        phi_3615_ = false;
                                        phi_3616_ = false;
                                    }
                                    let _e4941 = phi_3608_;
                                    let _e4943 = phi_3609_;
                                    let _e4945 = phi_3610_;
                                    let _e4947 = phi_3611_;
                                    let _e4949 = phi_3612_;
                                    let _e4951 = phi_3613_;
                                    let _e4953 = phi_3614_;
                                    let _e4955 = phi_3615_;
                                    let _e4957 = phi_3616_;
                                    phi_3617_ = _e4941;
                                    phi_3618_ = _e4943;
                                    phi_3619_ = _e4945;
                                    phi_3620_ = _e4947;
                                    phi_3621_ = _e4949;
                                    phi_3622_ = _e4951;
                                    phi_3623_ = _e4953;
                                    phi_3624_ = _e4955;
                                    phi_3625_ = _e4957;
                                } else {
                                    phi_3617_ = f32();
                                    phi_3618_ = f32();
                                    phi_3619_ = f32();
                                    phi_3620_ = f32();
                                    phi_3621_ = true;
                                    phi_3622_ = false;
                                    phi_3623_ = false;
                                    phi_3624_ = false;
                                    phi_3625_ = false;
                                }
                                let _e4959 = phi_3617_;
                                let _e4961 = phi_3618_;
                                let _e4963 = phi_3619_;
                                let _e4965 = phi_3620_;
                                let _e4967 = phi_3621_;
                                let _e4969 = phi_3622_;
                                let _e4971 = phi_3623_;
                                let _e4973 = phi_3624_;
                                let _e4975 = phi_3625_;
                                if _e4967 {
                                    if (_e3800 <= _e3802) {
                                        let _e5136 = (_e3810 + 1u);
                                        let _e5137 = (_e5136 > 3u);
                                        if _e5137 {
                                            phi_3638_ = false;
                                        } else {
                                            phi_3638_ = true;
                                        }
                                        let _e5139 = phi_3638_;
                                        phi_3960_ = _e5136;
                                        phi_3961_ = f32();
                                        phi_3962_ = false;
                                        phi_3963_ = _e5139;
                                        phi_3964_ = _e5137;
                                    } else {
                                        let _e4979 = local_9.member[0u];
                                        let _e4982 = local_9.member_1[0u];
                                        let _e4985 = local_9.member[0u];
                                        let _e4991 = local_9.member_2[0u];
                                        let _e4992 = ((_e4979 + ((_e4982 - _e4985) * _e3806)) - _e4991);
                                        let _e4995 = local_9.member[1u];
                                        let _e4998 = local_9.member_1[1u];
                                        let _e5001 = local_9.member[1u];
                                        let _e5007 = local_9.member_2[1u];
                                        let _e5008 = ((_e4995 + ((_e4998 - _e5001) * _e3806)) - _e5007);
                                        if (_e4992 < _e5008) {
                                            phi_3711_ = _e4992;
                                        } else {
                                            phi_3711_ = _e5008;
                                        }
                                        let _e5011 = phi_3711_;
                                        let _e5014 = local_9.member[2u];
                                        let _e5017 = local_9.member_1[2u];
                                        let _e5020 = local_9.member[2u];
                                        let _e5026 = local_9.member_2[2u];
                                        let _e5027 = ((_e5014 + ((_e5017 - _e5020) * _e3806)) - _e5026);
                                        let _e5030 = local_9.member[3u];
                                        let _e5033 = local_9.member_1[3u];
                                        let _e5036 = local_9.member[3u];
                                        let _e5042 = local_9.member_2[3u];
                                        let _e5043 = ((_e5030 + ((_e5033 - _e5036) * _e3806)) - _e5042);
                                        if (_e5027 < _e5043) {
                                            phi_3784_ = _e5027;
                                        } else {
                                            phi_3784_ = _e5043;
                                        }
                                        let _e5046 = phi_3784_;
                                        if (_e5011 < _e5046) {
                                            phi_3789_ = _e5011;
                                        } else {
                                            phi_3789_ = _e5046;
                                        }
                                        let _e5049 = phi_3789_;
                                        let _e5052 = local_10.member[0u];
                                        let _e5055 = local_10.member_1[0u];
                                        let _e5058 = local_10.member[0u];
                                        let _e5064 = local_10.member_2[0u];
                                        let _e5065 = ((_e5052 + ((_e5055 - _e5058) * _e3800)) - _e5064);
                                        let _e5068 = local_10.member[1u];
                                        let _e5071 = local_10.member_1[1u];
                                        let _e5074 = local_10.member[1u];
                                        let _e5080 = local_10.member_2[1u];
                                        let _e5081 = ((_e5068 + ((_e5071 - _e5074) * _e3800)) - _e5080);
                                        if (_e5065 < _e5081) {
                                            phi_3862_ = _e5065;
                                        } else {
                                            phi_3862_ = _e5081;
                                        }
                                        let _e5084 = phi_3862_;
                                        let _e5087 = local_10.member[2u];
                                        let _e5090 = local_10.member_1[2u];
                                        let _e5093 = local_10.member[2u];
                                        let _e5099 = local_10.member_2[2u];
                                        let _e5100 = ((_e5087 + ((_e5090 - _e5093) * _e3800)) - _e5099);
                                        let _e5103 = local_10.member[3u];
                                        let _e5106 = local_10.member_1[3u];
                                        let _e5109 = local_10.member[3u];
                                        let _e5115 = local_10.member_2[3u];
                                        let _e5116 = ((_e5103 + ((_e5106 - _e5109) * _e3800)) - _e5115);
                                        if (_e5100 < _e5116) {
                                            phi_3935_ = _e5100;
                                        } else {
                                            phi_3935_ = _e5116;
                                        }
                                        let _e5119 = phi_3935_;
                                        if (_e5084 < _e5119) {
                                            phi_3940_ = _e5084;
                                        } else {
                                            phi_3940_ = _e5119;
                                        }
                                        let _e5122 = phi_3940_;
                                        if (_e5122 > 0f) {
                                            phi_3958_ = 0.5f;
                                        } else {
                                            let _e5126 = (0.95f * (_e5049 / (_e5049 - _e5122)));
                                            if (_e5126 > 0.0625f) {
                                                if (_e5126 < 0.9f) {
                                                    phi_3956_ = _e5126;
                                                } else {
                                                    phi_3956_ = 0.9f;
                                                }
                                                let _e5130 = phi_3956_;
                                                phi_3957_ = _e5130;
                                            } else {
                                                phi_3957_ = 0.0625f;
                                            }
                                            let _e5132 = phi_3957_;
                                            phi_3958_ = _e5132;
                                        }
                                        let _e5134 = phi_3958_;
                                        phi_3960_ = u32();
                                        phi_3961_ = (_e4122 * _e5134);
                                        phi_3962_ = true;
                                        phi_3963_ = false;
                                        phi_3964_ = false;
                                    }
                                    let _e5141 = phi_3960_;
                                    let _e5143 = phi_3961_;
                                    let _e5145 = phi_3962_;
                                    let _e5147 = phi_3963_;
                                    let _e5149 = phi_3964_;
                                    phi_3965_ = _e5141;
                                    phi_3966_ = _e3802;
                                    phi_3967_ = _e5143;
                                    phi_3968_ = _e3804;
                                    phi_3969_ = _e3806;
                                    phi_3970_ = _e3808;
                                    phi_3971_ = _e3810;
                                    phi_3972_ = _e5145;
                                    phi_3973_ = _e5147;
                                    phi_3974_ = _e5149;
                                    phi_3975_ = false;
                                    phi_3976_ = false;
                                    phi_3977_ = false;
                                } else {
                                    phi_3965_ = u32();
                                    phi_3966_ = _e4959;
                                    phi_3967_ = _e4961;
                                    phi_3968_ = _e4963;
                                    phi_3969_ = _e3800;
                                    phi_3970_ = true;
                                    phi_3971_ = 0u;
                                    phi_3972_ = _e4969;
                                    phi_3973_ = false;
                                    phi_3974_ = false;
                                    phi_3975_ = _e4971;
                                    phi_3976_ = _e4973;
                                    phi_3977_ = _e4975;
                                }
                                let _e5151 = phi_3965_;
                                let _e5153 = phi_3966_;
                                let _e5155 = phi_3967_;
                                let _e5157 = phi_3968_;
                                let _e5159 = phi_3969_;
                                let _e5161 = phi_3970_;
                                let _e5163 = phi_3971_;
                                let _e5165 = phi_3972_;
                                let _e5167 = phi_3973_;
                                let _e5169 = phi_3974_;
                                let _e5171 = phi_3975_;
                                let _e5173 = phi_3976_;
                                let _e5175 = phi_3977_;
                                if _e5165 {
                                    let _e5176 = (_e5159 + _e5155);
                                    if (_e5176 > _e5153) {
                                        phi_3986_ = _e5176;
                                    } else {
                                        phi_3986_ = _e5153;
                                    }
                                    let _e5179 = phi_3986_;
                                    if (_e5179 < 1f) {
                                        phi_3991_ = _e5179;
                                    } else {
                                        phi_3991_ = 1f;
                                    }
                                    let _e5182 = phi_3991_;
                                    if !(_e3808) {
                                        phi_4000_ = true;
                                    } else {
                                        phi_4000_ = ((_e5182 - _e5159) > 0.0000000037252903f);
                                    }
                                    let _e5186 = phi_4000_;
                                    if _e5186 {
                                        phi_4004_ = false;
                                    } else {
                                        phi_4004_ = true;
                                    }
                                    let _e5188 = phi_4004_;
                                    phi_4005_ = _e5182;
                                    phi_4006_ = _e5153;
                                    phi_4007_ = _e5157;
                                    phi_4008_ = _e5159;
                                    phi_4009_ = _e5161;
                                    phi_4010_ = _e5163;
                                    phi_4011_ = _e5186;
                                    phi_4012_ = _e5188;
                                    phi_4013_ = false;
                                    phi_4014_ = false;
                                    phi_4015_ = false;
                                    phi_4016_ = false;
                                } else {
                                    phi_4005_ = _e3800;
                                    phi_4006_ = _e3802;
                                    phi_4007_ = _e3804;
                                    phi_4008_ = _e3806;
                                    phi_4009_ = _e3808;
                                    phi_4010_ = _e5151;
                                    phi_4011_ = _e5167;
                                    phi_4012_ = false;
                                    phi_4013_ = _e5169;
                                    phi_4014_ = _e5171;
                                    phi_4015_ = _e5173;
                                    phi_4016_ = _e5175;
                                }
                                let _e5190 = phi_4005_;
                                let _e5192 = phi_4006_;
                                let _e5194 = phi_4007_;
                                let _e5196 = phi_4008_;
                                let _e5198 = phi_4009_;
                                let _e5200 = phi_4010_;
                                let _e5202 = phi_4011_;
                                let _e5204 = phi_4012_;
                                let _e5206 = phi_4013_;
                                let _e5208 = phi_4014_;
                                let _e5210 = phi_4015_;
                                let _e5212 = phi_4016_;
                                phi_1839_ = _e5190;
                                phi_1841_ = _e5192;
                                phi_1843_ = _e5194;
                                phi_1845_ = _e5196;
                                phi_1847_ = _e5198;
                                phi_1849_ = _e5200;
                                phi_4017_ = _e5153;
                                phi_4018_ = _e4965;
                                phi_4019_ = _e5202;
                                phi_4020_ = _e5204;
                                phi_4021_ = _e5206;
                                phi_4022_ = _e5208;
                                phi_4023_ = _e5210;
                                phi_4024_ = false;
                                phi_4025_ = _e5212;
                            } else {
                                phi_1839_ = f32();
                                phi_1841_ = f32();
                                phi_1843_ = f32();
                                phi_1845_ = f32();
                                phi_1847_ = bool();
                                phi_1849_ = u32();
                                phi_4017_ = f32();
                                phi_4018_ = f32();
                                phi_4019_ = false;
                                phi_4020_ = false;
                                phi_4021_ = false;
                                phi_4022_ = false;
                                phi_4023_ = false;
                                phi_4024_ = true;
                                phi_4025_ = false;
                            }
                            let _e5214 = phi_1839_;
                            let _e5216 = phi_1841_;
                            let _e5218 = phi_1843_;
                            let _e5220 = phi_1845_;
                            let _e5222 = phi_1847_;
                            let _e5224 = phi_1849_;
                            let _e5226 = phi_4017_;
                            let _e5228 = phi_4018_;
                            let _e5230 = phi_4019_;
                            let _e5232 = phi_4020_;
                            let _e5234 = phi_4021_;
                            let _e5236 = phi_4022_;
                            let _e5238 = phi_4023_;
                            let _e5240 = phi_4024_;
                            let _e5242 = phi_4025_;
                            local_26 = _e5232;
                            local_45 = _e5234;
                            local_46 = _e5236;
                            local_47 = _e5238;
                            local_48 = _e5240;
                            local_49 = _e5242;
                            local_50 = _e5232;
                            local_51 = _e5228;
                            local_52 = _e5226;
                            continue;
                            continuing {
                                phi_1835_ = _e3822;
                                phi_1838_ = _e5214;
                                phi_1840_ = _e5216;
                                phi_1842_ = _e5218;
                                phi_1844_ = _e5220;
                                phi_1846_ = _e5222;
                                phi_1848_ = _e5224;
                                break if !(_e5230);
                            }
                        }
                        let _e5245 = local_26;
                        if _e5245 {
                            phi_4029_ = false;
                            phi_4030_ = false;
                            phi_4031_ = false;
                            phi_4032_ = false;
                            phi_4033_ = false;
                        } else {
                            let _e6715 = local_45;
                            phi_4029_ = _e6715;
                            let _e6718 = local_46;
                            phi_4030_ = _e6718;
                            let _e6721 = local_47;
                            phi_4031_ = _e6721;
                            let _e6724 = local_48;
                            phi_4032_ = _e6724;
                            let _e6727 = local_49;
                            phi_4033_ = _e6727;
                        }
                        let _e5247 = phi_4029_;
                        let _e5249 = phi_4030_;
                        let _e5251 = phi_4031_;
                        let _e5253 = phi_4032_;
                        let _e5255 = phi_4033_;
                        if _e5247 {
                            let _e5257 = local_27;
                            phi_4038_ = type_30(1u, _e5257);
                            phi_4039_ = false;
                            phi_4040_ = false;
                            phi_4041_ = false;
                            phi_4042_ = false;
                            phi_4043_ = false;
                        } else {
                            phi_4038_ = type_30();
                            phi_4039_ = _e5249;
                            phi_4040_ = _e5251;
                            let _e6734 = local_50;
                            phi_4041_ = _e6734;
                            phi_4042_ = _e5253;
                            phi_4043_ = _e5255;
                        }
                        let _e5260 = phi_4038_;
                        let _e5262 = phi_4039_;
                        let _e5264 = phi_4040_;
                        let _e5266 = phi_4041_;
                        let _e5268 = phi_4042_;
                        let _e5270 = phi_4043_;
                        if _e5262 {
                            phi_4048_ = type_30(0u, type_30().member_1);
                            phi_4049_ = false;
                            phi_4050_ = false;
                            phi_4051_ = false;
                            phi_4052_ = false;
                            phi_4053_ = true;
                        } else {
                            phi_4048_ = _e5260;
                            phi_4049_ = _e5264;
                            phi_4050_ = _e5266;
                            phi_4051_ = _e5268;
                            phi_4052_ = _e5270;
                            phi_4053_ = _e5247;
                        }
                        let _e5274 = phi_4048_;
                        let _e5276 = phi_4049_;
                        let _e5278 = phi_4050_;
                        let _e5280 = phi_4051_;
                        let _e5282 = phi_4052_;
                        let _e5284 = phi_4053_;
                        if _e5276 {
                            let _e6745 = local_51;
                            phi_4057_ = _e6745;
                            phi_4058_ = true;
                            phi_4059_ = false;
                            phi_4060_ = false;
                            phi_4061_ = false;
                        } else {
                            let _e6747 = local_52;
                            phi_4057_ = _e6747;
                            phi_4058_ = _e5278;
                            phi_4059_ = _e5280;
                            phi_4060_ = _e5282;
                            phi_4061_ = _e5284;
                        }
                        let _e5286 = phi_4057_;
                        let _e5288 = phi_4058_;
                        let _e5290 = phi_4059_;
                        let _e5292 = phi_4060_;
                        let _e5294 = phi_4061_;
                        if _e5288 {
                            phi_4065_ = _e5286;
                            phi_4066_ = true;
                            phi_4067_ = false;
                            phi_4068_ = false;
                        } else {
                            let _e6754 = local_53;
                            phi_4065_ = _e6754;
                            phi_4066_ = _e5290;
                            phi_4067_ = _e5292;
                            phi_4068_ = _e5294;
                        }
                        let _e5296 = phi_4065_;
                        let _e5298 = phi_4066_;
                        let _e5300 = phi_4067_;
                        let _e5302 = phi_4068_;
                        if _e5298 {
                            phi_4073_ = type_30(1u, _e5296);
                            phi_4074_ = false;
                            phi_4075_ = false;
                        } else {
                            phi_4073_ = type_30();
                            phi_4074_ = _e5300;
                            phi_4075_ = _e5302;
                        }
                        let _e5305 = phi_4073_;
                        let _e5307 = phi_4074_;
                        let _e5309 = phi_4075_;
                        if _e5307 {
                            phi_4080_ = type_30(0u, type_30().member_1);
                            phi_4081_ = true;
                        } else {
                            phi_4080_ = _e5274;
                            phi_4081_ = _e5309;
                        }
                        let _e5313 = phi_4080_;
                        let _e5315 = phi_4081_;
                        if _e5315 {
                            phi_4085_ = _e5313;
                        } else {
                            phi_4085_ = _e5305;
                        }
                        let _e5317 = phi_4085_;
                        if (_e5317.member != 0u) {
                            local_11[0u] = 0.00000001f;
                            local_11[1u] = 0f;
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4098_ = type_12(0u, 3u);
                            loop {
                                let _e5328 = phi_4098_;
                                if (_e5328.member < _e5328.member_1) {
                                    phi_4099_ = type_12((_e5328.member + 1u), _e5328.member_1);
                                    phi_4122_ = type_12(1u, _e5328.member);
                                } else {
                                    phi_4099_ = _e5328;
                                    phi_4122_ = type_12(0u, type_12().member_1);
                                }
                                let _e5340 = phi_4099_;
                                let _e5342 = phi_4122_;
                                if (bitcast<i32>(_e5342.member) != 0i) {
                                    let _e5348 = local_11[_e5342.member_1];
                                    let _e5349 = (_e5317.member_1 + _e5348);
                                    if (_e5349 < 1f) {
                                        phi_4142_ = _e5349;
                                    } else {
                                        phi_4142_ = 1f;
                                    }
                                    let _e5352 = phi_4142_;
                                    let _e5355 = local_12.member[0u];
                                    let _e5361 = local_12.member[1u];
                                    let _e5377 = local_12.member_1[0u];
                                    let _e5383 = local_12.member_1[1u];
                                    let _e5399 = local_12.member_2[0u];
                                    let _e5405 = local_12.member_2[1u];
                                    let _e5419 = function_2(array<f32, 3>((_e5355[0] + ((_e5361[0] - _e5355[0]) * _e5352)), (_e5355[1] + ((_e5361[1] - _e5355[1]) * _e5352)), (_e5355[2] + ((_e5361[2] - _e5355[2]) * _e5352))), array<f32, 3>((_e5377[0] + ((_e5383[0] - _e5377[0]) * _e5352)), (_e5377[1] + ((_e5383[1] - _e5377[1]) * _e5352)), (_e5377[2] + ((_e5383[2] - _e5377[2]) * _e5352))), array<f32, 3>((_e5399[0] + ((_e5405[0] - _e5399[0]) * _e5352)), (_e5399[1] + ((_e5405[1] - _e5399[1]) * _e5352)), (_e5399[2] + ((_e5405[2] - _e5399[2]) * _e5352))), 1u);
                                    let _e5430 = (((_e5419[0] * _e5419[0]) + (_e5419[1] * _e5419[1])) + (_e5419[2] * _e5419[2]));
                                    if (_e5430 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e5430 > 0f) {
                                            phi_4265_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4265_ = 0f;
                                        }
                                        let _e5483 = phi_4265_;
                                        phi_4329_ = _e5483;
                                    } else {
                                        phi_4272_ = type_14(0i, 5i);
                                        phi_4275_ = bitcast<f32>(((bitcast<u32>(_e5430) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e5438 = phi_4272_;
                                            let _e5440 = phi_4275_;
                                            local_28 = _e5440;
                                            if (_e5438.member < _e5438.member_1) {
                                                let _e5447 = (_e5438.member + 1i);
                                                if ((false == (_e5447 > _e5438.member)) != false) {
                                                    phi_4296_ = true;
                                                } else {
                                                    phi_4296_ = false;
                                                }
                                                let _e5452 = phi_4296_;
                                                if _e5452 {
                                                    phi_4302_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_4302_ = type_15(1u, _e5447);
                                                }
                                                let _e5457 = phi_4302_;
                                                phi_4273_ = type_14(_e5457.member_1, _e5438.member_1);
                                                phi_4316_ = type_15(1u, _e5438.member);
                                            } else {
                                                phi_4273_ = _e5438;
                                                phi_4316_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5463 = phi_4273_;
                                            let _e5465 = phi_4316_;
                                            let _e5468 = (bitcast<i32>(_e5465.member) != 0i);
                                            if _e5468 {
                                                phi_4276_ = (0.5f * (_e5440 + (_e5430 / _e5440)));
                                            } else {
                                                phi_4276_ = f32();
                                            }
                                            let _e5473 = phi_4276_;
                                            continue;
                                            continuing {
                                                phi_4272_ = _e5463;
                                                phi_4275_ = _e5473;
                                                break if !(_e5468);
                                            }
                                        }
                                        let _e5478 = local_28;
                                        phi_4329_ = (_e5478 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5485 = phi_4329_;
                                    let _e5491 = local_12.member[0u];
                                    if (_e5491[0] < 0f) {
                                        phi_4345_ = -(_e5491[0]);
                                    } else {
                                        phi_4345_ = _e5491[0];
                                    }
                                    let _e5498 = phi_4345_;
                                    if (_e5491[1] < 0f) {
                                        phi_4352_ = -(_e5491[1]);
                                    } else {
                                        phi_4352_ = _e5491[1];
                                    }
                                    let _e5502 = phi_4352_;
                                    if (_e5498 > _e5502) {
                                        phi_4357_ = _e5498;
                                    } else {
                                        phi_4357_ = _e5502;
                                    }
                                    let _e5505 = phi_4357_;
                                    if (_e5491[2] < 0f) {
                                        phi_4364_ = -(_e5491[2]);
                                    } else {
                                        phi_4364_ = _e5491[2];
                                    }
                                    let _e5509 = phi_4364_;
                                    if (_e5505 > _e5509) {
                                        phi_4369_ = _e5505;
                                    } else {
                                        phi_4369_ = _e5509;
                                    }
                                    let _e5512 = phi_4369_;
                                    let _e5515 = local_12.member[1u];
                                    if (_e5515[0] < 0f) {
                                        phi_4382_ = -(_e5515[0]);
                                    } else {
                                        phi_4382_ = _e5515[0];
                                    }
                                    let _e5522 = phi_4382_;
                                    if (_e5515[1] < 0f) {
                                        phi_4389_ = -(_e5515[1]);
                                    } else {
                                        phi_4389_ = _e5515[1];
                                    }
                                    let _e5526 = phi_4389_;
                                    if (_e5522 > _e5526) {
                                        phi_4394_ = _e5522;
                                    } else {
                                        phi_4394_ = _e5526;
                                    }
                                    let _e5529 = phi_4394_;
                                    if (_e5515[2] < 0f) {
                                        phi_4401_ = -(_e5515[2]);
                                    } else {
                                        phi_4401_ = _e5515[2];
                                    }
                                    let _e5533 = phi_4401_;
                                    if (_e5529 > _e5533) {
                                        phi_4406_ = _e5529;
                                    } else {
                                        phi_4406_ = _e5533;
                                    }
                                    let _e5536 = phi_4406_;
                                    if (_e5512 > _e5536) {
                                        phi_4411_ = _e5512;
                                    } else {
                                        phi_4411_ = _e5536;
                                    }
                                    let _e5539 = phi_4411_;
                                    let _e5541 = local_12.member_3;
                                    let _e5545 = local_12.member_1[0u];
                                    if (_e5545[0] < 0f) {
                                        phi_4428_ = -(_e5545[0]);
                                    } else {
                                        phi_4428_ = _e5545[0];
                                    }
                                    let _e5552 = phi_4428_;
                                    if (_e5545[1] < 0f) {
                                        phi_4435_ = -(_e5545[1]);
                                    } else {
                                        phi_4435_ = _e5545[1];
                                    }
                                    let _e5556 = phi_4435_;
                                    if (_e5552 > _e5556) {
                                        phi_4440_ = _e5552;
                                    } else {
                                        phi_4440_ = _e5556;
                                    }
                                    let _e5559 = phi_4440_;
                                    if (_e5545[2] < 0f) {
                                        phi_4447_ = -(_e5545[2]);
                                    } else {
                                        phi_4447_ = _e5545[2];
                                    }
                                    let _e5563 = phi_4447_;
                                    if (_e5559 > _e5563) {
                                        phi_4452_ = _e5559;
                                    } else {
                                        phi_4452_ = _e5563;
                                    }
                                    let _e5566 = phi_4452_;
                                    let _e5569 = local_12.member_1[1u];
                                    if (_e5569[0] < 0f) {
                                        phi_4466_ = -(_e5569[0]);
                                    } else {
                                        phi_4466_ = _e5569[0];
                                    }
                                    let _e5576 = phi_4466_;
                                    if (_e5569[1] < 0f) {
                                        phi_4473_ = -(_e5569[1]);
                                    } else {
                                        phi_4473_ = _e5569[1];
                                    }
                                    let _e5580 = phi_4473_;
                                    if (_e5576 > _e5580) {
                                        phi_4478_ = _e5576;
                                    } else {
                                        phi_4478_ = _e5580;
                                    }
                                    let _e5583 = phi_4478_;
                                    if (_e5569[2] < 0f) {
                                        phi_4485_ = -(_e5569[2]);
                                    } else {
                                        phi_4485_ = _e5569[2];
                                    }
                                    let _e5587 = phi_4485_;
                                    if (_e5583 > _e5587) {
                                        phi_4490_ = _e5583;
                                    } else {
                                        phi_4490_ = _e5587;
                                    }
                                    let _e5590 = phi_4490_;
                                    if (_e5566 > _e5590) {
                                        phi_4495_ = _e5566;
                                    } else {
                                        phi_4495_ = _e5590;
                                    }
                                    let _e5593 = phi_4495_;
                                    let _e5595 = local_12.member_3;
                                    let _e5599 = local_12.member_2[0u];
                                    if (_e5599[0] < 0f) {
                                        phi_4512_ = -(_e5599[0]);
                                    } else {
                                        phi_4512_ = _e5599[0];
                                    }
                                    let _e5606 = phi_4512_;
                                    if (_e5599[1] < 0f) {
                                        phi_4519_ = -(_e5599[1]);
                                    } else {
                                        phi_4519_ = _e5599[1];
                                    }
                                    let _e5610 = phi_4519_;
                                    if (_e5606 > _e5610) {
                                        phi_4524_ = _e5606;
                                    } else {
                                        phi_4524_ = _e5610;
                                    }
                                    let _e5613 = phi_4524_;
                                    if (_e5599[2] < 0f) {
                                        phi_4531_ = -(_e5599[2]);
                                    } else {
                                        phi_4531_ = _e5599[2];
                                    }
                                    let _e5617 = phi_4531_;
                                    if (_e5613 > _e5617) {
                                        phi_4536_ = _e5613;
                                    } else {
                                        phi_4536_ = _e5617;
                                    }
                                    let _e5620 = phi_4536_;
                                    let _e5623 = local_12.member_2[1u];
                                    if (_e5623[0] < 0f) {
                                        phi_4550_ = -(_e5623[0]);
                                    } else {
                                        phi_4550_ = _e5623[0];
                                    }
                                    let _e5630 = phi_4550_;
                                    if (_e5623[1] < 0f) {
                                        phi_4557_ = -(_e5623[1]);
                                    } else {
                                        phi_4557_ = _e5623[1];
                                    }
                                    let _e5634 = phi_4557_;
                                    if (_e5630 > _e5634) {
                                        phi_4562_ = _e5630;
                                    } else {
                                        phi_4562_ = _e5634;
                                    }
                                    let _e5637 = phi_4562_;
                                    if (_e5623[2] < 0f) {
                                        phi_4569_ = -(_e5623[2]);
                                    } else {
                                        phi_4569_ = _e5623[2];
                                    }
                                    let _e5641 = phi_4569_;
                                    if (_e5637 > _e5641) {
                                        phi_4574_ = _e5637;
                                    } else {
                                        phi_4574_ = _e5641;
                                    }
                                    let _e5644 = phi_4574_;
                                    if (_e5620 > _e5644) {
                                        phi_4579_ = _e5620;
                                    } else {
                                        phi_4579_ = _e5644;
                                    }
                                    let _e5647 = phi_4579_;
                                    let _e5649 = local_12.member_3;
                                    let _e5656 = local_12.member_3;
                                    let _e5663 = (((_e5485 * (1f + (0.000000059604645f * 8f))) + (((((((_e5539 + _e5541) + (_e5593 + _e5595)) + (_e5647 + _e5649)) * (0.000000059604645f * 16f)) + (_e5656 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e455.member_1);
                                    if _e5663 {
                                        phi_4599_ = false;
                                    } else {
                                        phi_4599_ = true;
                                    }
                                    let _e5665 = phi_4599_;
                                    phi_4600_ = _e5665;
                                    phi_4601_ = _e5663;
                                } else {
                                    phi_4600_ = false;
                                    phi_4601_ = false;
                                }
                                let _e5667 = phi_4600_;
                                let _e5669 = phi_4601_;
                                local_29 = _e5669;
                                continue;
                                continuing {
                                    phi_4098_ = _e5340;
                                    break if !(_e5667);
                                }
                            }
                            let _e5672 = local_29;
                            if _e5672 {
                                phi_4606_ = type_30(1u, _e5317.member_1);
                                phi_4607_ = false;
                            } else {
                                phi_4606_ = type_30();
                                phi_4607_ = true;
                            }
                            let _e5675 = phi_4606_;
                            let _e5677 = phi_4607_;
                            if _e5677 {
                                phi_4612_ = type_30(2u, _e5317.member_1);
                                phi_4613_ = false;
                            } else {
                                phi_4612_ = type_30();
                                phi_4613_ = true;
                            }
                            let _e5680 = phi_4612_;
                            let _e5682 = phi_4613_;
                            phi_4615_ = _e5680;
                            phi_4616_ = _e5675;
                            phi_4617_ = _e5682;
                        } else {
                            phi_4615_ = type_30();
                            phi_4616_ = type_30(0u, type_30().member_1);
                            phi_4617_ = true;
                        }
                        let _e5684 = phi_4615_;
                        let _e5686 = phi_4616_;
                        let _e5688 = phi_4617_;
                        if _e5688 {
                            phi_4621_ = _e5686;
                        } else {
                            phi_4621_ = _e5684;
                        }
                        let _e5690 = phi_4621_;
                        phi_9090_ = _e5690;
                    } else {
                        if (_e593 < 0f) {
                            phi_4631_ = -(_e593);
                        } else {
                            phi_4631_ = _e593;
                        }
                        let _e936 = phi_4631_;
                        if (_e616 < 0f) {
                            phi_4637_ = -(_e616);
                        } else {
                            phi_4637_ = _e616;
                        }
                        let _e940 = phi_4637_;
                        if (_e936 > _e940) {
                            phi_4642_ = _e936;
                        } else {
                            phi_4642_ = _e940;
                        }
                        let _e943 = phi_4642_;
                        if (_e639 < 0f) {
                            phi_4648_ = -(_e639);
                        } else {
                            phi_4648_ = _e639;
                        }
                        let _e947 = phi_4648_;
                        if (_e650 < 0f) {
                            phi_4654_ = -(_e650);
                        } else {
                            phi_4654_ = _e650;
                        }
                        let _e951 = phi_4654_;
                        if (_e947 > _e951) {
                            phi_4659_ = _e947;
                        } else {
                            phi_4659_ = _e951;
                        }
                        let _e954 = phi_4659_;
                        if (_e943 > _e954) {
                            phi_4664_ = _e943;
                        } else {
                            phi_4664_ = _e954;
                        }
                        let _e957 = phi_4664_;
                        let _e958 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e957 >= _e958) {
                            phi_4672_ = (_e957 <= (1f / _e958));
                        } else {
                            phi_4672_ = false;
                        }
                        let _e963 = phi_4672_;
                        if _e963 {
                            phi_4677_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4677_ = 2f;
                        }
                        let _e966 = phi_4677_;
                        let _e968 = ((_e900 * 0.34f) + (_e957 * _e966));
                        if _e963 {
                            phi_4684_ = (1f / _e957);
                        } else {
                            phi_4684_ = 0f;
                        }
                        let _e971 = phi_4684_;
                        let _e977 = ((_e616 - (3f * _e593)) * _e971);
                        let _e978 = ((_e639 - _e616) * _e971);
                        let _e979 = (((3f * _e650) - _e639) * _e971);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e986 = ((_e978 * _e978) - (_e977 * _e979));
                        if (_e986 > 0f) {
                            if (_e986 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e986 > 0f) {
                                    phi_4717_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4717_ = 0f;
                                }
                                let _e1040 = phi_4717_;
                                phi_4781_ = _e1040;
                            } else {
                                phi_4724_ = type_14(0i, 5i);
                                phi_4727_ = bitcast<f32>(((bitcast<u32>(_e986) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e995 = phi_4724_;
                                    let _e997 = phi_4727_;
                                    local_13 = _e997;
                                    if (_e995.member < _e995.member_1) {
                                        let _e1004 = (_e995.member + 1i);
                                        if ((false == (_e1004 > _e995.member)) != false) {
                                            phi_4748_ = true;
                                        } else {
                                            phi_4748_ = false;
                                        }
                                        let _e1009 = phi_4748_;
                                        if _e1009 {
                                            phi_4754_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4754_ = type_15(1u, _e1004);
                                        }
                                        let _e1014 = phi_4754_;
                                        phi_4725_ = type_14(_e1014.member_1, _e995.member_1);
                                        phi_4768_ = type_15(1u, _e995.member);
                                    } else {
                                        phi_4725_ = _e995;
                                        phi_4768_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1020 = phi_4725_;
                                    let _e1022 = phi_4768_;
                                    let _e1025 = (bitcast<i32>(_e1022.member) != 0i);
                                    if _e1025 {
                                        phi_4728_ = (0.5f * (_e997 + (_e986 / _e997)));
                                    } else {
                                        phi_4728_ = f32();
                                    }
                                    let _e1030 = phi_4728_;
                                    continue;
                                    continuing {
                                        phi_4724_ = _e1020;
                                        phi_4727_ = _e1030;
                                        break if !(_e1025);
                                    }
                                }
                                let _e1035 = local_13;
                                phi_4781_ = (_e1035 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1042 = phi_4781_;
                            if (_e978 < 0f) {
                                phi_4787_ = -(_e1042);
                            } else {
                                phi_4787_ = _e1042;
                            }
                            let _e1046 = phi_4787_;
                            let _e1048 = -((_e978 + _e1046));
                            local_7[0u] = (_e1048 / (_e1048 + _e979));
                            local_7[1u] = (_e977 / (_e977 + _e1048));
                            let _e1057 = local_7[1u];
                            let _e1058 = local_7[0u];
                            if (_e1057 < _e1058) {
                                let _e1061 = local_7[1u];
                                let _e1063 = local_7[0u];
                                local_7[0u] = _e1061;
                                local_7[1u] = _e1063;
                            }
                            phi_4812_ = type_12(0u, 2u);
                            phi_4815_ = 1u;
                            loop {
                                let _e1067 = phi_4812_;
                                let _e1069 = phi_4815_;
                                local_30 = _e1069;
                                if (_e1067.member < _e1067.member_1) {
                                    phi_4813_ = type_12((_e1067.member + 1u), _e1067.member_1);
                                    phi_4838_ = type_12(1u, _e1067.member);
                                } else {
                                    phi_4813_ = _e1067;
                                    phi_4838_ = type_12(0u, type_12().member_1);
                                }
                                let _e1081 = phi_4813_;
                                let _e1083 = phi_4838_;
                                let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                if _e1087 {
                                    let _e1089 = local_7[_e1083.member_1];
                                    if (_e1089 > 0f) {
                                        let _e1092 = local_7[_e1083.member_1];
                                        if (_e1092 < 1f) {
                                            let _e1095 = local_7[_e1083.member_1];
                                            local_6[_e1069] = _e1095;
                                            phi_4882_ = (_e1069 + 1u);
                                        } else {
                                            phi_4882_ = _e1069;
                                        }
                                        let _e1099 = phi_4882_;
                                        phi_4883_ = _e1099;
                                    } else {
                                        phi_4883_ = _e1069;
                                    }
                                    let _e1101 = phi_4883_;
                                    phi_4816_ = _e1101;
                                } else {
                                    phi_4816_ = u32();
                                }
                                let _e1103 = phi_4816_;
                                continue;
                                continuing {
                                    phi_4812_ = _e1081;
                                    phi_4815_ = _e1103;
                                    break if !(_e1087);
                                }
                            }
                            let _e5950 = local_30;
                            phi_4884_ = _e5950;
                        } else {
                            phi_4884_ = 1u;
                        }
                        let _e1106 = phi_4884_;
                        local_6[_e1106] = 1f;
                        let _e1108 = local_6;
                        local_8 = _e1108;
                        phi_4904_ = type_12(0u, _e1106);
                        loop {
                            let _e1111 = phi_4904_;
                            if (_e1111.member < _e1111.member_1) {
                                phi_4905_ = type_12((_e1111.member + 1u), _e1111.member_1);
                                phi_4928_ = type_12(1u, _e1111.member);
                            } else {
                                phi_4905_ = _e1111;
                                phi_4928_ = type_12(0u, type_12().member_1);
                            }
                            let _e1123 = phi_4905_;
                            let _e1125 = phi_4928_;
                            if (bitcast<i32>(_e1125.member) != 0i) {
                                let _e1131 = local_8[_e1125.member_1];
                                let _e1134 = local_8[(_e1125.member_1 + 1u)];
                                let _e1135 = (1f - _e1131);
                                let _e1146 = ((((_e593 * _e1135) + (_e616 * _e1131)) * (_e1135 * _e1135)) + (((_e639 * _e1135) + (_e650 * _e1131)) * (_e1131 * _e1131)));
                                let _e1147 = (1f - _e1134);
                                let _e1158 = ((((_e593 * _e1147) + (_e616 * _e1134)) * (_e1147 * _e1147)) + (((_e639 * _e1147) + (_e650 * _e1134)) * (_e1134 * _e1134)));
                                if (_e1146 < 0f) {
                                    phi_4980_ = -(_e1146);
                                } else {
                                    phi_4980_ = _e1146;
                                }
                                let _e1162 = phi_4980_;
                                let _e1163 = (_e1162 > _e968);
                                if (_e1158 < 0f) {
                                    phi_4987_ = -(_e1158);
                                } else {
                                    phi_4987_ = _e1158;
                                }
                                let _e1167 = phi_4987_;
                                let _e1168 = (_e1167 > _e968);
                                if _e1163 {
                                    if _e1168 {
                                        phi_4998_ = ((_e1146 > 0f) != (_e1158 > 0f));
                                        phi_4999_ = false;
                                    } else {
                                        phi_4998_ = bool();
                                        phi_4999_ = true;
                                    }
                                    let _e1173 = phi_4998_;
                                    let _e1175 = phi_4999_;
                                    phi_5000_ = _e1173;
                                    phi_5001_ = _e1175;
                                } else {
                                    phi_5000_ = bool();
                                    phi_5001_ = true;
                                }
                                let _e1177 = phi_5000_;
                                let _e1179 = phi_5001_;
                                if _e1179 {
                                    phi_5005_ = false;
                                } else {
                                    phi_5005_ = _e1177;
                                }
                                let _e1181 = phi_5005_;
                                if _e1163 {
                                    if _e1168 {
                                        if _e1181 {
                                            phi_5016_ = type_37();
                                        } else {
                                            phi_5016_ = type_37(1f, 0f, _e1181);
                                        }
                                        let _e1184 = phi_5016_;
                                        phi_5017_ = _e1184;
                                        phi_5018_ = _e1181;
                                    } else {
                                        phi_5017_ = type_37();
                                        phi_5018_ = true;
                                    }
                                    let _e1186 = phi_5017_;
                                    let _e1188 = phi_5018_;
                                    phi_5019_ = _e1186;
                                    phi_5020_ = _e1188;
                                } else {
                                    phi_5019_ = type_37();
                                    phi_5020_ = true;
                                }
                                let _e1190 = phi_5019_;
                                let _e1192 = phi_5020_;
                                if _e1192 {
                                    if _e1163 {
                                        if (_e1146 < 0f) {
                                            phi_5031_ = -1f;
                                        } else {
                                            phi_5031_ = 1f;
                                        }
                                        let _e1195 = phi_5031_;
                                        let _e1198 = (_e639 - _e616);
                                        phi_5041_ = type_12(0u, 64u);
                                        phi_5044_ = _e1134;
                                        phi_5046_ = _e1131;
                                        phi_5048_ = (0.5f * (_e1131 + _e1134));
                                        loop {
                                            let _e1204 = phi_5041_;
                                            let _e1206 = phi_5044_;
                                            let _e1208 = phi_5046_;
                                            let _e1210 = phi_5048_;
                                            local_32 = _e1208;
                                            if (_e1204.member < _e1204.member_1) {
                                                phi_5042_ = type_12((_e1204.member + 1u), _e1204.member_1);
                                                phi_5071_ = type_12(1u, _e1204.member);
                                            } else {
                                                phi_5042_ = _e1204;
                                                phi_5071_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1222 = phi_5042_;
                                            let _e1224 = phi_5071_;
                                            if (bitcast<i32>(_e1224.member) != 0i) {
                                                let _e1228 = (1f - _e1210);
                                                let _e1241 = ((_e1195 * ((((_e593 * _e1228) + (_e616 * _e1210)) * (_e1228 * _e1228)) + (((_e639 * _e1228) + (_e650 * _e1210)) * (_e1210 * _e1210)))) - _e968);
                                                if (_e1241 > 0f) {
                                                    phi_5096_ = _e1206;
                                                    phi_5097_ = _e1210;
                                                } else {
                                                    phi_5096_ = _e1210;
                                                    phi_5097_ = _e1208;
                                                }
                                                let _e1244 = phi_5096_;
                                                let _e1246 = phi_5097_;
                                                let _e1248 = ((_e1244 - _e1246) > 0.00000000000022737368f);
                                                if _e1248 {
                                                    let _e1249 = (1f - _e1210);
                                                    let _e1261 = (-(_e1241) / (_e1195 * (((((_e616 - (3f * _e593)) * _e1249) + (_e1198 * _e1210)) * _e1249) + (((_e1198 * _e1249) + (((3f * _e650) - _e639) * _e1210)) * _e1210))));
                                                    if (_e1241 > 0f) {
                                                        phi_5123_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5123_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1267 = phi_5123_;
                                                    let _e1269 = ((_e1210 + _e1261) + _e1267);
                                                    if (_e1269 > _e1246) {
                                                        if (_e1269 < _e1244) {
                                                            if (_e1261 < 0f) {
                                                                phi_5139_ = -(_e1261);
                                                            } else {
                                                                phi_5139_ = _e1261;
                                                            }
                                                            let _e1275 = phi_5139_;
                                                            if (_e1275 < (0.5f * (_e1244 - _e1246))) {
                                                                phi_5146_ = false;
                                                            } else {
                                                                phi_5146_ = true;
                                                            }
                                                            let _e1280 = phi_5146_;
                                                            phi_5147_ = _e1280;
                                                        } else {
                                                            phi_5147_ = true;
                                                        }
                                                        let _e1282 = phi_5147_;
                                                        phi_5148_ = _e1282;
                                                    } else {
                                                        phi_5148_ = true;
                                                    }
                                                    let _e1284 = phi_5148_;
                                                    if _e1284 {
                                                        phi_5154_ = (0.5f * (_e1246 + _e1244));
                                                    } else {
                                                        phi_5154_ = _e1269;
                                                    }
                                                    let _e1288 = phi_5154_;
                                                    phi_5155_ = _e1288;
                                                    phi_5156_ = false;
                                                } else {
                                                    phi_5155_ = f32();
                                                    phi_5156_ = true;
                                                }
                                                let _e1290 = phi_5155_;
                                                let _e1292 = phi_5156_;
                                                phi_5045_ = _e1244;
                                                phi_5047_ = _e1246;
                                                phi_5049_ = _e1290;
                                                phi_5157_ = _e1246;
                                                phi_5158_ = _e1248;
                                                phi_5159_ = _e1292;
                                            } else {
                                                phi_5045_ = f32();
                                                phi_5047_ = f32();
                                                phi_5049_ = f32();
                                                phi_5157_ = f32();
                                                phi_5158_ = false;
                                                phi_5159_ = false;
                                            }
                                            let _e1294 = phi_5045_;
                                            let _e1296 = phi_5047_;
                                            let _e1298 = phi_5049_;
                                            let _e1300 = phi_5157_;
                                            let _e1302 = phi_5158_;
                                            let _e1304 = phi_5159_;
                                            local_14 = _e1304;
                                            local_31 = _e1300;
                                            continue;
                                            continuing {
                                                phi_5041_ = _e1222;
                                                phi_5044_ = _e1294;
                                                phi_5046_ = _e1296;
                                                phi_5048_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_14;
                                        if _e1307 {
                                            let _e5992 = local_31;
                                            phi_5163_ = _e5992;
                                        } else {
                                            let _e5994 = local_32;
                                            phi_5163_ = _e5994;
                                        }
                                        let _e1309 = phi_5163_;
                                        phi_5164_ = _e1309;
                                    } else {
                                        phi_5164_ = _e1131;
                                    }
                                    let _e1311 = phi_5164_;
                                    if _e1168 {
                                        if (_e1158 < 0f) {
                                            phi_5172_ = -1f;
                                        } else {
                                            phi_5172_ = 1f;
                                        }
                                        let _e1314 = phi_5172_;
                                        phi_5176_ = type_12(0u, 64u);
                                        phi_5179_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1317 = phi_5176_;
                                            let _e1319 = phi_5179_;
                                            if (_e1317.member < _e1317.member_1) {
                                                phi_5177_ = type_12((_e1317.member + 1u), _e1317.member_1);
                                                phi_5202_ = type_12(1u, _e1317.member);
                                            } else {
                                                phi_5177_ = _e1317;
                                                phi_5202_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1331 = phi_5177_;
                                            let _e1333 = phi_5202_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1319);
                                                if (_e1337 < _e1134) {
                                                    let _e1339 = (1f - _e1337);
                                                    let _e1352 = ((_e1314 * ((((_e593 * _e1339) + (_e616 * _e1337)) * (_e1339 * _e1339)) + (((_e639 * _e1339) + (_e650 * _e1337)) * (_e1337 * _e1337)))) > _e968);
                                                    if _e1352 {
                                                        phi_5232_ = f32();
                                                        phi_5233_ = false;
                                                    } else {
                                                        phi_5232_ = (_e1319 + _e1319);
                                                        phi_5233_ = true;
                                                    }
                                                    let _e1355 = phi_5232_;
                                                    let _e1357 = phi_5233_;
                                                    phi_5234_ = _e1355;
                                                    phi_5235_ = _e1357;
                                                    phi_5236_ = _e1352;
                                                    phi_5237_ = false;
                                                } else {
                                                    phi_5234_ = f32();
                                                    phi_5235_ = false;
                                                    phi_5236_ = false;
                                                    phi_5237_ = true;
                                                }
                                                let _e1359 = phi_5234_;
                                                let _e1361 = phi_5235_;
                                                let _e1363 = phi_5236_;
                                                let _e1365 = phi_5237_;
                                                phi_5238_ = _e1337;
                                                phi_5180_ = _e1359;
                                                phi_5239_ = _e1361;
                                                phi_5240_ = _e1363;
                                                phi_5241_ = _e1365;
                                                phi_5242_ = false;
                                            } else {
                                                phi_5238_ = f32();
                                                phi_5180_ = f32();
                                                phi_5239_ = false;
                                                phi_5240_ = false;
                                                phi_5241_ = false;
                                                phi_5242_ = true;
                                            }
                                            let _e1367 = phi_5238_;
                                            let _e1369 = phi_5180_;
                                            let _e1371 = phi_5239_;
                                            let _e1373 = phi_5240_;
                                            let _e1375 = phi_5241_;
                                            let _e1377 = phi_5242_;
                                            local_15 = _e1373;
                                            local_33 = _e1375;
                                            local_34 = _e1377;
                                            local_35 = _e1367;
                                            continue;
                                            continuing {
                                                phi_5176_ = _e1331;
                                                phi_5179_ = _e1369;
                                                break if !(_e1371);
                                            }
                                        }
                                        let _e1380 = local_15;
                                        if _e1380 {
                                            phi_5246_ = false;
                                            phi_5247_ = false;
                                        } else {
                                            let _e6016 = local_33;
                                            phi_5246_ = _e6016;
                                            let _e6019 = local_34;
                                            phi_5247_ = _e6019;
                                        }
                                        let _e1382 = phi_5246_;
                                        let _e1384 = phi_5247_;
                                        if _e1382 {
                                            phi_5251_ = true;
                                        } else {
                                            phi_5251_ = _e1384;
                                        }
                                        let _e1386 = phi_5251_;
                                        if _e1386 {
                                            phi_5255_ = _e1134;
                                        } else {
                                            let _e6023 = local_35;
                                            phi_5255_ = _e6023;
                                        }
                                        let _e1388 = phi_5255_;
                                        phi_5256_ = _e1388;
                                    } else {
                                        phi_5256_ = _e1134;
                                    }
                                    let _e1390 = phi_5256_;
                                    phi_5258_ = type_37(_e1311, _e1390, _e1181);
                                } else {
                                    phi_5258_ = _e1190;
                                }
                                let _e1393 = phi_5258_;
                                if (_e1393.member > _e1393.member_1) {
                                    phi_9046_ = f32();
                                    phi_9047_ = true;
                                    phi_9048_ = false;
                                    phi_9049_ = false;
                                    phi_9050_ = false;
                                } else {
                                    let _e1400 = ((_e1393.member_1 - _e1393.member) * 0.5f);
                                    let _e1401 = (_e1393.member + _e1400);
                                    let _e1403 = (_e1400 + (0.000000059604645f * 4f));
                                    let _e1405 = local_12.member_3;
                                    let _e1408 = local_12.member[0u];
                                    if (_e1408[0] < 0f) {
                                        phi_5287_ = -(_e1408[0]);
                                    } else {
                                        phi_5287_ = _e1408[0];
                                    }
                                    let _e1415 = phi_5287_;
                                    if (_e1408[1] < 0f) {
                                        phi_5294_ = -(_e1408[1]);
                                    } else {
                                        phi_5294_ = _e1408[1];
                                    }
                                    let _e1419 = phi_5294_;
                                    if (_e1415 > _e1419) {
                                        phi_5299_ = _e1415;
                                    } else {
                                        phi_5299_ = _e1419;
                                    }
                                    let _e1422 = phi_5299_;
                                    if (_e1408[2] < 0f) {
                                        phi_5306_ = -(_e1408[2]);
                                    } else {
                                        phi_5306_ = _e1408[2];
                                    }
                                    let _e1426 = phi_5306_;
                                    if (_e1422 > _e1426) {
                                        phi_5311_ = _e1422;
                                    } else {
                                        phi_5311_ = _e1426;
                                    }
                                    let _e1429 = phi_5311_;
                                    let _e1431 = local_12.member[1u];
                                    if (_e1431[0] < 0f) {
                                        phi_5324_ = -(_e1431[0]);
                                    } else {
                                        phi_5324_ = _e1431[0];
                                    }
                                    let _e1438 = phi_5324_;
                                    if (_e1431[1] < 0f) {
                                        phi_5331_ = -(_e1431[1]);
                                    } else {
                                        phi_5331_ = _e1431[1];
                                    }
                                    let _e1442 = phi_5331_;
                                    if (_e1438 > _e1442) {
                                        phi_5336_ = _e1438;
                                    } else {
                                        phi_5336_ = _e1442;
                                    }
                                    let _e1445 = phi_5336_;
                                    if (_e1431[2] < 0f) {
                                        phi_5343_ = -(_e1431[2]);
                                    } else {
                                        phi_5343_ = _e1431[2];
                                    }
                                    let _e1449 = phi_5343_;
                                    if (_e1445 > _e1449) {
                                        phi_5348_ = _e1445;
                                    } else {
                                        phi_5348_ = _e1449;
                                    }
                                    let _e1452 = phi_5348_;
                                    if (_e1429 > _e1452) {
                                        phi_5353_ = _e1429;
                                    } else {
                                        phi_5353_ = _e1452;
                                    }
                                    let _e1455 = phi_5353_;
                                    let _e1458 = local_12.member[0u];
                                    let _e1463 = local_12.member[1u];
                                    let _e1473 = (_e1458[0] + ((_e1463[0] - _e1458[0]) * _e1401));
                                    let _e1474 = (_e1458[1] + ((_e1463[1] - _e1458[1]) * _e1401));
                                    let _e1475 = (_e1458[2] + ((_e1463[2] - _e1458[2]) * _e1401));
                                    let _e1477 = local_12.member[1u];
                                    let _e1482 = local_12.member[0u];
                                    let _e1486 = (_e1477[0] - _e1482[0]);
                                    let _e1487 = (_e1477[1] - _e1482[1]);
                                    let _e1488 = (_e1477[2] - _e1482[2]);
                                    if (_e1486 < 0f) {
                                        phi_5412_ = -(_e1486);
                                    } else {
                                        phi_5412_ = _e1486;
                                    }
                                    let _e1492 = phi_5412_;
                                    if (_e1487 < 0f) {
                                        phi_5418_ = -(_e1487);
                                    } else {
                                        phi_5418_ = _e1487;
                                    }
                                    let _e1496 = phi_5418_;
                                    if (_e1492 > _e1496) {
                                        phi_5423_ = _e1492;
                                    } else {
                                        phi_5423_ = _e1496;
                                    }
                                    let _e1499 = phi_5423_;
                                    if (_e1488 < 0f) {
                                        phi_5429_ = -(_e1488);
                                    } else {
                                        phi_5429_ = _e1488;
                                    }
                                    let _e1503 = phi_5429_;
                                    if (_e1499 > _e1503) {
                                        phi_5434_ = _e1499;
                                    } else {
                                        phi_5434_ = _e1503;
                                    }
                                    let _e1506 = phi_5434_;
                                    let _e1512 = ((((_e1403 * _e1506) * 1.01f) + ((_e1455 + _e1405) * (0.000000059604645f * 8f))) + _e1405);
                                    if (_e1473 < 0f) {
                                        phi_5446_ = -(_e1473);
                                    } else {
                                        phi_5446_ = _e1473;
                                    }
                                    let _e1516 = phi_5446_;
                                    if (_e1474 < 0f) {
                                        phi_5452_ = -(_e1474);
                                    } else {
                                        phi_5452_ = _e1474;
                                    }
                                    let _e1520 = phi_5452_;
                                    if (_e1516 > _e1520) {
                                        phi_5457_ = _e1516;
                                    } else {
                                        phi_5457_ = _e1520;
                                    }
                                    let _e1523 = phi_5457_;
                                    if (_e1475 < 0f) {
                                        phi_5463_ = -(_e1475);
                                    } else {
                                        phi_5463_ = _e1475;
                                    }
                                    let _e1527 = phi_5463_;
                                    if (_e1523 > _e1527) {
                                        phi_5468_ = _e1523;
                                    } else {
                                        phi_5468_ = _e1527;
                                    }
                                    let _e1530 = phi_5468_;
                                    local_2 = type_26(array<f32, 3>(_e1473, _e1474, _e1475), _e1512, (_e1530 + _e1512));
                                    let _e1536 = local_12.member_3;
                                    let _e1538 = local_12.member_1[0u];
                                    if (_e1538[0] < 0f) {
                                        phi_5494_ = -(_e1538[0]);
                                    } else {
                                        phi_5494_ = _e1538[0];
                                    }
                                    let _e1545 = phi_5494_;
                                    if (_e1538[1] < 0f) {
                                        phi_5501_ = -(_e1538[1]);
                                    } else {
                                        phi_5501_ = _e1538[1];
                                    }
                                    let _e1549 = phi_5501_;
                                    if (_e1545 > _e1549) {
                                        phi_5506_ = _e1545;
                                    } else {
                                        phi_5506_ = _e1549;
                                    }
                                    let _e1552 = phi_5506_;
                                    if (_e1538[2] < 0f) {
                                        phi_5513_ = -(_e1538[2]);
                                    } else {
                                        phi_5513_ = _e1538[2];
                                    }
                                    let _e1556 = phi_5513_;
                                    if (_e1552 > _e1556) {
                                        phi_5518_ = _e1552;
                                    } else {
                                        phi_5518_ = _e1556;
                                    }
                                    let _e1559 = phi_5518_;
                                    let _e1561 = local_12.member_1[1u];
                                    if (_e1561[0] < 0f) {
                                        phi_5531_ = -(_e1561[0]);
                                    } else {
                                        phi_5531_ = _e1561[0];
                                    }
                                    let _e1568 = phi_5531_;
                                    if (_e1561[1] < 0f) {
                                        phi_5538_ = -(_e1561[1]);
                                    } else {
                                        phi_5538_ = _e1561[1];
                                    }
                                    let _e1572 = phi_5538_;
                                    if (_e1568 > _e1572) {
                                        phi_5543_ = _e1568;
                                    } else {
                                        phi_5543_ = _e1572;
                                    }
                                    let _e1575 = phi_5543_;
                                    if (_e1561[2] < 0f) {
                                        phi_5550_ = -(_e1561[2]);
                                    } else {
                                        phi_5550_ = _e1561[2];
                                    }
                                    let _e1579 = phi_5550_;
                                    if (_e1575 > _e1579) {
                                        phi_5555_ = _e1575;
                                    } else {
                                        phi_5555_ = _e1579;
                                    }
                                    let _e1582 = phi_5555_;
                                    if (_e1559 > _e1582) {
                                        phi_5560_ = _e1559;
                                    } else {
                                        phi_5560_ = _e1582;
                                    }
                                    let _e1585 = phi_5560_;
                                    let _e1588 = local_12.member_1[0u];
                                    let _e1593 = local_12.member_1[1u];
                                    let _e1603 = (_e1588[0] + ((_e1593[0] - _e1588[0]) * _e1401));
                                    let _e1604 = (_e1588[1] + ((_e1593[1] - _e1588[1]) * _e1401));
                                    let _e1605 = (_e1588[2] + ((_e1593[2] - _e1588[2]) * _e1401));
                                    let _e1607 = local_12.member_1[1u];
                                    let _e1612 = local_12.member_1[0u];
                                    let _e1616 = (_e1607[0] - _e1612[0]);
                                    let _e1617 = (_e1607[1] - _e1612[1]);
                                    let _e1618 = (_e1607[2] - _e1612[2]);
                                    if (_e1616 < 0f) {
                                        phi_5619_ = -(_e1616);
                                    } else {
                                        phi_5619_ = _e1616;
                                    }
                                    let _e1622 = phi_5619_;
                                    if (_e1617 < 0f) {
                                        phi_5625_ = -(_e1617);
                                    } else {
                                        phi_5625_ = _e1617;
                                    }
                                    let _e1626 = phi_5625_;
                                    if (_e1622 > _e1626) {
                                        phi_5630_ = _e1622;
                                    } else {
                                        phi_5630_ = _e1626;
                                    }
                                    let _e1629 = phi_5630_;
                                    if (_e1618 < 0f) {
                                        phi_5636_ = -(_e1618);
                                    } else {
                                        phi_5636_ = _e1618;
                                    }
                                    let _e1633 = phi_5636_;
                                    if (_e1629 > _e1633) {
                                        phi_5641_ = _e1629;
                                    } else {
                                        phi_5641_ = _e1633;
                                    }
                                    let _e1636 = phi_5641_;
                                    let _e1642 = ((((_e1403 * _e1636) * 1.01f) + ((_e1585 + _e1536) * (0.000000059604645f * 8f))) + _e1536);
                                    if (_e1603 < 0f) {
                                        phi_5653_ = -(_e1603);
                                    } else {
                                        phi_5653_ = _e1603;
                                    }
                                    let _e1646 = phi_5653_;
                                    if (_e1604 < 0f) {
                                        phi_5659_ = -(_e1604);
                                    } else {
                                        phi_5659_ = _e1604;
                                    }
                                    let _e1650 = phi_5659_;
                                    if (_e1646 > _e1650) {
                                        phi_5664_ = _e1646;
                                    } else {
                                        phi_5664_ = _e1650;
                                    }
                                    let _e1653 = phi_5664_;
                                    if (_e1605 < 0f) {
                                        phi_5670_ = -(_e1605);
                                    } else {
                                        phi_5670_ = _e1605;
                                    }
                                    let _e1657 = phi_5670_;
                                    if (_e1653 > _e1657) {
                                        phi_5675_ = _e1653;
                                    } else {
                                        phi_5675_ = _e1657;
                                    }
                                    let _e1660 = phi_5675_;
                                    local_3 = type_26(array<f32, 3>(_e1603, _e1604, _e1605), _e1642, (_e1660 + _e1642));
                                    let _e1666 = local_12.member_3;
                                    let _e1668 = local_12.member_2[0u];
                                    if (_e1668[0] < 0f) {
                                        phi_5701_ = -(_e1668[0]);
                                    } else {
                                        phi_5701_ = _e1668[0];
                                    }
                                    let _e1675 = phi_5701_;
                                    if (_e1668[1] < 0f) {
                                        phi_5708_ = -(_e1668[1]);
                                    } else {
                                        phi_5708_ = _e1668[1];
                                    }
                                    let _e1679 = phi_5708_;
                                    if (_e1675 > _e1679) {
                                        phi_5713_ = _e1675;
                                    } else {
                                        phi_5713_ = _e1679;
                                    }
                                    let _e1682 = phi_5713_;
                                    if (_e1668[2] < 0f) {
                                        phi_5720_ = -(_e1668[2]);
                                    } else {
                                        phi_5720_ = _e1668[2];
                                    }
                                    let _e1686 = phi_5720_;
                                    if (_e1682 > _e1686) {
                                        phi_5725_ = _e1682;
                                    } else {
                                        phi_5725_ = _e1686;
                                    }
                                    let _e1689 = phi_5725_;
                                    let _e1691 = local_12.member_2[1u];
                                    if (_e1691[0] < 0f) {
                                        phi_5738_ = -(_e1691[0]);
                                    } else {
                                        phi_5738_ = _e1691[0];
                                    }
                                    let _e1698 = phi_5738_;
                                    if (_e1691[1] < 0f) {
                                        phi_5745_ = -(_e1691[1]);
                                    } else {
                                        phi_5745_ = _e1691[1];
                                    }
                                    let _e1702 = phi_5745_;
                                    if (_e1698 > _e1702) {
                                        phi_5750_ = _e1698;
                                    } else {
                                        phi_5750_ = _e1702;
                                    }
                                    let _e1705 = phi_5750_;
                                    if (_e1691[2] < 0f) {
                                        phi_5757_ = -(_e1691[2]);
                                    } else {
                                        phi_5757_ = _e1691[2];
                                    }
                                    let _e1709 = phi_5757_;
                                    if (_e1705 > _e1709) {
                                        phi_5762_ = _e1705;
                                    } else {
                                        phi_5762_ = _e1709;
                                    }
                                    let _e1712 = phi_5762_;
                                    if (_e1689 > _e1712) {
                                        phi_5767_ = _e1689;
                                    } else {
                                        phi_5767_ = _e1712;
                                    }
                                    let _e1715 = phi_5767_;
                                    let _e1718 = local_12.member_2[0u];
                                    let _e1723 = local_12.member_2[1u];
                                    let _e1733 = (_e1718[0] + ((_e1723[0] - _e1718[0]) * _e1401));
                                    let _e1734 = (_e1718[1] + ((_e1723[1] - _e1718[1]) * _e1401));
                                    let _e1735 = (_e1718[2] + ((_e1723[2] - _e1718[2]) * _e1401));
                                    let _e1737 = local_12.member_2[1u];
                                    let _e1742 = local_12.member_2[0u];
                                    let _e1746 = (_e1737[0] - _e1742[0]);
                                    let _e1747 = (_e1737[1] - _e1742[1]);
                                    let _e1748 = (_e1737[2] - _e1742[2]);
                                    if (_e1746 < 0f) {
                                        phi_5826_ = -(_e1746);
                                    } else {
                                        phi_5826_ = _e1746;
                                    }
                                    let _e1752 = phi_5826_;
                                    if (_e1747 < 0f) {
                                        phi_5832_ = -(_e1747);
                                    } else {
                                        phi_5832_ = _e1747;
                                    }
                                    let _e1756 = phi_5832_;
                                    if (_e1752 > _e1756) {
                                        phi_5837_ = _e1752;
                                    } else {
                                        phi_5837_ = _e1756;
                                    }
                                    let _e1759 = phi_5837_;
                                    if (_e1748 < 0f) {
                                        phi_5843_ = -(_e1748);
                                    } else {
                                        phi_5843_ = _e1748;
                                    }
                                    let _e1763 = phi_5843_;
                                    if (_e1759 > _e1763) {
                                        phi_5848_ = _e1759;
                                    } else {
                                        phi_5848_ = _e1763;
                                    }
                                    let _e1766 = phi_5848_;
                                    let _e1772 = ((((_e1403 * _e1766) * 1.01f) + ((_e1715 + _e1666) * (0.000000059604645f * 8f))) + _e1666);
                                    if (_e1733 < 0f) {
                                        phi_5860_ = -(_e1733);
                                    } else {
                                        phi_5860_ = _e1733;
                                    }
                                    let _e1776 = phi_5860_;
                                    if (_e1734 < 0f) {
                                        phi_5866_ = -(_e1734);
                                    } else {
                                        phi_5866_ = _e1734;
                                    }
                                    let _e1780 = phi_5866_;
                                    if (_e1776 > _e1780) {
                                        phi_5871_ = _e1776;
                                    } else {
                                        phi_5871_ = _e1780;
                                    }
                                    let _e1783 = phi_5871_;
                                    if (_e1735 < 0f) {
                                        phi_5877_ = -(_e1735);
                                    } else {
                                        phi_5877_ = _e1735;
                                    }
                                    let _e1787 = phi_5877_;
                                    if (_e1783 > _e1787) {
                                        phi_5882_ = _e1783;
                                    } else {
                                        phi_5882_ = _e1787;
                                    }
                                    let _e1790 = phi_5882_;
                                    local_4 = type_26(array<f32, 3>(_e1733, _e1734, _e1735), _e1772, (_e1790 + _e1772));
                                    let _e1795 = local_3.member;
                                    let _e1800 = local_4.member;
                                    let _e1806 = ((_e1795[1] * _e1800[2]) - (_e1795[2] * _e1800[1]));
                                    let _e1809 = ((_e1795[2] * _e1800[0]) - (_e1795[0] * _e1800[2]));
                                    let _e1812 = ((_e1795[0] * _e1800[1]) - (_e1795[1] * _e1800[0]));
                                    if (_e1806 < 0f) {
                                        phi_5931_ = -(_e1806);
                                    } else {
                                        phi_5931_ = _e1806;
                                    }
                                    let _e1816 = phi_5931_;
                                    if (_e1809 < 0f) {
                                        phi_5937_ = -(_e1809);
                                    } else {
                                        phi_5937_ = _e1809;
                                    }
                                    let _e1820 = phi_5937_;
                                    if (_e1816 > _e1820) {
                                        if (_e1806 < 0f) {
                                            phi_5947_ = -(_e1806);
                                        } else {
                                            phi_5947_ = _e1806;
                                        }
                                        let _e1838 = phi_5947_;
                                        if (_e1812 < 0f) {
                                            phi_5953_ = -(_e1812);
                                        } else {
                                            phi_5953_ = _e1812;
                                        }
                                        let _e1842 = phi_5953_;
                                        if (_e1838 > _e1842) {
                                            phi_5958_ = 2u;
                                            phi_5959_ = 1u;
                                        } else {
                                            phi_5958_ = 1u;
                                            phi_5959_ = 0u;
                                        }
                                        let _e1845 = phi_5958_;
                                        let _e1847 = phi_5959_;
                                        phi_5978_ = _e1845;
                                        phi_5979_ = _e1847;
                                    } else {
                                        if (_e1809 < 0f) {
                                            phi_5965_ = -(_e1809);
                                        } else {
                                            phi_5965_ = _e1809;
                                        }
                                        let _e1825 = phi_5965_;
                                        if (_e1812 < 0f) {
                                            phi_5971_ = -(_e1812);
                                        } else {
                                            phi_5971_ = _e1812;
                                        }
                                        let _e1829 = phi_5971_;
                                        if (_e1825 > _e1829) {
                                            phi_5976_ = 0u;
                                            phi_5977_ = 2u;
                                        } else {
                                            phi_5976_ = 1u;
                                            phi_5977_ = 0u;
                                        }
                                        let _e1832 = phi_5976_;
                                        let _e1834 = phi_5977_;
                                        phi_5978_ = _e1832;
                                        phi_5979_ = _e1834;
                                    }
                                    let _e1849 = phi_5978_;
                                    let _e1851 = phi_5979_;
                                    let _e1854 = local_3.member[_e1851];
                                    let _e1857 = local_4.member[_e1849];
                                    let _e1861 = local_3.member[_e1849];
                                    let _e1864 = local_4.member[_e1851];
                                    let _e1866 = ((_e1854 * _e1857) - (_e1861 * _e1864));
                                    let _e1868 = local_3.member_1;
                                    let _e1870 = local_4.member_2;
                                    let _e1873 = local_3.member_2;
                                    let _e1875 = local_4.member_1;
                                    let _e1880 = local_3.member_2;
                                    let _e1883 = local_4.member_2;
                                    let _e1891 = local_3.member_2;
                                    let _e1894 = local_4.member_2;
                                    let _e1898 = (((((_e1868 * _e1870) + (_e1873 * _e1875)) * 2.01f) + (((_e1880 * 2f) * (_e1883 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1891) * (1f + _e1894))));
                                    if (_e1866 < 0f) {
                                        phi_6048_ = -(_e1866);
                                    } else {
                                        phi_6048_ = _e1866;
                                    }
                                    let _e1902 = phi_6048_;
                                    if (_e1902 > _e1898) {
                                        if (_e1866 < 0f) {
                                            phi_6057_ = -1f;
                                        } else {
                                            phi_6057_ = 1f;
                                        }
                                        let _e1906 = phi_6057_;
                                        let _e1909 = local_2.member[_e1851];
                                        let _e1912 = local_4.member[_e1849];
                                        let _e1916 = local_2.member[_e1849];
                                        let _e1919 = local_4.member[_e1851];
                                        let _e1923 = local_2.member_1;
                                        let _e1925 = local_4.member_2;
                                        let _e1928 = local_2.member_2;
                                        let _e1930 = local_4.member_1;
                                        let _e1935 = local_2.member_2;
                                        let _e1938 = local_4.member_2;
                                        let _e1946 = local_2.member_2;
                                        let _e1949 = local_4.member_2;
                                        let _e1953 = (((((_e1923 * _e1925) + (_e1928 * _e1930)) * 2.01f) + (((_e1935 * 2f) * (_e1938 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1946) * (1f + _e1949))));
                                        let _e1956 = local_3.member[_e1851];
                                        let _e1959 = local_2.member[_e1849];
                                        let _e1963 = local_3.member[_e1849];
                                        let _e1966 = local_2.member[_e1851];
                                        let _e1970 = local_3.member_1;
                                        let _e1972 = local_2.member_2;
                                        let _e1975 = local_3.member_2;
                                        let _e1977 = local_2.member_1;
                                        let _e1982 = local_3.member_2;
                                        let _e1985 = local_2.member_2;
                                        let _e1993 = local_3.member_2;
                                        let _e1996 = local_2.member_2;
                                        let _e2000 = (((((_e1970 * _e1972) + (_e1975 * _e1977)) * 2.01f) + (((_e1982 * 2f) * (_e1985 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1993) * (1f + _e1996))));
                                        let _e2001 = (_e1866 * _e1906);
                                        let _e2002 = (((_e1909 * _e1912) - (_e1916 * _e1919)) * _e1906);
                                        let _e2003 = (((_e1956 * _e1959) - (_e1963 * _e1966)) * _e1906);
                                        if (_e2001 < 0f) {
                                            phi_6192_ = -(_e2001);
                                        } else {
                                            phi_6192_ = _e2001;
                                        }
                                        let _e2007 = phi_6192_;
                                        if (_e2002 < 0f) {
                                            phi_6198_ = -(_e2002);
                                        } else {
                                            phi_6198_ = _e2002;
                                        }
                                        let _e2011 = phi_6198_;
                                        if (_e2003 < 0f) {
                                            phi_6205_ = -(_e2003);
                                        } else {
                                            phi_6205_ = _e2003;
                                        }
                                        let _e2016 = phi_6205_;
                                        let _e2019 = (((_e2007 + _e2011) + _e2016) * (0.000000059604645f * 4f));
                                        local_5 = array<type_32, 4>(type_32(_e2002, _e1953), type_32(_e2003, _e2000), type_32((_e2001 - _e2002), ((_e1898 + _e1953) + _e2019)), type_32((_e2001 - _e2003), ((_e1898 + _e2000) + _e2019)));
                                        phi_6260_ = type_12(0u, 4u);
                                        phi_6263_ = true;
                                        loop {
                                            let _e2032 = phi_6260_;
                                            let _e2034 = phi_6263_;
                                            local_17 = _e2034;
                                            if (_e2032.member < _e2032.member_1) {
                                                phi_6261_ = type_12((_e2032.member + 1u), _e2032.member_1);
                                                phi_6286_ = type_12(1u, _e2032.member);
                                            } else {
                                                phi_6261_ = _e2032;
                                                phi_6286_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e2046 = phi_6261_;
                                            let _e2048 = phi_6286_;
                                            if (bitcast<i32>(_e2048.member) != 0i) {
                                                let _e2055 = local_5[_e2048.member_1].member;
                                                let _e2058 = local_5[_e2048.member_1].member_1;
                                                let _e2060 = (_e2055 < -(_e2058));
                                                if _e2060 {
                                                    phi_6313_ = bool();
                                                    phi_6314_ = false;
                                                } else {
                                                    phi_6313_ = (_e2034 && (_e2055 > _e2058));
                                                    phi_6314_ = true;
                                                }
                                                let _e2064 = phi_6313_;
                                                let _e2066 = phi_6314_;
                                                phi_6264_ = _e2064;
                                                phi_6315_ = _e2066;
                                                phi_6316_ = _e2060;
                                            } else {
                                                phi_6264_ = bool();
                                                phi_6315_ = false;
                                                phi_6316_ = false;
                                            }
                                            let _e2068 = phi_6264_;
                                            let _e2070 = phi_6315_;
                                            let _e2072 = phi_6316_;
                                            local_16 = _e2072;
                                            continue;
                                            continuing {
                                                phi_6260_ = _e2046;
                                                phi_6263_ = _e2068;
                                                break if !(_e2070);
                                            }
                                        }
                                        let _e2075 = local_16;
                                        if _e2075 {
                                            phi_6320_ = false;
                                        } else {
                                            phi_6320_ = true;
                                        }
                                        let _e2077 = phi_6320_;
                                        if _e2077 {
                                            let _e2079 = local_17;
                                            if _e2079 {
                                                phi_6327_ = 1u;
                                            } else {
                                                phi_6327_ = 2u;
                                            }
                                            let _e2081 = phi_6327_;
                                            phi_6328_ = _e2081;
                                            phi_6329_ = false;
                                        } else {
                                            phi_6328_ = u32();
                                            phi_6329_ = true;
                                        }
                                        let _e2083 = phi_6328_;
                                        let _e2085 = phi_6329_;
                                        phi_6330_ = _e2083;
                                        phi_6331_ = 0u;
                                        phi_6332_ = _e2085;
                                    } else {
                                        phi_6330_ = u32();
                                        phi_6331_ = 2u;
                                        phi_6332_ = true;
                                    }
                                    let _e2087 = phi_6330_;
                                    let _e2089 = phi_6331_;
                                    let _e2091 = phi_6332_;
                                    if _e2091 {
                                        phi_6336_ = _e2089;
                                    } else {
                                        phi_6336_ = _e2087;
                                    }
                                    let _e2093 = phi_6336_;
                                    let _e2094 = (_e2093 == 0u);
                                    if _e2094 {
                                        phi_9042_ = f32();
                                        phi_9043_ = false;
                                        phi_9044_ = false;
                                        phi_9045_ = false;
                                    } else {
                                        if (_e2093 == 1u) {
                                            if _e1393.member_2 {
                                                if ((_e1393.member_1 - _e1393.member) <= 0.0000005f) {
                                                    phi_6356_ = false;
                                                } else {
                                                    phi_6356_ = true;
                                                }
                                                let _e2102 = phi_6356_;
                                                phi_6357_ = _e2102;
                                            } else {
                                                phi_6357_ = true;
                                            }
                                            let _e2104 = phi_6357_;
                                            phi_6358_ = _e2104;
                                        } else {
                                            phi_6358_ = true;
                                        }
                                        let _e2106 = phi_6358_;
                                        if _e2106 {
                                            let _e2111 = local_12.member[0u];
                                            let _e2117 = local_12.member_1[0u];
                                            let _e2123 = local_12.member_2[0u];
                                            let _e2127 = (_e2111[0] - _e2117[0]);
                                            let _e2128 = (_e2111[1] - _e2117[1]);
                                            let _e2129 = (_e2111[2] - _e2117[2]);
                                            let _e2138 = local_12.member[1u];
                                            let _e2144 = local_12.member_1[1u];
                                            let _e2150 = local_12.member_2[1u];
                                            let _e2154 = (_e2138[0] - _e2144[0]);
                                            let _e2155 = (_e2138[1] - _e2144[1]);
                                            let _e2156 = (_e2138[2] - _e2144[2]);
                                            let _e2165 = local_12.member[0u];
                                            if (_e2165[0] < 0f) {
                                                phi_6506_ = -(_e2165[0]);
                                            } else {
                                                phi_6506_ = _e2165[0];
                                            }
                                            let _e2172 = phi_6506_;
                                            if (_e2165[1] < 0f) {
                                                phi_6513_ = -(_e2165[1]);
                                            } else {
                                                phi_6513_ = _e2165[1];
                                            }
                                            let _e2176 = phi_6513_;
                                            if (_e2172 > _e2176) {
                                                phi_6518_ = _e2172;
                                            } else {
                                                phi_6518_ = _e2176;
                                            }
                                            let _e2179 = phi_6518_;
                                            if (_e2165[2] < 0f) {
                                                phi_6525_ = -(_e2165[2]);
                                            } else {
                                                phi_6525_ = _e2165[2];
                                            }
                                            let _e2183 = phi_6525_;
                                            if (_e2179 > _e2183) {
                                                phi_6530_ = _e2179;
                                            } else {
                                                phi_6530_ = _e2183;
                                            }
                                            let _e2186 = phi_6530_;
                                            let _e2189 = local_12.member[1u];
                                            if (_e2189[0] < 0f) {
                                                phi_6543_ = -(_e2189[0]);
                                            } else {
                                                phi_6543_ = _e2189[0];
                                            }
                                            let _e2196 = phi_6543_;
                                            if (_e2189[1] < 0f) {
                                                phi_6550_ = -(_e2189[1]);
                                            } else {
                                                phi_6550_ = _e2189[1];
                                            }
                                            let _e2200 = phi_6550_;
                                            if (_e2196 > _e2200) {
                                                phi_6555_ = _e2196;
                                            } else {
                                                phi_6555_ = _e2200;
                                            }
                                            let _e2203 = phi_6555_;
                                            if (_e2189[2] < 0f) {
                                                phi_6562_ = -(_e2189[2]);
                                            } else {
                                                phi_6562_ = _e2189[2];
                                            }
                                            let _e2207 = phi_6562_;
                                            if (_e2203 > _e2207) {
                                                phi_6567_ = _e2203;
                                            } else {
                                                phi_6567_ = _e2207;
                                            }
                                            let _e2210 = phi_6567_;
                                            if (_e2186 > _e2210) {
                                                phi_6572_ = _e2186;
                                            } else {
                                                phi_6572_ = _e2210;
                                            }
                                            let _e2213 = phi_6572_;
                                            let _e2215 = local_12.member_3;
                                            let _e2219 = local_12.member_1[0u];
                                            if (_e2219[0] < 0f) {
                                                phi_6589_ = -(_e2219[0]);
                                            } else {
                                                phi_6589_ = _e2219[0];
                                            }
                                            let _e2226 = phi_6589_;
                                            if (_e2219[1] < 0f) {
                                                phi_6596_ = -(_e2219[1]);
                                            } else {
                                                phi_6596_ = _e2219[1];
                                            }
                                            let _e2230 = phi_6596_;
                                            if (_e2226 > _e2230) {
                                                phi_6601_ = _e2226;
                                            } else {
                                                phi_6601_ = _e2230;
                                            }
                                            let _e2233 = phi_6601_;
                                            if (_e2219[2] < 0f) {
                                                phi_6608_ = -(_e2219[2]);
                                            } else {
                                                phi_6608_ = _e2219[2];
                                            }
                                            let _e2237 = phi_6608_;
                                            if (_e2233 > _e2237) {
                                                phi_6613_ = _e2233;
                                            } else {
                                                phi_6613_ = _e2237;
                                            }
                                            let _e2240 = phi_6613_;
                                            let _e2243 = local_12.member_1[1u];
                                            if (_e2243[0] < 0f) {
                                                phi_6627_ = -(_e2243[0]);
                                            } else {
                                                phi_6627_ = _e2243[0];
                                            }
                                            let _e2250 = phi_6627_;
                                            if (_e2243[1] < 0f) {
                                                phi_6634_ = -(_e2243[1]);
                                            } else {
                                                phi_6634_ = _e2243[1];
                                            }
                                            let _e2254 = phi_6634_;
                                            if (_e2250 > _e2254) {
                                                phi_6639_ = _e2250;
                                            } else {
                                                phi_6639_ = _e2254;
                                            }
                                            let _e2257 = phi_6639_;
                                            if (_e2243[2] < 0f) {
                                                phi_6646_ = -(_e2243[2]);
                                            } else {
                                                phi_6646_ = _e2243[2];
                                            }
                                            let _e2261 = phi_6646_;
                                            if (_e2257 > _e2261) {
                                                phi_6651_ = _e2257;
                                            } else {
                                                phi_6651_ = _e2261;
                                            }
                                            let _e2264 = phi_6651_;
                                            if (_e2240 > _e2264) {
                                                phi_6656_ = _e2240;
                                            } else {
                                                phi_6656_ = _e2264;
                                            }
                                            let _e2267 = phi_6656_;
                                            let _e2269 = local_12.member_3;
                                            let _e2273 = local_12.member_2[0u];
                                            if (_e2273[0] < 0f) {
                                                phi_6673_ = -(_e2273[0]);
                                            } else {
                                                phi_6673_ = _e2273[0];
                                            }
                                            let _e2280 = phi_6673_;
                                            if (_e2273[1] < 0f) {
                                                phi_6680_ = -(_e2273[1]);
                                            } else {
                                                phi_6680_ = _e2273[1];
                                            }
                                            let _e2284 = phi_6680_;
                                            if (_e2280 > _e2284) {
                                                phi_6685_ = _e2280;
                                            } else {
                                                phi_6685_ = _e2284;
                                            }
                                            let _e2287 = phi_6685_;
                                            if (_e2273[2] < 0f) {
                                                phi_6692_ = -(_e2273[2]);
                                            } else {
                                                phi_6692_ = _e2273[2];
                                            }
                                            let _e2291 = phi_6692_;
                                            if (_e2287 > _e2291) {
                                                phi_6697_ = _e2287;
                                            } else {
                                                phi_6697_ = _e2291;
                                            }
                                            let _e2294 = phi_6697_;
                                            let _e2297 = local_12.member_2[1u];
                                            if (_e2297[0] < 0f) {
                                                phi_6711_ = -(_e2297[0]);
                                            } else {
                                                phi_6711_ = _e2297[0];
                                            }
                                            let _e2304 = phi_6711_;
                                            if (_e2297[1] < 0f) {
                                                phi_6718_ = -(_e2297[1]);
                                            } else {
                                                phi_6718_ = _e2297[1];
                                            }
                                            let _e2308 = phi_6718_;
                                            if (_e2304 > _e2308) {
                                                phi_6723_ = _e2304;
                                            } else {
                                                phi_6723_ = _e2308;
                                            }
                                            let _e2311 = phi_6723_;
                                            if (_e2297[2] < 0f) {
                                                phi_6730_ = -(_e2297[2]);
                                            } else {
                                                phi_6730_ = _e2297[2];
                                            }
                                            let _e2315 = phi_6730_;
                                            if (_e2311 > _e2315) {
                                                phi_6735_ = _e2311;
                                            } else {
                                                phi_6735_ = _e2315;
                                            }
                                            let _e2318 = phi_6735_;
                                            if (_e2294 > _e2318) {
                                                phi_6740_ = _e2294;
                                            } else {
                                                phi_6740_ = _e2318;
                                            }
                                            let _e2321 = phi_6740_;
                                            let _e2323 = local_12.member_3;
                                            let _e2330 = local_12.member_3;
                                            local = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6780_ = type_12(0u, 96u);
                                            phi_6783_ = _e1393.member;
                                            phi_6785_ = _e1393.member;
                                            phi_6787_ = (_e1393.member_1 - _e1393.member);
                                            phi_6789_ = _e1393.member;
                                            phi_6791_ = false;
                                            phi_6793_ = 0u;
                                            loop {
                                                let _e2337 = phi_6780_;
                                                let _e2339 = phi_6783_;
                                                let _e2341 = phi_6785_;
                                                let _e2343 = phi_6787_;
                                                let _e2345 = phi_6789_;
                                                let _e2347 = phi_6791_;
                                                let _e2349 = phi_6793_;
                                                local_20 = _e2339;
                                                local_42 = _e2341;
                                                if (_e2337.member < _e2337.member_1) {
                                                    phi_6781_ = type_12((_e2337.member + 1u), _e2337.member_1);
                                                    phi_6816_ = type_12(1u, _e2337.member);
                                                } else {
                                                    phi_6781_ = _e2337;
                                                    phi_6816_ = type_12(0u, type_12().member_1);
                                                }
                                                let _e2361 = phi_6781_;
                                                let _e2363 = phi_6816_;
                                                if (bitcast<i32>(_e2363.member) != 0i) {
                                                    let _e2369 = local_12.member[0u];
                                                    let _e2375 = local_12.member[1u];
                                                    let _e2391 = local_12.member_1[0u];
                                                    let _e2397 = local_12.member_1[1u];
                                                    let _e2413 = local_12.member_2[0u];
                                                    let _e2419 = local_12.member_2[1u];
                                                    let _e2433 = function_2(array<f32, 3>((_e2369[0] + ((_e2375[0] - _e2369[0]) * _e2339)), (_e2369[1] + ((_e2375[1] - _e2369[1]) * _e2339)), (_e2369[2] + ((_e2375[2] - _e2369[2]) * _e2339))), array<f32, 3>((_e2391[0] + ((_e2397[0] - _e2391[0]) * _e2339)), (_e2391[1] + ((_e2397[1] - _e2391[1]) * _e2339)), (_e2391[2] + ((_e2397[2] - _e2391[2]) * _e2339))), array<f32, 3>((_e2413[0] + ((_e2419[0] - _e2413[0]) * _e2339)), (_e2413[1] + ((_e2419[1] - _e2413[1]) * _e2339)), (_e2413[2] + ((_e2419[2] - _e2413[2]) * _e2339))), 1u);
                                                    if (_e2349 == 0u) {
                                                        phi_6944_ = _e2433;
                                                    } else {
                                                        if (_e2349 == 1u) {
                                                            phi_6930_ = _e2433[0];
                                                        } else {
                                                            phi_6930_ = 0f;
                                                        }
                                                        let _e2438 = phi_6930_;
                                                        if (_e2349 == 2u) {
                                                            phi_6936_ = _e2433[1];
                                                        } else {
                                                            phi_6936_ = 0f;
                                                        }
                                                        let _e2442 = phi_6936_;
                                                        if (_e2349 == 3u) {
                                                            phi_6942_ = _e2433[2];
                                                        } else {
                                                            phi_6942_ = 0f;
                                                        }
                                                        let _e2446 = phi_6942_;
                                                        phi_6944_ = array<f32, 3>(_e2438, _e2442, _e2446);
                                                    }
                                                    let _e2449 = phi_6944_;
                                                    if (_e2449[0] < 0f) {
                                                        phi_6951_ = -(_e2449[0]);
                                                    } else {
                                                        phi_6951_ = _e2449[0];
                                                    }
                                                    let _e2454 = phi_6951_;
                                                    if (_e2449[1] < 0f) {
                                                        phi_6958_ = -(_e2449[1]);
                                                    } else {
                                                        phi_6958_ = _e2449[1];
                                                    }
                                                    let _e2459 = phi_6958_;
                                                    if (_e2449[2] < 0f) {
                                                        phi_6966_ = -(_e2449[2]);
                                                    } else {
                                                        phi_6966_ = _e2449[2];
                                                    }
                                                    let _e2465 = phi_6966_;
                                                    let _e2466 = ((_e2454 + _e2459) + _e2465);
                                                    if (_e2466 > 0f) {
                                                        if ((bitcast<u32>(_e2466) & 2139095040u) != 2139095040u) {
                                                            let _e2471 = (1f / _e2466);
                                                            let _e2473 = (_e2449[0] * _e2471);
                                                            let _e2475 = (_e2449[1] * _e2471);
                                                            let _e2477 = (_e2449[2] * _e2471);
                                                            let _e2482 = (((_e2473 * _e2473) + (_e2475 * _e2475)) + (_e2477 * _e2477));
                                                            if (_e2482 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2482 > 0f) {
                                                                    phi_7003_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_7003_ = 0f;
                                                                }
                                                                let _e2535 = phi_7003_;
                                                                phi_7067_ = _e2535;
                                                            } else {
                                                                phi_7010_ = type_14(0i, 5i);
                                                                phi_7013_ = bitcast<f32>(((bitcast<u32>(_e2482) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2490 = phi_7010_;
                                                                    let _e2492 = phi_7013_;
                                                                    local_18 = _e2492;
                                                                    if (_e2490.member < _e2490.member_1) {
                                                                        let _e2499 = (_e2490.member + 1i);
                                                                        if ((false == (_e2499 > _e2490.member)) != false) {
                                                                            phi_7034_ = true;
                                                                        } else {
                                                                            phi_7034_ = false;
                                                                        }
                                                                        let _e2504 = phi_7034_;
                                                                        if _e2504 {
                                                                            phi_7040_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_7040_ = type_15(1u, _e2499);
                                                                        }
                                                                        let _e2509 = phi_7040_;
                                                                        phi_7011_ = type_14(_e2509.member_1, _e2490.member_1);
                                                                        phi_7054_ = type_15(1u, _e2490.member);
                                                                    } else {
                                                                        phi_7011_ = _e2490;
                                                                        phi_7054_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2515 = phi_7011_;
                                                                    let _e2517 = phi_7054_;
                                                                    let _e2520 = (bitcast<i32>(_e2517.member) != 0i);
                                                                    if _e2520 {
                                                                        phi_7014_ = (0.5f * (_e2492 + (_e2482 / _e2492)));
                                                                    } else {
                                                                        phi_7014_ = f32();
                                                                    }
                                                                    let _e2525 = phi_7014_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7010_ = _e2515;
                                                                        phi_7013_ = _e2525;
                                                                        break if !(_e2520);
                                                                    }
                                                                }
                                                                let _e2530 = local_18;
                                                                phi_7067_ = (_e2530 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2537 = phi_7067_;
                                                            let _e2538 = (0.000000059604645f * 12f);
                                                            let _e2543 = ((((((((_e2213 + _e2215) + (_e2267 + _e2269)) + (_e2321 + _e2323)) * (0.000000059604645f * 16f)) + (_e2330 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2537) * (1f + _e2538)));
                                                            let _e2548 = (((_e2473 * _e2111[0]) + (_e2475 * _e2111[1])) + (_e2477 * _e2111[2]));
                                                            let _e2553 = (((_e2473 * _e2127) + (_e2475 * _e2128)) + (_e2477 * _e2129));
                                                            let _e2558 = (((_e2473 * (_e2111[0] - _e2123[0])) + (_e2475 * (_e2111[1] - _e2123[1]))) + (_e2477 * (_e2111[2] - _e2123[2])));
                                                            let _e2563 = (((_e2473 * (_e2127 - _e2123[0])) + (_e2475 * (_e2128 - _e2123[1]))) + (_e2477 * (_e2129 - _e2123[2])));
                                                            let _e2569 = (((_e2473 * _e2138[0]) + (_e2475 * _e2138[1])) + (_e2477 * _e2138[2]));
                                                            let _e2574 = (((_e2473 * _e2154) + (_e2475 * _e2155)) + (_e2477 * _e2156));
                                                            let _e2579 = (((_e2473 * (_e2138[0] - _e2150[0])) + (_e2475 * (_e2138[1] - _e2150[1]))) + (_e2477 * (_e2138[2] - _e2150[2])));
                                                            let _e2584 = (((_e2473 * (_e2154 - _e2150[0])) + (_e2475 * (_e2155 - _e2150[1]))) + (_e2477 * (_e2156 - _e2150[2])));
                                                            if (_e2548 < 0f) {
                                                                phi_7133_ = -(_e2548);
                                                            } else {
                                                                phi_7133_ = _e2548;
                                                            }
                                                            let _e2589 = phi_7133_;
                                                            if (_e2569 < 0f) {
                                                                phi_7139_ = -(_e2569);
                                                            } else {
                                                                phi_7139_ = _e2569;
                                                            }
                                                            let _e2593 = phi_7139_;
                                                            if (_e2553 < 0f) {
                                                                phi_7148_ = -(_e2553);
                                                            } else {
                                                                phi_7148_ = _e2553;
                                                            }
                                                            let _e2600 = phi_7148_;
                                                            if (_e2574 < 0f) {
                                                                phi_7154_ = -(_e2574);
                                                            } else {
                                                                phi_7154_ = _e2574;
                                                            }
                                                            let _e2604 = phi_7154_;
                                                            if (_e2558 < 0f) {
                                                                phi_7163_ = -(_e2558);
                                                            } else {
                                                                phi_7163_ = _e2558;
                                                            }
                                                            let _e2611 = phi_7163_;
                                                            if (_e2579 < 0f) {
                                                                phi_7169_ = -(_e2579);
                                                            } else {
                                                                phi_7169_ = _e2579;
                                                            }
                                                            let _e2615 = phi_7169_;
                                                            if (_e2563 < 0f) {
                                                                phi_7178_ = -(_e2563);
                                                            } else {
                                                                phi_7178_ = _e2563;
                                                            }
                                                            let _e2622 = phi_7178_;
                                                            if (_e2584 < 0f) {
                                                                phi_7184_ = -(_e2584);
                                                            } else {
                                                                phi_7184_ = _e2584;
                                                            }
                                                            let _e2626 = phi_7184_;
                                                            phi_7190_ = type_31(array<f32, 4>(_e2548, _e2553, _e2558, _e2563), array<f32, 4>(_e2569, _e2574, _e2579, _e2584), array<f32, 4>((_e2543 + ((_e2589 + _e2593) * _e2538)), (_e2543 + ((_e2600 + _e2604) * _e2538)), (_e2543 + ((_e2611 + _e2615) * _e2538)), (_e2543 + ((_e2622 + _e2626) * _e2538))));
                                                            phi_7191_ = false;
                                                        } else {
                                                            phi_7190_ = type_31();
                                                            phi_7191_ = true;
                                                        }
                                                        let _e2633 = phi_7190_;
                                                        let _e2635 = phi_7191_;
                                                        phi_7192_ = _e2633;
                                                        phi_7193_ = _e2635;
                                                    } else {
                                                        phi_7192_ = type_31();
                                                        phi_7193_ = true;
                                                    }
                                                    let _e2637 = phi_7192_;
                                                    let _e2639 = phi_7193_;
                                                    if _e2639 {
                                                        phi_7201_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7201_ = _e2637;
                                                    }
                                                    let _e2641 = phi_7201_;
                                                    local_1 = type_31(array<f32, 4>(_e2641.member[0], _e2641.member[1], _e2641.member[2], _e2641.member[3]), array<f32, 4>(_e2641.member_1[0], _e2641.member_1[1], _e2641.member_1[2], _e2641.member_1[3]), array<f32, 4>(_e2641.member_2[0], _e2641.member_2[1], _e2641.member_2[2], _e2641.member_2[3]));
                                                    let _e2661 = (_e2339 - _e2345);
                                                    let _e2665 = local_1.member[0u];
                                                    let _e2668 = local_1.member_1[0u];
                                                    let _e2671 = local_1.member[0u];
                                                    let _e2677 = local_1.member_2[0u];
                                                    if (((_e2665 + ((_e2668 - _e2671) * _e2339)) - _e2677) > 0f) {
                                                        let _e2682 = local_1.member[1u];
                                                        let _e2685 = local_1.member_1[1u];
                                                        let _e2688 = local_1.member[1u];
                                                        let _e2694 = local_1.member_2[1u];
                                                        if (((_e2682 + ((_e2685 - _e2688) * _e2339)) - _e2694) > 0f) {
                                                            let _e2699 = local_1.member[2u];
                                                            let _e2702 = local_1.member_1[2u];
                                                            let _e2705 = local_1.member[2u];
                                                            let _e2711 = local_1.member_2[2u];
                                                            if (((_e2699 + ((_e2702 - _e2705) * _e2339)) - _e2711) > 0f) {
                                                                let _e2716 = local_1.member[3u];
                                                                let _e2719 = local_1.member_1[3u];
                                                                let _e2722 = local_1.member[3u];
                                                                let _e2728 = local_1.member_2[3u];
                                                                phi_7372_ = (((_e2716 + ((_e2719 - _e2722) * _e2339)) - _e2728) > 0f);
                                                                phi_7373_ = false;
                                                            } else {
                                                                phi_7372_ = bool();
                                                                phi_7373_ = true;
                                                            }
                                                            let _e2732 = phi_7372_;
                                                            let _e2734 = phi_7373_;
                                                            phi_7374_ = _e2732;
                                                            phi_7375_ = _e2734;
                                                        } else {
                                                            phi_7374_ = bool();
                                                            phi_7375_ = true;
                                                        }
                                                        let _e2736 = phi_7374_;
                                                        let _e2738 = phi_7375_;
                                                        phi_7376_ = _e2736;
                                                        phi_7377_ = _e2738;
                                                    } else {
                                                        phi_7376_ = bool();
                                                        phi_7377_ = true;
                                                    }
                                                    let _e2740 = phi_7376_;
                                                    let _e2742 = phi_7377_;
                                                    if _e2742 {
                                                        phi_7381_ = false;
                                                    } else {
                                                        phi_7381_ = _e2740;
                                                    }
                                                    let _e2744 = phi_7381_;
                                                    if _e2744 {
                                                        if (_e2339 <= _e2341) {
                                                            phi_7691_ = true;
                                                        } else {
                                                            let _e2748 = local.member[0u];
                                                            let _e2751 = local.member_1[0u];
                                                            let _e2754 = local.member[0u];
                                                            let _e2760 = local.member_2[0u];
                                                            let _e2764 = local_1.member[0u];
                                                            let _e2767 = local_1.member_1[0u];
                                                            let _e2770 = local_1.member[0u];
                                                            let _e2776 = local_1.member_2[0u];
                                                            if ((((_e2748 + ((_e2751 - _e2754) * _e2339)) - _e2760) + ((_e2764 + ((_e2767 - _e2770) * _e2345)) - _e2776)) > 0f) {
                                                                let _e2782 = local.member[1u];
                                                                let _e2785 = local.member_1[1u];
                                                                let _e2788 = local.member[1u];
                                                                let _e2794 = local.member_2[1u];
                                                                let _e2798 = local_1.member[1u];
                                                                let _e2801 = local_1.member_1[1u];
                                                                let _e2804 = local_1.member[1u];
                                                                let _e2810 = local_1.member_2[1u];
                                                                if ((((_e2782 + ((_e2785 - _e2788) * _e2339)) - _e2794) + ((_e2798 + ((_e2801 - _e2804) * _e2345)) - _e2810)) > 0f) {
                                                                    let _e2816 = local.member[2u];
                                                                    let _e2819 = local.member_1[2u];
                                                                    let _e2822 = local.member[2u];
                                                                    let _e2828 = local.member_2[2u];
                                                                    let _e2832 = local_1.member[2u];
                                                                    let _e2835 = local_1.member_1[2u];
                                                                    let _e2838 = local_1.member[2u];
                                                                    let _e2844 = local_1.member_2[2u];
                                                                    if ((((_e2816 + ((_e2819 - _e2822) * _e2339)) - _e2828) + ((_e2832 + ((_e2835 - _e2838) * _e2345)) - _e2844)) > 0f) {
                                                                        let _e2850 = local.member[3u];
                                                                        let _e2853 = local.member_1[3u];
                                                                        let _e2856 = local.member[3u];
                                                                        let _e2862 = local.member_2[3u];
                                                                        let _e2866 = local_1.member[3u];
                                                                        let _e2869 = local_1.member_1[3u];
                                                                        let _e2872 = local_1.member[3u];
                                                                        let _e2878 = local_1.member_2[3u];
                                                                        phi_7678_ = ((((_e2850 + ((_e2853 - _e2856) * _e2339)) - _e2862) + ((_e2866 + ((_e2869 - _e2872) * _e2345)) - _e2878)) > 0f);
                                                                        phi_7679_ = false;
                                                                    } else {
                                                                        phi_7678_ = bool();
                                                                        phi_7679_ = true;
                                                                    }
                                                                    let _e2883 = phi_7678_;
                                                                    let _e2885 = phi_7679_;
                                                                    phi_7680_ = _e2883;
                                                                    phi_7681_ = _e2885;
                                                                } else {
                                                                    phi_7680_ = bool();
                                                                    phi_7681_ = true;
                                                                }
                                                                let _e2887 = phi_7680_;
                                                                let _e2889 = phi_7681_;
                                                                phi_7682_ = _e2887;
                                                                phi_7683_ = _e2889;
                                                            } else {
                                                                phi_7682_ = bool();
                                                                phi_7683_ = true;
                                                            }
                                                            let _e2891 = phi_7682_;
                                                            let _e2893 = phi_7683_;
                                                            if _e2893 {
                                                                phi_7687_ = false;
                                                            } else {
                                                                phi_7687_ = _e2891;
                                                            }
                                                            let _e2895 = phi_7687_;
                                                            phi_7691_ = _e2895;
                                                        }
                                                        let _e2897 = phi_7691_;
                                                        if _e2897 {
                                                            if _e2347 {
                                                                if (_e2339 >= _e1393.member_1) {
                                                                    phi_7702_ = false;
                                                                } else {
                                                                    phi_7702_ = true;
                                                                }
                                                                let _e2900 = phi_7702_;
                                                                phi_7703_ = _e2900;
                                                            } else {
                                                                phi_7703_ = true;
                                                            }
                                                            let _e2902 = phi_7703_;
                                                            if _e2902 {
                                                                local = type_31(array<f32, 4>(_e2641.member[0], _e2641.member[1], _e2641.member[2], _e2641.member[3]), array<f32, 4>(_e2641.member_1[0], _e2641.member_1[1], _e2641.member_1[2], _e2641.member_1[3]), array<f32, 4>(_e2641.member_2[0], _e2641.member_2[1], _e2641.member_2[2], _e2641.member_2[3]));
                                                                let _e2924 = local.member[0u];
                                                                let _e2927 = local.member_1[0u];
                                                                let _e2930 = local.member_2[0u];
                                                                if (_e2924 > _e2930) {
                                                                    if (_e2927 > _e2930) {
                                                                        phi_7777_ = false;
                                                                    } else {
                                                                        phi_7777_ = true;
                                                                    }
                                                                    let _e2934 = phi_7777_;
                                                                    phi_7778_ = _e2934;
                                                                } else {
                                                                    phi_7778_ = true;
                                                                }
                                                                let _e2936 = phi_7778_;
                                                                if _e2936 {
                                                                    let _e2937 = (_e2927 >= _e2924);
                                                                    if _e2937 {
                                                                        phi_7800_ = f32();
                                                                        phi_7801_ = false;
                                                                    } else {
                                                                        if ((_e2924 - _e2927) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7798_ = (((_e2924 - _e2930) / (_e2924 - _e2927)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7799_ = false;
                                                                        } else {
                                                                            phi_7798_ = f32();
                                                                            phi_7799_ = true;
                                                                        }
                                                                        let _e2948 = phi_7798_;
                                                                        let _e2950 = phi_7799_;
                                                                        phi_7800_ = _e2948;
                                                                        phi_7801_ = _e2950;
                                                                    }
                                                                    let _e2952 = phi_7800_;
                                                                    let _e2954 = phi_7801_;
                                                                    phi_7802_ = _e2952;
                                                                    phi_7803_ = _e2937;
                                                                    phi_7804_ = _e2954;
                                                                } else {
                                                                    phi_7802_ = f32();
                                                                    phi_7803_ = true;
                                                                    phi_7804_ = false;
                                                                }
                                                                let _e2956 = phi_7802_;
                                                                let _e2958 = phi_7803_;
                                                                let _e2960 = phi_7804_;
                                                                if _e2958 {
                                                                    phi_7808_ = 2f;
                                                                    phi_7809_ = true;
                                                                } else {
                                                                    phi_7808_ = _e2339;
                                                                    phi_7809_ = _e2960;
                                                                }
                                                                let _e2962 = phi_7808_;
                                                                let _e2964 = phi_7809_;
                                                                if _e2964 {
                                                                    phi_7813_ = _e2962;
                                                                } else {
                                                                    phi_7813_ = _e2956;
                                                                }
                                                                let _e2966 = phi_7813_;
                                                                let _e2969 = local.member[1u];
                                                                let _e2972 = local.member_1[1u];
                                                                let _e2975 = local.member_2[1u];
                                                                if (_e2969 > _e2975) {
                                                                    if (_e2972 > _e2975) {
                                                                        phi_7845_ = false;
                                                                    } else {
                                                                        phi_7845_ = true;
                                                                    }
                                                                    let _e2979 = phi_7845_;
                                                                    phi_7846_ = _e2979;
                                                                } else {
                                                                    phi_7846_ = true;
                                                                }
                                                                let _e2981 = phi_7846_;
                                                                if _e2981 {
                                                                    let _e2982 = (_e2972 >= _e2969);
                                                                    if _e2982 {
                                                                        phi_7868_ = f32();
                                                                        phi_7869_ = false;
                                                                    } else {
                                                                        if ((_e2969 - _e2972) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7866_ = (((_e2969 - _e2975) / (_e2969 - _e2972)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7867_ = false;
                                                                        } else {
                                                                            phi_7866_ = f32();
                                                                            phi_7867_ = true;
                                                                        }
                                                                        let _e2993 = phi_7866_;
                                                                        let _e2995 = phi_7867_;
                                                                        phi_7868_ = _e2993;
                                                                        phi_7869_ = _e2995;
                                                                    }
                                                                    let _e2997 = phi_7868_;
                                                                    let _e2999 = phi_7869_;
                                                                    phi_7870_ = _e2997;
                                                                    phi_7871_ = _e2982;
                                                                    phi_7872_ = _e2999;
                                                                } else {
                                                                    phi_7870_ = f32();
                                                                    phi_7871_ = true;
                                                                    phi_7872_ = false;
                                                                }
                                                                let _e3001 = phi_7870_;
                                                                let _e3003 = phi_7871_;
                                                                let _e3005 = phi_7872_;
                                                                if _e3003 {
                                                                    phi_7876_ = 2f;
                                                                    phi_7877_ = true;
                                                                } else {
                                                                    phi_7876_ = _e2339;
                                                                    phi_7877_ = _e3005;
                                                                }
                                                                let _e3007 = phi_7876_;
                                                                let _e3009 = phi_7877_;
                                                                if _e3009 {
                                                                    phi_7881_ = _e3007;
                                                                } else {
                                                                    phi_7881_ = _e3001;
                                                                }
                                                                let _e3011 = phi_7881_;
                                                                if (_e2966 < _e3011) {
                                                                    phi_7886_ = _e2966;
                                                                } else {
                                                                    phi_7886_ = _e3011;
                                                                }
                                                                let _e3014 = phi_7886_;
                                                                let _e3017 = local.member[2u];
                                                                let _e3020 = local.member_1[2u];
                                                                let _e3023 = local.member_2[2u];
                                                                if (_e3017 > _e3023) {
                                                                    if (_e3020 > _e3023) {
                                                                        phi_7918_ = false;
                                                                    } else {
                                                                        phi_7918_ = true;
                                                                    }
                                                                    let _e3027 = phi_7918_;
                                                                    phi_7919_ = _e3027;
                                                                } else {
                                                                    phi_7919_ = true;
                                                                }
                                                                let _e3029 = phi_7919_;
                                                                if _e3029 {
                                                                    let _e3030 = (_e3020 >= _e3017);
                                                                    if _e3030 {
                                                                        phi_7941_ = f32();
                                                                        phi_7942_ = false;
                                                                    } else {
                                                                        if ((_e3017 - _e3020) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7939_ = (((_e3017 - _e3023) / (_e3017 - _e3020)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7940_ = false;
                                                                        } else {
                                                                            phi_7939_ = f32();
                                                                            phi_7940_ = true;
                                                                        }
                                                                        let _e3041 = phi_7939_;
                                                                        let _e3043 = phi_7940_;
                                                                        phi_7941_ = _e3041;
                                                                        phi_7942_ = _e3043;
                                                                    }
                                                                    let _e3045 = phi_7941_;
                                                                    let _e3047 = phi_7942_;
                                                                    phi_7943_ = _e3045;
                                                                    phi_7944_ = _e3030;
                                                                    phi_7945_ = _e3047;
                                                                } else {
                                                                    phi_7943_ = f32();
                                                                    phi_7944_ = true;
                                                                    phi_7945_ = false;
                                                                }
                                                                let _e3049 = phi_7943_;
                                                                let _e3051 = phi_7944_;
                                                                let _e3053 = phi_7945_;
                                                                if _e3051 {
                                                                    phi_7949_ = 2f;
                                                                    phi_7950_ = true;
                                                                } else {
                                                                    phi_7949_ = _e2339;
                                                                    phi_7950_ = _e3053;
                                                                }
                                                                let _e3055 = phi_7949_;
                                                                let _e3057 = phi_7950_;
                                                                if _e3057 {
                                                                    phi_7954_ = _e3055;
                                                                } else {
                                                                    phi_7954_ = _e3049;
                                                                }
                                                                let _e3059 = phi_7954_;
                                                                let _e3062 = local.member[3u];
                                                                let _e3065 = local.member_1[3u];
                                                                let _e3068 = local.member_2[3u];
                                                                if (_e3062 > _e3068) {
                                                                    if (_e3065 > _e3068) {
                                                                        phi_7986_ = false;
                                                                    } else {
                                                                        phi_7986_ = true;
                                                                    }
                                                                    let _e3072 = phi_7986_;
                                                                    phi_7987_ = _e3072;
                                                                } else {
                                                                    phi_7987_ = true;
                                                                }
                                                                let _e3074 = phi_7987_;
                                                                if _e3074 {
                                                                    let _e3075 = (_e3065 >= _e3062);
                                                                    if _e3075 {
                                                                        phi_8009_ = f32();
                                                                        phi_8010_ = false;
                                                                    } else {
                                                                        if ((_e3062 - _e3065) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8007_ = (((_e3062 - _e3068) / (_e3062 - _e3065)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8008_ = false;
                                                                        } else {
                                                                            phi_8007_ = f32();
                                                                            phi_8008_ = true;
                                                                        }
                                                                        let _e3086 = phi_8007_;
                                                                        let _e3088 = phi_8008_;
                                                                        phi_8009_ = _e3086;
                                                                        phi_8010_ = _e3088;
                                                                    }
                                                                    let _e3090 = phi_8009_;
                                                                    let _e3092 = phi_8010_;
                                                                    phi_8011_ = _e3090;
                                                                    phi_8012_ = _e3075;
                                                                    phi_8013_ = _e3092;
                                                                } else {
                                                                    phi_8011_ = f32();
                                                                    phi_8012_ = true;
                                                                    phi_8013_ = false;
                                                                }
                                                                let _e3094 = phi_8011_;
                                                                let _e3096 = phi_8012_;
                                                                let _e3098 = phi_8013_;
                                                                if _e3096 {
                                                                    phi_8017_ = 2f;
                                                                    phi_8018_ = true;
                                                                } else {
                                                                    phi_8017_ = _e2339;
                                                                    phi_8018_ = _e3098;
                                                                }
                                                                let _e3100 = phi_8017_;
                                                                let _e3102 = phi_8018_;
                                                                if _e3102 {
                                                                    phi_8022_ = _e3100;
                                                                } else {
                                                                    phi_8022_ = _e3094;
                                                                }
                                                                let _e3104 = phi_8022_;
                                                                if (_e3059 < _e3104) {
                                                                    phi_8027_ = _e3059;
                                                                } else {
                                                                    phi_8027_ = _e3104;
                                                                }
                                                                let _e3107 = phi_8027_;
                                                                if (_e3014 < _e3107) {
                                                                    phi_8032_ = _e3014;
                                                                } else {
                                                                    phi_8032_ = _e3107;
                                                                }
                                                                let _e3110 = phi_8032_;
                                                                if (_e3110 > _e2339) {
                                                                    phi_8037_ = _e3110;
                                                                } else {
                                                                    phi_8037_ = _e2339;
                                                                }
                                                                let _e3113 = phi_8037_;
                                                                let _e3114 = (_e3113 > _e1393.member_1);
                                                                if _e3114 {
                                                                    phi_8541_ = f32();
                                                                    phi_8542_ = f32();
                                                                    phi_8543_ = false;
                                                                } else {
                                                                    let _e3115 = (_e3113 - _e2339);
                                                                    if _e2347 {
                                                                        if (_e3115 <= 0.0000000037252903f) {
                                                                            phi_8531_ = true;
                                                                        } else {
                                                                            if (_e3115 <= (_e2343 * 0.25f)) {
                                                                                phi_8530_ = false;
                                                                            } else {
                                                                                phi_8530_ = true;
                                                                            }
                                                                            let _e3121 = phi_8530_;
                                                                            phi_8531_ = _e3121;
                                                                        }
                                                                        let _e3123 = phi_8531_;
                                                                        if _e3123 {
                                                                            phi_8536_ = (_e2661 + _e2661);
                                                                        } else {
                                                                            phi_8536_ = 0f;
                                                                        }
                                                                        let _e3126 = phi_8536_;
                                                                        phi_8538_ = _e3126;
                                                                    } else {
                                                                        phi_8538_ = (_e1393.member_1 - _e2339);
                                                                    }
                                                                    let _e3128 = phi_8538_;
                                                                    phi_8541_ = _e3128;
                                                                    phi_8542_ = _e3115;
                                                                    phi_8543_ = true;
                                                                }
                                                                let _e3130 = phi_8541_;
                                                                let _e3132 = phi_8542_;
                                                                let _e3134 = phi_8543_;
                                                                phi_8545_ = _e3113;
                                                                phi_8546_ = _e3130;
                                                                phi_8547_ = _e3132;
                                                                phi_8549_ = _e3134;
                                                                phi_8550_ = _e3114;
                                                                phi_8552_ = false;
                                                            } else {
                                                                phi_8545_ = f32();
                                                                phi_8546_ = f32();
                                                                phi_8547_ = f32();
                                                                phi_8549_ = false;
                                                                phi_8550_ = false;
                                                                phi_8552_ = true;
                                                            }
                                                            let _e3136 = phi_8545_;
                                                            let _e3138 = phi_8546_;
                                                            let _e3140 = phi_8547_;
                                                            let _e3142 = phi_8549_;
                                                            let _e3144 = phi_8550_;
                                                            let _e3146 = phi_8552_;
                                                            phi_8553_ = _e3136;
                                                            phi_8554_ = _e3138;
                                                            phi_8555_ = _e3140;
                                                            phi_8557_ = false;
                                                            phi_8558_ = _e3142;
                                                            phi_8559_ = _e3144;
                                                            phi_8561_ = _e3146;
                                                        } else {
                                                            phi_8553_ = f32();
                                                            phi_8554_ = f32();
                                                            phi_8555_ = f32();
                                                            phi_8557_ = true;
                                                            phi_8558_ = false;
                                                            phi_8559_ = false;
                                                            phi_8561_ = false;
                                                        }
                                                        let _e3148 = phi_8553_;
                                                        let _e3150 = phi_8554_;
                                                        let _e3152 = phi_8555_;
                                                        let _e3154 = phi_8557_;
                                                        let _e3156 = phi_8558_;
                                                        let _e3158 = phi_8559_;
                                                        let _e3160 = phi_8561_;
                                                        phi_8562_ = _e3148;
                                                        phi_8563_ = _e3150;
                                                        phi_8564_ = _e3152;
                                                        phi_8566_ = _e3154;
                                                        phi_8567_ = _e3156;
                                                        phi_8568_ = _e3158;
                                                        phi_8570_ = _e3160;
                                                    } else {
                                                        phi_8562_ = f32();
                                                        phi_8563_ = f32();
                                                        phi_8564_ = f32();
                                                        phi_8566_ = true;
                                                        phi_8567_ = false;
                                                        phi_8568_ = false;
                                                        phi_8570_ = false;
                                                    }
                                                    let _e3162 = phi_8562_;
                                                    let _e3164 = phi_8563_;
                                                    let _e3166 = phi_8564_;
                                                    let _e3168 = phi_8566_;
                                                    let _e3170 = phi_8567_;
                                                    let _e3172 = phi_8568_;
                                                    let _e3174 = phi_8570_;
                                                    if _e3168 {
                                                        if (_e2339 <= _e2341) {
                                                            let _e3335 = (_e2349 + 1u);
                                                            let _e3336 = (_e3335 > 3u);
                                                            if _e3336 {
                                                                phi_8583_ = false;
                                                            } else {
                                                                phi_8583_ = true;
                                                            }
                                                            let _e3338 = phi_8583_;
                                                            phi_8905_ = _e3335;
                                                            phi_8906_ = f32();
                                                            phi_8907_ = false;
                                                            phi_8908_ = _e3338;
                                                            phi_8909_ = _e3336;
                                                        } else {
                                                            let _e3178 = local.member[0u];
                                                            let _e3181 = local.member_1[0u];
                                                            let _e3184 = local.member[0u];
                                                            let _e3190 = local.member_2[0u];
                                                            let _e3191 = ((_e3178 + ((_e3181 - _e3184) * _e2345)) - _e3190);
                                                            let _e3194 = local.member[1u];
                                                            let _e3197 = local.member_1[1u];
                                                            let _e3200 = local.member[1u];
                                                            let _e3206 = local.member_2[1u];
                                                            let _e3207 = ((_e3194 + ((_e3197 - _e3200) * _e2345)) - _e3206);
                                                            if (_e3191 < _e3207) {
                                                                phi_8656_ = _e3191;
                                                            } else {
                                                                phi_8656_ = _e3207;
                                                            }
                                                            let _e3210 = phi_8656_;
                                                            let _e3213 = local.member[2u];
                                                            let _e3216 = local.member_1[2u];
                                                            let _e3219 = local.member[2u];
                                                            let _e3225 = local.member_2[2u];
                                                            let _e3226 = ((_e3213 + ((_e3216 - _e3219) * _e2345)) - _e3225);
                                                            let _e3229 = local.member[3u];
                                                            let _e3232 = local.member_1[3u];
                                                            let _e3235 = local.member[3u];
                                                            let _e3241 = local.member_2[3u];
                                                            let _e3242 = ((_e3229 + ((_e3232 - _e3235) * _e2345)) - _e3241);
                                                            if (_e3226 < _e3242) {
                                                                phi_8729_ = _e3226;
                                                            } else {
                                                                phi_8729_ = _e3242;
                                                            }
                                                            let _e3245 = phi_8729_;
                                                            if (_e3210 < _e3245) {
                                                                phi_8734_ = _e3210;
                                                            } else {
                                                                phi_8734_ = _e3245;
                                                            }
                                                            let _e3248 = phi_8734_;
                                                            let _e3251 = local_1.member[0u];
                                                            let _e3254 = local_1.member_1[0u];
                                                            let _e3257 = local_1.member[0u];
                                                            let _e3263 = local_1.member_2[0u];
                                                            let _e3264 = ((_e3251 + ((_e3254 - _e3257) * _e2339)) - _e3263);
                                                            let _e3267 = local_1.member[1u];
                                                            let _e3270 = local_1.member_1[1u];
                                                            let _e3273 = local_1.member[1u];
                                                            let _e3279 = local_1.member_2[1u];
                                                            let _e3280 = ((_e3267 + ((_e3270 - _e3273) * _e2339)) - _e3279);
                                                            if (_e3264 < _e3280) {
                                                                phi_8807_ = _e3264;
                                                            } else {
                                                                phi_8807_ = _e3280;
                                                            }
                                                            let _e3283 = phi_8807_;
                                                            let _e3286 = local_1.member[2u];
                                                            let _e3289 = local_1.member_1[2u];
                                                            let _e3292 = local_1.member[2u];
                                                            let _e3298 = local_1.member_2[2u];
                                                            let _e3299 = ((_e3286 + ((_e3289 - _e3292) * _e2339)) - _e3298);
                                                            let _e3302 = local_1.member[3u];
                                                            let _e3305 = local_1.member_1[3u];
                                                            let _e3308 = local_1.member[3u];
                                                            let _e3314 = local_1.member_2[3u];
                                                            let _e3315 = ((_e3302 + ((_e3305 - _e3308) * _e2339)) - _e3314);
                                                            if (_e3299 < _e3315) {
                                                                phi_8880_ = _e3299;
                                                            } else {
                                                                phi_8880_ = _e3315;
                                                            }
                                                            let _e3318 = phi_8880_;
                                                            if (_e3283 < _e3318) {
                                                                phi_8885_ = _e3283;
                                                            } else {
                                                                phi_8885_ = _e3318;
                                                            }
                                                            let _e3321 = phi_8885_;
                                                            if (_e3321 > 0f) {
                                                                phi_8903_ = 0.5f;
                                                            } else {
                                                                let _e3325 = (0.95f * (_e3248 / (_e3248 - _e3321)));
                                                                if (_e3325 > 0.0625f) {
                                                                    if (_e3325 < 0.9f) {
                                                                        phi_8901_ = _e3325;
                                                                    } else {
                                                                        phi_8901_ = 0.9f;
                                                                    }
                                                                    let _e3329 = phi_8901_;
                                                                    phi_8902_ = _e3329;
                                                                } else {
                                                                    phi_8902_ = 0.0625f;
                                                                }
                                                                let _e3331 = phi_8902_;
                                                                phi_8903_ = _e3331;
                                                            }
                                                            let _e3333 = phi_8903_;
                                                            phi_8905_ = u32();
                                                            phi_8906_ = (_e2661 * _e3333);
                                                            phi_8907_ = true;
                                                            phi_8908_ = false;
                                                            phi_8909_ = false;
                                                        }
                                                        let _e3340 = phi_8905_;
                                                        let _e3342 = phi_8906_;
                                                        let _e3344 = phi_8907_;
                                                        let _e3346 = phi_8908_;
                                                        let _e3348 = phi_8909_;
                                                        phi_8910_ = _e3340;
                                                        phi_8911_ = _e2341;
                                                        phi_8912_ = _e3342;
                                                        phi_8913_ = _e2343;
                                                        phi_8914_ = _e2345;
                                                        phi_8915_ = _e2347;
                                                        phi_8916_ = _e2349;
                                                        phi_8917_ = _e3344;
                                                        phi_8918_ = _e3346;
                                                        phi_8919_ = _e3348;
                                                        phi_8920_ = false;
                                                        phi_8922_ = false;
                                                    } else {
                                                        phi_8910_ = u32();
                                                        phi_8911_ = _e3162;
                                                        phi_8912_ = _e3164;
                                                        phi_8913_ = _e3166;
                                                        phi_8914_ = _e2339;
                                                        phi_8915_ = true;
                                                        phi_8916_ = 0u;
                                                        phi_8917_ = _e3170;
                                                        phi_8918_ = false;
                                                        phi_8919_ = false;
                                                        phi_8920_ = _e3172;
                                                        phi_8922_ = _e3174;
                                                    }
                                                    let _e3350 = phi_8910_;
                                                    let _e3352 = phi_8911_;
                                                    let _e3354 = phi_8912_;
                                                    let _e3356 = phi_8913_;
                                                    let _e3358 = phi_8914_;
                                                    let _e3360 = phi_8915_;
                                                    let _e3362 = phi_8916_;
                                                    let _e3364 = phi_8917_;
                                                    let _e3366 = phi_8918_;
                                                    let _e3368 = phi_8919_;
                                                    let _e3370 = phi_8920_;
                                                    let _e3372 = phi_8922_;
                                                    if _e3364 {
                                                        let _e3373 = (_e3358 + _e3354);
                                                        if (_e3373 > _e3352) {
                                                            phi_8931_ = _e3373;
                                                        } else {
                                                            phi_8931_ = _e3352;
                                                        }
                                                        let _e3376 = phi_8931_;
                                                        if (_e3376 < _e1393.member_1) {
                                                            phi_8936_ = _e3376;
                                                        } else {
                                                            phi_8936_ = _e1393.member_1;
                                                        }
                                                        let _e3379 = phi_8936_;
                                                        if !(_e2347) {
                                                            phi_8945_ = true;
                                                        } else {
                                                            phi_8945_ = ((_e3379 - _e3358) > 0.0000000037252903f);
                                                        }
                                                        let _e3383 = phi_8945_;
                                                        if _e3383 {
                                                            phi_8949_ = false;
                                                        } else {
                                                            phi_8949_ = true;
                                                        }
                                                        let _e3385 = phi_8949_;
                                                        phi_8950_ = _e3379;
                                                        phi_8951_ = _e3352;
                                                        phi_8952_ = _e3356;
                                                        phi_8953_ = _e3358;
                                                        phi_8954_ = _e3360;
                                                        phi_8955_ = _e3362;
                                                        phi_8956_ = _e3383;
                                                        phi_8957_ = _e3385;
                                                        phi_8958_ = false;
                                                        phi_8959_ = false;
                                                        phi_8961_ = false;
                                                    } else {
                                                        phi_8950_ = _e2339;
                                                        phi_8951_ = _e2341;
                                                        phi_8952_ = _e2343;
                                                        phi_8953_ = _e2345;
                                                        phi_8954_ = _e2347;
                                                        phi_8955_ = _e3350;
                                                        phi_8956_ = _e3366;
                                                        phi_8957_ = false;
                                                        phi_8958_ = _e3368;
                                                        phi_8959_ = _e3370;
                                                        phi_8961_ = _e3372;
                                                    }
                                                    let _e3387 = phi_8950_;
                                                    let _e3389 = phi_8951_;
                                                    let _e3391 = phi_8952_;
                                                    let _e3393 = phi_8953_;
                                                    let _e3395 = phi_8954_;
                                                    let _e3397 = phi_8955_;
                                                    let _e3399 = phi_8956_;
                                                    let _e3401 = phi_8957_;
                                                    let _e3403 = phi_8958_;
                                                    let _e3405 = phi_8959_;
                                                    let _e3407 = phi_8961_;
                                                    phi_6784_ = _e3387;
                                                    phi_6786_ = _e3389;
                                                    phi_6788_ = _e3391;
                                                    phi_6790_ = _e3393;
                                                    phi_6792_ = _e3395;
                                                    phi_6794_ = _e3397;
                                                    phi_8962_ = _e3352;
                                                    phi_8964_ = _e3399;
                                                    phi_8965_ = _e3401;
                                                    phi_8966_ = _e3403;
                                                    phi_8967_ = _e3405;
                                                    phi_8969_ = false;
                                                    phi_8970_ = _e3407;
                                                } else {
                                                    phi_6784_ = f32();
                                                    phi_6786_ = f32();
                                                    phi_6788_ = f32();
                                                    phi_6790_ = f32();
                                                    phi_6792_ = bool();
                                                    phi_6794_ = u32();
                                                    phi_8962_ = f32();
                                                    phi_8964_ = false;
                                                    phi_8965_ = false;
                                                    phi_8966_ = false;
                                                    phi_8967_ = false;
                                                    phi_8969_ = true;
                                                    phi_8970_ = false;
                                                }
                                                let _e3409 = phi_6784_;
                                                let _e3411 = phi_6786_;
                                                let _e3413 = phi_6788_;
                                                let _e3415 = phi_6790_;
                                                let _e3417 = phi_6792_;
                                                let _e3419 = phi_6794_;
                                                let _e3421 = phi_8962_;
                                                let _e3423 = phi_8964_;
                                                let _e3425 = phi_8965_;
                                                let _e3427 = phi_8966_;
                                                let _e3429 = phi_8967_;
                                                let _e3431 = phi_8969_;
                                                let _e3433 = phi_8970_;
                                                local_19 = _e3425;
                                                local_36 = _e3427;
                                                local_37 = _e3429;
                                                local_38 = _e3431;
                                                local_39 = _e3433;
                                                local_40 = _e3425;
                                                local_41 = _e3421;
                                                continue;
                                                continuing {
                                                    phi_6780_ = _e2361;
                                                    phi_6783_ = _e3409;
                                                    phi_6785_ = _e3411;
                                                    phi_6787_ = _e3413;
                                                    phi_6789_ = _e3415;
                                                    phi_6791_ = _e3417;
                                                    phi_6793_ = _e3419;
                                                    break if !(_e3423);
                                                }
                                            }
                                            let _e3436 = local_19;
                                            if _e3436 {
                                                phi_8974_ = false;
                                                phi_8975_ = false;
                                                phi_8977_ = false;
                                                phi_8978_ = false;
                                            } else {
                                                let _e6354 = local_36;
                                                phi_8974_ = _e6354;
                                                let _e6357 = local_37;
                                                phi_8975_ = _e6357;
                                                let _e6360 = local_38;
                                                phi_8977_ = _e6360;
                                                let _e6363 = local_39;
                                                phi_8978_ = _e6363;
                                            }
                                            let _e3438 = phi_8974_;
                                            let _e3440 = phi_8975_;
                                            let _e3442 = phi_8977_;
                                            let _e3444 = phi_8978_;
                                            if _e3438 {
                                                let _e3446 = local_20;
                                                phi_8983_ = type_30(1u, _e3446);
                                                phi_8984_ = false;
                                                phi_8986_ = false;
                                                phi_8987_ = false;
                                                phi_8988_ = false;
                                            } else {
                                                phi_8983_ = type_30();
                                                phi_8984_ = _e3440;
                                                let _e6369 = local_40;
                                                phi_8986_ = _e6369;
                                                phi_8987_ = _e3442;
                                                phi_8988_ = _e3444;
                                            }
                                            let _e3449 = phi_8983_;
                                            let _e3451 = phi_8984_;
                                            let _e3453 = phi_8986_;
                                            let _e3455 = phi_8987_;
                                            let _e3457 = phi_8988_;
                                            if _e3451 {
                                                phi_8993_ = type_30(0u, type_30().member_1);
                                                phi_8995_ = false;
                                                phi_8996_ = false;
                                                phi_8997_ = false;
                                                phi_8998_ = true;
                                            } else {
                                                phi_8993_ = _e3449;
                                                phi_8995_ = _e3453;
                                                phi_8996_ = _e3455;
                                                phi_8997_ = _e3457;
                                                phi_8998_ = _e3438;
                                            }
                                            let _e3461 = phi_8993_;
                                            let _e3463 = phi_8995_;
                                            let _e3465 = phi_8996_;
                                            let _e3467 = phi_8997_;
                                            let _e3469 = phi_8998_;
                                            if _e3463 {
                                                let _e6379 = local_41;
                                                phi_9010_ = _e6379;
                                                phi_9011_ = true;
                                                phi_9012_ = false;
                                                phi_9013_ = false;
                                            } else {
                                                let _e6381 = local_42;
                                                phi_9010_ = _e6381;
                                                phi_9011_ = _e3465;
                                                phi_9012_ = _e3467;
                                                phi_9013_ = _e3469;
                                            }
                                            let _e3471 = phi_9010_;
                                            let _e3473 = phi_9011_;
                                            let _e3475 = phi_9012_;
                                            let _e3477 = phi_9013_;
                                            if _e3473 {
                                                phi_9018_ = type_30(1u, _e3471);
                                                phi_9019_ = false;
                                                phi_9020_ = false;
                                            } else {
                                                phi_9018_ = type_30();
                                                phi_9019_ = _e3475;
                                                phi_9020_ = _e3477;
                                            }
                                            let _e3480 = phi_9018_;
                                            let _e3482 = phi_9019_;
                                            let _e3484 = phi_9020_;
                                            if _e3482 {
                                                phi_9025_ = type_30(0u, type_30().member_1);
                                                phi_9026_ = true;
                                            } else {
                                                phi_9025_ = _e3461;
                                                phi_9026_ = _e3484;
                                            }
                                            let _e3488 = phi_9025_;
                                            let _e3490 = phi_9026_;
                                            if _e3490 {
                                                phi_9030_ = _e3488;
                                            } else {
                                                phi_9030_ = _e3480;
                                            }
                                            let _e3492 = phi_9030_;
                                            let _e3495 = (_e3492.member != 0u);
                                            if _e3495 {
                                                phi_9037_ = false;
                                            } else {
                                                phi_9037_ = true;
                                            }
                                            let _e3497 = phi_9037_;
                                            phi_9038_ = _e3492.member_1;
                                            phi_9039_ = _e3497;
                                            phi_9040_ = _e3495;
                                            phi_9041_ = false;
                                        } else {
                                            phi_9038_ = f32();
                                            phi_9039_ = false;
                                            phi_9040_ = false;
                                            phi_9041_ = true;
                                        }
                                        let _e3499 = phi_9038_;
                                        let _e3501 = phi_9039_;
                                        let _e3503 = phi_9040_;
                                        let _e3505 = phi_9041_;
                                        phi_9042_ = _e3499;
                                        phi_9043_ = _e3501;
                                        phi_9044_ = _e3503;
                                        phi_9045_ = _e3505;
                                    }
                                    let _e3507 = phi_9042_;
                                    let _e3509 = phi_9043_;
                                    let _e3511 = phi_9044_;
                                    let _e3513 = phi_9045_;
                                    phi_9046_ = _e3507;
                                    phi_9047_ = _e2094;
                                    phi_9048_ = _e3509;
                                    phi_9049_ = _e3511;
                                    phi_9050_ = _e3513;
                                }
                                let _e3515 = phi_9046_;
                                let _e3517 = phi_9047_;
                                let _e3519 = phi_9048_;
                                let _e3521 = phi_9049_;
                                let _e3523 = phi_9050_;
                                if _e3517 {
                                    phi_9054_ = true;
                                    phi_9055_ = false;
                                    phi_9056_ = false;
                                } else {
                                    phi_9054_ = _e3519;
                                    phi_9055_ = _e3521;
                                    phi_9056_ = _e3523;
                                }
                                let _e3525 = phi_9054_;
                                let _e3527 = phi_9055_;
                                let _e3529 = phi_9056_;
                                phi_9057_ = _e3515;
                                phi_9058_ = _e1393;
                                phi_9059_ = _e3525;
                                phi_9060_ = false;
                                phi_9061_ = _e3527;
                                phi_9062_ = _e3529;
                            } else {
                                phi_9057_ = f32();
                                phi_9058_ = type_37();
                                phi_9059_ = false;
                                phi_9060_ = true;
                                phi_9061_ = false;
                                phi_9062_ = false;
                            }
                            let _e3531 = phi_9057_;
                            let _e3533 = phi_9058_;
                            let _e3535 = phi_9059_;
                            let _e3537 = phi_9060_;
                            let _e3539 = phi_9061_;
                            let _e3541 = phi_9062_;
                            local_21 = _e3537;
                            local_43 = _e3539;
                            local_44 = _e3541;
                            local_22 = _e3531;
                            local_23 = _e3533;
                            continue;
                            continuing {
                                phi_4904_ = _e1123;
                                break if !(_e3535);
                            }
                        }
                        let _e3544 = local_21;
                        if _e3544 {
                            phi_9067_ = type_30(0u, type_30().member_1);
                            phi_9068_ = false;
                            phi_9069_ = false;
                        } else {
                            phi_9067_ = type_30();
                            let _e6418 = local_43;
                            phi_9068_ = _e6418;
                            let _e6421 = local_44;
                            phi_9069_ = _e6421;
                        }
                        let _e3548 = phi_9067_;
                        let _e3550 = phi_9068_;
                        let _e3552 = phi_9069_;
                        if _e3550 {
                            let _e3554 = local_22;
                            phi_9074_ = type_30(2u, _e3554);
                            phi_9075_ = false;
                        } else {
                            phi_9074_ = type_30();
                            phi_9075_ = _e3552;
                        }
                        let _e3557 = phi_9074_;
                        let _e3559 = phi_9075_;
                        if _e3559 {
                            let _e3561 = local_23;
                            phi_9081_ = type_30(1u, _e3561.member);
                            phi_9082_ = true;
                        } else {
                            phi_9081_ = _e3557;
                            phi_9082_ = _e3550;
                        }
                        let _e3565 = phi_9081_;
                        let _e3567 = phi_9082_;
                        if _e3567 {
                            phi_9086_ = _e3565;
                        } else {
                            phi_9086_ = _e3548;
                        }
                        let _e3569 = phi_9086_;
                        phi_9090_ = _e3569;
                    }
                    let _e5692 = phi_9090_;
                    phi_9091_ = _e5692;
                }
                let _e5696 = phi_9091_;
                switch bitcast<i32>(_e5696.member) {
                    case 0: {
                        phi_9104_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5702 = function_(_e5696.member_1);
                        phi_9104_ = type_38(0u, _e5702, true);
                        break;
                    }
                    case 2: {
                        let _e5700 = function_(_e5696.member_1);
                        phi_9104_ = type_38(1u, _e5700, true);
                        break;
                    }
                    default: {
                        phi_9104_ = type_38();
                        break;
                    }
                }
                let _e5705 = phi_9104_;
                if _e5705.member_2 {
                    phi_9111_ = (_e5705.member == 0u);
                } else {
                    phi_9111_ = false;
                }
                let _e5710 = phi_9111_;
                if _e5710 {
                    let _e5718 = (_e5705.member_1[1] >> bitcast<u32>(20i));
                    if (_e5718 <= 896u) {
                        phi_9135_ = 0u;
                    } else {
                        phi_9135_ = ((((_e5718 - 896u) << bitcast<u32>(23i)) | ((_e5705.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5705.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5733 = phi_9135_;
                    let _e5735 = atomicMin((&earliest.member[0u]), _e5733);
                }
                phi_9139_ = type_20(1u, 0u, _e176, _e179, _e5705.member_1);
                phi_9140_ = _e5710;
                phi_9141_ = (_e5705.member != 0u);
            } else {
                phi_9139_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_9140_ = false;
                phi_9141_ = false;
            }
            let _e5737 = phi_9139_;
            let _e5739 = phi_9140_;
            let _e5741 = phi_9141_;
            let _e5744 = params.member.member.member_1;
            if ((_e5744 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5739 {
                    let _e5750 = atomicAdd((&counters[0u]), 1u);
                    phi_9160_ = _e5750;
                } else {
                    phi_9160_ = 0u;
                }
                let _e5752 = phi_9160_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5755 = atomicLoad((&counters[0u]));
                    if (_e5755 > 0u) {
                        let _e5758 = atomicAdd((&contacts.member[0u]), _e5755);
                        atomicStore((&counters[1u]), _e5758);
                    }
                }
                workgroupBarrier();
                let _e5761 = atomicLoad((&counters[1u]));
                let _e5762 = (_e5761 + _e5752);
                if _e5739 {
                    let _e5765 = params.member.member_1.member_3;
                    if (_e5762 < _e5765) {
                        let _e5767 = (6u * _e5762);
                        atomicStore((&contacts.member[(4u + _e5767)]), _e5737.member);
                        atomicStore((&contacts.member[(_e5767 + 5u)]), _e5737.member_1);
                        atomicStore((&contacts.member[(_e5767 + 6u)]), _e5737.member_2);
                        atomicStore((&contacts.member[(_e5767 + 7u)]), _e5737.member_3);
                        atomicStore((&contacts.member[(_e5767 + 8u)]), _e5737.member_4[0]);
                        atomicStore((&contacts.member[(_e5767 + 9u)]), _e5737.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5741 {
                let _e5791 = atomicAdd((&counters[0u]), 1u);
                phi_9223_ = _e5791;
            } else {
                phi_9223_ = 0u;
            }
            let _e5793 = phi_9223_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5796 = atomicLoad((&counters[0u]));
                if (_e5796 > 0u) {
                    let _e5799 = atomicAdd((&undecided.member[0u]), _e5796);
                    atomicStore((&counters[1u]), _e5799);
                }
            }
            workgroupBarrier();
            let _e5802 = atomicLoad((&counters[1u]));
            let _e5803 = (_e5802 + _e5793);
            if _e5741 {
                let _e5806 = params.member.member_2.member;
                if (_e5803 < _e5806) {
                    let _e5810 = (2u * _e5803);
                    atomicStore((&undecided.member[(4u + _e5810)]), _e5737.member_2);
                    atomicStore((&undecided.member[(_e5810 + 5u)]), _e5737.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_264_ = _e161;
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
