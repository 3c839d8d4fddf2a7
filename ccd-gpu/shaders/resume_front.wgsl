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
    member_18: u32,
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
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_22;
@group(0) @binding(1) 
var<storage> a: type_16;
@group(0) @binding(2) 
var<storage> b: type_16;
@group(0) @binding(3) 
var<storage, read_write> control: type_22;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_22;
var<workgroup> shared_: array<atomic<u32>, 22>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_202_: array<u32, 2>;
    var phi_291_: array<u32, 2>;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_332_: u32;
    var phi_333_: u32;
    var phi_335_: u32;
    var phi_336_: u32;
    var phi_354_: array<u32, 2>;
    var phi_355_: array<u32, 2>;
    var phi_367_: array<u32, 2>;
    var phi_368_: array<u32, 2>;
    var phi_526_: type_9;
    var phi_531_: type_9;
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
    let _e53 = params.member.member_1;
    if (_e49 < _e53.member) {
        let _e61 = (2u * (((1u - _e51.member_5) * _e51.member_4) + _e49));
        let _e63 = front.member[_e61];
        let _e66 = front.member[(_e61 + 1u)];
        phi_202_ = array<u32, 2>(_e63, _e66);
    } else {
        phi_202_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e69 = phi_202_;
    if (_e35 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e69[0] != 4294967295u) {
        let _e78 = a.member[_e69[0]];
        let _e81 = b.member[_e69[1]];
        if ((((((_e78.member[0] <= _e81.member_2[0]) && (_e81.member[0] <= _e78.member_2[0])) && (_e78.member[1] <= _e81.member_2[1])) && (_e81.member[1] <= _e78.member_2[1])) && (_e78.member[2] <= _e81.member_2[2])) && (_e81.member[2] <= _e78.member_2[2])) {
            let _e111 = params.member.member_2.member;
            if (_e111 == 0u) {
                phi_291_ = array<u32, 2>(0u, 2u);
            } else {
                phi_291_ = array<u32, 2>(1u, 1u);
            }
            let _e114 = phi_291_;
            let _e120 = params.member.member.member[_e114[0]];
            let _e125 = params.member.member.member[_e114[1]];
            if (_e69[0] == 4294967295u) {
                phi_333_ = 0u;
            } else {
                if (_e69[0] >= (_e120 - 1u)) {
                    if (_e69[1] >= (_e125 - 1u)) {
                        phi_327_ = false;
                    } else {
                        phi_327_ = true;
                    }
                    let _e134 = phi_327_;
                    phi_328_ = _e134;
                } else {
                    phi_328_ = true;
                }
                let _e136 = phi_328_;
                if _e136 {
                    phi_332_ = 1u;
                } else {
                    phi_332_ = 2u;
                }
                let _e138 = phi_332_;
                phi_333_ = _e138;
            }
            let _e140 = phi_333_;
            phi_335_ = _e140;
        } else {
            phi_335_ = 3u;
        }
        let _e142 = phi_335_;
        phi_336_ = _e142;
    } else {
        phi_336_ = 0u;
    }
    let _e144 = phi_336_;
    if (_e144 == 1u) {
        let _e154 = atomicAdd((&shared_[6u]), 1u);
        phi_355_ = array<u32, 2>(_e154, 0u);
    } else {
        if (_e144 == 2u) {
            let _e149 = atomicAdd((&shared_[7u]), 1u);
            phi_354_ = array<u32, 2>(_e149, 0u);
        } else {
            phi_354_ = array<u32, 2>(0u, 0u);
        }
        let _e152 = phi_354_;
        phi_355_ = _e152;
    }
    let _e157 = phi_355_;
    if (_e144 >= 2u) {
        if (_e51.member_4 > 0u) {
            let _e161 = atomicAdd((&shared_[8u]), 1u);
            phi_367_ = array<u32, 2>(_e157[0], _e161);
        } else {
            phi_367_ = _e157;
        }
        let _e165 = phi_367_;
        phi_368_ = _e165;
    } else {
        phi_368_ = _e157;
    }
    let _e167 = phi_368_;
    workgroupBarrier();
    if (_e35 == 0u) {
        let _e170 = atomicLoad((&shared_[6u]));
        let _e172 = atomicLoad((&shared_[7u]));
        if (_e170 > 0u) {
            let _e175 = atomicAdd((&control.member[0u]), _e170);
            let _e178 = atomicMax((&nodes.member[0u]), (_e175 + _e170));
            if ((_e175 + _e170) < _e175) {
                let _e182 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e175);
        }
        if (_e172 > 0u) {
            let _e186 = atomicAdd((&pairs.member[0u]), _e172);
            if ((_e186 + _e172) < _e186) {
                let _e190 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e186);
        }
        let _e193 = atomicLoad((&shared_[8u]));
        if (_e193 > 0u) {
            let _e196 = atomicLoad((&shared_[8u]));
            let _e198 = atomicAdd((&control.member[1537u]), _e196);
            if ((_e198 + _e196) < _e198) {
                let _e202 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e198);
        }
    }
    workgroupBarrier();
    if (_e144 == 1u) {
        let _e261 = atomicLoad((&shared_[11u]));
        let _e263 = (_e261 + _e167[0]);
        if (_e263 < _e51.member_3) {
            if (_e263 < 4294967295u) {
                let _e269 = (2u * _e263);
                atomicStore((&nodes.member[(4u + _e269)]), _e69[0]);
                atomicStore((&nodes.member[(_e269 + 5u)]), _e69[1]);
            }
        }
    } else {
        if (_e144 == 0u) {
        } else {
            if (_e144 == 2u) {
                let _e209 = a.member[_e69[0]];
                let _e213 = b.member[_e69[1]];
                let _e217 = params.member.member_2.member;
                if (_e217 == 1u) {
                    if (_e209.member_1 < _e213.member_1) {
                        phi_526_ = type_9(_e209.member_1, _e213.member_1);
                    } else {
                        phi_526_ = type_9(_e213.member_1, _e209.member_1);
                    }
                    let _e224 = phi_526_;
                    phi_531_ = _e224;
                } else {
                    phi_531_ = type_9(_e209.member_1, _e213.member_1);
                }
                let _e226 = phi_531_;
                let _e230 = params.member.member_1;
                let _e233 = atomicLoad((&shared_[12u]));
                let _e235 = (_e233 + _e167[0]);
                if (_e235 < _e230.member_3) {
                    let _e237 = (2u * _e235);
                    atomicStore((&pairs.member[(4u + _e237)]), _e226.member);
                    atomicStore((&pairs.member[(_e237 + 5u)]), _e226.member_1);
                }
            }
            if (_e51.member_4 > 0u) {
                let _e245 = atomicLoad((&shared_[13u]));
                let _e247 = (_e245 + _e167[1]);
                if (_e247 < _e51.member_4) {
                    let _e254 = (2u * ((_e51.member_5 * _e51.member_4) + _e247));
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
