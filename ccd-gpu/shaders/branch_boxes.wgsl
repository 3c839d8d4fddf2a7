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

struct type_21 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_24 {
    member: array<type_21>,
}

struct type_32 {
    member: u32,
    member_1: u32,
}

struct type_36 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_44 {
    member: array<type_41>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> branches: type_39;
@group(0) @binding(2) 
var<storage> block_nodes: type_19;
@group(0) @binding(3) 
var<storage> leaves: type_24;
@group(0) @binding(4) 
var<storage, read_write> out: type_44;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_6;
    var phi_128_: type_32;
    var phi_131_: type_6;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_129_: type_32;
    var phi_158_: type_32;
    var phi_177_: u32;
    var phi_187_: bool;
    var phi_191_: u32;
    var phi_192_: u32;
    var phi_195_: type_32;
    var phi_198_: type_6;
    var phi_196_: type_32;
    var phi_221_: type_32;
    var phi_278_: type_32;
    var phi_279_: type_32;
    var phi_302_: type_32;
    var phi_328_: f32;
    var phi_355_: f32;
    var phi_199_: type_6;
    var phi_377_: type_32;
    var phi_380_: type_6;
    var phi_378_: type_32;
    var phi_403_: type_32;
    var phi_460_: type_32;
    var phi_461_: type_32;
    var phi_484_: type_32;
    var phi_510_: f32;
    var phi_537_: f32;
    var phi_381_: type_6;
    var phi_561_: u32;
    var phi_566_: u32;
    var phi_132_: type_6;
    var phi_134_: u32;
    var phi_136_: u32;
    var local_4: type_6;
    var local_5: type_6;
    var local_6: type_6;
    var local_7: type_6;

