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
var<storage> input: type_10;
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
    var phi_808_: type_12;
    var phi_809_: type_12;
    var phi_832_: type_12;
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
    var phi_5164_: f32;
    var phi_5170_: f32;
    var phi_5175_: f32;
    var phi_5181_: f32;
    var phi_5187_: f32;
    var phi_5192_: f32;
    var phi_5197_: f32;
    var phi_5205_: bool;
    var phi_5210_: f32;
    var phi_5217_: f32;
    var phi_5257_: type_14;
    var phi_5260_: f32;
    var phi_5281_: bool;
    var phi_5287_: type_15;
    var phi_5258_: type_14;
    var phi_5301_: type_15;
    var phi_5261_: f32;
    var local_13: f32;
    var phi_5250_: f32;
    var phi_5314_: f32;
    var phi_5320_: f32;
    var phi_5345_: type_12;
    var phi_5348_: u32;
    var phi_5346_: type_12;
    var phi_5371_: type_12;
    var phi_5415_: u32;
    var phi_5416_: u32;
    var phi_5349_: u32;
    var phi_5417_: u32;
    var phi_5437_: type_12;
    var phi_5438_: type_12;
    var phi_5461_: type_12;
    var phi_5513_: f32;
    var phi_5520_: f32;
    var phi_5531_: bool;
    var phi_5532_: bool;
    var phi_5533_: bool;
    var phi_5534_: bool;
    var phi_5538_: bool;
    var phi_5549_: type_37;
    var phi_5550_: type_37;
    var phi_5551_: bool;
    var phi_5552_: type_37;
    var phi_5553_: bool;
    var phi_5564_: f32;
    var phi_5574_: type_12;
    var phi_5577_: f32;
    var phi_5579_: f32;
    var phi_5581_: f32;
    var phi_5575_: type_12;
    var phi_5604_: type_12;
    var phi_5629_: f32;
    var phi_5630_: f32;
    var phi_5656_: f32;
    var phi_5672_: f32;
    var phi_5679_: bool;
    var phi_5680_: bool;
    var phi_5681_: bool;
    var phi_5687_: f32;
    var phi_5688_: f32;
    var phi_5689_: bool;
    var phi_5578_: f32;
    var phi_5580_: f32;
    var phi_5582_: f32;
    var phi_5690_: f32;
    var phi_5691_: bool;
    var phi_5692_: bool;
    var local_14: bool;
    var phi_5696_: f32;
    var phi_5697_: f32;
    var phi_5705_: f32;
    var phi_5709_: type_12;
    var phi_5712_: f32;
    var phi_5710_: type_12;
    var phi_5735_: type_12;
    var phi_5765_: f32;
    var phi_5766_: bool;
    var phi_5767_: f32;
    var phi_5768_: bool;
    var phi_5769_: bool;
    var phi_5770_: bool;
    var phi_5771_: f32;
    var phi_5713_: f32;
    var phi_5772_: bool;
    var phi_5773_: bool;
    var phi_5774_: bool;
    var phi_5775_: bool;
    var local_15: bool;
    var phi_5779_: bool;
    var phi_5780_: bool;
    var phi_5784_: bool;
    var phi_5788_: f32;
    var phi_5789_: f32;
    var phi_5791_: type_37;
    var phi_5820_: f32;
    var phi_5827_: f32;
    var phi_5832_: f32;
    var phi_5839_: f32;
    var phi_5844_: f32;
    var phi_5857_: f32;
    var phi_5864_: f32;
    var phi_5869_: f32;
    var phi_5876_: f32;
    var phi_5881_: f32;
    var phi_5886_: f32;
    var phi_5945_: f32;
    var phi_5951_: f32;
    var phi_5956_: f32;
    var phi_5962_: f32;
    var phi_5967_: f32;
    var phi_5979_: f32;
    var phi_5985_: f32;
    var phi_5990_: f32;
    var phi_5996_: f32;
    var phi_6001_: f32;
    var phi_6027_: f32;
    var phi_6034_: f32;
    var phi_6039_: f32;
    var phi_6046_: f32;
    var phi_6051_: f32;
    var phi_6064_: f32;
    var phi_6071_: f32;
    var phi_6076_: f32;
    var phi_6083_: f32;
    var phi_6088_: f32;
    var phi_6093_: f32;
    var phi_6152_: f32;
    var phi_6158_: f32;
    var phi_6163_: f32;
    var phi_6169_: f32;
    var phi_6174_: f32;
    var phi_6186_: f32;
    var phi_6192_: f32;
    var phi_6197_: f32;
    var phi_6203_: f32;
    var phi_6208_: f32;
    var phi_6234_: f32;
    var phi_6241_: f32;
    var phi_6246_: f32;
    var phi_6253_: f32;
    var phi_6258_: f32;
    var phi_6271_: f32;
    var phi_6278_: f32;
    var phi_6283_: f32;
    var phi_6290_: f32;
    var phi_6295_: f32;
    var phi_6300_: f32;
    var phi_6359_: f32;
    var phi_6365_: f32;
    var phi_6370_: f32;
    var phi_6376_: f32;
    var phi_6381_: f32;
    var phi_6393_: f32;
    var phi_6399_: f32;
    var phi_6404_: f32;
    var phi_6410_: f32;
    var phi_6415_: f32;
    var phi_6464_: f32;
    var phi_6470_: f32;
    var phi_6498_: f32;
    var phi_6504_: f32;
    var phi_6509_: u32;
    var phi_6510_: u32;
    var phi_6480_: f32;
    var phi_6486_: f32;
    var phi_6491_: u32;
    var phi_6492_: u32;
    var phi_6511_: u32;
    var phi_6512_: u32;
    var phi_6581_: f32;
    var phi_6590_: f32;
    var phi_6725_: f32;
    var phi_6731_: f32;
    var phi_6738_: f32;
    var phi_6793_: type_12;
    var phi_6796_: bool;
    var phi_6794_: type_12;
    var phi_6819_: type_12;
    var phi_6846_: bool;
    var phi_6847_: bool;
    var phi_6797_: bool;
    var phi_6848_: bool;
    var phi_6849_: bool;
    var local_16: bool;
    var phi_6853_: bool;
    var local_17: bool;
    var phi_6860_: u32;
    var phi_6861_: u32;
    var phi_6862_: bool;
    var phi_6863_: u32;
    var phi_6864_: u32;
    var phi_6865_: bool;
    var phi_6869_: u32;
    var phi_6889_: bool;
    var phi_6890_: bool;
    var phi_6891_: bool;
    var phi_7039_: f32;
    var phi_7046_: f32;
    var phi_7051_: f32;
    var phi_7058_: f32;
    var phi_7063_: f32;
    var phi_7076_: f32;
    var phi_7083_: f32;
    var phi_7088_: f32;
    var phi_7095_: f32;
    var phi_7100_: f32;
    var phi_7105_: f32;
    var phi_7122_: f32;
    var phi_7129_: f32;
    var phi_7134_: f32;
    var phi_7141_: f32;
    var phi_7146_: f32;
    var phi_7160_: f32;
    var phi_7167_: f32;
    var phi_7172_: f32;
    var phi_7179_: f32;
    var phi_7184_: f32;
    var phi_7189_: f32;
    var phi_7206_: f32;
    var phi_7213_: f32;
    var phi_7218_: f32;
    var phi_7225_: f32;
    var phi_7230_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7256_: f32;
    var phi_7263_: f32;
    var phi_7268_: f32;
    var phi_7273_: f32;
    var phi_7313_: type_12;
    var phi_7316_: f32;
    var phi_7318_: f32;
    var phi_7320_: f32;
    var phi_7322_: f32;
    var phi_7324_: bool;
    var phi_7326_: u32;
    var phi_7314_: type_12;
    var phi_7349_: type_12;
    var phi_7463_: f32;
    var phi_7469_: f32;
    var phi_7475_: f32;
    var phi_7477_: array<f32, 3>;
    var phi_7484_: f32;
    var phi_7491_: f32;
    var phi_7499_: f32;
    var phi_7543_: type_14;
    var phi_7546_: f32;
    var phi_7567_: bool;
    var phi_7573_: type_15;
    var phi_7544_: type_14;
    var phi_7587_: type_15;
    var phi_7547_: f32;
    var local_18: f32;
    var phi_7536_: f32;
    var phi_7600_: f32;
    var phi_7666_: f32;
    var phi_7672_: f32;
    var phi_7681_: f32;
    var phi_7687_: f32;
    var phi_7696_: f32;
    var phi_7702_: f32;
    var phi_7711_: f32;
    var phi_7717_: f32;
    var phi_7723_: type_31;
    var phi_7724_: bool;
    var phi_7725_: type_31;
    var phi_7726_: bool;
    var phi_7734_: type_31;
    var phi_7905_: bool;
    var phi_7906_: bool;
    var phi_7907_: bool;
    var phi_7908_: bool;
    var phi_7909_: bool;
    var phi_7910_: bool;
    var phi_7914_: bool;
    var phi_8211_: bool;
    var phi_8212_: bool;
    var phi_8213_: bool;
    var phi_8214_: bool;
    var phi_8215_: bool;
    var phi_8216_: bool;
    var phi_8220_: bool;
    var phi_8224_: bool;
    var phi_8235_: bool;
    var phi_8236_: bool;
    var phi_8310_: bool;
    var phi_8311_: bool;
    var phi_8331_: f32;
    var phi_8332_: bool;
    var phi_8333_: f32;
    var phi_8334_: bool;
    var phi_8335_: f32;
    var phi_8336_: bool;
    var phi_8337_: bool;
    var phi_8341_: f32;
    var phi_8342_: bool;
    var phi_8346_: f32;
    var phi_8378_: bool;
    var phi_8379_: bool;
    var phi_8399_: f32;
    var phi_8400_: bool;
    var phi_8401_: f32;
    var phi_8402_: bool;
    var phi_8403_: f32;
    var phi_8404_: bool;
    var phi_8405_: bool;
    var phi_8409_: f32;
    var phi_8410_: bool;
    var phi_8414_: f32;
    var phi_8419_: f32;
    var phi_8451_: bool;
    var phi_8452_: bool;
    var phi_8472_: f32;
    var phi_8473_: bool;
    var phi_8474_: f32;
    var phi_8475_: bool;
    var phi_8476_: f32;
    var phi_8477_: bool;
    var phi_8478_: bool;
    var phi_8482_: f32;
    var phi_8483_: bool;
    var phi_8487_: f32;
    var phi_8519_: bool;
    var phi_8520_: bool;
    var phi_8540_: f32;
    var phi_8541_: bool;
    var phi_8542_: f32;
    var phi_8543_: bool;
    var phi_8544_: f32;
    var phi_8545_: bool;
    var phi_8546_: bool;
    var phi_8550_: f32;
    var phi_8551_: bool;
    var phi_8555_: f32;
    var phi_8560_: f32;
    var phi_8565_: f32;
    var phi_8570_: f32;
    var phi_9063_: bool;
    var phi_9064_: bool;
    var phi_9069_: f32;
    var phi_9071_: f32;
    var phi_9074_: f32;
    var phi_9075_: f32;
    var phi_9076_: bool;
    var phi_9078_: f32;
    var phi_9079_: f32;
    var phi_9080_: f32;
    var phi_9082_: bool;
    var phi_9083_: bool;
    var phi_9085_: bool;
    var phi_9086_: f32;
    var phi_9087_: f32;
    var phi_9088_: f32;
    var phi_9090_: bool;
    var phi_9091_: bool;
    var phi_9092_: bool;
    var phi_9094_: bool;
    var phi_9095_: f32;
    var phi_9096_: f32;
    var phi_9097_: f32;
    var phi_9099_: bool;
    var phi_9100_: bool;
    var phi_9101_: bool;
    var phi_9103_: bool;
    var phi_9189_: f32;
    var phi_9262_: f32;
    var phi_9267_: f32;
    var phi_9340_: f32;
    var phi_9413_: f32;
    var phi_9418_: f32;
    var phi_9434_: f32;
    var phi_9435_: f32;
    var phi_9436_: f32;
    var phi_9116_: bool;
    var phi_9438_: u32;
    var phi_9439_: f32;
    var phi_9440_: bool;
    var phi_9441_: bool;
    var phi_9442_: bool;
    var phi_9443_: u32;
    var phi_9444_: f32;
    var phi_9445_: f32;
    var phi_9446_: f32;
    var phi_9447_: f32;
    var phi_9448_: bool;
    var phi_9449_: u32;
    var phi_9450_: bool;
    var phi_9451_: bool;
    var phi_9452_: bool;
    var phi_9453_: bool;
    var phi_9455_: bool;
    var phi_9464_: f32;
    var phi_9469_: f32;
    var phi_9478_: bool;
    var phi_9482_: bool;
    var phi_9483_: f32;
    var phi_9484_: f32;
    var phi_9485_: f32;
    var phi_9486_: f32;
    var phi_9487_: bool;
    var phi_9488_: u32;
    var phi_9489_: bool;
    var phi_9490_: bool;
    var phi_9491_: bool;
    var phi_9492_: bool;
    var phi_9494_: bool;
    var phi_7317_: f32;
    var phi_7319_: f32;
    var phi_7321_: f32;
    var phi_7323_: f32;
    var phi_7325_: bool;
    var phi_7327_: u32;
    var phi_9495_: f32;
    var phi_9497_: bool;
    var phi_9498_: bool;
    var phi_9499_: bool;
    var phi_9500_: bool;
    var phi_9502_: bool;
    var phi_9503_: bool;
    var local_19: bool;
    var phi_9507_: bool;
    var phi_9508_: bool;
    var phi_9510_: bool;
    var phi_9511_: bool;
    var local_20: f32;
    var phi_9516_: type_28;
    var phi_9517_: bool;
    var phi_9519_: bool;
    var phi_9520_: bool;
    var phi_9521_: bool;
    var phi_9526_: type_28;
    var phi_9528_: bool;
    var phi_9529_: bool;
    var phi_9530_: bool;
    var phi_9531_: bool;
    var phi_9543_: f32;
    var phi_9544_: bool;
    var phi_9545_: bool;
    var phi_9546_: bool;
    var phi_9551_: type_28;
    var phi_9552_: bool;
    var phi_9553_: bool;
    var phi_9558_: type_28;
    var phi_9559_: bool;
    var phi_9563_: type_28;
    var phi_9570_: bool;
    var phi_9571_: f32;
    var phi_9572_: bool;
    var phi_9573_: bool;
    var phi_9574_: bool;
    var phi_9575_: f32;
    var phi_9576_: bool;
    var phi_9577_: bool;
    var phi_9578_: bool;
    var phi_9579_: f32;
    var phi_9580_: bool;
    var phi_9581_: bool;
    var phi_9582_: bool;
    var phi_9583_: bool;
    var phi_9587_: bool;
    var phi_9588_: bool;
    var phi_9589_: bool;
    var phi_9590_: f32;
    var phi_9591_: type_37;
    var phi_9592_: bool;
    var phi_9593_: bool;
    var phi_9594_: bool;
    var phi_9595_: bool;
    var local_21: bool;
    var phi_9600_: type_28;
    var phi_9601_: bool;
    var phi_9602_: bool;
    var local_22: f32;
    var phi_9607_: type_28;
    var phi_9608_: bool;
    var local_23: type_37;
    var phi_9614_: type_28;
    var phi_9615_: bool;
    var phi_9619_: type_28;
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
    var phi_2368_: type_12;
    var phi_2371_: f32;
    var phi_2373_: f32;
    var phi_2375_: f32;
    var phi_2377_: f32;
    var phi_2379_: bool;
    var phi_2381_: u32;
    var phi_2369_: type_12;
    var phi_2404_: type_12;
    var phi_2518_: f32;
    var phi_2524_: f32;
    var phi_2530_: f32;
    var phi_2532_: array<f32, 3>;
    var phi_2539_: f32;
    var phi_2546_: f32;
    var phi_2554_: f32;
    var phi_2598_: type_14;
    var phi_2601_: f32;
    var phi_2622_: bool;
    var phi_2628_: type_15;
    var phi_2599_: type_14;
    var phi_2642_: type_15;
    var phi_2602_: f32;
    var local_24: f32;
    var phi_2591_: f32;
    var phi_2655_: f32;
    var phi_2721_: f32;
    var phi_2727_: f32;
    var phi_2736_: f32;
    var phi_2742_: f32;
    var phi_2751_: f32;
    var phi_2757_: f32;
    var phi_2766_: f32;
    var phi_2772_: f32;
    var phi_2778_: type_31;
    var phi_2779_: bool;
    var phi_2780_: type_31;
    var phi_2781_: bool;
    var phi_2789_: type_31;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2965_: bool;
    var phi_2969_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3275_: bool;
    var phi_3279_: bool;
    var phi_3290_: bool;
    var phi_3291_: bool;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3386_: f32;
    var phi_3387_: bool;
    var phi_3388_: f32;
    var phi_3389_: bool;
    var phi_3390_: f32;
    var phi_3391_: bool;
    var phi_3392_: bool;
    var phi_3396_: f32;
    var phi_3397_: bool;
    var phi_3401_: f32;
    var phi_3433_: bool;
    var phi_3434_: bool;
    var phi_3454_: f32;
    var phi_3455_: bool;
    var phi_3456_: f32;
    var phi_3457_: bool;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3464_: f32;
    var phi_3465_: bool;
    var phi_3469_: f32;
    var phi_3474_: f32;
    var phi_3506_: bool;
    var phi_3507_: bool;
    var phi_3527_: f32;
    var phi_3528_: bool;
    var phi_3529_: f32;
    var phi_3530_: bool;
    var phi_3531_: f32;
    var phi_3532_: bool;
    var phi_3533_: bool;
    var phi_3537_: f32;
    var phi_3538_: bool;
    var phi_3542_: f32;
    var phi_3574_: bool;
    var phi_3575_: bool;
    var phi_3595_: f32;
    var phi_3596_: bool;
    var phi_3597_: f32;
    var phi_3598_: bool;
    var phi_3599_: f32;
    var phi_3600_: bool;
    var phi_3601_: bool;
    var phi_3605_: f32;
    var phi_3606_: bool;
    var phi_3610_: f32;
    var phi_3615_: f32;
    var phi_3620_: f32;
    var phi_3625_: f32;
    var phi_3637_: f32;
    var phi_3774_: type_14;
    var phi_3777_: f32;
    var phi_3798_: bool;
    var phi_3804_: type_15;
    var phi_3775_: type_14;
    var phi_3818_: type_15;
    var phi_3778_: f32;
    var local_25: f32;
    var phi_3767_: f32;
    var phi_3831_: f32;
    var phi_3847_: f32;
    var phi_3854_: f32;
    var phi_3859_: f32;
    var phi_3866_: f32;
    var phi_3871_: f32;
    var phi_3884_: f32;
    var phi_3891_: f32;
    var phi_3896_: f32;
    var phi_3903_: f32;
    var phi_3908_: f32;
    var phi_3913_: f32;
    var phi_3930_: f32;
    var phi_3937_: f32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3954_: f32;
    var phi_3968_: f32;
    var phi_3975_: f32;
    var phi_3980_: f32;
    var phi_3987_: f32;
    var phi_3992_: f32;
    var phi_3997_: f32;
    var phi_4014_: f32;
    var phi_4021_: f32;
    var phi_4026_: f32;
    var phi_4033_: f32;
    var phi_4038_: f32;
    var phi_4052_: f32;
    var phi_4059_: f32;
    var phi_4064_: f32;
    var phi_4071_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4101_: bool;
    var phi_4102_: bool;
    var phi_4103_: bool;
    var phi_4118_: bool;
    var phi_4119_: bool;
    var phi_4124_: f32;
    var phi_4126_: f32;
    var phi_4127_: f32;
    var phi_4128_: bool;
    var phi_4129_: f32;
    var phi_4130_: f32;
    var phi_4131_: bool;
    var phi_4132_: bool;
    var phi_4133_: f32;
    var phi_4134_: f32;
    var phi_4135_: f32;
    var phi_4136_: f32;
    var phi_4137_: bool;
    var phi_4138_: bool;
    var phi_4139_: bool;
    var phi_4140_: bool;
    var phi_4141_: f32;
    var phi_4142_: f32;
    var phi_4143_: f32;
    var phi_4144_: f32;
    var phi_4145_: bool;
    var phi_4146_: bool;
    var phi_4147_: bool;
    var phi_4148_: bool;
    var phi_4149_: bool;
    var phi_4150_: f32;
    var phi_4151_: f32;
    var phi_4152_: f32;
    var phi_4153_: f32;
    var phi_4154_: bool;
    var phi_4155_: bool;
    var phi_4156_: bool;
    var phi_4157_: bool;
    var phi_4158_: bool;
    var phi_4244_: f32;
    var phi_4317_: f32;
    var phi_4322_: f32;
    var phi_4395_: f32;
    var phi_4468_: f32;
    var phi_4473_: f32;
    var phi_4489_: f32;
    var phi_4490_: f32;
    var phi_4491_: f32;
    var phi_4171_: bool;
    var phi_4493_: u32;
    var phi_4494_: f32;
    var phi_4495_: bool;
    var phi_4496_: bool;
    var phi_4497_: bool;
    var phi_4498_: u32;
    var phi_4499_: f32;
    var phi_4500_: f32;
    var phi_4501_: f32;
    var phi_4502_: f32;
    var phi_4503_: bool;
    var phi_4504_: u32;
    var phi_4505_: bool;
    var phi_4506_: bool;
    var phi_4507_: bool;
    var phi_4508_: bool;
    var phi_4509_: bool;
    var phi_4510_: bool;
    var phi_4519_: f32;
    var phi_4524_: f32;
    var phi_4533_: bool;
    var phi_4537_: bool;
    var phi_4538_: f32;
    var phi_4539_: f32;
    var phi_4540_: f32;
    var phi_4541_: f32;
    var phi_4542_: bool;
    var phi_4543_: u32;
    var phi_4544_: bool;
    var phi_4545_: bool;
    var phi_4546_: bool;
    var phi_4547_: bool;
    var phi_4548_: bool;
    var phi_4549_: bool;
    var phi_2372_: f32;
    var phi_2374_: f32;
    var phi_2376_: f32;
    var phi_2378_: f32;
    var phi_2380_: bool;
    var phi_2382_: u32;
    var phi_4550_: f32;
    var phi_4551_: f32;
    var phi_4552_: bool;
    var phi_4553_: bool;
    var phi_4554_: bool;
    var phi_4555_: bool;
    var phi_4556_: bool;
    var phi_4557_: bool;
    var phi_4558_: bool;
    var local_26: bool;
    var phi_4562_: bool;
    var phi_4563_: bool;
    var phi_4564_: bool;
    var phi_4565_: bool;
    var phi_4566_: bool;
    var local_27: f32;
    var phi_4571_: type_28;
    var phi_4572_: bool;
    var phi_4573_: bool;
    var phi_4574_: bool;
    var phi_4575_: bool;
    var phi_4576_: bool;
    var phi_4581_: type_28;
    var phi_4582_: bool;
    var phi_4583_: bool;
    var phi_4584_: bool;
    var phi_4585_: bool;
    var phi_4586_: bool;
    var phi_4590_: f32;
    var phi_4591_: bool;
    var phi_4592_: bool;
    var phi_4593_: bool;
    var phi_4594_: bool;
    var phi_4598_: f32;
    var phi_4599_: bool;
    var phi_4600_: bool;
    var phi_4601_: bool;
    var phi_4606_: type_28;
    var phi_4607_: bool;
    var phi_4608_: bool;
    var phi_4613_: type_28;
    var phi_4614_: bool;
    var phi_4618_: type_28;
    var phi_4631_: type_12;
    var phi_4632_: type_12;
    var phi_4655_: type_12;
    var phi_4675_: f32;
    var phi_4805_: type_14;
    var phi_4808_: f32;
    var phi_4829_: bool;
    var phi_4835_: type_15;
    var phi_4806_: type_14;
    var phi_4849_: type_15;
    var phi_4809_: f32;
    var local_28: f32;
    var phi_4798_: f32;
    var phi_4862_: f32;
    var phi_4878_: f32;
    var phi_4885_: f32;
    var phi_4890_: f32;
    var phi_4897_: f32;
    var phi_4902_: f32;
    var phi_4915_: f32;
    var phi_4922_: f32;
    var phi_4927_: f32;
    var phi_4934_: f32;
    var phi_4939_: f32;
    var phi_4944_: f32;
    var phi_4961_: f32;
    var phi_4968_: f32;
    var phi_4973_: f32;
    var phi_4980_: f32;
    var phi_4985_: f32;
    var phi_4999_: f32;
    var phi_5006_: f32;
    var phi_5011_: f32;
    var phi_5018_: f32;
    var phi_5023_: f32;
    var phi_5028_: f32;
    var phi_5045_: f32;
    var phi_5052_: f32;
    var phi_5057_: f32;
    var phi_5064_: f32;
    var phi_5069_: f32;
    var phi_5083_: f32;
    var phi_5090_: f32;
    var phi_5095_: f32;
    var phi_5102_: f32;
    var phi_5107_: f32;
    var phi_5112_: f32;
    var phi_5132_: bool;
    var phi_5133_: bool;
    var phi_5134_: bool;
    var local_29: bool;
    var phi_5139_: type_28;
    var phi_5140_: bool;
    var phi_5145_: type_28;
    var phi_5146_: bool;
    var phi_5148_: type_28;
    var phi_5149_: type_28;
    var phi_5150_: bool;
    var phi_5154_: type_28;
    var phi_9623_: type_28;
    var phi_9624_: type_28;
    var phi_9637_: type_38;
    var phi_9644_: bool;
    var phi_9668_: u32;
    var phi_9672_: type_20;
    var phi_9673_: bool;
    var phi_9674_: bool;
    var phi_9693_: u32;
    var phi_9756_: u32;
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
    phi_808_ = type_12(0u, _e146);
    loop {
        let _e149 = phi_808_;
        if (_e149.member < _e149.member_1) {
            phi_809_ = type_12((_e149.member + 1u), _e149.member_1);
            phi_832_ = type_12(1u, _e149.member);
        } else {
            phi_809_ = _e149;
            phi_832_ = type_12(0u, type_12().member_1);
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
                    phi_9624_ = type_28(0u, type_28().member_1);
                } else {
                    if (_e452.member_1 > 0f) {
                        let _e3562 = local_12.member[0u];
                        let _e3568 = local_12.member_1[0u];
                        let _e3574 = local_12.member_2[0u];
                        let _e3586 = local_12.member[1u];
                        let _e3592 = local_12.member_1[1u];
                        let _e3598 = local_12.member_2[1u];
                        let _e3610 = local_12.member[0u];
                        if (_e3610[0] < 0f) {
                            phi_2094_ = -(_e3610[0]);
                        } else {
                            phi_2094_ = _e3610[0];
                        }
                        let _e3617 = phi_2094_;
                        if (_e3610[1] < 0f) {
                            phi_2101_ = -(_e3610[1]);
                        } else {
                            phi_2101_ = _e3610[1];
                        }
                        let _e3621 = phi_2101_;
                        if (_e3617 > _e3621) {
                            phi_2106_ = _e3617;
                        } else {
                            phi_2106_ = _e3621;
                        }
                        let _e3624 = phi_2106_;
                        if (_e3610[2] < 0f) {
                            phi_2113_ = -(_e3610[2]);
                        } else {
                            phi_2113_ = _e3610[2];
                        }
                        let _e3628 = phi_2113_;
                        if (_e3624 > _e3628) {
                            phi_2118_ = _e3624;
                        } else {
                            phi_2118_ = _e3628;
                        }
                        let _e3631 = phi_2118_;
                        let _e3634 = local_12.member[1u];
                        if (_e3634[0] < 0f) {
                            phi_2131_ = -(_e3634[0]);
                        } else {
                            phi_2131_ = _e3634[0];
                        }
                        let _e3641 = phi_2131_;
                        if (_e3634[1] < 0f) {
                            phi_2138_ = -(_e3634[1]);
                        } else {
                            phi_2138_ = _e3634[1];
                        }
                        let _e3645 = phi_2138_;
                        if (_e3641 > _e3645) {
                            phi_2143_ = _e3641;
                        } else {
                            phi_2143_ = _e3645;
                        }
                        let _e3648 = phi_2143_;
                        if (_e3634[2] < 0f) {
                            phi_2150_ = -(_e3634[2]);
                        } else {
                            phi_2150_ = _e3634[2];
                        }
                        let _e3652 = phi_2150_;
                        if (_e3648 > _e3652) {
                            phi_2155_ = _e3648;
                        } else {
                            phi_2155_ = _e3652;
                        }
                        let _e3655 = phi_2155_;
                        if (_e3631 > _e3655) {
                            phi_2160_ = _e3631;
                        } else {
                            phi_2160_ = _e3655;
                        }
                        let _e3658 = phi_2160_;
                        let _e3660 = local_12.member_3;
                        let _e3664 = local_12.member_1[0u];
                        if (_e3664[0] < 0f) {
                            phi_2177_ = -(_e3664[0]);
                        } else {
                            phi_2177_ = _e3664[0];
                        }
                        let _e3671 = phi_2177_;
                        if (_e3664[1] < 0f) {
                            phi_2184_ = -(_e3664[1]);
                        } else {
                            phi_2184_ = _e3664[1];
                        }
                        let _e3675 = phi_2184_;
                        if (_e3671 > _e3675) {
                            phi_2189_ = _e3671;
                        } else {
                            phi_2189_ = _e3675;
                        }
                        let _e3678 = phi_2189_;
                        if (_e3664[2] < 0f) {
                            phi_2196_ = -(_e3664[2]);
                        } else {
                            phi_2196_ = _e3664[2];
                        }
                        let _e3682 = phi_2196_;
                        if (_e3678 > _e3682) {
                            phi_2201_ = _e3678;
                        } else {
                            phi_2201_ = _e3682;
                        }
                        let _e3685 = phi_2201_;
                        let _e3688 = local_12.member_1[1u];
                        if (_e3688[0] < 0f) {
                            phi_2215_ = -(_e3688[0]);
                        } else {
                            phi_2215_ = _e3688[0];
                        }
                        let _e3695 = phi_2215_;
                        if (_e3688[1] < 0f) {
                            phi_2222_ = -(_e3688[1]);
                        } else {
                            phi_2222_ = _e3688[1];
                        }
                        let _e3699 = phi_2222_;
                        if (_e3695 > _e3699) {
                            phi_2227_ = _e3695;
                        } else {
                            phi_2227_ = _e3699;
                        }
                        let _e3702 = phi_2227_;
                        if (_e3688[2] < 0f) {
                            phi_2234_ = -(_e3688[2]);
                        } else {
                            phi_2234_ = _e3688[2];
                        }
                        let _e3706 = phi_2234_;
                        if (_e3702 > _e3706) {
                            phi_2239_ = _e3702;
                        } else {
                            phi_2239_ = _e3706;
                        }
                        let _e3709 = phi_2239_;
                        if (_e3685 > _e3709) {
                            phi_2244_ = _e3685;
                        } else {
                            phi_2244_ = _e3709;
                        }
                        let _e3712 = phi_2244_;
                        let _e3714 = local_12.member_3;
                        let _e3718 = local_12.member_2[0u];
                        if (_e3718[0] < 0f) {
                            phi_2261_ = -(_e3718[0]);
                        } else {
                            phi_2261_ = _e3718[0];
                        }
                        let _e3725 = phi_2261_;
                        if (_e3718[1] < 0f) {
                            phi_2268_ = -(_e3718[1]);
                        } else {
                            phi_2268_ = _e3718[1];
                        }
                        let _e3729 = phi_2268_;
                        if (_e3725 > _e3729) {
                            phi_2273_ = _e3725;
                        } else {
                            phi_2273_ = _e3729;
                        }
                        let _e3732 = phi_2273_;
                        if (_e3718[2] < 0f) {
                            phi_2280_ = -(_e3718[2]);
                        } else {
                            phi_2280_ = _e3718[2];
                        }
                        let _e3736 = phi_2280_;
                        if (_e3732 > _e3736) {
                            phi_2285_ = _e3732;
                        } else {
                            phi_2285_ = _e3736;
                        }
                        let _e3739 = phi_2285_;
                        let _e3742 = local_12.member_2[1u];
                        if (_e3742[0] < 0f) {
                            phi_2299_ = -(_e3742[0]);
                        } else {
                            phi_2299_ = _e3742[0];
                        }
                        let _e3749 = phi_2299_;
                        if (_e3742[1] < 0f) {
                            phi_2306_ = -(_e3742[1]);
                        } else {
                            phi_2306_ = _e3742[1];
                        }
                        let _e3753 = phi_2306_;
                        if (_e3749 > _e3753) {
                            phi_2311_ = _e3749;
                        } else {
                            phi_2311_ = _e3753;
                        }
                        let _e3756 = phi_2311_;
                        if (_e3742[2] < 0f) {
                            phi_2318_ = -(_e3742[2]);
                        } else {
                            phi_2318_ = _e3742[2];
                        }
                        let _e3760 = phi_2318_;
                        if (_e3756 > _e3760) {
                            phi_2323_ = _e3756;
                        } else {
                            phi_2323_ = _e3760;
                        }
                        let _e3763 = phi_2323_;
                        if (_e3739 > _e3763) {
                            phi_2328_ = _e3739;
                        } else {
                            phi_2328_ = _e3763;
                        }
                        let _e3766 = phi_2328_;
                        let _e3768 = local_12.member_3;
                        let _e3775 = local_12.member_3;
                        local_9 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_2368_ = type_12(0u, 96u);
                        phi_2371_ = 0f;
                        phi_2373_ = 0f;
                        phi_2375_ = (1f - 0f);
                        phi_2377_ = 0f;
                        phi_2379_ = false;
                        phi_2381_ = 0u;
                        loop {
                            let _e3782 = phi_2368_;
                            let _e3784 = phi_2371_;
                            let _e3786 = phi_2373_;
                            let _e3788 = phi_2375_;
                            let _e3790 = phi_2377_;
                            let _e3792 = phi_2379_;
                            let _e3794 = phi_2381_;
                            local_27 = _e3784;
                            local_53 = _e3786;
                            if (_e3782.member < _e3782.member_1) {
                                phi_2369_ = type_12((_e3782.member + 1u), _e3782.member_1);
                                phi_2404_ = type_12(1u, _e3782.member);
                            } else {
                                phi_2369_ = _e3782;
                                phi_2404_ = type_12(0u, type_12().member_1);
                            }
                            let _e3806 = phi_2369_;
                            let _e3808 = phi_2404_;
                            if (bitcast<i32>(_e3808.member) != 0i) {
                                let _e3814 = local_12.member[0u];
                                let _e3820 = local_12.member[1u];
                                let _e3836 = local_12.member_1[0u];
                                let _e3842 = local_12.member_1[1u];
                                let _e3858 = local_12.member_2[0u];
                                let _e3864 = local_12.member_2[1u];
                                let _e3878 = function_1(array<f32, 3>((_e3814[0] + ((_e3820[0] - _e3814[0]) * _e3784)), (_e3814[1] + ((_e3820[1] - _e3814[1]) * _e3784)), (_e3814[2] + ((_e3820[2] - _e3814[2]) * _e3784))), array<f32, 3>((_e3836[0] + ((_e3842[0] - _e3836[0]) * _e3784)), (_e3836[1] + ((_e3842[1] - _e3836[1]) * _e3784)), (_e3836[2] + ((_e3842[2] - _e3836[2]) * _e3784))), array<f32, 3>((_e3858[0] + ((_e3864[0] - _e3858[0]) * _e3784)), (_e3858[1] + ((_e3864[1] - _e3858[1]) * _e3784)), (_e3858[2] + ((_e3864[2] - _e3858[2]) * _e3784))), 0u);
                                if (_e3794 == 0u) {
                                    phi_2532_ = _e3878;
                                } else {
                                    if (_e3794 == 1u) {
                                        phi_2518_ = _e3878[0];
                                    } else {
                                        phi_2518_ = 0f;
                                    }
                                    let _e3883 = phi_2518_;
                                    if (_e3794 == 2u) {
                                        phi_2524_ = _e3878[1];
                                    } else {
                                        phi_2524_ = 0f;
                                    }
                                    let _e3887 = phi_2524_;
                                    if (_e3794 == 3u) {
                                        phi_2530_ = _e3878[2];
                                    } else {
                                        phi_2530_ = 0f;
                                    }
                                    let _e3891 = phi_2530_;
                                    phi_2532_ = array<f32, 3>(_e3883, _e3887, _e3891);
                                }
                                let _e3894 = phi_2532_;
                                if (_e3894[0] < 0f) {
                                    phi_2539_ = -(_e3894[0]);
                                } else {
                                    phi_2539_ = _e3894[0];
                                }
                                let _e3899 = phi_2539_;
                                if (_e3894[1] < 0f) {
                                    phi_2546_ = -(_e3894[1]);
                                } else {
                                    phi_2546_ = _e3894[1];
                                }
                                let _e3904 = phi_2546_;
                                if (_e3894[2] < 0f) {
                                    phi_2554_ = -(_e3894[2]);
                                } else {
                                    phi_2554_ = _e3894[2];
                                }
                                let _e3910 = phi_2554_;
                                let _e3911 = ((_e3899 + _e3904) + _e3910);
                                if (_e3911 > 0f) {
                                    if ((bitcast<u32>(_e3911) & 2139095040u) != 2139095040u) {
                                        let _e3916 = (1f / _e3911);
                                        let _e3918 = (_e3894[0] * _e3916);
                                        let _e3920 = (_e3894[1] * _e3916);
                                        let _e3922 = (_e3894[2] * _e3916);
                                        let _e3927 = (((_e3918 * _e3918) + (_e3920 * _e3920)) + (_e3922 * _e3922));
                                        if (_e3927 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3927 > 0f) {
                                                phi_2591_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2591_ = 0f;
                                            }
                                            let _e3980 = phi_2591_;
                                            phi_2655_ = _e3980;
                                        } else {
                                            phi_2598_ = type_14(0i, 5i);
                                            phi_2601_ = bitcast<f32>(((bitcast<u32>(_e3927) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3935 = phi_2598_;
                                                let _e3937 = phi_2601_;
                                                local_24 = _e3937;
                                                if (_e3935.member < _e3935.member_1) {
                                                    let _e3944 = (_e3935.member + 1i);
                                                    if ((false == (_e3944 > _e3935.member)) != false) {
                                                        phi_2622_ = true;
                                                    } else {
                                                        phi_2622_ = false;
                                                    }
                                                    let _e3949 = phi_2622_;
                                                    if _e3949 {
                                                        phi_2628_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2628_ = type_15(1u, _e3944);
                                                    }
                                                    let _e3954 = phi_2628_;
                                                    phi_2599_ = type_14(_e3954.member_1, _e3935.member_1);
                                                    phi_2642_ = type_15(1u, _e3935.member);
                                                } else {
                                                    phi_2599_ = _e3935;
                                                    phi_2642_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3960 = phi_2599_;
                                                let _e3962 = phi_2642_;
                                                let _e3965 = (bitcast<i32>(_e3962.member) != 0i);
                                                if _e3965 {
                                                    phi_2602_ = (0.5f * (_e3937 + (_e3927 / _e3937)));
                                                } else {
                                                    phi_2602_ = f32();
                                                }
                                                let _e3970 = phi_2602_;
                                                continue;
                                                continuing {
                                                    phi_2598_ = _e3960;
                                                    phi_2601_ = _e3970;
                                                    break if !(_e3965);
                                                }
                                            }
                                            let _e3975 = local_24;
                                            phi_2655_ = (_e3975 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3982 = phi_2655_;
                                        let _e3983 = (0.000000059604645f * 12f);
                                        let _e3988 = ((((((((_e3658 + _e3660) + (_e3712 + _e3714)) + (_e3766 + _e3768)) * (0.000000059604645f * 16f)) + (_e3775 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e452.member_1 * _e3982) * (1f + _e3983)));
                                        let _e3993 = (((_e3918 * _e3562[0]) + (_e3920 * _e3562[1])) + (_e3922 * _e3562[2]));
                                        let _e3998 = (((_e3918 * (_e3562[0] - _e3568[0])) + (_e3920 * (_e3562[1] - _e3568[1]))) + (_e3922 * (_e3562[2] - _e3568[2])));
                                        let _e4003 = (((_e3918 * (_e3562[0] - _e3574[0])) + (_e3920 * (_e3562[1] - _e3574[1]))) + (_e3922 * (_e3562[2] - _e3574[2])));
                                        let _e4008 = (((_e3918 * _e3562[0]) + (_e3920 * _e3562[1])) + (_e3922 * _e3562[2]));
                                        let _e4014 = (((_e3918 * _e3586[0]) + (_e3920 * _e3586[1])) + (_e3922 * _e3586[2]));
                                        let _e4019 = (((_e3918 * (_e3586[0] - _e3592[0])) + (_e3920 * (_e3586[1] - _e3592[1]))) + (_e3922 * (_e3586[2] - _e3592[2])));
                                        let _e4024 = (((_e3918 * (_e3586[0] - _e3598[0])) + (_e3920 * (_e3586[1] - _e3598[1]))) + (_e3922 * (_e3586[2] - _e3598[2])));
                                        let _e4029 = (((_e3918 * _e3586[0]) + (_e3920 * _e3586[1])) + (_e3922 * _e3586[2]));
                                        if (_e3993 < 0f) {
                                            phi_2721_ = -(_e3993);
                                        } else {
                                            phi_2721_ = _e3993;
                                        }
                                        let _e4034 = phi_2721_;
                                        if (_e4014 < 0f) {
                                            phi_2727_ = -(_e4014);
                                        } else {
                                            phi_2727_ = _e4014;
                                        }
                                        let _e4038 = phi_2727_;
                                        if (_e3998 < 0f) {
                                            phi_2736_ = -(_e3998);
                                        } else {
                                            phi_2736_ = _e3998;
                                        }
                                        let _e4045 = phi_2736_;
                                        if (_e4019 < 0f) {
                                            phi_2742_ = -(_e4019);
                                        } else {
                                            phi_2742_ = _e4019;
                                        }
                                        let _e4049 = phi_2742_;
                                        if (_e4003 < 0f) {
                                            phi_2751_ = -(_e4003);
                                        } else {
                                            phi_2751_ = _e4003;
                                        }
                                        let _e4056 = phi_2751_;
                                        if (_e4024 < 0f) {
                                            phi_2757_ = -(_e4024);
                                        } else {
                                            phi_2757_ = _e4024;
                                        }
                                        let _e4060 = phi_2757_;
                                        if (_e4008 < 0f) {
                                            phi_2766_ = -(_e4008);
                                        } else {
                                            phi_2766_ = _e4008;
                                        }
                                        let _e4067 = phi_2766_;
                                        if (_e4029 < 0f) {
                                            phi_2772_ = -(_e4029);
                                        } else {
                                            phi_2772_ = _e4029;
                                        }
                                        let _e4071 = phi_2772_;
                                        phi_2778_ = type_31(array<f32, 4>(_e3993, _e3998, _e4003, _e4008), array<f32, 4>(_e4014, _e4019, _e4024, _e4029), array<f32, 4>((_e3988 + ((_e4034 + _e4038) * _e3983)), (_e3988 + ((_e4045 + _e4049) * _e3983)), (_e3988 + ((_e4056 + _e4060) * _e3983)), (_e3988 + ((_e4067 + _e4071) * _e3983))));
                                        phi_2779_ = false;
                                    } else {
                                        phi_2778_ = type_31();
                                        phi_2779_ = true;
                                    }
                                    let _e4078 = phi_2778_;
                                    let _e4080 = phi_2779_;
                                    phi_2780_ = _e4078;
                                    phi_2781_ = _e4080;
                                } else {
                                    phi_2780_ = type_31();
                                    phi_2781_ = true;
                                }
                                let _e4082 = phi_2780_;
                                let _e4084 = phi_2781_;
                                if _e4084 {
                                    phi_2789_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2789_ = _e4082;
                                }
                                let _e4086 = phi_2789_;
                                local_10 = type_31(array<f32, 4>(_e4086.member[0], _e4086.member[1], _e4086.member[2], _e4086.member[3]), array<f32, 4>(_e4086.member_1[0], _e4086.member_1[1], _e4086.member_1[2], _e4086.member_1[3]), array<f32, 4>(_e4086.member_2[0], _e4086.member_2[1], _e4086.member_2[2], _e4086.member_2[3]));
                                let _e4106 = (_e3784 - _e3790);
                                let _e4110 = local_10.member[0u];
                                let _e4113 = local_10.member_1[0u];
                                let _e4116 = local_10.member[0u];
                                let _e4122 = local_10.member_2[0u];
                                if (((_e4110 + ((_e4113 - _e4116) * _e3784)) - _e4122) > 0f) {
                                    let _e4127 = local_10.member[1u];
                                    let _e4130 = local_10.member_1[1u];
                                    let _e4133 = local_10.member[1u];
                                    let _e4139 = local_10.member_2[1u];
                                    if (((_e4127 + ((_e4130 - _e4133) * _e3784)) - _e4139) > 0f) {
                                        let _e4144 = local_10.member[2u];
                                        let _e4147 = local_10.member_1[2u];
                                        let _e4150 = local_10.member[2u];
                                        let _e4156 = local_10.member_2[2u];
                                        if (((_e4144 + ((_e4147 - _e4150) * _e3784)) - _e4156) > 0f) {
                                            let _e4161 = local_10.member[3u];
                                            let _e4164 = local_10.member_1[3u];
                                            let _e4167 = local_10.member[3u];
                                            let _e4173 = local_10.member_2[3u];
                                            phi_2960_ = (((_e4161 + ((_e4164 - _e4167) * _e3784)) - _e4173) > 0f);
                                            phi_2961_ = false;
                                        } else {
                                            phi_2960_ = bool();
                                            phi_2961_ = true;
                                        }
                                        let _e4177 = phi_2960_;
                                        let _e4179 = phi_2961_;
                                        phi_2962_ = _e4177;
                                        phi_2963_ = _e4179;
                                    } else {
                                        phi_2962_ = bool();
                                        phi_2963_ = true;
                                    }
                                    let _e4181 = phi_2962_;
                                    let _e4183 = phi_2963_;
                                    phi_2964_ = _e4181;
                                    phi_2965_ = _e4183;
                                } else {
                                    phi_2964_ = bool();
                                    phi_2965_ = true;
                                }
                                let _e4185 = phi_2964_;
                                let _e4187 = phi_2965_;
                                if _e4187 {
                                    phi_2969_ = false;
                                } else {
                                    phi_2969_ = _e4185;
                                }
                                let _e4189 = phi_2969_;
                                if _e4189 {
                                    if (_e3784 <= _e3786) {
                                        phi_3279_ = true;
                                    } else {
                                        let _e4193 = local_9.member[0u];
                                        let _e4196 = local_9.member_1[0u];
                                        let _e4199 = local_9.member[0u];
                                        let _e4205 = local_9.member_2[0u];
                                        let _e4209 = local_10.member[0u];
                                        let _e4212 = local_10.member_1[0u];
                                        let _e4215 = local_10.member[0u];
                                        let _e4221 = local_10.member_2[0u];
                                        if ((((_e4193 + ((_e4196 - _e4199) * _e3784)) - _e4205) + ((_e4209 + ((_e4212 - _e4215) * _e3790)) - _e4221)) > 0f) {
                                            let _e4227 = local_9.member[1u];
                                            let _e4230 = local_9.member_1[1u];
                                            let _e4233 = local_9.member[1u];
                                            let _e4239 = local_9.member_2[1u];
                                            let _e4243 = local_10.member[1u];
                                            let _e4246 = local_10.member_1[1u];
                                            let _e4249 = local_10.member[1u];
                                            let _e4255 = local_10.member_2[1u];
                                            if ((((_e4227 + ((_e4230 - _e4233) * _e3784)) - _e4239) + ((_e4243 + ((_e4246 - _e4249) * _e3790)) - _e4255)) > 0f) {
                                                let _e4261 = local_9.member[2u];
                                                let _e4264 = local_9.member_1[2u];
                                                let _e4267 = local_9.member[2u];
                                                let _e4273 = local_9.member_2[2u];
                                                let _e4277 = local_10.member[2u];
                                                let _e4280 = local_10.member_1[2u];
                                                let _e4283 = local_10.member[2u];
                                                let _e4289 = local_10.member_2[2u];
                                                if ((((_e4261 + ((_e4264 - _e4267) * _e3784)) - _e4273) + ((_e4277 + ((_e4280 - _e4283) * _e3790)) - _e4289)) > 0f) {
                                                    let _e4295 = local_9.member[3u];
                                                    let _e4298 = local_9.member_1[3u];
                                                    let _e4301 = local_9.member[3u];
                                                    let _e4307 = local_9.member_2[3u];
                                                    let _e4311 = local_10.member[3u];
                                                    let _e4314 = local_10.member_1[3u];
                                                    let _e4317 = local_10.member[3u];
                                                    let _e4323 = local_10.member_2[3u];
                                                    phi_3266_ = ((((_e4295 + ((_e4298 - _e4301) * _e3784)) - _e4307) + ((_e4311 + ((_e4314 - _e4317) * _e3790)) - _e4323)) > 0f);
                                                    phi_3267_ = false;
                                                } else {
                                                    phi_3266_ = bool();
                                                    phi_3267_ = true;
                                                }
                                                let _e4328 = phi_3266_;
                                                let _e4330 = phi_3267_;
                                                phi_3268_ = _e4328;
                                                phi_3269_ = _e4330;
                                            } else {
                                                phi_3268_ = bool();
                                                phi_3269_ = true;
                                            }
                                            let _e4332 = phi_3268_;
                                            let _e4334 = phi_3269_;
                                            phi_3270_ = _e4332;
                                            phi_3271_ = _e4334;
                                        } else {
                                            phi_3270_ = bool();
                                            phi_3271_ = true;
                                        }
                                        let _e4336 = phi_3270_;
                                        let _e4338 = phi_3271_;
                                        if _e4338 {
                                            phi_3275_ = false;
                                        } else {
                                            phi_3275_ = _e4336;
                                        }
                                        let _e4340 = phi_3275_;
                                        phi_3279_ = _e4340;
                                    }
                                    let _e4342 = phi_3279_;
                                    if _e4342 {
                                        if _e3792 {
                                            if (_e3784 >= 1f) {
                                                phi_3290_ = false;
                                            } else {
                                                phi_3290_ = true;
                                            }
                                            let _e4345 = phi_3290_;
                                            phi_3291_ = _e4345;
                                        } else {
                                            phi_3291_ = true;
                                        }
                                        let _e4347 = phi_3291_;
                                        if _e4347 {
                                            local_9 = type_31(array<f32, 4>(_e4086.member[0], _e4086.member[1], _e4086.member[2], _e4086.member[3]), array<f32, 4>(_e4086.member_1[0], _e4086.member_1[1], _e4086.member_1[2], _e4086.member_1[3]), array<f32, 4>(_e4086.member_2[0], _e4086.member_2[1], _e4086.member_2[2], _e4086.member_2[3]));
                                            let _e4369 = local_9.member[0u];
                                            let _e4372 = local_9.member_1[0u];
                                            let _e4375 = local_9.member_2[0u];
                                            if (_e4369 > _e4375) {
                                                if (_e4372 > _e4375) {
                                                    phi_3365_ = false;
                                                } else {
                                                    phi_3365_ = true;
                                                }
                                                let _e4379 = phi_3365_;
                                                phi_3366_ = _e4379;
                                            } else {
                                                phi_3366_ = true;
                                            }
                                            let _e4381 = phi_3366_;
                                            if _e4381 {
                                                let _e4382 = (_e4372 >= _e4369);
                                                if _e4382 {
                                                    phi_3388_ = f32();
                                                    phi_3389_ = false;
                                                } else {
                                                    if ((_e4369 - _e4372) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3386_ = (((_e4369 - _e4375) / (_e4369 - _e4372)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3387_ = false;
                                                    } else {
                                                        phi_3386_ = f32();
                                                        phi_3387_ = true;
                                                    }
                                                    let _e4393 = phi_3386_;
                                                    let _e4395 = phi_3387_;
                                                    phi_3388_ = _e4393;
                                                    phi_3389_ = _e4395;
                                                }
                                                let _e4397 = phi_3388_;
                                                let _e4399 = phi_3389_;
                                                phi_3390_ = _e4397;
                                                phi_3391_ = _e4382;
                                                phi_3392_ = _e4399;
                                            } else {
                                                phi_3390_ = f32();
                                                phi_3391_ = true;
                                                phi_3392_ = false;
                                            }
                                            let _e4401 = phi_3390_;
                                            let _e4403 = phi_3391_;
                                            let _e4405 = phi_3392_;
                                            if _e4403 {
                                                phi_3396_ = 2f;
                                                phi_3397_ = true;
                                            } else {
                                                phi_3396_ = _e3784;
                                                phi_3397_ = _e4405;
                                            }
                                            let _e4407 = phi_3396_;
                                            let _e4409 = phi_3397_;
                                            if _e4409 {
                                                phi_3401_ = _e4407;
                                            } else {
                                                phi_3401_ = _e4401;
                                            }
                                            let _e4411 = phi_3401_;
                                            let _e4414 = local_9.member[1u];
                                            let _e4417 = local_9.member_1[1u];
                                            let _e4420 = local_9.member_2[1u];
                                            if (_e4414 > _e4420) {
                                                if (_e4417 > _e4420) {
                                                    phi_3433_ = false;
                                                } else {
                                                    phi_3433_ = true;
                                                }
                                                let _e4424 = phi_3433_;
                                                phi_3434_ = _e4424;
                                            } else {
                                                phi_3434_ = true;
                                            }
                                            let _e4426 = phi_3434_;
                                            if _e4426 {
                                                let _e4427 = (_e4417 >= _e4414);
                                                if _e4427 {
                                                    phi_3456_ = f32();
                                                    phi_3457_ = false;
                                                } else {
                                                    if ((_e4414 - _e4417) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3454_ = (((_e4414 - _e4420) / (_e4414 - _e4417)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3455_ = false;
                                                    } else {
                                                        phi_3454_ = f32();
                                                        phi_3455_ = true;
                                                    }
                                                    let _e4438 = phi_3454_;
                                                    let _e4440 = phi_3455_;
                                                    phi_3456_ = _e4438;
                                                    phi_3457_ = _e4440;
                                                }
                                                let _e4442 = phi_3456_;
                                                let _e4444 = phi_3457_;
                                                phi_3458_ = _e4442;
                                                phi_3459_ = _e4427;
                                                phi_3460_ = _e4444;
                                            } else {
                                                phi_3458_ = f32();
                                                phi_3459_ = true;
                                                phi_3460_ = false;
                                            }
                                            let _e4446 = phi_3458_;
                                            let _e4448 = phi_3459_;
                                            let _e4450 = phi_3460_;
                                            if _e4448 {
                                                phi_3464_ = 2f;
                                                phi_3465_ = true;
                                            } else {
                                                phi_3464_ = _e3784;
                                                phi_3465_ = _e4450;
                                            }
                                            let _e4452 = phi_3464_;
                                            let _e4454 = phi_3465_;
                                            if _e4454 {
                                                phi_3469_ = _e4452;
                                            } else {
                                                phi_3469_ = _e4446;
                                            }
                                            let _e4456 = phi_3469_;
                                            if (_e4411 < _e4456) {
                                                phi_3474_ = _e4411;
                                            } else {
                                                phi_3474_ = _e4456;
                                            }
                                            let _e4459 = phi_3474_;
                                            let _e4462 = local_9.member[2u];
                                            let _e4465 = local_9.member_1[2u];
                                            let _e4468 = local_9.member_2[2u];
                                            if (_e4462 > _e4468) {
                                                if (_e4465 > _e4468) {
                                                    phi_3506_ = false;
                                                } else {
                                                    phi_3506_ = true;
                                                }
                                                let _e4472 = phi_3506_;
                                                phi_3507_ = _e4472;
                                            } else {
                                                phi_3507_ = true;
                                            }
                                            let _e4474 = phi_3507_;
                                            if _e4474 {
                                                let _e4475 = (_e4465 >= _e4462);
                                                if _e4475 {
                                                    phi_3529_ = f32();
                                                    phi_3530_ = false;
                                                } else {
                                                    if ((_e4462 - _e4465) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3527_ = (((_e4462 - _e4468) / (_e4462 - _e4465)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3528_ = false;
                                                    } else {
                                                        phi_3527_ = f32();
                                                        phi_3528_ = true;
                                                    }
                                                    let _e4486 = phi_3527_;
                                                    let _e4488 = phi_3528_;
                                                    phi_3529_ = _e4486;
                                                    phi_3530_ = _e4488;
                                                }
                                                let _e4490 = phi_3529_;
                                                let _e4492 = phi_3530_;
                                                phi_3531_ = _e4490;
                                                phi_3532_ = _e4475;
                                                phi_3533_ = _e4492;
                                            } else {
                                                phi_3531_ = f32();
                                                phi_3532_ = true;
                                                phi_3533_ = false;
                                            }
                                            let _e4494 = phi_3531_;
                                            let _e4496 = phi_3532_;
                                            let _e4498 = phi_3533_;
                                            if _e4496 {
                                                phi_3537_ = 2f;
                                                phi_3538_ = true;
                                            } else {
                                                phi_3537_ = _e3784;
                                                phi_3538_ = _e4498;
                                            }
                                            let _e4500 = phi_3537_;
                                            let _e4502 = phi_3538_;
                                            if _e4502 {
                                                phi_3542_ = _e4500;
                                            } else {
                                                phi_3542_ = _e4494;
                                            }
                                            let _e4504 = phi_3542_;
                                            let _e4507 = local_9.member[3u];
                                            let _e4510 = local_9.member_1[3u];
                                            let _e4513 = local_9.member_2[3u];
                                            if (_e4507 > _e4513) {
                                                if (_e4510 > _e4513) {
                                                    phi_3574_ = false;
                                                } else {
                                                    phi_3574_ = true;
                                                }
                                                let _e4517 = phi_3574_;
                                                phi_3575_ = _e4517;
                                            } else {
                                                phi_3575_ = true;
                                            }
                                            let _e4519 = phi_3575_;
                                            if _e4519 {
                                                let _e4520 = (_e4510 >= _e4507);
                                                if _e4520 {
                                                    phi_3597_ = f32();
                                                    phi_3598_ = false;
                                                } else {
                                                    if ((_e4507 - _e4510) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3595_ = (((_e4507 - _e4513) / (_e4507 - _e4510)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3596_ = false;
                                                    } else {
                                                        phi_3595_ = f32();
                                                        phi_3596_ = true;
                                                    }
                                                    let _e4531 = phi_3595_;
                                                    let _e4533 = phi_3596_;
                                                    phi_3597_ = _e4531;
                                                    phi_3598_ = _e4533;
                                                }
                                                let _e4535 = phi_3597_;
                                                let _e4537 = phi_3598_;
                                                phi_3599_ = _e4535;
                                                phi_3600_ = _e4520;
                                                phi_3601_ = _e4537;
                                            } else {
                                                phi_3599_ = f32();
                                                phi_3600_ = true;
                                                phi_3601_ = false;
                                            }
                                            let _e4539 = phi_3599_;
                                            let _e4541 = phi_3600_;
                                            let _e4543 = phi_3601_;
                                            if _e4541 {
                                                phi_3605_ = 2f;
                                                phi_3606_ = true;
                                            } else {
                                                phi_3605_ = _e3784;
                                                phi_3606_ = _e4543;
                                            }
                                            let _e4545 = phi_3605_;
                                            let _e4547 = phi_3606_;
                                            if _e4547 {
                                                phi_3610_ = _e4545;
                                            } else {
                                                phi_3610_ = _e4539;
                                            }
                                            let _e4549 = phi_3610_;
                                            if (_e4504 < _e4549) {
                                                phi_3615_ = _e4504;
                                            } else {
                                                phi_3615_ = _e4549;
                                            }
                                            let _e4552 = phi_3615_;
                                            if (_e4459 < _e4552) {
                                                phi_3620_ = _e4459;
                                            } else {
                                                phi_3620_ = _e4552;
                                            }
                                            let _e4555 = phi_3620_;
                                            if (_e4555 > _e3784) {
                                                phi_3625_ = _e4555;
                                            } else {
                                                phi_3625_ = _e3784;
                                            }
                                            let _e4558 = phi_3625_;
                                            let _e4559 = (_e4558 > 1f);
                                            if _e4559 {
                                                phi_4129_ = f32();
                                                phi_4130_ = f32();
                                                phi_4131_ = false;
                                                phi_4132_ = false;
                                            } else {
                                                let _e4560 = (_e4558 - _e3784);
                                                let _e4561 = (_e4560 <= 0.0000000037252903f);
                                                let _e4562 = (_e4558 + 0.00000001f);
                                                if (_e4562 < 1f) {
                                                    phi_3637_ = _e4562;
                                                } else {
                                                    phi_3637_ = 1f;
                                                }
                                                let _e4565 = phi_3637_;
                                                if _e4561 {
                                                    if (_e452.member_1 > 0f) {
                                                        let _e4569 = local_12.member[0u];
                                                        let _e4575 = local_12.member[1u];
                                                        let _e4591 = local_12.member_1[0u];
                                                        let _e4597 = local_12.member_1[1u];
                                                        let _e4613 = local_12.member_2[0u];
                                                        let _e4619 = local_12.member_2[1u];
                                                        let _e4633 = function_1(array<f32, 3>((_e4569[0] + ((_e4575[0] - _e4569[0]) * _e4565)), (_e4569[1] + ((_e4575[1] - _e4569[1]) * _e4565)), (_e4569[2] + ((_e4575[2] - _e4569[2]) * _e4565))), array<f32, 3>((_e4591[0] + ((_e4597[0] - _e4591[0]) * _e4565)), (_e4591[1] + ((_e4597[1] - _e4591[1]) * _e4565)), (_e4591[2] + ((_e4597[2] - _e4591[2]) * _e4565))), array<f32, 3>((_e4613[0] + ((_e4619[0] - _e4613[0]) * _e4565)), (_e4613[1] + ((_e4619[1] - _e4613[1]) * _e4565)), (_e4613[2] + ((_e4619[2] - _e4613[2]) * _e4565))), 0u);
                                                        let _e4644 = (((_e4633[0] * _e4633[0]) + (_e4633[1] * _e4633[1])) + (_e4633[2] * _e4633[2]));
                                                        if (_e4644 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e4644 > 0f) {
                                                                phi_3767_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_3767_ = 0f;
                                                            }
                                                            let _e4697 = phi_3767_;
                                                            phi_3831_ = _e4697;
                                                        } else {
                                                            phi_3774_ = type_14(0i, 5i);
                                                            phi_3777_ = bitcast<f32>(((bitcast<u32>(_e4644) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e4652 = phi_3774_;
                                                                let _e4654 = phi_3777_;
                                                                local_25 = _e4654;
                                                                if (_e4652.member < _e4652.member_1) {
                                                                    let _e4661 = (_e4652.member + 1i);
                                                                    if ((false == (_e4661 > _e4652.member)) != false) {
                                                                        phi_3798_ = true;
                                                                    } else {
                                                                        phi_3798_ = false;
                                                                    }
                                                                    let _e4666 = phi_3798_;
                                                                    if _e4666 {
                                                                        phi_3804_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_3804_ = type_15(1u, _e4661);
                                                                    }
                                                                    let _e4671 = phi_3804_;
                                                                    phi_3775_ = type_14(_e4671.member_1, _e4652.member_1);
                                                                    phi_3818_ = type_15(1u, _e4652.member);
                                                                } else {
                                                                    phi_3775_ = _e4652;
                                                                    phi_3818_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e4677 = phi_3775_;
                                                                let _e4679 = phi_3818_;
                                                                let _e4682 = (bitcast<i32>(_e4679.member) != 0i);
                                                                if _e4682 {
                                                                    phi_3778_ = (0.5f * (_e4654 + (_e4644 / _e4654)));
                                                                } else {
                                                                    phi_3778_ = f32();
                                                                }
                                                                let _e4687 = phi_3778_;
                                                                continue;
                                                                continuing {
                                                                    phi_3774_ = _e4677;
                                                                    phi_3777_ = _e4687;
                                                                    break if !(_e4682);
                                                                }
                                                            }
                                                            let _e4692 = local_25;
                                                            phi_3831_ = (_e4692 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e4699 = phi_3831_;
                                                        let _e4705 = local_12.member[0u];
                                                        if (_e4705[0] < 0f) {
                                                            phi_3847_ = -(_e4705[0]);
                                                        } else {
                                                            phi_3847_ = _e4705[0];
                                                        }
                                                        let _e4712 = phi_3847_;
                                                        if (_e4705[1] < 0f) {
                                                            phi_3854_ = -(_e4705[1]);
                                                        } else {
                                                            phi_3854_ = _e4705[1];
                                                        }
                                                        let _e4716 = phi_3854_;
                                                        if (_e4712 > _e4716) {
                                                            phi_3859_ = _e4712;
                                                        } else {
                                                            phi_3859_ = _e4716;
                                                        }
                                                        let _e4719 = phi_3859_;
                                                        if (_e4705[2] < 0f) {
                                                            phi_3866_ = -(_e4705[2]);
                                                        } else {
                                                            phi_3866_ = _e4705[2];
                                                        }
                                                        let _e4723 = phi_3866_;
                                                        if (_e4719 > _e4723) {
                                                            phi_3871_ = _e4719;
                                                        } else {
                                                            phi_3871_ = _e4723;
                                                        }
                                                        let _e4726 = phi_3871_;
                                                        let _e4729 = local_12.member[1u];
                                                        if (_e4729[0] < 0f) {
                                                            phi_3884_ = -(_e4729[0]);
                                                        } else {
                                                            phi_3884_ = _e4729[0];
                                                        }
                                                        let _e4736 = phi_3884_;
                                                        if (_e4729[1] < 0f) {
                                                            phi_3891_ = -(_e4729[1]);
                                                        } else {
                                                            phi_3891_ = _e4729[1];
                                                        }
                                                        let _e4740 = phi_3891_;
                                                        if (_e4736 > _e4740) {
                                                            phi_3896_ = _e4736;
                                                        } else {
                                                            phi_3896_ = _e4740;
                                                        }
                                                        let _e4743 = phi_3896_;
                                                        if (_e4729[2] < 0f) {
                                                            phi_3903_ = -(_e4729[2]);
                                                        } else {
                                                            phi_3903_ = _e4729[2];
                                                        }
                                                        let _e4747 = phi_3903_;
                                                        if (_e4743 > _e4747) {
                                                            phi_3908_ = _e4743;
                                                        } else {
                                                            phi_3908_ = _e4747;
                                                        }
                                                        let _e4750 = phi_3908_;
                                                        if (_e4726 > _e4750) {
                                                            phi_3913_ = _e4726;
                                                        } else {
                                                            phi_3913_ = _e4750;
                                                        }
                                                        let _e4753 = phi_3913_;
                                                        let _e4755 = local_12.member_3;
                                                        let _e4759 = local_12.member_1[0u];
                                                        if (_e4759[0] < 0f) {
                                                            phi_3930_ = -(_e4759[0]);
                                                        } else {
                                                            phi_3930_ = _e4759[0];
                                                        }
                                                        let _e4766 = phi_3930_;
                                                        if (_e4759[1] < 0f) {
                                                            phi_3937_ = -(_e4759[1]);
                                                        } else {
                                                            phi_3937_ = _e4759[1];
                                                        }
                                                        let _e4770 = phi_3937_;
                                                        if (_e4766 > _e4770) {
                                                            phi_3942_ = _e4766;
                                                        } else {
                                                            phi_3942_ = _e4770;
                                                        }
                                                        let _e4773 = phi_3942_;
                                                        if (_e4759[2] < 0f) {
                                                            phi_3949_ = -(_e4759[2]);
                                                        } else {
                                                            phi_3949_ = _e4759[2];
                                                        }
                                                        let _e4777 = phi_3949_;
                                                        if (_e4773 > _e4777) {
                                                            phi_3954_ = _e4773;
                                                        } else {
                                                            phi_3954_ = _e4777;
                                                        }
                                                        let _e4780 = phi_3954_;
                                                        let _e4783 = local_12.member_1[1u];
                                                        if (_e4783[0] < 0f) {
                                                            phi_3968_ = -(_e4783[0]);
                                                        } else {
                                                            phi_3968_ = _e4783[0];
                                                        }
                                                        let _e4790 = phi_3968_;
                                                        if (_e4783[1] < 0f) {
                                                            phi_3975_ = -(_e4783[1]);
                                                        } else {
                                                            phi_3975_ = _e4783[1];
                                                        }
                                                        let _e4794 = phi_3975_;
                                                        if (_e4790 > _e4794) {
                                                            phi_3980_ = _e4790;
                                                        } else {
                                                            phi_3980_ = _e4794;
                                                        }
                                                        let _e4797 = phi_3980_;
                                                        if (_e4783[2] < 0f) {
                                                            phi_3987_ = -(_e4783[2]);
                                                        } else {
                                                            phi_3987_ = _e4783[2];
                                                        }
                                                        let _e4801 = phi_3987_;
                                                        if (_e4797 > _e4801) {
                                                            phi_3992_ = _e4797;
                                                        } else {
                                                            phi_3992_ = _e4801;
                                                        }
                                                        let _e4804 = phi_3992_;
                                                        if (_e4780 > _e4804) {
                                                            phi_3997_ = _e4780;
                                                        } else {
                                                            phi_3997_ = _e4804;
                                                        }
                                                        let _e4807 = phi_3997_;
                                                        let _e4809 = local_12.member_3;
                                                        let _e4813 = local_12.member_2[0u];
                                                        if (_e4813[0] < 0f) {
                                                            phi_4014_ = -(_e4813[0]);
                                                        } else {
                                                            phi_4014_ = _e4813[0];
                                                        }
                                                        let _e4820 = phi_4014_;
                                                        if (_e4813[1] < 0f) {
                                                            phi_4021_ = -(_e4813[1]);
                                                        } else {
                                                            phi_4021_ = _e4813[1];
                                                        }
                                                        let _e4824 = phi_4021_;
                                                        if (_e4820 > _e4824) {
                                                            phi_4026_ = _e4820;
                                                        } else {
                                                            phi_4026_ = _e4824;
                                                        }
                                                        let _e4827 = phi_4026_;
                                                        if (_e4813[2] < 0f) {
                                                            phi_4033_ = -(_e4813[2]);
                                                        } else {
                                                            phi_4033_ = _e4813[2];
                                                        }
                                                        let _e4831 = phi_4033_;
                                                        if (_e4827 > _e4831) {
                                                            phi_4038_ = _e4827;
                                                        } else {
                                                            phi_4038_ = _e4831;
                                                        }
                                                        let _e4834 = phi_4038_;
                                                        let _e4837 = local_12.member_2[1u];
                                                        if (_e4837[0] < 0f) {
                                                            phi_4052_ = -(_e4837[0]);
                                                        } else {
                                                            phi_4052_ = _e4837[0];
                                                        }
                                                        let _e4844 = phi_4052_;
                                                        if (_e4837[1] < 0f) {
                                                            phi_4059_ = -(_e4837[1]);
                                                        } else {
                                                            phi_4059_ = _e4837[1];
                                                        }
                                                        let _e4848 = phi_4059_;
                                                        if (_e4844 > _e4848) {
                                                            phi_4064_ = _e4844;
                                                        } else {
                                                            phi_4064_ = _e4848;
                                                        }
                                                        let _e4851 = phi_4064_;
                                                        if (_e4837[2] < 0f) {
                                                            phi_4071_ = -(_e4837[2]);
                                                        } else {
                                                            phi_4071_ = _e4837[2];
                                                        }
                                                        let _e4855 = phi_4071_;
                                                        if (_e4851 > _e4855) {
                                                            phi_4076_ = _e4851;
                                                        } else {
                                                            phi_4076_ = _e4855;
                                                        }
                                                        let _e4858 = phi_4076_;
                                                        if (_e4834 > _e4858) {
                                                            phi_4081_ = _e4834;
                                                        } else {
                                                            phi_4081_ = _e4858;
                                                        }
                                                        let _e4861 = phi_4081_;
                                                        let _e4863 = local_12.member_3;
                                                        let _e4870 = local_12.member_3;
                                                        if (((_e4699 * (1f + (0.000000059604645f * 8f))) + (((((((_e4753 + _e4755) + (_e4807 + _e4809)) + (_e4861 + _e4863)) * (0.000000059604645f * 16f)) + (_e4870 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e452.member_1) {
                                                            phi_4101_ = false;
                                                        } else {
                                                            phi_4101_ = true;
                                                        }
                                                        let _e4879 = phi_4101_;
                                                        phi_4102_ = _e4879;
                                                    } else {
                                                        phi_4102_ = true;
                                                    }
                                                    let _e4881 = phi_4102_;
                                                    phi_4103_ = _e4881;
                                                } else {
                                                    phi_4103_ = true;
                                                }
                                                let _e4883 = phi_4103_;
                                                if _e4883 {
                                                    if _e3792 {
                                                        if _e4561 {
                                                            phi_4119_ = true;
                                                        } else {
                                                            if (_e4560 <= (_e3788 * 0.25f)) {
                                                                phi_4118_ = false;
                                                            } else {
                                                                phi_4118_ = true;
                                                            }
                                                            let _e4888 = phi_4118_;
                                                            phi_4119_ = _e4888;
                                                        }
                                                        let _e4890 = phi_4119_;
                                                        if _e4890 {
                                                            phi_4124_ = (_e4106 + _e4106);
                                                        } else {
                                                            phi_4124_ = 0f;
                                                        }
                                                        let _e4893 = phi_4124_;
                                                        phi_4126_ = _e4893;
                                                    } else {
                                                        phi_4126_ = (1f - _e3784);
                                                    }
                                                    let _e4895 = phi_4126_;
                                                    phi_4127_ = _e4895;
                                                    phi_4128_ = false;
                                                } else {
                                                    phi_4127_ = f32();
                                                    phi_4128_ = true;
                                                }
                                                let _e4897 = phi_4127_;
                                                let _e4899 = phi_4128_;
                                                phi_4129_ = _e4897;
                                                phi_4130_ = _e4560;
                                                phi_4131_ = _e4883;
                                                phi_4132_ = _e4899;
                                            }
                                            let _e4901 = phi_4129_;
                                            let _e4903 = phi_4130_;
                                            let _e4905 = phi_4131_;
                                            let _e4907 = phi_4132_;
                                            phi_4133_ = _e4558;
                                            phi_4134_ = _e4901;
                                            phi_4135_ = _e4903;
                                            phi_4136_ = _e4558;
                                            phi_4137_ = _e4905;
                                            phi_4138_ = _e4559;
                                            phi_4139_ = _e4907;
                                            phi_4140_ = false;
                                        } else {
                                            phi_4133_ = f32();
                                            phi_4134_ = f32();
                                            phi_4135_ = f32();
                                            phi_4136_ = f32();
                                            phi_4137_ = false;
                                            phi_4138_ = false;
                                            phi_4139_ = false;
                                            phi_4140_ = true;
                                        }
                                        let _e4909 = phi_4133_;
                                        let _e4911 = phi_4134_;
                                        let _e4913 = phi_4135_;
                                        let _e4915 = phi_4136_;
                                        let _e4917 = phi_4137_;
                                        let _e4919 = phi_4138_;
                                        let _e4921 = phi_4139_;
                                        let _e4923 = phi_4140_;
                                        phi_4141_ = _e4909;
                                        phi_4142_ = _e4911;
                                        phi_4143_ = _e4913;
                                        phi_4144_ = _e4915;
                                        phi_4145_ = false;
                                        phi_4146_ = _e4917;
                                        phi_4147_ = _e4919;
                                        phi_4148_ = _e4921;
                                        phi_4149_ = _e4923;
                                    } else {
                                        phi_4141_ = f32();
                                        phi_4142_ = f32();
                                        phi_4143_ = f32();
                                        phi_4144_ = f32();
                                        phi_4145_ = true;
                                        phi_4146_ = false;
                                        phi_4147_ = false;
                                        phi_4148_ = false;
                                        phi_4149_ = false;
                                    }
                                    let _e4925 = phi_4141_;
                                    let _e4927 = phi_4142_;
                                    let _e4929 = phi_4143_;
                                    let _e4931 = phi_4144_;
                                    let _e4933 = phi_4145_;
                                    let _e4935 = phi_4146_;
                                    let _e4937 = phi_4147_;
                                    let _e4939 = phi_4148_;
                                    let _e4941 = phi_4149_;
                                    phi_4150_ = _e4925;
                                    phi_4151_ = _e4927;
                                    phi_4152_ = _e4929;
                                    phi_4153_ = _e4931;
                                    phi_4154_ = _e4933;
                                    phi_4155_ = _e4935;
                                    phi_4156_ = _e4937;
                                    phi_4157_ = _e4939;
                                    phi_4158_ = _e4941;
                                } else {
                                    phi_4150_ = f32();
                                    phi_4151_ = f32();
                                    phi_4152_ = f32();
                                    phi_4153_ = f32();
                                    phi_4154_ = true;
                                    phi_4155_ = false;
                                    phi_4156_ = false;
                                    phi_4157_ = false;
                                    phi_4158_ = false;
                                }
                                let _e4943 = phi_4150_;
                                let _e4945 = phi_4151_;
                                let _e4947 = phi_4152_;
                                let _e4949 = phi_4153_;
                                let _e4951 = phi_4154_;
                                let _e4953 = phi_4155_;
                                let _e4955 = phi_4156_;
                                let _e4957 = phi_4157_;
                                let _e4959 = phi_4158_;
                                if _e4951 {
                                    if (_e3784 <= _e3786) {
                                        let _e5120 = (_e3794 + 1u);
                                        let _e5121 = (_e5120 > 3u);
                                        if _e5121 {
                                            phi_4171_ = false;
                                        } else {
                                            phi_4171_ = true;
                                        }
                                        let _e5123 = phi_4171_;
                                        phi_4493_ = _e5120;
                                        phi_4494_ = f32();
                                        phi_4495_ = false;
                                        phi_4496_ = _e5123;
                                        phi_4497_ = _e5121;
                                    } else {
                                        let _e4963 = local_9.member[0u];
                                        let _e4966 = local_9.member_1[0u];
                                        let _e4969 = local_9.member[0u];
                                        let _e4975 = local_9.member_2[0u];
                                        let _e4976 = ((_e4963 + ((_e4966 - _e4969) * _e3790)) - _e4975);
                                        let _e4979 = local_9.member[1u];
                                        let _e4982 = local_9.member_1[1u];
                                        let _e4985 = local_9.member[1u];
                                        let _e4991 = local_9.member_2[1u];
                                        let _e4992 = ((_e4979 + ((_e4982 - _e4985) * _e3790)) - _e4991);
                                        if (_e4976 < _e4992) {
                                            phi_4244_ = _e4976;
                                        } else {
                                            phi_4244_ = _e4992;
                                        }
                                        let _e4995 = phi_4244_;
                                        let _e4998 = local_9.member[2u];
                                        let _e5001 = local_9.member_1[2u];
                                        let _e5004 = local_9.member[2u];
                                        let _e5010 = local_9.member_2[2u];
                                        let _e5011 = ((_e4998 + ((_e5001 - _e5004) * _e3790)) - _e5010);
                                        let _e5014 = local_9.member[3u];
                                        let _e5017 = local_9.member_1[3u];
                                        let _e5020 = local_9.member[3u];
                                        let _e5026 = local_9.member_2[3u];
                                        let _e5027 = ((_e5014 + ((_e5017 - _e5020) * _e3790)) - _e5026);
                                        if (_e5011 < _e5027) {
                                            phi_4317_ = _e5011;
                                        } else {
                                            phi_4317_ = _e5027;
                                        }
                                        let _e5030 = phi_4317_;
                                        if (_e4995 < _e5030) {
                                            phi_4322_ = _e4995;
                                        } else {
                                            phi_4322_ = _e5030;
                                        }
                                        let _e5033 = phi_4322_;
                                        let _e5036 = local_10.member[0u];
                                        let _e5039 = local_10.member_1[0u];
                                        let _e5042 = local_10.member[0u];
                                        let _e5048 = local_10.member_2[0u];
                                        let _e5049 = ((_e5036 + ((_e5039 - _e5042) * _e3784)) - _e5048);
                                        let _e5052 = local_10.member[1u];
                                        let _e5055 = local_10.member_1[1u];
                                        let _e5058 = local_10.member[1u];
                                        let _e5064 = local_10.member_2[1u];
                                        let _e5065 = ((_e5052 + ((_e5055 - _e5058) * _e3784)) - _e5064);
                                        if (_e5049 < _e5065) {
                                            phi_4395_ = _e5049;
                                        } else {
                                            phi_4395_ = _e5065;
                                        }
                                        let _e5068 = phi_4395_;
                                        let _e5071 = local_10.member[2u];
                                        let _e5074 = local_10.member_1[2u];
                                        let _e5077 = local_10.member[2u];
                                        let _e5083 = local_10.member_2[2u];
                                        let _e5084 = ((_e5071 + ((_e5074 - _e5077) * _e3784)) - _e5083);
                                        let _e5087 = local_10.member[3u];
                                        let _e5090 = local_10.member_1[3u];
                                        let _e5093 = local_10.member[3u];
                                        let _e5099 = local_10.member_2[3u];
                                        let _e5100 = ((_e5087 + ((_e5090 - _e5093) * _e3784)) - _e5099);
                                        if (_e5084 < _e5100) {
                                            phi_4468_ = _e5084;
                                        } else {
                                            phi_4468_ = _e5100;
                                        }
                                        let _e5103 = phi_4468_;
                                        if (_e5068 < _e5103) {
                                            phi_4473_ = _e5068;
                                        } else {
                                            phi_4473_ = _e5103;
                                        }
                                        let _e5106 = phi_4473_;
                                        if (_e5106 > 0f) {
                                            phi_4491_ = 0.5f;
                                        } else {
                                            let _e5110 = (0.95f * (_e5033 / (_e5033 - _e5106)));
                                            if (_e5110 > 0.0625f) {
                                                if (_e5110 < 0.9f) {
                                                    phi_4489_ = _e5110;
                                                } else {
                                                    phi_4489_ = 0.9f;
                                                }
                                                let _e5114 = phi_4489_;
                                                phi_4490_ = _e5114;
                                            } else {
                                                phi_4490_ = 0.0625f;
                                            }
                                            let _e5116 = phi_4490_;
                                            phi_4491_ = _e5116;
                                        }
                                        let _e5118 = phi_4491_;
                                        phi_4493_ = u32();
                                        phi_4494_ = (_e4106 * _e5118);
                                        phi_4495_ = true;
                                        phi_4496_ = false;
                                        phi_4497_ = false;
                                    }
                                    let _e5125 = phi_4493_;
                                    let _e5127 = phi_4494_;
                                    let _e5129 = phi_4495_;
                                    let _e5131 = phi_4496_;
                                    let _e5133 = phi_4497_;
                                    phi_4498_ = _e5125;
                                    phi_4499_ = _e3786;
                                    phi_4500_ = _e5127;
                                    phi_4501_ = _e3788;
                                    phi_4502_ = _e3790;
                                    phi_4503_ = _e3792;
                                    phi_4504_ = _e3794;
                                    phi_4505_ = _e5129;
                                    phi_4506_ = _e5131;
                                    phi_4507_ = _e5133;
                                    phi_4508_ = false;
                                    phi_4509_ = false;
                                    phi_4510_ = false;
                                } else {
                                    phi_4498_ = u32();
                                    phi_4499_ = _e4943;
                                    phi_4500_ = _e4945;
                                    phi_4501_ = _e4947;
                                    phi_4502_ = _e3784;
                                    phi_4503_ = true;
                                    phi_4504_ = 0u;
                                    phi_4505_ = _e4953;
                                    phi_4506_ = false;
                                    phi_4507_ = false;
                                    phi_4508_ = _e4955;
                                    phi_4509_ = _e4957;
                                    phi_4510_ = _e4959;
                                }
                                let _e5135 = phi_4498_;
                                let _e5137 = phi_4499_;
                                let _e5139 = phi_4500_;
                                let _e5141 = phi_4501_;
                                let _e5143 = phi_4502_;
                                let _e5145 = phi_4503_;
                                let _e5147 = phi_4504_;
                                let _e5149 = phi_4505_;
                                let _e5151 = phi_4506_;
                                let _e5153 = phi_4507_;
                                let _e5155 = phi_4508_;
                                let _e5157 = phi_4509_;
                                let _e5159 = phi_4510_;
                                if _e5149 {
                                    let _e5160 = (_e5143 + _e5139);
                                    if (_e5160 > _e5137) {
                                        phi_4519_ = _e5160;
                                    } else {
                                        phi_4519_ = _e5137;
                                    }
                                    let _e5163 = phi_4519_;
                                    if (_e5163 < 1f) {
                                        phi_4524_ = _e5163;
                                    } else {
                                        phi_4524_ = 1f;
                                    }
                                    let _e5166 = phi_4524_;
                                    if !(_e3792) {
                                        phi_4533_ = true;
                                    } else {
                                        phi_4533_ = ((_e5166 - _e5143) > 0.0000000037252903f);
                                    }
                                    let _e5170 = phi_4533_;
                                    if _e5170 {
                                        phi_4537_ = false;
                                    } else {
                                        phi_4537_ = true;
                                    }
                                    let _e5172 = phi_4537_;
                                    phi_4538_ = _e5166;
                                    phi_4539_ = _e5137;
                                    phi_4540_ = _e5141;
                                    phi_4541_ = _e5143;
                                    phi_4542_ = _e5145;
                                    phi_4543_ = _e5147;
                                    phi_4544_ = _e5170;
                                    phi_4545_ = _e5172;
                                    phi_4546_ = false;
                                    phi_4547_ = false;
                                    phi_4548_ = false;
                                    phi_4549_ = false;
                                } else {
                                    phi_4538_ = _e3784;
                                    phi_4539_ = _e3786;
                                    phi_4540_ = _e3788;
                                    phi_4541_ = _e3790;
                                    phi_4542_ = _e3792;
                                    phi_4543_ = _e5135;
                                    phi_4544_ = _e5151;
                                    phi_4545_ = false;
                                    phi_4546_ = _e5153;
                                    phi_4547_ = _e5155;
                                    phi_4548_ = _e5157;
                                    phi_4549_ = _e5159;
                                }
                                let _e5174 = phi_4538_;
                                let _e5176 = phi_4539_;
                                let _e5178 = phi_4540_;
                                let _e5180 = phi_4541_;
                                let _e5182 = phi_4542_;
                                let _e5184 = phi_4543_;
                                let _e5186 = phi_4544_;
                                let _e5188 = phi_4545_;
                                let _e5190 = phi_4546_;
                                let _e5192 = phi_4547_;
                                let _e5194 = phi_4548_;
                                let _e5196 = phi_4549_;
                                phi_2372_ = _e5174;
                                phi_2374_ = _e5176;
                                phi_2376_ = _e5178;
                                phi_2378_ = _e5180;
                                phi_2380_ = _e5182;
                                phi_2382_ = _e5184;
                                phi_4550_ = _e5137;
                                phi_4551_ = _e4949;
                                phi_4552_ = _e5186;
                                phi_4553_ = _e5188;
                                phi_4554_ = _e5190;
                                phi_4555_ = _e5192;
                                phi_4556_ = _e5194;
                                phi_4557_ = false;
                                phi_4558_ = _e5196;
                            } else {
                                phi_2372_ = f32();
                                phi_2374_ = f32();
                                phi_2376_ = f32();
                                phi_2378_ = f32();
                                phi_2380_ = bool();
                                phi_2382_ = u32();
                                phi_4550_ = f32();
                                phi_4551_ = f32();
                                phi_4552_ = false;
                                phi_4553_ = false;
                                phi_4554_ = false;
                                phi_4555_ = false;
                                phi_4556_ = false;
                                phi_4557_ = true;
                                phi_4558_ = false;
                            }
                            let _e5198 = phi_2372_;
                            let _e5200 = phi_2374_;
                            let _e5202 = phi_2376_;
                            let _e5204 = phi_2378_;
                            let _e5206 = phi_2380_;
                            let _e5208 = phi_2382_;
                            let _e5210 = phi_4550_;
                            let _e5212 = phi_4551_;
                            let _e5214 = phi_4552_;
                            let _e5216 = phi_4553_;
                            let _e5218 = phi_4554_;
                            let _e5220 = phi_4555_;
                            let _e5222 = phi_4556_;
                            let _e5224 = phi_4557_;
                            let _e5226 = phi_4558_;
                            local_26 = _e5216;
                            local_45 = _e5218;
                            local_46 = _e5220;
                            local_47 = _e5222;
                            local_48 = _e5224;
                            local_49 = _e5226;
                            local_50 = _e5216;
                            local_51 = _e5212;
                            local_52 = _e5210;
                            continue;
                            continuing {
                                phi_2368_ = _e3806;
                                phi_2371_ = _e5198;
                                phi_2373_ = _e5200;
                                phi_2375_ = _e5202;
                                phi_2377_ = _e5204;
                                phi_2379_ = _e5206;
                                phi_2381_ = _e5208;
                                break if !(_e5214);
                            }
                        }
                        let _e5229 = local_26;
                        if _e5229 {
                            phi_4562_ = false;
                            phi_4563_ = false;
                            phi_4564_ = false;
                            phi_4565_ = false;
                            phi_4566_ = false;
                        } else {
                            let _e6699 = local_45;
                            phi_4562_ = _e6699;
                            let _e6702 = local_46;
                            phi_4563_ = _e6702;
                            let _e6705 = local_47;
                            phi_4564_ = _e6705;
                            let _e6708 = local_48;
                            phi_4565_ = _e6708;
                            let _e6711 = local_49;
                            phi_4566_ = _e6711;
                        }
                        let _e5231 = phi_4562_;
                        let _e5233 = phi_4563_;
                        let _e5235 = phi_4564_;
                        let _e5237 = phi_4565_;
                        let _e5239 = phi_4566_;
                        if _e5231 {
                            let _e5241 = local_27;
                            phi_4571_ = type_28(1u, _e5241);
                            phi_4572_ = false;
                            phi_4573_ = false;
                            phi_4574_ = false;
                            phi_4575_ = false;
                            phi_4576_ = false;
                        } else {
                            phi_4571_ = type_28();
                            phi_4572_ = _e5233;
                            phi_4573_ = _e5235;
                            let _e6718 = local_50;
                            phi_4574_ = _e6718;
                            phi_4575_ = _e5237;
                            phi_4576_ = _e5239;
                        }
                        let _e5244 = phi_4571_;
                        let _e5246 = phi_4572_;
                        let _e5248 = phi_4573_;
                        let _e5250 = phi_4574_;
                        let _e5252 = phi_4575_;
                        let _e5254 = phi_4576_;
                        if _e5246 {
                            phi_4581_ = type_28(0u, type_28().member_1);
                            phi_4582_ = false;
                            phi_4583_ = false;
                            phi_4584_ = false;
                            phi_4585_ = false;
                            phi_4586_ = true;
                        } else {
                            phi_4581_ = _e5244;
                            phi_4582_ = _e5248;
                            phi_4583_ = _e5250;
                            phi_4584_ = _e5252;
                            phi_4585_ = _e5254;
                            phi_4586_ = _e5231;
                        }
                        let _e5258 = phi_4581_;
                        let _e5260 = phi_4582_;
                        let _e5262 = phi_4583_;
                        let _e5264 = phi_4584_;
                        let _e5266 = phi_4585_;
                        let _e5268 = phi_4586_;
                        if _e5260 {
                            let _e6729 = local_51;
                            phi_4590_ = _e6729;
                            phi_4591_ = true;
                            phi_4592_ = false;
                            phi_4593_ = false;
                            phi_4594_ = false;
                        } else {
                            let _e6731 = local_52;
                            phi_4590_ = _e6731;
                            phi_4591_ = _e5262;
                            phi_4592_ = _e5264;
                            phi_4593_ = _e5266;
                            phi_4594_ = _e5268;
                        }
                        let _e5270 = phi_4590_;
                        let _e5272 = phi_4591_;
                        let _e5274 = phi_4592_;
                        let _e5276 = phi_4593_;
                        let _e5278 = phi_4594_;
                        if _e5272 {
                            phi_4598_ = _e5270;
                            phi_4599_ = true;
                            phi_4600_ = false;
                            phi_4601_ = false;
                        } else {
                            let _e6738 = local_53;
                            phi_4598_ = _e6738;
                            phi_4599_ = _e5274;
                            phi_4600_ = _e5276;
                            phi_4601_ = _e5278;
                        }
                        let _e5280 = phi_4598_;
                        let _e5282 = phi_4599_;
                        let _e5284 = phi_4600_;
                        let _e5286 = phi_4601_;
                        if _e5282 {
                            phi_4606_ = type_28(1u, _e5280);
                            phi_4607_ = false;
                            phi_4608_ = false;
                        } else {
                            phi_4606_ = type_28();
                            phi_4607_ = _e5284;
                            phi_4608_ = _e5286;
                        }
                        let _e5289 = phi_4606_;
                        let _e5291 = phi_4607_;
                        let _e5293 = phi_4608_;
                        if _e5291 {
                            phi_4613_ = type_28(0u, type_28().member_1);
                            phi_4614_ = true;
                        } else {
                            phi_4613_ = _e5258;
                            phi_4614_ = _e5293;
                        }
                        let _e5297 = phi_4613_;
                        let _e5299 = phi_4614_;
                        if _e5299 {
                            phi_4618_ = _e5297;
                        } else {
                            phi_4618_ = _e5289;
                        }
                        let _e5301 = phi_4618_;
                        if (_e5301.member != 0u) {
                            local_11[0u] = 0.00000001f;
                            local_11[1u] = 0f;
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4631_ = type_12(0u, 3u);
                            loop {
                                let _e5312 = phi_4631_;
                                if (_e5312.member < _e5312.member_1) {
                                    phi_4632_ = type_12((_e5312.member + 1u), _e5312.member_1);
                                    phi_4655_ = type_12(1u, _e5312.member);
                                } else {
                                    phi_4632_ = _e5312;
                                    phi_4655_ = type_12(0u, type_12().member_1);
                                }
                                let _e5324 = phi_4632_;
                                let _e5326 = phi_4655_;
                                if (bitcast<i32>(_e5326.member) != 0i) {
                                    let _e5332 = local_11[_e5326.member_1];
                                    let _e5333 = (_e5301.member_1 + _e5332);
                                    if (_e5333 < 1f) {
                                        phi_4675_ = _e5333;
                                    } else {
                                        phi_4675_ = 1f;
                                    }
                                    let _e5336 = phi_4675_;
                                    let _e5339 = local_12.member[0u];
                                    let _e5345 = local_12.member[1u];
                                    let _e5361 = local_12.member_1[0u];
                                    let _e5367 = local_12.member_1[1u];
                                    let _e5383 = local_12.member_2[0u];
                                    let _e5389 = local_12.member_2[1u];
                                    let _e5403 = function_1(array<f32, 3>((_e5339[0] + ((_e5345[0] - _e5339[0]) * _e5336)), (_e5339[1] + ((_e5345[1] - _e5339[1]) * _e5336)), (_e5339[2] + ((_e5345[2] - _e5339[2]) * _e5336))), array<f32, 3>((_e5361[0] + ((_e5367[0] - _e5361[0]) * _e5336)), (_e5361[1] + ((_e5367[1] - _e5361[1]) * _e5336)), (_e5361[2] + ((_e5367[2] - _e5361[2]) * _e5336))), array<f32, 3>((_e5383[0] + ((_e5389[0] - _e5383[0]) * _e5336)), (_e5383[1] + ((_e5389[1] - _e5383[1]) * _e5336)), (_e5383[2] + ((_e5389[2] - _e5383[2]) * _e5336))), 0u);
                                    let _e5414 = (((_e5403[0] * _e5403[0]) + (_e5403[1] * _e5403[1])) + (_e5403[2] * _e5403[2]));
                                    if (_e5414 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e5414 > 0f) {
                                            phi_4798_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_4798_ = 0f;
                                        }
                                        let _e5467 = phi_4798_;
                                        phi_4862_ = _e5467;
                                    } else {
                                        phi_4805_ = type_14(0i, 5i);
                                        phi_4808_ = bitcast<f32>(((bitcast<u32>(_e5414) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e5422 = phi_4805_;
                                            let _e5424 = phi_4808_;
                                            local_28 = _e5424;
                                            if (_e5422.member < _e5422.member_1) {
                                                let _e5431 = (_e5422.member + 1i);
                                                if ((false == (_e5431 > _e5422.member)) != false) {
                                                    phi_4829_ = true;
                                                } else {
                                                    phi_4829_ = false;
                                                }
                                                let _e5436 = phi_4829_;
                                                if _e5436 {
                                                    phi_4835_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_4835_ = type_15(1u, _e5431);
                                                }
                                                let _e5441 = phi_4835_;
                                                phi_4806_ = type_14(_e5441.member_1, _e5422.member_1);
                                                phi_4849_ = type_15(1u, _e5422.member);
                                            } else {
                                                phi_4806_ = _e5422;
                                                phi_4849_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5447 = phi_4806_;
                                            let _e5449 = phi_4849_;
                                            let _e5452 = (bitcast<i32>(_e5449.member) != 0i);
                                            if _e5452 {
                                                phi_4809_ = (0.5f * (_e5424 + (_e5414 / _e5424)));
                                            } else {
                                                phi_4809_ = f32();
                                            }
                                            let _e5457 = phi_4809_;
                                            continue;
                                            continuing {
                                                phi_4805_ = _e5447;
                                                phi_4808_ = _e5457;
                                                break if !(_e5452);
                                            }
                                        }
                                        let _e5462 = local_28;
                                        phi_4862_ = (_e5462 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5469 = phi_4862_;
                                    let _e5475 = local_12.member[0u];
                                    if (_e5475[0] < 0f) {
                                        phi_4878_ = -(_e5475[0]);
                                    } else {
                                        phi_4878_ = _e5475[0];
                                    }
                                    let _e5482 = phi_4878_;
                                    if (_e5475[1] < 0f) {
                                        phi_4885_ = -(_e5475[1]);
                                    } else {
                                        phi_4885_ = _e5475[1];
                                    }
                                    let _e5486 = phi_4885_;
                                    if (_e5482 > _e5486) {
                                        phi_4890_ = _e5482;
                                    } else {
                                        phi_4890_ = _e5486;
                                    }
                                    let _e5489 = phi_4890_;
                                    if (_e5475[2] < 0f) {
                                        phi_4897_ = -(_e5475[2]);
                                    } else {
                                        phi_4897_ = _e5475[2];
                                    }
                                    let _e5493 = phi_4897_;
                                    if (_e5489 > _e5493) {
                                        phi_4902_ = _e5489;
                                    } else {
                                        phi_4902_ = _e5493;
                                    }
                                    let _e5496 = phi_4902_;
                                    let _e5499 = local_12.member[1u];
                                    if (_e5499[0] < 0f) {
                                        phi_4915_ = -(_e5499[0]);
                                    } else {
                                        phi_4915_ = _e5499[0];
                                    }
                                    let _e5506 = phi_4915_;
                                    if (_e5499[1] < 0f) {
                                        phi_4922_ = -(_e5499[1]);
                                    } else {
                                        phi_4922_ = _e5499[1];
                                    }
                                    let _e5510 = phi_4922_;
                                    if (_e5506 > _e5510) {
                                        phi_4927_ = _e5506;
                                    } else {
                                        phi_4927_ = _e5510;
                                    }
                                    let _e5513 = phi_4927_;
                                    if (_e5499[2] < 0f) {
                                        phi_4934_ = -(_e5499[2]);
                                    } else {
                                        phi_4934_ = _e5499[2];
                                    }
                                    let _e5517 = phi_4934_;
                                    if (_e5513 > _e5517) {
                                        phi_4939_ = _e5513;
                                    } else {
                                        phi_4939_ = _e5517;
                                    }
                                    let _e5520 = phi_4939_;
                                    if (_e5496 > _e5520) {
                                        phi_4944_ = _e5496;
                                    } else {
                                        phi_4944_ = _e5520;
                                    }
                                    let _e5523 = phi_4944_;
                                    let _e5525 = local_12.member_3;
                                    let _e5529 = local_12.member_1[0u];
                                    if (_e5529[0] < 0f) {
                                        phi_4961_ = -(_e5529[0]);
                                    } else {
                                        phi_4961_ = _e5529[0];
                                    }
                                    let _e5536 = phi_4961_;
                                    if (_e5529[1] < 0f) {
                                        phi_4968_ = -(_e5529[1]);
                                    } else {
                                        phi_4968_ = _e5529[1];
                                    }
                                    let _e5540 = phi_4968_;
                                    if (_e5536 > _e5540) {
                                        phi_4973_ = _e5536;
                                    } else {
                                        phi_4973_ = _e5540;
                                    }
                                    let _e5543 = phi_4973_;
                                    if (_e5529[2] < 0f) {
                                        phi_4980_ = -(_e5529[2]);
                                    } else {
                                        phi_4980_ = _e5529[2];
                                    }
                                    let _e5547 = phi_4980_;
                                    if (_e5543 > _e5547) {
                                        phi_4985_ = _e5543;
                                    } else {
                                        phi_4985_ = _e5547;
                                    }
                                    let _e5550 = phi_4985_;
                                    let _e5553 = local_12.member_1[1u];
                                    if (_e5553[0] < 0f) {
                                        phi_4999_ = -(_e5553[0]);
                                    } else {
                                        phi_4999_ = _e5553[0];
                                    }
                                    let _e5560 = phi_4999_;
                                    if (_e5553[1] < 0f) {
                                        phi_5006_ = -(_e5553[1]);
                                    } else {
                                        phi_5006_ = _e5553[1];
                                    }
                                    let _e5564 = phi_5006_;
                                    if (_e5560 > _e5564) {
                                        phi_5011_ = _e5560;
                                    } else {
                                        phi_5011_ = _e5564;
                                    }
                                    let _e5567 = phi_5011_;
                                    if (_e5553[2] < 0f) {
                                        phi_5018_ = -(_e5553[2]);
                                    } else {
                                        phi_5018_ = _e5553[2];
                                    }
                                    let _e5571 = phi_5018_;
                                    if (_e5567 > _e5571) {
                                        phi_5023_ = _e5567;
                                    } else {
                                        phi_5023_ = _e5571;
                                    }
                                    let _e5574 = phi_5023_;
                                    if (_e5550 > _e5574) {
                                        phi_5028_ = _e5550;
                                    } else {
                                        phi_5028_ = _e5574;
                                    }
                                    let _e5577 = phi_5028_;
                                    let _e5579 = local_12.member_3;
                                    let _e5583 = local_12.member_2[0u];
                                    if (_e5583[0] < 0f) {
                                        phi_5045_ = -(_e5583[0]);
                                    } else {
                                        phi_5045_ = _e5583[0];
                                    }
                                    let _e5590 = phi_5045_;
                                    if (_e5583[1] < 0f) {
                                        phi_5052_ = -(_e5583[1]);
                                    } else {
                                        phi_5052_ = _e5583[1];
                                    }
                                    let _e5594 = phi_5052_;
                                    if (_e5590 > _e5594) {
                                        phi_5057_ = _e5590;
                                    } else {
                                        phi_5057_ = _e5594;
                                    }
                                    let _e5597 = phi_5057_;
                                    if (_e5583[2] < 0f) {
                                        phi_5064_ = -(_e5583[2]);
                                    } else {
                                        phi_5064_ = _e5583[2];
                                    }
                                    let _e5601 = phi_5064_;
                                    if (_e5597 > _e5601) {
                                        phi_5069_ = _e5597;
                                    } else {
                                        phi_5069_ = _e5601;
                                    }
                                    let _e5604 = phi_5069_;
                                    let _e5607 = local_12.member_2[1u];
                                    if (_e5607[0] < 0f) {
                                        phi_5083_ = -(_e5607[0]);
                                    } else {
                                        phi_5083_ = _e5607[0];
                                    }
                                    let _e5614 = phi_5083_;
                                    if (_e5607[1] < 0f) {
                                        phi_5090_ = -(_e5607[1]);
                                    } else {
                                        phi_5090_ = _e5607[1];
                                    }
                                    let _e5618 = phi_5090_;
                                    if (_e5614 > _e5618) {
                                        phi_5095_ = _e5614;
                                    } else {
                                        phi_5095_ = _e5618;
                                    }
                                    let _e5621 = phi_5095_;
                                    if (_e5607[2] < 0f) {
                                        phi_5102_ = -(_e5607[2]);
                                    } else {
                                        phi_5102_ = _e5607[2];
                                    }
                                    let _e5625 = phi_5102_;
                                    if (_e5621 > _e5625) {
                                        phi_5107_ = _e5621;
                                    } else {
                                        phi_5107_ = _e5625;
                                    }
                                    let _e5628 = phi_5107_;
                                    if (_e5604 > _e5628) {
                                        phi_5112_ = _e5604;
                                    } else {
                                        phi_5112_ = _e5628;
                                    }
                                    let _e5631 = phi_5112_;
                                    let _e5633 = local_12.member_3;
                                    let _e5640 = local_12.member_3;
                                    let _e5647 = (((_e5469 * (1f + (0.000000059604645f * 8f))) + (((((((_e5523 + _e5525) + (_e5577 + _e5579)) + (_e5631 + _e5633)) * (0.000000059604645f * 16f)) + (_e5640 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e452.member_1);
                                    if _e5647 {
                                        phi_5132_ = false;
                                    } else {
                                        phi_5132_ = true;
                                    }
                                    let _e5649 = phi_5132_;
                                    phi_5133_ = _e5649;
                                    phi_5134_ = _e5647;
                                } else {
                                    phi_5133_ = false;
                                    phi_5134_ = false;
                                }
                                let _e5651 = phi_5133_;
                                let _e5653 = phi_5134_;
                                local_29 = _e5653;
                                continue;
                                continuing {
                                    phi_4631_ = _e5324;
                                    break if !(_e5651);
                                }
                            }
                            let _e5656 = local_29;
                            if _e5656 {
                                phi_5139_ = type_28(1u, _e5301.member_1);
                                phi_5140_ = false;
                            } else {
                                phi_5139_ = type_28();
                                phi_5140_ = true;
                            }
                            let _e5659 = phi_5139_;
                            let _e5661 = phi_5140_;
                            if _e5661 {
                                phi_5145_ = type_28(2u, _e5301.member_1);
                                phi_5146_ = false;
                            } else {
                                phi_5145_ = type_28();
                                phi_5146_ = true;
                            }
                            let _e5664 = phi_5145_;
                            let _e5666 = phi_5146_;
                            phi_5148_ = _e5664;
                            phi_5149_ = _e5659;
                            phi_5150_ = _e5666;
                        } else {
                            phi_5148_ = type_28();
                            phi_5149_ = type_28(0u, type_28().member_1);
                            phi_5150_ = true;
                        }
                        let _e5668 = phi_5148_;
                        let _e5670 = phi_5149_;
                        let _e5672 = phi_5150_;
                        if _e5672 {
                            phi_5154_ = _e5670;
                        } else {
                            phi_5154_ = _e5668;
                        }
                        let _e5674 = phi_5154_;
                        phi_9623_ = _e5674;
                    } else {
                        if (_e590 < 0f) {
                            phi_5164_ = -(_e590);
                        } else {
                            phi_5164_ = _e590;
                        }
                        let _e933 = phi_5164_;
                        if (_e613 < 0f) {
                            phi_5170_ = -(_e613);
                        } else {
                            phi_5170_ = _e613;
                        }
                        let _e937 = phi_5170_;
                        if (_e933 > _e937) {
                            phi_5175_ = _e933;
                        } else {
                            phi_5175_ = _e937;
                        }
                        let _e940 = phi_5175_;
                        if (_e636 < 0f) {
                            phi_5181_ = -(_e636);
                        } else {
                            phi_5181_ = _e636;
                        }
                        let _e944 = phi_5181_;
                        if (_e647 < 0f) {
                            phi_5187_ = -(_e647);
                        } else {
                            phi_5187_ = _e647;
                        }
                        let _e948 = phi_5187_;
                        if (_e944 > _e948) {
                            phi_5192_ = _e944;
                        } else {
                            phi_5192_ = _e948;
                        }
                        let _e951 = phi_5192_;
                        if (_e940 > _e951) {
                            phi_5197_ = _e940;
                        } else {
                            phi_5197_ = _e951;
                        }
                        let _e954 = phi_5197_;
                        let _e955 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e954 >= _e955) {
                            phi_5205_ = (_e954 <= (1f / _e955));
                        } else {
                            phi_5205_ = false;
                        }
                        let _e960 = phi_5205_;
                        if _e960 {
                            phi_5210_ = (0.000000059604645f * 256f);
                        } else {
                            phi_5210_ = 2f;
                        }
                        let _e963 = phi_5210_;
                        let _e965 = ((_e897 * 0.34f) + (_e954 * _e963));
                        if _e960 {
                            phi_5217_ = (1f / _e954);
                        } else {
                            phi_5217_ = 0f;
                        }
                        let _e968 = phi_5217_;
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
                                    phi_5250_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_5250_ = 0f;
                                }
                                let _e1037 = phi_5250_;
                                phi_5314_ = _e1037;
                            } else {
                                phi_5257_ = type_14(0i, 5i);
                                phi_5260_ = bitcast<f32>(((bitcast<u32>(_e983) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e992 = phi_5257_;
                                    let _e994 = phi_5260_;
                                    local_13 = _e994;
                                    if (_e992.member < _e992.member_1) {
                                        let _e1001 = (_e992.member + 1i);
                                        if ((false == (_e1001 > _e992.member)) != false) {
                                            phi_5281_ = true;
                                        } else {
                                            phi_5281_ = false;
                                        }
                                        let _e1006 = phi_5281_;
                                        if _e1006 {
                                            phi_5287_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_5287_ = type_15(1u, _e1001);
                                        }
                                        let _e1011 = phi_5287_;
                                        phi_5258_ = type_14(_e1011.member_1, _e992.member_1);
                                        phi_5301_ = type_15(1u, _e992.member);
                                    } else {
                                        phi_5258_ = _e992;
                                        phi_5301_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1017 = phi_5258_;
                                    let _e1019 = phi_5301_;
                                    let _e1022 = (bitcast<i32>(_e1019.member) != 0i);
                                    if _e1022 {
                                        phi_5261_ = (0.5f * (_e994 + (_e983 / _e994)));
                                    } else {
                                        phi_5261_ = f32();
                                    }
                                    let _e1027 = phi_5261_;
                                    continue;
                                    continuing {
                                        phi_5257_ = _e1017;
                                        phi_5260_ = _e1027;
                                        break if !(_e1022);
                                    }
                                }
                                let _e1032 = local_13;
                                phi_5314_ = (_e1032 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1039 = phi_5314_;
                            if (_e975 < 0f) {
                                phi_5320_ = -(_e1039);
                            } else {
                                phi_5320_ = _e1039;
                            }
                            let _e1043 = phi_5320_;
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
                            phi_5345_ = type_12(0u, 2u);
                            phi_5348_ = 1u;
                            loop {
                                let _e1064 = phi_5345_;
                                let _e1066 = phi_5348_;
                                local_30 = _e1066;
                                if (_e1064.member < _e1064.member_1) {
                                    phi_5346_ = type_12((_e1064.member + 1u), _e1064.member_1);
                                    phi_5371_ = type_12(1u, _e1064.member);
                                } else {
                                    phi_5346_ = _e1064;
                                    phi_5371_ = type_12(0u, type_12().member_1);
                                }
                                let _e1078 = phi_5346_;
                                let _e1080 = phi_5371_;
                                let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                if _e1084 {
                                    let _e1086 = local_7[_e1080.member_1];
                                    if (_e1086 > 0f) {
                                        let _e1089 = local_7[_e1080.member_1];
                                        if (_e1089 < 1f) {
                                            let _e1092 = local_7[_e1080.member_1];
                                            local_6[_e1066] = _e1092;
                                            phi_5415_ = (_e1066 + 1u);
                                        } else {
                                            phi_5415_ = _e1066;
                                        }
                                        let _e1096 = phi_5415_;
                                        phi_5416_ = _e1096;
                                    } else {
                                        phi_5416_ = _e1066;
                                    }
                                    let _e1098 = phi_5416_;
                                    phi_5349_ = _e1098;
                                } else {
                                    phi_5349_ = u32();
                                }
                                let _e1100 = phi_5349_;
                                continue;
                                continuing {
                                    phi_5345_ = _e1078;
                                    phi_5348_ = _e1100;
                                    break if !(_e1084);
                                }
                            }
                            let _e5934 = local_30;
                            phi_5417_ = _e5934;
                        } else {
                            phi_5417_ = 1u;
                        }
                        let _e1103 = phi_5417_;
                        local_6[_e1103] = 1f;
                        let _e1105 = local_6;
                        local_8 = _e1105;
                        phi_5437_ = type_12(0u, _e1103);
                        loop {
                            let _e1108 = phi_5437_;
                            if (_e1108.member < _e1108.member_1) {
                                phi_5438_ = type_12((_e1108.member + 1u), _e1108.member_1);
                                phi_5461_ = type_12(1u, _e1108.member);
                            } else {
                                phi_5438_ = _e1108;
                                phi_5461_ = type_12(0u, type_12().member_1);
                            }
                            let _e1120 = phi_5438_;
                            let _e1122 = phi_5461_;
                            if (bitcast<i32>(_e1122.member) != 0i) {
                                let _e1128 = local_8[_e1122.member_1];
                                let _e1131 = local_8[(_e1122.member_1 + 1u)];
                                let _e1132 = (1f - _e1128);
                                let _e1143 = ((((_e590 * _e1132) + (_e613 * _e1128)) * (_e1132 * _e1132)) + (((_e636 * _e1132) + (_e647 * _e1128)) * (_e1128 * _e1128)));
                                let _e1144 = (1f - _e1131);
                                let _e1155 = ((((_e590 * _e1144) + (_e613 * _e1131)) * (_e1144 * _e1144)) + (((_e636 * _e1144) + (_e647 * _e1131)) * (_e1131 * _e1131)));
                                if (_e1143 < 0f) {
                                    phi_5513_ = -(_e1143);
                                } else {
                                    phi_5513_ = _e1143;
                                }
                                let _e1159 = phi_5513_;
                                let _e1160 = (_e1159 > _e965);
                                if (_e1155 < 0f) {
                                    phi_5520_ = -(_e1155);
                                } else {
                                    phi_5520_ = _e1155;
                                }
                                let _e1164 = phi_5520_;
                                let _e1165 = (_e1164 > _e965);
                                if _e1160 {
                                    if _e1165 {
                                        phi_5531_ = ((_e1143 > 0f) != (_e1155 > 0f));
                                        phi_5532_ = false;
                                    } else {
                                        phi_5531_ = bool();
                                        phi_5532_ = true;
                                    }
                                    let _e1170 = phi_5531_;
                                    let _e1172 = phi_5532_;
                                    phi_5533_ = _e1170;
                                    phi_5534_ = _e1172;
                                } else {
                                    phi_5533_ = bool();
                                    phi_5534_ = true;
                                }
                                let _e1174 = phi_5533_;
                                let _e1176 = phi_5534_;
                                if _e1176 {
                                    phi_5538_ = false;
                                } else {
                                    phi_5538_ = _e1174;
                                }
                                let _e1178 = phi_5538_;
                                if _e1160 {
                                    if _e1165 {
                                        if _e1178 {
                                            phi_5549_ = type_37();
                                        } else {
                                            phi_5549_ = type_37(1f, 0f, _e1178);
                                        }
                                        let _e1181 = phi_5549_;
                                        phi_5550_ = _e1181;
                                        phi_5551_ = _e1178;
                                    } else {
                                        phi_5550_ = type_37();
                                        phi_5551_ = true;
                                    }
                                    let _e1183 = phi_5550_;
                                    let _e1185 = phi_5551_;
                                    phi_5552_ = _e1183;
                                    phi_5553_ = _e1185;
                                } else {
                                    phi_5552_ = type_37();
                                    phi_5553_ = true;
                                }
                                let _e1187 = phi_5552_;
                                let _e1189 = phi_5553_;
                                if _e1189 {
                                    if _e1160 {
                                        if (_e1143 < 0f) {
                                            phi_5564_ = -1f;
                                        } else {
                                            phi_5564_ = 1f;
                                        }
                                        let _e1192 = phi_5564_;
                                        let _e1195 = (_e636 - _e613);
                                        phi_5574_ = type_12(0u, 64u);
                                        phi_5577_ = _e1131;
                                        phi_5579_ = _e1128;
                                        phi_5581_ = (0.5f * (_e1128 + _e1131));
                                        loop {
                                            let _e1201 = phi_5574_;
                                            let _e1203 = phi_5577_;
                                            let _e1205 = phi_5579_;
                                            let _e1207 = phi_5581_;
                                            local_32 = _e1205;
                                            if (_e1201.member < _e1201.member_1) {
                                                phi_5575_ = type_12((_e1201.member + 1u), _e1201.member_1);
                                                phi_5604_ = type_12(1u, _e1201.member);
                                            } else {
                                                phi_5575_ = _e1201;
                                                phi_5604_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1219 = phi_5575_;
                                            let _e1221 = phi_5604_;
                                            if (bitcast<i32>(_e1221.member) != 0i) {
                                                let _e1225 = (1f - _e1207);
                                                let _e1238 = ((_e1192 * ((((_e590 * _e1225) + (_e613 * _e1207)) * (_e1225 * _e1225)) + (((_e636 * _e1225) + (_e647 * _e1207)) * (_e1207 * _e1207)))) - _e965);
                                                if (_e1238 > 0f) {
                                                    phi_5629_ = _e1203;
                                                    phi_5630_ = _e1207;
                                                } else {
                                                    phi_5629_ = _e1207;
                                                    phi_5630_ = _e1205;
                                                }
                                                let _e1241 = phi_5629_;
                                                let _e1243 = phi_5630_;
                                                let _e1245 = ((_e1241 - _e1243) > 0.00000000000022737368f);
                                                if _e1245 {
                                                    let _e1246 = (1f - _e1207);
                                                    let _e1258 = (-(_e1238) / (_e1192 * (((((_e613 - (3f * _e590)) * _e1246) + (_e1195 * _e1207)) * _e1246) + (((_e1195 * _e1246) + (((3f * _e647) - _e636) * _e1207)) * _e1207))));
                                                    if (_e1238 > 0f) {
                                                        phi_5656_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_5656_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1264 = phi_5656_;
                                                    let _e1266 = ((_e1207 + _e1258) + _e1264);
                                                    if (_e1266 > _e1243) {
                                                        if (_e1266 < _e1241) {
                                                            if (_e1258 < 0f) {
                                                                phi_5672_ = -(_e1258);
                                                            } else {
                                                                phi_5672_ = _e1258;
                                                            }
                                                            let _e1272 = phi_5672_;
                                                            if (_e1272 < (0.5f * (_e1241 - _e1243))) {
                                                                phi_5679_ = false;
                                                            } else {
                                                                phi_5679_ = true;
                                                            }
                                                            let _e1277 = phi_5679_;
                                                            phi_5680_ = _e1277;
                                                        } else {
                                                            phi_5680_ = true;
                                                        }
                                                        let _e1279 = phi_5680_;
                                                        phi_5681_ = _e1279;
                                                    } else {
                                                        phi_5681_ = true;
                                                    }
                                                    let _e1281 = phi_5681_;
                                                    if _e1281 {
                                                        phi_5687_ = (0.5f * (_e1243 + _e1241));
                                                    } else {
                                                        phi_5687_ = _e1266;
                                                    }
                                                    let _e1285 = phi_5687_;
                                                    phi_5688_ = _e1285;
                                                    phi_5689_ = false;
                                                } else {
                                                    phi_5688_ = f32();
                                                    phi_5689_ = true;
                                                }
                                                let _e1287 = phi_5688_;
                                                let _e1289 = phi_5689_;
                                                phi_5578_ = _e1241;
                                                phi_5580_ = _e1243;
                                                phi_5582_ = _e1287;
                                                phi_5690_ = _e1243;
                                                phi_5691_ = _e1245;
                                                phi_5692_ = _e1289;
                                            } else {
                                                phi_5578_ = f32();
                                                phi_5580_ = f32();
                                                phi_5582_ = f32();
                                                phi_5690_ = f32();
                                                phi_5691_ = false;
                                                phi_5692_ = false;
                                            }
                                            let _e1291 = phi_5578_;
                                            let _e1293 = phi_5580_;
                                            let _e1295 = phi_5582_;
                                            let _e1297 = phi_5690_;
                                            let _e1299 = phi_5691_;
                                            let _e1301 = phi_5692_;
                                            local_14 = _e1301;
                                            local_31 = _e1297;
                                            continue;
                                            continuing {
                                                phi_5574_ = _e1219;
                                                phi_5577_ = _e1291;
                                                phi_5579_ = _e1293;
                                                phi_5581_ = _e1295;
                                                break if !(_e1299);
                                            }
                                        }
                                        let _e1304 = local_14;
                                        if _e1304 {
                                            let _e5976 = local_31;
                                            phi_5696_ = _e5976;
                                        } else {
                                            let _e5978 = local_32;
                                            phi_5696_ = _e5978;
                                        }
                                        let _e1306 = phi_5696_;
                                        phi_5697_ = _e1306;
                                    } else {
                                        phi_5697_ = _e1128;
                                    }
                                    let _e1308 = phi_5697_;
                                    if _e1165 {
                                        if (_e1155 < 0f) {
                                            phi_5705_ = -1f;
                                        } else {
                                            phi_5705_ = 1f;
                                        }
                                        let _e1311 = phi_5705_;
                                        phi_5709_ = type_12(0u, 64u);
                                        phi_5712_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1314 = phi_5709_;
                                            let _e1316 = phi_5712_;
                                            if (_e1314.member < _e1314.member_1) {
                                                phi_5710_ = type_12((_e1314.member + 1u), _e1314.member_1);
                                                phi_5735_ = type_12(1u, _e1314.member);
                                            } else {
                                                phi_5710_ = _e1314;
                                                phi_5735_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1328 = phi_5710_;
                                            let _e1330 = phi_5735_;
                                            if (bitcast<i32>(_e1330.member) != 0i) {
                                                let _e1334 = (_e1308 + _e1316);
                                                if (_e1334 < _e1131) {
                                                    let _e1336 = (1f - _e1334);
                                                    let _e1349 = ((_e1311 * ((((_e590 * _e1336) + (_e613 * _e1334)) * (_e1336 * _e1336)) + (((_e636 * _e1336) + (_e647 * _e1334)) * (_e1334 * _e1334)))) > _e965);
                                                    if _e1349 {
                                                        phi_5765_ = f32();
                                                        phi_5766_ = false;
                                                    } else {
                                                        phi_5765_ = (_e1316 + _e1316);
                                                        phi_5766_ = true;
                                                    }
                                                    let _e1352 = phi_5765_;
                                                    let _e1354 = phi_5766_;
                                                    phi_5767_ = _e1352;
                                                    phi_5768_ = _e1354;
                                                    phi_5769_ = _e1349;
                                                    phi_5770_ = false;
                                                } else {
                                                    phi_5767_ = f32();
                                                    phi_5768_ = false;
                                                    phi_5769_ = false;
                                                    phi_5770_ = true;
                                                }
                                                let _e1356 = phi_5767_;
                                                let _e1358 = phi_5768_;
                                                let _e1360 = phi_5769_;
                                                let _e1362 = phi_5770_;
                                                phi_5771_ = _e1334;
                                                phi_5713_ = _e1356;
                                                phi_5772_ = _e1358;
                                                phi_5773_ = _e1360;
                                                phi_5774_ = _e1362;
                                                phi_5775_ = false;
                                            } else {
                                                phi_5771_ = f32();
                                                phi_5713_ = f32();
                                                phi_5772_ = false;
                                                phi_5773_ = false;
                                                phi_5774_ = false;
                                                phi_5775_ = true;
                                            }
                                            let _e1364 = phi_5771_;
                                            let _e1366 = phi_5713_;
                                            let _e1368 = phi_5772_;
                                            let _e1370 = phi_5773_;
                                            let _e1372 = phi_5774_;
                                            let _e1374 = phi_5775_;
                                            local_15 = _e1370;
                                            local_33 = _e1372;
                                            local_34 = _e1374;
                                            local_35 = _e1364;
                                            continue;
                                            continuing {
                                                phi_5709_ = _e1328;
                                                phi_5712_ = _e1366;
                                                break if !(_e1368);
                                            }
                                        }
                                        let _e1377 = local_15;
                                        if _e1377 {
                                            phi_5779_ = false;
                                            phi_5780_ = false;
                                        } else {
                                            let _e6000 = local_33;
                                            phi_5779_ = _e6000;
                                            let _e6003 = local_34;
                                            phi_5780_ = _e6003;
                                        }
                                        let _e1379 = phi_5779_;
                                        let _e1381 = phi_5780_;
                                        if _e1379 {
                                            phi_5784_ = true;
                                        } else {
                                            phi_5784_ = _e1381;
                                        }
                                        let _e1383 = phi_5784_;
                                        if _e1383 {
                                            phi_5788_ = _e1131;
                                        } else {
                                            let _e6007 = local_35;
                                            phi_5788_ = _e6007;
                                        }
                                        let _e1385 = phi_5788_;
                                        phi_5789_ = _e1385;
                                    } else {
                                        phi_5789_ = _e1131;
                                    }
                                    let _e1387 = phi_5789_;
                                    phi_5791_ = type_37(_e1308, _e1387, _e1178);
                                } else {
                                    phi_5791_ = _e1187;
                                }
                                let _e1390 = phi_5791_;
                                if (_e1390.member > _e1390.member_1) {
                                    phi_9579_ = f32();
                                    phi_9580_ = true;
                                    phi_9581_ = false;
                                    phi_9582_ = false;
                                    phi_9583_ = false;
                                } else {
                                    let _e1397 = ((_e1390.member_1 - _e1390.member) * 0.5f);
                                    let _e1398 = (_e1390.member + _e1397);
                                    let _e1400 = (_e1397 + (0.000000059604645f * 4f));
                                    let _e1402 = local_12.member_3;
                                    let _e1405 = local_12.member[0u];
                                    if (_e1405[0] < 0f) {
                                        phi_5820_ = -(_e1405[0]);
                                    } else {
                                        phi_5820_ = _e1405[0];
                                    }
                                    let _e1412 = phi_5820_;
                                    if (_e1405[1] < 0f) {
                                        phi_5827_ = -(_e1405[1]);
                                    } else {
                                        phi_5827_ = _e1405[1];
                                    }
                                    let _e1416 = phi_5827_;
                                    if (_e1412 > _e1416) {
                                        phi_5832_ = _e1412;
                                    } else {
                                        phi_5832_ = _e1416;
                                    }
                                    let _e1419 = phi_5832_;
                                    if (_e1405[2] < 0f) {
                                        phi_5839_ = -(_e1405[2]);
                                    } else {
                                        phi_5839_ = _e1405[2];
                                    }
                                    let _e1423 = phi_5839_;
                                    if (_e1419 > _e1423) {
                                        phi_5844_ = _e1419;
                                    } else {
                                        phi_5844_ = _e1423;
                                    }
                                    let _e1426 = phi_5844_;
                                    let _e1428 = local_12.member[1u];
                                    if (_e1428[0] < 0f) {
                                        phi_5857_ = -(_e1428[0]);
                                    } else {
                                        phi_5857_ = _e1428[0];
                                    }
                                    let _e1435 = phi_5857_;
                                    if (_e1428[1] < 0f) {
                                        phi_5864_ = -(_e1428[1]);
                                    } else {
                                        phi_5864_ = _e1428[1];
                                    }
                                    let _e1439 = phi_5864_;
                                    if (_e1435 > _e1439) {
                                        phi_5869_ = _e1435;
                                    } else {
                                        phi_5869_ = _e1439;
                                    }
                                    let _e1442 = phi_5869_;
                                    if (_e1428[2] < 0f) {
                                        phi_5876_ = -(_e1428[2]);
                                    } else {
                                        phi_5876_ = _e1428[2];
                                    }
                                    let _e1446 = phi_5876_;
                                    if (_e1442 > _e1446) {
                                        phi_5881_ = _e1442;
                                    } else {
                                        phi_5881_ = _e1446;
                                    }
                                    let _e1449 = phi_5881_;
                                    if (_e1426 > _e1449) {
                                        phi_5886_ = _e1426;
                                    } else {
                                        phi_5886_ = _e1449;
                                    }
                                    let _e1452 = phi_5886_;
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
                                        phi_5945_ = -(_e1483);
                                    } else {
                                        phi_5945_ = _e1483;
                                    }
                                    let _e1489 = phi_5945_;
                                    if (_e1484 < 0f) {
                                        phi_5951_ = -(_e1484);
                                    } else {
                                        phi_5951_ = _e1484;
                                    }
                                    let _e1493 = phi_5951_;
                                    if (_e1489 > _e1493) {
                                        phi_5956_ = _e1489;
                                    } else {
                                        phi_5956_ = _e1493;
                                    }
                                    let _e1496 = phi_5956_;
                                    if (_e1485 < 0f) {
                                        phi_5962_ = -(_e1485);
                                    } else {
                                        phi_5962_ = _e1485;
                                    }
                                    let _e1500 = phi_5962_;
                                    if (_e1496 > _e1500) {
                                        phi_5967_ = _e1496;
                                    } else {
                                        phi_5967_ = _e1500;
                                    }
                                    let _e1503 = phi_5967_;
                                    let _e1509 = ((((_e1400 * _e1503) * 1.01f) + ((_e1452 + _e1402) * (0.000000059604645f * 8f))) + _e1402);
                                    if (_e1470 < 0f) {
                                        phi_5979_ = -(_e1470);
                                    } else {
                                        phi_5979_ = _e1470;
                                    }
                                    let _e1513 = phi_5979_;
                                    if (_e1471 < 0f) {
                                        phi_5985_ = -(_e1471);
                                    } else {
                                        phi_5985_ = _e1471;
                                    }
                                    let _e1517 = phi_5985_;
                                    if (_e1513 > _e1517) {
                                        phi_5990_ = _e1513;
                                    } else {
                                        phi_5990_ = _e1517;
                                    }
                                    let _e1520 = phi_5990_;
                                    if (_e1472 < 0f) {
                                        phi_5996_ = -(_e1472);
                                    } else {
                                        phi_5996_ = _e1472;
                                    }
                                    let _e1524 = phi_5996_;
                                    if (_e1520 > _e1524) {
                                        phi_6001_ = _e1520;
                                    } else {
                                        phi_6001_ = _e1524;
                                    }
                                    let _e1527 = phi_6001_;
                                    local_2 = type_24(array<f32, 3>(_e1470, _e1471, _e1472), _e1509, (_e1527 + _e1509));
                                    let _e1533 = local_12.member_3;
                                    let _e1535 = local_12.member_1[0u];
                                    if (_e1535[0] < 0f) {
                                        phi_6027_ = -(_e1535[0]);
                                    } else {
                                        phi_6027_ = _e1535[0];
                                    }
                                    let _e1542 = phi_6027_;
                                    if (_e1535[1] < 0f) {
                                        phi_6034_ = -(_e1535[1]);
                                    } else {
                                        phi_6034_ = _e1535[1];
                                    }
                                    let _e1546 = phi_6034_;
                                    if (_e1542 > _e1546) {
                                        phi_6039_ = _e1542;
                                    } else {
                                        phi_6039_ = _e1546;
                                    }
                                    let _e1549 = phi_6039_;
                                    if (_e1535[2] < 0f) {
                                        phi_6046_ = -(_e1535[2]);
                                    } else {
                                        phi_6046_ = _e1535[2];
                                    }
                                    let _e1553 = phi_6046_;
                                    if (_e1549 > _e1553) {
                                        phi_6051_ = _e1549;
                                    } else {
                                        phi_6051_ = _e1553;
                                    }
                                    let _e1556 = phi_6051_;
                                    let _e1558 = local_12.member_1[1u];
                                    if (_e1558[0] < 0f) {
                                        phi_6064_ = -(_e1558[0]);
                                    } else {
                                        phi_6064_ = _e1558[0];
                                    }
                                    let _e1565 = phi_6064_;
                                    if (_e1558[1] < 0f) {
                                        phi_6071_ = -(_e1558[1]);
                                    } else {
                                        phi_6071_ = _e1558[1];
                                    }
                                    let _e1569 = phi_6071_;
                                    if (_e1565 > _e1569) {
                                        phi_6076_ = _e1565;
                                    } else {
                                        phi_6076_ = _e1569;
                                    }
                                    let _e1572 = phi_6076_;
                                    if (_e1558[2] < 0f) {
                                        phi_6083_ = -(_e1558[2]);
                                    } else {
                                        phi_6083_ = _e1558[2];
                                    }
                                    let _e1576 = phi_6083_;
                                    if (_e1572 > _e1576) {
                                        phi_6088_ = _e1572;
                                    } else {
                                        phi_6088_ = _e1576;
                                    }
                                    let _e1579 = phi_6088_;
                                    if (_e1556 > _e1579) {
                                        phi_6093_ = _e1556;
                                    } else {
                                        phi_6093_ = _e1579;
                                    }
                                    let _e1582 = phi_6093_;
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
                                        phi_6152_ = -(_e1613);
                                    } else {
                                        phi_6152_ = _e1613;
                                    }
                                    let _e1619 = phi_6152_;
                                    if (_e1614 < 0f) {
                                        phi_6158_ = -(_e1614);
                                    } else {
                                        phi_6158_ = _e1614;
                                    }
                                    let _e1623 = phi_6158_;
                                    if (_e1619 > _e1623) {
                                        phi_6163_ = _e1619;
                                    } else {
                                        phi_6163_ = _e1623;
                                    }
                                    let _e1626 = phi_6163_;
                                    if (_e1615 < 0f) {
                                        phi_6169_ = -(_e1615);
                                    } else {
                                        phi_6169_ = _e1615;
                                    }
                                    let _e1630 = phi_6169_;
                                    if (_e1626 > _e1630) {
                                        phi_6174_ = _e1626;
                                    } else {
                                        phi_6174_ = _e1630;
                                    }
                                    let _e1633 = phi_6174_;
                                    let _e1639 = ((((_e1400 * _e1633) * 1.01f) + ((_e1582 + _e1533) * (0.000000059604645f * 8f))) + _e1533);
                                    if (_e1600 < 0f) {
                                        phi_6186_ = -(_e1600);
                                    } else {
                                        phi_6186_ = _e1600;
                                    }
                                    let _e1643 = phi_6186_;
                                    if (_e1601 < 0f) {
                                        phi_6192_ = -(_e1601);
                                    } else {
                                        phi_6192_ = _e1601;
                                    }
                                    let _e1647 = phi_6192_;
                                    if (_e1643 > _e1647) {
                                        phi_6197_ = _e1643;
                                    } else {
                                        phi_6197_ = _e1647;
                                    }
                                    let _e1650 = phi_6197_;
                                    if (_e1602 < 0f) {
                                        phi_6203_ = -(_e1602);
                                    } else {
                                        phi_6203_ = _e1602;
                                    }
                                    let _e1654 = phi_6203_;
                                    if (_e1650 > _e1654) {
                                        phi_6208_ = _e1650;
                                    } else {
                                        phi_6208_ = _e1654;
                                    }
                                    let _e1657 = phi_6208_;
                                    local_3 = type_24(array<f32, 3>(_e1600, _e1601, _e1602), _e1639, (_e1657 + _e1639));
                                    let _e1663 = local_12.member_3;
                                    let _e1665 = local_12.member_2[0u];
                                    if (_e1665[0] < 0f) {
                                        phi_6234_ = -(_e1665[0]);
                                    } else {
                                        phi_6234_ = _e1665[0];
                                    }
                                    let _e1672 = phi_6234_;
                                    if (_e1665[1] < 0f) {
                                        phi_6241_ = -(_e1665[1]);
                                    } else {
                                        phi_6241_ = _e1665[1];
                                    }
                                    let _e1676 = phi_6241_;
                                    if (_e1672 > _e1676) {
                                        phi_6246_ = _e1672;
                                    } else {
                                        phi_6246_ = _e1676;
                                    }
                                    let _e1679 = phi_6246_;
                                    if (_e1665[2] < 0f) {
                                        phi_6253_ = -(_e1665[2]);
                                    } else {
                                        phi_6253_ = _e1665[2];
                                    }
                                    let _e1683 = phi_6253_;
                                    if (_e1679 > _e1683) {
                                        phi_6258_ = _e1679;
                                    } else {
                                        phi_6258_ = _e1683;
                                    }
                                    let _e1686 = phi_6258_;
                                    let _e1688 = local_12.member_2[1u];
                                    if (_e1688[0] < 0f) {
                                        phi_6271_ = -(_e1688[0]);
                                    } else {
                                        phi_6271_ = _e1688[0];
                                    }
                                    let _e1695 = phi_6271_;
                                    if (_e1688[1] < 0f) {
                                        phi_6278_ = -(_e1688[1]);
                                    } else {
                                        phi_6278_ = _e1688[1];
                                    }
                                    let _e1699 = phi_6278_;
                                    if (_e1695 > _e1699) {
                                        phi_6283_ = _e1695;
                                    } else {
                                        phi_6283_ = _e1699;
                                    }
                                    let _e1702 = phi_6283_;
                                    if (_e1688[2] < 0f) {
                                        phi_6290_ = -(_e1688[2]);
                                    } else {
                                        phi_6290_ = _e1688[2];
                                    }
                                    let _e1706 = phi_6290_;
                                    if (_e1702 > _e1706) {
                                        phi_6295_ = _e1702;
                                    } else {
                                        phi_6295_ = _e1706;
                                    }
                                    let _e1709 = phi_6295_;
                                    if (_e1686 > _e1709) {
                                        phi_6300_ = _e1686;
                                    } else {
                                        phi_6300_ = _e1709;
                                    }
                                    let _e1712 = phi_6300_;
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
                                        phi_6359_ = -(_e1743);
                                    } else {
                                        phi_6359_ = _e1743;
                                    }
                                    let _e1749 = phi_6359_;
                                    if (_e1744 < 0f) {
                                        phi_6365_ = -(_e1744);
                                    } else {
                                        phi_6365_ = _e1744;
                                    }
                                    let _e1753 = phi_6365_;
                                    if (_e1749 > _e1753) {
                                        phi_6370_ = _e1749;
                                    } else {
                                        phi_6370_ = _e1753;
                                    }
                                    let _e1756 = phi_6370_;
                                    if (_e1745 < 0f) {
                                        phi_6376_ = -(_e1745);
                                    } else {
                                        phi_6376_ = _e1745;
                                    }
                                    let _e1760 = phi_6376_;
                                    if (_e1756 > _e1760) {
                                        phi_6381_ = _e1756;
                                    } else {
                                        phi_6381_ = _e1760;
                                    }
                                    let _e1763 = phi_6381_;
                                    let _e1769 = ((((_e1400 * _e1763) * 1.01f) + ((_e1712 + _e1663) * (0.000000059604645f * 8f))) + _e1663);
                                    if (_e1730 < 0f) {
                                        phi_6393_ = -(_e1730);
                                    } else {
                                        phi_6393_ = _e1730;
                                    }
                                    let _e1773 = phi_6393_;
                                    if (_e1731 < 0f) {
                                        phi_6399_ = -(_e1731);
                                    } else {
                                        phi_6399_ = _e1731;
                                    }
                                    let _e1777 = phi_6399_;
                                    if (_e1773 > _e1777) {
                                        phi_6404_ = _e1773;
                                    } else {
                                        phi_6404_ = _e1777;
                                    }
                                    let _e1780 = phi_6404_;
                                    if (_e1732 < 0f) {
                                        phi_6410_ = -(_e1732);
                                    } else {
                                        phi_6410_ = _e1732;
                                    }
                                    let _e1784 = phi_6410_;
                                    if (_e1780 > _e1784) {
                                        phi_6415_ = _e1780;
                                    } else {
                                        phi_6415_ = _e1784;
                                    }
                                    let _e1787 = phi_6415_;
                                    local_4 = type_24(array<f32, 3>(_e1730, _e1731, _e1732), _e1769, (_e1787 + _e1769));
                                    let _e1792 = local_3.member;
                                    let _e1797 = local_4.member;
                                    let _e1803 = ((_e1792[1] * _e1797[2]) - (_e1792[2] * _e1797[1]));
                                    let _e1806 = ((_e1792[2] * _e1797[0]) - (_e1792[0] * _e1797[2]));
                                    let _e1809 = ((_e1792[0] * _e1797[1]) - (_e1792[1] * _e1797[0]));
                                    if (_e1803 < 0f) {
                                        phi_6464_ = -(_e1803);
                                    } else {
                                        phi_6464_ = _e1803;
                                    }
                                    let _e1813 = phi_6464_;
                                    if (_e1806 < 0f) {
                                        phi_6470_ = -(_e1806);
                                    } else {
                                        phi_6470_ = _e1806;
                                    }
                                    let _e1817 = phi_6470_;
                                    if (_e1813 > _e1817) {
                                        if (_e1803 < 0f) {
                                            phi_6480_ = -(_e1803);
                                        } else {
                                            phi_6480_ = _e1803;
                                        }
                                        let _e1835 = phi_6480_;
                                        if (_e1809 < 0f) {
                                            phi_6486_ = -(_e1809);
                                        } else {
                                            phi_6486_ = _e1809;
                                        }
                                        let _e1839 = phi_6486_;
                                        if (_e1835 > _e1839) {
                                            phi_6491_ = 2u;
                                            phi_6492_ = 1u;
                                        } else {
                                            phi_6491_ = 1u;
                                            phi_6492_ = 0u;
                                        }
                                        let _e1842 = phi_6491_;
                                        let _e1844 = phi_6492_;
                                        phi_6511_ = _e1842;
                                        phi_6512_ = _e1844;
                                    } else {
                                        if (_e1806 < 0f) {
                                            phi_6498_ = -(_e1806);
                                        } else {
                                            phi_6498_ = _e1806;
                                        }
                                        let _e1822 = phi_6498_;
                                        if (_e1809 < 0f) {
                                            phi_6504_ = -(_e1809);
                                        } else {
                                            phi_6504_ = _e1809;
                                        }
                                        let _e1826 = phi_6504_;
                                        if (_e1822 > _e1826) {
                                            phi_6509_ = 0u;
                                            phi_6510_ = 2u;
                                        } else {
                                            phi_6509_ = 1u;
                                            phi_6510_ = 0u;
                                        }
                                        let _e1829 = phi_6509_;
                                        let _e1831 = phi_6510_;
                                        phi_6511_ = _e1829;
                                        phi_6512_ = _e1831;
                                    }
                                    let _e1846 = phi_6511_;
                                    let _e1848 = phi_6512_;
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
                                        phi_6581_ = -(_e1863);
                                    } else {
                                        phi_6581_ = _e1863;
                                    }
                                    let _e1899 = phi_6581_;
                                    if (_e1899 > _e1895) {
                                        if (_e1863 < 0f) {
                                            phi_6590_ = -1f;
                                        } else {
                                            phi_6590_ = 1f;
                                        }
                                        let _e1903 = phi_6590_;
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
                                            phi_6725_ = -(_e1998);
                                        } else {
                                            phi_6725_ = _e1998;
                                        }
                                        let _e2004 = phi_6725_;
                                        if (_e1999 < 0f) {
                                            phi_6731_ = -(_e1999);
                                        } else {
                                            phi_6731_ = _e1999;
                                        }
                                        let _e2008 = phi_6731_;
                                        if (_e2000 < 0f) {
                                            phi_6738_ = -(_e2000);
                                        } else {
                                            phi_6738_ = _e2000;
                                        }
                                        let _e2013 = phi_6738_;
                                        let _e2018 = ((_e1998 - _e1999) - _e2000);
                                        let _e2021 = (((_e1895 + _e1950) + _e1997) + (((_e2004 + _e2008) + _e2013) * (0.000000059604645f * 4f)));
                                        local_5 = array<type_32, 4>(type_32(_e1999, _e1950), type_32(_e2000, _e1997), type_32(_e2018, _e2021), type_32(_e2018, _e2021));
                                        phi_6793_ = type_12(0u, 4u);
                                        phi_6796_ = true;
                                        loop {
                                            let _e2028 = phi_6793_;
                                            let _e2030 = phi_6796_;
                                            local_17 = _e2030;
                                            if (_e2028.member < _e2028.member_1) {
                                                phi_6794_ = type_12((_e2028.member + 1u), _e2028.member_1);
                                                phi_6819_ = type_12(1u, _e2028.member);
                                            } else {
                                                phi_6794_ = _e2028;
                                                phi_6819_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e2042 = phi_6794_;
                                            let _e2044 = phi_6819_;
                                            if (bitcast<i32>(_e2044.member) != 0i) {
                                                let _e2051 = local_5[_e2044.member_1].member;
                                                let _e2054 = local_5[_e2044.member_1].member_1;
                                                let _e2056 = (_e2051 < -(_e2054));
                                                if _e2056 {
                                                    phi_6846_ = bool();
                                                    phi_6847_ = false;
                                                } else {
                                                    phi_6846_ = (_e2030 && (_e2051 > _e2054));
                                                    phi_6847_ = true;
                                                }
                                                let _e2060 = phi_6846_;
                                                let _e2062 = phi_6847_;
                                                phi_6797_ = _e2060;
                                                phi_6848_ = _e2062;
                                                phi_6849_ = _e2056;
                                            } else {
                                                phi_6797_ = bool();
                                                phi_6848_ = false;
                                                phi_6849_ = false;
                                            }
                                            let _e2064 = phi_6797_;
                                            let _e2066 = phi_6848_;
                                            let _e2068 = phi_6849_;
                                            local_16 = _e2068;
                                            continue;
                                            continuing {
                                                phi_6793_ = _e2042;
                                                phi_6796_ = _e2064;
                                                break if !(_e2066);
                                            }
                                        }
                                        let _e2071 = local_16;
                                        if _e2071 {
                                            phi_6853_ = false;
                                        } else {
                                            phi_6853_ = true;
                                        }
                                        let _e2073 = phi_6853_;
                                        if _e2073 {
                                            let _e2075 = local_17;
                                            if _e2075 {
                                                phi_6860_ = 1u;
                                            } else {
                                                phi_6860_ = 2u;
                                            }
                                            let _e2077 = phi_6860_;
                                            phi_6861_ = _e2077;
                                            phi_6862_ = false;
                                        } else {
                                            phi_6861_ = u32();
                                            phi_6862_ = true;
                                        }
                                        let _e2079 = phi_6861_;
                                        let _e2081 = phi_6862_;
                                        phi_6863_ = _e2079;
                                        phi_6864_ = 0u;
                                        phi_6865_ = _e2081;
                                    } else {
                                        phi_6863_ = u32();
                                        phi_6864_ = 2u;
                                        phi_6865_ = true;
                                    }
                                    let _e2083 = phi_6863_;
                                    let _e2085 = phi_6864_;
                                    let _e2087 = phi_6865_;
                                    if _e2087 {
                                        phi_6869_ = _e2085;
                                    } else {
                                        phi_6869_ = _e2083;
                                    }
                                    let _e2089 = phi_6869_;
                                    let _e2090 = (_e2089 == 0u);
                                    if _e2090 {
                                        phi_9575_ = f32();
                                        phi_9576_ = false;
                                        phi_9577_ = false;
                                        phi_9578_ = false;
                                    } else {
                                        if (_e2089 == 1u) {
                                            if _e1390.member_2 {
                                                if ((_e1390.member_1 - _e1390.member) <= 0.0000005f) {
                                                    phi_6889_ = false;
                                                } else {
                                                    phi_6889_ = true;
                                                }
                                                let _e2098 = phi_6889_;
                                                phi_6890_ = _e2098;
                                            } else {
                                                phi_6890_ = true;
                                            }
                                            let _e2100 = phi_6890_;
                                            phi_6891_ = _e2100;
                                        } else {
                                            phi_6891_ = true;
                                        }
                                        let _e2102 = phi_6891_;
                                        if _e2102 {
                                            let _e2107 = local_12.member[0u];
                                            let _e2113 = local_12.member_1[0u];
                                            let _e2119 = local_12.member_2[0u];
                                            let _e2131 = local_12.member[1u];
                                            let _e2137 = local_12.member_1[1u];
                                            let _e2143 = local_12.member_2[1u];
                                            let _e2155 = local_12.member[0u];
                                            if (_e2155[0] < 0f) {
                                                phi_7039_ = -(_e2155[0]);
                                            } else {
                                                phi_7039_ = _e2155[0];
                                            }
                                            let _e2162 = phi_7039_;
                                            if (_e2155[1] < 0f) {
                                                phi_7046_ = -(_e2155[1]);
                                            } else {
                                                phi_7046_ = _e2155[1];
                                            }
                                            let _e2166 = phi_7046_;
                                            if (_e2162 > _e2166) {
                                                phi_7051_ = _e2162;
                                            } else {
                                                phi_7051_ = _e2166;
                                            }
                                            let _e2169 = phi_7051_;
                                            if (_e2155[2] < 0f) {
                                                phi_7058_ = -(_e2155[2]);
                                            } else {
                                                phi_7058_ = _e2155[2];
                                            }
                                            let _e2173 = phi_7058_;
                                            if (_e2169 > _e2173) {
                                                phi_7063_ = _e2169;
                                            } else {
                                                phi_7063_ = _e2173;
                                            }
                                            let _e2176 = phi_7063_;
                                            let _e2179 = local_12.member[1u];
                                            if (_e2179[0] < 0f) {
                                                phi_7076_ = -(_e2179[0]);
                                            } else {
                                                phi_7076_ = _e2179[0];
                                            }
                                            let _e2186 = phi_7076_;
                                            if (_e2179[1] < 0f) {
                                                phi_7083_ = -(_e2179[1]);
                                            } else {
                                                phi_7083_ = _e2179[1];
                                            }
                                            let _e2190 = phi_7083_;
                                            if (_e2186 > _e2190) {
                                                phi_7088_ = _e2186;
                                            } else {
                                                phi_7088_ = _e2190;
                                            }
                                            let _e2193 = phi_7088_;
                                            if (_e2179[2] < 0f) {
                                                phi_7095_ = -(_e2179[2]);
                                            } else {
                                                phi_7095_ = _e2179[2];
                                            }
                                            let _e2197 = phi_7095_;
                                            if (_e2193 > _e2197) {
                                                phi_7100_ = _e2193;
                                            } else {
                                                phi_7100_ = _e2197;
                                            }
                                            let _e2200 = phi_7100_;
                                            if (_e2176 > _e2200) {
                                                phi_7105_ = _e2176;
                                            } else {
                                                phi_7105_ = _e2200;
                                            }
                                            let _e2203 = phi_7105_;
                                            let _e2205 = local_12.member_3;
                                            let _e2209 = local_12.member_1[0u];
                                            if (_e2209[0] < 0f) {
                                                phi_7122_ = -(_e2209[0]);
                                            } else {
                                                phi_7122_ = _e2209[0];
                                            }
                                            let _e2216 = phi_7122_;
                                            if (_e2209[1] < 0f) {
                                                phi_7129_ = -(_e2209[1]);
                                            } else {
                                                phi_7129_ = _e2209[1];
                                            }
                                            let _e2220 = phi_7129_;
                                            if (_e2216 > _e2220) {
                                                phi_7134_ = _e2216;
                                            } else {
                                                phi_7134_ = _e2220;
                                            }
                                            let _e2223 = phi_7134_;
                                            if (_e2209[2] < 0f) {
                                                phi_7141_ = -(_e2209[2]);
                                            } else {
                                                phi_7141_ = _e2209[2];
                                            }
                                            let _e2227 = phi_7141_;
                                            if (_e2223 > _e2227) {
                                                phi_7146_ = _e2223;
                                            } else {
                                                phi_7146_ = _e2227;
                                            }
                                            let _e2230 = phi_7146_;
                                            let _e2233 = local_12.member_1[1u];
                                            if (_e2233[0] < 0f) {
                                                phi_7160_ = -(_e2233[0]);
                                            } else {
                                                phi_7160_ = _e2233[0];
                                            }
                                            let _e2240 = phi_7160_;
                                            if (_e2233[1] < 0f) {
                                                phi_7167_ = -(_e2233[1]);
                                            } else {
                                                phi_7167_ = _e2233[1];
                                            }
                                            let _e2244 = phi_7167_;
                                            if (_e2240 > _e2244) {
                                                phi_7172_ = _e2240;
                                            } else {
                                                phi_7172_ = _e2244;
                                            }
                                            let _e2247 = phi_7172_;
                                            if (_e2233[2] < 0f) {
                                                phi_7179_ = -(_e2233[2]);
                                            } else {
                                                phi_7179_ = _e2233[2];
                                            }
                                            let _e2251 = phi_7179_;
                                            if (_e2247 > _e2251) {
                                                phi_7184_ = _e2247;
                                            } else {
                                                phi_7184_ = _e2251;
                                            }
                                            let _e2254 = phi_7184_;
                                            if (_e2230 > _e2254) {
                                                phi_7189_ = _e2230;
                                            } else {
                                                phi_7189_ = _e2254;
                                            }
                                            let _e2257 = phi_7189_;
                                            let _e2259 = local_12.member_3;
                                            let _e2263 = local_12.member_2[0u];
                                            if (_e2263[0] < 0f) {
                                                phi_7206_ = -(_e2263[0]);
                                            } else {
                                                phi_7206_ = _e2263[0];
                                            }
                                            let _e2270 = phi_7206_;
                                            if (_e2263[1] < 0f) {
                                                phi_7213_ = -(_e2263[1]);
                                            } else {
                                                phi_7213_ = _e2263[1];
                                            }
                                            let _e2274 = phi_7213_;
                                            if (_e2270 > _e2274) {
                                                phi_7218_ = _e2270;
                                            } else {
                                                phi_7218_ = _e2274;
                                            }
                                            let _e2277 = phi_7218_;
                                            if (_e2263[2] < 0f) {
                                                phi_7225_ = -(_e2263[2]);
                                            } else {
                                                phi_7225_ = _e2263[2];
                                            }
                                            let _e2281 = phi_7225_;
                                            if (_e2277 > _e2281) {
                                                phi_7230_ = _e2277;
                                            } else {
                                                phi_7230_ = _e2281;
                                            }
                                            let _e2284 = phi_7230_;
                                            let _e2287 = local_12.member_2[1u];
                                            if (_e2287[0] < 0f) {
                                                phi_7244_ = -(_e2287[0]);
                                            } else {
                                                phi_7244_ = _e2287[0];
                                            }
                                            let _e2294 = phi_7244_;
                                            if (_e2287[1] < 0f) {
                                                phi_7251_ = -(_e2287[1]);
                                            } else {
                                                phi_7251_ = _e2287[1];
                                            }
                                            let _e2298 = phi_7251_;
                                            if (_e2294 > _e2298) {
                                                phi_7256_ = _e2294;
                                            } else {
                                                phi_7256_ = _e2298;
                                            }
                                            let _e2301 = phi_7256_;
                                            if (_e2287[2] < 0f) {
                                                phi_7263_ = -(_e2287[2]);
                                            } else {
                                                phi_7263_ = _e2287[2];
                                            }
                                            let _e2305 = phi_7263_;
                                            if (_e2301 > _e2305) {
                                                phi_7268_ = _e2301;
                                            } else {
                                                phi_7268_ = _e2305;
                                            }
                                            let _e2308 = phi_7268_;
                                            if (_e2284 > _e2308) {
                                                phi_7273_ = _e2284;
                                            } else {
                                                phi_7273_ = _e2308;
                                            }
                                            let _e2311 = phi_7273_;
                                            let _e2313 = local_12.member_3;
                                            let _e2320 = local_12.member_3;
                                            local = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_7313_ = type_12(0u, 96u);
                                            phi_7316_ = _e1390.member;
                                            phi_7318_ = _e1390.member;
                                            phi_7320_ = (_e1390.member_1 - _e1390.member);
                                            phi_7322_ = _e1390.member;
                                            phi_7324_ = false;
                                            phi_7326_ = 0u;
                                            loop {
                                                let _e2327 = phi_7313_;
                                                let _e2329 = phi_7316_;
                                                let _e2331 = phi_7318_;
                                                let _e2333 = phi_7320_;
                                                let _e2335 = phi_7322_;
                                                let _e2337 = phi_7324_;
                                                let _e2339 = phi_7326_;
                                                local_20 = _e2329;
                                                local_42 = _e2331;
                                                if (_e2327.member < _e2327.member_1) {
                                                    phi_7314_ = type_12((_e2327.member + 1u), _e2327.member_1);
                                                    phi_7349_ = type_12(1u, _e2327.member);
                                                } else {
                                                    phi_7314_ = _e2327;
                                                    phi_7349_ = type_12(0u, type_12().member_1);
                                                }
                                                let _e2351 = phi_7314_;
                                                let _e2353 = phi_7349_;
                                                if (bitcast<i32>(_e2353.member) != 0i) {
                                                    let _e2359 = local_12.member[0u];
                                                    let _e2365 = local_12.member[1u];
                                                    let _e2381 = local_12.member_1[0u];
                                                    let _e2387 = local_12.member_1[1u];
                                                    let _e2403 = local_12.member_2[0u];
                                                    let _e2409 = local_12.member_2[1u];
                                                    let _e2423 = function_1(array<f32, 3>((_e2359[0] + ((_e2365[0] - _e2359[0]) * _e2329)), (_e2359[1] + ((_e2365[1] - _e2359[1]) * _e2329)), (_e2359[2] + ((_e2365[2] - _e2359[2]) * _e2329))), array<f32, 3>((_e2381[0] + ((_e2387[0] - _e2381[0]) * _e2329)), (_e2381[1] + ((_e2387[1] - _e2381[1]) * _e2329)), (_e2381[2] + ((_e2387[2] - _e2381[2]) * _e2329))), array<f32, 3>((_e2403[0] + ((_e2409[0] - _e2403[0]) * _e2329)), (_e2403[1] + ((_e2409[1] - _e2403[1]) * _e2329)), (_e2403[2] + ((_e2409[2] - _e2403[2]) * _e2329))), 0u);
                                                    if (_e2339 == 0u) {
                                                        phi_7477_ = _e2423;
                                                    } else {
                                                        if (_e2339 == 1u) {
                                                            phi_7463_ = _e2423[0];
                                                        } else {
                                                            phi_7463_ = 0f;
                                                        }
                                                        let _e2428 = phi_7463_;
                                                        if (_e2339 == 2u) {
                                                            phi_7469_ = _e2423[1];
                                                        } else {
                                                            phi_7469_ = 0f;
                                                        }
                                                        let _e2432 = phi_7469_;
                                                        if (_e2339 == 3u) {
                                                            phi_7475_ = _e2423[2];
                                                        } else {
                                                            phi_7475_ = 0f;
                                                        }
                                                        let _e2436 = phi_7475_;
                                                        phi_7477_ = array<f32, 3>(_e2428, _e2432, _e2436);
                                                    }
                                                    let _e2439 = phi_7477_;
                                                    if (_e2439[0] < 0f) {
                                                        phi_7484_ = -(_e2439[0]);
                                                    } else {
                                                        phi_7484_ = _e2439[0];
                                                    }
                                                    let _e2444 = phi_7484_;
                                                    if (_e2439[1] < 0f) {
                                                        phi_7491_ = -(_e2439[1]);
                                                    } else {
                                                        phi_7491_ = _e2439[1];
                                                    }
                                                    let _e2449 = phi_7491_;
                                                    if (_e2439[2] < 0f) {
                                                        phi_7499_ = -(_e2439[2]);
                                                    } else {
                                                        phi_7499_ = _e2439[2];
                                                    }
                                                    let _e2455 = phi_7499_;
                                                    let _e2456 = ((_e2444 + _e2449) + _e2455);
                                                    if (_e2456 > 0f) {
                                                        if ((bitcast<u32>(_e2456) & 2139095040u) != 2139095040u) {
                                                            let _e2461 = (1f / _e2456);
                                                            let _e2463 = (_e2439[0] * _e2461);
                                                            let _e2465 = (_e2439[1] * _e2461);
                                                            let _e2467 = (_e2439[2] * _e2461);
                                                            let _e2472 = (((_e2463 * _e2463) + (_e2465 * _e2465)) + (_e2467 * _e2467));
                                                            if (_e2472 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2472 > 0f) {
                                                                    phi_7536_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_7536_ = 0f;
                                                                }
                                                                let _e2525 = phi_7536_;
                                                                phi_7600_ = _e2525;
                                                            } else {
                                                                phi_7543_ = type_14(0i, 5i);
                                                                phi_7546_ = bitcast<f32>(((bitcast<u32>(_e2472) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2480 = phi_7543_;
                                                                    let _e2482 = phi_7546_;
                                                                    local_18 = _e2482;
                                                                    if (_e2480.member < _e2480.member_1) {
                                                                        let _e2489 = (_e2480.member + 1i);
                                                                        if ((false == (_e2489 > _e2480.member)) != false) {
                                                                            phi_7567_ = true;
                                                                        } else {
                                                                            phi_7567_ = false;
                                                                        }
                                                                        let _e2494 = phi_7567_;
                                                                        if _e2494 {
                                                                            phi_7573_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_7573_ = type_15(1u, _e2489);
                                                                        }
                                                                        let _e2499 = phi_7573_;
                                                                        phi_7544_ = type_14(_e2499.member_1, _e2480.member_1);
                                                                        phi_7587_ = type_15(1u, _e2480.member);
                                                                    } else {
                                                                        phi_7544_ = _e2480;
                                                                        phi_7587_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2505 = phi_7544_;
                                                                    let _e2507 = phi_7587_;
                                                                    let _e2510 = (bitcast<i32>(_e2507.member) != 0i);
                                                                    if _e2510 {
                                                                        phi_7547_ = (0.5f * (_e2482 + (_e2472 / _e2482)));
                                                                    } else {
                                                                        phi_7547_ = f32();
                                                                    }
                                                                    let _e2515 = phi_7547_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7543_ = _e2505;
                                                                        phi_7546_ = _e2515;
                                                                        break if !(_e2510);
                                                                    }
                                                                }
                                                                let _e2520 = local_18;
                                                                phi_7600_ = (_e2520 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2527 = phi_7600_;
                                                            let _e2528 = (0.000000059604645f * 12f);
                                                            let _e2533 = ((((((((_e2203 + _e2205) + (_e2257 + _e2259)) + (_e2311 + _e2313)) * (0.000000059604645f * 16f)) + (_e2320 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2527) * (1f + _e2528)));
                                                            let _e2538 = (((_e2463 * _e2107[0]) + (_e2465 * _e2107[1])) + (_e2467 * _e2107[2]));
                                                            let _e2543 = (((_e2463 * (_e2107[0] - _e2113[0])) + (_e2465 * (_e2107[1] - _e2113[1]))) + (_e2467 * (_e2107[2] - _e2113[2])));
                                                            let _e2548 = (((_e2463 * (_e2107[0] - _e2119[0])) + (_e2465 * (_e2107[1] - _e2119[1]))) + (_e2467 * (_e2107[2] - _e2119[2])));
                                                            let _e2553 = (((_e2463 * _e2107[0]) + (_e2465 * _e2107[1])) + (_e2467 * _e2107[2]));
                                                            let _e2559 = (((_e2463 * _e2131[0]) + (_e2465 * _e2131[1])) + (_e2467 * _e2131[2]));
                                                            let _e2564 = (((_e2463 * (_e2131[0] - _e2137[0])) + (_e2465 * (_e2131[1] - _e2137[1]))) + (_e2467 * (_e2131[2] - _e2137[2])));
                                                            let _e2569 = (((_e2463 * (_e2131[0] - _e2143[0])) + (_e2465 * (_e2131[1] - _e2143[1]))) + (_e2467 * (_e2131[2] - _e2143[2])));
                                                            let _e2574 = (((_e2463 * _e2131[0]) + (_e2465 * _e2131[1])) + (_e2467 * _e2131[2]));
                                                            if (_e2538 < 0f) {
                                                                phi_7666_ = -(_e2538);
                                                            } else {
                                                                phi_7666_ = _e2538;
                                                            }
                                                            let _e2579 = phi_7666_;
                                                            if (_e2559 < 0f) {
                                                                phi_7672_ = -(_e2559);
                                                            } else {
                                                                phi_7672_ = _e2559;
                                                            }
                                                            let _e2583 = phi_7672_;
                                                            if (_e2543 < 0f) {
                                                                phi_7681_ = -(_e2543);
                                                            } else {
                                                                phi_7681_ = _e2543;
                                                            }
                                                            let _e2590 = phi_7681_;
                                                            if (_e2564 < 0f) {
                                                                phi_7687_ = -(_e2564);
                                                            } else {
                                                                phi_7687_ = _e2564;
                                                            }
                                                            let _e2594 = phi_7687_;
                                                            if (_e2548 < 0f) {
                                                                phi_7696_ = -(_e2548);
                                                            } else {
                                                                phi_7696_ = _e2548;
                                                            }
                                                            let _e2601 = phi_7696_;
                                                            if (_e2569 < 0f) {
                                                                phi_7702_ = -(_e2569);
                                                            } else {
                                                                phi_7702_ = _e2569;
                                                            }
                                                            let _e2605 = phi_7702_;
                                                            if (_e2553 < 0f) {
                                                                phi_7711_ = -(_e2553);
                                                            } else {
                                                                phi_7711_ = _e2553;
                                                            }
                                                            let _e2612 = phi_7711_;
                                                            if (_e2574 < 0f) {
                                                                phi_7717_ = -(_e2574);
                                                            } else {
                                                                phi_7717_ = _e2574;
                                                            }
                                                            let _e2616 = phi_7717_;
                                                            phi_7723_ = type_31(array<f32, 4>(_e2538, _e2543, _e2548, _e2553), array<f32, 4>(_e2559, _e2564, _e2569, _e2574), array<f32, 4>((_e2533 + ((_e2579 + _e2583) * _e2528)), (_e2533 + ((_e2590 + _e2594) * _e2528)), (_e2533 + ((_e2601 + _e2605) * _e2528)), (_e2533 + ((_e2612 + _e2616) * _e2528))));
                                                            phi_7724_ = false;
                                                        } else {
                                                            phi_7723_ = type_31();
                                                            phi_7724_ = true;
                                                        }
                                                        let _e2623 = phi_7723_;
                                                        let _e2625 = phi_7724_;
                                                        phi_7725_ = _e2623;
                                                        phi_7726_ = _e2625;
                                                    } else {
                                                        phi_7725_ = type_31();
                                                        phi_7726_ = true;
                                                    }
                                                    let _e2627 = phi_7725_;
                                                    let _e2629 = phi_7726_;
                                                    if _e2629 {
                                                        phi_7734_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_7734_ = _e2627;
                                                    }
                                                    let _e2631 = phi_7734_;
                                                    local_1 = type_31(array<f32, 4>(_e2631.member[0], _e2631.member[1], _e2631.member[2], _e2631.member[3]), array<f32, 4>(_e2631.member_1[0], _e2631.member_1[1], _e2631.member_1[2], _e2631.member_1[3]), array<f32, 4>(_e2631.member_2[0], _e2631.member_2[1], _e2631.member_2[2], _e2631.member_2[3]));
                                                    let _e2651 = (_e2329 - _e2335);
                                                    let _e2655 = local_1.member[0u];
                                                    let _e2658 = local_1.member_1[0u];
                                                    let _e2661 = local_1.member[0u];
                                                    let _e2667 = local_1.member_2[0u];
                                                    if (((_e2655 + ((_e2658 - _e2661) * _e2329)) - _e2667) > 0f) {
                                                        let _e2672 = local_1.member[1u];
                                                        let _e2675 = local_1.member_1[1u];
                                                        let _e2678 = local_1.member[1u];
                                                        let _e2684 = local_1.member_2[1u];
                                                        if (((_e2672 + ((_e2675 - _e2678) * _e2329)) - _e2684) > 0f) {
                                                            let _e2689 = local_1.member[2u];
                                                            let _e2692 = local_1.member_1[2u];
                                                            let _e2695 = local_1.member[2u];
                                                            let _e2701 = local_1.member_2[2u];
                                                            if (((_e2689 + ((_e2692 - _e2695) * _e2329)) - _e2701) > 0f) {
                                                                let _e2706 = local_1.member[3u];
                                                                let _e2709 = local_1.member_1[3u];
                                                                let _e2712 = local_1.member[3u];
                                                                let _e2718 = local_1.member_2[3u];
                                                                phi_7905_ = (((_e2706 + ((_e2709 - _e2712) * _e2329)) - _e2718) > 0f);
                                                                phi_7906_ = false;
                                                            } else {
                                                                phi_7905_ = bool();
                                                                phi_7906_ = true;
                                                            }
                                                            let _e2722 = phi_7905_;
                                                            let _e2724 = phi_7906_;
                                                            phi_7907_ = _e2722;
                                                            phi_7908_ = _e2724;
                                                        } else {
                                                            phi_7907_ = bool();
                                                            phi_7908_ = true;
                                                        }
                                                        let _e2726 = phi_7907_;
                                                        let _e2728 = phi_7908_;
                                                        phi_7909_ = _e2726;
                                                        phi_7910_ = _e2728;
                                                    } else {
                                                        phi_7909_ = bool();
                                                        phi_7910_ = true;
                                                    }
                                                    let _e2730 = phi_7909_;
                                                    let _e2732 = phi_7910_;
                                                    if _e2732 {
                                                        phi_7914_ = false;
                                                    } else {
                                                        phi_7914_ = _e2730;
                                                    }
                                                    let _e2734 = phi_7914_;
                                                    if _e2734 {
                                                        if (_e2329 <= _e2331) {
                                                            phi_8224_ = true;
                                                        } else {
                                                            let _e2738 = local.member[0u];
                                                            let _e2741 = local.member_1[0u];
                                                            let _e2744 = local.member[0u];
                                                            let _e2750 = local.member_2[0u];
                                                            let _e2754 = local_1.member[0u];
                                                            let _e2757 = local_1.member_1[0u];
                                                            let _e2760 = local_1.member[0u];
                                                            let _e2766 = local_1.member_2[0u];
                                                            if ((((_e2738 + ((_e2741 - _e2744) * _e2329)) - _e2750) + ((_e2754 + ((_e2757 - _e2760) * _e2335)) - _e2766)) > 0f) {
                                                                let _e2772 = local.member[1u];
                                                                let _e2775 = local.member_1[1u];
                                                                let _e2778 = local.member[1u];
                                                                let _e2784 = local.member_2[1u];
                                                                let _e2788 = local_1.member[1u];
                                                                let _e2791 = local_1.member_1[1u];
                                                                let _e2794 = local_1.member[1u];
                                                                let _e2800 = local_1.member_2[1u];
                                                                if ((((_e2772 + ((_e2775 - _e2778) * _e2329)) - _e2784) + ((_e2788 + ((_e2791 - _e2794) * _e2335)) - _e2800)) > 0f) {
                                                                    let _e2806 = local.member[2u];
                                                                    let _e2809 = local.member_1[2u];
                                                                    let _e2812 = local.member[2u];
                                                                    let _e2818 = local.member_2[2u];
                                                                    let _e2822 = local_1.member[2u];
                                                                    let _e2825 = local_1.member_1[2u];
                                                                    let _e2828 = local_1.member[2u];
                                                                    let _e2834 = local_1.member_2[2u];
                                                                    if ((((_e2806 + ((_e2809 - _e2812) * _e2329)) - _e2818) + ((_e2822 + ((_e2825 - _e2828) * _e2335)) - _e2834)) > 0f) {
                                                                        let _e2840 = local.member[3u];
                                                                        let _e2843 = local.member_1[3u];
                                                                        let _e2846 = local.member[3u];
                                                                        let _e2852 = local.member_2[3u];
                                                                        let _e2856 = local_1.member[3u];
                                                                        let _e2859 = local_1.member_1[3u];
                                                                        let _e2862 = local_1.member[3u];
                                                                        let _e2868 = local_1.member_2[3u];
                                                                        phi_8211_ = ((((_e2840 + ((_e2843 - _e2846) * _e2329)) - _e2852) + ((_e2856 + ((_e2859 - _e2862) * _e2335)) - _e2868)) > 0f);
                                                                        phi_8212_ = false;
                                                                    } else {
                                                                        phi_8211_ = bool();
                                                                        phi_8212_ = true;
                                                                    }
                                                                    let _e2873 = phi_8211_;
                                                                    let _e2875 = phi_8212_;
                                                                    phi_8213_ = _e2873;
                                                                    phi_8214_ = _e2875;
                                                                } else {
                                                                    phi_8213_ = bool();
                                                                    phi_8214_ = true;
                                                                }
                                                                let _e2877 = phi_8213_;
                                                                let _e2879 = phi_8214_;
                                                                phi_8215_ = _e2877;
                                                                phi_8216_ = _e2879;
                                                            } else {
                                                                phi_8215_ = bool();
                                                                phi_8216_ = true;
                                                            }
                                                            let _e2881 = phi_8215_;
                                                            let _e2883 = phi_8216_;
                                                            if _e2883 {
                                                                phi_8220_ = false;
                                                            } else {
                                                                phi_8220_ = _e2881;
                                                            }
                                                            let _e2885 = phi_8220_;
                                                            phi_8224_ = _e2885;
                                                        }
                                                        let _e2887 = phi_8224_;
                                                        if _e2887 {
                                                            if _e2337 {
                                                                if (_e2329 >= _e1390.member_1) {
                                                                    phi_8235_ = false;
                                                                } else {
                                                                    phi_8235_ = true;
                                                                }
                                                                let _e2890 = phi_8235_;
                                                                phi_8236_ = _e2890;
                                                            } else {
                                                                phi_8236_ = true;
                                                            }
                                                            let _e2892 = phi_8236_;
                                                            if _e2892 {
                                                                local = type_31(array<f32, 4>(_e2631.member[0], _e2631.member[1], _e2631.member[2], _e2631.member[3]), array<f32, 4>(_e2631.member_1[0], _e2631.member_1[1], _e2631.member_1[2], _e2631.member_1[3]), array<f32, 4>(_e2631.member_2[0], _e2631.member_2[1], _e2631.member_2[2], _e2631.member_2[3]));
                                                                let _e2914 = local.member[0u];
                                                                let _e2917 = local.member_1[0u];
                                                                let _e2920 = local.member_2[0u];
                                                                if (_e2914 > _e2920) {
                                                                    if (_e2917 > _e2920) {
                                                                        phi_8310_ = false;
                                                                    } else {
                                                                        phi_8310_ = true;
                                                                    }
                                                                    let _e2924 = phi_8310_;
                                                                    phi_8311_ = _e2924;
                                                                } else {
                                                                    phi_8311_ = true;
                                                                }
                                                                let _e2926 = phi_8311_;
                                                                if _e2926 {
                                                                    let _e2927 = (_e2917 >= _e2914);
                                                                    if _e2927 {
                                                                        phi_8333_ = f32();
                                                                        phi_8334_ = false;
                                                                    } else {
                                                                        if ((_e2914 - _e2917) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8331_ = (((_e2914 - _e2920) / (_e2914 - _e2917)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8332_ = false;
                                                                        } else {
                                                                            phi_8331_ = f32();
                                                                            phi_8332_ = true;
                                                                        }
                                                                        let _e2938 = phi_8331_;
                                                                        let _e2940 = phi_8332_;
                                                                        phi_8333_ = _e2938;
                                                                        phi_8334_ = _e2940;
                                                                    }
                                                                    let _e2942 = phi_8333_;
                                                                    let _e2944 = phi_8334_;
                                                                    phi_8335_ = _e2942;
                                                                    phi_8336_ = _e2927;
                                                                    phi_8337_ = _e2944;
                                                                } else {
                                                                    phi_8335_ = f32();
                                                                    phi_8336_ = true;
                                                                    phi_8337_ = false;
                                                                }
                                                                let _e2946 = phi_8335_;
                                                                let _e2948 = phi_8336_;
                                                                let _e2950 = phi_8337_;
                                                                if _e2948 {
                                                                    phi_8341_ = 2f;
                                                                    phi_8342_ = true;
                                                                } else {
                                                                    phi_8341_ = _e2329;
                                                                    phi_8342_ = _e2950;
                                                                }
                                                                let _e2952 = phi_8341_;
                                                                let _e2954 = phi_8342_;
                                                                if _e2954 {
                                                                    phi_8346_ = _e2952;
                                                                } else {
                                                                    phi_8346_ = _e2946;
                                                                }
                                                                let _e2956 = phi_8346_;
                                                                let _e2959 = local.member[1u];
                                                                let _e2962 = local.member_1[1u];
                                                                let _e2965 = local.member_2[1u];
                                                                if (_e2959 > _e2965) {
                                                                    if (_e2962 > _e2965) {
                                                                        phi_8378_ = false;
                                                                    } else {
                                                                        phi_8378_ = true;
                                                                    }
                                                                    let _e2969 = phi_8378_;
                                                                    phi_8379_ = _e2969;
                                                                } else {
                                                                    phi_8379_ = true;
                                                                }
                                                                let _e2971 = phi_8379_;
                                                                if _e2971 {
                                                                    let _e2972 = (_e2962 >= _e2959);
                                                                    if _e2972 {
                                                                        phi_8401_ = f32();
                                                                        phi_8402_ = false;
                                                                    } else {
                                                                        if ((_e2959 - _e2962) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8399_ = (((_e2959 - _e2965) / (_e2959 - _e2962)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8400_ = false;
                                                                        } else {
                                                                            phi_8399_ = f32();
                                                                            phi_8400_ = true;
                                                                        }
                                                                        let _e2983 = phi_8399_;
                                                                        let _e2985 = phi_8400_;
                                                                        phi_8401_ = _e2983;
                                                                        phi_8402_ = _e2985;
                                                                    }
                                                                    let _e2987 = phi_8401_;
                                                                    let _e2989 = phi_8402_;
                                                                    phi_8403_ = _e2987;
                                                                    phi_8404_ = _e2972;
                                                                    phi_8405_ = _e2989;
                                                                } else {
                                                                    phi_8403_ = f32();
                                                                    phi_8404_ = true;
                                                                    phi_8405_ = false;
                                                                }
                                                                let _e2991 = phi_8403_;
                                                                let _e2993 = phi_8404_;
                                                                let _e2995 = phi_8405_;
                                                                if _e2993 {
                                                                    phi_8409_ = 2f;
                                                                    phi_8410_ = true;
                                                                } else {
                                                                    phi_8409_ = _e2329;
                                                                    phi_8410_ = _e2995;
                                                                }
                                                                let _e2997 = phi_8409_;
                                                                let _e2999 = phi_8410_;
                                                                if _e2999 {
                                                                    phi_8414_ = _e2997;
                                                                } else {
                                                                    phi_8414_ = _e2991;
                                                                }
                                                                let _e3001 = phi_8414_;
                                                                if (_e2956 < _e3001) {
                                                                    phi_8419_ = _e2956;
                                                                } else {
                                                                    phi_8419_ = _e3001;
                                                                }
                                                                let _e3004 = phi_8419_;
                                                                let _e3007 = local.member[2u];
                                                                let _e3010 = local.member_1[2u];
                                                                let _e3013 = local.member_2[2u];
                                                                if (_e3007 > _e3013) {
                                                                    if (_e3010 > _e3013) {
                                                                        phi_8451_ = false;
                                                                    } else {
                                                                        phi_8451_ = true;
                                                                    }
                                                                    let _e3017 = phi_8451_;
                                                                    phi_8452_ = _e3017;
                                                                } else {
                                                                    phi_8452_ = true;
                                                                }
                                                                let _e3019 = phi_8452_;
                                                                if _e3019 {
                                                                    let _e3020 = (_e3010 >= _e3007);
                                                                    if _e3020 {
                                                                        phi_8474_ = f32();
                                                                        phi_8475_ = false;
                                                                    } else {
                                                                        if ((_e3007 - _e3010) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8472_ = (((_e3007 - _e3013) / (_e3007 - _e3010)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8473_ = false;
                                                                        } else {
                                                                            phi_8472_ = f32();
                                                                            phi_8473_ = true;
                                                                        }
                                                                        let _e3031 = phi_8472_;
                                                                        let _e3033 = phi_8473_;
                                                                        phi_8474_ = _e3031;
                                                                        phi_8475_ = _e3033;
                                                                    }
                                                                    let _e3035 = phi_8474_;
                                                                    let _e3037 = phi_8475_;
                                                                    phi_8476_ = _e3035;
                                                                    phi_8477_ = _e3020;
                                                                    phi_8478_ = _e3037;
                                                                } else {
                                                                    phi_8476_ = f32();
                                                                    phi_8477_ = true;
                                                                    phi_8478_ = false;
                                                                }
                                                                let _e3039 = phi_8476_;
                                                                let _e3041 = phi_8477_;
                                                                let _e3043 = phi_8478_;
                                                                if _e3041 {
                                                                    phi_8482_ = 2f;
                                                                    phi_8483_ = true;
                                                                } else {
                                                                    phi_8482_ = _e2329;
                                                                    phi_8483_ = _e3043;
                                                                }
                                                                let _e3045 = phi_8482_;
                                                                let _e3047 = phi_8483_;
                                                                if _e3047 {
                                                                    phi_8487_ = _e3045;
                                                                } else {
                                                                    phi_8487_ = _e3039;
                                                                }
                                                                let _e3049 = phi_8487_;
                                                                let _e3052 = local.member[3u];
                                                                let _e3055 = local.member_1[3u];
                                                                let _e3058 = local.member_2[3u];
                                                                if (_e3052 > _e3058) {
                                                                    if (_e3055 > _e3058) {
                                                                        phi_8519_ = false;
                                                                    } else {
                                                                        phi_8519_ = true;
                                                                    }
                                                                    let _e3062 = phi_8519_;
                                                                    phi_8520_ = _e3062;
                                                                } else {
                                                                    phi_8520_ = true;
                                                                }
                                                                let _e3064 = phi_8520_;
                                                                if _e3064 {
                                                                    let _e3065 = (_e3055 >= _e3052);
                                                                    if _e3065 {
                                                                        phi_8542_ = f32();
                                                                        phi_8543_ = false;
                                                                    } else {
                                                                        if ((_e3052 - _e3055) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_8540_ = (((_e3052 - _e3058) / (_e3052 - _e3055)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_8541_ = false;
                                                                        } else {
                                                                            phi_8540_ = f32();
                                                                            phi_8541_ = true;
                                                                        }
                                                                        let _e3076 = phi_8540_;
                                                                        let _e3078 = phi_8541_;
                                                                        phi_8542_ = _e3076;
                                                                        phi_8543_ = _e3078;
                                                                    }
                                                                    let _e3080 = phi_8542_;
                                                                    let _e3082 = phi_8543_;
                                                                    phi_8544_ = _e3080;
                                                                    phi_8545_ = _e3065;
                                                                    phi_8546_ = _e3082;
                                                                } else {
                                                                    phi_8544_ = f32();
                                                                    phi_8545_ = true;
                                                                    phi_8546_ = false;
                                                                }
                                                                let _e3084 = phi_8544_;
                                                                let _e3086 = phi_8545_;
                                                                let _e3088 = phi_8546_;
                                                                if _e3086 {
                                                                    phi_8550_ = 2f;
                                                                    phi_8551_ = true;
                                                                } else {
                                                                    phi_8550_ = _e2329;
                                                                    phi_8551_ = _e3088;
                                                                }
                                                                let _e3090 = phi_8550_;
                                                                let _e3092 = phi_8551_;
                                                                if _e3092 {
                                                                    phi_8555_ = _e3090;
                                                                } else {
                                                                    phi_8555_ = _e3084;
                                                                }
                                                                let _e3094 = phi_8555_;
                                                                if (_e3049 < _e3094) {
                                                                    phi_8560_ = _e3049;
                                                                } else {
                                                                    phi_8560_ = _e3094;
                                                                }
                                                                let _e3097 = phi_8560_;
                                                                if (_e3004 < _e3097) {
                                                                    phi_8565_ = _e3004;
                                                                } else {
                                                                    phi_8565_ = _e3097;
                                                                }
                                                                let _e3100 = phi_8565_;
                                                                if (_e3100 > _e2329) {
                                                                    phi_8570_ = _e3100;
                                                                } else {
                                                                    phi_8570_ = _e2329;
                                                                }
                                                                let _e3103 = phi_8570_;
                                                                let _e3104 = (_e3103 > _e1390.member_1);
                                                                if _e3104 {
                                                                    phi_9074_ = f32();
                                                                    phi_9075_ = f32();
                                                                    phi_9076_ = false;
                                                                } else {
                                                                    let _e3105 = (_e3103 - _e2329);
                                                                    if _e2337 {
                                                                        if (_e3105 <= 0.0000000037252903f) {
                                                                            phi_9064_ = true;
                                                                        } else {
                                                                            if (_e3105 <= (_e2333 * 0.25f)) {
                                                                                phi_9063_ = false;
                                                                            } else {
                                                                                phi_9063_ = true;
                                                                            }
                                                                            let _e3111 = phi_9063_;
                                                                            phi_9064_ = _e3111;
                                                                        }
                                                                        let _e3113 = phi_9064_;
                                                                        if _e3113 {
                                                                            phi_9069_ = (_e2651 + _e2651);
                                                                        } else {
                                                                            phi_9069_ = 0f;
                                                                        }
                                                                        let _e3116 = phi_9069_;
                                                                        phi_9071_ = _e3116;
                                                                    } else {
                                                                        phi_9071_ = (_e1390.member_1 - _e2329);
                                                                    }
                                                                    let _e3118 = phi_9071_;
                                                                    phi_9074_ = _e3118;
                                                                    phi_9075_ = _e3105;
                                                                    phi_9076_ = true;
                                                                }
                                                                let _e3120 = phi_9074_;
                                                                let _e3122 = phi_9075_;
                                                                let _e3124 = phi_9076_;
                                                                phi_9078_ = _e3103;
                                                                phi_9079_ = _e3120;
                                                                phi_9080_ = _e3122;
                                                                phi_9082_ = _e3124;
                                                                phi_9083_ = _e3104;
                                                                phi_9085_ = false;
                                                            } else {
                                                                phi_9078_ = f32();
                                                                phi_9079_ = f32();
                                                                phi_9080_ = f32();
                                                                phi_9082_ = false;
                                                                phi_9083_ = false;
                                                                phi_9085_ = true;
                                                            }
                                                            let _e3126 = phi_9078_;
                                                            let _e3128 = phi_9079_;
                                                            let _e3130 = phi_9080_;
                                                            let _e3132 = phi_9082_;
                                                            let _e3134 = phi_9083_;
                                                            let _e3136 = phi_9085_;
                                                            phi_9086_ = _e3126;
                                                            phi_9087_ = _e3128;
                                                            phi_9088_ = _e3130;
                                                            phi_9090_ = false;
                                                            phi_9091_ = _e3132;
                                                            phi_9092_ = _e3134;
                                                            phi_9094_ = _e3136;
                                                        } else {
                                                            phi_9086_ = f32();
                                                            phi_9087_ = f32();
                                                            phi_9088_ = f32();
                                                            phi_9090_ = true;
                                                            phi_9091_ = false;
                                                            phi_9092_ = false;
                                                            phi_9094_ = false;
                                                        }
                                                        let _e3138 = phi_9086_;
                                                        let _e3140 = phi_9087_;
                                                        let _e3142 = phi_9088_;
                                                        let _e3144 = phi_9090_;
                                                        let _e3146 = phi_9091_;
                                                        let _e3148 = phi_9092_;
                                                        let _e3150 = phi_9094_;
                                                        phi_9095_ = _e3138;
                                                        phi_9096_ = _e3140;
                                                        phi_9097_ = _e3142;
                                                        phi_9099_ = _e3144;
                                                        phi_9100_ = _e3146;
                                                        phi_9101_ = _e3148;
                                                        phi_9103_ = _e3150;
                                                    } else {
                                                        phi_9095_ = f32();
                                                        phi_9096_ = f32();
                                                        phi_9097_ = f32();
                                                        phi_9099_ = true;
                                                        phi_9100_ = false;
                                                        phi_9101_ = false;
                                                        phi_9103_ = false;
                                                    }
                                                    let _e3152 = phi_9095_;
                                                    let _e3154 = phi_9096_;
                                                    let _e3156 = phi_9097_;
                                                    let _e3158 = phi_9099_;
                                                    let _e3160 = phi_9100_;
                                                    let _e3162 = phi_9101_;
                                                    let _e3164 = phi_9103_;
                                                    if _e3158 {
                                                        if (_e2329 <= _e2331) {
                                                            let _e3325 = (_e2339 + 1u);
                                                            let _e3326 = (_e3325 > 3u);
                                                            if _e3326 {
                                                                phi_9116_ = false;
                                                            } else {
                                                                phi_9116_ = true;
                                                            }
                                                            let _e3328 = phi_9116_;
                                                            phi_9438_ = _e3325;
                                                            phi_9439_ = f32();
                                                            phi_9440_ = false;
                                                            phi_9441_ = _e3328;
                                                            phi_9442_ = _e3326;
                                                        } else {
                                                            let _e3168 = local.member[0u];
                                                            let _e3171 = local.member_1[0u];
                                                            let _e3174 = local.member[0u];
                                                            let _e3180 = local.member_2[0u];
                                                            let _e3181 = ((_e3168 + ((_e3171 - _e3174) * _e2335)) - _e3180);
                                                            let _e3184 = local.member[1u];
                                                            let _e3187 = local.member_1[1u];
                                                            let _e3190 = local.member[1u];
                                                            let _e3196 = local.member_2[1u];
                                                            let _e3197 = ((_e3184 + ((_e3187 - _e3190) * _e2335)) - _e3196);
                                                            if (_e3181 < _e3197) {
                                                                phi_9189_ = _e3181;
                                                            } else {
                                                                phi_9189_ = _e3197;
                                                            }
                                                            let _e3200 = phi_9189_;
                                                            let _e3203 = local.member[2u];
                                                            let _e3206 = local.member_1[2u];
                                                            let _e3209 = local.member[2u];
                                                            let _e3215 = local.member_2[2u];
                                                            let _e3216 = ((_e3203 + ((_e3206 - _e3209) * _e2335)) - _e3215);
                                                            let _e3219 = local.member[3u];
                                                            let _e3222 = local.member_1[3u];
                                                            let _e3225 = local.member[3u];
                                                            let _e3231 = local.member_2[3u];
                                                            let _e3232 = ((_e3219 + ((_e3222 - _e3225) * _e2335)) - _e3231);
                                                            if (_e3216 < _e3232) {
                                                                phi_9262_ = _e3216;
                                                            } else {
                                                                phi_9262_ = _e3232;
                                                            }
                                                            let _e3235 = phi_9262_;
                                                            if (_e3200 < _e3235) {
                                                                phi_9267_ = _e3200;
                                                            } else {
                                                                phi_9267_ = _e3235;
                                                            }
                                                            let _e3238 = phi_9267_;
                                                            let _e3241 = local_1.member[0u];
                                                            let _e3244 = local_1.member_1[0u];
                                                            let _e3247 = local_1.member[0u];
                                                            let _e3253 = local_1.member_2[0u];
                                                            let _e3254 = ((_e3241 + ((_e3244 - _e3247) * _e2329)) - _e3253);
                                                            let _e3257 = local_1.member[1u];
                                                            let _e3260 = local_1.member_1[1u];
                                                            let _e3263 = local_1.member[1u];
                                                            let _e3269 = local_1.member_2[1u];
                                                            let _e3270 = ((_e3257 + ((_e3260 - _e3263) * _e2329)) - _e3269);
                                                            if (_e3254 < _e3270) {
                                                                phi_9340_ = _e3254;
                                                            } else {
                                                                phi_9340_ = _e3270;
                                                            }
                                                            let _e3273 = phi_9340_;
                                                            let _e3276 = local_1.member[2u];
                                                            let _e3279 = local_1.member_1[2u];
                                                            let _e3282 = local_1.member[2u];
                                                            let _e3288 = local_1.member_2[2u];
                                                            let _e3289 = ((_e3276 + ((_e3279 - _e3282) * _e2329)) - _e3288);
                                                            let _e3292 = local_1.member[3u];
                                                            let _e3295 = local_1.member_1[3u];
                                                            let _e3298 = local_1.member[3u];
                                                            let _e3304 = local_1.member_2[3u];
                                                            let _e3305 = ((_e3292 + ((_e3295 - _e3298) * _e2329)) - _e3304);
                                                            if (_e3289 < _e3305) {
                                                                phi_9413_ = _e3289;
                                                            } else {
                                                                phi_9413_ = _e3305;
                                                            }
                                                            let _e3308 = phi_9413_;
                                                            if (_e3273 < _e3308) {
                                                                phi_9418_ = _e3273;
                                                            } else {
                                                                phi_9418_ = _e3308;
                                                            }
                                                            let _e3311 = phi_9418_;
                                                            if (_e3311 > 0f) {
                                                                phi_9436_ = 0.5f;
                                                            } else {
                                                                let _e3315 = (0.95f * (_e3238 / (_e3238 - _e3311)));
                                                                if (_e3315 > 0.0625f) {
                                                                    if (_e3315 < 0.9f) {
                                                                        phi_9434_ = _e3315;
                                                                    } else {
                                                                        phi_9434_ = 0.9f;
                                                                    }
                                                                    let _e3319 = phi_9434_;
                                                                    phi_9435_ = _e3319;
                                                                } else {
                                                                    phi_9435_ = 0.0625f;
                                                                }
                                                                let _e3321 = phi_9435_;
                                                                phi_9436_ = _e3321;
                                                            }
                                                            let _e3323 = phi_9436_;
                                                            phi_9438_ = u32();
                                                            phi_9439_ = (_e2651 * _e3323);
                                                            phi_9440_ = true;
                                                            phi_9441_ = false;
                                                            phi_9442_ = false;
                                                        }
                                                        let _e3330 = phi_9438_;
                                                        let _e3332 = phi_9439_;
                                                        let _e3334 = phi_9440_;
                                                        let _e3336 = phi_9441_;
                                                        let _e3338 = phi_9442_;
                                                        phi_9443_ = _e3330;
                                                        phi_9444_ = _e2331;
                                                        phi_9445_ = _e3332;
                                                        phi_9446_ = _e2333;
                                                        phi_9447_ = _e2335;
                                                        phi_9448_ = _e2337;
                                                        phi_9449_ = _e2339;
                                                        phi_9450_ = _e3334;
                                                        phi_9451_ = _e3336;
                                                        phi_9452_ = _e3338;
                                                        phi_9453_ = false;
                                                        phi_9455_ = false;
                                                    } else {
                                                        phi_9443_ = u32();
                                                        phi_9444_ = _e3152;
                                                        phi_9445_ = _e3154;
                                                        phi_9446_ = _e3156;
                                                        phi_9447_ = _e2329;
                                                        phi_9448_ = true;
                                                        phi_9449_ = 0u;
                                                        phi_9450_ = _e3160;
                                                        phi_9451_ = false;
                                                        phi_9452_ = false;
                                                        phi_9453_ = _e3162;
                                                        phi_9455_ = _e3164;
                                                    }
                                                    let _e3340 = phi_9443_;
                                                    let _e3342 = phi_9444_;
                                                    let _e3344 = phi_9445_;
                                                    let _e3346 = phi_9446_;
                                                    let _e3348 = phi_9447_;
                                                    let _e3350 = phi_9448_;
                                                    let _e3352 = phi_9449_;
                                                    let _e3354 = phi_9450_;
                                                    let _e3356 = phi_9451_;
                                                    let _e3358 = phi_9452_;
                                                    let _e3360 = phi_9453_;
                                                    let _e3362 = phi_9455_;
                                                    if _e3354 {
                                                        let _e3363 = (_e3348 + _e3344);
                                                        if (_e3363 > _e3342) {
                                                            phi_9464_ = _e3363;
                                                        } else {
                                                            phi_9464_ = _e3342;
                                                        }
                                                        let _e3366 = phi_9464_;
                                                        if (_e3366 < _e1390.member_1) {
                                                            phi_9469_ = _e3366;
                                                        } else {
                                                            phi_9469_ = _e1390.member_1;
                                                        }
                                                        let _e3369 = phi_9469_;
                                                        if !(_e2337) {
                                                            phi_9478_ = true;
                                                        } else {
                                                            phi_9478_ = ((_e3369 - _e3348) > 0.0000000037252903f);
                                                        }
                                                        let _e3373 = phi_9478_;
                                                        if _e3373 {
                                                            phi_9482_ = false;
                                                        } else {
                                                            phi_9482_ = true;
                                                        }
                                                        let _e3375 = phi_9482_;
                                                        phi_9483_ = _e3369;
                                                        phi_9484_ = _e3342;
                                                        phi_9485_ = _e3346;
                                                        phi_9486_ = _e3348;
                                                        phi_9487_ = _e3350;
                                                        phi_9488_ = _e3352;
                                                        phi_9489_ = _e3373;
                                                        phi_9490_ = _e3375;
                                                        phi_9491_ = false;
                                                        phi_9492_ = false;
                                                        phi_9494_ = false;
                                                    } else {
                                                        phi_9483_ = _e2329;
                                                        phi_9484_ = _e2331;
                                                        phi_9485_ = _e2333;
                                                        phi_9486_ = _e2335;
                                                        phi_9487_ = _e2337;
                                                        phi_9488_ = _e3340;
                                                        phi_9489_ = _e3356;
                                                        phi_9490_ = false;
                                                        phi_9491_ = _e3358;
                                                        phi_9492_ = _e3360;
                                                        phi_9494_ = _e3362;
                                                    }
                                                    let _e3377 = phi_9483_;
                                                    let _e3379 = phi_9484_;
                                                    let _e3381 = phi_9485_;
                                                    let _e3383 = phi_9486_;
                                                    let _e3385 = phi_9487_;
                                                    let _e3387 = phi_9488_;
                                                    let _e3389 = phi_9489_;
                                                    let _e3391 = phi_9490_;
                                                    let _e3393 = phi_9491_;
                                                    let _e3395 = phi_9492_;
                                                    let _e3397 = phi_9494_;
                                                    phi_7317_ = _e3377;
                                                    phi_7319_ = _e3379;
                                                    phi_7321_ = _e3381;
                                                    phi_7323_ = _e3383;
                                                    phi_7325_ = _e3385;
                                                    phi_7327_ = _e3387;
                                                    phi_9495_ = _e3342;
                                                    phi_9497_ = _e3389;
                                                    phi_9498_ = _e3391;
                                                    phi_9499_ = _e3393;
                                                    phi_9500_ = _e3395;
                                                    phi_9502_ = false;
                                                    phi_9503_ = _e3397;
                                                } else {
                                                    phi_7317_ = f32();
                                                    phi_7319_ = f32();
                                                    phi_7321_ = f32();
                                                    phi_7323_ = f32();
                                                    phi_7325_ = bool();
                                                    phi_7327_ = u32();
                                                    phi_9495_ = f32();
                                                    phi_9497_ = false;
                                                    phi_9498_ = false;
                                                    phi_9499_ = false;
                                                    phi_9500_ = false;
                                                    phi_9502_ = true;
                                                    phi_9503_ = false;
                                                }
                                                let _e3399 = phi_7317_;
                                                let _e3401 = phi_7319_;
                                                let _e3403 = phi_7321_;
                                                let _e3405 = phi_7323_;
                                                let _e3407 = phi_7325_;
                                                let _e3409 = phi_7327_;
                                                let _e3411 = phi_9495_;
                                                let _e3413 = phi_9497_;
                                                let _e3415 = phi_9498_;
                                                let _e3417 = phi_9499_;
                                                let _e3419 = phi_9500_;
                                                let _e3421 = phi_9502_;
                                                let _e3423 = phi_9503_;
                                                local_19 = _e3415;
                                                local_36 = _e3417;
                                                local_37 = _e3419;
                                                local_38 = _e3421;
                                                local_39 = _e3423;
                                                local_40 = _e3415;
                                                local_41 = _e3411;
                                                continue;
                                                continuing {
                                                    phi_7313_ = _e2351;
                                                    phi_7316_ = _e3399;
                                                    phi_7318_ = _e3401;
                                                    phi_7320_ = _e3403;
                                                    phi_7322_ = _e3405;
                                                    phi_7324_ = _e3407;
                                                    phi_7326_ = _e3409;
                                                    break if !(_e3413);
                                                }
                                            }
                                            let _e3426 = local_19;
                                            if _e3426 {
                                                phi_9507_ = false;
                                                phi_9508_ = false;
                                                phi_9510_ = false;
                                                phi_9511_ = false;
                                            } else {
                                                let _e6338 = local_36;
                                                phi_9507_ = _e6338;
                                                let _e6341 = local_37;
                                                phi_9508_ = _e6341;
                                                let _e6344 = local_38;
                                                phi_9510_ = _e6344;
                                                let _e6347 = local_39;
                                                phi_9511_ = _e6347;
                                            }
                                            let _e3428 = phi_9507_;
                                            let _e3430 = phi_9508_;
                                            let _e3432 = phi_9510_;
                                            let _e3434 = phi_9511_;
                                            if _e3428 {
                                                let _e3436 = local_20;
                                                phi_9516_ = type_28(1u, _e3436);
                                                phi_9517_ = false;
                                                phi_9519_ = false;
                                                phi_9520_ = false;
                                                phi_9521_ = false;
                                            } else {
                                                phi_9516_ = type_28();
                                                phi_9517_ = _e3430;
                                                let _e6353 = local_40;
                                                phi_9519_ = _e6353;
                                                phi_9520_ = _e3432;
                                                phi_9521_ = _e3434;
                                            }
                                            let _e3439 = phi_9516_;
                                            let _e3441 = phi_9517_;
                                            let _e3443 = phi_9519_;
                                            let _e3445 = phi_9520_;
                                            let _e3447 = phi_9521_;
                                            if _e3441 {
                                                phi_9526_ = type_28(0u, type_28().member_1);
                                                phi_9528_ = false;
                                                phi_9529_ = false;
                                                phi_9530_ = false;
                                                phi_9531_ = true;
                                            } else {
                                                phi_9526_ = _e3439;
                                                phi_9528_ = _e3443;
                                                phi_9529_ = _e3445;
                                                phi_9530_ = _e3447;
                                                phi_9531_ = _e3428;
                                            }
                                            let _e3451 = phi_9526_;
                                            let _e3453 = phi_9528_;
                                            let _e3455 = phi_9529_;
                                            let _e3457 = phi_9530_;
                                            let _e3459 = phi_9531_;
                                            if _e3453 {
                                                let _e6363 = local_41;
                                                phi_9543_ = _e6363;
                                                phi_9544_ = true;
                                                phi_9545_ = false;
                                                phi_9546_ = false;
                                            } else {
                                                let _e6365 = local_42;
                                                phi_9543_ = _e6365;
                                                phi_9544_ = _e3455;
                                                phi_9545_ = _e3457;
                                                phi_9546_ = _e3459;
                                            }
                                            let _e3461 = phi_9543_;
                                            let _e3463 = phi_9544_;
                                            let _e3465 = phi_9545_;
                                            let _e3467 = phi_9546_;
                                            if _e3463 {
                                                phi_9551_ = type_28(1u, _e3461);
                                                phi_9552_ = false;
                                                phi_9553_ = false;
                                            } else {
                                                phi_9551_ = type_28();
                                                phi_9552_ = _e3465;
                                                phi_9553_ = _e3467;
                                            }
                                            let _e3470 = phi_9551_;
                                            let _e3472 = phi_9552_;
                                            let _e3474 = phi_9553_;
                                            if _e3472 {
                                                phi_9558_ = type_28(0u, type_28().member_1);
                                                phi_9559_ = true;
                                            } else {
                                                phi_9558_ = _e3451;
                                                phi_9559_ = _e3474;
                                            }
                                            let _e3478 = phi_9558_;
                                            let _e3480 = phi_9559_;
                                            if _e3480 {
                                                phi_9563_ = _e3478;
                                            } else {
                                                phi_9563_ = _e3470;
                                            }
                                            let _e3482 = phi_9563_;
                                            let _e3485 = (_e3482.member != 0u);
                                            if _e3485 {
                                                phi_9570_ = false;
                                            } else {
                                                phi_9570_ = true;
                                            }
                                            let _e3487 = phi_9570_;
                                            phi_9571_ = _e3482.member_1;
                                            phi_9572_ = _e3487;
                                            phi_9573_ = _e3485;
                                            phi_9574_ = false;
                                        } else {
                                            phi_9571_ = f32();
                                            phi_9572_ = false;
                                            phi_9573_ = false;
                                            phi_9574_ = true;
                                        }
                                        let _e3489 = phi_9571_;
                                        let _e3491 = phi_9572_;
                                        let _e3493 = phi_9573_;
                                        let _e3495 = phi_9574_;
                                        phi_9575_ = _e3489;
                                        phi_9576_ = _e3491;
                                        phi_9577_ = _e3493;
                                        phi_9578_ = _e3495;
                                    }
                                    let _e3497 = phi_9575_;
                                    let _e3499 = phi_9576_;
                                    let _e3501 = phi_9577_;
                                    let _e3503 = phi_9578_;
                                    phi_9579_ = _e3497;
                                    phi_9580_ = _e2090;
                                    phi_9581_ = _e3499;
                                    phi_9582_ = _e3501;
                                    phi_9583_ = _e3503;
                                }
                                let _e3505 = phi_9579_;
                                let _e3507 = phi_9580_;
                                let _e3509 = phi_9581_;
                                let _e3511 = phi_9582_;
                                let _e3513 = phi_9583_;
                                if _e3507 {
                                    phi_9587_ = true;
                                    phi_9588_ = false;
                                    phi_9589_ = false;
                                } else {
                                    phi_9587_ = _e3509;
                                    phi_9588_ = _e3511;
                                    phi_9589_ = _e3513;
                                }
                                let _e3515 = phi_9587_;
                                let _e3517 = phi_9588_;
                                let _e3519 = phi_9589_;
                                phi_9590_ = _e3505;
                                phi_9591_ = _e1390;
                                phi_9592_ = _e3515;
                                phi_9593_ = false;
                                phi_9594_ = _e3517;
                                phi_9595_ = _e3519;
                            } else {
                                phi_9590_ = f32();
                                phi_9591_ = type_37();
                                phi_9592_ = false;
                                phi_9593_ = true;
                                phi_9594_ = false;
                                phi_9595_ = false;
                            }
                            let _e3521 = phi_9590_;
                            let _e3523 = phi_9591_;
                            let _e3525 = phi_9592_;
                            let _e3527 = phi_9593_;
                            let _e3529 = phi_9594_;
                            let _e3531 = phi_9595_;
                            local_21 = _e3527;
                            local_43 = _e3529;
                            local_44 = _e3531;
                            local_22 = _e3521;
                            local_23 = _e3523;
                            continue;
                            continuing {
                                phi_5437_ = _e1120;
                                break if !(_e3525);
                            }
                        }
                        let _e3534 = local_21;
                        if _e3534 {
                            phi_9600_ = type_28(0u, type_28().member_1);
                            phi_9601_ = false;
                            phi_9602_ = false;
                        } else {
                            phi_9600_ = type_28();
                            let _e6402 = local_43;
                            phi_9601_ = _e6402;
                            let _e6405 = local_44;
                            phi_9602_ = _e6405;
                        }
                        let _e3538 = phi_9600_;
                        let _e3540 = phi_9601_;
                        let _e3542 = phi_9602_;
                        if _e3540 {
                            let _e3544 = local_22;
                            phi_9607_ = type_28(2u, _e3544);
                            phi_9608_ = false;
                        } else {
                            phi_9607_ = type_28();
                            phi_9608_ = _e3542;
                        }
                        let _e3547 = phi_9607_;
                        let _e3549 = phi_9608_;
                        if _e3549 {
                            let _e3551 = local_23;
                            phi_9614_ = type_28(1u, _e3551.member);
                            phi_9615_ = true;
                        } else {
                            phi_9614_ = _e3547;
                            phi_9615_ = _e3540;
                        }
                        let _e3555 = phi_9614_;
                        let _e3557 = phi_9615_;
                        if _e3557 {
                            phi_9619_ = _e3555;
                        } else {
                            phi_9619_ = _e3538;
                        }
                        let _e3559 = phi_9619_;
                        phi_9623_ = _e3559;
                    }
                    let _e5676 = phi_9623_;
                    phi_9624_ = _e5676;
                }
                let _e5680 = phi_9624_;
                switch bitcast<i32>(_e5680.member) {
                    case 0: {
                        phi_9637_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5686 = function_2(_e5680.member_1);
                        phi_9637_ = type_38(0u, _e5686, true);
                        break;
                    }
                    case 2: {
                        let _e5684 = function_2(_e5680.member_1);
                        phi_9637_ = type_38(1u, _e5684, true);
                        break;
                    }
                    default: {
                        phi_9637_ = type_38();
                        break;
                    }
                }
                let _e5689 = phi_9637_;
                if _e5689.member_2 {
                    phi_9644_ = (_e5689.member == 0u);
                } else {
                    phi_9644_ = false;
                }
                let _e5694 = phi_9644_;
                if _e5694 {
                    let _e5702 = (_e5689.member_1[1] >> bitcast<u32>(20i));
                    if (_e5702 <= 896u) {
                        phi_9668_ = 0u;
                    } else {
                        phi_9668_ = ((((_e5702 - 896u) << bitcast<u32>(23i)) | ((_e5689.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5689.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5717 = phi_9668_;
                    let _e5719 = atomicMin((&earliest.member[0u]), _e5717);
                }
                phi_9672_ = type_20(0u, 0u, _e176, _e179, _e5689.member_1);
                phi_9673_ = _e5694;
                phi_9674_ = (_e5689.member != 0u);
            } else {
                phi_9672_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_9673_ = false;
                phi_9674_ = false;
            }
            let _e5721 = phi_9672_;
            let _e5723 = phi_9673_;
            let _e5725 = phi_9674_;
            let _e5728 = params.member.member.member_1;
            if ((_e5728 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5723 {
                    let _e5734 = atomicAdd((&counters[0u]), 1u);
                    phi_9693_ = _e5734;
                } else {
                    phi_9693_ = 0u;
                }
                let _e5736 = phi_9693_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5739 = atomicLoad((&counters[0u]));
                    if (_e5739 > 0u) {
                        let _e5742 = atomicAdd((&contacts.member[0u]), _e5739);
                        atomicStore((&counters[1u]), _e5742);
                    }
                }
                workgroupBarrier();
                let _e5745 = atomicLoad((&counters[1u]));
                let _e5746 = (_e5745 + _e5736);
                if _e5723 {
                    let _e5749 = params.member.member_1.member_3;
                    if (_e5746 < _e5749) {
                        let _e5751 = (6u * _e5746);
                        atomicStore((&contacts.member[(4u + _e5751)]), _e5721.member);
                        atomicStore((&contacts.member[(_e5751 + 5u)]), _e5721.member_1);
                        atomicStore((&contacts.member[(_e5751 + 6u)]), _e5721.member_2);
                        atomicStore((&contacts.member[(_e5751 + 7u)]), _e5721.member_3);
                        atomicStore((&contacts.member[(_e5751 + 8u)]), _e5721.member_4[0]);
                        atomicStore((&contacts.member[(_e5751 + 9u)]), _e5721.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5725 {
                let _e5775 = atomicAdd((&counters[0u]), 1u);
                phi_9756_ = _e5775;
            } else {
                phi_9756_ = 0u;
            }
            let _e5777 = phi_9756_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5780 = atomicLoad((&counters[0u]));
                if (_e5780 > 0u) {
                    let _e5783 = atomicAdd((&undecided.member[0u]), _e5780);
                    atomicStore((&counters[1u]), _e5783);
                }
            }
            workgroupBarrier();
            let _e5786 = atomicLoad((&counters[1u]));
            let _e5787 = (_e5786 + _e5777);
            if _e5725 {
                let _e5790 = params.member.member_2.member;
                if (_e5787 < _e5790) {
                    let _e5794 = (2u * _e5787);
                    atomicStore((&undecided.member[(4u + _e5794)]), _e5721.member_2);
                    atomicStore((&undecided.member[(_e5794 + 5u)]), _e5721.member_3);
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
