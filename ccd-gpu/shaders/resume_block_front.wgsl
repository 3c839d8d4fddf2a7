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
    var phi_201_: array<u32, 2>;
    var phi_313_: u32;
    var phi_331_: array<u32, 2>;
    var phi_332_: array<u32, 2>;
    var phi_344_: array<u32, 2>;
    var phi_345_: array<u32, 2>;
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
    let _e50 = params.member.member_1;
    if (_e45 < _e50.member) {
        let _e58 = (2u * (((1u - _e48.member_5) * _e48.member_4) + _e45));
        let _e60 = front.member[_e58];
        let _e63 = front.member[(_e58 + 1u)];
        phi_201_ = array<u32, 2>(_e60, _e63);
    } else {
        phi_201_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e66 = phi_201_;
    if (_e32 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e66[0] != 4294967295u) {
        let _e76 = (_e66[0] >> bitcast<u32>(27u));
        let _e82 = params.member.member_2.member_1[_e76][0u];
        let _e85 = boxes.member[(_e82 + (_e66[0] & 134217727u))];
        let _e102 = params.member.member_2.member_1[_e76][1u];
        let _e105 = boxes.member[(_e102 + _e66[1])];
        phi_313_ = select(3u, select(2u, 1u, (_e76 > 1u)), ((((((_e85.member.x <= _e105.member_1.y) && (_e105.member.x <= _e85.member_1.y)) && (_e85.member.y <= _e105.member_2.x)) && (_e105.member.y <= _e85.member_2.x)) && (_e85.member_1.x <= _e105.member_2.y)) && (_e105.member_1.x <= _e85.member_2.y)));
    } else {
        phi_313_ = 0u;
    }
    let _e133 = phi_313_;
    if (_e133 == 1u) {
        let _e143 = atomicAdd((&shared_[6u]), 1u);
        phi_332_ = array<u32, 2>(_e143, 0u);
    } else {
        if (_e133 == 2u) {
            let _e138 = atomicAdd((&shared_[7u]), 1u);
            phi_331_ = array<u32, 2>(_e138, 0u);
        } else {
            phi_331_ = array<u32, 2>(0u, 0u);
        }
        let _e141 = phi_331_;
        phi_332_ = _e141;
    }
    let _e146 = phi_332_;
    if (_e133 >= 2u) {
        if (_e48.member_4 > 0u) {
            let _e150 = atomicAdd((&shared_[8u]), 1u);
            phi_344_ = array<u32, 2>(_e146[0], _e150);
        } else {
            phi_344_ = _e146;
        }
        let _e154 = phi_344_;
        phi_345_ = _e154;
    } else {
        phi_345_ = _e146;
    }
    let _e156 = phi_345_;
    workgroupBarrier();
    if (_e32 == 0u) {
        let _e159 = atomicLoad((&shared_[6u]));
        let _e161 = atomicLoad((&shared_[7u]));
        if (_e159 > 0u) {
            let _e164 = atomicAdd((&control.member[0u]), _e159);
            let _e167 = atomicMax((&nodes.member[0u]), (_e164 + _e159));
            if ((_e164 + _e159) < _e164) {
                let _e171 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e164);
        }
        if (_e161 > 0u) {
            let _e175 = atomicAdd((&pairs.member[0u]), _e161);
            if ((_e175 + _e161) < _e175) {
                let _e179 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e175);
        }
        let _e182 = atomicLoad((&shared_[8u]));
        if (_e182 > 0u) {
            let _e185 = atomicLoad((&shared_[8u]));
            let _e187 = atomicAdd((&control.member[1537u]), _e185);
            if ((_e187 + _e185) < _e187) {
                let _e191 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e187);
        }
    }
    workgroupBarrier();
    if (_e133 == 1u) {
        let _e231 = atomicLoad((&shared_[11u]));
        let _e233 = (_e231 + _e156[0]);
        if (_e233 < _e48.member_3) {
            if (_e233 < 4294967295u) {
                let _e239 = (2u * _e233);
                atomicStore((&nodes.member[(4u + _e239)]), _e66[0]);
                atomicStore((&nodes.member[(_e239 + 5u)]), _e66[1]);
            }
        }
    } else {
        if (_e133 == 0u) {
        } else {
            if (_e133 == 2u) {
                let _e200 = params.member.member_1;
                let _e203 = atomicLoad((&shared_[12u]));
                let _e205 = (_e203 + _e156[0]);
                if (_e205 < _e200.member_3) {
                    let _e207 = (2u * _e205);
                    atomicStore((&pairs.member[(4u + _e207)]), (_e66[0] & 134217727u));
                    atomicStore((&pairs.member[(_e207 + 5u)]), _e66[1]);
                }
            }
            if (_e48.member_4 > 0u) {
                let _e215 = atomicLoad((&shared_[13u]));
                let _e217 = (_e215 + _e156[1]);
                if (_e217 < _e48.member_4) {
                    let _e224 = (2u * ((_e48.member_5 * _e48.member_4) + _e217));
                    front.member[_e224] = _e66[0];
                    front.member[(_e224 + 1u)] = _e66[1];
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
