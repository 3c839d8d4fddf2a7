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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<type_8>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> branches: type_20;
@group(0) @binding(2) 
var<storage> block_nodes: type_24;
@group(0) @binding(3) 
var<storage> leaves: type_18;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_128_: type_9;
    var phi_131_: type_22;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_129_: type_9;
    var phi_158_: type_9;
    var phi_177_: u32;
    var phi_187_: bool;
    var phi_191_: u32;
    var phi_192_: u32;
    var phi_195_: type_9;
    var phi_198_: type_22;
    var phi_196_: type_9;
    var phi_221_: type_9;
    var phi_259_: f32;
    var phi_266_: f32;
    var phi_273_: f32;
    var phi_281_: f32;
    var phi_288_: f32;
    var phi_295_: f32;
    var phi_199_: type_22;
    var phi_300_: type_9;
    var phi_303_: type_22;
    var phi_301_: type_9;
    var phi_326_: type_9;
    var phi_364_: f32;
    var phi_371_: f32;
    var phi_378_: f32;
    var phi_386_: f32;
    var phi_393_: f32;
    var phi_400_: f32;
    var phi_304_: type_22;
    var phi_407_: u32;
    var phi_412_: u32;
    var phi_132_: type_22;
    var phi_134_: u32;
    var phi_136_: u32;
    var local: type_22;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_22;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e20 = id_2;
    let _e21 = n_2;
    let _e22 = lane_2;
    let _e34 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e37 = params.member.member_2.member_1;
    let _e41 = params.member.member.member[_e37];
    if ((_e34 + 1u) < _e41) {
        let _e45 = branches.member[_e34];
        phi_128_ = type_9(0u, 8u);
        phi_131_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_133_ = (_e45.member_3 + 1u);
        phi_135_ = _e45.member_2;
        loop {
            let _e51 = phi_128_;
            let _e53 = phi_131_;
            let _e55 = phi_133_;
            let _e57 = phi_135_;
            local = _e53;
            local_1 = _e53;
            if (_e51.member < _e51.member_1) {
                phi_129_ = type_9((_e51.member + 1u), _e51.member_1);
                phi_158_ = type_9(1u, _e51.member);
            } else {
                phi_129_ = _e51;
                phi_158_ = type_9(0u, type_9().member_1);
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
                    let _e86 = params.member.member_2.member_2;
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
                phi_195_ = type_9(_e57, _e93);
                phi_198_ = _e53;
                loop {
                    let _e96 = phi_195_;
                    let _e98 = phi_198_;
                    local_2 = _e98;
                    if (_e96.member < _e96.member_1) {
                        phi_196_ = type_9((_e96.member + 1u), _e96.member_1);
                        phi_221_ = type_9(1u, _e96.member);
                    } else {
                        phi_196_ = _e96;
                        phi_221_ = type_9(0u, type_9().member_1);
                    }
                    let _e110 = phi_196_;
                    let _e112 = phi_221_;
                    let _e116 = (bitcast<i32>(_e112.member) != 0i);
                    if _e116 {
                        let _e120 = params.member.member_2.member[_e71.member_1][_e37];
                        let _e123 = block_nodes.member[(_e120 + _e112.member_1)];
                        if (_e98.member[0] < _e123.member[0]) {
                            phi_259_ = _e98.member[0];
                        } else {
                            phi_259_ = _e123.member[0];
                        }
                        let _e130 = phi_259_;
                        if (_e98.member[1] < _e123.member[1]) {
                            phi_266_ = _e98.member[1];
                        } else {
                            phi_266_ = _e123.member[1];
                        }
                        let _e137 = phi_266_;
                        if (_e98.member[2] < _e123.member[2]) {
                            phi_273_ = _e98.member[2];
                        } else {
                            phi_273_ = _e123.member[2];
                        }
                        let _e144 = phi_273_;
                        if (_e98.member_1[0] > _e123.member_1[0]) {
                            phi_281_ = _e98.member_1[0];
                        } else {
                            phi_281_ = _e123.member_1[0];
                        }
                        let _e152 = phi_281_;
                        if (_e98.member_1[1] > _e123.member_1[1]) {
                            phi_288_ = _e98.member_1[1];
                        } else {
                            phi_288_ = _e123.member_1[1];
                        }
                        let _e159 = phi_288_;
                        if (_e98.member_1[2] > _e123.member_1[2]) {
                            phi_295_ = _e98.member_1[2];
                        } else {
                            phi_295_ = _e123.member_1[2];
                        }
                        let _e166 = phi_295_;
                        phi_199_ = type_22(array<f32, 3>(_e130, _e137, _e144), array<f32, 3>(_e152, _e159, _e166));
                    } else {
                        phi_199_ = type_22();
                    }
                    let _e170 = phi_199_;
                    continue;
                    continuing {
                        phi_195_ = _e110;
                        phi_198_ = _e170;
                        break if !(_e116);
                    }
                }
                phi_300_ = type_9(_e91, _e55);
                let _e315 = local_2;
                phi_303_ = _e315;
                loop {
                    let _e174 = phi_300_;
                    let _e176 = phi_303_;
                    local_3 = _e176;
                    if (_e174.member < _e174.member_1) {
                        phi_301_ = type_9((_e174.member + 1u), _e174.member_1);
                        phi_326_ = type_9(1u, _e174.member);
                    } else {
                        phi_301_ = _e174;
                        phi_326_ = type_9(0u, type_9().member_1);
                    }
                    let _e188 = phi_301_;
                    let _e190 = phi_326_;
                    let _e194 = (bitcast<i32>(_e190.member) != 0i);
                    if _e194 {
                        let _e198 = params.member.member_2.member[_e71.member_1][_e37];
                        let _e201 = block_nodes.member[(_e198 + _e190.member_1)];
                        if (_e176.member[0] < _e201.member[0]) {
                            phi_364_ = _e176.member[0];
                        } else {
                            phi_364_ = _e201.member[0];
                        }
                        let _e208 = phi_364_;
                        if (_e176.member[1] < _e201.member[1]) {
                            phi_371_ = _e176.member[1];
                        } else {
                            phi_371_ = _e201.member[1];
                        }
                        let _e215 = phi_371_;
                        if (_e176.member[2] < _e201.member[2]) {
                            phi_378_ = _e176.member[2];
                        } else {
                            phi_378_ = _e201.member[2];
                        }
                        let _e222 = phi_378_;
                        if (_e176.member_1[0] > _e201.member_1[0]) {
                            phi_386_ = _e176.member_1[0];
                        } else {
                            phi_386_ = _e201.member_1[0];
                        }
                        let _e230 = phi_386_;
                        if (_e176.member_1[1] > _e201.member_1[1]) {
                            phi_393_ = _e176.member_1[1];
                        } else {
                            phi_393_ = _e201.member_1[1];
                        }
                        let _e237 = phi_393_;
                        if (_e176.member_1[2] > _e201.member_1[2]) {
                            phi_400_ = _e176.member_1[2];
                        } else {
                            phi_400_ = _e201.member_1[2];
                        }
                        let _e244 = phi_400_;
                        phi_304_ = type_22(array<f32, 3>(_e208, _e215, _e222), array<f32, 3>(_e230, _e237, _e244));
                    } else {
                        phi_304_ = type_22();
                    }
                    let _e248 = phi_304_;
                    continue;
                    continuing {
                        phi_300_ = _e188;
                        phi_303_ = _e248;
                        break if !(_e194);
                    }
                }
                if _e89 {
                    phi_407_ = (_e81 / 32u);
                } else {
                    phi_407_ = 0u;
                }
                let _e252 = phi_407_;
                if _e89 {
                    phi_412_ = (_e83 / 32u);
                } else {
                    phi_412_ = 0u;
                }
                let _e255 = phi_412_;
                let _e329 = local_3;
                phi_132_ = _e329;
                phi_134_ = _e255;
                phi_136_ = _e252;
            } else {
                phi_132_ = type_22();
                phi_134_ = u32();
                phi_136_ = u32();
            }
            let _e257 = phi_132_;
            let _e259 = phi_134_;
            let _e261 = phi_136_;
            continue;
            continuing {
                phi_128_ = _e69;
                phi_131_ = _e257;
                phi_133_ = _e259;
                phi_135_ = _e261;
                break if !(_e75);
            }
        }
        let _e264 = local;
        let _e268 = local_1;
        nodes.member[_e34] = type_25(_e264.member, _e45.member, _e268.member_1, _e45.member_1);
    }
    if (_e34 < _e41) {
        let _e278 = params.member.member_2.member[0u][_e37];
        let _e279 = (_e278 + _e34);
        let _e281 = block_nodes.member[_e279];
        let _e286 = leaves.member[_e279];
        nodes.member[((_e41 - 1u) + _e34)] = type_25(_e281.member, _e286.member_1, _e281.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
