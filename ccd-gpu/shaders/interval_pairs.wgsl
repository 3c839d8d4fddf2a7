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
var<workgroup> hits: array<u32, 2048>;
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
    var phi_468_: u32;
    var phi_473_: u32;
    var phi_476_: bool;
    var phi_491_: u32;
    var phi_492_: u32;
    var phi_493_: u32;
    var phi_494_: bool;
    var phi_498_: u32;
    var phi_515_: type_15;
    var phi_518_: u32;
    var phi_520_: u32;
    var phi_541_: bool;
    var phi_547_: type_16;
    var phi_516_: type_15;
    var phi_561_: type_16;
    var phi_590_: u32;
    var phi_591_: u32;
    var phi_592_: u32;
    var phi_593_: u32;
    var phi_594_: bool;
    var phi_519_: u32;
    var phi_521_: u32;
    var phi_595_: bool;
    var phi_600_: type_15;
    var phi_603_: u32;
    var phi_605_: u32;
    var phi_626_: bool;
    var phi_632_: type_16;
    var phi_601_: type_15;
    var phi_646_: type_16;
    var phi_675_: u32;
    var phi_676_: u32;
    var phi_677_: u32;
    var phi_678_: u32;
    var phi_679_: bool;
    var phi_604_: u32;
    var phi_606_: u32;
    var phi_680_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_682_: u32;
    var phi_698_: array<u32, 2>;
    var phi_699_: array<u32, 2>;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_722_: u32;
    var phi_731_: u32;
    var phi_736_: u32;
    var phi_739_: bool;
    var phi_754_: u32;
    var phi_755_: u32;
    var phi_756_: u32;
    var phi_757_: bool;
    var phi_761_: u32;
    var phi_783_: u32;
    var phi_802_: u32;
    var phi_821_: u32;
    var phi_826_: type_9;
    var phi_827_: type_9;
    var phi_850_: type_9;
    var phi_876_: u32;
    var phi_902_: u32;
    var phi_1035_: type_9;
    var phi_1038_: type_27;
    var phi_1036_: type_9;
    var phi_1061_: type_9;
    var phi_1071_: type_9;
    var phi_1074_: bool;
    var phi_1072_: type_9;
    var phi_1097_: type_9;
    var phi_1119_: f32;
    var phi_1136_: bool;
    var phi_1075_: bool;
    var local_10: bool;
    var phi_1142_: type_27;
    var phi_1143_: bool;
    var phi_1039_: type_27;
    var phi_1144_: bool;
    var phi_1152_: u32;
    var local_11: type_27;
    var local_12: type_27;
    var local_13: type_27;
    var phi_1162_: u32;
    var local_14: type_27;
    var phi_1169_: u32;
    var local_15: type_27;
    var local_16: type_27;
    var local_17: type_27;
    var phi_1201_: type_9;
    var phi_1202_: type_9;
    var phi_1225_: type_9;
    var phi_1276_: f32;
    var phi_1281_: f32;
    var phi_1322_: type_9;
    var phi_1323_: type_9;
    var phi_1346_: type_9;
    var phi_1406_: u32;
    var phi_1407_: u32;
    var phi_1419_: array<u32, 3>;
    var phi_1420_: array<u32, 3>;
    var phi_1487_: bool;
    var phi_1499_: bool;
    var phi_1500_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1550_: u32;
    var phi_1551_: bool;
    var phi_1552_: u32;
    var phi_1553_: bool;
    var phi_1558_: u32;
    var phi_1568_: u32;
    var phi_1582_: array<u32, 2>;
    var phi_1583_: array<u32, 2>;
    var phi_1584_: bool;
    var phi_1585_: array<u32, 2>;
    var phi_1586_: bool;
    var phi_1587_: array<u32, 2>;
    var phi_1588_: bool;
    var phi_1593_: array<u32, 2>;
    var phi_1594_: array<u32, 2>;
    var phi_1602_: array<u32, 2>;
    var phi_1603_: bool;
    var phi_1604_: array<u32, 2>;
    var phi_1605_: bool;
    var phi_1610_: array<u32, 2>;
    var phi_1617_: array<u32, 2>;
    var phi_1454_: f32;
    var phi_1455_: f32;
    var phi_1461_: u32;
    var phi_1471_: u32;
    var phi_1618_: array<u32, 2>;
    var phi_1626_: u32;
    var phi_1629_: array<u32, 3>;
    var phi_1631_: array<u32, 3>;
    var phi_1648_: type_18;
    var phi_1651_: type_9;
    var phi_1652_: type_9;
    var phi_1675_: type_9;
    var phi_1710_: type_18;
    var phi_1711_: u32;
    var phi_1732_: type_9;
    var phi_1733_: type_9;
    var phi_1756_: type_9;
    var phi_1880_: u32;
    var phi_1885_: u32;
    var phi_1901_: type_9;
    var phi_1869_: type_9;
    var phi_1902_: type_9;
    var phi_1937_: u32;
    var phi_1963_: type_9;
    var phi_1964_: type_9;
    var phi_1987_: type_9;
    var phi_2018_: array<u32, 2>;
    var phi_2025_: u32;
    var phi_2030_: u32;
    var phi_2038_: array<u32, 2>;
    var phi_2112_: u32;
    var phi_2117_: u32;
    var phi_2133_: type_9;
    var phi_2101_: type_9;
    var phi_2134_: type_9;
    var phi_2152_: bool;
    var phi_2153_: bool;
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
                let _e267 = ((_e187 % 80u) / 10u);
                if (_e267 == 0u) {
                    if (_e230 == 2u) {
                        phi_468_ = 8u;
                    } else {
                        phi_468_ = 1u;
                    }
                    let _e271 = phi_468_;
                    if (_e230 == 2u) {
                        phi_473_ = 10u;
                    } else {
                        phi_473_ = 1u;
                    }
                    let _e274 = phi_473_;
                    phi_476_ = (_e187 >= (_e271 * _e274));
                } else {
                    phi_476_ = false;
                }
                let _e278 = phi_476_;
                if (_e230 != 2u) {
                    phi_493_ = u32();
                    phi_494_ = true;
                } else {
                    if _e278 {
                        phi_492_ = u32();
                    } else {
                        let _e283 = (((_e252 >> bitcast<u32>(27u)) % 8u) + _e267);
                        if (_e283 < 8u) {
                            phi_491_ = _e283;
                        } else {
                            phi_491_ = 8u;
                        }
                        let _e286 = phi_491_;
                        phi_492_ = _e286;
                    }
                    let _e288 = phi_492_;
                    phi_493_ = _e288;
                    phi_494_ = _e278;
                }
                let _e290 = phi_493_;
                let _e292 = phi_494_;
                if _e292 {
                    phi_498_ = 8u;
                } else {
                    phi_498_ = _e290;
                }
                let _e294 = phi_498_;
                if (_e294 < 8u) {
                    let _e300 = ((_e249[1] << bitcast<u32>(30u)) + (_e294 << bitcast<u32>(27u)));
                    let _e304 = params.member.member.member_2[3u];
                    phi_515_ = type_15(0i, 32i);
                    phi_518_ = 0u;
                    phi_520_ = _e304;
                    loop {
                        let _e307 = phi_515_;
                        let _e309 = phi_518_;
                        let _e311 = phi_520_;
                        local_8 = _e309;
                        if (_e307.member < _e307.member_1) {
                            let _e318 = (_e307.member + 1i);
                            if ((false == (_e318 > _e307.member)) != false) {
                                phi_541_ = true;
                            } else {
                                phi_541_ = false;
                            }
                            let _e323 = phi_541_;
                            if _e323 {
                                phi_547_ = type_16(0u, type_16().member_1);
                            } else {
                                phi_547_ = type_16(1u, _e318);
                            }
                            let _e328 = phi_547_;
                            phi_516_ = type_15(_e328.member_1, _e307.member_1);
                            phi_561_ = type_16(1u, _e307.member);
                        } else {
                            phi_516_ = _e307;
                            phi_561_ = type_16(0u, type_16().member_1);
                        }
                        let _e334 = phi_516_;
                        let _e336 = phi_561_;
                        if (bitcast<i32>(_e336.member) != 0i) {
                            if (_e309 >= _e311) {
                                phi_592_ = u32();
                                phi_593_ = u32();
                                phi_594_ = false;
                            } else {
                                let _e343 = (_e309 + ((_e311 - _e309) / 2u));
                                let _e345 = keys.member[_e343];
                                if (_e345 < (_e300 + 134217728u)) {
                                    phi_590_ = (_e343 + 1u);
                                    phi_591_ = _e311;
                                } else {
                                    phi_590_ = _e309;
                                    phi_591_ = _e343;
                                }
                                let _e349 = phi_590_;
                                let _e351 = phi_591_;
                                phi_592_ = _e349;
                                phi_593_ = _e351;
                                phi_594_ = true;
                            }
                            let _e353 = phi_592_;
                            let _e355 = phi_593_;
                            let _e357 = phi_594_;
                            phi_519_ = _e353;
                            phi_521_ = _e355;
                            phi_595_ = _e357;
                        } else {
                            phi_519_ = u32();
                            phi_521_ = u32();
                            phi_595_ = false;
                        }
                        let _e359 = phi_519_;
                        let _e361 = phi_521_;
                        let _e363 = phi_595_;
                        continue;
                        continuing {
                            phi_515_ = _e334;
                            phi_518_ = _e359;
                            phi_520_ = _e361;
                            break if !(_e363);
                        }
                    }
                    phi_600_ = type_15(0i, 32i);
                    phi_603_ = 0u;
                    phi_605_ = _e304;
                    loop {
                        let _e366 = phi_600_;
                        let _e368 = phi_603_;
                        let _e370 = phi_605_;
                        local_9 = _e368;
                        if (_e366.member < _e366.member_1) {
                            let _e377 = (_e366.member + 1i);
                            if ((false == (_e377 > _e366.member)) != false) {
                                phi_626_ = true;
                            } else {
                                phi_626_ = false;
                            }
                            let _e382 = phi_626_;
                            if _e382 {
                                phi_632_ = type_16(0u, type_16().member_1);
                            } else {
                                phi_632_ = type_16(1u, _e377);
                            }
                            let _e387 = phi_632_;
                            phi_601_ = type_15(_e387.member_1, _e366.member_1);
                            phi_646_ = type_16(1u, _e366.member);
                        } else {
                            phi_601_ = _e366;
                            phi_646_ = type_16(0u, type_16().member_1);
                        }
                        let _e393 = phi_601_;
                        let _e395 = phi_646_;
                        if (bitcast<i32>(_e395.member) != 0i) {
                            if (_e368 >= _e370) {
                                phi_677_ = u32();
                                phi_678_ = u32();
                                phi_679_ = false;
                            } else {
                                let _e402 = (_e368 + ((_e370 - _e368) / 2u));
                                let _e404 = keys.member[_e402];
                                if (_e404 < _e300) {
                                    phi_675_ = (_e402 + 1u);
                                    phi_676_ = _e370;
                                } else {
                                    phi_675_ = _e368;
                                    phi_676_ = _e402;
                                }
                                let _e408 = phi_675_;
                                let _e410 = phi_676_;
                                phi_677_ = _e408;
                                phi_678_ = _e410;
                                phi_679_ = true;
                            }
                            let _e412 = phi_677_;
                            let _e414 = phi_678_;
                            let _e416 = phi_679_;
                            phi_604_ = _e412;
                            phi_606_ = _e414;
                            phi_680_ = _e416;
                        } else {
                            phi_604_ = u32();
                            phi_606_ = u32();
                            phi_680_ = false;
                        }
                        let _e418 = phi_604_;
                        let _e420 = phi_606_;
                        let _e422 = phi_680_;
                        continue;
                        continuing {
                            phi_600_ = _e393;
                            phi_603_ = _e418;
                            phi_605_ = _e420;
                            break if !(_e422);
                        }
                    }
                    let _e425 = local_8;
                    let _e427 = local_9;
                    phi_682_ = (_e425 - _e427);
                } else {
                    phi_682_ = 0u;
                }
                let _e430 = phi_682_;
                if (_e230 != 2u) {
                    phi_710_ = true;
                } else {
                    if (_e430 == 0u) {
                        phi_699_ = array<u32, 2>(0u, 0u);
                    } else {
                        if (_e430 <= 256u) {
                            phi_698_ = array<u32, 2>(9u, 10u);
                        } else {
                            phi_698_ = array<u32, 2>(0u, 9u);
                        }
                        let _e435 = phi_698_;
                        phi_699_ = _e435;
                    }
                    let _e437 = phi_699_;
                    let _e441 = ((_e187 % 80u) % 10u);
                    if (_e437[0] <= _e441) {
                        phi_709_ = (_e441 < _e437[1]);
                    } else {
                        phi_709_ = false;
                    }
                    let _e445 = phi_709_;
                    phi_710_ = _e445;
                }
                let _e447 = phi_710_;
                if _e447 {
                    if (_e230 == 2u) {
                        phi_722_ = ((_e187 % 80u) / 10u);
                    } else {
                        phi_722_ = 0u;
                    }
                    let _e452 = phi_722_;
                    if (_e452 == 0u) {
                        if (_e230 == 2u) {
                            phi_731_ = 8u;
                        } else {
                            phi_731_ = 1u;
                        }
                        let _e456 = phi_731_;
                        if (_e230 == 2u) {
                            phi_736_ = 10u;
                        } else {
                            phi_736_ = 1u;
                        }
                        let _e459 = phi_736_;
                        phi_739_ = (_e187 >= (_e456 * _e459));
                    } else {
                        phi_739_ = false;
                    }
                    let _e463 = phi_739_;
                    if (_e230 != 2u) {
                        phi_756_ = u32();
                        phi_757_ = true;
                    } else {
                        if _e463 {
                            phi_755_ = u32();
                        } else {
                            let _e468 = (((_e252 >> bitcast<u32>(27u)) % 8u) + _e452);
                            if (_e468 < 8u) {
                                phi_754_ = _e468;
                            } else {
                                phi_754_ = 8u;
                            }
                            let _e471 = phi_754_;
                            phi_755_ = _e471;
                        }
                        let _e473 = phi_755_;
                        phi_756_ = _e473;
                        phi_757_ = _e463;
                    }
                    let _e475 = phi_756_;
                    let _e477 = phi_757_;
                    if _e477 {
                        phi_761_ = 8u;
                    } else {
                        phi_761_ = _e475;
                    }
                    let _e479 = phi_761_;
                    if (_e230 == 2u) {
                        let _e482 = survey.member[6u];
                        if ((_e482 >> bitcast<u32>(31i)) == 1u) {
                            phi_783_ = (_e482 & 2147483647u);
                        } else {
                            phi_783_ = ~(_e482);
                        }
                        let _e489 = phi_783_;
                        let _e490 = bitcast<f32>(_e489);
                        let _e492 = survey.member[7u];
                        if ((_e492 >> bitcast<u32>(31i)) == 1u) {
                            phi_802_ = (_e492 & 2147483647u);
                        } else {
                            phi_802_ = ~(_e492);
                        }
                        let _e499 = phi_802_;
                        let _e500 = bitcast<f32>(_e499);
                        let _e502 = survey.member[8u];
                        if ((_e502 >> bitcast<u32>(31i)) == 1u) {
                            phi_821_ = (_e502 & 2147483647u);
                        } else {
                            phi_821_ = ~(_e502);
                        }
                        let _e509 = phi_821_;
                        let _e510 = bitcast<f32>(_e509);
                        local_5 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_826_ = type_9(0u, 3u);
                        loop {
                            let _e512 = phi_826_;
                            if (_e512.member < _e512.member_1) {
                                phi_827_ = type_9((_e512.member + 1u), _e512.member_1);
                                phi_850_ = type_9(1u, _e512.member);
                            } else {
                                phi_827_ = _e512;
                                phi_850_ = type_9(0u, type_9().member_1);
                            }
                            let _e524 = phi_827_;
                            let _e526 = phi_850_;
                            let _e530 = (bitcast<i32>(_e526.member) != 0i);
                            if _e530 {
                                let _e532 = survey.member[_e526.member_1];
                                let _e533 = ~(_e532);
                                if ((_e533 >> bitcast<u32>(31i)) == 1u) {
                                    phi_876_ = (_e533 & 2147483647u);
                                } else {
                                    phi_876_ = ~(_e533);
                                }
                                let _e540 = phi_876_;
                                local_5.member[_e526.member_1] = bitcast<f32>(_e540);
                                let _e546 = survey.member[(3u + _e526.member_1)];
                                if ((_e546 >> bitcast<u32>(31i)) == 1u) {
                                    phi_902_ = (_e546 & 2147483647u);
                                } else {
                                    phi_902_ = ~(_e546);
                                }
                                let _e553 = phi_902_;
                                local_5.member_1[_e526.member_1] = bitcast<f32>(_e553);
                            }
                            continue;
                            continuing {
                                phi_826_ = _e524;
                                break if !(_e530);
                            }
                        }
                        let _e558 = local_5;
                        local_6 = type_23(_e558, array<f32, 3>(_e490, _e500, _e510));
                        if (_e452 == 0u) {
                            let _e862 = (_e252 & 134217727u);
                            phi_1419_ = array<u32, 3>((_e862 & 511u), ((_e862 >> bitcast<u32>(9u)) & 511u), (_e862 >> bitcast<u32>(18u)));
                        } else {
                            let _e579 = local_6.member.member_1[0u];
                            let _e583 = local_6.member.member[0u];
                            let _e588 = local_6.member.member_1[1u];
                            let _e592 = local_6.member.member[1u];
                            let _e597 = local_6.member.member_1[2u];
                            let _e601 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e579 * 0.5f) - (_e583 * 0.5f)), ((_e588 * 0.5f) - (_e592 * 0.5f)), ((_e597 * 0.5f) - (_e601 * 0.5f)));
                            phi_1035_ = type_9(0u, 9u);
                            phi_1038_ = type_27(type_23(type_18(array<f32, 3>(_e558.member[0], _e558.member[1], _e558.member[2]), array<f32, 3>(_e558.member_1[0], _e558.member_1[1], _e558.member_1[2])), array<f32, 3>(_e490, _e500, _e510)), 0u);
                            loop {
                                let _e606 = phi_1035_;
                                let _e608 = phi_1038_;
                                local_11 = _e608;
                                local_12 = _e608;
                                local_13 = _e608;
                                local_14 = _e608;
                                local_15 = _e608;
                                local_16 = _e608;
                                local_17 = _e608;
                                if (_e606.member < _e606.member_1) {
                                    phi_1036_ = type_9((_e606.member + 1u), _e606.member_1);
                                    phi_1061_ = type_9(1u, _e606.member);
                                } else {
                                    phi_1036_ = _e606;
                                    phi_1061_ = type_9(0u, type_9().member_1);
                                }
                                let _e620 = phi_1036_;
                                let _e622 = phi_1061_;
                                if (bitcast<i32>(_e622.member) != 0i) {
                                    phi_1071_ = type_9(0u, 3u);
                                    phi_1074_ = true;
                                    loop {
                                        let _e628 = phi_1071_;
                                        let _e630 = phi_1074_;
                                        local_10 = _e630;
                                        if (_e628.member < _e628.member_1) {
                                            phi_1072_ = type_9((_e628.member + 1u), _e628.member_1);
                                            phi_1097_ = type_9(1u, _e628.member);
                                        } else {
                                            phi_1072_ = _e628;
                                            phi_1097_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e642 = phi_1072_;
                                        let _e644 = phi_1097_;
                                        let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                        if _e648 {
                                            let _e650 = local_3[_e644.member_1];
                                            let _e652 = (_e650 * (1f / 512f));
                                            if (_e652 > 0.000000000000000000000000000006310887f) {
                                                phi_1119_ = _e652;
                                            } else {
                                                phi_1119_ = 0.000000000000000000000000000006310887f;
                                            }
                                            let _e655 = phi_1119_;
                                            let _e658 = local_6.member_1[_e644.member_1];
                                            if ((_e658 * bitcast<f32>(((127u - _e622.member_1) << bitcast<u32>(23i)))) > _e655) {
                                                phi_1136_ = false;
                                            } else {
                                                phi_1136_ = _e630;
                                            }
                                            let _e666 = phi_1136_;
                                            phi_1075_ = _e666;
                                        } else {
                                            phi_1075_ = bool();
                                        }
                                        let _e668 = phi_1075_;
                                        continue;
                                        continuing {
                                            phi_1071_ = _e642;
                                            phi_1074_ = _e668;
                                            break if !(_e648);
                                        }
                                    }
                                    let _e671 = local_10;
                                    if _e671 {
                                        phi_1142_ = type_27();
                                        phi_1143_ = false;
                                    } else {
                                        phi_1142_ = type_27(_e608.member, (_e622.member_1 + 1u));
                                        phi_1143_ = true;
                                    }
                                    let _e676 = phi_1142_;
                                    let _e678 = phi_1143_;
                                    phi_1039_ = _e676;
                                    phi_1144_ = _e678;
                                } else {
                                    phi_1039_ = type_27();
                                    phi_1144_ = false;
                                }
                                let _e680 = phi_1039_;
                                let _e682 = phi_1144_;
                                continue;
                                continuing {
                                    phi_1035_ = _e620;
                                    phi_1038_ = _e680;
                                    break if !(_e682);
                                }
                            }
                            let _e687 = (((_e252 >> bitcast<u32>(27u)) % 8u) + _e452);
                            if (_e687 < 8u) {
                                phi_1152_ = _e687;
                            } else {
                                phi_1152_ = 8u;
                            }
                            let _e690 = phi_1152_;
                            let _e692 = local_11;
                            let _e697 = local_12;
                            if (_e697.member_1 < 8u) {
                                let _e701 = local_13;
                                phi_1162_ = (_e701.member_1 + 1u);
                            } else {
                                phi_1162_ = 8u;
                            }
                            let _e705 = phi_1162_;
                            if ((_e690 + 1u) >= _e705) {
                                phi_1169_ = 0u;
                            } else {
                                let _e708 = local_14;
                                phi_1169_ = (_e708.member_1 - _e690);
                            }
                            let _e712 = phi_1169_;
                            let _e716 = bitcast<f32>(((127u - _e712) << bitcast<u32>(23i)));
                            let _e718 = local_15;
                            let _e724 = local_16;
                            let _e730 = local_17;
                            local_2.member = type_18(array<f32, 3>(_e692.member.member.member[0], _e692.member.member.member[1], _e692.member.member.member[2]), array<f32, 3>(_e692.member.member.member_1[0], _e692.member.member.member_1[1], _e692.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e718.member.member_1[0] * _e716), (_e724.member.member_1[1] * _e716), (_e730.member.member_1[2] * _e716));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_1201_ = type_9(0u, 3u);
                            loop {
                                let _e752 = phi_1201_;
                                if (_e752.member < _e752.member_1) {
                                    phi_1202_ = type_9((_e752.member + 1u), _e752.member_1);
                                    phi_1225_ = type_9(1u, _e752.member);
                                } else {
                                    phi_1202_ = _e752;
                                    phi_1225_ = type_9(0u, type_9().member_1);
                                }
                                let _e764 = phi_1202_;
                                let _e766 = phi_1225_;
                                let _e770 = (bitcast<i32>(_e766.member) != 0i);
                                if _e770 {
                                    let _e774 = local_2.member.member[_e766.member_1];
                                    let _e778 = local_2.member.member_1[_e766.member_1];
                                    let _e783 = (((_e778 * 0.5f) - (_e774 * 0.5f)) * (1f / 512f));
                                    let _e786 = local_2.member_1[_e766.member_1];
                                    let _e789 = local_2.member_1[_e766.member_1];
                                    let _e791 = (_e786 + (_e789 * 0.00390625f));
                                    if (_e783 > _e791) {
                                        phi_1276_ = _e783;
                                    } else {
                                        phi_1276_ = _e791;
                                    }
                                    let _e794 = phi_1276_;
                                    if (0.000000000000000000000000000006310887f > _e794) {
                                        phi_1281_ = 0.000000000000000000000000000006310887f;
                                    } else {
                                        phi_1281_ = _e794;
                                    }
                                    let _e797 = phi_1281_;
                                    local_1.member[_e766.member_1] = (_e774 * 0.25f);
                                    local_1.member_1[_e766.member_1] = (1f / _e797);
                                }
                                continue;
                                continuing {
                                    phi_1201_ = _e764;
                                    break if !(_e770);
                                }
                            }
                            let _e805 = local_1;
                            local_4 = _e805;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1322_ = type_9(0u, 3u);
                            loop {
                                let _e807 = phi_1322_;
                                if (_e807.member < _e807.member_1) {
                                    phi_1323_ = type_9((_e807.member + 1u), _e807.member_1);
                                    phi_1346_ = type_9(1u, _e807.member);
                                } else {
                                    phi_1323_ = _e807;
                                    phi_1346_ = type_9(0u, type_9().member_1);
                                }
                                let _e819 = phi_1323_;
                                let _e821 = phi_1346_;
                                let _e825 = (bitcast<i32>(_e821.member) != 0i);
                                if _e825 {
                                    let _e828 = local_4.member[_e821.member_1];
                                    let _e831 = local_7.member[_e821.member_1];
                                    let _e836 = local_7.member_1[_e821.member_1];
                                    let _e842 = local_4.member_1[_e821.member_1];
                                    let _e843 = ((((_e831 * 0.25f) - _e828) + ((_e836 * 0.25f) - _e828)) * _e842);
                                    if (_e843 >= 511f) {
                                        phi_1407_ = 511u;
                                    } else {
                                        if (_e843 > 0f) {
                                            phi_1406_ = select(select(u32(_e843), 0u, (_e843 < 0f)), 4294967295u, (_e843 > 4294967000f));
                                        } else {
                                            phi_1406_ = 0u;
                                        }
                                        let _e852 = phi_1406_;
                                        phi_1407_ = _e852;
                                    }
                                    let _e854 = phi_1407_;
                                    local[_e821.member_1] = _e854;
                                }
                                continue;
                                continuing {
                                    phi_1322_ = _e819;
                                    break if !(_e825);
                                }
                            }
                            let _e857 = local;
                            phi_1419_ = array<u32, 3>(_e857[0], _e857[1], _e857[2]);
                        }
                        let _e871 = phi_1419_;
                        phi_1420_ = _e871;
                    } else {
                        phi_1420_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e873 = phi_1420_;
                    let _e875 = (_e249[1] << bitcast<u32>(30u));
                    if (_e230 == 1u) {
                        let _e997 = survey.member[6u];
                        if (_e997 == 0u) {
                            let _e1007 = local_7.member_1[0u];
                            phi_1455_ = _e1007;
                        } else {
                            if (_e997 == 1u) {
                                let _e1003 = local_7.member_1[1u];
                                phi_1454_ = _e1003;
                            } else {
                                let _e1001 = local_7.member_1[2u];
                                phi_1454_ = _e1001;
                            }
                            let _e1005 = phi_1454_;
                            phi_1455_ = _e1005;
                        }
                        let _e1009 = phi_1455_;
                        let _e1010 = bitcast<u32>(_e1009);
                        if (_e1010 == 2147483648u) {
                            phi_1461_ = 0u;
                        } else {
                            phi_1461_ = _e1010;
                        }
                        let _e1013 = phi_1461_;
                        let _e1015 = bitcast<u32>(bitcast<f32>(_e1013));
                        if ((_e1015 >> bitcast<u32>(31i)) == 1u) {
                            phi_1471_ = ~(_e1015);
                        } else {
                            phi_1471_ = (_e1015 | 2147483648u);
                        }
                        let _e1022 = phi_1471_;
                        phi_1618_ = array<u32, 2>(((_e875 | (_e252 & 1073741823u)) + _e187), (_e875 | (_e1022 >> bitcast<u32>(2i))));
                    } else {
                        if (_e230 == 2u) {
                            let _e879 = (_e187 % 80u);
                            let _e881 = (_e879 % 10u);
                            if (_e233 == 1u) {
                                phi_1487_ = ((_e879 / 10u) == 0u);
                            } else {
                                phi_1487_ = false;
                            }
                            let _e885 = phi_1487_;
                            if (_e479 >= 8u) {
                                phi_1604_ = array<u32, 2>();
                                phi_1605_ = true;
                            } else {
                                if _e885 {
                                    if (_e881 < 4u) {
                                        phi_1499_ = false;
                                    } else {
                                        phi_1499_ = true;
                                    }
                                    let _e889 = phi_1499_;
                                    phi_1500_ = _e889;
                                } else {
                                    phi_1500_ = true;
                                }
                                let _e891 = phi_1500_;
                                if _e891 {
                                    if (_e881 == 9u) {
                                        phi_1594_ = array<u32, 2>(0u, 134217727u);
                                    } else {
                                        let _e895 = (_e873[1] + (_e881 % 3u));
                                        let _e898 = (_e873[2] + (_e881 / 3u));
                                        if (_e895 < 1u) {
                                            phi_1587_ = array<u32, 2>();
                                            phi_1588_ = true;
                                        } else {
                                            if (_e898 < 1u) {
                                                phi_1585_ = array<u32, 2>();
                                                phi_1586_ = true;
                                            } else {
                                                if (_e895 > 512u) {
                                                    phi_1583_ = array<u32, 2>();
                                                    phi_1584_ = true;
                                                } else {
                                                    let _e902 = (_e898 > 512u);
                                                    if _e902 {
                                                        phi_1582_ = array<u32, 2>();
                                                    } else {
                                                        if (_e873[0] > 0u) {
                                                            if _e885 {
                                                                if (_e881 == 4u) {
                                                                    phi_1543_ = false;
                                                                } else {
                                                                    phi_1543_ = true;
                                                                }
                                                                let _e907 = phi_1543_;
                                                                phi_1544_ = _e907;
                                                            } else {
                                                                phi_1544_ = true;
                                                            }
                                                            let _e909 = phi_1544_;
                                                            if _e909 {
                                                                phi_1550_ = (_e873[0] - 1u);
                                                                phi_1551_ = false;
                                                            } else {
                                                                phi_1550_ = u32();
                                                                phi_1551_ = true;
                                                            }
                                                            let _e913 = phi_1550_;
                                                            let _e915 = phi_1551_;
                                                            phi_1552_ = _e913;
                                                            phi_1553_ = _e915;
                                                        } else {
                                                            phi_1552_ = u32();
                                                            phi_1553_ = true;
                                                        }
                                                        let _e917 = phi_1552_;
                                                        let _e919 = phi_1553_;
                                                        if _e919 {
                                                            phi_1558_ = _e873[0];
                                                        } else {
                                                            phi_1558_ = _e917;
                                                        }
                                                        let _e922 = phi_1558_;
                                                        if ((_e873[0] + 1u) < 512u) {
                                                            phi_1568_ = (_e873[0] + 1u);
                                                        } else {
                                                            phi_1568_ = _e873[0];
                                                        }
                                                        let _e930 = phi_1568_;
                                                        phi_1582_ = array<u32, 2>(((((_e898 - 1u) << bitcast<u32>(18u)) | ((_e895 - 1u) << bitcast<u32>(9u))) | _e922), ((((_e898 - 1u) << bitcast<u32>(18u)) | ((_e895 - 1u) << bitcast<u32>(9u))) | _e930));
                                                    }
                                                    let _e949 = phi_1582_;
                                                    phi_1583_ = _e949;
                                                    phi_1584_ = _e902;
                                                }
                                                let _e951 = phi_1583_;
                                                let _e953 = phi_1584_;
                                                phi_1585_ = _e951;
                                                phi_1586_ = _e953;
                                            }
                                            let _e955 = phi_1585_;
                                            let _e957 = phi_1586_;
                                            phi_1587_ = _e955;
                                            phi_1588_ = _e957;
                                        }
                                        let _e959 = phi_1587_;
                                        let _e961 = phi_1588_;
                                        if _e961 {
                                            phi_1593_ = array<u32, 2>(1u, 0u);
                                        } else {
                                            phi_1593_ = _e959;
                                        }
                                        let _e963 = phi_1593_;
                                        phi_1594_ = _e963;
                                    }
                                    let _e965 = phi_1594_;
                                    phi_1602_ = array<u32, 2>(((_e479 << bitcast<u32>(27u)) | _e965[0]), ((_e479 << bitcast<u32>(27u)) | _e965[1]));
                                    phi_1603_ = false;
                                } else {
                                    phi_1602_ = array<u32, 2>();
                                    phi_1603_ = true;
                                }
                                let _e976 = phi_1602_;
                                let _e978 = phi_1603_;
                                phi_1604_ = _e976;
                                phi_1605_ = _e978;
                            }
                            let _e980 = phi_1604_;
                            let _e982 = phi_1605_;
                            if _e982 {
                                phi_1610_ = array<u32, 2>(1u, 0u);
                            } else {
                                phi_1610_ = _e980;
                            }
                            let _e984 = phi_1610_;
                            phi_1617_ = array<u32, 2>((_e875 | _e984[0]), (_e875 | _e984[1]));
                        } else {
                            phi_1617_ = array<u32, 2>(_e875, _e875);
                        }
                        let _e991 = phi_1617_;
                        phi_1618_ = _e991;
                    }
                    let _e1028 = phi_1618_;
                    if (_e233 == 1u) {
                        phi_1626_ = (_e222 + 1u);
                    } else {
                        phi_1626_ = 0u;
                    }
                    let _e1034 = phi_1626_;
                    phi_1629_ = array<u32, 3>(_e1028[0], _e1028[1], _e1034);
                } else {
                    phi_1629_ = array<u32, 3>(4294967295u, 0u, 0u);
                }
                let _e1037 = phi_1629_;
                phi_1631_ = _e1037;
            } else {
                phi_1631_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e1039 = phi_1631_;
            if _e227 {
                let _e1044 = sorted.member[_e222];
                phi_1648_ = _e1044;
            } else {
                phi_1648_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e1046 = phi_1648_;
            phi_1651_ = type_9(0u, ((_e185 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e1049 = phi_1651_;
                if (_e1049.member < _e1049.member_1) {
                    phi_1652_ = type_9((_e1049.member + 1u), _e1049.member_1);
                    phi_1675_ = type_9(1u, _e1049.member);
                } else {
                    phi_1652_ = _e1049;
                    phi_1675_ = type_9(0u, type_9().member_1);
                }
                let _e1061 = phi_1652_;
                let _e1063 = phi_1675_;
                let _e1067 = (bitcast<i32>(_e1063.member) != 0i);
                if _e1067 {
                    let _e1069 = ((_e185 & 536870911u) + (_e1063.member_1 * 128u));
                    let _e1070 = (_e1069 + _e96);
                    if (_e1070 < _e136) {
                        let _e1073 = keys.member[_e1070];
                        let _e1075 = sorted.member[_e1070];
                        phi_1710_ = _e1075;
                        phi_1711_ = _e1073;
                    } else {
                        phi_1710_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1711_ = 4294967295u;
                    }
                    let _e1077 = phi_1710_;
                    let _e1079 = phi_1711_;
                    names[_e96] = _e1079;
                    boxes[_e96] = type_18(array<f32, 3>(_e1077.member[0], _e1077.member[1], _e1077.member[2]), array<f32, 3>(_e1077.member_1[0], _e1077.member_1[1], _e1077.member_1[2]));
                    if (_e96 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1732_ = type_9(0u, 128u);
                    loop {
                        let _e1096 = phi_1732_;
                        if (_e1096.member < _e1096.member_1) {
                            phi_1733_ = type_9((_e1096.member + 1u), _e1096.member_1);
                            phi_1756_ = type_9(1u, _e1096.member);
                        } else {
                            phi_1733_ = _e1096;
                            phi_1756_ = type_9(0u, type_9().member_1);
                        }
                        let _e1108 = phi_1733_;
                        let _e1110 = phi_1756_;
                        let _e1114 = (bitcast<i32>(_e1110.member) != 0i);
                        if _e1114 {
                            let _e1116 = names[_e1110.member_1];
                            if (_e1116 >= _e1039[0]) {
                                if (_e1116 <= _e1039[1]) {
                                    if ((_e1069 + _e1110.member_1) >= _e1039[2]) {
                                        let _e1122 = boxes[_e1110.member_1];
                                        if ((((((_e1046.member[0] <= _e1122.member_1[0]) && (_e1122.member[0] <= _e1046.member_1[0])) && (_e1046.member[1] <= _e1122.member_1[1])) && (_e1122.member[1] <= _e1046.member_1[1])) && (_e1046.member[2] <= _e1122.member_1[2])) && (_e1122.member[2] <= _e1046.member_1[2])) {
                                            let _e1155 = atomicAdd((&counters[0u]), 1u);
                                            if (_e1155 < 2048u) {
                                                hits[_e1155] = ((_e96 << bitcast<u32>(7i)) | _e1110.member_1);
                                            } else {
                                                let _e1159 = order.member[_e222];
                                                let _e1161 = order.member[(_e1069 + _e1110.member_1)];
                                                let _e1164 = params.member.member_2.member_1;
                                                if (_e1164 == 1u) {
                                                    let _e1194 = params.member.member.member_2[1u];
                                                    let _e1195 = (_e1159 - _e1194);
                                                    let _e1199 = params.member.member.member_2[1u];
                                                    let _e1200 = (_e1161 - _e1199);
                                                    if (_e1195 < _e1200) {
                                                        phi_1869_ = type_9(_e1195, _e1200);
                                                    } else {
                                                        phi_1869_ = type_9(_e1200, _e1195);
                                                    }
                                                    let _e1205 = phi_1869_;
                                                    phi_1902_ = _e1205;
                                                } else {
                                                    let _e1168 = params.member.member_2.member;
                                                    if (_e1168 == 2u) {
                                                        phi_1880_ = 8u;
                                                    } else {
                                                        phi_1880_ = 1u;
                                                    }
                                                    let _e1171 = phi_1880_;
                                                    if (_e1168 == 2u) {
                                                        phi_1885_ = 10u;
                                                    } else {
                                                        phi_1885_ = 1u;
                                                    }
                                                    let _e1174 = phi_1885_;
                                                    if (_e187 >= (_e1171 * _e1174)) {
                                                        let _e1186 = params.member.member.member_2[2u];
                                                        phi_1901_ = type_9(_e1161, (_e1159 - _e1186));
                                                    } else {
                                                        let _e1180 = params.member.member.member_2[2u];
                                                        phi_1901_ = type_9(_e1159, (_e1161 - _e1180));
                                                    }
                                                    let _e1190 = phi_1901_;
                                                    phi_1902_ = _e1190;
                                                }
                                                let _e1207 = phi_1902_;
                                                let _e1212 = params.member.member_1.member_3;
                                                let _e1214 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1214 + 1u) < _e1214) {
                                                    let _e1218 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1214 < _e1212) {
                                                    let _e1220 = (2u * _e1214);
                                                    atomicStore((&pairs.member[(4u + _e1220)]), _e1207.member);
                                                    atomicStore((&pairs.member[(_e1220 + 5u)]), _e1207.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1732_ = _e1108;
                            break if !(_e1114);
                        }
                    }
                    workgroupBarrier();
                    let _e1231 = atomicLoad((&counters[0u]));
                    if (2048u < _e1231) {
                        phi_1937_ = 2048u;
                    } else {
                        phi_1937_ = _e1231;
                    }
                    let _e1234 = phi_1937_;
                    if (_e96 == 0u) {
                        if (_e1234 > 0u) {
                            let _e1238 = atomicAdd((&pairs.member[0u]), _e1234);
                            if ((_e1238 + _e1234) < _e1238) {
                                let _e1242 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1238);
                        }
                    }
                    workgroupBarrier();
                    let _e1245 = atomicLoad((&counters[1u]));
                    phi_1963_ = type_9(0u, 16u);
                    loop {
                        let _e1247 = phi_1963_;
                        if (_e1247.member < _e1247.member_1) {
                            phi_1964_ = type_9((_e1247.member + 1u), _e1247.member_1);
                            phi_1987_ = type_9(1u, _e1247.member);
                        } else {
                            phi_1964_ = _e1247;
                            phi_1987_ = type_9(0u, type_9().member_1);
                        }
                        let _e1259 = phi_1964_;
                        let _e1261 = phi_1987_;
                        if (bitcast<i32>(_e1261.member) != 0i) {
                            let _e1267 = ((_e1261.member_1 * 128u) + _e96);
                            if (_e1267 >= _e1234) {
                                phi_2152_ = false;
                            } else {
                                let _e1270 = hits[_e1267];
                                let _e1275 = params.member.member_2.member;
                                let _e1278 = params.member.member_2.member_1;
                                if (_e1278 == 0u) {
                                    phi_2018_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_2018_ = array<u32, 2>(1u, 1u);
                                }
                                let _e1281 = phi_2018_;
                                if (_e1275 == 2u) {
                                    phi_2025_ = 8u;
                                } else {
                                    phi_2025_ = 1u;
                                }
                                let _e1286 = phi_2025_;
                                if (_e1275 == 2u) {
                                    phi_2030_ = 10u;
                                } else {
                                    phi_2030_ = 1u;
                                }
                                let _e1289 = phi_2030_;
                                if (_e187 >= (_e1286 * _e1289)) {
                                    phi_2038_ = array<u32, 2>(_e1281[1], _e1281[0]);
                                } else {
                                    phi_2038_ = _e1281;
                                }
                                let _e1294 = phi_2038_;
                                let _e1301 = params.member.member.member_2[_e1294[0]];
                                let _e1306 = order.member[(_e1301 + ((_e191 * 128u) + (_e1270 >> bitcast<u32>(7i))))];
                                let _e1308 = order.member[(_e1069 + (_e1270 % 128u))];
                                let _e1311 = params.member.member_2.member_1;
                                if (_e1311 == 1u) {
                                    let _e1341 = params.member.member.member_2[1u];
                                    let _e1342 = (_e1306 - _e1341);
                                    let _e1346 = params.member.member.member_2[1u];
                                    let _e1347 = (_e1308 - _e1346);
                                    if (_e1342 < _e1347) {
                                        phi_2101_ = type_9(_e1342, _e1347);
                                    } else {
                                        phi_2101_ = type_9(_e1347, _e1342);
                                    }
                                    let _e1352 = phi_2101_;
                                    phi_2134_ = _e1352;
                                } else {
                                    let _e1315 = params.member.member_2.member;
                                    if (_e1315 == 2u) {
                                        phi_2112_ = 8u;
                                    } else {
                                        phi_2112_ = 1u;
                                    }
                                    let _e1318 = phi_2112_;
                                    if (_e1315 == 2u) {
                                        phi_2117_ = 10u;
                                    } else {
                                        phi_2117_ = 1u;
                                    }
                                    let _e1321 = phi_2117_;
                                    if (_e187 >= (_e1318 * _e1321)) {
                                        let _e1333 = params.member.member.member_2[2u];
                                        phi_2133_ = type_9(_e1308, (_e1306 - _e1333));
                                    } else {
                                        let _e1327 = params.member.member.member_2[2u];
                                        phi_2133_ = type_9(_e1306, (_e1308 - _e1327));
                                    }
                                    let _e1337 = phi_2133_;
                                    phi_2134_ = _e1337;
                                }
                                let _e1354 = phi_2134_;
                                let _e1359 = params.member.member_1.member_3;
                                let _e1360 = (_e1245 + _e1267);
                                if (_e1360 < _e1359) {
                                    let _e1362 = (2u * _e1360);
                                    atomicStore((&pairs.member[(4u + _e1362)]), _e1354.member);
                                    atomicStore((&pairs.member[(_e1362 + 5u)]), _e1354.member_1);
                                }
                                phi_2152_ = true;
                            }
                            let _e1368 = phi_2152_;
                            phi_2153_ = _e1368;
                        } else {
                            phi_2153_ = false;
                        }
                        let _e1370 = phi_2153_;
                        continue;
                        continuing {
                            phi_1963_ = _e1259;
                            break if !(_e1370);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1651_ = _e1061;
                    break if !(_e1067);
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
