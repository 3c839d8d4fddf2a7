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
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
var<workgroup> firsts: array<u32, 8>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_151_: u32;
    var phi_188_: u32;
    var phi_189_: u32;
    var phi_197_: u32;
    var phi_213_: u32;
    var phi_236_: u32;
    var phi_237_: u32;
    var phi_240_: type_9;
    var phi_241_: type_9;
    var phi_264_: type_9;
    var phi_311_: u32;
    var phi_312_: u32;
    var phi_320_: u32;
    var phi_334_: u32;
    var phi_394_: array<u32, 2>;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_597_: type_24;
    var phi_606_: bool;
    var phi_615_: type_9;
    var phi_618_: u32;
    var phi_616_: type_9;
    var phi_641_: type_9;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_713_: bool;
    var phi_731_: u32;
    var phi_732_: u32;
    var phi_733_: u32;
    var phi_619_: u32;
    var phi_736_: type_9;
    var phi_739_: u32;
    var phi_737_: type_9;
    var phi_762_: type_9;
    var phi_812_: u32;
    var phi_813_: bool;
    var phi_740_: u32;
    var phi_814_: bool;
    var phi_821_: u32;
    var phi_855_: type_9;
    var phi_856_: type_9;
    var phi_879_: type_9;
    var phi_924_: bool;
    var phi_925_: bool;
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
        phi_151_ = _e54;
    } else {
        phi_151_ = _e56;
    }
    let _e59 = phi_151_;
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
            phi_188_ = (_e74 + 1u);
        } else {
            phi_188_ = _e74;
        }
        let _e80 = phi_188_;
        phi_189_ = _e80;
    } else {
        phi_189_ = 0u;
    }
    let _e82 = phi_189_;
    let _e85 = params.member.member_2.member_4;
    if (_e85 < _e82) {
        phi_197_ = _e85;
    } else {
        phi_197_ = _e82;
    }
    let _e88 = phi_197_;
    let _e89 = (_e88 / 4u);
    if ((_e88 % 4u) > 0u) {
        phi_213_ = (_e89 + 1u);
    } else {
        phi_213_ = _e89;
    }
    let _e94 = phi_213_;
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
            phi_236_ = (_e98 + 1u);
        } else {
            phi_236_ = _e98;
        }
        let _e104 = phi_236_;
        phi_237_ = _e104;
    } else {
        phi_237_ = 0u;
    }
    let _e106 = phi_237_;
    phi_240_ = type_9(0u, _e106);
    loop {
        let _e109 = phi_240_;
        if (_e109.member < _e109.member_1) {
            phi_241_ = type_9((_e109.member + 1u), _e109.member_1);
            phi_264_ = type_9(1u, _e109.member);
        } else {
            phi_241_ = _e109;
            phi_264_ = type_9(0u, type_9().member_1);
        }
        let _e121 = phi_241_;
        let _e123 = phi_264_;
        let _e127 = (bitcast<i32>(_e123.member) != 0i);
        if _e127 {
            let _e132 = (((_e48 + (_e123.member_1 * _e51)) * 4u) + (_e39 / 32u));
            let _e135 = params.member.member_1.member_1;
            if (_e59 > _e135) {
                let _e139 = params.member.member_1.member_1;
                let _e140 = (_e59 - _e139);
                let _e143 = params.member.member_2.member_3;
                if (_e143 == 0u) {
                    return;
                }
                let _e145 = (_e140 / _e143);
                if (_e143 == 0u) {
                    return;
                }
                if ((_e140 % _e143) > 0u) {
                    phi_311_ = (_e145 + 1u);
                } else {
                    phi_311_ = _e145;
                }
                let _e151 = phi_311_;
                phi_312_ = _e151;
            } else {
                phi_312_ = 0u;
            }
            let _e153 = phi_312_;
            let _e156 = params.member.member_2.member_4;
            if (_e156 < _e153) {
                phi_320_ = _e156;
            } else {
                phi_320_ = _e153;
            }
            let _e159 = phi_320_;
            let _e160 = (_e132 < _e159);
            let _e163 = params.member.member_1.member_1;
            let _e166 = params.member.member_2.member_3;
            if _e160 {
                phi_334_ = (_e132 * _e166);
            } else {
                phi_334_ = 0u;
            }
            let _e169 = phi_334_;
            let _e171 = (2u * (_e163 + _e169));
            let _e174 = input.member[(4u + _e171)];
            let _e177 = input.member[(_e171 + 5u)];
            if (_e39 < 8u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if (_e61 == 0u) {
                firsts[(2u * _e60)] = (_e174 * 32u);
                firsts[((2u * _e60) + 1u)] = (_e177 * 32u);
            }
            let _e190 = params.member.member_2.member_1;
            if (_e190 == 0u) {
                phi_394_ = array<u32, 2>(0u, 2u);
            } else {
                phi_394_ = array<u32, 2>(1u, 1u);
            }
            let _e193 = phi_394_;
            let _e196 = (_e39 / 32u);
            let _e197 = (_e39 % 32u);
            let _e199 = params.member.member_2.member_2;
            let _e203 = params.member.member_2.member[_e199][_e193[0]];
            let _e206 = nodes.member[(_e203 + _e174)];
            let _e220 = params.member.member_2.member_2;
            let _e224 = params.member.member_2.member[_e220][_e193[1]];
            let _e227 = nodes.member[(_e224 + _e177)];
            let _e241 = params.member.member_2.member_2;
            let _e248 = params.member.member_2.member[(_e241 - 1u)][_e193[0]];
            let _e251 = nodes.member[(_e248 + ((_e174 * 32u) + _e197))];
            let _e268 = params.member.member_2.member_2;
            let _e275 = params.member.member_2.member[(_e268 - 1u)][_e193[1]];
            let _e278 = nodes.member[(_e275 + ((_e177 * 32u) + _e197))];
            if _e160 {
                if ((((((_e278.member.x <= _e206.member_1.y) && (_e206.member.x <= _e278.member_1.y)) && (_e278.member.y <= _e206.member_2.x)) && (_e206.member.y <= _e278.member_2.x)) && (_e278.member_1.x <= _e206.member_2.y)) && (_e206.member_1.x <= _e278.member_2.y)) {
                    let _e304 = atomicAdd((&counters[_e196]), 1u);
                    let _e305 = ((_e196 * 32u) + _e304);
                    columns[_e305] = type_24(array<f32, 3>(_e278.member.x, _e278.member.y, _e278.member_1.x), array<f32, 3>(_e278.member_1.y, _e278.member_2.x, _e278.member_2.y));
                    names[_e305] = _e197;
                }
            }
            workgroupBarrier();
            if _e160 {
                if ((((((_e251.member.x <= _e227.member_1.y) && (_e227.member.x <= _e251.member_1.y)) && (_e251.member.y <= _e227.member_2.x)) && (_e227.member.y <= _e251.member_2.x)) && (_e251.member_1.x <= _e227.member_2.y)) && (_e227.member_1.x <= _e251.member_2.y)) {
                    phi_592_ = false;
                } else {
                    phi_592_ = true;
                }
                let _e323 = phi_592_;
                phi_593_ = _e323;
            } else {
                phi_593_ = true;
            }
            let _e325 = phi_593_;
            if _e325 {
                phi_597_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_597_ = type_24(array<f32, 3>(_e251.member.x, _e251.member.y, _e251.member_1.x), array<f32, 3>(_e251.member_1.y, _e251.member_2.x, _e251.member_2.y));
            }
            let _e327 = phi_597_;
            let _e330 = params.member.member_2.member_1;
            if (_e330 == 1u) {
                phi_606_ = (_e174 == _e177);
            } else {
                phi_606_ = false;
            }
            let _e334 = phi_606_;
            let _e335 = (_e39 / 32u);
            let _e336 = (_e39 % 32u);
            let _e338 = atomicLoad((&counters[_e335]));
            phi_615_ = type_9(0u, _e338);
            phi_618_ = 0u;
            loop {
                let _e341 = phi_615_;
                let _e343 = phi_618_;
                local = _e343;
                if (_e341.member < _e341.member_1) {
                    phi_616_ = type_9((_e341.member + 1u), _e341.member_1);
                    phi_641_ = type_9(1u, _e341.member);
                } else {
                    phi_616_ = _e341;
                    phi_641_ = type_9(0u, type_9().member_1);
                }
                let _e355 = phi_616_;
                let _e357 = phi_641_;
                let _e361 = (bitcast<i32>(_e357.member) != 0i);
                if _e361 {
                    let _e365 = names[((_e335 * 32u) + _e357.member_1)];
                    let _e369 = columns[((_e335 * 32u) + _e357.member_1)];
                    if ((((((_e327.member[0] <= _e369.member_1[0]) && (_e369.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e369.member_1[1])) && (_e369.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e369.member_1[2])) && (_e369.member[2] <= _e327.member_1[2])) {
                        if _e334 {
                            let _e401 = (_e336 < _e365);
                            if _e401 {
                                phi_707_ = bool();
                            } else {
                                if (_e336 == _e365) {
                                    phi_706_ = true;
                                } else {
                                    phi_706_ = false;
                                }
                                let _e404 = phi_706_;
                                phi_707_ = _e404;
                            }
                            let _e406 = phi_707_;
                            phi_708_ = _e406;
                            phi_709_ = _e401;
                        } else {
                            phi_708_ = bool();
                            phi_709_ = true;
                        }
                        let _e408 = phi_708_;
                        let _e410 = phi_709_;
                        if _e410 {
                            phi_713_ = true;
                        } else {
                            phi_713_ = _e408;
                        }
                        let _e412 = phi_713_;
                        if _e412 {
                            let _e414 = atomicAdd((&counters[4u]), 1u);
                            if (_e414 < 2048u) {
                                hits[_e414] = (((_e335 << bitcast<u32>(10i)) | (_e336 << bitcast<u32>(5i))) | _e365);
                                phi_731_ = _e343;
                            } else {
                                phi_731_ = (_e343 | (1u << bitcast<u32>((_e357.member_1 & 31u))));
                            }
                            let _e428 = phi_731_;
                            phi_732_ = _e428;
                        } else {
                            phi_732_ = _e343;
                        }
                        let _e430 = phi_732_;
                        phi_733_ = _e430;
                    } else {
                        phi_733_ = _e343;
                    }
                    let _e432 = phi_733_;
                    phi_619_ = _e432;
                } else {
                    phi_619_ = u32();
                }
                let _e434 = phi_619_;
                continue;
                continuing {
                    phi_615_ = _e355;
                    phi_618_ = _e434;
                    break if !(_e361);
                }
            }
            phi_736_ = type_9(0u, 32u);
            let _e607 = local;
            phi_739_ = _e607;
            loop {
                let _e437 = phi_736_;
                let _e439 = phi_739_;
                if (_e437.member < _e437.member_1) {
                    phi_737_ = type_9((_e437.member + 1u), _e437.member_1);
                    phi_762_ = type_9(1u, _e437.member);
                } else {
                    phi_737_ = _e437;
                    phi_762_ = type_9(0u, type_9().member_1);
                }
                let _e451 = phi_737_;
                let _e453 = phi_762_;
                if (bitcast<i32>(_e453.member) != 0i) {
                    if (_e439 == 0u) {
                        phi_812_ = u32();
                        phi_813_ = false;
                    } else {
                        let _e464 = names[((_e60 * 32u) + select(firstTrailingBit(_e439), 32u, (_e439 == 0u)))];
                        let _e473 = params.member.member_1.member_3;
                        let _e475 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e475 + 1u) < _e475) {
                            let _e479 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e475 < _e473) {
                            let _e481 = (2u * _e475);
                            atomicStore((&output.member[(4u + _e481)]), ((_e174 * 32u) + _e61));
                            atomicStore((&output.member[(_e481 + 5u)]), ((_e177 * 32u) + _e464));
                        }
                        phi_812_ = (_e439 & (_e439 - 1u));
                        phi_813_ = true;
                    }
                    let _e487 = phi_812_;
                    let _e489 = phi_813_;
                    phi_740_ = _e487;
                    phi_814_ = _e489;
                } else {
                    phi_740_ = u32();
                    phi_814_ = false;
                }
                let _e491 = phi_740_;
                let _e493 = phi_814_;
                continue;
                continuing {
                    phi_736_ = _e451;
                    phi_739_ = _e491;
                    break if !(_e493);
                }
            }
            workgroupBarrier();
            let _e496 = atomicLoad((&counters[4u]));
            if (2048u < _e496) {
                phi_821_ = 2048u;
            } else {
                phi_821_ = _e496;
            }
            let _e499 = phi_821_;
            if (_e39 == 0u) {
                atomicStore((&counters[5u]), _e499);
            }
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e504 = atomicLoad((&counters[5u]));
                if (_e504 > 0u) {
                    let _e507 = atomicAdd((&output.member[0u]), _e504);
                    if ((_e507 + _e504) < _e507) {
                        let _e511 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e507);
                }
            }
            workgroupBarrier();
            let _e514 = atomicLoad((&counters[6u]));
            phi_855_ = type_9(0u, 16u);
            loop {
                let _e516 = phi_855_;
                if (_e516.member < _e516.member_1) {
                    phi_856_ = type_9((_e516.member + 1u), _e516.member_1);
                    phi_879_ = type_9(1u, _e516.member);
                } else {
                    phi_856_ = _e516;
                    phi_879_ = type_9(0u, type_9().member_1);
                }
                let _e528 = phi_856_;
                let _e530 = phi_879_;
                if (bitcast<i32>(_e530.member) != 0i) {
                    let _e536 = (_e39 + (_e530.member_1 * 128u));
                    if (_e536 >= _e499) {
                        phi_924_ = false;
                    } else {
                        let _e539 = hits[_e536];
                        let _e542 = ((_e539 >> bitcast<u32>(10i)) & 3u);
                        let _e549 = firsts[(2u * _e542)];
                        let _e554 = firsts[((2u * _e542) + 1u)];
                        let _e558 = params.member.member_1.member_3;
                        let _e559 = (_e514 + _e536);
                        if (_e559 < _e558) {
                            let _e561 = (2u * _e559);
                            atomicStore((&output.member[(4u + _e561)]), (_e549 + ((_e539 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e561 + 5u)]), (_e554 + (_e539 & 31u)));
                        }
                        phi_924_ = true;
                    }
                    let _e567 = phi_924_;
                    phi_925_ = _e567;
                } else {
                    phi_925_ = false;
                }
                let _e569 = phi_925_;
                continue;
                continuing {
                    phi_855_ = _e528;
                    break if !(_e569);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_240_ = _e121;
            break if !(_e127);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
