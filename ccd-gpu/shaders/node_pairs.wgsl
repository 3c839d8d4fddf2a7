struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
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

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_22 {
    member: array<u32>,
}

struct type_31 {
    member: u32,
    member_1: u32,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> nodes: type_18;
@group(0) @binding(2) 
var<storage> input: type_22;
@group(0) @binding(3) 
var<storage, read_write> output: type_43;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_6, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_() {
    var phi_127_: u32;
    var phi_155_: u32;
    var phi_156_: u32;
    var phi_163_: u32;
    var phi_179_: u32;
    var phi_200_: u32;
    var phi_201_: u32;
    var phi_204_: type_31;
    var phi_205_: type_31;
    var phi_228_: type_31;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_274_: u32;
    var phi_284_: u32;
    var phi_334_: array<u32, 2>;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_533_: type_6;
    var phi_541_: bool;
    var phi_548_: type_31;
    var phi_551_: u32;
    var phi_549_: type_31;
    var phi_574_: type_31;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_646_: bool;
    var phi_664_: u32;
    var phi_665_: u32;
    var phi_666_: u32;
    var phi_552_: u32;
    var phi_669_: type_31;
    var phi_672_: u32;
    var phi_670_: type_31;
    var phi_695_: type_31;
    var phi_747_: u32;
    var phi_748_: bool;
    var phi_673_: u32;
    var phi_749_: bool;
    var phi_756_: u32;
    var phi_789_: type_31;
    var phi_790_: type_31;
    var phi_813_: type_31;
    var phi_859_: bool;
    var phi_860_: bool;
    var local: u32;

    let _e50 = id_1;
    let _e51 = n_1;
    let _e52 = lane_1;
    let _e61 = ((_e50.y * _e51.x) + _e50.x);
    let _e64 = (_e51.x * _e51.y);
    let _e66 = params.member.member_15;
    let _e68 = input.member[0u];
    if (_e66 < _e68) {
        phi_127_ = _e66;
    } else {
        phi_127_ = _e68;
    }
    let _e71 = phi_127_;
    let _e72 = (_e52 / 32u);
    let _e74 = params.member.member_12;
    if (_e71 > _e74) {
        let _e77 = params.member.member_12;
        let _e78 = (_e71 - _e77);
        let _e80 = params.member.member_13;
        if (_e80 == 0u) {
            return;
        }
        let _e82 = (_e78 / _e80);
        if (_e80 == 0u) {
            return;
        }
        if ((_e78 % _e80) > 0u) {
            phi_155_ = (_e82 + 1u);
        } else {
            phi_155_ = _e82;
        }
        let _e88 = phi_155_;
        phi_156_ = _e88;
    } else {
        phi_156_ = 0u;
    }
    let _e90 = phi_156_;
    let _e92 = params.member.member_14;
    if (_e92 < _e90) {
        phi_163_ = _e92;
    } else {
        phi_163_ = _e90;
    }
    let _e95 = phi_163_;
    let _e96 = (_e95 / 4u);
    if ((_e95 % 4u) > 0u) {
        phi_179_ = (_e96 + 1u);
    } else {
        phi_179_ = _e96;
    }
    let _e101 = phi_179_;
    if (_e101 > _e61) {
        let _e103 = (_e101 - _e61);
        if (_e64 == 0u) {
            return;
        }
        let _e105 = (_e103 / _e64);
        if (_e64 == 0u) {
            return;
        }
        if ((_e103 % _e64) > 0u) {
            phi_200_ = (_e105 + 1u);
        } else {
            phi_200_ = _e105;
        }
        let _e111 = phi_200_;
        phi_201_ = _e111;
    } else {
        phi_201_ = 0u;
    }
    let _e113 = phi_201_;
    phi_204_ = type_31(0u, _e113);
    loop {
        let _e116 = phi_204_;
        if (_e116.member < _e116.member_1) {
            phi_205_ = type_31((_e116.member + 1u), _e116.member_1);
            phi_228_ = type_31(1u, _e116.member);
        } else {
            phi_205_ = _e116;
            phi_228_ = type_31(0u, type_31().member_1);
        }
        let _e130 = phi_205_;
        let _e132 = phi_228_;
        let _e136 = (bitcast<i32>(_e132.member) != 0i);
        if _e136 {
            let _e140 = (((_e61 + (_e132.member_1 * _e64)) * 4u) + _e72);
            let _e142 = params.member.member_12;
            if (_e71 > _e142) {
                let _e145 = params.member.member_12;
                let _e146 = (_e71 - _e145);
                let _e148 = params.member.member_13;
                if (_e148 == 0u) {
                    return;
                }
                let _e150 = (_e146 / _e148);
                if (_e148 == 0u) {
                    return;
                }
                if ((_e146 % _e148) > 0u) {
                    phi_266_ = (_e150 + 1u);
                } else {
                    phi_266_ = _e150;
                }
                let _e156 = phi_266_;
                phi_267_ = _e156;
            } else {
                phi_267_ = 0u;
            }
            let _e158 = phi_267_;
            let _e160 = params.member.member_14;
            if (_e160 < _e158) {
                phi_274_ = _e160;
            } else {
                phi_274_ = _e158;
            }
            let _e163 = phi_274_;
            let _e164 = (_e140 < _e163);
            let _e166 = params.member.member_12;
            if _e164 {
                let _e168 = params.member.member_13;
                phi_284_ = (_e140 * _e168);
            } else {
                phi_284_ = 0u;
            }
            let _e171 = phi_284_;
            let _e173 = (2u * (_e166 + _e171));
            let _e176 = input.member[(4u + _e173)];
            let _e179 = input.member[(_e173 + 5u)];
            if (_e52 < 8u) {
                atomicStore((&counters[_e52]), 0u);
            }
            workgroupBarrier();
            if ((_e52 % 32u) == 0u) {
                firsts[(2u * _e72)] = (_e176 * 32u);
                firsts[((2u * _e72) + 1u)] = (_e179 * 32u);
            }
            let _e192 = params.member.member_8;
            if (_e192 == 0u) {
                phi_334_ = array<u32, 2>(0u, 2u);
            } else {
                phi_334_ = array<u32, 2>(1u, 1u);
            }
            let _e195 = phi_334_;
            let _e198 = (_e52 / 32u);
            let _e199 = (_e52 % 32u);
            let _e201 = params.member.member_9;
            if (_e201 < 8u) {
            } else {
                return;
            }
            if (_e195[0] < 4u) {
            } else {
                return;
            }
            let _e207 = params.member.member_20[_e201][_e195[0]];
            let _e210 = nodes.member[(_e207 + _e176)];
            let _e212 = params.member.member_9;
            if (_e212 < 8u) {
            } else {
                return;
            }
            if (_e195[1] < 4u) {
            } else {
                return;
            }
            let _e218 = params.member.member_20[_e212][_e195[1]];
            let _e221 = nodes.member[(_e218 + _e179)];
            let _e223 = params.member.member_9;
            let _e224 = (_e223 - 1u);
            if (_e224 < 8u) {
            } else {
                return;
            }
            if (_e195[0] < 4u) {
            } else {
                return;
            }
            let _e232 = params.member.member_20[_e224][_e195[0]];
            let _e235 = nodes.member[(_e232 + ((_e176 * 32u) + _e199))];
            let _e237 = params.member.member_9;
            let _e238 = (_e237 - 1u);
            if (_e238 < 8u) {
            } else {
                return;
            }
            if (_e195[1] < 4u) {
            } else {
                return;
            }
            let _e246 = params.member.member_20[_e238][_e195[1]];
            let _e249 = nodes.member[(_e246 + ((_e179 * 32u) + _e199))];
            if _e164 {
                if ((((((_e249.member[0] <= _e210.member_1[0]) && (_e210.member[0] <= _e249.member_1[0])) && (_e249.member[1] <= _e210.member_1[1])) && (_e210.member[1] <= _e249.member_1[1])) && (_e249.member[2] <= _e210.member_1[2])) && (_e210.member[2] <= _e249.member_1[2])) {
                    let _e287 = atomicAdd((&counters[_e198]), 1u);
                    let _e288 = ((_e198 * 32u) + _e287);
                    columns[_e288] = type_6(array<f32, 3>(_e249.member[0], _e249.member[1], _e249.member[2]), array<f32, 3>(_e249.member_1[0], _e249.member_1[1], _e249.member_1[2]));
                    names[_e288] = _e199;
                }
            }
            workgroupBarrier();
            if _e164 {
                if ((((((_e235.member[0] <= _e221.member_1[0]) && (_e221.member[0] <= _e235.member_1[0])) && (_e235.member[1] <= _e221.member_1[1])) && (_e221.member[1] <= _e235.member_1[1])) && (_e235.member[2] <= _e221.member_1[2])) && (_e221.member[2] <= _e235.member_1[2])) {
                    phi_528_ = false;
                } else {
                    phi_528_ = true;
                }
                let _e338 = phi_528_;
                phi_529_ = _e338;
            } else {
                phi_529_ = true;
            }
            let _e340 = phi_529_;
            if _e340 {
                phi_533_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_533_ = _e235;
            }
            let _e342 = phi_533_;
            let _e344 = params.member.member_8;
            if (_e344 == 1u) {
                phi_541_ = (_e176 == _e179);
            } else {
                phi_541_ = false;
            }
            let _e348 = phi_541_;
            let _e349 = (_e52 / 32u);
            let _e350 = (_e52 % 32u);
            let _e352 = atomicLoad((&counters[_e349]));
            phi_548_ = type_31(0u, _e352);
            phi_551_ = 0u;
            loop {
                let _e355 = phi_548_;
                let _e357 = phi_551_;
                local = _e357;
                if (_e355.member < _e355.member_1) {
                    phi_549_ = type_31((_e355.member + 1u), _e355.member_1);
                    phi_574_ = type_31(1u, _e355.member);
                } else {
                    phi_549_ = _e355;
                    phi_574_ = type_31(0u, type_31().member_1);
                }
                let _e371 = phi_549_;
                let _e373 = phi_574_;
                let _e377 = (bitcast<i32>(_e373.member) != 0i);
                if _e377 {
                    let _e381 = names[((_e349 * 32u) + _e373.member_1)];
                    let _e385 = columns[((_e349 * 32u) + _e373.member_1)];
                    if ((((((_e342.member[0] <= _e385.member_1[0]) && (_e385.member[0] <= _e342.member_1[0])) && (_e342.member[1] <= _e385.member_1[1])) && (_e385.member[1] <= _e342.member_1[1])) && (_e342.member[2] <= _e385.member_1[2])) && (_e385.member[2] <= _e342.member_1[2])) {
                        if _e348 {
                            let _e417 = (_e350 < _e381);
                            if _e417 {
                                phi_640_ = bool();
                            } else {
                                if (_e350 == _e381) {
                                    phi_639_ = true;
                                } else {
                                    phi_639_ = false;
                                }
                                let _e420 = phi_639_;
                                phi_640_ = _e420;
                            }
                            let _e422 = phi_640_;
                            phi_641_ = _e422;
                            phi_642_ = _e417;
                        } else {
                            phi_641_ = bool();
                            phi_642_ = true;
                        }
                        let _e424 = phi_641_;
                        let _e426 = phi_642_;
                        if _e426 {
                            phi_646_ = true;
                        } else {
                            phi_646_ = _e424;
                        }
                        let _e428 = phi_646_;
                        if _e428 {
                            let _e430 = atomicAdd((&counters[4u]), 1u);
                            if (_e430 < 2048u) {
                                hits[_e430] = (((_e349 << bitcast<u32>(10i)) | (_e350 << bitcast<u32>(5i))) | _e381);
                                phi_664_ = _e357;
                            } else {
                                phi_664_ = (_e357 | (1u << bitcast<u32>((_e373.member_1 & 31u))));
                            }
                            let _e444 = phi_664_;
                            phi_665_ = _e444;
                        } else {
                            phi_665_ = _e357;
                        }
                        let _e446 = phi_665_;
                        phi_666_ = _e446;
                    } else {
                        phi_666_ = _e357;
                    }
                    let _e448 = phi_666_;
                    phi_552_ = _e448;
                } else {
                    phi_552_ = u32();
                }
                let _e450 = phi_552_;
                continue;
                continuing {
                    phi_548_ = _e371;
                    phi_551_ = _e450;
                    break if !(_e377);
                }
            }
            phi_669_ = type_31(0u, 32u);
            let _e628 = local;
            phi_672_ = _e628;
            loop {
                let _e453 = phi_669_;
                let _e455 = phi_672_;
                if (_e453.member < _e453.member_1) {
                    phi_670_ = type_31((_e453.member + 1u), _e453.member_1);
                    phi_695_ = type_31(1u, _e453.member);
                } else {
                    phi_670_ = _e453;
                    phi_695_ = type_31(0u, type_31().member_1);
                }
                let _e469 = phi_670_;
                let _e471 = phi_695_;
                if (bitcast<i32>(_e471.member) != 0i) {
                    if (_e455 == 0u) {
                        phi_747_ = u32();
                        phi_748_ = false;
                    } else {
                        let _e482 = names[((_e72 * 32u) + select(firstTrailingBit(_e455), 32u, (_e455 == 0u)))];
                        let _e486 = params.member.member_16;
                        let _e493 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e493 + 1u) < _e493) {
                            let _e497 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e493 < _e486) {
                            atomicStore((&output.member[(4u + (2u * _e493))]), ((_e176 * 32u) + (_e52 % 32u)));
                            atomicStore((&output.member[((2u * _e493) + 5u)]), ((_e179 * 32u) + _e482));
                        }
                        phi_747_ = (_e455 & (_e455 - 1u));
                        phi_748_ = true;
                    }
                    let _e506 = phi_747_;
                    let _e508 = phi_748_;
                    phi_673_ = _e506;
                    phi_749_ = _e508;
                } else {
                    phi_673_ = u32();
                    phi_749_ = false;
                }
                let _e510 = phi_673_;
                let _e512 = phi_749_;
                continue;
                continuing {
                    phi_669_ = _e469;
                    phi_672_ = _e510;
                    break if !(_e512);
                }
            }
            workgroupBarrier();
            let _e515 = atomicLoad((&counters[4u]));
            if (2048u < _e515) {
                phi_756_ = 2048u;
            } else {
                phi_756_ = _e515;
            }
            let _e518 = phi_756_;
            if (_e52 == 0u) {
                atomicStore((&counters[5u]), _e518);
            }
            workgroupBarrier();
            if (_e52 == 0u) {
                let _e523 = atomicLoad((&counters[5u]));
                if (_e523 > 0u) {
                    let _e526 = atomicAdd((&output.member[0u]), _e523);
                    if ((_e526 + _e523) < _e526) {
                        let _e530 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e526);
                }
            }
            workgroupBarrier();
            let _e533 = atomicLoad((&counters[6u]));
            phi_789_ = type_31(0u, 16u);
            loop {
                let _e535 = phi_789_;
                if (_e535.member < _e535.member_1) {
                    phi_790_ = type_31((_e535.member + 1u), _e535.member_1);
                    phi_813_ = type_31(1u, _e535.member);
                } else {
                    phi_790_ = _e535;
                    phi_813_ = type_31(0u, type_31().member_1);
                }
                let _e549 = phi_790_;
                let _e551 = phi_813_;
                if (bitcast<i32>(_e551.member) != 0i) {
                    let _e557 = (_e52 + (_e551.member_1 * 128u));
                    if (_e557 >= _e518) {
                        phi_859_ = false;
                    } else {
                        let _e560 = hits[_e557];
                        let _e563 = ((_e560 >> bitcast<u32>(10i)) & 3u);
                        let _e569 = params.member.member_16;
                        let _e570 = (_e533 + _e557);
                        let _e573 = firsts[(2u * _e563)];
                        let _e578 = firsts[((2u * _e563) + 1u)];
                        if (_e570 < _e569) {
                            atomicStore((&output.member[(4u + (2u * _e570))]), (_e573 + ((_e560 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[((2u * _e570) + 5u)]), (_e578 + (_e560 & 31u)));
                        }
                        phi_859_ = true;
                    }
                    let _e588 = phi_859_;
                    phi_860_ = _e588;
                } else {
                    phi_860_ = false;
                }
                let _e590 = phi_860_;
                continue;
                continuing {
                    phi_789_ = _e549;
                    break if !(_e590);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_204_ = _e130;
            break if !(_e136);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
