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

struct type_13 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_15 {
    member: array<type_13>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

@group(0) @binding(1) 
var<storage> paths: type_15;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_19;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_17;
    var local_1: type_17;
    var local_2: type_17;
    var phi_116_: f32;
    var phi_121_: f32;
    var phi_126_: f32;
    var phi_132_: f32;
    var phi_137_: f32;
    var phi_142_: f32;
    var phi_162_: type_9;
    var phi_163_: type_9;
    var phi_186_: type_9;
    var phi_213_: bool;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_259_: bool;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_322_: type_9;
    var phi_323_: type_9;
    var phi_346_: type_9;
    var phi_376_: bool;
    var phi_393_: f32;
    var phi_394_: f32;
    var phi_395_: f32;
    var phi_397_: f32;
    var phi_403_: f32;
    var phi_408_: f32;
    var phi_437_: bool;
    var phi_454_: f32;
    var phi_455_: f32;
    var phi_456_: f32;
    var phi_457_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e21 = id_2;
    let _e22 = n_2;
    let _e23 = lane_2;
    let _e33 = ((((_e21.y * _e22.x) + _e21.x) * 256u) + _e23);
    let _e37 = params.member.member.member[0u];
    if (_e33 < _e37) {
        let _e40 = paths.member[_e33];
        let _e43 = params.member.member.member_3;
        if (_e40.member[0] < _e40.member_1[0]) {
            phi_116_ = _e40.member[0];
        } else {
            phi_116_ = _e40.member_1[0];
        }
        let _e54 = phi_116_;
        if (_e40.member[1] < _e40.member_1[1]) {
            phi_121_ = _e40.member[1];
        } else {
            phi_121_ = _e40.member_1[1];
        }
        let _e57 = phi_121_;
        if (_e40.member[2] < _e40.member_1[2]) {
            phi_126_ = _e40.member[2];
        } else {
            phi_126_ = _e40.member_1[2];
        }
        let _e60 = phi_126_;
        if (_e40.member[0] > _e40.member_1[0]) {
            phi_132_ = _e40.member[0];
        } else {
            phi_132_ = _e40.member_1[0];
        }
        let _e63 = phi_132_;
        if (_e40.member[1] > _e40.member_1[1]) {
            phi_137_ = _e40.member[1];
        } else {
            phi_137_ = _e40.member_1[1];
        }
        let _e66 = phi_137_;
        if (_e40.member[2] > _e40.member_1[2]) {
            phi_142_ = _e40.member[2];
        } else {
            phi_142_ = _e40.member_1[2];
        }
        let _e69 = phi_142_;
        if (_e43 > 0f) {
            local_1 = type_17(array<f32, 3>(_e54, _e57, _e60), array<f32, 3>(_e63, _e66, _e69));
            phi_162_ = type_9(0u, 3u);
            loop {
                let _e78 = phi_162_;
                if (_e78.member < _e78.member_1) {
                    phi_163_ = type_9((_e78.member + 1u), _e78.member_1);
                    phi_186_ = type_9(1u, _e78.member);
                } else {
                    phi_163_ = _e78;
                    phi_186_ = type_9(0u, type_9().member_1);
                }
                let _e90 = phi_163_;
                let _e92 = phi_186_;
                let _e96 = (bitcast<i32>(_e92.member) != 0i);
                if _e96 {
                    let _e99 = local_1.member[_e92.member_1];
                    let _e101 = -((_e99 - _e43));
                    let _e102 = bitcast<u32>(_e101);
                    if ((_e102 & 2139095040u) == 2139095040u) {
                        phi_213_ = (_e101 < 0f);
                    } else {
                        phi_213_ = true;
                    }
                    let _e107 = phi_213_;
                    if _e107 {
                        if (_e101 > 0f) {
                            phi_231_ = bitcast<f32>((_e102 + 1u));
                        } else {
                            if (_e101 < 0f) {
                                phi_230_ = bitcast<f32>((_e102 - 1u));
                            } else {
                                phi_230_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e113 = phi_230_;
                            phi_231_ = _e113;
                        }
                        let _e117 = phi_231_;
                        phi_232_ = _e117;
                    } else {
                        phi_232_ = _e101;
                    }
                    let _e119 = phi_232_;
                    local_1.member[_e92.member_1] = -(_e119);
                    let _e125 = local_1.member_1[_e92.member_1];
                    let _e126 = (_e125 + _e43);
                    let _e127 = bitcast<u32>(_e126);
                    if ((_e127 & 2139095040u) == 2139095040u) {
                        phi_259_ = (_e126 < 0f);
                    } else {
                        phi_259_ = true;
                    }
                    let _e132 = phi_259_;
                    if _e132 {
                        if (_e126 > 0f) {
                            phi_277_ = bitcast<f32>((_e127 + 1u));
                        } else {
                            if (_e126 < 0f) {
                                phi_276_ = bitcast<f32>((_e127 - 1u));
                            } else {
                                phi_276_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e138 = phi_276_;
                            phi_277_ = _e138;
                        }
                        let _e142 = phi_277_;
                        phi_278_ = _e142;
                    } else {
                        phi_278_ = _e126;
                    }
                    let _e144 = phi_278_;
                    local_1.member_1[_e92.member_1] = _e144;
                }
                continue;
                continuing {
                    phi_162_ = _e90;
                    break if !(_e96);
                }
            }
        } else {
            local_1 = type_17(array<f32, 3>(_e54, _e57, _e60), array<f32, 3>(_e63, _e66, _e69));
        }
        let _e148 = local_1;
        local_2 = _e148;
        local = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_322_ = type_9(0u, 3u);
        loop {
            let _e150 = phi_322_;
            if (_e150.member < _e150.member_1) {
                phi_323_ = type_9((_e150.member + 1u), _e150.member_1);
                phi_346_ = type_9(1u, _e150.member);
            } else {
                phi_323_ = _e150;
                phi_346_ = type_9(0u, type_9().member_1);
            }
            let _e162 = phi_323_;
            let _e164 = phi_346_;
            let _e168 = (bitcast<i32>(_e164.member) != 0i);
            if _e168 {
                let _e171 = local_2.member[_e164.member_1];
                if (_e171 > _e171) {
                    let _e173 = -(_e171);
                    let _e174 = bitcast<u32>(_e173);
                    if ((_e174 & 2139095040u) == 2139095040u) {
                        phi_376_ = (_e173 < 0f);
                    } else {
                        phi_376_ = true;
                    }
                    let _e179 = phi_376_;
                    if _e179 {
                        if (_e173 > 0f) {
                            phi_394_ = bitcast<f32>((_e174 + 1u));
                        } else {
                            if (_e173 < 0f) {
                                phi_393_ = bitcast<f32>((_e174 - 1u));
                            } else {
                                phi_393_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e185 = phi_393_;
                            phi_394_ = _e185;
                        }
                        let _e189 = phi_394_;
                        phi_395_ = _e189;
                    } else {
                        phi_395_ = _e173;
                    }
                    let _e191 = phi_395_;
                    phi_397_ = -(_e191);
                } else {
                    phi_397_ = _e171;
                }
                let _e194 = phi_397_;
                let _e195 = -(290000000000000000000000000000000000000f);
                if (_e194 > _e195) {
                    phi_403_ = _e194;
                } else {
                    phi_403_ = _e195;
                }
                let _e198 = phi_403_;
                if (_e198 < 290000000000000000000000000000000000000f) {
                    phi_408_ = _e198;
                } else {
                    phi_408_ = 290000000000000000000000000000000000000f;
                }
                let _e201 = phi_408_;
                local.member[_e164.member_1] = _e201;
                let _e206 = local_2.member_1[_e164.member_1];
                if (_e206 < _e206) {
                    let _e208 = bitcast<u32>(_e206);
                    if ((_e208 & 2139095040u) == 2139095040u) {
                        phi_437_ = (_e206 < 0f);
                    } else {
                        phi_437_ = true;
                    }
                    let _e213 = phi_437_;
                    if _e213 {
                        if (_e206 > 0f) {
                            phi_455_ = bitcast<f32>((_e208 + 1u));
                        } else {
                            if (_e206 < 0f) {
                                phi_454_ = bitcast<f32>((_e208 - 1u));
                            } else {
                                phi_454_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e219 = phi_454_;
                            phi_455_ = _e219;
                        }
                        let _e223 = phi_455_;
                        phi_456_ = _e223;
                    } else {
                        phi_456_ = _e206;
                    }
                    let _e225 = phi_456_;
                    phi_457_ = _e225;
                } else {
                    phi_457_ = _e206;
                }
                let _e227 = phi_457_;
                let _e228 = -(290000000000000000000000000000000000000f);
                if (_e227 > _e228) {
                    phi_463_ = _e227;
                } else {
                    phi_463_ = _e228;
                }
                let _e231 = phi_463_;
                if (_e231 < 290000000000000000000000000000000000000f) {
                    phi_468_ = _e231;
                } else {
                    phi_468_ = 290000000000000000000000000000000000000f;
                }
                let _e234 = phi_468_;
                local.member_1[_e164.member_1] = _e234;
            }
            continue;
            continuing {
                phi_322_ = _e162;
                break if !(_e168);
            }
        }
        let _e238 = local;
        boxes.member[_e33] = type_17(array<f32, 3>(_e238.member[0], _e238.member[1], _e238.member[2]), array<f32, 3>(_e238.member_1[0], _e238.member_1[1], _e238.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
