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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
    member_4: bool,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(1) 
var<storage> boxes: type_20;
@group(0) @binding(3) 
var<storage> nodes: type_23;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_28;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_25;
    var phi_112_: array<u32, 2>;
    var phi_144_: u32;
    var phi_171_: array<u32, 2>;
    var phi_202_: array<u32, 2>;
    var phi_265_: array<u32, 2>;
    var phi_298_: bool;
    var phi_370_: type_9;
    var phi_371_: type_9;
    var phi_394_: type_9;
    var phi_494_: u32;
    var phi_520_: bool;
    var phi_550_: bool;
    var phi_589_: u32;
    var phi_590_: bool;
    var phi_591_: u32;
    var phi_592_: bool;
    var phi_596_: u32;
    var phi_610_: array<u32, 2>;
    var phi_643_: bool;
    var phi_673_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    let _e40 = ((((_e26.y * _e27.x) + _e26.x) * 128u) + _e28);
    let _e43 = params.member.member_1.member;
    if (_e40 < _e43) {
        let _e47 = params.member.member_2.member;
        if (_e47 == 0u) {
            phi_112_ = array<u32, 2>(0u, 2u);
        } else {
            phi_112_ = array<u32, 2>(1u, 1u);
        }
        let _e50 = phi_112_;
        let _e55 = params.member.member.member_2[_e50[0]];
        let _e58 = params.member.member_1.member_1;
        let _e60 = ((_e55 + _e58) + _e40);
        let _e63 = params.member.member_2.member_1;
        if (_e63 == 0u) {
            phi_144_ = _e60;
        } else {
            let _e66 = order.member[_e60];
            phi_144_ = _e66;
        }
        let _e68 = phi_144_;
        let _e69 = (_e68 - _e55);
        let _e71 = boxes.member[_e68];
        let _e86 = params.member.member_2.member;
        if (_e86 == 0u) {
            phi_171_ = array<u32, 2>(0u, 2u);
        } else {
            phi_171_ = array<u32, 2>(1u, 1u);
        }
        let _e89 = phi_171_;
        let _e94 = params.member.member.member[_e89[1]];
        let _e95 = (_e94 - 1u);
        if (_e95 == 0u) {
            let _e99 = params.member.member_2.member;
            if (_e99 == 0u) {
                phi_202_ = array<u32, 2>(0u, 2u);
            } else {
                phi_202_ = array<u32, 2>(1u, 1u);
            }
            let _e102 = phi_202_;
            let _e107 = params.member.member.member_2[_e102[1]];
            let _e109 = order.member[_e107];
            let _e111 = boxes.member[_e109];
            if ((((((_e111.member.x <= _e71.member_1.y) && (_e71.member.x <= _e111.member_1.y)) && (_e111.member.y <= _e71.member_2.x)) && (_e71.member.y <= _e111.member_2.x)) && (_e111.member_1.x <= _e71.member_2.y)) && (_e71.member_1.x <= _e111.member_2.y)) {
                let _e137 = params.member.member_2.member;
                if (_e137 == 0u) {
                    phi_265_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_265_ = array<u32, 2>(1u, 1u);
                }
                let _e140 = phi_265_;
                let _e145 = params.member.member.member_2[_e140[1]];
                let _e147 = order.member[_e145];
                let _e148 = (_e147 - _e145);
                let _e151 = params.member.member_2.member;
                if (_e151 == 0u) {
                    phi_298_ = true;
                } else {
                    phi_298_ = (_e148 > _e69);
                }
                let _e155 = phi_298_;
                if _e155 {
                    let _e158 = params.member.member_1.member_3;
                    let _e160 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e160 + 1u) < _e160) {
                        let _e164 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e160 < _e158) {
                        let _e166 = (2u * _e160);
                        atomicStore((&pairs.member[(4u + _e166)]), _e69);
                        atomicStore((&pairs.member[(_e166 + 5u)]), _e148);
                    }
                }
            }
        }
        local = type_25(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, false, true);
        phi_370_ = type_9(0u, (2u * _e95));
        loop {
            let _e174 = phi_370_;
            if (_e174.member < _e174.member_1) {
                phi_371_ = type_9((_e174.member + 1u), _e174.member_1);
                phi_394_ = type_9(1u, _e174.member);
            } else {
                phi_371_ = _e174;
                phi_394_ = type_9(0u, type_9().member_1);
            }
            let _e186 = phi_371_;
            let _e188 = phi_394_;
            if (bitcast<i32>(_e188.member) != 0i) {
                let _e193 = local.member_4;
                if _e193 {
                    let _e195 = local.member_2;
                    let _e197 = nodes.member[_e195];
                    let _e235 = local.member_3;
                    let _e236 = (((_e197.member_3.w & 2147483648u) != 0u) != _e235);
                    if _e236 {
                        phi_494_ = _e197.member.w;
                    } else {
                        phi_494_ = _e197.member_1.w;
                    }
                    let _e238 = phi_494_;
                    if _e236 {
                        phi_520_ = ((((((bitcast<f32>(_e197.member.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e197.member_1.x))) && (bitcast<f32>(_e197.member.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e197.member_1.y))) && (bitcast<f32>(_e197.member.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e197.member_1.z)));
                    } else {
                        phi_520_ = ((((((bitcast<f32>(_e197.member_2.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e197.member_3.x))) && (bitcast<f32>(_e197.member_2.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e197.member_3.y))) && (bitcast<f32>(_e197.member_2.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e197.member_3.z)));
                    }
                    let _e262 = phi_520_;
                    let _e264 = ((_e238 & 2147483648u) != 0u);
                    if _e262 {
                        if _e264 {
                        } else {
                            let _e266 = local.member_3;
                            if _e266 {
                            } else {
                                let _e268 = local.member_2;
                                let _e270 = local.member_1;
                                local.member[_e270] = _e268;
                                let _e275 = local.member_1;
                                local.member_1 = (_e275 + 1u);
                            }
                            local.member_2 = _e238;
                            local.member_3 = false;
                        }
                        phi_550_ = _e264;
                    } else {
                        phi_550_ = true;
                    }
                    let _e280 = phi_550_;
                    if _e280 {
                        let _e282 = local.member_3;
                        if _e282 {
                            let _e285 = local.member_1;
                            if (_e285 > 0u) {
                                let _e290 = local.member_1;
                                local.member_1 = (_e290 - 1u);
                                let _e293 = local.member_1;
                                let _e296 = local.member[_e293];
                                local.member_2 = _e296;
                                local.member_3 = true;
                            } else {
                                local.member_4 = false;
                            }
                        } else {
                            local.member_3 = true;
                        }
                    }
                    if _e262 {
                        if _e264 {
                            phi_589_ = (_e238 & 2147483647u);
                            phi_590_ = false;
                        } else {
                            phi_589_ = u32();
                            phi_590_ = true;
                        }
                        let _e301 = phi_589_;
                        let _e303 = phi_590_;
                        phi_591_ = _e301;
                        phi_592_ = _e303;
                    } else {
                        phi_591_ = u32();
                        phi_592_ = true;
                    }
                    let _e305 = phi_591_;
                    let _e307 = phi_592_;
                    if _e307 {
                        phi_596_ = 4294967295u;
                    } else {
                        phi_596_ = _e305;
                    }
                    let _e309 = phi_596_;
                    if (_e309 != 4294967295u) {
                        let _e313 = params.member.member_2.member;
                        if (_e313 == 0u) {
                            phi_610_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_610_ = array<u32, 2>(1u, 1u);
                        }
                        let _e316 = phi_610_;
                        let _e321 = params.member.member.member_2[_e316[1]];
                        let _e324 = order.member[(_e321 + _e309)];
                        let _e325 = (_e324 - _e321);
                        let _e328 = params.member.member_2.member;
                        if (_e328 == 0u) {
                            phi_643_ = true;
                        } else {
                            phi_643_ = (_e325 > _e69);
                        }
                        let _e332 = phi_643_;
                        if _e332 {
                            let _e335 = params.member.member_1.member_3;
                            let _e337 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e337 + 1u) < _e337) {
                                let _e341 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e337 < _e335) {
                                let _e343 = (2u * _e337);
                                atomicStore((&pairs.member[(4u + _e343)]), _e69);
                                atomicStore((&pairs.member[(_e343 + 5u)]), _e325);
                            }
                        }
                    }
                }
                phi_673_ = _e193;
            } else {
                phi_673_ = false;
            }
            let _e349 = phi_673_;
            continue;
            continuing {
                phi_370_ = _e186;
                break if !(_e349);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_recursive(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
