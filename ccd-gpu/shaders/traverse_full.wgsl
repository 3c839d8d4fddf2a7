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

struct type_17 {
    member: array<type_8>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(3) 
var<storage> nodes: type_24;
@group(0) @binding(4) 
var<storage> branches: type_17;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_29;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var phi_116_: array<u32, 2>;
    var phi_149_: u32;
    var phi_236_: bool;
    var phi_306_: type_9;
    var phi_307_: type_9;
    var phi_330_: type_9;
    var phi_362_: u32;
    var phi_473_: u32;
    var phi_474_: bool;
    var phi_475_: u32;
    var phi_476_: bool;
    var phi_480_: u32;
    var phi_490_: u32;
    var phi_491_: bool;
    var phi_492_: u32;
    var phi_493_: bool;
    var phi_497_: u32;
    var phi_504_: bool;
    var phi_511_: bool;
    var phi_528_: u32;
    var phi_546_: u32;
    var phi_548_: bool;
    var phi_549_: bool;
    var phi_599_: bool;
    var phi_644_: bool;
    var phi_674_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e25 = id_2;
    let _e26 = n_2;
    let _e27 = lane_2;
    let _e40 = ((((_e25.y * _e26.x) + _e25.x) * 128u) + _e27);
    let _e43 = params.member.member_1.member;
    if (_e40 < _e43) {
        let _e47 = params.member.member_2.member;
        if (_e47 == 0u) {
            phi_116_ = array<u32, 2>(0u, 2u);
        } else {
            phi_116_ = array<u32, 2>(1u, 1u);
        }
        let _e50 = phi_116_;
        let _e56 = params.member.member.member_2[_e50[0]];
        let _e59 = params.member.member_1.member_1;
        let _e61 = ((_e56 + _e59) + _e40);
        let _e64 = params.member.member_2.member_1;
        if (_e64 == 0u) {
            phi_149_ = _e61;
        } else {
            let _e67 = order.member[_e61];
            phi_149_ = _e67;
        }
        let _e69 = phi_149_;
        let _e71 = boxes.member[_e69];
        let _e75 = params.member.member.member_2[_e50[0]];
        let _e76 = (_e69 - _e75);
        let _e80 = params.member.member.member[_e50[1]];
        let _e81 = (_e80 - 1u);
        if (_e81 == 0u) {
            let _e84 = nodes.member[0u];
            if ((((((_e84.member[0] <= _e71.member_1[0]) && (_e71.member[0] <= _e84.member_2[0])) && (_e84.member[1] <= _e71.member_1[1])) && (_e71.member[1] <= _e84.member_2[1])) && (_e84.member[2] <= _e71.member_1[2])) && (_e71.member[2] <= _e84.member_2[2])) {
                if (_e84.member_1 != 4294967295u) {
                    let _e120 = params.member.member_2.member;
                    if (_e120 == 0u) {
                        phi_236_ = true;
                    } else {
                        phi_236_ = (_e84.member_1 > _e76);
                    }
                    let _e124 = phi_236_;
                    if _e124 {
                        let _e127 = params.member.member_1.member_3;
                        let _e129 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e129 + 1u) < _e129) {
                            let _e133 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e129 < _e127) {
                            let _e135 = (2u * _e129);
                            atomicStore((&pairs.member[(4u + _e135)]), _e76);
                            atomicStore((&pairs.member[(_e135 + 5u)]), _e84.member_1);
                        }
                    }
                }
            }
        }
        local = type_26(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_306_ = type_9(0u, _e81);
        loop {
            let _e142 = phi_306_;
            if (_e142.member < _e142.member_1) {
                phi_307_ = type_9((_e142.member + 1u), _e142.member_1);
                phi_330_ = type_9(1u, _e142.member);
            } else {
                phi_307_ = _e142;
                phi_330_ = type_9(0u, type_9().member_1);
            }
            let _e154 = phi_307_;
            let _e156 = phi_330_;
            if (bitcast<i32>(_e156.member) != 0i) {
                let _e161 = local.member_3;
                if _e161 {
                    let _e163 = local.member_2;
                    let _e165 = branches.member[_e163];
                    if (_e165.member >= _e81) {
                        phi_362_ = (_e165.member - _e81);
                    } else {
                        phi_362_ = _e165.member;
                    }
                    let _e172 = phi_362_;
                    let _e175 = nodes.member[_e165.member];
                    let _e178 = nodes.member[_e165.member_1];
                    let _e209 = ((((((_e175.member[0] <= _e71.member_1[0]) && (_e71.member[0] <= _e175.member_2[0])) && (_e175.member[1] <= _e71.member_1[1])) && (_e71.member[1] <= _e175.member_2[1])) && (_e175.member[2] <= _e71.member_1[2])) && (_e71.member[2] <= _e175.member_2[2]));
                    let _e240 = ((((((_e178.member[0] <= _e71.member_1[0]) && (_e71.member[0] <= _e178.member_2[0])) && (_e178.member[1] <= _e71.member_1[1])) && (_e71.member[1] <= _e178.member_2[1])) && (_e178.member[2] <= _e71.member_1[2])) && (_e71.member[2] <= _e178.member_2[2]));
                    if _e209 {
                        if (_e175.member_3 == 4294967295u) {
                            phi_473_ = _e175.member_1;
                            phi_474_ = false;
                        } else {
                            phi_473_ = u32();
                            phi_474_ = true;
                        }
                        let _e245 = phi_473_;
                        let _e247 = phi_474_;
                        phi_475_ = _e245;
                        phi_476_ = _e247;
                    } else {
                        phi_475_ = u32();
                        phi_476_ = true;
                    }
                    let _e249 = phi_475_;
                    let _e251 = phi_476_;
                    if _e251 {
                        phi_480_ = 4294967295u;
                    } else {
                        phi_480_ = _e249;
                    }
                    let _e253 = phi_480_;
                    if _e240 {
                        if (_e178.member_3 == 4294967295u) {
                            phi_490_ = _e178.member_1;
                            phi_491_ = false;
                        } else {
                            phi_490_ = u32();
                            phi_491_ = true;
                        }
                        let _e258 = phi_490_;
                        let _e260 = phi_491_;
                        phi_492_ = _e258;
                        phi_493_ = _e260;
                    } else {
                        phi_492_ = u32();
                        phi_493_ = true;
                    }
                    let _e262 = phi_492_;
                    let _e264 = phi_493_;
                    if _e264 {
                        phi_497_ = 4294967295u;
                    } else {
                        phi_497_ = _e262;
                    }
                    let _e266 = phi_497_;
                    if _e209 {
                        phi_504_ = !((_e175.member_3 == 4294967295u));
                    } else {
                        phi_504_ = false;
                    }
                    let _e271 = phi_504_;
                    if _e240 {
                        phi_511_ = !((_e178.member_3 == 4294967295u));
                    } else {
                        phi_511_ = false;
                    }
                    let _e276 = phi_511_;
                    if _e271 {
                        if _e276 {
                            let _e281 = ((_e172 - _e165.member_2) < (_e165.member_3 - _e172));
                            if _e281 {
                                phi_528_ = _e165.member_1;
                            } else {
                                phi_528_ = _e165.member;
                            }
                            let _e285 = phi_528_;
                            let _e287 = local.member_1;
                            local.member[_e287] = _e285;
                            let _e292 = local.member_1;
                            local.member_1 = (_e292 + 1u);
                            if _e281 {
                                phi_546_ = _e165.member;
                            } else {
                                phi_546_ = _e165.member_1;
                            }
                            let _e297 = phi_546_;
                            local.member_2 = _e297;
                            phi_548_ = false;
                        } else {
                            phi_548_ = true;
                        }
                        let _e300 = phi_548_;
                        phi_549_ = _e300;
                    } else {
                        phi_549_ = true;
                    }
                    let _e302 = phi_549_;
                    if _e302 {
                        if _e271 {
                            local.member_2 = _e165.member;
                        } else {
                            if _e276 {
                                local.member_2 = _e165.member_1;
                            } else {
                                let _e304 = local.member_1;
                                if (_e304 > 0u) {
                                    let _e309 = local.member_1;
                                    local.member_1 = (_e309 - 1u);
                                    let _e312 = local.member_1;
                                    let _e315 = local.member[_e312];
                                    local.member_2 = _e315;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e253 != 4294967295u) {
                        let _e324 = params.member.member_2.member;
                        if (_e324 == 0u) {
                            phi_599_ = true;
                        } else {
                            phi_599_ = (_e253 > _e76);
                        }
                        let _e328 = phi_599_;
                        if _e328 {
                            let _e331 = params.member.member_1.member_3;
                            let _e333 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e333 + 1u) < _e333) {
                                let _e337 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e333 < _e331) {
                                let _e339 = (2u * _e333);
                                atomicStore((&pairs.member[(4u + _e339)]), _e76);
                                atomicStore((&pairs.member[(_e339 + 5u)]), _e253);
                            }
                        }
                    }
                    if (_e266 != 4294967295u) {
                        let _e347 = params.member.member_2.member;
                        if (_e347 == 0u) {
                            phi_644_ = true;
                        } else {
                            phi_644_ = (_e266 > _e76);
                        }
                        let _e351 = phi_644_;
                        if _e351 {
                            let _e354 = params.member.member_1.member_3;
                            let _e356 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e356 + 1u) < _e356) {
                                let _e360 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e356 < _e354) {
                                let _e362 = (2u * _e356);
                                atomicStore((&pairs.member[(4u + _e362)]), _e76);
                                atomicStore((&pairs.member[(_e362 + 5u)]), _e266);
                            }
                        }
                    }
                }
                phi_674_ = _e161;
            } else {
                phi_674_ = false;
            }
            let _e368 = phi_674_;
            continue;
            continuing {
                phi_306_ = _e154;
                break if !(_e368);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
