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
}

struct type_26 {
    member: type_25,
    member_1: u32,
    member_2: bool,
    member_3: bool,
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
    var phi_378_: type_9;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_532_: u32;
    var phi_562_: bool;
    var phi_684_: bool;
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
        local = type_26(type_25(array<u32, 31>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, false, true);
        phi_378_ = type_9(0u, (2u * _e85));
        loop {
            let _e162 = phi_378_;
            let _e165 = (_e162.member < _e162.member_1);
            if (bitcast<i32>(select(0u, 1u, _e165)) != 0i) {
                let _e178 = local.member_3;
                if _e178 {
                    let _e180 = local.member_1;
                    let _e182 = nodes.member[_e180];
                    let _e218 = local.member_2;
                    if (((_e182.member_3.w & 4u) != 0u) != _e218) {
                        phi_530_ = ((_e182.member_3.w & 1u) != 0u);
                        phi_531_ = ((((((bitcast<f32>(_e182.member.x) <= _e63.member_1.y) && (_e63.member.x <= bitcast<f32>(_e182.member_1.x))) && (bitcast<f32>(_e182.member.y) <= _e63.member_2.x)) && (_e63.member.y <= bitcast<f32>(_e182.member_1.y))) && (bitcast<f32>(_e182.member.z) <= _e63.member_2.y)) && (_e63.member_1.x <= bitcast<f32>(_e182.member_1.z)));
                        phi_532_ = _e182.member_2.w;
                    } else {
                        phi_530_ = ((_e182.member_3.w & 2u) != 0u);
                        phi_531_ = ((((((bitcast<f32>(_e182.member_2.x) <= _e63.member_1.y) && (_e63.member.x <= bitcast<f32>(_e182.member_3.x))) && (bitcast<f32>(_e182.member_2.y) <= _e63.member_2.x)) && (_e63.member.y <= bitcast<f32>(_e182.member_3.y))) && (bitcast<f32>(_e182.member_2.z) <= _e63.member_2.y)) && (_e63.member_1.x <= bitcast<f32>(_e182.member_3.z)));
                        phi_532_ = (_e182.member_2.w + 1u);
                    }
                    let _e248 = phi_530_;
                    let _e250 = phi_531_;
                    let _e252 = phi_532_;
                    if _e250 {
                        if _e248 {
                        } else {
                            let _e254 = local.member_2;
                            if _e254 {
                            } else {
                                let _e256 = local.member_1;
                                let _e258 = function_(_e256);
                                let _e260 = local.member.member_1;
                                local.member.member[_e260] = _e258;
                                let _e265 = local.member.member_1;
                                local.member.member_1 = (_e265 + 1u);
                            }
                            local.member_1 = _e252;
                            local.member_2 = false;
                        }
                        phi_562_ = _e248;
                    } else {
                        phi_562_ = true;
                    }
                    let _e270 = phi_562_;
                    if _e270 {
                        let _e272 = local.member_2;
                        if _e272 {
                            let _e276 = local.member.member_1;
                            if (_e276 > 0u) {
                                let _e282 = local.member.member_1;
                                local.member.member_1 = (_e282 - 1u);
                                let _e285 = local.member.member_1;
                                let _e288 = local.member.member[_e285];
                                local.member_1 = _e288;
                                local.member_2 = true;
                            } else {
                                local.member_3 = false;
                            }
                        } else {
                            local.member_2 = true;
                        }
                    }
                    let _e293 = select(_e252, 4294967295u, select(true, select(true, false, _e248), _e250));
                    if (_e293 != 4294967295u) {
                        let _e297 = params.member.member_2.member;
                        let _e303 = params.member.member.member_2[select(1u, 2u, (_e297 == 0u))];
                        let _e306 = order.member[(_e303 + _e293)];
                        let _e307 = (_e306 - _e303);
                        let _e310 = params.member.member_2.member;
                        if select((_e307 > _e61), true, (_e310 == 0u)) {
                            let _e316 = params.member.member_1.member_3;
                            let _e318 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e318 + 1u) < _e318) {
                                let _e322 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e318 < _e316) {
                                let _e324 = (2u * _e318);
                                atomicStore((&pairs.member[(4u + _e324)]), _e61);
                                atomicStore((&pairs.member[(_e324 + 5u)]), _e307);
                            }
                        }
                    }
                }
                phi_684_ = _e178;
            } else {
                phi_684_ = false;
            }
            let _e330 = phi_684_;
            continue;
            continuing {
                phi_378_ = type_9(select(_e162.member, (_e162.member + 1u), _e165), select(_e162.member_1, _e162.member_1, _e165));
                break if !(_e330);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_recursive(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
