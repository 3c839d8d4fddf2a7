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

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 2>,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_21 {
    member: type_9,
    member_1: type_9,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<u32, 5>,
    member_1: u32,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> tests: type_23;
@group(0) @binding(2) 
var<storage> regions: type_11;
@group(0) @binding(3) 
var<storage> swept: type_17;
@group(0) @binding(4) 
var<storage> boxes: type_17;
@group(0) @binding(5) 
var<storage, read_write> vf: type_28;
@group(0) @binding(6) 
var<storage, read_write> ee: type_28;
@group(0) @binding(7) 
var<storage, read_write> counts: type_28;
var<workgroup> shared_: array<atomic<u32>, 12>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_130_: u32;
    var phi_151_: u32;
    var phi_152_: u32;
    var phi_155_: type_9;
    var phi_156_: type_9;
    var phi_179_: type_9;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_329_: u32;
    var phi_330_: u32;
    var phi_386_: bool;
    var phi_391_: type_25;
    var phi_392_: bool;
    var phi_393_: type_25;
    var phi_394_: bool;
    var phi_398_: type_25;
    var phi_446_: u32;
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
    if ((_e53 % 128u) > 0u) {
        phi_130_ = (_e54 + 1u);
    } else {
        phi_130_ = _e54;
    }
    let _e59 = phi_130_;
    if (_e59 > _e45) {
        let _e61 = (_e59 - _e45);
        if (_e48 == 0u) {
            return;
        }
        let _e63 = (_e61 / _e48);
        if (_e48 == 0u) {
            return;
        }
        if ((_e61 % _e48) > 0u) {
            phi_151_ = (_e63 + 1u);
        } else {
            phi_151_ = _e63;
        }
        let _e69 = phi_151_;
        phi_152_ = _e69;
    } else {
        phi_152_ = 0u;
    }
    let _e71 = phi_152_;
    phi_155_ = type_9(0u, _e71);
    loop {
        let _e74 = phi_155_;
        if (_e74.member < _e74.member_1) {
            phi_156_ = type_9((_e74.member + 1u), _e74.member_1);
            phi_179_ = type_9(1u, _e74.member);
        } else {
            phi_156_ = _e74;
            phi_179_ = type_9(0u, type_9().member_1);
        }
        let _e86 = phi_156_;
        let _e88 = phi_179_;
        let _e92 = (bitcast<i32>(_e88.member) != 0i);
        if _e92 {
            let _e96 = (((_e45 + (_e88.member_1 * _e48)) * 128u) + _e32);
            if (_e32 == 0u) {
                atomicStore((&shared_[5u]), 0u);
                atomicStore((&shared_[6u]), 0u);
            }
            workgroupBarrier();
            let _e102 = params.member.member_1.member;
            if (_e96 < _e102) {
                let _e106 = params.member.member_1.member_1;
                let _e107 = (_e106 + _e96);
                let _e109 = tests.member[_e107];
                let _e122 = params.member.member_2.member;
                if ((_e122 & 2u) != 0u) {
                    let _e126 = regions.member[_e109.member_1.member];
                    let _e128 = regions.member[_e109.member_1.member_1];
                    if (_e126 == _e128) {
                        phi_260_ = (_e126 != 4294967295u);
                    } else {
                        phi_260_ = false;
                    }
                    let _e132 = phi_260_;
                    phi_261_ = _e132;
                } else {
                    phi_261_ = false;
                }
                let _e134 = phi_261_;
                if _e134 {
                    phi_393_ = type_25();
                    phi_394_ = true;
                } else {
                    let _e136 = swept.member[_e109.member_1.member];
                    let _e138 = swept.member[_e109.member_1.member_1];
                    if ((((((_e136.member[0] <= _e138.member_1[0]) && (_e138.member[0] <= _e136.member_1[0])) && (_e136.member[1] <= _e138.member_1[1])) && (_e138.member[1] <= _e136.member_1[1])) && (_e136.member[2] <= _e138.member_1[2])) && (_e138.member[2] <= _e136.member_1[2])) {
                        let _e176 = params.member.member.member_2[2u];
                        let _e179 = params.member.member_2.member_2;
                        if (_e107 >= _e179) {
                            let _e183 = params.member.member.member_2[1u];
                            let _e187 = params.member.member.member_2[1u];
                            phi_329_ = (_e109.member.member + _e183);
                            phi_330_ = (_e187 + _e109.member.member_1);
                        } else {
                            phi_329_ = _e109.member.member;
                            phi_330_ = (_e176 + _e109.member.member_1);
                        }
                        let _e190 = phi_329_;
                        let _e192 = phi_330_;
                        let _e194 = boxes.member[_e190];
                        let _e196 = boxes.member[_e192];
                        let _e235 = params.member.member_2.member_3[0u];
                        if (_e107 >= _e235) {
                            let _e239 = params.member.member_2.member_3[1u];
                            phi_386_ = (_e107 < _e239);
                        } else {
                            phi_386_ = false;
                        }
                        let _e242 = phi_386_;
                        let _e243 = select(0u, 1u, _e242);
                        phi_391_ = type_25(array<u32, 5>(0u, 0u, 0u, (1u - _e243), _e243), select(0u, 1u, ((((((_e194.member[0] <= _e196.member_1[0]) && (_e196.member[0] <= _e194.member_1[0])) && (_e194.member[1] <= _e196.member_1[1])) && (_e196.member[1] <= _e194.member_1[1])) && (_e194.member[2] <= _e196.member_1[2])) && (_e196.member[2] <= _e194.member_1[2]))));
                        phi_392_ = false;
                    } else {
                        phi_391_ = type_25();
                        phi_392_ = true;
                    }
                    let _e248 = phi_391_;
                    let _e250 = phi_392_;
                    phi_393_ = _e248;
                    phi_394_ = _e250;
                }
                let _e252 = phi_393_;
                let _e254 = phi_394_;
                if _e254 {
                    phi_398_ = type_25(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                } else {
                    phi_398_ = _e252;
                }
                let _e256 = phi_398_;
                if (_e256.member[0] == 0u) {
                } else {
                    let _e269 = atomicAdd((&shared_[0u]), _e256.member[0]);
                }
                if (_e256.member[1] == 0u) {
                } else {
                    let _e272 = atomicAdd((&shared_[1u]), _e256.member[1]);
                }
                if (_e256.member[2] == 0u) {
                } else {
                    let _e275 = atomicAdd((&shared_[2u]), _e256.member[2]);
                }
                if (_e256.member[3] == 0u) {
                } else {
                    let _e278 = atomicAdd((&shared_[3u]), _e256.member[3]);
                }
                if (_e256.member[4] == 0u) {
                } else {
                    let _e281 = atomicAdd((&shared_[4u]), _e256.member[4]);
                }
                let _e285 = params.member.member_2.member_2;
                let _e286 = (_e107 < _e285);
                if (_e256.member_1 == 0u) {
                    phi_449_ = 0u;
                } else {
                    if _e286 {
                        phi_446_ = 5u;
                    } else {
                        phi_446_ = 6u;
                    }
                    let _e289 = phi_446_;
                    let _e291 = atomicAdd((&shared_[_e289]), 1u);
                    phi_449_ = _e291;
                }
                let _e293 = phi_449_;
                phi_450_ = _e293;
                phi_451_ = _e256.member_1;
                phi_452_ = _e109.member;
                phi_453_ = _e286;
            } else {
                phi_450_ = 0u;
                phi_451_ = 0u;
                phi_452_ = type_9(0u, 0u);
                phi_453_ = false;
            }
            let _e295 = phi_450_;
            let _e297 = phi_451_;
            let _e299 = phi_452_;
            let _e301 = phi_453_;
            workgroupBarrier();
            if (_e32 == 0u) {
                let _e304 = atomicLoad((&shared_[5u]));
                let _e306 = atomicLoad((&shared_[6u]));
                if (_e304 > 0u) {
                    let _e309 = atomicAdd((&vf.member[0u]), _e304);
                    if ((_e309 + _e304) < _e309) {
                        let _e313 = atomicAdd((&vf.member[2u]), 1u);
                    }
                    atomicStore((&shared_[7u]), _e309);
                }
                if (_e306 > 0u) {
                    let _e317 = atomicAdd((&ee.member[0u]), _e306);
                    if ((_e317 + _e306) < _e317) {
                        let _e321 = atomicAdd((&ee.member[2u]), 1u);
                    }
                    atomicStore((&shared_[8u]), _e317);
                }
            }
            workgroupBarrier();
            if (_e297 == 0u) {
            } else {
                if _e301 {
                    let _e340 = params.member.member_1.member_3;
                    let _e342 = atomicLoad((&shared_[7u]));
                    let _e343 = (_e342 + _e295);
                    if (_e343 < _e340) {
                        let _e347 = (2u * _e343);
                        atomicStore((&vf.member[(4u + _e347)]), _e299.member);
                        atomicStore((&vf.member[(_e347 + 5u)]), _e299.member_1);
                    }
                } else {
                    let _e326 = params.member.member_2.member_1;
                    let _e328 = atomicLoad((&shared_[8u]));
                    let _e329 = (_e328 + _e295);
                    if (_e329 < _e326) {
                        let _e333 = (2u * _e329);
                        atomicStore((&ee.member[(4u + _e333)]), _e299.member);
                        atomicStore((&ee.member[(_e333 + 5u)]), _e299.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_155_ = _e86;
            break if !(_e92);
        }
    }
    workgroupBarrier();
    if (_e32 < 5u) {
        let _e355 = atomicLoad((&shared_[_e32]));
        if (_e355 > 0u) {
            let _e357 = (_e32 * 4u);
            let _e359 = atomicAdd((&counts.member[_e357]), _e355);
            if ((_e359 + _e355) < _e359) {
                let _e364 = atomicAdd((&counts.member[(_e357 + 2u)]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn near_tests(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
