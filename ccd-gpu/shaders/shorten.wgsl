struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<u32>,
}

struct type_13 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_15 {
    member: array<type_13>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_15;
@group(0) @binding(2) 
var<storage> of_vf: type_11;
@group(0) @binding(3) 
var<storage> of_ee: type_11;
@group(0) @binding(4) 
var<storage, read_write> out: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_108_: u32;
    var phi_114_: f32;
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
    let _e30 = params.member.member[0u];
    if (_e27 < _e30) {
        let _e33 = paths.member[_e27];
        let _e35 = of_vf.member[0u];
        let _e37 = of_ee.member[0u];
        if (_e37 < _e35) {
            phi_108_ = _e37;
        } else {
            phi_108_ = _e35;
        }
        let _e40 = phi_108_;
        if (_e40 < 1065353216u) {
            phi_114_ = bitcast<f32>(_e40);
        } else {
            phi_114_ = 1f;
        }
        let _e44 = phi_114_;
        out.member[_e27] = type_13(_e33.member, array<f32, 4>((_e33.member[0] + ((_e33.member_1[0] - _e33.member[0]) * _e44)), (_e33.member[1] + ((_e33.member_1[1] - _e33.member[1]) * _e44)), (_e33.member[2] + ((_e33.member_1[2] - _e33.member[2]) * _e44)), 0f));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn shorten(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
