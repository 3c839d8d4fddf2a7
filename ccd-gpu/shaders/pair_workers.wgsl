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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_24 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> a_nodes: type_18;
@group(0) @binding(2) 
var<storage> b_nodes: type_18;
@group(0) @binding(6) 
var<storage, read_write> front: type_10;
@group(0) @binding(3) 
var<storage, read_write> control: type_27;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_27;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_27;
var<workgroup> shared_: array<atomic<u32>, 18>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_145_: u32;
    var phi_158_: array<u32, 2>;
    var phi_182_: u32;
    var phi_194_: type_12;
    var phi_195_: type_12;
    var phi_218_: type_12;
    var phi_236_: u32;
    var phi_266_: bool;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_326_: u32;
    var phi_331_: u32;
    var phi_336_: u32;
    var phi_345_: u32;
    var phi_351_: u32;
    var phi_357_: u32;
    var phi_298_: u32;
    var phi_304_: u32;
    var phi_358_: u32;
    var phi_359_: u32;
    var phi_360_: u32;
    var phi_379_: u32;
    var phi_380_: u32;
    var phi_449_: array<u32, 2>;
    var phi_450_: array<u32, 2>;
    var phi_522_: array<u32, 2>;
    var phi_558_: array<u32, 2>;
    var phi_568_: array<u32, 2>;
    var phi_570_: array<array<u32, 2>, 4>;
    var phi_571_: array<array<u32, 2>, 4>;
    var phi_572_: bool;
    var phi_573_: array<array<u32, 2>, 4>;
    var phi_574_: bool;
    var phi_586_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_607_: bool;
    var phi_612_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_660_: bool;
    var phi_662_: bool;
    var phi_671_: bool;
    var phi_676_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_724_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_843_: array<u32, 2>;
    var phi_873_: array<u32, 2>;
    var phi_903_: array<u32, 2>;
    var phi_933_: array<u32, 2>;
    var phi_935_: array<array<u32, 2>, 4>;
    var phi_936_: bool;
    var phi_937_: array<array<u32, 2>, 4>;
    var phi_938_: bool;
    var phi_1097_: array<u32, 2>;
    var phi_1129_: array<u32, 2>;
    var phi_1004_: array<u32, 2>;
    var phi_1036_: array<u32, 2>;
    var phi_1131_: array<array<u32, 2>, 4>;
    var phi_1132_: array<array<u32, 2>, 4>;
    var phi_1133_: array<array<u32, 2>, 4>;
    var phi_1134_: bool;
    var phi_1135_: array<array<u32, 2>, 4>;
    var phi_1136_: bool;
    var phi_1140_: array<array<u32, 2>, 4>;
    var phi_1141_: array<array<u32, 2>, 4>;
    var phi_1142_: bool;
    var phi_1146_: array<array<u32, 2>, 4>;
    var phi_1205_: array<u32, 2>;
    var phi_1227_: array<u32, 2>;
    var phi_1229_: array<array<u32, 2>, 4>;
    var phi_1230_: array<array<u32, 2>, 4>;
    var phi_1231_: bool;
    var phi_1232_: array<array<u32, 2>, 4>;
    var phi_1233_: bool;
    var phi_1245_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1266_: bool;
    var phi_1271_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1315_: bool;
    var phi_1319_: bool;
    var phi_1321_: bool;
    var phi_1330_: bool;
    var phi_1335_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1383_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1430_: array<array<u32, 2>, 4>;
    var phi_1431_: bool;
    var phi_1432_: array<array<u32, 2>, 4>;
    var phi_1433_: bool;
    var phi_1450_: array<array<u32, 2>, 4>;
    var phi_1451_: array<array<u32, 2>, 4>;
    var phi_1452_: array<array<u32, 2>, 4>;
    var phi_1453_: bool;
    var phi_1454_: array<array<u32, 2>, 4>;
    var phi_1455_: bool;
    var phi_1459_: array<array<u32, 2>, 4>;
    var phi_1460_: array<array<u32, 2>, 4>;
    var phi_1461_: bool;
    var phi_1465_: array<array<u32, 2>, 4>;
    var phi_1466_: array<array<u32, 2>, 4>;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1502_: type_24;
    var phi_1503_: type_24;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1526_: u32;
    var phi_1527_: u32;
    var phi_1539_: type_24;
    var phi_1540_: type_24;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1563_: u32;
    var phi_1564_: u32;
    var phi_1576_: type_24;
    var phi_1577_: type_24;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1600_: u32;
    var phi_1601_: u32;
    var phi_1613_: type_24;
    var phi_1614_: type_24;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1635_: u32;
    var phi_1636_: u32;
    var phi_1642_: type_24;
    var phi_1643_: type_24;
    var phi_1644_: type_24;
    var phi_1645_: type_24;
    var phi_1646_: type_24;
    var phi_1664_: array<u32, 2>;
    var phi_1665_: array<u32, 2>;
    var phi_1677_: array<u32, 2>;
    var phi_1678_: array<u32, 2>;
    var phi_1695_: array<u32, 2>;
    var phi_1696_: array<u32, 2>;
    var phi_1708_: array<u32, 2>;
    var phi_1709_: array<u32, 2>;
    var phi_1726_: array<u32, 2>;
    var phi_1727_: array<u32, 2>;
    var phi_1739_: array<u32, 2>;
    var phi_1740_: array<u32, 2>;
    var phi_1757_: array<u32, 2>;
    var phi_1758_: array<u32, 2>;
    var phi_1770_: array<u32, 2>;
    var phi_1771_: array<u32, 2>;
    var phi_1804_: u32;
    var phi_1966_: type_12;
    var phi_1971_: type_12;
    var phi_2118_: type_12;
    var phi_2123_: type_12;
    var phi_2270_: type_12;
    var phi_2275_: type_12;
    var phi_2422_: type_12;
    var phi_2427_: type_12;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2500_: u32;
    var phi_2504_: u32;
    var phi_2561_: type_12;
    var phi_2562_: type_12;
    var phi_2585_: type_12;
    var phi_2641_: u32;
    var phi_2644_: type_12;
    var phi_2645_: type_12;
    var phi_2668_: type_12;
    var phi_2740_: type_12;
    var phi_2741_: type_12;
    var phi_2764_: type_12;
    var phi_2844_: bool;
    var phi_2845_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e66 = params.member.member_2;
    let _e71 = ((_e55.y * _e56.x) + _e55.x);
    let _e74 = params.member.member_1.member_1;
    let _e77 = params.member.member_2.member_3;
    let _e78 = (_e74 % 2u);
    let _e81 = params.member.member_2.member_7;
    let _e83 = atomicLoad((&control.member[_e74]));
    if (_e77 < _e83) {
        phi_145_ = _e77;
    } else {
        phi_145_ = _e83;
    }
    let _e86 = phi_145_;
    let _e87 = (_e78 * _e77);
    let _e89 = ((1u - _e78) * _e77);
    let _e91 = (_e66.member == 1u);
    if (_e66.member == 0u) {
        phi_158_ = array<u32, 2>(0u, 2u);
    } else {
        phi_158_ = array<u32, 2>(1u, 1u);
    }
    let _e95 = phi_158_;
    let _e101 = params.member.member.member[_e95[0]];
    let _e102 = (_e101 - 1u);
    let _e106 = params.member.member.member[_e95[1]];
    let _e107 = (_e106 - 1u);
    if (_e66.member_1 == 0u) {
        phi_182_ = 1u;
    } else {
        phi_182_ = 0u;
    }
    let _e111 = phi_182_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_194_ = type_12(0u, _e66.member_11);
    loop {
        let _e120 = phi_194_;
        if (_e120.member < _e120.member_1) {
            phi_195_ = type_12((_e120.member + 1u), _e120.member_1);
            phi_218_ = type_12(1u, _e120.member);
        } else {
            phi_195_ = _e120;
            phi_218_ = type_12(0u, type_12().member_1);
        }
        let _e132 = phi_195_;
        let _e134 = phi_218_;
        if (bitcast<i32>(_e134.member) != 0i) {
            if (_e57 == 0u) {
                let _e141 = atomicLoad((&shared_[0u]));
                if (128u < _e141) {
                    phi_236_ = 128u;
                } else {
                    phi_236_ = _e141;
                }
                let _e144 = phi_236_;
                if (_e66.member_9 > 0u) {
                    if (_e134.member_1 >= 16u) {
                        let _e150 = atomicLoad((&control.member[(1024u + _e74)]));
                        if (_e66.member_9 > 0u) {
                            phi_266_ = ((_e150 * 100u) >= (_e66.member_9 << bitcast<u32>((_e81 & 31u))));
                        } else {
                            phi_266_ = false;
                        }
                        let _e159 = phi_266_;
                        if _e159 {
                            phi_270_ = 2u;
                        } else {
                            phi_270_ = 0u;
                        }
                        let _e161 = phi_270_;
                        phi_271_ = _e161;
                    } else {
                        phi_271_ = 0u;
                    }
                    let _e163 = phi_271_;
                    phi_272_ = _e163;
                } else {
                    phi_272_ = 0u;
                }
                let _e165 = phi_272_;
                let _e166 = (128u - _e144);
                if (_e165 == 0u) {
                    if (_e166 > 0u) {
                        let _e170 = atomicLoad((&shared_[5u]));
                        if (_e66.member_6 == 0u) {
                            if (_e71 < _e86) {
                                phi_298_ = ((((_e86 - 1u) - _e71) >> bitcast<u32>((_e81 & 31u))) + 1u);
                            } else {
                                phi_298_ = 0u;
                            }
                            let _e213 = phi_298_;
                            let _e214 = (_e213 - _e170);
                            if (_e166 < _e214) {
                                phi_304_ = _e166;
                            } else {
                                phi_304_ = _e214;
                            }
                            let _e217 = phi_304_;
                            atomicStore((&shared_[3u]), (_e71 + (_e170 << bitcast<u32>((_e81 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e81 & 31u))));
                            atomicStore((&shared_[5u]), (_e170 + _e217));
                            phi_358_ = _e217;
                        } else {
                            if (_e170 == 0u) {
                                let _e178 = (_e86 >> bitcast<u32>(((_e81 + 2u) & 31u)));
                                if (_e66.member_8 < _e178) {
                                    phi_326_ = _e178;
                                } else {
                                    phi_326_ = _e66.member_8;
                                }
                                let _e181 = phi_326_;
                                if (128u < _e181) {
                                    phi_331_ = 128u;
                                } else {
                                    phi_331_ = _e181;
                                }
                                let _e184 = phi_331_;
                                if (_e166 < _e184) {
                                    phi_336_ = _e166;
                                } else {
                                    phi_336_ = _e184;
                                }
                                let _e187 = phi_336_;
                                let _e190 = atomicAdd((&control.member[(512u + _e74)]), _e187);
                                if (_e86 < _e190) {
                                    phi_345_ = _e86;
                                } else {
                                    phi_345_ = _e190;
                                }
                                let _e193 = phi_345_;
                                let _e194 = (_e86 - _e193);
                                if (_e187 < _e194) {
                                    phi_351_ = _e187;
                                } else {
                                    phi_351_ = _e194;
                                }
                                let _e197 = phi_351_;
                                atomicStore((&shared_[3u]), _e190);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e197 < _e187)));
                                phi_357_ = _e197;
                            } else {
                                phi_357_ = 0u;
                            }
                            let _e204 = phi_357_;
                            phi_358_ = _e204;
                        }
                        let _e230 = phi_358_;
                        phi_359_ = _e230;
                    } else {
                        phi_359_ = 0u;
                    }
                    let _e232 = phi_359_;
                    phi_360_ = _e232;
                } else {
                    phi_360_ = 0u;
                }
                let _e234 = phi_360_;
                if (_e165 == 0u) {
                    if ((_e144 + _e234) == 0u) {
                        if (_e66.member_9 > 0u) {
                            let _e242 = atomicAdd((&control.member[(1024u + _e74)]), 1u);
                        }
                        phi_379_ = 1u;
                    } else {
                        phi_379_ = _e165;
                    }
                    let _e244 = phi_379_;
                    phi_380_ = _e244;
                } else {
                    phi_380_ = _e165;
                }
                let _e246 = phi_380_;
                atomicStore((&shared_[1u]), _e144);
                atomicStore((&shared_[2u]), _e234);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e246;
            }
            let _e254 = workgroupUniformLoad((&state[0u]));
            if (_e254 != 0u) {
                phi_2480_ = false;
            } else {
                let _e257 = atomicLoad((&shared_[1u]));
                let _e259 = atomicLoad((&shared_[2u]));
                if (_e57 < _e257) {
                    let _e282 = atomicLoad((&shared_[0u]));
                    let _e285 = (2u * ((_e282 - 1u) - _e57));
                    let _e287 = stack[_e285];
                    let _e290 = stack[(_e285 + 1u)];
                    phi_450_ = array<u32, 2>(_e287, _e290);
                } else {
                    if (_e57 < (_e257 + _e259)) {
                        let _e264 = atomicLoad((&shared_[3u]));
                        let _e267 = atomicLoad((&shared_[4u]));
                        let _e271 = (2u * (_e87 + (_e264 + ((_e57 - _e257) * _e267))));
                        let _e274 = atomicLoad((&nodes.member[(4u + _e271)]));
                        let _e277 = atomicLoad((&nodes.member[(_e271 + 5u)]));
                        phi_449_ = array<u32, 2>(_e274, _e277);
                    } else {
                        phi_449_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e280 = phi_449_;
                    phi_450_ = _e280;
                }
                let _e293 = phi_450_;
                if (_e293[0] != 4294967295u) {
                    let _e299 = a_nodes.member[_e293[0]];
                    let _e301 = b_nodes.member[_e293[1]];
                    if _e91 {
                        if (_e293[0] == _e293[1]) {
                            if (_e299.member_3 == 4294967295u) {
                                phi_570_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            } else {
                                let _e307 = a_nodes.member[_e299.member_1];
                                let _e310 = a_nodes.member[_e299.member_3];
                                if !((_e307.member_3 == 4294967295u)) {
                                    phi_522_ = array<u32, 2>(_e299.member_1, _e299.member_1);
                                } else {
                                    phi_522_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e318 = phi_522_;
                                if ((((((_e307.member[0] <= _e310.member_2[0]) && (_e310.member[0] <= _e307.member_2[0])) && (_e307.member[1] <= _e310.member_2[1])) && (_e310.member[1] <= _e307.member_2[1])) && (_e307.member[2] <= _e310.member_2[2])) && (_e310.member[2] <= _e307.member_2[2])) {
                                    phi_558_ = array<u32, 2>(_e299.member_1, _e299.member_3);
                                } else {
                                    phi_558_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e350 = phi_558_;
                                if !((_e310.member_3 == 4294967295u)) {
                                    phi_568_ = array<u32, 2>(_e299.member_3, _e299.member_3);
                                } else {
                                    phi_568_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e358 = phi_568_;
                                phi_570_ = array<array<u32, 2>, 4>(_e318, _e350, _e358, array<u32, 2>(4294967295u, 4294967295u));
                            }
                            let _e361 = phi_570_;
                            phi_571_ = _e361;
                            phi_572_ = false;
                        } else {
                            phi_571_ = array<array<u32, 2>, 4>();
                            phi_572_ = true;
                        }
                        let _e363 = phi_571_;
                        let _e365 = phi_572_;
                        phi_573_ = _e363;
                        phi_574_ = _e365;
                    } else {
                        phi_573_ = array<array<u32, 2>, 4>();
                        phi_574_ = true;
                    }
                    let _e367 = phi_573_;
                    let _e369 = phi_574_;
                    if _e369 {
                        if (_e299.member_3 == 4294967295u) {
                            phi_586_ = false;
                        } else {
                            phi_586_ = !((_e301.member_3 == 4294967295u));
                        }
                        let _e376 = phi_586_;
                        if _e376 {
                            if (_e111 == 1u) {
                                phi_594_ = false;
                            } else {
                                phi_594_ = true;
                            }
                            let _e379 = phi_594_;
                            phi_595_ = _e379;
                        } else {
                            phi_595_ = true;
                        }
                        let _e381 = phi_595_;
                        if _e381 {
                            if (_e299.member_3 == 4294967295u) {
                                phi_607_ = false;
                            } else {
                                phi_607_ = !((_e301.member_3 == 4294967295u));
                            }
                            let _e388 = phi_607_;
                            if _e388 {
                                phi_612_ = (_e111 == 1u);
                            } else {
                                phi_612_ = false;
                            }
                            let _e391 = phi_612_;
                            if _e391 {
                                phi_655_ = bool();
                                phi_656_ = true;
                            } else {
                                let _e393 = (_e299.member_3 == 4294967295u);
                                if _e393 {
                                    phi_654_ = bool();
                                } else {
                                    if _e388 {
                                        phi_653_ = ((((_e301.member_2[0] - _e301.member[0]) * (_e301.member_2[1] - _e301.member[1])) * (_e301.member_2[2] - _e301.member[2])) > (((_e299.member_2[0] - _e299.member[0]) * (_e299.member_2[1] - _e299.member[1])) * (_e299.member_2[2] - _e299.member[2])));
                                    } else {
                                        phi_653_ = false;
                                    }
                                    let _e422 = phi_653_;
                                    phi_654_ = _e422;
                                }
                                let _e424 = phi_654_;
                                phi_655_ = _e424;
                                phi_656_ = _e393;
                            }
                            let _e426 = phi_655_;
                            let _e428 = phi_656_;
                            if _e428 {
                                phi_660_ = true;
                            } else {
                                phi_660_ = _e426;
                            }
                            let _e430 = phi_660_;
                            phi_662_ = !(_e430);
                        } else {
                            phi_662_ = true;
                        }
                        let _e433 = phi_662_;
                        if (_e299.member_3 == 4294967295u) {
                            phi_671_ = false;
                        } else {
                            phi_671_ = !((_e301.member_3 == 4294967295u));
                        }
                        let _e440 = phi_671_;
                        if _e440 {
                            phi_676_ = (_e111 == 1u);
                        } else {
                            phi_676_ = false;
                        }
                        let _e443 = phi_676_;
                        if _e443 {
                            phi_719_ = bool();
                            phi_720_ = true;
                        } else {
                            let _e445 = (_e299.member_3 == 4294967295u);
                            if _e445 {
                                phi_718_ = bool();
                            } else {
                                if _e440 {
                                    phi_717_ = ((((_e301.member_2[0] - _e301.member[0]) * (_e301.member_2[1] - _e301.member[1])) * (_e301.member_2[2] - _e301.member[2])) > (((_e299.member_2[0] - _e299.member[0]) * (_e299.member_2[1] - _e299.member[1])) * (_e299.member_2[2] - _e299.member[2])));
                                } else {
                                    phi_717_ = false;
                                }
                                let _e474 = phi_717_;
                                phi_718_ = _e474;
                            }
                            let _e476 = phi_718_;
                            phi_719_ = _e476;
                            phi_720_ = _e445;
                        }
                        let _e478 = phi_719_;
                        let _e480 = phi_720_;
                        if _e480 {
                            phi_724_ = true;
                        } else {
                            phi_724_ = _e478;
                        }
                        let _e482 = phi_724_;
                        if _e433 {
                            if (_e299.member_3 == 4294967295u) {
                                phi_734_ = false;
                            } else {
                                phi_734_ = true;
                            }
                            let _e486 = phi_734_;
                            phi_735_ = _e486;
                        } else {
                            phi_735_ = true;
                        }
                        let _e488 = phi_735_;
                        if _e488 {
                            if _e482 {
                                if (_e301.member_3 == 4294967295u) {
                                    phi_747_ = false;
                                } else {
                                    phi_747_ = true;
                                }
                                let _e492 = phi_747_;
                                phi_748_ = _e492;
                            } else {
                                phi_748_ = true;
                            }
                            let _e494 = phi_748_;
                            if _e494 {
                                if _e433 {
                                    if _e482 {
                                        let _e497 = a_nodes.member[_e299.member_1];
                                        let _e502 = a_nodes.member[_e299.member_3];
                                        let _e507 = b_nodes.member[_e301.member_1];
                                        let _e512 = b_nodes.member[_e301.member_3];
                                        if ((((((_e497.member[0] <= _e507.member_2[0]) && (_e507.member[0] <= _e497.member_2[0])) && (_e497.member[1] <= _e507.member_2[1])) && (_e507.member[1] <= _e497.member_2[1])) && (_e497.member[2] <= _e507.member_2[2])) && (_e507.member[2] <= _e497.member_2[2])) {
                                            phi_843_ = array<u32, 2>(_e299.member_1, _e301.member_1);
                                        } else {
                                            phi_843_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e542 = phi_843_;
                                        if ((((((_e497.member[0] <= _e512.member_2[0]) && (_e512.member[0] <= _e497.member_2[0])) && (_e497.member[1] <= _e512.member_2[1])) && (_e512.member[1] <= _e497.member_2[1])) && (_e497.member[2] <= _e512.member_2[2])) && (_e512.member[2] <= _e497.member_2[2])) {
                                            phi_873_ = array<u32, 2>(_e299.member_1, _e301.member_3);
                                        } else {
                                            phi_873_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e570 = phi_873_;
                                        if ((((((_e502.member[0] <= _e507.member_2[0]) && (_e507.member[0] <= _e502.member_2[0])) && (_e502.member[1] <= _e507.member_2[1])) && (_e507.member[1] <= _e502.member_2[1])) && (_e502.member[2] <= _e507.member_2[2])) && (_e507.member[2] <= _e502.member_2[2])) {
                                            phi_903_ = array<u32, 2>(_e299.member_3, _e301.member_1);
                                        } else {
                                            phi_903_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e598 = phi_903_;
                                        if ((((((_e502.member[0] <= _e512.member_2[0]) && (_e512.member[0] <= _e502.member_2[0])) && (_e502.member[1] <= _e512.member_2[1])) && (_e512.member[1] <= _e502.member_2[1])) && (_e502.member[2] <= _e512.member_2[2])) && (_e512.member[2] <= _e502.member_2[2])) {
                                            phi_933_ = array<u32, 2>(_e299.member_3, _e301.member_3);
                                        } else {
                                            phi_933_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e626 = phi_933_;
                                        phi_935_ = array<array<u32, 2>, 4>(_e542, _e570, _e598, _e626);
                                        phi_936_ = false;
                                    } else {
                                        phi_935_ = array<array<u32, 2>, 4>();
                                        phi_936_ = true;
                                    }
                                    let _e629 = phi_935_;
                                    let _e631 = phi_936_;
                                    phi_937_ = _e629;
                                    phi_938_ = _e631;
                                } else {
                                    phi_937_ = array<array<u32, 2>, 4>();
                                    phi_938_ = true;
                                }
                                let _e633 = phi_937_;
                                let _e635 = phi_938_;
                                if _e635 {
                                    if _e433 {
                                        let _e707 = a_nodes.member[_e299.member_1];
                                        let _e712 = a_nodes.member[_e299.member_3];
                                        if ((((((_e707.member[0] <= _e301.member_2[0]) && (_e301.member[0] <= _e707.member_2[0])) && (_e707.member[1] <= _e301.member_2[1])) && (_e301.member[1] <= _e707.member_2[1])) && (_e707.member[2] <= _e301.member_2[2])) && (_e301.member[2] <= _e707.member_2[2])) {
                                            phi_1004_ = array<u32, 2>(_e299.member_1, _e293[1]);
                                        } else {
                                            phi_1004_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e743 = phi_1004_;
                                        if ((((((_e712.member[0] <= _e301.member_2[0]) && (_e301.member[0] <= _e712.member_2[0])) && (_e712.member[1] <= _e301.member_2[1])) && (_e301.member[1] <= _e712.member_2[1])) && (_e712.member[2] <= _e301.member_2[2])) && (_e301.member[2] <= _e712.member_2[2])) {
                                            phi_1036_ = array<u32, 2>(_e299.member_3, _e293[1]);
                                        } else {
                                            phi_1036_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e772 = phi_1036_;
                                        phi_1131_ = array<array<u32, 2>, 4>(_e743, _e772, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    } else {
                                        let _e638 = b_nodes.member[_e301.member_1];
                                        let _e643 = b_nodes.member[_e301.member_3];
                                        if ((((((_e299.member[0] <= _e638.member_2[0]) && (_e638.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e638.member_2[1])) && (_e638.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e638.member_2[2])) && (_e638.member[2] <= _e299.member_2[2])) {
                                            phi_1097_ = array<u32, 2>(_e293[0], _e301.member_1);
                                        } else {
                                            phi_1097_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e674 = phi_1097_;
                                        if ((((((_e299.member[0] <= _e643.member_2[0]) && (_e643.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e643.member_2[1])) && (_e643.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e643.member_2[2])) && (_e643.member[2] <= _e299.member_2[2])) {
                                            phi_1129_ = array<u32, 2>(_e293[0], _e301.member_3);
                                        } else {
                                            phi_1129_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e703 = phi_1129_;
                                        phi_1131_ = array<array<u32, 2>, 4>(_e674, _e703, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    }
                                    let _e775 = phi_1131_;
                                    phi_1132_ = _e775;
                                } else {
                                    phi_1132_ = _e633;
                                }
                                let _e777 = phi_1132_;
                                phi_1133_ = _e777;
                                phi_1134_ = false;
                            } else {
                                phi_1133_ = array<array<u32, 2>, 4>();
                                phi_1134_ = true;
                            }
                            let _e779 = phi_1133_;
                            let _e781 = phi_1134_;
                            phi_1135_ = _e779;
                            phi_1136_ = _e781;
                        } else {
                            phi_1135_ = array<array<u32, 2>, 4>();
                            phi_1136_ = true;
                        }
                        let _e783 = phi_1135_;
                        let _e785 = phi_1136_;
                        phi_1140_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        phi_1141_ = _e783;
                        phi_1142_ = _e785;
                    } else {
                        phi_1140_ = _e367;
                        phi_1141_ = array<array<u32, 2>, 4>();
                        phi_1142_ = true;
                    }
                    let _e787 = phi_1140_;
                    let _e789 = phi_1141_;
                    let _e791 = phi_1142_;
                    if _e791 {
                        phi_1146_ = _e787;
                    } else {
                        phi_1146_ = _e789;
                    }
                    let _e793 = phi_1146_;
                    if (_e66.member_4 > 0u) {
                        let _e799 = a_nodes.member[_e293[0]];
                        let _e801 = b_nodes.member[_e293[1]];
                        if _e91 {
                            if (_e293[0] == _e293[1]) {
                                if (_e799.member_3 == 4294967295u) {
                                    phi_1229_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e807 = a_nodes.member[_e799.member_1];
                                    if !((_e807.member_3 == 4294967295u)) {
                                        phi_1205_ = array<u32, 2>(_e799.member_1, _e799.member_1);
                                    } else {
                                        phi_1205_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e813 = phi_1205_;
                                    let _e819 = a_nodes.member[_e799.member_3];
                                    if !((_e819.member_3 == 4294967295u)) {
                                        phi_1227_ = array<u32, 2>(_e799.member_3, _e799.member_3);
                                    } else {
                                        phi_1227_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e825 = phi_1227_;
                                    phi_1229_ = array<array<u32, 2>, 4>(_e813, array<u32, 2>(_e799.member_1, _e799.member_3), _e825, array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e828 = phi_1229_;
                                phi_1230_ = _e828;
                                phi_1231_ = false;
                            } else {
                                phi_1230_ = array<array<u32, 2>, 4>();
                                phi_1231_ = true;
                            }
                            let _e830 = phi_1230_;
                            let _e832 = phi_1231_;
                            phi_1232_ = _e830;
                            phi_1233_ = _e832;
                        } else {
                            phi_1232_ = array<array<u32, 2>, 4>();
                            phi_1233_ = true;
                        }
                        let _e834 = phi_1232_;
                        let _e836 = phi_1233_;
                        if _e836 {
                            if (_e799.member_3 == 4294967295u) {
                                phi_1245_ = false;
                            } else {
                                phi_1245_ = !((_e801.member_3 == 4294967295u));
                            }
                            let _e843 = phi_1245_;
                            if _e843 {
                                if (_e111 == 1u) {
                                    phi_1253_ = false;
                                } else {
                                    phi_1253_ = true;
                                }
                                let _e846 = phi_1253_;
                                phi_1254_ = _e846;
                            } else {
                                phi_1254_ = true;
                            }
                            let _e848 = phi_1254_;
                            if _e848 {
                                if (_e799.member_3 == 4294967295u) {
                                    phi_1266_ = false;
                                } else {
                                    phi_1266_ = !((_e801.member_3 == 4294967295u));
                                }
                                let _e855 = phi_1266_;
                                if _e855 {
                                    phi_1271_ = (_e111 == 1u);
                                } else {
                                    phi_1271_ = false;
                                }
                                let _e858 = phi_1271_;
                                if _e858 {
                                    phi_1314_ = bool();
                                    phi_1315_ = true;
                                } else {
                                    let _e860 = (_e799.member_3 == 4294967295u);
                                    if _e860 {
                                        phi_1313_ = bool();
                                    } else {
                                        if _e855 {
                                            phi_1312_ = ((((_e801.member_2[0] - _e801.member[0]) * (_e801.member_2[1] - _e801.member[1])) * (_e801.member_2[2] - _e801.member[2])) > (((_e799.member_2[0] - _e799.member[0]) * (_e799.member_2[1] - _e799.member[1])) * (_e799.member_2[2] - _e799.member[2])));
                                        } else {
                                            phi_1312_ = false;
                                        }
                                        let _e889 = phi_1312_;
                                        phi_1313_ = _e889;
                                    }
                                    let _e891 = phi_1313_;
                                    phi_1314_ = _e891;
                                    phi_1315_ = _e860;
                                }
                                let _e893 = phi_1314_;
                                let _e895 = phi_1315_;
                                if _e895 {
                                    phi_1319_ = true;
                                } else {
                                    phi_1319_ = _e893;
                                }
                                let _e897 = phi_1319_;
                                phi_1321_ = !(_e897);
                            } else {
                                phi_1321_ = true;
                            }
                            let _e900 = phi_1321_;
                            if (_e799.member_3 == 4294967295u) {
                                phi_1330_ = false;
                            } else {
                                phi_1330_ = !((_e801.member_3 == 4294967295u));
                            }
                            let _e907 = phi_1330_;
                            if _e907 {
                                phi_1335_ = (_e111 == 1u);
                            } else {
                                phi_1335_ = false;
                            }
                            let _e910 = phi_1335_;
                            if _e910 {
                                phi_1378_ = bool();
                                phi_1379_ = true;
                            } else {
                                let _e912 = (_e799.member_3 == 4294967295u);
                                if _e912 {
                                    phi_1377_ = bool();
                                } else {
                                    if _e907 {
                                        phi_1376_ = ((((_e801.member_2[0] - _e801.member[0]) * (_e801.member_2[1] - _e801.member[1])) * (_e801.member_2[2] - _e801.member[2])) > (((_e799.member_2[0] - _e799.member[0]) * (_e799.member_2[1] - _e799.member[1])) * (_e799.member_2[2] - _e799.member[2])));
                                    } else {
                                        phi_1376_ = false;
                                    }
                                    let _e941 = phi_1376_;
                                    phi_1377_ = _e941;
                                }
                                let _e943 = phi_1377_;
                                phi_1378_ = _e943;
                                phi_1379_ = _e912;
                            }
                            let _e945 = phi_1378_;
                            let _e947 = phi_1379_;
                            if _e947 {
                                phi_1383_ = true;
                            } else {
                                phi_1383_ = _e945;
                            }
                            let _e949 = phi_1383_;
                            if _e900 {
                                if (_e799.member_3 == 4294967295u) {
                                    phi_1393_ = false;
                                } else {
                                    phi_1393_ = true;
                                }
                                let _e953 = phi_1393_;
                                phi_1394_ = _e953;
                            } else {
                                phi_1394_ = true;
                            }
                            let _e955 = phi_1394_;
                            if _e955 {
                                if _e949 {
                                    if (_e801.member_3 == 4294967295u) {
                                        phi_1406_ = false;
                                    } else {
                                        phi_1406_ = true;
                                    }
                                    let _e959 = phi_1406_;
                                    phi_1407_ = _e959;
                                } else {
                                    phi_1407_ = true;
                                }
                                let _e961 = phi_1407_;
                                if _e961 {
                                    if _e900 {
                                        if _e949 {
                                            phi_1430_ = array<array<u32, 2>, 4>(array<u32, 2>(_e799.member_1, _e801.member_1), array<u32, 2>(_e799.member_1, _e801.member_3), array<u32, 2>(_e799.member_3, _e801.member_1), array<u32, 2>(_e799.member_3, _e801.member_3));
                                            phi_1431_ = false;
                                        } else {
                                            phi_1430_ = array<array<u32, 2>, 4>();
                                            phi_1431_ = true;
                                        }
                                        let _e976 = phi_1430_;
                                        let _e978 = phi_1431_;
                                        phi_1432_ = _e976;
                                        phi_1433_ = _e978;
                                    } else {
                                        phi_1432_ = array<array<u32, 2>, 4>();
                                        phi_1433_ = true;
                                    }
                                    let _e980 = phi_1432_;
                                    let _e982 = phi_1433_;
                                    if _e982 {
                                        if _e900 {
                                            phi_1450_ = array<array<u32, 2>, 4>(array<u32, 2>(_e799.member_1, _e293[1]), array<u32, 2>(_e799.member_3, _e293[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        } else {
                                            phi_1450_ = array<array<u32, 2>, 4>(array<u32, 2>(_e293[0], _e801.member_1), array<u32, 2>(_e293[0], _e801.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        }
                                        let _e994 = phi_1450_;
                                        phi_1451_ = _e994;
                                    } else {
                                        phi_1451_ = _e980;
                                    }
                                    let _e996 = phi_1451_;
                                    phi_1452_ = _e996;
                                    phi_1453_ = false;
                                } else {
                                    phi_1452_ = array<array<u32, 2>, 4>();
                                    phi_1453_ = true;
                                }
                                let _e998 = phi_1452_;
                                let _e1000 = phi_1453_;
                                phi_1454_ = _e998;
                                phi_1455_ = _e1000;
                            } else {
                                phi_1454_ = array<array<u32, 2>, 4>();
                                phi_1455_ = true;
                            }
                            let _e1002 = phi_1454_;
                            let _e1004 = phi_1455_;
                            phi_1459_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            phi_1460_ = _e1002;
                            phi_1461_ = _e1004;
                        } else {
                            phi_1459_ = _e834;
                            phi_1460_ = array<array<u32, 2>, 4>();
                            phi_1461_ = true;
                        }
                        let _e1006 = phi_1459_;
                        let _e1008 = phi_1460_;
                        let _e1010 = phi_1461_;
                        if _e1010 {
                            phi_1465_ = _e1006;
                        } else {
                            phi_1465_ = _e1008;
                        }
                        let _e1012 = phi_1465_;
                        phi_1466_ = _e1012;
                    } else {
                        phi_1466_ = _e793;
                    }
                    let _e1014 = phi_1466_;
                    if (_e793[0][0] == 4294967295u) {
                        phi_1490_ = 0u;
                    } else {
                        if (_e793[0][0] >= _e102) {
                            if (_e793[0][1] >= _e107) {
                                phi_1484_ = false;
                            } else {
                                phi_1484_ = true;
                            }
                            let _e1024 = phi_1484_;
                            phi_1485_ = _e1024;
                        } else {
                            phi_1485_ = true;
                        }
                        let _e1026 = phi_1485_;
                        if _e1026 {
                            phi_1489_ = 1u;
                        } else {
                            phi_1489_ = 2u;
                        }
                        let _e1028 = phi_1489_;
                        phi_1490_ = _e1028;
                    }
                    let _e1030 = phi_1490_;
                    let _e1031 = type_24(_e793[0], _e1030);
                    if (_e1030 == 0u) {
                        if (_e1014[0][0] != 4294967295u) {
                            phi_1502_ = type_24(_e1014[0], 3u);
                        } else {
                            phi_1502_ = _e1031;
                        }
                        let _e1037 = phi_1502_;
                        phi_1503_ = _e1037;
                    } else {
                        phi_1503_ = _e1031;
                    }
                    let _e1039 = phi_1503_;
                    if (_e793[1][0] == 4294967295u) {
                        phi_1527_ = 0u;
                    } else {
                        if (_e793[1][0] >= _e102) {
                            if (_e793[1][1] >= _e107) {
                                phi_1521_ = false;
                            } else {
                                phi_1521_ = true;
                            }
                            let _e1049 = phi_1521_;
                            phi_1522_ = _e1049;
                        } else {
                            phi_1522_ = true;
                        }
                        let _e1051 = phi_1522_;
                        if _e1051 {
                            phi_1526_ = 1u;
                        } else {
                            phi_1526_ = 2u;
                        }
                        let _e1053 = phi_1526_;
                        phi_1527_ = _e1053;
                    }
                    let _e1055 = phi_1527_;
                    let _e1056 = type_24(_e793[1], _e1055);
                    if (_e1055 == 0u) {
                        if (_e1014[1][0] != 4294967295u) {
                            phi_1539_ = type_24(_e1014[1], 3u);
                        } else {
                            phi_1539_ = _e1056;
                        }
                        let _e1062 = phi_1539_;
                        phi_1540_ = _e1062;
                    } else {
                        phi_1540_ = _e1056;
                    }
                    let _e1064 = phi_1540_;
                    if (_e793[2][0] == 4294967295u) {
                        phi_1564_ = 0u;
                    } else {
                        if (_e793[2][0] >= _e102) {
                            if (_e793[2][1] >= _e107) {
                                phi_1558_ = false;
                            } else {
                                phi_1558_ = true;
                            }
                            let _e1074 = phi_1558_;
                            phi_1559_ = _e1074;
                        } else {
                            phi_1559_ = true;
                        }
                        let _e1076 = phi_1559_;
                        if _e1076 {
                            phi_1563_ = 1u;
                        } else {
                            phi_1563_ = 2u;
                        }
                        let _e1078 = phi_1563_;
                        phi_1564_ = _e1078;
                    }
                    let _e1080 = phi_1564_;
                    let _e1081 = type_24(_e793[2], _e1080);
                    if (_e1080 == 0u) {
                        if (_e1014[2][0] != 4294967295u) {
                            phi_1576_ = type_24(_e1014[2], 3u);
                        } else {
                            phi_1576_ = _e1081;
                        }
                        let _e1087 = phi_1576_;
                        phi_1577_ = _e1087;
                    } else {
                        phi_1577_ = _e1081;
                    }
                    let _e1089 = phi_1577_;
                    if (_e793[3][0] == 4294967295u) {
                        phi_1601_ = 0u;
                    } else {
                        if (_e793[3][0] >= _e102) {
                            if (_e793[3][1] >= _e107) {
                                phi_1595_ = false;
                            } else {
                                phi_1595_ = true;
                            }
                            let _e1099 = phi_1595_;
                            phi_1596_ = _e1099;
                        } else {
                            phi_1596_ = true;
                        }
                        let _e1101 = phi_1596_;
                        if _e1101 {
                            phi_1600_ = 1u;
                        } else {
                            phi_1600_ = 2u;
                        }
                        let _e1103 = phi_1600_;
                        phi_1601_ = _e1103;
                    }
                    let _e1105 = phi_1601_;
                    let _e1106 = type_24(_e793[3], _e1105);
                    if (_e1105 == 0u) {
                        if (_e1014[3][0] != 4294967295u) {
                            phi_1613_ = type_24(_e1014[3], 3u);
                        } else {
                            phi_1613_ = _e1106;
                        }
                        let _e1112 = phi_1613_;
                        phi_1614_ = _e1112;
                    } else {
                        phi_1614_ = _e1106;
                    }
                    let _e1114 = phi_1614_;
                    if (_e293[0] == 4294967295u) {
                        phi_1636_ = 0u;
                    } else {
                        if (_e293[0] >= _e102) {
                            if (_e293[1] >= _e107) {
                                phi_1630_ = false;
                            } else {
                                phi_1630_ = true;
                            }
                            let _e1122 = phi_1630_;
                            phi_1631_ = _e1122;
                        } else {
                            phi_1631_ = true;
                        }
                        let _e1124 = phi_1631_;
                        if _e1124 {
                            phi_1635_ = 1u;
                        } else {
                            phi_1635_ = 2u;
                        }
                        let _e1126 = phi_1635_;
                        phi_1636_ = _e1126;
                    }
                    let _e1128 = phi_1636_;
                    if (_e1128 == 2u) {
                        phi_1642_ = type_24(_e293, 2u);
                    } else {
                        phi_1642_ = _e1039;
                    }
                    let _e1132 = phi_1642_;
                    phi_1643_ = _e1132;
                    phi_1644_ = _e1114;
                    phi_1645_ = _e1089;
                    phi_1646_ = _e1064;
                } else {
                    phi_1643_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1644_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1645_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1646_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e1134 = phi_1643_;
                let _e1136 = phi_1644_;
                let _e1138 = phi_1645_;
                let _e1140 = phi_1646_;
                if (_e1134.member_1 == 1u) {
                    let _e1151 = atomicAdd((&shared_[6u]), 1u);
                    phi_1665_ = array<u32, 2>(_e1151, 0u);
                } else {
                    if (_e1134.member_1 == 2u) {
                        let _e1146 = atomicAdd((&shared_[7u]), 1u);
                        phi_1664_ = array<u32, 2>(_e1146, 0u);
                    } else {
                        phi_1664_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1149 = phi_1664_;
                    phi_1665_ = _e1149;
                }
                let _e1154 = phi_1665_;
                if (_e1134.member_1 >= 2u) {
                    if (_e66.member_4 > 0u) {
                        let _e1158 = atomicAdd((&shared_[8u]), 1u);
                        phi_1677_ = array<u32, 2>(_e1154[0], _e1158);
                    } else {
                        phi_1677_ = _e1154;
                    }
                    let _e1162 = phi_1677_;
                    phi_1678_ = _e1162;
                } else {
                    phi_1678_ = _e1154;
                }
                let _e1164 = phi_1678_;
                if (_e1140.member_1 == 1u) {
                    let _e1174 = atomicAdd((&shared_[6u]), 1u);
                    phi_1696_ = array<u32, 2>(_e1174, 0u);
                } else {
                    if (_e1140.member_1 == 2u) {
                        let _e1169 = atomicAdd((&shared_[7u]), 1u);
                        phi_1695_ = array<u32, 2>(_e1169, 0u);
                    } else {
                        phi_1695_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1172 = phi_1695_;
                    phi_1696_ = _e1172;
                }
                let _e1177 = phi_1696_;
                if (_e1140.member_1 >= 2u) {
                    if (_e66.member_4 > 0u) {
                        let _e1181 = atomicAdd((&shared_[8u]), 1u);
                        phi_1708_ = array<u32, 2>(_e1177[0], _e1181);
                    } else {
                        phi_1708_ = _e1177;
                    }
                    let _e1185 = phi_1708_;
                    phi_1709_ = _e1185;
                } else {
                    phi_1709_ = _e1177;
                }
                let _e1187 = phi_1709_;
                if (_e1138.member_1 == 1u) {
                    let _e1197 = atomicAdd((&shared_[6u]), 1u);
                    phi_1727_ = array<u32, 2>(_e1197, 0u);
                } else {
                    if (_e1138.member_1 == 2u) {
                        let _e1192 = atomicAdd((&shared_[7u]), 1u);
                        phi_1726_ = array<u32, 2>(_e1192, 0u);
                    } else {
                        phi_1726_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1195 = phi_1726_;
                    phi_1727_ = _e1195;
                }
                let _e1200 = phi_1727_;
                if (_e1138.member_1 >= 2u) {
                    if (_e66.member_4 > 0u) {
                        let _e1204 = atomicAdd((&shared_[8u]), 1u);
                        phi_1739_ = array<u32, 2>(_e1200[0], _e1204);
                    } else {
                        phi_1739_ = _e1200;
                    }
                    let _e1208 = phi_1739_;
                    phi_1740_ = _e1208;
                } else {
                    phi_1740_ = _e1200;
                }
                let _e1210 = phi_1740_;
                if (_e1136.member_1 == 1u) {
                    let _e1220 = atomicAdd((&shared_[6u]), 1u);
                    phi_1758_ = array<u32, 2>(_e1220, 0u);
                } else {
                    if (_e1136.member_1 == 2u) {
                        let _e1215 = atomicAdd((&shared_[7u]), 1u);
                        phi_1757_ = array<u32, 2>(_e1215, 0u);
                    } else {
                        phi_1757_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1218 = phi_1757_;
                    phi_1758_ = _e1218;
                }
                let _e1223 = phi_1758_;
                if (_e1136.member_1 >= 2u) {
                    if (_e66.member_4 > 0u) {
                        let _e1227 = atomicAdd((&shared_[8u]), 1u);
                        phi_1770_ = array<u32, 2>(_e1223[0], _e1227);
                    } else {
                        phi_1770_ = _e1223;
                    }
                    let _e1231 = phi_1770_;
                    phi_1771_ = _e1231;
                } else {
                    phi_1771_ = _e1223;
                }
                let _e1233 = phi_1771_;
                workgroupBarrier();
                if (_e57 == 0u) {
                    let _e1236 = atomicLoad((&shared_[6u]));
                    let _e1238 = atomicLoad((&shared_[7u]));
                    let _e1240 = atomicLoad((&shared_[8u]));
                    let _e1242 = atomicLoad((&shared_[1u]));
                    let _e1244 = atomicLoad((&shared_[2u]));
                    let _e1246 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1246 + 1u));
                    let _e1250 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1250 + _e1242) + _e1244));
                    let _e1255 = atomicLoad((&shared_[0u]));
                    let _e1256 = (_e1255 - _e1242);
                    let _e1258 = (_e66.member_10 - _e1256);
                    if (_e1258 < _e1236) {
                        phi_1804_ = _e1258;
                    } else {
                        phi_1804_ = _e1236;
                    }
                    let _e1261 = phi_1804_;
                    atomicStore((&shared_[9u]), _e1256);
                    atomicStore((&shared_[10u]), _e1261);
                    atomicStore((&shared_[0u]), (_e1256 + _e1261));
                    if (_e1236 > _e1261) {
                        let _e1267 = (_e1236 - _e1261);
                        if (_e66.member_12 == 0u) {
                        } else {
                            let _e1271 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1274 = atomicAdd((&control.member[(_e74 + 1u)]), _e1267);
                        let _e1277 = atomicMax((&nodes.member[0u]), (_e1274 + _e1267));
                        if ((_e1274 + _e1267) < _e1274) {
                            let _e1281 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1274);
                    }
                    if (_e1238 > 0u) {
                        let _e1285 = atomicAdd((&pairs.member[0u]), _e1238);
                        if ((_e1285 + _e1238) < _e1285) {
                            let _e1289 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1285);
                    }
                    if (_e1240 > 0u) {
                        let _e1293 = atomicAdd((&control.member[1537u]), _e1240);
                        if ((_e1293 + _e1240) < _e1293) {
                            let _e1297 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1293);
                    }
                }
                workgroupBarrier();
                if (_e1134.member_1 == 1u) {
                    let _e1364 = atomicLoad((&shared_[10u]));
                    if (_e1164[0] < _e1364) {
                        let _e1386 = atomicLoad((&shared_[9u]));
                        let _e1389 = (2u * (_e1386 + _e1164[0]));
                        stack[_e1389] = _e1134.member[0];
                        stack[(_e1389 + 1u)] = _e1134.member[1];
                    } else {
                        let _e1368 = atomicLoad((&shared_[11u]));
                        let _e1371 = ((_e1368 + _e1164[0]) - _e1364);
                        let _e1374 = params.member.member_2.member_3;
                        if (_e1371 < _e1374) {
                            let _e1376 = (_e89 + _e1371);
                            if (_e1376 < 4294967295u) {
                                let _e1380 = (2u * _e1376);
                                atomicStore((&nodes.member[(4u + _e1380)]), _e1134.member[0]);
                                atomicStore((&nodes.member[(_e1380 + 5u)]), _e1134.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1134.member_1 == 0u) {
                    } else {
                        if (_e1134.member_1 == 2u) {
                            let _e1306 = a_nodes.member[_e1134.member[0]];
                            let _e1310 = b_nodes.member[_e1134.member[1]];
                            let _e1314 = params.member.member_2.member;
                            if (_e1314 == 1u) {
                                if (_e1306.member_1 < _e1310.member_1) {
                                    phi_1966_ = type_12(_e1306.member_1, _e1310.member_1);
                                } else {
                                    phi_1966_ = type_12(_e1310.member_1, _e1306.member_1);
                                }
                                let _e1321 = phi_1966_;
                                phi_1971_ = _e1321;
                            } else {
                                phi_1971_ = type_12(_e1306.member_1, _e1310.member_1);
                            }
                            let _e1323 = phi_1971_;
                            let _e1326 = params.member.member_1.member_3;
                            let _e1328 = atomicLoad((&shared_[12u]));
                            let _e1330 = (_e1328 + _e1164[0]);
                            if (_e1330 < _e1326) {
                                let _e1334 = (2u * _e1330);
                                atomicStore((&pairs.member[(4u + _e1334)]), _e1323.member);
                                atomicStore((&pairs.member[(_e1334 + 5u)]), _e1323.member_1);
                            }
                        }
                        let _e1341 = params.member.member_2.member_4;
                        if (_e1341 > 0u) {
                            let _e1345 = atomicLoad((&shared_[13u]));
                            let _e1347 = (_e1345 + _e1164[1]);
                            let _e1349 = params.member.member_2.member_4;
                            if (_e1347 < _e1349) {
                                let _e1352 = params.member.member_2.member_5;
                                let _e1354 = params.member.member_2.member_4;
                                let _e1357 = (2u * ((_e1352 * _e1354) + _e1347));
                                front.member[_e1357] = _e1134.member[0];
                                front.member[(_e1357 + 1u)] = _e1134.member[1];
                            }
                        }
                    }
                }
                if (_e1140.member_1 == 1u) {
                    let _e1460 = atomicLoad((&shared_[10u]));
                    if (_e1187[0] < _e1460) {
                        let _e1482 = atomicLoad((&shared_[9u]));
                        let _e1485 = (2u * (_e1482 + _e1187[0]));
                        stack[_e1485] = _e1140.member[0];
                        stack[(_e1485 + 1u)] = _e1140.member[1];
                    } else {
                        let _e1464 = atomicLoad((&shared_[11u]));
                        let _e1467 = ((_e1464 + _e1187[0]) - _e1460);
                        let _e1470 = params.member.member_2.member_3;
                        if (_e1467 < _e1470) {
                            let _e1472 = (_e89 + _e1467);
                            if (_e1472 < 4294967295u) {
                                let _e1476 = (2u * _e1472);
                                atomicStore((&nodes.member[(4u + _e1476)]), _e1140.member[0]);
                                atomicStore((&nodes.member[(_e1476 + 5u)]), _e1140.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1140.member_1 == 0u) {
                    } else {
                        if (_e1140.member_1 == 2u) {
                            let _e1402 = a_nodes.member[_e1140.member[0]];
                            let _e1406 = b_nodes.member[_e1140.member[1]];
                            let _e1410 = params.member.member_2.member;
                            if (_e1410 == 1u) {
                                if (_e1402.member_1 < _e1406.member_1) {
                                    phi_2118_ = type_12(_e1402.member_1, _e1406.member_1);
                                } else {
                                    phi_2118_ = type_12(_e1406.member_1, _e1402.member_1);
                                }
                                let _e1417 = phi_2118_;
                                phi_2123_ = _e1417;
                            } else {
                                phi_2123_ = type_12(_e1402.member_1, _e1406.member_1);
                            }
                            let _e1419 = phi_2123_;
                            let _e1422 = params.member.member_1.member_3;
                            let _e1424 = atomicLoad((&shared_[12u]));
                            let _e1426 = (_e1424 + _e1187[0]);
                            if (_e1426 < _e1422) {
                                let _e1430 = (2u * _e1426);
                                atomicStore((&pairs.member[(4u + _e1430)]), _e1419.member);
                                atomicStore((&pairs.member[(_e1430 + 5u)]), _e1419.member_1);
                            }
                        }
                        let _e1437 = params.member.member_2.member_4;
                        if (_e1437 > 0u) {
                            let _e1441 = atomicLoad((&shared_[13u]));
                            let _e1443 = (_e1441 + _e1187[1]);
                            let _e1445 = params.member.member_2.member_4;
                            if (_e1443 < _e1445) {
                                let _e1448 = params.member.member_2.member_5;
                                let _e1450 = params.member.member_2.member_4;
                                let _e1453 = (2u * ((_e1448 * _e1450) + _e1443));
                                front.member[_e1453] = _e1140.member[0];
                                front.member[(_e1453 + 1u)] = _e1140.member[1];
                            }
                        }
                    }
                }
                if (_e1138.member_1 == 1u) {
                    let _e1556 = atomicLoad((&shared_[10u]));
                    if (_e1210[0] < _e1556) {
                        let _e1578 = atomicLoad((&shared_[9u]));
                        let _e1581 = (2u * (_e1578 + _e1210[0]));
                        stack[_e1581] = _e1138.member[0];
                        stack[(_e1581 + 1u)] = _e1138.member[1];
                    } else {
                        let _e1560 = atomicLoad((&shared_[11u]));
                        let _e1563 = ((_e1560 + _e1210[0]) - _e1556);
                        let _e1566 = params.member.member_2.member_3;
                        if (_e1563 < _e1566) {
                            let _e1568 = (_e89 + _e1563);
                            if (_e1568 < 4294967295u) {
                                let _e1572 = (2u * _e1568);
                                atomicStore((&nodes.member[(4u + _e1572)]), _e1138.member[0]);
                                atomicStore((&nodes.member[(_e1572 + 5u)]), _e1138.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1138.member_1 == 0u) {
                    } else {
                        if (_e1138.member_1 == 2u) {
                            let _e1498 = a_nodes.member[_e1138.member[0]];
                            let _e1502 = b_nodes.member[_e1138.member[1]];
                            let _e1506 = params.member.member_2.member;
                            if (_e1506 == 1u) {
                                if (_e1498.member_1 < _e1502.member_1) {
                                    phi_2270_ = type_12(_e1498.member_1, _e1502.member_1);
                                } else {
                                    phi_2270_ = type_12(_e1502.member_1, _e1498.member_1);
                                }
                                let _e1513 = phi_2270_;
                                phi_2275_ = _e1513;
                            } else {
                                phi_2275_ = type_12(_e1498.member_1, _e1502.member_1);
                            }
                            let _e1515 = phi_2275_;
                            let _e1518 = params.member.member_1.member_3;
                            let _e1520 = atomicLoad((&shared_[12u]));
                            let _e1522 = (_e1520 + _e1210[0]);
                            if (_e1522 < _e1518) {
                                let _e1526 = (2u * _e1522);
                                atomicStore((&pairs.member[(4u + _e1526)]), _e1515.member);
                                atomicStore((&pairs.member[(_e1526 + 5u)]), _e1515.member_1);
                            }
                        }
                        let _e1533 = params.member.member_2.member_4;
                        if (_e1533 > 0u) {
                            let _e1537 = atomicLoad((&shared_[13u]));
                            let _e1539 = (_e1537 + _e1210[1]);
                            let _e1541 = params.member.member_2.member_4;
                            if (_e1539 < _e1541) {
                                let _e1544 = params.member.member_2.member_5;
                                let _e1546 = params.member.member_2.member_4;
                                let _e1549 = (2u * ((_e1544 * _e1546) + _e1539));
                                front.member[_e1549] = _e1138.member[0];
                                front.member[(_e1549 + 1u)] = _e1138.member[1];
                            }
                        }
                    }
                }
                if (_e1136.member_1 == 1u) {
                    let _e1652 = atomicLoad((&shared_[10u]));
                    if (_e1233[0] < _e1652) {
                        let _e1674 = atomicLoad((&shared_[9u]));
                        let _e1677 = (2u * (_e1674 + _e1233[0]));
                        stack[_e1677] = _e1136.member[0];
                        stack[(_e1677 + 1u)] = _e1136.member[1];
                    } else {
                        let _e1656 = atomicLoad((&shared_[11u]));
                        let _e1659 = ((_e1656 + _e1233[0]) - _e1652);
                        let _e1662 = params.member.member_2.member_3;
                        if (_e1659 < _e1662) {
                            let _e1664 = (_e89 + _e1659);
                            if (_e1664 < 4294967295u) {
                                let _e1668 = (2u * _e1664);
                                atomicStore((&nodes.member[(4u + _e1668)]), _e1136.member[0]);
                                atomicStore((&nodes.member[(_e1668 + 5u)]), _e1136.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1136.member_1 == 0u) {
                    } else {
                        if (_e1136.member_1 == 2u) {
                            let _e1594 = a_nodes.member[_e1136.member[0]];
                            let _e1598 = b_nodes.member[_e1136.member[1]];
                            let _e1602 = params.member.member_2.member;
                            if (_e1602 == 1u) {
                                if (_e1594.member_1 < _e1598.member_1) {
                                    phi_2422_ = type_12(_e1594.member_1, _e1598.member_1);
                                } else {
                                    phi_2422_ = type_12(_e1598.member_1, _e1594.member_1);
                                }
                                let _e1609 = phi_2422_;
                                phi_2427_ = _e1609;
                            } else {
                                phi_2427_ = type_12(_e1594.member_1, _e1598.member_1);
                            }
                            let _e1611 = phi_2427_;
                            let _e1614 = params.member.member_1.member_3;
                            let _e1616 = atomicLoad((&shared_[12u]));
                            let _e1618 = (_e1616 + _e1233[0]);
                            if (_e1618 < _e1614) {
                                let _e1622 = (2u * _e1618);
                                atomicStore((&pairs.member[(4u + _e1622)]), _e1611.member);
                                atomicStore((&pairs.member[(_e1622 + 5u)]), _e1611.member_1);
                            }
                        }
                        let _e1629 = params.member.member_2.member_4;
                        if (_e1629 > 0u) {
                            let _e1633 = atomicLoad((&shared_[13u]));
                            let _e1635 = (_e1633 + _e1233[1]);
                            let _e1637 = params.member.member_2.member_4;
                            if (_e1635 < _e1637) {
                                let _e1640 = params.member.member_2.member_5;
                                let _e1642 = params.member.member_2.member_4;
                                let _e1645 = (2u * ((_e1640 * _e1642) + _e1635));
                                front.member[_e1645] = _e1136.member[0];
                                front.member[(_e1645 + 1u)] = _e1136.member[1];
                            }
                        }
                    }
                }
                phi_2480_ = true;
            }
            let _e1684 = phi_2480_;
            phi_2481_ = _e1684;
        } else {
            phi_2481_ = false;
        }
        let _e1686 = phi_2481_;
        continue;
        continuing {
            phi_194_ = _e132;
            break if !(_e1686);
        }
    }
    if (_e57 == 0u) {
        if (_e66.member_6 == 0u) {
            if (_e71 < _e86) {
                phi_2500_ = ((((_e86 - 1u) - _e71) >> bitcast<u32>((_e81 & 31u))) + 1u);
            } else {
                phi_2500_ = 0u;
            }
            let _e1699 = phi_2500_;
            let _e1701 = atomicLoad((&shared_[5u]));
            phi_2504_ = (_e1699 - _e1701);
        } else {
            phi_2504_ = 0u;
        }
        let _e1704 = phi_2504_;
        atomicStore((&shared_[14u]), _e1704);
        let _e1707 = atomicLoad((&shared_[0u]));
        let _e1708 = (_e1707 + _e1704);
        if (_e1708 > 0u) {
            if (_e66.member_12 == 0u) {
            } else {
                let _e1713 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e1716 = atomicAdd((&control.member[(_e74 + 1u)]), _e1708);
            let _e1719 = atomicMax((&nodes.member[0u]), (_e1716 + _e1708));
            if ((_e1716 + _e1708) < _e1716) {
                let _e1723 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e1716);
        }
        let _e1728 = atomicLoad((&shared_[15u]));
        let _e1730 = atomicAdd((&control.member[(1540u + (2u * _e71))]), _e1728);
        let _e1734 = atomicLoad((&shared_[16u]));
        let _e1736 = atomicAdd((&control.member[((2u * _e71) + 1541u)]), _e1734);
    }
    workgroupBarrier();
    let _e1738 = atomicLoad((&shared_[0u]));
    let _e1740 = atomicLoad((&shared_[17u]));
    let _e1742 = atomicLoad((&shared_[14u]));
    phi_2561_ = type_12(0u, 8u);
    loop {
        let _e1744 = phi_2561_;
        if (_e1744.member < _e1744.member_1) {
            phi_2562_ = type_12((_e1744.member + 1u), _e1744.member_1);
            phi_2585_ = type_12(1u, _e1744.member);
        } else {
            phi_2562_ = _e1744;
            phi_2585_ = type_12(0u, type_12().member_1);
        }
        let _e1756 = phi_2562_;
        let _e1758 = phi_2585_;
        let _e1762 = (bitcast<i32>(_e1758.member) != 0i);
        if _e1762 {
            let _e1764 = ((_e1758.member_1 * 128u) + _e57);
            if (_e1764 < _e1738) {
                let _e1768 = stack[(2u * _e1764)];
                let _e1772 = stack[((2u * _e1764) + 1u)];
                let _e1773 = (_e1740 + _e1764);
                if (_e1773 < _e66.member_3) {
                    let _e1776 = (_e89 + _e1773);
                    if (_e1776 < 4294967295u) {
                        let _e1778 = (2u * _e1776);
                        atomicStore((&nodes.member[(4u + _e1778)]), _e1768);
                        atomicStore((&nodes.member[(_e1778 + 5u)]), _e1772);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2561_ = _e1756;
            break if !(_e1762);
        }
    }
    let _e1785 = atomicLoad((&shared_[5u]));
    let _e1786 = (_e1742 / 128u);
    if ((_e1742 % 128u) > 0u) {
        phi_2641_ = (_e1786 + 1u);
    } else {
        phi_2641_ = _e1786;
    }
    let _e1791 = phi_2641_;
    phi_2644_ = type_12(0u, _e1791);
    loop {
        let _e1794 = phi_2644_;
        if (_e1794.member < _e1794.member_1) {
            phi_2645_ = type_12((_e1794.member + 1u), _e1794.member_1);
            phi_2668_ = type_12(1u, _e1794.member);
        } else {
            phi_2645_ = _e1794;
            phi_2668_ = type_12(0u, type_12().member_1);
        }
        let _e1806 = phi_2645_;
        let _e1808 = phi_2668_;
        let _e1812 = (bitcast<i32>(_e1808.member) != 0i);
        if _e1812 {
            let _e1814 = ((_e1808.member_1 * 128u) + _e57);
            if (_e1814 < _e1742) {
                let _e1822 = (2u * ((_e87 + _e71) + ((_e1785 + _e1814) << bitcast<u32>((_e81 & 31u)))));
                let _e1825 = atomicLoad((&nodes.member[(4u + _e1822)]));
                let _e1828 = atomicLoad((&nodes.member[(_e1822 + 5u)]));
                let _e1830 = ((_e1740 + _e1738) + _e1814);
                if (_e1830 < _e66.member_3) {
                    let _e1833 = (_e89 + _e1830);
                    if (_e1833 < 4294967295u) {
                        let _e1835 = (2u * _e1833);
                        atomicStore((&nodes.member[(4u + _e1835)]), _e1825);
                        atomicStore((&nodes.member[(_e1835 + 5u)]), _e1828);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2644_ = _e1806;
            break if !(_e1812);
        }
    }
    if (_e66.member_6 == 1u) {
        if (_e1785 == 0u) {
            phi_2740_ = type_12(0u, _e86);
            loop {
                let _e1846 = phi_2740_;
                if (_e1846.member < _e1846.member_1) {
                    phi_2741_ = type_12((_e1846.member + 1u), _e1846.member_1);
                    phi_2764_ = type_12(1u, _e1846.member);
                } else {
                    phi_2741_ = _e1846;
                    phi_2764_ = type_12(0u, type_12().member_1);
                }
                let _e1858 = phi_2741_;
                let _e1860 = phi_2764_;
                if (bitcast<i32>(_e1860.member) != 0i) {
                    let _e1866 = atomicAdd((&control.member[(512u + _e74)]), 1u);
                    if (_e1866 >= _e86) {
                        phi_2844_ = false;
                    } else {
                        let _e1869 = (2u * (_e87 + _e1866));
                        let _e1872 = atomicLoad((&nodes.member[(4u + _e1869)]));
                        let _e1875 = atomicLoad((&nodes.member[(_e1869 + 5u)]));
                        if (_e66.member_12 == 0u) {
                        } else {
                            let _e1879 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1882 = atomicAdd((&control.member[(_e74 + 1u)]), 1u);
                        let _e1885 = atomicMax((&nodes.member[0u]), (_e1882 + 1u));
                        if ((_e1882 + 1u) < _e1882) {
                            let _e1889 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1882 < _e66.member_3) {
                            let _e1892 = (_e89 + _e1882);
                            if (_e1892 < 4294967295u) {
                                let _e1894 = (2u * _e1892);
                                atomicStore((&nodes.member[(4u + _e1894)]), _e1872);
                                atomicStore((&nodes.member[(_e1894 + 5u)]), _e1875);
                            }
                        }
                        phi_2844_ = true;
                    }
                    let _e1900 = phi_2844_;
                    phi_2845_ = _e1900;
                } else {
                    phi_2845_ = false;
                }
                let _e1902 = phi_2845_;
                continue;
                continuing {
                    phi_2740_ = _e1858;
                    break if !(_e1902);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
