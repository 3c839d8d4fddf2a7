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
    member: array<type_8>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
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

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> nodes: type_17;
@group(0) @binding(2) 
var<storage> branches: type_13;
@group(0) @binding(3) 
var<storage, read_write> pairs: type_25;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_225_: type_9;
    var phi_226_: type_9;
    var phi_249_: type_9;
    var phi_281_: u32;
    var phi_312_: bool;
    var phi_342_: bool;
    var phi_352_: bool;
    var phi_382_: bool;
    var phi_392_: u32;
    var phi_393_: bool;
    var phi_394_: u32;
    var phi_395_: bool;
    var phi_399_: u32;
    var phi_409_: u32;
    var phi_410_: bool;
    var phi_411_: u32;
    var phi_412_: bool;
    var phi_416_: u32;
    var phi_423_: bool;
    var phi_430_: bool;
    var phi_494_: type_9;
    var phi_541_: type_9;
    var phi_572_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e21 = id_2;
    let _e22 = n_2;
    let _e23 = lane_2;
    let _e34 = ((((_e21.y * _e22.x) + _e21.x) * 128u) + _e23);
    let _e37 = params.member.member_1.member;
    if (_e34 < _e37) {
        let _e41 = params.member.member_1.member_1;
        let _e42 = (_e41 + _e34);
        let _e46 = params.member.member.member[1u];
        let _e50 = nodes.member[((_e46 - 1u) + _e42)];
        let _e57 = params.member.member.member[1u];
        let _e58 = (_e57 - 1u);
        local = type_19(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_225_ = type_9(0u, _e58);
        loop {
            let _e61 = phi_225_;
            if (_e61.member < _e61.member_1) {
                phi_226_ = type_9((_e61.member + 1u), _e61.member_1);
                phi_249_ = type_9(1u, _e61.member);
            } else {
                phi_226_ = _e61;
                phi_249_ = type_9(0u, type_9().member_1);
            }
            let _e73 = phi_226_;
            let _e75 = phi_249_;
            if (bitcast<i32>(_e75.member) != 0i) {
                let _e80 = local.member_3;
                if _e80 {
                    let _e82 = local.member_2;
                    let _e84 = branches.member[_e82];
                    if (_e84.member >= _e58) {
                        phi_281_ = (_e84.member - _e58);
                    } else {
                        phi_281_ = _e84.member;
                    }
                    let _e91 = phi_281_;
                    let _e94 = nodes.member[_e84.member];
                    let _e97 = nodes.member[_e84.member_1];
                    if (_e42 == 4294967295u) {
                        phi_312_ = true;
                    } else {
                        phi_312_ = (_e91 > _e42);
                    }
                    let _e101 = phi_312_;
                    if _e101 {
                        phi_342_ = ((((((_e94.member[0] <= _e50.member_2[0]) && (_e50.member[0] <= _e94.member_2[0])) && (_e94.member[1] <= _e50.member_2[1])) && (_e50.member[1] <= _e94.member_2[1])) && (_e94.member[2] <= _e50.member_2[2])) && (_e50.member[2] <= _e94.member_2[2]));
                    } else {
                        phi_342_ = false;
                    }
                    let _e128 = phi_342_;
                    if (_e42 == 4294967295u) {
                        phi_352_ = true;
                    } else {
                        phi_352_ = (_e84.member_3 > _e42);
                    }
                    let _e133 = phi_352_;
                    if _e133 {
                        phi_382_ = ((((((_e97.member[0] <= _e50.member_2[0]) && (_e50.member[0] <= _e97.member_2[0])) && (_e97.member[1] <= _e50.member_2[1])) && (_e50.member[1] <= _e97.member_2[1])) && (_e97.member[2] <= _e50.member_2[2])) && (_e50.member[2] <= _e97.member_2[2]));
                    } else {
                        phi_382_ = false;
                    }
                    let _e160 = phi_382_;
                    if _e128 {
                        if (_e94.member_3 == 4294967295u) {
                            phi_392_ = _e94.member_1;
                            phi_393_ = false;
                        } else {
                            phi_392_ = u32();
                            phi_393_ = true;
                        }
                        let _e165 = phi_392_;
                        let _e167 = phi_393_;
                        phi_394_ = _e165;
                        phi_395_ = _e167;
                    } else {
                        phi_394_ = u32();
                        phi_395_ = true;
                    }
                    let _e169 = phi_394_;
                    let _e171 = phi_395_;
                    if _e171 {
                        phi_399_ = 4294967295u;
                    } else {
                        phi_399_ = _e169;
                    }
                    let _e173 = phi_399_;
                    if _e160 {
                        if (_e97.member_3 == 4294967295u) {
                            phi_409_ = _e97.member_1;
                            phi_410_ = false;
                        } else {
                            phi_409_ = u32();
                            phi_410_ = true;
                        }
                        let _e178 = phi_409_;
                        let _e180 = phi_410_;
                        phi_411_ = _e178;
                        phi_412_ = _e180;
                    } else {
                        phi_411_ = u32();
                        phi_412_ = true;
                    }
                    let _e182 = phi_411_;
                    let _e184 = phi_412_;
                    if _e184 {
                        phi_416_ = 4294967295u;
                    } else {
                        phi_416_ = _e182;
                    }
                    let _e186 = phi_416_;
                    if _e128 {
                        phi_423_ = !((_e94.member_3 == 4294967295u));
                    } else {
                        phi_423_ = false;
                    }
                    let _e191 = phi_423_;
                    if _e160 {
                        phi_430_ = !((_e97.member_3 == 4294967295u));
                    } else {
                        phi_430_ = false;
                    }
                    let _e196 = phi_430_;
                    if _e191 {
                        local.member_2 = _e84.member;
                        if _e196 {
                            let _e217 = local.member_1;
                            local.member[_e217] = _e84.member_1;
                            let _e222 = local.member_1;
                            local.member_1 = (_e222 + 1u);
                        }
                    } else {
                        if _e196 {
                            local.member_2 = _e84.member_1;
                        } else {
                            let _e198 = local.member_1;
                            if (_e198 > 0u) {
                                let _e203 = local.member_1;
                                local.member_1 = (_e203 - 1u);
                                let _e206 = local.member_1;
                                let _e209 = local.member[_e206];
                                local.member_2 = _e209;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    let _e226 = params.member.member_1.member_3;
                    if (_e173 != 4294967295u) {
                        if (_e50.member_1 < _e173) {
                            phi_494_ = type_9(_e50.member_1, _e173);
                        } else {
                            phi_494_ = type_9(_e173, _e50.member_1);
                        }
                        let _e232 = phi_494_;
                        let _e236 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e236 + 1u) < _e236) {
                            let _e240 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e236 < _e226) {
                            let _e242 = (2u * _e236);
                            atomicStore((&pairs.member[(4u + _e242)]), _e232.member);
                            atomicStore((&pairs.member[(_e242 + 5u)]), _e232.member_1);
                        }
                    }
                    let _e249 = params.member.member_1.member_3;
                    if (_e186 != 4294967295u) {
                        if (_e50.member_1 < _e186) {
                            phi_541_ = type_9(_e50.member_1, _e186);
                        } else {
                            phi_541_ = type_9(_e186, _e50.member_1);
                        }
                        let _e255 = phi_541_;
                        let _e259 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e259 + 1u) < _e259) {
                            let _e263 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e259 < _e249) {
                            let _e265 = (2u * _e259);
                            atomicStore((&pairs.member[(4u + _e265)]), _e255.member);
                            atomicStore((&pairs.member[(_e265 + 5u)]), _e255.member_1);
                        }
                    }
                }
                phi_572_ = _e80;
            } else {
                phi_572_ = false;
            }
            let _e271 = phi_572_;
            continue;
            continuing {
                phi_225_ = _e73;
                break if !(_e271);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
