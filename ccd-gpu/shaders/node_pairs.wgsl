struct type_8 {
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<u32>,
}

struct type_18 {
    member: u32,
    member_1: u32,
}

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> nodes: type_13;
@group(0) @binding(2) 
var<storage> input: type_15;
@group(0) @binding(3) 
var<storage, read_write> output: type_25;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_11, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_127_: u32;
    var phi_155_: u32;
    var phi_156_: u32;
    var phi_163_: u32;
    var phi_179_: u32;
    var phi_200_: u32;
    var phi_201_: u32;
    var phi_204_: type_18;
    var phi_205_: type_18;
    var phi_228_: type_18;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_274_: u32;
    var phi_284_: u32;
    var phi_334_: array<u32, 2>;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_533_: type_11;
    var phi_541_: bool;
    var phi_548_: type_18;
    var phi_551_: u32;
    var phi_549_: type_18;
    var phi_574_: type_18;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_646_: bool;
    var phi_664_: u32;
    var phi_665_: u32;
    var phi_666_: u32;
    var phi_552_: u32;
    var phi_669_: type_18;
    var phi_672_: u32;
    var phi_670_: type_18;
    var phi_695_: type_18;
    var phi_747_: u32;
    var phi_748_: bool;
    var phi_673_: u32;
    var phi_749_: bool;
    var phi_756_: u32;
    var phi_789_: type_18;
    var phi_790_: type_18;
    var phi_813_: type_18;
    var phi_859_: bool;
    var phi_860_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e37 = id_2;
    let _e38 = n_2;
    let _e39 = lane_2;
    let _e48 = ((_e37.y * _e38.x) + _e37.x);
    let _e51 = (_e38.x * _e38.y);
    let _e53 = params.member.member_15;
    let _e55 = input.member[0u];
    if (_e53 < _e55) {
        phi_127_ = _e53;
    } else {
        phi_127_ = _e55;
    }
    let _e58 = phi_127_;
    let _e59 = (_e39 / 32u);
    let _e61 = params.member.member_12;
    if (_e58 > _e61) {
        let _e64 = params.member.member_12;
        let _e65 = (_e58 - _e64);
        let _e67 = params.member.member_13;
        if (_e67 == 0u) {
            return;
        }
        let _e69 = (_e65 / _e67);
        if (_e67 == 0u) {
            return;
        }
        if ((_e65 % _e67) > 0u) {
            phi_155_ = (_e69 + 1u);
        } else {
            phi_155_ = _e69;
        }
        let _e75 = phi_155_;
        phi_156_ = _e75;
    } else {
        phi_156_ = 0u;
    }
    let _e77 = phi_156_;
    let _e79 = params.member.member_14;
    if (_e79 < _e77) {
        phi_163_ = _e79;
    } else {
        phi_163_ = _e77;
    }
    let _e82 = phi_163_;
    let _e83 = (_e82 / 4u);
    if ((_e82 % 4u) > 0u) {
        phi_179_ = (_e83 + 1u);
    } else {
        phi_179_ = _e83;
    }
    let _e88 = phi_179_;
    if (_e88 > _e48) {
        let _e90 = (_e88 - _e48);
        if (_e51 == 0u) {
            return;
        }
        let _e92 = (_e90 / _e51);
        if (_e51 == 0u) {
            return;
        }
        if ((_e90 % _e51) > 0u) {
            phi_200_ = (_e92 + 1u);
        } else {
            phi_200_ = _e92;
        }
        let _e98 = phi_200_;
        phi_201_ = _e98;
    } else {
        phi_201_ = 0u;
    }
    let _e100 = phi_201_;
    phi_204_ = type_18(0u, _e100);
    loop {
        let _e103 = phi_204_;
        if (_e103.member < _e103.member_1) {
            phi_205_ = type_18((_e103.member + 1u), _e103.member_1);
            phi_228_ = type_18(1u, _e103.member);
        } else {
            phi_205_ = _e103;
            phi_228_ = type_18(0u, type_18().member_1);
        }
        let _e115 = phi_205_;
        let _e117 = phi_228_;
        let _e121 = (bitcast<i32>(_e117.member) != 0i);
        if _e121 {
            let _e125 = (((_e48 + (_e117.member_1 * _e51)) * 4u) + _e59);
            let _e127 = params.member.member_12;
            if (_e58 > _e127) {
                let _e130 = params.member.member_12;
                let _e131 = (_e58 - _e130);
                let _e133 = params.member.member_13;
                if (_e133 == 0u) {
                    return;
                }
                let _e135 = (_e131 / _e133);
                if (_e133 == 0u) {
                    return;
                }
                if ((_e131 % _e133) > 0u) {
                    phi_266_ = (_e135 + 1u);
                } else {
                    phi_266_ = _e135;
                }
                let _e141 = phi_266_;
                phi_267_ = _e141;
            } else {
                phi_267_ = 0u;
            }
            let _e143 = phi_267_;
            let _e145 = params.member.member_14;
            if (_e145 < _e143) {
                phi_274_ = _e145;
            } else {
                phi_274_ = _e143;
            }
            let _e148 = phi_274_;
            let _e149 = (_e125 < _e148);
            let _e151 = params.member.member_12;
            if _e149 {
                let _e153 = params.member.member_13;
                phi_284_ = (_e125 * _e153);
            } else {
                phi_284_ = 0u;
            }
            let _e156 = phi_284_;
            let _e158 = (2u * (_e151 + _e156));
            let _e161 = input.member[(4u + _e158)];
            let _e164 = input.member[(_e158 + 5u)];
            if (_e39 < 8u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if ((_e39 % 32u) == 0u) {
                firsts[(2u * _e59)] = (_e161 * 32u);
                firsts[((2u * _e59) + 1u)] = (_e164 * 32u);
            }
            let _e177 = params.member.member_8;
            if (_e177 == 0u) {
                phi_334_ = array<u32, 2>(0u, 2u);
            } else {
                phi_334_ = array<u32, 2>(1u, 1u);
            }
            let _e180 = phi_334_;
            let _e183 = (_e39 / 32u);
            let _e184 = (_e39 % 32u);
            let _e186 = params.member.member_9;
            let _e190 = params.member.member_20[_e186][_e180[0]];
            let _e193 = nodes.member[(_e190 + _e161)];
            let _e195 = params.member.member_9;
            let _e199 = params.member.member_20[_e195][_e180[1]];
            let _e202 = nodes.member[(_e199 + _e164)];
            let _e204 = params.member.member_9;
            let _e211 = params.member.member_20[(_e204 - 1u)][_e180[0]];
            let _e214 = nodes.member[(_e211 + ((_e161 * 32u) + _e184))];
            let _e216 = params.member.member_9;
            let _e223 = params.member.member_20[(_e216 - 1u)][_e180[1]];
            let _e226 = nodes.member[(_e223 + ((_e164 * 32u) + _e184))];
            if _e149 {
                if ((((((_e226.member[0] <= _e193.member_1[0]) && (_e193.member[0] <= _e226.member_1[0])) && (_e226.member[1] <= _e193.member_1[1])) && (_e193.member[1] <= _e226.member_1[1])) && (_e226.member[2] <= _e193.member_1[2])) && (_e193.member[2] <= _e226.member_1[2])) {
                    let _e264 = atomicAdd((&counters[_e183]), 1u);
                    let _e265 = ((_e183 * 32u) + _e264);
                    columns[_e265] = type_11(array<f32, 3>(_e226.member[0], _e226.member[1], _e226.member[2]), array<f32, 3>(_e226.member_1[0], _e226.member_1[1], _e226.member_1[2]));
                    names[_e265] = _e184;
                }
            }
            workgroupBarrier();
            if _e149 {
                if ((((((_e214.member[0] <= _e202.member_1[0]) && (_e202.member[0] <= _e214.member_1[0])) && (_e214.member[1] <= _e202.member_1[1])) && (_e202.member[1] <= _e214.member_1[1])) && (_e214.member[2] <= _e202.member_1[2])) && (_e202.member[2] <= _e214.member_1[2])) {
                    phi_528_ = false;
                } else {
                    phi_528_ = true;
                }
                let _e315 = phi_528_;
                phi_529_ = _e315;
            } else {
                phi_529_ = true;
            }
            let _e317 = phi_529_;
            if _e317 {
                phi_533_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_533_ = _e214;
            }
            let _e319 = phi_533_;
            let _e321 = params.member.member_8;
            if (_e321 == 1u) {
                phi_541_ = (_e161 == _e164);
            } else {
                phi_541_ = false;
            }
            let _e325 = phi_541_;
            let _e326 = (_e39 / 32u);
            let _e327 = (_e39 % 32u);
            let _e329 = atomicLoad((&counters[_e326]));
            phi_548_ = type_18(0u, _e329);
            phi_551_ = 0u;
            loop {
                let _e332 = phi_548_;
                let _e334 = phi_551_;
                local = _e334;
                if (_e332.member < _e332.member_1) {
                    phi_549_ = type_18((_e332.member + 1u), _e332.member_1);
                    phi_574_ = type_18(1u, _e332.member);
                } else {
                    phi_549_ = _e332;
                    phi_574_ = type_18(0u, type_18().member_1);
                }
                let _e346 = phi_549_;
                let _e348 = phi_574_;
                let _e352 = (bitcast<i32>(_e348.member) != 0i);
                if _e352 {
                    let _e356 = names[((_e326 * 32u) + _e348.member_1)];
                    let _e360 = columns[((_e326 * 32u) + _e348.member_1)];
                    if ((((((_e319.member[0] <= _e360.member_1[0]) && (_e360.member[0] <= _e319.member_1[0])) && (_e319.member[1] <= _e360.member_1[1])) && (_e360.member[1] <= _e319.member_1[1])) && (_e319.member[2] <= _e360.member_1[2])) && (_e360.member[2] <= _e319.member_1[2])) {
                        if _e325 {
                            let _e392 = (_e327 < _e356);
                            if _e392 {
                                phi_640_ = bool();
                            } else {
                                if (_e327 == _e356) {
                                    phi_639_ = true;
                                } else {
                                    phi_639_ = false;
                                }
                                let _e395 = phi_639_;
                                phi_640_ = _e395;
                            }
                            let _e397 = phi_640_;
                            phi_641_ = _e397;
                            phi_642_ = _e392;
                        } else {
                            phi_641_ = bool();
                            phi_642_ = true;
                        }
                        let _e399 = phi_641_;
                        let _e401 = phi_642_;
                        if _e401 {
                            phi_646_ = true;
                        } else {
                            phi_646_ = _e399;
                        }
                        let _e403 = phi_646_;
                        if _e403 {
                            let _e405 = atomicAdd((&counters[4u]), 1u);
                            if (_e405 < 2048u) {
                                hits[_e405] = (((_e326 << bitcast<u32>(10i)) | (_e327 << bitcast<u32>(5i))) | _e356);
                                phi_664_ = _e334;
                            } else {
                                phi_664_ = (_e334 | (1u << bitcast<u32>((_e348.member_1 & 31u))));
                            }
                            let _e419 = phi_664_;
                            phi_665_ = _e419;
                        } else {
                            phi_665_ = _e334;
                        }
                        let _e421 = phi_665_;
                        phi_666_ = _e421;
                    } else {
                        phi_666_ = _e334;
                    }
                    let _e423 = phi_666_;
                    phi_552_ = _e423;
                } else {
                    phi_552_ = u32();
                }
                let _e425 = phi_552_;
                continue;
                continuing {
                    phi_548_ = _e346;
                    phi_551_ = _e425;
                    break if !(_e352);
                }
            }
            phi_669_ = type_18(0u, 32u);
            let _e599 = local;
            phi_672_ = _e599;
            loop {
                let _e428 = phi_669_;
                let _e430 = phi_672_;
                if (_e428.member < _e428.member_1) {
                    phi_670_ = type_18((_e428.member + 1u), _e428.member_1);
                    phi_695_ = type_18(1u, _e428.member);
                } else {
                    phi_670_ = _e428;
                    phi_695_ = type_18(0u, type_18().member_1);
                }
                let _e442 = phi_670_;
                let _e444 = phi_695_;
                if (bitcast<i32>(_e444.member) != 0i) {
                    if (_e430 == 0u) {
                        phi_747_ = u32();
                        phi_748_ = false;
                    } else {
                        let _e455 = names[((_e59 * 32u) + select(firstTrailingBit(_e430), 32u, (_e430 == 0u)))];
                        let _e459 = params.member.member_16;
                        let _e466 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e466 + 1u) < _e466) {
                            let _e470 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e466 < _e459) {
                            atomicStore((&output.member[(4u + (2u * _e466))]), ((_e161 * 32u) + (_e39 % 32u)));
                            atomicStore((&output.member[((2u * _e466) + 5u)]), ((_e164 * 32u) + _e455));
                        }
                        phi_747_ = (_e430 & (_e430 - 1u));
                        phi_748_ = true;
                    }
                    let _e479 = phi_747_;
                    let _e481 = phi_748_;
                    phi_673_ = _e479;
                    phi_749_ = _e481;
                } else {
                    phi_673_ = u32();
                    phi_749_ = false;
                }
                let _e483 = phi_673_;
                let _e485 = phi_749_;
                continue;
                continuing {
                    phi_669_ = _e442;
                    phi_672_ = _e483;
                    break if !(_e485);
                }
            }
            workgroupBarrier();
            let _e488 = atomicLoad((&counters[4u]));
            if (2048u < _e488) {
                phi_756_ = 2048u;
            } else {
                phi_756_ = _e488;
            }
            let _e491 = phi_756_;
            if (_e39 == 0u) {
                atomicStore((&counters[5u]), _e491);
            }
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e496 = atomicLoad((&counters[5u]));
                if (_e496 > 0u) {
                    let _e499 = atomicAdd((&output.member[0u]), _e496);
                    if ((_e499 + _e496) < _e499) {
                        let _e503 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e499);
                }
            }
            workgroupBarrier();
            let _e506 = atomicLoad((&counters[6u]));
            phi_789_ = type_18(0u, 16u);
            loop {
                let _e508 = phi_789_;
                if (_e508.member < _e508.member_1) {
                    phi_790_ = type_18((_e508.member + 1u), _e508.member_1);
                    phi_813_ = type_18(1u, _e508.member);
                } else {
                    phi_790_ = _e508;
                    phi_813_ = type_18(0u, type_18().member_1);
                }
                let _e520 = phi_790_;
                let _e522 = phi_813_;
                if (bitcast<i32>(_e522.member) != 0i) {
                    let _e528 = (_e39 + (_e522.member_1 * 128u));
                    if (_e528 >= _e491) {
                        phi_859_ = false;
                    } else {
                        let _e531 = hits[_e528];
                        let _e534 = ((_e531 >> bitcast<u32>(10i)) & 3u);
                        let _e540 = params.member.member_16;
                        let _e541 = (_e506 + _e528);
                        let _e544 = firsts[(2u * _e534)];
                        let _e549 = firsts[((2u * _e534) + 1u)];
                        if (_e541 < _e540) {
                            atomicStore((&output.member[(4u + (2u * _e541))]), (_e544 + ((_e531 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[((2u * _e541) + 5u)]), (_e549 + (_e531 & 31u)));
                        }
                        phi_859_ = true;
                    }
                    let _e559 = phi_859_;
                    phi_860_ = _e559;
                } else {
                    phi_860_ = false;
                }
                let _e561 = phi_860_;
                continue;
                continuing {
                    phi_789_ = _e520;
                    break if !(_e561);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_204_ = _e115;
            break if !(_e121);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
