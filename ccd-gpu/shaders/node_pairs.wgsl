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

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
@group(0) @binding(2) 
var<storage> input: type_11;
@group(0) @binding(3) 
var<storage, read_write> output: type_31;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_153_: u32;
    var phi_180_: u32;
    var phi_210_: u32;
    var phi_454_: bool;
    var phi_504_: type_9;
    var phi_507_: u32;
    var phi_508_: u32;
    var local: u32;
    var local_1: u32;
    var phi_726_: type_9;
    var phi_729_: u32;
    var phi_730_: u32;
    var phi_794_: u32;
    var phi_795_: u32;
    var phi_828_: type_9;
    var phi_894_: type_9;
    var phi_897_: u32;
    var phi_899_: u32;
    var phi_901_: u32;
    var phi_898_: u32;
    var phi_900_: u32;
    var phi_902_: u32;
    var phi_1064_: u32;
    var phi_1071_: type_9;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_211_: u32;
    var local_2: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e40 = id_2;
    let _e41 = n_2;
    let _e42 = lane_2;
    let _e57 = params.member.member_1.member_2;
    let _e59 = input.member[0u];
    let _e61 = select(_e59, _e57, (_e57 < _e59));
    let _e64 = params.member.member_1.member_1;
    if (_e61 > _e64) {
        let _e68 = params.member.member_1.member_1;
        phi_153_ = (_e61 - _e68);
    } else {
        phi_153_ = 0u;
    }
    let _e71 = phi_153_;
    let _e74 = params.member.member_2.member_3;
    if (_e74 == 1u) {
        phi_180_ = _e71;
    } else {
        let _e78 = params.member.member_2.member_3;
        if (_e78 == 0u) {
            return;
        }
        let _e80 = (_e71 / _e78);
        if (_e78 == 0u) {
            return;
        }
        phi_180_ = select(_e80, (_e80 + 1u), ((_e71 % _e78) > 0u));
    }
    let _e87 = phi_180_;
    let _e90 = params.member.member_2.member_4;
    let _e92 = select(_e87, _e90, (_e90 < _e87));
    let _e93 = (_e42 / 32u);
    phi_210_ = ((_e40.y * _e41.x) + _e40.x);
    loop {
        let _e96 = phi_210_;
        let _e97 = (_e92 / 4u);
        let _e102 = (_e96 < select(_e97, (_e97 + 1u), ((_e92 % 4u) > 0u)));
        if _e102 {
            let _e105 = ((_e96 * 4u) + (_e42 / 32u));
            let _e106 = (_e105 < _e92);
            let _e109 = params.member.member_1.member_1;
            let _e112 = params.member.member_2.member_3;
            let _e116 = (2u * (_e109 + select(0u, (_e105 * _e112), _e106)));
            let _e119 = input.member[(4u + _e116)];
            let _e122 = input.member[(_e116 + 5u)];
            if (_e42 <= 5u) {
                atomicStore((&counters[_e42]), 0u);
            }
            workgroupBarrier();
            if ((_e42 % 32u) == 0u) {
                firsts[(2u * _e93)] = (_e119 * 32u);
                firsts[((2u * _e93) + 1u)] = (_e122 * 32u);
            }
            let _e136 = params.member.member_2.member_1;
            let _e139 = select(false, (_e119 == _e122), (_e136 == 1u));
            let _e142 = params.member.member_2.member_2;
            let _e145 = params.member.member_2.member_1;
            let _e146 = (_e145 == 0u);
            let _e147 = select(1u, 0u, _e146);
            let _e149 = (_e42 / 32u);
            let _e150 = (_e42 % 32u);
            let _e154 = params.member.member_2.member[_e142][_e147];
            let _e157 = nodes.member[(_e154 + _e119)];
            let _e176 = params.member.member_2.member[(_e142 - 1u)][_e147];
            let _e179 = nodes.member[(_e176 + ((_e119 * 32u) + _e150))];
            let _e198 = params.member.member_2.member[(_e142 - 1u)][select(1u, 2u, _e146)];
            let _e201 = nodes.member[(_e198 + ((_e122 * 32u) + _e150))];
            if _e106 {
                if _e139 {
                    phi_454_ = true;
                } else {
                    phi_454_ = ((((((_e201.member.x <= _e157.member_1.y) && (_e157.member.x <= _e201.member_1.y)) && (_e201.member.y <= _e157.member_2.x)) && (_e157.member.y <= _e201.member_2.x)) && (_e201.member_1.x <= _e157.member_2.y)) && (_e157.member_1.x <= _e201.member_2.y));
                }
                let _e226 = phi_454_;
                if _e226 {
                    let _e228 = atomicAdd((&counters[_e149]), 1u);
                    let _e231 = ((_e149 * 32u) + select(_e228, _e150, _e139));
                    columns[_e231] = type_24(array<f32, 3>(_e201.member.x, _e201.member.y, _e201.member_1.x), array<f32, 3>(_e201.member_1.y, _e201.member_2.x, _e201.member_2.y));
                    names[_e231] = _e150;
                }
            }
            workgroupBarrier();
            let _e237 = (_e42 / 32u);
            let _e239 = (_e237 * 32u);
            let _e241 = atomicLoad((&counters[_e237]));
            let _e242 = (_e241 / 4u);
            phi_504_ = type_9(0u, select(_e242, (_e242 + 1u), ((_e241 % 4u) > 0u)));
            phi_507_ = 0u;
            loop {
                let _e249 = phi_504_;
                let _e251 = phi_507_;
                local = _e251;
                local_1 = _e251;
                let _e254 = (_e249.member < _e249.member_1);
                let _e267 = (bitcast<i32>(select(0u, 1u, _e254)) != 0i);
                if _e267 {
                    let _e268 = (4u * select(type_9().member_1, _e249.member, _e254));
                    let _e271 = columns[(_e239 + _e268)];
                    let _e295 = columns[((_e239 + _e268) + 1u)];
                    let _e322 = columns[((_e239 + _e268) + 2u)];
                    let _e349 = columns[((_e239 + _e268) + 3u)];
                    phi_508_ = (_e251 | ((((select(0u, 1u, ((((((_e179.member.x <= _e271.member_1[0]) && (_e271.member[0] <= _e179.member_1.y)) && (_e179.member.y <= _e271.member_1[1])) && (_e271.member[1] <= _e179.member_2.x)) && (_e179.member_1.x <= _e271.member_1[2])) && (_e271.member[2] <= _e179.member_2.y))) | (select(0u, 1u, ((((((_e179.member.x <= _e295.member_1[0]) && (_e295.member[0] <= _e179.member_1.y)) && (_e179.member.y <= _e295.member_1[1])) && (_e295.member[1] <= _e179.member_2.x)) && (_e179.member_1.x <= _e295.member_1[2])) && (_e295.member[2] <= _e179.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e179.member.x <= _e322.member_1[0]) && (_e322.member[0] <= _e179.member_1.y)) && (_e179.member.y <= _e322.member_1[1])) && (_e322.member[1] <= _e179.member_2.x)) && (_e179.member_1.x <= _e322.member_1[2])) && (_e322.member[2] <= _e179.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e179.member.x <= _e349.member_1[0]) && (_e349.member[0] <= _e179.member_1.y)) && (_e179.member.y <= _e349.member_1[1])) && (_e349.member[1] <= _e179.member_2.x)) && (_e179.member_1.x <= _e349.member_1[2])) && (_e349.member[2] <= _e179.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e268 & 31u))));
                } else {
                    phi_508_ = u32();
                }
                let _e378 = phi_508_;
                continue;
                continuing {
                    phi_504_ = type_9(select(_e249.member, (_e249.member + 1u), _e254), select(_e249.member_1, _e249.member_1, _e254));
                    phi_507_ = _e378;
                    break if !(_e267);
                }
            }
            let _e386 = local;
            let _e389 = local_1;
            let _e390 = select(_e389, (_e386 & ((1u << bitcast<u32>((_e241 & 31u))) - 1u)), (_e241 < 32u));
            let _e395 = select(_e390, (_e390 & (4294967295u << bitcast<u32>(((_e42 % 32u) & 31u)))), _e139);
            let _e398 = params.member.member.member_1;
            if ((_e398 & 256u) != 0u) {
                if select(!((_e179.member.x <= _e179.member_1.y)), true, ((bitcast<u32>(_e179.member_1.y) & 1u) == 1u)) {
                    phi_726_ = type_9(0u, _e241);
                    phi_729_ = _e395;
                    loop {
                        let _e409 = phi_726_;
                        let _e411 = phi_729_;
                        local_2 = _e411;
                        let _e414 = (_e409.member < _e409.member_1);
                        let _e425 = select(type_9().member_1, _e409.member, _e414);
                        let _e427 = (bitcast<i32>(select(0u, 1u, _e414)) != 0i);
                        if _e427 {
                            let _e430 = columns[(_e239 + _e425)];
                            phi_730_ = select(_e411, (_e411 & ~((1u << bitcast<u32>((_e425 & 31u))))), select(!((_e430.member[0] <= _e430.member_1[0])), true, ((bitcast<u32>(_e430.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_730_ = u32();
                        }
                        let _e448 = phi_730_;
                        continue;
                        continuing {
                            phi_726_ = type_9(select(_e409.member, (_e409.member + 1u), _e414), select(_e409.member_1, _e409.member_1, _e414));
                            phi_729_ = _e448;
                            break if !(_e427);
                        }
                    }
                    let _e683 = local_2;
                    phi_794_ = _e683;
                } else {
                    phi_794_ = _e395;
                }
                let _e451 = phi_794_;
                phi_795_ = _e451;
            } else {
                phi_795_ = _e395;
            }
            let _e453 = phi_795_;
            let _e456 = atomicAdd((&counters[4u]), countOneBits(_e453));
            workgroupBarrier();
            if (_e42 == 0u) {
                let _e459 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e459;
            }
            let _e462 = workgroupUniformLoad((&n_hits[0u]));
            let _e463 = (_e462 / 512u);
            phi_828_ = type_9(0u, select(_e463, (_e463 + 1u), ((_e462 % 512u) > 0u)));
            loop {
                let _e470 = phi_828_;
                let _e473 = (_e470.member < _e470.member_1);
                let _e486 = (bitcast<i32>(select(0u, 1u, _e473)) != 0i);
                if _e486 {
                    let _e487 = (_e42 / 32u);
                    let _e489 = (select(type_9().member_1, _e470.member, _e473) * 512u);
                    if (_e453 == 0u) {
                    } else {
                        let _e498 = atomicLoad((&counters[_e487]));
                        let _e499 = (_e498 / 4u);
                        phi_894_ = type_9(0u, select(_e499, (_e499 + 1u), ((_e498 % 4u) > 0u)));
                        phi_897_ = (_e456 - _e489);
                        phi_899_ = ((_e487 << bitcast<u32>(10i)) | ((_e42 % 32u) << bitcast<u32>(5i)));
                        phi_901_ = _e453;
                        loop {
                            let _e506 = phi_894_;
                            let _e508 = phi_897_;
                            let _e510 = phi_899_;
                            let _e512 = phi_901_;
                            let _e515 = (_e506.member < _e506.member_1);
                            let _e526 = (bitcast<i32>(select(0u, 1u, _e515)) != 0i);
                            if _e526 {
                                let _e527 = (_e512 & 1u);
                                if (_e527 == 0u) {
                                } else {
                                    if (_e508 < 512u) {
                                        hits[_e508] = _e510;
                                    }
                                }
                                let _e533 = select((_e508 + 1u), _e508, (_e527 == 0u));
                                let _e534 = (_e512 & 2u);
                                if (_e534 == 0u) {
                                } else {
                                    if (_e533 < 512u) {
                                        hits[_e533] = (_e510 + 1u);
                                    }
                                }
                                let _e541 = select((_e533 + 1u), _e533, (_e534 == 0u));
                                let _e542 = (_e512 & 4u);
                                if (_e542 == 0u) {
                                } else {
                                    if (_e541 < 512u) {
                                        hits[_e541] = (_e510 + 2u);
                                    }
                                }
                                let _e549 = select((_e541 + 1u), _e541, (_e542 == 0u));
                                let _e550 = (_e512 & 8u);
                                if (_e550 == 0u) {
                                } else {
                                    if (_e549 < 512u) {
                                        hits[_e549] = (_e510 + 3u);
                                    }
                                }
                                phi_898_ = select((_e549 + 1u), _e549, (_e550 == 0u));
                                phi_900_ = (_e510 + 4u);
                                phi_902_ = (_e512 >> bitcast<u32>(4i));
                            } else {
                                phi_898_ = u32();
                                phi_900_ = u32();
                                phi_902_ = u32();
                            }
                            let _e562 = phi_898_;
                            let _e564 = phi_900_;
                            let _e566 = phi_902_;
                            continue;
                            continuing {
                                phi_894_ = type_9(select(_e506.member, (_e506.member + 1u), _e515), select(_e506.member_1, _e506.member_1, _e515));
                                phi_897_ = _e562;
                                phi_899_ = _e564;
                                phi_901_ = _e566;
                                break if !(_e526);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e569 = n_hits[0u];
                    let _e570 = (_e569 - _e489);
                    let _e572 = select(_e570, 512u, (512u < _e570));
                    if (_e42 == 0u) {
                        atomicStore((&counters[5u]), _e572);
                    }
                    workgroupBarrier();
                    if (_e42 == 0u) {
                        let _e577 = atomicLoad((&counters[5u]));
                        if (_e577 > 0u) {
                            let _e581 = params.member.member.member_1;
                            if ((_e581 & 1024u) != 0u) {
                                let _e591 = atomicAdd((&output.member[0u]), _e577);
                                let _e592 = (_e591 + _e577);
                                let _e594 = select(_e592, 4294967295u, (_e592 < _e591));
                                let _e597 = params.member.member_1.member_3;
                                if (_e594 > _e597) {
                                    let _e600 = atomicMax((&output.member[2u]), _e594);
                                }
                                phi_1064_ = _e591;
                            } else {
                                let _e585 = atomicAdd((&output.member[0u]), _e577);
                                if ((_e585 + _e577) < _e585) {
                                    let _e589 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1064_ = _e585;
                            }
                            let _e602 = phi_1064_;
                            atomicStore((&counters[6u]), _e602);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e606 = atomicLoad((&counters[6u]));
                    phi_1071_ = type_9(0u, 4u);
                    loop {
                        let _e608 = phi_1071_;
                        let _e611 = (_e608.member < _e608.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e611)) != 0i) {
                            let _e626 = (_e42 + (select(type_9().member_1, _e608.member, _e611) * 128u));
                            if (_e626 >= _e572) {
                                phi_1144_ = false;
                            } else {
                                let _e629 = hits[_e626];
                                let _e632 = ((_e629 >> bitcast<u32>(10i)) & 3u);
                                let _e640 = names[((_e632 * 32u) + (_e629 & 31u))];
                                let _e643 = firsts[(2u * _e632)];
                                let _e648 = firsts[((2u * _e632) + 1u)];
                                let _e652 = params.member.member_1.member_3;
                                let _e653 = (_e606 + _e626);
                                if (_e653 < _e652) {
                                    let _e655 = (2u * _e653);
                                    atomicStore((&output.member[(4u + _e655)]), (_e643 + ((_e629 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e655 + 5u)]), (_e648 + _e640));
                                }
                                phi_1144_ = true;
                            }
                            let _e661 = phi_1144_;
                            phi_1145_ = _e661;
                        } else {
                            phi_1145_ = false;
                        }
                        let _e663 = phi_1145_;
                        continue;
                        continuing {
                            phi_1071_ = type_9(select(_e608.member, (_e608.member + 1u), _e611), select(_e608.member_1, _e608.member_1, _e611));
                            break if !(_e663);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_828_ = type_9(select(_e470.member, (_e470.member + 1u), _e473), select(_e470.member_1, _e470.member_1, _e473));
                    break if !(_e486);
                }
            }
            phi_211_ = (_e96 + (_e41.x * _e41.y));
        } else {
            phi_211_ = u32();
        }
        let _e667 = phi_211_;
        continue;
        continuing {
            phi_210_ = _e667;
            break if !(_e102);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
