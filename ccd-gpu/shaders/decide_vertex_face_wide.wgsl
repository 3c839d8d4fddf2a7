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

struct type_23 {
    member: array<array<f64, 3>>,
}

struct type_25 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_30 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_32 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_33 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_34 {
    member: f64,
    member_1: f64,
}

struct type_38 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_41 {
    member: type_38,
    member_1: f64,
}

struct type_42 {
    member: u32,
    member_1: f64,
}

struct type_43 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_27;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_23;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(3) 
var<storage> elements: type_14;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_738_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_738_ = param_2;
    } else {
        phi_738_ = param_1;
    }
    let _e26 = phi_738_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_309_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_291_: bool;
    var phi_310_: bool;
    var phi_340_: array<f64, 3>;
    var phi_341_: bool;
    var phi_342_: array<f64, 3>;
    var phi_343_: bool;
    var phi_589_: f64;
    var phi_591_: f64;
    var phi_633_: f64;
    var phi_635_: f64;
    var phi_683_: f64;
    var phi_685_: f64;
    var phi_394_: f64;
    var phi_396_: f64;
    var phi_444_: f64;
    var phi_446_: f64;
    var phi_491_: f64;
    var phi_493_: f64;
    var phi_544_: f64;
    var phi_546_: f64;
    var phi_700_: array<array<f64, 3>, 4>;
    var phi_708_: array<f64, 3>;

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
                    phi_282_ = (_e78 <= _e70);
                    phi_283_ = false;
                } else {
                    phi_282_ = bool();
                    phi_283_ = true;
                }
                let _e99 = phi_282_;
                let _e101 = phi_283_;
                phi_284_ = _e99;
                phi_285_ = _e101;
            } else {
                phi_284_ = bool();
                phi_285_ = true;
            }
            let _e103 = phi_284_;
            let _e105 = phi_285_;
            phi_286_ = _e103;
            phi_287_ = _e105;
        } else {
            phi_286_ = bool();
            phi_287_ = true;
        }
        let _e107 = phi_286_;
        let _e109 = phi_287_;
        if _e109 {
            phi_291_ = false;
        } else {
            phi_291_ = _e107;
        }
        let _e111 = phi_291_;
        phi_310_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_302_ = ((_e74 + _e78) <= _e70);
                phi_303_ = false;
            } else {
                phi_302_ = bool();
                phi_303_ = true;
            }
            let _e85 = phi_302_;
            let _e87 = phi_303_;
            phi_304_ = _e85;
            phi_305_ = _e87;
        } else {
            phi_304_ = bool();
            phi_305_ = true;
        }
        let _e89 = phi_304_;
        let _e91 = phi_305_;
        if _e91 {
            phi_309_ = false;
        } else {
            phi_309_ = _e89;
        }
        let _e93 = phi_309_;
        phi_310_ = _e93;
    }
    let _e113 = phi_310_;
    if (_e68 > _e69) {
        if _e113 {
            phi_340_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_341_ = false;
        } else {
            phi_340_ = array<f64, 3>();
            phi_341_ = true;
        }
        let _e138 = phi_340_;
        let _e140 = phi_341_;
        phi_342_ = _e138;
        phi_343_ = _e140;
    } else {
        phi_342_ = array<f64, 3>();
        phi_343_ = true;
    }
    let _e142 = phi_342_;
    let _e144 = phi_343_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_394_ = _e307;
                } else {
                    phi_394_ = f64(1f);
                }
                let _e315 = phi_394_;
                phi_396_ = _e315;
            } else {
                phi_396_ = f64(0f);
            }
            let _e317 = phi_396_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_444_ = _e353;
                } else {
                    phi_444_ = f64(1f);
                }
                let _e361 = phi_444_;
                phi_446_ = _e361;
            } else {
                phi_446_ = f64(0f);
            }
            let _e363 = phi_446_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_491_ = _e396;
                } else {
                    phi_491_ = f64(1f);
                }
                let _e404 = phi_491_;
                phi_493_ = _e404;
            } else {
                phi_493_ = f64(0f);
            }
            let _e406 = phi_493_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_544_ = _e445;
                } else {
                    phi_544_ = f64(1f);
                }
                let _e453 = phi_544_;
                phi_546_ = _e453;
            } else {
                phi_546_ = f64(0f);
            }
            let _e455 = phi_546_;
            phi_700_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_589_ = _e174;
                } else {
                    phi_589_ = f64(1f);
                }
                let _e182 = phi_589_;
                phi_591_ = _e182;
            } else {
                phi_591_ = f64(0f);
            }
            let _e184 = phi_591_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_633_ = _e214;
                } else {
                    phi_633_ = f64(1f);
                }
                let _e222 = phi_633_;
                phi_635_ = _e222;
            } else {
                phi_635_ = f64(0f);
            }
            let _e224 = phi_635_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_683_ = _e260;
                } else {
                    phi_683_ = f64(1f);
                }
                let _e268 = phi_683_;
                phi_685_ = _e268;
            } else {
                phi_685_ = f64(0f);
            }
            let _e270 = phi_685_;
            phi_700_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_700_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_708_ = _e475;
    } else {
        phi_708_ = _e142;
    }
    let _e477 = phi_708_;
    return _e477;
}

