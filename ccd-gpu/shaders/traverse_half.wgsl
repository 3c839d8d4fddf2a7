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

struct type_15 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_30;
@group(0) @binding(1) 
var<storage> leaves: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var phi_199_: type_9;
    var phi_200_: type_9;
    var phi_223_: type_9;
    var phi_293_: bool;
    var phi_308_: bool;
    var phi_316_: bool;
    var phi_331_: bool;
    var phi_343_: u32;
    var phi_344_: bool;
    var phi_345_: u32;
    var phi_346_: bool;
    var phi_350_: u32;
    var phi_358_: u32;
    var phi_359_: bool;
    var phi_360_: u32;
    var phi_361_: bool;
    var phi_365_: u32;
    var phi_370_: bool;
    var phi_375_: bool;
    var phi_387_: u32;
    var phi_403_: u32;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_467_: type_9;
    var phi_521_: type_9;
    var phi_568_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e38 = ((((_e24.y * _e25.x) + _e24.x) * 128u) + _e26);
    let _e41 = params.member.member_1.member;
    if (_e38 < _e41) {
        let _e45 = params.member.member_1.member_1;
        let _e46 = (_e45 + _e38);
        let _e51 = params.member.member_2.member[0u][1u];
        let _e54 = leaves.member[(_e51 + _e46)];
        let _e70 = params.member.member.member_2[1u];
        let _e74 = params.member.member.member[1u];
        let _e77 = order.member[(_e70 + _e46)];
        let _e78 = (_e77 - _e70);
        local = type_27(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_199_ = type_9(0u, (_e74 - 1u));
        loop {
            let _e82 = phi_199_;
            if (_e82.member < _e82.member_1) {
                phi_200_ = type_9((_e82.member + 1u), _e82.member_1);
                phi_223_ = type_9(1u, _e82.member);
            } else {
                phi_200_ = _e82;
                phi_223_ = type_9(0u, type_9().member_1);
            }
            let _e94 = phi_200_;
            let _e96 = phi_223_;
            if (bitcast<i32>(_e96.member) != 0i) {
                let _e101 = local.member_3;
                if _e101 {
                    let _e103 = local.member_2;
                    let _e105 = nodes.member[_e103];
                    let _e142 = (_e46 == 4294967295u);
                    if _e142 {
                        phi_293_ = true;
                    } else {
                        phi_293_ = (_e105.member_2.w > _e46);
                    }
                    let _e146 = phi_293_;
                    if _e146 {
                        phi_308_ = ((((((bitcast<f32>(_e105.member.x) <= _e54.member_1.y) && (_e54.member.x <= bitcast<f32>(_e105.member_1.x))) && (bitcast<f32>(_e105.member.y) <= _e54.member_2.x)) && (_e54.member.y <= bitcast<f32>(_e105.member_1.y))) && (bitcast<f32>(_e105.member.z) <= _e54.member_2.y)) && (_e54.member_1.x <= bitcast<f32>(_e105.member_1.z)));
                    } else {
                        phi_308_ = false;
                    }
                    let _e159 = phi_308_;
                    if _e142 {
                        phi_316_ = true;
                    } else {
                        phi_316_ = ((_e105.member_3.w & 2147483647u) > _e46);
                    }
                    let _e162 = phi_316_;
                    if _e162 {
                        phi_331_ = ((((((bitcast<f32>(_e105.member_2.x) <= _e54.member_1.y) && (_e54.member.x <= bitcast<f32>(_e105.member_3.x))) && (bitcast<f32>(_e105.member_2.y) <= _e54.member_2.x)) && (_e54.member.y <= bitcast<f32>(_e105.member_3.y))) && (bitcast<f32>(_e105.member_2.z) <= _e54.member_2.y)) && (_e54.member_1.x <= bitcast<f32>(_e105.member_3.z)));
                    } else {
                        phi_331_ = false;
                    }
                    let _e175 = phi_331_;
                    let _e177 = ((_e105.member.w & 2147483648u) != 0u);
                    let _e179 = ((_e105.member_1.w & 2147483648u) != 0u);
                    if _e159 {
                        if _e177 {
                            phi_343_ = (_e105.member.w & 2147483647u);
                            phi_344_ = false;
                        } else {
                            phi_343_ = u32();
                            phi_344_ = true;
                        }
                        let _e182 = phi_343_;
                        let _e184 = phi_344_;
                        phi_345_ = _e182;
                        phi_346_ = _e184;
                    } else {
                        phi_345_ = u32();
                        phi_346_ = true;
                    }
                    let _e186 = phi_345_;
                    let _e188 = phi_346_;
                    if _e188 {
                        phi_350_ = 4294967295u;
                    } else {
                        phi_350_ = _e186;
                    }
                    let _e190 = phi_350_;
                    if _e175 {
                        if _e179 {
                            phi_358_ = (_e105.member_1.w & 2147483647u);
                            phi_359_ = false;
                        } else {
                            phi_358_ = u32();
                            phi_359_ = true;
                        }
                        let _e193 = phi_358_;
                        let _e195 = phi_359_;
                        phi_360_ = _e193;
                        phi_361_ = _e195;
                    } else {
                        phi_360_ = u32();
                        phi_361_ = true;
                    }
                    let _e197 = phi_360_;
                    let _e199 = phi_361_;
                    if _e199 {
                        phi_365_ = 4294967295u;
                    } else {
                        phi_365_ = _e197;
                    }
                    let _e201 = phi_365_;
                    if _e159 {
                        phi_370_ = !(_e177);
                    } else {
                        phi_370_ = false;
                    }
                    let _e204 = phi_370_;
                    if _e175 {
                        phi_375_ = !(_e179);
                    } else {
                        phi_375_ = false;
                    }
                    let _e207 = phi_375_;
                    if _e204 {
                        if _e207 {
                            let _e209 = ((_e105.member_3.w & 2147483648u) != 0u);
                            if _e209 {
                                phi_387_ = _e105.member_1.w;
                            } else {
                                phi_387_ = _e105.member.w;
                            }
                            let _e211 = phi_387_;
                            let _e213 = local.member_1;
                            local.member[_e213] = _e211;
                            let _e218 = local.member_1;
                            local.member_1 = (_e218 + 1u);
                            if _e209 {
                                phi_403_ = _e105.member.w;
                            } else {
                                phi_403_ = _e105.member_1.w;
                            }
                            let _e221 = phi_403_;
                            local.member_2 = _e221;
                            phi_405_ = false;
                        } else {
                            phi_405_ = true;
                        }
                        let _e224 = phi_405_;
                        phi_406_ = _e224;
                    } else {
                        phi_406_ = true;
                    }
                    let _e226 = phi_406_;
                    if _e226 {
                        if _e204 {
                            local.member_2 = _e105.member.w;
                        } else {
                            if _e207 {
                                local.member_2 = _e105.member_1.w;
                            } else {
                                let _e228 = local.member_1;
                                if (_e228 > 0u) {
                                    let _e233 = local.member_1;
                                    local.member_1 = (_e233 - 1u);
                                    let _e236 = local.member_1;
                                    let _e239 = local.member[_e236];
                                    local.member_2 = _e239;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e190 != 4294967295u) {
                        let _e247 = params.member.member.member_2[1u];
                        let _e250 = order.member[(_e247 + _e190)];
                        let _e251 = (_e250 - _e247);
                        let _e254 = params.member.member_1.member_3;
                        if (_e78 < _e251) {
                            phi_467_ = type_9(_e78, _e251);
                        } else {
                            phi_467_ = type_9(_e251, _e78);
                        }
                        let _e259 = phi_467_;
                        let _e263 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e263 + 1u) < _e263) {
                            let _e267 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e263 < _e254) {
                            let _e269 = (2u * _e263);
                            atomicStore((&pairs.member[(4u + _e269)]), _e259.member);
                            atomicStore((&pairs.member[(_e269 + 5u)]), _e259.member_1);
                        }
                    }
                    if (_e201 != 4294967295u) {
                        let _e278 = params.member.member.member_2[1u];
                        let _e281 = order.member[(_e278 + _e201)];
                        let _e282 = (_e281 - _e278);
                        let _e285 = params.member.member_1.member_3;
                        if (_e78 < _e282) {
                            phi_521_ = type_9(_e78, _e282);
                        } else {
                            phi_521_ = type_9(_e282, _e78);
                        }
                        let _e290 = phi_521_;
                        let _e294 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e294 + 1u) < _e294) {
                            let _e298 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e294 < _e285) {
                            let _e300 = (2u * _e294);
                            atomicStore((&pairs.member[(4u + _e300)]), _e290.member);
                            atomicStore((&pairs.member[(_e300 + 5u)]), _e290.member_1);
                        }
                    }
                }
                phi_568_ = _e101;
            } else {
                phi_568_ = false;
            }
            let _e306 = phi_568_;
            continue;
            continuing {
                phi_199_ = _e94;
                break if !(_e306);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
