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
    member: u32,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_28 {
    member: array<array<u32, 3>>,
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
var<storage> params: type_26;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_49;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_49;
@group(0) @binding(3) 
var<storage> elements: type_28;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_744_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_744_ = param_2;
    } else {
        phi_744_ = param_1;
    }
    let _e26 = phi_744_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_297_: bool;
    var phi_316_: bool;
    var phi_346_: array<f64, 3>;
    var phi_347_: bool;
    var phi_348_: array<f64, 3>;
    var phi_349_: bool;
    var phi_595_: f64;
    var phi_597_: f64;
    var phi_639_: f64;
    var phi_641_: f64;
    var phi_689_: f64;
    var phi_691_: f64;
    var phi_400_: f64;
    var phi_402_: f64;
    var phi_450_: f64;
    var phi_452_: f64;
    var phi_497_: f64;
    var phi_499_: f64;
    var phi_550_: f64;
    var phi_552_: f64;
    var phi_706_: array<array<f64, 3>, 4>;
    var phi_714_: array<f64, 3>;

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
                    phi_288_ = (_e78 <= _e70);
                    phi_289_ = false;
                } else {
                    phi_288_ = bool();
                    phi_289_ = true;
                }
                let _e99 = phi_288_;
                let _e101 = phi_289_;
                phi_290_ = _e99;
                phi_291_ = _e101;
            } else {
                phi_290_ = bool();
                phi_291_ = true;
            }
            let _e103 = phi_290_;
            let _e105 = phi_291_;
            phi_292_ = _e103;
            phi_293_ = _e105;
        } else {
            phi_292_ = bool();
            phi_293_ = true;
        }
        let _e107 = phi_292_;
        let _e109 = phi_293_;
        if _e109 {
            phi_297_ = false;
        } else {
            phi_297_ = _e107;
        }
        let _e111 = phi_297_;
        phi_316_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_308_ = ((_e74 + _e78) <= _e70);
                phi_309_ = false;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e85 = phi_308_;
            let _e87 = phi_309_;
            phi_310_ = _e85;
            phi_311_ = _e87;
        } else {
            phi_310_ = bool();
            phi_311_ = true;
        }
        let _e89 = phi_310_;
        let _e91 = phi_311_;
        if _e91 {
            phi_315_ = false;
        } else {
            phi_315_ = _e89;
        }
        let _e93 = phi_315_;
        phi_316_ = _e93;
    }
    let _e113 = phi_316_;
    if (_e68 > _e69) {
        if _e113 {
            phi_346_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_347_ = false;
        } else {
            phi_346_ = array<f64, 3>();
            phi_347_ = true;
        }
        let _e138 = phi_346_;
        let _e140 = phi_347_;
        phi_348_ = _e138;
        phi_349_ = _e140;
    } else {
        phi_348_ = array<f64, 3>();
        phi_349_ = true;
    }
    let _e142 = phi_348_;
    let _e144 = phi_349_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_400_ = _e307;
                } else {
                    phi_400_ = f64(1f);
                }
                let _e315 = phi_400_;
                phi_402_ = _e315;
            } else {
                phi_402_ = f64(0f);
            }
            let _e317 = phi_402_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_450_ = _e353;
                } else {
                    phi_450_ = f64(1f);
                }
                let _e361 = phi_450_;
                phi_452_ = _e361;
            } else {
                phi_452_ = f64(0f);
            }
            let _e363 = phi_452_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_497_ = _e396;
                } else {
                    phi_497_ = f64(1f);
                }
                let _e404 = phi_497_;
                phi_499_ = _e404;
            } else {
                phi_499_ = f64(0f);
            }
            let _e406 = phi_499_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_550_ = _e445;
                } else {
                    phi_550_ = f64(1f);
                }
                let _e453 = phi_550_;
                phi_552_ = _e453;
            } else {
                phi_552_ = f64(0f);
            }
            let _e455 = phi_552_;
            phi_706_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_595_ = _e174;
                } else {
                    phi_595_ = f64(1f);
                }
                let _e182 = phi_595_;
                phi_597_ = _e182;
            } else {
                phi_597_ = f64(0f);
            }
            let _e184 = phi_597_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_639_ = _e214;
                } else {
                    phi_639_ = f64(1f);
                }
                let _e222 = phi_639_;
                phi_641_ = _e222;
            } else {
                phi_641_ = f64(0f);
            }
            let _e224 = phi_641_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_689_ = _e260;
                } else {
                    phi_689_ = f64(1f);
                }
                let _e268 = phi_689_;
                phi_691_ = _e268;
            } else {
                phi_691_ = f64(0f);
            }
            let _e270 = phi_691_;
            phi_706_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_706_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_714_ = _e475;
    } else {
        phi_714_ = _e142;
    }
    let _e477 = phi_714_;
    return _e477;
}

