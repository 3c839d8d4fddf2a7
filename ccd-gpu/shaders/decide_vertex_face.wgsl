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
    member: type_23,
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
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_27;
@group(0) @binding(2) 
var<storage> elements: type_30;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_687_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_687_ = param_1;
    } else {
        phi_687_ = param;
    }
    let _e26 = phi_687_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_286_: bool;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_263_: bool;
    var phi_264_: bool;
    var phi_268_: bool;
    var phi_287_: bool;
    var phi_317_: array<f32, 3>;
    var phi_318_: bool;
    var phi_319_: array<f32, 3>;
    var phi_320_: bool;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_587_: f32;
    var phi_588_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_414_: f32;
    var phi_415_: f32;
    var phi_457_: f32;
    var phi_458_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_649_: array<array<f32, 3>, 4>;
    var phi_657_: array<f32, 3>;

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
                    phi_259_ = (_e76 <= 1f);
                    phi_260_ = false;
                } else {
                    phi_259_ = bool();
                    phi_260_ = true;
                }
                let _e97 = phi_259_;
                let _e99 = phi_260_;
                phi_261_ = _e97;
                phi_262_ = _e99;
            } else {
                phi_261_ = bool();
                phi_262_ = true;
            }
            let _e101 = phi_261_;
            let _e103 = phi_262_;
            phi_263_ = _e101;
            phi_264_ = _e103;
        } else {
            phi_263_ = bool();
            phi_264_ = true;
        }
        let _e105 = phi_263_;
        let _e107 = phi_264_;
        if _e107 {
            phi_268_ = false;
        } else {
            phi_268_ = _e105;
        }
        let _e109 = phi_268_;
        phi_287_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_279_ = ((_e72 + _e76) <= 1f);
                phi_280_ = false;
            } else {
                phi_279_ = bool();
                phi_280_ = true;
            }
            let _e83 = phi_279_;
            let _e85 = phi_280_;
            phi_281_ = _e83;
            phi_282_ = _e85;
        } else {
            phi_281_ = bool();
            phi_282_ = true;
        }
        let _e87 = phi_281_;
        let _e89 = phi_282_;
        if _e89 {
            phi_286_ = false;
        } else {
            phi_286_ = _e87;
        }
        let _e91 = phi_286_;
        phi_287_ = _e91;
    }
    let _e111 = phi_287_;
    if (_e68 > 0f) {
        if _e111 {
            phi_317_ = array<f32, 3>((param_2[0] - ((param_3[0] * _e72) + (param_4[0] * _e76))), (param_2[1] - ((param_3[1] * _e72) + (param_4[1] * _e76))), (param_2[2] - ((param_3[2] * _e72) + (param_4[2] * _e76))));
            phi_318_ = false;
        } else {
            phi_317_ = array<f32, 3>();
            phi_318_ = true;
        }
        let _e136 = phi_317_;
        let _e138 = phi_318_;
        phi_319_ = _e136;
        phi_320_ = _e138;
    } else {
        phi_319_ = array<f32, 3>();
        phi_320_ = true;
    }
    let _e140 = phi_319_;
    let _e142 = phi_320_;
    if _e142 {
        let _e145 = (param_2[0] - param_3[0]);
        let _e148 = (param_2[1] - param_3[1]);
        let _e151 = (param_2[2] - param_3[2]);
        if (param_5 != 0u) {
            let _e293 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_368_ = _e293;
                } else {
                    phi_368_ = 1f;
                }
                let _e297 = phi_368_;
                phi_369_ = _e297;
            } else {
                phi_369_ = 0f;
            }
            let _e299 = phi_369_;
            let _e335 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_414_ = _e335;
                } else {
                    phi_414_ = 1f;
                }
                let _e339 = phi_414_;
                phi_415_ = _e339;
            } else {
                phi_415_ = 0f;
            }
            let _e341 = phi_415_;
            let _e374 = ((((_e145 * param_4[0]) + (_e148 * param_4[1])) + (_e151 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_457_ = _e374;
                } else {
                    phi_457_ = 1f;
                }
                let _e378 = phi_457_;
                phi_458_ = _e378;
            } else {
                phi_458_ = 0f;
            }
            let _e380 = phi_458_;
            let _e393 = (param_2[0] - param_4[0]);
            let _e396 = (param_2[1] - param_4[1]);
            let _e399 = (param_2[2] - param_4[2]);
            let _e419 = ((((_e393 * param_3[0]) + (_e396 * param_3[1])) + (_e399 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_506_ = _e419;
                } else {
                    phi_506_ = 1f;
                }
                let _e423 = phi_506_;
                phi_507_ = _e423;
            } else {
                phi_507_ = 0f;
            }
            let _e425 = phi_507_;
            phi_649_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e299)), (param_2[1] - (param_3[1] * _e299)), (param_2[2] - (param_3[2] * _e299))), array<f32, 3>((param_2[0] - (param_4[0] * _e341)), (param_2[1] - (param_4[1] * _e341)), (param_2[2] - (param_4[2] * _e341))), array<f32, 3>((_e145 - (param_4[0] * _e380)), (_e148 - (param_4[1] * _e380)), (_e151 - (param_4[2] * _e380))), array<f32, 3>((_e393 - (param_3[0] * _e425)), (_e396 - (param_3[1] * _e425)), (_e399 - (param_3[2] * _e425))));
        } else {
            let _e155 = (param_4[0] - param_3[0]);
            let _e158 = (param_4[1] - param_3[1]);
            let _e161 = (param_4[2] - param_3[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_547_ = _e172;
                } else {
                    phi_547_ = 1f;
                }
                let _e176 = phi_547_;
                phi_548_ = _e176;
            } else {
                phi_548_ = 0f;
            }
            let _e178 = phi_548_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_587_ = _e208;
                } else {
                    phi_587_ = 1f;
                }
                let _e212 = phi_587_;
                phi_588_ = _e212;
            } else {
                phi_588_ = 0f;
            }
            let _e214 = phi_588_;
            let _e250 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_633_ = _e250;
                } else {
                    phi_633_ = 1f;
                }
                let _e254 = phi_633_;
                phi_634_ = _e254;
            } else {
                phi_634_ = 0f;
            }
            let _e256 = phi_634_;
            phi_649_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e214)), (param_2[1] - (param_3[1] * _e214)), (param_2[2] - (param_3[2] * _e214))), array<f32, 3>((param_2[0] - (param_4[0] * _e256)), (param_2[1] - (param_4[1] * _e256)), (param_2[2] - (param_4[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_649_;
        let _e441 = function_(_e438[0], _e438[1]);
        let _e443 = function_(_e441, _e438[2]);
        let _e445 = function_(_e443, _e438[3]);
        phi_657_ = _e445;
    } else {
        phi_657_ = _e140;
    }
    let _e447 = phi_657_;
    return _e447;
}

fn function_2(param_6: f32) -> array<u32, 2> {
    var phi_708_: array<u32, 2>;
    var phi_709_: array<u32, 2>;
    var phi_710_: bool;
    var phi_714_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_6);
    if (_e13 < 8388608u) {
        phi_709_ = array<u32, 2>();
        phi_710_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_708_ = array<u32, 2>();
        } else {
            phi_708_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_708_;
        phi_709_ = _e31;
        phi_710_ = _e17;
    }
    let _e33 = phi_709_;
    let _e35 = phi_710_;
    if _e35 {
        phi_714_ = array<u32, 2>(0u, 0u);
    } else {
        phi_714_ = _e33;
    }
    let _e37 = phi_714_;
    return _e37;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_31;
    var local_1: type_31;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_32, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_31;
    var local_10: type_31;
    var local_11: array<f32, 3>;
    var local_12: type_23;
    var phi_767_: u32;
    var phi_783_: u32;
    var phi_804_: u32;
    var phi_805_: u32;
    var phi_808_: type_9;
    var phi_809_: type_9;
    var phi_832_: type_9;
    var phi_996_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1013_: f32;
    var phi_1018_: f32;
    var phi_1024_: f32;
    var phi_1030_: f32;
    var phi_1035_: f32;
    var phi_1041_: f32;
    var phi_1046_: f32;
    var phi_1051_: f32;
    var phi_1058_: f32;
    var phi_1064_: f32;
    var phi_1069_: f32;
    var phi_1075_: f32;
    var phi_1080_: f32;
    var phi_1086_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1103_: f32;
    var phi_1108_: f32;
    var phi_1113_: f32;
    var phi_1120_: f32;
    var phi_1126_: f32;
    var phi_1131_: f32;
    var phi_1137_: f32;
    var phi_1142_: f32;
    var phi_1148_: f32;
    var phi_1154_: f32;
    var phi_1159_: f32;
    var phi_1165_: f32;
    var phi_1170_: f32;
    var phi_1175_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1193_: bool;
    var phi_1217_: u32;
    var phi_1228_: f32;
    var phi_1229_: f32;
    var phi_1260_: type_35;
    var phi_1261_: bool;
    var phi_1262_: type_35;
    var phi_1263_: bool;
    var phi_1264_: type_35;
    var phi_1265_: bool;
    var phi_1270_: type_35;
    var phi_1552_: f32;
    var phi_1559_: f32;
    var phi_1564_: f32;
    var phi_1571_: f32;
    var phi_1576_: f32;
    var phi_1589_: f32;
    var phi_1596_: f32;
    var phi_1601_: f32;
    var phi_1608_: f32;
    var phi_1613_: f32;
    var phi_1618_: f32;
    var phi_1635_: f32;
    var phi_1642_: f32;
    var phi_1647_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1673_: f32;
    var phi_1680_: f32;
    var phi_1685_: f32;
    var phi_1692_: f32;
    var phi_1697_: f32;
    var phi_1702_: f32;
    var phi_1719_: f32;
    var phi_1726_: f32;
    var phi_1731_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1757_: f32;
    var phi_1764_: f32;
    var phi_1769_: f32;
    var phi_1776_: f32;
    var phi_1781_: f32;
    var phi_1786_: f32;
    var phi_1817_: f32;
    var phi_1823_: f32;
    var phi_1830_: f32;
    var phi_1837_: f32;
    var phi_1843_: f32;
    var phi_1850_: f32;
    var phi_1856_: f32;
    var phi_1862_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1906_: f32;
    var phi_1911_: f32;
    var phi_1916_: f32;
    var phi_1921_: f32;
    var phi_1926_: f32;
    var phi_1931_: f32;
    var phi_1941_: f32;
    var phi_4632_: f32;
    var phi_4638_: f32;
    var phi_4643_: f32;
    var phi_4649_: f32;
    var phi_4655_: f32;
    var phi_4660_: f32;
    var phi_4665_: f32;
    var phi_4673_: bool;
    var phi_4678_: f32;
    var phi_4685_: f32;
    var phi_4725_: type_14;
    var phi_4728_: f32;
    var phi_4749_: bool;
    var phi_4755_: type_15;
    var phi_4726_: type_14;
    var phi_4769_: type_15;
    var phi_4729_: f32;
    var local_13: f32;
    var phi_4718_: f32;
    var phi_4782_: f32;
    var phi_4788_: f32;
    var phi_4813_: type_9;
    var phi_4816_: u32;
    var phi_4814_: type_9;
    var phi_4839_: type_9;
    var phi_4883_: u32;
    var phi_4884_: u32;
    var phi_4817_: u32;
    var phi_4885_: u32;
    var phi_4905_: type_9;
    var phi_4906_: type_9;
    var phi_4929_: type_9;
    var phi_4981_: f32;
    var phi_4988_: f32;
    var phi_4999_: bool;
    var phi_5000_: bool;
    var phi_5001_: bool;
    var phi_5002_: bool;
    var phi_5006_: bool;
    var phi_5017_: type_37;
    var phi_5018_: type_37;
    var phi_5019_: bool;
    var phi_5020_: type_37;
    var phi_5021_: bool;
    var phi_5032_: f32;
    var phi_5042_: type_9;
    var phi_5045_: f32;
    var phi_5047_: f32;
    var phi_5049_: f32;
    var phi_5043_: type_9;
    var phi_5072_: type_9;
    var phi_5097_: f32;
    var phi_5098_: f32;
    var phi_5124_: f32;
    var phi_5140_: f32;
    var phi_5147_: bool;
    var phi_5148_: bool;
    var phi_5149_: bool;
    var phi_5155_: f32;
    var phi_5156_: f32;
    var phi_5157_: bool;
    var phi_5046_: f32;
    var phi_5048_: f32;
    var phi_5050_: f32;
    var phi_5158_: f32;
    var phi_5159_: bool;
    var phi_5160_: bool;
    var local_14: bool;
    var phi_5164_: f32;
    var phi_5165_: f32;
    var phi_5173_: f32;
    var phi_5177_: type_9;
    var phi_5180_: f32;
    var phi_5178_: type_9;
    var phi_5203_: type_9;
    var phi_5233_: f32;
    var phi_5234_: bool;
    var phi_5235_: f32;
    var phi_5236_: bool;
    var phi_5237_: bool;
    var phi_5238_: bool;
    var phi_5239_: f32;
    var phi_5181_: f32;
    var phi_5240_: bool;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var phi_5243_: bool;
    var local_15: bool;
    var phi_5247_: bool;
    var phi_5248_: bool;
    var phi_5252_: bool;
    var phi_5256_: f32;
    var phi_5257_: f32;
    var phi_5259_: type_37;
    var phi_5288_: f32;
    var phi_5295_: f32;
    var phi_5300_: f32;
    var phi_5307_: f32;
    var phi_5312_: f32;
    var phi_5325_: f32;
    var phi_5332_: f32;
    var phi_5337_: f32;
    var phi_5344_: f32;
    var phi_5349_: f32;
    var phi_5354_: f32;
    var phi_5413_: f32;
    var phi_5419_: f32;
    var phi_5424_: f32;
    var phi_5430_: f32;
    var phi_5435_: f32;
    var phi_5447_: f32;
    var phi_5453_: f32;
    var phi_5458_: f32;
    var phi_5464_: f32;
    var phi_5469_: f32;
    var phi_5495_: f32;
    var phi_5502_: f32;
    var phi_5507_: f32;
    var phi_5514_: f32;
    var phi_5519_: f32;
    var phi_5532_: f32;
    var phi_5539_: f32;
    var phi_5544_: f32;
    var phi_5551_: f32;
    var phi_5556_: f32;
    var phi_5561_: f32;
    var phi_5620_: f32;
    var phi_5626_: f32;
    var phi_5631_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5654_: f32;
    var phi_5660_: f32;
    var phi_5665_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5702_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5739_: f32;
    var phi_5746_: f32;
    var phi_5751_: f32;
    var phi_5758_: f32;
    var phi_5763_: f32;
    var phi_5768_: f32;
    var phi_5827_: f32;
    var phi_5833_: f32;
    var phi_5838_: f32;
    var phi_5844_: f32;
    var phi_5849_: f32;
    var phi_5861_: f32;
    var phi_5867_: f32;
    var phi_5872_: f32;
    var phi_5878_: f32;
    var phi_5883_: f32;
    var phi_5932_: f32;
    var phi_5938_: f32;
    var phi_5966_: f32;
    var phi_5972_: f32;
    var phi_5977_: u32;
    var phi_5978_: u32;
    var phi_5948_: f32;
    var phi_5954_: f32;
    var phi_5959_: u32;
    var phi_5960_: u32;
    var phi_5979_: u32;
    var phi_5980_: u32;
    var phi_6049_: f32;
    var phi_6058_: f32;
    var phi_6193_: f32;
    var phi_6199_: f32;
    var phi_6206_: f32;
    var phi_6261_: type_9;
    var phi_6264_: bool;
    var phi_6262_: type_9;
    var phi_6287_: type_9;
    var phi_6314_: bool;
    var phi_6315_: bool;
    var phi_6265_: bool;
    var phi_6316_: bool;
    var phi_6317_: bool;
    var local_16: bool;
    var phi_6321_: bool;
    var local_17: bool;
    var phi_6328_: u32;
    var phi_6329_: u32;
    var phi_6330_: bool;
    var phi_6331_: u32;
    var phi_6332_: u32;
    var phi_6333_: bool;
    var phi_6337_: u32;
    var phi_6357_: bool;
    var phi_6358_: bool;
    var phi_6359_: bool;
    var phi_6507_: f32;
    var phi_6514_: f32;
    var phi_6519_: f32;
    var phi_6526_: f32;
    var phi_6531_: f32;
    var phi_6544_: f32;
    var phi_6551_: f32;
    var phi_6556_: f32;
    var phi_6563_: f32;
    var phi_6568_: f32;
    var phi_6573_: f32;
    var phi_6590_: f32;
    var phi_6597_: f32;
    var phi_6602_: f32;
    var phi_6609_: f32;
    var phi_6614_: f32;
    var phi_6628_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6647_: f32;
    var phi_6652_: f32;
    var phi_6657_: f32;
    var phi_6674_: f32;
    var phi_6681_: f32;
    var phi_6686_: f32;
    var phi_6693_: f32;
    var phi_6698_: f32;
    var phi_6712_: f32;
    var phi_6719_: f32;
    var phi_6724_: f32;
    var phi_6731_: f32;
    var phi_6736_: f32;
    var phi_6741_: f32;
    var phi_6780_: type_9;
    var phi_6783_: f32;
    var phi_6785_: f32;
    var phi_6787_: f32;
    var phi_6789_: bool;
    var phi_6791_: u32;
    var phi_6781_: type_9;
    var phi_6814_: type_9;
    var phi_6928_: f32;
    var phi_6934_: f32;
    var phi_6940_: f32;
    var phi_6942_: array<f32, 3>;
    var phi_6949_: f32;
    var phi_6956_: f32;
    var phi_6964_: f32;
    var phi_7008_: type_14;
    var phi_7011_: f32;
    var phi_7032_: bool;
    var phi_7038_: type_15;
    var phi_7009_: type_14;
    var phi_7052_: type_15;
    var phi_7012_: f32;
    var local_18: f32;
    var phi_7001_: f32;
    var phi_7065_: f32;
    var phi_7131_: f32;
    var phi_7137_: f32;
    var phi_7146_: f32;
    var phi_7152_: f32;
    var phi_7161_: f32;
    var phi_7167_: f32;
    var phi_7176_: f32;
    var phi_7182_: f32;
    var phi_7188_: type_31;
    var phi_7189_: bool;
    var phi_7190_: type_31;
    var phi_7191_: bool;
    var phi_7199_: type_31;
    var phi_7370_: bool;
    var phi_7371_: bool;
    var phi_7372_: bool;
    var phi_7373_: bool;
    var phi_7374_: bool;
    var phi_7375_: bool;
    var phi_7379_: bool;
    var phi_7676_: bool;
    var phi_7677_: bool;
    var phi_7678_: bool;
    var phi_7679_: bool;
    var phi_7680_: bool;
    var phi_7681_: bool;
    var phi_7685_: bool;
    var phi_7689_: bool;
    var phi_7700_: bool;
    var phi_7701_: bool;
    var phi_7775_: bool;
    var phi_7776_: bool;
    var phi_7796_: f32;
    var phi_7797_: bool;
    var phi_7798_: f32;
    var phi_7799_: bool;
    var phi_7800_: f32;
    var phi_7801_: bool;
    var phi_7802_: bool;
    var phi_7806_: f32;
    var phi_7807_: bool;
    var phi_7811_: f32;
    var phi_7843_: bool;
    var phi_7844_: bool;
    var phi_7864_: f32;
    var phi_7865_: bool;
    var phi_7866_: f32;
    var phi_7867_: bool;
    var phi_7868_: f32;
    var phi_7869_: bool;
    var phi_7870_: bool;
    var phi_7874_: f32;
    var phi_7875_: bool;
    var phi_7879_: f32;
    var phi_7884_: f32;
    var phi_7916_: bool;
    var phi_7917_: bool;
    var phi_7937_: f32;
    var phi_7938_: bool;
    var phi_7939_: f32;
    var phi_7940_: bool;
    var phi_7941_: f32;
    var phi_7942_: bool;
    var phi_7943_: bool;
    var phi_7947_: f32;
    var phi_7948_: bool;
    var phi_7952_: f32;
    var phi_7984_: bool;
    var phi_7985_: bool;
    var phi_8005_: f32;
    var phi_8006_: bool;
    var phi_8007_: f32;
    var phi_8008_: bool;
    var phi_8009_: f32;
    var phi_8010_: bool;
    var phi_8011_: bool;
    var phi_8015_: f32;
    var phi_8016_: bool;
    var phi_8020_: f32;
    var phi_8025_: f32;
    var phi_8030_: f32;
    var phi_8035_: f32;
    var phi_8045_: f32;
    var phi_8046_: f32;
    var phi_8047_: bool;
    var phi_8048_: f32;
    var phi_8049_: f32;
    var phi_8050_: bool;
    var phi_8051_: bool;
    var phi_8052_: bool;
    var phi_8053_: f32;
    var phi_8054_: f32;
    var phi_8055_: bool;
    var phi_8056_: bool;
    var phi_8057_: bool;
    var phi_8058_: bool;
    var phi_8059_: f32;
    var phi_8060_: f32;
    var phi_8061_: bool;
    var phi_8062_: bool;
    var phi_8063_: bool;
    var phi_8064_: bool;
    var phi_8150_: f32;
    var phi_8223_: f32;
    var phi_8228_: f32;
    var phi_8301_: f32;
    var phi_8374_: f32;
    var phi_8379_: f32;
    var phi_8395_: f32;
    var phi_8396_: f32;
    var phi_8397_: f32;
    var phi_8077_: bool;
    var phi_8399_: u32;
    var phi_8400_: f32;
    var phi_8401_: bool;
    var phi_8402_: bool;
    var phi_8403_: bool;
    var phi_8404_: u32;
    var phi_8405_: f32;
    var phi_8406_: f32;
    var phi_8407_: f32;
    var phi_8408_: bool;
    var phi_8409_: u32;
    var phi_8410_: bool;
    var phi_8411_: bool;
    var phi_8412_: bool;
    var phi_8413_: bool;
    var phi_8414_: bool;
    var phi_8423_: f32;
    var phi_8428_: f32;
    var phi_8437_: bool;
    var phi_8441_: bool;
    var phi_8442_: f32;
    var phi_8443_: f32;
    var phi_8444_: f32;
    var phi_8445_: bool;
    var phi_8446_: u32;
    var phi_8447_: bool;
    var phi_8448_: bool;
    var phi_8449_: bool;
    var phi_8450_: bool;
    var phi_8451_: bool;
    var phi_6784_: f32;
    var phi_6786_: f32;
    var phi_6788_: f32;
    var phi_6790_: bool;
    var phi_6792_: u32;
    var phi_8452_: f32;
    var phi_8453_: bool;
    var phi_8454_: bool;
    var phi_8455_: bool;
    var phi_8456_: bool;
    var phi_8457_: bool;
    var phi_8458_: bool;
    var local_19: bool;
    var phi_8462_: f32;
    var phi_8463_: bool;
    var phi_8464_: bool;
    var phi_8465_: bool;
    var phi_8466_: bool;
    var phi_8471_: type_28;
    var phi_8472_: bool;
    var phi_8473_: bool;
    var phi_8474_: bool;
    var local_20: f32;
    var phi_8479_: type_28;
    var phi_8480_: bool;
    var phi_8481_: bool;
    var phi_8486_: type_28;
    var phi_8487_: bool;
    var phi_8488_: bool;
    var phi_8493_: type_28;
    var phi_8494_: bool;
    var phi_8498_: type_28;
    var phi_8505_: bool;
    var phi_8506_: f32;
    var phi_8507_: bool;
    var phi_8508_: bool;
    var phi_8509_: bool;
    var phi_8510_: f32;
    var phi_8511_: bool;
    var phi_8512_: bool;
    var phi_8513_: bool;
    var phi_8514_: f32;
    var phi_8515_: bool;
    var phi_8516_: bool;
    var phi_8517_: bool;
    var phi_8518_: bool;
    var phi_8522_: bool;
    var phi_8523_: bool;
    var phi_8524_: bool;
    var phi_8525_: f32;
    var phi_8526_: type_37;
    var phi_8527_: bool;
    var phi_8528_: bool;
    var phi_8529_: bool;
    var phi_8530_: bool;
    var local_21: bool;
    var phi_8535_: type_28;
    var phi_8536_: bool;
    var phi_8537_: bool;
    var local_22: f32;
    var phi_8542_: type_28;
    var phi_8543_: bool;
    var local_23: type_37;
    var phi_8549_: type_28;
    var phi_8550_: bool;
    var phi_8554_: type_28;
    var phi_2094_: f32;
    var phi_2101_: f32;
    var phi_2106_: f32;
    var phi_2113_: f32;
    var phi_2118_: f32;
    var phi_2131_: f32;
    var phi_2138_: f32;
    var phi_2143_: f32;
    var phi_2150_: f32;
    var phi_2155_: f32;
    var phi_2160_: f32;
    var phi_2177_: f32;
    var phi_2184_: f32;
    var phi_2189_: f32;
    var phi_2196_: f32;
    var phi_2201_: f32;
    var phi_2215_: f32;
    var phi_2222_: f32;
    var phi_2227_: f32;
    var phi_2234_: f32;
    var phi_2239_: f32;
    var phi_2244_: f32;
    var phi_2261_: f32;
    var phi_2268_: f32;
    var phi_2273_: f32;
    var phi_2280_: f32;
    var phi_2285_: f32;
    var phi_2299_: f32;
    var phi_2306_: f32;
    var phi_2311_: f32;
    var phi_2318_: f32;
    var phi_2323_: f32;
    var phi_2328_: f32;
    var phi_2367_: type_9;
    var phi_2370_: f32;
    var phi_2372_: f32;
    var phi_2374_: f32;
    var phi_2376_: bool;
    var phi_2378_: u32;
    var phi_2368_: type_9;
    var phi_2401_: type_9;
    var phi_2515_: f32;
    var phi_2521_: f32;
    var phi_2527_: f32;
    var phi_2529_: array<f32, 3>;
    var phi_2536_: f32;
    var phi_2543_: f32;
    var phi_2551_: f32;
    var phi_2595_: type_14;
    var phi_2598_: f32;
    var phi_2619_: bool;
    var phi_2625_: type_15;
    var phi_2596_: type_14;
    var phi_2639_: type_15;
    var phi_2599_: f32;
    var local_24: f32;
    var phi_2588_: f32;
    var phi_2652_: f32;
    var phi_2718_: f32;
    var phi_2724_: f32;
    var phi_2733_: f32;
    var phi_2739_: f32;
    var phi_2748_: f32;
    var phi_2754_: f32;
    var phi_2763_: f32;
    var phi_2769_: f32;
    var phi_2775_: type_31;
    var phi_2776_: bool;
    var phi_2777_: type_31;
    var phi_2778_: bool;
    var phi_2786_: type_31;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2966_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3272_: bool;
    var phi_3276_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3362_: bool;
    var phi_3363_: bool;
    var phi_3383_: f32;
    var phi_3384_: bool;
    var phi_3385_: f32;
    var phi_3386_: bool;
    var phi_3387_: f32;
    var phi_3388_: bool;
    var phi_3389_: bool;
    var phi_3393_: f32;
    var phi_3394_: bool;
    var phi_3398_: f32;
    var phi_3430_: bool;
    var phi_3431_: bool;
    var phi_3451_: f32;
    var phi_3452_: bool;
    var phi_3453_: f32;
    var phi_3454_: bool;
    var phi_3455_: f32;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_3461_: f32;
    var phi_3462_: bool;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3524_: f32;
    var phi_3525_: bool;
    var phi_3526_: f32;
    var phi_3527_: bool;
    var phi_3528_: f32;
    var phi_3529_: bool;
    var phi_3530_: bool;
    var phi_3534_: f32;
    var phi_3535_: bool;
    var phi_3539_: f32;
    var phi_3571_: bool;
    var phi_3572_: bool;
    var phi_3592_: f32;
    var phi_3593_: bool;
    var phi_3594_: f32;
    var phi_3595_: bool;
    var phi_3596_: f32;
    var phi_3597_: bool;
    var phi_3598_: bool;
    var phi_3602_: f32;
    var phi_3603_: bool;
    var phi_3607_: f32;
    var phi_3612_: f32;
    var phi_3617_: f32;
    var phi_3622_: f32;
    var phi_3632_: f32;
    var phi_3633_: f32;
    var phi_3634_: bool;
    var phi_3635_: f32;
    var phi_3636_: f32;
    var phi_3637_: bool;
    var phi_3638_: bool;
    var phi_3639_: bool;
    var phi_3640_: f32;
    var phi_3641_: f32;
    var phi_3642_: bool;
    var phi_3643_: bool;
    var phi_3644_: bool;
    var phi_3645_: bool;
    var phi_3646_: f32;
    var phi_3647_: f32;
    var phi_3648_: bool;
    var phi_3649_: bool;
    var phi_3650_: bool;
    var phi_3651_: bool;
    var phi_3737_: f32;
    var phi_3810_: f32;
    var phi_3815_: f32;
    var phi_3888_: f32;
    var phi_3961_: f32;
    var phi_3966_: f32;
    var phi_3982_: f32;
    var phi_3983_: f32;
    var phi_3984_: f32;
    var phi_3664_: bool;
    var phi_3986_: u32;
    var phi_3987_: f32;
    var phi_3988_: bool;
    var phi_3989_: bool;
    var phi_3990_: bool;
    var phi_3991_: u32;
    var phi_3992_: f32;
    var phi_3993_: f32;
    var phi_3994_: f32;
    var phi_3995_: bool;
    var phi_3996_: u32;
    var phi_3997_: bool;
    var phi_3998_: bool;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var phi_4001_: bool;
    var phi_4010_: f32;
    var phi_4015_: f32;
    var phi_4024_: bool;
    var phi_4028_: bool;
    var phi_4029_: f32;
    var phi_4030_: f32;
    var phi_4031_: f32;
    var phi_4032_: bool;
    var phi_4033_: u32;
    var phi_4034_: bool;
    var phi_4035_: bool;
    var phi_4036_: bool;
    var phi_4037_: bool;
    var phi_4038_: bool;
    var phi_2371_: f32;
    var phi_2373_: f32;
    var phi_2375_: f32;
    var phi_2377_: bool;
    var phi_2379_: u32;
    var phi_4039_: f32;
    var phi_4040_: bool;
    var phi_4041_: bool;
    var phi_4042_: bool;
    var phi_4043_: bool;
    var phi_4044_: bool;
    var phi_4045_: bool;
    var local_25: bool;
    var phi_4049_: f32;
    var phi_4050_: bool;
    var phi_4051_: bool;
    var phi_4052_: bool;
    var phi_4053_: bool;
    var phi_4058_: type_28;
    var phi_4059_: bool;
    var phi_4060_: bool;
    var phi_4061_: bool;
    var local_26: f32;
    var phi_4066_: type_28;
    var phi_4067_: bool;
    var phi_4068_: bool;
    var phi_4073_: type_28;
    var phi_4074_: bool;
    var phi_4075_: bool;
    var phi_4080_: type_28;
    var phi_4081_: bool;
    var phi_4085_: type_28;
    var phi_4099_: type_9;
    var phi_4100_: type_9;
    var phi_4123_: type_9;
    var phi_4143_: f32;
    var phi_4273_: type_14;
    var phi_4276_: f32;
    var phi_4297_: bool;
    var phi_4303_: type_15;
    var phi_4274_: type_14;
    var phi_4317_: type_15;
    var phi_4277_: f32;
    var local_27: f32;
    var phi_4266_: f32;
    var phi_4330_: f32;
    var phi_4346_: f32;
    var phi_4353_: f32;
    var phi_4358_: f32;
    var phi_4365_: f32;
    var phi_4370_: f32;
    var phi_4383_: f32;
    var phi_4390_: f32;
    var phi_4395_: f32;
    var phi_4402_: f32;
    var phi_4407_: f32;
    var phi_4412_: f32;
    var phi_4429_: f32;
    var phi_4436_: f32;
    var phi_4441_: f32;
    var phi_4448_: f32;
    var phi_4453_: f32;
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
    var phi_4600_: bool;
    var phi_4601_: bool;
    var phi_4602_: bool;
    var local_28: bool;
    var phi_4607_: type_28;
    var phi_4608_: bool;
    var phi_4613_: type_28;
    var phi_4614_: bool;
    var phi_4616_: type_28;
    var phi_4617_: type_28;
    var phi_4618_: bool;
    var phi_4622_: type_28;
    var phi_8558_: type_28;
    var phi_8559_: type_28;
    var phi_8572_: type_38;
    var phi_8579_: bool;
    var phi_8603_: u32;
    var phi_8607_: type_20;
    var phi_8608_: bool;
    var phi_8609_: bool;
    var phi_8628_: u32;
    var phi_8691_: u32;
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
        phi_767_ = _e123;
    } else {
        phi_767_ = _e125;
    }
    let _e128 = phi_767_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_783_ = (_e129 + 1u);
    } else {
        phi_783_ = _e129;
    }
    let _e134 = phi_783_;
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
            phi_804_ = (_e138 + 1u);
        } else {
            phi_804_ = _e138;
        }
        let _e144 = phi_804_;
        phi_805_ = _e144;
    } else {
        phi_805_ = 0u;
    }
    let _e146 = phi_805_;
    phi_808_ = type_9(0u, _e146);
    loop {
        let _e149 = phi_808_;
        if (_e149.member < _e149.member_1) {
            phi_809_ = type_9((_e149.member + 1u), _e149.member_1);
            phi_832_ = type_9(1u, _e149.member);
        } else {
            phi_809_ = _e149;
            phi_832_ = type_9(0u, type_9().member_1);
        }
        let _e161 = phi_809_;
        let _e163 = phi_832_;
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
                    phi_996_ = -(_e228);
                } else {
                    phi_996_ = _e228;
                }
                let _e262 = phi_996_;
                if (_e229 < 0f) {
                    phi_1002_ = -(_e229);
                } else {
                    phi_1002_ = _e229;
                }
                let _e266 = phi_1002_;
                if (_e262 > _e266) {
                    phi_1007_ = _e262;
                } else {
                    phi_1007_ = _e266;
                }
                let _e269 = phi_1007_;
                if (_e230 < 0f) {
                    phi_1013_ = -(_e230);
                } else {
                    phi_1013_ = _e230;
                }
                let _e273 = phi_1013_;
                if (_e269 > _e273) {
                    phi_1018_ = _e269;
                } else {
                    phi_1018_ = _e273;
                }
                let _e276 = phi_1018_;
                if (_e232 < 0f) {
                    phi_1024_ = -(_e232);
                } else {
                    phi_1024_ = _e232;
                }
                let _e280 = phi_1024_;
                if (_e233 < 0f) {
                    phi_1030_ = -(_e233);
                } else {
                    phi_1030_ = _e233;
                }
                let _e284 = phi_1030_;
                if (_e280 > _e284) {
                    phi_1035_ = _e280;
                } else {
                    phi_1035_ = _e284;
                }
                let _e287 = phi_1035_;
                if (_e234 < 0f) {
                    phi_1041_ = -(_e234);
                } else {
                    phi_1041_ = _e234;
                }
                let _e291 = phi_1041_;
                if (_e287 > _e291) {
                    phi_1046_ = _e287;
                } else {
                    phi_1046_ = _e291;
                }
                let _e294 = phi_1046_;
                if (_e276 > _e294) {
                    phi_1051_ = _e276;
                } else {
                    phi_1051_ = _e294;
                }
                let _e297 = phi_1051_;
                let _e298 = (_e297 + _e255);
                if (_e237 < 0f) {
                    phi_1058_ = -(_e237);
                } else {
                    phi_1058_ = _e237;
                }
                let _e302 = phi_1058_;
                if (_e238 < 0f) {
                    phi_1064_ = -(_e238);
                } else {
                    phi_1064_ = _e238;
                }
                let _e306 = phi_1064_;
                if (_e302 > _e306) {
                    phi_1069_ = _e302;
                } else {
                    phi_1069_ = _e306;
                }
                let _e309 = phi_1069_;
                if (_e239 < 0f) {
                    phi_1075_ = -(_e239);
                } else {
                    phi_1075_ = _e239;
                }
                let _e313 = phi_1075_;
                if (_e309 > _e313) {
                    phi_1080_ = _e309;
                } else {
                    phi_1080_ = _e313;
                }
                let _e316 = phi_1080_;
                if (_e241 < 0f) {
                    phi_1086_ = -(_e241);
                } else {
                    phi_1086_ = _e241;
                }
                let _e320 = phi_1086_;
                if (_e242 < 0f) {
                    phi_1092_ = -(_e242);
                } else {
                    phi_1092_ = _e242;
                }
                let _e324 = phi_1092_;
                if (_e320 > _e324) {
                    phi_1097_ = _e320;
                } else {
                    phi_1097_ = _e324;
                }
                let _e327 = phi_1097_;
                if (_e243 < 0f) {
                    phi_1103_ = -(_e243);
                } else {
                    phi_1103_ = _e243;
                }
                let _e331 = phi_1103_;
                if (_e327 > _e331) {
                    phi_1108_ = _e327;
                } else {
                    phi_1108_ = _e331;
                }
                let _e334 = phi_1108_;
                if (_e316 > _e334) {
                    phi_1113_ = _e316;
                } else {
                    phi_1113_ = _e334;
                }
                let _e337 = phi_1113_;
                let _e338 = (_e337 + _e255);
                if (_e246 < 0f) {
                    phi_1120_ = -(_e246);
                } else {
                    phi_1120_ = _e246;
                }
                let _e342 = phi_1120_;
                if (_e247 < 0f) {
                    phi_1126_ = -(_e247);
                } else {
                    phi_1126_ = _e247;
                }
                let _e346 = phi_1126_;
                if (_e342 > _e346) {
                    phi_1131_ = _e342;
                } else {
                    phi_1131_ = _e346;
                }
                let _e349 = phi_1131_;
                if (_e248 < 0f) {
                    phi_1137_ = -(_e248);
                } else {
                    phi_1137_ = _e248;
                }
                let _e353 = phi_1137_;
                if (_e349 > _e353) {
                    phi_1142_ = _e349;
                } else {
                    phi_1142_ = _e353;
                }
                let _e356 = phi_1142_;
                if (_e250 < 0f) {
                    phi_1148_ = -(_e250);
                } else {
                    phi_1148_ = _e250;
                }
                let _e360 = phi_1148_;
                if (_e251 < 0f) {
                    phi_1154_ = -(_e251);
                } else {
                    phi_1154_ = _e251;
                }
                let _e364 = phi_1154_;
                if (_e360 > _e364) {
                    phi_1159_ = _e360;
                } else {
                    phi_1159_ = _e364;
                }
                let _e367 = phi_1159_;
                if (_e252 < 0f) {
                    phi_1165_ = -(_e252);
                } else {
                    phi_1165_ = _e252;
                }
                let _e371 = phi_1165_;
                if (_e367 > _e371) {
                    phi_1170_ = _e367;
                } else {
                    phi_1170_ = _e371;
                }
                let _e374 = phi_1170_;
                if (_e356 > _e374) {
                    phi_1175_ = _e356;
                } else {
                    phi_1175_ = _e374;
                }
                let _e377 = phi_1175_;
                let _e378 = (_e377 + _e255);
                if (_e298 > _e338) {
                    phi_1181_ = _e298;
                } else {
                    phi_1181_ = _e338;
                }
                let _e381 = phi_1181_;
                if (_e381 > _e378) {
                    phi_1186_ = _e381;
                } else {
                    phi_1186_ = _e378;
                }
                let _e384 = phi_1186_;
                if (_e384 <= 65536f) {
                    phi_1193_ = (_e384 >= (1f / 65536f));
                } else {
                    phi_1193_ = false;
                }
                let _e389 = phi_1193_;
                if _e389 {
                    phi_1264_ = type_35();
                    phi_1265_ = true;
                } else {
                    if (_e384 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e384) & 2139095040u) != 2139095040u) {
                            let _e396 = (2130706432u - (bitcast<u32>(_e384) & 2139095040u));
                            if (_e396 > 8388608u) {
                                phi_1217_ = _e396;
                            } else {
                                phi_1217_ = 8388608u;
                            }
                            let _e399 = phi_1217_;
                            let _e400 = bitcast<f32>(_e399);
                            let _e401 = (_e258 * _e400);
                            if (_e258 > 0f) {
                                if (_e401 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_1228_ = _e401;
                                } else {
                                    phi_1228_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e405 = phi_1228_;
                                phi_1229_ = _e405;
                            } else {
                                phi_1229_ = _e401;
                            }
                            let _e407 = phi_1229_;
                            phi_1260_ = type_35(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e228 * _e400), (_e229 * _e400), (_e230 * _e400)), array<f32, 3>((_e232 * _e400), (_e233 * _e400), (_e234 * _e400))), array<array<f32, 3>, 2>(array<f32, 3>((_e237 * _e400), (_e238 * _e400), (_e239 * _e400)), array<f32, 3>((_e241 * _e400), (_e242 * _e400), (_e243 * _e400))), array<array<f32, 3>, 2>(array<f32, 3>((_e246 * _e400), (_e247 * _e400), (_e248 * _e400)), array<f32, 3>((_e250 * _e400), (_e251 * _e400), (_e252 * _e400))), (_e255 * _e400)), _e407);
                            phi_1261_ = false;
                        } else {
                            phi_1260_ = type_35();
                            phi_1261_ = true;
                        }
                        let _e439 = phi_1260_;
                        let _e441 = phi_1261_;
                        phi_1262_ = _e439;
                        phi_1263_ = _e441;
                    } else {
                        phi_1262_ = type_35();
                        phi_1263_ = true;
                    }
                    let _e443 = phi_1262_;
                    let _e445 = phi_1263_;
                    phi_1264_ = _e443;
                    phi_1265_ = _e445;
                }
                let _e447 = phi_1264_;
                let _e449 = phi_1265_;
                if _e449 {
                    phi_1270_ = type_35(type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e228, _e229, _e230), array<f32, 3>(_e232, _e233, _e234)), array<array<f32, 3>, 2>(array<f32, 3>(_e237, _e238, _e239), array<f32, 3>(_e241, _e242, _e243)), array<array<f32, 3>, 2>(array<f32, 3>(_e246, _e247, _e248), array<f32, 3>(_e250, _e251, _e252)), _e255), _e258);
                } else {
                    phi_1270_ = _e447;
                }
                let _e452 = phi_1270_;
                local_12 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member[0][0], _e452.member.member[0][1], _e452.member.member[0][2]), array<f32, 3>(_e452.member.member[1][0], _e452.member.member[1][1], _e452.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member_1[0][0], _e452.member.member_1[0][1], _e452.member.member_1[0][2]), array<f32, 3>(_e452.member.member_1[1][0], _e452.member.member_1[1][1], _e452.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e452.member.member_2[0][0], _e452.member.member_2[0][1], _e452.member.member_2[0][2]), array<f32, 3>(_e452.member.member_2[1][0], _e452.member.member_2[1][1], _e452.member.member_2[1][2])), _e452.member.member_3);
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
                    phi_1552_ = -(_e650[0]);
                } else {
                    phi_1552_ = _e650[0];
                }
                let _e657 = phi_1552_;
                if (_e650[1] < 0f) {
                    phi_1559_ = -(_e650[1]);
                } else {
                    phi_1559_ = _e650[1];
                }
                let _e661 = phi_1559_;
                if (_e657 > _e661) {
                    phi_1564_ = _e657;
                } else {
                    phi_1564_ = _e661;
                }
                let _e664 = phi_1564_;
                if (_e650[2] < 0f) {
                    phi_1571_ = -(_e650[2]);
                } else {
                    phi_1571_ = _e650[2];
                }
                let _e668 = phi_1571_;
                if (_e664 > _e668) {
                    phi_1576_ = _e664;
                } else {
                    phi_1576_ = _e668;
                }
                let _e671 = phi_1576_;
                let _e674 = local_12.member[1u];
                if (_e674[0] < 0f) {
                    phi_1589_ = -(_e674[0]);
                } else {
                    phi_1589_ = _e674[0];
                }
                let _e681 = phi_1589_;
                if (_e674[1] < 0f) {
                    phi_1596_ = -(_e674[1]);
                } else {
                    phi_1596_ = _e674[1];
                }
                let _e685 = phi_1596_;
                if (_e681 > _e685) {
                    phi_1601_ = _e681;
                } else {
                    phi_1601_ = _e685;
                }
                let _e688 = phi_1601_;
                if (_e674[2] < 0f) {
                    phi_1608_ = -(_e674[2]);
                } else {
                    phi_1608_ = _e674[2];
                }
                let _e692 = phi_1608_;
                if (_e688 > _e692) {
                    phi_1613_ = _e688;
                } else {
                    phi_1613_ = _e692;
                }
                let _e695 = phi_1613_;
                if (_e671 > _e695) {
                    phi_1618_ = _e671;
                } else {
                    phi_1618_ = _e695;
                }
                let _e698 = phi_1618_;
                let _e700 = local_12.member_3;
                let _e701 = (_e698 + _e700);
                let _e704 = local_12.member_1[0u];
                if (_e704[0] < 0f) {
                    phi_1635_ = -(_e704[0]);
                } else {
                    phi_1635_ = _e704[0];
                }
                let _e711 = phi_1635_;
                if (_e704[1] < 0f) {
                    phi_1642_ = -(_e704[1]);
                } else {
                    phi_1642_ = _e704[1];
                }
                let _e715 = phi_1642_;
                if (_e711 > _e715) {
                    phi_1647_ = _e711;
                } else {
                    phi_1647_ = _e715;
                }
                let _e718 = phi_1647_;
                if (_e704[2] < 0f) {
                    phi_1654_ = -(_e704[2]);
                } else {
                    phi_1654_ = _e704[2];
                }
                let _e722 = phi_1654_;
                if (_e718 > _e722) {
                    phi_1659_ = _e718;
                } else {
                    phi_1659_ = _e722;
                }
                let _e725 = phi_1659_;
                let _e728 = local_12.member_1[1u];
                if (_e728[0] < 0f) {
                    phi_1673_ = -(_e728[0]);
                } else {
                    phi_1673_ = _e728[0];
                }
                let _e735 = phi_1673_;
                if (_e728[1] < 0f) {
                    phi_1680_ = -(_e728[1]);
                } else {
                    phi_1680_ = _e728[1];
                }
                let _e739 = phi_1680_;
                if (_e735 > _e739) {
                    phi_1685_ = _e735;
                } else {
                    phi_1685_ = _e739;
                }
                let _e742 = phi_1685_;
                if (_e728[2] < 0f) {
                    phi_1692_ = -(_e728[2]);
                } else {
                    phi_1692_ = _e728[2];
                }
                let _e746 = phi_1692_;
                if (_e742 > _e746) {
                    phi_1697_ = _e742;
                } else {
                    phi_1697_ = _e746;
                }
                let _e749 = phi_1697_;
                if (_e725 > _e749) {
                    phi_1702_ = _e725;
                } else {
                    phi_1702_ = _e749;
                }
                let _e752 = phi_1702_;
                let _e754 = local_12.member_3;
                let _e755 = (_e752 + _e754);
                let _e758 = local_12.member_2[0u];
                if (_e758[0] < 0f) {
                    phi_1719_ = -(_e758[0]);
                } else {
                    phi_1719_ = _e758[0];
                }
                let _e765 = phi_1719_;
                if (_e758[1] < 0f) {
                    phi_1726_ = -(_e758[1]);
                } else {
                    phi_1726_ = _e758[1];
                }
                let _e769 = phi_1726_;
                if (_e765 > _e769) {
                    phi_1731_ = _e765;
                } else {
                    phi_1731_ = _e769;
                }
                let _e772 = phi_1731_;
                if (_e758[2] < 0f) {
                    phi_1738_ = -(_e758[2]);
                } else {
                    phi_1738_ = _e758[2];
                }
                let _e776 = phi_1738_;
                if (_e772 > _e776) {
                    phi_1743_ = _e772;
                } else {
                    phi_1743_ = _e776;
                }
                let _e779 = phi_1743_;
                let _e782 = local_12.member_2[1u];
                if (_e782[0] < 0f) {
                    phi_1757_ = -(_e782[0]);
                } else {
                    phi_1757_ = _e782[0];
                }
                let _e789 = phi_1757_;
                if (_e782[1] < 0f) {
                    phi_1764_ = -(_e782[1]);
                } else {
                    phi_1764_ = _e782[1];
                }
                let _e793 = phi_1764_;
                if (_e789 > _e793) {
                    phi_1769_ = _e789;
                } else {
                    phi_1769_ = _e793;
                }
                let _e796 = phi_1769_;
                if (_e782[2] < 0f) {
                    phi_1776_ = -(_e782[2]);
                } else {
                    phi_1776_ = _e782[2];
                }
                let _e800 = phi_1776_;
                if (_e796 > _e800) {
                    phi_1781_ = _e796;
                } else {
                    phi_1781_ = _e800;
                }
                let _e803 = phi_1781_;
                if (_e779 > _e803) {
                    phi_1786_ = _e779;
                } else {
                    phi_1786_ = _e803;
                }
                let _e806 = phi_1786_;
                let _e808 = local_12.member_3;
                let _e809 = (_e806 + _e808);
                let _e811 = ((_e755 * 8f) * _e809);
                let _e818 = local_12.member_3;
                if (_e507 < 0f) {
                    phi_1817_ = -(_e507);
                } else {
                    phi_1817_ = _e507;
                }
                let _e835 = phi_1817_;
                if (_e510 < 0f) {
                    phi_1823_ = -(_e510);
                } else {
                    phi_1823_ = _e510;
                }
                let _e839 = phi_1823_;
                if (_e513 < 0f) {
                    phi_1830_ = -(_e513);
                } else {
                    phi_1830_ = _e513;
                }
                let _e844 = phi_1830_;
                let _e845 = ((_e835 + _e839) + _e844);
                if (_e528 < 0f) {
                    phi_1837_ = -(_e528);
                } else {
                    phi_1837_ = _e528;
                }
                let _e849 = phi_1837_;
                if (_e531 < 0f) {
                    phi_1843_ = -(_e531);
                } else {
                    phi_1843_ = _e531;
                }
                let _e853 = phi_1843_;
                if (_e534 < 0f) {
                    phi_1850_ = -(_e534);
                } else {
                    phi_1850_ = _e534;
                }
                let _e858 = phi_1850_;
                let _e859 = ((_e849 + _e853) + _e858);
                if (_e845 > _e859) {
                    phi_1856_ = _e845;
                } else {
                    phi_1856_ = _e859;
                }
                let _e862 = phi_1856_;
                if (_e577 < 0f) {
                    phi_1862_ = -(_e577);
                } else {
                    phi_1862_ = _e577;
                }
                let _e866 = phi_1862_;
                if (_e578 < 0f) {
                    phi_1868_ = -(_e578);
                } else {
                    phi_1868_ = _e578;
                }
                let _e870 = phi_1868_;
                if (_e579 < 0f) {
                    phi_1875_ = -(_e579);
                } else {
                    phi_1875_ = _e579;
                }
                let _e875 = phi_1875_;
                let _e877 = (((_e866 + _e870) + _e875) * 0.5f);
                if (_e862 > _e877) {
                    phi_1882_ = _e862;
                } else {
                    phi_1882_ = _e877;
                }
                let _e880 = phi_1882_;
                let _e885 = local_12.member_3;
                let _e897 = (((((_e701 * 8f) * _e811) * (0.000000059604645f * (524f / 64f))) + ((_e818 * 19f) * ((_e701 * (_e755 + _e809)) + (_e755 * _e809)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e701) * ((1f + _e755) * (1f + _e809)))));
                let _e898 = (_e590 * 3f);
                let _e899 = (_e647 * 3f);
                if (_e898 < _e899) {
                    phi_1906_ = _e898;
                } else {
                    phi_1906_ = _e899;
                }
                let _e902 = phi_1906_;
                if (_e613 < _e636) {
                    phi_1911_ = _e613;
                } else {
                    phi_1911_ = _e636;
                }
                let _e905 = phi_1911_;
                if (_e902 < _e905) {
                    phi_1916_ = _e902;
                } else {
                    phi_1916_ = _e905;
                }
                let _e908 = phi_1916_;
                if (_e898 > _e899) {
                    phi_1921_ = _e898;
                } else {
                    phi_1921_ = _e899;
                }
                let _e911 = phi_1921_;
                if (_e613 > _e636) {
                    phi_1926_ = _e613;
                } else {
                    phi_1926_ = _e636;
                }
                let _e914 = phi_1926_;
                if (_e911 > _e914) {
                    phi_1931_ = _e911;
                } else {
                    phi_1931_ = _e914;
                }
                let _e917 = phi_1931_;
                let _e922 = -(_e917);
                if (_e908 > _e922) {
                    phi_1941_ = _e908;
                } else {
                    phi_1941_ = _e922;
                }
                let _e925 = phi_1941_;
                if ((_e925 - (_e897 + ((_e452.member_1 * (((_e880 + (_e811 * (0.000000059604645f * 8f))) + ((_e885 * 6f) * (_e755 + _e809))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e755) * (1f + _e809))))) * (3f * 1.0001f)))) > 0f) {
                    phi_8559_ = type_28(0u, type_28().member_1);
                } else {
                    if (_e452.member_1 > 0f) {
                        let _e3523 = local_12.member[0u];
                        let _e3529 = local_12.member_1[0u];
                        let _e3535 = local_12.member_2[0u];
                        let _e3547 = local_12.member[1u];
                        let _e3553 = local_12.member_1[1u];
                        let _e3559 = local_12.member_2[1u];
                        let _e3571 = local_12.member[0u];
                        if (_e3571[0] < 0f) {
                            phi_2094_ = -(_e3571[0]);
                        } else {
                            phi_2094_ = _e3571[0];
                        }
                        let _e3578 = phi_2094_;
                        if (_e3571[1] < 0f) {
                            phi_2101_ = -(_e3571[1]);
                        } else {
                            phi_2101_ = _e3571[1];
                        }
                        let _e3582 = phi_2101_;
                        if (_e3578 > _e3582) {
                            phi_2106_ = _e3578;
                        } else {
                            phi_2106_ = _e3582;
                        }
                        let _e3585 = phi_2106_;
                        if (_e3571[2] < 0f) {
                            phi_2113_ = -(_e3571[2]);
                        } else {
                            phi_2113_ = _e3571[2];
                        }
                        let _e3589 = phi_2113_;
                        if (_e3585 > _e3589) {
                            phi_2118_ = _e3585;
                        } else {
                            phi_2118_ = _e3589;
                        }
                        let _e3592 = phi_2118_;
                        let _e3595 = local_12.member[1u];
                        if (_e3595[0] < 0f) {
                            phi_2131_ = -(_e3595[0]);
                        } else {
                            phi_2131_ = _e3595[0];
                        }
                        let _e3602 = phi_2131_;
                        if (_e3595[1] < 0f) {
                            phi_2138_ = -(_e3595[1]);
                        } else {
                            phi_2138_ = _e3595[1];
                        }
                        let _e3606 = phi_2138_;
                        if (_e3602 > _e3606) {
                            phi_2143_ = _e3602;
                        } else {
                            phi_2143_ = _e3606;
                        }
                        let _e3609 = phi_2143_;
                        if (_e3595[2] < 0f) {
                            phi_2150_ = -(_e3595[2]);
                        } else {
                            phi_2150_ = _e3595[2];
                        }
                        let _e3613 = phi_2150_;
                        if (_e3609 > _e3613) {
                            phi_2155_ = _e3609;
                        } else {
                            phi_2155_ = _e3613;
                        }
                        let _e3616 = phi_2155_;
                        if (_e3592 > _e3616) {
                            phi_2160_ = _e3592;
                        } else {
                            phi_2160_ = _e3616;
                        }
                        let _e3619 = phi_2160_;
                        let _e3621 = local_12.member_3;
                        let _e3625 = local_12.member_1[0u];
                        if (_e3625[0] < 0f) {
                            phi_2177_ = -(_e3625[0]);
                        } else {
                            phi_2177_ = _e3625[0];
                        }
                        let _e3632 = phi_2177_;
                        if (_e3625[1] < 0f) {
                            phi_2184_ = -(_e3625[1]);
                        } else {
                            phi_2184_ = _e3625[1];
                        }
                        let _e3636 = phi_2184_;
                        if (_e3632 > _e3636) {
                            phi_2189_ = _e3632;
                        } else {
                            phi_2189_ = _e3636;
                        }
                        let _e3639 = phi_2189_;
                        if (_e3625[2] < 0f) {
                            phi_2196_ = -(_e3625[2]);
                        } else {
                            phi_2196_ = _e3625[2];
                        }
                        let _e3643 = phi_2196_;
                        if (_e3639 > _e3643) {
                            phi_2201_ = _e3639;
                        } else {
                            phi_2201_ = _e3643;
                        }
                        let _e3646 = phi_2201_;
                        let _e3649 = local_12.member_1[1u];
                        if (_e3649[0] < 0f) {
                            phi_2215_ = -(_e3649[0]);
                        } else {
                            phi_2215_ = _e3649[0];
                        }
                        let _e3656 = phi_2215_;
                        if (_e3649[1] < 0f) {
                            phi_2222_ = -(_e3649[1]);
                        } else {
                            phi_2222_ = _e3649[1];
                        }
                        let _e3660 = phi_2222_;
                        if (_e3656 > _e3660) {
                            phi_2227_ = _e3656;
                        } else {
                            phi_2227_ = _e3660;
                        }
                        let _e3663 = phi_2227_;
                        if (_e3649[2] < 0f) {
                            phi_2234_ = -(_e3649[2]);
                        } else {
                            phi_2234_ = _e3649[2];
                        }
                        let _e3667 = phi_2234_;
                        if (_e3663 > _e3667) {
                            phi_2239_ = _e3663;
                        } else {
                            phi_2239_ = _e3667;
                        }
                        let _e3670 = phi_2239_;
                        if (_e3646 > _e3670) {
                            phi_2244_ = _e3646;
                        } else {
                            phi_2244_ = _e3670;
                        }
                        let _e3673 = phi_2244_;
                        let _e3675 = local_12.member_3;
                        let _e3679 = local_12.member_2[0u];
                        if (_e3679[0] < 0f) {
                            phi_2261_ = -(_e3679[0]);
                        } else {
                            phi_2261_ = _e3679[0];
                        }
                        let _e3686 = phi_2261_;
                        if (_e3679[1] < 0f) {
                            phi_2268_ = -(_e3679[1]);
                        } else {
                            phi_2268_ = _e3679[1];
                        }
                        let _e3690 = phi_2268_;
                        if (_e3686 > _e3690) {
                            phi_2273_ = _e3686;
                        } else {
                            phi_2273_ = _e3690;
                        }
                        let _e3693 = phi_2273_;
                        if (_e3679[2] < 0f) {
                            phi_2280_ = -(_e3679[2]);
                        } else {
                            phi_2280_ = _e3679[2];
                        }
                        let _e3697 = phi_2280_;
                        if (_e3693 > _e3697) {
                            phi_2285_ = _e3693;
                        } else {
                            phi_2285_ = _e3697;
                        }
                        let _e3700 = phi_2285_;
                        let _e3703 = local_12.member_2[1u];
                        if (_e3703[0] < 0f) {
                            phi_2299_ = -(_e3703[0]);
                        } else {
                            phi_2299_ = _e3703[0];
                        }
                        let _e3710 = phi_2299_;
                        if (_e3703[1] < 0f) {
                            phi_2306_ = -(_e3703[1]);
                        } else {
                            phi_2306_ = _e3703[1];
                        }
                        let _e3714 = phi_2306_;
                        if (_e3710 > _e3714) {
                            phi_2311_ = _e3710;
                        } else {
                            phi_2311_ = _e3714;
                        }
                        let _e3717 = phi_2311_;
                        if (_e3703[2] < 0f) {
                            phi_2318_ = -(_e3703[2]);
                        } else {
                            phi_2318_ = _e3703[2];
                        }
                        let _e3721 = phi_2318_;
                        if (_e3717 > _e3721) {
                            phi_2323_ = _e3717;
                        } else {
                            phi_2323_ = _e3721;
                        }
                        let _e3724 = phi_2323_;
                        if (_e3700 > _e3724) {
                            phi_2328_ = _e3700;
                        } else {
                            phi_2328_ = _e3724;
                        }
                        let _e3727 = phi_2328_;
                        let _e3729 = local_12.member_3;
                        let _e3736 = local_12.member_3;
                        local_9 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_2367_ = type_9(0u, 96u);
                        phi_2370_ = 0f;
                        phi_2372_ = 0f;
                        phi_2374_ = 0f;
                        phi_2376_ = false;
                        phi_2378_ = 0u;
                        loop {
                            let _e3742 = phi_2367_;
                            let _e3744 = phi_2370_;
                            let _e3746 = phi_2372_;
                            let _e3748 = phi_2374_;
                            let _e3750 = phi_2376_;
                            let _e3752 = phi_2378_;
                            local_44 = _e3746;
                            local_26 = _e3744;
                            if (_e3742.member < _e3742.member_1) {
                                phi_2368_ = type_9((_e3742.member + 1u), _e3742.member_1);
                                phi_2401_ = type_9(1u, _e3742.member);
                            } else {
                                phi_2368_ = _e3742;
                                phi_2401_ = type_9(0u, type_9().member_1);
                            }
                            let _e3764 = phi_2368_;
                            let _e3766 = phi_2401_;
                            if (bitcast<i32>(_e3766.member) != 0i) {
                                let _e3772 = local_12.member[0u];
                                let _e3778 = local_12.member[1u];
                                let _e3794 = local_12.member_1[0u];
                                let _e3800 = local_12.member_1[1u];
                                let _e3816 = local_12.member_2[0u];
                                let _e3822 = local_12.member_2[1u];
                                let _e3836 = function_1(array<f32, 3>((_e3772[0] + ((_e3778[0] - _e3772[0]) * _e3744)), (_e3772[1] + ((_e3778[1] - _e3772[1]) * _e3744)), (_e3772[2] + ((_e3778[2] - _e3772[2]) * _e3744))), array<f32, 3>((_e3794[0] + ((_e3800[0] - _e3794[0]) * _e3744)), (_e3794[1] + ((_e3800[1] - _e3794[1]) * _e3744)), (_e3794[2] + ((_e3800[2] - _e3794[2]) * _e3744))), array<f32, 3>((_e3816[0] + ((_e3822[0] - _e3816[0]) * _e3744)), (_e3816[1] + ((_e3822[1] - _e3816[1]) * _e3744)), (_e3816[2] + ((_e3822[2] - _e3816[2]) * _e3744))), 0u);
                                if (_e3752 == 0u) {
                                    phi_2529_ = _e3836;
                                } else {
                                    if (_e3752 == 1u) {
                                        phi_2515_ = _e3836[0];
                                    } else {
                                        phi_2515_ = 0f;
                                    }
                                    let _e3841 = phi_2515_;
                                    if (_e3752 == 2u) {
                                        phi_2521_ = _e3836[1];
                                    } else {
                                        phi_2521_ = 0f;
                                    }
                                    let _e3845 = phi_2521_;
                                    if (_e3752 == 3u) {
                                        phi_2527_ = _e3836[2];
                                    } else {
                                        phi_2527_ = 0f;
                                    }
                                    let _e3849 = phi_2527_;
                                    phi_2529_ = array<f32, 3>(_e3841, _e3845, _e3849);
                                }
                                let _e3852 = phi_2529_;
                                if (_e3852[0] < 0f) {
                                    phi_2536_ = -(_e3852[0]);
                                } else {
                                    phi_2536_ = _e3852[0];
                                }
                                let _e3857 = phi_2536_;
                                if (_e3852[1] < 0f) {
                                    phi_2543_ = -(_e3852[1]);
                                } else {
                                    phi_2543_ = _e3852[1];
                                }
                                let _e3862 = phi_2543_;
                                if (_e3852[2] < 0f) {
                                    phi_2551_ = -(_e3852[2]);
                                } else {
                                    phi_2551_ = _e3852[2];
                                }
                                let _e3868 = phi_2551_;
                                let _e3869 = ((_e3857 + _e3862) + _e3868);
                                if (_e3869 > 0f) {
                                    if ((bitcast<u32>(_e3869) & 2139095040u) != 2139095040u) {
                                        let _e3874 = (1f / _e3869);
                                        let _e3876 = (_e3852[0] * _e3874);
                                        let _e3878 = (_e3852[1] * _e3874);
                                        let _e3880 = (_e3852[2] * _e3874);
                                        let _e3885 = (((_e3876 * _e3876) + (_e3878 * _e3878)) + (_e3880 * _e3880));
                                        if (_e3885 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3885 > 0f) {
                                                phi_2588_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2588_ = 0f;
                                            }
                                            let _e3938 = phi_2588_;
                                            phi_2652_ = _e3938;
                                        } else {
                                            phi_2595_ = type_14(0i, 5i);
                                            phi_2598_ = bitcast<f32>(((bitcast<u32>(_e3885) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3893 = phi_2595_;
                                                let _e3895 = phi_2598_;
                                                local_24 = _e3895;
                                                if (_e3893.member < _e3893.member_1) {
                                                    let _e3902 = (_e3893.member + 1i);
                                                    if ((false == (_e3902 > _e3893.member)) != false) {
                                                        phi_2619_ = true;
                                                    } else {
                                                        phi_2619_ = false;
                                                    }
                                                    let _e3907 = phi_2619_;
                                                    if _e3907 {
                                                        phi_2625_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2625_ = type_15(1u, _e3902);
                                                    }
                                                    let _e3912 = phi_2625_;
                                                    phi_2596_ = type_14(_e3912.member_1, _e3893.member_1);
                                                    phi_2639_ = type_15(1u, _e3893.member);
                                                } else {
                                                    phi_2596_ = _e3893;
                                                    phi_2639_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3918 = phi_2596_;
                                                let _e3920 = phi_2639_;
                                                let _e3923 = (bitcast<i32>(_e3920.member) != 0i);
                                                if _e3923 {
                                                    phi_2599_ = (0.5f * (_e3895 + (_e3885 / _e3895)));
                                                } else {
                                                    phi_2599_ = f32();
                                                }
                                                let _e3928 = phi_2599_;
                                                continue;
                                                continuing {
                                                    phi_2595_ = _e3918;
                                                    phi_2598_ = _e3928;
                                                    break if !(_e3923);
                                                }
                                            }
                                            let _e3933 = local_24;
                                            phi_2652_ = (_e3933 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3940 = phi_2652_;
                                        let _e3941 = (0.000000059604645f * 12f);
                                        let _e3946 = ((((((((_e3619 + _e3621) + (_e3673 + _e3675)) + (_e3727 + _e3729)) * (0.000000059604645f * 16f)) + (_e3736 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e452.member_1 * _e3940) * (1f + _e3941)));
                                        let _e3951 = (((_e3876 * _e3523[0]) + (_e3878 * _e3523[1])) + (_e3880 * _e3523[2]));
                                        let _e3956 = (((_e3876 * (_e3523[0] - _e3529[0])) + (_e3878 * (_e3523[1] - _e3529[1]))) + (_e3880 * (_e3523[2] - _e3529[2])));
                                        let _e3961 = (((_e3876 * (_e3523[0] - _e3535[0])) + (_e3878 * (_e3523[1] - _e3535[1]))) + (_e3880 * (_e3523[2] - _e3535[2])));
                                        let _e3966 = (((_e3876 * _e3523[0]) + (_e3878 * _e3523[1])) + (_e3880 * _e3523[2]));
                                        let _e3972 = (((_e3876 * _e3547[0]) + (_e3878 * _e3547[1])) + (_e3880 * _e3547[2]));
                                        let _e3977 = (((_e3876 * (_e3547[0] - _e3553[0])) + (_e3878 * (_e3547[1] - _e3553[1]))) + (_e3880 * (_e3547[2] - _e3553[2])));
                                        let _e3982 = (((_e3876 * (_e3547[0] - _e3559[0])) + (_e3878 * (_e3547[1] - _e3559[1]))) + (_e3880 * (_e3547[2] - _e3559[2])));
                                        let _e3987 = (((_e3876 * _e3547[0]) + (_e3878 * _e3547[1])) + (_e3880 * _e3547[2]));
                                        if (_e3951 < 0f) {
                                            phi_2718_ = -(_e3951);
                                        } else {
                                            phi_2718_ = _e3951;
                                        }
                                        let _e3992 = phi_2718_;
                                        if (_e3972 < 0f) {
                                            phi_2724_ = -(_e3972);
                                        } else {
                                            phi_2724_ = _e3972;
                                        }
                                        let _e3996 = phi_2724_;
                                        if (_e3956 < 0f) {
                                            phi_2733_ = -(_e3956);
                                        } else {
                                            phi_2733_ = _e3956;
                                        }
                                        let _e4003 = phi_2733_;
                                        if (_e3977 < 0f) {
                                            phi_2739_ = -(_e3977);
                                        } else {
                                            phi_2739_ = _e3977;
                                        }
                                        let _e4007 = phi_2739_;
                                        if (_e3961 < 0f) {
                                            phi_2748_ = -(_e3961);
                                        } else {
                                            phi_2748_ = _e3961;
                                        }
                                        let _e4014 = phi_2748_;
                                        if (_e3982 < 0f) {
                                            phi_2754_ = -(_e3982);
                                        } else {
                                            phi_2754_ = _e3982;
                                        }
                                        let _e4018 = phi_2754_;
                                        if (_e3966 < 0f) {
                                            phi_2763_ = -(_e3966);
                                        } else {
                                            phi_2763_ = _e3966;
                                        }
                                        let _e4025 = phi_2763_;
                                        if (_e3987 < 0f) {
                                            phi_2769_ = -(_e3987);
                                        } else {
                                            phi_2769_ = _e3987;
                                        }
                                        let _e4029 = phi_2769_;
                                        phi_2775_ = type_31(array<f32, 4>(_e3951, _e3956, _e3961, _e3966), array<f32, 4>(_e3972, _e3977, _e3982, _e3987), array<f32, 4>((_e3946 + ((_e3992 + _e3996) * _e3941)), (_e3946 + ((_e4003 + _e4007) * _e3941)), (_e3946 + ((_e4014 + _e4018) * _e3941)), (_e3946 + ((_e4025 + _e4029) * _e3941))));
                                        phi_2776_ = false;
                                    } else {
                                        phi_2775_ = type_31();
                                        phi_2776_ = true;
                                    }
                                    let _e4036 = phi_2775_;
                                    let _e4038 = phi_2776_;
                                    phi_2777_ = _e4036;
                                    phi_2778_ = _e4038;
                                } else {
                                    phi_2777_ = type_31();
                                    phi_2778_ = true;
                                }
                                let _e4040 = phi_2777_;
                                let _e4042 = phi_2778_;
                                if _e4042 {
                                    phi_2786_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2786_ = _e4040;
                                }
                                let _e4044 = phi_2786_;
                                local_10 = type_31(array<f32, 4>(_e4044.member[0], _e4044.member[1], _e4044.member[2], _e4044.member[3]), array<f32, 4>(_e4044.member_1[0], _e4044.member_1[1], _e4044.member_1[2], _e4044.member_1[3]), array<f32, 4>(_e4044.member_2[0], _e4044.member_2[1], _e4044.member_2[2], _e4044.member_2[3]));
                                let _e4064 = (_e3744 - _e3748);
                                let _e4068 = local_10.member[0u];
                                let _e4071 = local_10.member_1[0u];
                                let _e4074 = local_10.member[0u];
                                let _e4080 = local_10.member_2[0u];
                                if (((_e4068 + ((_e4071 - _e4074) * _e3744)) - _e4080) > 0f) {
                                    let _e4085 = local_10.member[1u];
                                    let _e4088 = local_10.member_1[1u];
                                    let _e4091 = local_10.member[1u];
                                    let _e4097 = local_10.member_2[1u];
                                    if (((_e4085 + ((_e4088 - _e4091) * _e3744)) - _e4097) > 0f) {
                                        let _e4102 = local_10.member[2u];
                                        let _e4105 = local_10.member_1[2u];
                                        let _e4108 = local_10.member[2u];
                                        let _e4114 = local_10.member_2[2u];
                                        if (((_e4102 + ((_e4105 - _e4108) * _e3744)) - _e4114) > 0f) {
                                            let _e4119 = local_10.member[3u];
                                            let _e4122 = local_10.member_1[3u];
                                            let _e4125 = local_10.member[3u];
                                            let _e4131 = local_10.member_2[3u];
                                            phi_2957_ = (((_e4119 + ((_e4122 - _e4125) * _e3744)) - _e4131) > 0f);
                                            phi_2958_ = false;
                                        } else {
                                            phi_2957_ = bool();
                                            phi_2958_ = true;
                                        }
                                        let _e4135 = phi_2957_;
                                        let _e4137 = phi_2958_;
                                        phi_2959_ = _e4135;
                                        phi_2960_ = _e4137;
                                    } else {
                                        phi_2959_ = bool();
                                        phi_2960_ = true;
                                    }
                                    let _e4139 = phi_2959_;
                                    let _e4141 = phi_2960_;
                                    phi_2961_ = _e4139;
                                    phi_2962_ = _e4141;
                                } else {
                                    phi_2961_ = bool();
                                    phi_2962_ = true;
                                }
                                let _e4143 = phi_2961_;
                                let _e4145 = phi_2962_;
                                if _e4145 {
                                    phi_2966_ = false;
                                } else {
                                    phi_2966_ = _e4143;
                                }
                                let _e4147 = phi_2966_;
                                if _e4147 {
                                    if (_e3744 <= _e3746) {
                                        phi_3276_ = true;
                                    } else {
                                        let _e4151 = local_9.member[0u];
                                        let _e4154 = local_9.member_1[0u];
                                        let _e4157 = local_9.member[0u];
                                        let _e4163 = local_9.member_2[0u];
                                        let _e4167 = local_10.member[0u];
                                        let _e4170 = local_10.member_1[0u];
                                        let _e4173 = local_10.member[0u];
                                        let _e4179 = local_10.member_2[0u];
                                        if ((((_e4151 + ((_e4154 - _e4157) * _e3744)) - _e4163) + ((_e4167 + ((_e4170 - _e4173) * _e3748)) - _e4179)) > 0f) {
                                            let _e4185 = local_9.member[1u];
                                            let _e4188 = local_9.member_1[1u];
                                            let _e4191 = local_9.member[1u];
                                            let _e4197 = local_9.member_2[1u];
                                            let _e4201 = local_10.member[1u];
                                            let _e4204 = local_10.member_1[1u];
                                            let _e4207 = local_10.member[1u];
                                            let _e4213 = local_10.member_2[1u];
                                            if ((((_e4185 + ((_e4188 - _e4191) * _e3744)) - _e4197) + ((_e4201 + ((_e4204 - _e4207) * _e3748)) - _e4213)) > 0f) {
                                                let _e4219 = local_9.member[2u];
                                                let _e4222 = local_9.member_1[2u];
                                                let _e4225 = local_9.member[2u];
                                                let _e4231 = local_9.member_2[2u];
                                                let _e4235 = local_10.member[2u];
                                                let _e4238 = local_10.member_1[2u];
                                                let _e4241 = local_10.member[2u];
                                                let _e4247 = local_10.member_2[2u];
                                                if ((((_e4219 + ((_e4222 - _e4225) * _e3744)) - _e4231) + ((_e4235 + ((_e4238 - _e4241) * _e3748)) - _e4247)) > 0f) {
                                                    let _e4253 = local_9.member[3u];
                                                    let _e4256 = local_9.member_1[3u];
                                                    let _e4259 = local_9.member[3u];
                                                    let _e4265 = local_9.member_2[3u];
                                                    let _e4269 = local_10.member[3u];
                                                    let _e4272 = local_10.member_1[3u];
                                                    let _e4275 = local_10.member[3u];
                                                    let _e4281 = local_10.member_2[3u];
                                                    phi_3263_ = ((((_e4253 + ((_e4256 - _e4259) * _e3744)) - _e4265) + ((_e4269 + ((_e4272 - _e4275) * _e3748)) - _e4281)) > 0f);
                                                    phi_3264_ = false;
                                                } else {
                                                    phi_3263_ = bool();
                                                    phi_3264_ = true;
                                                }
                                                let _e4286 = phi_3263_;
                                                let _e4288 = phi_3264_;
                                                phi_3265_ = _e4286;
                                                phi_3266_ = _e4288;
                                            } else {
                                                phi_3265_ = bool();
                                                phi_3266_ = true;
                                            }
                                            let _e4290 = phi_3265_;
                                            let _e4292 = phi_3266_;
                                            phi_3267_ = _e4290;
                                            phi_3268_ = _e4292;
                                        } else {
                                            phi_3267_ = bool();
                                            phi_3268_ = true;
                                        }
                                        let _e4294 = phi_3267_;
                                        let _e4296 = phi_3268_;
                                        if _e4296 {
                                            phi_3272_ = false;
                                        } else {
                                            phi_3272_ = _e4294;
                                        }
                                        let _e4298 = phi_3272_;
                                        phi_3276_ = _e4298;
                                    }
                                    let _e4300 = phi_3276_;
                                    if _e4300 {
                                        if _e3750 {
                                            if (_e3744 >= 1f) {
                                                phi_3287_ = false;
                                            } else {
                                                phi_3287_ = true;
                                            }
                                            let _e4303 = phi_3287_;
                                            phi_3288_ = _e4303;
                                        } else {
                                            phi_3288_ = true;
                                        }
                                        let _e4305 = phi_3288_;
                                        if _e4305 {
                                            local_9 = type_31(array<f32, 4>(_e4044.member[0], _e4044.member[1], _e4044.member[2], _e4044.member[3]), array<f32, 4>(_e4044.member_1[0], _e4044.member_1[1], _e4044.member_1[2], _e4044.member_1[3]), array<f32, 4>(_e4044.member_2[0], _e4044.member_2[1], _e4044.member_2[2], _e4044.member_2[3]));
                                            let _e4327 = local_9.member[0u];
                                            let _e4330 = local_9.member_1[0u];
                                            let _e4333 = local_9.member_2[0u];
                                            if (_e4327 > _e4333) {
                                                if (_e4330 > _e4333) {
                                                    phi_3362_ = false;
                                                } else {
                                                    phi_3362_ = true;
                                                }
                                                let _e4337 = phi_3362_;
                                                phi_3363_ = _e4337;
                                            } else {
                                                phi_3363_ = true;
                                            }
                                            let _e4339 = phi_3363_;
                                            if _e4339 {
                                                let _e4340 = (_e4330 >= _e4327);
                                                if _e4340 {
                                                    phi_3385_ = f32();
                                                    phi_3386_ = false;
                                                } else {
                                                    if ((_e4327 - _e4330) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3383_ = (((_e4327 - _e4333) / (_e4327 - _e4330)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3384_ = false;
                                                    } else {
                                                        phi_3383_ = f32();
                                                        phi_3384_ = true;
                                                    }
                                                    let _e4351 = phi_3383_;
                                                    let _e4353 = phi_3384_;
                                                    phi_3385_ = _e4351;
                                                    phi_3386_ = _e4353;
                                                }
                                                let _e4355 = phi_3385_;
                                                let _e4357 = phi_3386_;
                                                phi_3387_ = _e4355;
                                                phi_3388_ = _e4340;
                                                phi_3389_ = _e4357;
                                            } else {
                                                phi_3387_ = f32();
                                                phi_3388_ = true;
                                                phi_3389_ = false;
                                            }
                                            let _e4359 = phi_3387_;
                                            let _e4361 = phi_3388_;
                                            let _e4363 = phi_3389_;
                                            if _e4361 {
                                                phi_3393_ = 2f;
                                                phi_3394_ = true;
                                            } else {
                                                phi_3393_ = _e3744;
                                                phi_3394_ = _e4363;
                                            }
                                            let _e4365 = phi_3393_;
                                            let _e4367 = phi_3394_;
                                            if _e4367 {
                                                phi_3398_ = _e4365;
                                            } else {
                                                phi_3398_ = _e4359;
                                            }
                                            let _e4369 = phi_3398_;
                                            let _e4372 = local_9.member[1u];
                                            let _e4375 = local_9.member_1[1u];
                                            let _e4378 = local_9.member_2[1u];
                                            if (_e4372 > _e4378) {
                                                if (_e4375 > _e4378) {
                                                    phi_3430_ = false;
                                                } else {
                                                    phi_3430_ = true;
                                                }
                                                let _e4382 = phi_3430_;
                                                phi_3431_ = _e4382;
                                            } else {
                                                phi_3431_ = true;
                                            }
                                            let _e4384 = phi_3431_;
                                            if _e4384 {
                                                let _e4385 = (_e4375 >= _e4372);
                                                if _e4385 {
                                                    phi_3453_ = f32();
                                                    phi_3454_ = false;
                                                } else {
                                                    if ((_e4372 - _e4375) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3451_ = (((_e4372 - _e4378) / (_e4372 - _e4375)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3452_ = false;
                                                    } else {
                                                        phi_3451_ = f32();
                                                        phi_3452_ = true;
                                                    }
                                                    let _e4396 = phi_3451_;
                                                    let _e4398 = phi_3452_;
                                                    phi_3453_ = _e4396;
                                                    phi_3454_ = _e4398;
                                                }
                                                let _e4400 = phi_3453_;
                                                let _e4402 = phi_3454_;
                                                phi_3455_ = _e4400;
                                                phi_3456_ = _e4385;
                                                phi_3457_ = _e4402;
                                            } else {
                                                phi_3455_ = f32();
                                                phi_3456_ = true;
                                                phi_3457_ = false;
                                            }
                                            let _e4404 = phi_3455_;
                                            let _e4406 = phi_3456_;
                                            let _e4408 = phi_3457_;
                                            if _e4406 {
                                                phi_3461_ = 2f;
                                                phi_3462_ = true;
                                            } else {
                                                phi_3461_ = _e3744;
                                                phi_3462_ = _e4408;
                                            }
                                            let _e4410 = phi_3461_;
                                            let _e4412 = phi_3462_;
                                            if _e4412 {
                                                phi_3466_ = _e4410;
                                            } else {
                                                phi_3466_ = _e4404;
                                            }
                                            let _e4414 = phi_3466_;
                                            if (_e4369 < _e4414) {
                                                phi_3471_ = _e4369;
                                            } else {
                                                phi_3471_ = _e4414;
                                            }
                                            let _e4417 = phi_3471_;
                                            let _e4420 = local_9.member[2u];
                                            let _e4423 = local_9.member_1[2u];
                                            let _e4426 = local_9.member_2[2u];
                                            if (_e4420 > _e4426) {
                                                if (_e4423 > _e4426) {
                                                    phi_3503_ = false;
                                                } else {
                                                    phi_3503_ = true;
                                                }
                                                let _e4430 = phi_3503_;
                                                phi_3504_ = _e4430;
                                            } else {
                                                phi_3504_ = true;
                                            }
                                            let _e4432 = phi_3504_;
                                            if _e4432 {
                                                let _e4433 = (_e4423 >= _e4420);
                                                if _e4433 {
                                                    phi_3526_ = f32();
                                                    phi_3527_ = false;
                                                } else {
                                                    if ((_e4420 - _e4423) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3524_ = (((_e4420 - _e4426) / (_e4420 - _e4423)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3525_ = false;
                                                    } else {
                                                        phi_3524_ = f32();
                                                        phi_3525_ = true;
                                                    }
                                                    let _e4444 = phi_3524_;
                                                    let _e4446 = phi_3525_;
                                                    phi_3526_ = _e4444;
                                                    phi_3527_ = _e4446;
                                                }
                                                let _e4448 = phi_3526_;
                                                let _e4450 = phi_3527_;
                                                phi_3528_ = _e4448;
                                                phi_3529_ = _e4433;
                                                phi_3530_ = _e4450;
                                            } else {
                                                phi_3528_ = f32();
                                                phi_3529_ = true;
                                                phi_3530_ = false;
                                            }
                                            let _e4452 = phi_3528_;
                                            let _e4454 = phi_3529_;
                                            let _e4456 = phi_3530_;
                                            if _e4454 {
                                                phi_3534_ = 2f;
                                                phi_3535_ = true;
                                            } else {
                                                phi_3534_ = _e3744;
                                                phi_3535_ = _e4456;
                                            }
                                            let _e4458 = phi_3534_;
                                            let _e4460 = phi_3535_;
                                            if _e4460 {
                                                phi_3539_ = _e4458;
                                            } else {
                                                phi_3539_ = _e4452;
                                            }
                                            let _e4462 = phi_3539_;
                                            let _e4465 = local_9.member[3u];
                                            let _e4468 = local_9.member_1[3u];
                                            let _e4471 = local_9.member_2[3u];
                                            if (_e4465 > _e4471) {
                                                if (_e4468 > _e4471) {
                                                    phi_3571_ = false;
                                                } else {
                                                    phi_3571_ = true;
                                                }
                                                let _e4475 = phi_3571_;
                                                phi_3572_ = _e4475;
                                            } else {
                                                phi_3572_ = true;
                                            }
                                            let _e4477 = phi_3572_;
                                            if _e4477 {
                                                let _e4478 = (_e4468 >= _e4465);
                                                if _e4478 {
                                                    phi_3594_ = f32();
                                                    phi_3595_ = false;
                                                } else {
                                                    if ((_e4465 - _e4468) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3592_ = (((_e4465 - _e4471) / (_e4465 - _e4468)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3593_ = false;
                                                    } else {
                                                        phi_3592_ = f32();
                                                        phi_3593_ = true;
                                                    }
                                                    let _e4489 = phi_3592_;
                                                    let _e4491 = phi_3593_;
                                                    phi_3594_ = _e4489;
                                                    phi_3595_ = _e4491;
                                                }
                                                let _e4493 = phi_3594_;
                                                let _e4495 = phi_3595_;
                                                phi_3596_ = _e4493;
                                                phi_3597_ = _e4478;
                                                phi_3598_ = _e4495;
                                            } else {
                                                phi_3596_ = f32();
                                                phi_3597_ = true;
                                                phi_3598_ = false;
                                            }
                                            let _e4497 = phi_3596_;
                                            let _e4499 = phi_3597_;
                                            let _e4501 = phi_3598_;
                                            if _e4499 {
                                                phi_3602_ = 2f;
                                                phi_3603_ = true;
                                            } else {
                                                phi_3602_ = _e3744;
                                                phi_3603_ = _e4501;
                                            }
                                            let _e4503 = phi_3602_;
                                            let _e4505 = phi_3603_;
                                            if _e4505 {
                                                phi_3607_ = _e4503;
                                            } else {
                                                phi_3607_ = _e4497;
                                            }
                                            let _e4507 = phi_3607_;
                                            if (_e4462 < _e4507) {
                                                phi_3612_ = _e4462;
                                            } else {
                                                phi_3612_ = _e4507;
                                            }
                                            let _e4510 = phi_3612_;
                                            if (_e4417 < _e4510) {
                                                phi_3617_ = _e4417;
                                            } else {
                                                phi_3617_ = _e4510;
                                            }
                                            let _e4513 = phi_3617_;
                                            if (_e4513 > _e3744) {
                                                phi_3622_ = _e4513;
                                            } else {
                                                phi_3622_ = _e3744;
                                            }
                                            let _e4516 = phi_3622_;
                                            let _e4517 = (_e4516 > 1f);
                                            if _e4517 {
                                                phi_3633_ = f32();
                                                phi_3634_ = false;
                                            } else {
                                                if _e3750 {
                                                    phi_3632_ = (_e4064 + _e4064);
                                                } else {
                                                    phi_3632_ = (1f - _e3744);
                                                }
                                                let _e4521 = phi_3632_;
                                                phi_3633_ = _e4521;
                                                phi_3634_ = true;
                                            }
                                            let _e4523 = phi_3633_;
                                            let _e4525 = phi_3634_;
                                            phi_3635_ = _e4516;
                                            phi_3636_ = _e4523;
                                            phi_3637_ = _e4525;
                                            phi_3638_ = _e4517;
                                            phi_3639_ = false;
                                        } else {
                                            phi_3635_ = f32();
                                            phi_3636_ = f32();
                                            phi_3637_ = false;
                                            phi_3638_ = false;
                                            phi_3639_ = true;
                                        }
                                        let _e4527 = phi_3635_;
                                        let _e4529 = phi_3636_;
                                        let _e4531 = phi_3637_;
                                        let _e4533 = phi_3638_;
                                        let _e4535 = phi_3639_;
                                        phi_3640_ = _e4527;
                                        phi_3641_ = _e4529;
                                        phi_3642_ = false;
                                        phi_3643_ = _e4531;
                                        phi_3644_ = _e4533;
                                        phi_3645_ = _e4535;
                                    } else {
                                        phi_3640_ = f32();
                                        phi_3641_ = f32();
                                        phi_3642_ = true;
                                        phi_3643_ = false;
                                        phi_3644_ = false;
                                        phi_3645_ = false;
                                    }
                                    let _e4537 = phi_3640_;
                                    let _e4539 = phi_3641_;
                                    let _e4541 = phi_3642_;
                                    let _e4543 = phi_3643_;
                                    let _e4545 = phi_3644_;
                                    let _e4547 = phi_3645_;
                                    phi_3646_ = _e4537;
                                    phi_3647_ = _e4539;
                                    phi_3648_ = _e4541;
                                    phi_3649_ = _e4543;
                                    phi_3650_ = _e4545;
                                    phi_3651_ = _e4547;
                                } else {
                                    phi_3646_ = f32();
                                    phi_3647_ = f32();
                                    phi_3648_ = true;
                                    phi_3649_ = false;
                                    phi_3650_ = false;
                                    phi_3651_ = false;
                                }
                                let _e4549 = phi_3646_;
                                let _e4551 = phi_3647_;
                                let _e4553 = phi_3648_;
                                let _e4555 = phi_3649_;
                                let _e4557 = phi_3650_;
                                let _e4559 = phi_3651_;
                                if _e4553 {
                                    if (_e3744 <= _e3746) {
                                        let _e4720 = (_e3752 + 1u);
                                        let _e4721 = (_e4720 > 3u);
                                        if _e4721 {
                                            phi_3664_ = false;
                                        } else {
                                            phi_3664_ = true;
                                        }
                                        let _e4723 = phi_3664_;
                                        phi_3986_ = _e4720;
                                        phi_3987_ = f32();
                                        phi_3988_ = false;
                                        phi_3989_ = _e4723;
                                        phi_3990_ = _e4721;
                                    } else {
                                        let _e4563 = local_9.member[0u];
                                        let _e4566 = local_9.member_1[0u];
                                        let _e4569 = local_9.member[0u];
                                        let _e4575 = local_9.member_2[0u];
                                        let _e4576 = ((_e4563 + ((_e4566 - _e4569) * _e3748)) - _e4575);
                                        let _e4579 = local_9.member[1u];
                                        let _e4582 = local_9.member_1[1u];
                                        let _e4585 = local_9.member[1u];
                                        let _e4591 = local_9.member_2[1u];
                                        let _e4592 = ((_e4579 + ((_e4582 - _e4585) * _e3748)) - _e4591);
                                        if (_e4576 < _e4592) {
                                            phi_3737_ = _e4576;
                                        } else {
                                            phi_3737_ = _e4592;
                                        }
                                        let _e4595 = phi_3737_;
                                        let _e4598 = local_9.member[2u];
                                        let _e4601 = local_9.member_1[2u];
                                        let _e4604 = local_9.member[2u];
                                        let _e4610 = local_9.member_2[2u];
                                        let _e4611 = ((_e4598 + ((_e4601 - _e4604) * _e3748)) - _e4610);
                                        let _e4614 = local_9.member[3u];
                                        let _e4617 = local_9.member_1[3u];
                                        let _e4620 = local_9.member[3u];
                                        let _e4626 = local_9.member_2[3u];
                                        let _e4627 = ((_e4614 + ((_e4617 - _e4620) * _e3748)) - _e4626);
                                        if (_e4611 < _e4627) {
                                            phi_3810_ = _e4611;
                                        } else {
                                            phi_3810_ = _e4627;
                                        }
                                        let _e4630 = phi_3810_;
                                        if (_e4595 < _e4630) {
                                            phi_3815_ = _e4595;
                                        } else {
                                            phi_3815_ = _e4630;
                                        }
                                        let _e4633 = phi_3815_;
                                        let _e4636 = local_10.member[0u];
                                        let _e4639 = local_10.member_1[0u];
                                        let _e4642 = local_10.member[0u];
                                        let _e4648 = local_10.member_2[0u];
                                        let _e4649 = ((_e4636 + ((_e4639 - _e4642) * _e3744)) - _e4648);
                                        let _e4652 = local_10.member[1u];
                                        let _e4655 = local_10.member_1[1u];
                                        let _e4658 = local_10.member[1u];
                                        let _e4664 = local_10.member_2[1u];
                                        let _e4665 = ((_e4652 + ((_e4655 - _e4658) * _e3744)) - _e4664);
                                        if (_e4649 < _e4665) {
                                            phi_3888_ = _e4649;
                                        } else {
                                            phi_3888_ = _e4665;
                                        }
                                        let _e4668 = phi_3888_;
                                        let _e4671 = local_10.member[2u];
                                        let _e4674 = local_10.member_1[2u];
                                        let _e4677 = local_10.member[2u];
                                        let _e4683 = local_10.member_2[2u];
                                        let _e4684 = ((_e4671 + ((_e4674 - _e4677) * _e3744)) - _e4683);
                                        let _e4687 = local_10.member[3u];
                                        let _e4690 = local_10.member_1[3u];
                                        let _e4693 = local_10.member[3u];
                                        let _e4699 = local_10.member_2[3u];
                                        let _e4700 = ((_e4687 + ((_e4690 - _e4693) * _e3744)) - _e4699);
                                        if (_e4684 < _e4700) {
                                            phi_3961_ = _e4684;
                                        } else {
                                            phi_3961_ = _e4700;
                                        }
                                        let _e4703 = phi_3961_;
                                        if (_e4668 < _e4703) {
                                            phi_3966_ = _e4668;
                                        } else {
                                            phi_3966_ = _e4703;
                                        }
                                        let _e4706 = phi_3966_;
                                        if (_e4706 > 0f) {
                                            phi_3984_ = 0.5f;
                                        } else {
                                            let _e4710 = (0.95f * (_e4633 / (_e4633 - _e4706)));
                                            if (_e4710 > 0.0625f) {
                                                if (_e4710 < 0.9f) {
                                                    phi_3982_ = _e4710;
                                                } else {
                                                    phi_3982_ = 0.9f;
                                                }
                                                let _e4714 = phi_3982_;
                                                phi_3983_ = _e4714;
                                            } else {
                                                phi_3983_ = 0.0625f;
                                            }
                                            let _e4716 = phi_3983_;
                                            phi_3984_ = _e4716;
                                        }
                                        let _e4718 = phi_3984_;
                                        phi_3986_ = u32();
                                        phi_3987_ = (_e4064 * _e4718);
                                        phi_3988_ = true;
                                        phi_3989_ = false;
                                        phi_3990_ = false;
                                    }
                                    let _e4725 = phi_3986_;
                                    let _e4727 = phi_3987_;
                                    let _e4729 = phi_3988_;
                                    let _e4731 = phi_3989_;
                                    let _e4733 = phi_3990_;
                                    phi_3991_ = _e4725;
                                    phi_3992_ = _e3746;
                                    phi_3993_ = _e4727;
                                    phi_3994_ = _e3748;
                                    phi_3995_ = _e3750;
                                    phi_3996_ = _e3752;
                                    phi_3997_ = _e4729;
                                    phi_3998_ = _e4731;
                                    phi_3999_ = _e4733;
                                    phi_4000_ = false;
                                    phi_4001_ = false;
                                } else {
                                    phi_3991_ = u32();
                                    phi_3992_ = _e4549;
                                    phi_3993_ = _e4551;
                                    phi_3994_ = _e3744;
                                    phi_3995_ = true;
                                    phi_3996_ = 0u;
                                    phi_3997_ = _e4555;
                                    phi_3998_ = false;
                                    phi_3999_ = false;
                                    phi_4000_ = _e4557;
                                    phi_4001_ = _e4559;
                                }
                                let _e4735 = phi_3991_;
                                let _e4737 = phi_3992_;
                                let _e4739 = phi_3993_;
                                let _e4741 = phi_3994_;
                                let _e4743 = phi_3995_;
                                let _e4745 = phi_3996_;
                                let _e4747 = phi_3997_;
                                let _e4749 = phi_3998_;
                                let _e4751 = phi_3999_;
                                let _e4753 = phi_4000_;
                                let _e4755 = phi_4001_;
                                if _e4747 {
                                    let _e4756 = (_e4741 + _e4739);
                                    if (_e4756 > _e4737) {
                                        phi_4010_ = _e4756;
                                    } else {
                                        phi_4010_ = _e4737;
                                    }
                                    let _e4759 = phi_4010_;
                                    if (_e4759 < 1f) {
                                        phi_4015_ = _e4759;
                                    } else {
                                        phi_4015_ = 1f;
                                    }
                                    let _e4762 = phi_4015_;
                                    if !(_e3750) {
                                        phi_4024_ = true;
                                    } else {
                                        phi_4024_ = ((_e4762 - _e4741) > 0.0000000037252903f);
                                    }
                                    let _e4766 = phi_4024_;
                                    if _e4766 {
                                        phi_4028_ = false;
                                    } else {
                                        phi_4028_ = true;
                                    }
                                    let _e4768 = phi_4028_;
                                    phi_4029_ = _e4762;
                                    phi_4030_ = _e4737;
                                    phi_4031_ = _e4741;
                                    phi_4032_ = _e4743;
                                    phi_4033_ = _e4745;
                                    phi_4034_ = _e4766;
                                    phi_4035_ = _e4768;
                                    phi_4036_ = false;
                                    phi_4037_ = false;
                                    phi_4038_ = false;
                                } else {
                                    phi_4029_ = _e3744;
                                    phi_4030_ = _e3746;
                                    phi_4031_ = _e3748;
                                    phi_4032_ = _e3750;
                                    phi_4033_ = _e4735;
                                    phi_4034_ = _e4749;
                                    phi_4035_ = false;
                                    phi_4036_ = _e4751;
                                    phi_4037_ = _e4753;
                                    phi_4038_ = _e4755;
                                }
                                let _e4770 = phi_4029_;
                                let _e4772 = phi_4030_;
                                let _e4774 = phi_4031_;
                                let _e4776 = phi_4032_;
                                let _e4778 = phi_4033_;
                                let _e4780 = phi_4034_;
                                let _e4782 = phi_4035_;
                                let _e4784 = phi_4036_;
                                let _e4786 = phi_4037_;
                                let _e4788 = phi_4038_;
                                phi_2371_ = _e4770;
                                phi_2373_ = _e4772;
                                phi_2375_ = _e4774;
                                phi_2377_ = _e4776;
                                phi_2379_ = _e4778;
                                phi_4039_ = _e4737;
                                phi_4040_ = _e4780;
                                phi_4041_ = _e4782;
                                phi_4042_ = false;
                                phi_4043_ = _e4784;
                                phi_4044_ = _e4786;
                                phi_4045_ = _e4788;
                            } else {
                                phi_2371_ = f32();
                                phi_2373_ = f32();
                                phi_2375_ = f32();
                                phi_2377_ = bool();
                                phi_2379_ = u32();
                                phi_4039_ = f32();
                                phi_4040_ = false;
                                phi_4041_ = false;
                                phi_4042_ = true;
                                phi_4043_ = false;
                                phi_4044_ = false;
                                phi_4045_ = false;
                            }
                            let _e4790 = phi_2371_;
                            let _e4792 = phi_2373_;
                            let _e4794 = phi_2375_;
                            let _e4796 = phi_2377_;
                            let _e4798 = phi_2379_;
                            let _e4800 = phi_4039_;
                            let _e4802 = phi_4040_;
                            let _e4804 = phi_4041_;
                            let _e4806 = phi_4042_;
                            let _e4808 = phi_4043_;
                            let _e4810 = phi_4044_;
                            let _e4812 = phi_4045_;
                            local_25 = _e4804;
                            local_43 = _e4800;
                            local_45 = _e4806;
                            local_46 = _e4808;
                            local_47 = _e4810;
                            local_48 = _e4812;
                            continue;
                            continuing {
                                phi_2367_ = _e3764;
                                phi_2370_ = _e4790;
                                phi_2372_ = _e4792;
                                phi_2374_ = _e4794;
                                phi_2376_ = _e4796;
                                phi_2378_ = _e4798;
                                break if !(_e4802);
                            }
                        }
                        let _e4815 = local_25;
                        if _e4815 {
                            let _e6168 = local_43;
                            phi_4049_ = _e6168;
                            phi_4050_ = true;
                            phi_4051_ = false;
                            phi_4052_ = false;
                            phi_4053_ = false;
                        } else {
                            let _e6170 = local_44;
                            phi_4049_ = _e6170;
                            let _e6173 = local_45;
                            phi_4050_ = _e6173;
                            let _e6176 = local_46;
                            phi_4051_ = _e6176;
                            let _e6179 = local_47;
                            phi_4052_ = _e6179;
                            let _e6182 = local_48;
                            phi_4053_ = _e6182;
                        }
                        let _e4817 = phi_4049_;
                        let _e4819 = phi_4050_;
                        let _e4821 = phi_4051_;
                        let _e4823 = phi_4052_;
                        let _e4825 = phi_4053_;
                        if _e4819 {
                            phi_4058_ = type_28(1u, _e4817);
                            phi_4059_ = false;
                            phi_4060_ = false;
                            phi_4061_ = false;
                        } else {
                            phi_4058_ = type_28();
                            phi_4059_ = _e4821;
                            phi_4060_ = _e4823;
                            phi_4061_ = _e4825;
                        }
                        let _e4828 = phi_4058_;
                        let _e4830 = phi_4059_;
                        let _e4832 = phi_4060_;
                        let _e4834 = phi_4061_;
                        if _e4830 {
                            let _e4836 = local_26;
                            phi_4066_ = type_28(1u, _e4836);
                            phi_4067_ = false;
                            phi_4068_ = false;
                        } else {
                            phi_4066_ = type_28();
                            phi_4067_ = _e4832;
                            phi_4068_ = _e4834;
                        }
                        let _e4839 = phi_4066_;
                        let _e4841 = phi_4067_;
                        let _e4843 = phi_4068_;
                        if _e4841 {
                            phi_4073_ = type_28(0u, type_28().member_1);
                            phi_4074_ = false;
                            phi_4075_ = true;
                        } else {
                            phi_4073_ = _e4839;
                            phi_4074_ = _e4843;
                            phi_4075_ = _e4830;
                        }
                        let _e4847 = phi_4073_;
                        let _e4849 = phi_4074_;
                        let _e4851 = phi_4075_;
                        if _e4849 {
                            phi_4080_ = type_28(0u, type_28().member_1);
                            phi_4081_ = true;
                        } else {
                            phi_4080_ = _e4847;
                            phi_4081_ = _e4851;
                        }
                        let _e4855 = phi_4080_;
                        let _e4857 = phi_4081_;
                        if _e4857 {
                            phi_4085_ = _e4855;
                        } else {
                            phi_4085_ = _e4828;
                        }
                        let _e4859 = phi_4085_;
                        if (_e4859.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4099_ = type_9(0u, 3u);
                            loop {
                                let _e4871 = phi_4099_;
                                if (_e4871.member < _e4871.member_1) {
                                    phi_4100_ = type_9((_e4871.member + 1u), _e4871.member_1);
                                    phi_4123_ = type_9(1u, _e4871.member);
                                } else {
                                    phi_4100_ = _e4871;
                                    phi_4123_ = type_9(0u, type_9().member_1);
                                }
                                let _e4883 = phi_4100_;
                                let _e4885 = phi_4123_;
                                if (bitcast<i32>(_e4885.member) != 0i) {
                                    let _e4891 = local_11[_e4885.member_1];
                                    let _e4892 = (_e4859.member_1 + _e4891);
                                    if (_e4892 < 1f) {
                                        phi_4143_ = _e4892;
                                    } else {
                                        phi_4143_ = 1f;
                                    }
                                    let _e4895 = phi_4143_;
                                    let _e4898 = local_12.member[0u];
                                    let _e4904 = local_12.member[1u];
                                    let _e4920 = local_12.member_1[0u];
                                    let _e4926 = local_12.member_1[1u];
                                    let _e4942 = local_12.member_2[0u];
                                    let _e4948 = local_12.member_2[1u];
                                    let _e4962 = function_1(array<f32, 3>((_e4898[0] + ((_e4904[0] - _e4898[0]) * _e4895)), (_e4898[1] + ((_e4904[1] - _e4898[1]) * _e4895)), (_e4898[2] + ((_e4904[2] - _e4898[2]) * _e4895))), array<f32, 3>((_e4920[0] + ((_e4926[0] - _e4920[0]) * _e4895)), (_e4920[1] + ((_e4926[1] - _e4920[1]) * _e4895)), (_e4920[2] + ((_e4926[2] - _e4920[2]) * _e4895))), array<f32, 3>((_e4942[0] + ((_e4948[0] - _e4942[0]) * _e4895)), (_e4942[1] + ((_e4948[1] - _e4942[1]) * _e4895)), (_e4942[2] + ((_e4948[2] - _e4942[2]) * _e4895))), 0u);
                                    let _e4973 = (((_e4962[0] * _e4962[0]) + (_e4962[1] * _e4962[1])) + (_e4962[2] * _e4962[2]));
                                    if (_e4973 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4973 > 0f) {
                                            phi_4266_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4266_ = 0f;
                                        }
                                        let _e5026 = phi_4266_;
                                        phi_4330_ = _e5026;
                                    } else {
                                        phi_4273_ = type_14(0i, 5i);
                                        phi_4276_ = bitcast<f32>(((bitcast<u32>(_e4973) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4981 = phi_4273_;
                                            let _e4983 = phi_4276_;
                                            local_27 = _e4983;
                                            if (_e4981.member < _e4981.member_1) {
                                                let _e4990 = (_e4981.member + 1i);
                                                if ((false == (_e4990 > _e4981.member)) != false) {
                                                    phi_4297_ = true;
                                                } else {
                                                    phi_4297_ = false;
                                                }
                                                let _e4995 = phi_4297_;
                                                if _e4995 {
                                                    phi_4303_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_4303_ = type_15(1u, _e4990);
                                                }
                                                let _e5000 = phi_4303_;
                                                phi_4274_ = type_14(_e5000.member_1, _e4981.member_1);
                                                phi_4317_ = type_15(1u, _e4981.member);
                                            } else {
                                                phi_4274_ = _e4981;
                                                phi_4317_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5006 = phi_4274_;
                                            let _e5008 = phi_4317_;
                                            let _e5011 = (bitcast<i32>(_e5008.member) != 0i);
                                            if _e5011 {
                                                phi_4277_ = (0.5f * (_e4983 + (_e4973 / _e4983)));
                                            } else {
                                                phi_4277_ = f32();
                                            }
                                            let _e5016 = phi_4277_;
                                            continue;
                                            continuing {
                                                phi_4273_ = _e5006;
                                                phi_4276_ = _e5016;
                                                break if !(_e5011);
                                            }
                                        }
                                        let _e5021 = local_27;
                                        phi_4330_ = (_e5021 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5028 = phi_4330_;
                                    let _e5034 = local_12.member[0u];
                                    if (_e5034[0] < 0f) {
                                        phi_4346_ = -(_e5034[0]);
                                    } else {
                                        phi_4346_ = _e5034[0];
                                    }
                                    let _e5041 = phi_4346_;
                                    if (_e5034[1] < 0f) {
                                        phi_4353_ = -(_e5034[1]);
                                    } else {
                                        phi_4353_ = _e5034[1];
                                    }
                                    let _e5045 = phi_4353_;
                                    if (_e5041 > _e5045) {
                                        phi_4358_ = _e5041;
                                    } else {
                                        phi_4358_ = _e5045;
                                    }
                                    let _e5048 = phi_4358_;
                                    if (_e5034[2] < 0f) {
                                        phi_4365_ = -(_e5034[2]);
                                    } else {
                                        phi_4365_ = _e5034[2];
                                    }
                                    let _e5052 = phi_4365_;
                                    if (_e5048 > _e5052) {
                                        phi_4370_ = _e5048;
                                    } else {
                                        phi_4370_ = _e5052;
                                    }
                                    let _e5055 = phi_4370_;
                                    let _e5058 = local_12.member[1u];
                                    if (_e5058[0] < 0f) {
                                        phi_4383_ = -(_e5058[0]);
                                    } else {
                                        phi_4383_ = _e5058[0];
                                    }
                                    let _e5065 = phi_4383_;
                                    if (_e5058[1] < 0f) {
                                        phi_4390_ = -(_e5058[1]);
                                    } else {
                                        phi_4390_ = _e5058[1];
                                    }
                                    let _e5069 = phi_4390_;
                                    if (_e5065 > _e5069) {
                                        phi_4395_ = _e5065;
                                    } else {
                                        phi_4395_ = _e5069;
                                    }
                                    let _e5072 = phi_4395_;
                                    if (_e5058[2] < 0f) {
                                        phi_4402_ = -(_e5058[2]);
                                    } else {
                                        phi_4402_ = _e5058[2];
                                    }
                                    let _e5076 = phi_4402_;
                                    if (_e5072 > _e5076) {
                                        phi_4407_ = _e5072;
                                    } else {
                                        phi_4407_ = _e5076;
                                    }
                                    let _e5079 = phi_4407_;
                                    if (_e5055 > _e5079) {
                                        phi_4412_ = _e5055;
                                    } else {
                                        phi_4412_ = _e5079;
                                    }
                                    let _e5082 = phi_4412_;
                                    let _e5084 = local_12.member_3;
                                    let _e5088 = local_12.member_1[0u];
                                    if (_e5088[0] < 0f) {
                                        phi_4429_ = -(_e5088[0]);
                                    } else {
                                        phi_4429_ = _e5088[0];
                                    }
                                    let _e5095 = phi_4429_;
                                    if (_e5088[1] < 0f) {
                                        phi_4436_ = -(_e5088[1]);
                                    } else {
                                        phi_4436_ = _e5088[1];
                                    }
                                    let _e5099 = phi_4436_;
                                    if (_e5095 > _e5099) {
                                        phi_4441_ = _e5095;
                                    } else {
                                        phi_4441_ = _e5099;
                                    }
                                    let _e5102 = phi_4441_;
                                    if (_e5088[2] < 0f) {
                                        phi_4448_ = -(_e5088[2]);
                                    } else {
                                        phi_4448_ = _e5088[2];
                                    }
                                    let _e5106 = phi_4448_;
                                    if (_e5102 > _e5106) {
                                        phi_4453_ = _e5102;
                                    } else {
                                        phi_4453_ = _e5106;
                                    }
                                    let _e5109 = phi_4453_;
                                    let _e5112 = local_12.member_1[1u];
                                    if (_e5112[0] < 0f) {
                                        phi_4467_ = -(_e5112[0]);
                                    } else {
                                        phi_4467_ = _e5112[0];
                                    }
                                    let _e5119 = phi_4467_;
                                    if (_e5112[1] < 0f) {
                                        phi_4474_ = -(_e5112[1]);
                                    } else {
                                        phi_4474_ = _e5112[1];
                                    }
                                    let _e5123 = phi_4474_;
                                    if (_e5119 > _e5123) {
                                        phi_4479_ = _e5119;
                                    } else {
                                        phi_4479_ = _e5123;
                                    }
                                    let _e5126 = phi_4479_;
                                    if (_e5112[2] < 0f) {
                                        phi_4486_ = -(_e5112[2]);
                                    } else {
                                        phi_4486_ = _e5112[2];
                                    }
                                    let _e5130 = phi_4486_;
                                    if (_e5126 > _e5130) {
                                        phi_4491_ = _e5126;
                                    } else {
                                        phi_4491_ = _e5130;
                                    }
                                    let _e5133 = phi_4491_;
                                    if (_e5109 > _e5133) {
                                        phi_4496_ = _e5109;
                                    } else {
                                        phi_4496_ = _e5133;
                                    }
                                    let _e5136 = phi_4496_;
                                    let _e5138 = local_12.member_3;
                                    let _e5142 = local_12.member_2[0u];
                                    if (_e5142[0] < 0f) {
                                        phi_4513_ = -(_e5142[0]);
                                    } else {
                                        phi_4513_ = _e5142[0];
                                    }
                                    let _e5149 = phi_4513_;
                                    if (_e5142[1] < 0f) {
                                        phi_4520_ = -(_e5142[1]);
                                    } else {
                                        phi_4520_ = _e5142[1];
                                    }
                                    let _e5153 = phi_4520_;
                                    if (_e5149 > _e5153) {
                                        phi_4525_ = _e5149;
                                    } else {
                                        phi_4525_ = _e5153;
                                    }
                                    let _e5156 = phi_4525_;
                                    if (_e5142[2] < 0f) {
                                        phi_4532_ = -(_e5142[2]);
                                    } else {
                                        phi_4532_ = _e5142[2];
                                    }
                                    let _e5160 = phi_4532_;
                                    if (_e5156 > _e5160) {
                                        phi_4537_ = _e5156;
                                    } else {
                                        phi_4537_ = _e5160;
                                    }
                                    let _e5163 = phi_4537_;
                                    let _e5166 = local_12.member_2[1u];
                                    if (_e5166[0] < 0f) {
                                        phi_4551_ = -(_e5166[0]);
                                    } else {
                                        phi_4551_ = _e5166[0];
                                    }
                                    let _e5173 = phi_4551_;
                                    if (_e5166[1] < 0f) {
                                        phi_4558_ = -(_e5166[1]);
                                    } else {
                                        phi_4558_ = _e5166[1];
                                    }
                                    let _e5177 = phi_4558_;
                                    if (_e5173 > _e5177) {
                                        phi_4563_ = _e5173;
                                    } else {
                                        phi_4563_ = _e5177;
                                    }
                                    let _e5180 = phi_4563_;
                                    if (_e5166[2] < 0f) {
                                        phi_4570_ = -(_e5166[2]);
                                    } else {
                                        phi_4570_ = _e5166[2];
                                    }
                                    let _e5184 = phi_4570_;
                                    if (_e5180 > _e5184) {
                                        phi_4575_ = _e5180;
                                    } else {
                                        phi_4575_ = _e5184;
                                    }
                                    let _e5187 = phi_4575_;
                                    if (_e5163 > _e5187) {
                                        phi_4580_ = _e5163;
                                    } else {
                                        phi_4580_ = _e5187;
                                    }
                                    let _e5190 = phi_4580_;
                                    let _e5192 = local_12.member_3;
                                    let _e5199 = local_12.member_3;
                                    let _e5206 = (((_e5028 * (1f + (0.000000059604645f * 8f))) + (((((((_e5082 + _e5084) + (_e5136 + _e5138)) + (_e5190 + _e5192)) * (0.000000059604645f * 16f)) + (_e5199 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e452.member_1);
                                    if _e5206 {
                                        phi_4600_ = false;
                                    } else {
                                        phi_4600_ = true;
                                    }
                                    let _e5208 = phi_4600_;
                                    phi_4601_ = _e5208;
                                    phi_4602_ = _e5206;
                                } else {
                                    phi_4601_ = false;
                                    phi_4602_ = false;
                                }
                                let _e5210 = phi_4601_;
                                let _e5212 = phi_4602_;
                                local_28 = _e5212;
                                continue;
                                continuing {
                                    phi_4099_ = _e4883;
                                    break if !(_e5210);
                                }
                            }
                            let _e5215 = local_28;
                            if _e5215 {
                                phi_4607_ = type_28(1u, _e4859.member_1);
                                phi_4608_ = false;
                            } else {
                                phi_4607_ = type_28();
                                phi_4608_ = true;
                            }
                            let _e5218 = phi_4607_;
                            let _e5220 = phi_4608_;
                            if _e5220 {
                                phi_4613_ = type_28(2u, _e4859.member_1);
                                phi_4614_ = false;
                            } else {
                                phi_4613_ = type_28();
                                phi_4614_ = true;
                            }
                            let _e5223 = phi_4613_;
                            let _e5225 = phi_4614_;
                            phi_4616_ = _e5223;
                            phi_4617_ = _e5218;
                            phi_4618_ = _e5225;
                        } else {
                            phi_4616_ = type_28();
                            phi_4617_ = type_28(0u, type_28().member_1);
                            phi_4618_ = true;
                        }
                        let _e5227 = phi_4616_;
                        let _e5229 = phi_4617_;
                        let _e5231 = phi_4618_;
                        if _e5231 {
                            phi_4622_ = _e5229;
                        } else {
                            phi_4622_ = _e5227;
                        }
                        let _e5233 = phi_4622_;
                        phi_8558_ = _e5233;
                    } else {
                        if (_e590 < 0f) {
                            phi_4632_ = -(_e590);
                        } else {
                            phi_4632_ = _e590;
                        }
                        let _e933 = phi_4632_;
                        if (_e613 < 0f) {
                            phi_4638_ = -(_e613);
                        } else {
                            phi_4638_ = _e613;
                        }
                        let _e937 = phi_4638_;
                        if (_e933 > _e937) {
                            phi_4643_ = _e933;
                        } else {
                            phi_4643_ = _e937;
                        }
                        let _e940 = phi_4643_;
                        if (_e636 < 0f) {
                            phi_4649_ = -(_e636);
                        } else {
                            phi_4649_ = _e636;
                        }
                        let _e944 = phi_4649_;
                        if (_e647 < 0f) {
                            phi_4655_ = -(_e647);
                        } else {
                            phi_4655_ = _e647;
                        }
                        let _e948 = phi_4655_;
                        if (_e944 > _e948) {
                            phi_4660_ = _e944;
                        } else {
                            phi_4660_ = _e948;
                        }
                        let _e951 = phi_4660_;
                        if (_e940 > _e951) {
                            phi_4665_ = _e940;
                        } else {
                            phi_4665_ = _e951;
                        }
                        let _e954 = phi_4665_;
                        let _e955 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e954 >= _e955) {
                            phi_4673_ = (_e954 <= (1f / _e955));
                        } else {
                            phi_4673_ = false;
                        }
                        let _e960 = phi_4673_;
                        if _e960 {
                            phi_4678_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4678_ = 2f;
                        }
                        let _e963 = phi_4678_;
                        let _e965 = ((_e897 * 0.34f) + (_e954 * _e963));
                        if _e960 {
                            phi_4685_ = (1f / _e954);
                        } else {
                            phi_4685_ = 0f;
                        }
                        let _e968 = phi_4685_;
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
                                    phi_4718_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4718_ = 0f;
                                }
                                let _e1037 = phi_4718_;
                                phi_4782_ = _e1037;
                            } else {
                                phi_4725_ = type_14(0i, 5i);
                                phi_4728_ = bitcast<f32>(((bitcast<u32>(_e983) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e992 = phi_4725_;
                                    let _e994 = phi_4728_;
                                    local_13 = _e994;
                                    if (_e992.member < _e992.member_1) {
                                        let _e1001 = (_e992.member + 1i);
                                        if ((false == (_e1001 > _e992.member)) != false) {
                                            phi_4749_ = true;
                                        } else {
                                            phi_4749_ = false;
                                        }
                                        let _e1006 = phi_4749_;
                                        if _e1006 {
                                            phi_4755_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4755_ = type_15(1u, _e1001);
                                        }
                                        let _e1011 = phi_4755_;
                                        phi_4726_ = type_14(_e1011.member_1, _e992.member_1);
                                        phi_4769_ = type_15(1u, _e992.member);
                                    } else {
                                        phi_4726_ = _e992;
                                        phi_4769_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1017 = phi_4726_;
                                    let _e1019 = phi_4769_;
                                    let _e1022 = (bitcast<i32>(_e1019.member) != 0i);
                                    if _e1022 {
                                        phi_4729_ = (0.5f * (_e994 + (_e983 / _e994)));
                                    } else {
                                        phi_4729_ = f32();
                                    }
                                    let _e1027 = phi_4729_;
                                    continue;
                                    continuing {
                                        phi_4725_ = _e1017;
                                        phi_4728_ = _e1027;
                                        break if !(_e1022);
                                    }
                                }
                                let _e1032 = local_13;
                                phi_4782_ = (_e1032 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1039 = phi_4782_;
                            if (_e975 < 0f) {
                                phi_4788_ = -(_e1039);
                            } else {
                                phi_4788_ = _e1039;
                            }
                            let _e1043 = phi_4788_;
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
                            phi_4813_ = type_9(0u, 2u);
                            phi_4816_ = 1u;
                            loop {
                                let _e1064 = phi_4813_;
                                let _e1066 = phi_4816_;
                                local_29 = _e1066;
                                if (_e1064.member < _e1064.member_1) {
                                    phi_4814_ = type_9((_e1064.member + 1u), _e1064.member_1);
                                    phi_4839_ = type_9(1u, _e1064.member);
                                } else {
                                    phi_4814_ = _e1064;
                                    phi_4839_ = type_9(0u, type_9().member_1);
                                }
                                let _e1078 = phi_4814_;
                                let _e1080 = phi_4839_;
                                let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                if _e1084 {
                                    let _e1086 = local_7[_e1080.member_1];
                                    if (_e1086 > 0f) {
                                        let _e1089 = local_7[_e1080.member_1];
                                        if (_e1089 < 1f) {
                                            let _e1092 = local_7[_e1080.member_1];
                                            local_6[_e1066] = _e1092;
                                            phi_4883_ = (_e1066 + 1u);
                                        } else {
                                            phi_4883_ = _e1066;
                                        }
                                        let _e1096 = phi_4883_;
                                        phi_4884_ = _e1096;
                                    } else {
                                        phi_4884_ = _e1066;
                                    }
                                    let _e1098 = phi_4884_;
                                    phi_4817_ = _e1098;
                                } else {
                                    phi_4817_ = u32();
                                }
                                let _e1100 = phi_4817_;
                                continue;
                                continuing {
                                    phi_4813_ = _e1078;
                                    phi_4816_ = _e1100;
                                    break if !(_e1084);
                                }
                            }
                            let _e5493 = local_29;
                            phi_4885_ = _e5493;
                        } else {
                            phi_4885_ = 1u;
                        }
                        let _e1103 = phi_4885_;
                        local_6[_e1103] = 1f;
                        let _e1105 = local_6;
                        local_8 = _e1105;
                        phi_4905_ = type_9(0u, _e1103);
                        loop {
                            let _e1108 = phi_4905_;
                            if (_e1108.member < _e1108.member_1) {
                                phi_4906_ = type_9((_e1108.member + 1u), _e1108.member_1);
                                phi_4929_ = type_9(1u, _e1108.member);
                            } else {
                                phi_4906_ = _e1108;
                                phi_4929_ = type_9(0u, type_9().member_1);
                            }
                            let _e1120 = phi_4906_;
                            let _e1122 = phi_4929_;
                            if (bitcast<i32>(_e1122.member) != 0i) {
                                let _e1128 = local_8[_e1122.member_1];
                                let _e1131 = local_8[(_e1122.member_1 + 1u)];
                                let _e1132 = (1f - _e1128);
                                let _e1143 = ((((_e590 * _e1132) + (_e613 * _e1128)) * (_e1132 * _e1132)) + (((_e636 * _e1132) + (_e647 * _e1128)) * (_e1128 * _e1128)));
                                let _e1144 = (1f - _e1131);
                                let _e1155 = ((((_e590 * _e1144) + (_e613 * _e1131)) * (_e1144 * _e1144)) + (((_e636 * _e1144) + (_e647 * _e1131)) * (_e1131 * _e1131)));
                                if (_e1143 < 0f) {
                                    phi_4981_ = -(_e1143);
                                } else {
                                    phi_4981_ = _e1143;
                                }
                                let _e1159 = phi_4981_;
                                let _e1160 = (_e1159 > _e965);
                                if (_e1155 < 0f) {
                                    phi_4988_ = -(_e1155);
                                } else {
                                    phi_4988_ = _e1155;
                                }
                                let _e1164 = phi_4988_;
                                let _e1165 = (_e1164 > _e965);
                                if _e1160 {
                                    if _e1165 {
                                        phi_4999_ = ((_e1143 > 0f) != (_e1155 > 0f));
                                        phi_5000_ = false;
                                    } else {
                                        phi_4999_ = bool();
                                        phi_5000_ = true;
                                    }
                                    let _e1170 = phi_4999_;
                                    let _e1172 = phi_5000_;
                                    phi_5001_ = _e1170;
                                    phi_5002_ = _e1172;
                                } else {
                                    phi_5001_ = bool();
                                    phi_5002_ = true;
                                }
                                let _e1174 = phi_5001_;
                                let _e1176 = phi_5002_;
                                if _e1176 {
                                    phi_5006_ = false;
                                } else {
                                    phi_5006_ = _e1174;
                                }
                                let _e1178 = phi_5006_;
                                if _e1160 {
                                    if _e1165 {
                                        if _e1178 {
                                            phi_5017_ = type_37();
                                        } else {
                                            phi_5017_ = type_37(1f, 0f, _e1178);
                                        }
                                        let _e1181 = phi_5017_;
                                        phi_5018_ = _e1181;
                                        phi_5019_ = _e1178;
                                    } else {
                                        phi_5018_ = type_37();
                                        phi_5019_ = true;
                                    }
                                    let _e1183 = phi_5018_;
                                    let _e1185 = phi_5019_;
                                    phi_5020_ = _e1183;
                                    phi_5021_ = _e1185;
                                } else {
                                    phi_5020_ = type_37();
                                    phi_5021_ = true;
                                }
                                let _e1187 = phi_5020_;
                                let _e1189 = phi_5021_;
                                if _e1189 {
                                    if _e1160 {
                                        if (_e1143 < 0f) {
                                            phi_5032_ = -1f;
                                        } else {
                                            phi_5032_ = 1f;
                                        }
                                        let _e1192 = phi_5032_;
                                        let _e1195 = (_e636 - _e613);
                                        phi_5042_ = type_9(0u, 64u);
                                        phi_5045_ = _e1131;
                                        phi_5047_ = _e1128;
                                        phi_5049_ = (0.5f * (_e1128 + _e1131));
                                        loop {
                                            let _e1201 = phi_5042_;
                                            let _e1203 = phi_5045_;
                                            let _e1205 = phi_5047_;
                                            let _e1207 = phi_5049_;
                                            local_31 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_5043_ = type_9((_e1201.member + 1u), _e1201.member_1);
                                                phi_5072_ = type_9(1u, _e1201.member);
                                            } else {
                                                phi_5043_ = _e1201;
                                                phi_5072_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1219 = phi_5043_;
                                            let _e1221 = phi_5072_;
                                            if (bitcast<i32>(_e1221.member) != 0i) {
                                                let _e1225 = (1f - _e1207);
                                                let _e1238 = ((_e1192 * ((((_e590 * _e1225) + (_e613 * _e1207)) * (_e1225 * _e1225)) + (((_e636 * _e1225) + (_e647 * _e1207)) * (_e1207 * _e1207)))) - _e965);
                                                if (_e1238 > 0f) {
                                                    phi_5097_ = _e1203;
                                                    phi_5098_ = _e1207;
                                                } else {
                                                    phi_5097_ = _e1207;
                                                    phi_5098_ = _e1205;
                                                }
                                                let _e1241 = phi_5097_;
                                                let _e1243 = phi_5098_;
                                                let _e1245 = ((_e1241 - _e1243) > 0.00000000000022737368f);
                                                if _e1245 {
                                                    let _e1246 = (1f - _e1207);
                                                    let _e1258 = (-(_e1238) / (_e1192 * (((((_e613 - (3f * _e590)) * _e1246) + (_e1195 * _e1207)) * _e1246) + (((_e1195 * _e1246) + (((3f * _e647) - _e636) * _e1207)) * _e1207))));
                                                    if (_e1238 > 0f) {
                                                        phi_5124_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5124_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1264 = phi_5124_;
                                                    let _e1266 = ((_e1207 + _e1258) + _e1264);
                                                    if (_e1266 > _e1243) {
                                                        if (_e1266 < _e1241) {
                                                            if (_e1258 < 0f) {
                                                                phi_5140_ = -(_e1258);
                                                            } else {
                                                                phi_5140_ = _e1258;
                                                            }
                                                            let _e1272 = phi_5140_;
                                                            if (_e1272 < (0.5f * (_e1241 - _e1243))) {
                                                                phi_5147_ = false;
                                                            } else {
                                                                phi_5147_ = true;
                                                            }
                                                            let _e1277 = phi_5147_;
                                                            phi_5148_ = _e1277;
                                                        } else {
                                                            phi_5148_ = true;
                                                        }
                                                        let _e1279 = phi_5148_;
                                                        phi_5149_ = _e1279;
                                                    } else {
                                                        phi_5149_ = true;
                                                    }
                                                    let _e1281 = phi_5149_;
                                                    if _e1281 {
                                                        phi_5155_ = (0.5f * (_e1243 + _e1241));
                                                    } else {
                                                        phi_5155_ = _e1266;
                                                    }
                                                    let _e1285 = phi_5155_;
                                                    phi_5156_ = _e1285;
                                                    phi_5157_ = false;
                                                } else {
                                                    phi_5156_ = f32();
                                                    phi_5157_ = true;
                                                }
                                                let _e1287 = phi_5156_;
                                                let _e1289 = phi_5157_;
                                                phi_5046_ = _e1241;
                                                phi_5048_ = _e1243;
                                                phi_5050_ = _e1287;
                                                phi_5158_ = _e1243;
                                                phi_5159_ = _e1245;
                                                phi_5160_ = _e1289;
                                            } else {
                                                phi_5046_ = f32();
                                                phi_5048_ = f32();
                                                phi_5050_ = f32();
                                                phi_5158_ = f32();
                                                phi_5159_ = false;
                                                phi_5160_ = false;
                                            }
                                            let _e1291 = phi_5046_;
                                            let _e1293 = phi_5048_;
                                            let _e1295 = phi_5050_;
                                            let _e1297 = phi_5158_;
                                            let _e1299 = phi_5159_;
                                            let _e1301 = phi_5160_;
                                            local_14 = _e1301;
                                            local_30 = _e1297;
                                            continue;
                                            continuing {
                                                phi_5042_ = _e1219;
                                                phi_5045_ = _e1291;
                                                phi_5047_ = _e1293;
                                                phi_5049_ = _e1295;
                                                break if !(_e1299);
                                            }
                                        }
                                        let _e1304 = local_14;
                                        if _e1304 {
                                            let _e5535 = local_30;
                                            phi_5164_ = _e5535;
                                        } else {
                                            let _e5537 = local_31;
                                            phi_5164_ = _e5537;
                                        }
                                        let _e1306 = phi_5164_;
                                        phi_5165_ = _e1306;
                                    } else {
                                        phi_5165_ = _e1128;
                                    }
                                    let _e1308 = phi_5165_;
                                    if _e1165 {
                                        if (_e1155 < 0f) {
                                            phi_5173_ = -1f;
                                        } else {
                                            phi_5173_ = 1f;
                                        }
                                        let _e1311 = phi_5173_;
                                        phi_5177_ = type_9(0u, 64u);
                                        phi_5180_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1314 = phi_5177_;
                                            let _e1316 = phi_5180_;
                                            if (_e1314.member < _e1314.member_1) {
                                                phi_5178_ = type_9((_e1314.member + 1u), _e1314.member_1);
                                                phi_5203_ = type_9(1u, _e1314.member);
                                            } else {
                                                phi_5178_ = _e1314;
                                                phi_5203_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1328 = phi_5178_;
                                            let _e1330 = phi_5203_;
                                            if (bitcast<i32>(_e1330.member) != 0i) {
                                                let _e1334 = (_e1308 + _e1316);
                                                if (_e1334 < _e1131) {
                                                    let _e1336 = (1f - _e1334);
                                                    let _e1349 = ((_e1311 * ((((_e590 * _e1336) + (_e613 * _e1334)) * (_e1336 * _e1336)) + (((_e636 * _e1336) + (_e647 * _e1334)) * (_e1334 * _e1334)))) > _e965);
                                                    if _e1349 {
                                                        phi_5233_ = f32();
                                                        phi_5234_ = false;
                                                    } else {
                                                        phi_5233_ = (_e1316 + _e1316);
                                                        phi_5234_ = true;
                                                    }
                                                    let _e1352 = phi_5233_;
                                                    let _e1354 = phi_5234_;
                                                    phi_5235_ = _e1352;
                                                    phi_5236_ = _e1354;
                                                    phi_5237_ = _e1349;
                                                    phi_5238_ = false;
                                                } else {
                                                    phi_5235_ = f32();
                                                    phi_5236_ = false;
                                                    phi_5237_ = false;
                                                    phi_5238_ = true;
                                                }
                                                let _e1356 = phi_5235_;
                                                let _e1358 = phi_5236_;
                                                let _e1360 = phi_5237_;
                                                let _e1362 = phi_5238_;
                                                phi_5239_ = _e1334;
                                                phi_5181_ = _e1356;
                                                phi_5240_ = _e1358;
                                                phi_5241_ = _e1360;
                                                phi_5242_ = _e1362;
                                                phi_5243_ = false;
                                            } else {
                                                phi_5239_ = f32();
                                                phi_5181_ = f32();
                                                phi_5240_ = false;
                                                phi_5241_ = false;
                                                phi_5242_ = false;
                                                phi_5243_ = true;
                                            }
                                            let _e1364 = phi_5239_;
                                            let _e1366 = phi_5181_;
                                            let _e1368 = phi_5240_;
                                            let _e1370 = phi_5241_;
                                            let _e1372 = phi_5242_;
                                            let _e1374 = phi_5243_;
                                            local_15 = _e1370;
                                            local_32 = _e1372;
                                            local_33 = _e1374;
                                            local_34 = _e1364;
                                            continue;
                                            continuing {
                                                phi_5177_ = _e1328;
                                                phi_5180_ = _e1366;
                                                break if !(_e1368);
                                            }
                                        }
                                        let _e1377 = local_15;
                                        if _e1377 {
                                            phi_5247_ = false;
                                            phi_5248_ = false;
                                        } else {
                                            let _e5559 = local_32;
                                            phi_5247_ = _e5559;
                                            let _e5562 = local_33;
                                            phi_5248_ = _e5562;
                                        }
                                        let _e1379 = phi_5247_;
                                        let _e1381 = phi_5248_;
                                        if _e1379 {
                                            phi_5252_ = true;
                                        } else {
                                            phi_5252_ = _e1381;
                                        }
                                        let _e1383 = phi_5252_;
                                        if _e1383 {
                                            phi_5256_ = _e1131;
                                        } else {
                                            let _e5566 = local_34;
                                            phi_5256_ = _e5566;
                                        }
                                        let _e1385 = phi_5256_;
                                        phi_5257_ = _e1385;
                                    } else {
                                        phi_5257_ = _e1131;
                                    }
                                    let _e1387 = phi_5257_;
                                    phi_5259_ = type_37(_e1308, _e1387, _e1178);
                                } else {
                                    phi_5259_ = _e1187;
                                }
                                let _e1390 = phi_5259_;
                                if (_e1390.member > _e1390.member_1) {
                                    phi_8514_ = f32();
                                    phi_8515_ = true;
                                    phi_8516_ = false;
                                    phi_8517_ = false;
                                    phi_8518_ = false;
                                } else {
                                    let _e1397 = ((_e1390.member_1 - _e1390.member) * 0.5f);
                                    let _e1398 = (_e1390.member + _e1397);
                                    let _e1400 = (_e1397 + (0.000000059604645f * 4f));
                                    let _e1402 = local_12.member_3;
                                    let _e1405 = local_12.member[0u];
                                    if (_e1405[0] < 0f) {
                                        phi_5288_ = -(_e1405[0]);
                                    } else {
                                        phi_5288_ = _e1405[0];
                                    }
                                    let _e1412 = phi_5288_;
                                    if (_e1405[1] < 0f) {
                                        phi_5295_ = -(_e1405[1]);
                                    } else {
                                        phi_5295_ = _e1405[1];
                                    }
                                    let _e1416 = phi_5295_;
                                    if (_e1412 > _e1416) {
                                        phi_5300_ = _e1412;
                                    } else {
                                        phi_5300_ = _e1416;
                                    }
                                    let _e1419 = phi_5300_;
                                    if (_e1405[2] < 0f) {
                                        phi_5307_ = -(_e1405[2]);
                                    } else {
                                        phi_5307_ = _e1405[2];
                                    }
                                    let _e1423 = phi_5307_;
                                    if (_e1419 > _e1423) {
                                        phi_5312_ = _e1419;
                                    } else {
                                        phi_5312_ = _e1423;
                                    }
                                    let _e1426 = phi_5312_;
                                    let _e1428 = local_12.member[1u];
                                    if (_e1428[0] < 0f) {
                                        phi_5325_ = -(_e1428[0]);
                                    } else {
                                        phi_5325_ = _e1428[0];
                                    }
                                    let _e1435 = phi_5325_;
                                    if (_e1428[1] < 0f) {
                                        phi_5332_ = -(_e1428[1]);
                                    } else {
                                        phi_5332_ = _e1428[1];
                                    }
                                    let _e1439 = phi_5332_;
                                    if (_e1435 > _e1439) {
                                        phi_5337_ = _e1435;
                                    } else {
                                        phi_5337_ = _e1439;
                                    }
                                    let _e1442 = phi_5337_;
                                    if (_e1428[2] < 0f) {
                                        phi_5344_ = -(_e1428[2]);
                                    } else {
                                        phi_5344_ = _e1428[2];
                                    }
                                    let _e1446 = phi_5344_;
                                    if (_e1442 > _e1446) {
                                        phi_5349_ = _e1442;
                                    } else {
                                        phi_5349_ = _e1446;
                                    }
                                    let _e1449 = phi_5349_;
                                    if (_e1426 > _e1449) {
                                        phi_5354_ = _e1426;
                                    } else {
                                        phi_5354_ = _e1449;
                                    }
                                    let _e1452 = phi_5354_;
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
                                        phi_5413_ = -(_e1483);
                                    } else {
                                        phi_5413_ = _e1483;
                                    }
                                    let _e1489 = phi_5413_;
                                    if (_e1484 < 0f) {
                                        phi_5419_ = -(_e1484);
                                    } else {
                                        phi_5419_ = _e1484;
                                    }
                                    let _e1493 = phi_5419_;
                                    if (_e1489 > _e1493) {
                                        phi_5424_ = _e1489;
                                    } else {
                                        phi_5424_ = _e1493;
                                    }
                                    let _e1496 = phi_5424_;
                                    if (_e1485 < 0f) {
                                        phi_5430_ = -(_e1485);
                                    } else {
                                        phi_5430_ = _e1485;
                                    }
                                    let _e1500 = phi_5430_;
                                    if (_e1496 > _e1500) {
                                        phi_5435_ = _e1496;
                                    } else {
                                        phi_5435_ = _e1500;
                                    }
                                    let _e1503 = phi_5435_;
                                    let _e1509 = ((((_e1400 * _e1503) * 1.01f) + ((_e1452 + _e1402) * (0.000000059604645f * 8f))) + _e1402);
                                    if (_e1470 < 0f) {
                                        phi_5447_ = -(_e1470);
                                    } else {
                                        phi_5447_ = _e1470;
                                    }
                                    let _e1513 = phi_5447_;
                                    if (_e1471 < 0f) {
                                        phi_5453_ = -(_e1471);
                                    } else {
                                        phi_5453_ = _e1471;
                                    }
                                    let _e1517 = phi_5453_;
                                    if (_e1513 > _e1517) {
                                        phi_5458_ = _e1513;
                                    } else {
                                        phi_5458_ = _e1517;
                                    }
                                    let _e1520 = phi_5458_;
                                    if (_e1472 < 0f) {
                                        phi_5464_ = -(_e1472);
                                    } else {
                                        phi_5464_ = _e1472;
                                    }
                                    let _e1524 = phi_5464_;
                                    if (_e1520 > _e1524) {
                                        phi_5469_ = _e1520;
                                    } else {
                                        phi_5469_ = _e1524;
                                    }
                                    let _e1527 = phi_5469_;
                                    local_2 = type_24(array<f32, 3>(_e1470, _e1471, _e1472), _e1509, (_e1527 + _e1509));
                                    let _e1533 = local_12.member_3;
                                    let _e1535 = local_12.member_1[0u];
                                    if (_e1535[0] < 0f) {
                                        phi_5495_ = -(_e1535[0]);
                                    } else {
                                        phi_5495_ = _e1535[0];
                                    }
                                    let _e1542 = phi_5495_;
                                    if (_e1535[1] < 0f) {
                                        phi_5502_ = -(_e1535[1]);
                                    } else {
                                        phi_5502_ = _e1535[1];
                                    }
                                    let _e1546 = phi_5502_;
                                    if (_e1542 > _e1546) {
                                        phi_5507_ = _e1542;
                                    } else {
                                        phi_5507_ = _e1546;
                                    }
                                    let _e1549 = phi_5507_;
                                    if (_e1535[2] < 0f) {
                                        phi_5514_ = -(_e1535[2]);
                                    } else {
                                        phi_5514_ = _e1535[2];
                                    }
                                    let _e1553 = phi_5514_;
                                    if (_e1549 > _e1553) {
                                        phi_5519_ = _e1549;
                                    } else {
                                        phi_5519_ = _e1553;
                                    }
                                    let _e1556 = phi_5519_;
                                    let _e1558 = local_12.member_1[1u];
                                    if (_e1558[0] < 0f) {
                                        phi_5532_ = -(_e1558[0]);
                                    } else {
                                        phi_5532_ = _e1558[0];
                                    }
                                    let _e1565 = phi_5532_;
                                    if (_e1558[1] < 0f) {
                                        phi_5539_ = -(_e1558[1]);
                                    } else {
                                        phi_5539_ = _e1558[1];
                                    }
                                    let _e1569 = phi_5539_;
                                    if (_e1565 > _e1569) {
                                        phi_5544_ = _e1565;
                                    } else {
                                        phi_5544_ = _e1569;
                                    }
                                    let _e1572 = phi_5544_;
                                    if (_e1558[2] < 0f) {
                                        phi_5551_ = -(_e1558[2]);
                                    } else {
                                        phi_5551_ = _e1558[2];
                                    }
                                    let _e1576 = phi_5551_;
                                    if (_e1572 > _e1576) {
                                        phi_5556_ = _e1572;
                                    } else {
                                        phi_5556_ = _e1576;
                                    }
                                    let _e1579 = phi_5556_;
                                    if (_e1556 > _e1579) {
                                        phi_5561_ = _e1556;
                                    } else {
                                        phi_5561_ = _e1579;
                                    }
                                    let _e1582 = phi_5561_;
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
                                        phi_5620_ = -(_e1613);
                                    } else {
                                        phi_5620_ = _e1613;
                                    }
                                    let _e1619 = phi_5620_;
                                    if (_e1614 < 0f) {
                                        phi_5626_ = -(_e1614);
                                    } else {
                                        phi_5626_ = _e1614;
                                    }
                                    let _e1623 = phi_5626_;
                                    if (_e1619 > _e1623) {
                                        phi_5631_ = _e1619;
                                    } else {
                                        phi_5631_ = _e1623;
                                    }
                                    let _e1626 = phi_5631_;
                                    if (_e1615 < 0f) {
                                        phi_5637_ = -(_e1615);
                                    } else {
                                        phi_5637_ = _e1615;
                                    }
                                    let _e1630 = phi_5637_;
                                    if (_e1626 > _e1630) {
                                        phi_5642_ = _e1626;
                                    } else {
                                        phi_5642_ = _e1630;
                                    }
                                    let _e1633 = phi_5642_;
                                    let _e1639 = ((((_e1400 * _e1633) * 1.01f) + ((_e1582 + _e1533) * (0.000000059604645f * 8f))) + _e1533);
                                    if (_e1600 < 0f) {
                                        phi_5654_ = -(_e1600);
                                    } else {
                                        phi_5654_ = _e1600;
                                    }
                                    let _e1643 = phi_5654_;
                                    if (_e1601 < 0f) {
                                        phi_5660_ = -(_e1601);
                                    } else {
                                        phi_5660_ = _e1601;
                                    }
                                    let _e1647 = phi_5660_;
                                    if (_e1643 > _e1647) {
                                        phi_5665_ = _e1643;
                                    } else {
                                        phi_5665_ = _e1647;
                                    }
                                    let _e1650 = phi_5665_;
                                    if (_e1602 < 0f) {
                                        phi_5671_ = -(_e1602);
                                    } else {
                                        phi_5671_ = _e1602;
                                    }
                                    let _e1654 = phi_5671_;
                                    if (_e1650 > _e1654) {
                                        phi_5676_ = _e1650;
                                    } else {
                                        phi_5676_ = _e1654;
                                    }
                                    let _e1657 = phi_5676_;
                                    local_3 = type_24(array<f32, 3>(_e1600, _e1601, _e1602), _e1639, (_e1657 + _e1639));
                                    let _e1663 = local_12.member_3;
                                    let _e1665 = local_12.member_2[0u];
                                    if (_e1665[0] < 0f) {
                                        phi_5702_ = -(_e1665[0]);
                                    } else {
                                        phi_5702_ = _e1665[0];
                                    }
                                    let _e1672 = phi_5702_;
                                    if (_e1665[1] < 0f) {
                                        phi_5709_ = -(_e1665[1]);
                                    } else {
                                        phi_5709_ = _e1665[1];
                                    }
                                    let _e1676 = phi_5709_;
                                    if (_e1672 > _e1676) {
                                        phi_5714_ = _e1672;
                                    } else {
                                        phi_5714_ = _e1676;
                                    }
                                    let _e1679 = phi_5714_;
                                    if (_e1665[2] < 0f) {
                                        phi_5721_ = -(_e1665[2]);
                                    } else {
                                        phi_5721_ = _e1665[2];
                                    }
                                    let _e1683 = phi_5721_;
                                    if (_e1679 > _e1683) {
                                        phi_5726_ = _e1679;
                                    } else {
                                        phi_5726_ = _e1683;
                                    }
                                    let _e1686 = phi_5726_;
                                    let _e1688 = local_12.member_2[1u];
                                    if (_e1688[0] < 0f) {
                                        phi_5739_ = -(_e1688[0]);
                                    } else {
                                        phi_5739_ = _e1688[0];
                                    }
                                    let _e1695 = phi_5739_;
                                    if (_e1688[1] < 0f) {
                                        phi_5746_ = -(_e1688[1]);
                                    } else {
                                        phi_5746_ = _e1688[1];
                                    }
                                    let _e1699 = phi_5746_;
                                    if (_e1695 > _e1699) {
                                        phi_5751_ = _e1695;
                                    } else {
                                        phi_5751_ = _e1699;
                                    }
                                    let _e1702 = phi_5751_;
                                    if (_e1688[2] < 0f) {
                                        phi_5758_ = -(_e1688[2]);
                                    } else {
                                        phi_5758_ = _e1688[2];
                                    }
                                    let _e1706 = phi_5758_;
                                    if (_e1702 > _e1706) {
                                        phi_5763_ = _e1702;
                                    } else {
                                        phi_5763_ = _e1706;
                                    }
                                    let _e1709 = phi_5763_;
                                    if (_e1686 > _e1709) {
                                        phi_5768_ = _e1686;
                                    } else {
                                        phi_5768_ = _e1709;
                                    }
                                    let _e1712 = phi_5768_;
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
                                        phi_5827_ = -(_e1743);
                                    } else {
                                        phi_5827_ = _e1743;
                                    }
                                    let _e1749 = phi_5827_;
                                    if (_e1744 < 0f) {
                                        phi_5833_ = -(_e1744);
                                    } else {
                                        phi_5833_ = _e1744;
                                    }
                                    let _e1753 = phi_5833_;
                                    if (_e1749 > _e1753) {
                                        phi_5838_ = _e1749;
                                    } else {
                                        phi_5838_ = _e1753;
                                    }
                                    let _e1756 = phi_5838_;
                                    if (_e1745 < 0f) {
                                        phi_5844_ = -(_e1745);
                                    } else {
                                        phi_5844_ = _e1745;
                                    }
                                    let _e1760 = phi_5844_;
                                    if (_e1756 > _e1760) {
                                        phi_5849_ = _e1756;
                                    } else {
                                        phi_5849_ = _e1760;
                                    }
                                    let _e1763 = phi_5849_;
                                    let _e1769 = ((((_e1400 * _e1763) * 1.01f) + ((_e1712 + _e1663) * (0.000000059604645f * 8f))) + _e1663);
                                    if (_e1730 < 0f) {
                                        phi_5861_ = -(_e1730);
                                    } else {
                                        phi_5861_ = _e1730;
                                    }
                                    let _e1773 = phi_5861_;
                                    if (_e1731 < 0f) {
                                        phi_5867_ = -(_e1731);
                                    } else {
                                        phi_5867_ = _e1731;
                                    }
                                    let _e1777 = phi_5867_;
                                    if (_e1773 > _e1777) {
                                        phi_5872_ = _e1773;
                                    } else {
                                        phi_5872_ = _e1777;
                                    }
                                    let _e1780 = phi_5872_;
                                    if (_e1732 < 0f) {
                                        phi_5878_ = -(_e1732);
                                    } else {
                                        phi_5878_ = _e1732;
                                    }
                                    let _e1784 = phi_5878_;
                                    if (_e1780 > _e1784) {
                                        phi_5883_ = _e1780;
                                    } else {
                                        phi_5883_ = _e1784;
                                    }
                                    let _e1787 = phi_5883_;
                                    local_4 = type_24(array<f32, 3>(_e1730, _e1731, _e1732), _e1769, (_e1787 + _e1769));
                                    let _e1792 = local_3.member;
                                    let _e1797 = local_4.member;
                                    let _e1803 = ((_e1792[1] * _e1797[2]) - (_e1792[2] * _e1797[1]));
                                    let _e1806 = ((_e1792[2] * _e1797[0]) - (_e1792[0] * _e1797[2]));
                                    let _e1809 = ((_e1792[0] * _e1797[1]) - (_e1792[1] * _e1797[0]));
                                    if (_e1803 < 0f) {
                                        phi_5932_ = -(_e1803);
                                    } else {
                                        phi_5932_ = _e1803;
                                    }
                                    let _e1813 = phi_5932_;
                                    if (_e1806 < 0f) {
                                        phi_5938_ = -(_e1806);
                                    } else {
                                        phi_5938_ = _e1806;
                                    }
                                    let _e1817 = phi_5938_;
                                    if (_e1813 > _e1817) {
                                        if (_e1803 < 0f) {
                                            phi_5948_ = -(_e1803);
                                        } else {
                                            phi_5948_ = _e1803;
                                        }
                                        let _e1835 = phi_5948_;
                                        if (_e1809 < 0f) {
                                            phi_5954_ = -(_e1809);
                                        } else {
                                            phi_5954_ = _e1809;
                                        }
                                        let _e1839 = phi_5954_;
                                        if (_e1835 > _e1839) {
                                            phi_5959_ = 2u;
                                            phi_5960_ = 1u;
                                        } else {
                                            phi_5959_ = 1u;
                                            phi_5960_ = 0u;
                                        }
                                        let _e1842 = phi_5959_;
                                        let _e1844 = phi_5960_;
                                        phi_5979_ = _e1842;
                                        phi_5980_ = _e1844;
                                    } else {
                                        if (_e1806 < 0f) {
                                            phi_5966_ = -(_e1806);
                                        } else {
                                            phi_5966_ = _e1806;
                                        }
                                        let _e1822 = phi_5966_;
                                        if (_e1809 < 0f) {
                                            phi_5972_ = -(_e1809);
                                        } else {
                                            phi_5972_ = _e1809;
                                        }
                                        let _e1826 = phi_5972_;
                                        if (_e1822 > _e1826) {
                                            phi_5977_ = 0u;
                                            phi_5978_ = 2u;
                                        } else {
                                            phi_5977_ = 1u;
                                            phi_5978_ = 0u;
                                        }
                                        let _e1829 = phi_5977_;
                                        let _e1831 = phi_5978_;
                                        phi_5979_ = _e1829;
                                        phi_5980_ = _e1831;
                                    }
                                    let _e1846 = phi_5979_;
                                    let _e1848 = phi_5980_;
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
                                        phi_6049_ = -(_e1863);
                                    } else {
                                        phi_6049_ = _e1863;
                                    }
                                    let _e1899 = phi_6049_;
                                    if (_e1899 > _e1895) {
                                        if (_e1863 < 0f) {
                                            phi_6058_ = -1f;
                                        } else {
                                            phi_6058_ = 1f;
                                        }
                                        let _e1903 = phi_6058_;
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
                                            phi_6193_ = -(_e1998);
                                        } else {
                                            phi_6193_ = _e1998;
                                        }
                                        let _e2004 = phi_6193_;
                                        if (_e1999 < 0f) {
                                            phi_6199_ = -(_e1999);
                                        } else {
                                            phi_6199_ = _e1999;
                                        }
                                        let _e2008 = phi_6199_;
                                        if (_e2000 < 0f) {
                                            phi_6206_ = -(_e2000);
                                        } else {
                                            phi_6206_ = _e2000;
                                        }
                                        let _e2013 = phi_6206_;
                                        let _e2018 = ((_e1998 - _e1999) - _e2000);
                                        let _e2021 = (((_e1895 + _e1950) + _e1997) + (((_e2004 + _e2008) + _e2013) * (0.000000059604645f * 4f)));
                                        local_5 = array<type_32, 4>(type_32(_e1999, _e1950), type_32(_e2000, _e1997), type_32(_e2018, _e2021), type_32(_e2018, _e2021));
                                        phi_6261_ = type_9(0u, 4u);
                                        phi_6264_ = true;
                                        loop {
                                            let _e2028 = phi_6261_;
                                            let _e2030 = phi_6264_;
                                            local_17 = _e2030;
                                            if (_e2028.member < _e2028.member_1) {
                                                phi_6262_ = type_9((_e2028.member + 1u), _e2028.member_1);
                                                phi_6287_ = type_9(1u, _e2028.member);
                                            } else {
                                                phi_6262_ = _e2028;
                                                phi_6287_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2042 = phi_6262_;
                                            let _e2044 = phi_6287_;
                                            if (bitcast<i32>(_e2044.member) != 0i) {
                                                let _e2051 = local_5[_e2044.member_1].member;
                                                let _e2054 = local_5[_e2044.member_1].member_1;
                                                let _e2056 = (_e2051 < -(_e2054));
                                                if _e2056 {
                                                    phi_6314_ = bool();
                                                    phi_6315_ = false;
                                                } else {
                                                    phi_6314_ = (_e2030 && (_e2051 > _e2054));
                                                    phi_6315_ = true;
                                                }
                                                let _e2060 = phi_6314_;
                                                let _e2062 = phi_6315_;
                                                phi_6265_ = _e2060;
                                                phi_6316_ = _e2062;
                                                phi_6317_ = _e2056;
                                            } else {
                                                phi_6265_ = bool();
                                                phi_6316_ = false;
                                                phi_6317_ = false;
                                            }
                                            let _e2064 = phi_6265_;
                                            let _e2066 = phi_6316_;
                                            let _e2068 = phi_6317_;
                                            local_16 = _e2068;
                                            continue;
                                            continuing {
                                                phi_6261_ = _e2042;
                                                phi_6264_ = _e2064;
                                                break if !(_e2066);
                                            }
                                        }
                                        let _e2071 = local_16;
                                        if _e2071 {
                                            phi_6321_ = false;
                                        } else {
                                            phi_6321_ = true;
                                        }
                                        let _e2073 = phi_6321_;
                                        if _e2073 {
                                            let _e2075 = local_17;
                                            if _e2075 {
                                                phi_6328_ = 1u;
                                            } else {
                                                phi_6328_ = 2u;
                                            }
                                            let _e2077 = phi_6328_;
                                            phi_6329_ = _e2077;
                                            phi_6330_ = false;
                                        } else {
                                            phi_6329_ = u32();
                                            phi_6330_ = true;
                                        }
                                        let _e2079 = phi_6329_;
                                        let _e2081 = phi_6330_;
                                        phi_6331_ = _e2079;
                                        phi_6332_ = 0u;
                                        phi_6333_ = _e2081;
                                    } else {
                                        phi_6331_ = u32();
                                        phi_6332_ = 2u;
                                        phi_6333_ = true;
                                    }
                                    let _e2083 = phi_6331_;
                                    let _e2085 = phi_6332_;
                                    let _e2087 = phi_6333_;
                                    if _e2087 {
                                        phi_6337_ = _e2085;
                                    } else {
                                        phi_6337_ = _e2083;
                                    }
                                    let _e2089 = phi_6337_;
                                    let _e2090 = (_e2089 == 0u);
                                    if _e2090 {
                                        phi_8510_ = f32();
                                        phi_8511_ = false;
                                        phi_8512_ = false;
                                        phi_8513_ = false;
                                    } else {
                                        if (_e2089 == 1u) {
                                            if _e1390.member_2 {
                                                if ((_e1390.member_1 - _e1390.member) <= 0.0000005f) {
                                                    phi_6357_ = false;
                                                } else {
                                                    phi_6357_ = true;
                                                }
                                                let _e2098 = phi_6357_;
                                                phi_6358_ = _e2098;
                                            } else {
                                                phi_6358_ = true;
                                            }
                                            let _e2100 = phi_6358_;
                                            phi_6359_ = _e2100;
                                        } else {
                                            phi_6359_ = true;
                                        }
                                        let _e2102 = phi_6359_;
                                        if _e2102 {
                                            let _e2107 = local_12.member[0u];
                                            let _e2113 = local_12.member_1[0u];
                                            let _e2119 = local_12.member_2[0u];
                                            let _e2131 = local_12.member[1u];
                                            let _e2137 = local_12.member_1[1u];
                                            let _e2143 = local_12.member_2[1u];
                                            let _e2155 = local_12.member[0u];
                                            if (_e2155[0] < 0f) {
                                                phi_6507_ = -(_e2155[0]);
                                            } else {
                                                phi_6507_ = _e2155[0];
                                            }
                                            let _e2162 = phi_6507_;
                                            if (_e2155[1] < 0f) {
                                                phi_6514_ = -(_e2155[1]);
                                            } else {
                                                phi_6514_ = _e2155[1];
                                            }
                                            let _e2166 = phi_6514_;
                                            if (_e2162 > _e2166) {
                                                phi_6519_ = _e2162;
                                            } else {
                                                phi_6519_ = _e2166;
                                            }
                                            let _e2169 = phi_6519_;
                                            if (_e2155[2] < 0f) {
                                                phi_6526_ = -(_e2155[2]);
                                            } else {
                                                phi_6526_ = _e2155[2];
                                            }
                                            let _e2173 = phi_6526_;
                                            if (_e2169 > _e2173) {
                                                phi_6531_ = _e2169;
                                            } else {
                                                phi_6531_ = _e2173;
                                            }
                                            let _e2176 = phi_6531_;
                                            let _e2179 = local_12.member[1u];
                                            if (_e2179[0] < 0f) {
                                                phi_6544_ = -(_e2179[0]);
                                            } else {
                                                phi_6544_ = _e2179[0];
                                            }
                                            let _e2186 = phi_6544_;
                                            if (_e2179[1] < 0f) {
                                                phi_6551_ = -(_e2179[1]);
                                            } else {
                                                phi_6551_ = _e2179[1];
                                            }
                                            let _e2190 = phi_6551_;
                                            if (_e2186 > _e2190) {
                                                phi_6556_ = _e2186;
                                            } else {
                                                phi_6556_ = _e2190;
                                            }
                                            let _e2193 = phi_6556_;
                                            if (_e2179[2] < 0f) {
                                                phi_6563_ = -(_e2179[2]);
                                            } else {
                                                phi_6563_ = _e2179[2];
                                            }
                                            let _e2197 = phi_6563_;
                                            if (_e2193 > _e2197) {
                                                phi_6568_ = _e2193;
                                            } else {
                                                phi_6568_ = _e2197;
                                            }
                                            let _e2200 = phi_6568_;
                                            if (_e2176 > _e2200) {
                                                phi_6573_ = _e2176;
                                            } else {
                                                phi_6573_ = _e2200;
                                            }
                                            let _e2203 = phi_6573_;
                                            let _e2205 = local_12.member_3;
                                            let _e2209 = local_12.member_1[0u];
                                            if (_e2209[0] < 0f) {
                                                phi_6590_ = -(_e2209[0]);
                                            } else {
                                                phi_6590_ = _e2209[0];
                                            }
                                            let _e2216 = phi_6590_;
                                            if (_e2209[1] < 0f) {
                                                phi_6597_ = -(_e2209[1]);
                                            } else {
                                                phi_6597_ = _e2209[1];
                                            }
                                            let _e2220 = phi_6597_;
                                            if (_e2216 > _e2220) {
                                                phi_6602_ = _e2216;
                                            } else {
                                                phi_6602_ = _e2220;
                                            }
                                            let _e2223 = phi_6602_;
                                            if (_e2209[2] < 0f) {
                                                phi_6609_ = -(_e2209[2]);
                                            } else {
                                                phi_6609_ = _e2209[2];
                                            }
                                            let _e2227 = phi_6609_;
                                            if (_e2223 > _e2227) {
                                                phi_6614_ = _e2223;
                                            } else {
                                                phi_6614_ = _e2227;
                                            }
                                            let _e2230 = phi_6614_;
                                            let _e2233 = local_12.member_1[1u];
                                            if (_e2233[0] < 0f) {
                                                phi_6628_ = -(_e2233[0]);
                                            } else {
                                                phi_6628_ = _e2233[0];
                                            }
                                            let _e2240 = phi_6628_;
                                            if (_e2233[1] < 0f) {
                                                phi_6635_ = -(_e2233[1]);
                                            } else {
                                                phi_6635_ = _e2233[1];
                                            }
                                            let _e2244 = phi_6635_;
                                            if (_e2240 > _e2244) {
                                                phi_6640_ = _e2240;
                                            } else {
                                                phi_6640_ = _e2244;
                                            }
                                            let _e2247 = phi_6640_;
                                            if (_e2233[2] < 0f) {
                                                phi_6647_ = -(_e2233[2]);
                                            } else {
                                                phi_6647_ = _e2233[2];
                                            }
                                            let _e2251 = phi_6647_;
                                            if (_e2247 > _e2251) {
                                                phi_6652_ = _e2247;
                                            } else {
                                                phi_6652_ = _e2251;
                                            }
                                            let _e2254 = phi_6652_;
                                            if (_e2230 > _e2254) {
                                                phi_6657_ = _e2230;
                                            } else {
                                                phi_6657_ = _e2254;
                                            }
                                            let _e2257 = phi_6657_;
                                            let _e2259 = local_12.member_3;
                                            let _e2263 = local_12.member_2[0u];
                                            if (_e2263[0] < 0f) {
                                                phi_6674_ = -(_e2263[0]);
                                            } else {
                                                phi_6674_ = _e2263[0];
                                            }
                                            let _e2270 = phi_6674_;
                                            if (_e2263[1] < 0f) {
                                                phi_6681_ = -(_e2263[1]);
                                            } else {
                                                phi_6681_ = _e2263[1];
                                            }
                                            let _e2274 = phi_6681_;
                                            if (_e2270 > _e2274) {
                                                phi_6686_ = _e2270;
                                            } else {
                                                phi_6686_ = _e2274;
                                            }
                                            let _e2277 = phi_6686_;
                                            if (_e2263[2] < 0f) {
                                                phi_6693_ = -(_e2263[2]);
                                            } else {
                                                phi_6693_ = _e2263[2];
                                            }
                                            let _e2281 = phi_6693_;
                                            if (_e2277 > _e2281) {
                                                phi_6698_ = _e2277;
                                            } else {
                                                phi_6698_ = _e2281;
                                            }
                                            let _e2284 = phi_6698_;
                                            let _e2287 = local_12.member_2[1u];
                                            if (_e2287[0] < 0f) {
                                                phi_6712_ = -(_e2287[0]);
                                            } else {
                                                phi_6712_ = _e2287[0];
                                            }
                                            let _e2294 = phi_6712_;
                                            if (_e2287[1] < 0f) {
                                                phi_6719_ = -(_e2287[1]);
                                            } else {
                                                phi_6719_ = _e2287[1];
                                            }
                                            let _e2298 = phi_6719_;
                                            if (_e2294 > _e2298) {
                                                phi_6724_ = _e2294;
                                            } else {
                                                phi_6724_ = _e2298;
                                            }
                                            let _e2301 = phi_6724_;
                                            if (_e2287[2] < 0f) {
                                                phi_6731_ = -(_e2287[2]);
                                            } else {
                                                phi_6731_ = _e2287[2];
                                            }
                                            let _e2305 = phi_6731_;
                                            if (_e2301 > _e2305) {
                                                phi_6736_ = _e2301;
                                            } else {
                                                phi_6736_ = _e2305;
                                            }
                                            let _e2308 = phi_6736_;
                                            if (_e2284 > _e2308) {
                                                phi_6741_ = _e2284;
                                            } else {
                                                phi_6741_ = _e2308;
                                            }
                                            let _e2311 = phi_6741_;
                                            let _e2313 = local_12.member_3;
                                            let _e2320 = local_12.member_3;
                                            local = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6780_ = type_9(0u, 96u);
                                            phi_6783_ = _e1390.member;
                                            phi_6785_ = _e1390.member;
                                            phi_6787_ = _e1390.member;
                                            phi_6789_ = false;
                                            phi_6791_ = 0u;
                                            loop {
                                                let _e2326 = phi_6780_;
                                                let _e2328 = phi_6783_;
                                                let _e2330 = phi_6785_;
                                                let _e2332 = phi_6787_;
                                                let _e2334 = phi_6789_;
                                                let _e2336 = phi_6791_;
                                                local_36 = _e2330;
                                                local_20 = _e2328;
                                                if (_e2326.member < _e2326.member_1) {
                                                    phi_6781_ = type_9((_e2326.member + 1u), _e2326.member_1);
                                                    phi_6814_ = type_9(1u, _e2326.member);
                                                } else {
                                                    phi_6781_ = _e2326;
                                                    phi_6814_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2348 = phi_6781_;
                                                let _e2350 = phi_6814_;
                                                if (bitcast<i32>(_e2350.member) != 0i) {
                                                    let _e2356 = local_12.member[0u];
                                                    let _e2362 = local_12.member[1u];
                                                    let _e2378 = local_12.member_1[0u];
                                                    let _e2384 = local_12.member_1[1u];
                                                    let _e2400 = local_12.member_2[0u];
                                                    let _e2406 = local_12.member_2[1u];
                                                    let _e2420 = function_1(array<f32, 3>((_e2356[0] + ((_e2362[0] - _e2356[0]) * _e2328)), (_e2356[1] + ((_e2362[1] - _e2356[1]) * _e2328)), (_e2356[2] + ((_e2362[2] - _e2356[2]) * _e2328))), array<f32, 3>((_e2378[0] + ((_e2384[0] - _e2378[0]) * _e2328)), (_e2378[1] + ((_e2384[1] - _e2378[1]) * _e2328)), (_e2378[2] + ((_e2384[2] - _e2378[2]) * _e2328))), array<f32, 3>((_e2400[0] + ((_e2406[0] - _e2400[0]) * _e2328)), (_e2400[1] + ((_e2406[1] - _e2400[1]) * _e2328)), (_e2400[2] + ((_e2406[2] - _e2400[2]) * _e2328))), 0u);
                                                    if (_e2336 == 0u) {
                                                        phi_6942_ = _e2420;
                                                    } else {
                                                        if (_e2336 == 1u) {
                                                            phi_6928_ = _e2420[0];
                                                        } else {
                                                            phi_6928_ = 0f;
                                                        }
                                                        let _e2425 = phi_6928_;
                                                        if (_e2336 == 2u) {
                                                            phi_6934_ = _e2420[1];
                                                        } else {
                                                            phi_6934_ = 0f;
                                                        }
                                                        let _e2429 = phi_6934_;
                                                        if (_e2336 == 3u) {
                                                            phi_6940_ = _e2420[2];
                                                        } else {
                                                            phi_6940_ = 0f;
                                                        }
                                                        let _e2433 = phi_6940_;
                                                        phi_6942_ = array<f32, 3>(_e2425, _e2429, _e2433);
                                                    }
                                                    let _e2436 = phi_6942_;
                                                    if (_e2436[0] < 0f) {
                                                        phi_6949_ = -(_e2436[0]);
                                                    } else {
                                                        phi_6949_ = _e2436[0];
                                                    }
                                                    let _e2441 = phi_6949_;
                                                    if (_e2436[1] < 0f) {
                                                        phi_6956_ = -(_e2436[1]);
                                                    } else {
                                                        phi_6956_ = _e2436[1];
                                                    }
                                                    let _e2446 = phi_6956_;
                                                    if (_e2436[2] < 0f) {
                                                        phi_6964_ = -(_e2436[2]);
                                                    } else {
                                                        phi_6964_ = _e2436[2];
                                                    }
                                                    let _e2452 = phi_6964_;
                                                    let _e2453 = ((_e2441 + _e2446) + _e2452);
                                                    if (_e2453 > 0f) {
                                                        if ((bitcast<u32>(_e2453) & 2139095040u) != 2139095040u) {
                                                            let _e2458 = (1f / _e2453);
                                                            let _e2460 = (_e2436[0] * _e2458);
                                                            let _e2462 = (_e2436[1] * _e2458);
                                                            let _e2464 = (_e2436[2] * _e2458);
                                                            let _e2469 = (((_e2460 * _e2460) + (_e2462 * _e2462)) + (_e2464 * _e2464));
                                                            if (_e2469 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2469 > 0f) {
                                                                    phi_7001_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_7001_ = 0f;
                                                                }
                                                                let _e2522 = phi_7001_;
                                                                phi_7065_ = _e2522;
                                                            } else {
                                                                phi_7008_ = type_14(0i, 5i);
                                                                phi_7011_ = bitcast<f32>(((bitcast<u32>(_e2469) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2477 = phi_7008_;
                                                                    let _e2479 = phi_7011_;
                                                                    local_18 = _e2479;
                                                                    if (_e2477.member < _e2477.member_1) {
                                                                        let _e2486 = (_e2477.member + 1i);
                                                                        if ((false == (_e2486 > _e2477.member)) != false) {
                                                                            phi_7032_ = true;
                                                                        } else {
                                                                            phi_7032_ = false;
                                                                        }
                                                                        let _e2491 = phi_7032_;
                                                                        if _e2491 {
                                                                            phi_7038_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_7038_ = type_15(1u, _e2486);
                                                                        }
                                                                        let _e2496 = phi_7038_;
                                                                        phi_7009_ = type_14(_e2496.member_1, _e2477.member_1);
                                                                        phi_7052_ = type_15(1u, _e2477.member);
                                                                    } else {
                                                                        phi_7009_ = _e2477;
                                                                        phi_7052_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2502 = phi_7009_;
                                                                    let _e2504 = phi_7052_;
                                                                    let _e2507 = (bitcast<i32>(_e2504.member) != 0i);
                                                                    if _e2507 {
                                                                        phi_7012_ = (0.5f * (_e2479 + (_e2469 / _e2479)));
                                                                    } else {
                                                                        phi_7012_ = f32();
                                                                    }
                                                                    let _e2512 = phi_7012_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7008_ = _e2502;
                                                                        phi_7011_ = _e2512;
                                                                        break if !(_e2507);
                                                                    }
                                                                }
                                                                let _e2517 = local_18;
                                                                phi_7065_ = (_e2517 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2524 = phi_7065_;
                                                            let _e2525 = (0.000000059604645f * 12f);
                                                            let _e2530 = ((((((((_e2203 + _e2205) + (_e2257 + _e2259)) + (_e2311 + _e2313)) * (0.000000059604645f * 16f)) + (_e2320 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2524) * (1f + _e2525)));
                                                            let _e2535 = (((_e2460 * _e2107[0]) + (_e2462 * _e2107[1])) + (_e2464 * _e2107[2]));
                                                            let _e2540 = (((_e2460 * (_e2107[0] - _e2113[0])) + (_e2462 * (_e2107[1] - _e2113[1]))) + (_e2464 * (_e2107[2] - _e2113[2])));
                                                            let _e2545 = (((_e2460 * (_e2107[0] - _e2119[0])) + (_e2462 * (_e2107[1] - _e2119[1]))) + (_e2464 * (_e2107[2] - _e2119[2])));
                                                            let _e2550 = (((_e2460 * _e2107[0]) + (_e2462 * _e2107[1])) + (_e2464 * _e2107[2]));
                                                            let _e2556 = (((_e2460 * _e2131[0]) + (_e2462 * _e2131[1])) + (_e2464 * _e2131[2]));
                                                            let _e2561 = (((_e2460 * (_e2131[0] - _e2137[0])) + (_e2462 * (_e2131[1] - _e2137[1]))) + (_e2464 * (_e2131[2] - _e2137[2])));
                                                            let _e2566 = (((_e2460 * (_e2131[0] - _e2143[0])) + (_e2462 * (_e2131[1] - _e2143[1]))) + (_e2464 * (_e2131[2] - _e2143[2])));
                                                            let _e2571 = (((_e2460 * _e2131[0]) + (_e2462 * _e2131[1])) + (_e2464 * _e2131[2]));
                                                            if (_e2535 < 0f) {
                                                                phi_7131_ = -(_e2535);
                                                            } else {
                                                                phi_7131_ = _e2535;
                                                            }
                                                            let _e2576 = phi_7131_;
                                                            if (_e2556 < 0f) {
                                                                phi_7137_ = -(_e2556);
                                                            } else {
                                                                phi_7137_ = _e2556;
                                                            }
                                                            let _e2580 = phi_7137_;
                                                            if (_e2540 < 0f) {
                                                                phi_7146_ = -(_e2540);
                                                            } else {
                                                                phi_7146_ = _e2540;
                                                            }
                                                            let _e2587 = phi_7146_;
                                                            if (_e2561 < 0f) {
                                                                phi_7152_ = -(_e2561);
                                                            } else {
                                                                phi_7152_ = _e2561;
                                                            }
                                                            let _e2591 = phi_7152_;
                                                            if (_e2545 < 0f) {
                                                                phi_7161_ = -(_e2545);
                                                            } else {
                                                                phi_7161_ = _e2545;
                                                            }
                                                            let _e2598 = phi_7161_;
                                                            if (_e2566 < 0f) {
                                                                phi_7167_ = -(_e2566);
                                                            } else {
                                                                phi_7167_ = _e2566;
                                                            }
                                                            let _e2602 = phi_7167_;
                                                            if (_e2550 < 0f) {
                                                                phi_7176_ = -(_e2550);
                                                            } else {
                                                                phi_7176_ = _e2550;
                                                            }
                                                            let _e2609 = phi_7176_;
                                                            if (_e2571 < 0f) {
                                                                phi_7182_ = -(_e2571);
                                                            } else {
                                                                phi_7182_ = _e2571;
                                                            }
                                                            let _e2613 = phi_7182_;
                                                            phi_7188_ = type_31(array<f32, 4>(_e2535, _e2540, _e2545, _e2550), array<f32, 4>(_e2556, _e2561, _e2566, _e2571), array<f32, 4>((_e2530 + ((_e2576 + _e2580) * _e2525)), (_e2530 + ((_e2587 + _e2591) * _e2525)), (_e2530 + ((_e2598 + _e2602) * _e2525)), (_e2530 + ((_e2609 + _e2613) * _e2525))));
                                                            phi_7189_ = false;
                                                        } else {
                                                            phi_7188_ = type_31();
                                                            phi_7189_ = true;
                                                        }
                                                        let _e2620 = phi_7188_;
                                                        let _e2622 = phi_7189_;
                                                        phi_7190_ = _e2620;
                                                        phi_7191_ = _e2622;
                                                    } else {
                                                        phi_7190_ = type_31();
                                                        phi_7191_ = true;
                                                    }
                                                    let _e2624 = phi_7190_;
                                                    let _e2626 = phi_7191_;
                                                    if _e2626 {
                                                        phi_7199_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7199_ = _e2624;
                                                    }
                                                    let _e2628 = phi_7199_;
                                                    local_1 = type_31(array<f32, 4>(_e2628.member[0], _e2628.member[1], _e2628.member[2], _e2628.member[3]), array<f32, 4>(_e2628.member_1[0], _e2628.member_1[1], _e2628.member_1[2], _e2628.member_1[3]), array<f32, 4>(_e2628.member_2[0], _e2628.member_2[1], _e2628.member_2[2], _e2628.member_2[3]));
                                                    let _e2648 = (_e2328 - _e2332);
                                                    let _e2652 = local_1.member[0u];
                                                    let _e2655 = local_1.member_1[0u];
                                                    let _e2658 = local_1.member[0u];
                                                    let _e2664 = local_1.member_2[0u];
                                                    if (((_e2652 + ((_e2655 - _e2658) * _e2328)) - _e2664) > 0f) {
                                                        let _e2669 = local_1.member[1u];
                                                        let _e2672 = local_1.member_1[1u];
                                                        let _e2675 = local_1.member[1u];
                                                        let _e2681 = local_1.member_2[1u];
                                                        if (((_e2669 + ((_e2672 - _e2675) * _e2328)) - _e2681) > 0f) {
                                                            let _e2686 = local_1.member[2u];
                                                            let _e2689 = local_1.member_1[2u];
                                                            let _e2692 = local_1.member[2u];
                                                            let _e2698 = local_1.member_2[2u];
                                                            if (((_e2686 + ((_e2689 - _e2692) * _e2328)) - _e2698) > 0f) {
                                                                let _e2703 = local_1.member[3u];
                                                                let _e2706 = local_1.member_1[3u];
                                                                let _e2709 = local_1.member[3u];
                                                                let _e2715 = local_1.member_2[3u];
                                                                phi_7370_ = (((_e2703 + ((_e2706 - _e2709) * _e2328)) - _e2715) > 0f);
                                                                phi_7371_ = false;
                                                            } else {
                                                                phi_7370_ = bool();
                                                                phi_7371_ = true;
                                                            }
                                                            let _e2719 = phi_7370_;
                                                            let _e2721 = phi_7371_;
                                                            phi_7372_ = _e2719;
                                                            phi_7373_ = _e2721;
                                                        } else {
                                                            phi_7372_ = bool();
                                                            phi_7373_ = true;
                                                        }
                                                        let _e2723 = phi_7372_;
                                                        let _e2725 = phi_7373_;
                                                        phi_7374_ = _e2723;
                                                        phi_7375_ = _e2725;
                                                    } else {
                                                        phi_7374_ = bool();
                                                        phi_7375_ = true;
                                                    }
                                                    let _e2727 = phi_7374_;
                                                    let _e2729 = phi_7375_;
                                                    if _e2729 {
                                                        phi_7379_ = false;
                                                    } else {
                                                        phi_7379_ = _e2727;
                                                    }
                                                    let _e2731 = phi_7379_;
                                                    if _e2731 {
                                                        if (_e2328 <= _e2330) {
                                                            phi_7689_ = true;
                                                        } else {
                                                            let _e2735 = local.member[0u];
                                                            let _e2738 = local.member_1[0u];
                                                            let _e2741 = local.member[0u];
                                                            let _e2747 = local.member_2[0u];
                                                            let _e2751 = local_1.member[0u];
                                                            let _e2754 = local_1.member_1[0u];
                                                            let _e2757 = local_1.member[0u];
                                                            let _e2763 = local_1.member_2[0u];
                                                            if ((((_e2735 + ((_e2738 - _e2741) * _e2328)) - _e2747) + ((_e2751 + ((_e2754 - _e2757) * _e2332)) - _e2763)) > 0f) {
                                                                let _e2769 = local.member[1u];
                                                                let _e2772 = local.member_1[1u];
                                                                let _e2775 = local.member[1u];
                                                                let _e2781 = local.member_2[1u];
                                                                let _e2785 = local_1.member[1u];
                                                                let _e2788 = local_1.member_1[1u];
                                                                let _e2791 = local_1.member[1u];
                                                                let _e2797 = local_1.member_2[1u];
                                                                if ((((_e2769 + ((_e2772 - _e2775) * _e2328)) - _e2781) + ((_e2785 + ((_e2788 - _e2791) * _e2332)) - _e2797)) > 0f) {
                                                                    let _e2803 = local.member[2u];
                                                                    let _e2806 = local.member_1[2u];
                                                                    let _e2809 = local.member[2u];
                                                                    let _e2815 = local.member_2[2u];
                                                                    let _e2819 = local_1.member[2u];
                                                                    let _e2822 = local_1.member_1[2u];
                                                                    let _e2825 = local_1.member[2u];
                                                                    let _e2831 = local_1.member_2[2u];
                                                                    if ((((_e2803 + ((_e2806 - _e2809) * _e2328)) - _e2815) + ((_e2819 + ((_e2822 - _e2825) * _e2332)) - _e2831)) > 0f) {
                                                                        let _e2837 = local.member[3u];
                                                                        let _e2840 = local.member_1[3u];
                                                                        let _e2843 = local.member[3u];
                                                                        let _e2849 = local.member_2[3u];
                                                                        let _e2853 = local_1.member[3u];
                                                                        let _e2856 = local_1.member_1[3u];
                                                                        let _e2859 = local_1.member[3u];
                                                                        let _e2865 = local_1.member_2[3u];
                                                                        phi_7676_ = ((((_e2837 + ((_e2840 - _e2843) * _e2328)) - _e2849) + ((_e2853 + ((_e2856 - _e2859) * _e2332)) - _e2865)) > 0f);
                                                                        phi_7677_ = false;
                                                                    } else {
                                                                        phi_7676_ = bool();
                                                                        phi_7677_ = true;
                                                                    }
                                                                    let _e2870 = phi_7676_;
                                                                    let _e2872 = phi_7677_;
                                                                    phi_7678_ = _e2870;
                                                                    phi_7679_ = _e2872;
                                                                } else {
                                                                    phi_7678_ = bool();
                                                                    phi_7679_ = true;
                                                                }
                                                                let _e2874 = phi_7678_;
                                                                let _e2876 = phi_7679_;
                                                                phi_7680_ = _e2874;
                                                                phi_7681_ = _e2876;
                                                            } else {
                                                                phi_7680_ = bool();
                                                                phi_7681_ = true;
                                                            }
                                                            let _e2878 = phi_7680_;
                                                            let _e2880 = phi_7681_;
                                                            if _e2880 {
                                                                phi_7685_ = false;
                                                            } else {
                                                                phi_7685_ = _e2878;
                                                            }
                                                            let _e2882 = phi_7685_;
                                                            phi_7689_ = _e2882;
                                                        }
                                                        let _e2884 = phi_7689_;
                                                        if _e2884 {
                                                            if _e2334 {
                                                                if (_e2328 >= _e1390.member_1) {
                                                                    phi_7700_ = false;
                                                                } else {
                                                                    phi_7700_ = true;
                                                                }
                                                                let _e2887 = phi_7700_;
                                                                phi_7701_ = _e2887;
                                                            } else {
                                                                phi_7701_ = true;
                                                            }
                                                            let _e2889 = phi_7701_;
                                                            if _e2889 {
                                                                local = type_31(array<f32, 4>(_e2628.member[0], _e2628.member[1], _e2628.member[2], _e2628.member[3]), array<f32, 4>(_e2628.member_1[0], _e2628.member_1[1], _e2628.member_1[2], _e2628.member_1[3]), array<f32, 4>(_e2628.member_2[0], _e2628.member_2[1], _e2628.member_2[2], _e2628.member_2[3]));
                                                                let _e2911 = local.member[0u];
                                                                let _e2914 = local.member_1[0u];
                                                                let _e2917 = local.member_2[0u];
                                                                if (_e2911 > _e2917) {
                                                                    if (_e2914 > _e2917) {
                                                                        phi_7775_ = false;
                                                                    } else {
                                                                        phi_7775_ = true;
                                                                    }
                                                                    let _e2921 = phi_7775_;
                                                                    phi_7776_ = _e2921;
                                                                } else {
                                                                    phi_7776_ = true;
                                                                }
                                                                let _e2923 = phi_7776_;
                                                                if _e2923 {
                                                                    let _e2924 = (_e2914 >= _e2911);
                                                                    if _e2924 {
                                                                        phi_7798_ = f32();
                                                                        phi_7799_ = false;
                                                                    } else {
                                                                        if ((_e2911 - _e2914) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7796_ = (((_e2911 - _e2917) / (_e2911 - _e2914)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7797_ = false;
                                                                        } else {
                                                                            phi_7796_ = f32();
                                                                            phi_7797_ = true;
                                                                        }
                                                                        let _e2935 = phi_7796_;
                                                                        let _e2937 = phi_7797_;
                                                                        phi_7798_ = _e2935;
                                                                        phi_7799_ = _e2937;
                                                                    }
                                                                    let _e2939 = phi_7798_;
                                                                    let _e2941 = phi_7799_;
                                                                    phi_7800_ = _e2939;
                                                                    phi_7801_ = _e2924;
                                                                    phi_7802_ = _e2941;
                                                                } else {
                                                                    phi_7800_ = f32();
                                                                    phi_7801_ = true;
                                                                    phi_7802_ = false;
                                                                }
                                                                let _e2943 = phi_7800_;
                                                                let _e2945 = phi_7801_;
                                                                let _e2947 = phi_7802_;
                                                                if _e2945 {
                                                                    phi_7806_ = 2f;
                                                                    phi_7807_ = true;
                                                                } else {
                                                                    phi_7806_ = _e2328;
                                                                    phi_7807_ = _e2947;
                                                                }
                                                                let _e2949 = phi_7806_;
                                                                let _e2951 = phi_7807_;
                                                                if _e2951 {
                                                                    phi_7811_ = _e2949;
                                                                } else {
                                                                    phi_7811_ = _e2943;
                                                                }
                                                                let _e2953 = phi_7811_;
                                                                let _e2956 = local.member[1u];
                                                                let _e2959 = local.member_1[1u];
                                                                let _e2962 = local.member_2[1u];
                                                                if (_e2956 > _e2962) {
                                                                    if (_e2959 > _e2962) {
                                                                        phi_7843_ = false;
                                                                    } else {
                                                                        phi_7843_ = true;
                                                                    }
                                                                    let _e2966 = phi_7843_;
                                                                    phi_7844_ = _e2966;
                                                                } else {
                                                                    phi_7844_ = true;
                                                                }
                                                                let _e2968 = phi_7844_;
                                                                if _e2968 {
                                                                    let _e2969 = (_e2959 >= _e2956);
                                                                    if _e2969 {
                                                                        phi_7866_ = f32();
                                                                        phi_7867_ = false;
                                                                    } else {
                                                                        if ((_e2956 - _e2959) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7864_ = (((_e2956 - _e2962) / (_e2956 - _e2959)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7865_ = false;
                                                                        } else {
                                                                            phi_7864_ = f32();
                                                                            phi_7865_ = true;
                                                                        }
                                                                        let _e2980 = phi_7864_;
                                                                        let _e2982 = phi_7865_;
                                                                        phi_7866_ = _e2980;
                                                                        phi_7867_ = _e2982;
                                                                    }
                                                                    let _e2984 = phi_7866_;
                                                                    let _e2986 = phi_7867_;
                                                                    phi_7868_ = _e2984;
                                                                    phi_7869_ = _e2969;
                                                                    phi_7870_ = _e2986;
                                                                } else {
                                                                    phi_7868_ = f32();
                                                                    phi_7869_ = true;
                                                                    phi_7870_ = false;
                                                                }
                                                                let _e2988 = phi_7868_;
                                                                let _e2990 = phi_7869_;
                                                                let _e2992 = phi_7870_;
                                                                if _e2990 {
                                                                    phi_7874_ = 2f;
                                                                    phi_7875_ = true;
                                                                } else {
                                                                    phi_7874_ = _e2328;
                                                                    phi_7875_ = _e2992;
                                                                }
                                                                let _e2994 = phi_7874_;
                                                                let _e2996 = phi_7875_;
                                                                if _e2996 {
                                                                    phi_7879_ = _e2994;
                                                                } else {
                                                                    phi_7879_ = _e2988;
                                                                }
                                                                let _e2998 = phi_7879_;
                                                                if (_e2953 < _e2998) {
                                                                    phi_7884_ = _e2953;
                                                                } else {
                                                                    phi_7884_ = _e2998;
                                                                }
                                                                let _e3001 = phi_7884_;
                                                                let _e3004 = local.member[2u];
                                                                let _e3007 = local.member_1[2u];
                                                                let _e3010 = local.member_2[2u];
                                                                if (_e3004 > _e3010) {
                                                                    if (_e3007 > _e3010) {
                                                                        phi_7916_ = false;
                                                                    } else {
                                                                        phi_7916_ = true;
                                                                    }
                                                                    let _e3014 = phi_7916_;
                                                                    phi_7917_ = _e3014;
                                                                } else {
                                                                    phi_7917_ = true;
                                                                }
                                                                let _e3016 = phi_7917_;
                                                                if _e3016 {
                                                                    let _e3017 = (_e3007 >= _e3004);
                                                                    if _e3017 {
                                                                        phi_7939_ = f32();
                                                                        phi_7940_ = false;
                                                                    } else {
                                                                        if ((_e3004 - _e3007) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7937_ = (((_e3004 - _e3010) / (_e3004 - _e3007)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7938_ = false;
                                                                        } else {
                                                                            phi_7937_ = f32();
                                                                            phi_7938_ = true;
                                                                        }
                                                                        let _e3028 = phi_7937_;
                                                                        let _e3030 = phi_7938_;
                                                                        phi_7939_ = _e3028;
                                                                        phi_7940_ = _e3030;
                                                                    }
                                                                    let _e3032 = phi_7939_;
                                                                    let _e3034 = phi_7940_;
                                                                    phi_7941_ = _e3032;
                                                                    phi_7942_ = _e3017;
                                                                    phi_7943_ = _e3034;
                                                                } else {
                                                                    phi_7941_ = f32();
                                                                    phi_7942_ = true;
                                                                    phi_7943_ = false;
                                                                }
                                                                let _e3036 = phi_7941_;
                                                                let _e3038 = phi_7942_;
                                                                let _e3040 = phi_7943_;
                                                                if _e3038 {
                                                                    phi_7947_ = 2f;
                                                                    phi_7948_ = true;
                                                                } else {
                                                                    phi_7947_ = _e2328;
                                                                    phi_7948_ = _e3040;
                                                                }
                                                                let _e3042 = phi_7947_;
                                                                let _e3044 = phi_7948_;
                                                                if _e3044 {
                                                                    phi_7952_ = _e3042;
                                                                } else {
                                                                    phi_7952_ = _e3036;
                                                                }
                                                                let _e3046 = phi_7952_;
                                                                let _e3049 = local.member[3u];
                                                                let _e3052 = local.member_1[3u];
                                                                let _e3055 = local.member_2[3u];
                                                                if (_e3049 > _e3055) {
                                                                    if (_e3052 > _e3055) {
                                                                        phi_7984_ = false;
                                                                    } else {
                                                                        phi_7984_ = true;
                                                                    }
                                                                    let _e3059 = phi_7984_;
                                                                    phi_7985_ = _e3059;
                                                                } else {
                                                                    phi_7985_ = true;
                                                                }
                                                                let _e3061 = phi_7985_;
                                                                if _e3061 {
                                                                    let _e3062 = (_e3052 >= _e3049);
                                                                    if _e3062 {
                                                                        phi_8007_ = f32();
                                                                        phi_8008_ = false;
                                                                    } else {
                                                                        if ((_e3049 - _e3052) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8005_ = (((_e3049 - _e3055) / (_e3049 - _e3052)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8006_ = false;
                                                                        } else {
                                                                            phi_8005_ = f32();
                                                                            phi_8006_ = true;
                                                                        }
                                                                        let _e3073 = phi_8005_;
                                                                        let _e3075 = phi_8006_;
                                                                        phi_8007_ = _e3073;
                                                                        phi_8008_ = _e3075;
                                                                    }
                                                                    let _e3077 = phi_8007_;
                                                                    let _e3079 = phi_8008_;
                                                                    phi_8009_ = _e3077;
                                                                    phi_8010_ = _e3062;
                                                                    phi_8011_ = _e3079;
                                                                } else {
                                                                    phi_8009_ = f32();
                                                                    phi_8010_ = true;
                                                                    phi_8011_ = false;
                                                                }
                                                                let _e3081 = phi_8009_;
                                                                let _e3083 = phi_8010_;
                                                                let _e3085 = phi_8011_;
                                                                if _e3083 {
                                                                    phi_8015_ = 2f;
                                                                    phi_8016_ = true;
                                                                } else {
                                                                    phi_8015_ = _e2328;
                                                                    phi_8016_ = _e3085;
                                                                }
                                                                let _e3087 = phi_8015_;
                                                                let _e3089 = phi_8016_;
                                                                if _e3089 {
                                                                    phi_8020_ = _e3087;
                                                                } else {
                                                                    phi_8020_ = _e3081;
                                                                }
                                                                let _e3091 = phi_8020_;
                                                                if (_e3046 < _e3091) {
                                                                    phi_8025_ = _e3046;
                                                                } else {
                                                                    phi_8025_ = _e3091;
                                                                }
                                                                let _e3094 = phi_8025_;
                                                                if (_e3001 < _e3094) {
                                                                    phi_8030_ = _e3001;
                                                                } else {
                                                                    phi_8030_ = _e3094;
                                                                }
                                                                let _e3097 = phi_8030_;
                                                                if (_e3097 > _e2328) {
                                                                    phi_8035_ = _e3097;
                                                                } else {
                                                                    phi_8035_ = _e2328;
                                                                }
                                                                let _e3100 = phi_8035_;
                                                                let _e3101 = (_e3100 > _e1390.member_1);
                                                                if _e3101 {
                                                                    phi_8046_ = f32();
                                                                    phi_8047_ = false;
                                                                } else {
                                                                    if _e2334 {
                                                                        phi_8045_ = (_e2648 + _e2648);
                                                                    } else {
                                                                        phi_8045_ = (_e1390.member_1 - _e2328);
                                                                    }
                                                                    let _e3105 = phi_8045_;
                                                                    phi_8046_ = _e3105;
                                                                    phi_8047_ = true;
                                                                }
                                                                let _e3107 = phi_8046_;
                                                                let _e3109 = phi_8047_;
                                                                phi_8048_ = _e3100;
                                                                phi_8049_ = _e3107;
                                                                phi_8050_ = _e3109;
                                                                phi_8051_ = _e3101;
                                                                phi_8052_ = false;
                                                            } else {
                                                                phi_8048_ = f32();
                                                                phi_8049_ = f32();
                                                                phi_8050_ = false;
                                                                phi_8051_ = false;
                                                                phi_8052_ = true;
                                                            }
                                                            let _e3111 = phi_8048_;
                                                            let _e3113 = phi_8049_;
                                                            let _e3115 = phi_8050_;
                                                            let _e3117 = phi_8051_;
                                                            let _e3119 = phi_8052_;
                                                            phi_8053_ = _e3111;
                                                            phi_8054_ = _e3113;
                                                            phi_8055_ = false;
                                                            phi_8056_ = _e3115;
                                                            phi_8057_ = _e3117;
                                                            phi_8058_ = _e3119;
                                                        } else {
                                                            phi_8053_ = f32();
                                                            phi_8054_ = f32();
                                                            phi_8055_ = true;
                                                            phi_8056_ = false;
                                                            phi_8057_ = false;
                                                            phi_8058_ = false;
                                                        }
                                                        let _e3121 = phi_8053_;
                                                        let _e3123 = phi_8054_;
                                                        let _e3125 = phi_8055_;
                                                        let _e3127 = phi_8056_;
                                                        let _e3129 = phi_8057_;
                                                        let _e3131 = phi_8058_;
                                                        phi_8059_ = _e3121;
                                                        phi_8060_ = _e3123;
                                                        phi_8061_ = _e3125;
                                                        phi_8062_ = _e3127;
                                                        phi_8063_ = _e3129;
                                                        phi_8064_ = _e3131;
                                                    } else {
                                                        phi_8059_ = f32();
                                                        phi_8060_ = f32();
                                                        phi_8061_ = true;
                                                        phi_8062_ = false;
                                                        phi_8063_ = false;
                                                        phi_8064_ = false;
                                                    }
                                                    let _e3133 = phi_8059_;
                                                    let _e3135 = phi_8060_;
                                                    let _e3137 = phi_8061_;
                                                    let _e3139 = phi_8062_;
                                                    let _e3141 = phi_8063_;
                                                    let _e3143 = phi_8064_;
                                                    if _e3137 {
                                                        if (_e2328 <= _e2330) {
                                                            let _e3304 = (_e2336 + 1u);
                                                            let _e3305 = (_e3304 > 3u);
                                                            if _e3305 {
                                                                phi_8077_ = false;
                                                            } else {
                                                                phi_8077_ = true;
                                                            }
                                                            let _e3307 = phi_8077_;
                                                            phi_8399_ = _e3304;
                                                            phi_8400_ = f32();
                                                            phi_8401_ = false;
                                                            phi_8402_ = _e3307;
                                                            phi_8403_ = _e3305;
                                                        } else {
                                                            let _e3147 = local.member[0u];
                                                            let _e3150 = local.member_1[0u];
                                                            let _e3153 = local.member[0u];
                                                            let _e3159 = local.member_2[0u];
                                                            let _e3160 = ((_e3147 + ((_e3150 - _e3153) * _e2332)) - _e3159);
                                                            let _e3163 = local.member[1u];
                                                            let _e3166 = local.member_1[1u];
                                                            let _e3169 = local.member[1u];
                                                            let _e3175 = local.member_2[1u];
                                                            let _e3176 = ((_e3163 + ((_e3166 - _e3169) * _e2332)) - _e3175);
                                                            if (_e3160 < _e3176) {
                                                                phi_8150_ = _e3160;
                                                            } else {
                                                                phi_8150_ = _e3176;
                                                            }
                                                            let _e3179 = phi_8150_;
                                                            let _e3182 = local.member[2u];
                                                            let _e3185 = local.member_1[2u];
                                                            let _e3188 = local.member[2u];
                                                            let _e3194 = local.member_2[2u];
                                                            let _e3195 = ((_e3182 + ((_e3185 - _e3188) * _e2332)) - _e3194);
                                                            let _e3198 = local.member[3u];
                                                            let _e3201 = local.member_1[3u];
                                                            let _e3204 = local.member[3u];
                                                            let _e3210 = local.member_2[3u];
                                                            let _e3211 = ((_e3198 + ((_e3201 - _e3204) * _e2332)) - _e3210);
                                                            if (_e3195 < _e3211) {
                                                                phi_8223_ = _e3195;
                                                            } else {
                                                                phi_8223_ = _e3211;
                                                            }
                                                            let _e3214 = phi_8223_;
                                                            if (_e3179 < _e3214) {
                                                                phi_8228_ = _e3179;
                                                            } else {
                                                                phi_8228_ = _e3214;
                                                            }
                                                            let _e3217 = phi_8228_;
                                                            let _e3220 = local_1.member[0u];
                                                            let _e3223 = local_1.member_1[0u];
                                                            let _e3226 = local_1.member[0u];
                                                            let _e3232 = local_1.member_2[0u];
                                                            let _e3233 = ((_e3220 + ((_e3223 - _e3226) * _e2328)) - _e3232);
                                                            let _e3236 = local_1.member[1u];
                                                            let _e3239 = local_1.member_1[1u];
                                                            let _e3242 = local_1.member[1u];
                                                            let _e3248 = local_1.member_2[1u];
                                                            let _e3249 = ((_e3236 + ((_e3239 - _e3242) * _e2328)) - _e3248);
                                                            if (_e3233 < _e3249) {
                                                                phi_8301_ = _e3233;
                                                            } else {
                                                                phi_8301_ = _e3249;
                                                            }
                                                            let _e3252 = phi_8301_;
                                                            let _e3255 = local_1.member[2u];
                                                            let _e3258 = local_1.member_1[2u];
                                                            let _e3261 = local_1.member[2u];
                                                            let _e3267 = local_1.member_2[2u];
                                                            let _e3268 = ((_e3255 + ((_e3258 - _e3261) * _e2328)) - _e3267);
                                                            let _e3271 = local_1.member[3u];
                                                            let _e3274 = local_1.member_1[3u];
                                                            let _e3277 = local_1.member[3u];
                                                            let _e3283 = local_1.member_2[3u];
                                                            let _e3284 = ((_e3271 + ((_e3274 - _e3277) * _e2328)) - _e3283);
                                                            if (_e3268 < _e3284) {
                                                                phi_8374_ = _e3268;
                                                            } else {
                                                                phi_8374_ = _e3284;
                                                            }
                                                            let _e3287 = phi_8374_;
                                                            if (_e3252 < _e3287) {
                                                                phi_8379_ = _e3252;
                                                            } else {
                                                                phi_8379_ = _e3287;
                                                            }
                                                            let _e3290 = phi_8379_;
                                                            if (_e3290 > 0f) {
                                                                phi_8397_ = 0.5f;
                                                            } else {
                                                                let _e3294 = (0.95f * (_e3217 / (_e3217 - _e3290)));
                                                                if (_e3294 > 0.0625f) {
                                                                    if (_e3294 < 0.9f) {
                                                                        phi_8395_ = _e3294;
                                                                    } else {
                                                                        phi_8395_ = 0.9f;
                                                                    }
                                                                    let _e3298 = phi_8395_;
                                                                    phi_8396_ = _e3298;
                                                                } else {
                                                                    phi_8396_ = 0.0625f;
                                                                }
                                                                let _e3300 = phi_8396_;
                                                                phi_8397_ = _e3300;
                                                            }
                                                            let _e3302 = phi_8397_;
                                                            phi_8399_ = u32();
                                                            phi_8400_ = (_e2648 * _e3302);
                                                            phi_8401_ = true;
                                                            phi_8402_ = false;
                                                            phi_8403_ = false;
                                                        }
                                                        let _e3309 = phi_8399_;
                                                        let _e3311 = phi_8400_;
                                                        let _e3313 = phi_8401_;
                                                        let _e3315 = phi_8402_;
                                                        let _e3317 = phi_8403_;
                                                        phi_8404_ = _e3309;
                                                        phi_8405_ = _e2330;
                                                        phi_8406_ = _e3311;
                                                        phi_8407_ = _e2332;
                                                        phi_8408_ = _e2334;
                                                        phi_8409_ = _e2336;
                                                        phi_8410_ = _e3313;
                                                        phi_8411_ = _e3315;
                                                        phi_8412_ = _e3317;
                                                        phi_8413_ = false;
                                                        phi_8414_ = false;
                                                    } else {
                                                        phi_8404_ = u32();
                                                        phi_8405_ = _e3133;
                                                        phi_8406_ = _e3135;
                                                        phi_8407_ = _e2328;
                                                        phi_8408_ = true;
                                                        phi_8409_ = 0u;
                                                        phi_8410_ = _e3139;
                                                        phi_8411_ = false;
                                                        phi_8412_ = false;
                                                        phi_8413_ = _e3141;
                                                        phi_8414_ = _e3143;
                                                    }
                                                    let _e3319 = phi_8404_;
                                                    let _e3321 = phi_8405_;
                                                    let _e3323 = phi_8406_;
                                                    let _e3325 = phi_8407_;
                                                    let _e3327 = phi_8408_;
                                                    let _e3329 = phi_8409_;
                                                    let _e3331 = phi_8410_;
                                                    let _e3333 = phi_8411_;
                                                    let _e3335 = phi_8412_;
                                                    let _e3337 = phi_8413_;
                                                    let _e3339 = phi_8414_;
                                                    if _e3331 {
                                                        let _e3340 = (_e3325 + _e3323);
                                                        if (_e3340 > _e3321) {
                                                            phi_8423_ = _e3340;
                                                        } else {
                                                            phi_8423_ = _e3321;
                                                        }
                                                        let _e3343 = phi_8423_;
                                                        if (_e3343 < _e1390.member_1) {
                                                            phi_8428_ = _e3343;
                                                        } else {
                                                            phi_8428_ = _e1390.member_1;
                                                        }
                                                        let _e3346 = phi_8428_;
                                                        if !(_e2334) {
                                                            phi_8437_ = true;
                                                        } else {
                                                            phi_8437_ = ((_e3346 - _e3325) > 0.0000000037252903f);
                                                        }
                                                        let _e3350 = phi_8437_;
                                                        if _e3350 {
                                                            phi_8441_ = false;
                                                        } else {
                                                            phi_8441_ = true;
                                                        }
                                                        let _e3352 = phi_8441_;
                                                        phi_8442_ = _e3346;
                                                        phi_8443_ = _e3321;
                                                        phi_8444_ = _e3325;
                                                        phi_8445_ = _e3327;
                                                        phi_8446_ = _e3329;
                                                        phi_8447_ = _e3350;
                                                        phi_8448_ = _e3352;
                                                        phi_8449_ = false;
                                                        phi_8450_ = false;
                                                        phi_8451_ = false;
                                                    } else {
                                                        phi_8442_ = _e2328;
                                                        phi_8443_ = _e2330;
                                                        phi_8444_ = _e2332;
                                                        phi_8445_ = _e2334;
                                                        phi_8446_ = _e3319;
                                                        phi_8447_ = _e3333;
                                                        phi_8448_ = false;
                                                        phi_8449_ = _e3335;
                                                        phi_8450_ = _e3337;
                                                        phi_8451_ = _e3339;
                                                    }
                                                    let _e3354 = phi_8442_;
                                                    let _e3356 = phi_8443_;
                                                    let _e3358 = phi_8444_;
                                                    let _e3360 = phi_8445_;
                                                    let _e3362 = phi_8446_;
                                                    let _e3364 = phi_8447_;
                                                    let _e3366 = phi_8448_;
                                                    let _e3368 = phi_8449_;
                                                    let _e3370 = phi_8450_;
                                                    let _e3372 = phi_8451_;
                                                    phi_6784_ = _e3354;
                                                    phi_6786_ = _e3356;
                                                    phi_6788_ = _e3358;
                                                    phi_6790_ = _e3360;
                                                    phi_6792_ = _e3362;
                                                    phi_8452_ = _e3321;
                                                    phi_8453_ = _e3364;
                                                    phi_8454_ = _e3366;
                                                    phi_8455_ = false;
                                                    phi_8456_ = _e3368;
                                                    phi_8457_ = _e3370;
                                                    phi_8458_ = _e3372;
                                                } else {
                                                    phi_6784_ = f32();
                                                    phi_6786_ = f32();
                                                    phi_6788_ = f32();
                                                    phi_6790_ = bool();
                                                    phi_6792_ = u32();
                                                    phi_8452_ = f32();
                                                    phi_8453_ = false;
                                                    phi_8454_ = false;
                                                    phi_8455_ = true;
                                                    phi_8456_ = false;
                                                    phi_8457_ = false;
                                                    phi_8458_ = false;
                                                }
                                                let _e3374 = phi_6784_;
                                                let _e3376 = phi_6786_;
                                                let _e3378 = phi_6788_;
                                                let _e3380 = phi_6790_;
                                                let _e3382 = phi_6792_;
                                                let _e3384 = phi_8452_;
                                                let _e3386 = phi_8453_;
                                                let _e3388 = phi_8454_;
                                                let _e3390 = phi_8455_;
                                                let _e3392 = phi_8456_;
                                                let _e3394 = phi_8457_;
                                                let _e3396 = phi_8458_;
                                                local_19 = _e3388;
                                                local_35 = _e3384;
                                                local_37 = _e3390;
                                                local_38 = _e3392;
                                                local_39 = _e3394;
                                                local_40 = _e3396;
                                                continue;
                                                continuing {
                                                    phi_6780_ = _e2348;
                                                    phi_6783_ = _e3374;
                                                    phi_6785_ = _e3376;
                                                    phi_6787_ = _e3378;
                                                    phi_6789_ = _e3380;
                                                    phi_6791_ = _e3382;
                                                    break if !(_e3386);
                                                }
                                            }
                                            let _e3399 = local_19;
                                            if _e3399 {
                                                let _e5886 = local_35;
                                                phi_8462_ = _e5886;
                                                phi_8463_ = true;
                                                phi_8464_ = false;
                                                phi_8465_ = false;
                                                phi_8466_ = false;
                                            } else {
                                                let _e5888 = local_36;
                                                phi_8462_ = _e5888;
                                                let _e5891 = local_37;
                                                phi_8463_ = _e5891;
                                                let _e5894 = local_38;
                                                phi_8464_ = _e5894;
                                                let _e5897 = local_39;
                                                phi_8465_ = _e5897;
                                                let _e5900 = local_40;
                                                phi_8466_ = _e5900;
                                            }
                                            let _e3401 = phi_8462_;
                                            let _e3403 = phi_8463_;
                                            let _e3405 = phi_8464_;
                                            let _e3407 = phi_8465_;
                                            let _e3409 = phi_8466_;
                                            if _e3403 {
                                                phi_8471_ = type_28(1u, _e3401);
                                                phi_8472_ = false;
                                                phi_8473_ = false;
                                                phi_8474_ = false;
                                            } else {
                                                phi_8471_ = type_28();
                                                phi_8472_ = _e3405;
                                                phi_8473_ = _e3407;
                                                phi_8474_ = _e3409;
                                            }
                                            let _e3412 = phi_8471_;
                                            let _e3414 = phi_8472_;
                                            let _e3416 = phi_8473_;
                                            let _e3418 = phi_8474_;
                                            if _e3414 {
                                                let _e3420 = local_20;
                                                phi_8479_ = type_28(1u, _e3420);
                                                phi_8480_ = false;
                                                phi_8481_ = false;
                                            } else {
                                                phi_8479_ = type_28();
                                                phi_8480_ = _e3416;
                                                phi_8481_ = _e3418;
                                            }
                                            let _e3423 = phi_8479_;
                                            let _e3425 = phi_8480_;
                                            let _e3427 = phi_8481_;
                                            if _e3425 {
                                                phi_8486_ = type_28(0u, type_28().member_1);
                                                phi_8487_ = false;
                                                phi_8488_ = true;
                                            } else {
                                                phi_8486_ = _e3423;
                                                phi_8487_ = _e3427;
                                                phi_8488_ = _e3414;
                                            }
                                            let _e3431 = phi_8486_;
                                            let _e3433 = phi_8487_;
                                            let _e3435 = phi_8488_;
                                            if _e3433 {
                                                phi_8493_ = type_28(0u, type_28().member_1);
                                                phi_8494_ = true;
                                            } else {
                                                phi_8493_ = _e3431;
                                                phi_8494_ = _e3435;
                                            }
                                            let _e3439 = phi_8493_;
                                            let _e3441 = phi_8494_;
                                            if _e3441 {
                                                phi_8498_ = _e3439;
                                            } else {
                                                phi_8498_ = _e3412;
                                            }
                                            let _e3443 = phi_8498_;
                                            let _e3446 = (_e3443.member != 0u);
                                            if _e3446 {
                                                phi_8505_ = false;
                                            } else {
                                                phi_8505_ = true;
                                            }
                                            let _e3448 = phi_8505_;
                                            phi_8506_ = _e3443.member_1;
                                            phi_8507_ = _e3448;
                                            phi_8508_ = _e3446;
                                            phi_8509_ = false;
                                        } else {
                                            phi_8506_ = f32();
                                            phi_8507_ = false;
                                            phi_8508_ = false;
                                            phi_8509_ = true;
                                        }
                                        let _e3450 = phi_8506_;
                                        let _e3452 = phi_8507_;
                                        let _e3454 = phi_8508_;
                                        let _e3456 = phi_8509_;
                                        phi_8510_ = _e3450;
                                        phi_8511_ = _e3452;
                                        phi_8512_ = _e3454;
                                        phi_8513_ = _e3456;
                                    }
                                    let _e3458 = phi_8510_;
                                    let _e3460 = phi_8511_;
                                    let _e3462 = phi_8512_;
                                    let _e3464 = phi_8513_;
                                    phi_8514_ = _e3458;
                                    phi_8515_ = _e2090;
                                    phi_8516_ = _e3460;
                                    phi_8517_ = _e3462;
                                    phi_8518_ = _e3464;
                                }
                                let _e3466 = phi_8514_;
                                let _e3468 = phi_8515_;
                                let _e3470 = phi_8516_;
                                let _e3472 = phi_8517_;
                                let _e3474 = phi_8518_;
                                if _e3468 {
                                    phi_8522_ = true;
                                    phi_8523_ = false;
                                    phi_8524_ = false;
                                } else {
                                    phi_8522_ = _e3470;
                                    phi_8523_ = _e3472;
                                    phi_8524_ = _e3474;
                                }
                                let _e3476 = phi_8522_;
                                let _e3478 = phi_8523_;
                                let _e3480 = phi_8524_;
                                phi_8525_ = _e3466;
                                phi_8526_ = _e1390;
                                phi_8527_ = _e3476;
                                phi_8528_ = false;
                                phi_8529_ = _e3478;
                                phi_8530_ = _e3480;
                            } else {
                                phi_8525_ = f32();
                                phi_8526_ = type_37();
                                phi_8527_ = false;
                                phi_8528_ = true;
                                phi_8529_ = false;
                                phi_8530_ = false;
                            }
                            let _e3482 = phi_8525_;
                            let _e3484 = phi_8526_;
                            let _e3486 = phi_8527_;
                            let _e3488 = phi_8528_;
                            let _e3490 = phi_8529_;
                            let _e3492 = phi_8530_;
                            local_21 = _e3488;
                            local_41 = _e3490;
                            local_42 = _e3492;
                            local_22 = _e3482;
                            local_23 = _e3484;
                            continue;
                            continuing {
                                phi_4905_ = _e1120;
                                break if !(_e3486);
                            }
                        }
                        let _e3495 = local_21;
                        if _e3495 {
                            phi_8535_ = type_28(0u, type_28().member_1);
                            phi_8536_ = false;
                            phi_8537_ = false;
                        } else {
                            phi_8535_ = type_28();
                            let _e5942 = local_41;
                            phi_8536_ = _e5942;
                            let _e5945 = local_42;
                            phi_8537_ = _e5945;
                        }
                        let _e3499 = phi_8535_;
                        let _e3501 = phi_8536_;
                        let _e3503 = phi_8537_;
                        if _e3501 {
                            let _e3505 = local_22;
                            phi_8542_ = type_28(2u, _e3505);
                            phi_8543_ = false;
                        } else {
                            phi_8542_ = type_28();
                            phi_8543_ = _e3503;
                        }
                        let _e3508 = phi_8542_;
                        let _e3510 = phi_8543_;
                        if _e3510 {
                            let _e3512 = local_23;
                            phi_8549_ = type_28(1u, _e3512.member);
                            phi_8550_ = true;
                        } else {
                            phi_8549_ = _e3508;
                            phi_8550_ = _e3501;
                        }
                        let _e3516 = phi_8549_;
                        let _e3518 = phi_8550_;
                        if _e3518 {
                            phi_8554_ = _e3516;
                        } else {
                            phi_8554_ = _e3499;
                        }
                        let _e3520 = phi_8554_;
                        phi_8558_ = _e3520;
                    }
                    let _e5235 = phi_8558_;
                    phi_8559_ = _e5235;
                }
                let _e5239 = phi_8559_;
                switch bitcast<i32>(_e5239.member) {
                    case 0: {
                        phi_8572_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5245 = function_2(_e5239.member_1);
                        phi_8572_ = type_38(0u, _e5245, true);
                        break;
                    }
                    case 2: {
                        let _e5243 = function_2(_e5239.member_1);
                        phi_8572_ = type_38(1u, _e5243, true);
                        break;
                    }
                    default: {
                        phi_8572_ = type_38();
                        break;
                    }
                }
                let _e5248 = phi_8572_;
                if _e5248.member_2 {
                    phi_8579_ = (_e5248.member == 0u);
                } else {
                    phi_8579_ = false;
                }
                let _e5253 = phi_8579_;
                if _e5253 {
                    let _e5261 = (_e5248.member_1[1] >> bitcast<u32>(20i));
                    if (_e5261 <= 896u) {
                        phi_8603_ = 0u;
                    } else {
                        phi_8603_ = ((((_e5261 - 896u) << bitcast<u32>(23i)) | ((_e5248.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5248.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5276 = phi_8603_;
                    let _e5278 = atomicMin((&earliest.member[0u]), _e5276);
                }
                phi_8607_ = type_20(0u, 0u, _e176, _e179, _e5248.member_1);
                phi_8608_ = _e5253;
                phi_8609_ = (_e5248.member != 0u);
            } else {
                phi_8607_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8608_ = false;
                phi_8609_ = false;
            }
            let _e5280 = phi_8607_;
            let _e5282 = phi_8608_;
            let _e5284 = phi_8609_;
            let _e5287 = params.member.member.member_1;
            if ((_e5287 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5282 {
                    let _e5293 = atomicAdd((&counters[0u]), 1u);
                    phi_8628_ = _e5293;
                } else {
                    phi_8628_ = 0u;
                }
                let _e5295 = phi_8628_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5298 = atomicLoad((&counters[0u]));
                    if (_e5298 > 0u) {
                        let _e5301 = atomicAdd((&contacts.member[0u]), _e5298);
                        atomicStore((&counters[1u]), _e5301);
                    }
                }
                workgroupBarrier();
                let _e5304 = atomicLoad((&counters[1u]));
                let _e5305 = (_e5304 + _e5295);
                if _e5282 {
                    let _e5308 = params.member.member_1.member_3;
                    if (_e5305 < _e5308) {
                        let _e5310 = (6u * _e5305);
                        atomicStore((&contacts.member[(4u + _e5310)]), _e5280.member);
                        atomicStore((&contacts.member[(_e5310 + 5u)]), _e5280.member_1);
                        atomicStore((&contacts.member[(_e5310 + 6u)]), _e5280.member_2);
                        atomicStore((&contacts.member[(_e5310 + 7u)]), _e5280.member_3);
                        atomicStore((&contacts.member[(_e5310 + 8u)]), _e5280.member_4[0]);
                        atomicStore((&contacts.member[(_e5310 + 9u)]), _e5280.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5284 {
                let _e5334 = atomicAdd((&counters[0u]), 1u);
                phi_8691_ = _e5334;
            } else {
                phi_8691_ = 0u;
            }
            let _e5336 = phi_8691_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5339 = atomicLoad((&counters[0u]));
                if (_e5339 > 0u) {
                    let _e5342 = atomicAdd((&undecided.member[0u]), _e5339);
                    atomicStore((&counters[1u]), _e5342);
                }
            }
            workgroupBarrier();
            let _e5345 = atomicLoad((&counters[1u]));
            let _e5346 = (_e5345 + _e5336);
            if _e5284 {
                let _e5349 = params.member.member_2.member;
                if (_e5346 < _e5349) {
                    let _e5353 = (2u * _e5346);
                    atomicStore((&undecided.member[(4u + _e5353)]), _e5280.member_2);
                    atomicStore((&undecided.member[(_e5353 + 5u)]), _e5280.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_808_ = _e161;
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
