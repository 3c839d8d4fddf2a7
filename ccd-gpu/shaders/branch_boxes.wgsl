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
    var phi_106_: array<u32, 2>;
    var phi_136_: type_9;
    var phi_139_: type_22;
    var phi_141_: u32;
    var phi_143_: u32;
    var phi_137_: type_9;
    var phi_166_: type_9;
    var phi_185_: u32;
    var phi_195_: bool;
    var phi_199_: u32;
    var phi_200_: u32;
    var phi_203_: type_9;
    var phi_206_: type_22;
    var phi_204_: type_9;
    var phi_229_: type_9;
    var phi_267_: f32;
    var phi_274_: f32;
    var phi_281_: f32;
    var phi_289_: f32;
    var phi_296_: f32;
    var phi_303_: f32;
    var phi_207_: type_22;
    var phi_308_: type_9;
    var phi_311_: type_22;
    var phi_309_: type_9;
    var phi_334_: type_9;
    var phi_372_: f32;
    var phi_379_: f32;
    var phi_386_: f32;
    var phi_394_: f32;
    var phi_401_: f32;
    var phi_408_: f32;
    var phi_312_: type_22;
    var phi_415_: u32;
    var phi_420_: u32;
    var phi_140_: type_22;
    var phi_142_: u32;
    var phi_144_: u32;
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
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e36 = ((((_e22.y * _e23.x) + _e22.x) * 256u) + _e24);
    let _e39 = params.member.member_2.member_1;
    if (_e39 == 0u) {
        phi_106_ = array<u32, 2>(0u, 2u);
    } else {
        phi_106_ = array<u32, 2>(1u, 1u);
    }
    let _e42 = phi_106_;
    let _e47 = params.member.member.member[_e42[1]];
    if ((_e36 + 1u) < _e47) {
        let _e51 = branches.member[_e36];
        phi_136_ = type_9(0u, 8u);
        phi_139_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_141_ = (_e51.member_3 + 1u);
        phi_143_ = _e51.member_2;
        loop {
            let _e57 = phi_136_;
            let _e59 = phi_139_;
            let _e61 = phi_141_;
            let _e63 = phi_143_;
            local = _e59;
            local_1 = _e59;
            if (_e57.member < _e57.member_1) {
                phi_137_ = type_9((_e57.member + 1u), _e57.member_1);
                phi_166_ = type_9(1u, _e57.member);
            } else {
                phi_137_ = _e57;
                phi_166_ = type_9(0u, type_9().member_1);
            }
            let _e75 = phi_137_;
            let _e77 = phi_166_;
            let _e81 = (bitcast<i32>(_e77.member) != 0i);
            if _e81 {
                let _e82 = (_e63 % 32u);
                if (_e82 == 0u) {
                    phi_185_ = _e63;
                } else {
                    phi_185_ = (_e63 + (32u - _e82));
                }
                let _e87 = phi_185_;
                let _e89 = ((_e61 / 32u) * 32u);
                if (_e87 < _e89) {
                    let _e92 = params.member.member_2.member_2;
                    phi_195_ = (_e77.member_1 < _e92);
                } else {
                    phi_195_ = false;
                }
                let _e95 = phi_195_;
                if _e95 {
                    phi_199_ = _e89;
                    phi_200_ = _e87;
                } else {
                    phi_199_ = _e61;
                    phi_200_ = _e61;
                }
                let _e97 = phi_199_;
                let _e99 = phi_200_;
                phi_203_ = type_9(_e63, _e99);
                phi_206_ = _e59;
                loop {
                    let _e102 = phi_203_;
                    let _e104 = phi_206_;
                    local_2 = _e104;
                    if (_e102.member < _e102.member_1) {
                        phi_204_ = type_9((_e102.member + 1u), _e102.member_1);
                        phi_229_ = type_9(1u, _e102.member);
                    } else {
                        phi_204_ = _e102;
                        phi_229_ = type_9(0u, type_9().member_1);
                    }
                    let _e116 = phi_204_;
                    let _e118 = phi_229_;
                    let _e122 = (bitcast<i32>(_e118.member) != 0i);
                    if _e122 {
                        let _e126 = params.member.member_2.member[_e77.member_1][_e42[1]];
                        let _e129 = block_nodes.member[(_e126 + _e118.member_1)];
                        if (_e104.member[0] < _e129.member[0]) {
                            phi_267_ = _e104.member[0];
                        } else {
                            phi_267_ = _e129.member[0];
                        }
                        let _e136 = phi_267_;
                        if (_e104.member[1] < _e129.member[1]) {
                            phi_274_ = _e104.member[1];
                        } else {
                            phi_274_ = _e129.member[1];
                        }
                        let _e143 = phi_274_;
                        if (_e104.member[2] < _e129.member[2]) {
                            phi_281_ = _e104.member[2];
                        } else {
                            phi_281_ = _e129.member[2];
                        }
                        let _e150 = phi_281_;
                        if (_e104.member_1[0] > _e129.member_1[0]) {
                            phi_289_ = _e104.member_1[0];
                        } else {
                            phi_289_ = _e129.member_1[0];
                        }
                        let _e158 = phi_289_;
                        if (_e104.member_1[1] > _e129.member_1[1]) {
                            phi_296_ = _e104.member_1[1];
                        } else {
                            phi_296_ = _e129.member_1[1];
                        }
                        let _e165 = phi_296_;
                        if (_e104.member_1[2] > _e129.member_1[2]) {
                            phi_303_ = _e104.member_1[2];
                        } else {
                            phi_303_ = _e129.member_1[2];
                        }
                        let _e172 = phi_303_;
                        phi_207_ = type_22(array<f32, 3>(_e136, _e143, _e150), array<f32, 3>(_e158, _e165, _e172));
                    } else {
                        phi_207_ = type_22();
                    }
                    let _e176 = phi_207_;
                    continue;
                    continuing {
                        phi_203_ = _e116;
                        phi_206_ = _e176;
                        break if !(_e122);
                    }
                }
                phi_308_ = type_9(_e97, _e61);
                let _e322 = local_2;
                phi_311_ = _e322;
                loop {
                    let _e180 = phi_308_;
                    let _e182 = phi_311_;
                    local_3 = _e182;
                    if (_e180.member < _e180.member_1) {
                        phi_309_ = type_9((_e180.member + 1u), _e180.member_1);
                        phi_334_ = type_9(1u, _e180.member);
                    } else {
                        phi_309_ = _e180;
                        phi_334_ = type_9(0u, type_9().member_1);
                    }
                    let _e194 = phi_309_;
                    let _e196 = phi_334_;
                    let _e200 = (bitcast<i32>(_e196.member) != 0i);
                    if _e200 {
                        let _e204 = params.member.member_2.member[_e77.member_1][_e42[1]];
                        let _e207 = block_nodes.member[(_e204 + _e196.member_1)];
                        if (_e182.member[0] < _e207.member[0]) {
                            phi_372_ = _e182.member[0];
                        } else {
                            phi_372_ = _e207.member[0];
                        }
                        let _e214 = phi_372_;
                        if (_e182.member[1] < _e207.member[1]) {
                            phi_379_ = _e182.member[1];
                        } else {
                            phi_379_ = _e207.member[1];
                        }
                        let _e221 = phi_379_;
                        if (_e182.member[2] < _e207.member[2]) {
                            phi_386_ = _e182.member[2];
                        } else {
                            phi_386_ = _e207.member[2];
                        }
                        let _e228 = phi_386_;
                        if (_e182.member_1[0] > _e207.member_1[0]) {
                            phi_394_ = _e182.member_1[0];
                        } else {
                            phi_394_ = _e207.member_1[0];
                        }
                        let _e236 = phi_394_;
                        if (_e182.member_1[1] > _e207.member_1[1]) {
                            phi_401_ = _e182.member_1[1];
                        } else {
                            phi_401_ = _e207.member_1[1];
                        }
                        let _e243 = phi_401_;
                        if (_e182.member_1[2] > _e207.member_1[2]) {
                            phi_408_ = _e182.member_1[2];
                        } else {
                            phi_408_ = _e207.member_1[2];
                        }
                        let _e250 = phi_408_;
                        phi_312_ = type_22(array<f32, 3>(_e214, _e221, _e228), array<f32, 3>(_e236, _e243, _e250));
                    } else {
                        phi_312_ = type_22();
                    }
                    let _e254 = phi_312_;
                    continue;
                    continuing {
                        phi_308_ = _e194;
                        phi_311_ = _e254;
                        break if !(_e200);
                    }
                }
                if _e95 {
                    phi_415_ = (_e87 / 32u);
                } else {
                    phi_415_ = 0u;
                }
                let _e258 = phi_415_;
                if _e95 {
                    phi_420_ = (_e89 / 32u);
                } else {
                    phi_420_ = 0u;
                }
                let _e261 = phi_420_;
                let _e336 = local_3;
                phi_140_ = _e336;
                phi_142_ = _e261;
                phi_144_ = _e258;
            } else {
                phi_140_ = type_22();
                phi_142_ = u32();
                phi_144_ = u32();
            }
            let _e263 = phi_140_;
            let _e265 = phi_142_;
            let _e267 = phi_144_;
            continue;
            continuing {
                phi_136_ = _e75;
                phi_139_ = _e263;
                phi_141_ = _e265;
                phi_143_ = _e267;
                break if !(_e81);
            }
        }
        let _e270 = local;
        let _e274 = local_1;
        nodes.member[_e36] = type_25(_e270.member, _e51.member, _e274.member_1, _e51.member_1);
    }
    if (_e36 < _e47) {
        let _e284 = params.member.member_2.member[0u][_e42[1]];
        let _e285 = (_e284 + _e36);
        let _e287 = block_nodes.member[_e285];
        let _e292 = leaves.member[_e285];
        nodes.member[((_e47 - 1u) + _e36)] = type_25(_e287.member, _e292.member_1, _e287.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
