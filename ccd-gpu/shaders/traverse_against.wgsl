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
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_23 {
    member: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage> nodes: type_20;
@group(0) @binding(3) 
var<storage> branches: type_13;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_28;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_22;
    var phi_225_: type_9;
    var phi_226_: type_9;
    var phi_249_: type_9;
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
    var phi_572_: bool;
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
    let _e39 = params.member.member_1.member;
    if (_e36 < _e39) {
        let _e43 = params.member.member_1.member_1;
        let _e44 = (_e43 + _e36);
        let _e46 = boxes.member[_e44];
        let _e50 = params.member.member.member[1u];
        local = type_22(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_225_ = type_9(0u, (_e50 - 1u));
        loop {
            let _e54 = phi_225_;
            if (_e54.member < _e54.member_1) {
                phi_226_ = type_9((_e54.member + 1u), _e54.member_1);
                phi_249_ = type_9(1u, _e54.member);
            } else {
                phi_226_ = _e54;
                phi_249_ = type_9(0u, type_9().member_1);
            }
            let _e66 = phi_226_;
            let _e68 = phi_249_;
            if (bitcast<i32>(_e68.member) != 0i) {
                let _e73 = local.member_3;
                if _e73 {
                    let _e75 = local.member_2;
                    let _e77 = branches.member[_e75];
                    let _e80 = nodes.member[_e77.member];
                    let _e83 = nodes.member[_e77.member_1];
                    let _e114 = ((((((_e80.member[0] <= _e46.member_1[0]) && (_e46.member[0] <= _e80.member_2[0])) && (_e80.member[1] <= _e46.member_1[1])) && (_e46.member[1] <= _e80.member_2[1])) && (_e80.member[2] <= _e46.member_1[2])) && (_e46.member[2] <= _e80.member_2[2]));
                    let _e145 = ((((((_e83.member[0] <= _e46.member_1[0]) && (_e46.member[0] <= _e83.member_2[0])) && (_e83.member[1] <= _e46.member_1[1])) && (_e46.member[1] <= _e83.member_2[1])) && (_e83.member[2] <= _e46.member_1[2])) && (_e46.member[2] <= _e83.member_2[2]));
                    if _e114 {
                        if (_e80.member_3 == 4294967295u) {
                            phi_392_ = _e80.member_1;
                            phi_393_ = false;
                        } else {
                            phi_392_ = u32();
                            phi_393_ = true;
                        }
                        let _e150 = phi_392_;
                        let _e152 = phi_393_;
                        phi_394_ = _e150;
                        phi_395_ = _e152;
                    } else {
                        phi_394_ = u32();
                        phi_395_ = true;
                    }
                    let _e154 = phi_394_;
                    let _e156 = phi_395_;
                    if _e156 {
                        phi_399_ = 4294967295u;
                    } else {
                        phi_399_ = _e154;
                    }
                    let _e158 = phi_399_;
                    if _e145 {
                        if (_e83.member_3 == 4294967295u) {
                            phi_409_ = _e83.member_1;
                            phi_410_ = false;
                        } else {
                            phi_409_ = u32();
                            phi_410_ = true;
                        }
                        let _e163 = phi_409_;
                        let _e165 = phi_410_;
                        phi_411_ = _e163;
                        phi_412_ = _e165;
                    } else {
                        phi_411_ = u32();
                        phi_412_ = true;
                    }
                    let _e167 = phi_411_;
                    let _e169 = phi_412_;
                    if _e169 {
                        phi_416_ = 4294967295u;
                    } else {
                        phi_416_ = _e167;
                    }
                    let _e171 = phi_416_;
                    if _e114 {
                        phi_423_ = !((_e80.member_3 == 4294967295u));
                    } else {
                        phi_423_ = false;
                    }
                    let _e176 = phi_423_;
                    if _e145 {
                        phi_430_ = !((_e83.member_3 == 4294967295u));
                    } else {
                        phi_430_ = false;
                    }
                    let _e181 = phi_430_;
                    if _e176 {
                        local.member_2 = _e77.member;
                        if _e181 {
                            let _e202 = local.member_1;
                            local.member[_e202] = _e77.member_1;
                            let _e207 = local.member_1;
                            local.member_1 = (_e207 + 1u);
                        }
                    } else {
                        if _e181 {
                            local.member_2 = _e77.member_1;
                        } else {
                            let _e183 = local.member_1;
                            if (_e183 > 0u) {
                                let _e188 = local.member_1;
                                local.member_1 = (_e188 - 1u);
                                let _e191 = local.member_1;
                                let _e194 = local.member[_e191];
                                local.member_2 = _e194;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    let _e211 = params.member.member_1.member_3;
                    if (_e158 != 4294967295u) {
                        let _e214 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e214 + 1u) < _e214) {
                            let _e218 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e214 < _e211) {
                            let _e220 = (2u * _e214);
                            atomicStore((&pairs.member[(4u + _e220)]), _e44);
                            atomicStore((&pairs.member[(_e220 + 5u)]), _e158);
                        }
                    }
                    let _e227 = params.member.member_1.member_3;
                    if (_e171 != 4294967295u) {
                        let _e230 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e230 + 1u) < _e230) {
                            let _e234 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e230 < _e227) {
                            let _e236 = (2u * _e230);
                            atomicStore((&pairs.member[(4u + _e236)]), _e44);
                            atomicStore((&pairs.member[(_e236 + 5u)]), _e171);
                        }
                    }
                }
                phi_572_ = _e73;
            } else {
                phi_572_ = false;
            }
            let _e242 = phi_572_;
            continue;
            continuing {
                phi_225_ = _e66;
                break if !(_e242);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_against(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
