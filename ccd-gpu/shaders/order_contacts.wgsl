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
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(2) 
var<storage> order: type_16;
@group(0) @binding(1) 
var<storage> contacts: type_16;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_16;

fn function_() {
    var phi_81_: u32;
    var phi_86_: u32;
    var phi_105_: type_21;
    var phi_106_: type_21;
    var phi_129_: type_21;

    let _e20 = id_1;
    let _e21 = n_1;
    let _e22 = lane_1;
    let _e33 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e35 = params.member.member_17;
    let _e37 = params.member.member_15;
    let _e39 = contacts.member[0u];
    if (_e37 < _e39) {
        phi_81_ = _e37;
    } else {
        phi_81_ = _e39;
    }
    let _e42 = phi_81_;
    if (_e42 < _e35) {
        phi_86_ = _e42;
    } else {
        phi_86_ = _e35;
    }
    let _e45 = phi_86_;
    if (_e33 < _e45) {
        let _e48 = order.member[_e33];
        phi_105_ = type_21(0u, 6u);
        loop {
            let _e52 = phi_105_;
            if (_e52.member < _e52.member_1) {
                phi_106_ = type_21((_e52.member + 1u), _e52.member_1);
                phi_129_ = type_21(1u, _e52.member);
            } else {
                phi_106_ = _e52;
                phi_129_ = type_21(0u, type_21().member_1);
            }
            let _e66 = phi_106_;
            let _e68 = phi_129_;
            let _e72 = (bitcast<i32>(_e68.member) != 0i);
            if _e72 {
                let _e77 = contacts.member[((4u + (6u * _e48)) + _e68.member_1)];
                ordered.member[((6u * _e33) + _e68.member_1)] = _e77;
            }
            continue;
            continuing {
                phi_105_ = _e66;
                break if !(_e72);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
