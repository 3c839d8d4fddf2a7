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

struct type_12 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_14 {
    member: array<type_12>,
}

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> boxes: type_14;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(3) 
var<storage, read_write> sorted: type_14;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e9 = id_2;
    let _e10 = n_2;
    let _e11 = lane_2;
    let _e22 = ((((_e9.y * _e10.x) + _e9.x) * 256u) + _e11);
    let _e26 = params.member.member.member_2[3u];
    if (_e22 < _e26) {
        let _e29 = order.member[_e22];
        let _e31 = boxes.member[_e29];
        sorted.member[_e22] = _e31;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
