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

struct type_11 {
    member: i32,
    member_1: i32,
}

struct type_12 {
    member: u32,
    member_1: i32,
}

struct type_14 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_16;
var<workgroup> shared_: array<type_22, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 4>;
    var phi_123_: u32;
    var phi_124_: u32;
    var phi_150_: type_22;
    var phi_170_: type_11;
    var phi_173_: type_22;
    var phi_175_: u32;
    var phi_196_: bool;
    var phi_202_: type_12;
    var phi_171_: type_11;
    var phi_216_: type_12;
    var phi_368_: f32;
    var phi_375_: f32;
    var phi_382_: f32;
    var phi_390_: f32;
    var phi_397_: f32;
    var phi_404_: f32;
    var phi_251_: f32;
    var phi_258_: f32;
    var phi_265_: f32;
    var phi_273_: f32;
    var phi_280_: f32;
    var phi_287_: f32;
    var phi_301_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_339_: bool;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_360_: type_22;
    var phi_361_: type_22;
    var phi_407_: type_22;
    var phi_420_: type_22;
    var phi_174_: type_22;
    var phi_176_: u32;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_22;
    var local_4: type_22;
    var local_5: type_22;
    var local_6: type_22;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    let _e38 = params.member.member_2.member_2;
    let _e42 = params.member.member_2.member[_e38];
    local = array<u32, 4>(_e42[0], _e42[1], _e42[2], _e42[3]);
    let _e49 = local[0u];
    let _e52 = ((_e49 + (((_e26.y * _e27.x) + _e26.x) * 256u)) + _e28);
    let _e54 = local[2u];
    if (_e52 >= _e54) {
        phi_124_ = 2u;
    } else {
        let _e57 = local[1u];
        if (_e52 >= _e57) {
            phi_123_ = 1u;
        } else {
            phi_123_ = 0u;
        }
        let _e60 = phi_123_;
        phi_124_ = _e60;
    }
    let _e62 = phi_124_;
    let _e64 = local[3u];
    let _e65 = (_e52 < _e64);
    if _e65 {
        let _e67 = nodes.member[_e52];
        phi_150_ = type_22(array<f32, 3>(_e67.member.x, _e67.member.y, _e67.member_1.x), array<f32, 3>(_e67.member_1.y, _e67.member_2.x, _e67.member_2.y));
    } else {
        phi_150_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e84 = phi_150_;
    let _e87 = params.member.member.member_1;
    shared_[_e28] = type_22(array<f32, 3>(_e84.member[0], _e84.member[1], _e84.member[2]), array<f32, 3>(_e84.member_1[0], _e84.member_1[1], _e84.member_1[2]));
    phi_170_ = type_11(0i, 5i);
    phi_173_ = _e84;
    phi_175_ = 16u;
    loop {
        let _e103 = phi_170_;
        let _e105 = phi_173_;
        let _e107 = phi_175_;
        local_1 = _e105;
        local_2 = _e105;
        local_3 = _e105;
        local_4 = _e105;
        local_5 = _e105;
        local_6 = _e105;
        if (_e103.member < _e103.member_1) {
            let _e114 = (_e103.member + 1i);
            if ((false == (_e114 > _e103.member)) != false) {
                phi_196_ = true;
            } else {
                phi_196_ = false;
            }
            let _e119 = phi_196_;
            if _e119 {
                phi_202_ = type_12(0u, type_12().member_1);
            } else {
                phi_202_ = type_12(1u, _e114);
            }
            let _e124 = phi_202_;
            phi_171_ = type_11(_e124.member_1, _e103.member_1);
            phi_216_ = type_12(1u, _e103.member);
        } else {
            phi_171_ = _e103;
            phi_216_ = type_12(0u, type_12().member_1);
        }
        let _e130 = phi_171_;
        let _e132 = phi_216_;
        let _e135 = (bitcast<i32>(_e132.member) != 0i);
        if _e135 {
            workgroupBarrier();
            if ((_e28 % 32u) < _e107) {
                let _e140 = shared_[(_e28 + _e107)];
                if ((_e87 & 256u) != 0u) {
                    if (_e105.member[0] < _e140.member[0]) {
                        phi_251_ = _e105.member[0];
                    } else {
                        phi_251_ = _e140.member[0];
                    }
                    let _e186 = phi_251_;
                    if (_e105.member[1] < _e140.member[1]) {
                        phi_258_ = _e105.member[1];
                    } else {
                        phi_258_ = _e140.member[1];
                    }
                    let _e191 = phi_258_;
                    if (_e105.member[2] < _e140.member[2]) {
                        phi_265_ = _e105.member[2];
                    } else {
                        phi_265_ = _e140.member[2];
                    }
                    let _e196 = phi_265_;
                    if (_e105.member_1[0] > _e140.member_1[0]) {
                        phi_273_ = _e105.member_1[0];
                    } else {
                        phi_273_ = _e140.member_1[0];
                    }
                    let _e202 = phi_273_;
                    if (_e105.member_1[1] > _e140.member_1[1]) {
                        phi_280_ = _e105.member_1[1];
                    } else {
                        phi_280_ = _e140.member_1[1];
                    }
                    let _e207 = phi_280_;
                    if (_e105.member_1[2] > _e140.member_1[2]) {
                        phi_287_ = _e105.member_1[2];
                    } else {
                        phi_287_ = _e140.member_1[2];
                    }
                    let _e212 = phi_287_;
                    let _e214 = type_22(array<f32, 3>(_e186, _e191, _e196), array<f32, 3>(_e202, _e207, _e212));
                    if ((bitcast<u32>(_e105.member_1[0]) & 1u) == 1u) {
                        phi_301_ = true;
                    } else {
                        phi_301_ = !((_e105.member[0] <= _e105.member_1[0]));
                    }
                    let _e227 = phi_301_;
                    if _e227 {
                        if ((bitcast<u32>(_e140.member_1[0]) & 1u) == 1u) {
                            phi_316_ = true;
                        } else {
                            phi_316_ = !((_e140.member[0] <= _e140.member_1[0]));
                        }
                        let _e234 = phi_316_;
                        phi_317_ = _e234;
                    } else {
                        phi_317_ = false;
                    }
                    let _e236 = phi_317_;
                    if (_e186 <= _e202) {
                        if (((bitcast<u32>(_e202) & 1u) == 1u) != _e236) {
                            let _e242 = bitcast<u32>(_e202);
                            if ((_e242 & 2139095040u) == 2139095040u) {
                                phi_339_ = (_e202 < 0f);
                            } else {
                                phi_339_ = true;
                            }
                            let _e247 = phi_339_;
                            if _e247 {
                                if (_e202 > 0f) {
                                    phi_357_ = bitcast<f32>((_e242 + 1u));
                                } else {
                                    if (_e202 < 0f) {
                                        phi_356_ = bitcast<f32>((_e242 - 1u));
                                    } else {
                                        phi_356_ = 0.000000000000000000000000000000000000000000001f;
                                    }
                                    let _e253 = phi_356_;
                                    phi_357_ = _e253;
                                }
                                let _e257 = phi_357_;
                                phi_358_ = _e257;
                            } else {
                                phi_358_ = _e202;
                            }
                            let _e259 = phi_358_;
                            phi_360_ = type_22(_e214.member, array<f32, 3>(_e259, _e214.member_1[1], _e214.member_1[2]));
                        } else {
                            phi_360_ = _e214;
                        }
                        let _e267 = phi_360_;
                        phi_361_ = _e267;
                    } else {
                        phi_361_ = _e214;
                    }
                    let _e269 = phi_361_;
                    phi_407_ = _e269;
                } else {
                    if (_e105.member[0] < _e140.member[0]) {
                        phi_368_ = _e105.member[0];
                    } else {
                        phi_368_ = _e140.member[0];
                    }
                    let _e153 = phi_368_;
                    if (_e105.member[1] < _e140.member[1]) {
                        phi_375_ = _e105.member[1];
                    } else {
                        phi_375_ = _e140.member[1];
                    }
                    let _e158 = phi_375_;
                    if (_e105.member[2] < _e140.member[2]) {
                        phi_382_ = _e105.member[2];
                    } else {
                        phi_382_ = _e140.member[2];
                    }
                    let _e163 = phi_382_;
                    if (_e105.member_1[0] > _e140.member_1[0]) {
                        phi_390_ = _e105.member_1[0];
                    } else {
                        phi_390_ = _e140.member_1[0];
                    }
                    let _e169 = phi_390_;
                    if (_e105.member_1[1] > _e140.member_1[1]) {
                        phi_397_ = _e105.member_1[1];
                    } else {
                        phi_397_ = _e140.member_1[1];
                    }
                    let _e174 = phi_397_;
                    if (_e105.member_1[2] > _e140.member_1[2]) {
                        phi_404_ = _e105.member_1[2];
                    } else {
                        phi_404_ = _e140.member_1[2];
                    }
                    let _e179 = phi_404_;
                    phi_407_ = type_22(array<f32, 3>(_e153, _e158, _e163), array<f32, 3>(_e169, _e174, _e179));
                }
                let _e271 = phi_407_;
                shared_[_e28] = type_22(array<f32, 3>(_e271.member[0], _e271.member[1], _e271.member[2]), array<f32, 3>(_e271.member_1[0], _e271.member_1[1], _e271.member_1[2]));
                phi_420_ = _e271;
            } else {
                phi_420_ = _e105;
            }
            let _e285 = phi_420_;
            phi_174_ = _e285;
            phi_176_ = (_e107 / 2u);
        } else {
            phi_174_ = type_22();
            phi_176_ = u32();
        }
        let _e288 = phi_174_;
        let _e290 = phi_176_;
        continue;
        continuing {
            phi_170_ = _e130;
            phi_173_ = _e288;
            phi_175_ = _e290;
            break if !(_e135);
        }
    }
    if _e65 {
        if ((_e28 % 32u) == 0u) {
            let _e297 = params.member.member_2.member_2;
            let _e300 = local[_e62];
            let _e306 = params.member.member_2.member[(_e297 + 1u)][_e62];
            let _e309 = local_1;
            let _e313 = local_2;
            let _e317 = local_3;
            let _e321 = local_4;
            let _e325 = local_5;
            let _e329 = local_6;
            nodes.member[(_e306 + ((_e52 - _e300) / 32u))] = type_18(vec2<f32>(_e309.member[0], _e313.member[1]), vec2<f32>(_e317.member[2], _e321.member_1[0]), vec2<f32>(_e325.member_1[1], _e329.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
