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

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_24 {
    member: array<array<u32, 2>>,
}

struct type_26 {
    member: u32,
}

struct type_27 {
    member: type_7,
    member_1: type_8,
    member_2: type_26,
}

struct type_28 {
    member: type_27,
}

struct type_31 {
    member: array<array<f64, 3>>,
}

struct type_32 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_34 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_35 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_36 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_42 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_43 {
    member: type_40,
    member_1: f64,
}

struct type_44 {
    member: u32,
    member_1: f64,
}

struct type_45 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_49 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_28;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_49;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_49;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_10131_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_10131_ = param_2;
    } else {
        phi_10131_ = param_1;
    }
    let _e26 = phi_10131_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_9695_: bool;
    var phi_9696_: bool;
    var phi_9697_: bool;
    var phi_9698_: bool;
    var phi_9702_: bool;
    var phi_9675_: bool;
    var phi_9676_: bool;
    var phi_9677_: bool;
    var phi_9678_: bool;
    var phi_9679_: bool;
    var phi_9680_: bool;
    var phi_9684_: bool;
    var phi_9703_: bool;
    var phi_9733_: array<f64, 3>;
    var phi_9734_: bool;
    var phi_9735_: array<f64, 3>;
    var phi_9736_: bool;
    var phi_9982_: f64;
    var phi_9984_: f64;
    var phi_10026_: f64;
    var phi_10028_: f64;
    var phi_10076_: f64;
    var phi_10078_: f64;
    var phi_9787_: f64;
    var phi_9789_: f64;
    var phi_9837_: f64;
    var phi_9839_: f64;
    var phi_9884_: f64;
    var phi_9886_: f64;
    var phi_9937_: f64;
    var phi_9939_: f64;
    var phi_10093_: array<array<f64, 3>, 4>;
    var phi_10101_: array<f64, 3>;

    let _e21 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e32 = (((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2]));
    let _e43 = (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2]));
    let _e54 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e65 = (((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e69 = f64(0f);
    let _e70 = f64(1f);
    let _e74 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e78 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_6 != 0u) {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                if (_e74 <= _e70) {
                    phi_9675_ = (_e78 <= _e70);
                    phi_9676_ = false;
                } else {
                    phi_9675_ = bool();
                    phi_9676_ = true;
                }
                let _e99 = phi_9675_;
                let _e101 = phi_9676_;
                phi_9677_ = _e99;
                phi_9678_ = _e101;
            } else {
                phi_9677_ = bool();
                phi_9678_ = true;
            }
            let _e103 = phi_9677_;
            let _e105 = phi_9678_;
            phi_9679_ = _e103;
            phi_9680_ = _e105;
        } else {
            phi_9679_ = bool();
            phi_9680_ = true;
        }
        let _e107 = phi_9679_;
        let _e109 = phi_9680_;
        if _e109 {
            phi_9684_ = false;
        } else {
            phi_9684_ = _e107;
        }
        let _e111 = phi_9684_;
        phi_9703_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_9695_ = ((_e74 + _e78) <= _e70);
                phi_9696_ = false;
            } else {
                phi_9695_ = bool();
                phi_9696_ = true;
            }
            let _e85 = phi_9695_;
            let _e87 = phi_9696_;
            phi_9697_ = _e85;
            phi_9698_ = _e87;
        } else {
            phi_9697_ = bool();
            phi_9698_ = true;
        }
        let _e89 = phi_9697_;
        let _e91 = phi_9698_;
        if _e91 {
            phi_9702_ = false;
        } else {
            phi_9702_ = _e89;
        }
        let _e93 = phi_9702_;
        phi_9703_ = _e93;
    }
    let _e113 = phi_9703_;
    if (_e68 > _e69) {
        if _e113 {
            phi_9733_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_9734_ = false;
        } else {
            phi_9733_ = array<f64, 3>();
            phi_9734_ = true;
        }
        let _e138 = phi_9733_;
        let _e140 = phi_9734_;
        phi_9735_ = _e138;
        phi_9736_ = _e140;
    } else {
        phi_9735_ = array<f64, 3>();
        phi_9736_ = true;
    }
    let _e142 = phi_9735_;
    let _e144 = phi_9736_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_9787_ = _e307;
                } else {
                    phi_9787_ = f64(1f);
                }
                let _e315 = phi_9787_;
                phi_9789_ = _e315;
            } else {
                phi_9789_ = f64(0f);
            }
            let _e317 = phi_9789_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_9837_ = _e353;
                } else {
                    phi_9837_ = f64(1f);
                }
                let _e361 = phi_9837_;
                phi_9839_ = _e361;
            } else {
                phi_9839_ = f64(0f);
            }
            let _e363 = phi_9839_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_9884_ = _e396;
                } else {
                    phi_9884_ = f64(1f);
                }
                let _e404 = phi_9884_;
                phi_9886_ = _e404;
            } else {
                phi_9886_ = f64(0f);
            }
            let _e406 = phi_9886_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_9937_ = _e445;
                } else {
                    phi_9937_ = f64(1f);
                }
                let _e453 = phi_9937_;
                phi_9939_ = _e453;
            } else {
                phi_9939_ = f64(0f);
            }
            let _e455 = phi_9939_;
            phi_10093_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_9982_ = _e174;
                } else {
                    phi_9982_ = f64(1f);
                }
                let _e182 = phi_9982_;
                phi_9984_ = _e182;
            } else {
                phi_9984_ = f64(0f);
            }
            let _e184 = phi_9984_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_10026_ = _e214;
                } else {
                    phi_10026_ = f64(1f);
                }
                let _e222 = phi_10026_;
                phi_10028_ = _e222;
            } else {
                phi_10028_ = f64(0f);
            }
            let _e224 = phi_10028_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_10076_ = _e260;
                } else {
                    phi_10076_ = f64(1f);
                }
                let _e268 = phi_10076_;
                phi_10078_ = _e268;
            } else {
                phi_10078_ = f64(0f);
            }
            let _e270 = phi_10078_;
            phi_10093_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_10093_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_10101_ = _e475;
    } else {
        phi_10101_ = _e142;
    }
    let _e477 = phi_10101_;
    return _e477;
}

