struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_29 {
    member: i32,
    member_1: i32,
}

struct type_30 {
    member: u32,
    member_1: i32,
}

struct type_31 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
var<workgroup> shared_: array<type_6, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_18;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: array<u32, 4>;
    var phi_121_: u32;
    var phi_122_: u32;
    var phi_139_: type_6;
    var phi_154_: type_29;
    var phi_157_: type_6;
    var phi_159_: u32;
    var phi_180_: bool;
    var phi_186_: type_30;
    var phi_155_: type_29;
    var phi_200_: type_30;
    var phi_250_: type_31;
    var phi_251_: type_31;
    var phi_274_: type_31;
    var phi_300_: f32;
    var phi_327_: f32;
    var phi_359_: type_6;
    var phi_158_: type_6;
    var phi_160_: u32;
    var local_3: type_6;

    let _e37 = id_1;
    let _e38 = n_1;
    let _e39 = lane_1;
    let _e43 = params.member.member_9;
    if (_e43 < 8u) {
    } else {
        return;
    }
    let _e47 = params.member.member_18[_e43];
    local_2 = array<u32, 4>(_e47[0], _e47[1], _e47[2], _e47[3]);
    let _e54 = local_2[0u];
    let _e62 = ((_e54 + (((_e37.y * _e38.x) + _e37.x) * 256u)) + _e39);
    let _e64 = local_2[2u];
    if (_e62 >= _e64) {
        phi_122_ = 2u;
    } else {
        let _e67 = local_2[1u];
        if (_e62 >= _e67) {
            phi_121_ = 1u;
        } else {
            phi_121_ = 0u;
        }
        let _e70 = phi_121_;
        phi_122_ = _e70;
    }
    let _e72 = phi_122_;
    let _e74 = local_2[3u];
    let _e75 = (_e62 < _e74);
    if _e75 {
        let _e77 = nodes.member[_e62];
        phi_139_ = _e77;
    } else {
        phi_139_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e79 = phi_139_;
    shared_[_e39] = type_6(array<f32, 3>(_e79.member[0], _e79.member[1], _e79.member[2]), array<f32, 3>(_e79.member_1[0], _e79.member_1[1], _e79.member_1[2]));
    phi_154_ = type_29(0i, 5i);
    phi_157_ = _e79;
    phi_159_ = 16u;
    loop {
        let _e93 = phi_154_;
        let _e95 = phi_157_;
        let _e97 = phi_159_;
        local_3 = _e95;
        if (_e93.member < _e93.member_1) {
            let _e105 = (_e93.member + 1i);
            if ((false == (_e105 > _e93.member)) != false) {
                phi_180_ = true;
            } else {
                phi_180_ = false;
            }
            let _e110 = phi_180_;
            if _e110 {
                phi_186_ = type_30(0u, type_30().member_1);
            } else {
                phi_186_ = type_30(1u, _e105);
            }
            let _e116 = phi_186_;
            if (bitcast<i32>(_e116.member) != 0i) {
            } else {
                return;
            }
            phi_155_ = type_29(_e116.member_1, _e93.member_1);
            phi_200_ = type_30(1u, _e93.member);
        } else {
            phi_155_ = _e93;
            phi_200_ = type_30(0u, type_30().member_1);
        }
        let _e126 = phi_155_;
        let _e128 = phi_200_;
        let _e131 = (bitcast<i32>(_e128.member) != 0i);
        if _e131 {
            workgroupBarrier();
            if ((_e39 % 32u) < _e97) {
                let _e136 = shared_[(_e39 + _e97)];
                local_1 = _e136;
                local = type_6(array<f32, 3>(_e95.member[0], _e95.member[1], _e95.member[2]), array<f32, 3>(_e95.member_1[0], _e95.member_1[1], _e95.member_1[2]));
                phi_250_ = type_31(0u, 3u);
                loop {
                    let _e149 = phi_250_;
                    if (_e149.member < _e149.member_1) {
                        phi_251_ = type_31((_e149.member + 1u), _e149.member_1);
                        phi_274_ = type_31(1u, _e149.member);
                    } else {
                        phi_251_ = _e149;
                        phi_274_ = type_31(0u, type_31().member_1);
                    }
                    let _e163 = phi_251_;
                    let _e165 = phi_274_;
                    let _e169 = (bitcast<i32>(_e165.member) != 0i);
                    if _e169 {
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e173 = local.member[_e165.member_1];
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e177 = local_1.member[_e165.member_1];
                        if (_e173 < _e177) {
                            phi_300_ = _e173;
                        } else {
                            phi_300_ = _e177;
                        }
                        let _e180 = phi_300_;
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member[_e165.member_1] = _e180;
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e187 = local.member_1[_e165.member_1];
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e191 = local_1.member_1[_e165.member_1];
                        if (_e187 > _e191) {
                            phi_327_ = _e187;
                        } else {
                            phi_327_ = _e191;
                        }
                        let _e194 = phi_327_;
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member_1[_e165.member_1] = _e194;
                    }
                    continue;
                    continuing {
                        phi_250_ = _e163;
                        break if !(_e169);
                    }
                }
                let _e199 = local;
                shared_[_e39] = _e199;
                phi_359_ = type_6(array<f32, 3>(_e199.member[0], _e199.member[1], _e199.member[2]), array<f32, 3>(_e199.member_1[0], _e199.member_1[1], _e199.member_1[2]));
            } else {
                phi_359_ = _e95;
            }
            let _e213 = phi_359_;
            phi_158_ = _e213;
            phi_160_ = (_e97 / 2u);
        } else {
            phi_158_ = type_6();
            phi_160_ = u32();
        }
        let _e216 = phi_158_;
        let _e218 = phi_160_;
        continue;
        continuing {
            phi_154_ = _e126;
            phi_157_ = _e216;
            phi_159_ = _e218;
            break if !(_e131);
        }
    }
    if _e75 {
        if ((_e39 % 32u) == 0u) {
            let _e223 = params.member.member_9;
            let _e224 = (_e223 + 1u);
            if (_e72 < 4u) {
            } else {
                return;
            }
            let _e227 = local_2[_e72];
            if (_e224 < 8u) {
            } else {
                return;
            }
            if (_e72 < 4u) {
            } else {
                return;
            }
            let _e235 = params.member.member_18[_e224][_e72];
            let _e239 = local_3;
            nodes.member[(_e235 + ((_e62 - _e227) / 32u))] = _e239;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
