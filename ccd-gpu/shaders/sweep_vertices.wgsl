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

struct type_12 {
    member: f32,
    member_1: f32,
}

struct type_14 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

@group(0) @binding(1) 
var<storage> paths: type_16;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_20;

fn function_(param: f32) -> type_12 {
    return type_12(param, param);
}

fn function_1(param_1: f32) -> type_12 {
    return type_12(param_1, param_1);
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;
    var phi_120_: f32;
    var phi_125_: f32;
    var phi_130_: f32;
    var phi_136_: f32;
    var phi_141_: f32;
    var phi_146_: f32;
    var phi_166_: type_9;
    var phi_167_: type_9;
    var phi_190_: type_9;
    var phi_217_: bool;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_263_: bool;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_326_: type_9;
    var phi_327_: type_9;
    var phi_350_: type_9;
    var phi_372_: f32;
    var phi_377_: f32;
    var phi_399_: f32;
    var phi_404_: f32;
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
            phi_120_ = _e40.member[0];
        } else {
            phi_120_ = _e40.member_1[0];
        }
        let _e54 = phi_120_;
        if (_e40.member[1] < _e40.member_1[1]) {
            phi_125_ = _e40.member[1];
        } else {
            phi_125_ = _e40.member_1[1];
        }
        let _e57 = phi_125_;
        if (_e40.member[2] < _e40.member_1[2]) {
            phi_130_ = _e40.member[2];
        } else {
            phi_130_ = _e40.member_1[2];
        }
        let _e60 = phi_130_;
        if (_e40.member[0] > _e40.member_1[0]) {
            phi_136_ = _e40.member[0];
        } else {
            phi_136_ = _e40.member_1[0];
        }
        let _e63 = phi_136_;
        if (_e40.member[1] > _e40.member_1[1]) {
            phi_141_ = _e40.member[1];
        } else {
            phi_141_ = _e40.member_1[1];
        }
        let _e66 = phi_141_;
        if (_e40.member[2] > _e40.member_1[2]) {
            phi_146_ = _e40.member[2];
        } else {
            phi_146_ = _e40.member_1[2];
        }
        let _e69 = phi_146_;
        if (_e43 > 0f) {
            local_1 = type_18(array<f32, 3>(_e54, _e57, _e60), array<f32, 3>(_e63, _e66, _e69));
            phi_166_ = type_9(0u, 3u);
            loop {
                let _e78 = phi_166_;
                if (_e78.member < _e78.member_1) {
                    phi_167_ = type_9((_e78.member + 1u), _e78.member_1);
                    phi_190_ = type_9(1u, _e78.member);
                } else {
                    phi_167_ = _e78;
                    phi_190_ = type_9(0u, type_9().member_1);
                }
                let _e90 = phi_167_;
                let _e92 = phi_190_;
                let _e96 = (bitcast<i32>(_e92.member) != 0i);
                if _e96 {
                    let _e99 = local_1.member[_e92.member_1];
                    let _e101 = -((_e99 - _e43));
                    let _e102 = bitcast<u32>(_e101);
                    if ((_e102 & 2139095040u) == 2139095040u) {
                        phi_217_ = (_e101 < 0f);
                    } else {
                        phi_217_ = true;
                    }
                    let _e107 = phi_217_;
                    if _e107 {
                        if (_e101 > 0f) {
                            phi_235_ = bitcast<f32>((_e102 + 1u));
                        } else {
                            if (_e101 < 0f) {
                                phi_234_ = bitcast<f32>((_e102 - 1u));
                            } else {
                                phi_234_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e113 = phi_234_;
                            phi_235_ = _e113;
                        }
                        let _e117 = phi_235_;
                        phi_236_ = _e117;
                    } else {
                        phi_236_ = _e101;
                    }
                    let _e119 = phi_236_;
                    local_1.member[_e92.member_1] = -(_e119);
                    let _e125 = local_1.member_1[_e92.member_1];
                    let _e126 = (_e125 + _e43);
                    let _e127 = bitcast<u32>(_e126);
                    if ((_e127 & 2139095040u) == 2139095040u) {
                        phi_263_ = (_e126 < 0f);
                    } else {
                        phi_263_ = true;
                    }
                    let _e132 = phi_263_;
                    if _e132 {
                        if (_e126 > 0f) {
                            phi_281_ = bitcast<f32>((_e127 + 1u));
                        } else {
                            if (_e126 < 0f) {
                                phi_280_ = bitcast<f32>((_e127 - 1u));
                            } else {
                                phi_280_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e138 = phi_280_;
                            phi_281_ = _e138;
                        }
                        let _e142 = phi_281_;
                        phi_282_ = _e142;
                    } else {
                        phi_282_ = _e126;
                    }
                    let _e144 = phi_282_;
                    local_1.member_1[_e92.member_1] = _e144;
                }
                continue;
                continuing {
                    phi_166_ = _e90;
                    break if !(_e96);
                }
            }
        } else {
            local_1 = type_18(array<f32, 3>(_e54, _e57, _e60), array<f32, 3>(_e63, _e66, _e69));
        }
        let _e148 = local_1;
        local_2 = _e148;
        local = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_326_ = type_9(0u, 3u);
        loop {
            let _e150 = phi_326_;
            if (_e150.member < _e150.member_1) {
                phi_327_ = type_9((_e150.member + 1u), _e150.member_1);
                phi_350_ = type_9(1u, _e150.member);
            } else {
                phi_327_ = _e150;
                phi_350_ = type_9(0u, type_9().member_1);
            }
            let _e162 = phi_327_;
            let _e164 = phi_350_;
            let _e168 = (bitcast<i32>(_e164.member) != 0i);
            if _e168 {
                let _e171 = local_2.member[_e164.member_1];
                let _e172 = function_1(_e171);
                let _e174 = -(290000000000000000000000000000000000000f);
                if (_e172.member > _e174) {
                    phi_372_ = _e172.member;
                } else {
                    phi_372_ = _e174;
                }
                let _e177 = phi_372_;
                if (_e177 < 290000000000000000000000000000000000000f) {
                    phi_377_ = _e177;
                } else {
                    phi_377_ = 290000000000000000000000000000000000000f;
                }
                let _e180 = phi_377_;
                local.member[_e164.member_1] = _e180;
                let _e185 = local_2.member_1[_e164.member_1];
                let _e186 = function_(_e185);
                let _e188 = -(290000000000000000000000000000000000000f);
                if (_e186.member_1 > _e188) {
                    phi_399_ = _e186.member_1;
                } else {
                    phi_399_ = _e188;
                }
                let _e191 = phi_399_;
                if (_e191 < 290000000000000000000000000000000000000f) {
                    phi_404_ = _e191;
                } else {
                    phi_404_ = 290000000000000000000000000000000000000f;
                }
                let _e194 = phi_404_;
                local.member_1[_e164.member_1] = _e194;
            }
            continue;
            continuing {
                phi_326_ = _e162;
                break if !(_e168);
            }
        }
        let _e198 = local;
        boxes.member[_e33] = type_18(array<f32, 3>(_e198.member[0], _e198.member[1], _e198.member[2]), array<f32, 3>(_e198.member_1[0], _e198.member_1[1], _e198.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
