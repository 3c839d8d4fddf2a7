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
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_142_: u32;
    var phi_159_: type_12;
    var phi_160_: type_12;
    var phi_183_: type_12;
    var phi_201_: u32;
    var phi_231_: bool;
    var phi_235_: u32;
    var phi_236_: u32;
    var phi_237_: u32;
    var phi_291_: u32;
    var phi_296_: u32;
    var phi_301_: u32;
    var phi_310_: u32;
    var phi_316_: u32;
    var phi_322_: u32;
    var phi_263_: u32;
    var phi_269_: u32;
    var phi_323_: u32;
    var phi_324_: u32;
    var phi_325_: u32;
    var phi_344_: u32;
    var phi_345_: u32;
    var phi_414_: array<u32, 2>;
    var phi_415_: array<u32, 2>;
    var phi_429_: array<u32, 2>;
    var phi_455_: u32;
    var phi_527_: array<u32, 2>;
    var phi_563_: array<u32, 2>;
    var phi_573_: array<u32, 2>;
    var phi_575_: array<array<u32, 2>, 4>;
    var phi_576_: array<array<u32, 2>, 4>;
    var phi_577_: bool;
    var phi_578_: array<array<u32, 2>, 4>;
    var phi_579_: bool;
    var phi_591_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_612_: bool;
    var phi_617_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_665_: bool;
    var phi_667_: bool;
    var phi_676_: bool;
    var phi_681_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_729_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_848_: array<u32, 2>;
    var phi_878_: array<u32, 2>;
    var phi_908_: array<u32, 2>;
    var phi_938_: array<u32, 2>;
    var phi_940_: array<array<u32, 2>, 4>;
    var phi_941_: bool;
    var phi_942_: array<array<u32, 2>, 4>;
    var phi_943_: bool;
    var phi_1102_: array<u32, 2>;
    var phi_1134_: array<u32, 2>;
    var phi_1009_: array<u32, 2>;
    var phi_1041_: array<u32, 2>;
    var phi_1136_: array<array<u32, 2>, 4>;
    var phi_1137_: array<array<u32, 2>, 4>;
    var phi_1138_: array<array<u32, 2>, 4>;
    var phi_1139_: bool;
    var phi_1140_: array<array<u32, 2>, 4>;
    var phi_1141_: bool;
    var phi_1145_: array<array<u32, 2>, 4>;
    var phi_1146_: array<array<u32, 2>, 4>;
    var phi_1147_: bool;
    var phi_1151_: array<array<u32, 2>, 4>;
    var phi_1212_: array<u32, 2>;
    var phi_1234_: array<u32, 2>;
    var phi_1236_: array<array<u32, 2>, 4>;
    var phi_1237_: array<array<u32, 2>, 4>;
    var phi_1238_: bool;
    var phi_1239_: array<array<u32, 2>, 4>;
    var phi_1240_: bool;
    var phi_1252_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1273_: bool;
    var phi_1278_: bool;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1326_: bool;
    var phi_1328_: bool;
    var phi_1337_: bool;
    var phi_1342_: bool;
    var phi_1383_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1390_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1437_: array<array<u32, 2>, 4>;
    var phi_1438_: bool;
    var phi_1439_: array<array<u32, 2>, 4>;
    var phi_1440_: bool;
    var phi_1457_: array<array<u32, 2>, 4>;
    var phi_1458_: array<array<u32, 2>, 4>;
    var phi_1459_: array<array<u32, 2>, 4>;
    var phi_1460_: bool;
    var phi_1461_: array<array<u32, 2>, 4>;
    var phi_1462_: bool;
    var phi_1466_: array<array<u32, 2>, 4>;
    var phi_1467_: array<array<u32, 2>, 4>;
    var phi_1468_: bool;
    var phi_1472_: array<array<u32, 2>, 4>;
    var phi_1473_: array<array<u32, 2>, 4>;
    var phi_1491_: bool;
    var phi_1492_: bool;
    var phi_1496_: u32;
    var phi_1497_: u32;
    var phi_1509_: type_24;
    var phi_1510_: type_24;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1533_: u32;
    var phi_1534_: u32;
    var phi_1546_: type_24;
    var phi_1547_: type_24;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1570_: u32;
    var phi_1571_: u32;
    var phi_1583_: type_24;
    var phi_1584_: type_24;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1607_: u32;
    var phi_1608_: u32;
    var phi_1620_: type_24;
    var phi_1621_: type_24;
    var phi_1637_: bool;
    var phi_1638_: bool;
    var phi_1642_: u32;
    var phi_1643_: u32;
    var phi_1649_: type_24;
    var phi_1650_: type_24;
    var phi_1651_: type_24;
    var phi_1652_: type_24;
    var phi_1653_: type_24;
    var phi_1672_: array<u32, 2>;
    var phi_1673_: array<u32, 2>;
    var phi_1685_: array<u32, 2>;
    var phi_1686_: array<u32, 2>;
    var phi_1703_: array<u32, 2>;
    var phi_1704_: array<u32, 2>;
    var phi_1716_: array<u32, 2>;
    var phi_1717_: array<u32, 2>;
    var phi_1734_: array<u32, 2>;
    var phi_1735_: array<u32, 2>;
    var phi_1747_: array<u32, 2>;
    var phi_1748_: array<u32, 2>;
    var phi_1765_: array<u32, 2>;
    var phi_1766_: array<u32, 2>;
    var phi_1778_: array<u32, 2>;
    var phi_1779_: array<u32, 2>;
    var phi_1812_: u32;
    var phi_1972_: type_12;
    var phi_1977_: type_12;
    var phi_2113_: type_12;
    var phi_2118_: type_12;
    var phi_2254_: type_12;
    var phi_2259_: type_12;
    var phi_2395_: type_12;
    var phi_2400_: type_12;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2464_: u32;
    var phi_2468_: u32;
    var phi_2525_: type_12;
    var phi_2526_: type_12;
    var phi_2549_: type_12;
    var phi_2605_: u32;
    var phi_2608_: type_12;
    var phi_2609_: type_12;
    var phi_2632_: type_12;
    var phi_2704_: type_12;
    var phi_2705_: type_12;
    var phi_2728_: type_12;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((_e55.y * _e56.x) + _e55.x);
    let _e71 = params.member.member_2;
    let _e74 = params.member.member_1.member_1;
    let _e76 = (_e74 % 2u);
    let _e79 = atomicLoad((&control.member[_e74]));
    if (_e71.member_3 < _e79) {
        phi_142_ = _e71.member_3;
    } else {
        phi_142_ = _e79;
    }
    let _e82 = phi_142_;
    let _e83 = (_e76 * _e71.member_3);
    let _e85 = ((1u - _e76) * _e71.member_3);
    let _e87 = params.member.member_1.member_3;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_159_ = type_12(0u, _e71.member_11);
    loop {
        let _e96 = phi_159_;
        if (_e96.member < _e96.member_1) {
            phi_160_ = type_12((_e96.member + 1u), _e96.member_1);
            phi_183_ = type_12(1u, _e96.member);
        } else {
            phi_160_ = _e96;
            phi_183_ = type_12(0u, type_12().member_1);
        }
        let _e108 = phi_160_;
        let _e110 = phi_183_;
        if (bitcast<i32>(_e110.member) != 0i) {
            if (_e57 == 0u) {
                let _e117 = atomicLoad((&shared_[0u]));
                if (128u < _e117) {
                    phi_201_ = 128u;
                } else {
                    phi_201_ = _e117;
                }
                let _e120 = phi_201_;
                if (_e71.member_9 > 0u) {
                    if (_e110.member_1 >= 16u) {
                        let _e126 = atomicLoad((&control.member[(1024u + _e74)]));
                        if (_e71.member_9 > 0u) {
                            phi_231_ = ((_e126 * 100u) >= (_e71.member_9 << bitcast<u32>((_e71.member_7 & 31u))));
                        } else {
                            phi_231_ = false;
                        }
                        let _e135 = phi_231_;
                        if _e135 {
                            phi_235_ = 2u;
                        } else {
                            phi_235_ = 0u;
                        }
                        let _e137 = phi_235_;
                        phi_236_ = _e137;
                    } else {
                        phi_236_ = 0u;
                    }
                    let _e139 = phi_236_;
                    phi_237_ = _e139;
                } else {
                    phi_237_ = 0u;
                }
                let _e141 = phi_237_;
                let _e142 = (128u - _e120);
                if (_e141 == 0u) {
                    if (_e142 > 0u) {
                        let _e146 = atomicLoad((&shared_[5u]));
                        if (_e71.member_6 == 0u) {
                            if (_e69 < _e82) {
                                phi_263_ = ((((_e82 - 1u) - _e69) >> bitcast<u32>((_e71.member_7 & 31u))) + 1u);
                            } else {
                                phi_263_ = 0u;
                            }
                            let _e189 = phi_263_;
                            let _e190 = (_e189 - _e146);
                            if (_e142 < _e190) {
                                phi_269_ = _e142;
                            } else {
                                phi_269_ = _e190;
                            }
                            let _e193 = phi_269_;
                            atomicStore((&shared_[3u]), (_e69 + (_e146 << bitcast<u32>((_e71.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e71.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e146 + _e193));
                            phi_323_ = _e193;
                        } else {
                            if (_e146 == 0u) {
                                let _e154 = (_e82 >> bitcast<u32>(((_e71.member_7 + 2u) & 31u)));
                                if (_e71.member_8 < _e154) {
                                    phi_291_ = _e154;
                                } else {
                                    phi_291_ = _e71.member_8;
                                }
                                let _e157 = phi_291_;
                                if (128u < _e157) {
                                    phi_296_ = 128u;
                                } else {
                                    phi_296_ = _e157;
                                }
                                let _e160 = phi_296_;
                                if (_e142 < _e160) {
                                    phi_301_ = _e142;
                                } else {
                                    phi_301_ = _e160;
                                }
                                let _e163 = phi_301_;
                                let _e166 = atomicAdd((&control.member[(512u + _e74)]), _e163);
                                if (_e82 < _e166) {
                                    phi_310_ = _e82;
                                } else {
                                    phi_310_ = _e166;
                                }
                                let _e169 = phi_310_;
                                let _e170 = (_e82 - _e169);
                                if (_e163 < _e170) {
                                    phi_316_ = _e163;
                                } else {
                                    phi_316_ = _e170;
                                }
                                let _e173 = phi_316_;
                                atomicStore((&shared_[3u]), _e166);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e173 < _e163)));
                                phi_322_ = _e173;
                            } else {
                                phi_322_ = 0u;
                            }
                            let _e180 = phi_322_;
                            phi_323_ = _e180;
                        }
                        let _e206 = phi_323_;
                        phi_324_ = _e206;
                    } else {
                        phi_324_ = 0u;
                    }
                    let _e208 = phi_324_;
                    phi_325_ = _e208;
                } else {
                    phi_325_ = 0u;
                }
                let _e210 = phi_325_;
                if (_e141 == 0u) {
                    if ((_e120 + _e210) == 0u) {
                        if (_e71.member_9 > 0u) {
                            let _e218 = atomicAdd((&control.member[(1024u + _e74)]), 1u);
                        }
                        phi_344_ = 1u;
                    } else {
                        phi_344_ = _e141;
                    }
                    let _e220 = phi_344_;
                    phi_345_ = _e220;
                } else {
                    phi_345_ = _e141;
                }
                let _e222 = phi_345_;
                atomicStore((&shared_[1u]), _e120);
                atomicStore((&shared_[2u]), _e210);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e222;
            }
            let _e230 = workgroupUniformLoad((&state[0u]));
            if (_e230 != 0u) {
                phi_2444_ = false;
            } else {
                let _e233 = atomicLoad((&shared_[1u]));
                let _e235 = atomicLoad((&shared_[2u]));
                if (_e57 < _e233) {
                    let _e258 = atomicLoad((&shared_[0u]));
                    let _e261 = (2u * ((_e258 - 1u) - _e57));
                    let _e263 = stack[_e261];
                    let _e266 = stack[(_e261 + 1u)];
                    phi_415_ = array<u32, 2>(_e263, _e266);
                } else {
                    if (_e57 < (_e233 + _e235)) {
                        let _e240 = atomicLoad((&shared_[3u]));
                        let _e243 = atomicLoad((&shared_[4u]));
                        let _e247 = (2u * (_e83 + (_e240 + ((_e57 - _e233) * _e243))));
                        let _e250 = atomicLoad((&nodes.member[(4u + _e247)]));
                        let _e253 = atomicLoad((&nodes.member[(_e247 + 5u)]));
                        phi_414_ = array<u32, 2>(_e250, _e253);
                    } else {
                        phi_414_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e256 = phi_414_;
                    phi_415_ = _e256;
                }
                let _e269 = phi_415_;
                let _e272 = params.member.member_2.member;
                let _e273 = (_e272 == 1u);
                let _e276 = params.member.member_2.member;
                if (_e276 == 0u) {
                    phi_429_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_429_ = array<u32, 2>(1u, 1u);
                }
                let _e279 = phi_429_;
                let _e285 = params.member.member.member[_e279[0]];
                let _e286 = (_e285 - 1u);
                let _e290 = params.member.member.member[_e279[1]];
                let _e291 = (_e290 - 1u);
                let _e294 = params.member.member_2.member_1;
                if (_e294 == 0u) {
                    phi_455_ = 1u;
                } else {
                    phi_455_ = 0u;
                }
                let _e297 = phi_455_;
                if (_e269[0] != 4294967295u) {
                    let _e303 = a_nodes.member[_e269[0]];
                    let _e305 = b_nodes.member[_e269[1]];
                    if _e273 {
                        if (_e269[0] == _e269[1]) {
                            if (_e303.member_3 == 4294967295u) {
                                phi_575_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            } else {
                                let _e311 = a_nodes.member[_e303.member_1];
                                let _e314 = a_nodes.member[_e303.member_3];
                                if !((_e311.member_3 == 4294967295u)) {
                                    phi_527_ = array<u32, 2>(_e303.member_1, _e303.member_1);
                                } else {
                                    phi_527_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e322 = phi_527_;
                                if ((((((_e311.member[0] <= _e314.member_2[0]) && (_e314.member[0] <= _e311.member_2[0])) && (_e311.member[1] <= _e314.member_2[1])) && (_e314.member[1] <= _e311.member_2[1])) && (_e311.member[2] <= _e314.member_2[2])) && (_e314.member[2] <= _e311.member_2[2])) {
                                    phi_563_ = array<u32, 2>(_e303.member_1, _e303.member_3);
                                } else {
                                    phi_563_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e354 = phi_563_;
                                if !((_e314.member_3 == 4294967295u)) {
                                    phi_573_ = array<u32, 2>(_e303.member_3, _e303.member_3);
                                } else {
                                    phi_573_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e362 = phi_573_;
                                phi_575_ = array<array<u32, 2>, 4>(_e322, _e354, _e362, array<u32, 2>(4294967295u, 4294967295u));
                            }
                            let _e365 = phi_575_;
                            phi_576_ = _e365;
                            phi_577_ = false;
                        } else {
                            phi_576_ = array<array<u32, 2>, 4>();
                            phi_577_ = true;
                        }
                        let _e367 = phi_576_;
                        let _e369 = phi_577_;
                        phi_578_ = _e367;
                        phi_579_ = _e369;
                    } else {
                        phi_578_ = array<array<u32, 2>, 4>();
                        phi_579_ = true;
                    }
                    let _e371 = phi_578_;
                    let _e373 = phi_579_;
                    if _e373 {
                        if (_e303.member_3 == 4294967295u) {
                            phi_591_ = false;
                        } else {
                            phi_591_ = !((_e305.member_3 == 4294967295u));
                        }
                        let _e380 = phi_591_;
                        if _e380 {
                            if (_e297 == 1u) {
                                phi_599_ = false;
                            } else {
                                phi_599_ = true;
                            }
                            let _e383 = phi_599_;
                            phi_600_ = _e383;
                        } else {
                            phi_600_ = true;
                        }
                        let _e385 = phi_600_;
                        if _e385 {
                            if (_e303.member_3 == 4294967295u) {
                                phi_612_ = false;
                            } else {
                                phi_612_ = !((_e305.member_3 == 4294967295u));
                            }
                            let _e392 = phi_612_;
                            if _e392 {
                                phi_617_ = (_e297 == 1u);
                            } else {
                                phi_617_ = false;
                            }
                            let _e395 = phi_617_;
                            if _e395 {
                                phi_660_ = bool();
                                phi_661_ = true;
                            } else {
                                let _e397 = (_e303.member_3 == 4294967295u);
                                if _e397 {
                                    phi_659_ = bool();
                                } else {
                                    if _e392 {
                                        phi_658_ = ((((_e305.member_2[0] - _e305.member[0]) * (_e305.member_2[1] - _e305.member[1])) * (_e305.member_2[2] - _e305.member[2])) > (((_e303.member_2[0] - _e303.member[0]) * (_e303.member_2[1] - _e303.member[1])) * (_e303.member_2[2] - _e303.member[2])));
                                    } else {
                                        phi_658_ = false;
                                    }
                                    let _e426 = phi_658_;
                                    phi_659_ = _e426;
                                }
                                let _e428 = phi_659_;
                                phi_660_ = _e428;
                                phi_661_ = _e397;
                            }
                            let _e430 = phi_660_;
                            let _e432 = phi_661_;
                            if _e432 {
                                phi_665_ = true;
                            } else {
                                phi_665_ = _e430;
                            }
                            let _e434 = phi_665_;
                            phi_667_ = !(_e434);
                        } else {
                            phi_667_ = true;
                        }
                        let _e437 = phi_667_;
                        if (_e303.member_3 == 4294967295u) {
                            phi_676_ = false;
                        } else {
                            phi_676_ = !((_e305.member_3 == 4294967295u));
                        }
                        let _e444 = phi_676_;
                        if _e444 {
                            phi_681_ = (_e297 == 1u);
                        } else {
                            phi_681_ = false;
                        }
                        let _e447 = phi_681_;
                        if _e447 {
                            phi_724_ = bool();
                            phi_725_ = true;
                        } else {
                            let _e449 = (_e303.member_3 == 4294967295u);
                            if _e449 {
                                phi_723_ = bool();
                            } else {
                                if _e444 {
                                    phi_722_ = ((((_e305.member_2[0] - _e305.member[0]) * (_e305.member_2[1] - _e305.member[1])) * (_e305.member_2[2] - _e305.member[2])) > (((_e303.member_2[0] - _e303.member[0]) * (_e303.member_2[1] - _e303.member[1])) * (_e303.member_2[2] - _e303.member[2])));
                                } else {
                                    phi_722_ = false;
                                }
                                let _e478 = phi_722_;
                                phi_723_ = _e478;
                            }
                            let _e480 = phi_723_;
                            phi_724_ = _e480;
                            phi_725_ = _e449;
                        }
                        let _e482 = phi_724_;
                        let _e484 = phi_725_;
                        if _e484 {
                            phi_729_ = true;
                        } else {
                            phi_729_ = _e482;
                        }
                        let _e486 = phi_729_;
                        if _e437 {
                            if (_e303.member_3 == 4294967295u) {
                                phi_739_ = false;
                            } else {
                                phi_739_ = true;
                            }
                            let _e490 = phi_739_;
                            phi_740_ = _e490;
                        } else {
                            phi_740_ = true;
                        }
                        let _e492 = phi_740_;
                        if _e492 {
                            if _e486 {
                                if (_e305.member_3 == 4294967295u) {
                                    phi_752_ = false;
                                } else {
                                    phi_752_ = true;
                                }
                                let _e496 = phi_752_;
                                phi_753_ = _e496;
                            } else {
                                phi_753_ = true;
                            }
                            let _e498 = phi_753_;
                            if _e498 {
                                if _e437 {
                                    if _e486 {
                                        let _e501 = a_nodes.member[_e303.member_1];
                                        let _e506 = a_nodes.member[_e303.member_3];
                                        let _e511 = b_nodes.member[_e305.member_1];
                                        let _e516 = b_nodes.member[_e305.member_3];
                                        if ((((((_e501.member[0] <= _e511.member_2[0]) && (_e511.member[0] <= _e501.member_2[0])) && (_e501.member[1] <= _e511.member_2[1])) && (_e511.member[1] <= _e501.member_2[1])) && (_e501.member[2] <= _e511.member_2[2])) && (_e511.member[2] <= _e501.member_2[2])) {
                                            phi_848_ = array<u32, 2>(_e303.member_1, _e305.member_1);
                                        } else {
                                            phi_848_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e546 = phi_848_;
                                        if ((((((_e501.member[0] <= _e516.member_2[0]) && (_e516.member[0] <= _e501.member_2[0])) && (_e501.member[1] <= _e516.member_2[1])) && (_e516.member[1] <= _e501.member_2[1])) && (_e501.member[2] <= _e516.member_2[2])) && (_e516.member[2] <= _e501.member_2[2])) {
                                            phi_878_ = array<u32, 2>(_e303.member_1, _e305.member_3);
                                        } else {
                                            phi_878_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e574 = phi_878_;
                                        if ((((((_e506.member[0] <= _e511.member_2[0]) && (_e511.member[0] <= _e506.member_2[0])) && (_e506.member[1] <= _e511.member_2[1])) && (_e511.member[1] <= _e506.member_2[1])) && (_e506.member[2] <= _e511.member_2[2])) && (_e511.member[2] <= _e506.member_2[2])) {
                                            phi_908_ = array<u32, 2>(_e303.member_3, _e305.member_1);
                                        } else {
                                            phi_908_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e602 = phi_908_;
                                        if ((((((_e506.member[0] <= _e516.member_2[0]) && (_e516.member[0] <= _e506.member_2[0])) && (_e506.member[1] <= _e516.member_2[1])) && (_e516.member[1] <= _e506.member_2[1])) && (_e506.member[2] <= _e516.member_2[2])) && (_e516.member[2] <= _e506.member_2[2])) {
                                            phi_938_ = array<u32, 2>(_e303.member_3, _e305.member_3);
                                        } else {
                                            phi_938_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e630 = phi_938_;
                                        phi_940_ = array<array<u32, 2>, 4>(_e546, _e574, _e602, _e630);
                                        phi_941_ = false;
                                    } else {
                                        phi_940_ = array<array<u32, 2>, 4>();
                                        phi_941_ = true;
                                    }
                                    let _e633 = phi_940_;
                                    let _e635 = phi_941_;
                                    phi_942_ = _e633;
                                    phi_943_ = _e635;
                                } else {
                                    phi_942_ = array<array<u32, 2>, 4>();
                                    phi_943_ = true;
                                }
                                let _e637 = phi_942_;
                                let _e639 = phi_943_;
                                if _e639 {
                                    if _e437 {
                                        let _e711 = a_nodes.member[_e303.member_1];
                                        let _e716 = a_nodes.member[_e303.member_3];
                                        if ((((((_e711.member[0] <= _e305.member_2[0]) && (_e305.member[0] <= _e711.member_2[0])) && (_e711.member[1] <= _e305.member_2[1])) && (_e305.member[1] <= _e711.member_2[1])) && (_e711.member[2] <= _e305.member_2[2])) && (_e305.member[2] <= _e711.member_2[2])) {
                                            phi_1009_ = array<u32, 2>(_e303.member_1, _e269[1]);
                                        } else {
                                            phi_1009_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e747 = phi_1009_;
                                        if ((((((_e716.member[0] <= _e305.member_2[0]) && (_e305.member[0] <= _e716.member_2[0])) && (_e716.member[1] <= _e305.member_2[1])) && (_e305.member[1] <= _e716.member_2[1])) && (_e716.member[2] <= _e305.member_2[2])) && (_e305.member[2] <= _e716.member_2[2])) {
                                            phi_1041_ = array<u32, 2>(_e303.member_3, _e269[1]);
                                        } else {
                                            phi_1041_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e776 = phi_1041_;
                                        phi_1136_ = array<array<u32, 2>, 4>(_e747, _e776, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    } else {
                                        let _e642 = b_nodes.member[_e305.member_1];
                                        let _e647 = b_nodes.member[_e305.member_3];
                                        if ((((((_e303.member[0] <= _e642.member_2[0]) && (_e642.member[0] <= _e303.member_2[0])) && (_e303.member[1] <= _e642.member_2[1])) && (_e642.member[1] <= _e303.member_2[1])) && (_e303.member[2] <= _e642.member_2[2])) && (_e642.member[2] <= _e303.member_2[2])) {
                                            phi_1102_ = array<u32, 2>(_e269[0], _e305.member_1);
                                        } else {
                                            phi_1102_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e678 = phi_1102_;
                                        if ((((((_e303.member[0] <= _e647.member_2[0]) && (_e647.member[0] <= _e303.member_2[0])) && (_e303.member[1] <= _e647.member_2[1])) && (_e647.member[1] <= _e303.member_2[1])) && (_e303.member[2] <= _e647.member_2[2])) && (_e647.member[2] <= _e303.member_2[2])) {
                                            phi_1134_ = array<u32, 2>(_e269[0], _e305.member_3);
                                        } else {
                                            phi_1134_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e707 = phi_1134_;
                                        phi_1136_ = array<array<u32, 2>, 4>(_e678, _e707, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    }
                                    let _e779 = phi_1136_;
                                    phi_1137_ = _e779;
                                } else {
                                    phi_1137_ = _e637;
                                }
                                let _e781 = phi_1137_;
                                phi_1138_ = _e781;
                                phi_1139_ = false;
                            } else {
                                phi_1138_ = array<array<u32, 2>, 4>();
                                phi_1139_ = true;
                            }
                            let _e783 = phi_1138_;
                            let _e785 = phi_1139_;
                            phi_1140_ = _e783;
                            phi_1141_ = _e785;
                        } else {
                            phi_1140_ = array<array<u32, 2>, 4>();
                            phi_1141_ = true;
                        }
                        let _e787 = phi_1140_;
                        let _e789 = phi_1141_;
                        phi_1145_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        phi_1146_ = _e787;
                        phi_1147_ = _e789;
                    } else {
                        phi_1145_ = _e371;
                        phi_1146_ = array<array<u32, 2>, 4>();
                        phi_1147_ = true;
                    }
                    let _e791 = phi_1145_;
                    let _e793 = phi_1146_;
                    let _e795 = phi_1147_;
                    if _e795 {
                        phi_1151_ = _e791;
                    } else {
                        phi_1151_ = _e793;
                    }
                    let _e797 = phi_1151_;
                    let _e800 = params.member.member_2.member_4;
                    if (_e800 > 0u) {
                        let _e805 = a_nodes.member[_e269[0]];
                        let _e807 = b_nodes.member[_e269[1]];
                        if _e273 {
                            if (_e269[0] == _e269[1]) {
                                if (_e805.member_3 == 4294967295u) {
                                    phi_1236_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e813 = a_nodes.member[_e805.member_1];
                                    if !((_e813.member_3 == 4294967295u)) {
                                        phi_1212_ = array<u32, 2>(_e805.member_1, _e805.member_1);
                                    } else {
                                        phi_1212_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e819 = phi_1212_;
                                    let _e825 = a_nodes.member[_e805.member_3];
                                    if !((_e825.member_3 == 4294967295u)) {
                                        phi_1234_ = array<u32, 2>(_e805.member_3, _e805.member_3);
                                    } else {
                                        phi_1234_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e831 = phi_1234_;
                                    phi_1236_ = array<array<u32, 2>, 4>(_e819, array<u32, 2>(_e805.member_1, _e805.member_3), _e831, array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e834 = phi_1236_;
                                phi_1237_ = _e834;
                                phi_1238_ = false;
                            } else {
                                phi_1237_ = array<array<u32, 2>, 4>();
                                phi_1238_ = true;
                            }
                            let _e836 = phi_1237_;
                            let _e838 = phi_1238_;
                            phi_1239_ = _e836;
                            phi_1240_ = _e838;
                        } else {
                            phi_1239_ = array<array<u32, 2>, 4>();
                            phi_1240_ = true;
                        }
                        let _e840 = phi_1239_;
                        let _e842 = phi_1240_;
                        if _e842 {
                            if (_e805.member_3 == 4294967295u) {
                                phi_1252_ = false;
                            } else {
                                phi_1252_ = !((_e807.member_3 == 4294967295u));
                            }
                            let _e849 = phi_1252_;
                            if _e849 {
                                if (_e297 == 1u) {
                                    phi_1260_ = false;
                                } else {
                                    phi_1260_ = true;
                                }
                                let _e852 = phi_1260_;
                                phi_1261_ = _e852;
                            } else {
                                phi_1261_ = true;
                            }
                            let _e854 = phi_1261_;
                            if _e854 {
                                if (_e805.member_3 == 4294967295u) {
                                    phi_1273_ = false;
                                } else {
                                    phi_1273_ = !((_e807.member_3 == 4294967295u));
                                }
                                let _e861 = phi_1273_;
                                if _e861 {
                                    phi_1278_ = (_e297 == 1u);
                                } else {
                                    phi_1278_ = false;
                                }
                                let _e864 = phi_1278_;
                                if _e864 {
                                    phi_1321_ = bool();
                                    phi_1322_ = true;
                                } else {
                                    let _e866 = (_e805.member_3 == 4294967295u);
                                    if _e866 {
                                        phi_1320_ = bool();
                                    } else {
                                        if _e861 {
                                            phi_1319_ = ((((_e807.member_2[0] - _e807.member[0]) * (_e807.member_2[1] - _e807.member[1])) * (_e807.member_2[2] - _e807.member[2])) > (((_e805.member_2[0] - _e805.member[0]) * (_e805.member_2[1] - _e805.member[1])) * (_e805.member_2[2] - _e805.member[2])));
                                        } else {
                                            phi_1319_ = false;
                                        }
                                        let _e895 = phi_1319_;
                                        phi_1320_ = _e895;
                                    }
                                    let _e897 = phi_1320_;
                                    phi_1321_ = _e897;
                                    phi_1322_ = _e866;
                                }
                                let _e899 = phi_1321_;
                                let _e901 = phi_1322_;
                                if _e901 {
                                    phi_1326_ = true;
                                } else {
                                    phi_1326_ = _e899;
                                }
                                let _e903 = phi_1326_;
                                phi_1328_ = !(_e903);
                            } else {
                                phi_1328_ = true;
                            }
                            let _e906 = phi_1328_;
                            if (_e805.member_3 == 4294967295u) {
                                phi_1337_ = false;
                            } else {
                                phi_1337_ = !((_e807.member_3 == 4294967295u));
                            }
                            let _e913 = phi_1337_;
                            if _e913 {
                                phi_1342_ = (_e297 == 1u);
                            } else {
                                phi_1342_ = false;
                            }
                            let _e916 = phi_1342_;
                            if _e916 {
                                phi_1385_ = bool();
                                phi_1386_ = true;
                            } else {
                                let _e918 = (_e805.member_3 == 4294967295u);
                                if _e918 {
                                    phi_1384_ = bool();
                                } else {
                                    if _e913 {
                                        phi_1383_ = ((((_e807.member_2[0] - _e807.member[0]) * (_e807.member_2[1] - _e807.member[1])) * (_e807.member_2[2] - _e807.member[2])) > (((_e805.member_2[0] - _e805.member[0]) * (_e805.member_2[1] - _e805.member[1])) * (_e805.member_2[2] - _e805.member[2])));
                                    } else {
                                        phi_1383_ = false;
                                    }
                                    let _e947 = phi_1383_;
                                    phi_1384_ = _e947;
                                }
                                let _e949 = phi_1384_;
                                phi_1385_ = _e949;
                                phi_1386_ = _e918;
                            }
                            let _e951 = phi_1385_;
                            let _e953 = phi_1386_;
                            if _e953 {
                                phi_1390_ = true;
                            } else {
                                phi_1390_ = _e951;
                            }
                            let _e955 = phi_1390_;
                            if _e906 {
                                if (_e805.member_3 == 4294967295u) {
                                    phi_1400_ = false;
                                } else {
                                    phi_1400_ = true;
                                }
                                let _e959 = phi_1400_;
                                phi_1401_ = _e959;
                            } else {
                                phi_1401_ = true;
                            }
                            let _e961 = phi_1401_;
                            if _e961 {
                                if _e955 {
                                    if (_e807.member_3 == 4294967295u) {
                                        phi_1413_ = false;
                                    } else {
                                        phi_1413_ = true;
                                    }
                                    let _e965 = phi_1413_;
                                    phi_1414_ = _e965;
                                } else {
                                    phi_1414_ = true;
                                }
                                let _e967 = phi_1414_;
                                if _e967 {
                                    if _e906 {
                                        if _e955 {
                                            phi_1437_ = array<array<u32, 2>, 4>(array<u32, 2>(_e805.member_1, _e807.member_1), array<u32, 2>(_e805.member_1, _e807.member_3), array<u32, 2>(_e805.member_3, _e807.member_1), array<u32, 2>(_e805.member_3, _e807.member_3));
                                            phi_1438_ = false;
                                        } else {
                                            phi_1437_ = array<array<u32, 2>, 4>();
                                            phi_1438_ = true;
                                        }
                                        let _e982 = phi_1437_;
                                        let _e984 = phi_1438_;
                                        phi_1439_ = _e982;
                                        phi_1440_ = _e984;
                                    } else {
                                        phi_1439_ = array<array<u32, 2>, 4>();
                                        phi_1440_ = true;
                                    }
                                    let _e986 = phi_1439_;
                                    let _e988 = phi_1440_;
                                    if _e988 {
                                        if _e906 {
                                            phi_1457_ = array<array<u32, 2>, 4>(array<u32, 2>(_e805.member_1, _e269[1]), array<u32, 2>(_e805.member_3, _e269[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        } else {
                                            phi_1457_ = array<array<u32, 2>, 4>(array<u32, 2>(_e269[0], _e807.member_1), array<u32, 2>(_e269[0], _e807.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        }
                                        let _e1000 = phi_1457_;
                                        phi_1458_ = _e1000;
                                    } else {
                                        phi_1458_ = _e986;
                                    }
                                    let _e1002 = phi_1458_;
                                    phi_1459_ = _e1002;
                                    phi_1460_ = false;
                                } else {
                                    phi_1459_ = array<array<u32, 2>, 4>();
                                    phi_1460_ = true;
                                }
                                let _e1004 = phi_1459_;
                                let _e1006 = phi_1460_;
                                phi_1461_ = _e1004;
                                phi_1462_ = _e1006;
                            } else {
                                phi_1461_ = array<array<u32, 2>, 4>();
                                phi_1462_ = true;
                            }
                            let _e1008 = phi_1461_;
                            let _e1010 = phi_1462_;
                            phi_1466_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            phi_1467_ = _e1008;
                            phi_1468_ = _e1010;
                        } else {
                            phi_1466_ = _e840;
                            phi_1467_ = array<array<u32, 2>, 4>();
                            phi_1468_ = true;
                        }
                        let _e1012 = phi_1466_;
                        let _e1014 = phi_1467_;
                        let _e1016 = phi_1468_;
                        if _e1016 {
                            phi_1472_ = _e1012;
                        } else {
                            phi_1472_ = _e1014;
                        }
                        let _e1018 = phi_1472_;
                        phi_1473_ = _e1018;
                    } else {
                        phi_1473_ = _e797;
                    }
                    let _e1020 = phi_1473_;
                    if (_e797[0][0] == 4294967295u) {
                        phi_1497_ = 0u;
                    } else {
                        if (_e797[0][0] >= _e286) {
                            if (_e797[0][1] >= _e291) {
                                phi_1491_ = false;
                            } else {
                                phi_1491_ = true;
                            }
                            let _e1030 = phi_1491_;
                            phi_1492_ = _e1030;
                        } else {
                            phi_1492_ = true;
                        }
                        let _e1032 = phi_1492_;
                        if _e1032 {
                            phi_1496_ = 1u;
                        } else {
                            phi_1496_ = 2u;
                        }
                        let _e1034 = phi_1496_;
                        phi_1497_ = _e1034;
                    }
                    let _e1036 = phi_1497_;
                    let _e1037 = type_24(_e797[0], _e1036);
                    if (_e1036 == 0u) {
                        if (_e1020[0][0] != 4294967295u) {
                            phi_1509_ = type_24(_e1020[0], 3u);
                        } else {
                            phi_1509_ = _e1037;
                        }
                        let _e1043 = phi_1509_;
                        phi_1510_ = _e1043;
                    } else {
                        phi_1510_ = _e1037;
                    }
                    let _e1045 = phi_1510_;
                    if (_e797[1][0] == 4294967295u) {
                        phi_1534_ = 0u;
                    } else {
                        if (_e797[1][0] >= _e286) {
                            if (_e797[1][1] >= _e291) {
                                phi_1528_ = false;
                            } else {
                                phi_1528_ = true;
                            }
                            let _e1055 = phi_1528_;
                            phi_1529_ = _e1055;
                        } else {
                            phi_1529_ = true;
                        }
                        let _e1057 = phi_1529_;
                        if _e1057 {
                            phi_1533_ = 1u;
                        } else {
                            phi_1533_ = 2u;
                        }
                        let _e1059 = phi_1533_;
                        phi_1534_ = _e1059;
                    }
                    let _e1061 = phi_1534_;
                    let _e1062 = type_24(_e797[1], _e1061);
                    if (_e1061 == 0u) {
                        if (_e1020[1][0] != 4294967295u) {
                            phi_1546_ = type_24(_e1020[1], 3u);
                        } else {
                            phi_1546_ = _e1062;
                        }
                        let _e1068 = phi_1546_;
                        phi_1547_ = _e1068;
                    } else {
                        phi_1547_ = _e1062;
                    }
                    let _e1070 = phi_1547_;
                    if (_e797[2][0] == 4294967295u) {
                        phi_1571_ = 0u;
                    } else {
                        if (_e797[2][0] >= _e286) {
                            if (_e797[2][1] >= _e291) {
                                phi_1565_ = false;
                            } else {
                                phi_1565_ = true;
                            }
                            let _e1080 = phi_1565_;
                            phi_1566_ = _e1080;
                        } else {
                            phi_1566_ = true;
                        }
                        let _e1082 = phi_1566_;
                        if _e1082 {
                            phi_1570_ = 1u;
                        } else {
                            phi_1570_ = 2u;
                        }
                        let _e1084 = phi_1570_;
                        phi_1571_ = _e1084;
                    }
                    let _e1086 = phi_1571_;
                    let _e1087 = type_24(_e797[2], _e1086);
                    if (_e1086 == 0u) {
                        if (_e1020[2][0] != 4294967295u) {
                            phi_1583_ = type_24(_e1020[2], 3u);
                        } else {
                            phi_1583_ = _e1087;
                        }
                        let _e1093 = phi_1583_;
                        phi_1584_ = _e1093;
                    } else {
                        phi_1584_ = _e1087;
                    }
                    let _e1095 = phi_1584_;
                    if (_e797[3][0] == 4294967295u) {
                        phi_1608_ = 0u;
                    } else {
                        if (_e797[3][0] >= _e286) {
                            if (_e797[3][1] >= _e291) {
                                phi_1602_ = false;
                            } else {
                                phi_1602_ = true;
                            }
                            let _e1105 = phi_1602_;
                            phi_1603_ = _e1105;
                        } else {
                            phi_1603_ = true;
                        }
                        let _e1107 = phi_1603_;
                        if _e1107 {
                            phi_1607_ = 1u;
                        } else {
                            phi_1607_ = 2u;
                        }
                        let _e1109 = phi_1607_;
                        phi_1608_ = _e1109;
                    }
                    let _e1111 = phi_1608_;
                    let _e1112 = type_24(_e797[3], _e1111);
                    if (_e1111 == 0u) {
                        if (_e1020[3][0] != 4294967295u) {
                            phi_1620_ = type_24(_e1020[3], 3u);
                        } else {
                            phi_1620_ = _e1112;
                        }
                        let _e1118 = phi_1620_;
                        phi_1621_ = _e1118;
                    } else {
                        phi_1621_ = _e1112;
                    }
                    let _e1120 = phi_1621_;
                    if (_e269[0] == 4294967295u) {
                        phi_1643_ = 0u;
                    } else {
                        if (_e269[0] >= _e286) {
                            if (_e269[1] >= _e291) {
                                phi_1637_ = false;
                            } else {
                                phi_1637_ = true;
                            }
                            let _e1128 = phi_1637_;
                            phi_1638_ = _e1128;
                        } else {
                            phi_1638_ = true;
                        }
                        let _e1130 = phi_1638_;
                        if _e1130 {
                            phi_1642_ = 1u;
                        } else {
                            phi_1642_ = 2u;
                        }
                        let _e1132 = phi_1642_;
                        phi_1643_ = _e1132;
                    }
                    let _e1134 = phi_1643_;
                    if (_e1134 == 2u) {
                        phi_1649_ = type_24(_e269, 2u);
                    } else {
                        phi_1649_ = _e1045;
                    }
                    let _e1138 = phi_1649_;
                    phi_1650_ = _e1138;
                    phi_1651_ = _e1120;
                    phi_1652_ = _e1095;
                    phi_1653_ = _e1070;
                } else {
                    phi_1650_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1651_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1652_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1653_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e1140 = phi_1650_;
                let _e1142 = phi_1651_;
                let _e1144 = phi_1652_;
                let _e1146 = phi_1653_;
                if (_e1140.member_1 == 1u) {
                    let _e1157 = atomicAdd((&shared_[6u]), 1u);
                    phi_1673_ = array<u32, 2>(_e1157, 0u);
                } else {
                    if (_e1140.member_1 == 2u) {
                        let _e1152 = atomicAdd((&shared_[7u]), 1u);
                        phi_1672_ = array<u32, 2>(_e1152, 0u);
                    } else {
                        phi_1672_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1155 = phi_1672_;
                    phi_1673_ = _e1155;
                }
                let _e1160 = phi_1673_;
                if (_e1140.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1164 = atomicAdd((&shared_[8u]), 1u);
                        phi_1685_ = array<u32, 2>(_e1160[0], _e1164);
                    } else {
                        phi_1685_ = _e1160;
                    }
                    let _e1168 = phi_1685_;
                    phi_1686_ = _e1168;
                } else {
                    phi_1686_ = _e1160;
                }
                let _e1170 = phi_1686_;
                if (_e1146.member_1 == 1u) {
                    let _e1180 = atomicAdd((&shared_[6u]), 1u);
                    phi_1704_ = array<u32, 2>(_e1180, 0u);
                } else {
                    if (_e1146.member_1 == 2u) {
                        let _e1175 = atomicAdd((&shared_[7u]), 1u);
                        phi_1703_ = array<u32, 2>(_e1175, 0u);
                    } else {
                        phi_1703_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1178 = phi_1703_;
                    phi_1704_ = _e1178;
                }
                let _e1183 = phi_1704_;
                if (_e1146.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1187 = atomicAdd((&shared_[8u]), 1u);
                        phi_1716_ = array<u32, 2>(_e1183[0], _e1187);
                    } else {
                        phi_1716_ = _e1183;
                    }
                    let _e1191 = phi_1716_;
                    phi_1717_ = _e1191;
                } else {
                    phi_1717_ = _e1183;
                }
                let _e1193 = phi_1717_;
                if (_e1144.member_1 == 1u) {
                    let _e1203 = atomicAdd((&shared_[6u]), 1u);
                    phi_1735_ = array<u32, 2>(_e1203, 0u);
                } else {
                    if (_e1144.member_1 == 2u) {
                        let _e1198 = atomicAdd((&shared_[7u]), 1u);
                        phi_1734_ = array<u32, 2>(_e1198, 0u);
                    } else {
                        phi_1734_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1201 = phi_1734_;
                    phi_1735_ = _e1201;
                }
                let _e1206 = phi_1735_;
                if (_e1144.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1210 = atomicAdd((&shared_[8u]), 1u);
                        phi_1747_ = array<u32, 2>(_e1206[0], _e1210);
                    } else {
                        phi_1747_ = _e1206;
                    }
                    let _e1214 = phi_1747_;
                    phi_1748_ = _e1214;
                } else {
                    phi_1748_ = _e1206;
                }
                let _e1216 = phi_1748_;
                if (_e1142.member_1 == 1u) {
                    let _e1226 = atomicAdd((&shared_[6u]), 1u);
                    phi_1766_ = array<u32, 2>(_e1226, 0u);
                } else {
                    if (_e1142.member_1 == 2u) {
                        let _e1221 = atomicAdd((&shared_[7u]), 1u);
                        phi_1765_ = array<u32, 2>(_e1221, 0u);
                    } else {
                        phi_1765_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1224 = phi_1765_;
                    phi_1766_ = _e1224;
                }
                let _e1229 = phi_1766_;
                if (_e1142.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1233 = atomicAdd((&shared_[8u]), 1u);
                        phi_1778_ = array<u32, 2>(_e1229[0], _e1233);
                    } else {
                        phi_1778_ = _e1229;
                    }
                    let _e1237 = phi_1778_;
                    phi_1779_ = _e1237;
                } else {
                    phi_1779_ = _e1229;
                }
                let _e1239 = phi_1779_;
                workgroupBarrier();
                if (_e57 == 0u) {
                    let _e1242 = atomicLoad((&shared_[6u]));
                    let _e1244 = atomicLoad((&shared_[7u]));
                    let _e1246 = atomicLoad((&shared_[8u]));
                    let _e1248 = atomicLoad((&shared_[1u]));
                    let _e1250 = atomicLoad((&shared_[2u]));
                    let _e1252 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1252 + 1u));
                    let _e1256 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1256 + _e1248) + _e1250));
                    let _e1261 = atomicLoad((&shared_[0u]));
                    let _e1262 = (_e1261 - _e1248);
                    let _e1264 = (_e71.member_10 - _e1262);
                    if (_e1264 < _e1242) {
                        phi_1812_ = _e1264;
                    } else {
                        phi_1812_ = _e1242;
                    }
                    let _e1267 = phi_1812_;
                    atomicStore((&shared_[9u]), _e1262);
                    atomicStore((&shared_[10u]), _e1267);
                    atomicStore((&shared_[0u]), (_e1262 + _e1267));
                    if (_e1242 > _e1267) {
                        let _e1273 = (_e1242 - _e1267);
                        if (_e71.member_12 == 0u) {
                        } else {
                            let _e1277 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1280 = atomicAdd((&control.member[(_e74 + 1u)]), _e1273);
                        let _e1283 = atomicMax((&nodes.member[0u]), (_e1280 + _e1273));
                        if ((_e1280 + _e1273) < _e1280) {
                            let _e1287 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1280);
                    }
                    if (_e1244 > 0u) {
                        let _e1291 = atomicAdd((&pairs.member[0u]), _e1244);
                        if ((_e1291 + _e1244) < _e1291) {
                            let _e1295 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1291);
                    }
                    if (_e1246 > 0u) {
                        let _e1299 = atomicAdd((&control.member[1537u]), _e1246);
                        if ((_e1299 + _e1246) < _e1299) {
                            let _e1303 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1299);
                    }
                }
                workgroupBarrier();
                if (_e1140.member_1 == 1u) {
                    let _e1361 = atomicLoad((&shared_[10u]));
                    if (_e1170[0] < _e1361) {
                        let _e1381 = atomicLoad((&shared_[9u]));
                        let _e1384 = (2u * (_e1381 + _e1170[0]));
                        stack[_e1384] = _e1140.member[0];
                        stack[(_e1384 + 1u)] = _e1140.member[1];
                    } else {
                        let _e1365 = atomicLoad((&shared_[11u]));
                        let _e1368 = ((_e1365 + _e1170[0]) - _e1361);
                        if (_e1368 < _e71.member_3) {
                            let _e1371 = (_e85 + _e1368);
                            if (_e1371 < 4294967295u) {
                                let _e1375 = (2u * _e1371);
                                atomicStore((&nodes.member[(4u + _e1375)]), _e1140.member[0]);
                                atomicStore((&nodes.member[(_e1375 + 5u)]), _e1140.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1140.member_1 == 0u) {
                    } else {
                        if (_e1140.member_1 == 2u) {
                            let _e1314 = a_nodes.member[_e1140.member[0]];
                            let _e1318 = b_nodes.member[_e1140.member[1]];
                            if (_e71.member == 1u) {
                                if (_e1314.member_1 < _e1318.member_1) {
                                    phi_1972_ = type_12(_e1314.member_1, _e1318.member_1);
                                } else {
                                    phi_1972_ = type_12(_e1318.member_1, _e1314.member_1);
                                }
                                let _e1327 = phi_1972_;
                                phi_1977_ = _e1327;
                            } else {
                                phi_1977_ = type_12(_e1314.member_1, _e1318.member_1);
                            }
                            let _e1329 = phi_1977_;
                            let _e1333 = atomicLoad((&shared_[12u]));
                            let _e1335 = (_e1333 + _e1170[0]);
                            if (_e1335 < _e87) {
                                let _e1337 = (2u * _e1335);
                                atomicStore((&pairs.member[(4u + _e1337)]), _e1329.member);
                                atomicStore((&pairs.member[(_e1337 + 5u)]), _e1329.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1345 = atomicLoad((&shared_[13u]));
                            let _e1347 = (_e1345 + _e1170[1]);
                            if (_e1347 < _e71.member_4) {
                                let _e1354 = (2u * ((_e71.member_5 * _e71.member_4) + _e1347));
                                front.member[_e1354] = _e1140.member[0];
                                front.member[(_e1354 + 1u)] = _e1140.member[1];
                            }
                        }
                    }
                }
                if (_e1146.member_1 == 1u) {
                    let _e1446 = atomicLoad((&shared_[10u]));
                    if (_e1193[0] < _e1446) {
                        let _e1466 = atomicLoad((&shared_[9u]));
                        let _e1469 = (2u * (_e1466 + _e1193[0]));
                        stack[_e1469] = _e1146.member[0];
                        stack[(_e1469 + 1u)] = _e1146.member[1];
                    } else {
                        let _e1450 = atomicLoad((&shared_[11u]));
                        let _e1453 = ((_e1450 + _e1193[0]) - _e1446);
                        if (_e1453 < _e71.member_3) {
                            let _e1456 = (_e85 + _e1453);
                            if (_e1456 < 4294967295u) {
                                let _e1460 = (2u * _e1456);
                                atomicStore((&nodes.member[(4u + _e1460)]), _e1146.member[0]);
                                atomicStore((&nodes.member[(_e1460 + 5u)]), _e1146.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1146.member_1 == 0u) {
                    } else {
                        if (_e1146.member_1 == 2u) {
                            let _e1399 = a_nodes.member[_e1146.member[0]];
                            let _e1403 = b_nodes.member[_e1146.member[1]];
                            if (_e71.member == 1u) {
                                if (_e1399.member_1 < _e1403.member_1) {
                                    phi_2113_ = type_12(_e1399.member_1, _e1403.member_1);
                                } else {
                                    phi_2113_ = type_12(_e1403.member_1, _e1399.member_1);
                                }
                                let _e1412 = phi_2113_;
                                phi_2118_ = _e1412;
                            } else {
                                phi_2118_ = type_12(_e1399.member_1, _e1403.member_1);
                            }
                            let _e1414 = phi_2118_;
                            let _e1418 = atomicLoad((&shared_[12u]));
                            let _e1420 = (_e1418 + _e1193[0]);
                            if (_e1420 < _e87) {
                                let _e1422 = (2u * _e1420);
                                atomicStore((&pairs.member[(4u + _e1422)]), _e1414.member);
                                atomicStore((&pairs.member[(_e1422 + 5u)]), _e1414.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1430 = atomicLoad((&shared_[13u]));
                            let _e1432 = (_e1430 + _e1193[1]);
                            if (_e1432 < _e71.member_4) {
                                let _e1439 = (2u * ((_e71.member_5 * _e71.member_4) + _e1432));
                                front.member[_e1439] = _e1146.member[0];
                                front.member[(_e1439 + 1u)] = _e1146.member[1];
                            }
                        }
                    }
                }
                if (_e1144.member_1 == 1u) {
                    let _e1531 = atomicLoad((&shared_[10u]));
                    if (_e1216[0] < _e1531) {
                        let _e1551 = atomicLoad((&shared_[9u]));
                        let _e1554 = (2u * (_e1551 + _e1216[0]));
                        stack[_e1554] = _e1144.member[0];
                        stack[(_e1554 + 1u)] = _e1144.member[1];
                    } else {
                        let _e1535 = atomicLoad((&shared_[11u]));
                        let _e1538 = ((_e1535 + _e1216[0]) - _e1531);
                        if (_e1538 < _e71.member_3) {
                            let _e1541 = (_e85 + _e1538);
                            if (_e1541 < 4294967295u) {
                                let _e1545 = (2u * _e1541);
                                atomicStore((&nodes.member[(4u + _e1545)]), _e1144.member[0]);
                                atomicStore((&nodes.member[(_e1545 + 5u)]), _e1144.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1144.member_1 == 0u) {
                    } else {
                        if (_e1144.member_1 == 2u) {
                            let _e1484 = a_nodes.member[_e1144.member[0]];
                            let _e1488 = b_nodes.member[_e1144.member[1]];
                            if (_e71.member == 1u) {
                                if (_e1484.member_1 < _e1488.member_1) {
                                    phi_2254_ = type_12(_e1484.member_1, _e1488.member_1);
                                } else {
                                    phi_2254_ = type_12(_e1488.member_1, _e1484.member_1);
                                }
                                let _e1497 = phi_2254_;
                                phi_2259_ = _e1497;
                            } else {
                                phi_2259_ = type_12(_e1484.member_1, _e1488.member_1);
                            }
                            let _e1499 = phi_2259_;
                            let _e1503 = atomicLoad((&shared_[12u]));
                            let _e1505 = (_e1503 + _e1216[0]);
                            if (_e1505 < _e87) {
                                let _e1507 = (2u * _e1505);
                                atomicStore((&pairs.member[(4u + _e1507)]), _e1499.member);
                                atomicStore((&pairs.member[(_e1507 + 5u)]), _e1499.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1515 = atomicLoad((&shared_[13u]));
                            let _e1517 = (_e1515 + _e1216[1]);
                            if (_e1517 < _e71.member_4) {
                                let _e1524 = (2u * ((_e71.member_5 * _e71.member_4) + _e1517));
                                front.member[_e1524] = _e1144.member[0];
                                front.member[(_e1524 + 1u)] = _e1144.member[1];
                            }
                        }
                    }
                }
                if (_e1142.member_1 == 1u) {
                    let _e1616 = atomicLoad((&shared_[10u]));
                    if (_e1239[0] < _e1616) {
                        let _e1636 = atomicLoad((&shared_[9u]));
                        let _e1639 = (2u * (_e1636 + _e1239[0]));
                        stack[_e1639] = _e1142.member[0];
                        stack[(_e1639 + 1u)] = _e1142.member[1];
                    } else {
                        let _e1620 = atomicLoad((&shared_[11u]));
                        let _e1623 = ((_e1620 + _e1239[0]) - _e1616);
                        if (_e1623 < _e71.member_3) {
                            let _e1626 = (_e85 + _e1623);
                            if (_e1626 < 4294967295u) {
                                let _e1630 = (2u * _e1626);
                                atomicStore((&nodes.member[(4u + _e1630)]), _e1142.member[0]);
                                atomicStore((&nodes.member[(_e1630 + 5u)]), _e1142.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e1142.member_1 == 0u) {
                    } else {
                        if (_e1142.member_1 == 2u) {
                            let _e1569 = a_nodes.member[_e1142.member[0]];
                            let _e1573 = b_nodes.member[_e1142.member[1]];
                            if (_e71.member == 1u) {
                                if (_e1569.member_1 < _e1573.member_1) {
                                    phi_2395_ = type_12(_e1569.member_1, _e1573.member_1);
                                } else {
                                    phi_2395_ = type_12(_e1573.member_1, _e1569.member_1);
                                }
                                let _e1582 = phi_2395_;
                                phi_2400_ = _e1582;
                            } else {
                                phi_2400_ = type_12(_e1569.member_1, _e1573.member_1);
                            }
                            let _e1584 = phi_2400_;
                            let _e1588 = atomicLoad((&shared_[12u]));
                            let _e1590 = (_e1588 + _e1239[0]);
                            if (_e1590 < _e87) {
                                let _e1592 = (2u * _e1590);
                                atomicStore((&pairs.member[(4u + _e1592)]), _e1584.member);
                                atomicStore((&pairs.member[(_e1592 + 5u)]), _e1584.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1600 = atomicLoad((&shared_[13u]));
                            let _e1602 = (_e1600 + _e1239[1]);
                            if (_e1602 < _e71.member_4) {
                                let _e1609 = (2u * ((_e71.member_5 * _e71.member_4) + _e1602));
                                front.member[_e1609] = _e1142.member[0];
                                front.member[(_e1609 + 1u)] = _e1142.member[1];
                            }
                        }
                    }
                }
                phi_2444_ = true;
            }
            let _e1646 = phi_2444_;
            phi_2445_ = _e1646;
        } else {
            phi_2445_ = false;
        }
        let _e1648 = phi_2445_;
        continue;
        continuing {
            phi_159_ = _e108;
            break if !(_e1648);
        }
    }
    if (_e57 == 0u) {
        if (_e71.member_6 == 0u) {
            if (_e69 < _e82) {
                phi_2464_ = ((((_e82 - 1u) - _e69) >> bitcast<u32>((_e71.member_7 & 31u))) + 1u);
            } else {
                phi_2464_ = 0u;
            }
            let _e1661 = phi_2464_;
            let _e1663 = atomicLoad((&shared_[5u]));
            phi_2468_ = (_e1661 - _e1663);
        } else {
            phi_2468_ = 0u;
        }
        let _e1666 = phi_2468_;
        atomicStore((&shared_[14u]), _e1666);
        let _e1669 = atomicLoad((&shared_[0u]));
        let _e1670 = (_e1669 + _e1666);
        if (_e1670 > 0u) {
            if (_e71.member_12 == 0u) {
            } else {
                let _e1675 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e1678 = atomicAdd((&control.member[(_e74 + 1u)]), _e1670);
            let _e1681 = atomicMax((&nodes.member[0u]), (_e1678 + _e1670));
            if ((_e1678 + _e1670) < _e1678) {
                let _e1685 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e1678);
        }
        let _e1690 = atomicLoad((&shared_[15u]));
        let _e1692 = atomicAdd((&control.member[(1540u + (2u * _e69))]), _e1690);
        let _e1696 = atomicLoad((&shared_[16u]));
        let _e1698 = atomicAdd((&control.member[((2u * _e69) + 1541u)]), _e1696);
    }
    workgroupBarrier();
    let _e1700 = atomicLoad((&shared_[0u]));
    let _e1702 = atomicLoad((&shared_[17u]));
    let _e1704 = atomicLoad((&shared_[14u]));
    phi_2525_ = type_12(0u, 8u);
    loop {
        let _e1706 = phi_2525_;
        if (_e1706.member < _e1706.member_1) {
            phi_2526_ = type_12((_e1706.member + 1u), _e1706.member_1);
            phi_2549_ = type_12(1u, _e1706.member);
        } else {
            phi_2526_ = _e1706;
            phi_2549_ = type_12(0u, type_12().member_1);
        }
        let _e1718 = phi_2526_;
        let _e1720 = phi_2549_;
        let _e1724 = (bitcast<i32>(_e1720.member) != 0i);
        if _e1724 {
            let _e1726 = ((_e1720.member_1 * 128u) + _e57);
            if (_e1726 < _e1700) {
                let _e1730 = stack[(2u * _e1726)];
                let _e1734 = stack[((2u * _e1726) + 1u)];
                let _e1735 = (_e1702 + _e1726);
                if (_e1735 < _e71.member_3) {
                    let _e1738 = (_e85 + _e1735);
                    if (_e1738 < 4294967295u) {
                        let _e1740 = (2u * _e1738);
                        atomicStore((&nodes.member[(4u + _e1740)]), _e1730);
                        atomicStore((&nodes.member[(_e1740 + 5u)]), _e1734);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2525_ = _e1718;
            break if !(_e1724);
        }
    }
    let _e1747 = atomicLoad((&shared_[5u]));
    let _e1748 = (_e1704 / 128u);
    if ((_e1704 % 128u) > 0u) {
        phi_2605_ = (_e1748 + 1u);
    } else {
        phi_2605_ = _e1748;
    }
    let _e1753 = phi_2605_;
    phi_2608_ = type_12(0u, _e1753);
    loop {
        let _e1756 = phi_2608_;
        if (_e1756.member < _e1756.member_1) {
            phi_2609_ = type_12((_e1756.member + 1u), _e1756.member_1);
            phi_2632_ = type_12(1u, _e1756.member);
        } else {
            phi_2609_ = _e1756;
            phi_2632_ = type_12(0u, type_12().member_1);
        }
        let _e1768 = phi_2609_;
        let _e1770 = phi_2632_;
        let _e1774 = (bitcast<i32>(_e1770.member) != 0i);
        if _e1774 {
            let _e1776 = ((_e1770.member_1 * 128u) + _e57);
            if (_e1776 < _e1704) {
                let _e1784 = (2u * ((_e83 + _e69) + ((_e1747 + _e1776) << bitcast<u32>((_e71.member_7 & 31u)))));
                let _e1787 = atomicLoad((&nodes.member[(4u + _e1784)]));
                let _e1790 = atomicLoad((&nodes.member[(_e1784 + 5u)]));
                let _e1792 = ((_e1702 + _e1700) + _e1776);
                if (_e1792 < _e71.member_3) {
                    let _e1795 = (_e85 + _e1792);
                    if (_e1795 < 4294967295u) {
                        let _e1797 = (2u * _e1795);
                        atomicStore((&nodes.member[(4u + _e1797)]), _e1787);
                        atomicStore((&nodes.member[(_e1797 + 5u)]), _e1790);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2608_ = _e1768;
            break if !(_e1774);
        }
    }
    if (_e71.member_6 == 1u) {
        if (_e1747 == 0u) {
            phi_2704_ = type_12(0u, _e82);
            loop {
                let _e1808 = phi_2704_;
                if (_e1808.member < _e1808.member_1) {
                    phi_2705_ = type_12((_e1808.member + 1u), _e1808.member_1);
                    phi_2728_ = type_12(1u, _e1808.member);
                } else {
                    phi_2705_ = _e1808;
                    phi_2728_ = type_12(0u, type_12().member_1);
                }
                let _e1820 = phi_2705_;
                let _e1822 = phi_2728_;
                if (bitcast<i32>(_e1822.member) != 0i) {
                    let _e1828 = atomicAdd((&control.member[(512u + _e74)]), 1u);
                    if (_e1828 >= _e82) {
                        phi_2808_ = false;
                    } else {
                        let _e1831 = (2u * (_e83 + _e1828));
                        let _e1834 = atomicLoad((&nodes.member[(4u + _e1831)]));
                        let _e1837 = atomicLoad((&nodes.member[(_e1831 + 5u)]));
                        if (_e71.member_12 == 0u) {
                        } else {
                            let _e1841 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1844 = atomicAdd((&control.member[(_e74 + 1u)]), 1u);
                        let _e1847 = atomicMax((&nodes.member[0u]), (_e1844 + 1u));
                        if ((_e1844 + 1u) < _e1844) {
                            let _e1851 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1844 < _e71.member_3) {
                            let _e1854 = (_e85 + _e1844);
                            if (_e1854 < 4294967295u) {
                                let _e1856 = (2u * _e1854);
                                atomicStore((&nodes.member[(4u + _e1856)]), _e1834);
                                atomicStore((&nodes.member[(_e1856 + 5u)]), _e1837);
                            }
                        }
                        phi_2808_ = true;
                    }
                    let _e1862 = phi_2808_;
                    phi_2809_ = _e1862;
                } else {
                    phi_2809_ = false;
                }
                let _e1864 = phi_2809_;
                continue;
                continuing {
                    phi_2704_ = _e1820;
                    break if !(_e1864);
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
