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

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_48;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;
@group(0) @binding(3) 
var<storage> elements: type_28;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_741_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_741_ = param_2;
    } else {
        phi_741_ = param_1;
    }
    let _e26 = phi_741_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_312_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_294_: bool;
    var phi_313_: bool;
    var phi_343_: array<f64, 3>;
    var phi_344_: bool;
    var phi_345_: array<f64, 3>;
    var phi_346_: bool;
    var phi_592_: f64;
    var phi_594_: f64;
    var phi_636_: f64;
    var phi_638_: f64;
    var phi_686_: f64;
    var phi_688_: f64;
    var phi_397_: f64;
    var phi_399_: f64;
    var phi_447_: f64;
    var phi_449_: f64;
    var phi_494_: f64;
    var phi_496_: f64;
    var phi_547_: f64;
    var phi_549_: f64;
    var phi_703_: array<array<f64, 3>, 4>;
    var phi_711_: array<f64, 3>;

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
                    phi_285_ = (_e78 <= _e70);
                    phi_286_ = false;
                } else {
                    phi_285_ = bool();
                    phi_286_ = true;
                }
                let _e99 = phi_285_;
                let _e101 = phi_286_;
                phi_287_ = _e99;
                phi_288_ = _e101;
            } else {
                phi_287_ = bool();
                phi_288_ = true;
            }
            let _e103 = phi_287_;
            let _e105 = phi_288_;
            phi_289_ = _e103;
            phi_290_ = _e105;
        } else {
            phi_289_ = bool();
            phi_290_ = true;
        }
        let _e107 = phi_289_;
        let _e109 = phi_290_;
        if _e109 {
            phi_294_ = false;
        } else {
            phi_294_ = _e107;
        }
        let _e111 = phi_294_;
        phi_313_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_305_ = ((_e74 + _e78) <= _e70);
                phi_306_ = false;
            } else {
                phi_305_ = bool();
                phi_306_ = true;
            }
            let _e85 = phi_305_;
            let _e87 = phi_306_;
            phi_307_ = _e85;
            phi_308_ = _e87;
        } else {
            phi_307_ = bool();
            phi_308_ = true;
        }
        let _e89 = phi_307_;
        let _e91 = phi_308_;
        if _e91 {
            phi_312_ = false;
        } else {
            phi_312_ = _e89;
        }
        let _e93 = phi_312_;
        phi_313_ = _e93;
    }
    let _e113 = phi_313_;
    if (_e68 > _e69) {
        if _e113 {
            phi_343_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_344_ = false;
        } else {
            phi_343_ = array<f64, 3>();
            phi_344_ = true;
        }
        let _e138 = phi_343_;
        let _e140 = phi_344_;
        phi_345_ = _e138;
        phi_346_ = _e140;
    } else {
        phi_345_ = array<f64, 3>();
        phi_346_ = true;
    }
    let _e142 = phi_345_;
    let _e144 = phi_346_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_397_ = _e307;
                } else {
                    phi_397_ = f64(1f);
                }
                let _e315 = phi_397_;
                phi_399_ = _e315;
            } else {
                phi_399_ = f64(0f);
            }
            let _e317 = phi_399_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_447_ = _e353;
                } else {
                    phi_447_ = f64(1f);
                }
                let _e361 = phi_447_;
                phi_449_ = _e361;
            } else {
                phi_449_ = f64(0f);
            }
            let _e363 = phi_449_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_494_ = _e396;
                } else {
                    phi_494_ = f64(1f);
                }
                let _e404 = phi_494_;
                phi_496_ = _e404;
            } else {
                phi_496_ = f64(0f);
            }
            let _e406 = phi_496_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_547_ = _e445;
                } else {
                    phi_547_ = f64(1f);
                }
                let _e453 = phi_547_;
                phi_549_ = _e453;
            } else {
                phi_549_ = f64(0f);
            }
            let _e455 = phi_549_;
            phi_703_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_592_ = _e174;
                } else {
                    phi_592_ = f64(1f);
                }
                let _e182 = phi_592_;
                phi_594_ = _e182;
            } else {
                phi_594_ = f64(0f);
            }
            let _e184 = phi_594_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_636_ = _e214;
                } else {
                    phi_636_ = f64(1f);
                }
                let _e222 = phi_636_;
                phi_638_ = _e222;
            } else {
                phi_638_ = f64(0f);
            }
            let _e224 = phi_638_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_686_ = _e260;
                } else {
                    phi_686_ = f64(1f);
                }
                let _e268 = phi_686_;
                phi_688_ = _e268;
            } else {
                phi_688_ = f64(0f);
            }
            let _e270 = phi_688_;
            phi_703_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_703_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_711_ = _e475;
    } else {
        phi_711_ = _e142;
    }
    let _e477 = phi_711_;
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
    var phi_802_: u32;
    var phi_818_: u32;
    var phi_839_: u32;
    var phi_840_: u32;
    var phi_843_: type_9;
    var phi_844_: type_9;
    var phi_867_: type_9;
    var phi_1114_: type_42;
    var phi_1208_: f64;
    var phi_1214_: f64;
    var phi_1219_: f64;
    var phi_1225_: f64;
    var phi_1230_: f64;
    var phi_1236_: f64;
    var phi_1242_: f64;
    var phi_1247_: f64;
    var phi_1253_: f64;
    var phi_1258_: f64;
    var phi_1263_: f64;
    var phi_1270_: f64;
    var phi_1276_: f64;
    var phi_1281_: f64;
    var phi_1287_: f64;
    var phi_1292_: f64;
    var phi_1298_: f64;
    var phi_1304_: f64;
    var phi_1309_: f64;
    var phi_1315_: f64;
    var phi_1320_: f64;
    var phi_1325_: f64;
    var phi_1332_: f64;
    var phi_1338_: f64;
    var phi_1343_: f64;
    var phi_1349_: f64;
    var phi_1354_: f64;
    var phi_1360_: f64;
    var phi_1366_: f64;
    var phi_1371_: f64;
    var phi_1377_: f64;
    var phi_1382_: f64;
    var phi_1387_: f64;
    var phi_1393_: f64;
    var phi_1398_: f64;
    var phi_1407_: bool;
    var phi_1431_: u64;
    var phi_1443_: f64;
    var phi_1444_: f64;
    var phi_1475_: type_43;
    var phi_1476_: bool;
    var phi_1477_: type_43;
    var phi_1478_: bool;
    var phi_1479_: type_43;
    var phi_1480_: bool;
    var phi_1485_: type_43;
    var phi_1767_: f64;
    var phi_1774_: f64;
    var phi_1779_: f64;
    var phi_1786_: f64;
    var phi_1791_: f64;
    var phi_1804_: f64;
    var phi_1811_: f64;
    var phi_1816_: f64;
    var phi_1823_: f64;
    var phi_1828_: f64;
    var phi_1833_: f64;
    var phi_1850_: f64;
    var phi_1857_: f64;
    var phi_1862_: f64;
    var phi_1869_: f64;
    var phi_1874_: f64;
    var phi_1888_: f64;
    var phi_1895_: f64;
    var phi_1900_: f64;
    var phi_1907_: f64;
    var phi_1912_: f64;
    var phi_1917_: f64;
    var phi_1934_: f64;
    var phi_1941_: f64;
    var phi_1946_: f64;
    var phi_1953_: f64;
    var phi_1958_: f64;
    var phi_1972_: f64;
    var phi_1979_: f64;
    var phi_1984_: f64;
    var phi_1991_: f64;
    var phi_1996_: f64;
    var phi_2001_: f64;
    var phi_2038_: f64;
    var phi_2044_: f64;
    var phi_2051_: f64;
    var phi_2058_: f64;
    var phi_2064_: f64;
    var phi_2071_: f64;
    var phi_2077_: f64;
    var phi_2083_: f64;
    var phi_2089_: f64;
    var phi_2096_: f64;
    var phi_2103_: f64;
    var phi_2131_: f64;
    var phi_2136_: f64;
    var phi_2141_: f64;
    var phi_2146_: f64;
    var phi_2151_: f64;
    var phi_2156_: f64;
    var phi_2167_: f64;
    var phi_4864_: f64;
    var phi_4870_: f64;
    var phi_4875_: f64;
    var phi_4881_: f64;
    var phi_4887_: f64;
    var phi_4892_: f64;
    var phi_4897_: f64;
    var phi_4907_: bool;
    var phi_4914_: f64;
    var phi_4922_: f64;
    var phi_4965_: type_16;
    var phi_4968_: f64;
    var phi_4989_: bool;
    var phi_4995_: type_17;
    var phi_4966_: type_16;
    var phi_5009_: type_17;
    var phi_4969_: f64;
    var local_13: f64;
    var phi_4958_: f64;
    var phi_5022_: f64;
    var phi_5028_: f64;
    var phi_5053_: type_9;
    var phi_5056_: u32;
    var phi_5054_: type_9;
    var phi_5079_: type_9;
    var phi_5123_: u32;
    var phi_5124_: u32;
    var phi_5057_: u32;
    var phi_5125_: u32;
    var phi_5145_: type_9;
    var phi_5146_: type_9;
    var phi_5169_: type_9;
    var phi_5223_: f64;
    var phi_5230_: f64;
    var phi_5242_: bool;
    var phi_5243_: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5249_: bool;
    var phi_5261_: type_45;
    var phi_5262_: type_45;
    var phi_5263_: bool;
    var phi_5264_: type_45;
    var phi_5265_: bool;
    var phi_5278_: f64;
    var phi_5291_: type_9;
    var phi_5294_: f64;
    var phi_5296_: f64;
    var phi_5298_: f64;
    var phi_5292_: type_9;
    var phi_5321_: type_9;
    var phi_5348_: f64;
    var phi_5349_: f64;
    var phi_5377_: f64;
    var phi_5393_: f64;
    var phi_5400_: bool;
    var phi_5401_: bool;
    var phi_5402_: bool;
    var phi_5408_: f64;
    var phi_5409_: f64;
    var phi_5410_: bool;
    var phi_5295_: f64;
    var phi_5297_: f64;
    var phi_5299_: f64;
    var phi_5411_: f64;
    var phi_5412_: bool;
    var phi_5413_: bool;
    var local_14: bool;
    var phi_5417_: f64;
    var phi_5418_: f64;
    var phi_5428_: f64;
    var phi_5433_: type_9;
    var phi_5436_: f64;
    var phi_5434_: type_9;
    var phi_5459_: type_9;
    var phi_5490_: f64;
    var phi_5491_: bool;
    var phi_5492_: f64;
    var phi_5493_: bool;
    var phi_5494_: bool;
    var phi_5495_: bool;
    var phi_5496_: f64;
    var phi_5437_: f64;
    var phi_5497_: bool;
    var phi_5498_: bool;
    var phi_5499_: bool;
    var phi_5500_: bool;
    var local_15: bool;
    var phi_5504_: bool;
    var phi_5505_: bool;
    var phi_5509_: bool;
    var phi_5513_: f64;
    var phi_5514_: f64;
    var phi_5516_: type_45;
    var phi_5547_: f64;
    var phi_5554_: f64;
    var phi_5559_: f64;
    var phi_5566_: f64;
    var phi_5571_: f64;
    var phi_5584_: f64;
    var phi_5591_: f64;
    var phi_5596_: f64;
    var phi_5603_: f64;
    var phi_5608_: f64;
    var phi_5613_: f64;
    var phi_5672_: f64;
    var phi_5678_: f64;
    var phi_5683_: f64;
    var phi_5689_: f64;
    var phi_5694_: f64;
    var phi_5708_: f64;
    var phi_5714_: f64;
    var phi_5719_: f64;
    var phi_5725_: f64;
    var phi_5730_: f64;
    var phi_5756_: f64;
    var phi_5763_: f64;
    var phi_5768_: f64;
    var phi_5775_: f64;
    var phi_5780_: f64;
    var phi_5793_: f64;
    var phi_5800_: f64;
    var phi_5805_: f64;
    var phi_5812_: f64;
    var phi_5817_: f64;
    var phi_5822_: f64;
    var phi_5881_: f64;
    var phi_5887_: f64;
    var phi_5892_: f64;
    var phi_5898_: f64;
    var phi_5903_: f64;
    var phi_5917_: f64;
    var phi_5923_: f64;
    var phi_5928_: f64;
    var phi_5934_: f64;
    var phi_5939_: f64;
    var phi_5965_: f64;
    var phi_5972_: f64;
    var phi_5977_: f64;
    var phi_5984_: f64;
    var phi_5989_: f64;
    var phi_6002_: f64;
    var phi_6009_: f64;
    var phi_6014_: f64;
    var phi_6021_: f64;
    var phi_6026_: f64;
    var phi_6031_: f64;
    var phi_6090_: f64;
    var phi_6096_: f64;
    var phi_6101_: f64;
    var phi_6107_: f64;
    var phi_6112_: f64;
    var phi_6126_: f64;
    var phi_6132_: f64;
    var phi_6137_: f64;
    var phi_6143_: f64;
    var phi_6148_: f64;
    var phi_6197_: f64;
    var phi_6203_: f64;
    var phi_6231_: f64;
    var phi_6237_: f64;
    var phi_6242_: u32;
    var phi_6243_: u32;
    var phi_6213_: f64;
    var phi_6219_: f64;
    var phi_6224_: u32;
    var phi_6225_: u32;
    var phi_6244_: u32;
    var phi_6245_: u32;
    var phi_6318_: f64;
    var phi_6330_: f64;
    var phi_6473_: f64;
    var phi_6479_: f64;
    var phi_6486_: f64;
    var phi_6530_: type_9;
    var phi_6533_: bool;
    var phi_6531_: type_9;
    var phi_6556_: type_9;
    var phi_6583_: bool;
    var phi_6584_: bool;
    var phi_6534_: bool;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var local_16: bool;
    var phi_6590_: bool;
    var local_17: bool;
    var phi_6597_: u32;
    var phi_6598_: u32;
    var phi_6599_: bool;
    var phi_6600_: u32;
    var phi_6601_: u32;
    var phi_6602_: bool;
    var phi_6606_: u32;
    var phi_6627_: bool;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var phi_6778_: f64;
    var phi_6785_: f64;
    var phi_6790_: f64;
    var phi_6797_: f64;
    var phi_6802_: f64;
    var phi_6815_: f64;
    var phi_6822_: f64;
    var phi_6827_: f64;
    var phi_6834_: f64;
    var phi_6839_: f64;
    var phi_6844_: f64;
    var phi_6861_: f64;
    var phi_6868_: f64;
    var phi_6873_: f64;
    var phi_6880_: f64;
    var phi_6885_: f64;
    var phi_6899_: f64;
    var phi_6906_: f64;
    var phi_6911_: f64;
    var phi_6918_: f64;
    var phi_6923_: f64;
    var phi_6928_: f64;
    var phi_6945_: f64;
    var phi_6952_: f64;
    var phi_6957_: f64;
    var phi_6964_: f64;
    var phi_6969_: f64;
    var phi_6983_: f64;
    var phi_6990_: f64;
    var phi_6995_: f64;
    var phi_7002_: f64;
    var phi_7007_: f64;
    var phi_7012_: f64;
    var phi_7056_: type_9;
    var phi_7059_: f64;
    var phi_7061_: f64;
    var phi_7063_: f64;
    var phi_7057_: type_9;
    var phi_7086_: type_9;
    var phi_7198_: f64;
    var phi_7205_: f64;
    var phi_7213_: f64;
    var phi_7259_: type_16;
    var phi_7262_: f64;
    var phi_7283_: bool;
    var phi_7289_: type_17;
    var phi_7260_: type_16;
    var phi_7303_: type_17;
    var phi_7263_: f64;
    var local_18: f64;
    var phi_7252_: f64;
    var phi_7316_: f64;
    var phi_7385_: f64;
    var phi_7391_: f64;
    var phi_7400_: f64;
    var phi_7406_: f64;
    var phi_7415_: f64;
    var phi_7421_: f64;
    var phi_7430_: f64;
    var phi_7436_: f64;
    var phi_7442_: type_34;
    var phi_7443_: bool;
    var phi_7444_: type_34;
    var phi_7445_: bool;
    var phi_7455_: type_34;
    var phi_7626_: bool;
    var phi_7627_: bool;
    var phi_7628_: bool;
    var phi_7629_: bool;
    var phi_7630_: bool;
    var phi_7631_: bool;
    var phi_7635_: bool;
    var phi_7933_: bool;
    var phi_7934_: bool;
    var phi_7935_: bool;
    var phi_7936_: bool;
    var phi_7937_: bool;
    var phi_7938_: bool;
    var phi_7942_: bool;
    var phi_7946_: bool;
    var phi_7958_: bool;
    var phi_7959_: bool;
    var phi_8033_: bool;
    var phi_8034_: bool;
    var phi_8057_: f64;
    var phi_8058_: bool;
    var phi_8059_: f64;
    var phi_8060_: bool;
    var phi_8061_: f64;
    var phi_8062_: bool;
    var phi_8063_: bool;
    var phi_8068_: f64;
    var phi_8069_: bool;
    var phi_8073_: f64;
    var phi_8105_: bool;
    var phi_8106_: bool;
    var phi_8129_: f64;
    var phi_8130_: bool;
    var phi_8131_: f64;
    var phi_8132_: bool;
    var phi_8133_: f64;
    var phi_8134_: bool;
    var phi_8135_: bool;
    var phi_8140_: f64;
    var phi_8141_: bool;
    var phi_8145_: f64;
    var phi_8150_: f64;
    var phi_8182_: bool;
    var phi_8183_: bool;
    var phi_8206_: f64;
    var phi_8207_: bool;
    var phi_8208_: f64;
    var phi_8209_: bool;
    var phi_8210_: f64;
    var phi_8211_: bool;
    var phi_8212_: bool;
    var phi_8217_: f64;
    var phi_8218_: bool;
    var phi_8222_: f64;
    var phi_8254_: bool;
    var phi_8255_: bool;
    var phi_8278_: f64;
    var phi_8279_: bool;
    var phi_8280_: f64;
    var phi_8281_: bool;
    var phi_8282_: f64;
    var phi_8283_: bool;
    var phi_8284_: bool;
    var phi_8289_: f64;
    var phi_8290_: bool;
    var phi_8294_: f64;
    var phi_8299_: f64;
    var phi_8304_: f64;
    var phi_8309_: f64;
    var phi_8320_: f64;
    var phi_8321_: f64;
    var phi_8322_: bool;
    var phi_8323_: f64;
    var phi_8324_: f64;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: bool;
    var phi_8328_: f64;
    var phi_8329_: f64;
    var phi_8330_: bool;
    var phi_8331_: bool;
    var phi_8332_: bool;
    var phi_8333_: bool;
    var phi_8334_: f64;
    var phi_8335_: f64;
    var phi_8336_: bool;
    var phi_8337_: bool;
    var phi_8338_: bool;
    var phi_8339_: bool;
    var phi_8419_: f64;
    var phi_8492_: f64;
    var phi_8497_: f64;
    var phi_8570_: f64;
    var phi_8643_: f64;
    var phi_8648_: f64;
    var phi_8669_: f64;
    var phi_8670_: f64;
    var phi_8671_: f64;
    var phi_8673_: f64;
    var phi_8674_: bool;
    var phi_8675_: f64;
    var phi_8676_: f64;
    var phi_8677_: f64;
    var phi_8678_: bool;
    var phi_8679_: bool;
    var phi_8680_: bool;
    var phi_8681_: bool;
    var phi_8690_: f64;
    var phi_8695_: f64;
    var phi_8706_: bool;
    var phi_8710_: bool;
    var phi_8711_: f64;
    var phi_8712_: bool;
    var phi_8713_: bool;
    var phi_8714_: bool;
    var phi_8715_: bool;
    var phi_8716_: bool;
    var phi_7060_: f64;
    var phi_7062_: f64;
    var phi_7064_: f64;
    var phi_8717_: f64;
    var phi_8718_: bool;
    var phi_8719_: bool;
    var phi_8720_: bool;
    var phi_8721_: bool;
    var phi_8722_: bool;
    var phi_8723_: bool;
    var local_19: bool;
    var phi_8727_: f64;
    var phi_8728_: bool;
    var phi_8729_: bool;
    var phi_8730_: bool;
    var phi_8731_: bool;
    var phi_8736_: type_44;
    var phi_8737_: bool;
    var phi_8738_: bool;
    var phi_8739_: bool;
    var local_20: f64;
    var phi_8744_: type_44;
    var phi_8745_: bool;
    var phi_8746_: bool;
    var phi_8751_: type_44;
    var phi_8752_: bool;
    var phi_8753_: bool;
    var phi_8758_: type_44;
    var phi_8759_: bool;
    var phi_8763_: type_44;
    var phi_8770_: bool;
    var phi_8771_: f64;
    var phi_8772_: bool;
    var phi_8773_: bool;
    var phi_8774_: bool;
    var phi_8775_: f64;
    var phi_8776_: bool;
    var phi_8777_: bool;
    var phi_8778_: bool;
    var phi_8779_: f64;
    var phi_8780_: bool;
    var phi_8781_: bool;
    var phi_8782_: bool;
    var phi_8783_: bool;
    var phi_8787_: bool;
    var phi_8788_: bool;
    var phi_8789_: bool;
    var phi_8790_: f64;
    var phi_8791_: type_45;
    var phi_8792_: bool;
    var phi_8793_: bool;
    var phi_8794_: bool;
    var phi_8795_: bool;
    var local_21: bool;
    var phi_8800_: type_44;
    var phi_8801_: bool;
    var phi_8802_: bool;
    var local_22: f64;
    var phi_8807_: type_44;
    var phi_8808_: bool;
    var local_23: type_45;
    var phi_8814_: type_44;
    var phi_8815_: bool;
    var phi_8819_: type_44;
    var phi_2324_: f64;
    var phi_2331_: f64;
    var phi_2336_: f64;
    var phi_2343_: f64;
    var phi_2348_: f64;
    var phi_2361_: f64;
    var phi_2368_: f64;
    var phi_2373_: f64;
    var phi_2380_: f64;
    var phi_2385_: f64;
    var phi_2390_: f64;
    var phi_2407_: f64;
    var phi_2414_: f64;
    var phi_2419_: f64;
    var phi_2426_: f64;
    var phi_2431_: f64;
    var phi_2445_: f64;
    var phi_2452_: f64;
    var phi_2457_: f64;
    var phi_2464_: f64;
    var phi_2469_: f64;
    var phi_2474_: f64;
    var phi_2491_: f64;
    var phi_2498_: f64;
    var phi_2503_: f64;
    var phi_2510_: f64;
    var phi_2515_: f64;
    var phi_2529_: f64;
    var phi_2536_: f64;
    var phi_2541_: f64;
    var phi_2548_: f64;
    var phi_2553_: f64;
    var phi_2558_: f64;
    var phi_2602_: type_9;
    var phi_2605_: f64;
    var phi_2607_: f64;
    var phi_2609_: f64;
    var phi_2603_: type_9;
    var phi_2632_: type_9;
    var phi_2744_: f64;
    var phi_2751_: f64;
    var phi_2759_: f64;
    var phi_2805_: type_16;
    var phi_2808_: f64;
    var phi_2829_: bool;
    var phi_2835_: type_17;
    var phi_2806_: type_16;
    var phi_2849_: type_17;
    var phi_2809_: f64;
    var local_24: f64;
    var phi_2798_: f64;
    var phi_2862_: f64;
    var phi_2931_: f64;
    var phi_2937_: f64;
    var phi_2946_: f64;
    var phi_2952_: f64;
    var phi_2961_: f64;
    var phi_2967_: f64;
    var phi_2976_: f64;
    var phi_2982_: f64;
    var phi_2988_: type_34;
    var phi_2989_: bool;
    var phi_2990_: type_34;
    var phi_2991_: bool;
    var phi_3001_: type_34;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3181_: bool;
    var phi_3479_: bool;
    var phi_3480_: bool;
    var phi_3481_: bool;
    var phi_3482_: bool;
    var phi_3483_: bool;
    var phi_3484_: bool;
    var phi_3488_: bool;
    var phi_3492_: bool;
    var phi_3504_: bool;
    var phi_3505_: bool;
    var phi_3579_: bool;
    var phi_3580_: bool;
    var phi_3603_: f64;
    var phi_3604_: bool;
    var phi_3605_: f64;
    var phi_3606_: bool;
    var phi_3607_: f64;
    var phi_3608_: bool;
    var phi_3609_: bool;
    var phi_3614_: f64;
    var phi_3615_: bool;
    var phi_3619_: f64;
    var phi_3651_: bool;
    var phi_3652_: bool;
    var phi_3675_: f64;
    var phi_3676_: bool;
    var phi_3677_: f64;
    var phi_3678_: bool;
    var phi_3679_: f64;
    var phi_3680_: bool;
    var phi_3681_: bool;
    var phi_3686_: f64;
    var phi_3687_: bool;
    var phi_3691_: f64;
    var phi_3696_: f64;
    var phi_3728_: bool;
    var phi_3729_: bool;
    var phi_3752_: f64;
    var phi_3753_: bool;
    var phi_3754_: f64;
    var phi_3755_: bool;
    var phi_3756_: f64;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3763_: f64;
    var phi_3764_: bool;
    var phi_3768_: f64;
    var phi_3800_: bool;
    var phi_3801_: bool;
    var phi_3824_: f64;
    var phi_3825_: bool;
    var phi_3826_: f64;
    var phi_3827_: bool;
    var phi_3828_: f64;
    var phi_3829_: bool;
    var phi_3830_: bool;
    var phi_3835_: f64;
    var phi_3836_: bool;
    var phi_3840_: f64;
    var phi_3845_: f64;
    var phi_3850_: f64;
    var phi_3855_: f64;
    var phi_3866_: f64;
    var phi_3867_: f64;
    var phi_3868_: bool;
    var phi_3869_: f64;
    var phi_3870_: f64;
    var phi_3871_: bool;
    var phi_3872_: bool;
    var phi_3873_: bool;
    var phi_3874_: f64;
    var phi_3875_: f64;
    var phi_3876_: bool;
    var phi_3877_: bool;
    var phi_3878_: bool;
    var phi_3879_: bool;
    var phi_3880_: f64;
    var phi_3881_: f64;
    var phi_3882_: bool;
    var phi_3883_: bool;
    var phi_3884_: bool;
    var phi_3885_: bool;
    var phi_3965_: f64;
    var phi_4038_: f64;
    var phi_4043_: f64;
    var phi_4116_: f64;
    var phi_4189_: f64;
    var phi_4194_: f64;
    var phi_4215_: f64;
    var phi_4216_: f64;
    var phi_4217_: f64;
    var phi_4219_: f64;
    var phi_4220_: bool;
    var phi_4221_: f64;
    var phi_4222_: f64;
    var phi_4223_: f64;
    var phi_4224_: bool;
    var phi_4225_: bool;
    var phi_4226_: bool;
    var phi_4227_: bool;
    var phi_4236_: f64;
    var phi_4241_: f64;
    var phi_4252_: bool;
    var phi_4256_: bool;
    var phi_4257_: f64;
    var phi_4258_: bool;
    var phi_4259_: bool;
    var phi_4260_: bool;
    var phi_4261_: bool;
    var phi_4262_: bool;
    var phi_2606_: f64;
    var phi_2608_: f64;
    var phi_2610_: f64;
    var phi_4263_: f64;
    var phi_4264_: bool;
    var phi_4265_: bool;
    var phi_4266_: bool;
    var phi_4267_: bool;
    var phi_4268_: bool;
    var phi_4269_: bool;
    var local_25: bool;
    var phi_4273_: f64;
    var phi_4274_: bool;
    var phi_4275_: bool;
    var phi_4276_: bool;
    var phi_4277_: bool;
    var phi_4282_: type_44;
    var phi_4283_: bool;
    var phi_4284_: bool;
    var phi_4285_: bool;
    var local_26: f64;
    var phi_4290_: type_44;
    var phi_4291_: bool;
    var phi_4292_: bool;
    var phi_4297_: type_44;
    var phi_4298_: bool;
    var phi_4299_: bool;
    var phi_4304_: type_44;
    var phi_4305_: bool;
    var phi_4309_: type_44;
    var phi_4323_: type_9;
    var phi_4324_: type_9;
    var phi_4347_: type_9;
    var phi_4368_: f64;
    var phi_4498_: type_16;
    var phi_4501_: f64;
    var phi_4522_: bool;
    var phi_4528_: type_17;
    var phi_4499_: type_16;
    var phi_4542_: type_17;
    var phi_4502_: f64;
    var local_27: f64;
    var phi_4491_: f64;
    var phi_4555_: f64;
    var phi_4573_: f64;
    var phi_4580_: f64;
    var phi_4585_: f64;
    var phi_4592_: f64;
    var phi_4597_: f64;
    var phi_4610_: f64;
    var phi_4617_: f64;
    var phi_4622_: f64;
    var phi_4629_: f64;
    var phi_4634_: f64;
    var phi_4639_: f64;
    var phi_4656_: f64;
    var phi_4663_: f64;
    var phi_4668_: f64;
    var phi_4675_: f64;
    var phi_4680_: f64;
    var phi_4694_: f64;
    var phi_4701_: f64;
    var phi_4706_: f64;
    var phi_4713_: f64;
    var phi_4718_: f64;
    var phi_4723_: f64;
    var phi_4740_: f64;
    var phi_4747_: f64;
    var phi_4752_: f64;
    var phi_4759_: f64;
    var phi_4764_: f64;
    var phi_4778_: f64;
    var phi_4785_: f64;
    var phi_4790_: f64;
    var phi_4797_: f64;
    var phi_4802_: f64;
    var phi_4807_: f64;
    var phi_4831_: bool;
    var phi_4832_: bool;
    var phi_4833_: bool;
    var local_28: bool;
    var phi_4838_: type_44;
    var phi_4839_: bool;
    var phi_4844_: type_44;
    var phi_4845_: bool;
    var phi_4847_: type_44;
    var phi_4848_: type_44;
    var phi_4849_: bool;
    var phi_4853_: type_44;
    var phi_8823_: type_44;
    var phi_8824_: type_44;
    var phi_8837_: type_32;
    var phi_8860_: u32;
    var phi_8864_: type_22;
    var phi_8865_: bool;
    var phi_8884_: u32;
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
        phi_802_ = _e128;
    } else {
        phi_802_ = _e130;
    }
    let _e133 = phi_802_;
    let _e134 = (_e133 / 64u);
    if ((_e133 % 64u) > 0u) {
        phi_818_ = (_e134 + 1u);
    } else {
        phi_818_ = _e134;
    }
    let _e139 = phi_818_;
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
            phi_839_ = (_e143 + 1u);
        } else {
            phi_839_ = _e143;
        }
        let _e149 = phi_839_;
        phi_840_ = _e149;
    } else {
        phi_840_ = 0u;
    }
    let _e151 = phi_840_;
    phi_843_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_843_;
        if (_e154.member < _e154.member_1) {
            phi_844_ = type_9((_e154.member + 1u), _e154.member_1);
            phi_867_ = type_9(1u, _e154.member);
        } else {
            phi_844_ = _e154;
            phi_867_ = type_9(0u, type_9().member_1);
        }
        let _e166 = phi_844_;
        let _e168 = phi_867_;
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
                    phi_1114_ = type_42(array<array<f64, 3>, 4>(_e278, _e279, _e280, _e281), array<array<f64, 3>, 4>(_e283, _e284, _e285, _e286));
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
                    phi_1114_ = type_42(array<array<f64, 3>, 4>(_e196, _e204, _e212, _e220), array<array<f64, 3>, 4>(_e202, _e210, _e218, _e226));
                }
                let _e290 = phi_1114_;
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
                    phi_1208_ = -(_e297);
                } else {
                    phi_1208_ = _e297;
                }
                let _e382 = phi_1208_;
                if (_e300 < 0.0lf) {
                    phi_1214_ = -(_e300);
                } else {
                    phi_1214_ = _e300;
                }
                let _e386 = phi_1214_;
                if (_e382 > _e386) {
                    phi_1219_ = _e382;
                } else {
                    phi_1219_ = _e386;
                }
                let _e389 = phi_1219_;
                if (_e303 < 0.0lf) {
                    phi_1225_ = -(_e303);
                } else {
                    phi_1225_ = _e303;
                }
                let _e393 = phi_1225_;
                if (_e389 > _e393) {
                    phi_1230_ = _e389;
                } else {
                    phi_1230_ = _e393;
                }
                let _e396 = phi_1230_;
                if (_e309 < 0.0lf) {
                    phi_1236_ = -(_e309);
                } else {
                    phi_1236_ = _e309;
                }
                let _e400 = phi_1236_;
                if (_e312 < 0.0lf) {
                    phi_1242_ = -(_e312);
                } else {
                    phi_1242_ = _e312;
                }
                let _e404 = phi_1242_;
                if (_e400 > _e404) {
                    phi_1247_ = _e400;
                } else {
                    phi_1247_ = _e404;
                }
                let _e407 = phi_1247_;
                if (_e315 < 0.0lf) {
                    phi_1253_ = -(_e315);
                } else {
                    phi_1253_ = _e315;
                }
                let _e411 = phi_1253_;
                if (_e407 > _e411) {
                    phi_1258_ = _e407;
                } else {
                    phi_1258_ = _e411;
                }
                let _e414 = phi_1258_;
                if (_e396 > _e414) {
                    phi_1263_ = _e396;
                } else {
                    phi_1263_ = _e414;
                }
                let _e417 = phi_1263_;
                let _e418 = (_e417 + _e368);
                if (_e322 < 0.0lf) {
                    phi_1270_ = -(_e322);
                } else {
                    phi_1270_ = _e322;
                }
                let _e422 = phi_1270_;
                if (_e325 < 0.0lf) {
                    phi_1276_ = -(_e325);
                } else {
                    phi_1276_ = _e325;
                }
                let _e426 = phi_1276_;
                if (_e422 > _e426) {
                    phi_1281_ = _e422;
                } else {
                    phi_1281_ = _e426;
                }
                let _e429 = phi_1281_;
                if (_e328 < 0.0lf) {
                    phi_1287_ = -(_e328);
                } else {
                    phi_1287_ = _e328;
                }
                let _e433 = phi_1287_;
                if (_e429 > _e433) {
                    phi_1292_ = _e429;
                } else {
                    phi_1292_ = _e433;
                }
                let _e436 = phi_1292_;
                if (_e334 < 0.0lf) {
                    phi_1298_ = -(_e334);
                } else {
                    phi_1298_ = _e334;
                }
                let _e440 = phi_1298_;
                if (_e337 < 0.0lf) {
                    phi_1304_ = -(_e337);
                } else {
                    phi_1304_ = _e337;
                }
                let _e444 = phi_1304_;
                if (_e440 > _e444) {
                    phi_1309_ = _e440;
                } else {
                    phi_1309_ = _e444;
                }
                let _e447 = phi_1309_;
                if (_e340 < 0.0lf) {
                    phi_1315_ = -(_e340);
                } else {
                    phi_1315_ = _e340;
                }
                let _e451 = phi_1315_;
                if (_e447 > _e451) {
                    phi_1320_ = _e447;
                } else {
                    phi_1320_ = _e451;
                }
                let _e454 = phi_1320_;
                if (_e436 > _e454) {
                    phi_1325_ = _e436;
                } else {
                    phi_1325_ = _e454;
                }
                let _e457 = phi_1325_;
                let _e458 = (_e457 + _e368);
                if (_e347 < 0.0lf) {
                    phi_1332_ = -(_e347);
                } else {
                    phi_1332_ = _e347;
                }
                let _e462 = phi_1332_;
                if (_e350 < 0.0lf) {
                    phi_1338_ = -(_e350);
                } else {
                    phi_1338_ = _e350;
                }
                let _e466 = phi_1338_;
                if (_e462 > _e466) {
                    phi_1343_ = _e462;
                } else {
                    phi_1343_ = _e466;
                }
                let _e469 = phi_1343_;
                if (_e353 < 0.0lf) {
                    phi_1349_ = -(_e353);
                } else {
                    phi_1349_ = _e353;
                }
                let _e473 = phi_1349_;
                if (_e469 > _e473) {
                    phi_1354_ = _e469;
                } else {
                    phi_1354_ = _e473;
                }
                let _e476 = phi_1354_;
                if (_e359 < 0.0lf) {
                    phi_1360_ = -(_e359);
                } else {
                    phi_1360_ = _e359;
                }
                let _e480 = phi_1360_;
                if (_e362 < 0.0lf) {
                    phi_1366_ = -(_e362);
                } else {
                    phi_1366_ = _e362;
                }
                let _e484 = phi_1366_;
                if (_e480 > _e484) {
                    phi_1371_ = _e480;
                } else {
                    phi_1371_ = _e484;
                }
                let _e487 = phi_1371_;
                if (_e365 < 0.0lf) {
                    phi_1377_ = -(_e365);
                } else {
                    phi_1377_ = _e365;
                }
                let _e491 = phi_1377_;
                if (_e487 > _e491) {
                    phi_1382_ = _e487;
                } else {
                    phi_1382_ = _e491;
                }
                let _e494 = phi_1382_;
                if (_e476 > _e494) {
                    phi_1387_ = _e476;
                } else {
                    phi_1387_ = _e494;
                }
                let _e497 = phi_1387_;
                let _e498 = (_e497 + _e368);
                if (_e418 > _e458) {
                    phi_1393_ = _e418;
                } else {
                    phi_1393_ = _e458;
                }
                let _e501 = phi_1393_;
                if (_e501 > _e498) {
                    phi_1398_ = _e501;
                } else {
                    phi_1398_ = _e498;
                }
                let _e504 = phi_1398_;
                if (_e504 <= f64(65536f)) {
                    phi_1407_ = (_e504 >= f64((1f / 65536f)));
                } else {
                    phi_1407_ = false;
                }
                let _e511 = phi_1407_;
                if _e511 {
                    phi_1479_ = type_43();
                    phi_1480_ = true;
                } else {
                    if (_e504 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e504) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e518 = (9214364837600034816lu - (bitcast<u64>(_e504) & 9218868437227405312lu));
                            if (_e518 > 4503599627370496lu) {
                                phi_1431_ = _e518;
                            } else {
                                phi_1431_ = 4503599627370496lu;
                            }
                            let _e521 = phi_1431_;
                            let _e522 = bitcast<f64>(_e521);
                            let _e523 = (_e378 * _e522);
                            if (_e378 > f64(0f)) {
                                if (_e523 > 2.2250738585072014e-308lf) {
                                    phi_1443_ = _e523;
                                } else {
                                    phi_1443_ = 2.2250738585072014e-308lf;
                                }
                                let _e528 = phi_1443_;
                                phi_1444_ = _e528;
                            } else {
                                phi_1444_ = _e523;
                            }
                            let _e530 = phi_1444_;
                            phi_1475_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e297 * _e522), (_e300 * _e522), (_e303 * _e522)), array<f64, 3>((_e309 * _e522), (_e312 * _e522), (_e315 * _e522))), array<array<f64, 3>, 2>(array<f64, 3>((_e322 * _e522), (_e325 * _e522), (_e328 * _e522)), array<f64, 3>((_e334 * _e522), (_e337 * _e522), (_e340 * _e522))), array<array<f64, 3>, 2>(array<f64, 3>((_e347 * _e522), (_e350 * _e522), (_e353 * _e522)), array<f64, 3>((_e359 * _e522), (_e362 * _e522), (_e365 * _e522))), (_e368 * _e522)), _e530);
                            phi_1476_ = false;
                        } else {
                            phi_1475_ = type_43();
                            phi_1476_ = true;
                        }
                        let _e562 = phi_1475_;
                        let _e564 = phi_1476_;
                        phi_1477_ = _e562;
                        phi_1478_ = _e564;
                    } else {
                        phi_1477_ = type_43();
                        phi_1478_ = true;
                    }
                    let _e566 = phi_1477_;
                    let _e568 = phi_1478_;
                    phi_1479_ = _e566;
                    phi_1480_ = _e568;
                }
                let _e570 = phi_1479_;
                let _e572 = phi_1480_;
                if _e572 {
                    phi_1485_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e297, _e300, _e303), array<f64, 3>(_e309, _e312, _e315)), array<array<f64, 3>, 2>(array<f64, 3>(_e322, _e325, _e328), array<f64, 3>(_e334, _e337, _e340)), array<array<f64, 3>, 2>(array<f64, 3>(_e347, _e350, _e353), array<f64, 3>(_e359, _e362, _e365)), _e368), _e378);
                } else {
                    phi_1485_ = _e570;
                }
                let _e575 = phi_1485_;
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
                    phi_1767_ = -(_e773[0]);
                } else {
                    phi_1767_ = _e773[0];
                }
                let _e780 = phi_1767_;
                if (_e773[1] < 0.0lf) {
                    phi_1774_ = -(_e773[1]);
                } else {
                    phi_1774_ = _e773[1];
                }
                let _e784 = phi_1774_;
                if (_e780 > _e784) {
                    phi_1779_ = _e780;
                } else {
                    phi_1779_ = _e784;
                }
                let _e787 = phi_1779_;
                if (_e773[2] < 0.0lf) {
                    phi_1786_ = -(_e773[2]);
                } else {
                    phi_1786_ = _e773[2];
                }
                let _e791 = phi_1786_;
                if (_e787 > _e791) {
                    phi_1791_ = _e787;
                } else {
                    phi_1791_ = _e791;
                }
                let _e794 = phi_1791_;
                let _e797 = local_12.member[1u];
                if (_e797[0] < 0.0lf) {
                    phi_1804_ = -(_e797[0]);
                } else {
                    phi_1804_ = _e797[0];
                }
                let _e804 = phi_1804_;
                if (_e797[1] < 0.0lf) {
                    phi_1811_ = -(_e797[1]);
                } else {
                    phi_1811_ = _e797[1];
                }
                let _e808 = phi_1811_;
                if (_e804 > _e808) {
                    phi_1816_ = _e804;
                } else {
                    phi_1816_ = _e808;
                }
                let _e811 = phi_1816_;
                if (_e797[2] < 0.0lf) {
                    phi_1823_ = -(_e797[2]);
                } else {
                    phi_1823_ = _e797[2];
                }
                let _e815 = phi_1823_;
                if (_e811 > _e815) {
                    phi_1828_ = _e811;
                } else {
                    phi_1828_ = _e815;
                }
                let _e818 = phi_1828_;
                if (_e794 > _e818) {
                    phi_1833_ = _e794;
                } else {
                    phi_1833_ = _e818;
                }
                let _e821 = phi_1833_;
                let _e823 = local_12.member_3;
                let _e824 = (_e821 + _e823);
                let _e827 = local_12.member_1[0u];
                if (_e827[0] < 0.0lf) {
                    phi_1850_ = -(_e827[0]);
                } else {
                    phi_1850_ = _e827[0];
                }
                let _e834 = phi_1850_;
                if (_e827[1] < 0.0lf) {
                    phi_1857_ = -(_e827[1]);
                } else {
                    phi_1857_ = _e827[1];
                }
                let _e838 = phi_1857_;
                if (_e834 > _e838) {
                    phi_1862_ = _e834;
                } else {
                    phi_1862_ = _e838;
                }
                let _e841 = phi_1862_;
                if (_e827[2] < 0.0lf) {
                    phi_1869_ = -(_e827[2]);
                } else {
                    phi_1869_ = _e827[2];
                }
                let _e845 = phi_1869_;
                if (_e841 > _e845) {
                    phi_1874_ = _e841;
                } else {
                    phi_1874_ = _e845;
                }
                let _e848 = phi_1874_;
                let _e851 = local_12.member_1[1u];
                if (_e851[0] < 0.0lf) {
                    phi_1888_ = -(_e851[0]);
                } else {
                    phi_1888_ = _e851[0];
                }
                let _e858 = phi_1888_;
                if (_e851[1] < 0.0lf) {
                    phi_1895_ = -(_e851[1]);
                } else {
                    phi_1895_ = _e851[1];
                }
                let _e862 = phi_1895_;
                if (_e858 > _e862) {
                    phi_1900_ = _e858;
                } else {
                    phi_1900_ = _e862;
                }
                let _e865 = phi_1900_;
                if (_e851[2] < 0.0lf) {
                    phi_1907_ = -(_e851[2]);
                } else {
                    phi_1907_ = _e851[2];
                }
                let _e869 = phi_1907_;
                if (_e865 > _e869) {
                    phi_1912_ = _e865;
                } else {
                    phi_1912_ = _e869;
                }
                let _e872 = phi_1912_;
                if (_e848 > _e872) {
                    phi_1917_ = _e848;
                } else {
                    phi_1917_ = _e872;
                }
                let _e875 = phi_1917_;
                let _e877 = local_12.member_3;
                let _e878 = (_e875 + _e877);
                let _e881 = local_12.member_2[0u];
                if (_e881[0] < 0.0lf) {
                    phi_1934_ = -(_e881[0]);
                } else {
                    phi_1934_ = _e881[0];
                }
                let _e888 = phi_1934_;
                if (_e881[1] < 0.0lf) {
                    phi_1941_ = -(_e881[1]);
                } else {
                    phi_1941_ = _e881[1];
                }
                let _e892 = phi_1941_;
                if (_e888 > _e892) {
                    phi_1946_ = _e888;
                } else {
                    phi_1946_ = _e892;
                }
                let _e895 = phi_1946_;
                if (_e881[2] < 0.0lf) {
                    phi_1953_ = -(_e881[2]);
                } else {
                    phi_1953_ = _e881[2];
                }
                let _e899 = phi_1953_;
                if (_e895 > _e899) {
                    phi_1958_ = _e895;
                } else {
                    phi_1958_ = _e899;
                }
                let _e902 = phi_1958_;
                let _e905 = local_12.member_2[1u];
                if (_e905[0] < 0.0lf) {
                    phi_1972_ = -(_e905[0]);
                } else {
                    phi_1972_ = _e905[0];
                }
                let _e912 = phi_1972_;
                if (_e905[1] < 0.0lf) {
                    phi_1979_ = -(_e905[1]);
                } else {
                    phi_1979_ = _e905[1];
                }
                let _e916 = phi_1979_;
                if (_e912 > _e916) {
                    phi_1984_ = _e912;
                } else {
                    phi_1984_ = _e916;
                }
                let _e919 = phi_1984_;
                if (_e905[2] < 0.0lf) {
                    phi_1991_ = -(_e905[2]);
                } else {
                    phi_1991_ = _e905[2];
                }
                let _e923 = phi_1991_;
                if (_e919 > _e923) {
                    phi_1996_ = _e919;
                } else {
                    phi_1996_ = _e923;
                }
                let _e926 = phi_1996_;
                if (_e902 > _e926) {
                    phi_2001_ = _e902;
                } else {
                    phi_2001_ = _e926;
                }
                let _e929 = phi_2001_;
                let _e931 = local_12.member_3;
                let _e932 = (_e929 + _e931);
                let _e933 = f64(1f);
                let _e934 = f64(8f);
                let _e936 = ((_e878 * _e934) * _e932);
                let _e944 = local_12.member_3;
                if (_e630 < 0.0lf) {
                    phi_2038_ = -(_e630);
                } else {
                    phi_2038_ = _e630;
                }
                let _e964 = phi_2038_;
                if (_e633 < 0.0lf) {
                    phi_2044_ = -(_e633);
                } else {
                    phi_2044_ = _e633;
                }
                let _e968 = phi_2044_;
                if (_e636 < 0.0lf) {
                    phi_2051_ = -(_e636);
                } else {
                    phi_2051_ = _e636;
                }
                let _e973 = phi_2051_;
                let _e974 = ((_e964 + _e968) + _e973);
                if (_e651 < 0.0lf) {
                    phi_2058_ = -(_e651);
                } else {
                    phi_2058_ = _e651;
                }
                let _e978 = phi_2058_;
                if (_e654 < 0.0lf) {
                    phi_2064_ = -(_e654);
                } else {
                    phi_2064_ = _e654;
                }
                let _e982 = phi_2064_;
                if (_e657 < 0.0lf) {
                    phi_2071_ = -(_e657);
                } else {
                    phi_2071_ = _e657;
                }
                let _e987 = phi_2071_;
                let _e988 = ((_e978 + _e982) + _e987);
                if (_e974 > _e988) {
                    phi_2077_ = _e974;
                } else {
                    phi_2077_ = _e988;
                }
                let _e991 = phi_2077_;
                if (_e700 < 0.0lf) {
                    phi_2083_ = -(_e700);
                } else {
                    phi_2083_ = _e700;
                }
                let _e995 = phi_2083_;
                if (_e701 < 0.0lf) {
                    phi_2089_ = -(_e701);
                } else {
                    phi_2089_ = _e701;
                }
                let _e999 = phi_2089_;
                if (_e702 < 0.0lf) {
                    phi_2096_ = -(_e702);
                } else {
                    phi_2096_ = _e702;
                }
                let _e1004 = phi_2096_;
                let _e1006 = (((_e995 + _e999) + _e1004) * f64(0.5f));
                if (_e991 > _e1006) {
                    phi_2103_ = _e991;
                } else {
                    phi_2103_ = _e1006;
                }
                let _e1009 = phi_2103_;
                let _e1015 = local_12.member_3;
                let _e1029 = (((((_e824 * _e934) * _e936) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e944 * f64(19f)) * ((_e824 * (_e878 + _e932)) + (_e878 * _e932)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e933 + _e824) * ((_e933 + _e878) * (_e933 + _e932)))));
                let _e1030 = f64(3f);
                let _e1031 = (_e713 * _e1030);
                let _e1032 = (_e770 * _e1030);
                if (_e1031 < _e1032) {
                    phi_2131_ = _e1031;
                } else {
                    phi_2131_ = _e1032;
                }
                let _e1035 = phi_2131_;
                if (_e736 < _e759) {
                    phi_2136_ = _e736;
                } else {
                    phi_2136_ = _e759;
                }
                let _e1038 = phi_2136_;
                if (_e1035 < _e1038) {
                    phi_2141_ = _e1035;
                } else {
                    phi_2141_ = _e1038;
                }
                let _e1041 = phi_2141_;
                if (_e1031 > _e1032) {
                    phi_2146_ = _e1031;
                } else {
                    phi_2146_ = _e1032;
                }
                let _e1044 = phi_2146_;
                if (_e736 > _e759) {
                    phi_2151_ = _e736;
                } else {
                    phi_2151_ = _e759;
                }
                let _e1047 = phi_2151_;
                if (_e1044 > _e1047) {
                    phi_2156_ = _e1044;
                } else {
                    phi_2156_ = _e1047;
                }
                let _e1050 = phi_2156_;
                let _e1056 = -(_e1050);
                if (_e1041 > _e1056) {
                    phi_2167_ = _e1041;
                } else {
                    phi_2167_ = _e1056;
                }
                let _e1059 = phi_2167_;
                if ((_e1059 - (_e1029 + ((_e575.member_1 * (((_e1009 + (_e936 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1015 * f64(6f)) * (_e878 + _e932))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e933 + _e878) * (_e933 + _e932))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8824_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e575.member_1 > f64(0f)) {
                        let _e3712 = f64(1f);
                        let _e3713 = f64(0f);
                        let _e3716 = local_12.member[0u];
                        let _e3722 = local_12.member_1[0u];
                        let _e3728 = local_12.member_2[0u];
                        let _e3740 = local_12.member[1u];
                        let _e3746 = local_12.member_1[1u];
                        let _e3752 = local_12.member_2[1u];
                        let _e3764 = local_12.member[0u];
                        if (_e3764[0] < 0.0lf) {
                            phi_2324_ = -(_e3764[0]);
                        } else {
                            phi_2324_ = _e3764[0];
                        }
                        let _e3771 = phi_2324_;
                        if (_e3764[1] < 0.0lf) {
                            phi_2331_ = -(_e3764[1]);
                        } else {
                            phi_2331_ = _e3764[1];
                        }
                        let _e3775 = phi_2331_;
                        if (_e3771 > _e3775) {
                            phi_2336_ = _e3771;
                        } else {
                            phi_2336_ = _e3775;
                        }
                        let _e3778 = phi_2336_;
                        if (_e3764[2] < 0.0lf) {
                            phi_2343_ = -(_e3764[2]);
                        } else {
                            phi_2343_ = _e3764[2];
                        }
                        let _e3782 = phi_2343_;
                        if (_e3778 > _e3782) {
                            phi_2348_ = _e3778;
                        } else {
                            phi_2348_ = _e3782;
                        }
                        let _e3785 = phi_2348_;
                        let _e3788 = local_12.member[1u];
                        if (_e3788[0] < 0.0lf) {
                            phi_2361_ = -(_e3788[0]);
                        } else {
                            phi_2361_ = _e3788[0];
                        }
                        let _e3795 = phi_2361_;
                        if (_e3788[1] < 0.0lf) {
                            phi_2368_ = -(_e3788[1]);
                        } else {
                            phi_2368_ = _e3788[1];
                        }
                        let _e3799 = phi_2368_;
                        if (_e3795 > _e3799) {
                            phi_2373_ = _e3795;
                        } else {
                            phi_2373_ = _e3799;
                        }
                        let _e3802 = phi_2373_;
                        if (_e3788[2] < 0.0lf) {
                            phi_2380_ = -(_e3788[2]);
                        } else {
                            phi_2380_ = _e3788[2];
                        }
                        let _e3806 = phi_2380_;
                        if (_e3802 > _e3806) {
                            phi_2385_ = _e3802;
                        } else {
                            phi_2385_ = _e3806;
                        }
                        let _e3809 = phi_2385_;
                        if (_e3785 > _e3809) {
                            phi_2390_ = _e3785;
                        } else {
                            phi_2390_ = _e3809;
                        }
                        let _e3812 = phi_2390_;
                        let _e3814 = local_12.member_3;
                        let _e3818 = local_12.member_1[0u];
                        if (_e3818[0] < 0.0lf) {
                            phi_2407_ = -(_e3818[0]);
                        } else {
                            phi_2407_ = _e3818[0];
                        }
                        let _e3825 = phi_2407_;
                        if (_e3818[1] < 0.0lf) {
                            phi_2414_ = -(_e3818[1]);
                        } else {
                            phi_2414_ = _e3818[1];
                        }
                        let _e3829 = phi_2414_;
                        if (_e3825 > _e3829) {
                            phi_2419_ = _e3825;
                        } else {
                            phi_2419_ = _e3829;
                        }
                        let _e3832 = phi_2419_;
                        if (_e3818[2] < 0.0lf) {
                            phi_2426_ = -(_e3818[2]);
                        } else {
                            phi_2426_ = _e3818[2];
                        }
                        let _e3836 = phi_2426_;
                        if (_e3832 > _e3836) {
                            phi_2431_ = _e3832;
                        } else {
                            phi_2431_ = _e3836;
                        }
                        let _e3839 = phi_2431_;
                        let _e3842 = local_12.member_1[1u];
                        if (_e3842[0] < 0.0lf) {
                            phi_2445_ = -(_e3842[0]);
                        } else {
                            phi_2445_ = _e3842[0];
                        }
                        let _e3849 = phi_2445_;
                        if (_e3842[1] < 0.0lf) {
                            phi_2452_ = -(_e3842[1]);
                        } else {
                            phi_2452_ = _e3842[1];
                        }
                        let _e3853 = phi_2452_;
                        if (_e3849 > _e3853) {
                            phi_2457_ = _e3849;
                        } else {
                            phi_2457_ = _e3853;
                        }
                        let _e3856 = phi_2457_;
                        if (_e3842[2] < 0.0lf) {
                            phi_2464_ = -(_e3842[2]);
                        } else {
                            phi_2464_ = _e3842[2];
                        }
                        let _e3860 = phi_2464_;
                        if (_e3856 > _e3860) {
                            phi_2469_ = _e3856;
                        } else {
                            phi_2469_ = _e3860;
                        }
                        let _e3863 = phi_2469_;
                        if (_e3839 > _e3863) {
                            phi_2474_ = _e3839;
                        } else {
                            phi_2474_ = _e3863;
                        }
                        let _e3866 = phi_2474_;
                        let _e3868 = local_12.member_3;
                        let _e3872 = local_12.member_2[0u];
                        if (_e3872[0] < 0.0lf) {
                            phi_2491_ = -(_e3872[0]);
                        } else {
                            phi_2491_ = _e3872[0];
                        }
                        let _e3879 = phi_2491_;
                        if (_e3872[1] < 0.0lf) {
                            phi_2498_ = -(_e3872[1]);
                        } else {
                            phi_2498_ = _e3872[1];
                        }
                        let _e3883 = phi_2498_;
                        if (_e3879 > _e3883) {
                            phi_2503_ = _e3879;
                        } else {
                            phi_2503_ = _e3883;
                        }
                        let _e3886 = phi_2503_;
                        if (_e3872[2] < 0.0lf) {
                            phi_2510_ = -(_e3872[2]);
                        } else {
                            phi_2510_ = _e3872[2];
                        }
                        let _e3890 = phi_2510_;
                        if (_e3886 > _e3890) {
                            phi_2515_ = _e3886;
                        } else {
                            phi_2515_ = _e3890;
                        }
                        let _e3893 = phi_2515_;
                        let _e3896 = local_12.member_2[1u];
                        if (_e3896[0] < 0.0lf) {
                            phi_2529_ = -(_e3896[0]);
                        } else {
                            phi_2529_ = _e3896[0];
                        }
                        let _e3903 = phi_2529_;
                        if (_e3896[1] < 0.0lf) {
                            phi_2536_ = -(_e3896[1]);
                        } else {
                            phi_2536_ = _e3896[1];
                        }
                        let _e3907 = phi_2536_;
                        if (_e3903 > _e3907) {
                            phi_2541_ = _e3903;
                        } else {
                            phi_2541_ = _e3907;
                        }
                        let _e3910 = phi_2541_;
                        if (_e3896[2] < 0.0lf) {
                            phi_2548_ = -(_e3896[2]);
                        } else {
                            phi_2548_ = _e3896[2];
                        }
                        let _e3914 = phi_2548_;
                        if (_e3910 > _e3914) {
                            phi_2553_ = _e3910;
                        } else {
                            phi_2553_ = _e3914;
                        }
                        let _e3917 = phi_2553_;
                        if (_e3893 > _e3917) {
                            phi_2558_ = _e3893;
                        } else {
                            phi_2558_ = _e3917;
                        }
                        let _e3920 = phi_2558_;
                        let _e3922 = local_12.member_3;
                        let _e3930 = local_12.member_3;
                        let _e3937 = f64(0f);
                        let _e3938 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e3937, _e3937, _e3937, _e3937), array<f64, 4>(_e3937, _e3937, _e3937, _e3937), array<f64, 4>(_e3938, _e3938, _e3938, _e3938));
                        phi_2602_ = type_9(0u, 96u);
                        phi_2605_ = _e3713;
                        phi_2607_ = _e3713;
                        phi_2609_ = _e3713;
                        loop {
                            let _e3944 = phi_2602_;
                            let _e3946 = phi_2605_;
                            let _e3948 = phi_2607_;
                            let _e3950 = phi_2609_;
                            local_44 = _e3948;
                            local_26 = _e3946;
                            if (_e3944.member < _e3944.member_1) {
                                phi_2603_ = type_9((_e3944.member + 1u), _e3944.member_1);
                                phi_2632_ = type_9(1u, _e3944.member);
                            } else {
                                phi_2603_ = _e3944;
                                phi_2632_ = type_9(0u, type_9().member_1);
                            }
                            let _e3962 = phi_2603_;
                            let _e3964 = phi_2632_;
                            if (bitcast<i32>(_e3964.member) != 0i) {
                                let _e3971 = local_12.member[0u];
                                let _e3977 = local_12.member[1u];
                                let _e3993 = local_12.member_1[0u];
                                let _e3999 = local_12.member_1[1u];
                                let _e4015 = local_12.member_2[0u];
                                let _e4021 = local_12.member_2[1u];
                                let _e4035 = function_2(array<f64, 3>((_e3971[0] + ((_e3977[0] - _e3971[0]) * _e3946)), (_e3971[1] + ((_e3977[1] - _e3971[1]) * _e3946)), (_e3971[2] + ((_e3977[2] - _e3971[2]) * _e3946))), array<f64, 3>((_e3993[0] + ((_e3999[0] - _e3993[0]) * _e3946)), (_e3993[1] + ((_e3999[1] - _e3993[1]) * _e3946)), (_e3993[2] + ((_e3999[2] - _e3993[2]) * _e3946))), array<f64, 3>((_e4015[0] + ((_e4021[0] - _e4015[0]) * _e3946)), (_e4015[1] + ((_e4021[1] - _e4015[1]) * _e3946)), (_e4015[2] + ((_e4021[2] - _e4015[2]) * _e3946))), 0u);
                                if (_e4035[0] < 0.0lf) {
                                    phi_2744_ = -(_e4035[0]);
                                } else {
                                    phi_2744_ = _e4035[0];
                                }
                                let _e4040 = phi_2744_;
                                if (_e4035[1] < 0.0lf) {
                                    phi_2751_ = -(_e4035[1]);
                                } else {
                                    phi_2751_ = _e4035[1];
                                }
                                let _e4045 = phi_2751_;
                                if (_e4035[2] < 0.0lf) {
                                    phi_2759_ = -(_e4035[2]);
                                } else {
                                    phi_2759_ = _e4035[2];
                                }
                                let _e4051 = phi_2759_;
                                let _e4052 = ((_e4040 + _e4045) + _e4051);
                                if (_e4052 > f64(0f)) {
                                    if ((bitcast<u64>(_e4052) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4059 = (f64(1f) / _e4052);
                                        let _e4061 = (_e4035[0] * _e4059);
                                        let _e4063 = (_e4035[1] * _e4059);
                                        let _e4065 = (_e4035[2] * _e4059);
                                        let _e4070 = (((_e4061 * _e4061) + (_e4063 * _e4063)) + (_e4065 * _e4065));
                                        if (_e4070 <= 2.2250738585072014e-308lf) {
                                            if (_e4070 > 0.0lf) {
                                                phi_2798_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2798_ = 0.0lf;
                                            }
                                            let _e4122 = phi_2798_;
                                            phi_2862_ = _e4122;
                                        } else {
                                            phi_2805_ = type_16(0i, 5i);
                                            phi_2808_ = bitcast<f64>(((bitcast<u64>(_e4070) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4077 = phi_2805_;
                                                let _e4079 = phi_2808_;
                                                local_24 = _e4079;
                                                if (_e4077.member < _e4077.member_1) {
                                                    let _e4086 = (_e4077.member + 1i);
                                                    if ((false == (_e4086 > _e4077.member)) != false) {
                                                        phi_2829_ = true;
                                                    } else {
                                                        phi_2829_ = false;
                                                    }
                                                    let _e4091 = phi_2829_;
                                                    if _e4091 {
                                                        phi_2835_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2835_ = type_17(1u, _e4086);
                                                    }
                                                    let _e4096 = phi_2835_;
                                                    phi_2806_ = type_16(_e4096.member_1, _e4077.member_1);
                                                    phi_2849_ = type_17(1u, _e4077.member);
                                                } else {
                                                    phi_2806_ = _e4077;
                                                    phi_2849_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4102 = phi_2806_;
                                                let _e4104 = phi_2849_;
                                                let _e4107 = (bitcast<i32>(_e4104.member) != 0i);
                                                if _e4107 {
                                                    phi_2809_ = (0.5lf * (_e4079 + (_e4070 / _e4079)));
                                                } else {
                                                    phi_2809_ = f64();
                                                }
                                                let _e4112 = phi_2809_;
                                                continue;
                                                continuing {
                                                    phi_2805_ = _e4102;
                                                    phi_2808_ = _e4112;
                                                    break if !(_e4107);
                                                }
                                            }
                                            let _e4117 = local_24;
                                            phi_2862_ = (_e4117 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4124 = phi_2862_;
                                        let _e4126 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4133 = ((((((((_e3812 + _e3814) + (_e3866 + _e3868)) + (_e3920 + _e3922)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3930 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e575.member_1 * _e4124) * (f64(1f) + _e4126)));
                                        let _e4138 = (((_e4061 * _e3716[0]) + (_e4063 * _e3716[1])) + (_e4065 * _e3716[2]));
                                        let _e4143 = (((_e4061 * (_e3716[0] - _e3722[0])) + (_e4063 * (_e3716[1] - _e3722[1]))) + (_e4065 * (_e3716[2] - _e3722[2])));
                                        let _e4148 = (((_e4061 * (_e3716[0] - _e3728[0])) + (_e4063 * (_e3716[1] - _e3728[1]))) + (_e4065 * (_e3716[2] - _e3728[2])));
                                        let _e4153 = (((_e4061 * _e3716[0]) + (_e4063 * _e3716[1])) + (_e4065 * _e3716[2]));
                                        let _e4159 = (((_e4061 * _e3740[0]) + (_e4063 * _e3740[1])) + (_e4065 * _e3740[2]));
                                        let _e4164 = (((_e4061 * (_e3740[0] - _e3746[0])) + (_e4063 * (_e3740[1] - _e3746[1]))) + (_e4065 * (_e3740[2] - _e3746[2])));
                                        let _e4169 = (((_e4061 * (_e3740[0] - _e3752[0])) + (_e4063 * (_e3740[1] - _e3752[1]))) + (_e4065 * (_e3740[2] - _e3752[2])));
                                        let _e4174 = (((_e4061 * _e3740[0]) + (_e4063 * _e3740[1])) + (_e4065 * _e3740[2]));
                                        if (_e4138 < 0.0lf) {
                                            phi_2931_ = -(_e4138);
                                        } else {
                                            phi_2931_ = _e4138;
                                        }
                                        let _e4179 = phi_2931_;
                                        if (_e4159 < 0.0lf) {
                                            phi_2937_ = -(_e4159);
                                        } else {
                                            phi_2937_ = _e4159;
                                        }
                                        let _e4183 = phi_2937_;
                                        if (_e4143 < 0.0lf) {
                                            phi_2946_ = -(_e4143);
                                        } else {
                                            phi_2946_ = _e4143;
                                        }
                                        let _e4190 = phi_2946_;
                                        if (_e4164 < 0.0lf) {
                                            phi_2952_ = -(_e4164);
                                        } else {
                                            phi_2952_ = _e4164;
                                        }
                                        let _e4194 = phi_2952_;
                                        if (_e4148 < 0.0lf) {
                                            phi_2961_ = -(_e4148);
                                        } else {
                                            phi_2961_ = _e4148;
                                        }
                                        let _e4201 = phi_2961_;
                                        if (_e4169 < 0.0lf) {
                                            phi_2967_ = -(_e4169);
                                        } else {
                                            phi_2967_ = _e4169;
                                        }
                                        let _e4205 = phi_2967_;
                                        if (_e4153 < 0.0lf) {
                                            phi_2976_ = -(_e4153);
                                        } else {
                                            phi_2976_ = _e4153;
                                        }
                                        let _e4212 = phi_2976_;
                                        if (_e4174 < 0.0lf) {
                                            phi_2982_ = -(_e4174);
                                        } else {
                                            phi_2982_ = _e4174;
                                        }
                                        let _e4216 = phi_2982_;
                                        phi_2988_ = type_34(array<f64, 4>(_e4138, _e4143, _e4148, _e4153), array<f64, 4>(_e4159, _e4164, _e4169, _e4174), array<f64, 4>((_e4133 + ((_e4179 + _e4183) * _e4126)), (_e4133 + ((_e4190 + _e4194) * _e4126)), (_e4133 + ((_e4201 + _e4205) * _e4126)), (_e4133 + ((_e4212 + _e4216) * _e4126))));
                                        phi_2989_ = false;
                                    } else {
                                        phi_2988_ = type_34();
                                        phi_2989_ = true;
                                    }
                                    let _e4223 = phi_2988_;
                                    let _e4225 = phi_2989_;
                                    phi_2990_ = _e4223;
                                    phi_2991_ = _e4225;
                                } else {
                                    phi_2990_ = type_34();
                                    phi_2991_ = true;
                                }
                                let _e4227 = phi_2990_;
                                let _e4229 = phi_2991_;
                                if _e4229 {
                                    let _e4230 = f64(0f);
                                    let _e4231 = f64(1f);
                                    phi_3001_ = type_34(array<f64, 4>(_e4230, _e4230, _e4230, _e4230), array<f64, 4>(_e4230, _e4230, _e4230, _e4230), array<f64, 4>(_e4231, _e4231, _e4231, _e4231));
                                } else {
                                    phi_3001_ = _e4227;
                                }
                                let _e4237 = phi_3001_;
                                local_10 = type_34(array<f64, 4>(_e4237.member[0], _e4237.member[1], _e4237.member[2], _e4237.member[3]), array<f64, 4>(_e4237.member_1[0], _e4237.member_1[1], _e4237.member_1[2], _e4237.member_1[3]), array<f64, 4>(_e4237.member_2[0], _e4237.member_2[1], _e4237.member_2[2], _e4237.member_2[3]));
                                let _e4257 = (_e3946 - _e3950);
                                let _e4258 = f64(0f);
                                let _e4261 = local_10.member[0u];
                                let _e4264 = local_10.member_1[0u];
                                let _e4267 = local_10.member[0u];
                                let _e4273 = local_10.member_2[0u];
                                if (((_e4261 + ((_e4264 - _e4267) * _e3946)) - _e4273) > _e4258) {
                                    let _e4278 = local_10.member[1u];
                                    let _e4281 = local_10.member_1[1u];
                                    let _e4284 = local_10.member[1u];
                                    let _e4290 = local_10.member_2[1u];
                                    if (((_e4278 + ((_e4281 - _e4284) * _e3946)) - _e4290) > _e4258) {
                                        let _e4295 = local_10.member[2u];
                                        let _e4298 = local_10.member_1[2u];
                                        let _e4301 = local_10.member[2u];
                                        let _e4307 = local_10.member_2[2u];
                                        if (((_e4295 + ((_e4298 - _e4301) * _e3946)) - _e4307) > _e4258) {
                                            let _e4312 = local_10.member[3u];
                                            let _e4315 = local_10.member_1[3u];
                                            let _e4318 = local_10.member[3u];
                                            let _e4324 = local_10.member_2[3u];
                                            phi_3172_ = (((_e4312 + ((_e4315 - _e4318) * _e3946)) - _e4324) > _e4258);
                                            phi_3173_ = false;
                                        } else {
                                            phi_3172_ = bool();
                                            phi_3173_ = true;
                                        }
                                        let _e4328 = phi_3172_;
                                        let _e4330 = phi_3173_;
                                        phi_3174_ = _e4328;
                                        phi_3175_ = _e4330;
                                    } else {
                                        phi_3174_ = bool();
                                        phi_3175_ = true;
                                    }
                                    let _e4332 = phi_3174_;
                                    let _e4334 = phi_3175_;
                                    phi_3176_ = _e4332;
                                    phi_3177_ = _e4334;
                                } else {
                                    phi_3176_ = bool();
                                    phi_3177_ = true;
                                }
                                let _e4336 = phi_3176_;
                                let _e4338 = phi_3177_;
                                if _e4338 {
                                    phi_3181_ = false;
                                } else {
                                    phi_3181_ = _e4336;
                                }
                                let _e4340 = phi_3181_;
                                if _e4340 {
                                    if (_e3946 <= _e3948) {
                                        phi_3492_ = true;
                                    } else {
                                        let _e4342 = f64(0f);
                                        let _e4345 = local_9.member[0u];
                                        let _e4348 = local_9.member_1[0u];
                                        let _e4351 = local_9.member[0u];
                                        let _e4357 = local_9.member_2[0u];
                                        let _e4361 = local_10.member[0u];
                                        let _e4364 = local_10.member_1[0u];
                                        let _e4367 = local_10.member[0u];
                                        let _e4373 = local_10.member_2[0u];
                                        if ((((_e4345 + ((_e4348 - _e4351) * _e3946)) - _e4357) + ((_e4361 + ((_e4364 - _e4367) * _e3950)) - _e4373)) > _e4342) {
                                            let _e4379 = local_9.member[1u];
                                            let _e4382 = local_9.member_1[1u];
                                            let _e4385 = local_9.member[1u];
                                            let _e4391 = local_9.member_2[1u];
                                            let _e4395 = local_10.member[1u];
                                            let _e4398 = local_10.member_1[1u];
                                            let _e4401 = local_10.member[1u];
                                            let _e4407 = local_10.member_2[1u];
                                            if ((((_e4379 + ((_e4382 - _e4385) * _e3946)) - _e4391) + ((_e4395 + ((_e4398 - _e4401) * _e3950)) - _e4407)) > _e4342) {
                                                let _e4413 = local_9.member[2u];
                                                let _e4416 = local_9.member_1[2u];
                                                let _e4419 = local_9.member[2u];
                                                let _e4425 = local_9.member_2[2u];
                                                let _e4429 = local_10.member[2u];
                                                let _e4432 = local_10.member_1[2u];
                                                let _e4435 = local_10.member[2u];
                                                let _e4441 = local_10.member_2[2u];
                                                if ((((_e4413 + ((_e4416 - _e4419) * _e3946)) - _e4425) + ((_e4429 + ((_e4432 - _e4435) * _e3950)) - _e4441)) > _e4342) {
                                                    let _e4447 = local_9.member[3u];
                                                    let _e4450 = local_9.member_1[3u];
                                                    let _e4453 = local_9.member[3u];
                                                    let _e4459 = local_9.member_2[3u];
                                                    let _e4463 = local_10.member[3u];
                                                    let _e4466 = local_10.member_1[3u];
                                                    let _e4469 = local_10.member[3u];
                                                    let _e4475 = local_10.member_2[3u];
                                                    phi_3479_ = ((((_e4447 + ((_e4450 - _e4453) * _e3946)) - _e4459) + ((_e4463 + ((_e4466 - _e4469) * _e3950)) - _e4475)) > _e4342);
                                                    phi_3480_ = false;
                                                } else {
                                                    phi_3479_ = bool();
                                                    phi_3480_ = true;
                                                }
                                                let _e4480 = phi_3479_;
                                                let _e4482 = phi_3480_;
                                                phi_3481_ = _e4480;
                                                phi_3482_ = _e4482;
                                            } else {
                                                phi_3481_ = bool();
                                                phi_3482_ = true;
                                            }
                                            let _e4484 = phi_3481_;
                                            let _e4486 = phi_3482_;
                                            phi_3483_ = _e4484;
                                            phi_3484_ = _e4486;
                                        } else {
                                            phi_3483_ = bool();
                                            phi_3484_ = true;
                                        }
                                        let _e4488 = phi_3483_;
                                        let _e4490 = phi_3484_;
                                        if _e4490 {
                                            phi_3488_ = false;
                                        } else {
                                            phi_3488_ = _e4488;
                                        }
                                        let _e4492 = phi_3488_;
                                        phi_3492_ = _e4492;
                                    }
                                    let _e4494 = phi_3492_;
                                    if _e4494 {
                                        if (_e3964.member_1 > 0u) {
                                            if (_e3946 >= _e3712) {
                                                phi_3504_ = false;
                                            } else {
                                                phi_3504_ = true;
                                            }
                                            let _e4498 = phi_3504_;
                                            phi_3505_ = _e4498;
                                        } else {
                                            phi_3505_ = true;
                                        }
                                        let _e4500 = phi_3505_;
                                        if _e4500 {
                                            local_9 = type_34(array<f64, 4>(_e4237.member[0], _e4237.member[1], _e4237.member[2], _e4237.member[3]), array<f64, 4>(_e4237.member_1[0], _e4237.member_1[1], _e4237.member_1[2], _e4237.member_1[3]), array<f64, 4>(_e4237.member_2[0], _e4237.member_2[1], _e4237.member_2[2], _e4237.member_2[3]));
                                            let _e4522 = local_9.member[0u];
                                            let _e4525 = local_9.member_1[0u];
                                            let _e4528 = local_9.member_2[0u];
                                            if (_e4522 > _e4528) {
                                                if (_e4525 > _e4528) {
                                                    phi_3579_ = false;
                                                } else {
                                                    phi_3579_ = true;
                                                }
                                                let _e4532 = phi_3579_;
                                                phi_3580_ = _e4532;
                                            } else {
                                                phi_3580_ = true;
                                            }
                                            let _e4534 = phi_3580_;
                                            if _e4534 {
                                                let _e4535 = (_e4525 >= _e4522);
                                                if _e4535 {
                                                    phi_3605_ = f64();
                                                    phi_3606_ = false;
                                                } else {
                                                    if ((_e4522 - _e4525) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3603_ = (((_e4522 - _e4528) / (_e4522 - _e4525)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3604_ = false;
                                                    } else {
                                                        phi_3603_ = f64();
                                                        phi_3604_ = true;
                                                    }
                                                    let _e4549 = phi_3603_;
                                                    let _e4551 = phi_3604_;
                                                    phi_3605_ = _e4549;
                                                    phi_3606_ = _e4551;
                                                }
                                                let _e4553 = phi_3605_;
                                                let _e4555 = phi_3606_;
                                                phi_3607_ = _e4553;
                                                phi_3608_ = _e4535;
                                                phi_3609_ = _e4555;
                                            } else {
                                                phi_3607_ = f64();
                                                phi_3608_ = true;
                                                phi_3609_ = false;
                                            }
                                            let _e4557 = phi_3607_;
                                            let _e4559 = phi_3608_;
                                            let _e4561 = phi_3609_;
                                            if _e4559 {
                                                phi_3614_ = f64(2f);
                                                phi_3615_ = true;
                                            } else {
                                                phi_3614_ = _e3946;
                                                phi_3615_ = _e4561;
                                            }
                                            let _e4564 = phi_3614_;
                                            let _e4566 = phi_3615_;
                                            if _e4566 {
                                                phi_3619_ = _e4564;
                                            } else {
                                                phi_3619_ = _e4557;
                                            }
                                            let _e4568 = phi_3619_;
                                            let _e4571 = local_9.member[1u];
                                            let _e4574 = local_9.member_1[1u];
                                            let _e4577 = local_9.member_2[1u];
                                            if (_e4571 > _e4577) {
                                                if (_e4574 > _e4577) {
                                                    phi_3651_ = false;
                                                } else {
                                                    phi_3651_ = true;
                                                }
                                                let _e4581 = phi_3651_;
                                                phi_3652_ = _e4581;
                                            } else {
                                                phi_3652_ = true;
                                            }
                                            let _e4583 = phi_3652_;
                                            if _e4583 {
                                                let _e4584 = (_e4574 >= _e4571);
                                                if _e4584 {
                                                    phi_3677_ = f64();
                                                    phi_3678_ = false;
                                                } else {
                                                    if ((_e4571 - _e4574) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3675_ = (((_e4571 - _e4577) / (_e4571 - _e4574)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3676_ = false;
                                                    } else {
                                                        phi_3675_ = f64();
                                                        phi_3676_ = true;
                                                    }
                                                    let _e4598 = phi_3675_;
                                                    let _e4600 = phi_3676_;
                                                    phi_3677_ = _e4598;
                                                    phi_3678_ = _e4600;
                                                }
                                                let _e4602 = phi_3677_;
                                                let _e4604 = phi_3678_;
                                                phi_3679_ = _e4602;
                                                phi_3680_ = _e4584;
                                                phi_3681_ = _e4604;
                                            } else {
                                                phi_3679_ = f64();
                                                phi_3680_ = true;
                                                phi_3681_ = false;
                                            }
                                            let _e4606 = phi_3679_;
                                            let _e4608 = phi_3680_;
                                            let _e4610 = phi_3681_;
                                            if _e4608 {
                                                phi_3686_ = f64(2f);
                                                phi_3687_ = true;
                                            } else {
                                                phi_3686_ = _e3946;
                                                phi_3687_ = _e4610;
                                            }
                                            let _e4613 = phi_3686_;
                                            let _e4615 = phi_3687_;
                                            if _e4615 {
                                                phi_3691_ = _e4613;
                                            } else {
                                                phi_3691_ = _e4606;
                                            }
                                            let _e4617 = phi_3691_;
                                            if (_e4568 < _e4617) {
                                                phi_3696_ = _e4568;
                                            } else {
                                                phi_3696_ = _e4617;
                                            }
                                            let _e4620 = phi_3696_;
                                            let _e4623 = local_9.member[2u];
                                            let _e4626 = local_9.member_1[2u];
                                            let _e4629 = local_9.member_2[2u];
                                            if (_e4623 > _e4629) {
                                                if (_e4626 > _e4629) {
                                                    phi_3728_ = false;
                                                } else {
                                                    phi_3728_ = true;
                                                }
                                                let _e4633 = phi_3728_;
                                                phi_3729_ = _e4633;
                                            } else {
                                                phi_3729_ = true;
                                            }
                                            let _e4635 = phi_3729_;
                                            if _e4635 {
                                                let _e4636 = (_e4626 >= _e4623);
                                                if _e4636 {
                                                    phi_3754_ = f64();
                                                    phi_3755_ = false;
                                                } else {
                                                    if ((_e4623 - _e4626) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3752_ = (((_e4623 - _e4629) / (_e4623 - _e4626)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3753_ = false;
                                                    } else {
                                                        phi_3752_ = f64();
                                                        phi_3753_ = true;
                                                    }
                                                    let _e4650 = phi_3752_;
                                                    let _e4652 = phi_3753_;
                                                    phi_3754_ = _e4650;
                                                    phi_3755_ = _e4652;
                                                }
                                                let _e4654 = phi_3754_;
                                                let _e4656 = phi_3755_;
                                                phi_3756_ = _e4654;
                                                phi_3757_ = _e4636;
                                                phi_3758_ = _e4656;
                                            } else {
                                                phi_3756_ = f64();
                                                phi_3757_ = true;
                                                phi_3758_ = false;
                                            }
                                            let _e4658 = phi_3756_;
                                            let _e4660 = phi_3757_;
                                            let _e4662 = phi_3758_;
                                            if _e4660 {
                                                phi_3763_ = f64(2f);
                                                phi_3764_ = true;
                                            } else {
                                                phi_3763_ = _e3946;
                                                phi_3764_ = _e4662;
                                            }
                                            let _e4665 = phi_3763_;
                                            let _e4667 = phi_3764_;
                                            if _e4667 {
                                                phi_3768_ = _e4665;
                                            } else {
                                                phi_3768_ = _e4658;
                                            }
                                            let _e4669 = phi_3768_;
                                            let _e4672 = local_9.member[3u];
                                            let _e4675 = local_9.member_1[3u];
                                            let _e4678 = local_9.member_2[3u];
                                            if (_e4672 > _e4678) {
                                                if (_e4675 > _e4678) {
                                                    phi_3800_ = false;
                                                } else {
                                                    phi_3800_ = true;
                                                }
                                                let _e4682 = phi_3800_;
                                                phi_3801_ = _e4682;
                                            } else {
                                                phi_3801_ = true;
                                            }
                                            let _e4684 = phi_3801_;
                                            if _e4684 {
                                                let _e4685 = (_e4675 >= _e4672);
                                                if _e4685 {
                                                    phi_3826_ = f64();
                                                    phi_3827_ = false;
                                                } else {
                                                    if ((_e4672 - _e4675) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3824_ = (((_e4672 - _e4678) / (_e4672 - _e4675)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3825_ = false;
                                                    } else {
                                                        phi_3824_ = f64();
                                                        phi_3825_ = true;
                                                    }
                                                    let _e4699 = phi_3824_;
                                                    let _e4701 = phi_3825_;
                                                    phi_3826_ = _e4699;
                                                    phi_3827_ = _e4701;
                                                }
                                                let _e4703 = phi_3826_;
                                                let _e4705 = phi_3827_;
                                                phi_3828_ = _e4703;
                                                phi_3829_ = _e4685;
                                                phi_3830_ = _e4705;
                                            } else {
                                                phi_3828_ = f64();
                                                phi_3829_ = true;
                                                phi_3830_ = false;
                                            }
                                            let _e4707 = phi_3828_;
                                            let _e4709 = phi_3829_;
                                            let _e4711 = phi_3830_;
                                            if _e4709 {
                                                phi_3835_ = f64(2f);
                                                phi_3836_ = true;
                                            } else {
                                                phi_3835_ = _e3946;
                                                phi_3836_ = _e4711;
                                            }
                                            let _e4714 = phi_3835_;
                                            let _e4716 = phi_3836_;
                                            if _e4716 {
                                                phi_3840_ = _e4714;
                                            } else {
                                                phi_3840_ = _e4707;
                                            }
                                            let _e4718 = phi_3840_;
                                            if (_e4669 < _e4718) {
                                                phi_3845_ = _e4669;
                                            } else {
                                                phi_3845_ = _e4718;
                                            }
                                            let _e4721 = phi_3845_;
                                            if (_e4620 < _e4721) {
                                                phi_3850_ = _e4620;
                                            } else {
                                                phi_3850_ = _e4721;
                                            }
                                            let _e4724 = phi_3850_;
                                            if (_e4724 > _e3946) {
                                                phi_3855_ = _e4724;
                                            } else {
                                                phi_3855_ = _e3946;
                                            }
                                            let _e4727 = phi_3855_;
                                            let _e4728 = (_e4727 > _e3712);
                                            if _e4728 {
                                                phi_3867_ = f64();
                                                phi_3868_ = false;
                                            } else {
                                                if (_e3964.member_1 == 0u) {
                                                    phi_3866_ = (_e3712 - _e3946);
                                                } else {
                                                    phi_3866_ = (_e4257 + _e4257);
                                                }
                                                let _e4733 = phi_3866_;
                                                phi_3867_ = _e4733;
                                                phi_3868_ = true;
                                            }
                                            let _e4735 = phi_3867_;
                                            let _e4737 = phi_3868_;
                                            phi_3869_ = _e4727;
                                            phi_3870_ = _e4735;
                                            phi_3871_ = _e4737;
                                            phi_3872_ = _e4728;
                                            phi_3873_ = false;
                                        } else {
                                            phi_3869_ = f64();
                                            phi_3870_ = f64();
                                            phi_3871_ = false;
                                            phi_3872_ = false;
                                            phi_3873_ = true;
                                        }
                                        let _e4739 = phi_3869_;
                                        let _e4741 = phi_3870_;
                                        let _e4743 = phi_3871_;
                                        let _e4745 = phi_3872_;
                                        let _e4747 = phi_3873_;
                                        phi_3874_ = _e4739;
                                        phi_3875_ = _e4741;
                                        phi_3876_ = false;
                                        phi_3877_ = _e4743;
                                        phi_3878_ = _e4745;
                                        phi_3879_ = _e4747;
                                    } else {
                                        phi_3874_ = f64();
                                        phi_3875_ = f64();
                                        phi_3876_ = true;
                                        phi_3877_ = false;
                                        phi_3878_ = false;
                                        phi_3879_ = false;
                                    }
                                    let _e4749 = phi_3874_;
                                    let _e4751 = phi_3875_;
                                    let _e4753 = phi_3876_;
                                    let _e4755 = phi_3877_;
                                    let _e4757 = phi_3878_;
                                    let _e4759 = phi_3879_;
                                    phi_3880_ = _e4749;
                                    phi_3881_ = _e4751;
                                    phi_3882_ = _e4753;
                                    phi_3883_ = _e4755;
                                    phi_3884_ = _e4757;
                                    phi_3885_ = _e4759;
                                } else {
                                    phi_3880_ = f64();
                                    phi_3881_ = f64();
                                    phi_3882_ = true;
                                    phi_3883_ = false;
                                    phi_3884_ = false;
                                    phi_3885_ = false;
                                }
                                let _e4761 = phi_3880_;
                                let _e4763 = phi_3881_;
                                let _e4765 = phi_3882_;
                                let _e4767 = phi_3883_;
                                let _e4769 = phi_3884_;
                                let _e4771 = phi_3885_;
                                if _e4765 {
                                    let _e4772 = (_e3946 <= _e3948);
                                    if _e4772 {
                                        phi_4219_ = f64();
                                        phi_4220_ = false;
                                    } else {
                                        let _e4775 = local_9.member[0u];
                                        let _e4778 = local_9.member_1[0u];
                                        let _e4781 = local_9.member[0u];
                                        let _e4787 = local_9.member_2[0u];
                                        let _e4788 = ((_e4775 + ((_e4778 - _e4781) * _e3950)) - _e4787);
                                        let _e4791 = local_9.member[1u];
                                        let _e4794 = local_9.member_1[1u];
                                        let _e4797 = local_9.member[1u];
                                        let _e4803 = local_9.member_2[1u];
                                        let _e4804 = ((_e4791 + ((_e4794 - _e4797) * _e3950)) - _e4803);
                                        if (_e4788 < _e4804) {
                                            phi_3965_ = _e4788;
                                        } else {
                                            phi_3965_ = _e4804;
                                        }
                                        let _e4807 = phi_3965_;
                                        let _e4810 = local_9.member[2u];
                                        let _e4813 = local_9.member_1[2u];
                                        let _e4816 = local_9.member[2u];
                                        let _e4822 = local_9.member_2[2u];
                                        let _e4823 = ((_e4810 + ((_e4813 - _e4816) * _e3950)) - _e4822);
                                        let _e4826 = local_9.member[3u];
                                        let _e4829 = local_9.member_1[3u];
                                        let _e4832 = local_9.member[3u];
                                        let _e4838 = local_9.member_2[3u];
                                        let _e4839 = ((_e4826 + ((_e4829 - _e4832) * _e3950)) - _e4838);
                                        if (_e4823 < _e4839) {
                                            phi_4038_ = _e4823;
                                        } else {
                                            phi_4038_ = _e4839;
                                        }
                                        let _e4842 = phi_4038_;
                                        if (_e4807 < _e4842) {
                                            phi_4043_ = _e4807;
                                        } else {
                                            phi_4043_ = _e4842;
                                        }
                                        let _e4845 = phi_4043_;
                                        let _e4848 = local_10.member[0u];
                                        let _e4851 = local_10.member_1[0u];
                                        let _e4854 = local_10.member[0u];
                                        let _e4860 = local_10.member_2[0u];
                                        let _e4861 = ((_e4848 + ((_e4851 - _e4854) * _e3946)) - _e4860);
                                        let _e4864 = local_10.member[1u];
                                        let _e4867 = local_10.member_1[1u];
                                        let _e4870 = local_10.member[1u];
                                        let _e4876 = local_10.member_2[1u];
                                        let _e4877 = ((_e4864 + ((_e4867 - _e4870) * _e3946)) - _e4876);
                                        if (_e4861 < _e4877) {
                                            phi_4116_ = _e4861;
                                        } else {
                                            phi_4116_ = _e4877;
                                        }
                                        let _e4880 = phi_4116_;
                                        let _e4883 = local_10.member[2u];
                                        let _e4886 = local_10.member_1[2u];
                                        let _e4889 = local_10.member[2u];
                                        let _e4895 = local_10.member_2[2u];
                                        let _e4896 = ((_e4883 + ((_e4886 - _e4889) * _e3946)) - _e4895);
                                        let _e4899 = local_10.member[3u];
                                        let _e4902 = local_10.member_1[3u];
                                        let _e4905 = local_10.member[3u];
                                        let _e4911 = local_10.member_2[3u];
                                        let _e4912 = ((_e4899 + ((_e4902 - _e4905) * _e3946)) - _e4911);
                                        if (_e4896 < _e4912) {
                                            phi_4189_ = _e4896;
                                        } else {
                                            phi_4189_ = _e4912;
                                        }
                                        let _e4915 = phi_4189_;
                                        if (_e4880 < _e4915) {
                                            phi_4194_ = _e4880;
                                        } else {
                                            phi_4194_ = _e4915;
                                        }
                                        let _e4918 = phi_4194_;
                                        let _e4919 = f64(0.0625f);
                                        let _e4921 = f64(0.9f);
                                        if (_e4918 > f64(0f)) {
                                            phi_4217_ = f64(0.5f);
                                        } else {
                                            let _e4927 = (f64(0.95f) * (_e4845 / (_e4845 - _e4918)));
                                            if (_e4927 > _e4919) {
                                                if (_e4927 < _e4921) {
                                                    phi_4215_ = _e4927;
                                                } else {
                                                    phi_4215_ = _e4921;
                                                }
                                                let _e4931 = phi_4215_;
                                                phi_4216_ = _e4931;
                                            } else {
                                                phi_4216_ = _e4919;
                                            }
                                            let _e4933 = phi_4216_;
                                            phi_4217_ = _e4933;
                                        }
                                        let _e4935 = phi_4217_;
                                        phi_4219_ = (_e4257 * _e4935);
                                        phi_4220_ = true;
                                    }
                                    let _e4938 = phi_4219_;
                                    let _e4940 = phi_4220_;
                                    phi_4221_ = _e3948;
                                    phi_4222_ = _e4938;
                                    phi_4223_ = _e3950;
                                    phi_4224_ = _e4940;
                                    phi_4225_ = _e4772;
                                    phi_4226_ = false;
                                    phi_4227_ = false;
                                } else {
                                    phi_4221_ = _e4761;
                                    phi_4222_ = _e4763;
                                    phi_4223_ = _e3946;
                                    phi_4224_ = _e4767;
                                    phi_4225_ = false;
                                    phi_4226_ = _e4769;
                                    phi_4227_ = _e4771;
                                }
                                let _e4942 = phi_4221_;
                                let _e4944 = phi_4222_;
                                let _e4946 = phi_4223_;
                                let _e4948 = phi_4224_;
                                let _e4950 = phi_4225_;
                                let _e4952 = phi_4226_;
                                let _e4954 = phi_4227_;
                                if _e4948 {
                                    let _e4955 = (_e4946 + _e4944);
                                    if (_e4955 > _e4942) {
                                        phi_4236_ = _e4955;
                                    } else {
                                        phi_4236_ = _e4942;
                                    }
                                    let _e4958 = phi_4236_;
                                    if (_e4958 < _e3712) {
                                        phi_4241_ = _e4958;
                                    } else {
                                        phi_4241_ = _e3712;
                                    }
                                    let _e4961 = phi_4241_;
                                    if (_e3964.member_1 > 0u) {
                                        phi_4252_ = ((_e4961 - _e4946) > f64(0.0000000037252903f));
                                    } else {
                                        phi_4252_ = true;
                                    }
                                    let _e4967 = phi_4252_;
                                    if _e4967 {
                                        phi_4256_ = false;
                                    } else {
                                        phi_4256_ = true;
                                    }
                                    let _e4969 = phi_4256_;
                                    phi_4257_ = _e4961;
                                    phi_4258_ = _e4967;
                                    phi_4259_ = _e4969;
                                    phi_4260_ = false;
                                    phi_4261_ = false;
                                    phi_4262_ = false;
                                } else {
                                    phi_4257_ = f64();
                                    phi_4258_ = false;
                                    phi_4259_ = false;
                                    phi_4260_ = _e4950;
                                    phi_4261_ = _e4952;
                                    phi_4262_ = _e4954;
                                }
                                let _e4971 = phi_4257_;
                                let _e4973 = phi_4258_;
                                let _e4975 = phi_4259_;
                                let _e4977 = phi_4260_;
                                let _e4979 = phi_4261_;
                                let _e4981 = phi_4262_;
                                phi_2606_ = _e4971;
                                phi_2608_ = _e4942;
                                phi_2610_ = _e4946;
                                phi_4263_ = _e4942;
                                phi_4264_ = _e4973;
                                phi_4265_ = _e4975;
                                phi_4266_ = false;
                                phi_4267_ = _e4977;
                                phi_4268_ = _e4979;
                                phi_4269_ = _e4981;
                            } else {
                                phi_2606_ = f64();
                                phi_2608_ = f64();
                                phi_2610_ = f64();
                                phi_4263_ = f64();
                                phi_4264_ = false;
                                phi_4265_ = false;
                                phi_4266_ = true;
                                phi_4267_ = false;
                                phi_4268_ = false;
                                phi_4269_ = false;
                            }
                            let _e4983 = phi_2606_;
                            let _e4985 = phi_2608_;
                            let _e4987 = phi_2610_;
                            let _e4989 = phi_4263_;
                            let _e4991 = phi_4264_;
                            let _e4993 = phi_4265_;
                            let _e4995 = phi_4266_;
                            let _e4997 = phi_4267_;
                            let _e4999 = phi_4268_;
                            let _e5001 = phi_4269_;
                            local_25 = _e4993;
                            local_43 = _e4989;
                            local_45 = _e4995;
                            local_46 = _e4997;
                            local_47 = _e4999;
                            local_48 = _e5001;
                            continue;
                            continuing {
                                phi_2602_ = _e3962;
                                phi_2605_ = _e4983;
                                phi_2607_ = _e4985;
                                phi_2609_ = _e4987;
                                break if !(_e4991);
                            }
                        }
                        let _e5004 = local_25;
                        if _e5004 {
                            let _e6289 = local_43;
                            phi_4273_ = _e6289;
                            phi_4274_ = true;
                            phi_4275_ = false;
                            phi_4276_ = false;
                            phi_4277_ = false;
                        } else {
                            let _e6291 = local_44;
                            phi_4273_ = _e6291;
                            let _e6294 = local_45;
                            phi_4274_ = _e6294;
                            let _e6297 = local_46;
                            phi_4275_ = _e6297;
                            let _e6300 = local_47;
                            phi_4276_ = _e6300;
                            let _e6303 = local_48;
                            phi_4277_ = _e6303;
                        }
                        let _e5006 = phi_4273_;
                        let _e5008 = phi_4274_;
                        let _e5010 = phi_4275_;
                        let _e5012 = phi_4276_;
                        let _e5014 = phi_4277_;
                        if _e5008 {
                            phi_4282_ = type_44(1u, _e5006);
                            phi_4283_ = false;
                            phi_4284_ = false;
                            phi_4285_ = false;
                        } else {
                            phi_4282_ = type_44();
                            phi_4283_ = _e5010;
                            phi_4284_ = _e5012;
                            phi_4285_ = _e5014;
                        }
                        let _e5017 = phi_4282_;
                        let _e5019 = phi_4283_;
                        let _e5021 = phi_4284_;
                        let _e5023 = phi_4285_;
                        if _e5019 {
                            let _e5025 = local_26;
                            phi_4290_ = type_44(1u, _e5025);
                            phi_4291_ = false;
                            phi_4292_ = false;
                        } else {
                            phi_4290_ = type_44();
                            phi_4291_ = _e5021;
                            phi_4292_ = _e5023;
                        }
                        let _e5028 = phi_4290_;
                        let _e5030 = phi_4291_;
                        let _e5032 = phi_4292_;
                        if _e5030 {
                            phi_4297_ = type_44(0u, type_44().member_1);
                            phi_4298_ = false;
                            phi_4299_ = true;
                        } else {
                            phi_4297_ = _e5028;
                            phi_4298_ = _e5032;
                            phi_4299_ = _e5019;
                        }
                        let _e5036 = phi_4297_;
                        let _e5038 = phi_4298_;
                        let _e5040 = phi_4299_;
                        if _e5038 {
                            phi_4304_ = type_44(0u, type_44().member_1);
                            phi_4305_ = true;
                        } else {
                            phi_4304_ = _e5036;
                            phi_4305_ = _e5040;
                        }
                        let _e5044 = phi_4304_;
                        let _e5046 = phi_4305_;
                        if _e5046 {
                            phi_4309_ = _e5044;
                        } else {
                            phi_4309_ = _e5017;
                        }
                        let _e5048 = phi_4309_;
                        if (_e5048.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4323_ = type_9(0u, 3u);
                            loop {
                                let _e5060 = phi_4323_;
                                if (_e5060.member < _e5060.member_1) {
                                    phi_4324_ = type_9((_e5060.member + 1u), _e5060.member_1);
                                    phi_4347_ = type_9(1u, _e5060.member);
                                } else {
                                    phi_4324_ = _e5060;
                                    phi_4347_ = type_9(0u, type_9().member_1);
                                }
                                let _e5072 = phi_4324_;
                                let _e5074 = phi_4347_;
                                if (bitcast<i32>(_e5074.member) != 0i) {
                                    let _e5080 = local_11[_e5074.member_1];
                                    let _e5082 = (_e5048.member_1 + f64(_e5080));
                                    if (_e5082 < _e3712) {
                                        phi_4368_ = _e5082;
                                    } else {
                                        phi_4368_ = _e3712;
                                    }
                                    let _e5085 = phi_4368_;
                                    let _e5088 = local_12.member[0u];
                                    let _e5094 = local_12.member[1u];
                                    let _e5110 = local_12.member_1[0u];
                                    let _e5116 = local_12.member_1[1u];
                                    let _e5132 = local_12.member_2[0u];
                                    let _e5138 = local_12.member_2[1u];
                                    let _e5152 = function_2(array<f64, 3>((_e5088[0] + ((_e5094[0] - _e5088[0]) * _e5085)), (_e5088[1] + ((_e5094[1] - _e5088[1]) * _e5085)), (_e5088[2] + ((_e5094[2] - _e5088[2]) * _e5085))), array<f64, 3>((_e5110[0] + ((_e5116[0] - _e5110[0]) * _e5085)), (_e5110[1] + ((_e5116[1] - _e5110[1]) * _e5085)), (_e5110[2] + ((_e5116[2] - _e5110[2]) * _e5085))), array<f64, 3>((_e5132[0] + ((_e5138[0] - _e5132[0]) * _e5085)), (_e5132[1] + ((_e5138[1] - _e5132[1]) * _e5085)), (_e5132[2] + ((_e5138[2] - _e5132[2]) * _e5085))), 0u);
                                    let _e5163 = (((_e5152[0] * _e5152[0]) + (_e5152[1] * _e5152[1])) + (_e5152[2] * _e5152[2]));
                                    if (_e5163 <= 2.2250738585072014e-308lf) {
                                        if (_e5163 > 0.0lf) {
                                            phi_4491_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_4491_ = 0.0lf;
                                        }
                                        let _e5215 = phi_4491_;
                                        phi_4555_ = _e5215;
                                    } else {
                                        phi_4498_ = type_16(0i, 5i);
                                        phi_4501_ = bitcast<f64>(((bitcast<u64>(_e5163) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5170 = phi_4498_;
                                            let _e5172 = phi_4501_;
                                            local_27 = _e5172;
                                            if (_e5170.member < _e5170.member_1) {
                                                let _e5179 = (_e5170.member + 1i);
                                                if ((false == (_e5179 > _e5170.member)) != false) {
                                                    phi_4522_ = true;
                                                } else {
                                                    phi_4522_ = false;
                                                }
                                                let _e5184 = phi_4522_;
                                                if _e5184 {
                                                    phi_4528_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4528_ = type_17(1u, _e5179);
                                                }
                                                let _e5189 = phi_4528_;
                                                phi_4499_ = type_16(_e5189.member_1, _e5170.member_1);
                                                phi_4542_ = type_17(1u, _e5170.member);
                                            } else {
                                                phi_4499_ = _e5170;
                                                phi_4542_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5195 = phi_4499_;
                                            let _e5197 = phi_4542_;
                                            let _e5200 = (bitcast<i32>(_e5197.member) != 0i);
                                            if _e5200 {
                                                phi_4502_ = (0.5lf * (_e5172 + (_e5163 / _e5172)));
                                            } else {
                                                phi_4502_ = f64();
                                            }
                                            let _e5205 = phi_4502_;
                                            continue;
                                            continuing {
                                                phi_4498_ = _e5195;
                                                phi_4501_ = _e5205;
                                                break if !(_e5200);
                                            }
                                        }
                                        let _e5210 = local_27;
                                        phi_4555_ = (_e5210 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5217 = phi_4555_;
                                    let _e5225 = local_12.member[0u];
                                    if (_e5225[0] < 0.0lf) {
                                        phi_4573_ = -(_e5225[0]);
                                    } else {
                                        phi_4573_ = _e5225[0];
                                    }
                                    let _e5232 = phi_4573_;
                                    if (_e5225[1] < 0.0lf) {
                                        phi_4580_ = -(_e5225[1]);
                                    } else {
                                        phi_4580_ = _e5225[1];
                                    }
                                    let _e5236 = phi_4580_;
                                    if (_e5232 > _e5236) {
                                        phi_4585_ = _e5232;
                                    } else {
                                        phi_4585_ = _e5236;
                                    }
                                    let _e5239 = phi_4585_;
                                    if (_e5225[2] < 0.0lf) {
                                        phi_4592_ = -(_e5225[2]);
                                    } else {
                                        phi_4592_ = _e5225[2];
                                    }
                                    let _e5243 = phi_4592_;
                                    if (_e5239 > _e5243) {
                                        phi_4597_ = _e5239;
                                    } else {
                                        phi_4597_ = _e5243;
                                    }
                                    let _e5246 = phi_4597_;
                                    let _e5249 = local_12.member[1u];
                                    if (_e5249[0] < 0.0lf) {
                                        phi_4610_ = -(_e5249[0]);
                                    } else {
                                        phi_4610_ = _e5249[0];
                                    }
                                    let _e5256 = phi_4610_;
                                    if (_e5249[1] < 0.0lf) {
                                        phi_4617_ = -(_e5249[1]);
                                    } else {
                                        phi_4617_ = _e5249[1];
                                    }
                                    let _e5260 = phi_4617_;
                                    if (_e5256 > _e5260) {
                                        phi_4622_ = _e5256;
                                    } else {
                                        phi_4622_ = _e5260;
                                    }
                                    let _e5263 = phi_4622_;
                                    if (_e5249[2] < 0.0lf) {
                                        phi_4629_ = -(_e5249[2]);
                                    } else {
                                        phi_4629_ = _e5249[2];
                                    }
                                    let _e5267 = phi_4629_;
                                    if (_e5263 > _e5267) {
                                        phi_4634_ = _e5263;
                                    } else {
                                        phi_4634_ = _e5267;
                                    }
                                    let _e5270 = phi_4634_;
                                    if (_e5246 > _e5270) {
                                        phi_4639_ = _e5246;
                                    } else {
                                        phi_4639_ = _e5270;
                                    }
                                    let _e5273 = phi_4639_;
                                    let _e5275 = local_12.member_3;
                                    let _e5279 = local_12.member_1[0u];
                                    if (_e5279[0] < 0.0lf) {
                                        phi_4656_ = -(_e5279[0]);
                                    } else {
                                        phi_4656_ = _e5279[0];
                                    }
                                    let _e5286 = phi_4656_;
                                    if (_e5279[1] < 0.0lf) {
                                        phi_4663_ = -(_e5279[1]);
                                    } else {
                                        phi_4663_ = _e5279[1];
                                    }
                                    let _e5290 = phi_4663_;
                                    if (_e5286 > _e5290) {
                                        phi_4668_ = _e5286;
                                    } else {
                                        phi_4668_ = _e5290;
                                    }
                                    let _e5293 = phi_4668_;
                                    if (_e5279[2] < 0.0lf) {
                                        phi_4675_ = -(_e5279[2]);
                                    } else {
                                        phi_4675_ = _e5279[2];
                                    }
                                    let _e5297 = phi_4675_;
                                    if (_e5293 > _e5297) {
                                        phi_4680_ = _e5293;
                                    } else {
                                        phi_4680_ = _e5297;
                                    }
                                    let _e5300 = phi_4680_;
                                    let _e5303 = local_12.member_1[1u];
                                    if (_e5303[0] < 0.0lf) {
                                        phi_4694_ = -(_e5303[0]);
                                    } else {
                                        phi_4694_ = _e5303[0];
                                    }
                                    let _e5310 = phi_4694_;
                                    if (_e5303[1] < 0.0lf) {
                                        phi_4701_ = -(_e5303[1]);
                                    } else {
                                        phi_4701_ = _e5303[1];
                                    }
                                    let _e5314 = phi_4701_;
                                    if (_e5310 > _e5314) {
                                        phi_4706_ = _e5310;
                                    } else {
                                        phi_4706_ = _e5314;
                                    }
                                    let _e5317 = phi_4706_;
                                    if (_e5303[2] < 0.0lf) {
                                        phi_4713_ = -(_e5303[2]);
                                    } else {
                                        phi_4713_ = _e5303[2];
                                    }
                                    let _e5321 = phi_4713_;
                                    if (_e5317 > _e5321) {
                                        phi_4718_ = _e5317;
                                    } else {
                                        phi_4718_ = _e5321;
                                    }
                                    let _e5324 = phi_4718_;
                                    if (_e5300 > _e5324) {
                                        phi_4723_ = _e5300;
                                    } else {
                                        phi_4723_ = _e5324;
                                    }
                                    let _e5327 = phi_4723_;
                                    let _e5329 = local_12.member_3;
                                    let _e5333 = local_12.member_2[0u];
                                    if (_e5333[0] < 0.0lf) {
                                        phi_4740_ = -(_e5333[0]);
                                    } else {
                                        phi_4740_ = _e5333[0];
                                    }
                                    let _e5340 = phi_4740_;
                                    if (_e5333[1] < 0.0lf) {
                                        phi_4747_ = -(_e5333[1]);
                                    } else {
                                        phi_4747_ = _e5333[1];
                                    }
                                    let _e5344 = phi_4747_;
                                    if (_e5340 > _e5344) {
                                        phi_4752_ = _e5340;
                                    } else {
                                        phi_4752_ = _e5344;
                                    }
                                    let _e5347 = phi_4752_;
                                    if (_e5333[2] < 0.0lf) {
                                        phi_4759_ = -(_e5333[2]);
                                    } else {
                                        phi_4759_ = _e5333[2];
                                    }
                                    let _e5351 = phi_4759_;
                                    if (_e5347 > _e5351) {
                                        phi_4764_ = _e5347;
                                    } else {
                                        phi_4764_ = _e5351;
                                    }
                                    let _e5354 = phi_4764_;
                                    let _e5357 = local_12.member_2[1u];
                                    if (_e5357[0] < 0.0lf) {
                                        phi_4778_ = -(_e5357[0]);
                                    } else {
                                        phi_4778_ = _e5357[0];
                                    }
                                    let _e5364 = phi_4778_;
                                    if (_e5357[1] < 0.0lf) {
                                        phi_4785_ = -(_e5357[1]);
                                    } else {
                                        phi_4785_ = _e5357[1];
                                    }
                                    let _e5368 = phi_4785_;
                                    if (_e5364 > _e5368) {
                                        phi_4790_ = _e5364;
                                    } else {
                                        phi_4790_ = _e5368;
                                    }
                                    let _e5371 = phi_4790_;
                                    if (_e5357[2] < 0.0lf) {
                                        phi_4797_ = -(_e5357[2]);
                                    } else {
                                        phi_4797_ = _e5357[2];
                                    }
                                    let _e5375 = phi_4797_;
                                    if (_e5371 > _e5375) {
                                        phi_4802_ = _e5371;
                                    } else {
                                        phi_4802_ = _e5375;
                                    }
                                    let _e5378 = phi_4802_;
                                    if (_e5354 > _e5378) {
                                        phi_4807_ = _e5354;
                                    } else {
                                        phi_4807_ = _e5378;
                                    }
                                    let _e5381 = phi_4807_;
                                    let _e5383 = local_12.member_3;
                                    let _e5391 = local_12.member_3;
                                    let _e5401 = (((_e5217 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5273 + _e5275) + (_e5327 + _e5329)) + (_e5381 + _e5383)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5391 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e575.member_1);
                                    if _e5401 {
                                        phi_4831_ = false;
                                    } else {
                                        phi_4831_ = true;
                                    }
                                    let _e5403 = phi_4831_;
                                    phi_4832_ = _e5403;
                                    phi_4833_ = _e5401;
                                } else {
                                    phi_4832_ = false;
                                    phi_4833_ = false;
                                }
                                let _e5405 = phi_4832_;
                                let _e5407 = phi_4833_;
                                local_28 = _e5407;
                                continue;
                                continuing {
                                    phi_4323_ = _e5072;
                                    break if !(_e5405);
                                }
                            }
                            let _e5410 = local_28;
                            if _e5410 {
                                phi_4838_ = type_44(1u, _e5048.member_1);
                                phi_4839_ = false;
                            } else {
                                phi_4838_ = type_44();
                                phi_4839_ = true;
                            }
                            let _e5413 = phi_4838_;
                            let _e5415 = phi_4839_;
                            if _e5415 {
                                phi_4844_ = type_44(2u, _e5048.member_1);
                                phi_4845_ = false;
                            } else {
                                phi_4844_ = type_44();
                                phi_4845_ = true;
                            }
                            let _e5418 = phi_4844_;
                            let _e5420 = phi_4845_;
                            phi_4847_ = _e5418;
                            phi_4848_ = _e5413;
                            phi_4849_ = _e5420;
                        } else {
                            phi_4847_ = type_44();
                            phi_4848_ = type_44(0u, type_44().member_1);
                            phi_4849_ = true;
                        }
                        let _e5422 = phi_4847_;
                        let _e5424 = phi_4848_;
                        let _e5426 = phi_4849_;
                        if _e5426 {
                            phi_4853_ = _e5424;
                        } else {
                            phi_4853_ = _e5422;
                        }
                        let _e5428 = phi_4853_;
                        phi_8823_ = _e5428;
                    } else {
                        if (_e713 < 0.0lf) {
                            phi_4864_ = -(_e713);
                        } else {
                            phi_4864_ = _e713;
                        }
                        let _e1070 = phi_4864_;
                        if (_e736 < 0.0lf) {
                            phi_4870_ = -(_e736);
                        } else {
                            phi_4870_ = _e736;
                        }
                        let _e1074 = phi_4870_;
                        if (_e1070 > _e1074) {
                            phi_4875_ = _e1070;
                        } else {
                            phi_4875_ = _e1074;
                        }
                        let _e1077 = phi_4875_;
                        if (_e759 < 0.0lf) {
                            phi_4881_ = -(_e759);
                        } else {
                            phi_4881_ = _e759;
                        }
                        let _e1081 = phi_4881_;
                        if (_e770 < 0.0lf) {
                            phi_4887_ = -(_e770);
                        } else {
                            phi_4887_ = _e770;
                        }
                        let _e1085 = phi_4887_;
                        if (_e1081 > _e1085) {
                            phi_4892_ = _e1081;
                        } else {
                            phi_4892_ = _e1085;
                        }
                        let _e1088 = phi_4892_;
                        if (_e1077 > _e1088) {
                            phi_4897_ = _e1077;
                        } else {
                            phi_4897_ = _e1088;
                        }
                        let _e1091 = phi_4897_;
                        let _e1093 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1094 = f64(1f);
                        if (_e1091 >= _e1093) {
                            phi_4907_ = (_e1091 <= (_e1094 / _e1093));
                        } else {
                            phi_4907_ = false;
                        }
                        let _e1099 = phi_4907_;
                        if _e1099 {
                            phi_4914_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4914_ = f64(2f);
                        }
                        let _e1104 = phi_4914_;
                        let _e1106 = ((_e1029 * f64(0.34f)) + (_e1091 * _e1104));
                        if _e1099 {
                            phi_4922_ = (_e1094 / _e1091);
                        } else {
                            phi_4922_ = f64(0f);
                        }
                        let _e1110 = phi_4922_;
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
                                    phi_4958_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4958_ = 0.0lf;
                                }
                                let _e1181 = phi_4958_;
                                phi_5022_ = _e1181;
                            } else {
                                phi_4965_ = type_16(0i, 5i);
                                phi_4968_ = bitcast<f64>(((bitcast<u64>(_e1128) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1136 = phi_4965_;
                                    let _e1138 = phi_4968_;
                                    local_13 = _e1138;
                                    if (_e1136.member < _e1136.member_1) {
                                        let _e1145 = (_e1136.member + 1i);
                                        if ((false == (_e1145 > _e1136.member)) != false) {
                                            phi_4989_ = true;
                                        } else {
                                            phi_4989_ = false;
                                        }
                                        let _e1150 = phi_4989_;
                                        if _e1150 {
                                            phi_4995_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_4995_ = type_17(1u, _e1145);
                                        }
                                        let _e1155 = phi_4995_;
                                        phi_4966_ = type_16(_e1155.member_1, _e1136.member_1);
                                        phi_5009_ = type_17(1u, _e1136.member);
                                    } else {
                                        phi_4966_ = _e1136;
                                        phi_5009_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1161 = phi_4966_;
                                    let _e1163 = phi_5009_;
                                    let _e1166 = (bitcast<i32>(_e1163.member) != 0i);
                                    if _e1166 {
                                        phi_4969_ = (0.5lf * (_e1138 + (_e1128 / _e1138)));
                                    } else {
                                        phi_4969_ = f64();
                                    }
                                    let _e1171 = phi_4969_;
                                    continue;
                                    continuing {
                                        phi_4965_ = _e1161;
                                        phi_4968_ = _e1171;
                                        break if !(_e1166);
                                    }
                                }
                                let _e1176 = local_13;
                                phi_5022_ = (_e1176 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1183 = phi_5022_;
                            if (_e1120 < _e1111) {
                                phi_5028_ = -(_e1183);
                            } else {
                                phi_5028_ = _e1183;
                            }
                            let _e1187 = phi_5028_;
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
                            phi_5053_ = type_9(0u, 2u);
                            phi_5056_ = 1u;
                            loop {
                                let _e1208 = phi_5053_;
                                let _e1210 = phi_5056_;
                                local_29 = _e1210;
                                if (_e1208.member < _e1208.member_1) {
                                    phi_5054_ = type_9((_e1208.member + 1u), _e1208.member_1);
                                    phi_5079_ = type_9(1u, _e1208.member);
                                } else {
                                    phi_5054_ = _e1208;
                                    phi_5079_ = type_9(0u, type_9().member_1);
                                }
                                let _e1222 = phi_5054_;
                                let _e1224 = phi_5079_;
                                let _e1228 = (bitcast<i32>(_e1224.member) != 0i);
                                if _e1228 {
                                    let _e1230 = local_7[_e1224.member_1];
                                    if (_e1230 > _e1111) {
                                        let _e1233 = local_7[_e1224.member_1];
                                        if (_e1233 < _e1112) {
                                            let _e1236 = local_7[_e1224.member_1];
                                            local_6[_e1210] = _e1236;
                                            phi_5123_ = (_e1210 + 1u);
                                        } else {
                                            phi_5123_ = _e1210;
                                        }
                                        let _e1240 = phi_5123_;
                                        phi_5124_ = _e1240;
                                    } else {
                                        phi_5124_ = _e1210;
                                    }
                                    let _e1242 = phi_5124_;
                                    phi_5057_ = _e1242;
                                } else {
                                    phi_5057_ = u32();
                                }
                                let _e1244 = phi_5057_;
                                continue;
                                continuing {
                                    phi_5053_ = _e1222;
                                    phi_5056_ = _e1244;
                                    break if !(_e1228);
                                }
                            }
                            let _e5654 = local_29;
                            phi_5125_ = _e5654;
                        } else {
                            phi_5125_ = 1u;
                        }
                        let _e1247 = phi_5125_;
                        local_6[_e1247] = _e1112;
                        let _e1249 = local_6;
                        local_8 = _e1249;
                        phi_5145_ = type_9(0u, _e1247);
                        loop {
                            let _e1252 = phi_5145_;
                            if (_e1252.member < _e1252.member_1) {
                                phi_5146_ = type_9((_e1252.member + 1u), _e1252.member_1);
                                phi_5169_ = type_9(1u, _e1252.member);
                            } else {
                                phi_5146_ = _e1252;
                                phi_5169_ = type_9(0u, type_9().member_1);
                            }
                            let _e1264 = phi_5146_;
                            let _e1266 = phi_5169_;
                            if (bitcast<i32>(_e1266.member) != 0i) {
                                let _e1272 = local_8[_e1266.member_1];
                                let _e1275 = local_8[(_e1266.member_1 + 1u)];
                                let _e1277 = (f64(1f) - _e1272);
                                let _e1288 = ((((_e713 * _e1277) + (_e736 * _e1272)) * (_e1277 * _e1277)) + (((_e759 * _e1277) + (_e770 * _e1272)) * (_e1272 * _e1272)));
                                let _e1290 = (f64(1f) - _e1275);
                                let _e1301 = ((((_e713 * _e1290) + (_e736 * _e1275)) * (_e1290 * _e1290)) + (((_e759 * _e1290) + (_e770 * _e1275)) * (_e1275 * _e1275)));
                                if (_e1288 < 0.0lf) {
                                    phi_5223_ = -(_e1288);
                                } else {
                                    phi_5223_ = _e1288;
                                }
                                let _e1305 = phi_5223_;
                                let _e1306 = (_e1305 > _e1106);
                                if (_e1301 < 0.0lf) {
                                    phi_5230_ = -(_e1301);
                                } else {
                                    phi_5230_ = _e1301;
                                }
                                let _e1310 = phi_5230_;
                                let _e1311 = (_e1310 > _e1106);
                                let _e1312 = f64(0f);
                                if _e1306 {
                                    if _e1311 {
                                        phi_5242_ = ((_e1288 > _e1312) != (_e1301 > _e1312));
                                        phi_5243_ = false;
                                    } else {
                                        phi_5242_ = bool();
                                        phi_5243_ = true;
                                    }
                                    let _e1317 = phi_5242_;
                                    let _e1319 = phi_5243_;
                                    phi_5244_ = _e1317;
                                    phi_5245_ = _e1319;
                                } else {
                                    phi_5244_ = bool();
                                    phi_5245_ = true;
                                }
                                let _e1321 = phi_5244_;
                                let _e1323 = phi_5245_;
                                if _e1323 {
                                    phi_5249_ = false;
                                } else {
                                    phi_5249_ = _e1321;
                                }
                                let _e1325 = phi_5249_;
                                if _e1306 {
                                    if _e1311 {
                                        if _e1325 {
                                            phi_5261_ = type_45();
                                        } else {
                                            phi_5261_ = type_45(f64(1f), _e1312, _e1325);
                                        }
                                        let _e1329 = phi_5261_;
                                        phi_5262_ = _e1329;
                                        phi_5263_ = _e1325;
                                    } else {
                                        phi_5262_ = type_45();
                                        phi_5263_ = true;
                                    }
                                    let _e1331 = phi_5262_;
                                    let _e1333 = phi_5263_;
                                    phi_5264_ = _e1331;
                                    phi_5265_ = _e1333;
                                } else {
                                    phi_5264_ = type_45();
                                    phi_5265_ = true;
                                }
                                let _e1335 = phi_5264_;
                                let _e1337 = phi_5265_;
                                if _e1337 {
                                    if _e1306 {
                                        if (_e1288 < _e1312) {
                                            phi_5278_ = f64(-1f);
                                        } else {
                                            phi_5278_ = f64(1f);
                                        }
                                        let _e1342 = phi_5278_;
                                        let _e1343 = f64(0.00000000000022737368f);
                                        let _e1344 = f64(0.5f);
                                        let _e1345 = f64(3f);
                                        let _e1348 = (_e759 - _e736);
                                        phi_5291_ = type_9(0u, 64u);
                                        phi_5294_ = _e1275;
                                        phi_5296_ = _e1272;
                                        phi_5298_ = (_e1344 * (_e1272 + _e1275));
                                        loop {
                                            let _e1354 = phi_5291_;
                                            let _e1356 = phi_5294_;
                                            let _e1358 = phi_5296_;
                                            let _e1360 = phi_5298_;
                                            local_31 = _e1358;
                                            if (_e1354.member < _e1354.member_1) {
                                                phi_5292_ = type_9((_e1354.member + 1u), _e1354.member_1);
                                                phi_5321_ = type_9(1u, _e1354.member);
                                            } else {
                                                phi_5292_ = _e1354;
                                                phi_5321_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1372 = phi_5292_;
                                            let _e1374 = phi_5321_;
                                            if (bitcast<i32>(_e1374.member) != 0i) {
                                                let _e1379 = (f64(1f) - _e1360);
                                                let _e1392 = ((_e1342 * ((((_e713 * _e1379) + (_e736 * _e1360)) * (_e1379 * _e1379)) + (((_e759 * _e1379) + (_e770 * _e1360)) * (_e1360 * _e1360)))) - _e1106);
                                                if (_e1392 > f64(0f)) {
                                                    phi_5348_ = _e1356;
                                                    phi_5349_ = _e1360;
                                                } else {
                                                    phi_5348_ = _e1360;
                                                    phi_5349_ = _e1358;
                                                }
                                                let _e1396 = phi_5348_;
                                                let _e1398 = phi_5349_;
                                                let _e1400 = ((_e1396 - _e1398) > _e1343);
                                                if _e1400 {
                                                    let _e1402 = (f64(1f) - _e1360);
                                                    let _e1414 = (-(_e1392) / (_e1342 * (((((_e736 - (_e1345 * _e713)) * _e1402) + (_e1348 * _e1360)) * _e1402) + (((_e1348 * _e1402) + (((_e1345 * _e770) - _e759) * _e1360)) * _e1360))));
                                                    if (_e1392 > f64(0f)) {
                                                        phi_5377_ = (_e1344 * _e1343);
                                                    } else {
                                                        phi_5377_ = -((_e1344 * _e1343));
                                                    }
                                                    let _e1421 = phi_5377_;
                                                    let _e1423 = ((_e1360 + _e1414) + _e1421);
                                                    if (_e1423 > _e1398) {
                                                        if (_e1423 < _e1396) {
                                                            if (_e1414 < 0.0lf) {
                                                                phi_5393_ = -(_e1414);
                                                            } else {
                                                                phi_5393_ = _e1414;
                                                            }
                                                            let _e1429 = phi_5393_;
                                                            if (_e1429 < (_e1344 * (_e1396 - _e1398))) {
                                                                phi_5400_ = false;
                                                            } else {
                                                                phi_5400_ = true;
                                                            }
                                                            let _e1434 = phi_5400_;
                                                            phi_5401_ = _e1434;
                                                        } else {
                                                            phi_5401_ = true;
                                                        }
                                                        let _e1436 = phi_5401_;
                                                        phi_5402_ = _e1436;
                                                    } else {
                                                        phi_5402_ = true;
                                                    }
                                                    let _e1438 = phi_5402_;
                                                    if _e1438 {
                                                        phi_5408_ = (_e1344 * (_e1398 + _e1396));
                                                    } else {
                                                        phi_5408_ = _e1423;
                                                    }
                                                    let _e1442 = phi_5408_;
                                                    phi_5409_ = _e1442;
                                                    phi_5410_ = false;
                                                } else {
                                                    phi_5409_ = f64();
                                                    phi_5410_ = true;
                                                }
                                                let _e1444 = phi_5409_;
                                                let _e1446 = phi_5410_;
                                                phi_5295_ = _e1396;
                                                phi_5297_ = _e1398;
                                                phi_5299_ = _e1444;
                                                phi_5411_ = _e1398;
                                                phi_5412_ = _e1400;
                                                phi_5413_ = _e1446;
                                            } else {
                                                phi_5295_ = f64();
                                                phi_5297_ = f64();
                                                phi_5299_ = f64();
                                                phi_5411_ = f64();
                                                phi_5412_ = false;
                                                phi_5413_ = false;
                                            }
                                            let _e1448 = phi_5295_;
                                            let _e1450 = phi_5297_;
                                            let _e1452 = phi_5299_;
                                            let _e1454 = phi_5411_;
                                            let _e1456 = phi_5412_;
                                            let _e1458 = phi_5413_;
                                            local_14 = _e1458;
                                            local_30 = _e1454;
                                            continue;
                                            continuing {
                                                phi_5291_ = _e1372;
                                                phi_5294_ = _e1448;
                                                phi_5296_ = _e1450;
                                                phi_5298_ = _e1452;
                                                break if !(_e1456);
                                            }
                                        }
                                        let _e1461 = local_14;
                                        if _e1461 {
                                            let _e5696 = local_30;
                                            phi_5417_ = _e5696;
                                        } else {
                                            let _e5698 = local_31;
                                            phi_5417_ = _e5698;
                                        }
                                        let _e1463 = phi_5417_;
                                        phi_5418_ = _e1463;
                                    } else {
                                        phi_5418_ = _e1272;
                                    }
                                    let _e1465 = phi_5418_;
                                    if _e1311 {
                                        if (_e1301 < _e1312) {
                                            phi_5428_ = f64(-1f);
                                        } else {
                                            phi_5428_ = f64(1f);
                                        }
                                        let _e1470 = phi_5428_;
                                        phi_5433_ = type_9(0u, 64u);
                                        phi_5436_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1474 = phi_5433_;
                                            let _e1476 = phi_5436_;
                                            if (_e1474.member < _e1474.member_1) {
                                                phi_5434_ = type_9((_e1474.member + 1u), _e1474.member_1);
                                                phi_5459_ = type_9(1u, _e1474.member);
                                            } else {
                                                phi_5434_ = _e1474;
                                                phi_5459_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1488 = phi_5434_;
                                            let _e1490 = phi_5459_;
                                            if (bitcast<i32>(_e1490.member) != 0i) {
                                                let _e1494 = (_e1465 + _e1476);
                                                if (_e1494 < _e1275) {
                                                    let _e1497 = (f64(1f) - _e1494);
                                                    let _e1510 = ((_e1470 * ((((_e713 * _e1497) + (_e736 * _e1494)) * (_e1497 * _e1497)) + (((_e759 * _e1497) + (_e770 * _e1494)) * (_e1494 * _e1494)))) > _e1106);
                                                    if _e1510 {
                                                        phi_5490_ = f64();
                                                        phi_5491_ = false;
                                                    } else {
                                                        phi_5490_ = (_e1476 + _e1476);
                                                        phi_5491_ = true;
                                                    }
                                                    let _e1513 = phi_5490_;
                                                    let _e1515 = phi_5491_;
                                                    phi_5492_ = _e1513;
                                                    phi_5493_ = _e1515;
                                                    phi_5494_ = _e1510;
                                                    phi_5495_ = false;
                                                } else {
                                                    phi_5492_ = f64();
                                                    phi_5493_ = false;
                                                    phi_5494_ = false;
                                                    phi_5495_ = true;
                                                }
                                                let _e1517 = phi_5492_;
                                                let _e1519 = phi_5493_;
                                                let _e1521 = phi_5494_;
                                                let _e1523 = phi_5495_;
                                                phi_5496_ = _e1494;
                                                phi_5437_ = _e1517;
                                                phi_5497_ = _e1519;
                                                phi_5498_ = _e1521;
                                                phi_5499_ = _e1523;
                                                phi_5500_ = false;
                                            } else {
                                                phi_5496_ = f64();
                                                phi_5437_ = f64();
                                                phi_5497_ = false;
                                                phi_5498_ = false;
                                                phi_5499_ = false;
                                                phi_5500_ = true;
                                            }
                                            let _e1525 = phi_5496_;
                                            let _e1527 = phi_5437_;
                                            let _e1529 = phi_5497_;
                                            let _e1531 = phi_5498_;
                                            let _e1533 = phi_5499_;
                                            let _e1535 = phi_5500_;
                                            local_15 = _e1531;
                                            local_32 = _e1533;
                                            local_33 = _e1535;
                                            local_34 = _e1525;
                                            continue;
                                            continuing {
                                                phi_5433_ = _e1488;
                                                phi_5436_ = _e1527;
                                                break if !(_e1529);
                                            }
                                        }
                                        let _e1538 = local_15;
                                        if _e1538 {
                                            phi_5504_ = false;
                                            phi_5505_ = false;
                                        } else {
                                            let _e5720 = local_32;
                                            phi_5504_ = _e5720;
                                            let _e5723 = local_33;
                                            phi_5505_ = _e5723;
                                        }
                                        let _e1540 = phi_5504_;
                                        let _e1542 = phi_5505_;
                                        if _e1540 {
                                            phi_5509_ = true;
                                        } else {
                                            phi_5509_ = _e1542;
                                        }
                                        let _e1544 = phi_5509_;
                                        if _e1544 {
                                            phi_5513_ = _e1275;
                                        } else {
                                            let _e5727 = local_34;
                                            phi_5513_ = _e5727;
                                        }
                                        let _e1546 = phi_5513_;
                                        phi_5514_ = _e1546;
                                    } else {
                                        phi_5514_ = _e1275;
                                    }
                                    let _e1548 = phi_5514_;
                                    phi_5516_ = type_45(_e1465, _e1548, _e1325);
                                } else {
                                    phi_5516_ = _e1335;
                                }
                                let _e1551 = phi_5516_;
                                if (_e1551.member > _e1551.member_1) {
                                    phi_8779_ = f64();
                                    phi_8780_ = true;
                                    phi_8781_ = false;
                                    phi_8782_ = false;
                                    phi_8783_ = false;
                                } else {
                                    let _e1559 = ((_e1551.member_1 - _e1551.member) * f64(0.5f));
                                    let _e1560 = (_e1551.member + _e1559);
                                    let _e1563 = (_e1559 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1565 = local_12.member_3;
                                    let _e1568 = local_12.member[0u];
                                    if (_e1568[0] < 0.0lf) {
                                        phi_5547_ = -(_e1568[0]);
                                    } else {
                                        phi_5547_ = _e1568[0];
                                    }
                                    let _e1575 = phi_5547_;
                                    if (_e1568[1] < 0.0lf) {
                                        phi_5554_ = -(_e1568[1]);
                                    } else {
                                        phi_5554_ = _e1568[1];
                                    }
                                    let _e1579 = phi_5554_;
                                    if (_e1575 > _e1579) {
                                        phi_5559_ = _e1575;
                                    } else {
                                        phi_5559_ = _e1579;
                                    }
                                    let _e1582 = phi_5559_;
                                    if (_e1568[2] < 0.0lf) {
                                        phi_5566_ = -(_e1568[2]);
                                    } else {
                                        phi_5566_ = _e1568[2];
                                    }
                                    let _e1586 = phi_5566_;
                                    if (_e1582 > _e1586) {
                                        phi_5571_ = _e1582;
                                    } else {
                                        phi_5571_ = _e1586;
                                    }
                                    let _e1589 = phi_5571_;
                                    let _e1591 = local_12.member[1u];
                                    if (_e1591[0] < 0.0lf) {
                                        phi_5584_ = -(_e1591[0]);
                                    } else {
                                        phi_5584_ = _e1591[0];
                                    }
                                    let _e1598 = phi_5584_;
                                    if (_e1591[1] < 0.0lf) {
                                        phi_5591_ = -(_e1591[1]);
                                    } else {
                                        phi_5591_ = _e1591[1];
                                    }
                                    let _e1602 = phi_5591_;
                                    if (_e1598 > _e1602) {
                                        phi_5596_ = _e1598;
                                    } else {
                                        phi_5596_ = _e1602;
                                    }
                                    let _e1605 = phi_5596_;
                                    if (_e1591[2] < 0.0lf) {
                                        phi_5603_ = -(_e1591[2]);
                                    } else {
                                        phi_5603_ = _e1591[2];
                                    }
                                    let _e1609 = phi_5603_;
                                    if (_e1605 > _e1609) {
                                        phi_5608_ = _e1605;
                                    } else {
                                        phi_5608_ = _e1609;
                                    }
                                    let _e1612 = phi_5608_;
                                    if (_e1589 > _e1612) {
                                        phi_5613_ = _e1589;
                                    } else {
                                        phi_5613_ = _e1612;
                                    }
                                    let _e1615 = phi_5613_;
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
                                        phi_5672_ = -(_e1646);
                                    } else {
                                        phi_5672_ = _e1646;
                                    }
                                    let _e1652 = phi_5672_;
                                    if (_e1647 < 0.0lf) {
                                        phi_5678_ = -(_e1647);
                                    } else {
                                        phi_5678_ = _e1647;
                                    }
                                    let _e1656 = phi_5678_;
                                    if (_e1652 > _e1656) {
                                        phi_5683_ = _e1652;
                                    } else {
                                        phi_5683_ = _e1656;
                                    }
                                    let _e1659 = phi_5683_;
                                    if (_e1648 < 0.0lf) {
                                        phi_5689_ = -(_e1648);
                                    } else {
                                        phi_5689_ = _e1648;
                                    }
                                    let _e1663 = phi_5689_;
                                    if (_e1659 > _e1663) {
                                        phi_5694_ = _e1659;
                                    } else {
                                        phi_5694_ = _e1663;
                                    }
                                    let _e1666 = phi_5694_;
                                    let _e1674 = ((((_e1563 * _e1666) * f64(1.01f)) + ((_e1615 + _e1565) * (1.1102230246251565e-16lf * f64(8f)))) + _e1565);
                                    if (_e1633 < 0.0lf) {
                                        phi_5708_ = -(_e1633);
                                    } else {
                                        phi_5708_ = _e1633;
                                    }
                                    let _e1678 = phi_5708_;
                                    if (_e1634 < 0.0lf) {
                                        phi_5714_ = -(_e1634);
                                    } else {
                                        phi_5714_ = _e1634;
                                    }
                                    let _e1682 = phi_5714_;
                                    if (_e1678 > _e1682) {
                                        phi_5719_ = _e1678;
                                    } else {
                                        phi_5719_ = _e1682;
                                    }
                                    let _e1685 = phi_5719_;
                                    if (_e1635 < 0.0lf) {
                                        phi_5725_ = -(_e1635);
                                    } else {
                                        phi_5725_ = _e1635;
                                    }
                                    let _e1689 = phi_5725_;
                                    if (_e1685 > _e1689) {
                                        phi_5730_ = _e1685;
                                    } else {
                                        phi_5730_ = _e1689;
                                    }
                                    let _e1692 = phi_5730_;
                                    local_2 = type_35(array<f64, 3>(_e1633, _e1634, _e1635), _e1674, (_e1692 + _e1674));
                                    let _e1698 = local_12.member_3;
                                    let _e1700 = local_12.member_1[0u];
                                    if (_e1700[0] < 0.0lf) {
                                        phi_5756_ = -(_e1700[0]);
                                    } else {
                                        phi_5756_ = _e1700[0];
                                    }
                                    let _e1707 = phi_5756_;
                                    if (_e1700[1] < 0.0lf) {
                                        phi_5763_ = -(_e1700[1]);
                                    } else {
                                        phi_5763_ = _e1700[1];
                                    }
                                    let _e1711 = phi_5763_;
                                    if (_e1707 > _e1711) {
                                        phi_5768_ = _e1707;
                                    } else {
                                        phi_5768_ = _e1711;
                                    }
                                    let _e1714 = phi_5768_;
                                    if (_e1700[2] < 0.0lf) {
                                        phi_5775_ = -(_e1700[2]);
                                    } else {
                                        phi_5775_ = _e1700[2];
                                    }
                                    let _e1718 = phi_5775_;
                                    if (_e1714 > _e1718) {
                                        phi_5780_ = _e1714;
                                    } else {
                                        phi_5780_ = _e1718;
                                    }
                                    let _e1721 = phi_5780_;
                                    let _e1723 = local_12.member_1[1u];
                                    if (_e1723[0] < 0.0lf) {
                                        phi_5793_ = -(_e1723[0]);
                                    } else {
                                        phi_5793_ = _e1723[0];
                                    }
                                    let _e1730 = phi_5793_;
                                    if (_e1723[1] < 0.0lf) {
                                        phi_5800_ = -(_e1723[1]);
                                    } else {
                                        phi_5800_ = _e1723[1];
                                    }
                                    let _e1734 = phi_5800_;
                                    if (_e1730 > _e1734) {
                                        phi_5805_ = _e1730;
                                    } else {
                                        phi_5805_ = _e1734;
                                    }
                                    let _e1737 = phi_5805_;
                                    if (_e1723[2] < 0.0lf) {
                                        phi_5812_ = -(_e1723[2]);
                                    } else {
                                        phi_5812_ = _e1723[2];
                                    }
                                    let _e1741 = phi_5812_;
                                    if (_e1737 > _e1741) {
                                        phi_5817_ = _e1737;
                                    } else {
                                        phi_5817_ = _e1741;
                                    }
                                    let _e1744 = phi_5817_;
                                    if (_e1721 > _e1744) {
                                        phi_5822_ = _e1721;
                                    } else {
                                        phi_5822_ = _e1744;
                                    }
                                    let _e1747 = phi_5822_;
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
                                        phi_5881_ = -(_e1778);
                                    } else {
                                        phi_5881_ = _e1778;
                                    }
                                    let _e1784 = phi_5881_;
                                    if (_e1779 < 0.0lf) {
                                        phi_5887_ = -(_e1779);
                                    } else {
                                        phi_5887_ = _e1779;
                                    }
                                    let _e1788 = phi_5887_;
                                    if (_e1784 > _e1788) {
                                        phi_5892_ = _e1784;
                                    } else {
                                        phi_5892_ = _e1788;
                                    }
                                    let _e1791 = phi_5892_;
                                    if (_e1780 < 0.0lf) {
                                        phi_5898_ = -(_e1780);
                                    } else {
                                        phi_5898_ = _e1780;
                                    }
                                    let _e1795 = phi_5898_;
                                    if (_e1791 > _e1795) {
                                        phi_5903_ = _e1791;
                                    } else {
                                        phi_5903_ = _e1795;
                                    }
                                    let _e1798 = phi_5903_;
                                    let _e1806 = ((((_e1563 * _e1798) * f64(1.01f)) + ((_e1747 + _e1698) * (1.1102230246251565e-16lf * f64(8f)))) + _e1698);
                                    if (_e1765 < 0.0lf) {
                                        phi_5917_ = -(_e1765);
                                    } else {
                                        phi_5917_ = _e1765;
                                    }
                                    let _e1810 = phi_5917_;
                                    if (_e1766 < 0.0lf) {
                                        phi_5923_ = -(_e1766);
                                    } else {
                                        phi_5923_ = _e1766;
                                    }
                                    let _e1814 = phi_5923_;
                                    if (_e1810 > _e1814) {
                                        phi_5928_ = _e1810;
                                    } else {
                                        phi_5928_ = _e1814;
                                    }
                                    let _e1817 = phi_5928_;
                                    if (_e1767 < 0.0lf) {
                                        phi_5934_ = -(_e1767);
                                    } else {
                                        phi_5934_ = _e1767;
                                    }
                                    let _e1821 = phi_5934_;
                                    if (_e1817 > _e1821) {
                                        phi_5939_ = _e1817;
                                    } else {
                                        phi_5939_ = _e1821;
                                    }
                                    let _e1824 = phi_5939_;
                                    local_3 = type_35(array<f64, 3>(_e1765, _e1766, _e1767), _e1806, (_e1824 + _e1806));
                                    let _e1830 = local_12.member_3;
                                    let _e1832 = local_12.member_2[0u];
                                    if (_e1832[0] < 0.0lf) {
                                        phi_5965_ = -(_e1832[0]);
                                    } else {
                                        phi_5965_ = _e1832[0];
                                    }
                                    let _e1839 = phi_5965_;
                                    if (_e1832[1] < 0.0lf) {
                                        phi_5972_ = -(_e1832[1]);
                                    } else {
                                        phi_5972_ = _e1832[1];
                                    }
                                    let _e1843 = phi_5972_;
                                    if (_e1839 > _e1843) {
                                        phi_5977_ = _e1839;
                                    } else {
                                        phi_5977_ = _e1843;
                                    }
                                    let _e1846 = phi_5977_;
                                    if (_e1832[2] < 0.0lf) {
                                        phi_5984_ = -(_e1832[2]);
                                    } else {
                                        phi_5984_ = _e1832[2];
                                    }
                                    let _e1850 = phi_5984_;
                                    if (_e1846 > _e1850) {
                                        phi_5989_ = _e1846;
                                    } else {
                                        phi_5989_ = _e1850;
                                    }
                                    let _e1853 = phi_5989_;
                                    let _e1855 = local_12.member_2[1u];
                                    if (_e1855[0] < 0.0lf) {
                                        phi_6002_ = -(_e1855[0]);
                                    } else {
                                        phi_6002_ = _e1855[0];
                                    }
                                    let _e1862 = phi_6002_;
                                    if (_e1855[1] < 0.0lf) {
                                        phi_6009_ = -(_e1855[1]);
                                    } else {
                                        phi_6009_ = _e1855[1];
                                    }
                                    let _e1866 = phi_6009_;
                                    if (_e1862 > _e1866) {
                                        phi_6014_ = _e1862;
                                    } else {
                                        phi_6014_ = _e1866;
                                    }
                                    let _e1869 = phi_6014_;
                                    if (_e1855[2] < 0.0lf) {
                                        phi_6021_ = -(_e1855[2]);
                                    } else {
                                        phi_6021_ = _e1855[2];
                                    }
                                    let _e1873 = phi_6021_;
                                    if (_e1869 > _e1873) {
                                        phi_6026_ = _e1869;
                                    } else {
                                        phi_6026_ = _e1873;
                                    }
                                    let _e1876 = phi_6026_;
                                    if (_e1853 > _e1876) {
                                        phi_6031_ = _e1853;
                                    } else {
                                        phi_6031_ = _e1876;
                                    }
                                    let _e1879 = phi_6031_;
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
                                        phi_6090_ = -(_e1910);
                                    } else {
                                        phi_6090_ = _e1910;
                                    }
                                    let _e1916 = phi_6090_;
                                    if (_e1911 < 0.0lf) {
                                        phi_6096_ = -(_e1911);
                                    } else {
                                        phi_6096_ = _e1911;
                                    }
                                    let _e1920 = phi_6096_;
                                    if (_e1916 > _e1920) {
                                        phi_6101_ = _e1916;
                                    } else {
                                        phi_6101_ = _e1920;
                                    }
                                    let _e1923 = phi_6101_;
                                    if (_e1912 < 0.0lf) {
                                        phi_6107_ = -(_e1912);
                                    } else {
                                        phi_6107_ = _e1912;
                                    }
                                    let _e1927 = phi_6107_;
                                    if (_e1923 > _e1927) {
                                        phi_6112_ = _e1923;
                                    } else {
                                        phi_6112_ = _e1927;
                                    }
                                    let _e1930 = phi_6112_;
                                    let _e1938 = ((((_e1563 * _e1930) * f64(1.01f)) + ((_e1879 + _e1830) * (1.1102230246251565e-16lf * f64(8f)))) + _e1830);
                                    if (_e1897 < 0.0lf) {
                                        phi_6126_ = -(_e1897);
                                    } else {
                                        phi_6126_ = _e1897;
                                    }
                                    let _e1942 = phi_6126_;
                                    if (_e1898 < 0.0lf) {
                                        phi_6132_ = -(_e1898);
                                    } else {
                                        phi_6132_ = _e1898;
                                    }
                                    let _e1946 = phi_6132_;
                                    if (_e1942 > _e1946) {
                                        phi_6137_ = _e1942;
                                    } else {
                                        phi_6137_ = _e1946;
                                    }
                                    let _e1949 = phi_6137_;
                                    if (_e1899 < 0.0lf) {
                                        phi_6143_ = -(_e1899);
                                    } else {
                                        phi_6143_ = _e1899;
                                    }
                                    let _e1953 = phi_6143_;
                                    if (_e1949 > _e1953) {
                                        phi_6148_ = _e1949;
                                    } else {
                                        phi_6148_ = _e1953;
                                    }
                                    let _e1956 = phi_6148_;
                                    local_4 = type_35(array<f64, 3>(_e1897, _e1898, _e1899), _e1938, (_e1956 + _e1938));
                                    let _e1961 = local_3.member;
                                    let _e1966 = local_4.member;
                                    let _e1972 = ((_e1961[1] * _e1966[2]) - (_e1961[2] * _e1966[1]));
                                    let _e1975 = ((_e1961[2] * _e1966[0]) - (_e1961[0] * _e1966[2]));
                                    let _e1978 = ((_e1961[0] * _e1966[1]) - (_e1961[1] * _e1966[0]));
                                    if (_e1972 < 0.0lf) {
                                        phi_6197_ = -(_e1972);
                                    } else {
                                        phi_6197_ = _e1972;
                                    }
                                    let _e1982 = phi_6197_;
                                    if (_e1975 < 0.0lf) {
                                        phi_6203_ = -(_e1975);
                                    } else {
                                        phi_6203_ = _e1975;
                                    }
                                    let _e1986 = phi_6203_;
                                    if (_e1982 > _e1986) {
                                        if (_e1972 < 0.0lf) {
                                            phi_6213_ = -(_e1972);
                                        } else {
                                            phi_6213_ = _e1972;
                                        }
                                        let _e2004 = phi_6213_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6219_ = -(_e1978);
                                        } else {
                                            phi_6219_ = _e1978;
                                        }
                                        let _e2008 = phi_6219_;
                                        if (_e2004 > _e2008) {
                                            phi_6224_ = 2u;
                                            phi_6225_ = 1u;
                                        } else {
                                            phi_6224_ = 1u;
                                            phi_6225_ = 0u;
                                        }
                                        let _e2011 = phi_6224_;
                                        let _e2013 = phi_6225_;
                                        phi_6244_ = _e2011;
                                        phi_6245_ = _e2013;
                                    } else {
                                        if (_e1975 < 0.0lf) {
                                            phi_6231_ = -(_e1975);
                                        } else {
                                            phi_6231_ = _e1975;
                                        }
                                        let _e1991 = phi_6231_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6237_ = -(_e1978);
                                        } else {
                                            phi_6237_ = _e1978;
                                        }
                                        let _e1995 = phi_6237_;
                                        if (_e1991 > _e1995) {
                                            phi_6242_ = 0u;
                                            phi_6243_ = 2u;
                                        } else {
                                            phi_6242_ = 1u;
                                            phi_6243_ = 0u;
                                        }
                                        let _e1998 = phi_6242_;
                                        let _e2000 = phi_6243_;
                                        phi_6244_ = _e1998;
                                        phi_6245_ = _e2000;
                                    }
                                    let _e2015 = phi_6244_;
                                    let _e2017 = phi_6245_;
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
                                        phi_6318_ = -(_e2032);
                                    } else {
                                        phi_6318_ = _e2032;
                                    }
                                    let _e2072 = phi_6318_;
                                    if (_e2072 > _e2068) {
                                        if (_e2032 < f64(0f)) {
                                            phi_6330_ = f64(-1f);
                                        } else {
                                            phi_6330_ = f64(1f);
                                        }
                                        let _e2079 = phi_6330_;
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
                                            phi_6473_ = -(_e2182);
                                        } else {
                                            phi_6473_ = _e2182;
                                        }
                                        let _e2188 = phi_6473_;
                                        if (_e2183 < 0.0lf) {
                                            phi_6479_ = -(_e2183);
                                        } else {
                                            phi_6479_ = _e2183;
                                        }
                                        let _e2192 = phi_6479_;
                                        if (_e2184 < 0.0lf) {
                                            phi_6486_ = -(_e2184);
                                        } else {
                                            phi_6486_ = _e2184;
                                        }
                                        let _e2197 = phi_6486_;
                                        let _e2203 = ((_e2182 - _e2183) - _e2184);
                                        let _e2206 = (((_e2068 + _e2130) + _e2181) + (((_e2188 + _e2192) + _e2197) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5[0u].member = _e2183;
                                        local_5[0u].member_1 = _e2130;
                                        local_5[1u].member = _e2184;
                                        local_5[1u].member_1 = _e2181;
                                        local_5[2u].member = _e2203;
                                        local_5[2u].member_1 = _e2206;
                                        local_5[3u].member = _e2203;
                                        local_5[3u].member_1 = _e2206;
                                        phi_6530_ = type_9(0u, 4u);
                                        phi_6533_ = true;
                                        loop {
                                            let _e2221 = phi_6530_;
                                            let _e2223 = phi_6533_;
                                            local_17 = _e2223;
                                            if (_e2221.member < _e2221.member_1) {
                                                phi_6531_ = type_9((_e2221.member + 1u), _e2221.member_1);
                                                phi_6556_ = type_9(1u, _e2221.member);
                                            } else {
                                                phi_6531_ = _e2221;
                                                phi_6556_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2235 = phi_6531_;
                                            let _e2237 = phi_6556_;
                                            if (bitcast<i32>(_e2237.member) != 0i) {
                                                let _e2244 = local_5[_e2237.member_1].member;
                                                let _e2247 = local_5[_e2237.member_1].member_1;
                                                let _e2249 = (_e2244 < -(_e2247));
                                                if _e2249 {
                                                    phi_6583_ = bool();
                                                    phi_6584_ = false;
                                                } else {
                                                    phi_6583_ = (_e2223 && (_e2244 > _e2247));
                                                    phi_6584_ = true;
                                                }
                                                let _e2253 = phi_6583_;
                                                let _e2255 = phi_6584_;
                                                phi_6534_ = _e2253;
                                                phi_6585_ = _e2255;
                                                phi_6586_ = _e2249;
                                            } else {
                                                phi_6534_ = bool();
                                                phi_6585_ = false;
                                                phi_6586_ = false;
                                            }
                                            let _e2257 = phi_6534_;
                                            let _e2259 = phi_6585_;
                                            let _e2261 = phi_6586_;
                                            local_16 = _e2261;
                                            continue;
                                            continuing {
                                                phi_6530_ = _e2235;
                                                phi_6533_ = _e2257;
                                                break if !(_e2259);
                                            }
                                        }
                                        let _e2264 = local_16;
                                        if _e2264 {
                                            phi_6590_ = false;
                                        } else {
                                            phi_6590_ = true;
                                        }
                                        let _e2266 = phi_6590_;
                                        if _e2266 {
                                            let _e2268 = local_17;
                                            if _e2268 {
                                                phi_6597_ = 1u;
                                            } else {
                                                phi_6597_ = 2u;
                                            }
                                            let _e2270 = phi_6597_;
                                            phi_6598_ = _e2270;
                                            phi_6599_ = false;
                                        } else {
                                            phi_6598_ = u32();
                                            phi_6599_ = true;
                                        }
                                        let _e2272 = phi_6598_;
                                        let _e2274 = phi_6599_;
                                        phi_6600_ = _e2272;
                                        phi_6601_ = 0u;
                                        phi_6602_ = _e2274;
                                    } else {
                                        phi_6600_ = u32();
                                        phi_6601_ = 2u;
                                        phi_6602_ = true;
                                    }
                                    let _e2276 = phi_6600_;
                                    let _e2278 = phi_6601_;
                                    let _e2280 = phi_6602_;
                                    if _e2280 {
                                        phi_6606_ = _e2278;
                                    } else {
                                        phi_6606_ = _e2276;
                                    }
                                    let _e2282 = phi_6606_;
                                    let _e2283 = (_e2282 == 0u);
                                    if _e2283 {
                                        phi_8775_ = f64();
                                        phi_8776_ = false;
                                        phi_8777_ = false;
                                        phi_8778_ = false;
                                    } else {
                                        if (_e2282 == 1u) {
                                            if _e1551.member_2 {
                                                if ((_e1551.member_1 - _e1551.member) <= f64(0.0000005f)) {
                                                    phi_6627_ = false;
                                                } else {
                                                    phi_6627_ = true;
                                                }
                                                let _e2292 = phi_6627_;
                                                phi_6628_ = _e2292;
                                            } else {
                                                phi_6628_ = true;
                                            }
                                            let _e2294 = phi_6628_;
                                            phi_6629_ = _e2294;
                                        } else {
                                            phi_6629_ = true;
                                        }
                                        let _e2296 = phi_6629_;
                                        if _e2296 {
                                            let _e2302 = local_12.member[0u];
                                            let _e2308 = local_12.member_1[0u];
                                            let _e2314 = local_12.member_2[0u];
                                            let _e2326 = local_12.member[1u];
                                            let _e2332 = local_12.member_1[1u];
                                            let _e2338 = local_12.member_2[1u];
                                            let _e2350 = local_12.member[0u];
                                            if (_e2350[0] < 0.0lf) {
                                                phi_6778_ = -(_e2350[0]);
                                            } else {
                                                phi_6778_ = _e2350[0];
                                            }
                                            let _e2357 = phi_6778_;
                                            if (_e2350[1] < 0.0lf) {
                                                phi_6785_ = -(_e2350[1]);
                                            } else {
                                                phi_6785_ = _e2350[1];
                                            }
                                            let _e2361 = phi_6785_;
                                            if (_e2357 > _e2361) {
                                                phi_6790_ = _e2357;
                                            } else {
                                                phi_6790_ = _e2361;
                                            }
                                            let _e2364 = phi_6790_;
                                            if (_e2350[2] < 0.0lf) {
                                                phi_6797_ = -(_e2350[2]);
                                            } else {
                                                phi_6797_ = _e2350[2];
                                            }
                                            let _e2368 = phi_6797_;
                                            if (_e2364 > _e2368) {
                                                phi_6802_ = _e2364;
                                            } else {
                                                phi_6802_ = _e2368;
                                            }
                                            let _e2371 = phi_6802_;
                                            let _e2374 = local_12.member[1u];
                                            if (_e2374[0] < 0.0lf) {
                                                phi_6815_ = -(_e2374[0]);
                                            } else {
                                                phi_6815_ = _e2374[0];
                                            }
                                            let _e2381 = phi_6815_;
                                            if (_e2374[1] < 0.0lf) {
                                                phi_6822_ = -(_e2374[1]);
                                            } else {
                                                phi_6822_ = _e2374[1];
                                            }
                                            let _e2385 = phi_6822_;
                                            if (_e2381 > _e2385) {
                                                phi_6827_ = _e2381;
                                            } else {
                                                phi_6827_ = _e2385;
                                            }
                                            let _e2388 = phi_6827_;
                                            if (_e2374[2] < 0.0lf) {
                                                phi_6834_ = -(_e2374[2]);
                                            } else {
                                                phi_6834_ = _e2374[2];
                                            }
                                            let _e2392 = phi_6834_;
                                            if (_e2388 > _e2392) {
                                                phi_6839_ = _e2388;
                                            } else {
                                                phi_6839_ = _e2392;
                                            }
                                            let _e2395 = phi_6839_;
                                            if (_e2371 > _e2395) {
                                                phi_6844_ = _e2371;
                                            } else {
                                                phi_6844_ = _e2395;
                                            }
                                            let _e2398 = phi_6844_;
                                            let _e2400 = local_12.member_3;
                                            let _e2404 = local_12.member_1[0u];
                                            if (_e2404[0] < 0.0lf) {
                                                phi_6861_ = -(_e2404[0]);
                                            } else {
                                                phi_6861_ = _e2404[0];
                                            }
                                            let _e2411 = phi_6861_;
                                            if (_e2404[1] < 0.0lf) {
                                                phi_6868_ = -(_e2404[1]);
                                            } else {
                                                phi_6868_ = _e2404[1];
                                            }
                                            let _e2415 = phi_6868_;
                                            if (_e2411 > _e2415) {
                                                phi_6873_ = _e2411;
                                            } else {
                                                phi_6873_ = _e2415;
                                            }
                                            let _e2418 = phi_6873_;
                                            if (_e2404[2] < 0.0lf) {
                                                phi_6880_ = -(_e2404[2]);
                                            } else {
                                                phi_6880_ = _e2404[2];
                                            }
                                            let _e2422 = phi_6880_;
                                            if (_e2418 > _e2422) {
                                                phi_6885_ = _e2418;
                                            } else {
                                                phi_6885_ = _e2422;
                                            }
                                            let _e2425 = phi_6885_;
                                            let _e2428 = local_12.member_1[1u];
                                            if (_e2428[0] < 0.0lf) {
                                                phi_6899_ = -(_e2428[0]);
                                            } else {
                                                phi_6899_ = _e2428[0];
                                            }
                                            let _e2435 = phi_6899_;
                                            if (_e2428[1] < 0.0lf) {
                                                phi_6906_ = -(_e2428[1]);
                                            } else {
                                                phi_6906_ = _e2428[1];
                                            }
                                            let _e2439 = phi_6906_;
                                            if (_e2435 > _e2439) {
                                                phi_6911_ = _e2435;
                                            } else {
                                                phi_6911_ = _e2439;
                                            }
                                            let _e2442 = phi_6911_;
                                            if (_e2428[2] < 0.0lf) {
                                                phi_6918_ = -(_e2428[2]);
                                            } else {
                                                phi_6918_ = _e2428[2];
                                            }
                                            let _e2446 = phi_6918_;
                                            if (_e2442 > _e2446) {
                                                phi_6923_ = _e2442;
                                            } else {
                                                phi_6923_ = _e2446;
                                            }
                                            let _e2449 = phi_6923_;
                                            if (_e2425 > _e2449) {
                                                phi_6928_ = _e2425;
                                            } else {
                                                phi_6928_ = _e2449;
                                            }
                                            let _e2452 = phi_6928_;
                                            let _e2454 = local_12.member_3;
                                            let _e2458 = local_12.member_2[0u];
                                            if (_e2458[0] < 0.0lf) {
                                                phi_6945_ = -(_e2458[0]);
                                            } else {
                                                phi_6945_ = _e2458[0];
                                            }
                                            let _e2465 = phi_6945_;
                                            if (_e2458[1] < 0.0lf) {
                                                phi_6952_ = -(_e2458[1]);
                                            } else {
                                                phi_6952_ = _e2458[1];
                                            }
                                            let _e2469 = phi_6952_;
                                            if (_e2465 > _e2469) {
                                                phi_6957_ = _e2465;
                                            } else {
                                                phi_6957_ = _e2469;
                                            }
                                            let _e2472 = phi_6957_;
                                            if (_e2458[2] < 0.0lf) {
                                                phi_6964_ = -(_e2458[2]);
                                            } else {
                                                phi_6964_ = _e2458[2];
                                            }
                                            let _e2476 = phi_6964_;
                                            if (_e2472 > _e2476) {
                                                phi_6969_ = _e2472;
                                            } else {
                                                phi_6969_ = _e2476;
                                            }
                                            let _e2479 = phi_6969_;
                                            let _e2482 = local_12.member_2[1u];
                                            if (_e2482[0] < 0.0lf) {
                                                phi_6983_ = -(_e2482[0]);
                                            } else {
                                                phi_6983_ = _e2482[0];
                                            }
                                            let _e2489 = phi_6983_;
                                            if (_e2482[1] < 0.0lf) {
                                                phi_6990_ = -(_e2482[1]);
                                            } else {
                                                phi_6990_ = _e2482[1];
                                            }
                                            let _e2493 = phi_6990_;
                                            if (_e2489 > _e2493) {
                                                phi_6995_ = _e2489;
                                            } else {
                                                phi_6995_ = _e2493;
                                            }
                                            let _e2496 = phi_6995_;
                                            if (_e2482[2] < 0.0lf) {
                                                phi_7002_ = -(_e2482[2]);
                                            } else {
                                                phi_7002_ = _e2482[2];
                                            }
                                            let _e2500 = phi_7002_;
                                            if (_e2496 > _e2500) {
                                                phi_7007_ = _e2496;
                                            } else {
                                                phi_7007_ = _e2500;
                                            }
                                            let _e2503 = phi_7007_;
                                            if (_e2479 > _e2503) {
                                                phi_7012_ = _e2479;
                                            } else {
                                                phi_7012_ = _e2503;
                                            }
                                            let _e2506 = phi_7012_;
                                            let _e2508 = local_12.member_3;
                                            let _e2516 = local_12.member_3;
                                            let _e2523 = f64(0f);
                                            let _e2524 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2523, _e2523, _e2523, _e2523), array<f64, 4>(_e2523, _e2523, _e2523, _e2523), array<f64, 4>(_e2524, _e2524, _e2524, _e2524));
                                            phi_7056_ = type_9(0u, 96u);
                                            phi_7059_ = _e1551.member;
                                            phi_7061_ = _e1551.member;
                                            phi_7063_ = _e1551.member;
                                            loop {
                                                let _e2530 = phi_7056_;
                                                let _e2532 = phi_7059_;
                                                let _e2534 = phi_7061_;
                                                let _e2536 = phi_7063_;
                                                local_36 = _e2534;
                                                local_20 = _e2532;
                                                if (_e2530.member < _e2530.member_1) {
                                                    phi_7057_ = type_9((_e2530.member + 1u), _e2530.member_1);
                                                    phi_7086_ = type_9(1u, _e2530.member);
                                                } else {
                                                    phi_7057_ = _e2530;
                                                    phi_7086_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2548 = phi_7057_;
                                                let _e2550 = phi_7086_;
                                                if (bitcast<i32>(_e2550.member) != 0i) {
                                                    let _e2557 = local_12.member[0u];
                                                    let _e2563 = local_12.member[1u];
                                                    let _e2579 = local_12.member_1[0u];
                                                    let _e2585 = local_12.member_1[1u];
                                                    let _e2601 = local_12.member_2[0u];
                                                    let _e2607 = local_12.member_2[1u];
                                                    let _e2621 = function_2(array<f64, 3>((_e2557[0] + ((_e2563[0] - _e2557[0]) * _e2532)), (_e2557[1] + ((_e2563[1] - _e2557[1]) * _e2532)), (_e2557[2] + ((_e2563[2] - _e2557[2]) * _e2532))), array<f64, 3>((_e2579[0] + ((_e2585[0] - _e2579[0]) * _e2532)), (_e2579[1] + ((_e2585[1] - _e2579[1]) * _e2532)), (_e2579[2] + ((_e2585[2] - _e2579[2]) * _e2532))), array<f64, 3>((_e2601[0] + ((_e2607[0] - _e2601[0]) * _e2532)), (_e2601[1] + ((_e2607[1] - _e2601[1]) * _e2532)), (_e2601[2] + ((_e2607[2] - _e2601[2]) * _e2532))), 0u);
                                                    if (_e2621[0] < 0.0lf) {
                                                        phi_7198_ = -(_e2621[0]);
                                                    } else {
                                                        phi_7198_ = _e2621[0];
                                                    }
                                                    let _e2626 = phi_7198_;
                                                    if (_e2621[1] < 0.0lf) {
                                                        phi_7205_ = -(_e2621[1]);
                                                    } else {
                                                        phi_7205_ = _e2621[1];
                                                    }
                                                    let _e2631 = phi_7205_;
                                                    if (_e2621[2] < 0.0lf) {
                                                        phi_7213_ = -(_e2621[2]);
                                                    } else {
                                                        phi_7213_ = _e2621[2];
                                                    }
                                                    let _e2637 = phi_7213_;
                                                    let _e2638 = ((_e2626 + _e2631) + _e2637);
                                                    if (_e2638 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2638) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2645 = (f64(1f) / _e2638);
                                                            let _e2647 = (_e2621[0] * _e2645);
                                                            let _e2649 = (_e2621[1] * _e2645);
                                                            let _e2651 = (_e2621[2] * _e2645);
                                                            let _e2656 = (((_e2647 * _e2647) + (_e2649 * _e2649)) + (_e2651 * _e2651));
                                                            if (_e2656 <= 2.2250738585072014e-308lf) {
                                                                if (_e2656 > 0.0lf) {
                                                                    phi_7252_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7252_ = 0.0lf;
                                                                }
                                                                let _e2708 = phi_7252_;
                                                                phi_7316_ = _e2708;
                                                            } else {
                                                                phi_7259_ = type_16(0i, 5i);
                                                                phi_7262_ = bitcast<f64>(((bitcast<u64>(_e2656) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2663 = phi_7259_;
                                                                    let _e2665 = phi_7262_;
                                                                    local_18 = _e2665;
                                                                    if (_e2663.member < _e2663.member_1) {
                                                                        let _e2672 = (_e2663.member + 1i);
                                                                        if ((false == (_e2672 > _e2663.member)) != false) {
                                                                            phi_7283_ = true;
                                                                        } else {
                                                                            phi_7283_ = false;
                                                                        }
                                                                        let _e2677 = phi_7283_;
                                                                        if _e2677 {
                                                                            phi_7289_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_7289_ = type_17(1u, _e2672);
                                                                        }
                                                                        let _e2682 = phi_7289_;
                                                                        phi_7260_ = type_16(_e2682.member_1, _e2663.member_1);
                                                                        phi_7303_ = type_17(1u, _e2663.member);
                                                                    } else {
                                                                        phi_7260_ = _e2663;
                                                                        phi_7303_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2688 = phi_7260_;
                                                                    let _e2690 = phi_7303_;
                                                                    let _e2693 = (bitcast<i32>(_e2690.member) != 0i);
                                                                    if _e2693 {
                                                                        phi_7263_ = (0.5lf * (_e2665 + (_e2656 / _e2665)));
                                                                    } else {
                                                                        phi_7263_ = f64();
                                                                    }
                                                                    let _e2698 = phi_7263_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7259_ = _e2688;
                                                                        phi_7262_ = _e2698;
                                                                        break if !(_e2693);
                                                                    }
                                                                }
                                                                let _e2703 = local_18;
                                                                phi_7316_ = (_e2703 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2710 = phi_7316_;
                                                            let _e2712 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2719 = ((((((((_e2398 + _e2400) + (_e2452 + _e2454)) + (_e2506 + _e2508)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2516 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2710) * (f64(1f) + _e2712)));
                                                            let _e2724 = (((_e2647 * _e2302[0]) + (_e2649 * _e2302[1])) + (_e2651 * _e2302[2]));
                                                            let _e2729 = (((_e2647 * (_e2302[0] - _e2308[0])) + (_e2649 * (_e2302[1] - _e2308[1]))) + (_e2651 * (_e2302[2] - _e2308[2])));
                                                            let _e2734 = (((_e2647 * (_e2302[0] - _e2314[0])) + (_e2649 * (_e2302[1] - _e2314[1]))) + (_e2651 * (_e2302[2] - _e2314[2])));
                                                            let _e2739 = (((_e2647 * _e2302[0]) + (_e2649 * _e2302[1])) + (_e2651 * _e2302[2]));
                                                            let _e2745 = (((_e2647 * _e2326[0]) + (_e2649 * _e2326[1])) + (_e2651 * _e2326[2]));
                                                            let _e2750 = (((_e2647 * (_e2326[0] - _e2332[0])) + (_e2649 * (_e2326[1] - _e2332[1]))) + (_e2651 * (_e2326[2] - _e2332[2])));
                                                            let _e2755 = (((_e2647 * (_e2326[0] - _e2338[0])) + (_e2649 * (_e2326[1] - _e2338[1]))) + (_e2651 * (_e2326[2] - _e2338[2])));
                                                            let _e2760 = (((_e2647 * _e2326[0]) + (_e2649 * _e2326[1])) + (_e2651 * _e2326[2]));
                                                            if (_e2724 < 0.0lf) {
                                                                phi_7385_ = -(_e2724);
                                                            } else {
                                                                phi_7385_ = _e2724;
                                                            }
                                                            let _e2765 = phi_7385_;
                                                            if (_e2745 < 0.0lf) {
                                                                phi_7391_ = -(_e2745);
                                                            } else {
                                                                phi_7391_ = _e2745;
                                                            }
                                                            let _e2769 = phi_7391_;
                                                            if (_e2729 < 0.0lf) {
                                                                phi_7400_ = -(_e2729);
                                                            } else {
                                                                phi_7400_ = _e2729;
                                                            }
                                                            let _e2776 = phi_7400_;
                                                            if (_e2750 < 0.0lf) {
                                                                phi_7406_ = -(_e2750);
                                                            } else {
                                                                phi_7406_ = _e2750;
                                                            }
                                                            let _e2780 = phi_7406_;
                                                            if (_e2734 < 0.0lf) {
                                                                phi_7415_ = -(_e2734);
                                                            } else {
                                                                phi_7415_ = _e2734;
                                                            }
                                                            let _e2787 = phi_7415_;
                                                            if (_e2755 < 0.0lf) {
                                                                phi_7421_ = -(_e2755);
                                                            } else {
                                                                phi_7421_ = _e2755;
                                                            }
                                                            let _e2791 = phi_7421_;
                                                            if (_e2739 < 0.0lf) {
                                                                phi_7430_ = -(_e2739);
                                                            } else {
                                                                phi_7430_ = _e2739;
                                                            }
                                                            let _e2798 = phi_7430_;
                                                            if (_e2760 < 0.0lf) {
                                                                phi_7436_ = -(_e2760);
                                                            } else {
                                                                phi_7436_ = _e2760;
                                                            }
                                                            let _e2802 = phi_7436_;
                                                            phi_7442_ = type_34(array<f64, 4>(_e2724, _e2729, _e2734, _e2739), array<f64, 4>(_e2745, _e2750, _e2755, _e2760), array<f64, 4>((_e2719 + ((_e2765 + _e2769) * _e2712)), (_e2719 + ((_e2776 + _e2780) * _e2712)), (_e2719 + ((_e2787 + _e2791) * _e2712)), (_e2719 + ((_e2798 + _e2802) * _e2712))));
                                                            phi_7443_ = false;
                                                        } else {
                                                            phi_7442_ = type_34();
                                                            phi_7443_ = true;
                                                        }
                                                        let _e2809 = phi_7442_;
                                                        let _e2811 = phi_7443_;
                                                        phi_7444_ = _e2809;
                                                        phi_7445_ = _e2811;
                                                    } else {
                                                        phi_7444_ = type_34();
                                                        phi_7445_ = true;
                                                    }
                                                    let _e2813 = phi_7444_;
                                                    let _e2815 = phi_7445_;
                                                    if _e2815 {
                                                        let _e2816 = f64(0f);
                                                        let _e2817 = f64(1f);
                                                        phi_7455_ = type_34(array<f64, 4>(_e2816, _e2816, _e2816, _e2816), array<f64, 4>(_e2816, _e2816, _e2816, _e2816), array<f64, 4>(_e2817, _e2817, _e2817, _e2817));
                                                    } else {
                                                        phi_7455_ = _e2813;
                                                    }
                                                    let _e2823 = phi_7455_;
                                                    local_1 = type_34(array<f64, 4>(_e2823.member[0], _e2823.member[1], _e2823.member[2], _e2823.member[3]), array<f64, 4>(_e2823.member_1[0], _e2823.member_1[1], _e2823.member_1[2], _e2823.member_1[3]), array<f64, 4>(_e2823.member_2[0], _e2823.member_2[1], _e2823.member_2[2], _e2823.member_2[3]));
                                                    let _e2843 = (_e2532 - _e2536);
                                                    let _e2844 = f64(0f);
                                                    let _e2847 = local_1.member[0u];
                                                    let _e2850 = local_1.member_1[0u];
                                                    let _e2853 = local_1.member[0u];
                                                    let _e2859 = local_1.member_2[0u];
                                                    if (((_e2847 + ((_e2850 - _e2853) * _e2532)) - _e2859) > _e2844) {
                                                        let _e2864 = local_1.member[1u];
                                                        let _e2867 = local_1.member_1[1u];
                                                        let _e2870 = local_1.member[1u];
                                                        let _e2876 = local_1.member_2[1u];
                                                        if (((_e2864 + ((_e2867 - _e2870) * _e2532)) - _e2876) > _e2844) {
                                                            let _e2881 = local_1.member[2u];
                                                            let _e2884 = local_1.member_1[2u];
                                                            let _e2887 = local_1.member[2u];
                                                            let _e2893 = local_1.member_2[2u];
                                                            if (((_e2881 + ((_e2884 - _e2887) * _e2532)) - _e2893) > _e2844) {
                                                                let _e2898 = local_1.member[3u];
                                                                let _e2901 = local_1.member_1[3u];
                                                                let _e2904 = local_1.member[3u];
                                                                let _e2910 = local_1.member_2[3u];
                                                                phi_7626_ = (((_e2898 + ((_e2901 - _e2904) * _e2532)) - _e2910) > _e2844);
                                                                phi_7627_ = false;
                                                            } else {
                                                                phi_7626_ = bool();
                                                                phi_7627_ = true;
                                                            }
                                                            let _e2914 = phi_7626_;
                                                            let _e2916 = phi_7627_;
                                                            phi_7628_ = _e2914;
                                                            phi_7629_ = _e2916;
                                                        } else {
                                                            phi_7628_ = bool();
                                                            phi_7629_ = true;
                                                        }
                                                        let _e2918 = phi_7628_;
                                                        let _e2920 = phi_7629_;
                                                        phi_7630_ = _e2918;
                                                        phi_7631_ = _e2920;
                                                    } else {
                                                        phi_7630_ = bool();
                                                        phi_7631_ = true;
                                                    }
                                                    let _e2922 = phi_7630_;
                                                    let _e2924 = phi_7631_;
                                                    if _e2924 {
                                                        phi_7635_ = false;
                                                    } else {
                                                        phi_7635_ = _e2922;
                                                    }
                                                    let _e2926 = phi_7635_;
                                                    if _e2926 {
                                                        if (_e2532 <= _e2534) {
                                                            phi_7946_ = true;
                                                        } else {
                                                            let _e2928 = f64(0f);
                                                            let _e2931 = local.member[0u];
                                                            let _e2934 = local.member_1[0u];
                                                            let _e2937 = local.member[0u];
                                                            let _e2943 = local.member_2[0u];
                                                            let _e2947 = local_1.member[0u];
                                                            let _e2950 = local_1.member_1[0u];
                                                            let _e2953 = local_1.member[0u];
                                                            let _e2959 = local_1.member_2[0u];
                                                            if ((((_e2931 + ((_e2934 - _e2937) * _e2532)) - _e2943) + ((_e2947 + ((_e2950 - _e2953) * _e2536)) - _e2959)) > _e2928) {
                                                                let _e2965 = local.member[1u];
                                                                let _e2968 = local.member_1[1u];
                                                                let _e2971 = local.member[1u];
                                                                let _e2977 = local.member_2[1u];
                                                                let _e2981 = local_1.member[1u];
                                                                let _e2984 = local_1.member_1[1u];
                                                                let _e2987 = local_1.member[1u];
                                                                let _e2993 = local_1.member_2[1u];
                                                                if ((((_e2965 + ((_e2968 - _e2971) * _e2532)) - _e2977) + ((_e2981 + ((_e2984 - _e2987) * _e2536)) - _e2993)) > _e2928) {
                                                                    let _e2999 = local.member[2u];
                                                                    let _e3002 = local.member_1[2u];
                                                                    let _e3005 = local.member[2u];
                                                                    let _e3011 = local.member_2[2u];
                                                                    let _e3015 = local_1.member[2u];
                                                                    let _e3018 = local_1.member_1[2u];
                                                                    let _e3021 = local_1.member[2u];
                                                                    let _e3027 = local_1.member_2[2u];
                                                                    if ((((_e2999 + ((_e3002 - _e3005) * _e2532)) - _e3011) + ((_e3015 + ((_e3018 - _e3021) * _e2536)) - _e3027)) > _e2928) {
                                                                        let _e3033 = local.member[3u];
                                                                        let _e3036 = local.member_1[3u];
                                                                        let _e3039 = local.member[3u];
                                                                        let _e3045 = local.member_2[3u];
                                                                        let _e3049 = local_1.member[3u];
                                                                        let _e3052 = local_1.member_1[3u];
                                                                        let _e3055 = local_1.member[3u];
                                                                        let _e3061 = local_1.member_2[3u];
                                                                        phi_7933_ = ((((_e3033 + ((_e3036 - _e3039) * _e2532)) - _e3045) + ((_e3049 + ((_e3052 - _e3055) * _e2536)) - _e3061)) > _e2928);
                                                                        phi_7934_ = false;
                                                                    } else {
                                                                        phi_7933_ = bool();
                                                                        phi_7934_ = true;
                                                                    }
                                                                    let _e3066 = phi_7933_;
                                                                    let _e3068 = phi_7934_;
                                                                    phi_7935_ = _e3066;
                                                                    phi_7936_ = _e3068;
                                                                } else {
                                                                    phi_7935_ = bool();
                                                                    phi_7936_ = true;
                                                                }
                                                                let _e3070 = phi_7935_;
                                                                let _e3072 = phi_7936_;
                                                                phi_7937_ = _e3070;
                                                                phi_7938_ = _e3072;
                                                            } else {
                                                                phi_7937_ = bool();
                                                                phi_7938_ = true;
                                                            }
                                                            let _e3074 = phi_7937_;
                                                            let _e3076 = phi_7938_;
                                                            if _e3076 {
                                                                phi_7942_ = false;
                                                            } else {
                                                                phi_7942_ = _e3074;
                                                            }
                                                            let _e3078 = phi_7942_;
                                                            phi_7946_ = _e3078;
                                                        }
                                                        let _e3080 = phi_7946_;
                                                        if _e3080 {
                                                            if (_e2550.member_1 > 0u) {
                                                                if (_e2532 >= _e1551.member_1) {
                                                                    phi_7958_ = false;
                                                                } else {
                                                                    phi_7958_ = true;
                                                                }
                                                                let _e3084 = phi_7958_;
                                                                phi_7959_ = _e3084;
                                                            } else {
                                                                phi_7959_ = true;
                                                            }
                                                            let _e3086 = phi_7959_;
                                                            if _e3086 {
                                                                local = type_34(array<f64, 4>(_e2823.member[0], _e2823.member[1], _e2823.member[2], _e2823.member[3]), array<f64, 4>(_e2823.member_1[0], _e2823.member_1[1], _e2823.member_1[2], _e2823.member_1[3]), array<f64, 4>(_e2823.member_2[0], _e2823.member_2[1], _e2823.member_2[2], _e2823.member_2[3]));
                                                                let _e3108 = local.member[0u];
                                                                let _e3111 = local.member_1[0u];
                                                                let _e3114 = local.member_2[0u];
                                                                if (_e3108 > _e3114) {
                                                                    if (_e3111 > _e3114) {
                                                                        phi_8033_ = false;
                                                                    } else {
                                                                        phi_8033_ = true;
                                                                    }
                                                                    let _e3118 = phi_8033_;
                                                                    phi_8034_ = _e3118;
                                                                } else {
                                                                    phi_8034_ = true;
                                                                }
                                                                let _e3120 = phi_8034_;
                                                                if _e3120 {
                                                                    let _e3121 = (_e3111 >= _e3108);
                                                                    if _e3121 {
                                                                        phi_8059_ = f64();
                                                                        phi_8060_ = false;
                                                                    } else {
                                                                        if ((_e3108 - _e3111) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8057_ = (((_e3108 - _e3114) / (_e3108 - _e3111)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8058_ = false;
                                                                        } else {
                                                                            phi_8057_ = f64();
                                                                            phi_8058_ = true;
                                                                        }
                                                                        let _e3135 = phi_8057_;
                                                                        let _e3137 = phi_8058_;
                                                                        phi_8059_ = _e3135;
                                                                        phi_8060_ = _e3137;
                                                                    }
                                                                    let _e3139 = phi_8059_;
                                                                    let _e3141 = phi_8060_;
                                                                    phi_8061_ = _e3139;
                                                                    phi_8062_ = _e3121;
                                                                    phi_8063_ = _e3141;
                                                                } else {
                                                                    phi_8061_ = f64();
                                                                    phi_8062_ = true;
                                                                    phi_8063_ = false;
                                                                }
                                                                let _e3143 = phi_8061_;
                                                                let _e3145 = phi_8062_;
                                                                let _e3147 = phi_8063_;
                                                                if _e3145 {
                                                                    phi_8068_ = f64(2f);
                                                                    phi_8069_ = true;
                                                                } else {
                                                                    phi_8068_ = _e2532;
                                                                    phi_8069_ = _e3147;
                                                                }
                                                                let _e3150 = phi_8068_;
                                                                let _e3152 = phi_8069_;
                                                                if _e3152 {
                                                                    phi_8073_ = _e3150;
                                                                } else {
                                                                    phi_8073_ = _e3143;
                                                                }
                                                                let _e3154 = phi_8073_;
                                                                let _e3157 = local.member[1u];
                                                                let _e3160 = local.member_1[1u];
                                                                let _e3163 = local.member_2[1u];
                                                                if (_e3157 > _e3163) {
                                                                    if (_e3160 > _e3163) {
                                                                        phi_8105_ = false;
                                                                    } else {
                                                                        phi_8105_ = true;
                                                                    }
                                                                    let _e3167 = phi_8105_;
                                                                    phi_8106_ = _e3167;
                                                                } else {
                                                                    phi_8106_ = true;
                                                                }
                                                                let _e3169 = phi_8106_;
                                                                if _e3169 {
                                                                    let _e3170 = (_e3160 >= _e3157);
                                                                    if _e3170 {
                                                                        phi_8131_ = f64();
                                                                        phi_8132_ = false;
                                                                    } else {
                                                                        if ((_e3157 - _e3160) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8129_ = (((_e3157 - _e3163) / (_e3157 - _e3160)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8130_ = false;
                                                                        } else {
                                                                            phi_8129_ = f64();
                                                                            phi_8130_ = true;
                                                                        }
                                                                        let _e3184 = phi_8129_;
                                                                        let _e3186 = phi_8130_;
                                                                        phi_8131_ = _e3184;
                                                                        phi_8132_ = _e3186;
                                                                    }
                                                                    let _e3188 = phi_8131_;
                                                                    let _e3190 = phi_8132_;
                                                                    phi_8133_ = _e3188;
                                                                    phi_8134_ = _e3170;
                                                                    phi_8135_ = _e3190;
                                                                } else {
                                                                    phi_8133_ = f64();
                                                                    phi_8134_ = true;
                                                                    phi_8135_ = false;
                                                                }
                                                                let _e3192 = phi_8133_;
                                                                let _e3194 = phi_8134_;
                                                                let _e3196 = phi_8135_;
                                                                if _e3194 {
                                                                    phi_8140_ = f64(2f);
                                                                    phi_8141_ = true;
                                                                } else {
                                                                    phi_8140_ = _e2532;
                                                                    phi_8141_ = _e3196;
                                                                }
                                                                let _e3199 = phi_8140_;
                                                                let _e3201 = phi_8141_;
                                                                if _e3201 {
                                                                    phi_8145_ = _e3199;
                                                                } else {
                                                                    phi_8145_ = _e3192;
                                                                }
                                                                let _e3203 = phi_8145_;
                                                                if (_e3154 < _e3203) {
                                                                    phi_8150_ = _e3154;
                                                                } else {
                                                                    phi_8150_ = _e3203;
                                                                }
                                                                let _e3206 = phi_8150_;
                                                                let _e3209 = local.member[2u];
                                                                let _e3212 = local.member_1[2u];
                                                                let _e3215 = local.member_2[2u];
                                                                if (_e3209 > _e3215) {
                                                                    if (_e3212 > _e3215) {
                                                                        phi_8182_ = false;
                                                                    } else {
                                                                        phi_8182_ = true;
                                                                    }
                                                                    let _e3219 = phi_8182_;
                                                                    phi_8183_ = _e3219;
                                                                } else {
                                                                    phi_8183_ = true;
                                                                }
                                                                let _e3221 = phi_8183_;
                                                                if _e3221 {
                                                                    let _e3222 = (_e3212 >= _e3209);
                                                                    if _e3222 {
                                                                        phi_8208_ = f64();
                                                                        phi_8209_ = false;
                                                                    } else {
                                                                        if ((_e3209 - _e3212) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8206_ = (((_e3209 - _e3215) / (_e3209 - _e3212)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8207_ = false;
                                                                        } else {
                                                                            phi_8206_ = f64();
                                                                            phi_8207_ = true;
                                                                        }
                                                                        let _e3236 = phi_8206_;
                                                                        let _e3238 = phi_8207_;
                                                                        phi_8208_ = _e3236;
                                                                        phi_8209_ = _e3238;
                                                                    }
                                                                    let _e3240 = phi_8208_;
                                                                    let _e3242 = phi_8209_;
                                                                    phi_8210_ = _e3240;
                                                                    phi_8211_ = _e3222;
                                                                    phi_8212_ = _e3242;
                                                                } else {
                                                                    phi_8210_ = f64();
                                                                    phi_8211_ = true;
                                                                    phi_8212_ = false;
                                                                }
                                                                let _e3244 = phi_8210_;
                                                                let _e3246 = phi_8211_;
                                                                let _e3248 = phi_8212_;
                                                                if _e3246 {
                                                                    phi_8217_ = f64(2f);
                                                                    phi_8218_ = true;
                                                                } else {
                                                                    phi_8217_ = _e2532;
                                                                    phi_8218_ = _e3248;
                                                                }
                                                                let _e3251 = phi_8217_;
                                                                let _e3253 = phi_8218_;
                                                                if _e3253 {
                                                                    phi_8222_ = _e3251;
                                                                } else {
                                                                    phi_8222_ = _e3244;
                                                                }
                                                                let _e3255 = phi_8222_;
                                                                let _e3258 = local.member[3u];
                                                                let _e3261 = local.member_1[3u];
                                                                let _e3264 = local.member_2[3u];
                                                                if (_e3258 > _e3264) {
                                                                    if (_e3261 > _e3264) {
                                                                        phi_8254_ = false;
                                                                    } else {
                                                                        phi_8254_ = true;
                                                                    }
                                                                    let _e3268 = phi_8254_;
                                                                    phi_8255_ = _e3268;
                                                                } else {
                                                                    phi_8255_ = true;
                                                                }
                                                                let _e3270 = phi_8255_;
                                                                if _e3270 {
                                                                    let _e3271 = (_e3261 >= _e3258);
                                                                    if _e3271 {
                                                                        phi_8280_ = f64();
                                                                        phi_8281_ = false;
                                                                    } else {
                                                                        if ((_e3258 - _e3261) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8278_ = (((_e3258 - _e3264) / (_e3258 - _e3261)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8279_ = false;
                                                                        } else {
                                                                            phi_8278_ = f64();
                                                                            phi_8279_ = true;
                                                                        }
                                                                        let _e3285 = phi_8278_;
                                                                        let _e3287 = phi_8279_;
                                                                        phi_8280_ = _e3285;
                                                                        phi_8281_ = _e3287;
                                                                    }
                                                                    let _e3289 = phi_8280_;
                                                                    let _e3291 = phi_8281_;
                                                                    phi_8282_ = _e3289;
                                                                    phi_8283_ = _e3271;
                                                                    phi_8284_ = _e3291;
                                                                } else {
                                                                    phi_8282_ = f64();
                                                                    phi_8283_ = true;
                                                                    phi_8284_ = false;
                                                                }
                                                                let _e3293 = phi_8282_;
                                                                let _e3295 = phi_8283_;
                                                                let _e3297 = phi_8284_;
                                                                if _e3295 {
                                                                    phi_8289_ = f64(2f);
                                                                    phi_8290_ = true;
                                                                } else {
                                                                    phi_8289_ = _e2532;
                                                                    phi_8290_ = _e3297;
                                                                }
                                                                let _e3300 = phi_8289_;
                                                                let _e3302 = phi_8290_;
                                                                if _e3302 {
                                                                    phi_8294_ = _e3300;
                                                                } else {
                                                                    phi_8294_ = _e3293;
                                                                }
                                                                let _e3304 = phi_8294_;
                                                                if (_e3255 < _e3304) {
                                                                    phi_8299_ = _e3255;
                                                                } else {
                                                                    phi_8299_ = _e3304;
                                                                }
                                                                let _e3307 = phi_8299_;
                                                                if (_e3206 < _e3307) {
                                                                    phi_8304_ = _e3206;
                                                                } else {
                                                                    phi_8304_ = _e3307;
                                                                }
                                                                let _e3310 = phi_8304_;
                                                                if (_e3310 > _e2532) {
                                                                    phi_8309_ = _e3310;
                                                                } else {
                                                                    phi_8309_ = _e2532;
                                                                }
                                                                let _e3313 = phi_8309_;
                                                                let _e3314 = (_e3313 > _e1551.member_1);
                                                                if _e3314 {
                                                                    phi_8321_ = f64();
                                                                    phi_8322_ = false;
                                                                } else {
                                                                    if (_e2550.member_1 == 0u) {
                                                                        phi_8320_ = (_e1551.member_1 - _e2532);
                                                                    } else {
                                                                        phi_8320_ = (_e2843 + _e2843);
                                                                    }
                                                                    let _e3319 = phi_8320_;
                                                                    phi_8321_ = _e3319;
                                                                    phi_8322_ = true;
                                                                }
                                                                let _e3321 = phi_8321_;
                                                                let _e3323 = phi_8322_;
                                                                phi_8323_ = _e3313;
                                                                phi_8324_ = _e3321;
                                                                phi_8325_ = _e3323;
                                                                phi_8326_ = _e3314;
                                                                phi_8327_ = false;
                                                            } else {
                                                                phi_8323_ = f64();
                                                                phi_8324_ = f64();
                                                                phi_8325_ = false;
                                                                phi_8326_ = false;
                                                                phi_8327_ = true;
                                                            }
                                                            let _e3325 = phi_8323_;
                                                            let _e3327 = phi_8324_;
                                                            let _e3329 = phi_8325_;
                                                            let _e3331 = phi_8326_;
                                                            let _e3333 = phi_8327_;
                                                            phi_8328_ = _e3325;
                                                            phi_8329_ = _e3327;
                                                            phi_8330_ = false;
                                                            phi_8331_ = _e3329;
                                                            phi_8332_ = _e3331;
                                                            phi_8333_ = _e3333;
                                                        } else {
                                                            phi_8328_ = f64();
                                                            phi_8329_ = f64();
                                                            phi_8330_ = true;
                                                            phi_8331_ = false;
                                                            phi_8332_ = false;
                                                            phi_8333_ = false;
                                                        }
                                                        let _e3335 = phi_8328_;
                                                        let _e3337 = phi_8329_;
                                                        let _e3339 = phi_8330_;
                                                        let _e3341 = phi_8331_;
                                                        let _e3343 = phi_8332_;
                                                        let _e3345 = phi_8333_;
                                                        phi_8334_ = _e3335;
                                                        phi_8335_ = _e3337;
                                                        phi_8336_ = _e3339;
                                                        phi_8337_ = _e3341;
                                                        phi_8338_ = _e3343;
                                                        phi_8339_ = _e3345;
                                                    } else {
                                                        phi_8334_ = f64();
                                                        phi_8335_ = f64();
                                                        phi_8336_ = true;
                                                        phi_8337_ = false;
                                                        phi_8338_ = false;
                                                        phi_8339_ = false;
                                                    }
                                                    let _e3347 = phi_8334_;
                                                    let _e3349 = phi_8335_;
                                                    let _e3351 = phi_8336_;
                                                    let _e3353 = phi_8337_;
                                                    let _e3355 = phi_8338_;
                                                    let _e3357 = phi_8339_;
                                                    if _e3351 {
                                                        let _e3358 = (_e2532 <= _e2534);
                                                        if _e3358 {
                                                            phi_8673_ = f64();
                                                            phi_8674_ = false;
                                                        } else {
                                                            let _e3361 = local.member[0u];
                                                            let _e3364 = local.member_1[0u];
                                                            let _e3367 = local.member[0u];
                                                            let _e3373 = local.member_2[0u];
                                                            let _e3374 = ((_e3361 + ((_e3364 - _e3367) * _e2536)) - _e3373);
                                                            let _e3377 = local.member[1u];
                                                            let _e3380 = local.member_1[1u];
                                                            let _e3383 = local.member[1u];
                                                            let _e3389 = local.member_2[1u];
                                                            let _e3390 = ((_e3377 + ((_e3380 - _e3383) * _e2536)) - _e3389);
                                                            if (_e3374 < _e3390) {
                                                                phi_8419_ = _e3374;
                                                            } else {
                                                                phi_8419_ = _e3390;
                                                            }
                                                            let _e3393 = phi_8419_;
                                                            let _e3396 = local.member[2u];
                                                            let _e3399 = local.member_1[2u];
                                                            let _e3402 = local.member[2u];
                                                            let _e3408 = local.member_2[2u];
                                                            let _e3409 = ((_e3396 + ((_e3399 - _e3402) * _e2536)) - _e3408);
                                                            let _e3412 = local.member[3u];
                                                            let _e3415 = local.member_1[3u];
                                                            let _e3418 = local.member[3u];
                                                            let _e3424 = local.member_2[3u];
                                                            let _e3425 = ((_e3412 + ((_e3415 - _e3418) * _e2536)) - _e3424);
                                                            if (_e3409 < _e3425) {
                                                                phi_8492_ = _e3409;
                                                            } else {
                                                                phi_8492_ = _e3425;
                                                            }
                                                            let _e3428 = phi_8492_;
                                                            if (_e3393 < _e3428) {
                                                                phi_8497_ = _e3393;
                                                            } else {
                                                                phi_8497_ = _e3428;
                                                            }
                                                            let _e3431 = phi_8497_;
                                                            let _e3434 = local_1.member[0u];
                                                            let _e3437 = local_1.member_1[0u];
                                                            let _e3440 = local_1.member[0u];
                                                            let _e3446 = local_1.member_2[0u];
                                                            let _e3447 = ((_e3434 + ((_e3437 - _e3440) * _e2532)) - _e3446);
                                                            let _e3450 = local_1.member[1u];
                                                            let _e3453 = local_1.member_1[1u];
                                                            let _e3456 = local_1.member[1u];
                                                            let _e3462 = local_1.member_2[1u];
                                                            let _e3463 = ((_e3450 + ((_e3453 - _e3456) * _e2532)) - _e3462);
                                                            if (_e3447 < _e3463) {
                                                                phi_8570_ = _e3447;
                                                            } else {
                                                                phi_8570_ = _e3463;
                                                            }
                                                            let _e3466 = phi_8570_;
                                                            let _e3469 = local_1.member[2u];
                                                            let _e3472 = local_1.member_1[2u];
                                                            let _e3475 = local_1.member[2u];
                                                            let _e3481 = local_1.member_2[2u];
                                                            let _e3482 = ((_e3469 + ((_e3472 - _e3475) * _e2532)) - _e3481);
                                                            let _e3485 = local_1.member[3u];
                                                            let _e3488 = local_1.member_1[3u];
                                                            let _e3491 = local_1.member[3u];
                                                            let _e3497 = local_1.member_2[3u];
                                                            let _e3498 = ((_e3485 + ((_e3488 - _e3491) * _e2532)) - _e3497);
                                                            if (_e3482 < _e3498) {
                                                                phi_8643_ = _e3482;
                                                            } else {
                                                                phi_8643_ = _e3498;
                                                            }
                                                            let _e3501 = phi_8643_;
                                                            if (_e3466 < _e3501) {
                                                                phi_8648_ = _e3466;
                                                            } else {
                                                                phi_8648_ = _e3501;
                                                            }
                                                            let _e3504 = phi_8648_;
                                                            let _e3505 = f64(0.0625f);
                                                            let _e3507 = f64(0.9f);
                                                            if (_e3504 > f64(0f)) {
                                                                phi_8671_ = f64(0.5f);
                                                            } else {
                                                                let _e3513 = (f64(0.95f) * (_e3431 / (_e3431 - _e3504)));
                                                                if (_e3513 > _e3505) {
                                                                    if (_e3513 < _e3507) {
                                                                        phi_8669_ = _e3513;
                                                                    } else {
                                                                        phi_8669_ = _e3507;
                                                                    }
                                                                    let _e3517 = phi_8669_;
                                                                    phi_8670_ = _e3517;
                                                                } else {
                                                                    phi_8670_ = _e3505;
                                                                }
                                                                let _e3519 = phi_8670_;
                                                                phi_8671_ = _e3519;
                                                            }
                                                            let _e3521 = phi_8671_;
                                                            phi_8673_ = (_e2843 * _e3521);
                                                            phi_8674_ = true;
                                                        }
                                                        let _e3524 = phi_8673_;
                                                        let _e3526 = phi_8674_;
                                                        phi_8675_ = _e2534;
                                                        phi_8676_ = _e3524;
                                                        phi_8677_ = _e2536;
                                                        phi_8678_ = _e3526;
                                                        phi_8679_ = _e3358;
                                                        phi_8680_ = false;
                                                        phi_8681_ = false;
                                                    } else {
                                                        phi_8675_ = _e3347;
                                                        phi_8676_ = _e3349;
                                                        phi_8677_ = _e2532;
                                                        phi_8678_ = _e3353;
                                                        phi_8679_ = false;
                                                        phi_8680_ = _e3355;
                                                        phi_8681_ = _e3357;
                                                    }
                                                    let _e3528 = phi_8675_;
                                                    let _e3530 = phi_8676_;
                                                    let _e3532 = phi_8677_;
                                                    let _e3534 = phi_8678_;
                                                    let _e3536 = phi_8679_;
                                                    let _e3538 = phi_8680_;
                                                    let _e3540 = phi_8681_;
                                                    if _e3534 {
                                                        let _e3541 = (_e3532 + _e3530);
                                                        if (_e3541 > _e3528) {
                                                            phi_8690_ = _e3541;
                                                        } else {
                                                            phi_8690_ = _e3528;
                                                        }
                                                        let _e3544 = phi_8690_;
                                                        if (_e3544 < _e1551.member_1) {
                                                            phi_8695_ = _e3544;
                                                        } else {
                                                            phi_8695_ = _e1551.member_1;
                                                        }
                                                        let _e3547 = phi_8695_;
                                                        if (_e2550.member_1 > 0u) {
                                                            phi_8706_ = ((_e3547 - _e3532) > f64(0.0000000037252903f));
                                                        } else {
                                                            phi_8706_ = true;
                                                        }
                                                        let _e3553 = phi_8706_;
                                                        if _e3553 {
                                                            phi_8710_ = false;
                                                        } else {
                                                            phi_8710_ = true;
                                                        }
                                                        let _e3555 = phi_8710_;
                                                        phi_8711_ = _e3547;
                                                        phi_8712_ = _e3553;
                                                        phi_8713_ = _e3555;
                                                        phi_8714_ = false;
                                                        phi_8715_ = false;
                                                        phi_8716_ = false;
                                                    } else {
                                                        phi_8711_ = f64();
                                                        phi_8712_ = false;
                                                        phi_8713_ = false;
                                                        phi_8714_ = _e3536;
                                                        phi_8715_ = _e3538;
                                                        phi_8716_ = _e3540;
                                                    }
                                                    let _e3557 = phi_8711_;
                                                    let _e3559 = phi_8712_;
                                                    let _e3561 = phi_8713_;
                                                    let _e3563 = phi_8714_;
                                                    let _e3565 = phi_8715_;
                                                    let _e3567 = phi_8716_;
                                                    phi_7060_ = _e3557;
                                                    phi_7062_ = _e3528;
                                                    phi_7064_ = _e3532;
                                                    phi_8717_ = _e3528;
                                                    phi_8718_ = _e3559;
                                                    phi_8719_ = _e3561;
                                                    phi_8720_ = false;
                                                    phi_8721_ = _e3563;
                                                    phi_8722_ = _e3565;
                                                    phi_8723_ = _e3567;
                                                } else {
                                                    phi_7060_ = f64();
                                                    phi_7062_ = f64();
                                                    phi_7064_ = f64();
                                                    phi_8717_ = f64();
                                                    phi_8718_ = false;
                                                    phi_8719_ = false;
                                                    phi_8720_ = true;
                                                    phi_8721_ = false;
                                                    phi_8722_ = false;
                                                    phi_8723_ = false;
                                                }
                                                let _e3569 = phi_7060_;
                                                let _e3571 = phi_7062_;
                                                let _e3573 = phi_7064_;
                                                let _e3575 = phi_8717_;
                                                let _e3577 = phi_8718_;
                                                let _e3579 = phi_8719_;
                                                let _e3581 = phi_8720_;
                                                let _e3583 = phi_8721_;
                                                let _e3585 = phi_8722_;
                                                let _e3587 = phi_8723_;
                                                local_19 = _e3579;
                                                local_35 = _e3575;
                                                local_37 = _e3581;
                                                local_38 = _e3583;
                                                local_39 = _e3585;
                                                local_40 = _e3587;
                                                continue;
                                                continuing {
                                                    phi_7056_ = _e2548;
                                                    phi_7059_ = _e3569;
                                                    phi_7061_ = _e3571;
                                                    phi_7063_ = _e3573;
                                                    break if !(_e3577);
                                                }
                                            }
                                            let _e3590 = local_19;
                                            if _e3590 {
                                                let _e6027 = local_35;
                                                phi_8727_ = _e6027;
                                                phi_8728_ = true;
                                                phi_8729_ = false;
                                                phi_8730_ = false;
                                                phi_8731_ = false;
                                            } else {
                                                let _e6029 = local_36;
                                                phi_8727_ = _e6029;
                                                let _e6032 = local_37;
                                                phi_8728_ = _e6032;
                                                let _e6035 = local_38;
                                                phi_8729_ = _e6035;
                                                let _e6038 = local_39;
                                                phi_8730_ = _e6038;
                                                let _e6041 = local_40;
                                                phi_8731_ = _e6041;
                                            }
                                            let _e3592 = phi_8727_;
                                            let _e3594 = phi_8728_;
                                            let _e3596 = phi_8729_;
                                            let _e3598 = phi_8730_;
                                            let _e3600 = phi_8731_;
                                            if _e3594 {
                                                phi_8736_ = type_44(1u, _e3592);
                                                phi_8737_ = false;
                                                phi_8738_ = false;
                                                phi_8739_ = false;
                                            } else {
                                                phi_8736_ = type_44();
                                                phi_8737_ = _e3596;
                                                phi_8738_ = _e3598;
                                                phi_8739_ = _e3600;
                                            }
                                            let _e3603 = phi_8736_;
                                            let _e3605 = phi_8737_;
                                            let _e3607 = phi_8738_;
                                            let _e3609 = phi_8739_;
                                            if _e3605 {
                                                let _e3611 = local_20;
                                                phi_8744_ = type_44(1u, _e3611);
                                                phi_8745_ = false;
                                                phi_8746_ = false;
                                            } else {
                                                phi_8744_ = type_44();
                                                phi_8745_ = _e3607;
                                                phi_8746_ = _e3609;
                                            }
                                            let _e3614 = phi_8744_;
                                            let _e3616 = phi_8745_;
                                            let _e3618 = phi_8746_;
                                            if _e3616 {
                                                phi_8751_ = type_44(0u, type_44().member_1);
                                                phi_8752_ = false;
                                                phi_8753_ = true;
                                            } else {
                                                phi_8751_ = _e3614;
                                                phi_8752_ = _e3618;
                                                phi_8753_ = _e3605;
                                            }
                                            let _e3622 = phi_8751_;
                                            let _e3624 = phi_8752_;
                                            let _e3626 = phi_8753_;
                                            if _e3624 {
                                                phi_8758_ = type_44(0u, type_44().member_1);
                                                phi_8759_ = true;
                                            } else {
                                                phi_8758_ = _e3622;
                                                phi_8759_ = _e3626;
                                            }
                                            let _e3630 = phi_8758_;
                                            let _e3632 = phi_8759_;
                                            if _e3632 {
                                                phi_8763_ = _e3630;
                                            } else {
                                                phi_8763_ = _e3603;
                                            }
                                            let _e3634 = phi_8763_;
                                            let _e3637 = (_e3634.member != 0u);
                                            if _e3637 {
                                                phi_8770_ = false;
                                            } else {
                                                phi_8770_ = true;
                                            }
                                            let _e3639 = phi_8770_;
                                            phi_8771_ = _e3634.member_1;
                                            phi_8772_ = _e3639;
                                            phi_8773_ = _e3637;
                                            phi_8774_ = false;
                                        } else {
                                            phi_8771_ = f64();
                                            phi_8772_ = false;
                                            phi_8773_ = false;
                                            phi_8774_ = true;
                                        }
                                        let _e3641 = phi_8771_;
                                        let _e3643 = phi_8772_;
                                        let _e3645 = phi_8773_;
                                        let _e3647 = phi_8774_;
                                        phi_8775_ = _e3641;
                                        phi_8776_ = _e3643;
                                        phi_8777_ = _e3645;
                                        phi_8778_ = _e3647;
                                    }
                                    let _e3649 = phi_8775_;
                                    let _e3651 = phi_8776_;
                                    let _e3653 = phi_8777_;
                                    let _e3655 = phi_8778_;
                                    phi_8779_ = _e3649;
                                    phi_8780_ = _e2283;
                                    phi_8781_ = _e3651;
                                    phi_8782_ = _e3653;
                                    phi_8783_ = _e3655;
                                }
                                let _e3657 = phi_8779_;
                                let _e3659 = phi_8780_;
                                let _e3661 = phi_8781_;
                                let _e3663 = phi_8782_;
                                let _e3665 = phi_8783_;
                                if _e3659 {
                                    phi_8787_ = true;
                                    phi_8788_ = false;
                                    phi_8789_ = false;
                                } else {
                                    phi_8787_ = _e3661;
                                    phi_8788_ = _e3663;
                                    phi_8789_ = _e3665;
                                }
                                let _e3667 = phi_8787_;
                                let _e3669 = phi_8788_;
                                let _e3671 = phi_8789_;
                                phi_8790_ = _e3657;
                                phi_8791_ = _e1551;
                                phi_8792_ = _e3667;
                                phi_8793_ = false;
                                phi_8794_ = _e3669;
                                phi_8795_ = _e3671;
                            } else {
                                phi_8790_ = f64();
                                phi_8791_ = type_45();
                                phi_8792_ = false;
                                phi_8793_ = true;
                                phi_8794_ = false;
                                phi_8795_ = false;
                            }
                            let _e3673 = phi_8790_;
                            let _e3675 = phi_8791_;
                            let _e3677 = phi_8792_;
                            let _e3679 = phi_8793_;
                            let _e3681 = phi_8794_;
                            let _e3683 = phi_8795_;
                            local_21 = _e3679;
                            local_41 = _e3681;
                            local_42 = _e3683;
                            local_22 = _e3673;
                            local_23 = _e3675;
                            continue;
                            continuing {
                                phi_5145_ = _e1264;
                                break if !(_e3677);
                            }
                        }
                        let _e3686 = local_21;
                        if _e3686 {
                            phi_8800_ = type_44(0u, type_44().member_1);
                            phi_8801_ = false;
                            phi_8802_ = false;
                        } else {
                            phi_8800_ = type_44();
                            let _e6083 = local_41;
                            phi_8801_ = _e6083;
                            let _e6086 = local_42;
                            phi_8802_ = _e6086;
                        }
                        let _e3690 = phi_8800_;
                        let _e3692 = phi_8801_;
                        let _e3694 = phi_8802_;
                        if _e3692 {
                            let _e3696 = local_22;
                            phi_8807_ = type_44(2u, _e3696);
                            phi_8808_ = false;
                        } else {
                            phi_8807_ = type_44();
                            phi_8808_ = _e3694;
                        }
                        let _e3699 = phi_8807_;
                        let _e3701 = phi_8808_;
                        if _e3701 {
                            let _e3703 = local_23;
                            phi_8814_ = type_44(1u, _e3703.member);
                            phi_8815_ = true;
                        } else {
                            phi_8814_ = _e3699;
                            phi_8815_ = _e3692;
                        }
                        let _e3707 = phi_8814_;
                        let _e3709 = phi_8815_;
                        if _e3709 {
                            phi_8819_ = _e3707;
                        } else {
                            phi_8819_ = _e3690;
                        }
                        let _e3711 = phi_8819_;
                        phi_8823_ = _e3711;
                    }
                    let _e5430 = phi_8823_;
                    phi_8824_ = _e5430;
                }
                let _e5434 = phi_8824_;
                switch bitcast<i32>(_e5434.member) {
                    case 0: {
                        phi_8837_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5440 = function_3(_e5434.member_1);
                        phi_8837_ = type_32(0u, _e5440, true);
                        break;
                    }
                    case 2: {
                        let _e5438 = function_3(_e5434.member_1);
                        phi_8837_ = type_32(1u, _e5438, true);
                        break;
                    }
                    default: {
                        phi_8837_ = type_32();
                        break;
                    }
                }
                let _e5443 = phi_8837_;
                if _e5443.member_2 {
                    let _e5450 = (_e5443.member_1[1] >> bitcast<u32>(20i));
                    if (_e5450 <= 896u) {
                        phi_8860_ = 0u;
                    } else {
                        phi_8860_ = ((((_e5450 - 896u) << bitcast<u32>(23i)) | ((_e5443.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5443.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5465 = phi_8860_;
                    let _e5467 = atomicMin((&earliest.member[0u]), _e5465);
                }
                phi_8864_ = type_22(0u, _e5443.member, _e181, _e184, _e5443.member_1);
                phi_8865_ = _e5443.member_2;
            } else {
                phi_8864_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8865_ = false;
            }
            let _e5469 = phi_8864_;
            let _e5471 = phi_8865_;
            let _e5474 = params.member.member.member_1;
            if ((_e5474 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5471 {
                    let _e5480 = atomicAdd((&counters[0u]), 1u);
                    phi_8884_ = _e5480;
                } else {
                    phi_8884_ = 0u;
                }
                let _e5482 = phi_8884_;
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
                if _e5471 {
                    let _e5495 = params.member.member_1.member_3;
                    if (_e5492 < _e5495) {
                        let _e5497 = (6u * _e5492);
                        atomicStore((&contacts.member[(4u + _e5497)]), _e5469.member);
                        atomicStore((&contacts.member[(_e5497 + 5u)]), _e5469.member_1);
                        atomicStore((&contacts.member[(_e5497 + 6u)]), _e5469.member_2);
                        atomicStore((&contacts.member[(_e5497 + 7u)]), _e5469.member_3);
                        atomicStore((&contacts.member[(_e5497 + 8u)]), _e5469.member_4[0]);
                        atomicStore((&contacts.member[(_e5497 + 9u)]), _e5469.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_843_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
