struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_11 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<type_6>,
}

struct type_21 {
    member: array<u32>,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_26 {
    member: array<type_23>,
}

struct type_35 {
    member: i32,
    member_1: i32,
}

struct type_36 {
    member: u32,
    member_1: i32,
}

struct type_37 {
    member: u32,
    member_1: u32,
}

struct type_56 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_63 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> sides: array<type_6, 64>;
var<workgroup> names: array<u32, 64>;
var<workgroup> hits: array<u32, 1024>;
@group(0) @binding(2) 
var<storage> leaves: type_26;
@group(0) @binding(3) 
var<storage> bodies: type_21;
@group(0) @binding(4) 
var<storage> keys: type_56;
@group(0) @binding(5) 
var<storage> input: type_21;
@group(0) @binding(6) 
var<storage, read_write> output: type_63;
var<workgroup> kept: array<u32, 1024>;

fn function_() {
    var local: array<array<u32, 2>, 6>;
    var local_1: array<array<u32, 2>, 6>;
    var local_2: array<array<u32, 2>, 6>;
    var local_3: array<array<u32, 2>, 6>;
    var local_4: array<array<u32, 2>, 6>;
    var local_5: array<array<u32, 2>, 6>;
    var local_6: array<array<u32, 2>, 6>;
    var local_7: array<array<u32, 2>, 6>;
    var local_8: type_23;
    var local_9: type_23;
    var phi_159_: array<u32, 2>;
    var phi_178_: u32;
    var phi_205_: u32;
    var phi_206_: u32;
    var phi_213_: u32;
    var phi_234_: u32;
    var phi_235_: u32;
    var phi_238_: type_37;
    var phi_239_: type_37;
    var phi_262_: type_37;
    var phi_314_: array<u32, 2>;
    var phi_322_: u32;
    var phi_323_: u32;
    var phi_328_: u32;
    var phi_329_: u32;
    var phi_447_: u32;
    var phi_478_: bool;
    var phi_483_: type_37;
    var phi_486_: u32;
    var phi_484_: type_37;
    var phi_509_: type_37;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_592_: u32;
    var phi_593_: bool;
    var phi_487_: u32;
    var phi_594_: bool;
    var phi_599_: type_35;
    var phi_602_: u32;
    var phi_623_: bool;
    var phi_629_: type_36;
    var phi_600_: type_35;
    var phi_643_: type_36;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_835_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_955_: type_37;
    var phi_958_: bool;
    var phi_956_: type_37;
    var phi_981_: type_37;
    var phi_1038_: type_37;
    var phi_1041_: array<u32, 2>;
    var phi_1039_: type_37;
    var phi_1064_: type_37;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1144_: array<u32, 2>;
    var phi_1042_: array<u32, 2>;
    var phi_1195_: type_37;
    var phi_1198_: array<u32, 2>;
    var phi_1196_: type_37;
    var phi_1221_: type_37;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1302_: array<u32, 2>;
    var phi_1199_: array<u32, 2>;
    var local_10: array<u32, 2>;
    var local_11: array<u32, 2>;
    var local_12: array<u32, 2>;
    var local_13: array<u32, 2>;
    var local_14: array<u32, 2>;
    var local_15: array<u32, 2>;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1370_: type_37;
    var phi_1373_: array<u32, 2>;
    var phi_1371_: type_37;
    var phi_1396_: type_37;
    var phi_1471_: bool;
    var phi_1472_: bool;
    var phi_1476_: array<u32, 2>;
    var phi_1374_: array<u32, 2>;
    var phi_1527_: type_37;
    var phi_1530_: array<u32, 2>;
    var phi_1528_: type_37;
    var phi_1553_: type_37;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1634_: array<u32, 2>;
    var phi_1531_: array<u32, 2>;
    var local_16: array<u32, 2>;
    var local_17: array<u32, 2>;
    var local_18: array<u32, 2>;
    var local_19: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_959_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1669_: bool;
    var phi_1677_: u32;
    var phi_1678_: bool;
    var phi_603_: u32;
    var phi_1679_: bool;
    var phi_1700_: type_35;
    var phi_1703_: u32;
    var phi_1724_: bool;
    var phi_1730_: type_36;
    var phi_1701_: type_35;
    var phi_1744_: type_36;
    var phi_1828_: type_37;
    var phi_1832_: type_37;
    var phi_1852_: u32;
    var phi_1853_: bool;
    var phi_1704_: u32;
    var phi_1854_: bool;
    var local_22: bool;

    let _e64 = id_1;
    let _e65 = n_1;
    let _e66 = lane_1;
    let _e78 = ((_e64.y * _e65.x) + _e64.x);
    let _e81 = (_e65.x * _e65.y);
    let _e83 = params.member.member_8;
    if (_e83 == 0u) {
        phi_159_ = array<u32, 2>(0u, 2u);
    } else {
        phi_159_ = array<u32, 2>(1u, 1u);
    }
    let _e86 = phi_159_;
    let _e90 = params.member.member_15;
    let _e92 = input.member[0u];
    if (_e90 < _e92) {
        phi_178_ = _e90;
    } else {
        phi_178_ = _e92;
    }
    let _e95 = phi_178_;
    let _e97 = params.member.member_12;
    if (_e95 > _e97) {
        let _e100 = params.member.member_12;
        let _e101 = (_e95 - _e100);
        let _e103 = params.member.member_13;
        if (_e103 == 0u) {
            return;
        }
        let _e105 = (_e101 / _e103);
        if (_e103 == 0u) {
            return;
        }
        if ((_e101 % _e103) > 0u) {
            phi_205_ = (_e105 + 1u);
        } else {
            phi_205_ = _e105;
        }
        let _e111 = phi_205_;
        phi_206_ = _e111;
    } else {
        phi_206_ = 0u;
    }
    let _e113 = phi_206_;
    let _e115 = params.member.member_14;
    if (_e115 < _e113) {
        phi_213_ = _e115;
    } else {
        phi_213_ = _e113;
    }
    let _e118 = phi_213_;
    if (_e118 > _e78) {
        let _e120 = (_e118 - _e78);
        if (_e81 == 0u) {
            return;
        }
        let _e122 = (_e120 / _e81);
        if (_e81 == 0u) {
            return;
        }
        if ((_e120 % _e81) > 0u) {
            phi_234_ = (_e122 + 1u);
        } else {
            phi_234_ = _e122;
        }
        let _e128 = phi_234_;
        phi_235_ = _e128;
    } else {
        phi_235_ = 0u;
    }
    let _e130 = phi_235_;
    phi_238_ = type_37(0u, _e130);
    loop {
        let _e133 = phi_238_;
        if (_e133.member < _e133.member_1) {
            phi_239_ = type_37((_e133.member + 1u), _e133.member_1);
            phi_262_ = type_37(1u, _e133.member);
        } else {
            phi_239_ = _e133;
            phi_262_ = type_37(0u, type_37().member_1);
        }
        let _e147 = phi_239_;
        let _e149 = phi_262_;
        let _e153 = (bitcast<i32>(_e149.member) != 0i);
        if _e153 {
            let _e155 = params.member.member_12;
            let _e159 = params.member.member_13;
            let _e162 = (2u * (_e155 + ((_e78 + (_e149.member_1 * _e81)) * _e159)));
            let _e165 = input.member[(4u + _e162)];
            let _e168 = input.member[(_e162 + 5u)];
            if (_e66 < 8u) {
                atomicStore((&counters[_e66]), 0u);
            }
            workgroupBarrier();
            let _e172 = params.member.member_8;
            if (_e172 == 0u) {
                phi_314_ = array<u32, 2>(0u, 2u);
            } else {
                phi_314_ = array<u32, 2>(1u, 1u);
            }
            let _e175 = phi_314_;
            let _e178 = (_e66 / 32u);
            if (_e178 == 0u) {
                phi_322_ = _e175[0];
                phi_323_ = _e165;
            } else {
                phi_322_ = _e175[1];
                phi_323_ = _e168;
            }
            let _e181 = phi_322_;
            let _e183 = phi_323_;
            if (_e178 == 0u) {
                phi_328_ = _e168;
                phi_329_ = _e175[1];
            } else {
                phi_328_ = _e165;
                phi_329_ = _e175[0];
            }
            let _e186 = phi_328_;
            let _e188 = phi_329_;
            let _e190 = params.member.member_9;
            let _e191 = (_e190 - 1u);
            if (_e191 < 8u) {
            } else {
                return;
            }
            if (_e181 < 4u) {
            } else {
                return;
            }
            let _e200 = params.member.member_18[_e191][_e181];
            let _e203 = nodes.member[(_e200 + ((_e183 * 32u) + (_e66 % 32u)))];
            let _e205 = params.member.member_9;
            if (_e205 < 8u) {
            } else {
                return;
            }
            if (_e188 < 4u) {
            } else {
                return;
            }
            let _e211 = params.member.member_18[_e205][_e188];
            let _e214 = nodes.member[(_e211 + _e186)];
            if ((((((_e203.member[0] <= _e214.member_1[0]) && (_e214.member[0] <= _e203.member_1[0])) && (_e203.member[1] <= _e214.member_1[1])) && (_e214.member[1] <= _e203.member_1[1])) && (_e203.member[2] <= _e214.member_1[2])) && (_e214.member[2] <= _e203.member_1[2])) {
                let _e252 = atomicAdd((&counters[_e178]), 1u);
                let _e253 = ((_e178 * 32u) + _e252);
                sides[_e253] = type_6(array<f32, 3>(_e203.member[0], _e203.member[1], _e203.member[2]), array<f32, 3>(_e203.member_1[0], _e203.member_1[1], _e203.member_1[2]));
                names[_e253] = (_e66 % 32u);
            }
            workgroupBarrier();
            let _e269 = atomicLoad((&counters[0u]));
            let _e271 = atomicLoad((&counters[1u]));
            if (_e269 <= 1u) {
                phi_447_ = 0u;
            } else {
                let _e273 = (_e269 - 1u);
                phi_447_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e273)), 32u, (_e273 == 0u)));
            }
            let _e281 = phi_447_;
            let _e286 = (_e66 & ((1u << bitcast<u32>((_e281 & 31u))) - 1u));
            if (_e286 < _e269) {
                let _e289 = sides[_e286];
                let _e299 = names[_e286];
                let _e301 = params.member.member_8;
                if (_e301 == 1u) {
                    phi_478_ = (_e165 == _e168);
                } else {
                    phi_478_ = false;
                }
                let _e305 = phi_478_;
                phi_483_ = type_37(0u, 32u);
                phi_486_ = (_e66 >> bitcast<u32>((_e281 & 31u)));
                loop {
                    let _e310 = phi_483_;
                    let _e312 = phi_486_;
                    if (_e310.member < _e310.member_1) {
                        phi_484_ = type_37((_e310.member + 1u), _e310.member_1);
                        phi_509_ = type_37(1u, _e310.member);
                    } else {
                        phi_484_ = _e310;
                        phi_509_ = type_37(0u, type_37().member_1);
                    }
                    let _e326 = phi_484_;
                    let _e328 = phi_509_;
                    if (bitcast<i32>(_e328.member) != 0i) {
                        if (_e312 >= _e271) {
                            phi_592_ = u32();
                            phi_593_ = false;
                        } else {
                            let _e335 = sides[(32u + _e312)];
                            if ((((((_e289.member[0] <= _e335.member_1[0]) && (_e335.member[0] <= _e289.member_1[0])) && (_e289.member[1] <= _e335.member_1[1])) && (_e335.member[1] <= _e289.member_1[1])) && (_e289.member[2] <= _e335.member_1[2])) && (_e335.member[2] <= _e289.member_1[2])) {
                                let _e357 = names[(32u + _e312)];
                                if _e305 {
                                    if (_e299 < _e357) {
                                        phi_579_ = true;
                                    } else {
                                        phi_579_ = false;
                                    }
                                    let _e360 = phi_579_;
                                    phi_580_ = _e360;
                                } else {
                                    phi_580_ = true;
                                }
                                let _e362 = phi_580_;
                                if _e362 {
                                    let _e364 = atomicAdd((&counters[2u]), 1u);
                                    hits[_e364] = ((_e299 << bitcast<u32>(5i)) | _e357);
                                }
                            }
                            phi_592_ = (_e312 + (64u >> bitcast<u32>((_e281 & 31u))));
                            phi_593_ = true;
                        }
                        let _e374 = phi_592_;
                        let _e376 = phi_593_;
                        phi_487_ = _e374;
                        phi_594_ = _e376;
                    } else {
                        phi_487_ = u32();
                        phi_594_ = false;
                    }
                    let _e378 = phi_487_;
                    let _e380 = phi_594_;
                    continue;
                    continuing {
                        phi_483_ = _e326;
                        phi_486_ = _e378;
                        break if !(_e380);
                    }
                }
            }
            workgroupBarrier();
            let _e383 = atomicLoad((&counters[2u]));
            phi_599_ = type_35(0i, 16i);
            phi_602_ = _e66;
            loop {
                let _e385 = phi_599_;
                let _e387 = phi_602_;
                if (_e385.member < _e385.member_1) {
                    let _e395 = (_e385.member + 1i);
                    if ((false == (_e395 > _e385.member)) != false) {
                        phi_623_ = true;
                    } else {
                        phi_623_ = false;
                    }
                    let _e400 = phi_623_;
                    if _e400 {
                        phi_629_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_629_ = type_36(1u, _e395);
                    }
                    let _e406 = phi_629_;
                    if (bitcast<i32>(_e406.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_600_ = type_35(_e406.member_1, _e385.member_1);
                    phi_643_ = type_36(1u, _e385.member);
                } else {
                    phi_600_ = _e385;
                    phi_643_ = type_36(0u, type_36().member_1);
                }
                let _e416 = phi_600_;
                let _e418 = phi_643_;
                if (bitcast<i32>(_e418.member) != 0i) {
                    if (_e387 >= _e383) {
                        phi_1677_ = u32();
                        phi_1678_ = false;
                    } else {
                        let _e424 = hits[_e387];
                        if (_e86[0] < 4u) {
                        } else {
                            return;
                        }
                        let _e434 = params.member.member_18[0u][_e86[0]];
                        let _e435 = (_e434 + ((_e165 * 32u) + (_e424 >> bitcast<u32>(5i))));
                        if (_e86[1] < 4u) {
                        } else {
                            return;
                        }
                        let _e442 = params.member.member_18[0u][_e86[1]];
                        let _e443 = (_e442 + ((_e168 * 32u) + (_e424 & 31u)));
                        let _e445 = leaves.member[_e435];
                        local_8 = type_23(array<u32, 3>(_e445.member[0], _e445.member[1], _e445.member[2]), _e445.member_1);
                        let _e454 = leaves.member[_e443];
                        local_9 = type_23(array<u32, 3>(_e454.member[0], _e454.member[1], _e454.member[2]), _e454.member_1);
                        let _e463 = nodes.member[_e435];
                        let _e465 = nodes.member[_e443];
                        let _e467 = params.member.member_1;
                        if ((_e467 & 1u) != 0u) {
                            let _e471 = params.member.member_8;
                            if (_e471 == 0u) {
                                let _e513 = local_8.member[0u];
                                let _e516 = local_9.member[0u];
                                if (_e513 == _e516) {
                                    phi_781_ = bool();
                                    phi_782_ = true;
                                } else {
                                    let _e520 = local_8.member[0u];
                                    let _e523 = local_9.member[1u];
                                    let _e524 = (_e520 == _e523);
                                    if _e524 {
                                        phi_780_ = bool();
                                    } else {
                                        let _e527 = local_8.member[0u];
                                        let _e530 = local_9.member[2u];
                                        phi_780_ = (_e527 == _e530);
                                    }
                                    let _e533 = phi_780_;
                                    phi_781_ = _e533;
                                    phi_782_ = _e524;
                                }
                                let _e535 = phi_781_;
                                let _e537 = phi_782_;
                                phi_823_ = _e535;
                                phi_824_ = _e537;
                            } else {
                                let _e475 = local_8.member[0u];
                                let _e478 = local_9.member[0u];
                                if (_e475 == _e478) {
                                    phi_818_ = bool();
                                    phi_819_ = true;
                                } else {
                                    let _e482 = local_8.member[0u];
                                    let _e485 = local_9.member[1u];
                                    if (_e482 == _e485) {
                                        phi_816_ = bool();
                                        phi_817_ = true;
                                    } else {
                                        let _e489 = local_8.member[1u];
                                        let _e492 = local_9.member[0u];
                                        let _e493 = (_e489 == _e492);
                                        if _e493 {
                                            phi_815_ = bool();
                                        } else {
                                            let _e496 = local_8.member[1u];
                                            let _e499 = local_9.member[1u];
                                            phi_815_ = (_e496 == _e499);
                                        }
                                        let _e502 = phi_815_;
                                        phi_816_ = _e502;
                                        phi_817_ = _e493;
                                    }
                                    let _e504 = phi_816_;
                                    let _e506 = phi_817_;
                                    phi_818_ = _e504;
                                    phi_819_ = _e506;
                                }
                                let _e508 = phi_818_;
                                let _e510 = phi_819_;
                                phi_823_ = _e508;
                                phi_824_ = _e510;
                            }
                            let _e539 = phi_823_;
                            let _e541 = phi_824_;
                            if _e541 {
                                phi_828_ = false;
                            } else {
                                phi_828_ = true;
                            }
                            let _e543 = phi_828_;
                            if _e543 {
                                phi_835_ = _e539;
                            } else {
                                phi_835_ = true;
                            }
                            let _e545 = phi_835_;
                            if _e545 {
                                phi_839_ = false;
                            } else {
                                phi_839_ = true;
                            }
                            let _e547 = phi_839_;
                            phi_840_ = _e547;
                        } else {
                            phi_840_ = true;
                        }
                        let _e549 = phi_840_;
                        if _e549 {
                            let _e551 = params.member.member_1;
                            if ((_e551 & 2u) != 0u) {
                                let _e556 = local_8.member[0u];
                                let _e558 = bodies.member[_e556];
                                let _e561 = local_9.member[0u];
                                let _e563 = bodies.member[_e561];
                                if ((_e558 / 2u) == (_e563 / 2u)) {
                                    let _e568 = params.member.member_1;
                                    if !(((_e568 & 4u) != 0u)) {
                                        phi_889_ = false;
                                    } else {
                                        phi_889_ = true;
                                    }
                                    let _e573 = phi_889_;
                                    phi_890_ = _e573;
                                } else {
                                    phi_890_ = true;
                                }
                                let _e575 = phi_890_;
                                if _e575 {
                                    if (((_e558 & _e563) & 1u) == 0u) {
                                        phi_900_ = false;
                                    } else {
                                        phi_900_ = true;
                                    }
                                    let _e580 = phi_900_;
                                    phi_901_ = _e580;
                                } else {
                                    phi_901_ = true;
                                }
                                let _e582 = phi_901_;
                                if _e582 {
                                    phi_905_ = false;
                                } else {
                                    phi_905_ = true;
                                }
                                let _e584 = phi_905_;
                                phi_906_ = _e584;
                            } else {
                                phi_906_ = true;
                            }
                            let _e586 = phi_906_;
                            if _e586 {
                                let _e588 = params.member.member_1;
                                if ((_e588 & 32u) != 0u) {
                                    let _e592 = params.member.member_6;
                                    let _e633 = (((((((_e463.member_1[0] - _e465.member[0]) > _e592) && ((_e465.member_1[0] - _e463.member[0]) > _e592)) && ((_e463.member_1[1] - _e465.member[1]) > _e592)) && ((_e465.member_1[1] - _e463.member[1]) > _e592)) && ((_e463.member_1[2] - _e465.member[2]) > _e592)) && ((_e465.member_1[2] - _e463.member[2]) > _e592));
                                    if _e633 {
                                        phi_1655_ = bool();
                                    } else {
                                        phi_955_ = type_37(0u, 3u);
                                        phi_958_ = true;
                                        loop {
                                            let _e637 = phi_955_;
                                            let _e639 = phi_958_;
                                            local_22 = _e639;
                                            if (_e637.member < _e637.member_1) {
                                                phi_956_ = type_37((_e637.member + 1u), _e637.member_1);
                                                phi_981_ = type_37(1u, _e637.member);
                                            } else {
                                                phi_956_ = _e637;
                                                phi_981_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e653 = phi_956_;
                                            let _e655 = phi_981_;
                                            let _e659 = (bitcast<i32>(_e655.member) != 0i);
                                            if _e659 {
                                                let _e661 = local_8.member[0u];
                                                let _e663 = keys.member[_e661];
                                                local_6 = array<array<u32, 2>, 6>(array<u32, 2>(_e663[0][0], _e663[0][1]), array<u32, 2>(_e663[1][0], _e663[1][1]), array<u32, 2>(_e663[2][0], _e663[2][1]), array<u32, 2>(_e663[3][0], _e663[3][1]), array<u32, 2>(_e663[4][0], _e663[4][1]), array<u32, 2>(_e663[5][0], _e663[5][1]));
                                                if (_e655.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e691 = local_6[_e655.member_1];
                                                phi_1038_ = type_37(1u, 3u);
                                                phi_1041_ = array<u32, 2>(_e691[0], _e691[1]);
                                                loop {
                                                    let _e696 = phi_1038_;
                                                    let _e698 = phi_1041_;
                                                    local_10 = _e698;
                                                    local_12 = _e698;
                                                    local_14 = _e698;
                                                    if (_e696.member < _e696.member_1) {
                                                        phi_1039_ = type_37((_e696.member + 1u), _e696.member_1);
                                                        phi_1064_ = type_37(1u, _e696.member);
                                                    } else {
                                                        phi_1039_ = _e696;
                                                        phi_1064_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e712 = phi_1039_;
                                                    let _e714 = phi_1064_;
                                                    let _e718 = (bitcast<i32>(_e714.member) != 0i);
                                                    if _e718 {
                                                        if (_e714.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e721 = local_8.member[_e714.member_1];
                                                        let _e723 = keys.member[_e721];
                                                        local_7 = array<array<u32, 2>, 6>(array<u32, 2>(_e723[0][0], _e723[0][1]), array<u32, 2>(_e723[1][0], _e723[1][1]), array<u32, 2>(_e723[2][0], _e723[2][1]), array<u32, 2>(_e723[3][0], _e723[3][1]), array<u32, 2>(_e723[4][0], _e723[4][1]), array<u32, 2>(_e723[5][0], _e723[5][1]));
                                                        if (_e655.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e751 = local_7[_e655.member_1];
                                                        if (_e698[1] > _e751[1]) {
                                                            phi_1140_ = true;
                                                        } else {
                                                            if (_e698[1] == _e751[1]) {
                                                                phi_1139_ = (_e698[0] > _e751[0]);
                                                            } else {
                                                                phi_1139_ = false;
                                                            }
                                                            let _e762 = phi_1139_;
                                                            phi_1140_ = _e762;
                                                        }
                                                        let _e764 = phi_1140_;
                                                        if _e764 {
                                                            phi_1144_ = array<u32, 2>(_e751[0], _e751[1]);
                                                        } else {
                                                            phi_1144_ = _e698;
                                                        }
                                                        let _e766 = phi_1144_;
                                                        phi_1042_ = _e766;
                                                    } else {
                                                        phi_1042_ = array<u32, 2>();
                                                    }
                                                    let _e768 = phi_1042_;
                                                    continue;
                                                    continuing {
                                                        phi_1038_ = _e712;
                                                        phi_1041_ = _e768;
                                                        break if !(_e718);
                                                    }
                                                }
                                                let _e771 = local_9.member[0u];
                                                let _e773 = keys.member[_e771];
                                                local_4 = array<array<u32, 2>, 6>(array<u32, 2>(_e773[0][0], _e773[0][1]), array<u32, 2>(_e773[1][0], _e773[1][1]), array<u32, 2>(_e773[2][0], _e773[2][1]), array<u32, 2>(_e773[3][0], _e773[3][1]), array<u32, 2>(_e773[4][0], _e773[4][1]), array<u32, 2>(_e773[5][0], _e773[5][1]));
                                                let _e799 = (3u + _e655.member_1);
                                                if (_e799 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e802 = local_4[_e799];
                                                phi_1195_ = type_37(1u, 3u);
                                                phi_1198_ = array<u32, 2>(_e802[0], _e802[1]);
                                                loop {
                                                    let _e807 = phi_1195_;
                                                    let _e809 = phi_1198_;
                                                    local_11 = _e809;
                                                    local_13 = _e809;
                                                    local_15 = _e809;
                                                    if (_e807.member < _e807.member_1) {
                                                        phi_1196_ = type_37((_e807.member + 1u), _e807.member_1);
                                                        phi_1221_ = type_37(1u, _e807.member);
                                                    } else {
                                                        phi_1196_ = _e807;
                                                        phi_1221_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e823 = phi_1196_;
                                                    let _e825 = phi_1221_;
                                                    let _e829 = (bitcast<i32>(_e825.member) != 0i);
                                                    if _e829 {
                                                        if (_e825.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e832 = local_9.member[_e825.member_1];
                                                        let _e834 = keys.member[_e832];
                                                        local_5 = array<array<u32, 2>, 6>(array<u32, 2>(_e834[0][0], _e834[0][1]), array<u32, 2>(_e834[1][0], _e834[1][1]), array<u32, 2>(_e834[2][0], _e834[2][1]), array<u32, 2>(_e834[3][0], _e834[3][1]), array<u32, 2>(_e834[4][0], _e834[4][1]), array<u32, 2>(_e834[5][0], _e834[5][1]));
                                                        let _e860 = (3u + _e655.member_1);
                                                        if (_e860 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e863 = local_5[_e860];
                                                        if (_e863[1] > _e809[1]) {
                                                            phi_1298_ = true;
                                                        } else {
                                                            if (_e863[1] == _e809[1]) {
                                                                phi_1297_ = (_e863[0] > _e809[0]);
                                                            } else {
                                                                phi_1297_ = false;
                                                            }
                                                            let _e874 = phi_1297_;
                                                            phi_1298_ = _e874;
                                                        }
                                                        let _e876 = phi_1298_;
                                                        if _e876 {
                                                            phi_1302_ = array<u32, 2>(_e863[0], _e863[1]);
                                                        } else {
                                                            phi_1302_ = _e809;
                                                        }
                                                        let _e878 = phi_1302_;
                                                        phi_1199_ = _e878;
                                                    } else {
                                                        phi_1199_ = array<u32, 2>();
                                                    }
                                                    let _e880 = phi_1199_;
                                                    continue;
                                                    continuing {
                                                        phi_1195_ = _e823;
                                                        phi_1198_ = _e880;
                                                        break if !(_e829);
                                                    }
                                                }
                                                let _e883 = local_10;
                                                let _e886 = local_11;
                                                if (_e883[1] > _e886[1]) {
                                                    phi_1319_ = true;
                                                } else {
                                                    let _e890 = local_12;
                                                    let _e893 = local_13;
                                                    if (_e890[1] == _e893[1]) {
                                                        let _e897 = local_14;
                                                        let _e900 = local_15;
                                                        phi_1318_ = (_e897[0] > _e900[0]);
                                                    } else {
                                                        phi_1318_ = false;
                                                    }
                                                    let _e904 = phi_1318_;
                                                    phi_1319_ = _e904;
                                                }
                                                let _e906 = phi_1319_;
                                                let _e909 = local_9.member[0u];
                                                let _e911 = keys.member[_e909];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e911[0][0], _e911[0][1]), array<u32, 2>(_e911[1][0], _e911[1][1]), array<u32, 2>(_e911[2][0], _e911[2][1]), array<u32, 2>(_e911[3][0], _e911[3][1]), array<u32, 2>(_e911[4][0], _e911[4][1]), array<u32, 2>(_e911[5][0], _e911[5][1]));
                                                if (_e655.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e939 = local_2[_e655.member_1];
                                                phi_1370_ = type_37(1u, 3u);
                                                phi_1373_ = array<u32, 2>(_e939[0], _e939[1]);
                                                loop {
                                                    let _e944 = phi_1370_;
                                                    let _e946 = phi_1373_;
                                                    local_16 = _e946;
                                                    local_18 = _e946;
                                                    local_20 = _e946;
                                                    if (_e944.member < _e944.member_1) {
                                                        phi_1371_ = type_37((_e944.member + 1u), _e944.member_1);
                                                        phi_1396_ = type_37(1u, _e944.member);
                                                    } else {
                                                        phi_1371_ = _e944;
                                                        phi_1396_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e960 = phi_1371_;
                                                    let _e962 = phi_1396_;
                                                    let _e966 = (bitcast<i32>(_e962.member) != 0i);
                                                    if _e966 {
                                                        if (_e962.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e969 = local_9.member[_e962.member_1];
                                                        let _e971 = keys.member[_e969];
                                                        local_3 = array<array<u32, 2>, 6>(array<u32, 2>(_e971[0][0], _e971[0][1]), array<u32, 2>(_e971[1][0], _e971[1][1]), array<u32, 2>(_e971[2][0], _e971[2][1]), array<u32, 2>(_e971[3][0], _e971[3][1]), array<u32, 2>(_e971[4][0], _e971[4][1]), array<u32, 2>(_e971[5][0], _e971[5][1]));
                                                        if (_e655.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e999 = local_3[_e655.member_1];
                                                        if (_e946[1] > _e999[1]) {
                                                            phi_1472_ = true;
                                                        } else {
                                                            if (_e946[1] == _e999[1]) {
                                                                phi_1471_ = (_e946[0] > _e999[0]);
                                                            } else {
                                                                phi_1471_ = false;
                                                            }
                                                            let _e1010 = phi_1471_;
                                                            phi_1472_ = _e1010;
                                                        }
                                                        let _e1012 = phi_1472_;
                                                        if _e1012 {
                                                            phi_1476_ = array<u32, 2>(_e999[0], _e999[1]);
                                                        } else {
                                                            phi_1476_ = _e946;
                                                        }
                                                        let _e1014 = phi_1476_;
                                                        phi_1374_ = _e1014;
                                                    } else {
                                                        phi_1374_ = array<u32, 2>();
                                                    }
                                                    let _e1016 = phi_1374_;
                                                    continue;
                                                    continuing {
                                                        phi_1370_ = _e960;
                                                        phi_1373_ = _e1016;
                                                        break if !(_e966);
                                                    }
                                                }
                                                let _e1019 = local_8.member[0u];
                                                let _e1021 = keys.member[_e1019];
                                                local = array<array<u32, 2>, 6>(array<u32, 2>(_e1021[0][0], _e1021[0][1]), array<u32, 2>(_e1021[1][0], _e1021[1][1]), array<u32, 2>(_e1021[2][0], _e1021[2][1]), array<u32, 2>(_e1021[3][0], _e1021[3][1]), array<u32, 2>(_e1021[4][0], _e1021[4][1]), array<u32, 2>(_e1021[5][0], _e1021[5][1]));
                                                let _e1047 = (3u + _e655.member_1);
                                                if (_e1047 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1050 = local[_e1047];
                                                phi_1527_ = type_37(1u, 3u);
                                                phi_1530_ = array<u32, 2>(_e1050[0], _e1050[1]);
                                                loop {
                                                    let _e1055 = phi_1527_;
                                                    let _e1057 = phi_1530_;
                                                    local_17 = _e1057;
                                                    local_19 = _e1057;
                                                    local_21 = _e1057;
                                                    if (_e1055.member < _e1055.member_1) {
                                                        phi_1528_ = type_37((_e1055.member + 1u), _e1055.member_1);
                                                        phi_1553_ = type_37(1u, _e1055.member);
                                                    } else {
                                                        phi_1528_ = _e1055;
                                                        phi_1553_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e1071 = phi_1528_;
                                                    let _e1073 = phi_1553_;
                                                    let _e1077 = (bitcast<i32>(_e1073.member) != 0i);
                                                    if _e1077 {
                                                        if (_e1073.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1080 = local_8.member[_e1073.member_1];
                                                        let _e1082 = keys.member[_e1080];
                                                        local_1 = array<array<u32, 2>, 6>(array<u32, 2>(_e1082[0][0], _e1082[0][1]), array<u32, 2>(_e1082[1][0], _e1082[1][1]), array<u32, 2>(_e1082[2][0], _e1082[2][1]), array<u32, 2>(_e1082[3][0], _e1082[3][1]), array<u32, 2>(_e1082[4][0], _e1082[4][1]), array<u32, 2>(_e1082[5][0], _e1082[5][1]));
                                                        let _e1108 = (3u + _e655.member_1);
                                                        if (_e1108 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1111 = local_1[_e1108];
                                                        if (_e1111[1] > _e1057[1]) {
                                                            phi_1630_ = true;
                                                        } else {
                                                            if (_e1111[1] == _e1057[1]) {
                                                                phi_1629_ = (_e1111[0] > _e1057[0]);
                                                            } else {
                                                                phi_1629_ = false;
                                                            }
                                                            let _e1122 = phi_1629_;
                                                            phi_1630_ = _e1122;
                                                        }
                                                        let _e1124 = phi_1630_;
                                                        if _e1124 {
                                                            phi_1634_ = array<u32, 2>(_e1111[0], _e1111[1]);
                                                        } else {
                                                            phi_1634_ = _e1057;
                                                        }
                                                        let _e1126 = phi_1634_;
                                                        phi_1531_ = _e1126;
                                                    } else {
                                                        phi_1531_ = array<u32, 2>();
                                                    }
                                                    let _e1128 = phi_1531_;
                                                    continue;
                                                    continuing {
                                                        phi_1527_ = _e1071;
                                                        phi_1530_ = _e1128;
                                                        break if !(_e1077);
                                                    }
                                                }
                                                let _e1131 = local_16;
                                                let _e1134 = local_17;
                                                if (_e1131[1] > _e1134[1]) {
                                                    phi_1651_ = true;
                                                } else {
                                                    let _e1138 = local_18;
                                                    let _e1141 = local_19;
                                                    if (_e1138[1] == _e1141[1]) {
                                                        let _e1145 = local_20;
                                                        let _e1148 = local_21;
                                                        phi_1650_ = (_e1145[0] > _e1148[0]);
                                                    } else {
                                                        phi_1650_ = false;
                                                    }
                                                    let _e1152 = phi_1650_;
                                                    phi_1651_ = _e1152;
                                                }
                                                let _e1154 = phi_1651_;
                                                phi_959_ = (_e639 && (!(_e906) && !(_e1154)));
                                            } else {
                                                phi_959_ = bool();
                                            }
                                            let _e1159 = phi_959_;
                                            continue;
                                            continuing {
                                                phi_955_ = _e653;
                                                phi_958_ = _e1159;
                                                break if !(_e659);
                                            }
                                        }
                                        let _e1411 = local_22;
                                        phi_1655_ = _e1411;
                                    }
                                    let _e1162 = phi_1655_;
                                    phi_1656_ = _e1162;
                                    phi_1657_ = _e633;
                                } else {
                                    phi_1656_ = bool();
                                    phi_1657_ = true;
                                }
                                let _e1164 = phi_1656_;
                                let _e1166 = phi_1657_;
                                if _e1166 {
                                    phi_1661_ = false;
                                } else {
                                    phi_1661_ = true;
                                }
                                let _e1168 = phi_1661_;
                                phi_1662_ = _e1164;
                                phi_1663_ = _e1168;
                            } else {
                                phi_1662_ = false;
                                phi_1663_ = true;
                            }
                            let _e1170 = phi_1662_;
                            let _e1172 = phi_1663_;
                            phi_1664_ = _e1170;
                            phi_1665_ = _e1172;
                        } else {
                            phi_1664_ = false;
                            phi_1665_ = true;
                        }
                        let _e1174 = phi_1664_;
                        let _e1176 = phi_1665_;
                        if _e1176 {
                            phi_1669_ = _e1174;
                        } else {
                            phi_1669_ = true;
                        }
                        let _e1178 = phi_1669_;
                        if _e1178 {
                            let _e1180 = atomicAdd((&counters[3u]), 1u);
                            kept[_e1180] = _e424;
                        }
                        phi_1677_ = (_e387 + 64u);
                        phi_1678_ = true;
                    }
                    let _e1184 = phi_1677_;
                    let _e1186 = phi_1678_;
                    phi_603_ = _e1184;
                    phi_1679_ = _e1186;
                } else {
                    phi_603_ = u32();
                    phi_1679_ = false;
                }
                let _e1188 = phi_603_;
                let _e1190 = phi_1679_;
                continue;
                continuing {
                    phi_599_ = _e416;
                    phi_602_ = _e1188;
                    break if !(_e1190);
                }
            }
            workgroupBarrier();
            if (_e66 == 0u) {
                let _e1194 = atomicLoad((&counters[3u]));
                if (_e1194 > 0u) {
                    let _e1197 = atomicAdd((&output.member[0u]), _e1194);
                    atomicStore((&counters[4u]), _e1197);
                }
            }
            workgroupBarrier();
            let _e1200 = atomicLoad((&counters[4u]));
            let _e1202 = atomicLoad((&counters[3u]));
            phi_1700_ = type_35(0i, 16i);
            phi_1703_ = _e66;
            loop {
                let _e1204 = phi_1700_;
                let _e1206 = phi_1703_;
                if (_e1204.member < _e1204.member_1) {
                    let _e1214 = (_e1204.member + 1i);
                    if ((false == (_e1214 > _e1204.member)) != false) {
                        phi_1724_ = true;
                    } else {
                        phi_1724_ = false;
                    }
                    let _e1219 = phi_1724_;
                    if _e1219 {
                        phi_1730_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_1730_ = type_36(1u, _e1214);
                    }
                    let _e1225 = phi_1730_;
                    if (bitcast<i32>(_e1225.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_1701_ = type_35(_e1225.member_1, _e1204.member_1);
                    phi_1744_ = type_36(1u, _e1204.member);
                } else {
                    phi_1701_ = _e1204;
                    phi_1744_ = type_36(0u, type_36().member_1);
                }
                let _e1235 = phi_1701_;
                let _e1237 = phi_1744_;
                if (bitcast<i32>(_e1237.member) != 0i) {
                    if (_e1206 >= _e1202) {
                        phi_1852_ = u32();
                        phi_1853_ = false;
                    } else {
                        let _e1243 = kept[_e1206];
                        if (_e86[0] < 4u) {
                        } else {
                            return;
                        }
                        let _e1253 = params.member.member_18[0u][_e86[0]];
                        if (_e86[1] < 4u) {
                        } else {
                            return;
                        }
                        let _e1261 = params.member.member_18[0u][_e86[1]];
                        let _e1264 = leaves.member[(_e1253 + ((_e165 * 32u) + (_e1243 >> bitcast<u32>(5i))))];
                        let _e1267 = leaves.member[(_e1261 + ((_e168 * 32u) + (_e1243 & 31u)))];
                        let _e1270 = params.member.member_8;
                        if (_e1270 == 0u) {
                            phi_1832_ = type_37(_e1264.member_1, _e1267.member_1);
                        } else {
                            if (_e1264.member_1 < _e1267.member_1) {
                                phi_1828_ = type_37(_e1264.member_1, _e1267.member_1);
                            } else {
                                phi_1828_ = type_37(_e1267.member_1, _e1264.member_1);
                            }
                            let _e1276 = phi_1828_;
                            phi_1832_ = _e1276;
                        }
                        let _e1279 = phi_1832_;
                        let _e1281 = params.member.member_16;
                        let _e1282 = (_e1200 + _e1206);
                        if (_e1282 < _e1281) {
                            atomicStore((&output.member[(4u + (2u * _e1282))]), _e1279.member);
                            atomicStore((&output.member[((2u * _e1282) + 5u)]), _e1279.member_1);
                        }
                        phi_1852_ = (_e1206 + 64u);
                        phi_1853_ = true;
                    }
                    let _e1294 = phi_1852_;
                    let _e1296 = phi_1853_;
                    phi_1704_ = _e1294;
                    phi_1854_ = _e1296;
                } else {
                    phi_1704_ = u32();
                    phi_1854_ = false;
                }
                let _e1298 = phi_1704_;
                let _e1300 = phi_1854_;
                continue;
                continuing {
                    phi_1700_ = _e1235;
                    phi_1703_ = _e1298;
                    break if !(_e1300);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_238_ = _e147;
            break if !(_e153);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