fn function_3(param_7: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_7[0]), f64(param_7[1]), f64(param_7[2]));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_34;
    var local_1: type_34;
    var local_2: type_35;
    var local_3: type_35;
    var local_4: type_35;
    var local_5: array<type_36, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: type_34;
    var local_10: type_34;
    var local_11: array<f32, 3>;
    var local_12: type_40;
    var phi_241_: u32;
    var phi_257_: u32;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_282_: type_12;
    var phi_283_: type_12;
    var phi_306_: type_12;
    var phi_564_: type_42;
    var phi_658_: f64;
    var phi_664_: f64;
    var phi_669_: f64;
    var phi_675_: f64;
    var phi_680_: f64;
    var phi_686_: f64;
    var phi_692_: f64;
    var phi_697_: f64;
    var phi_703_: f64;
    var phi_708_: f64;
    var phi_713_: f64;
    var phi_720_: f64;
    var phi_726_: f64;
    var phi_731_: f64;
    var phi_737_: f64;
    var phi_742_: f64;
    var phi_748_: f64;
    var phi_754_: f64;
    var phi_759_: f64;
    var phi_765_: f64;
    var phi_770_: f64;
    var phi_775_: f64;
    var phi_782_: f64;
    var phi_788_: f64;
    var phi_793_: f64;
    var phi_799_: f64;
    var phi_804_: f64;
    var phi_810_: f64;
    var phi_816_: f64;
    var phi_821_: f64;
    var phi_827_: f64;
    var phi_832_: f64;
    var phi_837_: f64;
    var phi_843_: f64;
    var phi_848_: f64;
    var phi_857_: bool;
    var phi_881_: u64;
    var phi_893_: f64;
    var phi_894_: f64;
    var phi_925_: type_43;
    var phi_926_: bool;
    var phi_927_: type_43;
    var phi_928_: bool;
    var phi_929_: type_43;
    var phi_930_: bool;
    var phi_935_: type_43;
    var phi_1217_: f64;
    var phi_1224_: f64;
    var phi_1229_: f64;
    var phi_1236_: f64;
    var phi_1241_: f64;
    var phi_1254_: f64;
    var phi_1261_: f64;
    var phi_1266_: f64;
    var phi_1273_: f64;
    var phi_1278_: f64;
    var phi_1283_: f64;
    var phi_1300_: f64;
    var phi_1307_: f64;
    var phi_1312_: f64;
    var phi_1319_: f64;
    var phi_1324_: f64;
    var phi_1338_: f64;
    var phi_1345_: f64;
    var phi_1350_: f64;
    var phi_1357_: f64;
    var phi_1362_: f64;
    var phi_1367_: f64;
    var phi_1384_: f64;
    var phi_1391_: f64;
    var phi_1396_: f64;
    var phi_1403_: f64;
    var phi_1408_: f64;
    var phi_1422_: f64;
    var phi_1429_: f64;
    var phi_1434_: f64;
    var phi_1441_: f64;
    var phi_1446_: f64;
    var phi_1451_: f64;
    var phi_1488_: f64;
    var phi_1494_: f64;
    var phi_1501_: f64;
    var phi_1508_: f64;
    var phi_1514_: f64;
    var phi_1521_: f64;
    var phi_1527_: f64;
    var phi_1533_: f64;
    var phi_1539_: f64;
    var phi_1546_: f64;
    var phi_1553_: f64;
    var phi_1581_: f64;
    var phi_1586_: f64;
    var phi_1591_: f64;
    var phi_1596_: f64;
    var phi_1601_: f64;
    var phi_1606_: f64;
    var phi_1617_: f64;
    var phi_4902_: f64;
    var phi_4908_: f64;
    var phi_4913_: f64;
    var phi_4919_: f64;
    var phi_4925_: f64;
    var phi_4930_: f64;
    var phi_4935_: f64;
    var phi_4945_: bool;
    var phi_4952_: f64;
    var phi_4960_: f64;
    var phi_5003_: type_16;
    var phi_5006_: f64;
    var phi_5027_: bool;
    var phi_5033_: type_17;
    var phi_5004_: type_16;
    var phi_5047_: type_17;
    var phi_5007_: f64;
    var local_13: f64;
    var phi_4996_: f64;
    var phi_5060_: f64;
    var phi_5066_: f64;
    var phi_5091_: type_12;
    var phi_5094_: u32;
    var phi_5092_: type_12;
    var phi_5117_: type_12;
    var phi_5161_: u32;
    var phi_5162_: u32;
    var phi_5095_: u32;
    var phi_5163_: u32;
    var phi_5183_: type_12;
    var phi_5184_: type_12;
    var phi_5207_: type_12;
    var phi_5261_: f64;
    var phi_5268_: f64;
    var phi_5280_: bool;
    var phi_5281_: bool;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5287_: bool;
    var phi_5299_: type_45;
    var phi_5300_: type_45;
    var phi_5301_: bool;
    var phi_5302_: type_45;
    var phi_5303_: bool;
    var phi_5316_: f64;
    var phi_5329_: type_12;
    var phi_5332_: f64;
    var phi_5334_: f64;
    var phi_5336_: f64;
    var phi_5330_: type_12;
    var phi_5359_: type_12;
    var phi_5386_: f64;
    var phi_5387_: f64;
    var phi_5415_: f64;
    var phi_5431_: f64;
    var phi_5438_: bool;
    var phi_5439_: bool;
    var phi_5440_: bool;
    var phi_5446_: f64;
    var phi_5447_: f64;
    var phi_5448_: bool;
    var phi_5333_: f64;
    var phi_5335_: f64;
    var phi_5337_: f64;
    var phi_5449_: f64;
    var phi_5450_: bool;
    var phi_5451_: bool;
    var local_14: bool;
    var phi_5455_: f64;
    var phi_5456_: f64;
    var phi_5466_: f64;
    var phi_5471_: type_12;
    var phi_5474_: f64;
    var phi_5472_: type_12;
    var phi_5497_: type_12;
    var phi_5528_: f64;
    var phi_5529_: bool;
    var phi_5530_: f64;
    var phi_5531_: bool;
    var phi_5532_: bool;
    var phi_5533_: bool;
    var phi_5534_: f64;
    var phi_5475_: f64;
    var phi_5535_: bool;
    var phi_5536_: bool;
    var phi_5537_: bool;
    var phi_5538_: bool;
    var local_15: bool;
    var phi_5542_: bool;
    var phi_5543_: bool;
    var phi_5547_: bool;
    var phi_5551_: f64;
    var phi_5552_: f64;
    var phi_5554_: type_45;
    var phi_5585_: f64;
    var phi_5592_: f64;
    var phi_5597_: f64;
    var phi_5604_: f64;
    var phi_5609_: f64;
    var phi_5622_: f64;
    var phi_5629_: f64;
    var phi_5634_: f64;
    var phi_5641_: f64;
    var phi_5646_: f64;
    var phi_5651_: f64;
    var phi_5710_: f64;
    var phi_5716_: f64;
    var phi_5721_: f64;
    var phi_5727_: f64;
    var phi_5732_: f64;
    var phi_5746_: f64;
    var phi_5752_: f64;
    var phi_5757_: f64;
    var phi_5763_: f64;
    var phi_5768_: f64;
    var phi_5794_: f64;
    var phi_5801_: f64;
    var phi_5806_: f64;
    var phi_5813_: f64;
    var phi_5818_: f64;
    var phi_5831_: f64;
    var phi_5838_: f64;
    var phi_5843_: f64;
    var phi_5850_: f64;
    var phi_5855_: f64;
    var phi_5860_: f64;
    var phi_5919_: f64;
    var phi_5925_: f64;
    var phi_5930_: f64;
    var phi_5936_: f64;
    var phi_5941_: f64;
    var phi_5955_: f64;
    var phi_5961_: f64;
    var phi_5966_: f64;
    var phi_5972_: f64;
    var phi_5977_: f64;
    var phi_6003_: f64;
    var phi_6010_: f64;
    var phi_6015_: f64;
    var phi_6022_: f64;
    var phi_6027_: f64;
    var phi_6040_: f64;
    var phi_6047_: f64;
    var phi_6052_: f64;
    var phi_6059_: f64;
    var phi_6064_: f64;
    var phi_6069_: f64;
    var phi_6128_: f64;
    var phi_6134_: f64;
    var phi_6139_: f64;
    var phi_6145_: f64;
    var phi_6150_: f64;
    var phi_6164_: f64;
    var phi_6170_: f64;
    var phi_6175_: f64;
    var phi_6181_: f64;
    var phi_6186_: f64;
    var phi_6235_: f64;
    var phi_6241_: f64;
    var phi_6269_: f64;
    var phi_6275_: f64;
    var phi_6280_: u32;
    var phi_6281_: u32;
    var phi_6251_: f64;
    var phi_6257_: f64;
    var phi_6262_: u32;
    var phi_6263_: u32;
    var phi_6282_: u32;
    var phi_6283_: u32;
    var phi_6356_: f64;
    var phi_6368_: f64;
    var phi_6511_: f64;
    var phi_6517_: f64;
    var phi_6524_: f64;
    var phi_6580_: type_12;
    var phi_6583_: bool;
    var phi_6581_: type_12;
    var phi_6606_: type_12;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var phi_6584_: bool;
    var phi_6635_: bool;
    var phi_6636_: bool;
    var local_16: bool;
    var phi_6640_: bool;
    var local_17: bool;
    var phi_6647_: u32;
    var phi_6648_: u32;
    var phi_6649_: bool;
    var phi_6650_: u32;
    var phi_6651_: u32;
    var phi_6652_: bool;
    var phi_6656_: u32;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6828_: f64;
    var phi_6835_: f64;
    var phi_6840_: f64;
    var phi_6847_: f64;
    var phi_6852_: f64;
    var phi_6865_: f64;
    var phi_6872_: f64;
    var phi_6877_: f64;
    var phi_6884_: f64;
    var phi_6889_: f64;
    var phi_6894_: f64;
    var phi_6911_: f64;
    var phi_6918_: f64;
    var phi_6923_: f64;
    var phi_6930_: f64;
    var phi_6935_: f64;
    var phi_6949_: f64;
    var phi_6956_: f64;
    var phi_6961_: f64;
    var phi_6968_: f64;
    var phi_6973_: f64;
    var phi_6978_: f64;
    var phi_6995_: f64;
    var phi_7002_: f64;
    var phi_7007_: f64;
    var phi_7014_: f64;
    var phi_7019_: f64;
    var phi_7033_: f64;
    var phi_7040_: f64;
    var phi_7045_: f64;
    var phi_7052_: f64;
    var phi_7057_: f64;
    var phi_7062_: f64;
    var phi_7107_: type_12;
    var phi_7110_: f64;
    var phi_7112_: f64;
    var phi_7114_: f64;
    var phi_7116_: f64;
    var phi_7118_: bool;
    var phi_7120_: u32;
    var phi_7108_: type_12;
    var phi_7143_: type_12;
    var phi_7258_: f64;
    var phi_7264_: f64;
    var phi_7270_: f64;
    var phi_7272_: array<f64, 3>;
    var phi_7279_: f64;
    var phi_7286_: f64;
    var phi_7294_: f64;
    var phi_7340_: type_16;
    var phi_7343_: f64;
    var phi_7364_: bool;
    var phi_7370_: type_17;
    var phi_7341_: type_16;
    var phi_7384_: type_17;
    var phi_7344_: f64;
    var local_18: f64;
    var phi_7333_: f64;
    var phi_7397_: f64;
    var phi_7466_: f64;
    var phi_7472_: f64;
    var phi_7481_: f64;
    var phi_7487_: f64;
    var phi_7496_: f64;
    var phi_7502_: f64;
    var phi_7511_: f64;
    var phi_7517_: f64;
    var phi_7523_: type_34;
    var phi_7524_: bool;
    var phi_7525_: type_34;
    var phi_7526_: bool;
    var phi_7536_: type_34;
    var phi_7708_: bool;
    var phi_7709_: bool;
    var phi_7710_: bool;
    var phi_7711_: bool;
    var phi_7712_: bool;
    var phi_7713_: bool;
    var phi_7717_: bool;
    var phi_8015_: bool;
    var phi_8016_: bool;
    var phi_8017_: bool;
    var phi_8018_: bool;
    var phi_8019_: bool;
    var phi_8020_: bool;
    var phi_8024_: bool;
    var phi_8028_: bool;
    var phi_8039_: bool;
    var phi_8040_: bool;
    var phi_8114_: bool;
    var phi_8115_: bool;
    var phi_8138_: f64;
    var phi_8139_: bool;
    var phi_8140_: f64;
    var phi_8141_: bool;
    var phi_8142_: f64;
    var phi_8143_: bool;
    var phi_8144_: bool;
    var phi_8149_: f64;
    var phi_8150_: bool;
    var phi_8154_: f64;
    var phi_8186_: bool;
    var phi_8187_: bool;
    var phi_8210_: f64;
    var phi_8211_: bool;
    var phi_8212_: f64;
    var phi_8213_: bool;
    var phi_8214_: f64;
    var phi_8215_: bool;
    var phi_8216_: bool;
    var phi_8221_: f64;
    var phi_8222_: bool;
    var phi_8226_: f64;
    var phi_8231_: f64;
    var phi_8263_: bool;
    var phi_8264_: bool;
    var phi_8287_: f64;
    var phi_8288_: bool;
    var phi_8289_: f64;
    var phi_8290_: bool;
    var phi_8291_: f64;
    var phi_8292_: bool;
    var phi_8293_: bool;
    var phi_8298_: f64;
    var phi_8299_: bool;
    var phi_8303_: f64;
    var phi_8335_: bool;
    var phi_8336_: bool;
    var phi_8359_: f64;
    var phi_8360_: bool;
    var phi_8361_: f64;
    var phi_8362_: bool;
    var phi_8363_: f64;
    var phi_8364_: bool;
    var phi_8365_: bool;
    var phi_8370_: f64;
    var phi_8371_: bool;
    var phi_8375_: f64;
    var phi_8380_: f64;
    var phi_8385_: f64;
    var phi_8390_: f64;
    var phi_8404_: f64;
    var phi_8542_: type_16;
    var phi_8545_: f64;
    var phi_8566_: bool;
    var phi_8572_: type_17;
    var phi_8543_: type_16;
    var phi_8586_: type_17;
    var phi_8546_: f64;
    var local_19: f64;
    var phi_8535_: f64;
    var phi_8599_: f64;
    var phi_8617_: f64;
    var phi_8624_: f64;
    var phi_8629_: f64;
    var phi_8636_: f64;
    var phi_8641_: f64;
    var phi_8654_: f64;
    var phi_8661_: f64;
    var phi_8666_: f64;
    var phi_8673_: f64;
    var phi_8678_: f64;
    var phi_8683_: f64;
    var phi_8700_: f64;
    var phi_8707_: f64;
    var phi_8712_: f64;
    var phi_8719_: f64;
    var phi_8724_: f64;
    var phi_8738_: f64;
    var phi_8745_: f64;
    var phi_8750_: f64;
    var phi_8757_: f64;
    var phi_8762_: f64;
    var phi_8767_: f64;
    var phi_8784_: f64;
    var phi_8791_: f64;
    var phi_8796_: f64;
    var phi_8803_: f64;
    var phi_8808_: f64;
    var phi_8822_: f64;
    var phi_8829_: f64;
    var phi_8834_: f64;
    var phi_8841_: f64;
    var phi_8846_: f64;
    var phi_8851_: f64;
    var phi_8875_: bool;
    var phi_8876_: bool;
    var phi_8877_: bool;
    var phi_8894_: f64;
    var phi_8895_: bool;
    var phi_8896_: f64;
    var phi_8897_: bool;
    var phi_8902_: f64;
    var phi_8904_: f64;
    var phi_8905_: f64;
    var phi_8906_: bool;
    var phi_8907_: f64;
    var phi_8908_: f64;
    var phi_8909_: bool;
    var phi_8910_: bool;
    var phi_8911_: f64;
    var phi_8912_: f64;
    var phi_8913_: f64;
    var phi_8914_: f64;
    var phi_8915_: bool;
    var phi_8916_: bool;
    var phi_8917_: bool;
    var phi_8918_: bool;
    var phi_8919_: f64;
    var phi_8920_: f64;
    var phi_8921_: f64;
    var phi_8922_: f64;
    var phi_8923_: bool;
    var phi_8924_: bool;
    var phi_8925_: bool;
    var phi_8926_: bool;
    var phi_8927_: bool;
    var phi_8928_: f64;
    var phi_8929_: f64;
    var phi_8930_: f64;
    var phi_8931_: f64;
    var phi_8932_: bool;
    var phi_8933_: bool;
    var phi_8934_: bool;
    var phi_8935_: bool;
    var phi_8936_: bool;
    var phi_9022_: f64;
    var phi_9095_: f64;
    var phi_9100_: f64;
    var phi_9173_: f64;
    var phi_9246_: f64;
    var phi_9251_: f64;
    var phi_9272_: f64;
    var phi_9273_: f64;
    var phi_9274_: f64;
    var phi_8949_: bool;
    var phi_9276_: u32;
    var phi_9277_: f64;
    var phi_9278_: bool;
    var phi_9279_: bool;
    var phi_9280_: bool;
    var phi_9281_: u32;
    var phi_9282_: f64;
    var phi_9283_: f64;
    var phi_9284_: f64;
    var phi_9285_: f64;
    var phi_9286_: bool;
    var phi_9287_: u32;
    var phi_9288_: bool;
    var phi_9289_: bool;
    var phi_9290_: bool;
    var phi_9291_: bool;
    var phi_9292_: bool;
    var phi_9293_: bool;
    var phi_9302_: f64;
    var phi_9307_: f64;
    var phi_9317_: bool;
    var phi_9321_: bool;
    var phi_9322_: f64;
    var phi_9323_: f64;
    var phi_9324_: f64;
    var phi_9325_: f64;
    var phi_9326_: bool;
    var phi_9327_: u32;
    var phi_9328_: bool;
    var phi_9329_: bool;
    var phi_9330_: bool;
    var phi_9331_: bool;
    var phi_9332_: bool;
    var phi_9333_: bool;
    var phi_7111_: f64;
    var phi_7113_: f64;
    var phi_7115_: f64;
    var phi_7117_: f64;
    var phi_7119_: bool;
    var phi_7121_: u32;
    var phi_9334_: f64;
    var phi_9335_: f64;
    var phi_9336_: bool;
    var phi_9337_: bool;
    var phi_9338_: bool;
    var phi_9339_: bool;
    var phi_9340_: bool;
    var phi_9341_: bool;
    var phi_9342_: bool;
    var local_20: bool;
    var phi_9346_: bool;
    var phi_9347_: bool;
    var phi_9348_: bool;
    var phi_9349_: bool;
    var phi_9350_: bool;
    var local_21: f64;
    var phi_9355_: type_44;
    var phi_9356_: bool;
    var phi_9357_: bool;
    var phi_9358_: bool;
    var phi_9359_: bool;
    var phi_9360_: bool;
    var phi_9365_: type_44;
    var phi_9366_: bool;
    var phi_9367_: bool;
    var phi_9368_: bool;
    var phi_9369_: bool;
    var phi_9370_: bool;
    var phi_9374_: f64;
    var phi_9375_: bool;
    var phi_9376_: bool;
    var phi_9377_: bool;
    var phi_9378_: bool;
    var phi_9382_: f64;
    var phi_9383_: bool;
    var phi_9384_: bool;
    var phi_9385_: bool;
    var phi_9390_: type_44;
    var phi_9391_: bool;
    var phi_9392_: bool;
    var phi_9397_: type_44;
    var phi_9398_: bool;
    var phi_9402_: type_44;
    var phi_9409_: bool;
    var phi_9410_: f64;
    var phi_9411_: bool;
    var phi_9412_: bool;
    var phi_9413_: bool;
    var phi_9414_: f64;
    var phi_9415_: bool;
    var phi_9416_: bool;
    var phi_9417_: bool;
    var phi_9418_: f64;
    var phi_9419_: bool;
    var phi_9420_: bool;
    var phi_9421_: bool;
    var phi_9422_: bool;
    var phi_9426_: bool;
    var phi_9427_: bool;
    var phi_9428_: bool;
    var phi_9429_: f64;
    var phi_9430_: type_45;
    var phi_9431_: bool;
    var phi_9432_: bool;
    var phi_9433_: bool;
    var phi_9434_: bool;
    var local_22: bool;
    var phi_9439_: type_44;
    var phi_9440_: bool;
    var phi_9441_: bool;
    var local_23: f64;
    var phi_9446_: type_44;
    var phi_9447_: bool;
    var local_24: type_45;
    var phi_9453_: type_44;
    var phi_9454_: bool;
    var phi_9458_: type_44;
    var phi_1774_: f64;
    var phi_1781_: f64;
    var phi_1786_: f64;
    var phi_1793_: f64;
    var phi_1798_: f64;
    var phi_1811_: f64;
    var phi_1818_: f64;
    var phi_1823_: f64;
    var phi_1830_: f64;
    var phi_1835_: f64;
    var phi_1840_: f64;
    var phi_1857_: f64;
    var phi_1864_: f64;
    var phi_1869_: f64;
    var phi_1876_: f64;
    var phi_1881_: f64;
    var phi_1895_: f64;
    var phi_1902_: f64;
    var phi_1907_: f64;
    var phi_1914_: f64;
    var phi_1919_: f64;
    var phi_1924_: f64;
    var phi_1941_: f64;
    var phi_1948_: f64;
    var phi_1953_: f64;
    var phi_1960_: f64;
    var phi_1965_: f64;
    var phi_1979_: f64;
    var phi_1986_: f64;
    var phi_1991_: f64;
    var phi_1998_: f64;
    var phi_2003_: f64;
    var phi_2008_: f64;
    var phi_2053_: type_12;
    var phi_2056_: f64;
    var phi_2058_: f64;
    var phi_2060_: f64;
    var phi_2062_: f64;
    var phi_2064_: bool;
    var phi_2066_: u32;
    var phi_2054_: type_12;
    var phi_2089_: type_12;
    var phi_2204_: f64;
    var phi_2210_: f64;
    var phi_2216_: f64;
    var phi_2218_: array<f64, 3>;
    var phi_2225_: f64;
    var phi_2232_: f64;
    var phi_2240_: f64;
    var phi_2286_: type_16;
    var phi_2289_: f64;
    var phi_2310_: bool;
    var phi_2316_: type_17;
    var phi_2287_: type_16;
    var phi_2330_: type_17;
    var phi_2290_: f64;
    var local_25: f64;
    var phi_2279_: f64;
    var phi_2343_: f64;
    var phi_2412_: f64;
    var phi_2418_: f64;
    var phi_2427_: f64;
    var phi_2433_: f64;
    var phi_2442_: f64;
    var phi_2448_: f64;
    var phi_2457_: f64;
    var phi_2463_: f64;
    var phi_2469_: type_34;
    var phi_2470_: bool;
    var phi_2471_: type_34;
    var phi_2472_: bool;
    var phi_2482_: type_34;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2663_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var phi_2966_: bool;
    var phi_2970_: bool;
    var phi_2974_: bool;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var phi_3060_: bool;
    var phi_3061_: bool;
    var phi_3084_: f64;
    var phi_3085_: bool;
    var phi_3086_: f64;
    var phi_3087_: bool;
    var phi_3088_: f64;
    var phi_3089_: bool;
    var phi_3090_: bool;
    var phi_3095_: f64;
    var phi_3096_: bool;
    var phi_3100_: f64;
    var phi_3132_: bool;
    var phi_3133_: bool;
    var phi_3156_: f64;
    var phi_3157_: bool;
    var phi_3158_: f64;
    var phi_3159_: bool;
    var phi_3160_: f64;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3167_: f64;
    var phi_3168_: bool;
    var phi_3172_: f64;
    var phi_3177_: f64;
    var phi_3209_: bool;
    var phi_3210_: bool;
    var phi_3233_: f64;
    var phi_3234_: bool;
    var phi_3235_: f64;
    var phi_3236_: bool;
    var phi_3237_: f64;
    var phi_3238_: bool;
    var phi_3239_: bool;
    var phi_3244_: f64;
    var phi_3245_: bool;
    var phi_3249_: f64;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3305_: f64;
    var phi_3306_: bool;
    var phi_3307_: f64;
    var phi_3308_: bool;
    var phi_3309_: f64;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3316_: f64;
    var phi_3317_: bool;
    var phi_3321_: f64;
    var phi_3326_: f64;
    var phi_3331_: f64;
    var phi_3336_: f64;
    var phi_3350_: f64;
    var phi_3488_: type_16;
    var phi_3491_: f64;
    var phi_3512_: bool;
    var phi_3518_: type_17;
    var phi_3489_: type_16;
    var phi_3532_: type_17;
    var phi_3492_: f64;
    var local_26: f64;
    var phi_3481_: f64;
    var phi_3545_: f64;
    var phi_3563_: f64;
    var phi_3570_: f64;
    var phi_3575_: f64;
    var phi_3582_: f64;
    var phi_3587_: f64;
    var phi_3600_: f64;
    var phi_3607_: f64;
    var phi_3612_: f64;
    var phi_3619_: f64;
    var phi_3624_: f64;
    var phi_3629_: f64;
    var phi_3646_: f64;
    var phi_3653_: f64;
    var phi_3658_: f64;
    var phi_3665_: f64;
    var phi_3670_: f64;
    var phi_3684_: f64;
    var phi_3691_: f64;
    var phi_3696_: f64;
    var phi_3703_: f64;
    var phi_3708_: f64;
    var phi_3713_: f64;
    var phi_3730_: f64;
    var phi_3737_: f64;
    var phi_3742_: f64;
    var phi_3749_: f64;
    var phi_3754_: f64;
    var phi_3768_: f64;
    var phi_3775_: f64;
    var phi_3780_: f64;
    var phi_3787_: f64;
    var phi_3792_: f64;
    var phi_3797_: f64;
    var phi_3821_: bool;
    var phi_3822_: bool;
    var phi_3823_: bool;
    var phi_3840_: f64;
    var phi_3841_: bool;
    var phi_3842_: f64;
    var phi_3843_: bool;
    var phi_3848_: f64;
    var phi_3850_: f64;
    var phi_3851_: f64;
    var phi_3852_: bool;
    var phi_3853_: f64;
    var phi_3854_: f64;
    var phi_3855_: bool;
    var phi_3856_: bool;
    var phi_3857_: f64;
    var phi_3858_: f64;
    var phi_3859_: f64;
    var phi_3860_: f64;
    var phi_3861_: bool;
    var phi_3862_: bool;
    var phi_3863_: bool;
    var phi_3864_: bool;
    var phi_3865_: f64;
    var phi_3866_: f64;
    var phi_3867_: f64;
    var phi_3868_: f64;
    var phi_3869_: bool;
    var phi_3870_: bool;
    var phi_3871_: bool;
    var phi_3872_: bool;
    var phi_3873_: bool;
    var phi_3874_: f64;
    var phi_3875_: f64;
    var phi_3876_: f64;
    var phi_3877_: f64;
    var phi_3878_: bool;
    var phi_3879_: bool;
    var phi_3880_: bool;
    var phi_3881_: bool;
    var phi_3882_: bool;
    var phi_3968_: f64;
    var phi_4041_: f64;
    var phi_4046_: f64;
    var phi_4119_: f64;
    var phi_4192_: f64;
    var phi_4197_: f64;
    var phi_4218_: f64;
    var phi_4219_: f64;
    var phi_4220_: f64;
    var phi_3895_: bool;
    var phi_4222_: u32;
    var phi_4223_: f64;
    var phi_4224_: bool;
    var phi_4225_: bool;
    var phi_4226_: bool;
    var phi_4227_: u32;
    var phi_4228_: f64;
    var phi_4229_: f64;
    var phi_4230_: f64;
    var phi_4231_: f64;
    var phi_4232_: bool;
    var phi_4233_: u32;
    var phi_4234_: bool;
    var phi_4235_: bool;
    var phi_4236_: bool;
    var phi_4237_: bool;
    var phi_4238_: bool;
    var phi_4239_: bool;
    var phi_4248_: f64;
    var phi_4253_: f64;
    var phi_4263_: bool;
    var phi_4267_: bool;
    var phi_4268_: f64;
    var phi_4269_: f64;
    var phi_4270_: f64;
    var phi_4271_: f64;
    var phi_4272_: bool;
    var phi_4273_: u32;
    var phi_4274_: bool;
    var phi_4275_: bool;
    var phi_4276_: bool;
    var phi_4277_: bool;
    var phi_4278_: bool;
    var phi_4279_: bool;
    var phi_2057_: f64;
    var phi_2059_: f64;
    var phi_2061_: f64;
    var phi_2063_: f64;
    var phi_2065_: bool;
    var phi_2067_: u32;
    var phi_4280_: f64;
    var phi_4281_: f64;
    var phi_4282_: bool;
    var phi_4283_: bool;
    var phi_4284_: bool;
    var phi_4285_: bool;
    var phi_4286_: bool;
    var phi_4287_: bool;
    var phi_4288_: bool;
    var local_27: bool;
    var phi_4292_: bool;
    var phi_4293_: bool;
    var phi_4294_: bool;
    var phi_4295_: bool;
    var phi_4296_: bool;
    var local_28: f64;
    var phi_4301_: type_44;
    var phi_4302_: bool;
    var phi_4303_: bool;
    var phi_4304_: bool;
    var phi_4305_: bool;
    var phi_4306_: bool;
    var phi_4311_: type_44;
    var phi_4312_: bool;
    var phi_4313_: bool;
    var phi_4314_: bool;
    var phi_4315_: bool;
    var phi_4316_: bool;
    var phi_4320_: f64;
    var phi_4321_: bool;
    var phi_4322_: bool;
    var phi_4323_: bool;
    var phi_4324_: bool;
    var phi_4328_: f64;
    var phi_4329_: bool;
    var phi_4330_: bool;
    var phi_4331_: bool;
    var phi_4336_: type_44;
    var phi_4337_: bool;
    var phi_4338_: bool;
    var phi_4343_: type_44;
    var phi_4344_: bool;
    var phi_4348_: type_44;
    var phi_4361_: type_12;
    var phi_4362_: type_12;
    var phi_4385_: type_12;
    var phi_4406_: f64;
    var phi_4536_: type_16;
    var phi_4539_: f64;
    var phi_4560_: bool;
    var phi_4566_: type_17;
    var phi_4537_: type_16;
    var phi_4580_: type_17;
    var phi_4540_: f64;
    var local_29: f64;
    var phi_4529_: f64;
    var phi_4593_: f64;
    var phi_4611_: f64;
    var phi_4618_: f64;
    var phi_4623_: f64;
    var phi_4630_: f64;
    var phi_4635_: f64;
    var phi_4648_: f64;
    var phi_4655_: f64;
    var phi_4660_: f64;
    var phi_4667_: f64;
    var phi_4672_: f64;
    var phi_4677_: f64;
    var phi_4694_: f64;
    var phi_4701_: f64;
    var phi_4706_: f64;
    var phi_4713_: f64;
    var phi_4718_: f64;
    var phi_4732_: f64;
    var phi_4739_: f64;
    var phi_4744_: f64;
    var phi_4751_: f64;
    var phi_4756_: f64;
    var phi_4761_: f64;
    var phi_4778_: f64;
    var phi_4785_: f64;
    var phi_4790_: f64;
    var phi_4797_: f64;
    var phi_4802_: f64;
    var phi_4816_: f64;
    var phi_4823_: f64;
    var phi_4828_: f64;
    var phi_4835_: f64;
    var phi_4840_: f64;
    var phi_4845_: f64;
    var phi_4869_: bool;
    var phi_4870_: bool;
    var phi_4871_: bool;
    var local_30: bool;
    var phi_4876_: type_44;
    var phi_4877_: bool;
    var phi_4882_: type_44;
    var phi_4883_: bool;
    var phi_4885_: type_44;
    var phi_4886_: type_44;
    var phi_4887_: bool;
    var phi_4891_: type_44;
    var phi_9462_: type_44;
    var phi_9463_: type_44;
    var phi_9476_: type_32;
    var phi_9499_: u32;
    var phi_9503_: type_22;
    var phi_9504_: bool;
    var phi_9523_: u32;
    var local_31: u32;
    var local_32: f64;
    var local_33: f64;
    var local_34: bool;
    var local_35: bool;
    var local_36: f64;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f64;
    var local_44: f64;
    var local_45: f64;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: bool;
    var local_52: bool;
    var local_53: bool;
    var local_54: f64;
    var local_55: f64;
    var local_56: f64;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e108 = id_2;
    let _e109 = n_2;
    let _e110 = lane_2;
    let _e122 = ((_e108.y * _e109.x) + _e108.x);
    let _e125 = (_e109.x * _e109.y);
    let _e128 = params.member.member_1.member_2;
    let _e130 = input.member[0u];
    if (_e128 < _e130) {
        phi_241_ = _e128;
    } else {
        phi_241_ = _e130;
    }
    let _e133 = phi_241_;
    let _e134 = (_e133 / 64u);
    if ((_e133 % 64u) > 0u) {
        phi_257_ = (_e134 + 1u);
    } else {
        phi_257_ = _e134;
    }
    let _e139 = phi_257_;
    if (_e139 > _e122) {
        let _e141 = (_e139 - _e122);
        if (_e125 == 0u) {
            return;
        }
        let _e143 = (_e141 / _e125);
        if (_e125 == 0u) {
            return;
        }
        if ((_e141 % _e125) > 0u) {
            phi_278_ = (_e143 + 1u);
        } else {
            phi_278_ = _e143;
        }
        let _e149 = phi_278_;
        phi_279_ = _e149;
    } else {
        phi_279_ = 0u;
    }
    let _e151 = phi_279_;
    phi_282_ = type_12(0u, _e151);
    loop {
        let _e154 = phi_282_;
        if (_e154.member < _e154.member_1) {
            phi_283_ = type_12((_e154.member + 1u), _e154.member_1);
            phi_306_ = type_12(1u, _e154.member);
        } else {
            phi_283_ = _e154;
            phi_306_ = type_12(0u, type_12().member_1);
        }
        let _e166 = phi_283_;
        let _e168 = phi_306_;
        let _e172 = (bitcast<i32>(_e168.member) != 0i);
        if _e172 {
            let _e176 = (((_e122 + (_e168.member_1 * _e125)) * 64u) + _e110);
            if (_e176 < _e133) {
                let _e178 = (2u * _e176);
                let _e181 = input.member[(4u + _e178)];
                let _e184 = input.member[(_e178 + 5u)];
                let _e187 = elements.member[_e181];
                let _e189 = elements.member[_e184];
                let _e195 = params.member.member.member_1;
                if ((_e195 & 8u) != 0u) {
                    let _e234 = paths.member[_e187[0]];
                    let _e236 = paths.member[_e187[1]];
                    let _e242 = paths.member[_e189[0]];
                    let _e244 = paths.member[_e189[1]];
                    let _e281 = function_3(array<f32, 3>(_e234.member[0], _e234.member[1], _e234.member[2]));
                    let _e282 = function_3(array<f32, 3>(_e236.member[0], _e236.member[1], _e236.member[2]));
                    let _e283 = function_3(array<f32, 3>(_e242.member[0], _e242.member[1], _e242.member[2]));
                    let _e284 = function_3(array<f32, 3>(_e244.member[0], _e244.member[1], _e244.member[2]));
                    let _e286 = function_3(array<f32, 3>(_e234.member_1[0], _e234.member_1[1], _e234.member_1[2]));
                    let _e287 = function_3(array<f32, 3>(_e236.member_1[0], _e236.member_1[1], _e236.member_1[2]));
                    let _e288 = function_3(array<f32, 3>(_e242.member_1[0], _e242.member_1[1], _e242.member_1[2]));
                    let _e289 = function_3(array<f32, 3>(_e244.member_1[0], _e244.member_1[1], _e244.member_1[2]));
                    phi_564_ = type_42(array<array<f64, 3>, 4>(_e281, _e282, _e283, _e284), array<array<f64, 3>, 4>(_e286, _e287, _e288, _e289));
                } else {
                    let _e199 = positions.member[_e187[0]];
                    let _e202 = params.member.member.member[0u];
                    let _e205 = positions.member[(_e202 + _e187[0])];
                    let _e207 = positions.member[_e187[1]];
                    let _e210 = params.member.member.member[0u];
                    let _e213 = positions.member[(_e210 + _e187[1])];
                    let _e215 = positions.member[_e189[0]];
                    let _e218 = params.member.member.member[0u];
                    let _e221 = positions.member[(_e218 + _e189[0])];
                    let _e223 = positions.member[_e189[1]];
                    let _e226 = params.member.member.member[0u];
                    let _e229 = positions.member[(_e226 + _e189[1])];
                    phi_564_ = type_42(array<array<f64, 3>, 4>(_e199, _e207, _e215, _e223), array<array<f64, 3>, 4>(_e205, _e213, _e221, _e229));
                }
                let _e293 = phi_564_;
                let _e300 = (_e293.member[2][0] - _e293.member[0][0]);
                let _e303 = (_e293.member[2][1] - _e293.member[0][1]);
                let _e306 = (_e293.member[2][2] - _e293.member[0][2]);
                let _e312 = (_e293.member_1[2][0] - _e293.member_1[0][0]);
                let _e315 = (_e293.member_1[2][1] - _e293.member_1[0][1]);
                let _e318 = (_e293.member_1[2][2] - _e293.member_1[0][2]);
                let _e325 = (_e293.member[1][0] - _e293.member[0][0]);
                let _e328 = (_e293.member[1][1] - _e293.member[0][1]);
                let _e331 = (_e293.member[1][2] - _e293.member[0][2]);
                let _e337 = (_e293.member_1[1][0] - _e293.member_1[0][0]);
                let _e340 = (_e293.member_1[1][1] - _e293.member_1[0][1]);
                let _e343 = (_e293.member_1[1][2] - _e293.member_1[0][2]);
                let _e350 = (_e293.member[2][0] - _e293.member[3][0]);
                let _e353 = (_e293.member[2][1] - _e293.member[3][1]);
                let _e356 = (_e293.member[2][2] - _e293.member[3][2]);
                let _e362 = (_e293.member_1[2][0] - _e293.member_1[3][0]);
                let _e365 = (_e293.member_1[2][1] - _e293.member_1[3][1]);
                let _e368 = (_e293.member_1[2][2] - _e293.member_1[3][2]);
                let _e371 = (0.0lf + 0.0lf);
                let _e374 = params.member.member.member_7;
                let _e381 = bitcast<f64>(((u64(_e374[1]) * 4294967296lu) + u64(_e374[0])));
                if (_e300 < 0.0lf) {
                    phi_658_ = -(_e300);
                } else {
                    phi_658_ = _e300;
                }
                let _e385 = phi_658_;
                if (_e303 < 0.0lf) {
                    phi_664_ = -(_e303);
                } else {
                    phi_664_ = _e303;
                }
                let _e389 = phi_664_;
                if (_e385 > _e389) {
                    phi_669_ = _e385;
                } else {
                    phi_669_ = _e389;
                }
                let _e392 = phi_669_;
                if (_e306 < 0.0lf) {
                    phi_675_ = -(_e306);
                } else {
                    phi_675_ = _e306;
                }
                let _e396 = phi_675_;
                if (_e392 > _e396) {
                    phi_680_ = _e392;
                } else {
                    phi_680_ = _e396;
                }
                let _e399 = phi_680_;
                if (_e312 < 0.0lf) {
                    phi_686_ = -(_e312);
                } else {
                    phi_686_ = _e312;
                }
                let _e403 = phi_686_;
                if (_e315 < 0.0lf) {
                    phi_692_ = -(_e315);
                } else {
                    phi_692_ = _e315;
                }
                let _e407 = phi_692_;
                if (_e403 > _e407) {
                    phi_697_ = _e403;
                } else {
                    phi_697_ = _e407;
                }
                let _e410 = phi_697_;
                if (_e318 < 0.0lf) {
                    phi_703_ = -(_e318);
                } else {
                    phi_703_ = _e318;
                }
                let _e414 = phi_703_;
                if (_e410 > _e414) {
                    phi_708_ = _e410;
                } else {
                    phi_708_ = _e414;
                }
                let _e417 = phi_708_;
                if (_e399 > _e417) {
                    phi_713_ = _e399;
                } else {
                    phi_713_ = _e417;
                }
                let _e420 = phi_713_;
                let _e421 = (_e420 + _e371);
                if (_e325 < 0.0lf) {
                    phi_720_ = -(_e325);
                } else {
                    phi_720_ = _e325;
                }
                let _e425 = phi_720_;
                if (_e328 < 0.0lf) {
                    phi_726_ = -(_e328);
                } else {
                    phi_726_ = _e328;
                }
                let _e429 = phi_726_;
                if (_e425 > _e429) {
                    phi_731_ = _e425;
                } else {
                    phi_731_ = _e429;
                }
                let _e432 = phi_731_;
                if (_e331 < 0.0lf) {
                    phi_737_ = -(_e331);
                } else {
                    phi_737_ = _e331;
                }
                let _e436 = phi_737_;
                if (_e432 > _e436) {
                    phi_742_ = _e432;
                } else {
                    phi_742_ = _e436;
                }
                let _e439 = phi_742_;
                if (_e337 < 0.0lf) {
                    phi_748_ = -(_e337);
                } else {
                    phi_748_ = _e337;
                }
                let _e443 = phi_748_;
                if (_e340 < 0.0lf) {
                    phi_754_ = -(_e340);
                } else {
                    phi_754_ = _e340;
                }
                let _e447 = phi_754_;
                if (_e443 > _e447) {
                    phi_759_ = _e443;
                } else {
                    phi_759_ = _e447;
                }
                let _e450 = phi_759_;
                if (_e343 < 0.0lf) {
                    phi_765_ = -(_e343);
                } else {
                    phi_765_ = _e343;
                }
                let _e454 = phi_765_;
                if (_e450 > _e454) {
                    phi_770_ = _e450;
                } else {
                    phi_770_ = _e454;
                }
                let _e457 = phi_770_;
                if (_e439 > _e457) {
                    phi_775_ = _e439;
                } else {
                    phi_775_ = _e457;
                }
                let _e460 = phi_775_;
                let _e461 = (_e460 + _e371);
                if (_e350 < 0.0lf) {
                    phi_782_ = -(_e350);
                } else {
                    phi_782_ = _e350;
                }
                let _e465 = phi_782_;
                if (_e353 < 0.0lf) {
                    phi_788_ = -(_e353);
                } else {
                    phi_788_ = _e353;
                }
                let _e469 = phi_788_;
                if (_e465 > _e469) {
                    phi_793_ = _e465;
                } else {
                    phi_793_ = _e469;
                }
                let _e472 = phi_793_;
                if (_e356 < 0.0lf) {
                    phi_799_ = -(_e356);
                } else {
                    phi_799_ = _e356;
                }
                let _e476 = phi_799_;
                if (_e472 > _e476) {
                    phi_804_ = _e472;
                } else {
                    phi_804_ = _e476;
                }
                let _e479 = phi_804_;
                if (_e362 < 0.0lf) {
                    phi_810_ = -(_e362);
                } else {
                    phi_810_ = _e362;
                }
                let _e483 = phi_810_;
                if (_e365 < 0.0lf) {
                    phi_816_ = -(_e365);
                } else {
                    phi_816_ = _e365;
                }
                let _e487 = phi_816_;
                if (_e483 > _e487) {
                    phi_821_ = _e483;
                } else {
                    phi_821_ = _e487;
                }
                let _e490 = phi_821_;
                if (_e368 < 0.0lf) {
                    phi_827_ = -(_e368);
                } else {
                    phi_827_ = _e368;
                }
                let _e494 = phi_827_;
                if (_e490 > _e494) {
                    phi_832_ = _e490;
                } else {
                    phi_832_ = _e494;
                }
                let _e497 = phi_832_;
                if (_e479 > _e497) {
                    phi_837_ = _e479;
                } else {
                    phi_837_ = _e497;
                }
                let _e500 = phi_837_;
                let _e501 = (_e500 + _e371);
                if (_e421 > _e461) {
                    phi_843_ = _e421;
                } else {
                    phi_843_ = _e461;
                }
                let _e504 = phi_843_;
                if (_e504 > _e501) {
                    phi_848_ = _e504;
                } else {
                    phi_848_ = _e501;
                }
                let _e507 = phi_848_;
                if (_e507 <= f64(65536f)) {
                    phi_857_ = (_e507 >= f64((1f / 65536f)));
                } else {
                    phi_857_ = false;
                }
                let _e514 = phi_857_;
                if _e514 {
                    phi_929_ = type_43();
                    phi_930_ = true;
                } else {
                    if (_e507 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e507) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e521 = (9214364837600034816lu - (bitcast<u64>(_e507) & 9218868437227405312lu));
                            if (_e521 > 4503599627370496lu) {
                                phi_881_ = _e521;
                            } else {
                                phi_881_ = 4503599627370496lu;
                            }
                            let _e524 = phi_881_;
                            let _e525 = bitcast<f64>(_e524);
                            let _e526 = (_e381 * _e525);
                            if (_e381 > f64(0f)) {
                                if (_e526 > 2.2250738585072014e-308lf) {
                                    phi_893_ = _e526;
                                } else {
                                    phi_893_ = 2.2250738585072014e-308lf;
                                }
                                let _e531 = phi_893_;
                                phi_894_ = _e531;
                            } else {
                                phi_894_ = _e526;
                            }
                            let _e533 = phi_894_;
                            phi_925_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e300 * _e525), (_e303 * _e525), (_e306 * _e525)), array<f64, 3>((_e312 * _e525), (_e315 * _e525), (_e318 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e325 * _e525), (_e328 * _e525), (_e331 * _e525)), array<f64, 3>((_e337 * _e525), (_e340 * _e525), (_e343 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e350 * _e525), (_e353 * _e525), (_e356 * _e525)), array<f64, 3>((_e362 * _e525), (_e365 * _e525), (_e368 * _e525))), (_e371 * _e525)), _e533);
                            phi_926_ = false;
                        } else {
                            phi_925_ = type_43();
                            phi_926_ = true;
                        }
                        let _e565 = phi_925_;
                        let _e567 = phi_926_;
                        phi_927_ = _e565;
                        phi_928_ = _e567;
                    } else {
                        phi_927_ = type_43();
                        phi_928_ = true;
                    }
                    let _e569 = phi_927_;
                    let _e571 = phi_928_;
                    phi_929_ = _e569;
                    phi_930_ = _e571;
                }
                let _e573 = phi_929_;
                let _e575 = phi_930_;
                if _e575 {
                    phi_935_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e300, _e303, _e306), array<f64, 3>(_e312, _e315, _e318)), array<array<f64, 3>, 2>(array<f64, 3>(_e325, _e328, _e331), array<f64, 3>(_e337, _e340, _e343)), array<array<f64, 3>, 2>(array<f64, 3>(_e350, _e353, _e356), array<f64, 3>(_e362, _e365, _e368)), _e371), _e381);
                } else {
                    phi_935_ = _e573;
                }
                let _e578 = phi_935_;
                local_12 = type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member[0][0], _e578.member.member[0][1], _e578.member.member[0][2]), array<f64, 3>(_e578.member.member[1][0], _e578.member.member[1][1], _e578.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member_1[0][0], _e578.member.member_1[0][1], _e578.member.member_1[0][2]), array<f64, 3>(_e578.member.member_1[1][0], _e578.member.member_1[1][1], _e578.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member_2[0][0], _e578.member.member_2[0][1], _e578.member.member_2[0][2]), array<f64, 3>(_e578.member.member_2[1][0], _e578.member.member_2[1][1], _e578.member.member_2[1][2])), _e578.member.member_3);
                let _e621 = local_12.member_1[0u];
                let _e627 = local_12.member_2[0u];
                let _e633 = ((_e621[1] * _e627[2]) - (_e621[2] * _e627[1]));
                let _e636 = ((_e621[2] * _e627[0]) - (_e621[0] * _e627[2]));
                let _e639 = ((_e621[0] * _e627[1]) - (_e621[1] * _e627[0]));
                let _e642 = local_12.member_1[1u];
                let _e648 = local_12.member_2[1u];
                let _e654 = ((_e642[1] * _e648[2]) - (_e642[2] * _e648[1]));
                let _e657 = ((_e642[2] * _e648[0]) - (_e642[0] * _e648[2]));
                let _e660 = ((_e642[0] * _e648[1]) - (_e642[1] * _e648[0]));
                let _e663 = local_12.member_1[0u];
                let _e669 = local_12.member_2[1u];
                let _e684 = local_12.member_1[1u];
                let _e690 = local_12.member_2[0u];
                let _e703 = (((_e663[1] * _e669[2]) - (_e663[2] * _e669[1])) + ((_e684[1] * _e690[2]) - (_e684[2] * _e690[1])));
                let _e704 = (((_e663[2] * _e669[0]) - (_e663[0] * _e669[2])) + ((_e684[2] * _e690[0]) - (_e684[0] * _e690[2])));
                let _e705 = (((_e663[0] * _e669[1]) - (_e663[1] * _e669[0])) + ((_e684[0] * _e690[1]) - (_e684[1] * _e690[0])));
                let _e708 = local_12.member[0u];
                let _e716 = (((_e708[0] * _e633) + (_e708[1] * _e636)) + (_e708[2] * _e639));
                let _e719 = local_12.member[1u];
                let _e730 = local_12.member[0u];
                let _e739 = ((((_e719[0] * _e633) + (_e719[1] * _e636)) + (_e719[2] * _e639)) + (((_e730[0] * _e703) + (_e730[1] * _e704)) + (_e730[2] * _e705)));
                let _e742 = local_12.member[0u];
                let _e753 = local_12.member[1u];
                let _e762 = ((((_e742[0] * _e654) + (_e742[1] * _e657)) + (_e742[2] * _e660)) + (((_e753[0] * _e703) + (_e753[1] * _e704)) + (_e753[2] * _e705)));
                let _e765 = local_12.member[1u];
                let _e773 = (((_e765[0] * _e654) + (_e765[1] * _e657)) + (_e765[2] * _e660));
                let _e776 = local_12.member[0u];
                if (_e776[0] < 0.0lf) {
                    phi_1217_ = -(_e776[0]);
                } else {
                    phi_1217_ = _e776[0];
                }
                let _e783 = phi_1217_;
                if (_e776[1] < 0.0lf) {
                    phi_1224_ = -(_e776[1]);
                } else {
                    phi_1224_ = _e776[1];
                }
                let _e787 = phi_1224_;
                if (_e783 > _e787) {
                    phi_1229_ = _e783;
                } else {
                    phi_1229_ = _e787;
                }
                let _e790 = phi_1229_;
                if (_e776[2] < 0.0lf) {
                    phi_1236_ = -(_e776[2]);
                } else {
                    phi_1236_ = _e776[2];
                }
                let _e794 = phi_1236_;
                if (_e790 > _e794) {
                    phi_1241_ = _e790;
                } else {
                    phi_1241_ = _e794;
                }
                let _e797 = phi_1241_;
                let _e800 = local_12.member[1u];
                if (_e800[0] < 0.0lf) {
                    phi_1254_ = -(_e800[0]);
                } else {
                    phi_1254_ = _e800[0];
                }
                let _e807 = phi_1254_;
                if (_e800[1] < 0.0lf) {
                    phi_1261_ = -(_e800[1]);
                } else {
                    phi_1261_ = _e800[1];
                }
                let _e811 = phi_1261_;
                if (_e807 > _e811) {
                    phi_1266_ = _e807;
                } else {
                    phi_1266_ = _e811;
                }
                let _e814 = phi_1266_;
                if (_e800[2] < 0.0lf) {
                    phi_1273_ = -(_e800[2]);
                } else {
                    phi_1273_ = _e800[2];
                }
                let _e818 = phi_1273_;
                if (_e814 > _e818) {
                    phi_1278_ = _e814;
                } else {
                    phi_1278_ = _e818;
                }
                let _e821 = phi_1278_;
                if (_e797 > _e821) {
                    phi_1283_ = _e797;
                } else {
                    phi_1283_ = _e821;
                }
                let _e824 = phi_1283_;
                let _e826 = local_12.member_3;
                let _e827 = (_e824 + _e826);
                let _e830 = local_12.member_1[0u];
                if (_e830[0] < 0.0lf) {
                    phi_1300_ = -(_e830[0]);
                } else {
                    phi_1300_ = _e830[0];
                }
                let _e837 = phi_1300_;
                if (_e830[1] < 0.0lf) {
                    phi_1307_ = -(_e830[1]);
                } else {
                    phi_1307_ = _e830[1];
                }
                let _e841 = phi_1307_;
                if (_e837 > _e841) {
                    phi_1312_ = _e837;
                } else {
                    phi_1312_ = _e841;
                }
                let _e844 = phi_1312_;
                if (_e830[2] < 0.0lf) {
                    phi_1319_ = -(_e830[2]);
                } else {
                    phi_1319_ = _e830[2];
                }
                let _e848 = phi_1319_;
                if (_e844 > _e848) {
                    phi_1324_ = _e844;
                } else {
                    phi_1324_ = _e848;
                }
                let _e851 = phi_1324_;
                let _e854 = local_12.member_1[1u];
                if (_e854[0] < 0.0lf) {
                    phi_1338_ = -(_e854[0]);
                } else {
                    phi_1338_ = _e854[0];
                }
                let _e861 = phi_1338_;
                if (_e854[1] < 0.0lf) {
                    phi_1345_ = -(_e854[1]);
                } else {
                    phi_1345_ = _e854[1];
                }
                let _e865 = phi_1345_;
                if (_e861 > _e865) {
                    phi_1350_ = _e861;
                } else {
                    phi_1350_ = _e865;
                }
                let _e868 = phi_1350_;
                if (_e854[2] < 0.0lf) {
                    phi_1357_ = -(_e854[2]);
                } else {
                    phi_1357_ = _e854[2];
                }
                let _e872 = phi_1357_;
                if (_e868 > _e872) {
                    phi_1362_ = _e868;
                } else {
                    phi_1362_ = _e872;
                }
                let _e875 = phi_1362_;
                if (_e851 > _e875) {
                    phi_1367_ = _e851;
                } else {
                    phi_1367_ = _e875;
                }
                let _e878 = phi_1367_;
                let _e880 = local_12.member_3;
                let _e881 = (_e878 + _e880);
                let _e884 = local_12.member_2[0u];
                if (_e884[0] < 0.0lf) {
                    phi_1384_ = -(_e884[0]);
                } else {
                    phi_1384_ = _e884[0];
                }
                let _e891 = phi_1384_;
                if (_e884[1] < 0.0lf) {
                    phi_1391_ = -(_e884[1]);
                } else {
                    phi_1391_ = _e884[1];
                }
                let _e895 = phi_1391_;
                if (_e891 > _e895) {
                    phi_1396_ = _e891;
                } else {
                    phi_1396_ = _e895;
                }
                let _e898 = phi_1396_;
                if (_e884[2] < 0.0lf) {
                    phi_1403_ = -(_e884[2]);
                } else {
                    phi_1403_ = _e884[2];
                }
                let _e902 = phi_1403_;
                if (_e898 > _e902) {
                    phi_1408_ = _e898;
                } else {
                    phi_1408_ = _e902;
                }
                let _e905 = phi_1408_;
                let _e908 = local_12.member_2[1u];
                if (_e908[0] < 0.0lf) {
                    phi_1422_ = -(_e908[0]);
                } else {
                    phi_1422_ = _e908[0];
                }
                let _e915 = phi_1422_;
                if (_e908[1] < 0.0lf) {
                    phi_1429_ = -(_e908[1]);
                } else {
                    phi_1429_ = _e908[1];
                }
                let _e919 = phi_1429_;
                if (_e915 > _e919) {
                    phi_1434_ = _e915;
                } else {
                    phi_1434_ = _e919;
                }
                let _e922 = phi_1434_;
                if (_e908[2] < 0.0lf) {
                    phi_1441_ = -(_e908[2]);
                } else {
                    phi_1441_ = _e908[2];
                }
                let _e926 = phi_1441_;
                if (_e922 > _e926) {
                    phi_1446_ = _e922;
                } else {
                    phi_1446_ = _e926;
                }
                let _e929 = phi_1446_;
                if (_e905 > _e929) {
                    phi_1451_ = _e905;
                } else {
                    phi_1451_ = _e929;
                }
                let _e932 = phi_1451_;
                let _e934 = local_12.member_3;
                let _e935 = (_e932 + _e934);
                let _e936 = f64(1f);
                let _e937 = f64(8f);
                let _e939 = ((_e881 * _e937) * _e935);
                let _e947 = local_12.member_3;
                if (_e633 < 0.0lf) {
                    phi_1488_ = -(_e633);
                } else {
                    phi_1488_ = _e633;
                }
                let _e967 = phi_1488_;
                if (_e636 < 0.0lf) {
                    phi_1494_ = -(_e636);
                } else {
                    phi_1494_ = _e636;
                }
                let _e971 = phi_1494_;
                if (_e639 < 0.0lf) {
                    phi_1501_ = -(_e639);
                } else {
                    phi_1501_ = _e639;
                }
                let _e976 = phi_1501_;
                let _e977 = ((_e967 + _e971) + _e976);
                if (_e654 < 0.0lf) {
                    phi_1508_ = -(_e654);
                } else {
                    phi_1508_ = _e654;
                }
                let _e981 = phi_1508_;
                if (_e657 < 0.0lf) {
                    phi_1514_ = -(_e657);
                } else {
                    phi_1514_ = _e657;
                }
                let _e985 = phi_1514_;
                if (_e660 < 0.0lf) {
                    phi_1521_ = -(_e660);
                } else {
                    phi_1521_ = _e660;
                }
                let _e990 = phi_1521_;
                let _e991 = ((_e981 + _e985) + _e990);
                if (_e977 > _e991) {
                    phi_1527_ = _e977;
                } else {
                    phi_1527_ = _e991;
                }
                let _e994 = phi_1527_;
                if (_e703 < 0.0lf) {
                    phi_1533_ = -(_e703);
                } else {
                    phi_1533_ = _e703;
                }
                let _e998 = phi_1533_;
                if (_e704 < 0.0lf) {
                    phi_1539_ = -(_e704);
                } else {
                    phi_1539_ = _e704;
                }
                let _e1002 = phi_1539_;
                if (_e705 < 0.0lf) {
                    phi_1546_ = -(_e705);
                } else {
                    phi_1546_ = _e705;
                }
                let _e1007 = phi_1546_;
                let _e1009 = (((_e998 + _e1002) + _e1007) * f64(0.5f));
                if (_e994 > _e1009) {
                    phi_1553_ = _e994;
                } else {
                    phi_1553_ = _e1009;
                }
                let _e1012 = phi_1553_;
                let _e1018 = local_12.member_3;
                let _e1032 = (((((_e827 * _e937) * _e939) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e947 * f64(19f)) * ((_e827 * (_e881 + _e935)) + (_e881 * _e935)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e827) * ((_e936 + _e881) * (_e936 + _e935)))));
                let _e1033 = f64(3f);
                let _e1034 = (_e716 * _e1033);
                let _e1035 = (_e773 * _e1033);
                if (_e1034 < _e1035) {
                    phi_1581_ = _e1034;
                } else {
                    phi_1581_ = _e1035;
                }
                let _e1038 = phi_1581_;
                if (_e739 < _e762) {
                    phi_1586_ = _e739;
                } else {
                    phi_1586_ = _e762;
                }
                let _e1041 = phi_1586_;
                if (_e1038 < _e1041) {
                    phi_1591_ = _e1038;
                } else {
                    phi_1591_ = _e1041;
                }
                let _e1044 = phi_1591_;
                if (_e1034 > _e1035) {
                    phi_1596_ = _e1034;
                } else {
                    phi_1596_ = _e1035;
                }
                let _e1047 = phi_1596_;
                if (_e739 > _e762) {
                    phi_1601_ = _e739;
                } else {
                    phi_1601_ = _e762;
                }
                let _e1050 = phi_1601_;
                if (_e1047 > _e1050) {
                    phi_1606_ = _e1047;
                } else {
                    phi_1606_ = _e1050;
                }
                let _e1053 = phi_1606_;
                let _e1059 = -(_e1053);
                if (_e1044 > _e1059) {
                    phi_1617_ = _e1044;
                } else {
                    phi_1617_ = _e1059;
                }
                let _e1062 = phi_1617_;
                if ((_e1062 - (_e1032 + ((_e578.member_1 * (((_e1012 + (_e939 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1018 * f64(6f)) * (_e881 + _e935))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e881) * (_e936 + _e935))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_9463_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e578.member_1 > f64(0f)) {
                        let _e4179 = f64(1f);
                        let _e4180 = f64(0f);
                        let _e4183 = local_12.member[0u];
                        let _e4189 = local_12.member_1[0u];
                        let _e4195 = local_12.member_2[0u];
                        let _e4199 = (_e4183[0] - _e4189[0]);
                        let _e4200 = (_e4183[1] - _e4189[1]);
                        let _e4201 = (_e4183[2] - _e4189[2]);
                        let _e4210 = local_12.member[1u];
                        let _e4216 = local_12.member_1[1u];
                        let _e4222 = local_12.member_2[1u];
                        let _e4226 = (_e4210[0] - _e4216[0]);
                        let _e4227 = (_e4210[1] - _e4216[1]);
                        let _e4228 = (_e4210[2] - _e4216[2]);
                        let _e4237 = local_12.member[0u];
                        if (_e4237[0] < 0.0lf) {
                            phi_1774_ = -(_e4237[0]);
                        } else {
                            phi_1774_ = _e4237[0];
                        }
                        let _e4244 = phi_1774_;
                        if (_e4237[1] < 0.0lf) {
                            phi_1781_ = -(_e4237[1]);
                        } else {
                            phi_1781_ = _e4237[1];
                        }
                        let _e4248 = phi_1781_;
                        if (_e4244 > _e4248) {
                            phi_1786_ = _e4244;
                        } else {
                            phi_1786_ = _e4248;
                        }
                        let _e4251 = phi_1786_;
                        if (_e4237[2] < 0.0lf) {
                            phi_1793_ = -(_e4237[2]);
                        } else {
                            phi_1793_ = _e4237[2];
                        }
                        let _e4255 = phi_1793_;
                        if (_e4251 > _e4255) {
                            phi_1798_ = _e4251;
                        } else {
                            phi_1798_ = _e4255;
                        }
                        let _e4258 = phi_1798_;
                        let _e4261 = local_12.member[1u];
                        if (_e4261[0] < 0.0lf) {
                            phi_1811_ = -(_e4261[0]);
                        } else {
                            phi_1811_ = _e4261[0];
                        }
                        let _e4268 = phi_1811_;
                        if (_e4261[1] < 0.0lf) {
                            phi_1818_ = -(_e4261[1]);
                        } else {
                            phi_1818_ = _e4261[1];
                        }
                        let _e4272 = phi_1818_;
                        if (_e4268 > _e4272) {
                            phi_1823_ = _e4268;
                        } else {
                            phi_1823_ = _e4272;
                        }
                        let _e4275 = phi_1823_;
                        if (_e4261[2] < 0.0lf) {
                            phi_1830_ = -(_e4261[2]);
                        } else {
                            phi_1830_ = _e4261[2];
                        }
                        let _e4279 = phi_1830_;
                        if (_e4275 > _e4279) {
                            phi_1835_ = _e4275;
                        } else {
                            phi_1835_ = _e4279;
                        }
                        let _e4282 = phi_1835_;
                        if (_e4258 > _e4282) {
                            phi_1840_ = _e4258;
                        } else {
                            phi_1840_ = _e4282;
                        }
                        let _e4285 = phi_1840_;
                        let _e4287 = local_12.member_3;
                        let _e4291 = local_12.member_1[0u];
                        if (_e4291[0] < 0.0lf) {
                            phi_1857_ = -(_e4291[0]);
                        } else {
                            phi_1857_ = _e4291[0];
                        }
                        let _e4298 = phi_1857_;
                        if (_e4291[1] < 0.0lf) {
                            phi_1864_ = -(_e4291[1]);
                        } else {
                            phi_1864_ = _e4291[1];
                        }
                        let _e4302 = phi_1864_;
                        if (_e4298 > _e4302) {
                            phi_1869_ = _e4298;
                        } else {
                            phi_1869_ = _e4302;
                        }
                        let _e4305 = phi_1869_;
                        if (_e4291[2] < 0.0lf) {
                            phi_1876_ = -(_e4291[2]);
                        } else {
                            phi_1876_ = _e4291[2];
                        }
                        let _e4309 = phi_1876_;
                        if (_e4305 > _e4309) {
                            phi_1881_ = _e4305;
                        } else {
                            phi_1881_ = _e4309;
                        }
                        let _e4312 = phi_1881_;
                        let _e4315 = local_12.member_1[1u];
                        if (_e4315[0] < 0.0lf) {
                            phi_1895_ = -(_e4315[0]);
                        } else {
                            phi_1895_ = _e4315[0];
                        }
                        let _e4322 = phi_1895_;
                        if (_e4315[1] < 0.0lf) {
                            phi_1902_ = -(_e4315[1]);
                        } else {
                            phi_1902_ = _e4315[1];
                        }
                        let _e4326 = phi_1902_;
                        if (_e4322 > _e4326) {
                            phi_1907_ = _e4322;
                        } else {
                            phi_1907_ = _e4326;
                        }
                        let _e4329 = phi_1907_;
                        if (_e4315[2] < 0.0lf) {
                            phi_1914_ = -(_e4315[2]);
                        } else {
                            phi_1914_ = _e4315[2];
                        }
                        let _e4333 = phi_1914_;
                        if (_e4329 > _e4333) {
                            phi_1919_ = _e4329;
                        } else {
                            phi_1919_ = _e4333;
                        }
                        let _e4336 = phi_1919_;
                        if (_e4312 > _e4336) {
                            phi_1924_ = _e4312;
                        } else {
                            phi_1924_ = _e4336;
                        }
                        let _e4339 = phi_1924_;
                        let _e4341 = local_12.member_3;
                        let _e4345 = local_12.member_2[0u];
                        if (_e4345[0] < 0.0lf) {
                            phi_1941_ = -(_e4345[0]);
                        } else {
                            phi_1941_ = _e4345[0];
                        }
                        let _e4352 = phi_1941_;
                        if (_e4345[1] < 0.0lf) {
                            phi_1948_ = -(_e4345[1]);
                        } else {
                            phi_1948_ = _e4345[1];
                        }
                        let _e4356 = phi_1948_;
                        if (_e4352 > _e4356) {
                            phi_1953_ = _e4352;
                        } else {
                            phi_1953_ = _e4356;
                        }
                        let _e4359 = phi_1953_;
                        if (_e4345[2] < 0.0lf) {
                            phi_1960_ = -(_e4345[2]);
                        } else {
                            phi_1960_ = _e4345[2];
                        }
                        let _e4363 = phi_1960_;
                        if (_e4359 > _e4363) {
                            phi_1965_ = _e4359;
                        } else {
                            phi_1965_ = _e4363;
                        }
                        let _e4366 = phi_1965_;
                        let _e4369 = local_12.member_2[1u];
                        if (_e4369[0] < 0.0lf) {
                            phi_1979_ = -(_e4369[0]);
                        } else {
                            phi_1979_ = _e4369[0];
                        }
                        let _e4376 = phi_1979_;
                        if (_e4369[1] < 0.0lf) {
                            phi_1986_ = -(_e4369[1]);
                        } else {
                            phi_1986_ = _e4369[1];
                        }
                        let _e4380 = phi_1986_;
                        if (_e4376 > _e4380) {
                            phi_1991_ = _e4376;
                        } else {
                            phi_1991_ = _e4380;
                        }
                        let _e4383 = phi_1991_;
                        if (_e4369[2] < 0.0lf) {
                            phi_1998_ = -(_e4369[2]);
                        } else {
                            phi_1998_ = _e4369[2];
                        }
                        let _e4387 = phi_1998_;
                        if (_e4383 > _e4387) {
                            phi_2003_ = _e4383;
                        } else {
                            phi_2003_ = _e4387;
                        }
                        let _e4390 = phi_2003_;
                        if (_e4366 > _e4390) {
                            phi_2008_ = _e4366;
                        } else {
                            phi_2008_ = _e4390;
                        }
                        let _e4393 = phi_2008_;
                        let _e4395 = local_12.member_3;
                        let _e4403 = local_12.member_3;
                        let _e4410 = f64(0f);
                        let _e4411 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e4410, _e4410, _e4410, _e4410), array<f64, 4>(_e4410, _e4410, _e4410, _e4410), array<f64, 4>(_e4411, _e4411, _e4411, _e4411));
                        phi_2053_ = type_12(0u, 96u);
                        phi_2056_ = _e4180;
                        phi_2058_ = _e4180;
                        phi_2060_ = (_e4179 - _e4180);
                        phi_2062_ = _e4180;
                        phi_2064_ = false;
                        phi_2066_ = 0u;
                        loop {
                            let _e4418 = phi_2053_;
                            let _e4420 = phi_2056_;
                            let _e4422 = phi_2058_;
                            let _e4424 = phi_2060_;
                            let _e4426 = phi_2062_;
                            let _e4428 = phi_2064_;
                            let _e4430 = phi_2066_;
                            local_28 = _e4420;
                            local_56 = _e4422;
                            if (_e4418.member < _e4418.member_1) {
                                phi_2054_ = type_12((_e4418.member + 1u), _e4418.member_1);
                                phi_2089_ = type_12(1u, _e4418.member);
                            } else {
                                phi_2054_ = _e4418;
                                phi_2089_ = type_12(0u, type_12().member_1);
                            }
                            let _e4442 = phi_2054_;
                            let _e4444 = phi_2089_;
                            if (bitcast<i32>(_e4444.member) != 0i) {
                                let _e4450 = local_12.member[0u];
                                let _e4456 = local_12.member[1u];
                                let _e4472 = local_12.member_1[0u];
                                let _e4478 = local_12.member_1[1u];
                                let _e4494 = local_12.member_2[0u];
                                let _e4500 = local_12.member_2[1u];
                                let _e4514 = function_2(array<f64, 3>((_e4450[0] + ((_e4456[0] - _e4450[0]) * _e4420)), (_e4450[1] + ((_e4456[1] - _e4450[1]) * _e4420)), (_e4450[2] + ((_e4456[2] - _e4450[2]) * _e4420))), array<f64, 3>((_e4472[0] + ((_e4478[0] - _e4472[0]) * _e4420)), (_e4472[1] + ((_e4478[1] - _e4472[1]) * _e4420)), (_e4472[2] + ((_e4478[2] - _e4472[2]) * _e4420))), array<f64, 3>((_e4494[0] + ((_e4500[0] - _e4494[0]) * _e4420)), (_e4494[1] + ((_e4500[1] - _e4494[1]) * _e4420)), (_e4494[2] + ((_e4500[2] - _e4494[2]) * _e4420))), 1u);
                                if (_e4430 == 0u) {
                                    phi_2218_ = _e4514;
                                } else {
                                    let _e4516 = f64(0f);
                                    if (_e4430 == 1u) {
                                        phi_2204_ = _e4514[0];
                                    } else {
                                        phi_2204_ = _e4516;
                                    }
                                    let _e4520 = phi_2204_;
                                    if (_e4430 == 2u) {
                                        phi_2210_ = _e4514[1];
                                    } else {
                                        phi_2210_ = _e4516;
                                    }
                                    let _e4524 = phi_2210_;
                                    if (_e4430 == 3u) {
                                        phi_2216_ = _e4514[2];
                                    } else {
                                        phi_2216_ = _e4516;
                                    }
                                    let _e4528 = phi_2216_;
                                    phi_2218_ = array<f64, 3>(_e4520, _e4524, _e4528);
                                }
                                let _e4531 = phi_2218_;
                                if (_e4531[0] < 0.0lf) {
                                    phi_2225_ = -(_e4531[0]);
                                } else {
                                    phi_2225_ = _e4531[0];
                                }
                                let _e4536 = phi_2225_;
                                if (_e4531[1] < 0.0lf) {
                                    phi_2232_ = -(_e4531[1]);
                                } else {
                                    phi_2232_ = _e4531[1];
                                }
                                let _e4541 = phi_2232_;
                                if (_e4531[2] < 0.0lf) {
                                    phi_2240_ = -(_e4531[2]);
                                } else {
                                    phi_2240_ = _e4531[2];
                                }
                                let _e4547 = phi_2240_;
                                let _e4548 = ((_e4536 + _e4541) + _e4547);
                                if (_e4548 > f64(0f)) {
                                    if ((bitcast<u64>(_e4548) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4555 = (f64(1f) / _e4548);
                                        let _e4557 = (_e4531[0] * _e4555);
                                        let _e4559 = (_e4531[1] * _e4555);
                                        let _e4561 = (_e4531[2] * _e4555);
                                        let _e4566 = (((_e4557 * _e4557) + (_e4559 * _e4559)) + (_e4561 * _e4561));
                                        if (_e4566 <= 2.2250738585072014e-308lf) {
                                            if (_e4566 > 0.0lf) {
                                                phi_2279_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2279_ = 0.0lf;
                                            }
                                            let _e4618 = phi_2279_;
                                            phi_2343_ = _e4618;
                                        } else {
                                            phi_2286_ = type_16(0i, 5i);
                                            phi_2289_ = bitcast<f64>(((bitcast<u64>(_e4566) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4573 = phi_2286_;
                                                let _e4575 = phi_2289_;
                                                local_25 = _e4575;
                                                if (_e4573.member < _e4573.member_1) {
                                                    let _e4582 = (_e4573.member + 1i);
                                                    if ((false == (_e4582 > _e4573.member)) != false) {
                                                        phi_2310_ = true;
                                                    } else {
                                                        phi_2310_ = false;
                                                    }
                                                    let _e4587 = phi_2310_;
                                                    if _e4587 {
                                                        phi_2316_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2316_ = type_17(1u, _e4582);
                                                    }
                                                    let _e4592 = phi_2316_;
                                                    phi_2287_ = type_16(_e4592.member_1, _e4573.member_1);
                                                    phi_2330_ = type_17(1u, _e4573.member);
                                                } else {
                                                    phi_2287_ = _e4573;
                                                    phi_2330_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4598 = phi_2287_;
                                                let _e4600 = phi_2330_;
                                                let _e4603 = (bitcast<i32>(_e4600.member) != 0i);
                                                if _e4603 {
                                                    phi_2290_ = (0.5lf * (_e4575 + (_e4566 / _e4575)));
                                                } else {
                                                    phi_2290_ = f64();
                                                }
                                                let _e4608 = phi_2290_;
                                                continue;
                                                continuing {
                                                    phi_2286_ = _e4598;
                                                    phi_2289_ = _e4608;
                                                    break if !(_e4603);
                                                }
                                            }
                                            let _e4613 = local_25;
                                            phi_2343_ = (_e4613 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4620 = phi_2343_;
                                        let _e4622 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4629 = ((((((((_e4285 + _e4287) + (_e4339 + _e4341)) + (_e4393 + _e4395)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4403 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e578.member_1 * _e4620) * (f64(1f) + _e4622)));
                                        let _e4634 = (((_e4557 * _e4183[0]) + (_e4559 * _e4183[1])) + (_e4561 * _e4183[2]));
                                        let _e4639 = (((_e4557 * _e4199) + (_e4559 * _e4200)) + (_e4561 * _e4201));
                                        let _e4644 = (((_e4557 * (_e4183[0] - _e4195[0])) + (_e4559 * (_e4183[1] - _e4195[1]))) + (_e4561 * (_e4183[2] - _e4195[2])));
                                        let _e4649 = (((_e4557 * (_e4199 - _e4195[0])) + (_e4559 * (_e4200 - _e4195[1]))) + (_e4561 * (_e4201 - _e4195[2])));
                                        let _e4655 = (((_e4557 * _e4210[0]) + (_e4559 * _e4210[1])) + (_e4561 * _e4210[2]));
                                        let _e4660 = (((_e4557 * _e4226) + (_e4559 * _e4227)) + (_e4561 * _e4228));
                                        let _e4665 = (((_e4557 * (_e4210[0] - _e4222[0])) + (_e4559 * (_e4210[1] - _e4222[1]))) + (_e4561 * (_e4210[2] - _e4222[2])));
                                        let _e4670 = (((_e4557 * (_e4226 - _e4222[0])) + (_e4559 * (_e4227 - _e4222[1]))) + (_e4561 * (_e4228 - _e4222[2])));
                                        if (_e4634 < 0.0lf) {
                                            phi_2412_ = -(_e4634);
                                        } else {
                                            phi_2412_ = _e4634;
                                        }
                                        let _e4675 = phi_2412_;
                                        if (_e4655 < 0.0lf) {
                                            phi_2418_ = -(_e4655);
                                        } else {
                                            phi_2418_ = _e4655;
                                        }
                                        let _e4679 = phi_2418_;
                                        if (_e4639 < 0.0lf) {
                                            phi_2427_ = -(_e4639);
                                        } else {
                                            phi_2427_ = _e4639;
                                        }
                                        let _e4686 = phi_2427_;
                                        if (_e4660 < 0.0lf) {
                                            phi_2433_ = -(_e4660);
                                        } else {
                                            phi_2433_ = _e4660;
                                        }
                                        let _e4690 = phi_2433_;
                                        if (_e4644 < 0.0lf) {
                                            phi_2442_ = -(_e4644);
                                        } else {
                                            phi_2442_ = _e4644;
                                        }
                                        let _e4697 = phi_2442_;
                                        if (_e4665 < 0.0lf) {
                                            phi_2448_ = -(_e4665);
                                        } else {
                                            phi_2448_ = _e4665;
                                        }
                                        let _e4701 = phi_2448_;
                                        if (_e4649 < 0.0lf) {
                                            phi_2457_ = -(_e4649);
                                        } else {
                                            phi_2457_ = _e4649;
                                        }
                                        let _e4708 = phi_2457_;
                                        if (_e4670 < 0.0lf) {
                                            phi_2463_ = -(_e4670);
                                        } else {
                                            phi_2463_ = _e4670;
                                        }
                                        let _e4712 = phi_2463_;
                                        phi_2469_ = type_34(array<f64, 4>(_e4634, _e4639, _e4644, _e4649), array<f64, 4>(_e4655, _e4660, _e4665, _e4670), array<f64, 4>((_e4629 + ((_e4675 + _e4679) * _e4622)), (_e4629 + ((_e4686 + _e4690) * _e4622)), (_e4629 + ((_e4697 + _e4701) * _e4622)), (_e4629 + ((_e4708 + _e4712) * _e4622))));
                                        phi_2470_ = false;
                                    } else {
                                        phi_2469_ = type_34();
                                        phi_2470_ = true;
                                    }
                                    let _e4719 = phi_2469_;
                                    let _e4721 = phi_2470_;
                                    phi_2471_ = _e4719;
                                    phi_2472_ = _e4721;
                                } else {
                                    phi_2471_ = type_34();
                                    phi_2472_ = true;
                                }
                                let _e4723 = phi_2471_;
                                let _e4725 = phi_2472_;
                                if _e4725 {
                                    let _e4726 = f64(0f);
                                    let _e4727 = f64(1f);
                                    phi_2482_ = type_34(array<f64, 4>(_e4726, _e4726, _e4726, _e4726), array<f64, 4>(_e4726, _e4726, _e4726, _e4726), array<f64, 4>(_e4727, _e4727, _e4727, _e4727));
                                } else {
                                    phi_2482_ = _e4723;
                                }
                                let _e4733 = phi_2482_;
                                local_10 = type_34(array<f64, 4>(_e4733.member[0], _e4733.member[1], _e4733.member[2], _e4733.member[3]), array<f64, 4>(_e4733.member_1[0], _e4733.member_1[1], _e4733.member_1[2], _e4733.member_1[3]), array<f64, 4>(_e4733.member_2[0], _e4733.member_2[1], _e4733.member_2[2], _e4733.member_2[3]));
                                let _e4753 = (_e4420 - _e4426);
                                let _e4755 = f64(0f);
                                let _e4758 = local_10.member[0u];
                                let _e4761 = local_10.member_1[0u];
                                let _e4764 = local_10.member[0u];
                                let _e4770 = local_10.member_2[0u];
                                if (((_e4758 + ((_e4761 - _e4764) * _e4420)) - _e4770) > _e4755) {
                                    let _e4775 = local_10.member[1u];
                                    let _e4778 = local_10.member_1[1u];
                                    let _e4781 = local_10.member[1u];
                                    let _e4787 = local_10.member_2[1u];
                                    if (((_e4775 + ((_e4778 - _e4781) * _e4420)) - _e4787) > _e4755) {
                                        let _e4792 = local_10.member[2u];
                                        let _e4795 = local_10.member_1[2u];
                                        let _e4798 = local_10.member[2u];
                                        let _e4804 = local_10.member_2[2u];
                                        if (((_e4792 + ((_e4795 - _e4798) * _e4420)) - _e4804) > _e4755) {
                                            let _e4809 = local_10.member[3u];
                                            let _e4812 = local_10.member_1[3u];
                                            let _e4815 = local_10.member[3u];
                                            let _e4821 = local_10.member_2[3u];
                                            phi_2654_ = (((_e4809 + ((_e4812 - _e4815) * _e4420)) - _e4821) > _e4755);
                                            phi_2655_ = false;
                                        } else {
                                            phi_2654_ = bool();
                                            phi_2655_ = true;
                                        }
                                        let _e4825 = phi_2654_;
                                        let _e4827 = phi_2655_;
                                        phi_2656_ = _e4825;
                                        phi_2657_ = _e4827;
                                    } else {
                                        phi_2656_ = bool();
                                        phi_2657_ = true;
                                    }
                                    let _e4829 = phi_2656_;
                                    let _e4831 = phi_2657_;
                                    phi_2658_ = _e4829;
                                    phi_2659_ = _e4831;
                                } else {
                                    phi_2658_ = bool();
                                    phi_2659_ = true;
                                }
                                let _e4833 = phi_2658_;
                                let _e4835 = phi_2659_;
                                if _e4835 {
                                    phi_2663_ = false;
                                } else {
                                    phi_2663_ = _e4833;
                                }
                                let _e4837 = phi_2663_;
                                if _e4837 {
                                    if (_e4420 <= _e4422) {
                                        phi_2974_ = true;
                                    } else {
                                        let _e4839 = f64(0f);
                                        let _e4842 = local_9.member[0u];
                                        let _e4845 = local_9.member_1[0u];
                                        let _e4848 = local_9.member[0u];
                                        let _e4854 = local_9.member_2[0u];
                                        let _e4858 = local_10.member[0u];
                                        let _e4861 = local_10.member_1[0u];
                                        let _e4864 = local_10.member[0u];
                                        let _e4870 = local_10.member_2[0u];
                                        if ((((_e4842 + ((_e4845 - _e4848) * _e4420)) - _e4854) + ((_e4858 + ((_e4861 - _e4864) * _e4426)) - _e4870)) > _e4839) {
                                            let _e4876 = local_9.member[1u];
                                            let _e4879 = local_9.member_1[1u];
                                            let _e4882 = local_9.member[1u];
                                            let _e4888 = local_9.member_2[1u];
                                            let _e4892 = local_10.member[1u];
                                            let _e4895 = local_10.member_1[1u];
                                            let _e4898 = local_10.member[1u];
                                            let _e4904 = local_10.member_2[1u];
                                            if ((((_e4876 + ((_e4879 - _e4882) * _e4420)) - _e4888) + ((_e4892 + ((_e4895 - _e4898) * _e4426)) - _e4904)) > _e4839) {
                                                let _e4910 = local_9.member[2u];
                                                let _e4913 = local_9.member_1[2u];
                                                let _e4916 = local_9.member[2u];
                                                let _e4922 = local_9.member_2[2u];
                                                let _e4926 = local_10.member[2u];
                                                let _e4929 = local_10.member_1[2u];
                                                let _e4932 = local_10.member[2u];
                                                let _e4938 = local_10.member_2[2u];
                                                if ((((_e4910 + ((_e4913 - _e4916) * _e4420)) - _e4922) + ((_e4926 + ((_e4929 - _e4932) * _e4426)) - _e4938)) > _e4839) {
                                                    let _e4944 = local_9.member[3u];
                                                    let _e4947 = local_9.member_1[3u];
                                                    let _e4950 = local_9.member[3u];
                                                    let _e4956 = local_9.member_2[3u];
                                                    let _e4960 = local_10.member[3u];
                                                    let _e4963 = local_10.member_1[3u];
                                                    let _e4966 = local_10.member[3u];
                                                    let _e4972 = local_10.member_2[3u];
                                                    phi_2961_ = ((((_e4944 + ((_e4947 - _e4950) * _e4420)) - _e4956) + ((_e4960 + ((_e4963 - _e4966) * _e4426)) - _e4972)) > _e4839);
                                                    phi_2962_ = false;
                                                } else {
                                                    phi_2961_ = bool();
                                                    phi_2962_ = true;
                                                }
                                                let _e4977 = phi_2961_;
                                                let _e4979 = phi_2962_;
                                                phi_2963_ = _e4977;
                                                phi_2964_ = _e4979;
                                            } else {
                                                phi_2963_ = bool();
                                                phi_2964_ = true;
                                            }
                                            let _e4981 = phi_2963_;
                                            let _e4983 = phi_2964_;
                                            phi_2965_ = _e4981;
                                            phi_2966_ = _e4983;
                                        } else {
                                            phi_2965_ = bool();
                                            phi_2966_ = true;
                                        }
                                        let _e4985 = phi_2965_;
                                        let _e4987 = phi_2966_;
                                        if _e4987 {
                                            phi_2970_ = false;
                                        } else {
                                            phi_2970_ = _e4985;
                                        }
                                        let _e4989 = phi_2970_;
                                        phi_2974_ = _e4989;
                                    }
                                    let _e4991 = phi_2974_;
                                    if _e4991 {
                                        if _e4428 {
                                            if (_e4420 >= _e4179) {
                                                phi_2985_ = false;
                                            } else {
                                                phi_2985_ = true;
                                            }
                                            let _e4994 = phi_2985_;
                                            phi_2986_ = _e4994;
                                        } else {
                                            phi_2986_ = true;
                                        }
                                        let _e4996 = phi_2986_;
                                        if _e4996 {
                                            local_9 = type_34(array<f64, 4>(_e4733.member[0], _e4733.member[1], _e4733.member[2], _e4733.member[3]), array<f64, 4>(_e4733.member_1[0], _e4733.member_1[1], _e4733.member_1[2], _e4733.member_1[3]), array<f64, 4>(_e4733.member_2[0], _e4733.member_2[1], _e4733.member_2[2], _e4733.member_2[3]));
                                            let _e5018 = local_9.member[0u];
                                            let _e5021 = local_9.member_1[0u];
                                            let _e5024 = local_9.member_2[0u];
                                            if (_e5018 > _e5024) {
                                                if (_e5021 > _e5024) {
                                                    phi_3060_ = false;
                                                } else {
                                                    phi_3060_ = true;
                                                }
                                                let _e5028 = phi_3060_;
                                                phi_3061_ = _e5028;
                                            } else {
                                                phi_3061_ = true;
                                            }
                                            let _e5030 = phi_3061_;
                                            if _e5030 {
                                                let _e5031 = (_e5021 >= _e5018);
                                                if _e5031 {
                                                    phi_3086_ = f64();
                                                    phi_3087_ = false;
                                                } else {
                                                    if ((_e5018 - _e5021) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3084_ = (((_e5018 - _e5024) / (_e5018 - _e5021)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3085_ = false;
                                                    } else {
                                                        phi_3084_ = f64();
                                                        phi_3085_ = true;
                                                    }
                                                    let _e5045 = phi_3084_;
                                                    let _e5047 = phi_3085_;
                                                    phi_3086_ = _e5045;
                                                    phi_3087_ = _e5047;
                                                }
                                                let _e5049 = phi_3086_;
                                                let _e5051 = phi_3087_;
                                                phi_3088_ = _e5049;
                                                phi_3089_ = _e5031;
                                                phi_3090_ = _e5051;
                                            } else {
                                                phi_3088_ = f64();
                                                phi_3089_ = true;
                                                phi_3090_ = false;
                                            }
                                            let _e5053 = phi_3088_;
                                            let _e5055 = phi_3089_;
                                            let _e5057 = phi_3090_;
                                            if _e5055 {
                                                phi_3095_ = f64(2f);
                                                phi_3096_ = true;
                                            } else {
                                                phi_3095_ = _e4420;
                                                phi_3096_ = _e5057;
                                            }
                                            let _e5060 = phi_3095_;
                                            let _e5062 = phi_3096_;
                                            if _e5062 {
                                                phi_3100_ = _e5060;
                                            } else {
                                                phi_3100_ = _e5053;
                                            }
                                            let _e5064 = phi_3100_;
                                            let _e5067 = local_9.member[1u];
                                            let _e5070 = local_9.member_1[1u];
                                            let _e5073 = local_9.member_2[1u];
                                            if (_e5067 > _e5073) {
                                                if (_e5070 > _e5073) {
                                                    phi_3132_ = false;
                                                } else {
                                                    phi_3132_ = true;
                                                }
                                                let _e5077 = phi_3132_;
                                                phi_3133_ = _e5077;
                                            } else {
                                                phi_3133_ = true;
                                            }
                                            let _e5079 = phi_3133_;
                                            if _e5079 {
                                                let _e5080 = (_e5070 >= _e5067);
                                                if _e5080 {
                                                    phi_3158_ = f64();
                                                    phi_3159_ = false;
                                                } else {
                                                    if ((_e5067 - _e5070) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3156_ = (((_e5067 - _e5073) / (_e5067 - _e5070)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3157_ = false;
                                                    } else {
                                                        phi_3156_ = f64();
                                                        phi_3157_ = true;
                                                    }
                                                    let _e5094 = phi_3156_;
                                                    let _e5096 = phi_3157_;
                                                    phi_3158_ = _e5094;
                                                    phi_3159_ = _e5096;
                                                }
                                                let _e5098 = phi_3158_;
                                                let _e5100 = phi_3159_;
                                                phi_3160_ = _e5098;
                                                phi_3161_ = _e5080;
                                                phi_3162_ = _e5100;
                                            } else {
                                                phi_3160_ = f64();
                                                phi_3161_ = true;
                                                phi_3162_ = false;
                                            }
                                            let _e5102 = phi_3160_;
                                            let _e5104 = phi_3161_;
                                            let _e5106 = phi_3162_;
                                            if _e5104 {
                                                phi_3167_ = f64(2f);
                                                phi_3168_ = true;
                                            } else {
                                                phi_3167_ = _e4420;
                                                phi_3168_ = _e5106;
                                            }
                                            let _e5109 = phi_3167_;
                                            let _e5111 = phi_3168_;
                                            if _e5111 {
                                                phi_3172_ = _e5109;
                                            } else {
                                                phi_3172_ = _e5102;
                                            }
                                            let _e5113 = phi_3172_;
                                            if (_e5064 < _e5113) {
                                                phi_3177_ = _e5064;
                                            } else {
                                                phi_3177_ = _e5113;
                                            }
                                            let _e5116 = phi_3177_;
                                            let _e5119 = local_9.member[2u];
                                            let _e5122 = local_9.member_1[2u];
                                            let _e5125 = local_9.member_2[2u];
                                            if (_e5119 > _e5125) {
                                                if (_e5122 > _e5125) {
                                                    phi_3209_ = false;
                                                } else {
                                                    phi_3209_ = true;
                                                }
                                                let _e5129 = phi_3209_;
                                                phi_3210_ = _e5129;
                                            } else {
                                                phi_3210_ = true;
                                            }
                                            let _e5131 = phi_3210_;
                                            if _e5131 {
                                                let _e5132 = (_e5122 >= _e5119);
                                                if _e5132 {
                                                    phi_3235_ = f64();
                                                    phi_3236_ = false;
                                                } else {
                                                    if ((_e5119 - _e5122) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3233_ = (((_e5119 - _e5125) / (_e5119 - _e5122)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3234_ = false;
                                                    } else {
                                                        phi_3233_ = f64();
                                                        phi_3234_ = true;
                                                    }
                                                    let _e5146 = phi_3233_;
                                                    let _e5148 = phi_3234_;
                                                    phi_3235_ = _e5146;
                                                    phi_3236_ = _e5148;
                                                }
                                                let _e5150 = phi_3235_;
                                                let _e5152 = phi_3236_;
                                                phi_3237_ = _e5150;
                                                phi_3238_ = _e5132;
                                                phi_3239_ = _e5152;
                                            } else {
                                                phi_3237_ = f64();
                                                phi_3238_ = true;
                                                phi_3239_ = false;
                                            }
                                            let _e5154 = phi_3237_;
                                            let _e5156 = phi_3238_;
                                            let _e5158 = phi_3239_;
                                            if _e5156 {
                                                phi_3244_ = f64(2f);
                                                phi_3245_ = true;
                                            } else {
                                                phi_3244_ = _e4420;
                                                phi_3245_ = _e5158;
                                            }
                                            let _e5161 = phi_3244_;
                                            let _e5163 = phi_3245_;
                                            if _e5163 {
                                                phi_3249_ = _e5161;
                                            } else {
                                                phi_3249_ = _e5154;
                                            }
                                            let _e5165 = phi_3249_;
                                            let _e5168 = local_9.member[3u];
                                            let _e5171 = local_9.member_1[3u];
                                            let _e5174 = local_9.member_2[3u];
                                            if (_e5168 > _e5174) {
                                                if (_e5171 > _e5174) {
                                                    phi_3281_ = false;
                                                } else {
                                                    phi_3281_ = true;
                                                }
                                                let _e5178 = phi_3281_;
                                                phi_3282_ = _e5178;
                                            } else {
                                                phi_3282_ = true;
                                            }
                                            let _e5180 = phi_3282_;
                                            if _e5180 {
                                                let _e5181 = (_e5171 >= _e5168);
                                                if _e5181 {
                                                    phi_3307_ = f64();
                                                    phi_3308_ = false;
                                                } else {
                                                    if ((_e5168 - _e5171) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3305_ = (((_e5168 - _e5174) / (_e5168 - _e5171)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3306_ = false;
                                                    } else {
                                                        phi_3305_ = f64();
                                                        phi_3306_ = true;
                                                    }
                                                    let _e5195 = phi_3305_;
                                                    let _e5197 = phi_3306_;
                                                    phi_3307_ = _e5195;
                                                    phi_3308_ = _e5197;
                                                }
                                                let _e5199 = phi_3307_;
                                                let _e5201 = phi_3308_;
                                                phi_3309_ = _e5199;
                                                phi_3310_ = _e5181;
                                                phi_3311_ = _e5201;
                                            } else {
                                                phi_3309_ = f64();
                                                phi_3310_ = true;
                                                phi_3311_ = false;
                                            }
                                            let _e5203 = phi_3309_;
                                            let _e5205 = phi_3310_;
                                            let _e5207 = phi_3311_;
                                            if _e5205 {
                                                phi_3316_ = f64(2f);
                                                phi_3317_ = true;
                                            } else {
                                                phi_3316_ = _e4420;
                                                phi_3317_ = _e5207;
                                            }
                                            let _e5210 = phi_3316_;
                                            let _e5212 = phi_3317_;
                                            if _e5212 {
                                                phi_3321_ = _e5210;
                                            } else {
                                                phi_3321_ = _e5203;
                                            }
                                            let _e5214 = phi_3321_;
                                            if (_e5165 < _e5214) {
                                                phi_3326_ = _e5165;
                                            } else {
                                                phi_3326_ = _e5214;
                                            }
                                            let _e5217 = phi_3326_;
                                            if (_e5116 < _e5217) {
                                                phi_3331_ = _e5116;
                                            } else {
                                                phi_3331_ = _e5217;
                                            }
                                            let _e5220 = phi_3331_;
                                            if (_e5220 > _e4420) {
                                                phi_3336_ = _e5220;
                                            } else {
                                                phi_3336_ = _e4420;
                                            }
                                            let _e5223 = phi_3336_;
                                            let _e5224 = (_e5223 > _e4179);
                                            if _e5224 {
                                                phi_3853_ = f64();
                                                phi_3854_ = f64();
                                                phi_3855_ = false;
                                                phi_3856_ = false;
                                            } else {
                                                let _e5225 = (_e5223 - _e4420);
                                                let _e5227 = (_e5225 <= f64(0.0000000037252903f));
                                                let _e5229 = (_e5223 + f64(0.00000001f));
                                                if (_e5229 < _e4179) {
                                                    phi_3350_ = _e5229;
                                                } else {
                                                    phi_3350_ = _e4179;
                                                }
                                                let _e5232 = phi_3350_;
                                                if _e5227 {
                                                    if (_e578.member_1 > f64(0f)) {
                                                        let _e5237 = local_12.member[0u];
                                                        let _e5243 = local_12.member[1u];
                                                        let _e5259 = local_12.member_1[0u];
                                                        let _e5265 = local_12.member_1[1u];
                                                        let _e5281 = local_12.member_2[0u];
                                                        let _e5287 = local_12.member_2[1u];
                                                        let _e5301 = function_2(array<f64, 3>((_e5237[0] + ((_e5243[0] - _e5237[0]) * _e5232)), (_e5237[1] + ((_e5243[1] - _e5237[1]) * _e5232)), (_e5237[2] + ((_e5243[2] - _e5237[2]) * _e5232))), array<f64, 3>((_e5259[0] + ((_e5265[0] - _e5259[0]) * _e5232)), (_e5259[1] + ((_e5265[1] - _e5259[1]) * _e5232)), (_e5259[2] + ((_e5265[2] - _e5259[2]) * _e5232))), array<f64, 3>((_e5281[0] + ((_e5287[0] - _e5281[0]) * _e5232)), (_e5281[1] + ((_e5287[1] - _e5281[1]) * _e5232)), (_e5281[2] + ((_e5287[2] - _e5281[2]) * _e5232))), 1u);
                                                        let _e5312 = (((_e5301[0] * _e5301[0]) + (_e5301[1] * _e5301[1])) + (_e5301[2] * _e5301[2]));
                                                        if (_e5312 <= 2.2250738585072014e-308lf) {
                                                            if (_e5312 > 0.0lf) {
                                                                phi_3481_ = (1.464336215552873e-154lf * 2.0lf);
                                                            } else {
                                                                phi_3481_ = 0.0lf;
                                                            }
                                                            let _e5364 = phi_3481_;
                                                            phi_3545_ = _e5364;
                                                        } else {
                                                            phi_3488_ = type_16(0i, 5i);
                                                            phi_3491_ = bitcast<f64>(((bitcast<u64>(_e5312) / 2lu) + 2303426169912950784lu));
                                                            loop {
                                                                let _e5319 = phi_3488_;
                                                                let _e5321 = phi_3491_;
                                                                local_26 = _e5321;
                                                                if (_e5319.member < _e5319.member_1) {
                                                                    let _e5328 = (_e5319.member + 1i);
                                                                    if ((false == (_e5328 > _e5319.member)) != false) {
                                                                        phi_3512_ = true;
                                                                    } else {
                                                                        phi_3512_ = false;
                                                                    }
                                                                    let _e5333 = phi_3512_;
                                                                    if _e5333 {
                                                                        phi_3518_ = type_17(0u, type_17().member_1);
                                                                    } else {
                                                                        phi_3518_ = type_17(1u, _e5328);
                                                                    }
                                                                    let _e5338 = phi_3518_;
                                                                    phi_3489_ = type_16(_e5338.member_1, _e5319.member_1);
                                                                    phi_3532_ = type_17(1u, _e5319.member);
                                                                } else {
                                                                    phi_3489_ = _e5319;
                                                                    phi_3532_ = type_17(0u, type_17().member_1);
                                                                }
                                                                let _e5344 = phi_3489_;
                                                                let _e5346 = phi_3532_;
                                                                let _e5349 = (bitcast<i32>(_e5346.member) != 0i);
                                                                if _e5349 {
                                                                    phi_3492_ = (0.5lf * (_e5321 + (_e5312 / _e5321)));
                                                                } else {
                                                                    phi_3492_ = f64();
                                                                }
                                                                let _e5354 = phi_3492_;
                                                                continue;
                                                                continuing {
                                                                    phi_3488_ = _e5344;
                                                                    phi_3491_ = _e5354;
                                                                    break if !(_e5349);
                                                                }
                                                            }
                                                            let _e5359 = local_26;
                                                            phi_3545_ = (_e5359 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                        }
                                                        let _e5366 = phi_3545_;
                                                        let _e5374 = local_12.member[0u];
                                                        if (_e5374[0] < 0.0lf) {
                                                            phi_3563_ = -(_e5374[0]);
                                                        } else {
                                                            phi_3563_ = _e5374[0];
                                                        }
                                                        let _e5381 = phi_3563_;
                                                        if (_e5374[1] < 0.0lf) {
                                                            phi_3570_ = -(_e5374[1]);
                                                        } else {
                                                            phi_3570_ = _e5374[1];
                                                        }
                                                        let _e5385 = phi_3570_;
                                                        if (_e5381 > _e5385) {
                                                            phi_3575_ = _e5381;
                                                        } else {
                                                            phi_3575_ = _e5385;
                                                        }
                                                        let _e5388 = phi_3575_;
                                                        if (_e5374[2] < 0.0lf) {
                                                            phi_3582_ = -(_e5374[2]);
                                                        } else {
                                                            phi_3582_ = _e5374[2];
                                                        }
                                                        let _e5392 = phi_3582_;
                                                        if (_e5388 > _e5392) {
                                                            phi_3587_ = _e5388;
                                                        } else {
                                                            phi_3587_ = _e5392;
                                                        }
                                                        let _e5395 = phi_3587_;
                                                        let _e5398 = local_12.member[1u];
                                                        if (_e5398[0] < 0.0lf) {
                                                            phi_3600_ = -(_e5398[0]);
                                                        } else {
                                                            phi_3600_ = _e5398[0];
                                                        }
                                                        let _e5405 = phi_3600_;
                                                        if (_e5398[1] < 0.0lf) {
                                                            phi_3607_ = -(_e5398[1]);
                                                        } else {
                                                            phi_3607_ = _e5398[1];
                                                        }
                                                        let _e5409 = phi_3607_;
                                                        if (_e5405 > _e5409) {
                                                            phi_3612_ = _e5405;
                                                        } else {
                                                            phi_3612_ = _e5409;
                                                        }
                                                        let _e5412 = phi_3612_;
                                                        if (_e5398[2] < 0.0lf) {
                                                            phi_3619_ = -(_e5398[2]);
                                                        } else {
                                                            phi_3619_ = _e5398[2];
                                                        }
                                                        let _e5416 = phi_3619_;
                                                        if (_e5412 > _e5416) {
                                                            phi_3624_ = _e5412;
                                                        } else {
                                                            phi_3624_ = _e5416;
                                                        }
                                                        let _e5419 = phi_3624_;
                                                        if (_e5395 > _e5419) {
                                                            phi_3629_ = _e5395;
                                                        } else {
                                                            phi_3629_ = _e5419;
                                                        }
                                                        let _e5422 = phi_3629_;
                                                        let _e5424 = local_12.member_3;
                                                        let _e5428 = local_12.member_1[0u];
                                                        if (_e5428[0] < 0.0lf) {
                                                            phi_3646_ = -(_e5428[0]);
                                                        } else {
                                                            phi_3646_ = _e5428[0];
                                                        }
                                                        let _e5435 = phi_3646_;
                                                        if (_e5428[1] < 0.0lf) {
                                                            phi_3653_ = -(_e5428[1]);
                                                        } else {
                                                            phi_3653_ = _e5428[1];
                                                        }
                                                        let _e5439 = phi_3653_;
                                                        if (_e5435 > _e5439) {
                                                            phi_3658_ = _e5435;
                                                        } else {
                                                            phi_3658_ = _e5439;
                                                        }
                                                        let _e5442 = phi_3658_;
                                                        if (_e5428[2] < 0.0lf) {
                                                            phi_3665_ = -(_e5428[2]);
                                                        } else {
                                                            phi_3665_ = _e5428[2];
                                                        }
                                                        let _e5446 = phi_3665_;
                                                        if (_e5442 > _e5446) {
                                                            phi_3670_ = _e5442;
                                                        } else {
                                                            phi_3670_ = _e5446;
                                                        }
                                                        let _e5449 = phi_3670_;
                                                        let _e5452 = local_12.member_1[1u];
                                                        if (_e5452[0] < 0.0lf) {
                                                            phi_3684_ = -(_e5452[0]);
                                                        } else {
                                                            phi_3684_ = _e5452[0];
                                                        }
                                                        let _e5459 = phi_3684_;
                                                        if (_e5452[1] < 0.0lf) {
                                                            phi_3691_ = -(_e5452[1]);
                                                        } else {
                                                            phi_3691_ = _e5452[1];
                                                        }
                                                        let _e5463 = phi_3691_;
                                                        if (_e5459 > _e5463) {
                                                            phi_3696_ = _e5459;
                                                        } else {
                                                            phi_3696_ = _e5463;
                                                        }
                                                        let _e5466 = phi_3696_;
                                                        if (_e5452[2] < 0.0lf) {
                                                            phi_3703_ = -(_e5452[2]);
                                                        } else {
                                                            phi_3703_ = _e5452[2];
                                                        }
                                                        let _e5470 = phi_3703_;
                                                        if (_e5466 > _e5470) {
                                                            phi_3708_ = _e5466;
                                                        } else {
                                                            phi_3708_ = _e5470;
                                                        }
                                                        let _e5473 = phi_3708_;
                                                        if (_e5449 > _e5473) {
                                                            phi_3713_ = _e5449;
                                                        } else {
                                                            phi_3713_ = _e5473;
                                                        }
                                                        let _e5476 = phi_3713_;
                                                        let _e5478 = local_12.member_3;
                                                        let _e5482 = local_12.member_2[0u];
                                                        if (_e5482[0] < 0.0lf) {
                                                            phi_3730_ = -(_e5482[0]);
                                                        } else {
                                                            phi_3730_ = _e5482[0];
                                                        }
                                                        let _e5489 = phi_3730_;
                                                        if (_e5482[1] < 0.0lf) {
                                                            phi_3737_ = -(_e5482[1]);
                                                        } else {
                                                            phi_3737_ = _e5482[1];
                                                        }
                                                        let _e5493 = phi_3737_;
                                                        if (_e5489 > _e5493) {
                                                            phi_3742_ = _e5489;
                                                        } else {
                                                            phi_3742_ = _e5493;
                                                        }
                                                        let _e5496 = phi_3742_;
                                                        if (_e5482[2] < 0.0lf) {
                                                            phi_3749_ = -(_e5482[2]);
                                                        } else {
                                                            phi_3749_ = _e5482[2];
                                                        }
                                                        let _e5500 = phi_3749_;
                                                        if (_e5496 > _e5500) {
                                                            phi_3754_ = _e5496;
                                                        } else {
                                                            phi_3754_ = _e5500;
                                                        }
                                                        let _e5503 = phi_3754_;
                                                        let _e5506 = local_12.member_2[1u];
                                                        if (_e5506[0] < 0.0lf) {
                                                            phi_3768_ = -(_e5506[0]);
                                                        } else {
                                                            phi_3768_ = _e5506[0];
                                                        }
                                                        let _e5513 = phi_3768_;
                                                        if (_e5506[1] < 0.0lf) {
                                                            phi_3775_ = -(_e5506[1]);
                                                        } else {
                                                            phi_3775_ = _e5506[1];
                                                        }
                                                        let _e5517 = phi_3775_;
                                                        if (_e5513 > _e5517) {
                                                            phi_3780_ = _e5513;
                                                        } else {
                                                            phi_3780_ = _e5517;
                                                        }
                                                        let _e5520 = phi_3780_;
                                                        if (_e5506[2] < 0.0lf) {
                                                            phi_3787_ = -(_e5506[2]);
                                                        } else {
                                                            phi_3787_ = _e5506[2];
                                                        }
                                                        let _e5524 = phi_3787_;
                                                        if (_e5520 > _e5524) {
                                                            phi_3792_ = _e5520;
                                                        } else {
                                                            phi_3792_ = _e5524;
                                                        }
                                                        let _e5527 = phi_3792_;
                                                        if (_e5503 > _e5527) {
                                                            phi_3797_ = _e5503;
                                                        } else {
                                                            phi_3797_ = _e5527;
                                                        }
                                                        let _e5530 = phi_3797_;
                                                        let _e5532 = local_12.member_3;
                                                        let _e5540 = local_12.member_3;
                                                        if (((_e5366 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5422 + _e5424) + (_e5476 + _e5478)) + (_e5530 + _e5532)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5540 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e578.member_1) {
                                                            phi_3821_ = false;
                                                        } else {
                                                            phi_3821_ = true;
                                                        }
                                                        let _e5552 = phi_3821_;
                                                        phi_3822_ = _e5552;
                                                    } else {
                                                        phi_3822_ = true;
                                                    }
                                                    let _e5554 = phi_3822_;
                                                    phi_3823_ = _e5554;
                                                } else {
                                                    phi_3823_ = true;
                                                }
                                                let _e5556 = phi_3823_;
                                                if _e5556 {
                                                    if _e4428 {
                                                        if _e5227 {
                                                            phi_3842_ = f64();
                                                            phi_3843_ = true;
                                                        } else {
                                                            if (_e5225 <= (_e4424 * f64(0.25f))) {
                                                                phi_3840_ = f64(0f);
                                                                phi_3841_ = false;
                                                            } else {
                                                                phi_3840_ = f64();
                                                                phi_3841_ = true;
                                                            }
                                                            let _e5563 = phi_3840_;
                                                            let _e5565 = phi_3841_;
                                                            phi_3842_ = _e5563;
                                                            phi_3843_ = _e5565;
                                                        }
                                                        let _e5567 = phi_3842_;
                                                        let _e5569 = phi_3843_;
                                                        if _e5569 {
                                                            phi_3848_ = (_e4753 + _e4753);
                                                        } else {
                                                            phi_3848_ = _e5567;
                                                        }
                                                        let _e5572 = phi_3848_;
                                                        phi_3850_ = _e5572;
                                                    } else {
                                                        phi_3850_ = (_e4179 - _e4420);
                                                    }
                                                    let _e5574 = phi_3850_;
                                                    phi_3851_ = _e5574;
                                                    phi_3852_ = false;
                                                } else {
                                                    phi_3851_ = f64();
                                                    phi_3852_ = true;
                                                }
                                                let _e5576 = phi_3851_;
                                                let _e5578 = phi_3852_;
                                                phi_3853_ = _e5576;
                                                phi_3854_ = _e5225;
                                                phi_3855_ = _e5556;
                                                phi_3856_ = _e5578;
                                            }
                                            let _e5580 = phi_3853_;
                                            let _e5582 = phi_3854_;
                                            let _e5584 = phi_3855_;
                                            let _e5586 = phi_3856_;
                                            phi_3857_ = _e5223;
                                            phi_3858_ = _e5580;
                                            phi_3859_ = _e5582;
                                            phi_3860_ = _e5223;
                                            phi_3861_ = _e5584;
                                            phi_3862_ = _e5224;
                                            phi_3863_ = _e5586;
                                            phi_3864_ = false;
                                        } else {
                                            phi_3857_ = f64();
                                            phi_3858_ = f64();
                                            phi_3859_ = f64();
                                            phi_3860_ = f64();
                                            phi_3861_ = false;
                                            phi_3862_ = false;
                                            phi_3863_ = false;
                                            phi_3864_ = true;
                                        }
                                        let _e5588 = phi_3857_;
                                        let _e5590 = phi_3858_;
                                        let _e5592 = phi_3859_;
                                        let _e5594 = phi_3860_;
                                        let _e5596 = phi_3861_;
                                        let _e5598 = phi_3862_;
                                        let _e5600 = phi_3863_;
                                        let _e5602 = phi_3864_;
                                        phi_3865_ = _e5588;
                                        phi_3866_ = _e5590;
                                        phi_3867_ = _e5592;
                                        phi_3868_ = _e5594;
                                        phi_3869_ = false;
                                        phi_3870_ = _e5596;
                                        phi_3871_ = _e5598;
                                        phi_3872_ = _e5600;
                                        phi_3873_ = _e5602;
                                    } else {
                                        phi_3865_ = f64();
                                        phi_3866_ = f64();
                                        phi_3867_ = f64();
                                        phi_3868_ = f64();
                                        phi_3869_ = true;
                                        phi_3870_ = false;
                                        phi_3871_ = false;
                                        phi_3872_ = false;
                                        phi_3873_ = false;
                                    }
                                    let _e5604 = phi_3865_;
                                    let _e5606 = phi_3866_;
                                    let _e5608 = phi_3867_;
                                    let _e5610 = phi_3868_;
                                    let _e5612 = phi_3869_;
                                    let _e5614 = phi_3870_;
                                    let _e5616 = phi_3871_;
                                    let _e5618 = phi_3872_;
                                    let _e5620 = phi_3873_;
                                    phi_3874_ = _e5604;
                                    phi_3875_ = _e5606;
                                    phi_3876_ = _e5608;
                                    phi_3877_ = _e5610;
                                    phi_3878_ = _e5612;
                                    phi_3879_ = _e5614;
                                    phi_3880_ = _e5616;
                                    phi_3881_ = _e5618;
                                    phi_3882_ = _e5620;
                                } else {
                                    phi_3874_ = f64();
                                    phi_3875_ = f64();
                                    phi_3876_ = f64();
                                    phi_3877_ = f64();
                                    phi_3878_ = true;
                                    phi_3879_ = false;
                                    phi_3880_ = false;
                                    phi_3881_ = false;
                                    phi_3882_ = false;
                                }
                                let _e5622 = phi_3874_;
                                let _e5624 = phi_3875_;
                                let _e5626 = phi_3876_;
                                let _e5628 = phi_3877_;
                                let _e5630 = phi_3878_;
                                let _e5632 = phi_3879_;
                                let _e5634 = phi_3880_;
                                let _e5636 = phi_3881_;
                                let _e5638 = phi_3882_;
                                if _e5630 {
                                    if (_e4420 <= _e4422) {
                                        let _e5804 = (_e4430 + 1u);
                                        let _e5805 = (_e5804 > 3u);
                                        if _e5805 {
                                            phi_3895_ = false;
                                        } else {
                                            phi_3895_ = true;
                                        }
                                        let _e5807 = phi_3895_;
                                        phi_4222_ = _e5804;
                                        phi_4223_ = f64();
                                        phi_4224_ = false;
                                        phi_4225_ = _e5807;
                                        phi_4226_ = _e5805;
                                    } else {
                                        let _e5642 = local_9.member[0u];
                                        let _e5645 = local_9.member_1[0u];
                                        let _e5648 = local_9.member[0u];
                                        let _e5654 = local_9.member_2[0u];
                                        let _e5655 = ((_e5642 + ((_e5645 - _e5648) * _e4426)) - _e5654);
                                        let _e5658 = local_9.member[1u];
                                        let _e5661 = local_9.member_1[1u];
                                        let _e5664 = local_9.member[1u];
                                        let _e5670 = local_9.member_2[1u];
                                        let _e5671 = ((_e5658 + ((_e5661 - _e5664) * _e4426)) - _e5670);
                                        if (_e5655 < _e5671) {
                                            phi_3968_ = _e5655;
                                        } else {
                                            phi_3968_ = _e5671;
                                        }
                                        let _e5674 = phi_3968_;
                                        let _e5677 = local_9.member[2u];
                                        let _e5680 = local_9.member_1[2u];
                                        let _e5683 = local_9.member[2u];
                                        let _e5689 = local_9.member_2[2u];
                                        let _e5690 = ((_e5677 + ((_e5680 - _e5683) * _e4426)) - _e5689);
                                        let _e5693 = local_9.member[3u];
                                        let _e5696 = local_9.member_1[3u];
                                        let _e5699 = local_9.member[3u];
                                        let _e5705 = local_9.member_2[3u];
                                        let _e5706 = ((_e5693 + ((_e5696 - _e5699) * _e4426)) - _e5705);
                                        if (_e5690 < _e5706) {
                                            phi_4041_ = _e5690;
                                        } else {
                                            phi_4041_ = _e5706;
                                        }
                                        let _e5709 = phi_4041_;
                                        if (_e5674 < _e5709) {
                                            phi_4046_ = _e5674;
                                        } else {
                                            phi_4046_ = _e5709;
                                        }
                                        let _e5712 = phi_4046_;
                                        let _e5715 = local_10.member[0u];
                                        let _e5718 = local_10.member_1[0u];
                                        let _e5721 = local_10.member[0u];
                                        let _e5727 = local_10.member_2[0u];
                                        let _e5728 = ((_e5715 + ((_e5718 - _e5721) * _e4420)) - _e5727);
                                        let _e5731 = local_10.member[1u];
                                        let _e5734 = local_10.member_1[1u];
                                        let _e5737 = local_10.member[1u];
                                        let _e5743 = local_10.member_2[1u];
                                        let _e5744 = ((_e5731 + ((_e5734 - _e5737) * _e4420)) - _e5743);
                                        if (_e5728 < _e5744) {
                                            phi_4119_ = _e5728;
                                        } else {
                                            phi_4119_ = _e5744;
                                        }
                                        let _e5747 = phi_4119_;
                                        let _e5750 = local_10.member[2u];
                                        let _e5753 = local_10.member_1[2u];
                                        let _e5756 = local_10.member[2u];
                                        let _e5762 = local_10.member_2[2u];
                                        let _e5763 = ((_e5750 + ((_e5753 - _e5756) * _e4420)) - _e5762);
                                        let _e5766 = local_10.member[3u];
                                        let _e5769 = local_10.member_1[3u];
                                        let _e5772 = local_10.member[3u];
                                        let _e5778 = local_10.member_2[3u];
                                        let _e5779 = ((_e5766 + ((_e5769 - _e5772) * _e4420)) - _e5778);
                                        if (_e5763 < _e5779) {
                                            phi_4192_ = _e5763;
                                        } else {
                                            phi_4192_ = _e5779;
                                        }
                                        let _e5782 = phi_4192_;
                                        if (_e5747 < _e5782) {
                                            phi_4197_ = _e5747;
                                        } else {
                                            phi_4197_ = _e5782;
                                        }
                                        let _e5785 = phi_4197_;
                                        let _e5786 = f64(0.0625f);
                                        let _e5788 = f64(0.9f);
                                        if (_e5785 > f64(0f)) {
                                            phi_4220_ = f64(0.5f);
                                        } else {
                                            let _e5794 = (f64(0.95f) * (_e5712 / (_e5712 - _e5785)));
                                            if (_e5794 > _e5786) {
                                                if (_e5794 < _e5788) {
                                                    phi_4218_ = _e5794;
                                                } else {
                                                    phi_4218_ = _e5788;
                                                }
                                                let _e5798 = phi_4218_;
                                                phi_4219_ = _e5798;
                                            } else {
                                                phi_4219_ = _e5786;
                                            }
                                            let _e5800 = phi_4219_;
                                            phi_4220_ = _e5800;
                                        }
                                        let _e5802 = phi_4220_;
                                        phi_4222_ = u32();
                                        phi_4223_ = (_e4753 * _e5802);
                                        phi_4224_ = true;
                                        phi_4225_ = false;
                                        phi_4226_ = false;
                                    }
                                    let _e5809 = phi_4222_;
                                    let _e5811 = phi_4223_;
                                    let _e5813 = phi_4224_;
                                    let _e5815 = phi_4225_;
                                    let _e5817 = phi_4226_;
                                    phi_4227_ = _e5809;
                                    phi_4228_ = _e4422;
                                    phi_4229_ = _e5811;
                                    phi_4230_ = _e4424;
                                    phi_4231_ = _e4426;
                                    phi_4232_ = _e4428;
                                    phi_4233_ = _e4430;
                                    phi_4234_ = _e5813;
                                    phi_4235_ = _e5815;
                                    phi_4236_ = _e5817;
                                    phi_4237_ = false;
                                    phi_4238_ = false;
                                    phi_4239_ = false;
                                } else {
                                    phi_4227_ = u32();
                                    phi_4228_ = _e5622;
                                    phi_4229_ = _e5624;
                                    phi_4230_ = _e5626;
                                    phi_4231_ = _e4420;
                                    phi_4232_ = true;
                                    phi_4233_ = 0u;
                                    phi_4234_ = _e5632;
                                    phi_4235_ = false;
                                    phi_4236_ = false;
                                    phi_4237_ = _e5634;
                                    phi_4238_ = _e5636;
                                    phi_4239_ = _e5638;
                                }
                                let _e5819 = phi_4227_;
                                let _e5821 = phi_4228_;
                                let _e5823 = phi_4229_;
                                let _e5825 = phi_4230_;
                                let _e5827 = phi_4231_;
                                let _e5829 = phi_4232_;
                                let _e5831 = phi_4233_;
                                let _e5833 = phi_4234_;
                                let _e5835 = phi_4235_;
                                let _e5837 = phi_4236_;
                                let _e5839 = phi_4237_;
                                let _e5841 = phi_4238_;
                                let _e5843 = phi_4239_;
                                if _e5833 {
                                    let _e5844 = (_e5827 + _e5823);
                                    if (_e5844 > _e5821) {
                                        phi_4248_ = _e5844;
                                    } else {
                                        phi_4248_ = _e5821;
                                    }
                                    let _e5847 = phi_4248_;
                                    if (_e5847 < _e4179) {
                                        phi_4253_ = _e5847;
                                    } else {
                                        phi_4253_ = _e4179;
                                    }
                                    let _e5850 = phi_4253_;
                                    if !(_e4428) {
                                        phi_4263_ = true;
                                    } else {
                                        phi_4263_ = ((_e5850 - _e5827) > f64(0.0000000037252903f));
                                    }
                                    let _e5855 = phi_4263_;
                                    if _e5855 {
                                        phi_4267_ = false;
                                    } else {
                                        phi_4267_ = true;
                                    }
                                    let _e5857 = phi_4267_;
                                    phi_4268_ = _e5850;
                                    phi_4269_ = _e5821;
                                    phi_4270_ = _e5825;
                                    phi_4271_ = _e5827;
                                    phi_4272_ = _e5829;
                                    phi_4273_ = _e5831;
                                    phi_4274_ = _e5855;
                                    phi_4275_ = _e5857;
                                    phi_4276_ = false;
                                    phi_4277_ = false;
                                    phi_4278_ = false;
                                    phi_4279_ = false;
                                } else {
                                    phi_4268_ = _e4420;
                                    phi_4269_ = _e4422;
                                    phi_4270_ = _e4424;
                                    phi_4271_ = _e4426;
                                    phi_4272_ = _e4428;
                                    phi_4273_ = _e5819;
                                    phi_4274_ = _e5835;
                                    phi_4275_ = false;
                                    phi_4276_ = _e5837;
                                    phi_4277_ = _e5839;
                                    phi_4278_ = _e5841;
                                    phi_4279_ = _e5843;
                                }
                                let _e5859 = phi_4268_;
                                let _e5861 = phi_4269_;
                                let _e5863 = phi_4270_;
                                let _e5865 = phi_4271_;
                                let _e5867 = phi_4272_;
                                let _e5869 = phi_4273_;
                                let _e5871 = phi_4274_;
                                let _e5873 = phi_4275_;
                                let _e5875 = phi_4276_;
                                let _e5877 = phi_4277_;
                                let _e5879 = phi_4278_;
                                let _e5881 = phi_4279_;
                                phi_2057_ = _e5859;
                                phi_2059_ = _e5861;
                                phi_2061_ = _e5863;
                                phi_2063_ = _e5865;
                                phi_2065_ = _e5867;
                                phi_2067_ = _e5869;
                                phi_4280_ = _e5821;
                                phi_4281_ = _e5628;
                                phi_4282_ = _e5871;
                                phi_4283_ = _e5873;
                                phi_4284_ = _e5875;
                                phi_4285_ = _e5877;
                                phi_4286_ = _e5879;
                                phi_4287_ = false;
                                phi_4288_ = _e5881;
                            } else {
                                phi_2057_ = f64();
                                phi_2059_ = f64();
                                phi_2061_ = f64();
                                phi_2063_ = f64();
                                phi_2065_ = bool();
                                phi_2067_ = u32();
                                phi_4280_ = f64();
                                phi_4281_ = f64();
                                phi_4282_ = false;
                                phi_4283_ = false;
                                phi_4284_ = false;
                                phi_4285_ = false;
                                phi_4286_ = false;
                                phi_4287_ = true;
                                phi_4288_ = false;
                            }
                            let _e5883 = phi_2057_;
                            let _e5885 = phi_2059_;
                            let _e5887 = phi_2061_;
                            let _e5889 = phi_2063_;
                            let _e5891 = phi_2065_;
                            let _e5893 = phi_2067_;
                            let _e5895 = phi_4280_;
                            let _e5897 = phi_4281_;
                            let _e5899 = phi_4282_;
                            let _e5901 = phi_4283_;
                            let _e5903 = phi_4284_;
                            let _e5905 = phi_4285_;
                            let _e5907 = phi_4286_;
                            let _e5909 = phi_4287_;
                            let _e5911 = phi_4288_;
                            local_27 = _e5901;
                            local_48 = _e5903;
                            local_49 = _e5905;
                            local_50 = _e5907;
                            local_51 = _e5909;
                            local_52 = _e5911;
                            local_53 = _e5901;
                            local_54 = _e5897;
                            local_55 = _e5895;
                            continue;
                            continuing {
                                phi_2053_ = _e4442;
                                phi_2056_ = _e5883;
                                phi_2058_ = _e5885;
                                phi_2060_ = _e5887;
                                phi_2062_ = _e5889;
                                phi_2064_ = _e5891;
                                phi_2066_ = _e5893;
                                break if !(_e5899);
                            }
                        }
                        let _e5914 = local_27;
                        if _e5914 {
                            phi_4292_ = false;
                            phi_4293_ = false;
                            phi_4294_ = false;
                            phi_4295_ = false;
                            phi_4296_ = false;
                        } else {
                            let _e7432 = local_48;
                            phi_4292_ = _e7432;
                            let _e7435 = local_49;
                            phi_4293_ = _e7435;
                            let _e7438 = local_50;
                            phi_4294_ = _e7438;
                            let _e7441 = local_51;
                            phi_4295_ = _e7441;
                            let _e7444 = local_52;
                            phi_4296_ = _e7444;
                        }
                        let _e5916 = phi_4292_;
                        let _e5918 = phi_4293_;
                        let _e5920 = phi_4294_;
                        let _e5922 = phi_4295_;
                        let _e5924 = phi_4296_;
                        if _e5916 {
                            let _e5926 = local_28;
                            phi_4301_ = type_44(1u, _e5926);
                            phi_4302_ = false;
                            phi_4303_ = false;
                            phi_4304_ = false;
                            phi_4305_ = false;
                            phi_4306_ = false;
                        } else {
                            phi_4301_ = type_44();
                            phi_4302_ = _e5918;
                            phi_4303_ = _e5920;
                            let _e7451 = local_53;
                            phi_4304_ = _e7451;
                            phi_4305_ = _e5922;
                            phi_4306_ = _e5924;
                        }
                        let _e5929 = phi_4301_;
                        let _e5931 = phi_4302_;
                        let _e5933 = phi_4303_;
                        let _e5935 = phi_4304_;
                        let _e5937 = phi_4305_;
                        let _e5939 = phi_4306_;
                        if _e5931 {
                            phi_4311_ = type_44(0u, type_44().member_1);
                            phi_4312_ = false;
                            phi_4313_ = false;
                            phi_4314_ = false;
                            phi_4315_ = false;
                            phi_4316_ = true;
                        } else {
                            phi_4311_ = _e5929;
                            phi_4312_ = _e5933;
                            phi_4313_ = _e5935;
                            phi_4314_ = _e5937;
                            phi_4315_ = _e5939;
                            phi_4316_ = _e5916;
                        }
                        let _e5943 = phi_4311_;
                        let _e5945 = phi_4312_;
                        let _e5947 = phi_4313_;
                        let _e5949 = phi_4314_;
                        let _e5951 = phi_4315_;
                        let _e5953 = phi_4316_;
                        if _e5945 {
                            let _e7462 = local_54;
                            phi_4320_ = _e7462;
                            phi_4321_ = true;
                            phi_4322_ = false;
                            phi_4323_ = false;
                            phi_4324_ = false;
                        } else {
                            let _e7464 = local_55;
                            phi_4320_ = _e7464;
                            phi_4321_ = _e5947;
                            phi_4322_ = _e5949;
                            phi_4323_ = _e5951;
                            phi_4324_ = _e5953;
                        }
                        let _e5955 = phi_4320_;
                        let _e5957 = phi_4321_;
                        let _e5959 = phi_4322_;
                        let _e5961 = phi_4323_;
                        let _e5963 = phi_4324_;
                        if _e5957 {
                            phi_4328_ = _e5955;
                            phi_4329_ = true;
                            phi_4330_ = false;
                            phi_4331_ = false;
                        } else {
                            let _e7471 = local_56;
                            phi_4328_ = _e7471;
                            phi_4329_ = _e5959;
                            phi_4330_ = _e5961;
                            phi_4331_ = _e5963;
                        }
                        let _e5965 = phi_4328_;
                        let _e5967 = phi_4329_;
                        let _e5969 = phi_4330_;
                        let _e5971 = phi_4331_;
                        if _e5967 {
                            phi_4336_ = type_44(1u, _e5965);
                            phi_4337_ = false;
                            phi_4338_ = false;
                        } else {
                            phi_4336_ = type_44();
                            phi_4337_ = _e5969;
                            phi_4338_ = _e5971;
                        }
                        let _e5974 = phi_4336_;
                        let _e5976 = phi_4337_;
                        let _e5978 = phi_4338_;
                        if _e5976 {
                            phi_4343_ = type_44(0u, type_44().member_1);
                            phi_4344_ = true;
                        } else {
                            phi_4343_ = _e5943;
                            phi_4344_ = _e5978;
                        }
                        let _e5982 = phi_4343_;
                        let _e5984 = phi_4344_;
                        if _e5984 {
                            phi_4348_ = _e5982;
                        } else {
                            phi_4348_ = _e5974;
                        }
                        let _e5986 = phi_4348_;
                        if (_e5986.member != 0u) {
                            local_11[0u] = 0.00000001f;
                            local_11[1u] = 0f;
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4361_ = type_12(0u, 3u);
                            loop {
                                let _e5997 = phi_4361_;
                                if (_e5997.member < _e5997.member_1) {
                                    phi_4362_ = type_12((_e5997.member + 1u), _e5997.member_1);
                                    phi_4385_ = type_12(1u, _e5997.member);
                                } else {
                                    phi_4362_ = _e5997;
                                    phi_4385_ = type_12(0u, type_12().member_1);
                                }
                                let _e6009 = phi_4362_;
                                let _e6011 = phi_4385_;
                                if (bitcast<i32>(_e6011.member) != 0i) {
                                    let _e6017 = local_11[_e6011.member_1];
                                    let _e6019 = (_e5986.member_1 + f64(_e6017));
                                    if (_e6019 < _e4179) {
                                        phi_4406_ = _e6019;
                                    } else {
                                        phi_4406_ = _e4179;
                                    }
                                    let _e6022 = phi_4406_;
                                    let _e6025 = local_12.member[0u];
                                    let _e6031 = local_12.member[1u];
                                    let _e6047 = local_12.member_1[0u];
                                    let _e6053 = local_12.member_1[1u];
                                    let _e6069 = local_12.member_2[0u];
                                    let _e6075 = local_12.member_2[1u];
                                    let _e6089 = function_2(array<f64, 3>((_e6025[0] + ((_e6031[0] - _e6025[0]) * _e6022)), (_e6025[1] + ((_e6031[1] - _e6025[1]) * _e6022)), (_e6025[2] + ((_e6031[2] - _e6025[2]) * _e6022))), array<f64, 3>((_e6047[0] + ((_e6053[0] - _e6047[0]) * _e6022)), (_e6047[1] + ((_e6053[1] - _e6047[1]) * _e6022)), (_e6047[2] + ((_e6053[2] - _e6047[2]) * _e6022))), array<f64, 3>((_e6069[0] + ((_e6075[0] - _e6069[0]) * _e6022)), (_e6069[1] + ((_e6075[1] - _e6069[1]) * _e6022)), (_e6069[2] + ((_e6075[2] - _e6069[2]) * _e6022))), 1u);
                                    let _e6100 = (((_e6089[0] * _e6089[0]) + (_e6089[1] * _e6089[1])) + (_e6089[2] * _e6089[2]));
                                    if (_e6100 <= 2.2250738585072014e-308lf) {
                                        if (_e6100 > 0.0lf) {
                                            phi_4529_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_4529_ = 0.0lf;
                                        }
                                        let _e6152 = phi_4529_;
                                        phi_4593_ = _e6152;
                                    } else {
                                        phi_4536_ = type_16(0i, 5i);
                                        phi_4539_ = bitcast<f64>(((bitcast<u64>(_e6100) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e6107 = phi_4536_;
                                            let _e6109 = phi_4539_;
                                            local_29 = _e6109;
                                            if (_e6107.member < _e6107.member_1) {
                                                let _e6116 = (_e6107.member + 1i);
                                                if ((false == (_e6116 > _e6107.member)) != false) {
                                                    phi_4560_ = true;
                                                } else {
                                                    phi_4560_ = false;
                                                }
                                                let _e6121 = phi_4560_;
                                                if _e6121 {
                                                    phi_4566_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4566_ = type_17(1u, _e6116);
                                                }
                                                let _e6126 = phi_4566_;
                                                phi_4537_ = type_16(_e6126.member_1, _e6107.member_1);
                                                phi_4580_ = type_17(1u, _e6107.member);
                                            } else {
                                                phi_4537_ = _e6107;
                                                phi_4580_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e6132 = phi_4537_;
                                            let _e6134 = phi_4580_;
                                            let _e6137 = (bitcast<i32>(_e6134.member) != 0i);
                                            if _e6137 {
                                                phi_4540_ = (0.5lf * (_e6109 + (_e6100 / _e6109)));
                                            } else {
                                                phi_4540_ = f64();
                                            }
                                            let _e6142 = phi_4540_;
                                            continue;
                                            continuing {
                                                phi_4536_ = _e6132;
                                                phi_4539_ = _e6142;
                                                break if !(_e6137);
                                            }
                                        }
                                        let _e6147 = local_29;
                                        phi_4593_ = (_e6147 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e6154 = phi_4593_;
                                    let _e6162 = local_12.member[0u];
                                    if (_e6162[0] < 0.0lf) {
                                        phi_4611_ = -(_e6162[0]);
                                    } else {
                                        phi_4611_ = _e6162[0];
                                    }
                                    let _e6169 = phi_4611_;
                                    if (_e6162[1] < 0.0lf) {
                                        phi_4618_ = -(_e6162[1]);
                                    } else {
                                        phi_4618_ = _e6162[1];
                                    }
                                    let _e6173 = phi_4618_;
                                    if (_e6169 > _e6173) {
                                        phi_4623_ = _e6169;
                                    } else {
                                        phi_4623_ = _e6173;
                                    }
                                    let _e6176 = phi_4623_;
                                    if (_e6162[2] < 0.0lf) {
                                        phi_4630_ = -(_e6162[2]);
                                    } else {
                                        phi_4630_ = _e6162[2];
                                    }
                                    let _e6180 = phi_4630_;
                                    if (_e6176 > _e6180) {
                                        phi_4635_ = _e6176;
                                    } else {
                                        phi_4635_ = _e6180;
                                    }
                                    let _e6183 = phi_4635_;
                                    let _e6186 = local_12.member[1u];
                                    if (_e6186[0] < 0.0lf) {
                                        phi_4648_ = -(_e6186[0]);
                                    } else {
                                        phi_4648_ = _e6186[0];
                                    }
                                    let _e6193 = phi_4648_;
                                    if (_e6186[1] < 0.0lf) {
                                        phi_4655_ = -(_e6186[1]);
                                    } else {
                                        phi_4655_ = _e6186[1];
                                    }
                                    let _e6197 = phi_4655_;
                                    if (_e6193 > _e6197) {
                                        phi_4660_ = _e6193;
                                    } else {
                                        phi_4660_ = _e6197;
                                    }
                                    let _e6200 = phi_4660_;
                                    if (_e6186[2] < 0.0lf) {
                                        phi_4667_ = -(_e6186[2]);
                                    } else {
                                        phi_4667_ = _e6186[2];
                                    }
                                    let _e6204 = phi_4667_;
                                    if (_e6200 > _e6204) {
                                        phi_4672_ = _e6200;
                                    } else {
                                        phi_4672_ = _e6204;
                                    }
                                    let _e6207 = phi_4672_;
                                    if (_e6183 > _e6207) {
                                        phi_4677_ = _e6183;
                                    } else {
                                        phi_4677_ = _e6207;
                                    }
                                    let _e6210 = phi_4677_;
                                    let _e6212 = local_12.member_3;
                                    let _e6216 = local_12.member_1[0u];
                                    if (_e6216[0] < 0.0lf) {
                                        phi_4694_ = -(_e6216[0]);
                                    } else {
                                        phi_4694_ = _e6216[0];
                                    }
                                    let _e6223 = phi_4694_;
                                    if (_e6216[1] < 0.0lf) {
                                        phi_4701_ = -(_e6216[1]);
                                    } else {
                                        phi_4701_ = _e6216[1];
                                    }
                                    let _e6227 = phi_4701_;
                                    if (_e6223 > _e6227) {
                                        phi_4706_ = _e6223;
                                    } else {
                                        phi_4706_ = _e6227;
                                    }
                                    let _e6230 = phi_4706_;
                                    if (_e6216[2] < 0.0lf) {
                                        phi_4713_ = -(_e6216[2]);
                                    } else {
                                        phi_4713_ = _e6216[2];
                                    }
                                    let _e6234 = phi_4713_;
                                    if (_e6230 > _e6234) {
                                        phi_4718_ = _e6230;
                                    } else {
                                        phi_4718_ = _e6234;
                                    }
                                    let _e6237 = phi_4718_;
                                    let _e6240 = local_12.member_1[1u];
                                    if (_e6240[0] < 0.0lf) {
                                        phi_4732_ = -(_e6240[0]);
                                    } else {
                                        phi_4732_ = _e6240[0];
                                    }
                                    let _e6247 = phi_4732_;
                                    if (_e6240[1] < 0.0lf) {
                                        phi_4739_ = -(_e6240[1]);
                                    } else {
                                        phi_4739_ = _e6240[1];
                                    }
                                    let _e6251 = phi_4739_;
                                    if (_e6247 > _e6251) {
                                        phi_4744_ = _e6247;
                                    } else {
                                        phi_4744_ = _e6251;
                                    }
                                    let _e6254 = phi_4744_;
                                    if (_e6240[2] < 0.0lf) {
                                        phi_4751_ = -(_e6240[2]);
                                    } else {
                                        phi_4751_ = _e6240[2];
                                    }
                                    let _e6258 = phi_4751_;
                                    if (_e6254 > _e6258) {
                                        phi_4756_ = _e6254;
                                    } else {
                                        phi_4756_ = _e6258;
                                    }
                                    let _e6261 = phi_4756_;
                                    if (_e6237 > _e6261) {
                                        phi_4761_ = _e6237;
                                    } else {
                                        phi_4761_ = _e6261;
                                    }
                                    let _e6264 = phi_4761_;
                                    let _e6266 = local_12.member_3;
                                    let _e6270 = local_12.member_2[0u];
                                    if (_e6270[0] < 0.0lf) {
                                        phi_4778_ = -(_e6270[0]);
                                    } else {
                                        phi_4778_ = _e6270[0];
                                    }
                                    let _e6277 = phi_4778_;
                                    if (_e6270[1] < 0.0lf) {
                                        phi_4785_ = -(_e6270[1]);
                                    } else {
                                        phi_4785_ = _e6270[1];
                                    }
                                    let _e6281 = phi_4785_;
                                    if (_e6277 > _e6281) {
                                        phi_4790_ = _e6277;
                                    } else {
                                        phi_4790_ = _e6281;
                                    }
                                    let _e6284 = phi_4790_;
                                    if (_e6270[2] < 0.0lf) {
                                        phi_4797_ = -(_e6270[2]);
                                    } else {
                                        phi_4797_ = _e6270[2];
                                    }
                                    let _e6288 = phi_4797_;
                                    if (_e6284 > _e6288) {
                                        phi_4802_ = _e6284;
                                    } else {
                                        phi_4802_ = _e6288;
                                    }
                                    let _e6291 = phi_4802_;
                                    let _e6294 = local_12.member_2[1u];
                                    if (_e6294[0] < 0.0lf) {
                                        phi_4816_ = -(_e6294[0]);
                                    } else {
                                        phi_4816_ = _e6294[0];
                                    }
                                    let _e6301 = phi_4816_;
                                    if (_e6294[1] < 0.0lf) {
                                        phi_4823_ = -(_e6294[1]);
                                    } else {
                                        phi_4823_ = _e6294[1];
                                    }
                                    let _e6305 = phi_4823_;
                                    if (_e6301 > _e6305) {
                                        phi_4828_ = _e6301;
                                    } else {
                                        phi_4828_ = _e6305;
                                    }
                                    let _e6308 = phi_4828_;
                                    if (_e6294[2] < 0.0lf) {
                                        phi_4835_ = -(_e6294[2]);
                                    } else {
                                        phi_4835_ = _e6294[2];
                                    }
                                    let _e6312 = phi_4835_;
                                    if (_e6308 > _e6312) {
                                        phi_4840_ = _e6308;
                                    } else {
                                        phi_4840_ = _e6312;
                                    }
                                    let _e6315 = phi_4840_;
                                    if (_e6291 > _e6315) {
                                        phi_4845_ = _e6291;
                                    } else {
                                        phi_4845_ = _e6315;
                                    }
                                    let _e6318 = phi_4845_;
                                    let _e6320 = local_12.member_3;
                                    let _e6328 = local_12.member_3;
                                    let _e6338 = (((_e6154 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6210 + _e6212) + (_e6264 + _e6266)) + (_e6318 + _e6320)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6328 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e578.member_1);
                                    if _e6338 {
                                        phi_4869_ = false;
                                    } else {
                                        phi_4869_ = true;
                                    }
                                    let _e6340 = phi_4869_;
                                    phi_4870_ = _e6340;
                                    phi_4871_ = _e6338;
                                } else {
                                    phi_4870_ = false;
                                    phi_4871_ = false;
                                }
                                let _e6342 = phi_4870_;
                                let _e6344 = phi_4871_;
                                local_30 = _e6344;
                                continue;
                                continuing {
                                    phi_4361_ = _e6009;
                                    break if !(_e6342);
                                }
                            }
                            let _e6347 = local_30;
                            if _e6347 {
                                phi_4876_ = type_44(1u, _e5986.member_1);
                                phi_4877_ = false;
                            } else {
                                phi_4876_ = type_44();
                                phi_4877_ = true;
                            }
                            let _e6350 = phi_4876_;
                            let _e6352 = phi_4877_;
                            if _e6352 {
                                phi_4882_ = type_44(2u, _e5986.member_1);
                                phi_4883_ = false;
                            } else {
                                phi_4882_ = type_44();
                                phi_4883_ = true;
                            }
                            let _e6355 = phi_4882_;
                            let _e6357 = phi_4883_;
                            phi_4885_ = _e6355;
                            phi_4886_ = _e6350;
                            phi_4887_ = _e6357;
                        } else {
                            phi_4885_ = type_44();
                            phi_4886_ = type_44(0u, type_44().member_1);
                            phi_4887_ = true;
                        }
                        let _e6359 = phi_4885_;
                        let _e6361 = phi_4886_;
                        let _e6363 = phi_4887_;
                        if _e6363 {
                            phi_4891_ = _e6361;
                        } else {
                            phi_4891_ = _e6359;
                        }
                        let _e6365 = phi_4891_;
                        phi_9462_ = _e6365;
                    } else {
                        if (_e716 < 0.0lf) {
                            phi_4902_ = -(_e716);
                        } else {
                            phi_4902_ = _e716;
                        }
                        let _e1073 = phi_4902_;
                        if (_e739 < 0.0lf) {
                            phi_4908_ = -(_e739);
                        } else {
                            phi_4908_ = _e739;
                        }
                        let _e1077 = phi_4908_;
                        if (_e1073 > _e1077) {
                            phi_4913_ = _e1073;
                        } else {
                            phi_4913_ = _e1077;
                        }
                        let _e1080 = phi_4913_;
                        if (_e762 < 0.0lf) {
                            phi_4919_ = -(_e762);
                        } else {
                            phi_4919_ = _e762;
                        }
                        let _e1084 = phi_4919_;
                        if (_e773 < 0.0lf) {
                            phi_4925_ = -(_e773);
                        } else {
                            phi_4925_ = _e773;
                        }
                        let _e1088 = phi_4925_;
                        if (_e1084 > _e1088) {
                            phi_4930_ = _e1084;
                        } else {
                            phi_4930_ = _e1088;
                        }
                        let _e1091 = phi_4930_;
                        if (_e1080 > _e1091) {
                            phi_4935_ = _e1080;
                        } else {
                            phi_4935_ = _e1091;
                        }
                        let _e1094 = phi_4935_;
                        let _e1096 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1097 = f64(1f);
                        if (_e1094 >= _e1096) {
                            phi_4945_ = (_e1094 <= (_e1097 / _e1096));
                        } else {
                            phi_4945_ = false;
                        }
                        let _e1102 = phi_4945_;
                        if _e1102 {
                            phi_4952_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4952_ = f64(2f);
                        }
                        let _e1107 = phi_4952_;
                        let _e1109 = ((_e1032 * f64(0.34f)) + (_e1094 * _e1107));
                        if _e1102 {
                            phi_4960_ = (_e1097 / _e1094);
                        } else {
                            phi_4960_ = f64(0f);
                        }
                        let _e1113 = phi_4960_;
                        let _e1114 = f64(0f);
                        let _e1115 = f64(1f);
                        let _e1116 = f64(3f);
                        let _e1122 = ((_e739 - (_e1116 * _e716)) * _e1113);
                        let _e1123 = ((_e762 - _e739) * _e1113);
                        let _e1124 = (((_e1116 * _e773) - _e762) * _e1113);
                        local_6[0u] = _e1114;
                        local_6[1u] = _e1115;
                        local_6[2u] = _e1115;
                        local_6[3u] = _e1115;
                        let _e1131 = ((_e1123 * _e1123) - (_e1122 * _e1124));
                        if (_e1131 > _e1114) {
                            if (_e1131 <= 2.2250738585072014e-308lf) {
                                if (_e1131 > 0.0lf) {
                                    phi_4996_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4996_ = 0.0lf;
                                }
                                let _e1184 = phi_4996_;
                                phi_5060_ = _e1184;
                            } else {
                                phi_5003_ = type_16(0i, 5i);
                                phi_5006_ = bitcast<f64>(((bitcast<u64>(_e1131) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1139 = phi_5003_;
                                    let _e1141 = phi_5006_;
                                    local_13 = _e1141;
                                    if (_e1139.member < _e1139.member_1) {
                                        let _e1148 = (_e1139.member + 1i);
                                        if ((false == (_e1148 > _e1139.member)) != false) {
                                            phi_5027_ = true;
                                        } else {
                                            phi_5027_ = false;
                                        }
                                        let _e1153 = phi_5027_;
                                        if _e1153 {
                                            phi_5033_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_5033_ = type_17(1u, _e1148);
                                        }
                                        let _e1158 = phi_5033_;
                                        phi_5004_ = type_16(_e1158.member_1, _e1139.member_1);
                                        phi_5047_ = type_17(1u, _e1139.member);
                                    } else {
                                        phi_5004_ = _e1139;
                                        phi_5047_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1164 = phi_5004_;
                                    let _e1166 = phi_5047_;
                                    let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                                    if _e1169 {
                                        phi_5007_ = (0.5lf * (_e1141 + (_e1131 / _e1141)));
                                    } else {
                                        phi_5007_ = f64();
                                    }
                                    let _e1174 = phi_5007_;
                                    continue;
                                    continuing {
                                        phi_5003_ = _e1164;
                                        phi_5006_ = _e1174;
                                        break if !(_e1169);
                                    }
                                }
                                let _e1179 = local_13;
                                phi_5060_ = (_e1179 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1186 = phi_5060_;
                            if (_e1123 < _e1114) {
                                phi_5066_ = -(_e1186);
                            } else {
                                phi_5066_ = _e1186;
                            }
                            let _e1190 = phi_5066_;
                            let _e1192 = -((_e1123 + _e1190));
                            local_7[0u] = (_e1192 / (_e1192 + _e1124));
                            local_7[1u] = (_e1122 / (_e1122 + _e1192));
                            let _e1201 = local_7[1u];
                            let _e1202 = local_7[0u];
                            if (_e1201 < _e1202) {
                                let _e1205 = local_7[1u];
                                let _e1207 = local_7[0u];
                                local_7[0u] = _e1205;
                                local_7[1u] = _e1207;
                            }
                            phi_5091_ = type_12(0u, 2u);
                            phi_5094_ = 1u;
                            loop {
                                let _e1211 = phi_5091_;
                                let _e1213 = phi_5094_;
                                local_31 = _e1213;
                                if (_e1211.member < _e1211.member_1) {
                                    phi_5092_ = type_12((_e1211.member + 1u), _e1211.member_1);
                                    phi_5117_ = type_12(1u, _e1211.member);
                                } else {
                                    phi_5092_ = _e1211;
                                    phi_5117_ = type_12(0u, type_12().member_1);
                                }
                                let _e1225 = phi_5092_;
                                let _e1227 = phi_5117_;
                                let _e1231 = (bitcast<i32>(_e1227.member) != 0i);
                                if _e1231 {
                                    let _e1233 = local_7[_e1227.member_1];
                                    if (_e1233 > _e1114) {
                                        let _e1236 = local_7[_e1227.member_1];
                                        if (_e1236 < _e1115) {
                                            let _e1239 = local_7[_e1227.member_1];
                                            local_6[_e1213] = _e1239;
                                            phi_5161_ = (_e1213 + 1u);
                                        } else {
                                            phi_5161_ = _e1213;
                                        }
                                        let _e1243 = phi_5161_;
                                        phi_5162_ = _e1243;
                                    } else {
                                        phi_5162_ = _e1213;
                                    }
                                    let _e1245 = phi_5162_;
                                    phi_5095_ = _e1245;
                                } else {
                                    phi_5095_ = u32();
                                }
                                let _e1247 = phi_5095_;
                                continue;
                                continuing {
                                    phi_5091_ = _e1225;
                                    phi_5094_ = _e1247;
                                    break if !(_e1231);
                                }
                            }
                            let _e6591 = local_31;
                            phi_5163_ = _e6591;
                        } else {
                            phi_5163_ = 1u;
                        }
                        let _e1250 = phi_5163_;
                        local_6[_e1250] = _e1115;
                        let _e1252 = local_6;
                        local_8 = _e1252;
                        phi_5183_ = type_12(0u, _e1250);
                        loop {
                            let _e1255 = phi_5183_;
                            if (_e1255.member < _e1255.member_1) {
                                phi_5184_ = type_12((_e1255.member + 1u), _e1255.member_1);
                                phi_5207_ = type_12(1u, _e1255.member);
                            } else {
                                phi_5184_ = _e1255;
                                phi_5207_ = type_12(0u, type_12().member_1);
                            }
                            let _e1267 = phi_5184_;
                            let _e1269 = phi_5207_;
                            if (bitcast<i32>(_e1269.member) != 0i) {
                                let _e1275 = local_8[_e1269.member_1];
                                let _e1278 = local_8[(_e1269.member_1 + 1u)];
                                let _e1280 = (f64(1f) - _e1275);
                                let _e1291 = ((((_e716 * _e1280) + (_e739 * _e1275)) * (_e1280 * _e1280)) + (((_e762 * _e1280) + (_e773 * _e1275)) * (_e1275 * _e1275)));
                                let _e1293 = (f64(1f) - _e1278);
                                let _e1304 = ((((_e716 * _e1293) + (_e739 * _e1278)) * (_e1293 * _e1293)) + (((_e762 * _e1293) + (_e773 * _e1278)) * (_e1278 * _e1278)));
                                if (_e1291 < 0.0lf) {
                                    phi_5261_ = -(_e1291);
                                } else {
                                    phi_5261_ = _e1291;
                                }
                                let _e1308 = phi_5261_;
                                let _e1309 = (_e1308 > _e1109);
                                if (_e1304 < 0.0lf) {
                                    phi_5268_ = -(_e1304);
                                } else {
                                    phi_5268_ = _e1304;
                                }
                                let _e1313 = phi_5268_;
                                let _e1314 = (_e1313 > _e1109);
                                let _e1315 = f64(0f);
                                if _e1309 {
                                    if _e1314 {
                                        phi_5280_ = ((_e1291 > _e1315) != (_e1304 > _e1315));
                                        phi_5281_ = false;
                                    } else {
                                        phi_5280_ = bool();
                                        phi_5281_ = true;
                                    }
                                    let _e1320 = phi_5280_;
                                    let _e1322 = phi_5281_;
                                    phi_5282_ = _e1320;
                                    phi_5283_ = _e1322;
                                } else {
                                    phi_5282_ = bool();
                                    phi_5283_ = true;
                                }
                                let _e1324 = phi_5282_;
                                let _e1326 = phi_5283_;
                                if _e1326 {
                                    phi_5287_ = false;
                                } else {
                                    phi_5287_ = _e1324;
                                }
                                let _e1328 = phi_5287_;
                                if _e1309 {
                                    if _e1314 {
                                        if _e1328 {
                                            phi_5299_ = type_45();
                                        } else {
                                            phi_5299_ = type_45(f64(1f), _e1315, _e1328);
                                        }
                                        let _e1332 = phi_5299_;
                                        phi_5300_ = _e1332;
                                        phi_5301_ = _e1328;
                                    } else {
                                        phi_5300_ = type_45();
                                        phi_5301_ = true;
                                    }
                                    let _e1334 = phi_5300_;
                                    let _e1336 = phi_5301_;
                                    phi_5302_ = _e1334;
                                    phi_5303_ = _e1336;
                                } else {
                                    phi_5302_ = type_45();
                                    phi_5303_ = true;
                                }
                                let _e1338 = phi_5302_;
                                let _e1340 = phi_5303_;
                                if _e1340 {
                                    if _e1309 {
                                        if (_e1291 < _e1315) {
                                            phi_5316_ = f64(-1f);
                                        } else {
                                            phi_5316_ = f64(1f);
                                        }
                                        let _e1345 = phi_5316_;
                                        let _e1346 = f64(0.00000000000022737368f);
                                        let _e1347 = f64(0.5f);
                                        let _e1348 = f64(3f);
                                        let _e1351 = (_e762 - _e739);
                                        phi_5329_ = type_12(0u, 64u);
                                        phi_5332_ = _e1278;
                                        phi_5334_ = _e1275;
                                        phi_5336_ = (_e1347 * (_e1275 + _e1278));
                                        loop {
                                            let _e1357 = phi_5329_;
                                            let _e1359 = phi_5332_;
                                            let _e1361 = phi_5334_;
                                            let _e1363 = phi_5336_;
                                            local_33 = _e1361;
                                            if (_e1357.member < _e1357.member_1) {
                                                phi_5330_ = type_12((_e1357.member + 1u), _e1357.member_1);
                                                phi_5359_ = type_12(1u, _e1357.member);
                                            } else {
                                                phi_5330_ = _e1357;
                                                phi_5359_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1375 = phi_5330_;
                                            let _e1377 = phi_5359_;
                                            if (bitcast<i32>(_e1377.member) != 0i) {
                                                let _e1382 = (f64(1f) - _e1363);
                                                let _e1395 = ((_e1345 * ((((_e716 * _e1382) + (_e739 * _e1363)) * (_e1382 * _e1382)) + (((_e762 * _e1382) + (_e773 * _e1363)) * (_e1363 * _e1363)))) - _e1109);
                                                if (_e1395 > f64(0f)) {
                                                    phi_5386_ = _e1359;
                                                    phi_5387_ = _e1363;
                                                } else {
                                                    phi_5386_ = _e1363;
                                                    phi_5387_ = _e1361;
                                                }
                                                let _e1399 = phi_5386_;
                                                let _e1401 = phi_5387_;
                                                let _e1403 = ((_e1399 - _e1401) > _e1346);
                                                if _e1403 {
                                                    let _e1405 = (f64(1f) - _e1363);
                                                    let _e1417 = (-(_e1395) / (_e1345 * (((((_e739 - (_e1348 * _e716)) * _e1405) + (_e1351 * _e1363)) * _e1405) + (((_e1351 * _e1405) + (((_e1348 * _e773) - _e762) * _e1363)) * _e1363))));
                                                    if (_e1395 > f64(0f)) {
                                                        phi_5415_ = (_e1347 * _e1346);
                                                    } else {
                                                        phi_5415_ = -((_e1347 * _e1346));
                                                    }
                                                    let _e1424 = phi_5415_;
                                                    let _e1426 = ((_e1363 + _e1417) + _e1424);
                                                    if (_e1426 > _e1401) {
                                                        if (_e1426 < _e1399) {
                                                            if (_e1417 < 0.0lf) {
                                                                phi_5431_ = -(_e1417);
                                                            } else {
                                                                phi_5431_ = _e1417;
                                                            }
                                                            let _e1432 = phi_5431_;
                                                            if (_e1432 < (_e1347 * (_e1399 - _e1401))) {
                                                                phi_5438_ = false;
                                                            } else {
                                                                phi_5438_ = true;
                                                            }
                                                            let _e1437 = phi_5438_;
                                                            phi_5439_ = _e1437;
                                                        } else {
                                                            phi_5439_ = true;
                                                        }
                                                        let _e1439 = phi_5439_;
                                                        phi_5440_ = _e1439;
                                                    } else {
                                                        phi_5440_ = true;
                                                    }
                                                    let _e1441 = phi_5440_;
                                                    if _e1441 {
                                                        phi_5446_ = (_e1347 * (_e1401 + _e1399));
                                                    } else {
                                                        phi_5446_ = _e1426;
                                                    }
                                                    let _e1445 = phi_5446_;
                                                    phi_5447_ = _e1445;
                                                    phi_5448_ = false;
                                                } else {
                                                    phi_5447_ = f64();
                                                    phi_5448_ = true;
                                                }
                                                let _e1447 = phi_5447_;
                                                let _e1449 = phi_5448_;
                                                phi_5333_ = _e1399;
                                                phi_5335_ = _e1401;
                                                phi_5337_ = _e1447;
                                                phi_5449_ = _e1401;
                                                phi_5450_ = _e1403;
                                                phi_5451_ = _e1449;
                                            } else {
                                                phi_5333_ = f64();
                                                phi_5335_ = f64();
                                                phi_5337_ = f64();
                                                phi_5449_ = f64();
                                                phi_5450_ = false;
                                                phi_5451_ = false;
                                            }
                                            let _e1451 = phi_5333_;
                                            let _e1453 = phi_5335_;
                                            let _e1455 = phi_5337_;
                                            let _e1457 = phi_5449_;
                                            let _e1459 = phi_5450_;
                                            let _e1461 = phi_5451_;
                                            local_14 = _e1461;
                                            local_32 = _e1457;
                                            continue;
                                            continuing {
                                                phi_5329_ = _e1375;
                                                phi_5332_ = _e1451;
                                                phi_5334_ = _e1453;
                                                phi_5336_ = _e1455;
                                                break if !(_e1459);
                                            }
                                        }
                                        let _e1464 = local_14;
                                        if _e1464 {
                                            let _e6633 = local_32;
                                            phi_5455_ = _e6633;
                                        } else {
                                            let _e6635 = local_33;
                                            phi_5455_ = _e6635;
                                        }
                                        let _e1466 = phi_5455_;
                                        phi_5456_ = _e1466;
                                    } else {
                                        phi_5456_ = _e1275;
                                    }
                                    let _e1468 = phi_5456_;
                                    if _e1314 {
                                        if (_e1304 < _e1315) {
                                            phi_5466_ = f64(-1f);
                                        } else {
                                            phi_5466_ = f64(1f);
                                        }
                                        let _e1473 = phi_5466_;
                                        phi_5471_ = type_12(0u, 64u);
                                        phi_5474_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1477 = phi_5471_;
                                            let _e1479 = phi_5474_;
                                            if (_e1477.member < _e1477.member_1) {
                                                phi_5472_ = type_12((_e1477.member + 1u), _e1477.member_1);
                                                phi_5497_ = type_12(1u, _e1477.member);
                                            } else {
                                                phi_5472_ = _e1477;
                                                phi_5497_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1491 = phi_5472_;
                                            let _e1493 = phi_5497_;
                                            if (bitcast<i32>(_e1493.member) != 0i) {
                                                let _e1497 = (_e1468 + _e1479);
                                                if (_e1497 < _e1278) {
                                                    let _e1500 = (f64(1f) - _e1497);
                                                    let _e1513 = ((_e1473 * ((((_e716 * _e1500) + (_e739 * _e1497)) * (_e1500 * _e1500)) + (((_e762 * _e1500) + (_e773 * _e1497)) * (_e1497 * _e1497)))) > _e1109);
                                                    if _e1513 {
                                                        phi_5528_ = f64();
                                                        phi_5529_ = false;
                                                    } else {
                                                        phi_5528_ = (_e1479 + _e1479);
                                                        phi_5529_ = true;
                                                    }
                                                    let _e1516 = phi_5528_;
                                                    let _e1518 = phi_5529_;
                                                    phi_5530_ = _e1516;
                                                    phi_5531_ = _e1518;
                                                    phi_5532_ = _e1513;
                                                    phi_5533_ = false;
                                                } else {
                                                    phi_5530_ = f64();
                                                    phi_5531_ = false;
                                                    phi_5532_ = false;
                                                    phi_5533_ = true;
                                                }
                                                let _e1520 = phi_5530_;
                                                let _e1522 = phi_5531_;
                                                let _e1524 = phi_5532_;
                                                let _e1526 = phi_5533_;
                                                phi_5534_ = _e1497;
                                                phi_5475_ = _e1520;
                                                phi_5535_ = _e1522;
                                                phi_5536_ = _e1524;
                                                phi_5537_ = _e1526;
                                                phi_5538_ = false;
                                            } else {
                                                phi_5534_ = f64();
                                                phi_5475_ = f64();
                                                phi_5535_ = false;
                                                phi_5536_ = false;
                                                phi_5537_ = false;
                                                phi_5538_ = true;
                                            }
                                            let _e1528 = phi_5534_;
                                            let _e1530 = phi_5475_;
                                            let _e1532 = phi_5535_;
                                            let _e1534 = phi_5536_;
                                            let _e1536 = phi_5537_;
                                            let _e1538 = phi_5538_;
                                            local_15 = _e1534;
                                            local_34 = _e1536;
                                            local_35 = _e1538;
                                            local_36 = _e1528;
                                            continue;
                                            continuing {
                                                phi_5471_ = _e1491;
                                                phi_5474_ = _e1530;
                                                break if !(_e1532);
                                            }
                                        }
                                        let _e1541 = local_15;
                                        if _e1541 {
                                            phi_5542_ = false;
                                            phi_5543_ = false;
                                        } else {
                                            let _e6657 = local_34;
                                            phi_5542_ = _e6657;
                                            let _e6660 = local_35;
                                            phi_5543_ = _e6660;
                                        }
                                        let _e1543 = phi_5542_;
                                        let _e1545 = phi_5543_;
                                        if _e1543 {
                                            phi_5547_ = true;
                                        } else {
                                            phi_5547_ = _e1545;
                                        }
                                        let _e1547 = phi_5547_;
                                        if _e1547 {
                                            phi_5551_ = _e1278;
                                        } else {
                                            let _e6664 = local_36;
                                            phi_5551_ = _e6664;
                                        }
                                        let _e1549 = phi_5551_;
                                        phi_5552_ = _e1549;
                                    } else {
                                        phi_5552_ = _e1278;
                                    }
                                    let _e1551 = phi_5552_;
                                    phi_5554_ = type_45(_e1468, _e1551, _e1328);
                                } else {
                                    phi_5554_ = _e1338;
                                }
                                let _e1554 = phi_5554_;
                                if (_e1554.member > _e1554.member_1) {
                                    phi_9418_ = f64();
                                    phi_9419_ = true;
                                    phi_9420_ = false;
                                    phi_9421_ = false;
                                    phi_9422_ = false;
                                } else {
                                    let _e1562 = ((_e1554.member_1 - _e1554.member) * f64(0.5f));
                                    let _e1563 = (_e1554.member + _e1562);
                                    let _e1566 = (_e1562 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1568 = local_12.member_3;
                                    let _e1571 = local_12.member[0u];
                                    if (_e1571[0] < 0.0lf) {
                                        phi_5585_ = -(_e1571[0]);
                                    } else {
                                        phi_5585_ = _e1571[0];
                                    }
                                    let _e1578 = phi_5585_;
                                    if (_e1571[1] < 0.0lf) {
                                        phi_5592_ = -(_e1571[1]);
                                    } else {
                                        phi_5592_ = _e1571[1];
                                    }
                                    let _e1582 = phi_5592_;
                                    if (_e1578 > _e1582) {
                                        phi_5597_ = _e1578;
                                    } else {
                                        phi_5597_ = _e1582;
                                    }
                                    let _e1585 = phi_5597_;
                                    if (_e1571[2] < 0.0lf) {
                                        phi_5604_ = -(_e1571[2]);
                                    } else {
                                        phi_5604_ = _e1571[2];
                                    }
                                    let _e1589 = phi_5604_;
                                    if (_e1585 > _e1589) {
                                        phi_5609_ = _e1585;
                                    } else {
                                        phi_5609_ = _e1589;
                                    }
                                    let _e1592 = phi_5609_;
                                    let _e1594 = local_12.member[1u];
                                    if (_e1594[0] < 0.0lf) {
                                        phi_5622_ = -(_e1594[0]);
                                    } else {
                                        phi_5622_ = _e1594[0];
                                    }
                                    let _e1601 = phi_5622_;
                                    if (_e1594[1] < 0.0lf) {
                                        phi_5629_ = -(_e1594[1]);
                                    } else {
                                        phi_5629_ = _e1594[1];
                                    }
                                    let _e1605 = phi_5629_;
                                    if (_e1601 > _e1605) {
                                        phi_5634_ = _e1601;
                                    } else {
                                        phi_5634_ = _e1605;
                                    }
                                    let _e1608 = phi_5634_;
                                    if (_e1594[2] < 0.0lf) {
                                        phi_5641_ = -(_e1594[2]);
                                    } else {
                                        phi_5641_ = _e1594[2];
                                    }
                                    let _e1612 = phi_5641_;
                                    if (_e1608 > _e1612) {
                                        phi_5646_ = _e1608;
                                    } else {
                                        phi_5646_ = _e1612;
                                    }
                                    let _e1615 = phi_5646_;
                                    if (_e1592 > _e1615) {
                                        phi_5651_ = _e1592;
                                    } else {
                                        phi_5651_ = _e1615;
                                    }
                                    let _e1618 = phi_5651_;
                                    let _e1621 = local_12.member[0u];
                                    let _e1626 = local_12.member[1u];
                                    let _e1636 = (_e1621[0] + ((_e1626[0] - _e1621[0]) * _e1563));
                                    let _e1637 = (_e1621[1] + ((_e1626[1] - _e1621[1]) * _e1563));
                                    let _e1638 = (_e1621[2] + ((_e1626[2] - _e1621[2]) * _e1563));
                                    let _e1640 = local_12.member[1u];
                                    let _e1645 = local_12.member[0u];
                                    let _e1649 = (_e1640[0] - _e1645[0]);
                                    let _e1650 = (_e1640[1] - _e1645[1]);
                                    let _e1651 = (_e1640[2] - _e1645[2]);
                                    if (_e1649 < 0.0lf) {
                                        phi_5710_ = -(_e1649);
                                    } else {
                                        phi_5710_ = _e1649;
                                    }
                                    let _e1655 = phi_5710_;
                                    if (_e1650 < 0.0lf) {
                                        phi_5716_ = -(_e1650);
                                    } else {
                                        phi_5716_ = _e1650;
                                    }
                                    let _e1659 = phi_5716_;
                                    if (_e1655 > _e1659) {
                                        phi_5721_ = _e1655;
                                    } else {
                                        phi_5721_ = _e1659;
                                    }
                                    let _e1662 = phi_5721_;
                                    if (_e1651 < 0.0lf) {
                                        phi_5727_ = -(_e1651);
                                    } else {
                                        phi_5727_ = _e1651;
                                    }
                                    let _e1666 = phi_5727_;
                                    if (_e1662 > _e1666) {
                                        phi_5732_ = _e1662;
                                    } else {
                                        phi_5732_ = _e1666;
                                    }
                                    let _e1669 = phi_5732_;
                                    let _e1677 = ((((_e1566 * _e1669) * f64(1.01f)) + ((_e1618 + _e1568) * (1.1102230246251565e-16lf * f64(8f)))) + _e1568);
                                    if (_e1636 < 0.0lf) {
                                        phi_5746_ = -(_e1636);
                                    } else {
                                        phi_5746_ = _e1636;
                                    }
                                    let _e1681 = phi_5746_;
                                    if (_e1637 < 0.0lf) {
                                        phi_5752_ = -(_e1637);
                                    } else {
                                        phi_5752_ = _e1637;
                                    }
                                    let _e1685 = phi_5752_;
                                    if (_e1681 > _e1685) {
                                        phi_5757_ = _e1681;
                                    } else {
                                        phi_5757_ = _e1685;
                                    }
                                    let _e1688 = phi_5757_;
                                    if (_e1638 < 0.0lf) {
                                        phi_5763_ = -(_e1638);
                                    } else {
                                        phi_5763_ = _e1638;
                                    }
                                    let _e1692 = phi_5763_;
                                    if (_e1688 > _e1692) {
                                        phi_5768_ = _e1688;
                                    } else {
                                        phi_5768_ = _e1692;
                                    }
                                    let _e1695 = phi_5768_;
                                    local_2 = type_35(array<f64, 3>(_e1636, _e1637, _e1638), _e1677, (_e1695 + _e1677));
                                    let _e1701 = local_12.member_3;
                                    let _e1703 = local_12.member_1[0u];
                                    if (_e1703[0] < 0.0lf) {
                                        phi_5794_ = -(_e1703[0]);
                                    } else {
                                        phi_5794_ = _e1703[0];
                                    }
                                    let _e1710 = phi_5794_;
                                    if (_e1703[1] < 0.0lf) {
                                        phi_5801_ = -(_e1703[1]);
                                    } else {
                                        phi_5801_ = _e1703[1];
                                    }
                                    let _e1714 = phi_5801_;
                                    if (_e1710 > _e1714) {
                                        phi_5806_ = _e1710;
                                    } else {
                                        phi_5806_ = _e1714;
                                    }
                                    let _e1717 = phi_5806_;
                                    if (_e1703[2] < 0.0lf) {
                                        phi_5813_ = -(_e1703[2]);
                                    } else {
                                        phi_5813_ = _e1703[2];
                                    }
                                    let _e1721 = phi_5813_;
                                    if (_e1717 > _e1721) {
                                        phi_5818_ = _e1717;
                                    } else {
                                        phi_5818_ = _e1721;
                                    }
                                    let _e1724 = phi_5818_;
                                    let _e1726 = local_12.member_1[1u];
                                    if (_e1726[0] < 0.0lf) {
                                        phi_5831_ = -(_e1726[0]);
                                    } else {
                                        phi_5831_ = _e1726[0];
                                    }
                                    let _e1733 = phi_5831_;
                                    if (_e1726[1] < 0.0lf) {
                                        phi_5838_ = -(_e1726[1]);
                                    } else {
                                        phi_5838_ = _e1726[1];
                                    }
                                    let _e1737 = phi_5838_;
                                    if (_e1733 > _e1737) {
                                        phi_5843_ = _e1733;
                                    } else {
                                        phi_5843_ = _e1737;
                                    }
                                    let _e1740 = phi_5843_;
                                    if (_e1726[2] < 0.0lf) {
                                        phi_5850_ = -(_e1726[2]);
                                    } else {
                                        phi_5850_ = _e1726[2];
                                    }
                                    let _e1744 = phi_5850_;
                                    if (_e1740 > _e1744) {
                                        phi_5855_ = _e1740;
                                    } else {
                                        phi_5855_ = _e1744;
                                    }
                                    let _e1747 = phi_5855_;
                                    if (_e1724 > _e1747) {
                                        phi_5860_ = _e1724;
                                    } else {
                                        phi_5860_ = _e1747;
                                    }
                                    let _e1750 = phi_5860_;
                                    let _e1753 = local_12.member_1[0u];
                                    let _e1758 = local_12.member_1[1u];
                                    let _e1768 = (_e1753[0] + ((_e1758[0] - _e1753[0]) * _e1563));
                                    let _e1769 = (_e1753[1] + ((_e1758[1] - _e1753[1]) * _e1563));
                                    let _e1770 = (_e1753[2] + ((_e1758[2] - _e1753[2]) * _e1563));
                                    let _e1772 = local_12.member_1[1u];
                                    let _e1777 = local_12.member_1[0u];
                                    let _e1781 = (_e1772[0] - _e1777[0]);
                                    let _e1782 = (_e1772[1] - _e1777[1]);
                                    let _e1783 = (_e1772[2] - _e1777[2]);
                                    if (_e1781 < 0.0lf) {
                                        phi_5919_ = -(_e1781);
                                    } else {
                                        phi_5919_ = _e1781;
                                    }
                                    let _e1787 = phi_5919_;
                                    if (_e1782 < 0.0lf) {
                                        phi_5925_ = -(_e1782);
                                    } else {
                                        phi_5925_ = _e1782;
                                    }
                                    let _e1791 = phi_5925_;
                                    if (_e1787 > _e1791) {
                                        phi_5930_ = _e1787;
                                    } else {
                                        phi_5930_ = _e1791;
                                    }
                                    let _e1794 = phi_5930_;
                                    if (_e1783 < 0.0lf) {
                                        phi_5936_ = -(_e1783);
                                    } else {
                                        phi_5936_ = _e1783;
                                    }
                                    let _e1798 = phi_5936_;
                                    if (_e1794 > _e1798) {
                                        phi_5941_ = _e1794;
                                    } else {
                                        phi_5941_ = _e1798;
                                    }
                                    let _e1801 = phi_5941_;
                                    let _e1809 = ((((_e1566 * _e1801) * f64(1.01f)) + ((_e1750 + _e1701) * (1.1102230246251565e-16lf * f64(8f)))) + _e1701);
                                    if (_e1768 < 0.0lf) {
                                        phi_5955_ = -(_e1768);
                                    } else {
                                        phi_5955_ = _e1768;
                                    }
                                    let _e1813 = phi_5955_;
                                    if (_e1769 < 0.0lf) {
                                        phi_5961_ = -(_e1769);
                                    } else {
                                        phi_5961_ = _e1769;
                                    }
                                    let _e1817 = phi_5961_;
                                    if (_e1813 > _e1817) {
                                        phi_5966_ = _e1813;
                                    } else {
                                        phi_5966_ = _e1817;
                                    }
                                    let _e1820 = phi_5966_;
                                    if (_e1770 < 0.0lf) {
                                        phi_5972_ = -(_e1770);
                                    } else {
                                        phi_5972_ = _e1770;
                                    }
                                    let _e1824 = phi_5972_;
                                    if (_e1820 > _e1824) {
                                        phi_5977_ = _e1820;
                                    } else {
                                        phi_5977_ = _e1824;
                                    }
                                    let _e1827 = phi_5977_;
                                    local_3 = type_35(array<f64, 3>(_e1768, _e1769, _e1770), _e1809, (_e1827 + _e1809));
                                    let _e1833 = local_12.member_3;
                                    let _e1835 = local_12.member_2[0u];
                                    if (_e1835[0] < 0.0lf) {
                                        phi_6003_ = -(_e1835[0]);
                                    } else {
                                        phi_6003_ = _e1835[0];
                                    }
                                    let _e1842 = phi_6003_;
                                    if (_e1835[1] < 0.0lf) {
                                        phi_6010_ = -(_e1835[1]);
                                    } else {
                                        phi_6010_ = _e1835[1];
                                    }
                                    let _e1846 = phi_6010_;
                                    if (_e1842 > _e1846) {
                                        phi_6015_ = _e1842;
                                    } else {
                                        phi_6015_ = _e1846;
                                    }
                                    let _e1849 = phi_6015_;
                                    if (_e1835[2] < 0.0lf) {
                                        phi_6022_ = -(_e1835[2]);
                                    } else {
                                        phi_6022_ = _e1835[2];
                                    }
                                    let _e1853 = phi_6022_;
                                    if (_e1849 > _e1853) {
                                        phi_6027_ = _e1849;
                                    } else {
                                        phi_6027_ = _e1853;
                                    }
                                    let _e1856 = phi_6027_;
                                    let _e1858 = local_12.member_2[1u];
                                    if (_e1858[0] < 0.0lf) {
                                        phi_6040_ = -(_e1858[0]);
                                    } else {
                                        phi_6040_ = _e1858[0];
                                    }
                                    let _e1865 = phi_6040_;
                                    if (_e1858[1] < 0.0lf) {
                                        phi_6047_ = -(_e1858[1]);
                                    } else {
                                        phi_6047_ = _e1858[1];
                                    }
                                    let _e1869 = phi_6047_;
                                    if (_e1865 > _e1869) {
                                        phi_6052_ = _e1865;
                                    } else {
                                        phi_6052_ = _e1869;
                                    }
                                    let _e1872 = phi_6052_;
                                    if (_e1858[2] < 0.0lf) {
                                        phi_6059_ = -(_e1858[2]);
                                    } else {
                                        phi_6059_ = _e1858[2];
                                    }
                                    let _e1876 = phi_6059_;
                                    if (_e1872 > _e1876) {
                                        phi_6064_ = _e1872;
                                    } else {
                                        phi_6064_ = _e1876;
                                    }
                                    let _e1879 = phi_6064_;
                                    if (_e1856 > _e1879) {
                                        phi_6069_ = _e1856;
                                    } else {
                                        phi_6069_ = _e1879;
                                    }
                                    let _e1882 = phi_6069_;
                                    let _e1885 = local_12.member_2[0u];
                                    let _e1890 = local_12.member_2[1u];
                                    let _e1900 = (_e1885[0] + ((_e1890[0] - _e1885[0]) * _e1563));
                                    let _e1901 = (_e1885[1] + ((_e1890[1] - _e1885[1]) * _e1563));
                                    let _e1902 = (_e1885[2] + ((_e1890[2] - _e1885[2]) * _e1563));
                                    let _e1904 = local_12.member_2[1u];
                                    let _e1909 = local_12.member_2[0u];
                                    let _e1913 = (_e1904[0] - _e1909[0]);
                                    let _e1914 = (_e1904[1] - _e1909[1]);
                                    let _e1915 = (_e1904[2] - _e1909[2]);
                                    if (_e1913 < 0.0lf) {
                                        phi_6128_ = -(_e1913);
                                    } else {
                                        phi_6128_ = _e1913;
                                    }
                                    let _e1919 = phi_6128_;
                                    if (_e1914 < 0.0lf) {
                                        phi_6134_ = -(_e1914);
                                    } else {
                                        phi_6134_ = _e1914;
                                    }
                                    let _e1923 = phi_6134_;
                                    if (_e1919 > _e1923) {
                                        phi_6139_ = _e1919;
                                    } else {
                                        phi_6139_ = _e1923;
                                    }
                                    let _e1926 = phi_6139_;
                                    if (_e1915 < 0.0lf) {
                                        phi_6145_ = -(_e1915);
                                    } else {
                                        phi_6145_ = _e1915;
                                    }
                                    let _e1930 = phi_6145_;
                                    if (_e1926 > _e1930) {
                                        phi_6150_ = _e1926;
                                    } else {
                                        phi_6150_ = _e1930;
                                    }
                                    let _e1933 = phi_6150_;
                                    let _e1941 = ((((_e1566 * _e1933) * f64(1.01f)) + ((_e1882 + _e1833) * (1.1102230246251565e-16lf * f64(8f)))) + _e1833);
                                    if (_e1900 < 0.0lf) {
                                        phi_6164_ = -(_e1900);
                                    } else {
                                        phi_6164_ = _e1900;
                                    }
                                    let _e1945 = phi_6164_;
                                    if (_e1901 < 0.0lf) {
                                        phi_6170_ = -(_e1901);
                                    } else {
                                        phi_6170_ = _e1901;
                                    }
                                    let _e1949 = phi_6170_;
                                    if (_e1945 > _e1949) {
                                        phi_6175_ = _e1945;
                                    } else {
                                        phi_6175_ = _e1949;
                                    }
                                    let _e1952 = phi_6175_;
                                    if (_e1902 < 0.0lf) {
                                        phi_6181_ = -(_e1902);
                                    } else {
                                        phi_6181_ = _e1902;
                                    }
                                    let _e1956 = phi_6181_;
                                    if (_e1952 > _e1956) {
                                        phi_6186_ = _e1952;
                                    } else {
                                        phi_6186_ = _e1956;
                                    }
                                    let _e1959 = phi_6186_;
                                    local_4 = type_35(array<f64, 3>(_e1900, _e1901, _e1902), _e1941, (_e1959 + _e1941));
                                    let _e1964 = local_3.member;
                                    let _e1969 = local_4.member;
                                    let _e1975 = ((_e1964[1] * _e1969[2]) - (_e1964[2] * _e1969[1]));
                                    let _e1978 = ((_e1964[2] * _e1969[0]) - (_e1964[0] * _e1969[2]));
                                    let _e1981 = ((_e1964[0] * _e1969[1]) - (_e1964[1] * _e1969[0]));
                                    if (_e1975 < 0.0lf) {
                                        phi_6235_ = -(_e1975);
                                    } else {
                                        phi_6235_ = _e1975;
                                    }
                                    let _e1985 = phi_6235_;
                                    if (_e1978 < 0.0lf) {
                                        phi_6241_ = -(_e1978);
                                    } else {
                                        phi_6241_ = _e1978;
                                    }
                                    let _e1989 = phi_6241_;
                                    if (_e1985 > _e1989) {
                                        if (_e1975 < 0.0lf) {
                                            phi_6251_ = -(_e1975);
                                        } else {
                                            phi_6251_ = _e1975;
                                        }
                                        let _e2007 = phi_6251_;
                                        if (_e1981 < 0.0lf) {
                                            phi_6257_ = -(_e1981);
                                        } else {
                                            phi_6257_ = _e1981;
                                        }
                                        let _e2011 = phi_6257_;
                                        if (_e2007 > _e2011) {
                                            phi_6262_ = 2u;
                                            phi_6263_ = 1u;
                                        } else {
                                            phi_6262_ = 1u;
                                            phi_6263_ = 0u;
                                        }
                                        let _e2014 = phi_6262_;
                                        let _e2016 = phi_6263_;
                                        phi_6282_ = _e2014;
                                        phi_6283_ = _e2016;
                                    } else {
                                        if (_e1978 < 0.0lf) {
                                            phi_6269_ = -(_e1978);
                                        } else {
                                            phi_6269_ = _e1978;
                                        }
                                        let _e1994 = phi_6269_;
                                        if (_e1981 < 0.0lf) {
                                            phi_6275_ = -(_e1981);
                                        } else {
                                            phi_6275_ = _e1981;
                                        }
                                        let _e1998 = phi_6275_;
                                        if (_e1994 > _e1998) {
                                            phi_6280_ = 0u;
                                            phi_6281_ = 2u;
                                        } else {
                                            phi_6280_ = 1u;
                                            phi_6281_ = 0u;
                                        }
                                        let _e2001 = phi_6280_;
                                        let _e2003 = phi_6281_;
                                        phi_6282_ = _e2001;
                                        phi_6283_ = _e2003;
                                    }
                                    let _e2018 = phi_6282_;
                                    let _e2020 = phi_6283_;
                                    let _e2023 = local_3.member[_e2020];
                                    let _e2026 = local_4.member[_e2018];
                                    let _e2030 = local_3.member[_e2018];
                                    let _e2033 = local_4.member[_e2020];
                                    let _e2035 = ((_e2023 * _e2026) - (_e2030 * _e2033));
                                    let _e2036 = f64(1f);
                                    let _e2037 = f64(2f);
                                    let _e2039 = local_3.member_1;
                                    let _e2041 = local_4.member_2;
                                    let _e2044 = local_3.member_2;
                                    let _e2046 = local_4.member_1;
                                    let _e2052 = local_3.member_2;
                                    let _e2055 = local_4.member_2;
                                    let _e2064 = local_3.member_2;
                                    let _e2067 = local_4.member_2;
                                    let _e2071 = (((((_e2039 * _e2041) + (_e2044 * _e2046)) * f64(2.01f)) + (((_e2052 * _e2037) * (_e2055 * _e2037)) * (1.1102230246251565e-16lf * _e2037))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2036 + _e2064) * (_e2036 + _e2067))));
                                    if (_e2035 < 0.0lf) {
                                        phi_6356_ = -(_e2035);
                                    } else {
                                        phi_6356_ = _e2035;
                                    }
                                    let _e2075 = phi_6356_;
                                    if (_e2075 > _e2071) {
                                        if (_e2035 < f64(0f)) {
                                            phi_6368_ = f64(-1f);
                                        } else {
                                            phi_6368_ = f64(1f);
                                        }
                                        let _e2082 = phi_6368_;
                                        let _e2085 = local_2.member[_e2020];
                                        let _e2088 = local_4.member[_e2018];
                                        let _e2092 = local_2.member[_e2018];
                                        let _e2095 = local_4.member[_e2020];
                                        let _e2098 = f64(1f);
                                        let _e2099 = f64(2f);
                                        let _e2101 = local_2.member_1;
                                        let _e2103 = local_4.member_2;
                                        let _e2106 = local_2.member_2;
                                        let _e2108 = local_4.member_1;
                                        let _e2114 = local_2.member_2;
                                        let _e2117 = local_4.member_2;
                                        let _e2126 = local_2.member_2;
                                        let _e2129 = local_4.member_2;
                                        let _e2133 = (((((_e2101 * _e2103) + (_e2106 * _e2108)) * f64(2.01f)) + (((_e2114 * _e2099) * (_e2117 * _e2099)) * (1.1102230246251565e-16lf * _e2099))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2098 + _e2126) * (_e2098 + _e2129))));
                                        let _e2136 = local_3.member[_e2020];
                                        let _e2139 = local_2.member[_e2018];
                                        let _e2143 = local_3.member[_e2018];
                                        let _e2146 = local_2.member[_e2020];
                                        let _e2149 = f64(1f);
                                        let _e2150 = f64(2f);
                                        let _e2152 = local_3.member_1;
                                        let _e2154 = local_2.member_2;
                                        let _e2157 = local_3.member_2;
                                        let _e2159 = local_2.member_1;
                                        let _e2165 = local_3.member_2;
                                        let _e2168 = local_2.member_2;
                                        let _e2177 = local_3.member_2;
                                        let _e2180 = local_2.member_2;
                                        let _e2184 = (((((_e2152 * _e2154) + (_e2157 * _e2159)) * f64(2.01f)) + (((_e2165 * _e2150) * (_e2168 * _e2150)) * (1.1102230246251565e-16lf * _e2150))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2149 + _e2177) * (_e2149 + _e2180))));
                                        let _e2185 = (_e2035 * _e2082);
                                        let _e2186 = (((_e2085 * _e2088) - (_e2092 * _e2095)) * _e2082);
                                        let _e2187 = (((_e2136 * _e2139) - (_e2143 * _e2146)) * _e2082);
                                        if (_e2185 < 0.0lf) {
                                            phi_6511_ = -(_e2185);
                                        } else {
                                            phi_6511_ = _e2185;
                                        }
                                        let _e2191 = phi_6511_;
                                        if (_e2186 < 0.0lf) {
                                            phi_6517_ = -(_e2186);
                                        } else {
                                            phi_6517_ = _e2186;
                                        }
                                        let _e2195 = phi_6517_;
                                        if (_e2187 < 0.0lf) {
                                            phi_6524_ = -(_e2187);
                                        } else {
                                            phi_6524_ = _e2187;
                                        }
                                        let _e2200 = phi_6524_;
                                        let _e2204 = (((_e2191 + _e2195) + _e2200) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5 = array<type_36, 4>(type_36(_e2186, _e2133), type_36(_e2187, _e2184), type_36((_e2185 - _e2186), ((_e2071 + _e2133) + _e2204)), type_36((_e2185 - _e2187), ((_e2071 + _e2184) + _e2204)));
                                        phi_6580_ = type_12(0u, 4u);
                                        phi_6583_ = true;
                                        loop {
                                            let _e2217 = phi_6580_;
                                            let _e2219 = phi_6583_;
                                            local_17 = _e2219;
                                            if (_e2217.member < _e2217.member_1) {
                                                phi_6581_ = type_12((_e2217.member + 1u), _e2217.member_1);
                                                phi_6606_ = type_12(1u, _e2217.member);
                                            } else {
                                                phi_6581_ = _e2217;
                                                phi_6606_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e2231 = phi_6581_;
                                            let _e2233 = phi_6606_;
                                            if (bitcast<i32>(_e2233.member) != 0i) {
                                                let _e2240 = local_5[_e2233.member_1].member;
                                                let _e2243 = local_5[_e2233.member_1].member_1;
                                                let _e2245 = (_e2240 < -(_e2243));
                                                if _e2245 {
                                                    phi_6633_ = bool();
                                                    phi_6634_ = false;
                                                } else {
                                                    phi_6633_ = (_e2219 && (_e2240 > _e2243));
                                                    phi_6634_ = true;
                                                }
                                                let _e2249 = phi_6633_;
                                                let _e2251 = phi_6634_;
                                                phi_6584_ = _e2249;
                                                phi_6635_ = _e2251;
                                                phi_6636_ = _e2245;
                                            } else {
                                                phi_6584_ = bool();
                                                phi_6635_ = false;
                                                phi_6636_ = false;
                                            }
                                            let _e2253 = phi_6584_;
                                            let _e2255 = phi_6635_;
                                            let _e2257 = phi_6636_;
                                            local_16 = _e2257;
                                            continue;
                                            continuing {
                                                phi_6580_ = _e2231;
                                                phi_6583_ = _e2253;
                                                break if !(_e2255);
                                            }
                                        }
                                        let _e2260 = local_16;
                                        if _e2260 {
                                            phi_6640_ = false;
                                        } else {
                                            phi_6640_ = true;
                                        }
                                        let _e2262 = phi_6640_;
                                        if _e2262 {
                                            let _e2264 = local_17;
                                            if _e2264 {
                                                phi_6647_ = 1u;
                                            } else {
                                                phi_6647_ = 2u;
                                            }
                                            let _e2266 = phi_6647_;
                                            phi_6648_ = _e2266;
                                            phi_6649_ = false;
                                        } else {
                                            phi_6648_ = u32();
                                            phi_6649_ = true;
                                        }
                                        let _e2268 = phi_6648_;
                                        let _e2270 = phi_6649_;
                                        phi_6650_ = _e2268;
                                        phi_6651_ = 0u;
                                        phi_6652_ = _e2270;
                                    } else {
                                        phi_6650_ = u32();
                                        phi_6651_ = 2u;
                                        phi_6652_ = true;
                                    }
                                    let _e2272 = phi_6650_;
                                    let _e2274 = phi_6651_;
                                    let _e2276 = phi_6652_;
                                    if _e2276 {
                                        phi_6656_ = _e2274;
                                    } else {
                                        phi_6656_ = _e2272;
                                    }
                                    let _e2278 = phi_6656_;
                                    let _e2279 = (_e2278 == 0u);
                                    if _e2279 {
                                        phi_9414_ = f64();
                                        phi_9415_ = false;
                                        phi_9416_ = false;
                                        phi_9417_ = false;
                                    } else {
                                        if (_e2278 == 1u) {
                                            if _e1554.member_2 {
                                                if ((_e1554.member_1 - _e1554.member) <= f64(0.0000005f)) {
                                                    phi_6677_ = false;
                                                } else {
                                                    phi_6677_ = true;
                                                }
                                                let _e2288 = phi_6677_;
                                                phi_6678_ = _e2288;
                                            } else {
                                                phi_6678_ = true;
                                            }
                                            let _e2290 = phi_6678_;
                                            phi_6679_ = _e2290;
                                        } else {
                                            phi_6679_ = true;
                                        }
                                        let _e2292 = phi_6679_;
                                        if _e2292 {
                                            let _e2295 = f64(0f);
                                            let _e2298 = local_12.member[0u];
                                            let _e2304 = local_12.member_1[0u];
                                            let _e2310 = local_12.member_2[0u];
                                            let _e2314 = (_e2298[0] - _e2304[0]);
                                            let _e2315 = (_e2298[1] - _e2304[1]);
                                            let _e2316 = (_e2298[2] - _e2304[2]);
                                            let _e2325 = local_12.member[1u];
                                            let _e2331 = local_12.member_1[1u];
                                            let _e2337 = local_12.member_2[1u];
                                            let _e2341 = (_e2325[0] - _e2331[0]);
                                            let _e2342 = (_e2325[1] - _e2331[1]);
                                            let _e2343 = (_e2325[2] - _e2331[2]);
                                            let _e2352 = local_12.member[0u];
                                            if (_e2352[0] < 0.0lf) {
                                                phi_6828_ = -(_e2352[0]);
                                            } else {
                                                phi_6828_ = _e2352[0];
                                            }
                                            let _e2359 = phi_6828_;
                                            if (_e2352[1] < 0.0lf) {
                                                phi_6835_ = -(_e2352[1]);
                                            } else {
                                                phi_6835_ = _e2352[1];
                                            }
                                            let _e2363 = phi_6835_;
                                            if (_e2359 > _e2363) {
                                                phi_6840_ = _e2359;
                                            } else {
                                                phi_6840_ = _e2363;
                                            }
                                            let _e2366 = phi_6840_;
                                            if (_e2352[2] < 0.0lf) {
                                                phi_6847_ = -(_e2352[2]);
                                            } else {
                                                phi_6847_ = _e2352[2];
                                            }
                                            let _e2370 = phi_6847_;
                                            if (_e2366 > _e2370) {
                                                phi_6852_ = _e2366;
                                            } else {
                                                phi_6852_ = _e2370;
                                            }
                                            let _e2373 = phi_6852_;
                                            let _e2376 = local_12.member[1u];
                                            if (_e2376[0] < 0.0lf) {
                                                phi_6865_ = -(_e2376[0]);
                                            } else {
                                                phi_6865_ = _e2376[0];
                                            }
                                            let _e2383 = phi_6865_;
                                            if (_e2376[1] < 0.0lf) {
                                                phi_6872_ = -(_e2376[1]);
                                            } else {
                                                phi_6872_ = _e2376[1];
                                            }
                                            let _e2387 = phi_6872_;
                                            if (_e2383 > _e2387) {
                                                phi_6877_ = _e2383;
                                            } else {
                                                phi_6877_ = _e2387;
                                            }
                                            let _e2390 = phi_6877_;
                                            if (_e2376[2] < 0.0lf) {
                                                phi_6884_ = -(_e2376[2]);
                                            } else {
                                                phi_6884_ = _e2376[2];
                                            }
                                            let _e2394 = phi_6884_;
                                            if (_e2390 > _e2394) {
                                                phi_6889_ = _e2390;
                                            } else {
                                                phi_6889_ = _e2394;
                                            }
                                            let _e2397 = phi_6889_;
                                            if (_e2373 > _e2397) {
                                                phi_6894_ = _e2373;
                                            } else {
                                                phi_6894_ = _e2397;
                                            }
                                            let _e2400 = phi_6894_;
                                            let _e2402 = local_12.member_3;
                                            let _e2406 = local_12.member_1[0u];
                                            if (_e2406[0] < 0.0lf) {
                                                phi_6911_ = -(_e2406[0]);
                                            } else {
                                                phi_6911_ = _e2406[0];
                                            }
                                            let _e2413 = phi_6911_;
                                            if (_e2406[1] < 0.0lf) {
                                                phi_6918_ = -(_e2406[1]);
                                            } else {
                                                phi_6918_ = _e2406[1];
                                            }
                                            let _e2417 = phi_6918_;
                                            if (_e2413 > _e2417) {
                                                phi_6923_ = _e2413;
                                            } else {
                                                phi_6923_ = _e2417;
                                            }
                                            let _e2420 = phi_6923_;
                                            if (_e2406[2] < 0.0lf) {
                                                phi_6930_ = -(_e2406[2]);
                                            } else {
                                                phi_6930_ = _e2406[2];
                                            }
                                            let _e2424 = phi_6930_;
                                            if (_e2420 > _e2424) {
                                                phi_6935_ = _e2420;
                                            } else {
                                                phi_6935_ = _e2424;
                                            }
                                            let _e2427 = phi_6935_;
                                            let _e2430 = local_12.member_1[1u];
                                            if (_e2430[0] < 0.0lf) {
                                                phi_6949_ = -(_e2430[0]);
                                            } else {
                                                phi_6949_ = _e2430[0];
                                            }
                                            let _e2437 = phi_6949_;
                                            if (_e2430[1] < 0.0lf) {
                                                phi_6956_ = -(_e2430[1]);
                                            } else {
                                                phi_6956_ = _e2430[1];
                                            }
                                            let _e2441 = phi_6956_;
                                            if (_e2437 > _e2441) {
                                                phi_6961_ = _e2437;
                                            } else {
                                                phi_6961_ = _e2441;
                                            }
                                            let _e2444 = phi_6961_;
                                            if (_e2430[2] < 0.0lf) {
                                                phi_6968_ = -(_e2430[2]);
                                            } else {
                                                phi_6968_ = _e2430[2];
                                            }
                                            let _e2448 = phi_6968_;
                                            if (_e2444 > _e2448) {
                                                phi_6973_ = _e2444;
                                            } else {
                                                phi_6973_ = _e2448;
                                            }
                                            let _e2451 = phi_6973_;
                                            if (_e2427 > _e2451) {
                                                phi_6978_ = _e2427;
                                            } else {
                                                phi_6978_ = _e2451;
                                            }
                                            let _e2454 = phi_6978_;
                                            let _e2456 = local_12.member_3;
                                            let _e2460 = local_12.member_2[0u];
                                            if (_e2460[0] < 0.0lf) {
                                                phi_6995_ = -(_e2460[0]);
                                            } else {
                                                phi_6995_ = _e2460[0];
                                            }
                                            let _e2467 = phi_6995_;
                                            if (_e2460[1] < 0.0lf) {
                                                phi_7002_ = -(_e2460[1]);
                                            } else {
                                                phi_7002_ = _e2460[1];
                                            }
                                            let _e2471 = phi_7002_;
                                            if (_e2467 > _e2471) {
                                                phi_7007_ = _e2467;
                                            } else {
                                                phi_7007_ = _e2471;
                                            }
                                            let _e2474 = phi_7007_;
                                            if (_e2460[2] < 0.0lf) {
                                                phi_7014_ = -(_e2460[2]);
                                            } else {
                                                phi_7014_ = _e2460[2];
                                            }
                                            let _e2478 = phi_7014_;
                                            if (_e2474 > _e2478) {
                                                phi_7019_ = _e2474;
                                            } else {
                                                phi_7019_ = _e2478;
                                            }
                                            let _e2481 = phi_7019_;
                                            let _e2484 = local_12.member_2[1u];
                                            if (_e2484[0] < 0.0lf) {
                                                phi_7033_ = -(_e2484[0]);
                                            } else {
                                                phi_7033_ = _e2484[0];
                                            }
                                            let _e2491 = phi_7033_;
                                            if (_e2484[1] < 0.0lf) {
                                                phi_7040_ = -(_e2484[1]);
                                            } else {
                                                phi_7040_ = _e2484[1];
                                            }
                                            let _e2495 = phi_7040_;
                                            if (_e2491 > _e2495) {
                                                phi_7045_ = _e2491;
                                            } else {
                                                phi_7045_ = _e2495;
                                            }
                                            let _e2498 = phi_7045_;
                                            if (_e2484[2] < 0.0lf) {
                                                phi_7052_ = -(_e2484[2]);
                                            } else {
                                                phi_7052_ = _e2484[2];
                                            }
                                            let _e2502 = phi_7052_;
                                            if (_e2498 > _e2502) {
                                                phi_7057_ = _e2498;
                                            } else {
                                                phi_7057_ = _e2502;
                                            }
                                            let _e2505 = phi_7057_;
                                            if (_e2481 > _e2505) {
                                                phi_7062_ = _e2481;
                                            } else {
                                                phi_7062_ = _e2505;
                                            }
                                            let _e2508 = phi_7062_;
                                            let _e2510 = local_12.member_3;
                                            let _e2518 = local_12.member_3;
                                            let _e2525 = f64(0f);
                                            let _e2526 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2525, _e2525, _e2525, _e2525), array<f64, 4>(_e2525, _e2525, _e2525, _e2525), array<f64, 4>(_e2526, _e2526, _e2526, _e2526));
                                            phi_7107_ = type_12(0u, 96u);
                                            phi_7110_ = _e1554.member;
                                            phi_7112_ = _e1554.member;
                                            phi_7114_ = (_e1554.member_1 - _e1554.member);
                                            phi_7116_ = _e1554.member;
                                            phi_7118_ = false;
                                            phi_7120_ = 0u;
                                            loop {
                                                let _e2533 = phi_7107_;
                                                let _e2535 = phi_7110_;
                                                let _e2537 = phi_7112_;
                                                let _e2539 = phi_7114_;
                                                let _e2541 = phi_7116_;
                                                let _e2543 = phi_7118_;
                                                let _e2545 = phi_7120_;
                                                local_21 = _e2535;
                                                local_45 = _e2537;
                                                if (_e2533.member < _e2533.member_1) {
                                                    phi_7108_ = type_12((_e2533.member + 1u), _e2533.member_1);
                                                    phi_7143_ = type_12(1u, _e2533.member);
                                                } else {
                                                    phi_7108_ = _e2533;
                                                    phi_7143_ = type_12(0u, type_12().member_1);
                                                }
                                                let _e2557 = phi_7108_;
                                                let _e2559 = phi_7143_;
                                                if (bitcast<i32>(_e2559.member) != 0i) {
                                                    let _e2565 = local_12.member[0u];
                                                    let _e2571 = local_12.member[1u];
                                                    let _e2587 = local_12.member_1[0u];
                                                    let _e2593 = local_12.member_1[1u];
                                                    let _e2609 = local_12.member_2[0u];
                                                    let _e2615 = local_12.member_2[1u];
                                                    let _e2629 = function_2(array<f64, 3>((_e2565[0] + ((_e2571[0] - _e2565[0]) * _e2535)), (_e2565[1] + ((_e2571[1] - _e2565[1]) * _e2535)), (_e2565[2] + ((_e2571[2] - _e2565[2]) * _e2535))), array<f64, 3>((_e2587[0] + ((_e2593[0] - _e2587[0]) * _e2535)), (_e2587[1] + ((_e2593[1] - _e2587[1]) * _e2535)), (_e2587[2] + ((_e2593[2] - _e2587[2]) * _e2535))), array<f64, 3>((_e2609[0] + ((_e2615[0] - _e2609[0]) * _e2535)), (_e2609[1] + ((_e2615[1] - _e2609[1]) * _e2535)), (_e2609[2] + ((_e2615[2] - _e2609[2]) * _e2535))), 1u);
                                                    if (_e2545 == 0u) {
                                                        phi_7272_ = _e2629;
                                                    } else {
                                                        let _e2631 = f64(0f);
                                                        if (_e2545 == 1u) {
                                                            phi_7258_ = _e2629[0];
                                                        } else {
                                                            phi_7258_ = _e2631;
                                                        }
                                                        let _e2635 = phi_7258_;
                                                        if (_e2545 == 2u) {
                                                            phi_7264_ = _e2629[1];
                                                        } else {
                                                            phi_7264_ = _e2631;
                                                        }
                                                        let _e2639 = phi_7264_;
                                                        if (_e2545 == 3u) {
                                                            phi_7270_ = _e2629[2];
                                                        } else {
                                                            phi_7270_ = _e2631;
                                                        }
                                                        let _e2643 = phi_7270_;
                                                        phi_7272_ = array<f64, 3>(_e2635, _e2639, _e2643);
                                                    }
                                                    let _e2646 = phi_7272_;
                                                    if (_e2646[0] < 0.0lf) {
                                                        phi_7279_ = -(_e2646[0]);
                                                    } else {
                                                        phi_7279_ = _e2646[0];
                                                    }
                                                    let _e2651 = phi_7279_;
                                                    if (_e2646[1] < 0.0lf) {
                                                        phi_7286_ = -(_e2646[1]);
                                                    } else {
                                                        phi_7286_ = _e2646[1];
                                                    }
                                                    let _e2656 = phi_7286_;
                                                    if (_e2646[2] < 0.0lf) {
                                                        phi_7294_ = -(_e2646[2]);
                                                    } else {
                                                        phi_7294_ = _e2646[2];
                                                    }
                                                    let _e2662 = phi_7294_;
                                                    let _e2663 = ((_e2651 + _e2656) + _e2662);
                                                    if (_e2663 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2663) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2670 = (f64(1f) / _e2663);
                                                            let _e2672 = (_e2646[0] * _e2670);
                                                            let _e2674 = (_e2646[1] * _e2670);
                                                            let _e2676 = (_e2646[2] * _e2670);
                                                            let _e2681 = (((_e2672 * _e2672) + (_e2674 * _e2674)) + (_e2676 * _e2676));
                                                            if (_e2681 <= 2.2250738585072014e-308lf) {
                                                                if (_e2681 > 0.0lf) {
                                                                    phi_7333_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7333_ = 0.0lf;
                                                                }
                                                                let _e2733 = phi_7333_;
                                                                phi_7397_ = _e2733;
                                                            } else {
                                                                phi_7340_ = type_16(0i, 5i);
                                                                phi_7343_ = bitcast<f64>(((bitcast<u64>(_e2681) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2688 = phi_7340_;
                                                                    let _e2690 = phi_7343_;
                                                                    local_18 = _e2690;
                                                                    if (_e2688.member < _e2688.member_1) {
                                                                        let _e2697 = (_e2688.member + 1i);
                                                                        if ((false == (_e2697 > _e2688.member)) != false) {
                                                                            phi_7364_ = true;
                                                                        } else {
                                                                            phi_7364_ = false;
                                                                        }
                                                                        let _e2702 = phi_7364_;
                                                                        if _e2702 {
                                                                            phi_7370_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_7370_ = type_17(1u, _e2697);
                                                                        }
                                                                        let _e2707 = phi_7370_;
                                                                        phi_7341_ = type_16(_e2707.member_1, _e2688.member_1);
                                                                        phi_7384_ = type_17(1u, _e2688.member);
                                                                    } else {
                                                                        phi_7341_ = _e2688;
                                                                        phi_7384_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2713 = phi_7341_;
                                                                    let _e2715 = phi_7384_;
                                                                    let _e2718 = (bitcast<i32>(_e2715.member) != 0i);
                                                                    if _e2718 {
                                                                        phi_7344_ = (0.5lf * (_e2690 + (_e2681 / _e2690)));
                                                                    } else {
                                                                        phi_7344_ = f64();
                                                                    }
                                                                    let _e2723 = phi_7344_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7340_ = _e2713;
                                                                        phi_7343_ = _e2723;
                                                                        break if !(_e2718);
                                                                    }
                                                                }
                                                                let _e2728 = local_18;
                                                                phi_7397_ = (_e2728 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2735 = phi_7397_;
                                                            let _e2737 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2744 = ((((((((_e2400 + _e2402) + (_e2454 + _e2456)) + (_e2508 + _e2510)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2518 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e2295 * _e2735) * (f64(1f) + _e2737)));
                                                            let _e2749 = (((_e2672 * _e2298[0]) + (_e2674 * _e2298[1])) + (_e2676 * _e2298[2]));
                                                            let _e2754 = (((_e2672 * _e2314) + (_e2674 * _e2315)) + (_e2676 * _e2316));
                                                            let _e2759 = (((_e2672 * (_e2298[0] - _e2310[0])) + (_e2674 * (_e2298[1] - _e2310[1]))) + (_e2676 * (_e2298[2] - _e2310[2])));
                                                            let _e2764 = (((_e2672 * (_e2314 - _e2310[0])) + (_e2674 * (_e2315 - _e2310[1]))) + (_e2676 * (_e2316 - _e2310[2])));
                                                            let _e2770 = (((_e2672 * _e2325[0]) + (_e2674 * _e2325[1])) + (_e2676 * _e2325[2]));
                                                            let _e2775 = (((_e2672 * _e2341) + (_e2674 * _e2342)) + (_e2676 * _e2343));
                                                            let _e2780 = (((_e2672 * (_e2325[0] - _e2337[0])) + (_e2674 * (_e2325[1] - _e2337[1]))) + (_e2676 * (_e2325[2] - _e2337[2])));
                                                            let _e2785 = (((_e2672 * (_e2341 - _e2337[0])) + (_e2674 * (_e2342 - _e2337[1]))) + (_e2676 * (_e2343 - _e2337[2])));
                                                            if (_e2749 < 0.0lf) {
                                                                phi_7466_ = -(_e2749);
                                                            } else {
                                                                phi_7466_ = _e2749;
                                                            }
                                                            let _e2790 = phi_7466_;
                                                            if (_e2770 < 0.0lf) {
                                                                phi_7472_ = -(_e2770);
                                                            } else {
                                                                phi_7472_ = _e2770;
                                                            }
                                                            let _e2794 = phi_7472_;
                                                            if (_e2754 < 0.0lf) {
                                                                phi_7481_ = -(_e2754);
                                                            } else {
                                                                phi_7481_ = _e2754;
                                                            }
                                                            let _e2801 = phi_7481_;
                                                            if (_e2775 < 0.0lf) {
                                                                phi_7487_ = -(_e2775);
                                                            } else {
                                                                phi_7487_ = _e2775;
                                                            }
                                                            let _e2805 = phi_7487_;
                                                            if (_e2759 < 0.0lf) {
                                                                phi_7496_ = -(_e2759);
                                                            } else {
                                                                phi_7496_ = _e2759;
                                                            }
                                                            let _e2812 = phi_7496_;
                                                            if (_e2780 < 0.0lf) {
                                                                phi_7502_ = -(_e2780);
                                                            } else {
                                                                phi_7502_ = _e2780;
                                                            }
                                                            let _e2816 = phi_7502_;
                                                            if (_e2764 < 0.0lf) {
                                                                phi_7511_ = -(_e2764);
                                                            } else {
                                                                phi_7511_ = _e2764;
                                                            }
                                                            let _e2823 = phi_7511_;
                                                            if (_e2785 < 0.0lf) {
                                                                phi_7517_ = -(_e2785);
                                                            } else {
                                                                phi_7517_ = _e2785;
                                                            }
                                                            let _e2827 = phi_7517_;
                                                            phi_7523_ = type_34(array<f64, 4>(_e2749, _e2754, _e2759, _e2764), array<f64, 4>(_e2770, _e2775, _e2780, _e2785), array<f64, 4>((_e2744 + ((_e2790 + _e2794) * _e2737)), (_e2744 + ((_e2801 + _e2805) * _e2737)), (_e2744 + ((_e2812 + _e2816) * _e2737)), (_e2744 + ((_e2823 + _e2827) * _e2737))));
                                                            phi_7524_ = false;
                                                        } else {
                                                            phi_7523_ = type_34();
                                                            phi_7524_ = true;
                                                        }
                                                        let _e2834 = phi_7523_;
                                                        let _e2836 = phi_7524_;
                                                        phi_7525_ = _e2834;
                                                        phi_7526_ = _e2836;
                                                    } else {
                                                        phi_7525_ = type_34();
                                                        phi_7526_ = true;
                                                    }
                                                    let _e2838 = phi_7525_;
                                                    let _e2840 = phi_7526_;
                                                    if _e2840 {
                                                        let _e2841 = f64(0f);
                                                        let _e2842 = f64(1f);
                                                        phi_7536_ = type_34(array<f64, 4>(_e2841, _e2841, _e2841, _e2841), array<f64, 4>(_e2841, _e2841, _e2841, _e2841), array<f64, 4>(_e2842, _e2842, _e2842, _e2842));
                                                    } else {
                                                        phi_7536_ = _e2838;
                                                    }
                                                    let _e2848 = phi_7536_;
                                                    local_1 = type_34(array<f64, 4>(_e2848.member[0], _e2848.member[1], _e2848.member[2], _e2848.member[3]), array<f64, 4>(_e2848.member_1[0], _e2848.member_1[1], _e2848.member_1[2], _e2848.member_1[3]), array<f64, 4>(_e2848.member_2[0], _e2848.member_2[1], _e2848.member_2[2], _e2848.member_2[3]));
                                                    let _e2868 = (_e2535 - _e2541);
                                                    let _e2870 = f64(0f);
                                                    let _e2873 = local_1.member[0u];
                                                    let _e2876 = local_1.member_1[0u];
                                                    let _e2879 = local_1.member[0u];
                                                    let _e2885 = local_1.member_2[0u];
                                                    if (((_e2873 + ((_e2876 - _e2879) * _e2535)) - _e2885) > _e2870) {
                                                        let _e2890 = local_1.member[1u];
                                                        let _e2893 = local_1.member_1[1u];
                                                        let _e2896 = local_1.member[1u];
                                                        let _e2902 = local_1.member_2[1u];
                                                        if (((_e2890 + ((_e2893 - _e2896) * _e2535)) - _e2902) > _e2870) {
                                                            let _e2907 = local_1.member[2u];
                                                            let _e2910 = local_1.member_1[2u];
                                                            let _e2913 = local_1.member[2u];
                                                            let _e2919 = local_1.member_2[2u];
                                                            if (((_e2907 + ((_e2910 - _e2913) * _e2535)) - _e2919) > _e2870) {
                                                                let _e2924 = local_1.member[3u];
                                                                let _e2927 = local_1.member_1[3u];
                                                                let _e2930 = local_1.member[3u];
                                                                let _e2936 = local_1.member_2[3u];
                                                                phi_7708_ = (((_e2924 + ((_e2927 - _e2930) * _e2535)) - _e2936) > _e2870);
                                                                phi_7709_ = false;
                                                            } else {
                                                                phi_7708_ = bool();
                                                                phi_7709_ = true;
                                                            }
                                                            let _e2940 = phi_7708_;
                                                            let _e2942 = phi_7709_;
                                                            phi_7710_ = _e2940;
                                                            phi_7711_ = _e2942;
                                                        } else {
                                                            phi_7710_ = bool();
                                                            phi_7711_ = true;
                                                        }
                                                        let _e2944 = phi_7710_;
                                                        let _e2946 = phi_7711_;
                                                        phi_7712_ = _e2944;
                                                        phi_7713_ = _e2946;
                                                    } else {
                                                        phi_7712_ = bool();
                                                        phi_7713_ = true;
                                                    }
                                                    let _e2948 = phi_7712_;
                                                    let _e2950 = phi_7713_;
                                                    if _e2950 {
                                                        phi_7717_ = false;
                                                    } else {
                                                        phi_7717_ = _e2948;
                                                    }
                                                    let _e2952 = phi_7717_;
                                                    if _e2952 {
                                                        if (_e2535 <= _e2537) {
                                                            phi_8028_ = true;
                                                        } else {
                                                            let _e2954 = f64(0f);
                                                            let _e2957 = local.member[0u];
                                                            let _e2960 = local.member_1[0u];
                                                            let _e2963 = local.member[0u];
                                                            let _e2969 = local.member_2[0u];
                                                            let _e2973 = local_1.member[0u];
                                                            let _e2976 = local_1.member_1[0u];
                                                            let _e2979 = local_1.member[0u];
                                                            let _e2985 = local_1.member_2[0u];
                                                            if ((((_e2957 + ((_e2960 - _e2963) * _e2535)) - _e2969) + ((_e2973 + ((_e2976 - _e2979) * _e2541)) - _e2985)) > _e2954) {
                                                                let _e2991 = local.member[1u];
                                                                let _e2994 = local.member_1[1u];
                                                                let _e2997 = local.member[1u];
                                                                let _e3003 = local.member_2[1u];
                                                                let _e3007 = local_1.member[1u];
                                                                let _e3010 = local_1.member_1[1u];
                                                                let _e3013 = local_1.member[1u];
                                                                let _e3019 = local_1.member_2[1u];
                                                                if ((((_e2991 + ((_e2994 - _e2997) * _e2535)) - _e3003) + ((_e3007 + ((_e3010 - _e3013) * _e2541)) - _e3019)) > _e2954) {
                                                                    let _e3025 = local.member[2u];
                                                                    let _e3028 = local.member_1[2u];
                                                                    let _e3031 = local.member[2u];
                                                                    let _e3037 = local.member_2[2u];
                                                                    let _e3041 = local_1.member[2u];
                                                                    let _e3044 = local_1.member_1[2u];
                                                                    let _e3047 = local_1.member[2u];
                                                                    let _e3053 = local_1.member_2[2u];
                                                                    if ((((_e3025 + ((_e3028 - _e3031) * _e2535)) - _e3037) + ((_e3041 + ((_e3044 - _e3047) * _e2541)) - _e3053)) > _e2954) {
                                                                        let _e3059 = local.member[3u];
                                                                        let _e3062 = local.member_1[3u];
                                                                        let _e3065 = local.member[3u];
                                                                        let _e3071 = local.member_2[3u];
                                                                        let _e3075 = local_1.member[3u];
                                                                        let _e3078 = local_1.member_1[3u];
                                                                        let _e3081 = local_1.member[3u];
                                                                        let _e3087 = local_1.member_2[3u];
                                                                        phi_8015_ = ((((_e3059 + ((_e3062 - _e3065) * _e2535)) - _e3071) + ((_e3075 + ((_e3078 - _e3081) * _e2541)) - _e3087)) > _e2954);
                                                                        phi_8016_ = false;
                                                                    } else {
                                                                        phi_8015_ = bool();
                                                                        phi_8016_ = true;
                                                                    }
                                                                    let _e3092 = phi_8015_;
                                                                    let _e3094 = phi_8016_;
                                                                    phi_8017_ = _e3092;
                                                                    phi_8018_ = _e3094;
                                                                } else {
                                                                    phi_8017_ = bool();
                                                                    phi_8018_ = true;
                                                                }
                                                                let _e3096 = phi_8017_;
                                                                let _e3098 = phi_8018_;
                                                                phi_8019_ = _e3096;
                                                                phi_8020_ = _e3098;
                                                            } else {
                                                                phi_8019_ = bool();
                                                                phi_8020_ = true;
                                                            }
                                                            let _e3100 = phi_8019_;
                                                            let _e3102 = phi_8020_;
                                                            if _e3102 {
                                                                phi_8024_ = false;
                                                            } else {
                                                                phi_8024_ = _e3100;
                                                            }
                                                            let _e3104 = phi_8024_;
                                                            phi_8028_ = _e3104;
                                                        }
                                                        let _e3106 = phi_8028_;
                                                        if _e3106 {
                                                            if _e2543 {
                                                                if (_e2535 >= _e1554.member_1) {
                                                                    phi_8039_ = false;
                                                                } else {
                                                                    phi_8039_ = true;
                                                                }
                                                                let _e3109 = phi_8039_;
                                                                phi_8040_ = _e3109;
                                                            } else {
                                                                phi_8040_ = true;
                                                            }
                                                            let _e3111 = phi_8040_;
                                                            if _e3111 {
                                                                local = type_34(array<f64, 4>(_e2848.member[0], _e2848.member[1], _e2848.member[2], _e2848.member[3]), array<f64, 4>(_e2848.member_1[0], _e2848.member_1[1], _e2848.member_1[2], _e2848.member_1[3]), array<f64, 4>(_e2848.member_2[0], _e2848.member_2[1], _e2848.member_2[2], _e2848.member_2[3]));
                                                                let _e3133 = local.member[0u];
                                                                let _e3136 = local.member_1[0u];
                                                                let _e3139 = local.member_2[0u];
                                                                if (_e3133 > _e3139) {
                                                                    if (_e3136 > _e3139) {
                                                                        phi_8114_ = false;
                                                                    } else {
                                                                        phi_8114_ = true;
                                                                    }
                                                                    let _e3143 = phi_8114_;
                                                                    phi_8115_ = _e3143;
                                                                } else {
                                                                    phi_8115_ = true;
                                                                }
                                                                let _e3145 = phi_8115_;
                                                                if _e3145 {
                                                                    let _e3146 = (_e3136 >= _e3133);
                                                                    if _e3146 {
                                                                        phi_8140_ = f64();
                                                                        phi_8141_ = false;
                                                                    } else {
                                                                        if ((_e3133 - _e3136) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8138_ = (((_e3133 - _e3139) / (_e3133 - _e3136)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8139_ = false;
                                                                        } else {
                                                                            phi_8138_ = f64();
                                                                            phi_8139_ = true;
                                                                        }
                                                                        let _e3160 = phi_8138_;
                                                                        let _e3162 = phi_8139_;
                                                                        phi_8140_ = _e3160;
                                                                        phi_8141_ = _e3162;
                                                                    }
                                                                    let _e3164 = phi_8140_;
                                                                    let _e3166 = phi_8141_;
                                                                    phi_8142_ = _e3164;
                                                                    phi_8143_ = _e3146;
                                                                    phi_8144_ = _e3166;
                                                                } else {
                                                                    phi_8142_ = f64();
                                                                    phi_8143_ = true;
                                                                    phi_8144_ = false;
                                                                }
                                                                let _e3168 = phi_8142_;
                                                                let _e3170 = phi_8143_;
                                                                let _e3172 = phi_8144_;
                                                                if _e3170 {
                                                                    phi_8149_ = f64(2f);
                                                                    phi_8150_ = true;
                                                                } else {
                                                                    phi_8149_ = _e2535;
                                                                    phi_8150_ = _e3172;
                                                                }
                                                                let _e3175 = phi_8149_;
                                                                let _e3177 = phi_8150_;
                                                                if _e3177 {
                                                                    phi_8154_ = _e3175;
                                                                } else {
                                                                    phi_8154_ = _e3168;
                                                                }
                                                                let _e3179 = phi_8154_;
                                                                let _e3182 = local.member[1u];
                                                                let _e3185 = local.member_1[1u];
                                                                let _e3188 = local.member_2[1u];
                                                                if (_e3182 > _e3188) {
                                                                    if (_e3185 > _e3188) {
                                                                        phi_8186_ = false;
                                                                    } else {
                                                                        phi_8186_ = true;
                                                                    }
                                                                    let _e3192 = phi_8186_;
                                                                    phi_8187_ = _e3192;
                                                                } else {
                                                                    phi_8187_ = true;
                                                                }
                                                                let _e3194 = phi_8187_;
                                                                if _e3194 {
                                                                    let _e3195 = (_e3185 >= _e3182);
                                                                    if _e3195 {
                                                                        phi_8212_ = f64();
                                                                        phi_8213_ = false;
                                                                    } else {
                                                                        if ((_e3182 - _e3185) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8210_ = (((_e3182 - _e3188) / (_e3182 - _e3185)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8211_ = false;
                                                                        } else {
                                                                            phi_8210_ = f64();
                                                                            phi_8211_ = true;
                                                                        }
                                                                        let _e3209 = phi_8210_;
                                                                        let _e3211 = phi_8211_;
                                                                        phi_8212_ = _e3209;
                                                                        phi_8213_ = _e3211;
                                                                    }
                                                                    let _e3213 = phi_8212_;
                                                                    let _e3215 = phi_8213_;
                                                                    phi_8214_ = _e3213;
                                                                    phi_8215_ = _e3195;
                                                                    phi_8216_ = _e3215;
                                                                } else {
                                                                    phi_8214_ = f64();
                                                                    phi_8215_ = true;
                                                                    phi_8216_ = false;
                                                                }
                                                                let _e3217 = phi_8214_;
                                                                let _e3219 = phi_8215_;
                                                                let _e3221 = phi_8216_;
                                                                if _e3219 {
                                                                    phi_8221_ = f64(2f);
                                                                    phi_8222_ = true;
                                                                } else {
                                                                    phi_8221_ = _e2535;
                                                                    phi_8222_ = _e3221;
                                                                }
                                                                let _e3224 = phi_8221_;
                                                                let _e3226 = phi_8222_;
                                                                if _e3226 {
                                                                    phi_8226_ = _e3224;
                                                                } else {
                                                                    phi_8226_ = _e3217;
                                                                }
                                                                let _e3228 = phi_8226_;
                                                                if (_e3179 < _e3228) {
                                                                    phi_8231_ = _e3179;
                                                                } else {
                                                                    phi_8231_ = _e3228;
                                                                }
                                                                let _e3231 = phi_8231_;
                                                                let _e3234 = local.member[2u];
                                                                let _e3237 = local.member_1[2u];
                                                                let _e3240 = local.member_2[2u];
                                                                if (_e3234 > _e3240) {
                                                                    if (_e3237 > _e3240) {
                                                                        phi_8263_ = false;
                                                                    } else {
                                                                        phi_8263_ = true;
                                                                    }
                                                                    let _e3244 = phi_8263_;
                                                                    phi_8264_ = _e3244;
                                                                } else {
                                                                    phi_8264_ = true;
                                                                }
                                                                let _e3246 = phi_8264_;
                                                                if _e3246 {
                                                                    let _e3247 = (_e3237 >= _e3234);
                                                                    if _e3247 {
                                                                        phi_8289_ = f64();
                                                                        phi_8290_ = false;
                                                                    } else {
                                                                        if ((_e3234 - _e3237) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8287_ = (((_e3234 - _e3240) / (_e3234 - _e3237)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8288_ = false;
                                                                        } else {
                                                                            phi_8287_ = f64();
                                                                            phi_8288_ = true;
                                                                        }
                                                                        let _e3261 = phi_8287_;
                                                                        let _e3263 = phi_8288_;
                                                                        phi_8289_ = _e3261;
                                                                        phi_8290_ = _e3263;
                                                                    }
                                                                    let _e3265 = phi_8289_;
                                                                    let _e3267 = phi_8290_;
                                                                    phi_8291_ = _e3265;
                                                                    phi_8292_ = _e3247;
                                                                    phi_8293_ = _e3267;
                                                                } else {
                                                                    phi_8291_ = f64();
                                                                    phi_8292_ = true;
                                                                    phi_8293_ = false;
                                                                }
                                                                let _e3269 = phi_8291_;
                                                                let _e3271 = phi_8292_;
                                                                let _e3273 = phi_8293_;
                                                                if _e3271 {
                                                                    phi_8298_ = f64(2f);
                                                                    phi_8299_ = true;
                                                                } else {
                                                                    phi_8298_ = _e2535;
                                                                    phi_8299_ = _e3273;
                                                                }
                                                                let _e3276 = phi_8298_;
                                                                let _e3278 = phi_8299_;
                                                                if _e3278 {
                                                                    phi_8303_ = _e3276;
                                                                } else {
                                                                    phi_8303_ = _e3269;
                                                                }
                                                                let _e3280 = phi_8303_;
                                                                let _e3283 = local.member[3u];
                                                                let _e3286 = local.member_1[3u];
                                                                let _e3289 = local.member_2[3u];
                                                                if (_e3283 > _e3289) {
                                                                    if (_e3286 > _e3289) {
                                                                        phi_8335_ = false;
                                                                    } else {
                                                                        phi_8335_ = true;
                                                                    }
                                                                    let _e3293 = phi_8335_;
                                                                    phi_8336_ = _e3293;
                                                                } else {
                                                                    phi_8336_ = true;
                                                                }
                                                                let _e3295 = phi_8336_;
                                                                if _e3295 {
                                                                    let _e3296 = (_e3286 >= _e3283);
                                                                    if _e3296 {
                                                                        phi_8361_ = f64();
                                                                        phi_8362_ = false;
                                                                    } else {
                                                                        if ((_e3283 - _e3286) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8359_ = (((_e3283 - _e3289) / (_e3283 - _e3286)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8360_ = false;
                                                                        } else {
                                                                            phi_8359_ = f64();
                                                                            phi_8360_ = true;
                                                                        }
                                                                        let _e3310 = phi_8359_;
                                                                        let _e3312 = phi_8360_;
                                                                        phi_8361_ = _e3310;
                                                                        phi_8362_ = _e3312;
                                                                    }
                                                                    let _e3314 = phi_8361_;
                                                                    let _e3316 = phi_8362_;
                                                                    phi_8363_ = _e3314;
                                                                    phi_8364_ = _e3296;
                                                                    phi_8365_ = _e3316;
                                                                } else {
                                                                    phi_8363_ = f64();
                                                                    phi_8364_ = true;
                                                                    phi_8365_ = false;
                                                                }
                                                                let _e3318 = phi_8363_;
                                                                let _e3320 = phi_8364_;
                                                                let _e3322 = phi_8365_;
                                                                if _e3320 {
                                                                    phi_8370_ = f64(2f);
                                                                    phi_8371_ = true;
                                                                } else {
                                                                    phi_8370_ = _e2535;
                                                                    phi_8371_ = _e3322;
                                                                }
                                                                let _e3325 = phi_8370_;
                                                                let _e3327 = phi_8371_;
                                                                if _e3327 {
                                                                    phi_8375_ = _e3325;
                                                                } else {
                                                                    phi_8375_ = _e3318;
                                                                }
                                                                let _e3329 = phi_8375_;
                                                                if (_e3280 < _e3329) {
                                                                    phi_8380_ = _e3280;
                                                                } else {
                                                                    phi_8380_ = _e3329;
                                                                }
                                                                let _e3332 = phi_8380_;
                                                                if (_e3231 < _e3332) {
                                                                    phi_8385_ = _e3231;
                                                                } else {
                                                                    phi_8385_ = _e3332;
                                                                }
                                                                let _e3335 = phi_8385_;
                                                                if (_e3335 > _e2535) {
                                                                    phi_8390_ = _e3335;
                                                                } else {
                                                                    phi_8390_ = _e2535;
                                                                }
                                                                let _e3338 = phi_8390_;
                                                                let _e3339 = (_e3338 > _e1554.member_1);
                                                                if _e3339 {
                                                                    phi_8907_ = f64();
                                                                    phi_8908_ = f64();
                                                                    phi_8909_ = false;
                                                                    phi_8910_ = false;
                                                                } else {
                                                                    let _e3340 = (_e3338 - _e2535);
                                                                    let _e3342 = (_e3340 <= f64(0.0000000037252903f));
                                                                    let _e3344 = (_e3338 + f64(0.00000001f));
                                                                    if (_e3344 < _e1554.member_1) {
                                                                        phi_8404_ = _e3344;
                                                                    } else {
                                                                        phi_8404_ = _e1554.member_1;
                                                                    }
                                                                    let _e3347 = phi_8404_;
                                                                    if _e3342 {
                                                                        if (_e2295 > f64(0f)) {
                                                                            let _e3352 = local_12.member[0u];
                                                                            let _e3358 = local_12.member[1u];
                                                                            let _e3374 = local_12.member_1[0u];
                                                                            let _e3380 = local_12.member_1[1u];
                                                                            let _e3396 = local_12.member_2[0u];
                                                                            let _e3402 = local_12.member_2[1u];
                                                                            let _e3416 = function_2(array<f64, 3>((_e3352[0] + ((_e3358[0] - _e3352[0]) * _e3347)), (_e3352[1] + ((_e3358[1] - _e3352[1]) * _e3347)), (_e3352[2] + ((_e3358[2] - _e3352[2]) * _e3347))), array<f64, 3>((_e3374[0] + ((_e3380[0] - _e3374[0]) * _e3347)), (_e3374[1] + ((_e3380[1] - _e3374[1]) * _e3347)), (_e3374[2] + ((_e3380[2] - _e3374[2]) * _e3347))), array<f64, 3>((_e3396[0] + ((_e3402[0] - _e3396[0]) * _e3347)), (_e3396[1] + ((_e3402[1] - _e3396[1]) * _e3347)), (_e3396[2] + ((_e3402[2] - _e3396[2]) * _e3347))), 1u);
                                                                            let _e3427 = (((_e3416[0] * _e3416[0]) + (_e3416[1] * _e3416[1])) + (_e3416[2] * _e3416[2]));
                                                                            if (_e3427 <= 2.2250738585072014e-308lf) {
                                                                                if (_e3427 > 0.0lf) {
                                                                                    phi_8535_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                } else {
                                                                                    phi_8535_ = 0.0lf;
                                                                                }
                                                                                let _e3479 = phi_8535_;
                                                                                phi_8599_ = _e3479;
                                                                            } else {
                                                                                phi_8542_ = type_16(0i, 5i);
                                                                                phi_8545_ = bitcast<f64>(((bitcast<u64>(_e3427) / 2lu) + 2303426169912950784lu));
                                                                                loop {
                                                                                    let _e3434 = phi_8542_;
                                                                                    let _e3436 = phi_8545_;
                                                                                    local_19 = _e3436;
                                                                                    if (_e3434.member < _e3434.member_1) {
                                                                                        let _e3443 = (_e3434.member + 1i);
                                                                                        if ((false == (_e3443 > _e3434.member)) != false) {
                                                                                            phi_8566_ = true;
                                                                                        } else {
                                                                                            phi_8566_ = false;
                                                                                        }
                                                                                        let _e3448 = phi_8566_;
                                                                                        if _e3448 {
                                                                                            phi_8572_ = type_17(0u, type_17().member_1);
                                                                                        } else {
                                                                                            phi_8572_ = type_17(1u, _e3443);
                                                                                        }
                                                                                        let _e3453 = phi_8572_;
                                                                                        phi_8543_ = type_16(_e3453.member_1, _e3434.member_1);
                                                                                        phi_8586_ = type_17(1u, _e3434.member);
                                                                                    } else {
                                                                                        phi_8543_ = _e3434;
                                                                                        phi_8586_ = type_17(0u, type_17().member_1);
                                                                                    }
                                                                                    let _e3459 = phi_8543_;
                                                                                    let _e3461 = phi_8586_;
                                                                                    let _e3464 = (bitcast<i32>(_e3461.member) != 0i);
                                                                                    if _e3464 {
                                                                                        phi_8546_ = (0.5lf * (_e3436 + (_e3427 / _e3436)));
                                                                                    } else {
                                                                                        phi_8546_ = f64();
                                                                                    }
                                                                                    let _e3469 = phi_8546_;
                                                                                    continue;
                                                                                    continuing {
                                                                                        phi_8542_ = _e3459;
                                                                                        phi_8545_ = _e3469;
                                                                                        break if !(_e3464);
                                                                                    }
                                                                                }
                                                                                let _e3474 = local_19;
                                                                                phi_8599_ = (_e3474 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                            }
                                                                            let _e3481 = phi_8599_;
                                                                            let _e3489 = local_12.member[0u];
                                                                            if (_e3489[0] < 0.0lf) {
                                                                                phi_8617_ = -(_e3489[0]);
                                                                            } else {
                                                                                phi_8617_ = _e3489[0];
                                                                            }
                                                                            let _e3496 = phi_8617_;
                                                                            if (_e3489[1] < 0.0lf) {
                                                                                phi_8624_ = -(_e3489[1]);
                                                                            } else {
                                                                                phi_8624_ = _e3489[1];
                                                                            }
                                                                            let _e3500 = phi_8624_;
                                                                            if (_e3496 > _e3500) {
                                                                                phi_8629_ = _e3496;
                                                                            } else {
                                                                                phi_8629_ = _e3500;
                                                                            }
                                                                            let _e3503 = phi_8629_;
                                                                            if (_e3489[2] < 0.0lf) {
                                                                                phi_8636_ = -(_e3489[2]);
                                                                            } else {
                                                                                phi_8636_ = _e3489[2];
                                                                            }
                                                                            let _e3507 = phi_8636_;
                                                                            if (_e3503 > _e3507) {
                                                                                phi_8641_ = _e3503;
                                                                            } else {
                                                                                phi_8641_ = _e3507;
                                                                            }
                                                                            let _e3510 = phi_8641_;
                                                                            let _e3513 = local_12.member[1u];
                                                                            if (_e3513[0] < 0.0lf) {
                                                                                phi_8654_ = -(_e3513[0]);
                                                                            } else {
                                                                                phi_8654_ = _e3513[0];
                                                                            }
                                                                            let _e3520 = phi_8654_;
                                                                            if (_e3513[1] < 0.0lf) {
                                                                                phi_8661_ = -(_e3513[1]);
                                                                            } else {
                                                                                phi_8661_ = _e3513[1];
                                                                            }
                                                                            let _e3524 = phi_8661_;
                                                                            if (_e3520 > _e3524) {
                                                                                phi_8666_ = _e3520;
                                                                            } else {
                                                                                phi_8666_ = _e3524;
                                                                            }
                                                                            let _e3527 = phi_8666_;
                                                                            if (_e3513[2] < 0.0lf) {
                                                                                phi_8673_ = -(_e3513[2]);
                                                                            } else {
                                                                                phi_8673_ = _e3513[2];
                                                                            }
                                                                            let _e3531 = phi_8673_;
                                                                            if (_e3527 > _e3531) {
                                                                                phi_8678_ = _e3527;
                                                                            } else {
                                                                                phi_8678_ = _e3531;
                                                                            }
                                                                            let _e3534 = phi_8678_;
                                                                            if (_e3510 > _e3534) {
                                                                                phi_8683_ = _e3510;
                                                                            } else {
                                                                                phi_8683_ = _e3534;
                                                                            }
                                                                            let _e3537 = phi_8683_;
                                                                            let _e3539 = local_12.member_3;
                                                                            let _e3543 = local_12.member_1[0u];
                                                                            if (_e3543[0] < 0.0lf) {
                                                                                phi_8700_ = -(_e3543[0]);
                                                                            } else {
                                                                                phi_8700_ = _e3543[0];
                                                                            }
                                                                            let _e3550 = phi_8700_;
                                                                            if (_e3543[1] < 0.0lf) {
                                                                                phi_8707_ = -(_e3543[1]);
                                                                            } else {
                                                                                phi_8707_ = _e3543[1];
                                                                            }
                                                                            let _e3554 = phi_8707_;
                                                                            if (_e3550 > _e3554) {
                                                                                phi_8712_ = _e3550;
                                                                            } else {
                                                                                phi_8712_ = _e3554;
                                                                            }
                                                                            let _e3557 = phi_8712_;
                                                                            if (_e3543[2] < 0.0lf) {
                                                                                phi_8719_ = -(_e3543[2]);
                                                                            } else {
                                                                                phi_8719_ = _e3543[2];
                                                                            }
                                                                            let _e3561 = phi_8719_;
                                                                            if (_e3557 > _e3561) {
                                                                                phi_8724_ = _e3557;
                                                                            } else {
                                                                                phi_8724_ = _e3561;
                                                                            }
                                                                            let _e3564 = phi_8724_;
                                                                            let _e3567 = local_12.member_1[1u];
                                                                            if (_e3567[0] < 0.0lf) {
                                                                                phi_8738_ = -(_e3567[0]);
                                                                            } else {
                                                                                phi_8738_ = _e3567[0];
                                                                            }
                                                                            let _e3574 = phi_8738_;
                                                                            if (_e3567[1] < 0.0lf) {
                                                                                phi_8745_ = -(_e3567[1]);
                                                                            } else {
                                                                                phi_8745_ = _e3567[1];
                                                                            }
                                                                            let _e3578 = phi_8745_;
                                                                            if (_e3574 > _e3578) {
                                                                                phi_8750_ = _e3574;
                                                                            } else {
                                                                                phi_8750_ = _e3578;
                                                                            }
                                                                            let _e3581 = phi_8750_;
                                                                            if (_e3567[2] < 0.0lf) {
                                                                                phi_8757_ = -(_e3567[2]);
                                                                            } else {
                                                                                phi_8757_ = _e3567[2];
                                                                            }
                                                                            let _e3585 = phi_8757_;
                                                                            if (_e3581 > _e3585) {
                                                                                phi_8762_ = _e3581;
                                                                            } else {
                                                                                phi_8762_ = _e3585;
                                                                            }
                                                                            let _e3588 = phi_8762_;
                                                                            if (_e3564 > _e3588) {
                                                                                phi_8767_ = _e3564;
                                                                            } else {
                                                                                phi_8767_ = _e3588;
                                                                            }
                                                                            let _e3591 = phi_8767_;
                                                                            let _e3593 = local_12.member_3;
                                                                            let _e3597 = local_12.member_2[0u];
                                                                            if (_e3597[0] < 0.0lf) {
                                                                                phi_8784_ = -(_e3597[0]);
                                                                            } else {
                                                                                phi_8784_ = _e3597[0];
                                                                            }
                                                                            let _e3604 = phi_8784_;
                                                                            if (_e3597[1] < 0.0lf) {
                                                                                phi_8791_ = -(_e3597[1]);
                                                                            } else {
                                                                                phi_8791_ = _e3597[1];
                                                                            }
                                                                            let _e3608 = phi_8791_;
                                                                            if (_e3604 > _e3608) {
                                                                                phi_8796_ = _e3604;
                                                                            } else {
                                                                                phi_8796_ = _e3608;
                                                                            }
                                                                            let _e3611 = phi_8796_;
                                                                            if (_e3597[2] < 0.0lf) {
                                                                                phi_8803_ = -(_e3597[2]);
                                                                            } else {
                                                                                phi_8803_ = _e3597[2];
                                                                            }
                                                                            let _e3615 = phi_8803_;
                                                                            if (_e3611 > _e3615) {
                                                                                phi_8808_ = _e3611;
                                                                            } else {
                                                                                phi_8808_ = _e3615;
                                                                            }
                                                                            let _e3618 = phi_8808_;
                                                                            let _e3621 = local_12.member_2[1u];
                                                                            if (_e3621[0] < 0.0lf) {
                                                                                phi_8822_ = -(_e3621[0]);
                                                                            } else {
                                                                                phi_8822_ = _e3621[0];
                                                                            }
                                                                            let _e3628 = phi_8822_;
                                                                            if (_e3621[1] < 0.0lf) {
                                                                                phi_8829_ = -(_e3621[1]);
                                                                            } else {
                                                                                phi_8829_ = _e3621[1];
                                                                            }
                                                                            let _e3632 = phi_8829_;
                                                                            if (_e3628 > _e3632) {
                                                                                phi_8834_ = _e3628;
                                                                            } else {
                                                                                phi_8834_ = _e3632;
                                                                            }
                                                                            let _e3635 = phi_8834_;
                                                                            if (_e3621[2] < 0.0lf) {
                                                                                phi_8841_ = -(_e3621[2]);
                                                                            } else {
                                                                                phi_8841_ = _e3621[2];
                                                                            }
                                                                            let _e3639 = phi_8841_;
                                                                            if (_e3635 > _e3639) {
                                                                                phi_8846_ = _e3635;
                                                                            } else {
                                                                                phi_8846_ = _e3639;
                                                                            }
                                                                            let _e3642 = phi_8846_;
                                                                            if (_e3618 > _e3642) {
                                                                                phi_8851_ = _e3618;
                                                                            } else {
                                                                                phi_8851_ = _e3642;
                                                                            }
                                                                            let _e3645 = phi_8851_;
                                                                            let _e3647 = local_12.member_3;
                                                                            let _e3655 = local_12.member_3;
                                                                            if (((_e3481 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3537 + _e3539) + (_e3591 + _e3593)) + (_e3645 + _e3647)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3655 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e2295) {
                                                                                phi_8875_ = false;
                                                                            } else {
                                                                                phi_8875_ = true;
                                                                            }
                                                                            let _e3667 = phi_8875_;
                                                                            phi_8876_ = _e3667;
                                                                        } else {
                                                                            phi_8876_ = true;
                                                                        }
                                                                        let _e3669 = phi_8876_;
                                                                        phi_8877_ = _e3669;
                                                                    } else {
                                                                        phi_8877_ = true;
                                                                    }
                                                                    let _e3671 = phi_8877_;
                                                                    if _e3671 {
                                                                        if _e2543 {
                                                                            if _e3342 {
                                                                                phi_8896_ = f64();
                                                                                phi_8897_ = true;
                                                                            } else {
                                                                                if (_e3340 <= (_e2539 * f64(0.25f))) {
                                                                                    phi_8894_ = f64(0f);
                                                                                    phi_8895_ = false;
                                                                                } else {
                                                                                    phi_8894_ = f64();
                                                                                    phi_8895_ = true;
                                                                                }
                                                                                let _e3678 = phi_8894_;
                                                                                let _e3680 = phi_8895_;
                                                                                phi_8896_ = _e3678;
                                                                                phi_8897_ = _e3680;
                                                                            }
                                                                            let _e3682 = phi_8896_;
                                                                            let _e3684 = phi_8897_;
                                                                            if _e3684 {
                                                                                phi_8902_ = (_e2868 + _e2868);
                                                                            } else {
                                                                                phi_8902_ = _e3682;
                                                                            }
                                                                            let _e3687 = phi_8902_;
                                                                            phi_8904_ = _e3687;
                                                                        } else {
                                                                            phi_8904_ = (_e1554.member_1 - _e2535);
                                                                        }
                                                                        let _e3689 = phi_8904_;
                                                                        phi_8905_ = _e3689;
                                                                        phi_8906_ = false;
                                                                    } else {
                                                                        phi_8905_ = f64();
                                                                        phi_8906_ = true;
                                                                    }
                                                                    let _e3691 = phi_8905_;
                                                                    let _e3693 = phi_8906_;
                                                                    phi_8907_ = _e3691;
                                                                    phi_8908_ = _e3340;
                                                                    phi_8909_ = _e3671;
                                                                    phi_8910_ = _e3693;
                                                                }
                                                                let _e3695 = phi_8907_;
                                                                let _e3697 = phi_8908_;
                                                                let _e3699 = phi_8909_;
                                                                let _e3701 = phi_8910_;
                                                                phi_8911_ = _e3338;
                                                                phi_8912_ = _e3695;
                                                                phi_8913_ = _e3697;
                                                                phi_8914_ = _e3338;
                                                                phi_8915_ = _e3699;
                                                                phi_8916_ = _e3339;
                                                                phi_8917_ = _e3701;
                                                                phi_8918_ = false;
                                                            } else {
                                                                phi_8911_ = f64();
                                                                phi_8912_ = f64();
                                                                phi_8913_ = f64();
                                                                phi_8914_ = f64();
                                                                phi_8915_ = false;
                                                                phi_8916_ = false;
                                                                phi_8917_ = false;
                                                                phi_8918_ = true;
                                                            }
                                                            let _e3703 = phi_8911_;
                                                            let _e3705 = phi_8912_;
                                                            let _e3707 = phi_8913_;
                                                            let _e3709 = phi_8914_;
                                                            let _e3711 = phi_8915_;
                                                            let _e3713 = phi_8916_;
                                                            let _e3715 = phi_8917_;
                                                            let _e3717 = phi_8918_;
                                                            phi_8919_ = _e3703;
                                                            phi_8920_ = _e3705;
                                                            phi_8921_ = _e3707;
                                                            phi_8922_ = _e3709;
                                                            phi_8923_ = false;
                                                            phi_8924_ = _e3711;
                                                            phi_8925_ = _e3713;
                                                            phi_8926_ = _e3715;
                                                            phi_8927_ = _e3717;
                                                        } else {
                                                            phi_8919_ = f64();
                                                            phi_8920_ = f64();
                                                            phi_8921_ = f64();
                                                            phi_8922_ = f64();
                                                            phi_8923_ = true;
                                                            phi_8924_ = false;
                                                            phi_8925_ = false;
                                                            phi_8926_ = false;
                                                            phi_8927_ = false;
                                                        }
                                                        let _e3719 = phi_8919_;
                                                        let _e3721 = phi_8920_;
                                                        let _e3723 = phi_8921_;
                                                        let _e3725 = phi_8922_;
                                                        let _e3727 = phi_8923_;
                                                        let _e3729 = phi_8924_;
                                                        let _e3731 = phi_8925_;
                                                        let _e3733 = phi_8926_;
                                                        let _e3735 = phi_8927_;
                                                        phi_8928_ = _e3719;
                                                        phi_8929_ = _e3721;
                                                        phi_8930_ = _e3723;
                                                        phi_8931_ = _e3725;
                                                        phi_8932_ = _e3727;
                                                        phi_8933_ = _e3729;
                                                        phi_8934_ = _e3731;
                                                        phi_8935_ = _e3733;
                                                        phi_8936_ = _e3735;
                                                    } else {
                                                        phi_8928_ = f64();
                                                        phi_8929_ = f64();
                                                        phi_8930_ = f64();
                                                        phi_8931_ = f64();
                                                        phi_8932_ = true;
                                                        phi_8933_ = false;
                                                        phi_8934_ = false;
                                                        phi_8935_ = false;
                                                        phi_8936_ = false;
                                                    }
                                                    let _e3737 = phi_8928_;
                                                    let _e3739 = phi_8929_;
                                                    let _e3741 = phi_8930_;
                                                    let _e3743 = phi_8931_;
                                                    let _e3745 = phi_8932_;
                                                    let _e3747 = phi_8933_;
                                                    let _e3749 = phi_8934_;
                                                    let _e3751 = phi_8935_;
                                                    let _e3753 = phi_8936_;
                                                    if _e3745 {
                                                        if (_e2535 <= _e2537) {
                                                            let _e3919 = (_e2545 + 1u);
                                                            let _e3920 = (_e3919 > 3u);
                                                            if _e3920 {
                                                                phi_8949_ = false;
                                                            } else {
                                                                phi_8949_ = true;
                                                            }
                                                            let _e3922 = phi_8949_;
                                                            phi_9276_ = _e3919;
                                                            phi_9277_ = f64();
                                                            phi_9278_ = false;
                                                            phi_9279_ = _e3922;
                                                            phi_9280_ = _e3920;
                                                        } else {
                                                            let _e3757 = local.member[0u];
                                                            let _e3760 = local.member_1[0u];
                                                            let _e3763 = local.member[0u];
                                                            let _e3769 = local.member_2[0u];
                                                            let _e3770 = ((_e3757 + ((_e3760 - _e3763) * _e2541)) - _e3769);
                                                            let _e3773 = local.member[1u];
                                                            let _e3776 = local.member_1[1u];
                                                            let _e3779 = local.member[1u];
                                                            let _e3785 = local.member_2[1u];
                                                            let _e3786 = ((_e3773 + ((_e3776 - _e3779) * _e2541)) - _e3785);
                                                            if (_e3770 < _e3786) {
                                                                phi_9022_ = _e3770;
                                                            } else {
                                                                phi_9022_ = _e3786;
                                                            }
                                                            let _e3789 = phi_9022_;
                                                            let _e3792 = local.member[2u];
                                                            let _e3795 = local.member_1[2u];
                                                            let _e3798 = local.member[2u];
                                                            let _e3804 = local.member_2[2u];
                                                            let _e3805 = ((_e3792 + ((_e3795 - _e3798) * _e2541)) - _e3804);
                                                            let _e3808 = local.member[3u];
                                                            let _e3811 = local.member_1[3u];
                                                            let _e3814 = local.member[3u];
                                                            let _e3820 = local.member_2[3u];
                                                            let _e3821 = ((_e3808 + ((_e3811 - _e3814) * _e2541)) - _e3820);
                                                            if (_e3805 < _e3821) {
                                                                phi_9095_ = _e3805;
                                                            } else {
                                                                phi_9095_ = _e3821;
                                                            }
                                                            let _e3824 = phi_9095_;
                                                            if (_e3789 < _e3824) {
                                                                phi_9100_ = _e3789;
                                                            } else {
                                                                phi_9100_ = _e3824;
                                                            }
                                                            let _e3827 = phi_9100_;
                                                            let _e3830 = local_1.member[0u];
                                                            let _e3833 = local_1.member_1[0u];
                                                            let _e3836 = local_1.member[0u];
                                                            let _e3842 = local_1.member_2[0u];
                                                            let _e3843 = ((_e3830 + ((_e3833 - _e3836) * _e2535)) - _e3842);
                                                            let _e3846 = local_1.member[1u];
                                                            let _e3849 = local_1.member_1[1u];
                                                            let _e3852 = local_1.member[1u];
                                                            let _e3858 = local_1.member_2[1u];
                                                            let _e3859 = ((_e3846 + ((_e3849 - _e3852) * _e2535)) - _e3858);
                                                            if (_e3843 < _e3859) {
                                                                phi_9173_ = _e3843;
                                                            } else {
                                                                phi_9173_ = _e3859;
                                                            }
                                                            let _e3862 = phi_9173_;
                                                            let _e3865 = local_1.member[2u];
                                                            let _e3868 = local_1.member_1[2u];
                                                            let _e3871 = local_1.member[2u];
                                                            let _e3877 = local_1.member_2[2u];
                                                            let _e3878 = ((_e3865 + ((_e3868 - _e3871) * _e2535)) - _e3877);
                                                            let _e3881 = local_1.member[3u];
                                                            let _e3884 = local_1.member_1[3u];
                                                            let _e3887 = local_1.member[3u];
                                                            let _e3893 = local_1.member_2[3u];
                                                            let _e3894 = ((_e3881 + ((_e3884 - _e3887) * _e2535)) - _e3893);
                                                            if (_e3878 < _e3894) {
                                                                phi_9246_ = _e3878;
                                                            } else {
                                                                phi_9246_ = _e3894;
                                                            }
                                                            let _e3897 = phi_9246_;
                                                            if (_e3862 < _e3897) {
                                                                phi_9251_ = _e3862;
                                                            } else {
                                                                phi_9251_ = _e3897;
                                                            }
                                                            let _e3900 = phi_9251_;
                                                            let _e3901 = f64(0.0625f);
                                                            let _e3903 = f64(0.9f);
                                                            if (_e3900 > f64(0f)) {
                                                                phi_9274_ = f64(0.5f);
                                                            } else {
                                                                let _e3909 = (f64(0.95f) * (_e3827 / (_e3827 - _e3900)));
                                                                if (_e3909 > _e3901) {
                                                                    if (_e3909 < _e3903) {
                                                                        phi_9272_ = _e3909;
                                                                    } else {
                                                                        phi_9272_ = _e3903;
                                                                    }
                                                                    let _e3913 = phi_9272_;
                                                                    phi_9273_ = _e3913;
                                                                } else {
                                                                    phi_9273_ = _e3901;
                                                                }
                                                                let _e3915 = phi_9273_;
                                                                phi_9274_ = _e3915;
                                                            }
                                                            let _e3917 = phi_9274_;
                                                            phi_9276_ = u32();
                                                            phi_9277_ = (_e2868 * _e3917);
                                                            phi_9278_ = true;
                                                            phi_9279_ = false;
                                                            phi_9280_ = false;
                                                        }
                                                        let _e3924 = phi_9276_;
                                                        let _e3926 = phi_9277_;
                                                        let _e3928 = phi_9278_;
                                                        let _e3930 = phi_9279_;
                                                        let _e3932 = phi_9280_;
                                                        phi_9281_ = _e3924;
                                                        phi_9282_ = _e2537;
                                                        phi_9283_ = _e3926;
                                                        phi_9284_ = _e2539;
                                                        phi_9285_ = _e2541;
                                                        phi_9286_ = _e2543;
                                                        phi_9287_ = _e2545;
                                                        phi_9288_ = _e3928;
                                                        phi_9289_ = _e3930;
                                                        phi_9290_ = _e3932;
                                                        phi_9291_ = false;
                                                        phi_9292_ = false;
                                                        phi_9293_ = false;
                                                    } else {
                                                        phi_9281_ = u32();
                                                        phi_9282_ = _e3737;
                                                        phi_9283_ = _e3739;
                                                        phi_9284_ = _e3741;
                                                        phi_9285_ = _e2535;
                                                        phi_9286_ = true;
                                                        phi_9287_ = 0u;
                                                        phi_9288_ = _e3747;
                                                        phi_9289_ = false;
                                                        phi_9290_ = false;
                                                        phi_9291_ = _e3749;
                                                        phi_9292_ = _e3751;
                                                        phi_9293_ = _e3753;
                                                    }
                                                    let _e3934 = phi_9281_;
                                                    let _e3936 = phi_9282_;
                                                    let _e3938 = phi_9283_;
                                                    let _e3940 = phi_9284_;
                                                    let _e3942 = phi_9285_;
                                                    let _e3944 = phi_9286_;
                                                    let _e3946 = phi_9287_;
                                                    let _e3948 = phi_9288_;
                                                    let _e3950 = phi_9289_;
                                                    let _e3952 = phi_9290_;
                                                    let _e3954 = phi_9291_;
                                                    let _e3956 = phi_9292_;
                                                    let _e3958 = phi_9293_;
                                                    if _e3948 {
                                                        let _e3959 = (_e3942 + _e3938);
                                                        if (_e3959 > _e3936) {
                                                            phi_9302_ = _e3959;
                                                        } else {
                                                            phi_9302_ = _e3936;
                                                        }
                                                        let _e3962 = phi_9302_;
                                                        if (_e3962 < _e1554.member_1) {
                                                            phi_9307_ = _e3962;
                                                        } else {
                                                            phi_9307_ = _e1554.member_1;
                                                        }
                                                        let _e3965 = phi_9307_;
                                                        if !(_e2543) {
                                                            phi_9317_ = true;
                                                        } else {
                                                            phi_9317_ = ((_e3965 - _e3942) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3970 = phi_9317_;
                                                        if _e3970 {
                                                            phi_9321_ = false;
                                                        } else {
                                                            phi_9321_ = true;
                                                        }
                                                        let _e3972 = phi_9321_;
                                                        phi_9322_ = _e3965;
                                                        phi_9323_ = _e3936;
                                                        phi_9324_ = _e3940;
                                                        phi_9325_ = _e3942;
                                                        phi_9326_ = _e3944;
                                                        phi_9327_ = _e3946;
                                                        phi_9328_ = _e3970;
                                                        phi_9329_ = _e3972;
                                                        phi_9330_ = false;
                                                        phi_9331_ = false;
                                                        phi_9332_ = false;
                                                        phi_9333_ = false;
                                                    } else {
                                                        phi_9322_ = _e2535;
                                                        phi_9323_ = _e2537;
                                                        phi_9324_ = _e2539;
                                                        phi_9325_ = _e2541;
                                                        phi_9326_ = _e2543;
                                                        phi_9327_ = _e3934;
                                                        phi_9328_ = _e3950;
                                                        phi_9329_ = false;
                                                        phi_9330_ = _e3952;
                                                        phi_9331_ = _e3954;
                                                        phi_9332_ = _e3956;
                                                        phi_9333_ = _e3958;
                                                    }
                                                    let _e3974 = phi_9322_;
                                                    let _e3976 = phi_9323_;
                                                    let _e3978 = phi_9324_;
                                                    let _e3980 = phi_9325_;
                                                    let _e3982 = phi_9326_;
                                                    let _e3984 = phi_9327_;
                                                    let _e3986 = phi_9328_;
                                                    let _e3988 = phi_9329_;
                                                    let _e3990 = phi_9330_;
                                                    let _e3992 = phi_9331_;
                                                    let _e3994 = phi_9332_;
                                                    let _e3996 = phi_9333_;
                                                    phi_7111_ = _e3974;
                                                    phi_7113_ = _e3976;
                                                    phi_7115_ = _e3978;
                                                    phi_7117_ = _e3980;
                                                    phi_7119_ = _e3982;
                                                    phi_7121_ = _e3984;
                                                    phi_9334_ = _e3936;
                                                    phi_9335_ = _e3743;
                                                    phi_9336_ = _e3986;
                                                    phi_9337_ = _e3988;
                                                    phi_9338_ = _e3990;
                                                    phi_9339_ = _e3992;
                                                    phi_9340_ = _e3994;
                                                    phi_9341_ = false;
                                                    phi_9342_ = _e3996;
                                                } else {
                                                    phi_7111_ = f64();
                                                    phi_7113_ = f64();
                                                    phi_7115_ = f64();
                                                    phi_7117_ = f64();
                                                    phi_7119_ = bool();
                                                    phi_7121_ = u32();
                                                    phi_9334_ = f64();
                                                    phi_9335_ = f64();
                                                    phi_9336_ = false;
                                                    phi_9337_ = false;
                                                    phi_9338_ = false;
                                                    phi_9339_ = false;
                                                    phi_9340_ = false;
                                                    phi_9341_ = true;
                                                    phi_9342_ = false;
                                                }
                                                let _e3998 = phi_7111_;
                                                let _e4000 = phi_7113_;
                                                let _e4002 = phi_7115_;
                                                let _e4004 = phi_7117_;
                                                let _e4006 = phi_7119_;
                                                let _e4008 = phi_7121_;
                                                let _e4010 = phi_9334_;
                                                let _e4012 = phi_9335_;
                                                let _e4014 = phi_9336_;
                                                let _e4016 = phi_9337_;
                                                let _e4018 = phi_9338_;
                                                let _e4020 = phi_9339_;
                                                let _e4022 = phi_9340_;
                                                let _e4024 = phi_9341_;
                                                let _e4026 = phi_9342_;
                                                local_20 = _e4016;
                                                local_37 = _e4018;
                                                local_38 = _e4020;
                                                local_39 = _e4022;
                                                local_40 = _e4024;
                                                local_41 = _e4026;
                                                local_42 = _e4016;
                                                local_43 = _e4012;
                                                local_44 = _e4010;
                                                continue;
                                                continuing {
                                                    phi_7107_ = _e2557;
                                                    phi_7110_ = _e3998;
                                                    phi_7112_ = _e4000;
                                                    phi_7114_ = _e4002;
                                                    phi_7116_ = _e4004;
                                                    phi_7118_ = _e4006;
                                                    phi_7120_ = _e4008;
                                                    break if !(_e4014);
                                                }
                                            }
                                            let _e4029 = local_20;
                                            if _e4029 {
                                                phi_9346_ = false;
                                                phi_9347_ = false;
                                                phi_9348_ = false;
                                                phi_9349_ = false;
                                                phi_9350_ = false;
                                            } else {
                                                let _e7057 = local_37;
                                                phi_9346_ = _e7057;
                                                let _e7060 = local_38;
                                                phi_9347_ = _e7060;
                                                let _e7063 = local_39;
                                                phi_9348_ = _e7063;
                                                let _e7066 = local_40;
                                                phi_9349_ = _e7066;
                                                let _e7069 = local_41;
                                                phi_9350_ = _e7069;
                                            }
                                            let _e4031 = phi_9346_;
                                            let _e4033 = phi_9347_;
                                            let _e4035 = phi_9348_;
                                            let _e4037 = phi_9349_;
                                            let _e4039 = phi_9350_;
                                            if _e4031 {
                                                let _e4041 = local_21;
                                                phi_9355_ = type_44(1u, _e4041);
                                                phi_9356_ = false;
                                                phi_9357_ = false;
                                                phi_9358_ = false;
                                                phi_9359_ = false;
                                                phi_9360_ = false;
                                            } else {
                                                phi_9355_ = type_44();
                                                phi_9356_ = _e4033;
                                                phi_9357_ = _e4035;
                                                let _e7076 = local_42;
                                                phi_9358_ = _e7076;
                                                phi_9359_ = _e4037;
                                                phi_9360_ = _e4039;
                                            }
                                            let _e4044 = phi_9355_;
                                            let _e4046 = phi_9356_;
                                            let _e4048 = phi_9357_;
                                            let _e4050 = phi_9358_;
                                            let _e4052 = phi_9359_;
                                            let _e4054 = phi_9360_;
                                            if _e4046 {
                                                phi_9365_ = type_44(0u, type_44().member_1);
                                                phi_9366_ = false;
                                                phi_9367_ = false;
                                                phi_9368_ = false;
                                                phi_9369_ = false;
                                                phi_9370_ = true;
                                            } else {
                                                phi_9365_ = _e4044;
                                                phi_9366_ = _e4048;
                                                phi_9367_ = _e4050;
                                                phi_9368_ = _e4052;
                                                phi_9369_ = _e4054;
                                                phi_9370_ = _e4031;
                                            }
                                            let _e4058 = phi_9365_;
                                            let _e4060 = phi_9366_;
                                            let _e4062 = phi_9367_;
                                            let _e4064 = phi_9368_;
                                            let _e4066 = phi_9369_;
                                            let _e4068 = phi_9370_;
                                            if _e4060 {
                                                let _e7087 = local_43;
                                                phi_9374_ = _e7087;
                                                phi_9375_ = true;
                                                phi_9376_ = false;
                                                phi_9377_ = false;
                                                phi_9378_ = false;
                                            } else {
                                                let _e7089 = local_44;
                                                phi_9374_ = _e7089;
                                                phi_9375_ = _e4062;
                                                phi_9376_ = _e4064;
                                                phi_9377_ = _e4066;
                                                phi_9378_ = _e4068;
                                            }
                                            let _e4070 = phi_9374_;
                                            let _e4072 = phi_9375_;
                                            let _e4074 = phi_9376_;
                                            let _e4076 = phi_9377_;
                                            let _e4078 = phi_9378_;
                                            if _e4072 {
                                                phi_9382_ = _e4070;
                                                phi_9383_ = true;
                                                phi_9384_ = false;
                                                phi_9385_ = false;
                                            } else {
                                                let _e7096 = local_45;
                                                phi_9382_ = _e7096;
                                                phi_9383_ = _e4074;
                                                phi_9384_ = _e4076;
                                                phi_9385_ = _e4078;
                                            }
                                            let _e4080 = phi_9382_;
                                            let _e4082 = phi_9383_;
                                            let _e4084 = phi_9384_;
                                            let _e4086 = phi_9385_;
                                            if _e4082 {
                                                phi_9390_ = type_44(1u, _e4080);
                                                phi_9391_ = false;
                                                phi_9392_ = false;
                                            } else {
                                                phi_9390_ = type_44();
                                                phi_9391_ = _e4084;
                                                phi_9392_ = _e4086;
                                            }
                                            let _e4089 = phi_9390_;
                                            let _e4091 = phi_9391_;
                                            let _e4093 = phi_9392_;
                                            if _e4091 {
                                                phi_9397_ = type_44(0u, type_44().member_1);
                                                phi_9398_ = true;
                                            } else {
                                                phi_9397_ = _e4058;
                                                phi_9398_ = _e4093;
                                            }
                                            let _e4097 = phi_9397_;
                                            let _e4099 = phi_9398_;
                                            if _e4099 {
                                                phi_9402_ = _e4097;
                                            } else {
                                                phi_9402_ = _e4089;
                                            }
                                            let _e4101 = phi_9402_;
                                            let _e4104 = (_e4101.member != 0u);
                                            if _e4104 {
                                                phi_9409_ = false;
                                            } else {
                                                phi_9409_ = true;
                                            }
                                            let _e4106 = phi_9409_;
                                            phi_9410_ = _e4101.member_1;
                                            phi_9411_ = _e4106;
                                            phi_9412_ = _e4104;
                                            phi_9413_ = false;
                                        } else {
                                            phi_9410_ = f64();
                                            phi_9411_ = false;
                                            phi_9412_ = false;
                                            phi_9413_ = true;
                                        }
                                        let _e4108 = phi_9410_;
                                        let _e4110 = phi_9411_;
                                        let _e4112 = phi_9412_;
                                        let _e4114 = phi_9413_;
                                        phi_9414_ = _e4108;
                                        phi_9415_ = _e4110;
                                        phi_9416_ = _e4112;
                                        phi_9417_ = _e4114;
                                    }
                                    let _e4116 = phi_9414_;
                                    let _e4118 = phi_9415_;
                                    let _e4120 = phi_9416_;
                                    let _e4122 = phi_9417_;
                                    phi_9418_ = _e4116;
                                    phi_9419_ = _e2279;
                                    phi_9420_ = _e4118;
                                    phi_9421_ = _e4120;
                                    phi_9422_ = _e4122;
                                }
                                let _e4124 = phi_9418_;
                                let _e4126 = phi_9419_;
                                let _e4128 = phi_9420_;
                                let _e4130 = phi_9421_;
                                let _e4132 = phi_9422_;
                                if _e4126 {
                                    phi_9426_ = true;
                                    phi_9427_ = false;
                                    phi_9428_ = false;
                                } else {
                                    phi_9426_ = _e4128;
                                    phi_9427_ = _e4130;
                                    phi_9428_ = _e4132;
                                }
                                let _e4134 = phi_9426_;
                                let _e4136 = phi_9427_;
                                let _e4138 = phi_9428_;
                                phi_9429_ = _e4124;
                                phi_9430_ = _e1554;
                                phi_9431_ = _e4134;
                                phi_9432_ = false;
                                phi_9433_ = _e4136;
                                phi_9434_ = _e4138;
                            } else {
                                phi_9429_ = f64();
                                phi_9430_ = type_45();
                                phi_9431_ = false;
                                phi_9432_ = true;
                                phi_9433_ = false;
                                phi_9434_ = false;
                            }
                            let _e4140 = phi_9429_;
                            let _e4142 = phi_9430_;
                            let _e4144 = phi_9431_;
                            let _e4146 = phi_9432_;
                            let _e4148 = phi_9433_;
                            let _e4150 = phi_9434_;
                            local_22 = _e4146;
                            local_46 = _e4148;
                            local_47 = _e4150;
                            local_23 = _e4140;
                            local_24 = _e4142;
                            continue;
                            continuing {
                                phi_5183_ = _e1267;
                                break if !(_e4144);
                            }
                        }
                        let _e4153 = local_22;
                        if _e4153 {
                            phi_9439_ = type_44(0u, type_44().member_1);
                            phi_9440_ = false;
                            phi_9441_ = false;
                        } else {
                            phi_9439_ = type_44();
                            let _e7133 = local_46;
                            phi_9440_ = _e7133;
                            let _e7136 = local_47;
                            phi_9441_ = _e7136;
                        }
                        let _e4157 = phi_9439_;
                        let _e4159 = phi_9440_;
                        let _e4161 = phi_9441_;
                        if _e4159 {
                            let _e4163 = local_23;
                            phi_9446_ = type_44(2u, _e4163);
                            phi_9447_ = false;
                        } else {
                            phi_9446_ = type_44();
                            phi_9447_ = _e4161;
                        }
                        let _e4166 = phi_9446_;
                        let _e4168 = phi_9447_;
                        if _e4168 {
                            let _e4170 = local_24;
                            phi_9453_ = type_44(1u, _e4170.member);
                            phi_9454_ = true;
                        } else {
                            phi_9453_ = _e4166;
                            phi_9454_ = _e4159;
                        }
                        let _e4174 = phi_9453_;
                        let _e4176 = phi_9454_;
                        if _e4176 {
                            phi_9458_ = _e4174;
                        } else {
                            phi_9458_ = _e4157;
                        }
                        let _e4178 = phi_9458_;
                        phi_9462_ = _e4178;
                    }
                    let _e6367 = phi_9462_;
                    phi_9463_ = _e6367;
                }
                let _e6371 = phi_9463_;
                switch bitcast<i32>(_e6371.member) {
                    case 0: {
                        phi_9476_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e6377 = function_(_e6371.member_1);
                        phi_9476_ = type_32(0u, _e6377, true);
                        break;
                    }
                    case 2: {
                        let _e6375 = function_(_e6371.member_1);
                        phi_9476_ = type_32(1u, _e6375, true);
                        break;
                    }
                    default: {
                        phi_9476_ = type_32();
                        break;
                    }
                }
                let _e6380 = phi_9476_;
                if _e6380.member_2 {
                    let _e6387 = (_e6380.member_1[1] >> bitcast<u32>(20i));
                    if (_e6387 <= 896u) {
                        phi_9499_ = 0u;
                    } else {
                        phi_9499_ = ((((_e6387 - 896u) << bitcast<u32>(23i)) | ((_e6380.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e6380.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e6402 = phi_9499_;
                    let _e6404 = atomicMin((&earliest.member[0u]), _e6402);
                }
                phi_9503_ = type_22(1u, _e6380.member, _e181, _e184, _e6380.member_1);
                phi_9504_ = _e6380.member_2;
            } else {
                phi_9503_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_9504_ = false;
            }
            let _e6406 = phi_9503_;
            let _e6408 = phi_9504_;
            let _e6411 = params.member.member.member_1;
            if ((_e6411 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e6408 {
                    let _e6417 = atomicAdd((&counters[0u]), 1u);
                    phi_9523_ = _e6417;
                } else {
                    phi_9523_ = 0u;
                }
                let _e6419 = phi_9523_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e6422 = atomicLoad((&counters[0u]));
                    if (_e6422 > 0u) {
                        let _e6425 = atomicAdd((&contacts.member[0u]), _e6422);
                        atomicStore((&counters[1u]), _e6425);
                    }
                }
                workgroupBarrier();
                let _e6428 = atomicLoad((&counters[1u]));
                let _e6429 = (_e6428 + _e6419);
                if _e6408 {
                    let _e6432 = params.member.member_1.member_3;
                    if (_e6429 < _e6432) {
                        let _e6434 = (6u * _e6429);
                        atomicStore((&contacts.member[(4u + _e6434)]), _e6406.member);
                        atomicStore((&contacts.member[(_e6434 + 5u)]), _e6406.member_1);
                        atomicStore((&contacts.member[(_e6434 + 6u)]), _e6406.member_2);
                        atomicStore((&contacts.member[(_e6434 + 7u)]), _e6406.member_3);
                        atomicStore((&contacts.member[(_e6434 + 8u)]), _e6406.member_4[0]);
                        atomicStore((&contacts.member[(_e6434 + 9u)]), _e6406.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_282_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
