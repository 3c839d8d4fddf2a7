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

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
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
    member: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_29 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_31 {
    member: f32,
    member_1: f32,
}

struct type_34 {
    member: type_26,
    member_1: f32,
}

struct type_35 {
    member: u32,
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

struct type_41 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_41;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_41;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_41;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_29;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_684_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_684_ = param_1;
    } else {
        phi_684_ = param;
    }
    let _e26 = phi_684_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_283_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_265_: bool;
    var phi_284_: bool;
    var phi_314_: array<f32, 3>;
    var phi_315_: bool;
    var phi_316_: array<f32, 3>;
    var phi_317_: bool;
    var phi_544_: f32;
    var phi_545_: f32;
    var phi_584_: f32;
    var phi_585_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_411_: f32;
    var phi_412_: f32;
    var phi_454_: f32;
    var phi_455_: f32;
    var phi_503_: f32;
    var phi_504_: f32;
    var phi_646_: array<array<f32, 3>, 4>;
    var phi_654_: array<f32, 3>;

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
                    phi_256_ = (_e76 <= 1f);
                    phi_257_ = false;
                } else {
                    phi_256_ = bool();
                    phi_257_ = true;
                }
                let _e97 = phi_256_;
                let _e99 = phi_257_;
                phi_258_ = _e97;
                phi_259_ = _e99;
            } else {
                phi_258_ = bool();
                phi_259_ = true;
            }
            let _e101 = phi_258_;
            let _e103 = phi_259_;
            phi_260_ = _e101;
            phi_261_ = _e103;
        } else {
            phi_260_ = bool();
            phi_261_ = true;
        }
        let _e105 = phi_260_;
        let _e107 = phi_261_;
        if _e107 {
            phi_265_ = false;
        } else {
            phi_265_ = _e105;
        }
        let _e109 = phi_265_;
        phi_284_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_276_ = ((_e72 + _e76) <= 1f);
                phi_277_ = false;
            } else {
                phi_276_ = bool();
                phi_277_ = true;
            }
            let _e83 = phi_276_;
            let _e85 = phi_277_;
            phi_278_ = _e83;
            phi_279_ = _e85;
        } else {
            phi_278_ = bool();
            phi_279_ = true;
        }
        let _e87 = phi_278_;
        let _e89 = phi_279_;
        if _e89 {
            phi_283_ = false;
        } else {
            phi_283_ = _e87;
        }
        let _e91 = phi_283_;
        phi_284_ = _e91;
    }
    let _e111 = phi_284_;
    if (_e68 > 0f) {
        if _e111 {
            phi_314_ = array<f32, 3>((param_2[0] - ((param_3[0] * _e72) + (param_4[0] * _e76))), (param_2[1] - ((param_3[1] * _e72) + (param_4[1] * _e76))), (param_2[2] - ((param_3[2] * _e72) + (param_4[2] * _e76))));
            phi_315_ = false;
        } else {
            phi_314_ = array<f32, 3>();
            phi_315_ = true;
        }
        let _e136 = phi_314_;
        let _e138 = phi_315_;
        phi_316_ = _e136;
        phi_317_ = _e138;
    } else {
        phi_316_ = array<f32, 3>();
        phi_317_ = true;
    }
    let _e140 = phi_316_;
    let _e142 = phi_317_;
    if _e142 {
        let _e145 = (param_2[0] - param_3[0]);
        let _e148 = (param_2[1] - param_3[1]);
        let _e151 = (param_2[2] - param_3[2]);
        if (param_5 != 0u) {
            let _e293 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_365_ = _e293;
                } else {
                    phi_365_ = 1f;
                }
                let _e297 = phi_365_;
                phi_366_ = _e297;
            } else {
                phi_366_ = 0f;
            }
            let _e299 = phi_366_;
            let _e335 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_411_ = _e335;
                } else {
                    phi_411_ = 1f;
                }
                let _e339 = phi_411_;
                phi_412_ = _e339;
            } else {
                phi_412_ = 0f;
            }
            let _e341 = phi_412_;
            let _e374 = ((((_e145 * param_4[0]) + (_e148 * param_4[1])) + (_e151 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_454_ = _e374;
                } else {
                    phi_454_ = 1f;
                }
                let _e378 = phi_454_;
                phi_455_ = _e378;
            } else {
                phi_455_ = 0f;
            }
            let _e380 = phi_455_;
            let _e393 = (param_2[0] - param_4[0]);
            let _e396 = (param_2[1] - param_4[1]);
            let _e399 = (param_2[2] - param_4[2]);
            let _e419 = ((((_e393 * param_3[0]) + (_e396 * param_3[1])) + (_e399 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_503_ = _e419;
                } else {
                    phi_503_ = 1f;
                }
                let _e423 = phi_503_;
                phi_504_ = _e423;
            } else {
                phi_504_ = 0f;
            }
            let _e425 = phi_504_;
            phi_646_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e299)), (param_2[1] - (param_3[1] * _e299)), (param_2[2] - (param_3[2] * _e299))), array<f32, 3>((param_2[0] - (param_4[0] * _e341)), (param_2[1] - (param_4[1] * _e341)), (param_2[2] - (param_4[2] * _e341))), array<f32, 3>((_e145 - (param_4[0] * _e380)), (_e148 - (param_4[1] * _e380)), (_e151 - (param_4[2] * _e380))), array<f32, 3>((_e393 - (param_3[0] * _e425)), (_e396 - (param_3[1] * _e425)), (_e399 - (param_3[2] * _e425))));
        } else {
            let _e155 = (param_4[0] - param_3[0]);
            let _e158 = (param_4[1] - param_3[1]);
            let _e161 = (param_4[2] - param_3[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_544_ = _e172;
                } else {
                    phi_544_ = 1f;
                }
                let _e176 = phi_544_;
                phi_545_ = _e176;
            } else {
                phi_545_ = 0f;
            }
            let _e178 = phi_545_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_584_ = _e208;
                } else {
                    phi_584_ = 1f;
                }
                let _e212 = phi_584_;
                phi_585_ = _e212;
            } else {
                phi_585_ = 0f;
            }
            let _e214 = phi_585_;
            let _e250 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_630_ = _e250;
                } else {
                    phi_630_ = 1f;
                }
                let _e254 = phi_630_;
                phi_631_ = _e254;
            } else {
                phi_631_ = 0f;
            }
            let _e256 = phi_631_;
            phi_646_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e214)), (param_2[1] - (param_3[1] * _e214)), (param_2[2] - (param_3[2] * _e214))), array<f32, 3>((param_2[0] - (param_4[0] * _e256)), (param_2[1] - (param_4[1] * _e256)), (param_2[2] - (param_4[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_646_;
        let _e441 = function_(_e438[0], _e438[1]);
        let _e443 = function_(_e441, _e438[2]);
        let _e445 = function_(_e443, _e438[3]);
        phi_654_ = _e445;
    } else {
        phi_654_ = _e140;
    }
    let _e447 = phi_654_;
    return _e447;
}

fn function_2(param_6: f32) -> array<u32, 2> {
    var phi_705_: array<u32, 2>;
    var phi_706_: array<u32, 2>;
    var phi_707_: bool;
    var phi_711_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_6);
    if (_e13 < 8388608u) {
        phi_706_ = array<u32, 2>();
        phi_707_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_705_ = array<u32, 2>();
        } else {
            phi_705_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_705_;
        phi_706_ = _e31;
        phi_707_ = _e17;
    }
    let _e33 = phi_706_;
    let _e35 = phi_707_;
    if _e35 {
        phi_711_ = array<u32, 2>(0u, 0u);
    } else {
        phi_711_ = _e33;
    }
    let _e37 = phi_711_;
    return _e37;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: type_27;
    var local_3: type_27;
    var local_4: type_27;
    var local_5: array<type_31, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_30;
    var local_10: type_30;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_764_: u32;
    var phi_780_: u32;
    var phi_801_: u32;
    var phi_802_: u32;
    var phi_805_: type_9;
    var phi_806_: type_9;
    var phi_829_: type_9;
    var phi_993_: f32;
    var phi_999_: f32;
    var phi_1004_: f32;
    var phi_1010_: f32;
    var phi_1015_: f32;
    var phi_1021_: f32;
    var phi_1027_: f32;
    var phi_1032_: f32;
    var phi_1038_: f32;
    var phi_1043_: f32;
    var phi_1048_: f32;
    var phi_1055_: f32;
    var phi_1061_: f32;
    var phi_1066_: f32;
    var phi_1072_: f32;
    var phi_1077_: f32;
    var phi_1083_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1110_: f32;
    var phi_1117_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1145_: f32;
    var phi_1151_: f32;
    var phi_1156_: f32;
    var phi_1162_: f32;
    var phi_1167_: f32;
    var phi_1172_: f32;
    var phi_1178_: f32;
    var phi_1183_: f32;
    var phi_1190_: bool;
    var phi_1214_: u32;
    var phi_1225_: f32;
    var phi_1226_: f32;
    var phi_1257_: type_34;
    var phi_1258_: bool;
    var phi_1259_: type_34;
    var phi_1260_: bool;
    var phi_1261_: type_34;
    var phi_1262_: bool;
    var phi_1267_: type_34;
    var phi_1549_: f32;
    var phi_1556_: f32;
    var phi_1561_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1586_: f32;
    var phi_1593_: f32;
    var phi_1598_: f32;
    var phi_1605_: f32;
    var phi_1610_: f32;
    var phi_1615_: f32;
    var phi_1632_: f32;
    var phi_1639_: f32;
    var phi_1644_: f32;
    var phi_1651_: f32;
    var phi_1656_: f32;
    var phi_1670_: f32;
    var phi_1677_: f32;
    var phi_1682_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1699_: f32;
    var phi_1716_: f32;
    var phi_1723_: f32;
    var phi_1728_: f32;
    var phi_1735_: f32;
    var phi_1740_: f32;
    var phi_1754_: f32;
    var phi_1761_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1814_: f32;
    var phi_1820_: f32;
    var phi_1827_: f32;
    var phi_1834_: f32;
    var phi_1840_: f32;
    var phi_1847_: f32;
    var phi_1853_: f32;
    var phi_1859_: f32;
    var phi_1865_: f32;
    var phi_1872_: f32;
    var phi_1879_: f32;
    var phi_1903_: f32;
    var phi_1908_: f32;
    var phi_1913_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1928_: f32;
    var phi_1938_: f32;
    var phi_4587_: f32;
    var phi_4593_: f32;
    var phi_4598_: f32;
    var phi_4604_: f32;
    var phi_4610_: f32;
    var phi_4615_: f32;
    var phi_4620_: f32;
    var phi_4628_: bool;
    var phi_4633_: f32;
    var phi_4640_: f32;
    var phi_4680_: type_14;
    var phi_4683_: f32;
    var phi_4704_: bool;
    var phi_4710_: type_15;
    var phi_4681_: type_14;
    var phi_4724_: type_15;
    var phi_4684_: f32;
    var local_13: f32;
    var phi_4673_: f32;
    var phi_4737_: f32;
    var phi_4743_: f32;
    var phi_4768_: type_9;
    var phi_4771_: u32;
    var phi_4769_: type_9;
    var phi_4794_: type_9;
    var phi_4838_: u32;
    var phi_4839_: u32;
    var phi_4772_: u32;
    var phi_4840_: u32;
    var phi_4860_: type_9;
    var phi_4861_: type_9;
    var phi_4884_: type_9;
    var phi_4936_: f32;
    var phi_4943_: f32;
    var phi_4954_: bool;
    var phi_4955_: bool;
    var phi_4956_: bool;
    var phi_4957_: bool;
    var phi_4961_: bool;
    var phi_4972_: type_37;
    var phi_4973_: type_37;
    var phi_4974_: bool;
    var phi_4975_: type_37;
    var phi_4976_: bool;
    var phi_4987_: f32;
    var phi_4997_: type_9;
    var phi_5000_: f32;
    var phi_5002_: f32;
    var phi_5004_: f32;
    var phi_4998_: type_9;
    var phi_5027_: type_9;
    var phi_5052_: f32;
    var phi_5053_: f32;
    var phi_5079_: f32;
    var phi_5095_: f32;
    var phi_5102_: bool;
    var phi_5103_: bool;
    var phi_5104_: bool;
    var phi_5110_: f32;
    var phi_5111_: f32;
    var phi_5112_: bool;
    var phi_5001_: f32;
    var phi_5003_: f32;
    var phi_5005_: f32;
    var phi_5113_: f32;
    var phi_5114_: bool;
    var phi_5115_: bool;
    var local_14: bool;
    var phi_5119_: f32;
    var phi_5120_: f32;
    var phi_5128_: f32;
    var phi_5132_: type_9;
    var phi_5135_: f32;
    var phi_5133_: type_9;
    var phi_5158_: type_9;
    var phi_5188_: f32;
    var phi_5189_: bool;
    var phi_5190_: f32;
    var phi_5191_: bool;
    var phi_5192_: bool;
    var phi_5193_: bool;
    var phi_5194_: f32;
    var phi_5136_: f32;
    var phi_5195_: bool;
    var phi_5196_: bool;
    var phi_5197_: bool;
    var phi_5198_: bool;
    var local_15: bool;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5207_: bool;
    var phi_5211_: f32;
    var phi_5212_: f32;
    var phi_5214_: type_37;
    var phi_5243_: f32;
    var phi_5250_: f32;
    var phi_5255_: f32;
    var phi_5262_: f32;
    var phi_5267_: f32;
    var phi_5280_: f32;
    var phi_5287_: f32;
    var phi_5292_: f32;
    var phi_5299_: f32;
    var phi_5304_: f32;
    var phi_5309_: f32;
    var phi_5368_: f32;
    var phi_5374_: f32;
    var phi_5379_: f32;
    var phi_5385_: f32;
    var phi_5390_: f32;
    var phi_5402_: f32;
    var phi_5408_: f32;
    var phi_5413_: f32;
    var phi_5419_: f32;
    var phi_5424_: f32;
    var phi_5450_: f32;
    var phi_5457_: f32;
    var phi_5462_: f32;
    var phi_5469_: f32;
    var phi_5474_: f32;
    var phi_5487_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5506_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5575_: f32;
    var phi_5581_: f32;
    var phi_5586_: f32;
    var phi_5592_: f32;
    var phi_5597_: f32;
    var phi_5609_: f32;
    var phi_5615_: f32;
    var phi_5620_: f32;
    var phi_5626_: f32;
    var phi_5631_: f32;
    var phi_5657_: f32;
    var phi_5664_: f32;
    var phi_5669_: f32;
    var phi_5676_: f32;
    var phi_5681_: f32;
    var phi_5694_: f32;
    var phi_5701_: f32;
    var phi_5706_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
    var phi_5723_: f32;
    var phi_5782_: f32;
    var phi_5788_: f32;
    var phi_5793_: f32;
    var phi_5799_: f32;
    var phi_5804_: f32;
    var phi_5816_: f32;
    var phi_5822_: f32;
    var phi_5827_: f32;
    var phi_5833_: f32;
    var phi_5838_: f32;
    var phi_5887_: f32;
    var phi_5893_: f32;
    var phi_5921_: f32;
    var phi_5927_: f32;
    var phi_5932_: u32;
    var phi_5933_: u32;
    var phi_5903_: f32;
    var phi_5909_: f32;
    var phi_5914_: u32;
    var phi_5915_: u32;
    var phi_5934_: u32;
    var phi_5935_: u32;
    var phi_6004_: f32;
    var phi_6013_: f32;
    var phi_6148_: f32;
    var phi_6154_: f32;
    var phi_6161_: f32;
    var phi_6204_: type_9;
    var phi_6207_: bool;
    var phi_6205_: type_9;
    var phi_6230_: type_9;
    var phi_6257_: bool;
    var phi_6258_: bool;
    var phi_6208_: bool;
    var phi_6259_: bool;
    var phi_6260_: bool;
    var local_16: bool;
    var phi_6264_: bool;
    var local_17: bool;
    var phi_6271_: u32;
    var phi_6272_: u32;
    var phi_6273_: bool;
    var phi_6274_: u32;
    var phi_6275_: u32;
    var phi_6276_: bool;
    var phi_6280_: u32;
    var phi_6300_: bool;
    var phi_6301_: bool;
    var phi_6302_: bool;
    var phi_6450_: f32;
    var phi_6457_: f32;
    var phi_6462_: f32;
    var phi_6469_: f32;
    var phi_6474_: f32;
    var phi_6487_: f32;
    var phi_6494_: f32;
    var phi_6499_: f32;
    var phi_6506_: f32;
    var phi_6511_: f32;
    var phi_6516_: f32;
    var phi_6533_: f32;
    var phi_6540_: f32;
    var phi_6545_: f32;
    var phi_6552_: f32;
    var phi_6557_: f32;
    var phi_6571_: f32;
    var phi_6578_: f32;
    var phi_6583_: f32;
    var phi_6590_: f32;
    var phi_6595_: f32;
    var phi_6600_: f32;
    var phi_6617_: f32;
    var phi_6624_: f32;
    var phi_6629_: f32;
    var phi_6636_: f32;
    var phi_6641_: f32;
    var phi_6655_: f32;
    var phi_6662_: f32;
    var phi_6667_: f32;
    var phi_6674_: f32;
    var phi_6679_: f32;
    var phi_6684_: f32;
    var phi_6723_: type_9;
    var phi_6726_: f32;
    var phi_6728_: f32;
    var phi_6730_: f32;
    var phi_6724_: type_9;
    var phi_6753_: type_9;
    var phi_6865_: f32;
    var phi_6872_: f32;
    var phi_6880_: f32;
    var phi_6924_: type_14;
    var phi_6927_: f32;
    var phi_6948_: bool;
    var phi_6954_: type_15;
    var phi_6925_: type_14;
    var phi_6968_: type_15;
    var phi_6928_: f32;
    var local_18: f32;
    var phi_6917_: f32;
    var phi_6981_: f32;
    var phi_7047_: f32;
    var phi_7053_: f32;
    var phi_7062_: f32;
    var phi_7068_: f32;
    var phi_7077_: f32;
    var phi_7083_: f32;
    var phi_7092_: f32;
    var phi_7098_: f32;
    var phi_7104_: type_30;
    var phi_7105_: bool;
    var phi_7106_: type_30;
    var phi_7107_: bool;
    var phi_7115_: type_30;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7294_: bool;
    var phi_7591_: bool;
    var phi_7592_: bool;
    var phi_7593_: bool;
    var phi_7594_: bool;
    var phi_7595_: bool;
    var phi_7596_: bool;
    var phi_7600_: bool;
    var phi_7604_: bool;
    var phi_7616_: bool;
    var phi_7617_: bool;
    var phi_7691_: bool;
    var phi_7692_: bool;
    var phi_7712_: f32;
    var phi_7713_: bool;
    var phi_7714_: f32;
    var phi_7715_: bool;
    var phi_7716_: f32;
    var phi_7717_: bool;
    var phi_7718_: bool;
    var phi_7722_: f32;
    var phi_7723_: bool;
    var phi_7727_: f32;
    var phi_7759_: bool;
    var phi_7760_: bool;
    var phi_7780_: f32;
    var phi_7781_: bool;
    var phi_7782_: f32;
    var phi_7783_: bool;
    var phi_7784_: f32;
    var phi_7785_: bool;
    var phi_7786_: bool;
    var phi_7790_: f32;
    var phi_7791_: bool;
    var phi_7795_: f32;
    var phi_7800_: f32;
    var phi_7832_: bool;
    var phi_7833_: bool;
    var phi_7853_: f32;
    var phi_7854_: bool;
    var phi_7855_: f32;
    var phi_7856_: bool;
    var phi_7857_: f32;
    var phi_7858_: bool;
    var phi_7859_: bool;
    var phi_7863_: f32;
    var phi_7864_: bool;
    var phi_7868_: f32;
    var phi_7900_: bool;
    var phi_7901_: bool;
    var phi_7921_: f32;
    var phi_7922_: bool;
    var phi_7923_: f32;
    var phi_7924_: bool;
    var phi_7925_: f32;
    var phi_7926_: bool;
    var phi_7927_: bool;
    var phi_7931_: f32;
    var phi_7932_: bool;
    var phi_7936_: f32;
    var phi_7941_: f32;
    var phi_7946_: f32;
    var phi_7951_: f32;
    var phi_7962_: f32;
    var phi_7963_: f32;
    var phi_7964_: bool;
    var phi_7965_: f32;
    var phi_7966_: f32;
    var phi_7967_: bool;
    var phi_7968_: bool;
    var phi_7969_: bool;
    var phi_7970_: f32;
    var phi_7971_: f32;
    var phi_7972_: bool;
    var phi_7973_: bool;
    var phi_7974_: bool;
    var phi_7975_: bool;
    var phi_7976_: f32;
    var phi_7977_: f32;
    var phi_7978_: bool;
    var phi_7979_: bool;
    var phi_7980_: bool;
    var phi_7981_: bool;
    var phi_8061_: f32;
    var phi_8134_: f32;
    var phi_8139_: f32;
    var phi_8212_: f32;
    var phi_8285_: f32;
    var phi_8290_: f32;
    var phi_8306_: f32;
    var phi_8307_: f32;
    var phi_8308_: f32;
    var phi_8310_: f32;
    var phi_8311_: bool;
    var phi_8312_: f32;
    var phi_8313_: f32;
    var phi_8314_: f32;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var phi_8317_: bool;
    var phi_8318_: bool;
    var phi_8327_: f32;
    var phi_8332_: f32;
    var phi_8342_: bool;
    var phi_8346_: bool;
    var phi_8347_: f32;
    var phi_8348_: bool;
    var phi_8349_: bool;
    var phi_8350_: bool;
    var phi_8351_: bool;
    var phi_8352_: bool;
    var phi_6727_: f32;
    var phi_6729_: f32;
    var phi_6731_: f32;
    var phi_8353_: f32;
    var phi_8354_: bool;
    var phi_8355_: bool;
    var phi_8356_: bool;
    var phi_8357_: bool;
    var phi_8358_: bool;
    var phi_8359_: bool;
    var local_19: bool;
    var phi_8363_: f32;
    var phi_8364_: bool;
    var phi_8365_: bool;
    var phi_8366_: bool;
    var phi_8367_: bool;
    var phi_8372_: type_35;
    var phi_8373_: bool;
    var phi_8374_: bool;
    var phi_8375_: bool;
    var local_20: f32;
    var phi_8380_: type_35;
    var phi_8381_: bool;
    var phi_8382_: bool;
    var phi_8387_: type_35;
    var phi_8388_: bool;
    var phi_8389_: bool;
    var phi_8394_: type_35;
    var phi_8395_: bool;
    var phi_8399_: type_35;
    var phi_8406_: bool;
    var phi_8407_: f32;
    var phi_8408_: bool;
    var phi_8409_: bool;
    var phi_8410_: bool;
    var phi_8411_: f32;
    var phi_8412_: bool;
    var phi_8413_: bool;
    var phi_8414_: bool;
    var phi_8415_: f32;
    var phi_8416_: bool;
    var phi_8417_: bool;
    var phi_8418_: bool;
    var phi_8419_: bool;
    var phi_8423_: bool;
    var phi_8424_: bool;
    var phi_8425_: bool;
    var phi_8426_: f32;
    var phi_8427_: type_37;
    var phi_8428_: bool;
    var phi_8429_: bool;
    var phi_8430_: bool;
    var phi_8431_: bool;
    var local_21: bool;
    var phi_8436_: type_35;
    var phi_8437_: bool;
    var phi_8438_: bool;
    var local_22: f32;
    var phi_8443_: type_35;
    var phi_8444_: bool;
    var local_23: type_37;
    var phi_8450_: type_35;
    var phi_8451_: bool;
    var phi_8455_: type_35;
    var phi_2091_: f32;
    var phi_2098_: f32;
    var phi_2103_: f32;
    var phi_2110_: f32;
    var phi_2115_: f32;
    var phi_2128_: f32;
    var phi_2135_: f32;
    var phi_2140_: f32;
    var phi_2147_: f32;
    var phi_2152_: f32;
    var phi_2157_: f32;
    var phi_2174_: f32;
    var phi_2181_: f32;
    var phi_2186_: f32;
    var phi_2193_: f32;
    var phi_2198_: f32;
    var phi_2212_: f32;
    var phi_2219_: f32;
    var phi_2224_: f32;
    var phi_2231_: f32;
    var phi_2236_: f32;
    var phi_2241_: f32;
    var phi_2258_: f32;
    var phi_2265_: f32;
    var phi_2270_: f32;
    var phi_2277_: f32;
    var phi_2282_: f32;
    var phi_2296_: f32;
    var phi_2303_: f32;
    var phi_2308_: f32;
    var phi_2315_: f32;
    var phi_2320_: f32;
    var phi_2325_: f32;
    var phi_2364_: type_9;
    var phi_2367_: f32;
    var phi_2369_: f32;
    var phi_2371_: f32;
    var phi_2365_: type_9;
    var phi_2394_: type_9;
    var phi_2506_: f32;
    var phi_2513_: f32;
    var phi_2521_: f32;
    var phi_2565_: type_14;
    var phi_2568_: f32;
    var phi_2589_: bool;
    var phi_2595_: type_15;
    var phi_2566_: type_14;
    var phi_2609_: type_15;
    var phi_2569_: f32;
    var local_24: f32;
    var phi_2558_: f32;
    var phi_2622_: f32;
    var phi_2688_: f32;
    var phi_2694_: f32;
    var phi_2703_: f32;
    var phi_2709_: f32;
    var phi_2718_: f32;
    var phi_2724_: f32;
    var phi_2733_: f32;
    var phi_2739_: f32;
    var phi_2745_: type_30;
    var phi_2746_: bool;
    var phi_2747_: type_30;
    var phi_2748_: bool;
    var phi_2756_: type_30;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2935_: bool;
    var phi_3232_: bool;
    var phi_3233_: bool;
    var phi_3234_: bool;
    var phi_3235_: bool;
    var phi_3236_: bool;
    var phi_3237_: bool;
    var phi_3241_: bool;
    var phi_3245_: bool;
    var phi_3257_: bool;
    var phi_3258_: bool;
    var phi_3332_: bool;
    var phi_3333_: bool;
    var phi_3353_: f32;
    var phi_3354_: bool;
    var phi_3355_: f32;
    var phi_3356_: bool;
    var phi_3357_: f32;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3363_: f32;
    var phi_3364_: bool;
    var phi_3368_: f32;
    var phi_3400_: bool;
    var phi_3401_: bool;
    var phi_3421_: f32;
    var phi_3422_: bool;
    var phi_3423_: f32;
    var phi_3424_: bool;
    var phi_3425_: f32;
    var phi_3426_: bool;
    var phi_3427_: bool;
    var phi_3431_: f32;
    var phi_3432_: bool;
    var phi_3436_: f32;
    var phi_3441_: f32;
    var phi_3473_: bool;
    var phi_3474_: bool;
    var phi_3494_: f32;
    var phi_3495_: bool;
    var phi_3496_: f32;
    var phi_3497_: bool;
    var phi_3498_: f32;
    var phi_3499_: bool;
    var phi_3500_: bool;
    var phi_3504_: f32;
    var phi_3505_: bool;
    var phi_3509_: f32;
    var phi_3541_: bool;
    var phi_3542_: bool;
    var phi_3562_: f32;
    var phi_3563_: bool;
    var phi_3564_: f32;
    var phi_3565_: bool;
    var phi_3566_: f32;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3572_: f32;
    var phi_3573_: bool;
    var phi_3577_: f32;
    var phi_3582_: f32;
    var phi_3587_: f32;
    var phi_3592_: f32;
    var phi_3603_: f32;
    var phi_3604_: f32;
    var phi_3605_: bool;
    var phi_3606_: f32;
    var phi_3607_: f32;
    var phi_3608_: bool;
    var phi_3609_: bool;
    var phi_3610_: bool;
    var phi_3611_: f32;
    var phi_3612_: f32;
    var phi_3613_: bool;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3616_: bool;
    var phi_3617_: f32;
    var phi_3618_: f32;
    var phi_3619_: bool;
    var phi_3620_: bool;
    var phi_3621_: bool;
    var phi_3622_: bool;
    var phi_3702_: f32;
    var phi_3775_: f32;
    var phi_3780_: f32;
    var phi_3853_: f32;
    var phi_3926_: f32;
    var phi_3931_: f32;
    var phi_3947_: f32;
    var phi_3948_: f32;
    var phi_3949_: f32;
    var phi_3951_: f32;
    var phi_3952_: bool;
    var phi_3953_: f32;
    var phi_3954_: f32;
    var phi_3955_: f32;
    var phi_3956_: bool;
    var phi_3957_: bool;
    var phi_3958_: bool;
    var phi_3959_: bool;
    var phi_3968_: f32;
    var phi_3973_: f32;
    var phi_3983_: bool;
    var phi_3987_: bool;
    var phi_3988_: f32;
    var phi_3989_: bool;
    var phi_3990_: bool;
    var phi_3991_: bool;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_2368_: f32;
    var phi_2370_: f32;
    var phi_2372_: f32;
    var phi_3994_: f32;
    var phi_3995_: bool;
    var phi_3996_: bool;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var local_25: bool;
    var phi_4004_: f32;
    var phi_4005_: bool;
    var phi_4006_: bool;
    var phi_4007_: bool;
    var phi_4008_: bool;
    var phi_4013_: type_35;
    var phi_4014_: bool;
    var phi_4015_: bool;
    var phi_4016_: bool;
    var local_26: f32;
    var phi_4021_: type_35;
    var phi_4022_: bool;
    var phi_4023_: bool;
    var phi_4028_: type_35;
    var phi_4029_: bool;
    var phi_4030_: bool;
    var phi_4035_: type_35;
    var phi_4036_: bool;
    var phi_4040_: type_35;
    var phi_4054_: type_9;
    var phi_4055_: type_9;
    var phi_4078_: type_9;
    var phi_4098_: f32;
    var phi_4228_: type_14;
    var phi_4231_: f32;
    var phi_4252_: bool;
    var phi_4258_: type_15;
    var phi_4229_: type_14;
    var phi_4272_: type_15;
    var phi_4232_: f32;
    var local_27: f32;
    var phi_4221_: f32;
    var phi_4285_: f32;
    var phi_4301_: f32;
    var phi_4308_: f32;
    var phi_4313_: f32;
    var phi_4320_: f32;
    var phi_4325_: f32;
    var phi_4338_: f32;
    var phi_4345_: f32;
    var phi_4350_: f32;
    var phi_4357_: f32;
    var phi_4362_: f32;
    var phi_4367_: f32;
    var phi_4384_: f32;
    var phi_4391_: f32;
    var phi_4396_: f32;
    var phi_4403_: f32;
    var phi_4408_: f32;
    var phi_4422_: f32;
    var phi_4429_: f32;
    var phi_4434_: f32;
    var phi_4441_: f32;
    var phi_4446_: f32;
    var phi_4451_: f32;
    var phi_4468_: f32;
    var phi_4475_: f32;
    var phi_4480_: f32;
    var phi_4487_: f32;
    var phi_4492_: f32;
    var phi_4506_: f32;
    var phi_4513_: f32;
    var phi_4518_: f32;
    var phi_4525_: f32;
    var phi_4530_: f32;
    var phi_4535_: f32;
    var phi_4555_: bool;
    var phi_4556_: bool;
    var phi_4557_: bool;
    var local_28: bool;
    var phi_4562_: type_35;
    var phi_4563_: bool;
    var phi_4568_: type_35;
    var phi_4569_: bool;
    var phi_4571_: type_35;
    var phi_4572_: type_35;
    var phi_4573_: bool;
    var phi_4577_: type_35;
    var phi_8459_: type_35;
    var phi_8460_: type_35;
    var phi_8473_: type_38;
    var phi_8480_: bool;
    var phi_8504_: u32;
    var phi_8508_: type_20;
    var phi_8509_: bool;
    var phi_8510_: bool;
    var phi_8529_: u32;
    var phi_8592_: u32;
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
    let _e123 = params.member.member_1.member_2;
    let _e125 = input.member[0u];
    if (_e123 < _e125) {
        phi_764_ = _e123;
    } else {
        phi_764_ = _e125;
    }
    let _e128 = phi_764_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_780_ = (_e129 + 1u);
    } else {
        phi_780_ = _e129;
    }
    let _e134 = phi_780_;
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
            phi_801_ = (_e138 + 1u);
        } else {
            phi_801_ = _e138;
        }
        let _e144 = phi_801_;
        phi_802_ = _e144;
    } else {
        phi_802_ = 0u;
    }
    let _e146 = phi_802_;
    phi_805_ = type_9(0u, _e146);
    loop {
        let _e149 = phi_805_;
        if (_e149.member < _e149.member_1) {
            phi_806_ = type_9((_e149.member + 1u), _e149.member_1);
            phi_829_ = type_9(1u, _e149.member);
        } else {
            phi_806_ = _e149;
            phi_829_ = type_9(0u, type_9().member_1);
        }
        let _e161 = phi_806_;
        let _e163 = phi_829_;
        let _e167 = (bitcast<i32>(_e163.member) != 0i);
        if _e167 {
            let _e171 = (((_e117 + (_e163.member_1 * _e120)) * 64u) + _e105);
            if (_e171 < _e128) {
                let _e173 = (2u * _e171);
                let _e176 = input.member[(4u + _e173)];
                let _e179 = input.member[(_e173 + 5u)];
                let _e182 = elements.member[_e179];
                let _e187 = paths.member[_e176];
                let _e189 = paths.member[_e182[0]];
                let _e195 = paths.member[_e182[1]];
                let _e197 = paths.member[_e182[2]];
                let _e227 = params.member.member.member_4;
                let _e228 = (_e187.member[0] - _e189.member[0]);
                let _e229 = (_e187.member[1] - _e189.member[1]);
                let _e230 = (_e187.member[2] - _e189.member[2]);
                let _e232 = (_e187.member_1[0] - _e189.member_1[0]);
                let _e233 = (_e187.member_1[1] - _e189.member_1[1]);
                let _e234 = (_e187.member_1[2] - _e189.member_1[2]);
                let _e237 = (_e195.member[0] - _e189.member[0]);
                let _e238 = (_e195.member[1] - _e189.member[1]);
                let _e239 = (_e195.member[2] - _e189.member[2]);
                let _e241 = (_e195.member_1[0] - _e189.member_1[0]);
                let _e242 = (_e195.member_1[1] - _e189.member_1[1]);
                let _e243 = (_e195.member_1[2] - _e189.member_1[2]);
                let _e246 = (_e197.member[0] - _e189.member[0]);
                let _e247 = (_e197.member[1] - _e189.member[1]);
                let _e248 = (_e197.member[2] - _e189.member[2]);
                let _e250 = (_e197.member_1[0] - _e189.member_1[0]);
                let _e251 = (_e197.member_1[1] - _e189.member_1[1]);
                let _e252 = (_e197.member_1[2] - _e189.member_1[2]);
                let _e255 = (_e227 + _e227);
                let _e258 = params.member.member.member_5;
                if (_e228 < 0f) {
                    phi_993_ = -(_e228);
                } else {
                    phi_993_ = _e228;
                }
                let _e262 = phi_993_;
                if (_e229 < 0f) {
                    phi_999_ = -(_e229);
                } else {
                    phi_999_ = _e229;
                }
                let _e266 = phi_999_;
                if (_e262 > _e266) {
                    phi_1004_ = _e262;
                } else {
                    phi_1004_ = _e266;
                }
                let _e269 = phi_1004_;
                if (_e230 < 0f) {
                    phi_1010_ = -(_e230);
                } else {
                    phi_1010_ = _e230;
                }
                let _e273 = phi_1010_;
                if (_e269 > _e273) {
                    phi_1015_ = _e269;
                } else {
                    phi_1015_ = _e273;
                }
                let _e276 = phi_1015_;
                if (_e232 < 0f) {
                    phi_1021_ = -(_e232);
                } else {
                    phi_1021_ = _e232;
                }
                let _e280 = phi_1021_;
                if (_e233 < 0f) {
                    phi_1027_ = -(_e233);
                } else {
                    phi_1027_ = _e233;
                }
                let _e284 = phi_1027_;
                if (_e280 > _e284) {
                    phi_1032_ = _e280;
                } else {
                    phi_1032_ = _e284;
                }
                let _e287 = phi_1032_;
                if (_e234 < 0f) {
                    phi_1038_ = -(_e234);
                } else {
                    phi_1038_ = _e234;
                }
                let _e291 = phi_1038_;
                if (_e287 > _e291) {
                    phi_1043_ = _e287;
                } else {
                    phi_1043_ = _e291;
                }
                let _e294 = phi_1043_;
                if (_e276 > _e294) {
                    phi_1048_ = _e276;
                } else {
                    phi_1048_ = _e294;
                }
                let _e297 = phi_1048_;
                let _e298 = (_e297 + _e255);
                if (_e237 < 0f) {
                    phi_1055_ = -(_e237);
                } else {
                    phi_1055_ = _e237;
                }
                let _e302 = phi_1055_;
                if (_e238 < 0f) {
                    phi_1061_ = -(_e238);
                } else {
                    phi_1061_ = _e238;
                }
                let _e306 = phi_1061_;
                if (_e302 > _e306) {
                    phi_1066_ = _e302;
                } else {
                    phi_1066_ = _e306;
                }
                let _e309 = phi_1066_;
                if (_e239 < 0f) {
                    phi_1072_ = -(_e239);
                } else {
                    phi_1072_ = _e239;
                }
                let _e313 = phi_1072_;
                if (_e309 > _e313) {
                    phi_1077_ = _e309;
                } else {
                    phi_1077_ = _e313;
                }
                let _e316 = phi_1077_;
                if (_e241 < 0f) {
                    phi_1083_ = -(_e241);
                } else {
                    phi_1083_ = _e241;
                }
                let _e320 = phi_1083_;
                if (_e242 < 0f) {
                    phi_1089_ = -(_e242);
                } else {
                    phi_1089_ = _e242;
                }
                let _e324 = phi_1089_;
                if (_e320 > _e324) {
                    phi_1094_ = _e320;
                } else {
                    phi_1094_ = _e324;
                }
                let _e327 = phi_1094_;
                if (_e243 < 0f) {
                    phi_1100_ = -(_e243);
                } else {
                    phi_1100_ = _e243;
                }
                let _e331 = phi_1100_;
                if (_e327 > _e331) {
                    phi_1105_ = _e327;
                } else {
                    phi_1105_ = _e331;
                }
                let _e334 = phi_1105_;
                if (_e316 > _e334) {
                    phi_1110_ = _e316;
                } else {
                    phi_1110_ = _e334;
                }
                let _e337 = phi_1110_;
                let _e338 = (_e337 + _e255);
                if (_e246 < 0f) {
                    phi_1117_ = -(_e246);
                } else {
                    phi_1117_ = _e246;
                }
                let _e342 = phi_1117_;
                if (_e247 < 0f) {
                    phi_1123_ = -(_e247);
                } else {
                    phi_1123_ = _e247;
                }
                let _e346 = phi_1123_;
                if (_e342 > _e346) {
                    phi_1128_ = _e342;
                } else {
                    phi_1128_ = _e346;
                }
                let _e349 = phi_1128_;
                if (_e248 < 0f) {
                    phi_1134_ = -(_e248);
                } else {
                    phi_1134_ = _e248;
                }
                let _e353 = phi_1134_;
                if (_e349 > _e353) {
                    phi_1139_ = _e349;
                } else {
                    phi_1139_ = _e353;
                }
                let _e356 = phi_1139_;
                if (_e250 < 0f) {
                    phi_1145_ = -(_e250);
                } else {
                    phi_1145_ = _e250;
                }
                let _e360 = phi_1145_;
                if (_e251 < 0f) {
                    phi_1151_ = -(_e251);
                } else {
                    phi_1151_ = _e251;
                }
                let _e364 = phi_1151_;
                if (_e360 > _e364) {
                    phi_1156_ = _e360;
                } else {
                    phi_1156_ = _e364;
                }
                let _e367 = phi_1156_;
                if (_e252 < 0f) {
                    phi_1162_ = -(_e252);
                } else {
                    phi_1162_ = _e252;
                }
                let _e371 = phi_1162_;
                if (_e367 > _e371) {
                    phi_1167_ = _e367;
                } else {
                    phi_1167_ = _e371;
                }
                let _e374 = phi_1167_;
                if (_e356 > _e374) {
                    phi_1172_ = _e356;
                } else {
                    phi_1172_ = _e374;
                }
                let _e377 = phi_1172_;
                let _e378 = (_e377 + _e255);
                if (_e298 > _e338) {
                    phi_1178_ = _e298;
                } else {
                    phi_1178_ = _e338;
                }
                let _e381 = phi_1178_;
                if (_e381 > _e378) {
                    phi_1183_ = _e381;
                } else {
                    phi_1183_ = _e378;
                }
                let _e384 = phi_1183_;
                if (_e384 <= 65536f) {
                    phi_1190_ = (_e384 >= (1f / 65536f));
                } else {
                    phi_1190_ = false;
                }
                let _e389 = phi_1190_;
                if _e389 {
                    phi_1261_ = type_34();
                    phi_1262_ = true;
                } else {
                    if (_e384 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e384) & 2139095040u) != 2139095040u) {
                            let _e396 = (2130706432u - (bitcast<u32>(_e384) & 2139095040u));
                            if (_e396 > 8388608u) {
                                phi_1214_ = _e396;
                            } else {
                                phi_1214_ = 8388608u;
                            }
                            let _e399 = phi_1214_;
                            let _e400 = bitcast<f32>(_e399);
                            let _e401 = (_e258 * _e400);
                            if (_e258 > 0f) {
                                if (_e401 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1225_ = _e401;
                                } else {
                                    phi_1225_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e405 = phi_1225_;
                                phi_1226_ = _e405;
                            } else {
                                phi_1226_ = _e401;
                            }
                            let _e407 = phi_1226_;
                            phi_1257_ = type_34(type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e228 * _e400), (_e229 * _e400), (_e230 * _e400)), array<f32, 3>((_e232 * _e400), (_e233 * _e400), (_e234 * _e400))), array<array<f32, 3>, 2>(array<f32, 3>((_e237 * _e400), (_e238 * _e400), (_e239 * _e400)), array<f32, 3>((_e241 * _e400), (_e242 * _e400), (_e243 * _e400))), array<array<f32, 3>, 2>(array<f32, 3>((_e246 * _e400), (_e247 * _e400), (_e248 * _e400)), array<f32, 3>((_e250 * _e400), (_e251 * _e400), (_e252 * _e400))), (_e255 * _e400)), _e407);
                            phi_1258_ = false;
                        } else {
                            phi_1257_ = type_34();
                            phi_1258_ = true;
                        }
                        let _e439 = phi_1257_;
                        let _e441 = phi_1258_;
                        phi_1259_ = _e439;
                        phi_1260_ = _e441;
                    } else {
                        phi_1259_ = type_34();
                        phi_1260_ = true;
                    }
                    let _e443 = phi_1259_;
                    let _e445 = phi_1260_;
                    phi_1261_ = _e443;
                    phi_1262_ = _e445;
                }
                let _e447 = phi_1261_;
                let _e449 = phi_1262_;
                if _e449 {
                    phi_1267_ = type_34(type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e228, _e229, _e230), array<f32, 3>(_e232, _e233, _e234)), array<array<f32, 3>, 2>(array<f32, 3>(_e237, _e238, _e239), array<f32, 3>(_e241, _e242, _e243)), array<array<f32, 3>, 2>(array<f32, 3>(_e246, _e247, _e248), array<f32, 3>(_e250, _e251, _e252)), _e255), _e258);
                } else {
                    phi_1267_ = _e447;
                }
                let _e452 = phi_1267_;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member[0][0], _e452.member.member[0][1], _e452.member.member[0][2]), array<f32, 3>(_e452.member.member[1][0], _e452.member.member[1][1], _e452.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member_1[0][0], _e452.member.member_1[0][1], _e452.member.member_1[0][2]), array<f32, 3>(_e452.member.member_1[1][0], _e452.member.member_1[1][1], _e452.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member_2[0][0], _e452.member.member_2[0][1], _e452.member.member_2[0][2]), array<f32, 3>(_e452.member.member_2[1][0], _e452.member.member_2[1][1], _e452.member.member_2[1][2])), _e452.member.member_3);
                let _e495 = local_12.member_1[0u];
                let _e501 = local_12.member_2[0u];
                let _e507 = ((_e495[1] * _e501[2]) - (_e495[2] * _e501[1]));
                let _e510 = ((_e495[2] * _e501[0]) - (_e495[0] * _e501[2]));
                let _e513 = ((_e495[0] * _e501[1]) - (_e495[1] * _e501[0]));
                let _e516 = local_12.member_1[1u];
                let _e522 = local_12.member_2[1u];
                let _e528 = ((_e516[1] * _e522[2]) - (_e516[2] * _e522[1]));
                let _e531 = ((_e516[2] * _e522[0]) - (_e516[0] * _e522[2]));
                let _e534 = ((_e516[0] * _e522[1]) - (_e516[1] * _e522[0]));
                let _e537 = local_12.member_1[0u];
                let _e543 = local_12.member_2[1u];
                let _e558 = local_12.member_1[1u];
                let _e564 = local_12.member_2[0u];
                let _e577 = (((_e537[1] * _e543[2]) - (_e537[2] * _e543[1])) + ((_e558[1] * _e564[2]) - (_e558[2] * _e564[1])));
                let _e578 = (((_e537[2] * _e543[0]) - (_e537[0] * _e543[2])) + ((_e558[2] * _e564[0]) - (_e558[0] * _e564[2])));
                let _e579 = (((_e537[0] * _e543[1]) - (_e537[1] * _e543[0])) + ((_e558[0] * _e564[1]) - (_e558[1] * _e564[0])));
                let _e582 = local_12.member[0u];
                let _e590 = (((_e582[0] * _e507) + (_e582[1] * _e510)) + (_e582[2] * _e513));
                let _e593 = local_12.member[1u];
                let _e604 = local_12.member[0u];
                let _e613 = ((((_e593[0] * _e507) + (_e593[1] * _e510)) + (_e593[2] * _e513)) + (((_e604[0] * _e577) + (_e604[1] * _e578)) + (_e604[2] * _e579)));
                let _e616 = local_12.member[0u];
                let _e627 = local_12.member[1u];
                let _e636 = ((((_e616[0] * _e528) + (_e616[1] * _e531)) + (_e616[2] * _e534)) + (((_e627[0] * _e577) + (_e627[1] * _e578)) + (_e627[2] * _e579)));
                let _e639 = local_12.member[1u];
                let _e647 = (((_e639[0] * _e528) + (_e639[1] * _e531)) + (_e639[2] * _e534));
                let _e650 = local_12.member[0u];
                if (_e650[0] < 0f) {
                    phi_1549_ = -(_e650[0]);
                } else {
                    phi_1549_ = _e650[0];
                }
                let _e657 = phi_1549_;
                if (_e650[1] < 0f) {
                    phi_1556_ = -(_e650[1]);
                } else {
                    phi_1556_ = _e650[1];
                }
                let _e661 = phi_1556_;
                if (_e657 > _e661) {
                    phi_1561_ = _e657;
                } else {
                    phi_1561_ = _e661;
                }
                let _e664 = phi_1561_;
                if (_e650[2] < 0f) {
                    phi_1568_ = -(_e650[2]);
                } else {
                    phi_1568_ = _e650[2];
                }
                let _e668 = phi_1568_;
                if (_e664 > _e668) {
                    phi_1573_ = _e664;
                } else {
                    phi_1573_ = _e668;
                }
                let _e671 = phi_1573_;
                let _e674 = local_12.member[1u];
                if (_e674[0] < 0f) {
                    phi_1586_ = -(_e674[0]);
                } else {
                    phi_1586_ = _e674[0];
                }
                let _e681 = phi_1586_;
                if (_e674[1] < 0f) {
                    phi_1593_ = -(_e674[1]);
                } else {
                    phi_1593_ = _e674[1];
                }
                let _e685 = phi_1593_;
                if (_e681 > _e685) {
                    phi_1598_ = _e681;
                } else {
                    phi_1598_ = _e685;
                }
                let _e688 = phi_1598_;
                if (_e674[2] < 0f) {
                    phi_1605_ = -(_e674[2]);
                } else {
                    phi_1605_ = _e674[2];
                }
                let _e692 = phi_1605_;
                if (_e688 > _e692) {
                    phi_1610_ = _e688;
                } else {
                    phi_1610_ = _e692;
                }
                let _e695 = phi_1610_;
                if (_e671 > _e695) {
                    phi_1615_ = _e671;
                } else {
                    phi_1615_ = _e695;
                }
                let _e698 = phi_1615_;
                let _e700 = local_12.member_3;
                let _e701 = (_e698 + _e700);
                let _e704 = local_12.member_1[0u];
                if (_e704[0] < 0f) {
                    phi_1632_ = -(_e704[0]);
                } else {
                    phi_1632_ = _e704[0];
                }
                let _e711 = phi_1632_;
                if (_e704[1] < 0f) {
                    phi_1639_ = -(_e704[1]);
                } else {
                    phi_1639_ = _e704[1];
                }
                let _e715 = phi_1639_;
                if (_e711 > _e715) {
                    phi_1644_ = _e711;
                } else {
                    phi_1644_ = _e715;
                }
                let _e718 = phi_1644_;
                if (_e704[2] < 0f) {
                    phi_1651_ = -(_e704[2]);
                } else {
                    phi_1651_ = _e704[2];
                }
                let _e722 = phi_1651_;
                if (_e718 > _e722) {
                    phi_1656_ = _e718;
                } else {
                    phi_1656_ = _e722;
                }
                let _e725 = phi_1656_;
                let _e728 = local_12.member_1[1u];
                if (_e728[0] < 0f) {
                    phi_1670_ = -(_e728[0]);
                } else {
                    phi_1670_ = _e728[0];
                }
                let _e735 = phi_1670_;
                if (_e728[1] < 0f) {
                    phi_1677_ = -(_e728[1]);
                } else {
                    phi_1677_ = _e728[1];
                }
                let _e739 = phi_1677_;
                if (_e735 > _e739) {
                    phi_1682_ = _e735;
                } else {
                    phi_1682_ = _e739;
                }
                let _e742 = phi_1682_;
                if (_e728[2] < 0f) {
                    phi_1689_ = -(_e728[2]);
                } else {
                    phi_1689_ = _e728[2];
                }
                let _e746 = phi_1689_;
                if (_e742 > _e746) {
                    phi_1694_ = _e742;
                } else {
                    phi_1694_ = _e746;
                }
                let _e749 = phi_1694_;
                if (_e725 > _e749) {
                    phi_1699_ = _e725;
                } else {
                    phi_1699_ = _e749;
                }
                let _e752 = phi_1699_;
                let _e754 = local_12.member_3;
                let _e755 = (_e752 + _e754);
                let _e758 = local_12.member_2[0u];
                if (_e758[0] < 0f) {
                    phi_1716_ = -(_e758[0]);
                } else {
                    phi_1716_ = _e758[0];
                }
                let _e765 = phi_1716_;
                if (_e758[1] < 0f) {
                    phi_1723_ = -(_e758[1]);
                } else {
                    phi_1723_ = _e758[1];
                }
                let _e769 = phi_1723_;
                if (_e765 > _e769) {
                    phi_1728_ = _e765;
                } else {
                    phi_1728_ = _e769;
                }
                let _e772 = phi_1728_;
                if (_e758[2] < 0f) {
                    phi_1735_ = -(_e758[2]);
                } else {
                    phi_1735_ = _e758[2];
                }
                let _e776 = phi_1735_;
                if (_e772 > _e776) {
                    phi_1740_ = _e772;
                } else {
                    phi_1740_ = _e776;
                }
                let _e779 = phi_1740_;
                let _e782 = local_12.member_2[1u];
                if (_e782[0] < 0f) {
                    phi_1754_ = -(_e782[0]);
                } else {
                    phi_1754_ = _e782[0];
                }
                let _e789 = phi_1754_;
                if (_e782[1] < 0f) {
                    phi_1761_ = -(_e782[1]);
                } else {
                    phi_1761_ = _e782[1];
                }
                let _e793 = phi_1761_;
                if (_e789 > _e793) {
                    phi_1766_ = _e789;
                } else {
                    phi_1766_ = _e793;
                }
                let _e796 = phi_1766_;
                if (_e782[2] < 0f) {
                    phi_1773_ = -(_e782[2]);
                } else {
                    phi_1773_ = _e782[2];
                }
                let _e800 = phi_1773_;
                if (_e796 > _e800) {
                    phi_1778_ = _e796;
                } else {
                    phi_1778_ = _e800;
                }
                let _e803 = phi_1778_;
                if (_e779 > _e803) {
                    phi_1783_ = _e779;
                } else {
                    phi_1783_ = _e803;
                }
                let _e806 = phi_1783_;
                let _e808 = local_12.member_3;
                let _e809 = (_e806 + _e808);
                let _e811 = ((_e755 * 8f) * _e809);
                let _e818 = local_12.member_3;
                if (_e507 < 0f) {
                    phi_1814_ = -(_e507);
                } else {
                    phi_1814_ = _e507;
                }
                let _e835 = phi_1814_;
                if (_e510 < 0f) {
                    phi_1820_ = -(_e510);
                } else {
                    phi_1820_ = _e510;
                }
                let _e839 = phi_1820_;
                if (_e513 < 0f) {
                    phi_1827_ = -(_e513);
                } else {
                    phi_1827_ = _e513;
                }
                let _e844 = phi_1827_;
                let _e845 = ((_e835 + _e839) + _e844);
                if (_e528 < 0f) {
                    phi_1834_ = -(_e528);
                } else {
                    phi_1834_ = _e528;
                }
                let _e849 = phi_1834_;
                if (_e531 < 0f) {
                    phi_1840_ = -(_e531);
                } else {
                    phi_1840_ = _e531;
                }
                let _e853 = phi_1840_;
                if (_e534 < 0f) {
                    phi_1847_ = -(_e534);
                } else {
                    phi_1847_ = _e534;
                }
                let _e858 = phi_1847_;
                let _e859 = ((_e849 + _e853) + _e858);
                if (_e845 > _e859) {
                    phi_1853_ = _e845;
                } else {
                    phi_1853_ = _e859;
                }
                let _e862 = phi_1853_;
                if (_e577 < 0f) {
                    phi_1859_ = -(_e577);
                } else {
                    phi_1859_ = _e577;
                }
                let _e866 = phi_1859_;
                if (_e578 < 0f) {
                    phi_1865_ = -(_e578);
                } else {
                    phi_1865_ = _e578;
                }
                let _e870 = phi_1865_;
                if (_e579 < 0f) {
                    phi_1872_ = -(_e579);
                } else {
                    phi_1872_ = _e579;
                }
                let _e875 = phi_1872_;
                let _e877 = (((_e866 + _e870) + _e875) * 0.5f);
                if (_e862 > _e877) {
                    phi_1879_ = _e862;
                } else {
                    phi_1879_ = _e877;
                }
                let _e880 = phi_1879_;
                let _e885 = local_12.member_3;
                let _e897 = (((((_e701 * 8f) * _e811) * (0.000000059604645f * (524f / 64f))) + ((_e818 * 19f) * ((_e701 * (_e755 + _e809)) + (_e755 * _e809)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e701) * ((1f + _e755) * (1f + _e809)))));
                let _e898 = (_e590 * 3f);
                let _e899 = (_e647 * 3f);
                if (_e898 < _e899) {
                    phi_1903_ = _e898;
                } else {
                    phi_1903_ = _e899;
                }
                let _e902 = phi_1903_;
                if (_e613 < _e636) {
                    phi_1908_ = _e613;
                } else {
                    phi_1908_ = _e636;
                }
                let _e905 = phi_1908_;
                if (_e902 < _e905) {
                    phi_1913_ = _e902;
                } else {
                    phi_1913_ = _e905;
                }
                let _e908 = phi_1913_;
                if (_e898 > _e899) {
                    phi_1918_ = _e898;
                } else {
                    phi_1918_ = _e899;
                }
                let _e911 = phi_1918_;
                if (_e613 > _e636) {
                    phi_1923_ = _e613;
                } else {
                    phi_1923_ = _e636;
                }
                let _e914 = phi_1923_;
                if (_e911 > _e914) {
                    phi_1928_ = _e911;
                } else {
                    phi_1928_ = _e914;
                }
                let _e917 = phi_1928_;
                let _e922 = -(_e917);
                if (_e908 > _e922) {
                    phi_1938_ = _e908;
                } else {
                    phi_1938_ = _e922;
                }
                let _e925 = phi_1938_;
                if ((_e925 - (_e897 + ((_e452.member_1 * (((_e880 + (_e811 * (0.000000059604645f * 8f))) + ((_e885 * 6f) * (_e755 + _e809))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e755) * (1f + _e809))))) * (3f * 1.0001f)))) > 0f) {
                    phi_8460_ = type_35(0u, type_35().member_1);
                } else {
                    if (_e452.member_1 > 0f) {
                        let _e3484 = local_12.member[0u];
                        let _e3490 = local_12.member_1[0u];
                        let _e3496 = local_12.member_2[0u];
                        let _e3508 = local_12.member[1u];
                        let _e3514 = local_12.member_1[1u];
                        let _e3520 = local_12.member_2[1u];
                        let _e3532 = local_12.member[0u];
                        if (_e3532[0] < 0f) {
                            phi_2091_ = -(_e3532[0]);
                        } else {
                            phi_2091_ = _e3532[0];
                        }
                        let _e3539 = phi_2091_;
                        if (_e3532[1] < 0f) {
                            phi_2098_ = -(_e3532[1]);
                        } else {
                            phi_2098_ = _e3532[1];
                        }
                        let _e3543 = phi_2098_;
                        if (_e3539 > _e3543) {
                            phi_2103_ = _e3539;
                        } else {
                            phi_2103_ = _e3543;
                        }
                        let _e3546 = phi_2103_;
                        if (_e3532[2] < 0f) {
                            phi_2110_ = -(_e3532[2]);
                        } else {
                            phi_2110_ = _e3532[2];
                        }
                        let _e3550 = phi_2110_;
                        if (_e3546 > _e3550) {
                            phi_2115_ = _e3546;
                        } else {
                            phi_2115_ = _e3550;
                        }
                        let _e3553 = phi_2115_;
                        let _e3556 = local_12.member[1u];
                        if (_e3556[0] < 0f) {
                            phi_2128_ = -(_e3556[0]);
                        } else {
                            phi_2128_ = _e3556[0];
                        }
                        let _e3563 = phi_2128_;
                        if (_e3556[1] < 0f) {
                            phi_2135_ = -(_e3556[1]);
                        } else {
                            phi_2135_ = _e3556[1];
                        }
                        let _e3567 = phi_2135_;
                        if (_e3563 > _e3567) {
                            phi_2140_ = _e3563;
                        } else {
                            phi_2140_ = _e3567;
                        }
                        let _e3570 = phi_2140_;
                        if (_e3556[2] < 0f) {
                            phi_2147_ = -(_e3556[2]);
                        } else {
                            phi_2147_ = _e3556[2];
                        }
                        let _e3574 = phi_2147_;
                        if (_e3570 > _e3574) {
                            phi_2152_ = _e3570;
                        } else {
                            phi_2152_ = _e3574;
                        }
                        let _e3577 = phi_2152_;
                        if (_e3553 > _e3577) {
                            phi_2157_ = _e3553;
                        } else {
                            phi_2157_ = _e3577;
                        }
                        let _e3580 = phi_2157_;
                        let _e3582 = local_12.member_3;
                        let _e3586 = local_12.member_1[0u];
                        if (_e3586[0] < 0f) {
                            phi_2174_ = -(_e3586[0]);
                        } else {
                            phi_2174_ = _e3586[0];
                        }
                        let _e3593 = phi_2174_;
                        if (_e3586[1] < 0f) {
                            phi_2181_ = -(_e3586[1]);
                        } else {
                            phi_2181_ = _e3586[1];
                        }
                        let _e3597 = phi_2181_;
                        if (_e3593 > _e3597) {
                            phi_2186_ = _e3593;
                        } else {
                            phi_2186_ = _e3597;
                        }
                        let _e3600 = phi_2186_;
                        if (_e3586[2] < 0f) {
                            phi_2193_ = -(_e3586[2]);
                        } else {
                            phi_2193_ = _e3586[2];
                        }
                        let _e3604 = phi_2193_;
                        if (_e3600 > _e3604) {
                            phi_2198_ = _e3600;
                        } else {
                            phi_2198_ = _e3604;
                        }
                        let _e3607 = phi_2198_;
                        let _e3610 = local_12.member_1[1u];
                        if (_e3610[0] < 0f) {
                            phi_2212_ = -(_e3610[0]);
                        } else {
                            phi_2212_ = _e3610[0];
                        }
                        let _e3617 = phi_2212_;
                        if (_e3610[1] < 0f) {
                            phi_2219_ = -(_e3610[1]);
                        } else {
                            phi_2219_ = _e3610[1];
                        }
                        let _e3621 = phi_2219_;
                        if (_e3617 > _e3621) {
                            phi_2224_ = _e3617;
                        } else {
                            phi_2224_ = _e3621;
                        }
                        let _e3624 = phi_2224_;
                        if (_e3610[2] < 0f) {
                            phi_2231_ = -(_e3610[2]);
                        } else {
                            phi_2231_ = _e3610[2];
                        }
                        let _e3628 = phi_2231_;
                        if (_e3624 > _e3628) {
                            phi_2236_ = _e3624;
                        } else {
                            phi_2236_ = _e3628;
                        }
                        let _e3631 = phi_2236_;
                        if (_e3607 > _e3631) {
                            phi_2241_ = _e3607;
                        } else {
                            phi_2241_ = _e3631;
                        }
                        let _e3634 = phi_2241_;
                        let _e3636 = local_12.member_3;
                        let _e3640 = local_12.member_2[0u];
                        if (_e3640[0] < 0f) {
                            phi_2258_ = -(_e3640[0]);
                        } else {
                            phi_2258_ = _e3640[0];
                        }
                        let _e3647 = phi_2258_;
                        if (_e3640[1] < 0f) {
                            phi_2265_ = -(_e3640[1]);
                        } else {
                            phi_2265_ = _e3640[1];
                        }
                        let _e3651 = phi_2265_;
                        if (_e3647 > _e3651) {
                            phi_2270_ = _e3647;
                        } else {
                            phi_2270_ = _e3651;
                        }
                        let _e3654 = phi_2270_;
                        if (_e3640[2] < 0f) {
                            phi_2277_ = -(_e3640[2]);
                        } else {
                            phi_2277_ = _e3640[2];
                        }
                        let _e3658 = phi_2277_;
                        if (_e3654 > _e3658) {
                            phi_2282_ = _e3654;
                        } else {
                            phi_2282_ = _e3658;
                        }
                        let _e3661 = phi_2282_;
                        let _e3664 = local_12.member_2[1u];
                        if (_e3664[0] < 0f) {
                            phi_2296_ = -(_e3664[0]);
                        } else {
                            phi_2296_ = _e3664[0];
                        }
                        let _e3671 = phi_2296_;
                        if (_e3664[1] < 0f) {
                            phi_2303_ = -(_e3664[1]);
                        } else {
                            phi_2303_ = _e3664[1];
                        }
                        let _e3675 = phi_2303_;
                        if (_e3671 > _e3675) {
                            phi_2308_ = _e3671;
                        } else {
                            phi_2308_ = _e3675;
                        }
                        let _e3678 = phi_2308_;
                        if (_e3664[2] < 0f) {
                            phi_2315_ = -(_e3664[2]);
                        } else {
                            phi_2315_ = _e3664[2];
                        }
                        let _e3682 = phi_2315_;
                        if (_e3678 > _e3682) {
                            phi_2320_ = _e3678;
                        } else {
                            phi_2320_ = _e3682;
                        }
                        let _e3685 = phi_2320_;
                        if (_e3661 > _e3685) {
                            phi_2325_ = _e3661;
                        } else {
                            phi_2325_ = _e3685;
                        }
                        let _e3688 = phi_2325_;
                        let _e3690 = local_12.member_3;
                        let _e3697 = local_12.member_3;
                        local_9 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_2364_ = type_9(0u, 96u);
                        phi_2367_ = 0f;
                        phi_2369_ = 0f;
                        phi_2371_ = 0f;
                        loop {
                            let _e3703 = phi_2364_;
                            let _e3705 = phi_2367_;
                            let _e3707 = phi_2369_;
                            let _e3709 = phi_2371_;
                            local_44 = _e3707;
                            local_26 = _e3705;
                            if (_e3703.member < _e3703.member_1) {
                                phi_2365_ = type_9((_e3703.member + 1u), _e3703.member_1);
                                phi_2394_ = type_9(1u, _e3703.member);
                            } else {
                                phi_2365_ = _e3703;
                                phi_2394_ = type_9(0u, type_9().member_1);
                            }
                            let _e3721 = phi_2365_;
                            let _e3723 = phi_2394_;
                            if (bitcast<i32>(_e3723.member) != 0i) {
                                let _e3730 = local_12.member[0u];
                                let _e3736 = local_12.member[1u];
                                let _e3752 = local_12.member_1[0u];
                                let _e3758 = local_12.member_1[1u];
                                let _e3774 = local_12.member_2[0u];
                                let _e3780 = local_12.member_2[1u];
                                let _e3794 = function_1(array<f32, 3>((_e3730[0] + ((_e3736[0] - _e3730[0]) * _e3705)), (_e3730[1] + ((_e3736[1] - _e3730[1]) * _e3705)), (_e3730[2] + ((_e3736[2] - _e3730[2]) * _e3705))), array<f32, 3>((_e3752[0] + ((_e3758[0] - _e3752[0]) * _e3705)), (_e3752[1] + ((_e3758[1] - _e3752[1]) * _e3705)), (_e3752[2] + ((_e3758[2] - _e3752[2]) * _e3705))), array<f32, 3>((_e3774[0] + ((_e3780[0] - _e3774[0]) * _e3705)), (_e3774[1] + ((_e3780[1] - _e3774[1]) * _e3705)), (_e3774[2] + ((_e3780[2] - _e3774[2]) * _e3705))), 0u);
                                if (_e3794[0] < 0f) {
                                    phi_2506_ = -(_e3794[0]);
                                } else {
                                    phi_2506_ = _e3794[0];
                                }
                                let _e3799 = phi_2506_;
                                if (_e3794[1] < 0f) {
                                    phi_2513_ = -(_e3794[1]);
                                } else {
                                    phi_2513_ = _e3794[1];
                                }
                                let _e3804 = phi_2513_;
                                if (_e3794[2] < 0f) {
                                    phi_2521_ = -(_e3794[2]);
                                } else {
                                    phi_2521_ = _e3794[2];
                                }
                                let _e3810 = phi_2521_;
                                let _e3811 = ((_e3799 + _e3804) + _e3810);
                                if (_e3811 > 0f) {
                                    if ((bitcast<u32>(_e3811) & 2139095040u) != 2139095040u) {
                                        let _e3816 = (1f / _e3811);
                                        let _e3818 = (_e3794[0] * _e3816);
                                        let _e3820 = (_e3794[1] * _e3816);
                                        let _e3822 = (_e3794[2] * _e3816);
                                        let _e3827 = (((_e3818 * _e3818) + (_e3820 * _e3820)) + (_e3822 * _e3822));
                                        if (_e3827 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3827 > 0f) {
                                                phi_2558_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2558_ = 0f;
                                            }
                                            let _e3880 = phi_2558_;
                                            phi_2622_ = _e3880;
                                        } else {
                                            phi_2565_ = type_14(0i, 5i);
                                            phi_2568_ = bitcast<f32>(((bitcast<u32>(_e3827) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3835 = phi_2565_;
                                                let _e3837 = phi_2568_;
                                                local_24 = _e3837;
                                                if (_e3835.member < _e3835.member_1) {
                                                    let _e3844 = (_e3835.member + 1i);
                                                    if ((false == (_e3844 > _e3835.member)) != false) {
                                                        phi_2589_ = true;
                                                    } else {
                                                        phi_2589_ = false;
                                                    }
                                                    let _e3849 = phi_2589_;
                                                    if _e3849 {
                                                        phi_2595_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2595_ = type_15(1u, _e3844);
                                                    }
                                                    let _e3854 = phi_2595_;
                                                    phi_2566_ = type_14(_e3854.member_1, _e3835.member_1);
                                                    phi_2609_ = type_15(1u, _e3835.member);
                                                } else {
                                                    phi_2566_ = _e3835;
                                                    phi_2609_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3860 = phi_2566_;
                                                let _e3862 = phi_2609_;
                                                let _e3865 = (bitcast<i32>(_e3862.member) != 0i);
                                                if _e3865 {
                                                    phi_2569_ = (0.5f * (_e3837 + (_e3827 / _e3837)));
                                                } else {
                                                    phi_2569_ = f32();
                                                }
                                                let _e3870 = phi_2569_;
                                                continue;
                                                continuing {
                                                    phi_2565_ = _e3860;
                                                    phi_2568_ = _e3870;
                                                    break if !(_e3865);
                                                }
                                            }
                                            let _e3875 = local_24;
                                            phi_2622_ = (_e3875 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3882 = phi_2622_;
                                        let _e3883 = (0.000000059604645f * 12f);
                                        let _e3888 = ((((((((_e3580 + _e3582) + (_e3634 + _e3636)) + (_e3688 + _e3690)) * (0.000000059604645f * 16f)) + (_e3697 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e452.member_1 * _e3882) * (1f + _e3883)));
                                        let _e3893 = (((_e3818 * _e3484[0]) + (_e3820 * _e3484[1])) + (_e3822 * _e3484[2]));
                                        let _e3898 = (((_e3818 * (_e3484[0] - _e3490[0])) + (_e3820 * (_e3484[1] - _e3490[1]))) + (_e3822 * (_e3484[2] - _e3490[2])));
                                        let _e3903 = (((_e3818 * (_e3484[0] - _e3496[0])) + (_e3820 * (_e3484[1] - _e3496[1]))) + (_e3822 * (_e3484[2] - _e3496[2])));
                                        let _e3908 = (((_e3818 * _e3484[0]) + (_e3820 * _e3484[1])) + (_e3822 * _e3484[2]));
                                        let _e3914 = (((_e3818 * _e3508[0]) + (_e3820 * _e3508[1])) + (_e3822 * _e3508[2]));
                                        let _e3919 = (((_e3818 * (_e3508[0] - _e3514[0])) + (_e3820 * (_e3508[1] - _e3514[1]))) + (_e3822 * (_e3508[2] - _e3514[2])));
                                        let _e3924 = (((_e3818 * (_e3508[0] - _e3520[0])) + (_e3820 * (_e3508[1] - _e3520[1]))) + (_e3822 * (_e3508[2] - _e3520[2])));
                                        let _e3929 = (((_e3818 * _e3508[0]) + (_e3820 * _e3508[1])) + (_e3822 * _e3508[2]));
                                        if (_e3893 < 0f) {
                                            phi_2688_ = -(_e3893);
                                        } else {
                                            phi_2688_ = _e3893;
                                        }
                                        let _e3934 = phi_2688_;
                                        if (_e3914 < 0f) {
                                            phi_2694_ = -(_e3914);
                                        } else {
                                            phi_2694_ = _e3914;
                                        }
                                        let _e3938 = phi_2694_;
                                        if (_e3898 < 0f) {
                                            phi_2703_ = -(_e3898);
                                        } else {
                                            phi_2703_ = _e3898;
                                        }
                                        let _e3945 = phi_2703_;
                                        if (_e3919 < 0f) {
                                            phi_2709_ = -(_e3919);
                                        } else {
                                            phi_2709_ = _e3919;
                                        }
                                        let _e3949 = phi_2709_;
                                        if (_e3903 < 0f) {
                                            phi_2718_ = -(_e3903);
                                        } else {
                                            phi_2718_ = _e3903;
                                        }
                                        let _e3956 = phi_2718_;
                                        if (_e3924 < 0f) {
                                            phi_2724_ = -(_e3924);
                                        } else {
                                            phi_2724_ = _e3924;
                                        }
                                        let _e3960 = phi_2724_;
                                        if (_e3908 < 0f) {
                                            phi_2733_ = -(_e3908);
                                        } else {
                                            phi_2733_ = _e3908;
                                        }
                                        let _e3967 = phi_2733_;
                                        if (_e3929 < 0f) {
                                            phi_2739_ = -(_e3929);
                                        } else {
                                            phi_2739_ = _e3929;
                                        }
                                        let _e3971 = phi_2739_;
                                        phi_2745_ = type_30(array<f32, 4>(_e3893, _e3898, _e3903, _e3908), array<f32, 4>(_e3914, _e3919, _e3924, _e3929), array<f32, 4>((_e3888 + ((_e3934 + _e3938) * _e3883)), (_e3888 + ((_e3945 + _e3949) * _e3883)), (_e3888 + ((_e3956 + _e3960) * _e3883)), (_e3888 + ((_e3967 + _e3971) * _e3883))));
                                        phi_2746_ = false;
                                    } else {
                                        phi_2745_ = type_30();
                                        phi_2746_ = true;
                                    }
                                    let _e3978 = phi_2745_;
                                    let _e3980 = phi_2746_;
                                    phi_2747_ = _e3978;
                                    phi_2748_ = _e3980;
                                } else {
                                    phi_2747_ = type_30();
                                    phi_2748_ = true;
                                }
                                let _e3982 = phi_2747_;
                                let _e3984 = phi_2748_;
                                if _e3984 {
                                    phi_2756_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2756_ = _e3982;
                                }
                                let _e3986 = phi_2756_;
                                local_10 = type_30(array<f32, 4>(_e3986.member[0], _e3986.member[1], _e3986.member[2], _e3986.member[3]), array<f32, 4>(_e3986.member_1[0], _e3986.member_1[1], _e3986.member_1[2], _e3986.member_1[3]), array<f32, 4>(_e3986.member_2[0], _e3986.member_2[1], _e3986.member_2[2], _e3986.member_2[3]));
                                let _e4006 = (_e3705 - _e3709);
                                let _e4009 = local_10.member[0u];
                                let _e4012 = local_10.member_1[0u];
                                let _e4015 = local_10.member[0u];
                                let _e4021 = local_10.member_2[0u];
                                if (((_e4009 + ((_e4012 - _e4015) * _e3705)) - _e4021) > 0f) {
                                    let _e4026 = local_10.member[1u];
                                    let _e4029 = local_10.member_1[1u];
                                    let _e4032 = local_10.member[1u];
                                    let _e4038 = local_10.member_2[1u];
                                    if (((_e4026 + ((_e4029 - _e4032) * _e3705)) - _e4038) > 0f) {
                                        let _e4043 = local_10.member[2u];
                                        let _e4046 = local_10.member_1[2u];
                                        let _e4049 = local_10.member[2u];
                                        let _e4055 = local_10.member_2[2u];
                                        if (((_e4043 + ((_e4046 - _e4049) * _e3705)) - _e4055) > 0f) {
                                            let _e4060 = local_10.member[3u];
                                            let _e4063 = local_10.member_1[3u];
                                            let _e4066 = local_10.member[3u];
                                            let _e4072 = local_10.member_2[3u];
                                            phi_2926_ = (((_e4060 + ((_e4063 - _e4066) * _e3705)) - _e4072) > 0f);
                                            phi_2927_ = false;
                                        } else {
                                            phi_2926_ = bool();
                                            phi_2927_ = true;
                                        }
                                        let _e4076 = phi_2926_;
                                        let _e4078 = phi_2927_;
                                        phi_2928_ = _e4076;
                                        phi_2929_ = _e4078;
                                    } else {
                                        phi_2928_ = bool();
                                        phi_2929_ = true;
                                    }
                                    let _e4080 = phi_2928_;
                                    let _e4082 = phi_2929_;
                                    phi_2930_ = _e4080;
                                    phi_2931_ = _e4082;
                                } else {
                                    phi_2930_ = bool();
                                    phi_2931_ = true;
                                }
                                let _e4084 = phi_2930_;
                                let _e4086 = phi_2931_;
                                if _e4086 {
                                    phi_2935_ = false;
                                } else {
                                    phi_2935_ = _e4084;
                                }
                                let _e4088 = phi_2935_;
                                if _e4088 {
                                    if (_e3705 <= _e3707) {
                                        phi_3245_ = true;
                                    } else {
                                        let _e4092 = local_9.member[0u];
                                        let _e4095 = local_9.member_1[0u];
                                        let _e4098 = local_9.member[0u];
                                        let _e4104 = local_9.member_2[0u];
                                        let _e4108 = local_10.member[0u];
                                        let _e4111 = local_10.member_1[0u];
                                        let _e4114 = local_10.member[0u];
                                        let _e4120 = local_10.member_2[0u];
                                        if ((((_e4092 + ((_e4095 - _e4098) * _e3705)) - _e4104) + ((_e4108 + ((_e4111 - _e4114) * _e3709)) - _e4120)) > 0f) {
                                            let _e4126 = local_9.member[1u];
                                            let _e4129 = local_9.member_1[1u];
                                            let _e4132 = local_9.member[1u];
                                            let _e4138 = local_9.member_2[1u];
                                            let _e4142 = local_10.member[1u];
                                            let _e4145 = local_10.member_1[1u];
                                            let _e4148 = local_10.member[1u];
                                            let _e4154 = local_10.member_2[1u];
                                            if ((((_e4126 + ((_e4129 - _e4132) * _e3705)) - _e4138) + ((_e4142 + ((_e4145 - _e4148) * _e3709)) - _e4154)) > 0f) {
                                                let _e4160 = local_9.member[2u];
                                                let _e4163 = local_9.member_1[2u];
                                                let _e4166 = local_9.member[2u];
                                                let _e4172 = local_9.member_2[2u];
                                                let _e4176 = local_10.member[2u];
                                                let _e4179 = local_10.member_1[2u];
                                                let _e4182 = local_10.member[2u];
                                                let _e4188 = local_10.member_2[2u];
                                                if ((((_e4160 + ((_e4163 - _e4166) * _e3705)) - _e4172) + ((_e4176 + ((_e4179 - _e4182) * _e3709)) - _e4188)) > 0f) {
                                                    let _e4194 = local_9.member[3u];
                                                    let _e4197 = local_9.member_1[3u];
                                                    let _e4200 = local_9.member[3u];
                                                    let _e4206 = local_9.member_2[3u];
                                                    let _e4210 = local_10.member[3u];
                                                    let _e4213 = local_10.member_1[3u];
                                                    let _e4216 = local_10.member[3u];
                                                    let _e4222 = local_10.member_2[3u];
                                                    phi_3232_ = ((((_e4194 + ((_e4197 - _e4200) * _e3705)) - _e4206) + ((_e4210 + ((_e4213 - _e4216) * _e3709)) - _e4222)) > 0f);
                                                    phi_3233_ = false;
                                                } else {
                                                    phi_3232_ = bool();
                                                    phi_3233_ = true;
                                                }
                                                let _e4227 = phi_3232_;
                                                let _e4229 = phi_3233_;
                                                phi_3234_ = _e4227;
                                                phi_3235_ = _e4229;
                                            } else {
                                                phi_3234_ = bool();
                                                phi_3235_ = true;
                                            }
                                            let _e4231 = phi_3234_;
                                            let _e4233 = phi_3235_;
                                            phi_3236_ = _e4231;
                                            phi_3237_ = _e4233;
                                        } else {
                                            phi_3236_ = bool();
                                            phi_3237_ = true;
                                        }
                                        let _e4235 = phi_3236_;
                                        let _e4237 = phi_3237_;
                                        if _e4237 {
                                            phi_3241_ = false;
                                        } else {
                                            phi_3241_ = _e4235;
                                        }
                                        let _e4239 = phi_3241_;
                                        phi_3245_ = _e4239;
                                    }
                                    let _e4241 = phi_3245_;
                                    if _e4241 {
                                        if (_e3723.member_1 > 0u) {
                                            if (_e3705 >= 1f) {
                                                phi_3257_ = false;
                                            } else {
                                                phi_3257_ = true;
                                            }
                                            let _e4245 = phi_3257_;
                                            phi_3258_ = _e4245;
                                        } else {
                                            phi_3258_ = true;
                                        }
                                        let _e4247 = phi_3258_;
                                        if _e4247 {
                                            local_9 = type_30(array<f32, 4>(_e3986.member[0], _e3986.member[1], _e3986.member[2], _e3986.member[3]), array<f32, 4>(_e3986.member_1[0], _e3986.member_1[1], _e3986.member_1[2], _e3986.member_1[3]), array<f32, 4>(_e3986.member_2[0], _e3986.member_2[1], _e3986.member_2[2], _e3986.member_2[3]));
                                            let _e4269 = local_9.member[0u];
                                            let _e4272 = local_9.member_1[0u];
                                            let _e4275 = local_9.member_2[0u];
                                            if (_e4269 > _e4275) {
                                                if (_e4272 > _e4275) {
                                                    phi_3332_ = false;
                                                } else {
                                                    phi_3332_ = true;
                                                }
                                                let _e4279 = phi_3332_;
                                                phi_3333_ = _e4279;
                                            } else {
                                                phi_3333_ = true;
                                            }
                                            let _e4281 = phi_3333_;
                                            if _e4281 {
                                                let _e4282 = (_e4272 >= _e4269);
                                                if _e4282 {
                                                    phi_3355_ = f32();
                                                    phi_3356_ = false;
                                                } else {
                                                    if ((_e4269 - _e4272) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3353_ = (((_e4269 - _e4275) / (_e4269 - _e4272)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3354_ = false;
                                                    } else {
                                                        phi_3353_ = f32();
                                                        phi_3354_ = true;
                                                    }
                                                    let _e4293 = phi_3353_;
                                                    let _e4295 = phi_3354_;
                                                    phi_3355_ = _e4293;
                                                    phi_3356_ = _e4295;
                                                }
                                                let _e4297 = phi_3355_;
                                                let _e4299 = phi_3356_;
                                                phi_3357_ = _e4297;
                                                phi_3358_ = _e4282;
                                                phi_3359_ = _e4299;
                                            } else {
                                                phi_3357_ = f32();
                                                phi_3358_ = true;
                                                phi_3359_ = false;
                                            }
                                            let _e4301 = phi_3357_;
                                            let _e4303 = phi_3358_;
                                            let _e4305 = phi_3359_;
                                            if _e4303 {
                                                phi_3363_ = 2f;
                                                phi_3364_ = true;
                                            } else {
                                                phi_3363_ = _e3705;
                                                phi_3364_ = _e4305;
                                            }
                                            let _e4307 = phi_3363_;
                                            let _e4309 = phi_3364_;
                                            if _e4309 {
                                                phi_3368_ = _e4307;
                                            } else {
                                                phi_3368_ = _e4301;
                                            }
                                            let _e4311 = phi_3368_;
                                            let _e4314 = local_9.member[1u];
                                            let _e4317 = local_9.member_1[1u];
                                            let _e4320 = local_9.member_2[1u];
                                            if (_e4314 > _e4320) {
                                                if (_e4317 > _e4320) {
                                                    phi_3400_ = false;
                                                } else {
                                                    phi_3400_ = true;
                                                }
                                                let _e4324 = phi_3400_;
                                                phi_3401_ = _e4324;
                                            } else {
                                                phi_3401_ = true;
                                            }
                                            let _e4326 = phi_3401_;
                                            if _e4326 {
                                                let _e4327 = (_e4317 >= _e4314);
                                                if _e4327 {
                                                    phi_3423_ = f32();
                                                    phi_3424_ = false;
                                                } else {
                                                    if ((_e4314 - _e4317) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3421_ = (((_e4314 - _e4320) / (_e4314 - _e4317)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3422_ = false;
                                                    } else {
                                                        phi_3421_ = f32();
                                                        phi_3422_ = true;
                                                    }
                                                    let _e4338 = phi_3421_;
                                                    let _e4340 = phi_3422_;
                                                    phi_3423_ = _e4338;
                                                    phi_3424_ = _e4340;
                                                }
                                                let _e4342 = phi_3423_;
                                                let _e4344 = phi_3424_;
                                                phi_3425_ = _e4342;
                                                phi_3426_ = _e4327;
                                                phi_3427_ = _e4344;
                                            } else {
                                                phi_3425_ = f32();
                                                phi_3426_ = true;
                                                phi_3427_ = false;
                                            }
                                            let _e4346 = phi_3425_;
                                            let _e4348 = phi_3426_;
                                            let _e4350 = phi_3427_;
                                            if _e4348 {
                                                phi_3431_ = 2f;
                                                phi_3432_ = true;
                                            } else {
                                                phi_3431_ = _e3705;
                                                phi_3432_ = _e4350;
                                            }
                                            let _e4352 = phi_3431_;
                                            let _e4354 = phi_3432_;
                                            if _e4354 {
                                                phi_3436_ = _e4352;
                                            } else {
                                                phi_3436_ = _e4346;
                                            }
                                            let _e4356 = phi_3436_;
                                            if (_e4311 < _e4356) {
                                                phi_3441_ = _e4311;
                                            } else {
                                                phi_3441_ = _e4356;
                                            }
                                            let _e4359 = phi_3441_;
                                            let _e4362 = local_9.member[2u];
                                            let _e4365 = local_9.member_1[2u];
                                            let _e4368 = local_9.member_2[2u];
                                            if (_e4362 > _e4368) {
                                                if (_e4365 > _e4368) {
                                                    phi_3473_ = false;
                                                } else {
                                                    phi_3473_ = true;
                                                }
                                                let _e4372 = phi_3473_;
                                                phi_3474_ = _e4372;
                                            } else {
                                                phi_3474_ = true;
                                            }
                                            let _e4374 = phi_3474_;
                                            if _e4374 {
                                                let _e4375 = (_e4365 >= _e4362);
                                                if _e4375 {
                                                    phi_3496_ = f32();
                                                    phi_3497_ = false;
                                                } else {
                                                    if ((_e4362 - _e4365) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3494_ = (((_e4362 - _e4368) / (_e4362 - _e4365)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3495_ = false;
                                                    } else {
                                                        phi_3494_ = f32();
                                                        phi_3495_ = true;
                                                    }
                                                    let _e4386 = phi_3494_;
                                                    let _e4388 = phi_3495_;
                                                    phi_3496_ = _e4386;
                                                    phi_3497_ = _e4388;
                                                }
                                                let _e4390 = phi_3496_;
                                                let _e4392 = phi_3497_;
                                                phi_3498_ = _e4390;
                                                phi_3499_ = _e4375;
                                                phi_3500_ = _e4392;
                                            } else {
                                                phi_3498_ = f32();
                                                phi_3499_ = true;
                                                phi_3500_ = false;
                                            }
                                            let _e4394 = phi_3498_;
                                            let _e4396 = phi_3499_;
                                            let _e4398 = phi_3500_;
                                            if _e4396 {
                                                phi_3504_ = 2f;
                                                phi_3505_ = true;
                                            } else {
                                                phi_3504_ = _e3705;
                                                phi_3505_ = _e4398;
                                            }
                                            let _e4400 = phi_3504_;
                                            let _e4402 = phi_3505_;
                                            if _e4402 {
                                                phi_3509_ = _e4400;
                                            } else {
                                                phi_3509_ = _e4394;
                                            }
                                            let _e4404 = phi_3509_;
                                            let _e4407 = local_9.member[3u];
                                            let _e4410 = local_9.member_1[3u];
                                            let _e4413 = local_9.member_2[3u];
                                            if (_e4407 > _e4413) {
                                                if (_e4410 > _e4413) {
                                                    phi_3541_ = false;
                                                } else {
                                                    phi_3541_ = true;
                                                }
                                                let _e4417 = phi_3541_;
                                                phi_3542_ = _e4417;
                                            } else {
                                                phi_3542_ = true;
                                            }
                                            let _e4419 = phi_3542_;
                                            if _e4419 {
                                                let _e4420 = (_e4410 >= _e4407);
                                                if _e4420 {
                                                    phi_3564_ = f32();
                                                    phi_3565_ = false;
                                                } else {
                                                    if ((_e4407 - _e4410) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3562_ = (((_e4407 - _e4413) / (_e4407 - _e4410)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3563_ = false;
                                                    } else {
                                                        phi_3562_ = f32();
                                                        phi_3563_ = true;
                                                    }
                                                    let _e4431 = phi_3562_;
                                                    let _e4433 = phi_3563_;
                                                    phi_3564_ = _e4431;
                                                    phi_3565_ = _e4433;
                                                }
                                                let _e4435 = phi_3564_;
                                                let _e4437 = phi_3565_;
                                                phi_3566_ = _e4435;
                                                phi_3567_ = _e4420;
                                                phi_3568_ = _e4437;
                                            } else {
                                                phi_3566_ = f32();
                                                phi_3567_ = true;
                                                phi_3568_ = false;
                                            }
                                            let _e4439 = phi_3566_;
                                            let _e4441 = phi_3567_;
                                            let _e4443 = phi_3568_;
                                            if _e4441 {
                                                phi_3572_ = 2f;
                                                phi_3573_ = true;
                                            } else {
                                                phi_3572_ = _e3705;
                                                phi_3573_ = _e4443;
                                            }
                                            let _e4445 = phi_3572_;
                                            let _e4447 = phi_3573_;
                                            if _e4447 {
                                                phi_3577_ = _e4445;
                                            } else {
                                                phi_3577_ = _e4439;
                                            }
                                            let _e4449 = phi_3577_;
                                            if (_e4404 < _e4449) {
                                                phi_3582_ = _e4404;
                                            } else {
                                                phi_3582_ = _e4449;
                                            }
                                            let _e4452 = phi_3582_;
                                            if (_e4359 < _e4452) {
                                                phi_3587_ = _e4359;
                                            } else {
                                                phi_3587_ = _e4452;
                                            }
                                            let _e4455 = phi_3587_;
                                            if (_e4455 > _e3705) {
                                                phi_3592_ = _e4455;
                                            } else {
                                                phi_3592_ = _e3705;
                                            }
                                            let _e4458 = phi_3592_;
                                            let _e4459 = (_e4458 > 1f);
                                            if _e4459 {
                                                phi_3604_ = f32();
                                                phi_3605_ = false;
                                            } else {
                                                if (_e3723.member_1 == 0u) {
                                                    phi_3603_ = (1f - _e3705);
                                                } else {
                                                    phi_3603_ = (_e4006 + _e4006);
                                                }
                                                let _e4464 = phi_3603_;
                                                phi_3604_ = _e4464;
                                                phi_3605_ = true;
                                            }
                                            let _e4466 = phi_3604_;
                                            let _e4468 = phi_3605_;
                                            phi_3606_ = _e4458;
                                            phi_3607_ = _e4466;
                                            phi_3608_ = _e4468;
                                            phi_3609_ = _e4459;
                                            phi_3610_ = false;
                                        } else {
                                            phi_3606_ = f32();
                                            phi_3607_ = f32();
                                            phi_3608_ = false;
                                            phi_3609_ = false;
                                            phi_3610_ = true;
                                        }
                                        let _e4470 = phi_3606_;
                                        let _e4472 = phi_3607_;
                                        let _e4474 = phi_3608_;
                                        let _e4476 = phi_3609_;
                                        let _e4478 = phi_3610_;
                                        phi_3611_ = _e4470;
                                        phi_3612_ = _e4472;
                                        phi_3613_ = false;
                                        phi_3614_ = _e4474;
                                        phi_3615_ = _e4476;
                                        phi_3616_ = _e4478;
                                    } else {
                                        phi_3611_ = f32();
                                        phi_3612_ = f32();
                                        phi_3613_ = true;
                                        phi_3614_ = false;
                                        phi_3615_ = false;
                                        phi_3616_ = false;
                                    }
                                    let _e4480 = phi_3611_;
                                    let _e4482 = phi_3612_;
                                    let _e4484 = phi_3613_;
                                    let _e4486 = phi_3614_;
                                    let _e4488 = phi_3615_;
                                    let _e4490 = phi_3616_;
                                    phi_3617_ = _e4480;
                                    phi_3618_ = _e4482;
                                    phi_3619_ = _e4484;
                                    phi_3620_ = _e4486;
                                    phi_3621_ = _e4488;
                                    phi_3622_ = _e4490;
                                } else {
                                    phi_3617_ = f32();
                                    phi_3618_ = f32();
                                    phi_3619_ = true;
                                    phi_3620_ = false;
                                    phi_3621_ = false;
                                    phi_3622_ = false;
                                }
                                let _e4492 = phi_3617_;
                                let _e4494 = phi_3618_;
                                let _e4496 = phi_3619_;
                                let _e4498 = phi_3620_;
                                let _e4500 = phi_3621_;
                                let _e4502 = phi_3622_;
                                if _e4496 {
                                    let _e4503 = (_e3705 <= _e3707);
                                    if _e4503 {
                                        phi_3951_ = f32();
                                        phi_3952_ = false;
                                    } else {
                                        let _e4506 = local_9.member[0u];
                                        let _e4509 = local_9.member_1[0u];
                                        let _e4512 = local_9.member[0u];
                                        let _e4518 = local_9.member_2[0u];
                                        let _e4519 = ((_e4506 + ((_e4509 - _e4512) * _e3709)) - _e4518);
                                        let _e4522 = local_9.member[1u];
                                        let _e4525 = local_9.member_1[1u];
                                        let _e4528 = local_9.member[1u];
                                        let _e4534 = local_9.member_2[1u];
                                        let _e4535 = ((_e4522 + ((_e4525 - _e4528) * _e3709)) - _e4534);
                                        if (_e4519 < _e4535) {
                                            phi_3702_ = _e4519;
                                        } else {
                                            phi_3702_ = _e4535;
                                        }
                                        let _e4538 = phi_3702_;
                                        let _e4541 = local_9.member[2u];
                                        let _e4544 = local_9.member_1[2u];
                                        let _e4547 = local_9.member[2u];
                                        let _e4553 = local_9.member_2[2u];
                                        let _e4554 = ((_e4541 + ((_e4544 - _e4547) * _e3709)) - _e4553);
                                        let _e4557 = local_9.member[3u];
                                        let _e4560 = local_9.member_1[3u];
                                        let _e4563 = local_9.member[3u];
                                        let _e4569 = local_9.member_2[3u];
                                        let _e4570 = ((_e4557 + ((_e4560 - _e4563) * _e3709)) - _e4569);
                                        if (_e4554 < _e4570) {
                                            phi_3775_ = _e4554;
                                        } else {
                                            phi_3775_ = _e4570;
                                        }
                                        let _e4573 = phi_3775_;
                                        if (_e4538 < _e4573) {
                                            phi_3780_ = _e4538;
                                        } else {
                                            phi_3780_ = _e4573;
                                        }
                                        let _e4576 = phi_3780_;
                                        let _e4579 = local_10.member[0u];
                                        let _e4582 = local_10.member_1[0u];
                                        let _e4585 = local_10.member[0u];
                                        let _e4591 = local_10.member_2[0u];
                                        let _e4592 = ((_e4579 + ((_e4582 - _e4585) * _e3705)) - _e4591);
                                        let _e4595 = local_10.member[1u];
                                        let _e4598 = local_10.member_1[1u];
                                        let _e4601 = local_10.member[1u];
                                        let _e4607 = local_10.member_2[1u];
                                        let _e4608 = ((_e4595 + ((_e4598 - _e4601) * _e3705)) - _e4607);
                                        if (_e4592 < _e4608) {
                                            phi_3853_ = _e4592;
                                        } else {
                                            phi_3853_ = _e4608;
                                        }
                                        let _e4611 = phi_3853_;
                                        let _e4614 = local_10.member[2u];
                                        let _e4617 = local_10.member_1[2u];
                                        let _e4620 = local_10.member[2u];
                                        let _e4626 = local_10.member_2[2u];
                                        let _e4627 = ((_e4614 + ((_e4617 - _e4620) * _e3705)) - _e4626);
                                        let _e4630 = local_10.member[3u];
                                        let _e4633 = local_10.member_1[3u];
                                        let _e4636 = local_10.member[3u];
                                        let _e4642 = local_10.member_2[3u];
                                        let _e4643 = ((_e4630 + ((_e4633 - _e4636) * _e3705)) - _e4642);
                                        if (_e4627 < _e4643) {
                                            phi_3926_ = _e4627;
                                        } else {
                                            phi_3926_ = _e4643;
                                        }
                                        let _e4646 = phi_3926_;
                                        if (_e4611 < _e4646) {
                                            phi_3931_ = _e4611;
                                        } else {
                                            phi_3931_ = _e4646;
                                        }
                                        let _e4649 = phi_3931_;
                                        if (_e4649 > 0f) {
                                            phi_3949_ = 0.5f;
                                        } else {
                                            let _e4653 = (0.95f * (_e4576 / (_e4576 - _e4649)));
                                            if (_e4653 > 0.0625f) {
                                                if (_e4653 < 0.9f) {
                                                    phi_3947_ = _e4653;
                                                } else {
                                                    phi_3947_ = 0.9f;
                                                }
                                                let _e4657 = phi_3947_;
                                                phi_3948_ = _e4657;
                                            } else {
                                                phi_3948_ = 0.0625f;
                                            }
                                            let _e4659 = phi_3948_;
                                            phi_3949_ = _e4659;
                                        }
                                        let _e4661 = phi_3949_;
                                        phi_3951_ = (_e4006 * _e4661);
                                        phi_3952_ = true;
                                    }
                                    let _e4664 = phi_3951_;
                                    let _e4666 = phi_3952_;
                                    phi_3953_ = _e3707;
                                    phi_3954_ = _e4664;
                                    phi_3955_ = _e3709;
                                    phi_3956_ = _e4666;
                                    phi_3957_ = _e4503;
                                    phi_3958_ = false;
                                    phi_3959_ = false;
                                } else {
                                    phi_3953_ = _e4492;
                                    phi_3954_ = _e4494;
                                    phi_3955_ = _e3705;
                                    phi_3956_ = _e4498;
                                    phi_3957_ = false;
                                    phi_3958_ = _e4500;
                                    phi_3959_ = _e4502;
                                }
                                let _e4668 = phi_3953_;
                                let _e4670 = phi_3954_;
                                let _e4672 = phi_3955_;
                                let _e4674 = phi_3956_;
                                let _e4676 = phi_3957_;
                                let _e4678 = phi_3958_;
                                let _e4680 = phi_3959_;
                                if _e4674 {
                                    let _e4681 = (_e4672 + _e4670);
                                    if (_e4681 > _e4668) {
                                        phi_3968_ = _e4681;
                                    } else {
                                        phi_3968_ = _e4668;
                                    }
                                    let _e4684 = phi_3968_;
                                    if (_e4684 < 1f) {
                                        phi_3973_ = _e4684;
                                    } else {
                                        phi_3973_ = 1f;
                                    }
                                    let _e4687 = phi_3973_;
                                    if (_e3723.member_1 > 0u) {
                                        phi_3983_ = ((_e4687 - _e4672) > 0.0000000037252903f);
                                    } else {
                                        phi_3983_ = true;
                                    }
                                    let _e4692 = phi_3983_;
                                    if _e4692 {
                                        phi_3987_ = false;
                                    } else {
                                        phi_3987_ = true;
                                    }
                                    let _e4694 = phi_3987_;
                                    phi_3988_ = _e4687;
                                    phi_3989_ = _e4692;
                                    phi_3990_ = _e4694;
                                    phi_3991_ = false;
                                    phi_3992_ = false;
                                    phi_3993_ = false;
                                } else {
                                    phi_3988_ = f32();
                                    phi_3989_ = false;
                                    phi_3990_ = false;
                                    phi_3991_ = _e4676;
                                    phi_3992_ = _e4678;
                                    phi_3993_ = _e4680;
                                }
                                let _e4696 = phi_3988_;
                                let _e4698 = phi_3989_;
                                let _e4700 = phi_3990_;
                                let _e4702 = phi_3991_;
                                let _e4704 = phi_3992_;
                                let _e4706 = phi_3993_;
                                phi_2368_ = _e4696;
                                phi_2370_ = _e4668;
                                phi_2372_ = _e4672;
                                phi_3994_ = _e4668;
                                phi_3995_ = _e4698;
                                phi_3996_ = _e4700;
                                phi_3997_ = false;
                                phi_3998_ = _e4702;
                                phi_3999_ = _e4704;
                                phi_4000_ = _e4706;
                            } else {
                                phi_2368_ = f32();
                                phi_2370_ = f32();
                                phi_2372_ = f32();
                                phi_3994_ = f32();
                                phi_3995_ = false;
                                phi_3996_ = false;
                                phi_3997_ = true;
                                phi_3998_ = false;
                                phi_3999_ = false;
                                phi_4000_ = false;
                            }
                            let _e4708 = phi_2368_;
                            let _e4710 = phi_2370_;
                            let _e4712 = phi_2372_;
                            let _e4714 = phi_3994_;
                            let _e4716 = phi_3995_;
                            let _e4718 = phi_3996_;
                            let _e4720 = phi_3997_;
                            let _e4722 = phi_3998_;
                            let _e4724 = phi_3999_;
                            let _e4726 = phi_4000_;
                            local_25 = _e4718;
                            local_43 = _e4714;
                            local_45 = _e4720;
                            local_46 = _e4722;
                            local_47 = _e4724;
                            local_48 = _e4726;
                            continue;
                            continuing {
                                phi_2364_ = _e3721;
                                phi_2367_ = _e4708;
                                phi_2369_ = _e4710;
                                phi_2371_ = _e4712;
                                break if !(_e4716);
                            }
                        }
                        let _e4729 = local_25;
                        if _e4729 {
                            let _e6042 = local_43;
                            phi_4004_ = _e6042;
                            phi_4005_ = true;
                            phi_4006_ = false;
                            phi_4007_ = false;
                            phi_4008_ = false;
                        } else {
                            let _e6044 = local_44;
                            phi_4004_ = _e6044;
                            let _e6047 = local_45;
                            phi_4005_ = _e6047;
                            let _e6050 = local_46;
                            phi_4006_ = _e6050;
                            let _e6053 = local_47;
                            phi_4007_ = _e6053;
                            let _e6056 = local_48;
                            phi_4008_ = _e6056;
                        }
                        let _e4731 = phi_4004_;
                        let _e4733 = phi_4005_;
                        let _e4735 = phi_4006_;
                        let _e4737 = phi_4007_;
                        let _e4739 = phi_4008_;
                        if _e4733 {
                            phi_4013_ = type_35(1u, _e4731);
                            phi_4014_ = false;
                            phi_4015_ = false;
                            phi_4016_ = false;
                        } else {
                            phi_4013_ = type_35();
                            phi_4014_ = _e4735;
                            phi_4015_ = _e4737;
                            phi_4016_ = _e4739;
                        }
                        let _e4742 = phi_4013_;
                        let _e4744 = phi_4014_;
                        let _e4746 = phi_4015_;
                        let _e4748 = phi_4016_;
                        if _e4744 {
                            let _e4750 = local_26;
                            phi_4021_ = type_35(1u, _e4750);
                            phi_4022_ = false;
                            phi_4023_ = false;
                        } else {
                            phi_4021_ = type_35();
                            phi_4022_ = _e4746;
                            phi_4023_ = _e4748;
                        }
                        let _e4753 = phi_4021_;
                        let _e4755 = phi_4022_;
                        let _e4757 = phi_4023_;
                        if _e4755 {
                            phi_4028_ = type_35(0u, type_35().member_1);
                            phi_4029_ = false;
                            phi_4030_ = true;
                        } else {
                            phi_4028_ = _e4753;
                            phi_4029_ = _e4757;
                            phi_4030_ = _e4744;
                        }
                        let _e4761 = phi_4028_;
                        let _e4763 = phi_4029_;
                        let _e4765 = phi_4030_;
                        if _e4763 {
                            phi_4035_ = type_35(0u, type_35().member_1);
                            phi_4036_ = true;
                        } else {
                            phi_4035_ = _e4761;
                            phi_4036_ = _e4765;
                        }
                        let _e4769 = phi_4035_;
                        let _e4771 = phi_4036_;
                        if _e4771 {
                            phi_4040_ = _e4769;
                        } else {
                            phi_4040_ = _e4742;
                        }
                        let _e4773 = phi_4040_;
                        if (_e4773.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4054_ = type_9(0u, 3u);
                            loop {
                                let _e4785 = phi_4054_;
                                if (_e4785.member < _e4785.member_1) {
                                    phi_4055_ = type_9((_e4785.member + 1u), _e4785.member_1);
                                    phi_4078_ = type_9(1u, _e4785.member);
                                } else {
                                    phi_4055_ = _e4785;
                                    phi_4078_ = type_9(0u, type_9().member_1);
                                }
                                let _e4797 = phi_4055_;
                                let _e4799 = phi_4078_;
                                if (bitcast<i32>(_e4799.member) != 0i) {
                                    let _e4805 = local_11[_e4799.member_1];
                                    let _e4806 = (_e4773.member_1 + _e4805);
                                    if (_e4806 < 1f) {
                                        phi_4098_ = _e4806;
                                    } else {
                                        phi_4098_ = 1f;
                                    }
                                    let _e4809 = phi_4098_;
                                    let _e4812 = local_12.member[0u];
                                    let _e4818 = local_12.member[1u];
                                    let _e4834 = local_12.member_1[0u];
                                    let _e4840 = local_12.member_1[1u];
                                    let _e4856 = local_12.member_2[0u];
                                    let _e4862 = local_12.member_2[1u];
                                    let _e4876 = function_1(array<f32, 3>((_e4812[0] + ((_e4818[0] - _e4812[0]) * _e4809)), (_e4812[1] + ((_e4818[1] - _e4812[1]) * _e4809)), (_e4812[2] + ((_e4818[2] - _e4812[2]) * _e4809))), array<f32, 3>((_e4834[0] + ((_e4840[0] - _e4834[0]) * _e4809)), (_e4834[1] + ((_e4840[1] - _e4834[1]) * _e4809)), (_e4834[2] + ((_e4840[2] - _e4834[2]) * _e4809))), array<f32, 3>((_e4856[0] + ((_e4862[0] - _e4856[0]) * _e4809)), (_e4856[1] + ((_e4862[1] - _e4856[1]) * _e4809)), (_e4856[2] + ((_e4862[2] - _e4856[2]) * _e4809))), 0u);
                                    let _e4887 = (((_e4876[0] * _e4876[0]) + (_e4876[1] * _e4876[1])) + (_e4876[2] * _e4876[2]));
                                    if (_e4887 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4887 > 0f) {
                                            phi_4221_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4221_ = 0f;
                                        }
                                        let _e4940 = phi_4221_;
                                        phi_4285_ = _e4940;
                                    } else {
                                        phi_4228_ = type_14(0i, 5i);
                                        phi_4231_ = bitcast<f32>(((bitcast<u32>(_e4887) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4895 = phi_4228_;
                                            let _e4897 = phi_4231_;
                                            local_27 = _e4897;
                                            if (_e4895.member < _e4895.member_1) {
                                                let _e4904 = (_e4895.member + 1i);
                                                if ((false == (_e4904 > _e4895.member)) != false) {
                                                    phi_4252_ = true;
                                                } else {
                                                    phi_4252_ = false;
                                                }
                                                let _e4909 = phi_4252_;
                                                if _e4909 {
                                                    phi_4258_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_4258_ = type_15(1u, _e4904);
                                                }
                                                let _e4914 = phi_4258_;
                                                phi_4229_ = type_14(_e4914.member_1, _e4895.member_1);
                                                phi_4272_ = type_15(1u, _e4895.member);
                                            } else {
                                                phi_4229_ = _e4895;
                                                phi_4272_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e4920 = phi_4229_;
                                            let _e4922 = phi_4272_;
                                            let _e4925 = (bitcast<i32>(_e4922.member) != 0i);
                                            if _e4925 {
                                                phi_4232_ = (0.5f * (_e4897 + (_e4887 / _e4897)));
                                            } else {
                                                phi_4232_ = f32();
                                            }
                                            let _e4930 = phi_4232_;
                                            continue;
                                            continuing {
                                                phi_4228_ = _e4920;
                                                phi_4231_ = _e4930;
                                                break if !(_e4925);
                                            }
                                        }
                                        let _e4935 = local_27;
                                        phi_4285_ = (_e4935 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4942 = phi_4285_;
                                    let _e4948 = local_12.member[0u];
                                    if (_e4948[0] < 0f) {
                                        phi_4301_ = -(_e4948[0]);
                                    } else {
                                        phi_4301_ = _e4948[0];
                                    }
                                    let _e4955 = phi_4301_;
                                    if (_e4948[1] < 0f) {
                                        phi_4308_ = -(_e4948[1]);
                                    } else {
                                        phi_4308_ = _e4948[1];
                                    }
                                    let _e4959 = phi_4308_;
                                    if (_e4955 > _e4959) {
                                        phi_4313_ = _e4955;
                                    } else {
                                        phi_4313_ = _e4959;
                                    }
                                    let _e4962 = phi_4313_;
                                    if (_e4948[2] < 0f) {
                                        phi_4320_ = -(_e4948[2]);
                                    } else {
                                        phi_4320_ = _e4948[2];
                                    }
                                    let _e4966 = phi_4320_;
                                    if (_e4962 > _e4966) {
                                        phi_4325_ = _e4962;
                                    } else {
                                        phi_4325_ = _e4966;
                                    }
                                    let _e4969 = phi_4325_;
                                    let _e4972 = local_12.member[1u];
                                    if (_e4972[0] < 0f) {
                                        phi_4338_ = -(_e4972[0]);
                                    } else {
                                        phi_4338_ = _e4972[0];
                                    }
                                    let _e4979 = phi_4338_;
                                    if (_e4972[1] < 0f) {
                                        phi_4345_ = -(_e4972[1]);
                                    } else {
                                        phi_4345_ = _e4972[1];
                                    }
                                    let _e4983 = phi_4345_;
                                    if (_e4979 > _e4983) {
                                        phi_4350_ = _e4979;
                                    } else {
                                        phi_4350_ = _e4983;
                                    }
                                    let _e4986 = phi_4350_;
                                    if (_e4972[2] < 0f) {
                                        phi_4357_ = -(_e4972[2]);
                                    } else {
                                        phi_4357_ = _e4972[2];
                                    }
                                    let _e4990 = phi_4357_;
                                    if (_e4986 > _e4990) {
                                        phi_4362_ = _e4986;
                                    } else {
                                        phi_4362_ = _e4990;
                                    }
                                    let _e4993 = phi_4362_;
                                    if (_e4969 > _e4993) {
                                        phi_4367_ = _e4969;
                                    } else {
                                        phi_4367_ = _e4993;
                                    }
                                    let _e4996 = phi_4367_;
                                    let _e4998 = local_12.member_3;
                                    let _e5002 = local_12.member_1[0u];
                                    if (_e5002[0] < 0f) {
                                        phi_4384_ = -(_e5002[0]);
                                    } else {
                                        phi_4384_ = _e5002[0];
                                    }
                                    let _e5009 = phi_4384_;
                                    if (_e5002[1] < 0f) {
                                        phi_4391_ = -(_e5002[1]);
                                    } else {
                                        phi_4391_ = _e5002[1];
                                    }
                                    let _e5013 = phi_4391_;
                                    if (_e5009 > _e5013) {
                                        phi_4396_ = _e5009;
                                    } else {
                                        phi_4396_ = _e5013;
                                    }
                                    let _e5016 = phi_4396_;
                                    if (_e5002[2] < 0f) {
                                        phi_4403_ = -(_e5002[2]);
                                    } else {
                                        phi_4403_ = _e5002[2];
                                    }
                                    let _e5020 = phi_4403_;
                                    if (_e5016 > _e5020) {
                                        phi_4408_ = _e5016;
                                    } else {
                                        phi_4408_ = _e5020;
                                    }
                                    let _e5023 = phi_4408_;
                                    let _e5026 = local_12.member_1[1u];
                                    if (_e5026[0] < 0f) {
                                        phi_4422_ = -(_e5026[0]);
                                    } else {
                                        phi_4422_ = _e5026[0];
                                    }
                                    let _e5033 = phi_4422_;
                                    if (_e5026[1] < 0f) {
                                        phi_4429_ = -(_e5026[1]);
                                    } else {
                                        phi_4429_ = _e5026[1];
                                    }
                                    let _e5037 = phi_4429_;
                                    if (_e5033 > _e5037) {
                                        phi_4434_ = _e5033;
                                    } else {
                                        phi_4434_ = _e5037;
                                    }
                                    let _e5040 = phi_4434_;
                                    if (_e5026[2] < 0f) {
                                        phi_4441_ = -(_e5026[2]);
                                    } else {
                                        phi_4441_ = _e5026[2];
                                    }
                                    let _e5044 = phi_4441_;
                                    if (_e5040 > _e5044) {
                                        phi_4446_ = _e5040;
                                    } else {
                                        phi_4446_ = _e5044;
                                    }
                                    let _e5047 = phi_4446_;
                                    if (_e5023 > _e5047) {
                                        phi_4451_ = _e5023;
                                    } else {
                                        phi_4451_ = _e5047;
                                    }
                                    let _e5050 = phi_4451_;
                                    let _e5052 = local_12.member_3;
                                    let _e5056 = local_12.member_2[0u];
                                    if (_e5056[0] < 0f) {
                                        phi_4468_ = -(_e5056[0]);
                                    } else {
                                        phi_4468_ = _e5056[0];
                                    }
                                    let _e5063 = phi_4468_;
                                    if (_e5056[1] < 0f) {
                                        phi_4475_ = -(_e5056[1]);
                                    } else {
                                        phi_4475_ = _e5056[1];
                                    }
                                    let _e5067 = phi_4475_;
                                    if (_e5063 > _e5067) {
                                        phi_4480_ = _e5063;
                                    } else {
                                        phi_4480_ = _e5067;
                                    }
                                    let _e5070 = phi_4480_;
                                    if (_e5056[2] < 0f) {
                                        phi_4487_ = -(_e5056[2]);
                                    } else {
                                        phi_4487_ = _e5056[2];
                                    }
                                    let _e5074 = phi_4487_;
                                    if (_e5070 > _e5074) {
                                        phi_4492_ = _e5070;
                                    } else {
                                        phi_4492_ = _e5074;
                                    }
                                    let _e5077 = phi_4492_;
                                    let _e5080 = local_12.member_2[1u];
                                    if (_e5080[0] < 0f) {
                                        phi_4506_ = -(_e5080[0]);
                                    } else {
                                        phi_4506_ = _e5080[0];
                                    }
                                    let _e5087 = phi_4506_;
                                    if (_e5080[1] < 0f) {
                                        phi_4513_ = -(_e5080[1]);
                                    } else {
                                        phi_4513_ = _e5080[1];
                                    }
                                    let _e5091 = phi_4513_;
                                    if (_e5087 > _e5091) {
                                        phi_4518_ = _e5087;
                                    } else {
                                        phi_4518_ = _e5091;
                                    }
                                    let _e5094 = phi_4518_;
                                    if (_e5080[2] < 0f) {
                                        phi_4525_ = -(_e5080[2]);
                                    } else {
                                        phi_4525_ = _e5080[2];
                                    }
                                    let _e5098 = phi_4525_;
                                    if (_e5094 > _e5098) {
                                        phi_4530_ = _e5094;
                                    } else {
                                        phi_4530_ = _e5098;
                                    }
                                    let _e5101 = phi_4530_;
                                    if (_e5077 > _e5101) {
                                        phi_4535_ = _e5077;
                                    } else {
                                        phi_4535_ = _e5101;
                                    }
                                    let _e5104 = phi_4535_;
                                    let _e5106 = local_12.member_3;
                                    let _e5113 = local_12.member_3;
                                    let _e5120 = (((_e4942 * (1f + (0.000000059604645f * 8f))) + (((((((_e4996 + _e4998) + (_e5050 + _e5052)) + (_e5104 + _e5106)) * (0.000000059604645f * 16f)) + (_e5113 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e452.member_1);
                                    if _e5120 {
                                        phi_4555_ = false;
                                    } else {
                                        phi_4555_ = true;
                                    }
                                    let _e5122 = phi_4555_;
                                    phi_4556_ = _e5122;
                                    phi_4557_ = _e5120;
                                } else {
                                    phi_4556_ = false;
                                    phi_4557_ = false;
                                }
                                let _e5124 = phi_4556_;
                                let _e5126 = phi_4557_;
                                local_28 = _e5126;
                                continue;
                                continuing {
                                    phi_4054_ = _e4797;
                                    break if !(_e5124);
                                }
                            }
                            let _e5129 = local_28;
                            if _e5129 {
                                phi_4562_ = type_35(1u, _e4773.member_1);
                                phi_4563_ = false;
                            } else {
                                phi_4562_ = type_35();
                                phi_4563_ = true;
                            }
                            let _e5132 = phi_4562_;
                            let _e5134 = phi_4563_;
                            if _e5134 {
                                phi_4568_ = type_35(2u, _e4773.member_1);
                                phi_4569_ = false;
                            } else {
                                phi_4568_ = type_35();
                                phi_4569_ = true;
                            }
                            let _e5137 = phi_4568_;
                            let _e5139 = phi_4569_;
                            phi_4571_ = _e5137;
                            phi_4572_ = _e5132;
                            phi_4573_ = _e5139;
                        } else {
                            phi_4571_ = type_35();
                            phi_4572_ = type_35(0u, type_35().member_1);
                            phi_4573_ = true;
                        }
                        let _e5141 = phi_4571_;
                        let _e5143 = phi_4572_;
                        let _e5145 = phi_4573_;
                        if _e5145 {
                            phi_4577_ = _e5143;
                        } else {
                            phi_4577_ = _e5141;
                        }
                        let _e5147 = phi_4577_;
                        phi_8459_ = _e5147;
                    } else {
                        if (_e590 < 0f) {
                            phi_4587_ = -(_e590);
                        } else {
                            phi_4587_ = _e590;
                        }
                        let _e933 = phi_4587_;
                        if (_e613 < 0f) {
                            phi_4593_ = -(_e613);
                        } else {
                            phi_4593_ = _e613;
                        }
                        let _e937 = phi_4593_;
                        if (_e933 > _e937) {
                            phi_4598_ = _e933;
                        } else {
                            phi_4598_ = _e937;
                        }
                        let _e940 = phi_4598_;
                        if (_e636 < 0f) {
                            phi_4604_ = -(_e636);
                        } else {
                            phi_4604_ = _e636;
                        }
                        let _e944 = phi_4604_;
                        if (_e647 < 0f) {
                            phi_4610_ = -(_e647);
                        } else {
                            phi_4610_ = _e647;
                        }
                        let _e948 = phi_4610_;
                        if (_e944 > _e948) {
                            phi_4615_ = _e944;
                        } else {
                            phi_4615_ = _e948;
                        }
                        let _e951 = phi_4615_;
                        if (_e940 > _e951) {
                            phi_4620_ = _e940;
                        } else {
                            phi_4620_ = _e951;
                        }
                        let _e954 = phi_4620_;
                        let _e955 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e954 >= _e955) {
                            phi_4628_ = (_e954 <= (1f / _e955));
                        } else {
                            phi_4628_ = false;
                        }
                        let _e960 = phi_4628_;
                        if _e960 {
                            phi_4633_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4633_ = 2f;
                        }
                        let _e963 = phi_4633_;
                        let _e965 = ((_e897 * 0.34f) + (_e954 * _e963));
                        if _e960 {
                            phi_4640_ = (1f / _e954);
                        } else {
                            phi_4640_ = 0f;
                        }
                        let _e968 = phi_4640_;
                        let _e974 = ((_e613 - (3f * _e590)) * _e968);
                        let _e975 = ((_e636 - _e613) * _e968);
                        let _e976 = (((3f * _e647) - _e636) * _e968);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e983 = ((_e975 * _e975) - (_e974 * _e976));
                        if (_e983 > 0f) {
                            if (_e983 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e983 > 0f) {
                                    phi_4673_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4673_ = 0f;
                                }
                                let _e1037 = phi_4673_;
                                phi_4737_ = _e1037;
                            } else {
                                phi_4680_ = type_14(0i, 5i);
                                phi_4683_ = bitcast<f32>(((bitcast<u32>(_e983) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e992 = phi_4680_;
                                    let _e994 = phi_4683_;
                                    local_13 = _e994;
                                    if (_e992.member < _e992.member_1) {
                                        let _e1001 = (_e992.member + 1i);
                                        if ((false == (_e1001 > _e992.member)) != false) {
                                            phi_4704_ = true;
                                        } else {
                                            phi_4704_ = false;
                                        }
                                        let _e1006 = phi_4704_;
                                        if _e1006 {
                                            phi_4710_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4710_ = type_15(1u, _e1001);
                                        }
                                        let _e1011 = phi_4710_;
                                        phi_4681_ = type_14(_e1011.member_1, _e992.member_1);
                                        phi_4724_ = type_15(1u, _e992.member);
                                    } else {
                                        phi_4681_ = _e992;
                                        phi_4724_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1017 = phi_4681_;
                                    let _e1019 = phi_4724_;
                                    let _e1022 = (bitcast<i32>(_e1019.member) != 0i);
                                    if _e1022 {
                                        phi_4684_ = (0.5f * (_e994 + (_e983 / _e994)));
                                    } else {
                                        phi_4684_ = f32();
                                    }
                                    let _e1027 = phi_4684_;
                                    continue;
                                    continuing {
                                        phi_4680_ = _e1017;
                                        phi_4683_ = _e1027;
                                        break if !(_e1022);
                                    }
                                }
                                let _e1032 = local_13;
                                phi_4737_ = (_e1032 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1039 = phi_4737_;
                            if (_e975 < 0f) {
                                phi_4743_ = -(_e1039);
                            } else {
                                phi_4743_ = _e1039;
                            }
                            let _e1043 = phi_4743_;
                            let _e1045 = -((_e975 + _e1043));
                            local_7[0u] = (_e1045 / (_e1045 + _e976));
                            local_7[1u] = (_e974 / (_e974 + _e1045));
                            let _e1054 = local_7[1u];
                            let _e1055 = local_7[0u];
                            if (_e1054 < _e1055) {
                                let _e1058 = local_7[1u];
                                let _e1060 = local_7[0u];
                                local_7[0u] = _e1058;
                                local_7[1u] = _e1060;
                            }
                            phi_4768_ = type_9(0u, 2u);
                            phi_4771_ = 1u;
                            loop {
                                let _e1064 = phi_4768_;
                                let _e1066 = phi_4771_;
                                local_29 = _e1066;
                                if (_e1064.member < _e1064.member_1) {
                                    phi_4769_ = type_9((_e1064.member + 1u), _e1064.member_1);
                                    phi_4794_ = type_9(1u, _e1064.member);
                                } else {
                                    phi_4769_ = _e1064;
                                    phi_4794_ = type_9(0u, type_9().member_1);
                                }
                                let _e1078 = phi_4769_;
                                let _e1080 = phi_4794_;
                                let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                if _e1084 {
                                    let _e1086 = local_7[_e1080.member_1];
                                    if (_e1086 > 0f) {
                                        let _e1089 = local_7[_e1080.member_1];
                                        if (_e1089 < 1f) {
                                            let _e1092 = local_7[_e1080.member_1];
                                            local_6[_e1066] = _e1092;
                                            phi_4838_ = (_e1066 + 1u);
                                        } else {
                                            phi_4838_ = _e1066;
                                        }
                                        let _e1096 = phi_4838_;
                                        phi_4839_ = _e1096;
                                    } else {
                                        phi_4839_ = _e1066;
                                    }
                                    let _e1098 = phi_4839_;
                                    phi_4772_ = _e1098;
                                } else {
                                    phi_4772_ = u32();
                                }
                                let _e1100 = phi_4772_;
                                continue;
                                continuing {
                                    phi_4768_ = _e1078;
                                    phi_4771_ = _e1100;
                                    break if !(_e1084);
                                }
                            }
                            let _e5407 = local_29;
                            phi_4840_ = _e5407;
                        } else {
                            phi_4840_ = 1u;
                        }
                        let _e1103 = phi_4840_;
                        local_6[_e1103] = 1f;
                        let _e1105 = local_6;
                        local_8 = _e1105;
                        phi_4860_ = type_9(0u, _e1103);
                        loop {
                            let _e1108 = phi_4860_;
                            if (_e1108.member < _e1108.member_1) {
                                phi_4861_ = type_9((_e1108.member + 1u), _e1108.member_1);
                                phi_4884_ = type_9(1u, _e1108.member);
                            } else {
                                phi_4861_ = _e1108;
                                phi_4884_ = type_9(0u, type_9().member_1);
                            }
                            let _e1120 = phi_4861_;
                            let _e1122 = phi_4884_;
                            if (bitcast<i32>(_e1122.member) != 0i) {
                                let _e1128 = local_8[_e1122.member_1];
                                let _e1131 = local_8[(_e1122.member_1 + 1u)];
                                let _e1132 = (1f - _e1128);
                                let _e1143 = ((((_e590 * _e1132) + (_e613 * _e1128)) * (_e1132 * _e1132)) + (((_e636 * _e1132) + (_e647 * _e1128)) * (_e1128 * _e1128)));
                                let _e1144 = (1f - _e1131);
                                let _e1155 = ((((_e590 * _e1144) + (_e613 * _e1131)) * (_e1144 * _e1144)) + (((_e636 * _e1144) + (_e647 * _e1131)) * (_e1131 * _e1131)));
                                if (_e1143 < 0f) {
                                    phi_4936_ = -(_e1143);
                                } else {
                                    phi_4936_ = _e1143;
                                }
                                let _e1159 = phi_4936_;
                                let _e1160 = (_e1159 > _e965);
                                if (_e1155 < 0f) {
                                    phi_4943_ = -(_e1155);
                                } else {
                                    phi_4943_ = _e1155;
                                }
                                let _e1164 = phi_4943_;
                                let _e1165 = (_e1164 > _e965);
                                if _e1160 {
                                    if _e1165 {
                                        phi_4954_ = ((_e1143 > 0f) != (_e1155 > 0f));
                                        phi_4955_ = false;
                                    } else {
                                        phi_4954_ = bool();
                                        phi_4955_ = true;
                                    }
                                    let _e1170 = phi_4954_;
                                    let _e1172 = phi_4955_;
                                    phi_4956_ = _e1170;
                                    phi_4957_ = _e1172;
                                } else {
                                    phi_4956_ = bool();
                                    phi_4957_ = true;
                                }
                                let _e1174 = phi_4956_;
                                let _e1176 = phi_4957_;
                                if _e1176 {
                                    phi_4961_ = false;
                                } else {
                                    phi_4961_ = _e1174;
                                }
                                let _e1178 = phi_4961_;
                                if _e1160 {
                                    if _e1165 {
                                        if _e1178 {
                                            phi_4972_ = type_37();
                                        } else {
                                            phi_4972_ = type_37(1f, 0f, _e1178);
                                        }
                                        let _e1181 = phi_4972_;
                                        phi_4973_ = _e1181;
                                        phi_4974_ = _e1178;
                                    } else {
                                        phi_4973_ = type_37();
                                        phi_4974_ = true;
                                    }
                                    let _e1183 = phi_4973_;
                                    let _e1185 = phi_4974_;
                                    phi_4975_ = _e1183;
                                    phi_4976_ = _e1185;
                                } else {
                                    phi_4975_ = type_37();
                                    phi_4976_ = true;
                                }
                                let _e1187 = phi_4975_;
                                let _e1189 = phi_4976_;
                                if _e1189 {
                                    if _e1160 {
                                        if (_e1143 < 0f) {
                                            phi_4987_ = -1f;
                                        } else {
                                            phi_4987_ = 1f;
                                        }
                                        let _e1192 = phi_4987_;
                                        let _e1195 = (_e636 - _e613);
                                        phi_4997_ = type_9(0u, 64u);
                                        phi_5000_ = _e1131;
                                        phi_5002_ = _e1128;
                                        phi_5004_ = (0.5f * (_e1128 + _e1131));
                                        loop {
                                            let _e1201 = phi_4997_;
                                            let _e1203 = phi_5000_;
                                            let _e1205 = phi_5002_;
                                            let _e1207 = phi_5004_;
                                            local_31 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_4998_ = type_9((_e1201.member + 1u), _e1201.member_1);
                                                phi_5027_ = type_9(1u, _e1201.member);
                                            } else {
                                                phi_4998_ = _e1201;
                                                phi_5027_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1219 = phi_4998_;
                                            let _e1221 = phi_5027_;
                                            if (bitcast<i32>(_e1221.member) != 0i) {
                                                let _e1225 = (1f - _e1207);
                                                let _e1238 = ((_e1192 * ((((_e590 * _e1225) + (_e613 * _e1207)) * (_e1225 * _e1225)) + (((_e636 * _e1225) + (_e647 * _e1207)) * (_e1207 * _e1207)))) - _e965);
                                                if (_e1238 > 0f) {
                                                    phi_5052_ = _e1203;
                                                    phi_5053_ = _e1207;
                                                } else {
                                                    phi_5052_ = _e1207;
                                                    phi_5053_ = _e1205;
                                                }
                                                let _e1241 = phi_5052_;
                                                let _e1243 = phi_5053_;
                                                let _e1245 = ((_e1241 - _e1243) > 0.00000000000022737368f);
                                                if _e1245 {
                                                    let _e1246 = (1f - _e1207);
                                                    let _e1258 = (-(_e1238) / (_e1192 * (((((_e613 - (3f * _e590)) * _e1246) + (_e1195 * _e1207)) * _e1246) + (((_e1195 * _e1246) + (((3f * _e647) - _e636) * _e1207)) * _e1207))));
                                                    if (_e1238 > 0f) {
                                                        phi_5079_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5079_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1264 = phi_5079_;
                                                    let _e1266 = ((_e1207 + _e1258) + _e1264);
                                                    if (_e1266 > _e1243) {
                                                        if (_e1266 < _e1241) {
                                                            if (_e1258 < 0f) {
                                                                phi_5095_ = -(_e1258);
                                                            } else {
                                                                phi_5095_ = _e1258;
                                                            }
                                                            let _e1272 = phi_5095_;
                                                            if (_e1272 < (0.5f * (_e1241 - _e1243))) {
                                                                phi_5102_ = false;
                                                            } else {
                                                                phi_5102_ = true;
                                                            }
                                                            let _e1277 = phi_5102_;
                                                            phi_5103_ = _e1277;
                                                        } else {
                                                            phi_5103_ = true;
                                                        }
                                                        let _e1279 = phi_5103_;
                                                        phi_5104_ = _e1279;
                                                    } else {
                                                        phi_5104_ = true;
                                                    }
                                                    let _e1281 = phi_5104_;
                                                    if _e1281 {
                                                        phi_5110_ = (0.5f * (_e1243 + _e1241));
                                                    } else {
                                                        phi_5110_ = _e1266;
                                                    }
                                                    let _e1285 = phi_5110_;
                                                    phi_5111_ = _e1285;
                                                    phi_5112_ = false;
                                                } else {
                                                    phi_5111_ = f32();
                                                    phi_5112_ = true;
                                                }
                                                let _e1287 = phi_5111_;
                                                let _e1289 = phi_5112_;
                                                phi_5001_ = _e1241;
                                                phi_5003_ = _e1243;
                                                phi_5005_ = _e1287;
                                                phi_5113_ = _e1243;
                                                phi_5114_ = _e1245;
                                                phi_5115_ = _e1289;
                                            } else {
                                                phi_5001_ = f32();
                                                phi_5003_ = f32();
                                                phi_5005_ = f32();
                                                phi_5113_ = f32();
                                                phi_5114_ = false;
                                                phi_5115_ = false;
                                            }
                                            let _e1291 = phi_5001_;
                                            let _e1293 = phi_5003_;
                                            let _e1295 = phi_5005_;
                                            let _e1297 = phi_5113_;
                                            let _e1299 = phi_5114_;
                                            let _e1301 = phi_5115_;
                                            local_14 = _e1301;
                                            local_30 = _e1297;
                                            continue;
                                            continuing {
                                                phi_4997_ = _e1219;
                                                phi_5000_ = _e1291;
                                                phi_5002_ = _e1293;
                                                phi_5004_ = _e1295;
                                                break if !(_e1299);
                                            }
                                        }
                                        let _e1304 = local_14;
                                        if _e1304 {
                                            let _e5449 = local_30;
                                            phi_5119_ = _e5449;
                                        } else {
                                            let _e5451 = local_31;
                                            phi_5119_ = _e5451;
                                        }
                                        let _e1306 = phi_5119_;
                                        phi_5120_ = _e1306;
                                    } else {
                                        phi_5120_ = _e1128;
                                    }
                                    let _e1308 = phi_5120_;
                                    if _e1165 {
                                        if (_e1155 < 0f) {
                                            phi_5128_ = -1f;
                                        } else {
                                            phi_5128_ = 1f;
                                        }
                                        let _e1311 = phi_5128_;
                                        phi_5132_ = type_9(0u, 64u);
                                        phi_5135_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1314 = phi_5132_;
                                            let _e1316 = phi_5135_;
                                            if (_e1314.member < _e1314.member_1) {
                                                phi_5133_ = type_9((_e1314.member + 1u), _e1314.member_1);
                                                phi_5158_ = type_9(1u, _e1314.member);
                                            } else {
                                                phi_5133_ = _e1314;
                                                phi_5158_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1328 = phi_5133_;
                                            let _e1330 = phi_5158_;
                                            if (bitcast<i32>(_e1330.member) != 0i) {
                                                let _e1334 = (_e1308 + _e1316);
                                                if (_e1334 < _e1131) {
                                                    let _e1336 = (1f - _e1334);
                                                    let _e1349 = ((_e1311 * ((((_e590 * _e1336) + (_e613 * _e1334)) * (_e1336 * _e1336)) + (((_e636 * _e1336) + (_e647 * _e1334)) * (_e1334 * _e1334)))) > _e965);
                                                    if _e1349 {
                                                        phi_5188_ = f32();
                                                        phi_5189_ = false;
                                                    } else {
                                                        phi_5188_ = (_e1316 + _e1316);
                                                        phi_5189_ = true;
                                                    }
                                                    let _e1352 = phi_5188_;
                                                    let _e1354 = phi_5189_;
                                                    phi_5190_ = _e1352;
                                                    phi_5191_ = _e1354;
                                                    phi_5192_ = _e1349;
                                                    phi_5193_ = false;
                                                } else {
                                                    phi_5190_ = f32();
                                                    phi_5191_ = false;
                                                    phi_5192_ = false;
                                                    phi_5193_ = true;
                                                }
                                                let _e1356 = phi_5190_;
                                                let _e1358 = phi_5191_;
                                                let _e1360 = phi_5192_;
                                                let _e1362 = phi_5193_;
                                                phi_5194_ = _e1334;
                                                phi_5136_ = _e1356;
                                                phi_5195_ = _e1358;
                                                phi_5196_ = _e1360;
                                                phi_5197_ = _e1362;
                                                phi_5198_ = false;
                                            } else {
                                                phi_5194_ = f32();
                                                phi_5136_ = f32();
                                                phi_5195_ = false;
                                                phi_5196_ = false;
                                                phi_5197_ = false;
                                                phi_5198_ = true;
                                            }
                                            let _e1364 = phi_5194_;
                                            let _e1366 = phi_5136_;
                                            let _e1368 = phi_5195_;
                                            let _e1370 = phi_5196_;
                                            let _e1372 = phi_5197_;
                                            let _e1374 = phi_5198_;
                                            local_15 = _e1370;
                                            local_32 = _e1372;
                                            local_33 = _e1374;
                                            local_34 = _e1364;
                                            continue;
                                            continuing {
                                                phi_5132_ = _e1328;
                                                phi_5135_ = _e1366;
                                                break if !(_e1368);
                                            }
                                        }
                                        let _e1377 = local_15;
                                        if _e1377 {
                                            phi_5202_ = false;
                                            phi_5203_ = false;
                                        } else {
                                            let _e5473 = local_32;
                                            phi_5202_ = _e5473;
                                            let _e5476 = local_33;
                                            phi_5203_ = _e5476;
                                        }
                                        let _e1379 = phi_5202_;
                                        let _e1381 = phi_5203_;
                                        if _e1379 {
                                            phi_5207_ = true;
                                        } else {
                                            phi_5207_ = _e1381;
                                        }
                                        let _e1383 = phi_5207_;
                                        if _e1383 {
                                            phi_5211_ = _e1131;
                                        } else {
                                            let _e5480 = local_34;
                                            phi_5211_ = _e5480;
                                        }
                                        let _e1385 = phi_5211_;
                                        phi_5212_ = _e1385;
                                    } else {
                                        phi_5212_ = _e1131;
                                    }
                                    let _e1387 = phi_5212_;
                                    phi_5214_ = type_37(_e1308, _e1387, _e1178);
                                } else {
                                    phi_5214_ = _e1187;
                                }
                                let _e1390 = phi_5214_;
                                if (_e1390.member > _e1390.member_1) {
                                    phi_8415_ = f32();
                                    phi_8416_ = true;
                                    phi_8417_ = false;
                                    phi_8418_ = false;
                                    phi_8419_ = false;
                                } else {
                                    let _e1397 = ((_e1390.member_1 - _e1390.member) * 0.5f);
                                    let _e1398 = (_e1390.member + _e1397);
                                    let _e1400 = (_e1397 + (0.000000059604645f * 4f));
                                    let _e1402 = local_12.member_3;
                                    let _e1405 = local_12.member[0u];
                                    if (_e1405[0] < 0f) {
                                        phi_5243_ = -(_e1405[0]);
                                    } else {
                                        phi_5243_ = _e1405[0];
                                    }
                                    let _e1412 = phi_5243_;
                                    if (_e1405[1] < 0f) {
                                        phi_5250_ = -(_e1405[1]);
                                    } else {
                                        phi_5250_ = _e1405[1];
                                    }
                                    let _e1416 = phi_5250_;
                                    if (_e1412 > _e1416) {
                                        phi_5255_ = _e1412;
                                    } else {
                                        phi_5255_ = _e1416;
                                    }
                                    let _e1419 = phi_5255_;
                                    if (_e1405[2] < 0f) {
                                        phi_5262_ = -(_e1405[2]);
                                    } else {
                                        phi_5262_ = _e1405[2];
                                    }
                                    let _e1423 = phi_5262_;
                                    if (_e1419 > _e1423) {
                                        phi_5267_ = _e1419;
                                    } else {
                                        phi_5267_ = _e1423;
                                    }
                                    let _e1426 = phi_5267_;
                                    let _e1428 = local_12.member[1u];
                                    if (_e1428[0] < 0f) {
                                        phi_5280_ = -(_e1428[0]);
                                    } else {
                                        phi_5280_ = _e1428[0];
                                    }
                                    let _e1435 = phi_5280_;
                                    if (_e1428[1] < 0f) {
                                        phi_5287_ = -(_e1428[1]);
                                    } else {
                                        phi_5287_ = _e1428[1];
                                    }
                                    let _e1439 = phi_5287_;
                                    if (_e1435 > _e1439) {
                                        phi_5292_ = _e1435;
                                    } else {
                                        phi_5292_ = _e1439;
                                    }
                                    let _e1442 = phi_5292_;
                                    if (_e1428[2] < 0f) {
                                        phi_5299_ = -(_e1428[2]);
                                    } else {
                                        phi_5299_ = _e1428[2];
                                    }
                                    let _e1446 = phi_5299_;
                                    if (_e1442 > _e1446) {
                                        phi_5304_ = _e1442;
                                    } else {
                                        phi_5304_ = _e1446;
                                    }
                                    let _e1449 = phi_5304_;
                                    if (_e1426 > _e1449) {
                                        phi_5309_ = _e1426;
                                    } else {
                                        phi_5309_ = _e1449;
                                    }
                                    let _e1452 = phi_5309_;
                                    let _e1455 = local_12.member[0u];
                                    let _e1460 = local_12.member[1u];
                                    let _e1470 = (_e1455[0] + ((_e1460[0] - _e1455[0]) * _e1398));
                                    let _e1471 = (_e1455[1] + ((_e1460[1] - _e1455[1]) * _e1398));
                                    let _e1472 = (_e1455[2] + ((_e1460[2] - _e1455[2]) * _e1398));
                                    let _e1474 = local_12.member[1u];
                                    let _e1479 = local_12.member[0u];
                                    let _e1483 = (_e1474[0] - _e1479[0]);
                                    let _e1484 = (_e1474[1] - _e1479[1]);
                                    let _e1485 = (_e1474[2] - _e1479[2]);
                                    if (_e1483 < 0f) {
                                        phi_5368_ = -(_e1483);
                                    } else {
                                        phi_5368_ = _e1483;
                                    }
                                    let _e1489 = phi_5368_;
                                    if (_e1484 < 0f) {
                                        phi_5374_ = -(_e1484);
                                    } else {
                                        phi_5374_ = _e1484;
                                    }
                                    let _e1493 = phi_5374_;
                                    if (_e1489 > _e1493) {
                                        phi_5379_ = _e1489;
                                    } else {
                                        phi_5379_ = _e1493;
                                    }
                                    let _e1496 = phi_5379_;
                                    if (_e1485 < 0f) {
                                        phi_5385_ = -(_e1485);
                                    } else {
                                        phi_5385_ = _e1485;
                                    }
                                    let _e1500 = phi_5385_;
                                    if (_e1496 > _e1500) {
                                        phi_5390_ = _e1496;
                                    } else {
                                        phi_5390_ = _e1500;
                                    }
                                    let _e1503 = phi_5390_;
                                    let _e1509 = ((((_e1400 * _e1503) * 1.01f) + ((_e1452 + _e1402) * (0.000000059604645f * 8f))) + _e1402);
                                    if (_e1470 < 0f) {
                                        phi_5402_ = -(_e1470);
                                    } else {
                                        phi_5402_ = _e1470;
                                    }
                                    let _e1513 = phi_5402_;
                                    if (_e1471 < 0f) {
                                        phi_5408_ = -(_e1471);
                                    } else {
                                        phi_5408_ = _e1471;
                                    }
                                    let _e1517 = phi_5408_;
                                    if (_e1513 > _e1517) {
                                        phi_5413_ = _e1513;
                                    } else {
                                        phi_5413_ = _e1517;
                                    }
                                    let _e1520 = phi_5413_;
                                    if (_e1472 < 0f) {
                                        phi_5419_ = -(_e1472);
                                    } else {
                                        phi_5419_ = _e1472;
                                    }
                                    let _e1524 = phi_5419_;
                                    if (_e1520 > _e1524) {
                                        phi_5424_ = _e1520;
                                    } else {
                                        phi_5424_ = _e1524;
                                    }
                                    let _e1527 = phi_5424_;
                                    local_2 = type_27(array<f32, 3>(_e1470, _e1471, _e1472), _e1509, (_e1527 + _e1509));
                                    let _e1533 = local_12.member_3;
                                    let _e1535 = local_12.member_1[0u];
                                    if (_e1535[0] < 0f) {
                                        phi_5450_ = -(_e1535[0]);
                                    } else {
                                        phi_5450_ = _e1535[0];
                                    }
                                    let _e1542 = phi_5450_;
                                    if (_e1535[1] < 0f) {
                                        phi_5457_ = -(_e1535[1]);
                                    } else {
                                        phi_5457_ = _e1535[1];
                                    }
                                    let _e1546 = phi_5457_;
                                    if (_e1542 > _e1546) {
                                        phi_5462_ = _e1542;
                                    } else {
                                        phi_5462_ = _e1546;
                                    }
                                    let _e1549 = phi_5462_;
                                    if (_e1535[2] < 0f) {
                                        phi_5469_ = -(_e1535[2]);
                                    } else {
                                        phi_5469_ = _e1535[2];
                                    }
                                    let _e1553 = phi_5469_;
                                    if (_e1549 > _e1553) {
                                        phi_5474_ = _e1549;
                                    } else {
                                        phi_5474_ = _e1553;
                                    }
                                    let _e1556 = phi_5474_;
                                    let _e1558 = local_12.member_1[1u];
                                    if (_e1558[0] < 0f) {
                                        phi_5487_ = -(_e1558[0]);
                                    } else {
                                        phi_5487_ = _e1558[0];
                                    }
                                    let _e1565 = phi_5487_;
                                    if (_e1558[1] < 0f) {
                                        phi_5494_ = -(_e1558[1]);
                                    } else {
                                        phi_5494_ = _e1558[1];
                                    }
                                    let _e1569 = phi_5494_;
                                    if (_e1565 > _e1569) {
                                        phi_5499_ = _e1565;
                                    } else {
                                        phi_5499_ = _e1569;
                                    }
                                    let _e1572 = phi_5499_;
                                    if (_e1558[2] < 0f) {
                                        phi_5506_ = -(_e1558[2]);
                                    } else {
                                        phi_5506_ = _e1558[2];
                                    }
                                    let _e1576 = phi_5506_;
                                    if (_e1572 > _e1576) {
                                        phi_5511_ = _e1572;
                                    } else {
                                        phi_5511_ = _e1576;
                                    }
                                    let _e1579 = phi_5511_;
                                    if (_e1556 > _e1579) {
                                        phi_5516_ = _e1556;
                                    } else {
                                        phi_5516_ = _e1579;
                                    }
                                    let _e1582 = phi_5516_;
                                    let _e1585 = local_12.member_1[0u];
                                    let _e1590 = local_12.member_1[1u];
                                    let _e1600 = (_e1585[0] + ((_e1590[0] - _e1585[0]) * _e1398));
                                    let _e1601 = (_e1585[1] + ((_e1590[1] - _e1585[1]) * _e1398));
                                    let _e1602 = (_e1585[2] + ((_e1590[2] - _e1585[2]) * _e1398));
                                    let _e1604 = local_12.member_1[1u];
                                    let _e1609 = local_12.member_1[0u];
                                    let _e1613 = (_e1604[0] - _e1609[0]);
                                    let _e1614 = (_e1604[1] - _e1609[1]);
                                    let _e1615 = (_e1604[2] - _e1609[2]);
                                    if (_e1613 < 0f) {
                                        phi_5575_ = -(_e1613);
                                    } else {
                                        phi_5575_ = _e1613;
                                    }
                                    let _e1619 = phi_5575_;
                                    if (_e1614 < 0f) {
                                        phi_5581_ = -(_e1614);
                                    } else {
                                        phi_5581_ = _e1614;
                                    }
                                    let _e1623 = phi_5581_;
                                    if (_e1619 > _e1623) {
                                        phi_5586_ = _e1619;
                                    } else {
                                        phi_5586_ = _e1623;
                                    }
                                    let _e1626 = phi_5586_;
                                    if (_e1615 < 0f) {
                                        phi_5592_ = -(_e1615);
                                    } else {
                                        phi_5592_ = _e1615;
                                    }
                                    let _e1630 = phi_5592_;
                                    if (_e1626 > _e1630) {
                                        phi_5597_ = _e1626;
                                    } else {
                                        phi_5597_ = _e1630;
                                    }
                                    let _e1633 = phi_5597_;
                                    let _e1639 = ((((_e1400 * _e1633) * 1.01f) + ((_e1582 + _e1533) * (0.000000059604645f * 8f))) + _e1533);
                                    if (_e1600 < 0f) {
                                        phi_5609_ = -(_e1600);
                                    } else {
                                        phi_5609_ = _e1600;
                                    }
                                    let _e1643 = phi_5609_;
                                    if (_e1601 < 0f) {
                                        phi_5615_ = -(_e1601);
                                    } else {
                                        phi_5615_ = _e1601;
                                    }
                                    let _e1647 = phi_5615_;
                                    if (_e1643 > _e1647) {
                                        phi_5620_ = _e1643;
                                    } else {
                                        phi_5620_ = _e1647;
                                    }
                                    let _e1650 = phi_5620_;
                                    if (_e1602 < 0f) {
                                        phi_5626_ = -(_e1602);
                                    } else {
                                        phi_5626_ = _e1602;
                                    }
                                    let _e1654 = phi_5626_;
                                    if (_e1650 > _e1654) {
                                        phi_5631_ = _e1650;
                                    } else {
                                        phi_5631_ = _e1654;
                                    }
                                    let _e1657 = phi_5631_;
                                    local_3 = type_27(array<f32, 3>(_e1600, _e1601, _e1602), _e1639, (_e1657 + _e1639));
                                    let _e1663 = local_12.member_3;
                                    let _e1665 = local_12.member_2[0u];
                                    if (_e1665[0] < 0f) {
                                        phi_5657_ = -(_e1665[0]);
                                    } else {
                                        phi_5657_ = _e1665[0];
                                    }
                                    let _e1672 = phi_5657_;
                                    if (_e1665[1] < 0f) {
                                        phi_5664_ = -(_e1665[1]);
                                    } else {
                                        phi_5664_ = _e1665[1];
                                    }
                                    let _e1676 = phi_5664_;
                                    if (_e1672 > _e1676) {
                                        phi_5669_ = _e1672;
                                    } else {
                                        phi_5669_ = _e1676;
                                    }
                                    let _e1679 = phi_5669_;
                                    if (_e1665[2] < 0f) {
                                        phi_5676_ = -(_e1665[2]);
                                    } else {
                                        phi_5676_ = _e1665[2];
                                    }
                                    let _e1683 = phi_5676_;
                                    if (_e1679 > _e1683) {
                                        phi_5681_ = _e1679;
                                    } else {
                                        phi_5681_ = _e1683;
                                    }
                                    let _e1686 = phi_5681_;
                                    let _e1688 = local_12.member_2[1u];
                                    if (_e1688[0] < 0f) {
                                        phi_5694_ = -(_e1688[0]);
                                    } else {
                                        phi_5694_ = _e1688[0];
                                    }
                                    let _e1695 = phi_5694_;
                                    if (_e1688[1] < 0f) {
                                        phi_5701_ = -(_e1688[1]);
                                    } else {
                                        phi_5701_ = _e1688[1];
                                    }
                                    let _e1699 = phi_5701_;
                                    if (_e1695 > _e1699) {
                                        phi_5706_ = _e1695;
                                    } else {
                                        phi_5706_ = _e1699;
                                    }
                                    let _e1702 = phi_5706_;
                                    if (_e1688[2] < 0f) {
                                        phi_5713_ = -(_e1688[2]);
                                    } else {
                                        phi_5713_ = _e1688[2];
                                    }
                                    let _e1706 = phi_5713_;
                                    if (_e1702 > _e1706) {
                                        phi_5718_ = _e1702;
                                    } else {
                                        phi_5718_ = _e1706;
                                    }
                                    let _e1709 = phi_5718_;
                                    if (_e1686 > _e1709) {
                                        phi_5723_ = _e1686;
                                    } else {
                                        phi_5723_ = _e1709;
                                    }
                                    let _e1712 = phi_5723_;
                                    let _e1715 = local_12.member_2[0u];
                                    let _e1720 = local_12.member_2[1u];
                                    let _e1730 = (_e1715[0] + ((_e1720[0] - _e1715[0]) * _e1398));
                                    let _e1731 = (_e1715[1] + ((_e1720[1] - _e1715[1]) * _e1398));
                                    let _e1732 = (_e1715[2] + ((_e1720[2] - _e1715[2]) * _e1398));
                                    let _e1734 = local_12.member_2[1u];
                                    let _e1739 = local_12.member_2[0u];
                                    let _e1743 = (_e1734[0] - _e1739[0]);
                                    let _e1744 = (_e1734[1] - _e1739[1]);
                                    let _e1745 = (_e1734[2] - _e1739[2]);
                                    if (_e1743 < 0f) {
                                        phi_5782_ = -(_e1743);
                                    } else {
                                        phi_5782_ = _e1743;
                                    }
                                    let _e1749 = phi_5782_;
                                    if (_e1744 < 0f) {
                                        phi_5788_ = -(_e1744);
                                    } else {
                                        phi_5788_ = _e1744;
                                    }
                                    let _e1753 = phi_5788_;
                                    if (_e1749 > _e1753) {
                                        phi_5793_ = _e1749;
                                    } else {
                                        phi_5793_ = _e1753;
                                    }
                                    let _e1756 = phi_5793_;
                                    if (_e1745 < 0f) {
                                        phi_5799_ = -(_e1745);
                                    } else {
                                        phi_5799_ = _e1745;
                                    }
                                    let _e1760 = phi_5799_;
                                    if (_e1756 > _e1760) {
                                        phi_5804_ = _e1756;
                                    } else {
                                        phi_5804_ = _e1760;
                                    }
                                    let _e1763 = phi_5804_;
                                    let _e1769 = ((((_e1400 * _e1763) * 1.01f) + ((_e1712 + _e1663) * (0.000000059604645f * 8f))) + _e1663);
                                    if (_e1730 < 0f) {
                                        phi_5816_ = -(_e1730);
                                    } else {
                                        phi_5816_ = _e1730;
                                    }
                                    let _e1773 = phi_5816_;
                                    if (_e1731 < 0f) {
                                        phi_5822_ = -(_e1731);
                                    } else {
                                        phi_5822_ = _e1731;
                                    }
                                    let _e1777 = phi_5822_;
                                    if (_e1773 > _e1777) {
                                        phi_5827_ = _e1773;
                                    } else {
                                        phi_5827_ = _e1777;
                                    }
                                    let _e1780 = phi_5827_;
                                    if (_e1732 < 0f) {
                                        phi_5833_ = -(_e1732);
                                    } else {
                                        phi_5833_ = _e1732;
                                    }
                                    let _e1784 = phi_5833_;
                                    if (_e1780 > _e1784) {
                                        phi_5838_ = _e1780;
                                    } else {
                                        phi_5838_ = _e1784;
                                    }
                                    let _e1787 = phi_5838_;
                                    local_4 = type_27(array<f32, 3>(_e1730, _e1731, _e1732), _e1769, (_e1787 + _e1769));
                                    let _e1792 = local_3.member;
                                    let _e1797 = local_4.member;
                                    let _e1803 = ((_e1792[1] * _e1797[2]) - (_e1792[2] * _e1797[1]));
                                    let _e1806 = ((_e1792[2] * _e1797[0]) - (_e1792[0] * _e1797[2]));
                                    let _e1809 = ((_e1792[0] * _e1797[1]) - (_e1792[1] * _e1797[0]));
                                    if (_e1803 < 0f) {
                                        phi_5887_ = -(_e1803);
                                    } else {
                                        phi_5887_ = _e1803;
                                    }
                                    let _e1813 = phi_5887_;
                                    if (_e1806 < 0f) {
                                        phi_5893_ = -(_e1806);
                                    } else {
                                        phi_5893_ = _e1806;
                                    }
                                    let _e1817 = phi_5893_;
                                    if (_e1813 > _e1817) {
                                        if (_e1803 < 0f) {
                                            phi_5903_ = -(_e1803);
                                        } else {
                                            phi_5903_ = _e1803;
                                        }
                                        let _e1835 = phi_5903_;
                                        if (_e1809 < 0f) {
                                            phi_5909_ = -(_e1809);
                                        } else {
                                            phi_5909_ = _e1809;
                                        }
                                        let _e1839 = phi_5909_;
                                        if (_e1835 > _e1839) {
                                            phi_5914_ = 2u;
                                            phi_5915_ = 1u;
                                        } else {
                                            phi_5914_ = 1u;
                                            phi_5915_ = 0u;
                                        }
                                        let _e1842 = phi_5914_;
                                        let _e1844 = phi_5915_;
                                        phi_5934_ = _e1842;
                                        phi_5935_ = _e1844;
                                    } else {
                                        if (_e1806 < 0f) {
                                            phi_5921_ = -(_e1806);
                                        } else {
                                            phi_5921_ = _e1806;
                                        }
                                        let _e1822 = phi_5921_;
                                        if (_e1809 < 0f) {
                                            phi_5927_ = -(_e1809);
                                        } else {
                                            phi_5927_ = _e1809;
                                        }
                                        let _e1826 = phi_5927_;
                                        if (_e1822 > _e1826) {
                                            phi_5932_ = 0u;
                                            phi_5933_ = 2u;
                                        } else {
                                            phi_5932_ = 1u;
                                            phi_5933_ = 0u;
                                        }
                                        let _e1829 = phi_5932_;
                                        let _e1831 = phi_5933_;
                                        phi_5934_ = _e1829;
                                        phi_5935_ = _e1831;
                                    }
                                    let _e1846 = phi_5934_;
                                    let _e1848 = phi_5935_;
                                    let _e1851 = local_3.member[_e1848];
                                    let _e1854 = local_4.member[_e1846];
                                    let _e1858 = local_3.member[_e1846];
                                    let _e1861 = local_4.member[_e1848];
                                    let _e1863 = ((_e1851 * _e1854) - (_e1858 * _e1861));
                                    let _e1865 = local_3.member_1;
                                    let _e1867 = local_4.member_2;
                                    let _e1870 = local_3.member_2;
                                    let _e1872 = local_4.member_1;
                                    let _e1877 = local_3.member_2;
                                    let _e1880 = local_4.member_2;
                                    let _e1888 = local_3.member_2;
                                    let _e1891 = local_4.member_2;
                                    let _e1895 = (((((_e1865 * _e1867) + (_e1870 * _e1872)) * 2.01f) + (((_e1877 * 2f) * (_e1880 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1888) * (1f + _e1891))));
                                    if (_e1863 < 0f) {
                                        phi_6004_ = -(_e1863);
                                    } else {
                                        phi_6004_ = _e1863;
                                    }
                                    let _e1899 = phi_6004_;
                                    if (_e1899 > _e1895) {
                                        if (_e1863 < 0f) {
                                            phi_6013_ = -1f;
                                        } else {
                                            phi_6013_ = 1f;
                                        }
                                        let _e1903 = phi_6013_;
                                        let _e1906 = local_2.member[_e1848];
                                        let _e1909 = local_4.member[_e1846];
                                        let _e1913 = local_2.member[_e1846];
                                        let _e1916 = local_4.member[_e1848];
                                        let _e1920 = local_2.member_1;
                                        let _e1922 = local_4.member_2;
                                        let _e1925 = local_2.member_2;
                                        let _e1927 = local_4.member_1;
                                        let _e1932 = local_2.member_2;
                                        let _e1935 = local_4.member_2;
                                        let _e1943 = local_2.member_2;
                                        let _e1946 = local_4.member_2;
                                        let _e1950 = (((((_e1920 * _e1922) + (_e1925 * _e1927)) * 2.01f) + (((_e1932 * 2f) * (_e1935 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1943) * (1f + _e1946))));
                                        let _e1953 = local_3.member[_e1848];
                                        let _e1956 = local_2.member[_e1846];
                                        let _e1960 = local_3.member[_e1846];
                                        let _e1963 = local_2.member[_e1848];
                                        let _e1967 = local_3.member_1;
                                        let _e1969 = local_2.member_2;
                                        let _e1972 = local_3.member_2;
                                        let _e1974 = local_2.member_1;
                                        let _e1979 = local_3.member_2;
                                        let _e1982 = local_2.member_2;
                                        let _e1990 = local_3.member_2;
                                        let _e1993 = local_2.member_2;
                                        let _e1997 = (((((_e1967 * _e1969) + (_e1972 * _e1974)) * 2.01f) + (((_e1979 * 2f) * (_e1982 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1990) * (1f + _e1993))));
                                        let _e1998 = (_e1863 * _e1903);
                                        let _e1999 = (((_e1906 * _e1909) - (_e1913 * _e1916)) * _e1903);
                                        let _e2000 = (((_e1953 * _e1956) - (_e1960 * _e1963)) * _e1903);
                                        if (_e1998 < 0f) {
                                            phi_6148_ = -(_e1998);
                                        } else {
                                            phi_6148_ = _e1998;
                                        }
                                        let _e2004 = phi_6148_;
                                        if (_e1999 < 0f) {
                                            phi_6154_ = -(_e1999);
                                        } else {
                                            phi_6154_ = _e1999;
                                        }
                                        let _e2008 = phi_6154_;
                                        if (_e2000 < 0f) {
                                            phi_6161_ = -(_e2000);
                                        } else {
                                            phi_6161_ = _e2000;
                                        }
                                        let _e2013 = phi_6161_;
                                        let _e2018 = ((_e1998 - _e1999) - _e2000);
                                        let _e2021 = (((_e1895 + _e1950) + _e1997) + (((_e2004 + _e2008) + _e2013) * (0.000000059604645f * 4f)));
                                        local_5[0u].member = _e1999;
                                        local_5[0u].member_1 = _e1950;
                                        local_5[1u].member = _e2000;
                                        local_5[1u].member_1 = _e1997;
                                        local_5[2u].member = _e2018;
                                        local_5[2u].member_1 = _e2021;
                                        local_5[3u].member = _e2018;
                                        local_5[3u].member_1 = _e2021;
                                        phi_6204_ = type_9(0u, 4u);
                                        phi_6207_ = true;
                                        loop {
                                            let _e2036 = phi_6204_;
                                            let _e2038 = phi_6207_;
                                            local_17 = _e2038;
                                            if (_e2036.member < _e2036.member_1) {
                                                phi_6205_ = type_9((_e2036.member + 1u), _e2036.member_1);
                                                phi_6230_ = type_9(1u, _e2036.member);
                                            } else {
                                                phi_6205_ = _e2036;
                                                phi_6230_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2050 = phi_6205_;
                                            let _e2052 = phi_6230_;
                                            if (bitcast<i32>(_e2052.member) != 0i) {
                                                let _e2059 = local_5[_e2052.member_1].member;
                                                let _e2062 = local_5[_e2052.member_1].member_1;
                                                let _e2064 = (_e2059 < -(_e2062));
                                                if _e2064 {
                                                    phi_6257_ = bool();
                                                    phi_6258_ = false;
                                                } else {
                                                    phi_6257_ = (_e2038 && (_e2059 > _e2062));
                                                    phi_6258_ = true;
                                                }
                                                let _e2068 = phi_6257_;
                                                let _e2070 = phi_6258_;
                                                phi_6208_ = _e2068;
                                                phi_6259_ = _e2070;
                                                phi_6260_ = _e2064;
                                            } else {
                                                phi_6208_ = bool();
                                                phi_6259_ = false;
                                                phi_6260_ = false;
                                            }
                                            let _e2072 = phi_6208_;
                                            let _e2074 = phi_6259_;
                                            let _e2076 = phi_6260_;
                                            local_16 = _e2076;
                                            continue;
                                            continuing {
                                                phi_6204_ = _e2050;
                                                phi_6207_ = _e2072;
                                                break if !(_e2074);
                                            }
                                        }
                                        let _e2079 = local_16;
                                        if _e2079 {
                                            phi_6264_ = false;
                                        } else {
                                            phi_6264_ = true;
                                        }
                                        let _e2081 = phi_6264_;
                                        if _e2081 {
                                            let _e2083 = local_17;
                                            if _e2083 {
                                                phi_6271_ = 1u;
                                            } else {
                                                phi_6271_ = 2u;
                                            }
                                            let _e2085 = phi_6271_;
                                            phi_6272_ = _e2085;
                                            phi_6273_ = false;
                                        } else {
                                            phi_6272_ = u32();
                                            phi_6273_ = true;
                                        }
                                        let _e2087 = phi_6272_;
                                        let _e2089 = phi_6273_;
                                        phi_6274_ = _e2087;
                                        phi_6275_ = 0u;
                                        phi_6276_ = _e2089;
                                    } else {
                                        phi_6274_ = u32();
                                        phi_6275_ = 2u;
                                        phi_6276_ = true;
                                    }
                                    let _e2091 = phi_6274_;
                                    let _e2093 = phi_6275_;
                                    let _e2095 = phi_6276_;
                                    if _e2095 {
                                        phi_6280_ = _e2093;
                                    } else {
                                        phi_6280_ = _e2091;
                                    }
                                    let _e2097 = phi_6280_;
                                    let _e2098 = (_e2097 == 0u);
                                    if _e2098 {
                                        phi_8411_ = f32();
                                        phi_8412_ = false;
                                        phi_8413_ = false;
                                        phi_8414_ = false;
                                    } else {
                                        if (_e2097 == 1u) {
                                            if _e1390.member_2 {
                                                if ((_e1390.member_1 - _e1390.member) <= 0.0000005f) {
                                                    phi_6300_ = false;
                                                } else {
                                                    phi_6300_ = true;
                                                }
                                                let _e2106 = phi_6300_;
                                                phi_6301_ = _e2106;
                                            } else {
                                                phi_6301_ = true;
                                            }
                                            let _e2108 = phi_6301_;
                                            phi_6302_ = _e2108;
                                        } else {
                                            phi_6302_ = true;
                                        }
                                        let _e2110 = phi_6302_;
                                        if _e2110 {
                                            let _e2115 = local_12.member[0u];
                                            let _e2121 = local_12.member_1[0u];
                                            let _e2127 = local_12.member_2[0u];
                                            let _e2139 = local_12.member[1u];
                                            let _e2145 = local_12.member_1[1u];
                                            let _e2151 = local_12.member_2[1u];
                                            let _e2163 = local_12.member[0u];
                                            if (_e2163[0] < 0f) {
                                                phi_6450_ = -(_e2163[0]);
                                            } else {
                                                phi_6450_ = _e2163[0];
                                            }
                                            let _e2170 = phi_6450_;
                                            if (_e2163[1] < 0f) {
                                                phi_6457_ = -(_e2163[1]);
                                            } else {
                                                phi_6457_ = _e2163[1];
                                            }
                                            let _e2174 = phi_6457_;
                                            if (_e2170 > _e2174) {
                                                phi_6462_ = _e2170;
                                            } else {
                                                phi_6462_ = _e2174;
                                            }
                                            let _e2177 = phi_6462_;
                                            if (_e2163[2] < 0f) {
                                                phi_6469_ = -(_e2163[2]);
                                            } else {
                                                phi_6469_ = _e2163[2];
                                            }
                                            let _e2181 = phi_6469_;
                                            if (_e2177 > _e2181) {
                                                phi_6474_ = _e2177;
                                            } else {
                                                phi_6474_ = _e2181;
                                            }
                                            let _e2184 = phi_6474_;
                                            let _e2187 = local_12.member[1u];
                                            if (_e2187[0] < 0f) {
                                                phi_6487_ = -(_e2187[0]);
                                            } else {
                                                phi_6487_ = _e2187[0];
                                            }
                                            let _e2194 = phi_6487_;
                                            if (_e2187[1] < 0f) {
                                                phi_6494_ = -(_e2187[1]);
                                            } else {
                                                phi_6494_ = _e2187[1];
                                            }
                                            let _e2198 = phi_6494_;
                                            if (_e2194 > _e2198) {
                                                phi_6499_ = _e2194;
                                            } else {
                                                phi_6499_ = _e2198;
                                            }
                                            let _e2201 = phi_6499_;
                                            if (_e2187[2] < 0f) {
                                                phi_6506_ = -(_e2187[2]);
                                            } else {
                                                phi_6506_ = _e2187[2];
                                            }
                                            let _e2205 = phi_6506_;
                                            if (_e2201 > _e2205) {
                                                phi_6511_ = _e2201;
                                            } else {
                                                phi_6511_ = _e2205;
                                            }
                                            let _e2208 = phi_6511_;
                                            if (_e2184 > _e2208) {
                                                phi_6516_ = _e2184;
                                            } else {
                                                phi_6516_ = _e2208;
                                            }
                                            let _e2211 = phi_6516_;
                                            let _e2213 = local_12.member_3;
                                            let _e2217 = local_12.member_1[0u];
                                            if (_e2217[0] < 0f) {
                                                phi_6533_ = -(_e2217[0]);
                                            } else {
                                                phi_6533_ = _e2217[0];
                                            }
                                            let _e2224 = phi_6533_;
                                            if (_e2217[1] < 0f) {
                                                phi_6540_ = -(_e2217[1]);
                                            } else {
                                                phi_6540_ = _e2217[1];
                                            }
                                            let _e2228 = phi_6540_;
                                            if (_e2224 > _e2228) {
                                                phi_6545_ = _e2224;
                                            } else {
                                                phi_6545_ = _e2228;
                                            }
                                            let _e2231 = phi_6545_;
                                            if (_e2217[2] < 0f) {
                                                phi_6552_ = -(_e2217[2]);
                                            } else {
                                                phi_6552_ = _e2217[2];
                                            }
                                            let _e2235 = phi_6552_;
                                            if (_e2231 > _e2235) {
                                                phi_6557_ = _e2231;
                                            } else {
                                                phi_6557_ = _e2235;
                                            }
                                            let _e2238 = phi_6557_;
                                            let _e2241 = local_12.member_1[1u];
                                            if (_e2241[0] < 0f) {
                                                phi_6571_ = -(_e2241[0]);
                                            } else {
                                                phi_6571_ = _e2241[0];
                                            }
                                            let _e2248 = phi_6571_;
                                            if (_e2241[1] < 0f) {
                                                phi_6578_ = -(_e2241[1]);
                                            } else {
                                                phi_6578_ = _e2241[1];
                                            }
                                            let _e2252 = phi_6578_;
                                            if (_e2248 > _e2252) {
                                                phi_6583_ = _e2248;
                                            } else {
                                                phi_6583_ = _e2252;
                                            }
                                            let _e2255 = phi_6583_;
                                            if (_e2241[2] < 0f) {
                                                phi_6590_ = -(_e2241[2]);
                                            } else {
                                                phi_6590_ = _e2241[2];
                                            }
                                            let _e2259 = phi_6590_;
                                            if (_e2255 > _e2259) {
                                                phi_6595_ = _e2255;
                                            } else {
                                                phi_6595_ = _e2259;
                                            }
                                            let _e2262 = phi_6595_;
                                            if (_e2238 > _e2262) {
                                                phi_6600_ = _e2238;
                                            } else {
                                                phi_6600_ = _e2262;
                                            }
                                            let _e2265 = phi_6600_;
                                            let _e2267 = local_12.member_3;
                                            let _e2271 = local_12.member_2[0u];
                                            if (_e2271[0] < 0f) {
                                                phi_6617_ = -(_e2271[0]);
                                            } else {
                                                phi_6617_ = _e2271[0];
                                            }
                                            let _e2278 = phi_6617_;
                                            if (_e2271[1] < 0f) {
                                                phi_6624_ = -(_e2271[1]);
                                            } else {
                                                phi_6624_ = _e2271[1];
                                            }
                                            let _e2282 = phi_6624_;
                                            if (_e2278 > _e2282) {
                                                phi_6629_ = _e2278;
                                            } else {
                                                phi_6629_ = _e2282;
                                            }
                                            let _e2285 = phi_6629_;
                                            if (_e2271[2] < 0f) {
                                                phi_6636_ = -(_e2271[2]);
                                            } else {
                                                phi_6636_ = _e2271[2];
                                            }
                                            let _e2289 = phi_6636_;
                                            if (_e2285 > _e2289) {
                                                phi_6641_ = _e2285;
                                            } else {
                                                phi_6641_ = _e2289;
                                            }
                                            let _e2292 = phi_6641_;
                                            let _e2295 = local_12.member_2[1u];
                                            if (_e2295[0] < 0f) {
                                                phi_6655_ = -(_e2295[0]);
                                            } else {
                                                phi_6655_ = _e2295[0];
                                            }
                                            let _e2302 = phi_6655_;
                                            if (_e2295[1] < 0f) {
                                                phi_6662_ = -(_e2295[1]);
                                            } else {
                                                phi_6662_ = _e2295[1];
                                            }
                                            let _e2306 = phi_6662_;
                                            if (_e2302 > _e2306) {
                                                phi_6667_ = _e2302;
                                            } else {
                                                phi_6667_ = _e2306;
                                            }
                                            let _e2309 = phi_6667_;
                                            if (_e2295[2] < 0f) {
                                                phi_6674_ = -(_e2295[2]);
                                            } else {
                                                phi_6674_ = _e2295[2];
                                            }
                                            let _e2313 = phi_6674_;
                                            if (_e2309 > _e2313) {
                                                phi_6679_ = _e2309;
                                            } else {
                                                phi_6679_ = _e2313;
                                            }
                                            let _e2316 = phi_6679_;
                                            if (_e2292 > _e2316) {
                                                phi_6684_ = _e2292;
                                            } else {
                                                phi_6684_ = _e2316;
                                            }
                                            let _e2319 = phi_6684_;
                                            let _e2321 = local_12.member_3;
                                            let _e2328 = local_12.member_3;
                                            local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6723_ = type_9(0u, 96u);
                                            phi_6726_ = _e1390.member;
                                            phi_6728_ = _e1390.member;
                                            phi_6730_ = _e1390.member;
                                            loop {
                                                let _e2334 = phi_6723_;
                                                let _e2336 = phi_6726_;
                                                let _e2338 = phi_6728_;
                                                let _e2340 = phi_6730_;
                                                local_36 = _e2338;
                                                local_20 = _e2336;
                                                if (_e2334.member < _e2334.member_1) {
                                                    phi_6724_ = type_9((_e2334.member + 1u), _e2334.member_1);
                                                    phi_6753_ = type_9(1u, _e2334.member);
                                                } else {
                                                    phi_6724_ = _e2334;
                                                    phi_6753_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2352 = phi_6724_;
                                                let _e2354 = phi_6753_;
                                                if (bitcast<i32>(_e2354.member) != 0i) {
                                                    let _e2361 = local_12.member[0u];
                                                    let _e2367 = local_12.member[1u];
                                                    let _e2383 = local_12.member_1[0u];
                                                    let _e2389 = local_12.member_1[1u];
                                                    let _e2405 = local_12.member_2[0u];
                                                    let _e2411 = local_12.member_2[1u];
                                                    let _e2425 = function_1(array<f32, 3>((_e2361[0] + ((_e2367[0] - _e2361[0]) * _e2336)), (_e2361[1] + ((_e2367[1] - _e2361[1]) * _e2336)), (_e2361[2] + ((_e2367[2] - _e2361[2]) * _e2336))), array<f32, 3>((_e2383[0] + ((_e2389[0] - _e2383[0]) * _e2336)), (_e2383[1] + ((_e2389[1] - _e2383[1]) * _e2336)), (_e2383[2] + ((_e2389[2] - _e2383[2]) * _e2336))), array<f32, 3>((_e2405[0] + ((_e2411[0] - _e2405[0]) * _e2336)), (_e2405[1] + ((_e2411[1] - _e2405[1]) * _e2336)), (_e2405[2] + ((_e2411[2] - _e2405[2]) * _e2336))), 0u);
                                                    if (_e2425[0] < 0f) {
                                                        phi_6865_ = -(_e2425[0]);
                                                    } else {
                                                        phi_6865_ = _e2425[0];
                                                    }
                                                    let _e2430 = phi_6865_;
                                                    if (_e2425[1] < 0f) {
                                                        phi_6872_ = -(_e2425[1]);
                                                    } else {
                                                        phi_6872_ = _e2425[1];
                                                    }
                                                    let _e2435 = phi_6872_;
                                                    if (_e2425[2] < 0f) {
                                                        phi_6880_ = -(_e2425[2]);
                                                    } else {
                                                        phi_6880_ = _e2425[2];
                                                    }
                                                    let _e2441 = phi_6880_;
                                                    let _e2442 = ((_e2430 + _e2435) + _e2441);
                                                    if (_e2442 > 0f) {
                                                        if ((bitcast<u32>(_e2442) & 2139095040u) != 2139095040u) {
                                                            let _e2447 = (1f / _e2442);
                                                            let _e2449 = (_e2425[0] * _e2447);
                                                            let _e2451 = (_e2425[1] * _e2447);
                                                            let _e2453 = (_e2425[2] * _e2447);
                                                            let _e2458 = (((_e2449 * _e2449) + (_e2451 * _e2451)) + (_e2453 * _e2453));
                                                            if (_e2458 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2458 > 0f) {
                                                                    phi_6917_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6917_ = 0f;
                                                                }
                                                                let _e2511 = phi_6917_;
                                                                phi_6981_ = _e2511;
                                                            } else {
                                                                phi_6924_ = type_14(0i, 5i);
                                                                phi_6927_ = bitcast<f32>(((bitcast<u32>(_e2458) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2466 = phi_6924_;
                                                                    let _e2468 = phi_6927_;
                                                                    local_18 = _e2468;
                                                                    if (_e2466.member < _e2466.member_1) {
                                                                        let _e2475 = (_e2466.member + 1i);
                                                                        if ((false == (_e2475 > _e2466.member)) != false) {
                                                                            phi_6948_ = true;
                                                                        } else {
                                                                            phi_6948_ = false;
                                                                        }
                                                                        let _e2480 = phi_6948_;
                                                                        if _e2480 {
                                                                            phi_6954_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_6954_ = type_15(1u, _e2475);
                                                                        }
                                                                        let _e2485 = phi_6954_;
                                                                        phi_6925_ = type_14(_e2485.member_1, _e2466.member_1);
                                                                        phi_6968_ = type_15(1u, _e2466.member);
                                                                    } else {
                                                                        phi_6925_ = _e2466;
                                                                        phi_6968_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2491 = phi_6925_;
                                                                    let _e2493 = phi_6968_;
                                                                    let _e2496 = (bitcast<i32>(_e2493.member) != 0i);
                                                                    if _e2496 {
                                                                        phi_6928_ = (0.5f * (_e2468 + (_e2458 / _e2468)));
                                                                    } else {
                                                                        phi_6928_ = f32();
                                                                    }
                                                                    let _e2501 = phi_6928_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6924_ = _e2491;
                                                                        phi_6927_ = _e2501;
                                                                        break if !(_e2496);
                                                                    }
                                                                }
                                                                let _e2506 = local_18;
                                                                phi_6981_ = (_e2506 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2513 = phi_6981_;
                                                            let _e2514 = (0.000000059604645f * 12f);
                                                            let _e2519 = ((((((((_e2211 + _e2213) + (_e2265 + _e2267)) + (_e2319 + _e2321)) * (0.000000059604645f * 16f)) + (_e2328 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2513) * (1f + _e2514)));
                                                            let _e2524 = (((_e2449 * _e2115[0]) + (_e2451 * _e2115[1])) + (_e2453 * _e2115[2]));
                                                            let _e2529 = (((_e2449 * (_e2115[0] - _e2121[0])) + (_e2451 * (_e2115[1] - _e2121[1]))) + (_e2453 * (_e2115[2] - _e2121[2])));
                                                            let _e2534 = (((_e2449 * (_e2115[0] - _e2127[0])) + (_e2451 * (_e2115[1] - _e2127[1]))) + (_e2453 * (_e2115[2] - _e2127[2])));
                                                            let _e2539 = (((_e2449 * _e2115[0]) + (_e2451 * _e2115[1])) + (_e2453 * _e2115[2]));
                                                            let _e2545 = (((_e2449 * _e2139[0]) + (_e2451 * _e2139[1])) + (_e2453 * _e2139[2]));
                                                            let _e2550 = (((_e2449 * (_e2139[0] - _e2145[0])) + (_e2451 * (_e2139[1] - _e2145[1]))) + (_e2453 * (_e2139[2] - _e2145[2])));
                                                            let _e2555 = (((_e2449 * (_e2139[0] - _e2151[0])) + (_e2451 * (_e2139[1] - _e2151[1]))) + (_e2453 * (_e2139[2] - _e2151[2])));
                                                            let _e2560 = (((_e2449 * _e2139[0]) + (_e2451 * _e2139[1])) + (_e2453 * _e2139[2]));
                                                            if (_e2524 < 0f) {
                                                                phi_7047_ = -(_e2524);
                                                            } else {
                                                                phi_7047_ = _e2524;
                                                            }
                                                            let _e2565 = phi_7047_;
                                                            if (_e2545 < 0f) {
                                                                phi_7053_ = -(_e2545);
                                                            } else {
                                                                phi_7053_ = _e2545;
                                                            }
                                                            let _e2569 = phi_7053_;
                                                            if (_e2529 < 0f) {
                                                                phi_7062_ = -(_e2529);
                                                            } else {
                                                                phi_7062_ = _e2529;
                                                            }
                                                            let _e2576 = phi_7062_;
                                                            if (_e2550 < 0f) {
                                                                phi_7068_ = -(_e2550);
                                                            } else {
                                                                phi_7068_ = _e2550;
                                                            }
                                                            let _e2580 = phi_7068_;
                                                            if (_e2534 < 0f) {
                                                                phi_7077_ = -(_e2534);
                                                            } else {
                                                                phi_7077_ = _e2534;
                                                            }
                                                            let _e2587 = phi_7077_;
                                                            if (_e2555 < 0f) {
                                                                phi_7083_ = -(_e2555);
                                                            } else {
                                                                phi_7083_ = _e2555;
                                                            }
                                                            let _e2591 = phi_7083_;
                                                            if (_e2539 < 0f) {
                                                                phi_7092_ = -(_e2539);
                                                            } else {
                                                                phi_7092_ = _e2539;
                                                            }
                                                            let _e2598 = phi_7092_;
                                                            if (_e2560 < 0f) {
                                                                phi_7098_ = -(_e2560);
                                                            } else {
                                                                phi_7098_ = _e2560;
                                                            }
                                                            let _e2602 = phi_7098_;
                                                            phi_7104_ = type_30(array<f32, 4>(_e2524, _e2529, _e2534, _e2539), array<f32, 4>(_e2545, _e2550, _e2555, _e2560), array<f32, 4>((_e2519 + ((_e2565 + _e2569) * _e2514)), (_e2519 + ((_e2576 + _e2580) * _e2514)), (_e2519 + ((_e2587 + _e2591) * _e2514)), (_e2519 + ((_e2598 + _e2602) * _e2514))));
                                                            phi_7105_ = false;
                                                        } else {
                                                            phi_7104_ = type_30();
                                                            phi_7105_ = true;
                                                        }
                                                        let _e2609 = phi_7104_;
                                                        let _e2611 = phi_7105_;
                                                        phi_7106_ = _e2609;
                                                        phi_7107_ = _e2611;
                                                    } else {
                                                        phi_7106_ = type_30();
                                                        phi_7107_ = true;
                                                    }
                                                    let _e2613 = phi_7106_;
                                                    let _e2615 = phi_7107_;
                                                    if _e2615 {
                                                        phi_7115_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7115_ = _e2613;
                                                    }
                                                    let _e2617 = phi_7115_;
                                                    local_1 = type_30(array<f32, 4>(_e2617.member[0], _e2617.member[1], _e2617.member[2], _e2617.member[3]), array<f32, 4>(_e2617.member_1[0], _e2617.member_1[1], _e2617.member_1[2], _e2617.member_1[3]), array<f32, 4>(_e2617.member_2[0], _e2617.member_2[1], _e2617.member_2[2], _e2617.member_2[3]));
                                                    let _e2637 = (_e2336 - _e2340);
                                                    let _e2640 = local_1.member[0u];
                                                    let _e2643 = local_1.member_1[0u];
                                                    let _e2646 = local_1.member[0u];
                                                    let _e2652 = local_1.member_2[0u];
                                                    if (((_e2640 + ((_e2643 - _e2646) * _e2336)) - _e2652) > 0f) {
                                                        let _e2657 = local_1.member[1u];
                                                        let _e2660 = local_1.member_1[1u];
                                                        let _e2663 = local_1.member[1u];
                                                        let _e2669 = local_1.member_2[1u];
                                                        if (((_e2657 + ((_e2660 - _e2663) * _e2336)) - _e2669) > 0f) {
                                                            let _e2674 = local_1.member[2u];
                                                            let _e2677 = local_1.member_1[2u];
                                                            let _e2680 = local_1.member[2u];
                                                            let _e2686 = local_1.member_2[2u];
                                                            if (((_e2674 + ((_e2677 - _e2680) * _e2336)) - _e2686) > 0f) {
                                                                let _e2691 = local_1.member[3u];
                                                                let _e2694 = local_1.member_1[3u];
                                                                let _e2697 = local_1.member[3u];
                                                                let _e2703 = local_1.member_2[3u];
                                                                phi_7285_ = (((_e2691 + ((_e2694 - _e2697) * _e2336)) - _e2703) > 0f);
                                                                phi_7286_ = false;
                                                            } else {
                                                                phi_7285_ = bool();
                                                                phi_7286_ = true;
                                                            }
                                                            let _e2707 = phi_7285_;
                                                            let _e2709 = phi_7286_;
                                                            phi_7287_ = _e2707;
                                                            phi_7288_ = _e2709;
                                                        } else {
                                                            phi_7287_ = bool();
                                                            phi_7288_ = true;
                                                        }
                                                        let _e2711 = phi_7287_;
                                                        let _e2713 = phi_7288_;
                                                        phi_7289_ = _e2711;
                                                        phi_7290_ = _e2713;
                                                    } else {
                                                        phi_7289_ = bool();
                                                        phi_7290_ = true;
                                                    }
                                                    let _e2715 = phi_7289_;
                                                    let _e2717 = phi_7290_;
                                                    if _e2717 {
                                                        phi_7294_ = false;
                                                    } else {
                                                        phi_7294_ = _e2715;
                                                    }
                                                    let _e2719 = phi_7294_;
                                                    if _e2719 {
                                                        if (_e2336 <= _e2338) {
                                                            phi_7604_ = true;
                                                        } else {
                                                            let _e2723 = local.member[0u];
                                                            let _e2726 = local.member_1[0u];
                                                            let _e2729 = local.member[0u];
                                                            let _e2735 = local.member_2[0u];
                                                            let _e2739 = local_1.member[0u];
                                                            let _e2742 = local_1.member_1[0u];
                                                            let _e2745 = local_1.member[0u];
                                                            let _e2751 = local_1.member_2[0u];
                                                            if ((((_e2723 + ((_e2726 - _e2729) * _e2336)) - _e2735) + ((_e2739 + ((_e2742 - _e2745) * _e2340)) - _e2751)) > 0f) {
                                                                let _e2757 = local.member[1u];
                                                                let _e2760 = local.member_1[1u];
                                                                let _e2763 = local.member[1u];
                                                                let _e2769 = local.member_2[1u];
                                                                let _e2773 = local_1.member[1u];
                                                                let _e2776 = local_1.member_1[1u];
                                                                let _e2779 = local_1.member[1u];
                                                                let _e2785 = local_1.member_2[1u];
                                                                if ((((_e2757 + ((_e2760 - _e2763) * _e2336)) - _e2769) + ((_e2773 + ((_e2776 - _e2779) * _e2340)) - _e2785)) > 0f) {
                                                                    let _e2791 = local.member[2u];
                                                                    let _e2794 = local.member_1[2u];
                                                                    let _e2797 = local.member[2u];
                                                                    let _e2803 = local.member_2[2u];
                                                                    let _e2807 = local_1.member[2u];
                                                                    let _e2810 = local_1.member_1[2u];
                                                                    let _e2813 = local_1.member[2u];
                                                                    let _e2819 = local_1.member_2[2u];
                                                                    if ((((_e2791 + ((_e2794 - _e2797) * _e2336)) - _e2803) + ((_e2807 + ((_e2810 - _e2813) * _e2340)) - _e2819)) > 0f) {
                                                                        let _e2825 = local.member[3u];
                                                                        let _e2828 = local.member_1[3u];
                                                                        let _e2831 = local.member[3u];
                                                                        let _e2837 = local.member_2[3u];
                                                                        let _e2841 = local_1.member[3u];
                                                                        let _e2844 = local_1.member_1[3u];
                                                                        let _e2847 = local_1.member[3u];
                                                                        let _e2853 = local_1.member_2[3u];
                                                                        phi_7591_ = ((((_e2825 + ((_e2828 - _e2831) * _e2336)) - _e2837) + ((_e2841 + ((_e2844 - _e2847) * _e2340)) - _e2853)) > 0f);
                                                                        phi_7592_ = false;
                                                                    } else {
                                                                        phi_7591_ = bool();
                                                                        phi_7592_ = true;
                                                                    }
                                                                    let _e2858 = phi_7591_;
                                                                    let _e2860 = phi_7592_;
                                                                    phi_7593_ = _e2858;
                                                                    phi_7594_ = _e2860;
                                                                } else {
                                                                    phi_7593_ = bool();
                                                                    phi_7594_ = true;
                                                                }
                                                                let _e2862 = phi_7593_;
                                                                let _e2864 = phi_7594_;
                                                                phi_7595_ = _e2862;
                                                                phi_7596_ = _e2864;
                                                            } else {
                                                                phi_7595_ = bool();
                                                                phi_7596_ = true;
                                                            }
                                                            let _e2866 = phi_7595_;
                                                            let _e2868 = phi_7596_;
                                                            if _e2868 {
                                                                phi_7600_ = false;
                                                            } else {
                                                                phi_7600_ = _e2866;
                                                            }
                                                            let _e2870 = phi_7600_;
                                                            phi_7604_ = _e2870;
                                                        }
                                                        let _e2872 = phi_7604_;
                                                        if _e2872 {
                                                            if (_e2354.member_1 > 0u) {
                                                                if (_e2336 >= _e1390.member_1) {
                                                                    phi_7616_ = false;
                                                                } else {
                                                                    phi_7616_ = true;
                                                                }
                                                                let _e2876 = phi_7616_;
                                                                phi_7617_ = _e2876;
                                                            } else {
                                                                phi_7617_ = true;
                                                            }
                                                            let _e2878 = phi_7617_;
                                                            if _e2878 {
                                                                local = type_30(array<f32, 4>(_e2617.member[0], _e2617.member[1], _e2617.member[2], _e2617.member[3]), array<f32, 4>(_e2617.member_1[0], _e2617.member_1[1], _e2617.member_1[2], _e2617.member_1[3]), array<f32, 4>(_e2617.member_2[0], _e2617.member_2[1], _e2617.member_2[2], _e2617.member_2[3]));
                                                                let _e2900 = local.member[0u];
                                                                let _e2903 = local.member_1[0u];
                                                                let _e2906 = local.member_2[0u];
                                                                if (_e2900 > _e2906) {
                                                                    if (_e2903 > _e2906) {
                                                                        phi_7691_ = false;
                                                                    } else {
                                                                        phi_7691_ = true;
                                                                    }
                                                                    let _e2910 = phi_7691_;
                                                                    phi_7692_ = _e2910;
                                                                } else {
                                                                    phi_7692_ = true;
                                                                }
                                                                let _e2912 = phi_7692_;
                                                                if _e2912 {
                                                                    let _e2913 = (_e2903 >= _e2900);
                                                                    if _e2913 {
                                                                        phi_7714_ = f32();
                                                                        phi_7715_ = false;
                                                                    } else {
                                                                        if ((_e2900 - _e2903) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7712_ = (((_e2900 - _e2906) / (_e2900 - _e2903)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7713_ = false;
                                                                        } else {
                                                                            phi_7712_ = f32();
                                                                            phi_7713_ = true;
                                                                        }
                                                                        let _e2924 = phi_7712_;
                                                                        let _e2926 = phi_7713_;
                                                                        phi_7714_ = _e2924;
                                                                        phi_7715_ = _e2926;
                                                                    }
                                                                    let _e2928 = phi_7714_;
                                                                    let _e2930 = phi_7715_;
                                                                    phi_7716_ = _e2928;
                                                                    phi_7717_ = _e2913;
                                                                    phi_7718_ = _e2930;
                                                                } else {
                                                                    phi_7716_ = f32();
                                                                    phi_7717_ = true;
                                                                    phi_7718_ = false;
                                                                }
                                                                let _e2932 = phi_7716_;
                                                                let _e2934 = phi_7717_;
                                                                let _e2936 = phi_7718_;
                                                                if _e2934 {
                                                                    phi_7722_ = 2f;
                                                                    phi_7723_ = true;
                                                                } else {
                                                                    phi_7722_ = _e2336;
                                                                    phi_7723_ = _e2936;
                                                                }
                                                                let _e2938 = phi_7722_;
                                                                let _e2940 = phi_7723_;
                                                                if _e2940 {
                                                                    phi_7727_ = _e2938;
                                                                } else {
                                                                    phi_7727_ = _e2932;
                                                                }
                                                                let _e2942 = phi_7727_;
                                                                let _e2945 = local.member[1u];
                                                                let _e2948 = local.member_1[1u];
                                                                let _e2951 = local.member_2[1u];
                                                                if (_e2945 > _e2951) {
                                                                    if (_e2948 > _e2951) {
                                                                        phi_7759_ = false;
                                                                    } else {
                                                                        phi_7759_ = true;
                                                                    }
                                                                    let _e2955 = phi_7759_;
                                                                    phi_7760_ = _e2955;
                                                                } else {
                                                                    phi_7760_ = true;
                                                                }
                                                                let _e2957 = phi_7760_;
                                                                if _e2957 {
                                                                    let _e2958 = (_e2948 >= _e2945);
                                                                    if _e2958 {
                                                                        phi_7782_ = f32();
                                                                        phi_7783_ = false;
                                                                    } else {
                                                                        if ((_e2945 - _e2948) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7780_ = (((_e2945 - _e2951) / (_e2945 - _e2948)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7781_ = false;
                                                                        } else {
                                                                            phi_7780_ = f32();
                                                                            phi_7781_ = true;
                                                                        }
                                                                        let _e2969 = phi_7780_;
                                                                        let _e2971 = phi_7781_;
                                                                        phi_7782_ = _e2969;
                                                                        phi_7783_ = _e2971;
                                                                    }
                                                                    let _e2973 = phi_7782_;
                                                                    let _e2975 = phi_7783_;
                                                                    phi_7784_ = _e2973;
                                                                    phi_7785_ = _e2958;
                                                                    phi_7786_ = _e2975;
                                                                } else {
                                                                    phi_7784_ = f32();
                                                                    phi_7785_ = true;
                                                                    phi_7786_ = false;
                                                                }
                                                                let _e2977 = phi_7784_;
                                                                let _e2979 = phi_7785_;
                                                                let _e2981 = phi_7786_;
                                                                if _e2979 {
                                                                    phi_7790_ = 2f;
                                                                    phi_7791_ = true;
                                                                } else {
                                                                    phi_7790_ = _e2336;
                                                                    phi_7791_ = _e2981;
                                                                }
                                                                let _e2983 = phi_7790_;
                                                                let _e2985 = phi_7791_;
                                                                if _e2985 {
                                                                    phi_7795_ = _e2983;
                                                                } else {
                                                                    phi_7795_ = _e2977;
                                                                }
                                                                let _e2987 = phi_7795_;
                                                                if (_e2942 < _e2987) {
                                                                    phi_7800_ = _e2942;
                                                                } else {
                                                                    phi_7800_ = _e2987;
                                                                }
                                                                let _e2990 = phi_7800_;
                                                                let _e2993 = local.member[2u];
                                                                let _e2996 = local.member_1[2u];
                                                                let _e2999 = local.member_2[2u];
                                                                if (_e2993 > _e2999) {
                                                                    if (_e2996 > _e2999) {
                                                                        phi_7832_ = false;
                                                                    } else {
                                                                        phi_7832_ = true;
                                                                    }
                                                                    let _e3003 = phi_7832_;
                                                                    phi_7833_ = _e3003;
                                                                } else {
                                                                    phi_7833_ = true;
                                                                }
                                                                let _e3005 = phi_7833_;
                                                                if _e3005 {
                                                                    let _e3006 = (_e2996 >= _e2993);
                                                                    if _e3006 {
                                                                        phi_7855_ = f32();
                                                                        phi_7856_ = false;
                                                                    } else {
                                                                        if ((_e2993 - _e2996) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7853_ = (((_e2993 - _e2999) / (_e2993 - _e2996)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7854_ = false;
                                                                        } else {
                                                                            phi_7853_ = f32();
                                                                            phi_7854_ = true;
                                                                        }
                                                                        let _e3017 = phi_7853_;
                                                                        let _e3019 = phi_7854_;
                                                                        phi_7855_ = _e3017;
                                                                        phi_7856_ = _e3019;
                                                                    }
                                                                    let _e3021 = phi_7855_;
                                                                    let _e3023 = phi_7856_;
                                                                    phi_7857_ = _e3021;
                                                                    phi_7858_ = _e3006;
                                                                    phi_7859_ = _e3023;
                                                                } else {
                                                                    phi_7857_ = f32();
                                                                    phi_7858_ = true;
                                                                    phi_7859_ = false;
                                                                }
                                                                let _e3025 = phi_7857_;
                                                                let _e3027 = phi_7858_;
                                                                let _e3029 = phi_7859_;
                                                                if _e3027 {
                                                                    phi_7863_ = 2f;
                                                                    phi_7864_ = true;
                                                                } else {
                                                                    phi_7863_ = _e2336;
                                                                    phi_7864_ = _e3029;
                                                                }
                                                                let _e3031 = phi_7863_;
                                                                let _e3033 = phi_7864_;
                                                                if _e3033 {
                                                                    phi_7868_ = _e3031;
                                                                } else {
                                                                    phi_7868_ = _e3025;
                                                                }
                                                                let _e3035 = phi_7868_;
                                                                let _e3038 = local.member[3u];
                                                                let _e3041 = local.member_1[3u];
                                                                let _e3044 = local.member_2[3u];
                                                                if (_e3038 > _e3044) {
                                                                    if (_e3041 > _e3044) {
                                                                        phi_7900_ = false;
                                                                    } else {
                                                                        phi_7900_ = true;
                                                                    }
                                                                    let _e3048 = phi_7900_;
                                                                    phi_7901_ = _e3048;
                                                                } else {
                                                                    phi_7901_ = true;
                                                                }
                                                                let _e3050 = phi_7901_;
                                                                if _e3050 {
                                                                    let _e3051 = (_e3041 >= _e3038);
                                                                    if _e3051 {
                                                                        phi_7923_ = f32();
                                                                        phi_7924_ = false;
                                                                    } else {
                                                                        if ((_e3038 - _e3041) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7921_ = (((_e3038 - _e3044) / (_e3038 - _e3041)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7922_ = false;
                                                                        } else {
                                                                            phi_7921_ = f32();
                                                                            phi_7922_ = true;
                                                                        }
                                                                        let _e3062 = phi_7921_;
                                                                        let _e3064 = phi_7922_;
                                                                        phi_7923_ = _e3062;
                                                                        phi_7924_ = _e3064;
                                                                    }
                                                                    let _e3066 = phi_7923_;
                                                                    let _e3068 = phi_7924_;
                                                                    phi_7925_ = _e3066;
                                                                    phi_7926_ = _e3051;
                                                                    phi_7927_ = _e3068;
                                                                } else {
                                                                    phi_7925_ = f32();
                                                                    phi_7926_ = true;
                                                                    phi_7927_ = false;
                                                                }
                                                                let _e3070 = phi_7925_;
                                                                let _e3072 = phi_7926_;
                                                                let _e3074 = phi_7927_;
                                                                if _e3072 {
                                                                    phi_7931_ = 2f;
                                                                    phi_7932_ = true;
                                                                } else {
                                                                    phi_7931_ = _e2336;
                                                                    phi_7932_ = _e3074;
                                                                }
                                                                let _e3076 = phi_7931_;
                                                                let _e3078 = phi_7932_;
                                                                if _e3078 {
                                                                    phi_7936_ = _e3076;
                                                                } else {
                                                                    phi_7936_ = _e3070;
                                                                }
                                                                let _e3080 = phi_7936_;
                                                                if (_e3035 < _e3080) {
                                                                    phi_7941_ = _e3035;
                                                                } else {
                                                                    phi_7941_ = _e3080;
                                                                }
                                                                let _e3083 = phi_7941_;
                                                                if (_e2990 < _e3083) {
                                                                    phi_7946_ = _e2990;
                                                                } else {
                                                                    phi_7946_ = _e3083;
                                                                }
                                                                let _e3086 = phi_7946_;
                                                                if (_e3086 > _e2336) {
                                                                    phi_7951_ = _e3086;
                                                                } else {
                                                                    phi_7951_ = _e2336;
                                                                }
                                                                let _e3089 = phi_7951_;
                                                                let _e3090 = (_e3089 > _e1390.member_1);
                                                                if _e3090 {
                                                                    phi_7963_ = f32();
                                                                    phi_7964_ = false;
                                                                } else {
                                                                    if (_e2354.member_1 == 0u) {
                                                                        phi_7962_ = (_e1390.member_1 - _e2336);
                                                                    } else {
                                                                        phi_7962_ = (_e2637 + _e2637);
                                                                    }
                                                                    let _e3095 = phi_7962_;
                                                                    phi_7963_ = _e3095;
                                                                    phi_7964_ = true;
                                                                }
                                                                let _e3097 = phi_7963_;
                                                                let _e3099 = phi_7964_;
                                                                phi_7965_ = _e3089;
                                                                phi_7966_ = _e3097;
                                                                phi_7967_ = _e3099;
                                                                phi_7968_ = _e3090;
                                                                phi_7969_ = false;
                                                            } else {
                                                                phi_7965_ = f32();
                                                                phi_7966_ = f32();
                                                                phi_7967_ = false;
                                                                phi_7968_ = false;
                                                                phi_7969_ = true;
                                                            }
                                                            let _e3101 = phi_7965_;
                                                            let _e3103 = phi_7966_;
                                                            let _e3105 = phi_7967_;
                                                            let _e3107 = phi_7968_;
                                                            let _e3109 = phi_7969_;
                                                            phi_7970_ = _e3101;
                                                            phi_7971_ = _e3103;
                                                            phi_7972_ = false;
                                                            phi_7973_ = _e3105;
                                                            phi_7974_ = _e3107;
                                                            phi_7975_ = _e3109;
                                                        } else {
                                                            phi_7970_ = f32();
                                                            phi_7971_ = f32();
                                                            phi_7972_ = true;
                                                            phi_7973_ = false;
                                                            phi_7974_ = false;
                                                            phi_7975_ = false;
                                                        }
                                                        let _e3111 = phi_7970_;
                                                        let _e3113 = phi_7971_;
                                                        let _e3115 = phi_7972_;
                                                        let _e3117 = phi_7973_;
                                                        let _e3119 = phi_7974_;
                                                        let _e3121 = phi_7975_;
                                                        phi_7976_ = _e3111;
                                                        phi_7977_ = _e3113;
                                                        phi_7978_ = _e3115;
                                                        phi_7979_ = _e3117;
                                                        phi_7980_ = _e3119;
                                                        phi_7981_ = _e3121;
                                                    } else {
                                                        phi_7976_ = f32();
                                                        phi_7977_ = f32();
                                                        phi_7978_ = true;
                                                        phi_7979_ = false;
                                                        phi_7980_ = false;
                                                        phi_7981_ = false;
                                                    }
                                                    let _e3123 = phi_7976_;
                                                    let _e3125 = phi_7977_;
                                                    let _e3127 = phi_7978_;
                                                    let _e3129 = phi_7979_;
                                                    let _e3131 = phi_7980_;
                                                    let _e3133 = phi_7981_;
                                                    if _e3127 {
                                                        let _e3134 = (_e2336 <= _e2338);
                                                        if _e3134 {
                                                            phi_8310_ = f32();
                                                            phi_8311_ = false;
                                                        } else {
                                                            let _e3137 = local.member[0u];
                                                            let _e3140 = local.member_1[0u];
                                                            let _e3143 = local.member[0u];
                                                            let _e3149 = local.member_2[0u];
                                                            let _e3150 = ((_e3137 + ((_e3140 - _e3143) * _e2340)) - _e3149);
                                                            let _e3153 = local.member[1u];
                                                            let _e3156 = local.member_1[1u];
                                                            let _e3159 = local.member[1u];
                                                            let _e3165 = local.member_2[1u];
                                                            let _e3166 = ((_e3153 + ((_e3156 - _e3159) * _e2340)) - _e3165);
                                                            if (_e3150 < _e3166) {
                                                                phi_8061_ = _e3150;
                                                            } else {
                                                                phi_8061_ = _e3166;
                                                            }
                                                            let _e3169 = phi_8061_;
                                                            let _e3172 = local.member[2u];
                                                            let _e3175 = local.member_1[2u];
                                                            let _e3178 = local.member[2u];
                                                            let _e3184 = local.member_2[2u];
                                                            let _e3185 = ((_e3172 + ((_e3175 - _e3178) * _e2340)) - _e3184);
                                                            let _e3188 = local.member[3u];
                                                            let _e3191 = local.member_1[3u];
                                                            let _e3194 = local.member[3u];
                                                            let _e3200 = local.member_2[3u];
                                                            let _e3201 = ((_e3188 + ((_e3191 - _e3194) * _e2340)) - _e3200);
                                                            if (_e3185 < _e3201) {
                                                                phi_8134_ = _e3185;
                                                            } else {
                                                                phi_8134_ = _e3201;
                                                            }
                                                            let _e3204 = phi_8134_;
                                                            if (_e3169 < _e3204) {
                                                                phi_8139_ = _e3169;
                                                            } else {
                                                                phi_8139_ = _e3204;
                                                            }
                                                            let _e3207 = phi_8139_;
                                                            let _e3210 = local_1.member[0u];
                                                            let _e3213 = local_1.member_1[0u];
                                                            let _e3216 = local_1.member[0u];
                                                            let _e3222 = local_1.member_2[0u];
                                                            let _e3223 = ((_e3210 + ((_e3213 - _e3216) * _e2336)) - _e3222);
                                                            let _e3226 = local_1.member[1u];
                                                            let _e3229 = local_1.member_1[1u];
                                                            let _e3232 = local_1.member[1u];
                                                            let _e3238 = local_1.member_2[1u];
                                                            let _e3239 = ((_e3226 + ((_e3229 - _e3232) * _e2336)) - _e3238);
                                                            if (_e3223 < _e3239) {
                                                                phi_8212_ = _e3223;
                                                            } else {
                                                                phi_8212_ = _e3239;
                                                            }
                                                            let _e3242 = phi_8212_;
                                                            let _e3245 = local_1.member[2u];
                                                            let _e3248 = local_1.member_1[2u];
                                                            let _e3251 = local_1.member[2u];
                                                            let _e3257 = local_1.member_2[2u];
                                                            let _e3258 = ((_e3245 + ((_e3248 - _e3251) * _e2336)) - _e3257);
                                                            let _e3261 = local_1.member[3u];
                                                            let _e3264 = local_1.member_1[3u];
                                                            let _e3267 = local_1.member[3u];
                                                            let _e3273 = local_1.member_2[3u];
                                                            let _e3274 = ((_e3261 + ((_e3264 - _e3267) * _e2336)) - _e3273);
                                                            if (_e3258 < _e3274) {
                                                                phi_8285_ = _e3258;
                                                            } else {
                                                                phi_8285_ = _e3274;
                                                            }
                                                            let _e3277 = phi_8285_;
                                                            if (_e3242 < _e3277) {
                                                                phi_8290_ = _e3242;
                                                            } else {
                                                                phi_8290_ = _e3277;
                                                            }
                                                            let _e3280 = phi_8290_;
                                                            if (_e3280 > 0f) {
                                                                phi_8308_ = 0.5f;
                                                            } else {
                                                                let _e3284 = (0.95f * (_e3207 / (_e3207 - _e3280)));
                                                                if (_e3284 > 0.0625f) {
                                                                    if (_e3284 < 0.9f) {
                                                                        phi_8306_ = _e3284;
                                                                    } else {
                                                                        phi_8306_ = 0.9f;
                                                                    }
                                                                    let _e3288 = phi_8306_;
                                                                    phi_8307_ = _e3288;
                                                                } else {
                                                                    phi_8307_ = 0.0625f;
                                                                }
                                                                let _e3290 = phi_8307_;
                                                                phi_8308_ = _e3290;
                                                            }
                                                            let _e3292 = phi_8308_;
                                                            phi_8310_ = (_e2637 * _e3292);
                                                            phi_8311_ = true;
                                                        }
                                                        let _e3295 = phi_8310_;
                                                        let _e3297 = phi_8311_;
                                                        phi_8312_ = _e2338;
                                                        phi_8313_ = _e3295;
                                                        phi_8314_ = _e2340;
                                                        phi_8315_ = _e3297;
                                                        phi_8316_ = _e3134;
                                                        phi_8317_ = false;
                                                        phi_8318_ = false;
                                                    } else {
                                                        phi_8312_ = _e3123;
                                                        phi_8313_ = _e3125;
                                                        phi_8314_ = _e2336;
                                                        phi_8315_ = _e3129;
                                                        phi_8316_ = false;
                                                        phi_8317_ = _e3131;
                                                        phi_8318_ = _e3133;
                                                    }
                                                    let _e3299 = phi_8312_;
                                                    let _e3301 = phi_8313_;
                                                    let _e3303 = phi_8314_;
                                                    let _e3305 = phi_8315_;
                                                    let _e3307 = phi_8316_;
                                                    let _e3309 = phi_8317_;
                                                    let _e3311 = phi_8318_;
                                                    if _e3305 {
                                                        let _e3312 = (_e3303 + _e3301);
                                                        if (_e3312 > _e3299) {
                                                            phi_8327_ = _e3312;
                                                        } else {
                                                            phi_8327_ = _e3299;
                                                        }
                                                        let _e3315 = phi_8327_;
                                                        if (_e3315 < _e1390.member_1) {
                                                            phi_8332_ = _e3315;
                                                        } else {
                                                            phi_8332_ = _e1390.member_1;
                                                        }
                                                        let _e3318 = phi_8332_;
                                                        if (_e2354.member_1 > 0u) {
                                                            phi_8342_ = ((_e3318 - _e3303) > 0.0000000037252903f);
                                                        } else {
                                                            phi_8342_ = true;
                                                        }
                                                        let _e3323 = phi_8342_;
                                                        if _e3323 {
                                                            phi_8346_ = false;
                                                        } else {
                                                            phi_8346_ = true;
                                                        }
                                                        let _e3325 = phi_8346_;
                                                        phi_8347_ = _e3318;
                                                        phi_8348_ = _e3323;
                                                        phi_8349_ = _e3325;
                                                        phi_8350_ = false;
                                                        phi_8351_ = false;
                                                        phi_8352_ = false;
                                                    } else {
                                                        phi_8347_ = f32();
                                                        phi_8348_ = false;
                                                        phi_8349_ = false;
                                                        phi_8350_ = _e3307;
                                                        phi_8351_ = _e3309;
                                                        phi_8352_ = _e3311;
                                                    }
                                                    let _e3327 = phi_8347_;
                                                    let _e3329 = phi_8348_;
                                                    let _e3331 = phi_8349_;
                                                    let _e3333 = phi_8350_;
                                                    let _e3335 = phi_8351_;
                                                    let _e3337 = phi_8352_;
                                                    phi_6727_ = _e3327;
                                                    phi_6729_ = _e3299;
                                                    phi_6731_ = _e3303;
                                                    phi_8353_ = _e3299;
                                                    phi_8354_ = _e3329;
                                                    phi_8355_ = _e3331;
                                                    phi_8356_ = false;
                                                    phi_8357_ = _e3333;
                                                    phi_8358_ = _e3335;
                                                    phi_8359_ = _e3337;
                                                } else {
                                                    phi_6727_ = f32();
                                                    phi_6729_ = f32();
                                                    phi_6731_ = f32();
                                                    phi_8353_ = f32();
                                                    phi_8354_ = false;
                                                    phi_8355_ = false;
                                                    phi_8356_ = true;
                                                    phi_8357_ = false;
                                                    phi_8358_ = false;
                                                    phi_8359_ = false;
                                                }
                                                let _e3339 = phi_6727_;
                                                let _e3341 = phi_6729_;
                                                let _e3343 = phi_6731_;
                                                let _e3345 = phi_8353_;
                                                let _e3347 = phi_8354_;
                                                let _e3349 = phi_8355_;
                                                let _e3351 = phi_8356_;
                                                let _e3353 = phi_8357_;
                                                let _e3355 = phi_8358_;
                                                let _e3357 = phi_8359_;
                                                local_19 = _e3349;
                                                local_35 = _e3345;
                                                local_37 = _e3351;
                                                local_38 = _e3353;
                                                local_39 = _e3355;
                                                local_40 = _e3357;
                                                continue;
                                                continuing {
                                                    phi_6723_ = _e2352;
                                                    phi_6726_ = _e3339;
                                                    phi_6728_ = _e3341;
                                                    phi_6730_ = _e3343;
                                                    break if !(_e3347);
                                                }
                                            }
                                            let _e3360 = local_19;
                                            if _e3360 {
                                                let _e5780 = local_35;
                                                phi_8363_ = _e5780;
                                                phi_8364_ = true;
                                                phi_8365_ = false;
                                                phi_8366_ = false;
                                                phi_8367_ = false;
                                            } else {
                                                let _e5782 = local_36;
                                                phi_8363_ = _e5782;
                                                let _e5785 = local_37;
                                                phi_8364_ = _e5785;
                                                let _e5788 = local_38;
                                                phi_8365_ = _e5788;
                                                let _e5791 = local_39;
                                                phi_8366_ = _e5791;
                                                let _e5794 = local_40;
                                                phi_8367_ = _e5794;
                                            }
                                            let _e3362 = phi_8363_;
                                            let _e3364 = phi_8364_;
                                            let _e3366 = phi_8365_;
                                            let _e3368 = phi_8366_;
                                            let _e3370 = phi_8367_;
                                            if _e3364 {
                                                phi_8372_ = type_35(1u, _e3362);
                                                phi_8373_ = false;
                                                phi_8374_ = false;
                                                phi_8375_ = false;
                                            } else {
                                                phi_8372_ = type_35();
                                                phi_8373_ = _e3366;
                                                phi_8374_ = _e3368;
                                                phi_8375_ = _e3370;
                                            }
                                            let _e3373 = phi_8372_;
                                            let _e3375 = phi_8373_;
                                            let _e3377 = phi_8374_;
                                            let _e3379 = phi_8375_;
                                            if _e3375 {
                                                let _e3381 = local_20;
                                                phi_8380_ = type_35(1u, _e3381);
                                                phi_8381_ = false;
                                                phi_8382_ = false;
                                            } else {
                                                phi_8380_ = type_35();
                                                phi_8381_ = _e3377;
                                                phi_8382_ = _e3379;
                                            }
                                            let _e3384 = phi_8380_;
                                            let _e3386 = phi_8381_;
                                            let _e3388 = phi_8382_;
                                            if _e3386 {
                                                phi_8387_ = type_35(0u, type_35().member_1);
                                                phi_8388_ = false;
                                                phi_8389_ = true;
                                            } else {
                                                phi_8387_ = _e3384;
                                                phi_8388_ = _e3388;
                                                phi_8389_ = _e3375;
                                            }
                                            let _e3392 = phi_8387_;
                                            let _e3394 = phi_8388_;
                                            let _e3396 = phi_8389_;
                                            if _e3394 {
                                                phi_8394_ = type_35(0u, type_35().member_1);
                                                phi_8395_ = true;
                                            } else {
                                                phi_8394_ = _e3392;
                                                phi_8395_ = _e3396;
                                            }
                                            let _e3400 = phi_8394_;
                                            let _e3402 = phi_8395_;
                                            if _e3402 {
                                                phi_8399_ = _e3400;
                                            } else {
                                                phi_8399_ = _e3373;
                                            }
                                            let _e3404 = phi_8399_;
                                            let _e3407 = (_e3404.member != 0u);
                                            if _e3407 {
                                                phi_8406_ = false;
                                            } else {
                                                phi_8406_ = true;
                                            }
                                            let _e3409 = phi_8406_;
                                            phi_8407_ = _e3404.member_1;
                                            phi_8408_ = _e3409;
                                            phi_8409_ = _e3407;
                                            phi_8410_ = false;
                                        } else {
                                            phi_8407_ = f32();
                                            phi_8408_ = false;
                                            phi_8409_ = false;
                                            phi_8410_ = true;
                                        }
                                        let _e3411 = phi_8407_;
                                        let _e3413 = phi_8408_;
                                        let _e3415 = phi_8409_;
                                        let _e3417 = phi_8410_;
                                        phi_8411_ = _e3411;
                                        phi_8412_ = _e3413;
                                        phi_8413_ = _e3415;
                                        phi_8414_ = _e3417;
                                    }
                                    let _e3419 = phi_8411_;
                                    let _e3421 = phi_8412_;
                                    let _e3423 = phi_8413_;
                                    let _e3425 = phi_8414_;
                                    phi_8415_ = _e3419;
                                    phi_8416_ = _e2098;
                                    phi_8417_ = _e3421;
                                    phi_8418_ = _e3423;
                                    phi_8419_ = _e3425;
                                }
                                let _e3427 = phi_8415_;
                                let _e3429 = phi_8416_;
                                let _e3431 = phi_8417_;
                                let _e3433 = phi_8418_;
                                let _e3435 = phi_8419_;
                                if _e3429 {
                                    phi_8423_ = true;
                                    phi_8424_ = false;
                                    phi_8425_ = false;
                                } else {
                                    phi_8423_ = _e3431;
                                    phi_8424_ = _e3433;
                                    phi_8425_ = _e3435;
                                }
                                let _e3437 = phi_8423_;
                                let _e3439 = phi_8424_;
                                let _e3441 = phi_8425_;
                                phi_8426_ = _e3427;
                                phi_8427_ = _e1390;
                                phi_8428_ = _e3437;
                                phi_8429_ = false;
                                phi_8430_ = _e3439;
                                phi_8431_ = _e3441;
                            } else {
                                phi_8426_ = f32();
                                phi_8427_ = type_37();
                                phi_8428_ = false;
                                phi_8429_ = true;
                                phi_8430_ = false;
                                phi_8431_ = false;
                            }
                            let _e3443 = phi_8426_;
                            let _e3445 = phi_8427_;
                            let _e3447 = phi_8428_;
                            let _e3449 = phi_8429_;
                            let _e3451 = phi_8430_;
                            let _e3453 = phi_8431_;
                            local_21 = _e3449;
                            local_41 = _e3451;
                            local_42 = _e3453;
                            local_22 = _e3443;
                            local_23 = _e3445;
                            continue;
                            continuing {
                                phi_4860_ = _e1120;
                                break if !(_e3447);
                            }
                        }
                        let _e3456 = local_21;
                        if _e3456 {
                            phi_8436_ = type_35(0u, type_35().member_1);
                            phi_8437_ = false;
                            phi_8438_ = false;
                        } else {
                            phi_8436_ = type_35();
                            let _e5836 = local_41;
                            phi_8437_ = _e5836;
                            let _e5839 = local_42;
                            phi_8438_ = _e5839;
                        }
                        let _e3460 = phi_8436_;
                        let _e3462 = phi_8437_;
                        let _e3464 = phi_8438_;
                        if _e3462 {
                            let _e3466 = local_22;
                            phi_8443_ = type_35(2u, _e3466);
                            phi_8444_ = false;
                        } else {
                            phi_8443_ = type_35();
                            phi_8444_ = _e3464;
                        }
                        let _e3469 = phi_8443_;
                        let _e3471 = phi_8444_;
                        if _e3471 {
                            let _e3473 = local_23;
                            phi_8450_ = type_35(1u, _e3473.member);
                            phi_8451_ = true;
                        } else {
                            phi_8450_ = _e3469;
                            phi_8451_ = _e3462;
                        }
                        let _e3477 = phi_8450_;
                        let _e3479 = phi_8451_;
                        if _e3479 {
                            phi_8455_ = _e3477;
                        } else {
                            phi_8455_ = _e3460;
                        }
                        let _e3481 = phi_8455_;
                        phi_8459_ = _e3481;
                    }
                    let _e5149 = phi_8459_;
                    phi_8460_ = _e5149;
                }
                let _e5153 = phi_8460_;
                switch bitcast<i32>(_e5153.member) {
                    case 0: {
                        phi_8473_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5159 = function_2(_e5153.member_1);
                        phi_8473_ = type_38(0u, _e5159, true);
                        break;
                    }
                    case 2: {
                        let _e5157 = function_2(_e5153.member_1);
                        phi_8473_ = type_38(1u, _e5157, true);
                        break;
                    }
                    default: {
                        phi_8473_ = type_38();
                        break;
                    }
                }
                let _e5162 = phi_8473_;
                if _e5162.member_2 {
                    phi_8480_ = (_e5162.member == 0u);
                } else {
                    phi_8480_ = false;
                }
                let _e5167 = phi_8480_;
                if _e5167 {
                    let _e5175 = (_e5162.member_1[1] >> bitcast<u32>(20i));
                    if (_e5175 <= 896u) {
                        phi_8504_ = 0u;
                    } else {
                        phi_8504_ = ((((_e5175 - 896u) << bitcast<u32>(23i)) | ((_e5162.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5162.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5190 = phi_8504_;
                    let _e5192 = atomicMin((&earliest.member[0u]), _e5190);
                }
                phi_8508_ = type_20(0u, 0u, _e176, _e179, _e5162.member_1);
                phi_8509_ = _e5167;
                phi_8510_ = (_e5162.member != 0u);
            } else {
                phi_8508_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8509_ = false;
                phi_8510_ = false;
            }
            let _e5194 = phi_8508_;
            let _e5196 = phi_8509_;
            let _e5198 = phi_8510_;
            let _e5201 = params.member.member.member_1;
            if ((_e5201 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5196 {
                    let _e5207 = atomicAdd((&counters[0u]), 1u);
                    phi_8529_ = _e5207;
                } else {
                    phi_8529_ = 0u;
                }
                let _e5209 = phi_8529_;
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
                if _e5196 {
                    let _e5222 = params.member.member_1.member_3;
                    if (_e5219 < _e5222) {
                        let _e5224 = (6u * _e5219);
                        atomicStore((&contacts.member[(4u + _e5224)]), _e5194.member);
                        atomicStore((&contacts.member[(_e5224 + 5u)]), _e5194.member_1);
                        atomicStore((&contacts.member[(_e5224 + 6u)]), _e5194.member_2);
                        atomicStore((&contacts.member[(_e5224 + 7u)]), _e5194.member_3);
                        atomicStore((&contacts.member[(_e5224 + 8u)]), _e5194.member_4[0]);
                        atomicStore((&contacts.member[(_e5224 + 9u)]), _e5194.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5198 {
                let _e5248 = atomicAdd((&counters[0u]), 1u);
                phi_8592_ = _e5248;
            } else {
                phi_8592_ = 0u;
            }
            let _e5250 = phi_8592_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5253 = atomicLoad((&counters[0u]));
                if (_e5253 > 0u) {
                    let _e5256 = atomicAdd((&undecided.member[0u]), _e5253);
                    atomicStore((&counters[1u]), _e5256);
                }
            }
            workgroupBarrier();
            let _e5259 = atomicLoad((&counters[1u]));
            let _e5260 = (_e5259 + _e5250);
            if _e5198 {
                let _e5263 = params.member.member_2.member;
                if (_e5260 < _e5263) {
                    let _e5267 = (2u * _e5260);
                    atomicStore((&undecided.member[(4u + _e5267)]), _e5194.member_2);
                    atomicStore((&undecided.member[(_e5267 + 5u)]), _e5194.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_805_ = _e161;
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
