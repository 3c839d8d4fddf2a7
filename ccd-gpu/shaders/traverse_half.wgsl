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
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
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
    var phi_308_: bool;
    var phi_331_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_568_: bool;
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
        let _e44 = params.member.member_1.member_1;
        let _e45 = (_e44 + _e37);
        let _e50 = params.member.member_2.member[0u][1u];
        let _e53 = leaves.member[(_e50 + _e45)];
        let _e69 = params.member.member.member_2[1u];
        let _e73 = params.member.member.member[1u];
        let _e76 = order.member[(_e69 + _e45)];
        let _e77 = (_e76 - _e69);
        local = type_27(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_199_ = type_9(0u, (_e73 - 1u));
        loop {
            let _e81 = phi_199_;
            let _e84 = (_e81.member < _e81.member_1);
            if (bitcast<i32>(select(0u, 1u, _e84)) != 0i) {
                let _e97 = local.member_3;
                if _e97 {
                    let _e99 = local.member_2;
                    let _e101 = nodes.member[_e99];
                    let _e138 = (_e45 == 4294967295u);
                    if select((_e101.member_2.w > _e45), true, _e138) {
                        phi_308_ = ((((((bitcast<f32>(_e101.member.x) <= _e53.member_1.y) && (_e53.member.x <= bitcast<f32>(_e101.member_1.x))) && (bitcast<f32>(_e101.member.y) <= _e53.member_2.x)) && (_e53.member.y <= bitcast<f32>(_e101.member_1.y))) && (bitcast<f32>(_e101.member.z) <= _e53.member_2.y)) && (_e53.member_1.x <= bitcast<f32>(_e101.member_1.z)));
                    } else {
                        phi_308_ = false;
                    }
                    let _e154 = phi_308_;
                    if select(((_e101.member_3.w & 2147483647u) > _e45), true, _e138) {
                        phi_331_ = ((((((bitcast<f32>(_e101.member_2.x) <= _e53.member_1.y) && (_e53.member.x <= bitcast<f32>(_e101.member_3.x))) && (bitcast<f32>(_e101.member_2.y) <= _e53.member_2.x)) && (_e53.member.y <= bitcast<f32>(_e101.member_3.y))) && (bitcast<f32>(_e101.member_2.z) <= _e53.member_2.y)) && (_e53.member_1.x <= bitcast<f32>(_e101.member_3.z)));
                    } else {
                        phi_331_ = false;
                    }
                    let _e169 = phi_331_;
                    let _e171 = ((_e101.member.w & 2147483648u) != 0u);
                    let _e173 = ((_e101.member_1.w & 2147483648u) != 0u);
                    let _e179 = select(select(u32(), select(u32(), (_e101.member.w & 2147483647u), _e171), _e154), 4294967295u, select(true, select(true, false, _e171), _e154));
                    let _e185 = select(select(u32(), select(u32(), (_e101.member_1.w & 2147483647u), _e173), _e169), 4294967295u, select(true, select(true, false, _e173), _e169));
                    let _e187 = select(false, !(_e171), _e154);
                    let _e189 = select(false, !(_e173), _e169);
                    if _e187 {
                        if _e189 {
                            let _e191 = ((_e101.member_3.w & 2147483648u) != 0u);
                            let _e194 = local.member_1;
                            local.member[_e194] = select(_e101.member.w, _e101.member_1.w, _e191);
                            let _e199 = local.member_1;
                            local.member_1 = (_e199 + 1u);
                            local.member_2 = select(_e101.member_1.w, _e101.member.w, _e191);
                            phi_405_ = false;
                        } else {
                            phi_405_ = true;
                        }
                        let _e204 = phi_405_;
                        phi_406_ = _e204;
                    } else {
                        phi_406_ = true;
                    }
                    let _e206 = phi_406_;
                    if _e206 {
                        if _e187 {
                            local.member_2 = _e101.member.w;
                        } else {
                            if _e189 {
                                local.member_2 = _e101.member_1.w;
                            } else {
                                let _e208 = local.member_1;
                                if (_e208 > 0u) {
                                    let _e213 = local.member_1;
                                    local.member_1 = (_e213 - 1u);
                                    let _e216 = local.member_1;
                                    let _e219 = local.member[_e216];
                                    local.member_2 = _e219;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e179 != 4294967295u) {
                        let _e227 = params.member.member.member_2[1u];
                        let _e230 = order.member[(_e227 + _e179)];
                        let _e231 = (_e230 - _e227);
                        let _e234 = params.member.member_1.member_3;
                        let _e235 = (_e77 < _e231);
                        let _e239 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e239 + 1u) < _e239) {
                            let _e243 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e239 < _e234) {
                            let _e245 = (2u * _e239);
                            atomicStore((&pairs.member[(4u + _e245)]), select(_e231, _e77, _e235));
                            atomicStore((&pairs.member[(_e245 + 5u)]), select(_e77, _e231, _e235));
                        }
                    }
                    if (_e185 != 4294967295u) {
                        let _e254 = params.member.member.member_2[1u];
                        let _e257 = order.member[(_e254 + _e185)];
                        let _e258 = (_e257 - _e254);
                        let _e261 = params.member.member_1.member_3;
                        let _e262 = (_e77 < _e258);
                        let _e266 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e266 + 1u) < _e266) {
                            let _e270 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e266 < _e261) {
                            let _e272 = (2u * _e266);
                            atomicStore((&pairs.member[(4u + _e272)]), select(_e258, _e77, _e262));
                            atomicStore((&pairs.member[(_e272 + 5u)]), select(_e77, _e258, _e262));
                        }
                    }
                }
                phi_568_ = _e97;
            } else {
                phi_568_ = false;
            }
            let _e278 = phi_568_;
            continue;
            continuing {
                phi_199_ = type_9(select(_e81.member, (_e81.member + 1u), _e84), select(_e81.member_1, _e81.member_1, _e84));
                break if !(_e278);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
