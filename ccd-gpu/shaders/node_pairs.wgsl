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

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
@group(0) @binding(2) 
var<storage> input: type_11;
@group(0) @binding(3) 
var<storage, read_write> output: type_30;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_130_: u32;
    var phi_162_: u32;
    var phi_163_: u32;
    var phi_171_: u32;
    var phi_187_: u32;
    var phi_208_: u32;
    var phi_209_: u32;
    var phi_212_: type_9;
    var phi_213_: type_9;
    var phi_236_: type_9;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_286_: u32;
    var phi_298_: u32;
    var phi_353_: array<u32, 2>;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_562_: type_24;
    var phi_571_: bool;
    var phi_578_: type_9;
    var phi_581_: u32;
    var phi_579_: type_9;
    var phi_604_: type_9;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_676_: bool;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_582_: u32;
    var phi_699_: type_9;
    var phi_702_: u32;
    var phi_700_: type_9;
    var phi_725_: type_9;
    var phi_775_: u32;
    var phi_776_: bool;
    var phi_703_: u32;
    var phi_777_: bool;
    var phi_784_: u32;
    var phi_817_: type_9;
    var phi_818_: type_9;
    var phi_841_: type_9;
    var phi_886_: bool;
    var phi_887_: bool;
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
        phi_130_ = _e54;
    } else {
        phi_130_ = _e56;
    }
    let _e59 = phi_130_;
    let _e60 = (_e39 / 32u);
    let _e61 = (_e39 % 32u);
    let _e64 = params.member.member_1.member_1;
    if (_e59 > _e64) {
        let _e68 = params.member.member_1.member_1;
        let _e69 = (_e59 - _e68);
        let _e72 = params.member.member_2.member_3;
        if (_e72 == 0u) {
            return;
        }
        let _e74 = (_e69 / _e72);
        if (_e72 == 0u) {
            return;
        }
        if ((_e69 % _e72) > 0u) {
            phi_162_ = (_e74 + 1u);
        } else {
            phi_162_ = _e74;
        }
        let _e80 = phi_162_;
        phi_163_ = _e80;
    } else {
        phi_163_ = 0u;
    }
    let _e82 = phi_163_;
    let _e85 = params.member.member_2.member_4;
    if (_e85 < _e82) {
        phi_171_ = _e85;
    } else {
        phi_171_ = _e82;
    }
    let _e88 = phi_171_;
    let _e89 = (_e88 / 4u);
    if ((_e88 % 4u) > 0u) {
        phi_187_ = (_e89 + 1u);
    } else {
        phi_187_ = _e89;
    }
    let _e94 = phi_187_;
    if (_e94 > _e48) {
        let _e96 = (_e94 - _e48);
        if (_e51 == 0u) {
            return;
        }
        let _e98 = (_e96 / _e51);
        if (_e51 == 0u) {
            return;
        }
        if ((_e96 % _e51) > 0u) {
            phi_208_ = (_e98 + 1u);
        } else {
            phi_208_ = _e98;
        }
        let _e104 = phi_208_;
        phi_209_ = _e104;
    } else {
        phi_209_ = 0u;
    }
    let _e106 = phi_209_;
    phi_212_ = type_9(0u, _e106);
    loop {
        let _e109 = phi_212_;
        if (_e109.member < _e109.member_1) {
            phi_213_ = type_9((_e109.member + 1u), _e109.member_1);
            phi_236_ = type_9(1u, _e109.member);
        } else {
            phi_213_ = _e109;
            phi_236_ = type_9(0u, type_9().member_1);
        }
        let _e121 = phi_213_;
        let _e123 = phi_236_;
        let _e127 = (bitcast<i32>(_e123.member) != 0i);
        if _e127 {
            let _e131 = (((_e48 + (_e123.member_1 * _e51)) * 4u) + _e60);
            let _e134 = params.member.member_1.member_1;
            if (_e59 > _e134) {
                let _e138 = params.member.member_1.member_1;
                let _e139 = (_e59 - _e138);
                let _e142 = params.member.member_2.member_3;
                if (_e142 == 0u) {
                    return;
                }
                let _e144 = (_e139 / _e142);
                if (_e142 == 0u) {
                    return;
                }
                if ((_e139 % _e142) > 0u) {
                    phi_277_ = (_e144 + 1u);
                } else {
                    phi_277_ = _e144;
                }
                let _e150 = phi_277_;
                phi_278_ = _e150;
            } else {
                phi_278_ = 0u;
            }
            let _e152 = phi_278_;
            let _e155 = params.member.member_2.member_4;
            if (_e155 < _e152) {
                phi_286_ = _e155;
            } else {
                phi_286_ = _e152;
            }
            let _e158 = phi_286_;
            let _e159 = (_e131 < _e158);
            let _e162 = params.member.member_1.member_1;
            if _e159 {
                let _e165 = params.member.member_2.member_3;
                phi_298_ = (_e131 * _e165);
            } else {
                phi_298_ = 0u;
            }
            let _e168 = phi_298_;
            let _e170 = (2u * (_e162 + _e168));
            let _e173 = input.member[(4u + _e170)];
            let _e176 = input.member[(_e170 + 5u)];
            if (_e39 < 8u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if (_e61 == 0u) {
                firsts[(2u * _e60)] = (_e173 * 32u);
                firsts[((2u * _e60) + 1u)] = (_e176 * 32u);
            }
            let _e189 = params.member.member_2.member_1;
            if (_e189 == 0u) {
                phi_353_ = array<u32, 2>(0u, 2u);
            } else {
                phi_353_ = array<u32, 2>(1u, 1u);
            }
            let _e192 = phi_353_;
            let _e195 = (_e39 / 32u);
            let _e196 = (_e39 % 32u);
            let _e200 = params.member.member_2.member_2;
            let _e204 = params.member.member_2.member[_e200][_e192[0]];
            let _e207 = nodes.member[(_e204 + _e173)];
            let _e223 = params.member.member_2.member_2;
            let _e227 = params.member.member_2.member[_e223][_e192[1]];
            let _e230 = nodes.member[(_e227 + _e176)];
            let _e246 = params.member.member_2.member_2;
            let _e253 = params.member.member_2.member[(_e246 - 1u)][_e192[0]];
            let _e256 = nodes.member[(_e253 + ((_e173 * 32u) + _e196))];
            let _e275 = params.member.member_2.member_2;
            let _e282 = params.member.member_2.member[(_e275 - 1u)][_e192[1]];
            let _e285 = nodes.member[(_e282 + ((_e176 * 32u) + _e196))];
            if _e159 {
                if ((((((_e285.member.x <= _e207.member_1.y) && (_e207.member.x <= _e285.member_1.y)) && (_e285.member.y <= _e207.member_2.x)) && (_e207.member.y <= _e285.member_2.x)) && (_e285.member_1.x <= _e207.member_2.y)) && (_e207.member_1.x <= _e285.member_2.y)) {
                    let _e311 = atomicAdd((&counters[_e195]), 1u);
                    let _e312 = ((_e195 * 32u) + _e311);
                    columns[_e312] = type_24(array<f32, 3>(_e285.member.x, _e285.member.y, _e285.member_1.x), array<f32, 3>(_e285.member_1.y, _e285.member_2.x, _e285.member_2.y));
                    names[_e312] = _e196;
                }
            }
            workgroupBarrier();
            if _e159 {
                if ((((((_e256.member.x <= _e230.member_1.y) && (_e230.member.x <= _e256.member_1.y)) && (_e256.member.y <= _e230.member_2.x)) && (_e230.member.y <= _e256.member_2.x)) && (_e256.member_1.x <= _e230.member_2.y)) && (_e230.member_1.x <= _e256.member_2.y)) {
                    phi_557_ = false;
                } else {
                    phi_557_ = true;
                }
                let _e330 = phi_557_;
                phi_558_ = _e330;
            } else {
                phi_558_ = true;
            }
            let _e332 = phi_558_;
            if _e332 {
                phi_562_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_562_ = type_24(array<f32, 3>(_e256.member.x, _e256.member.y, _e256.member_1.x), array<f32, 3>(_e256.member_1.y, _e256.member_2.x, _e256.member_2.y));
            }
            let _e334 = phi_562_;
            let _e337 = params.member.member_2.member_1;
            if (_e337 == 1u) {
                phi_571_ = (_e173 == _e176);
            } else {
                phi_571_ = false;
            }
            let _e341 = phi_571_;
            let _e342 = (_e39 / 32u);
            let _e343 = (_e39 % 32u);
            let _e345 = atomicLoad((&counters[_e342]));
            phi_578_ = type_9(0u, _e345);
            phi_581_ = 0u;
            loop {
                let _e348 = phi_578_;
                let _e350 = phi_581_;
                local = _e350;
                if (_e348.member < _e348.member_1) {
                    phi_579_ = type_9((_e348.member + 1u), _e348.member_1);
                    phi_604_ = type_9(1u, _e348.member);
                } else {
                    phi_579_ = _e348;
                    phi_604_ = type_9(0u, type_9().member_1);
                }
                let _e362 = phi_579_;
                let _e364 = phi_604_;
                let _e368 = (bitcast<i32>(_e364.member) != 0i);
                if _e368 {
                    let _e372 = names[((_e342 * 32u) + _e364.member_1)];
                    let _e376 = columns[((_e342 * 32u) + _e364.member_1)];
                    if ((((((_e334.member[0] <= _e376.member_1[0]) && (_e376.member[0] <= _e334.member_1[0])) && (_e334.member[1] <= _e376.member_1[1])) && (_e376.member[1] <= _e334.member_1[1])) && (_e334.member[2] <= _e376.member_1[2])) && (_e376.member[2] <= _e334.member_1[2])) {
                        if _e341 {
                            let _e408 = (_e343 < _e372);
                            if _e408 {
                                phi_670_ = bool();
                            } else {
                                if (_e343 == _e372) {
                                    phi_669_ = true;
                                } else {
                                    phi_669_ = false;
                                }
                                let _e411 = phi_669_;
                                phi_670_ = _e411;
                            }
                            let _e413 = phi_670_;
                            phi_671_ = _e413;
                            phi_672_ = _e408;
                        } else {
                            phi_671_ = bool();
                            phi_672_ = true;
                        }
                        let _e415 = phi_671_;
                        let _e417 = phi_672_;
                        if _e417 {
                            phi_676_ = true;
                        } else {
                            phi_676_ = _e415;
                        }
                        let _e419 = phi_676_;
                        if _e419 {
                            let _e421 = atomicAdd((&counters[4u]), 1u);
                            if (_e421 < 2048u) {
                                hits[_e421] = (((_e342 << bitcast<u32>(10i)) | (_e343 << bitcast<u32>(5i))) | _e372);
                                phi_694_ = _e350;
                            } else {
                                phi_694_ = (_e350 | (1u << bitcast<u32>((_e364.member_1 & 31u))));
                            }
                            let _e435 = phi_694_;
                            phi_695_ = _e435;
                        } else {
                            phi_695_ = _e350;
                        }
                        let _e437 = phi_695_;
                        phi_696_ = _e437;
                    } else {
                        phi_696_ = _e350;
                    }
                    let _e439 = phi_696_;
                    phi_582_ = _e439;
                } else {
                    phi_582_ = u32();
                }
                let _e441 = phi_582_;
                continue;
                continuing {
                    phi_578_ = _e362;
                    phi_581_ = _e441;
                    break if !(_e368);
                }
            }
            phi_699_ = type_9(0u, 32u);
            let _e614 = local;
            phi_702_ = _e614;
            loop {
                let _e444 = phi_699_;
                let _e446 = phi_702_;
                if (_e444.member < _e444.member_1) {
                    phi_700_ = type_9((_e444.member + 1u), _e444.member_1);
                    phi_725_ = type_9(1u, _e444.member);
                } else {
                    phi_700_ = _e444;
                    phi_725_ = type_9(0u, type_9().member_1);
                }
                let _e458 = phi_700_;
                let _e460 = phi_725_;
                if (bitcast<i32>(_e460.member) != 0i) {
                    if (_e446 == 0u) {
                        phi_775_ = u32();
                        phi_776_ = false;
                    } else {
                        let _e471 = names[((_e60 * 32u) + select(firstTrailingBit(_e446), 32u, (_e446 == 0u)))];
                        let _e480 = params.member.member_1.member_3;
                        let _e482 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e482 + 1u) < _e482) {
                            let _e486 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e482 < _e480) {
                            let _e488 = (2u * _e482);
                            atomicStore((&output.member[(4u + _e488)]), ((_e173 * 32u) + _e61));
                            atomicStore((&output.member[(_e488 + 5u)]), ((_e176 * 32u) + _e471));
                        }
                        phi_775_ = (_e446 & (_e446 - 1u));
                        phi_776_ = true;
                    }
                    let _e494 = phi_775_;
                    let _e496 = phi_776_;
                    phi_703_ = _e494;
                    phi_777_ = _e496;
                } else {
                    phi_703_ = u32();
                    phi_777_ = false;
                }
                let _e498 = phi_703_;
                let _e500 = phi_777_;
                continue;
                continuing {
                    phi_699_ = _e458;
                    phi_702_ = _e498;
                    break if !(_e500);
                }
            }
            workgroupBarrier();
            let _e503 = atomicLoad((&counters[4u]));
            if (2048u < _e503) {
                phi_784_ = 2048u;
            } else {
                phi_784_ = _e503;
            }
            let _e506 = phi_784_;
            if (_e39 == 0u) {
                atomicStore((&counters[5u]), _e506);
            }
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e511 = atomicLoad((&counters[5u]));
                if (_e511 > 0u) {
                    let _e514 = atomicAdd((&output.member[0u]), _e511);
                    if ((_e514 + _e511) < _e514) {
                        let _e518 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e514);
                }
            }
            workgroupBarrier();
            let _e521 = atomicLoad((&counters[6u]));
            phi_817_ = type_9(0u, 16u);
            loop {
                let _e523 = phi_817_;
                if (_e523.member < _e523.member_1) {
                    phi_818_ = type_9((_e523.member + 1u), _e523.member_1);
                    phi_841_ = type_9(1u, _e523.member);
                } else {
                    phi_818_ = _e523;
                    phi_841_ = type_9(0u, type_9().member_1);
                }
                let _e535 = phi_818_;
                let _e537 = phi_841_;
                if (bitcast<i32>(_e537.member) != 0i) {
                    let _e543 = (_e39 + (_e537.member_1 * 128u));
                    if (_e543 >= _e506) {
                        phi_886_ = false;
                    } else {
                        let _e546 = hits[_e543];
                        let _e549 = ((_e546 >> bitcast<u32>(10i)) & 3u);
                        let _e556 = firsts[(2u * _e549)];
                        let _e561 = firsts[((2u * _e549) + 1u)];
                        let _e565 = params.member.member_1.member_3;
                        let _e566 = (_e521 + _e543);
                        if (_e566 < _e565) {
                            let _e568 = (2u * _e566);
                            atomicStore((&output.member[(4u + _e568)]), (_e556 + ((_e546 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e568 + 5u)]), (_e561 + (_e546 & 31u)));
                        }
                        phi_886_ = true;
                    }
                    let _e574 = phi_886_;
                    phi_887_ = _e574;
                } else {
                    phi_887_ = false;
                }
                let _e576 = phi_887_;
                continue;
                continuing {
                    phi_817_ = _e535;
                    break if !(_e576);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_212_ = _e121;
            break if !(_e127);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
