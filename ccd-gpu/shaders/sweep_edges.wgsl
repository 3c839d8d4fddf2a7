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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<array<u32, 2>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> edges: type_15;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_107_: f32;
    var phi_114_: f32;
    var phi_121_: f32;
    var phi_129_: f32;
    var phi_136_: f32;
    var phi_143_: f32;
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
    let _e23 = params.member.member[1u];
    if (_e20 < _e23) {
        let _e26 = edges.member[_e20];
        let _e30 = boxes.member[_e26[0]];
        let _e32 = boxes.member[_e26[1]];
        if (_e30.member[0] < _e32.member[0]) {
            phi_107_ = _e30.member[0];
        } else {
            phi_107_ = _e32.member[0];
        }
        let _e39 = phi_107_;
        if (_e30.member[1] < _e32.member[1]) {
            phi_114_ = _e30.member[1];
        } else {
            phi_114_ = _e32.member[1];
        }
        let _e46 = phi_114_;
        if (_e30.member[2] < _e32.member[2]) {
            phi_121_ = _e30.member[2];
        } else {
            phi_121_ = _e32.member[2];
        }
        let _e53 = phi_121_;
        if (_e30.member_1[0] > _e32.member_1[0]) {
            phi_129_ = _e30.member_1[0];
        } else {
            phi_129_ = _e32.member_1[0];
        }
        let _e61 = phi_129_;
        if (_e30.member_1[1] > _e32.member_1[1]) {
            phi_136_ = _e30.member_1[1];
        } else {
            phi_136_ = _e32.member_1[1];
        }
        let _e68 = phi_136_;
        if (_e30.member_1[2] > _e32.member_1[2]) {
            phi_143_ = _e30.member_1[2];
        } else {
            phi_143_ = _e32.member_1[2];
        }
        let _e75 = phi_143_;
        let _e80 = params.member.member_2[1u];
        boxes.member[(_e80 + _e20)] = type_11(array<f32, 3>(_e39, _e46, _e53), array<f32, 3>(_e61, _e68, _e75));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_edges(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
