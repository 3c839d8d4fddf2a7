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
    var phi_311_: u32;
    var phi_312_: u32;
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
        if ((((((_e85.member.x <= _e105.member_1.y) && (_e105.member.x <= _e85.member_1.y)) && (_e85.member.y <= _e105.member_2.x)) && (_e105.member.y <= _e85.member_2.x)) && (_e85.member_1.x <= _e105.member_2.y)) && (_e105.member_1.x <= _e85.member_2.y)) {
            if (_e76 > 1u) {
                phi_311_ = 1u;
            } else {
                phi_311_ = 2u;
            }
            let _e131 = phi_311_;
            phi_312_ = _e131;
        } else {
            phi_312_ = 3u;
        }
        let _e133 = phi_312_;
        phi_313_ = _e133;
    } else {
        phi_313_ = 0u;
    }
    let _e135 = phi_313_;
    if (_e135 == 1u) {
        let _e145 = atomicAdd((&shared_[6u]), 1u);
        phi_332_ = array<u32, 2>(_e145, 0u);
    } else {
        if (_e135 == 2u) {
            let _e140 = atomicAdd((&shared_[7u]), 1u);
            phi_331_ = array<u32, 2>(_e140, 0u);
        } else {
            phi_331_ = array<u32, 2>(0u, 0u);
        }
        let _e143 = phi_331_;
        phi_332_ = _e143;
    }
    let _e148 = phi_332_;
    if (_e135 >= 2u) {
        if (_e48.member_4 > 0u) {
            let _e152 = atomicAdd((&shared_[8u]), 1u);
            phi_344_ = array<u32, 2>(_e148[0], _e152);
        } else {
            phi_344_ = _e148;
        }
        let _e156 = phi_344_;
        phi_345_ = _e156;
    } else {
        phi_345_ = _e148;
    }
    let _e158 = phi_345_;
    workgroupBarrier();
    if (_e32 == 0u) {
        let _e161 = atomicLoad((&shared_[6u]));
        let _e163 = atomicLoad((&shared_[7u]));
        if (_e161 > 0u) {
            let _e166 = atomicAdd((&control.member[0u]), _e161);
            let _e169 = atomicMax((&nodes.member[0u]), (_e166 + _e161));
            if ((_e166 + _e161) < _e166) {
                let _e173 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e166);
        }
        if (_e163 > 0u) {
            let _e177 = atomicAdd((&pairs.member[0u]), _e163);
            if ((_e177 + _e163) < _e177) {
                let _e181 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e177);
        }
        let _e184 = atomicLoad((&shared_[8u]));
        if (_e184 > 0u) {
            let _e187 = atomicLoad((&shared_[8u]));
            let _e189 = atomicAdd((&control.member[1537u]), _e187);
            if ((_e189 + _e187) < _e189) {
                let _e193 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e189);
        }
    }
    workgroupBarrier();
    if (_e135 == 1u) {
        let _e233 = atomicLoad((&shared_[11u]));
        let _e235 = (_e233 + _e158[0]);
        if (_e235 < _e48.member_3) {
            if (_e235 < 4294967295u) {
                let _e241 = (2u * _e235);
                atomicStore((&nodes.member[(4u + _e241)]), _e66[0]);
                atomicStore((&nodes.member[(_e241 + 5u)]), _e66[1]);
            }
        }
    } else {
        if (_e135 == 0u) {
        } else {
            if (_e135 == 2u) {
                let _e202 = params.member.member_1;
                let _e205 = atomicLoad((&shared_[12u]));
                let _e207 = (_e205 + _e158[0]);
                if (_e207 < _e202.member_3) {
                    let _e209 = (2u * _e207);
                    atomicStore((&pairs.member[(4u + _e209)]), (_e66[0] & 134217727u));
                    atomicStore((&pairs.member[(_e209 + 5u)]), _e66[1]);
                }
            }
            if (_e48.member_4 > 0u) {
                let _e217 = atomicLoad((&shared_[13u]));
                let _e219 = (_e217 + _e158[1]);
                if (_e219 < _e48.member_4) {
                    let _e226 = (2u * ((_e48.member_5 * _e48.member_4) + _e219));
                    front.member[_e226] = _e66[0];
                    front.member[(_e226 + 1u)] = _e66[1];
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
