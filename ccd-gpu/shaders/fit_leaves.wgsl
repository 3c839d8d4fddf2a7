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
    member: array<type_19>,
}

struct type_23 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> boxes: type_27;
@group(0) @binding(2) 
var<storage> order: type_10;
var<workgroup> shared_: array<type_25, 256>;
@group(0) @binding(3) 
var<storage> edges: type_23;
@group(0) @binding(4) 
var<storage> faces: type_30;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_27;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_21;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_132_: u32;
    var phi_133_: u32;
    var phi_247_: type_19;
    var phi_248_: type_19;
    var phi_249_: type_19;
    var phi_250_: type_25;
    var phi_251_: type_19;
    var phi_252_: type_25;
    var phi_253_: type_19;
    var phi_268_: type_13;
    var phi_271_: type_25;
    var phi_273_: u32;
    var phi_294_: bool;
    var phi_300_: type_14;
    var phi_269_: type_13;
    var phi_314_: type_14;
    var phi_346_: f32;
    var phi_353_: f32;
    var phi_360_: f32;
    var phi_368_: f32;
    var phi_375_: f32;
    var phi_382_: f32;
    var phi_397_: type_25;
    var phi_272_: type_25;
    var phi_274_: u32;
    var local: type_25;
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
        phi_133_ = 2u;
    } else {
        let _e53 = params.member.member_2.member[0u][1u];
        if (_e45 >= _e53) {
            phi_132_ = 1u;
        } else {
            phi_132_ = 0u;
        }
        let _e56 = phi_132_;
        phi_133_ = _e56;
    }
    let _e58 = phi_133_;
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
            let _e88 = params.member.member.member_2[_e58];
            let _e89 = (_e82 - _e88);
            let _e90 = type_19(array<u32, 3>(0u, 0u, 0u), _e89);
            let _e96 = type_19(array<u32, 3>(_e89, _e90.member[1], _e90.member[2]), _e90.member_1);
            let _e105 = type_19(array<u32, 3>(_e89, _e89, _e89), type_19(array<u32, 3>(_e96.member[0], _e89, _e96.member[2]), _e96.member_1).member_1);
            let _e108 = params.member.member.member_1;
            if ((_e108 & 1u) != 0u) {
                if (_e58 == 1u) {
                    let _e120 = edges.member[_e89];
                    let _e129 = type_19(array<u32, 3>(_e120[0], _e105.member[1], _e105.member[2]), _e105.member_1);
                    phi_248_ = type_19(array<u32, 3>(_e120[0], _e120[1], _e120[1]), type_19(array<u32, 3>(_e129.member[0], _e120[1], _e129.member[2]), _e129.member_1).member_1);
                } else {
                    if (_e58 == 2u) {
                        let _e114 = faces.member[_e89];
                        phi_247_ = type_19(_e114, _e105.member_1);
                    } else {
                        phi_247_ = _e105;
                    }
                    let _e118 = phi_247_;
                    phi_248_ = _e118;
                }
                let _e140 = phi_248_;
                phi_249_ = _e140;
            } else {
                phi_249_ = _e105;
            }
            let _e142 = phi_249_;
            phi_250_ = _e84;
            phi_251_ = _e142;
        } else {
            phi_250_ = type_25(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_251_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e144 = phi_250_;
        let _e146 = phi_251_;
        phi_252_ = _e144;
        phi_253_ = _e146;
    } else {
        phi_252_ = type_25(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_253_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
    }
    let _e148 = phi_252_;
    let _e150 = phi_253_;
    shared_[_e31] = type_25(array<f32, 3>(_e148.member[0], _e148.member[1], _e148.member[2]), array<f32, 3>(_e148.member_1[0], _e148.member_1[1], _e148.member_1[2]));
    phi_268_ = type_13(0i, 5i);
    phi_271_ = _e148;
    phi_273_ = 16u;
    loop {
        let _e164 = phi_268_;
        let _e166 = phi_271_;
        let _e168 = phi_273_;
        local = _e166;
        if (_e164.member < _e164.member_1) {
            let _e175 = (_e164.member + 1i);
            if ((false == (_e175 > _e164.member)) != false) {
                phi_294_ = true;
            } else {
                phi_294_ = false;
            }
            let _e180 = phi_294_;
            if _e180 {
                phi_300_ = type_14(0u, type_14().member_1);
            } else {
                phi_300_ = type_14(1u, _e175);
            }
            let _e185 = phi_300_;
            phi_269_ = type_13(_e185.member_1, _e164.member_1);
            phi_314_ = type_14(1u, _e164.member);
        } else {
            phi_269_ = _e164;
            phi_314_ = type_14(0u, type_14().member_1);
        }
        let _e191 = phi_269_;
        let _e193 = phi_314_;
        let _e196 = (bitcast<i32>(_e193.member) != 0i);
        if _e196 {
            workgroupBarrier();
            if ((_e31 % 32u) < _e168) {
                let _e201 = shared_[(_e31 + _e168)];
                if (_e166.member[0] < _e201.member[0]) {
                    phi_346_ = _e166.member[0];
                } else {
                    phi_346_ = _e201.member[0];
                }
                let _e214 = phi_346_;
                if (_e166.member[1] < _e201.member[1]) {
                    phi_353_ = _e166.member[1];
                } else {
                    phi_353_ = _e201.member[1];
                }
                let _e219 = phi_353_;
                if (_e166.member[2] < _e201.member[2]) {
                    phi_360_ = _e166.member[2];
                } else {
                    phi_360_ = _e201.member[2];
                }
                let _e224 = phi_360_;
                if (_e166.member_1[0] > _e201.member_1[0]) {
                    phi_368_ = _e166.member_1[0];
                } else {
                    phi_368_ = _e201.member_1[0];
                }
                let _e230 = phi_368_;
                if (_e166.member_1[1] > _e201.member_1[1]) {
                    phi_375_ = _e166.member_1[1];
                } else {
                    phi_375_ = _e201.member_1[1];
                }
                let _e235 = phi_375_;
                if (_e166.member_1[2] > _e201.member_1[2]) {
                    phi_382_ = _e166.member_1[2];
                } else {
                    phi_382_ = _e201.member_1[2];
                }
                let _e240 = phi_382_;
                shared_[_e31] = type_25(array<f32, 3>(_e214, _e219, _e224), array<f32, 3>(_e230, _e235, _e240));
                phi_397_ = type_25(array<f32, 3>(_e214, _e219, _e224), array<f32, 3>(_e230, _e235, _e240));
            } else {
                phi_397_ = _e166;
            }
            let _e248 = phi_397_;
            phi_272_ = _e248;
            phi_274_ = (_e168 / 2u);
        } else {
            phi_272_ = type_25();
            phi_274_ = u32();
        }
        let _e251 = phi_272_;
        let _e253 = phi_274_;
        continue;
        continuing {
            phi_268_ = _e191;
            phi_271_ = _e251;
            phi_273_ = _e253;
            break if !(_e196);
        }
    }
    if _e70 {
        nodes.member[_e45] = _e148;
        leaves.member[_e45] = _e150;
        if ((_e31 % 32u) == 0u) {
            let _e264 = params.member.member_2.member[1u][_e58];
            let _e268 = local;
            nodes.member[(_e264 + (_e64 / 32u))] = _e268;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