fn function_3(param_7: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_7);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_32;
    var local_1: type_32;
    var local_2: type_33;
    var local_3: type_33;
    var local_4: type_33;
    var local_5: array<type_34, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: type_32;
    var local_10: type_32;
    var local_11: array<f32, 3>;
    var local_12: type_38;
    var phi_798_: u32;
    var phi_814_: u32;
    var phi_835_: u32;
    var phi_836_: u32;
    var phi_839_: type_19;
    var phi_840_: type_19;
    var phi_863_: type_19;
    var phi_1111_: type_40;
    var phi_1205_: f64;
    var phi_1211_: f64;
    var phi_1216_: f64;
    var phi_1222_: f64;
    var phi_1227_: f64;
    var phi_1233_: f64;
    var phi_1239_: f64;
    var phi_1244_: f64;
    var phi_1250_: f64;
    var phi_1255_: f64;
    var phi_1260_: f64;
    var phi_1267_: f64;
    var phi_1273_: f64;
    var phi_1278_: f64;
    var phi_1284_: f64;
    var phi_1289_: f64;
    var phi_1295_: f64;
    var phi_1301_: f64;
    var phi_1306_: f64;
    var phi_1312_: f64;
    var phi_1317_: f64;
    var phi_1322_: f64;
    var phi_1329_: f64;
    var phi_1335_: f64;
    var phi_1340_: f64;
    var phi_1346_: f64;
    var phi_1351_: f64;
    var phi_1357_: f64;
    var phi_1363_: f64;
    var phi_1368_: f64;
    var phi_1374_: f64;
    var phi_1379_: f64;
    var phi_1384_: f64;
    var phi_1390_: f64;
    var phi_1395_: f64;
    var phi_1404_: bool;
    var phi_1428_: u64;
    var phi_1440_: f64;
    var phi_1441_: f64;
    var phi_1472_: type_41;
    var phi_1473_: bool;
    var phi_1474_: type_41;
    var phi_1475_: bool;
    var phi_1476_: type_41;
    var phi_1477_: bool;
    var phi_1482_: type_41;
    var phi_1764_: f64;
    var phi_1771_: f64;
    var phi_1776_: f64;
    var phi_1783_: f64;
    var phi_1788_: f64;
    var phi_1801_: f64;
    var phi_1808_: f64;
    var phi_1813_: f64;
    var phi_1820_: f64;
    var phi_1825_: f64;
    var phi_1830_: f64;
    var phi_1847_: f64;
    var phi_1854_: f64;
    var phi_1859_: f64;
    var phi_1866_: f64;
    var phi_1871_: f64;
    var phi_1885_: f64;
    var phi_1892_: f64;
    var phi_1897_: f64;
    var phi_1904_: f64;
    var phi_1909_: f64;
    var phi_1914_: f64;
    var phi_1931_: f64;
    var phi_1938_: f64;
    var phi_1943_: f64;
    var phi_1950_: f64;
    var phi_1955_: f64;
    var phi_1969_: f64;
    var phi_1976_: f64;
    var phi_1981_: f64;
    var phi_1988_: f64;
    var phi_1993_: f64;
    var phi_1998_: f64;
    var phi_2035_: f64;
    var phi_2041_: f64;
    var phi_2048_: f64;
    var phi_2055_: f64;
    var phi_2061_: f64;
    var phi_2068_: f64;
    var phi_2074_: f64;
    var phi_2080_: f64;
    var phi_2086_: f64;
    var phi_2093_: f64;
    var phi_2100_: f64;
    var phi_2128_: f64;
    var phi_2133_: f64;
    var phi_2138_: f64;
    var phi_2143_: f64;
    var phi_2148_: f64;
    var phi_2153_: f64;
    var phi_2164_: f64;
    var phi_4861_: f64;
    var phi_4867_: f64;
    var phi_4872_: f64;
    var phi_4878_: f64;
    var phi_4884_: f64;
    var phi_4889_: f64;
    var phi_4894_: f64;
    var phi_4904_: bool;
    var phi_4911_: f64;
    var phi_4919_: f64;
    var phi_4962_: type_17;
    var phi_4965_: f64;
    var phi_4986_: bool;
    var phi_4992_: type_18;
    var phi_4963_: type_17;
    var phi_5006_: type_18;
    var phi_4966_: f64;
    var local_13: f64;
    var phi_4955_: f64;
    var phi_5019_: f64;
    var phi_5025_: f64;
    var phi_5050_: type_19;
    var phi_5053_: u32;
    var phi_5051_: type_19;
    var phi_5076_: type_19;
    var phi_5120_: u32;
    var phi_5121_: u32;
    var phi_5054_: u32;
    var phi_5122_: u32;
    var phi_5142_: type_19;
    var phi_5143_: type_19;
    var phi_5166_: type_19;
    var phi_5220_: f64;
    var phi_5227_: f64;
    var phi_5239_: bool;
    var phi_5240_: bool;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var phi_5246_: bool;
    var phi_5258_: type_43;
    var phi_5259_: type_43;
    var phi_5260_: bool;
    var phi_5261_: type_43;
    var phi_5262_: bool;
    var phi_5275_: f64;
    var phi_5288_: type_19;
    var phi_5291_: f64;
    var phi_5293_: f64;
    var phi_5295_: f64;
    var phi_5289_: type_19;
    var phi_5318_: type_19;
    var phi_5345_: f64;
    var phi_5346_: f64;
    var phi_5374_: f64;
    var phi_5390_: f64;
    var phi_5397_: bool;
    var phi_5398_: bool;
    var phi_5399_: bool;
    var phi_5405_: f64;
    var phi_5406_: f64;
    var phi_5407_: bool;
    var phi_5292_: f64;
    var phi_5294_: f64;
    var phi_5296_: f64;
    var phi_5408_: f64;
    var phi_5409_: bool;
    var phi_5410_: bool;
    var local_14: bool;
    var phi_5414_: f64;
    var phi_5415_: f64;
    var phi_5425_: f64;
    var phi_5430_: type_19;
    var phi_5433_: f64;
    var phi_5431_: type_19;
    var phi_5456_: type_19;
    var phi_5487_: f64;
    var phi_5488_: bool;
    var phi_5489_: f64;
    var phi_5490_: bool;
    var phi_5491_: bool;
    var phi_5492_: bool;
    var phi_5493_: f64;
    var phi_5434_: f64;
    var phi_5494_: bool;
    var phi_5495_: bool;
    var phi_5496_: bool;
    var phi_5497_: bool;
    var local_15: bool;
    var phi_5501_: bool;
    var phi_5502_: bool;
    var phi_5506_: bool;
    var phi_5510_: f64;
    var phi_5511_: f64;
    var phi_5513_: type_43;
    var phi_5544_: f64;
    var phi_5551_: f64;
    var phi_5556_: f64;
    var phi_5563_: f64;
    var phi_5568_: f64;
    var phi_5581_: f64;
    var phi_5588_: f64;
    var phi_5593_: f64;
    var phi_5600_: f64;
    var phi_5605_: f64;
    var phi_5610_: f64;
    var phi_5669_: f64;
    var phi_5675_: f64;
    var phi_5680_: f64;
    var phi_5686_: f64;
    var phi_5691_: f64;
    var phi_5705_: f64;
    var phi_5711_: f64;
    var phi_5716_: f64;
    var phi_5722_: f64;
    var phi_5727_: f64;
    var phi_5753_: f64;
    var phi_5760_: f64;
    var phi_5765_: f64;
    var phi_5772_: f64;
    var phi_5777_: f64;
    var phi_5790_: f64;
    var phi_5797_: f64;
    var phi_5802_: f64;
    var phi_5809_: f64;
    var phi_5814_: f64;
    var phi_5819_: f64;
    var phi_5878_: f64;
    var phi_5884_: f64;
    var phi_5889_: f64;
    var phi_5895_: f64;
    var phi_5900_: f64;
    var phi_5914_: f64;
    var phi_5920_: f64;
    var phi_5925_: f64;
    var phi_5931_: f64;
    var phi_5936_: f64;
    var phi_5962_: f64;
    var phi_5969_: f64;
    var phi_5974_: f64;
    var phi_5981_: f64;
    var phi_5986_: f64;
    var phi_5999_: f64;
    var phi_6006_: f64;
    var phi_6011_: f64;
    var phi_6018_: f64;
    var phi_6023_: f64;
    var phi_6028_: f64;
    var phi_6087_: f64;
    var phi_6093_: f64;
    var phi_6098_: f64;
    var phi_6104_: f64;
    var phi_6109_: f64;
    var phi_6123_: f64;
    var phi_6129_: f64;
    var phi_6134_: f64;
    var phi_6140_: f64;
    var phi_6145_: f64;
    var phi_6194_: f64;
    var phi_6200_: f64;
    var phi_6228_: f64;
    var phi_6234_: f64;
    var phi_6239_: u32;
    var phi_6240_: u32;
    var phi_6210_: f64;
    var phi_6216_: f64;
    var phi_6221_: u32;
    var phi_6222_: u32;
    var phi_6241_: u32;
    var phi_6242_: u32;
    var phi_6315_: f64;
    var phi_6327_: f64;
    var phi_6470_: f64;
    var phi_6476_: f64;
    var phi_6483_: f64;
    var phi_6527_: type_19;
    var phi_6530_: bool;
    var phi_6528_: type_19;
    var phi_6553_: type_19;
    var phi_6580_: bool;
    var phi_6581_: bool;
    var phi_6531_: bool;
    var phi_6582_: bool;
    var phi_6583_: bool;
    var local_16: bool;
    var phi_6587_: bool;
    var local_17: bool;
    var phi_6594_: u32;
    var phi_6595_: u32;
    var phi_6596_: bool;
    var phi_6597_: u32;
    var phi_6598_: u32;
    var phi_6599_: bool;
    var phi_6603_: u32;
    var phi_6624_: bool;
    var phi_6625_: bool;
    var phi_6626_: bool;
    var phi_6775_: f64;
    var phi_6782_: f64;
    var phi_6787_: f64;
    var phi_6794_: f64;
    var phi_6799_: f64;
    var phi_6812_: f64;
    var phi_6819_: f64;
    var phi_6824_: f64;
    var phi_6831_: f64;
    var phi_6836_: f64;
    var phi_6841_: f64;
    var phi_6858_: f64;
    var phi_6865_: f64;
    var phi_6870_: f64;
    var phi_6877_: f64;
    var phi_6882_: f64;
    var phi_6896_: f64;
    var phi_6903_: f64;
    var phi_6908_: f64;
    var phi_6915_: f64;
    var phi_6920_: f64;
    var phi_6925_: f64;
    var phi_6942_: f64;
    var phi_6949_: f64;
    var phi_6954_: f64;
    var phi_6961_: f64;
    var phi_6966_: f64;
    var phi_6980_: f64;
    var phi_6987_: f64;
    var phi_6992_: f64;
    var phi_6999_: f64;
    var phi_7004_: f64;
    var phi_7009_: f64;
    var phi_7053_: type_19;
    var phi_7056_: f64;
    var phi_7058_: f64;
    var phi_7060_: f64;
    var phi_7054_: type_19;
    var phi_7083_: type_19;
    var phi_7195_: f64;
    var phi_7202_: f64;
    var phi_7210_: f64;
    var phi_7256_: type_17;
    var phi_7259_: f64;
    var phi_7280_: bool;
    var phi_7286_: type_18;
    var phi_7257_: type_17;
    var phi_7300_: type_18;
    var phi_7260_: f64;
    var local_18: f64;
    var phi_7249_: f64;
    var phi_7313_: f64;
    var phi_7382_: f64;
    var phi_7388_: f64;
    var phi_7397_: f64;
    var phi_7403_: f64;
    var phi_7412_: f64;
    var phi_7418_: f64;
    var phi_7427_: f64;
    var phi_7433_: f64;
    var phi_7439_: type_32;
    var phi_7440_: bool;
    var phi_7441_: type_32;
    var phi_7442_: bool;
    var phi_7452_: type_32;
    var phi_7623_: bool;
    var phi_7624_: bool;
    var phi_7625_: bool;
    var phi_7626_: bool;
    var phi_7627_: bool;
    var phi_7628_: bool;
    var phi_7632_: bool;
    var phi_7930_: bool;
    var phi_7931_: bool;
    var phi_7932_: bool;
    var phi_7933_: bool;
    var phi_7934_: bool;
    var phi_7935_: bool;
    var phi_7939_: bool;
    var phi_7943_: bool;
    var phi_7955_: bool;
    var phi_7956_: bool;
    var phi_8030_: bool;
    var phi_8031_: bool;
    var phi_8054_: f64;
    var phi_8055_: bool;
    var phi_8056_: f64;
    var phi_8057_: bool;
    var phi_8058_: f64;
    var phi_8059_: bool;
    var phi_8060_: bool;
    var phi_8065_: f64;
    var phi_8066_: bool;
    var phi_8070_: f64;
    var phi_8102_: bool;
    var phi_8103_: bool;
    var phi_8126_: f64;
    var phi_8127_: bool;
    var phi_8128_: f64;
    var phi_8129_: bool;
    var phi_8130_: f64;
    var phi_8131_: bool;
    var phi_8132_: bool;
    var phi_8137_: f64;
    var phi_8138_: bool;
    var phi_8142_: f64;
    var phi_8147_: f64;
    var phi_8179_: bool;
    var phi_8180_: bool;
    var phi_8203_: f64;
    var phi_8204_: bool;
    var phi_8205_: f64;
    var phi_8206_: bool;
    var phi_8207_: f64;
    var phi_8208_: bool;
    var phi_8209_: bool;
    var phi_8214_: f64;
    var phi_8215_: bool;
    var phi_8219_: f64;
    var phi_8251_: bool;
    var phi_8252_: bool;
    var phi_8275_: f64;
    var phi_8276_: bool;
    var phi_8277_: f64;
    var phi_8278_: bool;
    var phi_8279_: f64;
    var phi_8280_: bool;
    var phi_8281_: bool;
    var phi_8286_: f64;
    var phi_8287_: bool;
    var phi_8291_: f64;
    var phi_8296_: f64;
    var phi_8301_: f64;
    var phi_8306_: f64;
    var phi_8317_: f64;
    var phi_8318_: f64;
    var phi_8319_: bool;
    var phi_8320_: f64;
    var phi_8321_: f64;
    var phi_8322_: bool;
    var phi_8323_: bool;
    var phi_8324_: bool;
    var phi_8325_: f64;
    var phi_8326_: f64;
    var phi_8327_: bool;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var phi_8330_: bool;
    var phi_8331_: f64;
    var phi_8332_: f64;
    var phi_8333_: bool;
    var phi_8334_: bool;
    var phi_8335_: bool;
    var phi_8336_: bool;
    var phi_8416_: f64;
    var phi_8489_: f64;
    var phi_8494_: f64;
    var phi_8567_: f64;
    var phi_8640_: f64;
    var phi_8645_: f64;
    var phi_8666_: f64;
    var phi_8667_: f64;
    var phi_8668_: f64;
    var phi_8670_: f64;
    var phi_8671_: bool;
    var phi_8672_: f64;
    var phi_8673_: f64;
    var phi_8674_: f64;
    var phi_8675_: bool;
    var phi_8676_: bool;
    var phi_8677_: bool;
    var phi_8678_: bool;
    var phi_8687_: f64;
    var phi_8692_: f64;
    var phi_8703_: bool;
    var phi_8707_: bool;
    var phi_8708_: f64;
    var phi_8709_: bool;
    var phi_8710_: bool;
    var phi_8711_: bool;
    var phi_8712_: bool;
    var phi_8713_: bool;
    var phi_7057_: f64;
    var phi_7059_: f64;
    var phi_7061_: f64;
    var phi_8714_: f64;
    var phi_8715_: bool;
    var phi_8716_: bool;
    var phi_8717_: bool;
    var phi_8718_: bool;
    var phi_8719_: bool;
    var phi_8720_: bool;
    var local_19: bool;
    var phi_8724_: f64;
    var phi_8725_: bool;
    var phi_8726_: bool;
    var phi_8727_: bool;
    var phi_8728_: bool;
    var phi_8733_: type_42;
    var phi_8734_: bool;
    var phi_8735_: bool;
    var phi_8736_: bool;
    var local_20: f64;
    var phi_8741_: type_42;
    var phi_8742_: bool;
    var phi_8743_: bool;
    var phi_8748_: type_42;
    var phi_8749_: bool;
    var phi_8750_: bool;
    var phi_8755_: type_42;
    var phi_8756_: bool;
    var phi_8760_: type_42;
    var phi_8767_: bool;
    var phi_8768_: f64;
    var phi_8769_: bool;
    var phi_8770_: bool;
    var phi_8771_: bool;
    var phi_8772_: f64;
    var phi_8773_: bool;
    var phi_8774_: bool;
    var phi_8775_: bool;
    var phi_8776_: f64;
    var phi_8777_: bool;
    var phi_8778_: bool;
    var phi_8779_: bool;
    var phi_8780_: bool;
    var phi_8784_: bool;
    var phi_8785_: bool;
    var phi_8786_: bool;
    var phi_8787_: f64;
    var phi_8788_: type_43;
    var phi_8789_: bool;
    var phi_8790_: bool;
    var phi_8791_: bool;
    var phi_8792_: bool;
    var local_21: bool;
    var phi_8797_: type_42;
    var phi_8798_: bool;
    var phi_8799_: bool;
    var local_22: f64;
    var phi_8804_: type_42;
    var phi_8805_: bool;
    var local_23: type_43;
    var phi_8811_: type_42;
    var phi_8812_: bool;
    var phi_8816_: type_42;
    var phi_2321_: f64;
    var phi_2328_: f64;
    var phi_2333_: f64;
    var phi_2340_: f64;
    var phi_2345_: f64;
    var phi_2358_: f64;
    var phi_2365_: f64;
    var phi_2370_: f64;
    var phi_2377_: f64;
    var phi_2382_: f64;
    var phi_2387_: f64;
    var phi_2404_: f64;
    var phi_2411_: f64;
    var phi_2416_: f64;
    var phi_2423_: f64;
    var phi_2428_: f64;
    var phi_2442_: f64;
    var phi_2449_: f64;
    var phi_2454_: f64;
    var phi_2461_: f64;
    var phi_2466_: f64;
    var phi_2471_: f64;
    var phi_2488_: f64;
    var phi_2495_: f64;
    var phi_2500_: f64;
    var phi_2507_: f64;
    var phi_2512_: f64;
    var phi_2526_: f64;
    var phi_2533_: f64;
    var phi_2538_: f64;
    var phi_2545_: f64;
    var phi_2550_: f64;
    var phi_2555_: f64;
    var phi_2599_: type_19;
    var phi_2602_: f64;
    var phi_2604_: f64;
    var phi_2606_: f64;
    var phi_2600_: type_19;
    var phi_2629_: type_19;
    var phi_2741_: f64;
    var phi_2748_: f64;
    var phi_2756_: f64;
    var phi_2802_: type_17;
    var phi_2805_: f64;
    var phi_2826_: bool;
    var phi_2832_: type_18;
    var phi_2803_: type_17;
    var phi_2846_: type_18;
    var phi_2806_: f64;
    var local_24: f64;
    var phi_2795_: f64;
    var phi_2859_: f64;
    var phi_2928_: f64;
    var phi_2934_: f64;
    var phi_2943_: f64;
    var phi_2949_: f64;
    var phi_2958_: f64;
    var phi_2964_: f64;
    var phi_2973_: f64;
    var phi_2979_: f64;
    var phi_2985_: type_32;
    var phi_2986_: bool;
    var phi_2987_: type_32;
    var phi_2988_: bool;
    var phi_2998_: type_32;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3178_: bool;
    var phi_3476_: bool;
    var phi_3477_: bool;
    var phi_3478_: bool;
    var phi_3479_: bool;
    var phi_3480_: bool;
    var phi_3481_: bool;
    var phi_3485_: bool;
    var phi_3489_: bool;
    var phi_3501_: bool;
    var phi_3502_: bool;
    var phi_3576_: bool;
    var phi_3577_: bool;
    var phi_3600_: f64;
    var phi_3601_: bool;
    var phi_3602_: f64;
    var phi_3603_: bool;
    var phi_3604_: f64;
    var phi_3605_: bool;
    var phi_3606_: bool;
    var phi_3611_: f64;
    var phi_3612_: bool;
    var phi_3616_: f64;
    var phi_3648_: bool;
    var phi_3649_: bool;
    var phi_3672_: f64;
    var phi_3673_: bool;
    var phi_3674_: f64;
    var phi_3675_: bool;
    var phi_3676_: f64;
    var phi_3677_: bool;
    var phi_3678_: bool;
    var phi_3683_: f64;
    var phi_3684_: bool;
    var phi_3688_: f64;
    var phi_3693_: f64;
    var phi_3725_: bool;
    var phi_3726_: bool;
    var phi_3749_: f64;
    var phi_3750_: bool;
    var phi_3751_: f64;
    var phi_3752_: bool;
    var phi_3753_: f64;
    var phi_3754_: bool;
    var phi_3755_: bool;
    var phi_3760_: f64;
    var phi_3761_: bool;
    var phi_3765_: f64;
    var phi_3797_: bool;
    var phi_3798_: bool;
    var phi_3821_: f64;
    var phi_3822_: bool;
    var phi_3823_: f64;
    var phi_3824_: bool;
    var phi_3825_: f64;
    var phi_3826_: bool;
    var phi_3827_: bool;
    var phi_3832_: f64;
    var phi_3833_: bool;
    var phi_3837_: f64;
    var phi_3842_: f64;
    var phi_3847_: f64;
    var phi_3852_: f64;
    var phi_3863_: f64;
    var phi_3864_: f64;
    var phi_3865_: bool;
    var phi_3866_: f64;
    var phi_3867_: f64;
    var phi_3868_: bool;
    var phi_3869_: bool;
    var phi_3870_: bool;
    var phi_3871_: f64;
    var phi_3872_: f64;
    var phi_3873_: bool;
    var phi_3874_: bool;
    var phi_3875_: bool;
    var phi_3876_: bool;
    var phi_3877_: f64;
    var phi_3878_: f64;
    var phi_3879_: bool;
    var phi_3880_: bool;
    var phi_3881_: bool;
    var phi_3882_: bool;
    var phi_3962_: f64;
    var phi_4035_: f64;
    var phi_4040_: f64;
    var phi_4113_: f64;
    var phi_4186_: f64;
    var phi_4191_: f64;
    var phi_4212_: f64;
    var phi_4213_: f64;
    var phi_4214_: f64;
    var phi_4216_: f64;
    var phi_4217_: bool;
    var phi_4218_: f64;
    var phi_4219_: f64;
    var phi_4220_: f64;
    var phi_4221_: bool;
    var phi_4222_: bool;
    var phi_4223_: bool;
    var phi_4224_: bool;
    var phi_4233_: f64;
    var phi_4238_: f64;
    var phi_4249_: bool;
    var phi_4253_: bool;
    var phi_4254_: f64;
    var phi_4255_: bool;
    var phi_4256_: bool;
    var phi_4257_: bool;
    var phi_4258_: bool;
    var phi_4259_: bool;
    var phi_2603_: f64;
    var phi_2605_: f64;
    var phi_2607_: f64;
    var phi_4260_: f64;
    var phi_4261_: bool;
    var phi_4262_: bool;
    var phi_4263_: bool;
    var phi_4264_: bool;
    var phi_4265_: bool;
    var phi_4266_: bool;
    var local_25: bool;
    var phi_4270_: f64;
    var phi_4271_: bool;
    var phi_4272_: bool;
    var phi_4273_: bool;
    var phi_4274_: bool;
    var phi_4279_: type_42;
    var phi_4280_: bool;
    var phi_4281_: bool;
    var phi_4282_: bool;
    var local_26: f64;
    var phi_4287_: type_42;
    var phi_4288_: bool;
    var phi_4289_: bool;
    var phi_4294_: type_42;
    var phi_4295_: bool;
    var phi_4296_: bool;
    var phi_4301_: type_42;
    var phi_4302_: bool;
    var phi_4306_: type_42;
    var phi_4320_: type_19;
    var phi_4321_: type_19;
    var phi_4344_: type_19;
    var phi_4365_: f64;
    var phi_4495_: type_17;
    var phi_4498_: f64;
    var phi_4519_: bool;
    var phi_4525_: type_18;
    var phi_4496_: type_17;
    var phi_4539_: type_18;
    var phi_4499_: f64;
    var local_27: f64;
    var phi_4488_: f64;
    var phi_4552_: f64;
    var phi_4570_: f64;
    var phi_4577_: f64;
    var phi_4582_: f64;
    var phi_4589_: f64;
    var phi_4594_: f64;
    var phi_4607_: f64;
    var phi_4614_: f64;
    var phi_4619_: f64;
    var phi_4626_: f64;
    var phi_4631_: f64;
    var phi_4636_: f64;
    var phi_4653_: f64;
    var phi_4660_: f64;
    var phi_4665_: f64;
    var phi_4672_: f64;
    var phi_4677_: f64;
    var phi_4691_: f64;
    var phi_4698_: f64;
    var phi_4703_: f64;
    var phi_4710_: f64;
    var phi_4715_: f64;
    var phi_4720_: f64;
    var phi_4737_: f64;
    var phi_4744_: f64;
    var phi_4749_: f64;
    var phi_4756_: f64;
    var phi_4761_: f64;
    var phi_4775_: f64;
    var phi_4782_: f64;
    var phi_4787_: f64;
    var phi_4794_: f64;
    var phi_4799_: f64;
    var phi_4804_: f64;
    var phi_4828_: bool;
    var phi_4829_: bool;
    var phi_4830_: bool;
    var local_28: bool;
    var phi_4835_: type_42;
    var phi_4836_: bool;
    var phi_4841_: type_42;
    var phi_4842_: bool;
    var phi_4844_: type_42;
    var phi_4845_: type_42;
    var phi_4846_: bool;
    var phi_4850_: type_42;
    var phi_8820_: type_42;
    var phi_8821_: type_42;
    var phi_8834_: type_30;
    var phi_8857_: u32;
    var phi_8861_: type_29;
    var phi_8862_: bool;
    var phi_8880_: u32;
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
    let _e127 = params.member.member_15;
    let _e129 = input.member[0u];
    if (_e127 < _e129) {
        phi_798_ = _e127;
    } else {
        phi_798_ = _e129;
    }
    let _e132 = phi_798_;
    let _e133 = (_e132 / 64u);
    if ((_e132 % 64u) > 0u) {
        phi_814_ = (_e133 + 1u);
    } else {
        phi_814_ = _e133;
    }
    let _e138 = phi_814_;
    if (_e138 > _e122) {
        let _e140 = (_e138 - _e122);
        if (_e125 == 0u) {
            return;
        }
        let _e142 = (_e140 / _e125);
        if (_e125 == 0u) {
            return;
        }
        if ((_e140 % _e125) > 0u) {
            phi_835_ = (_e142 + 1u);
        } else {
            phi_835_ = _e142;
        }
        let _e148 = phi_835_;
        phi_836_ = _e148;
    } else {
        phi_836_ = 0u;
    }
    let _e150 = phi_836_;
    phi_839_ = type_19(0u, _e150);
    loop {
        let _e153 = phi_839_;
        if (_e153.member < _e153.member_1) {
            phi_840_ = type_19((_e153.member + 1u), _e153.member_1);
            phi_863_ = type_19(1u, _e153.member);
        } else {
            phi_840_ = _e153;
            phi_863_ = type_19(0u, type_19().member_1);
        }
        let _e165 = phi_840_;
        let _e167 = phi_863_;
        let _e171 = (bitcast<i32>(_e167.member) != 0i);
        if _e171 {
            let _e175 = (((_e122 + (_e167.member_1 * _e125)) * 64u) + _e110);
            let _e177 = params.member.member_8;
            if (_e175 < _e132) {
                let _e180 = (2u * _e175);
                let _e183 = input.member[(4u + _e180)];
                let _e186 = input.member[(_e180 + 5u)];
                let _e188 = elements.member[_e186];
                let _e193 = params.member.member_1;
                if ((_e193 & 8u) != 0u) {
                    let _e232 = paths.member[_e183];
                    let _e234 = paths.member[_e188[0]];
                    let _e240 = paths.member[_e188[1]];
                    let _e242 = paths.member[_e188[2]];
                    let _e279 = function_(array<f32, 3>(_e232.member[0], _e232.member[1], _e232.member[2]));
                    let _e280 = function_(array<f32, 3>(_e234.member[0], _e234.member[1], _e234.member[2]));
                    let _e281 = function_(array<f32, 3>(_e240.member[0], _e240.member[1], _e240.member[2]));
                    let _e282 = function_(array<f32, 3>(_e242.member[0], _e242.member[1], _e242.member[2]));
                    let _e284 = function_(array<f32, 3>(_e232.member_1[0], _e232.member_1[1], _e232.member_1[2]));
                    let _e285 = function_(array<f32, 3>(_e234.member_1[0], _e234.member_1[1], _e234.member_1[2]));
                    let _e286 = function_(array<f32, 3>(_e240.member_1[0], _e240.member_1[1], _e240.member_1[2]));
                    let _e287 = function_(array<f32, 3>(_e242.member_1[0], _e242.member_1[1], _e242.member_1[2]));
                    phi_1111_ = type_40(array<array<f64, 3>, 4>(_e279, _e280, _e281, _e282), array<array<f64, 3>, 4>(_e284, _e285, _e286, _e287));
                } else {
                    let _e197 = wide.member[_e183];
                    let _e200 = params.member.member[0u];
                    let _e203 = wide.member[(_e200 + _e183)];
                    let _e205 = wide.member[_e188[0]];
                    let _e208 = params.member.member[0u];
                    let _e211 = wide.member[(_e208 + _e188[0])];
                    let _e213 = wide.member[_e188[1]];
                    let _e216 = params.member.member[0u];
                    let _e219 = wide.member[(_e216 + _e188[1])];
                    let _e221 = wide.member[_e188[2]];
                    let _e224 = params.member.member[0u];
                    let _e227 = wide.member[(_e224 + _e188[2])];
                    phi_1111_ = type_40(array<array<f64, 3>, 4>(_e197, _e205, _e213, _e221), array<array<f64, 3>, 4>(_e203, _e211, _e219, _e227));
                }
                let _e291 = phi_1111_;
                let _e298 = (_e291.member[0][0] - _e291.member[1][0]);
                let _e301 = (_e291.member[0][1] - _e291.member[1][1]);
                let _e304 = (_e291.member[0][2] - _e291.member[1][2]);
                let _e310 = (_e291.member_1[0][0] - _e291.member_1[1][0]);
                let _e313 = (_e291.member_1[0][1] - _e291.member_1[1][1]);
                let _e316 = (_e291.member_1[0][2] - _e291.member_1[1][2]);
                let _e323 = (_e291.member[2][0] - _e291.member[1][0]);
                let _e326 = (_e291.member[2][1] - _e291.member[1][1]);
                let _e329 = (_e291.member[2][2] - _e291.member[1][2]);
                let _e335 = (_e291.member_1[2][0] - _e291.member_1[1][0]);
                let _e338 = (_e291.member_1[2][1] - _e291.member_1[1][1]);
                let _e341 = (_e291.member_1[2][2] - _e291.member_1[1][2]);
                let _e348 = (_e291.member[3][0] - _e291.member[1][0]);
                let _e351 = (_e291.member[3][1] - _e291.member[1][1]);
                let _e354 = (_e291.member[3][2] - _e291.member[1][2]);
                let _e360 = (_e291.member_1[3][0] - _e291.member_1[1][0]);
                let _e363 = (_e291.member_1[3][1] - _e291.member_1[1][1]);
                let _e366 = (_e291.member_1[3][2] - _e291.member_1[1][2]);
                let _e369 = (0.0lf + 0.0lf);
                let _e372 = params.member.member_7;
                let _e379 = bitcast<f64>(((u64(_e372[1]) * 4294967296lu) + u64(_e372[0])));
                if (_e298 < 0.0lf) {
                    phi_1205_ = -(_e298);
                } else {
                    phi_1205_ = _e298;
                }
                let _e383 = phi_1205_;
                if (_e301 < 0.0lf) {
                    phi_1211_ = -(_e301);
                } else {
                    phi_1211_ = _e301;
                }
                let _e387 = phi_1211_;
                if (_e383 > _e387) {
                    phi_1216_ = _e383;
                } else {
                    phi_1216_ = _e387;
                }
                let _e390 = phi_1216_;
                if (_e304 < 0.0lf) {
                    phi_1222_ = -(_e304);
                } else {
                    phi_1222_ = _e304;
                }
                let _e394 = phi_1222_;
                if (_e390 > _e394) {
                    phi_1227_ = _e390;
                } else {
                    phi_1227_ = _e394;
                }
                let _e397 = phi_1227_;
                if (_e310 < 0.0lf) {
                    phi_1233_ = -(_e310);
                } else {
                    phi_1233_ = _e310;
                }
                let _e401 = phi_1233_;
                if (_e313 < 0.0lf) {
                    phi_1239_ = -(_e313);
                } else {
                    phi_1239_ = _e313;
                }
                let _e405 = phi_1239_;
                if (_e401 > _e405) {
                    phi_1244_ = _e401;
                } else {
                    phi_1244_ = _e405;
                }
                let _e408 = phi_1244_;
                if (_e316 < 0.0lf) {
                    phi_1250_ = -(_e316);
                } else {
                    phi_1250_ = _e316;
                }
                let _e412 = phi_1250_;
                if (_e408 > _e412) {
                    phi_1255_ = _e408;
                } else {
                    phi_1255_ = _e412;
                }
                let _e415 = phi_1255_;
                if (_e397 > _e415) {
                    phi_1260_ = _e397;
                } else {
                    phi_1260_ = _e415;
                }
                let _e418 = phi_1260_;
                let _e419 = (_e418 + _e369);
                if (_e323 < 0.0lf) {
                    phi_1267_ = -(_e323);
                } else {
                    phi_1267_ = _e323;
                }
                let _e423 = phi_1267_;
                if (_e326 < 0.0lf) {
                    phi_1273_ = -(_e326);
                } else {
                    phi_1273_ = _e326;
                }
                let _e427 = phi_1273_;
                if (_e423 > _e427) {
                    phi_1278_ = _e423;
                } else {
                    phi_1278_ = _e427;
                }
                let _e430 = phi_1278_;
                if (_e329 < 0.0lf) {
                    phi_1284_ = -(_e329);
                } else {
                    phi_1284_ = _e329;
                }
                let _e434 = phi_1284_;
                if (_e430 > _e434) {
                    phi_1289_ = _e430;
                } else {
                    phi_1289_ = _e434;
                }
                let _e437 = phi_1289_;
                if (_e335 < 0.0lf) {
                    phi_1295_ = -(_e335);
                } else {
                    phi_1295_ = _e335;
                }
                let _e441 = phi_1295_;
                if (_e338 < 0.0lf) {
                    phi_1301_ = -(_e338);
                } else {
                    phi_1301_ = _e338;
                }
                let _e445 = phi_1301_;
                if (_e441 > _e445) {
                    phi_1306_ = _e441;
                } else {
                    phi_1306_ = _e445;
                }
                let _e448 = phi_1306_;
                if (_e341 < 0.0lf) {
                    phi_1312_ = -(_e341);
                } else {
                    phi_1312_ = _e341;
                }
                let _e452 = phi_1312_;
                if (_e448 > _e452) {
                    phi_1317_ = _e448;
                } else {
                    phi_1317_ = _e452;
                }
                let _e455 = phi_1317_;
                if (_e437 > _e455) {
                    phi_1322_ = _e437;
                } else {
                    phi_1322_ = _e455;
                }
                let _e458 = phi_1322_;
                let _e459 = (_e458 + _e369);
                if (_e348 < 0.0lf) {
                    phi_1329_ = -(_e348);
                } else {
                    phi_1329_ = _e348;
                }
                let _e463 = phi_1329_;
                if (_e351 < 0.0lf) {
                    phi_1335_ = -(_e351);
                } else {
                    phi_1335_ = _e351;
                }
                let _e467 = phi_1335_;
                if (_e463 > _e467) {
                    phi_1340_ = _e463;
                } else {
                    phi_1340_ = _e467;
                }
                let _e470 = phi_1340_;
                if (_e354 < 0.0lf) {
                    phi_1346_ = -(_e354);
                } else {
                    phi_1346_ = _e354;
                }
                let _e474 = phi_1346_;
                if (_e470 > _e474) {
                    phi_1351_ = _e470;
                } else {
                    phi_1351_ = _e474;
                }
                let _e477 = phi_1351_;
                if (_e360 < 0.0lf) {
                    phi_1357_ = -(_e360);
                } else {
                    phi_1357_ = _e360;
                }
                let _e481 = phi_1357_;
                if (_e363 < 0.0lf) {
                    phi_1363_ = -(_e363);
                } else {
                    phi_1363_ = _e363;
                }
                let _e485 = phi_1363_;
                if (_e481 > _e485) {
                    phi_1368_ = _e481;
                } else {
                    phi_1368_ = _e485;
                }
                let _e488 = phi_1368_;
                if (_e366 < 0.0lf) {
                    phi_1374_ = -(_e366);
                } else {
                    phi_1374_ = _e366;
                }
                let _e492 = phi_1374_;
                if (_e488 > _e492) {
                    phi_1379_ = _e488;
                } else {
                    phi_1379_ = _e492;
                }
                let _e495 = phi_1379_;
                if (_e477 > _e495) {
                    phi_1384_ = _e477;
                } else {
                    phi_1384_ = _e495;
                }
                let _e498 = phi_1384_;
                let _e499 = (_e498 + _e369);
                if (_e419 > _e459) {
                    phi_1390_ = _e419;
                } else {
                    phi_1390_ = _e459;
                }
                let _e502 = phi_1390_;
                if (_e502 > _e499) {
                    phi_1395_ = _e502;
                } else {
                    phi_1395_ = _e499;
                }
                let _e505 = phi_1395_;
                if (_e505 <= f64(65536f)) {
                    phi_1404_ = (_e505 >= f64((1f / 65536f)));
                } else {
                    phi_1404_ = false;
                }
                let _e512 = phi_1404_;
                if _e512 {
                    phi_1476_ = type_41();
                    phi_1477_ = true;
                } else {
                    if (_e505 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e505) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e519 = (9214364837600034816lu - (bitcast<u64>(_e505) & 9218868437227405312lu));
                            if (_e519 > 4503599627370496lu) {
                                phi_1428_ = _e519;
                            } else {
                                phi_1428_ = 4503599627370496lu;
                            }
                            let _e522 = phi_1428_;
                            let _e523 = bitcast<f64>(_e522);
                            let _e524 = (_e379 * _e523);
                            if (_e379 > f64(0f)) {
                                if (_e524 > 2.2250738585072014e-308lf) {
                                    phi_1440_ = _e524;
                                } else {
                                    phi_1440_ = 2.2250738585072014e-308lf;
                                }
                                let _e529 = phi_1440_;
                                phi_1441_ = _e529;
                            } else {
                                phi_1441_ = _e524;
                            }
                            let _e531 = phi_1441_;
                            phi_1472_ = type_41(type_38(array<array<f64, 3>, 2>(array<f64, 3>((_e298 * _e523), (_e301 * _e523), (_e304 * _e523)), array<f64, 3>((_e310 * _e523), (_e313 * _e523), (_e316 * _e523))), array<array<f64, 3>, 2>(array<f64, 3>((_e323 * _e523), (_e326 * _e523), (_e329 * _e523)), array<f64, 3>((_e335 * _e523), (_e338 * _e523), (_e341 * _e523))), array<array<f64, 3>, 2>(array<f64, 3>((_e348 * _e523), (_e351 * _e523), (_e354 * _e523)), array<f64, 3>((_e360 * _e523), (_e363 * _e523), (_e366 * _e523))), (_e369 * _e523)), _e531);
                            phi_1473_ = false;
                        } else {
                            phi_1472_ = type_41();
                            phi_1473_ = true;
                        }
                        let _e563 = phi_1472_;
                        let _e565 = phi_1473_;
                        phi_1474_ = _e563;
                        phi_1475_ = _e565;
                    } else {
                        phi_1474_ = type_41();
                        phi_1475_ = true;
                    }
                    let _e567 = phi_1474_;
                    let _e569 = phi_1475_;
                    phi_1476_ = _e567;
                    phi_1477_ = _e569;
                }
                let _e571 = phi_1476_;
                let _e573 = phi_1477_;
                if _e573 {
                    phi_1482_ = type_41(type_38(array<array<f64, 3>, 2>(array<f64, 3>(_e298, _e301, _e304), array<f64, 3>(_e310, _e313, _e316)), array<array<f64, 3>, 2>(array<f64, 3>(_e323, _e326, _e329), array<f64, 3>(_e335, _e338, _e341)), array<array<f64, 3>, 2>(array<f64, 3>(_e348, _e351, _e354), array<f64, 3>(_e360, _e363, _e366)), _e369), _e379);
                } else {
                    phi_1482_ = _e571;
                }
                let _e576 = phi_1482_;
                local_12 = type_38(array<array<f64, 3>, 2>(array<f64, 3>(_e576.member.member[0][0], _e576.member.member[0][1], _e576.member.member[0][2]), array<f64, 3>(_e576.member.member[1][0], _e576.member.member[1][1], _e576.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e576.member.member_1[0][0], _e576.member.member_1[0][1], _e576.member.member_1[0][2]), array<f64, 3>(_e576.member.member_1[1][0], _e576.member.member_1[1][1], _e576.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e576.member.member_2[0][0], _e576.member.member_2[0][1], _e576.member.member_2[0][2]), array<f64, 3>(_e576.member.member_2[1][0], _e576.member.member_2[1][1], _e576.member.member_2[1][2])), _e576.member.member_3);
                let _e619 = local_12.member_1[0u];
                let _e625 = local_12.member_2[0u];
                let _e631 = ((_e619[1] * _e625[2]) - (_e619[2] * _e625[1]));
                let _e634 = ((_e619[2] * _e625[0]) - (_e619[0] * _e625[2]));
                let _e637 = ((_e619[0] * _e625[1]) - (_e619[1] * _e625[0]));
                let _e640 = local_12.member_1[1u];
                let _e646 = local_12.member_2[1u];
                let _e652 = ((_e640[1] * _e646[2]) - (_e640[2] * _e646[1]));
                let _e655 = ((_e640[2] * _e646[0]) - (_e640[0] * _e646[2]));
                let _e658 = ((_e640[0] * _e646[1]) - (_e640[1] * _e646[0]));
                let _e661 = local_12.member_1[0u];
                let _e667 = local_12.member_2[1u];
                let _e682 = local_12.member_1[1u];
                let _e688 = local_12.member_2[0u];
                let _e701 = (((_e661[1] * _e667[2]) - (_e661[2] * _e667[1])) + ((_e682[1] * _e688[2]) - (_e682[2] * _e688[1])));
                let _e702 = (((_e661[2] * _e667[0]) - (_e661[0] * _e667[2])) + ((_e682[2] * _e688[0]) - (_e682[0] * _e688[2])));
                let _e703 = (((_e661[0] * _e667[1]) - (_e661[1] * _e667[0])) + ((_e682[0] * _e688[1]) - (_e682[1] * _e688[0])));
                let _e706 = local_12.member[0u];
                let _e714 = (((_e706[0] * _e631) + (_e706[1] * _e634)) + (_e706[2] * _e637));
                let _e717 = local_12.member[1u];
                let _e728 = local_12.member[0u];
                let _e737 = ((((_e717[0] * _e631) + (_e717[1] * _e634)) + (_e717[2] * _e637)) + (((_e728[0] * _e701) + (_e728[1] * _e702)) + (_e728[2] * _e703)));
                let _e740 = local_12.member[0u];
                let _e751 = local_12.member[1u];
                let _e760 = ((((_e740[0] * _e652) + (_e740[1] * _e655)) + (_e740[2] * _e658)) + (((_e751[0] * _e701) + (_e751[1] * _e702)) + (_e751[2] * _e703)));
                let _e763 = local_12.member[1u];
                let _e771 = (((_e763[0] * _e652) + (_e763[1] * _e655)) + (_e763[2] * _e658));
                let _e774 = local_12.member[0u];
                if (_e774[0] < 0.0lf) {
                    phi_1764_ = -(_e774[0]);
                } else {
                    phi_1764_ = _e774[0];
                }
                let _e781 = phi_1764_;
                if (_e774[1] < 0.0lf) {
                    phi_1771_ = -(_e774[1]);
                } else {
                    phi_1771_ = _e774[1];
                }
                let _e785 = phi_1771_;
                if (_e781 > _e785) {
                    phi_1776_ = _e781;
                } else {
                    phi_1776_ = _e785;
                }
                let _e788 = phi_1776_;
                if (_e774[2] < 0.0lf) {
                    phi_1783_ = -(_e774[2]);
                } else {
                    phi_1783_ = _e774[2];
                }
                let _e792 = phi_1783_;
                if (_e788 > _e792) {
                    phi_1788_ = _e788;
                } else {
                    phi_1788_ = _e792;
                }
                let _e795 = phi_1788_;
                let _e798 = local_12.member[1u];
                if (_e798[0] < 0.0lf) {
                    phi_1801_ = -(_e798[0]);
                } else {
                    phi_1801_ = _e798[0];
                }
                let _e805 = phi_1801_;
                if (_e798[1] < 0.0lf) {
                    phi_1808_ = -(_e798[1]);
                } else {
                    phi_1808_ = _e798[1];
                }
                let _e809 = phi_1808_;
                if (_e805 > _e809) {
                    phi_1813_ = _e805;
                } else {
                    phi_1813_ = _e809;
                }
                let _e812 = phi_1813_;
                if (_e798[2] < 0.0lf) {
                    phi_1820_ = -(_e798[2]);
                } else {
                    phi_1820_ = _e798[2];
                }
                let _e816 = phi_1820_;
                if (_e812 > _e816) {
                    phi_1825_ = _e812;
                } else {
                    phi_1825_ = _e816;
                }
                let _e819 = phi_1825_;
                if (_e795 > _e819) {
                    phi_1830_ = _e795;
                } else {
                    phi_1830_ = _e819;
                }
                let _e822 = phi_1830_;
                let _e824 = local_12.member_3;
                let _e825 = (_e822 + _e824);
                let _e828 = local_12.member_1[0u];
                if (_e828[0] < 0.0lf) {
                    phi_1847_ = -(_e828[0]);
                } else {
                    phi_1847_ = _e828[0];
                }
                let _e835 = phi_1847_;
                if (_e828[1] < 0.0lf) {
                    phi_1854_ = -(_e828[1]);
                } else {
                    phi_1854_ = _e828[1];
                }
                let _e839 = phi_1854_;
                if (_e835 > _e839) {
                    phi_1859_ = _e835;
                } else {
                    phi_1859_ = _e839;
                }
                let _e842 = phi_1859_;
                if (_e828[2] < 0.0lf) {
                    phi_1866_ = -(_e828[2]);
                } else {
                    phi_1866_ = _e828[2];
                }
                let _e846 = phi_1866_;
                if (_e842 > _e846) {
                    phi_1871_ = _e842;
                } else {
                    phi_1871_ = _e846;
                }
                let _e849 = phi_1871_;
                let _e852 = local_12.member_1[1u];
                if (_e852[0] < 0.0lf) {
                    phi_1885_ = -(_e852[0]);
                } else {
                    phi_1885_ = _e852[0];
                }
                let _e859 = phi_1885_;
                if (_e852[1] < 0.0lf) {
                    phi_1892_ = -(_e852[1]);
                } else {
                    phi_1892_ = _e852[1];
                }
                let _e863 = phi_1892_;
                if (_e859 > _e863) {
                    phi_1897_ = _e859;
                } else {
                    phi_1897_ = _e863;
                }
                let _e866 = phi_1897_;
                if (_e852[2] < 0.0lf) {
                    phi_1904_ = -(_e852[2]);
                } else {
                    phi_1904_ = _e852[2];
                }
                let _e870 = phi_1904_;
                if (_e866 > _e870) {
                    phi_1909_ = _e866;
                } else {
                    phi_1909_ = _e870;
                }
                let _e873 = phi_1909_;
                if (_e849 > _e873) {
                    phi_1914_ = _e849;
                } else {
                    phi_1914_ = _e873;
                }
                let _e876 = phi_1914_;
                let _e878 = local_12.member_3;
                let _e879 = (_e876 + _e878);
                let _e882 = local_12.member_2[0u];
                if (_e882[0] < 0.0lf) {
                    phi_1931_ = -(_e882[0]);
                } else {
                    phi_1931_ = _e882[0];
                }
                let _e889 = phi_1931_;
                if (_e882[1] < 0.0lf) {
                    phi_1938_ = -(_e882[1]);
                } else {
                    phi_1938_ = _e882[1];
                }
                let _e893 = phi_1938_;
                if (_e889 > _e893) {
                    phi_1943_ = _e889;
                } else {
                    phi_1943_ = _e893;
                }
                let _e896 = phi_1943_;
                if (_e882[2] < 0.0lf) {
                    phi_1950_ = -(_e882[2]);
                } else {
                    phi_1950_ = _e882[2];
                }
                let _e900 = phi_1950_;
                if (_e896 > _e900) {
                    phi_1955_ = _e896;
                } else {
                    phi_1955_ = _e900;
                }
                let _e903 = phi_1955_;
                let _e906 = local_12.member_2[1u];
                if (_e906[0] < 0.0lf) {
                    phi_1969_ = -(_e906[0]);
                } else {
                    phi_1969_ = _e906[0];
                }
                let _e913 = phi_1969_;
                if (_e906[1] < 0.0lf) {
                    phi_1976_ = -(_e906[1]);
                } else {
                    phi_1976_ = _e906[1];
                }
                let _e917 = phi_1976_;
                if (_e913 > _e917) {
                    phi_1981_ = _e913;
                } else {
                    phi_1981_ = _e917;
                }
                let _e920 = phi_1981_;
                if (_e906[2] < 0.0lf) {
                    phi_1988_ = -(_e906[2]);
                } else {
                    phi_1988_ = _e906[2];
                }
                let _e924 = phi_1988_;
                if (_e920 > _e924) {
                    phi_1993_ = _e920;
                } else {
                    phi_1993_ = _e924;
                }
                let _e927 = phi_1993_;
                if (_e903 > _e927) {
                    phi_1998_ = _e903;
                } else {
                    phi_1998_ = _e927;
                }
                let _e930 = phi_1998_;
                let _e932 = local_12.member_3;
                let _e933 = (_e930 + _e932);
                let _e934 = f64(1f);
                let _e935 = f64(8f);
                let _e937 = ((_e879 * _e935) * _e933);
                let _e945 = local_12.member_3;
                if (_e631 < 0.0lf) {
                    phi_2035_ = -(_e631);
                } else {
                    phi_2035_ = _e631;
                }
                let _e965 = phi_2035_;
                if (_e634 < 0.0lf) {
                    phi_2041_ = -(_e634);
                } else {
                    phi_2041_ = _e634;
                }
                let _e969 = phi_2041_;
                if (_e637 < 0.0lf) {
                    phi_2048_ = -(_e637);
                } else {
                    phi_2048_ = _e637;
                }
                let _e974 = phi_2048_;
                let _e975 = ((_e965 + _e969) + _e974);
                if (_e652 < 0.0lf) {
                    phi_2055_ = -(_e652);
                } else {
                    phi_2055_ = _e652;
                }
                let _e979 = phi_2055_;
                if (_e655 < 0.0lf) {
                    phi_2061_ = -(_e655);
                } else {
                    phi_2061_ = _e655;
                }
                let _e983 = phi_2061_;
                if (_e658 < 0.0lf) {
                    phi_2068_ = -(_e658);
                } else {
                    phi_2068_ = _e658;
                }
                let _e988 = phi_2068_;
                let _e989 = ((_e979 + _e983) + _e988);
                if (_e975 > _e989) {
                    phi_2074_ = _e975;
                } else {
                    phi_2074_ = _e989;
                }
                let _e992 = phi_2074_;
                if (_e701 < 0.0lf) {
                    phi_2080_ = -(_e701);
                } else {
                    phi_2080_ = _e701;
                }
                let _e996 = phi_2080_;
                if (_e702 < 0.0lf) {
                    phi_2086_ = -(_e702);
                } else {
                    phi_2086_ = _e702;
                }
                let _e1000 = phi_2086_;
                if (_e703 < 0.0lf) {
                    phi_2093_ = -(_e703);
                } else {
                    phi_2093_ = _e703;
                }
                let _e1005 = phi_2093_;
                let _e1007 = (((_e996 + _e1000) + _e1005) * f64(0.5f));
                if (_e992 > _e1007) {
                    phi_2100_ = _e992;
                } else {
                    phi_2100_ = _e1007;
                }
                let _e1010 = phi_2100_;
                let _e1016 = local_12.member_3;
                let _e1030 = (((((_e825 * _e935) * _e937) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e945 * f64(19f)) * ((_e825 * (_e879 + _e933)) + (_e879 * _e933)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e934 + _e825) * ((_e934 + _e879) * (_e934 + _e933)))));
                let _e1031 = f64(3f);
                let _e1032 = (_e714 * _e1031);
                let _e1033 = (_e771 * _e1031);
                if (_e1032 < _e1033) {
                    phi_2128_ = _e1032;
                } else {
                    phi_2128_ = _e1033;
                }
                let _e1036 = phi_2128_;
                if (_e737 < _e760) {
                    phi_2133_ = _e737;
                } else {
                    phi_2133_ = _e760;
                }
                let _e1039 = phi_2133_;
                if (_e1036 < _e1039) {
                    phi_2138_ = _e1036;
                } else {
                    phi_2138_ = _e1039;
                }
                let _e1042 = phi_2138_;
                if (_e1032 > _e1033) {
                    phi_2143_ = _e1032;
                } else {
                    phi_2143_ = _e1033;
                }
                let _e1045 = phi_2143_;
                if (_e737 > _e760) {
                    phi_2148_ = _e737;
                } else {
                    phi_2148_ = _e760;
                }
                let _e1048 = phi_2148_;
                if (_e1045 > _e1048) {
                    phi_2153_ = _e1045;
                } else {
                    phi_2153_ = _e1048;
                }
                let _e1051 = phi_2153_;
                let _e1057 = -(_e1051);
                if (_e1042 > _e1057) {
                    phi_2164_ = _e1042;
                } else {
                    phi_2164_ = _e1057;
                }
                let _e1060 = phi_2164_;
                if ((_e1060 - (_e1030 + ((_e576.member_1 * (((_e1010 + (_e937 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1016 * f64(6f)) * (_e879 + _e933))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e934 + _e879) * (_e934 + _e933))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8821_ = type_42(0u, type_42().member_1);
                } else {
                    if (_e576.member_1 > f64(0f)) {
                        let _e3713 = f64(1f);
                        let _e3714 = f64(0f);
                        let _e3717 = local_12.member[0u];
                        let _e3723 = local_12.member_1[0u];
                        let _e3729 = local_12.member_2[0u];
                        let _e3741 = local_12.member[1u];
                        let _e3747 = local_12.member_1[1u];
                        let _e3753 = local_12.member_2[1u];
                        let _e3765 = local_12.member[0u];
                        if (_e3765[0] < 0.0lf) {
                            phi_2321_ = -(_e3765[0]);
                        } else {
                            phi_2321_ = _e3765[0];
                        }
                        let _e3772 = phi_2321_;
                        if (_e3765[1] < 0.0lf) {
                            phi_2328_ = -(_e3765[1]);
                        } else {
                            phi_2328_ = _e3765[1];
                        }
                        let _e3776 = phi_2328_;
                        if (_e3772 > _e3776) {
                            phi_2333_ = _e3772;
                        } else {
                            phi_2333_ = _e3776;
                        }
                        let _e3779 = phi_2333_;
                        if (_e3765[2] < 0.0lf) {
                            phi_2340_ = -(_e3765[2]);
                        } else {
                            phi_2340_ = _e3765[2];
                        }
                        let _e3783 = phi_2340_;
                        if (_e3779 > _e3783) {
                            phi_2345_ = _e3779;
                        } else {
                            phi_2345_ = _e3783;
                        }
                        let _e3786 = phi_2345_;
                        let _e3789 = local_12.member[1u];
                        if (_e3789[0] < 0.0lf) {
                            phi_2358_ = -(_e3789[0]);
                        } else {
                            phi_2358_ = _e3789[0];
                        }
                        let _e3796 = phi_2358_;
                        if (_e3789[1] < 0.0lf) {
                            phi_2365_ = -(_e3789[1]);
                        } else {
                            phi_2365_ = _e3789[1];
                        }
                        let _e3800 = phi_2365_;
                        if (_e3796 > _e3800) {
                            phi_2370_ = _e3796;
                        } else {
                            phi_2370_ = _e3800;
                        }
                        let _e3803 = phi_2370_;
                        if (_e3789[2] < 0.0lf) {
                            phi_2377_ = -(_e3789[2]);
                        } else {
                            phi_2377_ = _e3789[2];
                        }
                        let _e3807 = phi_2377_;
                        if (_e3803 > _e3807) {
                            phi_2382_ = _e3803;
                        } else {
                            phi_2382_ = _e3807;
                        }
                        let _e3810 = phi_2382_;
                        if (_e3786 > _e3810) {
                            phi_2387_ = _e3786;
                        } else {
                            phi_2387_ = _e3810;
                        }
                        let _e3813 = phi_2387_;
                        let _e3815 = local_12.member_3;
                        let _e3819 = local_12.member_1[0u];
                        if (_e3819[0] < 0.0lf) {
                            phi_2404_ = -(_e3819[0]);
                        } else {
                            phi_2404_ = _e3819[0];
                        }
                        let _e3826 = phi_2404_;
                        if (_e3819[1] < 0.0lf) {
                            phi_2411_ = -(_e3819[1]);
                        } else {
                            phi_2411_ = _e3819[1];
                        }
                        let _e3830 = phi_2411_;
                        if (_e3826 > _e3830) {
                            phi_2416_ = _e3826;
                        } else {
                            phi_2416_ = _e3830;
                        }
                        let _e3833 = phi_2416_;
                        if (_e3819[2] < 0.0lf) {
                            phi_2423_ = -(_e3819[2]);
                        } else {
                            phi_2423_ = _e3819[2];
                        }
                        let _e3837 = phi_2423_;
                        if (_e3833 > _e3837) {
                            phi_2428_ = _e3833;
                        } else {
                            phi_2428_ = _e3837;
                        }
                        let _e3840 = phi_2428_;
                        let _e3843 = local_12.member_1[1u];
                        if (_e3843[0] < 0.0lf) {
                            phi_2442_ = -(_e3843[0]);
                        } else {
                            phi_2442_ = _e3843[0];
                        }
                        let _e3850 = phi_2442_;
                        if (_e3843[1] < 0.0lf) {
                            phi_2449_ = -(_e3843[1]);
                        } else {
                            phi_2449_ = _e3843[1];
                        }
                        let _e3854 = phi_2449_;
                        if (_e3850 > _e3854) {
                            phi_2454_ = _e3850;
                        } else {
                            phi_2454_ = _e3854;
                        }
                        let _e3857 = phi_2454_;
                        if (_e3843[2] < 0.0lf) {
                            phi_2461_ = -(_e3843[2]);
                        } else {
                            phi_2461_ = _e3843[2];
                        }
                        let _e3861 = phi_2461_;
                        if (_e3857 > _e3861) {
                            phi_2466_ = _e3857;
                        } else {
                            phi_2466_ = _e3861;
                        }
                        let _e3864 = phi_2466_;
                        if (_e3840 > _e3864) {
                            phi_2471_ = _e3840;
                        } else {
                            phi_2471_ = _e3864;
                        }
                        let _e3867 = phi_2471_;
                        let _e3869 = local_12.member_3;
                        let _e3873 = local_12.member_2[0u];
                        if (_e3873[0] < 0.0lf) {
                            phi_2488_ = -(_e3873[0]);
                        } else {
                            phi_2488_ = _e3873[0];
                        }
                        let _e3880 = phi_2488_;
                        if (_e3873[1] < 0.0lf) {
                            phi_2495_ = -(_e3873[1]);
                        } else {
                            phi_2495_ = _e3873[1];
                        }
                        let _e3884 = phi_2495_;
                        if (_e3880 > _e3884) {
                            phi_2500_ = _e3880;
                        } else {
                            phi_2500_ = _e3884;
                        }
                        let _e3887 = phi_2500_;
                        if (_e3873[2] < 0.0lf) {
                            phi_2507_ = -(_e3873[2]);
                        } else {
                            phi_2507_ = _e3873[2];
                        }
                        let _e3891 = phi_2507_;
                        if (_e3887 > _e3891) {
                            phi_2512_ = _e3887;
                        } else {
                            phi_2512_ = _e3891;
                        }
                        let _e3894 = phi_2512_;
                        let _e3897 = local_12.member_2[1u];
                        if (_e3897[0] < 0.0lf) {
                            phi_2526_ = -(_e3897[0]);
                        } else {
                            phi_2526_ = _e3897[0];
                        }
                        let _e3904 = phi_2526_;
                        if (_e3897[1] < 0.0lf) {
                            phi_2533_ = -(_e3897[1]);
                        } else {
                            phi_2533_ = _e3897[1];
                        }
                        let _e3908 = phi_2533_;
                        if (_e3904 > _e3908) {
                            phi_2538_ = _e3904;
                        } else {
                            phi_2538_ = _e3908;
                        }
                        let _e3911 = phi_2538_;
                        if (_e3897[2] < 0.0lf) {
                            phi_2545_ = -(_e3897[2]);
                        } else {
                            phi_2545_ = _e3897[2];
                        }
                        let _e3915 = phi_2545_;
                        if (_e3911 > _e3915) {
                            phi_2550_ = _e3911;
                        } else {
                            phi_2550_ = _e3915;
                        }
                        let _e3918 = phi_2550_;
                        if (_e3894 > _e3918) {
                            phi_2555_ = _e3894;
                        } else {
                            phi_2555_ = _e3918;
                        }
                        let _e3921 = phi_2555_;
                        let _e3923 = local_12.member_3;
                        let _e3931 = local_12.member_3;
                        let _e3938 = f64(0f);
                        let _e3939 = f64(1f);
                        local_9 = type_32(array<f64, 4>(_e3938, _e3938, _e3938, _e3938), array<f64, 4>(_e3938, _e3938, _e3938, _e3938), array<f64, 4>(_e3939, _e3939, _e3939, _e3939));
                        phi_2599_ = type_19(0u, 96u);
                        phi_2602_ = _e3714;
                        phi_2604_ = _e3714;
                        phi_2606_ = _e3714;
                        loop {
                            let _e3945 = phi_2599_;
                            let _e3947 = phi_2602_;
                            let _e3949 = phi_2604_;
                            let _e3951 = phi_2606_;
                            local_44 = _e3949;
                            local_26 = _e3947;
                            if (_e3945.member < _e3945.member_1) {
                                phi_2600_ = type_19((_e3945.member + 1u), _e3945.member_1);
                                phi_2629_ = type_19(1u, _e3945.member);
                            } else {
                                phi_2600_ = _e3945;
                                phi_2629_ = type_19(0u, type_19().member_1);
                            }
                            let _e3963 = phi_2600_;
                            let _e3965 = phi_2629_;
                            if (bitcast<i32>(_e3965.member) != 0i) {
                                let _e3972 = local_12.member[0u];
                                let _e3978 = local_12.member[1u];
                                let _e3994 = local_12.member_1[0u];
                                let _e4000 = local_12.member_1[1u];
                                let _e4016 = local_12.member_2[0u];
                                let _e4022 = local_12.member_2[1u];
                                let _e4036 = function_2(array<f64, 3>((_e3972[0] + ((_e3978[0] - _e3972[0]) * _e3947)), (_e3972[1] + ((_e3978[1] - _e3972[1]) * _e3947)), (_e3972[2] + ((_e3978[2] - _e3972[2]) * _e3947))), array<f64, 3>((_e3994[0] + ((_e4000[0] - _e3994[0]) * _e3947)), (_e3994[1] + ((_e4000[1] - _e3994[1]) * _e3947)), (_e3994[2] + ((_e4000[2] - _e3994[2]) * _e3947))), array<f64, 3>((_e4016[0] + ((_e4022[0] - _e4016[0]) * _e3947)), (_e4016[1] + ((_e4022[1] - _e4016[1]) * _e3947)), (_e4016[2] + ((_e4022[2] - _e4016[2]) * _e3947))), 0u);
                                if (_e4036[0] < 0.0lf) {
                                    phi_2741_ = -(_e4036[0]);
                                } else {
                                    phi_2741_ = _e4036[0];
                                }
                                let _e4041 = phi_2741_;
                                if (_e4036[1] < 0.0lf) {
                                    phi_2748_ = -(_e4036[1]);
                                } else {
                                    phi_2748_ = _e4036[1];
                                }
                                let _e4046 = phi_2748_;
                                if (_e4036[2] < 0.0lf) {
                                    phi_2756_ = -(_e4036[2]);
                                } else {
                                    phi_2756_ = _e4036[2];
                                }
                                let _e4052 = phi_2756_;
                                let _e4053 = ((_e4041 + _e4046) + _e4052);
                                if (_e4053 > f64(0f)) {
                                    if ((bitcast<u64>(_e4053) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4060 = (f64(1f) / _e4053);
                                        let _e4062 = (_e4036[0] * _e4060);
                                        let _e4064 = (_e4036[1] * _e4060);
                                        let _e4066 = (_e4036[2] * _e4060);
                                        let _e4071 = (((_e4062 * _e4062) + (_e4064 * _e4064)) + (_e4066 * _e4066));
                                        if (_e4071 <= 2.2250738585072014e-308lf) {
                                            if (_e4071 > 0.0lf) {
                                                phi_2795_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2795_ = 0.0lf;
                                            }
                                            let _e4123 = phi_2795_;
                                            phi_2859_ = _e4123;
                                        } else {
                                            phi_2802_ = type_17(0i, 5i);
                                            phi_2805_ = bitcast<f64>(((bitcast<u64>(_e4071) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4078 = phi_2802_;
                                                let _e4080 = phi_2805_;
                                                local_24 = _e4080;
                                                if (_e4078.member < _e4078.member_1) {
                                                    let _e4087 = (_e4078.member + 1i);
                                                    if ((false == (_e4087 > _e4078.member)) != false) {
                                                        phi_2826_ = true;
                                                    } else {
                                                        phi_2826_ = false;
                                                    }
                                                    let _e4092 = phi_2826_;
                                                    if _e4092 {
                                                        phi_2832_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2832_ = type_18(1u, _e4087);
                                                    }
                                                    let _e4097 = phi_2832_;
                                                    phi_2803_ = type_17(_e4097.member_1, _e4078.member_1);
                                                    phi_2846_ = type_18(1u, _e4078.member);
                                                } else {
                                                    phi_2803_ = _e4078;
                                                    phi_2846_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e4103 = phi_2803_;
                                                let _e4105 = phi_2846_;
                                                let _e4108 = (bitcast<i32>(_e4105.member) != 0i);
                                                if _e4108 {
                                                    phi_2806_ = (0.5lf * (_e4080 + (_e4071 / _e4080)));
                                                } else {
                                                    phi_2806_ = f64();
                                                }
                                                let _e4113 = phi_2806_;
                                                continue;
                                                continuing {
                                                    phi_2802_ = _e4103;
                                                    phi_2805_ = _e4113;
                                                    break if !(_e4108);
                                                }
                                            }
                                            let _e4118 = local_24;
                                            phi_2859_ = (_e4118 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4125 = phi_2859_;
                                        let _e4127 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4134 = ((((((((_e3813 + _e3815) + (_e3867 + _e3869)) + (_e3921 + _e3923)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3931 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e576.member_1 * _e4125) * (f64(1f) + _e4127)));
                                        let _e4139 = (((_e4062 * _e3717[0]) + (_e4064 * _e3717[1])) + (_e4066 * _e3717[2]));
                                        let _e4144 = (((_e4062 * (_e3717[0] - _e3723[0])) + (_e4064 * (_e3717[1] - _e3723[1]))) + (_e4066 * (_e3717[2] - _e3723[2])));
                                        let _e4149 = (((_e4062 * (_e3717[0] - _e3729[0])) + (_e4064 * (_e3717[1] - _e3729[1]))) + (_e4066 * (_e3717[2] - _e3729[2])));
                                        let _e4154 = (((_e4062 * _e3717[0]) + (_e4064 * _e3717[1])) + (_e4066 * _e3717[2]));
                                        let _e4160 = (((_e4062 * _e3741[0]) + (_e4064 * _e3741[1])) + (_e4066 * _e3741[2]));
                                        let _e4165 = (((_e4062 * (_e3741[0] - _e3747[0])) + (_e4064 * (_e3741[1] - _e3747[1]))) + (_e4066 * (_e3741[2] - _e3747[2])));
                                        let _e4170 = (((_e4062 * (_e3741[0] - _e3753[0])) + (_e4064 * (_e3741[1] - _e3753[1]))) + (_e4066 * (_e3741[2] - _e3753[2])));
                                        let _e4175 = (((_e4062 * _e3741[0]) + (_e4064 * _e3741[1])) + (_e4066 * _e3741[2]));
                                        if (_e4139 < 0.0lf) {
                                            phi_2928_ = -(_e4139);
                                        } else {
                                            phi_2928_ = _e4139;
                                        }
                                        let _e4180 = phi_2928_;
                                        if (_e4160 < 0.0lf) {
                                            phi_2934_ = -(_e4160);
                                        } else {
                                            phi_2934_ = _e4160;
                                        }
                                        let _e4184 = phi_2934_;
                                        if (_e4144 < 0.0lf) {
                                            phi_2943_ = -(_e4144);
                                        } else {
                                            phi_2943_ = _e4144;
                                        }
                                        let _e4191 = phi_2943_;
                                        if (_e4165 < 0.0lf) {
                                            phi_2949_ = -(_e4165);
                                        } else {
                                            phi_2949_ = _e4165;
                                        }
                                        let _e4195 = phi_2949_;
                                        if (_e4149 < 0.0lf) {
                                            phi_2958_ = -(_e4149);
                                        } else {
                                            phi_2958_ = _e4149;
                                        }
                                        let _e4202 = phi_2958_;
                                        if (_e4170 < 0.0lf) {
                                            phi_2964_ = -(_e4170);
                                        } else {
                                            phi_2964_ = _e4170;
                                        }
                                        let _e4206 = phi_2964_;
                                        if (_e4154 < 0.0lf) {
                                            phi_2973_ = -(_e4154);
                                        } else {
                                            phi_2973_ = _e4154;
                                        }
                                        let _e4213 = phi_2973_;
                                        if (_e4175 < 0.0lf) {
                                            phi_2979_ = -(_e4175);
                                        } else {
                                            phi_2979_ = _e4175;
                                        }
                                        let _e4217 = phi_2979_;
                                        phi_2985_ = type_32(array<f64, 4>(_e4139, _e4144, _e4149, _e4154), array<f64, 4>(_e4160, _e4165, _e4170, _e4175), array<f64, 4>((_e4134 + ((_e4180 + _e4184) * _e4127)), (_e4134 + ((_e4191 + _e4195) * _e4127)), (_e4134 + ((_e4202 + _e4206) * _e4127)), (_e4134 + ((_e4213 + _e4217) * _e4127))));
                                        phi_2986_ = false;
                                    } else {
                                        phi_2985_ = type_32();
                                        phi_2986_ = true;
                                    }
                                    let _e4224 = phi_2985_;
                                    let _e4226 = phi_2986_;
                                    phi_2987_ = _e4224;
                                    phi_2988_ = _e4226;
                                } else {
                                    phi_2987_ = type_32();
                                    phi_2988_ = true;
                                }
                                let _e4228 = phi_2987_;
                                let _e4230 = phi_2988_;
                                if _e4230 {
                                    let _e4231 = f64(0f);
                                    let _e4232 = f64(1f);
                                    phi_2998_ = type_32(array<f64, 4>(_e4231, _e4231, _e4231, _e4231), array<f64, 4>(_e4231, _e4231, _e4231, _e4231), array<f64, 4>(_e4232, _e4232, _e4232, _e4232));
                                } else {
                                    phi_2998_ = _e4228;
                                }
                                let _e4238 = phi_2998_;
                                local_10 = type_32(array<f64, 4>(_e4238.member[0], _e4238.member[1], _e4238.member[2], _e4238.member[3]), array<f64, 4>(_e4238.member_1[0], _e4238.member_1[1], _e4238.member_1[2], _e4238.member_1[3]), array<f64, 4>(_e4238.member_2[0], _e4238.member_2[1], _e4238.member_2[2], _e4238.member_2[3]));
                                let _e4258 = (_e3947 - _e3951);
                                let _e4259 = f64(0f);
                                let _e4262 = local_10.member[0u];
                                let _e4265 = local_10.member_1[0u];
                                let _e4268 = local_10.member[0u];
                                let _e4274 = local_10.member_2[0u];
                                if (((_e4262 + ((_e4265 - _e4268) * _e3947)) - _e4274) > _e4259) {
                                    let _e4279 = local_10.member[1u];
                                    let _e4282 = local_10.member_1[1u];
                                    let _e4285 = local_10.member[1u];
                                    let _e4291 = local_10.member_2[1u];
                                    if (((_e4279 + ((_e4282 - _e4285) * _e3947)) - _e4291) > _e4259) {
                                        let _e4296 = local_10.member[2u];
                                        let _e4299 = local_10.member_1[2u];
                                        let _e4302 = local_10.member[2u];
                                        let _e4308 = local_10.member_2[2u];
                                        if (((_e4296 + ((_e4299 - _e4302) * _e3947)) - _e4308) > _e4259) {
                                            let _e4313 = local_10.member[3u];
                                            let _e4316 = local_10.member_1[3u];
                                            let _e4319 = local_10.member[3u];
                                            let _e4325 = local_10.member_2[3u];
                                            phi_3169_ = (((_e4313 + ((_e4316 - _e4319) * _e3947)) - _e4325) > _e4259);
                                            phi_3170_ = false;
                                        } else {
                                            phi_3169_ = bool();
                                            phi_3170_ = true;
                                        }
                                        let _e4329 = phi_3169_;
                                        let _e4331 = phi_3170_;
                                        phi_3171_ = _e4329;
                                        phi_3172_ = _e4331;
                                    } else {
                                        phi_3171_ = bool();
                                        phi_3172_ = true;
                                    }
                                    let _e4333 = phi_3171_;
                                    let _e4335 = phi_3172_;
                                    phi_3173_ = _e4333;
                                    phi_3174_ = _e4335;
                                } else {
                                    phi_3173_ = bool();
                                    phi_3174_ = true;
                                }
                                let _e4337 = phi_3173_;
                                let _e4339 = phi_3174_;
                                if _e4339 {
                                    phi_3178_ = false;
                                } else {
                                    phi_3178_ = _e4337;
                                }
                                let _e4341 = phi_3178_;
                                if _e4341 {
                                    if (_e3947 <= _e3949) {
                                        phi_3489_ = true;
                                    } else {
                                        let _e4343 = f64(0f);
                                        let _e4346 = local_9.member[0u];
                                        let _e4349 = local_9.member_1[0u];
                                        let _e4352 = local_9.member[0u];
                                        let _e4358 = local_9.member_2[0u];
                                        let _e4362 = local_10.member[0u];
                                        let _e4365 = local_10.member_1[0u];
                                        let _e4368 = local_10.member[0u];
                                        let _e4374 = local_10.member_2[0u];
                                        if ((((_e4346 + ((_e4349 - _e4352) * _e3947)) - _e4358) + ((_e4362 + ((_e4365 - _e4368) * _e3951)) - _e4374)) > _e4343) {
                                            let _e4380 = local_9.member[1u];
                                            let _e4383 = local_9.member_1[1u];
                                            let _e4386 = local_9.member[1u];
                                            let _e4392 = local_9.member_2[1u];
                                            let _e4396 = local_10.member[1u];
                                            let _e4399 = local_10.member_1[1u];
                                            let _e4402 = local_10.member[1u];
                                            let _e4408 = local_10.member_2[1u];
                                            if ((((_e4380 + ((_e4383 - _e4386) * _e3947)) - _e4392) + ((_e4396 + ((_e4399 - _e4402) * _e3951)) - _e4408)) > _e4343) {
                                                let _e4414 = local_9.member[2u];
                                                let _e4417 = local_9.member_1[2u];
                                                let _e4420 = local_9.member[2u];
                                                let _e4426 = local_9.member_2[2u];
                                                let _e4430 = local_10.member[2u];
                                                let _e4433 = local_10.member_1[2u];
                                                let _e4436 = local_10.member[2u];
                                                let _e4442 = local_10.member_2[2u];
                                                if ((((_e4414 + ((_e4417 - _e4420) * _e3947)) - _e4426) + ((_e4430 + ((_e4433 - _e4436) * _e3951)) - _e4442)) > _e4343) {
                                                    let _e4448 = local_9.member[3u];
                                                    let _e4451 = local_9.member_1[3u];
                                                    let _e4454 = local_9.member[3u];
                                                    let _e4460 = local_9.member_2[3u];
                                                    let _e4464 = local_10.member[3u];
                                                    let _e4467 = local_10.member_1[3u];
                                                    let _e4470 = local_10.member[3u];
                                                    let _e4476 = local_10.member_2[3u];
                                                    phi_3476_ = ((((_e4448 + ((_e4451 - _e4454) * _e3947)) - _e4460) + ((_e4464 + ((_e4467 - _e4470) * _e3951)) - _e4476)) > _e4343);
                                                    phi_3477_ = false;
                                                } else {
                                                    phi_3476_ = bool();
                                                    phi_3477_ = true;
                                                }
                                                let _e4481 = phi_3476_;
                                                let _e4483 = phi_3477_;
                                                phi_3478_ = _e4481;
                                                phi_3479_ = _e4483;
                                            } else {
                                                phi_3478_ = bool();
                                                phi_3479_ = true;
                                            }
                                            let _e4485 = phi_3478_;
                                            let _e4487 = phi_3479_;
                                            phi_3480_ = _e4485;
                                            phi_3481_ = _e4487;
                                        } else {
                                            phi_3480_ = bool();
                                            phi_3481_ = true;
                                        }
                                        let _e4489 = phi_3480_;
                                        let _e4491 = phi_3481_;
                                        if _e4491 {
                                            phi_3485_ = false;
                                        } else {
                                            phi_3485_ = _e4489;
                                        }
                                        let _e4493 = phi_3485_;
                                        phi_3489_ = _e4493;
                                    }
                                    let _e4495 = phi_3489_;
                                    if _e4495 {
                                        if (_e3965.member_1 > 0u) {
                                            if (_e3947 >= _e3713) {
                                                phi_3501_ = false;
                                            } else {
                                                phi_3501_ = true;
                                            }
                                            let _e4499 = phi_3501_;
                                            phi_3502_ = _e4499;
                                        } else {
                                            phi_3502_ = true;
                                        }
                                        let _e4501 = phi_3502_;
                                        if _e4501 {
                                            local_9 = type_32(array<f64, 4>(_e4238.member[0], _e4238.member[1], _e4238.member[2], _e4238.member[3]), array<f64, 4>(_e4238.member_1[0], _e4238.member_1[1], _e4238.member_1[2], _e4238.member_1[3]), array<f64, 4>(_e4238.member_2[0], _e4238.member_2[1], _e4238.member_2[2], _e4238.member_2[3]));
                                            let _e4523 = local_9.member[0u];
                                            let _e4526 = local_9.member_1[0u];
                                            let _e4529 = local_9.member_2[0u];
                                            if (_e4523 > _e4529) {
                                                if (_e4526 > _e4529) {
                                                    phi_3576_ = false;
                                                } else {
                                                    phi_3576_ = true;
                                                }
                                                let _e4533 = phi_3576_;
                                                phi_3577_ = _e4533;
                                            } else {
                                                phi_3577_ = true;
                                            }
                                            let _e4535 = phi_3577_;
                                            if _e4535 {
                                                let _e4536 = (_e4526 >= _e4523);
                                                if _e4536 {
                                                    phi_3602_ = f64();
                                                    phi_3603_ = false;
                                                } else {
                                                    if ((_e4523 - _e4526) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3600_ = (((_e4523 - _e4529) / (_e4523 - _e4526)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3601_ = false;
                                                    } else {
                                                        phi_3600_ = f64();
                                                        phi_3601_ = true;
                                                    }
                                                    let _e4550 = phi_3600_;
                                                    let _e4552 = phi_3601_;
                                                    phi_3602_ = _e4550;
                                                    phi_3603_ = _e4552;
                                                }
                                                let _e4554 = phi_3602_;
                                                let _e4556 = phi_3603_;
                                                phi_3604_ = _e4554;
                                                phi_3605_ = _e4536;
                                                phi_3606_ = _e4556;
                                            } else {
                                                phi_3604_ = f64();
                                                phi_3605_ = true;
                                                phi_3606_ = false;
                                            }
                                            let _e4558 = phi_3604_;
                                            let _e4560 = phi_3605_;
                                            let _e4562 = phi_3606_;
                                            if _e4560 {
                                                phi_3611_ = f64(2f);
                                                phi_3612_ = true;
                                            } else {
                                                phi_3611_ = _e3947;
                                                phi_3612_ = _e4562;
                                            }
                                            let _e4565 = phi_3611_;
                                            let _e4567 = phi_3612_;
                                            if _e4567 {
                                                phi_3616_ = _e4565;
                                            } else {
                                                phi_3616_ = _e4558;
                                            }
                                            let _e4569 = phi_3616_;
                                            let _e4572 = local_9.member[1u];
                                            let _e4575 = local_9.member_1[1u];
                                            let _e4578 = local_9.member_2[1u];
                                            if (_e4572 > _e4578) {
                                                if (_e4575 > _e4578) {
                                                    phi_3648_ = false;
                                                } else {
                                                    phi_3648_ = true;
                                                }
                                                let _e4582 = phi_3648_;
                                                phi_3649_ = _e4582;
                                            } else {
                                                phi_3649_ = true;
                                            }
                                            let _e4584 = phi_3649_;
                                            if _e4584 {
                                                let _e4585 = (_e4575 >= _e4572);
                                                if _e4585 {
                                                    phi_3674_ = f64();
                                                    phi_3675_ = false;
                                                } else {
                                                    if ((_e4572 - _e4575) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3672_ = (((_e4572 - _e4578) / (_e4572 - _e4575)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3673_ = false;
                                                    } else {
                                                        phi_3672_ = f64();
                                                        phi_3673_ = true;
                                                    }
                                                    let _e4599 = phi_3672_;
                                                    let _e4601 = phi_3673_;
                                                    phi_3674_ = _e4599;
                                                    phi_3675_ = _e4601;
                                                }
                                                let _e4603 = phi_3674_;
                                                let _e4605 = phi_3675_;
                                                phi_3676_ = _e4603;
                                                phi_3677_ = _e4585;
                                                phi_3678_ = _e4605;
                                            } else {
                                                phi_3676_ = f64();
                                                phi_3677_ = true;
                                                phi_3678_ = false;
                                            }
                                            let _e4607 = phi_3676_;
                                            let _e4609 = phi_3677_;
                                            let _e4611 = phi_3678_;
                                            if _e4609 {
                                                phi_3683_ = f64(2f);
                                                phi_3684_ = true;
                                            } else {
                                                phi_3683_ = _e3947;
                                                phi_3684_ = _e4611;
                                            }
                                            let _e4614 = phi_3683_;
                                            let _e4616 = phi_3684_;
                                            if _e4616 {
                                                phi_3688_ = _e4614;
                                            } else {
                                                phi_3688_ = _e4607;
                                            }
                                            let _e4618 = phi_3688_;
                                            if (_e4569 < _e4618) {
                                                phi_3693_ = _e4569;
                                            } else {
                                                phi_3693_ = _e4618;
                                            }
                                            let _e4621 = phi_3693_;
                                            let _e4624 = local_9.member[2u];
                                            let _e4627 = local_9.member_1[2u];
                                            let _e4630 = local_9.member_2[2u];
                                            if (_e4624 > _e4630) {
                                                if (_e4627 > _e4630) {
                                                    phi_3725_ = false;
                                                } else {
                                                    phi_3725_ = true;
                                                }
                                                let _e4634 = phi_3725_;
                                                phi_3726_ = _e4634;
                                            } else {
                                                phi_3726_ = true;
                                            }
                                            let _e4636 = phi_3726_;
                                            if _e4636 {
                                                let _e4637 = (_e4627 >= _e4624);
                                                if _e4637 {
                                                    phi_3751_ = f64();
                                                    phi_3752_ = false;
                                                } else {
                                                    if ((_e4624 - _e4627) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3749_ = (((_e4624 - _e4630) / (_e4624 - _e4627)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3750_ = false;
                                                    } else {
                                                        phi_3749_ = f64();
                                                        phi_3750_ = true;
                                                    }
                                                    let _e4651 = phi_3749_;
                                                    let _e4653 = phi_3750_;
                                                    phi_3751_ = _e4651;
                                                    phi_3752_ = _e4653;
                                                }
                                                let _e4655 = phi_3751_;
                                                let _e4657 = phi_3752_;
                                                phi_3753_ = _e4655;
                                                phi_3754_ = _e4637;
                                                phi_3755_ = _e4657;
                                            } else {
                                                phi_3753_ = f64();
                                                phi_3754_ = true;
                                                phi_3755_ = false;
                                            }
                                            let _e4659 = phi_3753_;
                                            let _e4661 = phi_3754_;
                                            let _e4663 = phi_3755_;
                                            if _e4661 {
                                                phi_3760_ = f64(2f);
                                                phi_3761_ = true;
                                            } else {
                                                phi_3760_ = _e3947;
                                                phi_3761_ = _e4663;
                                            }
                                            let _e4666 = phi_3760_;
                                            let _e4668 = phi_3761_;
                                            if _e4668 {
                                                phi_3765_ = _e4666;
                                            } else {
                                                phi_3765_ = _e4659;
                                            }
                                            let _e4670 = phi_3765_;
                                            let _e4673 = local_9.member[3u];
                                            let _e4676 = local_9.member_1[3u];
                                            let _e4679 = local_9.member_2[3u];
                                            if (_e4673 > _e4679) {
                                                if (_e4676 > _e4679) {
                                                    phi_3797_ = false;
                                                } else {
                                                    phi_3797_ = true;
                                                }
                                                let _e4683 = phi_3797_;
                                                phi_3798_ = _e4683;
                                            } else {
                                                phi_3798_ = true;
                                            }
                                            let _e4685 = phi_3798_;
                                            if _e4685 {
                                                let _e4686 = (_e4676 >= _e4673);
                                                if _e4686 {
                                                    phi_3823_ = f64();
                                                    phi_3824_ = false;
                                                } else {
                                                    if ((_e4673 - _e4676) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3821_ = (((_e4673 - _e4679) / (_e4673 - _e4676)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3822_ = false;
                                                    } else {
                                                        phi_3821_ = f64();
                                                        phi_3822_ = true;
                                                    }
                                                    let _e4700 = phi_3821_;
                                                    let _e4702 = phi_3822_;
                                                    phi_3823_ = _e4700;
                                                    phi_3824_ = _e4702;
                                                }
                                                let _e4704 = phi_3823_;
                                                let _e4706 = phi_3824_;
                                                phi_3825_ = _e4704;
                                                phi_3826_ = _e4686;
                                                phi_3827_ = _e4706;
                                            } else {
                                                phi_3825_ = f64();
                                                phi_3826_ = true;
                                                phi_3827_ = false;
                                            }
                                            let _e4708 = phi_3825_;
                                            let _e4710 = phi_3826_;
                                            let _e4712 = phi_3827_;
                                            if _e4710 {
                                                phi_3832_ = f64(2f);
                                                phi_3833_ = true;
                                            } else {
                                                phi_3832_ = _e3947;
                                                phi_3833_ = _e4712;
                                            }
                                            let _e4715 = phi_3832_;
                                            let _e4717 = phi_3833_;
                                            if _e4717 {
                                                phi_3837_ = _e4715;
                                            } else {
                                                phi_3837_ = _e4708;
                                            }
                                            let _e4719 = phi_3837_;
                                            if (_e4670 < _e4719) {
                                                phi_3842_ = _e4670;
                                            } else {
                                                phi_3842_ = _e4719;
                                            }
                                            let _e4722 = phi_3842_;
                                            if (_e4621 < _e4722) {
                                                phi_3847_ = _e4621;
                                            } else {
                                                phi_3847_ = _e4722;
                                            }
                                            let _e4725 = phi_3847_;
                                            if (_e4725 > _e3947) {
                                                phi_3852_ = _e4725;
                                            } else {
                                                phi_3852_ = _e3947;
                                            }
                                            let _e4728 = phi_3852_;
                                            let _e4729 = (_e4728 > _e3713);
                                            if _e4729 {
                                                phi_3864_ = f64();
                                                phi_3865_ = false;
                                            } else {
                                                if (_e3965.member_1 == 0u) {
                                                    phi_3863_ = (_e3713 - _e3947);
                                                } else {
                                                    phi_3863_ = (_e4258 + _e4258);
                                                }
                                                let _e4734 = phi_3863_;
                                                phi_3864_ = _e4734;
                                                phi_3865_ = true;
                                            }
                                            let _e4736 = phi_3864_;
                                            let _e4738 = phi_3865_;
                                            phi_3866_ = _e4728;
                                            phi_3867_ = _e4736;
                                            phi_3868_ = _e4738;
                                            phi_3869_ = _e4729;
                                            phi_3870_ = false;
                                        } else {
                                            phi_3866_ = f64();
                                            phi_3867_ = f64();
                                            phi_3868_ = false;
                                            phi_3869_ = false;
                                            phi_3870_ = true;
                                        }
                                        let _e4740 = phi_3866_;
                                        let _e4742 = phi_3867_;
                                        let _e4744 = phi_3868_;
                                        let _e4746 = phi_3869_;
                                        let _e4748 = phi_3870_;
                                        phi_3871_ = _e4740;
                                        phi_3872_ = _e4742;
                                        phi_3873_ = false;
                                        phi_3874_ = _e4744;
                                        phi_3875_ = _e4746;
                                        phi_3876_ = _e4748;
                                    } else {
                                        phi_3871_ = f64();
                                        phi_3872_ = f64();
                                        phi_3873_ = true;
                                        phi_3874_ = false;
                                        phi_3875_ = false;
                                        phi_3876_ = false;
                                    }
                                    let _e4750 = phi_3871_;
                                    let _e4752 = phi_3872_;
                                    let _e4754 = phi_3873_;
                                    let _e4756 = phi_3874_;
                                    let _e4758 = phi_3875_;
                                    let _e4760 = phi_3876_;
                                    phi_3877_ = _e4750;
                                    phi_3878_ = _e4752;
                                    phi_3879_ = _e4754;
                                    phi_3880_ = _e4756;
                                    phi_3881_ = _e4758;
                                    phi_3882_ = _e4760;
                                } else {
                                    phi_3877_ = f64();
                                    phi_3878_ = f64();
                                    phi_3879_ = true;
                                    phi_3880_ = false;
                                    phi_3881_ = false;
                                    phi_3882_ = false;
                                }
                                let _e4762 = phi_3877_;
                                let _e4764 = phi_3878_;
                                let _e4766 = phi_3879_;
                                let _e4768 = phi_3880_;
                                let _e4770 = phi_3881_;
                                let _e4772 = phi_3882_;
                                if _e4766 {
                                    let _e4773 = (_e3947 <= _e3949);
                                    if _e4773 {
                                        phi_4216_ = f64();
                                        phi_4217_ = false;
                                    } else {
                                        let _e4776 = local_9.member[0u];
                                        let _e4779 = local_9.member_1[0u];
                                        let _e4782 = local_9.member[0u];
                                        let _e4788 = local_9.member_2[0u];
                                        let _e4789 = ((_e4776 + ((_e4779 - _e4782) * _e3951)) - _e4788);
                                        let _e4792 = local_9.member[1u];
                                        let _e4795 = local_9.member_1[1u];
                                        let _e4798 = local_9.member[1u];
                                        let _e4804 = local_9.member_2[1u];
                                        let _e4805 = ((_e4792 + ((_e4795 - _e4798) * _e3951)) - _e4804);
                                        if (_e4789 < _e4805) {
                                            phi_3962_ = _e4789;
                                        } else {
                                            phi_3962_ = _e4805;
                                        }
                                        let _e4808 = phi_3962_;
                                        let _e4811 = local_9.member[2u];
                                        let _e4814 = local_9.member_1[2u];
                                        let _e4817 = local_9.member[2u];
                                        let _e4823 = local_9.member_2[2u];
                                        let _e4824 = ((_e4811 + ((_e4814 - _e4817) * _e3951)) - _e4823);
                                        let _e4827 = local_9.member[3u];
                                        let _e4830 = local_9.member_1[3u];
                                        let _e4833 = local_9.member[3u];
                                        let _e4839 = local_9.member_2[3u];
                                        let _e4840 = ((_e4827 + ((_e4830 - _e4833) * _e3951)) - _e4839);
                                        if (_e4824 < _e4840) {
                                            phi_4035_ = _e4824;
                                        } else {
                                            phi_4035_ = _e4840;
                                        }
                                        let _e4843 = phi_4035_;
                                        if (_e4808 < _e4843) {
                                            phi_4040_ = _e4808;
                                        } else {
                                            phi_4040_ = _e4843;
                                        }
                                        let _e4846 = phi_4040_;
                                        let _e4849 = local_10.member[0u];
                                        let _e4852 = local_10.member_1[0u];
                                        let _e4855 = local_10.member[0u];
                                        let _e4861 = local_10.member_2[0u];
                                        let _e4862 = ((_e4849 + ((_e4852 - _e4855) * _e3947)) - _e4861);
                                        let _e4865 = local_10.member[1u];
                                        let _e4868 = local_10.member_1[1u];
                                        let _e4871 = local_10.member[1u];
                                        let _e4877 = local_10.member_2[1u];
                                        let _e4878 = ((_e4865 + ((_e4868 - _e4871) * _e3947)) - _e4877);
                                        if (_e4862 < _e4878) {
                                            phi_4113_ = _e4862;
                                        } else {
                                            phi_4113_ = _e4878;
                                        }
                                        let _e4881 = phi_4113_;
                                        let _e4884 = local_10.member[2u];
                                        let _e4887 = local_10.member_1[2u];
                                        let _e4890 = local_10.member[2u];
                                        let _e4896 = local_10.member_2[2u];
                                        let _e4897 = ((_e4884 + ((_e4887 - _e4890) * _e3947)) - _e4896);
                                        let _e4900 = local_10.member[3u];
                                        let _e4903 = local_10.member_1[3u];
                                        let _e4906 = local_10.member[3u];
                                        let _e4912 = local_10.member_2[3u];
                                        let _e4913 = ((_e4900 + ((_e4903 - _e4906) * _e3947)) - _e4912);
                                        if (_e4897 < _e4913) {
                                            phi_4186_ = _e4897;
                                        } else {
                                            phi_4186_ = _e4913;
                                        }
                                        let _e4916 = phi_4186_;
                                        if (_e4881 < _e4916) {
                                            phi_4191_ = _e4881;
                                        } else {
                                            phi_4191_ = _e4916;
                                        }
                                        let _e4919 = phi_4191_;
                                        let _e4920 = f64(0.0625f);
                                        let _e4922 = f64(0.9f);
                                        if (_e4919 > f64(0f)) {
                                            phi_4214_ = f64(0.5f);
                                        } else {
                                            let _e4928 = (f64(0.95f) * (_e4846 / (_e4846 - _e4919)));
                                            if (_e4928 > _e4920) {
                                                if (_e4928 < _e4922) {
                                                    phi_4212_ = _e4928;
                                                } else {
                                                    phi_4212_ = _e4922;
                                                }
                                                let _e4932 = phi_4212_;
                                                phi_4213_ = _e4932;
                                            } else {
                                                phi_4213_ = _e4920;
                                            }
                                            let _e4934 = phi_4213_;
                                            phi_4214_ = _e4934;
                                        }
                                        let _e4936 = phi_4214_;
                                        phi_4216_ = (_e4258 * _e4936);
                                        phi_4217_ = true;
                                    }
                                    let _e4939 = phi_4216_;
                                    let _e4941 = phi_4217_;
                                    phi_4218_ = _e3949;
                                    phi_4219_ = _e4939;
                                    phi_4220_ = _e3951;
                                    phi_4221_ = _e4941;
                                    phi_4222_ = _e4773;
                                    phi_4223_ = false;
                                    phi_4224_ = false;
                                } else {
                                    phi_4218_ = _e4762;
                                    phi_4219_ = _e4764;
                                    phi_4220_ = _e3947;
                                    phi_4221_ = _e4768;
                                    phi_4222_ = false;
                                    phi_4223_ = _e4770;
                                    phi_4224_ = _e4772;
                                }
                                let _e4943 = phi_4218_;
                                let _e4945 = phi_4219_;
                                let _e4947 = phi_4220_;
                                let _e4949 = phi_4221_;
                                let _e4951 = phi_4222_;
                                let _e4953 = phi_4223_;
                                let _e4955 = phi_4224_;
                                if _e4949 {
                                    let _e4956 = (_e4947 + _e4945);
                                    if (_e4956 > _e4943) {
                                        phi_4233_ = _e4956;
                                    } else {
                                        phi_4233_ = _e4943;
                                    }
                                    let _e4959 = phi_4233_;
                                    if (_e4959 < _e3713) {
                                        phi_4238_ = _e4959;
                                    } else {
                                        phi_4238_ = _e3713;
                                    }
                                    let _e4962 = phi_4238_;
                                    if (_e3965.member_1 > 0u) {
                                        phi_4249_ = ((_e4962 - _e4947) > f64(0.0000000037252903f));
                                    } else {
                                        phi_4249_ = true;
                                    }
                                    let _e4968 = phi_4249_;
                                    if _e4968 {
                                        phi_4253_ = false;
                                    } else {
                                        phi_4253_ = true;
                                    }
                                    let _e4970 = phi_4253_;
                                    phi_4254_ = _e4962;
                                    phi_4255_ = _e4968;
                                    phi_4256_ = _e4970;
                                    phi_4257_ = false;
                                    phi_4258_ = false;
                                    phi_4259_ = false;
                                } else {
                                    phi_4254_ = f64();
                                    phi_4255_ = false;
                                    phi_4256_ = false;
                                    phi_4257_ = _e4951;
                                    phi_4258_ = _e4953;
                                    phi_4259_ = _e4955;
                                }
                                let _e4972 = phi_4254_;
                                let _e4974 = phi_4255_;
                                let _e4976 = phi_4256_;
                                let _e4978 = phi_4257_;
                                let _e4980 = phi_4258_;
                                let _e4982 = phi_4259_;
                                phi_2603_ = _e4972;
                                phi_2605_ = _e4943;
                                phi_2607_ = _e4947;
                                phi_4260_ = _e4943;
                                phi_4261_ = _e4974;
                                phi_4262_ = _e4976;
                                phi_4263_ = false;
                                phi_4264_ = _e4978;
                                phi_4265_ = _e4980;
                                phi_4266_ = _e4982;
                            } else {
                                phi_2603_ = f64();
                                phi_2605_ = f64();
                                phi_2607_ = f64();
                                phi_4260_ = f64();
                                phi_4261_ = false;
                                phi_4262_ = false;
                                phi_4263_ = true;
                                phi_4264_ = false;
                                phi_4265_ = false;
                                phi_4266_ = false;
                            }
                            let _e4984 = phi_2603_;
                            let _e4986 = phi_2605_;
                            let _e4988 = phi_2607_;
                            let _e4990 = phi_4260_;
                            let _e4992 = phi_4261_;
                            let _e4994 = phi_4262_;
                            let _e4996 = phi_4263_;
                            let _e4998 = phi_4264_;
                            let _e5000 = phi_4265_;
                            let _e5002 = phi_4266_;
                            local_25 = _e4994;
                            local_43 = _e4990;
                            local_45 = _e4996;
                            local_46 = _e4998;
                            local_47 = _e5000;
                            local_48 = _e5002;
                            continue;
                            continuing {
                                phi_2599_ = _e3963;
                                phi_2602_ = _e4984;
                                phi_2604_ = _e4986;
                                phi_2606_ = _e4988;
                                break if !(_e4992);
                            }
                        }
                        let _e5005 = local_25;
                        if _e5005 {
                            let _e6288 = local_43;
                            phi_4270_ = _e6288;
                            phi_4271_ = true;
                            phi_4272_ = false;
                            phi_4273_ = false;
                            phi_4274_ = false;
                        } else {
                            let _e6290 = local_44;
                            phi_4270_ = _e6290;
                            let _e6293 = local_45;
                            phi_4271_ = _e6293;
                            let _e6296 = local_46;
                            phi_4272_ = _e6296;
                            let _e6299 = local_47;
                            phi_4273_ = _e6299;
                            let _e6302 = local_48;
                            phi_4274_ = _e6302;
                        }
                        let _e5007 = phi_4270_;
                        let _e5009 = phi_4271_;
                        let _e5011 = phi_4272_;
                        let _e5013 = phi_4273_;
                        let _e5015 = phi_4274_;
                        if _e5009 {
                            phi_4279_ = type_42(1u, _e5007);
                            phi_4280_ = false;
                            phi_4281_ = false;
                            phi_4282_ = false;
                        } else {
                            phi_4279_ = type_42();
                            phi_4280_ = _e5011;
                            phi_4281_ = _e5013;
                            phi_4282_ = _e5015;
                        }
                        let _e5018 = phi_4279_;
                        let _e5020 = phi_4280_;
                        let _e5022 = phi_4281_;
                        let _e5024 = phi_4282_;
                        if _e5020 {
                            let _e5026 = local_26;
                            phi_4287_ = type_42(1u, _e5026);
                            phi_4288_ = false;
                            phi_4289_ = false;
                        } else {
                            phi_4287_ = type_42();
                            phi_4288_ = _e5022;
                            phi_4289_ = _e5024;
                        }
                        let _e5029 = phi_4287_;
                        let _e5031 = phi_4288_;
                        let _e5033 = phi_4289_;
                        if _e5031 {
                            phi_4294_ = type_42(0u, type_42().member_1);
                            phi_4295_ = false;
                            phi_4296_ = true;
                        } else {
                            phi_4294_ = _e5029;
                            phi_4295_ = _e5033;
                            phi_4296_ = _e5020;
                        }
                        let _e5037 = phi_4294_;
                        let _e5039 = phi_4295_;
                        let _e5041 = phi_4296_;
                        if _e5039 {
                            phi_4301_ = type_42(0u, type_42().member_1);
                            phi_4302_ = true;
                        } else {
                            phi_4301_ = _e5037;
                            phi_4302_ = _e5041;
                        }
                        let _e5045 = phi_4301_;
                        let _e5047 = phi_4302_;
                        if _e5047 {
                            phi_4306_ = _e5045;
                        } else {
                            phi_4306_ = _e5018;
                        }
                        let _e5049 = phi_4306_;
                        if (_e5049.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4320_ = type_19(0u, 3u);
                            loop {
                                let _e5061 = phi_4320_;
                                if (_e5061.member < _e5061.member_1) {
                                    phi_4321_ = type_19((_e5061.member + 1u), _e5061.member_1);
                                    phi_4344_ = type_19(1u, _e5061.member);
                                } else {
                                    phi_4321_ = _e5061;
                                    phi_4344_ = type_19(0u, type_19().member_1);
                                }
                                let _e5073 = phi_4321_;
                                let _e5075 = phi_4344_;
                                if (bitcast<i32>(_e5075.member) != 0i) {
                                    let _e5081 = local_11[_e5075.member_1];
                                    let _e5083 = (_e5049.member_1 + f64(_e5081));
                                    if (_e5083 < _e3713) {
                                        phi_4365_ = _e5083;
                                    } else {
                                        phi_4365_ = _e3713;
                                    }
                                    let _e5086 = phi_4365_;
                                    let _e5089 = local_12.member[0u];
                                    let _e5095 = local_12.member[1u];
                                    let _e5111 = local_12.member_1[0u];
                                    let _e5117 = local_12.member_1[1u];
                                    let _e5133 = local_12.member_2[0u];
                                    let _e5139 = local_12.member_2[1u];
                                    let _e5153 = function_2(array<f64, 3>((_e5089[0] + ((_e5095[0] - _e5089[0]) * _e5086)), (_e5089[1] + ((_e5095[1] - _e5089[1]) * _e5086)), (_e5089[2] + ((_e5095[2] - _e5089[2]) * _e5086))), array<f64, 3>((_e5111[0] + ((_e5117[0] - _e5111[0]) * _e5086)), (_e5111[1] + ((_e5117[1] - _e5111[1]) * _e5086)), (_e5111[2] + ((_e5117[2] - _e5111[2]) * _e5086))), array<f64, 3>((_e5133[0] + ((_e5139[0] - _e5133[0]) * _e5086)), (_e5133[1] + ((_e5139[1] - _e5133[1]) * _e5086)), (_e5133[2] + ((_e5139[2] - _e5133[2]) * _e5086))), 0u);
                                    let _e5164 = (((_e5153[0] * _e5153[0]) + (_e5153[1] * _e5153[1])) + (_e5153[2] * _e5153[2]));
                                    if (_e5164 <= 2.2250738585072014e-308lf) {
                                        if (_e5164 > 0.0lf) {
                                            phi_4488_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_4488_ = 0.0lf;
                                        }
                                        let _e5216 = phi_4488_;
                                        phi_4552_ = _e5216;
                                    } else {
                                        phi_4495_ = type_17(0i, 5i);
                                        phi_4498_ = bitcast<f64>(((bitcast<u64>(_e5164) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5171 = phi_4495_;
                                            let _e5173 = phi_4498_;
                                            local_27 = _e5173;
                                            if (_e5171.member < _e5171.member_1) {
                                                let _e5180 = (_e5171.member + 1i);
                                                if ((false == (_e5180 > _e5171.member)) != false) {
                                                    phi_4519_ = true;
                                                } else {
                                                    phi_4519_ = false;
                                                }
                                                let _e5185 = phi_4519_;
                                                if _e5185 {
                                                    phi_4525_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_4525_ = type_18(1u, _e5180);
                                                }
                                                let _e5190 = phi_4525_;
                                                phi_4496_ = type_17(_e5190.member_1, _e5171.member_1);
                                                phi_4539_ = type_18(1u, _e5171.member);
                                            } else {
                                                phi_4496_ = _e5171;
                                                phi_4539_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e5196 = phi_4496_;
                                            let _e5198 = phi_4539_;
                                            let _e5201 = (bitcast<i32>(_e5198.member) != 0i);
                                            if _e5201 {
                                                phi_4499_ = (0.5lf * (_e5173 + (_e5164 / _e5173)));
                                            } else {
                                                phi_4499_ = f64();
                                            }
                                            let _e5206 = phi_4499_;
                                            continue;
                                            continuing {
                                                phi_4495_ = _e5196;
                                                phi_4498_ = _e5206;
                                                break if !(_e5201);
                                            }
                                        }
                                        let _e5211 = local_27;
                                        phi_4552_ = (_e5211 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5218 = phi_4552_;
                                    let _e5226 = local_12.member[0u];
                                    if (_e5226[0] < 0.0lf) {
                                        phi_4570_ = -(_e5226[0]);
                                    } else {
                                        phi_4570_ = _e5226[0];
                                    }
                                    let _e5233 = phi_4570_;
                                    if (_e5226[1] < 0.0lf) {
                                        phi_4577_ = -(_e5226[1]);
                                    } else {
                                        phi_4577_ = _e5226[1];
                                    }
                                    let _e5237 = phi_4577_;
                                    if (_e5233 > _e5237) {
                                        phi_4582_ = _e5233;
                                    } else {
                                        phi_4582_ = _e5237;
                                    }
                                    let _e5240 = phi_4582_;
                                    if (_e5226[2] < 0.0lf) {
                                        phi_4589_ = -(_e5226[2]);
                                    } else {
                                        phi_4589_ = _e5226[2];
                                    }
                                    let _e5244 = phi_4589_;
                                    if (_e5240 > _e5244) {
                                        phi_4594_ = _e5240;
                                    } else {
                                        phi_4594_ = _e5244;
                                    }
                                    let _e5247 = phi_4594_;
                                    let _e5250 = local_12.member[1u];
                                    if (_e5250[0] < 0.0lf) {
                                        phi_4607_ = -(_e5250[0]);
                                    } else {
                                        phi_4607_ = _e5250[0];
                                    }
                                    let _e5257 = phi_4607_;
                                    if (_e5250[1] < 0.0lf) {
                                        phi_4614_ = -(_e5250[1]);
                                    } else {
                                        phi_4614_ = _e5250[1];
                                    }
                                    let _e5261 = phi_4614_;
                                    if (_e5257 > _e5261) {
                                        phi_4619_ = _e5257;
                                    } else {
                                        phi_4619_ = _e5261;
                                    }
                                    let _e5264 = phi_4619_;
                                    if (_e5250[2] < 0.0lf) {
                                        phi_4626_ = -(_e5250[2]);
                                    } else {
                                        phi_4626_ = _e5250[2];
                                    }
                                    let _e5268 = phi_4626_;
                                    if (_e5264 > _e5268) {
                                        phi_4631_ = _e5264;
                                    } else {
                                        phi_4631_ = _e5268;
                                    }
                                    let _e5271 = phi_4631_;
                                    if (_e5247 > _e5271) {
                                        phi_4636_ = _e5247;
                                    } else {
                                        phi_4636_ = _e5271;
                                    }
                                    let _e5274 = phi_4636_;
                                    let _e5276 = local_12.member_3;
                                    let _e5280 = local_12.member_1[0u];
                                    if (_e5280[0] < 0.0lf) {
                                        phi_4653_ = -(_e5280[0]);
                                    } else {
                                        phi_4653_ = _e5280[0];
                                    }
                                    let _e5287 = phi_4653_;
                                    if (_e5280[1] < 0.0lf) {
                                        phi_4660_ = -(_e5280[1]);
                                    } else {
                                        phi_4660_ = _e5280[1];
                                    }
                                    let _e5291 = phi_4660_;
                                    if (_e5287 > _e5291) {
                                        phi_4665_ = _e5287;
                                    } else {
                                        phi_4665_ = _e5291;
                                    }
                                    let _e5294 = phi_4665_;
                                    if (_e5280[2] < 0.0lf) {
                                        phi_4672_ = -(_e5280[2]);
                                    } else {
                                        phi_4672_ = _e5280[2];
                                    }
                                    let _e5298 = phi_4672_;
                                    if (_e5294 > _e5298) {
                                        phi_4677_ = _e5294;
                                    } else {
                                        phi_4677_ = _e5298;
                                    }
                                    let _e5301 = phi_4677_;
                                    let _e5304 = local_12.member_1[1u];
                                    if (_e5304[0] < 0.0lf) {
                                        phi_4691_ = -(_e5304[0]);
                                    } else {
                                        phi_4691_ = _e5304[0];
                                    }
                                    let _e5311 = phi_4691_;
                                    if (_e5304[1] < 0.0lf) {
                                        phi_4698_ = -(_e5304[1]);
                                    } else {
                                        phi_4698_ = _e5304[1];
                                    }
                                    let _e5315 = phi_4698_;
                                    if (_e5311 > _e5315) {
                                        phi_4703_ = _e5311;
                                    } else {
                                        phi_4703_ = _e5315;
                                    }
                                    let _e5318 = phi_4703_;
                                    if (_e5304[2] < 0.0lf) {
                                        phi_4710_ = -(_e5304[2]);
                                    } else {
                                        phi_4710_ = _e5304[2];
                                    }
                                    let _e5322 = phi_4710_;
                                    if (_e5318 > _e5322) {
                                        phi_4715_ = _e5318;
                                    } else {
                                        phi_4715_ = _e5322;
                                    }
                                    let _e5325 = phi_4715_;
                                    if (_e5301 > _e5325) {
                                        phi_4720_ = _e5301;
                                    } else {
                                        phi_4720_ = _e5325;
                                    }
                                    let _e5328 = phi_4720_;
                                    let _e5330 = local_12.member_3;
                                    let _e5334 = local_12.member_2[0u];
                                    if (_e5334[0] < 0.0lf) {
                                        phi_4737_ = -(_e5334[0]);
                                    } else {
                                        phi_4737_ = _e5334[0];
                                    }
                                    let _e5341 = phi_4737_;
                                    if (_e5334[1] < 0.0lf) {
                                        phi_4744_ = -(_e5334[1]);
                                    } else {
                                        phi_4744_ = _e5334[1];
                                    }
                                    let _e5345 = phi_4744_;
                                    if (_e5341 > _e5345) {
                                        phi_4749_ = _e5341;
                                    } else {
                                        phi_4749_ = _e5345;
                                    }
                                    let _e5348 = phi_4749_;
                                    if (_e5334[2] < 0.0lf) {
                                        phi_4756_ = -(_e5334[2]);
                                    } else {
                                        phi_4756_ = _e5334[2];
                                    }
                                    let _e5352 = phi_4756_;
                                    if (_e5348 > _e5352) {
                                        phi_4761_ = _e5348;
                                    } else {
                                        phi_4761_ = _e5352;
                                    }
                                    let _e5355 = phi_4761_;
                                    let _e5358 = local_12.member_2[1u];
                                    if (_e5358[0] < 0.0lf) {
                                        phi_4775_ = -(_e5358[0]);
                                    } else {
                                        phi_4775_ = _e5358[0];
                                    }
                                    let _e5365 = phi_4775_;
                                    if (_e5358[1] < 0.0lf) {
                                        phi_4782_ = -(_e5358[1]);
                                    } else {
                                        phi_4782_ = _e5358[1];
                                    }
                                    let _e5369 = phi_4782_;
                                    if (_e5365 > _e5369) {
                                        phi_4787_ = _e5365;
                                    } else {
                                        phi_4787_ = _e5369;
                                    }
                                    let _e5372 = phi_4787_;
                                    if (_e5358[2] < 0.0lf) {
                                        phi_4794_ = -(_e5358[2]);
                                    } else {
                                        phi_4794_ = _e5358[2];
                                    }
                                    let _e5376 = phi_4794_;
                                    if (_e5372 > _e5376) {
                                        phi_4799_ = _e5372;
                                    } else {
                                        phi_4799_ = _e5376;
                                    }
                                    let _e5379 = phi_4799_;
                                    if (_e5355 > _e5379) {
                                        phi_4804_ = _e5355;
                                    } else {
                                        phi_4804_ = _e5379;
                                    }
                                    let _e5382 = phi_4804_;
                                    let _e5384 = local_12.member_3;
                                    let _e5392 = local_12.member_3;
                                    let _e5402 = (((_e5218 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5274 + _e5276) + (_e5328 + _e5330)) + (_e5382 + _e5384)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5392 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e576.member_1);
                                    if _e5402 {
                                        phi_4828_ = false;
                                    } else {
                                        phi_4828_ = true;
                                    }
                                    let _e5404 = phi_4828_;
                                    phi_4829_ = _e5404;
                                    phi_4830_ = _e5402;
                                } else {
                                    phi_4829_ = false;
                                    phi_4830_ = false;
                                }
                                let _e5406 = phi_4829_;
                                let _e5408 = phi_4830_;
                                local_28 = _e5408;
                                continue;
                                continuing {
                                    phi_4320_ = _e5073;
                                    break if !(_e5406);
                                }
                            }
                            let _e5411 = local_28;
                            if _e5411 {
                                phi_4835_ = type_42(1u, _e5049.member_1);
                                phi_4836_ = false;
                            } else {
                                phi_4835_ = type_42();
                                phi_4836_ = true;
                            }
                            let _e5414 = phi_4835_;
                            let _e5416 = phi_4836_;
                            if _e5416 {
                                phi_4841_ = type_42(2u, _e5049.member_1);
                                phi_4842_ = false;
                            } else {
                                phi_4841_ = type_42();
                                phi_4842_ = true;
                            }
                            let _e5419 = phi_4841_;
                            let _e5421 = phi_4842_;
                            phi_4844_ = _e5419;
                            phi_4845_ = _e5414;
                            phi_4846_ = _e5421;
                        } else {
                            phi_4844_ = type_42();
                            phi_4845_ = type_42(0u, type_42().member_1);
                            phi_4846_ = true;
                        }
                        let _e5423 = phi_4844_;
                        let _e5425 = phi_4845_;
                        let _e5427 = phi_4846_;
                        if _e5427 {
                            phi_4850_ = _e5425;
                        } else {
                            phi_4850_ = _e5423;
                        }
                        let _e5429 = phi_4850_;
                        phi_8820_ = _e5429;
                    } else {
                        if (_e714 < 0.0lf) {
                            phi_4861_ = -(_e714);
                        } else {
                            phi_4861_ = _e714;
                        }
                        let _e1071 = phi_4861_;
                        if (_e737 < 0.0lf) {
                            phi_4867_ = -(_e737);
                        } else {
                            phi_4867_ = _e737;
                        }
                        let _e1075 = phi_4867_;
                        if (_e1071 > _e1075) {
                            phi_4872_ = _e1071;
                        } else {
                            phi_4872_ = _e1075;
                        }
                        let _e1078 = phi_4872_;
                        if (_e760 < 0.0lf) {
                            phi_4878_ = -(_e760);
                        } else {
                            phi_4878_ = _e760;
                        }
                        let _e1082 = phi_4878_;
                        if (_e771 < 0.0lf) {
                            phi_4884_ = -(_e771);
                        } else {
                            phi_4884_ = _e771;
                        }
                        let _e1086 = phi_4884_;
                        if (_e1082 > _e1086) {
                            phi_4889_ = _e1082;
                        } else {
                            phi_4889_ = _e1086;
                        }
                        let _e1089 = phi_4889_;
                        if (_e1078 > _e1089) {
                            phi_4894_ = _e1078;
                        } else {
                            phi_4894_ = _e1089;
                        }
                        let _e1092 = phi_4894_;
                        let _e1094 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1095 = f64(1f);
                        if (_e1092 >= _e1094) {
                            phi_4904_ = (_e1092 <= (_e1095 / _e1094));
                        } else {
                            phi_4904_ = false;
                        }
                        let _e1100 = phi_4904_;
                        if _e1100 {
                            phi_4911_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4911_ = f64(2f);
                        }
                        let _e1105 = phi_4911_;
                        let _e1107 = ((_e1030 * f64(0.34f)) + (_e1092 * _e1105));
                        if _e1100 {
                            phi_4919_ = (_e1095 / _e1092);
                        } else {
                            phi_4919_ = f64(0f);
                        }
                        let _e1111 = phi_4919_;
                        let _e1112 = f64(0f);
                        let _e1113 = f64(1f);
                        let _e1114 = f64(3f);
                        let _e1120 = ((_e737 - (_e1114 * _e714)) * _e1111);
                        let _e1121 = ((_e760 - _e737) * _e1111);
                        let _e1122 = (((_e1114 * _e771) - _e760) * _e1111);
                        local_6[0u] = _e1112;
                        local_6[1u] = _e1113;
                        local_6[2u] = _e1113;
                        local_6[3u] = _e1113;
                        let _e1129 = ((_e1121 * _e1121) - (_e1120 * _e1122));
                        if (_e1129 > _e1112) {
                            if (_e1129 <= 2.2250738585072014e-308lf) {
                                if (_e1129 > 0.0lf) {
                                    phi_4955_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4955_ = 0.0lf;
                                }
                                let _e1182 = phi_4955_;
                                phi_5019_ = _e1182;
                            } else {
                                phi_4962_ = type_17(0i, 5i);
                                phi_4965_ = bitcast<f64>(((bitcast<u64>(_e1129) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1137 = phi_4962_;
                                    let _e1139 = phi_4965_;
                                    local_13 = _e1139;
                                    if (_e1137.member < _e1137.member_1) {
                                        let _e1146 = (_e1137.member + 1i);
                                        if ((false == (_e1146 > _e1137.member)) != false) {
                                            phi_4986_ = true;
                                        } else {
                                            phi_4986_ = false;
                                        }
                                        let _e1151 = phi_4986_;
                                        if _e1151 {
                                            phi_4992_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4992_ = type_18(1u, _e1146);
                                        }
                                        let _e1156 = phi_4992_;
                                        phi_4963_ = type_17(_e1156.member_1, _e1137.member_1);
                                        phi_5006_ = type_18(1u, _e1137.member);
                                    } else {
                                        phi_4963_ = _e1137;
                                        phi_5006_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e1162 = phi_4963_;
                                    let _e1164 = phi_5006_;
                                    let _e1167 = (bitcast<i32>(_e1164.member) != 0i);
                                    if _e1167 {
                                        phi_4966_ = (0.5lf * (_e1139 + (_e1129 / _e1139)));
                                    } else {
                                        phi_4966_ = f64();
                                    }
                                    let _e1172 = phi_4966_;
                                    continue;
                                    continuing {
                                        phi_4962_ = _e1162;
                                        phi_4965_ = _e1172;
                                        break if !(_e1167);
                                    }
                                }
                                let _e1177 = local_13;
                                phi_5019_ = (_e1177 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1184 = phi_5019_;
                            if (_e1121 < _e1112) {
                                phi_5025_ = -(_e1184);
                            } else {
                                phi_5025_ = _e1184;
                            }
                            let _e1188 = phi_5025_;
                            let _e1190 = -((_e1121 + _e1188));
                            local_7[0u] = (_e1190 / (_e1190 + _e1122));
                            local_7[1u] = (_e1120 / (_e1120 + _e1190));
                            let _e1199 = local_7[1u];
                            let _e1200 = local_7[0u];
                            if (_e1199 < _e1200) {
                                let _e1203 = local_7[1u];
                                let _e1205 = local_7[0u];
                                local_7[0u] = _e1203;
                                local_7[1u] = _e1205;
                            }
                            phi_5050_ = type_19(0u, 2u);
                            phi_5053_ = 1u;
                            loop {
                                let _e1209 = phi_5050_;
                                let _e1211 = phi_5053_;
                                local_29 = _e1211;
                                if (_e1209.member < _e1209.member_1) {
                                    phi_5051_ = type_19((_e1209.member + 1u), _e1209.member_1);
                                    phi_5076_ = type_19(1u, _e1209.member);
                                } else {
                                    phi_5051_ = _e1209;
                                    phi_5076_ = type_19(0u, type_19().member_1);
                                }
                                let _e1223 = phi_5051_;
                                let _e1225 = phi_5076_;
                                let _e1229 = (bitcast<i32>(_e1225.member) != 0i);
                                if _e1229 {
                                    let _e1231 = local_7[_e1225.member_1];
                                    if (_e1231 > _e1112) {
                                        let _e1234 = local_7[_e1225.member_1];
                                        if (_e1234 < _e1113) {
                                            let _e1237 = local_7[_e1225.member_1];
                                            local_6[_e1211] = _e1237;
                                            phi_5120_ = (_e1211 + 1u);
                                        } else {
                                            phi_5120_ = _e1211;
                                        }
                                        let _e1241 = phi_5120_;
                                        phi_5121_ = _e1241;
                                    } else {
                                        phi_5121_ = _e1211;
                                    }
                                    let _e1243 = phi_5121_;
                                    phi_5054_ = _e1243;
                                } else {
                                    phi_5054_ = u32();
                                }
                                let _e1245 = phi_5054_;
                                continue;
                                continuing {
                                    phi_5050_ = _e1223;
                                    phi_5053_ = _e1245;
                                    break if !(_e1229);
                                }
                            }
                            let _e5653 = local_29;
                            phi_5122_ = _e5653;
                        } else {
                            phi_5122_ = 1u;
                        }
                        let _e1248 = phi_5122_;
                        local_6[_e1248] = _e1113;
                        let _e1250 = local_6;
                        local_8 = _e1250;
                        phi_5142_ = type_19(0u, _e1248);
                        loop {
                            let _e1253 = phi_5142_;
                            if (_e1253.member < _e1253.member_1) {
                                phi_5143_ = type_19((_e1253.member + 1u), _e1253.member_1);
                                phi_5166_ = type_19(1u, _e1253.member);
                            } else {
                                phi_5143_ = _e1253;
                                phi_5166_ = type_19(0u, type_19().member_1);
                            }
                            let _e1265 = phi_5143_;
                            let _e1267 = phi_5166_;
                            if (bitcast<i32>(_e1267.member) != 0i) {
                                let _e1273 = local_8[_e1267.member_1];
                                let _e1276 = local_8[(_e1267.member_1 + 1u)];
                                let _e1278 = (f64(1f) - _e1273);
                                let _e1289 = ((((_e714 * _e1278) + (_e737 * _e1273)) * (_e1278 * _e1278)) + (((_e760 * _e1278) + (_e771 * _e1273)) * (_e1273 * _e1273)));
                                let _e1291 = (f64(1f) - _e1276);
                                let _e1302 = ((((_e714 * _e1291) + (_e737 * _e1276)) * (_e1291 * _e1291)) + (((_e760 * _e1291) + (_e771 * _e1276)) * (_e1276 * _e1276)));
                                if (_e1289 < 0.0lf) {
                                    phi_5220_ = -(_e1289);
                                } else {
                                    phi_5220_ = _e1289;
                                }
                                let _e1306 = phi_5220_;
                                let _e1307 = (_e1306 > _e1107);
                                if (_e1302 < 0.0lf) {
                                    phi_5227_ = -(_e1302);
                                } else {
                                    phi_5227_ = _e1302;
                                }
                                let _e1311 = phi_5227_;
                                let _e1312 = (_e1311 > _e1107);
                                let _e1313 = f64(0f);
                                if _e1307 {
                                    if _e1312 {
                                        phi_5239_ = ((_e1289 > _e1313) != (_e1302 > _e1313));
                                        phi_5240_ = false;
                                    } else {
                                        phi_5239_ = bool();
                                        phi_5240_ = true;
                                    }
                                    let _e1318 = phi_5239_;
                                    let _e1320 = phi_5240_;
                                    phi_5241_ = _e1318;
                                    phi_5242_ = _e1320;
                                } else {
                                    phi_5241_ = bool();
                                    phi_5242_ = true;
                                }
                                let _e1322 = phi_5241_;
                                let _e1324 = phi_5242_;
                                if _e1324 {
                                    phi_5246_ = false;
                                } else {
                                    phi_5246_ = _e1322;
                                }
                                let _e1326 = phi_5246_;
                                if _e1307 {
                                    if _e1312 {
                                        if _e1326 {
                                            phi_5258_ = type_43();
                                        } else {
                                            phi_5258_ = type_43(f64(1f), _e1313, _e1326);
                                        }
                                        let _e1330 = phi_5258_;
                                        phi_5259_ = _e1330;
                                        phi_5260_ = _e1326;
                                    } else {
                                        phi_5259_ = type_43();
                                        phi_5260_ = true;
                                    }
                                    let _e1332 = phi_5259_;
                                    let _e1334 = phi_5260_;
                                    phi_5261_ = _e1332;
                                    phi_5262_ = _e1334;
                                } else {
                                    phi_5261_ = type_43();
                                    phi_5262_ = true;
                                }
                                let _e1336 = phi_5261_;
                                let _e1338 = phi_5262_;
                                if _e1338 {
                                    if _e1307 {
                                        if (_e1289 < _e1313) {
                                            phi_5275_ = f64(-1f);
                                        } else {
                                            phi_5275_ = f64(1f);
                                        }
                                        let _e1343 = phi_5275_;
                                        let _e1344 = f64(0.00000000000022737368f);
                                        let _e1345 = f64(0.5f);
                                        let _e1346 = f64(3f);
                                        let _e1349 = (_e760 - _e737);
                                        phi_5288_ = type_19(0u, 64u);
                                        phi_5291_ = _e1276;
                                        phi_5293_ = _e1273;
                                        phi_5295_ = (_e1345 * (_e1273 + _e1276));
                                        loop {
                                            let _e1355 = phi_5288_;
                                            let _e1357 = phi_5291_;
                                            let _e1359 = phi_5293_;
                                            let _e1361 = phi_5295_;
                                            local_31 = _e1359;
                                            if (_e1355.member < _e1355.member_1) {
                                                phi_5289_ = type_19((_e1355.member + 1u), _e1355.member_1);
                                                phi_5318_ = type_19(1u, _e1355.member);
                                            } else {
                                                phi_5289_ = _e1355;
                                                phi_5318_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1373 = phi_5289_;
                                            let _e1375 = phi_5318_;
                                            if (bitcast<i32>(_e1375.member) != 0i) {
                                                let _e1380 = (f64(1f) - _e1361);
                                                let _e1393 = ((_e1343 * ((((_e714 * _e1380) + (_e737 * _e1361)) * (_e1380 * _e1380)) + (((_e760 * _e1380) + (_e771 * _e1361)) * (_e1361 * _e1361)))) - _e1107);
                                                if (_e1393 > f64(0f)) {
                                                    phi_5345_ = _e1357;
                                                    phi_5346_ = _e1361;
                                                } else {
                                                    phi_5345_ = _e1361;
                                                    phi_5346_ = _e1359;
                                                }
                                                let _e1397 = phi_5345_;
                                                let _e1399 = phi_5346_;
                                                let _e1401 = ((_e1397 - _e1399) > _e1344);
                                                if _e1401 {
                                                    let _e1403 = (f64(1f) - _e1361);
                                                    let _e1415 = (-(_e1393) / (_e1343 * (((((_e737 - (_e1346 * _e714)) * _e1403) + (_e1349 * _e1361)) * _e1403) + (((_e1349 * _e1403) + (((_e1346 * _e771) - _e760) * _e1361)) * _e1361))));
                                                    if (_e1393 > f64(0f)) {
                                                        phi_5374_ = (_e1345 * _e1344);
                                                    } else {
                                                        phi_5374_ = -((_e1345 * _e1344));
                                                    }
                                                    let _e1422 = phi_5374_;
                                                    let _e1424 = ((_e1361 + _e1415) + _e1422);
                                                    if (_e1424 > _e1399) {
                                                        if (_e1424 < _e1397) {
                                                            if (_e1415 < 0.0lf) {
                                                                phi_5390_ = -(_e1415);
                                                            } else {
                                                                phi_5390_ = _e1415;
                                                            }
                                                            let _e1430 = phi_5390_;
                                                            if (_e1430 < (_e1345 * (_e1397 - _e1399))) {
                                                                phi_5397_ = false;
                                                            } else {
                                                                phi_5397_ = true;
                                                            }
                                                            let _e1435 = phi_5397_;
                                                            phi_5398_ = _e1435;
                                                        } else {
                                                            phi_5398_ = true;
                                                        }
                                                        let _e1437 = phi_5398_;
                                                        phi_5399_ = _e1437;
                                                    } else {
                                                        phi_5399_ = true;
                                                    }
                                                    let _e1439 = phi_5399_;
                                                    if _e1439 {
                                                        phi_5405_ = (_e1345 * (_e1399 + _e1397));
                                                    } else {
                                                        phi_5405_ = _e1424;
                                                    }
                                                    let _e1443 = phi_5405_;
                                                    phi_5406_ = _e1443;
                                                    phi_5407_ = false;
                                                } else {
                                                    phi_5406_ = f64();
                                                    phi_5407_ = true;
                                                }
                                                let _e1445 = phi_5406_;
                                                let _e1447 = phi_5407_;
                                                phi_5292_ = _e1397;
                                                phi_5294_ = _e1399;
                                                phi_5296_ = _e1445;
                                                phi_5408_ = _e1399;
                                                phi_5409_ = _e1401;
                                                phi_5410_ = _e1447;
                                            } else {
                                                phi_5292_ = f64();
                                                phi_5294_ = f64();
                                                phi_5296_ = f64();
                                                phi_5408_ = f64();
                                                phi_5409_ = false;
                                                phi_5410_ = false;
                                            }
                                            let _e1449 = phi_5292_;
                                            let _e1451 = phi_5294_;
                                            let _e1453 = phi_5296_;
                                            let _e1455 = phi_5408_;
                                            let _e1457 = phi_5409_;
                                            let _e1459 = phi_5410_;
                                            local_14 = _e1459;
                                            local_30 = _e1455;
                                            continue;
                                            continuing {
                                                phi_5288_ = _e1373;
                                                phi_5291_ = _e1449;
                                                phi_5293_ = _e1451;
                                                phi_5295_ = _e1453;
                                                break if !(_e1457);
                                            }
                                        }
                                        let _e1462 = local_14;
                                        if _e1462 {
                                            let _e5695 = local_30;
                                            phi_5414_ = _e5695;
                                        } else {
                                            let _e5697 = local_31;
                                            phi_5414_ = _e5697;
                                        }
                                        let _e1464 = phi_5414_;
                                        phi_5415_ = _e1464;
                                    } else {
                                        phi_5415_ = _e1273;
                                    }
                                    let _e1466 = phi_5415_;
                                    if _e1312 {
                                        if (_e1302 < _e1313) {
                                            phi_5425_ = f64(-1f);
                                        } else {
                                            phi_5425_ = f64(1f);
                                        }
                                        let _e1471 = phi_5425_;
                                        phi_5430_ = type_19(0u, 64u);
                                        phi_5433_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1475 = phi_5430_;
                                            let _e1477 = phi_5433_;
                                            if (_e1475.member < _e1475.member_1) {
                                                phi_5431_ = type_19((_e1475.member + 1u), _e1475.member_1);
                                                phi_5456_ = type_19(1u, _e1475.member);
                                            } else {
                                                phi_5431_ = _e1475;
                                                phi_5456_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1489 = phi_5431_;
                                            let _e1491 = phi_5456_;
                                            if (bitcast<i32>(_e1491.member) != 0i) {
                                                let _e1495 = (_e1466 + _e1477);
                                                if (_e1495 < _e1276) {
                                                    let _e1498 = (f64(1f) - _e1495);
                                                    let _e1511 = ((_e1471 * ((((_e714 * _e1498) + (_e737 * _e1495)) * (_e1498 * _e1498)) + (((_e760 * _e1498) + (_e771 * _e1495)) * (_e1495 * _e1495)))) > _e1107);
                                                    if _e1511 {
                                                        phi_5487_ = f64();
                                                        phi_5488_ = false;
                                                    } else {
                                                        phi_5487_ = (_e1477 + _e1477);
                                                        phi_5488_ = true;
                                                    }
                                                    let _e1514 = phi_5487_;
                                                    let _e1516 = phi_5488_;
                                                    phi_5489_ = _e1514;
                                                    phi_5490_ = _e1516;
                                                    phi_5491_ = _e1511;
                                                    phi_5492_ = false;
                                                } else {
                                                    phi_5489_ = f64();
                                                    phi_5490_ = false;
                                                    phi_5491_ = false;
                                                    phi_5492_ = true;
                                                }
                                                let _e1518 = phi_5489_;
                                                let _e1520 = phi_5490_;
                                                let _e1522 = phi_5491_;
                                                let _e1524 = phi_5492_;
                                                phi_5493_ = _e1495;
                                                phi_5434_ = _e1518;
                                                phi_5494_ = _e1520;
                                                phi_5495_ = _e1522;
                                                phi_5496_ = _e1524;
                                                phi_5497_ = false;
                                            } else {
                                                phi_5493_ = f64();
                                                phi_5434_ = f64();
                                                phi_5494_ = false;
                                                phi_5495_ = false;
                                                phi_5496_ = false;
                                                phi_5497_ = true;
                                            }
                                            let _e1526 = phi_5493_;
                                            let _e1528 = phi_5434_;
                                            let _e1530 = phi_5494_;
                                            let _e1532 = phi_5495_;
                                            let _e1534 = phi_5496_;
                                            let _e1536 = phi_5497_;
                                            local_15 = _e1532;
                                            local_32 = _e1534;
                                            local_33 = _e1536;
                                            local_34 = _e1526;
                                            continue;
                                            continuing {
                                                phi_5430_ = _e1489;
                                                phi_5433_ = _e1528;
                                                break if !(_e1530);
                                            }
                                        }
                                        let _e1539 = local_15;
                                        if _e1539 {
                                            phi_5501_ = false;
                                            phi_5502_ = false;
                                        } else {
                                            let _e5719 = local_32;
                                            phi_5501_ = _e5719;
                                            let _e5722 = local_33;
                                            phi_5502_ = _e5722;
                                        }
                                        let _e1541 = phi_5501_;
                                        let _e1543 = phi_5502_;
                                        if _e1541 {
                                            phi_5506_ = true;
                                        } else {
                                            phi_5506_ = _e1543;
                                        }
                                        let _e1545 = phi_5506_;
                                        if _e1545 {
                                            phi_5510_ = _e1276;
                                        } else {
                                            let _e5726 = local_34;
                                            phi_5510_ = _e5726;
                                        }
                                        let _e1547 = phi_5510_;
                                        phi_5511_ = _e1547;
                                    } else {
                                        phi_5511_ = _e1276;
                                    }
                                    let _e1549 = phi_5511_;
                                    phi_5513_ = type_43(_e1466, _e1549, _e1326);
                                } else {
                                    phi_5513_ = _e1336;
                                }
                                let _e1552 = phi_5513_;
                                if (_e1552.member > _e1552.member_1) {
                                    phi_8776_ = f64();
                                    phi_8777_ = true;
                                    phi_8778_ = false;
                                    phi_8779_ = false;
                                    phi_8780_ = false;
                                } else {
                                    let _e1560 = ((_e1552.member_1 - _e1552.member) * f64(0.5f));
                                    let _e1561 = (_e1552.member + _e1560);
                                    let _e1564 = (_e1560 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1566 = local_12.member_3;
                                    let _e1569 = local_12.member[0u];
                                    if (_e1569[0] < 0.0lf) {
                                        phi_5544_ = -(_e1569[0]);
                                    } else {
                                        phi_5544_ = _e1569[0];
                                    }
                                    let _e1576 = phi_5544_;
                                    if (_e1569[1] < 0.0lf) {
                                        phi_5551_ = -(_e1569[1]);
                                    } else {
                                        phi_5551_ = _e1569[1];
                                    }
                                    let _e1580 = phi_5551_;
                                    if (_e1576 > _e1580) {
                                        phi_5556_ = _e1576;
                                    } else {
                                        phi_5556_ = _e1580;
                                    }
                                    let _e1583 = phi_5556_;
                                    if (_e1569[2] < 0.0lf) {
                                        phi_5563_ = -(_e1569[2]);
                                    } else {
                                        phi_5563_ = _e1569[2];
                                    }
                                    let _e1587 = phi_5563_;
                                    if (_e1583 > _e1587) {
                                        phi_5568_ = _e1583;
                                    } else {
                                        phi_5568_ = _e1587;
                                    }
                                    let _e1590 = phi_5568_;
                                    let _e1592 = local_12.member[1u];
                                    if (_e1592[0] < 0.0lf) {
                                        phi_5581_ = -(_e1592[0]);
                                    } else {
                                        phi_5581_ = _e1592[0];
                                    }
                                    let _e1599 = phi_5581_;
                                    if (_e1592[1] < 0.0lf) {
                                        phi_5588_ = -(_e1592[1]);
                                    } else {
                                        phi_5588_ = _e1592[1];
                                    }
                                    let _e1603 = phi_5588_;
                                    if (_e1599 > _e1603) {
                                        phi_5593_ = _e1599;
                                    } else {
                                        phi_5593_ = _e1603;
                                    }
                                    let _e1606 = phi_5593_;
                                    if (_e1592[2] < 0.0lf) {
                                        phi_5600_ = -(_e1592[2]);
                                    } else {
                                        phi_5600_ = _e1592[2];
                                    }
                                    let _e1610 = phi_5600_;
                                    if (_e1606 > _e1610) {
                                        phi_5605_ = _e1606;
                                    } else {
                                        phi_5605_ = _e1610;
                                    }
                                    let _e1613 = phi_5605_;
                                    if (_e1590 > _e1613) {
                                        phi_5610_ = _e1590;
                                    } else {
                                        phi_5610_ = _e1613;
                                    }
                                    let _e1616 = phi_5610_;
                                    let _e1619 = local_12.member[0u];
                                    let _e1624 = local_12.member[1u];
                                    let _e1634 = (_e1619[0] + ((_e1624[0] - _e1619[0]) * _e1561));
                                    let _e1635 = (_e1619[1] + ((_e1624[1] - _e1619[1]) * _e1561));
                                    let _e1636 = (_e1619[2] + ((_e1624[2] - _e1619[2]) * _e1561));
                                    let _e1638 = local_12.member[1u];
                                    let _e1643 = local_12.member[0u];
                                    let _e1647 = (_e1638[0] - _e1643[0]);
                                    let _e1648 = (_e1638[1] - _e1643[1]);
                                    let _e1649 = (_e1638[2] - _e1643[2]);
                                    if (_e1647 < 0.0lf) {
                                        phi_5669_ = -(_e1647);
                                    } else {
                                        phi_5669_ = _e1647;
                                    }
                                    let _e1653 = phi_5669_;
                                    if (_e1648 < 0.0lf) {
                                        phi_5675_ = -(_e1648);
                                    } else {
                                        phi_5675_ = _e1648;
                                    }
                                    let _e1657 = phi_5675_;
                                    if (_e1653 > _e1657) {
                                        phi_5680_ = _e1653;
                                    } else {
                                        phi_5680_ = _e1657;
                                    }
                                    let _e1660 = phi_5680_;
                                    if (_e1649 < 0.0lf) {
                                        phi_5686_ = -(_e1649);
                                    } else {
                                        phi_5686_ = _e1649;
                                    }
                                    let _e1664 = phi_5686_;
                                    if (_e1660 > _e1664) {
                                        phi_5691_ = _e1660;
                                    } else {
                                        phi_5691_ = _e1664;
                                    }
                                    let _e1667 = phi_5691_;
                                    let _e1675 = ((((_e1564 * _e1667) * f64(1.01f)) + ((_e1616 + _e1566) * (1.1102230246251565e-16lf * f64(8f)))) + _e1566);
                                    if (_e1634 < 0.0lf) {
                                        phi_5705_ = -(_e1634);
                                    } else {
                                        phi_5705_ = _e1634;
                                    }
                                    let _e1679 = phi_5705_;
                                    if (_e1635 < 0.0lf) {
                                        phi_5711_ = -(_e1635);
                                    } else {
                                        phi_5711_ = _e1635;
                                    }
                                    let _e1683 = phi_5711_;
                                    if (_e1679 > _e1683) {
                                        phi_5716_ = _e1679;
                                    } else {
                                        phi_5716_ = _e1683;
                                    }
                                    let _e1686 = phi_5716_;
                                    if (_e1636 < 0.0lf) {
                                        phi_5722_ = -(_e1636);
                                    } else {
                                        phi_5722_ = _e1636;
                                    }
                                    let _e1690 = phi_5722_;
                                    if (_e1686 > _e1690) {
                                        phi_5727_ = _e1686;
                                    } else {
                                        phi_5727_ = _e1690;
                                    }
                                    let _e1693 = phi_5727_;
                                    local_2 = type_33(array<f64, 3>(_e1634, _e1635, _e1636), _e1675, (_e1693 + _e1675));
                                    let _e1699 = local_12.member_3;
                                    let _e1701 = local_12.member_1[0u];
                                    if (_e1701[0] < 0.0lf) {
                                        phi_5753_ = -(_e1701[0]);
                                    } else {
                                        phi_5753_ = _e1701[0];
                                    }
                                    let _e1708 = phi_5753_;
                                    if (_e1701[1] < 0.0lf) {
                                        phi_5760_ = -(_e1701[1]);
                                    } else {
                                        phi_5760_ = _e1701[1];
                                    }
                                    let _e1712 = phi_5760_;
                                    if (_e1708 > _e1712) {
                                        phi_5765_ = _e1708;
                                    } else {
                                        phi_5765_ = _e1712;
                                    }
                                    let _e1715 = phi_5765_;
                                    if (_e1701[2] < 0.0lf) {
                                        phi_5772_ = -(_e1701[2]);
                                    } else {
                                        phi_5772_ = _e1701[2];
                                    }
                                    let _e1719 = phi_5772_;
                                    if (_e1715 > _e1719) {
                                        phi_5777_ = _e1715;
                                    } else {
                                        phi_5777_ = _e1719;
                                    }
                                    let _e1722 = phi_5777_;
                                    let _e1724 = local_12.member_1[1u];
                                    if (_e1724[0] < 0.0lf) {
                                        phi_5790_ = -(_e1724[0]);
                                    } else {
                                        phi_5790_ = _e1724[0];
                                    }
                                    let _e1731 = phi_5790_;
                                    if (_e1724[1] < 0.0lf) {
                                        phi_5797_ = -(_e1724[1]);
                                    } else {
                                        phi_5797_ = _e1724[1];
                                    }
                                    let _e1735 = phi_5797_;
                                    if (_e1731 > _e1735) {
                                        phi_5802_ = _e1731;
                                    } else {
                                        phi_5802_ = _e1735;
                                    }
                                    let _e1738 = phi_5802_;
                                    if (_e1724[2] < 0.0lf) {
                                        phi_5809_ = -(_e1724[2]);
                                    } else {
                                        phi_5809_ = _e1724[2];
                                    }
                                    let _e1742 = phi_5809_;
                                    if (_e1738 > _e1742) {
                                        phi_5814_ = _e1738;
                                    } else {
                                        phi_5814_ = _e1742;
                                    }
                                    let _e1745 = phi_5814_;
                                    if (_e1722 > _e1745) {
                                        phi_5819_ = _e1722;
                                    } else {
                                        phi_5819_ = _e1745;
                                    }
                                    let _e1748 = phi_5819_;
                                    let _e1751 = local_12.member_1[0u];
                                    let _e1756 = local_12.member_1[1u];
                                    let _e1766 = (_e1751[0] + ((_e1756[0] - _e1751[0]) * _e1561));
                                    let _e1767 = (_e1751[1] + ((_e1756[1] - _e1751[1]) * _e1561));
                                    let _e1768 = (_e1751[2] + ((_e1756[2] - _e1751[2]) * _e1561));
                                    let _e1770 = local_12.member_1[1u];
                                    let _e1775 = local_12.member_1[0u];
                                    let _e1779 = (_e1770[0] - _e1775[0]);
                                    let _e1780 = (_e1770[1] - _e1775[1]);
                                    let _e1781 = (_e1770[2] - _e1775[2]);
                                    if (_e1779 < 0.0lf) {
                                        phi_5878_ = -(_e1779);
                                    } else {
                                        phi_5878_ = _e1779;
                                    }
                                    let _e1785 = phi_5878_;
                                    if (_e1780 < 0.0lf) {
                                        phi_5884_ = -(_e1780);
                                    } else {
                                        phi_5884_ = _e1780;
                                    }
                                    let _e1789 = phi_5884_;
                                    if (_e1785 > _e1789) {
                                        phi_5889_ = _e1785;
                                    } else {
                                        phi_5889_ = _e1789;
                                    }
                                    let _e1792 = phi_5889_;
                                    if (_e1781 < 0.0lf) {
                                        phi_5895_ = -(_e1781);
                                    } else {
                                        phi_5895_ = _e1781;
                                    }
                                    let _e1796 = phi_5895_;
                                    if (_e1792 > _e1796) {
                                        phi_5900_ = _e1792;
                                    } else {
                                        phi_5900_ = _e1796;
                                    }
                                    let _e1799 = phi_5900_;
                                    let _e1807 = ((((_e1564 * _e1799) * f64(1.01f)) + ((_e1748 + _e1699) * (1.1102230246251565e-16lf * f64(8f)))) + _e1699);
                                    if (_e1766 < 0.0lf) {
                                        phi_5914_ = -(_e1766);
                                    } else {
                                        phi_5914_ = _e1766;
                                    }
                                    let _e1811 = phi_5914_;
                                    if (_e1767 < 0.0lf) {
                                        phi_5920_ = -(_e1767);
                                    } else {
                                        phi_5920_ = _e1767;
                                    }
                                    let _e1815 = phi_5920_;
                                    if (_e1811 > _e1815) {
                                        phi_5925_ = _e1811;
                                    } else {
                                        phi_5925_ = _e1815;
                                    }
                                    let _e1818 = phi_5925_;
                                    if (_e1768 < 0.0lf) {
                                        phi_5931_ = -(_e1768);
                                    } else {
                                        phi_5931_ = _e1768;
                                    }
                                    let _e1822 = phi_5931_;
                                    if (_e1818 > _e1822) {
                                        phi_5936_ = _e1818;
                                    } else {
                                        phi_5936_ = _e1822;
                                    }
                                    let _e1825 = phi_5936_;
                                    local_3 = type_33(array<f64, 3>(_e1766, _e1767, _e1768), _e1807, (_e1825 + _e1807));
                                    let _e1831 = local_12.member_3;
                                    let _e1833 = local_12.member_2[0u];
                                    if (_e1833[0] < 0.0lf) {
                                        phi_5962_ = -(_e1833[0]);
                                    } else {
                                        phi_5962_ = _e1833[0];
                                    }
                                    let _e1840 = phi_5962_;
                                    if (_e1833[1] < 0.0lf) {
                                        phi_5969_ = -(_e1833[1]);
                                    } else {
                                        phi_5969_ = _e1833[1];
                                    }
                                    let _e1844 = phi_5969_;
                                    if (_e1840 > _e1844) {
                                        phi_5974_ = _e1840;
                                    } else {
                                        phi_5974_ = _e1844;
                                    }
                                    let _e1847 = phi_5974_;
                                    if (_e1833[2] < 0.0lf) {
                                        phi_5981_ = -(_e1833[2]);
                                    } else {
                                        phi_5981_ = _e1833[2];
                                    }
                                    let _e1851 = phi_5981_;
                                    if (_e1847 > _e1851) {
                                        phi_5986_ = _e1847;
                                    } else {
                                        phi_5986_ = _e1851;
                                    }
                                    let _e1854 = phi_5986_;
                                    let _e1856 = local_12.member_2[1u];
                                    if (_e1856[0] < 0.0lf) {
                                        phi_5999_ = -(_e1856[0]);
                                    } else {
                                        phi_5999_ = _e1856[0];
                                    }
                                    let _e1863 = phi_5999_;
                                    if (_e1856[1] < 0.0lf) {
                                        phi_6006_ = -(_e1856[1]);
                                    } else {
                                        phi_6006_ = _e1856[1];
                                    }
                                    let _e1867 = phi_6006_;
                                    if (_e1863 > _e1867) {
                                        phi_6011_ = _e1863;
                                    } else {
                                        phi_6011_ = _e1867;
                                    }
                                    let _e1870 = phi_6011_;
                                    if (_e1856[2] < 0.0lf) {
                                        phi_6018_ = -(_e1856[2]);
                                    } else {
                                        phi_6018_ = _e1856[2];
                                    }
                                    let _e1874 = phi_6018_;
                                    if (_e1870 > _e1874) {
                                        phi_6023_ = _e1870;
                                    } else {
                                        phi_6023_ = _e1874;
                                    }
                                    let _e1877 = phi_6023_;
                                    if (_e1854 > _e1877) {
                                        phi_6028_ = _e1854;
                                    } else {
                                        phi_6028_ = _e1877;
                                    }
                                    let _e1880 = phi_6028_;
                                    let _e1883 = local_12.member_2[0u];
                                    let _e1888 = local_12.member_2[1u];
                                    let _e1898 = (_e1883[0] + ((_e1888[0] - _e1883[0]) * _e1561));
                                    let _e1899 = (_e1883[1] + ((_e1888[1] - _e1883[1]) * _e1561));
                                    let _e1900 = (_e1883[2] + ((_e1888[2] - _e1883[2]) * _e1561));
                                    let _e1902 = local_12.member_2[1u];
                                    let _e1907 = local_12.member_2[0u];
                                    let _e1911 = (_e1902[0] - _e1907[0]);
                                    let _e1912 = (_e1902[1] - _e1907[1]);
                                    let _e1913 = (_e1902[2] - _e1907[2]);
                                    if (_e1911 < 0.0lf) {
                                        phi_6087_ = -(_e1911);
                                    } else {
                                        phi_6087_ = _e1911;
                                    }
                                    let _e1917 = phi_6087_;
                                    if (_e1912 < 0.0lf) {
                                        phi_6093_ = -(_e1912);
                                    } else {
                                        phi_6093_ = _e1912;
                                    }
                                    let _e1921 = phi_6093_;
                                    if (_e1917 > _e1921) {
                                        phi_6098_ = _e1917;
                                    } else {
                                        phi_6098_ = _e1921;
                                    }
                                    let _e1924 = phi_6098_;
                                    if (_e1913 < 0.0lf) {
                                        phi_6104_ = -(_e1913);
                                    } else {
                                        phi_6104_ = _e1913;
                                    }
                                    let _e1928 = phi_6104_;
                                    if (_e1924 > _e1928) {
                                        phi_6109_ = _e1924;
                                    } else {
                                        phi_6109_ = _e1928;
                                    }
                                    let _e1931 = phi_6109_;
                                    let _e1939 = ((((_e1564 * _e1931) * f64(1.01f)) + ((_e1880 + _e1831) * (1.1102230246251565e-16lf * f64(8f)))) + _e1831);
                                    if (_e1898 < 0.0lf) {
                                        phi_6123_ = -(_e1898);
                                    } else {
                                        phi_6123_ = _e1898;
                                    }
                                    let _e1943 = phi_6123_;
                                    if (_e1899 < 0.0lf) {
                                        phi_6129_ = -(_e1899);
                                    } else {
                                        phi_6129_ = _e1899;
                                    }
                                    let _e1947 = phi_6129_;
                                    if (_e1943 > _e1947) {
                                        phi_6134_ = _e1943;
                                    } else {
                                        phi_6134_ = _e1947;
                                    }
                                    let _e1950 = phi_6134_;
                                    if (_e1900 < 0.0lf) {
                                        phi_6140_ = -(_e1900);
                                    } else {
                                        phi_6140_ = _e1900;
                                    }
                                    let _e1954 = phi_6140_;
                                    if (_e1950 > _e1954) {
                                        phi_6145_ = _e1950;
                                    } else {
                                        phi_6145_ = _e1954;
                                    }
                                    let _e1957 = phi_6145_;
                                    local_4 = type_33(array<f64, 3>(_e1898, _e1899, _e1900), _e1939, (_e1957 + _e1939));
                                    let _e1962 = local_3.member;
                                    let _e1967 = local_4.member;
                                    let _e1973 = ((_e1962[1] * _e1967[2]) - (_e1962[2] * _e1967[1]));
                                    let _e1976 = ((_e1962[2] * _e1967[0]) - (_e1962[0] * _e1967[2]));
                                    let _e1979 = ((_e1962[0] * _e1967[1]) - (_e1962[1] * _e1967[0]));
                                    if (_e1973 < 0.0lf) {
                                        phi_6194_ = -(_e1973);
                                    } else {
                                        phi_6194_ = _e1973;
                                    }
                                    let _e1983 = phi_6194_;
                                    if (_e1976 < 0.0lf) {
                                        phi_6200_ = -(_e1976);
                                    } else {
                                        phi_6200_ = _e1976;
                                    }
                                    let _e1987 = phi_6200_;
                                    if (_e1983 > _e1987) {
                                        if (_e1973 < 0.0lf) {
                                            phi_6210_ = -(_e1973);
                                        } else {
                                            phi_6210_ = _e1973;
                                        }
                                        let _e2005 = phi_6210_;
                                        if (_e1979 < 0.0lf) {
                                            phi_6216_ = -(_e1979);
                                        } else {
                                            phi_6216_ = _e1979;
                                        }
                                        let _e2009 = phi_6216_;
                                        if (_e2005 > _e2009) {
                                            phi_6221_ = 2u;
                                            phi_6222_ = 1u;
                                        } else {
                                            phi_6221_ = 1u;
                                            phi_6222_ = 0u;
                                        }
                                        let _e2012 = phi_6221_;
                                        let _e2014 = phi_6222_;
                                        phi_6241_ = _e2012;
                                        phi_6242_ = _e2014;
                                    } else {
                                        if (_e1976 < 0.0lf) {
                                            phi_6228_ = -(_e1976);
                                        } else {
                                            phi_6228_ = _e1976;
                                        }
                                        let _e1992 = phi_6228_;
                                        if (_e1979 < 0.0lf) {
                                            phi_6234_ = -(_e1979);
                                        } else {
                                            phi_6234_ = _e1979;
                                        }
                                        let _e1996 = phi_6234_;
                                        if (_e1992 > _e1996) {
                                            phi_6239_ = 0u;
                                            phi_6240_ = 2u;
                                        } else {
                                            phi_6239_ = 1u;
                                            phi_6240_ = 0u;
                                        }
                                        let _e1999 = phi_6239_;
                                        let _e2001 = phi_6240_;
                                        phi_6241_ = _e1999;
                                        phi_6242_ = _e2001;
                                    }
                                    let _e2016 = phi_6241_;
                                    let _e2018 = phi_6242_;
                                    let _e2021 = local_3.member[_e2018];
                                    let _e2024 = local_4.member[_e2016];
                                    let _e2028 = local_3.member[_e2016];
                                    let _e2031 = local_4.member[_e2018];
                                    let _e2033 = ((_e2021 * _e2024) - (_e2028 * _e2031));
                                    let _e2034 = f64(1f);
                                    let _e2035 = f64(2f);
                                    let _e2037 = local_3.member_1;
                                    let _e2039 = local_4.member_2;
                                    let _e2042 = local_3.member_2;
                                    let _e2044 = local_4.member_1;
                                    let _e2050 = local_3.member_2;
                                    let _e2053 = local_4.member_2;
                                    let _e2062 = local_3.member_2;
                                    let _e2065 = local_4.member_2;
                                    let _e2069 = (((((_e2037 * _e2039) + (_e2042 * _e2044)) * f64(2.01f)) + (((_e2050 * _e2035) * (_e2053 * _e2035)) * (1.1102230246251565e-16lf * _e2035))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2034 + _e2062) * (_e2034 + _e2065))));
                                    if (_e2033 < 0.0lf) {
                                        phi_6315_ = -(_e2033);
                                    } else {
                                        phi_6315_ = _e2033;
                                    }
                                    let _e2073 = phi_6315_;
                                    if (_e2073 > _e2069) {
                                        if (_e2033 < f64(0f)) {
                                            phi_6327_ = f64(-1f);
                                        } else {
                                            phi_6327_ = f64(1f);
                                        }
                                        let _e2080 = phi_6327_;
                                        let _e2083 = local_2.member[_e2018];
                                        let _e2086 = local_4.member[_e2016];
                                        let _e2090 = local_2.member[_e2016];
                                        let _e2093 = local_4.member[_e2018];
                                        let _e2096 = f64(1f);
                                        let _e2097 = f64(2f);
                                        let _e2099 = local_2.member_1;
                                        let _e2101 = local_4.member_2;
                                        let _e2104 = local_2.member_2;
                                        let _e2106 = local_4.member_1;
                                        let _e2112 = local_2.member_2;
                                        let _e2115 = local_4.member_2;
                                        let _e2124 = local_2.member_2;
                                        let _e2127 = local_4.member_2;
                                        let _e2131 = (((((_e2099 * _e2101) + (_e2104 * _e2106)) * f64(2.01f)) + (((_e2112 * _e2097) * (_e2115 * _e2097)) * (1.1102230246251565e-16lf * _e2097))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2096 + _e2124) * (_e2096 + _e2127))));
                                        let _e2134 = local_3.member[_e2018];
                                        let _e2137 = local_2.member[_e2016];
                                        let _e2141 = local_3.member[_e2016];
                                        let _e2144 = local_2.member[_e2018];
                                        let _e2147 = f64(1f);
                                        let _e2148 = f64(2f);
                                        let _e2150 = local_3.member_1;
                                        let _e2152 = local_2.member_2;
                                        let _e2155 = local_3.member_2;
                                        let _e2157 = local_2.member_1;
                                        let _e2163 = local_3.member_2;
                                        let _e2166 = local_2.member_2;
                                        let _e2175 = local_3.member_2;
                                        let _e2178 = local_2.member_2;
                                        let _e2182 = (((((_e2150 * _e2152) + (_e2155 * _e2157)) * f64(2.01f)) + (((_e2163 * _e2148) * (_e2166 * _e2148)) * (1.1102230246251565e-16lf * _e2148))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2147 + _e2175) * (_e2147 + _e2178))));
                                        let _e2183 = (_e2033 * _e2080);
                                        let _e2184 = (((_e2083 * _e2086) - (_e2090 * _e2093)) * _e2080);
                                        let _e2185 = (((_e2134 * _e2137) - (_e2141 * _e2144)) * _e2080);
                                        if (_e2183 < 0.0lf) {
                                            phi_6470_ = -(_e2183);
                                        } else {
                                            phi_6470_ = _e2183;
                                        }
                                        let _e2189 = phi_6470_;
                                        if (_e2184 < 0.0lf) {
                                            phi_6476_ = -(_e2184);
                                        } else {
                                            phi_6476_ = _e2184;
                                        }
                                        let _e2193 = phi_6476_;
                                        if (_e2185 < 0.0lf) {
                                            phi_6483_ = -(_e2185);
                                        } else {
                                            phi_6483_ = _e2185;
                                        }
                                        let _e2198 = phi_6483_;
                                        let _e2204 = ((_e2183 - _e2184) - _e2185);
                                        let _e2207 = (((_e2069 + _e2131) + _e2182) + (((_e2189 + _e2193) + _e2198) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5[0u].member = _e2184;
                                        local_5[0u].member_1 = _e2131;
                                        local_5[1u].member = _e2185;
                                        local_5[1u].member_1 = _e2182;
                                        local_5[2u].member = _e2204;
                                        local_5[2u].member_1 = _e2207;
                                        local_5[3u].member = _e2204;
                                        local_5[3u].member_1 = _e2207;
                                        phi_6527_ = type_19(0u, 4u);
                                        phi_6530_ = true;
                                        loop {
                                            let _e2222 = phi_6527_;
                                            let _e2224 = phi_6530_;
                                            local_17 = _e2224;
                                            if (_e2222.member < _e2222.member_1) {
                                                phi_6528_ = type_19((_e2222.member + 1u), _e2222.member_1);
                                                phi_6553_ = type_19(1u, _e2222.member);
                                            } else {
                                                phi_6528_ = _e2222;
                                                phi_6553_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2236 = phi_6528_;
                                            let _e2238 = phi_6553_;
                                            if (bitcast<i32>(_e2238.member) != 0i) {
                                                let _e2245 = local_5[_e2238.member_1].member;
                                                let _e2248 = local_5[_e2238.member_1].member_1;
                                                let _e2250 = (_e2245 < -(_e2248));
                                                if _e2250 {
                                                    phi_6580_ = bool();
                                                    phi_6581_ = false;
                                                } else {
                                                    phi_6580_ = (_e2224 && (_e2245 > _e2248));
                                                    phi_6581_ = true;
                                                }
                                                let _e2254 = phi_6580_;
                                                let _e2256 = phi_6581_;
                                                phi_6531_ = _e2254;
                                                phi_6582_ = _e2256;
                                                phi_6583_ = _e2250;
                                            } else {
                                                phi_6531_ = bool();
                                                phi_6582_ = false;
                                                phi_6583_ = false;
                                            }
                                            let _e2258 = phi_6531_;
                                            let _e2260 = phi_6582_;
                                            let _e2262 = phi_6583_;
                                            local_16 = _e2262;
                                            continue;
                                            continuing {
                                                phi_6527_ = _e2236;
                                                phi_6530_ = _e2258;
                                                break if !(_e2260);
                                            }
                                        }
                                        let _e2265 = local_16;
                                        if _e2265 {
                                            phi_6587_ = false;
                                        } else {
                                            phi_6587_ = true;
                                        }
                                        let _e2267 = phi_6587_;
                                        if _e2267 {
                                            let _e2269 = local_17;
                                            if _e2269 {
                                                phi_6594_ = 1u;
                                            } else {
                                                phi_6594_ = 2u;
                                            }
                                            let _e2271 = phi_6594_;
                                            phi_6595_ = _e2271;
                                            phi_6596_ = false;
                                        } else {
                                            phi_6595_ = u32();
                                            phi_6596_ = true;
                                        }
                                        let _e2273 = phi_6595_;
                                        let _e2275 = phi_6596_;
                                        phi_6597_ = _e2273;
                                        phi_6598_ = 0u;
                                        phi_6599_ = _e2275;
                                    } else {
                                        phi_6597_ = u32();
                                        phi_6598_ = 2u;
                                        phi_6599_ = true;
                                    }
                                    let _e2277 = phi_6597_;
                                    let _e2279 = phi_6598_;
                                    let _e2281 = phi_6599_;
                                    if _e2281 {
                                        phi_6603_ = _e2279;
                                    } else {
                                        phi_6603_ = _e2277;
                                    }
                                    let _e2283 = phi_6603_;
                                    let _e2284 = (_e2283 == 0u);
                                    if _e2284 {
                                        phi_8772_ = f64();
                                        phi_8773_ = false;
                                        phi_8774_ = false;
                                        phi_8775_ = false;
                                    } else {
                                        if (_e2283 == 1u) {
                                            if _e1552.member_2 {
                                                if ((_e1552.member_1 - _e1552.member) <= f64(0.0000005f)) {
                                                    phi_6624_ = false;
                                                } else {
                                                    phi_6624_ = true;
                                                }
                                                let _e2293 = phi_6624_;
                                                phi_6625_ = _e2293;
                                            } else {
                                                phi_6625_ = true;
                                            }
                                            let _e2295 = phi_6625_;
                                            phi_6626_ = _e2295;
                                        } else {
                                            phi_6626_ = true;
                                        }
                                        let _e2297 = phi_6626_;
                                        if _e2297 {
                                            let _e2303 = local_12.member[0u];
                                            let _e2309 = local_12.member_1[0u];
                                            let _e2315 = local_12.member_2[0u];
                                            let _e2327 = local_12.member[1u];
                                            let _e2333 = local_12.member_1[1u];
                                            let _e2339 = local_12.member_2[1u];
                                            let _e2351 = local_12.member[0u];
                                            if (_e2351[0] < 0.0lf) {
                                                phi_6775_ = -(_e2351[0]);
                                            } else {
                                                phi_6775_ = _e2351[0];
                                            }
                                            let _e2358 = phi_6775_;
                                            if (_e2351[1] < 0.0lf) {
                                                phi_6782_ = -(_e2351[1]);
                                            } else {
                                                phi_6782_ = _e2351[1];
                                            }
                                            let _e2362 = phi_6782_;
                                            if (_e2358 > _e2362) {
                                                phi_6787_ = _e2358;
                                            } else {
                                                phi_6787_ = _e2362;
                                            }
                                            let _e2365 = phi_6787_;
                                            if (_e2351[2] < 0.0lf) {
                                                phi_6794_ = -(_e2351[2]);
                                            } else {
                                                phi_6794_ = _e2351[2];
                                            }
                                            let _e2369 = phi_6794_;
                                            if (_e2365 > _e2369) {
                                                phi_6799_ = _e2365;
                                            } else {
                                                phi_6799_ = _e2369;
                                            }
                                            let _e2372 = phi_6799_;
                                            let _e2375 = local_12.member[1u];
                                            if (_e2375[0] < 0.0lf) {
                                                phi_6812_ = -(_e2375[0]);
                                            } else {
                                                phi_6812_ = _e2375[0];
                                            }
                                            let _e2382 = phi_6812_;
                                            if (_e2375[1] < 0.0lf) {
                                                phi_6819_ = -(_e2375[1]);
                                            } else {
                                                phi_6819_ = _e2375[1];
                                            }
                                            let _e2386 = phi_6819_;
                                            if (_e2382 > _e2386) {
                                                phi_6824_ = _e2382;
                                            } else {
                                                phi_6824_ = _e2386;
                                            }
                                            let _e2389 = phi_6824_;
                                            if (_e2375[2] < 0.0lf) {
                                                phi_6831_ = -(_e2375[2]);
                                            } else {
                                                phi_6831_ = _e2375[2];
                                            }
                                            let _e2393 = phi_6831_;
                                            if (_e2389 > _e2393) {
                                                phi_6836_ = _e2389;
                                            } else {
                                                phi_6836_ = _e2393;
                                            }
                                            let _e2396 = phi_6836_;
                                            if (_e2372 > _e2396) {
                                                phi_6841_ = _e2372;
                                            } else {
                                                phi_6841_ = _e2396;
                                            }
                                            let _e2399 = phi_6841_;
                                            let _e2401 = local_12.member_3;
                                            let _e2405 = local_12.member_1[0u];
                                            if (_e2405[0] < 0.0lf) {
                                                phi_6858_ = -(_e2405[0]);
                                            } else {
                                                phi_6858_ = _e2405[0];
                                            }
                                            let _e2412 = phi_6858_;
                                            if (_e2405[1] < 0.0lf) {
                                                phi_6865_ = -(_e2405[1]);
                                            } else {
                                                phi_6865_ = _e2405[1];
                                            }
                                            let _e2416 = phi_6865_;
                                            if (_e2412 > _e2416) {
                                                phi_6870_ = _e2412;
                                            } else {
                                                phi_6870_ = _e2416;
                                            }
                                            let _e2419 = phi_6870_;
                                            if (_e2405[2] < 0.0lf) {
                                                phi_6877_ = -(_e2405[2]);
                                            } else {
                                                phi_6877_ = _e2405[2];
                                            }
                                            let _e2423 = phi_6877_;
                                            if (_e2419 > _e2423) {
                                                phi_6882_ = _e2419;
                                            } else {
                                                phi_6882_ = _e2423;
                                            }
                                            let _e2426 = phi_6882_;
                                            let _e2429 = local_12.member_1[1u];
                                            if (_e2429[0] < 0.0lf) {
                                                phi_6896_ = -(_e2429[0]);
                                            } else {
                                                phi_6896_ = _e2429[0];
                                            }
                                            let _e2436 = phi_6896_;
                                            if (_e2429[1] < 0.0lf) {
                                                phi_6903_ = -(_e2429[1]);
                                            } else {
                                                phi_6903_ = _e2429[1];
                                            }
                                            let _e2440 = phi_6903_;
                                            if (_e2436 > _e2440) {
                                                phi_6908_ = _e2436;
                                            } else {
                                                phi_6908_ = _e2440;
                                            }
                                            let _e2443 = phi_6908_;
                                            if (_e2429[2] < 0.0lf) {
                                                phi_6915_ = -(_e2429[2]);
                                            } else {
                                                phi_6915_ = _e2429[2];
                                            }
                                            let _e2447 = phi_6915_;
                                            if (_e2443 > _e2447) {
                                                phi_6920_ = _e2443;
                                            } else {
                                                phi_6920_ = _e2447;
                                            }
                                            let _e2450 = phi_6920_;
                                            if (_e2426 > _e2450) {
                                                phi_6925_ = _e2426;
                                            } else {
                                                phi_6925_ = _e2450;
                                            }
                                            let _e2453 = phi_6925_;
                                            let _e2455 = local_12.member_3;
                                            let _e2459 = local_12.member_2[0u];
                                            if (_e2459[0] < 0.0lf) {
                                                phi_6942_ = -(_e2459[0]);
                                            } else {
                                                phi_6942_ = _e2459[0];
                                            }
                                            let _e2466 = phi_6942_;
                                            if (_e2459[1] < 0.0lf) {
                                                phi_6949_ = -(_e2459[1]);
                                            } else {
                                                phi_6949_ = _e2459[1];
                                            }
                                            let _e2470 = phi_6949_;
                                            if (_e2466 > _e2470) {
                                                phi_6954_ = _e2466;
                                            } else {
                                                phi_6954_ = _e2470;
                                            }
                                            let _e2473 = phi_6954_;
                                            if (_e2459[2] < 0.0lf) {
                                                phi_6961_ = -(_e2459[2]);
                                            } else {
                                                phi_6961_ = _e2459[2];
                                            }
                                            let _e2477 = phi_6961_;
                                            if (_e2473 > _e2477) {
                                                phi_6966_ = _e2473;
                                            } else {
                                                phi_6966_ = _e2477;
                                            }
                                            let _e2480 = phi_6966_;
                                            let _e2483 = local_12.member_2[1u];
                                            if (_e2483[0] < 0.0lf) {
                                                phi_6980_ = -(_e2483[0]);
                                            } else {
                                                phi_6980_ = _e2483[0];
                                            }
                                            let _e2490 = phi_6980_;
                                            if (_e2483[1] < 0.0lf) {
                                                phi_6987_ = -(_e2483[1]);
                                            } else {
                                                phi_6987_ = _e2483[1];
                                            }
                                            let _e2494 = phi_6987_;
                                            if (_e2490 > _e2494) {
                                                phi_6992_ = _e2490;
                                            } else {
                                                phi_6992_ = _e2494;
                                            }
                                            let _e2497 = phi_6992_;
                                            if (_e2483[2] < 0.0lf) {
                                                phi_6999_ = -(_e2483[2]);
                                            } else {
                                                phi_6999_ = _e2483[2];
                                            }
                                            let _e2501 = phi_6999_;
                                            if (_e2497 > _e2501) {
                                                phi_7004_ = _e2497;
                                            } else {
                                                phi_7004_ = _e2501;
                                            }
                                            let _e2504 = phi_7004_;
                                            if (_e2480 > _e2504) {
                                                phi_7009_ = _e2480;
                                            } else {
                                                phi_7009_ = _e2504;
                                            }
                                            let _e2507 = phi_7009_;
                                            let _e2509 = local_12.member_3;
                                            let _e2517 = local_12.member_3;
                                            let _e2524 = f64(0f);
                                            let _e2525 = f64(1f);
                                            local = type_32(array<f64, 4>(_e2524, _e2524, _e2524, _e2524), array<f64, 4>(_e2524, _e2524, _e2524, _e2524), array<f64, 4>(_e2525, _e2525, _e2525, _e2525));
                                            phi_7053_ = type_19(0u, 96u);
                                            phi_7056_ = _e1552.member;
                                            phi_7058_ = _e1552.member;
                                            phi_7060_ = _e1552.member;
                                            loop {
                                                let _e2531 = phi_7053_;
                                                let _e2533 = phi_7056_;
                                                let _e2535 = phi_7058_;
                                                let _e2537 = phi_7060_;
                                                local_36 = _e2535;
                                                local_20 = _e2533;
                                                if (_e2531.member < _e2531.member_1) {
                                                    phi_7054_ = type_19((_e2531.member + 1u), _e2531.member_1);
                                                    phi_7083_ = type_19(1u, _e2531.member);
                                                } else {
                                                    phi_7054_ = _e2531;
                                                    phi_7083_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2549 = phi_7054_;
                                                let _e2551 = phi_7083_;
                                                if (bitcast<i32>(_e2551.member) != 0i) {
                                                    let _e2558 = local_12.member[0u];
                                                    let _e2564 = local_12.member[1u];
                                                    let _e2580 = local_12.member_1[0u];
                                                    let _e2586 = local_12.member_1[1u];
                                                    let _e2602 = local_12.member_2[0u];
                                                    let _e2608 = local_12.member_2[1u];
                                                    let _e2622 = function_2(array<f64, 3>((_e2558[0] + ((_e2564[0] - _e2558[0]) * _e2533)), (_e2558[1] + ((_e2564[1] - _e2558[1]) * _e2533)), (_e2558[2] + ((_e2564[2] - _e2558[2]) * _e2533))), array<f64, 3>((_e2580[0] + ((_e2586[0] - _e2580[0]) * _e2533)), (_e2580[1] + ((_e2586[1] - _e2580[1]) * _e2533)), (_e2580[2] + ((_e2586[2] - _e2580[2]) * _e2533))), array<f64, 3>((_e2602[0] + ((_e2608[0] - _e2602[0]) * _e2533)), (_e2602[1] + ((_e2608[1] - _e2602[1]) * _e2533)), (_e2602[2] + ((_e2608[2] - _e2602[2]) * _e2533))), 0u);
                                                    if (_e2622[0] < 0.0lf) {
                                                        phi_7195_ = -(_e2622[0]);
                                                    } else {
                                                        phi_7195_ = _e2622[0];
                                                    }
                                                    let _e2627 = phi_7195_;
                                                    if (_e2622[1] < 0.0lf) {
                                                        phi_7202_ = -(_e2622[1]);
                                                    } else {
                                                        phi_7202_ = _e2622[1];
                                                    }
                                                    let _e2632 = phi_7202_;
                                                    if (_e2622[2] < 0.0lf) {
                                                        phi_7210_ = -(_e2622[2]);
                                                    } else {
                                                        phi_7210_ = _e2622[2];
                                                    }
                                                    let _e2638 = phi_7210_;
                                                    let _e2639 = ((_e2627 + _e2632) + _e2638);
                                                    if (_e2639 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2639) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2646 = (f64(1f) / _e2639);
                                                            let _e2648 = (_e2622[0] * _e2646);
                                                            let _e2650 = (_e2622[1] * _e2646);
                                                            let _e2652 = (_e2622[2] * _e2646);
                                                            let _e2657 = (((_e2648 * _e2648) + (_e2650 * _e2650)) + (_e2652 * _e2652));
                                                            if (_e2657 <= 2.2250738585072014e-308lf) {
                                                                if (_e2657 > 0.0lf) {
                                                                    phi_7249_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7249_ = 0.0lf;
                                                                }
                                                                let _e2709 = phi_7249_;
                                                                phi_7313_ = _e2709;
                                                            } else {
                                                                phi_7256_ = type_17(0i, 5i);
                                                                phi_7259_ = bitcast<f64>(((bitcast<u64>(_e2657) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2664 = phi_7256_;
                                                                    let _e2666 = phi_7259_;
                                                                    local_18 = _e2666;
                                                                    if (_e2664.member < _e2664.member_1) {
                                                                        let _e2673 = (_e2664.member + 1i);
                                                                        if ((false == (_e2673 > _e2664.member)) != false) {
                                                                            phi_7280_ = true;
                                                                        } else {
                                                                            phi_7280_ = false;
                                                                        }
                                                                        let _e2678 = phi_7280_;
                                                                        if _e2678 {
                                                                            phi_7286_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_7286_ = type_18(1u, _e2673);
                                                                        }
                                                                        let _e2683 = phi_7286_;
                                                                        phi_7257_ = type_17(_e2683.member_1, _e2664.member_1);
                                                                        phi_7300_ = type_18(1u, _e2664.member);
                                                                    } else {
                                                                        phi_7257_ = _e2664;
                                                                        phi_7300_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2689 = phi_7257_;
                                                                    let _e2691 = phi_7300_;
                                                                    let _e2694 = (bitcast<i32>(_e2691.member) != 0i);
                                                                    if _e2694 {
                                                                        phi_7260_ = (0.5lf * (_e2666 + (_e2657 / _e2666)));
                                                                    } else {
                                                                        phi_7260_ = f64();
                                                                    }
                                                                    let _e2699 = phi_7260_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7256_ = _e2689;
                                                                        phi_7259_ = _e2699;
                                                                        break if !(_e2694);
                                                                    }
                                                                }
                                                                let _e2704 = local_18;
                                                                phi_7313_ = (_e2704 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2711 = phi_7313_;
                                                            let _e2713 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2720 = ((((((((_e2399 + _e2401) + (_e2453 + _e2455)) + (_e2507 + _e2509)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2517 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2711) * (f64(1f) + _e2713)));
                                                            let _e2725 = (((_e2648 * _e2303[0]) + (_e2650 * _e2303[1])) + (_e2652 * _e2303[2]));
                                                            let _e2730 = (((_e2648 * (_e2303[0] - _e2309[0])) + (_e2650 * (_e2303[1] - _e2309[1]))) + (_e2652 * (_e2303[2] - _e2309[2])));
                                                            let _e2735 = (((_e2648 * (_e2303[0] - _e2315[0])) + (_e2650 * (_e2303[1] - _e2315[1]))) + (_e2652 * (_e2303[2] - _e2315[2])));
                                                            let _e2740 = (((_e2648 * _e2303[0]) + (_e2650 * _e2303[1])) + (_e2652 * _e2303[2]));
                                                            let _e2746 = (((_e2648 * _e2327[0]) + (_e2650 * _e2327[1])) + (_e2652 * _e2327[2]));
                                                            let _e2751 = (((_e2648 * (_e2327[0] - _e2333[0])) + (_e2650 * (_e2327[1] - _e2333[1]))) + (_e2652 * (_e2327[2] - _e2333[2])));
                                                            let _e2756 = (((_e2648 * (_e2327[0] - _e2339[0])) + (_e2650 * (_e2327[1] - _e2339[1]))) + (_e2652 * (_e2327[2] - _e2339[2])));
                                                            let _e2761 = (((_e2648 * _e2327[0]) + (_e2650 * _e2327[1])) + (_e2652 * _e2327[2]));
                                                            if (_e2725 < 0.0lf) {
                                                                phi_7382_ = -(_e2725);
                                                            } else {
                                                                phi_7382_ = _e2725;
                                                            }
                                                            let _e2766 = phi_7382_;
                                                            if (_e2746 < 0.0lf) {
                                                                phi_7388_ = -(_e2746);
                                                            } else {
                                                                phi_7388_ = _e2746;
                                                            }
                                                            let _e2770 = phi_7388_;
                                                            if (_e2730 < 0.0lf) {
                                                                phi_7397_ = -(_e2730);
                                                            } else {
                                                                phi_7397_ = _e2730;
                                                            }
                                                            let _e2777 = phi_7397_;
                                                            if (_e2751 < 0.0lf) {
                                                                phi_7403_ = -(_e2751);
                                                            } else {
                                                                phi_7403_ = _e2751;
                                                            }
                                                            let _e2781 = phi_7403_;
                                                            if (_e2735 < 0.0lf) {
                                                                phi_7412_ = -(_e2735);
                                                            } else {
                                                                phi_7412_ = _e2735;
                                                            }
                                                            let _e2788 = phi_7412_;
                                                            if (_e2756 < 0.0lf) {
                                                                phi_7418_ = -(_e2756);
                                                            } else {
                                                                phi_7418_ = _e2756;
                                                            }
                                                            let _e2792 = phi_7418_;
                                                            if (_e2740 < 0.0lf) {
                                                                phi_7427_ = -(_e2740);
                                                            } else {
                                                                phi_7427_ = _e2740;
                                                            }
                                                            let _e2799 = phi_7427_;
                                                            if (_e2761 < 0.0lf) {
                                                                phi_7433_ = -(_e2761);
                                                            } else {
                                                                phi_7433_ = _e2761;
                                                            }
                                                            let _e2803 = phi_7433_;
                                                            phi_7439_ = type_32(array<f64, 4>(_e2725, _e2730, _e2735, _e2740), array<f64, 4>(_e2746, _e2751, _e2756, _e2761), array<f64, 4>((_e2720 + ((_e2766 + _e2770) * _e2713)), (_e2720 + ((_e2777 + _e2781) * _e2713)), (_e2720 + ((_e2788 + _e2792) * _e2713)), (_e2720 + ((_e2799 + _e2803) * _e2713))));
                                                            phi_7440_ = false;
                                                        } else {
                                                            phi_7439_ = type_32();
                                                            phi_7440_ = true;
                                                        }
                                                        let _e2810 = phi_7439_;
                                                        let _e2812 = phi_7440_;
                                                        phi_7441_ = _e2810;
                                                        phi_7442_ = _e2812;
                                                    } else {
                                                        phi_7441_ = type_32();
                                                        phi_7442_ = true;
                                                    }
                                                    let _e2814 = phi_7441_;
                                                    let _e2816 = phi_7442_;
                                                    if _e2816 {
                                                        let _e2817 = f64(0f);
                                                        let _e2818 = f64(1f);
                                                        phi_7452_ = type_32(array<f64, 4>(_e2817, _e2817, _e2817, _e2817), array<f64, 4>(_e2817, _e2817, _e2817, _e2817), array<f64, 4>(_e2818, _e2818, _e2818, _e2818));
                                                    } else {
                                                        phi_7452_ = _e2814;
                                                    }
                                                    let _e2824 = phi_7452_;
                                                    local_1 = type_32(array<f64, 4>(_e2824.member[0], _e2824.member[1], _e2824.member[2], _e2824.member[3]), array<f64, 4>(_e2824.member_1[0], _e2824.member_1[1], _e2824.member_1[2], _e2824.member_1[3]), array<f64, 4>(_e2824.member_2[0], _e2824.member_2[1], _e2824.member_2[2], _e2824.member_2[3]));
                                                    let _e2844 = (_e2533 - _e2537);
                                                    let _e2845 = f64(0f);
                                                    let _e2848 = local_1.member[0u];
                                                    let _e2851 = local_1.member_1[0u];
                                                    let _e2854 = local_1.member[0u];
                                                    let _e2860 = local_1.member_2[0u];
                                                    if (((_e2848 + ((_e2851 - _e2854) * _e2533)) - _e2860) > _e2845) {
                                                        let _e2865 = local_1.member[1u];
                                                        let _e2868 = local_1.member_1[1u];
                                                        let _e2871 = local_1.member[1u];
                                                        let _e2877 = local_1.member_2[1u];
                                                        if (((_e2865 + ((_e2868 - _e2871) * _e2533)) - _e2877) > _e2845) {
                                                            let _e2882 = local_1.member[2u];
                                                            let _e2885 = local_1.member_1[2u];
                                                            let _e2888 = local_1.member[2u];
                                                            let _e2894 = local_1.member_2[2u];
                                                            if (((_e2882 + ((_e2885 - _e2888) * _e2533)) - _e2894) > _e2845) {
                                                                let _e2899 = local_1.member[3u];
                                                                let _e2902 = local_1.member_1[3u];
                                                                let _e2905 = local_1.member[3u];
                                                                let _e2911 = local_1.member_2[3u];
                                                                phi_7623_ = (((_e2899 + ((_e2902 - _e2905) * _e2533)) - _e2911) > _e2845);
                                                                phi_7624_ = false;
                                                            } else {
                                                                phi_7623_ = bool();
                                                                phi_7624_ = true;
                                                            }
                                                            let _e2915 = phi_7623_;
                                                            let _e2917 = phi_7624_;
                                                            phi_7625_ = _e2915;
                                                            phi_7626_ = _e2917;
                                                        } else {
                                                            phi_7625_ = bool();
                                                            phi_7626_ = true;
                                                        }
                                                        let _e2919 = phi_7625_;
                                                        let _e2921 = phi_7626_;
                                                        phi_7627_ = _e2919;
                                                        phi_7628_ = _e2921;
                                                    } else {
                                                        phi_7627_ = bool();
                                                        phi_7628_ = true;
                                                    }
                                                    let _e2923 = phi_7627_;
                                                    let _e2925 = phi_7628_;
                                                    if _e2925 {
                                                        phi_7632_ = false;
                                                    } else {
                                                        phi_7632_ = _e2923;
                                                    }
                                                    let _e2927 = phi_7632_;
                                                    if _e2927 {
                                                        if (_e2533 <= _e2535) {
                                                            phi_7943_ = true;
                                                        } else {
                                                            let _e2929 = f64(0f);
                                                            let _e2932 = local.member[0u];
                                                            let _e2935 = local.member_1[0u];
                                                            let _e2938 = local.member[0u];
                                                            let _e2944 = local.member_2[0u];
                                                            let _e2948 = local_1.member[0u];
                                                            let _e2951 = local_1.member_1[0u];
                                                            let _e2954 = local_1.member[0u];
                                                            let _e2960 = local_1.member_2[0u];
                                                            if ((((_e2932 + ((_e2935 - _e2938) * _e2533)) - _e2944) + ((_e2948 + ((_e2951 - _e2954) * _e2537)) - _e2960)) > _e2929) {
                                                                let _e2966 = local.member[1u];
                                                                let _e2969 = local.member_1[1u];
                                                                let _e2972 = local.member[1u];
                                                                let _e2978 = local.member_2[1u];
                                                                let _e2982 = local_1.member[1u];
                                                                let _e2985 = local_1.member_1[1u];
                                                                let _e2988 = local_1.member[1u];
                                                                let _e2994 = local_1.member_2[1u];
                                                                if ((((_e2966 + ((_e2969 - _e2972) * _e2533)) - _e2978) + ((_e2982 + ((_e2985 - _e2988) * _e2537)) - _e2994)) > _e2929) {
                                                                    let _e3000 = local.member[2u];
                                                                    let _e3003 = local.member_1[2u];
                                                                    let _e3006 = local.member[2u];
                                                                    let _e3012 = local.member_2[2u];
                                                                    let _e3016 = local_1.member[2u];
                                                                    let _e3019 = local_1.member_1[2u];
                                                                    let _e3022 = local_1.member[2u];
                                                                    let _e3028 = local_1.member_2[2u];
                                                                    if ((((_e3000 + ((_e3003 - _e3006) * _e2533)) - _e3012) + ((_e3016 + ((_e3019 - _e3022) * _e2537)) - _e3028)) > _e2929) {
                                                                        let _e3034 = local.member[3u];
                                                                        let _e3037 = local.member_1[3u];
                                                                        let _e3040 = local.member[3u];
                                                                        let _e3046 = local.member_2[3u];
                                                                        let _e3050 = local_1.member[3u];
                                                                        let _e3053 = local_1.member_1[3u];
                                                                        let _e3056 = local_1.member[3u];
                                                                        let _e3062 = local_1.member_2[3u];
                                                                        phi_7930_ = ((((_e3034 + ((_e3037 - _e3040) * _e2533)) - _e3046) + ((_e3050 + ((_e3053 - _e3056) * _e2537)) - _e3062)) > _e2929);
                                                                        phi_7931_ = false;
                                                                    } else {
                                                                        phi_7930_ = bool();
                                                                        phi_7931_ = true;
                                                                    }
                                                                    let _e3067 = phi_7930_;
                                                                    let _e3069 = phi_7931_;
                                                                    phi_7932_ = _e3067;
                                                                    phi_7933_ = _e3069;
                                                                } else {
                                                                    phi_7932_ = bool();
                                                                    phi_7933_ = true;
                                                                }
                                                                let _e3071 = phi_7932_;
                                                                let _e3073 = phi_7933_;
                                                                phi_7934_ = _e3071;
                                                                phi_7935_ = _e3073;
                                                            } else {
                                                                phi_7934_ = bool();
                                                                phi_7935_ = true;
                                                            }
                                                            let _e3075 = phi_7934_;
                                                            let _e3077 = phi_7935_;
                                                            if _e3077 {
                                                                phi_7939_ = false;
                                                            } else {
                                                                phi_7939_ = _e3075;
                                                            }
                                                            let _e3079 = phi_7939_;
                                                            phi_7943_ = _e3079;
                                                        }
                                                        let _e3081 = phi_7943_;
                                                        if _e3081 {
                                                            if (_e2551.member_1 > 0u) {
                                                                if (_e2533 >= _e1552.member_1) {
                                                                    phi_7955_ = false;
                                                                } else {
                                                                    phi_7955_ = true;
                                                                }
                                                                let _e3085 = phi_7955_;
                                                                phi_7956_ = _e3085;
                                                            } else {
                                                                phi_7956_ = true;
                                                            }
                                                            let _e3087 = phi_7956_;
                                                            if _e3087 {
                                                                local = type_32(array<f64, 4>(_e2824.member[0], _e2824.member[1], _e2824.member[2], _e2824.member[3]), array<f64, 4>(_e2824.member_1[0], _e2824.member_1[1], _e2824.member_1[2], _e2824.member_1[3]), array<f64, 4>(_e2824.member_2[0], _e2824.member_2[1], _e2824.member_2[2], _e2824.member_2[3]));
                                                                let _e3109 = local.member[0u];
                                                                let _e3112 = local.member_1[0u];
                                                                let _e3115 = local.member_2[0u];
                                                                if (_e3109 > _e3115) {
                                                                    if (_e3112 > _e3115) {
                                                                        phi_8030_ = false;
                                                                    } else {
                                                                        phi_8030_ = true;
                                                                    }
                                                                    let _e3119 = phi_8030_;
                                                                    phi_8031_ = _e3119;
                                                                } else {
                                                                    phi_8031_ = true;
                                                                }
                                                                let _e3121 = phi_8031_;
                                                                if _e3121 {
                                                                    let _e3122 = (_e3112 >= _e3109);
                                                                    if _e3122 {
                                                                        phi_8056_ = f64();
                                                                        phi_8057_ = false;
                                                                    } else {
                                                                        if ((_e3109 - _e3112) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8054_ = (((_e3109 - _e3115) / (_e3109 - _e3112)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8055_ = false;
                                                                        } else {
                                                                            phi_8054_ = f64();
                                                                            phi_8055_ = true;
                                                                        }
                                                                        let _e3136 = phi_8054_;
                                                                        let _e3138 = phi_8055_;
                                                                        phi_8056_ = _e3136;
                                                                        phi_8057_ = _e3138;
                                                                    }
                                                                    let _e3140 = phi_8056_;
                                                                    let _e3142 = phi_8057_;
                                                                    phi_8058_ = _e3140;
                                                                    phi_8059_ = _e3122;
                                                                    phi_8060_ = _e3142;
                                                                } else {
                                                                    phi_8058_ = f64();
                                                                    phi_8059_ = true;
                                                                    phi_8060_ = false;
                                                                }
                                                                let _e3144 = phi_8058_;
                                                                let _e3146 = phi_8059_;
                                                                let _e3148 = phi_8060_;
                                                                if _e3146 {
                                                                    phi_8065_ = f64(2f);
                                                                    phi_8066_ = true;
                                                                } else {
                                                                    phi_8065_ = _e2533;
                                                                    phi_8066_ = _e3148;
                                                                }
                                                                let _e3151 = phi_8065_;
                                                                let _e3153 = phi_8066_;
                                                                if _e3153 {
                                                                    phi_8070_ = _e3151;
                                                                } else {
                                                                    phi_8070_ = _e3144;
                                                                }
                                                                let _e3155 = phi_8070_;
                                                                let _e3158 = local.member[1u];
                                                                let _e3161 = local.member_1[1u];
                                                                let _e3164 = local.member_2[1u];
                                                                if (_e3158 > _e3164) {
                                                                    if (_e3161 > _e3164) {
                                                                        phi_8102_ = false;
                                                                    } else {
                                                                        phi_8102_ = true;
                                                                    }
                                                                    let _e3168 = phi_8102_;
                                                                    phi_8103_ = _e3168;
                                                                } else {
                                                                    phi_8103_ = true;
                                                                }
                                                                let _e3170 = phi_8103_;
                                                                if _e3170 {
                                                                    let _e3171 = (_e3161 >= _e3158);
                                                                    if _e3171 {
                                                                        phi_8128_ = f64();
                                                                        phi_8129_ = false;
                                                                    } else {
                                                                        if ((_e3158 - _e3161) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8126_ = (((_e3158 - _e3164) / (_e3158 - _e3161)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8127_ = false;
                                                                        } else {
                                                                            phi_8126_ = f64();
                                                                            phi_8127_ = true;
                                                                        }
                                                                        let _e3185 = phi_8126_;
                                                                        let _e3187 = phi_8127_;
                                                                        phi_8128_ = _e3185;
                                                                        phi_8129_ = _e3187;
                                                                    }
                                                                    let _e3189 = phi_8128_;
                                                                    let _e3191 = phi_8129_;
                                                                    phi_8130_ = _e3189;
                                                                    phi_8131_ = _e3171;
                                                                    phi_8132_ = _e3191;
                                                                } else {
                                                                    phi_8130_ = f64();
                                                                    phi_8131_ = true;
                                                                    phi_8132_ = false;
                                                                }
                                                                let _e3193 = phi_8130_;
                                                                let _e3195 = phi_8131_;
                                                                let _e3197 = phi_8132_;
                                                                if _e3195 {
                                                                    phi_8137_ = f64(2f);
                                                                    phi_8138_ = true;
                                                                } else {
                                                                    phi_8137_ = _e2533;
                                                                    phi_8138_ = _e3197;
                                                                }
                                                                let _e3200 = phi_8137_;
                                                                let _e3202 = phi_8138_;
                                                                if _e3202 {
                                                                    phi_8142_ = _e3200;
                                                                } else {
                                                                    phi_8142_ = _e3193;
                                                                }
                                                                let _e3204 = phi_8142_;
                                                                if (_e3155 < _e3204) {
                                                                    phi_8147_ = _e3155;
                                                                } else {
                                                                    phi_8147_ = _e3204;
                                                                }
                                                                let _e3207 = phi_8147_;
                                                                let _e3210 = local.member[2u];
                                                                let _e3213 = local.member_1[2u];
                                                                let _e3216 = local.member_2[2u];
                                                                if (_e3210 > _e3216) {
                                                                    if (_e3213 > _e3216) {
                                                                        phi_8179_ = false;
                                                                    } else {
                                                                        phi_8179_ = true;
                                                                    }
                                                                    let _e3220 = phi_8179_;
                                                                    phi_8180_ = _e3220;
                                                                } else {
                                                                    phi_8180_ = true;
                                                                }
                                                                let _e3222 = phi_8180_;
                                                                if _e3222 {
                                                                    let _e3223 = (_e3213 >= _e3210);
                                                                    if _e3223 {
                                                                        phi_8205_ = f64();
                                                                        phi_8206_ = false;
                                                                    } else {
                                                                        if ((_e3210 - _e3213) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8203_ = (((_e3210 - _e3216) / (_e3210 - _e3213)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8204_ = false;
                                                                        } else {
                                                                            phi_8203_ = f64();
                                                                            phi_8204_ = true;
                                                                        }
                                                                        let _e3237 = phi_8203_;
                                                                        let _e3239 = phi_8204_;
                                                                        phi_8205_ = _e3237;
                                                                        phi_8206_ = _e3239;
                                                                    }
                                                                    let _e3241 = phi_8205_;
                                                                    let _e3243 = phi_8206_;
                                                                    phi_8207_ = _e3241;
                                                                    phi_8208_ = _e3223;
                                                                    phi_8209_ = _e3243;
                                                                } else {
                                                                    phi_8207_ = f64();
                                                                    phi_8208_ = true;
                                                                    phi_8209_ = false;
                                                                }
                                                                let _e3245 = phi_8207_;
                                                                let _e3247 = phi_8208_;
                                                                let _e3249 = phi_8209_;
                                                                if _e3247 {
                                                                    phi_8214_ = f64(2f);
                                                                    phi_8215_ = true;
                                                                } else {
                                                                    phi_8214_ = _e2533;
                                                                    phi_8215_ = _e3249;
                                                                }
                                                                let _e3252 = phi_8214_;
                                                                let _e3254 = phi_8215_;
                                                                if _e3254 {
                                                                    phi_8219_ = _e3252;
                                                                } else {
                                                                    phi_8219_ = _e3245;
                                                                }
                                                                let _e3256 = phi_8219_;
                                                                let _e3259 = local.member[3u];
                                                                let _e3262 = local.member_1[3u];
                                                                let _e3265 = local.member_2[3u];
                                                                if (_e3259 > _e3265) {
                                                                    if (_e3262 > _e3265) {
                                                                        phi_8251_ = false;
                                                                    } else {
                                                                        phi_8251_ = true;
                                                                    }
                                                                    let _e3269 = phi_8251_;
                                                                    phi_8252_ = _e3269;
                                                                } else {
                                                                    phi_8252_ = true;
                                                                }
                                                                let _e3271 = phi_8252_;
                                                                if _e3271 {
                                                                    let _e3272 = (_e3262 >= _e3259);
                                                                    if _e3272 {
                                                                        phi_8277_ = f64();
                                                                        phi_8278_ = false;
                                                                    } else {
                                                                        if ((_e3259 - _e3262) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8275_ = (((_e3259 - _e3265) / (_e3259 - _e3262)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8276_ = false;
                                                                        } else {
                                                                            phi_8275_ = f64();
                                                                            phi_8276_ = true;
                                                                        }
                                                                        let _e3286 = phi_8275_;
                                                                        let _e3288 = phi_8276_;
                                                                        phi_8277_ = _e3286;
                                                                        phi_8278_ = _e3288;
                                                                    }
                                                                    let _e3290 = phi_8277_;
                                                                    let _e3292 = phi_8278_;
                                                                    phi_8279_ = _e3290;
                                                                    phi_8280_ = _e3272;
                                                                    phi_8281_ = _e3292;
                                                                } else {
                                                                    phi_8279_ = f64();
                                                                    phi_8280_ = true;
                                                                    phi_8281_ = false;
                                                                }
                                                                let _e3294 = phi_8279_;
                                                                let _e3296 = phi_8280_;
                                                                let _e3298 = phi_8281_;
                                                                if _e3296 {
                                                                    phi_8286_ = f64(2f);
                                                                    phi_8287_ = true;
                                                                } else {
                                                                    phi_8286_ = _e2533;
                                                                    phi_8287_ = _e3298;
                                                                }
                                                                let _e3301 = phi_8286_;
                                                                let _e3303 = phi_8287_;
                                                                if _e3303 {
                                                                    phi_8291_ = _e3301;
                                                                } else {
                                                                    phi_8291_ = _e3294;
                                                                }
                                                                let _e3305 = phi_8291_;
                                                                if (_e3256 < _e3305) {
                                                                    phi_8296_ = _e3256;
                                                                } else {
                                                                    phi_8296_ = _e3305;
                                                                }
                                                                let _e3308 = phi_8296_;
                                                                if (_e3207 < _e3308) {
                                                                    phi_8301_ = _e3207;
                                                                } else {
                                                                    phi_8301_ = _e3308;
                                                                }
                                                                let _e3311 = phi_8301_;
                                                                if (_e3311 > _e2533) {
                                                                    phi_8306_ = _e3311;
                                                                } else {
                                                                    phi_8306_ = _e2533;
                                                                }
                                                                let _e3314 = phi_8306_;
                                                                let _e3315 = (_e3314 > _e1552.member_1);
                                                                if _e3315 {
                                                                    phi_8318_ = f64();
                                                                    phi_8319_ = false;
                                                                } else {
                                                                    if (_e2551.member_1 == 0u) {
                                                                        phi_8317_ = (_e1552.member_1 - _e2533);
                                                                    } else {
                                                                        phi_8317_ = (_e2844 + _e2844);
                                                                    }
                                                                    let _e3320 = phi_8317_;
                                                                    phi_8318_ = _e3320;
                                                                    phi_8319_ = true;
                                                                }
                                                                let _e3322 = phi_8318_;
                                                                let _e3324 = phi_8319_;
                                                                phi_8320_ = _e3314;
                                                                phi_8321_ = _e3322;
                                                                phi_8322_ = _e3324;
                                                                phi_8323_ = _e3315;
                                                                phi_8324_ = false;
                                                            } else {
                                                                phi_8320_ = f64();
                                                                phi_8321_ = f64();
                                                                phi_8322_ = false;
                                                                phi_8323_ = false;
                                                                phi_8324_ = true;
                                                            }
                                                            let _e3326 = phi_8320_;
                                                            let _e3328 = phi_8321_;
                                                            let _e3330 = phi_8322_;
                                                            let _e3332 = phi_8323_;
                                                            let _e3334 = phi_8324_;
                                                            phi_8325_ = _e3326;
                                                            phi_8326_ = _e3328;
                                                            phi_8327_ = false;
                                                            phi_8328_ = _e3330;
                                                            phi_8329_ = _e3332;
                                                            phi_8330_ = _e3334;
                                                        } else {
                                                            phi_8325_ = f64();
                                                            phi_8326_ = f64();
                                                            phi_8327_ = true;
                                                            phi_8328_ = false;
                                                            phi_8329_ = false;
                                                            phi_8330_ = false;
                                                        }
                                                        let _e3336 = phi_8325_;
                                                        let _e3338 = phi_8326_;
                                                        let _e3340 = phi_8327_;
                                                        let _e3342 = phi_8328_;
                                                        let _e3344 = phi_8329_;
                                                        let _e3346 = phi_8330_;
                                                        phi_8331_ = _e3336;
                                                        phi_8332_ = _e3338;
                                                        phi_8333_ = _e3340;
                                                        phi_8334_ = _e3342;
                                                        phi_8335_ = _e3344;
                                                        phi_8336_ = _e3346;
                                                    } else {
                                                        phi_8331_ = f64();
                                                        phi_8332_ = f64();
                                                        phi_8333_ = true;
                                                        phi_8334_ = false;
                                                        phi_8335_ = false;
                                                        phi_8336_ = false;
                                                    }
                                                    let _e3348 = phi_8331_;
                                                    let _e3350 = phi_8332_;
                                                    let _e3352 = phi_8333_;
                                                    let _e3354 = phi_8334_;
                                                    let _e3356 = phi_8335_;
                                                    let _e3358 = phi_8336_;
                                                    if _e3352 {
                                                        let _e3359 = (_e2533 <= _e2535);
                                                        if _e3359 {
                                                            phi_8670_ = f64();
                                                            phi_8671_ = false;
                                                        } else {
                                                            let _e3362 = local.member[0u];
                                                            let _e3365 = local.member_1[0u];
                                                            let _e3368 = local.member[0u];
                                                            let _e3374 = local.member_2[0u];
                                                            let _e3375 = ((_e3362 + ((_e3365 - _e3368) * _e2537)) - _e3374);
                                                            let _e3378 = local.member[1u];
                                                            let _e3381 = local.member_1[1u];
                                                            let _e3384 = local.member[1u];
                                                            let _e3390 = local.member_2[1u];
                                                            let _e3391 = ((_e3378 + ((_e3381 - _e3384) * _e2537)) - _e3390);
                                                            if (_e3375 < _e3391) {
                                                                phi_8416_ = _e3375;
                                                            } else {
                                                                phi_8416_ = _e3391;
                                                            }
                                                            let _e3394 = phi_8416_;
                                                            let _e3397 = local.member[2u];
                                                            let _e3400 = local.member_1[2u];
                                                            let _e3403 = local.member[2u];
                                                            let _e3409 = local.member_2[2u];
                                                            let _e3410 = ((_e3397 + ((_e3400 - _e3403) * _e2537)) - _e3409);
                                                            let _e3413 = local.member[3u];
                                                            let _e3416 = local.member_1[3u];
                                                            let _e3419 = local.member[3u];
                                                            let _e3425 = local.member_2[3u];
                                                            let _e3426 = ((_e3413 + ((_e3416 - _e3419) * _e2537)) - _e3425);
                                                            if (_e3410 < _e3426) {
                                                                phi_8489_ = _e3410;
                                                            } else {
                                                                phi_8489_ = _e3426;
                                                            }
                                                            let _e3429 = phi_8489_;
                                                            if (_e3394 < _e3429) {
                                                                phi_8494_ = _e3394;
                                                            } else {
                                                                phi_8494_ = _e3429;
                                                            }
                                                            let _e3432 = phi_8494_;
                                                            let _e3435 = local_1.member[0u];
                                                            let _e3438 = local_1.member_1[0u];
                                                            let _e3441 = local_1.member[0u];
                                                            let _e3447 = local_1.member_2[0u];
                                                            let _e3448 = ((_e3435 + ((_e3438 - _e3441) * _e2533)) - _e3447);
                                                            let _e3451 = local_1.member[1u];
                                                            let _e3454 = local_1.member_1[1u];
                                                            let _e3457 = local_1.member[1u];
                                                            let _e3463 = local_1.member_2[1u];
                                                            let _e3464 = ((_e3451 + ((_e3454 - _e3457) * _e2533)) - _e3463);
                                                            if (_e3448 < _e3464) {
                                                                phi_8567_ = _e3448;
                                                            } else {
                                                                phi_8567_ = _e3464;
                                                            }
                                                            let _e3467 = phi_8567_;
                                                            let _e3470 = local_1.member[2u];
                                                            let _e3473 = local_1.member_1[2u];
                                                            let _e3476 = local_1.member[2u];
                                                            let _e3482 = local_1.member_2[2u];
                                                            let _e3483 = ((_e3470 + ((_e3473 - _e3476) * _e2533)) - _e3482);
                                                            let _e3486 = local_1.member[3u];
                                                            let _e3489 = local_1.member_1[3u];
                                                            let _e3492 = local_1.member[3u];
                                                            let _e3498 = local_1.member_2[3u];
                                                            let _e3499 = ((_e3486 + ((_e3489 - _e3492) * _e2533)) - _e3498);
                                                            if (_e3483 < _e3499) {
                                                                phi_8640_ = _e3483;
                                                            } else {
                                                                phi_8640_ = _e3499;
                                                            }
                                                            let _e3502 = phi_8640_;
                                                            if (_e3467 < _e3502) {
                                                                phi_8645_ = _e3467;
                                                            } else {
                                                                phi_8645_ = _e3502;
                                                            }
                                                            let _e3505 = phi_8645_;
                                                            let _e3506 = f64(0.0625f);
                                                            let _e3508 = f64(0.9f);
                                                            if (_e3505 > f64(0f)) {
                                                                phi_8668_ = f64(0.5f);
                                                            } else {
                                                                let _e3514 = (f64(0.95f) * (_e3432 / (_e3432 - _e3505)));
                                                                if (_e3514 > _e3506) {
                                                                    if (_e3514 < _e3508) {
                                                                        phi_8666_ = _e3514;
                                                                    } else {
                                                                        phi_8666_ = _e3508;
                                                                    }
                                                                    let _e3518 = phi_8666_;
                                                                    phi_8667_ = _e3518;
                                                                } else {
                                                                    phi_8667_ = _e3506;
                                                                }
                                                                let _e3520 = phi_8667_;
                                                                phi_8668_ = _e3520;
                                                            }
                                                            let _e3522 = phi_8668_;
                                                            phi_8670_ = (_e2844 * _e3522);
                                                            phi_8671_ = true;
                                                        }
                                                        let _e3525 = phi_8670_;
                                                        let _e3527 = phi_8671_;
                                                        phi_8672_ = _e2535;
                                                        phi_8673_ = _e3525;
                                                        phi_8674_ = _e2537;
                                                        phi_8675_ = _e3527;
                                                        phi_8676_ = _e3359;
                                                        phi_8677_ = false;
                                                        phi_8678_ = false;
                                                    } else {
                                                        phi_8672_ = _e3348;
                                                        phi_8673_ = _e3350;
                                                        phi_8674_ = _e2533;
                                                        phi_8675_ = _e3354;
                                                        phi_8676_ = false;
                                                        phi_8677_ = _e3356;
                                                        phi_8678_ = _e3358;
                                                    }
                                                    let _e3529 = phi_8672_;
                                                    let _e3531 = phi_8673_;
                                                    let _e3533 = phi_8674_;
                                                    let _e3535 = phi_8675_;
                                                    let _e3537 = phi_8676_;
                                                    let _e3539 = phi_8677_;
                                                    let _e3541 = phi_8678_;
                                                    if _e3535 {
                                                        let _e3542 = (_e3533 + _e3531);
                                                        if (_e3542 > _e3529) {
                                                            phi_8687_ = _e3542;
                                                        } else {
                                                            phi_8687_ = _e3529;
                                                        }
                                                        let _e3545 = phi_8687_;
                                                        if (_e3545 < _e1552.member_1) {
                                                            phi_8692_ = _e3545;
                                                        } else {
                                                            phi_8692_ = _e1552.member_1;
                                                        }
                                                        let _e3548 = phi_8692_;
                                                        if (_e2551.member_1 > 0u) {
                                                            phi_8703_ = ((_e3548 - _e3533) > f64(0.0000000037252903f));
                                                        } else {
                                                            phi_8703_ = true;
                                                        }
                                                        let _e3554 = phi_8703_;
                                                        if _e3554 {
                                                            phi_8707_ = false;
                                                        } else {
                                                            phi_8707_ = true;
                                                        }
                                                        let _e3556 = phi_8707_;
                                                        phi_8708_ = _e3548;
                                                        phi_8709_ = _e3554;
                                                        phi_8710_ = _e3556;
                                                        phi_8711_ = false;
                                                        phi_8712_ = false;
                                                        phi_8713_ = false;
                                                    } else {
                                                        phi_8708_ = f64();
                                                        phi_8709_ = false;
                                                        phi_8710_ = false;
                                                        phi_8711_ = _e3537;
                                                        phi_8712_ = _e3539;
                                                        phi_8713_ = _e3541;
                                                    }
                                                    let _e3558 = phi_8708_;
                                                    let _e3560 = phi_8709_;
                                                    let _e3562 = phi_8710_;
                                                    let _e3564 = phi_8711_;
                                                    let _e3566 = phi_8712_;
                                                    let _e3568 = phi_8713_;
                                                    phi_7057_ = _e3558;
                                                    phi_7059_ = _e3529;
                                                    phi_7061_ = _e3533;
                                                    phi_8714_ = _e3529;
                                                    phi_8715_ = _e3560;
                                                    phi_8716_ = _e3562;
                                                    phi_8717_ = false;
                                                    phi_8718_ = _e3564;
                                                    phi_8719_ = _e3566;
                                                    phi_8720_ = _e3568;
                                                } else {
                                                    phi_7057_ = f64();
                                                    phi_7059_ = f64();
                                                    phi_7061_ = f64();
                                                    phi_8714_ = f64();
                                                    phi_8715_ = false;
                                                    phi_8716_ = false;
                                                    phi_8717_ = true;
                                                    phi_8718_ = false;
                                                    phi_8719_ = false;
                                                    phi_8720_ = false;
                                                }
                                                let _e3570 = phi_7057_;
                                                let _e3572 = phi_7059_;
                                                let _e3574 = phi_7061_;
                                                let _e3576 = phi_8714_;
                                                let _e3578 = phi_8715_;
                                                let _e3580 = phi_8716_;
                                                let _e3582 = phi_8717_;
                                                let _e3584 = phi_8718_;
                                                let _e3586 = phi_8719_;
                                                let _e3588 = phi_8720_;
                                                local_19 = _e3580;
                                                local_35 = _e3576;
                                                local_37 = _e3582;
                                                local_38 = _e3584;
                                                local_39 = _e3586;
                                                local_40 = _e3588;
                                                continue;
                                                continuing {
                                                    phi_7053_ = _e2549;
                                                    phi_7056_ = _e3570;
                                                    phi_7058_ = _e3572;
                                                    phi_7060_ = _e3574;
                                                    break if !(_e3578);
                                                }
                                            }
                                            let _e3591 = local_19;
                                            if _e3591 {
                                                let _e6026 = local_35;
                                                phi_8724_ = _e6026;
                                                phi_8725_ = true;
                                                phi_8726_ = false;
                                                phi_8727_ = false;
                                                phi_8728_ = false;
                                            } else {
                                                let _e6028 = local_36;
                                                phi_8724_ = _e6028;
                                                let _e6031 = local_37;
                                                phi_8725_ = _e6031;
                                                let _e6034 = local_38;
                                                phi_8726_ = _e6034;
                                                let _e6037 = local_39;
                                                phi_8727_ = _e6037;
                                                let _e6040 = local_40;
                                                phi_8728_ = _e6040;
                                            }
                                            let _e3593 = phi_8724_;
                                            let _e3595 = phi_8725_;
                                            let _e3597 = phi_8726_;
                                            let _e3599 = phi_8727_;
                                            let _e3601 = phi_8728_;
                                            if _e3595 {
                                                phi_8733_ = type_42(1u, _e3593);
                                                phi_8734_ = false;
                                                phi_8735_ = false;
                                                phi_8736_ = false;
                                            } else {
                                                phi_8733_ = type_42();
                                                phi_8734_ = _e3597;
                                                phi_8735_ = _e3599;
                                                phi_8736_ = _e3601;
                                            }
                                            let _e3604 = phi_8733_;
                                            let _e3606 = phi_8734_;
                                            let _e3608 = phi_8735_;
                                            let _e3610 = phi_8736_;
                                            if _e3606 {
                                                let _e3612 = local_20;
                                                phi_8741_ = type_42(1u, _e3612);
                                                phi_8742_ = false;
                                                phi_8743_ = false;
                                            } else {
                                                phi_8741_ = type_42();
                                                phi_8742_ = _e3608;
                                                phi_8743_ = _e3610;
                                            }
                                            let _e3615 = phi_8741_;
                                            let _e3617 = phi_8742_;
                                            let _e3619 = phi_8743_;
                                            if _e3617 {
                                                phi_8748_ = type_42(0u, type_42().member_1);
                                                phi_8749_ = false;
                                                phi_8750_ = true;
                                            } else {
                                                phi_8748_ = _e3615;
                                                phi_8749_ = _e3619;
                                                phi_8750_ = _e3606;
                                            }
                                            let _e3623 = phi_8748_;
                                            let _e3625 = phi_8749_;
                                            let _e3627 = phi_8750_;
                                            if _e3625 {
                                                phi_8755_ = type_42(0u, type_42().member_1);
                                                phi_8756_ = true;
                                            } else {
                                                phi_8755_ = _e3623;
                                                phi_8756_ = _e3627;
                                            }
                                            let _e3631 = phi_8755_;
                                            let _e3633 = phi_8756_;
                                            if _e3633 {
                                                phi_8760_ = _e3631;
                                            } else {
                                                phi_8760_ = _e3604;
                                            }
                                            let _e3635 = phi_8760_;
                                            let _e3638 = (_e3635.member != 0u);
                                            if _e3638 {
                                                phi_8767_ = false;
                                            } else {
                                                phi_8767_ = true;
                                            }
                                            let _e3640 = phi_8767_;
                                            phi_8768_ = _e3635.member_1;
                                            phi_8769_ = _e3640;
                                            phi_8770_ = _e3638;
                                            phi_8771_ = false;
                                        } else {
                                            phi_8768_ = f64();
                                            phi_8769_ = false;
                                            phi_8770_ = false;
                                            phi_8771_ = true;
                                        }
                                        let _e3642 = phi_8768_;
                                        let _e3644 = phi_8769_;
                                        let _e3646 = phi_8770_;
                                        let _e3648 = phi_8771_;
                                        phi_8772_ = _e3642;
                                        phi_8773_ = _e3644;
                                        phi_8774_ = _e3646;
                                        phi_8775_ = _e3648;
                                    }
                                    let _e3650 = phi_8772_;
                                    let _e3652 = phi_8773_;
                                    let _e3654 = phi_8774_;
                                    let _e3656 = phi_8775_;
                                    phi_8776_ = _e3650;
                                    phi_8777_ = _e2284;
                                    phi_8778_ = _e3652;
                                    phi_8779_ = _e3654;
                                    phi_8780_ = _e3656;
                                }
                                let _e3658 = phi_8776_;
                                let _e3660 = phi_8777_;
                                let _e3662 = phi_8778_;
                                let _e3664 = phi_8779_;
                                let _e3666 = phi_8780_;
                                if _e3660 {
                                    phi_8784_ = true;
                                    phi_8785_ = false;
                                    phi_8786_ = false;
                                } else {
                                    phi_8784_ = _e3662;
                                    phi_8785_ = _e3664;
                                    phi_8786_ = _e3666;
                                }
                                let _e3668 = phi_8784_;
                                let _e3670 = phi_8785_;
                                let _e3672 = phi_8786_;
                                phi_8787_ = _e3658;
                                phi_8788_ = _e1552;
                                phi_8789_ = _e3668;
                                phi_8790_ = false;
                                phi_8791_ = _e3670;
                                phi_8792_ = _e3672;
                            } else {
                                phi_8787_ = f64();
                                phi_8788_ = type_43();
                                phi_8789_ = false;
                                phi_8790_ = true;
                                phi_8791_ = false;
                                phi_8792_ = false;
                            }
                            let _e3674 = phi_8787_;
                            let _e3676 = phi_8788_;
                            let _e3678 = phi_8789_;
                            let _e3680 = phi_8790_;
                            let _e3682 = phi_8791_;
                            let _e3684 = phi_8792_;
                            local_21 = _e3680;
                            local_41 = _e3682;
                            local_42 = _e3684;
                            local_22 = _e3674;
                            local_23 = _e3676;
                            continue;
                            continuing {
                                phi_5142_ = _e1265;
                                break if !(_e3678);
                            }
                        }
                        let _e3687 = local_21;
                        if _e3687 {
                            phi_8797_ = type_42(0u, type_42().member_1);
                            phi_8798_ = false;
                            phi_8799_ = false;
                        } else {
                            phi_8797_ = type_42();
                            let _e6082 = local_41;
                            phi_8798_ = _e6082;
                            let _e6085 = local_42;
                            phi_8799_ = _e6085;
                        }
                        let _e3691 = phi_8797_;
                        let _e3693 = phi_8798_;
                        let _e3695 = phi_8799_;
                        if _e3693 {
                            let _e3697 = local_22;
                            phi_8804_ = type_42(2u, _e3697);
                            phi_8805_ = false;
                        } else {
                            phi_8804_ = type_42();
                            phi_8805_ = _e3695;
                        }
                        let _e3700 = phi_8804_;
                        let _e3702 = phi_8805_;
                        if _e3702 {
                            let _e3704 = local_23;
                            phi_8811_ = type_42(1u, _e3704.member);
                            phi_8812_ = true;
                        } else {
                            phi_8811_ = _e3700;
                            phi_8812_ = _e3693;
                        }
                        let _e3708 = phi_8811_;
                        let _e3710 = phi_8812_;
                        if _e3710 {
                            phi_8816_ = _e3708;
                        } else {
                            phi_8816_ = _e3691;
                        }
                        let _e3712 = phi_8816_;
                        phi_8820_ = _e3712;
                    }
                    let _e5431 = phi_8820_;
                    phi_8821_ = _e5431;
                }
                let _e5435 = phi_8821_;
                switch bitcast<i32>(_e5435.member) {
                    case 0: {
                        phi_8834_ = type_30(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5441 = function_3(_e5435.member_1);
                        phi_8834_ = type_30(0u, _e5441, true);
                        break;
                    }
                    case 2: {
                        let _e5439 = function_3(_e5435.member_1);
                        phi_8834_ = type_30(1u, _e5439, true);
                        break;
                    }
                    default: {
                        phi_8834_ = type_30();
                        break;
                    }
                }
                let _e5444 = phi_8834_;
                if _e5444.member_2 {
                    let _e5451 = (_e5444.member_1[1] >> bitcast<u32>(20i));
                    if (_e5451 <= 896u) {
                        phi_8857_ = 0u;
                    } else {
                        phi_8857_ = ((((_e5451 - 896u) << bitcast<u32>(23i)) | ((_e5444.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5444.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5466 = phi_8857_;
                    let _e5468 = atomicMin((&earliest.member[0u]), _e5466);
                }
                phi_8861_ = type_29(_e177, _e5444.member, _e183, _e186, _e5444.member_1);
                phi_8862_ = _e5444.member_2;
            } else {
                phi_8861_ = type_29(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8862_ = false;
            }
            let _e5470 = phi_8861_;
            let _e5472 = phi_8862_;
            let _e5474 = params.member.member_1;
            if ((_e5474 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5472 {
                    let _e5480 = atomicAdd((&counters[0u]), 1u);
                    phi_8880_ = _e5480;
                } else {
                    phi_8880_ = 0u;
                }
                let _e5482 = phi_8880_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5485 = atomicLoad((&counters[0u]));
                    if (_e5485 > 0u) {
                        let _e5488 = atomicAdd((&contacts.member[0u]), _e5485);
                        atomicStore((&counters[1u]), _e5488);
                    }
                }
                workgroupBarrier();
                let _e5491 = atomicLoad((&counters[1u]));
                let _e5492 = (_e5491 + _e5482);
                if _e5472 {
                    let _e5494 = params.member.member_16;
                    if (_e5492 < _e5494) {
                        let _e5496 = (6u * _e5492);
                        atomicStore((&contacts.member[(4u + _e5496)]), _e5470.member);
                        atomicStore((&contacts.member[(_e5496 + 5u)]), _e5470.member_1);
                        atomicStore((&contacts.member[(_e5496 + 6u)]), _e5470.member_2);
                        atomicStore((&contacts.member[(_e5496 + 7u)]), _e5470.member_3);
                        atomicStore((&contacts.member[(_e5496 + 8u)]), _e5470.member_4[0]);
                        atomicStore((&contacts.member[(_e5496 + 9u)]), _e5470.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_839_ = _e165;
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
