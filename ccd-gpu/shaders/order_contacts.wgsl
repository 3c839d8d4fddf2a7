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
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_81_: u32;
    var phi_86_: u32;
    var phi_105_: type_13;
    var phi_106_: type_13;
    var phi_129_: type_13;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e15 = id_2;
    let _e16 = n_2;
    let _e17 = lane_2;
    let _e28 = ((((_e15.y * _e16.x) + _e15.x) * 256u) + _e17);
    let _e30 = params.member.member_17;
    let _e32 = params.member.member_15;
    let _e34 = contacts.member[0u];
    if (_e32 < _e34) {
        phi_81_ = _e32;
    } else {
        phi_81_ = _e34;
    }
    let _e37 = phi_81_;
    if (_e37 < _e30) {
        phi_86_ = _e37;
    } else {
        phi_86_ = _e30;
    }
    let _e40 = phi_86_;
    if (_e28 < _e40) {
        let _e43 = order.member[_e28];
        phi_105_ = type_13(0u, 6u);
        loop {
            let _e47 = phi_105_;
            if (_e47.member < _e47.member_1) {
                phi_106_ = type_13((_e47.member + 1u), _e47.member_1);
                phi_129_ = type_13(1u, _e47.member);
            } else {
                phi_106_ = _e47;
                phi_129_ = type_13(0u, type_13().member_1);
            }
            let _e59 = phi_106_;
            let _e61 = phi_129_;
            let _e65 = (bitcast<i32>(_e61.member) != 0i);
            if _e65 {
                let _e70 = contacts.member[((4u + (6u * _e43)) + _e61.member_1)];
                ordered.member[((6u * _e28) + _e61.member_1)] = _e70;
            }
            continue;
            continuing {
                phi_105_ = _e59;
                break if !(_e65);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
