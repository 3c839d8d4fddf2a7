struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_12 {
    member: array<u32>,
}

struct type_14 {
    member: array<array<u32, 3>>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_28 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_29 {
    member: f32,
    member_1: f32,
}

struct type_32 {
    member: type_26,
    member_1: f32,
}

struct type_33 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_36 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(3) 
var<storage> input: type_12;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_39;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_14;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_681_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_681_ = param_1;
    } else {
        phi_681_ = param;
    }
    let _e26 = phi_681_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_280_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_262_: bool;
    var phi_281_: bool;
    var phi_311_: array<f32, 3>;
    var phi_312_: bool;
    var phi_313_: array<f32, 3>;
    var phi_314_: bool;
    var phi_541_: f32;
    var phi_542_: f32;
    var phi_581_: f32;
    var phi_582_: f32;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_408_: f32;
    var phi_409_: f32;
    var phi_451_: f32;
    var phi_452_: f32;
    var phi_500_: f32;
    var phi_501_: f32;
    var phi_643_: array<array<f32, 3>, 4>;
    var phi_651_: array<f32, 3>;

    let _e21 = (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2]));
    let _e32 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e43 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e54 = (((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2]));
    let _e65 = (((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e72 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e76 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_5 != 0u) {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                if (_e72 <= 1f) {
                    phi_253_ = (_e76 <= 1f);
                    phi_254_ = false;
                } else {
                    phi_253_ = bool();
                    phi_254_ = true;
                }
                let _e97 = phi_253_;
                let _e99 = phi_254_;
                phi_255_ = _e97;
                phi_256_ = _e99;
            } else {
                phi_255_ = bool();
                phi_256_ = true;
            }
            let _e101 = phi_255_;
            let _e103 = phi_256_;
            phi_257_ = _e101;
            phi_258_ = _e103;
        } else {
            phi_257_ = bool();
            phi_258_ = true;
        }
        let _e105 = phi_257_;
        let _e107 = phi_258_;
        if _e107 {
            phi_262_ = false;
        } else {
            phi_262_ = _e105;
        }
        let _e109 = phi_262_;
        phi_281_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_273_ = ((_e72 + _e76) <= 1f);
                phi_274_ = false;
            } else {
                phi_273_ = bool();
                phi_274_ = true;
            }
            let _e83 = phi_273_;
            let _e85 = phi_274_;
            phi_275_ = _e83;
            phi_276_ = _e85;
        } else {
            phi_275_ = bool();
            phi_276_ = true;
        }
        let _e87 = phi_275_;
        let _e89 = phi_276_;
        if _e89 {
            phi_280_ = false;
        } else {
            phi_280_ = _e87;
        }
        let _e91 = phi_280_;
        phi_281_ = _e91;
    }
    let _e111 = phi_281_;
    if (_e68 > 0f) {
        if _e111 {
            phi_311_ = array<f32, 3>((param_2[0] - ((param_3[0] * _e72) + (param_4[0] * _e76))), (param_2[1] - ((param_3[1] * _e72) + (param_4[1] * _e76))), (param_2[2] - ((param_3[2] * _e72) + (param_4[2] * _e76))));
            phi_312_ = false;
        } else {
            phi_311_ = array<f32, 3>();
            phi_312_ = true;
        }
        let _e136 = phi_311_;
        let _e138 = phi_312_;
        phi_313_ = _e136;
        phi_314_ = _e138;
    } else {
        phi_313_ = array<f32, 3>();
        phi_314_ = true;
    }
    let _e140 = phi_313_;
    let _e142 = phi_314_;
    if _e142 {
        let _e145 = (param_2[0] - param_3[0]);
        let _e148 = (param_2[1] - param_3[1]);
        let _e151 = (param_2[2] - param_3[2]);
        if (param_5 != 0u) {
            let _e293 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_362_ = _e293;
                } else {
                    phi_362_ = 1f;
                }
                let _e297 = phi_362_;
                phi_363_ = _e297;
            } else {
                phi_363_ = 0f;
            }
            let _e299 = phi_363_;
            let _e335 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_408_ = _e335;
                } else {
                    phi_408_ = 1f;
                }
                let _e339 = phi_408_;
                phi_409_ = _e339;
            } else {
                phi_409_ = 0f;
            }
            let _e341 = phi_409_;
            let _e374 = ((((_e145 * param_4[0]) + (_e148 * param_4[1])) + (_e151 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_451_ = _e374;
                } else {
                    phi_451_ = 1f;
                }
                let _e378 = phi_451_;
                phi_452_ = _e378;
            } else {
                phi_452_ = 0f;
            }
            let _e380 = phi_452_;
            let _e393 = (param_2[0] - param_4[0]);
            let _e396 = (param_2[1] - param_4[1]);
            let _e399 = (param_2[2] - param_4[2]);
            let _e419 = ((((_e393 * param_3[0]) + (_e396 * param_3[1])) + (_e399 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_500_ = _e419;
                } else {
                    phi_500_ = 1f;
                }
                let _e423 = phi_500_;
                phi_501_ = _e423;
            } else {
                phi_501_ = 0f;
            }
            let _e425 = phi_501_;
            phi_643_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e299)), (param_2[1] - (param_3[1] * _e299)), (param_2[2] - (param_3[2] * _e299))), array<f32, 3>((param_2[0] - (param_4[0] * _e341)), (param_2[1] - (param_4[1] * _e341)), (param_2[2] - (param_4[2] * _e341))), array<f32, 3>((_e145 - (param_4[0] * _e380)), (_e148 - (param_4[1] * _e380)), (_e151 - (param_4[2] * _e380))), array<f32, 3>((_e393 - (param_3[0] * _e425)), (_e396 - (param_3[1] * _e425)), (_e399 - (param_3[2] * _e425))));
        } else {
            let _e155 = (param_4[0] - param_3[0]);
            let _e158 = (param_4[1] - param_3[1]);
            let _e161 = (param_4[2] - param_3[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_541_ = _e172;
                } else {
                    phi_541_ = 1f;
                }
                let _e176 = phi_541_;
                phi_542_ = _e176;
            } else {
                phi_542_ = 0f;
            }
            let _e178 = phi_542_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_581_ = _e208;
                } else {
                    phi_581_ = 1f;
                }
                let _e212 = phi_581_;
                phi_582_ = _e212;
            } else {
                phi_582_ = 0f;
            }
            let _e214 = phi_582_;
            let _e250 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_627_ = _e250;
                } else {
                    phi_627_ = 1f;
                }
                let _e254 = phi_627_;
                phi_628_ = _e254;
            } else {
                phi_628_ = 0f;
            }
            let _e256 = phi_628_;
            phi_643_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e214)), (param_2[1] - (param_3[1] * _e214)), (param_2[2] - (param_3[2] * _e214))), array<f32, 3>((param_2[0] - (param_4[0] * _e256)), (param_2[1] - (param_4[1] * _e256)), (param_2[2] - (param_4[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_643_;
        let _e441 = function_(_e438[0], _e438[1]);
        let _e443 = function_(_e441, _e438[2]);
        let _e445 = function_(_e443, _e438[3]);
        phi_651_ = _e445;
    } else {
        phi_651_ = _e140;
    }
    let _e447 = phi_651_;
    return _e447;
}

fn function_2(param_6: f32) -> array<u32, 2> {
    var phi_702_: array<u32, 2>;
    var phi_703_: array<u32, 2>;
    var phi_704_: bool;
    var phi_708_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_6);
    if (_e13 < 8388608u) {
        phi_703_ = array<u32, 2>();
        phi_704_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_702_ = array<u32, 2>();
        } else {
            phi_702_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_702_;
        phi_703_ = _e31;
        phi_704_ = _e17;
    }
    let _e33 = phi_703_;
    let _e35 = phi_704_;
    if _e35 {
        phi_708_ = array<u32, 2>(0u, 0u);
    } else {
        phi_708_ = _e33;
    }
    let _e37 = phi_708_;
    return _e37;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_29, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_28;
    var local_10: type_28;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_760_: u32;
    var phi_776_: u32;
    var phi_797_: u32;
    var phi_798_: u32;
    var phi_801_: type_19;
    var phi_802_: type_19;
    var phi_825_: type_19;
    var phi_990_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1007_: f32;
    var phi_1012_: f32;
    var phi_1018_: f32;
    var phi_1024_: f32;
    var phi_1029_: f32;
    var phi_1035_: f32;
    var phi_1040_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1058_: f32;
    var phi_1063_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1080_: f32;
    var phi_1086_: f32;
    var phi_1091_: f32;
    var phi_1097_: f32;
    var phi_1102_: f32;
    var phi_1107_: f32;
    var phi_1114_: f32;
    var phi_1120_: f32;
    var phi_1125_: f32;
    var phi_1131_: f32;
    var phi_1136_: f32;
    var phi_1142_: f32;
    var phi_1148_: f32;
    var phi_1153_: f32;
    var phi_1159_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1175_: f32;
    var phi_1180_: f32;
    var phi_1187_: bool;
    var phi_1211_: u32;
    var phi_1222_: f32;
    var phi_1223_: f32;
    var phi_1254_: type_32;
    var phi_1255_: bool;
    var phi_1256_: type_32;
    var phi_1257_: bool;
    var phi_1258_: type_32;
    var phi_1259_: bool;
    var phi_1264_: type_32;
    var phi_1546_: f32;
    var phi_1553_: f32;
    var phi_1558_: f32;
    var phi_1565_: f32;
    var phi_1570_: f32;
    var phi_1583_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1602_: f32;
    var phi_1607_: f32;
    var phi_1612_: f32;
    var phi_1629_: f32;
    var phi_1636_: f32;
    var phi_1641_: f32;
    var phi_1648_: f32;
    var phi_1653_: f32;
    var phi_1667_: f32;
    var phi_1674_: f32;
    var phi_1679_: f32;
    var phi_1686_: f32;
    var phi_1691_: f32;
    var phi_1696_: f32;
    var phi_1713_: f32;
    var phi_1720_: f32;
    var phi_1725_: f32;
    var phi_1732_: f32;
    var phi_1737_: f32;
    var phi_1751_: f32;
    var phi_1758_: f32;
    var phi_1763_: f32;
    var phi_1770_: f32;
    var phi_1775_: f32;
    var phi_1780_: f32;
    var phi_1811_: f32;
    var phi_1817_: f32;
    var phi_1824_: f32;
    var phi_1831_: f32;
    var phi_1837_: f32;
    var phi_1844_: f32;
    var phi_1850_: f32;
    var phi_1856_: f32;
    var phi_1862_: f32;
    var phi_1869_: f32;
    var phi_1876_: f32;
    var phi_1900_: f32;
    var phi_1905_: f32;
    var phi_1910_: f32;
    var phi_1915_: f32;
    var phi_1920_: f32;
    var phi_1925_: f32;
    var phi_1935_: f32;
    var phi_4584_: f32;
    var phi_4590_: f32;
    var phi_4595_: f32;
    var phi_4601_: f32;
    var phi_4607_: f32;
    var phi_4612_: f32;
    var phi_4617_: f32;
    var phi_4625_: bool;
    var phi_4630_: f32;
    var phi_4637_: f32;
    var phi_4677_: type_17;
    var phi_4680_: f32;
    var phi_4701_: bool;
    var phi_4707_: type_18;
    var phi_4678_: type_17;
    var phi_4721_: type_18;
    var phi_4681_: f32;
    var local_13: f32;
    var phi_4670_: f32;
    var phi_4734_: f32;
    var phi_4740_: f32;
    var phi_4765_: type_19;
    var phi_4768_: u32;
    var phi_4766_: type_19;
    var phi_4791_: type_19;
    var phi_4835_: u32;
    var phi_4836_: u32;
    var phi_4769_: u32;
    var phi_4837_: u32;
    var phi_4857_: type_19;
    var phi_4858_: type_19;
    var phi_4881_: type_19;
    var phi_4933_: f32;
    var phi_4940_: f32;
    var phi_4951_: bool;
    var phi_4952_: bool;
    var phi_4953_: bool;
    var phi_4954_: bool;
    var phi_4958_: bool;
    var phi_4969_: type_35;
    var phi_4970_: type_35;
    var phi_4971_: bool;
    var phi_4972_: type_35;
    var phi_4973_: bool;
    var phi_4984_: f32;
    var phi_4994_: type_19;
    var phi_4997_: f32;
    var phi_4999_: f32;
    var phi_5001_: f32;
    var phi_4995_: type_19;
    var phi_5024_: type_19;
    var phi_5049_: f32;
    var phi_5050_: f32;
    var phi_5076_: f32;
    var phi_5092_: f32;
    var phi_5099_: bool;
    var phi_5100_: bool;
    var phi_5101_: bool;
    var phi_5107_: f32;
    var phi_5108_: f32;
    var phi_5109_: bool;
    var phi_4998_: f32;
    var phi_5000_: f32;
    var phi_5002_: f32;
    var phi_5110_: f32;
    var phi_5111_: bool;
    var phi_5112_: bool;
    var local_14: bool;
    var phi_5116_: f32;
    var phi_5117_: f32;
    var phi_5125_: f32;
    var phi_5129_: type_19;
    var phi_5132_: f32;
    var phi_5130_: type_19;
    var phi_5155_: type_19;
    var phi_5185_: f32;
    var phi_5186_: bool;
    var phi_5187_: f32;
    var phi_5188_: bool;
    var phi_5189_: bool;
    var phi_5190_: bool;
    var phi_5191_: f32;
    var phi_5133_: f32;
    var phi_5192_: bool;
    var phi_5193_: bool;
    var phi_5194_: bool;
    var phi_5195_: bool;
    var local_15: bool;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5204_: bool;
    var phi_5208_: f32;
    var phi_5209_: f32;
    var phi_5211_: type_35;
    var phi_5240_: f32;
    var phi_5247_: f32;
    var phi_5252_: f32;
    var phi_5259_: f32;
    var phi_5264_: f32;
    var phi_5277_: f32;
    var phi_5284_: f32;
    var phi_5289_: f32;
    var phi_5296_: f32;
    var phi_5301_: f32;
    var phi_5306_: f32;
    var phi_5365_: f32;
    var phi_5371_: f32;
    var phi_5376_: f32;
    var phi_5382_: f32;
    var phi_5387_: f32;
    var phi_5399_: f32;
    var phi_5405_: f32;
    var phi_5410_: f32;
    var phi_5416_: f32;
    var phi_5421_: f32;
    var phi_5447_: f32;
    var phi_5454_: f32;
    var phi_5459_: f32;
    var phi_5466_: f32;
    var phi_5471_: f32;
    var phi_5484_: f32;
    var phi_5491_: f32;
    var phi_5496_: f32;
    var phi_5503_: f32;
    var phi_5508_: f32;
    var phi_5513_: f32;
    var phi_5572_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5589_: f32;
    var phi_5594_: f32;
    var phi_5606_: f32;
    var phi_5612_: f32;
    var phi_5617_: f32;
    var phi_5623_: f32;
    var phi_5628_: f32;
    var phi_5654_: f32;
    var phi_5661_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5678_: f32;
    var phi_5691_: f32;
    var phi_5698_: f32;
    var phi_5703_: f32;
    var phi_5710_: f32;
    var phi_5715_: f32;
    var phi_5720_: f32;
    var phi_5779_: f32;
    var phi_5785_: f32;
    var phi_5790_: f32;
    var phi_5796_: f32;
    var phi_5801_: f32;
    var phi_5813_: f32;
    var phi_5819_: f32;
    var phi_5824_: f32;
    var phi_5830_: f32;
    var phi_5835_: f32;
    var phi_5884_: f32;
    var phi_5890_: f32;
    var phi_5918_: f32;
    var phi_5924_: f32;
    var phi_5929_: u32;
    var phi_5930_: u32;
    var phi_5900_: f32;
    var phi_5906_: f32;
    var phi_5911_: u32;
    var phi_5912_: u32;
    var phi_5931_: u32;
    var phi_5932_: u32;
    var phi_6001_: f32;
    var phi_6010_: f32;
    var phi_6145_: f32;
    var phi_6151_: f32;
    var phi_6158_: f32;
    var phi_6201_: type_19;
    var phi_6204_: bool;
    var phi_6202_: type_19;
    var phi_6227_: type_19;
    var phi_6254_: bool;
    var phi_6255_: bool;
    var phi_6205_: bool;
    var phi_6256_: bool;
    var phi_6257_: bool;
    var local_16: bool;
    var phi_6261_: bool;
    var local_17: bool;
    var phi_6268_: u32;
    var phi_6269_: u32;
    var phi_6270_: bool;
    var phi_6271_: u32;
    var phi_6272_: u32;
    var phi_6273_: bool;
    var phi_6277_: u32;
    var phi_6297_: bool;
    var phi_6298_: bool;
    var phi_6299_: bool;
    var phi_6447_: f32;
    var phi_6454_: f32;
    var phi_6459_: f32;
    var phi_6466_: f32;
    var phi_6471_: f32;
    var phi_6484_: f32;
    var phi_6491_: f32;
    var phi_6496_: f32;
    var phi_6503_: f32;
    var phi_6508_: f32;
    var phi_6513_: f32;
    var phi_6530_: f32;
    var phi_6537_: f32;
    var phi_6542_: f32;
    var phi_6549_: f32;
    var phi_6554_: f32;
    var phi_6568_: f32;
    var phi_6575_: f32;
    var phi_6580_: f32;
    var phi_6587_: f32;
    var phi_6592_: f32;
    var phi_6597_: f32;
    var phi_6614_: f32;
    var phi_6621_: f32;
    var phi_6626_: f32;
    var phi_6633_: f32;
    var phi_6638_: f32;
    var phi_6652_: f32;
    var phi_6659_: f32;
    var phi_6664_: f32;
    var phi_6671_: f32;
    var phi_6676_: f32;
    var phi_6681_: f32;
    var phi_6720_: type_19;
    var phi_6723_: f32;
    var phi_6725_: f32;
    var phi_6727_: f32;
    var phi_6721_: type_19;
    var phi_6750_: type_19;
    var phi_6862_: f32;
    var phi_6869_: f32;
    var phi_6877_: f32;
    var phi_6921_: type_17;
    var phi_6924_: f32;
    var phi_6945_: bool;
    var phi_6951_: type_18;
    var phi_6922_: type_17;
    var phi_6965_: type_18;
    var phi_6925_: f32;
    var local_18: f32;
    var phi_6914_: f32;
    var phi_6978_: f32;
    var phi_7044_: f32;
    var phi_7050_: f32;
    var phi_7059_: f32;
    var phi_7065_: f32;
    var phi_7074_: f32;
    var phi_7080_: f32;
    var phi_7089_: f32;
    var phi_7095_: f32;
    var phi_7101_: type_28;
    var phi_7102_: bool;
    var phi_7103_: type_28;
    var phi_7104_: bool;
    var phi_7112_: type_28;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7291_: bool;
    var phi_7588_: bool;
    var phi_7589_: bool;
    var phi_7590_: bool;
    var phi_7591_: bool;
    var phi_7592_: bool;
    var phi_7593_: bool;
    var phi_7597_: bool;
    var phi_7601_: bool;
    var phi_7613_: bool;
    var phi_7614_: bool;
    var phi_7688_: bool;
    var phi_7689_: bool;
    var phi_7709_: f32;
    var phi_7710_: bool;
    var phi_7711_: f32;
    var phi_7712_: bool;
    var phi_7713_: f32;
    var phi_7714_: bool;
    var phi_7715_: bool;
    var phi_7719_: f32;
    var phi_7720_: bool;
    var phi_7724_: f32;
    var phi_7756_: bool;
    var phi_7757_: bool;
    var phi_7777_: f32;
    var phi_7778_: bool;
    var phi_7779_: f32;
    var phi_7780_: bool;
    var phi_7781_: f32;
    var phi_7782_: bool;
    var phi_7783_: bool;
    var phi_7787_: f32;
    var phi_7788_: bool;
    var phi_7792_: f32;
    var phi_7797_: f32;
    var phi_7829_: bool;
    var phi_7830_: bool;
    var phi_7850_: f32;
    var phi_7851_: bool;
    var phi_7852_: f32;
    var phi_7853_: bool;
    var phi_7854_: f32;
    var phi_7855_: bool;
    var phi_7856_: bool;
    var phi_7860_: f32;
    var phi_7861_: bool;
    var phi_7865_: f32;
    var phi_7897_: bool;
    var phi_7898_: bool;
    var phi_7918_: f32;
    var phi_7919_: bool;
    var phi_7920_: f32;
    var phi_7921_: bool;
    var phi_7922_: f32;
    var phi_7923_: bool;
    var phi_7924_: bool;
    var phi_7928_: f32;
    var phi_7929_: bool;
    var phi_7933_: f32;
    var phi_7938_: f32;
    var phi_7943_: f32;
    var phi_7948_: f32;
    var phi_7959_: f32;
    var phi_7960_: f32;
    var phi_7961_: bool;
    var phi_7962_: f32;
    var phi_7963_: f32;
    var phi_7964_: bool;
    var phi_7965_: bool;
    var phi_7966_: bool;
    var phi_7967_: f32;
    var phi_7968_: f32;
    var phi_7969_: bool;
    var phi_7970_: bool;
    var phi_7971_: bool;
    var phi_7972_: bool;
    var phi_7973_: f32;
    var phi_7974_: f32;
    var phi_7975_: bool;
    var phi_7976_: bool;
    var phi_7977_: bool;
    var phi_7978_: bool;
    var phi_8058_: f32;
    var phi_8131_: f32;
    var phi_8136_: f32;
    var phi_8209_: f32;
    var phi_8282_: f32;
    var phi_8287_: f32;
    var phi_8303_: f32;
    var phi_8304_: f32;
    var phi_8305_: f32;
    var phi_8307_: f32;
    var phi_8308_: bool;
    var phi_8309_: f32;
    var phi_8310_: f32;
    var phi_8311_: f32;
    var phi_8312_: bool;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: bool;
    var phi_8324_: f32;
    var phi_8329_: f32;
    var phi_8339_: bool;
    var phi_8343_: bool;
    var phi_8344_: f32;
    var phi_8345_: bool;
    var phi_8346_: bool;
    var phi_8347_: bool;
    var phi_8348_: bool;
    var phi_8349_: bool;
    var phi_6724_: f32;
    var phi_6726_: f32;
    var phi_6728_: f32;
    var phi_8350_: f32;
    var phi_8351_: bool;
    var phi_8352_: bool;
    var phi_8353_: bool;
    var phi_8354_: bool;
    var phi_8355_: bool;
    var phi_8356_: bool;
    var local_19: bool;
    var phi_8360_: f32;
    var phi_8361_: bool;
    var phi_8362_: bool;
    var phi_8363_: bool;
    var phi_8364_: bool;
    var phi_8369_: type_33;
    var phi_8370_: bool;
    var phi_8371_: bool;
    var phi_8372_: bool;
    var local_20: f32;
    var phi_8377_: type_33;
    var phi_8378_: bool;
    var phi_8379_: bool;
    var phi_8384_: type_33;
    var phi_8385_: bool;
    var phi_8386_: bool;
    var phi_8391_: type_33;
    var phi_8392_: bool;
    var phi_8396_: type_33;
    var phi_8403_: bool;
    var phi_8404_: f32;
    var phi_8405_: bool;
    var phi_8406_: bool;
    var phi_8407_: bool;
    var phi_8408_: f32;
    var phi_8409_: bool;
    var phi_8410_: bool;
    var phi_8411_: bool;
    var phi_8412_: f32;
    var phi_8413_: bool;
    var phi_8414_: bool;
    var phi_8415_: bool;
    var phi_8416_: bool;
    var phi_8420_: bool;
    var phi_8421_: bool;
    var phi_8422_: bool;
    var phi_8423_: f32;
    var phi_8424_: type_35;
    var phi_8425_: bool;
    var phi_8426_: bool;
    var phi_8427_: bool;
    var phi_8428_: bool;
    var local_21: bool;
    var phi_8433_: type_33;
    var phi_8434_: bool;
    var phi_8435_: bool;
    var local_22: f32;
    var phi_8440_: type_33;
    var phi_8441_: bool;
    var local_23: type_35;
    var phi_8447_: type_33;
    var phi_8448_: bool;
    var phi_8452_: type_33;
    var phi_2088_: f32;
    var phi_2095_: f32;
    var phi_2100_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2125_: f32;
    var phi_2132_: f32;
    var phi_2137_: f32;
    var phi_2144_: f32;
    var phi_2149_: f32;
    var phi_2154_: f32;
    var phi_2171_: f32;
    var phi_2178_: f32;
    var phi_2183_: f32;
    var phi_2190_: f32;
    var phi_2195_: f32;
    var phi_2209_: f32;
    var phi_2216_: f32;
    var phi_2221_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2238_: f32;
    var phi_2255_: f32;
    var phi_2262_: f32;
    var phi_2267_: f32;
    var phi_2274_: f32;
    var phi_2279_: f32;
    var phi_2293_: f32;
    var phi_2300_: f32;
    var phi_2305_: f32;
    var phi_2312_: f32;
    var phi_2317_: f32;
    var phi_2322_: f32;
    var phi_2361_: type_19;
    var phi_2364_: f32;
    var phi_2366_: f32;
    var phi_2368_: f32;
    var phi_2362_: type_19;
    var phi_2391_: type_19;
    var phi_2503_: f32;
    var phi_2510_: f32;
    var phi_2518_: f32;
    var phi_2562_: type_17;
    var phi_2565_: f32;
    var phi_2586_: bool;
    var phi_2592_: type_18;
    var phi_2563_: type_17;
    var phi_2606_: type_18;
    var phi_2566_: f32;
    var local_24: f32;
    var phi_2555_: f32;
    var phi_2619_: f32;
    var phi_2685_: f32;
    var phi_2691_: f32;
    var phi_2700_: f32;
    var phi_2706_: f32;
    var phi_2715_: f32;
    var phi_2721_: f32;
    var phi_2730_: f32;
    var phi_2736_: f32;
    var phi_2742_: type_28;
    var phi_2743_: bool;
    var phi_2744_: type_28;
    var phi_2745_: bool;
    var phi_2753_: type_28;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2932_: bool;
    var phi_3229_: bool;
    var phi_3230_: bool;
    var phi_3231_: bool;
    var phi_3232_: bool;
    var phi_3233_: bool;
    var phi_3234_: bool;
    var phi_3238_: bool;
    var phi_3242_: bool;
    var phi_3254_: bool;
    var phi_3255_: bool;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3350_: f32;
    var phi_3351_: bool;
    var phi_3352_: f32;
    var phi_3353_: bool;
    var phi_3354_: f32;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3360_: f32;
    var phi_3361_: bool;
    var phi_3365_: f32;
    var phi_3397_: bool;
    var phi_3398_: bool;
    var phi_3418_: f32;
    var phi_3419_: bool;
    var phi_3420_: f32;
    var phi_3421_: bool;
    var phi_3422_: f32;
    var phi_3423_: bool;
    var phi_3424_: bool;
    var phi_3428_: f32;
    var phi_3429_: bool;
    var phi_3433_: f32;
    var phi_3438_: f32;
    var phi_3470_: bool;
    var phi_3471_: bool;
    var phi_3491_: f32;
    var phi_3492_: bool;
    var phi_3493_: f32;
    var phi_3494_: bool;
    var phi_3495_: f32;
    var phi_3496_: bool;
    var phi_3497_: bool;
    var phi_3501_: f32;
    var phi_3502_: bool;
    var phi_3506_: f32;
    var phi_3538_: bool;
    var phi_3539_: bool;
    var phi_3559_: f32;
    var phi_3560_: bool;
    var phi_3561_: f32;
    var phi_3562_: bool;
    var phi_3563_: f32;
    var phi_3564_: bool;
    var phi_3565_: bool;
    var phi_3569_: f32;
    var phi_3570_: bool;
    var phi_3574_: f32;
    var phi_3579_: f32;
    var phi_3584_: f32;
    var phi_3589_: f32;
    var phi_3600_: f32;
    var phi_3601_: f32;
    var phi_3602_: bool;
    var phi_3603_: f32;
    var phi_3604_: f32;
    var phi_3605_: bool;
    var phi_3606_: bool;
    var phi_3607_: bool;
    var phi_3608_: f32;
    var phi_3609_: f32;
    var phi_3610_: bool;
    var phi_3611_: bool;
    var phi_3612_: bool;
    var phi_3613_: bool;
    var phi_3614_: f32;
    var phi_3615_: f32;
    var phi_3616_: bool;
    var phi_3617_: bool;
    var phi_3618_: bool;
    var phi_3619_: bool;
    var phi_3699_: f32;
    var phi_3772_: f32;
    var phi_3777_: f32;
    var phi_3850_: f32;
    var phi_3923_: f32;
    var phi_3928_: f32;
    var phi_3944_: f32;
    var phi_3945_: f32;
    var phi_3946_: f32;
    var phi_3948_: f32;
    var phi_3949_: bool;
    var phi_3950_: f32;
    var phi_3951_: f32;
    var phi_3952_: f32;
    var phi_3953_: bool;
    var phi_3954_: bool;
    var phi_3955_: bool;
    var phi_3956_: bool;
    var phi_3965_: f32;
    var phi_3970_: f32;
    var phi_3980_: bool;
    var phi_3984_: bool;
    var phi_3985_: f32;
    var phi_3986_: bool;
    var phi_3987_: bool;
    var phi_3988_: bool;
    var phi_3989_: bool;
    var phi_3990_: bool;
    var phi_2365_: f32;
    var phi_2367_: f32;
    var phi_2369_: f32;
    var phi_3991_: f32;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_3996_: bool;
    var phi_3997_: bool;
    var local_25: bool;
    var phi_4001_: f32;
    var phi_4002_: bool;
    var phi_4003_: bool;
    var phi_4004_: bool;
    var phi_4005_: bool;
    var phi_4010_: type_33;
    var phi_4011_: bool;
    var phi_4012_: bool;
    var phi_4013_: bool;
    var local_26: f32;
    var phi_4018_: type_33;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4025_: type_33;
    var phi_4026_: bool;
    var phi_4027_: bool;
    var phi_4032_: type_33;
    var phi_4033_: bool;
    var phi_4037_: type_33;
    var phi_4051_: type_19;
    var phi_4052_: type_19;
    var phi_4075_: type_19;
    var phi_4095_: f32;
    var phi_4225_: type_17;
    var phi_4228_: f32;
    var phi_4249_: bool;
    var phi_4255_: type_18;
    var phi_4226_: type_17;
    var phi_4269_: type_18;
    var phi_4229_: f32;
    var local_27: f32;
    var phi_4218_: f32;
    var phi_4282_: f32;
    var phi_4298_: f32;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4317_: f32;
    var phi_4322_: f32;
    var phi_4335_: f32;
    var phi_4342_: f32;
    var phi_4347_: f32;
    var phi_4354_: f32;
    var phi_4359_: f32;
    var phi_4364_: f32;
    var phi_4381_: f32;
    var phi_4388_: f32;
    var phi_4393_: f32;
    var phi_4400_: f32;
    var phi_4405_: f32;
    var phi_4419_: f32;
    var phi_4426_: f32;
    var phi_4431_: f32;
    var phi_4438_: f32;
    var phi_4443_: f32;
    var phi_4448_: f32;
    var phi_4465_: f32;
    var phi_4472_: f32;
    var phi_4477_: f32;
    var phi_4484_: f32;
    var phi_4489_: f32;
    var phi_4503_: f32;
    var phi_4510_: f32;
    var phi_4515_: f32;
    var phi_4522_: f32;
    var phi_4527_: f32;
    var phi_4532_: f32;
    var phi_4552_: bool;
    var phi_4553_: bool;
    var phi_4554_: bool;
    var local_28: bool;
    var phi_4559_: type_33;
    var phi_4560_: bool;
    var phi_4565_: type_33;
    var phi_4566_: bool;
    var phi_4568_: type_33;
    var phi_4569_: type_33;
    var phi_4570_: bool;
    var phi_4574_: type_33;
    var phi_8456_: type_33;
    var phi_8457_: type_33;
    var phi_8470_: type_36;
    var phi_8477_: bool;
    var phi_8501_: u32;
    var phi_8505_: type_27;
    var phi_8506_: bool;
    var phi_8507_: bool;
    var phi_8525_: u32;
    var phi_8587_: u32;
    var local_29: u32;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f32;
    var local_44: f32;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
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
    let _e122 = params.member.member_15;
    let _e124 = input.member[0u];
    if (_e122 < _e124) {
        phi_760_ = _e122;
    } else {
        phi_760_ = _e124;
    }
    let _e127 = phi_760_;
    let _e128 = (_e127 / 64u);
    if ((_e127 % 64u) > 0u) {
        phi_776_ = (_e128 + 1u);
    } else {
        phi_776_ = _e128;
    }
    let _e133 = phi_776_;
    if (_e133 > _e117) {
        let _e135 = (_e133 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e137 = (_e135 / _e120);
        if (_e120 == 0u) {
            return;
        }
        if ((_e135 % _e120) > 0u) {
            phi_797_ = (_e137 + 1u);
        } else {
            phi_797_ = _e137;
        }
        let _e143 = phi_797_;
        phi_798_ = _e143;
    } else {
        phi_798_ = 0u;
    }
    let _e145 = phi_798_;
    phi_801_ = type_19(0u, _e145);
    loop {
        let _e148 = phi_801_;
        if (_e148.member < _e148.member_1) {
            phi_802_ = type_19((_e148.member + 1u), _e148.member_1);
            phi_825_ = type_19(1u, _e148.member);
        } else {
            phi_802_ = _e148;
            phi_825_ = type_19(0u, type_19().member_1);
        }
        let _e160 = phi_802_;
        let _e162 = phi_825_;
        let _e166 = (bitcast<i32>(_e162.member) != 0i);
        if _e166 {
            let _e170 = (((_e117 + (_e162.member_1 * _e120)) * 64u) + _e105);
            let _e172 = params.member.member_8;
            if (_e170 < _e127) {
                let _e175 = (2u * _e170);
                let _e178 = input.member[(4u + _e175)];
                let _e181 = input.member[(_e175 + 5u)];
                let _e183 = elements.member[_e181];
                let _e188 = paths.member[_e178];
                let _e190 = paths.member[_e183[0]];
                let _e196 = paths.member[_e183[1]];
                let _e198 = paths.member[_e183[2]];
                let _e228 = params.member.member_4;
                let _e229 = (_e188.member[0] - _e190.member[0]);
                let _e230 = (_e188.member[1] - _e190.member[1]);
                let _e231 = (_e188.member[2] - _e190.member[2]);
                let _e233 = (_e188.member_1[0] - _e190.member_1[0]);
                let _e234 = (_e188.member_1[1] - _e190.member_1[1]);
                let _e235 = (_e188.member_1[2] - _e190.member_1[2]);
                let _e238 = (_e196.member[0] - _e190.member[0]);
                let _e239 = (_e196.member[1] - _e190.member[1]);
                let _e240 = (_e196.member[2] - _e190.member[2]);
                let _e242 = (_e196.member_1[0] - _e190.member_1[0]);
                let _e243 = (_e196.member_1[1] - _e190.member_1[1]);
                let _e244 = (_e196.member_1[2] - _e190.member_1[2]);
                let _e247 = (_e198.member[0] - _e190.member[0]);
                let _e248 = (_e198.member[1] - _e190.member[1]);
                let _e249 = (_e198.member[2] - _e190.member[2]);
                let _e251 = (_e198.member_1[0] - _e190.member_1[0]);
                let _e252 = (_e198.member_1[1] - _e190.member_1[1]);
                let _e253 = (_e198.member_1[2] - _e190.member_1[2]);
                let _e256 = (_e228 + _e228);
                let _e259 = params.member.member_5;
                if (_e229 < 0f) {
                    phi_990_ = -(_e229);
                } else {
                    phi_990_ = _e229;
                }
                let _e263 = phi_990_;
                if (_e230 < 0f) {
                    phi_996_ = -(_e230);
                } else {
                    phi_996_ = _e230;
                }
                let _e267 = phi_996_;
                if (_e263 > _e267) {
                    phi_1001_ = _e263;
                } else {
                    phi_1001_ = _e267;
                }
                let _e270 = phi_1001_;
                if (_e231 < 0f) {
                    phi_1007_ = -(_e231);
                } else {
                    phi_1007_ = _e231;
                }
                let _e274 = phi_1007_;
                if (_e270 > _e274) {
                    phi_1012_ = _e270;
                } else {
                    phi_1012_ = _e274;
                }
                let _e277 = phi_1012_;
                if (_e233 < 0f) {
                    phi_1018_ = -(_e233);
                } else {
                    phi_1018_ = _e233;
                }
                let _e281 = phi_1018_;
                if (_e234 < 0f) {
                    phi_1024_ = -(_e234);
                } else {
                    phi_1024_ = _e234;
                }
                let _e285 = phi_1024_;
                if (_e281 > _e285) {
                    phi_1029_ = _e281;
                } else {
                    phi_1029_ = _e285;
                }
                let _e288 = phi_1029_;
                if (_e235 < 0f) {
                    phi_1035_ = -(_e235);
                } else {
                    phi_1035_ = _e235;
                }
                let _e292 = phi_1035_;
                if (_e288 > _e292) {
                    phi_1040_ = _e288;
                } else {
                    phi_1040_ = _e292;
                }
                let _e295 = phi_1040_;
                if (_e277 > _e295) {
                    phi_1045_ = _e277;
                } else {
                    phi_1045_ = _e295;
                }
                let _e298 = phi_1045_;
                let _e299 = (_e298 + _e256);
                if (_e238 < 0f) {
                    phi_1052_ = -(_e238);
                } else {
                    phi_1052_ = _e238;
                }
                let _e303 = phi_1052_;
                if (_e239 < 0f) {
                    phi_1058_ = -(_e239);
                } else {
                    phi_1058_ = _e239;
                }
                let _e307 = phi_1058_;
                if (_e303 > _e307) {
                    phi_1063_ = _e303;
                } else {
                    phi_1063_ = _e307;
                }
                let _e310 = phi_1063_;
                if (_e240 < 0f) {
                    phi_1069_ = -(_e240);
                } else {
                    phi_1069_ = _e240;
                }
                let _e314 = phi_1069_;
                if (_e310 > _e314) {
                    phi_1074_ = _e310;
                } else {
                    phi_1074_ = _e314;
                }
                let _e317 = phi_1074_;
                if (_e242 < 0f) {
                    phi_1080_ = -(_e242);
                } else {
                    phi_1080_ = _e242;
                }
                let _e321 = phi_1080_;
                if (_e243 < 0f) {
                    phi_1086_ = -(_e243);
                } else {
                    phi_1086_ = _e243;
                }
                let _e325 = phi_1086_;
                if (_e321 > _e325) {
                    phi_1091_ = _e321;
                } else {
                    phi_1091_ = _e325;
                }
                let _e328 = phi_1091_;
                if (_e244 < 0f) {
                    phi_1097_ = -(_e244);
                } else {
                    phi_1097_ = _e244;
                }
                let _e332 = phi_1097_;
                if (_e328 > _e332) {
                    phi_1102_ = _e328;
                } else {
                    phi_1102_ = _e332;
                }
                let _e335 = phi_1102_;
                if (_e317 > _e335) {
                    phi_1107_ = _e317;
                } else {
                    phi_1107_ = _e335;
                }
                let _e338 = phi_1107_;
                let _e339 = (_e338 + _e256);
                if (_e247 < 0f) {
                    phi_1114_ = -(_e247);
                } else {
                    phi_1114_ = _e247;
                }
                let _e343 = phi_1114_;
                if (_e248 < 0f) {
                    phi_1120_ = -(_e248);
                } else {
                    phi_1120_ = _e248;
                }
                let _e347 = phi_1120_;
                if (_e343 > _e347) {
                    phi_1125_ = _e343;
                } else {
                    phi_1125_ = _e347;
                }
                let _e350 = phi_1125_;
                if (_e249 < 0f) {
                    phi_1131_ = -(_e249);
                } else {
                    phi_1131_ = _e249;
                }
                let _e354 = phi_1131_;
                if (_e350 > _e354) {
                    phi_1136_ = _e350;
                } else {
                    phi_1136_ = _e354;
                }
                let _e357 = phi_1136_;
                if (_e251 < 0f) {
                    phi_1142_ = -(_e251);
                } else {
                    phi_1142_ = _e251;
                }
                let _e361 = phi_1142_;
                if (_e252 < 0f) {
                    phi_1148_ = -(_e252);
                } else {
                    phi_1148_ = _e252;
                }
                let _e365 = phi_1148_;
                if (_e361 > _e365) {
                    phi_1153_ = _e361;
                } else {
                    phi_1153_ = _e365;
                }
                let _e368 = phi_1153_;
                if (_e253 < 0f) {
                    phi_1159_ = -(_e253);
                } else {
                    phi_1159_ = _e253;
                }
                let _e372 = phi_1159_;
                if (_e368 > _e372) {
                    phi_1164_ = _e368;
                } else {
                    phi_1164_ = _e372;
                }
                let _e375 = phi_1164_;
                if (_e357 > _e375) {
                    phi_1169_ = _e357;
                } else {
                    phi_1169_ = _e375;
                }
                let _e378 = phi_1169_;
                let _e379 = (_e378 + _e256);
                if (_e299 > _e339) {
                    phi_1175_ = _e299;
                } else {
                    phi_1175_ = _e339;
                }
                let _e382 = phi_1175_;
                if (_e382 > _e379) {
                    phi_1180_ = _e382;
                } else {
                    phi_1180_ = _e379;
                }
                let _e385 = phi_1180_;
                if (_e385 <= 65536f) {
                    phi_1187_ = (_e385 >= (1f / 65536f));
                } else {
                    phi_1187_ = false;
                }
                let _e390 = phi_1187_;
                if _e390 {
                    phi_1258_ = type_32();
                    phi_1259_ = true;
                } else {
                    if (_e385 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e385) & 2139095040u) != 2139095040u) {
                            let _e397 = (2130706432u - (bitcast<u32>(_e385) & 2139095040u));
                            if (_e397 > 8388608u) {
                                phi_1211_ = _e397;
                            } else {
                                phi_1211_ = 8388608u;
                            }
                            let _e400 = phi_1211_;
                            let _e401 = bitcast<f32>(_e400);
                            let _e402 = (_e259 * _e401);
                            if (_e259 > 0f) {
                                if (_e402 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1222_ = _e402;
                                } else {
                                    phi_1222_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e406 = phi_1222_;
                                phi_1223_ = _e406;
                            } else {
                                phi_1223_ = _e402;
                            }
                            let _e408 = phi_1223_;
                            phi_1254_ = type_32(type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e229 * _e401), (_e230 * _e401), (_e231 * _e401)), array<f32, 3>((_e233 * _e401), (_e234 * _e401), (_e235 * _e401))), array<array<f32, 3>, 2>(array<f32, 3>((_e238 * _e401), (_e239 * _e401), (_e240 * _e401)), array<f32, 3>((_e242 * _e401), (_e243 * _e401), (_e244 * _e401))), array<array<f32, 3>, 2>(array<f32, 3>((_e247 * _e401), (_e248 * _e401), (_e249 * _e401)), array<f32, 3>((_e251 * _e401), (_e252 * _e401), (_e253 * _e401))), (_e256 * _e401)), _e408);
                            phi_1255_ = false;
                        } else {
                            phi_1254_ = type_32();
                            phi_1255_ = true;
                        }
                        let _e440 = phi_1254_;
                        let _e442 = phi_1255_;
                        phi_1256_ = _e440;
                        phi_1257_ = _e442;
                    } else {
                        phi_1256_ = type_32();
                        phi_1257_ = true;
                    }
                    let _e444 = phi_1256_;
                    let _e446 = phi_1257_;
                    phi_1258_ = _e444;
                    phi_1259_ = _e446;
                }
                let _e448 = phi_1258_;
                let _e450 = phi_1259_;
                if _e450 {
                    phi_1264_ = type_32(type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e229, _e230, _e231), array<f32, 3>(_e233, _e234, _e235)), array<array<f32, 3>, 2>(array<f32, 3>(_e238, _e239, _e240), array<f32, 3>(_e242, _e243, _e244)), array<array<f32, 3>, 2>(array<f32, 3>(_e247, _e248, _e249), array<f32, 3>(_e251, _e252, _e253)), _e256), _e259);
                } else {
                    phi_1264_ = _e448;
                }
                let _e453 = phi_1264_;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e453.member.member[0][0], _e453.member.member[0][1], _e453.member.member[0][2]), array<f32, 3>(_e453.member.member[1][0], _e453.member.member[1][1], _e453.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e453.member.member_1[0][0], _e453.member.member_1[0][1], _e453.member.member_1[0][2]), array<f32, 3>(_e453.member.member_1[1][0], _e453.member.member_1[1][1], _e453.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e453.member.member_2[0][0], _e453.member.member_2[0][1], _e453.member.member_2[0][2]), array<f32, 3>(_e453.member.member_2[1][0], _e453.member.member_2[1][1], _e453.member.member_2[1][2])), _e453.member.member_3);
                let _e496 = local_12.member_1[0u];
                let _e502 = local_12.member_2[0u];
                let _e508 = ((_e496[1] * _e502[2]) - (_e496[2] * _e502[1]));
                let _e511 = ((_e496[2] * _e502[0]) - (_e496[0] * _e502[2]));
                let _e514 = ((_e496[0] * _e502[1]) - (_e496[1] * _e502[0]));
                let _e517 = local_12.member_1[1u];
                let _e523 = local_12.member_2[1u];
                let _e529 = ((_e517[1] * _e523[2]) - (_e517[2] * _e523[1]));
                let _e532 = ((_e517[2] * _e523[0]) - (_e517[0] * _e523[2]));
                let _e535 = ((_e517[0] * _e523[1]) - (_e517[1] * _e523[0]));
                let _e538 = local_12.member_1[0u];
                let _e544 = local_12.member_2[1u];
                let _e559 = local_12.member_1[1u];
                let _e565 = local_12.member_2[0u];
                let _e578 = (((_e538[1] * _e544[2]) - (_e538[2] * _e544[1])) + ((_e559[1] * _e565[2]) - (_e559[2] * _e565[1])));
                let _e579 = (((_e538[2] * _e544[0]) - (_e538[0] * _e544[2])) + ((_e559[2] * _e565[0]) - (_e559[0] * _e565[2])));
                let _e580 = (((_e538[0] * _e544[1]) - (_e538[1] * _e544[0])) + ((_e559[0] * _e565[1]) - (_e559[1] * _e565[0])));
                let _e583 = local_12.member[0u];
                let _e591 = (((_e583[0] * _e508) + (_e583[1] * _e511)) + (_e583[2] * _e514));
                let _e594 = local_12.member[1u];
                let _e605 = local_12.member[0u];
                let _e614 = ((((_e594[0] * _e508) + (_e594[1] * _e511)) + (_e594[2] * _e514)) + (((_e605[0] * _e578) + (_e605[1] * _e579)) + (_e605[2] * _e580)));
                let _e617 = local_12.member[0u];
                let _e628 = local_12.member[1u];
                let _e637 = ((((_e617[0] * _e529) + (_e617[1] * _e532)) + (_e617[2] * _e535)) + (((_e628[0] * _e578) + (_e628[1] * _e579)) + (_e628[2] * _e580)));
                let _e640 = local_12.member[1u];
                let _e648 = (((_e640[0] * _e529) + (_e640[1] * _e532)) + (_e640[2] * _e535));
                let _e651 = local_12.member[0u];
                if (_e651[0] < 0f) {
                    phi_1546_ = -(_e651[0]);
                } else {
                    phi_1546_ = _e651[0];
                }
                let _e658 = phi_1546_;
                if (_e651[1] < 0f) {
                    phi_1553_ = -(_e651[1]);
                } else {
                    phi_1553_ = _e651[1];
                }
                let _e662 = phi_1553_;
                if (_e658 > _e662) {
                    phi_1558_ = _e658;
                } else {
                    phi_1558_ = _e662;
                }
                let _e665 = phi_1558_;
                if (_e651[2] < 0f) {
                    phi_1565_ = -(_e651[2]);
                } else {
                    phi_1565_ = _e651[2];
                }
                let _e669 = phi_1565_;
                if (_e665 > _e669) {
                    phi_1570_ = _e665;
                } else {
                    phi_1570_ = _e669;
                }
                let _e672 = phi_1570_;
                let _e675 = local_12.member[1u];
                if (_e675[0] < 0f) {
                    phi_1583_ = -(_e675[0]);
                } else {
                    phi_1583_ = _e675[0];
                }
                let _e682 = phi_1583_;
                if (_e675[1] < 0f) {
                    phi_1590_ = -(_e675[1]);
                } else {
                    phi_1590_ = _e675[1];
                }
                let _e686 = phi_1590_;
                if (_e682 > _e686) {
                    phi_1595_ = _e682;
                } else {
                    phi_1595_ = _e686;
                }
                let _e689 = phi_1595_;
                if (_e675[2] < 0f) {
                    phi_1602_ = -(_e675[2]);
                } else {
                    phi_1602_ = _e675[2];
                }
                let _e693 = phi_1602_;
                if (_e689 > _e693) {
                    phi_1607_ = _e689;
                } else {
                    phi_1607_ = _e693;
                }
                let _e696 = phi_1607_;
                if (_e672 > _e696) {
                    phi_1612_ = _e672;
                } else {
                    phi_1612_ = _e696;
                }
                let _e699 = phi_1612_;
                let _e701 = local_12.member_3;
                let _e702 = (_e699 + _e701);
                let _e705 = local_12.member_1[0u];
                if (_e705[0] < 0f) {
                    phi_1629_ = -(_e705[0]);
                } else {
                    phi_1629_ = _e705[0];
                }
                let _e712 = phi_1629_;
                if (_e705[1] < 0f) {
                    phi_1636_ = -(_e705[1]);
                } else {
                    phi_1636_ = _e705[1];
                }
                let _e716 = phi_1636_;
                if (_e712 > _e716) {
                    phi_1641_ = _e712;
                } else {
                    phi_1641_ = _e716;
                }
                let _e719 = phi_1641_;
                if (_e705[2] < 0f) {
                    phi_1648_ = -(_e705[2]);
                } else {
                    phi_1648_ = _e705[2];
                }
                let _e723 = phi_1648_;
                if (_e719 > _e723) {
                    phi_1653_ = _e719;
                } else {
                    phi_1653_ = _e723;
                }
                let _e726 = phi_1653_;
                let _e729 = local_12.member_1[1u];
                if (_e729[0] < 0f) {
                    phi_1667_ = -(_e729[0]);
                } else {
                    phi_1667_ = _e729[0];
                }
                let _e736 = phi_1667_;
                if (_e729[1] < 0f) {
                    phi_1674_ = -(_e729[1]);
                } else {
                    phi_1674_ = _e729[1];
                }
                let _e740 = phi_1674_;
                if (_e736 > _e740) {
                    phi_1679_ = _e736;
                } else {
                    phi_1679_ = _e740;
                }
                let _e743 = phi_1679_;
                if (_e729[2] < 0f) {
                    phi_1686_ = -(_e729[2]);
                } else {
                    phi_1686_ = _e729[2];
                }
                let _e747 = phi_1686_;
                if (_e743 > _e747) {
                    phi_1691_ = _e743;
                } else {
                    phi_1691_ = _e747;
                }
                let _e750 = phi_1691_;
                if (_e726 > _e750) {
                    phi_1696_ = _e726;
                } else {
                    phi_1696_ = _e750;
                }
                let _e753 = phi_1696_;
                let _e755 = local_12.member_3;
                let _e756 = (_e753 + _e755);
                let _e759 = local_12.member_2[0u];
                if (_e759[0] < 0f) {
                    phi_1713_ = -(_e759[0]);
                } else {
                    phi_1713_ = _e759[0];
                }
                let _e766 = phi_1713_;
                if (_e759[1] < 0f) {
                    phi_1720_ = -(_e759[1]);
                } else {
                    phi_1720_ = _e759[1];
                }
                let _e770 = phi_1720_;
                if (_e766 > _e770) {
                    phi_1725_ = _e766;
                } else {
                    phi_1725_ = _e770;
                }
                let _e773 = phi_1725_;
                if (_e759[2] < 0f) {
                    phi_1732_ = -(_e759[2]);
                } else {
                    phi_1732_ = _e759[2];
                }
                let _e777 = phi_1732_;
                if (_e773 > _e777) {
                    phi_1737_ = _e773;
                } else {
                    phi_1737_ = _e777;
                }
                let _e780 = phi_1737_;
                let _e783 = local_12.member_2[1u];
                if (_e783[0] < 0f) {
                    phi_1751_ = -(_e783[0]);
                } else {
                    phi_1751_ = _e783[0];
                }
                let _e790 = phi_1751_;
                if (_e783[1] < 0f) {
                    phi_1758_ = -(_e783[1]);
                } else {
                    phi_1758_ = _e783[1];
                }
                let _e794 = phi_1758_;
                if (_e790 > _e794) {
                    phi_1763_ = _e790;
                } else {
                    phi_1763_ = _e794;
                }
                let _e797 = phi_1763_;
                if (_e783[2] < 0f) {
                    phi_1770_ = -(_e783[2]);
                } else {
                    phi_1770_ = _e783[2];
                }
                let _e801 = phi_1770_;
                if (_e797 > _e801) {
                    phi_1775_ = _e797;
                } else {
                    phi_1775_ = _e801;
                }
                let _e804 = phi_1775_;
                if (_e780 > _e804) {
                    phi_1780_ = _e780;
                } else {
                    phi_1780_ = _e804;
                }
                let _e807 = phi_1780_;
                let _e809 = local_12.member_3;
                let _e810 = (_e807 + _e809);
                let _e812 = ((_e756 * 8f) * _e810);
                let _e819 = local_12.member_3;
                if (_e508 < 0f) {
                    phi_1811_ = -(_e508);
                } else {
                    phi_1811_ = _e508;
                }
                let _e836 = phi_1811_;
                if (_e511 < 0f) {
                    phi_1817_ = -(_e511);
                } else {
                    phi_1817_ = _e511;
                }
                let _e840 = phi_1817_;
                if (_e514 < 0f) {
                    phi_1824_ = -(_e514);
                } else {
                    phi_1824_ = _e514;
                }
                let _e845 = phi_1824_;
                let _e846 = ((_e836 + _e840) + _e845);
                if (_e529 < 0f) {
                    phi_1831_ = -(_e529);
                } else {
                    phi_1831_ = _e529;
                }
                let _e850 = phi_1831_;
                if (_e532 < 0f) {
                    phi_1837_ = -(_e532);
                } else {
                    phi_1837_ = _e532;
                }
                let _e854 = phi_1837_;
                if (_e535 < 0f) {
                    phi_1844_ = -(_e535);
                } else {
                    phi_1844_ = _e535;
                }
                let _e859 = phi_1844_;
                let _e860 = ((_e850 + _e854) + _e859);
                if (_e846 > _e860) {
                    phi_1850_ = _e846;
                } else {
                    phi_1850_ = _e860;
                }
                let _e863 = phi_1850_;
                if (_e578 < 0f) {
                    phi_1856_ = -(_e578);
                } else {
                    phi_1856_ = _e578;
                }
                let _e867 = phi_1856_;
                if (_e579 < 0f) {
                    phi_1862_ = -(_e579);
                } else {
                    phi_1862_ = _e579;
                }
                let _e871 = phi_1862_;
                if (_e580 < 0f) {
                    phi_1869_ = -(_e580);
                } else {
                    phi_1869_ = _e580;
                }
                let _e876 = phi_1869_;
                let _e878 = (((_e867 + _e871) + _e876) * 0.5f);
                if (_e863 > _e878) {
                    phi_1876_ = _e863;
                } else {
                    phi_1876_ = _e878;
                }
                let _e881 = phi_1876_;
                let _e886 = local_12.member_3;
                let _e898 = (((((_e702 * 8f) * _e812) * (0.000000059604645f * (524f / 64f))) + ((_e819 * 19f) * ((_e702 * (_e756 + _e810)) + (_e756 * _e810)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e702) * ((1f + _e756) * (1f + _e810)))));
                let _e899 = (_e591 * 3f);
                let _e900 = (_e648 * 3f);
                if (_e899 < _e900) {
                    phi_1900_ = _e899;
                } else {
                    phi_1900_ = _e900;
                }
                let _e903 = phi_1900_;
                if (_e614 < _e637) {
                    phi_1905_ = _e614;
                } else {
                    phi_1905_ = _e637;
                }
                let _e906 = phi_1905_;
                if (_e903 < _e906) {
                    phi_1910_ = _e903;
                } else {
                    phi_1910_ = _e906;
                }
                let _e909 = phi_1910_;
                if (_e899 > _e900) {
                    phi_1915_ = _e899;
                } else {
                    phi_1915_ = _e900;
                }
                let _e912 = phi_1915_;
                if (_e614 > _e637) {
                    phi_1920_ = _e614;
                } else {
                    phi_1920_ = _e637;
                }
                let _e915 = phi_1920_;
                if (_e912 > _e915) {
                    phi_1925_ = _e912;
                } else {
                    phi_1925_ = _e915;
                }
                let _e918 = phi_1925_;
                let _e923 = -(_e918);
                if (_e909 > _e923) {
                    phi_1935_ = _e909;
                } else {
                    phi_1935_ = _e923;
                }
                let _e926 = phi_1935_;
                if ((_e926 - (_e898 + ((_e453.member_1 * (((_e881 + (_e812 * (0.000000059604645f * 8f))) + ((_e886 * 6f) * (_e756 + _e810))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e756) * (1f + _e810))))) * (3f * 1.0001f)))) > 0f) {
                    phi_8457_ = type_33(0u, type_33().member_1);
                } else {
                    if (_e453.member_1 > 0f) {
                        let _e3485 = local_12.member[0u];
                        let _e3491 = local_12.member_1[0u];
                        let _e3497 = local_12.member_2[0u];
                        let _e3509 = local_12.member[1u];
                        let _e3515 = local_12.member_1[1u];
                        let _e3521 = local_12.member_2[1u];
                        let _e3533 = local_12.member[0u];
                        if (_e3533[0] < 0f) {
                            phi_2088_ = -(_e3533[0]);
                        } else {
                            phi_2088_ = _e3533[0];
                        }
                        let _e3540 = phi_2088_;
                        if (_e3533[1] < 0f) {
                            phi_2095_ = -(_e3533[1]);
                        } else {
                            phi_2095_ = _e3533[1];
                        }
                        let _e3544 = phi_2095_;
                        if (_e3540 > _e3544) {
                            phi_2100_ = _e3540;
                        } else {
                            phi_2100_ = _e3544;
                        }
                        let _e3547 = phi_2100_;
                        if (_e3533[2] < 0f) {
                            phi_2107_ = -(_e3533[2]);
                        } else {
                            phi_2107_ = _e3533[2];
                        }
                        let _e3551 = phi_2107_;
                        if (_e3547 > _e3551) {
                            phi_2112_ = _e3547;
                        } else {
                            phi_2112_ = _e3551;
                        }
                        let _e3554 = phi_2112_;
                        let _e3557 = local_12.member[1u];
                        if (_e3557[0] < 0f) {
                            phi_2125_ = -(_e3557[0]);
                        } else {
                            phi_2125_ = _e3557[0];
                        }
                        let _e3564 = phi_2125_;
                        if (_e3557[1] < 0f) {
                            phi_2132_ = -(_e3557[1]);
                        } else {
                            phi_2132_ = _e3557[1];
                        }
                        let _e3568 = phi_2132_;
                        if (_e3564 > _e3568) {
                            phi_2137_ = _e3564;
                        } else {
                            phi_2137_ = _e3568;
                        }
                        let _e3571 = phi_2137_;
                        if (_e3557[2] < 0f) {
                            phi_2144_ = -(_e3557[2]);
                        } else {
                            phi_2144_ = _e3557[2];
                        }
                        let _e3575 = phi_2144_;
                        if (_e3571 > _e3575) {
                            phi_2149_ = _e3571;
                        } else {
                            phi_2149_ = _e3575;
                        }
                        let _e3578 = phi_2149_;
                        if (_e3554 > _e3578) {
                            phi_2154_ = _e3554;
                        } else {
                            phi_2154_ = _e3578;
                        }
                        let _e3581 = phi_2154_;
                        let _e3583 = local_12.member_3;
                        let _e3587 = local_12.member_1[0u];
                        if (_e3587[0] < 0f) {
                            phi_2171_ = -(_e3587[0]);
                        } else {
                            phi_2171_ = _e3587[0];
                        }
                        let _e3594 = phi_2171_;
                        if (_e3587[1] < 0f) {
                            phi_2178_ = -(_e3587[1]);
                        } else {
                            phi_2178_ = _e3587[1];
                        }
                        let _e3598 = phi_2178_;
                        if (_e3594 > _e3598) {
                            phi_2183_ = _e3594;
                        } else {
                            phi_2183_ = _e3598;
                        }
                        let _e3601 = phi_2183_;
                        if (_e3587[2] < 0f) {
                            phi_2190_ = -(_e3587[2]);
                        } else {
                            phi_2190_ = _e3587[2];
                        }
                        let _e3605 = phi_2190_;
                        if (_e3601 > _e3605) {
                            phi_2195_ = _e3601;
                        } else {
                            phi_2195_ = _e3605;
                        }
                        let _e3608 = phi_2195_;
                        let _e3611 = local_12.member_1[1u];
                        if (_e3611[0] < 0f) {
                            phi_2209_ = -(_e3611[0]);
                        } else {
                            phi_2209_ = _e3611[0];
                        }
                        let _e3618 = phi_2209_;
                        if (_e3611[1] < 0f) {
                            phi_2216_ = -(_e3611[1]);
                        } else {
                            phi_2216_ = _e3611[1];
                        }
                        let _e3622 = phi_2216_;
                        if (_e3618 > _e3622) {
                            phi_2221_ = _e3618;
                        } else {
                            phi_2221_ = _e3622;
                        }
                        let _e3625 = phi_2221_;
                        if (_e3611[2] < 0f) {
                            phi_2228_ = -(_e3611[2]);
                        } else {
                            phi_2228_ = _e3611[2];
                        }
                        let _e3629 = phi_2228_;
                        if (_e3625 > _e3629) {
                            phi_2233_ = _e3625;
                        } else {
                            phi_2233_ = _e3629;
                        }
                        let _e3632 = phi_2233_;
                        if (_e3608 > _e3632) {
                            phi_2238_ = _e3608;
                        } else {
                            phi_2238_ = _e3632;
                        }
                        let _e3635 = phi_2238_;
                        let _e3637 = local_12.member_3;
                        let _e3641 = local_12.member_2[0u];
                        if (_e3641[0] < 0f) {
                            phi_2255_ = -(_e3641[0]);
                        } else {
                            phi_2255_ = _e3641[0];
                        }
                        let _e3648 = phi_2255_;
                        if (_e3641[1] < 0f) {
                            phi_2262_ = -(_e3641[1]);
                        } else {
                            phi_2262_ = _e3641[1];
                        }
                        let _e3652 = phi_2262_;
                        if (_e3648 > _e3652) {
                            phi_2267_ = _e3648;
                        } else {
                            phi_2267_ = _e3652;
                        }
                        let _e3655 = phi_2267_;
                        if (_e3641[2] < 0f) {
                            phi_2274_ = -(_e3641[2]);
                        } else {
                            phi_2274_ = _e3641[2];
                        }
                        let _e3659 = phi_2274_;
                        if (_e3655 > _e3659) {
                            phi_2279_ = _e3655;
                        } else {
                            phi_2279_ = _e3659;
                        }
                        let _e3662 = phi_2279_;
                        let _e3665 = local_12.member_2[1u];
                        if (_e3665[0] < 0f) {
                            phi_2293_ = -(_e3665[0]);
                        } else {
                            phi_2293_ = _e3665[0];
                        }
                        let _e3672 = phi_2293_;
                        if (_e3665[1] < 0f) {
                            phi_2300_ = -(_e3665[1]);
                        } else {
                            phi_2300_ = _e3665[1];
                        }
                        let _e3676 = phi_2300_;
                        if (_e3672 > _e3676) {
                            phi_2305_ = _e3672;
                        } else {
                            phi_2305_ = _e3676;
                        }
                        let _e3679 = phi_2305_;
                        if (_e3665[2] < 0f) {
                            phi_2312_ = -(_e3665[2]);
                        } else {
                            phi_2312_ = _e3665[2];
                        }
                        let _e3683 = phi_2312_;
                        if (_e3679 > _e3683) {
                            phi_2317_ = _e3679;
                        } else {
                            phi_2317_ = _e3683;
                        }
                        let _e3686 = phi_2317_;
                        if (_e3662 > _e3686) {
                            phi_2322_ = _e3662;
                        } else {
                            phi_2322_ = _e3686;
                        }
                        let _e3689 = phi_2322_;
                        let _e3691 = local_12.member_3;
                        let _e3698 = local_12.member_3;
                        local_9 = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_2361_ = type_19(0u, 96u);
                        phi_2364_ = 0f;
                        phi_2366_ = 0f;
                        phi_2368_ = 0f;
                        loop {
                            let _e3704 = phi_2361_;
                            let _e3706 = phi_2364_;
                            let _e3708 = phi_2366_;
                            let _e3710 = phi_2368_;
                            local_44 = _e3708;
                            local_26 = _e3706;
                            if (_e3704.member < _e3704.member_1) {
                                phi_2362_ = type_19((_e3704.member + 1u), _e3704.member_1);
                                phi_2391_ = type_19(1u, _e3704.member);
                            } else {
                                phi_2362_ = _e3704;
                                phi_2391_ = type_19(0u, type_19().member_1);
                            }
                            let _e3722 = phi_2362_;
                            let _e3724 = phi_2391_;
                            if (bitcast<i32>(_e3724.member) != 0i) {
                                let _e3731 = local_12.member[0u];
                                let _e3737 = local_12.member[1u];
                                let _e3753 = local_12.member_1[0u];
                                let _e3759 = local_12.member_1[1u];
                                let _e3775 = local_12.member_2[0u];
                                let _e3781 = local_12.member_2[1u];
                                let _e3795 = function_1(array<f32, 3>((_e3731[0] + ((_e3737[0] - _e3731[0]) * _e3706)), (_e3731[1] + ((_e3737[1] - _e3731[1]) * _e3706)), (_e3731[2] + ((_e3737[2] - _e3731[2]) * _e3706))), array<f32, 3>((_e3753[0] + ((_e3759[0] - _e3753[0]) * _e3706)), (_e3753[1] + ((_e3759[1] - _e3753[1]) * _e3706)), (_e3753[2] + ((_e3759[2] - _e3753[2]) * _e3706))), array<f32, 3>((_e3775[0] + ((_e3781[0] - _e3775[0]) * _e3706)), (_e3775[1] + ((_e3781[1] - _e3775[1]) * _e3706)), (_e3775[2] + ((_e3781[2] - _e3775[2]) * _e3706))), 0u);
                                if (_e3795[0] < 0f) {
                                    phi_2503_ = -(_e3795[0]);
                                } else {
                                    phi_2503_ = _e3795[0];
                                }
                                let _e3800 = phi_2503_;
                                if (_e3795[1] < 0f) {
                                    phi_2510_ = -(_e3795[1]);
                                } else {
                                    phi_2510_ = _e3795[1];
                                }
                                let _e3805 = phi_2510_;
                                if (_e3795[2] < 0f) {
                                    phi_2518_ = -(_e3795[2]);
                                } else {
                                    phi_2518_ = _e3795[2];
                                }
                                let _e3811 = phi_2518_;
                                let _e3812 = ((_e3800 + _e3805) + _e3811);
                                if (_e3812 > 0f) {
                                    if ((bitcast<u32>(_e3812) & 2139095040u) != 2139095040u) {
                                        let _e3817 = (1f / _e3812);
                                        let _e3819 = (_e3795[0] * _e3817);
                                        let _e3821 = (_e3795[1] * _e3817);
                                        let _e3823 = (_e3795[2] * _e3817);
                                        let _e3828 = (((_e3819 * _e3819) + (_e3821 * _e3821)) + (_e3823 * _e3823));
                                        if (_e3828 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3828 > 0f) {
                                                phi_2555_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2555_ = 0f;
                                            }
                                            let _e3881 = phi_2555_;
                                            phi_2619_ = _e3881;
                                        } else {
                                            phi_2562_ = type_17(0i, 5i);
                                            phi_2565_ = bitcast<f32>(((bitcast<u32>(_e3828) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3836 = phi_2562_;
                                                let _e3838 = phi_2565_;
                                                local_24 = _e3838;
                                                if (_e3836.member < _e3836.member_1) {
                                                    let _e3845 = (_e3836.member + 1i);
                                                    if ((false == (_e3845 > _e3836.member)) != false) {
                                                        phi_2586_ = true;
                                                    } else {
                                                        phi_2586_ = false;
                                                    }
                                                    let _e3850 = phi_2586_;
                                                    if _e3850 {
                                                        phi_2592_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2592_ = type_18(1u, _e3845);
                                                    }
                                                    let _e3855 = phi_2592_;
                                                    phi_2563_ = type_17(_e3855.member_1, _e3836.member_1);
                                                    phi_2606_ = type_18(1u, _e3836.member);
                                                } else {
                                                    phi_2563_ = _e3836;
                                                    phi_2606_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3861 = phi_2563_;
                                                let _e3863 = phi_2606_;
                                                let _e3866 = (bitcast<i32>(_e3863.member) != 0i);
                                                if _e3866 {
                                                    phi_2566_ = (0.5f * (_e3838 + (_e3828 / _e3838)));
                                                } else {
                                                    phi_2566_ = f32();
                                                }
                                                let _e3871 = phi_2566_;
                                                continue;
                                                continuing {
                                                    phi_2562_ = _e3861;
                                                    phi_2565_ = _e3871;
                                                    break if !(_e3866);
                                                }
                                            }
                                            let _e3876 = local_24;
                                            phi_2619_ = (_e3876 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3883 = phi_2619_;
                                        let _e3884 = (0.000000059604645f * 12f);
                                        let _e3889 = ((((((((_e3581 + _e3583) + (_e3635 + _e3637)) + (_e3689 + _e3691)) * (0.000000059604645f * 16f)) + (_e3698 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e453.member_1 * _e3883) * (1f + _e3884)));
                                        let _e3894 = (((_e3819 * _e3485[0]) + (_e3821 * _e3485[1])) + (_e3823 * _e3485[2]));
                                        let _e3899 = (((_e3819 * (_e3485[0] - _e3491[0])) + (_e3821 * (_e3485[1] - _e3491[1]))) + (_e3823 * (_e3485[2] - _e3491[2])));
                                        let _e3904 = (((_e3819 * (_e3485[0] - _e3497[0])) + (_e3821 * (_e3485[1] - _e3497[1]))) + (_e3823 * (_e3485[2] - _e3497[2])));
                                        let _e3909 = (((_e3819 * _e3485[0]) + (_e3821 * _e3485[1])) + (_e3823 * _e3485[2]));
                                        let _e3915 = (((_e3819 * _e3509[0]) + (_e3821 * _e3509[1])) + (_e3823 * _e3509[2]));
                                        let _e3920 = (((_e3819 * (_e3509[0] - _e3515[0])) + (_e3821 * (_e3509[1] - _e3515[1]))) + (_e3823 * (_e3509[2] - _e3515[2])));
                                        let _e3925 = (((_e3819 * (_e3509[0] - _e3521[0])) + (_e3821 * (_e3509[1] - _e3521[1]))) + (_e3823 * (_e3509[2] - _e3521[2])));
                                        let _e3930 = (((_e3819 * _e3509[0]) + (_e3821 * _e3509[1])) + (_e3823 * _e3509[2]));
                                        if (_e3894 < 0f) {
                                            phi_2685_ = -(_e3894);
                                        } else {
                                            phi_2685_ = _e3894;
                                        }
                                        let _e3935 = phi_2685_;
                                        if (_e3915 < 0f) {
                                            phi_2691_ = -(_e3915);
                                        } else {
                                            phi_2691_ = _e3915;
                                        }
                                        let _e3939 = phi_2691_;
                                        if (_e3899 < 0f) {
                                            phi_2700_ = -(_e3899);
                                        } else {
                                            phi_2700_ = _e3899;
                                        }
                                        let _e3946 = phi_2700_;
                                        if (_e3920 < 0f) {
                                            phi_2706_ = -(_e3920);
                                        } else {
                                            phi_2706_ = _e3920;
                                        }
                                        let _e3950 = phi_2706_;
                                        if (_e3904 < 0f) {
                                            phi_2715_ = -(_e3904);
                                        } else {
                                            phi_2715_ = _e3904;
                                        }
                                        let _e3957 = phi_2715_;
                                        if (_e3925 < 0f) {
                                            phi_2721_ = -(_e3925);
                                        } else {
                                            phi_2721_ = _e3925;
                                        }
                                        let _e3961 = phi_2721_;
                                        if (_e3909 < 0f) {
                                            phi_2730_ = -(_e3909);
                                        } else {
                                            phi_2730_ = _e3909;
                                        }
                                        let _e3968 = phi_2730_;
                                        if (_e3930 < 0f) {
                                            phi_2736_ = -(_e3930);
                                        } else {
                                            phi_2736_ = _e3930;
                                        }
                                        let _e3972 = phi_2736_;
                                        phi_2742_ = type_28(array<f32, 4>(_e3894, _e3899, _e3904, _e3909), array<f32, 4>(_e3915, _e3920, _e3925, _e3930), array<f32, 4>((_e3889 + ((_e3935 + _e3939) * _e3884)), (_e3889 + ((_e3946 + _e3950) * _e3884)), (_e3889 + ((_e3957 + _e3961) * _e3884)), (_e3889 + ((_e3968 + _e3972) * _e3884))));
                                        phi_2743_ = false;
                                    } else {
                                        phi_2742_ = type_28();
                                        phi_2743_ = true;
                                    }
                                    let _e3979 = phi_2742_;
                                    let _e3981 = phi_2743_;
                                    phi_2744_ = _e3979;
                                    phi_2745_ = _e3981;
                                } else {
                                    phi_2744_ = type_28();
                                    phi_2745_ = true;
                                }
                                let _e3983 = phi_2744_;
                                let _e3985 = phi_2745_;
                                if _e3985 {
                                    phi_2753_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2753_ = _e3983;
                                }
                                let _e3987 = phi_2753_;
                                local_10 = type_28(array<f32, 4>(_e3987.member[0], _e3987.member[1], _e3987.member[2], _e3987.member[3]), array<f32, 4>(_e3987.member_1[0], _e3987.member_1[1], _e3987.member_1[2], _e3987.member_1[3]), array<f32, 4>(_e3987.member_2[0], _e3987.member_2[1], _e3987.member_2[2], _e3987.member_2[3]));
                                let _e4007 = (_e3706 - _e3710);
                                let _e4010 = local_10.member[0u];
                                let _e4013 = local_10.member_1[0u];
                                let _e4016 = local_10.member[0u];
                                let _e4022 = local_10.member_2[0u];
                                if (((_e4010 + ((_e4013 - _e4016) * _e3706)) - _e4022) > 0f) {
                                    let _e4027 = local_10.member[1u];
                                    let _e4030 = local_10.member_1[1u];
                                    let _e4033 = local_10.member[1u];
                                    let _e4039 = local_10.member_2[1u];
                                    if (((_e4027 + ((_e4030 - _e4033) * _e3706)) - _e4039) > 0f) {
                                        let _e4044 = local_10.member[2u];
                                        let _e4047 = local_10.member_1[2u];
                                        let _e4050 = local_10.member[2u];
                                        let _e4056 = local_10.member_2[2u];
                                        if (((_e4044 + ((_e4047 - _e4050) * _e3706)) - _e4056) > 0f) {
                                            let _e4061 = local_10.member[3u];
                                            let _e4064 = local_10.member_1[3u];
                                            let _e4067 = local_10.member[3u];
                                            let _e4073 = local_10.member_2[3u];
                                            phi_2923_ = (((_e4061 + ((_e4064 - _e4067) * _e3706)) - _e4073) > 0f);
                                            phi_2924_ = false;
                                        } else {
                                            phi_2923_ = bool();
                                            phi_2924_ = true;
                                        }
                                        let _e4077 = phi_2923_;
                                        let _e4079 = phi_2924_;
                                        phi_2925_ = _e4077;
                                        phi_2926_ = _e4079;
                                    } else {
                                        phi_2925_ = bool();
                                        phi_2926_ = true;
                                    }
                                    let _e4081 = phi_2925_;
                                    let _e4083 = phi_2926_;
                                    phi_2927_ = _e4081;
                                    phi_2928_ = _e4083;
                                } else {
                                    phi_2927_ = bool();
                                    phi_2928_ = true;
                                }
                                let _e4085 = phi_2927_;
                                let _e4087 = phi_2928_;
                                if _e4087 {
                                    phi_2932_ = false;
                                } else {
                                    phi_2932_ = _e4085;
                                }
                                let _e4089 = phi_2932_;
                                if _e4089 {
                                    if (_e3706 <= _e3708) {
                                        phi_3242_ = true;
                                    } else {
                                        let _e4093 = local_9.member[0u];
                                        let _e4096 = local_9.member_1[0u];
                                        let _e4099 = local_9.member[0u];
                                        let _e4105 = local_9.member_2[0u];
                                        let _e4109 = local_10.member[0u];
                                        let _e4112 = local_10.member_1[0u];
                                        let _e4115 = local_10.member[0u];
                                        let _e4121 = local_10.member_2[0u];
                                        if ((((_e4093 + ((_e4096 - _e4099) * _e3706)) - _e4105) + ((_e4109 + ((_e4112 - _e4115) * _e3710)) - _e4121)) > 0f) {
                                            let _e4127 = local_9.member[1u];
                                            let _e4130 = local_9.member_1[1u];
                                            let _e4133 = local_9.member[1u];
                                            let _e4139 = local_9.member_2[1u];
                                            let _e4143 = local_10.member[1u];
                                            let _e4146 = local_10.member_1[1u];
                                            let _e4149 = local_10.member[1u];
                                            let _e4155 = local_10.member_2[1u];
                                            if ((((_e4127 + ((_e4130 - _e4133) * _e3706)) - _e4139) + ((_e4143 + ((_e4146 - _e4149) * _e3710)) - _e4155)) > 0f) {
                                                let _e4161 = local_9.member[2u];
                                                let _e4164 = local_9.member_1[2u];
                                                let _e4167 = local_9.member[2u];
                                                let _e4173 = local_9.member_2[2u];
                                                let _e4177 = local_10.member[2u];
                                                let _e4180 = local_10.member_1[2u];
                                                let _e4183 = local_10.member[2u];
                                                let _e4189 = local_10.member_2[2u];
                                                if ((((_e4161 + ((_e4164 - _e4167) * _e3706)) - _e4173) + ((_e4177 + ((_e4180 - _e4183) * _e3710)) - _e4189)) > 0f) {
                                                    let _e4195 = local_9.member[3u];
                                                    let _e4198 = local_9.member_1[3u];
                                                    let _e4201 = local_9.member[3u];
                                                    let _e4207 = local_9.member_2[3u];
                                                    let _e4211 = local_10.member[3u];
                                                    let _e4214 = local_10.member_1[3u];
                                                    let _e4217 = local_10.member[3u];
                                                    let _e4223 = local_10.member_2[3u];
                                                    phi_3229_ = ((((_e4195 + ((_e4198 - _e4201) * _e3706)) - _e4207) + ((_e4211 + ((_e4214 - _e4217) * _e3710)) - _e4223)) > 0f);
                                                    phi_3230_ = false;
                                                } else {
                                                    phi_3229_ = bool();
                                                    phi_3230_ = true;
                                                }
                                                let _e4228 = phi_3229_;
                                                let _e4230 = phi_3230_;
                                                phi_3231_ = _e4228;
                                                phi_3232_ = _e4230;
                                            } else {
                                                phi_3231_ = bool();
                                                phi_3232_ = true;
                                            }
                                            let _e4232 = phi_3231_;
                                            let _e4234 = phi_3232_;
                                            phi_3233_ = _e4232;
                                            phi_3234_ = _e4234;
                                        } else {
                                            phi_3233_ = bool();
                                            phi_3234_ = true;
                                        }
                                        let _e4236 = phi_3233_;
                                        let _e4238 = phi_3234_;
                                        if _e4238 {
                                            phi_3238_ = false;
                                        } else {
                                            phi_3238_ = _e4236;
                                        }
                                        let _e4240 = phi_3238_;
                                        phi_3242_ = _e4240;
                                    }
                                    let _e4242 = phi_3242_;
                                    if _e4242 {
                                        if (_e3724.member_1 > 0u) {
                                            if (_e3706 >= 1f) {
                                                phi_3254_ = false;
                                            } else {
                                                phi_3254_ = true;
                                            }
                                            let _e4246 = phi_3254_;
                                            phi_3255_ = _e4246;
                                        } else {
                                            phi_3255_ = true;
                                        }
                                        let _e4248 = phi_3255_;
                                        if _e4248 {
                                            local_9 = type_28(array<f32, 4>(_e3987.member[0], _e3987.member[1], _e3987.member[2], _e3987.member[3]), array<f32, 4>(_e3987.member_1[0], _e3987.member_1[1], _e3987.member_1[2], _e3987.member_1[3]), array<f32, 4>(_e3987.member_2[0], _e3987.member_2[1], _e3987.member_2[2], _e3987.member_2[3]));
                                            let _e4270 = local_9.member[0u];
                                            let _e4273 = local_9.member_1[0u];
                                            let _e4276 = local_9.member_2[0u];
                                            if (_e4270 > _e4276) {
                                                if (_e4273 > _e4276) {
                                                    phi_3329_ = false;
                                                } else {
                                                    phi_3329_ = true;
                                                }
                                                let _e4280 = phi_3329_;
                                                phi_3330_ = _e4280;
                                            } else {
                                                phi_3330_ = true;
                                            }
                                            let _e4282 = phi_3330_;
                                            if _e4282 {
                                                let _e4283 = (_e4273 >= _e4270);
                                                if _e4283 {
                                                    phi_3352_ = f32();
                                                    phi_3353_ = false;
                                                } else {
                                                    if ((_e4270 - _e4273) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3350_ = (((_e4270 - _e4276) / (_e4270 - _e4273)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3351_ = false;
                                                    } else {
                                                        phi_3350_ = f32();
                                                        phi_3351_ = true;
                                                    }
                                                    let _e4294 = phi_3350_;
                                                    let _e4296 = phi_3351_;
                                                    phi_3352_ = _e4294;
                                                    phi_3353_ = _e4296;
                                                }
                                                let _e4298 = phi_3352_;
                                                let _e4300 = phi_3353_;
                                                phi_3354_ = _e4298;
                                                phi_3355_ = _e4283;
                                                phi_3356_ = _e4300;
                                            } else {
                                                phi_3354_ = f32();
                                                phi_3355_ = true;
                                                phi_3356_ = false;
                                            }
                                            let _e4302 = phi_3354_;
                                            let _e4304 = phi_3355_;
                                            let _e4306 = phi_3356_;
                                            if _e4304 {
                                                phi_3360_ = 2f;
                                                phi_3361_ = true;
                                            } else {
                                                phi_3360_ = _e3706;
                                                phi_3361_ = _e4306;
                                            }
                                            let _e4308 = phi_3360_;
                                            let _e4310 = phi_3361_;
                                            if _e4310 {
                                                phi_3365_ = _e4308;
                                            } else {
                                                phi_3365_ = _e4302;
                                            }
                                            let _e4312 = phi_3365_;
                                            let _e4315 = local_9.member[1u];
                                            let _e4318 = local_9.member_1[1u];
                                            let _e4321 = local_9.member_2[1u];
                                            if (_e4315 > _e4321) {
                                                if (_e4318 > _e4321) {
                                                    phi_3397_ = false;
                                                } else {
                                                    phi_3397_ = true;
                                                }
                                                let _e4325 = phi_3397_;
                                                phi_3398_ = _e4325;
                                            } else {
                                                phi_3398_ = true;
                                            }
                                            let _e4327 = phi_3398_;
                                            if _e4327 {
                                                let _e4328 = (_e4318 >= _e4315);
                                                if _e4328 {
                                                    phi_3420_ = f32();
                                                    phi_3421_ = false;
                                                } else {
                                                    if ((_e4315 - _e4318) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3418_ = (((_e4315 - _e4321) / (_e4315 - _e4318)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3419_ = false;
                                                    } else {
                                                        phi_3418_ = f32();
                                                        phi_3419_ = true;
                                                    }
                                                    let _e4339 = phi_3418_;
                                                    let _e4341 = phi_3419_;
                                                    phi_3420_ = _e4339;
                                                    phi_3421_ = _e4341;
                                                }
                                                let _e4343 = phi_3420_;
                                                let _e4345 = phi_3421_;
                                                phi_3422_ = _e4343;
                                                phi_3423_ = _e4328;
                                                phi_3424_ = _e4345;
                                            } else {
                                                phi_3422_ = f32();
                                                phi_3423_ = true;
                                                phi_3424_ = false;
                                            }
                                            let _e4347 = phi_3422_;
                                            let _e4349 = phi_3423_;
                                            let _e4351 = phi_3424_;
                                            if _e4349 {
                                                phi_3428_ = 2f;
                                                phi_3429_ = true;
                                            } else {
                                                phi_3428_ = _e3706;
                                                phi_3429_ = _e4351;
                                            }
                                            let _e4353 = phi_3428_;
                                            let _e4355 = phi_3429_;
                                            if _e4355 {
                                                phi_3433_ = _e4353;
                                            } else {
                                                phi_3433_ = _e4347;
                                            }
                                            let _e4357 = phi_3433_;
                                            if (_e4312 < _e4357) {
                                                phi_3438_ = _e4312;
                                            } else {
                                                phi_3438_ = _e4357;
                                            }
                                            let _e4360 = phi_3438_;
                                            let _e4363 = local_9.member[2u];
                                            let _e4366 = local_9.member_1[2u];
                                            let _e4369 = local_9.member_2[2u];
                                            if (_e4363 > _e4369) {
                                                if (_e4366 > _e4369) {
                                                    phi_3470_ = false;
                                                } else {
                                                    phi_3470_ = true;
                                                }
                                                let _e4373 = phi_3470_;
                                                phi_3471_ = _e4373;
                                            } else {
                                                phi_3471_ = true;
                                            }
                                            let _e4375 = phi_3471_;
                                            if _e4375 {
                                                let _e4376 = (_e4366 >= _e4363);
                                                if _e4376 {
                                                    phi_3493_ = f32();
                                                    phi_3494_ = false;
                                                } else {
                                                    if ((_e4363 - _e4366) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3491_ = (((_e4363 - _e4369) / (_e4363 - _e4366)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3492_ = false;
                                                    } else {
                                                        phi_3491_ = f32();
                                                        phi_3492_ = true;
                                                    }
                                                    let _e4387 = phi_3491_;
                                                    let _e4389 = phi_3492_;
                                                    phi_3493_ = _e4387;
                                                    phi_3494_ = _e4389;
                                                }
                                                let _e4391 = phi_3493_;
                                                let _e4393 = phi_3494_;
                                                phi_3495_ = _e4391;
                                                phi_3496_ = _e4376;
                                                phi_3497_ = _e4393;
                                            } else {
                                                phi_3495_ = f32();
                                                phi_3496_ = true;
                                                phi_3497_ = false;
                                            }
                                            let _e4395 = phi_3495_;
                                            let _e4397 = phi_3496_;
                                            let _e4399 = phi_3497_;
                                            if _e4397 {
                                                phi_3501_ = 2f;
                                                phi_3502_ = true;
                                            } else {
                                                phi_3501_ = _e3706;
                                                phi_3502_ = _e4399;
                                            }
                                            let _e4401 = phi_3501_;
                                            let _e4403 = phi_3502_;
                                            if _e4403 {
                                                phi_3506_ = _e4401;
                                            } else {
                                                phi_3506_ = _e4395;
                                            }
                                            let _e4405 = phi_3506_;
                                            let _e4408 = local_9.member[3u];
                                            let _e4411 = local_9.member_1[3u];
                                            let _e4414 = local_9.member_2[3u];
                                            if (_e4408 > _e4414) {
                                                if (_e4411 > _e4414) {
                                                    phi_3538_ = false;
                                                } else {
                                                    phi_3538_ = true;
                                                }
                                                let _e4418 = phi_3538_;
                                                phi_3539_ = _e4418;
                                            } else {
                                                phi_3539_ = true;
                                            }
                                            let _e4420 = phi_3539_;
                                            if _e4420 {
                                                let _e4421 = (_e4411 >= _e4408);
                                                if _e4421 {
                                                    phi_3561_ = f32();
                                                    phi_3562_ = false;
                                                } else {
                                                    if ((_e4408 - _e4411) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3559_ = (((_e4408 - _e4414) / (_e4408 - _e4411)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3560_ = false;
                                                    } else {
                                                        phi_3559_ = f32();
                                                        phi_3560_ = true;
                                                    }
                                                    let _e4432 = phi_3559_;
                                                    let _e4434 = phi_3560_;
                                                    phi_3561_ = _e4432;
                                                    phi_3562_ = _e4434;
                                                }
                                                let _e4436 = phi_3561_;
                                                let _e4438 = phi_3562_;
                                                phi_3563_ = _e4436;
                                                phi_3564_ = _e4421;
                                                phi_3565_ = _e4438;
                                            } else {
                                                phi_3563_ = f32();
                                                phi_3564_ = true;
                                                phi_3565_ = false;
                                            }
                                            let _e4440 = phi_3563_;
                                            let _e4442 = phi_3564_;
                                            let _e4444 = phi_3565_;
                                            if _e4442 {
                                                phi_3569_ = 2f;
                                                phi_3570_ = true;
                                            } else {
                                                phi_3569_ = _e3706;
                                                phi_3570_ = _e4444;
                                            }
                                            let _e4446 = phi_3569_;
                                            let _e4448 = phi_3570_;
                                            if _e4448 {
                                                phi_3574_ = _e4446;
                                            } else {
                                                phi_3574_ = _e4440;
                                            }
                                            let _e4450 = phi_3574_;
                                            if (_e4405 < _e4450) {
                                                phi_3579_ = _e4405;
                                            } else {
                                                phi_3579_ = _e4450;
                                            }
                                            let _e4453 = phi_3579_;
                                            if (_e4360 < _e4453) {
                                                phi_3584_ = _e4360;
                                            } else {
                                                phi_3584_ = _e4453;
                                            }
                                            let _e4456 = phi_3584_;
                                            if (_e4456 > _e3706) {
                                                phi_3589_ = _e4456;
                                            } else {
                                                phi_3589_ = _e3706;
                                            }
                                            let _e4459 = phi_3589_;
                                            let _e4460 = (_e4459 > 1f);
                                            if _e4460 {
                                                phi_3601_ = f32();
                                                phi_3602_ = false;
                                            } else {
                                                if (_e3724.member_1 == 0u) {
                                                    phi_3600_ = (1f - _e3706);
                                                } else {
                                                    phi_3600_ = (_e4007 + _e4007);
                                                }
                                                let _e4465 = phi_3600_;
                                                phi_3601_ = _e4465;
                                                phi_3602_ = true;
                                            }
                                            let _e4467 = phi_3601_;
                                            let _e4469 = phi_3602_;
                                            phi_3603_ = _e4459;
                                            phi_3604_ = _e4467;
                                            phi_3605_ = _e4469;
                                            phi_3606_ = _e4460;
                                            phi_3607_ = false;
                                        } else {
                                            phi_3603_ = f32();
                                            phi_3604_ = f32();
                                            phi_3605_ = false;
                                            phi_3606_ = false;
                                            phi_3607_ = true;
                                        }
                                        let _e4471 = phi_3603_;
                                        let _e4473 = phi_3604_;
                                        let _e4475 = phi_3605_;
                                        let _e4477 = phi_3606_;
                                        let _e4479 = phi_3607_;
                                        phi_3608_ = _e4471;
                                        phi_3609_ = _e4473;
                                        phi_3610_ = false;
                                        phi_3611_ = _e4475;
                                        phi_3612_ = _e4477;
                                        phi_3613_ = _e4479;
                                    } else {
                                        phi_3608_ = f32();
                                        phi_3609_ = f32();
                                        phi_3610_ = true;
                                        phi_3611_ = false;
                                        phi_3612_ = false;
                                        phi_3613_ = false;
                                    }
                                    let _e4481 = phi_3608_;
                                    let _e4483 = phi_3609_;
                                    let _e4485 = phi_3610_;
                                    let _e4487 = phi_3611_;
                                    let _e4489 = phi_3612_;
                                    let _e4491 = phi_3613_;
                                    phi_3614_ = _e4481;
                                    phi_3615_ = _e4483;
                                    phi_3616_ = _e4485;
                                    phi_3617_ = _e4487;
                                    phi_3618_ = _e4489;
                                    phi_3619_ = _e4491;
                                } else {
                                    phi_3614_ = f32();
                                    phi_3615_ = f32();
                                    phi_3616_ = true;
                                    phi_3617_ = false;
                                    phi_3618_ = false;
                                    phi_3619_ = false;
                                }
                                let _e4493 = phi_3614_;
                                let _e4495 = phi_3615_;
                                let _e4497 = phi_3616_;
                                let _e4499 = phi_3617_;
                                let _e4501 = phi_3618_;
                                let _e4503 = phi_3619_;
                                if _e4497 {
                                    let _e4504 = (_e3706 <= _e3708);
                                    if _e4504 {
                                        phi_3948_ = f32();
                                        phi_3949_ = false;
                                    } else {
                                        let _e4507 = local_9.member[0u];
                                        let _e4510 = local_9.member_1[0u];
                                        let _e4513 = local_9.member[0u];
                                        let _e4519 = local_9.member_2[0u];
                                        let _e4520 = ((_e4507 + ((_e4510 - _e4513) * _e3710)) - _e4519);
                                        let _e4523 = local_9.member[1u];
                                        let _e4526 = local_9.member_1[1u];
                                        let _e4529 = local_9.member[1u];
                                        let _e4535 = local_9.member_2[1u];
                                        let _e4536 = ((_e4523 + ((_e4526 - _e4529) * _e3710)) - _e4535);
                                        if (_e4520 < _e4536) {
                                            phi_3699_ = _e4520;
                                        } else {
                                            phi_3699_ = _e4536;
                                        }
                                        let _e4539 = phi_3699_;
                                        let _e4542 = local_9.member[2u];
                                        let _e4545 = local_9.member_1[2u];
                                        let _e4548 = local_9.member[2u];
                                        let _e4554 = local_9.member_2[2u];
                                        let _e4555 = ((_e4542 + ((_e4545 - _e4548) * _e3710)) - _e4554);
                                        let _e4558 = local_9.member[3u];
                                        let _e4561 = local_9.member_1[3u];
                                        let _e4564 = local_9.member[3u];
                                        let _e4570 = local_9.member_2[3u];
                                        let _e4571 = ((_e4558 + ((_e4561 - _e4564) * _e3710)) - _e4570);
                                        if (_e4555 < _e4571) {
                                            phi_3772_ = _e4555;
                                        } else {
                                            phi_3772_ = _e4571;
                                        }
                                        let _e4574 = phi_3772_;
                                        if (_e4539 < _e4574) {
                                            phi_3777_ = _e4539;
                                        } else {
                                            phi_3777_ = _e4574;
                                        }
                                        let _e4577 = phi_3777_;
                                        let _e4580 = local_10.member[0u];
                                        let _e4583 = local_10.member_1[0u];
                                        let _e4586 = local_10.member[0u];
                                        let _e4592 = local_10.member_2[0u];
                                        let _e4593 = ((_e4580 + ((_e4583 - _e4586) * _e3706)) - _e4592);
                                        let _e4596 = local_10.member[1u];
                                        let _e4599 = local_10.member_1[1u];
                                        let _e4602 = local_10.member[1u];
                                        let _e4608 = local_10.member_2[1u];
                                        let _e4609 = ((_e4596 + ((_e4599 - _e4602) * _e3706)) - _e4608);
                                        if (_e4593 < _e4609) {
                                            phi_3850_ = _e4593;
                                        } else {
                                            phi_3850_ = _e4609;
                                        }
                                        let _e4612 = phi_3850_;
                                        let _e4615 = local_10.member[2u];
                                        let _e4618 = local_10.member_1[2u];
                                        let _e4621 = local_10.member[2u];
                                        let _e4627 = local_10.member_2[2u];
                                        let _e4628 = ((_e4615 + ((_e4618 - _e4621) * _e3706)) - _e4627);
                                        let _e4631 = local_10.member[3u];
                                        let _e4634 = local_10.member_1[3u];
                                        let _e4637 = local_10.member[3u];
                                        let _e4643 = local_10.member_2[3u];
                                        let _e4644 = ((_e4631 + ((_e4634 - _e4637) * _e3706)) - _e4643);
                                        if (_e4628 < _e4644) {
                                            phi_3923_ = _e4628;
                                        } else {
                                            phi_3923_ = _e4644;
                                        }
                                        let _e4647 = phi_3923_;
                                        if (_e4612 < _e4647) {
                                            phi_3928_ = _e4612;
                                        } else {
                                            phi_3928_ = _e4647;
                                        }
                                        let _e4650 = phi_3928_;
                                        if (_e4650 > 0f) {
                                            phi_3946_ = 0.5f;
                                        } else {
                                            let _e4654 = (0.95f * (_e4577 / (_e4577 - _e4650)));
                                            if (_e4654 > 0.0625f) {
                                                if (_e4654 < 0.9f) {
                                                    phi_3944_ = _e4654;
                                                } else {
                                                    phi_3944_ = 0.9f;
                                                }
                                                let _e4658 = phi_3944_;
                                                phi_3945_ = _e4658;
                                            } else {
                                                phi_3945_ = 0.0625f;
                                            }
                                            let _e4660 = phi_3945_;
                                            phi_3946_ = _e4660;
                                        }
                                        let _e4662 = phi_3946_;
                                        phi_3948_ = (_e4007 * _e4662);
                                        phi_3949_ = true;
                                    }
                                    let _e4665 = phi_3948_;
                                    let _e4667 = phi_3949_;
                                    phi_3950_ = _e3708;
                                    phi_3951_ = _e4665;
                                    phi_3952_ = _e3710;
                                    phi_3953_ = _e4667;
                                    phi_3954_ = _e4504;
                                    phi_3955_ = false;
                                    phi_3956_ = false;
                                } else {
                                    phi_3950_ = _e4493;
                                    phi_3951_ = _e4495;
                                    phi_3952_ = _e3706;
                                    phi_3953_ = _e4499;
                                    phi_3954_ = false;
                                    phi_3955_ = _e4501;
                                    phi_3956_ = _e4503;
                                }
                                let _e4669 = phi_3950_;
                                let _e4671 = phi_3951_;
                                let _e4673 = phi_3952_;
                                let _e4675 = phi_3953_;
                                let _e4677 = phi_3954_;
                                let _e4679 = phi_3955_;
                                let _e4681 = phi_3956_;
                                if _e4675 {
                                    let _e4682 = (_e4673 + _e4671);
                                    if (_e4682 > _e4669) {
                                        phi_3965_ = _e4682;
                                    } else {
                                        phi_3965_ = _e4669;
                                    }
                                    let _e4685 = phi_3965_;
                                    if (_e4685 < 1f) {
                                        phi_3970_ = _e4685;
                                    } else {
                                        phi_3970_ = 1f;
                                    }
                                    let _e4688 = phi_3970_;
                                    if (_e3724.member_1 > 0u) {
                                        phi_3980_ = ((_e4688 - _e4673) > 0.0000000037252903f);
                                    } else {
                                        phi_3980_ = true;
                                    }
                                    let _e4693 = phi_3980_;
                                    if _e4693 {
                                        phi_3984_ = false;
                                    } else {
                                        phi_3984_ = true;
                                    }
                                    let _e4695 = phi_3984_;
                                    phi_3985_ = _e4688;
                                    phi_3986_ = _e4693;
                                    phi_3987_ = _e4695;
                                    phi_3988_ = false;
                                    phi_3989_ = false;
                                    phi_3990_ = false;
                                } else {
                                    phi_3985_ = f32();
                                    phi_3986_ = false;
                                    phi_3987_ = false;
                                    phi_3988_ = _e4677;
                                    phi_3989_ = _e4679;
                                    phi_3990_ = _e4681;
                                }
                                let _e4697 = phi_3985_;
                                let _e4699 = phi_3986_;
                                let _e4701 = phi_3987_;
                                let _e4703 = phi_3988_;
                                let _e4705 = phi_3989_;
                                let _e4707 = phi_3990_;
                                phi_2365_ = _e4697;
                                phi_2367_ = _e4669;
                                phi_2369_ = _e4673;
                                phi_3991_ = _e4669;
                                phi_3992_ = _e4699;
                                phi_3993_ = _e4701;
                                phi_3994_ = false;
                                phi_3995_ = _e4703;
                                phi_3996_ = _e4705;
                                phi_3997_ = _e4707;
                            } else {
                                phi_2365_ = f32();
                                phi_2367_ = f32();
                                phi_2369_ = f32();
                                phi_3991_ = f32();
                                phi_3992_ = false;
                                phi_3993_ = false;
                                phi_3994_ = true;
                                phi_3995_ = false;
                                phi_3996_ = false;
                                phi_3997_ = false;
                            }
                            let _e4709 = phi_2365_;
                            let _e4711 = phi_2367_;
                            let _e4713 = phi_2369_;
                            let _e4715 = phi_3991_;
                            let _e4717 = phi_3992_;
                            let _e4719 = phi_3993_;
                            let _e4721 = phi_3994_;
                            let _e4723 = phi_3995_;
                            let _e4725 = phi_3996_;
                            let _e4727 = phi_3997_;
                            local_25 = _e4719;
                            local_43 = _e4715;
                            local_45 = _e4721;
                            local_46 = _e4723;
                            local_47 = _e4725;
                            local_48 = _e4727;
                            continue;
                            continuing {
                                phi_2361_ = _e3722;
                                phi_2364_ = _e4709;
                                phi_2366_ = _e4711;
                                phi_2368_ = _e4713;
                                break if !(_e4717);
                            }
                        }
                        let _e4730 = local_25;
                        if _e4730 {
                            let _e6038 = local_43;
                            phi_4001_ = _e6038;
                            phi_4002_ = true;
                            phi_4003_ = false;
                            phi_4004_ = false;
                            phi_4005_ = false;
                        } else {
                            let _e6040 = local_44;
                            phi_4001_ = _e6040;
                            let _e6043 = local_45;
                            phi_4002_ = _e6043;
                            let _e6046 = local_46;
                            phi_4003_ = _e6046;
                            let _e6049 = local_47;
                            phi_4004_ = _e6049;
                            let _e6052 = local_48;
                            phi_4005_ = _e6052;
                        }
                        let _e4732 = phi_4001_;
                        let _e4734 = phi_4002_;
                        let _e4736 = phi_4003_;
                        let _e4738 = phi_4004_;
                        let _e4740 = phi_4005_;
                        if _e4734 {
                            phi_4010_ = type_33(1u, _e4732);
                            phi_4011_ = false;
                            phi_4012_ = false;
                            phi_4013_ = false;
                        } else {
                            phi_4010_ = type_33();
                            phi_4011_ = _e4736;
                            phi_4012_ = _e4738;
                            phi_4013_ = _e4740;
                        }
                        let _e4743 = phi_4010_;
                        let _e4745 = phi_4011_;
                        let _e4747 = phi_4012_;
                        let _e4749 = phi_4013_;
                        if _e4745 {
                            let _e4751 = local_26;
                            phi_4018_ = type_33(1u, _e4751);
                            phi_4019_ = false;
                            phi_4020_ = false;
                        } else {
                            phi_4018_ = type_33();
                            phi_4019_ = _e4747;
                            phi_4020_ = _e4749;
                        }
                        let _e4754 = phi_4018_;
                        let _e4756 = phi_4019_;
                        let _e4758 = phi_4020_;
                        if _e4756 {
                            phi_4025_ = type_33(0u, type_33().member_1);
                            phi_4026_ = false;
                            phi_4027_ = true;
                        } else {
                            phi_4025_ = _e4754;
                            phi_4026_ = _e4758;
                            phi_4027_ = _e4745;
                        }
                        let _e4762 = phi_4025_;
                        let _e4764 = phi_4026_;
                        let _e4766 = phi_4027_;
                        if _e4764 {
                            phi_4032_ = type_33(0u, type_33().member_1);
                            phi_4033_ = true;
                        } else {
                            phi_4032_ = _e4762;
                            phi_4033_ = _e4766;
                        }
                        let _e4770 = phi_4032_;
                        let _e4772 = phi_4033_;
                        if _e4772 {
                            phi_4037_ = _e4770;
                        } else {
                            phi_4037_ = _e4743;
                        }
                        let _e4774 = phi_4037_;
                        if (_e4774.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4051_ = type_19(0u, 3u);
                            loop {
                                let _e4786 = phi_4051_;
                                if (_e4786.member < _e4786.member_1) {
                                    phi_4052_ = type_19((_e4786.member + 1u), _e4786.member_1);
                                    phi_4075_ = type_19(1u, _e4786.member);
                                } else {
                                    phi_4052_ = _e4786;
                                    phi_4075_ = type_19(0u, type_19().member_1);
                                }
                                let _e4798 = phi_4052_;
                                let _e4800 = phi_4075_;
                                if (bitcast<i32>(_e4800.member) != 0i) {
                                    let _e4806 = local_11[_e4800.member_1];
                                    let _e4807 = (_e4774.member_1 + _e4806);
                                    if (_e4807 < 1f) {
                                        phi_4095_ = _e4807;
                                    } else {
                                        phi_4095_ = 1f;
                                    }
                                    let _e4810 = phi_4095_;
                                    let _e4813 = local_12.member[0u];
                                    let _e4819 = local_12.member[1u];
                                    let _e4835 = local_12.member_1[0u];
                                    let _e4841 = local_12.member_1[1u];
                                    let _e4857 = local_12.member_2[0u];
                                    let _e4863 = local_12.member_2[1u];
                                    let _e4877 = function_1(array<f32, 3>((_e4813[0] + ((_e4819[0] - _e4813[0]) * _e4810)), (_e4813[1] + ((_e4819[1] - _e4813[1]) * _e4810)), (_e4813[2] + ((_e4819[2] - _e4813[2]) * _e4810))), array<f32, 3>((_e4835[0] + ((_e4841[0] - _e4835[0]) * _e4810)), (_e4835[1] + ((_e4841[1] - _e4835[1]) * _e4810)), (_e4835[2] + ((_e4841[2] - _e4835[2]) * _e4810))), array<f32, 3>((_e4857[0] + ((_e4863[0] - _e4857[0]) * _e4810)), (_e4857[1] + ((_e4863[1] - _e4857[1]) * _e4810)), (_e4857[2] + ((_e4863[2] - _e4857[2]) * _e4810))), 0u);
                                    let _e4888 = (((_e4877[0] * _e4877[0]) + (_e4877[1] * _e4877[1])) + (_e4877[2] * _e4877[2]));
                                    if (_e4888 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4888 > 0f) {
                                            phi_4218_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4218_ = 0f;
                                        }
                                        let _e4941 = phi_4218_;
                                        phi_4282_ = _e4941;
                                    } else {
                                        phi_4225_ = type_17(0i, 5i);
                                        phi_4228_ = bitcast<f32>(((bitcast<u32>(_e4888) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4896 = phi_4225_;
                                            let _e4898 = phi_4228_;
                                            local_27 = _e4898;
                                            if (_e4896.member < _e4896.member_1) {
                                                let _e4905 = (_e4896.member + 1i);
                                                if ((false == (_e4905 > _e4896.member)) != false) {
                                                    phi_4249_ = true;
                                                } else {
                                                    phi_4249_ = false;
                                                }
                                                let _e4910 = phi_4249_;
                                                if _e4910 {
                                                    phi_4255_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_4255_ = type_18(1u, _e4905);
                                                }
                                                let _e4915 = phi_4255_;
                                                phi_4226_ = type_17(_e4915.member_1, _e4896.member_1);
                                                phi_4269_ = type_18(1u, _e4896.member);
                                            } else {
                                                phi_4226_ = _e4896;
                                                phi_4269_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4921 = phi_4226_;
                                            let _e4923 = phi_4269_;
                                            let _e4926 = (bitcast<i32>(_e4923.member) != 0i);
                                            if _e4926 {
                                                phi_4229_ = (0.5f * (_e4898 + (_e4888 / _e4898)));
                                            } else {
                                                phi_4229_ = f32();
                                            }
                                            let _e4931 = phi_4229_;
                                            continue;
                                            continuing {
                                                phi_4225_ = _e4921;
                                                phi_4228_ = _e4931;
                                                break if !(_e4926);
                                            }
                                        }
                                        let _e4936 = local_27;
                                        phi_4282_ = (_e4936 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4943 = phi_4282_;
                                    let _e4949 = local_12.member[0u];
                                    if (_e4949[0] < 0f) {
                                        phi_4298_ = -(_e4949[0]);
                                    } else {
                                        phi_4298_ = _e4949[0];
                                    }
                                    let _e4956 = phi_4298_;
                                    if (_e4949[1] < 0f) {
                                        phi_4305_ = -(_e4949[1]);
                                    } else {
                                        phi_4305_ = _e4949[1];
                                    }
                                    let _e4960 = phi_4305_;
                                    if (_e4956 > _e4960) {
                                        phi_4310_ = _e4956;
                                    } else {
                                        phi_4310_ = _e4960;
                                    }
                                    let _e4963 = phi_4310_;
                                    if (_e4949[2] < 0f) {
                                        phi_4317_ = -(_e4949[2]);
                                    } else {
                                        phi_4317_ = _e4949[2];
                                    }
                                    let _e4967 = phi_4317_;
                                    if (_e4963 > _e4967) {
                                        phi_4322_ = _e4963;
                                    } else {
                                        phi_4322_ = _e4967;
                                    }
                                    let _e4970 = phi_4322_;
                                    let _e4973 = local_12.member[1u];
                                    if (_e4973[0] < 0f) {
                                        phi_4335_ = -(_e4973[0]);
                                    } else {
                                        phi_4335_ = _e4973[0];
                                    }
                                    let _e4980 = phi_4335_;
                                    if (_e4973[1] < 0f) {
                                        phi_4342_ = -(_e4973[1]);
                                    } else {
                                        phi_4342_ = _e4973[1];
                                    }
                                    let _e4984 = phi_4342_;
                                    if (_e4980 > _e4984) {
                                        phi_4347_ = _e4980;
                                    } else {
                                        phi_4347_ = _e4984;
                                    }
                                    let _e4987 = phi_4347_;
                                    if (_e4973[2] < 0f) {
                                        phi_4354_ = -(_e4973[2]);
                                    } else {
                                        phi_4354_ = _e4973[2];
                                    }
                                    let _e4991 = phi_4354_;
                                    if (_e4987 > _e4991) {
                                        phi_4359_ = _e4987;
                                    } else {
                                        phi_4359_ = _e4991;
                                    }
                                    let _e4994 = phi_4359_;
                                    if (_e4970 > _e4994) {
                                        phi_4364_ = _e4970;
                                    } else {
                                        phi_4364_ = _e4994;
                                    }
                                    let _e4997 = phi_4364_;
                                    let _e4999 = local_12.member_3;
                                    let _e5003 = local_12.member_1[0u];
                                    if (_e5003[0] < 0f) {
                                        phi_4381_ = -(_e5003[0]);
                                    } else {
                                        phi_4381_ = _e5003[0];
                                    }
                                    let _e5010 = phi_4381_;
                                    if (_e5003[1] < 0f) {
                                        phi_4388_ = -(_e5003[1]);
                                    } else {
                                        phi_4388_ = _e5003[1];
                                    }
                                    let _e5014 = phi_4388_;
                                    if (_e5010 > _e5014) {
                                        phi_4393_ = _e5010;
                                    } else {
                                        phi_4393_ = _e5014;
                                    }
                                    let _e5017 = phi_4393_;
                                    if (_e5003[2] < 0f) {
                                        phi_4400_ = -(_e5003[2]);
                                    } else {
                                        phi_4400_ = _e5003[2];
                                    }
                                    let _e5021 = phi_4400_;
                                    if (_e5017 > _e5021) {
                                        phi_4405_ = _e5017;
                                    } else {
                                        phi_4405_ = _e5021;
                                    }
                                    let _e5024 = phi_4405_;
                                    let _e5027 = local_12.member_1[1u];
                                    if (_e5027[0] < 0f) {
                                        phi_4419_ = -(_e5027[0]);
                                    } else {
                                        phi_4419_ = _e5027[0];
                                    }
                                    let _e5034 = phi_4419_;
                                    if (_e5027[1] < 0f) {
                                        phi_4426_ = -(_e5027[1]);
                                    } else {
                                        phi_4426_ = _e5027[1];
                                    }
                                    let _e5038 = phi_4426_;
                                    if (_e5034 > _e5038) {
                                        phi_4431_ = _e5034;
                                    } else {
                                        phi_4431_ = _e5038;
                                    }
                                    let _e5041 = phi_4431_;
                                    if (_e5027[2] < 0f) {
                                        phi_4438_ = -(_e5027[2]);
                                    } else {
                                        phi_4438_ = _e5027[2];
                                    }
                                    let _e5045 = phi_4438_;
                                    if (_e5041 > _e5045) {
                                        phi_4443_ = _e5041;
                                    } else {
                                        phi_4443_ = _e5045;
                                    }
                                    let _e5048 = phi_4443_;
                                    if (_e5024 > _e5048) {
                                        phi_4448_ = _e5024;
                                    } else {
                                        phi_4448_ = _e5048;
                                    }
                                    let _e5051 = phi_4448_;
                                    let _e5053 = local_12.member_3;
                                    let _e5057 = local_12.member_2[0u];
                                    if (_e5057[0] < 0f) {
                                        phi_4465_ = -(_e5057[0]);
                                    } else {
                                        phi_4465_ = _e5057[0];
                                    }
                                    let _e5064 = phi_4465_;
                                    if (_e5057[1] < 0f) {
                                        phi_4472_ = -(_e5057[1]);
                                    } else {
                                        phi_4472_ = _e5057[1];
                                    }
                                    let _e5068 = phi_4472_;
                                    if (_e5064 > _e5068) {
                                        phi_4477_ = _e5064;
                                    } else {
                                        phi_4477_ = _e5068;
                                    }
                                    let _e5071 = phi_4477_;
                                    if (_e5057[2] < 0f) {
                                        phi_4484_ = -(_e5057[2]);
                                    } else {
                                        phi_4484_ = _e5057[2];
                                    }
                                    let _e5075 = phi_4484_;
                                    if (_e5071 > _e5075) {
                                        phi_4489_ = _e5071;
                                    } else {
                                        phi_4489_ = _e5075;
                                    }
                                    let _e5078 = phi_4489_;
                                    let _e5081 = local_12.member_2[1u];
                                    if (_e5081[0] < 0f) {
                                        phi_4503_ = -(_e5081[0]);
                                    } else {
                                        phi_4503_ = _e5081[0];
                                    }
                                    let _e5088 = phi_4503_;
                                    if (_e5081[1] < 0f) {
                                        phi_4510_ = -(_e5081[1]);
                                    } else {
                                        phi_4510_ = _e5081[1];
                                    }
                                    let _e5092 = phi_4510_;
                                    if (_e5088 > _e5092) {
                                        phi_4515_ = _e5088;
                                    } else {
                                        phi_4515_ = _e5092;
                                    }
                                    let _e5095 = phi_4515_;
                                    if (_e5081[2] < 0f) {
                                        phi_4522_ = -(_e5081[2]);
                                    } else {
                                        phi_4522_ = _e5081[2];
                                    }
                                    let _e5099 = phi_4522_;
                                    if (_e5095 > _e5099) {
                                        phi_4527_ = _e5095;
                                    } else {
                                        phi_4527_ = _e5099;
                                    }
                                    let _e5102 = phi_4527_;
                                    if (_e5078 > _e5102) {
                                        phi_4532_ = _e5078;
                                    } else {
                                        phi_4532_ = _e5102;
                                    }
                                    let _e5105 = phi_4532_;
                                    let _e5107 = local_12.member_3;
                                    let _e5114 = local_12.member_3;
                                    let _e5121 = (((_e4943 * (1f + (0.000000059604645f * 8f))) + (((((((_e4997 + _e4999) + (_e5051 + _e5053)) + (_e5105 + _e5107)) * (0.000000059604645f * 16f)) + (_e5114 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e453.member_1);
                                    if _e5121 {
                                        phi_4552_ = false;
                                    } else {
                                        phi_4552_ = true;
                                    }
                                    let _e5123 = phi_4552_;
                                    phi_4553_ = _e5123;
                                    phi_4554_ = _e5121;
                                } else {
                                    phi_4553_ = false;
                                    phi_4554_ = false;
                                }
                                let _e5125 = phi_4553_;
                                let _e5127 = phi_4554_;
                                local_28 = _e5127;
                                continue;
                                continuing {
                                    phi_4051_ = _e4798;
                                    break if !(_e5125);
                                }
                            }
                            let _e5130 = local_28;
                            if _e5130 {
                                phi_4559_ = type_33(1u, _e4774.member_1);
                                phi_4560_ = false;
                            } else {
                                phi_4559_ = type_33();
                                phi_4560_ = true;
                            }
                            let _e5133 = phi_4559_;
                            let _e5135 = phi_4560_;
                            if _e5135 {
                                phi_4565_ = type_33(2u, _e4774.member_1);
                                phi_4566_ = false;
                            } else {
                                phi_4565_ = type_33();
                                phi_4566_ = true;
                            }
                            let _e5138 = phi_4565_;
                            let _e5140 = phi_4566_;
                            phi_4568_ = _e5138;
                            phi_4569_ = _e5133;
                            phi_4570_ = _e5140;
                        } else {
                            phi_4568_ = type_33();
                            phi_4569_ = type_33(0u, type_33().member_1);
                            phi_4570_ = true;
                        }
                        let _e5142 = phi_4568_;
                        let _e5144 = phi_4569_;
                        let _e5146 = phi_4570_;
                        if _e5146 {
                            phi_4574_ = _e5144;
                        } else {
                            phi_4574_ = _e5142;
                        }
                        let _e5148 = phi_4574_;
                        phi_8456_ = _e5148;
                    } else {
                        if (_e591 < 0f) {
                            phi_4584_ = -(_e591);
                        } else {
                            phi_4584_ = _e591;
                        }
                        let _e934 = phi_4584_;
                        if (_e614 < 0f) {
                            phi_4590_ = -(_e614);
                        } else {
                            phi_4590_ = _e614;
                        }
                        let _e938 = phi_4590_;
                        if (_e934 > _e938) {
                            phi_4595_ = _e934;
                        } else {
                            phi_4595_ = _e938;
                        }
                        let _e941 = phi_4595_;
                        if (_e637 < 0f) {
                            phi_4601_ = -(_e637);
                        } else {
                            phi_4601_ = _e637;
                        }
                        let _e945 = phi_4601_;
                        if (_e648 < 0f) {
                            phi_4607_ = -(_e648);
                        } else {
                            phi_4607_ = _e648;
                        }
                        let _e949 = phi_4607_;
                        if (_e945 > _e949) {
                            phi_4612_ = _e945;
                        } else {
                            phi_4612_ = _e949;
                        }
                        let _e952 = phi_4612_;
                        if (_e941 > _e952) {
                            phi_4617_ = _e941;
                        } else {
                            phi_4617_ = _e952;
                        }
                        let _e955 = phi_4617_;
                        let _e956 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e955 >= _e956) {
                            phi_4625_ = (_e955 <= (1f / _e956));
                        } else {
                            phi_4625_ = false;
                        }
                        let _e961 = phi_4625_;
                        if _e961 {
                            phi_4630_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4630_ = 2f;
                        }
                        let _e964 = phi_4630_;
                        let _e966 = ((_e898 * 0.34f) + (_e955 * _e964));
                        if _e961 {
                            phi_4637_ = (1f / _e955);
                        } else {
                            phi_4637_ = 0f;
                        }
                        let _e969 = phi_4637_;
                        let _e975 = ((_e614 - (3f * _e591)) * _e969);
                        let _e976 = ((_e637 - _e614) * _e969);
                        let _e977 = (((3f * _e648) - _e637) * _e969);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e984 = ((_e976 * _e976) - (_e975 * _e977));
                        if (_e984 > 0f) {
                            if (_e984 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e984 > 0f) {
                                    phi_4670_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4670_ = 0f;
                                }
                                let _e1038 = phi_4670_;
                                phi_4734_ = _e1038;
                            } else {
                                phi_4677_ = type_17(0i, 5i);
                                phi_4680_ = bitcast<f32>(((bitcast<u32>(_e984) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e993 = phi_4677_;
                                    let _e995 = phi_4680_;
                                    local_13 = _e995;
                                    if (_e993.member < _e993.member_1) {
                                        let _e1002 = (_e993.member + 1i);
                                        if ((false == (_e1002 > _e993.member)) != false) {
                                            phi_4701_ = true;
                                        } else {
                                            phi_4701_ = false;
                                        }
                                        let _e1007 = phi_4701_;
                                        if _e1007 {
                                            phi_4707_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4707_ = type_18(1u, _e1002);
                                        }
                                        let _e1012 = phi_4707_;
                                        phi_4678_ = type_17(_e1012.member_1, _e993.member_1);
                                        phi_4721_ = type_18(1u, _e993.member);
                                    } else {
                                        phi_4678_ = _e993;
                                        phi_4721_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e1018 = phi_4678_;
                                    let _e1020 = phi_4721_;
                                    let _e1023 = (bitcast<i32>(_e1020.member) != 0i);
                                    if _e1023 {
                                        phi_4681_ = (0.5f * (_e995 + (_e984 / _e995)));
                                    } else {
                                        phi_4681_ = f32();
                                    }
                                    let _e1028 = phi_4681_;
                                    continue;
                                    continuing {
                                        phi_4677_ = _e1018;
                                        phi_4680_ = _e1028;
                                        break if !(_e1023);
                                    }
                                }
                                let _e1033 = local_13;
                                phi_4734_ = (_e1033 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1040 = phi_4734_;
                            if (_e976 < 0f) {
                                phi_4740_ = -(_e1040);
                            } else {
                                phi_4740_ = _e1040;
                            }
                            let _e1044 = phi_4740_;
                            let _e1046 = -((_e976 + _e1044));
                            local_7[0u] = (_e1046 / (_e1046 + _e977));
                            local_7[1u] = (_e975 / (_e975 + _e1046));
                            let _e1055 = local_7[1u];
                            let _e1056 = local_7[0u];
                            if (_e1055 < _e1056) {
                                let _e1059 = local_7[1u];
                                let _e1061 = local_7[0u];
                                local_7[0u] = _e1059;
                                local_7[1u] = _e1061;
                            }
                            phi_4765_ = type_19(0u, 2u);
                            phi_4768_ = 1u;
                            loop {
                                let _e1065 = phi_4765_;
                                let _e1067 = phi_4768_;
                                local_29 = _e1067;
                                if (_e1065.member < _e1065.member_1) {
                                    phi_4766_ = type_19((_e1065.member + 1u), _e1065.member_1);
                                    phi_4791_ = type_19(1u, _e1065.member);
                                } else {
                                    phi_4766_ = _e1065;
                                    phi_4791_ = type_19(0u, type_19().member_1);
                                }
                                let _e1079 = phi_4766_;
                                let _e1081 = phi_4791_;
                                let _e1085 = (bitcast<i32>(_e1081.member) != 0i);
                                if _e1085 {
                                    let _e1087 = local_7[_e1081.member_1];
                                    if (_e1087 > 0f) {
                                        let _e1090 = local_7[_e1081.member_1];
                                        if (_e1090 < 1f) {
                                            let _e1093 = local_7[_e1081.member_1];
                                            local_6[_e1067] = _e1093;
                                            phi_4835_ = (_e1067 + 1u);
                                        } else {
                                            phi_4835_ = _e1067;
                                        }
                                        let _e1097 = phi_4835_;
                                        phi_4836_ = _e1097;
                                    } else {
                                        phi_4836_ = _e1067;
                                    }
                                    let _e1099 = phi_4836_;
                                    phi_4769_ = _e1099;
                                } else {
                                    phi_4769_ = u32();
                                }
                                let _e1101 = phi_4769_;
                                continue;
                                continuing {
                                    phi_4765_ = _e1079;
                                    phi_4768_ = _e1101;
                                    break if !(_e1085);
                                }
                            }
                            let _e5403 = local_29;
                            phi_4837_ = _e5403;
                        } else {
                            phi_4837_ = 1u;
                        }
                        let _e1104 = phi_4837_;
                        local_6[_e1104] = 1f;
                        let _e1106 = local_6;
                        local_8 = _e1106;
                        phi_4857_ = type_19(0u, _e1104);
                        loop {
                            let _e1109 = phi_4857_;
                            if (_e1109.member < _e1109.member_1) {
                                phi_4858_ = type_19((_e1109.member + 1u), _e1109.member_1);
                                phi_4881_ = type_19(1u, _e1109.member);
                            } else {
                                phi_4858_ = _e1109;
                                phi_4881_ = type_19(0u, type_19().member_1);
                            }
                            let _e1121 = phi_4858_;
                            let _e1123 = phi_4881_;
                            if (bitcast<i32>(_e1123.member) != 0i) {
                                let _e1129 = local_8[_e1123.member_1];
                                let _e1132 = local_8[(_e1123.member_1 + 1u)];
                                let _e1133 = (1f - _e1129);
                                let _e1144 = ((((_e591 * _e1133) + (_e614 * _e1129)) * (_e1133 * _e1133)) + (((_e637 * _e1133) + (_e648 * _e1129)) * (_e1129 * _e1129)));
                                let _e1145 = (1f - _e1132);
                                let _e1156 = ((((_e591 * _e1145) + (_e614 * _e1132)) * (_e1145 * _e1145)) + (((_e637 * _e1145) + (_e648 * _e1132)) * (_e1132 * _e1132)));
                                if (_e1144 < 0f) {
                                    phi_4933_ = -(_e1144);
                                } else {
                                    phi_4933_ = _e1144;
                                }
                                let _e1160 = phi_4933_;
                                let _e1161 = (_e1160 > _e966);
                                if (_e1156 < 0f) {
                                    phi_4940_ = -(_e1156);
                                } else {
                                    phi_4940_ = _e1156;
                                }
                                let _e1165 = phi_4940_;
                                let _e1166 = (_e1165 > _e966);
                                if _e1161 {
                                    if _e1166 {
                                        phi_4951_ = ((_e1144 > 0f) != (_e1156 > 0f));
                                        phi_4952_ = false;
                                    } else {
                                        phi_4951_ = bool();
                                        phi_4952_ = true;
                                    }
                                    let _e1171 = phi_4951_;
                                    let _e1173 = phi_4952_;
                                    phi_4953_ = _e1171;
                                    phi_4954_ = _e1173;
                                } else {
                                    phi_4953_ = bool();
                                    phi_4954_ = true;
                                }
                                let _e1175 = phi_4953_;
                                let _e1177 = phi_4954_;
                                if _e1177 {
                                    phi_4958_ = false;
                                } else {
                                    phi_4958_ = _e1175;
                                }
                                let _e1179 = phi_4958_;
                                if _e1161 {
                                    if _e1166 {
                                        if _e1179 {
                                            phi_4969_ = type_35();
                                        } else {
                                            phi_4969_ = type_35(1f, 0f, _e1179);
                                        }
                                        let _e1182 = phi_4969_;
                                        phi_4970_ = _e1182;
                                        phi_4971_ = _e1179;
                                    } else {
                                        phi_4970_ = type_35();
                                        phi_4971_ = true;
                                    }
                                    let _e1184 = phi_4970_;
                                    let _e1186 = phi_4971_;
                                    phi_4972_ = _e1184;
                                    phi_4973_ = _e1186;
                                } else {
                                    phi_4972_ = type_35();
                                    phi_4973_ = true;
                                }
                                let _e1188 = phi_4972_;
                                let _e1190 = phi_4973_;
                                if _e1190 {
                                    if _e1161 {
                                        if (_e1144 < 0f) {
                                            phi_4984_ = -1f;
                                        } else {
                                            phi_4984_ = 1f;
                                        }
                                        let _e1193 = phi_4984_;
                                        let _e1196 = (_e637 - _e614);
                                        phi_4994_ = type_19(0u, 64u);
                                        phi_4997_ = _e1132;
                                        phi_4999_ = _e1129;
                                        phi_5001_ = (0.5f * (_e1129 + _e1132));
                                        loop {
                                            let _e1202 = phi_4994_;
                                            let _e1204 = phi_4997_;
                                            let _e1206 = phi_4999_;
                                            let _e1208 = phi_5001_;
                                            local_31 = _e1206;
                                            if (_e1202.member < _e1202.member_1) {
                                                phi_4995_ = type_19((_e1202.member + 1u), _e1202.member_1);
                                                phi_5024_ = type_19(1u, _e1202.member);
                                            } else {
                                                phi_4995_ = _e1202;
                                                phi_5024_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1220 = phi_4995_;
                                            let _e1222 = phi_5024_;
                                            if (bitcast<i32>(_e1222.member) != 0i) {
                                                let _e1226 = (1f - _e1208);
                                                let _e1239 = ((_e1193 * ((((_e591 * _e1226) + (_e614 * _e1208)) * (_e1226 * _e1226)) + (((_e637 * _e1226) + (_e648 * _e1208)) * (_e1208 * _e1208)))) - _e966);
                                                if (_e1239 > 0f) {
                                                    phi_5049_ = _e1204;
                                                    phi_5050_ = _e1208;
                                                } else {
                                                    phi_5049_ = _e1208;
                                                    phi_5050_ = _e1206;
                                                }
                                                let _e1242 = phi_5049_;
                                                let _e1244 = phi_5050_;
                                                let _e1246 = ((_e1242 - _e1244) > 0.00000000000022737368f);
                                                if _e1246 {
                                                    let _e1247 = (1f - _e1208);
                                                    let _e1259 = (-(_e1239) / (_e1193 * (((((_e614 - (3f * _e591)) * _e1247) + (_e1196 * _e1208)) * _e1247) + (((_e1196 * _e1247) + (((3f * _e648) - _e637) * _e1208)) * _e1208))));
                                                    if (_e1239 > 0f) {
                                                        phi_5076_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5076_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1265 = phi_5076_;
                                                    let _e1267 = ((_e1208 + _e1259) + _e1265);
                                                    if (_e1267 > _e1244) {
                                                        if (_e1267 < _e1242) {
                                                            if (_e1259 < 0f) {
                                                                phi_5092_ = -(_e1259);
                                                            } else {
                                                                phi_5092_ = _e1259;
                                                            }
                                                            let _e1273 = phi_5092_;
                                                            if (_e1273 < (0.5f * (_e1242 - _e1244))) {
                                                                phi_5099_ = false;
                                                            } else {
                                                                phi_5099_ = true;
                                                            }
                                                            let _e1278 = phi_5099_;
                                                            phi_5100_ = _e1278;
                                                        } else {
                                                            phi_5100_ = true;
                                                        }
                                                        let _e1280 = phi_5100_;
                                                        phi_5101_ = _e1280;
                                                    } else {
                                                        phi_5101_ = true;
                                                    }
                                                    let _e1282 = phi_5101_;
                                                    if _e1282 {
                                                        phi_5107_ = (0.5f * (_e1244 + _e1242));
                                                    } else {
                                                        phi_5107_ = _e1267;
                                                    }
                                                    let _e1286 = phi_5107_;
                                                    phi_5108_ = _e1286;
                                                    phi_5109_ = false;
                                                } else {
                                                    phi_5108_ = f32();
                                                    phi_5109_ = true;
                                                }
                                                let _e1288 = phi_5108_;
                                                let _e1290 = phi_5109_;
                                                phi_4998_ = _e1242;
                                                phi_5000_ = _e1244;
                                                phi_5002_ = _e1288;
                                                phi_5110_ = _e1244;
                                                phi_5111_ = _e1246;
                                                phi_5112_ = _e1290;
                                            } else {
                                                phi_4998_ = f32();
                                                phi_5000_ = f32();
                                                phi_5002_ = f32();
                                                phi_5110_ = f32();
                                                phi_5111_ = false;
                                                phi_5112_ = false;
                                            }
                                            let _e1292 = phi_4998_;
                                            let _e1294 = phi_5000_;
                                            let _e1296 = phi_5002_;
                                            let _e1298 = phi_5110_;
                                            let _e1300 = phi_5111_;
                                            let _e1302 = phi_5112_;
                                            local_14 = _e1302;
                                            local_30 = _e1298;
                                            continue;
                                            continuing {
                                                phi_4994_ = _e1220;
                                                phi_4997_ = _e1292;
                                                phi_4999_ = _e1294;
                                                phi_5001_ = _e1296;
                                                break if !(_e1300);
                                            }
                                        }
                                        let _e1305 = local_14;
                                        if _e1305 {
                                            let _e5445 = local_30;
                                            phi_5116_ = _e5445;
                                        } else {
                                            let _e5447 = local_31;
                                            phi_5116_ = _e5447;
                                        }
                                        let _e1307 = phi_5116_;
                                        phi_5117_ = _e1307;
                                    } else {
                                        phi_5117_ = _e1129;
                                    }
                                    let _e1309 = phi_5117_;
                                    if _e1166 {
                                        if (_e1156 < 0f) {
                                            phi_5125_ = -1f;
                                        } else {
                                            phi_5125_ = 1f;
                                        }
                                        let _e1312 = phi_5125_;
                                        phi_5129_ = type_19(0u, 64u);
                                        phi_5132_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1315 = phi_5129_;
                                            let _e1317 = phi_5132_;
                                            if (_e1315.member < _e1315.member_1) {
                                                phi_5130_ = type_19((_e1315.member + 1u), _e1315.member_1);
                                                phi_5155_ = type_19(1u, _e1315.member);
                                            } else {
                                                phi_5130_ = _e1315;
                                                phi_5155_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1329 = phi_5130_;
                                            let _e1331 = phi_5155_;
                                            if (bitcast<i32>(_e1331.member) != 0i) {
                                                let _e1335 = (_e1309 + _e1317);
                                                if (_e1335 < _e1132) {
                                                    let _e1337 = (1f - _e1335);
                                                    let _e1350 = ((_e1312 * ((((_e591 * _e1337) + (_e614 * _e1335)) * (_e1337 * _e1337)) + (((_e637 * _e1337) + (_e648 * _e1335)) * (_e1335 * _e1335)))) > _e966);
                                                    if _e1350 {
                                                        phi_5185_ = f32();
                                                        phi_5186_ = false;
                                                    } else {
                                                        phi_5185_ = (_e1317 + _e1317);
                                                        phi_5186_ = true;
                                                    }
                                                    let _e1353 = phi_5185_;
                                                    let _e1355 = phi_5186_;
                                                    phi_5187_ = _e1353;
                                                    phi_5188_ = _e1355;
                                                    phi_5189_ = _e1350;
                                                    phi_5190_ = false;
                                                } else {
                                                    phi_5187_ = f32();
                                                    phi_5188_ = false;
                                                    phi_5189_ = false;
                                                    phi_5190_ = true;
                                                }
                                                let _e1357 = phi_5187_;
                                                let _e1359 = phi_5188_;
                                                let _e1361 = phi_5189_;
                                                let _e1363 = phi_5190_;
                                                phi_5191_ = _e1335;
                                                phi_5133_ = _e1357;
                                                phi_5192_ = _e1359;
                                                phi_5193_ = _e1361;
                                                phi_5194_ = _e1363;
                                                phi_5195_ = false;
                                            } else {
                                                phi_5191_ = f32();
                                                phi_5133_ = f32();
                                                phi_5192_ = false;
                                                phi_5193_ = false;
                                                phi_5194_ = false;
                                                phi_5195_ = true;
                                            }
                                            let _e1365 = phi_5191_;
                                            let _e1367 = phi_5133_;
                                            let _e1369 = phi_5192_;
                                            let _e1371 = phi_5193_;
                                            let _e1373 = phi_5194_;
                                            let _e1375 = phi_5195_;
                                            local_15 = _e1371;
                                            local_32 = _e1373;
                                            local_33 = _e1375;
                                            local_34 = _e1365;
                                            continue;
                                            continuing {
                                                phi_5129_ = _e1329;
                                                phi_5132_ = _e1367;
                                                break if !(_e1369);
                                            }
                                        }
                                        let _e1378 = local_15;
                                        if _e1378 {
                                            phi_5199_ = false;
                                            phi_5200_ = false;
                                        } else {
                                            let _e5469 = local_32;
                                            phi_5199_ = _e5469;
                                            let _e5472 = local_33;
                                            phi_5200_ = _e5472;
                                        }
                                        let _e1380 = phi_5199_;
                                        let _e1382 = phi_5200_;
                                        if _e1380 {
                                            phi_5204_ = true;
                                        } else {
                                            phi_5204_ = _e1382;
                                        }
                                        let _e1384 = phi_5204_;
                                        if _e1384 {
                                            phi_5208_ = _e1132;
                                        } else {
                                            let _e5476 = local_34;
                                            phi_5208_ = _e5476;
                                        }
                                        let _e1386 = phi_5208_;
                                        phi_5209_ = _e1386;
                                    } else {
                                        phi_5209_ = _e1132;
                                    }
                                    let _e1388 = phi_5209_;
                                    phi_5211_ = type_35(_e1309, _e1388, _e1179);
                                } else {
                                    phi_5211_ = _e1188;
                                }
                                let _e1391 = phi_5211_;
                                if (_e1391.member > _e1391.member_1) {
                                    phi_8412_ = f32();
                                    phi_8413_ = true;
                                    phi_8414_ = false;
                                    phi_8415_ = false;
                                    phi_8416_ = false;
                                } else {
                                    let _e1398 = ((_e1391.member_1 - _e1391.member) * 0.5f);
                                    let _e1399 = (_e1391.member + _e1398);
                                    let _e1401 = (_e1398 + (0.000000059604645f * 4f));
                                    let _e1403 = local_12.member_3;
                                    let _e1406 = local_12.member[0u];
                                    if (_e1406[0] < 0f) {
                                        phi_5240_ = -(_e1406[0]);
                                    } else {
                                        phi_5240_ = _e1406[0];
                                    }
                                    let _e1413 = phi_5240_;
                                    if (_e1406[1] < 0f) {
                                        phi_5247_ = -(_e1406[1]);
                                    } else {
                                        phi_5247_ = _e1406[1];
                                    }
                                    let _e1417 = phi_5247_;
                                    if (_e1413 > _e1417) {
                                        phi_5252_ = _e1413;
                                    } else {
                                        phi_5252_ = _e1417;
                                    }
                                    let _e1420 = phi_5252_;
                                    if (_e1406[2] < 0f) {
                                        phi_5259_ = -(_e1406[2]);
                                    } else {
                                        phi_5259_ = _e1406[2];
                                    }
                                    let _e1424 = phi_5259_;
                                    if (_e1420 > _e1424) {
                                        phi_5264_ = _e1420;
                                    } else {
                                        phi_5264_ = _e1424;
                                    }
                                    let _e1427 = phi_5264_;
                                    let _e1429 = local_12.member[1u];
                                    if (_e1429[0] < 0f) {
                                        phi_5277_ = -(_e1429[0]);
                                    } else {
                                        phi_5277_ = _e1429[0];
                                    }
                                    let _e1436 = phi_5277_;
                                    if (_e1429[1] < 0f) {
                                        phi_5284_ = -(_e1429[1]);
                                    } else {
                                        phi_5284_ = _e1429[1];
                                    }
                                    let _e1440 = phi_5284_;
                                    if (_e1436 > _e1440) {
                                        phi_5289_ = _e1436;
                                    } else {
                                        phi_5289_ = _e1440;
                                    }
                                    let _e1443 = phi_5289_;
                                    if (_e1429[2] < 0f) {
                                        phi_5296_ = -(_e1429[2]);
                                    } else {
                                        phi_5296_ = _e1429[2];
                                    }
                                    let _e1447 = phi_5296_;
                                    if (_e1443 > _e1447) {
                                        phi_5301_ = _e1443;
                                    } else {
                                        phi_5301_ = _e1447;
                                    }
                                    let _e1450 = phi_5301_;
                                    if (_e1427 > _e1450) {
                                        phi_5306_ = _e1427;
                                    } else {
                                        phi_5306_ = _e1450;
                                    }
                                    let _e1453 = phi_5306_;
                                    let _e1456 = local_12.member[0u];
                                    let _e1461 = local_12.member[1u];
                                    let _e1471 = (_e1456[0] + ((_e1461[0] - _e1456[0]) * _e1399));
                                    let _e1472 = (_e1456[1] + ((_e1461[1] - _e1456[1]) * _e1399));
                                    let _e1473 = (_e1456[2] + ((_e1461[2] - _e1456[2]) * _e1399));
                                    let _e1475 = local_12.member[1u];
                                    let _e1480 = local_12.member[0u];
                                    let _e1484 = (_e1475[0] - _e1480[0]);
                                    let _e1485 = (_e1475[1] - _e1480[1]);
                                    let _e1486 = (_e1475[2] - _e1480[2]);
                                    if (_e1484 < 0f) {
                                        phi_5365_ = -(_e1484);
                                    } else {
                                        phi_5365_ = _e1484;
                                    }
                                    let _e1490 = phi_5365_;
                                    if (_e1485 < 0f) {
                                        phi_5371_ = -(_e1485);
                                    } else {
                                        phi_5371_ = _e1485;
                                    }
                                    let _e1494 = phi_5371_;
                                    if (_e1490 > _e1494) {
                                        phi_5376_ = _e1490;
                                    } else {
                                        phi_5376_ = _e1494;
                                    }
                                    let _e1497 = phi_5376_;
                                    if (_e1486 < 0f) {
                                        phi_5382_ = -(_e1486);
                                    } else {
                                        phi_5382_ = _e1486;
                                    }
                                    let _e1501 = phi_5382_;
                                    if (_e1497 > _e1501) {
                                        phi_5387_ = _e1497;
                                    } else {
                                        phi_5387_ = _e1501;
                                    }
                                    let _e1504 = phi_5387_;
                                    let _e1510 = ((((_e1401 * _e1504) * 1.01f) + ((_e1453 + _e1403) * (0.000000059604645f * 8f))) + _e1403);
                                    if (_e1471 < 0f) {
                                        phi_5399_ = -(_e1471);
                                    } else {
                                        phi_5399_ = _e1471;
                                    }
                                    let _e1514 = phi_5399_;
                                    if (_e1472 < 0f) {
                                        phi_5405_ = -(_e1472);
                                    } else {
                                        phi_5405_ = _e1472;
                                    }
                                    let _e1518 = phi_5405_;
                                    if (_e1514 > _e1518) {
                                        phi_5410_ = _e1514;
                                    } else {
                                        phi_5410_ = _e1518;
                                    }
                                    let _e1521 = phi_5410_;
                                    if (_e1473 < 0f) {
                                        phi_5416_ = -(_e1473);
                                    } else {
                                        phi_5416_ = _e1473;
                                    }
                                    let _e1525 = phi_5416_;
                                    if (_e1521 > _e1525) {
                                        phi_5421_ = _e1521;
                                    } else {
                                        phi_5421_ = _e1525;
                                    }
                                    let _e1528 = phi_5421_;
                                    local_2 = type_24(array<f32, 3>(_e1471, _e1472, _e1473), _e1510, (_e1528 + _e1510));
                                    let _e1534 = local_12.member_3;
                                    let _e1536 = local_12.member_1[0u];
                                    if (_e1536[0] < 0f) {
                                        phi_5447_ = -(_e1536[0]);
                                    } else {
                                        phi_5447_ = _e1536[0];
                                    }
                                    let _e1543 = phi_5447_;
                                    if (_e1536[1] < 0f) {
                                        phi_5454_ = -(_e1536[1]);
                                    } else {
                                        phi_5454_ = _e1536[1];
                                    }
                                    let _e1547 = phi_5454_;
                                    if (_e1543 > _e1547) {
                                        phi_5459_ = _e1543;
                                    } else {
                                        phi_5459_ = _e1547;
                                    }
                                    let _e1550 = phi_5459_;
                                    if (_e1536[2] < 0f) {
                                        phi_5466_ = -(_e1536[2]);
                                    } else {
                                        phi_5466_ = _e1536[2];
                                    }
                                    let _e1554 = phi_5466_;
                                    if (_e1550 > _e1554) {
                                        phi_5471_ = _e1550;
                                    } else {
                                        phi_5471_ = _e1554;
                                    }
                                    let _e1557 = phi_5471_;
                                    let _e1559 = local_12.member_1[1u];
                                    if (_e1559[0] < 0f) {
                                        phi_5484_ = -(_e1559[0]);
                                    } else {
                                        phi_5484_ = _e1559[0];
                                    }
                                    let _e1566 = phi_5484_;
                                    if (_e1559[1] < 0f) {
                                        phi_5491_ = -(_e1559[1]);
                                    } else {
                                        phi_5491_ = _e1559[1];
                                    }
                                    let _e1570 = phi_5491_;
                                    if (_e1566 > _e1570) {
                                        phi_5496_ = _e1566;
                                    } else {
                                        phi_5496_ = _e1570;
                                    }
                                    let _e1573 = phi_5496_;
                                    if (_e1559[2] < 0f) {
                                        phi_5503_ = -(_e1559[2]);
                                    } else {
                                        phi_5503_ = _e1559[2];
                                    }
                                    let _e1577 = phi_5503_;
                                    if (_e1573 > _e1577) {
                                        phi_5508_ = _e1573;
                                    } else {
                                        phi_5508_ = _e1577;
                                    }
                                    let _e1580 = phi_5508_;
                                    if (_e1557 > _e1580) {
                                        phi_5513_ = _e1557;
                                    } else {
                                        phi_5513_ = _e1580;
                                    }
                                    let _e1583 = phi_5513_;
                                    let _e1586 = local_12.member_1[0u];
                                    let _e1591 = local_12.member_1[1u];
                                    let _e1601 = (_e1586[0] + ((_e1591[0] - _e1586[0]) * _e1399));
                                    let _e1602 = (_e1586[1] + ((_e1591[1] - _e1586[1]) * _e1399));
                                    let _e1603 = (_e1586[2] + ((_e1591[2] - _e1586[2]) * _e1399));
                                    let _e1605 = local_12.member_1[1u];
                                    let _e1610 = local_12.member_1[0u];
                                    let _e1614 = (_e1605[0] - _e1610[0]);
                                    let _e1615 = (_e1605[1] - _e1610[1]);
                                    let _e1616 = (_e1605[2] - _e1610[2]);
                                    if (_e1614 < 0f) {
                                        phi_5572_ = -(_e1614);
                                    } else {
                                        phi_5572_ = _e1614;
                                    }
                                    let _e1620 = phi_5572_;
                                    if (_e1615 < 0f) {
                                        phi_5578_ = -(_e1615);
                                    } else {
                                        phi_5578_ = _e1615;
                                    }
                                    let _e1624 = phi_5578_;
                                    if (_e1620 > _e1624) {
                                        phi_5583_ = _e1620;
                                    } else {
                                        phi_5583_ = _e1624;
                                    }
                                    let _e1627 = phi_5583_;
                                    if (_e1616 < 0f) {
                                        phi_5589_ = -(_e1616);
                                    } else {
                                        phi_5589_ = _e1616;
                                    }
                                    let _e1631 = phi_5589_;
                                    if (_e1627 > _e1631) {
                                        phi_5594_ = _e1627;
                                    } else {
                                        phi_5594_ = _e1631;
                                    }
                                    let _e1634 = phi_5594_;
                                    let _e1640 = ((((_e1401 * _e1634) * 1.01f) + ((_e1583 + _e1534) * (0.000000059604645f * 8f))) + _e1534);
                                    if (_e1601 < 0f) {
                                        phi_5606_ = -(_e1601);
                                    } else {
                                        phi_5606_ = _e1601;
                                    }
                                    let _e1644 = phi_5606_;
                                    if (_e1602 < 0f) {
                                        phi_5612_ = -(_e1602);
                                    } else {
                                        phi_5612_ = _e1602;
                                    }
                                    let _e1648 = phi_5612_;
                                    if (_e1644 > _e1648) {
                                        phi_5617_ = _e1644;
                                    } else {
                                        phi_5617_ = _e1648;
                                    }
                                    let _e1651 = phi_5617_;
                                    if (_e1603 < 0f) {
                                        phi_5623_ = -(_e1603);
                                    } else {
                                        phi_5623_ = _e1603;
                                    }
                                    let _e1655 = phi_5623_;
                                    if (_e1651 > _e1655) {
                                        phi_5628_ = _e1651;
                                    } else {
                                        phi_5628_ = _e1655;
                                    }
                                    let _e1658 = phi_5628_;
                                    local_3 = type_24(array<f32, 3>(_e1601, _e1602, _e1603), _e1640, (_e1658 + _e1640));
                                    let _e1664 = local_12.member_3;
                                    let _e1666 = local_12.member_2[0u];
                                    if (_e1666[0] < 0f) {
                                        phi_5654_ = -(_e1666[0]);
                                    } else {
                                        phi_5654_ = _e1666[0];
                                    }
                                    let _e1673 = phi_5654_;
                                    if (_e1666[1] < 0f) {
                                        phi_5661_ = -(_e1666[1]);
                                    } else {
                                        phi_5661_ = _e1666[1];
                                    }
                                    let _e1677 = phi_5661_;
                                    if (_e1673 > _e1677) {
                                        phi_5666_ = _e1673;
                                    } else {
                                        phi_5666_ = _e1677;
                                    }
                                    let _e1680 = phi_5666_;
                                    if (_e1666[2] < 0f) {
                                        phi_5673_ = -(_e1666[2]);
                                    } else {
                                        phi_5673_ = _e1666[2];
                                    }
                                    let _e1684 = phi_5673_;
                                    if (_e1680 > _e1684) {
                                        phi_5678_ = _e1680;
                                    } else {
                                        phi_5678_ = _e1684;
                                    }
                                    let _e1687 = phi_5678_;
                                    let _e1689 = local_12.member_2[1u];
                                    if (_e1689[0] < 0f) {
                                        phi_5691_ = -(_e1689[0]);
                                    } else {
                                        phi_5691_ = _e1689[0];
                                    }
                                    let _e1696 = phi_5691_;
                                    if (_e1689[1] < 0f) {
                                        phi_5698_ = -(_e1689[1]);
                                    } else {
                                        phi_5698_ = _e1689[1];
                                    }
                                    let _e1700 = phi_5698_;
                                    if (_e1696 > _e1700) {
                                        phi_5703_ = _e1696;
                                    } else {
                                        phi_5703_ = _e1700;
                                    }
                                    let _e1703 = phi_5703_;
                                    if (_e1689[2] < 0f) {
                                        phi_5710_ = -(_e1689[2]);
                                    } else {
                                        phi_5710_ = _e1689[2];
                                    }
                                    let _e1707 = phi_5710_;
                                    if (_e1703 > _e1707) {
                                        phi_5715_ = _e1703;
                                    } else {
                                        phi_5715_ = _e1707;
                                    }
                                    let _e1710 = phi_5715_;
                                    if (_e1687 > _e1710) {
                                        phi_5720_ = _e1687;
                                    } else {
                                        phi_5720_ = _e1710;
                                    }
                                    let _e1713 = phi_5720_;
                                    let _e1716 = local_12.member_2[0u];
                                    let _e1721 = local_12.member_2[1u];
                                    let _e1731 = (_e1716[0] + ((_e1721[0] - _e1716[0]) * _e1399));
                                    let _e1732 = (_e1716[1] + ((_e1721[1] - _e1716[1]) * _e1399));
                                    let _e1733 = (_e1716[2] + ((_e1721[2] - _e1716[2]) * _e1399));
                                    let _e1735 = local_12.member_2[1u];
                                    let _e1740 = local_12.member_2[0u];
                                    let _e1744 = (_e1735[0] - _e1740[0]);
                                    let _e1745 = (_e1735[1] - _e1740[1]);
                                    let _e1746 = (_e1735[2] - _e1740[2]);
                                    if (_e1744 < 0f) {
                                        phi_5779_ = -(_e1744);
                                    } else {
                                        phi_5779_ = _e1744;
                                    }
                                    let _e1750 = phi_5779_;
                                    if (_e1745 < 0f) {
                                        phi_5785_ = -(_e1745);
                                    } else {
                                        phi_5785_ = _e1745;
                                    }
                                    let _e1754 = phi_5785_;
                                    if (_e1750 > _e1754) {
                                        phi_5790_ = _e1750;
                                    } else {
                                        phi_5790_ = _e1754;
                                    }
                                    let _e1757 = phi_5790_;
                                    if (_e1746 < 0f) {
                                        phi_5796_ = -(_e1746);
                                    } else {
                                        phi_5796_ = _e1746;
                                    }
                                    let _e1761 = phi_5796_;
                                    if (_e1757 > _e1761) {
                                        phi_5801_ = _e1757;
                                    } else {
                                        phi_5801_ = _e1761;
                                    }
                                    let _e1764 = phi_5801_;
                                    let _e1770 = ((((_e1401 * _e1764) * 1.01f) + ((_e1713 + _e1664) * (0.000000059604645f * 8f))) + _e1664);
                                    if (_e1731 < 0f) {
                                        phi_5813_ = -(_e1731);
                                    } else {
                                        phi_5813_ = _e1731;
                                    }
                                    let _e1774 = phi_5813_;
                                    if (_e1732 < 0f) {
                                        phi_5819_ = -(_e1732);
                                    } else {
                                        phi_5819_ = _e1732;
                                    }
                                    let _e1778 = phi_5819_;
                                    if (_e1774 > _e1778) {
                                        phi_5824_ = _e1774;
                                    } else {
                                        phi_5824_ = _e1778;
                                    }
                                    let _e1781 = phi_5824_;
                                    if (_e1733 < 0f) {
                                        phi_5830_ = -(_e1733);
                                    } else {
                                        phi_5830_ = _e1733;
                                    }
                                    let _e1785 = phi_5830_;
                                    if (_e1781 > _e1785) {
                                        phi_5835_ = _e1781;
                                    } else {
                                        phi_5835_ = _e1785;
                                    }
                                    let _e1788 = phi_5835_;
                                    local_4 = type_24(array<f32, 3>(_e1731, _e1732, _e1733), _e1770, (_e1788 + _e1770));
                                    let _e1793 = local_3.member;
                                    let _e1798 = local_4.member;
                                    let _e1804 = ((_e1793[1] * _e1798[2]) - (_e1793[2] * _e1798[1]));
                                    let _e1807 = ((_e1793[2] * _e1798[0]) - (_e1793[0] * _e1798[2]));
                                    let _e1810 = ((_e1793[0] * _e1798[1]) - (_e1793[1] * _e1798[0]));
                                    if (_e1804 < 0f) {
                                        phi_5884_ = -(_e1804);
                                    } else {
                                        phi_5884_ = _e1804;
                                    }
                                    let _e1814 = phi_5884_;
                                    if (_e1807 < 0f) {
                                        phi_5890_ = -(_e1807);
                                    } else {
                                        phi_5890_ = _e1807;
                                    }
                                    let _e1818 = phi_5890_;
                                    if (_e1814 > _e1818) {
                                        if (_e1804 < 0f) {
                                            phi_5900_ = -(_e1804);
                                        } else {
                                            phi_5900_ = _e1804;
                                        }
                                        let _e1836 = phi_5900_;
                                        if (_e1810 < 0f) {
                                            phi_5906_ = -(_e1810);
                                        } else {
                                            phi_5906_ = _e1810;
                                        }
                                        let _e1840 = phi_5906_;
                                        if (_e1836 > _e1840) {
                                            phi_5911_ = 2u;
                                            phi_5912_ = 1u;
                                        } else {
                                            phi_5911_ = 1u;
                                            phi_5912_ = 0u;
                                        }
                                        let _e1843 = phi_5911_;
                                        let _e1845 = phi_5912_;
                                        phi_5931_ = _e1843;
                                        phi_5932_ = _e1845;
                                    } else {
                                        if (_e1807 < 0f) {
                                            phi_5918_ = -(_e1807);
                                        } else {
                                            phi_5918_ = _e1807;
                                        }
                                        let _e1823 = phi_5918_;
                                        if (_e1810 < 0f) {
                                            phi_5924_ = -(_e1810);
                                        } else {
                                            phi_5924_ = _e1810;
                                        }
                                        let _e1827 = phi_5924_;
                                        if (_e1823 > _e1827) {
                                            phi_5929_ = 0u;
                                            phi_5930_ = 2u;
                                        } else {
                                            phi_5929_ = 1u;
                                            phi_5930_ = 0u;
                                        }
                                        let _e1830 = phi_5929_;
                                        let _e1832 = phi_5930_;
                                        phi_5931_ = _e1830;
                                        phi_5932_ = _e1832;
                                    }
                                    let _e1847 = phi_5931_;
                                    let _e1849 = phi_5932_;
                                    let _e1852 = local_3.member[_e1849];
                                    let _e1855 = local_4.member[_e1847];
                                    let _e1859 = local_3.member[_e1847];
                                    let _e1862 = local_4.member[_e1849];
                                    let _e1864 = ((_e1852 * _e1855) - (_e1859 * _e1862));
                                    let _e1866 = local_3.member_1;
                                    let _e1868 = local_4.member_2;
                                    let _e1871 = local_3.member_2;
                                    let _e1873 = local_4.member_1;
                                    let _e1878 = local_3.member_2;
                                    let _e1881 = local_4.member_2;
                                    let _e1889 = local_3.member_2;
                                    let _e1892 = local_4.member_2;
                                    let _e1896 = (((((_e1866 * _e1868) + (_e1871 * _e1873)) * 2.01f) + (((_e1878 * 2f) * (_e1881 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1889) * (1f + _e1892))));
                                    if (_e1864 < 0f) {
                                        phi_6001_ = -(_e1864);
                                    } else {
                                        phi_6001_ = _e1864;
                                    }
                                    let _e1900 = phi_6001_;
                                    if (_e1900 > _e1896) {
                                        if (_e1864 < 0f) {
                                            phi_6010_ = -1f;
                                        } else {
                                            phi_6010_ = 1f;
                                        }
                                        let _e1904 = phi_6010_;
                                        let _e1907 = local_2.member[_e1849];
                                        let _e1910 = local_4.member[_e1847];
                                        let _e1914 = local_2.member[_e1847];
                                        let _e1917 = local_4.member[_e1849];
                                        let _e1921 = local_2.member_1;
                                        let _e1923 = local_4.member_2;
                                        let _e1926 = local_2.member_2;
                                        let _e1928 = local_4.member_1;
                                        let _e1933 = local_2.member_2;
                                        let _e1936 = local_4.member_2;
                                        let _e1944 = local_2.member_2;
                                        let _e1947 = local_4.member_2;
                                        let _e1951 = (((((_e1921 * _e1923) + (_e1926 * _e1928)) * 2.01f) + (((_e1933 * 2f) * (_e1936 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1944) * (1f + _e1947))));
                                        let _e1954 = local_3.member[_e1849];
                                        let _e1957 = local_2.member[_e1847];
                                        let _e1961 = local_3.member[_e1847];
                                        let _e1964 = local_2.member[_e1849];
                                        let _e1968 = local_3.member_1;
                                        let _e1970 = local_2.member_2;
                                        let _e1973 = local_3.member_2;
                                        let _e1975 = local_2.member_1;
                                        let _e1980 = local_3.member_2;
                                        let _e1983 = local_2.member_2;
                                        let _e1991 = local_3.member_2;
                                        let _e1994 = local_2.member_2;
                                        let _e1998 = (((((_e1968 * _e1970) + (_e1973 * _e1975)) * 2.01f) + (((_e1980 * 2f) * (_e1983 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1991) * (1f + _e1994))));
                                        let _e1999 = (_e1864 * _e1904);
                                        let _e2000 = (((_e1907 * _e1910) - (_e1914 * _e1917)) * _e1904);
                                        let _e2001 = (((_e1954 * _e1957) - (_e1961 * _e1964)) * _e1904);
                                        if (_e1999 < 0f) {
                                            phi_6145_ = -(_e1999);
                                        } else {
                                            phi_6145_ = _e1999;
                                        }
                                        let _e2005 = phi_6145_;
                                        if (_e2000 < 0f) {
                                            phi_6151_ = -(_e2000);
                                        } else {
                                            phi_6151_ = _e2000;
                                        }
                                        let _e2009 = phi_6151_;
                                        if (_e2001 < 0f) {
                                            phi_6158_ = -(_e2001);
                                        } else {
                                            phi_6158_ = _e2001;
                                        }
                                        let _e2014 = phi_6158_;
                                        let _e2019 = ((_e1999 - _e2000) - _e2001);
                                        let _e2022 = (((_e1896 + _e1951) + _e1998) + (((_e2005 + _e2009) + _e2014) * (0.000000059604645f * 4f)));
                                        local_5[0u].member = _e2000;
                                        local_5[0u].member_1 = _e1951;
                                        local_5[1u].member = _e2001;
                                        local_5[1u].member_1 = _e1998;
                                        local_5[2u].member = _e2019;
                                        local_5[2u].member_1 = _e2022;
                                        local_5[3u].member = _e2019;
                                        local_5[3u].member_1 = _e2022;
                                        phi_6201_ = type_19(0u, 4u);
                                        phi_6204_ = true;
                                        loop {
                                            let _e2037 = phi_6201_;
                                            let _e2039 = phi_6204_;
                                            local_17 = _e2039;
                                            if (_e2037.member < _e2037.member_1) {
                                                phi_6202_ = type_19((_e2037.member + 1u), _e2037.member_1);
                                                phi_6227_ = type_19(1u, _e2037.member);
                                            } else {
                                                phi_6202_ = _e2037;
                                                phi_6227_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2051 = phi_6202_;
                                            let _e2053 = phi_6227_;
                                            if (bitcast<i32>(_e2053.member) != 0i) {
                                                let _e2060 = local_5[_e2053.member_1].member;
                                                let _e2063 = local_5[_e2053.member_1].member_1;
                                                let _e2065 = (_e2060 < -(_e2063));
                                                if _e2065 {
                                                    phi_6254_ = bool();
                                                    phi_6255_ = false;
                                                } else {
                                                    phi_6254_ = (_e2039 && (_e2060 > _e2063));
                                                    phi_6255_ = true;
                                                }
                                                let _e2069 = phi_6254_;
                                                let _e2071 = phi_6255_;
                                                phi_6205_ = _e2069;
                                                phi_6256_ = _e2071;
                                                phi_6257_ = _e2065;
                                            } else {
                                                phi_6205_ = bool();
                                                phi_6256_ = false;
                                                phi_6257_ = false;
                                            }
                                            let _e2073 = phi_6205_;
                                            let _e2075 = phi_6256_;
                                            let _e2077 = phi_6257_;
                                            local_16 = _e2077;
                                            continue;
                                            continuing {
                                                phi_6201_ = _e2051;
                                                phi_6204_ = _e2073;
                                                break if !(_e2075);
                                            }
                                        }
                                        let _e2080 = local_16;
                                        if _e2080 {
                                            phi_6261_ = false;
                                        } else {
                                            phi_6261_ = true;
                                        }
                                        let _e2082 = phi_6261_;
                                        if _e2082 {
                                            let _e2084 = local_17;
                                            if _e2084 {
                                                phi_6268_ = 1u;
                                            } else {
                                                phi_6268_ = 2u;
                                            }
                                            let _e2086 = phi_6268_;
                                            phi_6269_ = _e2086;
                                            phi_6270_ = false;
                                        } else {
                                            phi_6269_ = u32();
                                            phi_6270_ = true;
                                        }
                                        let _e2088 = phi_6269_;
                                        let _e2090 = phi_6270_;
                                        phi_6271_ = _e2088;
                                        phi_6272_ = 0u;
                                        phi_6273_ = _e2090;
                                    } else {
                                        phi_6271_ = u32();
                                        phi_6272_ = 2u;
                                        phi_6273_ = true;
                                    }
                                    let _e2092 = phi_6271_;
                                    let _e2094 = phi_6272_;
                                    let _e2096 = phi_6273_;
                                    if _e2096 {
                                        phi_6277_ = _e2094;
                                    } else {
                                        phi_6277_ = _e2092;
                                    }
                                    let _e2098 = phi_6277_;
                                    let _e2099 = (_e2098 == 0u);
                                    if _e2099 {
                                        phi_8408_ = f32();
                                        phi_8409_ = false;
                                        phi_8410_ = false;
                                        phi_8411_ = false;
                                    } else {
                                        if (_e2098 == 1u) {
                                            if _e1391.member_2 {
                                                if ((_e1391.member_1 - _e1391.member) <= 0.0000005f) {
                                                    phi_6297_ = false;
                                                } else {
                                                    phi_6297_ = true;
                                                }
                                                let _e2107 = phi_6297_;
                                                phi_6298_ = _e2107;
                                            } else {
                                                phi_6298_ = true;
                                            }
                                            let _e2109 = phi_6298_;
                                            phi_6299_ = _e2109;
                                        } else {
                                            phi_6299_ = true;
                                        }
                                        let _e2111 = phi_6299_;
                                        if _e2111 {
                                            let _e2116 = local_12.member[0u];
                                            let _e2122 = local_12.member_1[0u];
                                            let _e2128 = local_12.member_2[0u];
                                            let _e2140 = local_12.member[1u];
                                            let _e2146 = local_12.member_1[1u];
                                            let _e2152 = local_12.member_2[1u];
                                            let _e2164 = local_12.member[0u];
                                            if (_e2164[0] < 0f) {
                                                phi_6447_ = -(_e2164[0]);
                                            } else {
                                                phi_6447_ = _e2164[0];
                                            }
                                            let _e2171 = phi_6447_;
                                            if (_e2164[1] < 0f) {
                                                phi_6454_ = -(_e2164[1]);
                                            } else {
                                                phi_6454_ = _e2164[1];
                                            }
                                            let _e2175 = phi_6454_;
                                            if (_e2171 > _e2175) {
                                                phi_6459_ = _e2171;
                                            } else {
                                                phi_6459_ = _e2175;
                                            }
                                            let _e2178 = phi_6459_;
                                            if (_e2164[2] < 0f) {
                                                phi_6466_ = -(_e2164[2]);
                                            } else {
                                                phi_6466_ = _e2164[2];
                                            }
                                            let _e2182 = phi_6466_;
                                            if (_e2178 > _e2182) {
                                                phi_6471_ = _e2178;
                                            } else {
                                                phi_6471_ = _e2182;
                                            }
                                            let _e2185 = phi_6471_;
                                            let _e2188 = local_12.member[1u];
                                            if (_e2188[0] < 0f) {
                                                phi_6484_ = -(_e2188[0]);
                                            } else {
                                                phi_6484_ = _e2188[0];
                                            }
                                            let _e2195 = phi_6484_;
                                            if (_e2188[1] < 0f) {
                                                phi_6491_ = -(_e2188[1]);
                                            } else {
                                                phi_6491_ = _e2188[1];
                                            }
                                            let _e2199 = phi_6491_;
                                            if (_e2195 > _e2199) {
                                                phi_6496_ = _e2195;
                                            } else {
                                                phi_6496_ = _e2199;
                                            }
                                            let _e2202 = phi_6496_;
                                            if (_e2188[2] < 0f) {
                                                phi_6503_ = -(_e2188[2]);
                                            } else {
                                                phi_6503_ = _e2188[2];
                                            }
                                            let _e2206 = phi_6503_;
                                            if (_e2202 > _e2206) {
                                                phi_6508_ = _e2202;
                                            } else {
                                                phi_6508_ = _e2206;
                                            }
                                            let _e2209 = phi_6508_;
                                            if (_e2185 > _e2209) {
                                                phi_6513_ = _e2185;
                                            } else {
                                                phi_6513_ = _e2209;
                                            }
                                            let _e2212 = phi_6513_;
                                            let _e2214 = local_12.member_3;
                                            let _e2218 = local_12.member_1[0u];
                                            if (_e2218[0] < 0f) {
                                                phi_6530_ = -(_e2218[0]);
                                            } else {
                                                phi_6530_ = _e2218[0];
                                            }
                                            let _e2225 = phi_6530_;
                                            if (_e2218[1] < 0f) {
                                                phi_6537_ = -(_e2218[1]);
                                            } else {
                                                phi_6537_ = _e2218[1];
                                            }
                                            let _e2229 = phi_6537_;
                                            if (_e2225 > _e2229) {
                                                phi_6542_ = _e2225;
                                            } else {
                                                phi_6542_ = _e2229;
                                            }
                                            let _e2232 = phi_6542_;
                                            if (_e2218[2] < 0f) {
                                                phi_6549_ = -(_e2218[2]);
                                            } else {
                                                phi_6549_ = _e2218[2];
                                            }
                                            let _e2236 = phi_6549_;
                                            if (_e2232 > _e2236) {
                                                phi_6554_ = _e2232;
                                            } else {
                                                phi_6554_ = _e2236;
                                            }
                                            let _e2239 = phi_6554_;
                                            let _e2242 = local_12.member_1[1u];
                                            if (_e2242[0] < 0f) {
                                                phi_6568_ = -(_e2242[0]);
                                            } else {
                                                phi_6568_ = _e2242[0];
                                            }
                                            let _e2249 = phi_6568_;
                                            if (_e2242[1] < 0f) {
                                                phi_6575_ = -(_e2242[1]);
                                            } else {
                                                phi_6575_ = _e2242[1];
                                            }
                                            let _e2253 = phi_6575_;
                                            if (_e2249 > _e2253) {
                                                phi_6580_ = _e2249;
                                            } else {
                                                phi_6580_ = _e2253;
                                            }
                                            let _e2256 = phi_6580_;
                                            if (_e2242[2] < 0f) {
                                                phi_6587_ = -(_e2242[2]);
                                            } else {
                                                phi_6587_ = _e2242[2];
                                            }
                                            let _e2260 = phi_6587_;
                                            if (_e2256 > _e2260) {
                                                phi_6592_ = _e2256;
                                            } else {
                                                phi_6592_ = _e2260;
                                            }
                                            let _e2263 = phi_6592_;
                                            if (_e2239 > _e2263) {
                                                phi_6597_ = _e2239;
                                            } else {
                                                phi_6597_ = _e2263;
                                            }
                                            let _e2266 = phi_6597_;
                                            let _e2268 = local_12.member_3;
                                            let _e2272 = local_12.member_2[0u];
                                            if (_e2272[0] < 0f) {
                                                phi_6614_ = -(_e2272[0]);
                                            } else {
                                                phi_6614_ = _e2272[0];
                                            }
                                            let _e2279 = phi_6614_;
                                            if (_e2272[1] < 0f) {
                                                phi_6621_ = -(_e2272[1]);
                                            } else {
                                                phi_6621_ = _e2272[1];
                                            }
                                            let _e2283 = phi_6621_;
                                            if (_e2279 > _e2283) {
                                                phi_6626_ = _e2279;
                                            } else {
                                                phi_6626_ = _e2283;
                                            }
                                            let _e2286 = phi_6626_;
                                            if (_e2272[2] < 0f) {
                                                phi_6633_ = -(_e2272[2]);
                                            } else {
                                                phi_6633_ = _e2272[2];
                                            }
                                            let _e2290 = phi_6633_;
                                            if (_e2286 > _e2290) {
                                                phi_6638_ = _e2286;
                                            } else {
                                                phi_6638_ = _e2290;
                                            }
                                            let _e2293 = phi_6638_;
                                            let _e2296 = local_12.member_2[1u];
                                            if (_e2296[0] < 0f) {
                                                phi_6652_ = -(_e2296[0]);
                                            } else {
                                                phi_6652_ = _e2296[0];
                                            }
                                            let _e2303 = phi_6652_;
                                            if (_e2296[1] < 0f) {
                                                phi_6659_ = -(_e2296[1]);
                                            } else {
                                                phi_6659_ = _e2296[1];
                                            }
                                            let _e2307 = phi_6659_;
                                            if (_e2303 > _e2307) {
                                                phi_6664_ = _e2303;
                                            } else {
                                                phi_6664_ = _e2307;
                                            }
                                            let _e2310 = phi_6664_;
                                            if (_e2296[2] < 0f) {
                                                phi_6671_ = -(_e2296[2]);
                                            } else {
                                                phi_6671_ = _e2296[2];
                                            }
                                            let _e2314 = phi_6671_;
                                            if (_e2310 > _e2314) {
                                                phi_6676_ = _e2310;
                                            } else {
                                                phi_6676_ = _e2314;
                                            }
                                            let _e2317 = phi_6676_;
                                            if (_e2293 > _e2317) {
                                                phi_6681_ = _e2293;
                                            } else {
                                                phi_6681_ = _e2317;
                                            }
                                            let _e2320 = phi_6681_;
                                            let _e2322 = local_12.member_3;
                                            let _e2329 = local_12.member_3;
                                            local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6720_ = type_19(0u, 96u);
                                            phi_6723_ = _e1391.member;
                                            phi_6725_ = _e1391.member;
                                            phi_6727_ = _e1391.member;
                                            loop {
                                                let _e2335 = phi_6720_;
                                                let _e2337 = phi_6723_;
                                                let _e2339 = phi_6725_;
                                                let _e2341 = phi_6727_;
                                                local_36 = _e2339;
                                                local_20 = _e2337;
                                                if (_e2335.member < _e2335.member_1) {
                                                    phi_6721_ = type_19((_e2335.member + 1u), _e2335.member_1);
                                                    phi_6750_ = type_19(1u, _e2335.member);
                                                } else {
                                                    phi_6721_ = _e2335;
                                                    phi_6750_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2353 = phi_6721_;
                                                let _e2355 = phi_6750_;
                                                if (bitcast<i32>(_e2355.member) != 0i) {
                                                    let _e2362 = local_12.member[0u];
                                                    let _e2368 = local_12.member[1u];
                                                    let _e2384 = local_12.member_1[0u];
                                                    let _e2390 = local_12.member_1[1u];
                                                    let _e2406 = local_12.member_2[0u];
                                                    let _e2412 = local_12.member_2[1u];
                                                    let _e2426 = function_1(array<f32, 3>((_e2362[0] + ((_e2368[0] - _e2362[0]) * _e2337)), (_e2362[1] + ((_e2368[1] - _e2362[1]) * _e2337)), (_e2362[2] + ((_e2368[2] - _e2362[2]) * _e2337))), array<f32, 3>((_e2384[0] + ((_e2390[0] - _e2384[0]) * _e2337)), (_e2384[1] + ((_e2390[1] - _e2384[1]) * _e2337)), (_e2384[2] + ((_e2390[2] - _e2384[2]) * _e2337))), array<f32, 3>((_e2406[0] + ((_e2412[0] - _e2406[0]) * _e2337)), (_e2406[1] + ((_e2412[1] - _e2406[1]) * _e2337)), (_e2406[2] + ((_e2412[2] - _e2406[2]) * _e2337))), 0u);
                                                    if (_e2426[0] < 0f) {
                                                        phi_6862_ = -(_e2426[0]);
                                                    } else {
                                                        phi_6862_ = _e2426[0];
                                                    }
                                                    let _e2431 = phi_6862_;
                                                    if (_e2426[1] < 0f) {
                                                        phi_6869_ = -(_e2426[1]);
                                                    } else {
                                                        phi_6869_ = _e2426[1];
                                                    }
                                                    let _e2436 = phi_6869_;
                                                    if (_e2426[2] < 0f) {
                                                        phi_6877_ = -(_e2426[2]);
                                                    } else {
                                                        phi_6877_ = _e2426[2];
                                                    }
                                                    let _e2442 = phi_6877_;
                                                    let _e2443 = ((_e2431 + _e2436) + _e2442);
                                                    if (_e2443 > 0f) {
                                                        if ((bitcast<u32>(_e2443) & 2139095040u) != 2139095040u) {
                                                            let _e2448 = (1f / _e2443);
                                                            let _e2450 = (_e2426[0] * _e2448);
                                                            let _e2452 = (_e2426[1] * _e2448);
                                                            let _e2454 = (_e2426[2] * _e2448);
                                                            let _e2459 = (((_e2450 * _e2450) + (_e2452 * _e2452)) + (_e2454 * _e2454));
                                                            if (_e2459 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2459 > 0f) {
                                                                    phi_6914_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6914_ = 0f;
                                                                }
                                                                let _e2512 = phi_6914_;
                                                                phi_6978_ = _e2512;
                                                            } else {
                                                                phi_6921_ = type_17(0i, 5i);
                                                                phi_6924_ = bitcast<f32>(((bitcast<u32>(_e2459) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2467 = phi_6921_;
                                                                    let _e2469 = phi_6924_;
                                                                    local_18 = _e2469;
                                                                    if (_e2467.member < _e2467.member_1) {
                                                                        let _e2476 = (_e2467.member + 1i);
                                                                        if ((false == (_e2476 > _e2467.member)) != false) {
                                                                            phi_6945_ = true;
                                                                        } else {
                                                                            phi_6945_ = false;
                                                                        }
                                                                        let _e2481 = phi_6945_;
                                                                        if _e2481 {
                                                                            phi_6951_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_6951_ = type_18(1u, _e2476);
                                                                        }
                                                                        let _e2486 = phi_6951_;
                                                                        phi_6922_ = type_17(_e2486.member_1, _e2467.member_1);
                                                                        phi_6965_ = type_18(1u, _e2467.member);
                                                                    } else {
                                                                        phi_6922_ = _e2467;
                                                                        phi_6965_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2492 = phi_6922_;
                                                                    let _e2494 = phi_6965_;
                                                                    let _e2497 = (bitcast<i32>(_e2494.member) != 0i);
                                                                    if _e2497 {
                                                                        phi_6925_ = (0.5f * (_e2469 + (_e2459 / _e2469)));
                                                                    } else {
                                                                        phi_6925_ = f32();
                                                                    }
                                                                    let _e2502 = phi_6925_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6921_ = _e2492;
                                                                        phi_6924_ = _e2502;
                                                                        break if !(_e2497);
                                                                    }
                                                                }
                                                                let _e2507 = local_18;
                                                                phi_6978_ = (_e2507 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2514 = phi_6978_;
                                                            let _e2515 = (0.000000059604645f * 12f);
                                                            let _e2520 = ((((((((_e2212 + _e2214) + (_e2266 + _e2268)) + (_e2320 + _e2322)) * (0.000000059604645f * 16f)) + (_e2329 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2514) * (1f + _e2515)));
                                                            let _e2525 = (((_e2450 * _e2116[0]) + (_e2452 * _e2116[1])) + (_e2454 * _e2116[2]));
                                                            let _e2530 = (((_e2450 * (_e2116[0] - _e2122[0])) + (_e2452 * (_e2116[1] - _e2122[1]))) + (_e2454 * (_e2116[2] - _e2122[2])));
                                                            let _e2535 = (((_e2450 * (_e2116[0] - _e2128[0])) + (_e2452 * (_e2116[1] - _e2128[1]))) + (_e2454 * (_e2116[2] - _e2128[2])));
                                                            let _e2540 = (((_e2450 * _e2116[0]) + (_e2452 * _e2116[1])) + (_e2454 * _e2116[2]));
                                                            let _e2546 = (((_e2450 * _e2140[0]) + (_e2452 * _e2140[1])) + (_e2454 * _e2140[2]));
                                                            let _e2551 = (((_e2450 * (_e2140[0] - _e2146[0])) + (_e2452 * (_e2140[1] - _e2146[1]))) + (_e2454 * (_e2140[2] - _e2146[2])));
                                                            let _e2556 = (((_e2450 * (_e2140[0] - _e2152[0])) + (_e2452 * (_e2140[1] - _e2152[1]))) + (_e2454 * (_e2140[2] - _e2152[2])));
                                                            let _e2561 = (((_e2450 * _e2140[0]) + (_e2452 * _e2140[1])) + (_e2454 * _e2140[2]));
                                                            if (_e2525 < 0f) {
                                                                phi_7044_ = -(_e2525);
                                                            } else {
                                                                phi_7044_ = _e2525;
                                                            }
                                                            let _e2566 = phi_7044_;
                                                            if (_e2546 < 0f) {
                                                                phi_7050_ = -(_e2546);
                                                            } else {
                                                                phi_7050_ = _e2546;
                                                            }
                                                            let _e2570 = phi_7050_;
                                                            if (_e2530 < 0f) {
                                                                phi_7059_ = -(_e2530);
                                                            } else {
                                                                phi_7059_ = _e2530;
                                                            }
                                                            let _e2577 = phi_7059_;
                                                            if (_e2551 < 0f) {
                                                                phi_7065_ = -(_e2551);
                                                            } else {
                                                                phi_7065_ = _e2551;
                                                            }
                                                            let _e2581 = phi_7065_;
                                                            if (_e2535 < 0f) {
                                                                phi_7074_ = -(_e2535);
                                                            } else {
                                                                phi_7074_ = _e2535;
                                                            }
                                                            let _e2588 = phi_7074_;
                                                            if (_e2556 < 0f) {
                                                                phi_7080_ = -(_e2556);
                                                            } else {
                                                                phi_7080_ = _e2556;
                                                            }
                                                            let _e2592 = phi_7080_;
                                                            if (_e2540 < 0f) {
                                                                phi_7089_ = -(_e2540);
                                                            } else {
                                                                phi_7089_ = _e2540;
                                                            }
                                                            let _e2599 = phi_7089_;
                                                            if (_e2561 < 0f) {
                                                                phi_7095_ = -(_e2561);
                                                            } else {
                                                                phi_7095_ = _e2561;
                                                            }
                                                            let _e2603 = phi_7095_;
                                                            phi_7101_ = type_28(array<f32, 4>(_e2525, _e2530, _e2535, _e2540), array<f32, 4>(_e2546, _e2551, _e2556, _e2561), array<f32, 4>((_e2520 + ((_e2566 + _e2570) * _e2515)), (_e2520 + ((_e2577 + _e2581) * _e2515)), (_e2520 + ((_e2588 + _e2592) * _e2515)), (_e2520 + ((_e2599 + _e2603) * _e2515))));
                                                            phi_7102_ = false;
                                                        } else {
                                                            phi_7101_ = type_28();
                                                            phi_7102_ = true;
                                                        }
                                                        let _e2610 = phi_7101_;
                                                        let _e2612 = phi_7102_;
                                                        phi_7103_ = _e2610;
                                                        phi_7104_ = _e2612;
                                                    } else {
                                                        phi_7103_ = type_28();
                                                        phi_7104_ = true;
                                                    }
                                                    let _e2614 = phi_7103_;
                                                    let _e2616 = phi_7104_;
                                                    if _e2616 {
                                                        phi_7112_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7112_ = _e2614;
                                                    }
                                                    let _e2618 = phi_7112_;
                                                    local_1 = type_28(array<f32, 4>(_e2618.member[0], _e2618.member[1], _e2618.member[2], _e2618.member[3]), array<f32, 4>(_e2618.member_1[0], _e2618.member_1[1], _e2618.member_1[2], _e2618.member_1[3]), array<f32, 4>(_e2618.member_2[0], _e2618.member_2[1], _e2618.member_2[2], _e2618.member_2[3]));
                                                    let _e2638 = (_e2337 - _e2341);
                                                    let _e2641 = local_1.member[0u];
                                                    let _e2644 = local_1.member_1[0u];
                                                    let _e2647 = local_1.member[0u];
                                                    let _e2653 = local_1.member_2[0u];
                                                    if (((_e2641 + ((_e2644 - _e2647) * _e2337)) - _e2653) > 0f) {
                                                        let _e2658 = local_1.member[1u];
                                                        let _e2661 = local_1.member_1[1u];
                                                        let _e2664 = local_1.member[1u];
                                                        let _e2670 = local_1.member_2[1u];
                                                        if (((_e2658 + ((_e2661 - _e2664) * _e2337)) - _e2670) > 0f) {
                                                            let _e2675 = local_1.member[2u];
                                                            let _e2678 = local_1.member_1[2u];
                                                            let _e2681 = local_1.member[2u];
                                                            let _e2687 = local_1.member_2[2u];
                                                            if (((_e2675 + ((_e2678 - _e2681) * _e2337)) - _e2687) > 0f) {
                                                                let _e2692 = local_1.member[3u];
                                                                let _e2695 = local_1.member_1[3u];
                                                                let _e2698 = local_1.member[3u];
                                                                let _e2704 = local_1.member_2[3u];
                                                                phi_7282_ = (((_e2692 + ((_e2695 - _e2698) * _e2337)) - _e2704) > 0f);
                                                                phi_7283_ = false;
                                                            } else {
                                                                phi_7282_ = bool();
                                                                phi_7283_ = true;
                                                            }
                                                            let _e2708 = phi_7282_;
                                                            let _e2710 = phi_7283_;
                                                            phi_7284_ = _e2708;
                                                            phi_7285_ = _e2710;
                                                        } else {
                                                            phi_7284_ = bool();
                                                            phi_7285_ = true;
                                                        }
                                                        let _e2712 = phi_7284_;
                                                        let _e2714 = phi_7285_;
                                                        phi_7286_ = _e2712;
                                                        phi_7287_ = _e2714;
                                                    } else {
                                                        phi_7286_ = bool();
                                                        phi_7287_ = true;
                                                    }
                                                    let _e2716 = phi_7286_;
                                                    let _e2718 = phi_7287_;
                                                    if _e2718 {
                                                        phi_7291_ = false;
                                                    } else {
                                                        phi_7291_ = _e2716;
                                                    }
                                                    let _e2720 = phi_7291_;
                                                    if _e2720 {
                                                        if (_e2337 <= _e2339) {
                                                            phi_7601_ = true;
                                                        } else {
                                                            let _e2724 = local.member[0u];
                                                            let _e2727 = local.member_1[0u];
                                                            let _e2730 = local.member[0u];
                                                            let _e2736 = local.member_2[0u];
                                                            let _e2740 = local_1.member[0u];
                                                            let _e2743 = local_1.member_1[0u];
                                                            let _e2746 = local_1.member[0u];
                                                            let _e2752 = local_1.member_2[0u];
                                                            if ((((_e2724 + ((_e2727 - _e2730) * _e2337)) - _e2736) + ((_e2740 + ((_e2743 - _e2746) * _e2341)) - _e2752)) > 0f) {
                                                                let _e2758 = local.member[1u];
                                                                let _e2761 = local.member_1[1u];
                                                                let _e2764 = local.member[1u];
                                                                let _e2770 = local.member_2[1u];
                                                                let _e2774 = local_1.member[1u];
                                                                let _e2777 = local_1.member_1[1u];
                                                                let _e2780 = local_1.member[1u];
                                                                let _e2786 = local_1.member_2[1u];
                                                                if ((((_e2758 + ((_e2761 - _e2764) * _e2337)) - _e2770) + ((_e2774 + ((_e2777 - _e2780) * _e2341)) - _e2786)) > 0f) {
                                                                    let _e2792 = local.member[2u];
                                                                    let _e2795 = local.member_1[2u];
                                                                    let _e2798 = local.member[2u];
                                                                    let _e2804 = local.member_2[2u];
                                                                    let _e2808 = local_1.member[2u];
                                                                    let _e2811 = local_1.member_1[2u];
                                                                    let _e2814 = local_1.member[2u];
                                                                    let _e2820 = local_1.member_2[2u];
                                                                    if ((((_e2792 + ((_e2795 - _e2798) * _e2337)) - _e2804) + ((_e2808 + ((_e2811 - _e2814) * _e2341)) - _e2820)) > 0f) {
                                                                        let _e2826 = local.member[3u];
                                                                        let _e2829 = local.member_1[3u];
                                                                        let _e2832 = local.member[3u];
                                                                        let _e2838 = local.member_2[3u];
                                                                        let _e2842 = local_1.member[3u];
                                                                        let _e2845 = local_1.member_1[3u];
                                                                        let _e2848 = local_1.member[3u];
                                                                        let _e2854 = local_1.member_2[3u];
                                                                        phi_7588_ = ((((_e2826 + ((_e2829 - _e2832) * _e2337)) - _e2838) + ((_e2842 + ((_e2845 - _e2848) * _e2341)) - _e2854)) > 0f);
                                                                        phi_7589_ = false;
                                                                    } else {
                                                                        phi_7588_ = bool();
                                                                        phi_7589_ = true;
                                                                    }
                                                                    let _e2859 = phi_7588_;
                                                                    let _e2861 = phi_7589_;
                                                                    phi_7590_ = _e2859;
                                                                    phi_7591_ = _e2861;
                                                                } else {
                                                                    phi_7590_ = bool();
                                                                    phi_7591_ = true;
                                                                }
                                                                let _e2863 = phi_7590_;
                                                                let _e2865 = phi_7591_;
                                                                phi_7592_ = _e2863;
                                                                phi_7593_ = _e2865;
                                                            } else {
                                                                phi_7592_ = bool();
                                                                phi_7593_ = true;
                                                            }
                                                            let _e2867 = phi_7592_;
                                                            let _e2869 = phi_7593_;
                                                            if _e2869 {
                                                                phi_7597_ = false;
                                                            } else {
                                                                phi_7597_ = _e2867;
                                                            }
                                                            let _e2871 = phi_7597_;
                                                            phi_7601_ = _e2871;
                                                        }
                                                        let _e2873 = phi_7601_;
                                                        if _e2873 {
                                                            if (_e2355.member_1 > 0u) {
                                                                if (_e2337 >= _e1391.member_1) {
                                                                    phi_7613_ = false;
                                                                } else {
                                                                    phi_7613_ = true;
                                                                }
                                                                let _e2877 = phi_7613_;
                                                                phi_7614_ = _e2877;
                                                            } else {
                                                                phi_7614_ = true;
                                                            }
                                                            let _e2879 = phi_7614_;
                                                            if _e2879 {
                                                                local = type_28(array<f32, 4>(_e2618.member[0], _e2618.member[1], _e2618.member[2], _e2618.member[3]), array<f32, 4>(_e2618.member_1[0], _e2618.member_1[1], _e2618.member_1[2], _e2618.member_1[3]), array<f32, 4>(_e2618.member_2[0], _e2618.member_2[1], _e2618.member_2[2], _e2618.member_2[3]));
                                                                let _e2901 = local.member[0u];
                                                                let _e2904 = local.member_1[0u];
                                                                let _e2907 = local.member_2[0u];
                                                                if (_e2901 > _e2907) {
                                                                    if (_e2904 > _e2907) {
                                                                        phi_7688_ = false;
                                                                    } else {
                                                                        phi_7688_ = true;
                                                                    }
                                                                    let _e2911 = phi_7688_;
                                                                    phi_7689_ = _e2911;
                                                                } else {
                                                                    phi_7689_ = true;
                                                                }
                                                                let _e2913 = phi_7689_;
                                                                if _e2913 {
                                                                    let _e2914 = (_e2904 >= _e2901);
                                                                    if _e2914 {
                                                                        phi_7711_ = f32();
                                                                        phi_7712_ = false;
                                                                    } else {
                                                                        if ((_e2901 - _e2904) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7709_ = (((_e2901 - _e2907) / (_e2901 - _e2904)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7710_ = false;
                                                                        } else {
                                                                            phi_7709_ = f32();
                                                                            phi_7710_ = true;
                                                                        }
                                                                        let _e2925 = phi_7709_;
                                                                        let _e2927 = phi_7710_;
                                                                        phi_7711_ = _e2925;
                                                                        phi_7712_ = _e2927;
                                                                    }
                                                                    let _e2929 = phi_7711_;
                                                                    let _e2931 = phi_7712_;
                                                                    phi_7713_ = _e2929;
                                                                    phi_7714_ = _e2914;
                                                                    phi_7715_ = _e2931;
                                                                } else {
                                                                    phi_7713_ = f32();
                                                                    phi_7714_ = true;
                                                                    phi_7715_ = false;
                                                                }
                                                                let _e2933 = phi_7713_;
                                                                let _e2935 = phi_7714_;
                                                                let _e2937 = phi_7715_;
                                                                if _e2935 {
                                                                    phi_7719_ = 2f;
                                                                    phi_7720_ = true;
                                                                } else {
                                                                    phi_7719_ = _e2337;
                                                                    phi_7720_ = _e2937;
                                                                }
                                                                let _e2939 = phi_7719_;
                                                                let _e2941 = phi_7720_;
                                                                if _e2941 {
                                                                    phi_7724_ = _e2939;
                                                                } else {
                                                                    phi_7724_ = _e2933;
                                                                }
                                                                let _e2943 = phi_7724_;
                                                                let _e2946 = local.member[1u];
                                                                let _e2949 = local.member_1[1u];
                                                                let _e2952 = local.member_2[1u];
                                                                if (_e2946 > _e2952) {
                                                                    if (_e2949 > _e2952) {
                                                                        phi_7756_ = false;
                                                                    } else {
                                                                        phi_7756_ = true;
                                                                    }
                                                                    let _e2956 = phi_7756_;
                                                                    phi_7757_ = _e2956;
                                                                } else {
                                                                    phi_7757_ = true;
                                                                }
                                                                let _e2958 = phi_7757_;
                                                                if _e2958 {
                                                                    let _e2959 = (_e2949 >= _e2946);
                                                                    if _e2959 {
                                                                        phi_7779_ = f32();
                                                                        phi_7780_ = false;
                                                                    } else {
                                                                        if ((_e2946 - _e2949) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7777_ = (((_e2946 - _e2952) / (_e2946 - _e2949)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7778_ = false;
                                                                        } else {
                                                                            phi_7777_ = f32();
                                                                            phi_7778_ = true;
                                                                        }
                                                                        let _e2970 = phi_7777_;
                                                                        let _e2972 = phi_7778_;
                                                                        phi_7779_ = _e2970;
                                                                        phi_7780_ = _e2972;
                                                                    }
                                                                    let _e2974 = phi_7779_;
                                                                    let _e2976 = phi_7780_;
                                                                    phi_7781_ = _e2974;
                                                                    phi_7782_ = _e2959;
                                                                    phi_7783_ = _e2976;
                                                                } else {
                                                                    phi_7781_ = f32();
                                                                    phi_7782_ = true;
                                                                    phi_7783_ = false;
                                                                }
                                                                let _e2978 = phi_7781_;
                                                                let _e2980 = phi_7782_;
                                                                let _e2982 = phi_7783_;
                                                                if _e2980 {
                                                                    phi_7787_ = 2f;
                                                                    phi_7788_ = true;
                                                                } else {
                                                                    phi_7787_ = _e2337;
                                                                    phi_7788_ = _e2982;
                                                                }
                                                                let _e2984 = phi_7787_;
                                                                let _e2986 = phi_7788_;
                                                                if _e2986 {
                                                                    phi_7792_ = _e2984;
                                                                } else {
                                                                    phi_7792_ = _e2978;
                                                                }
                                                                let _e2988 = phi_7792_;
                                                                if (_e2943 < _e2988) {
                                                                    phi_7797_ = _e2943;
                                                                } else {
                                                                    phi_7797_ = _e2988;
                                                                }
                                                                let _e2991 = phi_7797_;
                                                                let _e2994 = local.member[2u];
                                                                let _e2997 = local.member_1[2u];
                                                                let _e3000 = local.member_2[2u];
                                                                if (_e2994 > _e3000) {
                                                                    if (_e2997 > _e3000) {
                                                                        phi_7829_ = false;
                                                                    } else {
                                                                        phi_7829_ = true;
                                                                    }
                                                                    let _e3004 = phi_7829_;
                                                                    phi_7830_ = _e3004;
                                                                } else {
                                                                    phi_7830_ = true;
                                                                }
                                                                let _e3006 = phi_7830_;
                                                                if _e3006 {
                                                                    let _e3007 = (_e2997 >= _e2994);
                                                                    if _e3007 {
                                                                        phi_7852_ = f32();
                                                                        phi_7853_ = false;
                                                                    } else {
                                                                        if ((_e2994 - _e2997) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7850_ = (((_e2994 - _e3000) / (_e2994 - _e2997)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7851_ = false;
                                                                        } else {
                                                                            phi_7850_ = f32();
                                                                            phi_7851_ = true;
                                                                        }
                                                                        let _e3018 = phi_7850_;
                                                                        let _e3020 = phi_7851_;
                                                                        phi_7852_ = _e3018;
                                                                        phi_7853_ = _e3020;
                                                                    }
                                                                    let _e3022 = phi_7852_;
                                                                    let _e3024 = phi_7853_;
                                                                    phi_7854_ = _e3022;
                                                                    phi_7855_ = _e3007;
                                                                    phi_7856_ = _e3024;
                                                                } else {
                                                                    phi_7854_ = f32();
                                                                    phi_7855_ = true;
                                                                    phi_7856_ = false;
                                                                }
                                                                let _e3026 = phi_7854_;
                                                                let _e3028 = phi_7855_;
                                                                let _e3030 = phi_7856_;
                                                                if _e3028 {
                                                                    phi_7860_ = 2f;
                                                                    phi_7861_ = true;
                                                                } else {
                                                                    phi_7860_ = _e2337;
                                                                    phi_7861_ = _e3030;
                                                                }
                                                                let _e3032 = phi_7860_;
                                                                let _e3034 = phi_7861_;
                                                                if _e3034 {
                                                                    phi_7865_ = _e3032;
                                                                } else {
                                                                    phi_7865_ = _e3026;
                                                                }
                                                                let _e3036 = phi_7865_;
                                                                let _e3039 = local.member[3u];
                                                                let _e3042 = local.member_1[3u];
                                                                let _e3045 = local.member_2[3u];
                                                                if (_e3039 > _e3045) {
                                                                    if (_e3042 > _e3045) {
                                                                        phi_7897_ = false;
                                                                    } else {
                                                                        phi_7897_ = true;
                                                                    }
                                                                    let _e3049 = phi_7897_;
                                                                    phi_7898_ = _e3049;
                                                                } else {
                                                                    phi_7898_ = true;
                                                                }
                                                                let _e3051 = phi_7898_;
                                                                if _e3051 {
                                                                    let _e3052 = (_e3042 >= _e3039);
                                                                    if _e3052 {
                                                                        phi_7920_ = f32();
                                                                        phi_7921_ = false;
                                                                    } else {
                                                                        if ((_e3039 - _e3042) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7918_ = (((_e3039 - _e3045) / (_e3039 - _e3042)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7919_ = false;
                                                                        } else {
                                                                            phi_7918_ = f32();
                                                                            phi_7919_ = true;
                                                                        }
                                                                        let _e3063 = phi_7918_;
                                                                        let _e3065 = phi_7919_;
                                                                        phi_7920_ = _e3063;
                                                                        phi_7921_ = _e3065;
                                                                    }
                                                                    let _e3067 = phi_7920_;
                                                                    let _e3069 = phi_7921_;
                                                                    phi_7922_ = _e3067;
                                                                    phi_7923_ = _e3052;
                                                                    phi_7924_ = _e3069;
                                                                } else {
                                                                    phi_7922_ = f32();
                                                                    phi_7923_ = true;
                                                                    phi_7924_ = false;
                                                                }
                                                                let _e3071 = phi_7922_;
                                                                let _e3073 = phi_7923_;
                                                                let _e3075 = phi_7924_;
                                                                if _e3073 {
                                                                    phi_7928_ = 2f;
                                                                    phi_7929_ = true;
                                                                } else {
                                                                    phi_7928_ = _e2337;
                                                                    phi_7929_ = _e3075;
                                                                }
                                                                let _e3077 = phi_7928_;
                                                                let _e3079 = phi_7929_;
                                                                if _e3079 {
                                                                    phi_7933_ = _e3077;
                                                                } else {
                                                                    phi_7933_ = _e3071;
                                                                }
                                                                let _e3081 = phi_7933_;
                                                                if (_e3036 < _e3081) {
                                                                    phi_7938_ = _e3036;
                                                                } else {
                                                                    phi_7938_ = _e3081;
                                                                }
                                                                let _e3084 = phi_7938_;
                                                                if (_e2991 < _e3084) {
                                                                    phi_7943_ = _e2991;
                                                                } else {
                                                                    phi_7943_ = _e3084;
                                                                }
                                                                let _e3087 = phi_7943_;
                                                                if (_e3087 > _e2337) {
                                                                    phi_7948_ = _e3087;
                                                                } else {
                                                                    phi_7948_ = _e2337;
                                                                }
                                                                let _e3090 = phi_7948_;
                                                                let _e3091 = (_e3090 > _e1391.member_1);
                                                                if _e3091 {
                                                                    phi_7960_ = f32();
                                                                    phi_7961_ = false;
                                                                } else {
                                                                    if (_e2355.member_1 == 0u) {
                                                                        phi_7959_ = (_e1391.member_1 - _e2337);
                                                                    } else {
                                                                        phi_7959_ = (_e2638 + _e2638);
                                                                    }
                                                                    let _e3096 = phi_7959_;
                                                                    phi_7960_ = _e3096;
                                                                    phi_7961_ = true;
                                                                }
                                                                let _e3098 = phi_7960_;
                                                                let _e3100 = phi_7961_;
                                                                phi_7962_ = _e3090;
                                                                phi_7963_ = _e3098;
                                                                phi_7964_ = _e3100;
                                                                phi_7965_ = _e3091;
                                                                phi_7966_ = false;
                                                            } else {
                                                                phi_7962_ = f32();
                                                                phi_7963_ = f32();
                                                                phi_7964_ = false;
                                                                phi_7965_ = false;
                                                                phi_7966_ = true;
                                                            }
                                                            let _e3102 = phi_7962_;
                                                            let _e3104 = phi_7963_;
                                                            let _e3106 = phi_7964_;
                                                            let _e3108 = phi_7965_;
                                                            let _e3110 = phi_7966_;
                                                            phi_7967_ = _e3102;
                                                            phi_7968_ = _e3104;
                                                            phi_7969_ = false;
                                                            phi_7970_ = _e3106;
                                                            phi_7971_ = _e3108;
                                                            phi_7972_ = _e3110;
                                                        } else {
                                                            phi_7967_ = f32();
                                                            phi_7968_ = f32();
                                                            phi_7969_ = true;
                                                            phi_7970_ = false;
                                                            phi_7971_ = false;
                                                            phi_7972_ = false;
                                                        }
                                                        let _e3112 = phi_7967_;
                                                        let _e3114 = phi_7968_;
                                                        let _e3116 = phi_7969_;
                                                        let _e3118 = phi_7970_;
                                                        let _e3120 = phi_7971_;
                                                        let _e3122 = phi_7972_;
                                                        phi_7973_ = _e3112;
                                                        phi_7974_ = _e3114;
                                                        phi_7975_ = _e3116;
                                                        phi_7976_ = _e3118;
                                                        phi_7977_ = _e3120;
                                                        phi_7978_ = _e3122;
                                                    } else {
                                                        phi_7973_ = f32();
                                                        phi_7974_ = f32();
                                                        phi_7975_ = true;
                                                        phi_7976_ = false;
                                                        phi_7977_ = false;
                                                        phi_7978_ = false;
                                                    }
                                                    let _e3124 = phi_7973_;
                                                    let _e3126 = phi_7974_;
                                                    let _e3128 = phi_7975_;
                                                    let _e3130 = phi_7976_;
                                                    let _e3132 = phi_7977_;
                                                    let _e3134 = phi_7978_;
                                                    if _e3128 {
                                                        let _e3135 = (_e2337 <= _e2339);
                                                        if _e3135 {
                                                            phi_8307_ = f32();
                                                            phi_8308_ = false;
                                                        } else {
                                                            let _e3138 = local.member[0u];
                                                            let _e3141 = local.member_1[0u];
                                                            let _e3144 = local.member[0u];
                                                            let _e3150 = local.member_2[0u];
                                                            let _e3151 = ((_e3138 + ((_e3141 - _e3144) * _e2341)) - _e3150);
                                                            let _e3154 = local.member[1u];
                                                            let _e3157 = local.member_1[1u];
                                                            let _e3160 = local.member[1u];
                                                            let _e3166 = local.member_2[1u];
                                                            let _e3167 = ((_e3154 + ((_e3157 - _e3160) * _e2341)) - _e3166);
                                                            if (_e3151 < _e3167) {
                                                                phi_8058_ = _e3151;
                                                            } else {
                                                                phi_8058_ = _e3167;
                                                            }
                                                            let _e3170 = phi_8058_;
                                                            let _e3173 = local.member[2u];
                                                            let _e3176 = local.member_1[2u];
                                                            let _e3179 = local.member[2u];
                                                            let _e3185 = local.member_2[2u];
                                                            let _e3186 = ((_e3173 + ((_e3176 - _e3179) * _e2341)) - _e3185);
                                                            let _e3189 = local.member[3u];
                                                            let _e3192 = local.member_1[3u];
                                                            let _e3195 = local.member[3u];
                                                            let _e3201 = local.member_2[3u];
                                                            let _e3202 = ((_e3189 + ((_e3192 - _e3195) * _e2341)) - _e3201);
                                                            if (_e3186 < _e3202) {
                                                                phi_8131_ = _e3186;
                                                            } else {
                                                                phi_8131_ = _e3202;
                                                            }
                                                            let _e3205 = phi_8131_;
                                                            if (_e3170 < _e3205) {
                                                                phi_8136_ = _e3170;
                                                            } else {
                                                                phi_8136_ = _e3205;
                                                            }
                                                            let _e3208 = phi_8136_;
                                                            let _e3211 = local_1.member[0u];
                                                            let _e3214 = local_1.member_1[0u];
                                                            let _e3217 = local_1.member[0u];
                                                            let _e3223 = local_1.member_2[0u];
                                                            let _e3224 = ((_e3211 + ((_e3214 - _e3217) * _e2337)) - _e3223);
                                                            let _e3227 = local_1.member[1u];
                                                            let _e3230 = local_1.member_1[1u];
                                                            let _e3233 = local_1.member[1u];
                                                            let _e3239 = local_1.member_2[1u];
                                                            let _e3240 = ((_e3227 + ((_e3230 - _e3233) * _e2337)) - _e3239);
                                                            if (_e3224 < _e3240) {
                                                                phi_8209_ = _e3224;
                                                            } else {
                                                                phi_8209_ = _e3240;
                                                            }
                                                            let _e3243 = phi_8209_;
                                                            let _e3246 = local_1.member[2u];
                                                            let _e3249 = local_1.member_1[2u];
                                                            let _e3252 = local_1.member[2u];
                                                            let _e3258 = local_1.member_2[2u];
                                                            let _e3259 = ((_e3246 + ((_e3249 - _e3252) * _e2337)) - _e3258);
                                                            let _e3262 = local_1.member[3u];
                                                            let _e3265 = local_1.member_1[3u];
                                                            let _e3268 = local_1.member[3u];
                                                            let _e3274 = local_1.member_2[3u];
                                                            let _e3275 = ((_e3262 + ((_e3265 - _e3268) * _e2337)) - _e3274);
                                                            if (_e3259 < _e3275) {
                                                                phi_8282_ = _e3259;
                                                            } else {
                                                                phi_8282_ = _e3275;
                                                            }
                                                            let _e3278 = phi_8282_;
                                                            if (_e3243 < _e3278) {
                                                                phi_8287_ = _e3243;
                                                            } else {
                                                                phi_8287_ = _e3278;
                                                            }
                                                            let _e3281 = phi_8287_;
                                                            if (_e3281 > 0f) {
                                                                phi_8305_ = 0.5f;
                                                            } else {
                                                                let _e3285 = (0.95f * (_e3208 / (_e3208 - _e3281)));
                                                                if (_e3285 > 0.0625f) {
                                                                    if (_e3285 < 0.9f) {
                                                                        phi_8303_ = _e3285;
                                                                    } else {
                                                                        phi_8303_ = 0.9f;
                                                                    }
                                                                    let _e3289 = phi_8303_;
                                                                    phi_8304_ = _e3289;
                                                                } else {
                                                                    phi_8304_ = 0.0625f;
                                                                }
                                                                let _e3291 = phi_8304_;
                                                                phi_8305_ = _e3291;
                                                            }
                                                            let _e3293 = phi_8305_;
                                                            phi_8307_ = (_e2638 * _e3293);
                                                            phi_8308_ = true;
                                                        }
                                                        let _e3296 = phi_8307_;
                                                        let _e3298 = phi_8308_;
                                                        phi_8309_ = _e2339;
                                                        phi_8310_ = _e3296;
                                                        phi_8311_ = _e2341;
                                                        phi_8312_ = _e3298;
                                                        phi_8313_ = _e3135;
                                                        phi_8314_ = false;
                                                        phi_8315_ = false;
                                                    } else {
                                                        phi_8309_ = _e3124;
                                                        phi_8310_ = _e3126;
                                                        phi_8311_ = _e2337;
                                                        phi_8312_ = _e3130;
                                                        phi_8313_ = false;
                                                        phi_8314_ = _e3132;
                                                        phi_8315_ = _e3134;
                                                    }
                                                    let _e3300 = phi_8309_;
                                                    let _e3302 = phi_8310_;
                                                    let _e3304 = phi_8311_;
                                                    let _e3306 = phi_8312_;
                                                    let _e3308 = phi_8313_;
                                                    let _e3310 = phi_8314_;
                                                    let _e3312 = phi_8315_;
                                                    if _e3306 {
                                                        let _e3313 = (_e3304 + _e3302);
                                                        if (_e3313 > _e3300) {
                                                            phi_8324_ = _e3313;
                                                        } else {
                                                            phi_8324_ = _e3300;
                                                        }
                                                        let _e3316 = phi_8324_;
                                                        if (_e3316 < _e1391.member_1) {
                                                            phi_8329_ = _e3316;
                                                        } else {
                                                            phi_8329_ = _e1391.member_1;
                                                        }
                                                        let _e3319 = phi_8329_;
                                                        if (_e2355.member_1 > 0u) {
                                                            phi_8339_ = ((_e3319 - _e3304) > 0.0000000037252903f);
                                                        } else {
                                                            phi_8339_ = true;
                                                        }
                                                        let _e3324 = phi_8339_;
                                                        if _e3324 {
                                                            phi_8343_ = false;
                                                        } else {
                                                            phi_8343_ = true;
                                                        }
                                                        let _e3326 = phi_8343_;
                                                        phi_8344_ = _e3319;
                                                        phi_8345_ = _e3324;
                                                        phi_8346_ = _e3326;
                                                        phi_8347_ = false;
                                                        phi_8348_ = false;
                                                        phi_8349_ = false;
                                                    } else {
                                                        phi_8344_ = f32();
                                                        phi_8345_ = false;
                                                        phi_8346_ = false;
                                                        phi_8347_ = _e3308;
                                                        phi_8348_ = _e3310;
                                                        phi_8349_ = _e3312;
                                                    }
                                                    let _e3328 = phi_8344_;
                                                    let _e3330 = phi_8345_;
                                                    let _e3332 = phi_8346_;
                                                    let _e3334 = phi_8347_;
                                                    let _e3336 = phi_8348_;
                                                    let _e3338 = phi_8349_;
                                                    phi_6724_ = _e3328;
                                                    phi_6726_ = _e3300;
                                                    phi_6728_ = _e3304;
                                                    phi_8350_ = _e3300;
                                                    phi_8351_ = _e3330;
                                                    phi_8352_ = _e3332;
                                                    phi_8353_ = false;
                                                    phi_8354_ = _e3334;
                                                    phi_8355_ = _e3336;
                                                    phi_8356_ = _e3338;
                                                } else {
                                                    phi_6724_ = f32();
                                                    phi_6726_ = f32();
                                                    phi_6728_ = f32();
                                                    phi_8350_ = f32();
                                                    phi_8351_ = false;
                                                    phi_8352_ = false;
                                                    phi_8353_ = true;
                                                    phi_8354_ = false;
                                                    phi_8355_ = false;
                                                    phi_8356_ = false;
                                                }
                                                let _e3340 = phi_6724_;
                                                let _e3342 = phi_6726_;
                                                let _e3344 = phi_6728_;
                                                let _e3346 = phi_8350_;
                                                let _e3348 = phi_8351_;
                                                let _e3350 = phi_8352_;
                                                let _e3352 = phi_8353_;
                                                let _e3354 = phi_8354_;
                                                let _e3356 = phi_8355_;
                                                let _e3358 = phi_8356_;
                                                local_19 = _e3350;
                                                local_35 = _e3346;
                                                local_37 = _e3352;
                                                local_38 = _e3354;
                                                local_39 = _e3356;
                                                local_40 = _e3358;
                                                continue;
                                                continuing {
                                                    phi_6720_ = _e2353;
                                                    phi_6723_ = _e3340;
                                                    phi_6725_ = _e3342;
                                                    phi_6727_ = _e3344;
                                                    break if !(_e3348);
                                                }
                                            }
                                            let _e3361 = local_19;
                                            if _e3361 {
                                                let _e5776 = local_35;
                                                phi_8360_ = _e5776;
                                                phi_8361_ = true;
                                                phi_8362_ = false;
                                                phi_8363_ = false;
                                                phi_8364_ = false;
                                            } else {
                                                let _e5778 = local_36;
                                                phi_8360_ = _e5778;
                                                let _e5781 = local_37;
                                                phi_8361_ = _e5781;
                                                let _e5784 = local_38;
                                                phi_8362_ = _e5784;
                                                let _e5787 = local_39;
                                                phi_8363_ = _e5787;
                                                let _e5790 = local_40;
                                                phi_8364_ = _e5790;
                                            }
                                            let _e3363 = phi_8360_;
                                            let _e3365 = phi_8361_;
                                            let _e3367 = phi_8362_;
                                            let _e3369 = phi_8363_;
                                            let _e3371 = phi_8364_;
                                            if _e3365 {
                                                phi_8369_ = type_33(1u, _e3363);
                                                phi_8370_ = false;
                                                phi_8371_ = false;
                                                phi_8372_ = false;
                                            } else {
                                                phi_8369_ = type_33();
                                                phi_8370_ = _e3367;
                                                phi_8371_ = _e3369;
                                                phi_8372_ = _e3371;
                                            }
                                            let _e3374 = phi_8369_;
                                            let _e3376 = phi_8370_;
                                            let _e3378 = phi_8371_;
                                            let _e3380 = phi_8372_;
                                            if _e3376 {
                                                let _e3382 = local_20;
                                                phi_8377_ = type_33(1u, _e3382);
                                                phi_8378_ = false;
                                                phi_8379_ = false;
                                            } else {
                                                phi_8377_ = type_33();
                                                phi_8378_ = _e3378;
                                                phi_8379_ = _e3380;
                                            }
                                            let _e3385 = phi_8377_;
                                            let _e3387 = phi_8378_;
                                            let _e3389 = phi_8379_;
                                            if _e3387 {
                                                phi_8384_ = type_33(0u, type_33().member_1);
                                                phi_8385_ = false;
                                                phi_8386_ = true;
                                            } else {
                                                phi_8384_ = _e3385;
                                                phi_8385_ = _e3389;
                                                phi_8386_ = _e3376;
                                            }
                                            let _e3393 = phi_8384_;
                                            let _e3395 = phi_8385_;
                                            let _e3397 = phi_8386_;
                                            if _e3395 {
                                                phi_8391_ = type_33(0u, type_33().member_1);
                                                phi_8392_ = true;
                                            } else {
                                                phi_8391_ = _e3393;
                                                phi_8392_ = _e3397;
                                            }
                                            let _e3401 = phi_8391_;
                                            let _e3403 = phi_8392_;
                                            if _e3403 {
                                                phi_8396_ = _e3401;
                                            } else {
                                                phi_8396_ = _e3374;
                                            }
                                            let _e3405 = phi_8396_;
                                            let _e3408 = (_e3405.member != 0u);
                                            if _e3408 {
                                                phi_8403_ = false;
                                            } else {
                                                phi_8403_ = true;
                                            }
                                            let _e3410 = phi_8403_;
                                            phi_8404_ = _e3405.member_1;
                                            phi_8405_ = _e3410;
                                            phi_8406_ = _e3408;
                                            phi_8407_ = false;
                                        } else {
                                            phi_8404_ = f32();
                                            phi_8405_ = false;
                                            phi_8406_ = false;
                                            phi_8407_ = true;
                                        }
                                        let _e3412 = phi_8404_;
                                        let _e3414 = phi_8405_;
                                        let _e3416 = phi_8406_;
                                        let _e3418 = phi_8407_;
                                        phi_8408_ = _e3412;
                                        phi_8409_ = _e3414;
                                        phi_8410_ = _e3416;
                                        phi_8411_ = _e3418;
                                    }
                                    let _e3420 = phi_8408_;
                                    let _e3422 = phi_8409_;
                                    let _e3424 = phi_8410_;
                                    let _e3426 = phi_8411_;
                                    phi_8412_ = _e3420;
                                    phi_8413_ = _e2099;
                                    phi_8414_ = _e3422;
                                    phi_8415_ = _e3424;
                                    phi_8416_ = _e3426;
                                }
                                let _e3428 = phi_8412_;
                                let _e3430 = phi_8413_;
                                let _e3432 = phi_8414_;
                                let _e3434 = phi_8415_;
                                let _e3436 = phi_8416_;
                                if _e3430 {
                                    phi_8420_ = true;
                                    phi_8421_ = false;
                                    phi_8422_ = false;
                                } else {
                                    phi_8420_ = _e3432;
                                    phi_8421_ = _e3434;
                                    phi_8422_ = _e3436;
                                }
                                let _e3438 = phi_8420_;
                                let _e3440 = phi_8421_;
                                let _e3442 = phi_8422_;
                                phi_8423_ = _e3428;
                                phi_8424_ = _e1391;
                                phi_8425_ = _e3438;
                                phi_8426_ = false;
                                phi_8427_ = _e3440;
                                phi_8428_ = _e3442;
                            } else {
                                phi_8423_ = f32();
                                phi_8424_ = type_35();
                                phi_8425_ = false;
                                phi_8426_ = true;
                                phi_8427_ = false;
                                phi_8428_ = false;
                            }
                            let _e3444 = phi_8423_;
                            let _e3446 = phi_8424_;
                            let _e3448 = phi_8425_;
                            let _e3450 = phi_8426_;
                            let _e3452 = phi_8427_;
                            let _e3454 = phi_8428_;
                            local_21 = _e3450;
                            local_41 = _e3452;
                            local_42 = _e3454;
                            local_22 = _e3444;
                            local_23 = _e3446;
                            continue;
                            continuing {
                                phi_4857_ = _e1121;
                                break if !(_e3448);
                            }
                        }
                        let _e3457 = local_21;
                        if _e3457 {
                            phi_8433_ = type_33(0u, type_33().member_1);
                            phi_8434_ = false;
                            phi_8435_ = false;
                        } else {
                            phi_8433_ = type_33();
                            let _e5832 = local_41;
                            phi_8434_ = _e5832;
                            let _e5835 = local_42;
                            phi_8435_ = _e5835;
                        }
                        let _e3461 = phi_8433_;
                        let _e3463 = phi_8434_;
                        let _e3465 = phi_8435_;
                        if _e3463 {
                            let _e3467 = local_22;
                            phi_8440_ = type_33(2u, _e3467);
                            phi_8441_ = false;
                        } else {
                            phi_8440_ = type_33();
                            phi_8441_ = _e3465;
                        }
                        let _e3470 = phi_8440_;
                        let _e3472 = phi_8441_;
                        if _e3472 {
                            let _e3474 = local_23;
                            phi_8447_ = type_33(1u, _e3474.member);
                            phi_8448_ = true;
                        } else {
                            phi_8447_ = _e3470;
                            phi_8448_ = _e3463;
                        }
                        let _e3478 = phi_8447_;
                        let _e3480 = phi_8448_;
                        if _e3480 {
                            phi_8452_ = _e3478;
                        } else {
                            phi_8452_ = _e3461;
                        }
                        let _e3482 = phi_8452_;
                        phi_8456_ = _e3482;
                    }
                    let _e5150 = phi_8456_;
                    phi_8457_ = _e5150;
                }
                let _e5154 = phi_8457_;
                switch bitcast<i32>(_e5154.member) {
                    case 0: {
                        phi_8470_ = type_36(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5160 = function_2(_e5154.member_1);
                        phi_8470_ = type_36(0u, _e5160, true);
                        break;
                    }
                    case 2: {
                        let _e5158 = function_2(_e5154.member_1);
                        phi_8470_ = type_36(1u, _e5158, true);
                        break;
                    }
                    default: {
                        phi_8470_ = type_36();
                        break;
                    }
                }
                let _e5163 = phi_8470_;
                if _e5163.member_2 {
                    phi_8477_ = (_e5163.member == 0u);
                } else {
                    phi_8477_ = false;
                }
                let _e5168 = phi_8477_;
                if _e5168 {
                    let _e5176 = (_e5163.member_1[1] >> bitcast<u32>(20i));
                    if (_e5176 <= 896u) {
                        phi_8501_ = 0u;
                    } else {
                        phi_8501_ = ((((_e5176 - 896u) << bitcast<u32>(23i)) | ((_e5163.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5163.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5191 = phi_8501_;
                    let _e5193 = atomicMin((&earliest.member[0u]), _e5191);
                }
                phi_8505_ = type_27(_e172, 0u, _e178, _e181, _e5163.member_1);
                phi_8506_ = _e5168;
                phi_8507_ = (_e5163.member != 0u);
            } else {
                phi_8505_ = type_27(_e172, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8506_ = false;
                phi_8507_ = false;
            }
            let _e5195 = phi_8505_;
            let _e5197 = phi_8506_;
            let _e5199 = phi_8507_;
            let _e5201 = params.member.member_1;
            if ((_e5201 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5197 {
                    let _e5207 = atomicAdd((&counters[0u]), 1u);
                    phi_8525_ = _e5207;
                } else {
                    phi_8525_ = 0u;
                }
                let _e5209 = phi_8525_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5212 = atomicLoad((&counters[0u]));
                    if (_e5212 > 0u) {
                        let _e5215 = atomicAdd((&contacts.member[0u]), _e5212);
                        atomicStore((&counters[1u]), _e5215);
                    }
                }
                workgroupBarrier();
                let _e5218 = atomicLoad((&counters[1u]));
                let _e5219 = (_e5218 + _e5209);
                if _e5197 {
                    let _e5221 = params.member.member_16;
                    if (_e5219 < _e5221) {
                        let _e5223 = (6u * _e5219);
                        atomicStore((&contacts.member[(4u + _e5223)]), _e5195.member);
                        atomicStore((&contacts.member[(_e5223 + 5u)]), _e5195.member_1);
                        atomicStore((&contacts.member[(_e5223 + 6u)]), _e5195.member_2);
                        atomicStore((&contacts.member[(_e5223 + 7u)]), _e5195.member_3);
                        atomicStore((&contacts.member[(_e5223 + 8u)]), _e5195.member_4[0]);
                        atomicStore((&contacts.member[(_e5223 + 9u)]), _e5195.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5199 {
                let _e5247 = atomicAdd((&counters[0u]), 1u);
                phi_8587_ = _e5247;
            } else {
                phi_8587_ = 0u;
            }
            let _e5249 = phi_8587_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5252 = atomicLoad((&counters[0u]));
                if (_e5252 > 0u) {
                    let _e5255 = atomicAdd((&undecided.member[0u]), _e5252);
                    atomicStore((&counters[1u]), _e5255);
                }
            }
            workgroupBarrier();
            let _e5258 = atomicLoad((&counters[1u]));
            let _e5259 = (_e5258 + _e5249);
            if _e5199 {
                atomicStore((&undecided.member[(4u + (2u * _e5259))]), _e5195.member_2);
                atomicStore((&undecided.member[((2u * _e5259) + 5u)]), _e5195.member_3);
            }
        }
        continue;
        continuing {
            phi_801_ = _e160;
            break if !(_e166);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
