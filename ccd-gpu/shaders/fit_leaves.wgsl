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

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: array<vec4<u32>>,
}

struct type_26 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_28;
var<workgroup> shared_: array<type_30, 256>;
@group(0) @binding(3) 
var<storage> edges: type_21;
@group(0) @binding(4) 
var<storage> faces: type_33;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_28;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_24;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_136_: u32;
    var phi_137_: u32;
    var phi_260_: type_19;
    var phi_261_: type_19;
    var phi_262_: type_19;
    var phi_263_: type_19;
    var phi_264_: type_30;
    var phi_265_: type_19;
    var phi_266_: type_30;
    var phi_281_: type_13;
    var phi_284_: type_30;
    var phi_286_: u32;
    var phi_307_: bool;
    var phi_313_: type_14;
    var phi_282_: type_13;
    var phi_327_: type_14;
    var phi_359_: f32;
    var phi_366_: f32;
    var phi_373_: f32;
    var phi_381_: f32;
    var phi_388_: f32;
    var phi_395_: f32;
    var phi_410_: type_30;
    var phi_285_: type_30;
    var phi_287_: u32;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_30;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e45 = ((((_e29.y * _e30.x) + _e29.x) * 256u) + _e31);
    let _e50 = params.member.member_2.member[0u][2u];
    if (_e45 >= _e50) {
        phi_137_ = 2u;
    } else {
        let _e53 = params.member.member_2.member[0u][1u];
        if (_e45 >= _e53) {
            phi_136_ = 1u;
        } else {
            phi_136_ = 0u;
        }
        let _e56 = phi_136_;
        phi_137_ = _e56;
    }
    let _e58 = phi_137_;
    let _e63 = params.member.member_2.member[0u][_e58];
    let _e64 = (_e45 - _e63);
    let _e69 = params.member.member_2.member[0u][3u];
    let _e70 = (_e45 < _e69);
    if _e70 {
        let _e74 = params.member.member.member[_e58];
        if (_e64 < _e74) {
            let _e79 = params.member.member.member_2[_e58];
            let _e82 = order.member[(_e79 + _e64)];
            let _e84 = boxes.member[_e82];
            let _e103 = params.member.member.member_2[_e58];
            let _e104 = (_e82 - _e103);
            let _e108 = type_19(array<u32, 3>(_e104, _e104, _e104), type_19(array<u32, 3>(0u, 0u, 0u), _e104).member_1);
            let _e111 = params.member.member.member_1;
            if ((_e111 & 1u) != 0u) {
                if (_e58 == 1u) {
                    let _e123 = edges.member[_e104];
                    phi_261_ = type_19(array<u32, 3>(_e123[0], _e123[1], _e123[1]), _e108.member_1);
                } else {
                    if (_e58 == 2u) {
                        let _e117 = faces.member[_e104];
                        phi_260_ = type_19(_e117, _e108.member_1);
                    } else {
                        phi_260_ = _e108;
                    }
                    let _e121 = phi_260_;
                    phi_261_ = _e121;
                }
                let _e131 = phi_261_;
                phi_262_ = _e131;
            } else {
                phi_262_ = _e108;
            }
            let _e133 = phi_262_;
            phi_263_ = _e133;
            phi_264_ = type_30(array<f32, 3>(_e84.member.x, _e84.member.y, _e84.member_1.x), array<f32, 3>(_e84.member_1.y, _e84.member_2.x, _e84.member_2.y));
        } else {
            phi_263_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_264_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e135 = phi_263_;
        let _e137 = phi_264_;
        phi_265_ = _e135;
        phi_266_ = _e137;
    } else {
        phi_265_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_266_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e139 = phi_265_;
    let _e141 = phi_266_;
    shared_[_e31] = type_30(array<f32, 3>(_e141.member[0], _e141.member[1], _e141.member[2]), array<f32, 3>(_e141.member_1[0], _e141.member_1[1], _e141.member_1[2]));
    phi_281_ = type_13(0i, 5i);
    phi_284_ = _e141;
    phi_286_ = 16u;
    loop {
        let _e155 = phi_281_;
        let _e157 = phi_284_;
        let _e159 = phi_286_;
        local = _e157;
        local_1 = _e157;
        local_2 = _e157;
        local_3 = _e157;
        local_4 = _e157;
        local_5 = _e157;
        if (_e155.member < _e155.member_1) {
            let _e166 = (_e155.member + 1i);
            if ((false == (_e166 > _e155.member)) != false) {
                phi_307_ = true;
            } else {
                phi_307_ = false;
            }
            let _e171 = phi_307_;
            if _e171 {
                phi_313_ = type_14(0u, type_14().member_1);
            } else {
                phi_313_ = type_14(1u, _e166);
            }
            let _e176 = phi_313_;
            phi_282_ = type_13(_e176.member_1, _e155.member_1);
            phi_327_ = type_14(1u, _e155.member);
        } else {
            phi_282_ = _e155;
            phi_327_ = type_14(0u, type_14().member_1);
        }
        let _e182 = phi_282_;
        let _e184 = phi_327_;
        let _e187 = (bitcast<i32>(_e184.member) != 0i);
        if _e187 {
            workgroupBarrier();
            if ((_e31 % 32u) < _e159) {
                let _e192 = shared_[(_e31 + _e159)];
                if (_e157.member[0] < _e192.member[0]) {
                    phi_359_ = _e157.member[0];
                } else {
                    phi_359_ = _e192.member[0];
                }
                let _e205 = phi_359_;
                if (_e157.member[1] < _e192.member[1]) {
                    phi_366_ = _e157.member[1];
                } else {
                    phi_366_ = _e192.member[1];
                }
                let _e210 = phi_366_;
                if (_e157.member[2] < _e192.member[2]) {
                    phi_373_ = _e157.member[2];
                } else {
                    phi_373_ = _e192.member[2];
                }
                let _e215 = phi_373_;
                if (_e157.member_1[0] > _e192.member_1[0]) {
                    phi_381_ = _e157.member_1[0];
                } else {
                    phi_381_ = _e192.member_1[0];
                }
                let _e221 = phi_381_;
                if (_e157.member_1[1] > _e192.member_1[1]) {
                    phi_388_ = _e157.member_1[1];
                } else {
                    phi_388_ = _e192.member_1[1];
                }
                let _e226 = phi_388_;
                if (_e157.member_1[2] > _e192.member_1[2]) {
                    phi_395_ = _e157.member_1[2];
                } else {
                    phi_395_ = _e192.member_1[2];
                }
                let _e231 = phi_395_;
                shared_[_e31] = type_30(array<f32, 3>(_e205, _e210, _e215), array<f32, 3>(_e221, _e226, _e231));
                phi_410_ = type_30(array<f32, 3>(_e205, _e210, _e215), array<f32, 3>(_e221, _e226, _e231));
            } else {
                phi_410_ = _e157;
            }
            let _e239 = phi_410_;
            phi_285_ = _e239;
            phi_287_ = (_e159 / 2u);
        } else {
            phi_285_ = type_30();
            phi_287_ = u32();
        }
        let _e242 = phi_285_;
        let _e244 = phi_287_;
        continue;
        continuing {
            phi_281_ = _e182;
            phi_284_ = _e242;
            phi_286_ = _e244;
            break if !(_e187);
        }
    }
    if _e70 {
        nodes.member[_e45] = type_26(vec2<f32>(_e141.member[0], _e141.member[1]), vec2<f32>(_e141.member[2], _e141.member_1[0]), vec2<f32>(_e141.member_1[1], _e141.member_1[2]));
        leaves.member[_e45] = vec4<u32>(_e139.member[0], _e139.member[1], _e139.member[2], _e139.member_1);
        if ((_e31 % 32u) == 0u) {
            let _e279 = params.member.member_2.member[1u][_e58];
            let _e282 = local;
            let _e286 = local_1;
            let _e290 = local_2;
            let _e294 = local_3;
            let _e298 = local_4;
            let _e302 = local_5;
            nodes.member[(_e279 + (_e64 / 32u))] = type_26(vec2<f32>(_e282.member[0], _e286.member[1]), vec2<f32>(_e290.member[2], _e294.member_1[0]), vec2<f32>(_e298.member_1[1], _e302.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
