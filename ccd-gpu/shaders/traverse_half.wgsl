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

struct type_17 {
    member: array<u32>,
}

struct type_22 {
    member: u32,
    member_1: u32,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_27 {
    member: array<type_24>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_32 {
    member: array<type_29>,
}

struct type_37 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> nodes: type_32;
@group(0) @binding(2) 
var<storage> branches: type_27;
@group(0) @binding(3) 
var<storage, read_write> out: type_42;

fn function_() {
    var local: type_37;
    var phi_222_: type_22;
    var phi_223_: type_22;
    var phi_246_: type_22;
    var phi_278_: u32;
    var phi_309_: bool;
    var phi_339_: bool;
    var phi_349_: bool;
    var phi_379_: bool;
    var phi_389_: u32;
    var phi_390_: bool;
    var phi_391_: u32;
    var phi_392_: bool;
    var phi_396_: u32;
    var phi_406_: u32;
    var phi_407_: bool;
    var phi_408_: u32;
    var phi_409_: bool;
    var phi_413_: u32;
    var phi_420_: bool;
    var phi_427_: bool;
    var phi_488_: type_22;
    var phi_529_: type_22;
    var phi_557_: bool;

    let _e29 = id_1;
    let _e30 = n_1;
    let _e31 = lane_1;
    let _e42 = ((((_e29.y * _e30.x) + _e29.x) * 128u) + _e31);
    let _e44 = params.member.member_17;
    if (_e42 < _e44) {
        let _e48 = params.member.member[1u];
        let _e49 = (_e48 - 1u);
        let _e51 = params.member.member_12;
        let _e52 = (_e51 + _e42);
        let _e55 = nodes.member[(_e49 + _e52)];
        local = type_37(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_222_ = type_22(0u, _e49);
        loop {
            let _e60 = phi_222_;
            if (_e60.member < _e60.member_1) {
                phi_223_ = type_22((_e60.member + 1u), _e60.member_1);
                phi_246_ = type_22(1u, _e60.member);
            } else {
                phi_223_ = _e60;
                phi_246_ = type_22(0u, type_22().member_1);
            }
            let _e74 = phi_223_;
            let _e76 = phi_246_;
            if (bitcast<i32>(_e76.member) != 0i) {
                let _e81 = local.member_3;
                if _e81 {
                    let _e83 = local.member_2;
                    let _e85 = branches.member[_e83];
                    if (_e85.member >= _e49) {
                        phi_278_ = (_e85.member - _e49);
                    } else {
                        phi_278_ = _e85.member;
                    }
                    let _e92 = phi_278_;
                    let _e95 = nodes.member[_e85.member];
                    let _e98 = nodes.member[_e85.member_1];
                    if (_e52 == 4294967295u) {
                        phi_309_ = true;
                    } else {
                        phi_309_ = (_e92 > _e52);
                    }
                    let _e102 = phi_309_;
                    if _e102 {
                        phi_339_ = ((((((_e95.member[0] <= _e55.member_2[0]) && (_e55.member[0] <= _e95.member_2[0])) && (_e95.member[1] <= _e55.member_2[1])) && (_e55.member[1] <= _e95.member_2[1])) && (_e95.member[2] <= _e55.member_2[2])) && (_e55.member[2] <= _e95.member_2[2]));
                    } else {
                        phi_339_ = false;
                    }
                    let _e129 = phi_339_;
                    if (_e52 == 4294967295u) {
                        phi_349_ = true;
                    } else {
                        phi_349_ = (_e85.member_3 > _e52);
                    }
                    let _e134 = phi_349_;
                    if _e134 {
                        phi_379_ = ((((((_e98.member[0] <= _e55.member_2[0]) && (_e55.member[0] <= _e98.member_2[0])) && (_e98.member[1] <= _e55.member_2[1])) && (_e55.member[1] <= _e98.member_2[1])) && (_e98.member[2] <= _e55.member_2[2])) && (_e55.member[2] <= _e98.member_2[2]));
                    } else {
                        phi_379_ = false;
                    }
                    let _e161 = phi_379_;
                    if _e129 {
                        if (_e95.member_3 == 4294967295u) {
                            phi_389_ = _e95.member_1;
                            phi_390_ = false;
                        } else {
                            phi_389_ = u32();
                            phi_390_ = true;
                        }
                        let _e166 = phi_389_;
                        let _e168 = phi_390_;
                        phi_391_ = _e166;
                        phi_392_ = _e168;
                    } else {
                        phi_391_ = u32();
                        phi_392_ = true;
                    }
                    let _e170 = phi_391_;
                    let _e172 = phi_392_;
                    if _e172 {
                        phi_396_ = 4294967295u;
                    } else {
                        phi_396_ = _e170;
                    }
                    let _e174 = phi_396_;
                    if _e161 {
                        if (_e98.member_3 == 4294967295u) {
                            phi_406_ = _e98.member_1;
                            phi_407_ = false;
                        } else {
                            phi_406_ = u32();
                            phi_407_ = true;
                        }
                        let _e179 = phi_406_;
                        let _e181 = phi_407_;
                        phi_408_ = _e179;
                        phi_409_ = _e181;
                    } else {
                        phi_408_ = u32();
                        phi_409_ = true;
                    }
                    let _e183 = phi_408_;
                    let _e185 = phi_409_;
                    if _e185 {
                        phi_413_ = 4294967295u;
                    } else {
                        phi_413_ = _e183;
                    }
                    let _e187 = phi_413_;
                    if _e129 {
                        phi_420_ = !((_e95.member_3 == 4294967295u));
                    } else {
                        phi_420_ = false;
                    }
                    let _e192 = phi_420_;
                    if _e161 {
                        phi_427_ = !((_e98.member_3 == 4294967295u));
                    } else {
                        phi_427_ = false;
                    }
                    let _e197 = phi_427_;
                    if _e192 {
                        local.member_2 = _e85.member;
                        if _e197 {
                            let _e219 = local.member_1;
                            if (_e219 < 96u) {
                            } else {
                                return;
                            }
                            local.member[_e219] = _e85.member_1;
                            let _e225 = local.member_1;
                            local.member_1 = (_e225 + 1u);
                        }
                    } else {
                        if _e197 {
                            local.member_2 = _e85.member_1;
                        } else {
                            let _e199 = local.member_1;
                            if (_e199 > 0u) {
                                let _e204 = local.member_1;
                                local.member_1 = (_e204 - 1u);
                                let _e207 = local.member_1;
                                if (_e207 < 96u) {
                                } else {
                                    return;
                                }
                                let _e211 = local.member[_e207];
                                local.member_2 = _e211;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    if (_e174 != 4294967295u) {
                        let _e229 = params.member.member_16;
                        if (_e55.member_1 < _e174) {
                            phi_488_ = type_22(_e55.member_1, _e174);
                        } else {
                            phi_488_ = type_22(_e174, _e55.member_1);
                        }
                        let _e235 = phi_488_;
                        let _e239 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e239 + 1u) < _e239) {
                            let _e243 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e239 < _e229) {
                            atomicStore((&out.member[(4u + (2u * _e239))]), _e235.member);
                            atomicStore((&out.member[((2u * _e239) + 5u)]), _e235.member_1);
                        }
                    }
                    if (_e187 != 4294967295u) {
                        let _e253 = params.member.member_16;
                        if (_e55.member_1 < _e187) {
                            phi_529_ = type_22(_e55.member_1, _e187);
                        } else {
                            phi_529_ = type_22(_e187, _e55.member_1);
                        }
                        let _e259 = phi_529_;
                        let _e263 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e263 + 1u) < _e263) {
                            let _e267 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e263 < _e253) {
                            atomicStore((&out.member[(4u + (2u * _e263))]), _e259.member);
                            atomicStore((&out.member[((2u * _e263) + 5u)]), _e259.member_1);
                        }
                    }
                }
                phi_557_ = _e81;
            } else {
                phi_557_ = false;
            }
            let _e276 = phi_557_;
            continue;
            continuing {
                phi_222_ = _e74;
                break if !(_e276);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
