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
    member_4: bool,
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
    var phi_370_: type_9;
    var phi_520_: bool;
    var phi_550_: bool;
    var phi_673_: bool;
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
        local = type_25(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, false, true);
        phi_370_ = type_9(0u, (2u * _e88));
        loop {
            let _e162 = phi_370_;
            let _e165 = (_e162.member < _e162.member_1);
            if (bitcast<i32>(select(0u, 1u, _e165)) != 0i) {
                let _e178 = local.member_4;
                if _e178 {
                    let _e180 = local.member_2;
                    let _e182 = nodes.member[_e180];
                    let _e220 = local.member_3;
                    let _e221 = (((_e182.member_3.w & 2147483648u) != 0u) != _e220);
                    let _e222 = select(_e182.member_1.w, _e182.member.w, _e221);
                    if _e221 {
                        phi_520_ = ((((((bitcast<f32>(_e182.member.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e182.member_1.x))) && (bitcast<f32>(_e182.member.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e182.member_1.y))) && (bitcast<f32>(_e182.member.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e182.member_1.z)));
                    } else {
                        phi_520_ = ((((((bitcast<f32>(_e182.member_2.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e182.member_3.x))) && (bitcast<f32>(_e182.member_2.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e182.member_3.y))) && (bitcast<f32>(_e182.member_2.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e182.member_3.z)));
                    }
                    let _e246 = phi_520_;
                    let _e248 = ((_e222 & 2147483648u) != 0u);
                    if _e246 {
                        if _e248 {
                        } else {
                            let _e250 = local.member_3;
                            if _e250 {
                            } else {
                                let _e252 = local.member_2;
                                let _e254 = local.member_1;
                                local.member[_e254] = _e252;
                                let _e259 = local.member_1;
                                local.member_1 = (_e259 + 1u);
                            }
                            local.member_2 = _e222;
                            local.member_3 = false;
                        }
                        phi_550_ = _e248;
                    } else {
                        phi_550_ = true;
                    }
                    let _e264 = phi_550_;
                    if _e264 {
                        let _e266 = local.member_3;
                        if _e266 {
                            let _e269 = local.member_1;
                            if (_e269 > 0u) {
                                let _e274 = local.member_1;
                                local.member_1 = (_e274 - 1u);
                                let _e277 = local.member_1;
                                let _e280 = local.member[_e277];
                                local.member_2 = _e280;
                                local.member_3 = true;
                            } else {
                                local.member_4 = false;
                            }
                        } else {
                            local.member_3 = true;
                        }
                    }
                    let _e288 = select(select(u32(), select(u32(), (_e222 & 2147483647u), _e248), _e246), 4294967295u, select(true, select(true, false, _e248), _e246));
                    if (_e288 != 4294967295u) {
                        let _e292 = params.member.member_2.member;
                        let _e298 = params.member.member.member_2[select(1u, 2u, (_e292 == 0u))];
                        let _e301 = order.member[(_e298 + _e288)];
                        let _e302 = (_e301 - _e298);
                        let _e305 = params.member.member_2.member;
                        if select((_e302 > _e64), true, (_e305 == 0u)) {
                            let _e311 = params.member.member_1.member_3;
                            let _e313 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e313 + 1u) < _e313) {
                                let _e317 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e313 < _e311) {
                                let _e319 = (2u * _e313);
                                atomicStore((&pairs.member[(4u + _e319)]), _e64);
                                atomicStore((&pairs.member[(_e319 + 5u)]), _e302);
                            }
                        }
                    }
                }
                phi_673_ = _e178;
            } else {
                phi_673_ = false;
            }
            let _e325 = phi_673_;
            continue;
            continuing {
                phi_370_ = type_9(select(_e162.member, (_e162.member + 1u), _e165), select(_e162.member_1, _e162.member_1, _e165));
                break if !(_e325);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_recursive(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
