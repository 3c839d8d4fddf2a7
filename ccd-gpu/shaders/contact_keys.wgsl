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

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> contacts: type_16;
@group(0) @binding(2) 
var<storage, read_write> keys: type_16;
@group(0) @binding(3) 
var<storage, read_write> order: type_16;

fn function_() {
    var phi_84_: u32;
    var phi_101_: u32;
    var phi_150_: u32;
    var phi_151_: u32;

    let _e19 = id_1;
    let _e20 = n_1;
    let _e21 = lane_1;
    let _e32 = ((((_e19.y * _e20.x) + _e19.x) * 256u) + _e21);
    let _e34 = params.member.member_17;
    if (_e32 < _e34) {
        let _e37 = params.member.member_9;
        if (_e37 == 0u) {
            order.member[_e32] = _e32;
            phi_84_ = _e32;
        } else {
            let _e40 = order.member[_e32];
            phi_84_ = _e40;
        }
        let _e43 = phi_84_;
        let _e45 = contacts.member[0u];
        let _e47 = params.member.member_15;
        if (_e47 < _e45) {
            phi_101_ = _e47;
        } else {
            phi_101_ = _e45;
        }
        let _e50 = phi_101_;
        if (_e43 >= _e50) {
            phi_151_ = 4294967295u;
        } else {
            let _e52 = (6u * _e43);
            let _e55 = params.member.member_9;
            if (_e55 == 0u) {
                let _e69 = contacts.member[(_e52 + 7u)];
                phi_150_ = _e69;
            } else {
                let _e58 = contacts.member[(4u + _e52)];
                let _e61 = params.member.member[0u];
                let _e65 = contacts.member[(_e52 + 6u)];
                phi_150_ = ((_e58 * _e61) + _e65);
            }
            let _e71 = phi_150_;
            phi_151_ = _e71;
        }
        let _e73 = phi_151_;
        keys.member[_e32] = _e73;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn contact_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
