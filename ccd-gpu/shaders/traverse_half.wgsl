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

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<u32, 96>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_24 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> nodes: type_19;
@group(0) @binding(2) 
var<storage> branches: type_16;
@group(0) @binding(3) 
var<storage, read_write> out: type_24;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var phi_222_: type_13;
    var phi_223_: type_13;
    var phi_246_: type_13;
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
    var phi_488_: type_13;
    var phi_529_: type_13;
    var phi_557_: bool;
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
    let _e36 = params.member.member_17;
    if (_e34 < _e36) {
        let _e40 = params.member.member[1u];
        let _e41 = (_e40 - 1u);
        let _e43 = params.member.member_12;
        let _e44 = (_e43 + _e34);
        let _e47 = nodes.member[(_e41 + _e44)];
        local = type_21(array<u32, 96>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_222_ = type_13(0u, _e41);
        loop {
            let _e52 = phi_222_;
            if (_e52.member < _e52.member_1) {
                phi_223_ = type_13((_e52.member + 1u), _e52.member_1);
                phi_246_ = type_13(1u, _e52.member);
            } else {
                phi_223_ = _e52;
                phi_246_ = type_13(0u, type_13().member_1);
            }
            let _e64 = phi_223_;
            let _e66 = phi_246_;
            if (bitcast<i32>(_e66.member) != 0i) {
                let _e71 = local.member_3;
                if _e71 {
                    let _e73 = local.member_2;
                    let _e75 = branches.member[_e73];
                    if (_e75.member >= _e41) {
                        phi_278_ = (_e75.member - _e41);
                    } else {
                        phi_278_ = _e75.member;
                    }
                    let _e82 = phi_278_;
                    let _e85 = nodes.member[_e75.member];
                    let _e88 = nodes.member[_e75.member_1];
                    if (_e44 == 4294967295u) {
                        phi_309_ = true;
                    } else {
                        phi_309_ = (_e82 > _e44);
                    }
                    let _e92 = phi_309_;
                    if _e92 {
                        phi_339_ = ((((((_e85.member[0] <= _e47.member_2[0]) && (_e47.member[0] <= _e85.member_2[0])) && (_e85.member[1] <= _e47.member_2[1])) && (_e47.member[1] <= _e85.member_2[1])) && (_e85.member[2] <= _e47.member_2[2])) && (_e47.member[2] <= _e85.member_2[2]));
                    } else {
                        phi_339_ = false;
                    }
                    let _e119 = phi_339_;
                    if (_e44 == 4294967295u) {
                        phi_349_ = true;
                    } else {
                        phi_349_ = (_e75.member_3 > _e44);
                    }
                    let _e124 = phi_349_;
                    if _e124 {
                        phi_379_ = ((((((_e88.member[0] <= _e47.member_2[0]) && (_e47.member[0] <= _e88.member_2[0])) && (_e88.member[1] <= _e47.member_2[1])) && (_e47.member[1] <= _e88.member_2[1])) && (_e88.member[2] <= _e47.member_2[2])) && (_e47.member[2] <= _e88.member_2[2]));
                    } else {
                        phi_379_ = false;
                    }
                    let _e151 = phi_379_;
                    if _e119 {
                        if (_e85.member_3 == 4294967295u) {
                            phi_389_ = _e85.member_1;
                            phi_390_ = false;
                        } else {
                            phi_389_ = u32();
                            phi_390_ = true;
                        }
                        let _e156 = phi_389_;
                        let _e158 = phi_390_;
                        phi_391_ = _e156;
                        phi_392_ = _e158;
                    } else {
                        phi_391_ = u32();
                        phi_392_ = true;
                    }
                    let _e160 = phi_391_;
                    let _e162 = phi_392_;
                    if _e162 {
                        phi_396_ = 4294967295u;
                    } else {
                        phi_396_ = _e160;
                    }
                    let _e164 = phi_396_;
                    if _e151 {
                        if (_e88.member_3 == 4294967295u) {
                            phi_406_ = _e88.member_1;
                            phi_407_ = false;
                        } else {
                            phi_406_ = u32();
                            phi_407_ = true;
                        }
                        let _e169 = phi_406_;
                        let _e171 = phi_407_;
                        phi_408_ = _e169;
                        phi_409_ = _e171;
                    } else {
                        phi_408_ = u32();
                        phi_409_ = true;
                    }
                    let _e173 = phi_408_;
                    let _e175 = phi_409_;
                    if _e175 {
                        phi_413_ = 4294967295u;
                    } else {
                        phi_413_ = _e173;
                    }
                    let _e177 = phi_413_;
                    if _e119 {
                        phi_420_ = !((_e85.member_3 == 4294967295u));
                    } else {
                        phi_420_ = false;
                    }
                    let _e182 = phi_420_;
                    if _e151 {
                        phi_427_ = !((_e88.member_3 == 4294967295u));
                    } else {
                        phi_427_ = false;
                    }
                    let _e187 = phi_427_;
                    if _e182 {
                        local.member_2 = _e75.member;
                        if _e187 {
                            let _e208 = local.member_1;
                            local.member[_e208] = _e75.member_1;
                            let _e213 = local.member_1;
                            local.member_1 = (_e213 + 1u);
                        }
                    } else {
                        if _e187 {
                            local.member_2 = _e75.member_1;
                        } else {
                            let _e189 = local.member_1;
                            if (_e189 > 0u) {
                                let _e194 = local.member_1;
                                local.member_1 = (_e194 - 1u);
                                let _e197 = local.member_1;
                                let _e200 = local.member[_e197];
                                local.member_2 = _e200;
                            } else {
                                local.member_3 = false;
                            }
                        }
                    }
                    if (_e164 != 4294967295u) {
                        let _e217 = params.member.member_16;
                        if (_e47.member_1 < _e164) {
                            phi_488_ = type_13(_e47.member_1, _e164);
                        } else {
                            phi_488_ = type_13(_e164, _e47.member_1);
                        }
                        let _e223 = phi_488_;
                        let _e227 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e227 + 1u) < _e227) {
                            let _e231 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e227 < _e217) {
                            atomicStore((&out.member[(4u + (2u * _e227))]), _e223.member);
                            atomicStore((&out.member[((2u * _e227) + 5u)]), _e223.member_1);
                        }
                    }
                    if (_e177 != 4294967295u) {
                        let _e241 = params.member.member_16;
                        if (_e47.member_1 < _e177) {
                            phi_529_ = type_13(_e47.member_1, _e177);
                        } else {
                            phi_529_ = type_13(_e177, _e47.member_1);
                        }
                        let _e247 = phi_529_;
                        let _e251 = atomicAdd((&out.member[0u]), 1u);
                        if ((_e251 + 1u) < _e251) {
                            let _e255 = atomicAdd((&out.member[2u]), 1u);
                        }
                        if (_e251 < _e241) {
                            atomicStore((&out.member[(4u + (2u * _e251))]), _e247.member);
                            atomicStore((&out.member[((2u * _e251) + 5u)]), _e247.member_1);
                        }
                    }
                }
                phi_557_ = _e71;
            } else {
                phi_557_ = false;
            }
            let _e264 = phi_557_;
            continue;
            continuing {
                phi_222_ = _e64;
                break if !(_e264);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