    let _e35 = id_1;
    let _e36 = n_1;
    let _e37 = lane_1;
    let _e49 = ((((_e35.y * _e36.x) + _e35.x) * 256u) + _e37);
    let _e52 = params.member.member[1u];
    if ((_e49 + 1u) < _e52) {
        let _e56 = branches.member[_e49];
        phi_128_ = type_32(0u, 8u);
        phi_131_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_133_ = (_e56.member_3 + 1u);
        phi_135_ = _e56.member_2;
        loop {
            let _e61 = phi_128_;
            let _e63 = phi_131_;
            let _e65 = phi_133_;
            let _e67 = phi_135_;
            local_4 = _e63;
            local_5 = _e63;
            if (_e61.member < _e61.member_1) {
                phi_129_ = type_32((_e61.member + 1u), _e61.member_1);
                phi_158_ = type_32(1u, _e61.member);
            } else {
                phi_129_ = _e61;
                phi_158_ = type_32(0u, type_32().member_1);
            }
            let _e81 = phi_129_;
            let _e83 = phi_158_;
            let _e87 = (bitcast<i32>(_e83.member) != 0i);
            if _e87 {
                let _e88 = (_e67 % 32u);
                if (_e88 == 0u) {
                    phi_177_ = _e67;
                } else {
                    phi_177_ = (_e67 + (32u - _e88));
                }
                let _e93 = phi_177_;
                let _e95 = ((_e65 / 32u) * 32u);
                if (_e93 < _e95) {
                    let _e98 = params.member.member_9;
                    phi_187_ = (_e83.member_1 < _e98);
                } else {
                    phi_187_ = false;
                }
                let _e101 = phi_187_;
                if _e101 {
                    phi_191_ = _e95;
                    phi_192_ = _e93;
                } else {
                    phi_191_ = _e65;
                    phi_192_ = _e65;
                }
                let _e103 = phi_191_;
                let _e105 = phi_192_;
                phi_195_ = type_32(_e67, _e105);
                phi_198_ = _e63;
                loop {
                    let _e108 = phi_195_;
                    let _e110 = phi_198_;
                    local_6 = _e110;
                    if (_e108.member < _e108.member_1) {
                        phi_196_ = type_32((_e108.member + 1u), _e108.member_1);
                        phi_221_ = type_32(1u, _e108.member);
                    } else {
                        phi_196_ = _e108;
                        phi_221_ = type_32(0u, type_32().member_1);
                    }
                    let _e124 = phi_196_;
                    let _e126 = phi_221_;
                    let _e130 = (bitcast<i32>(_e126.member) != 0i);
                    if _e130 {
                        if (_e83.member_1 < 8u) {
                        } else {
                            return;
                        }
                        let _e135 = params.member.member_20[_e83.member_1][1u];
                        let _e138 = block_nodes.member[(_e135 + _e126.member_1)];
                        local_2 = type_6(array<f32, 3>(_e138.member[0], _e138.member[1], _e138.member[2]), array<f32, 3>(_e138.member_1[0], _e138.member_1[1], _e138.member_1[2]));
                        local_1 = type_6(array<f32, 3>(_e110.member[0], _e110.member[1], _e110.member[2]), array<f32, 3>(_e110.member_1[0], _e110.member_1[1], _e110.member_1[2]));
                        phi_278_ = type_32(0u, 3u);
                        loop {
                            let _e162 = phi_278_;
                            if (_e162.member < _e162.member_1) {
                                phi_279_ = type_32((_e162.member + 1u), _e162.member_1);
                                phi_302_ = type_32(1u, _e162.member);
                            } else {
                                phi_279_ = _e162;
                                phi_302_ = type_32(0u, type_32().member_1);
                            }
                            let _e176 = phi_279_;
                            let _e178 = phi_302_;
                            let _e182 = (bitcast<i32>(_e178.member) != 0i);
                            if _e182 {
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e186 = local_1.member[_e178.member_1];
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e190 = local_2.member[_e178.member_1];
                                if (_e186 < _e190) {
                                    phi_328_ = _e186;
                                } else {
                                    phi_328_ = _e190;
                                }
                                let _e193 = phi_328_;
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                local_1.member[_e178.member_1] = _e193;
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e200 = local_1.member_1[_e178.member_1];
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e204 = local_2.member_1[_e178.member_1];
                                if (_e200 > _e204) {
                                    phi_355_ = _e200;
                                } else {
                                    phi_355_ = _e204;
                                }
                                let _e207 = phi_355_;
                                if (_e178.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                local_1.member_1[_e178.member_1] = _e207;
                            }
                            continue;
                            continuing {
                                phi_278_ = _e176;
                                break if !(_e182);
                            }
                        }
                        let _e212 = local_1;
                        phi_199_ = type_6(array<f32, 3>(_e212.member[0], _e212.member[1], _e212.member[2]), array<f32, 3>(_e212.member_1[0], _e212.member_1[1], _e212.member_1[2]));
                    } else {
                        phi_199_ = type_6();
                    }
                    let _e225 = phi_199_;
                    continue;
                    continuing {
                        phi_195_ = _e124;
                        phi_198_ = _e225;
                        break if !(_e130);
                    }
                }
                phi_377_ = type_32(_e103, _e65);
                let _e411 = local_6;
                phi_380_ = _e411;
                loop {
                    let _e229 = phi_377_;
                    let _e231 = phi_380_;
                    local_7 = _e231;
                    if (_e229.member < _e229.member_1) {
                        phi_378_ = type_32((_e229.member + 1u), _e229.member_1);
                        phi_403_ = type_32(1u, _e229.member);
                    } else {
                        phi_378_ = _e229;
                        phi_403_ = type_32(0u, type_32().member_1);
                    }
                    let _e245 = phi_378_;
                    let _e247 = phi_403_;
                    let _e251 = (bitcast<i32>(_e247.member) != 0i);
                    if _e251 {
                        if (_e83.member_1 < 8u) {
                        } else {
                            return;
                        }
                        let _e256 = params.member.member_20[_e83.member_1][1u];
                        let _e259 = block_nodes.member[(_e256 + _e247.member_1)];
                        local_3 = type_6(array<f32, 3>(_e259.member[0], _e259.member[1], _e259.member[2]), array<f32, 3>(_e259.member_1[0], _e259.member_1[1], _e259.member_1[2]));
                        local = type_6(array<f32, 3>(_e231.member[0], _e231.member[1], _e231.member[2]), array<f32, 3>(_e231.member_1[0], _e231.member_1[1], _e231.member_1[2]));
                        phi_460_ = type_32(0u, 3u);
                        loop {
                            let _e283 = phi_460_;
                            if (_e283.member < _e283.member_1) {
                                phi_461_ = type_32((_e283.member + 1u), _e283.member_1);
                                phi_484_ = type_32(1u, _e283.member);
                            } else {
                                phi_461_ = _e283;
                                phi_484_ = type_32(0u, type_32().member_1);
                            }
                            let _e297 = phi_461_;
                            let _e299 = phi_484_;
                            let _e303 = (bitcast<i32>(_e299.member) != 0i);
                            if _e303 {
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e307 = local.member[_e299.member_1];
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e311 = local_3.member[_e299.member_1];
                                if (_e307 < _e311) {
                                    phi_510_ = _e307;
                                } else {
                                    phi_510_ = _e311;
                                }
                                let _e314 = phi_510_;
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                local.member[_e299.member_1] = _e314;
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e321 = local.member_1[_e299.member_1];
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                let _e325 = local_3.member_1[_e299.member_1];
                                if (_e321 > _e325) {
                                    phi_537_ = _e321;
                                } else {
                                    phi_537_ = _e325;
                                }
                                let _e328 = phi_537_;
                                if (_e299.member_1 < 3u) {
                                } else {
                                    return;
                                }
                                local.member_1[_e299.member_1] = _e328;
                            }
                            continue;
                            continuing {
                                phi_460_ = _e297;
                                break if !(_e303);
                            }
                        }
                        let _e333 = local;
                        phi_381_ = type_6(array<f32, 3>(_e333.member[0], _e333.member[1], _e333.member[2]), array<f32, 3>(_e333.member_1[0], _e333.member_1[1], _e333.member_1[2]));
                    } else {
                        phi_381_ = type_6();
                    }
                    let _e346 = phi_381_;
                    continue;
                    continuing {
                        phi_377_ = _e245;
                        phi_380_ = _e346;
                        break if !(_e251);
                    }
                }
                if _e101 {
                    phi_561_ = (_e93 / 32u);
                } else {
                    phi_561_ = 0u;
                }
                let _e350 = phi_561_;
                if _e101 {
                    phi_566_ = (_e95 / 32u);
                } else {
                    phi_566_ = 0u;
                }
                let _e353 = phi_566_;
                let _e424 = local_7;
                phi_132_ = _e424;
                phi_134_ = _e353;
                phi_136_ = _e350;
            } else {
                phi_132_ = type_6();
                phi_134_ = u32();
                phi_136_ = u32();
            }
            let _e355 = phi_132_;
            let _e357 = phi_134_;
            let _e359 = phi_136_;
            continue;
            continuing {
                phi_128_ = _e81;
                phi_131_ = _e355;
                phi_133_ = _e357;
                phi_135_ = _e359;
                break if !(_e87);
            }
        }
        let _e362 = local_4;
        let _e366 = local_5;
        out.member[_e49] = type_41(_e362.member, _e56.member, _e366.member_1, _e56.member_1);
    }
    if (_e49 < _e52) {
        let _e375 = params.member.member_20[0u][1u];
        let _e376 = (_e375 + _e49);
        let _e378 = block_nodes.member[_e376];
        let _e383 = leaves.member[_e376];
        out.member[((_e52 - 1u) + _e49)] = type_41(_e378.member, _e383.member_1, _e378.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
