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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(1) 
var<storage> boxes: type_20;
@group(0) @binding(3) 
var<storage> nodes: type_23;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_28;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_25;
    var phi_112_: array<u32, 2>;
    var phi_144_: u32;
    var phi_171_: array<u32, 2>;
    var phi_202_: array<u32, 2>;
    var phi_265_: array<u32, 2>;
    var phi_298_: bool;
    var phi_368_: type_9;
    var phi_369_: type_9;
    var phi_392_: type_9;
    var phi_512_: u32;
    var phi_513_: bool;
    var phi_514_: u32;
    var phi_515_: bool;
    var phi_519_: u32;
    var phi_527_: u32;
    var phi_528_: bool;
    var phi_529_: u32;
    var phi_530_: bool;
    var phi_534_: u32;
    var phi_539_: bool;
    var phi_544_: bool;
    var phi_556_: u32;
    var phi_572_: u32;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_621_: array<u32, 2>;
    var phi_654_: bool;
    var phi_697_: array<u32, 2>;
    var phi_730_: bool;
    var phi_781_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    let _e40 = ((((_e26.y * _e27.x) + _e26.x) * 128u) + _e28);
    let _e43 = params.member.member_1.member;
    if (_e40 < _e43) {
        let _e47 = params.member.member_2.member;
        if (_e47 == 0u) {
            phi_112_ = array<u32, 2>(0u, 2u);
        } else {
            phi_112_ = array<u32, 2>(1u, 1u);
        }
        let _e50 = phi_112_;
        let _e55 = params.member.member.member_2[_e50[0]];
        let _e58 = params.member.member_1.member_1;
        let _e60 = ((_e55 + _e58) + _e40);
        let _e63 = params.member.member_2.member_1;
        if (_e63 == 0u) {
            phi_144_ = _e60;
        } else {
            let _e66 = order.member[_e60];
            phi_144_ = _e66;
        }
        let _e68 = phi_144_;
        let _e69 = (_e68 - _e55);
        let _e71 = boxes.member[_e68];
        let _e86 = params.member.member_2.member;
        if (_e86 == 0u) {
            phi_171_ = array<u32, 2>(0u, 2u);
        } else {
            phi_171_ = array<u32, 2>(1u, 1u);
        }
        let _e89 = phi_171_;
        let _e94 = params.member.member.member[_e89[1]];
        let _e95 = (_e94 - 1u);
        if (_e95 == 0u) {
            let _e99 = params.member.member_2.member;
            if (_e99 == 0u) {
                phi_202_ = array<u32, 2>(0u, 2u);
            } else {
                phi_202_ = array<u32, 2>(1u, 1u);
            }
            let _e102 = phi_202_;
            let _e107 = params.member.member.member_2[_e102[1]];
            let _e109 = order.member[_e107];
            let _e111 = boxes.member[_e109];
            if ((((((_e111.member.x <= _e71.member_1.y) && (_e71.member.x <= _e111.member_1.y)) && (_e111.member.y <= _e71.member_2.x)) && (_e71.member.y <= _e111.member_2.x)) && (_e111.member_1.x <= _e71.member_2.y)) && (_e71.member_1.x <= _e111.member_2.y)) {
                let _e137 = params.member.member_2.member;
                if (_e137 == 0u) {
                    phi_265_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_265_ = array<u32, 2>(1u, 1u);
                }
                let _e140 = phi_265_;
                let _e145 = params.member.member.member_2[_e140[1]];
                let _e147 = order.member[_e145];
                let _e148 = (_e147 - _e145);
                let _e151 = params.member.member_2.member;
                if (_e151 == 0u) {
                    phi_298_ = true;
                } else {
                    phi_298_ = (_e148 > _e69);
                }
                let _e155 = phi_298_;
                if _e155 {
                    let _e158 = params.member.member_1.member_3;
                    let _e160 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e160 + 1u) < _e160) {
                        let _e164 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e160 < _e158) {
                        let _e166 = (2u * _e160);
                        atomicStore((&pairs.member[(4u + _e166)]), _e69);
                        atomicStore((&pairs.member[(_e166 + 5u)]), _e148);
                    }
                }
            }
        }
        local = type_25(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_368_ = type_9(0u, _e95);
        loop {
            let _e173 = phi_368_;
            if (_e173.member < _e173.member_1) {
                phi_369_ = type_9((_e173.member + 1u), _e173.member_1);
                phi_392_ = type_9(1u, _e173.member);
            } else {
                phi_369_ = _e173;
                phi_392_ = type_9(0u, type_9().member_1);
            }
            let _e185 = phi_369_;
            let _e187 = phi_392_;
            if (bitcast<i32>(_e187.member) != 0i) {
                let _e192 = local.member_3;
                if _e192 {
                    let _e194 = local.member_2;
                    let _e196 = nodes.member[_e194];
                    let _e241 = ((((((bitcast<f32>(_e196.member.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e196.member_1.x))) && (bitcast<f32>(_e196.member.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e196.member_1.y))) && (bitcast<f32>(_e196.member.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e196.member_1.z)));
                    let _e252 = ((((((bitcast<f32>(_e196.member_2.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e196.member_3.x))) && (bitcast<f32>(_e196.member_2.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e196.member_3.y))) && (bitcast<f32>(_e196.member_2.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e196.member_3.z)));
                    let _e254 = ((_e196.member.w & 2147483648u) != 0u);
                    let _e256 = ((_e196.member_1.w & 2147483648u) != 0u);
                    if _e241 {
                        if _e254 {
                            phi_512_ = (_e196.member.w & 2147483647u);
                            phi_513_ = false;
                        } else {
                            phi_512_ = u32();
                            phi_513_ = true;
                        }
                        let _e259 = phi_512_;
                        let _e261 = phi_513_;
                        phi_514_ = _e259;
                        phi_515_ = _e261;
                    } else {
                        phi_514_ = u32();
                        phi_515_ = true;
                    }
                    let _e263 = phi_514_;
                    let _e265 = phi_515_;
                    if _e265 {
                        phi_519_ = 4294967295u;
                    } else {
                        phi_519_ = _e263;
                    }
                    let _e267 = phi_519_;
                    if _e252 {
                        if _e256 {
                            phi_527_ = (_e196.member_1.w & 2147483647u);
                            phi_528_ = false;
                        } else {
                            phi_527_ = u32();
                            phi_528_ = true;
                        }
                        let _e270 = phi_527_;
                        let _e272 = phi_528_;
                        phi_529_ = _e270;
                        phi_530_ = _e272;
                    } else {
                        phi_529_ = u32();
                        phi_530_ = true;
                    }
                    let _e274 = phi_529_;
                    let _e276 = phi_530_;
                    if _e276 {
                        phi_534_ = 4294967295u;
                    } else {
                        phi_534_ = _e274;
                    }
                    let _e278 = phi_534_;
                    if _e241 {
                        phi_539_ = !(_e254);
                    } else {
                        phi_539_ = false;
                    }
                    let _e281 = phi_539_;
                    if _e252 {
                        phi_544_ = !(_e256);
                    } else {
                        phi_544_ = false;
                    }
                    let _e284 = phi_544_;
                    if _e281 {
                        if _e284 {
                            let _e286 = ((_e196.member_3.w & 2147483648u) != 0u);
                            if _e286 {
                                phi_556_ = _e196.member_1.w;
                            } else {
                                phi_556_ = _e196.member.w;
                            }
                            let _e288 = phi_556_;
                            let _e290 = local.member_1;
                            local.member[_e290] = _e288;
                            let _e295 = local.member_1;
                            local.member_1 = (_e295 + 1u);
                            if _e286 {
                                phi_572_ = _e196.member.w;
                            } else {
                                phi_572_ = _e196.member_1.w;
                            }
                            let _e298 = phi_572_;
                            local.member_2 = _e298;
                            phi_574_ = false;
                        } else {
                            phi_574_ = true;
                        }
                        let _e301 = phi_574_;
                        phi_575_ = _e301;
                    } else {
                        phi_575_ = true;
                    }
                    let _e303 = phi_575_;
                    if _e303 {
                        if _e281 {
                            local.member_2 = _e196.member.w;
                        } else {
                            if _e284 {
                                local.member_2 = _e196.member_1.w;
                            } else {
                                let _e305 = local.member_1;
                                if (_e305 > 0u) {
                                    let _e310 = local.member_1;
                                    local.member_1 = (_e310 - 1u);
                                    let _e313 = local.member_1;
                                    let _e316 = local.member[_e313];
                                    local.member_2 = _e316;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e267 != 4294967295u) {
                        let _e323 = params.member.member_2.member;
                        if (_e323 == 0u) {
                            phi_621_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_621_ = array<u32, 2>(1u, 1u);
                        }
                        let _e326 = phi_621_;
                        let _e331 = params.member.member.member_2[_e326[1]];
                        let _e334 = order.member[(_e331 + _e267)];
                        let _e335 = (_e334 - _e331);
                        let _e338 = params.member.member_2.member;
                        if (_e338 == 0u) {
                            phi_654_ = true;
                        } else {
                            phi_654_ = (_e335 > _e69);
                        }
                        let _e342 = phi_654_;
                        if _e342 {
                            let _e345 = params.member.member_1.member_3;
                            let _e347 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e347 + 1u) < _e347) {
                                let _e351 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e347 < _e345) {
                                let _e353 = (2u * _e347);
                                atomicStore((&pairs.member[(4u + _e353)]), _e69);
                                atomicStore((&pairs.member[(_e353 + 5u)]), _e335);
                            }
                        }
                    }
                    if (_e278 != 4294967295u) {
                        let _e361 = params.member.member_2.member;
                        if (_e361 == 0u) {
                            phi_697_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_697_ = array<u32, 2>(1u, 1u);
                        }
                        let _e364 = phi_697_;
                        let _e369 = params.member.member.member_2[_e364[1]];
                        let _e372 = order.member[(_e369 + _e278)];
                        let _e373 = (_e372 - _e369);
                        let _e376 = params.member.member_2.member;
                        if (_e376 == 0u) {
                            phi_730_ = true;
                        } else {
                            phi_730_ = (_e373 > _e69);
                        }
                        let _e380 = phi_730_;
                        if _e380 {
                            let _e383 = params.member.member_1.member_3;
                            let _e385 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e385 + 1u) < _e385) {
                                let _e389 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e385 < _e383) {
                                let _e391 = (2u * _e385);
                                atomicStore((&pairs.member[(4u + _e391)]), _e69);
                                atomicStore((&pairs.member[(_e391 + 5u)]), _e373);
                            }
                        }
                    }
                }
                phi_781_ = _e192;
            } else {
                phi_781_ = false;
            }
            let _e397 = phi_781_;
            continue;
            continuing {
                phi_368_ = _e185;
                break if !(_e397);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
