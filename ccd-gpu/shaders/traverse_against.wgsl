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

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_24 {
    member: u32,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_21;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_29;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(1) 
var<storage> boxes: type_18;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_23;
    var phi_168_: type_9;
    var phi_169_: type_9;
    var phi_192_: type_9;
    var phi_307_: u32;
    var phi_308_: bool;
    var phi_309_: u32;
    var phi_310_: bool;
    var phi_314_: u32;
    var phi_322_: u32;
    var phi_323_: bool;
    var phi_324_: u32;
    var phi_325_: bool;
    var phi_329_: u32;
    var phi_334_: bool;
    var phi_339_: bool;
    var phi_351_: u32;
    var phi_367_: u32;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_511_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e38 = ((((_e24.y * _e25.x) + _e24.x) * 128u) + _e26);
    let _e41 = params.member.member_1.member;
    if (_e38 < _e41) {
        let _e45 = params.member.member_1.member_1;
        let _e46 = (_e45 + _e38);
        let _e48 = boxes.member[_e46];
        let _e64 = params.member.member.member[1u];
        let _e67 = params.member.member_1.member_3;
        local = type_23(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_168_ = type_9(0u, (_e64 - 1u));
        loop {
            let _e71 = phi_168_;
            if (_e71.member < _e71.member_1) {
                phi_169_ = type_9((_e71.member + 1u), _e71.member_1);
                phi_192_ = type_9(1u, _e71.member);
            } else {
                phi_169_ = _e71;
                phi_192_ = type_9(0u, type_9().member_1);
            }
            let _e83 = phi_169_;
            let _e85 = phi_192_;
            if (bitcast<i32>(_e85.member) != 0i) {
                let _e90 = local.member_3;
                if _e90 {
                    let _e92 = local.member_2;
                    let _e94 = nodes.member[_e92];
                    let _e139 = ((((((bitcast<f32>(_e94.member.x) <= _e48.member_1.y) && (_e48.member.x <= bitcast<f32>(_e94.member_1.x))) && (bitcast<f32>(_e94.member.y) <= _e48.member_2.x)) && (_e48.member.y <= bitcast<f32>(_e94.member_1.y))) && (bitcast<f32>(_e94.member.z) <= _e48.member_2.y)) && (_e48.member_1.x <= bitcast<f32>(_e94.member_1.z)));
                    let _e150 = ((((((bitcast<f32>(_e94.member_2.x) <= _e48.member_1.y) && (_e48.member.x <= bitcast<f32>(_e94.member_3.x))) && (bitcast<f32>(_e94.member_2.y) <= _e48.member_2.x)) && (_e48.member.y <= bitcast<f32>(_e94.member_3.y))) && (bitcast<f32>(_e94.member_2.z) <= _e48.member_2.y)) && (_e48.member_1.x <= bitcast<f32>(_e94.member_3.z)));
                    let _e152 = ((_e94.member.w & 2147483648u) != 0u);
                    let _e154 = ((_e94.member_1.w & 2147483648u) != 0u);
                    if _e139 {
                        if _e152 {
                            phi_307_ = (_e94.member.w & 2147483647u);
                            phi_308_ = false;
                        } else {
                            phi_307_ = u32();
                            phi_308_ = true;
                        }
                        let _e157 = phi_307_;
                        let _e159 = phi_308_;
                        phi_309_ = _e157;
                        phi_310_ = _e159;
                    } else {
                        phi_309_ = u32();
                        phi_310_ = true;
                    }
                    let _e161 = phi_309_;
                    let _e163 = phi_310_;
                    if _e163 {
                        phi_314_ = 4294967295u;
                    } else {
                        phi_314_ = _e161;
                    }
                    let _e165 = phi_314_;
                    if _e150 {
                        if _e154 {
                            phi_322_ = (_e94.member_1.w & 2147483647u);
                            phi_323_ = false;
                        } else {
                            phi_322_ = u32();
                            phi_323_ = true;
                        }
                        let _e168 = phi_322_;
                        let _e170 = phi_323_;
                        phi_324_ = _e168;
                        phi_325_ = _e170;
                    } else {
                        phi_324_ = u32();
                        phi_325_ = true;
                    }
                    let _e172 = phi_324_;
                    let _e174 = phi_325_;
                    if _e174 {
                        phi_329_ = 4294967295u;
                    } else {
                        phi_329_ = _e172;
                    }
                    let _e176 = phi_329_;
                    if _e139 {
                        phi_334_ = !(_e152);
                    } else {
                        phi_334_ = false;
                    }
                    let _e179 = phi_334_;
                    if _e150 {
                        phi_339_ = !(_e154);
                    } else {
                        phi_339_ = false;
                    }
                    let _e182 = phi_339_;
                    if _e179 {
                        if _e182 {
                            let _e184 = ((_e94.member_3.w & 2147483648u) != 0u);
                            if _e184 {
                                phi_351_ = _e94.member_1.w;
                            } else {
                                phi_351_ = _e94.member.w;
                            }
                            let _e186 = phi_351_;
                            let _e188 = local.member_1;
                            local.member[_e188] = _e186;
                            let _e193 = local.member_1;
                            local.member_1 = (_e193 + 1u);
                            if _e184 {
                                phi_367_ = _e94.member.w;
                            } else {
                                phi_367_ = _e94.member_1.w;
                            }
                            let _e196 = phi_367_;
                            local.member_2 = _e196;
                            phi_369_ = false;
                        } else {
                            phi_369_ = true;
                        }
                        let _e199 = phi_369_;
                        phi_370_ = _e199;
                    } else {
                        phi_370_ = true;
                    }
                    let _e201 = phi_370_;
                    if _e201 {
                        if _e179 {
                            local.member_2 = _e94.member.w;
                        } else {
                            if _e182 {
                                local.member_2 = _e94.member_1.w;
                            } else {
                                let _e203 = local.member_1;
                                if (_e203 > 0u) {
                                    let _e208 = local.member_1;
                                    local.member_1 = (_e208 - 1u);
                                    let _e211 = local.member_1;
                                    let _e214 = local.member[_e211];
                                    local.member_2 = _e214;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e165 != 4294967295u) {
                        let _e220 = order.member[_e165];
                        let _e222 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e222 + 1u) < _e222) {
                            let _e226 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e222 < _e67) {
                            let _e228 = (2u * _e222);
                            atomicStore((&pairs.member[(4u + _e228)]), _e46);
                            atomicStore((&pairs.member[(_e228 + 5u)]), _e220);
                        }
                    }
                    if (_e176 != 4294967295u) {
                        let _e235 = order.member[_e176];
                        let _e237 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e237 + 1u) < _e237) {
                            let _e241 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e237 < _e67) {
                            let _e243 = (2u * _e237);
                            atomicStore((&pairs.member[(4u + _e243)]), _e46);
                            atomicStore((&pairs.member[(_e243 + 5u)]), _e235);
                        }
                    }
                }
                phi_511_ = _e90;
            } else {
                phi_511_ = false;
            }
            let _e249 = phi_511_;
            continue;
            continuing {
                phi_168_ = _e83;
                break if !(_e249);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_against(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
