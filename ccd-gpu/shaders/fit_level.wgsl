struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_30 {
    member: i32,
    member_1: i32,
}

struct type_31 {
    member: u32,
    member_1: i32,
}

struct type_32 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
var<workgroup> shared_: array<type_6, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_19;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: array<u32, 4>;
    var phi_122_: u32;
    var phi_123_: u32;
    var phi_140_: type_6;
    var phi_155_: type_30;
    var phi_158_: type_6;
    var phi_160_: u32;
    var phi_181_: bool;
    var phi_187_: type_31;
    var phi_156_: type_30;
    var phi_201_: type_31;
    var phi_251_: type_32;
    var phi_252_: type_32;
    var phi_275_: type_32;
    var phi_301_: f32;
    var phi_328_: f32;
    var phi_360_: type_6;
    var phi_159_: type_6;
    var phi_161_: u32;
    var local_3: type_6;

    let _e37 = id_1;
    let _e38 = n_1;
    let _e39 = lane_1;
    let _e43 = params.member.member_9;
    if (_e43 < 8u) {
    } else {
        return;
    }
    let _e47 = params.member.member_20[_e43];
    local_2 = array<u32, 4>(_e47[0], _e47[1], _e47[2], _e47[3]);
    let _e54 = local_2[0u];
    let _e62 = ((_e54 + (((_e37.y * _e38.x) + _e37.x) * 256u)) + _e39);
    let _e64 = local_2[2u];
    if (_e62 >= _e64) {
        phi_123_ = 2u;
    } else {
        let _e67 = local_2[1u];
        if (_e62 >= _e67) {
            phi_122_ = 1u;
        } else {
            phi_122_ = 0u;
        }
        let _e70 = phi_122_;
        phi_123_ = _e70;
    }
    let _e72 = phi_123_;
    let _e74 = local_2[3u];
    let _e75 = (_e62 < _e74);
    if _e75 {
        let _e77 = nodes.member[_e62];
        phi_140_ = _e77;
    } else {
        phi_140_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e79 = phi_140_;
    shared_[_e39] = type_6(array<f32, 3>(_e79.member[0], _e79.member[1], _e79.member[2]), array<f32, 3>(_e79.member_1[0], _e79.member_1[1], _e79.member_1[2]));
    phi_155_ = type_30(0i, 5i);
    phi_158_ = _e79;
    phi_160_ = 16u;
    loop {
        let _e93 = phi_155_;
        let _e95 = phi_158_;
        let _e97 = phi_160_;
        local_3 = _e95;
        if (_e93.member < _e93.member_1) {
            let _e105 = (_e93.member + 1i);
            if ((false == (_e105 > _e93.member)) != false) {
                phi_181_ = true;
            } else {
                phi_181_ = false;
            }
            let _e110 = phi_181_;
            if _e110 {
                phi_187_ = type_31(0u, type_31().member_1);
            } else {
                phi_187_ = type_31(1u, _e105);
            }
            let _e116 = phi_187_;
            if (bitcast<i32>(_e116.member) != 0i) {
            } else {
                return;
            }
            phi_156_ = type_30(_e116.member_1, _e93.member_1);
            phi_201_ = type_31(1u, _e93.member);
        } else {
            phi_156_ = _e93;
            phi_201_ = type_31(0u, type_31().member_1);
        }
        let _e126 = phi_156_;
        let _e128 = phi_201_;
        let _e131 = (bitcast<i32>(_e128.member) != 0i);
        if _e131 {
            workgroupBarrier();
            if ((_e39 % 32u) < _e97) {
                let _e136 = shared_[(_e39 + _e97)];
                local_1 = _e136;
                local = type_6(array<f32, 3>(_e95.member[0], _e95.member[1], _e95.member[2]), array<f32, 3>(_e95.member_1[0], _e95.member_1[1], _e95.member_1[2]));
                phi_251_ = type_32(0u, 3u);
                loop {
                    let _e149 = phi_251_;
                    if (_e149.member < _e149.member_1) {
                        phi_252_ = type_32((_e149.member + 1u), _e149.member_1);
                        phi_275_ = type_32(1u, _e149.member);
                    } else {
                        phi_252_ = _e149;
                        phi_275_ = type_32(0u, type_32().member_1);
                    }
                    let _e163 = phi_252_;
                    let _e165 = phi_275_;
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
                            phi_301_ = _e173;
                        } else {
                            phi_301_ = _e177;
                        }
                        let _e180 = phi_301_;
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
                            phi_328_ = _e187;
                        } else {
                            phi_328_ = _e191;
                        }
                        let _e194 = phi_328_;
                        if (_e165.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member_1[_e165.member_1] = _e194;
                    }
                    continue;
                    continuing {
                        phi_251_ = _e163;
                        break if !(_e169);
                    }
                }
                let _e199 = local;
                shared_[_e39] = _e199;
                phi_360_ = type_6(array<f32, 3>(_e199.member[0], _e199.member[1], _e199.member[2]), array<f32, 3>(_e199.member_1[0], _e199.member_1[1], _e199.member_1[2]));
            } else {
                phi_360_ = _e95;
            }
            let _e213 = phi_360_;
            phi_159_ = _e213;
            phi_161_ = (_e97 / 2u);
        } else {
            phi_159_ = type_6();
            phi_161_ = u32();
        }
        let _e216 = phi_159_;
        let _e218 = phi_161_;
        continue;
        continuing {
            phi_155_ = _e126;
            phi_158_ = _e216;
            phi_160_ = _e218;
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
            let _e235 = params.member.member_20[_e224][_e72];
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
