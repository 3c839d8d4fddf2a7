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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
@group(0) @binding(2) 
var<storage> input: type_11;
@group(0) @binding(3) 
var<storage, read_write> output: type_28;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_20, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_128_: u32;
    var phi_159_: u32;
    var phi_160_: u32;
    var phi_168_: u32;
    var phi_184_: u32;
    var phi_205_: u32;
    var phi_206_: u32;
    var phi_209_: type_9;
    var phi_210_: type_9;
    var phi_233_: type_9;
    var phi_274_: u32;
    var phi_275_: u32;
    var phi_283_: u32;
    var phi_295_: u32;
    var phi_351_: array<u32, 2>;
    var phi_549_: bool;
    var phi_550_: bool;
    var phi_554_: type_20;
    var phi_563_: bool;
    var phi_570_: type_9;
    var phi_573_: u32;
    var phi_571_: type_9;
    var phi_596_: type_9;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_668_: bool;
    var phi_686_: u32;
    var phi_687_: u32;
    var phi_688_: u32;
    var phi_574_: u32;
    var phi_691_: type_9;
    var phi_694_: u32;
    var phi_692_: type_9;
    var phi_717_: type_9;
    var phi_768_: u32;
    var phi_769_: bool;
    var phi_695_: u32;
    var phi_770_: bool;
    var phi_777_: u32;
    var phi_810_: type_9;
    var phi_811_: type_9;
    var phi_834_: type_9;
    var phi_879_: bool;
    var phi_880_: bool;
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
    let _e54 = params.member.member_1.member_2;
    let _e56 = input.member[0u];
    if (_e54 < _e56) {
        phi_128_ = _e54;
    } else {
        phi_128_ = _e56;
    }
    let _e59 = phi_128_;
    let _e60 = (_e39 / 32u);
    let _e63 = params.member.member_1.member_1;
    if (_e59 > _e63) {
        let _e67 = params.member.member_1.member_1;
        let _e68 = (_e59 - _e67);
        let _e71 = params.member.member_2.member_3;
        if (_e71 == 0u) {
            return;
        }
        let _e73 = (_e68 / _e71);
        if (_e71 == 0u) {
            return;
        }
        if ((_e68 % _e71) > 0u) {
            phi_159_ = (_e73 + 1u);
        } else {
            phi_159_ = _e73;
        }
        let _e79 = phi_159_;
        phi_160_ = _e79;
    } else {
        phi_160_ = 0u;
    }
    let _e81 = phi_160_;
    let _e84 = params.member.member_2.member_4;
    if (_e84 < _e81) {
        phi_168_ = _e84;
    } else {
        phi_168_ = _e81;
    }
    let _e87 = phi_168_;
    let _e88 = (_e87 / 4u);
    if ((_e87 % 4u) > 0u) {
        phi_184_ = (_e88 + 1u);
    } else {
        phi_184_ = _e88;
    }
    let _e93 = phi_184_;
    if (_e93 > _e48) {
        let _e95 = (_e93 - _e48);
        if (_e51 == 0u) {
            return;
        }
        let _e97 = (_e95 / _e51);
        if (_e51 == 0u) {
            return;
        }
        if ((_e95 % _e51) > 0u) {
            phi_205_ = (_e97 + 1u);
        } else {
            phi_205_ = _e97;
        }
        let _e103 = phi_205_;
        phi_206_ = _e103;
    } else {
        phi_206_ = 0u;
    }
    let _e105 = phi_206_;
    phi_209_ = type_9(0u, _e105);
    loop {
        let _e108 = phi_209_;
        if (_e108.member < _e108.member_1) {
            phi_210_ = type_9((_e108.member + 1u), _e108.member_1);
            phi_233_ = type_9(1u, _e108.member);
        } else {
            phi_210_ = _e108;
            phi_233_ = type_9(0u, type_9().member_1);
        }
        let _e120 = phi_210_;
        let _e122 = phi_233_;
        let _e126 = (bitcast<i32>(_e122.member) != 0i);
        if _e126 {
            let _e130 = (((_e48 + (_e122.member_1 * _e51)) * 4u) + _e60);
            let _e133 = params.member.member_1.member_1;
            if (_e59 > _e133) {
                let _e137 = params.member.member_1.member_1;
                let _e138 = (_e59 - _e137);
                let _e141 = params.member.member_2.member_3;
                if (_e141 == 0u) {
                    return;
                }
                let _e143 = (_e138 / _e141);
                if (_e141 == 0u) {
                    return;
                }
                if ((_e138 % _e141) > 0u) {
                    phi_274_ = (_e143 + 1u);
                } else {
                    phi_274_ = _e143;
                }
                let _e149 = phi_274_;
                phi_275_ = _e149;
            } else {
                phi_275_ = 0u;
            }
            let _e151 = phi_275_;
            let _e154 = params.member.member_2.member_4;
            if (_e154 < _e151) {
                phi_283_ = _e154;
            } else {
                phi_283_ = _e151;
            }
            let _e157 = phi_283_;
            let _e158 = (_e130 < _e157);
            let _e161 = params.member.member_1.member_1;
            if _e158 {
                let _e164 = params.member.member_2.member_3;
                phi_295_ = (_e130 * _e164);
            } else {
                phi_295_ = 0u;
            }
            let _e167 = phi_295_;
            let _e169 = (2u * (_e161 + _e167));
            let _e172 = input.member[(4u + _e169)];
            let _e175 = input.member[(_e169 + 5u)];
            if (_e39 < 8u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if ((_e39 % 32u) == 0u) {
                firsts[(2u * _e60)] = (_e172 * 32u);
                firsts[((2u * _e60) + 1u)] = (_e175 * 32u);
            }
            let _e189 = params.member.member_2.member_1;
            if (_e189 == 0u) {
                phi_351_ = array<u32, 2>(0u, 2u);
            } else {
                phi_351_ = array<u32, 2>(1u, 1u);
            }
            let _e192 = phi_351_;
            let _e195 = (_e39 / 32u);
            let _e196 = (_e39 % 32u);
            let _e200 = params.member.member_2.member_2;
            let _e204 = params.member.member_2.member[_e200][_e192[0]];
            let _e207 = nodes.member[(_e204 + _e172)];
            let _e211 = params.member.member_2.member_2;
            let _e215 = params.member.member_2.member[_e211][_e192[1]];
            let _e218 = nodes.member[(_e215 + _e175)];
            let _e222 = params.member.member_2.member_2;
            let _e229 = params.member.member_2.member[(_e222 - 1u)][_e192[0]];
            let _e232 = nodes.member[(_e229 + ((_e172 * 32u) + _e196))];
            let _e236 = params.member.member_2.member_2;
            let _e243 = params.member.member_2.member[(_e236 - 1u)][_e192[1]];
            let _e246 = nodes.member[(_e243 + ((_e175 * 32u) + _e196))];
            if _e158 {
                if ((((((_e246.member[0] <= _e207.member_1[0]) && (_e207.member[0] <= _e246.member_1[0])) && (_e246.member[1] <= _e207.member_1[1])) && (_e207.member[1] <= _e246.member_1[1])) && (_e246.member[2] <= _e207.member_1[2])) && (_e207.member[2] <= _e246.member_1[2])) {
                    let _e284 = atomicAdd((&counters[_e195]), 1u);
                    let _e285 = ((_e195 * 32u) + _e284);
                    columns[_e285] = type_20(array<f32, 3>(_e246.member[0], _e246.member[1], _e246.member[2]), array<f32, 3>(_e246.member_1[0], _e246.member_1[1], _e246.member_1[2]));
                    names[_e285] = _e196;
                }
            }
            workgroupBarrier();
            if _e158 {
                if ((((((_e232.member[0] <= _e218.member_1[0]) && (_e218.member[0] <= _e232.member_1[0])) && (_e232.member[1] <= _e218.member_1[1])) && (_e218.member[1] <= _e232.member_1[1])) && (_e232.member[2] <= _e218.member_1[2])) && (_e218.member[2] <= _e232.member_1[2])) {
                    phi_549_ = false;
                } else {
                    phi_549_ = true;
                }
                let _e335 = phi_549_;
                phi_550_ = _e335;
            } else {
                phi_550_ = true;
            }
            let _e337 = phi_550_;
            if _e337 {
                phi_554_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_554_ = _e232;
            }
            let _e339 = phi_554_;
            let _e342 = params.member.member_2.member_1;
            if (_e342 == 1u) {
                phi_563_ = (_e172 == _e175);
            } else {
                phi_563_ = false;
            }
            let _e346 = phi_563_;
            let _e347 = (_e39 / 32u);
            let _e348 = (_e39 % 32u);
            let _e350 = atomicLoad((&counters[_e347]));
            phi_570_ = type_9(0u, _e350);
            phi_573_ = 0u;
            loop {
                let _e353 = phi_570_;
                let _e355 = phi_573_;
                local = _e355;
                if (_e353.member < _e353.member_1) {
                    phi_571_ = type_9((_e353.member + 1u), _e353.member_1);
                    phi_596_ = type_9(1u, _e353.member);
                } else {
                    phi_571_ = _e353;
                    phi_596_ = type_9(0u, type_9().member_1);
                }
                let _e367 = phi_571_;
                let _e369 = phi_596_;
                let _e373 = (bitcast<i32>(_e369.member) != 0i);
                if _e373 {
                    let _e377 = names[((_e347 * 32u) + _e369.member_1)];
                    let _e381 = columns[((_e347 * 32u) + _e369.member_1)];
                    if ((((((_e339.member[0] <= _e381.member_1[0]) && (_e381.member[0] <= _e339.member_1[0])) && (_e339.member[1] <= _e381.member_1[1])) && (_e381.member[1] <= _e339.member_1[1])) && (_e339.member[2] <= _e381.member_1[2])) && (_e381.member[2] <= _e339.member_1[2])) {
                        if _e346 {
                            let _e413 = (_e348 < _e377);
                            if _e413 {
                                phi_662_ = bool();
                            } else {
                                if (_e348 == _e377) {
                                    phi_661_ = true;
                                } else {
                                    phi_661_ = false;
                                }
                                let _e416 = phi_661_;
                                phi_662_ = _e416;
                            }
                            let _e418 = phi_662_;
                            phi_663_ = _e418;
                            phi_664_ = _e413;
                        } else {
                            phi_663_ = bool();
                            phi_664_ = true;
                        }
                        let _e420 = phi_663_;
                        let _e422 = phi_664_;
                        if _e422 {
                            phi_668_ = true;
                        } else {
                            phi_668_ = _e420;
                        }
                        let _e424 = phi_668_;
                        if _e424 {
                            let _e426 = atomicAdd((&counters[4u]), 1u);
                            if (_e426 < 2048u) {
                                hits[_e426] = (((_e347 << bitcast<u32>(10i)) | (_e348 << bitcast<u32>(5i))) | _e377);
                                phi_686_ = _e355;
                            } else {
                                phi_686_ = (_e355 | (1u << bitcast<u32>((_e369.member_1 & 31u))));
                            }
                            let _e440 = phi_686_;
                            phi_687_ = _e440;
                        } else {
                            phi_687_ = _e355;
                        }
                        let _e442 = phi_687_;
                        phi_688_ = _e442;
                    } else {
                        phi_688_ = _e355;
                    }
                    let _e444 = phi_688_;
                    phi_574_ = _e444;
                } else {
                    phi_574_ = u32();
                }
                let _e446 = phi_574_;
                continue;
                continuing {
                    phi_570_ = _e367;
                    phi_573_ = _e446;
                    break if !(_e373);
                }
            }
            phi_691_ = type_9(0u, 32u);
            let _e620 = local;
            phi_694_ = _e620;
            loop {
                let _e449 = phi_691_;
                let _e451 = phi_694_;
                if (_e449.member < _e449.member_1) {
                    phi_692_ = type_9((_e449.member + 1u), _e449.member_1);
                    phi_717_ = type_9(1u, _e449.member);
                } else {
                    phi_692_ = _e449;
                    phi_717_ = type_9(0u, type_9().member_1);
                }
                let _e463 = phi_692_;
                let _e465 = phi_717_;
                if (bitcast<i32>(_e465.member) != 0i) {
                    if (_e451 == 0u) {
                        phi_768_ = u32();
                        phi_769_ = false;
                    } else {
                        let _e476 = names[((_e60 * 32u) + select(firstTrailingBit(_e451), 32u, (_e451 == 0u)))];
                        let _e481 = params.member.member_1.member_3;
                        let _e488 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e488 + 1u) < _e488) {
                            let _e492 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e488 < _e481) {
                            let _e494 = (2u * _e488);
                            atomicStore((&output.member[(4u + _e494)]), ((_e172 * 32u) + (_e39 % 32u)));
                            atomicStore((&output.member[(_e494 + 5u)]), ((_e175 * 32u) + _e476));
                        }
                        phi_768_ = (_e451 & (_e451 - 1u));
                        phi_769_ = true;
                    }
                    let _e500 = phi_768_;
                    let _e502 = phi_769_;
                    phi_695_ = _e500;
                    phi_770_ = _e502;
                } else {
                    phi_695_ = u32();
                    phi_770_ = false;
                }
                let _e504 = phi_695_;
                let _e506 = phi_770_;
                continue;
                continuing {
                    phi_691_ = _e463;
                    phi_694_ = _e504;
                    break if !(_e506);
                }
            }
            workgroupBarrier();
            let _e509 = atomicLoad((&counters[4u]));
            if (2048u < _e509) {
                phi_777_ = 2048u;
            } else {
                phi_777_ = _e509;
            }
            let _e512 = phi_777_;
            if (_e39 == 0u) {
                atomicStore((&counters[5u]), _e512);
            }
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e517 = atomicLoad((&counters[5u]));
                if (_e517 > 0u) {
                    let _e520 = atomicAdd((&output.member[0u]), _e517);
                    if ((_e520 + _e517) < _e520) {
                        let _e524 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e520);
                }
            }
            workgroupBarrier();
            let _e527 = atomicLoad((&counters[6u]));
            phi_810_ = type_9(0u, 16u);
            loop {
                let _e529 = phi_810_;
                if (_e529.member < _e529.member_1) {
                    phi_811_ = type_9((_e529.member + 1u), _e529.member_1);
                    phi_834_ = type_9(1u, _e529.member);
                } else {
                    phi_811_ = _e529;
                    phi_834_ = type_9(0u, type_9().member_1);
                }
                let _e541 = phi_811_;
                let _e543 = phi_834_;
                if (bitcast<i32>(_e543.member) != 0i) {
                    let _e549 = (_e39 + (_e543.member_1 * 128u));
                    if (_e549 >= _e512) {
                        phi_879_ = false;
                    } else {
                        let _e552 = hits[_e549];
                        let _e555 = ((_e552 >> bitcast<u32>(10i)) & 3u);
                        let _e562 = firsts[(2u * _e555)];
                        let _e567 = firsts[((2u * _e555) + 1u)];
                        let _e571 = params.member.member_1.member_3;
                        let _e572 = (_e527 + _e549);
                        if (_e572 < _e571) {
                            let _e574 = (2u * _e572);
                            atomicStore((&output.member[(4u + _e574)]), (_e562 + ((_e552 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e574 + 5u)]), (_e567 + (_e552 & 31u)));
                        }
                        phi_879_ = true;
                    }
                    let _e580 = phi_879_;
                    phi_880_ = _e580;
                } else {
                    phi_880_ = false;
                }
                let _e582 = phi_880_;
                continue;
                continuing {
                    phi_810_ = _e541;
                    break if !(_e582);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_209_ = _e120;
            break if !(_e126);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
