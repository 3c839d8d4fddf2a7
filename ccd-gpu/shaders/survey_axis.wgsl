// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: i32,
    member_1: i32,
}

struct type_14 {
    member: u32,
    member_1: i32,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: u32,
}

struct type_20 {
    member: type_6,
    member_1: type_7,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: f32,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(2) 
var<storage, read_write> survey: type_10;
var<workgroup> shared_: array<type_22, 256>;

fn function_(lane_1: u32) {
    var local: type_22;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_16;
    var local_4: type_16;
    var local_5: type_22;
    var local_6: type_22;
    var local_7: type_22;
    var phi_108_: type_8;
    var phi_109_: type_8;
    var phi_132_: type_8;
    var phi_170_: type_8;
    var phi_171_: type_8;
    var phi_194_: type_8;
    var phi_225_: type_8;
    var phi_226_: type_8;
    var phi_249_: type_8;
    var phi_293_: type_8;
    var phi_294_: type_8;
    var phi_317_: type_8;
    var phi_346_: type_8;
    var phi_347_: type_8;
    var phi_370_: type_8;
    var phi_401_: type_8;
    var phi_402_: type_8;
    var phi_425_: type_8;
    var phi_521_: type_8;
    var phi_522_: type_8;
    var phi_545_: type_8;
    var phi_670_: type_13;
    var phi_673_: u32;
    var phi_694_: bool;
    var phi_700_: type_14;
    var phi_671_: type_13;
    var phi_714_: type_14;
    var phi_771_: type_8;
    var phi_772_: type_8;
    var phi_795_: type_8;
    var phi_674_: u32;
    var phi_945_: u32;
    var phi_940_: u32;
    var phi_946_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_980_: array<u32, 3>;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e34 = lane_2;
    local_5 = type_22(0f, array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
    phi_108_ = type_8(0u, 32u);
    loop {
        let _e39 = phi_108_;
        if (_e39.member < _e39.member_1) {
            phi_109_ = type_8((_e39.member + 1u), _e39.member_1);
            phi_132_ = type_8(1u, _e39.member);
        } else {
            phi_109_ = _e39;
            phi_132_ = type_8(0u, type_8().member_1);
        }
        let _e51 = phi_109_;
        let _e53 = phi_132_;
        let _e57 = (bitcast<i32>(_e53.member) != 0i);
        if _e57 {
            let _e62 = params.member.member_1.member_1;
            let _e63 = (((_e53.member_1 * 256u) + _e34) * _e62);
            let _e66 = params.member.member_1.member;
            if (_e63 < _e66) {
                local_2.member = 1f;
                local_2.member_1 = array<f32, 3>(0f, 0f, 0f);
                local_2.member_2 = array<f32, 3>(0f, 0f, 0f);
                phi_170_ = type_8(_e63, (_e63 + 1u));
                loop {
                    let _e74 = phi_170_;
                    if (_e74.member < _e74.member_1) {
                        phi_171_ = type_8((_e74.member + 1u), _e74.member_1);
                        phi_194_ = type_8(1u, _e74.member);
                    } else {
                        phi_171_ = _e74;
                        phi_194_ = type_8(0u, type_8().member_1);
                    }
                    let _e86 = phi_171_;
                    let _e88 = phi_194_;
                    let _e92 = (bitcast<i32>(_e88.member) != 0i);
                    if _e92 {
                        let _e94 = boxes.member[_e88.member_1];
                        local_3 = type_16(array<f32, 3>(_e94.member[0], _e94.member[1], _e94.member[2]), array<f32, 3>(_e94.member_1[0], _e94.member_1[1], _e94.member_1[2]));
                        phi_225_ = type_8(0u, 3u);
                        loop {
                            let _e107 = phi_225_;
                            if (_e107.member < _e107.member_1) {
                                phi_226_ = type_8((_e107.member + 1u), _e107.member_1);
                                phi_249_ = type_8(1u, _e107.member);
                            } else {
                                phi_226_ = _e107;
                                phi_249_ = type_8(0u, type_8().member_1);
                            }
                            let _e119 = phi_226_;
                            let _e121 = phi_249_;
                            let _e125 = (bitcast<i32>(_e121.member) != 0i);
                            if _e125 {
                                let _e128 = local_2.member_1[_e121.member_1];
                                let _e131 = local_3.member[_e121.member_1];
                                let _e135 = local_3.member_1[_e121.member_1];
                                local_2.member_1[_e121.member_1] = (_e128 + ((_e131 * 0.5f) + (_e135 * 0.5f)));
                            }
                            continue;
                            continuing {
                                phi_225_ = _e119;
                                break if !(_e125);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_170_ = _e86;
                        break if !(_e92);
                    }
                }
                phi_293_ = type_8(0u, 3u);
                loop {
                    let _e144 = phi_293_;
                    if (_e144.member < _e144.member_1) {
                        phi_294_ = type_8((_e144.member + 1u), _e144.member_1);
                        phi_317_ = type_8(1u, _e144.member);
                    } else {
                        phi_294_ = _e144;
                        phi_317_ = type_8(0u, type_8().member_1);
                    }
                    let _e156 = phi_294_;
                    let _e158 = phi_317_;
                    let _e162 = (bitcast<i32>(_e158.member) != 0i);
                    if _e162 {
                        let _e165 = local_2.member_1[_e158.member_1];
                        let _e167 = local_2.member;
                        local_2.member_1[_e158.member_1] = (_e165 / _e167);
                    }
                    continue;
                    continuing {
                        phi_293_ = _e156;
                        break if !(_e162);
                    }
                }
                phi_346_ = type_8(_e63, (_e63 + 1u));
                loop {
                    let _e175 = phi_346_;
                    if (_e175.member < _e175.member_1) {
                        phi_347_ = type_8((_e175.member + 1u), _e175.member_1);
                        phi_370_ = type_8(1u, _e175.member);
                    } else {
                        phi_347_ = _e175;
                        phi_370_ = type_8(0u, type_8().member_1);
                    }
                    let _e187 = phi_347_;
                    let _e189 = phi_370_;
                    let _e193 = (bitcast<i32>(_e189.member) != 0i);
                    if _e193 {
                        let _e195 = boxes.member[_e189.member_1];
                        local_4 = type_16(array<f32, 3>(_e195.member[0], _e195.member[1], _e195.member[2]), array<f32, 3>(_e195.member_1[0], _e195.member_1[1], _e195.member_1[2]));
                        phi_401_ = type_8(0u, 3u);
                        loop {
                            let _e208 = phi_401_;
                            if (_e208.member < _e208.member_1) {
                                phi_402_ = type_8((_e208.member + 1u), _e208.member_1);
                                phi_425_ = type_8(1u, _e208.member);
                            } else {
                                phi_402_ = _e208;
                                phi_425_ = type_8(0u, type_8().member_1);
                            }
                            let _e220 = phi_402_;
                            let _e222 = phi_425_;
                            let _e226 = (bitcast<i32>(_e222.member) != 0i);
                            if _e226 {
                                let _e229 = local_4.member[_e222.member_1];
                                let _e233 = local_4.member_1[_e222.member_1];
                                let _e238 = local_2.member_1[_e222.member_1];
                                let _e239 = (((_e229 * 0.5f) + (_e233 * 0.5f)) - _e238);
                                let _e242 = local_2.member_2[_e222.member_1];
                                local_2.member_2[_e222.member_1] = (_e242 + (_e239 * _e239));
                            }
                            continue;
                            continuing {
                                phi_401_ = _e220;
                                break if !(_e226);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_346_ = _e187;
                        break if !(_e193);
                    }
                }
                let _e249 = local_2;
                local_6 = _e249;
                let _e251 = local_5.member;
                let _e253 = local_6.member;
                let _e254 = (_e251 + _e253);
                if (_e254 > 0f) {
                    local_1.member = _e254;
                    let _e260 = local_5.member_1;
                    local_1.member_1 = _e260;
                    let _e263 = local_5.member_2;
                    local_1.member_2 = _e263;
                    let _e265 = local_6.member;
                    let _e266 = (_e265 / _e254);
                    phi_521_ = type_8(0u, 3u);
                    loop {
                        let _e268 = phi_521_;
                        if (_e268.member < _e268.member_1) {
                            phi_522_ = type_8((_e268.member + 1u), _e268.member_1);
                            phi_545_ = type_8(1u, _e268.member);
                        } else {
                            phi_522_ = _e268;
                            phi_545_ = type_8(0u, type_8().member_1);
                        }
                        let _e280 = phi_522_;
                        let _e282 = phi_545_;
                        let _e286 = (bitcast<i32>(_e282.member) != 0i);
                        if _e286 {
                            let _e289 = local_6.member_1[_e282.member_1];
                            let _e292 = local_5.member_1[_e282.member_1];
                            let _e293 = (_e289 - _e292);
                            let _e296 = local_5.member_1[_e282.member_1];
                            local_1.member_1[_e282.member_1] = (_e296 + (_e293 * _e266));
                            let _e303 = local_5.member_2[_e282.member_1];
                            let _e306 = local_6.member_2[_e282.member_1];
                            let _e310 = local_5.member;
                            local_1.member_2[_e282.member_1] = ((_e303 + _e306) + ((_e293 * _e293) * (_e310 * _e266)));
                        }
                        continue;
                        continuing {
                            phi_521_ = _e280;
                            break if !(_e286);
                        }
                    }
                } else {
                    let _e256 = local_5;
                    local_1 = _e256;
                }
                let _e317 = local_1;
                local_5 = _e317;
            }
        }
        continue;
        continuing {
            phi_108_ = _e51;
            break if !(_e57);
        }
    }
    let _e319 = local_5;
    shared_[_e34] = _e319;
    phi_670_ = type_13(0i, 8i);
    phi_673_ = 128u;
    loop {
        let _e322 = phi_670_;
        let _e324 = phi_673_;
        if (_e322.member < _e322.member_1) {
            let _e331 = (_e322.member + 1i);
            if ((false == (_e331 > _e322.member)) != false) {
                phi_694_ = true;
            } else {
                phi_694_ = false;
            }
            let _e336 = phi_694_;
            if _e336 {
                phi_700_ = type_14(0u, type_14().member_1);
            } else {
                phi_700_ = type_14(1u, _e331);
            }
            let _e341 = phi_700_;
            phi_671_ = type_13(_e341.member_1, _e322.member_1);
            phi_714_ = type_14(1u, _e322.member);
        } else {
            phi_671_ = _e322;
            phi_714_ = type_14(0u, type_14().member_1);
        }
        let _e347 = phi_671_;
        let _e349 = phi_714_;
        let _e352 = (bitcast<i32>(_e349.member) != 0i);
        if _e352 {
            workgroupBarrier();
            if (_e34 < _e324) {
                let _e356 = shared_[(_e34 + _e324)];
                local_7 = _e356;
                let _e358 = local_5.member;
                let _e360 = local_7.member;
                let _e361 = (_e358 + _e360);
                if (_e361 > 0f) {
                    local.member = _e361;
                    let _e367 = local_5.member_1;
                    local.member_1 = _e367;
                    let _e370 = local_5.member_2;
                    local.member_2 = _e370;
                    let _e372 = local_7.member;
                    let _e373 = (_e372 / _e361);
                    phi_771_ = type_8(0u, 3u);
                    loop {
                        let _e375 = phi_771_;
                        if (_e375.member < _e375.member_1) {
                            phi_772_ = type_8((_e375.member + 1u), _e375.member_1);
                            phi_795_ = type_8(1u, _e375.member);
                        } else {
                            phi_772_ = _e375;
                            phi_795_ = type_8(0u, type_8().member_1);
                        }
                        let _e387 = phi_772_;
                        let _e389 = phi_795_;
                        let _e393 = (bitcast<i32>(_e389.member) != 0i);
                        if _e393 {
                            let _e396 = local_7.member_1[_e389.member_1];
                            let _e399 = local_5.member_1[_e389.member_1];
                            let _e400 = (_e396 - _e399);
                            let _e403 = local_5.member_1[_e389.member_1];
                            local.member_1[_e389.member_1] = (_e403 + (_e400 * _e373));
                            let _e410 = local_5.member_2[_e389.member_1];
                            let _e413 = local_7.member_2[_e389.member_1];
                            let _e417 = local_5.member;
                            local.member_2[_e389.member_1] = ((_e410 + _e413) + ((_e400 * _e400) * (_e417 * _e373)));
                        }
                        continue;
                        continuing {
                            phi_771_ = _e387;
                            break if !(_e393);
                        }
                    }
                } else {
                    let _e363 = local_5;
                    local = _e363;
                }
                let _e424 = local;
                local_5 = _e424;
                let _e425 = local_5;
                shared_[_e34] = _e425;
            }
            phi_674_ = (_e324 / 2u);
        } else {
            phi_674_ = u32();
        }
        let _e429 = phi_674_;
        continue;
        continuing {
            phi_670_ = _e347;
            phi_673_ = _e429;
            break if !(_e352);
        }
    }
    if (_e34 == 0u) {
        let _e434 = local_5.member_2[0u];
        let _e437 = local_5.member_2[1u];
        let _e440 = local_5.member_2[2u];
        if (_e437 > _e434) {
            if (_e440 > _e437) {
                phi_940_ = 2u;
            } else {
                phi_940_ = 1u;
            }
            let _e447 = phi_940_;
            phi_946_ = _e447;
        } else {
            if (_e440 > _e434) {
                phi_945_ = 2u;
            } else {
                phi_945_ = 0u;
            }
            let _e444 = phi_945_;
            phi_946_ = _e444;
        }
        let _e449 = phi_946_;
        if (_e449 == 0u) {
            phi_956_ = 2u;
            phi_957_ = 1u;
        } else {
            if (_e449 == 1u) {
                phi_955_ = 2u;
            } else {
                phi_955_ = 1u;
            }
            let _e453 = phi_955_;
            phi_956_ = _e453;
            phi_957_ = 0u;
        }
        let _e455 = phi_956_;
        let _e457 = phi_957_;
        let _e462 = local_5.member_2[_e455];
        let _e463 = local_5.member_2[_e457];
        if (_e462 > _e463) {
            phi_980_ = array<u32, 3>(_e449, _e455, _e457);
        } else {
            phi_980_ = array<u32, 3>(_e449, _e457, _e455);
        }
        let _e468 = phi_980_;
        survey.member[6u] = _e468[0];
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_axis(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
