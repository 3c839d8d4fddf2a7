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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: i32,
    member_1: i32,
}

struct type_14 {
    member: u32,
    member_1: i32,
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

struct type_19 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_22 {
    member: array<vec4<u32>>,
}

struct type_24 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_26;
@group(0) @binding(4) 
var<storage> bodies: type_10;
var<workgroup> shared_: array<type_28, 256>;
@group(0) @binding(3) 
var<storage> elements: type_10;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_26;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_130_: u32;
    var phi_292_: array<u32, 3>;
    var phi_294_: type_19;
    var phi_295_: type_19;
    var phi_296_: type_19;
    var phi_297_: type_28;
    var phi_298_: type_19;
    var phi_299_: type_28;
    var phi_375_: type_28;
    var phi_376_: type_28;
    var phi_377_: type_28;
    var phi_392_: type_13;
    var phi_395_: type_28;
    var phi_397_: u32;
    var phi_393_: type_13;
    var phi_438_: type_14;
    var phi_590_: type_28;
    var phi_591_: type_28;
    var phi_637_: type_28;
    var phi_650_: type_28;
    var phi_396_: type_28;
    var phi_398_: u32;
    var local: type_28;
    var local_1: type_28;
    var local_2: type_28;
    var local_3: type_28;
    var local_4: type_28;
    var local_5: type_28;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e32 = id_2;
    let _e33 = n_2;
    let _e34 = lane_2;
    let _e48 = ((((_e32.y * _e33.x) + _e32.x) * 256u) + _e34);
    let _e53 = params.member.member_2.member[0u][2u];
    if (_e48 >= _e53) {
        phi_130_ = 2u;
    } else {
        let _e56 = params.member.member_2.member[0u][1u];
        phi_130_ = select(0u, 1u, (_e48 >= _e56));
    }
    let _e60 = phi_130_;
    let _e65 = params.member.member_2.member[0u][_e60];
    let _e66 = (_e48 - _e65);
    let _e71 = params.member.member_2.member[0u][3u];
    let _e72 = (_e48 < _e71);
    if _e72 {
        let _e76 = params.member.member.member[_e60];
        if (_e66 < _e76) {
            let _e81 = params.member.member.member_2[_e60];
            let _e84 = order.member[(_e81 + _e66)];
            let _e86 = boxes.member[_e84];
            let _e105 = params.member.member.member_2[_e60];
            let _e106 = (_e84 - _e105);
            let _e110 = type_19(array<u32, 3>(_e106, _e106, _e106), type_19(array<u32, 3>(0u, 0u, 0u), _e106).member_1);
            let _e113 = params.member.member.member_1;
            if ((_e113 & 1u) != 0u) {
                if (_e60 > 0u) {
                    let _e120 = params.member.member.member[1u];
                    let _e124 = params.member.member.member_2[1u];
                    let _e125 = (_e84 - _e124);
                    if (_e125 < _e120) {
                        let _e140 = (2u * _e125);
                        let _e142 = elements.member[_e140];
                        let _e145 = elements.member[(_e140 + 1u)];
                        phi_292_ = array<u32, 3>(_e142, _e145, _e145);
                    } else {
                        let _e130 = ((2u * _e120) + (3u * (_e125 - _e120)));
                        let _e132 = elements.member[_e130];
                        let _e135 = elements.member[(_e130 + 1u)];
                        let _e138 = elements.member[(_e130 + 2u)];
                        phi_292_ = array<u32, 3>(_e132, _e135, _e138);
                    }
                    let _e148 = phi_292_;
                    phi_294_ = type_19(_e148, _e110.member_1);
                } else {
                    phi_294_ = _e110;
                }
                let _e152 = phi_294_;
                phi_295_ = _e152;
            } else {
                phi_295_ = _e110;
            }
            let _e154 = phi_295_;
            phi_296_ = _e154;
            phi_297_ = type_28(array<f32, 3>(_e86.member.x, _e86.member.y, _e86.member_1.x), array<f32, 3>(_e86.member_1.y, _e86.member_2.x, _e86.member_2.y));
        } else {
            phi_296_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_297_ = type_28(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e156 = phi_296_;
        let _e158 = phi_297_;
        phi_298_ = _e156;
        phi_299_ = _e158;
    } else {
        phi_298_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_299_ = type_28(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e160 = phi_298_;
    let _e162 = phi_299_;
    let _e165 = params.member.member.member_1;
    let _e167 = ((_e165 & 256u) != 0u);
    if _e167 {
        let _e171 = bodies.member[_e160.member[0]];
        if (_e162.member[0] <= _e162.member_1[0]) {
            if (((bitcast<u32>(_e162.member_1[0]) & 1u) == 1u) != ((_e171 & 1u) == 1u)) {
                let _e187 = bitcast<u32>(_e162.member_1[0]);
                let _e190 = ((_e187 >> bitcast<u32>(31i)) == 1u);
                let _e191 = (_e187 & 2147483647u);
                let _e192 = (_e191 < 8388608u);
                let _e195 = select(true, select(true, false, (_e191 == 8388608u)), _e190);
                phi_375_ = type_28(_e162.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e187 + 1u), (_e187 - 1u), _e190), _e195), u32(), _e192), (8388608u | ((_e187 & 1u) ^ 1u)), select(select(true, false, _e195), true, _e192))), _e162.member_1[1], _e162.member_1[2]));
            } else {
                phi_375_ = _e162;
            }
            let _e215 = phi_375_;
            phi_376_ = _e215;
        } else {
            phi_376_ = _e162;
        }
        let _e217 = phi_376_;
        phi_377_ = _e217;
    } else {
        phi_377_ = _e162;
    }
    let _e219 = phi_377_;
    shared_[_e34] = type_28(array<f32, 3>(_e219.member[0], _e219.member[1], _e219.member[2]), array<f32, 3>(_e219.member_1[0], _e219.member_1[1], _e219.member_1[2]));
    phi_392_ = type_13(0i, 5i);
    phi_395_ = _e219;
    phi_397_ = 16u;
    loop {
        let _e233 = phi_392_;
        let _e235 = phi_395_;
        let _e237 = phi_397_;
        local = _e235;
        local_1 = _e235;
        local_2 = _e235;
        local_3 = _e235;
        local_4 = _e235;
        local_5 = _e235;
        if (_e233.member < _e233.member_1) {
            let _e244 = (_e233.member + 1i);
            phi_393_ = type_13(select(_e244, type_14().member_1, select(false, true, ((false == (_e244 > _e233.member)) != false))), _e233.member_1);
            phi_438_ = type_14(1u, _e233.member);
        } else {
            phi_393_ = _e233;
            phi_438_ = type_14(0u, type_14().member_1);
        }
        let _e255 = phi_393_;
        let _e257 = phi_438_;
        let _e260 = (bitcast<i32>(_e257.member) != 0i);
        if _e260 {
            workgroupBarrier();
            if ((_e34 % 32u) < _e237) {
                let _e265 = shared_[(_e34 + _e237)];
                if _e167 {
                    let _e304 = select(_e265.member[0], _e235.member[0], (_e235.member[0] < _e265.member[0]));
                    let _e317 = select(_e265.member_1[0], _e235.member_1[0], (_e235.member_1[0] > _e265.member_1[0]));
                    let _e327 = type_28(array<f32, 3>(_e304, select(_e265.member[1], _e235.member[1], (_e235.member[1] < _e265.member[1])), select(_e265.member[2], _e235.member[2], (_e235.member[2] < _e265.member[2]))), array<f32, 3>(_e317, select(_e265.member_1[1], _e235.member_1[1], (_e235.member_1[1] > _e265.member_1[1])), select(_e265.member_1[2], _e235.member_1[2], (_e235.member_1[2] > _e265.member_1[2]))));
                    if (_e304 <= _e317) {
                        if (((bitcast<u32>(_e317) & 1u) == 1u) != select(false, select(!((_e265.member[0] <= _e265.member_1[0])), true, ((bitcast<u32>(_e265.member_1[0]) & 1u) == 1u)), select(!((_e235.member[0] <= _e235.member_1[0])), true, ((bitcast<u32>(_e235.member_1[0]) & 1u) == 1u)))) {
                            let _e352 = bitcast<u32>(_e317);
                            let _e355 = ((_e352 >> bitcast<u32>(31i)) == 1u);
                            let _e356 = (_e352 & 2147483647u);
                            let _e357 = (_e356 < 8388608u);
                            let _e360 = select(true, select(true, false, (_e356 == 8388608u)), _e355);
                            phi_590_ = type_28(_e327.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e352 + 1u), (_e352 - 1u), _e355), _e360), u32(), _e357), (8388608u | ((_e352 & 1u) ^ 1u)), select(select(true, false, _e360), true, _e357))), _e327.member_1[1], _e327.member_1[2]));
                        } else {
                            phi_590_ = _e327;
                        }
                        let _e380 = phi_590_;
                        phi_591_ = _e380;
                    } else {
                        phi_591_ = _e327;
                    }
                    let _e382 = phi_591_;
                    phi_637_ = _e382;
                } else {
                    phi_637_ = type_28(array<f32, 3>(select(_e265.member[0], _e235.member[0], (_e235.member[0] < _e265.member[0])), select(_e265.member[1], _e235.member[1], (_e235.member[1] < _e265.member[1])), select(_e265.member[2], _e235.member[2], (_e235.member[2] < _e265.member[2]))), array<f32, 3>(select(_e265.member_1[0], _e235.member_1[0], (_e235.member_1[0] > _e265.member_1[0])), select(_e265.member_1[1], _e235.member_1[1], (_e235.member_1[1] > _e265.member_1[1])), select(_e265.member_1[2], _e235.member_1[2], (_e235.member_1[2] > _e265.member_1[2]))));
                }
                let _e384 = phi_637_;
                shared_[_e34] = type_28(array<f32, 3>(_e384.member[0], _e384.member[1], _e384.member[2]), array<f32, 3>(_e384.member_1[0], _e384.member_1[1], _e384.member_1[2]));
                phi_650_ = _e384;
            } else {
                phi_650_ = _e235;
            }
            let _e398 = phi_650_;
            phi_396_ = _e398;
            phi_398_ = (_e237 / 2u);
        } else {
            phi_396_ = type_28();
            phi_398_ = u32();
        }
        let _e401 = phi_396_;
        let _e403 = phi_398_;
        continue;
        continuing {
            phi_392_ = _e255;
            phi_395_ = _e401;
            phi_397_ = _e403;
            break if !(_e260);
        }
    }
    if _e72 {
        nodes.member[_e48] = type_24(vec2<f32>(_e162.member[0], _e162.member[1]), vec2<f32>(_e162.member[2], _e162.member_1[0]), vec2<f32>(_e162.member_1[1], _e162.member_1[2]));
        leaves.member[_e48] = vec4<u32>(_e160.member[0], _e160.member[1], _e160.member[2], _e160.member_1);
        if ((_e34 % 32u) == 0u) {
            let _e438 = params.member.member_2.member[1u][_e60];
            let _e441 = local;
            let _e445 = local_1;
            let _e449 = local_2;
            let _e453 = local_3;
            let _e457 = local_4;
            let _e461 = local_5;
            nodes.member[(_e438 + (_e66 / 32u))] = type_24(vec2<f32>(_e441.member[0], _e445.member[1]), vec2<f32>(_e449.member[2], _e453.member_1[0]), vec2<f32>(_e457.member_1[1], _e461.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
