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
var<storage> elements: type_10;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_14;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_137_: array<u32, 3>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e10 = id_2;
    let _e11 = n_2;
    let _e12 = lane_2;
    let _e22 = ((((_e10.y * _e11.x) + _e10.x) * 256u) + _e12);
    let _e25 = params.member.member.member;
    if (_e22 < (_e25[1] + _e25[2])) {
        if (_e22 < _e25[1]) {
            let _e44 = (2u * _e22);
            let _e46 = elements.member[_e44];
            let _e49 = elements.member[(_e44 + 1u)];
            phi_137_ = array<u32, 3>(_e46, _e49, _e49);
        } else {
            let _e34 = ((2u * _e25[1]) + (3u * (_e22 - _e25[1])));
            let _e36 = elements.member[_e34];
            let _e39 = elements.member[(_e34 + 1u)];
            let _e42 = elements.member[(_e34 + 2u)];
            phi_137_ = array<u32, 3>(_e36, _e39, _e42);
        }
        let _e52 = phi_137_;
        let _e56 = params.member.member.member_2[1u];
        let _e62 = boxes.member[_e52[0]];
        let _e64 = boxes.member[_e52[1]];
        let _e70 = select(_e64.member[0], _e62.member[0], (_e62.member[0] < _e64.member[0]));
        let _e76 = select(_e64.member[1], _e62.member[1], (_e62.member[1] < _e64.member[1]));
        let _e82 = select(_e64.member[2], _e62.member[2], (_e62.member[2] < _e64.member[2]));
        let _e88 = select(_e64.member_1[0], _e62.member_1[0], (_e62.member_1[0] > _e64.member_1[0]));
        let _e94 = select(_e64.member_1[1], _e62.member_1[1], (_e62.member_1[1] > _e64.member_1[1]));
        let _e100 = select(_e64.member_1[2], _e62.member_1[2], (_e62.member_1[2] > _e64.member_1[2]));
        let _e102 = boxes.member[_e52[2]];
        boxes.member[(_e56 + _e22)] = type_12(array<f32, 3>(select(_e102.member[0], _e70, (_e70 < _e102.member[0])), select(_e102.member[1], _e76, (_e76 < _e102.member[1])), select(_e102.member[2], _e82, (_e82 < _e102.member[2]))), array<f32, 3>(select(_e102.member_1[0], _e88, (_e88 > _e102.member_1[0])), select(_e102.member_1[1], _e94, (_e94 > _e102.member_1[1])), select(_e102.member_1[2], _e100, (_e100 > _e102.member_1[2]))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_elements(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
