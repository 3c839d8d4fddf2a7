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

struct type_16 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_20 {
    member: array<type_18>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;
@group(0) @binding(1) 
var<storage> paths: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_11;
    var local_1: type_11;
    var local_2: type_11;
    var phi_115_: f32;
    var phi_120_: f32;
    var phi_125_: f32;
    var phi_131_: f32;
    var phi_136_: f32;
    var phi_141_: f32;
    var phi_161_: type_16;
    var phi_162_: type_16;
    var phi_185_: type_16;
    var phi_212_: bool;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_258_: bool;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_321_: type_16;
    var phi_322_: type_16;
    var phi_345_: type_16;
    var phi_375_: bool;
    var phi_392_: f32;
    var phi_393_: f32;
    var phi_394_: f32;
    var phi_396_: f32;
    var phi_402_: f32;
    var phi_407_: f32;
    var phi_436_: bool;
    var phi_453_: f32;
    var phi_454_: f32;
    var phi_455_: f32;
    var phi_456_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
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
    let _e36 = params.member.member[0u];
    if (_e33 < _e36) {
        let _e39 = paths.member[_e33];
        let _e41 = params.member.member_3;
        if (_e39.member[0] < _e39.member_1[0]) {
            phi_115_ = _e39.member[0];
        } else {
            phi_115_ = _e39.member_1[0];
        }
        let _e52 = phi_115_;
        if (_e39.member[1] < _e39.member_1[1]) {
            phi_120_ = _e39.member[1];
        } else {
            phi_120_ = _e39.member_1[1];
        }
        let _e55 = phi_120_;
        if (_e39.member[2] < _e39.member_1[2]) {
            phi_125_ = _e39.member[2];
        } else {
            phi_125_ = _e39.member_1[2];
        }
        let _e58 = phi_125_;
        if (_e39.member[0] > _e39.member_1[0]) {
            phi_131_ = _e39.member[0];
        } else {
            phi_131_ = _e39.member_1[0];
        }
        let _e61 = phi_131_;
        if (_e39.member[1] > _e39.member_1[1]) {
            phi_136_ = _e39.member[1];
        } else {
            phi_136_ = _e39.member_1[1];
        }
        let _e64 = phi_136_;
        if (_e39.member[2] > _e39.member_1[2]) {
            phi_141_ = _e39.member[2];
        } else {
            phi_141_ = _e39.member_1[2];
        }
        let _e67 = phi_141_;
        if (_e41 > 0f) {
            local_1 = type_11(array<f32, 3>(_e52, _e55, _e58), array<f32, 3>(_e61, _e64, _e67));
            phi_161_ = type_16(0u, 3u);
            loop {
                let _e76 = phi_161_;
                if (_e76.member < _e76.member_1) {
                    phi_162_ = type_16((_e76.member + 1u), _e76.member_1);
                    phi_185_ = type_16(1u, _e76.member);
                } else {
                    phi_162_ = _e76;
                    phi_185_ = type_16(0u, type_16().member_1);
                }
                let _e88 = phi_162_;
                let _e90 = phi_185_;
                let _e94 = (bitcast<i32>(_e90.member) != 0i);
                if _e94 {
                    let _e97 = local_1.member[_e90.member_1];
                    let _e99 = -((_e97 - _e41));
                    let _e100 = bitcast<u32>(_e99);
                    if ((_e100 & 2139095040u) == 2139095040u) {
                        phi_212_ = (_e99 < 0f);
                    } else {
                        phi_212_ = true;
                    }
                    let _e105 = phi_212_;
                    if _e105 {
                        if (_e99 > 0f) {
                            phi_230_ = bitcast<f32>((_e100 + 1u));
                        } else {
                            if (_e99 < 0f) {
                                phi_229_ = bitcast<f32>((_e100 - 1u));
                            } else {
                                phi_229_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e111 = phi_229_;
                            phi_230_ = _e111;
                        }
                        let _e115 = phi_230_;
                        phi_231_ = _e115;
                    } else {
                        phi_231_ = _e99;
                    }
                    let _e117 = phi_231_;
                    local_1.member[_e90.member_1] = -(_e117);
                    let _e123 = local_1.member_1[_e90.member_1];
                    let _e124 = (_e123 + _e41);
                    let _e125 = bitcast<u32>(_e124);
                    if ((_e125 & 2139095040u) == 2139095040u) {
                        phi_258_ = (_e124 < 0f);
                    } else {
                        phi_258_ = true;
                    }
                    let _e130 = phi_258_;
                    if _e130 {
                        if (_e124 > 0f) {
                            phi_276_ = bitcast<f32>((_e125 + 1u));
                        } else {
                            if (_e124 < 0f) {
                                phi_275_ = bitcast<f32>((_e125 - 1u));
                            } else {
                                phi_275_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e136 = phi_275_;
                            phi_276_ = _e136;
                        }
                        let _e140 = phi_276_;
                        phi_277_ = _e140;
                    } else {
                        phi_277_ = _e124;
                    }
                    let _e142 = phi_277_;
                    local_1.member_1[_e90.member_1] = _e142;
                }
                continue;
                continuing {
                    phi_161_ = _e88;
                    break if !(_e94);
                }
            }
        } else {
            local_1 = type_11(array<f32, 3>(_e52, _e55, _e58), array<f32, 3>(_e61, _e64, _e67));
        }
        let _e146 = local_1;
        local_2 = _e146;
        local = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_321_ = type_16(0u, 3u);
        loop {
            let _e148 = phi_321_;
            if (_e148.member < _e148.member_1) {
                phi_322_ = type_16((_e148.member + 1u), _e148.member_1);
                phi_345_ = type_16(1u, _e148.member);
            } else {
                phi_322_ = _e148;
                phi_345_ = type_16(0u, type_16().member_1);
            }
            let _e160 = phi_322_;
            let _e162 = phi_345_;
            let _e166 = (bitcast<i32>(_e162.member) != 0i);
            if _e166 {
                let _e169 = local_2.member[_e162.member_1];
                if (_e169 > _e169) {
                    let _e171 = -(_e169);
                    let _e172 = bitcast<u32>(_e171);
                    if ((_e172 & 2139095040u) == 2139095040u) {
                        phi_375_ = (_e171 < 0f);
                    } else {
                        phi_375_ = true;
                    }
                    let _e177 = phi_375_;
                    if _e177 {
                        if (_e171 > 0f) {
                            phi_393_ = bitcast<f32>((_e172 + 1u));
                        } else {
                            if (_e171 < 0f) {
                                phi_392_ = bitcast<f32>((_e172 - 1u));
                            } else {
                                phi_392_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e183 = phi_392_;
                            phi_393_ = _e183;
                        }
                        let _e187 = phi_393_;
                        phi_394_ = _e187;
                    } else {
                        phi_394_ = _e171;
                    }
                    let _e189 = phi_394_;
                    phi_396_ = -(_e189);
                } else {
                    phi_396_ = _e169;
                }
                let _e192 = phi_396_;
                let _e193 = -(290000000000000000000000000000000000000f);
                if (_e192 > _e193) {
                    phi_402_ = _e192;
                } else {
                    phi_402_ = _e193;
                }
                let _e196 = phi_402_;
                if (_e196 < 290000000000000000000000000000000000000f) {
                    phi_407_ = _e196;
                } else {
                    phi_407_ = 290000000000000000000000000000000000000f;
                }
                let _e199 = phi_407_;
                local.member[_e162.member_1] = _e199;
                let _e204 = local_2.member_1[_e162.member_1];
                if (_e204 < _e204) {
                    let _e206 = bitcast<u32>(_e204);
                    if ((_e206 & 2139095040u) == 2139095040u) {
                        phi_436_ = (_e204 < 0f);
                    } else {
                        phi_436_ = true;
                    }
                    let _e211 = phi_436_;
                    if _e211 {
                        if (_e204 > 0f) {
                            phi_454_ = bitcast<f32>((_e206 + 1u));
                        } else {
                            if (_e204 < 0f) {
                                phi_453_ = bitcast<f32>((_e206 - 1u));
                            } else {
                                phi_453_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e217 = phi_453_;
                            phi_454_ = _e217;
                        }
                        let _e221 = phi_454_;
                        phi_455_ = _e221;
                    } else {
                        phi_455_ = _e204;
                    }
                    let _e223 = phi_455_;
                    phi_456_ = _e223;
                } else {
                    phi_456_ = _e204;
                }
                let _e225 = phi_456_;
                let _e226 = -(290000000000000000000000000000000000000f);
                if (_e225 > _e226) {
                    phi_462_ = _e225;
                } else {
                    phi_462_ = _e226;
                }
                let _e229 = phi_462_;
                if (_e229 < 290000000000000000000000000000000000000f) {
                    phi_467_ = _e229;
                } else {
                    phi_467_ = 290000000000000000000000000000000000000f;
                }
                let _e232 = phi_467_;
                local.member_1[_e162.member_1] = _e232;
            }
            continue;
            continuing {
                phi_321_ = _e160;
                break if !(_e166);
            }
        }
        let _e236 = local;
        boxes.member[_e33] = type_11(array<f32, 3>(_e236.member[0], _e236.member[1], _e236.member[2]), array<f32, 3>(_e236.member_1[0], _e236.member_1[1], _e236.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
