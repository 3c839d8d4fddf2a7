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

struct type_11 {
    member: u32,
}

struct type_12 {
    member: type_7,
    member_1: type_8,
    member_2: type_11,
}

struct type_13 {
    member: type_12,
}

@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> contacts: type_10;
@group(0) @binding(2) 
var<storage, read_write> keys: type_10;
@group(0) @binding(3) 
var<storage, read_write> order: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_87_: u32;
    var phi_105_: u32;
    var phi_155_: u32;
    var phi_156_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e13 = id_2;
    let _e14 = n_2;
    let _e15 = lane_2;
    let _e26 = ((((_e13.y * _e14.x) + _e13.x) * 256u) + _e15);
    let _e29 = params.member.member_1.member;
    if (_e26 < _e29) {
        let _e33 = params.member.member_2.member;
        if (_e33 == 0u) {
            order.member[_e26] = _e26;
            phi_87_ = _e26;
        } else {
            let _e36 = order.member[_e26];
            phi_87_ = _e36;
        }
        let _e39 = phi_87_;
        let _e41 = contacts.member[0u];
        let _e44 = params.member.member_1.member_2;
        if (_e44 < _e41) {
            phi_105_ = _e44;
        } else {
            phi_105_ = _e41;
        }
        let _e47 = phi_105_;
        if (_e39 >= _e47) {
            phi_156_ = 4294967295u;
        } else {
            let _e49 = (7u * _e39);
            let _e53 = params.member.member_2.member;
            if (_e53 == 0u) {
                let _e68 = contacts.member[(_e49 + 7u)];
                phi_155_ = _e68;
            } else {
                let _e56 = contacts.member[(4u + _e49)];
                let _e60 = params.member.member.member[0u];
                let _e64 = contacts.member[(_e49 + 6u)];
                phi_155_ = ((_e56 * _e60) + _e64);
            }
            let _e70 = phi_155_;
            phi_156_ = _e70;
        }
        let _e72 = phi_156_;
        keys.member[_e26] = _e72;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn contact_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
