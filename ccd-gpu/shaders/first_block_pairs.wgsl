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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_14 {
    member: array<type_12>,
}

struct type_15 {
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
    member: type_15,
    member_1: array<array<u32, 2>, 8>,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_22 {
    member: array<atomic<u32>>,
}

@group(0) @binding(6) 
var<storage, read_write> front: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_14;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_22;
@group(0) @binding(3) 
var<storage, read_write> control: type_22;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_22;
var<workgroup> shared_: array<atomic<u32>, 22>;
@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(2) 
var<storage> first: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_144_: array<u32, 2>;
    var phi_311_: u32;
    var phi_329_: array<u32, 2>;
    var phi_330_: array<u32, 2>;
    var phi_342_: array<u32, 2>;
    var phi_343_: array<u32, 2>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e47 = ((((_e31.y * _e32.x) + _e31.x) * 128u) + _e33);
    let _e50 = params.member.member_1.member;
    if (_e47 < _e50) {
        let _e52 = (2u * _e47);
        let _e55 = first.member[(4u + _e52)];
        let _e58 = first.member[(_e52 + 5u)];
        let _e61 = params.member.member_1.member_1;
        phi_144_ = array<u32, 2>(((_e61 << bitcast<u32>(27u)) | _e55), _e58);
    } else {
        phi_144_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e67 = phi_144_;
    let _e70 = params.member.member_2.member;
    if (_e33 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e67[0] != 4294967295u) {
        let _e80 = (_e67[0] >> bitcast<u32>(27u));
        let _e86 = params.member.member_2.member_1[_e80][0u];
        let _e89 = boxes.member[(_e86 + (_e67[0] & 134217727u))];
        let _e106 = params.member.member_2.member_1[_e80][1u];
        let _e109 = boxes.member[(_e106 + _e67[1])];
        phi_311_ = select(3u, select(2u, 1u, (_e80 > 1u)), ((((((_e89.member.x <= _e109.member_1.y) && (_e109.member.x <= _e89.member_1.y)) && (_e89.member.y <= _e109.member_2.x)) && (_e109.member.y <= _e89.member_2.x)) && (_e89.member_1.x <= _e109.member_2.y)) && (_e109.member_1.x <= _e89.member_2.y)));
    } else {
        phi_311_ = 0u;
    }
    let _e137 = phi_311_;
    if (_e137 == 1u) {
        let _e147 = atomicAdd((&shared_[6u]), 1u);
        phi_330_ = array<u32, 2>(_e147, 0u);
    } else {
        if (_e137 == 2u) {
            let _e142 = atomicAdd((&shared_[7u]), 1u);
            phi_329_ = array<u32, 2>(_e142, 0u);
        } else {
            phi_329_ = array<u32, 2>(0u, 0u);
        }
        let _e145 = phi_329_;
        phi_330_ = _e145;
    }
    let _e150 = phi_330_;
    if (_e137 >= 2u) {
        if (_e70.member_4 > 0u) {
            let _e154 = atomicAdd((&shared_[8u]), 1u);
            phi_342_ = array<u32, 2>(_e150[0], _e154);
        } else {
            phi_342_ = _e150;
        }
        let _e158 = phi_342_;
        phi_343_ = _e158;
    } else {
        phi_343_ = _e150;
    }
    let _e160 = phi_343_;
    workgroupBarrier();
    if (_e33 == 0u) {
        let _e163 = atomicLoad((&shared_[6u]));
        let _e165 = atomicLoad((&shared_[7u]));
        if (_e163 > 0u) {
            let _e168 = atomicAdd((&control.member[0u]), _e163);
            let _e171 = atomicMax((&nodes.member[0u]), (_e168 + _e163));
            if ((_e168 + _e163) < _e168) {
                let _e175 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e168);
        }
        if (_e165 > 0u) {
            let _e179 = atomicAdd((&pairs.member[0u]), _e165);
            if ((_e179 + _e165) < _e179) {
                let _e183 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e179);
        }
        let _e186 = atomicLoad((&shared_[8u]));
        if (_e186 > 0u) {
            let _e189 = atomicLoad((&shared_[8u]));
            let _e191 = atomicAdd((&control.member[1537u]), _e189);
            if ((_e191 + _e189) < _e191) {
                let _e195 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e191);
        }
    }
    workgroupBarrier();
    if (_e137 == 1u) {
        let _e235 = atomicLoad((&shared_[11u]));
        let _e237 = (_e235 + _e160[0]);
        if (_e237 < _e70.member_3) {
            if (_e237 < 4294967295u) {
                let _e243 = (2u * _e237);
                atomicStore((&nodes.member[(4u + _e243)]), _e67[0]);
                atomicStore((&nodes.member[(_e243 + 5u)]), _e67[1]);
            }
        }
    } else {
        if (_e137 == 0u) {
        } else {
            if (_e137 == 2u) {
                let _e204 = params.member.member_1;
                let _e207 = atomicLoad((&shared_[12u]));
                let _e209 = (_e207 + _e160[0]);
                if (_e209 < _e204.member_3) {
                    let _e211 = (2u * _e209);
                    atomicStore((&pairs.member[(4u + _e211)]), (_e67[0] & 134217727u));
                    atomicStore((&pairs.member[(_e211 + 5u)]), _e67[1]);
                }
            }
            if (_e70.member_4 > 0u) {
                let _e219 = atomicLoad((&shared_[13u]));
                let _e221 = (_e219 + _e160[1]);
                if (_e221 < _e70.member_4) {
                    let _e228 = (2u * ((_e70.member_5 * _e70.member_4) + _e221));
                    front.member[_e228] = _e67[0];
                    front.member[(_e228 + 1u)] = _e67[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn first_block_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
