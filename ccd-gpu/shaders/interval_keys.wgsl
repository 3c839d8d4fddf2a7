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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: type_15,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: type_18,
    member_1: u32,
}

@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage> survey: type_11;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_15;
    var local_2: type_18;
    var local_3: type_15;
    var local_4: array<f32, 3>;
    var local_5: type_15;
    var local_6: type_18;
    var local_7: type_15;
    var phi_147_: u32;
    var phi_148_: u32;
    var phi_242_: u32;
    var phi_261_: u32;
    var phi_280_: u32;
    var phi_285_: type_9;
    var phi_286_: type_9;
    var phi_309_: type_9;
    var phi_335_: u32;
    var phi_361_: u32;
    var phi_484_: type_9;
    var phi_487_: type_22;
    var phi_485_: type_9;
    var phi_510_: type_9;
    var phi_520_: type_9;
    var phi_523_: bool;
    var phi_521_: type_9;
    var phi_546_: type_9;
    var phi_568_: f32;
    var phi_585_: bool;
    var phi_524_: bool;
    var local_8: bool;
    var phi_591_: type_22;
    var phi_592_: bool;
    var phi_488_: type_22;
    var phi_593_: bool;
    var phi_651_: type_9;
    var phi_654_: u32;
    var phi_652_: type_9;
    var phi_677_: type_9;
    var local_9: type_22;
    var local_10: type_22;
    var phi_692_: u32;
    var local_11: type_22;
    var local_12: type_22;
    var phi_705_: u32;
    var local_13: type_22;
    var phi_712_: u32;
    var local_14: type_22;
    var local_15: type_22;
    var local_16: type_22;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_738_: bool;
    var phi_743_: u32;
    var phi_744_: bool;
    var phi_745_: u32;
    var phi_746_: bool;
    var phi_655_: u32;
    var phi_748_: bool;
    var local_17: u32;
    var local_18: type_22;
    var local_19: u32;
    var local_20: type_22;
    var local_21: type_22;
    var phi_768_: u32;
    var local_22: type_22;
    var local_23: u32;
    var phi_775_: u32;
    var local_24: type_22;
    var local_25: type_22;
    var local_26: type_22;
    var phi_807_: type_9;
    var phi_808_: type_9;
    var phi_831_: type_9;
    var phi_882_: f32;
    var phi_887_: f32;
    var phi_928_: type_9;
    var phi_929_: type_9;
    var phi_952_: type_9;
    var phi_980_: f32;
    var phi_995_: f32;
    var phi_1022_: u32;
    var phi_1023_: u32;
    var phi_1043_: u32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_209_: u32;
    var phi_219_: u32;
    var phi_1044_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e58 = id_2;
    let _e59 = n_2;
    let _e60 = lane_2;
    let _e72 = ((((_e58.y * _e59.x) + _e58.x) * 256u) + _e60);
    let _e76 = params.member.member.member_2[3u];
    if (_e72 < _e76) {
        let _e81 = params.member.member.member_2[2u];
        if (_e72 >= _e81) {
            phi_148_ = 2u;
        } else {
            let _e84 = params.member.member.member_2[1u];
            if (_e72 >= _e84) {
                phi_147_ = 1u;
            } else {
                phi_147_ = 0u;
            }
            let _e87 = phi_147_;
            phi_148_ = _e87;
        }
        let _e89 = phi_148_;
        let _e91 = boxes.member[_e72];
        local_7 = type_15(array<f32, 3>(_e91.member[0], _e91.member[1], _e91.member[2]), array<f32, 3>(_e91.member_1[0], _e91.member_1[1], _e91.member_1[2]));
        let _e105 = params.member.member_2.member;
        if (_e105 == 1u) {
            let _e631 = survey.member[6u];
            if (_e631 == 0u) {
                let _e642 = local_7.member[0u];
                phi_203_ = _e642;
            } else {
                if (_e631 == 1u) {
                    let _e638 = local_7.member[1u];
                    phi_202_ = _e638;
                } else {
                    let _e636 = local_7.member[2u];
                    phi_202_ = _e636;
                }
                let _e640 = phi_202_;
                phi_203_ = _e640;
            }
            let _e644 = phi_203_;
            let _e645 = bitcast<u32>(_e644);
            if (_e645 == 2147483648u) {
                phi_209_ = 0u;
            } else {
                phi_209_ = _e645;
            }
            let _e648 = phi_209_;
            let _e650 = bitcast<u32>(bitcast<f32>(_e648));
            if ((_e650 >> bitcast<u32>(31i)) == 1u) {
                phi_219_ = ~(_e650);
            } else {
                phi_219_ = (_e650 | 2147483648u);
            }
            let _e657 = phi_219_;
            phi_1044_ = (_e657 >> bitcast<u32>(2i));
        } else {
            if (_e105 == 2u) {
                let _e109 = survey.member[6u];
                if ((_e109 >> bitcast<u32>(31i)) == 1u) {
                    phi_242_ = (_e109 & 2147483647u);
                } else {
                    phi_242_ = ~(_e109);
                }
                let _e116 = phi_242_;
                let _e117 = bitcast<f32>(_e116);
                let _e119 = survey.member[7u];
                if ((_e119 >> bitcast<u32>(31i)) == 1u) {
                    phi_261_ = (_e119 & 2147483647u);
                } else {
                    phi_261_ = ~(_e119);
                }
                let _e126 = phi_261_;
                let _e127 = bitcast<f32>(_e126);
                let _e129 = survey.member[8u];
                if ((_e129 >> bitcast<u32>(31i)) == 1u) {
                    phi_280_ = (_e129 & 2147483647u);
                } else {
                    phi_280_ = ~(_e129);
                }
                let _e136 = phi_280_;
                let _e137 = bitcast<f32>(_e136);
                local_5 = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_285_ = type_9(0u, 3u);
                loop {
                    let _e139 = phi_285_;
                    if (_e139.member < _e139.member_1) {
                        phi_286_ = type_9((_e139.member + 1u), _e139.member_1);
                        phi_309_ = type_9(1u, _e139.member);
                    } else {
                        phi_286_ = _e139;
                        phi_309_ = type_9(0u, type_9().member_1);
                    }
                    let _e151 = phi_286_;
                    let _e153 = phi_309_;
                    let _e157 = (bitcast<i32>(_e153.member) != 0i);
                    if _e157 {
                        let _e159 = survey.member[_e153.member_1];
                        let _e160 = ~(_e159);
                        if ((_e160 >> bitcast<u32>(31i)) == 1u) {
                            phi_335_ = (_e160 & 2147483647u);
                        } else {
                            phi_335_ = ~(_e160);
                        }
                        let _e167 = phi_335_;
                        local_5.member[_e153.member_1] = bitcast<f32>(_e167);
                        let _e173 = survey.member[(3u + _e153.member_1)];
                        if ((_e173 >> bitcast<u32>(31i)) == 1u) {
                            phi_361_ = (_e173 & 2147483647u);
                        } else {
                            phi_361_ = ~(_e173);
                        }
                        let _e180 = phi_361_;
                        local_5.member_1[_e153.member_1] = bitcast<f32>(_e180);
                    }
                    continue;
                    continuing {
                        phi_285_ = _e151;
                        break if !(_e157);
                    }
                }
                let _e185 = local_5;
                local_6 = type_18(_e185, array<f32, 3>(_e117, _e127, _e137));
                let _e205 = local_6.member.member_1[0u];
                let _e209 = local_6.member.member[0u];
                let _e214 = local_6.member.member_1[1u];
                let _e218 = local_6.member.member[1u];
                let _e223 = local_6.member.member_1[2u];
                let _e227 = local_6.member.member[2u];
                local_4 = array<f32, 3>(((_e205 * 0.5f) - (_e209 * 0.5f)), ((_e214 * 0.5f) - (_e218 * 0.5f)), ((_e223 * 0.5f) - (_e227 * 0.5f)));
                phi_484_ = type_9(0u, 9u);
                phi_487_ = type_22(type_18(type_15(array<f32, 3>(_e185.member[0], _e185.member[1], _e185.member[2]), array<f32, 3>(_e185.member_1[0], _e185.member_1[1], _e185.member_1[2])), array<f32, 3>(_e117, _e127, _e137)), 0u);
                loop {
                    let _e232 = phi_484_;
                    let _e234 = phi_487_;
                    local_9 = _e234;
                    local_10 = _e234;
                    local_11 = _e234;
                    local_12 = _e234;
                    local_13 = _e234;
                    local_14 = _e234;
                    local_15 = _e234;
                    local_16 = _e234;
                    local_18 = _e234;
                    local_20 = _e234;
                    local_21 = _e234;
                    local_22 = _e234;
                    local_24 = _e234;
                    local_25 = _e234;
                    local_26 = _e234;
                    if (_e232.member < _e232.member_1) {
                        phi_485_ = type_9((_e232.member + 1u), _e232.member_1);
                        phi_510_ = type_9(1u, _e232.member);
                    } else {
                        phi_485_ = _e232;
                        phi_510_ = type_9(0u, type_9().member_1);
                    }
                    let _e246 = phi_485_;
                    let _e248 = phi_510_;
                    if (bitcast<i32>(_e248.member) != 0i) {
                        phi_520_ = type_9(0u, 3u);
                        phi_523_ = true;
                        loop {
                            let _e254 = phi_520_;
                            let _e256 = phi_523_;
                            local_8 = _e256;
                            if (_e254.member < _e254.member_1) {
                                phi_521_ = type_9((_e254.member + 1u), _e254.member_1);
                                phi_546_ = type_9(1u, _e254.member);
                            } else {
                                phi_521_ = _e254;
                                phi_546_ = type_9(0u, type_9().member_1);
                            }
                            let _e268 = phi_521_;
                            let _e270 = phi_546_;
                            let _e274 = (bitcast<i32>(_e270.member) != 0i);
                            if _e274 {
                                let _e276 = local_4[_e270.member_1];
                                let _e278 = (_e276 * (1f / 512f));
                                if (_e278 > 0.000000000000000000000000000006310887f) {
                                    phi_568_ = _e278;
                                } else {
                                    phi_568_ = 0.000000000000000000000000000006310887f;
                                }
                                let _e281 = phi_568_;
                                let _e284 = local_6.member_1[_e270.member_1];
                                if ((_e284 * bitcast<f32>(((127u - _e248.member_1) << bitcast<u32>(23i)))) > _e281) {
                                    phi_585_ = false;
                                } else {
                                    phi_585_ = _e256;
                                }
                                let _e292 = phi_585_;
                                phi_524_ = _e292;
                            } else {
                                phi_524_ = bool();
                            }
                            let _e294 = phi_524_;
                            continue;
                            continuing {
                                phi_520_ = _e268;
                                phi_523_ = _e294;
                                break if !(_e274);
                            }
                        }
                        let _e297 = local_8;
                        if _e297 {
                            phi_591_ = type_22();
                            phi_592_ = false;
                        } else {
                            phi_591_ = type_22(_e234.member, (_e248.member_1 + 1u));
                            phi_592_ = true;
                        }
                        let _e302 = phi_591_;
                        let _e304 = phi_592_;
                        phi_488_ = _e302;
                        phi_593_ = _e304;
                    } else {
                        phi_488_ = type_22();
                        phi_593_ = false;
                    }
                    let _e306 = phi_488_;
                    let _e308 = phi_593_;
                    continue;
                    continuing {
                        phi_484_ = _e246;
                        phi_487_ = _e306;
                        break if !(_e308);
                    }
                }
                let _e312 = local_7.member_1[0u];
                let _e316 = local_7.member[0u];
                let _e321 = local_7.member_1[1u];
                let _e325 = local_7.member[1u];
                let _e330 = local_7.member_1[2u];
                let _e334 = local_7.member[2u];
                phi_651_ = type_9(1u, 8u);
                phi_654_ = 0u;
                loop {
                    let _e338 = phi_651_;
                    let _e340 = phi_654_;
                    local_17 = _e340;
                    local_19 = _e340;
                    local_23 = _e340;
                    if (_e338.member < _e338.member_1) {
                        phi_652_ = type_9((_e338.member + 1u), _e338.member_1);
                        phi_677_ = type_9(1u, _e338.member);
                    } else {
                        phi_652_ = _e338;
                        phi_677_ = type_9(0u, type_9().member_1);
                    }
                    let _e352 = phi_652_;
                    let _e354 = phi_677_;
                    if (bitcast<i32>(_e354.member) != 0i) {
                        let _e360 = local_9;
                        if (_e360.member_1 < 8u) {
                            let _e364 = local_10;
                            phi_692_ = (_e364.member_1 + 1u);
                        } else {
                            phi_692_ = 8u;
                        }
                        let _e368 = phi_692_;
                        if ((_e340 + 1u) >= _e368) {
                            phi_745_ = u32();
                            phi_746_ = false;
                        } else {
                            let _e372 = local_11;
                            if (_e372.member_1 < 8u) {
                                let _e376 = local_12;
                                phi_705_ = (_e376.member_1 + 1u);
                            } else {
                                phi_705_ = 8u;
                            }
                            let _e380 = phi_705_;
                            if ((_e340 + 1u) >= _e380) {
                                phi_712_ = 0u;
                            } else {
                                let _e383 = local_13;
                                phi_712_ = (_e383.member_1 - _e340);
                            }
                            let _e387 = phi_712_;
                            let _e391 = bitcast<f32>(((127u - _e387) << bitcast<u32>(23i)));
                            let _e393 = local_14;
                            let _e399 = local_15;
                            let _e405 = local_16;
                            if (((_e312 * 0.5f) - (_e316 * 0.5f)) <= (_e393.member.member_1[0] * _e391)) {
                                if (((_e321 * 0.5f) - (_e325 * 0.5f)) <= (_e399.member.member_1[1] * _e391)) {
                                    phi_731_ = (((_e330 * 0.5f) - (_e334 * 0.5f)) <= (_e405.member.member_1[2] * _e391));
                                    phi_732_ = false;
                                } else {
                                    phi_731_ = bool();
                                    phi_732_ = true;
                                }
                                let _e414 = phi_731_;
                                let _e416 = phi_732_;
                                phi_733_ = _e414;
                                phi_734_ = _e416;
                            } else {
                                phi_733_ = bool();
                                phi_734_ = true;
                            }
                            let _e418 = phi_733_;
                            let _e420 = phi_734_;
                            if _e420 {
                                phi_738_ = false;
                            } else {
                                phi_738_ = _e418;
                            }
                            let _e422 = phi_738_;
                            if _e422 {
                                phi_743_ = u32();
                                phi_744_ = false;
                            } else {
                                phi_743_ = (_e340 + 1u);
                                phi_744_ = true;
                            }
                            let _e425 = phi_743_;
                            let _e427 = phi_744_;
                            phi_745_ = _e425;
                            phi_746_ = _e427;
                        }
                        let _e429 = phi_745_;
                        let _e431 = phi_746_;
                        phi_655_ = _e429;
                        phi_748_ = _e431;
                    } else {
                        phi_655_ = u32();
                        phi_748_ = false;
                    }
                    let _e433 = phi_655_;
                    let _e435 = phi_748_;
                    continue;
                    continuing {
                        phi_651_ = _e352;
                        phi_654_ = _e433;
                        break if !(_e435);
                    }
                }
                let _e438 = local_17;
                let _e442 = local_18;
                let _e446 = local_19;
                let _e449 = local_20;
                if (_e449.member_1 < 8u) {
                    let _e453 = local_21;
                    phi_768_ = (_e453.member_1 + 1u);
                } else {
                    phi_768_ = 8u;
                }
                let _e457 = phi_768_;
                if ((_e446 + 1u) >= _e457) {
                    phi_775_ = 0u;
                } else {
                    let _e460 = local_22;
                    let _e463 = local_23;
                    phi_775_ = (_e460.member_1 - _e463);
                }
                let _e466 = phi_775_;
                let _e470 = bitcast<f32>(((127u - _e466) << bitcast<u32>(23i)));
                let _e472 = local_24;
                let _e478 = local_25;
                let _e484 = local_26;
                local_2.member = type_15(array<f32, 3>(_e442.member.member.member[0], _e442.member.member.member[1], _e442.member.member.member[2]), array<f32, 3>(_e442.member.member.member_1[0], _e442.member.member.member_1[1], _e442.member.member.member_1[2]));
                local_2.member_1 = array<f32, 3>((_e472.member.member_1[0] * _e470), (_e478.member.member_1[1] * _e470), (_e484.member.member_1[2] * _e470));
                local_1.member = array<f32, 3>(0f, 0f, 0f);
                local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                phi_807_ = type_9(0u, 3u);
                loop {
                    let _e506 = phi_807_;
                    if (_e506.member < _e506.member_1) {
                        phi_808_ = type_9((_e506.member + 1u), _e506.member_1);
                        phi_831_ = type_9(1u, _e506.member);
                    } else {
                        phi_808_ = _e506;
                        phi_831_ = type_9(0u, type_9().member_1);
                    }
                    let _e518 = phi_808_;
                    let _e520 = phi_831_;
                    let _e524 = (bitcast<i32>(_e520.member) != 0i);
                    if _e524 {
                        let _e528 = local_2.member.member[_e520.member_1];
                        let _e532 = local_2.member.member_1[_e520.member_1];
                        let _e537 = (((_e532 * 0.5f) - (_e528 * 0.5f)) * (1f / 512f));
                        let _e540 = local_2.member_1[_e520.member_1];
                        let _e543 = local_2.member_1[_e520.member_1];
                        let _e545 = (_e540 + (_e543 * 0.00390625f));
                        if (_e537 > _e545) {
                            phi_882_ = _e537;
                        } else {
                            phi_882_ = _e545;
                        }
                        let _e548 = phi_882_;
                        if (0.000000000000000000000000000006310887f > _e548) {
                            phi_887_ = 0.000000000000000000000000000006310887f;
                        } else {
                            phi_887_ = _e548;
                        }
                        let _e551 = phi_887_;
                        local_1.member[_e520.member_1] = (_e528 * 0.25f);
                        local_1.member_1[_e520.member_1] = (1f / _e551);
                    }
                    continue;
                    continuing {
                        phi_807_ = _e518;
                        break if !(_e524);
                    }
                }
                let _e559 = local_1;
                local_3 = _e559;
                local = array<u32, 3>(0u, 0u, 0u);
                phi_928_ = type_9(0u, 3u);
                loop {
                    let _e561 = phi_928_;
                    if (_e561.member < _e561.member_1) {
                        phi_929_ = type_9((_e561.member + 1u), _e561.member_1);
                        phi_952_ = type_9(1u, _e561.member);
                    } else {
                        phi_929_ = _e561;
                        phi_952_ = type_9(0u, type_9().member_1);
                    }
                    let _e573 = phi_929_;
                    let _e575 = phi_952_;
                    let _e579 = (bitcast<i32>(_e575.member) != 0i);
                    if _e579 {
                        let _e582 = local_3.member[_e575.member_1];
                        let _e585 = local_7.member[_e575.member_1];
                        let _e587 = ((_e585 * 0.25f) - _e582);
                        if (_e587 > 0f) {
                            phi_980_ = _e587;
                        } else {
                            phi_980_ = 0f;
                        }
                        let _e590 = phi_980_;
                        let _e593 = local_7.member_1[_e575.member_1];
                        let _e595 = ((_e593 * 0.25f) - _e582);
                        if (_e595 > 0f) {
                            phi_995_ = _e595;
                        } else {
                            phi_995_ = 0f;
                        }
                        let _e598 = phi_995_;
                        let _e602 = local_3.member_1[_e575.member_1];
                        let _e603 = ((_e590 + _e598) * _e602);
                        if (_e603 >= 511f) {
                            phi_1023_ = 511u;
                        } else {
                            if (_e603 > 0f) {
                                phi_1022_ = select(select(u32(_e603), 0u, (_e603 < 0f)), 4294967295u, (_e603 > 4294967000f));
                            } else {
                                phi_1022_ = 0u;
                            }
                            let _e612 = phi_1022_;
                            phi_1023_ = _e612;
                        }
                        let _e614 = phi_1023_;
                        local[_e575.member_1] = _e614;
                    }
                    continue;
                    continuing {
                        phi_928_ = _e573;
                        break if !(_e579);
                    }
                }
                let _e617 = local;
                phi_1043_ = ((_e438 << bitcast<u32>(27u)) | (((_e617[2] << bitcast<u32>(18u)) | (_e617[1] << bitcast<u32>(9u))) | _e617[0]));
            } else {
                phi_1043_ = 0u;
            }
            let _e629 = phi_1043_;
            phi_1044_ = _e629;
        }
        let _e661 = phi_1044_;
        keys.member[_e72] = ((_e89 << bitcast<u32>(30u)) | _e661);
        order.member[_e72] = _e72;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn interval_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
