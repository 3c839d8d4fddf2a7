struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_25 {
    member: u32,
    member_1: u32,
}

struct type_29 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_32 {
    member: array<type_29>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_19;
@group(0) @binding(1) 
var<storage> paths: type_32;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_6;
    var local_4: type_6;
    var phi_141_: type_25;
    var phi_142_: type_25;
    var phi_165_: type_25;
    var phi_191_: f32;
    var phi_218_: f32;
    var phi_255_: type_25;
    var phi_256_: type_25;
    var phi_279_: type_25;
    var phi_306_: bool;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_352_: bool;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_415_: type_25;
    var phi_416_: type_25;
    var phi_439_: type_25;
    var phi_469_: bool;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_530_: bool;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_561_: f32;

    let _e31 = id_1;
    let _e32 = n_1;
    let _e33 = lane_1;
    let _e43 = ((((_e31.y * _e32.x) + _e31.x) * 256u) + _e33);
    let _e46 = params.member.member[0u];
    if (_e43 < _e46) {
        let _e49 = paths.member[_e43];
        let _e51 = params.member.member_3;
        local_3 = type_6(array<f32, 3>(_e49.member_1[0], _e49.member_1[1], _e49.member_1[2]), array<f32, 3>(_e49.member_1[0], _e49.member_1[1], _e49.member_1[2]));
        local_2 = type_6(array<f32, 3>(_e49.member[0], _e49.member[1], _e49.member[2]), array<f32, 3>(_e49.member[0], _e49.member[1], _e49.member[2]));
        phi_141_ = type_25(0u, 3u);
        loop {
            let _e67 = phi_141_;
            if (_e67.member < _e67.member_1) {
                phi_142_ = type_25((_e67.member + 1u), _e67.member_1);
                phi_165_ = type_25(1u, _e67.member);
            } else {
                phi_142_ = _e67;
                phi_165_ = type_25(0u, type_25().member_1);
            }
            let _e81 = phi_142_;
            let _e83 = phi_165_;
            let _e87 = (bitcast<i32>(_e83.member) != 0i);
            if _e87 {
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                let _e91 = local_2.member[_e83.member_1];
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                let _e95 = local_3.member[_e83.member_1];
                if (_e91 < _e95) {
                    phi_191_ = _e91;
                } else {
                    phi_191_ = _e95;
                }
                let _e98 = phi_191_;
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member[_e83.member_1] = _e98;
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                let _e105 = local_2.member_1[_e83.member_1];
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                let _e109 = local_3.member_1[_e83.member_1];
                if (_e105 > _e109) {
                    phi_218_ = _e105;
                } else {
                    phi_218_ = _e109;
                }
                let _e112 = phi_218_;
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member_1[_e83.member_1] = _e112;
            }
            continue;
            continuing {
                phi_141_ = _e81;
                break if !(_e87);
            }
        }
        let _e117 = local_2;
        if (_e51 > 0f) {
            local_1 = _e117;
            phi_255_ = type_25(0u, 3u);
            loop {
                let _e120 = phi_255_;
                if (_e120.member < _e120.member_1) {
                    phi_256_ = type_25((_e120.member + 1u), _e120.member_1);
                    phi_279_ = type_25(1u, _e120.member);
                } else {
                    phi_256_ = _e120;
                    phi_279_ = type_25(0u, type_25().member_1);
                }
                let _e134 = phi_256_;
                let _e136 = phi_279_;
                let _e140 = (bitcast<i32>(_e136.member) != 0i);
                if _e140 {
                    if (_e136.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e144 = local_1.member[_e136.member_1];
                    let _e146 = -((_e144 - _e51));
                    let _e147 = bitcast<u32>(_e146);
                    if ((_e147 & 2139095040u) == 2139095040u) {
                        phi_306_ = (_e146 < 0f);
                    } else {
                        phi_306_ = true;
                    }
                    let _e152 = phi_306_;
                    if _e152 {
                        if (_e146 > 0f) {
                            phi_324_ = bitcast<f32>((_e147 + 1u));
                        } else {
                            if (_e146 < 0f) {
                                phi_323_ = bitcast<f32>((_e147 - 1u));
                            } else {
                                phi_323_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e158 = phi_323_;
                            phi_324_ = _e158;
                        }
                        let _e162 = phi_324_;
                        phi_325_ = _e162;
                    } else {
                        phi_325_ = _e146;
                    }
                    let _e164 = phi_325_;
                    if (_e136.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_1.member[_e136.member_1] = -(_e164);
                    if (_e136.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e172 = local_1.member_1[_e136.member_1];
                    let _e173 = (_e172 + _e51);
                    let _e174 = bitcast<u32>(_e173);
                    if ((_e174 & 2139095040u) == 2139095040u) {
                        phi_352_ = (_e173 < 0f);
                    } else {
                        phi_352_ = true;
                    }
                    let _e179 = phi_352_;
                    if _e179 {
                        if (_e173 > 0f) {
                            phi_370_ = bitcast<f32>((_e174 + 1u));
                        } else {
                            if (_e173 < 0f) {
                                phi_369_ = bitcast<f32>((_e174 - 1u));
                            } else {
                                phi_369_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e185 = phi_369_;
                            phi_370_ = _e185;
                        }
                        let _e189 = phi_370_;
                        phi_371_ = _e189;
                    } else {
                        phi_371_ = _e173;
                    }
                    let _e191 = phi_371_;
                    if (_e136.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_1.member_1[_e136.member_1] = _e191;
                }
                continue;
                continuing {
                    phi_255_ = _e134;
                    break if !(_e140);
                }
            }
        } else {
            local_1 = _e117;
        }
        let _e196 = local_1;
        local_4 = _e196;
        local = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_415_ = type_25(0u, 3u);
        loop {
            let _e198 = phi_415_;
            if (_e198.member < _e198.member_1) {
                phi_416_ = type_25((_e198.member + 1u), _e198.member_1);
                phi_439_ = type_25(1u, _e198.member);
            } else {
                phi_416_ = _e198;
                phi_439_ = type_25(0u, type_25().member_1);
            }
            let _e212 = phi_416_;
            let _e214 = phi_439_;
            let _e218 = (bitcast<i32>(_e214.member) != 0i);
            if _e218 {
                if (_e214.member_1 < 3u) {
                } else {
                    return;
                }
                let _e222 = local_4.member[_e214.member_1];
                if (_e222 > _e222) {
                    let _e224 = -(_e222);
                    let _e225 = bitcast<u32>(_e224);
                    if ((_e225 & 2139095040u) == 2139095040u) {
                        phi_469_ = (_e224 < 0f);
                    } else {
                        phi_469_ = true;
                    }
                    let _e230 = phi_469_;
                    if _e230 {
                        if (_e224 > 0f) {
                            phi_487_ = bitcast<f32>((_e225 + 1u));
                        } else {
                            if (_e224 < 0f) {
                                phi_486_ = bitcast<f32>((_e225 - 1u));
                            } else {
                                phi_486_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e236 = phi_486_;
                            phi_487_ = _e236;
                        }
                        let _e240 = phi_487_;
                        phi_488_ = _e240;
                    } else {
                        phi_488_ = _e224;
                    }
                    let _e242 = phi_488_;
                    phi_490_ = -(_e242);
                } else {
                    phi_490_ = _e222;
                }
                let _e245 = phi_490_;
                let _e246 = -(290000000000000000000000000000000000000f);
                if (_e245 > _e246) {
                    phi_496_ = _e245;
                } else {
                    phi_496_ = _e246;
                }
                let _e249 = phi_496_;
                if (_e249 < 290000000000000000000000000000000000000f) {
                    phi_501_ = _e249;
                } else {
                    phi_501_ = 290000000000000000000000000000000000000f;
                }
                let _e252 = phi_501_;
                if (_e214.member_1 < 3u) {
                } else {
                    return;
                }
                local.member[_e214.member_1] = _e252;
                if (_e214.member_1 < 3u) {
                } else {
                    return;
                }
                let _e259 = local_4.member_1[_e214.member_1];
                if (_e259 < _e259) {
                    let _e261 = bitcast<u32>(_e259);
                    if ((_e261 & 2139095040u) == 2139095040u) {
                        phi_530_ = (_e259 < 0f);
                    } else {
                        phi_530_ = true;
                    }
                    let _e266 = phi_530_;
                    if _e266 {
                        if (_e259 > 0f) {
                            phi_548_ = bitcast<f32>((_e261 + 1u));
                        } else {
                            if (_e259 < 0f) {
                                phi_547_ = bitcast<f32>((_e261 - 1u));
                            } else {
                                phi_547_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e272 = phi_547_;
                            phi_548_ = _e272;
                        }
                        let _e276 = phi_548_;
                        phi_549_ = _e276;
                    } else {
                        phi_549_ = _e259;
                    }
                    let _e278 = phi_549_;
                    phi_550_ = _e278;
                } else {
                    phi_550_ = _e259;
                }
                let _e280 = phi_550_;
                let _e281 = -(290000000000000000000000000000000000000f);
                if (_e280 > _e281) {
                    phi_556_ = _e280;
                } else {
                    phi_556_ = _e281;
                }
                let _e284 = phi_556_;
                if (_e284 < 290000000000000000000000000000000000000f) {
                    phi_561_ = _e284;
                } else {
                    phi_561_ = 290000000000000000000000000000000000000f;
                }
                let _e287 = phi_561_;
                if (_e214.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e214.member_1] = _e287;
            }
            continue;
            continuing {
                phi_415_ = _e212;
                break if !(_e218);
            }
        }
        let _e292 = local;
        boxes.member[_e43] = type_6(array<f32, 3>(_e292.member[0], _e292.member[1], _e292.member[2]), array<f32, 3>(_e292.member_1[0], _e292.member_1[1], _e292.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
