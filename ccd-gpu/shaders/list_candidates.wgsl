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
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_824_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_876_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_941_: type_37;
    var phi_944_: bool;
    var phi_942_: type_37;
    var phi_967_: type_37;
    var phi_1024_: type_37;
    var phi_1027_: array<u32, 2>;
    var phi_1025_: type_37;
    var phi_1050_: type_37;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1130_: array<u32, 2>;
    var phi_1028_: array<u32, 2>;
    var phi_1181_: type_37;
    var phi_1184_: array<u32, 2>;
    var phi_1182_: type_37;
    var phi_1207_: type_37;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1288_: array<u32, 2>;
    var phi_1185_: array<u32, 2>;
    var local_10: array<u32, 2>;
    var local_11: array<u32, 2>;
    var local_12: array<u32, 2>;
    var local_13: array<u32, 2>;
    var local_14: array<u32, 2>;
    var local_15: array<u32, 2>;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1356_: type_37;
    var phi_1359_: array<u32, 2>;
    var phi_1357_: type_37;
    var phi_1382_: type_37;
    var phi_1457_: bool;
    var phi_1458_: bool;
    var phi_1462_: array<u32, 2>;
    var phi_1360_: array<u32, 2>;
    var phi_1513_: type_37;
    var phi_1516_: array<u32, 2>;
    var phi_1514_: type_37;
    var phi_1539_: type_37;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1620_: array<u32, 2>;
    var phi_1517_: array<u32, 2>;
    var local_16: array<u32, 2>;
    var local_17: array<u32, 2>;
    var local_18: array<u32, 2>;
    var local_19: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var phi_1636_: bool;
    var phi_1637_: bool;
    var phi_945_: bool;
    var phi_1641_: bool;
    var phi_1642_: bool;
    var phi_1643_: bool;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1655_: bool;
    var phi_1663_: u32;
    var phi_1664_: bool;
    var phi_603_: u32;
    var phi_1665_: bool;
    var phi_1686_: type_35;
    var phi_1689_: u32;
    var phi_1710_: bool;
    var phi_1716_: type_36;
    var phi_1687_: type_35;
    var phi_1730_: type_36;
    var phi_1814_: type_37;
    var phi_1818_: type_37;
    var phi_1838_: u32;
    var phi_1839_: bool;
    var phi_1690_: u32;
    var phi_1840_: bool;
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
                        phi_1663_ = u32();
                        phi_1664_ = false;
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
                                let _e515 = local_8.member[0u];
                                let _e518 = local_9.member[0u];
                                if (_e515 == _e518) {
                                    phi_781_ = bool();
                                    phi_782_ = true;
                                } else {
                                    let _e522 = local_8.member[0u];
                                    let _e525 = local_9.member[1u];
                                    let _e526 = (_e522 == _e525);
                                    if _e526 {
                                        phi_780_ = bool();
                                    } else {
                                        let _e529 = local_8.member[0u];
                                        let _e532 = local_9.member[2u];
                                        phi_780_ = (_e529 == _e532);
                                    }
                                    let _e535 = phi_780_;
                                    phi_781_ = _e535;
                                    phi_782_ = _e526;
                                }
                                let _e537 = phi_781_;
                                let _e539 = phi_782_;
                                if _e539 {
                                    phi_786_ = true;
                                } else {
                                    phi_786_ = _e537;
                                }
                                let _e541 = phi_786_;
                                phi_825_ = _e541;
                            } else {
                                let _e475 = local_8.member[0u];
                                let _e478 = local_9.member[0u];
                                if (_e475 == _e478) {
                                    phi_819_ = bool();
                                    phi_820_ = true;
                                } else {
                                    let _e482 = local_8.member[0u];
                                    let _e485 = local_9.member[1u];
                                    if (_e482 == _e485) {
                                        phi_817_ = bool();
                                        phi_818_ = true;
                                    } else {
                                        let _e489 = local_8.member[1u];
                                        let _e492 = local_9.member[0u];
                                        let _e493 = (_e489 == _e492);
                                        if _e493 {
                                            phi_816_ = bool();
                                        } else {
                                            let _e496 = local_8.member[1u];
                                            let _e499 = local_9.member[1u];
                                            phi_816_ = (_e496 == _e499);
                                        }
                                        let _e502 = phi_816_;
                                        phi_817_ = _e502;
                                        phi_818_ = _e493;
                                    }
                                    let _e504 = phi_817_;
                                    let _e506 = phi_818_;
                                    phi_819_ = _e504;
                                    phi_820_ = _e506;
                                }
                                let _e508 = phi_819_;
                                let _e510 = phi_820_;
                                if _e510 {
                                    phi_824_ = true;
                                } else {
                                    phi_824_ = _e508;
                                }
                                let _e512 = phi_824_;
                                phi_825_ = _e512;
                            }
                            let _e543 = phi_825_;
                            if _e543 {
                                phi_829_ = false;
                            } else {
                                phi_829_ = true;
                            }
                            let _e545 = phi_829_;
                            phi_830_ = _e545;
                        } else {
                            phi_830_ = true;
                        }
                        let _e547 = phi_830_;
                        if _e547 {
                            let _e549 = params.member.member_1;
                            if ((_e549 & 2u) != 0u) {
                                let _e554 = local_8.member[0u];
                                let _e556 = bodies.member[_e554];
                                let _e559 = local_9.member[0u];
                                let _e561 = bodies.member[_e559];
                                if ((_e556 / 2u) == (_e561 / 2u)) {
                                    let _e566 = params.member.member_1;
                                    phi_876_ = !(((_e566 & 4u) != 0u));
                                } else {
                                    phi_876_ = false;
                                }
                                let _e571 = phi_876_;
                                if _e571 {
                                    phi_887_ = true;
                                } else {
                                    if (((_e556 & _e561) & 1u) == 0u) {
                                        phi_886_ = false;
                                    } else {
                                        phi_886_ = true;
                                    }
                                    let _e576 = phi_886_;
                                    phi_887_ = _e576;
                                }
                                let _e578 = phi_887_;
                                if _e578 {
                                    phi_891_ = false;
                                } else {
                                    phi_891_ = true;
                                }
                                let _e580 = phi_891_;
                                phi_892_ = _e580;
                            } else {
                                phi_892_ = true;
                            }
                            let _e582 = phi_892_;
                            if _e582 {
                                let _e584 = params.member.member_1;
                                if ((_e584 & 32u) != 0u) {
                                    let _e588 = params.member.member_6;
                                    let _e629 = (((((((_e463.member_1[0] - _e465.member[0]) > _e588) && ((_e465.member_1[0] - _e463.member[0]) > _e588)) && ((_e463.member_1[1] - _e465.member[1]) > _e588)) && ((_e465.member_1[1] - _e463.member[1]) > _e588)) && ((_e463.member_1[2] - _e465.member[2]) > _e588)) && ((_e465.member_1[2] - _e463.member[2]) > _e588));
                                    if _e629 {
                                        phi_1641_ = bool();
                                    } else {
                                        phi_941_ = type_37(0u, 3u);
                                        phi_944_ = true;
                                        loop {
                                            let _e633 = phi_941_;
                                            let _e635 = phi_944_;
                                            local_22 = _e635;
                                            if (_e633.member < _e633.member_1) {
                                                phi_942_ = type_37((_e633.member + 1u), _e633.member_1);
                                                phi_967_ = type_37(1u, _e633.member);
                                            } else {
                                                phi_942_ = _e633;
                                                phi_967_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e649 = phi_942_;
                                            let _e651 = phi_967_;
                                            let _e655 = (bitcast<i32>(_e651.member) != 0i);
                                            if _e655 {
                                                let _e657 = local_8.member[0u];
                                                let _e659 = keys.member[_e657];
                                                local_6 = array<array<u32, 2>, 6>(array<u32, 2>(_e659[0][0], _e659[0][1]), array<u32, 2>(_e659[1][0], _e659[1][1]), array<u32, 2>(_e659[2][0], _e659[2][1]), array<u32, 2>(_e659[3][0], _e659[3][1]), array<u32, 2>(_e659[4][0], _e659[4][1]), array<u32, 2>(_e659[5][0], _e659[5][1]));
                                                if (_e651.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e687 = local_6[_e651.member_1];
                                                phi_1024_ = type_37(1u, 3u);
                                                phi_1027_ = array<u32, 2>(_e687[0], _e687[1]);
                                                loop {
                                                    let _e692 = phi_1024_;
                                                    let _e694 = phi_1027_;
                                                    local_10 = _e694;
                                                    local_12 = _e694;
                                                    local_14 = _e694;
                                                    if (_e692.member < _e692.member_1) {
                                                        phi_1025_ = type_37((_e692.member + 1u), _e692.member_1);
                                                        phi_1050_ = type_37(1u, _e692.member);
                                                    } else {
                                                        phi_1025_ = _e692;
                                                        phi_1050_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e708 = phi_1025_;
                                                    let _e710 = phi_1050_;
                                                    let _e714 = (bitcast<i32>(_e710.member) != 0i);
                                                    if _e714 {
                                                        if (_e710.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e717 = local_8.member[_e710.member_1];
                                                        let _e719 = keys.member[_e717];
                                                        local_7 = array<array<u32, 2>, 6>(array<u32, 2>(_e719[0][0], _e719[0][1]), array<u32, 2>(_e719[1][0], _e719[1][1]), array<u32, 2>(_e719[2][0], _e719[2][1]), array<u32, 2>(_e719[3][0], _e719[3][1]), array<u32, 2>(_e719[4][0], _e719[4][1]), array<u32, 2>(_e719[5][0], _e719[5][1]));
                                                        if (_e651.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e747 = local_7[_e651.member_1];
                                                        if (_e694[1] > _e747[1]) {
                                                            phi_1126_ = true;
                                                        } else {
                                                            if (_e694[1] == _e747[1]) {
                                                                phi_1125_ = (_e694[0] > _e747[0]);
                                                            } else {
                                                                phi_1125_ = false;
                                                            }
                                                            let _e758 = phi_1125_;
                                                            phi_1126_ = _e758;
                                                        }
                                                        let _e760 = phi_1126_;
                                                        if _e760 {
                                                            phi_1130_ = array<u32, 2>(_e747[0], _e747[1]);
                                                        } else {
                                                            phi_1130_ = _e694;
                                                        }
                                                        let _e762 = phi_1130_;
                                                        phi_1028_ = _e762;
                                                    } else {
                                                        phi_1028_ = array<u32, 2>();
                                                    }
                                                    let _e764 = phi_1028_;
                                                    continue;
                                                    continuing {
                                                        phi_1024_ = _e708;
                                                        phi_1027_ = _e764;
                                                        break if !(_e714);
                                                    }
                                                }
                                                let _e767 = local_9.member[0u];
                                                let _e769 = keys.member[_e767];
                                                local_4 = array<array<u32, 2>, 6>(array<u32, 2>(_e769[0][0], _e769[0][1]), array<u32, 2>(_e769[1][0], _e769[1][1]), array<u32, 2>(_e769[2][0], _e769[2][1]), array<u32, 2>(_e769[3][0], _e769[3][1]), array<u32, 2>(_e769[4][0], _e769[4][1]), array<u32, 2>(_e769[5][0], _e769[5][1]));
                                                let _e795 = (3u + _e651.member_1);
                                                if (_e795 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e798 = local_4[_e795];
                                                phi_1181_ = type_37(1u, 3u);
                                                phi_1184_ = array<u32, 2>(_e798[0], _e798[1]);
                                                loop {
                                                    let _e803 = phi_1181_;
                                                    let _e805 = phi_1184_;
                                                    local_11 = _e805;
                                                    local_13 = _e805;
                                                    local_15 = _e805;
                                                    if (_e803.member < _e803.member_1) {
                                                        phi_1182_ = type_37((_e803.member + 1u), _e803.member_1);
                                                        phi_1207_ = type_37(1u, _e803.member);
                                                    } else {
                                                        phi_1182_ = _e803;
                                                        phi_1207_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e819 = phi_1182_;
                                                    let _e821 = phi_1207_;
                                                    let _e825 = (bitcast<i32>(_e821.member) != 0i);
                                                    if _e825 {
                                                        if (_e821.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e828 = local_9.member[_e821.member_1];
                                                        let _e830 = keys.member[_e828];
                                                        local_5 = array<array<u32, 2>, 6>(array<u32, 2>(_e830[0][0], _e830[0][1]), array<u32, 2>(_e830[1][0], _e830[1][1]), array<u32, 2>(_e830[2][0], _e830[2][1]), array<u32, 2>(_e830[3][0], _e830[3][1]), array<u32, 2>(_e830[4][0], _e830[4][1]), array<u32, 2>(_e830[5][0], _e830[5][1]));
                                                        let _e856 = (3u + _e651.member_1);
                                                        if (_e856 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e859 = local_5[_e856];
                                                        if (_e859[1] > _e805[1]) {
                                                            phi_1284_ = true;
                                                        } else {
                                                            if (_e859[1] == _e805[1]) {
                                                                phi_1283_ = (_e859[0] > _e805[0]);
                                                            } else {
                                                                phi_1283_ = false;
                                                            }
                                                            let _e870 = phi_1283_;
                                                            phi_1284_ = _e870;
                                                        }
                                                        let _e872 = phi_1284_;
                                                        if _e872 {
                                                            phi_1288_ = array<u32, 2>(_e859[0], _e859[1]);
                                                        } else {
                                                            phi_1288_ = _e805;
                                                        }
                                                        let _e874 = phi_1288_;
                                                        phi_1185_ = _e874;
                                                    } else {
                                                        phi_1185_ = array<u32, 2>();
                                                    }
                                                    let _e876 = phi_1185_;
                                                    continue;
                                                    continuing {
                                                        phi_1181_ = _e819;
                                                        phi_1184_ = _e876;
                                                        break if !(_e825);
                                                    }
                                                }
                                                let _e879 = local_10;
                                                let _e882 = local_11;
                                                if (_e879[1] > _e882[1]) {
                                                    phi_1305_ = true;
                                                } else {
                                                    let _e886 = local_12;
                                                    let _e889 = local_13;
                                                    if (_e886[1] == _e889[1]) {
                                                        let _e893 = local_14;
                                                        let _e896 = local_15;
                                                        phi_1304_ = (_e893[0] > _e896[0]);
                                                    } else {
                                                        phi_1304_ = false;
                                                    }
                                                    let _e900 = phi_1304_;
                                                    phi_1305_ = _e900;
                                                }
                                                let _e902 = phi_1305_;
                                                let _e905 = local_9.member[0u];
                                                let _e907 = keys.member[_e905];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e907[0][0], _e907[0][1]), array<u32, 2>(_e907[1][0], _e907[1][1]), array<u32, 2>(_e907[2][0], _e907[2][1]), array<u32, 2>(_e907[3][0], _e907[3][1]), array<u32, 2>(_e907[4][0], _e907[4][1]), array<u32, 2>(_e907[5][0], _e907[5][1]));
                                                if (_e651.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e935 = local_2[_e651.member_1];
                                                phi_1356_ = type_37(1u, 3u);
                                                phi_1359_ = array<u32, 2>(_e935[0], _e935[1]);
                                                loop {
                                                    let _e940 = phi_1356_;
                                                    let _e942 = phi_1359_;
                                                    local_16 = _e942;
                                                    local_18 = _e942;
                                                    local_20 = _e942;
                                                    if (_e940.member < _e940.member_1) {
                                                        phi_1357_ = type_37((_e940.member + 1u), _e940.member_1);
                                                        phi_1382_ = type_37(1u, _e940.member);
                                                    } else {
                                                        phi_1357_ = _e940;
                                                        phi_1382_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e956 = phi_1357_;
                                                    let _e958 = phi_1382_;
                                                    let _e962 = (bitcast<i32>(_e958.member) != 0i);
                                                    if _e962 {
                                                        if (_e958.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e965 = local_9.member[_e958.member_1];
                                                        let _e967 = keys.member[_e965];
                                                        local_3 = array<array<u32, 2>, 6>(array<u32, 2>(_e967[0][0], _e967[0][1]), array<u32, 2>(_e967[1][0], _e967[1][1]), array<u32, 2>(_e967[2][0], _e967[2][1]), array<u32, 2>(_e967[3][0], _e967[3][1]), array<u32, 2>(_e967[4][0], _e967[4][1]), array<u32, 2>(_e967[5][0], _e967[5][1]));
                                                        if (_e651.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e995 = local_3[_e651.member_1];
                                                        if (_e942[1] > _e995[1]) {
                                                            phi_1458_ = true;
                                                        } else {
                                                            if (_e942[1] == _e995[1]) {
                                                                phi_1457_ = (_e942[0] > _e995[0]);
                                                            } else {
                                                                phi_1457_ = false;
                                                            }
                                                            let _e1006 = phi_1457_;
                                                            phi_1458_ = _e1006;
                                                        }
                                                        let _e1008 = phi_1458_;
                                                        if _e1008 {
                                                            phi_1462_ = array<u32, 2>(_e995[0], _e995[1]);
                                                        } else {
                                                            phi_1462_ = _e942;
                                                        }
                                                        let _e1010 = phi_1462_;
                                                        phi_1360_ = _e1010;
                                                    } else {
                                                        phi_1360_ = array<u32, 2>();
                                                    }
                                                    let _e1012 = phi_1360_;
                                                    continue;
                                                    continuing {
                                                        phi_1356_ = _e956;
                                                        phi_1359_ = _e1012;
                                                        break if !(_e962);
                                                    }
                                                }
                                                let _e1015 = local_8.member[0u];
                                                let _e1017 = keys.member[_e1015];
                                                local = array<array<u32, 2>, 6>(array<u32, 2>(_e1017[0][0], _e1017[0][1]), array<u32, 2>(_e1017[1][0], _e1017[1][1]), array<u32, 2>(_e1017[2][0], _e1017[2][1]), array<u32, 2>(_e1017[3][0], _e1017[3][1]), array<u32, 2>(_e1017[4][0], _e1017[4][1]), array<u32, 2>(_e1017[5][0], _e1017[5][1]));
                                                let _e1043 = (3u + _e651.member_1);
                                                if (_e1043 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1046 = local[_e1043];
                                                phi_1513_ = type_37(1u, 3u);
                                                phi_1516_ = array<u32, 2>(_e1046[0], _e1046[1]);
                                                loop {
                                                    let _e1051 = phi_1513_;
                                                    let _e1053 = phi_1516_;
                                                    local_17 = _e1053;
                                                    local_19 = _e1053;
                                                    local_21 = _e1053;
                                                    if (_e1051.member < _e1051.member_1) {
                                                        phi_1514_ = type_37((_e1051.member + 1u), _e1051.member_1);
                                                        phi_1539_ = type_37(1u, _e1051.member);
                                                    } else {
                                                        phi_1514_ = _e1051;
                                                        phi_1539_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e1067 = phi_1514_;
                                                    let _e1069 = phi_1539_;
                                                    let _e1073 = (bitcast<i32>(_e1069.member) != 0i);
                                                    if _e1073 {
                                                        if (_e1069.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1076 = local_8.member[_e1069.member_1];
                                                        let _e1078 = keys.member[_e1076];
                                                        local_1 = array<array<u32, 2>, 6>(array<u32, 2>(_e1078[0][0], _e1078[0][1]), array<u32, 2>(_e1078[1][0], _e1078[1][1]), array<u32, 2>(_e1078[2][0], _e1078[2][1]), array<u32, 2>(_e1078[3][0], _e1078[3][1]), array<u32, 2>(_e1078[4][0], _e1078[4][1]), array<u32, 2>(_e1078[5][0], _e1078[5][1]));
                                                        let _e1104 = (3u + _e651.member_1);
                                                        if (_e1104 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1107 = local_1[_e1104];
                                                        if (_e1107[1] > _e1053[1]) {
                                                            phi_1616_ = true;
                                                        } else {
                                                            if (_e1107[1] == _e1053[1]) {
                                                                phi_1615_ = (_e1107[0] > _e1053[0]);
                                                            } else {
                                                                phi_1615_ = false;
                                                            }
                                                            let _e1118 = phi_1615_;
                                                            phi_1616_ = _e1118;
                                                        }
                                                        let _e1120 = phi_1616_;
                                                        if _e1120 {
                                                            phi_1620_ = array<u32, 2>(_e1107[0], _e1107[1]);
                                                        } else {
                                                            phi_1620_ = _e1053;
                                                        }
                                                        let _e1122 = phi_1620_;
                                                        phi_1517_ = _e1122;
                                                    } else {
                                                        phi_1517_ = array<u32, 2>();
                                                    }
                                                    let _e1124 = phi_1517_;
                                                    continue;
                                                    continuing {
                                                        phi_1513_ = _e1067;
                                                        phi_1516_ = _e1124;
                                                        break if !(_e1073);
                                                    }
                                                }
                                                let _e1127 = local_16;
                                                let _e1130 = local_17;
                                                if (_e1127[1] > _e1130[1]) {
                                                    phi_1637_ = true;
                                                } else {
                                                    let _e1134 = local_18;
                                                    let _e1137 = local_19;
                                                    if (_e1134[1] == _e1137[1]) {
                                                        let _e1141 = local_20;
                                                        let _e1144 = local_21;
                                                        phi_1636_ = (_e1141[0] > _e1144[0]);
                                                    } else {
                                                        phi_1636_ = false;
                                                    }
                                                    let _e1148 = phi_1636_;
                                                    phi_1637_ = _e1148;
                                                }
                                                let _e1150 = phi_1637_;
                                                phi_945_ = (_e635 && (!(_e902) && !(_e1150)));
                                            } else {
                                                phi_945_ = bool();
                                            }
                                            let _e1155 = phi_945_;
                                            continue;
                                            continuing {
                                                phi_941_ = _e649;
                                                phi_944_ = _e1155;
                                                break if !(_e655);
                                            }
                                        }
                                        let _e1405 = local_22;
                                        phi_1641_ = _e1405;
                                    }
                                    let _e1158 = phi_1641_;
                                    phi_1642_ = _e1158;
                                    phi_1643_ = _e629;
                                } else {
                                    phi_1642_ = bool();
                                    phi_1643_ = true;
                                }
                                let _e1160 = phi_1642_;
                                let _e1162 = phi_1643_;
                                if _e1162 {
                                    phi_1647_ = false;
                                } else {
                                    phi_1647_ = true;
                                }
                                let _e1164 = phi_1647_;
                                phi_1648_ = _e1160;
                                phi_1649_ = _e1164;
                            } else {
                                phi_1648_ = false;
                                phi_1649_ = true;
                            }
                            let _e1166 = phi_1648_;
                            let _e1168 = phi_1649_;
                            phi_1650_ = _e1166;
                            phi_1651_ = _e1168;
                        } else {
                            phi_1650_ = false;
                            phi_1651_ = true;
                        }
                        let _e1170 = phi_1650_;
                        let _e1172 = phi_1651_;
                        if _e1172 {
                            phi_1655_ = _e1170;
                        } else {
                            phi_1655_ = true;
                        }
                        let _e1174 = phi_1655_;
                        if _e1174 {
                            let _e1176 = atomicAdd((&counters[3u]), 1u);
                            kept[_e1176] = _e424;
                        }
                        phi_1663_ = (_e387 + 64u);
                        phi_1664_ = true;
                    }
                    let _e1180 = phi_1663_;
                    let _e1182 = phi_1664_;
                    phi_603_ = _e1180;
                    phi_1665_ = _e1182;
                } else {
                    phi_603_ = u32();
                    phi_1665_ = false;
                }
                let _e1184 = phi_603_;
                let _e1186 = phi_1665_;
                continue;
                continuing {
                    phi_599_ = _e416;
                    phi_602_ = _e1184;
                    break if !(_e1186);
                }
            }
            workgroupBarrier();
            if (_e66 == 0u) {
                let _e1190 = atomicLoad((&counters[3u]));
                if (_e1190 > 0u) {
                    let _e1193 = atomicAdd((&output.member[0u]), _e1190);
                    atomicStore((&counters[4u]), _e1193);
                }
            }
            workgroupBarrier();
            let _e1196 = atomicLoad((&counters[4u]));
            let _e1198 = atomicLoad((&counters[3u]));
            phi_1686_ = type_35(0i, 16i);
            phi_1689_ = _e66;
            loop {
                let _e1200 = phi_1686_;
                let _e1202 = phi_1689_;
                if (_e1200.member < _e1200.member_1) {
                    let _e1210 = (_e1200.member + 1i);
                    if ((false == (_e1210 > _e1200.member)) != false) {
                        phi_1710_ = true;
                    } else {
                        phi_1710_ = false;
                    }
                    let _e1215 = phi_1710_;
                    if _e1215 {
                        phi_1716_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_1716_ = type_36(1u, _e1210);
                    }
                    let _e1221 = phi_1716_;
                    if (bitcast<i32>(_e1221.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_1687_ = type_35(_e1221.member_1, _e1200.member_1);
                    phi_1730_ = type_36(1u, _e1200.member);
                } else {
                    phi_1687_ = _e1200;
                    phi_1730_ = type_36(0u, type_36().member_1);
                }
                let _e1231 = phi_1687_;
                let _e1233 = phi_1730_;
                if (bitcast<i32>(_e1233.member) != 0i) {
                    if (_e1202 >= _e1198) {
                        phi_1838_ = u32();
                        phi_1839_ = false;
                    } else {
                        let _e1239 = kept[_e1202];
                        if (_e86[0] < 4u) {
                        } else {
                            return;
                        }
                        let _e1249 = params.member.member_18[0u][_e86[0]];
                        if (_e86[1] < 4u) {
                        } else {
                            return;
                        }
                        let _e1257 = params.member.member_18[0u][_e86[1]];
                        let _e1260 = leaves.member[(_e1249 + ((_e165 * 32u) + (_e1239 >> bitcast<u32>(5i))))];
                        let _e1263 = leaves.member[(_e1257 + ((_e168 * 32u) + (_e1239 & 31u)))];
                        let _e1266 = params.member.member_8;
                        if (_e1266 == 0u) {
                            phi_1818_ = type_37(_e1260.member_1, _e1263.member_1);
                        } else {
                            if (_e1260.member_1 < _e1263.member_1) {
                                phi_1814_ = type_37(_e1260.member_1, _e1263.member_1);
                            } else {
                                phi_1814_ = type_37(_e1263.member_1, _e1260.member_1);
                            }
                            let _e1272 = phi_1814_;
                            phi_1818_ = _e1272;
                        }
                        let _e1275 = phi_1818_;
                        let _e1277 = params.member.member_16;
                        let _e1278 = (_e1196 + _e1202);
                        if (_e1278 < _e1277) {
                            atomicStore((&output.member[(4u + (2u * _e1278))]), _e1275.member);
                            atomicStore((&output.member[((2u * _e1278) + 5u)]), _e1275.member_1);
                        }
                        phi_1838_ = (_e1202 + 64u);
                        phi_1839_ = true;
                    }
                    let _e1290 = phi_1838_;
                    let _e1292 = phi_1839_;
                    phi_1690_ = _e1290;
                    phi_1840_ = _e1292;
                } else {
                    phi_1690_ = u32();
                    phi_1840_ = false;
                }
                let _e1294 = phi_1690_;
                let _e1296 = phi_1840_;
                continue;
                continuing {
                    phi_1686_ = _e1231;
                    phi_1689_ = _e1294;
                    break if !(_e1296);
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
