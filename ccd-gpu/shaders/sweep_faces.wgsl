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

struct type_17 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_12;
@group(0) @binding(1) 
var<storage> faces: type_17;

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
    let _e24 = params.member.member.member[2u];
    if (_e20 < _e24) {
        let _e27 = faces.member[_e20];
        let _e32 = boxes.member[_e27[0]];
        let _e34 = boxes.member[_e27[1]];
        let _e40 = select(_e34.member[0], _e32.member[0], (_e32.member[0] < _e34.member[0]));
        let _e46 = select(_e34.member[1], _e32.member[1], (_e32.member[1] < _e34.member[1]));
        let _e52 = select(_e34.member[2], _e32.member[2], (_e32.member[2] < _e34.member[2]));
        let _e58 = select(_e34.member_1[0], _e32.member_1[0], (_e32.member_1[0] > _e34.member_1[0]));
        let _e64 = select(_e34.member_1[1], _e32.member_1[1], (_e32.member_1[1] > _e34.member_1[1]));
        let _e70 = select(_e34.member_1[2], _e32.member_1[2], (_e32.member_1[2] > _e34.member_1[2]));
        let _e72 = boxes.member[_e27[2]];
        let _e103 = params.member.member.member_2[2u];
        boxes.member[(_e103 + _e20)] = type_10(array<f32, 3>(select(_e72.member[0], _e40, (_e40 < _e72.member[0])), select(_e72.member[1], _e46, (_e46 < _e72.member[1])), select(_e72.member[2], _e52, (_e52 < _e72.member[2]))), array<f32, 3>(select(_e72.member_1[0], _e58, (_e58 > _e72.member_1[0])), select(_e72.member_1[1], _e64, (_e64 > _e72.member_1[1])), select(_e72.member_1[2], _e70, (_e70 > _e72.member_1[2]))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_faces(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
