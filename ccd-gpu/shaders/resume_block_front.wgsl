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

@group(0) @binding(1) 
var<storage> boxes: type_14;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_22;
var<workgroup> shared_: array<atomic<u32>, 22>;
@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(2) 
var<storage, read_write> control: type_22;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_22;
@group(0) @binding(5) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_132_: array<u32, 2>;
    var phi_234_: u32;
    var phi_235_: u32;
    var phi_236_: u32;
    var phi_253_: array<u32, 2>;
    var phi_254_: array<u32, 2>;
    var phi_266_: array<u32, 2>;
    var phi_267_: array<u32, 2>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e30 = id_2;
    let _e31 = n_2;
    let _e32 = lane_2;
    let _e45 = ((((_e30.y * _e31.x) + _e30.x) * 128u) + _e32);
    let _e48 = params.member.member_2.member;
    let _e51 = params.member.member_1.member;
    if (_e45 < _e51) {
        let _e58 = (2u * (((1u - _e48.member_5) * _e48.member_4) + _e45));
        let _e60 = front.member[_e58];
        let _e63 = front.member[(_e58 + 1u)];
        phi_132_ = array<u32, 2>(_e60, _e63);
    } else {
        phi_132_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e66 = phi_132_;
    let _e69 = params.member.member_2.member;
    if (_e32 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e66[0] != 4294967295u) {
        let _e79 = (_e66[0] >> bitcast<u32>(27u));
        let _e85 = params.member.member_2.member_1[_e79][0u];
        let _e88 = boxes.member[(_e85 + (_e66[0] & 134217727u))];
        let _e105 = params.member.member_2.member_1[_e79][1u];
        let _e108 = boxes.member[(_e105 + _e66[1])];
        if ((((((_e88.member.x <= _e108.member_1.y) && (_e108.member.x <= _e88.member_1.y)) && (_e88.member.y <= _e108.member_2.x)) && (_e108.member.y <= _e88.member_2.x)) && (_e88.member_1.x <= _e108.member_2.y)) && (_e108.member_1.x <= _e88.member_2.y)) {
            if (_e79 > 1u) {
                phi_234_ = 1u;
            } else {
                phi_234_ = 2u;
            }
            let _e134 = phi_234_;
            phi_235_ = _e134;
        } else {
            phi_235_ = 3u;
        }
        let _e136 = phi_235_;
        phi_236_ = _e136;
    } else {
        phi_236_ = 0u;
    }
    let _e138 = phi_236_;
    if (_e138 == 1u) {
        let _e148 = atomicAdd((&shared_[6u]), 1u);
        phi_254_ = array<u32, 2>(_e148, 0u);
    } else {
        if (_e138 == 2u) {
            let _e143 = atomicAdd((&shared_[7u]), 1u);
            phi_253_ = array<u32, 2>(_e143, 0u);
        } else {
            phi_253_ = array<u32, 2>(0u, 0u);
        }
        let _e146 = phi_253_;
        phi_254_ = _e146;
    }
    let _e151 = phi_254_;
    if (_e138 >= 2u) {
        if (_e69.member_4 > 0u) {
            let _e155 = atomicAdd((&shared_[8u]), 1u);
            phi_266_ = array<u32, 2>(_e151[0], _e155);
        } else {
            phi_266_ = _e151;
        }
        let _e159 = phi_266_;
        phi_267_ = _e159;
    } else {
        phi_267_ = _e151;
    }
    let _e161 = phi_267_;
    workgroupBarrier();
    if (_e32 == 0u) {
        let _e164 = atomicLoad((&shared_[6u]));
        let _e166 = atomicLoad((&shared_[7u]));
        if (_e164 > 0u) {
            let _e169 = atomicAdd((&control.member[0u]), _e164);
            let _e172 = atomicMax((&nodes.member[0u]), (_e169 + _e164));
            if ((_e169 + _e164) < _e169) {
                let _e176 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e169);
        }
        if (_e166 > 0u) {
            let _e180 = atomicAdd((&pairs.member[0u]), _e166);
            if ((_e180 + _e166) < _e180) {
                let _e184 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e180);
        }
        let _e187 = atomicLoad((&shared_[8u]));
        if (_e187 > 0u) {
            let _e190 = atomicLoad((&shared_[8u]));
            let _e192 = atomicAdd((&control.member[1537u]), _e190);
            if ((_e192 + _e190) < _e192) {
                let _e196 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e192);
        }
    }
    workgroupBarrier();
    if (_e138 == 1u) {
        let _e236 = atomicLoad((&shared_[11u]));
        let _e238 = (_e236 + _e161[0]);
        if (_e238 < _e69.member_3) {
            if (_e238 < 4294967295u) {
                let _e244 = (2u * _e238);
                atomicStore((&nodes.member[(4u + _e244)]), _e66[0]);
                atomicStore((&nodes.member[(_e244 + 5u)]), _e66[1]);
            }
        }
    } else {
        if (_e138 == 0u) {
        } else {
            let _e202 = params.member.member_1.member_3;
            if (_e138 == 2u) {
                let _e208 = atomicLoad((&shared_[12u]));
                let _e210 = (_e208 + _e161[0]);
                if (_e210 < _e202) {
                    let _e212 = (2u * _e210);
                    atomicStore((&pairs.member[(4u + _e212)]), (_e66[0] & 134217727u));
                    atomicStore((&pairs.member[(_e212 + 5u)]), _e66[1]);
                }
            }
            if (_e69.member_4 > 0u) {
                let _e220 = atomicLoad((&shared_[13u]));
                let _e222 = (_e220 + _e161[1]);
                if (_e222 < _e69.member_4) {
                    let _e229 = (2u * ((_e69.member_5 * _e69.member_4) + _e222));
                    front.member[_e229] = _e66[0];
                    front.member[(_e229 + 1u)] = _e66[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_block_front(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
