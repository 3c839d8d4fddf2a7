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

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 2>,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: type_9,
    member_1: type_9,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<u32, 5>,
    member_1: u32,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> tests: type_24;
@group(0) @binding(2) 
var<storage> regions: type_11;
@group(0) @binding(3) 
var<storage> swept: type_18;
@group(0) @binding(4) 
var<storage> boxes: type_18;
@group(0) @binding(5) 
var<storage, read_write> vf: type_28;
@group(0) @binding(6) 
var<storage, read_write> ee: type_28;
@group(0) @binding(7) 
var<storage, read_write> counts: type_28;
var<workgroup> shared_: array<atomic<u32>, 12>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_152_: u32;
    var phi_155_: type_9;
    var phi_261_: bool;
    var phi_329_: u32;
    var phi_330_: u32;
    var phi_386_: bool;
    var phi_391_: type_25;
    var phi_392_: bool;
    var phi_393_: type_25;
    var phi_394_: bool;
    var phi_398_: type_25;
    var phi_449_: u32;
    var phi_450_: u32;
    var phi_451_: u32;
    var phi_452_: type_9;
    var phi_453_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e30 = id_2;
    let _e31 = n_2;
    let _e32 = lane_2;
    let _e45 = ((_e30.y * _e31.x) + _e30.x);
    let _e48 = (_e31.x * _e31.y);
    if (_e32 < 5u) {
        atomicStore((&shared_[_e32]), 0u);
    }
    workgroupBarrier();
    let _e53 = params.member.member_1.member;
    let _e54 = (_e53 / 128u);
    let _e58 = select(_e54, (_e54 + 1u), ((_e53 % 128u) > 0u));
    if (_e58 > _e45) {
        let _e60 = (_e58 - _e45);
        if (_e48 == 0u) {
            return;
        }
        let _e62 = (_e60 / _e48);
        if (_e48 == 0u) {
            return;
        }
        phi_152_ = select(_e62, (_e62 + 1u), ((_e60 % _e48) > 0u));
    } else {
        phi_152_ = 0u;
    }
    let _e69 = phi_152_;
    phi_155_ = type_9(0u, _e69);
    loop {
        let _e72 = phi_155_;
        let _e75 = (_e72.member < _e72.member_1);
        let _e88 = (bitcast<i32>(select(0u, 1u, _e75)) != 0i);
        if _e88 {
            let _e92 = (((_e45 + (select(type_9().member_1, _e72.member, _e75) * _e48)) * 128u) + _e32);
            if (_e32 == 0u) {
                atomicStore((&shared_[5u]), 0u);
                atomicStore((&shared_[6u]), 0u);
            }
            workgroupBarrier();
            let _e98 = params.member.member_1.member;
            if (_e92 < _e98) {
                let _e102 = params.member.member_1.member_1;
                let _e103 = (_e102 + _e92);
                let _e105 = tests.member[_e103];
                let _e118 = params.member.member_2.member;
                if ((_e118 & 2u) != 0u) {
                    let _e122 = regions.member[_e105.member_1.member];
                    let _e124 = regions.member[_e105.member_1.member_1];
                    phi_261_ = select(false, (_e122 != 4294967295u), (_e122 == _e124));
                } else {
                    phi_261_ = false;
                }
                let _e129 = phi_261_;
                if _e129 {
                    phi_393_ = type_25();
                    phi_394_ = true;
                } else {
                    let _e131 = swept.member[_e105.member_1.member];
                    let _e133 = swept.member[_e105.member_1.member_1];
                    if ((((((_e131.member[0] <= _e133.member_1[0]) && (_e133.member[0] <= _e131.member_1[0])) && (_e131.member[1] <= _e133.member_1[1])) && (_e133.member[1] <= _e131.member_1[1])) && (_e131.member[2] <= _e133.member_1[2])) && (_e133.member[2] <= _e131.member_1[2])) {
                        let _e171 = params.member.member.member_2[2u];
                        let _e174 = params.member.member_2.member_2;
                        if (_e103 >= _e174) {
                            let _e178 = params.member.member.member_2[1u];
                            let _e182 = params.member.member.member_2[1u];
                            phi_329_ = (_e105.member.member + _e178);
                            phi_330_ = (_e182 + _e105.member.member_1);
                        } else {
                            phi_329_ = _e105.member.member;
                            phi_330_ = (_e171 + _e105.member.member_1);
                        }
                        let _e185 = phi_329_;
                        let _e187 = phi_330_;
                        let _e189 = boxes.member[_e185];
                        let _e191 = boxes.member[_e187];
                        let _e230 = params.member.member_2.member_3[0u];
                        if (_e103 >= _e230) {
                            let _e234 = params.member.member_2.member_3[1u];
                            phi_386_ = (_e103 < _e234);
                        } else {
                            phi_386_ = false;
                        }
                        let _e237 = phi_386_;
                        let _e238 = select(0u, 1u, _e237);
                        phi_391_ = type_25(array<u32, 5>(0u, 0u, 0u, (1u - _e238), _e238), select(0u, 1u, ((((((_e189.member[0] <= _e191.member_1[0]) && (_e191.member[0] <= _e189.member_1[0])) && (_e189.member[1] <= _e191.member_1[1])) && (_e191.member[1] <= _e189.member_1[1])) && (_e189.member[2] <= _e191.member_1[2])) && (_e191.member[2] <= _e189.member_1[2]))));
                        phi_392_ = false;
                    } else {
                        phi_391_ = type_25();
                        phi_392_ = true;
                    }
                    let _e243 = phi_391_;
                    let _e245 = phi_392_;
                    phi_393_ = _e243;
                    phi_394_ = _e245;
                }
                let _e247 = phi_393_;
                let _e249 = phi_394_;
                if _e249 {
                    phi_398_ = type_25(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                } else {
                    phi_398_ = _e247;
                }
                let _e251 = phi_398_;
                if (_e251.member[0] == 0u) {
                } else {
                    let _e264 = atomicAdd((&shared_[0u]), _e251.member[0]);
                }
                if (_e251.member[1] == 0u) {
                } else {
                    let _e267 = atomicAdd((&shared_[1u]), _e251.member[1]);
                }
                if (_e251.member[2] == 0u) {
                } else {
                    let _e270 = atomicAdd((&shared_[2u]), _e251.member[2]);
                }
                if (_e251.member[3] == 0u) {
                } else {
                    let _e273 = atomicAdd((&shared_[3u]), _e251.member[3]);
                }
                if (_e251.member[4] == 0u) {
                } else {
                    let _e276 = atomicAdd((&shared_[4u]), _e251.member[4]);
                }
                let _e280 = params.member.member_2.member_2;
                let _e281 = (_e103 < _e280);
                if (_e251.member_1 == 0u) {
                    phi_449_ = 0u;
                } else {
                    let _e285 = atomicAdd((&shared_[select(6u, 5u, _e281)]), 1u);
                    phi_449_ = _e285;
                }
                let _e287 = phi_449_;
                phi_450_ = _e287;
                phi_451_ = _e251.member_1;
                phi_452_ = _e105.member;
                phi_453_ = _e281;
            } else {
                phi_450_ = 0u;
                phi_451_ = 0u;
                phi_452_ = type_9(0u, 0u);
                phi_453_ = false;
            }
            let _e289 = phi_450_;
            let _e291 = phi_451_;
            let _e293 = phi_452_;
            let _e295 = phi_453_;
            workgroupBarrier();
            if (_e32 == 0u) {
                let _e298 = atomicLoad((&shared_[5u]));
                let _e300 = atomicLoad((&shared_[6u]));
                if (_e298 > 0u) {
                    let _e303 = atomicAdd((&vf.member[0u]), _e298);
                    if ((_e303 + _e298) < _e303) {
                        let _e307 = atomicAdd((&vf.member[2u]), 1u);
                    }
                    atomicStore((&shared_[7u]), _e303);
                }
                if (_e300 > 0u) {
                    let _e311 = atomicAdd((&ee.member[0u]), _e300);
                    if ((_e311 + _e300) < _e311) {
                        let _e315 = atomicAdd((&ee.member[2u]), 1u);
                    }
                    atomicStore((&shared_[8u]), _e311);
                }
            }
            workgroupBarrier();
            if (_e291 == 0u) {
            } else {
                if _e295 {
                    let _e334 = params.member.member_1.member_3;
                    let _e336 = atomicLoad((&shared_[7u]));
                    let _e337 = (_e336 + _e289);
                    if (_e337 < _e334) {
                        let _e341 = (2u * _e337);
                        atomicStore((&vf.member[(4u + _e341)]), _e293.member);
                        atomicStore((&vf.member[(_e341 + 5u)]), _e293.member_1);
                    }
                } else {
                    let _e320 = params.member.member_2.member_1;
                    let _e322 = atomicLoad((&shared_[8u]));
                    let _e323 = (_e322 + _e289);
                    if (_e323 < _e320) {
                        let _e327 = (2u * _e323);
                        atomicStore((&ee.member[(4u + _e327)]), _e293.member);
                        atomicStore((&ee.member[(_e327 + 5u)]), _e293.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_155_ = type_9(select(_e72.member, (_e72.member + 1u), _e75), select(_e72.member_1, _e72.member_1, _e75));
            break if !(_e88);
        }
    }
    workgroupBarrier();
    if (_e32 < 5u) {
        let _e349 = atomicLoad((&shared_[_e32]));
        if (_e349 > 0u) {
            let _e351 = (_e32 * 4u);
            let _e353 = atomicAdd((&counts.member[_e351]), _e349);
            if ((_e353 + _e349) < _e353) {
                let _e358 = atomicAdd((&counts.member[(_e351 + 2u)]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn near_tests(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
