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

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage, read_write> keys: type_11;
@group(0) @binding(3) 
var<storage, read_write> order: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_84_: u32;
    var phi_101_: u32;
    var phi_150_: u32;
    var phi_151_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e13 = id_2;
    let _e14 = n_2;
    let _e15 = lane_2;
    let _e26 = ((((_e13.y * _e14.x) + _e13.x) * 256u) + _e15);
    let _e28 = params.member.member_17;
    if (_e26 < _e28) {
        let _e31 = params.member.member_9;
        if (_e31 == 0u) {
            order.member[_e26] = _e26;
            phi_84_ = _e26;
        } else {
            let _e34 = order.member[_e26];
            phi_84_ = _e34;
        }
        let _e37 = phi_84_;
        let _e39 = contacts.member[0u];
        let _e41 = params.member.member_15;
        if (_e41 < _e39) {
            phi_101_ = _e41;
        } else {
            phi_101_ = _e39;
        }
        let _e44 = phi_101_;
        if (_e37 >= _e44) {
            phi_151_ = 4294967295u;
        } else {
            let _e46 = (6u * _e37);
            let _e49 = params.member.member_9;
            if (_e49 == 0u) {
                let _e63 = contacts.member[(_e46 + 7u)];
                phi_150_ = _e63;
            } else {
                let _e52 = contacts.member[(4u + _e46)];
                let _e55 = params.member.member[0u];
                let _e59 = contacts.member[(_e46 + 6u)];
                phi_150_ = ((_e52 * _e55) + _e59);
            }
            let _e65 = phi_150_;
            phi_151_ = _e65;
        }
        let _e67 = phi_151_;
        keys.member[_e26] = _e67;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn contact_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
