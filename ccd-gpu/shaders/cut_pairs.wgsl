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

struct type_13 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_21 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(5) 
var<storage, read_write> output: type_21;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(4) 
var<storage, read_write> control: type_21;
@group(0) @binding(6) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_102_: u32;
    var phi_139_: bool;
    var phi_168_: array<u32, 2>;
    var phi_169_: array<u32, 2>;
    var phi_170_: array<u32, 2>;
    var phi_208_: bool;
    var phi_217_: bool;
    var phi_218_: bool;
    var phi_254_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e39 = ((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25);
    let _e42 = params.member.member_2.member_2;
    if (_e42 == 0u) {
        return;
    }
    let _e44 = (_e39 / _e42);
    let _e46 = params.member.member_2.member_2;
    if (_e46 == 0u) {
        return;
    }
    let _e48 = (_e39 % _e46);
    let _e50 = params.member.member_2.member;
    let _e51 = (_e50 == 1u);
    if _e51 {
        phi_102_ = 0u;
    } else {
        phi_102_ = 1u;
    }
    let _e53 = phi_102_;
    let _e54 = (_e53 * 1028u);
    let _e56 = cuts.member[0u];
    if (_e44 < _e56) {
        let _e59 = cuts.member[_e54];
        if (_e48 < _e59) {
            if _e51 {
                phi_139_ = (_e44 <= _e48);
            } else {
                phi_139_ = true;
            }
            let _e63 = phi_139_;
            if _e63 {
                let _e66 = cuts.member[(4u + _e44)];
                let _e70 = cuts.member[((_e54 + 4u) + _e48)];
                phi_168_ = array<u32, 2>(_e66, _e70);
            } else {
                phi_168_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e73 = phi_168_;
            phi_169_ = _e73;
        } else {
            phi_169_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e75 = phi_169_;
        phi_170_ = _e75;
    } else {
        phi_170_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e77 = phi_170_;
    if (_e77[0] != 4294967295u) {
        let _e82 = a_nodes.member[_e77[0]];
        let _e85 = b_nodes.member[_e77[1]];
        let _e88 = params.member.member_2.member;
        if (_e88 == 1u) {
            phi_208_ = (_e77[0] == _e77[1]);
        } else {
            phi_208_ = false;
        }
        let _e94 = phi_208_;
        if _e94 {
            if (_e82.member_3 == 4294967295u) {
                phi_217_ = false;
            } else {
                phi_217_ = true;
            }
            let _e98 = phi_217_;
            phi_218_ = _e98;
        } else {
            phi_218_ = true;
        }
        let _e100 = phi_218_;
        if _e100 {
            if ((((((_e82.member[0] <= _e85.member_2[0]) && (_e85.member[0] <= _e82.member_2[0])) && (_e82.member[1] <= _e85.member_2[1])) && (_e85.member[1] <= _e82.member_2[1])) && (_e82.member[2] <= _e85.member_2[2])) && (_e85.member[2] <= _e82.member_2[2])) {
                phi_254_ = true;
            } else {
                phi_254_ = false;
            }
            let _e129 = phi_254_;
            if _e129 {
                let _e157 = atomicAdd((&control.member[0u]), 1u);
                let _e160 = atomicMax((&output.member[0u]), (_e157 + 1u));
                if ((_e157 + 1u) < _e157) {
                    let _e164 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e167 = params.member.member_2.member_3;
                if (_e157 < _e167) {
                    let _e171 = (2u * _e157);
                    atomicStore((&output.member[(4u + _e171)]), _e77[0]);
                    atomicStore((&output.member[(_e171 + 5u)]), _e77[1]);
                }
            } else {
                let _e132 = params.member.member_2.member_4;
                if (_e132 > 0u) {
                    let _e135 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e135 + 1u) < _e135) {
                        let _e139 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e142 = params.member.member_2.member_4;
                    if (_e135 < _e142) {
                        let _e145 = params.member.member_2.member_5;
                        let _e147 = params.member.member_2.member_4;
                        let _e150 = (2u * ((_e145 * _e147) + _e135));
                        front.member[_e150] = _e77[0];
                        front.member[(_e150 + 1u)] = _e77[1];
                    }
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
