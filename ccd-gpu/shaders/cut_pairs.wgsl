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
    var phi_111_: u32;
    var phi_148_: bool;
    var phi_177_: array<u32, 2>;
    var phi_178_: array<u32, 2>;
    var phi_179_: array<u32, 2>;
    var phi_224_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_305_: bool;
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
        phi_111_ = 0u;
    } else {
        phi_111_ = 1u;
    }
    let _e53 = phi_111_;
    let _e54 = (_e53 * 1028u);
    let _e56 = cuts.member[0u];
    if (_e44 < _e56) {
        let _e59 = cuts.member[_e54];
        if (_e48 < _e59) {
            if _e51 {
                phi_148_ = (_e44 <= _e48);
            } else {
                phi_148_ = true;
            }
            let _e63 = phi_148_;
            if _e63 {
                let _e66 = cuts.member[(4u + _e44)];
                let _e70 = cuts.member[((_e54 + 4u) + _e48)];
                phi_177_ = array<u32, 2>(_e66, _e70);
            } else {
                phi_177_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e73 = phi_177_;
            phi_178_ = _e73;
        } else {
            phi_178_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e75 = phi_178_;
        phi_179_ = _e75;
    } else {
        phi_179_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e77 = phi_179_;
    if (_e77[0] != 4294967295u) {
        let _e83 = a_nodes.member[_e77[0]];
        let _e86 = b_nodes.member[_e77[1]];
        let _e89 = params.member.member_2.member;
        if (_e89 == 1u) {
            phi_224_ = (_e77[0] == _e77[1]);
        } else {
            phi_224_ = false;
        }
        let _e95 = phi_224_;
        if _e95 {
            if (_e83.member_3 == 4294967295u) {
                phi_233_ = false;
            } else {
                phi_233_ = true;
            }
            let _e99 = phi_233_;
            phi_234_ = _e99;
        } else {
            phi_234_ = true;
        }
        let _e101 = phi_234_;
        if _e101 {
            if ((((((_e83.member[0] <= _e86.member_2[0]) && (_e86.member[0] <= _e83.member_2[0])) && (_e83.member[1] <= _e86.member_2[1])) && (_e86.member[1] <= _e83.member_2[1])) && (_e83.member[2] <= _e86.member_2[2])) && (_e86.member[2] <= _e83.member_2[2])) {
                let _e130 = atomicAdd((&control.member[0u]), 1u);
                let _e133 = atomicMax((&output.member[0u]), (_e130 + 1u));
                if ((_e130 + 1u) < _e130) {
                    let _e137 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e140 = params.member.member_2.member_3;
                if (_e130 < _e140) {
                    let _e144 = (2u * _e130);
                    atomicStore((&output.member[(4u + _e144)]), _e77[0]);
                    atomicStore((&output.member[(_e144 + 5u)]), _e77[1]);
                }
                phi_305_ = false;
            } else {
                phi_305_ = true;
            }
            let _e150 = phi_305_;
            if _e150 {
                let _e153 = params.member.member_2.member_4;
                if (_e153 > 0u) {
                    let _e156 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e156 + 1u) < _e156) {
                        let _e160 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e162 = params.member.member_2.member_4;
                    if (_e156 < _e162) {
                        let _e165 = params.member.member_2.member_5;
                        let _e167 = params.member.member_2.member_4;
                        let _e170 = (2u * ((_e165 * _e167) + _e156));
                        front.member[_e170] = _e77[0];
                        front.member[(_e170 + 1u)] = _e77[1];
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
