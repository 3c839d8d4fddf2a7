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
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> ranges: array<u32, 1>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_135_: u32;
    var phi_167_: u32;
    var phi_168_: u32;
    var phi_176_: u32;
    var phi_192_: u32;
    var phi_213_: u32;
    var phi_214_: u32;
    var phi_217_: type_9;
    var phi_218_: type_9;
    var phi_241_: type_9;
    var phi_282_: u32;
    var phi_283_: u32;
    var phi_291_: u32;
    var phi_303_: u32;
    var phi_358_: array<u32, 2>;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_567_: type_24;
    var phi_576_: bool;
    var phi_583_: type_9;
    var phi_586_: u32;
    var phi_584_: type_9;
    var phi_609_: type_9;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_724_: u32;
    var phi_725_: u32;
    var phi_587_: u32;
    var phi_728_: type_9;
    var phi_731_: u32;
    var phi_729_: type_9;
    var phi_754_: type_9;
    var phi_804_: u32;
    var phi_805_: bool;
    var phi_732_: u32;
    var phi_806_: bool;
    var phi_813_: u32;
    var phi_846_: type_9;
    var phi_847_: type_9;
    var phi_870_: type_9;
    var phi_915_: bool;
    var phi_916_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e40 = id_2;
    let _e41 = n_2;
    let _e42 = lane_2;
    let _e51 = ((_e40.y * _e41.x) + _e40.x);
    let _e54 = (_e41.x * _e41.y);
    let _e57 = params.member.member_1.member_2;
    let _e59 = input.member[0u];
    if (_e57 < _e59) {
        phi_135_ = _e57;
    } else {
        phi_135_ = _e59;
    }
    let _e62 = phi_135_;
    let _e63 = (_e42 / 32u);
    let _e64 = (_e42 % 32u);
    let _e67 = params.member.member_1.member_1;
    if (_e62 > _e67) {
        let _e71 = params.member.member_1.member_1;
        let _e72 = (_e62 - _e71);
        let _e75 = params.member.member_2.member_3;
        if (_e75 == 0u) {
            return;
        }
        let _e77 = (_e72 / _e75);
        if (_e75 == 0u) {
            return;
        }
        if ((_e72 % _e75) > 0u) {
            phi_167_ = (_e77 + 1u);
        } else {
            phi_167_ = _e77;
        }
        let _e83 = phi_167_;
        phi_168_ = _e83;
    } else {
        phi_168_ = 0u;
    }
    let _e85 = phi_168_;
    let _e88 = params.member.member_2.member_4;
    if (_e88 < _e85) {
        phi_176_ = _e88;
    } else {
        phi_176_ = _e85;
    }
    let _e91 = phi_176_;
    let _e92 = (_e91 / 4u);
    if ((_e91 % 4u) > 0u) {
        phi_192_ = (_e92 + 1u);
    } else {
        phi_192_ = _e92;
    }
    let _e97 = phi_192_;
    if (_e97 > _e51) {
        let _e99 = (_e97 - _e51);
        if (_e54 == 0u) {
            return;
        }
        let _e101 = (_e99 / _e54);
        if (_e54 == 0u) {
            return;
        }
        if ((_e99 % _e54) > 0u) {
            phi_213_ = (_e101 + 1u);
        } else {
            phi_213_ = _e101;
        }
        let _e107 = phi_213_;
        phi_214_ = _e107;
    } else {
        phi_214_ = 0u;
    }
    let _e109 = phi_214_;
    phi_217_ = type_9(0u, _e109);
    loop {
        let _e112 = phi_217_;
        if (_e112.member < _e112.member_1) {
            phi_218_ = type_9((_e112.member + 1u), _e112.member_1);
            phi_241_ = type_9(1u, _e112.member);
        } else {
            phi_218_ = _e112;
            phi_241_ = type_9(0u, type_9().member_1);
        }
        let _e124 = phi_218_;
        let _e126 = phi_241_;
        let _e130 = (bitcast<i32>(_e126.member) != 0i);
        if _e130 {
            let _e134 = (((_e51 + (_e126.member_1 * _e54)) * 4u) + _e63);
            let _e137 = params.member.member_1.member_1;
            if (_e62 > _e137) {
                let _e141 = params.member.member_1.member_1;
                let _e142 = (_e62 - _e141);
                let _e145 = params.member.member_2.member_3;
                if (_e145 == 0u) {
                    return;
                }
                let _e147 = (_e142 / _e145);
                if (_e145 == 0u) {
                    return;
                }
                if ((_e142 % _e145) > 0u) {
                    phi_282_ = (_e147 + 1u);
                } else {
                    phi_282_ = _e147;
                }
                let _e153 = phi_282_;
                phi_283_ = _e153;
            } else {
                phi_283_ = 0u;
            }
            let _e155 = phi_283_;
            let _e158 = params.member.member_2.member_4;
            if (_e158 < _e155) {
                phi_291_ = _e158;
            } else {
                phi_291_ = _e155;
            }
            let _e161 = phi_291_;
            let _e162 = (_e134 < _e161);
            let _e165 = params.member.member_1.member_1;
            if _e162 {
                let _e168 = params.member.member_2.member_3;
                phi_303_ = (_e134 * _e168);
            } else {
                phi_303_ = 0u;
            }
            let _e171 = phi_303_;
            let _e173 = (2u * (_e165 + _e171));
            let _e176 = input.member[(4u + _e173)];
            let _e179 = input.member[(_e173 + 5u)];
            if (_e42 < 8u) {
                atomicStore((&counters[_e42]), 0u);
            }
            workgroupBarrier();
            if (_e64 == 0u) {
                firsts[(2u * _e63)] = (_e176 * 32u);
                firsts[((2u * _e63) + 1u)] = (_e179 * 32u);
            }
            let _e192 = params.member.member_2.member_1;
            if (_e192 == 0u) {
                phi_358_ = array<u32, 2>(0u, 2u);
            } else {
                phi_358_ = array<u32, 2>(1u, 1u);
            }
            let _e195 = phi_358_;
            let _e198 = (_e42 / 32u);
            let _e199 = (_e42 % 32u);
            let _e203 = params.member.member_2.member_2;
            let _e207 = params.member.member_2.member[_e203][_e195[0]];
            let _e210 = nodes.member[(_e207 + _e176)];
            let _e226 = params.member.member_2.member_2;
            let _e230 = params.member.member_2.member[_e226][_e195[1]];
            let _e233 = nodes.member[(_e230 + _e179)];
            let _e249 = params.member.member_2.member_2;
            let _e256 = params.member.member_2.member[(_e249 - 1u)][_e195[0]];
            let _e259 = nodes.member[(_e256 + ((_e176 * 32u) + _e199))];
            let _e278 = params.member.member_2.member_2;
            let _e285 = params.member.member_2.member[(_e278 - 1u)][_e195[1]];
            let _e288 = nodes.member[(_e285 + ((_e179 * 32u) + _e199))];
            if _e162 {
                if ((((((_e288.member.x <= _e210.member_1.y) && (_e210.member.x <= _e288.member_1.y)) && (_e288.member.y <= _e210.member_2.x)) && (_e210.member.y <= _e288.member_2.x)) && (_e288.member_1.x <= _e210.member_2.y)) && (_e210.member_1.x <= _e288.member_2.y)) {
                    let _e314 = atomicAdd((&counters[_e198]), 1u);
                    let _e315 = ((_e198 * 32u) + _e314);
                    columns[_e315] = type_24(array<f32, 3>(_e288.member.x, _e288.member.y, _e288.member_1.x), array<f32, 3>(_e288.member_1.y, _e288.member_2.x, _e288.member_2.y));
                    names[_e315] = _e199;
                }
            }
            workgroupBarrier();
            if _e162 {
                if ((((((_e259.member.x <= _e233.member_1.y) && (_e233.member.x <= _e259.member_1.y)) && (_e259.member.y <= _e233.member_2.x)) && (_e233.member.y <= _e259.member_2.x)) && (_e259.member_1.x <= _e233.member_2.y)) && (_e233.member_1.x <= _e259.member_2.y)) {
                    phi_562_ = false;
                } else {
                    phi_562_ = true;
                }
                let _e333 = phi_562_;
                phi_563_ = _e333;
            } else {
                phi_563_ = true;
            }
            let _e335 = phi_563_;
            if _e335 {
                phi_567_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_567_ = type_24(array<f32, 3>(_e259.member.x, _e259.member.y, _e259.member_1.x), array<f32, 3>(_e259.member_1.y, _e259.member_2.x, _e259.member_2.y));
            }
            let _e337 = phi_567_;
            let _e340 = params.member.member_2.member_1;
            if (_e340 == 1u) {
                phi_576_ = (_e176 == _e179);
            } else {
                phi_576_ = false;
            }
            let _e344 = phi_576_;
            let _e345 = (_e42 / 32u);
            let _e346 = (_e42 % 32u);
            let _e348 = atomicLoad((&counters[_e345]));
            phi_583_ = type_9(0u, _e348);
            phi_586_ = 0u;
            loop {
                let _e351 = phi_583_;
                let _e353 = phi_586_;
                local = _e353;
                if (_e351.member < _e351.member_1) {
                    phi_584_ = type_9((_e351.member + 1u), _e351.member_1);
                    phi_609_ = type_9(1u, _e351.member);
                } else {
                    phi_584_ = _e351;
                    phi_609_ = type_9(0u, type_9().member_1);
                }
                let _e365 = phi_584_;
                let _e367 = phi_609_;
                let _e371 = (bitcast<i32>(_e367.member) != 0i);
                if _e371 {
                    let _e375 = names[((_e345 * 32u) + _e367.member_1)];
                    let _e379 = columns[((_e345 * 32u) + _e367.member_1)];
                    if ((((((_e337.member[0] <= _e379.member_1[0]) && (_e379.member[0] <= _e337.member_1[0])) && (_e337.member[1] <= _e379.member_1[1])) && (_e379.member[1] <= _e337.member_1[1])) && (_e337.member[2] <= _e379.member_1[2])) && (_e379.member[2] <= _e337.member_1[2])) {
                        if _e344 {
                            let _e411 = (_e346 < _e375);
                            if _e411 {
                                phi_675_ = bool();
                            } else {
                                if (_e346 == _e375) {
                                    phi_674_ = true;
                                } else {
                                    phi_674_ = false;
                                }
                                let _e414 = phi_674_;
                                phi_675_ = _e414;
                            }
                            let _e416 = phi_675_;
                            phi_676_ = _e416;
                            phi_677_ = _e411;
                        } else {
                            phi_676_ = bool();
                            phi_677_ = true;
                        }
                        let _e418 = phi_676_;
                        let _e420 = phi_677_;
                        if _e420 {
                            phi_681_ = true;
                        } else {
                            phi_681_ = _e418;
                        }
                        let _e422 = phi_681_;
                        phi_682_ = _e422;
                    } else {
                        phi_682_ = false;
                    }
                    let _e424 = phi_682_;
                    if false {
                        if _e424 {
                            let _e428 = ranges[((_e345 * 32u) + _e375)];
                            if ((u32() >> bitcast<u32>(16i)) <= (_e428 & 65535u)) {
                                phi_704_ = ((_e428 >> bitcast<u32>(16i)) <= (u32() & 65535u));
                            } else {
                                phi_704_ = false;
                            }
                            let _e438 = phi_704_;
                            phi_705_ = _e438;
                        } else {
                            phi_705_ = false;
                        }
                        let _e440 = phi_705_;
                        phi_706_ = _e440;
                    } else {
                        phi_706_ = _e424;
                    }
                    let _e442 = phi_706_;
                    if _e442 {
                        let _e444 = atomicAdd((&counters[4u]), 1u);
                        if (_e444 < 2048u) {
                            hits[_e444] = (((_e345 << bitcast<u32>(10i)) | (_e346 << bitcast<u32>(5i))) | _e375);
                            phi_724_ = _e353;
                        } else {
                            phi_724_ = (_e353 | (1u << bitcast<u32>((_e367.member_1 & 31u))));
                        }
                        let _e458 = phi_724_;
                        phi_725_ = _e458;
                    } else {
                        phi_725_ = _e353;
                    }
                    let _e460 = phi_725_;
                    phi_587_ = _e460;
                } else {
                    phi_587_ = u32();
                }
                let _e462 = phi_587_;
                continue;
                continuing {
                    phi_583_ = _e365;
                    phi_586_ = _e462;
                    break if !(_e371);
                }
            }
            phi_728_ = type_9(0u, 32u);
            let _e638 = local;
            phi_731_ = _e638;
            loop {
                let _e465 = phi_728_;
                let _e467 = phi_731_;
                if (_e465.member < _e465.member_1) {
                    phi_729_ = type_9((_e465.member + 1u), _e465.member_1);
                    phi_754_ = type_9(1u, _e465.member);
                } else {
                    phi_729_ = _e465;
                    phi_754_ = type_9(0u, type_9().member_1);
                }
                let _e479 = phi_729_;
                let _e481 = phi_754_;
                if (bitcast<i32>(_e481.member) != 0i) {
                    if (_e467 == 0u) {
                        phi_804_ = u32();
                        phi_805_ = false;
                    } else {
                        let _e492 = names[((_e63 * 32u) + select(firstTrailingBit(_e467), 32u, (_e467 == 0u)))];
                        let _e501 = params.member.member_1.member_3;
                        let _e503 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e503 + 1u) < _e503) {
                            let _e507 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e503 < _e501) {
                            let _e509 = (2u * _e503);
                            atomicStore((&output.member[(4u + _e509)]), ((_e176 * 32u) + _e64));
                            atomicStore((&output.member[(_e509 + 5u)]), ((_e179 * 32u) + _e492));
                        }
                        phi_804_ = (_e467 & (_e467 - 1u));
                        phi_805_ = true;
                    }
                    let _e515 = phi_804_;
                    let _e517 = phi_805_;
                    phi_732_ = _e515;
                    phi_806_ = _e517;
                } else {
                    phi_732_ = u32();
                    phi_806_ = false;
                }
                let _e519 = phi_732_;
                let _e521 = phi_806_;
                continue;
                continuing {
                    phi_728_ = _e479;
                    phi_731_ = _e519;
                    break if !(_e521);
                }
            }
            workgroupBarrier();
            let _e524 = atomicLoad((&counters[4u]));
            if (2048u < _e524) {
                phi_813_ = 2048u;
            } else {
                phi_813_ = _e524;
            }
            let _e527 = phi_813_;
            if (_e42 == 0u) {
                atomicStore((&counters[5u]), _e527);
            }
            workgroupBarrier();
            if (_e42 == 0u) {
                let _e532 = atomicLoad((&counters[5u]));
                if (_e532 > 0u) {
                    let _e535 = atomicAdd((&output.member[0u]), _e532);
                    if ((_e535 + _e532) < _e535) {
                        let _e539 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e535);
                }
            }
            workgroupBarrier();
            let _e542 = atomicLoad((&counters[6u]));
            phi_846_ = type_9(0u, 16u);
            loop {
                let _e544 = phi_846_;
                if (_e544.member < _e544.member_1) {
                    phi_847_ = type_9((_e544.member + 1u), _e544.member_1);
                    phi_870_ = type_9(1u, _e544.member);
                } else {
                    phi_847_ = _e544;
                    phi_870_ = type_9(0u, type_9().member_1);
                }
                let _e556 = phi_847_;
                let _e558 = phi_870_;
                if (bitcast<i32>(_e558.member) != 0i) {
                    let _e564 = (_e42 + (_e558.member_1 * 128u));
                    if (_e564 >= _e527) {
                        phi_915_ = false;
                    } else {
                        let _e567 = hits[_e564];
                        let _e570 = ((_e567 >> bitcast<u32>(10i)) & 3u);
                        let _e577 = firsts[(2u * _e570)];
                        let _e582 = firsts[((2u * _e570) + 1u)];
                        let _e586 = params.member.member_1.member_3;
                        let _e587 = (_e542 + _e564);
                        if (_e587 < _e586) {
                            let _e589 = (2u * _e587);
                            atomicStore((&output.member[(4u + _e589)]), (_e577 + ((_e567 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e589 + 5u)]), (_e582 + (_e567 & 31u)));
                        }
                        phi_915_ = true;
                    }
                    let _e595 = phi_915_;
                    phi_916_ = _e595;
                } else {
                    phi_916_ = false;
                }
                let _e597 = phi_916_;
                continue;
                continuing {
                    phi_846_ = _e556;
                    break if !(_e597);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_217_ = _e124;
            break if !(_e130);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
