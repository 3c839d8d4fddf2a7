struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_23 {
    member: array<array<u32, 3>>,
}

struct type_31 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_19;
@group(0) @binding(1) 
var<storage> faces: type_23;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_6;
    var phi_139_: type_31;
    var phi_140_: type_31;
    var phi_163_: type_31;
    var phi_189_: f32;
    var phi_216_: f32;
    var phi_270_: type_31;
    var phi_271_: type_31;
    var phi_294_: type_31;
    var phi_320_: f32;
    var phi_347_: f32;

    let _e20 = id_1;
    let _e21 = n_1;
    let _e22 = lane_1;
    let _e32 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e35 = params.member.member[2u];
    if (_e32 < _e35) {
        let _e38 = faces.member[_e32];
        let _e43 = boxes.member[_e38[0]];
        let _e45 = boxes.member[_e38[1]];
        local_2 = type_6(array<f32, 3>(_e45.member[0], _e45.member[1], _e45.member[2]), array<f32, 3>(_e45.member_1[0], _e45.member_1[1], _e45.member_1[2]));
        local_1 = type_6(array<f32, 3>(_e43.member[0], _e43.member[1], _e43.member[2]), array<f32, 3>(_e43.member_1[0], _e43.member_1[1], _e43.member_1[2]));
        phi_139_ = type_31(0u, 3u);
        loop {
            let _e69 = phi_139_;
            if (_e69.member < _e69.member_1) {
                phi_140_ = type_31((_e69.member + 1u), _e69.member_1);
                phi_163_ = type_31(1u, _e69.member);
            } else {
                phi_140_ = _e69;
                phi_163_ = type_31(0u, type_31().member_1);
            }
            let _e83 = phi_140_;
            let _e85 = phi_163_;
            let _e89 = (bitcast<i32>(_e85.member) != 0i);
            if _e89 {
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                let _e93 = local_1.member[_e85.member_1];
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                let _e97 = local_2.member[_e85.member_1];
                if (_e93 < _e97) {
                    phi_189_ = _e93;
                } else {
                    phi_189_ = _e97;
                }
                let _e100 = phi_189_;
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                local_1.member[_e85.member_1] = _e100;
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                let _e107 = local_1.member_1[_e85.member_1];
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                let _e111 = local_2.member_1[_e85.member_1];
                if (_e107 > _e111) {
                    phi_216_ = _e107;
                } else {
                    phi_216_ = _e111;
                }
                let _e114 = phi_216_;
                if (_e85.member_1 < 3u) {
                } else {
                    return;
                }
                local_1.member_1[_e85.member_1] = _e114;
            }
            continue;
            continuing {
                phi_139_ = _e83;
                break if !(_e89);
            }
        }
        let _e119 = local_1;
        let _e121 = boxes.member[_e38[2]];
        local_3 = type_6(array<f32, 3>(_e121.member[0], _e121.member[1], _e121.member[2]), array<f32, 3>(_e121.member_1[0], _e121.member_1[1], _e121.member_1[2]));
        local = _e119;
        phi_270_ = type_31(0u, 3u);
        loop {
            let _e134 = phi_270_;
            if (_e134.member < _e134.member_1) {
                phi_271_ = type_31((_e134.member + 1u), _e134.member_1);
                phi_294_ = type_31(1u, _e134.member);
            } else {
                phi_271_ = _e134;
                phi_294_ = type_31(0u, type_31().member_1);
            }
            let _e148 = phi_271_;
            let _e150 = phi_294_;
            let _e154 = (bitcast<i32>(_e150.member) != 0i);
            if _e154 {
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                let _e158 = local.member[_e150.member_1];
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                let _e162 = local_3.member[_e150.member_1];
                if (_e158 < _e162) {
                    phi_320_ = _e158;
                } else {
                    phi_320_ = _e162;
                }
                let _e165 = phi_320_;
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                local.member[_e150.member_1] = _e165;
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                let _e172 = local.member_1[_e150.member_1];
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                let _e176 = local_3.member_1[_e150.member_1];
                if (_e172 > _e176) {
                    phi_347_ = _e172;
                } else {
                    phi_347_ = _e176;
                }
                let _e179 = phi_347_;
                if (_e150.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e150.member_1] = _e179;
            }
            continue;
            continuing {
                phi_270_ = _e148;
                break if !(_e154);
            }
        }
        let _e184 = local;
        let _e198 = params.member.member_2[2u];
        boxes.member[(_e198 + _e32)] = type_6(array<f32, 3>(_e184.member[0], _e184.member[1], _e184.member[2]), array<f32, 3>(_e184.member_1[0], _e184.member_1[1], _e184.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_faces(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
