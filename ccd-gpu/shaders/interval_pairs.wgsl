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

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_23 {
    member: type_18,
    member_1: array<f32, 3>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_27 {
    member: type_23,
    member_1: u32,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_31;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(1) 
var<storage> sorted: type_20;
@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(4) 
var<storage> survey: type_11;
@group(0) @binding(5) 
var<storage> work: type_11;
var<workgroup> boxes: array<type_18, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_18;
    var local_2: type_23;
    var local_3: array<f32, 3>;
    var local_4: type_18;
    var local_5: type_18;
    var local_6: type_23;
    var local_7: type_18;
    var phi_202_: u32;
    var phi_212_: u32;
    var phi_219_: u32;
    var phi_238_: u32;
    var phi_259_: u32;
    var phi_260_: u32;
    var phi_263_: type_9;
    var phi_264_: type_9;
    var phi_287_: type_9;
    var phi_343_: array<u32, 2>;
    var phi_350_: u32;
    var phi_355_: u32;
    var phi_363_: array<u32, 2>;
    var phi_401_: array<u32, 2>;
    var phi_408_: u32;
    var phi_413_: u32;
    var phi_421_: array<u32, 2>;
    var phi_464_: u32;
    var phi_473_: u32;
    var phi_478_: u32;
    var phi_481_: bool;
    var phi_496_: u32;
    var phi_497_: u32;
    var phi_498_: u32;
    var phi_499_: bool;
    var phi_503_: u32;
    var phi_520_: type_15;
    var phi_523_: u32;
    var phi_525_: u32;
    var phi_546_: bool;
    var phi_552_: type_16;
    var phi_521_: type_15;
    var phi_566_: type_16;
    var phi_595_: u32;
    var phi_596_: u32;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_599_: bool;
    var phi_524_: u32;
    var phi_526_: u32;
    var phi_600_: bool;
    var phi_605_: type_15;
    var phi_608_: u32;
    var phi_610_: u32;
    var phi_631_: bool;
    var phi_637_: type_16;
    var phi_606_: type_15;
    var phi_651_: type_16;
    var phi_680_: u32;
    var phi_681_: u32;
    var phi_682_: u32;
    var phi_683_: u32;
    var phi_684_: bool;
    var phi_609_: u32;
    var phi_611_: u32;
    var phi_685_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_687_: u32;
    var phi_703_: array<u32, 2>;
    var phi_704_: array<u32, 2>;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_742_: u32;
    var phi_761_: u32;
    var phi_780_: u32;
    var phi_785_: type_9;
    var phi_786_: type_9;
    var phi_809_: type_9;
    var phi_835_: u32;
    var phi_861_: u32;
    var phi_994_: type_9;
    var phi_997_: type_27;
    var phi_995_: type_9;
    var phi_1020_: type_9;
    var phi_1030_: type_9;
    var phi_1033_: bool;
    var phi_1031_: type_9;
    var phi_1056_: type_9;
    var phi_1078_: f32;
    var phi_1095_: bool;
    var phi_1034_: bool;
    var local_10: bool;
    var phi_1101_: type_27;
    var phi_1102_: bool;
    var phi_998_: type_27;
    var phi_1103_: bool;
    var phi_1111_: u32;
    var local_11: type_27;
    var local_12: type_27;
    var local_13: type_27;
    var phi_1121_: u32;
    var local_14: type_27;
    var phi_1128_: u32;
    var local_15: type_27;
    var local_16: type_27;
    var local_17: type_27;
    var phi_1160_: type_9;
    var phi_1161_: type_9;
    var phi_1184_: type_9;
    var phi_1235_: f32;
    var phi_1240_: f32;
    var phi_1281_: type_9;
    var phi_1282_: type_9;
    var phi_1305_: type_9;
    var phi_1333_: f32;
    var phi_1348_: f32;
    var phi_1375_: u32;
    var phi_1376_: u32;
    var phi_1388_: array<u32, 3>;
    var phi_1389_: array<u32, 3>;
    var phi_1458_: bool;
    var phi_1470_: bool;
    var phi_1471_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1521_: u32;
    var phi_1522_: bool;
    var phi_1523_: u32;
    var phi_1524_: bool;
    var phi_1529_: u32;
    var phi_1539_: u32;
    var phi_1553_: array<u32, 2>;
    var phi_1554_: array<u32, 2>;
    var phi_1555_: bool;
    var phi_1556_: array<u32, 2>;
    var phi_1557_: bool;
    var phi_1558_: array<u32, 2>;
    var phi_1559_: bool;
    var phi_1564_: array<u32, 2>;
    var phi_1565_: array<u32, 2>;
    var phi_1573_: array<u32, 2>;
    var phi_1574_: bool;
    var phi_1575_: array<u32, 2>;
    var phi_1576_: bool;
    var phi_1581_: array<u32, 2>;
    var phi_1588_: array<u32, 2>;
    var phi_1425_: f32;
    var phi_1426_: f32;
    var phi_1432_: u32;
    var phi_1442_: u32;
    var phi_1589_: array<u32, 2>;
    var phi_1597_: u32;
    var phi_1600_: array<u32, 3>;
    var phi_1602_: array<u32, 3>;
    var phi_1619_: type_18;
    var phi_1622_: type_9;
    var phi_1623_: type_9;
    var phi_1646_: type_9;
    var phi_1681_: type_18;
    var phi_1682_: u32;
    var phi_1703_: type_9;
    var phi_1704_: type_9;
    var phi_1727_: type_9;
    var phi_1851_: u32;
    var phi_1856_: u32;
    var phi_1872_: type_9;
    var phi_1840_: type_9;
    var phi_1873_: type_9;
    var phi_1908_: u32;
    var phi_1934_: type_9;
    var phi_1935_: type_9;
    var phi_1958_: type_9;
    var phi_1989_: array<u32, 2>;
    var phi_1996_: u32;
    var phi_2001_: u32;
    var phi_2009_: array<u32, 2>;
    var phi_2083_: u32;
    var phi_2088_: u32;
    var phi_2104_: type_9;
    var phi_2072_: type_9;
    var phi_2105_: type_9;
    var phi_2123_: bool;
    var phi_2124_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e94 = id_2;
    let _e95 = n_2;
    let _e96 = lane_2;
    let _e108 = ((_e94.y * _e95.x) + _e94.x);
    let _e111 = (_e95.x * _e95.y);
    let _e114 = params.member.member_1.member_2;
    let _e116 = work.member[0u];
    if (_e114 < _e116) {
        phi_202_ = _e114;
    } else {
        phi_202_ = _e116;
    }
    let _e119 = phi_202_;
    let _e121 = params.member.member_1.member_1;
    if (_e119 > _e121) {
        let _e124 = params.member.member_1.member_1;
        phi_212_ = (_e119 - _e124);
    } else {
        phi_212_ = 0u;
    }
    let _e127 = phi_212_;
    let _e129 = params.member.member_1.member;
    if (_e129 < _e127) {
        phi_219_ = _e129;
    } else {
        phi_219_ = _e127;
    }
    let _e132 = phi_219_;
    let _e136 = params.member.member.member_2[3u];
    if false {
        phi_238_ = (_e132 + 1u);
    } else {
        phi_238_ = _e132;
    }
    let _e139 = phi_238_;
    if (_e139 > _e108) {
        let _e141 = (_e139 - _e108);
        if (_e111 == 0u) {
            return;
        }
        let _e143 = (_e141 / _e111);
        if (_e111 == 0u) {
            return;
        }
        if ((_e141 % _e111) > 0u) {
            phi_259_ = (_e143 + 1u);
        } else {
            phi_259_ = _e143;
        }
        let _e149 = phi_259_;
        phi_260_ = _e149;
    } else {
        phi_260_ = 0u;
    }
    let _e151 = phi_260_;
    phi_263_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_263_;
        if (_e154.member < _e154.member_1) {
            phi_264_ = type_9((_e154.member + 1u), _e154.member_1);
            phi_287_ = type_9(1u, _e154.member);
        } else {
            phi_264_ = _e154;
            phi_287_ = type_9(0u, type_9().member_1);
        }
        let _e166 = phi_264_;
        let _e168 = phi_287_;
        let _e172 = (bitcast<i32>(_e168.member) != 0i);
        if _e172 {
            let _e175 = params.member.member_1.member_1;
            let _e179 = (2u * ((_e175 + _e108) + (_e168.member_1 * _e111)));
            let _e182 = work.member[(4u + _e179)];
            let _e185 = work.member[(_e179 + 5u)];
            let _e187 = (_e182 >> bitcast<u32>(24i));
            let _e191 = (_e182 & 16777215u);
            let _e195 = params.member.member_2.member;
            let _e198 = params.member.member_2.member_1;
            if (_e198 == 0u) {
                phi_343_ = array<u32, 2>(0u, 2u);
            } else {
                phi_343_ = array<u32, 2>(1u, 1u);
            }
            let _e201 = phi_343_;
            if (_e195 == 2u) {
                phi_350_ = 8u;
            } else {
                phi_350_ = 1u;
            }
            let _e206 = phi_350_;
            if (_e195 == 2u) {
                phi_355_ = 10u;
            } else {
                phi_355_ = 1u;
            }
            let _e209 = phi_355_;
            if (_e187 >= (_e206 * _e209)) {
                phi_363_ = array<u32, 2>(_e201[1], _e201[0]);
            } else {
                phi_363_ = _e201;
            }
            let _e214 = phi_363_;
            let _e217 = ((_e191 * 128u) + _e96);
            let _e221 = params.member.member.member_2[_e214[0]];
            let _e222 = (_e221 + _e217);
            let _e226 = params.member.member.member[_e214[0]];
            let _e227 = (_e217 < _e226);
            if _e227 {
                let _e230 = params.member.member_2.member;
                let _e233 = params.member.member_2.member_1;
                if (_e233 == 0u) {
                    phi_401_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_401_ = array<u32, 2>(1u, 1u);
                }
                let _e236 = phi_401_;
                if (_e230 == 2u) {
                    phi_408_ = 8u;
                } else {
                    phi_408_ = 1u;
                }
                let _e241 = phi_408_;
                if (_e230 == 2u) {
                    phi_413_ = 10u;
                } else {
                    phi_413_ = 1u;
                }
                let _e244 = phi_413_;
                if (_e187 >= (_e241 * _e244)) {
                    phi_421_ = array<u32, 2>(_e236[1], _e236[0]);
                } else {
                    phi_421_ = _e236;
                }
                let _e249 = phi_421_;
                let _e252 = keys.member[_e222];
                let _e254 = sorted.member[_e222];
                local_7 = type_18(array<f32, 3>(_e254.member[0], _e254.member[1], _e254.member[2]), array<f32, 3>(_e254.member_1[0], _e254.member_1[1], _e254.member_1[2]));
                if (_e230 == 2u) {
                    phi_464_ = ((_e187 % 80u) / 10u);
                } else {
                    phi_464_ = 0u;
                }
                let _e270 = phi_464_;
                if (_e270 == 0u) {
                    if (_e230 == 2u) {
                        phi_473_ = 8u;
                    } else {
                        phi_473_ = 1u;
                    }
                    let _e274 = phi_473_;
                    if (_e230 == 2u) {
                        phi_478_ = 10u;
                    } else {
                        phi_478_ = 1u;
                    }
                    let _e277 = phi_478_;
                    phi_481_ = (_e187 >= (_e274 * _e277));
                } else {
                    phi_481_ = false;
                }
                let _e281 = phi_481_;
                if (_e230 != 2u) {
                    phi_498_ = u32();
                    phi_499_ = true;
                } else {
                    if _e281 {
                        phi_497_ = u32();
                    } else {
                        let _e286 = (((_e252 >> bitcast<u32>(27u)) % 8u) + _e270);
                        if (_e286 < 8u) {
                            phi_496_ = _e286;
                        } else {
                            phi_496_ = 8u;
                        }
                        let _e289 = phi_496_;
                        phi_497_ = _e289;
                    }
                    let _e291 = phi_497_;
                    phi_498_ = _e291;
                    phi_499_ = _e281;
                }
                let _e293 = phi_498_;
                let _e295 = phi_499_;
                if _e295 {
                    phi_503_ = 8u;
                } else {
                    phi_503_ = _e293;
                }
                let _e297 = phi_503_;
                if (_e297 < 8u) {
                    let _e303 = ((_e249[1] << bitcast<u32>(30u)) + (_e297 << bitcast<u32>(27u)));
                    let _e307 = params.member.member.member_2[3u];
                    phi_520_ = type_15(0i, 32i);
                    phi_523_ = 0u;
                    phi_525_ = _e307;
                    loop {
                        let _e310 = phi_520_;
                        let _e312 = phi_523_;
                        let _e314 = phi_525_;
                        local_8 = _e312;
                        if (_e310.member < _e310.member_1) {
                            let _e321 = (_e310.member + 1i);
                            if ((false == (_e321 > _e310.member)) != false) {
                                phi_546_ = true;
                            } else {
                                phi_546_ = false;
                            }
                            let _e326 = phi_546_;
                            if _e326 {
                                phi_552_ = type_16(0u, type_16().member_1);
                            } else {
                                phi_552_ = type_16(1u, _e321);
                            }
                            let _e331 = phi_552_;
                            phi_521_ = type_15(_e331.member_1, _e310.member_1);
                            phi_566_ = type_16(1u, _e310.member);
                        } else {
                            phi_521_ = _e310;
                            phi_566_ = type_16(0u, type_16().member_1);
                        }
                        let _e337 = phi_521_;
                        let _e339 = phi_566_;
                        if (bitcast<i32>(_e339.member) != 0i) {
                            if (_e312 >= _e314) {
                                phi_597_ = u32();
                                phi_598_ = u32();
                                phi_599_ = false;
                            } else {
                                let _e346 = (_e312 + ((_e314 - _e312) / 2u));
                                let _e348 = keys.member[_e346];
                                if (_e348 < (_e303 + 134217728u)) {
                                    phi_595_ = (_e346 + 1u);
                                    phi_596_ = _e314;
                                } else {
                                    phi_595_ = _e312;
                                    phi_596_ = _e346;
                                }
                                let _e352 = phi_595_;
                                let _e354 = phi_596_;
                                phi_597_ = _e352;
                                phi_598_ = _e354;
                                phi_599_ = true;
                            }
                            let _e356 = phi_597_;
                            let _e358 = phi_598_;
                            let _e360 = phi_599_;
                            phi_524_ = _e356;
                            phi_526_ = _e358;
                            phi_600_ = _e360;
                        } else {
                            phi_524_ = u32();
                            phi_526_ = u32();
                            phi_600_ = false;
                        }
                        let _e362 = phi_524_;
                        let _e364 = phi_526_;
                        let _e366 = phi_600_;
                        continue;
                        continuing {
                            phi_520_ = _e337;
                            phi_523_ = _e362;
                            phi_525_ = _e364;
                            break if !(_e366);
                        }
                    }
                    phi_605_ = type_15(0i, 32i);
                    phi_608_ = 0u;
                    phi_610_ = _e307;
                    loop {
                        let _e369 = phi_605_;
                        let _e371 = phi_608_;
                        let _e373 = phi_610_;
                        local_9 = _e371;
                        if (_e369.member < _e369.member_1) {
                            let _e380 = (_e369.member + 1i);
                            if ((false == (_e380 > _e369.member)) != false) {
                                phi_631_ = true;
                            } else {
                                phi_631_ = false;
                            }
                            let _e385 = phi_631_;
                            if _e385 {
                                phi_637_ = type_16(0u, type_16().member_1);
                            } else {
                                phi_637_ = type_16(1u, _e380);
                            }
                            let _e390 = phi_637_;
                            phi_606_ = type_15(_e390.member_1, _e369.member_1);
                            phi_651_ = type_16(1u, _e369.member);
                        } else {
                            phi_606_ = _e369;
                            phi_651_ = type_16(0u, type_16().member_1);
                        }
                        let _e396 = phi_606_;
                        let _e398 = phi_651_;
                        if (bitcast<i32>(_e398.member) != 0i) {
                            if (_e371 >= _e373) {
                                phi_682_ = u32();
                                phi_683_ = u32();
                                phi_684_ = false;
                            } else {
                                let _e405 = (_e371 + ((_e373 - _e371) / 2u));
                                let _e407 = keys.member[_e405];
                                if (_e407 < _e303) {
                                    phi_680_ = (_e405 + 1u);
                                    phi_681_ = _e373;
                                } else {
                                    phi_680_ = _e371;
                                    phi_681_ = _e405;
                                }
                                let _e411 = phi_680_;
                                let _e413 = phi_681_;
                                phi_682_ = _e411;
                                phi_683_ = _e413;
                                phi_684_ = true;
                            }
                            let _e415 = phi_682_;
                            let _e417 = phi_683_;
                            let _e419 = phi_684_;
                            phi_609_ = _e415;
                            phi_611_ = _e417;
                            phi_685_ = _e419;
                        } else {
                            phi_609_ = u32();
                            phi_611_ = u32();
                            phi_685_ = false;
                        }
                        let _e421 = phi_609_;
                        let _e423 = phi_611_;
                        let _e425 = phi_685_;
                        continue;
                        continuing {
                            phi_605_ = _e396;
                            phi_608_ = _e421;
                            phi_610_ = _e423;
                            break if !(_e425);
                        }
                    }
                    let _e428 = local_8;
                    let _e430 = local_9;
                    phi_687_ = (_e428 - _e430);
                } else {
                    phi_687_ = 0u;
                }
                let _e433 = phi_687_;
                if (_e230 != 2u) {
                    phi_715_ = true;
                } else {
                    if (_e433 == 0u) {
                        phi_704_ = array<u32, 2>(0u, 0u);
                    } else {
                        if (_e433 <= 256u) {
                            phi_703_ = array<u32, 2>(9u, 10u);
                        } else {
                            phi_703_ = array<u32, 2>(0u, 9u);
                        }
                        let _e438 = phi_703_;
                        phi_704_ = _e438;
                    }
                    let _e440 = phi_704_;
                    let _e444 = ((_e187 % 80u) % 10u);
                    if (_e440[0] <= _e444) {
                        phi_714_ = (_e444 < _e440[1]);
                    } else {
                        phi_714_ = false;
                    }
                    let _e448 = phi_714_;
                    phi_715_ = _e448;
                }
                let _e450 = phi_715_;
                if _e450 {
                    if (_e230 == 2u) {
                        let _e453 = survey.member[6u];
                        if ((_e453 >> bitcast<u32>(31i)) == 1u) {
                            phi_742_ = (_e453 & 2147483647u);
                        } else {
                            phi_742_ = ~(_e453);
                        }
                        let _e460 = phi_742_;
                        let _e461 = bitcast<f32>(_e460);
                        let _e463 = survey.member[7u];
                        if ((_e463 >> bitcast<u32>(31i)) == 1u) {
                            phi_761_ = (_e463 & 2147483647u);
                        } else {
                            phi_761_ = ~(_e463);
                        }
                        let _e470 = phi_761_;
                        let _e471 = bitcast<f32>(_e470);
                        let _e473 = survey.member[8u];
                        if ((_e473 >> bitcast<u32>(31i)) == 1u) {
                            phi_780_ = (_e473 & 2147483647u);
                        } else {
                            phi_780_ = ~(_e473);
                        }
                        let _e480 = phi_780_;
                        let _e481 = bitcast<f32>(_e480);
                        local_5 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_785_ = type_9(0u, 3u);
                        loop {
                            let _e483 = phi_785_;
                            if (_e483.member < _e483.member_1) {
                                phi_786_ = type_9((_e483.member + 1u), _e483.member_1);
                                phi_809_ = type_9(1u, _e483.member);
                            } else {
                                phi_786_ = _e483;
                                phi_809_ = type_9(0u, type_9().member_1);
                            }
                            let _e495 = phi_786_;
                            let _e497 = phi_809_;
                            let _e501 = (bitcast<i32>(_e497.member) != 0i);
                            if _e501 {
                                let _e503 = survey.member[_e497.member_1];
                                let _e504 = ~(_e503);
                                if ((_e504 >> bitcast<u32>(31i)) == 1u) {
                                    phi_835_ = (_e504 & 2147483647u);
                                } else {
                                    phi_835_ = ~(_e504);
                                }
                                let _e511 = phi_835_;
                                local_5.member[_e497.member_1] = bitcast<f32>(_e511);
                                let _e517 = survey.member[(3u + _e497.member_1)];
                                if ((_e517 >> bitcast<u32>(31i)) == 1u) {
                                    phi_861_ = (_e517 & 2147483647u);
                                } else {
                                    phi_861_ = ~(_e517);
                                }
                                let _e524 = phi_861_;
                                local_5.member_1[_e497.member_1] = bitcast<f32>(_e524);
                            }
                            continue;
                            continuing {
                                phi_785_ = _e495;
                                break if !(_e501);
                            }
                        }
                        let _e529 = local_5;
                        local_6 = type_23(_e529, array<f32, 3>(_e461, _e471, _e481));
                        if (_e270 == 0u) {
                            let _e839 = (_e252 & 134217727u);
                            phi_1388_ = array<u32, 3>((_e839 & 511u), ((_e839 >> bitcast<u32>(9u)) & 511u), (_e839 >> bitcast<u32>(18u)));
                        } else {
                            let _e550 = local_6.member.member_1[0u];
                            let _e554 = local_6.member.member[0u];
                            let _e559 = local_6.member.member_1[1u];
                            let _e563 = local_6.member.member[1u];
                            let _e568 = local_6.member.member_1[2u];
                            let _e572 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e550 * 0.5f) - (_e554 * 0.5f)), ((_e559 * 0.5f) - (_e563 * 0.5f)), ((_e568 * 0.5f) - (_e572 * 0.5f)));
                            phi_994_ = type_9(0u, 9u);
                            phi_997_ = type_27(type_23(type_18(array<f32, 3>(_e529.member[0], _e529.member[1], _e529.member[2]), array<f32, 3>(_e529.member_1[0], _e529.member_1[1], _e529.member_1[2])), array<f32, 3>(_e461, _e471, _e481)), 0u);
                            loop {
                                let _e577 = phi_994_;
                                let _e579 = phi_997_;
                                local_11 = _e579;
                                local_12 = _e579;
                                local_13 = _e579;
                                local_14 = _e579;
                                local_15 = _e579;
                                local_16 = _e579;
                                local_17 = _e579;
                                if (_e577.member < _e577.member_1) {
                                    phi_995_ = type_9((_e577.member + 1u), _e577.member_1);
                                    phi_1020_ = type_9(1u, _e577.member);
                                } else {
                                    phi_995_ = _e577;
                                    phi_1020_ = type_9(0u, type_9().member_1);
                                }
                                let _e591 = phi_995_;
                                let _e593 = phi_1020_;
                                if (bitcast<i32>(_e593.member) != 0i) {
                                    phi_1030_ = type_9(0u, 3u);
                                    phi_1033_ = true;
                                    loop {
                                        let _e599 = phi_1030_;
                                        let _e601 = phi_1033_;
                                        local_10 = _e601;
                                        if (_e599.member < _e599.member_1) {
                                            phi_1031_ = type_9((_e599.member + 1u), _e599.member_1);
                                            phi_1056_ = type_9(1u, _e599.member);
                                        } else {
                                            phi_1031_ = _e599;
                                            phi_1056_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e613 = phi_1031_;
                                        let _e615 = phi_1056_;
                                        let _e619 = (bitcast<i32>(_e615.member) != 0i);
                                        if _e619 {
                                            let _e621 = local_3[_e615.member_1];
                                            let _e623 = (_e621 * (1f / 512f));
                                            if (_e623 > 0.000000000000000000000000000006310887f) {
                                                phi_1078_ = _e623;
                                            } else {
                                                phi_1078_ = 0.000000000000000000000000000006310887f;
                                            }
                                            let _e626 = phi_1078_;
                                            let _e629 = local_6.member_1[_e615.member_1];
                                            if ((_e629 * bitcast<f32>(((127u - _e593.member_1) << bitcast<u32>(23i)))) > _e626) {
                                                phi_1095_ = false;
                                            } else {
                                                phi_1095_ = _e601;
                                            }
                                            let _e637 = phi_1095_;
                                            phi_1034_ = _e637;
                                        } else {
                                            phi_1034_ = bool();
                                        }
                                        let _e639 = phi_1034_;
                                        continue;
                                        continuing {
                                            phi_1030_ = _e613;
                                            phi_1033_ = _e639;
                                            break if !(_e619);
                                        }
                                    }
                                    let _e642 = local_10;
                                    if _e642 {
                                        phi_1101_ = type_27();
                                        phi_1102_ = false;
                                    } else {
                                        phi_1101_ = type_27(_e579.member, (_e593.member_1 + 1u));
                                        phi_1102_ = true;
                                    }
                                    let _e647 = phi_1101_;
                                    let _e649 = phi_1102_;
                                    phi_998_ = _e647;
                                    phi_1103_ = _e649;
                                } else {
                                    phi_998_ = type_27();
                                    phi_1103_ = false;
                                }
                                let _e651 = phi_998_;
                                let _e653 = phi_1103_;
                                continue;
                                continuing {
                                    phi_994_ = _e591;
                                    phi_997_ = _e651;
                                    break if !(_e653);
                                }
                            }
                            let _e658 = (((_e252 >> bitcast<u32>(27u)) % 8u) + _e270);
                            if (_e658 < 8u) {
                                phi_1111_ = _e658;
                            } else {
                                phi_1111_ = 8u;
                            }
                            let _e661 = phi_1111_;
                            let _e663 = local_11;
                            let _e668 = local_12;
                            if (_e668.member_1 < 8u) {
                                let _e672 = local_13;
                                phi_1121_ = (_e672.member_1 + 1u);
                            } else {
                                phi_1121_ = 8u;
                            }
                            let _e676 = phi_1121_;
                            if ((_e661 + 1u) >= _e676) {
                                phi_1128_ = 0u;
                            } else {
                                let _e679 = local_14;
                                phi_1128_ = (_e679.member_1 - _e661);
                            }
                            let _e683 = phi_1128_;
                            let _e687 = bitcast<f32>(((127u - _e683) << bitcast<u32>(23i)));
                            let _e689 = local_15;
                            let _e695 = local_16;
                            let _e701 = local_17;
                            local_2.member = type_18(array<f32, 3>(_e663.member.member.member[0], _e663.member.member.member[1], _e663.member.member.member[2]), array<f32, 3>(_e663.member.member.member_1[0], _e663.member.member.member_1[1], _e663.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e689.member.member_1[0] * _e687), (_e695.member.member_1[1] * _e687), (_e701.member.member_1[2] * _e687));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_1160_ = type_9(0u, 3u);
                            loop {
                                let _e723 = phi_1160_;
                                if (_e723.member < _e723.member_1) {
                                    phi_1161_ = type_9((_e723.member + 1u), _e723.member_1);
                                    phi_1184_ = type_9(1u, _e723.member);
                                } else {
                                    phi_1161_ = _e723;
                                    phi_1184_ = type_9(0u, type_9().member_1);
                                }
                                let _e735 = phi_1161_;
                                let _e737 = phi_1184_;
                                let _e741 = (bitcast<i32>(_e737.member) != 0i);
                                if _e741 {
                                    let _e745 = local_2.member.member[_e737.member_1];
                                    let _e749 = local_2.member.member_1[_e737.member_1];
                                    let _e754 = (((_e749 * 0.5f) - (_e745 * 0.5f)) * (1f / 512f));
                                    let _e757 = local_2.member_1[_e737.member_1];
                                    let _e760 = local_2.member_1[_e737.member_1];
                                    let _e762 = (_e757 + (_e760 * 0.00390625f));
                                    if (_e754 > _e762) {
                                        phi_1235_ = _e754;
                                    } else {
                                        phi_1235_ = _e762;
                                    }
                                    let _e765 = phi_1235_;
                                    if (0.000000000000000000000000000006310887f > _e765) {
                                        phi_1240_ = 0.000000000000000000000000000006310887f;
                                    } else {
                                        phi_1240_ = _e765;
                                    }
                                    let _e768 = phi_1240_;
                                    local_1.member[_e737.member_1] = (_e745 * 0.25f);
                                    local_1.member_1[_e737.member_1] = (1f / _e768);
                                }
                                continue;
                                continuing {
                                    phi_1160_ = _e735;
                                    break if !(_e741);
                                }
                            }
                            let _e776 = local_1;
                            local_4 = _e776;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1281_ = type_9(0u, 3u);
                            loop {
                                let _e778 = phi_1281_;
                                if (_e778.member < _e778.member_1) {
                                    phi_1282_ = type_9((_e778.member + 1u), _e778.member_1);
                                    phi_1305_ = type_9(1u, _e778.member);
                                } else {
                                    phi_1282_ = _e778;
                                    phi_1305_ = type_9(0u, type_9().member_1);
                                }
                                let _e790 = phi_1282_;
                                let _e792 = phi_1305_;
                                let _e796 = (bitcast<i32>(_e792.member) != 0i);
                                if _e796 {
                                    let _e799 = local_4.member[_e792.member_1];
                                    let _e802 = local_7.member[_e792.member_1];
                                    let _e804 = ((_e802 * 0.25f) - _e799);
                                    if (_e804 > 0f) {
                                        phi_1333_ = _e804;
                                    } else {
                                        phi_1333_ = 0f;
                                    }
                                    let _e807 = phi_1333_;
                                    let _e810 = local_7.member_1[_e792.member_1];
                                    let _e812 = ((_e810 * 0.25f) - _e799);
                                    if (_e812 > 0f) {
                                        phi_1348_ = _e812;
                                    } else {
                                        phi_1348_ = 0f;
                                    }
                                    let _e815 = phi_1348_;
                                    let _e819 = local_4.member_1[_e792.member_1];
                                    let _e820 = ((_e807 + _e815) * _e819);
                                    if (_e820 >= 511f) {
                                        phi_1376_ = 511u;
                                    } else {
                                        if (_e820 > 0f) {
                                            phi_1375_ = select(select(u32(_e820), 0u, (_e820 < 0f)), 4294967295u, (_e820 > 4294967000f));
                                        } else {
                                            phi_1375_ = 0u;
                                        }
                                        let _e829 = phi_1375_;
                                        phi_1376_ = _e829;
                                    }
                                    let _e831 = phi_1376_;
                                    local[_e792.member_1] = _e831;
                                }
                                continue;
                                continuing {
                                    phi_1281_ = _e790;
                                    break if !(_e796);
                                }
                            }
                            let _e834 = local;
                            phi_1388_ = array<u32, 3>(_e834[0], _e834[1], _e834[2]);
                        }
                        let _e848 = phi_1388_;
                        phi_1389_ = _e848;
                    } else {
                        phi_1389_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e850 = phi_1389_;
                    let _e852 = (_e249[1] << bitcast<u32>(30u));
                    if (_e230 == 1u) {
                        let _e974 = survey.member[6u];
                        if (_e974 == 0u) {
                            let _e984 = local_7.member_1[0u];
                            phi_1426_ = _e984;
                        } else {
                            if (_e974 == 1u) {
                                let _e980 = local_7.member_1[1u];
                                phi_1425_ = _e980;
                            } else {
                                let _e978 = local_7.member_1[2u];
                                phi_1425_ = _e978;
                            }
                            let _e982 = phi_1425_;
                            phi_1426_ = _e982;
                        }
                        let _e986 = phi_1426_;
                        let _e987 = bitcast<u32>(_e986);
                        if (_e987 == 2147483648u) {
                            phi_1432_ = 0u;
                        } else {
                            phi_1432_ = _e987;
                        }
                        let _e990 = phi_1432_;
                        let _e992 = bitcast<u32>(bitcast<f32>(_e990));
                        if ((_e992 >> bitcast<u32>(31i)) == 1u) {
                            phi_1442_ = ~(_e992);
                        } else {
                            phi_1442_ = (_e992 | 2147483648u);
                        }
                        let _e999 = phi_1442_;
                        phi_1589_ = array<u32, 2>(((_e852 | (_e252 & 1073741823u)) + _e187), (_e852 | (_e999 >> bitcast<u32>(2i))));
                    } else {
                        if (_e230 == 2u) {
                            let _e856 = (_e187 % 80u);
                            let _e858 = (_e856 % 10u);
                            if (_e233 == 1u) {
                                phi_1458_ = ((_e856 / 10u) == 0u);
                            } else {
                                phi_1458_ = false;
                            }
                            let _e862 = phi_1458_;
                            if (_e297 >= 8u) {
                                phi_1575_ = array<u32, 2>();
                                phi_1576_ = true;
                            } else {
                                if _e862 {
                                    if (_e858 < 4u) {
                                        phi_1470_ = false;
                                    } else {
                                        phi_1470_ = true;
                                    }
                                    let _e866 = phi_1470_;
                                    phi_1471_ = _e866;
                                } else {
                                    phi_1471_ = true;
                                }
                                let _e868 = phi_1471_;
                                if _e868 {
                                    if (_e858 == 9u) {
                                        phi_1565_ = array<u32, 2>(0u, 134217727u);
                                    } else {
                                        let _e872 = (_e850[1] + (_e858 % 3u));
                                        let _e875 = (_e850[2] + (_e858 / 3u));
                                        if (_e872 < 1u) {
                                            phi_1558_ = array<u32, 2>();
                                            phi_1559_ = true;
                                        } else {
                                            if (_e875 < 1u) {
                                                phi_1556_ = array<u32, 2>();
                                                phi_1557_ = true;
                                            } else {
                                                if (_e872 > 512u) {
                                                    phi_1554_ = array<u32, 2>();
                                                    phi_1555_ = true;
                                                } else {
                                                    let _e879 = (_e875 > 512u);
                                                    if _e879 {
                                                        phi_1553_ = array<u32, 2>();
                                                    } else {
                                                        if (_e850[0] > 0u) {
                                                            if _e862 {
                                                                if (_e858 == 4u) {
                                                                    phi_1514_ = false;
                                                                } else {
                                                                    phi_1514_ = true;
                                                                }
                                                                let _e884 = phi_1514_;
                                                                phi_1515_ = _e884;
                                                            } else {
                                                                phi_1515_ = true;
                                                            }
                                                            let _e886 = phi_1515_;
                                                            if _e886 {
                                                                phi_1521_ = (_e850[0] - 1u);
                                                                phi_1522_ = false;
                                                            } else {
                                                                phi_1521_ = u32();
                                                                phi_1522_ = true;
                                                            }
                                                            let _e890 = phi_1521_;
                                                            let _e892 = phi_1522_;
                                                            phi_1523_ = _e890;
                                                            phi_1524_ = _e892;
                                                        } else {
                                                            phi_1523_ = u32();
                                                            phi_1524_ = true;
                                                        }
                                                        let _e894 = phi_1523_;
                                                        let _e896 = phi_1524_;
                                                        if _e896 {
                                                            phi_1529_ = _e850[0];
                                                        } else {
                                                            phi_1529_ = _e894;
                                                        }
                                                        let _e899 = phi_1529_;
                                                        if ((_e850[0] + 1u) < 512u) {
                                                            phi_1539_ = (_e850[0] + 1u);
                                                        } else {
                                                            phi_1539_ = _e850[0];
                                                        }
                                                        let _e907 = phi_1539_;
                                                        phi_1553_ = array<u32, 2>(((((_e875 - 1u) << bitcast<u32>(18u)) | ((_e872 - 1u) << bitcast<u32>(9u))) | _e899), ((((_e875 - 1u) << bitcast<u32>(18u)) | ((_e872 - 1u) << bitcast<u32>(9u))) | _e907));
                                                    }
                                                    let _e926 = phi_1553_;
                                                    phi_1554_ = _e926;
                                                    phi_1555_ = _e879;
                                                }
                                                let _e928 = phi_1554_;
                                                let _e930 = phi_1555_;
                                                phi_1556_ = _e928;
                                                phi_1557_ = _e930;
                                            }
                                            let _e932 = phi_1556_;
                                            let _e934 = phi_1557_;
                                            phi_1558_ = _e932;
                                            phi_1559_ = _e934;
                                        }
                                        let _e936 = phi_1558_;
                                        let _e938 = phi_1559_;
                                        if _e938 {
                                            phi_1564_ = array<u32, 2>(1u, 0u);
                                        } else {
                                            phi_1564_ = _e936;
                                        }
                                        let _e940 = phi_1564_;
                                        phi_1565_ = _e940;
                                    }
                                    let _e942 = phi_1565_;
                                    phi_1573_ = array<u32, 2>(((_e297 << bitcast<u32>(27u)) | _e942[0]), ((_e297 << bitcast<u32>(27u)) | _e942[1]));
                                    phi_1574_ = false;
                                } else {
                                    phi_1573_ = array<u32, 2>();
                                    phi_1574_ = true;
                                }
                                let _e953 = phi_1573_;
                                let _e955 = phi_1574_;
                                phi_1575_ = _e953;
                                phi_1576_ = _e955;
                            }
                            let _e957 = phi_1575_;
                            let _e959 = phi_1576_;
                            if _e959 {
                                phi_1581_ = array<u32, 2>(1u, 0u);
                            } else {
                                phi_1581_ = _e957;
                            }
                            let _e961 = phi_1581_;
                            phi_1588_ = array<u32, 2>((_e852 | _e961[0]), (_e852 | _e961[1]));
                        } else {
                            phi_1588_ = array<u32, 2>(_e852, _e852);
                        }
                        let _e968 = phi_1588_;
                        phi_1589_ = _e968;
                    }
                    let _e1005 = phi_1589_;
                    if (_e233 == 1u) {
                        phi_1597_ = (_e222 + 1u);
                    } else {
                        phi_1597_ = 0u;
                    }
                    let _e1011 = phi_1597_;
                    phi_1600_ = array<u32, 3>(_e1005[0], _e1005[1], _e1011);
                } else {
                    phi_1600_ = array<u32, 3>(4294967295u, 0u, 0u);
                }
                let _e1014 = phi_1600_;
                phi_1602_ = _e1014;
            } else {
                phi_1602_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e1016 = phi_1602_;
            if _e227 {
                let _e1021 = sorted.member[_e222];
                phi_1619_ = _e1021;
            } else {
                phi_1619_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e1023 = phi_1619_;
            phi_1622_ = type_9(0u, ((_e185 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e1026 = phi_1622_;
                if (_e1026.member < _e1026.member_1) {
                    phi_1623_ = type_9((_e1026.member + 1u), _e1026.member_1);
                    phi_1646_ = type_9(1u, _e1026.member);
                } else {
                    phi_1623_ = _e1026;
                    phi_1646_ = type_9(0u, type_9().member_1);
                }
                let _e1038 = phi_1623_;
                let _e1040 = phi_1646_;
                let _e1044 = (bitcast<i32>(_e1040.member) != 0i);
                if _e1044 {
                    let _e1046 = ((_e185 & 536870911u) + (_e1040.member_1 * 128u));
                    let _e1047 = (_e1046 + _e96);
                    if (_e1047 < _e136) {
                        let _e1050 = keys.member[_e1047];
                        let _e1052 = sorted.member[_e1047];
                        phi_1681_ = _e1052;
                        phi_1682_ = _e1050;
                    } else {
                        phi_1681_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1682_ = 4294967295u;
                    }
                    let _e1054 = phi_1681_;
                    let _e1056 = phi_1682_;
                    names[_e96] = _e1056;
                    boxes[_e96] = type_18(array<f32, 3>(_e1054.member[0], _e1054.member[1], _e1054.member[2]), array<f32, 3>(_e1054.member_1[0], _e1054.member_1[1], _e1054.member_1[2]));
                    if (_e96 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1703_ = type_9(0u, 128u);
                    loop {
                        let _e1073 = phi_1703_;
                        if (_e1073.member < _e1073.member_1) {
                            phi_1704_ = type_9((_e1073.member + 1u), _e1073.member_1);
                            phi_1727_ = type_9(1u, _e1073.member);
                        } else {
                            phi_1704_ = _e1073;
                            phi_1727_ = type_9(0u, type_9().member_1);
                        }
                        let _e1085 = phi_1704_;
                        let _e1087 = phi_1727_;
                        let _e1091 = (bitcast<i32>(_e1087.member) != 0i);
                        if _e1091 {
                            let _e1093 = names[_e1087.member_1];
                            if (_e1093 >= _e1016[0]) {
                                if (_e1093 <= _e1016[1]) {
                                    if ((_e1046 + _e1087.member_1) >= _e1016[2]) {
                                        let _e1099 = boxes[_e1087.member_1];
                                        if ((((((_e1023.member[0] <= _e1099.member_1[0]) && (_e1099.member[0] <= _e1023.member_1[0])) && (_e1023.member[1] <= _e1099.member_1[1])) && (_e1099.member[1] <= _e1023.member_1[1])) && (_e1023.member[2] <= _e1099.member_1[2])) && (_e1099.member[2] <= _e1023.member_1[2])) {
                                            let _e1132 = atomicAdd((&counters[0u]), 1u);
                                            if (_e1132 < 2048u) {
                                                hits[_e1132] = ((_e96 << bitcast<u32>(7i)) | _e1087.member_1);
                                            } else {
                                                let _e1136 = order.member[_e222];
                                                let _e1138 = order.member[(_e1046 + _e1087.member_1)];
                                                let _e1141 = params.member.member_2.member_1;
                                                if (_e1141 == 1u) {
                                                    let _e1171 = params.member.member.member_2[1u];
                                                    let _e1172 = (_e1136 - _e1171);
                                                    let _e1176 = params.member.member.member_2[1u];
                                                    let _e1177 = (_e1138 - _e1176);
                                                    if (_e1172 < _e1177) {
                                                        phi_1840_ = type_9(_e1172, _e1177);
                                                    } else {
                                                        phi_1840_ = type_9(_e1177, _e1172);
                                                    }
                                                    let _e1182 = phi_1840_;
                                                    phi_1873_ = _e1182;
                                                } else {
                                                    let _e1145 = params.member.member_2.member;
                                                    if (_e1145 == 2u) {
                                                        phi_1851_ = 8u;
                                                    } else {
                                                        phi_1851_ = 1u;
                                                    }
                                                    let _e1148 = phi_1851_;
                                                    if (_e1145 == 2u) {
                                                        phi_1856_ = 10u;
                                                    } else {
                                                        phi_1856_ = 1u;
                                                    }
                                                    let _e1151 = phi_1856_;
                                                    if (_e187 >= (_e1148 * _e1151)) {
                                                        let _e1163 = params.member.member.member_2[2u];
                                                        phi_1872_ = type_9(_e1138, (_e1136 - _e1163));
                                                    } else {
                                                        let _e1157 = params.member.member.member_2[2u];
                                                        phi_1872_ = type_9(_e1136, (_e1138 - _e1157));
                                                    }
                                                    let _e1167 = phi_1872_;
                                                    phi_1873_ = _e1167;
                                                }
                                                let _e1184 = phi_1873_;
                                                let _e1189 = params.member.member_1.member_3;
                                                let _e1191 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1191 + 1u) < _e1191) {
                                                    let _e1195 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1191 < _e1189) {
                                                    let _e1197 = (2u * _e1191);
                                                    atomicStore((&pairs.member[(4u + _e1197)]), _e1184.member);
                                                    atomicStore((&pairs.member[(_e1197 + 5u)]), _e1184.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1703_ = _e1085;
                            break if !(_e1091);
                        }
                    }
                    workgroupBarrier();
                    let _e1208 = atomicLoad((&counters[0u]));
                    if (2048u < _e1208) {
                        phi_1908_ = 2048u;
                    } else {
                        phi_1908_ = _e1208;
                    }
                    let _e1211 = phi_1908_;
                    if (_e96 == 0u) {
                        if (_e1211 > 0u) {
                            let _e1215 = atomicAdd((&pairs.member[0u]), _e1211);
                            if ((_e1215 + _e1211) < _e1215) {
                                let _e1219 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1215);
                        }
                    }
                    workgroupBarrier();
                    let _e1222 = atomicLoad((&counters[1u]));
                    phi_1934_ = type_9(0u, 16u);
                    loop {
                        let _e1224 = phi_1934_;
                        if (_e1224.member < _e1224.member_1) {
                            phi_1935_ = type_9((_e1224.member + 1u), _e1224.member_1);
                            phi_1958_ = type_9(1u, _e1224.member);
                        } else {
                            phi_1935_ = _e1224;
                            phi_1958_ = type_9(0u, type_9().member_1);
                        }
                        let _e1236 = phi_1935_;
                        let _e1238 = phi_1958_;
                        if (bitcast<i32>(_e1238.member) != 0i) {
                            let _e1244 = ((_e1238.member_1 * 128u) + _e96);
                            if (_e1244 >= _e1211) {
                                phi_2123_ = false;
                            } else {
                                let _e1247 = hits[_e1244];
                                let _e1252 = params.member.member_2.member;
                                let _e1255 = params.member.member_2.member_1;
                                if (_e1255 == 0u) {
                                    phi_1989_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1989_ = array<u32, 2>(1u, 1u);
                                }
                                let _e1258 = phi_1989_;
                                if (_e1252 == 2u) {
                                    phi_1996_ = 8u;
                                } else {
                                    phi_1996_ = 1u;
                                }
                                let _e1263 = phi_1996_;
                                if (_e1252 == 2u) {
                                    phi_2001_ = 10u;
                                } else {
                                    phi_2001_ = 1u;
                                }
                                let _e1266 = phi_2001_;
                                if (_e187 >= (_e1263 * _e1266)) {
                                    phi_2009_ = array<u32, 2>(_e1258[1], _e1258[0]);
                                } else {
                                    phi_2009_ = _e1258;
                                }
                                let _e1271 = phi_2009_;
                                let _e1278 = params.member.member.member_2[_e1271[0]];
                                let _e1283 = order.member[(_e1278 + ((_e191 * 128u) + (_e1247 >> bitcast<u32>(7i))))];
                                let _e1285 = order.member[(_e1046 + (_e1247 % 128u))];
                                let _e1288 = params.member.member_2.member_1;
                                if (_e1288 == 1u) {
                                    let _e1318 = params.member.member.member_2[1u];
                                    let _e1319 = (_e1283 - _e1318);
                                    let _e1323 = params.member.member.member_2[1u];
                                    let _e1324 = (_e1285 - _e1323);
                                    if (_e1319 < _e1324) {
                                        phi_2072_ = type_9(_e1319, _e1324);
                                    } else {
                                        phi_2072_ = type_9(_e1324, _e1319);
                                    }
                                    let _e1329 = phi_2072_;
                                    phi_2105_ = _e1329;
                                } else {
                                    let _e1292 = params.member.member_2.member;
                                    if (_e1292 == 2u) {
                                        phi_2083_ = 8u;
                                    } else {
                                        phi_2083_ = 1u;
                                    }
                                    let _e1295 = phi_2083_;
                                    if (_e1292 == 2u) {
                                        phi_2088_ = 10u;
                                    } else {
                                        phi_2088_ = 1u;
                                    }
                                    let _e1298 = phi_2088_;
                                    if (_e187 >= (_e1295 * _e1298)) {
                                        let _e1310 = params.member.member.member_2[2u];
                                        phi_2104_ = type_9(_e1285, (_e1283 - _e1310));
                                    } else {
                                        let _e1304 = params.member.member.member_2[2u];
                                        phi_2104_ = type_9(_e1283, (_e1285 - _e1304));
                                    }
                                    let _e1314 = phi_2104_;
                                    phi_2105_ = _e1314;
                                }
                                let _e1331 = phi_2105_;
                                let _e1336 = params.member.member_1.member_3;
                                let _e1337 = (_e1222 + _e1244);
                                if (_e1337 < _e1336) {
                                    let _e1339 = (2u * _e1337);
                                    atomicStore((&pairs.member[(4u + _e1339)]), _e1331.member);
                                    atomicStore((&pairs.member[(_e1339 + 5u)]), _e1331.member_1);
                                }
                                phi_2123_ = true;
                            }
                            let _e1345 = phi_2123_;
                            phi_2124_ = _e1345;
                        } else {
                            phi_2124_ = false;
                        }
                        let _e1347 = phi_2124_;
                        continue;
                        continuing {
                            phi_1934_ = _e1236;
                            break if !(_e1347);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1622_ = _e1038;
                    break if !(_e1044);
                }
            }
        }
        continue;
        continuing {
            phi_263_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
