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

struct type_12 {
    member: u32,
    member_1: u32,
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
var<storage, read_write> front: type_10;
@group(0) @binding(3) 
var<storage, read_write> control: type_22;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_22;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_22;
var<workgroup> shared_: array<atomic<u32>, 18>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_102_: array<u32, 2>;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_232_: u32;
    var phi_233_: u32;
    var phi_234_: u32;
    var phi_235_: u32;
    var phi_236_: array<u32, 2>;
    var phi_253_: array<u32, 2>;
    var phi_254_: array<u32, 2>;
    var phi_266_: array<u32, 2>;
    var phi_267_: array<u32, 2>;
    var phi_405_: type_12;
    var phi_410_: type_12;
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
    if (_e51.member == 0u) {
        phi_102_ = array<u32, 2>(0u, 2u);
    } else {
        phi_102_ = array<u32, 2>(1u, 1u);
    }
    let _e55 = phi_102_;
    let _e61 = params.member.member.member[_e55[0]];
    let _e66 = params.member.member.member[_e55[1]];
    if (_e35 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    let _e74 = params.member.member_1.member;
    if (_e49 < _e74) {
        let _e81 = (2u * (((1u - _e51.member_5) * _e51.member_4) + _e49));
        let _e83 = front.member[_e81];
        let _e86 = front.member[(_e81 + 1u)];
        let _e89 = a_nodes.member[_e83];
        let _e91 = b_nodes.member[_e86];
        if ((((((_e89.member[0] <= _e91.member_2[0]) && (_e91.member[0] <= _e89.member_2[0])) && (_e89.member[1] <= _e91.member_2[1])) && (_e91.member[1] <= _e89.member_2[1])) && (_e89.member[2] <= _e91.member_2[2])) && (_e91.member[2] <= _e89.member_2[2])) {
            if (_e83 == 4294967295u) {
                phi_233_ = 0u;
            } else {
                if (_e83 >= (_e61 - 1u)) {
                    if (_e86 >= (_e66 - 1u)) {
                        phi_227_ = false;
                    } else {
                        phi_227_ = true;
                    }
                    let _e123 = phi_227_;
                    phi_228_ = _e123;
                } else {
                    phi_228_ = true;
                }
                let _e125 = phi_228_;
                if _e125 {
                    phi_232_ = 1u;
                } else {
                    phi_232_ = 2u;
                }
                let _e127 = phi_232_;
                phi_233_ = _e127;
            }
            let _e129 = phi_233_;
            phi_234_ = _e129;
        } else {
            phi_234_ = 3u;
        }
        let _e131 = phi_234_;
        phi_235_ = _e131;
        phi_236_ = array<u32, 2>(_e83, _e86);
    } else {
        phi_235_ = 0u;
        phi_236_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e133 = phi_235_;
    let _e135 = phi_236_;
    if (_e133 == 1u) {
        let _e145 = atomicAdd((&shared_[6u]), 1u);
        phi_254_ = array<u32, 2>(_e145, 0u);
    } else {
        if (_e133 == 2u) {
            let _e140 = atomicAdd((&shared_[7u]), 1u);
            phi_253_ = array<u32, 2>(_e140, 0u);
        } else {
            phi_253_ = array<u32, 2>(0u, 0u);
        }
        let _e143 = phi_253_;
        phi_254_ = _e143;
    }
    let _e148 = phi_254_;
    if (_e133 >= 2u) {
        if (_e51.member_4 > 0u) {
            let _e152 = atomicAdd((&shared_[8u]), 1u);
            phi_266_ = array<u32, 2>(_e148[0], _e152);
        } else {
            phi_266_ = _e148;
        }
        let _e156 = phi_266_;
        phi_267_ = _e156;
    } else {
        phi_267_ = _e148;
    }
    let _e158 = phi_267_;
    workgroupBarrier();
    if (_e35 == 0u) {
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
    if (_e133 == 1u) {
        let _e258 = atomicLoad((&shared_[11u]));
        let _e260 = (_e258 + _e158[0]);
        if (_e260 < _e51.member_3) {
            if (_e260 < 4294967295u) {
                let _e266 = (2u * _e260);
                atomicStore((&nodes.member[(4u + _e266)]), _e135[0]);
                atomicStore((&nodes.member[(_e266 + 5u)]), _e135[1]);
            }
        }
    } else {
        if (_e133 == 0u) {
        } else {
            if (_e133 == 2u) {
                let _e200 = a_nodes.member[_e135[0]];
                let _e204 = b_nodes.member[_e135[1]];
                let _e208 = params.member.member_2.member;
                if (_e208 == 1u) {
                    if (_e200.member_1 < _e204.member_1) {
                        phi_405_ = type_12(_e200.member_1, _e204.member_1);
                    } else {
                        phi_405_ = type_12(_e204.member_1, _e200.member_1);
                    }
                    let _e215 = phi_405_;
                    phi_410_ = _e215;
                } else {
                    phi_410_ = type_12(_e200.member_1, _e204.member_1);
                }
                let _e217 = phi_410_;
                let _e220 = params.member.member_1.member_3;
                let _e222 = atomicLoad((&shared_[12u]));
                let _e224 = (_e222 + _e158[0]);
                if (_e224 < _e220) {
                    let _e228 = (2u * _e224);
                    atomicStore((&pairs.member[(4u + _e228)]), _e217.member);
                    atomicStore((&pairs.member[(_e228 + 5u)]), _e217.member_1);
                }
            }
            let _e235 = params.member.member_2.member_4;
            if (_e235 > 0u) {
                let _e239 = atomicLoad((&shared_[13u]));
                let _e241 = (_e239 + _e158[1]);
                let _e243 = params.member.member_2.member_4;
                if (_e241 < _e243) {
                    let _e246 = params.member.member_2.member_5;
                    let _e248 = params.member.member_2.member_4;
                    let _e251 = (2u * ((_e246 * _e248) + _e241));
                    front.member[_e251] = _e135[0];
                    front.member[(_e251 + 1u)] = _e135[1];
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