fn function_3(param_7: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_7);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
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
    var phi_805_: u32;
    var phi_821_: u32;
    var phi_842_: u32;
    var phi_843_: u32;
    var phi_846_: type_9;
    var phi_847_: type_9;
    var phi_870_: type_9;
    var phi_1117_: type_42;
    var phi_1211_: f64;
    var phi_1217_: f64;
    var phi_1222_: f64;
    var phi_1228_: f64;
    var phi_1233_: f64;
    var phi_1239_: f64;
    var phi_1245_: f64;
    var phi_1250_: f64;
    var phi_1256_: f64;
    var phi_1261_: f64;
    var phi_1266_: f64;
    var phi_1273_: f64;
    var phi_1279_: f64;
    var phi_1284_: f64;
    var phi_1290_: f64;
    var phi_1295_: f64;
    var phi_1301_: f64;
    var phi_1307_: f64;
    var phi_1312_: f64;
    var phi_1318_: f64;
    var phi_1323_: f64;
    var phi_1328_: f64;
    var phi_1335_: f64;
    var phi_1341_: f64;
    var phi_1346_: f64;
    var phi_1352_: f64;
    var phi_1357_: f64;
    var phi_1363_: f64;
    var phi_1369_: f64;
    var phi_1374_: f64;
    var phi_1380_: f64;
    var phi_1385_: f64;
    var phi_1390_: f64;
    var phi_1396_: f64;
    var phi_1401_: f64;
    var phi_1410_: bool;
    var phi_1434_: u64;
    var phi_1446_: f64;
    var phi_1447_: f64;
    var phi_1478_: type_43;
    var phi_1479_: bool;
    var phi_1480_: type_43;
    var phi_1481_: bool;
    var phi_1482_: type_43;
    var phi_1483_: bool;
    var phi_1488_: type_43;
    var phi_1770_: f64;
    var phi_1777_: f64;
    var phi_1782_: f64;
    var phi_1789_: f64;
    var phi_1794_: f64;
    var phi_1807_: f64;
    var phi_1814_: f64;
    var phi_1819_: f64;
    var phi_1826_: f64;
    var phi_1831_: f64;
    var phi_1836_: f64;
    var phi_1853_: f64;
    var phi_1860_: f64;
    var phi_1865_: f64;
    var phi_1872_: f64;
    var phi_1877_: f64;
    var phi_1891_: f64;
    var phi_1898_: f64;
    var phi_1903_: f64;
    var phi_1910_: f64;
    var phi_1915_: f64;
    var phi_1920_: f64;
    var phi_1937_: f64;
    var phi_1944_: f64;
    var phi_1949_: f64;
    var phi_1956_: f64;
    var phi_1961_: f64;
    var phi_1975_: f64;
    var phi_1982_: f64;
    var phi_1987_: f64;
    var phi_1994_: f64;
    var phi_1999_: f64;
    var phi_2004_: f64;
    var phi_2041_: f64;
    var phi_2047_: f64;
    var phi_2054_: f64;
    var phi_2061_: f64;
    var phi_2067_: f64;
    var phi_2074_: f64;
    var phi_2080_: f64;
    var phi_2086_: f64;
    var phi_2092_: f64;
    var phi_2099_: f64;
    var phi_2106_: f64;
    var phi_2134_: f64;
    var phi_2139_: f64;
    var phi_2144_: f64;
    var phi_2149_: f64;
    var phi_2154_: f64;
    var phi_2159_: f64;
    var phi_2170_: f64;
    var phi_4910_: f64;
    var phi_4916_: f64;
    var phi_4921_: f64;
    var phi_4927_: f64;
    var phi_4933_: f64;
    var phi_4938_: f64;
    var phi_4943_: f64;
    var phi_4953_: bool;
    var phi_4960_: f64;
    var phi_4968_: f64;
    var phi_5011_: type_16;
    var phi_5014_: f64;
    var phi_5035_: bool;
    var phi_5041_: type_17;
    var phi_5012_: type_16;
    var phi_5055_: type_17;
    var phi_5015_: f64;
    var local_13: f64;
    var phi_5004_: f64;
    var phi_5068_: f64;
    var phi_5074_: f64;
    var phi_5099_: type_9;
    var phi_5102_: u32;
    var phi_5100_: type_9;
    var phi_5125_: type_9;
    var phi_5169_: u32;
    var phi_5170_: u32;
    var phi_5103_: u32;
    var phi_5171_: u32;
    var phi_5191_: type_9;
    var phi_5192_: type_9;
    var phi_5215_: type_9;
    var phi_5269_: f64;
    var phi_5276_: f64;
    var phi_5288_: bool;
    var phi_5289_: bool;
    var phi_5290_: bool;
    var phi_5291_: bool;
    var phi_5295_: bool;
    var phi_5307_: type_45;
    var phi_5308_: type_45;
    var phi_5309_: bool;
    var phi_5310_: type_45;
    var phi_5311_: bool;
    var phi_5324_: f64;
    var phi_5337_: type_9;
    var phi_5340_: f64;
    var phi_5342_: f64;
    var phi_5344_: f64;
    var phi_5338_: type_9;
    var phi_5367_: type_9;
    var phi_5394_: f64;
    var phi_5395_: f64;
    var phi_5423_: f64;
    var phi_5439_: f64;
    var phi_5446_: bool;
    var phi_5447_: bool;
    var phi_5448_: bool;
    var phi_5454_: f64;
    var phi_5455_: f64;
    var phi_5456_: bool;
    var phi_5341_: f64;
    var phi_5343_: f64;
    var phi_5345_: f64;
    var phi_5457_: f64;
    var phi_5458_: bool;
    var phi_5459_: bool;
    var local_14: bool;
    var phi_5463_: f64;
    var phi_5464_: f64;
    var phi_5474_: f64;
    var phi_5479_: type_9;
    var phi_5482_: f64;
    var phi_5480_: type_9;
    var phi_5505_: type_9;
    var phi_5536_: f64;
    var phi_5537_: bool;
    var phi_5538_: f64;
    var phi_5539_: bool;
    var phi_5540_: bool;
    var phi_5541_: bool;
    var phi_5542_: f64;
    var phi_5483_: f64;
    var phi_5543_: bool;
    var phi_5544_: bool;
    var phi_5545_: bool;
    var phi_5546_: bool;
    var local_15: bool;
    var phi_5550_: bool;
    var phi_5551_: bool;
    var phi_5555_: bool;
    var phi_5559_: f64;
    var phi_5560_: f64;
    var phi_5562_: type_45;
    var phi_5593_: f64;
    var phi_5600_: f64;
    var phi_5605_: f64;
    var phi_5612_: f64;
    var phi_5617_: f64;
    var phi_5630_: f64;
    var phi_5637_: f64;
    var phi_5642_: f64;
    var phi_5649_: f64;
    var phi_5654_: f64;
    var phi_5659_: f64;
    var phi_5718_: f64;
    var phi_5724_: f64;
    var phi_5729_: f64;
    var phi_5735_: f64;
    var phi_5740_: f64;
    var phi_5754_: f64;
    var phi_5760_: f64;
    var phi_5765_: f64;
    var phi_5771_: f64;
    var phi_5776_: f64;
    var phi_5802_: f64;
    var phi_5809_: f64;
    var phi_5814_: f64;
    var phi_5821_: f64;
    var phi_5826_: f64;
    var phi_5839_: f64;
    var phi_5846_: f64;
    var phi_5851_: f64;
    var phi_5858_: f64;
    var phi_5863_: f64;
    var phi_5868_: f64;
    var phi_5927_: f64;
    var phi_5933_: f64;
    var phi_5938_: f64;
    var phi_5944_: f64;
    var phi_5949_: f64;
    var phi_5963_: f64;
    var phi_5969_: f64;
    var phi_5974_: f64;
    var phi_5980_: f64;
    var phi_5985_: f64;
    var phi_6011_: f64;
    var phi_6018_: f64;
    var phi_6023_: f64;
    var phi_6030_: f64;
    var phi_6035_: f64;
    var phi_6048_: f64;
    var phi_6055_: f64;
    var phi_6060_: f64;
    var phi_6067_: f64;
    var phi_6072_: f64;
    var phi_6077_: f64;
    var phi_6136_: f64;
    var phi_6142_: f64;
    var phi_6147_: f64;
    var phi_6153_: f64;
    var phi_6158_: f64;
    var phi_6172_: f64;
    var phi_6178_: f64;
    var phi_6183_: f64;
    var phi_6189_: f64;
    var phi_6194_: f64;
    var phi_6243_: f64;
    var phi_6249_: f64;
    var phi_6277_: f64;
    var phi_6283_: f64;
    var phi_6288_: u32;
    var phi_6289_: u32;
    var phi_6259_: f64;
    var phi_6265_: f64;
    var phi_6270_: u32;
    var phi_6271_: u32;
    var phi_6290_: u32;
    var phi_6291_: u32;
    var phi_6364_: f64;
    var phi_6376_: f64;
    var phi_6519_: f64;
    var phi_6525_: f64;
    var phi_6532_: f64;
    var phi_6588_: type_9;
    var phi_6591_: bool;
    var phi_6589_: type_9;
    var phi_6614_: type_9;
    var phi_6641_: bool;
    var phi_6642_: bool;
    var phi_6592_: bool;
    var phi_6643_: bool;
    var phi_6644_: bool;
    var local_16: bool;
    var phi_6648_: bool;
    var local_17: bool;
    var phi_6655_: u32;
    var phi_6656_: u32;
    var phi_6657_: bool;
    var phi_6658_: u32;
    var phi_6659_: u32;
    var phi_6660_: bool;
    var phi_6664_: u32;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6836_: f64;
    var phi_6843_: f64;
    var phi_6848_: f64;
    var phi_6855_: f64;
    var phi_6860_: f64;
    var phi_6873_: f64;
    var phi_6880_: f64;
    var phi_6885_: f64;
    var phi_6892_: f64;
    var phi_6897_: f64;
    var phi_6902_: f64;
    var phi_6919_: f64;
    var phi_6926_: f64;
    var phi_6931_: f64;
    var phi_6938_: f64;
    var phi_6943_: f64;
    var phi_6957_: f64;
    var phi_6964_: f64;
    var phi_6969_: f64;
    var phi_6976_: f64;
    var phi_6981_: f64;
    var phi_6986_: f64;
    var phi_7003_: f64;
    var phi_7010_: f64;
    var phi_7015_: f64;
    var phi_7022_: f64;
    var phi_7027_: f64;
    var phi_7041_: f64;
    var phi_7048_: f64;
    var phi_7053_: f64;
    var phi_7060_: f64;
    var phi_7065_: f64;
    var phi_7070_: f64;
    var phi_7114_: type_9;
    var phi_7117_: f64;
    var phi_7119_: f64;
    var phi_7121_: f64;
    var phi_7123_: bool;
    var phi_7125_: u32;
    var phi_7115_: type_9;
    var phi_7148_: type_9;
    var phi_7263_: f64;
    var phi_7269_: f64;
    var phi_7275_: f64;
    var phi_7277_: array<f64, 3>;
    var phi_7284_: f64;
    var phi_7291_: f64;
    var phi_7299_: f64;
    var phi_7345_: type_16;
    var phi_7348_: f64;
    var phi_7369_: bool;
    var phi_7375_: type_17;
    var phi_7346_: type_16;
    var phi_7389_: type_17;
    var phi_7349_: f64;
    var local_18: f64;
    var phi_7338_: f64;
    var phi_7402_: f64;
    var phi_7471_: f64;
    var phi_7477_: f64;
    var phi_7486_: f64;
    var phi_7492_: f64;
    var phi_7501_: f64;
    var phi_7507_: f64;
    var phi_7516_: f64;
    var phi_7522_: f64;
    var phi_7528_: type_34;
    var phi_7529_: bool;
    var phi_7530_: type_34;
    var phi_7531_: bool;
    var phi_7541_: type_34;
    var phi_7713_: bool;
    var phi_7714_: bool;
    var phi_7715_: bool;
    var phi_7716_: bool;
    var phi_7717_: bool;
    var phi_7718_: bool;
    var phi_7722_: bool;
    var phi_8020_: bool;
    var phi_8021_: bool;
    var phi_8022_: bool;
    var phi_8023_: bool;
    var phi_8024_: bool;
    var phi_8025_: bool;
    var phi_8029_: bool;
    var phi_8033_: bool;
    var phi_8044_: bool;
    var phi_8045_: bool;
    var phi_8119_: bool;
    var phi_8120_: bool;
    var phi_8143_: f64;
    var phi_8144_: bool;
    var phi_8145_: f64;
    var phi_8146_: bool;
    var phi_8147_: f64;
    var phi_8148_: bool;
    var phi_8149_: bool;
    var phi_8154_: f64;
    var phi_8155_: bool;
    var phi_8159_: f64;
    var phi_8191_: bool;
    var phi_8192_: bool;
    var phi_8215_: f64;
    var phi_8216_: bool;
    var phi_8217_: f64;
    var phi_8218_: bool;
    var phi_8219_: f64;
    var phi_8220_: bool;
    var phi_8221_: bool;
    var phi_8226_: f64;
    var phi_8227_: bool;
    var phi_8231_: f64;
    var phi_8236_: f64;
    var phi_8268_: bool;
    var phi_8269_: bool;
    var phi_8292_: f64;
    var phi_8293_: bool;
    var phi_8294_: f64;
    var phi_8295_: bool;
    var phi_8296_: f64;
    var phi_8297_: bool;
    var phi_8298_: bool;
    var phi_8303_: f64;
    var phi_8304_: bool;
    var phi_8308_: f64;
    var phi_8340_: bool;
    var phi_8341_: bool;
    var phi_8364_: f64;
    var phi_8365_: bool;
    var phi_8366_: f64;
    var phi_8367_: bool;
    var phi_8368_: f64;
    var phi_8369_: bool;
    var phi_8370_: bool;
    var phi_8375_: f64;
    var phi_8376_: bool;
    var phi_8380_: f64;
    var phi_8385_: f64;
    var phi_8390_: f64;
    var phi_8395_: f64;
    var phi_8405_: f64;
    var phi_8406_: f64;
    var phi_8407_: bool;
    var phi_8408_: f64;
    var phi_8409_: f64;
    var phi_8410_: bool;
    var phi_8411_: bool;
    var phi_8412_: bool;
    var phi_8413_: f64;
    var phi_8414_: f64;
    var phi_8415_: bool;
    var phi_8416_: bool;
    var phi_8417_: bool;
    var phi_8418_: bool;
    var phi_8419_: f64;
    var phi_8420_: f64;
    var phi_8421_: bool;
    var phi_8422_: bool;
    var phi_8423_: bool;
    var phi_8424_: bool;
    var phi_8510_: f64;
    var phi_8583_: f64;
    var phi_8588_: f64;
    var phi_8661_: f64;
    var phi_8734_: f64;
    var phi_8739_: f64;
    var phi_8760_: f64;
    var phi_8761_: f64;
    var phi_8762_: f64;
    var phi_8437_: bool;
    var phi_8764_: u32;
    var phi_8765_: f64;
    var phi_8766_: bool;
    var phi_8767_: bool;
    var phi_8768_: bool;
    var phi_8769_: u32;
    var phi_8770_: f64;
    var phi_8771_: f64;
    var phi_8772_: f64;
    var phi_8773_: bool;
    var phi_8774_: u32;
    var phi_8775_: bool;
    var phi_8776_: bool;
    var phi_8777_: bool;
    var phi_8778_: bool;
    var phi_8779_: bool;
    var phi_8788_: f64;
    var phi_8793_: f64;
    var phi_8803_: bool;
    var phi_8807_: bool;
    var phi_8808_: f64;
    var phi_8809_: f64;
    var phi_8810_: f64;
    var phi_8811_: bool;
    var phi_8812_: u32;
    var phi_8813_: bool;
    var phi_8814_: bool;
    var phi_8815_: bool;
    var phi_8816_: bool;
    var phi_8817_: bool;
    var phi_7118_: f64;
    var phi_7120_: f64;
    var phi_7122_: f64;
    var phi_7124_: bool;
    var phi_7126_: u32;
    var phi_8818_: f64;
    var phi_8819_: bool;
    var phi_8820_: bool;
    var phi_8821_: bool;
    var phi_8822_: bool;
    var phi_8823_: bool;
    var phi_8824_: bool;
    var local_19: bool;
    var phi_8828_: f64;
    var phi_8829_: bool;
    var phi_8830_: bool;
    var phi_8831_: bool;
    var phi_8832_: bool;
    var phi_8837_: type_44;
    var phi_8838_: bool;
    var phi_8839_: bool;
    var phi_8840_: bool;
    var local_20: f64;
    var phi_8845_: type_44;
    var phi_8846_: bool;
    var phi_8847_: bool;
    var phi_8852_: type_44;
    var phi_8853_: bool;
    var phi_8854_: bool;
    var phi_8859_: type_44;
    var phi_8860_: bool;
    var phi_8864_: type_44;
    var phi_8871_: bool;
    var phi_8872_: f64;
    var phi_8873_: bool;
    var phi_8874_: bool;
    var phi_8875_: bool;
    var phi_8876_: f64;
    var phi_8877_: bool;
    var phi_8878_: bool;
    var phi_8879_: bool;
    var phi_8880_: f64;
    var phi_8881_: bool;
    var phi_8882_: bool;
    var phi_8883_: bool;
    var phi_8884_: bool;
    var phi_8888_: bool;
    var phi_8889_: bool;
    var phi_8890_: bool;
    var phi_8891_: f64;
    var phi_8892_: type_45;
    var phi_8893_: bool;
    var phi_8894_: bool;
    var phi_8895_: bool;
    var phi_8896_: bool;
    var local_21: bool;
    var phi_8901_: type_44;
    var phi_8902_: bool;
    var phi_8903_: bool;
    var local_22: f64;
    var phi_8908_: type_44;
    var phi_8909_: bool;
    var local_23: type_45;
    var phi_8915_: type_44;
    var phi_8916_: bool;
    var phi_8920_: type_44;
    var phi_2327_: f64;
    var phi_2334_: f64;
    var phi_2339_: f64;
    var phi_2346_: f64;
    var phi_2351_: f64;
    var phi_2364_: f64;
    var phi_2371_: f64;
    var phi_2376_: f64;
    var phi_2383_: f64;
    var phi_2388_: f64;
    var phi_2393_: f64;
    var phi_2410_: f64;
    var phi_2417_: f64;
    var phi_2422_: f64;
    var phi_2429_: f64;
    var phi_2434_: f64;
    var phi_2448_: f64;
    var phi_2455_: f64;
    var phi_2460_: f64;
    var phi_2467_: f64;
    var phi_2472_: f64;
    var phi_2477_: f64;
    var phi_2494_: f64;
    var phi_2501_: f64;
    var phi_2506_: f64;
    var phi_2513_: f64;
    var phi_2518_: f64;
    var phi_2532_: f64;
    var phi_2539_: f64;
    var phi_2544_: f64;
    var phi_2551_: f64;
    var phi_2556_: f64;
    var phi_2561_: f64;
    var phi_2605_: type_9;
    var phi_2608_: f64;
    var phi_2610_: f64;
    var phi_2612_: f64;
    var phi_2614_: bool;
    var phi_2616_: u32;
    var phi_2606_: type_9;
    var phi_2639_: type_9;
    var phi_2754_: f64;
    var phi_2760_: f64;
    var phi_2766_: f64;
    var phi_2768_: array<f64, 3>;
    var phi_2775_: f64;
    var phi_2782_: f64;
    var phi_2790_: f64;
    var phi_2836_: type_16;
    var phi_2839_: f64;
    var phi_2860_: bool;
    var phi_2866_: type_17;
    var phi_2837_: type_16;
    var phi_2880_: type_17;
    var phi_2840_: f64;
    var local_24: f64;
    var phi_2829_: f64;
    var phi_2893_: f64;
    var phi_2962_: f64;
    var phi_2968_: f64;
    var phi_2977_: f64;
    var phi_2983_: f64;
    var phi_2992_: f64;
    var phi_2998_: f64;
    var phi_3007_: f64;
    var phi_3013_: f64;
    var phi_3019_: type_34;
    var phi_3020_: bool;
    var phi_3021_: type_34;
    var phi_3022_: bool;
    var phi_3032_: type_34;
    var phi_3204_: bool;
    var phi_3205_: bool;
    var phi_3206_: bool;
    var phi_3207_: bool;
    var phi_3208_: bool;
    var phi_3209_: bool;
    var phi_3213_: bool;
    var phi_3511_: bool;
    var phi_3512_: bool;
    var phi_3513_: bool;
    var phi_3514_: bool;
    var phi_3515_: bool;
    var phi_3516_: bool;
    var phi_3520_: bool;
    var phi_3524_: bool;
    var phi_3535_: bool;
    var phi_3536_: bool;
    var phi_3610_: bool;
    var phi_3611_: bool;
    var phi_3634_: f64;
    var phi_3635_: bool;
    var phi_3636_: f64;
    var phi_3637_: bool;
    var phi_3638_: f64;
    var phi_3639_: bool;
    var phi_3640_: bool;
    var phi_3645_: f64;
    var phi_3646_: bool;
    var phi_3650_: f64;
    var phi_3682_: bool;
    var phi_3683_: bool;
    var phi_3706_: f64;
    var phi_3707_: bool;
    var phi_3708_: f64;
    var phi_3709_: bool;
    var phi_3710_: f64;
    var phi_3711_: bool;
    var phi_3712_: bool;
    var phi_3717_: f64;
    var phi_3718_: bool;
    var phi_3722_: f64;
    var phi_3727_: f64;
    var phi_3759_: bool;
    var phi_3760_: bool;
    var phi_3783_: f64;
    var phi_3784_: bool;
    var phi_3785_: f64;
    var phi_3786_: bool;
    var phi_3787_: f64;
    var phi_3788_: bool;
    var phi_3789_: bool;
    var phi_3794_: f64;
    var phi_3795_: bool;
    var phi_3799_: f64;
    var phi_3831_: bool;
    var phi_3832_: bool;
    var phi_3855_: f64;
    var phi_3856_: bool;
    var phi_3857_: f64;
    var phi_3858_: bool;
    var phi_3859_: f64;
    var phi_3860_: bool;
    var phi_3861_: bool;
    var phi_3866_: f64;
    var phi_3867_: bool;
    var phi_3871_: f64;
    var phi_3876_: f64;
    var phi_3881_: f64;
    var phi_3886_: f64;
    var phi_3896_: f64;
    var phi_3897_: f64;
    var phi_3898_: bool;
    var phi_3899_: f64;
    var phi_3900_: f64;
    var phi_3901_: bool;
    var phi_3902_: bool;
    var phi_3903_: bool;
    var phi_3904_: f64;
    var phi_3905_: f64;
    var phi_3906_: bool;
    var phi_3907_: bool;
    var phi_3908_: bool;
    var phi_3909_: bool;
    var phi_3910_: f64;
    var phi_3911_: f64;
    var phi_3912_: bool;
    var phi_3913_: bool;
    var phi_3914_: bool;
    var phi_3915_: bool;
    var phi_4001_: f64;
    var phi_4074_: f64;
    var phi_4079_: f64;
    var phi_4152_: f64;
    var phi_4225_: f64;
    var phi_4230_: f64;
    var phi_4251_: f64;
    var phi_4252_: f64;
    var phi_4253_: f64;
    var phi_3928_: bool;
    var phi_4255_: u32;
    var phi_4256_: f64;
    var phi_4257_: bool;
    var phi_4258_: bool;
    var phi_4259_: bool;
    var phi_4260_: u32;
    var phi_4261_: f64;
    var phi_4262_: f64;
    var phi_4263_: f64;
    var phi_4264_: bool;
    var phi_4265_: u32;
    var phi_4266_: bool;
    var phi_4267_: bool;
    var phi_4268_: bool;
    var phi_4269_: bool;
    var phi_4270_: bool;
    var phi_4279_: f64;
    var phi_4284_: f64;
    var phi_4294_: bool;
    var phi_4298_: bool;
    var phi_4299_: f64;
    var phi_4300_: f64;
    var phi_4301_: f64;
    var phi_4302_: bool;
    var phi_4303_: u32;
    var phi_4304_: bool;
    var phi_4305_: bool;
    var phi_4306_: bool;
    var phi_4307_: bool;
    var phi_4308_: bool;
    var phi_2609_: f64;
    var phi_2611_: f64;
    var phi_2613_: f64;
    var phi_2615_: bool;
    var phi_2617_: u32;
    var phi_4309_: f64;
    var phi_4310_: bool;
    var phi_4311_: bool;
    var phi_4312_: bool;
    var phi_4313_: bool;
    var phi_4314_: bool;
    var phi_4315_: bool;
    var local_25: bool;
    var phi_4319_: f64;
    var phi_4320_: bool;
    var phi_4321_: bool;
    var phi_4322_: bool;
    var phi_4323_: bool;
    var phi_4328_: type_44;
    var phi_4329_: bool;
    var phi_4330_: bool;
    var phi_4331_: bool;
    var local_26: f64;
    var phi_4336_: type_44;
    var phi_4337_: bool;
    var phi_4338_: bool;
    var phi_4343_: type_44;
    var phi_4344_: bool;
    var phi_4345_: bool;
    var phi_4350_: type_44;
    var phi_4351_: bool;
    var phi_4355_: type_44;
    var phi_4369_: type_9;
    var phi_4370_: type_9;
    var phi_4393_: type_9;
    var phi_4414_: f64;
    var phi_4544_: type_16;
    var phi_4547_: f64;
    var phi_4568_: bool;
    var phi_4574_: type_17;
    var phi_4545_: type_16;
    var phi_4588_: type_17;
    var phi_4548_: f64;
    var local_27: f64;
    var phi_4537_: f64;
    var phi_4601_: f64;
    var phi_4619_: f64;
    var phi_4626_: f64;
    var phi_4631_: f64;
    var phi_4638_: f64;
    var phi_4643_: f64;
    var phi_4656_: f64;
    var phi_4663_: f64;
    var phi_4668_: f64;
    var phi_4675_: f64;
    var phi_4680_: f64;
    var phi_4685_: f64;
    var phi_4702_: f64;
    var phi_4709_: f64;
    var phi_4714_: f64;
    var phi_4721_: f64;
    var phi_4726_: f64;
    var phi_4740_: f64;
    var phi_4747_: f64;
    var phi_4752_: f64;
    var phi_4759_: f64;
    var phi_4764_: f64;
    var phi_4769_: f64;
    var phi_4786_: f64;
    var phi_4793_: f64;
    var phi_4798_: f64;
    var phi_4805_: f64;
    var phi_4810_: f64;
    var phi_4824_: f64;
    var phi_4831_: f64;
    var phi_4836_: f64;
    var phi_4843_: f64;
    var phi_4848_: f64;
    var phi_4853_: f64;
    var phi_4877_: bool;
    var phi_4878_: bool;
    var phi_4879_: bool;
    var local_28: bool;
    var phi_4884_: type_44;
    var phi_4885_: bool;
    var phi_4890_: type_44;
    var phi_4891_: bool;
    var phi_4893_: type_44;
    var phi_4894_: type_44;
    var phi_4895_: bool;
    var phi_4899_: type_44;
    var phi_8924_: type_44;
    var phi_8925_: type_44;
    var phi_8938_: type_32;
    var phi_8961_: u32;
    var phi_8965_: type_22;
    var phi_8966_: bool;
    var phi_8985_: u32;
    var local_29: u32;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: f64;
    var local_35: f64;
    var local_36: f64;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f64;
    var local_44: f64;
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
    let _e108 = id_2;
    let _e109 = n_2;
    let _e110 = lane_2;
    let _e122 = ((_e108.y * _e109.x) + _e108.x);
    let _e125 = (_e109.x * _e109.y);
    let _e128 = params.member.member_1.member_2;
    let _e130 = input.member[0u];
    if (_e128 < _e130) {
        phi_805_ = _e128;
    } else {
        phi_805_ = _e130;
    }
    let _e133 = phi_805_;
    let _e134 = (_e133 / 64u);
    if ((_e133 % 64u) > 0u) {
        phi_821_ = (_e134 + 1u);
    } else {
        phi_821_ = _e134;
    }
    let _e139 = phi_821_;
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
            phi_842_ = (_e143 + 1u);
        } else {
            phi_842_ = _e143;
        }
        let _e149 = phi_842_;
        phi_843_ = _e149;
    } else {
        phi_843_ = 0u;
    }
    let _e151 = phi_843_;
    phi_846_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_846_;
        if (_e154.member < _e154.member_1) {
            phi_847_ = type_9((_e154.member + 1u), _e154.member_1);
            phi_870_ = type_9(1u, _e154.member);
        } else {
            phi_847_ = _e154;
            phi_870_ = type_9(0u, type_9().member_1);
        }
        let _e166 = phi_847_;
        let _e168 = phi_870_;
        let _e172 = (bitcast<i32>(_e168.member) != 0i);
        if _e172 {
            let _e176 = (((_e122 + (_e168.member_1 * _e125)) * 64u) + _e110);
            if (_e176 < _e133) {
                let _e178 = (2u * _e176);
                let _e181 = input.member[(4u + _e178)];
                let _e184 = input.member[(_e178 + 5u)];
                let _e187 = elements.member[_e184];
                let _e192 = params.member.member.member_1;
                if ((_e192 & 8u) != 0u) {
                    let _e231 = paths.member[_e181];
                    let _e233 = paths.member[_e187[0]];
                    let _e239 = paths.member[_e187[1]];
                    let _e241 = paths.member[_e187[2]];
                    let _e278 = function_(array<f32, 3>(_e231.member[0], _e231.member[1], _e231.member[2]));
                    let _e279 = function_(array<f32, 3>(_e233.member[0], _e233.member[1], _e233.member[2]));
                    let _e280 = function_(array<f32, 3>(_e239.member[0], _e239.member[1], _e239.member[2]));
                    let _e281 = function_(array<f32, 3>(_e241.member[0], _e241.member[1], _e241.member[2]));
                    let _e283 = function_(array<f32, 3>(_e231.member_1[0], _e231.member_1[1], _e231.member_1[2]));
                    let _e284 = function_(array<f32, 3>(_e233.member_1[0], _e233.member_1[1], _e233.member_1[2]));
                    let _e285 = function_(array<f32, 3>(_e239.member_1[0], _e239.member_1[1], _e239.member_1[2]));
                    let _e286 = function_(array<f32, 3>(_e241.member_1[0], _e241.member_1[1], _e241.member_1[2]));
                    phi_1117_ = type_42(array<array<f64, 3>, 4>(_e278, _e279, _e280, _e281), array<array<f64, 3>, 4>(_e283, _e284, _e285, _e286));
                } else {
                    let _e196 = positions.member[_e181];
                    let _e199 = params.member.member.member[0u];
                    let _e202 = positions.member[(_e199 + _e181)];
                    let _e204 = positions.member[_e187[0]];
                    let _e207 = params.member.member.member[0u];
                    let _e210 = positions.member[(_e207 + _e187[0])];
                    let _e212 = positions.member[_e187[1]];
                    let _e215 = params.member.member.member[0u];
                    let _e218 = positions.member[(_e215 + _e187[1])];
                    let _e220 = positions.member[_e187[2]];
                    let _e223 = params.member.member.member[0u];
                    let _e226 = positions.member[(_e223 + _e187[2])];
                    phi_1117_ = type_42(array<array<f64, 3>, 4>(_e196, _e204, _e212, _e220), array<array<f64, 3>, 4>(_e202, _e210, _e218, _e226));
                }
                let _e290 = phi_1117_;
                let _e297 = (_e290.member[0][0] - _e290.member[1][0]);
                let _e300 = (_e290.member[0][1] - _e290.member[1][1]);
                let _e303 = (_e290.member[0][2] - _e290.member[1][2]);
                let _e309 = (_e290.member_1[0][0] - _e290.member_1[1][0]);
                let _e312 = (_e290.member_1[0][1] - _e290.member_1[1][1]);
                let _e315 = (_e290.member_1[0][2] - _e290.member_1[1][2]);
                let _e322 = (_e290.member[2][0] - _e290.member[1][0]);
                let _e325 = (_e290.member[2][1] - _e290.member[1][1]);
                let _e328 = (_e290.member[2][2] - _e290.member[1][2]);
                let _e334 = (_e290.member_1[2][0] - _e290.member_1[1][0]);
                let _e337 = (_e290.member_1[2][1] - _e290.member_1[1][1]);
                let _e340 = (_e290.member_1[2][2] - _e290.member_1[1][2]);
                let _e347 = (_e290.member[3][0] - _e290.member[1][0]);
                let _e350 = (_e290.member[3][1] - _e290.member[1][1]);
                let _e353 = (_e290.member[3][2] - _e290.member[1][2]);
                let _e359 = (_e290.member_1[3][0] - _e290.member_1[1][0]);
                let _e362 = (_e290.member_1[3][1] - _e290.member_1[1][1]);
                let _e365 = (_e290.member_1[3][2] - _e290.member_1[1][2]);
                let _e368 = (0.0lf + 0.0lf);
                let _e371 = params.member.member.member_7;
                let _e378 = bitcast<f64>(((u64(_e371[1]) * 4294967296lu) + u64(_e371[0])));
                if (_e297 < 0.0lf) {
                    phi_1211_ = -(_e297);
                } else {
                    phi_1211_ = _e297;
                }
                let _e382 = phi_1211_;
                if (_e300 < 0.0lf) {
                    phi_1217_ = -(_e300);
                } else {
                    phi_1217_ = _e300;
                }
                let _e386 = phi_1217_;
                if (_e382 > _e386) {
                    phi_1222_ = _e382;
                } else {
                    phi_1222_ = _e386;
                }
                let _e389 = phi_1222_;
                if (_e303 < 0.0lf) {
                    phi_1228_ = -(_e303);
                } else {
                    phi_1228_ = _e303;
                }
                let _e393 = phi_1228_;
                if (_e389 > _e393) {
                    phi_1233_ = _e389;
                } else {
                    phi_1233_ = _e393;
                }
                let _e396 = phi_1233_;
                if (_e309 < 0.0lf) {
                    phi_1239_ = -(_e309);
                } else {
                    phi_1239_ = _e309;
                }
                let _e400 = phi_1239_;
                if (_e312 < 0.0lf) {
                    phi_1245_ = -(_e312);
                } else {
                    phi_1245_ = _e312;
                }
                let _e404 = phi_1245_;
                if (_e400 > _e404) {
                    phi_1250_ = _e400;
                } else {
                    phi_1250_ = _e404;
                }
                let _e407 = phi_1250_;
                if (_e315 < 0.0lf) {
                    phi_1256_ = -(_e315);
                } else {
                    phi_1256_ = _e315;
                }
                let _e411 = phi_1256_;
                if (_e407 > _e411) {
                    phi_1261_ = _e407;
                } else {
                    phi_1261_ = _e411;
                }
                let _e414 = phi_1261_;
                if (_e396 > _e414) {
                    phi_1266_ = _e396;
                } else {
                    phi_1266_ = _e414;
                }
                let _e417 = phi_1266_;
                let _e418 = (_e417 + _e368);
                if (_e322 < 0.0lf) {
                    phi_1273_ = -(_e322);
                } else {
                    phi_1273_ = _e322;
                }
                let _e422 = phi_1273_;
                if (_e325 < 0.0lf) {
                    phi_1279_ = -(_e325);
                } else {
                    phi_1279_ = _e325;
                }
                let _e426 = phi_1279_;
                if (_e422 > _e426) {
                    phi_1284_ = _e422;
                } else {
                    phi_1284_ = _e426;
                }
                let _e429 = phi_1284_;
                if (_e328 < 0.0lf) {
                    phi_1290_ = -(_e328);
                } else {
                    phi_1290_ = _e328;
                }
                let _e433 = phi_1290_;
                if (_e429 > _e433) {
                    phi_1295_ = _e429;
                } else {
                    phi_1295_ = _e433;
                }
                let _e436 = phi_1295_;
                if (_e334 < 0.0lf) {
                    phi_1301_ = -(_e334);
                } else {
                    phi_1301_ = _e334;
                }
                let _e440 = phi_1301_;
                if (_e337 < 0.0lf) {
                    phi_1307_ = -(_e337);
                } else {
                    phi_1307_ = _e337;
                }
                let _e444 = phi_1307_;
                if (_e440 > _e444) {
                    phi_1312_ = _e440;
                } else {
                    phi_1312_ = _e444;
                }
                let _e447 = phi_1312_;
                if (_e340 < 0.0lf) {
                    phi_1318_ = -(_e340);
                } else {
                    phi_1318_ = _e340;
                }
                let _e451 = phi_1318_;
                if (_e447 > _e451) {
                    phi_1323_ = _e447;
                } else {
                    phi_1323_ = _e451;
                }
                let _e454 = phi_1323_;
                if (_e436 > _e454) {
                    phi_1328_ = _e436;
                } else {
                    phi_1328_ = _e454;
                }
                let _e457 = phi_1328_;
                let _e458 = (_e457 + _e368);
                if (_e347 < 0.0lf) {
                    phi_1335_ = -(_e347);
                } else {
                    phi_1335_ = _e347;
                }
                let _e462 = phi_1335_;
                if (_e350 < 0.0lf) {
                    phi_1341_ = -(_e350);
                } else {
                    phi_1341_ = _e350;
                }
                let _e466 = phi_1341_;
                if (_e462 > _e466) {
                    phi_1346_ = _e462;
                } else {
                    phi_1346_ = _e466;
                }
                let _e469 = phi_1346_;
                if (_e353 < 0.0lf) {
                    phi_1352_ = -(_e353);
                } else {
                    phi_1352_ = _e353;
                }
                let _e473 = phi_1352_;
                if (_e469 > _e473) {
                    phi_1357_ = _e469;
                } else {
                    phi_1357_ = _e473;
                }
                let _e476 = phi_1357_;
                if (_e359 < 0.0lf) {
                    phi_1363_ = -(_e359);
                } else {
                    phi_1363_ = _e359;
                }
                let _e480 = phi_1363_;
                if (_e362 < 0.0lf) {
                    phi_1369_ = -(_e362);
                } else {
                    phi_1369_ = _e362;
                }
                let _e484 = phi_1369_;
                if (_e480 > _e484) {
                    phi_1374_ = _e480;
                } else {
                    phi_1374_ = _e484;
                }
                let _e487 = phi_1374_;
                if (_e365 < 0.0lf) {
                    phi_1380_ = -(_e365);
                } else {
                    phi_1380_ = _e365;
                }
                let _e491 = phi_1380_;
                if (_e487 > _e491) {
                    phi_1385_ = _e487;
                } else {
                    phi_1385_ = _e491;
                }
                let _e494 = phi_1385_;
                if (_e476 > _e494) {
                    phi_1390_ = _e476;
                } else {
                    phi_1390_ = _e494;
                }
                let _e497 = phi_1390_;
                let _e498 = (_e497 + _e368);
                if (_e418 > _e458) {
                    phi_1396_ = _e418;
                } else {
                    phi_1396_ = _e458;
                }
                let _e501 = phi_1396_;
                if (_e501 > _e498) {
                    phi_1401_ = _e501;
                } else {
                    phi_1401_ = _e498;
                }
                let _e504 = phi_1401_;
                if (_e504 <= f64(65536f)) {
                    phi_1410_ = (_e504 >= f64((1f / 65536f)));
                } else {
                    phi_1410_ = false;
                }
                let _e511 = phi_1410_;
                if _e511 {
                    phi_1482_ = type_43();
                    phi_1483_ = true;
                } else {
                    if (_e504 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e504) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e518 = (9214364837600034816lu - (bitcast<u64>(_e504) & 9218868437227405312lu));
                            if (_e518 > 4503599627370496lu) {
                                phi_1434_ = _e518;
                            } else {
                                phi_1434_ = 4503599627370496lu;
                            }
                            let _e521 = phi_1434_;
                            let _e522 = bitcast<f64>(_e521);
                            let _e523 = (_e378 * _e522);
                            if (_e378 > f64(0f)) {
                                if (_e523 > 2.2250738585072014e-308lf) {
                                    phi_1446_ = _e523;
                                } else {
                                    phi_1446_ = 2.2250738585072014e-308lf;
                                }
                                let _e528 = phi_1446_;
                                phi_1447_ = _e528;
                            } else {
                                phi_1447_ = _e523;
                            }
                            let _e530 = phi_1447_;
                            phi_1478_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e297 * _e522), (_e300 * _e522), (_e303 * _e522)), array<f64, 3>((_e309 * _e522), (_e312 * _e522), (_e315 * _e522))), array<array<f64, 3>, 2>(array<f64, 3>((_e322 * _e522), (_e325 * _e522), (_e328 * _e522)), array<f64, 3>((_e334 * _e522), (_e337 * _e522), (_e340 * _e522))), array<array<f64, 3>, 2>(array<f64, 3>((_e347 * _e522), (_e350 * _e522), (_e353 * _e522)), array<f64, 3>((_e359 * _e522), (_e362 * _e522), (_e365 * _e522))), (_e368 * _e522)), _e530);
                            phi_1479_ = false;
                        } else {
                            phi_1478_ = type_43();
                            phi_1479_ = true;
                        }
                        let _e562 = phi_1478_;
                        let _e564 = phi_1479_;
                        phi_1480_ = _e562;
                        phi_1481_ = _e564;
                    } else {
                        phi_1480_ = type_43();
                        phi_1481_ = true;
                    }
                    let _e566 = phi_1480_;
                    let _e568 = phi_1481_;
                    phi_1482_ = _e566;
                    phi_1483_ = _e568;
                }
                let _e570 = phi_1482_;
                let _e572 = phi_1483_;
                if _e572 {
                    phi_1488_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e297, _e300, _e303), array<f64, 3>(_e309, _e312, _e315)), array<array<f64, 3>, 2>(array<f64, 3>(_e322, _e325, _e328), array<f64, 3>(_e334, _e337, _e340)), array<array<f64, 3>, 2>(array<f64, 3>(_e347, _e350, _e353), array<f64, 3>(_e359, _e362, _e365)), _e368), _e378);
                } else {
                    phi_1488_ = _e570;
                }
                let _e575 = phi_1488_;
                local_12 = type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e575.member.member[0][0], _e575.member.member[0][1], _e575.member.member[0][2]), array<f64, 3>(_e575.member.member[1][0], _e575.member.member[1][1], _e575.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e575.member.member_1[0][0], _e575.member.member_1[0][1], _e575.member.member_1[0][2]), array<f64, 3>(_e575.member.member_1[1][0], _e575.member.member_1[1][1], _e575.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e575.member.member_2[0][0], _e575.member.member_2[0][1], _e575.member.member_2[0][2]), array<f64, 3>(_e575.member.member_2[1][0], _e575.member.member_2[1][1], _e575.member.member_2[1][2])), _e575.member.member_3);
                let _e618 = local_12.member_1[0u];
                let _e624 = local_12.member_2[0u];
                let _e630 = ((_e618[1] * _e624[2]) - (_e618[2] * _e624[1]));
                let _e633 = ((_e618[2] * _e624[0]) - (_e618[0] * _e624[2]));
                let _e636 = ((_e618[0] * _e624[1]) - (_e618[1] * _e624[0]));
                let _e639 = local_12.member_1[1u];
                let _e645 = local_12.member_2[1u];
                let _e651 = ((_e639[1] * _e645[2]) - (_e639[2] * _e645[1]));
                let _e654 = ((_e639[2] * _e645[0]) - (_e639[0] * _e645[2]));
                let _e657 = ((_e639[0] * _e645[1]) - (_e639[1] * _e645[0]));
                let _e660 = local_12.member_1[0u];
                let _e666 = local_12.member_2[1u];
                let _e681 = local_12.member_1[1u];
                let _e687 = local_12.member_2[0u];
                let _e700 = (((_e660[1] * _e666[2]) - (_e660[2] * _e666[1])) + ((_e681[1] * _e687[2]) - (_e681[2] * _e687[1])));
                let _e701 = (((_e660[2] * _e666[0]) - (_e660[0] * _e666[2])) + ((_e681[2] * _e687[0]) - (_e681[0] * _e687[2])));
                let _e702 = (((_e660[0] * _e666[1]) - (_e660[1] * _e666[0])) + ((_e681[0] * _e687[1]) - (_e681[1] * _e687[0])));
                let _e705 = local_12.member[0u];
                let _e713 = (((_e705[0] * _e630) + (_e705[1] * _e633)) + (_e705[2] * _e636));
                let _e716 = local_12.member[1u];
                let _e727 = local_12.member[0u];
                let _e736 = ((((_e716[0] * _e630) + (_e716[1] * _e633)) + (_e716[2] * _e636)) + (((_e727[0] * _e700) + (_e727[1] * _e701)) + (_e727[2] * _e702)));
                let _e739 = local_12.member[0u];
                let _e750 = local_12.member[1u];
                let _e759 = ((((_e739[0] * _e651) + (_e739[1] * _e654)) + (_e739[2] * _e657)) + (((_e750[0] * _e700) + (_e750[1] * _e701)) + (_e750[2] * _e702)));
                let _e762 = local_12.member[1u];
                let _e770 = (((_e762[0] * _e651) + (_e762[1] * _e654)) + (_e762[2] * _e657));
                let _e773 = local_12.member[0u];
                if (_e773[0] < 0.0lf) {
                    phi_1770_ = -(_e773[0]);
                } else {
                    phi_1770_ = _e773[0];
                }
                let _e780 = phi_1770_;
                if (_e773[1] < 0.0lf) {
                    phi_1777_ = -(_e773[1]);
                } else {
                    phi_1777_ = _e773[1];
                }
                let _e784 = phi_1777_;
                if (_e780 > _e784) {
                    phi_1782_ = _e780;
                } else {
                    phi_1782_ = _e784;
                }
                let _e787 = phi_1782_;
                if (_e773[2] < 0.0lf) {
                    phi_1789_ = -(_e773[2]);
                } else {
                    phi_1789_ = _e773[2];
                }
                let _e791 = phi_1789_;
                if (_e787 > _e791) {
                    phi_1794_ = _e787;
                } else {
                    phi_1794_ = _e791;
                }
                let _e794 = phi_1794_;
                let _e797 = local_12.member[1u];
                if (_e797[0] < 0.0lf) {
                    phi_1807_ = -(_e797[0]);
                } else {
                    phi_1807_ = _e797[0];
                }
                let _e804 = phi_1807_;
                if (_e797[1] < 0.0lf) {
                    phi_1814_ = -(_e797[1]);
                } else {
                    phi_1814_ = _e797[1];
                }
                let _e808 = phi_1814_;
                if (_e804 > _e808) {
                    phi_1819_ = _e804;
                } else {
                    phi_1819_ = _e808;
                }
                let _e811 = phi_1819_;
                if (_e797[2] < 0.0lf) {
                    phi_1826_ = -(_e797[2]);
                } else {
                    phi_1826_ = _e797[2];
                }
                let _e815 = phi_1826_;
                if (_e811 > _e815) {
                    phi_1831_ = _e811;
                } else {
                    phi_1831_ = _e815;
                }
                let _e818 = phi_1831_;
                if (_e794 > _e818) {
                    phi_1836_ = _e794;
                } else {
                    phi_1836_ = _e818;
                }
                let _e821 = phi_1836_;
                let _e823 = local_12.member_3;
                let _e824 = (_e821 + _e823);
                let _e827 = local_12.member_1[0u];
                if (_e827[0] < 0.0lf) {
                    phi_1853_ = -(_e827[0]);
                } else {
                    phi_1853_ = _e827[0];
                }
                let _e834 = phi_1853_;
                if (_e827[1] < 0.0lf) {
                    phi_1860_ = -(_e827[1]);
                } else {
                    phi_1860_ = _e827[1];
                }
                let _e838 = phi_1860_;
                if (_e834 > _e838) {
                    phi_1865_ = _e834;
                } else {
                    phi_1865_ = _e838;
                }
                let _e841 = phi_1865_;
                if (_e827[2] < 0.0lf) {
                    phi_1872_ = -(_e827[2]);
                } else {
                    phi_1872_ = _e827[2];
                }
                let _e845 = phi_1872_;
                if (_e841 > _e845) {
                    phi_1877_ = _e841;
                } else {
                    phi_1877_ = _e845;
                }
                let _e848 = phi_1877_;
                let _e851 = local_12.member_1[1u];
                if (_e851[0] < 0.0lf) {
                    phi_1891_ = -(_e851[0]);
                } else {
                    phi_1891_ = _e851[0];
                }
                let _e858 = phi_1891_;
                if (_e851[1] < 0.0lf) {
                    phi_1898_ = -(_e851[1]);
                } else {
                    phi_1898_ = _e851[1];
                }
                let _e862 = phi_1898_;
                if (_e858 > _e862) {
                    phi_1903_ = _e858;
                } else {
                    phi_1903_ = _e862;
                }
                let _e865 = phi_1903_;
                if (_e851[2] < 0.0lf) {
                    phi_1910_ = -(_e851[2]);
                } else {
                    phi_1910_ = _e851[2];
                }
                let _e869 = phi_1910_;
                if (_e865 > _e869) {
                    phi_1915_ = _e865;
                } else {
                    phi_1915_ = _e869;
                }
                let _e872 = phi_1915_;
                if (_e848 > _e872) {
                    phi_1920_ = _e848;
                } else {
                    phi_1920_ = _e872;
                }
                let _e875 = phi_1920_;
                let _e877 = local_12.member_3;
                let _e878 = (_e875 + _e877);
                let _e881 = local_12.member_2[0u];
                if (_e881[0] < 0.0lf) {
                    phi_1937_ = -(_e881[0]);
                } else {
                    phi_1937_ = _e881[0];
                }
                let _e888 = phi_1937_;
                if (_e881[1] < 0.0lf) {
                    phi_1944_ = -(_e881[1]);
                } else {
                    phi_1944_ = _e881[1];
                }
                let _e892 = phi_1944_;
                if (_e888 > _e892) {
                    phi_1949_ = _e888;
                } else {
                    phi_1949_ = _e892;
                }
                let _e895 = phi_1949_;
                if (_e881[2] < 0.0lf) {
                    phi_1956_ = -(_e881[2]);
                } else {
                    phi_1956_ = _e881[2];
                }
                let _e899 = phi_1956_;
                if (_e895 > _e899) {
                    phi_1961_ = _e895;
                } else {
                    phi_1961_ = _e899;
                }
                let _e902 = phi_1961_;
                let _e905 = local_12.member_2[1u];
                if (_e905[0] < 0.0lf) {
                    phi_1975_ = -(_e905[0]);
                } else {
                    phi_1975_ = _e905[0];
                }
                let _e912 = phi_1975_;
                if (_e905[1] < 0.0lf) {
                    phi_1982_ = -(_e905[1]);
                } else {
                    phi_1982_ = _e905[1];
                }
                let _e916 = phi_1982_;
                if (_e912 > _e916) {
                    phi_1987_ = _e912;
                } else {
                    phi_1987_ = _e916;
                }
                let _e919 = phi_1987_;
                if (_e905[2] < 0.0lf) {
                    phi_1994_ = -(_e905[2]);
                } else {
                    phi_1994_ = _e905[2];
                }
                let _e923 = phi_1994_;
                if (_e919 > _e923) {
                    phi_1999_ = _e919;
                } else {
                    phi_1999_ = _e923;
                }
                let _e926 = phi_1999_;
                if (_e902 > _e926) {
                    phi_2004_ = _e902;
                } else {
                    phi_2004_ = _e926;
                }
                let _e929 = phi_2004_;
                let _e931 = local_12.member_3;
                let _e932 = (_e929 + _e931);
                let _e933 = f64(1f);
                let _e934 = f64(8f);
                let _e936 = ((_e878 * _e934) * _e932);
                let _e944 = local_12.member_3;
                if (_e630 < 0.0lf) {
                    phi_2041_ = -(_e630);
                } else {
                    phi_2041_ = _e630;
                }
                let _e964 = phi_2041_;
                if (_e633 < 0.0lf) {
                    phi_2047_ = -(_e633);
                } else {
                    phi_2047_ = _e633;
                }
                let _e968 = phi_2047_;
                if (_e636 < 0.0lf) {
                    phi_2054_ = -(_e636);
                } else {
                    phi_2054_ = _e636;
                }
                let _e973 = phi_2054_;
                let _e974 = ((_e964 + _e968) + _e973);
                if (_e651 < 0.0lf) {
                    phi_2061_ = -(_e651);
                } else {
                    phi_2061_ = _e651;
                }
                let _e978 = phi_2061_;
                if (_e654 < 0.0lf) {
                    phi_2067_ = -(_e654);
                } else {
                    phi_2067_ = _e654;
                }
                let _e982 = phi_2067_;
                if (_e657 < 0.0lf) {
                    phi_2074_ = -(_e657);
                } else {
                    phi_2074_ = _e657;
                }
                let _e987 = phi_2074_;
                let _e988 = ((_e978 + _e982) + _e987);
                if (_e974 > _e988) {
                    phi_2080_ = _e974;
                } else {
                    phi_2080_ = _e988;
                }
                let _e991 = phi_2080_;
                if (_e700 < 0.0lf) {
                    phi_2086_ = -(_e700);
                } else {
                    phi_2086_ = _e700;
                }
                let _e995 = phi_2086_;
                if (_e701 < 0.0lf) {
                    phi_2092_ = -(_e701);
                } else {
                    phi_2092_ = _e701;
                }
                let _e999 = phi_2092_;
                if (_e702 < 0.0lf) {
                    phi_2099_ = -(_e702);
                } else {
                    phi_2099_ = _e702;
                }
                let _e1004 = phi_2099_;
                let _e1006 = (((_e995 + _e999) + _e1004) * f64(0.5f));
                if (_e991 > _e1006) {
                    phi_2106_ = _e991;
                } else {
                    phi_2106_ = _e1006;
                }
                let _e1009 = phi_2106_;
                let _e1015 = local_12.member_3;
                let _e1029 = (((((_e824 * _e934) * _e936) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e944 * f64(19f)) * ((_e824 * (_e878 + _e932)) + (_e878 * _e932)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e933 + _e824) * ((_e933 + _e878) * (_e933 + _e932)))));
                let _e1030 = f64(3f);
                let _e1031 = (_e713 * _e1030);
                let _e1032 = (_e770 * _e1030);
                if (_e1031 < _e1032) {
                    phi_2134_ = _e1031;
                } else {
                    phi_2134_ = _e1032;
                }
                let _e1035 = phi_2134_;
                if (_e736 < _e759) {
                    phi_2139_ = _e736;
                } else {
                    phi_2139_ = _e759;
                }
                let _e1038 = phi_2139_;
                if (_e1035 < _e1038) {
                    phi_2144_ = _e1035;
                } else {
                    phi_2144_ = _e1038;
                }
                let _e1041 = phi_2144_;
                if (_e1031 > _e1032) {
                    phi_2149_ = _e1031;
                } else {
                    phi_2149_ = _e1032;
                }
                let _e1044 = phi_2149_;
                if (_e736 > _e759) {
                    phi_2154_ = _e736;
                } else {
                    phi_2154_ = _e759;
                }
                let _e1047 = phi_2154_;
                if (_e1044 > _e1047) {
                    phi_2159_ = _e1044;
                } else {
                    phi_2159_ = _e1047;
                }
                let _e1050 = phi_2159_;
                let _e1056 = -(_e1050);
                if (_e1041 > _e1056) {
                    phi_2170_ = _e1041;
                } else {
                    phi_2170_ = _e1056;
                }
                let _e1059 = phi_2170_;
                if ((_e1059 - (_e1029 + ((_e575.member_1 * (((_e1009 + (_e936 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1015 * f64(6f)) * (_e878 + _e932))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e933 + _e878) * (_e933 + _e932))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8925_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e575.member_1 > f64(0f)) {
                        let _e3752 = f64(1f);
                        let _e3753 = f64(0f);
                        let _e3756 = local_12.member[0u];
                        let _e3762 = local_12.member_1[0u];
                        let _e3768 = local_12.member_2[0u];
                        let _e3780 = local_12.member[1u];
                        let _e3786 = local_12.member_1[1u];
                        let _e3792 = local_12.member_2[1u];
                        let _e3804 = local_12.member[0u];
                        if (_e3804[0] < 0.0lf) {
                            phi_2327_ = -(_e3804[0]);
                        } else {
                            phi_2327_ = _e3804[0];
                        }
                        let _e3811 = phi_2327_;
                        if (_e3804[1] < 0.0lf) {
                            phi_2334_ = -(_e3804[1]);
                        } else {
                            phi_2334_ = _e3804[1];
                        }
                        let _e3815 = phi_2334_;
                        if (_e3811 > _e3815) {
                            phi_2339_ = _e3811;
                        } else {
                            phi_2339_ = _e3815;
                        }
                        let _e3818 = phi_2339_;
                        if (_e3804[2] < 0.0lf) {
                            phi_2346_ = -(_e3804[2]);
                        } else {
                            phi_2346_ = _e3804[2];
                        }
                        let _e3822 = phi_2346_;
                        if (_e3818 > _e3822) {
                            phi_2351_ = _e3818;
                        } else {
                            phi_2351_ = _e3822;
                        }
                        let _e3825 = phi_2351_;
                        let _e3828 = local_12.member[1u];
                        if (_e3828[0] < 0.0lf) {
                            phi_2364_ = -(_e3828[0]);
                        } else {
                            phi_2364_ = _e3828[0];
                        }
                        let _e3835 = phi_2364_;
                        if (_e3828[1] < 0.0lf) {
                            phi_2371_ = -(_e3828[1]);
                        } else {
                            phi_2371_ = _e3828[1];
                        }
                        let _e3839 = phi_2371_;
                        if (_e3835 > _e3839) {
                            phi_2376_ = _e3835;
                        } else {
                            phi_2376_ = _e3839;
                        }
                        let _e3842 = phi_2376_;
                        if (_e3828[2] < 0.0lf) {
                            phi_2383_ = -(_e3828[2]);
                        } else {
                            phi_2383_ = _e3828[2];
                        }
                        let _e3846 = phi_2383_;
                        if (_e3842 > _e3846) {
                            phi_2388_ = _e3842;
                        } else {
                            phi_2388_ = _e3846;
                        }
                        let _e3849 = phi_2388_;
                        if (_e3825 > _e3849) {
                            phi_2393_ = _e3825;
                        } else {
                            phi_2393_ = _e3849;
                        }
                        let _e3852 = phi_2393_;
                        let _e3854 = local_12.member_3;
                        let _e3858 = local_12.member_1[0u];
                        if (_e3858[0] < 0.0lf) {
                            phi_2410_ = -(_e3858[0]);
                        } else {
                            phi_2410_ = _e3858[0];
                        }
                        let _e3865 = phi_2410_;
                        if (_e3858[1] < 0.0lf) {
                            phi_2417_ = -(_e3858[1]);
                        } else {
                            phi_2417_ = _e3858[1];
                        }
                        let _e3869 = phi_2417_;
                        if (_e3865 > _e3869) {
                            phi_2422_ = _e3865;
                        } else {
                            phi_2422_ = _e3869;
                        }
                        let _e3872 = phi_2422_;
                        if (_e3858[2] < 0.0lf) {
                            phi_2429_ = -(_e3858[2]);
                        } else {
                            phi_2429_ = _e3858[2];
                        }
                        let _e3876 = phi_2429_;
                        if (_e3872 > _e3876) {
                            phi_2434_ = _e3872;
                        } else {
                            phi_2434_ = _e3876;
                        }
                        let _e3879 = phi_2434_;
                        let _e3882 = local_12.member_1[1u];
                        if (_e3882[0] < 0.0lf) {
                            phi_2448_ = -(_e3882[0]);
                        } else {
                            phi_2448_ = _e3882[0];
                        }
                        let _e3889 = phi_2448_;
                        if (_e3882[1] < 0.0lf) {
                            phi_2455_ = -(_e3882[1]);
                        } else {
                            phi_2455_ = _e3882[1];
                        }
                        let _e3893 = phi_2455_;
                        if (_e3889 > _e3893) {
                            phi_2460_ = _e3889;
                        } else {
                            phi_2460_ = _e3893;
                        }
                        let _e3896 = phi_2460_;
                        if (_e3882[2] < 0.0lf) {
                            phi_2467_ = -(_e3882[2]);
                        } else {
                            phi_2467_ = _e3882[2];
                        }
                        let _e3900 = phi_2467_;
                        if (_e3896 > _e3900) {
                            phi_2472_ = _e3896;
                        } else {
                            phi_2472_ = _e3900;
                        }
                        let _e3903 = phi_2472_;
                        if (_e3879 > _e3903) {
                            phi_2477_ = _e3879;
                        } else {
                            phi_2477_ = _e3903;
                        }
                        let _e3906 = phi_2477_;
                        let _e3908 = local_12.member_3;
                        let _e3912 = local_12.member_2[0u];
                        if (_e3912[0] < 0.0lf) {
                            phi_2494_ = -(_e3912[0]);
                        } else {
                            phi_2494_ = _e3912[0];
                        }
                        let _e3919 = phi_2494_;
                        if (_e3912[1] < 0.0lf) {
                            phi_2501_ = -(_e3912[1]);
                        } else {
                            phi_2501_ = _e3912[1];
                        }
                        let _e3923 = phi_2501_;
                        if (_e3919 > _e3923) {
                            phi_2506_ = _e3919;
                        } else {
                            phi_2506_ = _e3923;
                        }
                        let _e3926 = phi_2506_;
                        if (_e3912[2] < 0.0lf) {
                            phi_2513_ = -(_e3912[2]);
                        } else {
                            phi_2513_ = _e3912[2];
                        }
                        let _e3930 = phi_2513_;
                        if (_e3926 > _e3930) {
                            phi_2518_ = _e3926;
                        } else {
                            phi_2518_ = _e3930;
                        }
                        let _e3933 = phi_2518_;
                        let _e3936 = local_12.member_2[1u];
                        if (_e3936[0] < 0.0lf) {
                            phi_2532_ = -(_e3936[0]);
                        } else {
                            phi_2532_ = _e3936[0];
                        }
                        let _e3943 = phi_2532_;
                        if (_e3936[1] < 0.0lf) {
                            phi_2539_ = -(_e3936[1]);
                        } else {
                            phi_2539_ = _e3936[1];
                        }
                        let _e3947 = phi_2539_;
                        if (_e3943 > _e3947) {
                            phi_2544_ = _e3943;
                        } else {
                            phi_2544_ = _e3947;
                        }
                        let _e3950 = phi_2544_;
                        if (_e3936[2] < 0.0lf) {
                            phi_2551_ = -(_e3936[2]);
                        } else {
                            phi_2551_ = _e3936[2];
                        }
                        let _e3954 = phi_2551_;
                        if (_e3950 > _e3954) {
                            phi_2556_ = _e3950;
                        } else {
                            phi_2556_ = _e3954;
                        }
                        let _e3957 = phi_2556_;
                        if (_e3933 > _e3957) {
                            phi_2561_ = _e3933;
                        } else {
                            phi_2561_ = _e3957;
                        }
                        let _e3960 = phi_2561_;
                        let _e3962 = local_12.member_3;
                        let _e3970 = local_12.member_3;
                        let _e3977 = f64(0f);
                        let _e3978 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e3977, _e3977, _e3977, _e3977), array<f64, 4>(_e3977, _e3977, _e3977, _e3977), array<f64, 4>(_e3978, _e3978, _e3978, _e3978));
                        phi_2605_ = type_9(0u, 96u);
                        phi_2608_ = _e3753;
                        phi_2610_ = _e3753;
                        phi_2612_ = _e3753;
                        phi_2614_ = false;
                        phi_2616_ = 0u;
                        loop {
                            let _e3984 = phi_2605_;
                            let _e3986 = phi_2608_;
                            let _e3988 = phi_2610_;
                            let _e3990 = phi_2612_;
                            let _e3992 = phi_2614_;
                            let _e3994 = phi_2616_;
                            local_44 = _e3988;
                            local_26 = _e3986;
                            if (_e3984.member < _e3984.member_1) {
                                phi_2606_ = type_9((_e3984.member + 1u), _e3984.member_1);
                                phi_2639_ = type_9(1u, _e3984.member);
                            } else {
                                phi_2606_ = _e3984;
                                phi_2639_ = type_9(0u, type_9().member_1);
                            }
                            let _e4006 = phi_2606_;
                            let _e4008 = phi_2639_;
                            if (bitcast<i32>(_e4008.member) != 0i) {
                                let _e4014 = local_12.member[0u];
                                let _e4020 = local_12.member[1u];
                                let _e4036 = local_12.member_1[0u];
                                let _e4042 = local_12.member_1[1u];
                                let _e4058 = local_12.member_2[0u];
                                let _e4064 = local_12.member_2[1u];
                                let _e4078 = function_2(array<f64, 3>((_e4014[0] + ((_e4020[0] - _e4014[0]) * _e3986)), (_e4014[1] + ((_e4020[1] - _e4014[1]) * _e3986)), (_e4014[2] + ((_e4020[2] - _e4014[2]) * _e3986))), array<f64, 3>((_e4036[0] + ((_e4042[0] - _e4036[0]) * _e3986)), (_e4036[1] + ((_e4042[1] - _e4036[1]) * _e3986)), (_e4036[2] + ((_e4042[2] - _e4036[2]) * _e3986))), array<f64, 3>((_e4058[0] + ((_e4064[0] - _e4058[0]) * _e3986)), (_e4058[1] + ((_e4064[1] - _e4058[1]) * _e3986)), (_e4058[2] + ((_e4064[2] - _e4058[2]) * _e3986))), 0u);
                                if (_e3994 == 0u) {
                                    phi_2768_ = _e4078;
                                } else {
                                    let _e4080 = f64(0f);
                                    if (_e3994 == 1u) {
                                        phi_2754_ = _e4078[0];
                                    } else {
                                        phi_2754_ = _e4080;
                                    }
                                    let _e4084 = phi_2754_;
                                    if (_e3994 == 2u) {
                                        phi_2760_ = _e4078[1];
                                    } else {
                                        phi_2760_ = _e4080;
                                    }
                                    let _e4088 = phi_2760_;
                                    if (_e3994 == 3u) {
                                        phi_2766_ = _e4078[2];
                                    } else {
                                        phi_2766_ = _e4080;
                                    }
                                    let _e4092 = phi_2766_;
                                    phi_2768_ = array<f64, 3>(_e4084, _e4088, _e4092);
                                }
                                let _e4095 = phi_2768_;
                                if (_e4095[0] < 0.0lf) {
                                    phi_2775_ = -(_e4095[0]);
                                } else {
                                    phi_2775_ = _e4095[0];
                                }
                                let _e4100 = phi_2775_;
                                if (_e4095[1] < 0.0lf) {
                                    phi_2782_ = -(_e4095[1]);
                                } else {
                                    phi_2782_ = _e4095[1];
                                }
                                let _e4105 = phi_2782_;
                                if (_e4095[2] < 0.0lf) {
                                    phi_2790_ = -(_e4095[2]);
                                } else {
                                    phi_2790_ = _e4095[2];
                                }
                                let _e4111 = phi_2790_;
                                let _e4112 = ((_e4100 + _e4105) + _e4111);
                                if (_e4112 > f64(0f)) {
                                    if ((bitcast<u64>(_e4112) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4119 = (f64(1f) / _e4112);
                                        let _e4121 = (_e4095[0] * _e4119);
                                        let _e4123 = (_e4095[1] * _e4119);
                                        let _e4125 = (_e4095[2] * _e4119);
                                        let _e4130 = (((_e4121 * _e4121) + (_e4123 * _e4123)) + (_e4125 * _e4125));
                                        if (_e4130 <= 2.2250738585072014e-308lf) {
                                            if (_e4130 > 0.0lf) {
                                                phi_2829_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2829_ = 0.0lf;
                                            }
                                            let _e4182 = phi_2829_;
                                            phi_2893_ = _e4182;
                                        } else {
                                            phi_2836_ = type_16(0i, 5i);
                                            phi_2839_ = bitcast<f64>(((bitcast<u64>(_e4130) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4137 = phi_2836_;
                                                let _e4139 = phi_2839_;
                                                local_24 = _e4139;
                                                if (_e4137.member < _e4137.member_1) {
                                                    let _e4146 = (_e4137.member + 1i);
                                                    if ((false == (_e4146 > _e4137.member)) != false) {
                                                        phi_2860_ = true;
                                                    } else {
                                                        phi_2860_ = false;
                                                    }
                                                    let _e4151 = phi_2860_;
                                                    if _e4151 {
                                                        phi_2866_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2866_ = type_17(1u, _e4146);
                                                    }
                                                    let _e4156 = phi_2866_;
                                                    phi_2837_ = type_16(_e4156.member_1, _e4137.member_1);
                                                    phi_2880_ = type_17(1u, _e4137.member);
                                                } else {
                                                    phi_2837_ = _e4137;
                                                    phi_2880_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4162 = phi_2837_;
                                                let _e4164 = phi_2880_;
                                                let _e4167 = (bitcast<i32>(_e4164.member) != 0i);
                                                if _e4167 {
                                                    phi_2840_ = (0.5lf * (_e4139 + (_e4130 / _e4139)));
                                                } else {
                                                    phi_2840_ = f64();
                                                }
                                                let _e4172 = phi_2840_;
                                                continue;
                                                continuing {
                                                    phi_2836_ = _e4162;
                                                    phi_2839_ = _e4172;
                                                    break if !(_e4167);
                                                }
                                            }
                                            let _e4177 = local_24;
                                            phi_2893_ = (_e4177 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4184 = phi_2893_;
                                        let _e4186 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4193 = ((((((((_e3852 + _e3854) + (_e3906 + _e3908)) + (_e3960 + _e3962)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3970 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e575.member_1 * _e4184) * (f64(1f) + _e4186)));
                                        let _e4198 = (((_e4121 * _e3756[0]) + (_e4123 * _e3756[1])) + (_e4125 * _e3756[2]));
                                        let _e4203 = (((_e4121 * (_e3756[0] - _e3762[0])) + (_e4123 * (_e3756[1] - _e3762[1]))) + (_e4125 * (_e3756[2] - _e3762[2])));
                                        let _e4208 = (((_e4121 * (_e3756[0] - _e3768[0])) + (_e4123 * (_e3756[1] - _e3768[1]))) + (_e4125 * (_e3756[2] - _e3768[2])));
                                        let _e4213 = (((_e4121 * _e3756[0]) + (_e4123 * _e3756[1])) + (_e4125 * _e3756[2]));
                                        let _e4219 = (((_e4121 * _e3780[0]) + (_e4123 * _e3780[1])) + (_e4125 * _e3780[2]));
                                        let _e4224 = (((_e4121 * (_e3780[0] - _e3786[0])) + (_e4123 * (_e3780[1] - _e3786[1]))) + (_e4125 * (_e3780[2] - _e3786[2])));
                                        let _e4229 = (((_e4121 * (_e3780[0] - _e3792[0])) + (_e4123 * (_e3780[1] - _e3792[1]))) + (_e4125 * (_e3780[2] - _e3792[2])));
                                        let _e4234 = (((_e4121 * _e3780[0]) + (_e4123 * _e3780[1])) + (_e4125 * _e3780[2]));
                                        if (_e4198 < 0.0lf) {
                                            phi_2962_ = -(_e4198);
                                        } else {
                                            phi_2962_ = _e4198;
                                        }
                                        let _e4239 = phi_2962_;
                                        if (_e4219 < 0.0lf) {
                                            phi_2968_ = -(_e4219);
                                        } else {
                                            phi_2968_ = _e4219;
                                        }
                                        let _e4243 = phi_2968_;
                                        if (_e4203 < 0.0lf) {
                                            phi_2977_ = -(_e4203);
                                        } else {
                                            phi_2977_ = _e4203;
                                        }
                                        let _e4250 = phi_2977_;
                                        if (_e4224 < 0.0lf) {
                                            phi_2983_ = -(_e4224);
                                        } else {
                                            phi_2983_ = _e4224;
                                        }
                                        let _e4254 = phi_2983_;
                                        if (_e4208 < 0.0lf) {
                                            phi_2992_ = -(_e4208);
                                        } else {
                                            phi_2992_ = _e4208;
                                        }
                                        let _e4261 = phi_2992_;
                                        if (_e4229 < 0.0lf) {
                                            phi_2998_ = -(_e4229);
                                        } else {
                                            phi_2998_ = _e4229;
                                        }
                                        let _e4265 = phi_2998_;
                                        if (_e4213 < 0.0lf) {
                                            phi_3007_ = -(_e4213);
                                        } else {
                                            phi_3007_ = _e4213;
                                        }
                                        let _e4272 = phi_3007_;
                                        if (_e4234 < 0.0lf) {
                                            phi_3013_ = -(_e4234);
                                        } else {
                                            phi_3013_ = _e4234;
                                        }
                                        let _e4276 = phi_3013_;
                                        phi_3019_ = type_34(array<f64, 4>(_e4198, _e4203, _e4208, _e4213), array<f64, 4>(_e4219, _e4224, _e4229, _e4234), array<f64, 4>((_e4193 + ((_e4239 + _e4243) * _e4186)), (_e4193 + ((_e4250 + _e4254) * _e4186)), (_e4193 + ((_e4261 + _e4265) * _e4186)), (_e4193 + ((_e4272 + _e4276) * _e4186))));
                                        phi_3020_ = false;
                                    } else {
                                        phi_3019_ = type_34();
                                        phi_3020_ = true;
                                    }
                                    let _e4283 = phi_3019_;
                                    let _e4285 = phi_3020_;
                                    phi_3021_ = _e4283;
                                    phi_3022_ = _e4285;
                                } else {
                                    phi_3021_ = type_34();
                                    phi_3022_ = true;
                                }
                                let _e4287 = phi_3021_;
                                let _e4289 = phi_3022_;
                                if _e4289 {
                                    let _e4290 = f64(0f);
                                    let _e4291 = f64(1f);
                                    phi_3032_ = type_34(array<f64, 4>(_e4290, _e4290, _e4290, _e4290), array<f64, 4>(_e4290, _e4290, _e4290, _e4290), array<f64, 4>(_e4291, _e4291, _e4291, _e4291));
                                } else {
                                    phi_3032_ = _e4287;
                                }
                                let _e4297 = phi_3032_;
                                local_10 = type_34(array<f64, 4>(_e4297.member[0], _e4297.member[1], _e4297.member[2], _e4297.member[3]), array<f64, 4>(_e4297.member_1[0], _e4297.member_1[1], _e4297.member_1[2], _e4297.member_1[3]), array<f64, 4>(_e4297.member_2[0], _e4297.member_2[1], _e4297.member_2[2], _e4297.member_2[3]));
                                let _e4317 = (_e3986 - _e3990);
                                let _e4319 = f64(0f);
                                let _e4322 = local_10.member[0u];
                                let _e4325 = local_10.member_1[0u];
                                let _e4328 = local_10.member[0u];
                                let _e4334 = local_10.member_2[0u];
                                if (((_e4322 + ((_e4325 - _e4328) * _e3986)) - _e4334) > _e4319) {
                                    let _e4339 = local_10.member[1u];
                                    let _e4342 = local_10.member_1[1u];
                                    let _e4345 = local_10.member[1u];
                                    let _e4351 = local_10.member_2[1u];
                                    if (((_e4339 + ((_e4342 - _e4345) * _e3986)) - _e4351) > _e4319) {
                                        let _e4356 = local_10.member[2u];
                                        let _e4359 = local_10.member_1[2u];
                                        let _e4362 = local_10.member[2u];
                                        let _e4368 = local_10.member_2[2u];
                                        if (((_e4356 + ((_e4359 - _e4362) * _e3986)) - _e4368) > _e4319) {
                                            let _e4373 = local_10.member[3u];
                                            let _e4376 = local_10.member_1[3u];
                                            let _e4379 = local_10.member[3u];
                                            let _e4385 = local_10.member_2[3u];
                                            phi_3204_ = (((_e4373 + ((_e4376 - _e4379) * _e3986)) - _e4385) > _e4319);
                                            phi_3205_ = false;
                                        } else {
                                            phi_3204_ = bool();
                                            phi_3205_ = true;
                                        }
                                        let _e4389 = phi_3204_;
                                        let _e4391 = phi_3205_;
                                        phi_3206_ = _e4389;
                                        phi_3207_ = _e4391;
                                    } else {
                                        phi_3206_ = bool();
                                        phi_3207_ = true;
                                    }
                                    let _e4393 = phi_3206_;
                                    let _e4395 = phi_3207_;
                                    phi_3208_ = _e4393;
                                    phi_3209_ = _e4395;
                                } else {
                                    phi_3208_ = bool();
                                    phi_3209_ = true;
                                }
                                let _e4397 = phi_3208_;
                                let _e4399 = phi_3209_;
                                if _e4399 {
                                    phi_3213_ = false;
                                } else {
                                    phi_3213_ = _e4397;
                                }
                                let _e4401 = phi_3213_;
                                if _e4401 {
                                    if (_e3986 <= _e3988) {
                                        phi_3524_ = true;
                                    } else {
                                        let _e4403 = f64(0f);
                                        let _e4406 = local_9.member[0u];
                                        let _e4409 = local_9.member_1[0u];
                                        let _e4412 = local_9.member[0u];
                                        let _e4418 = local_9.member_2[0u];
                                        let _e4422 = local_10.member[0u];
                                        let _e4425 = local_10.member_1[0u];
                                        let _e4428 = local_10.member[0u];
                                        let _e4434 = local_10.member_2[0u];
                                        if ((((_e4406 + ((_e4409 - _e4412) * _e3986)) - _e4418) + ((_e4422 + ((_e4425 - _e4428) * _e3990)) - _e4434)) > _e4403) {
                                            let _e4440 = local_9.member[1u];
                                            let _e4443 = local_9.member_1[1u];
                                            let _e4446 = local_9.member[1u];
                                            let _e4452 = local_9.member_2[1u];
                                            let _e4456 = local_10.member[1u];
                                            let _e4459 = local_10.member_1[1u];
                                            let _e4462 = local_10.member[1u];
                                            let _e4468 = local_10.member_2[1u];
                                            if ((((_e4440 + ((_e4443 - _e4446) * _e3986)) - _e4452) + ((_e4456 + ((_e4459 - _e4462) * _e3990)) - _e4468)) > _e4403) {
                                                let _e4474 = local_9.member[2u];
                                                let _e4477 = local_9.member_1[2u];
                                                let _e4480 = local_9.member[2u];
                                                let _e4486 = local_9.member_2[2u];
                                                let _e4490 = local_10.member[2u];
                                                let _e4493 = local_10.member_1[2u];
                                                let _e4496 = local_10.member[2u];
                                                let _e4502 = local_10.member_2[2u];
                                                if ((((_e4474 + ((_e4477 - _e4480) * _e3986)) - _e4486) + ((_e4490 + ((_e4493 - _e4496) * _e3990)) - _e4502)) > _e4403) {
                                                    let _e4508 = local_9.member[3u];
                                                    let _e4511 = local_9.member_1[3u];
                                                    let _e4514 = local_9.member[3u];
                                                    let _e4520 = local_9.member_2[3u];
                                                    let _e4524 = local_10.member[3u];
                                                    let _e4527 = local_10.member_1[3u];
                                                    let _e4530 = local_10.member[3u];
                                                    let _e4536 = local_10.member_2[3u];
                                                    phi_3511_ = ((((_e4508 + ((_e4511 - _e4514) * _e3986)) - _e4520) + ((_e4524 + ((_e4527 - _e4530) * _e3990)) - _e4536)) > _e4403);
                                                    phi_3512_ = false;
                                                } else {
                                                    phi_3511_ = bool();
                                                    phi_3512_ = true;
                                                }
                                                let _e4541 = phi_3511_;
                                                let _e4543 = phi_3512_;
                                                phi_3513_ = _e4541;
                                                phi_3514_ = _e4543;
                                            } else {
                                                phi_3513_ = bool();
                                                phi_3514_ = true;
                                            }
                                            let _e4545 = phi_3513_;
                                            let _e4547 = phi_3514_;
                                            phi_3515_ = _e4545;
                                            phi_3516_ = _e4547;
                                        } else {
                                            phi_3515_ = bool();
                                            phi_3516_ = true;
                                        }
                                        let _e4549 = phi_3515_;
                                        let _e4551 = phi_3516_;
                                        if _e4551 {
                                            phi_3520_ = false;
                                        } else {
                                            phi_3520_ = _e4549;
                                        }
                                        let _e4553 = phi_3520_;
                                        phi_3524_ = _e4553;
                                    }
                                    let _e4555 = phi_3524_;
                                    if _e4555 {
                                        if _e3992 {
                                            if (_e3986 >= _e3752) {
                                                phi_3535_ = false;
                                            } else {
                                                phi_3535_ = true;
                                            }
                                            let _e4558 = phi_3535_;
                                            phi_3536_ = _e4558;
                                        } else {
                                            phi_3536_ = true;
                                        }
                                        let _e4560 = phi_3536_;
                                        if _e4560 {
                                            local_9 = type_34(array<f64, 4>(_e4297.member[0], _e4297.member[1], _e4297.member[2], _e4297.member[3]), array<f64, 4>(_e4297.member_1[0], _e4297.member_1[1], _e4297.member_1[2], _e4297.member_1[3]), array<f64, 4>(_e4297.member_2[0], _e4297.member_2[1], _e4297.member_2[2], _e4297.member_2[3]));
                                            let _e4582 = local_9.member[0u];
                                            let _e4585 = local_9.member_1[0u];
                                            let _e4588 = local_9.member_2[0u];
                                            if (_e4582 > _e4588) {
                                                if (_e4585 > _e4588) {
                                                    phi_3610_ = false;
                                                } else {
                                                    phi_3610_ = true;
                                                }
                                                let _e4592 = phi_3610_;
                                                phi_3611_ = _e4592;
                                            } else {
                                                phi_3611_ = true;
                                            }
                                            let _e4594 = phi_3611_;
                                            if _e4594 {
                                                let _e4595 = (_e4585 >= _e4582);
                                                if _e4595 {
                                                    phi_3636_ = f64();
                                                    phi_3637_ = false;
                                                } else {
                                                    if ((_e4582 - _e4585) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3634_ = (((_e4582 - _e4588) / (_e4582 - _e4585)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3635_ = false;
                                                    } else {
                                                        phi_3634_ = f64();
                                                        phi_3635_ = true;
                                                    }
                                                    let _e4609 = phi_3634_;
                                                    let _e4611 = phi_3635_;
                                                    phi_3636_ = _e4609;
                                                    phi_3637_ = _e4611;
                                                }
                                                let _e4613 = phi_3636_;
                                                let _e4615 = phi_3637_;
                                                phi_3638_ = _e4613;
                                                phi_3639_ = _e4595;
                                                phi_3640_ = _e4615;
                                            } else {
                                                phi_3638_ = f64();
                                                phi_3639_ = true;
                                                phi_3640_ = false;
                                            }
                                            let _e4617 = phi_3638_;
                                            let _e4619 = phi_3639_;
                                            let _e4621 = phi_3640_;
                                            if _e4619 {
                                                phi_3645_ = f64(2f);
                                                phi_3646_ = true;
                                            } else {
                                                phi_3645_ = _e3986;
                                                phi_3646_ = _e4621;
                                            }
                                            let _e4624 = phi_3645_;
                                            let _e4626 = phi_3646_;
                                            if _e4626 {
                                                phi_3650_ = _e4624;
                                            } else {
                                                phi_3650_ = _e4617;
                                            }
                                            let _e4628 = phi_3650_;
                                            let _e4631 = local_9.member[1u];
                                            let _e4634 = local_9.member_1[1u];
                                            let _e4637 = local_9.member_2[1u];
                                            if (_e4631 > _e4637) {
                                                if (_e4634 > _e4637) {
                                                    phi_3682_ = false;
                                                } else {
                                                    phi_3682_ = true;
                                                }
                                                let _e4641 = phi_3682_;
                                                phi_3683_ = _e4641;
                                            } else {
                                                phi_3683_ = true;
                                            }
                                            let _e4643 = phi_3683_;
                                            if _e4643 {
                                                let _e4644 = (_e4634 >= _e4631);
                                                if _e4644 {
                                                    phi_3708_ = f64();
                                                    phi_3709_ = false;
                                                } else {
                                                    if ((_e4631 - _e4634) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3706_ = (((_e4631 - _e4637) / (_e4631 - _e4634)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3707_ = false;
                                                    } else {
                                                        phi_3706_ = f64();
                                                        phi_3707_ = true;
                                                    }
                                                    let _e4658 = phi_3706_;
                                                    let _e4660 = phi_3707_;
                                                    phi_3708_ = _e4658;
                                                    phi_3709_ = _e4660;
                                                }
                                                let _e4662 = phi_3708_;
                                                let _e4664 = phi_3709_;
                                                phi_3710_ = _e4662;
                                                phi_3711_ = _e4644;
                                                phi_3712_ = _e4664;
                                            } else {
                                                phi_3710_ = f64();
                                                phi_3711_ = true;
                                                phi_3712_ = false;
                                            }
                                            let _e4666 = phi_3710_;
                                            let _e4668 = phi_3711_;
                                            let _e4670 = phi_3712_;
                                            if _e4668 {
                                                phi_3717_ = f64(2f);
                                                phi_3718_ = true;
                                            } else {
                                                phi_3717_ = _e3986;
                                                phi_3718_ = _e4670;
                                            }
                                            let _e4673 = phi_3717_;
                                            let _e4675 = phi_3718_;
                                            if _e4675 {
                                                phi_3722_ = _e4673;
                                            } else {
                                                phi_3722_ = _e4666;
                                            }
                                            let _e4677 = phi_3722_;
                                            if (_e4628 < _e4677) {
                                                phi_3727_ = _e4628;
                                            } else {
                                                phi_3727_ = _e4677;
                                            }
                                            let _e4680 = phi_3727_;
                                            let _e4683 = local_9.member[2u];
                                            let _e4686 = local_9.member_1[2u];
                                            let _e4689 = local_9.member_2[2u];
                                            if (_e4683 > _e4689) {
                                                if (_e4686 > _e4689) {
                                                    phi_3759_ = false;
                                                } else {
                                                    phi_3759_ = true;
                                                }
                                                let _e4693 = phi_3759_;
                                                phi_3760_ = _e4693;
                                            } else {
                                                phi_3760_ = true;
                                            }
                                            let _e4695 = phi_3760_;
                                            if _e4695 {
                                                let _e4696 = (_e4686 >= _e4683);
                                                if _e4696 {
                                                    phi_3785_ = f64();
                                                    phi_3786_ = false;
                                                } else {
                                                    if ((_e4683 - _e4686) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3783_ = (((_e4683 - _e4689) / (_e4683 - _e4686)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3784_ = false;
                                                    } else {
                                                        phi_3783_ = f64();
                                                        phi_3784_ = true;
                                                    }
                                                    let _e4710 = phi_3783_;
                                                    let _e4712 = phi_3784_;
                                                    phi_3785_ = _e4710;
                                                    phi_3786_ = _e4712;
                                                }
                                                let _e4714 = phi_3785_;
                                                let _e4716 = phi_3786_;
                                                phi_3787_ = _e4714;
                                                phi_3788_ = _e4696;
                                                phi_3789_ = _e4716;
                                            } else {
                                                phi_3787_ = f64();
                                                phi_3788_ = true;
                                                phi_3789_ = false;
                                            }
                                            let _e4718 = phi_3787_;
                                            let _e4720 = phi_3788_;
                                            let _e4722 = phi_3789_;
                                            if _e4720 {
                                                phi_3794_ = f64(2f);
                                                phi_3795_ = true;
                                            } else {
                                                phi_3794_ = _e3986;
                                                phi_3795_ = _e4722;
                                            }
                                            let _e4725 = phi_3794_;
                                            let _e4727 = phi_3795_;
                                            if _e4727 {
                                                phi_3799_ = _e4725;
                                            } else {
                                                phi_3799_ = _e4718;
                                            }
                                            let _e4729 = phi_3799_;
                                            let _e4732 = local_9.member[3u];
                                            let _e4735 = local_9.member_1[3u];
                                            let _e4738 = local_9.member_2[3u];
                                            if (_e4732 > _e4738) {
                                                if (_e4735 > _e4738) {
                                                    phi_3831_ = false;
                                                } else {
                                                    phi_3831_ = true;
                                                }
                                                let _e4742 = phi_3831_;
                                                phi_3832_ = _e4742;
                                            } else {
                                                phi_3832_ = true;
                                            }
                                            let _e4744 = phi_3832_;
                                            if _e4744 {
                                                let _e4745 = (_e4735 >= _e4732);
                                                if _e4745 {
                                                    phi_3857_ = f64();
                                                    phi_3858_ = false;
                                                } else {
                                                    if ((_e4732 - _e4735) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3855_ = (((_e4732 - _e4738) / (_e4732 - _e4735)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3856_ = false;
                                                    } else {
                                                        phi_3855_ = f64();
                                                        phi_3856_ = true;
                                                    }
                                                    let _e4759 = phi_3855_;
                                                    let _e4761 = phi_3856_;
                                                    phi_3857_ = _e4759;
                                                    phi_3858_ = _e4761;
                                                }
                                                let _e4763 = phi_3857_;
                                                let _e4765 = phi_3858_;
                                                phi_3859_ = _e4763;
                                                phi_3860_ = _e4745;
                                                phi_3861_ = _e4765;
                                            } else {
                                                phi_3859_ = f64();
                                                phi_3860_ = true;
                                                phi_3861_ = false;
                                            }
                                            let _e4767 = phi_3859_;
                                            let _e4769 = phi_3860_;
                                            let _e4771 = phi_3861_;
                                            if _e4769 {
                                                phi_3866_ = f64(2f);
                                                phi_3867_ = true;
                                            } else {
                                                phi_3866_ = _e3986;
                                                phi_3867_ = _e4771;
                                            }
                                            let _e4774 = phi_3866_;
                                            let _e4776 = phi_3867_;
                                            if _e4776 {
                                                phi_3871_ = _e4774;
                                            } else {
                                                phi_3871_ = _e4767;
                                            }
                                            let _e4778 = phi_3871_;
                                            if (_e4729 < _e4778) {
                                                phi_3876_ = _e4729;
                                            } else {
                                                phi_3876_ = _e4778;
                                            }
                                            let _e4781 = phi_3876_;
                                            if (_e4680 < _e4781) {
                                                phi_3881_ = _e4680;
                                            } else {
                                                phi_3881_ = _e4781;
                                            }
                                            let _e4784 = phi_3881_;
                                            if (_e4784 > _e3986) {
                                                phi_3886_ = _e4784;
                                            } else {
                                                phi_3886_ = _e3986;
                                            }
                                            let _e4787 = phi_3886_;
                                            let _e4788 = (_e4787 > _e3752);
                                            if _e4788 {
                                                phi_3897_ = f64();
                                                phi_3898_ = false;
                                            } else {
                                                if _e3992 {
                                                    phi_3896_ = (_e4317 + _e4317);
                                                } else {
                                                    phi_3896_ = (_e3752 - _e3986);
                                                }
                                                let _e4792 = phi_3896_;
                                                phi_3897_ = _e4792;
                                                phi_3898_ = true;
                                            }
                                            let _e4794 = phi_3897_;
                                            let _e4796 = phi_3898_;
                                            phi_3899_ = _e4787;
                                            phi_3900_ = _e4794;
                                            phi_3901_ = _e4796;
                                            phi_3902_ = _e4788;
                                            phi_3903_ = false;
                                        } else {
                                            phi_3899_ = f64();
                                            phi_3900_ = f64();
                                            phi_3901_ = false;
                                            phi_3902_ = false;
                                            phi_3903_ = true;
                                        }
                                        let _e4798 = phi_3899_;
                                        let _e4800 = phi_3900_;
                                        let _e4802 = phi_3901_;
                                        let _e4804 = phi_3902_;
                                        let _e4806 = phi_3903_;
                                        phi_3904_ = _e4798;
                                        phi_3905_ = _e4800;
                                        phi_3906_ = false;
                                        phi_3907_ = _e4802;
                                        phi_3908_ = _e4804;
                                        phi_3909_ = _e4806;
                                    } else {
                                        phi_3904_ = f64();
                                        phi_3905_ = f64();
                                        phi_3906_ = true;
                                        phi_3907_ = false;
                                        phi_3908_ = false;
                                        phi_3909_ = false;
                                    }
                                    let _e4808 = phi_3904_;
                                    let _e4810 = phi_3905_;
                                    let _e4812 = phi_3906_;
                                    let _e4814 = phi_3907_;
                                    let _e4816 = phi_3908_;
                                    let _e4818 = phi_3909_;
                                    phi_3910_ = _e4808;
                                    phi_3911_ = _e4810;
                                    phi_3912_ = _e4812;
                                    phi_3913_ = _e4814;
                                    phi_3914_ = _e4816;
                                    phi_3915_ = _e4818;
                                } else {
                                    phi_3910_ = f64();
                                    phi_3911_ = f64();
                                    phi_3912_ = true;
                                    phi_3913_ = false;
                                    phi_3914_ = false;
                                    phi_3915_ = false;
                                }
                                let _e4820 = phi_3910_;
                                let _e4822 = phi_3911_;
                                let _e4824 = phi_3912_;
                                let _e4826 = phi_3913_;
                                let _e4828 = phi_3914_;
                                let _e4830 = phi_3915_;
                                if _e4824 {
                                    if (_e3986 <= _e3988) {
                                        let _e4996 = (_e3994 + 1u);
                                        let _e4997 = (_e4996 > 3u);
                                        if _e4997 {
                                            phi_3928_ = false;
                                        } else {
                                            phi_3928_ = true;
                                        }
                                        let _e4999 = phi_3928_;
                                        phi_4255_ = _e4996;
                                        phi_4256_ = f64();
                                        phi_4257_ = false;
                                        phi_4258_ = _e4999;
                                        phi_4259_ = _e4997;
                                    } else {
                                        let _e4834 = local_9.member[0u];
                                        let _e4837 = local_9.member_1[0u];
                                        let _e4840 = local_9.member[0u];
                                        let _e4846 = local_9.member_2[0u];
                                        let _e4847 = ((_e4834 + ((_e4837 - _e4840) * _e3990)) - _e4846);
                                        let _e4850 = local_9.member[1u];
                                        let _e4853 = local_9.member_1[1u];
                                        let _e4856 = local_9.member[1u];
                                        let _e4862 = local_9.member_2[1u];
                                        let _e4863 = ((_e4850 + ((_e4853 - _e4856) * _e3990)) - _e4862);
                                        if (_e4847 < _e4863) {
                                            phi_4001_ = _e4847;
                                        } else {
                                            phi_4001_ = _e4863;
                                        }
                                        let _e4866 = phi_4001_;
                                        let _e4869 = local_9.member[2u];
                                        let _e4872 = local_9.member_1[2u];
                                        let _e4875 = local_9.member[2u];
                                        let _e4881 = local_9.member_2[2u];
                                        let _e4882 = ((_e4869 + ((_e4872 - _e4875) * _e3990)) - _e4881);
                                        let _e4885 = local_9.member[3u];
                                        let _e4888 = local_9.member_1[3u];
                                        let _e4891 = local_9.member[3u];
                                        let _e4897 = local_9.member_2[3u];
                                        let _e4898 = ((_e4885 + ((_e4888 - _e4891) * _e3990)) - _e4897);
                                        if (_e4882 < _e4898) {
                                            phi_4074_ = _e4882;
                                        } else {
                                            phi_4074_ = _e4898;
                                        }
                                        let _e4901 = phi_4074_;
                                        if (_e4866 < _e4901) {
                                            phi_4079_ = _e4866;
                                        } else {
                                            phi_4079_ = _e4901;
                                        }
                                        let _e4904 = phi_4079_;
                                        let _e4907 = local_10.member[0u];
                                        let _e4910 = local_10.member_1[0u];
                                        let _e4913 = local_10.member[0u];
                                        let _e4919 = local_10.member_2[0u];
                                        let _e4920 = ((_e4907 + ((_e4910 - _e4913) * _e3986)) - _e4919);
                                        let _e4923 = local_10.member[1u];
                                        let _e4926 = local_10.member_1[1u];
                                        let _e4929 = local_10.member[1u];
                                        let _e4935 = local_10.member_2[1u];
                                        let _e4936 = ((_e4923 + ((_e4926 - _e4929) * _e3986)) - _e4935);
                                        if (_e4920 < _e4936) {
                                            phi_4152_ = _e4920;
                                        } else {
                                            phi_4152_ = _e4936;
                                        }
                                        let _e4939 = phi_4152_;
                                        let _e4942 = local_10.member[2u];
                                        let _e4945 = local_10.member_1[2u];
                                        let _e4948 = local_10.member[2u];
                                        let _e4954 = local_10.member_2[2u];
                                        let _e4955 = ((_e4942 + ((_e4945 - _e4948) * _e3986)) - _e4954);
                                        let _e4958 = local_10.member[3u];
                                        let _e4961 = local_10.member_1[3u];
                                        let _e4964 = local_10.member[3u];
                                        let _e4970 = local_10.member_2[3u];
                                        let _e4971 = ((_e4958 + ((_e4961 - _e4964) * _e3986)) - _e4970);
                                        if (_e4955 < _e4971) {
                                            phi_4225_ = _e4955;
                                        } else {
                                            phi_4225_ = _e4971;
                                        }
                                        let _e4974 = phi_4225_;
                                        if (_e4939 < _e4974) {
                                            phi_4230_ = _e4939;
                                        } else {
                                            phi_4230_ = _e4974;
                                        }
                                        let _e4977 = phi_4230_;
                                        let _e4978 = f64(0.0625f);
                                        let _e4980 = f64(0.9f);
                                        if (_e4977 > f64(0f)) {
                                            phi_4253_ = f64(0.5f);
                                        } else {
                                            let _e4986 = (f64(0.95f) * (_e4904 / (_e4904 - _e4977)));
                                            if (_e4986 > _e4978) {
                                                if (_e4986 < _e4980) {
                                                    phi_4251_ = _e4986;
                                                } else {
                                                    phi_4251_ = _e4980;
                                                }
                                                let _e4990 = phi_4251_;
                                                phi_4252_ = _e4990;
                                            } else {
                                                phi_4252_ = _e4978;
                                            }
                                            let _e4992 = phi_4252_;
                                            phi_4253_ = _e4992;
                                        }
                                        let _e4994 = phi_4253_;
                                        phi_4255_ = u32();
                                        phi_4256_ = (_e4317 * _e4994);
                                        phi_4257_ = true;
                                        phi_4258_ = false;
                                        phi_4259_ = false;
                                    }
                                    let _e5001 = phi_4255_;
                                    let _e5003 = phi_4256_;
                                    let _e5005 = phi_4257_;
                                    let _e5007 = phi_4258_;
                                    let _e5009 = phi_4259_;
                                    phi_4260_ = _e5001;
                                    phi_4261_ = _e3988;
                                    phi_4262_ = _e5003;
                                    phi_4263_ = _e3990;
                                    phi_4264_ = _e3992;
                                    phi_4265_ = _e3994;
                                    phi_4266_ = _e5005;
                                    phi_4267_ = _e5007;
                                    phi_4268_ = _e5009;
                                    phi_4269_ = false;
                                    phi_4270_ = false;
                                } else {
                                    phi_4260_ = u32();
                                    phi_4261_ = _e4820;
                                    phi_4262_ = _e4822;
                                    phi_4263_ = _e3986;
                                    phi_4264_ = true;
                                    phi_4265_ = 0u;
                                    phi_4266_ = _e4826;
                                    phi_4267_ = false;
                                    phi_4268_ = false;
                                    phi_4269_ = _e4828;
                                    phi_4270_ = _e4830;
                                }
                                let _e5011 = phi_4260_;
                                let _e5013 = phi_4261_;
                                let _e5015 = phi_4262_;
                                let _e5017 = phi_4263_;
                                let _e5019 = phi_4264_;
                                let _e5021 = phi_4265_;
                                let _e5023 = phi_4266_;
                                let _e5025 = phi_4267_;
                                let _e5027 = phi_4268_;
                                let _e5029 = phi_4269_;
                                let _e5031 = phi_4270_;
                                if _e5023 {
                                    let _e5032 = (_e5017 + _e5015);
                                    if (_e5032 > _e5013) {
                                        phi_4279_ = _e5032;
                                    } else {
                                        phi_4279_ = _e5013;
                                    }
                                    let _e5035 = phi_4279_;
                                    if (_e5035 < _e3752) {
                                        phi_4284_ = _e5035;
                                    } else {
                                        phi_4284_ = _e3752;
                                    }
                                    let _e5038 = phi_4284_;
                                    if !(_e3992) {
                                        phi_4294_ = true;
                                    } else {
                                        phi_4294_ = ((_e5038 - _e5017) > f64(0.0000000037252903f));
                                    }
                                    let _e5043 = phi_4294_;
                                    if _e5043 {
                                        phi_4298_ = false;
                                    } else {
                                        phi_4298_ = true;
                                    }
                                    let _e5045 = phi_4298_;
                                    phi_4299_ = _e5038;
                                    phi_4300_ = _e5013;
                                    phi_4301_ = _e5017;
                                    phi_4302_ = _e5019;
                                    phi_4303_ = _e5021;
                                    phi_4304_ = _e5043;
                                    phi_4305_ = _e5045;
                                    phi_4306_ = false;
                                    phi_4307_ = false;
                                    phi_4308_ = false;
                                } else {
                                    phi_4299_ = _e3986;
                                    phi_4300_ = _e3988;
                                    phi_4301_ = _e3990;
                                    phi_4302_ = _e3992;
                                    phi_4303_ = _e5011;
                                    phi_4304_ = _e5025;
                                    phi_4305_ = false;
                                    phi_4306_ = _e5027;
                                    phi_4307_ = _e5029;
                                    phi_4308_ = _e5031;
                                }
                                let _e5047 = phi_4299_;
                                let _e5049 = phi_4300_;
                                let _e5051 = phi_4301_;
                                let _e5053 = phi_4302_;
                                let _e5055 = phi_4303_;
                                let _e5057 = phi_4304_;
                                let _e5059 = phi_4305_;
                                let _e5061 = phi_4306_;
                                let _e5063 = phi_4307_;
                                let _e5065 = phi_4308_;
                                phi_2609_ = _e5047;
                                phi_2611_ = _e5049;
                                phi_2613_ = _e5051;
                                phi_2615_ = _e5053;
                                phi_2617_ = _e5055;
                                phi_4309_ = _e5013;
                                phi_4310_ = _e5057;
                                phi_4311_ = _e5059;
                                phi_4312_ = false;
                                phi_4313_ = _e5061;
                                phi_4314_ = _e5063;
                                phi_4315_ = _e5065;
                            } else {
                                phi_2609_ = f64();
                                phi_2611_ = f64();
                                phi_2613_ = f64();
                                phi_2615_ = bool();
                                phi_2617_ = u32();
                                phi_4309_ = f64();
                                phi_4310_ = false;
                                phi_4311_ = false;
                                phi_4312_ = true;
                                phi_4313_ = false;
                                phi_4314_ = false;
                                phi_4315_ = false;
                            }
                            let _e5067 = phi_2609_;
                            let _e5069 = phi_2611_;
                            let _e5071 = phi_2613_;
                            let _e5073 = phi_2615_;
                            let _e5075 = phi_2617_;
                            let _e5077 = phi_4309_;
                            let _e5079 = phi_4310_;
                            let _e5081 = phi_4311_;
                            let _e5083 = phi_4312_;
                            let _e5085 = phi_4313_;
                            let _e5087 = phi_4314_;
                            let _e5089 = phi_4315_;
                            local_25 = _e5081;
                            local_43 = _e5077;
                            local_45 = _e5083;
                            local_46 = _e5085;
                            local_47 = _e5087;
                            local_48 = _e5089;
                            continue;
                            continuing {
                                phi_2605_ = _e4006;
                                phi_2608_ = _e5067;
                                phi_2610_ = _e5069;
                                phi_2612_ = _e5071;
                                phi_2614_ = _e5073;
                                phi_2616_ = _e5075;
                                break if !(_e5079);
                            }
                        }
                        let _e5092 = local_25;
                        if _e5092 {
                            let _e6417 = local_43;
                            phi_4319_ = _e6417;
                            phi_4320_ = true;
                            phi_4321_ = false;
                            phi_4322_ = false;
                            phi_4323_ = false;
                        } else {
                            let _e6419 = local_44;
                            phi_4319_ = _e6419;
                            let _e6422 = local_45;
                            phi_4320_ = _e6422;
                            let _e6425 = local_46;
                            phi_4321_ = _e6425;
                            let _e6428 = local_47;
                            phi_4322_ = _e6428;
                            let _e6431 = local_48;
                            phi_4323_ = _e6431;
                        }
                        let _e5094 = phi_4319_;
                        let _e5096 = phi_4320_;
                        let _e5098 = phi_4321_;
                        let _e5100 = phi_4322_;
                        let _e5102 = phi_4323_;
                        if _e5096 {
                            phi_4328_ = type_44(1u, _e5094);
                            phi_4329_ = false;
                            phi_4330_ = false;
                            phi_4331_ = false;
                        } else {
                            phi_4328_ = type_44();
                            phi_4329_ = _e5098;
                            phi_4330_ = _e5100;
                            phi_4331_ = _e5102;
                        }
                        let _e5105 = phi_4328_;
                        let _e5107 = phi_4329_;
                        let _e5109 = phi_4330_;
                        let _e5111 = phi_4331_;
                        if _e5107 {
                            let _e5113 = local_26;
                            phi_4336_ = type_44(1u, _e5113);
                            phi_4337_ = false;
                            phi_4338_ = false;
                        } else {
                            phi_4336_ = type_44();
                            phi_4337_ = _e5109;
                            phi_4338_ = _e5111;
                        }
                        let _e5116 = phi_4336_;
                        let _e5118 = phi_4337_;
                        let _e5120 = phi_4338_;
                        if _e5118 {
                            phi_4343_ = type_44(0u, type_44().member_1);
                            phi_4344_ = false;
                            phi_4345_ = true;
                        } else {
                            phi_4343_ = _e5116;
                            phi_4344_ = _e5120;
                            phi_4345_ = _e5107;
                        }
                        let _e5124 = phi_4343_;
                        let _e5126 = phi_4344_;
                        let _e5128 = phi_4345_;
                        if _e5126 {
                            phi_4350_ = type_44(0u, type_44().member_1);
                            phi_4351_ = true;
                        } else {
                            phi_4350_ = _e5124;
                            phi_4351_ = _e5128;
                        }
                        let _e5132 = phi_4350_;
                        let _e5134 = phi_4351_;
                        if _e5134 {
                            phi_4355_ = _e5132;
                        } else {
                            phi_4355_ = _e5105;
                        }
                        let _e5136 = phi_4355_;
                        if (_e5136.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4369_ = type_9(0u, 3u);
                            loop {
                                let _e5148 = phi_4369_;
                                if (_e5148.member < _e5148.member_1) {
                                    phi_4370_ = type_9((_e5148.member + 1u), _e5148.member_1);
                                    phi_4393_ = type_9(1u, _e5148.member);
                                } else {
                                    phi_4370_ = _e5148;
                                    phi_4393_ = type_9(0u, type_9().member_1);
                                }
                                let _e5160 = phi_4370_;
                                let _e5162 = phi_4393_;
                                if (bitcast<i32>(_e5162.member) != 0i) {
                                    let _e5168 = local_11[_e5162.member_1];
                                    let _e5170 = (_e5136.member_1 + f64(_e5168));
                                    if (_e5170 < _e3752) {
                                        phi_4414_ = _e5170;
                                    } else {
                                        phi_4414_ = _e3752;
                                    }
                                    let _e5173 = phi_4414_;
                                    let _e5176 = local_12.member[0u];
                                    let _e5182 = local_12.member[1u];
                                    let _e5198 = local_12.member_1[0u];
                                    let _e5204 = local_12.member_1[1u];
                                    let _e5220 = local_12.member_2[0u];
                                    let _e5226 = local_12.member_2[1u];
                                    let _e5240 = function_2(array<f64, 3>((_e5176[0] + ((_e5182[0] - _e5176[0]) * _e5173)), (_e5176[1] + ((_e5182[1] - _e5176[1]) * _e5173)), (_e5176[2] + ((_e5182[2] - _e5176[2]) * _e5173))), array<f64, 3>((_e5198[0] + ((_e5204[0] - _e5198[0]) * _e5173)), (_e5198[1] + ((_e5204[1] - _e5198[1]) * _e5173)), (_e5198[2] + ((_e5204[2] - _e5198[2]) * _e5173))), array<f64, 3>((_e5220[0] + ((_e5226[0] - _e5220[0]) * _e5173)), (_e5220[1] + ((_e5226[1] - _e5220[1]) * _e5173)), (_e5220[2] + ((_e5226[2] - _e5220[2]) * _e5173))), 0u);
                                    let _e5251 = (((_e5240[0] * _e5240[0]) + (_e5240[1] * _e5240[1])) + (_e5240[2] * _e5240[2]));
                                    if (_e5251 <= 2.2250738585072014e-308lf) {
                                        if (_e5251 > 0.0lf) {
                                            phi_4537_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_4537_ = 0.0lf;
                                        }
                                        let _e5303 = phi_4537_;
                                        phi_4601_ = _e5303;
                                    } else {
                                        phi_4544_ = type_16(0i, 5i);
                                        phi_4547_ = bitcast<f64>(((bitcast<u64>(_e5251) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5258 = phi_4544_;
                                            let _e5260 = phi_4547_;
                                            local_27 = _e5260;
                                            if (_e5258.member < _e5258.member_1) {
                                                let _e5267 = (_e5258.member + 1i);
                                                if ((false == (_e5267 > _e5258.member)) != false) {
                                                    phi_4568_ = true;
                                                } else {
                                                    phi_4568_ = false;
                                                }
                                                let _e5272 = phi_4568_;
                                                if _e5272 {
                                                    phi_4574_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4574_ = type_17(1u, _e5267);
                                                }
                                                let _e5277 = phi_4574_;
                                                phi_4545_ = type_16(_e5277.member_1, _e5258.member_1);
                                                phi_4588_ = type_17(1u, _e5258.member);
                                            } else {
                                                phi_4545_ = _e5258;
                                                phi_4588_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5283 = phi_4545_;
                                            let _e5285 = phi_4588_;
                                            let _e5288 = (bitcast<i32>(_e5285.member) != 0i);
                                            if _e5288 {
                                                phi_4548_ = (0.5lf * (_e5260 + (_e5251 / _e5260)));
                                            } else {
                                                phi_4548_ = f64();
                                            }
                                            let _e5293 = phi_4548_;
                                            continue;
                                            continuing {
                                                phi_4544_ = _e5283;
                                                phi_4547_ = _e5293;
                                                break if !(_e5288);
                                            }
                                        }
                                        let _e5298 = local_27;
                                        phi_4601_ = (_e5298 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5305 = phi_4601_;
                                    let _e5313 = local_12.member[0u];
                                    if (_e5313[0] < 0.0lf) {
                                        phi_4619_ = -(_e5313[0]);
                                    } else {
                                        phi_4619_ = _e5313[0];
                                    }
                                    let _e5320 = phi_4619_;
                                    if (_e5313[1] < 0.0lf) {
                                        phi_4626_ = -(_e5313[1]);
                                    } else {
                                        phi_4626_ = _e5313[1];
                                    }
                                    let _e5324 = phi_4626_;
                                    if (_e5320 > _e5324) {
                                        phi_4631_ = _e5320;
                                    } else {
                                        phi_4631_ = _e5324;
                                    }
                                    let _e5327 = phi_4631_;
                                    if (_e5313[2] < 0.0lf) {
                                        phi_4638_ = -(_e5313[2]);
                                    } else {
                                        phi_4638_ = _e5313[2];
                                    }
                                    let _e5331 = phi_4638_;
                                    if (_e5327 > _e5331) {
                                        phi_4643_ = _e5327;
                                    } else {
                                        phi_4643_ = _e5331;
                                    }
                                    let _e5334 = phi_4643_;
                                    let _e5337 = local_12.member[1u];
                                    if (_e5337[0] < 0.0lf) {
                                        phi_4656_ = -(_e5337[0]);
                                    } else {
                                        phi_4656_ = _e5337[0];
                                    }
                                    let _e5344 = phi_4656_;
                                    if (_e5337[1] < 0.0lf) {
                                        phi_4663_ = -(_e5337[1]);
                                    } else {
                                        phi_4663_ = _e5337[1];
                                    }
                                    let _e5348 = phi_4663_;
                                    if (_e5344 > _e5348) {
                                        phi_4668_ = _e5344;
                                    } else {
                                        phi_4668_ = _e5348;
                                    }
                                    let _e5351 = phi_4668_;
                                    if (_e5337[2] < 0.0lf) {
                                        phi_4675_ = -(_e5337[2]);
                                    } else {
                                        phi_4675_ = _e5337[2];
                                    }
                                    let _e5355 = phi_4675_;
                                    if (_e5351 > _e5355) {
                                        phi_4680_ = _e5351;
                                    } else {
                                        phi_4680_ = _e5355;
                                    }
                                    let _e5358 = phi_4680_;
                                    if (_e5334 > _e5358) {
                                        phi_4685_ = _e5334;
                                    } else {
                                        phi_4685_ = _e5358;
                                    }
                                    let _e5361 = phi_4685_;
                                    let _e5363 = local_12.member_3;
                                    let _e5367 = local_12.member_1[0u];
                                    if (_e5367[0] < 0.0lf) {
                                        phi_4702_ = -(_e5367[0]);
                                    } else {
                                        phi_4702_ = _e5367[0];
                                    }
                                    let _e5374 = phi_4702_;
                                    if (_e5367[1] < 0.0lf) {
                                        phi_4709_ = -(_e5367[1]);
                                    } else {
                                        phi_4709_ = _e5367[1];
                                    }
                                    let _e5378 = phi_4709_;
                                    if (_e5374 > _e5378) {
                                        phi_4714_ = _e5374;
                                    } else {
                                        phi_4714_ = _e5378;
                                    }
                                    let _e5381 = phi_4714_;
                                    if (_e5367[2] < 0.0lf) {
                                        phi_4721_ = -(_e5367[2]);
                                    } else {
                                        phi_4721_ = _e5367[2];
                                    }
                                    let _e5385 = phi_4721_;
                                    if (_e5381 > _e5385) {
                                        phi_4726_ = _e5381;
                                    } else {
                                        phi_4726_ = _e5385;
                                    }
                                    let _e5388 = phi_4726_;
                                    let _e5391 = local_12.member_1[1u];
                                    if (_e5391[0] < 0.0lf) {
                                        phi_4740_ = -(_e5391[0]);
                                    } else {
                                        phi_4740_ = _e5391[0];
                                    }
                                    let _e5398 = phi_4740_;
                                    if (_e5391[1] < 0.0lf) {
                                        phi_4747_ = -(_e5391[1]);
                                    } else {
                                        phi_4747_ = _e5391[1];
                                    }
                                    let _e5402 = phi_4747_;
                                    if (_e5398 > _e5402) {
                                        phi_4752_ = _e5398;
                                    } else {
                                        phi_4752_ = _e5402;
                                    }
                                    let _e5405 = phi_4752_;
                                    if (_e5391[2] < 0.0lf) {
                                        phi_4759_ = -(_e5391[2]);
                                    } else {
                                        phi_4759_ = _e5391[2];
                                    }
                                    let _e5409 = phi_4759_;
                                    if (_e5405 > _e5409) {
                                        phi_4764_ = _e5405;
                                    } else {
                                        phi_4764_ = _e5409;
                                    }
                                    let _e5412 = phi_4764_;
                                    if (_e5388 > _e5412) {
                                        phi_4769_ = _e5388;
                                    } else {
                                        phi_4769_ = _e5412;
                                    }
                                    let _e5415 = phi_4769_;
                                    let _e5417 = local_12.member_3;
                                    let _e5421 = local_12.member_2[0u];
                                    if (_e5421[0] < 0.0lf) {
                                        phi_4786_ = -(_e5421[0]);
                                    } else {
                                        phi_4786_ = _e5421[0];
                                    }
                                    let _e5428 = phi_4786_;
                                    if (_e5421[1] < 0.0lf) {
                                        phi_4793_ = -(_e5421[1]);
                                    } else {
                                        phi_4793_ = _e5421[1];
                                    }
                                    let _e5432 = phi_4793_;
                                    if (_e5428 > _e5432) {
                                        phi_4798_ = _e5428;
                                    } else {
                                        phi_4798_ = _e5432;
                                    }
                                    let _e5435 = phi_4798_;
                                    if (_e5421[2] < 0.0lf) {
                                        phi_4805_ = -(_e5421[2]);
                                    } else {
                                        phi_4805_ = _e5421[2];
                                    }
                                    let _e5439 = phi_4805_;
                                    if (_e5435 > _e5439) {
                                        phi_4810_ = _e5435;
                                    } else {
                                        phi_4810_ = _e5439;
                                    }
                                    let _e5442 = phi_4810_;
                                    let _e5445 = local_12.member_2[1u];
                                    if (_e5445[0] < 0.0lf) {
                                        phi_4824_ = -(_e5445[0]);
                                    } else {
                                        phi_4824_ = _e5445[0];
                                    }
                                    let _e5452 = phi_4824_;
                                    if (_e5445[1] < 0.0lf) {
                                        phi_4831_ = -(_e5445[1]);
                                    } else {
                                        phi_4831_ = _e5445[1];
                                    }
                                    let _e5456 = phi_4831_;
                                    if (_e5452 > _e5456) {
                                        phi_4836_ = _e5452;
                                    } else {
                                        phi_4836_ = _e5456;
                                    }
                                    let _e5459 = phi_4836_;
                                    if (_e5445[2] < 0.0lf) {
                                        phi_4843_ = -(_e5445[2]);
                                    } else {
                                        phi_4843_ = _e5445[2];
                                    }
                                    let _e5463 = phi_4843_;
                                    if (_e5459 > _e5463) {
                                        phi_4848_ = _e5459;
                                    } else {
                                        phi_4848_ = _e5463;
                                    }
                                    let _e5466 = phi_4848_;
                                    if (_e5442 > _e5466) {
                                        phi_4853_ = _e5442;
                                    } else {
                                        phi_4853_ = _e5466;
                                    }
                                    let _e5469 = phi_4853_;
                                    let _e5471 = local_12.member_3;
                                    let _e5479 = local_12.member_3;
                                    let _e5489 = (((_e5305 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5361 + _e5363) + (_e5415 + _e5417)) + (_e5469 + _e5471)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5479 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e575.member_1);
                                    if _e5489 {
                                        phi_4877_ = false;
                                    } else {
                                        phi_4877_ = true;
                                    }
                                    let _e5491 = phi_4877_;
                                    phi_4878_ = _e5491;
                                    phi_4879_ = _e5489;
                                } else {
                                    phi_4878_ = false;
                                    phi_4879_ = false;
                                }
                                let _e5493 = phi_4878_;
                                let _e5495 = phi_4879_;
                                local_28 = _e5495;
                                continue;
                                continuing {
                                    phi_4369_ = _e5160;
                                    break if !(_e5493);
                                }
                            }
                            let _e5498 = local_28;
                            if _e5498 {
                                phi_4884_ = type_44(1u, _e5136.member_1);
                                phi_4885_ = false;
                            } else {
                                phi_4884_ = type_44();
                                phi_4885_ = true;
                            }
                            let _e5501 = phi_4884_;
                            let _e5503 = phi_4885_;
                            if _e5503 {
                                phi_4890_ = type_44(2u, _e5136.member_1);
                                phi_4891_ = false;
                            } else {
                                phi_4890_ = type_44();
                                phi_4891_ = true;
                            }
                            let _e5506 = phi_4890_;
                            let _e5508 = phi_4891_;
                            phi_4893_ = _e5506;
                            phi_4894_ = _e5501;
                            phi_4895_ = _e5508;
                        } else {
                            phi_4893_ = type_44();
                            phi_4894_ = type_44(0u, type_44().member_1);
                            phi_4895_ = true;
                        }
                        let _e5510 = phi_4893_;
                        let _e5512 = phi_4894_;
                        let _e5514 = phi_4895_;
                        if _e5514 {
                            phi_4899_ = _e5512;
                        } else {
                            phi_4899_ = _e5510;
                        }
                        let _e5516 = phi_4899_;
                        phi_8924_ = _e5516;
                    } else {
                        if (_e713 < 0.0lf) {
                            phi_4910_ = -(_e713);
                        } else {
                            phi_4910_ = _e713;
                        }
                        let _e1070 = phi_4910_;
                        if (_e736 < 0.0lf) {
                            phi_4916_ = -(_e736);
                        } else {
                            phi_4916_ = _e736;
                        }
                        let _e1074 = phi_4916_;
                        if (_e1070 > _e1074) {
                            phi_4921_ = _e1070;
                        } else {
                            phi_4921_ = _e1074;
                        }
                        let _e1077 = phi_4921_;
                        if (_e759 < 0.0lf) {
                            phi_4927_ = -(_e759);
                        } else {
                            phi_4927_ = _e759;
                        }
                        let _e1081 = phi_4927_;
                        if (_e770 < 0.0lf) {
                            phi_4933_ = -(_e770);
                        } else {
                            phi_4933_ = _e770;
                        }
                        let _e1085 = phi_4933_;
                        if (_e1081 > _e1085) {
                            phi_4938_ = _e1081;
                        } else {
                            phi_4938_ = _e1085;
                        }
                        let _e1088 = phi_4938_;
                        if (_e1077 > _e1088) {
                            phi_4943_ = _e1077;
                        } else {
                            phi_4943_ = _e1088;
                        }
                        let _e1091 = phi_4943_;
                        let _e1093 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1094 = f64(1f);
                        if (_e1091 >= _e1093) {
                            phi_4953_ = (_e1091 <= (_e1094 / _e1093));
                        } else {
                            phi_4953_ = false;
                        }
                        let _e1099 = phi_4953_;
                        if _e1099 {
                            phi_4960_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4960_ = f64(2f);
                        }
                        let _e1104 = phi_4960_;
                        let _e1106 = ((_e1029 * f64(0.34f)) + (_e1091 * _e1104));
                        if _e1099 {
                            phi_4968_ = (_e1094 / _e1091);
                        } else {
                            phi_4968_ = f64(0f);
                        }
                        let _e1110 = phi_4968_;
                        let _e1111 = f64(0f);
                        let _e1112 = f64(1f);
                        let _e1113 = f64(3f);
                        let _e1119 = ((_e736 - (_e1113 * _e713)) * _e1110);
                        let _e1120 = ((_e759 - _e736) * _e1110);
                        let _e1121 = (((_e1113 * _e770) - _e759) * _e1110);
                        local_6[0u] = _e1111;
                        local_6[1u] = _e1112;
                        local_6[2u] = _e1112;
                        local_6[3u] = _e1112;
                        let _e1128 = ((_e1120 * _e1120) - (_e1119 * _e1121));
                        if (_e1128 > _e1111) {
                            if (_e1128 <= 2.2250738585072014e-308lf) {
                                if (_e1128 > 0.0lf) {
                                    phi_5004_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_5004_ = 0.0lf;
                                }
                                let _e1181 = phi_5004_;
                                phi_5068_ = _e1181;
                            } else {
                                phi_5011_ = type_16(0i, 5i);
                                phi_5014_ = bitcast<f64>(((bitcast<u64>(_e1128) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1136 = phi_5011_;
                                    let _e1138 = phi_5014_;
                                    local_13 = _e1138;
                                    if (_e1136.member < _e1136.member_1) {
                                        let _e1145 = (_e1136.member + 1i);
                                        if ((false == (_e1145 > _e1136.member)) != false) {
                                            phi_5035_ = true;
                                        } else {
                                            phi_5035_ = false;
                                        }
                                        let _e1150 = phi_5035_;
                                        if _e1150 {
                                            phi_5041_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_5041_ = type_17(1u, _e1145);
                                        }
                                        let _e1155 = phi_5041_;
                                        phi_5012_ = type_16(_e1155.member_1, _e1136.member_1);
                                        phi_5055_ = type_17(1u, _e1136.member);
                                    } else {
                                        phi_5012_ = _e1136;
                                        phi_5055_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1161 = phi_5012_;
                                    let _e1163 = phi_5055_;
                                    let _e1166 = (bitcast<i32>(_e1163.member) != 0i);
                                    if _e1166 {
                                        phi_5015_ = (0.5lf * (_e1138 + (_e1128 / _e1138)));
                                    } else {
                                        phi_5015_ = f64();
                                    }
                                    let _e1171 = phi_5015_;
                                    continue;
                                    continuing {
                                        phi_5011_ = _e1161;
                                        phi_5014_ = _e1171;
                                        break if !(_e1166);
                                    }
                                }
                                let _e1176 = local_13;
                                phi_5068_ = (_e1176 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1183 = phi_5068_;
                            if (_e1120 < _e1111) {
                                phi_5074_ = -(_e1183);
                            } else {
                                phi_5074_ = _e1183;
                            }
                            let _e1187 = phi_5074_;
                            let _e1189 = -((_e1120 + _e1187));
                            local_7[0u] = (_e1189 / (_e1189 + _e1121));
                            local_7[1u] = (_e1119 / (_e1119 + _e1189));
                            let _e1198 = local_7[1u];
                            let _e1199 = local_7[0u];
                            if (_e1198 < _e1199) {
                                let _e1202 = local_7[1u];
                                let _e1204 = local_7[0u];
                                local_7[0u] = _e1202;
                                local_7[1u] = _e1204;
                            }
                            phi_5099_ = type_9(0u, 2u);
                            phi_5102_ = 1u;
                            loop {
                                let _e1208 = phi_5099_;
                                let _e1210 = phi_5102_;
                                local_29 = _e1210;
                                if (_e1208.member < _e1208.member_1) {
                                    phi_5100_ = type_9((_e1208.member + 1u), _e1208.member_1);
                                    phi_5125_ = type_9(1u, _e1208.member);
                                } else {
                                    phi_5100_ = _e1208;
                                    phi_5125_ = type_9(0u, type_9().member_1);
                                }
                                let _e1222 = phi_5100_;
                                let _e1224 = phi_5125_;
                                let _e1228 = (bitcast<i32>(_e1224.member) != 0i);
                                if _e1228 {
                                    let _e1230 = local_7[_e1224.member_1];
                                    if (_e1230 > _e1111) {
                                        let _e1233 = local_7[_e1224.member_1];
                                        if (_e1233 < _e1112) {
                                            let _e1236 = local_7[_e1224.member_1];
                                            local_6[_e1210] = _e1236;
                                            phi_5169_ = (_e1210 + 1u);
                                        } else {
                                            phi_5169_ = _e1210;
                                        }
                                        let _e1240 = phi_5169_;
                                        phi_5170_ = _e1240;
                                    } else {
                                        phi_5170_ = _e1210;
                                    }
                                    let _e1242 = phi_5170_;
                                    phi_5103_ = _e1242;
                                } else {
                                    phi_5103_ = u32();
                                }
                                let _e1244 = phi_5103_;
                                continue;
                                continuing {
                                    phi_5099_ = _e1222;
                                    phi_5102_ = _e1244;
                                    break if !(_e1228);
                                }
                            }
                            let _e5742 = local_29;
                            phi_5171_ = _e5742;
                        } else {
                            phi_5171_ = 1u;
                        }
                        let _e1247 = phi_5171_;
                        local_6[_e1247] = _e1112;
                        let _e1249 = local_6;
                        local_8 = _e1249;
                        phi_5191_ = type_9(0u, _e1247);
                        loop {
                            let _e1252 = phi_5191_;
                            if (_e1252.member < _e1252.member_1) {
                                phi_5192_ = type_9((_e1252.member + 1u), _e1252.member_1);
                                phi_5215_ = type_9(1u, _e1252.member);
                            } else {
                                phi_5192_ = _e1252;
                                phi_5215_ = type_9(0u, type_9().member_1);
                            }
                            let _e1264 = phi_5192_;
                            let _e1266 = phi_5215_;
                            if (bitcast<i32>(_e1266.member) != 0i) {
                                let _e1272 = local_8[_e1266.member_1];
                                let _e1275 = local_8[(_e1266.member_1 + 1u)];
                                let _e1277 = (f64(1f) - _e1272);
                                let _e1288 = ((((_e713 * _e1277) + (_e736 * _e1272)) * (_e1277 * _e1277)) + (((_e759 * _e1277) + (_e770 * _e1272)) * (_e1272 * _e1272)));
                                let _e1290 = (f64(1f) - _e1275);
                                let _e1301 = ((((_e713 * _e1290) + (_e736 * _e1275)) * (_e1290 * _e1290)) + (((_e759 * _e1290) + (_e770 * _e1275)) * (_e1275 * _e1275)));
                                if (_e1288 < 0.0lf) {
                                    phi_5269_ = -(_e1288);
                                } else {
                                    phi_5269_ = _e1288;
                                }
                                let _e1305 = phi_5269_;
                                let _e1306 = (_e1305 > _e1106);
                                if (_e1301 < 0.0lf) {
                                    phi_5276_ = -(_e1301);
                                } else {
                                    phi_5276_ = _e1301;
                                }
                                let _e1310 = phi_5276_;
                                let _e1311 = (_e1310 > _e1106);
                                let _e1312 = f64(0f);
                                if _e1306 {
                                    if _e1311 {
                                        phi_5288_ = ((_e1288 > _e1312) != (_e1301 > _e1312));
                                        phi_5289_ = false;
                                    } else {
                                        phi_5288_ = bool();
                                        phi_5289_ = true;
                                    }
                                    let _e1317 = phi_5288_;
                                    let _e1319 = phi_5289_;
                                    phi_5290_ = _e1317;
                                    phi_5291_ = _e1319;
                                } else {
                                    phi_5290_ = bool();
                                    phi_5291_ = true;
                                }
                                let _e1321 = phi_5290_;
                                let _e1323 = phi_5291_;
                                if _e1323 {
                                    phi_5295_ = false;
                                } else {
                                    phi_5295_ = _e1321;
                                }
                                let _e1325 = phi_5295_;
                                if _e1306 {
                                    if _e1311 {
                                        if _e1325 {
                                            phi_5307_ = type_45();
                                        } else {
                                            phi_5307_ = type_45(f64(1f), _e1312, _e1325);
                                        }
                                        let _e1329 = phi_5307_;
                                        phi_5308_ = _e1329;
                                        phi_5309_ = _e1325;
                                    } else {
                                        phi_5308_ = type_45();
                                        phi_5309_ = true;
                                    }
                                    let _e1331 = phi_5308_;
                                    let _e1333 = phi_5309_;
                                    phi_5310_ = _e1331;
                                    phi_5311_ = _e1333;
                                } else {
                                    phi_5310_ = type_45();
                                    phi_5311_ = true;
                                }
                                let _e1335 = phi_5310_;
                                let _e1337 = phi_5311_;
                                if _e1337 {
                                    if _e1306 {
                                        if (_e1288 < _e1312) {
                                            phi_5324_ = f64(-1f);
                                        } else {
                                            phi_5324_ = f64(1f);
                                        }
                                        let _e1342 = phi_5324_;
                                        let _e1343 = f64(0.00000000000022737368f);
                                        let _e1344 = f64(0.5f);
                                        let _e1345 = f64(3f);
                                        let _e1348 = (_e759 - _e736);
                                        phi_5337_ = type_9(0u, 64u);
                                        phi_5340_ = _e1275;
                                        phi_5342_ = _e1272;
                                        phi_5344_ = (_e1344 * (_e1272 + _e1275));
                                        loop {
                                            let _e1354 = phi_5337_;
                                            let _e1356 = phi_5340_;
                                            let _e1358 = phi_5342_;
                                            let _e1360 = phi_5344_;
                                            local_31 = _e1358;
                                            if (_e1354.member < _e1354.member_1) {
                                                phi_5338_ = type_9((_e1354.member + 1u), _e1354.member_1);
                                                phi_5367_ = type_9(1u, _e1354.member);
                                            } else {
                                                phi_5338_ = _e1354;
                                                phi_5367_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1372 = phi_5338_;
                                            let _e1374 = phi_5367_;
                                            if (bitcast<i32>(_e1374.member) != 0i) {
                                                let _e1379 = (f64(1f) - _e1360);
                                                let _e1392 = ((_e1342 * ((((_e713 * _e1379) + (_e736 * _e1360)) * (_e1379 * _e1379)) + (((_e759 * _e1379) + (_e770 * _e1360)) * (_e1360 * _e1360)))) - _e1106);
                                                if (_e1392 > f64(0f)) {
                                                    phi_5394_ = _e1356;
                                                    phi_5395_ = _e1360;
                                                } else {
                                                    phi_5394_ = _e1360;
                                                    phi_5395_ = _e1358;
                                                }
                                                let _e1396 = phi_5394_;
                                                let _e1398 = phi_5395_;
                                                let _e1400 = ((_e1396 - _e1398) > _e1343);
                                                if _e1400 {
                                                    let _e1402 = (f64(1f) - _e1360);
                                                    let _e1414 = (-(_e1392) / (_e1342 * (((((_e736 - (_e1345 * _e713)) * _e1402) + (_e1348 * _e1360)) * _e1402) + (((_e1348 * _e1402) + (((_e1345 * _e770) - _e759) * _e1360)) * _e1360))));
                                                    if (_e1392 > f64(0f)) {
                                                        phi_5423_ = (_e1344 * _e1343);
                                                    } else {
                                                        phi_5423_ = -((_e1344 * _e1343));
                                                    }
                                                    let _e1421 = phi_5423_;
                                                    let _e1423 = ((_e1360 + _e1414) + _e1421);
                                                    if (_e1423 > _e1398) {
                                                        if (_e1423 < _e1396) {
                                                            if (_e1414 < 0.0lf) {
                                                                phi_5439_ = -(_e1414);
                                                            } else {
                                                                phi_5439_ = _e1414;
                                                            }
                                                            let _e1429 = phi_5439_;
                                                            if (_e1429 < (_e1344 * (_e1396 - _e1398))) {
                                                                phi_5446_ = false;
                                                            } else {
                                                                phi_5446_ = true;
                                                            }
                                                            let _e1434 = phi_5446_;
                                                            phi_5447_ = _e1434;
                                                        } else {
                                                            phi_5447_ = true;
                                                        }
                                                        let _e1436 = phi_5447_;
                                                        phi_5448_ = _e1436;
                                                    } else {
                                                        phi_5448_ = true;
                                                    }
                                                    let _e1438 = phi_5448_;
                                                    if _e1438 {
                                                        phi_5454_ = (_e1344 * (_e1398 + _e1396));
                                                    } else {
                                                        phi_5454_ = _e1423;
                                                    }
                                                    let _e1442 = phi_5454_;
                                                    phi_5455_ = _e1442;
                                                    phi_5456_ = false;
                                                } else {
                                                    phi_5455_ = f64();
                                                    phi_5456_ = true;
                                                }
                                                let _e1444 = phi_5455_;
                                                let _e1446 = phi_5456_;
                                                phi_5341_ = _e1396;
                                                phi_5343_ = _e1398;
                                                phi_5345_ = _e1444;
                                                phi_5457_ = _e1398;
                                                phi_5458_ = _e1400;
                                                phi_5459_ = _e1446;
                                            } else {
                                                phi_5341_ = f64();
                                                phi_5343_ = f64();
                                                phi_5345_ = f64();
                                                phi_5457_ = f64();
                                                phi_5458_ = false;
                                                phi_5459_ = false;
                                            }
                                            let _e1448 = phi_5341_;
                                            let _e1450 = phi_5343_;
                                            let _e1452 = phi_5345_;
                                            let _e1454 = phi_5457_;
                                            let _e1456 = phi_5458_;
                                            let _e1458 = phi_5459_;
                                            local_14 = _e1458;
                                            local_30 = _e1454;
                                            continue;
                                            continuing {
                                                phi_5337_ = _e1372;
                                                phi_5340_ = _e1448;
                                                phi_5342_ = _e1450;
                                                phi_5344_ = _e1452;
                                                break if !(_e1456);
                                            }
                                        }
                                        let _e1461 = local_14;
                                        if _e1461 {
                                            let _e5784 = local_30;
                                            phi_5463_ = _e5784;
                                        } else {
                                            let _e5786 = local_31;
                                            phi_5463_ = _e5786;
                                        }
                                        let _e1463 = phi_5463_;
                                        phi_5464_ = _e1463;
                                    } else {
                                        phi_5464_ = _e1272;
                                    }
                                    let _e1465 = phi_5464_;
                                    if _e1311 {
                                        if (_e1301 < _e1312) {
                                            phi_5474_ = f64(-1f);
                                        } else {
                                            phi_5474_ = f64(1f);
                                        }
                                        let _e1470 = phi_5474_;
                                        phi_5479_ = type_9(0u, 64u);
                                        phi_5482_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1474 = phi_5479_;
                                            let _e1476 = phi_5482_;
                                            if (_e1474.member < _e1474.member_1) {
                                                phi_5480_ = type_9((_e1474.member + 1u), _e1474.member_1);
                                                phi_5505_ = type_9(1u, _e1474.member);
                                            } else {
                                                phi_5480_ = _e1474;
                                                phi_5505_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1488 = phi_5480_;
                                            let _e1490 = phi_5505_;
                                            if (bitcast<i32>(_e1490.member) != 0i) {
                                                let _e1494 = (_e1465 + _e1476);
                                                if (_e1494 < _e1275) {
                                                    let _e1497 = (f64(1f) - _e1494);
                                                    let _e1510 = ((_e1470 * ((((_e713 * _e1497) + (_e736 * _e1494)) * (_e1497 * _e1497)) + (((_e759 * _e1497) + (_e770 * _e1494)) * (_e1494 * _e1494)))) > _e1106);
                                                    if _e1510 {
                                                        phi_5536_ = f64();
                                                        phi_5537_ = false;
                                                    } else {
                                                        phi_5536_ = (_e1476 + _e1476);
                                                        phi_5537_ = true;
                                                    }
                                                    let _e1513 = phi_5536_;
                                                    let _e1515 = phi_5537_;
                                                    phi_5538_ = _e1513;
                                                    phi_5539_ = _e1515;
                                                    phi_5540_ = _e1510;
                                                    phi_5541_ = false;
                                                } else {
                                                    phi_5538_ = f64();
                                                    phi_5539_ = false;
                                                    phi_5540_ = false;
                                                    phi_5541_ = true;
                                                }
                                                let _e1517 = phi_5538_;
                                                let _e1519 = phi_5539_;
                                                let _e1521 = phi_5540_;
                                                let _e1523 = phi_5541_;
                                                phi_5542_ = _e1494;
                                                phi_5483_ = _e1517;
                                                phi_5543_ = _e1519;
                                                phi_5544_ = _e1521;
                                                phi_5545_ = _e1523;
                                                phi_5546_ = false;
                                            } else {
                                                phi_5542_ = f64();
                                                phi_5483_ = f64();
                                                phi_5543_ = false;
                                                phi_5544_ = false;
                                                phi_5545_ = false;
                                                phi_5546_ = true;
                                            }
                                            let _e1525 = phi_5542_;
                                            let _e1527 = phi_5483_;
                                            let _e1529 = phi_5543_;
                                            let _e1531 = phi_5544_;
                                            let _e1533 = phi_5545_;
                                            let _e1535 = phi_5546_;
                                            local_15 = _e1531;
                                            local_32 = _e1533;
                                            local_33 = _e1535;
                                            local_34 = _e1525;
                                            continue;
                                            continuing {
                                                phi_5479_ = _e1488;
                                                phi_5482_ = _e1527;
                                                break if !(_e1529);
                                            }
                                        }
                                        let _e1538 = local_15;
                                        if _e1538 {
                                            phi_5550_ = false;
                                            phi_5551_ = false;
                                        } else {
                                            let _e5808 = local_32;
                                            phi_5550_ = _e5808;
                                            let _e5811 = local_33;
                                            phi_5551_ = _e5811;
                                        }
                                        let _e1540 = phi_5550_;
                                        let _e1542 = phi_5551_;
                                        if _e1540 {
                                            phi_5555_ = true;
                                        } else {
                                            phi_5555_ = _e1542;
                                        }
                                        let _e1544 = phi_5555_;
                                        if _e1544 {
                                            phi_5559_ = _e1275;
                                        } else {
                                            let _e5815 = local_34;
                                            phi_5559_ = _e5815;
                                        }
                                        let _e1546 = phi_5559_;
                                        phi_5560_ = _e1546;
                                    } else {
                                        phi_5560_ = _e1275;
                                    }
                                    let _e1548 = phi_5560_;
                                    phi_5562_ = type_45(_e1465, _e1548, _e1325);
                                } else {
                                    phi_5562_ = _e1335;
                                }
                                let _e1551 = phi_5562_;
                                if (_e1551.member > _e1551.member_1) {
                                    phi_8880_ = f64();
                                    phi_8881_ = true;
                                    phi_8882_ = false;
                                    phi_8883_ = false;
                                    phi_8884_ = false;
                                } else {
                                    let _e1559 = ((_e1551.member_1 - _e1551.member) * f64(0.5f));
                                    let _e1560 = (_e1551.member + _e1559);
                                    let _e1563 = (_e1559 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1565 = local_12.member_3;
                                    let _e1568 = local_12.member[0u];
                                    if (_e1568[0] < 0.0lf) {
                                        phi_5593_ = -(_e1568[0]);
                                    } else {
                                        phi_5593_ = _e1568[0];
                                    }
                                    let _e1575 = phi_5593_;
                                    if (_e1568[1] < 0.0lf) {
                                        phi_5600_ = -(_e1568[1]);
                                    } else {
                                        phi_5600_ = _e1568[1];
                                    }
                                    let _e1579 = phi_5600_;
                                    if (_e1575 > _e1579) {
                                        phi_5605_ = _e1575;
                                    } else {
                                        phi_5605_ = _e1579;
                                    }
                                    let _e1582 = phi_5605_;
                                    if (_e1568[2] < 0.0lf) {
                                        phi_5612_ = -(_e1568[2]);
                                    } else {
                                        phi_5612_ = _e1568[2];
                                    }
                                    let _e1586 = phi_5612_;
                                    if (_e1582 > _e1586) {
                                        phi_5617_ = _e1582;
                                    } else {
                                        phi_5617_ = _e1586;
                                    }
                                    let _e1589 = phi_5617_;
                                    let _e1591 = local_12.member[1u];
                                    if (_e1591[0] < 0.0lf) {
                                        phi_5630_ = -(_e1591[0]);
                                    } else {
                                        phi_5630_ = _e1591[0];
                                    }
                                    let _e1598 = phi_5630_;
                                    if (_e1591[1] < 0.0lf) {
                                        phi_5637_ = -(_e1591[1]);
                                    } else {
                                        phi_5637_ = _e1591[1];
                                    }
                                    let _e1602 = phi_5637_;
                                    if (_e1598 > _e1602) {
                                        phi_5642_ = _e1598;
                                    } else {
                                        phi_5642_ = _e1602;
                                    }
                                    let _e1605 = phi_5642_;
                                    if (_e1591[2] < 0.0lf) {
                                        phi_5649_ = -(_e1591[2]);
                                    } else {
                                        phi_5649_ = _e1591[2];
                                    }
                                    let _e1609 = phi_5649_;
                                    if (_e1605 > _e1609) {
                                        phi_5654_ = _e1605;
                                    } else {
                                        phi_5654_ = _e1609;
                                    }
                                    let _e1612 = phi_5654_;
                                    if (_e1589 > _e1612) {
                                        phi_5659_ = _e1589;
                                    } else {
                                        phi_5659_ = _e1612;
                                    }
                                    let _e1615 = phi_5659_;
                                    let _e1618 = local_12.member[0u];
                                    let _e1623 = local_12.member[1u];
                                    let _e1633 = (_e1618[0] + ((_e1623[0] - _e1618[0]) * _e1560));
                                    let _e1634 = (_e1618[1] + ((_e1623[1] - _e1618[1]) * _e1560));
                                    let _e1635 = (_e1618[2] + ((_e1623[2] - _e1618[2]) * _e1560));
                                    let _e1637 = local_12.member[1u];
                                    let _e1642 = local_12.member[0u];
                                    let _e1646 = (_e1637[0] - _e1642[0]);
                                    let _e1647 = (_e1637[1] - _e1642[1]);
                                    let _e1648 = (_e1637[2] - _e1642[2]);
                                    if (_e1646 < 0.0lf) {
                                        phi_5718_ = -(_e1646);
                                    } else {
                                        phi_5718_ = _e1646;
                                    }
                                    let _e1652 = phi_5718_;
                                    if (_e1647 < 0.0lf) {
                                        phi_5724_ = -(_e1647);
                                    } else {
                                        phi_5724_ = _e1647;
                                    }
                                    let _e1656 = phi_5724_;
                                    if (_e1652 > _e1656) {
                                        phi_5729_ = _e1652;
                                    } else {
                                        phi_5729_ = _e1656;
                                    }
                                    let _e1659 = phi_5729_;
                                    if (_e1648 < 0.0lf) {
                                        phi_5735_ = -(_e1648);
                                    } else {
                                        phi_5735_ = _e1648;
                                    }
                                    let _e1663 = phi_5735_;
                                    if (_e1659 > _e1663) {
                                        phi_5740_ = _e1659;
                                    } else {
                                        phi_5740_ = _e1663;
                                    }
                                    let _e1666 = phi_5740_;
                                    let _e1674 = ((((_e1563 * _e1666) * f64(1.01f)) + ((_e1615 + _e1565) * (1.1102230246251565e-16lf * f64(8f)))) + _e1565);
                                    if (_e1633 < 0.0lf) {
                                        phi_5754_ = -(_e1633);
                                    } else {
                                        phi_5754_ = _e1633;
                                    }
                                    let _e1678 = phi_5754_;
                                    if (_e1634 < 0.0lf) {
                                        phi_5760_ = -(_e1634);
                                    } else {
                                        phi_5760_ = _e1634;
                                    }
                                    let _e1682 = phi_5760_;
                                    if (_e1678 > _e1682) {
                                        phi_5765_ = _e1678;
                                    } else {
                                        phi_5765_ = _e1682;
                                    }
                                    let _e1685 = phi_5765_;
                                    if (_e1635 < 0.0lf) {
                                        phi_5771_ = -(_e1635);
                                    } else {
                                        phi_5771_ = _e1635;
                                    }
                                    let _e1689 = phi_5771_;
                                    if (_e1685 > _e1689) {
                                        phi_5776_ = _e1685;
                                    } else {
                                        phi_5776_ = _e1689;
                                    }
                                    let _e1692 = phi_5776_;
                                    local_2 = type_35(array<f64, 3>(_e1633, _e1634, _e1635), _e1674, (_e1692 + _e1674));
                                    let _e1698 = local_12.member_3;
                                    let _e1700 = local_12.member_1[0u];
                                    if (_e1700[0] < 0.0lf) {
                                        phi_5802_ = -(_e1700[0]);
                                    } else {
                                        phi_5802_ = _e1700[0];
                                    }
                                    let _e1707 = phi_5802_;
                                    if (_e1700[1] < 0.0lf) {
                                        phi_5809_ = -(_e1700[1]);
                                    } else {
                                        phi_5809_ = _e1700[1];
                                    }
                                    let _e1711 = phi_5809_;
                                    if (_e1707 > _e1711) {
                                        phi_5814_ = _e1707;
                                    } else {
                                        phi_5814_ = _e1711;
                                    }
                                    let _e1714 = phi_5814_;
                                    if (_e1700[2] < 0.0lf) {
                                        phi_5821_ = -(_e1700[2]);
                                    } else {
                                        phi_5821_ = _e1700[2];
                                    }
                                    let _e1718 = phi_5821_;
                                    if (_e1714 > _e1718) {
                                        phi_5826_ = _e1714;
                                    } else {
                                        phi_5826_ = _e1718;
                                    }
                                    let _e1721 = phi_5826_;
                                    let _e1723 = local_12.member_1[1u];
                                    if (_e1723[0] < 0.0lf) {
                                        phi_5839_ = -(_e1723[0]);
                                    } else {
                                        phi_5839_ = _e1723[0];
                                    }
                                    let _e1730 = phi_5839_;
                                    if (_e1723[1] < 0.0lf) {
                                        phi_5846_ = -(_e1723[1]);
                                    } else {
                                        phi_5846_ = _e1723[1];
                                    }
                                    let _e1734 = phi_5846_;
                                    if (_e1730 > _e1734) {
                                        phi_5851_ = _e1730;
                                    } else {
                                        phi_5851_ = _e1734;
                                    }
                                    let _e1737 = phi_5851_;
                                    if (_e1723[2] < 0.0lf) {
                                        phi_5858_ = -(_e1723[2]);
                                    } else {
                                        phi_5858_ = _e1723[2];
                                    }
                                    let _e1741 = phi_5858_;
                                    if (_e1737 > _e1741) {
                                        phi_5863_ = _e1737;
                                    } else {
                                        phi_5863_ = _e1741;
                                    }
                                    let _e1744 = phi_5863_;
                                    if (_e1721 > _e1744) {
                                        phi_5868_ = _e1721;
                                    } else {
                                        phi_5868_ = _e1744;
                                    }
                                    let _e1747 = phi_5868_;
                                    let _e1750 = local_12.member_1[0u];
                                    let _e1755 = local_12.member_1[1u];
                                    let _e1765 = (_e1750[0] + ((_e1755[0] - _e1750[0]) * _e1560));
                                    let _e1766 = (_e1750[1] + ((_e1755[1] - _e1750[1]) * _e1560));
                                    let _e1767 = (_e1750[2] + ((_e1755[2] - _e1750[2]) * _e1560));
                                    let _e1769 = local_12.member_1[1u];
                                    let _e1774 = local_12.member_1[0u];
                                    let _e1778 = (_e1769[0] - _e1774[0]);
                                    let _e1779 = (_e1769[1] - _e1774[1]);
                                    let _e1780 = (_e1769[2] - _e1774[2]);
                                    if (_e1778 < 0.0lf) {
                                        phi_5927_ = -(_e1778);
                                    } else {
                                        phi_5927_ = _e1778;
                                    }
                                    let _e1784 = phi_5927_;
                                    if (_e1779 < 0.0lf) {
                                        phi_5933_ = -(_e1779);
                                    } else {
                                        phi_5933_ = _e1779;
                                    }
                                    let _e1788 = phi_5933_;
                                    if (_e1784 > _e1788) {
                                        phi_5938_ = _e1784;
                                    } else {
                                        phi_5938_ = _e1788;
                                    }
                                    let _e1791 = phi_5938_;
                                    if (_e1780 < 0.0lf) {
                                        phi_5944_ = -(_e1780);
                                    } else {
                                        phi_5944_ = _e1780;
                                    }
                                    let _e1795 = phi_5944_;
                                    if (_e1791 > _e1795) {
                                        phi_5949_ = _e1791;
                                    } else {
                                        phi_5949_ = _e1795;
                                    }
                                    let _e1798 = phi_5949_;
                                    let _e1806 = ((((_e1563 * _e1798) * f64(1.01f)) + ((_e1747 + _e1698) * (1.1102230246251565e-16lf * f64(8f)))) + _e1698);
                                    if (_e1765 < 0.0lf) {
                                        phi_5963_ = -(_e1765);
                                    } else {
                                        phi_5963_ = _e1765;
                                    }
                                    let _e1810 = phi_5963_;
                                    if (_e1766 < 0.0lf) {
                                        phi_5969_ = -(_e1766);
                                    } else {
                                        phi_5969_ = _e1766;
                                    }
                                    let _e1814 = phi_5969_;
                                    if (_e1810 > _e1814) {
                                        phi_5974_ = _e1810;
                                    } else {
                                        phi_5974_ = _e1814;
                                    }
                                    let _e1817 = phi_5974_;
                                    if (_e1767 < 0.0lf) {
                                        phi_5980_ = -(_e1767);
                                    } else {
                                        phi_5980_ = _e1767;
                                    }
                                    let _e1821 = phi_5980_;
                                    if (_e1817 > _e1821) {
                                        phi_5985_ = _e1817;
                                    } else {
                                        phi_5985_ = _e1821;
                                    }
                                    let _e1824 = phi_5985_;
                                    local_3 = type_35(array<f64, 3>(_e1765, _e1766, _e1767), _e1806, (_e1824 + _e1806));
                                    let _e1830 = local_12.member_3;
                                    let _e1832 = local_12.member_2[0u];
                                    if (_e1832[0] < 0.0lf) {
                                        phi_6011_ = -(_e1832[0]);
                                    } else {
                                        phi_6011_ = _e1832[0];
                                    }
                                    let _e1839 = phi_6011_;
                                    if (_e1832[1] < 0.0lf) {
                                        phi_6018_ = -(_e1832[1]);
                                    } else {
                                        phi_6018_ = _e1832[1];
                                    }
                                    let _e1843 = phi_6018_;
                                    if (_e1839 > _e1843) {
                                        phi_6023_ = _e1839;
                                    } else {
                                        phi_6023_ = _e1843;
                                    }
                                    let _e1846 = phi_6023_;
                                    if (_e1832[2] < 0.0lf) {
                                        phi_6030_ = -(_e1832[2]);
                                    } else {
                                        phi_6030_ = _e1832[2];
                                    }
                                    let _e1850 = phi_6030_;
                                    if (_e1846 > _e1850) {
                                        phi_6035_ = _e1846;
                                    } else {
                                        phi_6035_ = _e1850;
                                    }
                                    let _e1853 = phi_6035_;
                                    let _e1855 = local_12.member_2[1u];
                                    if (_e1855[0] < 0.0lf) {
                                        phi_6048_ = -(_e1855[0]);
                                    } else {
                                        phi_6048_ = _e1855[0];
                                    }
                                    let _e1862 = phi_6048_;
                                    if (_e1855[1] < 0.0lf) {
                                        phi_6055_ = -(_e1855[1]);
                                    } else {
                                        phi_6055_ = _e1855[1];
                                    }
                                    let _e1866 = phi_6055_;
                                    if (_e1862 > _e1866) {
                                        phi_6060_ = _e1862;
                                    } else {
                                        phi_6060_ = _e1866;
                                    }
                                    let _e1869 = phi_6060_;
                                    if (_e1855[2] < 0.0lf) {
                                        phi_6067_ = -(_e1855[2]);
                                    } else {
                                        phi_6067_ = _e1855[2];
                                    }
                                    let _e1873 = phi_6067_;
                                    if (_e1869 > _e1873) {
                                        phi_6072_ = _e1869;
                                    } else {
                                        phi_6072_ = _e1873;
                                    }
                                    let _e1876 = phi_6072_;
                                    if (_e1853 > _e1876) {
                                        phi_6077_ = _e1853;
                                    } else {
                                        phi_6077_ = _e1876;
                                    }
                                    let _e1879 = phi_6077_;
                                    let _e1882 = local_12.member_2[0u];
                                    let _e1887 = local_12.member_2[1u];
                                    let _e1897 = (_e1882[0] + ((_e1887[0] - _e1882[0]) * _e1560));
                                    let _e1898 = (_e1882[1] + ((_e1887[1] - _e1882[1]) * _e1560));
                                    let _e1899 = (_e1882[2] + ((_e1887[2] - _e1882[2]) * _e1560));
                                    let _e1901 = local_12.member_2[1u];
                                    let _e1906 = local_12.member_2[0u];
                                    let _e1910 = (_e1901[0] - _e1906[0]);
                                    let _e1911 = (_e1901[1] - _e1906[1]);
                                    let _e1912 = (_e1901[2] - _e1906[2]);
                                    if (_e1910 < 0.0lf) {
                                        phi_6136_ = -(_e1910);
                                    } else {
                                        phi_6136_ = _e1910;
                                    }
                                    let _e1916 = phi_6136_;
                                    if (_e1911 < 0.0lf) {
                                        phi_6142_ = -(_e1911);
                                    } else {
                                        phi_6142_ = _e1911;
                                    }
                                    let _e1920 = phi_6142_;
                                    if (_e1916 > _e1920) {
                                        phi_6147_ = _e1916;
                                    } else {
                                        phi_6147_ = _e1920;
                                    }
                                    let _e1923 = phi_6147_;
                                    if (_e1912 < 0.0lf) {
                                        phi_6153_ = -(_e1912);
                                    } else {
                                        phi_6153_ = _e1912;
                                    }
                                    let _e1927 = phi_6153_;
                                    if (_e1923 > _e1927) {
                                        phi_6158_ = _e1923;
                                    } else {
                                        phi_6158_ = _e1927;
                                    }
                                    let _e1930 = phi_6158_;
                                    let _e1938 = ((((_e1563 * _e1930) * f64(1.01f)) + ((_e1879 + _e1830) * (1.1102230246251565e-16lf * f64(8f)))) + _e1830);
                                    if (_e1897 < 0.0lf) {
                                        phi_6172_ = -(_e1897);
                                    } else {
                                        phi_6172_ = _e1897;
                                    }
                                    let _e1942 = phi_6172_;
                                    if (_e1898 < 0.0lf) {
                                        phi_6178_ = -(_e1898);
                                    } else {
                                        phi_6178_ = _e1898;
                                    }
                                    let _e1946 = phi_6178_;
                                    if (_e1942 > _e1946) {
                                        phi_6183_ = _e1942;
                                    } else {
                                        phi_6183_ = _e1946;
                                    }
                                    let _e1949 = phi_6183_;
                                    if (_e1899 < 0.0lf) {
                                        phi_6189_ = -(_e1899);
                                    } else {
                                        phi_6189_ = _e1899;
                                    }
                                    let _e1953 = phi_6189_;
                                    if (_e1949 > _e1953) {
                                        phi_6194_ = _e1949;
                                    } else {
                                        phi_6194_ = _e1953;
                                    }
                                    let _e1956 = phi_6194_;
                                    local_4 = type_35(array<f64, 3>(_e1897, _e1898, _e1899), _e1938, (_e1956 + _e1938));
                                    let _e1961 = local_3.member;
                                    let _e1966 = local_4.member;
                                    let _e1972 = ((_e1961[1] * _e1966[2]) - (_e1961[2] * _e1966[1]));
                                    let _e1975 = ((_e1961[2] * _e1966[0]) - (_e1961[0] * _e1966[2]));
                                    let _e1978 = ((_e1961[0] * _e1966[1]) - (_e1961[1] * _e1966[0]));
                                    if (_e1972 < 0.0lf) {
                                        phi_6243_ = -(_e1972);
                                    } else {
                                        phi_6243_ = _e1972;
                                    }
                                    let _e1982 = phi_6243_;
                                    if (_e1975 < 0.0lf) {
                                        phi_6249_ = -(_e1975);
                                    } else {
                                        phi_6249_ = _e1975;
                                    }
                                    let _e1986 = phi_6249_;
                                    if (_e1982 > _e1986) {
                                        if (_e1972 < 0.0lf) {
                                            phi_6259_ = -(_e1972);
                                        } else {
                                            phi_6259_ = _e1972;
                                        }
                                        let _e2004 = phi_6259_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6265_ = -(_e1978);
                                        } else {
                                            phi_6265_ = _e1978;
                                        }
                                        let _e2008 = phi_6265_;
                                        if (_e2004 > _e2008) {
                                            phi_6270_ = 2u;
                                            phi_6271_ = 1u;
                                        } else {
                                            phi_6270_ = 1u;
                                            phi_6271_ = 0u;
                                        }
                                        let _e2011 = phi_6270_;
                                        let _e2013 = phi_6271_;
                                        phi_6290_ = _e2011;
                                        phi_6291_ = _e2013;
                                    } else {
                                        if (_e1975 < 0.0lf) {
                                            phi_6277_ = -(_e1975);
                                        } else {
                                            phi_6277_ = _e1975;
                                        }
                                        let _e1991 = phi_6277_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6283_ = -(_e1978);
                                        } else {
                                            phi_6283_ = _e1978;
                                        }
                                        let _e1995 = phi_6283_;
                                        if (_e1991 > _e1995) {
                                            phi_6288_ = 0u;
                                            phi_6289_ = 2u;
                                        } else {
                                            phi_6288_ = 1u;
                                            phi_6289_ = 0u;
                                        }
                                        let _e1998 = phi_6288_;
                                        let _e2000 = phi_6289_;
                                        phi_6290_ = _e1998;
                                        phi_6291_ = _e2000;
                                    }
                                    let _e2015 = phi_6290_;
                                    let _e2017 = phi_6291_;
                                    let _e2020 = local_3.member[_e2017];
                                    let _e2023 = local_4.member[_e2015];
                                    let _e2027 = local_3.member[_e2015];
                                    let _e2030 = local_4.member[_e2017];
                                    let _e2032 = ((_e2020 * _e2023) - (_e2027 * _e2030));
                                    let _e2033 = f64(1f);
                                    let _e2034 = f64(2f);
                                    let _e2036 = local_3.member_1;
                                    let _e2038 = local_4.member_2;
                                    let _e2041 = local_3.member_2;
                                    let _e2043 = local_4.member_1;
                                    let _e2049 = local_3.member_2;
                                    let _e2052 = local_4.member_2;
                                    let _e2061 = local_3.member_2;
                                    let _e2064 = local_4.member_2;
                                    let _e2068 = (((((_e2036 * _e2038) + (_e2041 * _e2043)) * f64(2.01f)) + (((_e2049 * _e2034) * (_e2052 * _e2034)) * (1.1102230246251565e-16lf * _e2034))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2033 + _e2061) * (_e2033 + _e2064))));
                                    if (_e2032 < 0.0lf) {
                                        phi_6364_ = -(_e2032);
                                    } else {
                                        phi_6364_ = _e2032;
                                    }
                                    let _e2072 = phi_6364_;
                                    if (_e2072 > _e2068) {
                                        if (_e2032 < f64(0f)) {
                                            phi_6376_ = f64(-1f);
                                        } else {
                                            phi_6376_ = f64(1f);
                                        }
                                        let _e2079 = phi_6376_;
                                        let _e2082 = local_2.member[_e2017];
                                        let _e2085 = local_4.member[_e2015];
                                        let _e2089 = local_2.member[_e2015];
                                        let _e2092 = local_4.member[_e2017];
                                        let _e2095 = f64(1f);
                                        let _e2096 = f64(2f);
                                        let _e2098 = local_2.member_1;
                                        let _e2100 = local_4.member_2;
                                        let _e2103 = local_2.member_2;
                                        let _e2105 = local_4.member_1;
                                        let _e2111 = local_2.member_2;
                                        let _e2114 = local_4.member_2;
                                        let _e2123 = local_2.member_2;
                                        let _e2126 = local_4.member_2;
                                        let _e2130 = (((((_e2098 * _e2100) + (_e2103 * _e2105)) * f64(2.01f)) + (((_e2111 * _e2096) * (_e2114 * _e2096)) * (1.1102230246251565e-16lf * _e2096))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2095 + _e2123) * (_e2095 + _e2126))));
                                        let _e2133 = local_3.member[_e2017];
                                        let _e2136 = local_2.member[_e2015];
                                        let _e2140 = local_3.member[_e2015];
                                        let _e2143 = local_2.member[_e2017];
                                        let _e2146 = f64(1f);
                                        let _e2147 = f64(2f);
                                        let _e2149 = local_3.member_1;
                                        let _e2151 = local_2.member_2;
                                        let _e2154 = local_3.member_2;
                                        let _e2156 = local_2.member_1;
                                        let _e2162 = local_3.member_2;
                                        let _e2165 = local_2.member_2;
                                        let _e2174 = local_3.member_2;
                                        let _e2177 = local_2.member_2;
                                        let _e2181 = (((((_e2149 * _e2151) + (_e2154 * _e2156)) * f64(2.01f)) + (((_e2162 * _e2147) * (_e2165 * _e2147)) * (1.1102230246251565e-16lf * _e2147))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2146 + _e2174) * (_e2146 + _e2177))));
                                        let _e2182 = (_e2032 * _e2079);
                                        let _e2183 = (((_e2082 * _e2085) - (_e2089 * _e2092)) * _e2079);
                                        let _e2184 = (((_e2133 * _e2136) - (_e2140 * _e2143)) * _e2079);
                                        if (_e2182 < 0.0lf) {
                                            phi_6519_ = -(_e2182);
                                        } else {
                                            phi_6519_ = _e2182;
                                        }
                                        let _e2188 = phi_6519_;
                                        if (_e2183 < 0.0lf) {
                                            phi_6525_ = -(_e2183);
                                        } else {
                                            phi_6525_ = _e2183;
                                        }
                                        let _e2192 = phi_6525_;
                                        if (_e2184 < 0.0lf) {
                                            phi_6532_ = -(_e2184);
                                        } else {
                                            phi_6532_ = _e2184;
                                        }
                                        let _e2197 = phi_6532_;
                                        let _e2203 = ((_e2182 - _e2183) - _e2184);
                                        let _e2206 = (((_e2068 + _e2130) + _e2181) + (((_e2188 + _e2192) + _e2197) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5 = array<type_36, 4>(type_36(_e2183, _e2130), type_36(_e2184, _e2181), type_36(_e2203, _e2206), type_36(_e2203, _e2206));
                                        phi_6588_ = type_9(0u, 4u);
                                        phi_6591_ = true;
                                        loop {
                                            let _e2213 = phi_6588_;
                                            let _e2215 = phi_6591_;
                                            local_17 = _e2215;
                                            if (_e2213.member < _e2213.member_1) {
                                                phi_6589_ = type_9((_e2213.member + 1u), _e2213.member_1);
                                                phi_6614_ = type_9(1u, _e2213.member);
                                            } else {
                                                phi_6589_ = _e2213;
                                                phi_6614_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2227 = phi_6589_;
                                            let _e2229 = phi_6614_;
                                            if (bitcast<i32>(_e2229.member) != 0i) {
                                                let _e2236 = local_5[_e2229.member_1].member;
                                                let _e2239 = local_5[_e2229.member_1].member_1;
                                                let _e2241 = (_e2236 < -(_e2239));
                                                if _e2241 {
                                                    phi_6641_ = bool();
                                                    phi_6642_ = false;
                                                } else {
                                                    phi_6641_ = (_e2215 && (_e2236 > _e2239));
                                                    phi_6642_ = true;
                                                }
                                                let _e2245 = phi_6641_;
                                                let _e2247 = phi_6642_;
                                                phi_6592_ = _e2245;
                                                phi_6643_ = _e2247;
                                                phi_6644_ = _e2241;
                                            } else {
                                                phi_6592_ = bool();
                                                phi_6643_ = false;
                                                phi_6644_ = false;
                                            }
                                            let _e2249 = phi_6592_;
                                            let _e2251 = phi_6643_;
                                            let _e2253 = phi_6644_;
                                            local_16 = _e2253;
                                            continue;
                                            continuing {
                                                phi_6588_ = _e2227;
                                                phi_6591_ = _e2249;
                                                break if !(_e2251);
                                            }
                                        }
                                        let _e2256 = local_16;
                                        if _e2256 {
                                            phi_6648_ = false;
                                        } else {
                                            phi_6648_ = true;
                                        }
                                        let _e2258 = phi_6648_;
                                        if _e2258 {
                                            let _e2260 = local_17;
                                            if _e2260 {
                                                phi_6655_ = 1u;
                                            } else {
                                                phi_6655_ = 2u;
                                            }
                                            let _e2262 = phi_6655_;
                                            phi_6656_ = _e2262;
                                            phi_6657_ = false;
                                        } else {
                                            phi_6656_ = u32();
                                            phi_6657_ = true;
                                        }
                                        let _e2264 = phi_6656_;
                                        let _e2266 = phi_6657_;
                                        phi_6658_ = _e2264;
                                        phi_6659_ = 0u;
                                        phi_6660_ = _e2266;
                                    } else {
                                        phi_6658_ = u32();
                                        phi_6659_ = 2u;
                                        phi_6660_ = true;
                                    }
                                    let _e2268 = phi_6658_;
                                    let _e2270 = phi_6659_;
                                    let _e2272 = phi_6660_;
                                    if _e2272 {
                                        phi_6664_ = _e2270;
                                    } else {
                                        phi_6664_ = _e2268;
                                    }
                                    let _e2274 = phi_6664_;
                                    let _e2275 = (_e2274 == 0u);
                                    if _e2275 {
                                        phi_8876_ = f64();
                                        phi_8877_ = false;
                                        phi_8878_ = false;
                                        phi_8879_ = false;
                                    } else {
                                        if (_e2274 == 1u) {
                                            if _e1551.member_2 {
                                                if ((_e1551.member_1 - _e1551.member) <= f64(0.0000005f)) {
                                                    phi_6685_ = false;
                                                } else {
                                                    phi_6685_ = true;
                                                }
                                                let _e2284 = phi_6685_;
                                                phi_6686_ = _e2284;
                                            } else {
                                                phi_6686_ = true;
                                            }
                                            let _e2286 = phi_6686_;
                                            phi_6687_ = _e2286;
                                        } else {
                                            phi_6687_ = true;
                                        }
                                        let _e2288 = phi_6687_;
                                        if _e2288 {
                                            let _e2294 = local_12.member[0u];
                                            let _e2300 = local_12.member_1[0u];
                                            let _e2306 = local_12.member_2[0u];
                                            let _e2318 = local_12.member[1u];
                                            let _e2324 = local_12.member_1[1u];
                                            let _e2330 = local_12.member_2[1u];
                                            let _e2342 = local_12.member[0u];
                                            if (_e2342[0] < 0.0lf) {
                                                phi_6836_ = -(_e2342[0]);
                                            } else {
                                                phi_6836_ = _e2342[0];
                                            }
                                            let _e2349 = phi_6836_;
                                            if (_e2342[1] < 0.0lf) {
                                                phi_6843_ = -(_e2342[1]);
                                            } else {
                                                phi_6843_ = _e2342[1];
                                            }
                                            let _e2353 = phi_6843_;
                                            if (_e2349 > _e2353) {
                                                phi_6848_ = _e2349;
                                            } else {
                                                phi_6848_ = _e2353;
                                            }
                                            let _e2356 = phi_6848_;
                                            if (_e2342[2] < 0.0lf) {
                                                phi_6855_ = -(_e2342[2]);
                                            } else {
                                                phi_6855_ = _e2342[2];
                                            }
                                            let _e2360 = phi_6855_;
                                            if (_e2356 > _e2360) {
                                                phi_6860_ = _e2356;
                                            } else {
                                                phi_6860_ = _e2360;
                                            }
                                            let _e2363 = phi_6860_;
                                            let _e2366 = local_12.member[1u];
                                            if (_e2366[0] < 0.0lf) {
                                                phi_6873_ = -(_e2366[0]);
                                            } else {
                                                phi_6873_ = _e2366[0];
                                            }
                                            let _e2373 = phi_6873_;
                                            if (_e2366[1] < 0.0lf) {
                                                phi_6880_ = -(_e2366[1]);
                                            } else {
                                                phi_6880_ = _e2366[1];
                                            }
                                            let _e2377 = phi_6880_;
                                            if (_e2373 > _e2377) {
                                                phi_6885_ = _e2373;
                                            } else {
                                                phi_6885_ = _e2377;
                                            }
                                            let _e2380 = phi_6885_;
                                            if (_e2366[2] < 0.0lf) {
                                                phi_6892_ = -(_e2366[2]);
                                            } else {
                                                phi_6892_ = _e2366[2];
                                            }
                                            let _e2384 = phi_6892_;
                                            if (_e2380 > _e2384) {
                                                phi_6897_ = _e2380;
                                            } else {
                                                phi_6897_ = _e2384;
                                            }
                                            let _e2387 = phi_6897_;
                                            if (_e2363 > _e2387) {
                                                phi_6902_ = _e2363;
                                            } else {
                                                phi_6902_ = _e2387;
                                            }
                                            let _e2390 = phi_6902_;
                                            let _e2392 = local_12.member_3;
                                            let _e2396 = local_12.member_1[0u];
                                            if (_e2396[0] < 0.0lf) {
                                                phi_6919_ = -(_e2396[0]);
                                            } else {
                                                phi_6919_ = _e2396[0];
                                            }
                                            let _e2403 = phi_6919_;
                                            if (_e2396[1] < 0.0lf) {
                                                phi_6926_ = -(_e2396[1]);
                                            } else {
                                                phi_6926_ = _e2396[1];
                                            }
                                            let _e2407 = phi_6926_;
                                            if (_e2403 > _e2407) {
                                                phi_6931_ = _e2403;
                                            } else {
                                                phi_6931_ = _e2407;
                                            }
                                            let _e2410 = phi_6931_;
                                            if (_e2396[2] < 0.0lf) {
                                                phi_6938_ = -(_e2396[2]);
                                            } else {
                                                phi_6938_ = _e2396[2];
                                            }
                                            let _e2414 = phi_6938_;
                                            if (_e2410 > _e2414) {
                                                phi_6943_ = _e2410;
                                            } else {
                                                phi_6943_ = _e2414;
                                            }
                                            let _e2417 = phi_6943_;
                                            let _e2420 = local_12.member_1[1u];
                                            if (_e2420[0] < 0.0lf) {
                                                phi_6957_ = -(_e2420[0]);
                                            } else {
                                                phi_6957_ = _e2420[0];
                                            }
                                            let _e2427 = phi_6957_;
                                            if (_e2420[1] < 0.0lf) {
                                                phi_6964_ = -(_e2420[1]);
                                            } else {
                                                phi_6964_ = _e2420[1];
                                            }
                                            let _e2431 = phi_6964_;
                                            if (_e2427 > _e2431) {
                                                phi_6969_ = _e2427;
                                            } else {
                                                phi_6969_ = _e2431;
                                            }
                                            let _e2434 = phi_6969_;
                                            if (_e2420[2] < 0.0lf) {
                                                phi_6976_ = -(_e2420[2]);
                                            } else {
                                                phi_6976_ = _e2420[2];
                                            }
                                            let _e2438 = phi_6976_;
                                            if (_e2434 > _e2438) {
                                                phi_6981_ = _e2434;
                                            } else {
                                                phi_6981_ = _e2438;
                                            }
                                            let _e2441 = phi_6981_;
                                            if (_e2417 > _e2441) {
                                                phi_6986_ = _e2417;
                                            } else {
                                                phi_6986_ = _e2441;
                                            }
                                            let _e2444 = phi_6986_;
                                            let _e2446 = local_12.member_3;
                                            let _e2450 = local_12.member_2[0u];
                                            if (_e2450[0] < 0.0lf) {
                                                phi_7003_ = -(_e2450[0]);
                                            } else {
                                                phi_7003_ = _e2450[0];
                                            }
                                            let _e2457 = phi_7003_;
                                            if (_e2450[1] < 0.0lf) {
                                                phi_7010_ = -(_e2450[1]);
                                            } else {
                                                phi_7010_ = _e2450[1];
                                            }
                                            let _e2461 = phi_7010_;
                                            if (_e2457 > _e2461) {
                                                phi_7015_ = _e2457;
                                            } else {
                                                phi_7015_ = _e2461;
                                            }
                                            let _e2464 = phi_7015_;
                                            if (_e2450[2] < 0.0lf) {
                                                phi_7022_ = -(_e2450[2]);
                                            } else {
                                                phi_7022_ = _e2450[2];
                                            }
                                            let _e2468 = phi_7022_;
                                            if (_e2464 > _e2468) {
                                                phi_7027_ = _e2464;
                                            } else {
                                                phi_7027_ = _e2468;
                                            }
                                            let _e2471 = phi_7027_;
                                            let _e2474 = local_12.member_2[1u];
                                            if (_e2474[0] < 0.0lf) {
                                                phi_7041_ = -(_e2474[0]);
                                            } else {
                                                phi_7041_ = _e2474[0];
                                            }
                                            let _e2481 = phi_7041_;
                                            if (_e2474[1] < 0.0lf) {
                                                phi_7048_ = -(_e2474[1]);
                                            } else {
                                                phi_7048_ = _e2474[1];
                                            }
                                            let _e2485 = phi_7048_;
                                            if (_e2481 > _e2485) {
                                                phi_7053_ = _e2481;
                                            } else {
                                                phi_7053_ = _e2485;
                                            }
                                            let _e2488 = phi_7053_;
                                            if (_e2474[2] < 0.0lf) {
                                                phi_7060_ = -(_e2474[2]);
                                            } else {
                                                phi_7060_ = _e2474[2];
                                            }
                                            let _e2492 = phi_7060_;
                                            if (_e2488 > _e2492) {
                                                phi_7065_ = _e2488;
                                            } else {
                                                phi_7065_ = _e2492;
                                            }
                                            let _e2495 = phi_7065_;
                                            if (_e2471 > _e2495) {
                                                phi_7070_ = _e2471;
                                            } else {
                                                phi_7070_ = _e2495;
                                            }
                                            let _e2498 = phi_7070_;
                                            let _e2500 = local_12.member_3;
                                            let _e2508 = local_12.member_3;
                                            let _e2515 = f64(0f);
                                            let _e2516 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2515, _e2515, _e2515, _e2515), array<f64, 4>(_e2515, _e2515, _e2515, _e2515), array<f64, 4>(_e2516, _e2516, _e2516, _e2516));
                                            phi_7114_ = type_9(0u, 96u);
                                            phi_7117_ = _e1551.member;
                                            phi_7119_ = _e1551.member;
                                            phi_7121_ = _e1551.member;
                                            phi_7123_ = false;
                                            phi_7125_ = 0u;
                                            loop {
                                                let _e2522 = phi_7114_;
                                                let _e2524 = phi_7117_;
                                                let _e2526 = phi_7119_;
                                                let _e2528 = phi_7121_;
                                                let _e2530 = phi_7123_;
                                                let _e2532 = phi_7125_;
                                                local_36 = _e2526;
                                                local_20 = _e2524;
                                                if (_e2522.member < _e2522.member_1) {
                                                    phi_7115_ = type_9((_e2522.member + 1u), _e2522.member_1);
                                                    phi_7148_ = type_9(1u, _e2522.member);
                                                } else {
                                                    phi_7115_ = _e2522;
                                                    phi_7148_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2544 = phi_7115_;
                                                let _e2546 = phi_7148_;
                                                if (bitcast<i32>(_e2546.member) != 0i) {
                                                    let _e2552 = local_12.member[0u];
                                                    let _e2558 = local_12.member[1u];
                                                    let _e2574 = local_12.member_1[0u];
                                                    let _e2580 = local_12.member_1[1u];
                                                    let _e2596 = local_12.member_2[0u];
                                                    let _e2602 = local_12.member_2[1u];
                                                    let _e2616 = function_2(array<f64, 3>((_e2552[0] + ((_e2558[0] - _e2552[0]) * _e2524)), (_e2552[1] + ((_e2558[1] - _e2552[1]) * _e2524)), (_e2552[2] + ((_e2558[2] - _e2552[2]) * _e2524))), array<f64, 3>((_e2574[0] + ((_e2580[0] - _e2574[0]) * _e2524)), (_e2574[1] + ((_e2580[1] - _e2574[1]) * _e2524)), (_e2574[2] + ((_e2580[2] - _e2574[2]) * _e2524))), array<f64, 3>((_e2596[0] + ((_e2602[0] - _e2596[0]) * _e2524)), (_e2596[1] + ((_e2602[1] - _e2596[1]) * _e2524)), (_e2596[2] + ((_e2602[2] - _e2596[2]) * _e2524))), 0u);
                                                    if (_e2532 == 0u) {
                                                        phi_7277_ = _e2616;
                                                    } else {
                                                        let _e2618 = f64(0f);
                                                        if (_e2532 == 1u) {
                                                            phi_7263_ = _e2616[0];
                                                        } else {
                                                            phi_7263_ = _e2618;
                                                        }
                                                        let _e2622 = phi_7263_;
                                                        if (_e2532 == 2u) {
                                                            phi_7269_ = _e2616[1];
                                                        } else {
                                                            phi_7269_ = _e2618;
                                                        }
                                                        let _e2626 = phi_7269_;
                                                        if (_e2532 == 3u) {
                                                            phi_7275_ = _e2616[2];
                                                        } else {
                                                            phi_7275_ = _e2618;
                                                        }
                                                        let _e2630 = phi_7275_;
                                                        phi_7277_ = array<f64, 3>(_e2622, _e2626, _e2630);
                                                    }
                                                    let _e2633 = phi_7277_;
                                                    if (_e2633[0] < 0.0lf) {
                                                        phi_7284_ = -(_e2633[0]);
                                                    } else {
                                                        phi_7284_ = _e2633[0];
                                                    }
                                                    let _e2638 = phi_7284_;
                                                    if (_e2633[1] < 0.0lf) {
                                                        phi_7291_ = -(_e2633[1]);
                                                    } else {
                                                        phi_7291_ = _e2633[1];
                                                    }
                                                    let _e2643 = phi_7291_;
                                                    if (_e2633[2] < 0.0lf) {
                                                        phi_7299_ = -(_e2633[2]);
                                                    } else {
                                                        phi_7299_ = _e2633[2];
                                                    }
                                                    let _e2649 = phi_7299_;
                                                    let _e2650 = ((_e2638 + _e2643) + _e2649);
                                                    if (_e2650 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2650) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2657 = (f64(1f) / _e2650);
                                                            let _e2659 = (_e2633[0] * _e2657);
                                                            let _e2661 = (_e2633[1] * _e2657);
                                                            let _e2663 = (_e2633[2] * _e2657);
                                                            let _e2668 = (((_e2659 * _e2659) + (_e2661 * _e2661)) + (_e2663 * _e2663));
                                                            if (_e2668 <= 2.2250738585072014e-308lf) {
                                                                if (_e2668 > 0.0lf) {
                                                                    phi_7338_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7338_ = 0.0lf;
                                                                }
                                                                let _e2720 = phi_7338_;
                                                                phi_7402_ = _e2720;
                                                            } else {
                                                                phi_7345_ = type_16(0i, 5i);
                                                                phi_7348_ = bitcast<f64>(((bitcast<u64>(_e2668) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2675 = phi_7345_;
                                                                    let _e2677 = phi_7348_;
                                                                    local_18 = _e2677;
                                                                    if (_e2675.member < _e2675.member_1) {
                                                                        let _e2684 = (_e2675.member + 1i);
                                                                        if ((false == (_e2684 > _e2675.member)) != false) {
                                                                            phi_7369_ = true;
                                                                        } else {
                                                                            phi_7369_ = false;
                                                                        }
                                                                        let _e2689 = phi_7369_;
                                                                        if _e2689 {
                                                                            phi_7375_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_7375_ = type_17(1u, _e2684);
                                                                        }
                                                                        let _e2694 = phi_7375_;
                                                                        phi_7346_ = type_16(_e2694.member_1, _e2675.member_1);
                                                                        phi_7389_ = type_17(1u, _e2675.member);
                                                                    } else {
                                                                        phi_7346_ = _e2675;
                                                                        phi_7389_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2700 = phi_7346_;
                                                                    let _e2702 = phi_7389_;
                                                                    let _e2705 = (bitcast<i32>(_e2702.member) != 0i);
                                                                    if _e2705 {
                                                                        phi_7349_ = (0.5lf * (_e2677 + (_e2668 / _e2677)));
                                                                    } else {
                                                                        phi_7349_ = f64();
                                                                    }
                                                                    let _e2710 = phi_7349_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7345_ = _e2700;
                                                                        phi_7348_ = _e2710;
                                                                        break if !(_e2705);
                                                                    }
                                                                }
                                                                let _e2715 = local_18;
                                                                phi_7402_ = (_e2715 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2722 = phi_7402_;
                                                            let _e2724 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2731 = ((((((((_e2390 + _e2392) + (_e2444 + _e2446)) + (_e2498 + _e2500)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2508 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2722) * (f64(1f) + _e2724)));
                                                            let _e2736 = (((_e2659 * _e2294[0]) + (_e2661 * _e2294[1])) + (_e2663 * _e2294[2]));
                                                            let _e2741 = (((_e2659 * (_e2294[0] - _e2300[0])) + (_e2661 * (_e2294[1] - _e2300[1]))) + (_e2663 * (_e2294[2] - _e2300[2])));
                                                            let _e2746 = (((_e2659 * (_e2294[0] - _e2306[0])) + (_e2661 * (_e2294[1] - _e2306[1]))) + (_e2663 * (_e2294[2] - _e2306[2])));
                                                            let _e2751 = (((_e2659 * _e2294[0]) + (_e2661 * _e2294[1])) + (_e2663 * _e2294[2]));
                                                            let _e2757 = (((_e2659 * _e2318[0]) + (_e2661 * _e2318[1])) + (_e2663 * _e2318[2]));
                                                            let _e2762 = (((_e2659 * (_e2318[0] - _e2324[0])) + (_e2661 * (_e2318[1] - _e2324[1]))) + (_e2663 * (_e2318[2] - _e2324[2])));
                                                            let _e2767 = (((_e2659 * (_e2318[0] - _e2330[0])) + (_e2661 * (_e2318[1] - _e2330[1]))) + (_e2663 * (_e2318[2] - _e2330[2])));
                                                            let _e2772 = (((_e2659 * _e2318[0]) + (_e2661 * _e2318[1])) + (_e2663 * _e2318[2]));
                                                            if (_e2736 < 0.0lf) {
                                                                phi_7471_ = -(_e2736);
                                                            } else {
                                                                phi_7471_ = _e2736;
                                                            }
                                                            let _e2777 = phi_7471_;
                                                            if (_e2757 < 0.0lf) {
                                                                phi_7477_ = -(_e2757);
                                                            } else {
                                                                phi_7477_ = _e2757;
                                                            }
                                                            let _e2781 = phi_7477_;
                                                            if (_e2741 < 0.0lf) {
                                                                phi_7486_ = -(_e2741);
                                                            } else {
                                                                phi_7486_ = _e2741;
                                                            }
                                                            let _e2788 = phi_7486_;
                                                            if (_e2762 < 0.0lf) {
                                                                phi_7492_ = -(_e2762);
                                                            } else {
                                                                phi_7492_ = _e2762;
                                                            }
                                                            let _e2792 = phi_7492_;
                                                            if (_e2746 < 0.0lf) {
                                                                phi_7501_ = -(_e2746);
                                                            } else {
                                                                phi_7501_ = _e2746;
                                                            }
                                                            let _e2799 = phi_7501_;
                                                            if (_e2767 < 0.0lf) {
                                                                phi_7507_ = -(_e2767);
                                                            } else {
                                                                phi_7507_ = _e2767;
                                                            }
                                                            let _e2803 = phi_7507_;
                                                            if (_e2751 < 0.0lf) {
                                                                phi_7516_ = -(_e2751);
                                                            } else {
                                                                phi_7516_ = _e2751;
                                                            }
                                                            let _e2810 = phi_7516_;
                                                            if (_e2772 < 0.0lf) {
                                                                phi_7522_ = -(_e2772);
                                                            } else {
                                                                phi_7522_ = _e2772;
                                                            }
                                                            let _e2814 = phi_7522_;
                                                            phi_7528_ = type_34(array<f64, 4>(_e2736, _e2741, _e2746, _e2751), array<f64, 4>(_e2757, _e2762, _e2767, _e2772), array<f64, 4>((_e2731 + ((_e2777 + _e2781) * _e2724)), (_e2731 + ((_e2788 + _e2792) * _e2724)), (_e2731 + ((_e2799 + _e2803) * _e2724)), (_e2731 + ((_e2810 + _e2814) * _e2724))));
                                                            phi_7529_ = false;
                                                        } else {
                                                            phi_7528_ = type_34();
                                                            phi_7529_ = true;
                                                        }
                                                        let _e2821 = phi_7528_;
                                                        let _e2823 = phi_7529_;
                                                        phi_7530_ = _e2821;
                                                        phi_7531_ = _e2823;
                                                    } else {
                                                        phi_7530_ = type_34();
                                                        phi_7531_ = true;
                                                    }
                                                    let _e2825 = phi_7530_;
                                                    let _e2827 = phi_7531_;
                                                    if _e2827 {
                                                        let _e2828 = f64(0f);
                                                        let _e2829 = f64(1f);
                                                        phi_7541_ = type_34(array<f64, 4>(_e2828, _e2828, _e2828, _e2828), array<f64, 4>(_e2828, _e2828, _e2828, _e2828), array<f64, 4>(_e2829, _e2829, _e2829, _e2829));
                                                    } else {
                                                        phi_7541_ = _e2825;
                                                    }
                                                    let _e2835 = phi_7541_;
                                                    local_1 = type_34(array<f64, 4>(_e2835.member[0], _e2835.member[1], _e2835.member[2], _e2835.member[3]), array<f64, 4>(_e2835.member_1[0], _e2835.member_1[1], _e2835.member_1[2], _e2835.member_1[3]), array<f64, 4>(_e2835.member_2[0], _e2835.member_2[1], _e2835.member_2[2], _e2835.member_2[3]));
                                                    let _e2855 = (_e2524 - _e2528);
                                                    let _e2857 = f64(0f);
                                                    let _e2860 = local_1.member[0u];
                                                    let _e2863 = local_1.member_1[0u];
                                                    let _e2866 = local_1.member[0u];
                                                    let _e2872 = local_1.member_2[0u];
                                                    if (((_e2860 + ((_e2863 - _e2866) * _e2524)) - _e2872) > _e2857) {
                                                        let _e2877 = local_1.member[1u];
                                                        let _e2880 = local_1.member_1[1u];
                                                        let _e2883 = local_1.member[1u];
                                                        let _e2889 = local_1.member_2[1u];
                                                        if (((_e2877 + ((_e2880 - _e2883) * _e2524)) - _e2889) > _e2857) {
                                                            let _e2894 = local_1.member[2u];
                                                            let _e2897 = local_1.member_1[2u];
                                                            let _e2900 = local_1.member[2u];
                                                            let _e2906 = local_1.member_2[2u];
                                                            if (((_e2894 + ((_e2897 - _e2900) * _e2524)) - _e2906) > _e2857) {
                                                                let _e2911 = local_1.member[3u];
                                                                let _e2914 = local_1.member_1[3u];
                                                                let _e2917 = local_1.member[3u];
                                                                let _e2923 = local_1.member_2[3u];
                                                                phi_7713_ = (((_e2911 + ((_e2914 - _e2917) * _e2524)) - _e2923) > _e2857);
                                                                phi_7714_ = false;
                                                            } else {
                                                                phi_7713_ = bool();
                                                                phi_7714_ = true;
                                                            }
                                                            let _e2927 = phi_7713_;
                                                            let _e2929 = phi_7714_;
                                                            phi_7715_ = _e2927;
                                                            phi_7716_ = _e2929;
                                                        } else {
                                                            phi_7715_ = bool();
                                                            phi_7716_ = true;
                                                        }
                                                        let _e2931 = phi_7715_;
                                                        let _e2933 = phi_7716_;
                                                        phi_7717_ = _e2931;
                                                        phi_7718_ = _e2933;
                                                    } else {
                                                        phi_7717_ = bool();
                                                        phi_7718_ = true;
                                                    }
                                                    let _e2935 = phi_7717_;
                                                    let _e2937 = phi_7718_;
                                                    if _e2937 {
                                                        phi_7722_ = false;
                                                    } else {
                                                        phi_7722_ = _e2935;
                                                    }
                                                    let _e2939 = phi_7722_;
                                                    if _e2939 {
                                                        if (_e2524 <= _e2526) {
                                                            phi_8033_ = true;
                                                        } else {
                                                            let _e2941 = f64(0f);
                                                            let _e2944 = local.member[0u];
                                                            let _e2947 = local.member_1[0u];
                                                            let _e2950 = local.member[0u];
                                                            let _e2956 = local.member_2[0u];
                                                            let _e2960 = local_1.member[0u];
                                                            let _e2963 = local_1.member_1[0u];
                                                            let _e2966 = local_1.member[0u];
                                                            let _e2972 = local_1.member_2[0u];
                                                            if ((((_e2944 + ((_e2947 - _e2950) * _e2524)) - _e2956) + ((_e2960 + ((_e2963 - _e2966) * _e2528)) - _e2972)) > _e2941) {
                                                                let _e2978 = local.member[1u];
                                                                let _e2981 = local.member_1[1u];
                                                                let _e2984 = local.member[1u];
                                                                let _e2990 = local.member_2[1u];
                                                                let _e2994 = local_1.member[1u];
                                                                let _e2997 = local_1.member_1[1u];
                                                                let _e3000 = local_1.member[1u];
                                                                let _e3006 = local_1.member_2[1u];
                                                                if ((((_e2978 + ((_e2981 - _e2984) * _e2524)) - _e2990) + ((_e2994 + ((_e2997 - _e3000) * _e2528)) - _e3006)) > _e2941) {
                                                                    let _e3012 = local.member[2u];
                                                                    let _e3015 = local.member_1[2u];
                                                                    let _e3018 = local.member[2u];
                                                                    let _e3024 = local.member_2[2u];
                                                                    let _e3028 = local_1.member[2u];
                                                                    let _e3031 = local_1.member_1[2u];
                                                                    let _e3034 = local_1.member[2u];
                                                                    let _e3040 = local_1.member_2[2u];
                                                                    if ((((_e3012 + ((_e3015 - _e3018) * _e2524)) - _e3024) + ((_e3028 + ((_e3031 - _e3034) * _e2528)) - _e3040)) > _e2941) {
                                                                        let _e3046 = local.member[3u];
                                                                        let _e3049 = local.member_1[3u];
                                                                        let _e3052 = local.member[3u];
                                                                        let _e3058 = local.member_2[3u];
                                                                        let _e3062 = local_1.member[3u];
                                                                        let _e3065 = local_1.member_1[3u];
                                                                        let _e3068 = local_1.member[3u];
                                                                        let _e3074 = local_1.member_2[3u];
                                                                        phi_8020_ = ((((_e3046 + ((_e3049 - _e3052) * _e2524)) - _e3058) + ((_e3062 + ((_e3065 - _e3068) * _e2528)) - _e3074)) > _e2941);
                                                                        phi_8021_ = false;
                                                                    } else {
                                                                        phi_8020_ = bool();
                                                                        phi_8021_ = true;
                                                                    }
                                                                    let _e3079 = phi_8020_;
                                                                    let _e3081 = phi_8021_;
                                                                    phi_8022_ = _e3079;
                                                                    phi_8023_ = _e3081;
                                                                } else {
                                                                    phi_8022_ = bool();
                                                                    phi_8023_ = true;
                                                                }
                                                                let _e3083 = phi_8022_;
                                                                let _e3085 = phi_8023_;
                                                                phi_8024_ = _e3083;
                                                                phi_8025_ = _e3085;
                                                            } else {
                                                                phi_8024_ = bool();
                                                                phi_8025_ = true;
                                                            }
                                                            let _e3087 = phi_8024_;
                                                            let _e3089 = phi_8025_;
                                                            if _e3089 {
                                                                phi_8029_ = false;
                                                            } else {
                                                                phi_8029_ = _e3087;
                                                            }
                                                            let _e3091 = phi_8029_;
                                                            phi_8033_ = _e3091;
                                                        }
                                                        let _e3093 = phi_8033_;
                                                        if _e3093 {
                                                            if _e2530 {
                                                                if (_e2524 >= _e1551.member_1) {
                                                                    phi_8044_ = false;
                                                                } else {
                                                                    phi_8044_ = true;
                                                                }
                                                                let _e3096 = phi_8044_;
                                                                phi_8045_ = _e3096;
                                                            } else {
                                                                phi_8045_ = true;
                                                            }
                                                            let _e3098 = phi_8045_;
                                                            if _e3098 {
                                                                local = type_34(array<f64, 4>(_e2835.member[0], _e2835.member[1], _e2835.member[2], _e2835.member[3]), array<f64, 4>(_e2835.member_1[0], _e2835.member_1[1], _e2835.member_1[2], _e2835.member_1[3]), array<f64, 4>(_e2835.member_2[0], _e2835.member_2[1], _e2835.member_2[2], _e2835.member_2[3]));
                                                                let _e3120 = local.member[0u];
                                                                let _e3123 = local.member_1[0u];
                                                                let _e3126 = local.member_2[0u];
                                                                if (_e3120 > _e3126) {
                                                                    if (_e3123 > _e3126) {
                                                                        phi_8119_ = false;
                                                                    } else {
                                                                        phi_8119_ = true;
                                                                    }
                                                                    let _e3130 = phi_8119_;
                                                                    phi_8120_ = _e3130;
                                                                } else {
                                                                    phi_8120_ = true;
                                                                }
                                                                let _e3132 = phi_8120_;
                                                                if _e3132 {
                                                                    let _e3133 = (_e3123 >= _e3120);
                                                                    if _e3133 {
                                                                        phi_8145_ = f64();
                                                                        phi_8146_ = false;
                                                                    } else {
                                                                        if ((_e3120 - _e3123) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8143_ = (((_e3120 - _e3126) / (_e3120 - _e3123)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8144_ = false;
                                                                        } else {
                                                                            phi_8143_ = f64();
                                                                            phi_8144_ = true;
                                                                        }
                                                                        let _e3147 = phi_8143_;
                                                                        let _e3149 = phi_8144_;
                                                                        phi_8145_ = _e3147;
                                                                        phi_8146_ = _e3149;
                                                                    }
                                                                    let _e3151 = phi_8145_;
                                                                    let _e3153 = phi_8146_;
                                                                    phi_8147_ = _e3151;
                                                                    phi_8148_ = _e3133;
                                                                    phi_8149_ = _e3153;
                                                                } else {
                                                                    phi_8147_ = f64();
                                                                    phi_8148_ = true;
                                                                    phi_8149_ = false;
                                                                }
                                                                let _e3155 = phi_8147_;
                                                                let _e3157 = phi_8148_;
                                                                let _e3159 = phi_8149_;
                                                                if _e3157 {
                                                                    phi_8154_ = f64(2f);
                                                                    phi_8155_ = true;
                                                                } else {
                                                                    phi_8154_ = _e2524;
                                                                    phi_8155_ = _e3159;
                                                                }
                                                                let _e3162 = phi_8154_;
                                                                let _e3164 = phi_8155_;
                                                                if _e3164 {
                                                                    phi_8159_ = _e3162;
                                                                } else {
                                                                    phi_8159_ = _e3155;
                                                                }
                                                                let _e3166 = phi_8159_;
                                                                let _e3169 = local.member[1u];
                                                                let _e3172 = local.member_1[1u];
                                                                let _e3175 = local.member_2[1u];
                                                                if (_e3169 > _e3175) {
                                                                    if (_e3172 > _e3175) {
                                                                        phi_8191_ = false;
                                                                    } else {
                                                                        phi_8191_ = true;
                                                                    }
                                                                    let _e3179 = phi_8191_;
                                                                    phi_8192_ = _e3179;
                                                                } else {
                                                                    phi_8192_ = true;
                                                                }
                                                                let _e3181 = phi_8192_;
                                                                if _e3181 {
                                                                    let _e3182 = (_e3172 >= _e3169);
                                                                    if _e3182 {
                                                                        phi_8217_ = f64();
                                                                        phi_8218_ = false;
                                                                    } else {
                                                                        if ((_e3169 - _e3172) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8215_ = (((_e3169 - _e3175) / (_e3169 - _e3172)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8216_ = false;
                                                                        } else {
                                                                            phi_8215_ = f64();
                                                                            phi_8216_ = true;
                                                                        }
                                                                        let _e3196 = phi_8215_;
                                                                        let _e3198 = phi_8216_;
                                                                        phi_8217_ = _e3196;
                                                                        phi_8218_ = _e3198;
                                                                    }
                                                                    let _e3200 = phi_8217_;
                                                                    let _e3202 = phi_8218_;
                                                                    phi_8219_ = _e3200;
                                                                    phi_8220_ = _e3182;
                                                                    phi_8221_ = _e3202;
                                                                } else {
                                                                    phi_8219_ = f64();
                                                                    phi_8220_ = true;
                                                                    phi_8221_ = false;
                                                                }
                                                                let _e3204 = phi_8219_;
                                                                let _e3206 = phi_8220_;
                                                                let _e3208 = phi_8221_;
                                                                if _e3206 {
                                                                    phi_8226_ = f64(2f);
                                                                    phi_8227_ = true;
                                                                } else {
                                                                    phi_8226_ = _e2524;
                                                                    phi_8227_ = _e3208;
                                                                }
                                                                let _e3211 = phi_8226_;
                                                                let _e3213 = phi_8227_;
                                                                if _e3213 {
                                                                    phi_8231_ = _e3211;
                                                                } else {
                                                                    phi_8231_ = _e3204;
                                                                }
                                                                let _e3215 = phi_8231_;
                                                                if (_e3166 < _e3215) {
                                                                    phi_8236_ = _e3166;
                                                                } else {
                                                                    phi_8236_ = _e3215;
                                                                }
                                                                let _e3218 = phi_8236_;
                                                                let _e3221 = local.member[2u];
                                                                let _e3224 = local.member_1[2u];
                                                                let _e3227 = local.member_2[2u];
                                                                if (_e3221 > _e3227) {
                                                                    if (_e3224 > _e3227) {
                                                                        phi_8268_ = false;
                                                                    } else {
                                                                        phi_8268_ = true;
                                                                    }
                                                                    let _e3231 = phi_8268_;
                                                                    phi_8269_ = _e3231;
                                                                } else {
                                                                    phi_8269_ = true;
                                                                }
                                                                let _e3233 = phi_8269_;
                                                                if _e3233 {
                                                                    let _e3234 = (_e3224 >= _e3221);
                                                                    if _e3234 {
                                                                        phi_8294_ = f64();
                                                                        phi_8295_ = false;
                                                                    } else {
                                                                        if ((_e3221 - _e3224) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8292_ = (((_e3221 - _e3227) / (_e3221 - _e3224)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8293_ = false;
                                                                        } else {
                                                                            phi_8292_ = f64();
                                                                            phi_8293_ = true;
                                                                        }
                                                                        let _e3248 = phi_8292_;
                                                                        let _e3250 = phi_8293_;
                                                                        phi_8294_ = _e3248;
                                                                        phi_8295_ = _e3250;
                                                                    }
                                                                    let _e3252 = phi_8294_;
                                                                    let _e3254 = phi_8295_;
                                                                    phi_8296_ = _e3252;
                                                                    phi_8297_ = _e3234;
                                                                    phi_8298_ = _e3254;
                                                                } else {
                                                                    phi_8296_ = f64();
                                                                    phi_8297_ = true;
                                                                    phi_8298_ = false;
                                                                }
                                                                let _e3256 = phi_8296_;
                                                                let _e3258 = phi_8297_;
                                                                let _e3260 = phi_8298_;
                                                                if _e3258 {
                                                                    phi_8303_ = f64(2f);
                                                                    phi_8304_ = true;
                                                                } else {
                                                                    phi_8303_ = _e2524;
                                                                    phi_8304_ = _e3260;
                                                                }
                                                                let _e3263 = phi_8303_;
                                                                let _e3265 = phi_8304_;
                                                                if _e3265 {
                                                                    phi_8308_ = _e3263;
                                                                } else {
                                                                    phi_8308_ = _e3256;
                                                                }
                                                                let _e3267 = phi_8308_;
                                                                let _e3270 = local.member[3u];
                                                                let _e3273 = local.member_1[3u];
                                                                let _e3276 = local.member_2[3u];
                                                                if (_e3270 > _e3276) {
                                                                    if (_e3273 > _e3276) {
                                                                        phi_8340_ = false;
                                                                    } else {
                                                                        phi_8340_ = true;
                                                                    }
                                                                    let _e3280 = phi_8340_;
                                                                    phi_8341_ = _e3280;
                                                                } else {
                                                                    phi_8341_ = true;
                                                                }
                                                                let _e3282 = phi_8341_;
                                                                if _e3282 {
                                                                    let _e3283 = (_e3273 >= _e3270);
                                                                    if _e3283 {
                                                                        phi_8366_ = f64();
                                                                        phi_8367_ = false;
                                                                    } else {
                                                                        if ((_e3270 - _e3273) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8364_ = (((_e3270 - _e3276) / (_e3270 - _e3273)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8365_ = false;
                                                                        } else {
                                                                            phi_8364_ = f64();
                                                                            phi_8365_ = true;
                                                                        }
                                                                        let _e3297 = phi_8364_;
                                                                        let _e3299 = phi_8365_;
                                                                        phi_8366_ = _e3297;
                                                                        phi_8367_ = _e3299;
                                                                    }
                                                                    let _e3301 = phi_8366_;
                                                                    let _e3303 = phi_8367_;
                                                                    phi_8368_ = _e3301;
                                                                    phi_8369_ = _e3283;
                                                                    phi_8370_ = _e3303;
                                                                } else {
                                                                    phi_8368_ = f64();
                                                                    phi_8369_ = true;
                                                                    phi_8370_ = false;
                                                                }
                                                                let _e3305 = phi_8368_;
                                                                let _e3307 = phi_8369_;
                                                                let _e3309 = phi_8370_;
                                                                if _e3307 {
                                                                    phi_8375_ = f64(2f);
                                                                    phi_8376_ = true;
                                                                } else {
                                                                    phi_8375_ = _e2524;
                                                                    phi_8376_ = _e3309;
                                                                }
                                                                let _e3312 = phi_8375_;
                                                                let _e3314 = phi_8376_;
                                                                if _e3314 {
                                                                    phi_8380_ = _e3312;
                                                                } else {
                                                                    phi_8380_ = _e3305;
                                                                }
                                                                let _e3316 = phi_8380_;
                                                                if (_e3267 < _e3316) {
                                                                    phi_8385_ = _e3267;
                                                                } else {
                                                                    phi_8385_ = _e3316;
                                                                }
                                                                let _e3319 = phi_8385_;
                                                                if (_e3218 < _e3319) {
                                                                    phi_8390_ = _e3218;
                                                                } else {
                                                                    phi_8390_ = _e3319;
                                                                }
                                                                let _e3322 = phi_8390_;
                                                                if (_e3322 > _e2524) {
                                                                    phi_8395_ = _e3322;
                                                                } else {
                                                                    phi_8395_ = _e2524;
                                                                }
                                                                let _e3325 = phi_8395_;
                                                                let _e3326 = (_e3325 > _e1551.member_1);
                                                                if _e3326 {
                                                                    phi_8406_ = f64();
                                                                    phi_8407_ = false;
                                                                } else {
                                                                    if _e2530 {
                                                                        phi_8405_ = (_e2855 + _e2855);
                                                                    } else {
                                                                        phi_8405_ = (_e1551.member_1 - _e2524);
                                                                    }
                                                                    let _e3330 = phi_8405_;
                                                                    phi_8406_ = _e3330;
                                                                    phi_8407_ = true;
                                                                }
                                                                let _e3332 = phi_8406_;
                                                                let _e3334 = phi_8407_;
                                                                phi_8408_ = _e3325;
                                                                phi_8409_ = _e3332;
                                                                phi_8410_ = _e3334;
                                                                phi_8411_ = _e3326;
                                                                phi_8412_ = false;
                                                            } else {
                                                                phi_8408_ = f64();
                                                                phi_8409_ = f64();
                                                                phi_8410_ = false;
                                                                phi_8411_ = false;
                                                                phi_8412_ = true;
                                                            }
                                                            let _e3336 = phi_8408_;
                                                            let _e3338 = phi_8409_;
                                                            let _e3340 = phi_8410_;
                                                            let _e3342 = phi_8411_;
                                                            let _e3344 = phi_8412_;
                                                            phi_8413_ = _e3336;
                                                            phi_8414_ = _e3338;
                                                            phi_8415_ = false;
                                                            phi_8416_ = _e3340;
                                                            phi_8417_ = _e3342;
                                                            phi_8418_ = _e3344;
                                                        } else {
                                                            phi_8413_ = f64();
                                                            phi_8414_ = f64();
                                                            phi_8415_ = true;
                                                            phi_8416_ = false;
                                                            phi_8417_ = false;
                                                            phi_8418_ = false;
                                                        }
                                                        let _e3346 = phi_8413_;
                                                        let _e3348 = phi_8414_;
                                                        let _e3350 = phi_8415_;
                                                        let _e3352 = phi_8416_;
                                                        let _e3354 = phi_8417_;
                                                        let _e3356 = phi_8418_;
                                                        phi_8419_ = _e3346;
                                                        phi_8420_ = _e3348;
                                                        phi_8421_ = _e3350;
                                                        phi_8422_ = _e3352;
                                                        phi_8423_ = _e3354;
                                                        phi_8424_ = _e3356;
                                                    } else {
                                                        phi_8419_ = f64();
                                                        phi_8420_ = f64();
                                                        phi_8421_ = true;
                                                        phi_8422_ = false;
                                                        phi_8423_ = false;
                                                        phi_8424_ = false;
                                                    }
                                                    let _e3358 = phi_8419_;
                                                    let _e3360 = phi_8420_;
                                                    let _e3362 = phi_8421_;
                                                    let _e3364 = phi_8422_;
                                                    let _e3366 = phi_8423_;
                                                    let _e3368 = phi_8424_;
                                                    if _e3362 {
                                                        if (_e2524 <= _e2526) {
                                                            let _e3534 = (_e2532 + 1u);
                                                            let _e3535 = (_e3534 > 3u);
                                                            if _e3535 {
                                                                phi_8437_ = false;
                                                            } else {
                                                                phi_8437_ = true;
                                                            }
                                                            let _e3537 = phi_8437_;
                                                            phi_8764_ = _e3534;
                                                            phi_8765_ = f64();
                                                            phi_8766_ = false;
                                                            phi_8767_ = _e3537;
                                                            phi_8768_ = _e3535;
                                                        } else {
                                                            let _e3372 = local.member[0u];
                                                            let _e3375 = local.member_1[0u];
                                                            let _e3378 = local.member[0u];
                                                            let _e3384 = local.member_2[0u];
                                                            let _e3385 = ((_e3372 + ((_e3375 - _e3378) * _e2528)) - _e3384);
                                                            let _e3388 = local.member[1u];
                                                            let _e3391 = local.member_1[1u];
                                                            let _e3394 = local.member[1u];
                                                            let _e3400 = local.member_2[1u];
                                                            let _e3401 = ((_e3388 + ((_e3391 - _e3394) * _e2528)) - _e3400);
                                                            if (_e3385 < _e3401) {
                                                                phi_8510_ = _e3385;
                                                            } else {
                                                                phi_8510_ = _e3401;
                                                            }
                                                            let _e3404 = phi_8510_;
                                                            let _e3407 = local.member[2u];
                                                            let _e3410 = local.member_1[2u];
                                                            let _e3413 = local.member[2u];
                                                            let _e3419 = local.member_2[2u];
                                                            let _e3420 = ((_e3407 + ((_e3410 - _e3413) * _e2528)) - _e3419);
                                                            let _e3423 = local.member[3u];
                                                            let _e3426 = local.member_1[3u];
                                                            let _e3429 = local.member[3u];
                                                            let _e3435 = local.member_2[3u];
                                                            let _e3436 = ((_e3423 + ((_e3426 - _e3429) * _e2528)) - _e3435);
                                                            if (_e3420 < _e3436) {
                                                                phi_8583_ = _e3420;
                                                            } else {
                                                                phi_8583_ = _e3436;
                                                            }
                                                            let _e3439 = phi_8583_;
                                                            if (_e3404 < _e3439) {
                                                                phi_8588_ = _e3404;
                                                            } else {
                                                                phi_8588_ = _e3439;
                                                            }
                                                            let _e3442 = phi_8588_;
                                                            let _e3445 = local_1.member[0u];
                                                            let _e3448 = local_1.member_1[0u];
                                                            let _e3451 = local_1.member[0u];
                                                            let _e3457 = local_1.member_2[0u];
                                                            let _e3458 = ((_e3445 + ((_e3448 - _e3451) * _e2524)) - _e3457);
                                                            let _e3461 = local_1.member[1u];
                                                            let _e3464 = local_1.member_1[1u];
                                                            let _e3467 = local_1.member[1u];
                                                            let _e3473 = local_1.member_2[1u];
                                                            let _e3474 = ((_e3461 + ((_e3464 - _e3467) * _e2524)) - _e3473);
                                                            if (_e3458 < _e3474) {
                                                                phi_8661_ = _e3458;
                                                            } else {
                                                                phi_8661_ = _e3474;
                                                            }
                                                            let _e3477 = phi_8661_;
                                                            let _e3480 = local_1.member[2u];
                                                            let _e3483 = local_1.member_1[2u];
                                                            let _e3486 = local_1.member[2u];
                                                            let _e3492 = local_1.member_2[2u];
                                                            let _e3493 = ((_e3480 + ((_e3483 - _e3486) * _e2524)) - _e3492);
                                                            let _e3496 = local_1.member[3u];
                                                            let _e3499 = local_1.member_1[3u];
                                                            let _e3502 = local_1.member[3u];
                                                            let _e3508 = local_1.member_2[3u];
                                                            let _e3509 = ((_e3496 + ((_e3499 - _e3502) * _e2524)) - _e3508);
                                                            if (_e3493 < _e3509) {
                                                                phi_8734_ = _e3493;
                                                            } else {
                                                                phi_8734_ = _e3509;
                                                            }
                                                            let _e3512 = phi_8734_;
                                                            if (_e3477 < _e3512) {
                                                                phi_8739_ = _e3477;
                                                            } else {
                                                                phi_8739_ = _e3512;
                                                            }
                                                            let _e3515 = phi_8739_;
                                                            let _e3516 = f64(0.0625f);
                                                            let _e3518 = f64(0.9f);
                                                            if (_e3515 > f64(0f)) {
                                                                phi_8762_ = f64(0.5f);
                                                            } else {
                                                                let _e3524 = (f64(0.95f) * (_e3442 / (_e3442 - _e3515)));
                                                                if (_e3524 > _e3516) {
                                                                    if (_e3524 < _e3518) {
                                                                        phi_8760_ = _e3524;
                                                                    } else {
                                                                        phi_8760_ = _e3518;
                                                                    }
                                                                    let _e3528 = phi_8760_;
                                                                    phi_8761_ = _e3528;
                                                                } else {
                                                                    phi_8761_ = _e3516;
                                                                }
                                                                let _e3530 = phi_8761_;
                                                                phi_8762_ = _e3530;
                                                            }
                                                            let _e3532 = phi_8762_;
                                                            phi_8764_ = u32();
                                                            phi_8765_ = (_e2855 * _e3532);
                                                            phi_8766_ = true;
                                                            phi_8767_ = false;
                                                            phi_8768_ = false;
                                                        }
                                                        let _e3539 = phi_8764_;
                                                        let _e3541 = phi_8765_;
                                                        let _e3543 = phi_8766_;
                                                        let _e3545 = phi_8767_;
                                                        let _e3547 = phi_8768_;
                                                        phi_8769_ = _e3539;
                                                        phi_8770_ = _e2526;
                                                        phi_8771_ = _e3541;
                                                        phi_8772_ = _e2528;
                                                        phi_8773_ = _e2530;
                                                        phi_8774_ = _e2532;
                                                        phi_8775_ = _e3543;
                                                        phi_8776_ = _e3545;
                                                        phi_8777_ = _e3547;
                                                        phi_8778_ = false;
                                                        phi_8779_ = false;
                                                    } else {
                                                        phi_8769_ = u32();
                                                        phi_8770_ = _e3358;
                                                        phi_8771_ = _e3360;
                                                        phi_8772_ = _e2524;
                                                        phi_8773_ = true;
                                                        phi_8774_ = 0u;
                                                        phi_8775_ = _e3364;
                                                        phi_8776_ = false;
                                                        phi_8777_ = false;
                                                        phi_8778_ = _e3366;
                                                        phi_8779_ = _e3368;
                                                    }
                                                    let _e3549 = phi_8769_;
                                                    let _e3551 = phi_8770_;
                                                    let _e3553 = phi_8771_;
                                                    let _e3555 = phi_8772_;
                                                    let _e3557 = phi_8773_;
                                                    let _e3559 = phi_8774_;
                                                    let _e3561 = phi_8775_;
                                                    let _e3563 = phi_8776_;
                                                    let _e3565 = phi_8777_;
                                                    let _e3567 = phi_8778_;
                                                    let _e3569 = phi_8779_;
                                                    if _e3561 {
                                                        let _e3570 = (_e3555 + _e3553);
                                                        if (_e3570 > _e3551) {
                                                            phi_8788_ = _e3570;
                                                        } else {
                                                            phi_8788_ = _e3551;
                                                        }
                                                        let _e3573 = phi_8788_;
                                                        if (_e3573 < _e1551.member_1) {
                                                            phi_8793_ = _e3573;
                                                        } else {
                                                            phi_8793_ = _e1551.member_1;
                                                        }
                                                        let _e3576 = phi_8793_;
                                                        if !(_e2530) {
                                                            phi_8803_ = true;
                                                        } else {
                                                            phi_8803_ = ((_e3576 - _e3555) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3581 = phi_8803_;
                                                        if _e3581 {
                                                            phi_8807_ = false;
                                                        } else {
                                                            phi_8807_ = true;
                                                        }
                                                        let _e3583 = phi_8807_;
                                                        phi_8808_ = _e3576;
                                                        phi_8809_ = _e3551;
                                                        phi_8810_ = _e3555;
                                                        phi_8811_ = _e3557;
                                                        phi_8812_ = _e3559;
                                                        phi_8813_ = _e3581;
                                                        phi_8814_ = _e3583;
                                                        phi_8815_ = false;
                                                        phi_8816_ = false;
                                                        phi_8817_ = false;
                                                    } else {
                                                        phi_8808_ = _e2524;
                                                        phi_8809_ = _e2526;
                                                        phi_8810_ = _e2528;
                                                        phi_8811_ = _e2530;
                                                        phi_8812_ = _e3549;
                                                        phi_8813_ = _e3563;
                                                        phi_8814_ = false;
                                                        phi_8815_ = _e3565;
                                                        phi_8816_ = _e3567;
                                                        phi_8817_ = _e3569;
                                                    }
                                                    let _e3585 = phi_8808_;
                                                    let _e3587 = phi_8809_;
                                                    let _e3589 = phi_8810_;
                                                    let _e3591 = phi_8811_;
                                                    let _e3593 = phi_8812_;
                                                    let _e3595 = phi_8813_;
                                                    let _e3597 = phi_8814_;
                                                    let _e3599 = phi_8815_;
                                                    let _e3601 = phi_8816_;
                                                    let _e3603 = phi_8817_;
                                                    phi_7118_ = _e3585;
                                                    phi_7120_ = _e3587;
                                                    phi_7122_ = _e3589;
                                                    phi_7124_ = _e3591;
                                                    phi_7126_ = _e3593;
                                                    phi_8818_ = _e3551;
                                                    phi_8819_ = _e3595;
                                                    phi_8820_ = _e3597;
                                                    phi_8821_ = false;
                                                    phi_8822_ = _e3599;
                                                    phi_8823_ = _e3601;
                                                    phi_8824_ = _e3603;
                                                } else {
                                                    phi_7118_ = f64();
                                                    phi_7120_ = f64();
                                                    phi_7122_ = f64();
                                                    phi_7124_ = bool();
                                                    phi_7126_ = u32();
                                                    phi_8818_ = f64();
                                                    phi_8819_ = false;
                                                    phi_8820_ = false;
                                                    phi_8821_ = true;
                                                    phi_8822_ = false;
                                                    phi_8823_ = false;
                                                    phi_8824_ = false;
                                                }
                                                let _e3605 = phi_7118_;
                                                let _e3607 = phi_7120_;
                                                let _e3609 = phi_7122_;
                                                let _e3611 = phi_7124_;
                                                let _e3613 = phi_7126_;
                                                let _e3615 = phi_8818_;
                                                let _e3617 = phi_8819_;
                                                let _e3619 = phi_8820_;
                                                let _e3621 = phi_8821_;
                                                let _e3623 = phi_8822_;
                                                let _e3625 = phi_8823_;
                                                let _e3627 = phi_8824_;
                                                local_19 = _e3619;
                                                local_35 = _e3615;
                                                local_37 = _e3621;
                                                local_38 = _e3623;
                                                local_39 = _e3625;
                                                local_40 = _e3627;
                                                continue;
                                                continuing {
                                                    phi_7114_ = _e2544;
                                                    phi_7117_ = _e3605;
                                                    phi_7119_ = _e3607;
                                                    phi_7121_ = _e3609;
                                                    phi_7123_ = _e3611;
                                                    phi_7125_ = _e3613;
                                                    break if !(_e3617);
                                                }
                                            }
                                            let _e3630 = local_19;
                                            if _e3630 {
                                                let _e6135 = local_35;
                                                phi_8828_ = _e6135;
                                                phi_8829_ = true;
                                                phi_8830_ = false;
                                                phi_8831_ = false;
                                                phi_8832_ = false;
                                            } else {
                                                let _e6137 = local_36;
                                                phi_8828_ = _e6137;
                                                let _e6140 = local_37;
                                                phi_8829_ = _e6140;
                                                let _e6143 = local_38;
                                                phi_8830_ = _e6143;
                                                let _e6146 = local_39;
                                                phi_8831_ = _e6146;
                                                let _e6149 = local_40;
                                                phi_8832_ = _e6149;
                                            }
                                            let _e3632 = phi_8828_;
                                            let _e3634 = phi_8829_;
                                            let _e3636 = phi_8830_;
                                            let _e3638 = phi_8831_;
                                            let _e3640 = phi_8832_;
                                            if _e3634 {
                                                phi_8837_ = type_44(1u, _e3632);
                                                phi_8838_ = false;
                                                phi_8839_ = false;
                                                phi_8840_ = false;
                                            } else {
                                                phi_8837_ = type_44();
                                                phi_8838_ = _e3636;
                                                phi_8839_ = _e3638;
                                                phi_8840_ = _e3640;
                                            }
                                            let _e3643 = phi_8837_;
                                            let _e3645 = phi_8838_;
                                            let _e3647 = phi_8839_;
                                            let _e3649 = phi_8840_;
                                            if _e3645 {
                                                let _e3651 = local_20;
                                                phi_8845_ = type_44(1u, _e3651);
                                                phi_8846_ = false;
                                                phi_8847_ = false;
                                            } else {
                                                phi_8845_ = type_44();
                                                phi_8846_ = _e3647;
                                                phi_8847_ = _e3649;
                                            }
                                            let _e3654 = phi_8845_;
                                            let _e3656 = phi_8846_;
                                            let _e3658 = phi_8847_;
                                            if _e3656 {
                                                phi_8852_ = type_44(0u, type_44().member_1);
                                                phi_8853_ = false;
                                                phi_8854_ = true;
                                            } else {
                                                phi_8852_ = _e3654;
                                                phi_8853_ = _e3658;
                                                phi_8854_ = _e3645;
                                            }
                                            let _e3662 = phi_8852_;
                                            let _e3664 = phi_8853_;
                                            let _e3666 = phi_8854_;
                                            if _e3664 {
                                                phi_8859_ = type_44(0u, type_44().member_1);
                                                phi_8860_ = true;
                                            } else {
                                                phi_8859_ = _e3662;
                                                phi_8860_ = _e3666;
                                            }
                                            let _e3670 = phi_8859_;
                                            let _e3672 = phi_8860_;
                                            if _e3672 {
                                                phi_8864_ = _e3670;
                                            } else {
                                                phi_8864_ = _e3643;
                                            }
                                            let _e3674 = phi_8864_;
                                            let _e3677 = (_e3674.member != 0u);
                                            if _e3677 {
                                                phi_8871_ = false;
                                            } else {
                                                phi_8871_ = true;
                                            }
                                            let _e3679 = phi_8871_;
                                            phi_8872_ = _e3674.member_1;
                                            phi_8873_ = _e3679;
                                            phi_8874_ = _e3677;
                                            phi_8875_ = false;
                                        } else {
                                            phi_8872_ = f64();
                                            phi_8873_ = false;
                                            phi_8874_ = false;
                                            phi_8875_ = true;
                                        }
                                        let _e3681 = phi_8872_;
                                        let _e3683 = phi_8873_;
                                        let _e3685 = phi_8874_;
                                        let _e3687 = phi_8875_;
                                        phi_8876_ = _e3681;
                                        phi_8877_ = _e3683;
                                        phi_8878_ = _e3685;
                                        phi_8879_ = _e3687;
                                    }
                                    let _e3689 = phi_8876_;
                                    let _e3691 = phi_8877_;
                                    let _e3693 = phi_8878_;
                                    let _e3695 = phi_8879_;
                                    phi_8880_ = _e3689;
                                    phi_8881_ = _e2275;
                                    phi_8882_ = _e3691;
                                    phi_8883_ = _e3693;
                                    phi_8884_ = _e3695;
                                }
                                let _e3697 = phi_8880_;
                                let _e3699 = phi_8881_;
                                let _e3701 = phi_8882_;
                                let _e3703 = phi_8883_;
                                let _e3705 = phi_8884_;
                                if _e3699 {
                                    phi_8888_ = true;
                                    phi_8889_ = false;
                                    phi_8890_ = false;
                                } else {
                                    phi_8888_ = _e3701;
                                    phi_8889_ = _e3703;
                                    phi_8890_ = _e3705;
                                }
                                let _e3707 = phi_8888_;
                                let _e3709 = phi_8889_;
                                let _e3711 = phi_8890_;
                                phi_8891_ = _e3697;
                                phi_8892_ = _e1551;
                                phi_8893_ = _e3707;
                                phi_8894_ = false;
                                phi_8895_ = _e3709;
                                phi_8896_ = _e3711;
                            } else {
                                phi_8891_ = f64();
                                phi_8892_ = type_45();
                                phi_8893_ = false;
                                phi_8894_ = true;
                                phi_8895_ = false;
                                phi_8896_ = false;
                            }
                            let _e3713 = phi_8891_;
                            let _e3715 = phi_8892_;
                            let _e3717 = phi_8893_;
                            let _e3719 = phi_8894_;
                            let _e3721 = phi_8895_;
                            let _e3723 = phi_8896_;
                            local_21 = _e3719;
                            local_41 = _e3721;
                            local_42 = _e3723;
                            local_22 = _e3713;
                            local_23 = _e3715;
                            continue;
                            continuing {
                                phi_5191_ = _e1264;
                                break if !(_e3717);
                            }
                        }
                        let _e3726 = local_21;
                        if _e3726 {
                            phi_8901_ = type_44(0u, type_44().member_1);
                            phi_8902_ = false;
                            phi_8903_ = false;
                        } else {
                            phi_8901_ = type_44();
                            let _e6191 = local_41;
                            phi_8902_ = _e6191;
                            let _e6194 = local_42;
                            phi_8903_ = _e6194;
                        }
                        let _e3730 = phi_8901_;
                        let _e3732 = phi_8902_;
                        let _e3734 = phi_8903_;
                        if _e3732 {
                            let _e3736 = local_22;
                            phi_8908_ = type_44(2u, _e3736);
                            phi_8909_ = false;
                        } else {
                            phi_8908_ = type_44();
                            phi_8909_ = _e3734;
                        }
                        let _e3739 = phi_8908_;
                        let _e3741 = phi_8909_;
                        if _e3741 {
                            let _e3743 = local_23;
                            phi_8915_ = type_44(1u, _e3743.member);
                            phi_8916_ = true;
                        } else {
                            phi_8915_ = _e3739;
                            phi_8916_ = _e3732;
                        }
                        let _e3747 = phi_8915_;
                        let _e3749 = phi_8916_;
                        if _e3749 {
                            phi_8920_ = _e3747;
                        } else {
                            phi_8920_ = _e3730;
                        }
                        let _e3751 = phi_8920_;
                        phi_8924_ = _e3751;
                    }
                    let _e5518 = phi_8924_;
                    phi_8925_ = _e5518;
                }
                let _e5522 = phi_8925_;
                switch bitcast<i32>(_e5522.member) {
                    case 0: {
                        phi_8938_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5528 = function_3(_e5522.member_1);
                        phi_8938_ = type_32(0u, _e5528, true);
                        break;
                    }
                    case 2: {
                        let _e5526 = function_3(_e5522.member_1);
                        phi_8938_ = type_32(1u, _e5526, true);
                        break;
                    }
                    default: {
                        phi_8938_ = type_32();
                        break;
                    }
                }
                let _e5531 = phi_8938_;
                if _e5531.member_2 {
                    let _e5538 = (_e5531.member_1[1] >> bitcast<u32>(20i));
                    if (_e5538 <= 896u) {
                        phi_8961_ = 0u;
                    } else {
                        phi_8961_ = ((((_e5538 - 896u) << bitcast<u32>(23i)) | ((_e5531.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5531.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5553 = phi_8961_;
                    let _e5555 = atomicMin((&earliest.member[0u]), _e5553);
                }
                phi_8965_ = type_22(0u, _e5531.member, _e181, _e184, _e5531.member_1);
                phi_8966_ = _e5531.member_2;
            } else {
                phi_8965_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8966_ = false;
            }
            let _e5557 = phi_8965_;
            let _e5559 = phi_8966_;
            let _e5562 = params.member.member.member_1;
            if ((_e5562 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5559 {
                    let _e5568 = atomicAdd((&counters[0u]), 1u);
                    phi_8985_ = _e5568;
                } else {
                    phi_8985_ = 0u;
                }
                let _e5570 = phi_8985_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5573 = atomicLoad((&counters[0u]));
                    if (_e5573 > 0u) {
                        let _e5576 = atomicAdd((&contacts.member[0u]), _e5573);
                        atomicStore((&counters[1u]), _e5576);
                    }
                }
                workgroupBarrier();
                let _e5579 = atomicLoad((&counters[1u]));
                let _e5580 = (_e5579 + _e5570);
                if _e5559 {
                    let _e5583 = params.member.member_1.member_3;
                    if (_e5580 < _e5583) {
                        let _e5585 = (6u * _e5580);
                        atomicStore((&contacts.member[(4u + _e5585)]), _e5557.member);
                        atomicStore((&contacts.member[(_e5585 + 5u)]), _e5557.member_1);
                        atomicStore((&contacts.member[(_e5585 + 6u)]), _e5557.member_2);
                        atomicStore((&contacts.member[(_e5585 + 7u)]), _e5557.member_3);
                        atomicStore((&contacts.member[(_e5585 + 8u)]), _e5557.member_4[0]);
                        atomicStore((&contacts.member[(_e5585 + 9u)]), _e5557.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_846_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
