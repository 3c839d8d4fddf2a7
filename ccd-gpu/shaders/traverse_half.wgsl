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
@group(0) @binding(1) 
var<storage> leaves: type_22;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_30;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var phi_197_: type_9;
    var phi_198_: type_9;
    var phi_221_: type_9;
    var phi_286_: bool;
    var phi_301_: bool;
    var phi_309_: bool;
    var phi_324_: bool;
    var phi_336_: u32;
    var phi_337_: bool;
    var phi_338_: u32;
    var phi_339_: bool;
    var phi_343_: u32;
    var phi_351_: u32;
    var phi_352_: bool;
    var phi_353_: u32;
    var phi_354_: bool;
    var phi_358_: u32;
    var phi_363_: bool;
    var phi_368_: bool;
    var phi_380_: u32;
    var phi_396_: u32;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_455_: type_9;
    var phi_509_: type_9;
    var phi_540_: bool;
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
        let _e70 = params.member.member.member[1u];
        let _e73 = params.member.member_1.member_3;
        let _e75 = order.member[_e46];
        local = type_27(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_197_ = type_9(0u, (_e70 - 1u));
        loop {
            let _e79 = phi_197_;
            if (_e79.member < _e79.member_1) {
                phi_198_ = type_9((_e79.member + 1u), _e79.member_1);
                phi_221_ = type_9(1u, _e79.member);
            } else {
                phi_198_ = _e79;
                phi_221_ = type_9(0u, type_9().member_1);
            }
            let _e91 = phi_198_;
            let _e93 = phi_221_;
            if (bitcast<i32>(_e93.member) != 0i) {
                let _e98 = local.member_3;
                if _e98 {
                    let _e100 = local.member_2;
                    let _e102 = nodes.member[_e100];
                    let _e139 = (_e46 == 4294967295u);
                    if _e139 {
                        phi_286_ = true;
                    } else {
                        phi_286_ = (_e102.member_2.w > _e46);
                    }
                    let _e143 = phi_286_;
                    if _e143 {
                        phi_301_ = ((((((bitcast<f32>(_e102.member.x) <= _e54.member_1.y) && (_e54.member.x <= bitcast<f32>(_e102.member_1.x))) && (bitcast<f32>(_e102.member.y) <= _e54.member_2.x)) && (_e54.member.y <= bitcast<f32>(_e102.member_1.y))) && (bitcast<f32>(_e102.member.z) <= _e54.member_2.y)) && (_e54.member_1.x <= bitcast<f32>(_e102.member_1.z)));
                    } else {
                        phi_301_ = false;
                    }
                    let _e156 = phi_301_;
                    if _e139 {
                        phi_309_ = true;
                    } else {
                        phi_309_ = ((_e102.member_3.w & 2147483647u) > _e46);
                    }
                    let _e159 = phi_309_;
                    if _e159 {
                        phi_324_ = ((((((bitcast<f32>(_e102.member_2.x) <= _e54.member_1.y) && (_e54.member.x <= bitcast<f32>(_e102.member_3.x))) && (bitcast<f32>(_e102.member_2.y) <= _e54.member_2.x)) && (_e54.member.y <= bitcast<f32>(_e102.member_3.y))) && (bitcast<f32>(_e102.member_2.z) <= _e54.member_2.y)) && (_e54.member_1.x <= bitcast<f32>(_e102.member_3.z)));
                    } else {
                        phi_324_ = false;
                    }
                    let _e172 = phi_324_;
                    let _e174 = ((_e102.member.w & 2147483648u) != 0u);
                    let _e176 = ((_e102.member_1.w & 2147483648u) != 0u);
                    if _e156 {
                        if _e174 {
                            phi_336_ = (_e102.member.w & 2147483647u);
                            phi_337_ = false;
                        } else {
                            phi_336_ = u32();
                            phi_337_ = true;
                        }
                        let _e179 = phi_336_;
                        let _e181 = phi_337_;
                        phi_338_ = _e179;
                        phi_339_ = _e181;
                    } else {
                        phi_338_ = u32();
                        phi_339_ = true;
                    }
                    let _e183 = phi_338_;
                    let _e185 = phi_339_;
                    if _e185 {
                        phi_343_ = 4294967295u;
                    } else {
                        phi_343_ = _e183;
                    }
                    let _e187 = phi_343_;
                    if _e172 {
                        if _e176 {
                            phi_351_ = (_e102.member_1.w & 2147483647u);
                            phi_352_ = false;
                        } else {
                            phi_351_ = u32();
                            phi_352_ = true;
                        }
                        let _e190 = phi_351_;
                        let _e192 = phi_352_;
                        phi_353_ = _e190;
                        phi_354_ = _e192;
                    } else {
                        phi_353_ = u32();
                        phi_354_ = true;
                    }
                    let _e194 = phi_353_;
                    let _e196 = phi_354_;
                    if _e196 {
                        phi_358_ = 4294967295u;
                    } else {
                        phi_358_ = _e194;
                    }
                    let _e198 = phi_358_;
                    if _e156 {
                        phi_363_ = !(_e174);
                    } else {
                        phi_363_ = false;
                    }
                    let _e201 = phi_363_;
                    if _e172 {
                        phi_368_ = !(_e176);
                    } else {
                        phi_368_ = false;
                    }
                    let _e204 = phi_368_;
                    if _e201 {
                        if _e204 {
                            let _e206 = ((_e102.member_3.w & 2147483648u) != 0u);
                            if _e206 {
                                phi_380_ = _e102.member_1.w;
                            } else {
                                phi_380_ = _e102.member.w;
                            }
                            let _e208 = phi_380_;
                            let _e210 = local.member_1;
                            local.member[_e210] = _e208;
                            let _e215 = local.member_1;
                            local.member_1 = (_e215 + 1u);
                            if _e206 {
                                phi_396_ = _e102.member.w;
                            } else {
                                phi_396_ = _e102.member_1.w;
                            }
                            let _e218 = phi_396_;
                            local.member_2 = _e218;
                            phi_398_ = false;
                        } else {
                            phi_398_ = true;
                        }
                        let _e221 = phi_398_;
                        phi_399_ = _e221;
                    } else {
                        phi_399_ = true;
                    }
                    let _e223 = phi_399_;
                    if _e223 {
                        if _e201 {
                            local.member_2 = _e102.member.w;
                        } else {
                            if _e204 {
                                local.member_2 = _e102.member_1.w;
                            } else {
                                let _e225 = local.member_1;
                                if (_e225 > 0u) {
                                    let _e230 = local.member_1;
                                    local.member_1 = (_e230 - 1u);
                                    let _e233 = local.member_1;
                                    let _e236 = local.member[_e233];
                                    local.member_2 = _e236;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e187 != 4294967295u) {
                        let _e242 = order.member[_e187];
                        if (_e75 < _e242) {
                            phi_455_ = type_9(_e75, _e242);
                        } else {
                            phi_455_ = type_9(_e242, _e75);
                        }
                        let _e247 = phi_455_;
                        let _e251 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e251 + 1u) < _e251) {
                            let _e255 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e251 < _e73) {
                            let _e257 = (2u * _e251);
                            atomicStore((&pairs.member[(4u + _e257)]), _e247.member);
                            atomicStore((&pairs.member[(_e257 + 5u)]), _e247.member_1);
                        }
                    }
                    if (_e198 != 4294967295u) {
                        let _e264 = order.member[_e198];
                        if (_e75 < _e264) {
                            phi_509_ = type_9(_e75, _e264);
                        } else {
                            phi_509_ = type_9(_e264, _e75);
                        }
                        let _e269 = phi_509_;
                        let _e273 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e273 + 1u) < _e273) {
                            let _e277 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e273 < _e73) {
                            let _e279 = (2u * _e273);
                            atomicStore((&pairs.member[(4u + _e279)]), _e269.member);
                            atomicStore((&pairs.member[(_e279 + 5u)]), _e269.member_1);
                        }
                    }
                }
                phi_540_ = _e98;
            } else {
                phi_540_ = false;
            }
            let _e285 = phi_540_;
            continue;
            continuing {
                phi_197_ = _e91;
                break if !(_e285);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
