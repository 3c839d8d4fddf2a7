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
    var phi_139_: type_24;
    var phi_140_: type_24;
    var phi_163_: type_24;
    var phi_189_: f32;
    var phi_216_: f32;
    var phi_253_: type_24;
    var phi_254_: type_24;
    var phi_277_: type_24;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_397_: type_24;
    var phi_398_: type_24;
    var phi_421_: type_24;
    var phi_460_: f32;
    var phi_461_: f32;
    var phi_462_: f32;
    var phi_464_: f32;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_513_: f32;
    var phi_514_: f32;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_522_: f32;
    var phi_527_: f32;

    let _e30 = id_1;
    let _e31 = n_1;
    let _e32 = lane_1;
    let _e42 = ((((_e30.y * _e31.x) + _e30.x) * 256u) + _e32);
    let _e45 = params.member.member[0u];
    if (_e42 < _e45) {
        let _e48 = paths.member[_e42];
        let _e50 = params.member.member_3;
        local_3 = type_6(array<f32, 3>(_e48.member_1[0], _e48.member_1[1], _e48.member_1[2]), array<f32, 3>(_e48.member_1[0], _e48.member_1[1], _e48.member_1[2]));
        local_2 = type_6(array<f32, 3>(_e48.member[0], _e48.member[1], _e48.member[2]), array<f32, 3>(_e48.member[0], _e48.member[1], _e48.member[2]));
        phi_139_ = type_24(0u, 3u);
        loop {
            let _e66 = phi_139_;
            if (_e66.member < _e66.member_1) {
                phi_140_ = type_24((_e66.member + 1u), _e66.member_1);
                phi_163_ = type_24(1u, _e66.member);
            } else {
                phi_140_ = _e66;
                phi_163_ = type_24(0u, type_24().member_1);
            }
            let _e80 = phi_140_;
            let _e82 = phi_163_;
            let _e86 = (bitcast<i32>(_e82.member) != 0i);
            if _e86 {
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e90 = local_2.member[_e82.member_1];
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e94 = local_3.member[_e82.member_1];
                if (_e90 < _e94) {
                    phi_189_ = _e90;
                } else {
                    phi_189_ = _e94;
                }
                let _e97 = phi_189_;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member[_e82.member_1] = _e97;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e104 = local_2.member_1[_e82.member_1];
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e108 = local_3.member_1[_e82.member_1];
                if (_e104 > _e108) {
                    phi_216_ = _e104;
                } else {
                    phi_216_ = _e108;
                }
                let _e111 = phi_216_;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member_1[_e82.member_1] = _e111;
            }
            continue;
            continuing {
                phi_139_ = _e80;
                break if !(_e86);
            }
        }
        let _e116 = local_2;
        if (_e50 > 0f) {
            local_1 = _e116;
            phi_253_ = type_24(0u, 3u);
            loop {
                let _e119 = phi_253_;
                if (_e119.member < _e119.member_1) {
                    phi_254_ = type_24((_e119.member + 1u), _e119.member_1);
                    phi_277_ = type_24(1u, _e119.member);
                } else {
                    phi_254_ = _e119;
                    phi_277_ = type_24(0u, type_24().member_1);
                }
                let _e133 = phi_254_;
                let _e135 = phi_277_;
                let _e139 = (bitcast<i32>(_e135.member) != 0i);
                if _e139 {
                    if (_e135.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e143 = local_1.member[_e135.member_1];
                    let _e145 = -((_e143 - _e50));
                    let _e146 = bitcast<u32>(_e145);
                    if ((_e146 & 2139095040u) == 2139095040u) {
                        phi_315_ = _e145;
                    } else {
                        if (_e145 > 0f) {
                            phi_314_ = bitcast<f32>((_e146 + 1u));
                        } else {
                            if (_e145 < 0f) {
                                phi_313_ = bitcast<f32>((_e146 - 1u));
                            } else {
                                phi_313_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e154 = phi_313_;
                            phi_314_ = _e154;
                        }
                        let _e158 = phi_314_;
                        phi_315_ = _e158;
                    }
                    let _e160 = phi_315_;
                    if (_e135.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_1.member[_e135.member_1] = -(_e160);
                    if (_e135.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e168 = local_1.member_1[_e135.member_1];
                    let _e169 = (_e168 + _e50);
                    let _e170 = bitcast<u32>(_e169);
                    if ((_e170 & 2139095040u) == 2139095040u) {
                        phi_353_ = _e169;
                    } else {
                        if (_e169 > 0f) {
                            phi_352_ = bitcast<f32>((_e170 + 1u));
                        } else {
                            if (_e169 < 0f) {
                                phi_351_ = bitcast<f32>((_e170 - 1u));
                            } else {
                                phi_351_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e178 = phi_351_;
                            phi_352_ = _e178;
                        }
                        let _e182 = phi_352_;
                        phi_353_ = _e182;
                    }
                    let _e184 = phi_353_;
                    if (_e135.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_1.member_1[_e135.member_1] = _e184;
                }
                continue;
                continuing {
                    phi_253_ = _e133;
                    break if !(_e139);
                }
            }
        } else {
            local_1 = _e116;
        }
        let _e189 = local_1;
        local_4 = _e189;
        local = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_397_ = type_24(0u, 3u);
        loop {
            let _e191 = phi_397_;
            if (_e191.member < _e191.member_1) {
                phi_398_ = type_24((_e191.member + 1u), _e191.member_1);
                phi_421_ = type_24(1u, _e191.member);
            } else {
                phi_398_ = _e191;
                phi_421_ = type_24(0u, type_24().member_1);
            }
            let _e205 = phi_398_;
            let _e207 = phi_421_;
            let _e211 = (bitcast<i32>(_e207.member) != 0i);
            if _e211 {
                if (_e207.member_1 < 3u) {
                } else {
                    return;
                }
                let _e215 = local_4.member[_e207.member_1];
                if (_e215 > _e215) {
                    let _e217 = -(_e215);
                    let _e218 = bitcast<u32>(_e217);
                    if ((_e218 & 2139095040u) == 2139095040u) {
                        phi_462_ = _e217;
                    } else {
                        if (_e217 > 0f) {
                            phi_461_ = bitcast<f32>((_e218 + 1u));
                        } else {
                            if (_e217 < 0f) {
                                phi_460_ = bitcast<f32>((_e218 - 1u));
                            } else {
                                phi_460_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e226 = phi_460_;
                            phi_461_ = _e226;
                        }
                        let _e230 = phi_461_;
                        phi_462_ = _e230;
                    }
                    let _e232 = phi_462_;
                    phi_464_ = -(_e232);
                } else {
                    phi_464_ = _e215;
                }
                let _e235 = phi_464_;
                let _e236 = -(290000000000000000000000000000000000000f);
                if (_e235 > _e236) {
                    phi_470_ = _e235;
                } else {
                    phi_470_ = _e236;
                }
                let _e239 = phi_470_;
                if (_e239 < 290000000000000000000000000000000000000f) {
                    phi_475_ = _e239;
                } else {
                    phi_475_ = 290000000000000000000000000000000000000f;
                }
                let _e242 = phi_475_;
                if (_e207.member_1 < 3u) {
                } else {
                    return;
                }
                local.member[_e207.member_1] = _e242;
                if (_e207.member_1 < 3u) {
                } else {
                    return;
                }
                let _e249 = local_4.member_1[_e207.member_1];
                if (_e249 < _e249) {
                    let _e251 = bitcast<u32>(_e249);
                    if ((_e251 & 2139095040u) == 2139095040u) {
                        phi_515_ = _e249;
                    } else {
                        if (_e249 > 0f) {
                            phi_514_ = bitcast<f32>((_e251 + 1u));
                        } else {
                            if (_e249 < 0f) {
                                phi_513_ = bitcast<f32>((_e251 - 1u));
                            } else {
                                phi_513_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e259 = phi_513_;
                            phi_514_ = _e259;
                        }
                        let _e263 = phi_514_;
                        phi_515_ = _e263;
                    }
                    let _e265 = phi_515_;
                    phi_516_ = _e265;
                } else {
                    phi_516_ = _e249;
                }
                let _e267 = phi_516_;
                let _e268 = -(290000000000000000000000000000000000000f);
                if (_e267 > _e268) {
                    phi_522_ = _e267;
                } else {
                    phi_522_ = _e268;
                }
                let _e271 = phi_522_;
                if (_e271 < 290000000000000000000000000000000000000f) {
                    phi_527_ = _e271;
                } else {
                    phi_527_ = 290000000000000000000000000000000000000f;
                }
                let _e274 = phi_527_;
                if (_e207.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e207.member_1] = _e274;
            }
            continue;
            continuing {
                phi_397_ = _e205;
                break if !(_e211);
            }
        }
        let _e279 = local;
        boxes.member[_e42] = type_6(array<f32, 3>(_e279.member[0], _e279.member[1], _e279.member[2]), array<f32, 3>(_e279.member_1[0], _e279.member_1[1], _e279.member_1[2]));
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
