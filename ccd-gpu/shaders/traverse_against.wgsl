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

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> boxes: type_13;
@group(0) @binding(2) 
var<storage> nodes: type_22;
@group(0) @binding(3) 
var<storage> branches: type_19;
@group(0) @binding(4) 
var<storage, read_write> out: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var phi_226_: type_16;
    var phi_227_: type_16;
    var phi_250_: type_16;
    var phi_393_: u32;
    var phi_394_: bool;
    var phi_395_: u32;
    var phi_396_: bool;
    var phi_400_: u32;
    var phi_410_: u32;
    var phi_411_: bool;
    var phi_412_: u32;
    var phi_413_: bool;
    var phi_417_: u32;
    var phi_424_: bool;
    var phi_431_: bool;
    var phi_541_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e36 = ((((_e22.y * _e23.x) + _e22.x) * 128u) + _e24);
    let _e38 = params.member.member_17;
    if (_e36 < _e38) {
        let _e42 = params.member.member[1u];
        let _e45 = params.member.member_12;
        let _e46 = (_e45 + _e36);
        let _e48 = boxes.member[_e46];
        local = type_24(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_226_ = type_16(0u, (_e42 - 1u));
        loop {
            let _e51 = phi_226_;
            if (_e51.member < _e51.member_1) {
                phi_227_ = type_16((_e51.member + 1u), _e51.member_1);
                phi_250_ = type_16(1u, _e51.member);
            } else {
                phi_227_ = _e51;
                phi_250_ = type_16(0u, type_16().member_1);
            }
            let _e63 = phi_227_;
            let _e65 = phi_250_;
            if (bitcast<i32>(_e65.member) != 0i) {
                let _e70 = local.member_3;
                if _e70 {
                    let _e72 = local.member_2;
                    let _e74 = branches.member[_e72];
                    let _e77 = nodes.member[_e74.member];
                    let _e80 = nodes.member[_e74.member_1];
                    let _e111 = ((((((_e77.member[0] <= _e48.member_1[0]) && (_e48.member[0] <= _e77.member_2[0])) && (_e77.member[1] <= _e48.member_1[1])) && (_e48.member[1] <= _e77.member_2[1])) && (_e77.member[2] <= _e48.member_1[2])) && (_e48.member[2] <= _e77.member_2[2]));
                    let _e142 = ((((((_e80.member[0] <= _e48.member_1[0]) && (_e48.member[0] <= _e80.member_2[0])) && (_e80.member[1] <= _e48.member_1[1])) && (_e48.member[1] <= _e80.member_2[1])) && (_e80.member[2] <= _e48.member_1[2])) && (_e48.member[2] <= _e80.member_2[2]));
                    if _e111 {
                        if (_e77.member_3 == 4294967295u) {
                            phi_393_ = _e77.member_1;
                            phi_394_ = false;
                        } else {
                            phi_393_ = u32();
                            phi_394_ = true;
                        }
                        let _e147 = phi_393_;
                        let _e149 = phi_394_;
                        phi_395_ = _e147;
                        phi_396_ = _e149;
                    } else {
                        phi_395_ = u32();
                        phi_396_ = true;
                    }
                    let _e151 = phi_395_;
                    let _e153 = phi_396_;
                    if _e153 {
                        phi_400_ = 4294967295u;
                    } else {
                        phi_400_ = _e151;
                    }
                    let _e155 = phi_400_;
                    if _e142 {
                        if (_e80.member_3 == 4294967295u) {
                            phi_410_ = _e80.member_1;
                            phi_411_ = false;
                        } else {
                            phi_410_ = u32();
                            phi_411_ = true;
                        }
                        let _e160 = phi_410_;
                        let _e162 = phi_411_;
                        phi_412_ = _e160;
                        phi_413_ = _e162;
                    } else {
                        phi_412_ = u32();
                        phi_413_ = true;
                    }
                    let _e164 = phi_412_;
                    let _e166 = phi_413_;
                    if _e166 {
                        phi_417_ = 4294967295u;
                    } else {
                        phi_417_ = _e164;
                    }
                    let _e168 = phi_417_;
                    if _e111 {
                        phi_424_ = !((_e77.member_3 == 4294967295u));
                    } else {
                        phi_424_ = false;
                    }
                    let _e173 = phi_424_;
                    if _e142 {
                        phi_431_ = !((_e80.member_3 == 4294967295u));
                    } else {
                        phi_431_ = false;
                    }
                    let _e178 = phi_431_;
                    if _e173 {
                        local.member_2 = _e74.member;
                        if _e178 {
                            let _e199 = local.member_1;
                            local.member[_e199] = _e74.member_1;
                            let _e204 = local.member_1;
                            local.member_1 = (_e204 + 1u);
                        }
                    } else {
                        if _e178 {
                            local.member_2 = _e74.member_1;
                        } else {
                            let _e180 = local.member_1;
                            if (_e180 > 0u) {
                                let _e185 = local.member_1;
                                local.member_1 = (_e185 - 1u);
                                let _e188 = local.member_1;
                                let _e191 = local.member[_e188];
                                local.member_2 = _e191;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    if (_e155 != 4294967295u) {
                        let _e208 = params.member.member_16;
                        let _e210 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e210 + 1u) < _e210) {
                            let _e214 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e210 < _e208) {
                            atomicStore((&out.member[(4u + (2u * _e210))]), _e46);
                            atomicStore((&out.member[((2u * _e210) + 5u)]), _e155);
                        }
                    }
                    if (_e168 != 4294967295u) {
                        let _e224 = params.member.member_16;
                        let _e226 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e226 + 1u) < _e226) {
                            let _e230 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e226 < _e224) {
                            atomicStore((&out.member[(4u + (2u * _e226))]), _e46);
                            atomicStore((&out.member[((2u * _e226) + 5u)]), _e168);
                        }
                    }
                }
                phi_541_ = _e70;
            } else {
                phi_541_ = false;
            }
            let _e239 = phi_541_;
            continue;
            continuing {
                phi_226_ = _e63;
                break if !(_e239);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_against(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
