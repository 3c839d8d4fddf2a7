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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: type_17,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_24 {
    member: type_20,
    member_1: u32,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> sorted: type_19;
@group(0) @binding(3) 
var<storage> survey: type_11;
@group(0) @binding(4) 
var<storage, read_write> work: type_27;
var<workgroup> ranges: array<atomic<u32>, 656>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_17;
    var local_2: type_20;
    var local_3: array<f32, 3>;
    var local_4: type_17;
    var local_5: type_17;
    var local_6: type_20;
    var local_7: type_17;
    var phi_170_: u32;
    var phi_177_: array<u32, 2>;
    var phi_184_: u32;
    var phi_189_: u32;
    var phi_197_: array<u32, 2>;
    var phi_213_: type_14;
    var phi_216_: u32;
    var phi_218_: u32;
    var phi_239_: bool;
    var phi_245_: type_15;
    var phi_214_: type_14;
    var phi_259_: type_15;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_290_: u32;
    var phi_291_: u32;
    var phi_292_: bool;
    var phi_217_: u32;
    var phi_219_: u32;
    var phi_293_: bool;
    var local_8: u32;
    var phi_316_: array<u32, 2>;
    var phi_323_: u32;
    var phi_328_: u32;
    var phi_336_: array<u32, 2>;
    var phi_395_: u32;
    var phi_398_: type_9;
    var phi_399_: type_9;
    var phi_422_: type_9;
    var phi_438_: u32;
    var phi_443_: u32;
    var phi_446_: bool;
    var phi_461_: u32;
    var phi_462_: u32;
    var phi_463_: u32;
    var phi_464_: bool;
    var phi_468_: u32;
    var phi_473_: u32;
    var phi_485_: u32;
    var phi_501_: array<u32, 2>;
    var phi_502_: array<u32, 2>;
    var phi_504_: array<u32, 2>;
    var phi_532_: u32;
    var phi_551_: u32;
    var phi_570_: u32;
    var phi_575_: type_9;
    var phi_576_: type_9;
    var phi_599_: type_9;
    var phi_625_: u32;
    var phi_651_: u32;
    var phi_784_: type_9;
    var phi_787_: type_24;
    var phi_785_: type_9;
    var phi_810_: type_9;
    var phi_820_: type_9;
    var phi_823_: bool;
    var phi_821_: type_9;
    var phi_846_: type_9;
    var phi_868_: f32;
    var phi_885_: bool;
    var phi_824_: bool;
    var local_9: bool;
    var phi_891_: type_24;
    var phi_892_: bool;
    var phi_788_: type_24;
    var phi_893_: bool;
    var phi_901_: u32;
    var local_10: type_24;
    var local_11: type_24;
    var local_12: type_24;
    var phi_911_: u32;
    var local_13: type_24;
    var phi_918_: u32;
    var local_14: type_24;
    var local_15: type_24;
    var local_16: type_24;
    var phi_950_: type_9;
    var phi_951_: type_9;
    var phi_974_: type_9;
    var phi_1025_: f32;
    var phi_1030_: f32;
    var phi_1071_: type_9;
    var phi_1072_: type_9;
    var phi_1095_: type_9;
    var phi_1123_: f32;
    var phi_1138_: f32;
    var phi_1165_: u32;
    var phi_1166_: u32;
    var phi_1178_: array<u32, 3>;
    var phi_1179_: array<u32, 3>;
    var phi_1180_: array<u32, 3>;
    var phi_1183_: type_9;
    var phi_1184_: type_9;
    var phi_1207_: type_9;
    var phi_1232_: array<u32, 2>;
    var phi_1239_: u32;
    var phi_1244_: u32;
    var phi_1252_: array<u32, 2>;
    var phi_1342_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1405_: u32;
    var phi_1406_: bool;
    var phi_1407_: u32;
    var phi_1408_: bool;
    var phi_1413_: u32;
    var phi_1423_: u32;
    var phi_1437_: array<u32, 2>;
    var phi_1438_: array<u32, 2>;
    var phi_1439_: bool;
    var phi_1440_: array<u32, 2>;
    var phi_1441_: bool;
    var phi_1442_: array<u32, 2>;
    var phi_1443_: bool;
    var phi_1448_: array<u32, 2>;
    var phi_1449_: array<u32, 2>;
    var phi_1457_: array<u32, 2>;
    var phi_1458_: bool;
    var phi_1459_: array<u32, 2>;
    var phi_1460_: bool;
    var phi_1465_: array<u32, 2>;
    var phi_1472_: array<u32, 2>;
    var phi_1309_: f32;
    var phi_1310_: f32;
    var phi_1316_: u32;
    var phi_1326_: u32;
    var phi_1473_: array<u32, 2>;
    var phi_1498_: type_14;
    var phi_1501_: u32;
    var phi_1503_: u32;
    var phi_1524_: bool;
    var phi_1530_: type_15;
    var phi_1499_: type_14;
    var phi_1544_: type_15;
    var phi_1573_: u32;
    var phi_1574_: u32;
    var phi_1575_: u32;
    var phi_1576_: u32;
    var phi_1577_: bool;
    var phi_1502_: u32;
    var phi_1504_: u32;
    var phi_1578_: bool;
    var local_17: u32;
    var phi_1593_: u32;
    var phi_1594_: u32;
    var phi_1598_: type_14;
    var phi_1601_: u32;
    var phi_1603_: u32;
    var phi_1624_: bool;
    var phi_1630_: type_15;
    var phi_1599_: type_14;
    var phi_1644_: type_15;
    var phi_1673_: u32;
    var phi_1674_: u32;
    var phi_1675_: u32;
    var phi_1676_: u32;
    var phi_1677_: bool;
    var phi_1602_: u32;
    var phi_1604_: u32;
    var phi_1678_: bool;
    var local_18: u32;
    var local_19: u32;
    var phi_1699_: u32;
    var phi_1712_: u32;
    var phi_1713_: u32;
    var phi_1714_: u32;
    var phi_1715_: u32;
    var phi_1726_: u32;
    var phi_1730_: type_9;
    var phi_1731_: type_9;
    var phi_1754_: type_9;
    var phi_1788_: u32;
    var phi_1789_: u32;
    var phi_1805_: u32;
    var phi_1808_: type_9;
    var phi_1809_: type_9;
    var phi_1832_: type_9;
    var phi_1853_: u32;
    var phi_1869_: u32;
    var local_20: u32;
    var local_21: u32;
    var local_22: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e85 = id_2;
    let _e86 = n_2;
    let _e87 = lane_2;
    let _e97 = ((_e85.y * _e86.x) + _e85.x);
    let _e100 = params.member.member_2.member;
    let _e103 = params.member.member_2.member_1;
    let _e106 = params.member.member_2.member_2;
    let _e110 = params.member.member.member_2[3u];
    if (_e100 == 2u) {
        phi_170_ = 10u;
    } else {
        phi_170_ = 1u;
    }
    let _e113 = phi_170_;
    if (_e103 == 0u) {
        phi_177_ = array<u32, 2>(0u, 2u);
    } else {
        phi_177_ = array<u32, 2>(1u, 1u);
    }
    let _e116 = phi_177_;
    if (_e100 == 2u) {
        phi_184_ = 8u;
    } else {
        phi_184_ = 1u;
    }
    let _e121 = phi_184_;
    if (_e100 == 2u) {
        phi_189_ = 10u;
    } else {
        phi_189_ = 1u;
    }
    let _e124 = phi_189_;
    if (_e106 >= (_e121 * _e124)) {
        phi_197_ = array<u32, 2>(_e116[1], _e116[0]);
    } else {
        phi_197_ = _e116;
    }
    let _e129 = phi_197_;
    atomicStore((&ranges[_e87]), 4294967295u);
    atomicStore((&ranges[(128u + _e87)]), 0u);
    if (_e87 <= 8u) {
        phi_213_ = type_14(0i, 32i);
        phi_216_ = 0u;
        phi_218_ = _e110;
        loop {
            let _e142 = phi_213_;
            let _e144 = phi_216_;
            let _e146 = phi_218_;
            local_8 = _e144;
            if (_e142.member < _e142.member_1) {
                let _e153 = (_e142.member + 1i);
                if ((false == (_e153 > _e142.member)) != false) {
                    phi_239_ = true;
                } else {
                    phi_239_ = false;
                }
                let _e158 = phi_239_;
                if _e158 {
                    phi_245_ = type_15(0u, type_15().member_1);
                } else {
                    phi_245_ = type_15(1u, _e153);
                }
                let _e163 = phi_245_;
                phi_214_ = type_14(_e163.member_1, _e142.member_1);
                phi_259_ = type_15(1u, _e142.member);
            } else {
                phi_214_ = _e142;
                phi_259_ = type_15(0u, type_15().member_1);
            }
            let _e169 = phi_214_;
            let _e171 = phi_259_;
            if (bitcast<i32>(_e171.member) != 0i) {
                if (_e144 >= _e146) {
                    phi_290_ = u32();
                    phi_291_ = u32();
                    phi_292_ = false;
                } else {
                    let _e178 = (_e144 + ((_e146 - _e144) / 2u));
                    let _e180 = keys.member[_e178];
                    if (_e180 < ((_e129[1] << bitcast<u32>(30u)) + (_e87 << bitcast<u32>(27u)))) {
                        phi_288_ = (_e178 + 1u);
                        phi_289_ = _e146;
                    } else {
                        phi_288_ = _e144;
                        phi_289_ = _e178;
                    }
                    let _e184 = phi_288_;
                    let _e186 = phi_289_;
                    phi_290_ = _e184;
                    phi_291_ = _e186;
                    phi_292_ = true;
                }
                let _e188 = phi_290_;
                let _e190 = phi_291_;
                let _e192 = phi_292_;
                phi_217_ = _e188;
                phi_219_ = _e190;
                phi_293_ = _e192;
            } else {
                phi_217_ = u32();
                phi_219_ = u32();
                phi_293_ = false;
            }
            let _e194 = phi_217_;
            let _e196 = phi_219_;
            let _e198 = phi_293_;
            continue;
            continuing {
                phi_213_ = _e169;
                phi_216_ = _e194;
                phi_218_ = _e196;
                break if !(_e198);
            }
        }
        let _e202 = local_8;
        atomicStore((&ranges[(640u + _e87)]), _e202);
    }
    workgroupBarrier();
    let _e205 = params.member.member_2.member;
    let _e208 = params.member.member_2.member_1;
    if (_e208 == 0u) {
        phi_316_ = array<u32, 2>(0u, 2u);
    } else {
        phi_316_ = array<u32, 2>(1u, 1u);
    }
    let _e211 = phi_316_;
    if (_e205 == 2u) {
        phi_323_ = 8u;
    } else {
        phi_323_ = 1u;
    }
    let _e216 = phi_323_;
    if (_e205 == 2u) {
        phi_328_ = 10u;
    } else {
        phi_328_ = 1u;
    }
    let _e219 = phi_328_;
    if (_e106 >= (_e216 * _e219)) {
        phi_336_ = array<u32, 2>(_e211[1], _e211[0]);
    } else {
        phi_336_ = _e211;
    }
    let _e224 = phi_336_;
    let _e227 = ((_e97 * 128u) + _e87);
    let _e231 = params.member.member.member_2[_e224[0]];
    let _e232 = (_e231 + _e227);
    let _e236 = params.member.member.member[_e224[0]];
    if (_e227 < _e236) {
        let _e239 = keys.member[_e232];
        let _e241 = sorted.member[_e232];
        local_7 = type_17(array<f32, 3>(_e241.member[0], _e241.member[1], _e241.member[2]), array<f32, 3>(_e241.member_1[0], _e241.member_1[1], _e241.member_1[2]));
        if (_e100 == 2u) {
            phi_395_ = 8u;
        } else {
            phi_395_ = 1u;
        }
        let _e255 = phi_395_;
        phi_398_ = type_9(0u, _e255);
        loop {
            let _e258 = phi_398_;
            if (_e258.member < _e258.member_1) {
                phi_399_ = type_9((_e258.member + 1u), _e258.member_1);
                phi_422_ = type_9(1u, _e258.member);
            } else {
                phi_399_ = _e258;
                phi_422_ = type_9(0u, type_9().member_1);
            }
            let _e270 = phi_399_;
            let _e272 = phi_422_;
            let _e276 = (bitcast<i32>(_e272.member) != 0i);
            if _e276 {
                if (_e272.member_1 == 0u) {
                    if (_e100 == 2u) {
                        phi_438_ = 8u;
                    } else {
                        phi_438_ = 1u;
                    }
                    let _e280 = phi_438_;
                    if (_e100 == 2u) {
                        phi_443_ = 10u;
                    } else {
                        phi_443_ = 1u;
                    }
                    let _e283 = phi_443_;
                    phi_446_ = (_e106 >= (_e280 * _e283));
                } else {
                    phi_446_ = false;
                }
                let _e287 = phi_446_;
                if (_e100 != 2u) {
                    phi_463_ = u32();
                    phi_464_ = true;
                } else {
                    if _e287 {
                        phi_462_ = u32();
                    } else {
                        let _e292 = (((_e239 >> bitcast<u32>(27u)) % 8u) + _e272.member_1);
                        if (_e292 < 8u) {
                            phi_461_ = _e292;
                        } else {
                            phi_461_ = 8u;
                        }
                        let _e295 = phi_461_;
                        phi_462_ = _e295;
                    }
                    let _e297 = phi_462_;
                    phi_463_ = _e297;
                    phi_464_ = _e287;
                }
                let _e299 = phi_463_;
                let _e301 = phi_464_;
                if _e301 {
                    phi_468_ = 8u;
                } else {
                    phi_468_ = _e299;
                }
                let _e303 = phi_468_;
                if (7u < _e303) {
                    phi_473_ = 7u;
                } else {
                    phi_473_ = _e303;
                }
                let _e306 = phi_473_;
                if (_e303 < 8u) {
                    let _e311 = atomicLoad((&ranges[(_e306 + 641u)]));
                    let _e313 = atomicLoad((&ranges[(640u + _e306)]));
                    phi_485_ = (_e311 - _e313);
                } else {
                    phi_485_ = 0u;
                }
                let _e316 = phi_485_;
                if (_e100 == 2u) {
                    if (_e316 == 0u) {
                        phi_502_ = array<u32, 2>(0u, 0u);
                    } else {
                        if (_e316 <= 256u) {
                            phi_501_ = array<u32, 2>(9u, 10u);
                        } else {
                            phi_501_ = array<u32, 2>(0u, 9u);
                        }
                        let _e321 = phi_501_;
                        phi_502_ = _e321;
                    }
                    let _e323 = phi_502_;
                    phi_504_ = _e323;
                } else {
                    phi_504_ = array<u32, 2>(0u, 1u);
                }
                let _e325 = phi_504_;
                if (_e325[0] < _e325[1]) {
                    if (_e100 == 2u) {
                        let _e331 = survey.member[6u];
                        if ((_e331 >> bitcast<u32>(31i)) == 1u) {
                            phi_532_ = (_e331 & 2147483647u);
                        } else {
                            phi_532_ = ~(_e331);
                        }
                        let _e338 = phi_532_;
                        let _e339 = bitcast<f32>(_e338);
                        let _e341 = survey.member[7u];
                        if ((_e341 >> bitcast<u32>(31i)) == 1u) {
                            phi_551_ = (_e341 & 2147483647u);
                        } else {
                            phi_551_ = ~(_e341);
                        }
                        let _e348 = phi_551_;
                        let _e349 = bitcast<f32>(_e348);
                        let _e351 = survey.member[8u];
                        if ((_e351 >> bitcast<u32>(31i)) == 1u) {
                            phi_570_ = (_e351 & 2147483647u);
                        } else {
                            phi_570_ = ~(_e351);
                        }
                        let _e358 = phi_570_;
                        let _e359 = bitcast<f32>(_e358);
                        local_5 = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_575_ = type_9(0u, 3u);
                        loop {
                            let _e361 = phi_575_;
                            if (_e361.member < _e361.member_1) {
                                phi_576_ = type_9((_e361.member + 1u), _e361.member_1);
                                phi_599_ = type_9(1u, _e361.member);
                            } else {
                                phi_576_ = _e361;
                                phi_599_ = type_9(0u, type_9().member_1);
                            }
                            let _e373 = phi_576_;
                            let _e375 = phi_599_;
                            let _e379 = (bitcast<i32>(_e375.member) != 0i);
                            if _e379 {
                                let _e381 = survey.member[_e375.member_1];
                                let _e382 = ~(_e381);
                                if ((_e382 >> bitcast<u32>(31i)) == 1u) {
                                    phi_625_ = (_e382 & 2147483647u);
                                } else {
                                    phi_625_ = ~(_e382);
                                }
                                let _e389 = phi_625_;
                                local_5.member[_e375.member_1] = bitcast<f32>(_e389);
                                let _e395 = survey.member[(3u + _e375.member_1)];
                                if ((_e395 >> bitcast<u32>(31i)) == 1u) {
                                    phi_651_ = (_e395 & 2147483647u);
                                } else {
                                    phi_651_ = ~(_e395);
                                }
                                let _e402 = phi_651_;
                                local_5.member_1[_e375.member_1] = bitcast<f32>(_e402);
                            }
                            continue;
                            continuing {
                                phi_575_ = _e373;
                                break if !(_e379);
                            }
                        }
                        let _e407 = local_5;
                        local_6 = type_20(_e407, array<f32, 3>(_e339, _e349, _e359));
                        if (_e272.member_1 == 0u) {
                            let _e717 = (_e239 & 134217727u);
                            phi_1178_ = array<u32, 3>((_e717 & 511u), ((_e717 >> bitcast<u32>(9u)) & 511u), (_e717 >> bitcast<u32>(18u)));
                        } else {
                            let _e428 = local_6.member.member_1[0u];
                            let _e432 = local_6.member.member[0u];
                            let _e437 = local_6.member.member_1[1u];
                            let _e441 = local_6.member.member[1u];
                            let _e446 = local_6.member.member_1[2u];
                            let _e450 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e428 * 0.5f) - (_e432 * 0.5f)), ((_e437 * 0.5f) - (_e441 * 0.5f)), ((_e446 * 0.5f) - (_e450 * 0.5f)));
                            phi_784_ = type_9(0u, 9u);
                            phi_787_ = type_24(type_20(type_17(array<f32, 3>(_e407.member[0], _e407.member[1], _e407.member[2]), array<f32, 3>(_e407.member_1[0], _e407.member_1[1], _e407.member_1[2])), array<f32, 3>(_e339, _e349, _e359)), 0u);
                            loop {
                                let _e455 = phi_784_;
                                let _e457 = phi_787_;
                                local_10 = _e457;
                                local_11 = _e457;
                                local_12 = _e457;
                                local_13 = _e457;
                                local_14 = _e457;
                                local_15 = _e457;
                                local_16 = _e457;
                                if (_e455.member < _e455.member_1) {
                                    phi_785_ = type_9((_e455.member + 1u), _e455.member_1);
                                    phi_810_ = type_9(1u, _e455.member);
                                } else {
                                    phi_785_ = _e455;
                                    phi_810_ = type_9(0u, type_9().member_1);
                                }
                                let _e469 = phi_785_;
                                let _e471 = phi_810_;
                                if (bitcast<i32>(_e471.member) != 0i) {
                                    phi_820_ = type_9(0u, 3u);
                                    phi_823_ = true;
                                    loop {
                                        let _e477 = phi_820_;
                                        let _e479 = phi_823_;
                                        local_9 = _e479;
                                        if (_e477.member < _e477.member_1) {
                                            phi_821_ = type_9((_e477.member + 1u), _e477.member_1);
                                            phi_846_ = type_9(1u, _e477.member);
                                        } else {
                                            phi_821_ = _e477;
                                            phi_846_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e491 = phi_821_;
                                        let _e493 = phi_846_;
                                        let _e497 = (bitcast<i32>(_e493.member) != 0i);
                                        if _e497 {
                                            let _e499 = local_3[_e493.member_1];
                                            let _e501 = (_e499 * (1f / 512f));
                                            if (_e501 > 0.000000000000000000000000000006310887f) {
                                                phi_868_ = _e501;
                                            } else {
                                                phi_868_ = 0.000000000000000000000000000006310887f;
                                            }
                                            let _e504 = phi_868_;
                                            let _e507 = local_6.member_1[_e493.member_1];
                                            if ((_e507 * bitcast<f32>(((127u - _e471.member_1) << bitcast<u32>(23i)))) > _e504) {
                                                phi_885_ = false;
                                            } else {
                                                phi_885_ = _e479;
                                            }
                                            let _e515 = phi_885_;
                                            phi_824_ = _e515;
                                        } else {
                                            phi_824_ = bool();
                                        }
                                        let _e517 = phi_824_;
                                        continue;
                                        continuing {
                                            phi_820_ = _e491;
                                            phi_823_ = _e517;
                                            break if !(_e497);
                                        }
                                    }
                                    let _e520 = local_9;
                                    if _e520 {
                                        phi_891_ = type_24();
                                        phi_892_ = false;
                                    } else {
                                        phi_891_ = type_24(_e457.member, (_e471.member_1 + 1u));
                                        phi_892_ = true;
                                    }
                                    let _e525 = phi_891_;
                                    let _e527 = phi_892_;
                                    phi_788_ = _e525;
                                    phi_893_ = _e527;
                                } else {
                                    phi_788_ = type_24();
                                    phi_893_ = false;
                                }
                                let _e529 = phi_788_;
                                let _e531 = phi_893_;
                                continue;
                                continuing {
                                    phi_784_ = _e469;
                                    phi_787_ = _e529;
                                    break if !(_e531);
                                }
                            }
                            let _e536 = (((_e239 >> bitcast<u32>(27u)) % 8u) + _e272.member_1);
                            if (_e536 < 8u) {
                                phi_901_ = _e536;
                            } else {
                                phi_901_ = 8u;
                            }
                            let _e539 = phi_901_;
                            let _e541 = local_10;
                            let _e546 = local_11;
                            if (_e546.member_1 < 8u) {
                                let _e550 = local_12;
                                phi_911_ = (_e550.member_1 + 1u);
                            } else {
                                phi_911_ = 8u;
                            }
                            let _e554 = phi_911_;
                            if ((_e539 + 1u) >= _e554) {
                                phi_918_ = 0u;
                            } else {
                                let _e557 = local_13;
                                phi_918_ = (_e557.member_1 - _e539);
                            }
                            let _e561 = phi_918_;
                            let _e565 = bitcast<f32>(((127u - _e561) << bitcast<u32>(23i)));
                            let _e567 = local_14;
                            let _e573 = local_15;
                            let _e579 = local_16;
                            local_2.member = type_17(array<f32, 3>(_e541.member.member.member[0], _e541.member.member.member[1], _e541.member.member.member[2]), array<f32, 3>(_e541.member.member.member_1[0], _e541.member.member.member_1[1], _e541.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e567.member.member_1[0] * _e565), (_e573.member.member_1[1] * _e565), (_e579.member.member_1[2] * _e565));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_950_ = type_9(0u, 3u);
                            loop {
                                let _e601 = phi_950_;
                                if (_e601.member < _e601.member_1) {
                                    phi_951_ = type_9((_e601.member + 1u), _e601.member_1);
                                    phi_974_ = type_9(1u, _e601.member);
                                } else {
                                    phi_951_ = _e601;
                                    phi_974_ = type_9(0u, type_9().member_1);
                                }
                                let _e613 = phi_951_;
                                let _e615 = phi_974_;
                                let _e619 = (bitcast<i32>(_e615.member) != 0i);
                                if _e619 {
                                    let _e623 = local_2.member.member[_e615.member_1];
                                    let _e627 = local_2.member.member_1[_e615.member_1];
                                    let _e632 = (((_e627 * 0.5f) - (_e623 * 0.5f)) * (1f / 512f));
                                    let _e635 = local_2.member_1[_e615.member_1];
                                    let _e638 = local_2.member_1[_e615.member_1];
                                    let _e640 = (_e635 + (_e638 * 0.00390625f));
                                    if (_e632 > _e640) {
                                        phi_1025_ = _e632;
                                    } else {
                                        phi_1025_ = _e640;
                                    }
                                    let _e643 = phi_1025_;
                                    if (0.000000000000000000000000000006310887f > _e643) {
                                        phi_1030_ = 0.000000000000000000000000000006310887f;
                                    } else {
                                        phi_1030_ = _e643;
                                    }
                                    let _e646 = phi_1030_;
                                    local_1.member[_e615.member_1] = (_e623 * 0.25f);
                                    local_1.member_1[_e615.member_1] = (1f / _e646);
                                }
                                continue;
                                continuing {
                                    phi_950_ = _e613;
                                    break if !(_e619);
                                }
                            }
                            let _e654 = local_1;
                            local_4 = _e654;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1071_ = type_9(0u, 3u);
                            loop {
                                let _e656 = phi_1071_;
                                if (_e656.member < _e656.member_1) {
                                    phi_1072_ = type_9((_e656.member + 1u), _e656.member_1);
                                    phi_1095_ = type_9(1u, _e656.member);
                                } else {
                                    phi_1072_ = _e656;
                                    phi_1095_ = type_9(0u, type_9().member_1);
                                }
                                let _e668 = phi_1072_;
                                let _e670 = phi_1095_;
                                let _e674 = (bitcast<i32>(_e670.member) != 0i);
                                if _e674 {
                                    let _e677 = local_4.member[_e670.member_1];
                                    let _e680 = local_7.member[_e670.member_1];
                                    let _e682 = ((_e680 * 0.25f) - _e677);
                                    if (_e682 > 0f) {
                                        phi_1123_ = _e682;
                                    } else {
                                        phi_1123_ = 0f;
                                    }
                                    let _e685 = phi_1123_;
                                    let _e688 = local_7.member_1[_e670.member_1];
                                    let _e690 = ((_e688 * 0.25f) - _e677);
                                    if (_e690 > 0f) {
                                        phi_1138_ = _e690;
                                    } else {
                                        phi_1138_ = 0f;
                                    }
                                    let _e693 = phi_1138_;
                                    let _e697 = local_4.member_1[_e670.member_1];
                                    let _e698 = ((_e685 + _e693) * _e697);
                                    if (_e698 >= 511f) {
                                        phi_1166_ = 511u;
                                    } else {
                                        if (_e698 > 0f) {
                                            phi_1165_ = select(select(u32(_e698), 0u, (_e698 < 0f)), 4294967295u, (_e698 > 4294967000f));
                                        } else {
                                            phi_1165_ = 0u;
                                        }
                                        let _e707 = phi_1165_;
                                        phi_1166_ = _e707;
                                    }
                                    let _e709 = phi_1166_;
                                    local[_e670.member_1] = _e709;
                                }
                                continue;
                                continuing {
                                    phi_1071_ = _e668;
                                    break if !(_e674);
                                }
                            }
                            let _e712 = local;
                            phi_1178_ = array<u32, 3>(_e712[0], _e712[1], _e712[2]);
                        }
                        let _e726 = phi_1178_;
                        phi_1179_ = _e726;
                    } else {
                        phi_1179_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e728 = phi_1179_;
                    phi_1180_ = _e728;
                } else {
                    phi_1180_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e730 = phi_1180_;
                phi_1183_ = type_9(_e325[0], _e325[1]);
                loop {
                    let _e733 = phi_1183_;
                    if (_e733.member < _e733.member_1) {
                        phi_1184_ = type_9((_e733.member + 1u), _e733.member_1);
                        phi_1207_ = type_9(1u, _e733.member);
                    } else {
                        phi_1184_ = _e733;
                        phi_1207_ = type_9(0u, type_9().member_1);
                    }
                    let _e745 = phi_1184_;
                    let _e747 = phi_1207_;
                    let _e751 = (bitcast<i32>(_e747.member) != 0i);
                    if _e751 {
                        let _e753 = ((_e272.member_1 * _e113) + _e747.member_1);
                        let _e754 = (_e106 + _e753);
                        let _e757 = params.member.member_2.member;
                        let _e760 = params.member.member_2.member_1;
                        if (_e760 == 0u) {
                            phi_1232_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_1232_ = array<u32, 2>(1u, 1u);
                        }
                        let _e763 = phi_1232_;
                        if (_e757 == 2u) {
                            phi_1239_ = 8u;
                        } else {
                            phi_1239_ = 1u;
                        }
                        let _e768 = phi_1239_;
                        if (_e757 == 2u) {
                            phi_1244_ = 10u;
                        } else {
                            phi_1244_ = 1u;
                        }
                        let _e771 = phi_1244_;
                        if (_e754 >= (_e768 * _e771)) {
                            phi_1252_ = array<u32, 2>(_e763[1], _e763[0]);
                        } else {
                            phi_1252_ = _e763;
                        }
                        let _e776 = phi_1252_;
                        let _e779 = keys.member[_e232];
                        let _e781 = sorted.member[_e232];
                        let _e783 = (_e776[1] << bitcast<u32>(30u));
                        if (_e757 == 1u) {
                            let _e904 = survey.member[6u];
                            if (_e904 == 0u) {
                                phi_1310_ = _e781.member_1[0];
                            } else {
                                if (_e904 == 1u) {
                                    phi_1309_ = _e781.member_1[1];
                                } else {
                                    phi_1309_ = _e781.member_1[2];
                                }
                                let _e912 = phi_1309_;
                                phi_1310_ = _e912;
                            }
                            let _e916 = phi_1310_;
                            let _e917 = bitcast<u32>(_e916);
                            if (_e917 == 2147483648u) {
                                phi_1316_ = 0u;
                            } else {
                                phi_1316_ = _e917;
                            }
                            let _e920 = phi_1316_;
                            let _e922 = bitcast<u32>(bitcast<f32>(_e920));
                            if ((_e922 >> bitcast<u32>(31i)) == 1u) {
                                phi_1326_ = ~(_e922);
                            } else {
                                phi_1326_ = (_e922 | 2147483648u);
                            }
                            let _e929 = phi_1326_;
                            phi_1473_ = array<u32, 2>(((_e783 | (_e779 & 1073741823u)) + _e754), (_e783 | (_e929 >> bitcast<u32>(2i))));
                        } else {
                            if (_e757 == 2u) {
                                let _e787 = (_e754 % 80u);
                                let _e789 = (_e787 % 10u);
                                if (_e760 == 1u) {
                                    phi_1342_ = ((_e787 / 10u) == 0u);
                                } else {
                                    phi_1342_ = false;
                                }
                                let _e793 = phi_1342_;
                                if (_e303 >= 8u) {
                                    phi_1459_ = array<u32, 2>();
                                    phi_1460_ = true;
                                } else {
                                    if _e793 {
                                        if (_e789 < 4u) {
                                            phi_1354_ = false;
                                        } else {
                                            phi_1354_ = true;
                                        }
                                        let _e797 = phi_1354_;
                                        phi_1355_ = _e797;
                                    } else {
                                        phi_1355_ = true;
                                    }
                                    let _e799 = phi_1355_;
                                    if _e799 {
                                        if (_e789 == 9u) {
                                            phi_1449_ = array<u32, 2>(0u, 134217727u);
                                        } else {
                                            let _e803 = (_e730[1] + (_e789 % 3u));
                                            let _e806 = (_e730[2] + (_e789 / 3u));
                                            if (_e803 < 1u) {
                                                phi_1442_ = array<u32, 2>();
                                                phi_1443_ = true;
                                            } else {
                                                if (_e806 < 1u) {
                                                    phi_1440_ = array<u32, 2>();
                                                    phi_1441_ = true;
                                                } else {
                                                    if (_e803 > 512u) {
                                                        phi_1438_ = array<u32, 2>();
                                                        phi_1439_ = true;
                                                    } else {
                                                        let _e810 = (_e806 > 512u);
                                                        if _e810 {
                                                            phi_1437_ = array<u32, 2>();
                                                        } else {
                                                            if (_e730[0] > 0u) {
                                                                if _e793 {
                                                                    if (_e789 == 4u) {
                                                                        phi_1398_ = false;
                                                                    } else {
                                                                        phi_1398_ = true;
                                                                    }
                                                                    let _e815 = phi_1398_;
                                                                    phi_1399_ = _e815;
                                                                } else {
                                                                    phi_1399_ = true;
                                                                }
                                                                let _e817 = phi_1399_;
                                                                if _e817 {
                                                                    phi_1405_ = (_e730[0] - 1u);
                                                                    phi_1406_ = false;
                                                                } else {
                                                                    phi_1405_ = u32();
                                                                    phi_1406_ = true;
                                                                }
                                                                let _e821 = phi_1405_;
                                                                let _e823 = phi_1406_;
                                                                phi_1407_ = _e821;
                                                                phi_1408_ = _e823;
                                                            } else {
                                                                phi_1407_ = u32();
                                                                phi_1408_ = true;
                                                            }
                                                            let _e825 = phi_1407_;
                                                            let _e827 = phi_1408_;
                                                            if _e827 {
                                                                phi_1413_ = _e730[0];
                                                            } else {
                                                                phi_1413_ = _e825;
                                                            }
                                                            let _e830 = phi_1413_;
                                                            if ((_e730[0] + 1u) < 512u) {
                                                                phi_1423_ = (_e730[0] + 1u);
                                                            } else {
                                                                phi_1423_ = _e730[0];
                                                            }
                                                            let _e838 = phi_1423_;
                                                            phi_1437_ = array<u32, 2>(((((_e806 - 1u) << bitcast<u32>(18u)) | ((_e803 - 1u) << bitcast<u32>(9u))) | _e830), ((((_e806 - 1u) << bitcast<u32>(18u)) | ((_e803 - 1u) << bitcast<u32>(9u))) | _e838));
                                                        }
                                                        let _e857 = phi_1437_;
                                                        phi_1438_ = _e857;
                                                        phi_1439_ = _e810;
                                                    }
                                                    let _e859 = phi_1438_;
                                                    let _e861 = phi_1439_;
                                                    phi_1440_ = _e859;
                                                    phi_1441_ = _e861;
                                                }
                                                let _e863 = phi_1440_;
                                                let _e865 = phi_1441_;
                                                phi_1442_ = _e863;
                                                phi_1443_ = _e865;
                                            }
                                            let _e867 = phi_1442_;
                                            let _e869 = phi_1443_;
                                            if _e869 {
                                                phi_1448_ = array<u32, 2>(1u, 0u);
                                            } else {
                                                phi_1448_ = _e867;
                                            }
                                            let _e871 = phi_1448_;
                                            phi_1449_ = _e871;
                                        }
                                        let _e873 = phi_1449_;
                                        phi_1457_ = array<u32, 2>(((_e303 << bitcast<u32>(27u)) | _e873[0]), ((_e303 << bitcast<u32>(27u)) | _e873[1]));
                                        phi_1458_ = false;
                                    } else {
                                        phi_1457_ = array<u32, 2>();
                                        phi_1458_ = true;
                                    }
                                    let _e884 = phi_1457_;
                                    let _e886 = phi_1458_;
                                    phi_1459_ = _e884;
                                    phi_1460_ = _e886;
                                }
                                let _e888 = phi_1459_;
                                let _e890 = phi_1460_;
                                if _e890 {
                                    phi_1465_ = array<u32, 2>(1u, 0u);
                                } else {
                                    phi_1465_ = _e888;
                                }
                                let _e892 = phi_1465_;
                                phi_1472_ = array<u32, 2>((_e783 | _e892[0]), (_e783 | _e892[1]));
                            } else {
                                phi_1472_ = array<u32, 2>(_e783, _e783);
                            }
                            let _e899 = phi_1472_;
                            phi_1473_ = _e899;
                        }
                        let _e935 = phi_1473_;
                        if (_e935[0] <= _e935[1]) {
                            let _e940 = atomicMin((&ranges[_e753]), _e935[0]);
                            let _e943 = atomicMax((&ranges[(128u + _e753)]), _e935[1]);
                        }
                    }
                    continue;
                    continuing {
                        phi_1183_ = _e745;
                        break if !(_e751);
                    }
                }
            }
            continue;
            continuing {
                phi_398_ = _e270;
                break if !(_e276);
            }
        }
    }
    workgroupBarrier();
    let _e947 = atomicLoad((&ranges[_e87]));
    let _e950 = atomicLoad((&ranges[(128u + _e87)]));
    if (_e947 <= _e950) {
        phi_1498_ = type_14(0i, 32i);
        phi_1501_ = 0u;
        phi_1503_ = _e110;
        loop {
            let _e953 = phi_1498_;
            let _e955 = phi_1501_;
            let _e957 = phi_1503_;
            local_17 = _e955;
            local_20 = _e955;
            local_21 = _e955;
            if (_e953.member < _e953.member_1) {
                let _e964 = (_e953.member + 1i);
                if ((false == (_e964 > _e953.member)) != false) {
                    phi_1524_ = true;
                } else {
                    phi_1524_ = false;
                }
                let _e969 = phi_1524_;
                if _e969 {
                    phi_1530_ = type_15(0u, type_15().member_1);
                } else {
                    phi_1530_ = type_15(1u, _e964);
                }
                let _e974 = phi_1530_;
                phi_1499_ = type_14(_e974.member_1, _e953.member_1);
                phi_1544_ = type_15(1u, _e953.member);
            } else {
                phi_1499_ = _e953;
                phi_1544_ = type_15(0u, type_15().member_1);
            }
            let _e980 = phi_1499_;
            let _e982 = phi_1544_;
            if (bitcast<i32>(_e982.member) != 0i) {
                if (_e955 >= _e957) {
                    phi_1575_ = u32();
                    phi_1576_ = u32();
                    phi_1577_ = false;
                } else {
                    let _e989 = (_e955 + ((_e957 - _e955) / 2u));
                    let _e991 = keys.member[_e989];
                    if (_e991 < _e947) {
                        phi_1573_ = (_e989 + 1u);
                        phi_1574_ = _e957;
                    } else {
                        phi_1573_ = _e955;
                        phi_1574_ = _e989;
                    }
                    let _e995 = phi_1573_;
                    let _e997 = phi_1574_;
                    phi_1575_ = _e995;
                    phi_1576_ = _e997;
                    phi_1577_ = true;
                }
                let _e999 = phi_1575_;
                let _e1001 = phi_1576_;
                let _e1003 = phi_1577_;
                phi_1502_ = _e999;
                phi_1504_ = _e1001;
                phi_1578_ = _e1003;
            } else {
                phi_1502_ = u32();
                phi_1504_ = u32();
                phi_1578_ = false;
            }
            let _e1005 = phi_1502_;
            let _e1007 = phi_1504_;
            let _e1009 = phi_1578_;
            continue;
            continuing {
                phi_1498_ = _e980;
                phi_1501_ = _e1005;
                phi_1503_ = _e1007;
                break if !(_e1009);
            }
        }
        if (_e103 == 1u) {
            let _e1015 = params.member.member.member_2[1u];
            let _e1018 = ((_e1015 + (_e97 * 128u)) + 1u);
            let _e1020 = local_17;
            if (_e1018 < _e1020) {
                let _e1371 = local_20;
                phi_1593_ = _e1371;
            } else {
                phi_1593_ = _e1018;
            }
            let _e1023 = phi_1593_;
            phi_1594_ = _e1023;
        } else {
            let _e1374 = local_21;
            phi_1594_ = _e1374;
        }
        let _e1025 = phi_1594_;
        phi_1598_ = type_14(0i, 32i);
        phi_1601_ = 0u;
        phi_1603_ = _e110;
        loop {
            let _e1028 = phi_1598_;
            let _e1030 = phi_1601_;
            let _e1032 = phi_1603_;
            local_18 = _e1030;
            local_19 = _e1030;
            local_22 = _e1030;
            if (_e1028.member < _e1028.member_1) {
                let _e1039 = (_e1028.member + 1i);
                if ((false == (_e1039 > _e1028.member)) != false) {
                    phi_1624_ = true;
                } else {
                    phi_1624_ = false;
                }
                let _e1044 = phi_1624_;
                if _e1044 {
                    phi_1630_ = type_15(0u, type_15().member_1);
                } else {
                    phi_1630_ = type_15(1u, _e1039);
                }
                let _e1049 = phi_1630_;
                phi_1599_ = type_14(_e1049.member_1, _e1028.member_1);
                phi_1644_ = type_15(1u, _e1028.member);
            } else {
                phi_1599_ = _e1028;
                phi_1644_ = type_15(0u, type_15().member_1);
            }
            let _e1055 = phi_1599_;
            let _e1057 = phi_1644_;
            if (bitcast<i32>(_e1057.member) != 0i) {
                if (_e1030 >= _e1032) {
                    phi_1675_ = u32();
                    phi_1676_ = u32();
                    phi_1677_ = false;
                } else {
                    let _e1064 = (_e1030 + ((_e1032 - _e1030) / 2u));
                    let _e1066 = keys.member[_e1064];
                    if (_e1066 < (_e950 + 1u)) {
                        phi_1673_ = (_e1064 + 1u);
                        phi_1674_ = _e1032;
                    } else {
                        phi_1673_ = _e1030;
                        phi_1674_ = _e1064;
                    }
                    let _e1070 = phi_1673_;
                    let _e1072 = phi_1674_;
                    phi_1675_ = _e1070;
                    phi_1676_ = _e1072;
                    phi_1677_ = true;
                }
                let _e1074 = phi_1675_;
                let _e1076 = phi_1676_;
                let _e1078 = phi_1677_;
                phi_1602_ = _e1074;
                phi_1604_ = _e1076;
                phi_1678_ = _e1078;
            } else {
                phi_1602_ = u32();
                phi_1604_ = u32();
                phi_1678_ = false;
            }
            let _e1080 = phi_1602_;
            let _e1082 = phi_1604_;
            let _e1084 = phi_1678_;
            continue;
            continuing {
                phi_1598_ = _e1055;
                phi_1601_ = _e1080;
                phi_1603_ = _e1082;
                break if !(_e1084);
            }
        }
        let _e1087 = local_18;
        if (_e1025 < _e1087) {
            let _e1090 = local_19;
            let _e1091 = (_e1090 - _e1025);
            let _e1092 = (_e1091 / 1024u);
            if ((_e1091 % 1024u) > 0u) {
                phi_1699_ = (_e1092 + 1u);
            } else {
                phi_1699_ = _e1092;
            }
            let _e1097 = phi_1699_;
            let _e1099 = atomicAdd((&work.member[0u]), _e1097);
            if ((_e1099 + _e1097) < _e1099) {
                let _e1103 = atomicAdd((&work.member[2u]), 1u);
            }
            phi_1712_ = _e1099;
        } else {
            phi_1712_ = 0u;
        }
        let _e1105 = phi_1712_;
        phi_1713_ = _e1105;
        let _e1397 = local_22;
        phi_1714_ = _e1397;
        phi_1715_ = _e1025;
    } else {
        phi_1713_ = 0u;
        phi_1714_ = 0u;
        phi_1715_ = 0u;
    }
    let _e1107 = phi_1713_;
    let _e1109 = phi_1714_;
    let _e1111 = phi_1715_;
    atomicStore((&ranges[(256u + _e87)]), _e1111);
    atomicStore((&ranges[(384u + _e87)]), _e1109);
    atomicStore((&ranges[(512u + _e87)]), _e1107);
    workgroupBarrier();
    if (_e100 == 2u) {
        phi_1726_ = 8u;
    } else {
        phi_1726_ = 1u;
    }
    let _e1120 = phi_1726_;
    phi_1730_ = type_9(0u, (_e1120 * _e113));
    loop {
        let _e1124 = phi_1730_;
        if (_e1124.member < _e1124.member_1) {
            phi_1731_ = type_9((_e1124.member + 1u), _e1124.member_1);
            phi_1754_ = type_9(1u, _e1124.member);
        } else {
            phi_1731_ = _e1124;
            phi_1754_ = type_9(0u, type_9().member_1);
        }
        let _e1136 = phi_1731_;
        let _e1138 = phi_1754_;
        let _e1142 = (bitcast<i32>(_e1138.member) != 0i);
        if _e1142 {
            let _e1145 = atomicLoad((&ranges[(256u + _e1138.member_1)]));
            let _e1148 = atomicLoad((&ranges[(384u + _e1138.member_1)]));
            if (_e1145 < _e1148) {
                let _e1150 = (_e1148 - _e1145);
                let _e1151 = (_e1150 / 1024u);
                if ((_e1150 % 1024u) > 0u) {
                    phi_1788_ = (_e1151 + 1u);
                } else {
                    phi_1788_ = _e1151;
                }
                let _e1156 = phi_1788_;
                phi_1789_ = _e1156;
            } else {
                phi_1789_ = 0u;
            }
            let _e1158 = phi_1789_;
            let _e1159 = (_e1158 / 128u);
            if ((_e1158 % 128u) > 0u) {
                phi_1805_ = (_e1159 + 1u);
            } else {
                phi_1805_ = _e1159;
            }
            let _e1164 = phi_1805_;
            phi_1808_ = type_9(0u, _e1164);
            loop {
                let _e1167 = phi_1808_;
                if (_e1167.member < _e1167.member_1) {
                    phi_1809_ = type_9((_e1167.member + 1u), _e1167.member_1);
                    phi_1832_ = type_9(1u, _e1167.member);
                } else {
                    phi_1809_ = _e1167;
                    phi_1832_ = type_9(0u, type_9().member_1);
                }
                let _e1179 = phi_1809_;
                let _e1181 = phi_1832_;
                let _e1185 = (bitcast<i32>(_e1181.member) != 0i);
                if _e1185 {
                    let _e1187 = ((_e1181.member_1 * 128u) + _e87);
                    if (_e1187 < _e1158) {
                        let _e1190 = (_e1145 + (_e1187 * 1024u));
                        let _e1191 = (_e1148 - _e1190);
                        if (1024u < _e1191) {
                            phi_1853_ = 1024u;
                        } else {
                            phi_1853_ = _e1191;
                        }
                        let _e1194 = phi_1853_;
                        let _e1195 = (_e1194 / 128u);
                        if ((_e1194 % 128u) > 0u) {
                            phi_1869_ = (_e1195 + 1u);
                        } else {
                            phi_1869_ = _e1195;
                        }
                        let _e1200 = phi_1869_;
                        let _e1211 = atomicLoad((&ranges[(512u + _e1138.member_1)]));
                        let _e1212 = (_e1211 + _e1187);
                        let _e1215 = params.member.member_1.member_3;
                        if (_e1212 < _e1215) {
                            let _e1217 = (2u * _e1212);
                            atomicStore((&work.member[(4u + _e1217)]), (((_e106 + _e1138.member_1) << bitcast<u32>(24i)) | _e97));
                            atomicStore((&work.member[(_e1217 + 5u)]), (((_e1200 - 1u) << bitcast<u32>(29i)) | _e1190));
                        }
                    }
                }
                continue;
                continuing {
                    phi_1808_ = _e1179;
                    break if !(_e1185);
                }
            }
        }
        continue;
        continuing {
            phi_1730_ = _e1136;
            break if !(_e1142);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
