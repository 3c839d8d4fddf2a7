struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_22 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> boxes: type_13;
var<workgroup> shared_: array<type_11, 256>;
@group(0) @binding(2) 
var<storage, read_write> words: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_11;
    var phi_98_: type_19;
    var phi_101_: type_11;
    var phi_99_: type_19;
    var phi_124_: type_19;
    var phi_154_: f32;
    var phi_161_: f32;
    var phi_168_: f32;
    var phi_176_: f32;
    var phi_183_: f32;
    var phi_190_: f32;
    var phi_193_: type_11;
    var phi_102_: type_11;
    var local_1: type_11;
    var local_2: type_11;
    var local_3: type_11;
    var local_4: type_11;
    var phi_231_: type_17;
    var phi_234_: u32;
    var phi_255_: bool;
    var phi_261_: type_18;
    var phi_232_: type_17;
    var phi_275_: type_18;
    var phi_307_: f32;
    var phi_315_: f32;
    var phi_323_: f32;
    var phi_333_: f32;
    var phi_342_: f32;
    var phi_351_: f32;
    var phi_235_: u32;
    var phi_396_: type_19;
    var phi_397_: type_19;
    var phi_420_: type_19;
    var phi_466_: u32;
    var phi_447_: u32;
    var phi_467_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e43 = params.member.member_17;
    phi_98_ = type_19(0u, 8u);
    phi_101_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e45 = phi_98_;
        let _e47 = phi_101_;
        local_1 = _e47;
        local_2 = _e47;
        local_3 = _e47;
        local_4 = _e47;
        if (_e45.member < _e45.member_1) {
            phi_99_ = type_19((_e45.member + 1u), _e45.member_1);
            phi_124_ = type_19(1u, _e45.member);
        } else {
            phi_99_ = _e45;
            phi_124_ = type_19(0u, type_19().member_1);
        }
        let _e59 = phi_99_;
        let _e61 = phi_124_;
        let _e65 = (bitcast<i32>(_e61.member) != 0i);
        if _e65 {
            let _e67 = (((((_e29.y * _e30.x) + _e29.x) * 2048u) + _e31) + (_e61.member_1 * 256u));
            if (_e67 < _e43) {
                let _e70 = boxes.member[_e67];
                if (_e47.member[0] < _e70.member[0]) {
                    phi_154_ = _e47.member[0];
                } else {
                    phi_154_ = _e70.member[0];
                }
                let _e77 = phi_154_;
                if (_e47.member[1] < _e70.member[1]) {
                    phi_161_ = _e47.member[1];
                } else {
                    phi_161_ = _e70.member[1];
                }
                let _e84 = phi_161_;
                if (_e47.member[2] < _e70.member[2]) {
                    phi_168_ = _e47.member[2];
                } else {
                    phi_168_ = _e70.member[2];
                }
                let _e91 = phi_168_;
                if (_e47.member_1[0] > _e70.member_1[0]) {
                    phi_176_ = _e47.member_1[0];
                } else {
                    phi_176_ = _e70.member_1[0];
                }
                let _e99 = phi_176_;
                if (_e47.member_1[1] > _e70.member_1[1]) {
                    phi_183_ = _e47.member_1[1];
                } else {
                    phi_183_ = _e70.member_1[1];
                }
                let _e106 = phi_183_;
                if (_e47.member_1[2] > _e70.member_1[2]) {
                    phi_190_ = _e47.member_1[2];
                } else {
                    phi_190_ = _e70.member_1[2];
                }
                let _e113 = phi_190_;
                phi_193_ = type_11(array<f32, 3>(_e77, _e84, _e91), array<f32, 3>(_e99, _e106, _e113));
            } else {
                phi_193_ = _e47;
            }
            let _e117 = phi_193_;
            phi_102_ = _e117;
        } else {
            phi_102_ = type_11();
        }
        let _e119 = phi_102_;
        continue;
        continuing {
            phi_98_ = _e59;
            phi_101_ = _e119;
            break if !(_e65);
        }
    }
    let _e122 = local_1;
    let _e129 = local_2;
    local = type_11(array<f32, 3>(_e122.member[0], _e122.member[1], _e122.member[2]), array<f32, 3>(_e129.member_1[0], _e129.member_1[1], _e129.member_1[2]));
    let _e138 = local_3;
    let _e145 = local_4;
    shared_[_e31] = type_11(array<f32, 3>(_e138.member[0], _e138.member[1], _e138.member[2]), array<f32, 3>(_e145.member_1[0], _e145.member_1[1], _e145.member_1[2]));
    phi_231_ = type_17(0i, 8i);
    phi_234_ = 128u;
    loop {
        let _e153 = phi_231_;
        let _e155 = phi_234_;
        if (_e153.member < _e153.member_1) {
            let _e162 = (_e153.member + 1i);
            if ((false == (_e162 > _e153.member)) != false) {
                phi_255_ = true;
            } else {
                phi_255_ = false;
            }
            let _e167 = phi_255_;
            if _e167 {
                phi_261_ = type_18(0u, type_18().member_1);
            } else {
                phi_261_ = type_18(1u, _e162);
            }
            let _e172 = phi_261_;
            phi_232_ = type_17(_e172.member_1, _e153.member_1);
            phi_275_ = type_18(1u, _e153.member);
        } else {
            phi_232_ = _e153;
            phi_275_ = type_18(0u, type_18().member_1);
        }
        let _e178 = phi_232_;
        let _e180 = phi_275_;
        let _e183 = (bitcast<i32>(_e180.member) != 0i);
        if _e183 {
            workgroupBarrier();
            if (_e31 < _e155) {
                let _e187 = shared_[(_e31 + _e155)];
                let _e198 = local.member[0u];
                if (_e198 < _e187.member[0]) {
                    phi_307_ = _e198;
                } else {
                    phi_307_ = _e187.member[0];
                }
                let _e201 = phi_307_;
                let _e204 = local.member[1u];
                if (_e204 < _e187.member[1]) {
                    phi_315_ = _e204;
                } else {
                    phi_315_ = _e187.member[1];
                }
                let _e207 = phi_315_;
                let _e210 = local.member[2u];
                if (_e210 < _e187.member[2]) {
                    phi_323_ = _e210;
                } else {
                    phi_323_ = _e187.member[2];
                }
                let _e213 = phi_323_;
                let _e216 = local.member_1[0u];
                if (_e216 > _e187.member_1[0]) {
                    phi_333_ = _e216;
                } else {
                    phi_333_ = _e187.member_1[0];
                }
                let _e219 = phi_333_;
                let _e222 = local.member_1[1u];
                if (_e222 > _e187.member_1[1]) {
                    phi_342_ = _e222;
                } else {
                    phi_342_ = _e187.member_1[1];
                }
                let _e225 = phi_342_;
                let _e228 = local.member_1[2u];
                if (_e228 > _e187.member_1[2]) {
                    phi_351_ = _e228;
                } else {
                    phi_351_ = _e187.member_1[2];
                }
                let _e231 = phi_351_;
                local = type_11(array<f32, 3>(_e201, _e207, _e213), array<f32, 3>(_e219, _e225, _e231));
                shared_[_e31] = type_11(array<f32, 3>(_e201, _e207, _e213), array<f32, 3>(_e219, _e225, _e231));
            }
            phi_235_ = (_e155 / 2u);
        } else {
            phi_235_ = u32();
        }
        let _e241 = phi_235_;
        continue;
        continuing {
            phi_231_ = _e178;
            phi_234_ = _e241;
            break if !(_e183);
        }
    }
    if (_e31 == 0u) {
        phi_396_ = type_19(0u, 6u);
        loop {
            let _e245 = phi_396_;
            if (_e245.member < _e245.member_1) {
                phi_397_ = type_19((_e245.member + 1u), _e245.member_1);
                phi_420_ = type_19(1u, _e245.member);
            } else {
                phi_397_ = _e245;
                phi_420_ = type_19(0u, type_19().member_1);
            }
            let _e257 = phi_397_;
            let _e259 = phi_420_;
            let _e263 = (bitcast<i32>(_e259.member) != 0i);
            if _e263 {
                if (_e259.member_1 < 3u) {
                    let _e279 = local.member[_e259.member_1];
                    let _e280 = bitcast<u32>(_e279);
                    if ((_e280 >> bitcast<u32>(31i)) == 1u) {
                        phi_447_ = ~(_e280);
                    } else {
                        phi_447_ = (_e280 | 2147483648u);
                    }
                    let _e287 = phi_447_;
                    phi_467_ = ~(_e287);
                } else {
                    let _e268 = local.member_1[(_e259.member_1 - 3u)];
                    let _e269 = bitcast<u32>(_e268);
                    if ((_e269 >> bitcast<u32>(31i)) == 1u) {
                        phi_466_ = ~(_e269);
                    } else {
                        phi_466_ = (_e269 | 2147483648u);
                    }
                    let _e276 = phi_466_;
                    phi_467_ = _e276;
                }
                let _e290 = phi_467_;
                let _e292 = atomicMax((&words.member[_e259.member_1]), _e290);
            }
            continue;
            continuing {
                phi_396_ = _e257;
                break if !(_e263);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scene_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
