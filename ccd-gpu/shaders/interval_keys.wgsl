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
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_19 {
    member: type_15,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: type_19,
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
    var local_2: type_19;
    var local_3: type_15;
    var local_4: array<f32, 3>;
    var local_5: type_15;
    var local_6: type_19;
    var local_7: type_15;
    var phi_148_: u32;
    var phi_285_: type_9;
    var phi_484_: type_9;
    var phi_487_: type_22;
    var phi_520_: type_9;
    var phi_523_: bool;
    var phi_524_: bool;
    var local_8: bool;
    var phi_591_: type_22;
    var phi_592_: bool;
    var phi_488_: type_22;
    var phi_593_: bool;
    var phi_651_: type_9;
    var phi_654_: u32;
    var local_9: type_22;
    var local_10: type_22;
    var local_11: type_22;
    var local_12: type_22;
    var local_13: type_22;
    var local_14: type_22;
    var local_15: type_22;
    var local_16: type_22;
    var phi_745_: u32;
    var phi_746_: bool;
    var phi_655_: u32;
    var phi_748_: bool;
    var local_17: u32;
    var local_18: type_22;
    var local_19: u32;
    var local_20: type_22;
    var local_21: type_22;
    var local_22: type_22;
    var local_23: u32;
    var local_24: type_22;
    var local_25: type_22;
    var local_26: type_22;
    var phi_807_: type_9;
    var phi_928_: type_9;
    var phi_1043_: u32;
    var phi_202_: f32;
    var phi_203_: f32;
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
            phi_148_ = select(0u, 1u, (_e72 >= _e84));
        }
        let _e88 = phi_148_;
        let _e90 = boxes.member[_e72];
        local_7 = type_15(array<f32, 3>(_e90.member[0], _e90.member[1], _e90.member[2]), array<f32, 3>(_e90.member_1[0], _e90.member_1[1], _e90.member_1[2]));
        let _e104 = params.member.member_2.member;
        if (_e104 == 1u) {
            let _e592 = survey.member[6u];
            if (_e592 == 0u) {
                let _e603 = local_7.member[0u];
                phi_203_ = _e603;
            } else {
                if (_e592 == 1u) {
                    let _e599 = local_7.member[1u];
                    phi_202_ = _e599;
                } else {
                    let _e597 = local_7.member[2u];
                    phi_202_ = _e597;
                }
                let _e601 = phi_202_;
                phi_203_ = _e601;
            }
            let _e605 = phi_203_;
            let _e606 = bitcast<u32>(_e605);
            let _e610 = bitcast<u32>(bitcast<f32>(select(_e606, 0u, (_e606 == 2147483648u))));
            phi_1044_ = (select((_e610 | 2147483648u), ~(_e610), ((_e610 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i));
        } else {
            if (_e104 == 2u) {
                let _e108 = survey.member[6u];
                let _e115 = bitcast<f32>(select(~(_e108), (_e108 & 2147483647u), ((_e108 >> bitcast<u32>(31i)) == 1u)));
                let _e117 = survey.member[7u];
                let _e124 = bitcast<f32>(select(~(_e117), (_e117 & 2147483647u), ((_e117 >> bitcast<u32>(31i)) == 1u)));
                let _e126 = survey.member[8u];
                let _e133 = bitcast<f32>(select(~(_e126), (_e126 & 2147483647u), ((_e126 >> bitcast<u32>(31i)) == 1u)));
                local_5 = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_285_ = type_9(0u, 3u);
                loop {
                    let _e135 = phi_285_;
                    let _e138 = (_e135.member < _e135.member_1);
                    let _e149 = select(type_9().member_1, _e135.member, _e138);
                    let _e151 = (bitcast<i32>(select(0u, 1u, _e138)) != 0i);
                    if _e151 {
                        let _e153 = survey.member[_e149];
                        let _e154 = ~(_e153);
                        local_5.member[_e149] = bitcast<f32>(select(~(_e154), (_e154 & 2147483647u), ((_e154 >> bitcast<u32>(31i)) == 1u)));
                        let _e166 = survey.member[(3u + _e149)];
                        local_5.member_1[_e149] = bitcast<f32>(select(~(_e166), (_e166 & 2147483647u), ((_e166 >> bitcast<u32>(31i)) == 1u)));
                    }
                    continue;
                    continuing {
                        phi_285_ = type_9(select(_e135.member, (_e135.member + 1u), _e138), select(_e135.member_1, _e135.member_1, _e138));
                        break if !(_e151);
                    }
                }
                let _e177 = local_5;
                local_6 = type_19(_e177, array<f32, 3>(_e115, _e124, _e133));
                let _e197 = local_6.member.member_1[0u];
                let _e201 = local_6.member.member[0u];
                let _e206 = local_6.member.member_1[1u];
                let _e210 = local_6.member.member[1u];
                let _e215 = local_6.member.member_1[2u];
                let _e219 = local_6.member.member[2u];
                local_4 = array<f32, 3>(((_e197 * 0.5f) - (_e201 * 0.5f)), ((_e206 * 0.5f) - (_e210 * 0.5f)), ((_e215 * 0.5f) - (_e219 * 0.5f)));
                phi_484_ = type_9(0u, 9u);
                phi_487_ = type_22(type_19(type_15(array<f32, 3>(_e177.member[0], _e177.member[1], _e177.member[2]), array<f32, 3>(_e177.member_1[0], _e177.member_1[1], _e177.member_1[2])), array<f32, 3>(_e115, _e124, _e133)), 0u);
                loop {
                    let _e224 = phi_484_;
                    let _e226 = phi_487_;
                    local_9 = _e226;
                    local_10 = _e226;
                    local_11 = _e226;
                    local_12 = _e226;
                    local_13 = _e226;
                    local_14 = _e226;
                    local_15 = _e226;
                    local_16 = _e226;
                    local_18 = _e226;
                    local_20 = _e226;
                    local_21 = _e226;
                    local_22 = _e226;
                    local_24 = _e226;
                    local_25 = _e226;
                    local_26 = _e226;
                    let _e229 = (_e224.member < _e224.member_1);
                    let _e240 = select(type_9().member_1, _e224.member, _e229);
                    if (bitcast<i32>(select(0u, 1u, _e229)) != 0i) {
                        phi_520_ = type_9(0u, 3u);
                        phi_523_ = true;
                        loop {
                            let _e244 = phi_520_;
                            let _e246 = phi_523_;
                            local_8 = _e246;
                            let _e249 = (_e244.member < _e244.member_1);
                            let _e260 = select(type_9().member_1, _e244.member, _e249);
                            let _e262 = (bitcast<i32>(select(0u, 1u, _e249)) != 0i);
                            if _e262 {
                                let _e264 = local_4[_e260];
                                let _e266 = (_e264 * (1f / 512f));
                                let _e271 = local_6.member_1[_e260];
                                phi_524_ = select(_e246, false, ((_e271 * bitcast<f32>(((127u - _e240) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e266, (_e266 > 0.000000000000000000000000000006310887f))));
                            } else {
                                phi_524_ = bool();
                            }
                            let _e280 = phi_524_;
                            continue;
                            continuing {
                                phi_520_ = type_9(select(_e244.member, (_e244.member + 1u), _e249), select(_e244.member_1, _e244.member_1, _e249));
                                phi_523_ = _e280;
                                break if !(_e262);
                            }
                        }
                        let _e283 = local_8;
                        if _e283 {
                            phi_591_ = type_22();
                            phi_592_ = false;
                        } else {
                            phi_591_ = type_22(_e226.member, (_e240 + 1u));
                            phi_592_ = true;
                        }
                        let _e288 = phi_591_;
                        let _e290 = phi_592_;
                        phi_488_ = _e288;
                        phi_593_ = _e290;
                    } else {
                        phi_488_ = type_22();
                        phi_593_ = false;
                    }
                    let _e292 = phi_488_;
                    let _e294 = phi_593_;
                    continue;
                    continuing {
                        phi_484_ = type_9(select(_e224.member, (_e224.member + 1u), _e229), select(_e224.member_1, _e224.member_1, _e229));
                        phi_487_ = _e292;
                        break if !(_e294);
                    }
                }
                let _e298 = local_7.member_1[0u];
                let _e302 = local_7.member[0u];
                let _e307 = local_7.member_1[1u];
                let _e311 = local_7.member[1u];
                let _e316 = local_7.member_1[2u];
                let _e320 = local_7.member[2u];
                phi_651_ = type_9(1u, 8u);
                phi_654_ = 0u;
                loop {
                    let _e324 = phi_651_;
                    let _e326 = phi_654_;
                    local_17 = _e326;
                    local_19 = _e326;
                    local_23 = _e326;
                    let _e329 = (_e324.member < _e324.member_1);
                    if (bitcast<i32>(select(0u, 1u, _e329)) != 0i) {
                        let _e343 = local_9;
                        let _e347 = local_10;
                        if ((_e326 + 1u) >= select(8u, (_e347.member_1 + 1u), (_e343.member_1 < 8u))) {
                            phi_745_ = u32();
                            phi_746_ = false;
                        } else {
                            let _e354 = local_11;
                            let _e358 = local_12;
                            let _e364 = local_13;
                            let _e371 = bitcast<f32>(((127u - select((_e364.member_1 - _e326), 0u, ((_e326 + 1u) >= select(8u, (_e358.member_1 + 1u), (_e354.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e373 = local_14;
                            let _e379 = local_15;
                            let _e385 = local_16;
                            let _e390 = (((_e298 * 0.5f) - (_e302 * 0.5f)) <= (_e373.member.member_1[0] * _e371));
                            let _e391 = (((_e307 * 0.5f) - (_e311 * 0.5f)) <= (_e379.member.member_1[1] * _e371));
                            let _e397 = select(select(bool(), select(bool(), (((_e316 * 0.5f) - (_e320 * 0.5f)) <= (_e385.member.member_1[2] * _e371)), _e391), _e390), false, select(true, select(true, false, _e391), _e390));
                            phi_745_ = select((_e326 + 1u), u32(), _e397);
                            phi_746_ = select(true, false, _e397);
                        }
                        let _e402 = phi_745_;
                        let _e404 = phi_746_;
                        phi_655_ = _e402;
                        phi_748_ = _e404;
                    } else {
                        phi_655_ = u32();
                        phi_748_ = false;
                    }
                    let _e406 = phi_655_;
                    let _e408 = phi_748_;
                    continue;
                    continuing {
                        phi_651_ = type_9(select(_e324.member, (_e324.member + 1u), _e329), select(_e324.member_1, _e324.member_1, _e329));
                        phi_654_ = _e406;
                        break if !(_e408);
                    }
                }
                let _e411 = local_17;
                let _e415 = local_18;
                let _e419 = local_19;
                let _e422 = local_20;
                let _e426 = local_21;
                let _e432 = local_22;
                let _e435 = local_23;
                let _e441 = bitcast<f32>(((127u - select((_e432.member_1 - _e435), 0u, ((_e419 + 1u) >= select(8u, (_e426.member_1 + 1u), (_e422.member_1 < 8u))))) << bitcast<u32>(23i)));
                let _e443 = local_24;
                let _e449 = local_25;
                let _e455 = local_26;
                local_2.member = type_15(array<f32, 3>(_e415.member.member.member[0], _e415.member.member.member[1], _e415.member.member.member[2]), array<f32, 3>(_e415.member.member.member_1[0], _e415.member.member.member_1[1], _e415.member.member.member_1[2]));
                local_2.member_1 = array<f32, 3>((_e443.member.member_1[0] * _e441), (_e449.member.member_1[1] * _e441), (_e455.member.member_1[2] * _e441));
                local_1.member = array<f32, 3>(0f, 0f, 0f);
                local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                phi_807_ = type_9(0u, 3u);
                loop {
                    let _e477 = phi_807_;
                    let _e480 = (_e477.member < _e477.member_1);
                    let _e491 = select(type_9().member_1, _e477.member, _e480);
                    let _e493 = (bitcast<i32>(select(0u, 1u, _e480)) != 0i);
                    if _e493 {
                        let _e497 = local_2.member.member[_e491];
                        let _e501 = local_2.member.member_1[_e491];
                        let _e506 = (((_e501 * 0.5f) - (_e497 * 0.5f)) * (1f / 512f));
                        let _e509 = local_2.member_1[_e491];
                        let _e512 = local_2.member_1[_e491];
                        let _e514 = (_e509 + (_e512 * 0.00390625f));
                        let _e516 = select(_e514, _e506, (_e506 > _e514));
                        local_1.member[_e491] = (_e497 * 0.25f);
                        local_1.member_1[_e491] = (1f / select(_e516, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e516)));
                    }
                    continue;
                    continuing {
                        phi_807_ = type_9(select(_e477.member, (_e477.member + 1u), _e480), select(_e477.member_1, _e477.member_1, _e480));
                        break if !(_e493);
                    }
                }
                let _e526 = local_1;
                local_3 = _e526;
                local = array<u32, 3>(0u, 0u, 0u);
                phi_928_ = type_9(0u, 3u);
                loop {
                    let _e528 = phi_928_;
                    let _e531 = (_e528.member < _e528.member_1);
                    let _e542 = select(type_9().member_1, _e528.member, _e531);
                    let _e544 = (bitcast<i32>(select(0u, 1u, _e531)) != 0i);
                    if _e544 {
                        let _e547 = local_3.member[_e542];
                        let _e550 = local_7.member[_e542];
                        let _e552 = ((_e550 * 0.25f) - _e547);
                        let _e557 = local_7.member_1[_e542];
                        let _e559 = ((_e557 * 0.25f) - _e547);
                        let _e565 = local_3.member_1[_e542];
                        let _e566 = ((select(0f, _e552, (_e552 > 0f)) + select(0f, _e559, (_e559 > 0f))) * _e565);
                        local[_e542] = select(select(0u, select(select(u32(_e566), 0u, (_e566 < 0f)), 4294967295u, (_e566 > 4294967000f)), (_e566 > 0f)), 511u, (_e566 >= 511f));
                    }
                    continue;
                    continuing {
                        phi_928_ = type_9(select(_e528.member, (_e528.member + 1u), _e531), select(_e528.member_1, _e528.member_1, _e531));
                        break if !(_e544);
                    }
                }
                let _e578 = local;
                phi_1043_ = ((_e411 << bitcast<u32>(27u)) | (((_e578[2] << bitcast<u32>(18u)) | (_e578[1] << bitcast<u32>(9u))) | _e578[0]));
            } else {
                phi_1043_ = 0u;
            }
            let _e590 = phi_1043_;
            phi_1044_ = _e590;
        }
        let _e620 = phi_1044_;
        keys.member[_e72] = ((_e88 << bitcast<u32>(30u)) | _e620);
        order.member[_e72] = _e72;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn interval_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
