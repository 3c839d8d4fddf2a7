struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
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

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
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

@group(0) @binding(0) 
var<storage> params: type_11;
var<workgroup> shared_: array<type_4, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: array<u32, 4>;
    var phi_122_: u32;
    var phi_123_: u32;
    var phi_140_: type_4;
    var phi_155_: type_17;
    var phi_158_: type_4;
    var phi_160_: u32;
    var phi_181_: bool;
    var phi_187_: type_18;
    var phi_156_: type_17;
    var phi_201_: type_18;
    var phi_251_: type_19;
    var phi_252_: type_19;
    var phi_275_: type_19;
    var phi_301_: f32;
    var phi_328_: f32;
    var phi_360_: type_4;
    var phi_159_: type_4;
    var phi_161_: u32;
    var local_3: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e27 = id_2;
    let _e28 = n_2;
    let _e29 = lane_2;
    let _e33 = params.member.member_9;
    let _e36 = params.member.member_20[_e33];
    local_2 = array<u32, 4>(_e36[0], _e36[1], _e36[2], _e36[3]);
    let _e43 = local_2[0u];
    let _e51 = ((_e43 + (((_e27.y * _e28.x) + _e27.x) * 256u)) + _e29);
    let _e53 = local_2[2u];
    if (_e51 >= _e53) {
        phi_123_ = 2u;
    } else {
        let _e56 = local_2[1u];
        if (_e51 >= _e56) {
            phi_122_ = 1u;
        } else {
            phi_122_ = 0u;
        }
        let _e59 = phi_122_;
        phi_123_ = _e59;
    }
    let _e61 = phi_123_;
    let _e63 = local_2[3u];
    let _e64 = (_e51 < _e63);
    if _e64 {
        let _e66 = nodes.member[_e51];
        phi_140_ = _e66;
    } else {
        phi_140_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e68 = phi_140_;
    shared_[_e29] = type_4(array<f32, 3>(_e68.member[0], _e68.member[1], _e68.member[2]), array<f32, 3>(_e68.member_1[0], _e68.member_1[1], _e68.member_1[2]));
    phi_155_ = type_17(0i, 5i);
    phi_158_ = _e68;
    phi_160_ = 16u;
    loop {
        let _e82 = phi_155_;
        let _e84 = phi_158_;
        let _e86 = phi_160_;
        local_3 = _e84;
        if (_e82.member < _e82.member_1) {
            let _e93 = (_e82.member + 1i);
            if ((false == (_e93 > _e82.member)) != false) {
                phi_181_ = true;
            } else {
                phi_181_ = false;
            }
            let _e98 = phi_181_;
            if _e98 {
                phi_187_ = type_18(0u, type_18().member_1);
            } else {
                phi_187_ = type_18(1u, _e93);
            }
            let _e103 = phi_187_;
            phi_156_ = type_17(_e103.member_1, _e82.member_1);
            phi_201_ = type_18(1u, _e82.member);
        } else {
            phi_156_ = _e82;
            phi_201_ = type_18(0u, type_18().member_1);
        }
        let _e109 = phi_156_;
        let _e111 = phi_201_;
        let _e114 = (bitcast<i32>(_e111.member) != 0i);
        if _e114 {
            workgroupBarrier();
            if ((_e29 % 32u) < _e86) {
                let _e119 = shared_[(_e29 + _e86)];
                local_1 = _e119;
                local = type_4(array<f32, 3>(_e84.member[0], _e84.member[1], _e84.member[2]), array<f32, 3>(_e84.member_1[0], _e84.member_1[1], _e84.member_1[2]));
                phi_251_ = type_19(0u, 3u);
                loop {
                    let _e132 = phi_251_;
                    if (_e132.member < _e132.member_1) {
                        phi_252_ = type_19((_e132.member + 1u), _e132.member_1);
                        phi_275_ = type_19(1u, _e132.member);
                    } else {
                        phi_252_ = _e132;
                        phi_275_ = type_19(0u, type_19().member_1);
                    }
                    let _e144 = phi_252_;
                    let _e146 = phi_275_;
                    let _e150 = (bitcast<i32>(_e146.member) != 0i);
                    if _e150 {
                        let _e153 = local.member[_e146.member_1];
                        let _e156 = local_1.member[_e146.member_1];
                        if (_e153 < _e156) {
                            phi_301_ = _e153;
                        } else {
                            phi_301_ = _e156;
                        }
                        let _e159 = phi_301_;
                        local.member[_e146.member_1] = _e159;
                        let _e164 = local.member_1[_e146.member_1];
                        let _e167 = local_1.member_1[_e146.member_1];
                        if (_e164 > _e167) {
                            phi_328_ = _e164;
                        } else {
                            phi_328_ = _e167;
                        }
                        let _e170 = phi_328_;
                        local.member_1[_e146.member_1] = _e170;
                    }
                    continue;
                    continuing {
                        phi_251_ = _e144;
                        break if !(_e150);
                    }
                }
                let _e174 = local;
                shared_[_e29] = _e174;
                phi_360_ = type_4(array<f32, 3>(_e174.member[0], _e174.member[1], _e174.member[2]), array<f32, 3>(_e174.member_1[0], _e174.member_1[1], _e174.member_1[2]));
            } else {
                phi_360_ = _e84;
            }
            let _e188 = phi_360_;
            phi_159_ = _e188;
            phi_161_ = (_e86 / 2u);
        } else {
            phi_159_ = type_4();
            phi_161_ = u32();
        }
        let _e191 = phi_159_;
        let _e193 = phi_161_;
        continue;
        continuing {
            phi_155_ = _e109;
            phi_158_ = _e191;
            phi_160_ = _e193;
            break if !(_e114);
        }
    }
    if _e64 {
        if ((_e29 % 32u) == 0u) {
            let _e198 = params.member.member_9;
            let _e201 = local_2[_e61];
            let _e207 = params.member.member_20[(_e198 + 1u)][_e61];
            let _e211 = local_3;
            nodes.member[(_e207 + ((_e51 - _e201) / 32u))] = _e211;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
