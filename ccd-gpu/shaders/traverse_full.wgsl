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
    var phi_144_: u32;
    var phi_368_: type_9;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_781_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e37 = ((((_e23.y * _e24.x) + _e23.x) * 128u) + _e25);
    let _e40 = params.member.member_1.member;
    if (_e37 < _e40) {
        let _e44 = params.member.member_2.member;
        let _e50 = params.member.member.member_2[select(1u, 0u, (_e44 == 0u))];
        let _e53 = params.member.member_1.member_1;
        let _e55 = ((_e50 + _e53) + _e37);
        let _e58 = params.member.member_2.member_1;
        if (_e58 == 0u) {
            phi_144_ = _e55;
        } else {
            let _e61 = order.member[_e55];
            phi_144_ = _e61;
        }
        let _e63 = phi_144_;
        let _e64 = (_e63 - _e50);
        let _e66 = boxes.member[_e63];
        let _e81 = params.member.member_2.member;
        let _e87 = params.member.member.member[select(1u, 2u, (_e81 == 0u))];
        let _e88 = (_e87 - 1u);
        if (_e88 == 0u) {
            let _e92 = params.member.member_2.member;
            let _e98 = params.member.member.member_2[select(1u, 2u, (_e92 == 0u))];
            let _e100 = order.member[_e98];
            let _e102 = boxes.member[_e100];
            if ((((((_e102.member.x <= _e66.member_1.y) && (_e66.member.x <= _e102.member_1.y)) && (_e102.member.y <= _e66.member_2.x)) && (_e66.member.y <= _e102.member_2.x)) && (_e102.member_1.x <= _e66.member_2.y)) && (_e66.member_1.x <= _e102.member_2.y)) {
                let _e128 = params.member.member_2.member;
                let _e134 = params.member.member.member_2[select(1u, 2u, (_e128 == 0u))];
                let _e136 = order.member[_e134];
                let _e137 = (_e136 - _e134);
                let _e140 = params.member.member_2.member;
                if select((_e137 > _e64), true, (_e140 == 0u)) {
                    let _e146 = params.member.member_1.member_3;
                    let _e148 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e148 + 1u) < _e148) {
                        let _e152 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e148 < _e146) {
                        let _e154 = (2u * _e148);
                        atomicStore((&pairs.member[(4u + _e154)]), _e64);
                        atomicStore((&pairs.member[(_e154 + 5u)]), _e137);
                    }
                }
            }
        }
        local = type_25(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_368_ = type_9(0u, _e88);
        loop {
            let _e161 = phi_368_;
            let _e164 = (_e161.member < _e161.member_1);
            if (bitcast<i32>(select(0u, 1u, _e164)) != 0i) {
                let _e177 = local.member_3;
                if _e177 {
                    let _e179 = local.member_2;
                    let _e181 = nodes.member[_e179];
                    let _e226 = ((((((bitcast<f32>(_e181.member.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e181.member_1.x))) && (bitcast<f32>(_e181.member.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e181.member_1.y))) && (bitcast<f32>(_e181.member.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e181.member_1.z)));
                    let _e237 = ((((((bitcast<f32>(_e181.member_2.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e181.member_3.x))) && (bitcast<f32>(_e181.member_2.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e181.member_3.y))) && (bitcast<f32>(_e181.member_2.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e181.member_3.z)));
                    let _e239 = ((_e181.member.w & 2147483648u) != 0u);
                    let _e241 = ((_e181.member_1.w & 2147483648u) != 0u);
                    let _e247 = select(select(u32(), select(u32(), (_e181.member.w & 2147483647u), _e239), _e226), 4294967295u, select(true, select(true, false, _e239), _e226));
                    let _e253 = select(select(u32(), select(u32(), (_e181.member_1.w & 2147483647u), _e241), _e237), 4294967295u, select(true, select(true, false, _e241), _e237));
                    let _e255 = select(false, !(_e239), _e226);
                    let _e257 = select(false, !(_e241), _e237);
                    if _e255 {
                        if _e257 {
                            let _e259 = ((_e181.member_3.w & 2147483648u) != 0u);
                            let _e262 = local.member_1;
                            local.member[_e262] = select(_e181.member.w, _e181.member_1.w, _e259);
                            let _e267 = local.member_1;
                            local.member_1 = (_e267 + 1u);
                            local.member_2 = select(_e181.member_1.w, _e181.member.w, _e259);
                            phi_574_ = false;
                        } else {
                            phi_574_ = true;
                        }
                        let _e272 = phi_574_;
                        phi_575_ = _e272;
                    } else {
                        phi_575_ = true;
                    }
                    let _e274 = phi_575_;
                    if _e274 {
                        if _e255 {
                            local.member_2 = _e181.member.w;
                        } else {
                            if _e257 {
                                local.member_2 = _e181.member_1.w;
                            } else {
                                let _e276 = local.member_1;
                                if (_e276 > 0u) {
                                    let _e281 = local.member_1;
                                    local.member_1 = (_e281 - 1u);
                                    let _e284 = local.member_1;
                                    let _e287 = local.member[_e284];
                                    local.member_2 = _e287;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e247 != 4294967295u) {
                        let _e294 = params.member.member_2.member;
                        let _e300 = params.member.member.member_2[select(1u, 2u, (_e294 == 0u))];
                        let _e303 = order.member[(_e300 + _e247)];
                        let _e304 = (_e303 - _e300);
                        let _e307 = params.member.member_2.member;
                        if select((_e304 > _e64), true, (_e307 == 0u)) {
                            let _e313 = params.member.member_1.member_3;
                            let _e315 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e315 + 1u) < _e315) {
                                let _e319 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e315 < _e313) {
                                let _e321 = (2u * _e315);
                                atomicStore((&pairs.member[(4u + _e321)]), _e64);
                                atomicStore((&pairs.member[(_e321 + 5u)]), _e304);
                            }
                        }
                    }
                    if (_e253 != 4294967295u) {
                        let _e329 = params.member.member_2.member;
                        let _e335 = params.member.member.member_2[select(1u, 2u, (_e329 == 0u))];
                        let _e338 = order.member[(_e335 + _e253)];
                        let _e339 = (_e338 - _e335);
                        let _e342 = params.member.member_2.member;
                        if select((_e339 > _e64), true, (_e342 == 0u)) {
                            let _e348 = params.member.member_1.member_3;
                            let _e350 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e350 + 1u) < _e350) {
                                let _e354 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e350 < _e348) {
                                let _e356 = (2u * _e350);
                                atomicStore((&pairs.member[(4u + _e356)]), _e64);
                                atomicStore((&pairs.member[(_e356 + 5u)]), _e339);
                            }
                        }
                    }
                }
                phi_781_ = _e177;
            } else {
                phi_781_ = false;
            }
            let _e362 = phi_781_;
            continue;
            continuing {
                phi_368_ = type_9(select(_e161.member, (_e161.member + 1u), _e164), select(_e161.member_1, _e161.member_1, _e164));
                break if !(_e362);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
