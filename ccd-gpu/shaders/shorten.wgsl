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

@group(0) @binding(1) 
var<storage> paths: type_14;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(2) 
var<storage> of_vf: type_10;
@group(0) @binding(3) 
var<storage> of_ee: type_10;
@group(0) @binding(4) 
var<storage, read_write> shortened: type_14;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_109_: u32;
    var phi_115_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e13 = id_2;
    let _e14 = n_2;
    let _e15 = lane_2;
    let _e27 = ((((_e13.y * _e14.x) + _e13.x) * 256u) + _e15);
    let _e31 = params.member.member.member[0u];
    if (_e27 < _e31) {
        let _e34 = paths.member[_e27];
        let _e36 = of_vf.member[0u];
        let _e38 = of_ee.member[0u];
        if (_e38 < _e36) {
            phi_109_ = _e38;
        } else {
            phi_109_ = _e36;
        }
        let _e41 = phi_109_;
        if (_e41 < 1065353216u) {
            phi_115_ = bitcast<f32>(_e41);
        } else {
            phi_115_ = 1f;
        }
        let _e45 = phi_115_;
        shortened.member[_e27] = type_12(_e34.member, array<f32, 4>((_e34.member[0] + ((_e34.member_1[0] - _e34.member[0]) * _e45)), (_e34.member[1] + ((_e34.member_1[1] - _e34.member[1]) * _e45)), (_e34.member[2] + ((_e34.member_1[2] - _e34.member[2]) * _e45)), 0f));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn shorten(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
