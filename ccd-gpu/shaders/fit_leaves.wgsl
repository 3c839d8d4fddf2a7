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
            let _e105 = type_19(array<u32, 3>(0u, 0u, 0u), _e104);
            let _e111 = type_19(array<u32, 3>(_e104, _e105.member[1], _e105.member[2]), _e105.member_1);
            let _e120 = type_19(array<u32, 3>(_e104, _e104, _e104), type_19(array<u32, 3>(_e111.member[0], _e104, _e111.member[2]), _e111.member_1).member_1);
            let _e123 = params.member.member.member_1;
            if ((_e123 & 1u) != 0u) {
                if (_e58 == 1u) {
                    let _e135 = edges.member[_e104];
                    let _e144 = type_19(array<u32, 3>(_e135[0], _e120.member[1], _e120.member[2]), _e120.member_1);
                    phi_261_ = type_19(array<u32, 3>(_e135[0], _e135[1], _e135[1]), type_19(array<u32, 3>(_e144.member[0], _e135[1], _e144.member[2]), _e144.member_1).member_1);
                } else {
                    if (_e58 == 2u) {
                        let _e129 = faces.member[_e104];
                        phi_260_ = type_19(_e129, _e120.member_1);
                    } else {
                        phi_260_ = _e120;
                    }
                    let _e133 = phi_260_;
                    phi_261_ = _e133;
                }
                let _e155 = phi_261_;
                phi_262_ = _e155;
            } else {
                phi_262_ = _e120;
            }
            let _e157 = phi_262_;
            phi_263_ = _e157;
            phi_264_ = type_30(array<f32, 3>(_e84.member.x, _e84.member.y, _e84.member_1.x), array<f32, 3>(_e84.member_1.y, _e84.member_2.x, _e84.member_2.y));
        } else {
            phi_263_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_264_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e159 = phi_263_;
        let _e161 = phi_264_;
        phi_265_ = _e159;
        phi_266_ = _e161;
    } else {
        phi_265_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_266_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e163 = phi_265_;
    let _e165 = phi_266_;
    shared_[_e31] = type_30(array<f32, 3>(_e165.member[0], _e165.member[1], _e165.member[2]), array<f32, 3>(_e165.member_1[0], _e165.member_1[1], _e165.member_1[2]));
    phi_281_ = type_13(0i, 5i);
    phi_284_ = _e165;
    phi_286_ = 16u;
    loop {
        let _e179 = phi_281_;
        let _e181 = phi_284_;
        let _e183 = phi_286_;
        local = _e181;
        local_1 = _e181;
        local_2 = _e181;
        local_3 = _e181;
        local_4 = _e181;
        local_5 = _e181;
        if (_e179.member < _e179.member_1) {
            let _e190 = (_e179.member + 1i);
            if ((false == (_e190 > _e179.member)) != false) {
                phi_307_ = true;
            } else {
                phi_307_ = false;
            }
            let _e195 = phi_307_;
            if _e195 {
                phi_313_ = type_14(0u, type_14().member_1);
            } else {
                phi_313_ = type_14(1u, _e190);
            }
            let _e200 = phi_313_;
            phi_282_ = type_13(_e200.member_1, _e179.member_1);
            phi_327_ = type_14(1u, _e179.member);
        } else {
            phi_282_ = _e179;
            phi_327_ = type_14(0u, type_14().member_1);
        }
        let _e206 = phi_282_;
        let _e208 = phi_327_;
        let _e211 = (bitcast<i32>(_e208.member) != 0i);
        if _e211 {
            workgroupBarrier();
            if ((_e31 % 32u) < _e183) {
                let _e216 = shared_[(_e31 + _e183)];
                if (_e181.member[0] < _e216.member[0]) {
                    phi_359_ = _e181.member[0];
                } else {
                    phi_359_ = _e216.member[0];
                }
                let _e229 = phi_359_;
                if (_e181.member[1] < _e216.member[1]) {
                    phi_366_ = _e181.member[1];
                } else {
                    phi_366_ = _e216.member[1];
                }
                let _e234 = phi_366_;
                if (_e181.member[2] < _e216.member[2]) {
                    phi_373_ = _e181.member[2];
                } else {
                    phi_373_ = _e216.member[2];
                }
                let _e239 = phi_373_;
                if (_e181.member_1[0] > _e216.member_1[0]) {
                    phi_381_ = _e181.member_1[0];
                } else {
                    phi_381_ = _e216.member_1[0];
                }
                let _e245 = phi_381_;
                if (_e181.member_1[1] > _e216.member_1[1]) {
                    phi_388_ = _e181.member_1[1];
                } else {
                    phi_388_ = _e216.member_1[1];
                }
                let _e250 = phi_388_;
                if (_e181.member_1[2] > _e216.member_1[2]) {
                    phi_395_ = _e181.member_1[2];
                } else {
                    phi_395_ = _e216.member_1[2];
                }
                let _e255 = phi_395_;
                shared_[_e31] = type_30(array<f32, 3>(_e229, _e234, _e239), array<f32, 3>(_e245, _e250, _e255));
                phi_410_ = type_30(array<f32, 3>(_e229, _e234, _e239), array<f32, 3>(_e245, _e250, _e255));
            } else {
                phi_410_ = _e181;
            }
            let _e263 = phi_410_;
            phi_285_ = _e263;
            phi_287_ = (_e183 / 2u);
        } else {
            phi_285_ = type_30();
            phi_287_ = u32();
        }
        let _e266 = phi_285_;
        let _e268 = phi_287_;
        continue;
        continuing {
            phi_281_ = _e206;
            phi_284_ = _e266;
            phi_286_ = _e268;
            break if !(_e211);
        }
    }
    if _e70 {
        nodes.member[_e45] = type_26(vec2<f32>(_e165.member[0], _e165.member[1]), vec2<f32>(_e165.member[2], _e165.member_1[0]), vec2<f32>(_e165.member_1[1], _e165.member_1[2]));
        leaves.member[_e45] = vec4<u32>(_e163.member[0], _e163.member[1], _e163.member[2], _e163.member_1);
        if ((_e31 % 32u) == 0u) {
            let _e303 = params.member.member_2.member[1u][_e58];
            let _e306 = local;
            let _e310 = local_1;
            let _e314 = local_2;
            let _e318 = local_3;
            let _e322 = local_4;
            let _e326 = local_5;
            nodes.member[(_e303 + (_e64 / 32u))] = type_26(vec2<f32>(_e306.member[0], _e310.member[1]), vec2<f32>(_e314.member[2], _e318.member_1[0]), vec2<f32>(_e322.member_1[1], _e326.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
