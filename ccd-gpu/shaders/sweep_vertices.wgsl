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
    member_18: array<array<u32, 4>, 8>,
}

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_24 {
    member: u32,
    member_1: u32,
}

struct type_28 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_31 {
    member: array<type_28>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_18;
@group(0) @binding(1) 
var<storage> paths: type_31;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_6;
    var local_4: type_6;
    var phi_140_: type_24;
    var phi_141_: type_24;
    var phi_164_: type_24;
    var phi_190_: f32;
    var phi_217_: f32;
    var phi_254_: type_24;
    var phi_255_: type_24;
    var phi_278_: type_24;
    var phi_305_: bool;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_351_: bool;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_414_: type_24;
    var phi_415_: type_24;
    var phi_438_: type_24;
    var phi_468_: bool;
    var phi_485_: f32;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_529_: bool;
    var phi_546_: f32;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_560_: f32;

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
        phi_140_ = type_24(0u, 3u);
        loop {
            let _e67 = phi_140_;
            if (_e67.member < _e67.member_1) {
                phi_141_ = type_24((_e67.member + 1u), _e67.member_1);
                phi_164_ = type_24(1u, _e67.member);
            } else {
                phi_141_ = _e67;
                phi_164_ = type_24(0u, type_24().member_1);
            }
            let _e81 = phi_141_;
            let _e83 = phi_164_;
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
                    phi_190_ = _e91;
                } else {
                    phi_190_ = _e95;
                }
                let _e98 = phi_190_;
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
                    phi_217_ = _e105;
                } else {
                    phi_217_ = _e109;
                }
                let _e112 = phi_217_;
                if (_e83.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member_1[_e83.member_1] = _e112;
            }
            continue;
            continuing {
                phi_140_ = _e81;
                break if !(_e87);
            }
        }
        let _e117 = local_2;
        if (_e51 > 0f) {
            local_1 = _e117;
            phi_254_ = type_24(0u, 3u);
            loop {
                let _e120 = phi_254_;
                if (_e120.member < _e120.member_1) {
                    phi_255_ = type_24((_e120.member + 1u), _e120.member_1);
                    phi_278_ = type_24(1u, _e120.member);
                } else {
                    phi_255_ = _e120;
                    phi_278_ = type_24(0u, type_24().member_1);
                }
                let _e134 = phi_255_;
                let _e136 = phi_278_;
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
                        phi_305_ = (_e146 < 0f);
                    } else {
                        phi_305_ = true;
                    }
                    let _e152 = phi_305_;
                    if _e152 {
                        if (_e146 > 0f) {
                            phi_323_ = bitcast<f32>((_e147 + 1u));
                        } else {
                            if (_e146 < 0f) {
                                phi_322_ = bitcast<f32>((_e147 - 1u));
                            } else {
                                phi_322_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e158 = phi_322_;
                            phi_323_ = _e158;
                        }
                        let _e162 = phi_323_;
                        phi_324_ = _e162;
                    } else {
                        phi_324_ = _e146;
                    }
                    let _e164 = phi_324_;
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
                        phi_351_ = (_e173 < 0f);
                    } else {
                        phi_351_ = true;
                    }
                    let _e179 = phi_351_;
                    if _e179 {
                        if (_e173 > 0f) {
                            phi_369_ = bitcast<f32>((_e174 + 1u));
                        } else {
                            if (_e173 < 0f) {
                                phi_368_ = bitcast<f32>((_e174 - 1u));
                            } else {
                                phi_368_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e185 = phi_368_;
                            phi_369_ = _e185;
                        }
                        let _e189 = phi_369_;
                        phi_370_ = _e189;
                    } else {
                        phi_370_ = _e173;
                    }
                    let _e191 = phi_370_;
                    if (_e136.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_1.member_1[_e136.member_1] = _e191;
                }
                continue;
                continuing {
                    phi_254_ = _e134;
                    break if !(_e140);
                }
            }
        } else {
            local_1 = _e117;
        }
        let _e196 = local_1;
        local_4 = _e196;
        local = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_414_ = type_24(0u, 3u);
        loop {
            let _e198 = phi_414_;
            if (_e198.member < _e198.member_1) {
                phi_415_ = type_24((_e198.member + 1u), _e198.member_1);
                phi_438_ = type_24(1u, _e198.member);
            } else {
                phi_415_ = _e198;
                phi_438_ = type_24(0u, type_24().member_1);
            }
            let _e212 = phi_415_;
            let _e214 = phi_438_;
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
                        phi_468_ = (_e224 < 0f);
                    } else {
                        phi_468_ = true;
                    }
                    let _e230 = phi_468_;
                    if _e230 {
                        if (_e224 > 0f) {
                            phi_486_ = bitcast<f32>((_e225 + 1u));
                        } else {
                            if (_e224 < 0f) {
                                phi_485_ = bitcast<f32>((_e225 - 1u));
                            } else {
                                phi_485_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e236 = phi_485_;
                            phi_486_ = _e236;
                        }
                        let _e240 = phi_486_;
                        phi_487_ = _e240;
                    } else {
                        phi_487_ = _e224;
                    }
                    let _e242 = phi_487_;
                    phi_489_ = -(_e242);
                } else {
                    phi_489_ = _e222;
                }
                let _e245 = phi_489_;
                let _e246 = -(290000000000000000000000000000000000000f);
                if (_e245 > _e246) {
                    phi_495_ = _e245;
                } else {
                    phi_495_ = _e246;
                }
                let _e249 = phi_495_;
                if (_e249 < 290000000000000000000000000000000000000f) {
                    phi_500_ = _e249;
                } else {
                    phi_500_ = 290000000000000000000000000000000000000f;
                }
                let _e252 = phi_500_;
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
                        phi_529_ = (_e259 < 0f);
                    } else {
                        phi_529_ = true;
                    }
                    let _e266 = phi_529_;
                    if _e266 {
                        if (_e259 > 0f) {
                            phi_547_ = bitcast<f32>((_e261 + 1u));
                        } else {
                            if (_e259 < 0f) {
                                phi_546_ = bitcast<f32>((_e261 - 1u));
                            } else {
                                phi_546_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e272 = phi_546_;
                            phi_547_ = _e272;
                        }
                        let _e276 = phi_547_;
                        phi_548_ = _e276;
                    } else {
                        phi_548_ = _e259;
                    }
                    let _e278 = phi_548_;
                    phi_549_ = _e278;
                } else {
                    phi_549_ = _e259;
                }
                let _e280 = phi_549_;
                let _e281 = -(290000000000000000000000000000000000000f);
                if (_e280 > _e281) {
                    phi_555_ = _e280;
                } else {
                    phi_555_ = _e281;
                }
                let _e284 = phi_555_;
                if (_e284 < 290000000000000000000000000000000000000f) {
                    phi_560_ = _e284;
                } else {
                    phi_560_ = 290000000000000000000000000000000000000f;
                }
                let _e287 = phi_560_;
                if (_e214.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e214.member_1] = _e287;
            }
            continue;
            continuing {
                phi_414_ = _e212;
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
