struct type_10 {
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

struct type_12 {
    member: type_10,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_15>,
}

struct type_22 {
    member: array<u32>,
}

struct type_28 {
    member: u32,
    member_1: u32,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_33 {
    member: array<type_30>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_38 {
    member: array<type_35>,
}

struct type_43 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> branches: type_33;
@group(0) @binding(4) 
var<storage, read_write> out: type_48;

fn function_() {
    var local: type_43;
    var phi_226_: type_28;
    var phi_227_: type_28;
    var phi_250_: type_28;
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

    let _e30 = id_1;
    let _e31 = n_1;
    let _e32 = lane_1;
    let _e44 = ((((_e30.y * _e31.x) + _e30.x) * 128u) + _e32);
    let _e46 = params.member.member_17;
    if (_e44 < _e46) {
        let _e50 = params.member.member[1u];
        let _e53 = params.member.member_12;
        let _e54 = (_e53 + _e44);
        let _e56 = boxes.member[_e54];
        local = type_43(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_226_ = type_28(0u, (_e50 - 1u));
        loop {
            let _e59 = phi_226_;
            if (_e59.member < _e59.member_1) {
                phi_227_ = type_28((_e59.member + 1u), _e59.member_1);
                phi_250_ = type_28(1u, _e59.member);
            } else {
                phi_227_ = _e59;
                phi_250_ = type_28(0u, type_28().member_1);
            }
            let _e73 = phi_227_;
            let _e75 = phi_250_;
            if (bitcast<i32>(_e75.member) != 0i) {
                let _e80 = local.member_3;
                if _e80 {
                    let _e82 = local.member_2;
                    let _e84 = branches.member[_e82];
                    let _e87 = nodes.member[_e84.member];
                    let _e90 = nodes.member[_e84.member_1];
                    let _e121 = ((((((_e87.member[0] <= _e56.member_1[0]) && (_e56.member[0] <= _e87.member_2[0])) && (_e87.member[1] <= _e56.member_1[1])) && (_e56.member[1] <= _e87.member_2[1])) && (_e87.member[2] <= _e56.member_1[2])) && (_e56.member[2] <= _e87.member_2[2]));
                    let _e152 = ((((((_e90.member[0] <= _e56.member_1[0]) && (_e56.member[0] <= _e90.member_2[0])) && (_e90.member[1] <= _e56.member_1[1])) && (_e56.member[1] <= _e90.member_2[1])) && (_e90.member[2] <= _e56.member_1[2])) && (_e56.member[2] <= _e90.member_2[2]));
                    if _e121 {
                        if (_e87.member_3 == 4294967295u) {
                            phi_393_ = _e87.member_1;
                            phi_394_ = false;
                        } else {
                            phi_393_ = u32();
                            phi_394_ = true;
                        }
                        let _e157 = phi_393_;
                        let _e159 = phi_394_;
                        phi_395_ = _e157;
                        phi_396_ = _e159;
                    } else {
                        phi_395_ = u32();
                        phi_396_ = true;
                    }
                    let _e161 = phi_395_;
                    let _e163 = phi_396_;
                    if _e163 {
                        phi_400_ = 4294967295u;
                    } else {
                        phi_400_ = _e161;
                    }
                    let _e165 = phi_400_;
                    if _e152 {
                        if (_e90.member_3 == 4294967295u) {
                            phi_410_ = _e90.member_1;
                            phi_411_ = false;
                        } else {
                            phi_410_ = u32();
                            phi_411_ = true;
                        }
                        let _e170 = phi_410_;
                        let _e172 = phi_411_;
                        phi_412_ = _e170;
                        phi_413_ = _e172;
                    } else {
                        phi_412_ = u32();
                        phi_413_ = true;
                    }
                    let _e174 = phi_412_;
                    let _e176 = phi_413_;
                    if _e176 {
                        phi_417_ = 4294967295u;
                    } else {
                        phi_417_ = _e174;
                    }
                    let _e178 = phi_417_;
                    if _e121 {
                        phi_424_ = !((_e87.member_3 == 4294967295u));
                    } else {
                        phi_424_ = false;
                    }
                    let _e183 = phi_424_;
                    if _e152 {
                        phi_431_ = !((_e90.member_3 == 4294967295u));
                    } else {
                        phi_431_ = false;
                    }
                    let _e188 = phi_431_;
                    if _e183 {
                        local.member_2 = _e84.member;
                        if _e188 {
                            let _e210 = local.member_1;
                            if (_e210 < 96u) {
                            } else {
                                return;
                            }
                            local.member[_e210] = _e84.member_1;
                            let _e216 = local.member_1;
                            local.member_1 = (_e216 + 1u);
                        }
                    } else {
                        if _e188 {
                            local.member_2 = _e84.member_1;
                        } else {
                            let _e190 = local.member_1;
                            if (_e190 > 0u) {
                                let _e195 = local.member_1;
                                local.member_1 = (_e195 - 1u);
                                let _e198 = local.member_1;
                                if (_e198 < 96u) {
                                } else {
                                    return;
                                }
                                let _e202 = local.member[_e198];
                                local.member_2 = _e202;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    if (_e165 != 4294967295u) {
                        let _e220 = params.member.member_16;
                        let _e222 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e222 + 1u) < _e222) {
                            let _e226 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e222 < _e220) {
                            atomicStore((&out.member[(4u + (2u * _e222))]), _e54);
                            atomicStore((&out.member[((2u * _e222) + 5u)]), _e165);
                        }
                    }
                    if (_e178 != 4294967295u) {
                        let _e236 = params.member.member_16;
                        let _e238 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e238 + 1u) < _e238) {
                            let _e242 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e238 < _e236) {
                            atomicStore((&out.member[(4u + (2u * _e238))]), _e54);
                            atomicStore((&out.member[((2u * _e238) + 5u)]), _e178);
                        }
                    }
                }
                phi_541_ = _e80;
            } else {
                phi_541_ = false;
            }
            let _e251 = phi_541_;
            continue;
            continuing {
                phi_226_ = _e73;
                break if !(_e251);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_against(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
