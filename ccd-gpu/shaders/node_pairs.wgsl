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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_21 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> nodes: type_23;
@group(0) @binding(2) 
var<storage> input: type_10;
@group(0) @binding(3) 
var<storage, read_write> output: type_30;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_25, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_130_: u32;
    var phi_161_: u32;
    var phi_162_: u32;
    var phi_170_: u32;
    var phi_186_: u32;
    var phi_207_: u32;
    var phi_208_: u32;
    var phi_211_: type_13;
    var phi_212_: type_13;
    var phi_235_: type_13;
    var phi_276_: u32;
    var phi_277_: u32;
    var phi_285_: u32;
    var phi_297_: u32;
    var phi_353_: array<u32, 2>;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_562_: type_25;
    var phi_571_: bool;
    var phi_578_: type_13;
    var phi_581_: u32;
    var phi_579_: type_13;
    var phi_604_: type_13;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_676_: bool;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_582_: u32;
    var phi_699_: type_13;
    var phi_702_: u32;
    var phi_700_: type_13;
    var phi_725_: type_13;
    var phi_776_: u32;
    var phi_777_: bool;
    var phi_703_: u32;
    var phi_778_: bool;
    var phi_785_: u32;
    var phi_818_: type_13;
    var phi_819_: type_13;
    var phi_842_: type_13;
    var phi_887_: bool;
    var phi_888_: bool;
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
            phi_161_ = (_e73 + 1u);
        } else {
            phi_161_ = _e73;
        }
        let _e79 = phi_161_;
        phi_162_ = _e79;
    } else {
        phi_162_ = 0u;
    }
    let _e81 = phi_162_;
    let _e84 = params.member.member_2.member_4;
    if (_e84 < _e81) {
        phi_170_ = _e84;
    } else {
        phi_170_ = _e81;
    }
    let _e87 = phi_170_;
    let _e88 = (_e87 / 4u);
    if ((_e87 % 4u) > 0u) {
        phi_186_ = (_e88 + 1u);
    } else {
        phi_186_ = _e88;
    }
    let _e93 = phi_186_;
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
            phi_207_ = (_e97 + 1u);
        } else {
            phi_207_ = _e97;
        }
        let _e103 = phi_207_;
        phi_208_ = _e103;
    } else {
        phi_208_ = 0u;
    }
    let _e105 = phi_208_;
    phi_211_ = type_13(0u, _e105);
    loop {
        let _e108 = phi_211_;
        if (_e108.member < _e108.member_1) {
            phi_212_ = type_13((_e108.member + 1u), _e108.member_1);
            phi_235_ = type_13(1u, _e108.member);
        } else {
            phi_212_ = _e108;
            phi_235_ = type_13(0u, type_13().member_1);
        }
        let _e120 = phi_212_;
        let _e122 = phi_235_;
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
                    phi_276_ = (_e143 + 1u);
                } else {
                    phi_276_ = _e143;
                }
                let _e149 = phi_276_;
                phi_277_ = _e149;
            } else {
                phi_277_ = 0u;
            }
            let _e151 = phi_277_;
            let _e154 = params.member.member_2.member_4;
            if (_e154 < _e151) {
                phi_285_ = _e154;
            } else {
                phi_285_ = _e151;
            }
            let _e157 = phi_285_;
            let _e158 = (_e130 < _e157);
            let _e161 = params.member.member_1.member_1;
            if _e158 {
                let _e164 = params.member.member_2.member_3;
                phi_297_ = (_e130 * _e164);
            } else {
                phi_297_ = 0u;
            }
            let _e167 = phi_297_;
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
                phi_353_ = array<u32, 2>(0u, 2u);
            } else {
                phi_353_ = array<u32, 2>(1u, 1u);
            }
            let _e192 = phi_353_;
            let _e195 = (_e39 / 32u);
            let _e196 = (_e39 % 32u);
            let _e200 = params.member.member_2.member_2;
            let _e204 = params.member.member_2.member[_e200][_e192[0]];
            let _e207 = nodes.member[(_e204 + _e172)];
            let _e223 = params.member.member_2.member_2;
            let _e227 = params.member.member_2.member[_e223][_e192[1]];
            let _e230 = nodes.member[(_e227 + _e175)];
            let _e246 = params.member.member_2.member_2;
            let _e253 = params.member.member_2.member[(_e246 - 1u)][_e192[0]];
            let _e256 = nodes.member[(_e253 + ((_e172 * 32u) + _e196))];
            let _e275 = params.member.member_2.member_2;
            let _e282 = params.member.member_2.member[(_e275 - 1u)][_e192[1]];
            let _e285 = nodes.member[(_e282 + ((_e175 * 32u) + _e196))];
            if _e158 {
                if ((((((_e285.member.x <= _e207.member_1.y) && (_e207.member.x <= _e285.member_1.y)) && (_e285.member.y <= _e207.member_2.x)) && (_e207.member.y <= _e285.member_2.x)) && (_e285.member_1.x <= _e207.member_2.y)) && (_e207.member_1.x <= _e285.member_2.y)) {
                    let _e311 = atomicAdd((&counters[_e195]), 1u);
                    let _e312 = ((_e195 * 32u) + _e311);
                    columns[_e312] = type_25(array<f32, 3>(_e285.member.x, _e285.member.y, _e285.member_1.x), array<f32, 3>(_e285.member_1.y, _e285.member_2.x, _e285.member_2.y));
                    names[_e312] = _e196;
                }
            }
            workgroupBarrier();
            if _e158 {
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
                phi_562_ = type_25(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_562_ = type_25(array<f32, 3>(_e256.member.x, _e256.member.y, _e256.member_1.x), array<f32, 3>(_e256.member_1.y, _e256.member_2.x, _e256.member_2.y));
            }
            let _e334 = phi_562_;
            let _e337 = params.member.member_2.member_1;
            if (_e337 == 1u) {
                phi_571_ = (_e172 == _e175);
            } else {
                phi_571_ = false;
            }
            let _e341 = phi_571_;
            let _e342 = (_e39 / 32u);
            let _e343 = (_e39 % 32u);
            let _e345 = atomicLoad((&counters[_e342]));
            phi_578_ = type_13(0u, _e345);
            phi_581_ = 0u;
            loop {
                let _e348 = phi_578_;
                let _e350 = phi_581_;
                local = _e350;
                if (_e348.member < _e348.member_1) {
                    phi_579_ = type_13((_e348.member + 1u), _e348.member_1);
                    phi_604_ = type_13(1u, _e348.member);
                } else {
                    phi_579_ = _e348;
                    phi_604_ = type_13(0u, type_13().member_1);
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
            phi_699_ = type_13(0u, 32u);
            let _e615 = local;
            phi_702_ = _e615;
            loop {
                let _e444 = phi_699_;
                let _e446 = phi_702_;
                if (_e444.member < _e444.member_1) {
                    phi_700_ = type_13((_e444.member + 1u), _e444.member_1);
                    phi_725_ = type_13(1u, _e444.member);
                } else {
                    phi_700_ = _e444;
                    phi_725_ = type_13(0u, type_13().member_1);
                }
                let _e458 = phi_700_;
                let _e460 = phi_725_;
                if (bitcast<i32>(_e460.member) != 0i) {
                    if (_e446 == 0u) {
                        phi_776_ = u32();
                        phi_777_ = false;
                    } else {
                        let _e471 = names[((_e60 * 32u) + select(firstTrailingBit(_e446), 32u, (_e446 == 0u)))];
                        let _e476 = params.member.member_1.member_3;
                        let _e483 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e483 + 1u) < _e483) {
                            let _e487 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e483 < _e476) {
                            let _e489 = (2u * _e483);
                            atomicStore((&output.member[(4u + _e489)]), ((_e172 * 32u) + (_e39 % 32u)));
                            atomicStore((&output.member[(_e489 + 5u)]), ((_e175 * 32u) + _e471));
                        }
                        phi_776_ = (_e446 & (_e446 - 1u));
                        phi_777_ = true;
                    }
                    let _e495 = phi_776_;
                    let _e497 = phi_777_;
                    phi_703_ = _e495;
                    phi_778_ = _e497;
                } else {
                    phi_703_ = u32();
                    phi_778_ = false;
                }
                let _e499 = phi_703_;
                let _e501 = phi_778_;
                continue;
                continuing {
                    phi_699_ = _e458;
                    phi_702_ = _e499;
                    break if !(_e501);
                }
            }
            workgroupBarrier();
            let _e504 = atomicLoad((&counters[4u]));
            if (2048u < _e504) {
                phi_785_ = 2048u;
            } else {
                phi_785_ = _e504;
            }
            let _e507 = phi_785_;
            if (_e39 == 0u) {
                atomicStore((&counters[5u]), _e507);
            }
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e512 = atomicLoad((&counters[5u]));
                if (_e512 > 0u) {
                    let _e515 = atomicAdd((&output.member[0u]), _e512);
                    if ((_e515 + _e512) < _e515) {
                        let _e519 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e515);
                }
            }
            workgroupBarrier();
            let _e522 = atomicLoad((&counters[6u]));
            phi_818_ = type_13(0u, 16u);
            loop {
                let _e524 = phi_818_;
                if (_e524.member < _e524.member_1) {
                    phi_819_ = type_13((_e524.member + 1u), _e524.member_1);
                    phi_842_ = type_13(1u, _e524.member);
                } else {
                    phi_819_ = _e524;
                    phi_842_ = type_13(0u, type_13().member_1);
                }
                let _e536 = phi_819_;
                let _e538 = phi_842_;
                if (bitcast<i32>(_e538.member) != 0i) {
                    let _e544 = (_e39 + (_e538.member_1 * 128u));
                    if (_e544 >= _e507) {
                        phi_887_ = false;
                    } else {
                        let _e547 = hits[_e544];
                        let _e550 = ((_e547 >> bitcast<u32>(10i)) & 3u);
                        let _e557 = firsts[(2u * _e550)];
                        let _e562 = firsts[((2u * _e550) + 1u)];
                        let _e566 = params.member.member_1.member_3;
                        let _e567 = (_e522 + _e544);
                        if (_e567 < _e566) {
                            let _e569 = (2u * _e567);
                            atomicStore((&output.member[(4u + _e569)]), (_e557 + ((_e547 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e569 + 5u)]), (_e562 + (_e547 & 31u)));
                        }
                        phi_887_ = true;
                    }
                    let _e575 = phi_887_;
                    phi_888_ = _e575;
                } else {
                    phi_888_ = false;
                }
                let _e577 = phi_888_;
                continue;
                continuing {
                    phi_818_ = _e536;
                    break if !(_e577);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_211_ = _e120;
            break if !(_e126);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
