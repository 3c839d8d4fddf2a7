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
    let _e36 = select(_e34, _e32, (_e32 < _e34));
    if (_e26 < select(_e29, _e36, (_e36 < _e29))) {
        let _e41 = (7u * _e26);
        let _e44 = contacts.member[(4u + _e41)];
        let _e47 = params.member.member.member[0u];
        let _e51 = contacts.member[(_e41 + 6u)];
        let _e54 = atomicAdd((&table.member[((_e44 * _e47) + _e51)]), 1u);
        ranks.member[_e26] = _e54;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn count_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
