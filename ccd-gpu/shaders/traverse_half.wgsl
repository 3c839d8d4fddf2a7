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
    member: array<u32, 31>,
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
    var phi_156_: type_9;
    var phi_157_: type_9;
    var phi_180_: type_9;
    var phi_215_: u32;
    var phi_246_: bool;
    var phi_276_: bool;
    var phi_286_: bool;
    var phi_316_: bool;
    var phi_326_: u32;
    var phi_327_: bool;
    var phi_328_: u32;
    var phi_329_: bool;
    var phi_333_: u32;
    var phi_343_: u32;
    var phi_344_: bool;
    var phi_345_: u32;
    var phi_346_: bool;
    var phi_350_: u32;
    var phi_357_: bool;
    var phi_364_: bool;
    var phi_381_: u32;
    var phi_399_: u32;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_451_: type_9;
    var phi_491_: type_9;
    var phi_517_: bool;
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
        let _e54 = params.member.member.member[1u];
        let _e55 = (_e54 - 1u);
        local = type_19(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_156_ = type_9(0u, _e55);
        loop {
            let _e58 = phi_156_;
            if (_e58.member < _e58.member_1) {
                phi_157_ = type_9((_e58.member + 1u), _e58.member_1);
                phi_180_ = type_9(1u, _e58.member);
            } else {
                phi_157_ = _e58;
                phi_180_ = type_9(0u, type_9().member_1);
            }
            let _e70 = phi_157_;
            let _e72 = phi_180_;
            if (bitcast<i32>(_e72.member) != 0i) {
                let _e77 = local.member_3;
                if _e77 {
                    let _e81 = local.member_2;
                    let _e83 = branches.member[_e81];
                    if (_e83.member >= _e55) {
                        phi_215_ = (_e83.member - _e55);
                    } else {
                        phi_215_ = _e83.member;
                    }
                    let _e90 = phi_215_;
                    let _e93 = nodes.member[_e83.member];
                    let _e96 = nodes.member[_e83.member_1];
                    if (_e42 == 4294967295u) {
                        phi_246_ = true;
                    } else {
                        phi_246_ = (_e90 > _e42);
                    }
                    let _e100 = phi_246_;
                    if _e100 {
                        phi_276_ = ((((((_e93.member[0] <= _e50.member_2[0]) && (_e50.member[0] <= _e93.member_2[0])) && (_e93.member[1] <= _e50.member_2[1])) && (_e50.member[1] <= _e93.member_2[1])) && (_e93.member[2] <= _e50.member_2[2])) && (_e50.member[2] <= _e93.member_2[2]));
                    } else {
                        phi_276_ = false;
                    }
                    let _e127 = phi_276_;
                    if (_e42 == 4294967295u) {
                        phi_286_ = true;
                    } else {
                        phi_286_ = (_e83.member_3 > _e42);
                    }
                    let _e132 = phi_286_;
                    if _e132 {
                        phi_316_ = ((((((_e96.member[0] <= _e50.member_2[0]) && (_e50.member[0] <= _e96.member_2[0])) && (_e96.member[1] <= _e50.member_2[1])) && (_e50.member[1] <= _e96.member_2[1])) && (_e96.member[2] <= _e50.member_2[2])) && (_e50.member[2] <= _e96.member_2[2]));
                    } else {
                        phi_316_ = false;
                    }
                    let _e159 = phi_316_;
                    if _e127 {
                        if (_e93.member_3 == 4294967295u) {
                            phi_326_ = _e93.member_1;
                            phi_327_ = false;
                        } else {
                            phi_326_ = u32();
                            phi_327_ = true;
                        }
                        let _e164 = phi_326_;
                        let _e166 = phi_327_;
                        phi_328_ = _e164;
                        phi_329_ = _e166;
                    } else {
                        phi_328_ = u32();
                        phi_329_ = true;
                    }
                    let _e168 = phi_328_;
                    let _e170 = phi_329_;
                    if _e170 {
                        phi_333_ = 4294967295u;
                    } else {
                        phi_333_ = _e168;
                    }
                    let _e172 = phi_333_;
                    if _e159 {
                        if (_e96.member_3 == 4294967295u) {
                            phi_343_ = _e96.member_1;
                            phi_344_ = false;
                        } else {
                            phi_343_ = u32();
                            phi_344_ = true;
                        }
                        let _e177 = phi_343_;
                        let _e179 = phi_344_;
                        phi_345_ = _e177;
                        phi_346_ = _e179;
                    } else {
                        phi_345_ = u32();
                        phi_346_ = true;
                    }
                    let _e181 = phi_345_;
                    let _e183 = phi_346_;
                    if _e183 {
                        phi_350_ = 4294967295u;
                    } else {
                        phi_350_ = _e181;
                    }
                    let _e185 = phi_350_;
                    if _e127 {
                        phi_357_ = !((_e93.member_3 == 4294967295u));
                    } else {
                        phi_357_ = false;
                    }
                    let _e190 = phi_357_;
                    if _e159 {
                        phi_364_ = !((_e96.member_3 == 4294967295u));
                    } else {
                        phi_364_ = false;
                    }
                    let _e195 = phi_364_;
                    if _e190 {
                        if _e195 {
                            let _e200 = ((_e90 - _e83.member_2) < (_e83.member_3 - _e90));
                            if _e200 {
                                phi_381_ = _e83.member_1;
                            } else {
                                phi_381_ = _e83.member;
                            }
                            let _e204 = phi_381_;
                            let _e206 = local.member_1;
                            local.member[_e206] = _e204;
                            let _e211 = local.member_1;
                            local.member_1 = (_e211 + 1u);
                            if _e200 {
                                phi_399_ = _e83.member;
                            } else {
                                phi_399_ = _e83.member_1;
                            }
                            let _e216 = phi_399_;
                            local.member_2 = _e216;
                            phi_401_ = false;
                        } else {
                            phi_401_ = true;
                        }
                        let _e219 = phi_401_;
                        phi_402_ = _e219;
                    } else {
                        phi_402_ = true;
                    }
                    let _e221 = phi_402_;
                    if _e221 {
                        if _e190 {
                            local.member_2 = _e83.member;
                        } else {
                            if _e195 {
                                local.member_2 = _e83.member_1;
                            } else {
                                let _e223 = local.member_1;
                                if (_e223 > 0u) {
                                    let _e228 = local.member_1;
                                    local.member_1 = (_e228 - 1u);
                                    let _e231 = local.member_1;
                                    let _e234 = local.member[_e231];
                                    local.member_2 = _e234;
                                } else {
                                    local.member_3 = false;
                                }
                            }
                        }
                    }
                    if (_e172 != 4294967295u) {
                        let _e244 = params.member.member_1.member_3;
                        if (_e50.member_1 < _e172) {
                            phi_451_ = type_9(_e50.member_1, _e172);
                        } else {
                            phi_451_ = type_9(_e172, _e50.member_1);
                        }
                        let _e249 = phi_451_;
                        let _e253 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e253 + 1u) < _e253) {
                            let _e257 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e253 < _e244) {
                            let _e259 = (2u * _e253);
                            atomicStore((&pairs.member[(4u + _e259)]), _e249.member);
                            atomicStore((&pairs.member[(_e259 + 5u)]), _e249.member_1);
                        }
                    }
                    if (_e185 != 4294967295u) {
                        let _e268 = params.member.member_1.member_3;
                        if (_e50.member_1 < _e185) {
                            phi_491_ = type_9(_e50.member_1, _e185);
                        } else {
                            phi_491_ = type_9(_e185, _e50.member_1);
                        }
                        let _e273 = phi_491_;
                        let _e277 = atomicAdd((&pairs.member[0u]), 1u);
                        if ((_e277 + 1u) < _e277) {
                            let _e281 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        if (_e277 < _e268) {
                            let _e283 = (2u * _e277);
                            atomicStore((&pairs.member[(4u + _e283)]), _e273.member);
                            atomicStore((&pairs.member[(_e283 + 5u)]), _e273.member_1);
                        }
                    }
                }
                phi_517_ = _e77;
            } else {
                phi_517_ = false;
            }
            let _e289 = phi_517_;
            continue;
            continuing {
                phi_156_ = _e70;
                break if !(_e289);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
