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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
    member: array<type_10>,
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

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 3>,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_18;
@group(0) @binding(2) 
var<storage> boxes: type_12;
@group(0) @binding(3) 
var<storage, read_write> swept: type_12;

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
    let _e21 = ((((_e8.y * _e9.x) + _e8.x) * 256u) + _e10);
    let _e24 = params.member.member_1.member;
    if (_e21 < _e24) {
        let _e27 = triangles.member[_e21];
        let _e33 = boxes.member[_e27.member[0]];
        let _e35 = boxes.member[_e27.member[1]];
        let _e41 = select(_e35.member[0], _e33.member[0], (_e33.member[0] < _e35.member[0]));
        let _e47 = select(_e35.member[1], _e33.member[1], (_e33.member[1] < _e35.member[1]));
        let _e53 = select(_e35.member[2], _e33.member[2], (_e33.member[2] < _e35.member[2]));
        let _e59 = select(_e35.member_1[0], _e33.member_1[0], (_e33.member_1[0] > _e35.member_1[0]));
        let _e65 = select(_e35.member_1[1], _e33.member_1[1], (_e33.member_1[1] > _e35.member_1[1]));
        let _e71 = select(_e35.member_1[2], _e33.member_1[2], (_e33.member_1[2] > _e35.member_1[2]));
        let _e73 = boxes.member[_e27.member[2]];
        swept.member[_e21] = type_10(array<f32, 3>(select(_e73.member[0], _e41, (_e41 < _e73.member[0])), select(_e73.member[1], _e47, (_e47 < _e73.member[1])), select(_e73.member[2], _e53, (_e53 < _e73.member[2]))), array<f32, 3>(select(_e73.member_1[0], _e59, (_e59 > _e73.member_1[0])), select(_e73.member_1[1], _e65, (_e65 > _e73.member_1[1])), select(_e73.member_1[2], _e71, (_e71 > _e73.member_1[2]))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_triangles(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
