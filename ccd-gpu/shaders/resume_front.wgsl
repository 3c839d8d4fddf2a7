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

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
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

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> a_nodes: type_16;
@group(0) @binding(2) 
var<storage> b_nodes: type_16;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_22;
@group(0) @binding(3) 
var<storage, read_write> control: type_22;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_22;
var<workgroup> shared_: array<atomic<u32>, 22>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_130_: array<u32, 2>;
    var phi_211_: array<u32, 2>;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_250_: u32;
    var phi_251_: u32;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_271_: array<u32, 2>;
    var phi_272_: array<u32, 2>;
    var phi_284_: array<u32, 2>;
    var phi_285_: array<u32, 2>;
    var phi_424_: type_9;
    var phi_429_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e49 = ((((_e33.y * _e34.x) + _e33.x) * 128u) + _e35);
    let _e51 = params.member.member_2;
    let _e54 = params.member.member_1.member;
    if (_e49 < _e54) {
        let _e61 = (2u * (((1u - _e51.member_5) * _e51.member_4) + _e49));
        let _e63 = front.member[_e61];
        let _e66 = front.member[(_e61 + 1u)];
        phi_130_ = array<u32, 2>(_e63, _e66);
    } else {
        phi_130_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e69 = phi_130_;
    let _e71 = params.member.member_2;
    if (_e35 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e69[0] != 4294967295u) {
        let _e80 = a_nodes.member[_e69[0]];
        let _e83 = b_nodes.member[_e69[1]];
        if ((((((_e80.member[0] <= _e83.member_2[0]) && (_e83.member[0] <= _e80.member_2[0])) && (_e80.member[1] <= _e83.member_2[1])) && (_e83.member[1] <= _e80.member_2[1])) && (_e80.member[2] <= _e83.member_2[2])) && (_e83.member[2] <= _e80.member_2[2])) {
            let _e113 = params.member.member_2.member;
            if (_e113 == 0u) {
                phi_211_ = array<u32, 2>(0u, 2u);
            } else {
                phi_211_ = array<u32, 2>(1u, 1u);
            }
            let _e116 = phi_211_;
            let _e122 = params.member.member.member[_e116[0]];
            let _e127 = params.member.member.member[_e116[1]];
            if (_e69[0] == 4294967295u) {
                phi_251_ = 0u;
            } else {
                if (_e69[0] >= (_e122 - 1u)) {
                    if (_e69[1] >= (_e127 - 1u)) {
                        phi_245_ = false;
                    } else {
                        phi_245_ = true;
                    }
                    let _e136 = phi_245_;
                    phi_246_ = _e136;
                } else {
                    phi_246_ = true;
                }
                let _e138 = phi_246_;
                if _e138 {
                    phi_250_ = 1u;
                } else {
                    phi_250_ = 2u;
                }
                let _e140 = phi_250_;
                phi_251_ = _e140;
            }
            let _e142 = phi_251_;
            phi_253_ = _e142;
        } else {
            phi_253_ = 3u;
        }
        let _e144 = phi_253_;
        phi_254_ = _e144;
    } else {
        phi_254_ = 0u;
    }
    let _e146 = phi_254_;
    if (_e146 == 1u) {
        let _e156 = atomicAdd((&shared_[6u]), 1u);
        phi_272_ = array<u32, 2>(_e156, 0u);
    } else {
        if (_e146 == 2u) {
            let _e151 = atomicAdd((&shared_[7u]), 1u);
            phi_271_ = array<u32, 2>(_e151, 0u);
        } else {
            phi_271_ = array<u32, 2>(0u, 0u);
        }
        let _e154 = phi_271_;
        phi_272_ = _e154;
    }
    let _e159 = phi_272_;
    if (_e146 >= 2u) {
        if (_e71.member_4 > 0u) {
            let _e163 = atomicAdd((&shared_[8u]), 1u);
            phi_284_ = array<u32, 2>(_e159[0], _e163);
        } else {
            phi_284_ = _e159;
        }
        let _e167 = phi_284_;
        phi_285_ = _e167;
    } else {
        phi_285_ = _e159;
    }
    let _e169 = phi_285_;
    workgroupBarrier();
    if (_e35 == 0u) {
        let _e172 = atomicLoad((&shared_[6u]));
        let _e174 = atomicLoad((&shared_[7u]));
        if (_e172 > 0u) {
            let _e177 = atomicAdd((&control.member[0u]), _e172);
            let _e180 = atomicMax((&nodes.member[0u]), (_e177 + _e172));
            if ((_e177 + _e172) < _e177) {
                let _e184 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e177);
        }
        if (_e174 > 0u) {
            let _e188 = atomicAdd((&pairs.member[0u]), _e174);
            if ((_e188 + _e174) < _e188) {
                let _e192 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e188);
        }
        let _e195 = atomicLoad((&shared_[8u]));
        if (_e195 > 0u) {
            let _e198 = atomicLoad((&shared_[8u]));
            let _e200 = atomicAdd((&control.member[1537u]), _e198);
            if ((_e200 + _e198) < _e200) {
                let _e204 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e200);
        }
    }
    workgroupBarrier();
    if (_e146 == 1u) {
        let _e261 = atomicLoad((&shared_[11u]));
        let _e263 = (_e261 + _e169[0]);
        if (_e263 < _e71.member_3) {
            if (_e263 < 4294967295u) {
                let _e269 = (2u * _e263);
                atomicStore((&nodes.member[(4u + _e269)]), _e69[0]);
                atomicStore((&nodes.member[(_e269 + 5u)]), _e69[1]);
            }
        }
    } else {
        if (_e146 == 0u) {
        } else {
            let _e210 = params.member.member_1.member_3;
            if (_e146 == 2u) {
                let _e214 = a_nodes.member[_e69[0]];
                let _e218 = b_nodes.member[_e69[1]];
                if (_e71.member == 1u) {
                    if (_e214.member_1 < _e218.member_1) {
                        phi_424_ = type_9(_e214.member_1, _e218.member_1);
                    } else {
                        phi_424_ = type_9(_e218.member_1, _e214.member_1);
                    }
                    let _e227 = phi_424_;
                    phi_429_ = _e227;
                } else {
                    phi_429_ = type_9(_e214.member_1, _e218.member_1);
                }
                let _e229 = phi_429_;
                let _e233 = atomicLoad((&shared_[12u]));
                let _e235 = (_e233 + _e169[0]);
                if (_e235 < _e210) {
                    let _e237 = (2u * _e235);
                    atomicStore((&pairs.member[(4u + _e237)]), _e229.member);
                    atomicStore((&pairs.member[(_e237 + 5u)]), _e229.member_1);
                }
            }
            if (_e71.member_4 > 0u) {
                let _e245 = atomicLoad((&shared_[13u]));
                let _e247 = (_e245 + _e169[1]);
                if (_e247 < _e71.member_4) {
                    let _e254 = (2u * ((_e71.member_5 * _e71.member_4) + _e247));
                    front.member[_e254] = _e69[0];
                    front.member[(_e254 + 1u)] = _e69[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_front(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
