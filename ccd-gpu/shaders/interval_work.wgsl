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
    var phi_1155_: u32;
    var phi_1156_: u32;
    var phi_1168_: array<u32, 3>;
    var phi_1169_: array<u32, 3>;
    var phi_1170_: array<u32, 3>;
    var phi_1173_: type_9;
    var phi_1174_: type_9;
    var phi_1197_: type_9;
    var phi_1222_: array<u32, 2>;
    var phi_1229_: u32;
    var phi_1234_: u32;
    var phi_1242_: array<u32, 2>;
    var phi_1332_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1395_: u32;
    var phi_1396_: bool;
    var phi_1397_: u32;
    var phi_1398_: bool;
    var phi_1403_: u32;
    var phi_1413_: u32;
    var phi_1427_: array<u32, 2>;
    var phi_1428_: array<u32, 2>;
    var phi_1429_: bool;
    var phi_1430_: array<u32, 2>;
    var phi_1431_: bool;
    var phi_1432_: array<u32, 2>;
    var phi_1433_: bool;
    var phi_1438_: array<u32, 2>;
    var phi_1439_: array<u32, 2>;
    var phi_1447_: array<u32, 2>;
    var phi_1448_: bool;
    var phi_1449_: array<u32, 2>;
    var phi_1450_: bool;
    var phi_1455_: array<u32, 2>;
    var phi_1462_: array<u32, 2>;
    var phi_1299_: f32;
    var phi_1300_: f32;
    var phi_1306_: u32;
    var phi_1316_: u32;
    var phi_1463_: array<u32, 2>;
    var phi_1488_: type_14;
    var phi_1491_: u32;
    var phi_1493_: u32;
    var phi_1514_: bool;
    var phi_1520_: type_15;
    var phi_1489_: type_14;
    var phi_1534_: type_15;
    var phi_1563_: u32;
    var phi_1564_: u32;
    var phi_1565_: u32;
    var phi_1566_: u32;
    var phi_1567_: bool;
    var phi_1492_: u32;
    var phi_1494_: u32;
    var phi_1568_: bool;
    var local_17: u32;
    var phi_1583_: u32;
    var phi_1584_: u32;
    var phi_1588_: type_14;
    var phi_1591_: u32;
    var phi_1593_: u32;
    var phi_1614_: bool;
    var phi_1620_: type_15;
    var phi_1589_: type_14;
    var phi_1634_: type_15;
    var phi_1663_: u32;
    var phi_1664_: u32;
    var phi_1665_: u32;
    var phi_1666_: u32;
    var phi_1667_: bool;
    var phi_1592_: u32;
    var phi_1594_: u32;
    var phi_1668_: bool;
    var local_18: u32;
    var local_19: u32;
    var phi_1689_: u32;
    var phi_1702_: u32;
    var phi_1703_: u32;
    var phi_1704_: u32;
    var phi_1705_: u32;
    var phi_1716_: u32;
    var phi_1720_: type_9;
    var phi_1721_: type_9;
    var phi_1744_: type_9;
    var phi_1778_: u32;
    var phi_1779_: u32;
    var phi_1795_: u32;
    var phi_1798_: type_9;
    var phi_1799_: type_9;
    var phi_1822_: type_9;
    var phi_1843_: u32;
    var phi_1859_: u32;
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
                            let _e711 = (_e239 & 134217727u);
                            phi_1168_ = array<u32, 3>((_e711 & 511u), ((_e711 >> bitcast<u32>(9u)) & 511u), (_e711 >> bitcast<u32>(18u)));
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
                                    let _e685 = local_7.member_1[_e670.member_1];
                                    let _e691 = local_4.member_1[_e670.member_1];
                                    let _e692 = ((((_e680 * 0.25f) - _e677) + ((_e685 * 0.25f) - _e677)) * _e691);
                                    if (_e692 >= 511f) {
                                        phi_1156_ = 511u;
                                    } else {
                                        if (_e692 > 0f) {
                                            phi_1155_ = select(select(u32(_e692), 0u, (_e692 < 0f)), 4294967295u, (_e692 > 4294967000f));
                                        } else {
                                            phi_1155_ = 0u;
                                        }
                                        let _e701 = phi_1155_;
                                        phi_1156_ = _e701;
                                    }
                                    let _e703 = phi_1156_;
                                    local[_e670.member_1] = _e703;
                                }
                                continue;
                                continuing {
                                    phi_1071_ = _e668;
                                    break if !(_e674);
                                }
                            }
                            let _e706 = local;
                            phi_1168_ = array<u32, 3>(_e706[0], _e706[1], _e706[2]);
                        }
                        let _e720 = phi_1168_;
                        phi_1169_ = _e720;
                    } else {
                        phi_1169_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e722 = phi_1169_;
                    phi_1170_ = _e722;
                } else {
                    phi_1170_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e724 = phi_1170_;
                phi_1173_ = type_9(_e325[0], _e325[1]);
                loop {
                    let _e727 = phi_1173_;
                    if (_e727.member < _e727.member_1) {
                        phi_1174_ = type_9((_e727.member + 1u), _e727.member_1);
                        phi_1197_ = type_9(1u, _e727.member);
                    } else {
                        phi_1174_ = _e727;
                        phi_1197_ = type_9(0u, type_9().member_1);
                    }
                    let _e739 = phi_1174_;
                    let _e741 = phi_1197_;
                    let _e745 = (bitcast<i32>(_e741.member) != 0i);
                    if _e745 {
                        let _e747 = ((_e272.member_1 * _e113) + _e741.member_1);
                        let _e748 = (_e106 + _e747);
                        let _e751 = params.member.member_2.member;
                        let _e754 = params.member.member_2.member_1;
                        if (_e754 == 0u) {
                            phi_1222_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_1222_ = array<u32, 2>(1u, 1u);
                        }
                        let _e757 = phi_1222_;
                        if (_e751 == 2u) {
                            phi_1229_ = 8u;
                        } else {
                            phi_1229_ = 1u;
                        }
                        let _e762 = phi_1229_;
                        if (_e751 == 2u) {
                            phi_1234_ = 10u;
                        } else {
                            phi_1234_ = 1u;
                        }
                        let _e765 = phi_1234_;
                        if (_e748 >= (_e762 * _e765)) {
                            phi_1242_ = array<u32, 2>(_e757[1], _e757[0]);
                        } else {
                            phi_1242_ = _e757;
                        }
                        let _e770 = phi_1242_;
                        let _e773 = keys.member[_e232];
                        let _e775 = sorted.member[_e232];
                        let _e777 = (_e770[1] << bitcast<u32>(30u));
                        if (_e751 == 1u) {
                            let _e898 = survey.member[6u];
                            if (_e898 == 0u) {
                                phi_1300_ = _e775.member_1[0];
                            } else {
                                if (_e898 == 1u) {
                                    phi_1299_ = _e775.member_1[1];
                                } else {
                                    phi_1299_ = _e775.member_1[2];
                                }
                                let _e906 = phi_1299_;
                                phi_1300_ = _e906;
                            }
                            let _e910 = phi_1300_;
                            let _e911 = bitcast<u32>(_e910);
                            if (_e911 == 2147483648u) {
                                phi_1306_ = 0u;
                            } else {
                                phi_1306_ = _e911;
                            }
                            let _e914 = phi_1306_;
                            let _e916 = bitcast<u32>(bitcast<f32>(_e914));
                            if ((_e916 >> bitcast<u32>(31i)) == 1u) {
                                phi_1316_ = ~(_e916);
                            } else {
                                phi_1316_ = (_e916 | 2147483648u);
                            }
                            let _e923 = phi_1316_;
                            phi_1463_ = array<u32, 2>(((_e777 | (_e773 & 1073741823u)) + _e748), (_e777 | (_e923 >> bitcast<u32>(2i))));
                        } else {
                            if (_e751 == 2u) {
                                let _e781 = (_e748 % 80u);
                                let _e783 = (_e781 % 10u);
                                if (_e754 == 1u) {
                                    phi_1332_ = ((_e781 / 10u) == 0u);
                                } else {
                                    phi_1332_ = false;
                                }
                                let _e787 = phi_1332_;
                                if (_e303 >= 8u) {
                                    phi_1449_ = array<u32, 2>();
                                    phi_1450_ = true;
                                } else {
                                    if _e787 {
                                        if (_e783 < 4u) {
                                            phi_1344_ = false;
                                        } else {
                                            phi_1344_ = true;
                                        }
                                        let _e791 = phi_1344_;
                                        phi_1345_ = _e791;
                                    } else {
                                        phi_1345_ = true;
                                    }
                                    let _e793 = phi_1345_;
                                    if _e793 {
                                        if (_e783 == 9u) {
                                            phi_1439_ = array<u32, 2>(0u, 134217727u);
                                        } else {
                                            let _e797 = (_e724[1] + (_e783 % 3u));
                                            let _e800 = (_e724[2] + (_e783 / 3u));
                                            if (_e797 < 1u) {
                                                phi_1432_ = array<u32, 2>();
                                                phi_1433_ = true;
                                            } else {
                                                if (_e800 < 1u) {
                                                    phi_1430_ = array<u32, 2>();
                                                    phi_1431_ = true;
                                                } else {
                                                    if (_e797 > 512u) {
                                                        phi_1428_ = array<u32, 2>();
                                                        phi_1429_ = true;
                                                    } else {
                                                        let _e804 = (_e800 > 512u);
                                                        if _e804 {
                                                            phi_1427_ = array<u32, 2>();
                                                        } else {
                                                            if (_e724[0] > 0u) {
                                                                if _e787 {
                                                                    if (_e783 == 4u) {
                                                                        phi_1388_ = false;
                                                                    } else {
                                                                        phi_1388_ = true;
                                                                    }
                                                                    let _e809 = phi_1388_;
                                                                    phi_1389_ = _e809;
                                                                } else {
                                                                    phi_1389_ = true;
                                                                }
                                                                let _e811 = phi_1389_;
                                                                if _e811 {
                                                                    phi_1395_ = (_e724[0] - 1u);
                                                                    phi_1396_ = false;
                                                                } else {
                                                                    phi_1395_ = u32();
                                                                    phi_1396_ = true;
                                                                }
                                                                let _e815 = phi_1395_;
                                                                let _e817 = phi_1396_;
                                                                phi_1397_ = _e815;
                                                                phi_1398_ = _e817;
                                                            } else {
                                                                phi_1397_ = u32();
                                                                phi_1398_ = true;
                                                            }
                                                            let _e819 = phi_1397_;
                                                            let _e821 = phi_1398_;
                                                            if _e821 {
                                                                phi_1403_ = _e724[0];
                                                            } else {
                                                                phi_1403_ = _e819;
                                                            }
                                                            let _e824 = phi_1403_;
                                                            if ((_e724[0] + 1u) < 512u) {
                                                                phi_1413_ = (_e724[0] + 1u);
                                                            } else {
                                                                phi_1413_ = _e724[0];
                                                            }
                                                            let _e832 = phi_1413_;
                                                            phi_1427_ = array<u32, 2>(((((_e800 - 1u) << bitcast<u32>(18u)) | ((_e797 - 1u) << bitcast<u32>(9u))) | _e824), ((((_e800 - 1u) << bitcast<u32>(18u)) | ((_e797 - 1u) << bitcast<u32>(9u))) | _e832));
                                                        }
                                                        let _e851 = phi_1427_;
                                                        phi_1428_ = _e851;
                                                        phi_1429_ = _e804;
                                                    }
                                                    let _e853 = phi_1428_;
                                                    let _e855 = phi_1429_;
                                                    phi_1430_ = _e853;
                                                    phi_1431_ = _e855;
                                                }
                                                let _e857 = phi_1430_;
                                                let _e859 = phi_1431_;
                                                phi_1432_ = _e857;
                                                phi_1433_ = _e859;
                                            }
                                            let _e861 = phi_1432_;
                                            let _e863 = phi_1433_;
                                            if _e863 {
                                                phi_1438_ = array<u32, 2>(1u, 0u);
                                            } else {
                                                phi_1438_ = _e861;
                                            }
                                            let _e865 = phi_1438_;
                                            phi_1439_ = _e865;
                                        }
                                        let _e867 = phi_1439_;
                                        phi_1447_ = array<u32, 2>(((_e303 << bitcast<u32>(27u)) | _e867[0]), ((_e303 << bitcast<u32>(27u)) | _e867[1]));
                                        phi_1448_ = false;
                                    } else {
                                        phi_1447_ = array<u32, 2>();
                                        phi_1448_ = true;
                                    }
                                    let _e878 = phi_1447_;
                                    let _e880 = phi_1448_;
                                    phi_1449_ = _e878;
                                    phi_1450_ = _e880;
                                }
                                let _e882 = phi_1449_;
                                let _e884 = phi_1450_;
                                if _e884 {
                                    phi_1455_ = array<u32, 2>(1u, 0u);
                                } else {
                                    phi_1455_ = _e882;
                                }
                                let _e886 = phi_1455_;
                                phi_1462_ = array<u32, 2>((_e777 | _e886[0]), (_e777 | _e886[1]));
                            } else {
                                phi_1462_ = array<u32, 2>(_e777, _e777);
                            }
                            let _e893 = phi_1462_;
                            phi_1463_ = _e893;
                        }
                        let _e929 = phi_1463_;
                        if (_e929[0] <= _e929[1]) {
                            let _e934 = atomicMin((&ranges[_e747]), _e929[0]);
                            let _e937 = atomicMax((&ranges[(128u + _e747)]), _e929[1]);
                        }
                    }
                    continue;
                    continuing {
                        phi_1173_ = _e739;
                        break if !(_e745);
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
    let _e941 = atomicLoad((&ranges[_e87]));
    let _e944 = atomicLoad((&ranges[(128u + _e87)]));
    if (_e941 <= _e944) {
        phi_1488_ = type_14(0i, 32i);
        phi_1491_ = 0u;
        phi_1493_ = _e110;
        loop {
            let _e947 = phi_1488_;
            let _e949 = phi_1491_;
            let _e951 = phi_1493_;
            local_17 = _e949;
            local_20 = _e949;
            local_21 = _e949;
            if (_e947.member < _e947.member_1) {
                let _e958 = (_e947.member + 1i);
                if ((false == (_e958 > _e947.member)) != false) {
                    phi_1514_ = true;
                } else {
                    phi_1514_ = false;
                }
                let _e963 = phi_1514_;
                if _e963 {
                    phi_1520_ = type_15(0u, type_15().member_1);
                } else {
                    phi_1520_ = type_15(1u, _e958);
                }
                let _e968 = phi_1520_;
                phi_1489_ = type_14(_e968.member_1, _e947.member_1);
                phi_1534_ = type_15(1u, _e947.member);
            } else {
                phi_1489_ = _e947;
                phi_1534_ = type_15(0u, type_15().member_1);
            }
            let _e974 = phi_1489_;
            let _e976 = phi_1534_;
            if (bitcast<i32>(_e976.member) != 0i) {
                if (_e949 >= _e951) {
                    phi_1565_ = u32();
                    phi_1566_ = u32();
                    phi_1567_ = false;
                } else {
                    let _e983 = (_e949 + ((_e951 - _e949) / 2u));
                    let _e985 = keys.member[_e983];
                    if (_e985 < _e941) {
                        phi_1563_ = (_e983 + 1u);
                        phi_1564_ = _e951;
                    } else {
                        phi_1563_ = _e949;
                        phi_1564_ = _e983;
                    }
                    let _e989 = phi_1563_;
                    let _e991 = phi_1564_;
                    phi_1565_ = _e989;
                    phi_1566_ = _e991;
                    phi_1567_ = true;
                }
                let _e993 = phi_1565_;
                let _e995 = phi_1566_;
                let _e997 = phi_1567_;
                phi_1492_ = _e993;
                phi_1494_ = _e995;
                phi_1568_ = _e997;
            } else {
                phi_1492_ = u32();
                phi_1494_ = u32();
                phi_1568_ = false;
            }
            let _e999 = phi_1492_;
            let _e1001 = phi_1494_;
            let _e1003 = phi_1568_;
            continue;
            continuing {
                phi_1488_ = _e974;
                phi_1491_ = _e999;
                phi_1493_ = _e1001;
                break if !(_e1003);
            }
        }
        if (_e103 == 1u) {
            let _e1009 = params.member.member.member_2[1u];
            let _e1012 = ((_e1009 + (_e97 * 128u)) + 1u);
            let _e1014 = local_17;
            if (_e1012 < _e1014) {
                let _e1363 = local_20;
                phi_1583_ = _e1363;
            } else {
                phi_1583_ = _e1012;
            }
            let _e1017 = phi_1583_;
            phi_1584_ = _e1017;
        } else {
            let _e1366 = local_21;
            phi_1584_ = _e1366;
        }
        let _e1019 = phi_1584_;
        phi_1588_ = type_14(0i, 32i);
        phi_1591_ = 0u;
        phi_1593_ = _e110;
        loop {
            let _e1022 = phi_1588_;
            let _e1024 = phi_1591_;
            let _e1026 = phi_1593_;
            local_18 = _e1024;
            local_19 = _e1024;
            local_22 = _e1024;
            if (_e1022.member < _e1022.member_1) {
                let _e1033 = (_e1022.member + 1i);
                if ((false == (_e1033 > _e1022.member)) != false) {
                    phi_1614_ = true;
                } else {
                    phi_1614_ = false;
                }
                let _e1038 = phi_1614_;
                if _e1038 {
                    phi_1620_ = type_15(0u, type_15().member_1);
                } else {
                    phi_1620_ = type_15(1u, _e1033);
                }
                let _e1043 = phi_1620_;
                phi_1589_ = type_14(_e1043.member_1, _e1022.member_1);
                phi_1634_ = type_15(1u, _e1022.member);
            } else {
                phi_1589_ = _e1022;
                phi_1634_ = type_15(0u, type_15().member_1);
            }
            let _e1049 = phi_1589_;
            let _e1051 = phi_1634_;
            if (bitcast<i32>(_e1051.member) != 0i) {
                if (_e1024 >= _e1026) {
                    phi_1665_ = u32();
                    phi_1666_ = u32();
                    phi_1667_ = false;
                } else {
                    let _e1058 = (_e1024 + ((_e1026 - _e1024) / 2u));
                    let _e1060 = keys.member[_e1058];
                    if (_e1060 < (_e944 + 1u)) {
                        phi_1663_ = (_e1058 + 1u);
                        phi_1664_ = _e1026;
                    } else {
                        phi_1663_ = _e1024;
                        phi_1664_ = _e1058;
                    }
                    let _e1064 = phi_1663_;
                    let _e1066 = phi_1664_;
                    phi_1665_ = _e1064;
                    phi_1666_ = _e1066;
                    phi_1667_ = true;
                }
                let _e1068 = phi_1665_;
                let _e1070 = phi_1666_;
                let _e1072 = phi_1667_;
                phi_1592_ = _e1068;
                phi_1594_ = _e1070;
                phi_1668_ = _e1072;
            } else {
                phi_1592_ = u32();
                phi_1594_ = u32();
                phi_1668_ = false;
            }
            let _e1074 = phi_1592_;
            let _e1076 = phi_1594_;
            let _e1078 = phi_1668_;
            continue;
            continuing {
                phi_1588_ = _e1049;
                phi_1591_ = _e1074;
                phi_1593_ = _e1076;
                break if !(_e1078);
            }
        }
        let _e1081 = local_18;
        if (_e1019 < _e1081) {
            let _e1084 = local_19;
            let _e1085 = (_e1084 - _e1019);
            let _e1086 = (_e1085 / 1024u);
            if ((_e1085 % 1024u) > 0u) {
                phi_1689_ = (_e1086 + 1u);
            } else {
                phi_1689_ = _e1086;
            }
            let _e1091 = phi_1689_;
            let _e1093 = atomicAdd((&work.member[0u]), _e1091);
            if ((_e1093 + _e1091) < _e1093) {
                let _e1097 = atomicAdd((&work.member[2u]), 1u);
            }
            phi_1702_ = _e1093;
        } else {
            phi_1702_ = 0u;
        }
        let _e1099 = phi_1702_;
        phi_1703_ = _e1099;
        let _e1389 = local_22;
        phi_1704_ = _e1389;
        phi_1705_ = _e1019;
    } else {
        phi_1703_ = 0u;
        phi_1704_ = 0u;
        phi_1705_ = 0u;
    }
    let _e1101 = phi_1703_;
    let _e1103 = phi_1704_;
    let _e1105 = phi_1705_;
    atomicStore((&ranges[(256u + _e87)]), _e1105);
    atomicStore((&ranges[(384u + _e87)]), _e1103);
    atomicStore((&ranges[(512u + _e87)]), _e1101);
    workgroupBarrier();
    if (_e100 == 2u) {
        phi_1716_ = 8u;
    } else {
        phi_1716_ = 1u;
    }
    let _e1114 = phi_1716_;
    phi_1720_ = type_9(0u, (_e1114 * _e113));
    loop {
        let _e1118 = phi_1720_;
        if (_e1118.member < _e1118.member_1) {
            phi_1721_ = type_9((_e1118.member + 1u), _e1118.member_1);
            phi_1744_ = type_9(1u, _e1118.member);
        } else {
            phi_1721_ = _e1118;
            phi_1744_ = type_9(0u, type_9().member_1);
        }
        let _e1130 = phi_1721_;
        let _e1132 = phi_1744_;
        let _e1136 = (bitcast<i32>(_e1132.member) != 0i);
        if _e1136 {
            let _e1139 = atomicLoad((&ranges[(256u + _e1132.member_1)]));
            let _e1142 = atomicLoad((&ranges[(384u + _e1132.member_1)]));
            if (_e1139 < _e1142) {
                let _e1144 = (_e1142 - _e1139);
                let _e1145 = (_e1144 / 1024u);
                if ((_e1144 % 1024u) > 0u) {
                    phi_1778_ = (_e1145 + 1u);
                } else {
                    phi_1778_ = _e1145;
                }
                let _e1150 = phi_1778_;
                phi_1779_ = _e1150;
            } else {
                phi_1779_ = 0u;
            }
            let _e1152 = phi_1779_;
            let _e1153 = (_e1152 / 128u);
            if ((_e1152 % 128u) > 0u) {
                phi_1795_ = (_e1153 + 1u);
            } else {
                phi_1795_ = _e1153;
            }
            let _e1158 = phi_1795_;
            phi_1798_ = type_9(0u, _e1158);
            loop {
                let _e1161 = phi_1798_;
                if (_e1161.member < _e1161.member_1) {
                    phi_1799_ = type_9((_e1161.member + 1u), _e1161.member_1);
                    phi_1822_ = type_9(1u, _e1161.member);
                } else {
                    phi_1799_ = _e1161;
                    phi_1822_ = type_9(0u, type_9().member_1);
                }
                let _e1173 = phi_1799_;
                let _e1175 = phi_1822_;
                let _e1179 = (bitcast<i32>(_e1175.member) != 0i);
                if _e1179 {
                    let _e1181 = ((_e1175.member_1 * 128u) + _e87);
                    if (_e1181 < _e1152) {
                        let _e1184 = (_e1139 + (_e1181 * 1024u));
                        let _e1185 = (_e1142 - _e1184);
                        if (1024u < _e1185) {
                            phi_1843_ = 1024u;
                        } else {
                            phi_1843_ = _e1185;
                        }
                        let _e1188 = phi_1843_;
                        let _e1189 = (_e1188 / 128u);
                        if ((_e1188 % 128u) > 0u) {
                            phi_1859_ = (_e1189 + 1u);
                        } else {
                            phi_1859_ = _e1189;
                        }
                        let _e1194 = phi_1859_;
                        let _e1205 = atomicLoad((&ranges[(512u + _e1132.member_1)]));
                        let _e1206 = (_e1205 + _e1181);
                        let _e1209 = params.member.member_1.member_3;
                        if (_e1206 < _e1209) {
                            let _e1211 = (2u * _e1206);
                            atomicStore((&work.member[(4u + _e1211)]), (((_e106 + _e1132.member_1) << bitcast<u32>(24i)) | _e97));
                            atomicStore((&work.member[(_e1211 + 5u)]), (((_e1194 - 1u) << bitcast<u32>(29i)) | _e1184));
                        }
                    }
                }
                continue;
                continuing {
                    phi_1798_ = _e1173;
                    break if !(_e1179);
                }
            }
        }
        continue;
        continuing {
            phi_1720_ = _e1130;
            break if !(_e1136);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
