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
    member_18: u32,
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
    var phi_179_: array<u32, 2>;
    var phi_180_: array<u32, 2>;
    var phi_181_: array<u32, 2>;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e40 = ((((_e24.y * _e25.x) + _e24.x) * 256u) + _e26);
    let _e43 = params.member.member_2.member_2;
    if (_e43 == 0u) {
        return;
    }
    let _e45 = (_e40 / _e43);
    let _e47 = params.member.member_2.member_2;
    if (_e47 == 0u) {
        return;
    }
    let _e49 = (_e40 % _e47);
    let _e51 = params.member.member_2.member;
    let _e52 = (_e51 == 1u);
    let _e54 = (select(1u, 0u, _e52) * 1028u);
    let _e56 = cuts.member[0u];
    if (_e45 < _e56) {
        let _e59 = cuts.member[_e54];
        if (_e49 < _e59) {
            if select(true, (_e45 <= _e49), _e52) {
                let _e65 = cuts.member[(4u + _e45)];
                let _e69 = cuts.member[((_e54 + 4u) + _e49)];
                phi_179_ = array<u32, 2>(_e65, _e69);
            } else {
                phi_179_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e72 = phi_179_;
            phi_180_ = _e72;
        } else {
            phi_180_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e74 = phi_180_;
        phi_181_ = _e74;
    } else {
        phi_181_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e76 = phi_181_;
    if (_e76[0] != 4294967295u) {
        let _e82 = params.member.member_2.member;
        if (_e82 == 1u) {
            if (_e76[0] == _e76[1]) {
                let _e89 = a_nodes.member[_e76[0]];
                phi_232_ = (_e89.member_3 == 4294967295u);
                phi_233_ = false;
            } else {
                phi_232_ = bool();
                phi_233_ = true;
            }
            let _e93 = phi_232_;
            let _e95 = phi_233_;
            phi_234_ = _e93;
            phi_235_ = _e95;
        } else {
            phi_234_ = bool();
            phi_235_ = true;
        }
        let _e97 = phi_234_;
        let _e99 = phi_235_;
        if select(_e97, false, _e99) {
        } else {
            let _e103 = a_nodes.member[_e76[0]];
            let _e106 = b_nodes.member[_e76[1]];
            if select(false, true, ((((((_e103.member[0] <= _e106.member_2[0]) && (_e106.member[0] <= _e103.member_2[0])) && (_e103.member[1] <= _e106.member_2[1])) && (_e106.member[1] <= _e103.member_2[1])) && (_e103.member[2] <= _e106.member_2[2])) && (_e106.member[2] <= _e103.member_2[2]))) {
                let _e161 = atomicAdd((&control.member[0u]), 1u);
                let _e164 = atomicMax((&output.member[0u]), (_e161 + 1u));
                if ((_e161 + 1u) < _e161) {
                    let _e168 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e171 = params.member.member_2.member_3;
                if (_e161 < _e171) {
                    let _e175 = (2u * _e161);
                    atomicStore((&output.member[(4u + _e175)]), _e76[0]);
                    atomicStore((&output.member[(_e175 + 5u)]), _e76[1]);
                }
            } else {
                let _e137 = params.member.member_2.member_4;
                if (_e137 > 0u) {
                    let _e140 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e140 + 1u) < _e140) {
                        let _e144 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e146 = params.member.member_2.member_4;
                    if (_e140 < _e146) {
                        let _e149 = params.member.member_2.member_5;
                        let _e151 = params.member.member_2.member_4;
                        let _e154 = (2u * ((_e149 * _e151) + _e140));
                        front.member[_e154] = _e76[0];
                        front.member[(_e154 + 1u)] = _e76[1];
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
