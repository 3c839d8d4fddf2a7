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
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_14 {
    member: array<type_12>,
}

struct type_16 {
    member: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

@group(0) @binding(1) 
var<storage> paths: type_14;
@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> earliest: type_10;
@group(0) @binding(3) 
var<storage, read_write> shortened: type_14;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_100_: f32;
    var phi_136_: array<f32, 3>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e12 = id_2;
    let _e13 = n_2;
    let _e14 = lane_2;
    let _e25 = ((((_e12.y * _e13.x) + _e12.x) * 256u) + _e14);
    let _e29 = params.member.member.member[0u];
    if (_e25 < _e29) {
        let _e32 = earliest.member[0u];
        let _e35 = select(1f, bitcast<f32>(_e32), (_e32 < 1065353216u));
        let _e38 = params.member.member.member_13;
        if (_e35 < _e38) {
            phi_100_ = _e35;
        } else {
            let _e42 = params.member.member.member_13;
            phi_100_ = _e42;
        }
        let _e44 = phi_100_;
        let _e46 = paths.member[_e25];
        let _e49 = params.member.member.member_12;
        if (_e49 > 0f) {
            phi_136_ = array<f32, 3>((_e46.member[0] + ((_e46.member_1[0] - _e46.member[0]) * _e49)), (_e46.member[1] + ((_e46.member_1[1] - _e46.member[1]) * _e49)), (_e46.member[2] + ((_e46.member_1[2] - _e46.member[2]) * _e49)));
        } else {
            phi_136_ = array<f32, 3>(_e46.member[0], _e46.member[1], _e46.member[2]);
        }
        let _e71 = phi_136_;
        shortened.member[_e25] = type_12(array<f32, 4>(_e71[0], _e71[1], _e71[2], 0f), array<f32, 4>((_e46.member[0] + ((_e46.member_1[0] - _e46.member[0]) * _e44)), (_e46.member[1] + ((_e46.member_1[1] - _e46.member[1]) * _e44)), (_e46.member[2] + ((_e46.member_1[2] - _e46.member[2]) * _e44)), 0f));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn shorten(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
