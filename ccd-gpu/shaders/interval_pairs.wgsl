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
    var phi_1365_: u32;
    var phi_1366_: u32;
    var phi_1378_: array<u32, 3>;
    var phi_1379_: array<u32, 3>;
    var phi_1448_: bool;
    var phi_1460_: bool;
    var phi_1461_: bool;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1511_: u32;
    var phi_1512_: bool;
    var phi_1513_: u32;
    var phi_1514_: bool;
    var phi_1519_: u32;
    var phi_1529_: u32;
    var phi_1543_: array<u32, 2>;
    var phi_1544_: array<u32, 2>;
    var phi_1545_: bool;
    var phi_1546_: array<u32, 2>;
    var phi_1547_: bool;
    var phi_1548_: array<u32, 2>;
    var phi_1549_: bool;
    var phi_1554_: array<u32, 2>;
    var phi_1555_: array<u32, 2>;
    var phi_1563_: array<u32, 2>;
    var phi_1564_: bool;
    var phi_1565_: array<u32, 2>;
    var phi_1566_: bool;
    var phi_1571_: array<u32, 2>;
    var phi_1578_: array<u32, 2>;
    var phi_1415_: f32;
    var phi_1416_: f32;
    var phi_1422_: u32;
    var phi_1432_: u32;
    var phi_1579_: array<u32, 2>;
    var phi_1587_: u32;
    var phi_1590_: array<u32, 3>;
    var phi_1592_: array<u32, 3>;
    var phi_1609_: type_18;
    var phi_1612_: type_9;
    var phi_1613_: type_9;
    var phi_1636_: type_9;
    var phi_1671_: type_18;
    var phi_1672_: u32;
    var phi_1693_: type_9;
    var phi_1694_: type_9;
    var phi_1717_: type_9;
    var phi_1841_: u32;
    var phi_1846_: u32;
    var phi_1862_: type_9;
    var phi_1830_: type_9;
    var phi_1863_: type_9;
    var phi_1898_: u32;
    var phi_1924_: type_9;
    var phi_1925_: type_9;
    var phi_1948_: type_9;
    var phi_1979_: array<u32, 2>;
    var phi_1986_: u32;
    var phi_1991_: u32;
    var phi_1999_: array<u32, 2>;
    var phi_2073_: u32;
    var phi_2078_: u32;
    var phi_2094_: type_9;
    var phi_2062_: type_9;
    var phi_2095_: type_9;
    var phi_2113_: bool;
    var phi_2114_: bool;
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
                            let _e833 = (_e252 & 134217727u);
                            phi_1378_ = array<u32, 3>((_e833 & 511u), ((_e833 >> bitcast<u32>(9u)) & 511u), (_e833 >> bitcast<u32>(18u)));
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
                                    let _e807 = local_7.member_1[_e792.member_1];
                                    let _e813 = local_4.member_1[_e792.member_1];
                                    let _e814 = ((((_e802 * 0.25f) - _e799) + ((_e807 * 0.25f) - _e799)) * _e813);
                                    if (_e814 >= 511f) {
                                        phi_1366_ = 511u;
                                    } else {
                                        if (_e814 > 0f) {
                                            phi_1365_ = select(select(u32(_e814), 0u, (_e814 < 0f)), 4294967295u, (_e814 > 4294967000f));
                                        } else {
                                            phi_1365_ = 0u;
                                        }
                                        let _e823 = phi_1365_;
                                        phi_1366_ = _e823;
                                    }
                                    let _e825 = phi_1366_;
                                    local[_e792.member_1] = _e825;
                                }
                                continue;
                                continuing {
                                    phi_1281_ = _e790;
                                    break if !(_e796);
                                }
                            }
                            let _e828 = local;
                            phi_1378_ = array<u32, 3>(_e828[0], _e828[1], _e828[2]);
                        }
                        let _e842 = phi_1378_;
                        phi_1379_ = _e842;
                    } else {
                        phi_1379_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e844 = phi_1379_;
                    let _e846 = (_e249[1] << bitcast<u32>(30u));
                    if (_e230 == 1u) {
                        let _e968 = survey.member[6u];
                        if (_e968 == 0u) {
                            let _e978 = local_7.member_1[0u];
                            phi_1416_ = _e978;
                        } else {
                            if (_e968 == 1u) {
                                let _e974 = local_7.member_1[1u];
                                phi_1415_ = _e974;
                            } else {
                                let _e972 = local_7.member_1[2u];
                                phi_1415_ = _e972;
                            }
                            let _e976 = phi_1415_;
                            phi_1416_ = _e976;
                        }
                        let _e980 = phi_1416_;
                        let _e981 = bitcast<u32>(_e980);
                        if (_e981 == 2147483648u) {
                            phi_1422_ = 0u;
                        } else {
                            phi_1422_ = _e981;
                        }
                        let _e984 = phi_1422_;
                        let _e986 = bitcast<u32>(bitcast<f32>(_e984));
                        if ((_e986 >> bitcast<u32>(31i)) == 1u) {
                            phi_1432_ = ~(_e986);
                        } else {
                            phi_1432_ = (_e986 | 2147483648u);
                        }
                        let _e993 = phi_1432_;
                        phi_1579_ = array<u32, 2>(((_e846 | (_e252 & 1073741823u)) + _e187), (_e846 | (_e993 >> bitcast<u32>(2i))));
                    } else {
                        if (_e230 == 2u) {
                            let _e850 = (_e187 % 80u);
                            let _e852 = (_e850 % 10u);
                            if (_e233 == 1u) {
                                phi_1448_ = ((_e850 / 10u) == 0u);
                            } else {
                                phi_1448_ = false;
                            }
                            let _e856 = phi_1448_;
                            if (_e297 >= 8u) {
                                phi_1565_ = array<u32, 2>();
                                phi_1566_ = true;
                            } else {
                                if _e856 {
                                    if (_e852 < 4u) {
                                        phi_1460_ = false;
                                    } else {
                                        phi_1460_ = true;
                                    }
                                    let _e860 = phi_1460_;
                                    phi_1461_ = _e860;
                                } else {
                                    phi_1461_ = true;
                                }
                                let _e862 = phi_1461_;
                                if _e862 {
                                    if (_e852 == 9u) {
                                        phi_1555_ = array<u32, 2>(0u, 134217727u);
                                    } else {
                                        let _e866 = (_e844[1] + (_e852 % 3u));
                                        let _e869 = (_e844[2] + (_e852 / 3u));
                                        if (_e866 < 1u) {
                                            phi_1548_ = array<u32, 2>();
                                            phi_1549_ = true;
                                        } else {
                                            if (_e869 < 1u) {
                                                phi_1546_ = array<u32, 2>();
                                                phi_1547_ = true;
                                            } else {
                                                if (_e866 > 512u) {
                                                    phi_1544_ = array<u32, 2>();
                                                    phi_1545_ = true;
                                                } else {
                                                    let _e873 = (_e869 > 512u);
                                                    if _e873 {
                                                        phi_1543_ = array<u32, 2>();
                                                    } else {
                                                        if (_e844[0] > 0u) {
                                                            if _e856 {
                                                                if (_e852 == 4u) {
                                                                    phi_1504_ = false;
                                                                } else {
                                                                    phi_1504_ = true;
                                                                }
                                                                let _e878 = phi_1504_;
                                                                phi_1505_ = _e878;
                                                            } else {
                                                                phi_1505_ = true;
                                                            }
                                                            let _e880 = phi_1505_;
                                                            if _e880 {
                                                                phi_1511_ = (_e844[0] - 1u);
                                                                phi_1512_ = false;
                                                            } else {
                                                                phi_1511_ = u32();
                                                                phi_1512_ = true;
                                                            }
                                                            let _e884 = phi_1511_;
                                                            let _e886 = phi_1512_;
                                                            phi_1513_ = _e884;
                                                            phi_1514_ = _e886;
                                                        } else {
                                                            phi_1513_ = u32();
                                                            phi_1514_ = true;
                                                        }
                                                        let _e888 = phi_1513_;
                                                        let _e890 = phi_1514_;
                                                        if _e890 {
                                                            phi_1519_ = _e844[0];
                                                        } else {
                                                            phi_1519_ = _e888;
                                                        }
                                                        let _e893 = phi_1519_;
                                                        if ((_e844[0] + 1u) < 512u) {
                                                            phi_1529_ = (_e844[0] + 1u);
                                                        } else {
                                                            phi_1529_ = _e844[0];
                                                        }
                                                        let _e901 = phi_1529_;
                                                        phi_1543_ = array<u32, 2>(((((_e869 - 1u) << bitcast<u32>(18u)) | ((_e866 - 1u) << bitcast<u32>(9u))) | _e893), ((((_e869 - 1u) << bitcast<u32>(18u)) | ((_e866 - 1u) << bitcast<u32>(9u))) | _e901));
                                                    }
                                                    let _e920 = phi_1543_;
                                                    phi_1544_ = _e920;
                                                    phi_1545_ = _e873;
                                                }
                                                let _e922 = phi_1544_;
                                                let _e924 = phi_1545_;
                                                phi_1546_ = _e922;
                                                phi_1547_ = _e924;
                                            }
                                            let _e926 = phi_1546_;
                                            let _e928 = phi_1547_;
                                            phi_1548_ = _e926;
                                            phi_1549_ = _e928;
                                        }
                                        let _e930 = phi_1548_;
                                        let _e932 = phi_1549_;
                                        if _e932 {
                                            phi_1554_ = array<u32, 2>(1u, 0u);
                                        } else {
                                            phi_1554_ = _e930;
                                        }
                                        let _e934 = phi_1554_;
                                        phi_1555_ = _e934;
                                    }
                                    let _e936 = phi_1555_;
                                    phi_1563_ = array<u32, 2>(((_e297 << bitcast<u32>(27u)) | _e936[0]), ((_e297 << bitcast<u32>(27u)) | _e936[1]));
                                    phi_1564_ = false;
                                } else {
                                    phi_1563_ = array<u32, 2>();
                                    phi_1564_ = true;
                                }
                                let _e947 = phi_1563_;
                                let _e949 = phi_1564_;
                                phi_1565_ = _e947;
                                phi_1566_ = _e949;
                            }
                            let _e951 = phi_1565_;
                            let _e953 = phi_1566_;
                            if _e953 {
                                phi_1571_ = array<u32, 2>(1u, 0u);
                            } else {
                                phi_1571_ = _e951;
                            }
                            let _e955 = phi_1571_;
                            phi_1578_ = array<u32, 2>((_e846 | _e955[0]), (_e846 | _e955[1]));
                        } else {
                            phi_1578_ = array<u32, 2>(_e846, _e846);
                        }
                        let _e962 = phi_1578_;
                        phi_1579_ = _e962;
                    }
                    let _e999 = phi_1579_;
                    if (_e233 == 1u) {
                        phi_1587_ = (_e222 + 1u);
                    } else {
                        phi_1587_ = 0u;
                    }
                    let _e1005 = phi_1587_;
                    phi_1590_ = array<u32, 3>(_e999[0], _e999[1], _e1005);
                } else {
                    phi_1590_ = array<u32, 3>(4294967295u, 0u, 0u);
                }
                let _e1008 = phi_1590_;
                phi_1592_ = _e1008;
            } else {
                phi_1592_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e1010 = phi_1592_;
            if _e227 {
                let _e1015 = sorted.member[_e222];
                phi_1609_ = _e1015;
            } else {
                phi_1609_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e1017 = phi_1609_;
            phi_1612_ = type_9(0u, ((_e185 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e1020 = phi_1612_;
                if (_e1020.member < _e1020.member_1) {
                    phi_1613_ = type_9((_e1020.member + 1u), _e1020.member_1);
                    phi_1636_ = type_9(1u, _e1020.member);
                } else {
                    phi_1613_ = _e1020;
                    phi_1636_ = type_9(0u, type_9().member_1);
                }
                let _e1032 = phi_1613_;
                let _e1034 = phi_1636_;
                let _e1038 = (bitcast<i32>(_e1034.member) != 0i);
                if _e1038 {
                    let _e1040 = ((_e185 & 536870911u) + (_e1034.member_1 * 128u));
                    let _e1041 = (_e1040 + _e96);
                    if (_e1041 < _e136) {
                        let _e1044 = keys.member[_e1041];
                        let _e1046 = sorted.member[_e1041];
                        phi_1671_ = _e1046;
                        phi_1672_ = _e1044;
                    } else {
                        phi_1671_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1672_ = 4294967295u;
                    }
                    let _e1048 = phi_1671_;
                    let _e1050 = phi_1672_;
                    names[_e96] = _e1050;
                    boxes[_e96] = type_18(array<f32, 3>(_e1048.member[0], _e1048.member[1], _e1048.member[2]), array<f32, 3>(_e1048.member_1[0], _e1048.member_1[1], _e1048.member_1[2]));
                    if (_e96 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1693_ = type_9(0u, 128u);
                    loop {
                        let _e1067 = phi_1693_;
                        if (_e1067.member < _e1067.member_1) {
                            phi_1694_ = type_9((_e1067.member + 1u), _e1067.member_1);
                            phi_1717_ = type_9(1u, _e1067.member);
                        } else {
                            phi_1694_ = _e1067;
                            phi_1717_ = type_9(0u, type_9().member_1);
                        }
                        let _e1079 = phi_1694_;
                        let _e1081 = phi_1717_;
                        let _e1085 = (bitcast<i32>(_e1081.member) != 0i);
                        if _e1085 {
                            let _e1087 = names[_e1081.member_1];
                            if (_e1087 >= _e1010[0]) {
                                if (_e1087 <= _e1010[1]) {
                                    if ((_e1040 + _e1081.member_1) >= _e1010[2]) {
                                        let _e1093 = boxes[_e1081.member_1];
                                        if ((((((_e1017.member[0] <= _e1093.member_1[0]) && (_e1093.member[0] <= _e1017.member_1[0])) && (_e1017.member[1] <= _e1093.member_1[1])) && (_e1093.member[1] <= _e1017.member_1[1])) && (_e1017.member[2] <= _e1093.member_1[2])) && (_e1093.member[2] <= _e1017.member_1[2])) {
                                            let _e1126 = atomicAdd((&counters[0u]), 1u);
                                            if (_e1126 < 2048u) {
                                                hits[_e1126] = ((_e96 << bitcast<u32>(7i)) | _e1081.member_1);
                                            } else {
                                                let _e1130 = order.member[_e222];
                                                let _e1132 = order.member[(_e1040 + _e1081.member_1)];
                                                let _e1135 = params.member.member_2.member_1;
                                                if (_e1135 == 1u) {
                                                    let _e1165 = params.member.member.member_2[1u];
                                                    let _e1166 = (_e1130 - _e1165);
                                                    let _e1170 = params.member.member.member_2[1u];
                                                    let _e1171 = (_e1132 - _e1170);
                                                    if (_e1166 < _e1171) {
                                                        phi_1830_ = type_9(_e1166, _e1171);
                                                    } else {
                                                        phi_1830_ = type_9(_e1171, _e1166);
                                                    }
                                                    let _e1176 = phi_1830_;
                                                    phi_1863_ = _e1176;
                                                } else {
                                                    let _e1139 = params.member.member_2.member;
                                                    if (_e1139 == 2u) {
                                                        phi_1841_ = 8u;
                                                    } else {
                                                        phi_1841_ = 1u;
                                                    }
                                                    let _e1142 = phi_1841_;
                                                    if (_e1139 == 2u) {
                                                        phi_1846_ = 10u;
                                                    } else {
                                                        phi_1846_ = 1u;
                                                    }
                                                    let _e1145 = phi_1846_;
                                                    if (_e187 >= (_e1142 * _e1145)) {
                                                        let _e1157 = params.member.member.member_2[2u];
                                                        phi_1862_ = type_9(_e1132, (_e1130 - _e1157));
                                                    } else {
                                                        let _e1151 = params.member.member.member_2[2u];
                                                        phi_1862_ = type_9(_e1130, (_e1132 - _e1151));
                                                    }
                                                    let _e1161 = phi_1862_;
                                                    phi_1863_ = _e1161;
                                                }
                                                let _e1178 = phi_1863_;
                                                let _e1183 = params.member.member_1.member_3;
                                                let _e1185 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1185 + 1u) < _e1185) {
                                                    let _e1189 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1185 < _e1183) {
                                                    let _e1191 = (2u * _e1185);
                                                    atomicStore((&pairs.member[(4u + _e1191)]), _e1178.member);
                                                    atomicStore((&pairs.member[(_e1191 + 5u)]), _e1178.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1693_ = _e1079;
                            break if !(_e1085);
                        }
                    }
                    workgroupBarrier();
                    let _e1202 = atomicLoad((&counters[0u]));
                    if (2048u < _e1202) {
                        phi_1898_ = 2048u;
                    } else {
                        phi_1898_ = _e1202;
                    }
                    let _e1205 = phi_1898_;
                    if (_e96 == 0u) {
                        if (_e1205 > 0u) {
                            let _e1209 = atomicAdd((&pairs.member[0u]), _e1205);
                            if ((_e1209 + _e1205) < _e1209) {
                                let _e1213 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1209);
                        }
                    }
                    workgroupBarrier();
                    let _e1216 = atomicLoad((&counters[1u]));
                    phi_1924_ = type_9(0u, 16u);
                    loop {
                        let _e1218 = phi_1924_;
                        if (_e1218.member < _e1218.member_1) {
                            phi_1925_ = type_9((_e1218.member + 1u), _e1218.member_1);
                            phi_1948_ = type_9(1u, _e1218.member);
                        } else {
                            phi_1925_ = _e1218;
                            phi_1948_ = type_9(0u, type_9().member_1);
                        }
                        let _e1230 = phi_1925_;
                        let _e1232 = phi_1948_;
                        if (bitcast<i32>(_e1232.member) != 0i) {
                            let _e1238 = ((_e1232.member_1 * 128u) + _e96);
                            if (_e1238 >= _e1205) {
                                phi_2113_ = false;
                            } else {
                                let _e1241 = hits[_e1238];
                                let _e1246 = params.member.member_2.member;
                                let _e1249 = params.member.member_2.member_1;
                                if (_e1249 == 0u) {
                                    phi_1979_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1979_ = array<u32, 2>(1u, 1u);
                                }
                                let _e1252 = phi_1979_;
                                if (_e1246 == 2u) {
                                    phi_1986_ = 8u;
                                } else {
                                    phi_1986_ = 1u;
                                }
                                let _e1257 = phi_1986_;
                                if (_e1246 == 2u) {
                                    phi_1991_ = 10u;
                                } else {
                                    phi_1991_ = 1u;
                                }
                                let _e1260 = phi_1991_;
                                if (_e187 >= (_e1257 * _e1260)) {
                                    phi_1999_ = array<u32, 2>(_e1252[1], _e1252[0]);
                                } else {
                                    phi_1999_ = _e1252;
                                }
                                let _e1265 = phi_1999_;
                                let _e1272 = params.member.member.member_2[_e1265[0]];
                                let _e1277 = order.member[(_e1272 + ((_e191 * 128u) + (_e1241 >> bitcast<u32>(7i))))];
                                let _e1279 = order.member[(_e1040 + (_e1241 % 128u))];
                                let _e1282 = params.member.member_2.member_1;
                                if (_e1282 == 1u) {
                                    let _e1312 = params.member.member.member_2[1u];
                                    let _e1313 = (_e1277 - _e1312);
                                    let _e1317 = params.member.member.member_2[1u];
                                    let _e1318 = (_e1279 - _e1317);
                                    if (_e1313 < _e1318) {
                                        phi_2062_ = type_9(_e1313, _e1318);
                                    } else {
                                        phi_2062_ = type_9(_e1318, _e1313);
                                    }
                                    let _e1323 = phi_2062_;
                                    phi_2095_ = _e1323;
                                } else {
                                    let _e1286 = params.member.member_2.member;
                                    if (_e1286 == 2u) {
                                        phi_2073_ = 8u;
                                    } else {
                                        phi_2073_ = 1u;
                                    }
                                    let _e1289 = phi_2073_;
                                    if (_e1286 == 2u) {
                                        phi_2078_ = 10u;
                                    } else {
                                        phi_2078_ = 1u;
                                    }
                                    let _e1292 = phi_2078_;
                                    if (_e187 >= (_e1289 * _e1292)) {
                                        let _e1304 = params.member.member.member_2[2u];
                                        phi_2094_ = type_9(_e1279, (_e1277 - _e1304));
                                    } else {
                                        let _e1298 = params.member.member.member_2[2u];
                                        phi_2094_ = type_9(_e1277, (_e1279 - _e1298));
                                    }
                                    let _e1308 = phi_2094_;
                                    phi_2095_ = _e1308;
                                }
                                let _e1325 = phi_2095_;
                                let _e1330 = params.member.member_1.member_3;
                                let _e1331 = (_e1216 + _e1238);
                                if (_e1331 < _e1330) {
                                    let _e1333 = (2u * _e1331);
                                    atomicStore((&pairs.member[(4u + _e1333)]), _e1325.member);
                                    atomicStore((&pairs.member[(_e1333 + 5u)]), _e1325.member_1);
                                }
                                phi_2113_ = true;
                            }
                            let _e1339 = phi_2113_;
                            phi_2114_ = _e1339;
                        } else {
                            phi_2114_ = false;
                        }
                        let _e1341 = phi_2114_;
                        continue;
                        continuing {
                            phi_1924_ = _e1230;
                            break if !(_e1341);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1612_ = _e1032;
                    break if !(_e1038);
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
