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
    member: type_7,
    member_1: type_8,
    member_2: type_8,
}

struct type_17 {
    member: type_16,
}

struct type_20 {
    member: array<atomic<u32>>,
}

@group(0) @binding(6) 
var<storage, read_write> output: type_20;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(3) 
var<storage> a_cut: type_10;
@group(0) @binding(4) 
var<storage> b_cut: type_10;
@group(0) @binding(5) 
var<storage, read_write> levels: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_182_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e19 = id_2;
    let _e20 = n_2;
    let _e21 = lane_2;
    let _e35 = ((((_e19.y * _e20.x) + _e19.x) * 256u) + _e21);
    let _e38 = params.member.member_2.member_2;
    if (_e38 == 0u) {
        return;
    }
    let _e40 = (_e35 / _e38);
    let _e43 = params.member.member_2.member_2;
    if (_e43 == 0u) {
        return;
    }
    let _e45 = (_e35 % _e43);
    let _e47 = a_cut.member[0u];
    if (_e40 < _e47) {
        let _e50 = b_cut.member[0u];
        if (_e45 < _e50) {
            let _e54 = a_cut.member[(4u + _e40)];
            let _e57 = b_cut.member[(4u + _e45)];
            let _e59 = a_nodes.member[_e54];
            let _e61 = b_nodes.member[_e57];
            let _e64 = params.member.member_2.member;
            if (_e64 == 1u) {
                if (_e40 < _e45) {
                    phi_181_ = true;
                } else {
                    if (_e40 == _e45) {
                        phi_180_ = !((_e59.member_3 == 4294967295u));
                    } else {
                        phi_180_ = false;
                    }
                    let _e72 = phi_180_;
                    phi_181_ = _e72;
                }
                let _e74 = phi_181_;
                phi_182_ = _e74;
            } else {
                phi_182_ = true;
            }
            let _e76 = phi_182_;
            if _e76 {
                if ((((((_e59.member[0] <= _e61.member_2[0]) && (_e61.member[0] <= _e59.member_2[0])) && (_e59.member[1] <= _e61.member_2[1])) && (_e61.member[1] <= _e59.member_2[1])) && (_e59.member[2] <= _e61.member_2[2])) && (_e61.member[2] <= _e59.member_2[2])) {
                    let _e105 = atomicAdd((&levels.member[0u]), 1u);
                    let _e108 = atomicMax((&output.member[0u]), (_e105 + 1u));
                    if ((_e105 + 1u) < _e105) {
                        let _e112 = atomicAdd((&output.member[2u]), 1u);
                    }
                    let _e115 = params.member.member_2.member_3;
                    if (_e105 < _e115) {
                        let _e117 = (2u * _e105);
                        atomicStore((&output.member[(4u + _e117)]), _e54);
                        atomicStore((&output.member[(_e117 + 5u)]), _e57);
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
