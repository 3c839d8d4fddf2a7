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
@group(0) @binding(0) 
var<storage> params: type_26;
var<workgroup> counters: array<atomic<u32>, 4>;
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
    var phi_4907_: f64;
    var phi_4913_: f64;
    var phi_4918_: f64;
    var phi_4924_: f64;
    var phi_4930_: f64;
    var phi_4935_: f64;
    var phi_4940_: f64;
    var phi_4950_: bool;
    var phi_4957_: f64;
    var phi_4965_: f64;
    var phi_5008_: type_16;
    var phi_5011_: f64;
    var phi_5032_: bool;
    var phi_5038_: type_17;
    var phi_5009_: type_16;
    var phi_5052_: type_17;
    var phi_5012_: f64;
    var local_13: f64;
    var phi_5001_: f64;
    var phi_5065_: f64;
    var phi_5071_: f64;
    var phi_5096_: type_9;
    var phi_5099_: u32;
    var phi_5097_: type_9;
    var phi_5122_: type_9;
    var phi_5166_: u32;
    var phi_5167_: u32;
    var phi_5100_: u32;
    var phi_5168_: u32;
    var phi_5188_: type_9;
    var phi_5189_: type_9;
    var phi_5212_: type_9;
    var phi_5266_: f64;
    var phi_5273_: f64;
    var phi_5285_: bool;
    var phi_5286_: bool;
    var phi_5287_: bool;
    var phi_5288_: bool;
    var phi_5292_: bool;
    var phi_5304_: type_45;
    var phi_5305_: type_45;
    var phi_5306_: bool;
    var phi_5307_: type_45;
    var phi_5308_: bool;
    var phi_5321_: f64;
    var phi_5334_: type_9;
    var phi_5337_: f64;
    var phi_5339_: f64;
    var phi_5341_: f64;
    var phi_5335_: type_9;
    var phi_5364_: type_9;
    var phi_5391_: f64;
    var phi_5392_: f64;
    var phi_5420_: f64;
    var phi_5436_: f64;
    var phi_5443_: bool;
    var phi_5444_: bool;
    var phi_5445_: bool;
    var phi_5451_: f64;
    var phi_5452_: f64;
    var phi_5453_: bool;
    var phi_5338_: f64;
    var phi_5340_: f64;
    var phi_5342_: f64;
    var phi_5454_: f64;
    var phi_5455_: bool;
    var phi_5456_: bool;
    var local_14: bool;
    var phi_5460_: f64;
    var phi_5461_: f64;
    var phi_5471_: f64;
    var phi_5476_: type_9;
    var phi_5479_: f64;
    var phi_5477_: type_9;
    var phi_5502_: type_9;
    var phi_5533_: f64;
    var phi_5534_: bool;
    var phi_5535_: f64;
    var phi_5536_: bool;
    var phi_5537_: bool;
    var phi_5538_: bool;
    var phi_5539_: f64;
    var phi_5480_: f64;
    var phi_5540_: bool;
    var phi_5541_: bool;
    var phi_5542_: bool;
    var phi_5543_: bool;
    var local_15: bool;
    var phi_5547_: bool;
    var phi_5548_: bool;
    var phi_5552_: bool;
    var phi_5556_: f64;
    var phi_5557_: f64;
    var phi_5559_: type_45;
    var phi_5590_: f64;
    var phi_5597_: f64;
    var phi_5602_: f64;
    var phi_5609_: f64;
    var phi_5614_: f64;
    var phi_5627_: f64;
    var phi_5634_: f64;
    var phi_5639_: f64;
    var phi_5646_: f64;
    var phi_5651_: f64;
    var phi_5656_: f64;
    var phi_5715_: f64;
    var phi_5721_: f64;
    var phi_5726_: f64;
    var phi_5732_: f64;
    var phi_5737_: f64;
    var phi_5751_: f64;
    var phi_5757_: f64;
    var phi_5762_: f64;
    var phi_5768_: f64;
    var phi_5773_: f64;
    var phi_5799_: f64;
    var phi_5806_: f64;
    var phi_5811_: f64;
    var phi_5818_: f64;
    var phi_5823_: f64;
    var phi_5836_: f64;
    var phi_5843_: f64;
    var phi_5848_: f64;
    var phi_5855_: f64;
    var phi_5860_: f64;
    var phi_5865_: f64;
    var phi_5924_: f64;
    var phi_5930_: f64;
    var phi_5935_: f64;
    var phi_5941_: f64;
    var phi_5946_: f64;
    var phi_5960_: f64;
    var phi_5966_: f64;
    var phi_5971_: f64;
    var phi_5977_: f64;
    var phi_5982_: f64;
    var phi_6008_: f64;
    var phi_6015_: f64;
    var phi_6020_: f64;
    var phi_6027_: f64;
    var phi_6032_: f64;
    var phi_6045_: f64;
    var phi_6052_: f64;
    var phi_6057_: f64;
    var phi_6064_: f64;
    var phi_6069_: f64;
    var phi_6074_: f64;
    var phi_6133_: f64;
    var phi_6139_: f64;
    var phi_6144_: f64;
    var phi_6150_: f64;
    var phi_6155_: f64;
    var phi_6169_: f64;
    var phi_6175_: f64;
    var phi_6180_: f64;
    var phi_6186_: f64;
    var phi_6191_: f64;
    var phi_6240_: f64;
    var phi_6246_: f64;
    var phi_6274_: f64;
    var phi_6280_: f64;
    var phi_6285_: u32;
    var phi_6286_: u32;
    var phi_6256_: f64;
    var phi_6262_: f64;
    var phi_6267_: u32;
    var phi_6268_: u32;
    var phi_6287_: u32;
    var phi_6288_: u32;
    var phi_6361_: f64;
    var phi_6373_: f64;
    var phi_6516_: f64;
    var phi_6522_: f64;
    var phi_6529_: f64;
    var phi_6573_: type_9;
    var phi_6576_: bool;
    var phi_6574_: type_9;
    var phi_6599_: type_9;
    var phi_6626_: bool;
    var phi_6627_: bool;
    var phi_6577_: bool;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var local_16: bool;
    var phi_6633_: bool;
    var local_17: bool;
    var phi_6640_: u32;
    var phi_6641_: u32;
    var phi_6642_: bool;
    var phi_6643_: u32;
    var phi_6644_: u32;
    var phi_6645_: bool;
    var phi_6649_: u32;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: bool;
    var phi_6821_: f64;
    var phi_6828_: f64;
    var phi_6833_: f64;
    var phi_6840_: f64;
    var phi_6845_: f64;
    var phi_6858_: f64;
    var phi_6865_: f64;
    var phi_6870_: f64;
    var phi_6877_: f64;
    var phi_6882_: f64;
    var phi_6887_: f64;
    var phi_6904_: f64;
    var phi_6911_: f64;
    var phi_6916_: f64;
    var phi_6923_: f64;
    var phi_6928_: f64;
    var phi_6942_: f64;
    var phi_6949_: f64;
    var phi_6954_: f64;
    var phi_6961_: f64;
    var phi_6966_: f64;
    var phi_6971_: f64;
    var phi_6988_: f64;
    var phi_6995_: f64;
    var phi_7000_: f64;
    var phi_7007_: f64;
    var phi_7012_: f64;
    var phi_7026_: f64;
    var phi_7033_: f64;
    var phi_7038_: f64;
    var phi_7045_: f64;
    var phi_7050_: f64;
    var phi_7055_: f64;
    var phi_7099_: type_9;
    var phi_7102_: f64;
    var phi_7104_: f64;
    var phi_7106_: f64;
    var phi_7108_: bool;
    var phi_7110_: u32;
    var phi_7100_: type_9;
    var phi_7133_: type_9;
    var phi_7248_: f64;
    var phi_7254_: f64;
    var phi_7260_: f64;
    var phi_7262_: array<f64, 3>;
    var phi_7269_: f64;
    var phi_7276_: f64;
    var phi_7284_: f64;
    var phi_7330_: type_16;
    var phi_7333_: f64;
    var phi_7354_: bool;
    var phi_7360_: type_17;
    var phi_7331_: type_16;
    var phi_7374_: type_17;
    var phi_7334_: f64;
    var local_18: f64;
    var phi_7323_: f64;
    var phi_7387_: f64;
    var phi_7456_: f64;
    var phi_7462_: f64;
    var phi_7471_: f64;
    var phi_7477_: f64;
    var phi_7486_: f64;
    var phi_7492_: f64;
    var phi_7501_: f64;
    var phi_7507_: f64;
    var phi_7513_: type_34;
    var phi_7514_: bool;
    var phi_7515_: type_34;
    var phi_7516_: bool;
    var phi_7526_: type_34;
    var phi_7698_: bool;
    var phi_7699_: bool;
    var phi_7700_: bool;
    var phi_7701_: bool;
    var phi_7702_: bool;
    var phi_7703_: bool;
    var phi_7707_: bool;
    var phi_8005_: bool;
    var phi_8006_: bool;
    var phi_8007_: bool;
    var phi_8008_: bool;
    var phi_8009_: bool;
    var phi_8010_: bool;
    var phi_8014_: bool;
    var phi_8018_: bool;
    var phi_8029_: bool;
    var phi_8030_: bool;
    var phi_8104_: bool;
    var phi_8105_: bool;
    var phi_8128_: f64;
    var phi_8129_: bool;
    var phi_8130_: f64;
    var phi_8131_: bool;
    var phi_8132_: f64;
    var phi_8133_: bool;
    var phi_8134_: bool;
    var phi_8139_: f64;
    var phi_8140_: bool;
    var phi_8144_: f64;
    var phi_8176_: bool;
    var phi_8177_: bool;
    var phi_8200_: f64;
    var phi_8201_: bool;
    var phi_8202_: f64;
    var phi_8203_: bool;
    var phi_8204_: f64;
    var phi_8205_: bool;
    var phi_8206_: bool;
    var phi_8211_: f64;
    var phi_8212_: bool;
    var phi_8216_: f64;
    var phi_8221_: f64;
    var phi_8253_: bool;
    var phi_8254_: bool;
    var phi_8277_: f64;
    var phi_8278_: bool;
    var phi_8279_: f64;
    var phi_8280_: bool;
    var phi_8281_: f64;
    var phi_8282_: bool;
    var phi_8283_: bool;
    var phi_8288_: f64;
    var phi_8289_: bool;
    var phi_8293_: f64;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8349_: f64;
    var phi_8350_: bool;
    var phi_8351_: f64;
    var phi_8352_: bool;
    var phi_8353_: f64;
    var phi_8354_: bool;
    var phi_8355_: bool;
    var phi_8360_: f64;
    var phi_8361_: bool;
    var phi_8365_: f64;
    var phi_8370_: f64;
    var phi_8375_: f64;
    var phi_8380_: f64;
    var phi_8390_: f64;
    var phi_8391_: f64;
    var phi_8392_: bool;
    var phi_8393_: f64;
    var phi_8394_: f64;
    var phi_8395_: bool;
    var phi_8396_: bool;
    var phi_8397_: bool;
    var phi_8398_: f64;
    var phi_8399_: f64;
    var phi_8400_: bool;
    var phi_8401_: bool;
    var phi_8402_: bool;
    var phi_8403_: bool;
    var phi_8404_: f64;
    var phi_8405_: f64;
    var phi_8406_: bool;
    var phi_8407_: bool;
    var phi_8408_: bool;
    var phi_8409_: bool;
    var phi_8495_: f64;
    var phi_8568_: f64;
    var phi_8573_: f64;
    var phi_8646_: f64;
    var phi_8719_: f64;
    var phi_8724_: f64;
    var phi_8745_: f64;
    var phi_8746_: f64;
    var phi_8747_: f64;
    var phi_8422_: bool;
    var phi_8749_: u32;
    var phi_8750_: f64;
    var phi_8751_: bool;
    var phi_8752_: bool;
    var phi_8753_: bool;
    var phi_8754_: u32;
    var phi_8755_: f64;
    var phi_8756_: f64;
    var phi_8757_: f64;
    var phi_8758_: bool;
    var phi_8759_: u32;
    var phi_8760_: bool;
    var phi_8761_: bool;
    var phi_8762_: bool;
    var phi_8763_: bool;
    var phi_8764_: bool;
    var phi_8773_: f64;
    var phi_8778_: f64;
    var phi_8788_: bool;
    var phi_8792_: bool;
    var phi_8793_: f64;
    var phi_8794_: f64;
    var phi_8795_: f64;
    var phi_8796_: bool;
    var phi_8797_: u32;
    var phi_8798_: bool;
    var phi_8799_: bool;
    var phi_8800_: bool;
    var phi_8801_: bool;
    var phi_8802_: bool;
    var phi_7103_: f64;
    var phi_7105_: f64;
    var phi_7107_: f64;
    var phi_7109_: bool;
    var phi_7111_: u32;
    var phi_8803_: f64;
    var phi_8804_: bool;
    var phi_8805_: bool;
    var phi_8806_: bool;
    var phi_8807_: bool;
    var phi_8808_: bool;
    var phi_8809_: bool;
    var local_19: bool;
    var phi_8813_: f64;
    var phi_8814_: bool;
    var phi_8815_: bool;
    var phi_8816_: bool;
    var phi_8817_: bool;
    var phi_8822_: type_44;
    var phi_8823_: bool;
    var phi_8824_: bool;
    var phi_8825_: bool;
    var local_20: f64;
    var phi_8830_: type_44;
    var phi_8831_: bool;
    var phi_8832_: bool;
    var phi_8837_: type_44;
    var phi_8838_: bool;
    var phi_8839_: bool;
    var phi_8844_: type_44;
    var phi_8845_: bool;
    var phi_8849_: type_44;
    var phi_8856_: bool;
    var phi_8857_: f64;
    var phi_8858_: bool;
    var phi_8859_: bool;
    var phi_8860_: bool;
    var phi_8861_: f64;
    var phi_8862_: bool;
    var phi_8863_: bool;
    var phi_8864_: bool;
    var phi_8865_: f64;
    var phi_8866_: bool;
    var phi_8867_: bool;
    var phi_8868_: bool;
    var phi_8869_: bool;
    var phi_8873_: bool;
    var phi_8874_: bool;
    var phi_8875_: bool;
    var phi_8876_: f64;
    var phi_8877_: type_45;
    var phi_8878_: bool;
    var phi_8879_: bool;
    var phi_8880_: bool;
    var phi_8881_: bool;
    var local_21: bool;
    var phi_8886_: type_44;
    var phi_8887_: bool;
    var phi_8888_: bool;
    var local_22: f64;
    var phi_8893_: type_44;
    var phi_8894_: bool;
    var local_23: type_45;
    var phi_8900_: type_44;
    var phi_8901_: bool;
    var phi_8905_: type_44;
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
    var phi_2611_: bool;
    var phi_2613_: u32;
    var phi_2603_: type_9;
    var phi_2636_: type_9;
    var phi_2751_: f64;
    var phi_2757_: f64;
    var phi_2763_: f64;
    var phi_2765_: array<f64, 3>;
    var phi_2772_: f64;
    var phi_2779_: f64;
    var phi_2787_: f64;
    var phi_2833_: type_16;
    var phi_2836_: f64;
    var phi_2857_: bool;
    var phi_2863_: type_17;
    var phi_2834_: type_16;
    var phi_2877_: type_17;
    var phi_2837_: f64;
    var local_24: f64;
    var phi_2826_: f64;
    var phi_2890_: f64;
    var phi_2959_: f64;
    var phi_2965_: f64;
    var phi_2974_: f64;
    var phi_2980_: f64;
    var phi_2989_: f64;
    var phi_2995_: f64;
    var phi_3004_: f64;
    var phi_3010_: f64;
    var phi_3016_: type_34;
    var phi_3017_: bool;
    var phi_3018_: type_34;
    var phi_3019_: bool;
    var phi_3029_: type_34;
    var phi_3201_: bool;
    var phi_3202_: bool;
    var phi_3203_: bool;
    var phi_3204_: bool;
    var phi_3205_: bool;
    var phi_3206_: bool;
    var phi_3210_: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var phi_3510_: bool;
    var phi_3511_: bool;
    var phi_3512_: bool;
    var phi_3513_: bool;
    var phi_3517_: bool;
    var phi_3521_: bool;
    var phi_3532_: bool;
    var phi_3533_: bool;
    var phi_3607_: bool;
    var phi_3608_: bool;
    var phi_3631_: f64;
    var phi_3632_: bool;
    var phi_3633_: f64;
    var phi_3634_: bool;
    var phi_3635_: f64;
    var phi_3636_: bool;
    var phi_3637_: bool;
    var phi_3642_: f64;
    var phi_3643_: bool;
    var phi_3647_: f64;
    var phi_3679_: bool;
    var phi_3680_: bool;
    var phi_3703_: f64;
    var phi_3704_: bool;
    var phi_3705_: f64;
    var phi_3706_: bool;
    var phi_3707_: f64;
    var phi_3708_: bool;
    var phi_3709_: bool;
    var phi_3714_: f64;
    var phi_3715_: bool;
    var phi_3719_: f64;
    var phi_3724_: f64;
    var phi_3756_: bool;
    var phi_3757_: bool;
    var phi_3780_: f64;
    var phi_3781_: bool;
    var phi_3782_: f64;
    var phi_3783_: bool;
    var phi_3784_: f64;
    var phi_3785_: bool;
    var phi_3786_: bool;
    var phi_3791_: f64;
    var phi_3792_: bool;
    var phi_3796_: f64;
    var phi_3828_: bool;
    var phi_3829_: bool;
    var phi_3852_: f64;
    var phi_3853_: bool;
    var phi_3854_: f64;
    var phi_3855_: bool;
    var phi_3856_: f64;
    var phi_3857_: bool;
    var phi_3858_: bool;
    var phi_3863_: f64;
    var phi_3864_: bool;
    var phi_3868_: f64;
    var phi_3873_: f64;
    var phi_3878_: f64;
    var phi_3883_: f64;
    var phi_3893_: f64;
    var phi_3894_: f64;
    var phi_3895_: bool;
    var phi_3896_: f64;
    var phi_3897_: f64;
    var phi_3898_: bool;
    var phi_3899_: bool;
    var phi_3900_: bool;
    var phi_3901_: f64;
    var phi_3902_: f64;
    var phi_3903_: bool;
    var phi_3904_: bool;
    var phi_3905_: bool;
    var phi_3906_: bool;
    var phi_3907_: f64;
    var phi_3908_: f64;
    var phi_3909_: bool;
    var phi_3910_: bool;
    var phi_3911_: bool;
    var phi_3912_: bool;
    var phi_3998_: f64;
    var phi_4071_: f64;
    var phi_4076_: f64;
    var phi_4149_: f64;
    var phi_4222_: f64;
    var phi_4227_: f64;
    var phi_4248_: f64;
    var phi_4249_: f64;
    var phi_4250_: f64;
    var phi_3925_: bool;
    var phi_4252_: u32;
    var phi_4253_: f64;
    var phi_4254_: bool;
    var phi_4255_: bool;
    var phi_4256_: bool;
    var phi_4257_: u32;
    var phi_4258_: f64;
    var phi_4259_: f64;
    var phi_4260_: f64;
    var phi_4261_: bool;
    var phi_4262_: u32;
    var phi_4263_: bool;
    var phi_4264_: bool;
    var phi_4265_: bool;
    var phi_4266_: bool;
    var phi_4267_: bool;
    var phi_4276_: f64;
    var phi_4281_: f64;
    var phi_4291_: bool;
    var phi_4295_: bool;
    var phi_4296_: f64;
    var phi_4297_: f64;
    var phi_4298_: f64;
    var phi_4299_: bool;
    var phi_4300_: u32;
    var phi_4301_: bool;
    var phi_4302_: bool;
    var phi_4303_: bool;
    var phi_4304_: bool;
    var phi_4305_: bool;
    var phi_2606_: f64;
    var phi_2608_: f64;
    var phi_2610_: f64;
    var phi_2612_: bool;
    var phi_2614_: u32;
    var phi_4306_: f64;
    var phi_4307_: bool;
    var phi_4308_: bool;
    var phi_4309_: bool;
    var phi_4310_: bool;
    var phi_4311_: bool;
    var phi_4312_: bool;
    var local_25: bool;
    var phi_4316_: f64;
    var phi_4317_: bool;
    var phi_4318_: bool;
    var phi_4319_: bool;
    var phi_4320_: bool;
    var phi_4325_: type_44;
    var phi_4326_: bool;
    var phi_4327_: bool;
    var phi_4328_: bool;
    var local_26: f64;
    var phi_4333_: type_44;
    var phi_4334_: bool;
    var phi_4335_: bool;
    var phi_4340_: type_44;
    var phi_4341_: bool;
    var phi_4342_: bool;
    var phi_4347_: type_44;
    var phi_4348_: bool;
    var phi_4352_: type_44;
    var phi_4366_: type_9;
    var phi_4367_: type_9;
    var phi_4390_: type_9;
    var phi_4411_: f64;
    var phi_4541_: type_16;
    var phi_4544_: f64;
    var phi_4565_: bool;
    var phi_4571_: type_17;
    var phi_4542_: type_16;
    var phi_4585_: type_17;
    var phi_4545_: f64;
    var local_27: f64;
    var phi_4534_: f64;
    var phi_4598_: f64;
    var phi_4616_: f64;
    var phi_4623_: f64;
    var phi_4628_: f64;
    var phi_4635_: f64;
    var phi_4640_: f64;
    var phi_4653_: f64;
    var phi_4660_: f64;
    var phi_4665_: f64;
    var phi_4672_: f64;
    var phi_4677_: f64;
    var phi_4682_: f64;
    var phi_4699_: f64;
    var phi_4706_: f64;
    var phi_4711_: f64;
    var phi_4718_: f64;
    var phi_4723_: f64;
    var phi_4737_: f64;
    var phi_4744_: f64;
    var phi_4749_: f64;
    var phi_4756_: f64;
    var phi_4761_: f64;
    var phi_4766_: f64;
    var phi_4783_: f64;
    var phi_4790_: f64;
    var phi_4795_: f64;
    var phi_4802_: f64;
    var phi_4807_: f64;
    var phi_4821_: f64;
    var phi_4828_: f64;
    var phi_4833_: f64;
    var phi_4840_: f64;
    var phi_4845_: f64;
    var phi_4850_: f64;
    var phi_4874_: bool;
    var phi_4875_: bool;
    var phi_4876_: bool;
    var local_28: bool;
    var phi_4881_: type_44;
    var phi_4882_: bool;
    var phi_4887_: type_44;
    var phi_4888_: bool;
    var phi_4890_: type_44;
    var phi_4891_: type_44;
    var phi_4892_: bool;
    var phi_4896_: type_44;
    var phi_8909_: type_44;
    var phi_8910_: type_44;
    var phi_8923_: type_32;
    var phi_8946_: u32;
    var phi_8950_: type_22;
    var phi_8951_: bool;
    var phi_8970_: u32;
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
                    phi_8910_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e575.member_1 > f64(0f)) {
                        let _e3760 = f64(1f);
                        let _e3761 = f64(0f);
                        let _e3764 = local_12.member[0u];
                        let _e3770 = local_12.member_1[0u];
                        let _e3776 = local_12.member_2[0u];
                        let _e3788 = local_12.member[1u];
                        let _e3794 = local_12.member_1[1u];
                        let _e3800 = local_12.member_2[1u];
                        let _e3812 = local_12.member[0u];
                        if (_e3812[0] < 0.0lf) {
                            phi_2324_ = -(_e3812[0]);
                        } else {
                            phi_2324_ = _e3812[0];
                        }
                        let _e3819 = phi_2324_;
                        if (_e3812[1] < 0.0lf) {
                            phi_2331_ = -(_e3812[1]);
                        } else {
                            phi_2331_ = _e3812[1];
                        }
                        let _e3823 = phi_2331_;
                        if (_e3819 > _e3823) {
                            phi_2336_ = _e3819;
                        } else {
                            phi_2336_ = _e3823;
                        }
                        let _e3826 = phi_2336_;
                        if (_e3812[2] < 0.0lf) {
                            phi_2343_ = -(_e3812[2]);
                        } else {
                            phi_2343_ = _e3812[2];
                        }
                        let _e3830 = phi_2343_;
                        if (_e3826 > _e3830) {
                            phi_2348_ = _e3826;
                        } else {
                            phi_2348_ = _e3830;
                        }
                        let _e3833 = phi_2348_;
                        let _e3836 = local_12.member[1u];
                        if (_e3836[0] < 0.0lf) {
                            phi_2361_ = -(_e3836[0]);
                        } else {
                            phi_2361_ = _e3836[0];
                        }
                        let _e3843 = phi_2361_;
                        if (_e3836[1] < 0.0lf) {
                            phi_2368_ = -(_e3836[1]);
                        } else {
                            phi_2368_ = _e3836[1];
                        }
                        let _e3847 = phi_2368_;
                        if (_e3843 > _e3847) {
                            phi_2373_ = _e3843;
                        } else {
                            phi_2373_ = _e3847;
                        }
                        let _e3850 = phi_2373_;
                        if (_e3836[2] < 0.0lf) {
                            phi_2380_ = -(_e3836[2]);
                        } else {
                            phi_2380_ = _e3836[2];
                        }
                        let _e3854 = phi_2380_;
                        if (_e3850 > _e3854) {
                            phi_2385_ = _e3850;
                        } else {
                            phi_2385_ = _e3854;
                        }
                        let _e3857 = phi_2385_;
                        if (_e3833 > _e3857) {
                            phi_2390_ = _e3833;
                        } else {
                            phi_2390_ = _e3857;
                        }
                        let _e3860 = phi_2390_;
                        let _e3862 = local_12.member_3;
                        let _e3866 = local_12.member_1[0u];
                        if (_e3866[0] < 0.0lf) {
                            phi_2407_ = -(_e3866[0]);
                        } else {
                            phi_2407_ = _e3866[0];
                        }
                        let _e3873 = phi_2407_;
                        if (_e3866[1] < 0.0lf) {
                            phi_2414_ = -(_e3866[1]);
                        } else {
                            phi_2414_ = _e3866[1];
                        }
                        let _e3877 = phi_2414_;
                        if (_e3873 > _e3877) {
                            phi_2419_ = _e3873;
                        } else {
                            phi_2419_ = _e3877;
                        }
                        let _e3880 = phi_2419_;
                        if (_e3866[2] < 0.0lf) {
                            phi_2426_ = -(_e3866[2]);
                        } else {
                            phi_2426_ = _e3866[2];
                        }
                        let _e3884 = phi_2426_;
                        if (_e3880 > _e3884) {
                            phi_2431_ = _e3880;
                        } else {
                            phi_2431_ = _e3884;
                        }
                        let _e3887 = phi_2431_;
                        let _e3890 = local_12.member_1[1u];
                        if (_e3890[0] < 0.0lf) {
                            phi_2445_ = -(_e3890[0]);
                        } else {
                            phi_2445_ = _e3890[0];
                        }
                        let _e3897 = phi_2445_;
                        if (_e3890[1] < 0.0lf) {
                            phi_2452_ = -(_e3890[1]);
                        } else {
                            phi_2452_ = _e3890[1];
                        }
                        let _e3901 = phi_2452_;
                        if (_e3897 > _e3901) {
                            phi_2457_ = _e3897;
                        } else {
                            phi_2457_ = _e3901;
                        }
                        let _e3904 = phi_2457_;
                        if (_e3890[2] < 0.0lf) {
                            phi_2464_ = -(_e3890[2]);
                        } else {
                            phi_2464_ = _e3890[2];
                        }
                        let _e3908 = phi_2464_;
                        if (_e3904 > _e3908) {
                            phi_2469_ = _e3904;
                        } else {
                            phi_2469_ = _e3908;
                        }
                        let _e3911 = phi_2469_;
                        if (_e3887 > _e3911) {
                            phi_2474_ = _e3887;
                        } else {
                            phi_2474_ = _e3911;
                        }
                        let _e3914 = phi_2474_;
                        let _e3916 = local_12.member_3;
                        let _e3920 = local_12.member_2[0u];
                        if (_e3920[0] < 0.0lf) {
                            phi_2491_ = -(_e3920[0]);
                        } else {
                            phi_2491_ = _e3920[0];
                        }
                        let _e3927 = phi_2491_;
                        if (_e3920[1] < 0.0lf) {
                            phi_2498_ = -(_e3920[1]);
                        } else {
                            phi_2498_ = _e3920[1];
                        }
                        let _e3931 = phi_2498_;
                        if (_e3927 > _e3931) {
                            phi_2503_ = _e3927;
                        } else {
                            phi_2503_ = _e3931;
                        }
                        let _e3934 = phi_2503_;
                        if (_e3920[2] < 0.0lf) {
                            phi_2510_ = -(_e3920[2]);
                        } else {
                            phi_2510_ = _e3920[2];
                        }
                        let _e3938 = phi_2510_;
                        if (_e3934 > _e3938) {
                            phi_2515_ = _e3934;
                        } else {
                            phi_2515_ = _e3938;
                        }
                        let _e3941 = phi_2515_;
                        let _e3944 = local_12.member_2[1u];
                        if (_e3944[0] < 0.0lf) {
                            phi_2529_ = -(_e3944[0]);
                        } else {
                            phi_2529_ = _e3944[0];
                        }
                        let _e3951 = phi_2529_;
                        if (_e3944[1] < 0.0lf) {
                            phi_2536_ = -(_e3944[1]);
                        } else {
                            phi_2536_ = _e3944[1];
                        }
                        let _e3955 = phi_2536_;
                        if (_e3951 > _e3955) {
                            phi_2541_ = _e3951;
                        } else {
                            phi_2541_ = _e3955;
                        }
                        let _e3958 = phi_2541_;
                        if (_e3944[2] < 0.0lf) {
                            phi_2548_ = -(_e3944[2]);
                        } else {
                            phi_2548_ = _e3944[2];
                        }
                        let _e3962 = phi_2548_;
                        if (_e3958 > _e3962) {
                            phi_2553_ = _e3958;
                        } else {
                            phi_2553_ = _e3962;
                        }
                        let _e3965 = phi_2553_;
                        if (_e3941 > _e3965) {
                            phi_2558_ = _e3941;
                        } else {
                            phi_2558_ = _e3965;
                        }
                        let _e3968 = phi_2558_;
                        let _e3970 = local_12.member_3;
                        let _e3978 = local_12.member_3;
                        let _e3985 = f64(0f);
                        let _e3986 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e3985, _e3985, _e3985, _e3985), array<f64, 4>(_e3985, _e3985, _e3985, _e3985), array<f64, 4>(_e3986, _e3986, _e3986, _e3986));
                        phi_2602_ = type_9(0u, 96u);
                        phi_2605_ = _e3761;
                        phi_2607_ = _e3761;
                        phi_2609_ = _e3761;
                        phi_2611_ = false;
                        phi_2613_ = 0u;
                        loop {
                            let _e3992 = phi_2602_;
                            let _e3994 = phi_2605_;
                            let _e3996 = phi_2607_;
                            let _e3998 = phi_2609_;
                            let _e4000 = phi_2611_;
                            let _e4002 = phi_2613_;
                            local_44 = _e3996;
                            local_26 = _e3994;
                            if (_e3992.member < _e3992.member_1) {
                                phi_2603_ = type_9((_e3992.member + 1u), _e3992.member_1);
                                phi_2636_ = type_9(1u, _e3992.member);
                            } else {
                                phi_2603_ = _e3992;
                                phi_2636_ = type_9(0u, type_9().member_1);
                            }
                            let _e4014 = phi_2603_;
                            let _e4016 = phi_2636_;
                            if (bitcast<i32>(_e4016.member) != 0i) {
                                let _e4022 = local_12.member[0u];
                                let _e4028 = local_12.member[1u];
                                let _e4044 = local_12.member_1[0u];
                                let _e4050 = local_12.member_1[1u];
                                let _e4066 = local_12.member_2[0u];
                                let _e4072 = local_12.member_2[1u];
                                let _e4086 = function_2(array<f64, 3>((_e4022[0] + ((_e4028[0] - _e4022[0]) * _e3994)), (_e4022[1] + ((_e4028[1] - _e4022[1]) * _e3994)), (_e4022[2] + ((_e4028[2] - _e4022[2]) * _e3994))), array<f64, 3>((_e4044[0] + ((_e4050[0] - _e4044[0]) * _e3994)), (_e4044[1] + ((_e4050[1] - _e4044[1]) * _e3994)), (_e4044[2] + ((_e4050[2] - _e4044[2]) * _e3994))), array<f64, 3>((_e4066[0] + ((_e4072[0] - _e4066[0]) * _e3994)), (_e4066[1] + ((_e4072[1] - _e4066[1]) * _e3994)), (_e4066[2] + ((_e4072[2] - _e4066[2]) * _e3994))), 0u);
                                if (_e4002 == 0u) {
                                    phi_2765_ = _e4086;
                                } else {
                                    let _e4088 = f64(0f);
                                    if (_e4002 == 1u) {
                                        phi_2751_ = _e4086[0];
                                    } else {
                                        phi_2751_ = _e4088;
                                    }
                                    let _e4092 = phi_2751_;
                                    if (_e4002 == 2u) {
                                        phi_2757_ = _e4086[1];
                                    } else {
                                        phi_2757_ = _e4088;
                                    }
                                    let _e4096 = phi_2757_;
                                    if (_e4002 == 3u) {
                                        phi_2763_ = _e4086[2];
                                    } else {
                                        phi_2763_ = _e4088;
                                    }
                                    let _e4100 = phi_2763_;
                                    phi_2765_ = array<f64, 3>(_e4092, _e4096, _e4100);
                                }
                                let _e4103 = phi_2765_;
                                if (_e4103[0] < 0.0lf) {
                                    phi_2772_ = -(_e4103[0]);
                                } else {
                                    phi_2772_ = _e4103[0];
                                }
                                let _e4108 = phi_2772_;
                                if (_e4103[1] < 0.0lf) {
                                    phi_2779_ = -(_e4103[1]);
                                } else {
                                    phi_2779_ = _e4103[1];
                                }
                                let _e4113 = phi_2779_;
                                if (_e4103[2] < 0.0lf) {
                                    phi_2787_ = -(_e4103[2]);
                                } else {
                                    phi_2787_ = _e4103[2];
                                }
                                let _e4119 = phi_2787_;
                                let _e4120 = ((_e4108 + _e4113) + _e4119);
                                if (_e4120 > f64(0f)) {
                                    if ((bitcast<u64>(_e4120) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4127 = (f64(1f) / _e4120);
                                        let _e4129 = (_e4103[0] * _e4127);
                                        let _e4131 = (_e4103[1] * _e4127);
                                        let _e4133 = (_e4103[2] * _e4127);
                                        let _e4138 = (((_e4129 * _e4129) + (_e4131 * _e4131)) + (_e4133 * _e4133));
                                        if (_e4138 <= 2.2250738585072014e-308lf) {
                                            if (_e4138 > 0.0lf) {
                                                phi_2826_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2826_ = 0.0lf;
                                            }
                                            let _e4190 = phi_2826_;
                                            phi_2890_ = _e4190;
                                        } else {
                                            phi_2833_ = type_16(0i, 5i);
                                            phi_2836_ = bitcast<f64>(((bitcast<u64>(_e4138) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4145 = phi_2833_;
                                                let _e4147 = phi_2836_;
                                                local_24 = _e4147;
                                                if (_e4145.member < _e4145.member_1) {
                                                    let _e4154 = (_e4145.member + 1i);
                                                    if ((false == (_e4154 > _e4145.member)) != false) {
                                                        phi_2857_ = true;
                                                    } else {
                                                        phi_2857_ = false;
                                                    }
                                                    let _e4159 = phi_2857_;
                                                    if _e4159 {
                                                        phi_2863_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2863_ = type_17(1u, _e4154);
                                                    }
                                                    let _e4164 = phi_2863_;
                                                    phi_2834_ = type_16(_e4164.member_1, _e4145.member_1);
                                                    phi_2877_ = type_17(1u, _e4145.member);
                                                } else {
                                                    phi_2834_ = _e4145;
                                                    phi_2877_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4170 = phi_2834_;
                                                let _e4172 = phi_2877_;
                                                let _e4175 = (bitcast<i32>(_e4172.member) != 0i);
                                                if _e4175 {
                                                    phi_2837_ = (0.5lf * (_e4147 + (_e4138 / _e4147)));
                                                } else {
                                                    phi_2837_ = f64();
                                                }
                                                let _e4180 = phi_2837_;
                                                continue;
                                                continuing {
                                                    phi_2833_ = _e4170;
                                                    phi_2836_ = _e4180;
                                                    break if !(_e4175);
                                                }
                                            }
                                            let _e4185 = local_24;
                                            phi_2890_ = (_e4185 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4192 = phi_2890_;
                                        let _e4194 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4201 = ((((((((_e3860 + _e3862) + (_e3914 + _e3916)) + (_e3968 + _e3970)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3978 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e575.member_1 * _e4192) * (f64(1f) + _e4194)));
                                        let _e4206 = (((_e4129 * _e3764[0]) + (_e4131 * _e3764[1])) + (_e4133 * _e3764[2]));
                                        let _e4211 = (((_e4129 * (_e3764[0] - _e3770[0])) + (_e4131 * (_e3764[1] - _e3770[1]))) + (_e4133 * (_e3764[2] - _e3770[2])));
                                        let _e4216 = (((_e4129 * (_e3764[0] - _e3776[0])) + (_e4131 * (_e3764[1] - _e3776[1]))) + (_e4133 * (_e3764[2] - _e3776[2])));
                                        let _e4221 = (((_e4129 * _e3764[0]) + (_e4131 * _e3764[1])) + (_e4133 * _e3764[2]));
                                        let _e4227 = (((_e4129 * _e3788[0]) + (_e4131 * _e3788[1])) + (_e4133 * _e3788[2]));
                                        let _e4232 = (((_e4129 * (_e3788[0] - _e3794[0])) + (_e4131 * (_e3788[1] - _e3794[1]))) + (_e4133 * (_e3788[2] - _e3794[2])));
                                        let _e4237 = (((_e4129 * (_e3788[0] - _e3800[0])) + (_e4131 * (_e3788[1] - _e3800[1]))) + (_e4133 * (_e3788[2] - _e3800[2])));
                                        let _e4242 = (((_e4129 * _e3788[0]) + (_e4131 * _e3788[1])) + (_e4133 * _e3788[2]));
                                        if (_e4206 < 0.0lf) {
                                            phi_2959_ = -(_e4206);
                                        } else {
                                            phi_2959_ = _e4206;
                                        }
                                        let _e4247 = phi_2959_;
                                        if (_e4227 < 0.0lf) {
                                            phi_2965_ = -(_e4227);
                                        } else {
                                            phi_2965_ = _e4227;
                                        }
                                        let _e4251 = phi_2965_;
                                        if (_e4211 < 0.0lf) {
                                            phi_2974_ = -(_e4211);
                                        } else {
                                            phi_2974_ = _e4211;
                                        }
                                        let _e4258 = phi_2974_;
                                        if (_e4232 < 0.0lf) {
                                            phi_2980_ = -(_e4232);
                                        } else {
                                            phi_2980_ = _e4232;
                                        }
                                        let _e4262 = phi_2980_;
                                        if (_e4216 < 0.0lf) {
                                            phi_2989_ = -(_e4216);
                                        } else {
                                            phi_2989_ = _e4216;
                                        }
                                        let _e4269 = phi_2989_;
                                        if (_e4237 < 0.0lf) {
                                            phi_2995_ = -(_e4237);
                                        } else {
                                            phi_2995_ = _e4237;
                                        }
                                        let _e4273 = phi_2995_;
                                        if (_e4221 < 0.0lf) {
                                            phi_3004_ = -(_e4221);
                                        } else {
                                            phi_3004_ = _e4221;
                                        }
                                        let _e4280 = phi_3004_;
                                        if (_e4242 < 0.0lf) {
                                            phi_3010_ = -(_e4242);
                                        } else {
                                            phi_3010_ = _e4242;
                                        }
                                        let _e4284 = phi_3010_;
                                        phi_3016_ = type_34(array<f64, 4>(_e4206, _e4211, _e4216, _e4221), array<f64, 4>(_e4227, _e4232, _e4237, _e4242), array<f64, 4>((_e4201 + ((_e4247 + _e4251) * _e4194)), (_e4201 + ((_e4258 + _e4262) * _e4194)), (_e4201 + ((_e4269 + _e4273) * _e4194)), (_e4201 + ((_e4280 + _e4284) * _e4194))));
                                        phi_3017_ = false;
                                    } else {
                                        phi_3016_ = type_34();
                                        phi_3017_ = true;
                                    }
                                    let _e4291 = phi_3016_;
                                    let _e4293 = phi_3017_;
                                    phi_3018_ = _e4291;
                                    phi_3019_ = _e4293;
                                } else {
                                    phi_3018_ = type_34();
                                    phi_3019_ = true;
                                }
                                let _e4295 = phi_3018_;
                                let _e4297 = phi_3019_;
                                if _e4297 {
                                    let _e4298 = f64(0f);
                                    let _e4299 = f64(1f);
                                    phi_3029_ = type_34(array<f64, 4>(_e4298, _e4298, _e4298, _e4298), array<f64, 4>(_e4298, _e4298, _e4298, _e4298), array<f64, 4>(_e4299, _e4299, _e4299, _e4299));
                                } else {
                                    phi_3029_ = _e4295;
                                }
                                let _e4305 = phi_3029_;
                                local_10 = type_34(array<f64, 4>(_e4305.member[0], _e4305.member[1], _e4305.member[2], _e4305.member[3]), array<f64, 4>(_e4305.member_1[0], _e4305.member_1[1], _e4305.member_1[2], _e4305.member_1[3]), array<f64, 4>(_e4305.member_2[0], _e4305.member_2[1], _e4305.member_2[2], _e4305.member_2[3]));
                                let _e4325 = (_e3994 - _e3998);
                                let _e4327 = f64(0f);
                                let _e4330 = local_10.member[0u];
                                let _e4333 = local_10.member_1[0u];
                                let _e4336 = local_10.member[0u];
                                let _e4342 = local_10.member_2[0u];
                                if (((_e4330 + ((_e4333 - _e4336) * _e3994)) - _e4342) > _e4327) {
                                    let _e4347 = local_10.member[1u];
                                    let _e4350 = local_10.member_1[1u];
                                    let _e4353 = local_10.member[1u];
                                    let _e4359 = local_10.member_2[1u];
                                    if (((_e4347 + ((_e4350 - _e4353) * _e3994)) - _e4359) > _e4327) {
                                        let _e4364 = local_10.member[2u];
                                        let _e4367 = local_10.member_1[2u];
                                        let _e4370 = local_10.member[2u];
                                        let _e4376 = local_10.member_2[2u];
                                        if (((_e4364 + ((_e4367 - _e4370) * _e3994)) - _e4376) > _e4327) {
                                            let _e4381 = local_10.member[3u];
                                            let _e4384 = local_10.member_1[3u];
                                            let _e4387 = local_10.member[3u];
                                            let _e4393 = local_10.member_2[3u];
                                            phi_3201_ = (((_e4381 + ((_e4384 - _e4387) * _e3994)) - _e4393) > _e4327);
                                            phi_3202_ = false;
                                        } else {
                                            phi_3201_ = bool();
                                            phi_3202_ = true;
                                        }
                                        let _e4397 = phi_3201_;
                                        let _e4399 = phi_3202_;
                                        phi_3203_ = _e4397;
                                        phi_3204_ = _e4399;
                                    } else {
                                        phi_3203_ = bool();
                                        phi_3204_ = true;
                                    }
                                    let _e4401 = phi_3203_;
                                    let _e4403 = phi_3204_;
                                    phi_3205_ = _e4401;
                                    phi_3206_ = _e4403;
                                } else {
                                    phi_3205_ = bool();
                                    phi_3206_ = true;
                                }
                                let _e4405 = phi_3205_;
                                let _e4407 = phi_3206_;
                                if _e4407 {
                                    phi_3210_ = false;
                                } else {
                                    phi_3210_ = _e4405;
                                }
                                let _e4409 = phi_3210_;
                                if _e4409 {
                                    if (_e3994 <= _e3996) {
                                        phi_3521_ = true;
                                    } else {
                                        let _e4411 = f64(0f);
                                        let _e4414 = local_9.member[0u];
                                        let _e4417 = local_9.member_1[0u];
                                        let _e4420 = local_9.member[0u];
                                        let _e4426 = local_9.member_2[0u];
                                        let _e4430 = local_10.member[0u];
                                        let _e4433 = local_10.member_1[0u];
                                        let _e4436 = local_10.member[0u];
                                        let _e4442 = local_10.member_2[0u];
                                        if ((((_e4414 + ((_e4417 - _e4420) * _e3994)) - _e4426) + ((_e4430 + ((_e4433 - _e4436) * _e3998)) - _e4442)) > _e4411) {
                                            let _e4448 = local_9.member[1u];
                                            let _e4451 = local_9.member_1[1u];
                                            let _e4454 = local_9.member[1u];
                                            let _e4460 = local_9.member_2[1u];
                                            let _e4464 = local_10.member[1u];
                                            let _e4467 = local_10.member_1[1u];
                                            let _e4470 = local_10.member[1u];
                                            let _e4476 = local_10.member_2[1u];
                                            if ((((_e4448 + ((_e4451 - _e4454) * _e3994)) - _e4460) + ((_e4464 + ((_e4467 - _e4470) * _e3998)) - _e4476)) > _e4411) {
                                                let _e4482 = local_9.member[2u];
                                                let _e4485 = local_9.member_1[2u];
                                                let _e4488 = local_9.member[2u];
                                                let _e4494 = local_9.member_2[2u];
                                                let _e4498 = local_10.member[2u];
                                                let _e4501 = local_10.member_1[2u];
                                                let _e4504 = local_10.member[2u];
                                                let _e4510 = local_10.member_2[2u];
                                                if ((((_e4482 + ((_e4485 - _e4488) * _e3994)) - _e4494) + ((_e4498 + ((_e4501 - _e4504) * _e3998)) - _e4510)) > _e4411) {
                                                    let _e4516 = local_9.member[3u];
                                                    let _e4519 = local_9.member_1[3u];
                                                    let _e4522 = local_9.member[3u];
                                                    let _e4528 = local_9.member_2[3u];
                                                    let _e4532 = local_10.member[3u];
                                                    let _e4535 = local_10.member_1[3u];
                                                    let _e4538 = local_10.member[3u];
                                                    let _e4544 = local_10.member_2[3u];
                                                    phi_3508_ = ((((_e4516 + ((_e4519 - _e4522) * _e3994)) - _e4528) + ((_e4532 + ((_e4535 - _e4538) * _e3998)) - _e4544)) > _e4411);
                                                    phi_3509_ = false;
                                                } else {
                                                    phi_3508_ = bool();
                                                    phi_3509_ = true;
                                                }
                                                let _e4549 = phi_3508_;
                                                let _e4551 = phi_3509_;
                                                phi_3510_ = _e4549;
                                                phi_3511_ = _e4551;
                                            } else {
                                                phi_3510_ = bool();
                                                phi_3511_ = true;
                                            }
                                            let _e4553 = phi_3510_;
                                            let _e4555 = phi_3511_;
                                            phi_3512_ = _e4553;
                                            phi_3513_ = _e4555;
                                        } else {
                                            phi_3512_ = bool();
                                            phi_3513_ = true;
                                        }
                                        let _e4557 = phi_3512_;
                                        let _e4559 = phi_3513_;
                                        if _e4559 {
                                            phi_3517_ = false;
                                        } else {
                                            phi_3517_ = _e4557;
                                        }
                                        let _e4561 = phi_3517_;
                                        phi_3521_ = _e4561;
                                    }
                                    let _e4563 = phi_3521_;
                                    if _e4563 {
                                        if _e4000 {
                                            if (_e3994 >= _e3760) {
                                                phi_3532_ = false;
                                            } else {
                                                phi_3532_ = true;
                                            }
                                            let _e4566 = phi_3532_;
                                            phi_3533_ = _e4566;
                                        } else {
                                            phi_3533_ = true;
                                        }
                                        let _e4568 = phi_3533_;
                                        if _e4568 {
                                            local_9 = type_34(array<f64, 4>(_e4305.member[0], _e4305.member[1], _e4305.member[2], _e4305.member[3]), array<f64, 4>(_e4305.member_1[0], _e4305.member_1[1], _e4305.member_1[2], _e4305.member_1[3]), array<f64, 4>(_e4305.member_2[0], _e4305.member_2[1], _e4305.member_2[2], _e4305.member_2[3]));
                                            let _e4590 = local_9.member[0u];
                                            let _e4593 = local_9.member_1[0u];
                                            let _e4596 = local_9.member_2[0u];
                                            if (_e4590 > _e4596) {
                                                if (_e4593 > _e4596) {
                                                    phi_3607_ = false;
                                                } else {
                                                    phi_3607_ = true;
                                                }
                                                let _e4600 = phi_3607_;
                                                phi_3608_ = _e4600;
                                            } else {
                                                phi_3608_ = true;
                                            }
                                            let _e4602 = phi_3608_;
                                            if _e4602 {
                                                let _e4603 = (_e4593 >= _e4590);
                                                if _e4603 {
                                                    phi_3633_ = f64();
                                                    phi_3634_ = false;
                                                } else {
                                                    if ((_e4590 - _e4593) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3631_ = (((_e4590 - _e4596) / (_e4590 - _e4593)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3632_ = false;
                                                    } else {
                                                        phi_3631_ = f64();
                                                        phi_3632_ = true;
                                                    }
                                                    let _e4617 = phi_3631_;
                                                    let _e4619 = phi_3632_;
                                                    phi_3633_ = _e4617;
                                                    phi_3634_ = _e4619;
                                                }
                                                let _e4621 = phi_3633_;
                                                let _e4623 = phi_3634_;
                                                phi_3635_ = _e4621;
                                                phi_3636_ = _e4603;
                                                phi_3637_ = _e4623;
                                            } else {
                                                phi_3635_ = f64();
                                                phi_3636_ = true;
                                                phi_3637_ = false;
                                            }
                                            let _e4625 = phi_3635_;
                                            let _e4627 = phi_3636_;
                                            let _e4629 = phi_3637_;
                                            if _e4627 {
                                                phi_3642_ = f64(2f);
                                                phi_3643_ = true;
                                            } else {
                                                phi_3642_ = _e3994;
                                                phi_3643_ = _e4629;
                                            }
                                            let _e4632 = phi_3642_;
                                            let _e4634 = phi_3643_;
                                            if _e4634 {
                                                phi_3647_ = _e4632;
                                            } else {
                                                phi_3647_ = _e4625;
                                            }
                                            let _e4636 = phi_3647_;
                                            let _e4639 = local_9.member[1u];
                                            let _e4642 = local_9.member_1[1u];
                                            let _e4645 = local_9.member_2[1u];
                                            if (_e4639 > _e4645) {
                                                if (_e4642 > _e4645) {
                                                    phi_3679_ = false;
                                                } else {
                                                    phi_3679_ = true;
                                                }
                                                let _e4649 = phi_3679_;
                                                phi_3680_ = _e4649;
                                            } else {
                                                phi_3680_ = true;
                                            }
                                            let _e4651 = phi_3680_;
                                            if _e4651 {
                                                let _e4652 = (_e4642 >= _e4639);
                                                if _e4652 {
                                                    phi_3705_ = f64();
                                                    phi_3706_ = false;
                                                } else {
                                                    if ((_e4639 - _e4642) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3703_ = (((_e4639 - _e4645) / (_e4639 - _e4642)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3704_ = false;
                                                    } else {
                                                        phi_3703_ = f64();
                                                        phi_3704_ = true;
                                                    }
                                                    let _e4666 = phi_3703_;
                                                    let _e4668 = phi_3704_;
                                                    phi_3705_ = _e4666;
                                                    phi_3706_ = _e4668;
                                                }
                                                let _e4670 = phi_3705_;
                                                let _e4672 = phi_3706_;
                                                phi_3707_ = _e4670;
                                                phi_3708_ = _e4652;
                                                phi_3709_ = _e4672;
                                            } else {
                                                phi_3707_ = f64();
                                                phi_3708_ = true;
                                                phi_3709_ = false;
                                            }
                                            let _e4674 = phi_3707_;
                                            let _e4676 = phi_3708_;
                                            let _e4678 = phi_3709_;
                                            if _e4676 {
                                                phi_3714_ = f64(2f);
                                                phi_3715_ = true;
                                            } else {
                                                phi_3714_ = _e3994;
                                                phi_3715_ = _e4678;
                                            }
                                            let _e4681 = phi_3714_;
                                            let _e4683 = phi_3715_;
                                            if _e4683 {
                                                phi_3719_ = _e4681;
                                            } else {
                                                phi_3719_ = _e4674;
                                            }
                                            let _e4685 = phi_3719_;
                                            if (_e4636 < _e4685) {
                                                phi_3724_ = _e4636;
                                            } else {
                                                phi_3724_ = _e4685;
                                            }
                                            let _e4688 = phi_3724_;
                                            let _e4691 = local_9.member[2u];
                                            let _e4694 = local_9.member_1[2u];
                                            let _e4697 = local_9.member_2[2u];
                                            if (_e4691 > _e4697) {
                                                if (_e4694 > _e4697) {
                                                    phi_3756_ = false;
                                                } else {
                                                    phi_3756_ = true;
                                                }
                                                let _e4701 = phi_3756_;
                                                phi_3757_ = _e4701;
                                            } else {
                                                phi_3757_ = true;
                                            }
                                            let _e4703 = phi_3757_;
                                            if _e4703 {
                                                let _e4704 = (_e4694 >= _e4691);
                                                if _e4704 {
                                                    phi_3782_ = f64();
                                                    phi_3783_ = false;
                                                } else {
                                                    if ((_e4691 - _e4694) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3780_ = (((_e4691 - _e4697) / (_e4691 - _e4694)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3781_ = false;
                                                    } else {
                                                        phi_3780_ = f64();
                                                        phi_3781_ = true;
                                                    }
                                                    let _e4718 = phi_3780_;
                                                    let _e4720 = phi_3781_;
                                                    phi_3782_ = _e4718;
                                                    phi_3783_ = _e4720;
                                                }
                                                let _e4722 = phi_3782_;
                                                let _e4724 = phi_3783_;
                                                phi_3784_ = _e4722;
                                                phi_3785_ = _e4704;
                                                phi_3786_ = _e4724;
                                            } else {
                                                phi_3784_ = f64();
                                                phi_3785_ = true;
                                                phi_3786_ = false;
                                            }
                                            let _e4726 = phi_3784_;
                                            let _e4728 = phi_3785_;
                                            let _e4730 = phi_3786_;
                                            if _e4728 {
                                                phi_3791_ = f64(2f);
                                                phi_3792_ = true;
                                            } else {
                                                phi_3791_ = _e3994;
                                                phi_3792_ = _e4730;
                                            }
                                            let _e4733 = phi_3791_;
                                            let _e4735 = phi_3792_;
                                            if _e4735 {
                                                phi_3796_ = _e4733;
                                            } else {
                                                phi_3796_ = _e4726;
                                            }
                                            let _e4737 = phi_3796_;
                                            let _e4740 = local_9.member[3u];
                                            let _e4743 = local_9.member_1[3u];
                                            let _e4746 = local_9.member_2[3u];
                                            if (_e4740 > _e4746) {
                                                if (_e4743 > _e4746) {
                                                    phi_3828_ = false;
                                                } else {
                                                    phi_3828_ = true;
                                                }
                                                let _e4750 = phi_3828_;
                                                phi_3829_ = _e4750;
                                            } else {
                                                phi_3829_ = true;
                                            }
                                            let _e4752 = phi_3829_;
                                            if _e4752 {
                                                let _e4753 = (_e4743 >= _e4740);
                                                if _e4753 {
                                                    phi_3854_ = f64();
                                                    phi_3855_ = false;
                                                } else {
                                                    if ((_e4740 - _e4743) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3852_ = (((_e4740 - _e4746) / (_e4740 - _e4743)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3853_ = false;
                                                    } else {
                                                        phi_3852_ = f64();
                                                        phi_3853_ = true;
                                                    }
                                                    let _e4767 = phi_3852_;
                                                    let _e4769 = phi_3853_;
                                                    phi_3854_ = _e4767;
                                                    phi_3855_ = _e4769;
                                                }
                                                let _e4771 = phi_3854_;
                                                let _e4773 = phi_3855_;
                                                phi_3856_ = _e4771;
                                                phi_3857_ = _e4753;
                                                phi_3858_ = _e4773;
                                            } else {
                                                phi_3856_ = f64();
                                                phi_3857_ = true;
                                                phi_3858_ = false;
                                            }
                                            let _e4775 = phi_3856_;
                                            let _e4777 = phi_3857_;
                                            let _e4779 = phi_3858_;
                                            if _e4777 {
                                                phi_3863_ = f64(2f);
                                                phi_3864_ = true;
                                            } else {
                                                phi_3863_ = _e3994;
                                                phi_3864_ = _e4779;
                                            }
                                            let _e4782 = phi_3863_;
                                            let _e4784 = phi_3864_;
                                            if _e4784 {
                                                phi_3868_ = _e4782;
                                            } else {
                                                phi_3868_ = _e4775;
                                            }
                                            let _e4786 = phi_3868_;
                                            if (_e4737 < _e4786) {
                                                phi_3873_ = _e4737;
                                            } else {
                                                phi_3873_ = _e4786;
                                            }
                                            let _e4789 = phi_3873_;
                                            if (_e4688 < _e4789) {
                                                phi_3878_ = _e4688;
                                            } else {
                                                phi_3878_ = _e4789;
                                            }
                                            let _e4792 = phi_3878_;
                                            if (_e4792 > _e3994) {
                                                phi_3883_ = _e4792;
                                            } else {
                                                phi_3883_ = _e3994;
                                            }
                                            let _e4795 = phi_3883_;
                                            let _e4796 = (_e4795 > _e3760);
                                            if _e4796 {
                                                phi_3894_ = f64();
                                                phi_3895_ = false;
                                            } else {
                                                if _e4000 {
                                                    phi_3893_ = (_e4325 + _e4325);
                                                } else {
                                                    phi_3893_ = (_e3760 - _e3994);
                                                }
                                                let _e4800 = phi_3893_;
                                                phi_3894_ = _e4800;
                                                phi_3895_ = true;
                                            }
                                            let _e4802 = phi_3894_;
                                            let _e4804 = phi_3895_;
                                            phi_3896_ = _e4795;
                                            phi_3897_ = _e4802;
                                            phi_3898_ = _e4804;
                                            phi_3899_ = _e4796;
                                            phi_3900_ = false;
                                        } else {
                                            phi_3896_ = f64();
                                            phi_3897_ = f64();
                                            phi_3898_ = false;
                                            phi_3899_ = false;
                                            phi_3900_ = true;
                                        }
                                        let _e4806 = phi_3896_;
                                        let _e4808 = phi_3897_;
                                        let _e4810 = phi_3898_;
                                        let _e4812 = phi_3899_;
                                        let _e4814 = phi_3900_;
                                        phi_3901_ = _e4806;
                                        phi_3902_ = _e4808;
                                        phi_3903_ = false;
                                        phi_3904_ = _e4810;
                                        phi_3905_ = _e4812;
                                        phi_3906_ = _e4814;
                                    } else {
                                        phi_3901_ = f64();
                                        phi_3902_ = f64();
                                        phi_3903_ = true;
                                        phi_3904_ = false;
                                        phi_3905_ = false;
                                        phi_3906_ = false;
                                    }
                                    let _e4816 = phi_3901_;
                                    let _e4818 = phi_3902_;
                                    let _e4820 = phi_3903_;
                                    let _e4822 = phi_3904_;
                                    let _e4824 = phi_3905_;
                                    let _e4826 = phi_3906_;
                                    phi_3907_ = _e4816;
                                    phi_3908_ = _e4818;
                                    phi_3909_ = _e4820;
                                    phi_3910_ = _e4822;
                                    phi_3911_ = _e4824;
                                    phi_3912_ = _e4826;
                                } else {
                                    phi_3907_ = f64();
                                    phi_3908_ = f64();
                                    phi_3909_ = true;
                                    phi_3910_ = false;
                                    phi_3911_ = false;
                                    phi_3912_ = false;
                                }
                                let _e4828 = phi_3907_;
                                let _e4830 = phi_3908_;
                                let _e4832 = phi_3909_;
                                let _e4834 = phi_3910_;
                                let _e4836 = phi_3911_;
                                let _e4838 = phi_3912_;
                                if _e4832 {
                                    if (_e3994 <= _e3996) {
                                        let _e5004 = (_e4002 + 1u);
                                        let _e5005 = (_e5004 > 3u);
                                        if _e5005 {
                                            phi_3925_ = false;
                                        } else {
                                            phi_3925_ = true;
                                        }
                                        let _e5007 = phi_3925_;
                                        phi_4252_ = _e5004;
                                        phi_4253_ = f64();
                                        phi_4254_ = false;
                                        phi_4255_ = _e5007;
                                        phi_4256_ = _e5005;
                                    } else {
                                        let _e4842 = local_9.member[0u];
                                        let _e4845 = local_9.member_1[0u];
                                        let _e4848 = local_9.member[0u];
                                        let _e4854 = local_9.member_2[0u];
                                        let _e4855 = ((_e4842 + ((_e4845 - _e4848) * _e3998)) - _e4854);
                                        let _e4858 = local_9.member[1u];
                                        let _e4861 = local_9.member_1[1u];
                                        let _e4864 = local_9.member[1u];
                                        let _e4870 = local_9.member_2[1u];
                                        let _e4871 = ((_e4858 + ((_e4861 - _e4864) * _e3998)) - _e4870);
                                        if (_e4855 < _e4871) {
                                            phi_3998_ = _e4855;
                                        } else {
                                            phi_3998_ = _e4871;
                                        }
                                        let _e4874 = phi_3998_;
                                        let _e4877 = local_9.member[2u];
                                        let _e4880 = local_9.member_1[2u];
                                        let _e4883 = local_9.member[2u];
                                        let _e4889 = local_9.member_2[2u];
                                        let _e4890 = ((_e4877 + ((_e4880 - _e4883) * _e3998)) - _e4889);
                                        let _e4893 = local_9.member[3u];
                                        let _e4896 = local_9.member_1[3u];
                                        let _e4899 = local_9.member[3u];
                                        let _e4905 = local_9.member_2[3u];
                                        let _e4906 = ((_e4893 + ((_e4896 - _e4899) * _e3998)) - _e4905);
                                        if (_e4890 < _e4906) {
                                            phi_4071_ = _e4890;
                                        } else {
                                            phi_4071_ = _e4906;
                                        }
                                        let _e4909 = phi_4071_;
                                        if (_e4874 < _e4909) {
                                            phi_4076_ = _e4874;
                                        } else {
                                            phi_4076_ = _e4909;
                                        }
                                        let _e4912 = phi_4076_;
                                        let _e4915 = local_10.member[0u];
                                        let _e4918 = local_10.member_1[0u];
                                        let _e4921 = local_10.member[0u];
                                        let _e4927 = local_10.member_2[0u];
                                        let _e4928 = ((_e4915 + ((_e4918 - _e4921) * _e3994)) - _e4927);
                                        let _e4931 = local_10.member[1u];
                                        let _e4934 = local_10.member_1[1u];
                                        let _e4937 = local_10.member[1u];
                                        let _e4943 = local_10.member_2[1u];
                                        let _e4944 = ((_e4931 + ((_e4934 - _e4937) * _e3994)) - _e4943);
                                        if (_e4928 < _e4944) {
                                            phi_4149_ = _e4928;
                                        } else {
                                            phi_4149_ = _e4944;
                                        }
                                        let _e4947 = phi_4149_;
                                        let _e4950 = local_10.member[2u];
                                        let _e4953 = local_10.member_1[2u];
                                        let _e4956 = local_10.member[2u];
                                        let _e4962 = local_10.member_2[2u];
                                        let _e4963 = ((_e4950 + ((_e4953 - _e4956) * _e3994)) - _e4962);
                                        let _e4966 = local_10.member[3u];
                                        let _e4969 = local_10.member_1[3u];
                                        let _e4972 = local_10.member[3u];
                                        let _e4978 = local_10.member_2[3u];
                                        let _e4979 = ((_e4966 + ((_e4969 - _e4972) * _e3994)) - _e4978);
                                        if (_e4963 < _e4979) {
                                            phi_4222_ = _e4963;
                                        } else {
                                            phi_4222_ = _e4979;
                                        }
                                        let _e4982 = phi_4222_;
                                        if (_e4947 < _e4982) {
                                            phi_4227_ = _e4947;
                                        } else {
                                            phi_4227_ = _e4982;
                                        }
                                        let _e4985 = phi_4227_;
                                        let _e4986 = f64(0.0625f);
                                        let _e4988 = f64(0.9f);
                                        if (_e4985 > f64(0f)) {
                                            phi_4250_ = f64(0.5f);
                                        } else {
                                            let _e4994 = (f64(0.95f) * (_e4912 / (_e4912 - _e4985)));
                                            if (_e4994 > _e4986) {
                                                if (_e4994 < _e4988) {
                                                    phi_4248_ = _e4994;
                                                } else {
                                                    phi_4248_ = _e4988;
                                                }
                                                let _e4998 = phi_4248_;
                                                phi_4249_ = _e4998;
                                            } else {
                                                phi_4249_ = _e4986;
                                            }
                                            let _e5000 = phi_4249_;
                                            phi_4250_ = _e5000;
                                        }
                                        let _e5002 = phi_4250_;
                                        phi_4252_ = u32();
                                        phi_4253_ = (_e4325 * _e5002);
                                        phi_4254_ = true;
                                        phi_4255_ = false;
                                        phi_4256_ = false;
                                    }
                                    let _e5009 = phi_4252_;
                                    let _e5011 = phi_4253_;
                                    let _e5013 = phi_4254_;
                                    let _e5015 = phi_4255_;
                                    let _e5017 = phi_4256_;
                                    phi_4257_ = _e5009;
                                    phi_4258_ = _e3996;
                                    phi_4259_ = _e5011;
                                    phi_4260_ = _e3998;
                                    phi_4261_ = _e4000;
                                    phi_4262_ = _e4002;
                                    phi_4263_ = _e5013;
                                    phi_4264_ = _e5015;
                                    phi_4265_ = _e5017;
                                    phi_4266_ = false;
                                    phi_4267_ = false;
                                } else {
                                    phi_4257_ = u32();
                                    phi_4258_ = _e4828;
                                    phi_4259_ = _e4830;
                                    phi_4260_ = _e3994;
                                    phi_4261_ = true;
                                    phi_4262_ = 0u;
                                    phi_4263_ = _e4834;
                                    phi_4264_ = false;
                                    phi_4265_ = false;
                                    phi_4266_ = _e4836;
                                    phi_4267_ = _e4838;
                                }
                                let _e5019 = phi_4257_;
                                let _e5021 = phi_4258_;
                                let _e5023 = phi_4259_;
                                let _e5025 = phi_4260_;
                                let _e5027 = phi_4261_;
                                let _e5029 = phi_4262_;
                                let _e5031 = phi_4263_;
                                let _e5033 = phi_4264_;
                                let _e5035 = phi_4265_;
                                let _e5037 = phi_4266_;
                                let _e5039 = phi_4267_;
                                if _e5031 {
                                    let _e5040 = (_e5025 + _e5023);
                                    if (_e5040 > _e5021) {
                                        phi_4276_ = _e5040;
                                    } else {
                                        phi_4276_ = _e5021;
                                    }
                                    let _e5043 = phi_4276_;
                                    if (_e5043 < _e3760) {
                                        phi_4281_ = _e5043;
                                    } else {
                                        phi_4281_ = _e3760;
                                    }
                                    let _e5046 = phi_4281_;
                                    if !(_e4000) {
                                        phi_4291_ = true;
                                    } else {
                                        phi_4291_ = ((_e5046 - _e5025) > f64(0.0000000037252903f));
                                    }
                                    let _e5051 = phi_4291_;
                                    if _e5051 {
                                        phi_4295_ = false;
                                    } else {
                                        phi_4295_ = true;
                                    }
                                    let _e5053 = phi_4295_;
                                    phi_4296_ = _e5046;
                                    phi_4297_ = _e5021;
                                    phi_4298_ = _e5025;
                                    phi_4299_ = _e5027;
                                    phi_4300_ = _e5029;
                                    phi_4301_ = _e5051;
                                    phi_4302_ = _e5053;
                                    phi_4303_ = false;
                                    phi_4304_ = false;
                                    phi_4305_ = false;
                                } else {
                                    phi_4296_ = _e3994;
                                    phi_4297_ = _e3996;
                                    phi_4298_ = _e3998;
                                    phi_4299_ = _e4000;
                                    phi_4300_ = _e5019;
                                    phi_4301_ = _e5033;
                                    phi_4302_ = false;
                                    phi_4303_ = _e5035;
                                    phi_4304_ = _e5037;
                                    phi_4305_ = _e5039;
                                }
                                let _e5055 = phi_4296_;
                                let _e5057 = phi_4297_;
                                let _e5059 = phi_4298_;
                                let _e5061 = phi_4299_;
                                let _e5063 = phi_4300_;
                                let _e5065 = phi_4301_;
                                let _e5067 = phi_4302_;
                                let _e5069 = phi_4303_;
                                let _e5071 = phi_4304_;
                                let _e5073 = phi_4305_;
                                phi_2606_ = _e5055;
                                phi_2608_ = _e5057;
                                phi_2610_ = _e5059;
                                phi_2612_ = _e5061;
                                phi_2614_ = _e5063;
                                phi_4306_ = _e5021;
                                phi_4307_ = _e5065;
                                phi_4308_ = _e5067;
                                phi_4309_ = false;
                                phi_4310_ = _e5069;
                                phi_4311_ = _e5071;
                                phi_4312_ = _e5073;
                            } else {
                                phi_2606_ = f64();
                                phi_2608_ = f64();
                                phi_2610_ = f64();
                                phi_2612_ = bool();
                                phi_2614_ = u32();
                                phi_4306_ = f64();
                                phi_4307_ = false;
                                phi_4308_ = false;
                                phi_4309_ = true;
                                phi_4310_ = false;
                                phi_4311_ = false;
                                phi_4312_ = false;
                            }
                            let _e5075 = phi_2606_;
                            let _e5077 = phi_2608_;
                            let _e5079 = phi_2610_;
                            let _e5081 = phi_2612_;
                            let _e5083 = phi_2614_;
                            let _e5085 = phi_4306_;
                            let _e5087 = phi_4307_;
                            let _e5089 = phi_4308_;
                            let _e5091 = phi_4309_;
                            let _e5093 = phi_4310_;
                            let _e5095 = phi_4311_;
                            let _e5097 = phi_4312_;
                            local_25 = _e5089;
                            local_43 = _e5085;
                            local_45 = _e5091;
                            local_46 = _e5093;
                            local_47 = _e5095;
                            local_48 = _e5097;
                            continue;
                            continuing {
                                phi_2602_ = _e4014;
                                phi_2605_ = _e5075;
                                phi_2607_ = _e5077;
                                phi_2609_ = _e5079;
                                phi_2611_ = _e5081;
                                phi_2613_ = _e5083;
                                break if !(_e5087);
                            }
                        }
                        let _e5100 = local_25;
                        if _e5100 {
                            let _e6425 = local_43;
                            phi_4316_ = _e6425;
                            phi_4317_ = true;
                            phi_4318_ = false;
                            phi_4319_ = false;
                            phi_4320_ = false;
                        } else {
                            let _e6427 = local_44;
                            phi_4316_ = _e6427;
                            let _e6430 = local_45;
                            phi_4317_ = _e6430;
                            let _e6433 = local_46;
                            phi_4318_ = _e6433;
                            let _e6436 = local_47;
                            phi_4319_ = _e6436;
                            let _e6439 = local_48;
                            phi_4320_ = _e6439;
                        }
                        let _e5102 = phi_4316_;
                        let _e5104 = phi_4317_;
                        let _e5106 = phi_4318_;
                        let _e5108 = phi_4319_;
                        let _e5110 = phi_4320_;
                        if _e5104 {
                            phi_4325_ = type_44(1u, _e5102);
                            phi_4326_ = false;
                            phi_4327_ = false;
                            phi_4328_ = false;
                        } else {
                            phi_4325_ = type_44();
                            phi_4326_ = _e5106;
                            phi_4327_ = _e5108;
                            phi_4328_ = _e5110;
                        }
                        let _e5113 = phi_4325_;
                        let _e5115 = phi_4326_;
                        let _e5117 = phi_4327_;
                        let _e5119 = phi_4328_;
                        if _e5115 {
                            let _e5121 = local_26;
                            phi_4333_ = type_44(1u, _e5121);
                            phi_4334_ = false;
                            phi_4335_ = false;
                        } else {
                            phi_4333_ = type_44();
                            phi_4334_ = _e5117;
                            phi_4335_ = _e5119;
                        }
                        let _e5124 = phi_4333_;
                        let _e5126 = phi_4334_;
                        let _e5128 = phi_4335_;
                        if _e5126 {
                            phi_4340_ = type_44(0u, type_44().member_1);
                            phi_4341_ = false;
                            phi_4342_ = true;
                        } else {
                            phi_4340_ = _e5124;
                            phi_4341_ = _e5128;
                            phi_4342_ = _e5115;
                        }
                        let _e5132 = phi_4340_;
                        let _e5134 = phi_4341_;
                        let _e5136 = phi_4342_;
                        if _e5134 {
                            phi_4347_ = type_44(0u, type_44().member_1);
                            phi_4348_ = true;
                        } else {
                            phi_4347_ = _e5132;
                            phi_4348_ = _e5136;
                        }
                        let _e5140 = phi_4347_;
                        let _e5142 = phi_4348_;
                        if _e5142 {
                            phi_4352_ = _e5140;
                        } else {
                            phi_4352_ = _e5113;
                        }
                        let _e5144 = phi_4352_;
                        if (_e5144.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_4366_ = type_9(0u, 3u);
                            loop {
                                let _e5156 = phi_4366_;
                                if (_e5156.member < _e5156.member_1) {
                                    phi_4367_ = type_9((_e5156.member + 1u), _e5156.member_1);
                                    phi_4390_ = type_9(1u, _e5156.member);
                                } else {
                                    phi_4367_ = _e5156;
                                    phi_4390_ = type_9(0u, type_9().member_1);
                                }
                                let _e5168 = phi_4367_;
                                let _e5170 = phi_4390_;
                                if (bitcast<i32>(_e5170.member) != 0i) {
                                    let _e5176 = local_11[_e5170.member_1];
                                    let _e5178 = (_e5144.member_1 + f64(_e5176));
                                    if (_e5178 < _e3760) {
                                        phi_4411_ = _e5178;
                                    } else {
                                        phi_4411_ = _e3760;
                                    }
                                    let _e5181 = phi_4411_;
                                    let _e5184 = local_12.member[0u];
                                    let _e5190 = local_12.member[1u];
                                    let _e5206 = local_12.member_1[0u];
                                    let _e5212 = local_12.member_1[1u];
                                    let _e5228 = local_12.member_2[0u];
                                    let _e5234 = local_12.member_2[1u];
                                    let _e5248 = function_2(array<f64, 3>((_e5184[0] + ((_e5190[0] - _e5184[0]) * _e5181)), (_e5184[1] + ((_e5190[1] - _e5184[1]) * _e5181)), (_e5184[2] + ((_e5190[2] - _e5184[2]) * _e5181))), array<f64, 3>((_e5206[0] + ((_e5212[0] - _e5206[0]) * _e5181)), (_e5206[1] + ((_e5212[1] - _e5206[1]) * _e5181)), (_e5206[2] + ((_e5212[2] - _e5206[2]) * _e5181))), array<f64, 3>((_e5228[0] + ((_e5234[0] - _e5228[0]) * _e5181)), (_e5228[1] + ((_e5234[1] - _e5228[1]) * _e5181)), (_e5228[2] + ((_e5234[2] - _e5228[2]) * _e5181))), 0u);
                                    let _e5259 = (((_e5248[0] * _e5248[0]) + (_e5248[1] * _e5248[1])) + (_e5248[2] * _e5248[2]));
                                    if (_e5259 <= 2.2250738585072014e-308lf) {
                                        if (_e5259 > 0.0lf) {
                                            phi_4534_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_4534_ = 0.0lf;
                                        }
                                        let _e5311 = phi_4534_;
                                        phi_4598_ = _e5311;
                                    } else {
                                        phi_4541_ = type_16(0i, 5i);
                                        phi_4544_ = bitcast<f64>(((bitcast<u64>(_e5259) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5266 = phi_4541_;
                                            let _e5268 = phi_4544_;
                                            local_27 = _e5268;
                                            if (_e5266.member < _e5266.member_1) {
                                                let _e5275 = (_e5266.member + 1i);
                                                if ((false == (_e5275 > _e5266.member)) != false) {
                                                    phi_4565_ = true;
                                                } else {
                                                    phi_4565_ = false;
                                                }
                                                let _e5280 = phi_4565_;
                                                if _e5280 {
                                                    phi_4571_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4571_ = type_17(1u, _e5275);
                                                }
                                                let _e5285 = phi_4571_;
                                                phi_4542_ = type_16(_e5285.member_1, _e5266.member_1);
                                                phi_4585_ = type_17(1u, _e5266.member);
                                            } else {
                                                phi_4542_ = _e5266;
                                                phi_4585_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5291 = phi_4542_;
                                            let _e5293 = phi_4585_;
                                            let _e5296 = (bitcast<i32>(_e5293.member) != 0i);
                                            if _e5296 {
                                                phi_4545_ = (0.5lf * (_e5268 + (_e5259 / _e5268)));
                                            } else {
                                                phi_4545_ = f64();
                                            }
                                            let _e5301 = phi_4545_;
                                            continue;
                                            continuing {
                                                phi_4541_ = _e5291;
                                                phi_4544_ = _e5301;
                                                break if !(_e5296);
                                            }
                                        }
                                        let _e5306 = local_27;
                                        phi_4598_ = (_e5306 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5313 = phi_4598_;
                                    let _e5321 = local_12.member[0u];
                                    if (_e5321[0] < 0.0lf) {
                                        phi_4616_ = -(_e5321[0]);
                                    } else {
                                        phi_4616_ = _e5321[0];
                                    }
                                    let _e5328 = phi_4616_;
                                    if (_e5321[1] < 0.0lf) {
                                        phi_4623_ = -(_e5321[1]);
                                    } else {
                                        phi_4623_ = _e5321[1];
                                    }
                                    let _e5332 = phi_4623_;
                                    if (_e5328 > _e5332) {
                                        phi_4628_ = _e5328;
                                    } else {
                                        phi_4628_ = _e5332;
                                    }
                                    let _e5335 = phi_4628_;
                                    if (_e5321[2] < 0.0lf) {
                                        phi_4635_ = -(_e5321[2]);
                                    } else {
                                        phi_4635_ = _e5321[2];
                                    }
                                    let _e5339 = phi_4635_;
                                    if (_e5335 > _e5339) {
                                        phi_4640_ = _e5335;
                                    } else {
                                        phi_4640_ = _e5339;
                                    }
                                    let _e5342 = phi_4640_;
                                    let _e5345 = local_12.member[1u];
                                    if (_e5345[0] < 0.0lf) {
                                        phi_4653_ = -(_e5345[0]);
                                    } else {
                                        phi_4653_ = _e5345[0];
                                    }
                                    let _e5352 = phi_4653_;
                                    if (_e5345[1] < 0.0lf) {
                                        phi_4660_ = -(_e5345[1]);
                                    } else {
                                        phi_4660_ = _e5345[1];
                                    }
                                    let _e5356 = phi_4660_;
                                    if (_e5352 > _e5356) {
                                        phi_4665_ = _e5352;
                                    } else {
                                        phi_4665_ = _e5356;
                                    }
                                    let _e5359 = phi_4665_;
                                    if (_e5345[2] < 0.0lf) {
                                        phi_4672_ = -(_e5345[2]);
                                    } else {
                                        phi_4672_ = _e5345[2];
                                    }
                                    let _e5363 = phi_4672_;
                                    if (_e5359 > _e5363) {
                                        phi_4677_ = _e5359;
                                    } else {
                                        phi_4677_ = _e5363;
                                    }
                                    let _e5366 = phi_4677_;
                                    if (_e5342 > _e5366) {
                                        phi_4682_ = _e5342;
                                    } else {
                                        phi_4682_ = _e5366;
                                    }
                                    let _e5369 = phi_4682_;
                                    let _e5371 = local_12.member_3;
                                    let _e5375 = local_12.member_1[0u];
                                    if (_e5375[0] < 0.0lf) {
                                        phi_4699_ = -(_e5375[0]);
                                    } else {
                                        phi_4699_ = _e5375[0];
                                    }
                                    let _e5382 = phi_4699_;
                                    if (_e5375[1] < 0.0lf) {
                                        phi_4706_ = -(_e5375[1]);
                                    } else {
                                        phi_4706_ = _e5375[1];
                                    }
                                    let _e5386 = phi_4706_;
                                    if (_e5382 > _e5386) {
                                        phi_4711_ = _e5382;
                                    } else {
                                        phi_4711_ = _e5386;
                                    }
                                    let _e5389 = phi_4711_;
                                    if (_e5375[2] < 0.0lf) {
                                        phi_4718_ = -(_e5375[2]);
                                    } else {
                                        phi_4718_ = _e5375[2];
                                    }
                                    let _e5393 = phi_4718_;
                                    if (_e5389 > _e5393) {
                                        phi_4723_ = _e5389;
                                    } else {
                                        phi_4723_ = _e5393;
                                    }
                                    let _e5396 = phi_4723_;
                                    let _e5399 = local_12.member_1[1u];
                                    if (_e5399[0] < 0.0lf) {
                                        phi_4737_ = -(_e5399[0]);
                                    } else {
                                        phi_4737_ = _e5399[0];
                                    }
                                    let _e5406 = phi_4737_;
                                    if (_e5399[1] < 0.0lf) {
                                        phi_4744_ = -(_e5399[1]);
                                    } else {
                                        phi_4744_ = _e5399[1];
                                    }
                                    let _e5410 = phi_4744_;
                                    if (_e5406 > _e5410) {
                                        phi_4749_ = _e5406;
                                    } else {
                                        phi_4749_ = _e5410;
                                    }
                                    let _e5413 = phi_4749_;
                                    if (_e5399[2] < 0.0lf) {
                                        phi_4756_ = -(_e5399[2]);
                                    } else {
                                        phi_4756_ = _e5399[2];
                                    }
                                    let _e5417 = phi_4756_;
                                    if (_e5413 > _e5417) {
                                        phi_4761_ = _e5413;
                                    } else {
                                        phi_4761_ = _e5417;
                                    }
                                    let _e5420 = phi_4761_;
                                    if (_e5396 > _e5420) {
                                        phi_4766_ = _e5396;
                                    } else {
                                        phi_4766_ = _e5420;
                                    }
                                    let _e5423 = phi_4766_;
                                    let _e5425 = local_12.member_3;
                                    let _e5429 = local_12.member_2[0u];
                                    if (_e5429[0] < 0.0lf) {
                                        phi_4783_ = -(_e5429[0]);
                                    } else {
                                        phi_4783_ = _e5429[0];
                                    }
                                    let _e5436 = phi_4783_;
                                    if (_e5429[1] < 0.0lf) {
                                        phi_4790_ = -(_e5429[1]);
                                    } else {
                                        phi_4790_ = _e5429[1];
                                    }
                                    let _e5440 = phi_4790_;
                                    if (_e5436 > _e5440) {
                                        phi_4795_ = _e5436;
                                    } else {
                                        phi_4795_ = _e5440;
                                    }
                                    let _e5443 = phi_4795_;
                                    if (_e5429[2] < 0.0lf) {
                                        phi_4802_ = -(_e5429[2]);
                                    } else {
                                        phi_4802_ = _e5429[2];
                                    }
                                    let _e5447 = phi_4802_;
                                    if (_e5443 > _e5447) {
                                        phi_4807_ = _e5443;
                                    } else {
                                        phi_4807_ = _e5447;
                                    }
                                    let _e5450 = phi_4807_;
                                    let _e5453 = local_12.member_2[1u];
                                    if (_e5453[0] < 0.0lf) {
                                        phi_4821_ = -(_e5453[0]);
                                    } else {
                                        phi_4821_ = _e5453[0];
                                    }
                                    let _e5460 = phi_4821_;
                                    if (_e5453[1] < 0.0lf) {
                                        phi_4828_ = -(_e5453[1]);
                                    } else {
                                        phi_4828_ = _e5453[1];
                                    }
                                    let _e5464 = phi_4828_;
                                    if (_e5460 > _e5464) {
                                        phi_4833_ = _e5460;
                                    } else {
                                        phi_4833_ = _e5464;
                                    }
                                    let _e5467 = phi_4833_;
                                    if (_e5453[2] < 0.0lf) {
                                        phi_4840_ = -(_e5453[2]);
                                    } else {
                                        phi_4840_ = _e5453[2];
                                    }
                                    let _e5471 = phi_4840_;
                                    if (_e5467 > _e5471) {
                                        phi_4845_ = _e5467;
                                    } else {
                                        phi_4845_ = _e5471;
                                    }
                                    let _e5474 = phi_4845_;
                                    if (_e5450 > _e5474) {
                                        phi_4850_ = _e5450;
                                    } else {
                                        phi_4850_ = _e5474;
                                    }
                                    let _e5477 = phi_4850_;
                                    let _e5479 = local_12.member_3;
                                    let _e5487 = local_12.member_3;
                                    let _e5497 = (((_e5313 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5369 + _e5371) + (_e5423 + _e5425)) + (_e5477 + _e5479)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5487 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e575.member_1);
                                    if _e5497 {
                                        phi_4874_ = false;
                                    } else {
                                        phi_4874_ = true;
                                    }
                                    let _e5499 = phi_4874_;
                                    phi_4875_ = _e5499;
                                    phi_4876_ = _e5497;
                                } else {
                                    phi_4875_ = false;
                                    phi_4876_ = false;
                                }
                                let _e5501 = phi_4875_;
                                let _e5503 = phi_4876_;
                                local_28 = _e5503;
                                continue;
                                continuing {
                                    phi_4366_ = _e5168;
                                    break if !(_e5501);
                                }
                            }
                            let _e5506 = local_28;
                            if _e5506 {
                                phi_4881_ = type_44(1u, _e5144.member_1);
                                phi_4882_ = false;
                            } else {
                                phi_4881_ = type_44();
                                phi_4882_ = true;
                            }
                            let _e5509 = phi_4881_;
                            let _e5511 = phi_4882_;
                            if _e5511 {
                                phi_4887_ = type_44(2u, _e5144.member_1);
                                phi_4888_ = false;
                            } else {
                                phi_4887_ = type_44();
                                phi_4888_ = true;
                            }
                            let _e5514 = phi_4887_;
                            let _e5516 = phi_4888_;
                            phi_4890_ = _e5514;
                            phi_4891_ = _e5509;
                            phi_4892_ = _e5516;
                        } else {
                            phi_4890_ = type_44();
                            phi_4891_ = type_44(0u, type_44().member_1);
                            phi_4892_ = true;
                        }
                        let _e5518 = phi_4890_;
                        let _e5520 = phi_4891_;
                        let _e5522 = phi_4892_;
                        if _e5522 {
                            phi_4896_ = _e5520;
                        } else {
                            phi_4896_ = _e5518;
                        }
                        let _e5524 = phi_4896_;
                        phi_8909_ = _e5524;
                    } else {
                        if (_e713 < 0.0lf) {
                            phi_4907_ = -(_e713);
                        } else {
                            phi_4907_ = _e713;
                        }
                        let _e1070 = phi_4907_;
                        if (_e736 < 0.0lf) {
                            phi_4913_ = -(_e736);
                        } else {
                            phi_4913_ = _e736;
                        }
                        let _e1074 = phi_4913_;
                        if (_e1070 > _e1074) {
                            phi_4918_ = _e1070;
                        } else {
                            phi_4918_ = _e1074;
                        }
                        let _e1077 = phi_4918_;
                        if (_e759 < 0.0lf) {
                            phi_4924_ = -(_e759);
                        } else {
                            phi_4924_ = _e759;
                        }
                        let _e1081 = phi_4924_;
                        if (_e770 < 0.0lf) {
                            phi_4930_ = -(_e770);
                        } else {
                            phi_4930_ = _e770;
                        }
                        let _e1085 = phi_4930_;
                        if (_e1081 > _e1085) {
                            phi_4935_ = _e1081;
                        } else {
                            phi_4935_ = _e1085;
                        }
                        let _e1088 = phi_4935_;
                        if (_e1077 > _e1088) {
                            phi_4940_ = _e1077;
                        } else {
                            phi_4940_ = _e1088;
                        }
                        let _e1091 = phi_4940_;
                        let _e1093 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1094 = f64(1f);
                        if (_e1091 >= _e1093) {
                            phi_4950_ = (_e1091 <= (_e1094 / _e1093));
                        } else {
                            phi_4950_ = false;
                        }
                        let _e1099 = phi_4950_;
                        if _e1099 {
                            phi_4957_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4957_ = f64(2f);
                        }
                        let _e1104 = phi_4957_;
                        let _e1106 = ((_e1029 * f64(0.34f)) + (_e1091 * _e1104));
                        if _e1099 {
                            phi_4965_ = (_e1094 / _e1091);
                        } else {
                            phi_4965_ = f64(0f);
                        }
                        let _e1110 = phi_4965_;
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
                                    phi_5001_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_5001_ = 0.0lf;
                                }
                                let _e1181 = phi_5001_;
                                phi_5065_ = _e1181;
                            } else {
                                phi_5008_ = type_16(0i, 5i);
                                phi_5011_ = bitcast<f64>(((bitcast<u64>(_e1128) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1136 = phi_5008_;
                                    let _e1138 = phi_5011_;
                                    local_13 = _e1138;
                                    if (_e1136.member < _e1136.member_1) {
                                        let _e1145 = (_e1136.member + 1i);
                                        if ((false == (_e1145 > _e1136.member)) != false) {
                                            phi_5032_ = true;
                                        } else {
                                            phi_5032_ = false;
                                        }
                                        let _e1150 = phi_5032_;
                                        if _e1150 {
                                            phi_5038_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_5038_ = type_17(1u, _e1145);
                                        }
                                        let _e1155 = phi_5038_;
                                        phi_5009_ = type_16(_e1155.member_1, _e1136.member_1);
                                        phi_5052_ = type_17(1u, _e1136.member);
                                    } else {
                                        phi_5009_ = _e1136;
                                        phi_5052_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1161 = phi_5009_;
                                    let _e1163 = phi_5052_;
                                    let _e1166 = (bitcast<i32>(_e1163.member) != 0i);
                                    if _e1166 {
                                        phi_5012_ = (0.5lf * (_e1138 + (_e1128 / _e1138)));
                                    } else {
                                        phi_5012_ = f64();
                                    }
                                    let _e1171 = phi_5012_;
                                    continue;
                                    continuing {
                                        phi_5008_ = _e1161;
                                        phi_5011_ = _e1171;
                                        break if !(_e1166);
                                    }
                                }
                                let _e1176 = local_13;
                                phi_5065_ = (_e1176 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1183 = phi_5065_;
                            if (_e1120 < _e1111) {
                                phi_5071_ = -(_e1183);
                            } else {
                                phi_5071_ = _e1183;
                            }
                            let _e1187 = phi_5071_;
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
                            phi_5096_ = type_9(0u, 2u);
                            phi_5099_ = 1u;
                            loop {
                                let _e1208 = phi_5096_;
                                let _e1210 = phi_5099_;
                                local_29 = _e1210;
                                if (_e1208.member < _e1208.member_1) {
                                    phi_5097_ = type_9((_e1208.member + 1u), _e1208.member_1);
                                    phi_5122_ = type_9(1u, _e1208.member);
                                } else {
                                    phi_5097_ = _e1208;
                                    phi_5122_ = type_9(0u, type_9().member_1);
                                }
                                let _e1222 = phi_5097_;
                                let _e1224 = phi_5122_;
                                let _e1228 = (bitcast<i32>(_e1224.member) != 0i);
                                if _e1228 {
                                    let _e1230 = local_7[_e1224.member_1];
                                    if (_e1230 > _e1111) {
                                        let _e1233 = local_7[_e1224.member_1];
                                        if (_e1233 < _e1112) {
                                            let _e1236 = local_7[_e1224.member_1];
                                            local_6[_e1210] = _e1236;
                                            phi_5166_ = (_e1210 + 1u);
                                        } else {
                                            phi_5166_ = _e1210;
                                        }
                                        let _e1240 = phi_5166_;
                                        phi_5167_ = _e1240;
                                    } else {
                                        phi_5167_ = _e1210;
                                    }
                                    let _e1242 = phi_5167_;
                                    phi_5100_ = _e1242;
                                } else {
                                    phi_5100_ = u32();
                                }
                                let _e1244 = phi_5100_;
                                continue;
                                continuing {
                                    phi_5096_ = _e1222;
                                    phi_5099_ = _e1244;
                                    break if !(_e1228);
                                }
                            }
                            let _e5750 = local_29;
                            phi_5168_ = _e5750;
                        } else {
                            phi_5168_ = 1u;
                        }
                        let _e1247 = phi_5168_;
                        local_6[_e1247] = _e1112;
                        let _e1249 = local_6;
                        local_8 = _e1249;
                        phi_5188_ = type_9(0u, _e1247);
                        loop {
                            let _e1252 = phi_5188_;
                            if (_e1252.member < _e1252.member_1) {
                                phi_5189_ = type_9((_e1252.member + 1u), _e1252.member_1);
                                phi_5212_ = type_9(1u, _e1252.member);
                            } else {
                                phi_5189_ = _e1252;
                                phi_5212_ = type_9(0u, type_9().member_1);
                            }
                            let _e1264 = phi_5189_;
                            let _e1266 = phi_5212_;
                            if (bitcast<i32>(_e1266.member) != 0i) {
                                let _e1272 = local_8[_e1266.member_1];
                                let _e1275 = local_8[(_e1266.member_1 + 1u)];
                                let _e1277 = (f64(1f) - _e1272);
                                let _e1288 = ((((_e713 * _e1277) + (_e736 * _e1272)) * (_e1277 * _e1277)) + (((_e759 * _e1277) + (_e770 * _e1272)) * (_e1272 * _e1272)));
                                let _e1290 = (f64(1f) - _e1275);
                                let _e1301 = ((((_e713 * _e1290) + (_e736 * _e1275)) * (_e1290 * _e1290)) + (((_e759 * _e1290) + (_e770 * _e1275)) * (_e1275 * _e1275)));
                                if (_e1288 < 0.0lf) {
                                    phi_5266_ = -(_e1288);
                                } else {
                                    phi_5266_ = _e1288;
                                }
                                let _e1305 = phi_5266_;
                                let _e1306 = (_e1305 > _e1106);
                                if (_e1301 < 0.0lf) {
                                    phi_5273_ = -(_e1301);
                                } else {
                                    phi_5273_ = _e1301;
                                }
                                let _e1310 = phi_5273_;
                                let _e1311 = (_e1310 > _e1106);
                                let _e1312 = f64(0f);
                                if _e1306 {
                                    if _e1311 {
                                        phi_5285_ = ((_e1288 > _e1312) != (_e1301 > _e1312));
                                        phi_5286_ = false;
                                    } else {
                                        phi_5285_ = bool();
                                        phi_5286_ = true;
                                    }
                                    let _e1317 = phi_5285_;
                                    let _e1319 = phi_5286_;
                                    phi_5287_ = _e1317;
                                    phi_5288_ = _e1319;
                                } else {
                                    phi_5287_ = bool();
                                    phi_5288_ = true;
                                }
                                let _e1321 = phi_5287_;
                                let _e1323 = phi_5288_;
                                if _e1323 {
                                    phi_5292_ = false;
                                } else {
                                    phi_5292_ = _e1321;
                                }
                                let _e1325 = phi_5292_;
                                if _e1306 {
                                    if _e1311 {
                                        if _e1325 {
                                            phi_5304_ = type_45();
                                        } else {
                                            phi_5304_ = type_45(f64(1f), _e1312, _e1325);
                                        }
                                        let _e1329 = phi_5304_;
                                        phi_5305_ = _e1329;
                                        phi_5306_ = _e1325;
                                    } else {
                                        phi_5305_ = type_45();
                                        phi_5306_ = true;
                                    }
                                    let _e1331 = phi_5305_;
                                    let _e1333 = phi_5306_;
                                    phi_5307_ = _e1331;
                                    phi_5308_ = _e1333;
                                } else {
                                    phi_5307_ = type_45();
                                    phi_5308_ = true;
                                }
                                let _e1335 = phi_5307_;
                                let _e1337 = phi_5308_;
                                if _e1337 {
                                    if _e1306 {
                                        if (_e1288 < _e1312) {
                                            phi_5321_ = f64(-1f);
                                        } else {
                                            phi_5321_ = f64(1f);
                                        }
                                        let _e1342 = phi_5321_;
                                        let _e1343 = f64(0.00000000000022737368f);
                                        let _e1344 = f64(0.5f);
                                        let _e1345 = f64(3f);
                                        let _e1348 = (_e759 - _e736);
                                        phi_5334_ = type_9(0u, 64u);
                                        phi_5337_ = _e1275;
                                        phi_5339_ = _e1272;
                                        phi_5341_ = (_e1344 * (_e1272 + _e1275));
                                        loop {
                                            let _e1354 = phi_5334_;
                                            let _e1356 = phi_5337_;
                                            let _e1358 = phi_5339_;
                                            let _e1360 = phi_5341_;
                                            local_31 = _e1358;
                                            if (_e1354.member < _e1354.member_1) {
                                                phi_5335_ = type_9((_e1354.member + 1u), _e1354.member_1);
                                                phi_5364_ = type_9(1u, _e1354.member);
                                            } else {
                                                phi_5335_ = _e1354;
                                                phi_5364_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1372 = phi_5335_;
                                            let _e1374 = phi_5364_;
                                            if (bitcast<i32>(_e1374.member) != 0i) {
                                                let _e1379 = (f64(1f) - _e1360);
                                                let _e1392 = ((_e1342 * ((((_e713 * _e1379) + (_e736 * _e1360)) * (_e1379 * _e1379)) + (((_e759 * _e1379) + (_e770 * _e1360)) * (_e1360 * _e1360)))) - _e1106);
                                                if (_e1392 > f64(0f)) {
                                                    phi_5391_ = _e1356;
                                                    phi_5392_ = _e1360;
                                                } else {
                                                    phi_5391_ = _e1360;
                                                    phi_5392_ = _e1358;
                                                }
                                                let _e1396 = phi_5391_;
                                                let _e1398 = phi_5392_;
                                                let _e1400 = ((_e1396 - _e1398) > _e1343);
                                                if _e1400 {
                                                    let _e1402 = (f64(1f) - _e1360);
                                                    let _e1414 = (-(_e1392) / (_e1342 * (((((_e736 - (_e1345 * _e713)) * _e1402) + (_e1348 * _e1360)) * _e1402) + (((_e1348 * _e1402) + (((_e1345 * _e770) - _e759) * _e1360)) * _e1360))));
                                                    if (_e1392 > f64(0f)) {
                                                        phi_5420_ = (_e1344 * _e1343);
                                                    } else {
                                                        phi_5420_ = -((_e1344 * _e1343));
                                                    }
                                                    let _e1421 = phi_5420_;
                                                    let _e1423 = ((_e1360 + _e1414) + _e1421);
                                                    if (_e1423 > _e1398) {
                                                        if (_e1423 < _e1396) {
                                                            if (_e1414 < 0.0lf) {
                                                                phi_5436_ = -(_e1414);
                                                            } else {
                                                                phi_5436_ = _e1414;
                                                            }
                                                            let _e1429 = phi_5436_;
                                                            if (_e1429 < (_e1344 * (_e1396 - _e1398))) {
                                                                phi_5443_ = false;
                                                            } else {
                                                                phi_5443_ = true;
                                                            }
                                                            let _e1434 = phi_5443_;
                                                            phi_5444_ = _e1434;
                                                        } else {
                                                            phi_5444_ = true;
                                                        }
                                                        let _e1436 = phi_5444_;
                                                        phi_5445_ = _e1436;
                                                    } else {
                                                        phi_5445_ = true;
                                                    }
                                                    let _e1438 = phi_5445_;
                                                    if _e1438 {
                                                        phi_5451_ = (_e1344 * (_e1398 + _e1396));
                                                    } else {
                                                        phi_5451_ = _e1423;
                                                    }
                                                    let _e1442 = phi_5451_;
                                                    phi_5452_ = _e1442;
                                                    phi_5453_ = false;
                                                } else {
                                                    phi_5452_ = f64();
                                                    phi_5453_ = true;
                                                }
                                                let _e1444 = phi_5452_;
                                                let _e1446 = phi_5453_;
                                                phi_5338_ = _e1396;
                                                phi_5340_ = _e1398;
                                                phi_5342_ = _e1444;
                                                phi_5454_ = _e1398;
                                                phi_5455_ = _e1400;
                                                phi_5456_ = _e1446;
                                            } else {
                                                phi_5338_ = f64();
                                                phi_5340_ = f64();
                                                phi_5342_ = f64();
                                                phi_5454_ = f64();
                                                phi_5455_ = false;
                                                phi_5456_ = false;
                                            }
                                            let _e1448 = phi_5338_;
                                            let _e1450 = phi_5340_;
                                            let _e1452 = phi_5342_;
                                            let _e1454 = phi_5454_;
                                            let _e1456 = phi_5455_;
                                            let _e1458 = phi_5456_;
                                            local_14 = _e1458;
                                            local_30 = _e1454;
                                            continue;
                                            continuing {
                                                phi_5334_ = _e1372;
                                                phi_5337_ = _e1448;
                                                phi_5339_ = _e1450;
                                                phi_5341_ = _e1452;
                                                break if !(_e1456);
                                            }
                                        }
                                        let _e1461 = local_14;
                                        if _e1461 {
                                            let _e5792 = local_30;
                                            phi_5460_ = _e5792;
                                        } else {
                                            let _e5794 = local_31;
                                            phi_5460_ = _e5794;
                                        }
                                        let _e1463 = phi_5460_;
                                        phi_5461_ = _e1463;
                                    } else {
                                        phi_5461_ = _e1272;
                                    }
                                    let _e1465 = phi_5461_;
                                    if _e1311 {
                                        if (_e1301 < _e1312) {
                                            phi_5471_ = f64(-1f);
                                        } else {
                                            phi_5471_ = f64(1f);
                                        }
                                        let _e1470 = phi_5471_;
                                        phi_5476_ = type_9(0u, 64u);
                                        phi_5479_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1474 = phi_5476_;
                                            let _e1476 = phi_5479_;
                                            if (_e1474.member < _e1474.member_1) {
                                                phi_5477_ = type_9((_e1474.member + 1u), _e1474.member_1);
                                                phi_5502_ = type_9(1u, _e1474.member);
                                            } else {
                                                phi_5477_ = _e1474;
                                                phi_5502_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1488 = phi_5477_;
                                            let _e1490 = phi_5502_;
                                            if (bitcast<i32>(_e1490.member) != 0i) {
                                                let _e1494 = (_e1465 + _e1476);
                                                if (_e1494 < _e1275) {
                                                    let _e1497 = (f64(1f) - _e1494);
                                                    let _e1510 = ((_e1470 * ((((_e713 * _e1497) + (_e736 * _e1494)) * (_e1497 * _e1497)) + (((_e759 * _e1497) + (_e770 * _e1494)) * (_e1494 * _e1494)))) > _e1106);
                                                    if _e1510 {
                                                        phi_5533_ = f64();
                                                        phi_5534_ = false;
                                                    } else {
                                                        phi_5533_ = (_e1476 + _e1476);
                                                        phi_5534_ = true;
                                                    }
                                                    let _e1513 = phi_5533_;
                                                    let _e1515 = phi_5534_;
                                                    phi_5535_ = _e1513;
                                                    phi_5536_ = _e1515;
                                                    phi_5537_ = _e1510;
                                                    phi_5538_ = false;
                                                } else {
                                                    phi_5535_ = f64();
                                                    phi_5536_ = false;
                                                    phi_5537_ = false;
                                                    phi_5538_ = true;
                                                }
                                                let _e1517 = phi_5535_;
                                                let _e1519 = phi_5536_;
                                                let _e1521 = phi_5537_;
                                                let _e1523 = phi_5538_;
                                                phi_5539_ = _e1494;
                                                phi_5480_ = _e1517;
                                                phi_5540_ = _e1519;
                                                phi_5541_ = _e1521;
                                                phi_5542_ = _e1523;
                                                phi_5543_ = false;
                                            } else {
                                                phi_5539_ = f64();
                                                phi_5480_ = f64();
                                                phi_5540_ = false;
                                                phi_5541_ = false;
                                                phi_5542_ = false;
                                                phi_5543_ = true;
                                            }
                                            let _e1525 = phi_5539_;
                                            let _e1527 = phi_5480_;
                                            let _e1529 = phi_5540_;
                                            let _e1531 = phi_5541_;
                                            let _e1533 = phi_5542_;
                                            let _e1535 = phi_5543_;
                                            local_15 = _e1531;
                                            local_32 = _e1533;
                                            local_33 = _e1535;
                                            local_34 = _e1525;
                                            continue;
                                            continuing {
                                                phi_5476_ = _e1488;
                                                phi_5479_ = _e1527;
                                                break if !(_e1529);
                                            }
                                        }
                                        let _e1538 = local_15;
                                        if _e1538 {
                                            phi_5547_ = false;
                                            phi_5548_ = false;
                                        } else {
                                            let _e5816 = local_32;
                                            phi_5547_ = _e5816;
                                            let _e5819 = local_33;
                                            phi_5548_ = _e5819;
                                        }
                                        let _e1540 = phi_5547_;
                                        let _e1542 = phi_5548_;
                                        if _e1540 {
                                            phi_5552_ = true;
                                        } else {
                                            phi_5552_ = _e1542;
                                        }
                                        let _e1544 = phi_5552_;
                                        if _e1544 {
                                            phi_5556_ = _e1275;
                                        } else {
                                            let _e5823 = local_34;
                                            phi_5556_ = _e5823;
                                        }
                                        let _e1546 = phi_5556_;
                                        phi_5557_ = _e1546;
                                    } else {
                                        phi_5557_ = _e1275;
                                    }
                                    let _e1548 = phi_5557_;
                                    phi_5559_ = type_45(_e1465, _e1548, _e1325);
                                } else {
                                    phi_5559_ = _e1335;
                                }
                                let _e1551 = phi_5559_;
                                if (_e1551.member > _e1551.member_1) {
                                    phi_8865_ = f64();
                                    phi_8866_ = true;
                                    phi_8867_ = false;
                                    phi_8868_ = false;
                                    phi_8869_ = false;
                                } else {
                                    let _e1559 = ((_e1551.member_1 - _e1551.member) * f64(0.5f));
                                    let _e1560 = (_e1551.member + _e1559);
                                    let _e1563 = (_e1559 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1565 = local_12.member_3;
                                    let _e1568 = local_12.member[0u];
                                    if (_e1568[0] < 0.0lf) {
                                        phi_5590_ = -(_e1568[0]);
                                    } else {
                                        phi_5590_ = _e1568[0];
                                    }
                                    let _e1575 = phi_5590_;
                                    if (_e1568[1] < 0.0lf) {
                                        phi_5597_ = -(_e1568[1]);
                                    } else {
                                        phi_5597_ = _e1568[1];
                                    }
                                    let _e1579 = phi_5597_;
                                    if (_e1575 > _e1579) {
                                        phi_5602_ = _e1575;
                                    } else {
                                        phi_5602_ = _e1579;
                                    }
                                    let _e1582 = phi_5602_;
                                    if (_e1568[2] < 0.0lf) {
                                        phi_5609_ = -(_e1568[2]);
                                    } else {
                                        phi_5609_ = _e1568[2];
                                    }
                                    let _e1586 = phi_5609_;
                                    if (_e1582 > _e1586) {
                                        phi_5614_ = _e1582;
                                    } else {
                                        phi_5614_ = _e1586;
                                    }
                                    let _e1589 = phi_5614_;
                                    let _e1591 = local_12.member[1u];
                                    if (_e1591[0] < 0.0lf) {
                                        phi_5627_ = -(_e1591[0]);
                                    } else {
                                        phi_5627_ = _e1591[0];
                                    }
                                    let _e1598 = phi_5627_;
                                    if (_e1591[1] < 0.0lf) {
                                        phi_5634_ = -(_e1591[1]);
                                    } else {
                                        phi_5634_ = _e1591[1];
                                    }
                                    let _e1602 = phi_5634_;
                                    if (_e1598 > _e1602) {
                                        phi_5639_ = _e1598;
                                    } else {
                                        phi_5639_ = _e1602;
                                    }
                                    let _e1605 = phi_5639_;
                                    if (_e1591[2] < 0.0lf) {
                                        phi_5646_ = -(_e1591[2]);
                                    } else {
                                        phi_5646_ = _e1591[2];
                                    }
                                    let _e1609 = phi_5646_;
                                    if (_e1605 > _e1609) {
                                        phi_5651_ = _e1605;
                                    } else {
                                        phi_5651_ = _e1609;
                                    }
                                    let _e1612 = phi_5651_;
                                    if (_e1589 > _e1612) {
                                        phi_5656_ = _e1589;
                                    } else {
                                        phi_5656_ = _e1612;
                                    }
                                    let _e1615 = phi_5656_;
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
                                        phi_5715_ = -(_e1646);
                                    } else {
                                        phi_5715_ = _e1646;
                                    }
                                    let _e1652 = phi_5715_;
                                    if (_e1647 < 0.0lf) {
                                        phi_5721_ = -(_e1647);
                                    } else {
                                        phi_5721_ = _e1647;
                                    }
                                    let _e1656 = phi_5721_;
                                    if (_e1652 > _e1656) {
                                        phi_5726_ = _e1652;
                                    } else {
                                        phi_5726_ = _e1656;
                                    }
                                    let _e1659 = phi_5726_;
                                    if (_e1648 < 0.0lf) {
                                        phi_5732_ = -(_e1648);
                                    } else {
                                        phi_5732_ = _e1648;
                                    }
                                    let _e1663 = phi_5732_;
                                    if (_e1659 > _e1663) {
                                        phi_5737_ = _e1659;
                                    } else {
                                        phi_5737_ = _e1663;
                                    }
                                    let _e1666 = phi_5737_;
                                    let _e1674 = ((((_e1563 * _e1666) * f64(1.01f)) + ((_e1615 + _e1565) * (1.1102230246251565e-16lf * f64(8f)))) + _e1565);
                                    if (_e1633 < 0.0lf) {
                                        phi_5751_ = -(_e1633);
                                    } else {
                                        phi_5751_ = _e1633;
                                    }
                                    let _e1678 = phi_5751_;
                                    if (_e1634 < 0.0lf) {
                                        phi_5757_ = -(_e1634);
                                    } else {
                                        phi_5757_ = _e1634;
                                    }
                                    let _e1682 = phi_5757_;
                                    if (_e1678 > _e1682) {
                                        phi_5762_ = _e1678;
                                    } else {
                                        phi_5762_ = _e1682;
                                    }
                                    let _e1685 = phi_5762_;
                                    if (_e1635 < 0.0lf) {
                                        phi_5768_ = -(_e1635);
                                    } else {
                                        phi_5768_ = _e1635;
                                    }
                                    let _e1689 = phi_5768_;
                                    if (_e1685 > _e1689) {
                                        phi_5773_ = _e1685;
                                    } else {
                                        phi_5773_ = _e1689;
                                    }
                                    let _e1692 = phi_5773_;
                                    local_2 = type_35(array<f64, 3>(_e1633, _e1634, _e1635), _e1674, (_e1692 + _e1674));
                                    let _e1698 = local_12.member_3;
                                    let _e1700 = local_12.member_1[0u];
                                    if (_e1700[0] < 0.0lf) {
                                        phi_5799_ = -(_e1700[0]);
                                    } else {
                                        phi_5799_ = _e1700[0];
                                    }
                                    let _e1707 = phi_5799_;
                                    if (_e1700[1] < 0.0lf) {
                                        phi_5806_ = -(_e1700[1]);
                                    } else {
                                        phi_5806_ = _e1700[1];
                                    }
                                    let _e1711 = phi_5806_;
                                    if (_e1707 > _e1711) {
                                        phi_5811_ = _e1707;
                                    } else {
                                        phi_5811_ = _e1711;
                                    }
                                    let _e1714 = phi_5811_;
                                    if (_e1700[2] < 0.0lf) {
                                        phi_5818_ = -(_e1700[2]);
                                    } else {
                                        phi_5818_ = _e1700[2];
                                    }
                                    let _e1718 = phi_5818_;
                                    if (_e1714 > _e1718) {
                                        phi_5823_ = _e1714;
                                    } else {
                                        phi_5823_ = _e1718;
                                    }
                                    let _e1721 = phi_5823_;
                                    let _e1723 = local_12.member_1[1u];
                                    if (_e1723[0] < 0.0lf) {
                                        phi_5836_ = -(_e1723[0]);
                                    } else {
                                        phi_5836_ = _e1723[0];
                                    }
                                    let _e1730 = phi_5836_;
                                    if (_e1723[1] < 0.0lf) {
                                        phi_5843_ = -(_e1723[1]);
                                    } else {
                                        phi_5843_ = _e1723[1];
                                    }
                                    let _e1734 = phi_5843_;
                                    if (_e1730 > _e1734) {
                                        phi_5848_ = _e1730;
                                    } else {
                                        phi_5848_ = _e1734;
                                    }
                                    let _e1737 = phi_5848_;
                                    if (_e1723[2] < 0.0lf) {
                                        phi_5855_ = -(_e1723[2]);
                                    } else {
                                        phi_5855_ = _e1723[2];
                                    }
                                    let _e1741 = phi_5855_;
                                    if (_e1737 > _e1741) {
                                        phi_5860_ = _e1737;
                                    } else {
                                        phi_5860_ = _e1741;
                                    }
                                    let _e1744 = phi_5860_;
                                    if (_e1721 > _e1744) {
                                        phi_5865_ = _e1721;
                                    } else {
                                        phi_5865_ = _e1744;
                                    }
                                    let _e1747 = phi_5865_;
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
                                        phi_5924_ = -(_e1778);
                                    } else {
                                        phi_5924_ = _e1778;
                                    }
                                    let _e1784 = phi_5924_;
                                    if (_e1779 < 0.0lf) {
                                        phi_5930_ = -(_e1779);
                                    } else {
                                        phi_5930_ = _e1779;
                                    }
                                    let _e1788 = phi_5930_;
                                    if (_e1784 > _e1788) {
                                        phi_5935_ = _e1784;
                                    } else {
                                        phi_5935_ = _e1788;
                                    }
                                    let _e1791 = phi_5935_;
                                    if (_e1780 < 0.0lf) {
                                        phi_5941_ = -(_e1780);
                                    } else {
                                        phi_5941_ = _e1780;
                                    }
                                    let _e1795 = phi_5941_;
                                    if (_e1791 > _e1795) {
                                        phi_5946_ = _e1791;
                                    } else {
                                        phi_5946_ = _e1795;
                                    }
                                    let _e1798 = phi_5946_;
                                    let _e1806 = ((((_e1563 * _e1798) * f64(1.01f)) + ((_e1747 + _e1698) * (1.1102230246251565e-16lf * f64(8f)))) + _e1698);
                                    if (_e1765 < 0.0lf) {
                                        phi_5960_ = -(_e1765);
                                    } else {
                                        phi_5960_ = _e1765;
                                    }
                                    let _e1810 = phi_5960_;
                                    if (_e1766 < 0.0lf) {
                                        phi_5966_ = -(_e1766);
                                    } else {
                                        phi_5966_ = _e1766;
                                    }
                                    let _e1814 = phi_5966_;
                                    if (_e1810 > _e1814) {
                                        phi_5971_ = _e1810;
                                    } else {
                                        phi_5971_ = _e1814;
                                    }
                                    let _e1817 = phi_5971_;
                                    if (_e1767 < 0.0lf) {
                                        phi_5977_ = -(_e1767);
                                    } else {
                                        phi_5977_ = _e1767;
                                    }
                                    let _e1821 = phi_5977_;
                                    if (_e1817 > _e1821) {
                                        phi_5982_ = _e1817;
                                    } else {
                                        phi_5982_ = _e1821;
                                    }
                                    let _e1824 = phi_5982_;
                                    local_3 = type_35(array<f64, 3>(_e1765, _e1766, _e1767), _e1806, (_e1824 + _e1806));
                                    let _e1830 = local_12.member_3;
                                    let _e1832 = local_12.member_2[0u];
                                    if (_e1832[0] < 0.0lf) {
                                        phi_6008_ = -(_e1832[0]);
                                    } else {
                                        phi_6008_ = _e1832[0];
                                    }
                                    let _e1839 = phi_6008_;
                                    if (_e1832[1] < 0.0lf) {
                                        phi_6015_ = -(_e1832[1]);
                                    } else {
                                        phi_6015_ = _e1832[1];
                                    }
                                    let _e1843 = phi_6015_;
                                    if (_e1839 > _e1843) {
                                        phi_6020_ = _e1839;
                                    } else {
                                        phi_6020_ = _e1843;
                                    }
                                    let _e1846 = phi_6020_;
                                    if (_e1832[2] < 0.0lf) {
                                        phi_6027_ = -(_e1832[2]);
                                    } else {
                                        phi_6027_ = _e1832[2];
                                    }
                                    let _e1850 = phi_6027_;
                                    if (_e1846 > _e1850) {
                                        phi_6032_ = _e1846;
                                    } else {
                                        phi_6032_ = _e1850;
                                    }
                                    let _e1853 = phi_6032_;
                                    let _e1855 = local_12.member_2[1u];
                                    if (_e1855[0] < 0.0lf) {
                                        phi_6045_ = -(_e1855[0]);
                                    } else {
                                        phi_6045_ = _e1855[0];
                                    }
                                    let _e1862 = phi_6045_;
                                    if (_e1855[1] < 0.0lf) {
                                        phi_6052_ = -(_e1855[1]);
                                    } else {
                                        phi_6052_ = _e1855[1];
                                    }
                                    let _e1866 = phi_6052_;
                                    if (_e1862 > _e1866) {
                                        phi_6057_ = _e1862;
                                    } else {
                                        phi_6057_ = _e1866;
                                    }
                                    let _e1869 = phi_6057_;
                                    if (_e1855[2] < 0.0lf) {
                                        phi_6064_ = -(_e1855[2]);
                                    } else {
                                        phi_6064_ = _e1855[2];
                                    }
                                    let _e1873 = phi_6064_;
                                    if (_e1869 > _e1873) {
                                        phi_6069_ = _e1869;
                                    } else {
                                        phi_6069_ = _e1873;
                                    }
                                    let _e1876 = phi_6069_;
                                    if (_e1853 > _e1876) {
                                        phi_6074_ = _e1853;
                                    } else {
                                        phi_6074_ = _e1876;
                                    }
                                    let _e1879 = phi_6074_;
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
                                        phi_6133_ = -(_e1910);
                                    } else {
                                        phi_6133_ = _e1910;
                                    }
                                    let _e1916 = phi_6133_;
                                    if (_e1911 < 0.0lf) {
                                        phi_6139_ = -(_e1911);
                                    } else {
                                        phi_6139_ = _e1911;
                                    }
                                    let _e1920 = phi_6139_;
                                    if (_e1916 > _e1920) {
                                        phi_6144_ = _e1916;
                                    } else {
                                        phi_6144_ = _e1920;
                                    }
                                    let _e1923 = phi_6144_;
                                    if (_e1912 < 0.0lf) {
                                        phi_6150_ = -(_e1912);
                                    } else {
                                        phi_6150_ = _e1912;
                                    }
                                    let _e1927 = phi_6150_;
                                    if (_e1923 > _e1927) {
                                        phi_6155_ = _e1923;
                                    } else {
                                        phi_6155_ = _e1927;
                                    }
                                    let _e1930 = phi_6155_;
                                    let _e1938 = ((((_e1563 * _e1930) * f64(1.01f)) + ((_e1879 + _e1830) * (1.1102230246251565e-16lf * f64(8f)))) + _e1830);
                                    if (_e1897 < 0.0lf) {
                                        phi_6169_ = -(_e1897);
                                    } else {
                                        phi_6169_ = _e1897;
                                    }
                                    let _e1942 = phi_6169_;
                                    if (_e1898 < 0.0lf) {
                                        phi_6175_ = -(_e1898);
                                    } else {
                                        phi_6175_ = _e1898;
                                    }
                                    let _e1946 = phi_6175_;
                                    if (_e1942 > _e1946) {
                                        phi_6180_ = _e1942;
                                    } else {
                                        phi_6180_ = _e1946;
                                    }
                                    let _e1949 = phi_6180_;
                                    if (_e1899 < 0.0lf) {
                                        phi_6186_ = -(_e1899);
                                    } else {
                                        phi_6186_ = _e1899;
                                    }
                                    let _e1953 = phi_6186_;
                                    if (_e1949 > _e1953) {
                                        phi_6191_ = _e1949;
                                    } else {
                                        phi_6191_ = _e1953;
                                    }
                                    let _e1956 = phi_6191_;
                                    local_4 = type_35(array<f64, 3>(_e1897, _e1898, _e1899), _e1938, (_e1956 + _e1938));
                                    let _e1961 = local_3.member;
                                    let _e1966 = local_4.member;
                                    let _e1972 = ((_e1961[1] * _e1966[2]) - (_e1961[2] * _e1966[1]));
                                    let _e1975 = ((_e1961[2] * _e1966[0]) - (_e1961[0] * _e1966[2]));
                                    let _e1978 = ((_e1961[0] * _e1966[1]) - (_e1961[1] * _e1966[0]));
                                    if (_e1972 < 0.0lf) {
                                        phi_6240_ = -(_e1972);
                                    } else {
                                        phi_6240_ = _e1972;
                                    }
                                    let _e1982 = phi_6240_;
                                    if (_e1975 < 0.0lf) {
                                        phi_6246_ = -(_e1975);
                                    } else {
                                        phi_6246_ = _e1975;
                                    }
                                    let _e1986 = phi_6246_;
                                    if (_e1982 > _e1986) {
                                        if (_e1972 < 0.0lf) {
                                            phi_6256_ = -(_e1972);
                                        } else {
                                            phi_6256_ = _e1972;
                                        }
                                        let _e2004 = phi_6256_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6262_ = -(_e1978);
                                        } else {
                                            phi_6262_ = _e1978;
                                        }
                                        let _e2008 = phi_6262_;
                                        if (_e2004 > _e2008) {
                                            phi_6267_ = 2u;
                                            phi_6268_ = 1u;
                                        } else {
                                            phi_6267_ = 1u;
                                            phi_6268_ = 0u;
                                        }
                                        let _e2011 = phi_6267_;
                                        let _e2013 = phi_6268_;
                                        phi_6287_ = _e2011;
                                        phi_6288_ = _e2013;
                                    } else {
                                        if (_e1975 < 0.0lf) {
                                            phi_6274_ = -(_e1975);
                                        } else {
                                            phi_6274_ = _e1975;
                                        }
                                        let _e1991 = phi_6274_;
                                        if (_e1978 < 0.0lf) {
                                            phi_6280_ = -(_e1978);
                                        } else {
                                            phi_6280_ = _e1978;
                                        }
                                        let _e1995 = phi_6280_;
                                        if (_e1991 > _e1995) {
                                            phi_6285_ = 0u;
                                            phi_6286_ = 2u;
                                        } else {
                                            phi_6285_ = 1u;
                                            phi_6286_ = 0u;
                                        }
                                        let _e1998 = phi_6285_;
                                        let _e2000 = phi_6286_;
                                        phi_6287_ = _e1998;
                                        phi_6288_ = _e2000;
                                    }
                                    let _e2015 = phi_6287_;
                                    let _e2017 = phi_6288_;
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
                                        phi_6361_ = -(_e2032);
                                    } else {
                                        phi_6361_ = _e2032;
                                    }
                                    let _e2072 = phi_6361_;
                                    if (_e2072 > _e2068) {
                                        if (_e2032 < f64(0f)) {
                                            phi_6373_ = f64(-1f);
                                        } else {
                                            phi_6373_ = f64(1f);
                                        }
                                        let _e2079 = phi_6373_;
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
                                            phi_6516_ = -(_e2182);
                                        } else {
                                            phi_6516_ = _e2182;
                                        }
                                        let _e2188 = phi_6516_;
                                        if (_e2183 < 0.0lf) {
                                            phi_6522_ = -(_e2183);
                                        } else {
                                            phi_6522_ = _e2183;
                                        }
                                        let _e2192 = phi_6522_;
                                        if (_e2184 < 0.0lf) {
                                            phi_6529_ = -(_e2184);
                                        } else {
                                            phi_6529_ = _e2184;
                                        }
                                        let _e2197 = phi_6529_;
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
                                        phi_6573_ = type_9(0u, 4u);
                                        phi_6576_ = true;
                                        loop {
                                            let _e2221 = phi_6573_;
                                            let _e2223 = phi_6576_;
                                            local_17 = _e2223;
                                            if (_e2221.member < _e2221.member_1) {
                                                phi_6574_ = type_9((_e2221.member + 1u), _e2221.member_1);
                                                phi_6599_ = type_9(1u, _e2221.member);
                                            } else {
                                                phi_6574_ = _e2221;
                                                phi_6599_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2235 = phi_6574_;
                                            let _e2237 = phi_6599_;
                                            if (bitcast<i32>(_e2237.member) != 0i) {
                                                let _e2244 = local_5[_e2237.member_1].member;
                                                let _e2247 = local_5[_e2237.member_1].member_1;
                                                let _e2249 = (_e2244 < -(_e2247));
                                                if _e2249 {
                                                    phi_6626_ = bool();
                                                    phi_6627_ = false;
                                                } else {
                                                    phi_6626_ = (_e2223 && (_e2244 > _e2247));
                                                    phi_6627_ = true;
                                                }
                                                let _e2253 = phi_6626_;
                                                let _e2255 = phi_6627_;
                                                phi_6577_ = _e2253;
                                                phi_6628_ = _e2255;
                                                phi_6629_ = _e2249;
                                            } else {
                                                phi_6577_ = bool();
                                                phi_6628_ = false;
                                                phi_6629_ = false;
                                            }
                                            let _e2257 = phi_6577_;
                                            let _e2259 = phi_6628_;
                                            let _e2261 = phi_6629_;
                                            local_16 = _e2261;
                                            continue;
                                            continuing {
                                                phi_6573_ = _e2235;
                                                phi_6576_ = _e2257;
                                                break if !(_e2259);
                                            }
                                        }
                                        let _e2264 = local_16;
                                        if _e2264 {
                                            phi_6633_ = false;
                                        } else {
                                            phi_6633_ = true;
                                        }
                                        let _e2266 = phi_6633_;
                                        if _e2266 {
                                            let _e2268 = local_17;
                                            if _e2268 {
                                                phi_6640_ = 1u;
                                            } else {
                                                phi_6640_ = 2u;
                                            }
                                            let _e2270 = phi_6640_;
                                            phi_6641_ = _e2270;
                                            phi_6642_ = false;
                                        } else {
                                            phi_6641_ = u32();
                                            phi_6642_ = true;
                                        }
                                        let _e2272 = phi_6641_;
                                        let _e2274 = phi_6642_;
                                        phi_6643_ = _e2272;
                                        phi_6644_ = 0u;
                                        phi_6645_ = _e2274;
                                    } else {
                                        phi_6643_ = u32();
                                        phi_6644_ = 2u;
                                        phi_6645_ = true;
                                    }
                                    let _e2276 = phi_6643_;
                                    let _e2278 = phi_6644_;
                                    let _e2280 = phi_6645_;
                                    if _e2280 {
                                        phi_6649_ = _e2278;
                                    } else {
                                        phi_6649_ = _e2276;
                                    }
                                    let _e2282 = phi_6649_;
                                    let _e2283 = (_e2282 == 0u);
                                    if _e2283 {
                                        phi_8861_ = f64();
                                        phi_8862_ = false;
                                        phi_8863_ = false;
                                        phi_8864_ = false;
                                    } else {
                                        if (_e2282 == 1u) {
                                            if _e1551.member_2 {
                                                if ((_e1551.member_1 - _e1551.member) <= f64(0.0000005f)) {
                                                    phi_6670_ = false;
                                                } else {
                                                    phi_6670_ = true;
                                                }
                                                let _e2292 = phi_6670_;
                                                phi_6671_ = _e2292;
                                            } else {
                                                phi_6671_ = true;
                                            }
                                            let _e2294 = phi_6671_;
                                            phi_6672_ = _e2294;
                                        } else {
                                            phi_6672_ = true;
                                        }
                                        let _e2296 = phi_6672_;
                                        if _e2296 {
                                            let _e2302 = local_12.member[0u];
                                            let _e2308 = local_12.member_1[0u];
                                            let _e2314 = local_12.member_2[0u];
                                            let _e2326 = local_12.member[1u];
                                            let _e2332 = local_12.member_1[1u];
                                            let _e2338 = local_12.member_2[1u];
                                            let _e2350 = local_12.member[0u];
                                            if (_e2350[0] < 0.0lf) {
                                                phi_6821_ = -(_e2350[0]);
                                            } else {
                                                phi_6821_ = _e2350[0];
                                            }
                                            let _e2357 = phi_6821_;
                                            if (_e2350[1] < 0.0lf) {
                                                phi_6828_ = -(_e2350[1]);
                                            } else {
                                                phi_6828_ = _e2350[1];
                                            }
                                            let _e2361 = phi_6828_;
                                            if (_e2357 > _e2361) {
                                                phi_6833_ = _e2357;
                                            } else {
                                                phi_6833_ = _e2361;
                                            }
                                            let _e2364 = phi_6833_;
                                            if (_e2350[2] < 0.0lf) {
                                                phi_6840_ = -(_e2350[2]);
                                            } else {
                                                phi_6840_ = _e2350[2];
                                            }
                                            let _e2368 = phi_6840_;
                                            if (_e2364 > _e2368) {
                                                phi_6845_ = _e2364;
                                            } else {
                                                phi_6845_ = _e2368;
                                            }
                                            let _e2371 = phi_6845_;
                                            let _e2374 = local_12.member[1u];
                                            if (_e2374[0] < 0.0lf) {
                                                phi_6858_ = -(_e2374[0]);
                                            } else {
                                                phi_6858_ = _e2374[0];
                                            }
                                            let _e2381 = phi_6858_;
                                            if (_e2374[1] < 0.0lf) {
                                                phi_6865_ = -(_e2374[1]);
                                            } else {
                                                phi_6865_ = _e2374[1];
                                            }
                                            let _e2385 = phi_6865_;
                                            if (_e2381 > _e2385) {
                                                phi_6870_ = _e2381;
                                            } else {
                                                phi_6870_ = _e2385;
                                            }
                                            let _e2388 = phi_6870_;
                                            if (_e2374[2] < 0.0lf) {
                                                phi_6877_ = -(_e2374[2]);
                                            } else {
                                                phi_6877_ = _e2374[2];
                                            }
                                            let _e2392 = phi_6877_;
                                            if (_e2388 > _e2392) {
                                                phi_6882_ = _e2388;
                                            } else {
                                                phi_6882_ = _e2392;
                                            }
                                            let _e2395 = phi_6882_;
                                            if (_e2371 > _e2395) {
                                                phi_6887_ = _e2371;
                                            } else {
                                                phi_6887_ = _e2395;
                                            }
                                            let _e2398 = phi_6887_;
                                            let _e2400 = local_12.member_3;
                                            let _e2404 = local_12.member_1[0u];
                                            if (_e2404[0] < 0.0lf) {
                                                phi_6904_ = -(_e2404[0]);
                                            } else {
                                                phi_6904_ = _e2404[0];
                                            }
                                            let _e2411 = phi_6904_;
                                            if (_e2404[1] < 0.0lf) {
                                                phi_6911_ = -(_e2404[1]);
                                            } else {
                                                phi_6911_ = _e2404[1];
                                            }
                                            let _e2415 = phi_6911_;
                                            if (_e2411 > _e2415) {
                                                phi_6916_ = _e2411;
                                            } else {
                                                phi_6916_ = _e2415;
                                            }
                                            let _e2418 = phi_6916_;
                                            if (_e2404[2] < 0.0lf) {
                                                phi_6923_ = -(_e2404[2]);
                                            } else {
                                                phi_6923_ = _e2404[2];
                                            }
                                            let _e2422 = phi_6923_;
                                            if (_e2418 > _e2422) {
                                                phi_6928_ = _e2418;
                                            } else {
                                                phi_6928_ = _e2422;
                                            }
                                            let _e2425 = phi_6928_;
                                            let _e2428 = local_12.member_1[1u];
                                            if (_e2428[0] < 0.0lf) {
                                                phi_6942_ = -(_e2428[0]);
                                            } else {
                                                phi_6942_ = _e2428[0];
                                            }
                                            let _e2435 = phi_6942_;
                                            if (_e2428[1] < 0.0lf) {
                                                phi_6949_ = -(_e2428[1]);
                                            } else {
                                                phi_6949_ = _e2428[1];
                                            }
                                            let _e2439 = phi_6949_;
                                            if (_e2435 > _e2439) {
                                                phi_6954_ = _e2435;
                                            } else {
                                                phi_6954_ = _e2439;
                                            }
                                            let _e2442 = phi_6954_;
                                            if (_e2428[2] < 0.0lf) {
                                                phi_6961_ = -(_e2428[2]);
                                            } else {
                                                phi_6961_ = _e2428[2];
                                            }
                                            let _e2446 = phi_6961_;
                                            if (_e2442 > _e2446) {
                                                phi_6966_ = _e2442;
                                            } else {
                                                phi_6966_ = _e2446;
                                            }
                                            let _e2449 = phi_6966_;
                                            if (_e2425 > _e2449) {
                                                phi_6971_ = _e2425;
                                            } else {
                                                phi_6971_ = _e2449;
                                            }
                                            let _e2452 = phi_6971_;
                                            let _e2454 = local_12.member_3;
                                            let _e2458 = local_12.member_2[0u];
                                            if (_e2458[0] < 0.0lf) {
                                                phi_6988_ = -(_e2458[0]);
                                            } else {
                                                phi_6988_ = _e2458[0];
                                            }
                                            let _e2465 = phi_6988_;
                                            if (_e2458[1] < 0.0lf) {
                                                phi_6995_ = -(_e2458[1]);
                                            } else {
                                                phi_6995_ = _e2458[1];
                                            }
                                            let _e2469 = phi_6995_;
                                            if (_e2465 > _e2469) {
                                                phi_7000_ = _e2465;
                                            } else {
                                                phi_7000_ = _e2469;
                                            }
                                            let _e2472 = phi_7000_;
                                            if (_e2458[2] < 0.0lf) {
                                                phi_7007_ = -(_e2458[2]);
                                            } else {
                                                phi_7007_ = _e2458[2];
                                            }
                                            let _e2476 = phi_7007_;
                                            if (_e2472 > _e2476) {
                                                phi_7012_ = _e2472;
                                            } else {
                                                phi_7012_ = _e2476;
                                            }
                                            let _e2479 = phi_7012_;
                                            let _e2482 = local_12.member_2[1u];
                                            if (_e2482[0] < 0.0lf) {
                                                phi_7026_ = -(_e2482[0]);
                                            } else {
                                                phi_7026_ = _e2482[0];
                                            }
                                            let _e2489 = phi_7026_;
                                            if (_e2482[1] < 0.0lf) {
                                                phi_7033_ = -(_e2482[1]);
                                            } else {
                                                phi_7033_ = _e2482[1];
                                            }
                                            let _e2493 = phi_7033_;
                                            if (_e2489 > _e2493) {
                                                phi_7038_ = _e2489;
                                            } else {
                                                phi_7038_ = _e2493;
                                            }
                                            let _e2496 = phi_7038_;
                                            if (_e2482[2] < 0.0lf) {
                                                phi_7045_ = -(_e2482[2]);
                                            } else {
                                                phi_7045_ = _e2482[2];
                                            }
                                            let _e2500 = phi_7045_;
                                            if (_e2496 > _e2500) {
                                                phi_7050_ = _e2496;
                                            } else {
                                                phi_7050_ = _e2500;
                                            }
                                            let _e2503 = phi_7050_;
                                            if (_e2479 > _e2503) {
                                                phi_7055_ = _e2479;
                                            } else {
                                                phi_7055_ = _e2503;
                                            }
                                            let _e2506 = phi_7055_;
                                            let _e2508 = local_12.member_3;
                                            let _e2516 = local_12.member_3;
                                            let _e2523 = f64(0f);
                                            let _e2524 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2523, _e2523, _e2523, _e2523), array<f64, 4>(_e2523, _e2523, _e2523, _e2523), array<f64, 4>(_e2524, _e2524, _e2524, _e2524));
                                            phi_7099_ = type_9(0u, 96u);
                                            phi_7102_ = _e1551.member;
                                            phi_7104_ = _e1551.member;
                                            phi_7106_ = _e1551.member;
                                            phi_7108_ = false;
                                            phi_7110_ = 0u;
                                            loop {
                                                let _e2530 = phi_7099_;
                                                let _e2532 = phi_7102_;
                                                let _e2534 = phi_7104_;
                                                let _e2536 = phi_7106_;
                                                let _e2538 = phi_7108_;
                                                let _e2540 = phi_7110_;
                                                local_36 = _e2534;
                                                local_20 = _e2532;
                                                if (_e2530.member < _e2530.member_1) {
                                                    phi_7100_ = type_9((_e2530.member + 1u), _e2530.member_1);
                                                    phi_7133_ = type_9(1u, _e2530.member);
                                                } else {
                                                    phi_7100_ = _e2530;
                                                    phi_7133_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2552 = phi_7100_;
                                                let _e2554 = phi_7133_;
                                                if (bitcast<i32>(_e2554.member) != 0i) {
                                                    let _e2560 = local_12.member[0u];
                                                    let _e2566 = local_12.member[1u];
                                                    let _e2582 = local_12.member_1[0u];
                                                    let _e2588 = local_12.member_1[1u];
                                                    let _e2604 = local_12.member_2[0u];
                                                    let _e2610 = local_12.member_2[1u];
                                                    let _e2624 = function_2(array<f64, 3>((_e2560[0] + ((_e2566[0] - _e2560[0]) * _e2532)), (_e2560[1] + ((_e2566[1] - _e2560[1]) * _e2532)), (_e2560[2] + ((_e2566[2] - _e2560[2]) * _e2532))), array<f64, 3>((_e2582[0] + ((_e2588[0] - _e2582[0]) * _e2532)), (_e2582[1] + ((_e2588[1] - _e2582[1]) * _e2532)), (_e2582[2] + ((_e2588[2] - _e2582[2]) * _e2532))), array<f64, 3>((_e2604[0] + ((_e2610[0] - _e2604[0]) * _e2532)), (_e2604[1] + ((_e2610[1] - _e2604[1]) * _e2532)), (_e2604[2] + ((_e2610[2] - _e2604[2]) * _e2532))), 0u);
                                                    if (_e2540 == 0u) {
                                                        phi_7262_ = _e2624;
                                                    } else {
                                                        let _e2626 = f64(0f);
                                                        if (_e2540 == 1u) {
                                                            phi_7248_ = _e2624[0];
                                                        } else {
                                                            phi_7248_ = _e2626;
                                                        }
                                                        let _e2630 = phi_7248_;
                                                        if (_e2540 == 2u) {
                                                            phi_7254_ = _e2624[1];
                                                        } else {
                                                            phi_7254_ = _e2626;
                                                        }
                                                        let _e2634 = phi_7254_;
                                                        if (_e2540 == 3u) {
                                                            phi_7260_ = _e2624[2];
                                                        } else {
                                                            phi_7260_ = _e2626;
                                                        }
                                                        let _e2638 = phi_7260_;
                                                        phi_7262_ = array<f64, 3>(_e2630, _e2634, _e2638);
                                                    }
                                                    let _e2641 = phi_7262_;
                                                    if (_e2641[0] < 0.0lf) {
                                                        phi_7269_ = -(_e2641[0]);
                                                    } else {
                                                        phi_7269_ = _e2641[0];
                                                    }
                                                    let _e2646 = phi_7269_;
                                                    if (_e2641[1] < 0.0lf) {
                                                        phi_7276_ = -(_e2641[1]);
                                                    } else {
                                                        phi_7276_ = _e2641[1];
                                                    }
                                                    let _e2651 = phi_7276_;
                                                    if (_e2641[2] < 0.0lf) {
                                                        phi_7284_ = -(_e2641[2]);
                                                    } else {
                                                        phi_7284_ = _e2641[2];
                                                    }
                                                    let _e2657 = phi_7284_;
                                                    let _e2658 = ((_e2646 + _e2651) + _e2657);
                                                    if (_e2658 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2658) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2665 = (f64(1f) / _e2658);
                                                            let _e2667 = (_e2641[0] * _e2665);
                                                            let _e2669 = (_e2641[1] * _e2665);
                                                            let _e2671 = (_e2641[2] * _e2665);
                                                            let _e2676 = (((_e2667 * _e2667) + (_e2669 * _e2669)) + (_e2671 * _e2671));
                                                            if (_e2676 <= 2.2250738585072014e-308lf) {
                                                                if (_e2676 > 0.0lf) {
                                                                    phi_7323_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_7323_ = 0.0lf;
                                                                }
                                                                let _e2728 = phi_7323_;
                                                                phi_7387_ = _e2728;
                                                            } else {
                                                                phi_7330_ = type_16(0i, 5i);
                                                                phi_7333_ = bitcast<f64>(((bitcast<u64>(_e2676) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2683 = phi_7330_;
                                                                    let _e2685 = phi_7333_;
                                                                    local_18 = _e2685;
                                                                    if (_e2683.member < _e2683.member_1) {
                                                                        let _e2692 = (_e2683.member + 1i);
                                                                        if ((false == (_e2692 > _e2683.member)) != false) {
                                                                            phi_7354_ = true;
                                                                        } else {
                                                                            phi_7354_ = false;
                                                                        }
                                                                        let _e2697 = phi_7354_;
                                                                        if _e2697 {
                                                                            phi_7360_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_7360_ = type_17(1u, _e2692);
                                                                        }
                                                                        let _e2702 = phi_7360_;
                                                                        phi_7331_ = type_16(_e2702.member_1, _e2683.member_1);
                                                                        phi_7374_ = type_17(1u, _e2683.member);
                                                                    } else {
                                                                        phi_7331_ = _e2683;
                                                                        phi_7374_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2708 = phi_7331_;
                                                                    let _e2710 = phi_7374_;
                                                                    let _e2713 = (bitcast<i32>(_e2710.member) != 0i);
                                                                    if _e2713 {
                                                                        phi_7334_ = (0.5lf * (_e2685 + (_e2676 / _e2685)));
                                                                    } else {
                                                                        phi_7334_ = f64();
                                                                    }
                                                                    let _e2718 = phi_7334_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_7330_ = _e2708;
                                                                        phi_7333_ = _e2718;
                                                                        break if !(_e2713);
                                                                    }
                                                                }
                                                                let _e2723 = local_18;
                                                                phi_7387_ = (_e2723 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2730 = phi_7387_;
                                                            let _e2732 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2739 = ((((((((_e2398 + _e2400) + (_e2452 + _e2454)) + (_e2506 + _e2508)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2516 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2730) * (f64(1f) + _e2732)));
                                                            let _e2744 = (((_e2667 * _e2302[0]) + (_e2669 * _e2302[1])) + (_e2671 * _e2302[2]));
                                                            let _e2749 = (((_e2667 * (_e2302[0] - _e2308[0])) + (_e2669 * (_e2302[1] - _e2308[1]))) + (_e2671 * (_e2302[2] - _e2308[2])));
                                                            let _e2754 = (((_e2667 * (_e2302[0] - _e2314[0])) + (_e2669 * (_e2302[1] - _e2314[1]))) + (_e2671 * (_e2302[2] - _e2314[2])));
                                                            let _e2759 = (((_e2667 * _e2302[0]) + (_e2669 * _e2302[1])) + (_e2671 * _e2302[2]));
                                                            let _e2765 = (((_e2667 * _e2326[0]) + (_e2669 * _e2326[1])) + (_e2671 * _e2326[2]));
                                                            let _e2770 = (((_e2667 * (_e2326[0] - _e2332[0])) + (_e2669 * (_e2326[1] - _e2332[1]))) + (_e2671 * (_e2326[2] - _e2332[2])));
                                                            let _e2775 = (((_e2667 * (_e2326[0] - _e2338[0])) + (_e2669 * (_e2326[1] - _e2338[1]))) + (_e2671 * (_e2326[2] - _e2338[2])));
                                                            let _e2780 = (((_e2667 * _e2326[0]) + (_e2669 * _e2326[1])) + (_e2671 * _e2326[2]));
                                                            if (_e2744 < 0.0lf) {
                                                                phi_7456_ = -(_e2744);
                                                            } else {
                                                                phi_7456_ = _e2744;
                                                            }
                                                            let _e2785 = phi_7456_;
                                                            if (_e2765 < 0.0lf) {
                                                                phi_7462_ = -(_e2765);
                                                            } else {
                                                                phi_7462_ = _e2765;
                                                            }
                                                            let _e2789 = phi_7462_;
                                                            if (_e2749 < 0.0lf) {
                                                                phi_7471_ = -(_e2749);
                                                            } else {
                                                                phi_7471_ = _e2749;
                                                            }
                                                            let _e2796 = phi_7471_;
                                                            if (_e2770 < 0.0lf) {
                                                                phi_7477_ = -(_e2770);
                                                            } else {
                                                                phi_7477_ = _e2770;
                                                            }
                                                            let _e2800 = phi_7477_;
                                                            if (_e2754 < 0.0lf) {
                                                                phi_7486_ = -(_e2754);
                                                            } else {
                                                                phi_7486_ = _e2754;
                                                            }
                                                            let _e2807 = phi_7486_;
                                                            if (_e2775 < 0.0lf) {
                                                                phi_7492_ = -(_e2775);
                                                            } else {
                                                                phi_7492_ = _e2775;
                                                            }
                                                            let _e2811 = phi_7492_;
                                                            if (_e2759 < 0.0lf) {
                                                                phi_7501_ = -(_e2759);
                                                            } else {
                                                                phi_7501_ = _e2759;
                                                            }
                                                            let _e2818 = phi_7501_;
                                                            if (_e2780 < 0.0lf) {
                                                                phi_7507_ = -(_e2780);
                                                            } else {
                                                                phi_7507_ = _e2780;
                                                            }
                                                            let _e2822 = phi_7507_;
                                                            phi_7513_ = type_34(array<f64, 4>(_e2744, _e2749, _e2754, _e2759), array<f64, 4>(_e2765, _e2770, _e2775, _e2780), array<f64, 4>((_e2739 + ((_e2785 + _e2789) * _e2732)), (_e2739 + ((_e2796 + _e2800) * _e2732)), (_e2739 + ((_e2807 + _e2811) * _e2732)), (_e2739 + ((_e2818 + _e2822) * _e2732))));
                                                            phi_7514_ = false;
                                                        } else {
                                                            phi_7513_ = type_34();
                                                            phi_7514_ = true;
                                                        }
                                                        let _e2829 = phi_7513_;
                                                        let _e2831 = phi_7514_;
                                                        phi_7515_ = _e2829;
                                                        phi_7516_ = _e2831;
                                                    } else {
                                                        phi_7515_ = type_34();
                                                        phi_7516_ = true;
                                                    }
                                                    let _e2833 = phi_7515_;
                                                    let _e2835 = phi_7516_;
                                                    if _e2835 {
                                                        let _e2836 = f64(0f);
                                                        let _e2837 = f64(1f);
                                                        phi_7526_ = type_34(array<f64, 4>(_e2836, _e2836, _e2836, _e2836), array<f64, 4>(_e2836, _e2836, _e2836, _e2836), array<f64, 4>(_e2837, _e2837, _e2837, _e2837));
                                                    } else {
                                                        phi_7526_ = _e2833;
                                                    }
                                                    let _e2843 = phi_7526_;
                                                    local_1 = type_34(array<f64, 4>(_e2843.member[0], _e2843.member[1], _e2843.member[2], _e2843.member[3]), array<f64, 4>(_e2843.member_1[0], _e2843.member_1[1], _e2843.member_1[2], _e2843.member_1[3]), array<f64, 4>(_e2843.member_2[0], _e2843.member_2[1], _e2843.member_2[2], _e2843.member_2[3]));
                                                    let _e2863 = (_e2532 - _e2536);
                                                    let _e2865 = f64(0f);
                                                    let _e2868 = local_1.member[0u];
                                                    let _e2871 = local_1.member_1[0u];
                                                    let _e2874 = local_1.member[0u];
                                                    let _e2880 = local_1.member_2[0u];
                                                    if (((_e2868 + ((_e2871 - _e2874) * _e2532)) - _e2880) > _e2865) {
                                                        let _e2885 = local_1.member[1u];
                                                        let _e2888 = local_1.member_1[1u];
                                                        let _e2891 = local_1.member[1u];
                                                        let _e2897 = local_1.member_2[1u];
                                                        if (((_e2885 + ((_e2888 - _e2891) * _e2532)) - _e2897) > _e2865) {
                                                            let _e2902 = local_1.member[2u];
                                                            let _e2905 = local_1.member_1[2u];
                                                            let _e2908 = local_1.member[2u];
                                                            let _e2914 = local_1.member_2[2u];
                                                            if (((_e2902 + ((_e2905 - _e2908) * _e2532)) - _e2914) > _e2865) {
                                                                let _e2919 = local_1.member[3u];
                                                                let _e2922 = local_1.member_1[3u];
                                                                let _e2925 = local_1.member[3u];
                                                                let _e2931 = local_1.member_2[3u];
                                                                phi_7698_ = (((_e2919 + ((_e2922 - _e2925) * _e2532)) - _e2931) > _e2865);
                                                                phi_7699_ = false;
                                                            } else {
                                                                phi_7698_ = bool();
                                                                phi_7699_ = true;
                                                            }
                                                            let _e2935 = phi_7698_;
                                                            let _e2937 = phi_7699_;
                                                            phi_7700_ = _e2935;
                                                            phi_7701_ = _e2937;
                                                        } else {
                                                            phi_7700_ = bool();
                                                            phi_7701_ = true;
                                                        }
                                                        let _e2939 = phi_7700_;
                                                        let _e2941 = phi_7701_;
                                                        phi_7702_ = _e2939;
                                                        phi_7703_ = _e2941;
                                                    } else {
                                                        phi_7702_ = bool();
                                                        phi_7703_ = true;
                                                    }
                                                    let _e2943 = phi_7702_;
                                                    let _e2945 = phi_7703_;
                                                    if _e2945 {
                                                        phi_7707_ = false;
                                                    } else {
                                                        phi_7707_ = _e2943;
                                                    }
                                                    let _e2947 = phi_7707_;
                                                    if _e2947 {
                                                        if (_e2532 <= _e2534) {
                                                            phi_8018_ = true;
                                                        } else {
                                                            let _e2949 = f64(0f);
                                                            let _e2952 = local.member[0u];
                                                            let _e2955 = local.member_1[0u];
                                                            let _e2958 = local.member[0u];
                                                            let _e2964 = local.member_2[0u];
                                                            let _e2968 = local_1.member[0u];
                                                            let _e2971 = local_1.member_1[0u];
                                                            let _e2974 = local_1.member[0u];
                                                            let _e2980 = local_1.member_2[0u];
                                                            if ((((_e2952 + ((_e2955 - _e2958) * _e2532)) - _e2964) + ((_e2968 + ((_e2971 - _e2974) * _e2536)) - _e2980)) > _e2949) {
                                                                let _e2986 = local.member[1u];
                                                                let _e2989 = local.member_1[1u];
                                                                let _e2992 = local.member[1u];
                                                                let _e2998 = local.member_2[1u];
                                                                let _e3002 = local_1.member[1u];
                                                                let _e3005 = local_1.member_1[1u];
                                                                let _e3008 = local_1.member[1u];
                                                                let _e3014 = local_1.member_2[1u];
                                                                if ((((_e2986 + ((_e2989 - _e2992) * _e2532)) - _e2998) + ((_e3002 + ((_e3005 - _e3008) * _e2536)) - _e3014)) > _e2949) {
                                                                    let _e3020 = local.member[2u];
                                                                    let _e3023 = local.member_1[2u];
                                                                    let _e3026 = local.member[2u];
                                                                    let _e3032 = local.member_2[2u];
                                                                    let _e3036 = local_1.member[2u];
                                                                    let _e3039 = local_1.member_1[2u];
                                                                    let _e3042 = local_1.member[2u];
                                                                    let _e3048 = local_1.member_2[2u];
                                                                    if ((((_e3020 + ((_e3023 - _e3026) * _e2532)) - _e3032) + ((_e3036 + ((_e3039 - _e3042) * _e2536)) - _e3048)) > _e2949) {
                                                                        let _e3054 = local.member[3u];
                                                                        let _e3057 = local.member_1[3u];
                                                                        let _e3060 = local.member[3u];
                                                                        let _e3066 = local.member_2[3u];
                                                                        let _e3070 = local_1.member[3u];
                                                                        let _e3073 = local_1.member_1[3u];
                                                                        let _e3076 = local_1.member[3u];
                                                                        let _e3082 = local_1.member_2[3u];
                                                                        phi_8005_ = ((((_e3054 + ((_e3057 - _e3060) * _e2532)) - _e3066) + ((_e3070 + ((_e3073 - _e3076) * _e2536)) - _e3082)) > _e2949);
                                                                        phi_8006_ = false;
                                                                    } else {
                                                                        phi_8005_ = bool();
                                                                        phi_8006_ = true;
                                                                    }
                                                                    let _e3087 = phi_8005_;
                                                                    let _e3089 = phi_8006_;
                                                                    phi_8007_ = _e3087;
                                                                    phi_8008_ = _e3089;
                                                                } else {
                                                                    phi_8007_ = bool();
                                                                    phi_8008_ = true;
                                                                }
                                                                let _e3091 = phi_8007_;
                                                                let _e3093 = phi_8008_;
                                                                phi_8009_ = _e3091;
                                                                phi_8010_ = _e3093;
                                                            } else {
                                                                phi_8009_ = bool();
                                                                phi_8010_ = true;
                                                            }
                                                            let _e3095 = phi_8009_;
                                                            let _e3097 = phi_8010_;
                                                            if _e3097 {
                                                                phi_8014_ = false;
                                                            } else {
                                                                phi_8014_ = _e3095;
                                                            }
                                                            let _e3099 = phi_8014_;
                                                            phi_8018_ = _e3099;
                                                        }
                                                        let _e3101 = phi_8018_;
                                                        if _e3101 {
                                                            if _e2538 {
                                                                if (_e2532 >= _e1551.member_1) {
                                                                    phi_8029_ = false;
                                                                } else {
                                                                    phi_8029_ = true;
                                                                }
                                                                let _e3104 = phi_8029_;
                                                                phi_8030_ = _e3104;
                                                            } else {
                                                                phi_8030_ = true;
                                                            }
                                                            let _e3106 = phi_8030_;
                                                            if _e3106 {
                                                                local = type_34(array<f64, 4>(_e2843.member[0], _e2843.member[1], _e2843.member[2], _e2843.member[3]), array<f64, 4>(_e2843.member_1[0], _e2843.member_1[1], _e2843.member_1[2], _e2843.member_1[3]), array<f64, 4>(_e2843.member_2[0], _e2843.member_2[1], _e2843.member_2[2], _e2843.member_2[3]));
                                                                let _e3128 = local.member[0u];
                                                                let _e3131 = local.member_1[0u];
                                                                let _e3134 = local.member_2[0u];
                                                                if (_e3128 > _e3134) {
                                                                    if (_e3131 > _e3134) {
                                                                        phi_8104_ = false;
                                                                    } else {
                                                                        phi_8104_ = true;
                                                                    }
                                                                    let _e3138 = phi_8104_;
                                                                    phi_8105_ = _e3138;
                                                                } else {
                                                                    phi_8105_ = true;
                                                                }
                                                                let _e3140 = phi_8105_;
                                                                if _e3140 {
                                                                    let _e3141 = (_e3131 >= _e3128);
                                                                    if _e3141 {
                                                                        phi_8130_ = f64();
                                                                        phi_8131_ = false;
                                                                    } else {
                                                                        if ((_e3128 - _e3131) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8128_ = (((_e3128 - _e3134) / (_e3128 - _e3131)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8129_ = false;
                                                                        } else {
                                                                            phi_8128_ = f64();
                                                                            phi_8129_ = true;
                                                                        }
                                                                        let _e3155 = phi_8128_;
                                                                        let _e3157 = phi_8129_;
                                                                        phi_8130_ = _e3155;
                                                                        phi_8131_ = _e3157;
                                                                    }
                                                                    let _e3159 = phi_8130_;
                                                                    let _e3161 = phi_8131_;
                                                                    phi_8132_ = _e3159;
                                                                    phi_8133_ = _e3141;
                                                                    phi_8134_ = _e3161;
                                                                } else {
                                                                    phi_8132_ = f64();
                                                                    phi_8133_ = true;
                                                                    phi_8134_ = false;
                                                                }
                                                                let _e3163 = phi_8132_;
                                                                let _e3165 = phi_8133_;
                                                                let _e3167 = phi_8134_;
                                                                if _e3165 {
                                                                    phi_8139_ = f64(2f);
                                                                    phi_8140_ = true;
                                                                } else {
                                                                    phi_8139_ = _e2532;
                                                                    phi_8140_ = _e3167;
                                                                }
                                                                let _e3170 = phi_8139_;
                                                                let _e3172 = phi_8140_;
                                                                if _e3172 {
                                                                    phi_8144_ = _e3170;
                                                                } else {
                                                                    phi_8144_ = _e3163;
                                                                }
                                                                let _e3174 = phi_8144_;
                                                                let _e3177 = local.member[1u];
                                                                let _e3180 = local.member_1[1u];
                                                                let _e3183 = local.member_2[1u];
                                                                if (_e3177 > _e3183) {
                                                                    if (_e3180 > _e3183) {
                                                                        phi_8176_ = false;
                                                                    } else {
                                                                        phi_8176_ = true;
                                                                    }
                                                                    let _e3187 = phi_8176_;
                                                                    phi_8177_ = _e3187;
                                                                } else {
                                                                    phi_8177_ = true;
                                                                }
                                                                let _e3189 = phi_8177_;
                                                                if _e3189 {
                                                                    let _e3190 = (_e3180 >= _e3177);
                                                                    if _e3190 {
                                                                        phi_8202_ = f64();
                                                                        phi_8203_ = false;
                                                                    } else {
                                                                        if ((_e3177 - _e3180) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8200_ = (((_e3177 - _e3183) / (_e3177 - _e3180)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8201_ = false;
                                                                        } else {
                                                                            phi_8200_ = f64();
                                                                            phi_8201_ = true;
                                                                        }
                                                                        let _e3204 = phi_8200_;
                                                                        let _e3206 = phi_8201_;
                                                                        phi_8202_ = _e3204;
                                                                        phi_8203_ = _e3206;
                                                                    }
                                                                    let _e3208 = phi_8202_;
                                                                    let _e3210 = phi_8203_;
                                                                    phi_8204_ = _e3208;
                                                                    phi_8205_ = _e3190;
                                                                    phi_8206_ = _e3210;
                                                                } else {
                                                                    phi_8204_ = f64();
                                                                    phi_8205_ = true;
                                                                    phi_8206_ = false;
                                                                }
                                                                let _e3212 = phi_8204_;
                                                                let _e3214 = phi_8205_;
                                                                let _e3216 = phi_8206_;
                                                                if _e3214 {
                                                                    phi_8211_ = f64(2f);
                                                                    phi_8212_ = true;
                                                                } else {
                                                                    phi_8211_ = _e2532;
                                                                    phi_8212_ = _e3216;
                                                                }
                                                                let _e3219 = phi_8211_;
                                                                let _e3221 = phi_8212_;
                                                                if _e3221 {
                                                                    phi_8216_ = _e3219;
                                                                } else {
                                                                    phi_8216_ = _e3212;
                                                                }
                                                                let _e3223 = phi_8216_;
                                                                if (_e3174 < _e3223) {
                                                                    phi_8221_ = _e3174;
                                                                } else {
                                                                    phi_8221_ = _e3223;
                                                                }
                                                                let _e3226 = phi_8221_;
                                                                let _e3229 = local.member[2u];
                                                                let _e3232 = local.member_1[2u];
                                                                let _e3235 = local.member_2[2u];
                                                                if (_e3229 > _e3235) {
                                                                    if (_e3232 > _e3235) {
                                                                        phi_8253_ = false;
                                                                    } else {
                                                                        phi_8253_ = true;
                                                                    }
                                                                    let _e3239 = phi_8253_;
                                                                    phi_8254_ = _e3239;
                                                                } else {
                                                                    phi_8254_ = true;
                                                                }
                                                                let _e3241 = phi_8254_;
                                                                if _e3241 {
                                                                    let _e3242 = (_e3232 >= _e3229);
                                                                    if _e3242 {
                                                                        phi_8279_ = f64();
                                                                        phi_8280_ = false;
                                                                    } else {
                                                                        if ((_e3229 - _e3232) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8277_ = (((_e3229 - _e3235) / (_e3229 - _e3232)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8278_ = false;
                                                                        } else {
                                                                            phi_8277_ = f64();
                                                                            phi_8278_ = true;
                                                                        }
                                                                        let _e3256 = phi_8277_;
                                                                        let _e3258 = phi_8278_;
                                                                        phi_8279_ = _e3256;
                                                                        phi_8280_ = _e3258;
                                                                    }
                                                                    let _e3260 = phi_8279_;
                                                                    let _e3262 = phi_8280_;
                                                                    phi_8281_ = _e3260;
                                                                    phi_8282_ = _e3242;
                                                                    phi_8283_ = _e3262;
                                                                } else {
                                                                    phi_8281_ = f64();
                                                                    phi_8282_ = true;
                                                                    phi_8283_ = false;
                                                                }
                                                                let _e3264 = phi_8281_;
                                                                let _e3266 = phi_8282_;
                                                                let _e3268 = phi_8283_;
                                                                if _e3266 {
                                                                    phi_8288_ = f64(2f);
                                                                    phi_8289_ = true;
                                                                } else {
                                                                    phi_8288_ = _e2532;
                                                                    phi_8289_ = _e3268;
                                                                }
                                                                let _e3271 = phi_8288_;
                                                                let _e3273 = phi_8289_;
                                                                if _e3273 {
                                                                    phi_8293_ = _e3271;
                                                                } else {
                                                                    phi_8293_ = _e3264;
                                                                }
                                                                let _e3275 = phi_8293_;
                                                                let _e3278 = local.member[3u];
                                                                let _e3281 = local.member_1[3u];
                                                                let _e3284 = local.member_2[3u];
                                                                if (_e3278 > _e3284) {
                                                                    if (_e3281 > _e3284) {
                                                                        phi_8325_ = false;
                                                                    } else {
                                                                        phi_8325_ = true;
                                                                    }
                                                                    let _e3288 = phi_8325_;
                                                                    phi_8326_ = _e3288;
                                                                } else {
                                                                    phi_8326_ = true;
                                                                }
                                                                let _e3290 = phi_8326_;
                                                                if _e3290 {
                                                                    let _e3291 = (_e3281 >= _e3278);
                                                                    if _e3291 {
                                                                        phi_8351_ = f64();
                                                                        phi_8352_ = false;
                                                                    } else {
                                                                        if ((_e3278 - _e3281) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_8349_ = (((_e3278 - _e3284) / (_e3278 - _e3281)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_8350_ = false;
                                                                        } else {
                                                                            phi_8349_ = f64();
                                                                            phi_8350_ = true;
                                                                        }
                                                                        let _e3305 = phi_8349_;
                                                                        let _e3307 = phi_8350_;
                                                                        phi_8351_ = _e3305;
                                                                        phi_8352_ = _e3307;
                                                                    }
                                                                    let _e3309 = phi_8351_;
                                                                    let _e3311 = phi_8352_;
                                                                    phi_8353_ = _e3309;
                                                                    phi_8354_ = _e3291;
                                                                    phi_8355_ = _e3311;
                                                                } else {
                                                                    phi_8353_ = f64();
                                                                    phi_8354_ = true;
                                                                    phi_8355_ = false;
                                                                }
                                                                let _e3313 = phi_8353_;
                                                                let _e3315 = phi_8354_;
                                                                let _e3317 = phi_8355_;
                                                                if _e3315 {
                                                                    phi_8360_ = f64(2f);
                                                                    phi_8361_ = true;
                                                                } else {
                                                                    phi_8360_ = _e2532;
                                                                    phi_8361_ = _e3317;
                                                                }
                                                                let _e3320 = phi_8360_;
                                                                let _e3322 = phi_8361_;
                                                                if _e3322 {
                                                                    phi_8365_ = _e3320;
                                                                } else {
                                                                    phi_8365_ = _e3313;
                                                                }
                                                                let _e3324 = phi_8365_;
                                                                if (_e3275 < _e3324) {
                                                                    phi_8370_ = _e3275;
                                                                } else {
                                                                    phi_8370_ = _e3324;
                                                                }
                                                                let _e3327 = phi_8370_;
                                                                if (_e3226 < _e3327) {
                                                                    phi_8375_ = _e3226;
                                                                } else {
                                                                    phi_8375_ = _e3327;
                                                                }
                                                                let _e3330 = phi_8375_;
                                                                if (_e3330 > _e2532) {
                                                                    phi_8380_ = _e3330;
                                                                } else {
                                                                    phi_8380_ = _e2532;
                                                                }
                                                                let _e3333 = phi_8380_;
                                                                let _e3334 = (_e3333 > _e1551.member_1);
                                                                if _e3334 {
                                                                    phi_8391_ = f64();
                                                                    phi_8392_ = false;
                                                                } else {
                                                                    if _e2538 {
                                                                        phi_8390_ = (_e2863 + _e2863);
                                                                    } else {
                                                                        phi_8390_ = (_e1551.member_1 - _e2532);
                                                                    }
                                                                    let _e3338 = phi_8390_;
                                                                    phi_8391_ = _e3338;
                                                                    phi_8392_ = true;
                                                                }
                                                                let _e3340 = phi_8391_;
                                                                let _e3342 = phi_8392_;
                                                                phi_8393_ = _e3333;
                                                                phi_8394_ = _e3340;
                                                                phi_8395_ = _e3342;
                                                                phi_8396_ = _e3334;
                                                                phi_8397_ = false;
                                                            } else {
                                                                phi_8393_ = f64();
                                                                phi_8394_ = f64();
                                                                phi_8395_ = false;
                                                                phi_8396_ = false;
                                                                phi_8397_ = true;
                                                            }
                                                            let _e3344 = phi_8393_;
                                                            let _e3346 = phi_8394_;
                                                            let _e3348 = phi_8395_;
                                                            let _e3350 = phi_8396_;
                                                            let _e3352 = phi_8397_;
                                                            phi_8398_ = _e3344;
                                                            phi_8399_ = _e3346;
                                                            phi_8400_ = false;
                                                            phi_8401_ = _e3348;
                                                            phi_8402_ = _e3350;
                                                            phi_8403_ = _e3352;
                                                        } else {
                                                            phi_8398_ = f64();
                                                            phi_8399_ = f64();
                                                            phi_8400_ = true;
                                                            phi_8401_ = false;
                                                            phi_8402_ = false;
                                                            phi_8403_ = false;
                                                        }
                                                        let _e3354 = phi_8398_;
                                                        let _e3356 = phi_8399_;
                                                        let _e3358 = phi_8400_;
                                                        let _e3360 = phi_8401_;
                                                        let _e3362 = phi_8402_;
                                                        let _e3364 = phi_8403_;
                                                        phi_8404_ = _e3354;
                                                        phi_8405_ = _e3356;
                                                        phi_8406_ = _e3358;
                                                        phi_8407_ = _e3360;
                                                        phi_8408_ = _e3362;
                                                        phi_8409_ = _e3364;
                                                    } else {
                                                        phi_8404_ = f64();
                                                        phi_8405_ = f64();
                                                        phi_8406_ = true;
                                                        phi_8407_ = false;
                                                        phi_8408_ = false;
                                                        phi_8409_ = false;
                                                    }
                                                    let _e3366 = phi_8404_;
                                                    let _e3368 = phi_8405_;
                                                    let _e3370 = phi_8406_;
                                                    let _e3372 = phi_8407_;
                                                    let _e3374 = phi_8408_;
                                                    let _e3376 = phi_8409_;
                                                    if _e3370 {
                                                        if (_e2532 <= _e2534) {
                                                            let _e3542 = (_e2540 + 1u);
                                                            let _e3543 = (_e3542 > 3u);
                                                            if _e3543 {
                                                                phi_8422_ = false;
                                                            } else {
                                                                phi_8422_ = true;
                                                            }
                                                            let _e3545 = phi_8422_;
                                                            phi_8749_ = _e3542;
                                                            phi_8750_ = f64();
                                                            phi_8751_ = false;
                                                            phi_8752_ = _e3545;
                                                            phi_8753_ = _e3543;
                                                        } else {
                                                            let _e3380 = local.member[0u];
                                                            let _e3383 = local.member_1[0u];
                                                            let _e3386 = local.member[0u];
                                                            let _e3392 = local.member_2[0u];
                                                            let _e3393 = ((_e3380 + ((_e3383 - _e3386) * _e2536)) - _e3392);
                                                            let _e3396 = local.member[1u];
                                                            let _e3399 = local.member_1[1u];
                                                            let _e3402 = local.member[1u];
                                                            let _e3408 = local.member_2[1u];
                                                            let _e3409 = ((_e3396 + ((_e3399 - _e3402) * _e2536)) - _e3408);
                                                            if (_e3393 < _e3409) {
                                                                phi_8495_ = _e3393;
                                                            } else {
                                                                phi_8495_ = _e3409;
                                                            }
                                                            let _e3412 = phi_8495_;
                                                            let _e3415 = local.member[2u];
                                                            let _e3418 = local.member_1[2u];
                                                            let _e3421 = local.member[2u];
                                                            let _e3427 = local.member_2[2u];
                                                            let _e3428 = ((_e3415 + ((_e3418 - _e3421) * _e2536)) - _e3427);
                                                            let _e3431 = local.member[3u];
                                                            let _e3434 = local.member_1[3u];
                                                            let _e3437 = local.member[3u];
                                                            let _e3443 = local.member_2[3u];
                                                            let _e3444 = ((_e3431 + ((_e3434 - _e3437) * _e2536)) - _e3443);
                                                            if (_e3428 < _e3444) {
                                                                phi_8568_ = _e3428;
                                                            } else {
                                                                phi_8568_ = _e3444;
                                                            }
                                                            let _e3447 = phi_8568_;
                                                            if (_e3412 < _e3447) {
                                                                phi_8573_ = _e3412;
                                                            } else {
                                                                phi_8573_ = _e3447;
                                                            }
                                                            let _e3450 = phi_8573_;
                                                            let _e3453 = local_1.member[0u];
                                                            let _e3456 = local_1.member_1[0u];
                                                            let _e3459 = local_1.member[0u];
                                                            let _e3465 = local_1.member_2[0u];
                                                            let _e3466 = ((_e3453 + ((_e3456 - _e3459) * _e2532)) - _e3465);
                                                            let _e3469 = local_1.member[1u];
                                                            let _e3472 = local_1.member_1[1u];
                                                            let _e3475 = local_1.member[1u];
                                                            let _e3481 = local_1.member_2[1u];
                                                            let _e3482 = ((_e3469 + ((_e3472 - _e3475) * _e2532)) - _e3481);
                                                            if (_e3466 < _e3482) {
                                                                phi_8646_ = _e3466;
                                                            } else {
                                                                phi_8646_ = _e3482;
                                                            }
                                                            let _e3485 = phi_8646_;
                                                            let _e3488 = local_1.member[2u];
                                                            let _e3491 = local_1.member_1[2u];
                                                            let _e3494 = local_1.member[2u];
                                                            let _e3500 = local_1.member_2[2u];
                                                            let _e3501 = ((_e3488 + ((_e3491 - _e3494) * _e2532)) - _e3500);
                                                            let _e3504 = local_1.member[3u];
                                                            let _e3507 = local_1.member_1[3u];
                                                            let _e3510 = local_1.member[3u];
                                                            let _e3516 = local_1.member_2[3u];
                                                            let _e3517 = ((_e3504 + ((_e3507 - _e3510) * _e2532)) - _e3516);
                                                            if (_e3501 < _e3517) {
                                                                phi_8719_ = _e3501;
                                                            } else {
                                                                phi_8719_ = _e3517;
                                                            }
                                                            let _e3520 = phi_8719_;
                                                            if (_e3485 < _e3520) {
                                                                phi_8724_ = _e3485;
                                                            } else {
                                                                phi_8724_ = _e3520;
                                                            }
                                                            let _e3523 = phi_8724_;
                                                            let _e3524 = f64(0.0625f);
                                                            let _e3526 = f64(0.9f);
                                                            if (_e3523 > f64(0f)) {
                                                                phi_8747_ = f64(0.5f);
                                                            } else {
                                                                let _e3532 = (f64(0.95f) * (_e3450 / (_e3450 - _e3523)));
                                                                if (_e3532 > _e3524) {
                                                                    if (_e3532 < _e3526) {
                                                                        phi_8745_ = _e3532;
                                                                    } else {
                                                                        phi_8745_ = _e3526;
                                                                    }
                                                                    let _e3536 = phi_8745_;
                                                                    phi_8746_ = _e3536;
                                                                } else {
                                                                    phi_8746_ = _e3524;
                                                                }
                                                                let _e3538 = phi_8746_;
                                                                phi_8747_ = _e3538;
                                                            }
                                                            let _e3540 = phi_8747_;
                                                            phi_8749_ = u32();
                                                            phi_8750_ = (_e2863 * _e3540);
                                                            phi_8751_ = true;
                                                            phi_8752_ = false;
                                                            phi_8753_ = false;
                                                        }
                                                        let _e3547 = phi_8749_;
                                                        let _e3549 = phi_8750_;
                                                        let _e3551 = phi_8751_;
                                                        let _e3553 = phi_8752_;
                                                        let _e3555 = phi_8753_;
                                                        phi_8754_ = _e3547;
                                                        phi_8755_ = _e2534;
                                                        phi_8756_ = _e3549;
                                                        phi_8757_ = _e2536;
                                                        phi_8758_ = _e2538;
                                                        phi_8759_ = _e2540;
                                                        phi_8760_ = _e3551;
                                                        phi_8761_ = _e3553;
                                                        phi_8762_ = _e3555;
                                                        phi_8763_ = false;
                                                        phi_8764_ = false;
                                                    } else {
                                                        phi_8754_ = u32();
                                                        phi_8755_ = _e3366;
                                                        phi_8756_ = _e3368;
                                                        phi_8757_ = _e2532;
                                                        phi_8758_ = true;
                                                        phi_8759_ = 0u;
                                                        phi_8760_ = _e3372;
                                                        phi_8761_ = false;
                                                        phi_8762_ = false;
                                                        phi_8763_ = _e3374;
                                                        phi_8764_ = _e3376;
                                                    }
                                                    let _e3557 = phi_8754_;
                                                    let _e3559 = phi_8755_;
                                                    let _e3561 = phi_8756_;
                                                    let _e3563 = phi_8757_;
                                                    let _e3565 = phi_8758_;
                                                    let _e3567 = phi_8759_;
                                                    let _e3569 = phi_8760_;
                                                    let _e3571 = phi_8761_;
                                                    let _e3573 = phi_8762_;
                                                    let _e3575 = phi_8763_;
                                                    let _e3577 = phi_8764_;
                                                    if _e3569 {
                                                        let _e3578 = (_e3563 + _e3561);
                                                        if (_e3578 > _e3559) {
                                                            phi_8773_ = _e3578;
                                                        } else {
                                                            phi_8773_ = _e3559;
                                                        }
                                                        let _e3581 = phi_8773_;
                                                        if (_e3581 < _e1551.member_1) {
                                                            phi_8778_ = _e3581;
                                                        } else {
                                                            phi_8778_ = _e1551.member_1;
                                                        }
                                                        let _e3584 = phi_8778_;
                                                        if !(_e2538) {
                                                            phi_8788_ = true;
                                                        } else {
                                                            phi_8788_ = ((_e3584 - _e3563) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3589 = phi_8788_;
                                                        if _e3589 {
                                                            phi_8792_ = false;
                                                        } else {
                                                            phi_8792_ = true;
                                                        }
                                                        let _e3591 = phi_8792_;
                                                        phi_8793_ = _e3584;
                                                        phi_8794_ = _e3559;
                                                        phi_8795_ = _e3563;
                                                        phi_8796_ = _e3565;
                                                        phi_8797_ = _e3567;
                                                        phi_8798_ = _e3589;
                                                        phi_8799_ = _e3591;
                                                        phi_8800_ = false;
                                                        phi_8801_ = false;
                                                        phi_8802_ = false;
                                                    } else {
                                                        phi_8793_ = _e2532;
                                                        phi_8794_ = _e2534;
                                                        phi_8795_ = _e2536;
                                                        phi_8796_ = _e2538;
                                                        phi_8797_ = _e3557;
                                                        phi_8798_ = _e3571;
                                                        phi_8799_ = false;
                                                        phi_8800_ = _e3573;
                                                        phi_8801_ = _e3575;
                                                        phi_8802_ = _e3577;
                                                    }
                                                    let _e3593 = phi_8793_;
                                                    let _e3595 = phi_8794_;
                                                    let _e3597 = phi_8795_;
                                                    let _e3599 = phi_8796_;
                                                    let _e3601 = phi_8797_;
                                                    let _e3603 = phi_8798_;
                                                    let _e3605 = phi_8799_;
                                                    let _e3607 = phi_8800_;
                                                    let _e3609 = phi_8801_;
                                                    let _e3611 = phi_8802_;
                                                    phi_7103_ = _e3593;
                                                    phi_7105_ = _e3595;
                                                    phi_7107_ = _e3597;
                                                    phi_7109_ = _e3599;
                                                    phi_7111_ = _e3601;
                                                    phi_8803_ = _e3559;
                                                    phi_8804_ = _e3603;
                                                    phi_8805_ = _e3605;
                                                    phi_8806_ = false;
                                                    phi_8807_ = _e3607;
                                                    phi_8808_ = _e3609;
                                                    phi_8809_ = _e3611;
                                                } else {
                                                    phi_7103_ = f64();
                                                    phi_7105_ = f64();
                                                    phi_7107_ = f64();
                                                    phi_7109_ = bool();
                                                    phi_7111_ = u32();
                                                    phi_8803_ = f64();
                                                    phi_8804_ = false;
                                                    phi_8805_ = false;
                                                    phi_8806_ = true;
                                                    phi_8807_ = false;
                                                    phi_8808_ = false;
                                                    phi_8809_ = false;
                                                }
                                                let _e3613 = phi_7103_;
                                                let _e3615 = phi_7105_;
                                                let _e3617 = phi_7107_;
                                                let _e3619 = phi_7109_;
                                                let _e3621 = phi_7111_;
                                                let _e3623 = phi_8803_;
                                                let _e3625 = phi_8804_;
                                                let _e3627 = phi_8805_;
                                                let _e3629 = phi_8806_;
                                                let _e3631 = phi_8807_;
                                                let _e3633 = phi_8808_;
                                                let _e3635 = phi_8809_;
                                                local_19 = _e3627;
                                                local_35 = _e3623;
                                                local_37 = _e3629;
                                                local_38 = _e3631;
                                                local_39 = _e3633;
                                                local_40 = _e3635;
                                                continue;
                                                continuing {
                                                    phi_7099_ = _e2552;
                                                    phi_7102_ = _e3613;
                                                    phi_7104_ = _e3615;
                                                    phi_7106_ = _e3617;
                                                    phi_7108_ = _e3619;
                                                    phi_7110_ = _e3621;
                                                    break if !(_e3625);
                                                }
                                            }
                                            let _e3638 = local_19;
                                            if _e3638 {
                                                let _e6143 = local_35;
                                                phi_8813_ = _e6143;
                                                phi_8814_ = true;
                                                phi_8815_ = false;
                                                phi_8816_ = false;
                                                phi_8817_ = false;
                                            } else {
                                                let _e6145 = local_36;
                                                phi_8813_ = _e6145;
                                                let _e6148 = local_37;
                                                phi_8814_ = _e6148;
                                                let _e6151 = local_38;
                                                phi_8815_ = _e6151;
                                                let _e6154 = local_39;
                                                phi_8816_ = _e6154;
                                                let _e6157 = local_40;
                                                phi_8817_ = _e6157;
                                            }
                                            let _e3640 = phi_8813_;
                                            let _e3642 = phi_8814_;
                                            let _e3644 = phi_8815_;
                                            let _e3646 = phi_8816_;
                                            let _e3648 = phi_8817_;
                                            if _e3642 {
                                                phi_8822_ = type_44(1u, _e3640);
                                                phi_8823_ = false;
                                                phi_8824_ = false;
                                                phi_8825_ = false;
                                            } else {
                                                phi_8822_ = type_44();
                                                phi_8823_ = _e3644;
                                                phi_8824_ = _e3646;
                                                phi_8825_ = _e3648;
                                            }
                                            let _e3651 = phi_8822_;
                                            let _e3653 = phi_8823_;
                                            let _e3655 = phi_8824_;
                                            let _e3657 = phi_8825_;
                                            if _e3653 {
                                                let _e3659 = local_20;
                                                phi_8830_ = type_44(1u, _e3659);
                                                phi_8831_ = false;
                                                phi_8832_ = false;
                                            } else {
                                                phi_8830_ = type_44();
                                                phi_8831_ = _e3655;
                                                phi_8832_ = _e3657;
                                            }
                                            let _e3662 = phi_8830_;
                                            let _e3664 = phi_8831_;
                                            let _e3666 = phi_8832_;
                                            if _e3664 {
                                                phi_8837_ = type_44(0u, type_44().member_1);
                                                phi_8838_ = false;
                                                phi_8839_ = true;
                                            } else {
                                                phi_8837_ = _e3662;
                                                phi_8838_ = _e3666;
                                                phi_8839_ = _e3653;
                                            }
                                            let _e3670 = phi_8837_;
                                            let _e3672 = phi_8838_;
                                            let _e3674 = phi_8839_;
                                            if _e3672 {
                                                phi_8844_ = type_44(0u, type_44().member_1);
                                                phi_8845_ = true;
                                            } else {
                                                phi_8844_ = _e3670;
                                                phi_8845_ = _e3674;
                                            }
                                            let _e3678 = phi_8844_;
                                            let _e3680 = phi_8845_;
                                            if _e3680 {
                                                phi_8849_ = _e3678;
                                            } else {
                                                phi_8849_ = _e3651;
                                            }
                                            let _e3682 = phi_8849_;
                                            let _e3685 = (_e3682.member != 0u);
                                            if _e3685 {
                                                phi_8856_ = false;
                                            } else {
                                                phi_8856_ = true;
                                            }
                                            let _e3687 = phi_8856_;
                                            phi_8857_ = _e3682.member_1;
                                            phi_8858_ = _e3687;
                                            phi_8859_ = _e3685;
                                            phi_8860_ = false;
                                        } else {
                                            phi_8857_ = f64();
                                            phi_8858_ = false;
                                            phi_8859_ = false;
                                            phi_8860_ = true;
                                        }
                                        let _e3689 = phi_8857_;
                                        let _e3691 = phi_8858_;
                                        let _e3693 = phi_8859_;
                                        let _e3695 = phi_8860_;
                                        phi_8861_ = _e3689;
                                        phi_8862_ = _e3691;
                                        phi_8863_ = _e3693;
                                        phi_8864_ = _e3695;
                                    }
                                    let _e3697 = phi_8861_;
                                    let _e3699 = phi_8862_;
                                    let _e3701 = phi_8863_;
                                    let _e3703 = phi_8864_;
                                    phi_8865_ = _e3697;
                                    phi_8866_ = _e2283;
                                    phi_8867_ = _e3699;
                                    phi_8868_ = _e3701;
                                    phi_8869_ = _e3703;
                                }
                                let _e3705 = phi_8865_;
                                let _e3707 = phi_8866_;
                                let _e3709 = phi_8867_;
                                let _e3711 = phi_8868_;
                                let _e3713 = phi_8869_;
                                if _e3707 {
                                    phi_8873_ = true;
                                    phi_8874_ = false;
                                    phi_8875_ = false;
                                } else {
                                    phi_8873_ = _e3709;
                                    phi_8874_ = _e3711;
                                    phi_8875_ = _e3713;
                                }
                                let _e3715 = phi_8873_;
                                let _e3717 = phi_8874_;
                                let _e3719 = phi_8875_;
                                phi_8876_ = _e3705;
                                phi_8877_ = _e1551;
                                phi_8878_ = _e3715;
                                phi_8879_ = false;
                                phi_8880_ = _e3717;
                                phi_8881_ = _e3719;
                            } else {
                                phi_8876_ = f64();
                                phi_8877_ = type_45();
                                phi_8878_ = false;
                                phi_8879_ = true;
                                phi_8880_ = false;
                                phi_8881_ = false;
                            }
                            let _e3721 = phi_8876_;
                            let _e3723 = phi_8877_;
                            let _e3725 = phi_8878_;
                            let _e3727 = phi_8879_;
                            let _e3729 = phi_8880_;
                            let _e3731 = phi_8881_;
                            local_21 = _e3727;
                            local_41 = _e3729;
                            local_42 = _e3731;
                            local_22 = _e3721;
                            local_23 = _e3723;
                            continue;
                            continuing {
                                phi_5188_ = _e1264;
                                break if !(_e3725);
                            }
                        }
                        let _e3734 = local_21;
                        if _e3734 {
                            phi_8886_ = type_44(0u, type_44().member_1);
                            phi_8887_ = false;
                            phi_8888_ = false;
                        } else {
                            phi_8886_ = type_44();
                            let _e6199 = local_41;
                            phi_8887_ = _e6199;
                            let _e6202 = local_42;
                            phi_8888_ = _e6202;
                        }
                        let _e3738 = phi_8886_;
                        let _e3740 = phi_8887_;
                        let _e3742 = phi_8888_;
                        if _e3740 {
                            let _e3744 = local_22;
                            phi_8893_ = type_44(2u, _e3744);
                            phi_8894_ = false;
                        } else {
                            phi_8893_ = type_44();
                            phi_8894_ = _e3742;
                        }
                        let _e3747 = phi_8893_;
                        let _e3749 = phi_8894_;
                        if _e3749 {
                            let _e3751 = local_23;
                            phi_8900_ = type_44(1u, _e3751.member);
                            phi_8901_ = true;
                        } else {
                            phi_8900_ = _e3747;
                            phi_8901_ = _e3740;
                        }
                        let _e3755 = phi_8900_;
                        let _e3757 = phi_8901_;
                        if _e3757 {
                            phi_8905_ = _e3755;
                        } else {
                            phi_8905_ = _e3738;
                        }
                        let _e3759 = phi_8905_;
                        phi_8909_ = _e3759;
                    }
                    let _e5526 = phi_8909_;
                    phi_8910_ = _e5526;
                }
                let _e5530 = phi_8910_;
                switch bitcast<i32>(_e5530.member) {
                    case 0: {
                        phi_8923_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5536 = function_3(_e5530.member_1);
                        phi_8923_ = type_32(0u, _e5536, true);
                        break;
                    }
                    case 2: {
                        let _e5534 = function_3(_e5530.member_1);
                        phi_8923_ = type_32(1u, _e5534, true);
                        break;
                    }
                    default: {
                        phi_8923_ = type_32();
                        break;
                    }
                }
                let _e5539 = phi_8923_;
                if _e5539.member_2 {
                    let _e5546 = (_e5539.member_1[1] >> bitcast<u32>(20i));
                    if (_e5546 <= 896u) {
                        phi_8946_ = 0u;
                    } else {
                        phi_8946_ = ((((_e5546 - 896u) << bitcast<u32>(23i)) | ((_e5539.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5539.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5561 = phi_8946_;
                    let _e5563 = atomicMin((&earliest.member[0u]), _e5561);
                }
                phi_8950_ = type_22(0u, _e5539.member, _e181, _e184, _e5539.member_1);
                phi_8951_ = _e5539.member_2;
            } else {
                phi_8950_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8951_ = false;
            }
            let _e5565 = phi_8950_;
            let _e5567 = phi_8951_;
            let _e5570 = params.member.member.member_1;
            if ((_e5570 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5567 {
                    let _e5576 = atomicAdd((&counters[0u]), 1u);
                    phi_8970_ = _e5576;
                } else {
                    phi_8970_ = 0u;
                }
                let _e5578 = phi_8970_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5581 = atomicLoad((&counters[0u]));
                    if (_e5581 > 0u) {
                        let _e5584 = atomicAdd((&contacts.member[0u]), _e5581);
                        atomicStore((&counters[1u]), _e5584);
                    }
                }
                workgroupBarrier();
                let _e5587 = atomicLoad((&counters[1u]));
                let _e5588 = (_e5587 + _e5578);
                if _e5567 {
                    let _e5591 = params.member.member_1.member_3;
                    if (_e5588 < _e5591) {
                        let _e5593 = (6u * _e5588);
                        atomicStore((&contacts.member[(4u + _e5593)]), _e5565.member);
                        atomicStore((&contacts.member[(_e5593 + 5u)]), _e5565.member_1);
                        atomicStore((&contacts.member[(_e5593 + 6u)]), _e5565.member_2);
                        atomicStore((&contacts.member[(_e5593 + 7u)]), _e5565.member_3);
                        atomicStore((&contacts.member[(_e5593 + 8u)]), _e5565.member_4[0]);
                        atomicStore((&contacts.member[(_e5593 + 9u)]), _e5565.member_4[1]);
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
