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
    var phi_124_: u32;
    var phi_125_: u32;
    var phi_151_: type_22;
    var phi_171_: type_11;
    var phi_174_: type_22;
    var phi_176_: u32;
    var phi_197_: bool;
    var phi_203_: type_12;
    var phi_172_: type_11;
    var phi_217_: type_12;
    var phi_377_: f32;
    var phi_384_: f32;
    var phi_391_: f32;
    var phi_399_: f32;
    var phi_406_: f32;
    var phi_413_: f32;
    var phi_252_: f32;
    var phi_259_: f32;
    var phi_266_: f32;
    var phi_274_: f32;
    var phi_281_: f32;
    var phi_288_: f32;
    var phi_302_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_357_: bool;
    var phi_358_: u32;
    var phi_359_: bool;
    var phi_366_: u32;
    var phi_369_: type_22;
    var phi_370_: type_22;
    var phi_416_: type_22;
    var phi_429_: type_22;
    var phi_175_: type_22;
    var phi_177_: u32;
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
        phi_125_ = 2u;
    } else {
        let _e57 = local[1u];
        if (_e52 >= _e57) {
            phi_124_ = 1u;
        } else {
            phi_124_ = 0u;
        }
        let _e60 = phi_124_;
        phi_125_ = _e60;
    }
    let _e62 = phi_125_;
    let _e64 = local[3u];
    let _e65 = (_e52 < _e64);
    if _e65 {
        let _e67 = nodes.member[_e52];
        phi_151_ = type_22(array<f32, 3>(_e67.member.x, _e67.member.y, _e67.member_1.x), array<f32, 3>(_e67.member_1.y, _e67.member_2.x, _e67.member_2.y));
    } else {
        phi_151_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e84 = phi_151_;
    let _e87 = params.member.member.member_1;
    shared_[_e28] = type_22(array<f32, 3>(_e84.member[0], _e84.member[1], _e84.member[2]), array<f32, 3>(_e84.member_1[0], _e84.member_1[1], _e84.member_1[2]));
    phi_171_ = type_11(0i, 5i);
    phi_174_ = _e84;
    phi_176_ = 16u;
    loop {
        let _e103 = phi_171_;
        let _e105 = phi_174_;
        let _e107 = phi_176_;
        local_1 = _e105;
        local_2 = _e105;
        local_3 = _e105;
        local_4 = _e105;
        local_5 = _e105;
        local_6 = _e105;
        if (_e103.member < _e103.member_1) {
            let _e114 = (_e103.member + 1i);
            if ((false == (_e114 > _e103.member)) != false) {
                phi_197_ = true;
            } else {
                phi_197_ = false;
            }
            let _e119 = phi_197_;
            if _e119 {
                phi_203_ = type_12(0u, type_12().member_1);
            } else {
                phi_203_ = type_12(1u, _e114);
            }
            let _e124 = phi_203_;
            phi_172_ = type_11(_e124.member_1, _e103.member_1);
            phi_217_ = type_12(1u, _e103.member);
        } else {
            phi_172_ = _e103;
            phi_217_ = type_12(0u, type_12().member_1);
        }
        let _e130 = phi_172_;
        let _e132 = phi_217_;
        let _e135 = (bitcast<i32>(_e132.member) != 0i);
        if _e135 {
            workgroupBarrier();
            if ((_e28 % 32u) < _e107) {
                let _e140 = shared_[(_e28 + _e107)];
                if ((_e87 & 256u) != 0u) {
                    if (_e105.member[0] < _e140.member[0]) {
                        phi_252_ = _e105.member[0];
                    } else {
                        phi_252_ = _e140.member[0];
                    }
                    let _e186 = phi_252_;
                    if (_e105.member[1] < _e140.member[1]) {
                        phi_259_ = _e105.member[1];
                    } else {
                        phi_259_ = _e140.member[1];
                    }
                    let _e191 = phi_259_;
                    if (_e105.member[2] < _e140.member[2]) {
                        phi_266_ = _e105.member[2];
                    } else {
                        phi_266_ = _e140.member[2];
                    }
                    let _e196 = phi_266_;
                    if (_e105.member_1[0] > _e140.member_1[0]) {
                        phi_274_ = _e105.member_1[0];
                    } else {
                        phi_274_ = _e140.member_1[0];
                    }
                    let _e202 = phi_274_;
                    if (_e105.member_1[1] > _e140.member_1[1]) {
                        phi_281_ = _e105.member_1[1];
                    } else {
                        phi_281_ = _e140.member_1[1];
                    }
                    let _e207 = phi_281_;
                    if (_e105.member_1[2] > _e140.member_1[2]) {
                        phi_288_ = _e105.member_1[2];
                    } else {
                        phi_288_ = _e140.member_1[2];
                    }
                    let _e212 = phi_288_;
                    let _e214 = type_22(array<f32, 3>(_e186, _e191, _e196), array<f32, 3>(_e202, _e207, _e212));
                    if ((bitcast<u32>(_e105.member_1[0]) & 1u) == 1u) {
                        phi_302_ = true;
                    } else {
                        phi_302_ = !((_e105.member[0] <= _e105.member_1[0]));
                    }
                    let _e227 = phi_302_;
                    if _e227 {
                        if ((bitcast<u32>(_e140.member_1[0]) & 1u) == 1u) {
                            phi_317_ = true;
                        } else {
                            phi_317_ = !((_e140.member[0] <= _e140.member_1[0]));
                        }
                        let _e234 = phi_317_;
                        phi_318_ = _e234;
                    } else {
                        phi_318_ = false;
                    }
                    let _e236 = phi_318_;
                    if (_e186 <= _e202) {
                        if (((bitcast<u32>(_e202) & 1u) == 1u) != _e236) {
                            let _e242 = bitcast<u32>(_e202);
                            let _e245 = ((_e242 >> bitcast<u32>(31i)) == 1u);
                            let _e246 = (_e242 & 2147483647u);
                            if (_e246 < 8388608u) {
                                phi_358_ = u32();
                                phi_359_ = true;
                            } else {
                                if _e245 {
                                    if (_e246 == 8388608u) {
                                        phi_345_ = false;
                                    } else {
                                        phi_345_ = true;
                                    }
                                    let _e250 = phi_345_;
                                    phi_346_ = _e250;
                                } else {
                                    phi_346_ = true;
                                }
                                let _e252 = phi_346_;
                                if _e252 {
                                    if _e245 {
                                        phi_355_ = (_e242 - 1u);
                                    } else {
                                        phi_355_ = (_e242 + 1u);
                                    }
                                    let _e256 = phi_355_;
                                    phi_356_ = _e256;
                                    phi_357_ = false;
                                } else {
                                    phi_356_ = u32();
                                    phi_357_ = true;
                                }
                                let _e258 = phi_356_;
                                let _e260 = phi_357_;
                                phi_358_ = _e258;
                                phi_359_ = _e260;
                            }
                            let _e262 = phi_358_;
                            let _e264 = phi_359_;
                            if _e264 {
                                phi_366_ = (8388608u | ((_e242 & 1u) ^ 1u));
                            } else {
                                phi_366_ = _e262;
                            }
                            let _e269 = phi_366_;
                            phi_369_ = type_22(_e214.member, array<f32, 3>(bitcast<f32>(_e269), _e214.member_1[1], _e214.member_1[2]));
                        } else {
                            phi_369_ = _e214;
                        }
                        let _e278 = phi_369_;
                        phi_370_ = _e278;
                    } else {
                        phi_370_ = _e214;
                    }
                    let _e280 = phi_370_;
                    phi_416_ = _e280;
                } else {
                    if (_e105.member[0] < _e140.member[0]) {
                        phi_377_ = _e105.member[0];
                    } else {
                        phi_377_ = _e140.member[0];
                    }
                    let _e153 = phi_377_;
                    if (_e105.member[1] < _e140.member[1]) {
                        phi_384_ = _e105.member[1];
                    } else {
                        phi_384_ = _e140.member[1];
                    }
                    let _e158 = phi_384_;
                    if (_e105.member[2] < _e140.member[2]) {
                        phi_391_ = _e105.member[2];
                    } else {
                        phi_391_ = _e140.member[2];
                    }
                    let _e163 = phi_391_;
                    if (_e105.member_1[0] > _e140.member_1[0]) {
                        phi_399_ = _e105.member_1[0];
                    } else {
                        phi_399_ = _e140.member_1[0];
                    }
                    let _e169 = phi_399_;
                    if (_e105.member_1[1] > _e140.member_1[1]) {
                        phi_406_ = _e105.member_1[1];
                    } else {
                        phi_406_ = _e140.member_1[1];
                    }
                    let _e174 = phi_406_;
                    if (_e105.member_1[2] > _e140.member_1[2]) {
                        phi_413_ = _e105.member_1[2];
                    } else {
                        phi_413_ = _e140.member_1[2];
                    }
                    let _e179 = phi_413_;
                    phi_416_ = type_22(array<f32, 3>(_e153, _e158, _e163), array<f32, 3>(_e169, _e174, _e179));
                }
                let _e282 = phi_416_;
                shared_[_e28] = type_22(array<f32, 3>(_e282.member[0], _e282.member[1], _e282.member[2]), array<f32, 3>(_e282.member_1[0], _e282.member_1[1], _e282.member_1[2]));
                phi_429_ = _e282;
            } else {
                phi_429_ = _e105;
            }
            let _e296 = phi_429_;
            phi_175_ = _e296;
            phi_177_ = (_e107 / 2u);
        } else {
            phi_175_ = type_22();
            phi_177_ = u32();
        }
        let _e299 = phi_175_;
        let _e301 = phi_177_;
        continue;
        continuing {
            phi_171_ = _e130;
            phi_174_ = _e299;
            phi_176_ = _e301;
            break if !(_e135);
        }
    }
    if _e65 {
        if ((_e28 % 32u) == 0u) {
            let _e308 = params.member.member_2.member_2;
            let _e311 = local[_e62];
            let _e317 = params.member.member_2.member[(_e308 + 1u)][_e62];
            let _e320 = local_1;
            let _e324 = local_2;
            let _e328 = local_3;
            let _e332 = local_4;
            let _e336 = local_5;
            let _e340 = local_6;
            nodes.member[(_e317 + ((_e52 - _e311) / 32u))] = type_18(vec2<f32>(_e320.member[0], _e324.member[1]), vec2<f32>(_e328.member[2], _e332.member_1[0]), vec2<f32>(_e336.member_1[1], _e340.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
