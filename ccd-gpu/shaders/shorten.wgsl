struct type_10 {
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

struct type_12 {
    member: type_10,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_24 {
    member: array<type_21>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> paths: type_24;
@group(0) @binding(2) 
var<storage> of_vf: type_16;
@group(0) @binding(3) 
var<storage> of_ee: type_16;
@group(0) @binding(4) 
var<storage, read_write> out: type_24;

fn function_() {
    var phi_108_: u32;
    var phi_114_: f32;

    let _e17 = id_1;
    let _e18 = n_1;
    let _e19 = lane_1;
    let _e31 = ((((_e17.y * _e18.x) + _e17.x) * 256u) + _e19);
    let _e34 = params.member.member[0u];
    if (_e31 < _e34) {
        let _e37 = paths.member[_e31];
        let _e39 = of_vf.member[0u];
        let _e41 = of_ee.member[0u];
        if (_e41 < _e39) {
            phi_108_ = _e41;
        } else {
            phi_108_ = _e39;
        }
        let _e44 = phi_108_;
        if (_e44 < 1065353216u) {
            phi_114_ = bitcast<f32>(_e44);
        } else {
            phi_114_ = 1f;
        }
        let _e48 = phi_114_;
        out.member[_e31] = type_21(_e37.member, array<f32, 4>((_e37.member[0] + ((_e37.member_1[0] - _e37.member[0]) * _e48)), (_e37.member[1] + ((_e37.member_1[1] - _e37.member[1]) * _e48)), (_e37.member[2] + ((_e37.member_1[2] - _e37.member[2]) * _e48)), 0f));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn shorten(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
