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
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_49;
@group(0) @binding(2) 
var<storage> positions: type_31;
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
    var phi_846_: type_12;
    var phi_847_: type_12;
    var phi_870_: type_12;
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
    var phi_5455_: f64;
    var phi_5461_: f64;
    var phi_5466_: f64;
    var phi_5472_: f64;
    var phi_5478_: f64;
    var phi_5483_: f64;
    var phi_5488_: f64;
    var phi_5498_: bool;
    var phi_5505_: f64;
    var phi_5513_: f64;
    var phi_5556_: type_16;
    var phi_5559_: f64;
    var phi_5580_: bool;
    var phi_5586_: type_17;
    var phi_5557_: type_16;
    var phi_5600_: type_17;
    var phi_5560_: f64;
    var local_13: f64;
    var phi_5549_: f64;
    var phi_5613_: f64;
    var phi_5619_: f64;
    var phi_5644_: type_12;
    var phi_5647_: u32;
    var phi_5645_: type_12;
    var phi_5670_: type_12;
    var phi_5714_: u32;
    var phi_5715_: u32;
    var phi_5648_: u32;
    var phi_5716_: u32;
    var phi_5736_: type_12;
    var phi_5737_: type_12;
    var phi_5760_: type_12;
    var phi_5814_: f64;
    var phi_5821_: f64;
    var phi_5833_: bool;
    var phi_5834_: bool;
    var phi_5835_: bool;
    var phi_5836_: bool;
    var phi_5840_: bool;
    var phi_5852_: type_45;
    var phi_5853_: type_45;
    var phi_5854_: bool;
    var phi_5855_: type_45;
    var phi_5856_: bool;
    var phi_5869_: f64;
    var phi_5882_: type_12;
    var phi_5885_: f64;
    var phi_5887_: f64;
    var phi_5889_: f64;
    var phi_5883_: type_12;
    var phi_5912_: type_12;
    var phi_5939_: f64;
    var phi_5940_: f64;
    var phi_5968_: f64;
    var phi_5984_: f64;
    var phi_5991_: bool;
    var phi_5992_: bool;
    var phi_5993_: bool;
    var phi_5999_: f64;
    var phi_6000_: f64;
    var phi_6001_: bool;
    var phi_5886_: f64;
    var phi_5888_: f64;
    var phi_5890_: f64;
    var phi_6002_: f64;
    var phi_6003_: bool;
    var phi_6004_: bool;
    var local_14: bool;
    var phi_6008_: f64;
    var phi_6009_: f64;
    var phi_6019_: f64;
    var phi_6024_: type_12;
    var phi_6027_: f64;
    var phi_6025_: type_12;
    var phi_6050_: type_12;
    var phi_6081_: f64;
    var phi_6082_: bool;
    var phi_6083_: f64;
    var phi_6084_: bool;
    var phi_6085_: bool;
    var phi_6086_: bool;
    var phi_6087_: f64;
    var phi_6028_: f64;
    var phi_6088_: bool;
    var phi_6089_: bool;
    var phi_6090_: bool;
    var phi_6091_: bool;
    var local_15: bool;
    var phi_6095_: bool;
    var phi_6096_: bool;
    var phi_6100_: bool;
    var phi_6104_: f64;
    var phi_6105_: f64;
    var phi_6107_: type_45;
    var phi_6138_: f64;
    var phi_6145_: f64;
    var phi_6150_: f64;
    var phi_6157_: f64;
    var phi_6162_: f64;
    var phi_6175_: f64;
    var phi_6182_: f64;
    var phi_6187_: f64;
    var phi_6194_: f64;
    var phi_6199_: f64;
    var phi_6204_: f64;
    var phi_6263_: f64;
    var phi_6269_: f64;
    var phi_6274_: f64;
    var phi_6280_: f64;
    var phi_6285_: f64;
    var phi_6299_: f64;
    var phi_6305_: f64;
    var phi_6310_: f64;
    var phi_6316_: f64;
    var phi_6321_: f64;
    var phi_6347_: f64;
    var phi_6354_: f64;
    var phi_6359_: f64;
    var phi_6366_: f64;
    var phi_6371_: f64;
    var phi_6384_: f64;
    var phi_6391_: f64;
    var phi_6396_: f64;
    var phi_6403_: f64;
    var phi_6408_: f64;
    var phi_6413_: f64;
    var phi_6472_: f64;
    var phi_6478_: f64;
    var phi_6483_: f64;
    var phi_6489_: f64;
    var phi_6494_: f64;
    var phi_6508_: f64;
    var phi_6514_: f64;
    var phi_6519_: f64;
    var phi_6525_: f64;
    var phi_6530_: f64;
    var phi_6556_: f64;
    var phi_6563_: f64;
    var phi_6568_: f64;
    var phi_6575_: f64;
    var phi_6580_: f64;
    var phi_6593_: f64;
    var phi_6600_: f64;
    var phi_6605_: f64;
    var phi_6612_: f64;
    var phi_6617_: f64;
    var phi_6622_: f64;
    var phi_6681_: f64;
    var phi_6687_: f64;
    var phi_6692_: f64;
    var phi_6698_: f64;
    var phi_6703_: f64;
    var phi_6717_: f64;
    var phi_6723_: f64;
    var phi_6728_: f64;
    var phi_6734_: f64;
    var phi_6739_: f64;
    var phi_6788_: f64;
    var phi_6794_: f64;
    var phi_6822_: f64;
    var phi_6828_: f64;
    var phi_6833_: u32;
    var phi_6834_: u32;
    var phi_6804_: f64;
    var phi_6810_: f64;
    var phi_6815_: u32;
    var phi_6816_: u32;
    var phi_6835_: u32;
    var phi_6836_: u32;
    var phi_6909_: f64;
    var phi_6921_: f64;
    var phi_7064_: f64;
    var phi_7070_: f64;
    var phi_7077_: f64;
    var phi_7133_: type_12;
    var phi_7136_: bool;
    var phi_7134_: type_12;
    var phi_7159_: type_12;
    var phi_7186_: bool;
    var phi_7187_: bool;
    var phi_7137_: bool;
    var phi_7188_: bool;
    var phi_7189_: bool;
    var local_16: bool;
    var phi_7193_: bool;
    var local_17: bool;
    var phi_7200_: u32;
    var phi_7201_: u32;
    var phi_7202_: bool;
    var phi_7203_: u32;
    var phi_7204_: u32;
    var phi_7205_: bool;
    var phi_7209_: u32;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7381_: f64;
    var phi_7388_: f64;
    var phi_7393_: f64;
    var phi_7400_: f64;
    var phi_7405_: f64;
    var phi_7418_: f64;
    var phi_7425_: f64;
    var phi_7430_: f64;
    var phi_7437_: f64;
    var phi_7442_: f64;
    var phi_7447_: f64;
    var phi_7464_: f64;
    var phi_7471_: f64;
    var phi_7476_: f64;
    var phi_7483_: f64;
    var phi_7488_: f64;
    var phi_7502_: f64;
    var phi_7509_: f64;
    var phi_7514_: f64;
    var phi_7521_: f64;
    var phi_7526_: f64;
    var phi_7531_: f64;
    var phi_7548_: f64;
    var phi_7555_: f64;
    var phi_7560_: f64;
    var phi_7567_: f64;
    var phi_7572_: f64;
    var phi_7586_: f64;
    var phi_7593_: f64;
    var phi_7598_: f64;
    var phi_7605_: f64;
    var phi_7610_: f64;
    var phi_7615_: f64;
    var phi_7660_: type_12;
    var phi_7663_: f64;
    var phi_7665_: f64;
    var phi_7667_: f64;
    var phi_7669_: f64;
    var phi_7671_: bool;
    var phi_7673_: u32;
    var phi_7661_: type_12;
    var phi_7696_: type_12;
    var phi_7811_: f64;
    var phi_7817_: f64;
    var phi_7823_: f64;
    var phi_7825_: array<f64, 3>;
    var phi_7832_: f64;
    var phi_7839_: f64;
    var phi_7847_: f64;
    var phi_7893_: type_16;
    var phi_7896_: f64;
    var phi_7917_: bool;
    var phi_7923_: type_17;
    var phi_7894_: type_16;
    var phi_7937_: type_17;
    var phi_7897_: f64;
    var local_18: f64;
    var phi_7886_: f64;
    var phi_7950_: f64;
    var phi_8019_: f64;
    var phi_8025_: f64;
    var phi_8034_: f64;
    var phi_8040_: f64;
    var phi_8049_: f64;
    var phi_8055_: f64;
    var phi_8064_: f64;
    var phi_8070_: f64;
    var phi_8076_: type_34;
    var phi_8077_: bool;
    var phi_8078_: type_34;
    var phi_8079_: bool;
    var phi_8089_: type_34;
    var phi_8261_: bool;
    var phi_8262_: bool;
    var phi_8263_: bool;
    var phi_8264_: bool;
    var phi_8265_: bool;
    var phi_8266_: bool;
    var phi_8270_: bool;
    var phi_8568_: bool;
    var phi_8569_: bool;
    var phi_8570_: bool;
    var phi_8571_: bool;
    var phi_8572_: bool;
    var phi_8573_: bool;
    var phi_8577_: bool;
    var phi_8581_: bool;
    var phi_8592_: bool;
    var phi_8593_: bool;
    var phi_8667_: bool;
    var phi_8668_: bool;
    var phi_8691_: f64;
    var phi_8692_: bool;
    var phi_8693_: f64;
    var phi_8694_: bool;
    var phi_8695_: f64;
    var phi_8696_: bool;
    var phi_8697_: bool;
    var phi_8702_: f64;
    var phi_8703_: bool;
    var phi_8707_: f64;
    var phi_8739_: bool;
    var phi_8740_: bool;
    var phi_8763_: f64;
    var phi_8764_: bool;
    var phi_8765_: f64;
    var phi_8766_: bool;
    var phi_8767_: f64;
    var phi_8768_: bool;
    var phi_8769_: bool;
    var phi_8774_: f64;
    var phi_8775_: bool;
    var phi_8779_: f64;
    var phi_8784_: f64;
    var phi_8816_: bool;
    var phi_8817_: bool;
    var phi_8840_: f64;
    var phi_8841_: bool;
    var phi_8842_: f64;
    var phi_8843_: bool;
    var phi_8844_: f64;
    var phi_8845_: bool;
    var phi_8846_: bool;
    var phi_8851_: f64;
    var phi_8852_: bool;
    var phi_8856_: f64;
    var phi_8888_: bool;
    var phi_8889_: bool;
    var phi_8912_: f64;
    var phi_8913_: bool;
    var phi_8914_: f64;
    var phi_8915_: bool;
    var phi_8916_: f64;
    var phi_8917_: bool;
    var phi_8918_: bool;
    var phi_8923_: f64;
    var phi_8924_: bool;
    var phi_8928_: f64;
    var phi_8933_: f64;
    var phi_8938_: f64;
    var phi_8943_: f64;
    var phi_8957_: f64;
    var phi_9095_: type_16;
    var phi_9098_: f64;
    var phi_9119_: bool;
    var phi_9125_: type_17;
    var phi_9096_: type_16;
    var phi_9139_: type_17;
    var phi_9099_: f64;
    var local_19: f64;
    var phi_9088_: f64;
    var phi_9152_: f64;
    var phi_9170_: f64;
    var phi_9177_: f64;
    var phi_9182_: f64;
    var phi_9189_: f64;
    var phi_9194_: f64;
    var phi_9207_: f64;
    var phi_9214_: f64;
    var phi_9219_: f64;
    var phi_9226_: f64;
    var phi_9231_: f64;
    var phi_9236_: f64;
    var phi_9253_: f64;
    var phi_9260_: f64;
    var phi_9265_: f64;
    var phi_9272_: f64;
    var phi_9277_: f64;
    var phi_9291_: f64;
    var phi_9298_: f64;
    var phi_9303_: f64;
    var phi_9310_: f64;
    var phi_9315_: f64;
    var phi_9320_: f64;
    var phi_9337_: f64;
    var phi_9344_: f64;
    var phi_9349_: f64;
    var phi_9356_: f64;
    var phi_9361_: f64;
    var phi_9375_: f64;
    var phi_9382_: f64;
    var phi_9387_: f64;
    var phi_9394_: f64;
    var phi_9399_: f64;
    var phi_9404_: f64;
    var phi_9428_: bool;
    var phi_9429_: bool;
    var phi_9430_: bool;
    var phi_9447_: f64;
    var phi_9448_: bool;
    var phi_9449_: f64;
    var phi_9450_: bool;
    var phi_9455_: f64;
    var phi_9457_: f64;
    var phi_9458_: f64;
    var phi_9459_: bool;
    var phi_9460_: f64;
    var phi_9461_: f64;
    var phi_9462_: bool;
    var phi_9463_: bool;
    var phi_9464_: f64;
    var phi_9465_: f64;
    var phi_9466_: f64;
    var phi_9467_: f64;
    var phi_9468_: bool;
    var phi_9469_: bool;
    var phi_9470_: bool;
    var phi_9471_: bool;
    var phi_9472_: f64;
    var phi_9473_: f64;
    var phi_9474_: f64;
    var phi_9475_: f64;
    var phi_9476_: bool;
    var phi_9477_: bool;
    var phi_9478_: bool;
    var phi_9479_: bool;
    var phi_9480_: bool;
    var phi_9481_: f64;
    var phi_9482_: f64;
    var phi_9483_: f64;
    var phi_9484_: f64;
    var phi_9485_: bool;
    var phi_9486_: bool;
    var phi_9487_: bool;
    var phi_9488_: bool;
    var phi_9489_: bool;
    var phi_9575_: f64;
    var phi_9648_: f64;
    var phi_9653_: f64;
    var phi_9726_: f64;
    var phi_9799_: f64;
    var phi_9804_: f64;
    var phi_9825_: f64;
    var phi_9826_: f64;
    var phi_9827_: f64;
    var phi_9502_: bool;
    var phi_9829_: u32;
    var phi_9830_: f64;
    var phi_9831_: bool;
    var phi_9832_: bool;
    var phi_9833_: bool;
    var phi_9834_: u32;
    var phi_9835_: f64;
    var phi_9836_: f64;
    var phi_9837_: f64;
    var phi_9838_: f64;
    var phi_9839_: bool;
    var phi_9840_: u32;
    var phi_9841_: bool;
    var phi_9842_: bool;
    var phi_9843_: bool;
    var phi_9844_: bool;
    var phi_9845_: bool;
    var phi_9846_: bool;
    var phi_9855_: f64;
    var phi_9860_: f64;
    var phi_9870_: bool;
    var phi_9874_: bool;
    var phi_9875_: f64;
    var phi_9876_: f64;
    var phi_9877_: f64;
    var phi_9878_: f64;
    var phi_9879_: bool;
    var phi_9880_: u32;
    var phi_9881_: bool;
    var phi_9882_: bool;
    var phi_9883_: bool;
    var phi_9884_: bool;
    var phi_9885_: bool;
    var phi_9886_: bool;
    var phi_7664_: f64;
    var phi_7666_: f64;
    var phi_7668_: f64;
    var phi_7670_: f64;
    var phi_7672_: bool;
    var phi_7674_: u32;
    var phi_9887_: f64;
    var phi_9888_: f64;
    var phi_9889_: bool;
    var phi_9890_: bool;
    var phi_9891_: bool;
    var phi_9892_: bool;
    var phi_9893_: bool;
    var phi_9894_: bool;
    var phi_9895_: bool;
    var local_20: bool;
    var phi_9899_: bool;
    var phi_9900_: bool;
    var phi_9901_: bool;
    var phi_9902_: bool;
    var phi_9903_: bool;
    var local_21: f64;
    var phi_9908_: type_44;
    var phi_9909_: bool;
    var phi_9910_: bool;
    var phi_9911_: bool;
    var phi_9912_: bool;
    var phi_9913_: bool;
    var phi_9918_: type_44;
    var phi_9919_: bool;
    var phi_9920_: bool;
    var phi_9921_: bool;
    var phi_9922_: bool;
    var phi_9923_: bool;
    var phi_9927_: f64;
    var phi_9928_: bool;
    var phi_9929_: bool;
    var phi_9930_: bool;
    var phi_9931_: bool;
    var phi_9935_: f64;
    var phi_9936_: bool;
    var phi_9937_: bool;
    var phi_9938_: bool;
    var phi_9943_: type_44;
    var phi_9944_: bool;
    var phi_9945_: bool;
    var phi_9950_: type_44;
    var phi_9951_: bool;
    var phi_9955_: type_44;
    var phi_9962_: bool;
    var phi_9963_: f64;
    var phi_9964_: bool;
    var phi_9965_: bool;
    var phi_9966_: bool;
    var phi_9967_: f64;
    var phi_9968_: bool;
    var phi_9969_: bool;
    var phi_9970_: bool;
    var phi_9971_: f64;
    var phi_9972_: bool;
    var phi_9973_: bool;
    var phi_9974_: bool;
    var phi_9975_: bool;
    var phi_9979_: bool;
    var phi_9980_: bool;
    var phi_9981_: bool;
    var phi_9982_: f64;
    var phi_9983_: type_45;
    var phi_9984_: bool;
    var phi_9985_: bool;
    var phi_9986_: bool;
    var phi_9987_: bool;
    var local_22: bool;
    var phi_9992_: type_44;
    var phi_9993_: bool;
    var phi_9994_: bool;
    var local_23: f64;
    var phi_9999_: type_44;
    var phi_10000_: bool;
    var local_24: type_45;
    var phi_10006_: type_44;
    var phi_10007_: bool;
    var phi_10011_: type_44;
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
    var phi_2606_: type_12;
    var phi_2609_: f64;
    var phi_2611_: f64;
    var phi_2613_: f64;
    var phi_2615_: f64;
    var phi_2617_: bool;
    var phi_2619_: u32;
    var phi_2607_: type_12;
    var phi_2642_: type_12;
    var phi_2757_: f64;
    var phi_2763_: f64;
    var phi_2769_: f64;
    var phi_2771_: array<f64, 3>;
    var phi_2778_: f64;
    var phi_2785_: f64;
    var phi_2793_: f64;
    var phi_2839_: type_16;
    var phi_2842_: f64;
    var phi_2863_: bool;
    var phi_2869_: type_17;
    var phi_2840_: type_16;
    var phi_2883_: type_17;
    var phi_2843_: f64;
    var local_25: f64;
    var phi_2832_: f64;
    var phi_2896_: f64;
    var phi_2965_: f64;
    var phi_2971_: f64;
    var phi_2980_: f64;
    var phi_2986_: f64;
    var phi_2995_: f64;
    var phi_3001_: f64;
    var phi_3010_: f64;
    var phi_3016_: f64;
    var phi_3022_: type_34;
    var phi_3023_: bool;
    var phi_3024_: type_34;
    var phi_3025_: bool;
    var phi_3035_: type_34;
    var phi_3207_: bool;
    var phi_3208_: bool;
    var phi_3209_: bool;
    var phi_3210_: bool;
    var phi_3211_: bool;
    var phi_3212_: bool;
    var phi_3216_: bool;
    var phi_3514_: bool;
    var phi_3515_: bool;
    var phi_3516_: bool;
    var phi_3517_: bool;
    var phi_3518_: bool;
    var phi_3519_: bool;
    var phi_3523_: bool;
    var phi_3527_: bool;
    var phi_3538_: bool;
    var phi_3539_: bool;
    var phi_3613_: bool;
    var phi_3614_: bool;
    var phi_3637_: f64;
    var phi_3638_: bool;
    var phi_3639_: f64;
    var phi_3640_: bool;
    var phi_3641_: f64;
    var phi_3642_: bool;
    var phi_3643_: bool;
    var phi_3648_: f64;
    var phi_3649_: bool;
    var phi_3653_: f64;
    var phi_3685_: bool;
    var phi_3686_: bool;
    var phi_3709_: f64;
    var phi_3710_: bool;
    var phi_3711_: f64;
    var phi_3712_: bool;
    var phi_3713_: f64;
    var phi_3714_: bool;
    var phi_3715_: bool;
    var phi_3720_: f64;
    var phi_3721_: bool;
    var phi_3725_: f64;
    var phi_3730_: f64;
    var phi_3762_: bool;
    var phi_3763_: bool;
    var phi_3786_: f64;
    var phi_3787_: bool;
    var phi_3788_: f64;
    var phi_3789_: bool;
    var phi_3790_: f64;
    var phi_3791_: bool;
    var phi_3792_: bool;
    var phi_3797_: f64;
    var phi_3798_: bool;
    var phi_3802_: f64;
    var phi_3834_: bool;
    var phi_3835_: bool;
    var phi_3858_: f64;
    var phi_3859_: bool;
    var phi_3860_: f64;
    var phi_3861_: bool;
    var phi_3862_: f64;
    var phi_3863_: bool;
    var phi_3864_: bool;
    var phi_3869_: f64;
    var phi_3870_: bool;
    var phi_3874_: f64;
    var phi_3879_: f64;
    var phi_3884_: f64;
    var phi_3889_: f64;
    var phi_3903_: f64;
    var phi_4041_: type_16;
    var phi_4044_: f64;
    var phi_4065_: bool;
    var phi_4071_: type_17;
    var phi_4042_: type_16;
    var phi_4085_: type_17;
    var phi_4045_: f64;
    var local_26: f64;
    var phi_4034_: f64;
    var phi_4098_: f64;
    var phi_4116_: f64;
    var phi_4123_: f64;
    var phi_4128_: f64;
    var phi_4135_: f64;
    var phi_4140_: f64;
    var phi_4153_: f64;
    var phi_4160_: f64;
    var phi_4165_: f64;
    var phi_4172_: f64;
    var phi_4177_: f64;
    var phi_4182_: f64;
    var phi_4199_: f64;
    var phi_4206_: f64;
    var phi_4211_: f64;
    var phi_4218_: f64;
    var phi_4223_: f64;
    var phi_4237_: f64;
    var phi_4244_: f64;
    var phi_4249_: f64;
    var phi_4256_: f64;
    var phi_4261_: f64;
    var phi_4266_: f64;
    var phi_4283_: f64;
    var phi_4290_: f64;
    var phi_4295_: f64;
    var phi_4302_: f64;
    var phi_4307_: f64;
    var phi_4321_: f64;
    var phi_4328_: f64;
    var phi_4333_: f64;
    var phi_4340_: f64;
    var phi_4345_: f64;
    var phi_4350_: f64;
    var phi_4374_: bool;
    var phi_4375_: bool;
    var phi_4376_: bool;
    var phi_4393_: f64;
    var phi_4394_: bool;
    var phi_4395_: f64;
    var phi_4396_: bool;
    var phi_4401_: f64;
    var phi_4403_: f64;
    var phi_4404_: f64;
    var phi_4405_: bool;
    var phi_4406_: f64;
    var phi_4407_: f64;
    var phi_4408_: bool;
    var phi_4409_: bool;
    var phi_4410_: f64;
    var phi_4411_: f64;
    var phi_4412_: f64;
    var phi_4413_: f64;
    var phi_4414_: bool;
    var phi_4415_: bool;
    var phi_4416_: bool;
    var phi_4417_: bool;
    var phi_4418_: f64;
    var phi_4419_: f64;
    var phi_4420_: f64;
    var phi_4421_: f64;
    var phi_4422_: bool;
    var phi_4423_: bool;
    var phi_4424_: bool;
    var phi_4425_: bool;
    var phi_4426_: bool;
    var phi_4427_: f64;
    var phi_4428_: f64;
    var phi_4429_: f64;
    var phi_4430_: f64;
    var phi_4431_: bool;
    var phi_4432_: bool;
    var phi_4433_: bool;
    var phi_4434_: bool;
    var phi_4435_: bool;
    var phi_4521_: f64;
    var phi_4594_: f64;
    var phi_4599_: f64;
    var phi_4672_: f64;
    var phi_4745_: f64;
    var phi_4750_: f64;
    var phi_4771_: f64;
    var phi_4772_: f64;
    var phi_4773_: f64;
    var phi_4448_: bool;
    var phi_4775_: u32;
    var phi_4776_: f64;
    var phi_4777_: bool;
    var phi_4778_: bool;
    var phi_4779_: bool;
    var phi_4780_: u32;
    var phi_4781_: f64;
    var phi_4782_: f64;
    var phi_4783_: f64;
    var phi_4784_: f64;
    var phi_4785_: bool;
    var phi_4786_: u32;
    var phi_4787_: bool;
    var phi_4788_: bool;
    var phi_4789_: bool;
    var phi_4790_: bool;
    var phi_4791_: bool;
    var phi_4792_: bool;
    var phi_4801_: f64;
    var phi_4806_: f64;
    var phi_4816_: bool;
    var phi_4820_: bool;
    var phi_4821_: f64;
    var phi_4822_: f64;
    var phi_4823_: f64;
    var phi_4824_: f64;
    var phi_4825_: bool;
    var phi_4826_: u32;
    var phi_4827_: bool;
    var phi_4828_: bool;
    var phi_4829_: bool;
    var phi_4830_: bool;
    var phi_4831_: bool;
    var phi_4832_: bool;
    var phi_2610_: f64;
    var phi_2612_: f64;
    var phi_2614_: f64;
    var phi_2616_: f64;
    var phi_2618_: bool;
    var phi_2620_: u32;
    var phi_4833_: f64;
    var phi_4834_: f64;
    var phi_4835_: bool;
    var phi_4836_: bool;
    var phi_4837_: bool;
    var phi_4838_: bool;
    var phi_4839_: bool;
    var phi_4840_: bool;
    var phi_4841_: bool;
    var local_27: bool;
    var phi_4845_: bool;
    var phi_4846_: bool;
    var phi_4847_: bool;
    var phi_4848_: bool;
    var phi_4849_: bool;
    var local_28: f64;
    var phi_4854_: type_44;
    var phi_4855_: bool;
    var phi_4856_: bool;
    var phi_4857_: bool;
    var phi_4858_: bool;
    var phi_4859_: bool;
    var phi_4864_: type_44;
    var phi_4865_: bool;
    var phi_4866_: bool;
    var phi_4867_: bool;
    var phi_4868_: bool;
    var phi_4869_: bool;
    var phi_4873_: f64;
    var phi_4874_: bool;
    var phi_4875_: bool;
    var phi_4876_: bool;
    var phi_4877_: bool;
    var phi_4881_: f64;
    var phi_4882_: bool;
    var phi_4883_: bool;
    var phi_4884_: bool;
    var phi_4889_: type_44;
    var phi_4890_: bool;
    var phi_4891_: bool;
    var phi_4896_: type_44;
    var phi_4897_: bool;
    var phi_4901_: type_44;
    var phi_4914_: type_12;
    var phi_4915_: type_12;
    var phi_4938_: type_12;
    var phi_4959_: f64;
    var phi_5089_: type_16;
    var phi_5092_: f64;
    var phi_5113_: bool;
    var phi_5119_: type_17;
    var phi_5090_: type_16;
    var phi_5133_: type_17;
    var phi_5093_: f64;
    var local_29: f64;
    var phi_5082_: f64;
    var phi_5146_: f64;
    var phi_5164_: f64;
    var phi_5171_: f64;
    var phi_5176_: f64;
    var phi_5183_: f64;
    var phi_5188_: f64;
    var phi_5201_: f64;
    var phi_5208_: f64;
    var phi_5213_: f64;
    var phi_5220_: f64;
    var phi_5225_: f64;
    var phi_5230_: f64;
    var phi_5247_: f64;
    var phi_5254_: f64;
    var phi_5259_: f64;
    var phi_5266_: f64;
    var phi_5271_: f64;
    var phi_5285_: f64;
    var phi_5292_: f64;
    var phi_5297_: f64;
    var phi_5304_: f64;
    var phi_5309_: f64;
    var phi_5314_: f64;
    var phi_5331_: f64;
    var phi_5338_: f64;
    var phi_5343_: f64;
    var phi_5350_: f64;
    var phi_5355_: f64;
    var phi_5369_: f64;
    var phi_5376_: f64;
    var phi_5381_: f64;
    var phi_5388_: f64;
    var phi_5393_: f64;
    var phi_5398_: f64;
    var phi_5422_: bool;
    var phi_5423_: bool;
    var phi_5424_: bool;
    var local_30: bool;
    var phi_5429_: type_44;
    var phi_5430_: bool;
    var phi_5435_: type_44;
    var phi_5436_: bool;
    var phi_5438_: type_44;
    var phi_5439_: type_44;
    var phi_5440_: bool;
    var phi_5444_: type_44;
    var phi_10015_: type_44;
    var phi_10016_: type_44;
    var phi_10029_: type_32;
    var phi_10052_: u32;
    var phi_10056_: type_22;
    var phi_10057_: bool;
    var phi_10076_: u32;
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
    phi_846_ = type_12(0u, _e151);
    loop {
        let _e154 = phi_846_;
        if (_e154.member < _e154.member_1) {
            phi_847_ = type_12((_e154.member + 1u), _e154.member_1);
            phi_870_ = type_12(1u, _e154.member);
        } else {
            phi_847_ = _e154;
            phi_870_ = type_12(0u, type_12().member_1);
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
                    phi_10016_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e575.member_1 > f64(0f)) {
                        let _e4169 = f64(1f);
                        let _e4170 = f64(0f);
                        let _e4173 = local_12.member[0u];
                        let _e4179 = local_12.member_1[0u];
                        let _e4185 = local_12.member_2[0u];
                        let _e4197 = local_12.member[1u];
                        let _e4203 = local_12.member_1[1u];
                        let _e4209 = local_12.member_2[1u];
                        let _e4221 = local_12.member[0u];
                        if (_e4221[0] < 0.0lf) {
                            phi_2327_ = -(_e4221[0]);
                        } else {
                            phi_2327_ = _e4221[0];
                        }
                        let _e4228 = phi_2327_;
                        if (_e4221[1] < 0.0lf) {
                            phi_2334_ = -(_e4221[1]);
                        } else {
                            phi_2334_ = _e4221[1];
                        }
                        let _e4232 = phi_2334_;
                        if (_e4228 > _e4232) {
                            phi_2339_ = _e4228;
                        } else {
                            phi_2339_ = _e4232;
                        }
                        let _e4235 = phi_2339_;
                        if (_e4221[2] < 0.0lf) {
                            phi_2346_ = -(_e4221[2]);
                        } else {
                            phi_2346_ = _e4221[2];
                        }
                        let _e4239 = phi_2346_;
                        if (_e4235 > _e4239) {
                            phi_2351_ = _e4235;
                        } else {
                            phi_2351_ = _e4239;
                        }
                        let _e4242 = phi_2351_;
                        let _e4245 = local_12.member[1u];
                        if (_e4245[0] < 0.0lf) {
                            phi_2364_ = -(_e4245[0]);
                        } else {
                            phi_2364_ = _e4245[0];
                        }
                        let _e4252 = phi_2364_;
                        if (_e4245[1] < 0.0lf) {
                            phi_2371_ = -(_e4245[1]);
                        } else {
                            phi_2371_ = _e4245[1];
                        }
                        let _e4256 = phi_2371_;
                        if (_e4252 > _e4256) {
                            phi_2376_ = _e4252;
                        } else {
                            phi_2376_ = _e4256;
                        }
                        let _e4259 = phi_2376_;
                        if (_e4245[2] < 0.0lf) {
                            phi_2383_ = -(_e4245[2]);
                        } else {
                            phi_2383_ = _e4245[2];
                        }
                        let _e4263 = phi_2383_;
                        if (_e4259 > _e4263) {
                            phi_2388_ = _e4259;
                        } else {
                            phi_2388_ = _e4263;
                        }
                        let _e4266 = phi_2388_;
                        if (_e4242 > _e4266) {
                            phi_2393_ = _e4242;
                        } else {
                            phi_2393_ = _e4266;
                        }
                        let _e4269 = phi_2393_;
                        let _e4271 = local_12.member_3;
                        let _e4275 = local_12.member_1[0u];
                        if (_e4275[0] < 0.0lf) {
                            phi_2410_ = -(_e4275[0]);
                        } else {
                            phi_2410_ = _e4275[0];
                        }
                        let _e4282 = phi_2410_;
                        if (_e4275[1] < 0.0lf) {
                            phi_2417_ = -(_e4275[1]);
                        } else {
                            phi_2417_ = _e4275[1];
                        }
                        let _e4286 = phi_2417_;
                        if (_e4282 > _e4286) {
                            phi_2422_ = _e4282;
                        } else {
                            phi_2422_ = _e4286;
                        }
                        let _e4289 = phi_2422_;
                        if (_e4275[2] < 0.0lf) {
                            phi_2429_ = -(_e4275[2]);
                        } else {
                            phi_2429_ = _e4275[2];
                        }
                        let _e4293 = phi_2429_;
                        if (_e4289 > _e4293) {
                            phi_2434_ = _e4289;
                        } else {
                            phi_2434_ = _e4293;
                        }
                        let _e4296 = phi_2434_;
                        let _e4299 = local_12.member_1[1u];
                        if (_e4299[0] < 0.0lf) {
                            phi_2448_ = -(_e4299[0]);
                        } else {
                            phi_2448_ = _e4299[0];
                        }
                        let _e4306 = phi_2448_;
                        if (_e4299[1] < 0.0lf) {
                            phi_2455_ = -(_e4299[1]);
                        } else {
                            phi_2455_ = _e4299[1];
                        }
                        let _e4310 = phi_2455_;
                        if (_e4306 > _e4310) {
                            phi_2460_ = _e4306;
                        } else {
                            phi_2460_ = _e4310;
                        }
                        let _e4313 = phi_2460_;
                        if (_e4299[2] < 0.0lf) {
                            phi_2467_ = -(_e4299[2]);
                        } else {
                            phi_2467_ = _e4299[2];
                        }
                        let _e4317 = phi_2467_;
                        if (_e4313 > _e4317) {
                            phi_2472_ = _e4313;
                        } else {
                            phi_2472_ = _e4317;
                        }
                        let _e4320 = phi_2472_;
                        if (_e4296 > _e4320) {
                            phi_2477_ = _e4296;
                        } else {
                            phi_2477_ = _e4320;
                        }
                        let _e4323 = phi_2477_;
                        let _e4325 = local_12.member_3;
                        let _e4329 = local_12.member_2[0u];
                        if (_e4329[0] < 0.0lf) {
                            phi_2494_ = -(_e4329[0]);
                        } else {
                            phi_2494_ = _e4329[0];
                        }
                        let _e4336 = phi_2494_;
                        if (_e4329[1] < 0.0lf) {
                            phi_2501_ = -(_e4329[1]);
                        } else {
                            phi_2501_ = _e4329[1];
                        }
                        let _e4340 = phi_2501_;
                        if (_e4336 > _e4340) {
                            phi_2506_ = _e4336;
                        } else {
                            phi_2506_ = _e4340;
                        }
                        let _e4343 = phi_2506_;
                        if (_e4329[2] < 0.0lf) {
                            phi_2513_ = -(_e4329[2]);
                        } else {
                            phi_2513_ = _e4329[2];
                        }
                        let _e4347 = phi_2513_;
                        if (_e4343 > _e4347) {
                            phi_2518_ = _e4343;
                        } else {
                            phi_2518_ = _e4347;
                        }
                        let _e4350 = phi_2518_;
                        let _e4353 = local_12.member_2[1u];
                        if (_e4353[0] < 0.0lf) {
                            phi_2532_ = -(_e4353[0]);
                        } else {
                            phi_2532_ = _e4353[0];
                        }
                        let _e4360 = phi_2532_;
                        if (_e4353[1] < 0.0lf) {
                            phi_2539_ = -(_e4353[1]);
                        } else {
                            phi_2539_ = _e4353[1];
                        }
                        let _e4364 = phi_2539_;
                        if (_e4360 > _e4364) {
                            phi_2544_ = _e4360;
                        } else {
                            phi_2544_ = _e4364;
                        }
                        let _e4367 = phi_2544_;
                        if (_e4353[2] < 0.0lf) {
                            phi_2551_ = -(_e4353[2]);
                        } else {
                            phi_2551_ = _e4353[2];
                        }
                        let _e4371 = phi_2551_;
                        if (_e4367 > _e4371) {
                            phi_2556_ = _e4367;
                        } else {
                            phi_2556_ = _e4371;
                        }
                        let _e4374 = phi_2556_;
                        if (_e4350 > _e4374) {
                            phi_2561_ = _e4350;
                        } else {
                            phi_2561_ = _e4374;
                        }
                        let _e4377 = phi_2561_;
                        let _e4379 = local_12.member_3;
                        let _e4387 = local_12.member_3;
                        let _e4394 = f64(0f);
                        let _e4395 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e4394, _e4394, _e4394, _e4394), array<f64, 4>(_e4394, _e4394, _e4394, _e4394), array<f64, 4>(_e4395, _e4395, _e4395, _e4395));
                        phi_2606_ = type_12(0u, 96u);
                        phi_2609_ = _e4170;
                        phi_2611_ = _e4170;
                        phi_2613_ = (_e4169 - _e4170);
                        phi_2615_ = _e4170;
                        phi_2617_ = false;
                        phi_2619_ = 0u;
                        loop {
                            let _e4402 = phi_2606_;
                            let _e4404 = phi_2609_;
                            let _e4406 = phi_2611_;
                            let _e4408 = phi_2613_;
                            let _e4410 = phi_2615_;
                            let _e4412 = phi_2617_;
                            let _e4414 = phi_2619_;
                            local_28 = _e4404;
                            local_56 = _e4406;
                            if (_e4402.member < _e4402.member_1) {
                                phi_2607_ = type_12((_e4402.member + 1u), _e4402.member_1);
                                phi_2642_ = type_12(1u, _e4402.member);
                            } else {
                                phi_2607_ = _e4402;
                                phi_2642_ = type_12(0u, type_12().member_1);
                            }
                            let _e4426 = phi_2607_;
                            let _e4428 = phi_2642_;
                            if (bitcast<i32>(_e4428.member) != 0i) {
                                let _e4434 = local_12.member[0u];
                                let _e4440 = local_12.member[1u];
                                let _e4456 = local_12.member_1[0u];
                                let _e4462 = local_12.member_1[1u];
                                let _e4478 = local_12.member_2[0u];
                                let _e4484 = local_12.member_2[1u];
                                let _e4498 = function_2(array<f64, 3>((_e4434[0] + ((_e4440[0] - _e4434[0]) * _e4404)), (_e4434[1] + ((_e4440[1] - _e4434[1]) * _e4404)), (_e4434[2] + ((_e4440[2] - _e4434[2]) * _e4404))), array<f64, 3>((_e4456[0] + ((_e4462[0] - _e4456[0]) * _e4404)), (_e4456[1] + ((_e4462[1] - _e4456[1]) * _e4404)), (_e4456[2] + ((_e4462[2] - _e4456[2]) * _e4404))), array<f64, 3>((_e4478[0] + ((_e4484[0] - _e4478[0]) * _e4404)), (_e4478[1] + ((_e4484[1] - _e4478[1]) * _e4404)), (_e4478[2] + ((_e4484[2] - _e4478[2]) * _e4404))), 0u);
                                if (_e4414 == 0u) {
                                    phi_2771_ = _e4498;
                                } else {
                                    let _e4500 = f64(0f);
                                    if (_e4414 == 1u) {
                                        phi_2757_ = _e4498[0];
                                    } else {
                                        phi_2757_ = _e4500;
                                    }
                                    let _e4504 = phi_2757_;
                                    if (_e4414 == 2u) {
                                        phi_2763_ = _e4498[1];
                                    } else {
                                        phi_2763_ = _e4500;
                                    }
                                    let _e4508 = phi_2763_;
                                    if (_e4414 == 3u) {
                                        phi_2769_ = _e4498[2];
                                    } else {
                                        phi_2769_ = _e4500;
                                    }
                                    let _e4512 = phi_2769_;
                                    phi_2771_ = array<f64, 3>(_e4504, _e4508, _e4512);
                                }
                                let _e4515 = phi_2771_;
                                if (_e4515[0] < 0.0lf) {
                                    phi_2778_ = -(_e4515[0]);
                                } else {
                                    phi_2778_ = _e4515[0];
                                }
                                let _e4520 = phi_2778_;
                                if (_e4515[1] < 0.0lf) {
                                    phi_2785_ = -(_e4515[1]);
                                } else {
                                    phi_2785_ = _e4515[1];
                                }
                                let _e4525 = phi_2785_;
                                if (_e4515[2] < 0.0lf) {
                                    phi_2793_ = -(_e4515[2]);
                                } else {
                                    phi_2793_ = _e4515[2];
                                }
                                let _e4531 = phi_2793_;
                                let _e4532 = ((_e4520 + _e4525) + _e4531);
                                if (_e4532 > f64(0f)) {
                                    if ((bitcast<u64>(_e4532) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4539 = (f64(1f) / _e4532);
                                        let _e4541 = (_e4515[0] * _e4539);
                                        let _e4543 = (_e4515[1] * _e4539);
                                        let _e4545 = (_e4515[2] * _e4539);
                                        let _e4550 = (((_e4541 * _e4541) + (_e4543 * _e4543)) + (_e4545 * _e4545));
                                        if (_e4550 <= 2.2250738585072014e-308lf) {
                                            if (_e4550 > 0.0lf) {
                                                phi_2832_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2832_ = 0.0lf;
                                            }
                                            let _e4602 = phi_2832_;
                                            phi_2896_ = _e4602;
                                        } else {
                                            phi_2839_ = type_16(0i, 5i);
                                            phi_2842_ = bitcast<f64>(((bitcast<u64>(_e4550) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4557 = phi_2839_;
                                                let _e4559 = phi_2842_;
                                                local_25 = _e4559;
                                                if (_e4557.member < _e4557.member_1) {
                                                    let _e4566 = (_e4557.member + 1i);
                                                    if ((false == (_e4566 > _e4557.member)) != false) {
                                                        phi_2863_ = true;
                                                    } else {
                                                        phi_2863_ = false;
                                                    }
                                                    let _e4571 = phi_2863_;
                                                    if _e4571 {
                                                        phi_2869_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2869_ = type_17(1u, _e4566);
                                                    }
                                                    let _e4576 = phi_2869_;
                                                    phi_2840_ = type_16(_e4576.member_1, _e4557.member_1);
                                                    phi_2883_ = type_17(1u, _e4557.member);
                                                } else {
                                                    phi_2840_ = _e4557;
                                                    phi_2883_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4582 = phi_2840_;
                                                let _e4584 = phi_2883_;
                                                let _e4587 = (bitcast<i32>(_e4584.member) != 0i);
                                                if _e4587 {
                                                    phi_2843_ = (0.5lf * (_e4559 + (_e4550 / _e4559)));
                                                } else {
                                                    phi_2843_ = f64();
                                                }
                                                let _e4592 = phi_2843_;
                                                continue;
                                                continuing {
                                                    phi_2839_ = _e4582;
                                                    phi_2842_ = _e4592;
                                                    break if !(_e4587);
                                                }
                                            }
                                            let _e4597 = local_25;
                                            phi_2896_ = (_e4597 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4604 = phi_2896_;
                                        let _e4606 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4613 = ((((((((_e4269 + _e4271) + (_e4323 + _e4325)) + (_e4377 + _e4379)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4387 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e575.member_1 * _e4604) * (f64(1f) + _e4606)));
                                        let _e4618 = (((_e4541 * _e4173[0]) + (_e4543 * _e4173[1])) + (_e4545 * _e4173[2]));
                                        let _e4623 = (((_e4541 * (_e4173[0] - _e4179[0])) + (_e4543 * (_e4173[1] - _e4179[1]))) + (_e4545 * (_e4173[2] - _e4179[2])));
                                        let _e4628 = (((_e4541 * (_e4173[0] - _e4185[0])) + (_e4543 * (_e4173[1] - _e4185[1]))) + (_e4545 * (_e4173[2] - _e4185[2])));
                                        let _e4633 = (((_e4541 * _e4173[0]) + (_e4543 * _e4173[1])) + (_e4545 * _e4173[2]));
                                        let _e4639 = (((_e4541 * _e4197[0]) + (_e4543 * _e4197[1])) + (_e4545 * _e4197[2]));
                                        let _e4644 = (((_e4541 * (_e4197[0] - _e4203[0])) + (_e4543 * (_e4197[1] - _e4203[1]))) + (_e4545 * (_e4197[2] - _e4203[2])));
                                        let _e4649 = (((_e4541 * (_e4197[0] - _e4209[0])) + (_e4543 * (_e4197[1] - _e4209[1]))) + (_e4545 * (_e4197[2] - _e4209[2])));
                                        let _e4654 = (((_e4541 * _e4197[0]) + (_e4543 * _e4197[1])) + (_e4545 * _e4197[2]));
                                        if (_e4618 < 0.0lf) {
                                            phi_2965_ = -(_e4618);
                                        } else {
                                            phi_2965_ = _e4618;
                                        }
                                        let _e4659 = phi_2965_;
                                        if (_e4639 < 0.0lf) {
                                            phi_2971_ = -(_e4639);
                                        } else {
                                            phi_2971_ = _e4639;
                                        }
                                        let _e4663 = phi_2971_;
                                        if (_e4623 < 0.0lf) {
                                            phi_2980_ = -(_e4623);
                                        } else {
                                            phi_2980_ = _e4623;
                                        }
                                        let _e4670 = phi_2980_;
                                        if (_e4644 < 0.0lf) {
                                            phi_2986_ = -(_e4644);
                                        } else {
                                            phi_2986_ = _e4644;
                                        }
                                        let _e4674 = phi_2986_;
                                        if (_e4628 < 0.0lf) {
                                            phi_2995_ = -(_e4628);
                                        } else {
                                            phi_2995_ = _e4628;
                                        }
                                        let _e4681 = phi_2995_;
                                        if (_e4649 < 0.0lf) {
                                            phi_3001_ = -(_e4649);
                                        } else {
                                            phi_3001_ = _e4649;
                                        }
                                        let _e4685 = phi_3001_;
                                        if (_e4633 < 0.0lf) {
                                            phi_3010_ = -(_e4633);
                                        } else {
                                            phi_3010_ = _e4633;
                                        }
                                        let _e4692 = phi_3010_;
                                        if (_e4654 < 0.0lf) {
                                            phi_3016_ = -(_e4654);
                                        } else {
                                            phi_3016_ = _e4654;
                                        }
                                        let _e4696 = phi_3016_;
                                        phi_3022_ = type_34(array<f64, 4>(_e4618, _e4623, _e4628, _e4633), array<f64, 4>(_e4639, _e4644, _e4649, _e4654), array<f64, 4>((_e4613 + ((_e4659 + _e4663) * _e4606)), (_e4613 + ((_e4670 + _e4674) * _e4606)), (_e4613 + ((_e4681 + _e4685) * _e4606)), (_e4613 + ((_e4692 + _e4696) * _e4606))));
                                        phi_3023_ = false;
                                    } else {
                                        phi_3022_ = type_34();
                                        phi_3023_ = true;
                                    }
                                    let _e4703 = phi_3022_;
                                    let _e4705 = phi_3023_;
                                    phi_3024_ = _e4703;
                                    phi_3025_ = _e4705;
                                } else {
                                    phi_3024_ = type_34();
                                    phi_3025_ = true;
                                }
                                let _e4707 = phi_3024_;
                                let _e4709 = phi_3025_;
                                if _e4709 {
                                    let _e4710 = f64(0f);
                                    let _e4711 = f64(1f);
                                    phi_3035_ = type_34(array<f64, 4>(_e4710, _e4710, _e4710, _e4710), array<f64, 4>(_e4710, _e4710, _e4710, _e4710), array<f64, 4>(_e4711, _e4711, _e4711, _e4711));
                                } else {
                                    phi_3035_ = _e4707;
                                }
                                let _e4717 = phi_3035_;
                                local_10 = type_34(array<f64, 4>(_e4717.member[0], _e4717.member[1], _e4717.member[2], _e4717.member[3]), array<f64, 4>(_e4717.member_1[0], _e4717.member_1[1], _e4717.member_1[2], _e4717.member_1[3]), array<f64, 4>(_e4717.member_2[0], _e4717.member_2[1], _e4717.member_2[2], _e4717.member_2[3]));
                                let _e4737 = (_e4404 - _e4410);
                                let _e4739 = f64(0f);
                                let _e4742 = local_10.member[0u];
                                let _e4745 = local_10.member_1[0u];
                                let _e4748 = local_10.member[0u];
                                let _e4754 = local_10.member_2[0u];
                                if (((_e4742 + ((_e4745 - _e4748) * _e4404)) - _e4754) > _e4739) {
                                    let _e4759 = local_10.member[1u];
                                    let _e4762 = local_10.member_1[1u];
                                    let _e4765 = local_10.member[1u];
                                    let _e4771 = local_10.member_2[1u];
                                    if (((_e4759 + ((_e4762 - _e4765) * _e4404)) - _e4771) > _e4739) {
                                        let _e4776 = local_10.member[2u];
                                        let _e4779 = local_10.member_1[2u];
                                        let _e4782 = local_10.member[2u];
                                        let _e4788 = local_10.member_2[2u];
                                        if (((_e4776 + ((_e4779 - _e4782) * _e4404)) - _e4788) > _e4739) {
                                            let _e4793 = local_10.member[3u];
                                            let _e4796 = local_10.member_1[3u];
                                            let _e4799 = local_10.member[3u];
                                            let _e4805 = local_10.member_2[3u];
                                            phi_3207_ = (((_e4793 + ((_e4796 - _e4799) * _e4404)) - _e4805) > _e4739);
                                            phi_3208_ = false;
                                        } else {
                                            phi_3207_ = bool();
                                            phi_3208_ = true;
                                        }
                                        let _e4809 = phi_3207_;
                                        let _e4811 = phi_3208_;
                                        phi_3209_ = _e4809;
                                        phi_3210_ = _e4811;
                                    } else {
                                        phi_3209_ = bool();
                                        phi_3210_ = true;
                                    }
                                    let _e4813 = phi_3209_;
                                    let _e4815 = phi_3210_;
                                    phi_3211_ = _e4813;
                                    phi_3212_ = _e4815;
                                } else {
                                    phi_3211_ = bool();
                                    phi_3212_ = true;
                                }
                                let _e4817 = phi_3211_;
                                let _e4819 = phi_3212_;
                                if _e4819 {
                                    phi_3216_ = false;
                                } else {
                                    phi_3216_ = _e4817;
                                }
                                let _e4821 = phi_3216_;
                                if _e4821 {
                                    if (_e4404 <= _e4406) {
                                        phi_3527_ = true;
                                    } else {
                                        let _e4823 = f64(0f);
                                        let _e4826 = local_9.member[0u];
                                        let _e4829 = local_9.member_1[0u];
                                        let _e4832 = local_9.member[0u];
                                        let _e4838 = local_9.member_2[0u];
                                        let _e4842 = local_10.member[0u];
                                        let _e4845 = local_10.member_1[0u];
                                        let _e4848 = local_10.member[0u];
                                        let _e4854 = local_10.member_2[0u];
                                        if ((((_e4826 + ((_e4829 - _e4832) * _e4404)) - _e4838) + ((_e4842 + ((_e4845 - _e4848) * _e4410)) - _e4854)) > _e4823) {
                                            let _e4860 = local_9.member[1u];
                                            let _e4863 = local_9.member_1[1u];
                                            let _e4866 = local_9.member[1u];
                                            let _e4872 = local_9.member_2[1u];
                                            let _e4876 = local_10.member[1u];
                                            let _e4879 = local_10.member_1[1u];
                                            let _e4882 = local_10.member[1u];
                                            let _e4888 = local_10.member_2[1u];
                                            if ((((_e4860 + ((_e4863 - _e4866) * _e4404)) - _e4872) + ((_e4876 + ((_e4879 - _e4882) * _e4410)) - _e4888)) > _e4823) {
                                                let _e4894 = local_9.member[2u];
                                                let _e4897 = local_9.member_1[2u];
                                                let _e4900 = local_9.member[2u];
                                                let _e4906 = local_9.member_2[2u];
                                                let _e4910 = local_10.member[2u];
                                                let _e4913 = local_10.member_1[2u];
                                                let _e4916 = local_10.member[2u];
                                                let _e4922 = local_10.member_2[2u];
                                                if ((((_e4894 + ((_e4897 - _e4900) * _e4404)) - _e4906) + ((_e4910 + ((_e4913 - _e4916) * _e4410)) - _e4922)) > _e4823) {
                                                    let _e4928 = local_9.member[3u];
                                                    let _e4931 = local_9.member_1[3u];
                                                    let _e4934 = local_9.member[3u];
                                                    let _e4940 = local_9.member_2[3u];
                                                    let _e4944 = local_10.member[3u];
                                                    let _e4947 = local_10.member_1[3u];
                                                    let _e4950 = local_10.member[3u];
                                                    let _e4956 = local_10.member_2[3u];
                                                    phi_3514_ = ((((_e4928 + ((_e4931 - _e4934) * _e4404)) - _e4940) + ((_e4944 + ((_e4947 - _e4950) * _e4410)) - _e4956)) > _e4823);
                                                    phi_3515_ = false;
                                                } else {
                                                    phi_3514_ = bool();
                                                    phi_3515_ = true;
                                                }
                                                let _e4961 = phi_3514_;
                                                let _e4963 = phi_3515_;
                                                phi_3516_ = _e4961;
                                                phi_3517_ = _e4963;
                                            } else {
                                                phi_3516_ = bool();
                                                phi_3517_ = true;
                                            }
                                            let _e4965 = phi_3516_;
                                            let _e4967 = phi_3517_;
                                            phi_3518_ = _e4965;
                                            phi_3519_ = _e4967;
                                        } else {
                                            phi_3518_ = bool();
                                            phi_3519_ = true;
                                        }
                                        let _e4969 = phi_3518_;
                                        let _e4971 = phi_3519_;
                                        if _e4971 {
                                            phi_3523_ = false;
                                        } else {
                                            phi_3523_ = _e4969;
                                        }
                                        let _e4973 = phi_3523_;
                                        phi_3527_ = _e4973;
                                    }
                                    let _e4975 = phi_3527_;
                                    if _e4975 {
                                        if _e4412 {
                                            if (_e4404 >= _e4169) {
                                                phi_3538_ = false;
                                            } else {
                                                phi_3538_ = true;
                                            }
                                            let _e4978 = phi_3538_;
                                            phi_3539_ = _e4978;
                                        } else {
                                            phi_3539_ = true;
                                        }
                                        let _e4980 = phi_3539_;
                                        if _e4980 {
                                            local_9 = type_34(array<f64, 4>(_e4717.member[0], _e4717.member[1], _e4717.member[2], _e4717.member[3]), array<f64, 4>(_e4717.member_1[0], _e4717.member_1[1], _e4717.member_1[2], _e4717.member_1[3]), array<f64, 4>(_e4717.member_2[0], _e4717.member_2[1], _e4717.member_2[2], _e4717.member_2[3]));
                                            let _e5002 = local_9.member[0u];
                                            let _e5005 = local_9.member_1[0u];
                                            let _e5008 = local_9.member_2[0u];
                                            if (_e5002 > _e5008) {
                                                if (_e5005 > _e5008) {
                                                    phi_3613_ = false;
                                                } else {
                                                    phi_3613_ = true;
                                                }
                                                let _e5012 = phi_3613_;
                                                phi_3614_ = _e5012;
                                            } else {
                                                phi_3614_ = true;
                                            }
                                            let _e5014 = phi_3614_;
                                            if _e5014 {
                                                let _e5015 = (_e5005 >= _e5002);
                                                if _e5015 {
                                                    phi_3639_ = f64();
                                                    phi_3640_ = false;
                                                } else {
                                                    if ((_e5002 - _e5005) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3637_ = (((_e5002 - _e5008) / (_e5002 - _e5005)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3638_ = false;
                                                    } else {
                                                        phi_3637_ = f64();
                                                        phi_3638_ = true;
                                                    }
                                                    let _e5029 = phi_3637_;
                                                    let _e5031 = phi_3638_;
                                                    phi_3639_ = _e5029;
                                                    phi_3640_ = _e5031;
                                                }
                                                let _e5033 = phi_3639_;
                                                let _e5035 = phi_3640_;
                                                phi_3641_ = _e5033;
                                                phi_3642_ = _e5015;
                                                phi_3643_ = _e5035;
                                            } else {
                                                phi_3641_ = f64();
                                                phi_3642_ = true;
                                                phi_3643_ = false;
                                            }
                                            let _e5037 = phi_3641_;
                                            let _e5039 = phi_3642_;
                                            let _e5041 = phi_3643_;
                                            if _e5039 {
                                                phi_3648_ = f64(2f);
                                                phi_3649_ = true;
                                            } else {
                                                phi_3648_ = _e4404;
                                                phi_3649_ = _e5041;
                                            }
                                            let _e5044 = phi_3648_;
                                            let _e5046 = phi_3649_;
                                            if _e5046 {
                                                phi_3653_ = _e5044;
                                            } else {
                                                phi_3653_ = _e5037;
                                            }
                                            let _e5048 = phi_3653_;
                                            let _e5051 = local_9.member[1u];
                                            let _e5054 = local_9.member_1[1u];
                                            let _e5057 = local_9.member_2[1u];
                                            if (_e5051 > _e5057) {
                                                if (_e5054 > _e5057) {
                                                    phi_3685_ = false;
                                                } else {
                                                    phi_3685_ = true;
                                                }
                                                let _e5061 = phi_3685_;
                                                phi_3686_ = _e5061;
                                            } else {
                                                phi_3686_ = true;
                                            }
                                            let _e5063 = phi_3686_;
                                            if _e5063 {
                                                let _e5064 = (_e5054 >= _e5051);
                                                if _e5064 {
                                                    phi_3711_ = f64();
                                                    phi_3712_ = false;
                                                } else {
                                                    if ((_e5051 - _e5054) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3709_ = (((_e5051 - _e5057) / (_e5051 - _e5054)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3710_ = false;
                                                    } else {
                                                        phi_3709_ = f64();
                                                        phi_3710_ = true;
                                                    }
                                                    let _e5078 = phi_3709_;
                                                    let _e5080 = phi_3710_;
                                                    phi_3711_ = _e5078;
                                                    phi_3712_ = _e5080;
                                                }
                                                let _e5082 = phi_3711_;
                                                let _e5084 = phi_3712_;
                                                phi_3713_ = _e5082;
                                                phi_3714_ = _e5064;
                                                phi_3715_ = _e5084;
                                            } else {
                                                phi_3713_ = f64();
                                                phi_3714_ = true;
                                                phi_3715_ = false;
                                            }
                                            let _e5086 = phi_3713_;
                                            let _e5088 = phi_3714_;
                                            let _e5090 = phi_3715_;
                                            if _e5088 {
                                                phi_3720_ = f64(2f);
                                                phi_3721_ = true;
                                            } else {
                                                phi_3720_ = _e4404;
                                                phi_3721_ = _e5090;
                                            }
                                            let _e5093 = phi_3720_;
                                            let _e5095 = phi_3721_;
                                            if _e5095 {
                                                phi_3725_ = _e5093;
                                            } else {
                                                phi_3725_ = _e5086;
                                            }
                                            let _e5097 = phi_3725_;
                                            if (_e5048 < _e5097) {
                                                phi_3730_ = _e5048;
                                            } else {
                                                phi_3730_ = _e5097;
                                            }
                                            let _e5100 = phi_3730_;
                                            let _e5103 = local_9.member[2u];
                                            let _e5106 = local_9.member_1[2u];
                                            let _e5109 = local_9.member_2[2u];
                                            if (_e5103 > _e5109) {
                                                if (_e5106 > _e5109) {
                                                    phi_3762_ = false;
                                                } else {
                                                    phi_3762_ = true;
                                                }
                                                let _e5113 = phi_3762_;
                                                phi_3763_ = _e5113;
                                            } else {
                                                phi_3763_ = true;
                                            }
                                            let _e5115 = phi_3763_;
                                            if _e5115 {
                                                let _e5116 = (_e5106 >= _e5103);
                                                if _e5116 {
                                                    phi_3788_ = f64();
                                                    phi_3789_ = false;
                                                } else {
                                                    if ((_e5103 - _e5106) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3786_ = (((_e5103 - _e5109) / (_e5103 - _e5106)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3787_ = false;
                                                    } else {
                                                        phi_3786_ = f64();
                                                        phi_3787_ = true;
                                                    }
                                                    let _e5130 = phi_3786_;
                                                    let _e5132 = phi_3787_;
                                                    phi_3788_ = _e5130;
                                                    phi_3789_ = _e5132;
                                                }
                                                let _e5134 = phi_3788_;
                                                let _e5136 = phi_3789_;
                                                phi_3790_ = _e5134;
                                                phi_3791_ = _e5116;
                                                phi_3792_ = _e5136;
                                            } else {
                                                phi_3790_ = f64();
                                                phi_3791_ = true;
                                                phi_3792_ = false;
                                            }
                                            let _e5138 = phi_3790_;
                                            let _e5140 = phi_3791_;
                                            let _e5142 = phi_3792_;
                                            if _e5140 {
                                                phi_3797_ = f64(2f);
                                                phi_3798_ = true;
                                            } else {
                                                phi_3797_ = _e4404;
                                                phi_3798_ = _e5142;
                                            }
                                            let _e5145 = phi_3797_;
                                            let _e5147 = phi_3798_;
                                            if _e5147 {
                                                phi_3802_ = _e5145;
                                            } else {
                                                phi_3802_ = _e5138;
                                            }
                                            let _e5149 = phi_3802_;
                                            let _e5152 = local_9.member[3u];
                                            let _e5155 = local_9.member_1[3u];
                                            let _e5158 = local_9.member_2[3u];
                                            if (_e5152 > _e5158) {
                                                if (_e5155 > _e5158) {
                                                    phi_3834_ = false;
                                                } else {
                                                    phi_3834_ = true;
                                                }
                                                let _e5162 = phi_3834_;
                                                phi_3835_ = _e5162;
                                            } else {
                                                phi_3835_ = true;
                                            }
                                            let _e5164 = phi_3835_;
                                            if _e5164 {
                                                let _e5165 = (_e5155 >= _e5152);
                                                if _e5165 {
                                                    phi_3860_ = f64();
                                                    phi_3861_ = false;
                                                } else {
                                                    if ((_e5152 - _e5155) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3858_ = (((_e5152 - _e5158) / (_e5152 - _e5155)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3859_ = false;
                                                    } else {
                                                        phi_3858_ = f64();
                                                        phi_3859_ = true;
                                                    }
                                                    let _e5179 = phi_3858_;
                                                    let _e5181 = phi_3859_;
                                                    phi_3860_ = _e5179;
                                                    phi_3861_ = _e5181;
                                                }
                                                let _e5183 = phi_3860_;
                                                let _e5185 = phi_3861_;
                                                phi_3862_ = _e5183;
                                                phi_3863_ = _e5165;
                                                phi_3864_ = _e5185;
                                            } else {
                                                phi_3862_ = f64();
                                                phi_3863_ = true;
                                                phi_3864_ = false;
                                            }
                                            let _e5187 = phi_3862_;
                                            let _e5189 = phi_3863_;
                                            let _e5191 = phi_3864_;
                                            if _e5189 {
                                                phi_3869_ = f64(2f);
                                                phi_3870_ = true;
                                            } else {
                                                phi_3869_ = _e4404;
                                                phi_3870_ = _e5191;
                                            }
                                            let _e5194 = phi_3869_;
                                            let _e5196 = phi_3870_;
                                            if _e5196 {
                                                phi_3874_ = _e5194;
                                            } else {
                                                phi_3874_ = _e5187;
                                            }
                                            let _e5198 = phi_3874_;
                                            if (_e5149 < _e5198) {
                                                phi_3879_ = _e5149;
                                            } else {
                                                phi_3879_ = _e5198;
                                            }
                                            let _e5201 = phi_3879_;
                                            if (_e5100 < _e5201) {
                                                phi_3884_ = _e5100;
                                            } else {
                                                phi_3884_ = _e5201;
                                            }
                                            let _e5204 = phi_3884_;
                                            if (_e5204 > _e4404) {
                                                phi_3889_ = _e5204;
                                            } else {
                                                phi_3889_ = _e4404;
                                            }
                                            let _e5207 = phi_3889_;
                                            let _e5208 = (_e5207 > _e4169);
                                            if _e5208 {
                                                phi_4406_ = f64();
                                                phi_4407_ = f64();
                                                phi_4408_ = false;
                                                phi_4409_ = false;
                                            } else {
                                                let _e5209 = (_e5207 - _e4404);
                                                let _e5211 = (_e5209 <= f64(0.0000000037252903f));
                                                let _e5213 = (_e5207 + f64(0.00000001f));
                                                if (_e5213 < _e4169) {
                                                    phi_3903_ = _e5213;
                                                } else {
                                                    phi_3903_ = _e4169;
                                                }
                                                let _e5216 = phi_3903_;
                                                if _e5211 {
                                                    if (_e575.member_1 > f64(0f)) {
                                                        let _e5221 = local_12.member[0u];
                                                        let _e5227 = local_12.member[1u];
                                                        let _e5243 = local_12.member_1[0u];
                                                        let _e5249 = local_12.member_1[1u];
                                                        let _e5265 = local_12.member_2[0u];
                                                        let _e5271 = local_12.member_2[1u];
                                                        let _e5285 = function_2(array<f64, 3>((_e5221[0] + ((_e5227[0] - _e5221[0]) * _e5216)), (_e5221[1] + ((_e5227[1] - _e5221[1]) * _e5216)), (_e5221[2] + ((_e5227[2] - _e5221[2]) * _e5216))), array<f64, 3>((_e5243[0] + ((_e5249[0] - _e5243[0]) * _e5216)), (_e5243[1] + ((_e5249[1] - _e5243[1]) * _e5216)), (_e5243[2] + ((_e5249[2] - _e5243[2]) * _e5216))), array<f64, 3>((_e5265[0] + ((_e5271[0] - _e5265[0]) * _e5216)), (_e5265[1] + ((_e5271[1] - _e5265[1]) * _e5216)), (_e5265[2] + ((_e5271[2] - _e5265[2]) * _e5216))), 0u);
                                                        let _e5296 = (((_e5285[0] * _e5285[0]) + (_e5285[1] * _e5285[1])) + (_e5285[2] * _e5285[2]));
                                                        if (_e5296 <= 2.2250738585072014e-308lf) {
                                                            if (_e5296 > 0.0lf) {
                                                                phi_4034_ = (1.464336215552873e-154lf * 2.0lf);
                                                            } else {
                                                                phi_4034_ = 0.0lf;
                                                            }
                                                            let _e5348 = phi_4034_;
                                                            phi_4098_ = _e5348;
                                                        } else {
                                                            phi_4041_ = type_16(0i, 5i);
                                                            phi_4044_ = bitcast<f64>(((bitcast<u64>(_e5296) / 2lu) + 2303426169912950784lu));
                                                            loop {
                                                                let _e5303 = phi_4041_;
                                                                let _e5305 = phi_4044_;
                                                                local_26 = _e5305;
                                                                if (_e5303.member < _e5303.member_1) {
                                                                    let _e5312 = (_e5303.member + 1i);
                                                                    if ((false == (_e5312 > _e5303.member)) != false) {
                                                                        phi_4065_ = true;
                                                                    } else {
                                                                        phi_4065_ = false;
                                                                    }
                                                                    let _e5317 = phi_4065_;
                                                                    if _e5317 {
                                                                        phi_4071_ = type_17(0u, type_17().member_1);
                                                                    } else {
                                                                        phi_4071_ = type_17(1u, _e5312);
                                                                    }
                                                                    let _e5322 = phi_4071_;
                                                                    phi_4042_ = type_16(_e5322.member_1, _e5303.member_1);
                                                                    phi_4085_ = type_17(1u, _e5303.member);
                                                                } else {
                                                                    phi_4042_ = _e5303;
                                                                    phi_4085_ = type_17(0u, type_17().member_1);
                                                                }
                                                                let _e5328 = phi_4042_;
                                                                let _e5330 = phi_4085_;
                                                                let _e5333 = (bitcast<i32>(_e5330.member) != 0i);
                                                                if _e5333 {
                                                                    phi_4045_ = (0.5lf * (_e5305 + (_e5296 / _e5305)));
                                                                } else {
                                                                    phi_4045_ = f64();
                                                                }
                                                                let _e5338 = phi_4045_;
                                                                continue;
                                                                continuing {
                                                                    phi_4041_ = _e5328;
                                                                    phi_4044_ = _e5338;
                                                                    break if !(_e5333);
                                                                }
                                                            }
                                                            let _e5343 = local_26;
                                                            phi_4098_ = (_e5343 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                        }
                                                        let _e5350 = phi_4098_;
                                                        let _e5358 = local_12.member[0u];
                                                        if (_e5358[0] < 0.0lf) {
                                                            phi_4116_ = -(_e5358[0]);
                                                        } else {
                                                            phi_4116_ = _e5358[0];
                                                        }
                                                        let _e5365 = phi_4116_;
                                                        if (_e5358[1] < 0.0lf) {
                                                            phi_4123_ = -(_e5358[1]);
                                                        } else {
                                                            phi_4123_ = _e5358[1];
                                                        }
                                                        let _e5369 = phi_4123_;
                                                        if (_e5365 > _e5369) {
                                                            phi_4128_ = _e5365;
                                                        } else {
                                                            phi_4128_ = _e5369;
                                                        }
                                                        let _e5372 = phi_4128_;
                                                        if (_e5358[2] < 0.0lf) {
                                                            phi_4135_ = -(_e5358[2]);
                                                        } else {
                                                            phi_4135_ = _e5358[2];
                                                        }
                                                        let _e5376 = phi_4135_;
                                                        if (_e5372 > _e5376) {
                                                            phi_4140_ = _e5372;
                                                        } else {
                                                            phi_4140_ = _e5376;
                                                        }
                                                        let _e5379 = phi_4140_;
                                                        let _e5382 = local_12.member[1u];
                                                        if (_e5382[0] < 0.0lf) {
                                                            phi_4153_ = -(_e5382[0]);
                                                        } else {
                                                            phi_4153_ = _e5382[0];
                                                        }
                                                        let _e5389 = phi_4153_;
                                                        if (_e5382[1] < 0.0lf) {
                                                            phi_4160_ = -(_e5382[1]);
                                                        } else {
                                                            phi_4160_ = _e5382[1];
                                                        }
                                                        let _e5393 = phi_4160_;
                                                        if (_e5389 > _e5393) {
                                                            phi_4165_ = _e5389;
                                                        } else {
                                                            phi_4165_ = _e5393;
                                                        }
                                                        let _e5396 = phi_4165_;
                                                        if (_e5382[2] < 0.0lf) {
                                                            phi_4172_ = -(_e5382[2]);
                                                        } else {
                                                            phi_4172_ = _e5382[2];
                                                        }
                                                        let _e5400 = phi_4172_;
                                                        if (_e5396 > _e5400) {
                                                            phi_4177_ = _e5396;
                                                        } else {
                                                            phi_4177_ = _e5400;
                                                        }
                                                        let _e5403 = phi_4177_;
                                                        if (_e5379 > _e5403) {
                                                            phi_4182_ = _e5379;
                                                        } else {
                                                            phi_4182_ = _e5403;
                                                        }
                                                        let _e5406 = phi_4182_;
                                                        let _e5408 = local_12.member_3;
                                                        let _e5412 = local_12.member_1[0u];
                                                        if (_e5412[0] < 0.0lf) {
                                                            phi_4199_ = -(_e5412[0]);
                                                        } else {
                                                            phi_4199_ = _e5412[0];
                                                        }
                                                        let _e5419 = phi_4199_;
                                                        if (_e5412[1] < 0.0lf) {
                                                            phi_4206_ = -(_e5412[1]);
                                                        } else {
                                                            phi_4206_ = _e5412[1];
                                                        }
                                                        let _e5423 = phi_4206_;
                                                        if (_e5419 > _e5423) {
                                                            phi_4211_ = _e5419;
                                                        } else {
                                                            phi_4211_ = _e5423;
                                                        }
                                                        let _e5426 = phi_4211_;
                                                        if (_e5412[2] < 0.0lf) {
                                                            phi_4218_ = -(_e5412[2]);
                                                        } else {
                                                            phi_4218_ = _e5412[2];
                                                        }
                                                        let _e5430 = phi_4218_;
                                                        if (_e5426 > _e5430) {
                                                            phi_4223_ = _e5426;
                                                        } else {
                                                            phi_4223_ = _e5430;
                                                        }
                                                        let _e5433 = phi_4223_;
                                                        let _e5436 = local_12.member_1[1u];
                                                        if (_e5436[0] < 0.0lf) {
                                                            phi_4237_ = -(_e5436[0]);
                                                        } else {
                                                            phi_4237_ = _e5436[0];
                                                        }
                                                        let _e5443 = phi_4237_;
                                                        if (_e5436[1] < 0.0lf) {
                                                            phi_4244_ = -(_e5436[1]);
                                                        } else {
                                                            phi_4244_ = _e5436[1];
                                                        }
                                                        let _e5447 = phi_4244_;
                                                        if (_e5443 > _e5447) {
                                                            phi_4249_ = _e5443;
                                                        } else {
                                                            phi_4249_ = _e5447;
                                                        }
                                                        let _e5450 = phi_4249_;
                                                        if (_e5436[2] < 0.0lf) {
                                                            phi_4256_ = -(_e5436[2]);
                                                        } else {
                                                            phi_4256_ = _e5436[2];
                                                        }
                                                        let _e5454 = phi_4256_;
                                                        if (_e5450 > _e5454) {
                                                            phi_4261_ = _e5450;
                                                        } else {
                                                            phi_4261_ = _e5454;
                                                        }
                                                        let _e5457 = phi_4261_;
                                                        if (_e5433 > _e5457) {
                                                            phi_4266_ = _e5433;
                                                        } else {
                                                            phi_4266_ = _e5457;
                                                        }
                                                        let _e5460 = phi_4266_;
                                                        let _e5462 = local_12.member_3;
                                                        let _e5466 = local_12.member_2[0u];
                                                        if (_e5466[0] < 0.0lf) {
                                                            phi_4283_ = -(_e5466[0]);
                                                        } else {
                                                            phi_4283_ = _e5466[0];
                                                        }
                                                        let _e5473 = phi_4283_;
                                                        if (_e5466[1] < 0.0lf) {
                                                            phi_4290_ = -(_e5466[1]);
                                                        } else {
                                                            phi_4290_ = _e5466[1];
                                                        }
                                                        let _e5477 = phi_4290_;
                                                        if (_e5473 > _e5477) {
                                                            phi_4295_ = _e5473;
                                                        } else {
                                                            phi_4295_ = _e5477;
                                                        }
                                                        let _e5480 = phi_4295_;
                                                        if (_e5466[2] < 0.0lf) {
                                                            phi_4302_ = -(_e5466[2]);
                                                        } else {
                                                            phi_4302_ = _e5466[2];
                                                        }
                                                        let _e5484 = phi_4302_;
                                                        if (_e5480 > _e5484) {
                                                            phi_4307_ = _e5480;
                                                        } else {
                                                            phi_4307_ = _e5484;
                                                        }
                                                        let _e5487 = phi_4307_;
                                                        let _e5490 = local_12.member_2[1u];
                                                        if (_e5490[0] < 0.0lf) {
                                                            phi_4321_ = -(_e5490[0]);
                                                        } else {
                                                            phi_4321_ = _e5490[0];
                                                        }
                                                        let _e5497 = phi_4321_;
                                                        if (_e5490[1] < 0.0lf) {
                                                            phi_4328_ = -(_e5490[1]);
                                                        } else {
                                                            phi_4328_ = _e5490[1];
                                                        }
                                                        let _e5501 = phi_4328_;
                                                        if (_e5497 > _e5501) {
                                                            phi_4333_ = _e5497;
                                                        } else {
                                                            phi_4333_ = _e5501;
                                                        }
                                                        let _e5504 = phi_4333_;
                                                        if (_e5490[2] < 0.0lf) {
                                                            phi_4340_ = -(_e5490[2]);
                                                        } else {
                                                            phi_4340_ = _e5490[2];
                                                        }
                                                        let _e5508 = phi_4340_;
                                                        if (_e5504 > _e5508) {
                                                            phi_4345_ = _e5504;
                                                        } else {
                                                            phi_4345_ = _e5508;
                                                        }
                                                        let _e5511 = phi_4345_;
                                                        if (_e5487 > _e5511) {
                                                            phi_4350_ = _e5487;
                                                        } else {
                                                            phi_4350_ = _e5511;
                                                        }
                                                        let _e5514 = phi_4350_;
                                                        let _e5516 = local_12.member_3;
                                                        let _e5524 = local_12.member_3;
                                                        if (((_e5350 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5406 + _e5408) + (_e5460 + _e5462)) + (_e5514 + _e5516)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5524 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e575.member_1) {
                                                            phi_4374_ = false;
                                                        } else {
                                                            phi_4374_ = true;
                                                        }
                                                        let _e5536 = phi_4374_;
                                                        phi_4375_ = _e5536;
                                                    } else {
                                                        phi_4375_ = true;
                                                    }
                                                    let _e5538 = phi_4375_;
                                                    phi_4376_ = _e5538;
                                                } else {
                                                    phi_4376_ = true;
                                                }
                                                let _e5540 = phi_4376_;
                                                if _e5540 {
                                                    if _e4412 {
                                                        if _e5211 {
                                                            phi_4395_ = f64();
                                                            phi_4396_ = true;
                                                        } else {
                                                            if (_e5209 <= (_e4408 * f64(0.25f))) {
                                                                phi_4393_ = f64(0f);
                                                                phi_4394_ = false;
                                                            } else {
                                                                phi_4393_ = f64();
                                                                phi_4394_ = true;
                                                            }
                                                            let _e5547 = phi_4393_;
                                                            let _e5549 = phi_4394_;
                                                            phi_4395_ = _e5547;
                                                            phi_4396_ = _e5549;
                                                        }
                                                        let _e5551 = phi_4395_;
                                                        let _e5553 = phi_4396_;
                                                        if _e5553 {
                                                            phi_4401_ = (_e4737 + _e4737);
                                                        } else {
                                                            phi_4401_ = _e5551;
                                                        }
                                                        let _e5556 = phi_4401_;
                                                        phi_4403_ = _e5556;
                                                    } else {
                                                        phi_4403_ = (_e4169 - _e4404);
                                                    }
                                                    let _e5558 = phi_4403_;
                                                    phi_4404_ = _e5558;
                                                    phi_4405_ = false;
                                                } else {
                                                    phi_4404_ = f64();
                                                    phi_4405_ = true;
                                                }
                                                let _e5560 = phi_4404_;
                                                let _e5562 = phi_4405_;
                                                phi_4406_ = _e5560;
                                                phi_4407_ = _e5209;
                                                phi_4408_ = _e5540;
                                                phi_4409_ = _e5562;
                                            }
                                            let _e5564 = phi_4406_;
                                            let _e5566 = phi_4407_;
                                            let _e5568 = phi_4408_;
                                            let _e5570 = phi_4409_;
                                            phi_4410_ = _e5207;
                                            phi_4411_ = _e5564;
                                            phi_4412_ = _e5566;
                                            phi_4413_ = _e5207;
                                            phi_4414_ = _e5568;
                                            phi_4415_ = _e5208;
                                            phi_4416_ = _e5570;
                                            phi_4417_ = false;
                                        } else {
                                            phi_4410_ = f64();
                                            phi_4411_ = f64();
                                            phi_4412_ = f64();
                                            phi_4413_ = f64();
                                            phi_4414_ = false;
                                            phi_4415_ = false;
                                            phi_4416_ = false;
                                            phi_4417_ = true;
                                        }
                                        let _e5572 = phi_4410_;
                                        let _e5574 = phi_4411_;
                                        let _e5576 = phi_4412_;
                                        let _e5578 = phi_4413_;
                                        let _e5580 = phi_4414_;
                                        let _e5582 = phi_4415_;
                                        let _e5584 = phi_4416_;
                                        let _e5586 = phi_4417_;
                                        phi_4418_ = _e5572;
                                        phi_4419_ = _e5574;
                                        phi_4420_ = _e5576;
                                        phi_4421_ = _e5578;
                                        phi_4422_ = false;
                                        phi_4423_ = _e5580;
                                        phi_4424_ = _e5582;
                                        phi_4425_ = _e5584;
                                        phi_4426_ = _e5586;
                                    } else {
                                        phi_4418_ = f64();
                                        phi_4419_ = f64();
                                        phi_4420_ = f64();
                                        phi_4421_ = f64();
                                        phi_4422_ = true;
                                        phi_4423_ = false;
                                        phi_4424_ = false;
                                        phi_4425_ = false;
                                        phi_4426_ = false;
                                    }
                                    let _e5588 = phi_4418_;
                                    let _e5590 = phi_4419_;
                                    let _e5592 = phi_4420_;
                                    let _e5594 = phi_4421_;
                                    let _e5596 = phi_4422_;
                                    let _e5598 = phi_4423_;
                                    let _e5600 = phi_4424_;
                                    let _e5602 = phi_4425_;
                                    let _e5604 = phi_4426_;
                                    phi_4427_ = _e5588;
                                    phi_4428_ = _e5590;
                                    phi_4429_ = _e5592;
                                    phi_4430_ = _e5594;
                                    phi_4431_ = _e5596;
                                    phi_4432_ = _e5598;
                                    phi_4433_ = _e5600;
                                    phi_4434_ = _e5602;
                                    phi_4435_ = _e5604;
                                } else {
                                    phi_4427_ = f64();
                                    phi_4428_ = f64();
                                    phi_4429_ = f64();
                                    phi_4430_ = f64();
                                    phi_4431_ = true;
                                    phi_4432_ = false;
                                    phi_4433_ = false;
                                    phi_4434_ = false;
                                    phi_4435_ = false;
                                }
                                let _e5606 = phi_4427_;
                                let _e5608 = phi_4428_;
                                let _e5610 = phi_4429_;
                                let _e5612 = phi_4430_;
                                let _e5614 = phi_4431_;
                                let _e5616 = phi_4432_;
                                let _e5618 = phi_4433_;
                                let _e5620 = phi_4434_;
                                let _e5622 = phi_4435_;
                                if _e5614 {
                                    if (_e4404 <= _e4406) {
                                        let _e5788 = (_e4414 + 1u);
                                        let _e5789 = (_e5788 > 3u);
                                        if _e5789 {
                                            phi_4448_ = false;
                                        } else {
                                            phi_4448_ = true;
                                        }
                                        let _e5791 = phi_4448_;
                                        phi_4775_ = _e5788;
                                        phi_4776_ = f64();
                                        phi_4777_ = false;
                                        phi_4778_ = _e5791;
                                        phi_4779_ = _e5789;
                                    } else {
                                        let _e5626 = local_9.member[0u];
                                        let _e5629 = local_9.member_1[0u];
                                        let _e5632 = local_9.member[0u];
                                        let _e5638 = local_9.member_2[0u];
                                        let _e5639 = ((_e5626 + ((_e5629 - _e5632) * _e4410)) - _e5638);
                                        let _e5642 = local_9.member[1u];
                                        let _e5645 = local_9.member_1[1u];
                                        let _e5648 = local_9.member[1u];
                                        let _e5654 = local_9.member_2[1u];
                                        let _e5655 = ((_e5642 + ((_e5645 - _e5648) * _e4410)) - _e5654);
                                        if (_e5639 < _e5655) {
                                            phi_4521_ = _e5639;
                                        } else {
                                            phi_4521_ = _e5655;
                                        }
                                        let _e5658 = phi_4521_;
                                        let _e5661 = local_9.member[2u];
                                        let _e5664 = local_9.member_1[2u];
                                        let _e5667 = local_9.member[2u];
                                        let _e5673 = local_9.member_2[2u];
                                        let _e5674 = ((_e5661 + ((_e5664 - _e5667) * _e4410)) - _e5673);
                                        let _e5677 = local_9.member[3u];
                                        let _e5680 = local_9.member_1[3u];
                                        let _e5683 = local_9.member[3u];
                                        let _e5689 = local_9.member_2[3u];
                                        let _e5690 = ((_e5677 + ((_e5680 - _e5683) * _e4410)) - _e5689);
                                        if (_e5674 < _e5690) {
                                            phi_4594_ = _e5674;
                                        } else {
                                            phi_4594_ = _e5690;
                                        }
                                        let _e5693 = phi_4594_;
                                        if (_e5658 < _e5693) {
                                            phi_4599_ = _e5658;
                                        } else {
                                            phi_4599_ = _e5693;
                                        }
                                        let _e5696 = phi_4599_;
                                        let _e5699 = local_10.member[0u];
                                        let _e5702 = local_10.member_1[0u];
                                        let _e5705 = local_10.member[0u];
                                        let _e5711 = local_10.member_2[0u];
                                        let _e5712 = ((_e5699 + ((_e5702 - _e5705) * _e4404)) - _e5711);
                                        let _e5715 = local_10.member[1u];
                                        let _e5718 = local_10.member_1[1u];
                                        let _e5721 = local_10.member[1u];
                                        let _e5727 = local_10.member_2[1u];
                                        let _e5728 = ((_e5715 + ((_e5718 - _e5721) * _e4404)) - _e5727);
                                        if (_e5712 < _e5728) {
                                            phi_4672_ = _e5712;
                                        } else {
                                            phi_4672_ = _e5728;
                                        }
                                        let _e5731 = phi_4672_;
                                        let _e5734 = local_10.member[2u];
                                        let _e5737 = local_10.member_1[2u];
                                        let _e5740 = local_10.member[2u];
                                        let _e5746 = local_10.member_2[2u];
                                        let _e5747 = ((_e5734 + ((_e5737 - _e5740) * _e4404)) - _e5746);
                                        let _e5750 = local_10.member[3u];
                                        let _e5753 = local_10.member_1[3u];
                                        let _e5756 = local_10.member[3u];
                                        let _e5762 = local_10.member_2[3u];
                                        let _e5763 = ((_e5750 + ((_e5753 - _e5756) * _e4404)) - _e5762);
                                        if (_e5747 < _e5763) {
                                            phi_4745_ = _e5747;
                                        } else {
                                            phi_4745_ = _e5763;
                                        }
                                        let _e5766 = phi_4745_;
                                        if (_e5731 < _e5766) {
                                            phi_4750_ = _e5731;
                                        } else {
                                            phi_4750_ = _e5766;
                                        }
                                        let _e5769 = phi_4750_;
                                        let _e5770 = f64(0.0625f);
                                        let _e5772 = f64(0.9f);
                                        if (_e5769 > f64(0f)) {
                                            phi_4773_ = f64(0.5f);
                                        } else {
                                            let _e5778 = (f64(0.95f) * (_e5696 / (_e5696 - _e5769)));
                                            if (_e5778 > _e5770) {
                                                if (_e5778 < _e5772) {
                                                    phi_4771_ = _e5778;
                                                } else {
                                                    phi_4771_ = _e5772;
                                                }
                                                let _e5782 = phi_4771_;
                                                phi_4772_ = _e5782;
                                            } else {
                                                phi_4772_ = _e5770;
                                            }
                                            let _e5784 = phi_4772_;
                                            phi_4773_ = _e5784;
                                        }
                                        let _e5786 = phi_4773_;
                                        phi_4775_ = u32();
                                        phi_4776_ = (_e4737 * _e5786);
                                        phi_4777_ = true;
                                        phi_4778_ = false;
                                        phi_4779_ = false;
                                    }
                                    let _e5793 = phi_4775_;
                                    let _e5795 = phi_4776_;
                                    let _e5797 = phi_4777_;
                                    let _e5799 = phi_4778_;
                                    let _e5801 = phi_4779_;
                                    phi_4780_ = _e5793;
                                    phi_4781_ = _e4406;
                                    phi_4782_ = _e5795;
                                    phi_4783_ = _e4408;
                                    phi_4784_ = _e4410;
                                    phi_4785_ = _e4412;
                                    phi_4786_ = _e4414;
                                    phi_4787_ = _e5797;
                                    phi_4788_ = _e5799;
                                    phi_4789_ = _e5801;
                                    phi_4790_ = false;
                                    phi_4791_ = false;
                                    phi_4792_ = false;
                                } else {
                                    phi_4780_ = u32();
                                    phi_4781_ = _e5606;
                                    phi_4782_ = _e5608;
                                    phi_4783_ = _e5610;
                                    phi_4784_ = _e4404;
                                    phi_4785_ = true;
                                    phi_4786_ = 0u;
                                    phi_4787_ = _e5616;
                                    phi_4788_ = false;
                                    phi_4789_ = false;
                                    phi_4790_ = _e5618;
                                    phi_4791_ = _e5620;
                                    phi_4792_ = _e5622;
                                }
                                let _e5803 = phi_4780_;
                                let _e5805 = phi_4781_;
                                let _e5807 = phi_4782_;
                                let _e5809 = phi_4783_;
                                let _e5811 = phi_4784_;
                                let _e5813 = phi_4785_;
                                let _e5815 = phi_4786_;
                                let _e5817 = phi_4787_;
                                let _e5819 = phi_4788_;
                                let _e5821 = phi_4789_;
                                let _e5823 = phi_4790_;
                                let _e5825 = phi_4791_;
                                let _e5827 = phi_4792_;
                                if _e5817 {
                                    let _e5828 = (_e5811 + _e5807);
                                    if (_e5828 > _e5805) {
                                        phi_4801_ = _e5828;
                                    } else {
                                        phi_4801_ = _e5805;
                                    }
                                    let _e5831 = phi_4801_;
                                    if (_e5831 < _e4169) {
                                        phi_4806_ = _e5831;
                                    } else {
                                        phi_4806_ = _e4169;
                                    }
                                    let _e5834 = phi_4806_;
                                    if !(_e4412) {
                                        phi_4816_ = true;
                                    } else {
                                        phi_4816_ = ((_e5834 - _e5811) > f64(0.0000000037252903f));
                                    }
                                    let _e5839 = phi_4816_;
                                    if _e5839 {
                                        phi_4820_ = false;
                                    } else {
                                        phi_4820_ = true;
                                    }
                                    let _e5841 = phi_4820_;
                                    phi_4821_ = _e5834;
                                    phi_4822_ = _e5805;
                                    phi_4823_ = _e5809;
                                    phi_4824_ = _e5811;
                                    phi_4825_ = _e5813;
                                    phi_4826_ = _e5815;
                                    phi_4827_ = _e5839;
                                    phi_4828_ = _e5841;
                                    phi_4829_ = false;
                                    phi_4830_ = false;
                                    phi_4831_ = false;
                                    phi_4832_ = false;
                                } else {
                                    phi_4821_ = _e4404;
                                    phi_4822_ = _e4406;
                                    phi_4823_ = _e4408;
                                    phi_4824_ = _e4410;
                                    phi_4825_ = _e4412;
                                    phi_4826_ = _e5803;
                                    phi_4827_ = _e5819;
                                    phi_4828_ = false;
                                    phi_4829_ = _e5821;
                                    phi_4830_ = _e5823;
                                    phi_4831_ = _e5825;
                                    phi_4832_ = _e5827;
                                }
                                let _e5843 = phi_4821_;
                                let _e5845 = phi_4822_;
                                let _e5847 = phi_4823_;
                                let _e5849 = phi_4824_;
                                let _e5851 = phi_4825_;
                                let _e5853 = phi_4826_;
                                let _e5855 = phi_4827_;
                                let _e5857 = phi_4828_;
                                let _e5859 = phi_4829_;
                                let _e5861 = phi_4830_;
                                let _e5863 = phi_4831_;
                                let _e5865 = phi_4832_;
                                phi_2610_ = _e5843;
                                phi_2612_ = _e5845;
                                phi_2614_ = _e5847;
                                phi_2616_ = _e5849;
                                phi_2618_ = _e5851;
                                phi_2620_ = _e5853;
                                phi_4833_ = _e5805;
                                phi_4834_ = _e5612;
                                phi_4835_ = _e5855;
                                phi_4836_ = _e5857;
                                phi_4837_ = _e5859;
                                phi_4838_ = _e5861;
                                phi_4839_ = _e5863;
                                phi_4840_ = false;
                                phi_4841_ = _e5865;
                            } else {
                                phi_2610_ = f64();
                                phi_2612_ = f64();
                                phi_2614_ = f64();
                                phi_2616_ = f64();
                                phi_2618_ = bool();
                                phi_2620_ = u32();
                                phi_4833_ = f64();
                                phi_4834_ = f64();
                                phi_4835_ = false;
                                phi_4836_ = false;
                                phi_4837_ = false;
                                phi_4838_ = false;
                                phi_4839_ = false;
                                phi_4840_ = true;
                                phi_4841_ = false;
                            }
                            let _e5867 = phi_2610_;
                            let _e5869 = phi_2612_;
                            let _e5871 = phi_2614_;
                            let _e5873 = phi_2616_;
                            let _e5875 = phi_2618_;
                            let _e5877 = phi_2620_;
                            let _e5879 = phi_4833_;
                            let _e5881 = phi_4834_;
                            let _e5883 = phi_4835_;
                            let _e5885 = phi_4836_;
                            let _e5887 = phi_4837_;
                            let _e5889 = phi_4838_;
                            let _e5891 = phi_4839_;
                            let _e5893 = phi_4840_;
                            let _e5895 = phi_4841_;
                            local_27 = _e5885;
                            local_48 = _e5887;
                            local_49 = _e5889;
                            local_50 = _e5891;
                            local_51 = _e5893;
                            local_52 = _e5895;
                            local_53 = _e5885;
                            local_54 = _e5881;
                            local_55 = _e5879;
                            continue;
                            continuing {
                                phi_2606_ = _e4426;
                                phi_2609_ = _e5867;
                                phi_2611_ = _e5869;
                                phi_2613_ = _e5871;
                                phi_2615_ = _e5873;
                                phi_2617_ = _e5875;
                                phi_2619_ = _e5877;
                                break if !(_e5883);
                            }
                        }
                        let _e5898 = local_27;
                        if _e5898 {
                            phi_4845_ = false;
                            phi_4846_ = false;
                            phi_4847_ = false;
                            phi_4848_ = false;
                            phi_4849_ = false;
                        } else {
                            let _e7416 = local_48;
                            phi_4845_ = _e7416;
                            let _e7419 = local_49;
                            phi_4846_ = _e7419;
                            let _e7422 = local_50;
                            phi_4847_ = _e7422;
                            let _e7425 = local_51;
                            phi_4848_ = _e7425;
                            let _e7428 = local_52;
                            phi_4849_ = _e7428;
                        }
                        let _e5900 = phi_4845_;
                        let _e5902 = phi_4846_;
                        let _e5904 = phi_4847_;
                        let _e5906 = phi_4848_;
                        let _e5908 = phi_4849_;
                        if _e5900 {
                            let _e5910 = local_28;
                            phi_4854_ = type_44(1u, _e5910);
                            phi_4855_ = false;
                            phi_4856_ = false;
                            phi_4857_ = false;
                            phi_4858_ = false;
                            phi_4859_ = false;
                        } else {
                            phi_4854_ = type_44();
                            phi_4855_ = _e5902;
                            phi_4856_ = _e5904;
                            let _e7435 = local_53;
                            phi_4857_ = _e7435;
                            phi_4858_ = _e5906;
                            phi_4859_ = _e5908;
                        }
                        let _e5913 = phi_4854_;
                        let _e5915 = phi_4855_;
                        let _e5917 = phi_4856_;
                        let _e5919 = phi_4857_;
                        let _e5921 = phi_4858_;
                        let _e5923 = phi_4859_;
                        if _e5915 {
                            phi_4864_ = type_44(0u, type_44().member_1);
                            phi_4865_ = false;
                            phi_4866_ = false;
                            phi_4867_ = false;
                            phi_4868_ = false;
                            phi_4869_ = true;
                        } else {
                            phi_4864_ = _e5913;
                            phi_4865_ = _e5917;
                            phi_4866_ = _e5919;
                            phi_4867_ = _e5921;
                            phi_4868_ = _e5923;
                            phi_4869_ = _e5900;
                        }
                        let _e5927 = phi_4864_;
                        let _e5929 = phi_4865_;
                        let _e5931 = phi_4866_;
                        let _e5933 = phi_4867_;
                        let _e5935 = phi_4868_;
                        let _e5937 = phi_4869_;
                        if _e5929 {
                            let _e7446 = local_54;
                            phi_4873_ = _e7446;
                            phi_4874_ = true;
                            phi_4875_ = false;
                            phi_4876_ = false;
                            phi_4877_ = false;
                        } else {
                            let _e7448 = local_55;
                            phi_4873_ = _e7448;
                            phi_4874_ = _e5931;
                            phi_4875_ = _e5933;
                            phi_4876_ = _e5935;
                            phi_4877_ = _e5937;
                        }
                        let _e5939 = phi_4873_;
                        let _e5941 = phi_4874_;
                        let _e5943 = phi_4875_;
                        let _e5945 = phi_4876_;
                        let _e5947 = phi_4877_;
                        if _e5941 {
                            phi_4881_ = _e5939;
                            phi_4882_ = true;
                            phi_4883_ = false;
                            phi_4884_ = false;
                        } else {
                            let _e7455 = local_56;
                            phi_4881_ = _e7455;
                            phi_4882_ = _e5943;
                            phi_4883_ = _e5945;
                            phi_4884_ = _e5947;
                        }
                        let _e5949 = phi_4881_;
                        let _e5951 = phi_4882_;
                        let _e5953 = phi_4883_;
                        let _e5955 = phi_4884_;
                        if _e5951 {
                            phi_4889_ = type_44(1u, _e5949);
                            phi_4890_ = false;
                            phi_4891_ = false;
                        } else {
                            phi_4889_ = type_44();
                            phi_4890_ = _e5953;
                            phi_4891_ = _e5955;
                        }
                        let _e5958 = phi_4889_;
                        let _e5960 = phi_4890_;
                        let _e5962 = phi_4891_;
                        if _e5960 {
                            phi_4896_ = type_44(0u, type_44().member_1);
                            phi_4897_ = true;
                        } else {
                            phi_4896_ = _e5927;
                            phi_4897_ = _e5962;
                        }
                        let _e5966 = phi_4896_;
                        let _e5968 = phi_4897_;
                        if _e5968 {
                            phi_4901_ = _e5966;
                        } else {
                            phi_4901_ = _e5958;
                        }
                        let _e5970 = phi_4901_;
                        if (_e5970.member != 0u) {
                            local_11[0u] = 0.00000001f;
                            local_11[1u] = 0f;
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4914_ = type_12(0u, 3u);
                            loop {
                                let _e5981 = phi_4914_;
                                if (_e5981.member < _e5981.member_1) {
                                    phi_4915_ = type_12((_e5981.member + 1u), _e5981.member_1);
                                    phi_4938_ = type_12(1u, _e5981.member);
                                } else {
                                    phi_4915_ = _e5981;
                                    phi_4938_ = type_12(0u, type_12().member_1);
                                }
                                let _e5993 = phi_4915_;
                                let _e5995 = phi_4938_;
                                if (bitcast<i32>(_e5995.member) != 0i) {
                                    let _e6001 = local_11[_e5995.member_1];
                                    let _e6003 = (_e5970.member_1 + f64(_e6001));
                                    if (_e6003 < _e4169) {
                                        phi_4959_ = _e6003;
                                    } else {
                                        phi_4959_ = _e4169;
                                    }
                                    let _e6006 = phi_4959_;
                                    let _e6009 = local_12.member[0u];
                                    let _e6015 = local_12.member[1u];
                                    let _e6031 = local_12.member_1[0u];
                                    let _e6037 = local_12.member_1[1u];
                                    let _e6053 = local_12.member_2[0u];
                                    let _e6059 = local_12.member_2[1u];
                                    let _e6073 = function_2(array<f64, 3>((_e6009[0] + ((_e6015[0] - _e6009[0]) * _e6006)), (_e6009[1] + ((_e6015[1] - _e6009[1]) * _e6006)), (_e6009[2] + ((_e6015[2] - _e6009[2]) * _e6006))), array<f64, 3>((_e6031[0] + ((_e6037[0] - _e6031[0]) * _e6006)), (_e6031[1] + ((_e6037[1] - _e6031[1]) * _e6006)), (_e6031[2] + ((_e6037[2] - _e6031[2]) * _e6006))), array<f64, 3>((_e6053[0] + ((_e6059[0] - _e6053[0]) * _e6006)), (_e6053[1] + ((_e6059[1] - _e6053[1]) * _e6006)), (_e6053[2] + ((_e6059[2] - _e6053[2]) * _e6006))), 0u);
                                    let _e6084 = (((_e6073[0] * _e6073[0]) + (_e6073[1] * _e6073[1])) + (_e6073[2] * _e6073[2]));
                                    if (_e6084 <= 2.2250738585072014e-308lf) {
                                        if (_e6084 > 0.0lf) {
                                            phi_5082_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_5082_ = 0.0lf;
                                        }
                                        let _e6136 = phi_5082_;
                                        phi_5146_ = _e6136;
                                    } else {
                                        phi_5089_ = type_16(0i, 5i);
                                        phi_5092_ = bitcast<f64>(((bitcast<u64>(_e6084) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e6091 = phi_5089_;
                                            let _e6093 = phi_5092_;
                                            local_29 = _e6093;
                                            if (_e6091.member < _e6091.member_1) {
                                                let _e6100 = (_e6091.member + 1i);
                                                if ((false == (_e6100 > _e6091.member)) != false) {
                                                    phi_5113_ = true;
                                                } else {
                                                    phi_5113_ = false;
                                                }
                                                let _e6105 = phi_5113_;
                                                if _e6105 {
                                                    phi_5119_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_5119_ = type_17(1u, _e6100);
                                                }
                                                let _e6110 = phi_5119_;
                                                phi_5090_ = type_16(_e6110.member_1, _e6091.member_1);
                                                phi_5133_ = type_17(1u, _e6091.member);
                                            } else {
                                                phi_5090_ = _e6091;
                                                phi_5133_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e6116 = phi_5090_;
                                            let _e6118 = phi_5133_;
                                            let _e6121 = (bitcast<i32>(_e6118.member) != 0i);
                                            if _e6121 {
                                                phi_5093_ = (0.5lf * (_e6093 + (_e6084 / _e6093)));
                                            } else {
                                                phi_5093_ = f64();
                                            }
                                            let _e6126 = phi_5093_;
                                            continue;
                                            continuing {
                                                phi_5089_ = _e6116;
                                                phi_5092_ = _e6126;
                                                break if !(_e6121);
                                            }
                                        }
                                        let _e6131 = local_29;
                                        phi_5146_ = (_e6131 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e6138 = phi_5146_;
                                    let _e6146 = local_12.member[0u];
                                    if (_e6146[0] < 0.0lf) {
                                        phi_5164_ = -(_e6146[0]);
                                    } else {
                                        phi_5164_ = _e6146[0];
                                    }
                                    let _e6153 = phi_5164_;
                                    if (_e6146[1] < 0.0lf) {
                                        phi_5171_ = -(_e6146[1]);
                                    } else {
                                        phi_5171_ = _e6146[1];
                                    }
                                    let _e6157 = phi_5171_;
                                    if (_e6153 > _e6157) {
                                        phi_5176_ = _e6153;
                                    } else {
                                        phi_5176_ = _e6157;
                                    }
                                    let _e6160 = phi_5176_;
                                    if (_e6146[2] < 0.0lf) {
                                        phi_5183_ = -(_e6146[2]);
                                    } else {
                                        phi_5183_ = _e6146[2];
                                    }
                                    let _e6164 = phi_5183_;
                                    if (_e6160 > _e6164) {
                                        phi_5188_ = _e6160;
                                    } else {
                                        phi_5188_ = _e6164;
                                    }
                                    let _e6167 = phi_5188_;
                                    let _e6170 = local_12.member[1u];
                                    if (_e6170[0] < 0.0lf) {
                                        phi_5201_ = -(_e6170[0]);
                                    } else {
                                        phi_5201_ = _e6170[0];
                                    }
                                    let _e6177 = phi_5201_;
                                    if (_e6170[1] < 0.0lf) {
                                        phi_5208_ = -(_e6170[1]);
                                    } else {
                                        phi_5208_ = _e6170[1];
                                    }
                                    let _e6181 = phi_5208_;
                                    if (_e6177 > _e6181) {
                                        phi_5213_ = _e6177;
                                    } else {
                                        phi_5213_ = _e6181;
                                    }
                                    let _e6184 = phi_5213_;
                                    if (_e6170[2] < 0.0lf) {
                                        phi_5220_ = -(_e6170[2]);
                                    } else {
                                        phi_5220_ = _e6170[2];
                                    }
                                    let _e6188 = phi_5220_;
                                    if (_e6184 > _e6188) {
                                        phi_5225_ = _e6184;
                                    } else {
                                        phi_5225_ = _e6188;
                                    }
                                    let _e6191 = phi_5225_;
                                    if (_e6167 > _e6191) {
                                        phi_5230_ = _e6167;
                                    } else {
                                        phi_5230_ = _e6191;
                                    }
                                    let _e6194 = phi_5230_;
                                    let _e6196 = local_12.member_3;
                                    let _e6200 = local_12.member_1[0u];
                                    if (_e6200[0] < 0.0lf) {
                                        phi_5247_ = -(_e6200[0]);
                                    } else {
                                        phi_5247_ = _e6200[0];
                                    }
                                    let _e6207 = phi_5247_;
                                    if (_e6200[1] < 0.0lf) {
                                        phi_5254_ = -(_e6200[1]);
                                    } else {
                                        phi_5254_ = _e6200[1];
                                    }
                                    let _e6211 = phi_5254_;
                                    if (_e6207 > _e6211) {
                                        phi_5259_ = _e6207;
                                    } else {
                                        phi_5259_ = _e6211;
                                    }
                                    let _e6214 = phi_5259_;
                                    if (_e6200[2] < 0.0lf) {
                                        phi_5266_ = -(_e6200[2]);
                                    } else {
                                        phi_5266_ = _e6200[2];
                                    }
                                    let _e6218 = phi_5266_;
                                    if (_e6214 > _e6218) {
                                        phi_5271_ = _e6214;
                                    } else {
                                        phi_5271_ = _e6218;
                                    }
                                    let _e6221 = phi_5271_;
                                    let _e6224 = local_12.member_1[1u];
                                    if (_e6224[0] < 0.0lf) {
                                        phi_5285_ = -(_e6224[0]);
                                    } else {
                                        phi_5285_ = _e6224[0];
                                    }
                                    let _e6231 = phi_5285_;
                                    if (_e6224[1] < 0.0lf) {
                                        phi_5292_ = -(_e6224[1]);
                                    } else {
                                        phi_5292_ = _e6224[1];
                                    }
                                    let _e6235 = phi_5292_;
                                    if (_e6231 > _e6235) {
                                        phi_5297_ = _e6231;
                                    } else {
                                        phi_5297_ = _e6235;
                                    }
                                    let _e6238 = phi_5297_;
                                    if (_e6224[2] < 0.0lf) {
                                        phi_5304_ = -(_e6224[2]);
                                    } else {
                                        phi_5304_ = _e6224[2];
                                    }
                                    let _e6242 = phi_5304_;
                                    if (_e6238 > _e6242) {
                                        phi_5309_ = _e6238;
                                    } else {
                                        phi_5309_ = _e6242;
                                    }
                                    let _e6245 = phi_5309_;
                                    if (_e6221 > _e6245) {
                                        phi_5314_ = _e6221;
                                    } else {
                                        phi_5314_ = _e6245;
                                    }
                                    let _e6248 = phi_5314_;
                                    let _e6250 = local_12.member_3;
                                    let _e6254 = local_12.member_2[0u];
                                    if (_e6254[0] < 0.0lf) {
                                        phi_5331_ = -(_e6254[0]);
                                    } else {
                                        phi_5331_ = _e6254[0];
                                    }
                                    let _e6261 = phi_5331_;
                                    if (_e6254[1] < 0.0lf) {
                                        phi_5338_ = -(_e6254[1]);
                                    } else {
                                        phi_5338_ = _e6254[1];
                                    }
                                    let _e6265 = phi_5338_;
                                    if (_e6261 > _e6265) {
                                        phi_5343_ = _e6261;
                                    } else {
                                        phi_5343_ = _e6265;
                                    }
                                    let _e6268 = phi_5343_;
                                    if (_e6254[2] < 0.0lf) {
                                        phi_5350_ = -(_e6254[2]);
                                    } else {
                                        phi_5350_ = _e6254[2];
                                    }
                                    let _e6272 = phi_5350_;
                                    if (_e6268 > _e6272) {
                                        phi_5355_ = _e6268;
                                    } else {
                                        phi_5355_ = _e6272;
                                    }
                                    let _e6275 = phi_5355_;
                                    let _e6278 = local_12.member_2[1u];
                                    if (_e6278[0] < 0.0lf) {
                                        phi_5369_ = -(_e6278[0]);
                                    } else {
                                        phi_5369_ = _e6278[0];
                                    }
                                    let _e6285 = phi_5369_;
                                    if (_e6278[1] < 0.0lf) {
                                        phi_5376_ = -(_e6278[1]);
                                    } else {
                                        phi_5376_ = _e6278[1];
                                    }
                                    let _e6289 = phi_5376_;
                                    if (_e6285 > _e6289) {
                                        phi_5381_ = _e6285;
                                    } else {
                                        phi_5381_ = _e6289;
                                    }
                                    let _e6292 = phi_5381_;
                                    if (_e6278[2] < 0.0lf) {
                                        phi_5388_ = -(_e6278[2]);
                                    } else {
                                        phi_5388_ = _e6278[2];
                                    }
                                    let _e6296 = phi_5388_;
                                    if (_e6292 > _e6296) {
                                        phi_5393_ = _e6292;
                                    } else {
                                        phi_5393_ = _e6296;
                                    }
                                    let _e6299 = phi_5393_;
                                    if (_e6275 > _e6299) {
                                        phi_5398_ = _e6275;
                                    } else {
                                        phi_5398_ = _e6299;
                                    }
                                    let _e6302 = phi_5398_;
                                    let _e6304 = local_12.member_3;
                                    let _e6312 = local_12.member_3;
                                    let _e6322 = (((_e6138 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6194 + _e6196) + (_e6248 + _e6250)) + (_e6302 + _e6304)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6312 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e575.member_1);
                                    if _e6322 {
                                        phi_5422_ = false;
                                    } else {
                                        phi_5422_ = true;
                                    }
                                    let _e6324 = phi_5422_;
                                    phi_5423_ = _e6324;
                                    phi_5424_ = _e6322;
                                } else {
                                    phi_5423_ = false;
                                    phi_5424_ = false;
                                }
                                let _e6326 = phi_5423_;
                                let _e6328 = phi_5424_;
                                local_30 = _e6328;
                                continue;
                                continuing {
                                    phi_4914_ = _e5993;
                                    break if !(_e6326);
                                }
                            }
                            let _e6331 = local_30;
                            if _e6331 {
                                phi_5429_ = type_44(1u, _e5970.member_1);
                                phi_5430_ = false;
                            } else {
                                phi_5429_ = type_44();
                                phi_5430_ = true;
                            }
                            let _e6334 = phi_5429_;
                            let _e6336 = phi_5430_;
                            if _e6336 {
                                phi_5435_ = type_44(2u, _e5970.member_1);
                                phi_5436_ = false;
                            } else {
                                phi_5435_ = type_44();
                                phi_5436_ = true;
                            }
                            let _e6339 = phi_5435_;
                            let _e6341 = phi_5436_;
                            phi_5438_ = _e6339;
                            phi_5439_ = _e6334;
                            phi_5440_ = _e6341;
                        } else {
                            phi_5438_ = type_44();
                            phi_5439_ = type_44(0u, type_44().member_1);
                            phi_5440_ = true;
                        }
                        let _e6343 = phi_5438_;
                        let _e6345 = phi_5439_;
                        let _e6347 = phi_5440_;
                        if _e6347 {
                            phi_5444_ = _e6345;
                        } else {
                            phi_5444_ = _e6343;
                        }
                        let _e6349 = phi_5444_;
                        phi_10015_ = _e6349;
                    } else {
                        if (_e713 < 0.0lf) {
                            phi_5455_ = -(_e713);
                        } else {
                            phi_5455_ = _e713;
                        }
                        let _e1070 = phi_5455_;
                        if (_e736 < 0.0lf) {
                            phi_5461_ = -(_e736);
                        } else {
                            phi_5461_ = _e736;
                        }
                        let _e1074 = phi_5461_;
                        if (_e1070 > _e1074) {
                            phi_5466_ = _e1070;
                        } else {
                            phi_5466_ = _e1074;
                        }
                        let _e1077 = phi_5466_;
                        if (_e759 < 0.0lf) {
                            phi_5472_ = -(_e759);
                        } else {
                            phi_5472_ = _e759;
                        }
                        let _e1081 = phi_5472_;
                        if (_e770 < 0.0lf) {
                            phi_5478_ = -(_e770);
                        } else {
                            phi_5478_ = _e770;
                        }
                        let _e1085 = phi_5478_;
                        if (_e1081 > _e1085) {
                            phi_5483_ = _e1081;
                        } else {
                            phi_5483_ = _e1085;
                        }
                        let _e1088 = phi_5483_;
                        if (_e1077 > _e1088) {
                            phi_5488_ = _e1077;
                        } else {
                            phi_5488_ = _e1088;
                        }
                        let _e1091 = phi_5488_;
                        let _e1093 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1094 = f64(1f);
                        if (_e1091 >= _e1093) {
                            phi_5498_ = (_e1091 <= (_e1094 / _e1093));
                        } else {
                            phi_5498_ = false;
                        }
                        let _e1099 = phi_5498_;
                        if _e1099 {
                            phi_5505_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_5505_ = f64(2f);
                        }
                        let _e1104 = phi_5505_;
                        let _e1106 = ((_e1029 * f64(0.34f)) + (_e1091 * _e1104));
                        if _e1099 {
                            phi_5513_ = (_e1094 / _e1091);
                        } else {
                            phi_5513_ = f64(0f);
                        }
                        let _e1110 = phi_5513_;
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
                                    phi_5549_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_5549_ = 0.0lf;
                                }
                                let _e1181 = phi_5549_;
                                phi_5613_ = _e1181;
                            } else {
                                phi_5556_ = type_16(0i, 5i);
                                phi_5559_ = bitcast<f64>(((bitcast<u64>(_e1128) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1136 = phi_5556_;
                                    let _e1138 = phi_5559_;
                                    local_13 = _e1138;
                                    if (_e1136.member < _e1136.member_1) {
                                        let _e1145 = (_e1136.member + 1i);
                                        if ((false == (_e1145 > _e1136.member)) != false) {
                                            phi_5580_ = true;
                                        } else {
                                            phi_5580_ = false;
                                        }
                                        let _e1150 = phi_5580_;
                                        if _e1150 {
                                            phi_5586_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_5586_ = type_17(1u, _e1145);
                                        }
                                        let _e1155 = phi_5586_;
                                        phi_5557_ = type_16(_e1155.member_1, _e1136.member_1);
                                        phi_5600_ = type_17(1u, _e1136.member);
                                    } else {
                                        phi_5557_ = _e1136;
                                        phi_5600_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1161 = phi_5557_;
                                    let _e1163 = phi_5600_;
                                    let _e1166 = (bitcast<i32>(_e1163.member) != 0i);
                                    if _e1166 {
                                        phi_5560_ = (0.5lf * (_e1138 + (_e1128 / _e1138)));
                                    } else {
                                        phi_5560_ = f64();
                                    }
                                    let _e1171 = phi_5560_;
                                    continue;
                                    continuing {
                                        phi_5556_ = _e1161;
                                        phi_5559_ = _e1171;
                                        break if !(_e1166);
                                    }
                                }
                                let _e1176 = local_13;
                                phi_5613_ = (_e1176 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1183 = phi_5613_;
                            if (_e1120 < _e1111) {
                                phi_5619_ = -(_e1183);
                            } else {
                                phi_5619_ = _e1183;
                            }
                            let _e1187 = phi_5619_;
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
                            phi_5644_ = type_12(0u, 2u);
                            phi_5647_ = 1u;
                            loop {
                                let _e1208 = phi_5644_;
                                let _e1210 = phi_5647_;
                                local_31 = _e1210;
                                if (_e1208.member < _e1208.member_1) {
                                    phi_5645_ = type_12((_e1208.member + 1u), _e1208.member_1);
                                    phi_5670_ = type_12(1u, _e1208.member);
                                } else {
                                    phi_5645_ = _e1208;
                                    phi_5670_ = type_12(0u, type_12().member_1);
                                }
                                let _e1222 = phi_5645_;
                                let _e1224 = phi_5670_;
                                let _e1228 = (bitcast<i32>(_e1224.member) != 0i);
                                if _e1228 {
                                    let _e1230 = local_7[_e1224.member_1];
                                    if (_e1230 > _e1111) {
                                        let _e1233 = local_7[_e1224.member_1];
                                        if (_e1233 < _e1112) {
                                            let _e1236 = local_7[_e1224.member_1];
                                            local_6[_e1210] = _e1236;
                                            phi_5714_ = (_e1210 + 1u);
                                        } else {
                                            phi_5714_ = _e1210;
                                        }
                                        let _e1240 = phi_5714_;
                                        phi_5715_ = _e1240;
                                    } else {
                                        phi_5715_ = _e1210;
                                    }
                                    let _e1242 = phi_5715_;
                                    phi_5648_ = _e1242;
                                } else {
                                    phi_5648_ = u32();
                                }
                                let _e1244 = phi_5648_;
                                continue;
                                continuing {
                                    phi_5644_ = _e1222;
                                    phi_5647_ = _e1244;
                                    break if !(_e1228);
                                }
                            }
                            let _e6575 = local_31;
                            phi_5716_ = _e6575;
                        } else {
                            phi_5716_ = 1u;
                        }
                        let _e1247 = phi_5716_;
                        local_6[_e1247] = _e1112;
                        let _e1249 = local_6;
                        local_8 = _e1249;
                        phi_5736_ = type_12(0u, _e1247);
                        loop {
                            let _e1252 = phi_5736_;
                            if (_e1252.member < _e1252.member_1) {
                                phi_5737_ = type_12((_e1252.member + 1u), _e1252.member_1);
                                phi_5760_ = type_12(1u, _e1252.member);
                            } else {
                                phi_5737_ = _e1252;
                                phi_5760_ = type_12(0u, type_12().member_1);
                            }
                            let _e1264 = phi_5737_;
                            let _e1266 = phi_5760_;
                            if (bitcast<i32>(_e1266.member) != 0i) {
                                let _e1272 = local_8[_e1266.member_1];
                                let _e1275 = local_8[(_e1266.member_1 + 1u)];
                                let _e1277 = (f64(1f) - _e1272);
                                let _e1288 = ((((_e713 * _e1277) + (_e736 * _e1272)) * (_e1277 * _e1277)) + (((_e759 * _e1277) + (_e770 * _e1272)) * (_e1272 * _e1272)));
                                let _e1290 = (f64(1f) - _e1275);
                                let _e1301 = ((((_e713 * _e1290) + (_e736 * _e1275)) * (_e1290 * _e1290)) + (((_e759 * _e1290) + (_e770 * _e1275)) * (_e1275 * _e1275)));
                                if (_e1288 < 0.0lf) {
                                    phi_5814_ = -(_e1288);
                                } else {
                                    phi_5814_ = _e1288;
                                }
                                let _e1305 = phi_5814_;
                                let _e1306 = (_e1305 > _e1106);
                                if (_e1301 < 0.0lf) {
                                    phi_5821_ = -(_e1301);
                                } else {
                                    phi_5821_ = _e1301;
                                }
                                let _e1310 = phi_5821_;
                                let _e1311 = (_e1310 > _e1106);
                                let _e1312 = f64(0f);
                                if _e1306 {
                                    if _e1311 {
                                        phi_5833_ = ((_e1288 > _e1312) != (_e1301 > _e1312));
                                        phi_5834_ = false;
                                    } else {
                                        phi_5833_ = bool();
                                        phi_5834_ = true;
                                    }
                                    let _e1317 = phi_5833_;
                                    let _e1319 = phi_5834_;
                                    phi_5835_ = _e1317;
                                    phi_5836_ = _e1319;
                                } else {
                                    phi_5835_ = bool();
                                    phi_5836_ = true;
                                }
                                let _e1321 = phi_5835_;
                                let _e1323 = phi_5836_;
                                if _e1323 {
                                    phi_5840_ = false;
                                } else {
                                    phi_5840_ = _e1321;
                                }
                                let _e1325 = phi_5840_;
                                if _e1306 {
                                    if _e1311 {
                                        if _e1325 {
                                            phi_5852_ = type_45();
                                        } else {
                                            phi_5852_ = type_45(f64(1f), _e1312, _e1325);
                                        }
                                        let _e1329 = phi_5852_;
                                        phi_5853_ = _e1329;
                                        phi_5854_ = _e1325;
                                    } else {
                                        phi_5853_ = type_45();
                                        phi_5854_ = true;
                                    }
                                    let _e1331 = phi_5853_;
                                    let _e1333 = phi_5854_;
                                    phi_5855_ = _e1331;
                                    phi_5856_ = _e1333;
                                } else {
                                    phi_5855_ = type_45();
                                    phi_5856_ = true;
                                }
                                let _e1335 = phi_5855_;
                                let _e1337 = phi_5856_;
                                if _e1337 {
                                    if _e1306 {
                                        if (_e1288 < _e1312) {
                                            phi_5869_ = f64(-1f);
                                        } else {
                                            phi_5869_ = f64(1f);
                                        }
                                        let _e1342 = phi_5869_;
                                        let _e1343 = f64(0.00000000000022737368f);
                                        let _e1344 = f64(0.5f);
                                        let _e1345 = f64(3f);
                                        let _e1348 = (_e759 - _e736);
                                        phi_5882_ = type_12(0u, 64u);
                                        phi_5885_ = _e1275;
                                        phi_5887_ = _e1272;
                                        phi_5889_ = (_e1344 * (_e1272 + _e1275));
                                        loop {
                                            let _e1354 = phi_5882_;
                                            let _e1356 = phi_5885_;
                                            let _e1358 = phi_5887_;
                                            let _e1360 = phi_5889_;
                                            local_33 = _e1358;
                                            if (_e1354.member < _e1354.member_1) {
                                                phi_5883_ = type_12((_e1354.member + 1u), _e1354.member_1);
                                                phi_5912_ = type_12(1u, _e1354.member);
                                            } else {
                                                phi_5883_ = _e1354;
                                                phi_5912_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1372 = phi_5883_;
                                            let _e1374 = phi_5912_;
                                            if (bitcast<i32>(_e1374.member) != 0i) {
                                                let _e1379 = (f64(1f) - _e1360);
                                                let _e1392 = ((_e1342 * ((((_e713 * _e1379) + (_e736 * _e1360)) * (_e1379 * _e1379)) + (((_e759 * _e1379) + (_e770 * _e1360)) * (_e1360 * _e1360)))) - _e1106);
                                                if (_e1392 > f64(0f)) {
                                                    phi_5939_ = _e1356;
                                                    phi_5940_ = _e1360;
                                                } else {
                                                    phi_5939_ = _e1360;
                                                    phi_5940_ = _e1358;
                                                }
                                                let _e1396 = phi_5939_;
                                                let _e1398 = phi_5940_;
                                                let _e1400 = ((_e1396 - _e1398) > _e1343);
                                                if _e1400 {
                                                    let _e1402 = (f64(1f) - _e1360);
                                                    let _e1414 = (-(_e1392) / (_e1342 * (((((_e736 - (_e1345 * _e713)) * _e1402) + (_e1348 * _e1360)) * _e1402) + (((_e1348 * _e1402) + (((_e1345 * _e770) - _e759) * _e1360)) * _e1360))));
                                                    if (_e1392 > f64(0f)) {
                                                        phi_5968_ = (_e1344 * _e1343);
                                                    } else {
                                                        phi_5968_ = -((_e1344 * _e1343));
                                                    }
                                                    let _e1421 = phi_5968_;
                                                    let _e1423 = ((_e1360 + _e1414) + _e1421);
                                                    if (_e1423 > _e1398) {
                                                        if (_e1423 < _e1396) {
                                                            if (_e1414 < 0.0lf) {
                                                                phi_5984_ = -(_e1414);
                                                            } else {
                                                                phi_5984_ = _e1414;
                                                            }
                                                            let _e1429 = phi_5984_;
                                                            if (_e1429 < (_e1344 * (_e1396 - _e1398))) {
                                                                phi_5991_ = false;
                                                            } else {
                                                                phi_5991_ = true;
                                                            }
                                                            let _e1434 = phi_5991_;
                                                            phi_5992_ = _e1434;
                                                        } else {
                                                            phi_5992_ = true;
                                                        }
                                                        let _e1436 = phi_5992_;
                                                        phi_5993_ = _e1436;
                                                    } else {
                                                        phi_5993_ = true;
                                                    }
                                                    let _e1438 = phi_5993_;
                                                    if _e1438 {
                                                        phi_5999_ = (_e1344 * (_e1398 + _e1396));
                                                    } else {
                                                        phi_5999_ = _e1423;
                                                    }
                                                    let _e1442 = phi_5999_;
                                                    phi_6000_ = _e1442;
                                                    phi_6001_ = false;
                                                } else {
                                                    phi_6000_ = f64();
                                                    phi_6001_ = true;
                                                }
                                                let _e1444 = phi_6000_;
                                                let _e1446 = phi_6001_;
                                                phi_5886_ = _e1396;
                                                phi_5888_ = _e1398;
                                                phi_5890_ = _e1444;
                                                phi_6002_ = _e1398;
                                                phi_6003_ = _e1400;
                                                phi_6004_ = _e1446;
                                            } else {
                                                phi_5886_ = f64();
                                                phi_5888_ = f64();
                                                phi_5890_ = f64();
                                                phi_6002_ = f64();
                                                phi_6003_ = false;
                                                phi_6004_ = false;
                                            }
                                            let _e1448 = phi_5886_;
                                            let _e1450 = phi_5888_;
                                            let _e1452 = phi_5890_;
                                            let _e1454 = phi_6002_;
                                            let _e1456 = phi_6003_;
                                            let _e1458 = phi_6004_;
                                            local_14 = _e1458;
                                            local_32 = _e1454;
                                            continue;
                                            continuing {
                                                phi_5882_ = _e1372;
                                                phi_5885_ = _e1448;
                                                phi_5887_ = _e1450;
                                                phi_5889_ = _e1452;
                                                break if !(_e1456);
                                            }
                                        }
                                        let _e1461 = local_14;
                                        if _e1461 {
                                            let _e6617 = local_32;
                                            phi_6008_ = _e6617;
                                        } else {
                                            let _e6619 = local_33;
                                            phi_6008_ = _e6619;
                                        }
                                        let _e1463 = phi_6008_;
                                        phi_6009_ = _e1463;
                                    } else {
                                        phi_6009_ = _e1272;
                                    }
                                    let _e1465 = phi_6009_;
                                    if _e1311 {
                                        if (_e1301 < _e1312) {
                                            phi_6019_ = f64(-1f);
                                        } else {
                                            phi_6019_ = f64(1f);
                                        }
                                        let _e1470 = phi_6019_;
                                        phi_6024_ = type_12(0u, 64u);
                                        phi_6027_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1474 = phi_6024_;
                                            let _e1476 = phi_6027_;
                                            if (_e1474.member < _e1474.member_1) {
                                                phi_6025_ = type_12((_e1474.member + 1u), _e1474.member_1);
                                                phi_6050_ = type_12(1u, _e1474.member);
                                            } else {
                                                phi_6025_ = _e1474;
                                                phi_6050_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1488 = phi_6025_;
                                            let _e1490 = phi_6050_;
                                            if (bitcast<i32>(_e1490.member) != 0i) {
                                                let _e1494 = (_e1465 + _e1476);
                                                if (_e1494 < _e1275) {
                                                    let _e1497 = (f64(1f) - _e1494);
                                                    let _e1510 = ((_e1470 * ((((_e713 * _e1497) + (_e736 * _e1494)) * (_e1497 * _e1497)) + (((_e759 * _e1497) + (_e770 * _e1494)) * (_e1494 * _e1494)))) > _e1106);
                                                    if _e1510 {
                                                        phi_6081_ = f64();
                                                        phi_6082_ = false;
                                                    } else {
                                                        phi_6081_ = (_e1476 + _e1476);
                                                        phi_6082_ = true;
                                                    }
                                                    let _e1513 = phi_6081_;
                                                    let _e1515 = phi_6082_;
                                                    phi_6083_ = _e1513;
                                                    phi_6084_ = _e1515;
                                                    phi_6085_ = _e1510;
                                                    phi_6086_ = false;
                                                } else {
                                                    phi_6083_ = f64();
                                                    phi_6084_ = false;
                                                    phi_6085_ = false;
                                                    phi_6086_ = true;
                                                }
                                                let _e1517 = phi_6083_;
                                                let _e1519 = phi_6084_;
                                                let _e1521 = phi_6085_;
                                                let _e1523 = phi_6086_;
                                                phi_6087_ = _e1494;
                                                phi_6028_ = _e1517;
                                                phi_6088_ = _e1519;
                                                phi_6089_ = _e1521;
                                                phi_6090_ = _e1523;
                                                phi_6091_ = false;
                                            } else {
                                                phi_6087_ = f64();
                                                phi_6028_ = f64();
                                                phi_6088_ = false;
                                                phi_6089_ = false;
                                                phi_6090_ = false;
                                                phi_6091_ = true;
                                            }
                                            let _e1525 = phi_6087_;
                                            let _e1527 = phi_6028_;
                                            let _e1529 = phi_6088_;
                                            let _e1531 = phi_6089_;
                                            let _e1533 = phi_6090_;
                                            let _e1535 = phi_6091_;
                                            local_15 = _e1531;
                                            local_34 = _e1533;
                                            local_35 = _e1535;
                                            local_36 = _e1525;
                                            continue;
                                            continuing {
                                                phi_6024_ = _e1488;
                                                phi_6027_ = _e1527;
                                                break if !(_e1529);
                                            }
                                        }
                                        let _e1538 = local_15;
                                        if _e1538 {
                                            phi_6095_ = false;
                                            phi_6096_ = false;
                                        } else {
                                            let _e6641 = local_34;
                                            phi_6095_ = _e6641;
                                            let _e6644 = local_35;
                                            phi_6096_ = _e6644;
                                        }
                                        let _e1540 = phi_6095_;
                                        let _e1542 = phi_6096_;
                                        if _e1540 {
                                            phi_6100_ = true;
                                        } else {
                                            phi_6100_ = _e1542;
                                        }
                                        let _e1544 = phi_6100_;
                                        if _e1544 {
                                            phi_6104_ = _e1275;
                                        } else {
                                            let _e6648 = local_36;
                                            phi_6104_ = _e6648;
                                        }
                                        let _e1546 = phi_6104_;
                                        phi_6105_ = _e1546;
                                    } else {
                                        phi_6105_ = _e1275;
                                    }
                                    let _e1548 = phi_6105_;
                                    phi_6107_ = type_45(_e1465, _e1548, _e1325);
                                } else {
                                    phi_6107_ = _e1335;
                                }
                                let _e1551 = phi_6107_;
                                if (_e1551.member > _e1551.member_1) {
                                    phi_9971_ = f64();
                                    phi_9972_ = true;
                                    phi_9973_ = false;
                                    phi_9974_ = false;
                                    phi_9975_ = false;
                                } else {
                                    let _e1559 = ((_e1551.member_1 - _e1551.member) * f64(0.5f));
                                    let _e1560 = (_e1551.member + _e1559);
                                    let _e1563 = (_e1559 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1565 = local_12.member_3;
                                    let _e1568 = local_12.member[0u];
                                    if (_e1568[0] < 0.0lf) {
                                        phi_6138_ = -(_e1568[0]);
                                    } else {
                                        phi_6138_ = _e1568[0];
                                    }
                                    let _e1575 = phi_6138_;
                                    if (_e1568[1] < 0.0lf) {
                                        phi_6145_ = -(_e1568[1]);
                                    } else {
                                        phi_6145_ = _e1568[1];
                                    }
                                    let _e1579 = phi_6145_;
                                    if (_e1575 > _e1579) {
                                        phi_6150_ = _e1575;
                                    } else {
                                        phi_6150_ = _e1579;
                                    }
                                    let _e1582 = phi_6150_;
                                    if (_e1568[2] < 0.0lf) {
                                        phi_6157_ = -(_e1568[2]);
                                    } else {
                                        phi_6157_ = _e1568[2];
                                    }
                                    let _e1586 = phi_6157_;
                                    if (_e1582 > _e1586) {
                                        phi_6162_ = _e1582;
                                    } else {
                                        phi_6162_ = _e1586;
                                    }
                                    let _e1589 = phi_6162_;
                                    let _e1591 = local_12.member[1u];
                                    if (_e1591[0] < 0.0lf) {
                                        phi_6175_ = -(_e1591[0]);
                                    } else {
                                        phi_6175_ = _e1591[0];
                                    }
                                    let _e1598 = phi_6175_;
                                    if (_e1591[1] < 0.0lf) {
                                        phi_6182_ = -(_e1591[1]);
                                    } else {
                                        phi_6182_ = _e1591[1];
                                    }
                                    let _e1602 = phi_6182_;
                                    if (_e1598 > _e1602) {
                                        phi_6187_ = _e1598;
                                    } else {
                                        phi_6187_ = _e1602;
                                    }
                                    let _e1605 = phi_6187_;
                                    if (_e1591[2] < 0.0lf) {
                                        phi_6194_ = -(_e1591[2]);
                                    } else {
                                        phi_6194_ = _e1591[2];
                                    }
                                    let _e1609 = phi_6194_;
                                    if (_e1605 > _e1609) {
                                        phi_6199_ = _e1605;
                                    } else {
                                        phi_6199_ = _e1609;
                                    }
                                    let _e1612 = phi_6199_;
                                    if (_e1589 > _e1612) {
                                        phi_6204_ = _e1589;
                                    } else {
                                        phi_6204_ = _e1612;
                                    }
                                    let _e1615 = phi_6204_;
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
                                        phi_6263_ = -(_e1646);
                                    } else {
                                        phi_6263_ = _e1646;
                                    }
                                    let _e1652 = phi_6263_;
                                    if (_e1647 < 0.0lf) {
                                        phi_6269_ = -(_e1647);
                                    } else {
                                        phi_6269_ = _e1647;
                                    }
                                    let _e1656 = phi_6269_;
                                    if (_e1652 > _e1656) {
                                        phi_6274_ = _e1652;
                                    } else {
                                        phi_6274_ = _e1656;
                                    }
                                    let _e1659 = phi_6274_;
                                    if (_e1648 < 0.0lf) {
                                        phi_6280_ = -(_e1648);
                                    } else {
                                        phi_6280_ = _e1648;
                                    }
                                    let _e1663 = phi_6280_;
                                    if (_e1659 > _e1663) {
                                        phi_6285_ = _e1659;
                                    } else {
                                        phi_6285_ = _e1663;
                                    }
                                    let _e1666 = phi_6285_;
                                    let _e1674 = ((((_e1563 * _e1666) * f64(1.01f)) + ((_e1615 + _e1565) * (1.1102230246251565e-16lf * f64(8f)))) + _e1565);
                                    if (_e1633 < 0.0lf) {
                                        phi_6299_ = -(_e1633);
                                    } else {
                                        phi_6299_ = _e1633;
                                    }
                                    let _e1678 = phi_6299_;
                                    if (_e1634 < 0.0lf) {
                                        phi_6305_ = -(_e1634);
                                    } else {
                                        phi_6305_ = _e1634;
                                    }
                                    let _e1682 = phi_6305_;
                                    if (_e1678 > _e1682) {
                                        phi_6310_ = _e1678;
                                    } else {
                                        phi_6310_ = _e1682;
                                    }
                                    let _e1685 = phi_6310_;
                                    if (_e1635 < 0.0lf) {
                                        phi_6316_ = -(_e1635);
                                    } else {
                                        phi_6316_ = _e1635;
                                    }
                                    let _e1689 = phi_6316_;
                                    if (_e1685 > _e1689) {
                                        phi_6321_ = _e1685;
                                    } else {
                                        phi_6321_ = _e1689;
                                    }
                                    let _e1692 = phi_6321_;
                                    local_2 = type_35(array<f64, 3>(_e1633, _e1634, _e1635), _e1674, (_e1692 + _e1674));
                                    let _e1698 = local_12.member_3;
                                    let _e1700 = local_12.member_1[0u];
                                    if (_e1700[0] < 0.0lf) {
                                        phi_6347_ = -(_e1700[0]);
                                    } else {
                                        phi_6347_ = _e1700[0];
                                    }
                                    let _e1707 = phi_6347_;
                                    if (_e1700[1] < 0.0lf) {
                                        phi_6354_ = -(_e1700[1]);
                                    } else {
                                        phi_6354_ = _e1700[1];
                                    }
                                    let _e1711 = phi_6354_;
                                    if (_e1707 > _e1711) {
                                        phi_6359_ = _e1707;
                                    } else {
                                        phi_6359_ = _e1711;
                                    }
                                    let _e1714 = phi_6359_;
                                    if (_e1700[2] < 0.0lf) {
                                        phi_6366_ = -(_e1700[2]);
                                    } else {
                                        phi_6366_ = _e1700[2];
                                    }
                                    let _e1718 = phi_6366_;
                                    if (_e1714 > _e1718) {
                                        phi_6371_ = _e1714;
                                    } else {
                                        phi_6371_ = _e1718;
                                    }
                                    let _e1721 = phi_6371_;
                                    let _e1723 = local_12.member_1[1u];
                                    if (_e1723[0] < 0.0lf) {
                                        phi_6384_ = -(_e1723[0]);
                                    } else {
                                        phi_6384_ = _e1723[0];
                                    }
                                    let _e1730 = phi_6384_;
                                    if (_e1723[1] < 0.0lf) {
                                        phi_6391_ = -(_e1723[1]);
                                    } else {
                                        phi_6391_ = _e1723[1];
                                    }
                                    let _e1734 = phi_6391_;
                                    if (_e1730 > _e1734) {
                                        phi_6396_ = _e1730;
                                    } else {
                                        phi_6396_ = _e1734;
                                    }
                                    let _e1737 = phi_6396_;
                                    if (_e1723[2] < 0.0lf) {
                                        phi_6403_ = -(_e1723[2]);
                                    } else {
                                        phi_6403_ = _e1723[2];
                                    }
                                    let _e1741 = phi_6403_;
                                    if (_e1737 > _e1741) {
                                        phi_6408_ = _e1737;
                                    } else {
                                        phi_6408_ = _e1741;
                                    }
                                    let _e1744 = phi_6408_;
                                    if (_e1721 > _e1744) {
                                        phi_6413_ = _e1721;
                                    } else {
                                        phi_6413_ = _e1744;
                                    }
                                    let _e1747 = phi_6413_;
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
                                        phi_6472_ = -(_e1778);
                                    } else {
                                        phi_6472_ = _e1778;
                                    }
                                    let _e1784 = phi_6472_;
                                    if (_e1779 < 0.0lf) {
                                        phi_6478_ = -(_e1779);
                                    } else {
                                        phi_6478_ = _e1779;
                                    }
                                    let _e1788 = phi_6478_;
                                    if (_e1784 > _e1788) {
                                        phi_6483_ = _e1784;
                                    } else {
                                        phi_6483_ = _e1788;
                                    }
                                    let _e1791 = phi_6483_;
                                    if (_e1780 < 0.0lf) {
                                        phi_6489_ = -(_e1780);
                                    } else {
                                        phi_6489_ = _e1780;
                                    }
                                    let _e1795 = phi_6489_;
                                    if (_e1791 > _e1795) {
                                        phi_6494_ = _e1791;
                                    } else {
                                        phi_6494_ = _e1795;
                                    }
                                    let _e1798 = phi_6494_;
                                    let _e1806 = ((((_e1563 * _e1798) * f64(1.01f)) + ((_e1747 + _e1698) * (1.1102230246251565e-16lf * f64(8f)))) + _e1698);
                                    if (_e1765 < 0.0lf) {
                                        phi_6508_ = -(_e1765);
                                    } else {
                                        phi_6508_ = _e1765;
                                    }
                                    let _e1810 = phi_6508_;
                                    if (_e1766 < 0.0lf) {
                                        phi_6514_ = -(_e1766);
                                    } else {
                                        phi_6514_ = _e1766;
                                    }
                                    let _e1814 = phi_6514_;
                                    if (_e1810 > _e1814) {
                                        phi_6519_ = _e1810;
                                    } else {
                                        phi_6519_ = _e1814;
                                    }
                                    let _e1817 = phi_6519_;
                                    if (_e1767 < 0.0lf) {
                                        phi_6525_ = -(_e1767);
                                    } else {
                                        phi_6525_ = _e1767;
                                    }
                                    let _e1821 = phi_6525_;
                                    if (_e1817 > _e1821) {
                                        phi_6530_ = _e1817;
                                    } else {
                                        phi_6530_ = _e1821;
                                    }
                                    let _e1824 = phi_6530_;
                                    local_3 = type_35(array<f64, 3>(_e1765, _e1766, _e1767), _e1806, (_e1824 + _e1806));
                                    let _e1830 = local_12.member_3;
                                    let _e1832 = local_12.member_2[0u];
                                    if (_e1832[0] < 0.0lf) {
                                        phi_6556_ = -(_e1832[0]);
                                    } else {
                                        phi_6556_ = _e1832[0];
                                    }
                                    let _e1839 = phi_6556_;
                                    if (_e1832[1] < 0.0lf) {
                                        phi_6563_ = -(_e1832[1]);
                                    } else {
                                        phi_6563_ = _e1832[1];
                                    }
                                    let _e1843 = phi_6563_;
                                    if (_e1839 > _e1843) {
                                        phi_6568_ = _e1839;
                                    } else {
                                        phi_6568_ = _e1843;
                                    }
                                    let _e1846 = phi_6568_;
                                    if (_e1832[2] < 0.0lf) {
                                        phi_6575_ = -(_e1832[2]);
                                    } else {
                                        phi_6575_ = _e1832[2];
                                    }
                                    let _e1850 = phi_6575_;
                                    if (_e1846 > _e1850) {
                                        phi_6580_ = _e1846;
                                    } else {
                                        phi_6580_ = _e1850;
                                    }
                                    let _e1853 = phi_6580_;
                                    let _e1855 = local_12.member_2[1u];
                                    if (_e1855[0] < 0.0lf) {
                                        phi_6593_ = -(_e1855[0]);
                                    } else {
                                        phi_6593_ = _e1855[0];
                                    }
                                    let _e1862 = phi_6593_;
                                    if (_e1855[1] < 0.0lf) {
                                        phi_6600_ = -(_e1855[1]);
                                    } else {
                                        phi_6600_ = _e1855[1];
                                    }
                                    let _e1866 = phi_6600_;
                                    if (_e1862 > _e1866) {
                                        phi_6605_ = _e1862;
                                    } else {
                                        phi_6605_ = _e1866;
                                    }
                                    let _e1869 = phi_6605_;
                                    if (_e1855[2] < 0.0lf) {
                                        phi_6612_ = -(_e1855[2]);
                                    } else {
                                        phi_6612_ = _e1855[2];
                                    }
                                    let _e1873 = phi_6612_;
                                    if (_e1869 > _e1873) {
                                        phi_6617_ = _e1869;
                                    } else {
                                        phi_6617_ = _e1873;
                                    }
                                    let _e1876 = phi_6617_;
                                    if (_e1853 > _e1876) {
                                        phi_6622_ = _e1853;
                                    } else {
                                        phi_6622_ = _e1876;
                                    }
                                    let _e1879 = phi_6622_;
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
                                        phi_6681_ = -(_e1910);
                                    } else {
                                        phi_6681_ = _e1910;
                                    }
                                    let _e1916 = phi_6681_;
                                    if (_e1911 < 0.0lf) {
                                        phi_6687_ = -(_e1911);
                                    } else {
                                        phi_6687_ = _e1911;
                                    }
                                    let _e1920 = phi_6687_;
                                    if (_e1916 > _e1920) {
                                        phi_6692_ = _e1916;
                                    } else {
                                        phi_6692_ = _e1920;
                                    }
                                    let _e1923 = phi_6692_;
                                    if (_e1912 < 0.0lf) {
                                        phi_6698_ = -(_e1912);
                                    } else {
                                        phi_6698_ = _e1912;
                                    }
                                    let _e1927 = phi_6698_;
                                    if (_e1923 > _e1927) {
                                        phi_6703_ = _e1923;
                                    } else {
                                        phi_6703_ = _e1927;
                                    }
                                    let _e1930 = phi_6703_;
                                    let _e1938 = ((((_e1563 * _e1930) * f64(1.01f)) + ((_e1879 + _e1830) * (1.1102230246251565e-16lf * f64(8f)))) + _e1830);
                                    if (_e1897 < 0.0lf) {
                                        phi_6717_ = -(_e1897);
                                    } else {
                                        phi_6717_ = _e1897;
                                    }
                                    let _e1942 = phi_6717_;
                                    if (_e1898 < 0.0lf) {
                                        phi_6723_ = -(_e1898);
                                    } else {
                                        phi_6723_ = _e1898;
                                    }
                                    let _e1946 = phi_6723_;
                                    if (_e1942 > _e1946) {
                                        phi_6728_ = _e1942;
                                    } else {
                                        phi_6728_ = _e1946;
                                    }
                                    let _e1949 = phi_6728_;
                                    if (_e1899 < 0.0lf) {
                                        phi_6734_ = -(_e1899);
                                    } else {
                                        phi_6734_ = _e1899;
                                    }
                                    let _e1953 = phi_6734_;
                                    if (_e1949 > _e1953) {
                                        phi_6739_ = _e1949;
                                    } else {
                                        phi_6739_ = _e1953;
                                    }
                                    let _e1956 = phi_6739_;
                                    local_4 = type_35(array<f64, 3>(_e1897, _e1898, _e1899), _e1938, (_e1956 + _e1938));
                                    let _e1961 = local_3.member;
                                    let _e1966 = local_4.member;
                                    let _e1972 = ((_e1961[1] * _e1966[2]) - (_e1961[2] * _e1966[1]));
                                    let _e1975 = ((_e1961[2] * _e1966[0]) - (_e1961[0] * _e1966[2]));
                                    let _e1978 = ((_e1961[0] * _e1966[1]) - (_e1961[1] * _e1966[0]));
                                    if (_e1972 < 0.0lf) {
                                        phi_6788_ = -(_e1972);
                                    } else {
                                        phi_6788_ = _e1972;
                                    }
                                    let _e1982 = phi_6788_;
                                    if (_e1975 < 0.0lf) {
                                        phi_6794_ = -(_e1975);
                                    } else {
                                        phi_6794_ = _e1975;
                                    }
                                    let _e1986 = phi_6794_;
                                    if (_e1982 > _e1986) {
                                        if (_e1972 < 0.0lf) {
                                            phi_6804_ = -(_e1972);
                                        } else {
                                            phi_6804_ = _e1972;
                                        }
                                        let _e2004 = phi_6804_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6810_ = -(_e1978);
                                        } else {
                                            phi_6810_ = _e1978;
                                        }
                                        let _e2008 = phi_6810_;
                                        if (_e2004 > _e2008) {
                                            phi_6815_ = 2u;
                                            phi_6816_ = 1u;
                                        } else {
                                            phi_6815_ = 1u;
                                            phi_6816_ = 0u;
                                        }
                                        let _e2011 = phi_6815_;
                                        let _e2013 = phi_6816_;
                                        phi_6835_ = _e2011;
                                        phi_6836_ = _e2013;
                                    } else {
                                        if (_e1975 < 0.0lf) {
                                            phi_6822_ = -(_e1975);
                                        } else {
                                            phi_6822_ = _e1975;
                                        }
                                        let _e1991 = phi_6822_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6828_ = -(_e1978);
                                        } else {
                                            phi_6828_ = _e1978;
                                        }
                                        let _e1995 = phi_6828_;
                                        if (_e1991 > _e1995) {
                                            phi_6833_ = 0u;
                                            phi_6834_ = 2u;
                                        } else {
                                            phi_6833_ = 1u;
                                            phi_6834_ = 0u;
                                        }
                                        let _e1998 = phi_6833_;
                                        let _e2000 = phi_6834_;
                                        phi_6835_ = _e1998;
                                        phi_6836_ = _e2000;
                                    }
                                    let _e2015 = phi_6835_;
                                    let _e2017 = phi_6836_;
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
                                        phi_6909_ = -(_e2032);
                                    } else {
                                        phi_6909_ = _e2032;
                                    }
                                    let _e2072 = phi_6909_;
                                    if (_e2072 > _e2068) {
                                        if (_e2032 < f64(0f)) {
                                            phi_6921_ = f64(-1f);
                                        } else {
                                            phi_6921_ = f64(1f);
                                        }
                                        let _e2079 = phi_6921_;
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
                                            phi_7064_ = -(_e2182);
                                        } else {
                                            phi_7064_ = _e2182;
                                        }
                                        let _e2188 = phi_7064_;
                                        if (_e2183 < 0.0lf) {
                                            phi_7070_ = -(_e2183);
                                        } else {
                                            phi_7070_ = _e2183;
                                        }
                                        let _e2192 = phi_7070_;
                                        if (_e2184 < 0.0lf) {
                                            phi_7077_ = -(_e2184);
                                        } else {
                                            phi_7077_ = _e2184;
                                        }
                                        let _e2197 = phi_7077_;
                                        let _e2203 = ((_e2182 - _e2183) - _e2184);
                                        let _e2206 = (((_e2068 + _e2130) + _e2181) + (((_e2188 + _e2192) + _e2197) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5 = array<type_36, 4>(type_36(_e2183, _e2130), type_36(_e2184, _e2181), type_36(_e2203, _e2206), type_36(_e2203, _e2206));
                                        phi_7133_ = type_12(0u, 4u);
                                        phi_7136_ = true;
                                        loop {
                                            let _e2213 = phi_7133_;
                                            let _e2215 = phi_7136_;
                                            local_17 = _e2215;
                                            if (_e2213.member < _e2213.member_1) {
                                                phi_7134_ = type_12((_e2213.member + 1u), _e2213.member_1);
                                                phi_7159_ = type_12(1u, _e2213.member);
                                            } else {
                                                phi_7134_ = _e2213;
                                                phi_7159_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e2227 = phi_7134_;
                                            let _e2229 = phi_7159_;
                                            if (bitcast<i32>(_e2229.member) != 0i) {
                                                let _e2236 = local_5[_e2229.member_1].member;
                                                let _e2239 = local_5[_e2229.member_1].member_1;
                                                let _e2241 = (_e2236 < -(_e2239));
                                                if _e2241 {
                                                    phi_7186_ = bool();
                                                    phi_7187_ = false;
                                                } else {
                                                    phi_7186_ = (_e2215 && (_e2236 > _e2239));
                                                    phi_7187_ = true;
                                                }
                                                let _e2245 = phi_7186_;
                                                let _e2247 = phi_7187_;
                                                phi_7137_ = _e2245;
                                                phi_7188_ = _e2247;
                                                phi_7189_ = _e2241;
                                            } else {
                                                phi_7137_ = bool();
                                                phi_7188_ = false;
                                                phi_7189_ = false;
                                            }
                                            let _e2249 = phi_7137_;
                                            let _e2251 = phi_7188_;
                                            let _e2253 = phi_7189_;
                                            local_16 = _e2253;
                                            continue;
                                            continuing {
                                                phi_7133_ = _e2227;
                                                phi_7136_ = _e2249;
                                                break if !(_e2251);
                                            }
                                        }
                                        let _e2256 = local_16;
                                        if _e2256 {
                                            phi_7193_ = false;
                                        } else {
                                            phi_7193_ = true;
                                        }
                                        let _e2258 = phi_7193_;
                                        if _e2258 {
                                            let _e2260 = local_17;
                                            if _e2260 {
                                                phi_7200_ = 1u;
                                            } else {
                                                phi_7200_ = 2u;
                                            }
                                            let _e2262 = phi_7200_;
                                            phi_7201_ = _e2262;
                                            phi_7202_ = false;
                                        } else {
                                            phi_7201_ = u32();
                                            phi_7202_ = true;
                                        }
                                        let _e2264 = phi_7201_;
                                        let _e2266 = phi_7202_;
                                        phi_7203_ = _e2264;
                                        phi_7204_ = 0u;
                                        phi_7205_ = _e2266;
                                    } else {
                                        phi_7203_ = u32();
                                        phi_7204_ = 2u;
                                        phi_7205_ = true;
                                    }
                                    let _e2268 = phi_7203_;
                                    let _e2270 = phi_7204_;
                                    let _e2272 = phi_7205_;
                                    if _e2272 {
                                        phi_7209_ = _e2270;
                                    } else {
                                        phi_7209_ = _e2268;
                                    }
                                    let _e2274 = phi_7209_;
                                    let _e2275 = (_e2274 == 0u);
                                    if _e2275 {
                                        phi_9967_ = f64();
                                        phi_9968_ = false;
                                        phi_9969_ = false;
                                        phi_9970_ = false;
                                    } else {
                                        if (_e2274 == 1u) {
                                            if _e1551.member_2 {
                                                if ((_e1551.member_1 - _e1551.member) <= f64(0.0000005f)) {
                                                    phi_7230_ = false;
                                                } else {
                                                    phi_7230_ = true;
                                                }
                                                let _e2284 = phi_7230_;
                                                phi_7231_ = _e2284;
                                            } else {
                                                phi_7231_ = true;
                                            }
                                            let _e2286 = phi_7231_;
                                            phi_7232_ = _e2286;
                                        } else {
                                            phi_7232_ = true;
                                        }
                                        let _e2288 = phi_7232_;
                                        if _e2288 {
                                            let _e2291 = f64(0f);
                                            let _e2294 = local_12.member[0u];
                                            let _e2300 = local_12.member_1[0u];
                                            let _e2306 = local_12.member_2[0u];
                                            let _e2318 = local_12.member[1u];
                                            let _e2324 = local_12.member_1[1u];
                                            let _e2330 = local_12.member_2[1u];
                                            let _e2342 = local_12.member[0u];
                                            if (_e2342[0] < 0.0lf) {
                                                phi_7381_ = -(_e2342[0]);
                                            } else {
                                                phi_7381_ = _e2342[0];
                                            }
                                            let _e2349 = phi_7381_;
                                            if (_e2342[1] < 0.0lf) {
                                                phi_7388_ = -(_e2342[1]);
                                            } else {
                                                phi_7388_ = _e2342[1];
                                            }
                                            let _e2353 = phi_7388_;
                                            if (_e2349 > _e2353) {
                                                phi_7393_ = _e2349;
                                            } else {
                                                phi_7393_ = _e2353;
                                            }
                                            let _e2356 = phi_7393_;
                                            if (_e2342[2] < 0.0lf) {
                                                phi_7400_ = -(_e2342[2]);
                                            } else {
                                                phi_7400_ = _e2342[2];
                                            }
                                            let _e2360 = phi_7400_;
                                            if (_e2356 > _e2360) {
                                                phi_7405_ = _e2356;
                                            } else {
                                                phi_7405_ = _e2360;
                                            }
                                            let _e2363 = phi_7405_;
                                            let _e2366 = local_12.member[1u];
                                            if (_e2366[0] < 0.0lf) {
                                                phi_7418_ = -(_e2366[0]);
                                            } else {
                                                phi_7418_ = _e2366[0];
                                            }
                                            let _e2373 = phi_7418_;
                                            if (_e2366[1] < 0.0lf) {
                                                phi_7425_ = -(_e2366[1]);
                                            } else {
                                                phi_7425_ = _e2366[1];
                                            }
                                            let _e2377 = phi_7425_;
                                            if (_e2373 > _e2377) {
                                                phi_7430_ = _e2373;
                                            } else {
                                                phi_7430_ = _e2377;
                                            }
                                            let _e2380 = phi_7430_;
                                            if (_e2366[2] < 0.0lf) {
                                                phi_7437_ = -(_e2366[2]);
                                            } else {
                                                phi_7437_ = _e2366[2];
                                            }
                                            let _e2384 = phi_7437_;
                                            if (_e2380 > _e2384) {
                                                phi_7442_ = _e2380;
                                            } else {
                                                phi_7442_ = _e2384;
                                            }
                                            let _e2387 = phi_7442_;
                                            if (_e2363 > _e2387) {
                                                phi_7447_ = _e2363;
                                            } else {
                                                phi_7447_ = _e2387;
                                            }
                                            let _e2390 = phi_7447_;
                                            let _e2392 = local_12.member_3;
                                            let _e2396 = local_12.member_1[0u];
                                            if (_e2396[0] < 0.0lf) {
                                                phi_7464_ = -(_e2396[0]);
                                            } else {
                                                phi_7464_ = _e2396[0];
                                            }
                                            let _e2403 = phi_7464_;
                                            if (_e2396[1] < 0.0lf) {
                                                phi_7471_ = -(_e2396[1]);
                                            } else {
                                                phi_7471_ = _e2396[1];
                                            }
                                            let _e2407 = phi_7471_;
                                            if (_e2403 > _e2407) {
                                                phi_7476_ = _e2403;
                                            } else {
                                                phi_7476_ = _e2407;
                                            }
                                            let _e2410 = phi_7476_;
                                            if (_e2396[2] < 0.0lf) {
                                                phi_7483_ = -(_e2396[2]);
                                            } else {
                                                phi_7483_ = _e2396[2];
                                            }
                                            let _e2414 = phi_7483_;
                                            if (_e2410 > _e2414) {
                                                phi_7488_ = _e2410;
                                            } else {
                                                phi_7488_ = _e2414;
                                            }
                                            let _e2417 = phi_7488_;
                                            let _e2420 = local_12.member_1[1u];
                                            if (_e2420[0] < 0.0lf) {
                                                phi_7502_ = -(_e2420[0]);
                                            } else {
                                                phi_7502_ = _e2420[0];
                                            }
                                            let _e2427 = phi_7502_;
                                            if (_e2420[1] < 0.0lf) {
                                                phi_7509_ = -(_e2420[1]);
                                            } else {
                                                phi_7509_ = _e2420[1];
                                            }
                                            let _e2431 = phi_7509_;
                                            if (_e2427 > _e2431) {
                                                phi_7514_ = _e2427;
                                            } else {
                                                phi_7514_ = _e2431;
                                            }
                                            let _e2434 = phi_7514_;
                                            if (_e2420[2] < 0.0lf) {
                                                phi_7521_ = -(_e2420[2]);
                                            } else {
                                                phi_7521_ = _e2420[2];
                                            }
                                            let _e2438 = phi_7521_;
                                            if (_e2434 > _e2438) {
                                                phi_7526_ = _e2434;
                                            } else {
                                                phi_7526_ = _e2438;
                                            }
                                            let _e2441 = phi_7526_;
                                            if (_e2417 > _e2441) {
                                                phi_7531_ = _e2417;
                                            } else {
                                                phi_7531_ = _e2441;
                                            }
                                            let _e2444 = phi_7531_;
                                            let _e2446 = local_12.member_3;
                                            let _e2450 = local_12.member_2[0u];
                                            if (_e2450[0] < 0.0lf) {
                                                phi_7548_ = -(_e2450[0]);
                                            } else {
                                                phi_7548_ = _e2450[0];
                                            }
                                            let _e2457 = phi_7548_;
                                            if (_e2450[1] < 0.0lf) {
                                                phi_7555_ = -(_e2450[1]);
                                            } else {
                                                phi_7555_ = _e2450[1];
                                            }
                                            let _e2461 = phi_7555_;
                                            if (_e2457 > _e2461) {
                                                phi_7560_ = _e2457;
                                            } else {
                                                phi_7560_ = _e2461;
                                            }
                                            let _e2464 = phi_7560_;
                                            if (_e2450[2] < 0.0lf) {
                                                phi_7567_ = -(_e2450[2]);
                                            } else {
                                                phi_7567_ = _e2450[2];
                                            }
                                            let _e2468 = phi_7567_;
                                            if (_e2464 > _e2468) {
                                                phi_7572_ = _e2464;
                                            } else {
                                                phi_7572_ = _e2468;
                                            }
                                            let _e2471 = phi_7572_;
                                            let _e2474 = local_12.member_2[1u];
                                            if (_e2474[0] < 0.0lf) {
                                                phi_7586_ = -(_e2474[0]);
                                            } else {
                                                phi_7586_ = _e2474[0];
                                            }
                                            let _e2481 = phi_7586_;
                                            if (_e2474[1] < 0.0lf) {
                                                phi_7593_ = -(_e2474[1]);
                                            } else {
                                                phi_7593_ = _e2474[1];
                                            }
                                            let _e2485 = phi_7593_;
                                            if (_e2481 > _e2485) {
                                                phi_7598_ = _e2481;
                                            } else {
                                                phi_7598_ = _e2485;
                                            }
                                            let _e2488 = phi_7598_;
                                            if (_e2474[2] < 0.0lf) {
                                                phi_7605_ = -(_e2474[2]);
                                            } else {
                                                phi_7605_ = _e2474[2];
                                            }
                                            let _e2492 = phi_7605_;
                                            if (_e2488 > _e2492) {
                                                phi_7610_ = _e2488;
                                            } else {
                                                phi_7610_ = _e2492;
                                            }
                                            let _e2495 = phi_7610_;
                                            if (_e2471 > _e2495) {
                                                phi_7615_ = _e2471;
                                            } else {
                                                phi_7615_ = _e2495;
                                            }
                                            let _e2498 = phi_7615_;
                                            let _e2500 = local_12.member_3;
                                            let _e2508 = local_12.member_3;
                                            let _e2515 = f64(0f);
                                            let _e2516 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2515, _e2515, _e2515, _e2515), array<f64, 4>(_e2515, _e2515, _e2515, _e2515), array<f64, 4>(_e2516, _e2516, _e2516, _e2516));
                                            phi_7660_ = type_12(0u, 96u);
                                            phi_7663_ = _e1551.member;
                                            phi_7665_ = _e1551.member;
                                            phi_7667_ = (_e1551.member_1 - _e1551.member);
                                            phi_7669_ = _e1551.member;
                                            phi_7671_ = false;
                                            phi_7673_ = 0u;
                                            loop {
                                                let _e2523 = phi_7660_;
                                                let _e2525 = phi_7663_;
                                                let _e2527 = phi_7665_;
                                                let _e2529 = phi_7667_;
                                                let _e2531 = phi_7669_;
                                                let _e2533 = phi_7671_;
                                                let _e2535 = phi_7673_;
                                                local_21 = _e2525;
                                                local_45 = _e2527;
                                                if (_e2523.member < _e2523.member_1) {
                                                    phi_7661_ = type_12((_e2523.member + 1u), _e2523.member_1);
                                                    phi_7696_ = type_12(1u, _e2523.member);
                                                } else {
                                                    phi_7661_ = _e2523;
                                                    phi_7696_ = type_12(0u, type_12().member_1);
                                                }
                                                let _e2547 = phi_7661_;
                                                let _e2549 = phi_7696_;
                                                if (bitcast<i32>(_e2549.member) != 0i) {
                                                    let _e2555 = local_12.member[0u];
                                                    let _e2561 = local_12.member[1u];
                                                    let _e2577 = local_12.member_1[0u];
                                                    let _e2583 = local_12.member_1[1u];
                                                    let _e2599 = local_12.member_2[0u];
                                                    let _e2605 = local_12.member_2[1u];
                                                    let _e2619 = function_2(array<f64, 3>((_e2555[0] + ((_e2561[0] - _e2555[0]) * _e2525)), (_e2555[1] + ((_e2561[1] - _e2555[1]) * _e2525)), (_e2555[2] + ((_e2561[2] - _e2555[2]) * _e2525))), array<f64, 3>((_e2577[0] + ((_e2583[0] - _e2577[0]) * _e2525)), (_e2577[1] + ((_e2583[1] - _e2577[1]) * _e2525)), (_e2577[2] + ((_e2583[2] - _e2577[2]) * _e2525))), array<f64, 3>((_e2599[0] + ((_e2605[0] - _e2599[0]) * _e2525)), (_e2599[1] + ((_e2605[1] - _e2599[1]) * _e2525)), (_e2599[2] + ((_e2605[2] - _e2599[2]) * _e2525))), 0u);
                                                    if (_e2535 == 0u) {
                                                        phi_7825_ = _e2619;
                                                    } else {
                                                        let _e2621 = f64(0f);
                                                        if (_e2535 == 1u) {
                                                            phi_7811_ = _e2619[0];
                                                        } else {
                                                            phi_7811_ = _e2621;
                                                        }
                                                        let _e2625 = phi_7811_;
                                                        if (_e2535 == 2u) {
                                                            phi_7817_ = _e2619[1];
                                                        } else {
                                                            phi_7817_ = _e2621;
                                                        }
                                                        let _e2629 = phi_7817_;
                                                        if (_e2535 == 3u) {
                                                            phi_7823_ = _e2619[2];
                                                        } else {
                                                            phi_7823_ = _e2621;
                                                        }
                                                        let _e2633 = phi_7823_;
                                                        phi_7825_ = array<f64, 3>(_e2625, _e2629, _e2633);
                                                    }
                                                    let _e2636 = phi_7825_;
                                                    if (_e2636[0] < 0.0lf) {
                                                        phi_7832_ = -(_e2636[0]);
                                                    } else {
                                                        phi_7832_ = _e2636[0];
                                                    }
                                                    let _e2641 = phi_7832_;
                                                    if (_e2636[1] < 0.0lf) {
                                                        phi_7839_ = -(_e2636[1]);
                                                    } else {
                                                        phi_7839_ = _e2636[1];
                                                    }
                                                    let _e2646 = phi_7839_;
                                                    if (_e2636[2] < 0.0lf) {
                                                        phi_7847_ = -(_e2636[2]);
                                                    } else {
                                                        phi_7847_ = _e2636[2];
                                                    }
                                                    let _e2652 = phi_7847_;
                                                    let _e2653 = ((_e2641 + _e2646) + _e2652);
                                                    if (_e2653 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2653) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2660 = (f64(1f) / _e2653);
                                                            let _e2662 = (_e2636[0] * _e2660);
                                                            let _e2664 = (_e2636[1] * _e2660);
                                                            let _e2666 = (_e2636[2] * _e2660);
                                                            let _e2671 = (((_e2662 * _e2662) + (_e2664 * _e2664)) + (_e2666 * _e2666));
                                                            if (_e2671 <= 2.2250738585072014e-308lf) {
                                                                if (_e2671 > 0.0lf) {
                                                                    phi_7886_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7886_ = 0.0lf;
                                                                }
                                                                let _e2723 = phi_7886_;
                                                                phi_7950_ = _e2723;
                                                            } else {
                                                                phi_7893_ = type_16(0i, 5i);
                                                                phi_7896_ = bitcast<f64>(((bitcast<u64>(_e2671) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2678 = phi_7893_;
                                                                    let _e2680 = phi_7896_;
                                                                    local_18 = _e2680;
                                                                    if (_e2678.member < _e2678.member_1) {
                                                                        let _e2687 = (_e2678.member + 1i);
                                                                        if ((false == (_e2687 > _e2678.member)) != false) {
                                                                            phi_7917_ = true;
                                                                        } else {
                                                                            phi_7917_ = false;
                                                                        }
                                                                        let _e2692 = phi_7917_;
                                                                        if _e2692 {
                                                                            phi_7923_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_7923_ = type_17(1u, _e2687);
                                                                        }
                                                                        let _e2697 = phi_7923_;
                                                                        phi_7894_ = type_16(_e2697.member_1, _e2678.member_1);
                                                                        phi_7937_ = type_17(1u, _e2678.member);
                                                                    } else {
                                                                        phi_7894_ = _e2678;
                                                                        phi_7937_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2703 = phi_7894_;
                                                                    let _e2705 = phi_7937_;
                                                                    let _e2708 = (bitcast<i32>(_e2705.member) != 0i);
                                                                    if _e2708 {
                                                                        phi_7897_ = (0.5lf * (_e2680 + (_e2671 / _e2680)));
                                                                    } else {
                                                                        phi_7897_ = f64();
                                                                    }
                                                                    let _e2713 = phi_7897_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7893_ = _e2703;
                                                                        phi_7896_ = _e2713;
                                                                        break if !(_e2708);
                                                                    }
                                                                }
                                                                let _e2718 = local_18;
                                                                phi_7950_ = (_e2718 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2725 = phi_7950_;
                                                            let _e2727 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2734 = ((((((((_e2390 + _e2392) + (_e2444 + _e2446)) + (_e2498 + _e2500)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2508 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e2291 * _e2725) * (f64(1f) + _e2727)));
                                                            let _e2739 = (((_e2662 * _e2294[0]) + (_e2664 * _e2294[1])) + (_e2666 * _e2294[2]));
                                                            let _e2744 = (((_e2662 * (_e2294[0] - _e2300[0])) + (_e2664 * (_e2294[1] - _e2300[1]))) + (_e2666 * (_e2294[2] - _e2300[2])));
                                                            let _e2749 = (((_e2662 * (_e2294[0] - _e2306[0])) + (_e2664 * (_e2294[1] - _e2306[1]))) + (_e2666 * (_e2294[2] - _e2306[2])));
                                                            let _e2754 = (((_e2662 * _e2294[0]) + (_e2664 * _e2294[1])) + (_e2666 * _e2294[2]));
                                                            let _e2760 = (((_e2662 * _e2318[0]) + (_e2664 * _e2318[1])) + (_e2666 * _e2318[2]));
                                                            let _e2765 = (((_e2662 * (_e2318[0] - _e2324[0])) + (_e2664 * (_e2318[1] - _e2324[1]))) + (_e2666 * (_e2318[2] - _e2324[2])));
                                                            let _e2770 = (((_e2662 * (_e2318[0] - _e2330[0])) + (_e2664 * (_e2318[1] - _e2330[1]))) + (_e2666 * (_e2318[2] - _e2330[2])));
                                                            let _e2775 = (((_e2662 * _e2318[0]) + (_e2664 * _e2318[1])) + (_e2666 * _e2318[2]));
                                                            if (_e2739 < 0.0lf) {
                                                                phi_8019_ = -(_e2739);
                                                            } else {
                                                                phi_8019_ = _e2739;
                                                            }
                                                            let _e2780 = phi_8019_;
                                                            if (_e2760 < 0.0lf) {
                                                                phi_8025_ = -(_e2760);
                                                            } else {
                                                                phi_8025_ = _e2760;
                                                            }
                                                            let _e2784 = phi_8025_;
                                                            if (_e2744 < 0.0lf) {
                                                                phi_8034_ = -(_e2744);
                                                            } else {
                                                                phi_8034_ = _e2744;
                                                            }
                                                            let _e2791 = phi_8034_;
                                                            if (_e2765 < 0.0lf) {
                                                                phi_8040_ = -(_e2765);
                                                            } else {
                                                                phi_8040_ = _e2765;
                                                            }
                                                            let _e2795 = phi_8040_;
                                                            if (_e2749 < 0.0lf) {
                                                                phi_8049_ = -(_e2749);
                                                            } else {
                                                                phi_8049_ = _e2749;
                                                            }
                                                            let _e2802 = phi_8049_;
                                                            if (_e2770 < 0.0lf) {
                                                                phi_8055_ = -(_e2770);
                                                            } else {
                                                                phi_8055_ = _e2770;
                                                            }
                                                            let _e2806 = phi_8055_;
                                                            if (_e2754 < 0.0lf) {
                                                                phi_8064_ = -(_e2754);
                                                            } else {
                                                                phi_8064_ = _e2754;
                                                            }
                                                            let _e2813 = phi_8064_;
                                                            if (_e2775 < 0.0lf) {
                                                                phi_8070_ = -(_e2775);
                                                            } else {
                                                                phi_8070_ = _e2775;
                                                            }
                                                            let _e2817 = phi_8070_;
                                                            phi_8076_ = type_34(array<f64, 4>(_e2739, _e2744, _e2749, _e2754), array<f64, 4>(_e2760, _e2765, _e2770, _e2775), array<f64, 4>((_e2734 + ((_e2780 + _e2784) * _e2727)), (_e2734 + ((_e2791 + _e2795) * _e2727)), (_e2734 + ((_e2802 + _e2806) * _e2727)), (_e2734 + ((_e2813 + _e2817) * _e2727))));
                                                            phi_8077_ = false;
                                                        } else {
                                                            phi_8076_ = type_34();
                                                            phi_8077_ = true;
                                                        }
                                                        let _e2824 = phi_8076_;
                                                        let _e2826 = phi_8077_;
                                                        phi_8078_ = _e2824;
                                                        phi_8079_ = _e2826;
                                                    } else {
                                                        phi_8078_ = type_34();
                                                        phi_8079_ = true;
                                                    }
                                                    let _e2828 = phi_8078_;
                                                    let _e2830 = phi_8079_;
                                                    if _e2830 {
                                                        let _e2831 = f64(0f);
                                                        let _e2832 = f64(1f);
                                                        phi_8089_ = type_34(array<f64, 4>(_e2831, _e2831, _e2831, _e2831), array<f64, 4>(_e2831, _e2831, _e2831, _e2831), array<f64, 4>(_e2832, _e2832, _e2832, _e2832));
                                                    } else {
                                                        phi_8089_ = _e2828;
                                                    }
                                                    let _e2838 = phi_8089_;
                                                    local_1 = type_34(array<f64, 4>(_e2838.member[0], _e2838.member[1], _e2838.member[2], _e2838.member[3]), array<f64, 4>(_e2838.member_1[0], _e2838.member_1[1], _e2838.member_1[2], _e2838.member_1[3]), array<f64, 4>(_e2838.member_2[0], _e2838.member_2[1], _e2838.member_2[2], _e2838.member_2[3]));
                                                    let _e2858 = (_e2525 - _e2531);
                                                    let _e2860 = f64(0f);
                                                    let _e2863 = local_1.member[0u];
                                                    let _e2866 = local_1.member_1[0u];
                                                    let _e2869 = local_1.member[0u];
                                                    let _e2875 = local_1.member_2[0u];
                                                    if (((_e2863 + ((_e2866 - _e2869) * _e2525)) - _e2875) > _e2860) {
                                                        let _e2880 = local_1.member[1u];
                                                        let _e2883 = local_1.member_1[1u];
                                                        let _e2886 = local_1.member[1u];
                                                        let _e2892 = local_1.member_2[1u];
                                                        if (((_e2880 + ((_e2883 - _e2886) * _e2525)) - _e2892) > _e2860) {
                                                            let _e2897 = local_1.member[2u];
                                                            let _e2900 = local_1.member_1[2u];
                                                            let _e2903 = local_1.member[2u];
                                                            let _e2909 = local_1.member_2[2u];
                                                            if (((_e2897 + ((_e2900 - _e2903) * _e2525)) - _e2909) > _e2860) {
                                                                let _e2914 = local_1.member[3u];
                                                                let _e2917 = local_1.member_1[3u];
                                                                let _e2920 = local_1.member[3u];
                                                                let _e2926 = local_1.member_2[3u];
                                                                phi_8261_ = (((_e2914 + ((_e2917 - _e2920) * _e2525)) - _e2926) > _e2860);
                                                                phi_8262_ = false;
                                                            } else {
                                                                phi_8261_ = bool();
                                                                phi_8262_ = true;
                                                            }
                                                            let _e2930 = phi_8261_;
                                                            let _e2932 = phi_8262_;
                                                            phi_8263_ = _e2930;
                                                            phi_8264_ = _e2932;
                                                        } else {
                                                            phi_8263_ = bool();
                                                            phi_8264_ = true;
                                                        }
                                                        let _e2934 = phi_8263_;
                                                        let _e2936 = phi_8264_;
                                                        phi_8265_ = _e2934;
                                                        phi_8266_ = _e2936;
                                                    } else {
                                                        phi_8265_ = bool();
                                                        phi_8266_ = true;
                                                    }
                                                    let _e2938 = phi_8265_;
                                                    let _e2940 = phi_8266_;
                                                    if _e2940 {
                                                        phi_8270_ = false;
                                                    } else {
                                                        phi_8270_ = _e2938;
                                                    }
                                                    let _e2942 = phi_8270_;
                                                    if _e2942 {
                                                        if (_e2525 <= _e2527) {
                                                            phi_8581_ = true;
                                                        } else {
                                                            let _e2944 = f64(0f);
                                                            let _e2947 = local.member[0u];
                                                            let _e2950 = local.member_1[0u];
                                                            let _e2953 = local.member[0u];
                                                            let _e2959 = local.member_2[0u];
                                                            let _e2963 = local_1.member[0u];
                                                            let _e2966 = local_1.member_1[0u];
                                                            let _e2969 = local_1.member[0u];
                                                            let _e2975 = local_1.member_2[0u];
                                                            if ((((_e2947 + ((_e2950 - _e2953) * _e2525)) - _e2959) + ((_e2963 + ((_e2966 - _e2969) * _e2531)) - _e2975)) > _e2944) {
                                                                let _e2981 = local.member[1u];
                                                                let _e2984 = local.member_1[1u];
                                                                let _e2987 = local.member[1u];
                                                                let _e2993 = local.member_2[1u];
                                                                let _e2997 = local_1.member[1u];
                                                                let _e3000 = local_1.member_1[1u];
                                                                let _e3003 = local_1.member[1u];
                                                                let _e3009 = local_1.member_2[1u];
                                                                if ((((_e2981 + ((_e2984 - _e2987) * _e2525)) - _e2993) + ((_e2997 + ((_e3000 - _e3003) * _e2531)) - _e3009)) > _e2944) {
                                                                    let _e3015 = local.member[2u];
                                                                    let _e3018 = local.member_1[2u];
                                                                    let _e3021 = local.member[2u];
                                                                    let _e3027 = local.member_2[2u];
                                                                    let _e3031 = local_1.member[2u];
                                                                    let _e3034 = local_1.member_1[2u];
                                                                    let _e3037 = local_1.member[2u];
                                                                    let _e3043 = local_1.member_2[2u];
                                                                    if ((((_e3015 + ((_e3018 - _e3021) * _e2525)) - _e3027) + ((_e3031 + ((_e3034 - _e3037) * _e2531)) - _e3043)) > _e2944) {
                                                                        let _e3049 = local.member[3u];
                                                                        let _e3052 = local.member_1[3u];
                                                                        let _e3055 = local.member[3u];
                                                                        let _e3061 = local.member_2[3u];
                                                                        let _e3065 = local_1.member[3u];
                                                                        let _e3068 = local_1.member_1[3u];
                                                                        let _e3071 = local_1.member[3u];
                                                                        let _e3077 = local_1.member_2[3u];
                                                                        phi_8568_ = ((((_e3049 + ((_e3052 - _e3055) * _e2525)) - _e3061) + ((_e3065 + ((_e3068 - _e3071) * _e2531)) - _e3077)) > _e2944);
                                                                        phi_8569_ = false;
                                                                    } else {
                                                                        phi_8568_ = bool();
                                                                        phi_8569_ = true;
                                                                    }
                                                                    let _e3082 = phi_8568_;
                                                                    let _e3084 = phi_8569_;
                                                                    phi_8570_ = _e3082;
                                                                    phi_8571_ = _e3084;
                                                                } else {
                                                                    phi_8570_ = bool();
                                                                    phi_8571_ = true;
                                                                }
                                                                let _e3086 = phi_8570_;
                                                                let _e3088 = phi_8571_;
                                                                phi_8572_ = _e3086;
                                                                phi_8573_ = _e3088;
                                                            } else {
                                                                phi_8572_ = bool();
                                                                phi_8573_ = true;
                                                            }
                                                            let _e3090 = phi_8572_;
                                                            let _e3092 = phi_8573_;
                                                            if _e3092 {
                                                                phi_8577_ = false;
                                                            } else {
                                                                phi_8577_ = _e3090;
                                                            }
                                                            let _e3094 = phi_8577_;
                                                            phi_8581_ = _e3094;
                                                        }
                                                        let _e3096 = phi_8581_;
                                                        if _e3096 {
                                                            if _e2533 {
                                                                if (_e2525 >= _e1551.member_1) {
                                                                    phi_8592_ = false;
                                                                } else {
                                                                    phi_8592_ = true;
                                                                }
                                                                let _e3099 = phi_8592_;
                                                                phi_8593_ = _e3099;
                                                            } else {
                                                                phi_8593_ = true;
                                                            }
                                                            let _e3101 = phi_8593_;
                                                            if _e3101 {
                                                                local = type_34(array<f64, 4>(_e2838.member[0], _e2838.member[1], _e2838.member[2], _e2838.member[3]), array<f64, 4>(_e2838.member_1[0], _e2838.member_1[1], _e2838.member_1[2], _e2838.member_1[3]), array<f64, 4>(_e2838.member_2[0], _e2838.member_2[1], _e2838.member_2[2], _e2838.member_2[3]));
                                                                let _e3123 = local.member[0u];
                                                                let _e3126 = local.member_1[0u];
                                                                let _e3129 = local.member_2[0u];
                                                                if (_e3123 > _e3129) {
                                                                    if (_e3126 > _e3129) {
                                                                        phi_8667_ = false;
                                                                    } else {
                                                                        phi_8667_ = true;
                                                                    }
                                                                    let _e3133 = phi_8667_;
                                                                    phi_8668_ = _e3133;
                                                                } else {
                                                                    phi_8668_ = true;
                                                                }
                                                                let _e3135 = phi_8668_;
                                                                if _e3135 {
                                                                    let _e3136 = (_e3126 >= _e3123);
                                                                    if _e3136 {
                                                                        phi_8693_ = f64();
                                                                        phi_8694_ = false;
                                                                    } else {
                                                                        if ((_e3123 - _e3126) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8691_ = (((_e3123 - _e3129) / (_e3123 - _e3126)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8692_ = false;
                                                                        } else {
                                                                            phi_8691_ = f64();
                                                                            phi_8692_ = true;
                                                                        }
                                                                        let _e3150 = phi_8691_;
                                                                        let _e3152 = phi_8692_;
                                                                        phi_8693_ = _e3150;
                                                                        phi_8694_ = _e3152;
                                                                    }
                                                                    let _e3154 = phi_8693_;
                                                                    let _e3156 = phi_8694_;
                                                                    phi_8695_ = _e3154;
                                                                    phi_8696_ = _e3136;
                                                                    phi_8697_ = _e3156;
                                                                } else {
                                                                    phi_8695_ = f64();
                                                                    phi_8696_ = true;
                                                                    phi_8697_ = false;
                                                                }
                                                                let _e3158 = phi_8695_;
                                                                let _e3160 = phi_8696_;
                                                                let _e3162 = phi_8697_;
                                                                if _e3160 {
                                                                    phi_8702_ = f64(2f);
                                                                    phi_8703_ = true;
                                                                } else {
                                                                    phi_8702_ = _e2525;
                                                                    phi_8703_ = _e3162;
                                                                }
                                                                let _e3165 = phi_8702_;
                                                                let _e3167 = phi_8703_;
                                                                if _e3167 {
                                                                    phi_8707_ = _e3165;
                                                                } else {
                                                                    phi_8707_ = _e3158;
                                                                }
                                                                let _e3169 = phi_8707_;
                                                                let _e3172 = local.member[1u];
                                                                let _e3175 = local.member_1[1u];
                                                                let _e3178 = local.member_2[1u];
                                                                if (_e3172 > _e3178) {
                                                                    if (_e3175 > _e3178) {
                                                                        phi_8739_ = false;
                                                                    } else {
                                                                        phi_8739_ = true;
                                                                    }
                                                                    let _e3182 = phi_8739_;
                                                                    phi_8740_ = _e3182;
                                                                } else {
                                                                    phi_8740_ = true;
                                                                }
                                                                let _e3184 = phi_8740_;
                                                                if _e3184 {
                                                                    let _e3185 = (_e3175 >= _e3172);
                                                                    if _e3185 {
                                                                        phi_8765_ = f64();
                                                                        phi_8766_ = false;
                                                                    } else {
                                                                        if ((_e3172 - _e3175) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8763_ = (((_e3172 - _e3178) / (_e3172 - _e3175)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8764_ = false;
                                                                        } else {
                                                                            phi_8763_ = f64();
                                                                            phi_8764_ = true;
                                                                        }
                                                                        let _e3199 = phi_8763_;
                                                                        let _e3201 = phi_8764_;
                                                                        phi_8765_ = _e3199;
                                                                        phi_8766_ = _e3201;
                                                                    }
                                                                    let _e3203 = phi_8765_;
                                                                    let _e3205 = phi_8766_;
                                                                    phi_8767_ = _e3203;
                                                                    phi_8768_ = _e3185;
                                                                    phi_8769_ = _e3205;
                                                                } else {
                                                                    phi_8767_ = f64();
                                                                    phi_8768_ = true;
                                                                    phi_8769_ = false;
                                                                }
                                                                let _e3207 = phi_8767_;
                                                                let _e3209 = phi_8768_;
                                                                let _e3211 = phi_8769_;
                                                                if _e3209 {
                                                                    phi_8774_ = f64(2f);
                                                                    phi_8775_ = true;
                                                                } else {
                                                                    phi_8774_ = _e2525;
                                                                    phi_8775_ = _e3211;
                                                                }
                                                                let _e3214 = phi_8774_;
                                                                let _e3216 = phi_8775_;
                                                                if _e3216 {
                                                                    phi_8779_ = _e3214;
                                                                } else {
                                                                    phi_8779_ = _e3207;
                                                                }
                                                                let _e3218 = phi_8779_;
                                                                if (_e3169 < _e3218) {
                                                                    phi_8784_ = _e3169;
                                                                } else {
                                                                    phi_8784_ = _e3218;
                                                                }
                                                                let _e3221 = phi_8784_;
                                                                let _e3224 = local.member[2u];
                                                                let _e3227 = local.member_1[2u];
                                                                let _e3230 = local.member_2[2u];
                                                                if (_e3224 > _e3230) {
                                                                    if (_e3227 > _e3230) {
                                                                        phi_8816_ = false;
                                                                    } else {
                                                                        phi_8816_ = true;
                                                                    }
                                                                    let _e3234 = phi_8816_;
                                                                    phi_8817_ = _e3234;
                                                                } else {
                                                                    phi_8817_ = true;
                                                                }
                                                                let _e3236 = phi_8817_;
                                                                if _e3236 {
                                                                    let _e3237 = (_e3227 >= _e3224);
                                                                    if _e3237 {
                                                                        phi_8842_ = f64();
                                                                        phi_8843_ = false;
                                                                    } else {
                                                                        if ((_e3224 - _e3227) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8840_ = (((_e3224 - _e3230) / (_e3224 - _e3227)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8841_ = false;
                                                                        } else {
                                                                            phi_8840_ = f64();
                                                                            phi_8841_ = true;
                                                                        }
                                                                        let _e3251 = phi_8840_;
                                                                        let _e3253 = phi_8841_;
                                                                        phi_8842_ = _e3251;
                                                                        phi_8843_ = _e3253;
                                                                    }
                                                                    let _e3255 = phi_8842_;
                                                                    let _e3257 = phi_8843_;
                                                                    phi_8844_ = _e3255;
                                                                    phi_8845_ = _e3237;
                                                                    phi_8846_ = _e3257;
                                                                } else {
                                                                    phi_8844_ = f64();
                                                                    phi_8845_ = true;
                                                                    phi_8846_ = false;
                                                                }
                                                                let _e3259 = phi_8844_;
                                                                let _e3261 = phi_8845_;
                                                                let _e3263 = phi_8846_;
                                                                if _e3261 {
                                                                    phi_8851_ = f64(2f);
                                                                    phi_8852_ = true;
                                                                } else {
                                                                    phi_8851_ = _e2525;
                                                                    phi_8852_ = _e3263;
                                                                }
                                                                let _e3266 = phi_8851_;
                                                                let _e3268 = phi_8852_;
                                                                if _e3268 {
                                                                    phi_8856_ = _e3266;
                                                                } else {
                                                                    phi_8856_ = _e3259;
                                                                }
                                                                let _e3270 = phi_8856_;
                                                                let _e3273 = local.member[3u];
                                                                let _e3276 = local.member_1[3u];
                                                                let _e3279 = local.member_2[3u];
                                                                if (_e3273 > _e3279) {
                                                                    if (_e3276 > _e3279) {
                                                                        phi_8888_ = false;
                                                                    } else {
                                                                        phi_8888_ = true;
                                                                    }
                                                                    let _e3283 = phi_8888_;
                                                                    phi_8889_ = _e3283;
                                                                } else {
                                                                    phi_8889_ = true;
                                                                }
                                                                let _e3285 = phi_8889_;
                                                                if _e3285 {
                                                                    let _e3286 = (_e3276 >= _e3273);
                                                                    if _e3286 {
                                                                        phi_8914_ = f64();
                                                                        phi_8915_ = false;
                                                                    } else {
                                                                        if ((_e3273 - _e3276) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8912_ = (((_e3273 - _e3279) / (_e3273 - _e3276)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8913_ = false;
                                                                        } else {
                                                                            phi_8912_ = f64();
                                                                            phi_8913_ = true;
                                                                        }
                                                                        let _e3300 = phi_8912_;
                                                                        let _e3302 = phi_8913_;
                                                                        phi_8914_ = _e3300;
                                                                        phi_8915_ = _e3302;
                                                                    }
                                                                    let _e3304 = phi_8914_;
                                                                    let _e3306 = phi_8915_;
                                                                    phi_8916_ = _e3304;
                                                                    phi_8917_ = _e3286;
                                                                    phi_8918_ = _e3306;
                                                                } else {
                                                                    phi_8916_ = f64();
                                                                    phi_8917_ = true;
                                                                    phi_8918_ = false;
                                                                }
                                                                let _e3308 = phi_8916_;
                                                                let _e3310 = phi_8917_;
                                                                let _e3312 = phi_8918_;
                                                                if _e3310 {
                                                                    phi_8923_ = f64(2f);
                                                                    phi_8924_ = true;
                                                                } else {
                                                                    phi_8923_ = _e2525;
                                                                    phi_8924_ = _e3312;
                                                                }
                                                                let _e3315 = phi_8923_;
                                                                let _e3317 = phi_8924_;
                                                                if _e3317 {
                                                                    phi_8928_ = _e3315;
                                                                } else {
                                                                    phi_8928_ = _e3308;
                                                                }
                                                                let _e3319 = phi_8928_;
                                                                if (_e3270 < _e3319) {
                                                                    phi_8933_ = _e3270;
                                                                } else {
                                                                    phi_8933_ = _e3319;
                                                                }
                                                                let _e3322 = phi_8933_;
                                                                if (_e3221 < _e3322) {
                                                                    phi_8938_ = _e3221;
                                                                } else {
                                                                    phi_8938_ = _e3322;
                                                                }
                                                                let _e3325 = phi_8938_;
                                                                if (_e3325 > _e2525) {
                                                                    phi_8943_ = _e3325;
                                                                } else {
                                                                    phi_8943_ = _e2525;
                                                                }
                                                                let _e3328 = phi_8943_;
                                                                let _e3329 = (_e3328 > _e1551.member_1);
                                                                if _e3329 {
                                                                    phi_9460_ = f64();
                                                                    phi_9461_ = f64();
                                                                    phi_9462_ = false;
                                                                    phi_9463_ = false;
                                                                } else {
                                                                    let _e3330 = (_e3328 - _e2525);
                                                                    let _e3332 = (_e3330 <= f64(0.0000000037252903f));
                                                                    let _e3334 = (_e3328 + f64(0.00000001f));
                                                                    if (_e3334 < _e1551.member_1) {
                                                                        phi_8957_ = _e3334;
                                                                    } else {
                                                                        phi_8957_ = _e1551.member_1;
                                                                    }
                                                                    let _e3337 = phi_8957_;
                                                                    if _e3332 {
                                                                        if (_e2291 > f64(0f)) {
                                                                            let _e3342 = local_12.member[0u];
                                                                            let _e3348 = local_12.member[1u];
                                                                            let _e3364 = local_12.member_1[0u];
                                                                            let _e3370 = local_12.member_1[1u];
                                                                            let _e3386 = local_12.member_2[0u];
                                                                            let _e3392 = local_12.member_2[1u];
                                                                            let _e3406 = function_2(array<f64, 3>((_e3342[0] + ((_e3348[0] - _e3342[0]) * _e3337)), (_e3342[1] + ((_e3348[1] - _e3342[1]) * _e3337)), (_e3342[2] + ((_e3348[2] - _e3342[2]) * _e3337))), array<f64, 3>((_e3364[0] + ((_e3370[0] - _e3364[0]) * _e3337)), (_e3364[1] + ((_e3370[1] - _e3364[1]) * _e3337)), (_e3364[2] + ((_e3370[2] - _e3364[2]) * _e3337))), array<f64, 3>((_e3386[0] + ((_e3392[0] - _e3386[0]) * _e3337)), (_e3386[1] + ((_e3392[1] - _e3386[1]) * _e3337)), (_e3386[2] + ((_e3392[2] - _e3386[2]) * _e3337))), 0u);
                                                                            let _e3417 = (((_e3406[0] * _e3406[0]) + (_e3406[1] * _e3406[1])) + (_e3406[2] * _e3406[2]));
                                                                            if (_e3417 <= 2.2250738585072014e-308lf) {
                                                                                if (_e3417 > 0.0lf) {
                                                                                    phi_9088_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                } else {
                                                                                    phi_9088_ = 0.0lf;
                                                                                }
                                                                                let _e3469 = phi_9088_;
                                                                                phi_9152_ = _e3469;
                                                                            } else {
                                                                                phi_9095_ = type_16(0i, 5i);
                                                                                phi_9098_ = bitcast<f64>(((bitcast<u64>(_e3417) / 2lu) + 2303426169912950784lu));
                                                                                loop {
                                                                                    let _e3424 = phi_9095_;
                                                                                    let _e3426 = phi_9098_;
                                                                                    local_19 = _e3426;
                                                                                    if (_e3424.member < _e3424.member_1) {
                                                                                        let _e3433 = (_e3424.member + 1i);
                                                                                        if ((false == (_e3433 > _e3424.member)) != false) {
                                                                                            phi_9119_ = true;
                                                                                        } else {
                                                                                            phi_9119_ = false;
                                                                                        }
                                                                                        let _e3438 = phi_9119_;
                                                                                        if _e3438 {
                                                                                            phi_9125_ = type_17(0u, type_17().member_1);
                                                                                        } else {
                                                                                            phi_9125_ = type_17(1u, _e3433);
                                                                                        }
                                                                                        let _e3443 = phi_9125_;
                                                                                        phi_9096_ = type_16(_e3443.member_1, _e3424.member_1);
                                                                                        phi_9139_ = type_17(1u, _e3424.member);
                                                                                    } else {
                                                                                        phi_9096_ = _e3424;
                                                                                        phi_9139_ = type_17(0u, type_17().member_1);
                                                                                    }
                                                                                    let _e3449 = phi_9096_;
                                                                                    let _e3451 = phi_9139_;
                                                                                    let _e3454 = (bitcast<i32>(_e3451.member) != 0i);
                                                                                    if _e3454 {
                                                                                        phi_9099_ = (0.5lf * (_e3426 + (_e3417 / _e3426)));
                                                                                    } else {
                                                                                        phi_9099_ = f64();
                                                                                    }
                                                                                    let _e3459 = phi_9099_;
                                                                                    continue;
                                                                                    continuing {
                                                                                        phi_9095_ = _e3449;
                                                                                        phi_9098_ = _e3459;
                                                                                        break if !(_e3454);
                                                                                    }
                                                                                }
                                                                                let _e3464 = local_19;
                                                                                phi_9152_ = (_e3464 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                            }
                                                                            let _e3471 = phi_9152_;
                                                                            let _e3479 = local_12.member[0u];
                                                                            if (_e3479[0] < 0.0lf) {
                                                                                phi_9170_ = -(_e3479[0]);
                                                                            } else {
                                                                                phi_9170_ = _e3479[0];
                                                                            }
                                                                            let _e3486 = phi_9170_;
                                                                            if (_e3479[1] < 0.0lf) {
                                                                                phi_9177_ = -(_e3479[1]);
                                                                            } else {
                                                                                phi_9177_ = _e3479[1];
                                                                            }
                                                                            let _e3490 = phi_9177_;
                                                                            if (_e3486 > _e3490) {
                                                                                phi_9182_ = _e3486;
                                                                            } else {
                                                                                phi_9182_ = _e3490;
                                                                            }
                                                                            let _e3493 = phi_9182_;
                                                                            if (_e3479[2] < 0.0lf) {
                                                                                phi_9189_ = -(_e3479[2]);
                                                                            } else {
                                                                                phi_9189_ = _e3479[2];
                                                                            }
                                                                            let _e3497 = phi_9189_;
                                                                            if (_e3493 > _e3497) {
                                                                                phi_9194_ = _e3493;
                                                                            } else {
                                                                                phi_9194_ = _e3497;
                                                                            }
                                                                            let _e3500 = phi_9194_;
                                                                            let _e3503 = local_12.member[1u];
                                                                            if (_e3503[0] < 0.0lf) {
                                                                                phi_9207_ = -(_e3503[0]);
                                                                            } else {
                                                                                phi_9207_ = _e3503[0];
                                                                            }
                                                                            let _e3510 = phi_9207_;
                                                                            if (_e3503[1] < 0.0lf) {
                                                                                phi_9214_ = -(_e3503[1]);
                                                                            } else {
                                                                                phi_9214_ = _e3503[1];
                                                                            }
                                                                            let _e3514 = phi_9214_;
                                                                            if (_e3510 > _e3514) {
                                                                                phi_9219_ = _e3510;
                                                                            } else {
                                                                                phi_9219_ = _e3514;
                                                                            }
                                                                            let _e3517 = phi_9219_;
                                                                            if (_e3503[2] < 0.0lf) {
                                                                                phi_9226_ = -(_e3503[2]);
                                                                            } else {
                                                                                phi_9226_ = _e3503[2];
                                                                            }
                                                                            let _e3521 = phi_9226_;
                                                                            if (_e3517 > _e3521) {
                                                                                phi_9231_ = _e3517;
                                                                            } else {
                                                                                phi_9231_ = _e3521;
                                                                            }
                                                                            let _e3524 = phi_9231_;
                                                                            if (_e3500 > _e3524) {
                                                                                phi_9236_ = _e3500;
                                                                            } else {
                                                                                phi_9236_ = _e3524;
                                                                            }
                                                                            let _e3527 = phi_9236_;
                                                                            let _e3529 = local_12.member_3;
                                                                            let _e3533 = local_12.member_1[0u];
                                                                            if (_e3533[0] < 0.0lf) {
                                                                                phi_9253_ = -(_e3533[0]);
                                                                            } else {
                                                                                phi_9253_ = _e3533[0];
                                                                            }
                                                                            let _e3540 = phi_9253_;
                                                                            if (_e3533[1] < 0.0lf) {
                                                                                phi_9260_ = -(_e3533[1]);
                                                                            } else {
                                                                                phi_9260_ = _e3533[1];
                                                                            }
                                                                            let _e3544 = phi_9260_;
                                                                            if (_e3540 > _e3544) {
                                                                                phi_9265_ = _e3540;
                                                                            } else {
                                                                                phi_9265_ = _e3544;
                                                                            }
                                                                            let _e3547 = phi_9265_;
                                                                            if (_e3533[2] < 0.0lf) {
                                                                                phi_9272_ = -(_e3533[2]);
                                                                            } else {
                                                                                phi_9272_ = _e3533[2];
                                                                            }
                                                                            let _e3551 = phi_9272_;
                                                                            if (_e3547 > _e3551) {
                                                                                phi_9277_ = _e3547;
                                                                            } else {
                                                                                phi_9277_ = _e3551;
                                                                            }
                                                                            let _e3554 = phi_9277_;
                                                                            let _e3557 = local_12.member_1[1u];
                                                                            if (_e3557[0] < 0.0lf) {
                                                                                phi_9291_ = -(_e3557[0]);
                                                                            } else {
                                                                                phi_9291_ = _e3557[0];
                                                                            }
                                                                            let _e3564 = phi_9291_;
                                                                            if (_e3557[1] < 0.0lf) {
                                                                                phi_9298_ = -(_e3557[1]);
                                                                            } else {
                                                                                phi_9298_ = _e3557[1];
                                                                            }
                                                                            let _e3568 = phi_9298_;
                                                                            if (_e3564 > _e3568) {
                                                                                phi_9303_ = _e3564;
                                                                            } else {
                                                                                phi_9303_ = _e3568;
                                                                            }
                                                                            let _e3571 = phi_9303_;
                                                                            if (_e3557[2] < 0.0lf) {
                                                                                phi_9310_ = -(_e3557[2]);
                                                                            } else {
                                                                                phi_9310_ = _e3557[2];
                                                                            }
                                                                            let _e3575 = phi_9310_;
                                                                            if (_e3571 > _e3575) {
                                                                                phi_9315_ = _e3571;
                                                                            } else {
                                                                                phi_9315_ = _e3575;
                                                                            }
                                                                            let _e3578 = phi_9315_;
                                                                            if (_e3554 > _e3578) {
                                                                                phi_9320_ = _e3554;
                                                                            } else {
                                                                                phi_9320_ = _e3578;
                                                                            }
                                                                            let _e3581 = phi_9320_;
                                                                            let _e3583 = local_12.member_3;
                                                                            let _e3587 = local_12.member_2[0u];
                                                                            if (_e3587[0] < 0.0lf) {
                                                                                phi_9337_ = -(_e3587[0]);
                                                                            } else {
                                                                                phi_9337_ = _e3587[0];
                                                                            }
                                                                            let _e3594 = phi_9337_;
                                                                            if (_e3587[1] < 0.0lf) {
                                                                                phi_9344_ = -(_e3587[1]);
                                                                            } else {
                                                                                phi_9344_ = _e3587[1];
                                                                            }
                                                                            let _e3598 = phi_9344_;
                                                                            if (_e3594 > _e3598) {
                                                                                phi_9349_ = _e3594;
                                                                            } else {
                                                                                phi_9349_ = _e3598;
                                                                            }
                                                                            let _e3601 = phi_9349_;
                                                                            if (_e3587[2] < 0.0lf) {
                                                                                phi_9356_ = -(_e3587[2]);
                                                                            } else {
                                                                                phi_9356_ = _e3587[2];
                                                                            }
                                                                            let _e3605 = phi_9356_;
                                                                            if (_e3601 > _e3605) {
                                                                                phi_9361_ = _e3601;
                                                                            } else {
                                                                                phi_9361_ = _e3605;
                                                                            }
                                                                            let _e3608 = phi_9361_;
                                                                            let _e3611 = local_12.member_2[1u];
                                                                            if (_e3611[0] < 0.0lf) {
                                                                                phi_9375_ = -(_e3611[0]);
                                                                            } else {
                                                                                phi_9375_ = _e3611[0];
                                                                            }
                                                                            let _e3618 = phi_9375_;
                                                                            if (_e3611[1] < 0.0lf) {
                                                                                phi_9382_ = -(_e3611[1]);
                                                                            } else {
                                                                                phi_9382_ = _e3611[1];
                                                                            }
                                                                            let _e3622 = phi_9382_;
                                                                            if (_e3618 > _e3622) {
                                                                                phi_9387_ = _e3618;
                                                                            } else {
                                                                                phi_9387_ = _e3622;
                                                                            }
                                                                            let _e3625 = phi_9387_;
                                                                            if (_e3611[2] < 0.0lf) {
                                                                                phi_9394_ = -(_e3611[2]);
                                                                            } else {
                                                                                phi_9394_ = _e3611[2];
                                                                            }
                                                                            let _e3629 = phi_9394_;
                                                                            if (_e3625 > _e3629) {
                                                                                phi_9399_ = _e3625;
                                                                            } else {
                                                                                phi_9399_ = _e3629;
                                                                            }
                                                                            let _e3632 = phi_9399_;
                                                                            if (_e3608 > _e3632) {
                                                                                phi_9404_ = _e3608;
                                                                            } else {
                                                                                phi_9404_ = _e3632;
                                                                            }
                                                                            let _e3635 = phi_9404_;
                                                                            let _e3637 = local_12.member_3;
                                                                            let _e3645 = local_12.member_3;
                                                                            if (((_e3471 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3527 + _e3529) + (_e3581 + _e3583)) + (_e3635 + _e3637)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3645 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e2291) {
                                                                                phi_9428_ = false;
                                                                            } else {
                                                                                phi_9428_ = true;
                                                                            }
                                                                            let _e3657 = phi_9428_;
                                                                            phi_9429_ = _e3657;
                                                                        } else {
                                                                            phi_9429_ = true;
                                                                        }
                                                                        let _e3659 = phi_9429_;
                                                                        phi_9430_ = _e3659;
                                                                    } else {
                                                                        phi_9430_ = true;
                                                                    }
                                                                    let _e3661 = phi_9430_;
                                                                    if _e3661 {
                                                                        if _e2533 {
                                                                            if _e3332 {
                                                                                phi_9449_ = f64();
                                                                                phi_9450_ = true;
                                                                            } else {
                                                                                if (_e3330 <= (_e2529 * f64(0.25f))) {
                                                                                    phi_9447_ = f64(0f);
                                                                                    phi_9448_ = false;
                                                                                } else {
                                                                                    phi_9447_ = f64();
                                                                                    phi_9448_ = true;
                                                                                }
                                                                                let _e3668 = phi_9447_;
                                                                                let _e3670 = phi_9448_;
                                                                                phi_9449_ = _e3668;
                                                                                phi_9450_ = _e3670;
                                                                            }
                                                                            let _e3672 = phi_9449_;
                                                                            let _e3674 = phi_9450_;
                                                                            if _e3674 {
                                                                                phi_9455_ = (_e2858 + _e2858);
                                                                            } else {
                                                                                phi_9455_ = _e3672;
                                                                            }
                                                                            let _e3677 = phi_9455_;
                                                                            phi_9457_ = _e3677;
                                                                        } else {
                                                                            phi_9457_ = (_e1551.member_1 - _e2525);
                                                                        }
                                                                        let _e3679 = phi_9457_;
                                                                        phi_9458_ = _e3679;
                                                                        phi_9459_ = false;
                                                                    } else {
                                                                        phi_9458_ = f64();
                                                                        phi_9459_ = true;
                                                                    }
                                                                    let _e3681 = phi_9458_;
                                                                    let _e3683 = phi_9459_;
                                                                    phi_9460_ = _e3681;
                                                                    phi_9461_ = _e3330;
                                                                    phi_9462_ = _e3661;
                                                                    phi_9463_ = _e3683;
                                                                }
                                                                let _e3685 = phi_9460_;
                                                                let _e3687 = phi_9461_;
                                                                let _e3689 = phi_9462_;
                                                                let _e3691 = phi_9463_;
                                                                phi_9464_ = _e3328;
                                                                phi_9465_ = _e3685;
                                                                phi_9466_ = _e3687;
                                                                phi_9467_ = _e3328;
                                                                phi_9468_ = _e3689;
                                                                phi_9469_ = _e3329;
                                                                phi_9470_ = _e3691;
                                                                phi_9471_ = false;
                                                            } else {
                                                                phi_9464_ = f64();
                                                                phi_9465_ = f64();
                                                                phi_9466_ = f64();
                                                                phi_9467_ = f64();
                                                                phi_9468_ = false;
                                                                phi_9469_ = false;
                                                                phi_9470_ = false;
                                                                phi_9471_ = true;
                                                            }
                                                            let _e3693 = phi_9464_;
                                                            let _e3695 = phi_9465_;
                                                            let _e3697 = phi_9466_;
                                                            let _e3699 = phi_9467_;
                                                            let _e3701 = phi_9468_;
                                                            let _e3703 = phi_9469_;
                                                            let _e3705 = phi_9470_;
                                                            let _e3707 = phi_9471_;
                                                            phi_9472_ = _e3693;
                                                            phi_9473_ = _e3695;
                                                            phi_9474_ = _e3697;
                                                            phi_9475_ = _e3699;
                                                            phi_9476_ = false;
                                                            phi_9477_ = _e3701;
                                                            phi_9478_ = _e3703;
                                                            phi_9479_ = _e3705;
                                                            phi_9480_ = _e3707;
                                                        } else {
                                                            phi_9472_ = f64();
                                                            phi_9473_ = f64();
                                                            phi_9474_ = f64();
                                                            phi_9475_ = f64();
                                                            phi_9476_ = true;
                                                            phi_9477_ = false;
                                                            phi_9478_ = false;
                                                            phi_9479_ = false;
                                                            phi_9480_ = false;
                                                        }
                                                        let _e3709 = phi_9472_;
                                                        let _e3711 = phi_9473_;
                                                        let _e3713 = phi_9474_;
                                                        let _e3715 = phi_9475_;
                                                        let _e3717 = phi_9476_;
                                                        let _e3719 = phi_9477_;
                                                        let _e3721 = phi_9478_;
                                                        let _e3723 = phi_9479_;
                                                        let _e3725 = phi_9480_;
                                                        phi_9481_ = _e3709;
                                                        phi_9482_ = _e3711;
                                                        phi_9483_ = _e3713;
                                                        phi_9484_ = _e3715;
                                                        phi_9485_ = _e3717;
                                                        phi_9486_ = _e3719;
                                                        phi_9487_ = _e3721;
                                                        phi_9488_ = _e3723;
                                                        phi_9489_ = _e3725;
                                                    } else {
                                                        phi_9481_ = f64();
                                                        phi_9482_ = f64();
                                                        phi_9483_ = f64();
                                                        phi_9484_ = f64();
                                                        phi_9485_ = true;
                                                        phi_9486_ = false;
                                                        phi_9487_ = false;
                                                        phi_9488_ = false;
                                                        phi_9489_ = false;
                                                    }
                                                    let _e3727 = phi_9481_;
                                                    let _e3729 = phi_9482_;
                                                    let _e3731 = phi_9483_;
                                                    let _e3733 = phi_9484_;
                                                    let _e3735 = phi_9485_;
                                                    let _e3737 = phi_9486_;
                                                    let _e3739 = phi_9487_;
                                                    let _e3741 = phi_9488_;
                                                    let _e3743 = phi_9489_;
                                                    if _e3735 {
                                                        if (_e2525 <= _e2527) {
                                                            let _e3909 = (_e2535 + 1u);
                                                            let _e3910 = (_e3909 > 3u);
                                                            if _e3910 {
                                                                phi_9502_ = false;
                                                            } else {
                                                                phi_9502_ = true;
                                                            }
                                                            let _e3912 = phi_9502_;
                                                            phi_9829_ = _e3909;
                                                            phi_9830_ = f64();
                                                            phi_9831_ = false;
                                                            phi_9832_ = _e3912;
                                                            phi_9833_ = _e3910;
                                                        } else {
                                                            let _e3747 = local.member[0u];
                                                            let _e3750 = local.member_1[0u];
                                                            let _e3753 = local.member[0u];
                                                            let _e3759 = local.member_2[0u];
                                                            let _e3760 = ((_e3747 + ((_e3750 - _e3753) * _e2531)) - _e3759);
                                                            let _e3763 = local.member[1u];
                                                            let _e3766 = local.member_1[1u];
                                                            let _e3769 = local.member[1u];
                                                            let _e3775 = local.member_2[1u];
                                                            let _e3776 = ((_e3763 + ((_e3766 - _e3769) * _e2531)) - _e3775);
                                                            if (_e3760 < _e3776) {
                                                                phi_9575_ = _e3760;
                                                            } else {
                                                                phi_9575_ = _e3776;
                                                            }
                                                            let _e3779 = phi_9575_;
                                                            let _e3782 = local.member[2u];
                                                            let _e3785 = local.member_1[2u];
                                                            let _e3788 = local.member[2u];
                                                            let _e3794 = local.member_2[2u];
                                                            let _e3795 = ((_e3782 + ((_e3785 - _e3788) * _e2531)) - _e3794);
                                                            let _e3798 = local.member[3u];
                                                            let _e3801 = local.member_1[3u];
                                                            let _e3804 = local.member[3u];
                                                            let _e3810 = local.member_2[3u];
                                                            let _e3811 = ((_e3798 + ((_e3801 - _e3804) * _e2531)) - _e3810);
                                                            if (_e3795 < _e3811) {
                                                                phi_9648_ = _e3795;
                                                            } else {
                                                                phi_9648_ = _e3811;
                                                            }
                                                            let _e3814 = phi_9648_;
                                                            if (_e3779 < _e3814) {
                                                                phi_9653_ = _e3779;
                                                            } else {
                                                                phi_9653_ = _e3814;
                                                            }
                                                            let _e3817 = phi_9653_;
                                                            let _e3820 = local_1.member[0u];
                                                            let _e3823 = local_1.member_1[0u];
                                                            let _e3826 = local_1.member[0u];
                                                            let _e3832 = local_1.member_2[0u];
                                                            let _e3833 = ((_e3820 + ((_e3823 - _e3826) * _e2525)) - _e3832);
                                                            let _e3836 = local_1.member[1u];
                                                            let _e3839 = local_1.member_1[1u];
                                                            let _e3842 = local_1.member[1u];
                                                            let _e3848 = local_1.member_2[1u];
                                                            let _e3849 = ((_e3836 + ((_e3839 - _e3842) * _e2525)) - _e3848);
                                                            if (_e3833 < _e3849) {
                                                                phi_9726_ = _e3833;
                                                            } else {
                                                                phi_9726_ = _e3849;
                                                            }
                                                            let _e3852 = phi_9726_;
                                                            let _e3855 = local_1.member[2u];
                                                            let _e3858 = local_1.member_1[2u];
                                                            let _e3861 = local_1.member[2u];
                                                            let _e3867 = local_1.member_2[2u];
                                                            let _e3868 = ((_e3855 + ((_e3858 - _e3861) * _e2525)) - _e3867);
                                                            let _e3871 = local_1.member[3u];
                                                            let _e3874 = local_1.member_1[3u];
                                                            let _e3877 = local_1.member[3u];
                                                            let _e3883 = local_1.member_2[3u];
                                                            let _e3884 = ((_e3871 + ((_e3874 - _e3877) * _e2525)) - _e3883);
                                                            if (_e3868 < _e3884) {
                                                                phi_9799_ = _e3868;
                                                            } else {
                                                                phi_9799_ = _e3884;
                                                            }
                                                            let _e3887 = phi_9799_;
                                                            if (_e3852 < _e3887) {
                                                                phi_9804_ = _e3852;
                                                            } else {
                                                                phi_9804_ = _e3887;
                                                            }
                                                            let _e3890 = phi_9804_;
                                                            let _e3891 = f64(0.0625f);
                                                            let _e3893 = f64(0.9f);
                                                            if (_e3890 > f64(0f)) {
                                                                phi_9827_ = f64(0.5f);
                                                            } else {
                                                                let _e3899 = (f64(0.95f) * (_e3817 / (_e3817 - _e3890)));
                                                                if (_e3899 > _e3891) {
                                                                    if (_e3899 < _e3893) {
                                                                        phi_9825_ = _e3899;
                                                                    } else {
                                                                        phi_9825_ = _e3893;
                                                                    }
                                                                    let _e3903 = phi_9825_;
                                                                    phi_9826_ = _e3903;
                                                                } else {
                                                                    phi_9826_ = _e3891;
                                                                }
                                                                let _e3905 = phi_9826_;
                                                                phi_9827_ = _e3905;
                                                            }
                                                            let _e3907 = phi_9827_;
                                                            phi_9829_ = u32();
                                                            phi_9830_ = (_e2858 * _e3907);
                                                            phi_9831_ = true;
                                                            phi_9832_ = false;
                                                            phi_9833_ = false;
                                                        }
                                                        let _e3914 = phi_9829_;
                                                        let _e3916 = phi_9830_;
                                                        let _e3918 = phi_9831_;
                                                        let _e3920 = phi_9832_;
                                                        let _e3922 = phi_9833_;
                                                        phi_9834_ = _e3914;
                                                        phi_9835_ = _e2527;
                                                        phi_9836_ = _e3916;
                                                        phi_9837_ = _e2529;
                                                        phi_9838_ = _e2531;
                                                        phi_9839_ = _e2533;
                                                        phi_9840_ = _e2535;
                                                        phi_9841_ = _e3918;
                                                        phi_9842_ = _e3920;
                                                        phi_9843_ = _e3922;
                                                        phi_9844_ = false;
                                                        phi_9845_ = false;
                                                        phi_9846_ = false;
                                                    } else {
                                                        phi_9834_ = u32();
                                                        phi_9835_ = _e3727;
                                                        phi_9836_ = _e3729;
                                                        phi_9837_ = _e3731;
                                                        phi_9838_ = _e2525;
                                                        phi_9839_ = true;
                                                        phi_9840_ = 0u;
                                                        phi_9841_ = _e3737;
                                                        phi_9842_ = false;
                                                        phi_9843_ = false;
                                                        phi_9844_ = _e3739;
                                                        phi_9845_ = _e3741;
                                                        phi_9846_ = _e3743;
                                                    }
                                                    let _e3924 = phi_9834_;
                                                    let _e3926 = phi_9835_;
                                                    let _e3928 = phi_9836_;
                                                    let _e3930 = phi_9837_;
                                                    let _e3932 = phi_9838_;
                                                    let _e3934 = phi_9839_;
                                                    let _e3936 = phi_9840_;
                                                    let _e3938 = phi_9841_;
                                                    let _e3940 = phi_9842_;
                                                    let _e3942 = phi_9843_;
                                                    let _e3944 = phi_9844_;
                                                    let _e3946 = phi_9845_;
                                                    let _e3948 = phi_9846_;
                                                    if _e3938 {
                                                        let _e3949 = (_e3932 + _e3928);
                                                        if (_e3949 > _e3926) {
                                                            phi_9855_ = _e3949;
                                                        } else {
                                                            phi_9855_ = _e3926;
                                                        }
                                                        let _e3952 = phi_9855_;
                                                        if (_e3952 < _e1551.member_1) {
                                                            phi_9860_ = _e3952;
                                                        } else {
                                                            phi_9860_ = _e1551.member_1;
                                                        }
                                                        let _e3955 = phi_9860_;
                                                        if !(_e2533) {
                                                            phi_9870_ = true;
                                                        } else {
                                                            phi_9870_ = ((_e3955 - _e3932) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3960 = phi_9870_;
                                                        if _e3960 {
                                                            phi_9874_ = false;
                                                        } else {
                                                            phi_9874_ = true;
                                                        }
                                                        let _e3962 = phi_9874_;
                                                        phi_9875_ = _e3955;
                                                        phi_9876_ = _e3926;
                                                        phi_9877_ = _e3930;
                                                        phi_9878_ = _e3932;
                                                        phi_9879_ = _e3934;
                                                        phi_9880_ = _e3936;
                                                        phi_9881_ = _e3960;
                                                        phi_9882_ = _e3962;
                                                        phi_9883_ = false;
                                                        phi_9884_ = false;
                                                        phi_9885_ = false;
                                                        phi_9886_ = false;
                                                    } else {
                                                        phi_9875_ = _e2525;
                                                        phi_9876_ = _e2527;
                                                        phi_9877_ = _e2529;
                                                        phi_9878_ = _e2531;
                                                        phi_9879_ = _e2533;
                                                        phi_9880_ = _e3924;
                                                        phi_9881_ = _e3940;
                                                        phi_9882_ = false;
                                                        phi_9883_ = _e3942;
                                                        phi_9884_ = _e3944;
                                                        phi_9885_ = _e3946;
                                                        phi_9886_ = _e3948;
                                                    }
                                                    let _e3964 = phi_9875_;
                                                    let _e3966 = phi_9876_;
                                                    let _e3968 = phi_9877_;
                                                    let _e3970 = phi_9878_;
                                                    let _e3972 = phi_9879_;
                                                    let _e3974 = phi_9880_;
                                                    let _e3976 = phi_9881_;
                                                    let _e3978 = phi_9882_;
                                                    let _e3980 = phi_9883_;
                                                    let _e3982 = phi_9884_;
                                                    let _e3984 = phi_9885_;
                                                    let _e3986 = phi_9886_;
                                                    phi_7664_ = _e3964;
                                                    phi_7666_ = _e3966;
                                                    phi_7668_ = _e3968;
                                                    phi_7670_ = _e3970;
                                                    phi_7672_ = _e3972;
                                                    phi_7674_ = _e3974;
                                                    phi_9887_ = _e3926;
                                                    phi_9888_ = _e3733;
                                                    phi_9889_ = _e3976;
                                                    phi_9890_ = _e3978;
                                                    phi_9891_ = _e3980;
                                                    phi_9892_ = _e3982;
                                                    phi_9893_ = _e3984;
                                                    phi_9894_ = false;
                                                    phi_9895_ = _e3986;
                                                } else {
                                                    phi_7664_ = f64();
                                                    phi_7666_ = f64();
                                                    phi_7668_ = f64();
                                                    phi_7670_ = f64();
                                                    phi_7672_ = bool();
                                                    phi_7674_ = u32();
                                                    phi_9887_ = f64();
                                                    phi_9888_ = f64();
                                                    phi_9889_ = false;
                                                    phi_9890_ = false;
                                                    phi_9891_ = false;
                                                    phi_9892_ = false;
                                                    phi_9893_ = false;
                                                    phi_9894_ = true;
                                                    phi_9895_ = false;
                                                }
                                                let _e3988 = phi_7664_;
                                                let _e3990 = phi_7666_;
                                                let _e3992 = phi_7668_;
                                                let _e3994 = phi_7670_;
                                                let _e3996 = phi_7672_;
                                                let _e3998 = phi_7674_;
                                                let _e4000 = phi_9887_;
                                                let _e4002 = phi_9888_;
                                                let _e4004 = phi_9889_;
                                                let _e4006 = phi_9890_;
                                                let _e4008 = phi_9891_;
                                                let _e4010 = phi_9892_;
                                                let _e4012 = phi_9893_;
                                                let _e4014 = phi_9894_;
                                                let _e4016 = phi_9895_;
                                                local_20 = _e4006;
                                                local_37 = _e4008;
                                                local_38 = _e4010;
                                                local_39 = _e4012;
                                                local_40 = _e4014;
                                                local_41 = _e4016;
                                                local_42 = _e4006;
                                                local_43 = _e4002;
                                                local_44 = _e4000;
                                                continue;
                                                continuing {
                                                    phi_7660_ = _e2547;
                                                    phi_7663_ = _e3988;
                                                    phi_7665_ = _e3990;
                                                    phi_7667_ = _e3992;
                                                    phi_7669_ = _e3994;
                                                    phi_7671_ = _e3996;
                                                    phi_7673_ = _e3998;
                                                    break if !(_e4004);
                                                }
                                            }
                                            let _e4019 = local_20;
                                            if _e4019 {
                                                phi_9899_ = false;
                                                phi_9900_ = false;
                                                phi_9901_ = false;
                                                phi_9902_ = false;
                                                phi_9903_ = false;
                                            } else {
                                                let _e7041 = local_37;
                                                phi_9899_ = _e7041;
                                                let _e7044 = local_38;
                                                phi_9900_ = _e7044;
                                                let _e7047 = local_39;
                                                phi_9901_ = _e7047;
                                                let _e7050 = local_40;
                                                phi_9902_ = _e7050;
                                                let _e7053 = local_41;
                                                phi_9903_ = _e7053;
                                            }
                                            let _e4021 = phi_9899_;
                                            let _e4023 = phi_9900_;
                                            let _e4025 = phi_9901_;
                                            let _e4027 = phi_9902_;
                                            let _e4029 = phi_9903_;
                                            if _e4021 {
                                                let _e4031 = local_21;
                                                phi_9908_ = type_44(1u, _e4031);
                                                phi_9909_ = false;
                                                phi_9910_ = false;
                                                phi_9911_ = false;
                                                phi_9912_ = false;
                                                phi_9913_ = false;
                                            } else {
                                                phi_9908_ = type_44();
                                                phi_9909_ = _e4023;
                                                phi_9910_ = _e4025;
                                                let _e7060 = local_42;
                                                phi_9911_ = _e7060;
                                                phi_9912_ = _e4027;
                                                phi_9913_ = _e4029;
                                            }
                                            let _e4034 = phi_9908_;
                                            let _e4036 = phi_9909_;
                                            let _e4038 = phi_9910_;
                                            let _e4040 = phi_9911_;
                                            let _e4042 = phi_9912_;
                                            let _e4044 = phi_9913_;
                                            if _e4036 {
                                                phi_9918_ = type_44(0u, type_44().member_1);
                                                phi_9919_ = false;
                                                phi_9920_ = false;
                                                phi_9921_ = false;
                                                phi_9922_ = false;
                                                phi_9923_ = true;
                                            } else {
                                                phi_9918_ = _e4034;
                                                phi_9919_ = _e4038;
                                                phi_9920_ = _e4040;
                                                phi_9921_ = _e4042;
                                                phi_9922_ = _e4044;
                                                phi_9923_ = _e4021;
                                            }
                                            let _e4048 = phi_9918_;
                                            let _e4050 = phi_9919_;
                                            let _e4052 = phi_9920_;
                                            let _e4054 = phi_9921_;
                                            let _e4056 = phi_9922_;
                                            let _e4058 = phi_9923_;
                                            if _e4050 {
                                                let _e7071 = local_43;
                                                phi_9927_ = _e7071;
                                                phi_9928_ = true;
                                                phi_9929_ = false;
                                                phi_9930_ = false;
                                                phi_9931_ = false;
                                            } else {
                                                let _e7073 = local_44;
                                                phi_9927_ = _e7073;
                                                phi_9928_ = _e4052;
                                                phi_9929_ = _e4054;
                                                phi_9930_ = _e4056;
                                                phi_9931_ = _e4058;
                                            }
                                            let _e4060 = phi_9927_;
                                            let _e4062 = phi_9928_;
                                            let _e4064 = phi_9929_;
                                            let _e4066 = phi_9930_;
                                            let _e4068 = phi_9931_;
                                            if _e4062 {
                                                phi_9935_ = _e4060;
                                                phi_9936_ = true;
                                                phi_9937_ = false;
                                                phi_9938_ = false;
                                            } else {
                                                let _e7080 = local_45;
                                                phi_9935_ = _e7080;
                                                phi_9936_ = _e4064;
                                                phi_9937_ = _e4066;
                                                phi_9938_ = _e4068;
                                            }
                                            let _e4070 = phi_9935_;
                                            let _e4072 = phi_9936_;
                                            let _e4074 = phi_9937_;
                                            let _e4076 = phi_9938_;
                                            if _e4072 {
                                                phi_9943_ = type_44(1u, _e4070);
                                                phi_9944_ = false;
                                                phi_9945_ = false;
                                            } else {
                                                phi_9943_ = type_44();
                                                phi_9944_ = _e4074;
                                                phi_9945_ = _e4076;
                                            }
                                            let _e4079 = phi_9943_;
                                            let _e4081 = phi_9944_;
                                            let _e4083 = phi_9945_;
                                            if _e4081 {
                                                phi_9950_ = type_44(0u, type_44().member_1);
                                                phi_9951_ = true;
                                            } else {
                                                phi_9950_ = _e4048;
                                                phi_9951_ = _e4083;
                                            }
                                            let _e4087 = phi_9950_;
                                            let _e4089 = phi_9951_;
                                            if _e4089 {
                                                phi_9955_ = _e4087;
                                            } else {
                                                phi_9955_ = _e4079;
                                            }
                                            let _e4091 = phi_9955_;
                                            let _e4094 = (_e4091.member != 0u);
                                            if _e4094 {
                                                phi_9962_ = false;
                                            } else {
                                                phi_9962_ = true;
                                            }
                                            let _e4096 = phi_9962_;
                                            phi_9963_ = _e4091.member_1;
                                            phi_9964_ = _e4096;
                                            phi_9965_ = _e4094;
                                            phi_9966_ = false;
                                        } else {
                                            phi_9963_ = f64();
                                            phi_9964_ = false;
                                            phi_9965_ = false;
                                            phi_9966_ = true;
                                        }
                                        let _e4098 = phi_9963_;
                                        let _e4100 = phi_9964_;
                                        let _e4102 = phi_9965_;
                                        let _e4104 = phi_9966_;
                                        phi_9967_ = _e4098;
                                        phi_9968_ = _e4100;
                                        phi_9969_ = _e4102;
                                        phi_9970_ = _e4104;
                                    }
                                    let _e4106 = phi_9967_;
                                    let _e4108 = phi_9968_;
                                    let _e4110 = phi_9969_;
                                    let _e4112 = phi_9970_;
                                    phi_9971_ = _e4106;
                                    phi_9972_ = _e2275;
                                    phi_9973_ = _e4108;
                                    phi_9974_ = _e4110;
                                    phi_9975_ = _e4112;
                                }
                                let _e4114 = phi_9971_;
                                let _e4116 = phi_9972_;
                                let _e4118 = phi_9973_;
                                let _e4120 = phi_9974_;
                                let _e4122 = phi_9975_;
                                if _e4116 {
                                    phi_9979_ = true;
                                    phi_9980_ = false;
                                    phi_9981_ = false;
                                } else {
                                    phi_9979_ = _e4118;
                                    phi_9980_ = _e4120;
                                    phi_9981_ = _e4122;
                                }
                                let _e4124 = phi_9979_;
                                let _e4126 = phi_9980_;
                                let _e4128 = phi_9981_;
                                phi_9982_ = _e4114;
                                phi_9983_ = _e1551;
                                phi_9984_ = _e4124;
                                phi_9985_ = false;
                                phi_9986_ = _e4126;
                                phi_9987_ = _e4128;
                            } else {
                                phi_9982_ = f64();
                                phi_9983_ = type_45();
                                phi_9984_ = false;
                                phi_9985_ = true;
                                phi_9986_ = false;
                                phi_9987_ = false;
                            }
                            let _e4130 = phi_9982_;
                            let _e4132 = phi_9983_;
                            let _e4134 = phi_9984_;
                            let _e4136 = phi_9985_;
                            let _e4138 = phi_9986_;
                            let _e4140 = phi_9987_;
                            local_22 = _e4136;
                            local_46 = _e4138;
                            local_47 = _e4140;
                            local_23 = _e4130;
                            local_24 = _e4132;
                            continue;
                            continuing {
                                phi_5736_ = _e1264;
                                break if !(_e4134);
                            }
                        }
                        let _e4143 = local_22;
                        if _e4143 {
                            phi_9992_ = type_44(0u, type_44().member_1);
                            phi_9993_ = false;
                            phi_9994_ = false;
                        } else {
                            phi_9992_ = type_44();
                            let _e7117 = local_46;
                            phi_9993_ = _e7117;
                            let _e7120 = local_47;
                            phi_9994_ = _e7120;
                        }
                        let _e4147 = phi_9992_;
                        let _e4149 = phi_9993_;
                        let _e4151 = phi_9994_;
                        if _e4149 {
                            let _e4153 = local_23;
                            phi_9999_ = type_44(2u, _e4153);
                            phi_10000_ = false;
                        } else {
                            phi_9999_ = type_44();
                            phi_10000_ = _e4151;
                        }
                        let _e4156 = phi_9999_;
                        let _e4158 = phi_10000_;
                        if _e4158 {
                            let _e4160 = local_24;
                            phi_10006_ = type_44(1u, _e4160.member);
                            phi_10007_ = true;
                        } else {
                            phi_10006_ = _e4156;
                            phi_10007_ = _e4149;
                        }
                        let _e4164 = phi_10006_;
                        let _e4166 = phi_10007_;
                        if _e4166 {
                            phi_10011_ = _e4164;
                        } else {
                            phi_10011_ = _e4147;
                        }
                        let _e4168 = phi_10011_;
                        phi_10015_ = _e4168;
                    }
                    let _e6351 = phi_10015_;
                    phi_10016_ = _e6351;
                }
                let _e6355 = phi_10016_;
                switch bitcast<i32>(_e6355.member) {
                    case 0: {
                        phi_10029_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e6361 = function_3(_e6355.member_1);
                        phi_10029_ = type_32(0u, _e6361, true);
                        break;
                    }
                    case 2: {
                        let _e6359 = function_3(_e6355.member_1);
                        phi_10029_ = type_32(1u, _e6359, true);
                        break;
                    }
                    default: {
                        phi_10029_ = type_32();
                        break;
                    }
                }
                let _e6364 = phi_10029_;
                if _e6364.member_2 {
                    let _e6371 = (_e6364.member_1[1] >> bitcast<u32>(20i));
                    if (_e6371 <= 896u) {
                        phi_10052_ = 0u;
                    } else {
                        phi_10052_ = ((((_e6371 - 896u) << bitcast<u32>(23i)) | ((_e6364.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e6364.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e6386 = phi_10052_;
                    let _e6388 = atomicMin((&earliest.member[0u]), _e6386);
                }
                phi_10056_ = type_22(0u, _e6364.member, _e181, _e184, _e6364.member_1);
                phi_10057_ = _e6364.member_2;
            } else {
                phi_10056_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_10057_ = false;
            }
            let _e6390 = phi_10056_;
            let _e6392 = phi_10057_;
            let _e6395 = params.member.member.member_1;
            if ((_e6395 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e6392 {
                    let _e6401 = atomicAdd((&counters[0u]), 1u);
                    phi_10076_ = _e6401;
                } else {
                    phi_10076_ = 0u;
                }
                let _e6403 = phi_10076_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e6406 = atomicLoad((&counters[0u]));
                    if (_e6406 > 0u) {
                        let _e6409 = atomicAdd((&contacts.member[0u]), _e6406);
                        atomicStore((&counters[1u]), _e6409);
                    }
                }
                workgroupBarrier();
                let _e6412 = atomicLoad((&counters[1u]));
                let _e6413 = (_e6412 + _e6403);
                if _e6392 {
                    let _e6416 = params.member.member_1.member_3;
                    if (_e6413 < _e6416) {
                        let _e6418 = (6u * _e6413);
                        atomicStore((&contacts.member[(4u + _e6418)]), _e6390.member);
                        atomicStore((&contacts.member[(_e6418 + 5u)]), _e6390.member_1);
                        atomicStore((&contacts.member[(_e6418 + 6u)]), _e6390.member_2);
                        atomicStore((&contacts.member[(_e6418 + 7u)]), _e6390.member_3);
                        atomicStore((&contacts.member[(_e6418 + 8u)]), _e6390.member_4[0]);
                        atomicStore((&contacts.member[(_e6418 + 9u)]), _e6390.member_4[1]);
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
