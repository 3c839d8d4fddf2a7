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
    var phi_145_: u32;
    var phi_244_: array<u32, 2>;
    var phi_277_: bool;
    var phi_347_: type_9;
    var phi_348_: type_9;
    var phi_371_: type_9;
    var phi_491_: u32;
    var phi_492_: bool;
    var phi_493_: u32;
    var phi_494_: bool;
    var phi_498_: u32;
    var phi_506_: u32;
    var phi_507_: bool;
    var phi_508_: u32;
    var phi_509_: bool;
    var phi_513_: u32;
    var phi_518_: bool;
    var phi_523_: bool;
    var phi_535_: u32;
    var phi_551_: u32;
    var phi_553_: bool;
    var phi_554_: bool;
    var phi_600_: array<u32, 2>;
    var phi_633_: bool;
    var phi_676_: array<u32, 2>;
    var phi_709_: bool;
    var phi_760_: bool;
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
        let _e56 = params.member.member.member_2[_e50[0]];
        let _e59 = params.member.member_1.member_1;
        let _e61 = ((_e56 + _e59) + _e40);
        let _e64 = params.member.member_2.member_1;
        if (_e64 == 0u) {
            phi_145_ = _e61;
        } else {
            let _e67 = order.member[_e61];
            phi_145_ = _e67;
        }
        let _e69 = phi_145_;
        let _e71 = boxes.member[_e69];
        let _e87 = params.member.member.member_2[_e50[0]];
        let _e88 = (_e69 - _e87);
        let _e92 = params.member.member.member_2[_e50[1]];
        let _e96 = params.member.member.member[_e50[1]];
        let _e97 = (_e96 - 1u);
        if (_e97 == 0u) {
            let _e100 = order.member[_e92];
            let _e102 = boxes.member[_e100];
            if ((((((_e102.member.x <= _e71.member_1.y) && (_e71.member.x <= _e102.member_1.y)) && (_e102.member.y <= _e71.member_2.x)) && (_e71.member.y <= _e102.member_2.x)) && (_e102.member_1.x <= _e71.member_2.y)) && (_e71.member_1.x <= _e102.member_2.y)) {
                let _e128 = params.member.member_2.member;
                if (_e128 == 0u) {
                    phi_244_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_244_ = array<u32, 2>(1u, 1u);
                }
                let _e131 = phi_244_;
                let _e136 = params.member.member.member_2[_e131[1]];
                let _e138 = order.member[_e136];
                let _e139 = (_e138 - _e136);
                let _e142 = params.member.member_2.member;
                if (_e142 == 0u) {
                    phi_277_ = true;
                } else {
                    phi_277_ = (_e139 > _e88);
                }
                let _e146 = phi_277_;
                if _e146 {
                    let _e149 = params.member.member_1.member_3;
                    let _e151 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e151 + 1u) < _e151) {
                        let _e155 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e151 < _e149) {
                        let _e157 = (2u * _e151);
                        atomicStore((&pairs.member[(4u + _e157)]), _e88);
                        atomicStore((&pairs.member[(_e157 + 5u)]), _e139);
                    }
                }
            }
        }
        local = type_25(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_347_ = type_9(0u, _e97);
        loop {
            let _e164 = phi_347_;
            if (_e164.member < _e164.member_1) {
                phi_348_ = type_9((_e164.member + 1u), _e164.member_1);
                phi_371_ = type_9(1u, _e164.member);
            } else {
                phi_348_ = _e164;
                phi_371_ = type_9(0u, type_9().member_1);
            }
            let _e176 = phi_348_;
            let _e178 = phi_371_;
            if (bitcast<i32>(_e178.member) != 0i) {
                let _e183 = local.member_3;
                if _e183 {
                    let _e185 = local.member_2;
                    let _e187 = nodes.member[_e185];
                    let _e232 = ((((((bitcast<f32>(_e187.member.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e187.member_1.x))) && (bitcast<f32>(_e187.member.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e187.member_1.y))) && (bitcast<f32>(_e187.member.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e187.member_1.z)));
                    let _e243 = ((((((bitcast<f32>(_e187.member_2.x) <= _e71.member_1.y) && (_e71.member.x <= bitcast<f32>(_e187.member_3.x))) && (bitcast<f32>(_e187.member_2.y) <= _e71.member_2.x)) && (_e71.member.y <= bitcast<f32>(_e187.member_3.y))) && (bitcast<f32>(_e187.member_2.z) <= _e71.member_2.y)) && (_e71.member_1.x <= bitcast<f32>(_e187.member_3.z)));
                    let _e245 = ((_e187.member.w & 2147483648u) != 0u);
                    let _e247 = ((_e187.member_1.w & 2147483648u) != 0u);
                    if _e232 {
                        if _e245 {
                            phi_491_ = (_e187.member.w & 2147483647u);
                            phi_492_ = false;
                        } else {
                            phi_491_ = u32();
                            phi_492_ = true;
                        }
                        let _e250 = phi_491_;
                        let _e252 = phi_492_;
                        phi_493_ = _e250;
                        phi_494_ = _e252;
                    } else {
                        phi_493_ = u32();
                        phi_494_ = true;
                    }
                    let _e254 = phi_493_;
                    let _e256 = phi_494_;
                    if _e256 {
                        phi_498_ = 4294967295u;
                    } else {
                        phi_498_ = _e254;
                    }
                    let _e258 = phi_498_;
                    if _e243 {
                        if _e247 {
                            phi_506_ = (_e187.member_1.w & 2147483647u);
                            phi_507_ = false;
                        } else {
                            phi_506_ = u32();
                            phi_507_ = true;
                        }
                        let _e261 = phi_506_;
                        let _e263 = phi_507_;
                        phi_508_ = _e261;
                        phi_509_ = _e263;
                    } else {
                        phi_508_ = u32();
                        phi_509_ = true;
                    }
                    let _e265 = phi_508_;
                    let _e267 = phi_509_;
                    if _e267 {
                        phi_513_ = 4294967295u;
                    } else {
                        phi_513_ = _e265;
                    }
                    let _e269 = phi_513_;
                    if _e232 {
                        phi_518_ = !(_e245);
                    } else {
                        phi_518_ = false;
                    }
                    let _e272 = phi_518_;
                    if _e243 {
                        phi_523_ = !(_e247);
                    } else {
                        phi_523_ = false;
                    }
                    let _e275 = phi_523_;
                    if _e272 {
                        if _e275 {
                            let _e277 = ((_e187.member_3.w & 2147483648u) != 0u);
                            if _e277 {
                                phi_535_ = _e187.member_1.w;
                            } else {
                                phi_535_ = _e187.member.w;
                            }
                            let _e279 = phi_535_;
                            let _e281 = local.member_1;
                            local.member[_e281] = _e279;
                            let _e286 = local.member_1;
                            local.member_1 = (_e286 + 1u);
                            if _e277 {
                                phi_551_ = _e187.member.w;
                            } else {
                                phi_551_ = _e187.member_1.w;
                            }
                            let _e289 = phi_551_;
                            local.member_2 = _e289;
                            phi_553_ = false;
                        } else {
                            phi_553_ = true;
                        }
                        let _e292 = phi_553_;
                        phi_554_ = _e292;
                    } else {
                        phi_554_ = true;
                    }
                    let _e294 = phi_554_;
                    if _e294 {
                        if _e272 {
                            local.member_2 = _e187.member.w;
                        } else {
                            if _e275 {
                                local.member_2 = _e187.member_1.w;
                            } else {
                                let _e296 = local.member_1;
                                if (_e296 > 0u) {
                                    let _e301 = local.member_1;
                                    local.member_1 = (_e301 - 1u);
                                    let _e304 = local.member_1;
                                    let _e307 = local.member[_e304];
                                    local.member_2 = _e307;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e258 != 4294967295u) {
                        let _e314 = params.member.member_2.member;
                        if (_e314 == 0u) {
                            phi_600_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_600_ = array<u32, 2>(1u, 1u);
                        }
                        let _e317 = phi_600_;
                        let _e322 = params.member.member.member_2[_e317[1]];
                        let _e325 = order.member[(_e322 + _e258)];
                        let _e326 = (_e325 - _e322);
                        let _e329 = params.member.member_2.member;
                        if (_e329 == 0u) {
                            phi_633_ = true;
                        } else {
                            phi_633_ = (_e326 > _e88);
                        }
                        let _e333 = phi_633_;
                        if _e333 {
                            let _e336 = params.member.member_1.member_3;
                            let _e338 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e338 + 1u) < _e338) {
                                let _e342 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e338 < _e336) {
                                let _e344 = (2u * _e338);
                                atomicStore((&pairs.member[(4u + _e344)]), _e88);
                                atomicStore((&pairs.member[(_e344 + 5u)]), _e326);
                            }
                        }
                    }
                    if (_e269 != 4294967295u) {
                        let _e352 = params.member.member_2.member;
                        if (_e352 == 0u) {
                            phi_676_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_676_ = array<u32, 2>(1u, 1u);
                        }
                        let _e355 = phi_676_;
                        let _e360 = params.member.member.member_2[_e355[1]];
                        let _e363 = order.member[(_e360 + _e269)];
                        let _e364 = (_e363 - _e360);
                        let _e367 = params.member.member_2.member;
                        if (_e367 == 0u) {
                            phi_709_ = true;
                        } else {
                            phi_709_ = (_e364 > _e88);
                        }
                        let _e371 = phi_709_;
                        if _e371 {
                            let _e374 = params.member.member_1.member_3;
                            let _e376 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e376 + 1u) < _e376) {
                                let _e380 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e376 < _e374) {
                                let _e382 = (2u * _e376);
                                atomicStore((&pairs.member[(4u + _e382)]), _e88);
                                atomicStore((&pairs.member[(_e382 + 5u)]), _e364);
                            }
                        }
                    }
                }
                phi_760_ = _e183;
            } else {
                phi_760_ = false;
            }
            let _e388 = phi_760_;
            continue;
            continuing {
                phi_347_ = _e176;
                break if !(_e388);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
