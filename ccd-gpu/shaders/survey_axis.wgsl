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

struct type_9 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
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
var<storage, read_write> survey: type_9;
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
    var phi_102_: type_11;
    var phi_103_: type_11;
    var phi_126_: type_11;
    var phi_164_: type_11;
    var phi_165_: type_11;
    var phi_188_: type_11;
    var phi_219_: type_11;
    var phi_220_: type_11;
    var phi_243_: type_11;
    var phi_287_: type_11;
    var phi_288_: type_11;
    var phi_311_: type_11;
    var phi_340_: type_11;
    var phi_341_: type_11;
    var phi_364_: type_11;
    var phi_395_: type_11;
    var phi_396_: type_11;
    var phi_419_: type_11;
    var phi_515_: type_11;
    var phi_516_: type_11;
    var phi_539_: type_11;
    var phi_664_: type_13;
    var phi_667_: u32;
    var phi_688_: bool;
    var phi_694_: type_14;
    var phi_665_: type_13;
    var phi_708_: type_14;
    var phi_765_: type_11;
    var phi_766_: type_11;
    var phi_789_: type_11;
    var phi_668_: u32;
    var phi_939_: u32;
    var phi_934_: u32;
    var phi_940_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_974_: array<u32, 3>;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e34 = lane_2;
    local_5 = type_22(0f, array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
    phi_102_ = type_11(0u, 32u);
    loop {
        let _e39 = phi_102_;
        if (_e39.member < _e39.member_1) {
            phi_103_ = type_11((_e39.member + 1u), _e39.member_1);
            phi_126_ = type_11(1u, _e39.member);
        } else {
            phi_103_ = _e39;
            phi_126_ = type_11(0u, type_11().member_1);
        }
        let _e51 = phi_103_;
        let _e53 = phi_126_;
        let _e57 = (bitcast<i32>(_e53.member) != 0i);
        if _e57 {
            let _e62 = params.member.member_1.member_1;
            let _e63 = (((_e53.member_1 * 256u) + _e34) * _e62);
            let _e66 = params.member.member_1.member;
            if (_e63 < _e66) {
                local_2.member = 1f;
                local_2.member_1 = array<f32, 3>(0f, 0f, 0f);
                local_2.member_2 = array<f32, 3>(0f, 0f, 0f);
                phi_164_ = type_11(_e63, (_e63 + 1u));
                loop {
                    let _e74 = phi_164_;
                    if (_e74.member < _e74.member_1) {
                        phi_165_ = type_11((_e74.member + 1u), _e74.member_1);
                        phi_188_ = type_11(1u, _e74.member);
                    } else {
                        phi_165_ = _e74;
                        phi_188_ = type_11(0u, type_11().member_1);
                    }
                    let _e86 = phi_165_;
                    let _e88 = phi_188_;
                    let _e92 = (bitcast<i32>(_e88.member) != 0i);
                    if _e92 {
                        let _e94 = boxes.member[_e88.member_1];
                        local_3 = type_16(array<f32, 3>(_e94.member[0], _e94.member[1], _e94.member[2]), array<f32, 3>(_e94.member_1[0], _e94.member_1[1], _e94.member_1[2]));
                        phi_219_ = type_11(0u, 3u);
                        loop {
                            let _e107 = phi_219_;
                            if (_e107.member < _e107.member_1) {
                                phi_220_ = type_11((_e107.member + 1u), _e107.member_1);
                                phi_243_ = type_11(1u, _e107.member);
                            } else {
                                phi_220_ = _e107;
                                phi_243_ = type_11(0u, type_11().member_1);
                            }
                            let _e119 = phi_220_;
                            let _e121 = phi_243_;
                            let _e125 = (bitcast<i32>(_e121.member) != 0i);
                            if _e125 {
                                let _e128 = local_2.member_1[_e121.member_1];
                                let _e131 = local_3.member[_e121.member_1];
                                let _e135 = local_3.member_1[_e121.member_1];
                                local_2.member_1[_e121.member_1] = (_e128 + ((_e131 * 0.5f) + (_e135 * 0.5f)));
                            }
                            continue;
                            continuing {
                                phi_219_ = _e119;
                                break if !(_e125);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_164_ = _e86;
                        break if !(_e92);
                    }
                }
                phi_287_ = type_11(0u, 3u);
                loop {
                    let _e144 = phi_287_;
                    if (_e144.member < _e144.member_1) {
                        phi_288_ = type_11((_e144.member + 1u), _e144.member_1);
                        phi_311_ = type_11(1u, _e144.member);
                    } else {
                        phi_288_ = _e144;
                        phi_311_ = type_11(0u, type_11().member_1);
                    }
                    let _e156 = phi_288_;
                    let _e158 = phi_311_;
                    let _e162 = (bitcast<i32>(_e158.member) != 0i);
                    if _e162 {
                        let _e165 = local_2.member_1[_e158.member_1];
                        let _e167 = local_2.member;
                        local_2.member_1[_e158.member_1] = (_e165 / _e167);
                    }
                    continue;
                    continuing {
                        phi_287_ = _e156;
                        break if !(_e162);
                    }
                }
                phi_340_ = type_11(_e63, (_e63 + 1u));
                loop {
                    let _e175 = phi_340_;
                    if (_e175.member < _e175.member_1) {
                        phi_341_ = type_11((_e175.member + 1u), _e175.member_1);
                        phi_364_ = type_11(1u, _e175.member);
                    } else {
                        phi_341_ = _e175;
                        phi_364_ = type_11(0u, type_11().member_1);
                    }
                    let _e187 = phi_341_;
                    let _e189 = phi_364_;
                    let _e193 = (bitcast<i32>(_e189.member) != 0i);
                    if _e193 {
                        let _e195 = boxes.member[_e189.member_1];
                        local_4 = type_16(array<f32, 3>(_e195.member[0], _e195.member[1], _e195.member[2]), array<f32, 3>(_e195.member_1[0], _e195.member_1[1], _e195.member_1[2]));
                        phi_395_ = type_11(0u, 3u);
                        loop {
                            let _e208 = phi_395_;
                            if (_e208.member < _e208.member_1) {
                                phi_396_ = type_11((_e208.member + 1u), _e208.member_1);
                                phi_419_ = type_11(1u, _e208.member);
                            } else {
                                phi_396_ = _e208;
                                phi_419_ = type_11(0u, type_11().member_1);
                            }
                            let _e220 = phi_396_;
                            let _e222 = phi_419_;
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
                                phi_395_ = _e220;
                                break if !(_e226);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_340_ = _e187;
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
                    phi_515_ = type_11(0u, 3u);
                    loop {
                        let _e268 = phi_515_;
                        if (_e268.member < _e268.member_1) {
                            phi_516_ = type_11((_e268.member + 1u), _e268.member_1);
                            phi_539_ = type_11(1u, _e268.member);
                        } else {
                            phi_516_ = _e268;
                            phi_539_ = type_11(0u, type_11().member_1);
                        }
                        let _e280 = phi_516_;
                        let _e282 = phi_539_;
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
                            phi_515_ = _e280;
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
            phi_102_ = _e51;
            break if !(_e57);
        }
    }
    let _e319 = local_5;
    shared_[_e34] = _e319;
    phi_664_ = type_13(0i, 8i);
    phi_667_ = 128u;
    loop {
        let _e322 = phi_664_;
        let _e324 = phi_667_;
        if (_e322.member < _e322.member_1) {
            let _e331 = (_e322.member + 1i);
            if ((false == (_e331 > _e322.member)) != false) {
                phi_688_ = true;
            } else {
                phi_688_ = false;
            }
            let _e336 = phi_688_;
            if _e336 {
                phi_694_ = type_14(0u, type_14().member_1);
            } else {
                phi_694_ = type_14(1u, _e331);
            }
            let _e341 = phi_694_;
            phi_665_ = type_13(_e341.member_1, _e322.member_1);
            phi_708_ = type_14(1u, _e322.member);
        } else {
            phi_665_ = _e322;
            phi_708_ = type_14(0u, type_14().member_1);
        }
        let _e347 = phi_665_;
        let _e349 = phi_708_;
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
                    phi_765_ = type_11(0u, 3u);
                    loop {
                        let _e375 = phi_765_;
                        if (_e375.member < _e375.member_1) {
                            phi_766_ = type_11((_e375.member + 1u), _e375.member_1);
                            phi_789_ = type_11(1u, _e375.member);
                        } else {
                            phi_766_ = _e375;
                            phi_789_ = type_11(0u, type_11().member_1);
                        }
                        let _e387 = phi_766_;
                        let _e389 = phi_789_;
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
                            phi_765_ = _e387;
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
            phi_668_ = (_e324 / 2u);
        } else {
            phi_668_ = u32();
        }
        let _e429 = phi_668_;
        continue;
        continuing {
            phi_664_ = _e347;
            phi_667_ = _e429;
            break if !(_e352);
        }
    }
    if (_e34 == 0u) {
        let _e434 = local_5.member_2[0u];
        let _e437 = local_5.member_2[1u];
        let _e440 = local_5.member_2[2u];
        if (_e437 > _e434) {
            if (_e440 > _e437) {
                phi_934_ = 2u;
            } else {
                phi_934_ = 1u;
            }
            let _e447 = phi_934_;
            phi_940_ = _e447;
        } else {
            if (_e440 > _e434) {
                phi_939_ = 2u;
            } else {
                phi_939_ = 0u;
            }
            let _e444 = phi_939_;
            phi_940_ = _e444;
        }
        let _e449 = phi_940_;
        if (_e449 == 0u) {
            phi_950_ = 2u;
            phi_951_ = 1u;
        } else {
            if (_e449 == 1u) {
                phi_949_ = 2u;
            } else {
                phi_949_ = 1u;
            }
            let _e453 = phi_949_;
            phi_950_ = _e453;
            phi_951_ = 0u;
        }
        let _e455 = phi_950_;
        let _e457 = phi_951_;
        let _e462 = local_5.member_2[_e455];
        let _e463 = local_5.member_2[_e457];
        if (_e462 > _e463) {
            phi_974_ = array<u32, 3>(_e449, _e455, _e457);
        } else {
            phi_974_ = array<u32, 3>(_e449, _e457, _e455);
        }
        let _e468 = phi_974_;
        survey.member[6u] = _e468[0];
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_axis(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
