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
    member: array<array<u32, 2>>,
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
var<storage> edges: type_10;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_14;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e8 = id_2;
    let _e9 = n_2;
    let _e10 = lane_2;
    let _e20 = ((((_e8.y * _e9.x) + _e8.x) * 256u) + _e10);
    let _e24 = params.member.member.member[1u];
    if (_e20 < _e24) {
        let _e27 = edges.member[_e20];
        let _e31 = boxes.member[_e27[0]];
        let _e33 = boxes.member[_e27[1]];
        let _e76 = params.member.member.member_2[1u];
        boxes.member[(_e76 + _e20)] = type_12(array<f32, 3>(select(_e33.member[0], _e31.member[0], (_e31.member[0] < _e33.member[0])), select(_e33.member[1], _e31.member[1], (_e31.member[1] < _e33.member[1])), select(_e33.member[2], _e31.member[2], (_e31.member[2] < _e33.member[2]))), array<f32, 3>(select(_e33.member_1[0], _e31.member_1[0], (_e31.member_1[0] > _e33.member_1[0])), select(_e33.member_1[1], _e31.member_1[1], (_e31.member_1[1] > _e33.member_1[1])), select(_e33.member_1[2], _e31.member_1[2], (_e31.member_1[2] > _e33.member_1[2]))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_edges(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
