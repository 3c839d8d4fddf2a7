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

struct type_13 {
    member: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_83_: u32;
    var phi_88_: u32;
    var phi_107_: type_9;
    var phi_108_: type_9;
    var phi_131_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e15 = id_2;
    let _e16 = n_2;
    let _e17 = lane_2;
    let _e28 = ((((_e15.y * _e16.x) + _e15.x) * 256u) + _e17);
    let _e31 = params.member.member_1.member;
    let _e34 = params.member.member_1.member_2;
    let _e36 = contacts.member[0u];
    if (_e34 < _e36) {
        phi_83_ = _e34;
    } else {
        phi_83_ = _e36;
    }
    let _e39 = phi_83_;
    if (_e39 < _e31) {
        phi_88_ = _e39;
    } else {
        phi_88_ = _e31;
    }
    let _e42 = phi_88_;
    if (_e28 < _e42) {
        let _e45 = order.member[_e28];
        phi_107_ = type_9(0u, 7u);
        loop {
            let _e49 = phi_107_;
            if (_e49.member < _e49.member_1) {
                phi_108_ = type_9((_e49.member + 1u), _e49.member_1);
                phi_131_ = type_9(1u, _e49.member);
            } else {
                phi_108_ = _e49;
                phi_131_ = type_9(0u, type_9().member_1);
            }
            let _e61 = phi_108_;
            let _e63 = phi_131_;
            let _e67 = (bitcast<i32>(_e63.member) != 0i);
            if _e67 {
                let _e72 = contacts.member[((4u + (7u * _e45)) + _e63.member_1)];
                ordered.member[((7u * _e28) + _e63.member_1)] = _e72;
            }
            continue;
            continuing {
                phi_107_ = _e61;
                break if !(_e67);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
