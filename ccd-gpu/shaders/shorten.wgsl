struct type_9 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_9,
}

struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_20>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(2) 
var<storage> time: type_15;
@group(0) @binding(3) 
var<storage, read_write> out: type_23;

fn function_() {
    var phi_95_: f32;

    let _e16 = id_1;
    let _e17 = n_1;
    let _e18 = lane_1;
    let _e29 = ((((_e16.y * _e17.x) + _e16.x) * 256u) + _e18);
    let _e32 = params.member.member[0u];
    if (_e29 < _e32) {
        let _e35 = paths.member[_e29];
        let _e37 = time.member[0u];
        if (_e37 < 1065353216u) {
            phi_95_ = bitcast<f32>(_e37);
        } else {
            phi_95_ = 1f;
        }
        let _e41 = phi_95_;
        out.member[_e29] = type_20(_e35.member, array<f32, 4>((_e35.member[0] + ((_e35.member_1[0] - _e35.member[0]) * _e41)), (_e35.member[1] + ((_e35.member_1[1] - _e35.member[1]) * _e41)), (_e35.member[2] + ((_e35.member_1[2] - _e35.member[2]) * _e41)), 0f));
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
