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

struct type_14 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> branches: type_22;
@group(0) @binding(2) 
var<storage> block_nodes: type_13;
@group(0) @binding(3) 
var<storage> leaves: type_16;
@group(0) @binding(4) 
var<storage, read_write> out: type_25;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: type_4;
    var local_3: type_4;
    var phi_128_: type_19;
    var phi_131_: type_4;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_129_: type_19;
    var phi_158_: type_19;
    var phi_177_: u32;
    var phi_187_: bool;
    var phi_191_: u32;
    var phi_192_: u32;
    var phi_195_: type_19;
    var phi_198_: type_4;
    var phi_196_: type_19;
    var phi_221_: type_19;
    var phi_278_: type_19;
    var phi_279_: type_19;
    var phi_302_: type_19;
    var phi_328_: f32;
    var phi_355_: f32;
    var phi_199_: type_4;
    var phi_377_: type_19;
    var phi_380_: type_4;
    var phi_378_: type_19;
    var phi_403_: type_19;
    var phi_460_: type_19;
    var phi_461_: type_19;
    var phi_484_: type_19;
    var phi_510_: f32;
    var phi_537_: f32;
    var phi_381_: type_4;
    var phi_561_: u32;
    var phi_566_: u32;
    var phi_132_: type_4;
    var phi_134_: u32;
    var phi_136_: u32;
    var local_4: type_4;
    var local_5: type_4;
    var local_6: type_4;
    var local_7: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e25 = id_2;
    let _e26 = n_2;
    let _e27 = lane_2;
    let _e39 = ((((_e25.y * _e26.x) + _e25.x) * 256u) + _e27);
    let _e42 = params.member.member[1u];
    if ((_e39 + 1u) < _e42) {
        let _e46 = branches.member[_e39];
        phi_128_ = type_19(0u, 8u);
        phi_131_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_133_ = (_e46.member_3 + 1u);
        phi_135_ = _e46.member_2;
        loop {
            let _e51 = phi_128_;
            let _e53 = phi_131_;
            let _e55 = phi_133_;
            let _e57 = phi_135_;
            local_4 = _e53;
            local_5 = _e53;
            if (_e51.member < _e51.member_1) {
                phi_129_ = type_19((_e51.member + 1u), _e51.member_1);
                phi_158_ = type_19(1u, _e51.member);
            } else {
                phi_129_ = _e51;
                phi_158_ = type_19(0u, type_19().member_1);
            }
            let _e69 = phi_129_;
            let _e71 = phi_158_;
            let _e75 = (bitcast<i32>(_e71.member) != 0i);
            if _e75 {
                let _e76 = (_e57 % 32u);
                if (_e76 == 0u) {
                    phi_177_ = _e57;
                } else {
                    phi_177_ = (_e57 + (32u - _e76));
                }
                let _e81 = phi_177_;
                let _e83 = ((_e55 / 32u) * 32u);
                if (_e81 < _e83) {
                    let _e86 = params.member.member_9;
                    phi_187_ = (_e71.member_1 < _e86);
                } else {
                    phi_187_ = false;
                }
                let _e89 = phi_187_;
                if _e89 {
                    phi_191_ = _e83;
                    phi_192_ = _e81;
                } else {
                    phi_191_ = _e55;
                    phi_192_ = _e55;
                }
                let _e91 = phi_191_;
                let _e93 = phi_192_;
                phi_195_ = type_19(_e57, _e93);
                phi_198_ = _e53;
                loop {
                    let _e96 = phi_195_;
                    let _e98 = phi_198_;
                    local_6 = _e98;
                    if (_e96.member < _e96.member_1) {
                        phi_196_ = type_19((_e96.member + 1u), _e96.member_1);
                        phi_221_ = type_19(1u, _e96.member);
                    } else {
                        phi_196_ = _e96;
                        phi_221_ = type_19(0u, type_19().member_1);
                    }
                    let _e110 = phi_196_;
                    let _e112 = phi_221_;
                    let _e116 = (bitcast<i32>(_e112.member) != 0i);
                    if _e116 {
                        let _e120 = params.member.member_20[_e71.member_1][1u];
                        let _e123 = block_nodes.member[(_e120 + _e112.member_1)];
                        local_2 = type_4(array<f32, 3>(_e123.member[0], _e123.member[1], _e123.member[2]), array<f32, 3>(_e123.member_1[0], _e123.member_1[1], _e123.member_1[2]));
                        local_1 = type_4(array<f32, 3>(_e98.member[0], _e98.member[1], _e98.member[2]), array<f32, 3>(_e98.member_1[0], _e98.member_1[1], _e98.member_1[2]));
                        phi_278_ = type_19(0u, 3u);
                        loop {
                            let _e147 = phi_278_;
                            if (_e147.member < _e147.member_1) {
                                phi_279_ = type_19((_e147.member + 1u), _e147.member_1);
                                phi_302_ = type_19(1u, _e147.member);
                            } else {
                                phi_279_ = _e147;
                                phi_302_ = type_19(0u, type_19().member_1);
                            }
                            let _e159 = phi_279_;
                            let _e161 = phi_302_;
                            let _e165 = (bitcast<i32>(_e161.member) != 0i);
                            if _e165 {
                                let _e168 = local_1.member[_e161.member_1];
                                let _e171 = local_2.member[_e161.member_1];
                                if (_e168 < _e171) {
                                    phi_328_ = _e168;
                                } else {
                                    phi_328_ = _e171;
                                }
                                let _e174 = phi_328_;
                                local_1.member[_e161.member_1] = _e174;
                                let _e179 = local_1.member_1[_e161.member_1];
                                let _e182 = local_2.member_1[_e161.member_1];
                                if (_e179 > _e182) {
                                    phi_355_ = _e179;
                                } else {
                                    phi_355_ = _e182;
                                }
                                let _e185 = phi_355_;
                                local_1.member_1[_e161.member_1] = _e185;
                            }
                            continue;
                            continuing {
                                phi_278_ = _e159;
                                break if !(_e165);
                            }
                        }
                        let _e189 = local_1;
                        phi_199_ = type_4(array<f32, 3>(_e189.member[0], _e189.member[1], _e189.member[2]), array<f32, 3>(_e189.member_1[0], _e189.member_1[1], _e189.member_1[2]));
                    } else {
                        phi_199_ = type_4();
                    }
                    let _e202 = phi_199_;
                    continue;
                    continuing {
                        phi_195_ = _e110;
                        phi_198_ = _e202;
                        break if !(_e116);
                    }
                }
                phi_377_ = type_19(_e91, _e55);
                let _e377 = local_6;
                phi_380_ = _e377;
                loop {
                    let _e206 = phi_377_;
                    let _e208 = phi_380_;
                    local_7 = _e208;
                    if (_e206.member < _e206.member_1) {
                        phi_378_ = type_19((_e206.member + 1u), _e206.member_1);
                        phi_403_ = type_19(1u, _e206.member);
                    } else {
                        phi_378_ = _e206;
                        phi_403_ = type_19(0u, type_19().member_1);
                    }
                    let _e220 = phi_378_;
                    let _e222 = phi_403_;
                    let _e226 = (bitcast<i32>(_e222.member) != 0i);
                    if _e226 {
                        let _e230 = params.member.member_20[_e71.member_1][1u];
                        let _e233 = block_nodes.member[(_e230 + _e222.member_1)];
                        local_3 = type_4(array<f32, 3>(_e233.member[0], _e233.member[1], _e233.member[2]), array<f32, 3>(_e233.member_1[0], _e233.member_1[1], _e233.member_1[2]));
                        local = type_4(array<f32, 3>(_e208.member[0], _e208.member[1], _e208.member[2]), array<f32, 3>(_e208.member_1[0], _e208.member_1[1], _e208.member_1[2]));
                        phi_460_ = type_19(0u, 3u);
                        loop {
                            let _e257 = phi_460_;
                            if (_e257.member < _e257.member_1) {
                                phi_461_ = type_19((_e257.member + 1u), _e257.member_1);
                                phi_484_ = type_19(1u, _e257.member);
                            } else {
                                phi_461_ = _e257;
                                phi_484_ = type_19(0u, type_19().member_1);
                            }
                            let _e269 = phi_461_;
                            let _e271 = phi_484_;
                            let _e275 = (bitcast<i32>(_e271.member) != 0i);
                            if _e275 {
                                let _e278 = local.member[_e271.member_1];
                                let _e281 = local_3.member[_e271.member_1];
                                if (_e278 < _e281) {
                                    phi_510_ = _e278;
                                } else {
                                    phi_510_ = _e281;
                                }
                                let _e284 = phi_510_;
                                local.member[_e271.member_1] = _e284;
                                let _e289 = local.member_1[_e271.member_1];
                                let _e292 = local_3.member_1[_e271.member_1];
                                if (_e289 > _e292) {
                                    phi_537_ = _e289;
                                } else {
                                    phi_537_ = _e292;
                                }
                                let _e295 = phi_537_;
                                local.member_1[_e271.member_1] = _e295;
                            }
                            continue;
                            continuing {
                                phi_460_ = _e269;
                                break if !(_e275);
                            }
                        }
                        let _e299 = local;
                        phi_381_ = type_4(array<f32, 3>(_e299.member[0], _e299.member[1], _e299.member[2]), array<f32, 3>(_e299.member_1[0], _e299.member_1[1], _e299.member_1[2]));
                    } else {
                        phi_381_ = type_4();
                    }
                    let _e312 = phi_381_;
                    continue;
                    continuing {
                        phi_377_ = _e220;
                        phi_380_ = _e312;
                        break if !(_e226);
                    }
                }
                if _e89 {
                    phi_561_ = (_e81 / 32u);
                } else {
                    phi_561_ = 0u;
                }
                let _e316 = phi_561_;
                if _e89 {
                    phi_566_ = (_e83 / 32u);
                } else {
                    phi_566_ = 0u;
                }
                let _e319 = phi_566_;
                let _e390 = local_7;
                phi_132_ = _e390;
                phi_134_ = _e319;
                phi_136_ = _e316;
            } else {
                phi_132_ = type_4();
                phi_134_ = u32();
                phi_136_ = u32();
            }
            let _e321 = phi_132_;
            let _e323 = phi_134_;
            let _e325 = phi_136_;
            continue;
            continuing {
                phi_128_ = _e69;
                phi_131_ = _e321;
                phi_133_ = _e323;
                phi_135_ = _e325;
                break if !(_e75);
            }
        }
        let _e328 = local_4;
        let _e332 = local_5;
        out.member[_e39] = type_23(_e328.member, _e46.member, _e332.member_1, _e46.member_1);
    }
    if (_e39 < _e42) {
        let _e341 = params.member.member_20[0u][1u];
        let _e342 = (_e341 + _e39);
        let _e344 = block_nodes.member[_e342];
        let _e349 = leaves.member[_e342];
        out.member[((_e42 - 1u) + _e39)] = type_23(_e344.member, _e349.member_1, _e344.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
