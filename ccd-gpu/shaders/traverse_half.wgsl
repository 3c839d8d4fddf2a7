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
    member: array<u32, 47>,
    member_1: u32,
}

struct type_28 {
    member: type_27,
    member_1: u32,
    member_2: bool,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: bool,
}

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_32;
@group(0) @binding(1) 
var<storage> leaves: type_22;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var phi_227_: type_9;
    var phi_230_: type_29;
    var phi_267_: type_9;
    var phi_270_: type_29;
    var phi_308_: bool;
    var phi_398_: type_29;
    var phi_399_: u32;
    var phi_454_: type_29;
    var phi_271_: type_29;
    var phi_455_: bool;
    var phi_484_: type_9;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_830_: bool;
    var phi_831_: type_29;
    var phi_832_: bool;
    var phi_231_: type_29;
    var phi_833_: bool;
    var local_1: type_29;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e36 = ((((_e22.y * _e23.x) + _e22.x) * 128u) + _e24);
    let _e39 = params.member.member_1.member;
    if (_e36 < _e39) {
        let _e43 = params.member.member_1.member_1;
        let _e44 = (_e43 + _e36);
        let _e49 = params.member.member_2.member[0u][1u];
        let _e52 = leaves.member[(_e49 + _e44)];
        let _e68 = params.member.member.member_2[1u];
        let _e72 = params.member.member.member[1u];
        let _e75 = order.member[(_e68 + _e44)];
        let _e76 = (_e75 - _e68);
        local = type_28(type_27(array<u32, 47>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, true);
        phi_227_ = type_9(0u, (_e72 - 1u));
        phi_230_ = type_29(_e44, 0u, false);
        loop {
            let _e84 = phi_227_;
            let _e86 = phi_230_;
            let _e89 = (_e84.member < _e84.member_1);
            if (bitcast<i32>(select(0u, 1u, _e89)) != 0i) {
                if _e86.member_2 {
                    phi_831_ = type_29();
                    phi_832_ = false;
                } else {
                    phi_267_ = type_9(0u, (_e72 - 1u));
                    phi_270_ = _e86;
                    loop {
                        let _e105 = phi_267_;
                        let _e107 = phi_270_;
                        local_1 = _e107;
                        let _e110 = (_e105.member < _e105.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e110)) != 0i) {
                            if _e107.member_2 {
                                phi_308_ = false;
                            } else {
                                let _e125 = local.member.member_1;
                                phi_308_ = (_e125 < 16u);
                            }
                            let _e128 = phi_308_;
                            if _e128 {
                                let _e131 = nodes.member[_e107.member_1];
                                let _e150 = (_e131.member_2.w + 1u);
                                if (_e107.member > _e131.member_2.w) {
                                    let _e189 = type_29(_e107.member, _e150, _e107.member_2);
                                    phi_398_ = type_29(_e189.member, _e189.member_1, ((_e131.member_3.w & 2u) != 0u));
                                    phi_399_ = 4294967295u;
                                } else {
                                    let _e155 = type_29(_e107.member, _e131.member_2.w, _e107.member_2);
                                    let _e171 = ((((((bitcast<f32>(_e131.member_2.x) <= _e52.member_1.y) && (_e52.member.x <= bitcast<f32>(_e131.member_3.x))) && (bitcast<f32>(_e131.member_2.y) <= _e52.member_2.x)) && (_e52.member.y <= bitcast<f32>(_e131.member_3.y))) && (bitcast<f32>(_e131.member_2.z) <= _e52.member_2.y)) && (_e52.member_1.x <= bitcast<f32>(_e131.member_3.z)));
                                    let _e173 = ((_e131.member_3.w & 2u) != 0u);
                                    if _e171 {
                                        if _e173 {
                                        } else {
                                            let _e175 = function_(_e150);
                                            let _e177 = local.member.member_1;
                                            local.member.member[_e177] = _e175;
                                            let _e182 = local.member.member_1;
                                            local.member.member_1 = (_e182 + 1u);
                                        }
                                    }
                                    phi_398_ = type_29(_e155.member, _e155.member_1, ((_e131.member_3.w & 1u) != 0u));
                                    phi_399_ = select(_e150, 4294967295u, select(true, select(true, false, _e173), _e171));
                                }
                                let _e196 = phi_398_;
                                let _e198 = phi_399_;
                                if (_e198 != 4294967295u) {
                                    let _e203 = params.member.member.member_2[1u];
                                    let _e206 = order.member[(_e203 + _e198)];
                                    let _e207 = (_e206 - _e203);
                                    let _e210 = params.member.member_1.member_3;
                                    let _e211 = (_e76 < _e207);
                                    let _e215 = atomicAdd((&pairs.member[0u]), 1u);
                                    if ((_e215 + 1u) < _e215) {
                                        let _e219 = atomicAdd((&pairs.member[2u]), 1u);
                                    }
                                    if (_e215 < _e210) {
                                        let _e221 = (2u * _e215);
                                        atomicStore((&pairs.member[(4u + _e221)]), select(_e207, _e76, _e211));
                                        atomicStore((&pairs.member[(_e221 + 5u)]), select(_e76, _e207, _e211));
                                    }
                                }
                                phi_454_ = _e196;
                            } else {
                                phi_454_ = type_29();
                            }
                            let _e227 = phi_454_;
                            phi_271_ = _e227;
                            phi_455_ = _e128;
                        } else {
                            phi_271_ = type_29();
                            phi_455_ = false;
                        }
                        let _e229 = phi_271_;
                        let _e231 = phi_455_;
                        continue;
                        continuing {
                            phi_267_ = type_9(select(_e105.member, (_e105.member + 1u), _e110), select(_e105.member_1, _e105.member_1, _e110));
                            phi_270_ = _e229;
                            break if !(_e231);
                        }
                    }
                    let _e235 = local.member.member_1;
                    local.member_2 = (_e235 > 0u);
                    let _e239 = local.member_2;
                    if _e239 {
                        let _e243 = local.member.member_1;
                        local.member.member_1 = (_e243 - 1u);
                        let _e246 = local.member.member_1;
                        let _e249 = local.member.member[_e246];
                        local.member_1 = _e249;
                    }
                    phi_484_ = type_9(0u, (_e72 - 1u));
                    loop {
                        let _e254 = phi_484_;
                        let _e257 = (_e254.member < _e254.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e257)) != 0i) {
                            let _e270 = local.member_2;
                            if _e270 {
                                let _e272 = local.member_1;
                                let _e274 = nodes.member[_e272];
                                let _e317 = ((((((bitcast<f32>(_e274.member.x) <= _e52.member_1.y) && (_e52.member.x <= bitcast<f32>(_e274.member_1.x))) && (bitcast<f32>(_e274.member.y) <= _e52.member_2.x)) && (_e52.member.y <= bitcast<f32>(_e274.member_1.y))) && (bitcast<f32>(_e274.member.z) <= _e52.member_2.y)) && (_e52.member_1.x <= bitcast<f32>(_e274.member_1.z)));
                                let _e328 = ((((((bitcast<f32>(_e274.member_2.x) <= _e52.member_1.y) && (_e52.member.x <= bitcast<f32>(_e274.member_3.x))) && (bitcast<f32>(_e274.member_2.y) <= _e52.member_2.x)) && (_e52.member.y <= bitcast<f32>(_e274.member_3.y))) && (bitcast<f32>(_e274.member_2.z) <= _e52.member_2.y)) && (_e52.member_1.x <= bitcast<f32>(_e274.member_3.z)));
                                let _e330 = ((_e274.member_3.w & 1u) != 0u);
                                let _e332 = ((_e274.member_3.w & 2u) != 0u);
                                let _e333 = (_e274.member_2.w + 1u);
                                let _e336 = select(_e274.member_2.w, 4294967295u, select(true, select(true, false, _e330), _e317));
                                let _e339 = select(_e333, 4294967295u, select(true, select(true, false, _e332), _e328));
                                let _e341 = select(false, !(_e330), _e317);
                                let _e343 = select(false, !(_e332), _e328);
                                if _e341 {
                                    if _e343 {
                                        let _e345 = ((_e274.member_3.w & 4u) != 0u);
                                        let _e348 = function_(select(_e274.member_2.w, _e333, _e345));
                                        let _e350 = local.member.member_1;
                                        local.member.member[_e350] = _e348;
                                        let _e355 = local.member.member_1;
                                        local.member.member_1 = (_e355 + 1u);
                                        local.member_1 = select(_e333, _e274.member_2.w, _e345);
                                        phi_659_ = false;
                                    } else {
                                        phi_659_ = true;
                                    }
                                    let _e360 = phi_659_;
                                    phi_660_ = _e360;
                                } else {
                                    phi_660_ = true;
                                }
                                let _e362 = phi_660_;
                                if _e362 {
                                    if _e341 {
                                        local.member_1 = _e274.member_2.w;
                                    } else {
                                        if _e343 {
                                            local.member_1 = _e333;
                                        } else {
                                            let _e365 = local.member.member_1;
                                            local.member_2 = (_e365 > 0u);
                                            let _e369 = local.member_2;
                                            if _e369 {
                                                let _e373 = local.member.member_1;
                                                local.member.member_1 = (_e373 - 1u);
                                                let _e376 = local.member.member_1;
                                                let _e379 = local.member.member[_e376];
                                                local.member_1 = _e379;
                                            }
                                        }
                                    }
                                }
                                if (_e336 != 4294967295u) {
                                    let _e387 = params.member.member.member_2[1u];
                                    let _e390 = order.member[(_e387 + _e336)];
                                    let _e391 = (_e390 - _e387);
                                    let _e394 = params.member.member_1.member_3;
                                    let _e395 = (_e76 < _e391);
                                    let _e399 = atomicAdd((&pairs.member[0u]), 1u);
                                    if ((_e399 + 1u) < _e399) {
                                        let _e403 = atomicAdd((&pairs.member[2u]), 1u);
                                    }
                                    if (_e399 < _e394) {
                                        let _e405 = (2u * _e399);
                                        atomicStore((&pairs.member[(4u + _e405)]), select(_e391, _e76, _e395));
                                        atomicStore((&pairs.member[(_e405 + 5u)]), select(_e76, _e391, _e395));
                                    }
                                }
                                if (_e339 != 4294967295u) {
                                    let _e414 = params.member.member.member_2[1u];
                                    let _e417 = order.member[(_e414 + _e339)];
                                    let _e418 = (_e417 - _e414);
                                    let _e421 = params.member.member_1.member_3;
                                    let _e422 = (_e76 < _e418);
                                    let _e426 = atomicAdd((&pairs.member[0u]), 1u);
                                    if ((_e426 + 1u) < _e426) {
                                        let _e430 = atomicAdd((&pairs.member[2u]), 1u);
                                    }
                                    if (_e426 < _e421) {
                                        let _e432 = (2u * _e426);
                                        atomicStore((&pairs.member[(4u + _e432)]), select(_e418, _e76, _e422));
                                        atomicStore((&pairs.member[(_e432 + 5u)]), select(_e76, _e418, _e422));
                                    }
                                }
                            }
                            phi_830_ = _e270;
                        } else {
                            phi_830_ = false;
                        }
                        let _e438 = phi_830_;
                        continue;
                        continuing {
                            phi_484_ = type_9(select(_e254.member, (_e254.member + 1u), _e257), select(_e254.member_1, _e254.member_1, _e257));
                            break if !(_e438);
                        }
                    }
                    let _e465 = local_1;
                    phi_831_ = _e465;
                    phi_832_ = true;
                }
                let _e441 = phi_831_;
                let _e443 = phi_832_;
                phi_231_ = _e441;
                phi_833_ = _e443;
            } else {
                phi_231_ = type_29();
                phi_833_ = false;
            }
            let _e445 = phi_231_;
            let _e447 = phi_833_;
            continue;
            continuing {
                phi_227_ = type_9(select(_e84.member, (_e84.member + 1u), _e89), select(_e84.member_1, _e84.member_1, _e89));
                phi_230_ = _e445;
                break if !(_e447);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
