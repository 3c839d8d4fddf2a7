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

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(3) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_29;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

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
    var phi_4629_: f32;
    var phi_4635_: f32;
    var phi_4640_: f32;
    var phi_4646_: f32;
    var phi_4652_: f32;
    var phi_4657_: f32;
    var phi_4662_: f32;
    var phi_4670_: bool;
    var phi_4675_: f32;
    var phi_4682_: f32;
    var phi_4722_: type_14;
    var phi_4725_: f32;
    var phi_4746_: bool;
    var phi_4752_: type_15;
    var phi_4723_: type_14;
    var phi_4766_: type_15;
    var phi_4726_: f32;
    var local_13: f32;
    var phi_4715_: f32;
    var phi_4779_: f32;
    var phi_4785_: f32;
    var phi_4810_: type_9;
    var phi_4813_: u32;
    var phi_4811_: type_9;
    var phi_4836_: type_9;
    var phi_4880_: u32;
    var phi_4881_: u32;
    var phi_4814_: u32;
    var phi_4882_: u32;
    var phi_4902_: type_9;
    var phi_4903_: type_9;
    var phi_4926_: type_9;
    var phi_4978_: f32;
    var phi_4985_: f32;
    var phi_4996_: bool;
    var phi_4997_: bool;
    var phi_4998_: bool;
    var phi_4999_: bool;
    var phi_5003_: bool;
    var phi_5014_: type_37;
    var phi_5015_: type_37;
    var phi_5016_: bool;
    var phi_5017_: type_37;
    var phi_5018_: bool;
    var phi_5029_: f32;
    var phi_5039_: type_9;
    var phi_5042_: f32;
    var phi_5044_: f32;
    var phi_5046_: f32;
    var phi_5040_: type_9;
    var phi_5069_: type_9;
    var phi_5094_: f32;
    var phi_5095_: f32;
    var phi_5121_: f32;
    var phi_5137_: f32;
    var phi_5144_: bool;
    var phi_5145_: bool;
    var phi_5146_: bool;
    var phi_5152_: f32;
    var phi_5153_: f32;
    var phi_5154_: bool;
    var phi_5043_: f32;
    var phi_5045_: f32;
    var phi_5047_: f32;
    var phi_5155_: f32;
    var phi_5156_: bool;
    var phi_5157_: bool;
    var local_14: bool;
    var phi_5161_: f32;
    var phi_5162_: f32;
    var phi_5170_: f32;
    var phi_5174_: type_9;
    var phi_5177_: f32;
    var phi_5175_: type_9;
    var phi_5200_: type_9;
    var phi_5230_: f32;
    var phi_5231_: bool;
    var phi_5232_: f32;
    var phi_5233_: bool;
    var phi_5234_: bool;
    var phi_5235_: bool;
    var phi_5236_: f32;
    var phi_5178_: f32;
    var phi_5237_: bool;
    var phi_5238_: bool;
    var phi_5239_: bool;
    var phi_5240_: bool;
    var local_15: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5249_: bool;
    var phi_5253_: f32;
    var phi_5254_: f32;
    var phi_5256_: type_37;
    var phi_5285_: f32;
    var phi_5292_: f32;
    var phi_5297_: f32;
    var phi_5304_: f32;
    var phi_5309_: f32;
    var phi_5322_: f32;
    var phi_5329_: f32;
    var phi_5334_: f32;
    var phi_5341_: f32;
    var phi_5346_: f32;
    var phi_5351_: f32;
    var phi_5410_: f32;
    var phi_5416_: f32;
    var phi_5421_: f32;
    var phi_5427_: f32;
    var phi_5432_: f32;
    var phi_5444_: f32;
    var phi_5450_: f32;
    var phi_5455_: f32;
    var phi_5461_: f32;
    var phi_5466_: f32;
    var phi_5492_: f32;
    var phi_5499_: f32;
    var phi_5504_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5529_: f32;
    var phi_5536_: f32;
    var phi_5541_: f32;
    var phi_5548_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5617_: f32;
    var phi_5623_: f32;
    var phi_5628_: f32;
    var phi_5634_: f32;
    var phi_5639_: f32;
    var phi_5651_: f32;
    var phi_5657_: f32;
    var phi_5662_: f32;
    var phi_5668_: f32;
    var phi_5673_: f32;
    var phi_5699_: f32;
    var phi_5706_: f32;
    var phi_5711_: f32;
    var phi_5718_: f32;
    var phi_5723_: f32;
    var phi_5736_: f32;
    var phi_5743_: f32;
    var phi_5748_: f32;
    var phi_5755_: f32;
    var phi_5760_: f32;
    var phi_5765_: f32;
    var phi_5824_: f32;
    var phi_5830_: f32;
    var phi_5835_: f32;
    var phi_5841_: f32;
    var phi_5846_: f32;
    var phi_5858_: f32;
    var phi_5864_: f32;
    var phi_5869_: f32;
    var phi_5875_: f32;
    var phi_5880_: f32;
    var phi_5929_: f32;
    var phi_5935_: f32;
    var phi_5963_: f32;
    var phi_5969_: f32;
    var phi_5974_: u32;
    var phi_5975_: u32;
    var phi_5945_: f32;
    var phi_5951_: f32;
    var phi_5956_: u32;
    var phi_5957_: u32;
    var phi_5976_: u32;
    var phi_5977_: u32;
    var phi_6046_: f32;
    var phi_6055_: f32;
    var phi_6190_: f32;
    var phi_6196_: f32;
    var phi_6203_: f32;
    var phi_6246_: type_9;
    var phi_6249_: bool;
    var phi_6247_: type_9;
    var phi_6272_: type_9;
    var phi_6299_: bool;
    var phi_6300_: bool;
    var phi_6250_: bool;
    var phi_6301_: bool;
    var phi_6302_: bool;
    var local_16: bool;
    var phi_6306_: bool;
    var local_17: bool;
    var phi_6313_: u32;
    var phi_6314_: u32;
    var phi_6315_: bool;
    var phi_6316_: u32;
    var phi_6317_: u32;
    var phi_6318_: bool;
    var phi_6322_: u32;
    var phi_6342_: bool;
    var phi_6343_: bool;
    var phi_6344_: bool;
    var phi_6492_: f32;
    var phi_6499_: f32;
    var phi_6504_: f32;
    var phi_6511_: f32;
    var phi_6516_: f32;
    var phi_6529_: f32;
    var phi_6536_: f32;
    var phi_6541_: f32;
    var phi_6548_: f32;
    var phi_6553_: f32;
    var phi_6558_: f32;
    var phi_6575_: f32;
    var phi_6582_: f32;
    var phi_6587_: f32;
    var phi_6594_: f32;
    var phi_6599_: f32;
    var phi_6613_: f32;
    var phi_6620_: f32;
    var phi_6625_: f32;
    var phi_6632_: f32;
    var phi_6637_: f32;
    var phi_6642_: f32;
    var phi_6659_: f32;
    var phi_6666_: f32;
    var phi_6671_: f32;
    var phi_6678_: f32;
    var phi_6683_: f32;
    var phi_6697_: f32;
    var phi_6704_: f32;
    var phi_6709_: f32;
    var phi_6716_: f32;
    var phi_6721_: f32;
    var phi_6726_: f32;
    var phi_6765_: type_9;
    var phi_6768_: f32;
    var phi_6770_: f32;
    var phi_6772_: f32;
    var phi_6774_: bool;
    var phi_6776_: u32;
    var phi_6766_: type_9;
    var phi_6799_: type_9;
    var phi_6913_: f32;
    var phi_6919_: f32;
    var phi_6925_: f32;
    var phi_6927_: array<f32, 3>;
    var phi_6934_: f32;
    var phi_6941_: f32;
    var phi_6949_: f32;
    var phi_6993_: type_14;
    var phi_6996_: f32;
    var phi_7017_: bool;
    var phi_7023_: type_15;
    var phi_6994_: type_14;
    var phi_7037_: type_15;
    var phi_6997_: f32;
    var local_18: f32;
    var phi_6986_: f32;
    var phi_7050_: f32;
    var phi_7116_: f32;
    var phi_7122_: f32;
    var phi_7131_: f32;
    var phi_7137_: f32;
    var phi_7146_: f32;
    var phi_7152_: f32;
    var phi_7161_: f32;
    var phi_7167_: f32;
    var phi_7173_: type_30;
    var phi_7174_: bool;
    var phi_7175_: type_30;
    var phi_7176_: bool;
    var phi_7184_: type_30;
    var phi_7355_: bool;
    var phi_7356_: bool;
    var phi_7357_: bool;
    var phi_7358_: bool;
    var phi_7359_: bool;
    var phi_7360_: bool;
    var phi_7364_: bool;
    var phi_7661_: bool;
    var phi_7662_: bool;
    var phi_7663_: bool;
    var phi_7664_: bool;
    var phi_7665_: bool;
    var phi_7666_: bool;
    var phi_7670_: bool;
    var phi_7674_: bool;
    var phi_7685_: bool;
    var phi_7686_: bool;
    var phi_7760_: bool;
    var phi_7761_: bool;
    var phi_7781_: f32;
    var phi_7782_: bool;
    var phi_7783_: f32;
    var phi_7784_: bool;
    var phi_7785_: f32;
    var phi_7786_: bool;
    var phi_7787_: bool;
    var phi_7791_: f32;
    var phi_7792_: bool;
    var phi_7796_: f32;
    var phi_7828_: bool;
    var phi_7829_: bool;
    var phi_7849_: f32;
    var phi_7850_: bool;
    var phi_7851_: f32;
    var phi_7852_: bool;
    var phi_7853_: f32;
    var phi_7854_: bool;
    var phi_7855_: bool;
    var phi_7859_: f32;
    var phi_7860_: bool;
    var phi_7864_: f32;
    var phi_7869_: f32;
    var phi_7901_: bool;
    var phi_7902_: bool;
    var phi_7922_: f32;
    var phi_7923_: bool;
    var phi_7924_: f32;
    var phi_7925_: bool;
    var phi_7926_: f32;
    var phi_7927_: bool;
    var phi_7928_: bool;
    var phi_7932_: f32;
    var phi_7933_: bool;
    var phi_7937_: f32;
    var phi_7969_: bool;
    var phi_7970_: bool;
    var phi_7990_: f32;
    var phi_7991_: bool;
    var phi_7992_: f32;
    var phi_7993_: bool;
    var phi_7994_: f32;
    var phi_7995_: bool;
    var phi_7996_: bool;
    var phi_8000_: f32;
    var phi_8001_: bool;
    var phi_8005_: f32;
    var phi_8010_: f32;
    var phi_8015_: f32;
    var phi_8020_: f32;
    var phi_8030_: f32;
    var phi_8031_: f32;
    var phi_8032_: bool;
    var phi_8033_: f32;
    var phi_8034_: f32;
    var phi_8035_: bool;
    var phi_8036_: bool;
    var phi_8037_: bool;
    var phi_8038_: f32;
    var phi_8039_: f32;
    var phi_8040_: bool;
    var phi_8041_: bool;
    var phi_8042_: bool;
    var phi_8043_: bool;
    var phi_8044_: f32;
    var phi_8045_: f32;
    var phi_8046_: bool;
    var phi_8047_: bool;
    var phi_8048_: bool;
    var phi_8049_: bool;
    var phi_8135_: f32;
    var phi_8208_: f32;
    var phi_8213_: f32;
    var phi_8286_: f32;
    var phi_8359_: f32;
    var phi_8364_: f32;
    var phi_8380_: f32;
    var phi_8381_: f32;
    var phi_8382_: f32;
    var phi_8062_: bool;
    var phi_8384_: u32;
    var phi_8385_: f32;
    var phi_8386_: bool;
    var phi_8387_: bool;
    var phi_8388_: bool;
    var phi_8389_: u32;
    var phi_8390_: f32;
    var phi_8391_: f32;
    var phi_8392_: f32;
    var phi_8393_: bool;
    var phi_8394_: u32;
    var phi_8395_: bool;
    var phi_8396_: bool;
    var phi_8397_: bool;
    var phi_8398_: bool;
    var phi_8399_: bool;
    var phi_8408_: f32;
    var phi_8413_: f32;
    var phi_8422_: bool;
    var phi_8426_: bool;
    var phi_8427_: f32;
    var phi_8428_: f32;
    var phi_8429_: f32;
    var phi_8430_: bool;
    var phi_8431_: u32;
    var phi_8432_: bool;
    var phi_8433_: bool;
    var phi_8434_: bool;
    var phi_8435_: bool;
    var phi_8436_: bool;
    var phi_6769_: f32;
    var phi_6771_: f32;
    var phi_6773_: f32;
    var phi_6775_: bool;
    var phi_6777_: u32;
    var phi_8437_: f32;
    var phi_8438_: bool;
    var phi_8439_: bool;
    var phi_8440_: bool;
    var phi_8441_: bool;
    var phi_8442_: bool;
    var phi_8443_: bool;
    var local_19: bool;
    var phi_8447_: f32;
    var phi_8448_: bool;
    var phi_8449_: bool;
    var phi_8450_: bool;
    var phi_8451_: bool;
    var phi_8456_: type_35;
    var phi_8457_: bool;
    var phi_8458_: bool;
    var phi_8459_: bool;
    var local_20: f32;
    var phi_8464_: type_35;
    var phi_8465_: bool;
    var phi_8466_: bool;
    var phi_8471_: type_35;
    var phi_8472_: bool;
    var phi_8473_: bool;
    var phi_8478_: type_35;
    var phi_8479_: bool;
    var phi_8483_: type_35;
    var phi_8490_: bool;
    var phi_8491_: f32;
    var phi_8492_: bool;
    var phi_8493_: bool;
    var phi_8494_: bool;
    var phi_8495_: f32;
    var phi_8496_: bool;
    var phi_8497_: bool;
    var phi_8498_: bool;
    var phi_8499_: f32;
    var phi_8500_: bool;
    var phi_8501_: bool;
    var phi_8502_: bool;
    var phi_8503_: bool;
    var phi_8507_: bool;
    var phi_8508_: bool;
    var phi_8509_: bool;
    var phi_8510_: f32;
    var phi_8511_: type_37;
    var phi_8512_: bool;
    var phi_8513_: bool;
    var phi_8514_: bool;
    var phi_8515_: bool;
    var local_21: bool;
    var phi_8520_: type_35;
    var phi_8521_: bool;
    var phi_8522_: bool;
    var local_22: f32;
    var phi_8527_: type_35;
    var phi_8528_: bool;
    var local_23: type_37;
    var phi_8534_: type_35;
    var phi_8535_: bool;
    var phi_8539_: type_35;
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
    var phi_2373_: bool;
    var phi_2375_: u32;
    var phi_2365_: type_9;
    var phi_2398_: type_9;
    var phi_2512_: f32;
    var phi_2518_: f32;
    var phi_2524_: f32;
    var phi_2526_: array<f32, 3>;
    var phi_2533_: f32;
    var phi_2540_: f32;
    var phi_2548_: f32;
    var phi_2592_: type_14;
    var phi_2595_: f32;
    var phi_2616_: bool;
    var phi_2622_: type_15;
    var phi_2593_: type_14;
    var phi_2636_: type_15;
    var phi_2596_: f32;
    var local_24: f32;
    var phi_2585_: f32;
    var phi_2649_: f32;
    var phi_2715_: f32;
    var phi_2721_: f32;
    var phi_2730_: f32;
    var phi_2736_: f32;
    var phi_2745_: f32;
    var phi_2751_: f32;
    var phi_2760_: f32;
    var phi_2766_: f32;
    var phi_2772_: type_30;
    var phi_2773_: bool;
    var phi_2774_: type_30;
    var phi_2775_: bool;
    var phi_2783_: type_30;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2963_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3269_: bool;
    var phi_3273_: bool;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3380_: f32;
    var phi_3381_: bool;
    var phi_3382_: f32;
    var phi_3383_: bool;
    var phi_3384_: f32;
    var phi_3385_: bool;
    var phi_3386_: bool;
    var phi_3390_: f32;
    var phi_3391_: bool;
    var phi_3395_: f32;
    var phi_3427_: bool;
    var phi_3428_: bool;
    var phi_3448_: f32;
    var phi_3449_: bool;
    var phi_3450_: f32;
    var phi_3451_: bool;
    var phi_3452_: f32;
    var phi_3453_: bool;
    var phi_3454_: bool;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3463_: f32;
    var phi_3468_: f32;
    var phi_3500_: bool;
    var phi_3501_: bool;
    var phi_3521_: f32;
    var phi_3522_: bool;
    var phi_3523_: f32;
    var phi_3524_: bool;
    var phi_3525_: f32;
    var phi_3526_: bool;
    var phi_3527_: bool;
    var phi_3531_: f32;
    var phi_3532_: bool;
    var phi_3536_: f32;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var phi_3589_: f32;
    var phi_3590_: bool;
    var phi_3591_: f32;
    var phi_3592_: bool;
    var phi_3593_: f32;
    var phi_3594_: bool;
    var phi_3595_: bool;
    var phi_3599_: f32;
    var phi_3600_: bool;
    var phi_3604_: f32;
    var phi_3609_: f32;
    var phi_3614_: f32;
    var phi_3619_: f32;
    var phi_3629_: f32;
    var phi_3630_: f32;
    var phi_3631_: bool;
    var phi_3632_: f32;
    var phi_3633_: f32;
    var phi_3634_: bool;
    var phi_3635_: bool;
    var phi_3636_: bool;
    var phi_3637_: f32;
    var phi_3638_: f32;
    var phi_3639_: bool;
    var phi_3640_: bool;
    var phi_3641_: bool;
    var phi_3642_: bool;
    var phi_3643_: f32;
    var phi_3644_: f32;
    var phi_3645_: bool;
    var phi_3646_: bool;
    var phi_3647_: bool;
    var phi_3648_: bool;
    var phi_3734_: f32;
    var phi_3807_: f32;
    var phi_3812_: f32;
    var phi_3885_: f32;
    var phi_3958_: f32;
    var phi_3963_: f32;
    var phi_3979_: f32;
    var phi_3980_: f32;
    var phi_3981_: f32;
    var phi_3661_: bool;
    var phi_3983_: u32;
    var phi_3984_: f32;
    var phi_3985_: bool;
    var phi_3986_: bool;
    var phi_3987_: bool;
    var phi_3988_: u32;
    var phi_3989_: f32;
    var phi_3990_: f32;
    var phi_3991_: f32;
    var phi_3992_: bool;
    var phi_3993_: u32;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_3996_: bool;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var phi_4007_: f32;
    var phi_4012_: f32;
    var phi_4021_: bool;
    var phi_4025_: bool;
    var phi_4026_: f32;
    var phi_4027_: f32;
    var phi_4028_: f32;
    var phi_4029_: bool;
    var phi_4030_: u32;
    var phi_4031_: bool;
    var phi_4032_: bool;
    var phi_4033_: bool;
    var phi_4034_: bool;
    var phi_4035_: bool;
    var phi_2368_: f32;
    var phi_2370_: f32;
    var phi_2372_: f32;
    var phi_2374_: bool;
    var phi_2376_: u32;
    var phi_4036_: f32;
    var phi_4037_: bool;
    var phi_4038_: bool;
    var phi_4039_: bool;
    var phi_4040_: bool;
    var phi_4041_: bool;
    var phi_4042_: bool;
    var local_25: bool;
    var phi_4046_: f32;
    var phi_4047_: bool;
    var phi_4048_: bool;
    var phi_4049_: bool;
    var phi_4050_: bool;
    var phi_4055_: type_35;
    var phi_4056_: bool;
    var phi_4057_: bool;
    var phi_4058_: bool;
    var local_26: f32;
    var phi_4063_: type_35;
    var phi_4064_: bool;
    var phi_4065_: bool;
    var phi_4070_: type_35;
    var phi_4071_: bool;
    var phi_4072_: bool;
    var phi_4077_: type_35;
    var phi_4078_: bool;
    var phi_4082_: type_35;
    var phi_4096_: type_9;
    var phi_4097_: type_9;
    var phi_4120_: type_9;
    var phi_4140_: f32;
    var phi_4270_: type_14;
    var phi_4273_: f32;
    var phi_4294_: bool;
    var phi_4300_: type_15;
    var phi_4271_: type_14;
    var phi_4314_: type_15;
    var phi_4274_: f32;
    var local_27: f32;
    var phi_4263_: f32;
    var phi_4327_: f32;
    var phi_4343_: f32;
    var phi_4350_: f32;
    var phi_4355_: f32;
    var phi_4362_: f32;
    var phi_4367_: f32;
    var phi_4380_: f32;
    var phi_4387_: f32;
    var phi_4392_: f32;
    var phi_4399_: f32;
    var phi_4404_: f32;
    var phi_4409_: f32;
    var phi_4426_: f32;
    var phi_4433_: f32;
    var phi_4438_: f32;
    var phi_4445_: f32;
    var phi_4450_: f32;
    var phi_4464_: f32;
    var phi_4471_: f32;
    var phi_4476_: f32;
    var phi_4483_: f32;
    var phi_4488_: f32;
    var phi_4493_: f32;
    var phi_4510_: f32;
    var phi_4517_: f32;
    var phi_4522_: f32;
    var phi_4529_: f32;
    var phi_4534_: f32;
    var phi_4548_: f32;
    var phi_4555_: f32;
    var phi_4560_: f32;
    var phi_4567_: f32;
    var phi_4572_: f32;
    var phi_4577_: f32;
    var phi_4597_: bool;
    var phi_4598_: bool;
    var phi_4599_: bool;
    var local_28: bool;
    var phi_4604_: type_35;
    var phi_4605_: bool;
    var phi_4610_: type_35;
    var phi_4611_: bool;
    var phi_4613_: type_35;
    var phi_4614_: type_35;
    var phi_4615_: bool;
    var phi_4619_: type_35;
    var phi_8543_: type_35;
    var phi_8544_: type_35;
    var phi_8557_: type_38;
    var phi_8564_: bool;
    var phi_8588_: u32;
    var phi_8592_: type_20;
    var phi_8593_: bool;
    var phi_8594_: bool;
    var phi_8613_: u32;
    var phi_8676_: u32;
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
                    phi_8544_ = type_35(0u, type_35().member_1);
                } else {
                    if (_e452.member_1 > 0f) {
                        let _e3531 = local_12.member[0u];
                        let _e3537 = local_12.member_1[0u];
                        let _e3543 = local_12.member_2[0u];
                        let _e3555 = local_12.member[1u];
                        let _e3561 = local_12.member_1[1u];
                        let _e3567 = local_12.member_2[1u];
                        let _e3579 = local_12.member[0u];
                        if (_e3579[0] < 0f) {
                            phi_2091_ = -(_e3579[0]);
                        } else {
                            phi_2091_ = _e3579[0];
                        }
                        let _e3586 = phi_2091_;
                        if (_e3579[1] < 0f) {
                            phi_2098_ = -(_e3579[1]);
                        } else {
                            phi_2098_ = _e3579[1];
                        }
                        let _e3590 = phi_2098_;
                        if (_e3586 > _e3590) {
                            phi_2103_ = _e3586;
                        } else {
                            phi_2103_ = _e3590;
                        }
                        let _e3593 = phi_2103_;
                        if (_e3579[2] < 0f) {
                            phi_2110_ = -(_e3579[2]);
                        } else {
                            phi_2110_ = _e3579[2];
                        }
                        let _e3597 = phi_2110_;
                        if (_e3593 > _e3597) {
                            phi_2115_ = _e3593;
                        } else {
                            phi_2115_ = _e3597;
                        }
                        let _e3600 = phi_2115_;
                        let _e3603 = local_12.member[1u];
                        if (_e3603[0] < 0f) {
                            phi_2128_ = -(_e3603[0]);
                        } else {
                            phi_2128_ = _e3603[0];
                        }
                        let _e3610 = phi_2128_;
                        if (_e3603[1] < 0f) {
                            phi_2135_ = -(_e3603[1]);
                        } else {
                            phi_2135_ = _e3603[1];
                        }
                        let _e3614 = phi_2135_;
                        if (_e3610 > _e3614) {
                            phi_2140_ = _e3610;
                        } else {
                            phi_2140_ = _e3614;
                        }
                        let _e3617 = phi_2140_;
                        if (_e3603[2] < 0f) {
                            phi_2147_ = -(_e3603[2]);
                        } else {
                            phi_2147_ = _e3603[2];
                        }
                        let _e3621 = phi_2147_;
                        if (_e3617 > _e3621) {
                            phi_2152_ = _e3617;
                        } else {
                            phi_2152_ = _e3621;
                        }
                        let _e3624 = phi_2152_;
                        if (_e3600 > _e3624) {
                            phi_2157_ = _e3600;
                        } else {
                            phi_2157_ = _e3624;
                        }
                        let _e3627 = phi_2157_;
                        let _e3629 = local_12.member_3;
                        let _e3633 = local_12.member_1[0u];
                        if (_e3633[0] < 0f) {
                            phi_2174_ = -(_e3633[0]);
                        } else {
                            phi_2174_ = _e3633[0];
                        }
                        let _e3640 = phi_2174_;
                        if (_e3633[1] < 0f) {
                            phi_2181_ = -(_e3633[1]);
                        } else {
                            phi_2181_ = _e3633[1];
                        }
                        let _e3644 = phi_2181_;
                        if (_e3640 > _e3644) {
                            phi_2186_ = _e3640;
                        } else {
                            phi_2186_ = _e3644;
                        }
                        let _e3647 = phi_2186_;
                        if (_e3633[2] < 0f) {
                            phi_2193_ = -(_e3633[2]);
                        } else {
                            phi_2193_ = _e3633[2];
                        }
                        let _e3651 = phi_2193_;
                        if (_e3647 > _e3651) {
                            phi_2198_ = _e3647;
                        } else {
                            phi_2198_ = _e3651;
                        }
                        let _e3654 = phi_2198_;
                        let _e3657 = local_12.member_1[1u];
                        if (_e3657[0] < 0f) {
                            phi_2212_ = -(_e3657[0]);
                        } else {
                            phi_2212_ = _e3657[0];
                        }
                        let _e3664 = phi_2212_;
                        if (_e3657[1] < 0f) {
                            phi_2219_ = -(_e3657[1]);
                        } else {
                            phi_2219_ = _e3657[1];
                        }
                        let _e3668 = phi_2219_;
                        if (_e3664 > _e3668) {
                            phi_2224_ = _e3664;
                        } else {
                            phi_2224_ = _e3668;
                        }
                        let _e3671 = phi_2224_;
                        if (_e3657[2] < 0f) {
                            phi_2231_ = -(_e3657[2]);
                        } else {
                            phi_2231_ = _e3657[2];
                        }
                        let _e3675 = phi_2231_;
                        if (_e3671 > _e3675) {
                            phi_2236_ = _e3671;
                        } else {
                            phi_2236_ = _e3675;
                        }
                        let _e3678 = phi_2236_;
                        if (_e3654 > _e3678) {
                            phi_2241_ = _e3654;
                        } else {
                            phi_2241_ = _e3678;
                        }
                        let _e3681 = phi_2241_;
                        let _e3683 = local_12.member_3;
                        let _e3687 = local_12.member_2[0u];
                        if (_e3687[0] < 0f) {
                            phi_2258_ = -(_e3687[0]);
                        } else {
                            phi_2258_ = _e3687[0];
                        }
                        let _e3694 = phi_2258_;
                        if (_e3687[1] < 0f) {
                            phi_2265_ = -(_e3687[1]);
                        } else {
                            phi_2265_ = _e3687[1];
                        }
                        let _e3698 = phi_2265_;
                        if (_e3694 > _e3698) {
                            phi_2270_ = _e3694;
                        } else {
                            phi_2270_ = _e3698;
                        }
                        let _e3701 = phi_2270_;
                        if (_e3687[2] < 0f) {
                            phi_2277_ = -(_e3687[2]);
                        } else {
                            phi_2277_ = _e3687[2];
                        }
                        let _e3705 = phi_2277_;
                        if (_e3701 > _e3705) {
                            phi_2282_ = _e3701;
                        } else {
                            phi_2282_ = _e3705;
                        }
                        let _e3708 = phi_2282_;
                        let _e3711 = local_12.member_2[1u];
                        if (_e3711[0] < 0f) {
                            phi_2296_ = -(_e3711[0]);
                        } else {
                            phi_2296_ = _e3711[0];
                        }
                        let _e3718 = phi_2296_;
                        if (_e3711[1] < 0f) {
                            phi_2303_ = -(_e3711[1]);
                        } else {
                            phi_2303_ = _e3711[1];
                        }
                        let _e3722 = phi_2303_;
                        if (_e3718 > _e3722) {
                            phi_2308_ = _e3718;
                        } else {
                            phi_2308_ = _e3722;
                        }
                        let _e3725 = phi_2308_;
                        if (_e3711[2] < 0f) {
                            phi_2315_ = -(_e3711[2]);
                        } else {
                            phi_2315_ = _e3711[2];
                        }
                        let _e3729 = phi_2315_;
                        if (_e3725 > _e3729) {
                            phi_2320_ = _e3725;
                        } else {
                            phi_2320_ = _e3729;
                        }
                        let _e3732 = phi_2320_;
                        if (_e3708 > _e3732) {
                            phi_2325_ = _e3708;
                        } else {
                            phi_2325_ = _e3732;
                        }
                        let _e3735 = phi_2325_;
                        let _e3737 = local_12.member_3;
                        let _e3744 = local_12.member_3;
                        local_9 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_2364_ = type_9(0u, 96u);
                        phi_2367_ = 0f;
                        phi_2369_ = 0f;
                        phi_2371_ = 0f;
                        phi_2373_ = false;
                        phi_2375_ = 0u;
                        loop {
                            let _e3750 = phi_2364_;
                            let _e3752 = phi_2367_;
                            let _e3754 = phi_2369_;
                            let _e3756 = phi_2371_;
                            let _e3758 = phi_2373_;
                            let _e3760 = phi_2375_;
                            local_44 = _e3754;
                            local_26 = _e3752;
                            if (_e3750.member < _e3750.member_1) {
                                phi_2365_ = type_9((_e3750.member + 1u), _e3750.member_1);
                                phi_2398_ = type_9(1u, _e3750.member);
                            } else {
                                phi_2365_ = _e3750;
                                phi_2398_ = type_9(0u, type_9().member_1);
                            }
                            let _e3772 = phi_2365_;
                            let _e3774 = phi_2398_;
                            if (bitcast<i32>(_e3774.member) != 0i) {
                                let _e3780 = local_12.member[0u];
                                let _e3786 = local_12.member[1u];
                                let _e3802 = local_12.member_1[0u];
                                let _e3808 = local_12.member_1[1u];
                                let _e3824 = local_12.member_2[0u];
                                let _e3830 = local_12.member_2[1u];
                                let _e3844 = function_1(array<f32, 3>((_e3780[0] + ((_e3786[0] - _e3780[0]) * _e3752)), (_e3780[1] + ((_e3786[1] - _e3780[1]) * _e3752)), (_e3780[2] + ((_e3786[2] - _e3780[2]) * _e3752))), array<f32, 3>((_e3802[0] + ((_e3808[0] - _e3802[0]) * _e3752)), (_e3802[1] + ((_e3808[1] - _e3802[1]) * _e3752)), (_e3802[2] + ((_e3808[2] - _e3802[2]) * _e3752))), array<f32, 3>((_e3824[0] + ((_e3830[0] - _e3824[0]) * _e3752)), (_e3824[1] + ((_e3830[1] - _e3824[1]) * _e3752)), (_e3824[2] + ((_e3830[2] - _e3824[2]) * _e3752))), 0u);
                                if (_e3760 == 0u) {
                                    phi_2526_ = _e3844;
                                } else {
                                    if (_e3760 == 1u) {
                                        phi_2512_ = _e3844[0];
                                    } else {
                                        phi_2512_ = 0f;
                                    }
                                    let _e3849 = phi_2512_;
                                    if (_e3760 == 2u) {
                                        phi_2518_ = _e3844[1];
                                    } else {
                                        phi_2518_ = 0f;
                                    }
                                    let _e3853 = phi_2518_;
                                    if (_e3760 == 3u) {
                                        phi_2524_ = _e3844[2];
                                    } else {
                                        phi_2524_ = 0f;
                                    }
                                    let _e3857 = phi_2524_;
                                    phi_2526_ = array<f32, 3>(_e3849, _e3853, _e3857);
                                }
                                let _e3860 = phi_2526_;
                                if (_e3860[0] < 0f) {
                                    phi_2533_ = -(_e3860[0]);
                                } else {
                                    phi_2533_ = _e3860[0];
                                }
                                let _e3865 = phi_2533_;
                                if (_e3860[1] < 0f) {
                                    phi_2540_ = -(_e3860[1]);
                                } else {
                                    phi_2540_ = _e3860[1];
                                }
                                let _e3870 = phi_2540_;
                                if (_e3860[2] < 0f) {
                                    phi_2548_ = -(_e3860[2]);
                                } else {
                                    phi_2548_ = _e3860[2];
                                }
                                let _e3876 = phi_2548_;
                                let _e3877 = ((_e3865 + _e3870) + _e3876);
                                if (_e3877 > 0f) {
                                    if ((bitcast<u32>(_e3877) & 2139095040u) != 2139095040u) {
                                        let _e3882 = (1f / _e3877);
                                        let _e3884 = (_e3860[0] * _e3882);
                                        let _e3886 = (_e3860[1] * _e3882);
                                        let _e3888 = (_e3860[2] * _e3882);
                                        let _e3893 = (((_e3884 * _e3884) + (_e3886 * _e3886)) + (_e3888 * _e3888));
                                        if (_e3893 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3893 > 0f) {
                                                phi_2585_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2585_ = 0f;
                                            }
                                            let _e3946 = phi_2585_;
                                            phi_2649_ = _e3946;
                                        } else {
                                            phi_2592_ = type_14(0i, 5i);
                                            phi_2595_ = bitcast<f32>(((bitcast<u32>(_e3893) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3901 = phi_2592_;
                                                let _e3903 = phi_2595_;
                                                local_24 = _e3903;
                                                if (_e3901.member < _e3901.member_1) {
                                                    let _e3910 = (_e3901.member + 1i);
                                                    if ((false == (_e3910 > _e3901.member)) != false) {
                                                        phi_2616_ = true;
                                                    } else {
                                                        phi_2616_ = false;
                                                    }
                                                    let _e3915 = phi_2616_;
                                                    if _e3915 {
                                                        phi_2622_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2622_ = type_15(1u, _e3910);
                                                    }
                                                    let _e3920 = phi_2622_;
                                                    phi_2593_ = type_14(_e3920.member_1, _e3901.member_1);
                                                    phi_2636_ = type_15(1u, _e3901.member);
                                                } else {
                                                    phi_2593_ = _e3901;
                                                    phi_2636_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3926 = phi_2593_;
                                                let _e3928 = phi_2636_;
                                                let _e3931 = (bitcast<i32>(_e3928.member) != 0i);
                                                if _e3931 {
                                                    phi_2596_ = (0.5f * (_e3903 + (_e3893 / _e3903)));
                                                } else {
                                                    phi_2596_ = f32();
                                                }
                                                let _e3936 = phi_2596_;
                                                continue;
                                                continuing {
                                                    phi_2592_ = _e3926;
                                                    phi_2595_ = _e3936;
                                                    break if !(_e3931);
                                                }
                                            }
                                            let _e3941 = local_24;
                                            phi_2649_ = (_e3941 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3948 = phi_2649_;
                                        let _e3949 = (0.000000059604645f * 12f);
                                        let _e3954 = ((((((((_e3627 + _e3629) + (_e3681 + _e3683)) + (_e3735 + _e3737)) * (0.000000059604645f * 16f)) + (_e3744 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e452.member_1 * _e3948) * (1f + _e3949)));
                                        let _e3959 = (((_e3884 * _e3531[0]) + (_e3886 * _e3531[1])) + (_e3888 * _e3531[2]));
                                        let _e3964 = (((_e3884 * (_e3531[0] - _e3537[0])) + (_e3886 * (_e3531[1] - _e3537[1]))) + (_e3888 * (_e3531[2] - _e3537[2])));
                                        let _e3969 = (((_e3884 * (_e3531[0] - _e3543[0])) + (_e3886 * (_e3531[1] - _e3543[1]))) + (_e3888 * (_e3531[2] - _e3543[2])));
                                        let _e3974 = (((_e3884 * _e3531[0]) + (_e3886 * _e3531[1])) + (_e3888 * _e3531[2]));
                                        let _e3980 = (((_e3884 * _e3555[0]) + (_e3886 * _e3555[1])) + (_e3888 * _e3555[2]));
                                        let _e3985 = (((_e3884 * (_e3555[0] - _e3561[0])) + (_e3886 * (_e3555[1] - _e3561[1]))) + (_e3888 * (_e3555[2] - _e3561[2])));
                                        let _e3990 = (((_e3884 * (_e3555[0] - _e3567[0])) + (_e3886 * (_e3555[1] - _e3567[1]))) + (_e3888 * (_e3555[2] - _e3567[2])));
                                        let _e3995 = (((_e3884 * _e3555[0]) + (_e3886 * _e3555[1])) + (_e3888 * _e3555[2]));
                                        if (_e3959 < 0f) {
                                            phi_2715_ = -(_e3959);
                                        } else {
                                            phi_2715_ = _e3959;
                                        }
                                        let _e4000 = phi_2715_;
                                        if (_e3980 < 0f) {
                                            phi_2721_ = -(_e3980);
                                        } else {
                                            phi_2721_ = _e3980;
                                        }
                                        let _e4004 = phi_2721_;
                                        if (_e3964 < 0f) {
                                            phi_2730_ = -(_e3964);
                                        } else {
                                            phi_2730_ = _e3964;
                                        }
                                        let _e4011 = phi_2730_;
                                        if (_e3985 < 0f) {
                                            phi_2736_ = -(_e3985);
                                        } else {
                                            phi_2736_ = _e3985;
                                        }
                                        let _e4015 = phi_2736_;
                                        if (_e3969 < 0f) {
                                            phi_2745_ = -(_e3969);
                                        } else {
                                            phi_2745_ = _e3969;
                                        }
                                        let _e4022 = phi_2745_;
                                        if (_e3990 < 0f) {
                                            phi_2751_ = -(_e3990);
                                        } else {
                                            phi_2751_ = _e3990;
                                        }
                                        let _e4026 = phi_2751_;
                                        if (_e3974 < 0f) {
                                            phi_2760_ = -(_e3974);
                                        } else {
                                            phi_2760_ = _e3974;
                                        }
                                        let _e4033 = phi_2760_;
                                        if (_e3995 < 0f) {
                                            phi_2766_ = -(_e3995);
                                        } else {
                                            phi_2766_ = _e3995;
                                        }
                                        let _e4037 = phi_2766_;
                                        phi_2772_ = type_30(array<f32, 4>(_e3959, _e3964, _e3969, _e3974), array<f32, 4>(_e3980, _e3985, _e3990, _e3995), array<f32, 4>((_e3954 + ((_e4000 + _e4004) * _e3949)), (_e3954 + ((_e4011 + _e4015) * _e3949)), (_e3954 + ((_e4022 + _e4026) * _e3949)), (_e3954 + ((_e4033 + _e4037) * _e3949))));
                                        phi_2773_ = false;
                                    } else {
                                        phi_2772_ = type_30();
                                        phi_2773_ = true;
                                    }
                                    let _e4044 = phi_2772_;
                                    let _e4046 = phi_2773_;
                                    phi_2774_ = _e4044;
                                    phi_2775_ = _e4046;
                                } else {
                                    phi_2774_ = type_30();
                                    phi_2775_ = true;
                                }
                                let _e4048 = phi_2774_;
                                let _e4050 = phi_2775_;
                                if _e4050 {
                                    phi_2783_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2783_ = _e4048;
                                }
                                let _e4052 = phi_2783_;
                                local_10 = type_30(array<f32, 4>(_e4052.member[0], _e4052.member[1], _e4052.member[2], _e4052.member[3]), array<f32, 4>(_e4052.member_1[0], _e4052.member_1[1], _e4052.member_1[2], _e4052.member_1[3]), array<f32, 4>(_e4052.member_2[0], _e4052.member_2[1], _e4052.member_2[2], _e4052.member_2[3]));
                                let _e4072 = (_e3752 - _e3756);
                                let _e4076 = local_10.member[0u];
                                let _e4079 = local_10.member_1[0u];
                                let _e4082 = local_10.member[0u];
                                let _e4088 = local_10.member_2[0u];
                                if (((_e4076 + ((_e4079 - _e4082) * _e3752)) - _e4088) > 0f) {
                                    let _e4093 = local_10.member[1u];
                                    let _e4096 = local_10.member_1[1u];
                                    let _e4099 = local_10.member[1u];
                                    let _e4105 = local_10.member_2[1u];
                                    if (((_e4093 + ((_e4096 - _e4099) * _e3752)) - _e4105) > 0f) {
                                        let _e4110 = local_10.member[2u];
                                        let _e4113 = local_10.member_1[2u];
                                        let _e4116 = local_10.member[2u];
                                        let _e4122 = local_10.member_2[2u];
                                        if (((_e4110 + ((_e4113 - _e4116) * _e3752)) - _e4122) > 0f) {
                                            let _e4127 = local_10.member[3u];
                                            let _e4130 = local_10.member_1[3u];
                                            let _e4133 = local_10.member[3u];
                                            let _e4139 = local_10.member_2[3u];
                                            phi_2954_ = (((_e4127 + ((_e4130 - _e4133) * _e3752)) - _e4139) > 0f);
                                            phi_2955_ = false;
                                        } else {
                                            phi_2954_ = bool();
                                            phi_2955_ = true;
                                        }
                                        let _e4143 = phi_2954_;
                                        let _e4145 = phi_2955_;
                                        phi_2956_ = _e4143;
                                        phi_2957_ = _e4145;
                                    } else {
                                        phi_2956_ = bool();
                                        phi_2957_ = true;
                                    }
                                    let _e4147 = phi_2956_;
                                    let _e4149 = phi_2957_;
                                    phi_2958_ = _e4147;
                                    phi_2959_ = _e4149;
                                } else {
                                    phi_2958_ = bool();
                                    phi_2959_ = true;
                                }
                                let _e4151 = phi_2958_;
                                let _e4153 = phi_2959_;
                                if _e4153 {
                                    phi_2963_ = false;
                                } else {
                                    phi_2963_ = _e4151;
                                }
                                let _e4155 = phi_2963_;
                                if _e4155 {
                                    if (_e3752 <= _e3754) {
                                        phi_3273_ = true;
                                    } else {
                                        let _e4159 = local_9.member[0u];
                                        let _e4162 = local_9.member_1[0u];
                                        let _e4165 = local_9.member[0u];
                                        let _e4171 = local_9.member_2[0u];
                                        let _e4175 = local_10.member[0u];
                                        let _e4178 = local_10.member_1[0u];
                                        let _e4181 = local_10.member[0u];
                                        let _e4187 = local_10.member_2[0u];
                                        if ((((_e4159 + ((_e4162 - _e4165) * _e3752)) - _e4171) + ((_e4175 + ((_e4178 - _e4181) * _e3756)) - _e4187)) > 0f) {
                                            let _e4193 = local_9.member[1u];
                                            let _e4196 = local_9.member_1[1u];
                                            let _e4199 = local_9.member[1u];
                                            let _e4205 = local_9.member_2[1u];
                                            let _e4209 = local_10.member[1u];
                                            let _e4212 = local_10.member_1[1u];
                                            let _e4215 = local_10.member[1u];
                                            let _e4221 = local_10.member_2[1u];
                                            if ((((_e4193 + ((_e4196 - _e4199) * _e3752)) - _e4205) + ((_e4209 + ((_e4212 - _e4215) * _e3756)) - _e4221)) > 0f) {
                                                let _e4227 = local_9.member[2u];
                                                let _e4230 = local_9.member_1[2u];
                                                let _e4233 = local_9.member[2u];
                                                let _e4239 = local_9.member_2[2u];
                                                let _e4243 = local_10.member[2u];
                                                let _e4246 = local_10.member_1[2u];
                                                let _e4249 = local_10.member[2u];
                                                let _e4255 = local_10.member_2[2u];
                                                if ((((_e4227 + ((_e4230 - _e4233) * _e3752)) - _e4239) + ((_e4243 + ((_e4246 - _e4249) * _e3756)) - _e4255)) > 0f) {
                                                    let _e4261 = local_9.member[3u];
                                                    let _e4264 = local_9.member_1[3u];
                                                    let _e4267 = local_9.member[3u];
                                                    let _e4273 = local_9.member_2[3u];
                                                    let _e4277 = local_10.member[3u];
                                                    let _e4280 = local_10.member_1[3u];
                                                    let _e4283 = local_10.member[3u];
                                                    let _e4289 = local_10.member_2[3u];
                                                    phi_3260_ = ((((_e4261 + ((_e4264 - _e4267) * _e3752)) - _e4273) + ((_e4277 + ((_e4280 - _e4283) * _e3756)) - _e4289)) > 0f);
                                                    phi_3261_ = false;
                                                } else {
                                                    phi_3260_ = bool();
                                                    phi_3261_ = true;
                                                }
                                                let _e4294 = phi_3260_;
                                                let _e4296 = phi_3261_;
                                                phi_3262_ = _e4294;
                                                phi_3263_ = _e4296;
                                            } else {
                                                phi_3262_ = bool();
                                                phi_3263_ = true;
                                            }
                                            let _e4298 = phi_3262_;
                                            let _e4300 = phi_3263_;
                                            phi_3264_ = _e4298;
                                            phi_3265_ = _e4300;
                                        } else {
                                            phi_3264_ = bool();
                                            phi_3265_ = true;
                                        }
                                        let _e4302 = phi_3264_;
                                        let _e4304 = phi_3265_;
                                        if _e4304 {
                                            phi_3269_ = false;
                                        } else {
                                            phi_3269_ = _e4302;
                                        }
                                        let _e4306 = phi_3269_;
                                        phi_3273_ = _e4306;
                                    }
                                    let _e4308 = phi_3273_;
                                    if _e4308 {
                                        if _e3758 {
                                            if (_e3752 >= 1f) {
                                                phi_3284_ = false;
                                            } else {
                                                phi_3284_ = true;
                                            }
                                            let _e4311 = phi_3284_;
                                            phi_3285_ = _e4311;
                                        } else {
                                            phi_3285_ = true;
                                        }
                                        let _e4313 = phi_3285_;
                                        if _e4313 {
                                            local_9 = type_30(array<f32, 4>(_e4052.member[0], _e4052.member[1], _e4052.member[2], _e4052.member[3]), array<f32, 4>(_e4052.member_1[0], _e4052.member_1[1], _e4052.member_1[2], _e4052.member_1[3]), array<f32, 4>(_e4052.member_2[0], _e4052.member_2[1], _e4052.member_2[2], _e4052.member_2[3]));
                                            let _e4335 = local_9.member[0u];
                                            let _e4338 = local_9.member_1[0u];
                                            let _e4341 = local_9.member_2[0u];
                                            if (_e4335 > _e4341) {
                                                if (_e4338 > _e4341) {
                                                    phi_3359_ = false;
                                                } else {
                                                    phi_3359_ = true;
                                                }
                                                let _e4345 = phi_3359_;
                                                phi_3360_ = _e4345;
                                            } else {
                                                phi_3360_ = true;
                                            }
                                            let _e4347 = phi_3360_;
                                            if _e4347 {
                                                let _e4348 = (_e4338 >= _e4335);
                                                if _e4348 {
                                                    phi_3382_ = f32();
                                                    phi_3383_ = false;
                                                } else {
                                                    if ((_e4335 - _e4338) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3380_ = (((_e4335 - _e4341) / (_e4335 - _e4338)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3381_ = false;
                                                    } else {
                                                        phi_3380_ = f32();
                                                        phi_3381_ = true;
                                                    }
                                                    let _e4359 = phi_3380_;
                                                    let _e4361 = phi_3381_;
                                                    phi_3382_ = _e4359;
                                                    phi_3383_ = _e4361;
                                                }
                                                let _e4363 = phi_3382_;
                                                let _e4365 = phi_3383_;
                                                phi_3384_ = _e4363;
                                                phi_3385_ = _e4348;
                                                phi_3386_ = _e4365;
                                            } else {
                                                phi_3384_ = f32();
                                                phi_3385_ = true;
                                                phi_3386_ = false;
                                            }
                                            let _e4367 = phi_3384_;
                                            let _e4369 = phi_3385_;
                                            let _e4371 = phi_3386_;
                                            if _e4369 {
                                                phi_3390_ = 2f;
                                                phi_3391_ = true;
                                            } else {
                                                phi_3390_ = _e3752;
                                                phi_3391_ = _e4371;
                                            }
                                            let _e4373 = phi_3390_;
                                            let _e4375 = phi_3391_;
                                            if _e4375 {
                                                phi_3395_ = _e4373;
                                            } else {
                                                phi_3395_ = _e4367;
                                            }
                                            let _e4377 = phi_3395_;
                                            let _e4380 = local_9.member[1u];
                                            let _e4383 = local_9.member_1[1u];
                                            let _e4386 = local_9.member_2[1u];
                                            if (_e4380 > _e4386) {
                                                if (_e4383 > _e4386) {
                                                    phi_3427_ = false;
                                                } else {
                                                    phi_3427_ = true;
                                                }
                                                let _e4390 = phi_3427_;
                                                phi_3428_ = _e4390;
                                            } else {
                                                phi_3428_ = true;
                                            }
                                            let _e4392 = phi_3428_;
                                            if _e4392 {
                                                let _e4393 = (_e4383 >= _e4380);
                                                if _e4393 {
                                                    phi_3450_ = f32();
                                                    phi_3451_ = false;
                                                } else {
                                                    if ((_e4380 - _e4383) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3448_ = (((_e4380 - _e4386) / (_e4380 - _e4383)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3449_ = false;
                                                    } else {
                                                        phi_3448_ = f32();
                                                        phi_3449_ = true;
                                                    }
                                                    let _e4404 = phi_3448_;
                                                    let _e4406 = phi_3449_;
                                                    phi_3450_ = _e4404;
                                                    phi_3451_ = _e4406;
                                                }
                                                let _e4408 = phi_3450_;
                                                let _e4410 = phi_3451_;
                                                phi_3452_ = _e4408;
                                                phi_3453_ = _e4393;
                                                phi_3454_ = _e4410;
                                            } else {
                                                phi_3452_ = f32();
                                                phi_3453_ = true;
                                                phi_3454_ = false;
                                            }
                                            let _e4412 = phi_3452_;
                                            let _e4414 = phi_3453_;
                                            let _e4416 = phi_3454_;
                                            if _e4414 {
                                                phi_3458_ = 2f;
                                                phi_3459_ = true;
                                            } else {
                                                phi_3458_ = _e3752;
                                                phi_3459_ = _e4416;
                                            }
                                            let _e4418 = phi_3458_;
                                            let _e4420 = phi_3459_;
                                            if _e4420 {
                                                phi_3463_ = _e4418;
                                            } else {
                                                phi_3463_ = _e4412;
                                            }
                                            let _e4422 = phi_3463_;
                                            if (_e4377 < _e4422) {
                                                phi_3468_ = _e4377;
                                            } else {
                                                phi_3468_ = _e4422;
                                            }
                                            let _e4425 = phi_3468_;
                                            let _e4428 = local_9.member[2u];
                                            let _e4431 = local_9.member_1[2u];
                                            let _e4434 = local_9.member_2[2u];
                                            if (_e4428 > _e4434) {
                                                if (_e4431 > _e4434) {
                                                    phi_3500_ = false;
                                                } else {
                                                    phi_3500_ = true;
                                                }
                                                let _e4438 = phi_3500_;
                                                phi_3501_ = _e4438;
                                            } else {
                                                phi_3501_ = true;
                                            }
                                            let _e4440 = phi_3501_;
                                            if _e4440 {
                                                let _e4441 = (_e4431 >= _e4428);
                                                if _e4441 {
                                                    phi_3523_ = f32();
                                                    phi_3524_ = false;
                                                } else {
                                                    if ((_e4428 - _e4431) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3521_ = (((_e4428 - _e4434) / (_e4428 - _e4431)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3522_ = false;
                                                    } else {
                                                        phi_3521_ = f32();
                                                        phi_3522_ = true;
                                                    }
                                                    let _e4452 = phi_3521_;
                                                    let _e4454 = phi_3522_;
                                                    phi_3523_ = _e4452;
                                                    phi_3524_ = _e4454;
                                                }
                                                let _e4456 = phi_3523_;
                                                let _e4458 = phi_3524_;
                                                phi_3525_ = _e4456;
                                                phi_3526_ = _e4441;
                                                phi_3527_ = _e4458;
                                            } else {
                                                phi_3525_ = f32();
                                                phi_3526_ = true;
                                                phi_3527_ = false;
                                            }
                                            let _e4460 = phi_3525_;
                                            let _e4462 = phi_3526_;
                                            let _e4464 = phi_3527_;
                                            if _e4462 {
                                                phi_3531_ = 2f;
                                                phi_3532_ = true;
                                            } else {
                                                phi_3531_ = _e3752;
                                                phi_3532_ = _e4464;
                                            }
                                            let _e4466 = phi_3531_;
                                            let _e4468 = phi_3532_;
                                            if _e4468 {
                                                phi_3536_ = _e4466;
                                            } else {
                                                phi_3536_ = _e4460;
                                            }
                                            let _e4470 = phi_3536_;
                                            let _e4473 = local_9.member[3u];
                                            let _e4476 = local_9.member_1[3u];
                                            let _e4479 = local_9.member_2[3u];
                                            if (_e4473 > _e4479) {
                                                if (_e4476 > _e4479) {
                                                    phi_3568_ = false;
                                                } else {
                                                    phi_3568_ = true;
                                                }
                                                let _e4483 = phi_3568_;
                                                phi_3569_ = _e4483;
                                            } else {
                                                phi_3569_ = true;
                                            }
                                            let _e4485 = phi_3569_;
                                            if _e4485 {
                                                let _e4486 = (_e4476 >= _e4473);
                                                if _e4486 {
                                                    phi_3591_ = f32();
                                                    phi_3592_ = false;
                                                } else {
                                                    if ((_e4473 - _e4476) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3589_ = (((_e4473 - _e4479) / (_e4473 - _e4476)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3590_ = false;
                                                    } else {
                                                        phi_3589_ = f32();
                                                        phi_3590_ = true;
                                                    }
                                                    let _e4497 = phi_3589_;
                                                    let _e4499 = phi_3590_;
                                                    phi_3591_ = _e4497;
                                                    phi_3592_ = _e4499;
                                                }
                                                let _e4501 = phi_3591_;
                                                let _e4503 = phi_3592_;
                                                phi_3593_ = _e4501;
                                                phi_3594_ = _e4486;
                                                phi_3595_ = _e4503;
                                            } else {
                                                phi_3593_ = f32();
                                                phi_3594_ = true;
                                                phi_3595_ = false;
                                            }
                                            let _e4505 = phi_3593_;
                                            let _e4507 = phi_3594_;
                                            let _e4509 = phi_3595_;
                                            if _e4507 {
                                                phi_3599_ = 2f;
                                                phi_3600_ = true;
                                            } else {
                                                phi_3599_ = _e3752;
                                                phi_3600_ = _e4509;
                                            }
                                            let _e4511 = phi_3599_;
                                            let _e4513 = phi_3600_;
                                            if _e4513 {
                                                phi_3604_ = _e4511;
                                            } else {
                                                phi_3604_ = _e4505;
                                            }
                                            let _e4515 = phi_3604_;
                                            if (_e4470 < _e4515) {
                                                phi_3609_ = _e4470;
                                            } else {
                                                phi_3609_ = _e4515;
                                            }
                                            let _e4518 = phi_3609_;
                                            if (_e4425 < _e4518) {
                                                phi_3614_ = _e4425;
                                            } else {
                                                phi_3614_ = _e4518;
                                            }
                                            let _e4521 = phi_3614_;
                                            if (_e4521 > _e3752) {
                                                phi_3619_ = _e4521;
                                            } else {
                                                phi_3619_ = _e3752;
                                            }
                                            let _e4524 = phi_3619_;
                                            let _e4525 = (_e4524 > 1f);
                                            if _e4525 {
                                                phi_3630_ = f32();
                                                phi_3631_ = false;
                                            } else {
                                                if _e3758 {
                                                    phi_3629_ = (_e4072 + _e4072);
                                                } else {
                                                    phi_3629_ = (1f - _e3752);
                                                }
                                                let _e4529 = phi_3629_;
                                                phi_3630_ = _e4529;
                                                phi_3631_ = true;
                                            }
                                            let _e4531 = phi_3630_;
                                            let _e4533 = phi_3631_;
                                            phi_3632_ = _e4524;
                                            phi_3633_ = _e4531;
                                            phi_3634_ = _e4533;
                                            phi_3635_ = _e4525;
                                            phi_3636_ = false;
                                        } else {
                                            phi_3632_ = f32();
                                            phi_3633_ = f32();
                                            phi_3634_ = false;
                                            phi_3635_ = false;
                                            phi_3636_ = true;
                                        }
                                        let _e4535 = phi_3632_;
                                        let _e4537 = phi_3633_;
                                        let _e4539 = phi_3634_;
                                        let _e4541 = phi_3635_;
                                        let _e4543 = phi_3636_;
                                        phi_3637_ = _e4535;
                                        phi_3638_ = _e4537;
                                        phi_3639_ = false;
                                        phi_3640_ = _e4539;
                                        phi_3641_ = _e4541;
                                        phi_3642_ = _e4543;
                                    } else {
                                        phi_3637_ = f32();
                                        phi_3638_ = f32();
                                        phi_3639_ = true;
                                        phi_3640_ = false;
                                        phi_3641_ = false;
                                        phi_3642_ = false;
                                    }
                                    let _e4545 = phi_3637_;
                                    let _e4547 = phi_3638_;
                                    let _e4549 = phi_3639_;
                                    let _e4551 = phi_3640_;
                                    let _e4553 = phi_3641_;
                                    let _e4555 = phi_3642_;
                                    phi_3643_ = _e4545;
                                    phi_3644_ = _e4547;
                                    phi_3645_ = _e4549;
                                    phi_3646_ = _e4551;
                                    phi_3647_ = _e4553;
                                    phi_3648_ = _e4555;
                                } else {
                                    phi_3643_ = f32();
                                    phi_3644_ = f32();
                                    phi_3645_ = true;
                                    phi_3646_ = false;
                                    phi_3647_ = false;
                                    phi_3648_ = false;
                                }
                                let _e4557 = phi_3643_;
                                let _e4559 = phi_3644_;
                                let _e4561 = phi_3645_;
                                let _e4563 = phi_3646_;
                                let _e4565 = phi_3647_;
                                let _e4567 = phi_3648_;
                                if _e4561 {
                                    if (_e3752 <= _e3754) {
                                        let _e4728 = (_e3760 + 1u);
                                        let _e4729 = (_e4728 > 3u);
                                        if _e4729 {
                                            phi_3661_ = false;
                                        } else {
                                            phi_3661_ = true;
                                        }
                                        let _e4731 = phi_3661_;
                                        phi_3983_ = _e4728;
                                        phi_3984_ = f32();
                                        phi_3985_ = false;
                                        phi_3986_ = _e4731;
                                        phi_3987_ = _e4729;
                                    } else {
                                        let _e4571 = local_9.member[0u];
                                        let _e4574 = local_9.member_1[0u];
                                        let _e4577 = local_9.member[0u];
                                        let _e4583 = local_9.member_2[0u];
                                        let _e4584 = ((_e4571 + ((_e4574 - _e4577) * _e3756)) - _e4583);
                                        let _e4587 = local_9.member[1u];
                                        let _e4590 = local_9.member_1[1u];
                                        let _e4593 = local_9.member[1u];
                                        let _e4599 = local_9.member_2[1u];
                                        let _e4600 = ((_e4587 + ((_e4590 - _e4593) * _e3756)) - _e4599);
                                        if (_e4584 < _e4600) {
                                            phi_3734_ = _e4584;
                                        } else {
                                            phi_3734_ = _e4600;
                                        }
                                        let _e4603 = phi_3734_;
                                        let _e4606 = local_9.member[2u];
                                        let _e4609 = local_9.member_1[2u];
                                        let _e4612 = local_9.member[2u];
                                        let _e4618 = local_9.member_2[2u];
                                        let _e4619 = ((_e4606 + ((_e4609 - _e4612) * _e3756)) - _e4618);
                                        let _e4622 = local_9.member[3u];
                                        let _e4625 = local_9.member_1[3u];
                                        let _e4628 = local_9.member[3u];
                                        let _e4634 = local_9.member_2[3u];
                                        let _e4635 = ((_e4622 + ((_e4625 - _e4628) * _e3756)) - _e4634);
                                        if (_e4619 < _e4635) {
                                            phi_3807_ = _e4619;
                                        } else {
                                            phi_3807_ = _e4635;
                                        }
                                        let _e4638 = phi_3807_;
                                        if (_e4603 < _e4638) {
                                            phi_3812_ = _e4603;
                                        } else {
                                            phi_3812_ = _e4638;
                                        }
                                        let _e4641 = phi_3812_;
                                        let _e4644 = local_10.member[0u];
                                        let _e4647 = local_10.member_1[0u];
                                        let _e4650 = local_10.member[0u];
                                        let _e4656 = local_10.member_2[0u];
                                        let _e4657 = ((_e4644 + ((_e4647 - _e4650) * _e3752)) - _e4656);
                                        let _e4660 = local_10.member[1u];
                                        let _e4663 = local_10.member_1[1u];
                                        let _e4666 = local_10.member[1u];
                                        let _e4672 = local_10.member_2[1u];
                                        let _e4673 = ((_e4660 + ((_e4663 - _e4666) * _e3752)) - _e4672);
                                        if (_e4657 < _e4673) {
                                            phi_3885_ = _e4657;
                                        } else {
                                            phi_3885_ = _e4673;
                                        }
                                        let _e4676 = phi_3885_;
                                        let _e4679 = local_10.member[2u];
                                        let _e4682 = local_10.member_1[2u];
                                        let _e4685 = local_10.member[2u];
                                        let _e4691 = local_10.member_2[2u];
                                        let _e4692 = ((_e4679 + ((_e4682 - _e4685) * _e3752)) - _e4691);
                                        let _e4695 = local_10.member[3u];
                                        let _e4698 = local_10.member_1[3u];
                                        let _e4701 = local_10.member[3u];
                                        let _e4707 = local_10.member_2[3u];
                                        let _e4708 = ((_e4695 + ((_e4698 - _e4701) * _e3752)) - _e4707);
                                        if (_e4692 < _e4708) {
                                            phi_3958_ = _e4692;
                                        } else {
                                            phi_3958_ = _e4708;
                                        }
                                        let _e4711 = phi_3958_;
                                        if (_e4676 < _e4711) {
                                            phi_3963_ = _e4676;
                                        } else {
                                            phi_3963_ = _e4711;
                                        }
                                        let _e4714 = phi_3963_;
                                        if (_e4714 > 0f) {
                                            phi_3981_ = 0.5f;
                                        } else {
                                            let _e4718 = (0.95f * (_e4641 / (_e4641 - _e4714)));
                                            if (_e4718 > 0.0625f) {
                                                if (_e4718 < 0.9f) {
                                                    phi_3979_ = _e4718;
                                                } else {
                                                    phi_3979_ = 0.9f;
                                                }
                                                let _e4722 = phi_3979_;
                                                phi_3980_ = _e4722;
                                            } else {
                                                phi_3980_ = 0.0625f;
                                            }
                                            let _e4724 = phi_3980_;
                                            phi_3981_ = _e4724;
                                        }
                                        let _e4726 = phi_3981_;
                                        phi_3983_ = u32();
                                        phi_3984_ = (_e4072 * _e4726);
                                        phi_3985_ = true;
                                        phi_3986_ = false;
                                        phi_3987_ = false;
                                    }
                                    let _e4733 = phi_3983_;
                                    let _e4735 = phi_3984_;
                                    let _e4737 = phi_3985_;
                                    let _e4739 = phi_3986_;
                                    let _e4741 = phi_3987_;
                                    phi_3988_ = _e4733;
                                    phi_3989_ = _e3754;
                                    phi_3990_ = _e4735;
                                    phi_3991_ = _e3756;
                                    phi_3992_ = _e3758;
                                    phi_3993_ = _e3760;
                                    phi_3994_ = _e4737;
                                    phi_3995_ = _e4739;
                                    phi_3996_ = _e4741;
                                    phi_3997_ = false;
                                    phi_3998_ = false;
                                } else {
                                    phi_3988_ = u32();
                                    phi_3989_ = _e4557;
                                    phi_3990_ = _e4559;
                                    phi_3991_ = _e3752;
                                    phi_3992_ = true;
                                    phi_3993_ = 0u;
                                    phi_3994_ = _e4563;
                                    phi_3995_ = false;
                                    phi_3996_ = false;
                                    phi_3997_ = _e4565;
                                    phi_3998_ = _e4567;
                                }
                                let _e4743 = phi_3988_;
                                let _e4745 = phi_3989_;
                                let _e4747 = phi_3990_;
                                let _e4749 = phi_3991_;
                                let _e4751 = phi_3992_;
                                let _e4753 = phi_3993_;
                                let _e4755 = phi_3994_;
                                let _e4757 = phi_3995_;
                                let _e4759 = phi_3996_;
                                let _e4761 = phi_3997_;
                                let _e4763 = phi_3998_;
                                if _e4755 {
                                    let _e4764 = (_e4749 + _e4747);
                                    if (_e4764 > _e4745) {
                                        phi_4007_ = _e4764;
                                    } else {
                                        phi_4007_ = _e4745;
                                    }
                                    let _e4767 = phi_4007_;
                                    if (_e4767 < 1f) {
                                        phi_4012_ = _e4767;
                                    } else {
                                        phi_4012_ = 1f;
                                    }
                                    let _e4770 = phi_4012_;
                                    if !(_e3758) {
                                        phi_4021_ = true;
                                    } else {
                                        phi_4021_ = ((_e4770 - _e4749) > 0.0000000037252903f);
                                    }
                                    let _e4774 = phi_4021_;
                                    if _e4774 {
                                        phi_4025_ = false;
                                    } else {
                                        phi_4025_ = true;
                                    }
                                    let _e4776 = phi_4025_;
                                    phi_4026_ = _e4770;
                                    phi_4027_ = _e4745;
                                    phi_4028_ = _e4749;
                                    phi_4029_ = _e4751;
                                    phi_4030_ = _e4753;
                                    phi_4031_ = _e4774;
                                    phi_4032_ = _e4776;
                                    phi_4033_ = false;
                                    phi_4034_ = false;
                                    phi_4035_ = false;
                                } else {
                                    phi_4026_ = _e3752;
                                    phi_4027_ = _e3754;
                                    phi_4028_ = _e3756;
                                    phi_4029_ = _e3758;
                                    phi_4030_ = _e4743;
                                    phi_4031_ = _e4757;
                                    phi_4032_ = false;
                                    phi_4033_ = _e4759;
                                    phi_4034_ = _e4761;
                                    phi_4035_ = _e4763;
                                }
                                let _e4778 = phi_4026_;
                                let _e4780 = phi_4027_;
                                let _e4782 = phi_4028_;
                                let _e4784 = phi_4029_;
                                let _e4786 = phi_4030_;
                                let _e4788 = phi_4031_;
                                let _e4790 = phi_4032_;
                                let _e4792 = phi_4033_;
                                let _e4794 = phi_4034_;
                                let _e4796 = phi_4035_;
                                phi_2368_ = _e4778;
                                phi_2370_ = _e4780;
                                phi_2372_ = _e4782;
                                phi_2374_ = _e4784;
                                phi_2376_ = _e4786;
                                phi_4036_ = _e4745;
                                phi_4037_ = _e4788;
                                phi_4038_ = _e4790;
                                phi_4039_ = false;
                                phi_4040_ = _e4792;
                                phi_4041_ = _e4794;
                                phi_4042_ = _e4796;
                            } else {
                                phi_2368_ = f32();
                                phi_2370_ = f32();
                                phi_2372_ = f32();
                                phi_2374_ = bool();
                                phi_2376_ = u32();
                                phi_4036_ = f32();
                                phi_4037_ = false;
                                phi_4038_ = false;
                                phi_4039_ = true;
                                phi_4040_ = false;
                                phi_4041_ = false;
                                phi_4042_ = false;
                            }
                            let _e4798 = phi_2368_;
                            let _e4800 = phi_2370_;
                            let _e4802 = phi_2372_;
                            let _e4804 = phi_2374_;
                            let _e4806 = phi_2376_;
                            let _e4808 = phi_4036_;
                            let _e4810 = phi_4037_;
                            let _e4812 = phi_4038_;
                            let _e4814 = phi_4039_;
                            let _e4816 = phi_4040_;
                            let _e4818 = phi_4041_;
                            let _e4820 = phi_4042_;
                            local_25 = _e4812;
                            local_43 = _e4808;
                            local_45 = _e4814;
                            local_46 = _e4816;
                            local_47 = _e4818;
                            local_48 = _e4820;
                            continue;
                            continuing {
                                phi_2364_ = _e3772;
                                phi_2367_ = _e4798;
                                phi_2369_ = _e4800;
                                phi_2371_ = _e4802;
                                phi_2373_ = _e4804;
                                phi_2375_ = _e4806;
                                break if !(_e4810);
                            }
                        }
                        let _e4823 = local_25;
                        if _e4823 {
                            let _e6176 = local_43;
                            phi_4046_ = _e6176;
                            phi_4047_ = true;
                            phi_4048_ = false;
                            phi_4049_ = false;
                            phi_4050_ = false;
                        } else {
                            let _e6178 = local_44;
                            phi_4046_ = _e6178;
                            let _e6181 = local_45;
                            phi_4047_ = _e6181;
                            let _e6184 = local_46;
                            phi_4048_ = _e6184;
                            let _e6187 = local_47;
                            phi_4049_ = _e6187;
                            let _e6190 = local_48;
                            phi_4050_ = _e6190;
                        }
                        let _e4825 = phi_4046_;
                        let _e4827 = phi_4047_;
                        let _e4829 = phi_4048_;
                        let _e4831 = phi_4049_;
                        let _e4833 = phi_4050_;
                        if _e4827 {
                            phi_4055_ = type_35(1u, _e4825);
                            phi_4056_ = false;
                            phi_4057_ = false;
                            phi_4058_ = false;
                        } else {
                            phi_4055_ = type_35();
                            phi_4056_ = _e4829;
                            phi_4057_ = _e4831;
                            phi_4058_ = _e4833;
                        }
                        let _e4836 = phi_4055_;
                        let _e4838 = phi_4056_;
                        let _e4840 = phi_4057_;
                        let _e4842 = phi_4058_;
                        if _e4838 {
                            let _e4844 = local_26;
                            phi_4063_ = type_35(1u, _e4844);
                            phi_4064_ = false;
                            phi_4065_ = false;
                        } else {
                            phi_4063_ = type_35();
                            phi_4064_ = _e4840;
                            phi_4065_ = _e4842;
                        }
                        let _e4847 = phi_4063_;
                        let _e4849 = phi_4064_;
                        let _e4851 = phi_4065_;
                        if _e4849 {
                            phi_4070_ = type_35(0u, type_35().member_1);
                            phi_4071_ = false;
                            phi_4072_ = true;
                        } else {
                            phi_4070_ = _e4847;
                            phi_4071_ = _e4851;
                            phi_4072_ = _e4838;
                        }
                        let _e4855 = phi_4070_;
                        let _e4857 = phi_4071_;
                        let _e4859 = phi_4072_;
                        if _e4857 {
                            phi_4077_ = type_35(0u, type_35().member_1);
                            phi_4078_ = true;
                        } else {
                            phi_4077_ = _e4855;
                            phi_4078_ = _e4859;
                        }
                        let _e4863 = phi_4077_;
                        let _e4865 = phi_4078_;
                        if _e4865 {
                            phi_4082_ = _e4863;
                        } else {
                            phi_4082_ = _e4836;
                        }
                        let _e4867 = phi_4082_;
                        if (_e4867.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4096_ = type_9(0u, 3u);
                            loop {
                                let _e4879 = phi_4096_;
                                if (_e4879.member < _e4879.member_1) {
                                    phi_4097_ = type_9((_e4879.member + 1u), _e4879.member_1);
                                    phi_4120_ = type_9(1u, _e4879.member);
                                } else {
                                    phi_4097_ = _e4879;
                                    phi_4120_ = type_9(0u, type_9().member_1);
                                }
                                let _e4891 = phi_4097_;
                                let _e4893 = phi_4120_;
                                if (bitcast<i32>(_e4893.member) != 0i) {
                                    let _e4899 = local_11[_e4893.member_1];
                                    let _e4900 = (_e4867.member_1 + _e4899);
                                    if (_e4900 < 1f) {
                                        phi_4140_ = _e4900;
                                    } else {
                                        phi_4140_ = 1f;
                                    }
                                    let _e4903 = phi_4140_;
                                    let _e4906 = local_12.member[0u];
                                    let _e4912 = local_12.member[1u];
                                    let _e4928 = local_12.member_1[0u];
                                    let _e4934 = local_12.member_1[1u];
                                    let _e4950 = local_12.member_2[0u];
                                    let _e4956 = local_12.member_2[1u];
                                    let _e4970 = function_1(array<f32, 3>((_e4906[0] + ((_e4912[0] - _e4906[0]) * _e4903)), (_e4906[1] + ((_e4912[1] - _e4906[1]) * _e4903)), (_e4906[2] + ((_e4912[2] - _e4906[2]) * _e4903))), array<f32, 3>((_e4928[0] + ((_e4934[0] - _e4928[0]) * _e4903)), (_e4928[1] + ((_e4934[1] - _e4928[1]) * _e4903)), (_e4928[2] + ((_e4934[2] - _e4928[2]) * _e4903))), array<f32, 3>((_e4950[0] + ((_e4956[0] - _e4950[0]) * _e4903)), (_e4950[1] + ((_e4956[1] - _e4950[1]) * _e4903)), (_e4950[2] + ((_e4956[2] - _e4950[2]) * _e4903))), 0u);
                                    let _e4981 = (((_e4970[0] * _e4970[0]) + (_e4970[1] * _e4970[1])) + (_e4970[2] * _e4970[2]));
                                    if (_e4981 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4981 > 0f) {
                                            phi_4263_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4263_ = 0f;
                                        }
                                        let _e5034 = phi_4263_;
                                        phi_4327_ = _e5034;
                                    } else {
                                        phi_4270_ = type_14(0i, 5i);
                                        phi_4273_ = bitcast<f32>(((bitcast<u32>(_e4981) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4989 = phi_4270_;
                                            let _e4991 = phi_4273_;
                                            local_27 = _e4991;
                                            if (_e4989.member < _e4989.member_1) {
                                                let _e4998 = (_e4989.member + 1i);
                                                if ((false == (_e4998 > _e4989.member)) != false) {
                                                    phi_4294_ = true;
                                                } else {
                                                    phi_4294_ = false;
                                                }
                                                let _e5003 = phi_4294_;
                                                if _e5003 {
                                                    phi_4300_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_4300_ = type_15(1u, _e4998);
                                                }
                                                let _e5008 = phi_4300_;
                                                phi_4271_ = type_14(_e5008.member_1, _e4989.member_1);
                                                phi_4314_ = type_15(1u, _e4989.member);
                                            } else {
                                                phi_4271_ = _e4989;
                                                phi_4314_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5014 = phi_4271_;
                                            let _e5016 = phi_4314_;
                                            let _e5019 = (bitcast<i32>(_e5016.member) != 0i);
                                            if _e5019 {
                                                phi_4274_ = (0.5f * (_e4991 + (_e4981 / _e4991)));
                                            } else {
                                                phi_4274_ = f32();
                                            }
                                            let _e5024 = phi_4274_;
                                            continue;
                                            continuing {
                                                phi_4270_ = _e5014;
                                                phi_4273_ = _e5024;
                                                break if !(_e5019);
                                            }
                                        }
                                        let _e5029 = local_27;
                                        phi_4327_ = (_e5029 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5036 = phi_4327_;
                                    let _e5042 = local_12.member[0u];
                                    if (_e5042[0] < 0f) {
                                        phi_4343_ = -(_e5042[0]);
                                    } else {
                                        phi_4343_ = _e5042[0];
                                    }
                                    let _e5049 = phi_4343_;
                                    if (_e5042[1] < 0f) {
                                        phi_4350_ = -(_e5042[1]);
                                    } else {
                                        phi_4350_ = _e5042[1];
                                    }
                                    let _e5053 = phi_4350_;
                                    if (_e5049 > _e5053) {
                                        phi_4355_ = _e5049;
                                    } else {
                                        phi_4355_ = _e5053;
                                    }
                                    let _e5056 = phi_4355_;
                                    if (_e5042[2] < 0f) {
                                        phi_4362_ = -(_e5042[2]);
                                    } else {
                                        phi_4362_ = _e5042[2];
                                    }
                                    let _e5060 = phi_4362_;
                                    if (_e5056 > _e5060) {
                                        phi_4367_ = _e5056;
                                    } else {
                                        phi_4367_ = _e5060;
                                    }
                                    let _e5063 = phi_4367_;
                                    let _e5066 = local_12.member[1u];
                                    if (_e5066[0] < 0f) {
                                        phi_4380_ = -(_e5066[0]);
                                    } else {
                                        phi_4380_ = _e5066[0];
                                    }
                                    let _e5073 = phi_4380_;
                                    if (_e5066[1] < 0f) {
                                        phi_4387_ = -(_e5066[1]);
                                    } else {
                                        phi_4387_ = _e5066[1];
                                    }
                                    let _e5077 = phi_4387_;
                                    if (_e5073 > _e5077) {
                                        phi_4392_ = _e5073;
                                    } else {
                                        phi_4392_ = _e5077;
                                    }
                                    let _e5080 = phi_4392_;
                                    if (_e5066[2] < 0f) {
                                        phi_4399_ = -(_e5066[2]);
                                    } else {
                                        phi_4399_ = _e5066[2];
                                    }
                                    let _e5084 = phi_4399_;
                                    if (_e5080 > _e5084) {
                                        phi_4404_ = _e5080;
                                    } else {
                                        phi_4404_ = _e5084;
                                    }
                                    let _e5087 = phi_4404_;
                                    if (_e5063 > _e5087) {
                                        phi_4409_ = _e5063;
                                    } else {
                                        phi_4409_ = _e5087;
                                    }
                                    let _e5090 = phi_4409_;
                                    let _e5092 = local_12.member_3;
                                    let _e5096 = local_12.member_1[0u];
                                    if (_e5096[0] < 0f) {
                                        phi_4426_ = -(_e5096[0]);
                                    } else {
                                        phi_4426_ = _e5096[0];
                                    }
                                    let _e5103 = phi_4426_;
                                    if (_e5096[1] < 0f) {
                                        phi_4433_ = -(_e5096[1]);
                                    } else {
                                        phi_4433_ = _e5096[1];
                                    }
                                    let _e5107 = phi_4433_;
                                    if (_e5103 > _e5107) {
                                        phi_4438_ = _e5103;
                                    } else {
                                        phi_4438_ = _e5107;
                                    }
                                    let _e5110 = phi_4438_;
                                    if (_e5096[2] < 0f) {
                                        phi_4445_ = -(_e5096[2]);
                                    } else {
                                        phi_4445_ = _e5096[2];
                                    }
                                    let _e5114 = phi_4445_;
                                    if (_e5110 > _e5114) {
                                        phi_4450_ = _e5110;
                                    } else {
                                        phi_4450_ = _e5114;
                                    }
                                    let _e5117 = phi_4450_;
                                    let _e5120 = local_12.member_1[1u];
                                    if (_e5120[0] < 0f) {
                                        phi_4464_ = -(_e5120[0]);
                                    } else {
                                        phi_4464_ = _e5120[0];
                                    }
                                    let _e5127 = phi_4464_;
                                    if (_e5120[1] < 0f) {
                                        phi_4471_ = -(_e5120[1]);
                                    } else {
                                        phi_4471_ = _e5120[1];
                                    }
                                    let _e5131 = phi_4471_;
                                    if (_e5127 > _e5131) {
                                        phi_4476_ = _e5127;
                                    } else {
                                        phi_4476_ = _e5131;
                                    }
                                    let _e5134 = phi_4476_;
                                    if (_e5120[2] < 0f) {
                                        phi_4483_ = -(_e5120[2]);
                                    } else {
                                        phi_4483_ = _e5120[2];
                                    }
                                    let _e5138 = phi_4483_;
                                    if (_e5134 > _e5138) {
                                        phi_4488_ = _e5134;
                                    } else {
                                        phi_4488_ = _e5138;
                                    }
                                    let _e5141 = phi_4488_;
                                    if (_e5117 > _e5141) {
                                        phi_4493_ = _e5117;
                                    } else {
                                        phi_4493_ = _e5141;
                                    }
                                    let _e5144 = phi_4493_;
                                    let _e5146 = local_12.member_3;
                                    let _e5150 = local_12.member_2[0u];
                                    if (_e5150[0] < 0f) {
                                        phi_4510_ = -(_e5150[0]);
                                    } else {
                                        phi_4510_ = _e5150[0];
                                    }
                                    let _e5157 = phi_4510_;
                                    if (_e5150[1] < 0f) {
                                        phi_4517_ = -(_e5150[1]);
                                    } else {
                                        phi_4517_ = _e5150[1];
                                    }
                                    let _e5161 = phi_4517_;
                                    if (_e5157 > _e5161) {
                                        phi_4522_ = _e5157;
                                    } else {
                                        phi_4522_ = _e5161;
                                    }
                                    let _e5164 = phi_4522_;
                                    if (_e5150[2] < 0f) {
                                        phi_4529_ = -(_e5150[2]);
                                    } else {
                                        phi_4529_ = _e5150[2];
                                    }
                                    let _e5168 = phi_4529_;
                                    if (_e5164 > _e5168) {
                                        phi_4534_ = _e5164;
                                    } else {
                                        phi_4534_ = _e5168;
                                    }
                                    let _e5171 = phi_4534_;
                                    let _e5174 = local_12.member_2[1u];
                                    if (_e5174[0] < 0f) {
                                        phi_4548_ = -(_e5174[0]);
                                    } else {
                                        phi_4548_ = _e5174[0];
                                    }
                                    let _e5181 = phi_4548_;
                                    if (_e5174[1] < 0f) {
                                        phi_4555_ = -(_e5174[1]);
                                    } else {
                                        phi_4555_ = _e5174[1];
                                    }
                                    let _e5185 = phi_4555_;
                                    if (_e5181 > _e5185) {
                                        phi_4560_ = _e5181;
                                    } else {
                                        phi_4560_ = _e5185;
                                    }
                                    let _e5188 = phi_4560_;
                                    if (_e5174[2] < 0f) {
                                        phi_4567_ = -(_e5174[2]);
                                    } else {
                                        phi_4567_ = _e5174[2];
                                    }
                                    let _e5192 = phi_4567_;
                                    if (_e5188 > _e5192) {
                                        phi_4572_ = _e5188;
                                    } else {
                                        phi_4572_ = _e5192;
                                    }
                                    let _e5195 = phi_4572_;
                                    if (_e5171 > _e5195) {
                                        phi_4577_ = _e5171;
                                    } else {
                                        phi_4577_ = _e5195;
                                    }
                                    let _e5198 = phi_4577_;
                                    let _e5200 = local_12.member_3;
                                    let _e5207 = local_12.member_3;
                                    let _e5214 = (((_e5036 * (1f + (0.000000059604645f * 8f))) + (((((((_e5090 + _e5092) + (_e5144 + _e5146)) + (_e5198 + _e5200)) * (0.000000059604645f * 16f)) + (_e5207 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e452.member_1);
                                    if _e5214 {
                                        phi_4597_ = false;
                                    } else {
                                        phi_4597_ = true;
                                    }
                                    let _e5216 = phi_4597_;
                                    phi_4598_ = _e5216;
                                    phi_4599_ = _e5214;
                                } else {
                                    phi_4598_ = false;
                                    phi_4599_ = false;
                                }
                                let _e5218 = phi_4598_;
                                let _e5220 = phi_4599_;
                                local_28 = _e5220;
                                continue;
                                continuing {
                                    phi_4096_ = _e4891;
                                    break if !(_e5218);
                                }
                            }
                            let _e5223 = local_28;
                            if _e5223 {
                                phi_4604_ = type_35(1u, _e4867.member_1);
                                phi_4605_ = false;
                            } else {
                                phi_4604_ = type_35();
                                phi_4605_ = true;
                            }
                            let _e5226 = phi_4604_;
                            let _e5228 = phi_4605_;
                            if _e5228 {
                                phi_4610_ = type_35(2u, _e4867.member_1);
                                phi_4611_ = false;
                            } else {
                                phi_4610_ = type_35();
                                phi_4611_ = true;
                            }
                            let _e5231 = phi_4610_;
                            let _e5233 = phi_4611_;
                            phi_4613_ = _e5231;
                            phi_4614_ = _e5226;
                            phi_4615_ = _e5233;
                        } else {
                            phi_4613_ = type_35();
                            phi_4614_ = type_35(0u, type_35().member_1);
                            phi_4615_ = true;
                        }
                        let _e5235 = phi_4613_;
                        let _e5237 = phi_4614_;
                        let _e5239 = phi_4615_;
                        if _e5239 {
                            phi_4619_ = _e5237;
                        } else {
                            phi_4619_ = _e5235;
                        }
                        let _e5241 = phi_4619_;
                        phi_8543_ = _e5241;
                    } else {
                        if (_e590 < 0f) {
                            phi_4629_ = -(_e590);
                        } else {
                            phi_4629_ = _e590;
                        }
                        let _e933 = phi_4629_;
                        if (_e613 < 0f) {
                            phi_4635_ = -(_e613);
                        } else {
                            phi_4635_ = _e613;
                        }
                        let _e937 = phi_4635_;
                        if (_e933 > _e937) {
                            phi_4640_ = _e933;
                        } else {
                            phi_4640_ = _e937;
                        }
                        let _e940 = phi_4640_;
                        if (_e636 < 0f) {
                            phi_4646_ = -(_e636);
                        } else {
                            phi_4646_ = _e636;
                        }
                        let _e944 = phi_4646_;
                        if (_e647 < 0f) {
                            phi_4652_ = -(_e647);
                        } else {
                            phi_4652_ = _e647;
                        }
                        let _e948 = phi_4652_;
                        if (_e944 > _e948) {
                            phi_4657_ = _e944;
                        } else {
                            phi_4657_ = _e948;
                        }
                        let _e951 = phi_4657_;
                        if (_e940 > _e951) {
                            phi_4662_ = _e940;
                        } else {
                            phi_4662_ = _e951;
                        }
                        let _e954 = phi_4662_;
                        let _e955 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e954 >= _e955) {
                            phi_4670_ = (_e954 <= (1f / _e955));
                        } else {
                            phi_4670_ = false;
                        }
                        let _e960 = phi_4670_;
                        if _e960 {
                            phi_4675_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4675_ = 2f;
                        }
                        let _e963 = phi_4675_;
                        let _e965 = ((_e897 * 0.34f) + (_e954 * _e963));
                        if _e960 {
                            phi_4682_ = (1f / _e954);
                        } else {
                            phi_4682_ = 0f;
                        }
                        let _e968 = phi_4682_;
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
                                    phi_4715_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4715_ = 0f;
                                }
                                let _e1037 = phi_4715_;
                                phi_4779_ = _e1037;
                            } else {
                                phi_4722_ = type_14(0i, 5i);
                                phi_4725_ = bitcast<f32>(((bitcast<u32>(_e983) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e992 = phi_4722_;
                                    let _e994 = phi_4725_;
                                    local_13 = _e994;
                                    if (_e992.member < _e992.member_1) {
                                        let _e1001 = (_e992.member + 1i);
                                        if ((false == (_e1001 > _e992.member)) != false) {
                                            phi_4746_ = true;
                                        } else {
                                            phi_4746_ = false;
                                        }
                                        let _e1006 = phi_4746_;
                                        if _e1006 {
                                            phi_4752_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4752_ = type_15(1u, _e1001);
                                        }
                                        let _e1011 = phi_4752_;
                                        phi_4723_ = type_14(_e1011.member_1, _e992.member_1);
                                        phi_4766_ = type_15(1u, _e992.member);
                                    } else {
                                        phi_4723_ = _e992;
                                        phi_4766_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1017 = phi_4723_;
                                    let _e1019 = phi_4766_;
                                    let _e1022 = (bitcast<i32>(_e1019.member) != 0i);
                                    if _e1022 {
                                        phi_4726_ = (0.5f * (_e994 + (_e983 / _e994)));
                                    } else {
                                        phi_4726_ = f32();
                                    }
                                    let _e1027 = phi_4726_;
                                    continue;
                                    continuing {
                                        phi_4722_ = _e1017;
                                        phi_4725_ = _e1027;
                                        break if !(_e1022);
                                    }
                                }
                                let _e1032 = local_13;
                                phi_4779_ = (_e1032 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1039 = phi_4779_;
                            if (_e975 < 0f) {
                                phi_4785_ = -(_e1039);
                            } else {
                                phi_4785_ = _e1039;
                            }
                            let _e1043 = phi_4785_;
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
                            phi_4810_ = type_9(0u, 2u);
                            phi_4813_ = 1u;
                            loop {
                                let _e1064 = phi_4810_;
                                let _e1066 = phi_4813_;
                                local_29 = _e1066;
                                if (_e1064.member < _e1064.member_1) {
                                    phi_4811_ = type_9((_e1064.member + 1u), _e1064.member_1);
                                    phi_4836_ = type_9(1u, _e1064.member);
                                } else {
                                    phi_4811_ = _e1064;
                                    phi_4836_ = type_9(0u, type_9().member_1);
                                }
                                let _e1078 = phi_4811_;
                                let _e1080 = phi_4836_;
                                let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                if _e1084 {
                                    let _e1086 = local_7[_e1080.member_1];
                                    if (_e1086 > 0f) {
                                        let _e1089 = local_7[_e1080.member_1];
                                        if (_e1089 < 1f) {
                                            let _e1092 = local_7[_e1080.member_1];
                                            local_6[_e1066] = _e1092;
                                            phi_4880_ = (_e1066 + 1u);
                                        } else {
                                            phi_4880_ = _e1066;
                                        }
                                        let _e1096 = phi_4880_;
                                        phi_4881_ = _e1096;
                                    } else {
                                        phi_4881_ = _e1066;
                                    }
                                    let _e1098 = phi_4881_;
                                    phi_4814_ = _e1098;
                                } else {
                                    phi_4814_ = u32();
                                }
                                let _e1100 = phi_4814_;
                                continue;
                                continuing {
                                    phi_4810_ = _e1078;
                                    phi_4813_ = _e1100;
                                    break if !(_e1084);
                                }
                            }
                            let _e5501 = local_29;
                            phi_4882_ = _e5501;
                        } else {
                            phi_4882_ = 1u;
                        }
                        let _e1103 = phi_4882_;
                        local_6[_e1103] = 1f;
                        let _e1105 = local_6;
                        local_8 = _e1105;
                        phi_4902_ = type_9(0u, _e1103);
                        loop {
                            let _e1108 = phi_4902_;
                            if (_e1108.member < _e1108.member_1) {
                                phi_4903_ = type_9((_e1108.member + 1u), _e1108.member_1);
                                phi_4926_ = type_9(1u, _e1108.member);
                            } else {
                                phi_4903_ = _e1108;
                                phi_4926_ = type_9(0u, type_9().member_1);
                            }
                            let _e1120 = phi_4903_;
                            let _e1122 = phi_4926_;
                            if (bitcast<i32>(_e1122.member) != 0i) {
                                let _e1128 = local_8[_e1122.member_1];
                                let _e1131 = local_8[(_e1122.member_1 + 1u)];
                                let _e1132 = (1f - _e1128);
                                let _e1143 = ((((_e590 * _e1132) + (_e613 * _e1128)) * (_e1132 * _e1132)) + (((_e636 * _e1132) + (_e647 * _e1128)) * (_e1128 * _e1128)));
                                let _e1144 = (1f - _e1131);
                                let _e1155 = ((((_e590 * _e1144) + (_e613 * _e1131)) * (_e1144 * _e1144)) + (((_e636 * _e1144) + (_e647 * _e1131)) * (_e1131 * _e1131)));
                                if (_e1143 < 0f) {
                                    phi_4978_ = -(_e1143);
                                } else {
                                    phi_4978_ = _e1143;
                                }
                                let _e1159 = phi_4978_;
                                let _e1160 = (_e1159 > _e965);
                                if (_e1155 < 0f) {
                                    phi_4985_ = -(_e1155);
                                } else {
                                    phi_4985_ = _e1155;
                                }
                                let _e1164 = phi_4985_;
                                let _e1165 = (_e1164 > _e965);
                                if _e1160 {
                                    if _e1165 {
                                        phi_4996_ = ((_e1143 > 0f) != (_e1155 > 0f));
                                        phi_4997_ = false;
                                    } else {
                                        phi_4996_ = bool();
                                        phi_4997_ = true;
                                    }
                                    let _e1170 = phi_4996_;
                                    let _e1172 = phi_4997_;
                                    phi_4998_ = _e1170;
                                    phi_4999_ = _e1172;
                                } else {
                                    phi_4998_ = bool();
                                    phi_4999_ = true;
                                }
                                let _e1174 = phi_4998_;
                                let _e1176 = phi_4999_;
                                if _e1176 {
                                    phi_5003_ = false;
                                } else {
                                    phi_5003_ = _e1174;
                                }
                                let _e1178 = phi_5003_;
                                if _e1160 {
                                    if _e1165 {
                                        if _e1178 {
                                            phi_5014_ = type_37();
                                        } else {
                                            phi_5014_ = type_37(1f, 0f, _e1178);
                                        }
                                        let _e1181 = phi_5014_;
                                        phi_5015_ = _e1181;
                                        phi_5016_ = _e1178;
                                    } else {
                                        phi_5015_ = type_37();
                                        phi_5016_ = true;
                                    }
                                    let _e1183 = phi_5015_;
                                    let _e1185 = phi_5016_;
                                    phi_5017_ = _e1183;
                                    phi_5018_ = _e1185;
                                } else {
                                    phi_5017_ = type_37();
                                    phi_5018_ = true;
                                }
                                let _e1187 = phi_5017_;
                                let _e1189 = phi_5018_;
                                if _e1189 {
                                    if _e1160 {
                                        if (_e1143 < 0f) {
                                            phi_5029_ = -1f;
                                        } else {
                                            phi_5029_ = 1f;
                                        }
                                        let _e1192 = phi_5029_;
                                        let _e1195 = (_e636 - _e613);
                                        phi_5039_ = type_9(0u, 64u);
                                        phi_5042_ = _e1131;
                                        phi_5044_ = _e1128;
                                        phi_5046_ = (0.5f * (_e1128 + _e1131));
                                        loop {
                                            let _e1201 = phi_5039_;
                                            let _e1203 = phi_5042_;
                                            let _e1205 = phi_5044_;
                                            let _e1207 = phi_5046_;
                                            local_31 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_5040_ = type_9((_e1201.member + 1u), _e1201.member_1);
                                                phi_5069_ = type_9(1u, _e1201.member);
                                            } else {
                                                phi_5040_ = _e1201;
                                                phi_5069_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1219 = phi_5040_;
                                            let _e1221 = phi_5069_;
                                            if (bitcast<i32>(_e1221.member) != 0i) {
                                                let _e1225 = (1f - _e1207);
                                                let _e1238 = ((_e1192 * ((((_e590 * _e1225) + (_e613 * _e1207)) * (_e1225 * _e1225)) + (((_e636 * _e1225) + (_e647 * _e1207)) * (_e1207 * _e1207)))) - _e965);
                                                if (_e1238 > 0f) {
                                                    phi_5094_ = _e1203;
                                                    phi_5095_ = _e1207;
                                                } else {
                                                    phi_5094_ = _e1207;
                                                    phi_5095_ = _e1205;
                                                }
                                                let _e1241 = phi_5094_;
                                                let _e1243 = phi_5095_;
                                                let _e1245 = ((_e1241 - _e1243) > 0.00000000000022737368f);
                                                if _e1245 {
                                                    let _e1246 = (1f - _e1207);
                                                    let _e1258 = (-(_e1238) / (_e1192 * (((((_e613 - (3f * _e590)) * _e1246) + (_e1195 * _e1207)) * _e1246) + (((_e1195 * _e1246) + (((3f * _e647) - _e636) * _e1207)) * _e1207))));
                                                    if (_e1238 > 0f) {
                                                        phi_5121_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5121_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1264 = phi_5121_;
                                                    let _e1266 = ((_e1207 + _e1258) + _e1264);
                                                    if (_e1266 > _e1243) {
                                                        if (_e1266 < _e1241) {
                                                            if (_e1258 < 0f) {
                                                                phi_5137_ = -(_e1258);
                                                            } else {
                                                                phi_5137_ = _e1258;
                                                            }
                                                            let _e1272 = phi_5137_;
                                                            if (_e1272 < (0.5f * (_e1241 - _e1243))) {
                                                                phi_5144_ = false;
                                                            } else {
                                                                phi_5144_ = true;
                                                            }
                                                            let _e1277 = phi_5144_;
                                                            phi_5145_ = _e1277;
                                                        } else {
                                                            phi_5145_ = true;
                                                        }
                                                        let _e1279 = phi_5145_;
                                                        phi_5146_ = _e1279;
                                                    } else {
                                                        phi_5146_ = true;
                                                    }
                                                    let _e1281 = phi_5146_;
                                                    if _e1281 {
                                                        phi_5152_ = (0.5f * (_e1243 + _e1241));
                                                    } else {
                                                        phi_5152_ = _e1266;
                                                    }
                                                    let _e1285 = phi_5152_;
                                                    phi_5153_ = _e1285;
                                                    phi_5154_ = false;
                                                } else {
                                                    phi_5153_ = f32();
                                                    phi_5154_ = true;
                                                }
                                                let _e1287 = phi_5153_;
                                                let _e1289 = phi_5154_;
                                                phi_5043_ = _e1241;
                                                phi_5045_ = _e1243;
                                                phi_5047_ = _e1287;
                                                phi_5155_ = _e1243;
                                                phi_5156_ = _e1245;
                                                phi_5157_ = _e1289;
                                            } else {
                                                phi_5043_ = f32();
                                                phi_5045_ = f32();
                                                phi_5047_ = f32();
                                                phi_5155_ = f32();
                                                phi_5156_ = false;
                                                phi_5157_ = false;
                                            }
                                            let _e1291 = phi_5043_;
                                            let _e1293 = phi_5045_;
                                            let _e1295 = phi_5047_;
                                            let _e1297 = phi_5155_;
                                            let _e1299 = phi_5156_;
                                            let _e1301 = phi_5157_;
                                            local_14 = _e1301;
                                            local_30 = _e1297;
                                            continue;
                                            continuing {
                                                phi_5039_ = _e1219;
                                                phi_5042_ = _e1291;
                                                phi_5044_ = _e1293;
                                                phi_5046_ = _e1295;
                                                break if !(_e1299);
                                            }
                                        }
                                        let _e1304 = local_14;
                                        if _e1304 {
                                            let _e5543 = local_30;
                                            phi_5161_ = _e5543;
                                        } else {
                                            let _e5545 = local_31;
                                            phi_5161_ = _e5545;
                                        }
                                        let _e1306 = phi_5161_;
                                        phi_5162_ = _e1306;
                                    } else {
                                        phi_5162_ = _e1128;
                                    }
                                    let _e1308 = phi_5162_;
                                    if _e1165 {
                                        if (_e1155 < 0f) {
                                            phi_5170_ = -1f;
                                        } else {
                                            phi_5170_ = 1f;
                                        }
                                        let _e1311 = phi_5170_;
                                        phi_5174_ = type_9(0u, 64u);
                                        phi_5177_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1314 = phi_5174_;
                                            let _e1316 = phi_5177_;
                                            if (_e1314.member < _e1314.member_1) {
                                                phi_5175_ = type_9((_e1314.member + 1u), _e1314.member_1);
                                                phi_5200_ = type_9(1u, _e1314.member);
                                            } else {
                                                phi_5175_ = _e1314;
                                                phi_5200_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1328 = phi_5175_;
                                            let _e1330 = phi_5200_;
                                            if (bitcast<i32>(_e1330.member) != 0i) {
                                                let _e1334 = (_e1308 + _e1316);
                                                if (_e1334 < _e1131) {
                                                    let _e1336 = (1f - _e1334);
                                                    let _e1349 = ((_e1311 * ((((_e590 * _e1336) + (_e613 * _e1334)) * (_e1336 * _e1336)) + (((_e636 * _e1336) + (_e647 * _e1334)) * (_e1334 * _e1334)))) > _e965);
                                                    if _e1349 {
                                                        phi_5230_ = f32();
                                                        phi_5231_ = false;
                                                    } else {
                                                        phi_5230_ = (_e1316 + _e1316);
                                                        phi_5231_ = true;
                                                    }
                                                    let _e1352 = phi_5230_;
                                                    let _e1354 = phi_5231_;
                                                    phi_5232_ = _e1352;
                                                    phi_5233_ = _e1354;
                                                    phi_5234_ = _e1349;
                                                    phi_5235_ = false;
                                                } else {
                                                    phi_5232_ = f32();
                                                    phi_5233_ = false;
                                                    phi_5234_ = false;
                                                    phi_5235_ = true;
                                                }
                                                let _e1356 = phi_5232_;
                                                let _e1358 = phi_5233_;
                                                let _e1360 = phi_5234_;
                                                let _e1362 = phi_5235_;
                                                phi_5236_ = _e1334;
                                                phi_5178_ = _e1356;
                                                phi_5237_ = _e1358;
                                                phi_5238_ = _e1360;
                                                phi_5239_ = _e1362;
                                                phi_5240_ = false;
                                            } else {
                                                phi_5236_ = f32();
                                                phi_5178_ = f32();
                                                phi_5237_ = false;
                                                phi_5238_ = false;
                                                phi_5239_ = false;
                                                phi_5240_ = true;
                                            }
                                            let _e1364 = phi_5236_;
                                            let _e1366 = phi_5178_;
                                            let _e1368 = phi_5237_;
                                            let _e1370 = phi_5238_;
                                            let _e1372 = phi_5239_;
                                            let _e1374 = phi_5240_;
                                            local_15 = _e1370;
                                            local_32 = _e1372;
                                            local_33 = _e1374;
                                            local_34 = _e1364;
                                            continue;
                                            continuing {
                                                phi_5174_ = _e1328;
                                                phi_5177_ = _e1366;
                                                break if !(_e1368);
                                            }
                                        }
                                        let _e1377 = local_15;
                                        if _e1377 {
                                            phi_5244_ = false;
                                            phi_5245_ = false;
                                        } else {
                                            let _e5567 = local_32;
                                            phi_5244_ = _e5567;
                                            let _e5570 = local_33;
                                            phi_5245_ = _e5570;
                                        }
                                        let _e1379 = phi_5244_;
                                        let _e1381 = phi_5245_;
                                        if _e1379 {
                                            phi_5249_ = true;
                                        } else {
                                            phi_5249_ = _e1381;
                                        }
                                        let _e1383 = phi_5249_;
                                        if _e1383 {
                                            phi_5253_ = _e1131;
                                        } else {
                                            let _e5574 = local_34;
                                            phi_5253_ = _e5574;
                                        }
                                        let _e1385 = phi_5253_;
                                        phi_5254_ = _e1385;
                                    } else {
                                        phi_5254_ = _e1131;
                                    }
                                    let _e1387 = phi_5254_;
                                    phi_5256_ = type_37(_e1308, _e1387, _e1178);
                                } else {
                                    phi_5256_ = _e1187;
                                }
                                let _e1390 = phi_5256_;
                                if (_e1390.member > _e1390.member_1) {
                                    phi_8499_ = f32();
                                    phi_8500_ = true;
                                    phi_8501_ = false;
                                    phi_8502_ = false;
                                    phi_8503_ = false;
                                } else {
                                    let _e1397 = ((_e1390.member_1 - _e1390.member) * 0.5f);
                                    let _e1398 = (_e1390.member + _e1397);
                                    let _e1400 = (_e1397 + (0.000000059604645f * 4f));
                                    let _e1402 = local_12.member_3;
                                    let _e1405 = local_12.member[0u];
                                    if (_e1405[0] < 0f) {
                                        phi_5285_ = -(_e1405[0]);
                                    } else {
                                        phi_5285_ = _e1405[0];
                                    }
                                    let _e1412 = phi_5285_;
                                    if (_e1405[1] < 0f) {
                                        phi_5292_ = -(_e1405[1]);
                                    } else {
                                        phi_5292_ = _e1405[1];
                                    }
                                    let _e1416 = phi_5292_;
                                    if (_e1412 > _e1416) {
                                        phi_5297_ = _e1412;
                                    } else {
                                        phi_5297_ = _e1416;
                                    }
                                    let _e1419 = phi_5297_;
                                    if (_e1405[2] < 0f) {
                                        phi_5304_ = -(_e1405[2]);
                                    } else {
                                        phi_5304_ = _e1405[2];
                                    }
                                    let _e1423 = phi_5304_;
                                    if (_e1419 > _e1423) {
                                        phi_5309_ = _e1419;
                                    } else {
                                        phi_5309_ = _e1423;
                                    }
                                    let _e1426 = phi_5309_;
                                    let _e1428 = local_12.member[1u];
                                    if (_e1428[0] < 0f) {
                                        phi_5322_ = -(_e1428[0]);
                                    } else {
                                        phi_5322_ = _e1428[0];
                                    }
                                    let _e1435 = phi_5322_;
                                    if (_e1428[1] < 0f) {
                                        phi_5329_ = -(_e1428[1]);
                                    } else {
                                        phi_5329_ = _e1428[1];
                                    }
                                    let _e1439 = phi_5329_;
                                    if (_e1435 > _e1439) {
                                        phi_5334_ = _e1435;
                                    } else {
                                        phi_5334_ = _e1439;
                                    }
                                    let _e1442 = phi_5334_;
                                    if (_e1428[2] < 0f) {
                                        phi_5341_ = -(_e1428[2]);
                                    } else {
                                        phi_5341_ = _e1428[2];
                                    }
                                    let _e1446 = phi_5341_;
                                    if (_e1442 > _e1446) {
                                        phi_5346_ = _e1442;
                                    } else {
                                        phi_5346_ = _e1446;
                                    }
                                    let _e1449 = phi_5346_;
                                    if (_e1426 > _e1449) {
                                        phi_5351_ = _e1426;
                                    } else {
                                        phi_5351_ = _e1449;
                                    }
                                    let _e1452 = phi_5351_;
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
                                        phi_5410_ = -(_e1483);
                                    } else {
                                        phi_5410_ = _e1483;
                                    }
                                    let _e1489 = phi_5410_;
                                    if (_e1484 < 0f) {
                                        phi_5416_ = -(_e1484);
                                    } else {
                                        phi_5416_ = _e1484;
                                    }
                                    let _e1493 = phi_5416_;
                                    if (_e1489 > _e1493) {
                                        phi_5421_ = _e1489;
                                    } else {
                                        phi_5421_ = _e1493;
                                    }
                                    let _e1496 = phi_5421_;
                                    if (_e1485 < 0f) {
                                        phi_5427_ = -(_e1485);
                                    } else {
                                        phi_5427_ = _e1485;
                                    }
                                    let _e1500 = phi_5427_;
                                    if (_e1496 > _e1500) {
                                        phi_5432_ = _e1496;
                                    } else {
                                        phi_5432_ = _e1500;
                                    }
                                    let _e1503 = phi_5432_;
                                    let _e1509 = ((((_e1400 * _e1503) * 1.01f) + ((_e1452 + _e1402) * (0.000000059604645f * 8f))) + _e1402);
                                    if (_e1470 < 0f) {
                                        phi_5444_ = -(_e1470);
                                    } else {
                                        phi_5444_ = _e1470;
                                    }
                                    let _e1513 = phi_5444_;
                                    if (_e1471 < 0f) {
                                        phi_5450_ = -(_e1471);
                                    } else {
                                        phi_5450_ = _e1471;
                                    }
                                    let _e1517 = phi_5450_;
                                    if (_e1513 > _e1517) {
                                        phi_5455_ = _e1513;
                                    } else {
                                        phi_5455_ = _e1517;
                                    }
                                    let _e1520 = phi_5455_;
                                    if (_e1472 < 0f) {
                                        phi_5461_ = -(_e1472);
                                    } else {
                                        phi_5461_ = _e1472;
                                    }
                                    let _e1524 = phi_5461_;
                                    if (_e1520 > _e1524) {
                                        phi_5466_ = _e1520;
                                    } else {
                                        phi_5466_ = _e1524;
                                    }
                                    let _e1527 = phi_5466_;
                                    local_2 = type_27(array<f32, 3>(_e1470, _e1471, _e1472), _e1509, (_e1527 + _e1509));
                                    let _e1533 = local_12.member_3;
                                    let _e1535 = local_12.member_1[0u];
                                    if (_e1535[0] < 0f) {
                                        phi_5492_ = -(_e1535[0]);
                                    } else {
                                        phi_5492_ = _e1535[0];
                                    }
                                    let _e1542 = phi_5492_;
                                    if (_e1535[1] < 0f) {
                                        phi_5499_ = -(_e1535[1]);
                                    } else {
                                        phi_5499_ = _e1535[1];
                                    }
                                    let _e1546 = phi_5499_;
                                    if (_e1542 > _e1546) {
                                        phi_5504_ = _e1542;
                                    } else {
                                        phi_5504_ = _e1546;
                                    }
                                    let _e1549 = phi_5504_;
                                    if (_e1535[2] < 0f) {
                                        phi_5511_ = -(_e1535[2]);
                                    } else {
                                        phi_5511_ = _e1535[2];
                                    }
                                    let _e1553 = phi_5511_;
                                    if (_e1549 > _e1553) {
                                        phi_5516_ = _e1549;
                                    } else {
                                        phi_5516_ = _e1553;
                                    }
                                    let _e1556 = phi_5516_;
                                    let _e1558 = local_12.member_1[1u];
                                    if (_e1558[0] < 0f) {
                                        phi_5529_ = -(_e1558[0]);
                                    } else {
                                        phi_5529_ = _e1558[0];
                                    }
                                    let _e1565 = phi_5529_;
                                    if (_e1558[1] < 0f) {
                                        phi_5536_ = -(_e1558[1]);
                                    } else {
                                        phi_5536_ = _e1558[1];
                                    }
                                    let _e1569 = phi_5536_;
                                    if (_e1565 > _e1569) {
                                        phi_5541_ = _e1565;
                                    } else {
                                        phi_5541_ = _e1569;
                                    }
                                    let _e1572 = phi_5541_;
                                    if (_e1558[2] < 0f) {
                                        phi_5548_ = -(_e1558[2]);
                                    } else {
                                        phi_5548_ = _e1558[2];
                                    }
                                    let _e1576 = phi_5548_;
                                    if (_e1572 > _e1576) {
                                        phi_5553_ = _e1572;
                                    } else {
                                        phi_5553_ = _e1576;
                                    }
                                    let _e1579 = phi_5553_;
                                    if (_e1556 > _e1579) {
                                        phi_5558_ = _e1556;
                                    } else {
                                        phi_5558_ = _e1579;
                                    }
                                    let _e1582 = phi_5558_;
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
                                        phi_5617_ = -(_e1613);
                                    } else {
                                        phi_5617_ = _e1613;
                                    }
                                    let _e1619 = phi_5617_;
                                    if (_e1614 < 0f) {
                                        phi_5623_ = -(_e1614);
                                    } else {
                                        phi_5623_ = _e1614;
                                    }
                                    let _e1623 = phi_5623_;
                                    if (_e1619 > _e1623) {
                                        phi_5628_ = _e1619;
                                    } else {
                                        phi_5628_ = _e1623;
                                    }
                                    let _e1626 = phi_5628_;
                                    if (_e1615 < 0f) {
                                        phi_5634_ = -(_e1615);
                                    } else {
                                        phi_5634_ = _e1615;
                                    }
                                    let _e1630 = phi_5634_;
                                    if (_e1626 > _e1630) {
                                        phi_5639_ = _e1626;
                                    } else {
                                        phi_5639_ = _e1630;
                                    }
                                    let _e1633 = phi_5639_;
                                    let _e1639 = ((((_e1400 * _e1633) * 1.01f) + ((_e1582 + _e1533) * (0.000000059604645f * 8f))) + _e1533);
                                    if (_e1600 < 0f) {
                                        phi_5651_ = -(_e1600);
                                    } else {
                                        phi_5651_ = _e1600;
                                    }
                                    let _e1643 = phi_5651_;
                                    if (_e1601 < 0f) {
                                        phi_5657_ = -(_e1601);
                                    } else {
                                        phi_5657_ = _e1601;
                                    }
                                    let _e1647 = phi_5657_;
                                    if (_e1643 > _e1647) {
                                        phi_5662_ = _e1643;
                                    } else {
                                        phi_5662_ = _e1647;
                                    }
                                    let _e1650 = phi_5662_;
                                    if (_e1602 < 0f) {
                                        phi_5668_ = -(_e1602);
                                    } else {
                                        phi_5668_ = _e1602;
                                    }
                                    let _e1654 = phi_5668_;
                                    if (_e1650 > _e1654) {
                                        phi_5673_ = _e1650;
                                    } else {
                                        phi_5673_ = _e1654;
                                    }
                                    let _e1657 = phi_5673_;
                                    local_3 = type_27(array<f32, 3>(_e1600, _e1601, _e1602), _e1639, (_e1657 + _e1639));
                                    let _e1663 = local_12.member_3;
                                    let _e1665 = local_12.member_2[0u];
                                    if (_e1665[0] < 0f) {
                                        phi_5699_ = -(_e1665[0]);
                                    } else {
                                        phi_5699_ = _e1665[0];
                                    }
                                    let _e1672 = phi_5699_;
                                    if (_e1665[1] < 0f) {
                                        phi_5706_ = -(_e1665[1]);
                                    } else {
                                        phi_5706_ = _e1665[1];
                                    }
                                    let _e1676 = phi_5706_;
                                    if (_e1672 > _e1676) {
                                        phi_5711_ = _e1672;
                                    } else {
                                        phi_5711_ = _e1676;
                                    }
                                    let _e1679 = phi_5711_;
                                    if (_e1665[2] < 0f) {
                                        phi_5718_ = -(_e1665[2]);
                                    } else {
                                        phi_5718_ = _e1665[2];
                                    }
                                    let _e1683 = phi_5718_;
                                    if (_e1679 > _e1683) {
                                        phi_5723_ = _e1679;
                                    } else {
                                        phi_5723_ = _e1683;
                                    }
                                    let _e1686 = phi_5723_;
                                    let _e1688 = local_12.member_2[1u];
                                    if (_e1688[0] < 0f) {
                                        phi_5736_ = -(_e1688[0]);
                                    } else {
                                        phi_5736_ = _e1688[0];
                                    }
                                    let _e1695 = phi_5736_;
                                    if (_e1688[1] < 0f) {
                                        phi_5743_ = -(_e1688[1]);
                                    } else {
                                        phi_5743_ = _e1688[1];
                                    }
                                    let _e1699 = phi_5743_;
                                    if (_e1695 > _e1699) {
                                        phi_5748_ = _e1695;
                                    } else {
                                        phi_5748_ = _e1699;
                                    }
                                    let _e1702 = phi_5748_;
                                    if (_e1688[2] < 0f) {
                                        phi_5755_ = -(_e1688[2]);
                                    } else {
                                        phi_5755_ = _e1688[2];
                                    }
                                    let _e1706 = phi_5755_;
                                    if (_e1702 > _e1706) {
                                        phi_5760_ = _e1702;
                                    } else {
                                        phi_5760_ = _e1706;
                                    }
                                    let _e1709 = phi_5760_;
                                    if (_e1686 > _e1709) {
                                        phi_5765_ = _e1686;
                                    } else {
                                        phi_5765_ = _e1709;
                                    }
                                    let _e1712 = phi_5765_;
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
                                        phi_5824_ = -(_e1743);
                                    } else {
                                        phi_5824_ = _e1743;
                                    }
                                    let _e1749 = phi_5824_;
                                    if (_e1744 < 0f) {
                                        phi_5830_ = -(_e1744);
                                    } else {
                                        phi_5830_ = _e1744;
                                    }
                                    let _e1753 = phi_5830_;
                                    if (_e1749 > _e1753) {
                                        phi_5835_ = _e1749;
                                    } else {
                                        phi_5835_ = _e1753;
                                    }
                                    let _e1756 = phi_5835_;
                                    if (_e1745 < 0f) {
                                        phi_5841_ = -(_e1745);
                                    } else {
                                        phi_5841_ = _e1745;
                                    }
                                    let _e1760 = phi_5841_;
                                    if (_e1756 > _e1760) {
                                        phi_5846_ = _e1756;
                                    } else {
                                        phi_5846_ = _e1760;
                                    }
                                    let _e1763 = phi_5846_;
                                    let _e1769 = ((((_e1400 * _e1763) * 1.01f) + ((_e1712 + _e1663) * (0.000000059604645f * 8f))) + _e1663);
                                    if (_e1730 < 0f) {
                                        phi_5858_ = -(_e1730);
                                    } else {
                                        phi_5858_ = _e1730;
                                    }
                                    let _e1773 = phi_5858_;
                                    if (_e1731 < 0f) {
                                        phi_5864_ = -(_e1731);
                                    } else {
                                        phi_5864_ = _e1731;
                                    }
                                    let _e1777 = phi_5864_;
                                    if (_e1773 > _e1777) {
                                        phi_5869_ = _e1773;
                                    } else {
                                        phi_5869_ = _e1777;
                                    }
                                    let _e1780 = phi_5869_;
                                    if (_e1732 < 0f) {
                                        phi_5875_ = -(_e1732);
                                    } else {
                                        phi_5875_ = _e1732;
                                    }
                                    let _e1784 = phi_5875_;
                                    if (_e1780 > _e1784) {
                                        phi_5880_ = _e1780;
                                    } else {
                                        phi_5880_ = _e1784;
                                    }
                                    let _e1787 = phi_5880_;
                                    local_4 = type_27(array<f32, 3>(_e1730, _e1731, _e1732), _e1769, (_e1787 + _e1769));
                                    let _e1792 = local_3.member;
                                    let _e1797 = local_4.member;
                                    let _e1803 = ((_e1792[1] * _e1797[2]) - (_e1792[2] * _e1797[1]));
                                    let _e1806 = ((_e1792[2] * _e1797[0]) - (_e1792[0] * _e1797[2]));
                                    let _e1809 = ((_e1792[0] * _e1797[1]) - (_e1792[1] * _e1797[0]));
                                    if (_e1803 < 0f) {
                                        phi_5929_ = -(_e1803);
                                    } else {
                                        phi_5929_ = _e1803;
                                    }
                                    let _e1813 = phi_5929_;
                                    if (_e1806 < 0f) {
                                        phi_5935_ = -(_e1806);
                                    } else {
                                        phi_5935_ = _e1806;
                                    }
                                    let _e1817 = phi_5935_;
                                    if (_e1813 > _e1817) {
                                        if (_e1803 < 0f) {
                                            phi_5945_ = -(_e1803);
                                        } else {
                                            phi_5945_ = _e1803;
                                        }
                                        let _e1835 = phi_5945_;
                                        if (_e1809 < 0f) {
                                            phi_5951_ = -(_e1809);
                                        } else {
                                            phi_5951_ = _e1809;
                                        }
                                        let _e1839 = phi_5951_;
                                        if (_e1835 > _e1839) {
                                            phi_5956_ = 2u;
                                            phi_5957_ = 1u;
                                        } else {
                                            phi_5956_ = 1u;
                                            phi_5957_ = 0u;
                                        }
                                        let _e1842 = phi_5956_;
                                        let _e1844 = phi_5957_;
                                        phi_5976_ = _e1842;
                                        phi_5977_ = _e1844;
                                    } else {
                                        if (_e1806 < 0f) {
                                            phi_5963_ = -(_e1806);
                                        } else {
                                            phi_5963_ = _e1806;
                                        }
                                        let _e1822 = phi_5963_;
                                        if (_e1809 < 0f) {
                                            phi_5969_ = -(_e1809);
                                        } else {
                                            phi_5969_ = _e1809;
                                        }
                                        let _e1826 = phi_5969_;
                                        if (_e1822 > _e1826) {
                                            phi_5974_ = 0u;
                                            phi_5975_ = 2u;
                                        } else {
                                            phi_5974_ = 1u;
                                            phi_5975_ = 0u;
                                        }
                                        let _e1829 = phi_5974_;
                                        let _e1831 = phi_5975_;
                                        phi_5976_ = _e1829;
                                        phi_5977_ = _e1831;
                                    }
                                    let _e1846 = phi_5976_;
                                    let _e1848 = phi_5977_;
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
                                        phi_6046_ = -(_e1863);
                                    } else {
                                        phi_6046_ = _e1863;
                                    }
                                    let _e1899 = phi_6046_;
                                    if (_e1899 > _e1895) {
                                        if (_e1863 < 0f) {
                                            phi_6055_ = -1f;
                                        } else {
                                            phi_6055_ = 1f;
                                        }
                                        let _e1903 = phi_6055_;
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
                                            phi_6190_ = -(_e1998);
                                        } else {
                                            phi_6190_ = _e1998;
                                        }
                                        let _e2004 = phi_6190_;
                                        if (_e1999 < 0f) {
                                            phi_6196_ = -(_e1999);
                                        } else {
                                            phi_6196_ = _e1999;
                                        }
                                        let _e2008 = phi_6196_;
                                        if (_e2000 < 0f) {
                                            phi_6203_ = -(_e2000);
                                        } else {
                                            phi_6203_ = _e2000;
                                        }
                                        let _e2013 = phi_6203_;
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
                                        phi_6246_ = type_9(0u, 4u);
                                        phi_6249_ = true;
                                        loop {
                                            let _e2036 = phi_6246_;
                                            let _e2038 = phi_6249_;
                                            local_17 = _e2038;
                                            if (_e2036.member < _e2036.member_1) {
                                                phi_6247_ = type_9((_e2036.member + 1u), _e2036.member_1);
                                                phi_6272_ = type_9(1u, _e2036.member);
                                            } else {
                                                phi_6247_ = _e2036;
                                                phi_6272_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2050 = phi_6247_;
                                            let _e2052 = phi_6272_;
                                            if (bitcast<i32>(_e2052.member) != 0i) {
                                                let _e2059 = local_5[_e2052.member_1].member;
                                                let _e2062 = local_5[_e2052.member_1].member_1;
                                                let _e2064 = (_e2059 < -(_e2062));
                                                if _e2064 {
                                                    phi_6299_ = bool();
                                                    phi_6300_ = false;
                                                } else {
                                                    phi_6299_ = (_e2038 && (_e2059 > _e2062));
                                                    phi_6300_ = true;
                                                }
                                                let _e2068 = phi_6299_;
                                                let _e2070 = phi_6300_;
                                                phi_6250_ = _e2068;
                                                phi_6301_ = _e2070;
                                                phi_6302_ = _e2064;
                                            } else {
                                                phi_6250_ = bool();
                                                phi_6301_ = false;
                                                phi_6302_ = false;
                                            }
                                            let _e2072 = phi_6250_;
                                            let _e2074 = phi_6301_;
                                            let _e2076 = phi_6302_;
                                            local_16 = _e2076;
                                            continue;
                                            continuing {
                                                phi_6246_ = _e2050;
                                                phi_6249_ = _e2072;
                                                break if !(_e2074);
                                            }
                                        }
                                        let _e2079 = local_16;
                                        if _e2079 {
                                            phi_6306_ = false;
                                        } else {
                                            phi_6306_ = true;
                                        }
                                        let _e2081 = phi_6306_;
                                        if _e2081 {
                                            let _e2083 = local_17;
                                            if _e2083 {
                                                phi_6313_ = 1u;
                                            } else {
                                                phi_6313_ = 2u;
                                            }
                                            let _e2085 = phi_6313_;
                                            phi_6314_ = _e2085;
                                            phi_6315_ = false;
                                        } else {
                                            phi_6314_ = u32();
                                            phi_6315_ = true;
                                        }
                                        let _e2087 = phi_6314_;
                                        let _e2089 = phi_6315_;
                                        phi_6316_ = _e2087;
                                        phi_6317_ = 0u;
                                        phi_6318_ = _e2089;
                                    } else {
                                        phi_6316_ = u32();
                                        phi_6317_ = 2u;
                                        phi_6318_ = true;
                                    }
                                    let _e2091 = phi_6316_;
                                    let _e2093 = phi_6317_;
                                    let _e2095 = phi_6318_;
                                    if _e2095 {
                                        phi_6322_ = _e2093;
                                    } else {
                                        phi_6322_ = _e2091;
                                    }
                                    let _e2097 = phi_6322_;
                                    let _e2098 = (_e2097 == 0u);
                                    if _e2098 {
                                        phi_8495_ = f32();
                                        phi_8496_ = false;
                                        phi_8497_ = false;
                                        phi_8498_ = false;
                                    } else {
                                        if (_e2097 == 1u) {
                                            if _e1390.member_2 {
                                                if ((_e1390.member_1 - _e1390.member) <= 0.0000005f) {
                                                    phi_6342_ = false;
                                                } else {
                                                    phi_6342_ = true;
                                                }
                                                let _e2106 = phi_6342_;
                                                phi_6343_ = _e2106;
                                            } else {
                                                phi_6343_ = true;
                                            }
                                            let _e2108 = phi_6343_;
                                            phi_6344_ = _e2108;
                                        } else {
                                            phi_6344_ = true;
                                        }
                                        let _e2110 = phi_6344_;
                                        if _e2110 {
                                            let _e2115 = local_12.member[0u];
                                            let _e2121 = local_12.member_1[0u];
                                            let _e2127 = local_12.member_2[0u];
                                            let _e2139 = local_12.member[1u];
                                            let _e2145 = local_12.member_1[1u];
                                            let _e2151 = local_12.member_2[1u];
                                            let _e2163 = local_12.member[0u];
                                            if (_e2163[0] < 0f) {
                                                phi_6492_ = -(_e2163[0]);
                                            } else {
                                                phi_6492_ = _e2163[0];
                                            }
                                            let _e2170 = phi_6492_;
                                            if (_e2163[1] < 0f) {
                                                phi_6499_ = -(_e2163[1]);
                                            } else {
                                                phi_6499_ = _e2163[1];
                                            }
                                            let _e2174 = phi_6499_;
                                            if (_e2170 > _e2174) {
                                                phi_6504_ = _e2170;
                                            } else {
                                                phi_6504_ = _e2174;
                                            }
                                            let _e2177 = phi_6504_;
                                            if (_e2163[2] < 0f) {
                                                phi_6511_ = -(_e2163[2]);
                                            } else {
                                                phi_6511_ = _e2163[2];
                                            }
                                            let _e2181 = phi_6511_;
                                            if (_e2177 > _e2181) {
                                                phi_6516_ = _e2177;
                                            } else {
                                                phi_6516_ = _e2181;
                                            }
                                            let _e2184 = phi_6516_;
                                            let _e2187 = local_12.member[1u];
                                            if (_e2187[0] < 0f) {
                                                phi_6529_ = -(_e2187[0]);
                                            } else {
                                                phi_6529_ = _e2187[0];
                                            }
                                            let _e2194 = phi_6529_;
                                            if (_e2187[1] < 0f) {
                                                phi_6536_ = -(_e2187[1]);
                                            } else {
                                                phi_6536_ = _e2187[1];
                                            }
                                            let _e2198 = phi_6536_;
                                            if (_e2194 > _e2198) {
                                                phi_6541_ = _e2194;
                                            } else {
                                                phi_6541_ = _e2198;
                                            }
                                            let _e2201 = phi_6541_;
                                            if (_e2187[2] < 0f) {
                                                phi_6548_ = -(_e2187[2]);
                                            } else {
                                                phi_6548_ = _e2187[2];
                                            }
                                            let _e2205 = phi_6548_;
                                            if (_e2201 > _e2205) {
                                                phi_6553_ = _e2201;
                                            } else {
                                                phi_6553_ = _e2205;
                                            }
                                            let _e2208 = phi_6553_;
                                            if (_e2184 > _e2208) {
                                                phi_6558_ = _e2184;
                                            } else {
                                                phi_6558_ = _e2208;
                                            }
                                            let _e2211 = phi_6558_;
                                            let _e2213 = local_12.member_3;
                                            let _e2217 = local_12.member_1[0u];
                                            if (_e2217[0] < 0f) {
                                                phi_6575_ = -(_e2217[0]);
                                            } else {
                                                phi_6575_ = _e2217[0];
                                            }
                                            let _e2224 = phi_6575_;
                                            if (_e2217[1] < 0f) {
                                                phi_6582_ = -(_e2217[1]);
                                            } else {
                                                phi_6582_ = _e2217[1];
                                            }
                                            let _e2228 = phi_6582_;
                                            if (_e2224 > _e2228) {
                                                phi_6587_ = _e2224;
                                            } else {
                                                phi_6587_ = _e2228;
                                            }
                                            let _e2231 = phi_6587_;
                                            if (_e2217[2] < 0f) {
                                                phi_6594_ = -(_e2217[2]);
                                            } else {
                                                phi_6594_ = _e2217[2];
                                            }
                                            let _e2235 = phi_6594_;
                                            if (_e2231 > _e2235) {
                                                phi_6599_ = _e2231;
                                            } else {
                                                phi_6599_ = _e2235;
                                            }
                                            let _e2238 = phi_6599_;
                                            let _e2241 = local_12.member_1[1u];
                                            if (_e2241[0] < 0f) {
                                                phi_6613_ = -(_e2241[0]);
                                            } else {
                                                phi_6613_ = _e2241[0];
                                            }
                                            let _e2248 = phi_6613_;
                                            if (_e2241[1] < 0f) {
                                                phi_6620_ = -(_e2241[1]);
                                            } else {
                                                phi_6620_ = _e2241[1];
                                            }
                                            let _e2252 = phi_6620_;
                                            if (_e2248 > _e2252) {
                                                phi_6625_ = _e2248;
                                            } else {
                                                phi_6625_ = _e2252;
                                            }
                                            let _e2255 = phi_6625_;
                                            if (_e2241[2] < 0f) {
                                                phi_6632_ = -(_e2241[2]);
                                            } else {
                                                phi_6632_ = _e2241[2];
                                            }
                                            let _e2259 = phi_6632_;
                                            if (_e2255 > _e2259) {
                                                phi_6637_ = _e2255;
                                            } else {
                                                phi_6637_ = _e2259;
                                            }
                                            let _e2262 = phi_6637_;
                                            if (_e2238 > _e2262) {
                                                phi_6642_ = _e2238;
                                            } else {
                                                phi_6642_ = _e2262;
                                            }
                                            let _e2265 = phi_6642_;
                                            let _e2267 = local_12.member_3;
                                            let _e2271 = local_12.member_2[0u];
                                            if (_e2271[0] < 0f) {
                                                phi_6659_ = -(_e2271[0]);
                                            } else {
                                                phi_6659_ = _e2271[0];
                                            }
                                            let _e2278 = phi_6659_;
                                            if (_e2271[1] < 0f) {
                                                phi_6666_ = -(_e2271[1]);
                                            } else {
                                                phi_6666_ = _e2271[1];
                                            }
                                            let _e2282 = phi_6666_;
                                            if (_e2278 > _e2282) {
                                                phi_6671_ = _e2278;
                                            } else {
                                                phi_6671_ = _e2282;
                                            }
                                            let _e2285 = phi_6671_;
                                            if (_e2271[2] < 0f) {
                                                phi_6678_ = -(_e2271[2]);
                                            } else {
                                                phi_6678_ = _e2271[2];
                                            }
                                            let _e2289 = phi_6678_;
                                            if (_e2285 > _e2289) {
                                                phi_6683_ = _e2285;
                                            } else {
                                                phi_6683_ = _e2289;
                                            }
                                            let _e2292 = phi_6683_;
                                            let _e2295 = local_12.member_2[1u];
                                            if (_e2295[0] < 0f) {
                                                phi_6697_ = -(_e2295[0]);
                                            } else {
                                                phi_6697_ = _e2295[0];
                                            }
                                            let _e2302 = phi_6697_;
                                            if (_e2295[1] < 0f) {
                                                phi_6704_ = -(_e2295[1]);
                                            } else {
                                                phi_6704_ = _e2295[1];
                                            }
                                            let _e2306 = phi_6704_;
                                            if (_e2302 > _e2306) {
                                                phi_6709_ = _e2302;
                                            } else {
                                                phi_6709_ = _e2306;
                                            }
                                            let _e2309 = phi_6709_;
                                            if (_e2295[2] < 0f) {
                                                phi_6716_ = -(_e2295[2]);
                                            } else {
                                                phi_6716_ = _e2295[2];
                                            }
                                            let _e2313 = phi_6716_;
                                            if (_e2309 > _e2313) {
                                                phi_6721_ = _e2309;
                                            } else {
                                                phi_6721_ = _e2313;
                                            }
                                            let _e2316 = phi_6721_;
                                            if (_e2292 > _e2316) {
                                                phi_6726_ = _e2292;
                                            } else {
                                                phi_6726_ = _e2316;
                                            }
                                            let _e2319 = phi_6726_;
                                            let _e2321 = local_12.member_3;
                                            let _e2328 = local_12.member_3;
                                            local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6765_ = type_9(0u, 96u);
                                            phi_6768_ = _e1390.member;
                                            phi_6770_ = _e1390.member;
                                            phi_6772_ = _e1390.member;
                                            phi_6774_ = false;
                                            phi_6776_ = 0u;
                                            loop {
                                                let _e2334 = phi_6765_;
                                                let _e2336 = phi_6768_;
                                                let _e2338 = phi_6770_;
                                                let _e2340 = phi_6772_;
                                                let _e2342 = phi_6774_;
                                                let _e2344 = phi_6776_;
                                                local_36 = _e2338;
                                                local_20 = _e2336;
                                                if (_e2334.member < _e2334.member_1) {
                                                    phi_6766_ = type_9((_e2334.member + 1u), _e2334.member_1);
                                                    phi_6799_ = type_9(1u, _e2334.member);
                                                } else {
                                                    phi_6766_ = _e2334;
                                                    phi_6799_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2356 = phi_6766_;
                                                let _e2358 = phi_6799_;
                                                if (bitcast<i32>(_e2358.member) != 0i) {
                                                    let _e2364 = local_12.member[0u];
                                                    let _e2370 = local_12.member[1u];
                                                    let _e2386 = local_12.member_1[0u];
                                                    let _e2392 = local_12.member_1[1u];
                                                    let _e2408 = local_12.member_2[0u];
                                                    let _e2414 = local_12.member_2[1u];
                                                    let _e2428 = function_1(array<f32, 3>((_e2364[0] + ((_e2370[0] - _e2364[0]) * _e2336)), (_e2364[1] + ((_e2370[1] - _e2364[1]) * _e2336)), (_e2364[2] + ((_e2370[2] - _e2364[2]) * _e2336))), array<f32, 3>((_e2386[0] + ((_e2392[0] - _e2386[0]) * _e2336)), (_e2386[1] + ((_e2392[1] - _e2386[1]) * _e2336)), (_e2386[2] + ((_e2392[2] - _e2386[2]) * _e2336))), array<f32, 3>((_e2408[0] + ((_e2414[0] - _e2408[0]) * _e2336)), (_e2408[1] + ((_e2414[1] - _e2408[1]) * _e2336)), (_e2408[2] + ((_e2414[2] - _e2408[2]) * _e2336))), 0u);
                                                    if (_e2344 == 0u) {
                                                        phi_6927_ = _e2428;
                                                    } else {
                                                        if (_e2344 == 1u) {
                                                            phi_6913_ = _e2428[0];
                                                        } else {
                                                            phi_6913_ = 0f;
                                                        }
                                                        let _e2433 = phi_6913_;
                                                        if (_e2344 == 2u) {
                                                            phi_6919_ = _e2428[1];
                                                        } else {
                                                            phi_6919_ = 0f;
                                                        }
                                                        let _e2437 = phi_6919_;
                                                        if (_e2344 == 3u) {
                                                            phi_6925_ = _e2428[2];
                                                        } else {
                                                            phi_6925_ = 0f;
                                                        }
                                                        let _e2441 = phi_6925_;
                                                        phi_6927_ = array<f32, 3>(_e2433, _e2437, _e2441);
                                                    }
                                                    let _e2444 = phi_6927_;
                                                    if (_e2444[0] < 0f) {
                                                        phi_6934_ = -(_e2444[0]);
                                                    } else {
                                                        phi_6934_ = _e2444[0];
                                                    }
                                                    let _e2449 = phi_6934_;
                                                    if (_e2444[1] < 0f) {
                                                        phi_6941_ = -(_e2444[1]);
                                                    } else {
                                                        phi_6941_ = _e2444[1];
                                                    }
                                                    let _e2454 = phi_6941_;
                                                    if (_e2444[2] < 0f) {
                                                        phi_6949_ = -(_e2444[2]);
                                                    } else {
                                                        phi_6949_ = _e2444[2];
                                                    }
                                                    let _e2460 = phi_6949_;
                                                    let _e2461 = ((_e2449 + _e2454) + _e2460);
                                                    if (_e2461 > 0f) {
                                                        if ((bitcast<u32>(_e2461) & 2139095040u) != 2139095040u) {
                                                            let _e2466 = (1f / _e2461);
                                                            let _e2468 = (_e2444[0] * _e2466);
                                                            let _e2470 = (_e2444[1] * _e2466);
                                                            let _e2472 = (_e2444[2] * _e2466);
                                                            let _e2477 = (((_e2468 * _e2468) + (_e2470 * _e2470)) + (_e2472 * _e2472));
                                                            if (_e2477 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2477 > 0f) {
                                                                    phi_6986_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6986_ = 0f;
                                                                }
                                                                let _e2530 = phi_6986_;
                                                                phi_7050_ = _e2530;
                                                            } else {
                                                                phi_6993_ = type_14(0i, 5i);
                                                                phi_6996_ = bitcast<f32>(((bitcast<u32>(_e2477) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2485 = phi_6993_;
                                                                    let _e2487 = phi_6996_;
                                                                    local_18 = _e2487;
                                                                    if (_e2485.member < _e2485.member_1) {
                                                                        let _e2494 = (_e2485.member + 1i);
                                                                        if ((false == (_e2494 > _e2485.member)) != false) {
                                                                            phi_7017_ = true;
                                                                        } else {
                                                                            phi_7017_ = false;
                                                                        }
                                                                        let _e2499 = phi_7017_;
                                                                        if _e2499 {
                                                                            phi_7023_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_7023_ = type_15(1u, _e2494);
                                                                        }
                                                                        let _e2504 = phi_7023_;
                                                                        phi_6994_ = type_14(_e2504.member_1, _e2485.member_1);
                                                                        phi_7037_ = type_15(1u, _e2485.member);
                                                                    } else {
                                                                        phi_6994_ = _e2485;
                                                                        phi_7037_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2510 = phi_6994_;
                                                                    let _e2512 = phi_7037_;
                                                                    let _e2515 = (bitcast<i32>(_e2512.member) != 0i);
                                                                    if _e2515 {
                                                                        phi_6997_ = (0.5f * (_e2487 + (_e2477 / _e2487)));
                                                                    } else {
                                                                        phi_6997_ = f32();
                                                                    }
                                                                    let _e2520 = phi_6997_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6993_ = _e2510;
                                                                        phi_6996_ = _e2520;
                                                                        break if !(_e2515);
                                                                    }
                                                                }
                                                                let _e2525 = local_18;
                                                                phi_7050_ = (_e2525 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2532 = phi_7050_;
                                                            let _e2533 = (0.000000059604645f * 12f);
                                                            let _e2538 = ((((((((_e2211 + _e2213) + (_e2265 + _e2267)) + (_e2319 + _e2321)) * (0.000000059604645f * 16f)) + (_e2328 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2532) * (1f + _e2533)));
                                                            let _e2543 = (((_e2468 * _e2115[0]) + (_e2470 * _e2115[1])) + (_e2472 * _e2115[2]));
                                                            let _e2548 = (((_e2468 * (_e2115[0] - _e2121[0])) + (_e2470 * (_e2115[1] - _e2121[1]))) + (_e2472 * (_e2115[2] - _e2121[2])));
                                                            let _e2553 = (((_e2468 * (_e2115[0] - _e2127[0])) + (_e2470 * (_e2115[1] - _e2127[1]))) + (_e2472 * (_e2115[2] - _e2127[2])));
                                                            let _e2558 = (((_e2468 * _e2115[0]) + (_e2470 * _e2115[1])) + (_e2472 * _e2115[2]));
                                                            let _e2564 = (((_e2468 * _e2139[0]) + (_e2470 * _e2139[1])) + (_e2472 * _e2139[2]));
                                                            let _e2569 = (((_e2468 * (_e2139[0] - _e2145[0])) + (_e2470 * (_e2139[1] - _e2145[1]))) + (_e2472 * (_e2139[2] - _e2145[2])));
                                                            let _e2574 = (((_e2468 * (_e2139[0] - _e2151[0])) + (_e2470 * (_e2139[1] - _e2151[1]))) + (_e2472 * (_e2139[2] - _e2151[2])));
                                                            let _e2579 = (((_e2468 * _e2139[0]) + (_e2470 * _e2139[1])) + (_e2472 * _e2139[2]));
                                                            if (_e2543 < 0f) {
                                                                phi_7116_ = -(_e2543);
                                                            } else {
                                                                phi_7116_ = _e2543;
                                                            }
                                                            let _e2584 = phi_7116_;
                                                            if (_e2564 < 0f) {
                                                                phi_7122_ = -(_e2564);
                                                            } else {
                                                                phi_7122_ = _e2564;
                                                            }
                                                            let _e2588 = phi_7122_;
                                                            if (_e2548 < 0f) {
                                                                phi_7131_ = -(_e2548);
                                                            } else {
                                                                phi_7131_ = _e2548;
                                                            }
                                                            let _e2595 = phi_7131_;
                                                            if (_e2569 < 0f) {
                                                                phi_7137_ = -(_e2569);
                                                            } else {
                                                                phi_7137_ = _e2569;
                                                            }
                                                            let _e2599 = phi_7137_;
                                                            if (_e2553 < 0f) {
                                                                phi_7146_ = -(_e2553);
                                                            } else {
                                                                phi_7146_ = _e2553;
                                                            }
                                                            let _e2606 = phi_7146_;
                                                            if (_e2574 < 0f) {
                                                                phi_7152_ = -(_e2574);
                                                            } else {
                                                                phi_7152_ = _e2574;
                                                            }
                                                            let _e2610 = phi_7152_;
                                                            if (_e2558 < 0f) {
                                                                phi_7161_ = -(_e2558);
                                                            } else {
                                                                phi_7161_ = _e2558;
                                                            }
                                                            let _e2617 = phi_7161_;
                                                            if (_e2579 < 0f) {
                                                                phi_7167_ = -(_e2579);
                                                            } else {
                                                                phi_7167_ = _e2579;
                                                            }
                                                            let _e2621 = phi_7167_;
                                                            phi_7173_ = type_30(array<f32, 4>(_e2543, _e2548, _e2553, _e2558), array<f32, 4>(_e2564, _e2569, _e2574, _e2579), array<f32, 4>((_e2538 + ((_e2584 + _e2588) * _e2533)), (_e2538 + ((_e2595 + _e2599) * _e2533)), (_e2538 + ((_e2606 + _e2610) * _e2533)), (_e2538 + ((_e2617 + _e2621) * _e2533))));
                                                            phi_7174_ = false;
                                                        } else {
                                                            phi_7173_ = type_30();
                                                            phi_7174_ = true;
                                                        }
                                                        let _e2628 = phi_7173_;
                                                        let _e2630 = phi_7174_;
                                                        phi_7175_ = _e2628;
                                                        phi_7176_ = _e2630;
                                                    } else {
                                                        phi_7175_ = type_30();
                                                        phi_7176_ = true;
                                                    }
                                                    let _e2632 = phi_7175_;
                                                    let _e2634 = phi_7176_;
                                                    if _e2634 {
                                                        phi_7184_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7184_ = _e2632;
                                                    }
                                                    let _e2636 = phi_7184_;
                                                    local_1 = type_30(array<f32, 4>(_e2636.member[0], _e2636.member[1], _e2636.member[2], _e2636.member[3]), array<f32, 4>(_e2636.member_1[0], _e2636.member_1[1], _e2636.member_1[2], _e2636.member_1[3]), array<f32, 4>(_e2636.member_2[0], _e2636.member_2[1], _e2636.member_2[2], _e2636.member_2[3]));
                                                    let _e2656 = (_e2336 - _e2340);
                                                    let _e2660 = local_1.member[0u];
                                                    let _e2663 = local_1.member_1[0u];
                                                    let _e2666 = local_1.member[0u];
                                                    let _e2672 = local_1.member_2[0u];
                                                    if (((_e2660 + ((_e2663 - _e2666) * _e2336)) - _e2672) > 0f) {
                                                        let _e2677 = local_1.member[1u];
                                                        let _e2680 = local_1.member_1[1u];
                                                        let _e2683 = local_1.member[1u];
                                                        let _e2689 = local_1.member_2[1u];
                                                        if (((_e2677 + ((_e2680 - _e2683) * _e2336)) - _e2689) > 0f) {
                                                            let _e2694 = local_1.member[2u];
                                                            let _e2697 = local_1.member_1[2u];
                                                            let _e2700 = local_1.member[2u];
                                                            let _e2706 = local_1.member_2[2u];
                                                            if (((_e2694 + ((_e2697 - _e2700) * _e2336)) - _e2706) > 0f) {
                                                                let _e2711 = local_1.member[3u];
                                                                let _e2714 = local_1.member_1[3u];
                                                                let _e2717 = local_1.member[3u];
                                                                let _e2723 = local_1.member_2[3u];
                                                                phi_7355_ = (((_e2711 + ((_e2714 - _e2717) * _e2336)) - _e2723) > 0f);
                                                                phi_7356_ = false;
                                                            } else {
                                                                phi_7355_ = bool();
                                                                phi_7356_ = true;
                                                            }
                                                            let _e2727 = phi_7355_;
                                                            let _e2729 = phi_7356_;
                                                            phi_7357_ = _e2727;
                                                            phi_7358_ = _e2729;
                                                        } else {
                                                            phi_7357_ = bool();
                                                            phi_7358_ = true;
                                                        }
                                                        let _e2731 = phi_7357_;
                                                        let _e2733 = phi_7358_;
                                                        phi_7359_ = _e2731;
                                                        phi_7360_ = _e2733;
                                                    } else {
                                                        phi_7359_ = bool();
                                                        phi_7360_ = true;
                                                    }
                                                    let _e2735 = phi_7359_;
                                                    let _e2737 = phi_7360_;
                                                    if _e2737 {
                                                        phi_7364_ = false;
                                                    } else {
                                                        phi_7364_ = _e2735;
                                                    }
                                                    let _e2739 = phi_7364_;
                                                    if _e2739 {
                                                        if (_e2336 <= _e2338) {
                                                            phi_7674_ = true;
                                                        } else {
                                                            let _e2743 = local.member[0u];
                                                            let _e2746 = local.member_1[0u];
                                                            let _e2749 = local.member[0u];
                                                            let _e2755 = local.member_2[0u];
                                                            let _e2759 = local_1.member[0u];
                                                            let _e2762 = local_1.member_1[0u];
                                                            let _e2765 = local_1.member[0u];
                                                            let _e2771 = local_1.member_2[0u];
                                                            if ((((_e2743 + ((_e2746 - _e2749) * _e2336)) - _e2755) + ((_e2759 + ((_e2762 - _e2765) * _e2340)) - _e2771)) > 0f) {
                                                                let _e2777 = local.member[1u];
                                                                let _e2780 = local.member_1[1u];
                                                                let _e2783 = local.member[1u];
                                                                let _e2789 = local.member_2[1u];
                                                                let _e2793 = local_1.member[1u];
                                                                let _e2796 = local_1.member_1[1u];
                                                                let _e2799 = local_1.member[1u];
                                                                let _e2805 = local_1.member_2[1u];
                                                                if ((((_e2777 + ((_e2780 - _e2783) * _e2336)) - _e2789) + ((_e2793 + ((_e2796 - _e2799) * _e2340)) - _e2805)) > 0f) {
                                                                    let _e2811 = local.member[2u];
                                                                    let _e2814 = local.member_1[2u];
                                                                    let _e2817 = local.member[2u];
                                                                    let _e2823 = local.member_2[2u];
                                                                    let _e2827 = local_1.member[2u];
                                                                    let _e2830 = local_1.member_1[2u];
                                                                    let _e2833 = local_1.member[2u];
                                                                    let _e2839 = local_1.member_2[2u];
                                                                    if ((((_e2811 + ((_e2814 - _e2817) * _e2336)) - _e2823) + ((_e2827 + ((_e2830 - _e2833) * _e2340)) - _e2839)) > 0f) {
                                                                        let _e2845 = local.member[3u];
                                                                        let _e2848 = local.member_1[3u];
                                                                        let _e2851 = local.member[3u];
                                                                        let _e2857 = local.member_2[3u];
                                                                        let _e2861 = local_1.member[3u];
                                                                        let _e2864 = local_1.member_1[3u];
                                                                        let _e2867 = local_1.member[3u];
                                                                        let _e2873 = local_1.member_2[3u];
                                                                        phi_7661_ = ((((_e2845 + ((_e2848 - _e2851) * _e2336)) - _e2857) + ((_e2861 + ((_e2864 - _e2867) * _e2340)) - _e2873)) > 0f);
                                                                        phi_7662_ = false;
                                                                    } else {
                                                                        phi_7661_ = bool();
                                                                        phi_7662_ = true;
                                                                    }
                                                                    let _e2878 = phi_7661_;
                                                                    let _e2880 = phi_7662_;
                                                                    phi_7663_ = _e2878;
                                                                    phi_7664_ = _e2880;
                                                                } else {
                                                                    phi_7663_ = bool();
                                                                    phi_7664_ = true;
                                                                }
                                                                let _e2882 = phi_7663_;
                                                                let _e2884 = phi_7664_;
                                                                phi_7665_ = _e2882;
                                                                phi_7666_ = _e2884;
                                                            } else {
                                                                phi_7665_ = bool();
                                                                phi_7666_ = true;
                                                            }
                                                            let _e2886 = phi_7665_;
                                                            let _e2888 = phi_7666_;
                                                            if _e2888 {
                                                                phi_7670_ = false;
                                                            } else {
                                                                phi_7670_ = _e2886;
                                                            }
                                                            let _e2890 = phi_7670_;
                                                            phi_7674_ = _e2890;
                                                        }
                                                        let _e2892 = phi_7674_;
                                                        if _e2892 {
                                                            if _e2342 {
                                                                if (_e2336 >= _e1390.member_1) {
                                                                    phi_7685_ = false;
                                                                } else {
                                                                    phi_7685_ = true;
                                                                }
                                                                let _e2895 = phi_7685_;
                                                                phi_7686_ = _e2895;
                                                            } else {
                                                                phi_7686_ = true;
                                                            }
                                                            let _e2897 = phi_7686_;
                                                            if _e2897 {
                                                                local = type_30(array<f32, 4>(_e2636.member[0], _e2636.member[1], _e2636.member[2], _e2636.member[3]), array<f32, 4>(_e2636.member_1[0], _e2636.member_1[1], _e2636.member_1[2], _e2636.member_1[3]), array<f32, 4>(_e2636.member_2[0], _e2636.member_2[1], _e2636.member_2[2], _e2636.member_2[3]));
                                                                let _e2919 = local.member[0u];
                                                                let _e2922 = local.member_1[0u];
                                                                let _e2925 = local.member_2[0u];
                                                                if (_e2919 > _e2925) {
                                                                    if (_e2922 > _e2925) {
                                                                        phi_7760_ = false;
                                                                    } else {
                                                                        phi_7760_ = true;
                                                                    }
                                                                    let _e2929 = phi_7760_;
                                                                    phi_7761_ = _e2929;
                                                                } else {
                                                                    phi_7761_ = true;
                                                                }
                                                                let _e2931 = phi_7761_;
                                                                if _e2931 {
                                                                    let _e2932 = (_e2922 >= _e2919);
                                                                    if _e2932 {
                                                                        phi_7783_ = f32();
                                                                        phi_7784_ = false;
                                                                    } else {
                                                                        if ((_e2919 - _e2922) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7781_ = (((_e2919 - _e2925) / (_e2919 - _e2922)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7782_ = false;
                                                                        } else {
                                                                            phi_7781_ = f32();
                                                                            phi_7782_ = true;
                                                                        }
                                                                        let _e2943 = phi_7781_;
                                                                        let _e2945 = phi_7782_;
                                                                        phi_7783_ = _e2943;
                                                                        phi_7784_ = _e2945;
                                                                    }
                                                                    let _e2947 = phi_7783_;
                                                                    let _e2949 = phi_7784_;
                                                                    phi_7785_ = _e2947;
                                                                    phi_7786_ = _e2932;
                                                                    phi_7787_ = _e2949;
                                                                } else {
                                                                    phi_7785_ = f32();
                                                                    phi_7786_ = true;
                                                                    phi_7787_ = false;
                                                                }
                                                                let _e2951 = phi_7785_;
                                                                let _e2953 = phi_7786_;
                                                                let _e2955 = phi_7787_;
                                                                if _e2953 {
                                                                    phi_7791_ = 2f;
                                                                    phi_7792_ = true;
                                                                } else {
                                                                    phi_7791_ = _e2336;
                                                                    phi_7792_ = _e2955;
                                                                }
                                                                let _e2957 = phi_7791_;
                                                                let _e2959 = phi_7792_;
                                                                if _e2959 {
                                                                    phi_7796_ = _e2957;
                                                                } else {
                                                                    phi_7796_ = _e2951;
                                                                }
                                                                let _e2961 = phi_7796_;
                                                                let _e2964 = local.member[1u];
                                                                let _e2967 = local.member_1[1u];
                                                                let _e2970 = local.member_2[1u];
                                                                if (_e2964 > _e2970) {
                                                                    if (_e2967 > _e2970) {
                                                                        phi_7828_ = false;
                                                                    } else {
                                                                        phi_7828_ = true;
                                                                    }
                                                                    let _e2974 = phi_7828_;
                                                                    phi_7829_ = _e2974;
                                                                } else {
                                                                    phi_7829_ = true;
                                                                }
                                                                let _e2976 = phi_7829_;
                                                                if _e2976 {
                                                                    let _e2977 = (_e2967 >= _e2964);
                                                                    if _e2977 {
                                                                        phi_7851_ = f32();
                                                                        phi_7852_ = false;
                                                                    } else {
                                                                        if ((_e2964 - _e2967) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7849_ = (((_e2964 - _e2970) / (_e2964 - _e2967)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7850_ = false;
                                                                        } else {
                                                                            phi_7849_ = f32();
                                                                            phi_7850_ = true;
                                                                        }
                                                                        let _e2988 = phi_7849_;
                                                                        let _e2990 = phi_7850_;
                                                                        phi_7851_ = _e2988;
                                                                        phi_7852_ = _e2990;
                                                                    }
                                                                    let _e2992 = phi_7851_;
                                                                    let _e2994 = phi_7852_;
                                                                    phi_7853_ = _e2992;
                                                                    phi_7854_ = _e2977;
                                                                    phi_7855_ = _e2994;
                                                                } else {
                                                                    phi_7853_ = f32();
                                                                    phi_7854_ = true;
                                                                    phi_7855_ = false;
                                                                }
                                                                let _e2996 = phi_7853_;
                                                                let _e2998 = phi_7854_;
                                                                let _e3000 = phi_7855_;
                                                                if _e2998 {
                                                                    phi_7859_ = 2f;
                                                                    phi_7860_ = true;
                                                                } else {
                                                                    phi_7859_ = _e2336;
                                                                    phi_7860_ = _e3000;
                                                                }
                                                                let _e3002 = phi_7859_;
                                                                let _e3004 = phi_7860_;
                                                                if _e3004 {
                                                                    phi_7864_ = _e3002;
                                                                } else {
                                                                    phi_7864_ = _e2996;
                                                                }
                                                                let _e3006 = phi_7864_;
                                                                if (_e2961 < _e3006) {
                                                                    phi_7869_ = _e2961;
                                                                } else {
                                                                    phi_7869_ = _e3006;
                                                                }
                                                                let _e3009 = phi_7869_;
                                                                let _e3012 = local.member[2u];
                                                                let _e3015 = local.member_1[2u];
                                                                let _e3018 = local.member_2[2u];
                                                                if (_e3012 > _e3018) {
                                                                    if (_e3015 > _e3018) {
                                                                        phi_7901_ = false;
                                                                    } else {
                                                                        phi_7901_ = true;
                                                                    }
                                                                    let _e3022 = phi_7901_;
                                                                    phi_7902_ = _e3022;
                                                                } else {
                                                                    phi_7902_ = true;
                                                                }
                                                                let _e3024 = phi_7902_;
                                                                if _e3024 {
                                                                    let _e3025 = (_e3015 >= _e3012);
                                                                    if _e3025 {
                                                                        phi_7924_ = f32();
                                                                        phi_7925_ = false;
                                                                    } else {
                                                                        if ((_e3012 - _e3015) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7922_ = (((_e3012 - _e3018) / (_e3012 - _e3015)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7923_ = false;
                                                                        } else {
                                                                            phi_7922_ = f32();
                                                                            phi_7923_ = true;
                                                                        }
                                                                        let _e3036 = phi_7922_;
                                                                        let _e3038 = phi_7923_;
                                                                        phi_7924_ = _e3036;
                                                                        phi_7925_ = _e3038;
                                                                    }
                                                                    let _e3040 = phi_7924_;
                                                                    let _e3042 = phi_7925_;
                                                                    phi_7926_ = _e3040;
                                                                    phi_7927_ = _e3025;
                                                                    phi_7928_ = _e3042;
                                                                } else {
                                                                    phi_7926_ = f32();
                                                                    phi_7927_ = true;
                                                                    phi_7928_ = false;
                                                                }
                                                                let _e3044 = phi_7926_;
                                                                let _e3046 = phi_7927_;
                                                                let _e3048 = phi_7928_;
                                                                if _e3046 {
                                                                    phi_7932_ = 2f;
                                                                    phi_7933_ = true;
                                                                } else {
                                                                    phi_7932_ = _e2336;
                                                                    phi_7933_ = _e3048;
                                                                }
                                                                let _e3050 = phi_7932_;
                                                                let _e3052 = phi_7933_;
                                                                if _e3052 {
                                                                    phi_7937_ = _e3050;
                                                                } else {
                                                                    phi_7937_ = _e3044;
                                                                }
                                                                let _e3054 = phi_7937_;
                                                                let _e3057 = local.member[3u];
                                                                let _e3060 = local.member_1[3u];
                                                                let _e3063 = local.member_2[3u];
                                                                if (_e3057 > _e3063) {
                                                                    if (_e3060 > _e3063) {
                                                                        phi_7969_ = false;
                                                                    } else {
                                                                        phi_7969_ = true;
                                                                    }
                                                                    let _e3067 = phi_7969_;
                                                                    phi_7970_ = _e3067;
                                                                } else {
                                                                    phi_7970_ = true;
                                                                }
                                                                let _e3069 = phi_7970_;
                                                                if _e3069 {
                                                                    let _e3070 = (_e3060 >= _e3057);
                                                                    if _e3070 {
                                                                        phi_7992_ = f32();
                                                                        phi_7993_ = false;
                                                                    } else {
                                                                        if ((_e3057 - _e3060) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7990_ = (((_e3057 - _e3063) / (_e3057 - _e3060)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7991_ = false;
                                                                        } else {
                                                                            phi_7990_ = f32();
                                                                            phi_7991_ = true;
                                                                        }
                                                                        let _e3081 = phi_7990_;
                                                                        let _e3083 = phi_7991_;
                                                                        phi_7992_ = _e3081;
                                                                        phi_7993_ = _e3083;
                                                                    }
                                                                    let _e3085 = phi_7992_;
                                                                    let _e3087 = phi_7993_;
                                                                    phi_7994_ = _e3085;
                                                                    phi_7995_ = _e3070;
                                                                    phi_7996_ = _e3087;
                                                                } else {
                                                                    phi_7994_ = f32();
                                                                    phi_7995_ = true;
                                                                    phi_7996_ = false;
                                                                }
                                                                let _e3089 = phi_7994_;
                                                                let _e3091 = phi_7995_;
                                                                let _e3093 = phi_7996_;
                                                                if _e3091 {
                                                                    phi_8000_ = 2f;
                                                                    phi_8001_ = true;
                                                                } else {
                                                                    phi_8000_ = _e2336;
                                                                    phi_8001_ = _e3093;
                                                                }
                                                                let _e3095 = phi_8000_;
                                                                let _e3097 = phi_8001_;
                                                                if _e3097 {
                                                                    phi_8005_ = _e3095;
                                                                } else {
                                                                    phi_8005_ = _e3089;
                                                                }
                                                                let _e3099 = phi_8005_;
                                                                if (_e3054 < _e3099) {
                                                                    phi_8010_ = _e3054;
                                                                } else {
                                                                    phi_8010_ = _e3099;
                                                                }
                                                                let _e3102 = phi_8010_;
                                                                if (_e3009 < _e3102) {
                                                                    phi_8015_ = _e3009;
                                                                } else {
                                                                    phi_8015_ = _e3102;
                                                                }
                                                                let _e3105 = phi_8015_;
                                                                if (_e3105 > _e2336) {
                                                                    phi_8020_ = _e3105;
                                                                } else {
                                                                    phi_8020_ = _e2336;
                                                                }
                                                                let _e3108 = phi_8020_;
                                                                let _e3109 = (_e3108 > _e1390.member_1);
                                                                if _e3109 {
                                                                    phi_8031_ = f32();
                                                                    phi_8032_ = false;
                                                                } else {
                                                                    if _e2342 {
                                                                        phi_8030_ = (_e2656 + _e2656);
                                                                    } else {
                                                                        phi_8030_ = (_e1390.member_1 - _e2336);
                                                                    }
                                                                    let _e3113 = phi_8030_;
                                                                    phi_8031_ = _e3113;
                                                                    phi_8032_ = true;
                                                                }
                                                                let _e3115 = phi_8031_;
                                                                let _e3117 = phi_8032_;
                                                                phi_8033_ = _e3108;
                                                                phi_8034_ = _e3115;
                                                                phi_8035_ = _e3117;
                                                                phi_8036_ = _e3109;
                                                                phi_8037_ = false;
                                                            } else {
                                                                phi_8033_ = f32();
                                                                phi_8034_ = f32();
                                                                phi_8035_ = false;
                                                                phi_8036_ = false;
                                                                phi_8037_ = true;
                                                            }
                                                            let _e3119 = phi_8033_;
                                                            let _e3121 = phi_8034_;
                                                            let _e3123 = phi_8035_;
                                                            let _e3125 = phi_8036_;
                                                            let _e3127 = phi_8037_;
                                                            phi_8038_ = _e3119;
                                                            phi_8039_ = _e3121;
                                                            phi_8040_ = false;
                                                            phi_8041_ = _e3123;
                                                            phi_8042_ = _e3125;
                                                            phi_8043_ = _e3127;
                                                        } else {
                                                            phi_8038_ = f32();
                                                            phi_8039_ = f32();
                                                            phi_8040_ = true;
                                                            phi_8041_ = false;
                                                            phi_8042_ = false;
                                                            phi_8043_ = false;
                                                        }
                                                        let _e3129 = phi_8038_;
                                                        let _e3131 = phi_8039_;
                                                        let _e3133 = phi_8040_;
                                                        let _e3135 = phi_8041_;
                                                        let _e3137 = phi_8042_;
                                                        let _e3139 = phi_8043_;
                                                        phi_8044_ = _e3129;
                                                        phi_8045_ = _e3131;
                                                        phi_8046_ = _e3133;
                                                        phi_8047_ = _e3135;
                                                        phi_8048_ = _e3137;
                                                        phi_8049_ = _e3139;
                                                    } else {
                                                        phi_8044_ = f32();
                                                        phi_8045_ = f32();
                                                        phi_8046_ = true;
                                                        phi_8047_ = false;
                                                        phi_8048_ = false;
                                                        phi_8049_ = false;
                                                    }
                                                    let _e3141 = phi_8044_;
                                                    let _e3143 = phi_8045_;
                                                    let _e3145 = phi_8046_;
                                                    let _e3147 = phi_8047_;
                                                    let _e3149 = phi_8048_;
                                                    let _e3151 = phi_8049_;
                                                    if _e3145 {
                                                        if (_e2336 <= _e2338) {
                                                            let _e3312 = (_e2344 + 1u);
                                                            let _e3313 = (_e3312 > 3u);
                                                            if _e3313 {
                                                                phi_8062_ = false;
                                                            } else {
                                                                phi_8062_ = true;
                                                            }
                                                            let _e3315 = phi_8062_;
                                                            phi_8384_ = _e3312;
                                                            phi_8385_ = f32();
                                                            phi_8386_ = false;
                                                            phi_8387_ = _e3315;
                                                            phi_8388_ = _e3313;
                                                        } else {
                                                            let _e3155 = local.member[0u];
                                                            let _e3158 = local.member_1[0u];
                                                            let _e3161 = local.member[0u];
                                                            let _e3167 = local.member_2[0u];
                                                            let _e3168 = ((_e3155 + ((_e3158 - _e3161) * _e2340)) - _e3167);
                                                            let _e3171 = local.member[1u];
                                                            let _e3174 = local.member_1[1u];
                                                            let _e3177 = local.member[1u];
                                                            let _e3183 = local.member_2[1u];
                                                            let _e3184 = ((_e3171 + ((_e3174 - _e3177) * _e2340)) - _e3183);
                                                            if (_e3168 < _e3184) {
                                                                phi_8135_ = _e3168;
                                                            } else {
                                                                phi_8135_ = _e3184;
                                                            }
                                                            let _e3187 = phi_8135_;
                                                            let _e3190 = local.member[2u];
                                                            let _e3193 = local.member_1[2u];
                                                            let _e3196 = local.member[2u];
                                                            let _e3202 = local.member_2[2u];
                                                            let _e3203 = ((_e3190 + ((_e3193 - _e3196) * _e2340)) - _e3202);
                                                            let _e3206 = local.member[3u];
                                                            let _e3209 = local.member_1[3u];
                                                            let _e3212 = local.member[3u];
                                                            let _e3218 = local.member_2[3u];
                                                            let _e3219 = ((_e3206 + ((_e3209 - _e3212) * _e2340)) - _e3218);
                                                            if (_e3203 < _e3219) {
                                                                phi_8208_ = _e3203;
                                                            } else {
                                                                phi_8208_ = _e3219;
                                                            }
                                                            let _e3222 = phi_8208_;
                                                            if (_e3187 < _e3222) {
                                                                phi_8213_ = _e3187;
                                                            } else {
                                                                phi_8213_ = _e3222;
                                                            }
                                                            let _e3225 = phi_8213_;
                                                            let _e3228 = local_1.member[0u];
                                                            let _e3231 = local_1.member_1[0u];
                                                            let _e3234 = local_1.member[0u];
                                                            let _e3240 = local_1.member_2[0u];
                                                            let _e3241 = ((_e3228 + ((_e3231 - _e3234) * _e2336)) - _e3240);
                                                            let _e3244 = local_1.member[1u];
                                                            let _e3247 = local_1.member_1[1u];
                                                            let _e3250 = local_1.member[1u];
                                                            let _e3256 = local_1.member_2[1u];
                                                            let _e3257 = ((_e3244 + ((_e3247 - _e3250) * _e2336)) - _e3256);
                                                            if (_e3241 < _e3257) {
                                                                phi_8286_ = _e3241;
                                                            } else {
                                                                phi_8286_ = _e3257;
                                                            }
                                                            let _e3260 = phi_8286_;
                                                            let _e3263 = local_1.member[2u];
                                                            let _e3266 = local_1.member_1[2u];
                                                            let _e3269 = local_1.member[2u];
                                                            let _e3275 = local_1.member_2[2u];
                                                            let _e3276 = ((_e3263 + ((_e3266 - _e3269) * _e2336)) - _e3275);
                                                            let _e3279 = local_1.member[3u];
                                                            let _e3282 = local_1.member_1[3u];
                                                            let _e3285 = local_1.member[3u];
                                                            let _e3291 = local_1.member_2[3u];
                                                            let _e3292 = ((_e3279 + ((_e3282 - _e3285) * _e2336)) - _e3291);
                                                            if (_e3276 < _e3292) {
                                                                phi_8359_ = _e3276;
                                                            } else {
                                                                phi_8359_ = _e3292;
                                                            }
                                                            let _e3295 = phi_8359_;
                                                            if (_e3260 < _e3295) {
                                                                phi_8364_ = _e3260;
                                                            } else {
                                                                phi_8364_ = _e3295;
                                                            }
                                                            let _e3298 = phi_8364_;
                                                            if (_e3298 > 0f) {
                                                                phi_8382_ = 0.5f;
                                                            } else {
                                                                let _e3302 = (0.95f * (_e3225 / (_e3225 - _e3298)));
                                                                if (_e3302 > 0.0625f) {
                                                                    if (_e3302 < 0.9f) {
                                                                        phi_8380_ = _e3302;
                                                                    } else {
                                                                        phi_8380_ = 0.9f;
                                                                    }
                                                                    let _e3306 = phi_8380_;
                                                                    phi_8381_ = _e3306;
                                                                } else {
                                                                    phi_8381_ = 0.0625f;
                                                                }
                                                                let _e3308 = phi_8381_;
                                                                phi_8382_ = _e3308;
                                                            }
                                                            let _e3310 = phi_8382_;
                                                            phi_8384_ = u32();
                                                            phi_8385_ = (_e2656 * _e3310);
                                                            phi_8386_ = true;
                                                            phi_8387_ = false;
                                                            phi_8388_ = false;
                                                        }
                                                        let _e3317 = phi_8384_;
                                                        let _e3319 = phi_8385_;
                                                        let _e3321 = phi_8386_;
                                                        let _e3323 = phi_8387_;
                                                        let _e3325 = phi_8388_;
                                                        phi_8389_ = _e3317;
                                                        phi_8390_ = _e2338;
                                                        phi_8391_ = _e3319;
                                                        phi_8392_ = _e2340;
                                                        phi_8393_ = _e2342;
                                                        phi_8394_ = _e2344;
                                                        phi_8395_ = _e3321;
                                                        phi_8396_ = _e3323;
                                                        phi_8397_ = _e3325;
                                                        phi_8398_ = false;
                                                        phi_8399_ = false;
                                                    } else {
                                                        phi_8389_ = u32();
                                                        phi_8390_ = _e3141;
                                                        phi_8391_ = _e3143;
                                                        phi_8392_ = _e2336;
                                                        phi_8393_ = true;
                                                        phi_8394_ = 0u;
                                                        phi_8395_ = _e3147;
                                                        phi_8396_ = false;
                                                        phi_8397_ = false;
                                                        phi_8398_ = _e3149;
                                                        phi_8399_ = _e3151;
                                                    }
                                                    let _e3327 = phi_8389_;
                                                    let _e3329 = phi_8390_;
                                                    let _e3331 = phi_8391_;
                                                    let _e3333 = phi_8392_;
                                                    let _e3335 = phi_8393_;
                                                    let _e3337 = phi_8394_;
                                                    let _e3339 = phi_8395_;
                                                    let _e3341 = phi_8396_;
                                                    let _e3343 = phi_8397_;
                                                    let _e3345 = phi_8398_;
                                                    let _e3347 = phi_8399_;
                                                    if _e3339 {
                                                        let _e3348 = (_e3333 + _e3331);
                                                        if (_e3348 > _e3329) {
                                                            phi_8408_ = _e3348;
                                                        } else {
                                                            phi_8408_ = _e3329;
                                                        }
                                                        let _e3351 = phi_8408_;
                                                        if (_e3351 < _e1390.member_1) {
                                                            phi_8413_ = _e3351;
                                                        } else {
                                                            phi_8413_ = _e1390.member_1;
                                                        }
                                                        let _e3354 = phi_8413_;
                                                        if !(_e2342) {
                                                            phi_8422_ = true;
                                                        } else {
                                                            phi_8422_ = ((_e3354 - _e3333) > 0.0000000037252903f);
                                                        }
                                                        let _e3358 = phi_8422_;
                                                        if _e3358 {
                                                            phi_8426_ = false;
                                                        } else {
                                                            phi_8426_ = true;
                                                        }
                                                        let _e3360 = phi_8426_;
                                                        phi_8427_ = _e3354;
                                                        phi_8428_ = _e3329;
                                                        phi_8429_ = _e3333;
                                                        phi_8430_ = _e3335;
                                                        phi_8431_ = _e3337;
                                                        phi_8432_ = _e3358;
                                                        phi_8433_ = _e3360;
                                                        phi_8434_ = false;
                                                        phi_8435_ = false;
                                                        phi_8436_ = false;
                                                    } else {
                                                        phi_8427_ = _e2336;
                                                        phi_8428_ = _e2338;
                                                        phi_8429_ = _e2340;
                                                        phi_8430_ = _e2342;
                                                        phi_8431_ = _e3327;
                                                        phi_8432_ = _e3341;
                                                        phi_8433_ = false;
                                                        phi_8434_ = _e3343;
                                                        phi_8435_ = _e3345;
                                                        phi_8436_ = _e3347;
                                                    }
                                                    let _e3362 = phi_8427_;
                                                    let _e3364 = phi_8428_;
                                                    let _e3366 = phi_8429_;
                                                    let _e3368 = phi_8430_;
                                                    let _e3370 = phi_8431_;
                                                    let _e3372 = phi_8432_;
                                                    let _e3374 = phi_8433_;
                                                    let _e3376 = phi_8434_;
                                                    let _e3378 = phi_8435_;
                                                    let _e3380 = phi_8436_;
                                                    phi_6769_ = _e3362;
                                                    phi_6771_ = _e3364;
                                                    phi_6773_ = _e3366;
                                                    phi_6775_ = _e3368;
                                                    phi_6777_ = _e3370;
                                                    phi_8437_ = _e3329;
                                                    phi_8438_ = _e3372;
                                                    phi_8439_ = _e3374;
                                                    phi_8440_ = false;
                                                    phi_8441_ = _e3376;
                                                    phi_8442_ = _e3378;
                                                    phi_8443_ = _e3380;
                                                } else {
                                                    phi_6769_ = f32();
                                                    phi_6771_ = f32();
                                                    phi_6773_ = f32();
                                                    phi_6775_ = bool();
                                                    phi_6777_ = u32();
                                                    phi_8437_ = f32();
                                                    phi_8438_ = false;
                                                    phi_8439_ = false;
                                                    phi_8440_ = true;
                                                    phi_8441_ = false;
                                                    phi_8442_ = false;
                                                    phi_8443_ = false;
                                                }
                                                let _e3382 = phi_6769_;
                                                let _e3384 = phi_6771_;
                                                let _e3386 = phi_6773_;
                                                let _e3388 = phi_6775_;
                                                let _e3390 = phi_6777_;
                                                let _e3392 = phi_8437_;
                                                let _e3394 = phi_8438_;
                                                let _e3396 = phi_8439_;
                                                let _e3398 = phi_8440_;
                                                let _e3400 = phi_8441_;
                                                let _e3402 = phi_8442_;
                                                let _e3404 = phi_8443_;
                                                local_19 = _e3396;
                                                local_35 = _e3392;
                                                local_37 = _e3398;
                                                local_38 = _e3400;
                                                local_39 = _e3402;
                                                local_40 = _e3404;
                                                continue;
                                                continuing {
                                                    phi_6765_ = _e2356;
                                                    phi_6768_ = _e3382;
                                                    phi_6770_ = _e3384;
                                                    phi_6772_ = _e3386;
                                                    phi_6774_ = _e3388;
                                                    phi_6776_ = _e3390;
                                                    break if !(_e3394);
                                                }
                                            }
                                            let _e3407 = local_19;
                                            if _e3407 {
                                                let _e5894 = local_35;
                                                phi_8447_ = _e5894;
                                                phi_8448_ = true;
                                                phi_8449_ = false;
                                                phi_8450_ = false;
                                                phi_8451_ = false;
                                            } else {
                                                let _e5896 = local_36;
                                                phi_8447_ = _e5896;
                                                let _e5899 = local_37;
                                                phi_8448_ = _e5899;
                                                let _e5902 = local_38;
                                                phi_8449_ = _e5902;
                                                let _e5905 = local_39;
                                                phi_8450_ = _e5905;
                                                let _e5908 = local_40;
                                                phi_8451_ = _e5908;
                                            }
                                            let _e3409 = phi_8447_;
                                            let _e3411 = phi_8448_;
                                            let _e3413 = phi_8449_;
                                            let _e3415 = phi_8450_;
                                            let _e3417 = phi_8451_;
                                            if _e3411 {
                                                phi_8456_ = type_35(1u, _e3409);
                                                phi_8457_ = false;
                                                phi_8458_ = false;
                                                phi_8459_ = false;
                                            } else {
                                                phi_8456_ = type_35();
                                                phi_8457_ = _e3413;
                                                phi_8458_ = _e3415;
                                                phi_8459_ = _e3417;
                                            }
                                            let _e3420 = phi_8456_;
                                            let _e3422 = phi_8457_;
                                            let _e3424 = phi_8458_;
                                            let _e3426 = phi_8459_;
                                            if _e3422 {
                                                let _e3428 = local_20;
                                                phi_8464_ = type_35(1u, _e3428);
                                                phi_8465_ = false;
                                                phi_8466_ = false;
                                            } else {
                                                phi_8464_ = type_35();
                                                phi_8465_ = _e3424;
                                                phi_8466_ = _e3426;
                                            }
                                            let _e3431 = phi_8464_;
                                            let _e3433 = phi_8465_;
                                            let _e3435 = phi_8466_;
                                            if _e3433 {
                                                phi_8471_ = type_35(0u, type_35().member_1);
                                                phi_8472_ = false;
                                                phi_8473_ = true;
                                            } else {
                                                phi_8471_ = _e3431;
                                                phi_8472_ = _e3435;
                                                phi_8473_ = _e3422;
                                            }
                                            let _e3439 = phi_8471_;
                                            let _e3441 = phi_8472_;
                                            let _e3443 = phi_8473_;
                                            if _e3441 {
                                                phi_8478_ = type_35(0u, type_35().member_1);
                                                phi_8479_ = true;
                                            } else {
                                                phi_8478_ = _e3439;
                                                phi_8479_ = _e3443;
                                            }
                                            let _e3447 = phi_8478_;
                                            let _e3449 = phi_8479_;
                                            if _e3449 {
                                                phi_8483_ = _e3447;
                                            } else {
                                                phi_8483_ = _e3420;
                                            }
                                            let _e3451 = phi_8483_;
                                            let _e3454 = (_e3451.member != 0u);
                                            if _e3454 {
                                                phi_8490_ = false;
                                            } else {
                                                phi_8490_ = true;
                                            }
                                            let _e3456 = phi_8490_;
                                            phi_8491_ = _e3451.member_1;
                                            phi_8492_ = _e3456;
                                            phi_8493_ = _e3454;
                                            phi_8494_ = false;
                                        } else {
                                            phi_8491_ = f32();
                                            phi_8492_ = false;
                                            phi_8493_ = false;
                                            phi_8494_ = true;
                                        }
                                        let _e3458 = phi_8491_;
                                        let _e3460 = phi_8492_;
                                        let _e3462 = phi_8493_;
                                        let _e3464 = phi_8494_;
                                        phi_8495_ = _e3458;
                                        phi_8496_ = _e3460;
                                        phi_8497_ = _e3462;
                                        phi_8498_ = _e3464;
                                    }
                                    let _e3466 = phi_8495_;
                                    let _e3468 = phi_8496_;
                                    let _e3470 = phi_8497_;
                                    let _e3472 = phi_8498_;
                                    phi_8499_ = _e3466;
                                    phi_8500_ = _e2098;
                                    phi_8501_ = _e3468;
                                    phi_8502_ = _e3470;
                                    phi_8503_ = _e3472;
                                }
                                let _e3474 = phi_8499_;
                                let _e3476 = phi_8500_;
                                let _e3478 = phi_8501_;
                                let _e3480 = phi_8502_;
                                let _e3482 = phi_8503_;
                                if _e3476 {
                                    phi_8507_ = true;
                                    phi_8508_ = false;
                                    phi_8509_ = false;
                                } else {
                                    phi_8507_ = _e3478;
                                    phi_8508_ = _e3480;
                                    phi_8509_ = _e3482;
                                }
                                let _e3484 = phi_8507_;
                                let _e3486 = phi_8508_;
                                let _e3488 = phi_8509_;
                                phi_8510_ = _e3474;
                                phi_8511_ = _e1390;
                                phi_8512_ = _e3484;
                                phi_8513_ = false;
                                phi_8514_ = _e3486;
                                phi_8515_ = _e3488;
                            } else {
                                phi_8510_ = f32();
                                phi_8511_ = type_37();
                                phi_8512_ = false;
                                phi_8513_ = true;
                                phi_8514_ = false;
                                phi_8515_ = false;
                            }
                            let _e3490 = phi_8510_;
                            let _e3492 = phi_8511_;
                            let _e3494 = phi_8512_;
                            let _e3496 = phi_8513_;
                            let _e3498 = phi_8514_;
                            let _e3500 = phi_8515_;
                            local_21 = _e3496;
                            local_41 = _e3498;
                            local_42 = _e3500;
                            local_22 = _e3490;
                            local_23 = _e3492;
                            continue;
                            continuing {
                                phi_4902_ = _e1120;
                                break if !(_e3494);
                            }
                        }
                        let _e3503 = local_21;
                        if _e3503 {
                            phi_8520_ = type_35(0u, type_35().member_1);
                            phi_8521_ = false;
                            phi_8522_ = false;
                        } else {
                            phi_8520_ = type_35();
                            let _e5950 = local_41;
                            phi_8521_ = _e5950;
                            let _e5953 = local_42;
                            phi_8522_ = _e5953;
                        }
                        let _e3507 = phi_8520_;
                        let _e3509 = phi_8521_;
                        let _e3511 = phi_8522_;
                        if _e3509 {
                            let _e3513 = local_22;
                            phi_8527_ = type_35(2u, _e3513);
                            phi_8528_ = false;
                        } else {
                            phi_8527_ = type_35();
                            phi_8528_ = _e3511;
                        }
                        let _e3516 = phi_8527_;
                        let _e3518 = phi_8528_;
                        if _e3518 {
                            let _e3520 = local_23;
                            phi_8534_ = type_35(1u, _e3520.member);
                            phi_8535_ = true;
                        } else {
                            phi_8534_ = _e3516;
                            phi_8535_ = _e3509;
                        }
                        let _e3524 = phi_8534_;
                        let _e3526 = phi_8535_;
                        if _e3526 {
                            phi_8539_ = _e3524;
                        } else {
                            phi_8539_ = _e3507;
                        }
                        let _e3528 = phi_8539_;
                        phi_8543_ = _e3528;
                    }
                    let _e5243 = phi_8543_;
                    phi_8544_ = _e5243;
                }
                let _e5247 = phi_8544_;
                switch bitcast<i32>(_e5247.member) {
                    case 0: {
                        phi_8557_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5253 = function_2(_e5247.member_1);
                        phi_8557_ = type_38(0u, _e5253, true);
                        break;
                    }
                    case 2: {
                        let _e5251 = function_2(_e5247.member_1);
                        phi_8557_ = type_38(1u, _e5251, true);
                        break;
                    }
                    default: {
                        phi_8557_ = type_38();
                        break;
                    }
                }
                let _e5256 = phi_8557_;
                if _e5256.member_2 {
                    phi_8564_ = (_e5256.member == 0u);
                } else {
                    phi_8564_ = false;
                }
                let _e5261 = phi_8564_;
                if _e5261 {
                    let _e5269 = (_e5256.member_1[1] >> bitcast<u32>(20i));
                    if (_e5269 <= 896u) {
                        phi_8588_ = 0u;
                    } else {
                        phi_8588_ = ((((_e5269 - 896u) << bitcast<u32>(23i)) | ((_e5256.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5256.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5284 = phi_8588_;
                    let _e5286 = atomicMin((&earliest.member[0u]), _e5284);
                }
                phi_8592_ = type_20(0u, 0u, _e176, _e179, _e5256.member_1);
                phi_8593_ = _e5261;
                phi_8594_ = (_e5256.member != 0u);
            } else {
                phi_8592_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8593_ = false;
                phi_8594_ = false;
            }
            let _e5288 = phi_8592_;
            let _e5290 = phi_8593_;
            let _e5292 = phi_8594_;
            let _e5295 = params.member.member.member_1;
            if ((_e5295 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5290 {
                    let _e5301 = atomicAdd((&counters[0u]), 1u);
                    phi_8613_ = _e5301;
                } else {
                    phi_8613_ = 0u;
                }
                let _e5303 = phi_8613_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5306 = atomicLoad((&counters[0u]));
                    if (_e5306 > 0u) {
                        let _e5309 = atomicAdd((&contacts.member[0u]), _e5306);
                        atomicStore((&counters[1u]), _e5309);
                    }
                }
                workgroupBarrier();
                let _e5312 = atomicLoad((&counters[1u]));
                let _e5313 = (_e5312 + _e5303);
                if _e5290 {
                    let _e5316 = params.member.member_1.member_3;
                    if (_e5313 < _e5316) {
                        let _e5318 = (6u * _e5313);
                        atomicStore((&contacts.member[(4u + _e5318)]), _e5288.member);
                        atomicStore((&contacts.member[(_e5318 + 5u)]), _e5288.member_1);
                        atomicStore((&contacts.member[(_e5318 + 6u)]), _e5288.member_2);
                        atomicStore((&contacts.member[(_e5318 + 7u)]), _e5288.member_3);
                        atomicStore((&contacts.member[(_e5318 + 8u)]), _e5288.member_4[0]);
                        atomicStore((&contacts.member[(_e5318 + 9u)]), _e5288.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5292 {
                let _e5342 = atomicAdd((&counters[0u]), 1u);
                phi_8676_ = _e5342;
            } else {
                phi_8676_ = 0u;
            }
            let _e5344 = phi_8676_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5347 = atomicLoad((&counters[0u]));
                if (_e5347 > 0u) {
                    let _e5350 = atomicAdd((&undecided.member[0u]), _e5347);
                    atomicStore((&counters[1u]), _e5350);
                }
            }
            workgroupBarrier();
            let _e5353 = atomicLoad((&counters[1u]));
            let _e5354 = (_e5353 + _e5344);
            if _e5292 {
                let _e5357 = params.member.member_2.member;
                if (_e5354 < _e5357) {
                    let _e5361 = (2u * _e5354);
                    atomicStore((&undecided.member[(4u + _e5361)]), _e5288.member_2);
                    atomicStore((&undecided.member[(_e5361 + 5u)]), _e5288.member_3);
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
