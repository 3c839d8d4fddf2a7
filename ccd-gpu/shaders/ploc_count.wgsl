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

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_13 {
    member: type_7,
    member_1: type_8,
    member_2: type_12,
}

struct type_14 {
    member: type_13,
}

struct type_17 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> neighbours: type_10;
@group(0) @binding(2) 
var<storage, read_write> counts: type_17;
var<workgroup> left: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_81_: u32;
    var phi_125_: u32;
    var phi_126_: u32;
    var phi_127_: u32;
    var phi_128_: bool;
    var phi_132_: u32;
    var phi_173_: u32;
    var phi_189_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e24 = ((_e14.y * _e15.x) + _e14.x);
    let _e27 = params.member.member_1.member_1;
    let _e29 = atomicLoad((&counts.member[_e27]));
    if (_e29 > 256u) {
        phi_81_ = _e29;
    } else {
        phi_81_ = 0u;
    }
    let _e32 = phi_81_;
    let _e34 = ((_e24 * 256u) + _e16);
    if (_e16 == 0u) {
        atomicStore((&left[0u]), 0u);
    }
    workgroupBarrier();
    if (_e34 < _e32) {
        let _e39 = neighbours.member[_e34];
        let _e41 = neighbours.member[_e39];
        if (_e34 == _e39) {
            phi_127_ = u32();
            phi_128_ = true;
        } else {
            let _e43 = (_e41 != _e34);
            if _e43 {
                phi_126_ = u32();
            } else {
                if (_e34 < _e39) {
                    phi_125_ = 1u;
                } else {
                    phi_125_ = 2u;
                }
                let _e46 = phi_125_;
                phi_126_ = _e46;
            }
            let _e48 = phi_126_;
            phi_127_ = _e48;
            phi_128_ = _e43;
        }
        let _e50 = phi_127_;
        let _e52 = phi_128_;
        if _e52 {
            phi_132_ = 0u;
        } else {
            phi_132_ = _e50;
        }
        let _e54 = phi_132_;
        if !((_e54 == 2u)) {
            let _e58 = atomicAdd((&left[0u]), 1u);
        }
    }
    workgroupBarrier();
    if (_e16 == 0u) {
        if (_e34 < _e32) {
            let _e63 = params.member.member_2.member;
            let _e67 = params.member.member.member[_e63];
            let _e68 = (_e67 / 256u);
            if ((_e67 % 256u) > 0u) {
                phi_173_ = (_e68 + 1u);
            } else {
                phi_173_ = _e68;
            }
            let _e73 = phi_173_;
            let _e74 = (_e73 / 256u);
            if ((_e73 % 256u) > 0u) {
                phi_189_ = (_e74 + 1u);
            } else {
                phi_189_ = _e74;
            }
            let _e79 = phi_189_;
            let _e83 = atomicLoad((&left[0u]));
            atomicStore((&counts.member[(192u + (_e79 + _e24))]), _e83);
            let _e88 = atomicLoad((&left[0u]));
            let _e90 = atomicAdd((&counts.member[(192u + (_e24 / 256u))]), _e88);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
