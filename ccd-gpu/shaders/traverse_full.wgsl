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
    member: array<u32, 47>,
    member_1: u32,
}

struct type_26 {
    member: type_25,
    member_1: u32,
    member_2: bool,
}

struct type_29 {
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
var<storage, read_write> pairs: type_29;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var phi_148_: u32;
    var phi_392_: type_9;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_782_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e20 = id_2;
    let _e21 = n_2;
    let _e22 = lane_2;
    let _e34 = ((((_e20.y * _e21.x) + _e20.x) * 128u) + _e22);
    let _e37 = params.member.member_1.member;
    if (_e34 < _e37) {
        let _e41 = params.member.member_2.member;
        let _e47 = params.member.member.member_2[select(1u, 0u, (_e41 == 0u))];
        let _e50 = params.member.member_1.member_1;
        let _e52 = ((_e47 + _e50) + _e34);
        let _e55 = params.member.member_2.member_1;
        if (_e55 == 0u) {
            phi_148_ = _e52;
        } else {
            let _e58 = order.member[_e52];
            phi_148_ = _e58;
        }
        let _e60 = phi_148_;
        let _e61 = (_e60 - _e47);
        let _e63 = boxes.member[_e60];
        let _e78 = params.member.member_2.member;
        let _e84 = params.member.member.member[select(1u, 2u, (_e78 == 0u))];
        let _e85 = (_e84 - 1u);
        if (_e85 == 0u) {
            let _e89 = params.member.member_2.member;
            let _e95 = params.member.member.member_2[select(1u, 2u, (_e89 == 0u))];
            let _e97 = order.member[_e95];
            let _e99 = boxes.member[_e97];
            if ((((((_e99.member.x <= _e63.member_1.y) && (_e63.member.x <= _e99.member_1.y)) && (_e99.member.y <= _e63.member_2.x)) && (_e63.member.y <= _e99.member_2.x)) && (_e99.member_1.x <= _e63.member_2.y)) && (_e63.member_1.x <= _e99.member_2.y)) {
                let _e125 = params.member.member_2.member;
                let _e131 = params.member.member.member_2[select(1u, 2u, (_e125 == 0u))];
                let _e133 = order.member[_e131];
                let _e134 = (_e133 - _e131);
                let _e137 = params.member.member_2.member;
                if select((_e134 > _e61), true, (_e137 == 0u)) {
                    let _e143 = params.member.member_1.member_3;
                    let _e145 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e145 + 1u) < _e145) {
                        let _e149 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e145 < _e143) {
                        let _e151 = (2u * _e145);
                        atomicStore((&pairs.member[(4u + _e151)]), _e61);
                        atomicStore((&pairs.member[(_e151 + 5u)]), _e134);
                    }
                }
            }
        }
        local = type_26(type_25(array<u32, 47>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, true);
        phi_392_ = type_9(0u, _e85);
        loop {
            let _e161 = phi_392_;
            let _e164 = (_e161.member < _e161.member_1);
            if (bitcast<i32>(select(0u, 1u, _e164)) != 0i) {
                let _e177 = local.member_2;
                if _e177 {
                    let _e179 = local.member_1;
                    let _e181 = nodes.member[_e179];
                    let _e224 = ((((((bitcast<f32>(_e181.member.x) <= _e63.member_1.y) && (_e63.member.x <= bitcast<f32>(_e181.member_1.x))) && (bitcast<f32>(_e181.member.y) <= _e63.member_2.x)) && (_e63.member.y <= bitcast<f32>(_e181.member_1.y))) && (bitcast<f32>(_e181.member.z) <= _e63.member_2.y)) && (_e63.member_1.x <= bitcast<f32>(_e181.member_1.z)));
                    let _e235 = ((((((bitcast<f32>(_e181.member_2.x) <= _e63.member_1.y) && (_e63.member.x <= bitcast<f32>(_e181.member_3.x))) && (bitcast<f32>(_e181.member_2.y) <= _e63.member_2.x)) && (_e63.member.y <= bitcast<f32>(_e181.member_3.y))) && (bitcast<f32>(_e181.member_2.z) <= _e63.member_2.y)) && (_e63.member_1.x <= bitcast<f32>(_e181.member_3.z)));
                    let _e237 = ((_e181.member_3.w & 1u) != 0u);
                    let _e239 = ((_e181.member_3.w & 2u) != 0u);
                    let _e240 = (_e181.member_2.w + 1u);
                    let _e243 = select(_e181.member_2.w, 4294967295u, select(true, select(true, false, _e237), _e224));
                    let _e246 = select(_e240, 4294967295u, select(true, select(true, false, _e239), _e235));
                    let _e248 = select(false, !(_e237), _e224);
                    let _e250 = select(false, !(_e239), _e235);
                    if _e248 {
                        if _e250 {
                            let _e252 = ((_e181.member_3.w & 4u) != 0u);
                            let _e255 = function_(select(_e181.member_2.w, _e240, _e252));
                            let _e257 = local.member.member_1;
                            local.member.member[_e257] = _e255;
                            let _e262 = local.member.member_1;
                            local.member.member_1 = (_e262 + 1u);
                            local.member_1 = select(_e240, _e181.member_2.w, _e252);
                            phi_567_ = false;
                        } else {
                            phi_567_ = true;
                        }
                        let _e267 = phi_567_;
                        phi_568_ = _e267;
                    } else {
                        phi_568_ = true;
                    }
                    let _e269 = phi_568_;
                    if _e269 {
                        if _e248 {
                            local.member_1 = _e181.member_2.w;
                        } else {
                            if _e250 {
                                local.member_1 = _e240;
                            } else {
                                let _e272 = local.member.member_1;
                                local.member_2 = (_e272 > 0u);
                                let _e276 = local.member_2;
                                if _e276 {
                                    let _e280 = local.member.member_1;
                                    local.member.member_1 = (_e280 - 1u);
                                    let _e283 = local.member.member_1;
                                    let _e286 = local.member.member[_e283];
                                    local.member_1 = _e286;
                                }
                            }
                        }
                    }
                    if (_e243 != 4294967295u) {
                        let _e293 = params.member.member_2.member;
                        let _e299 = params.member.member.member_2[select(1u, 2u, (_e293 == 0u))];
                        let _e302 = order.member[(_e299 + _e243)];
                        let _e303 = (_e302 - _e299);
                        let _e306 = params.member.member_2.member;
                        if select((_e303 > _e61), true, (_e306 == 0u)) {
                            let _e312 = params.member.member_1.member_3;
                            let _e314 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e314 + 1u) < _e314) {
                                let _e318 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e314 < _e312) {
                                let _e320 = (2u * _e314);
                                atomicStore((&pairs.member[(4u + _e320)]), _e61);
                                atomicStore((&pairs.member[(_e320 + 5u)]), _e303);
                            }
                        }
                    }
                    if (_e246 != 4294967295u) {
                        let _e328 = params.member.member_2.member;
                        let _e334 = params.member.member.member_2[select(1u, 2u, (_e328 == 0u))];
                        let _e337 = order.member[(_e334 + _e246)];
                        let _e338 = (_e337 - _e334);
                        let _e341 = params.member.member_2.member;
                        if select((_e338 > _e61), true, (_e341 == 0u)) {
                            let _e347 = params.member.member_1.member_3;
                            let _e349 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e349 + 1u) < _e349) {
                                let _e353 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e349 < _e347) {
                                let _e355 = (2u * _e349);
                                atomicStore((&pairs.member[(4u + _e355)]), _e61);
                                atomicStore((&pairs.member[(_e355 + 5u)]), _e338);
                            }
                        }
                    }
                }
                phi_782_ = _e177;
            } else {
                phi_782_ = false;
            }
            let _e361 = phi_782_;
            continue;
            continuing {
                phi_392_ = type_9(select(_e161.member, (_e161.member + 1u), _e164), select(_e161.member_1, _e161.member_1, _e164));
                break if !(_e361);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
