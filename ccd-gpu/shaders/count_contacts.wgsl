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

struct type_16 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage, read_write> table: type_16;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> contacts: type_10;
@group(0) @binding(3) 
var<storage, read_write> ranks: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_80_: u32;
    var phi_85_: u32;
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
    let _e32 = params.member.member_1.member_2;
    let _e34 = contacts.member[0u];
    if (_e32 < _e34) {
        phi_80_ = _e32;
    } else {
        phi_80_ = _e34;
    }
    let _e37 = phi_80_;
    if (_e37 < _e29) {
        phi_85_ = _e37;
    } else {
        phi_85_ = _e29;
    }
    let _e40 = phi_85_;
    if (_e26 < _e40) {
        let _e43 = (7u * _e26);
        let _e46 = contacts.member[(4u + _e43)];
        let _e49 = params.member.member.member[0u];
        let _e53 = contacts.member[(_e43 + 6u)];
        let _e56 = atomicAdd((&table.member[((_e46 * _e49) + _e53)]), 1u);
        ranks.member[_e26] = _e56;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn count_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
