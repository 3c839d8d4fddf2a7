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
    var phi_113_: u32;
    var phi_150_: bool;
    var phi_179_: array<u32, 2>;
    var phi_180_: array<u32, 2>;
    var phi_181_: array<u32, 2>;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_239_: bool;
    var phi_301_: bool;
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
    if _e52 {
        phi_113_ = 0u;
    } else {
        phi_113_ = 1u;
    }
    let _e54 = phi_113_;
    let _e55 = (_e54 * 1028u);
    let _e57 = cuts.member[0u];
    if (_e45 < _e57) {
        let _e60 = cuts.member[_e55];
        if (_e49 < _e60) {
            if _e52 {
                phi_150_ = (_e45 <= _e49);
            } else {
                phi_150_ = true;
            }
            let _e64 = phi_150_;
            if _e64 {
                let _e67 = cuts.member[(4u + _e45)];
                let _e71 = cuts.member[((_e55 + 4u) + _e49)];
                phi_179_ = array<u32, 2>(_e67, _e71);
            } else {
                phi_179_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e74 = phi_179_;
            phi_180_ = _e74;
        } else {
            phi_180_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e76 = phi_180_;
        phi_181_ = _e76;
    } else {
        phi_181_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e78 = phi_181_;
    if (_e78[0] != 4294967295u) {
        let _e84 = params.member.member_2.member;
        if (_e84 == 1u) {
            if (_e78[0] == _e78[1]) {
                let _e91 = a_nodes.member[_e78[0]];
                phi_232_ = (_e91.member_3 == 4294967295u);
                phi_233_ = false;
            } else {
                phi_232_ = bool();
                phi_233_ = true;
            }
            let _e95 = phi_232_;
            let _e97 = phi_233_;
            phi_234_ = _e95;
            phi_235_ = _e97;
        } else {
            phi_234_ = bool();
            phi_235_ = true;
        }
        let _e99 = phi_234_;
        let _e101 = phi_235_;
        if _e101 {
            phi_239_ = false;
        } else {
            phi_239_ = _e99;
        }
        let _e103 = phi_239_;
        if _e103 {
        } else {
            let _e106 = a_nodes.member[_e78[0]];
            let _e109 = b_nodes.member[_e78[1]];
            if ((((((_e106.member[0] <= _e109.member_2[0]) && (_e109.member[0] <= _e106.member_2[0])) && (_e106.member[1] <= _e109.member_2[1])) && (_e109.member[1] <= _e106.member_2[1])) && (_e106.member[2] <= _e109.member_2[2])) && (_e109.member[2] <= _e106.member_2[2])) {
                phi_301_ = true;
            } else {
                phi_301_ = false;
            }
            let _e138 = phi_301_;
            if _e138 {
                let _e165 = atomicAdd((&control.member[0u]), 1u);
                let _e168 = atomicMax((&output.member[0u]), (_e165 + 1u));
                if ((_e165 + 1u) < _e165) {
                    let _e172 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e175 = params.member.member_2.member_3;
                if (_e165 < _e175) {
                    let _e179 = (2u * _e165);
                    atomicStore((&output.member[(4u + _e179)]), _e78[0]);
                    atomicStore((&output.member[(_e179 + 5u)]), _e78[1]);
                }
            } else {
                let _e141 = params.member.member_2.member_4;
                if (_e141 > 0u) {
                    let _e144 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e144 + 1u) < _e144) {
                        let _e148 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e150 = params.member.member_2.member_4;
                    if (_e144 < _e150) {
                        let _e153 = params.member.member_2.member_5;
                        let _e155 = params.member.member_2.member_4;
                        let _e158 = (2u * ((_e153 * _e155) + _e144));
                        front.member[_e158] = _e78[0];
                        front.member[(_e158 + 1u)] = _e78[1];
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
