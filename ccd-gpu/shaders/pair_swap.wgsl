// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<vec4<u32>>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_6,
    member_1: type_7,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_19 {
    member: f32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage, read_write> found: type_10;
@group(0) @binding(1) 
var<storage, read_write> items: type_15;
var<workgroup> least: array<atomic<u32>, 3>;

fn function_(lane_1: u32) {
    var phi_109_: u32;
    var phi_126_: u32;
    var phi_129_: type_8;
    var phi_132_: type_19;
    var phi_130_: type_8;
    var phi_155_: type_8;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_213_: type_19;
    var phi_214_: bool;
    var phi_215_: type_19;
    var phi_216_: bool;
    var phi_221_: type_19;
    var phi_225_: type_19;
    var phi_133_: type_19;
    var local: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e17 = lane_2;
    if (_e17 == 0u) {
        atomicStore((&least[0u]), 2137108966u);
        atomicStore((&least[1u]), 4294967295u);
        let _e25 = found.member[0u];
        atomicStore((&least[2u]), (_e25 + 1u));
    }
    workgroupBarrier();
    let _e29 = atomicLoad((&least[2u]));
    let _e32 = params.member.member_1.member;
    let _e33 = (_e32 - _e29);
    let _e34 = (_e33 / 256u);
    if ((_e33 % 256u) > 0u) {
        phi_109_ = (_e34 + 1u);
    } else {
        phi_109_ = _e34;
    }
    let _e39 = phi_109_;
    let _e41 = (_e39 / 256u);
    if ((_e39 % 256u) > 0u) {
        phi_126_ = (_e41 + 1u);
    } else {
        phi_126_ = _e41;
    }
    let _e46 = phi_126_;
    phi_129_ = type_8(0u, _e46);
    phi_132_ = type_19(300000000000000000000000000000000000000f, _e29);
    loop {
        let _e49 = phi_129_;
        let _e51 = phi_132_;
        local = _e51;
        local_1 = _e51;
        local_2 = _e51;
        if (_e49.member < _e49.member_1) {
            phi_130_ = type_8((_e49.member + 1u), _e49.member_1);
            phi_155_ = type_8(1u, _e49.member);
        } else {
            phi_130_ = _e49;
            phi_155_ = type_8(0u, type_8().member_1);
        }
        let _e63 = phi_130_;
        let _e65 = phi_155_;
        let _e69 = (bitcast<i32>(_e65.member) != 0i);
        if _e69 {
            let _e71 = ((_e65.member_1 * 256u) + _e17);
            if (_e71 < _e39) {
                let _e73 = (2u * _e71);
                let _e76 = found.member[(1u + _e73)];
                let _e77 = bitcast<f32>(_e76);
                let _e80 = found.member[(_e73 + 2u)];
                if (_e77 < _e51.member) {
                    phi_215_ = type_19();
                    phi_216_ = true;
                } else {
                    if (_e77 == _e51.member) {
                        if (_e80 < _e51.member_1) {
                            phi_207_ = false;
                        } else {
                            phi_207_ = true;
                        }
                        let _e87 = phi_207_;
                        phi_208_ = _e87;
                    } else {
                        phi_208_ = true;
                    }
                    let _e89 = phi_208_;
                    if _e89 {
                        phi_213_ = _e51;
                        phi_214_ = false;
                    } else {
                        phi_213_ = type_19();
                        phi_214_ = true;
                    }
                    let _e91 = phi_213_;
                    let _e93 = phi_214_;
                    phi_215_ = _e91;
                    phi_216_ = _e93;
                }
                let _e95 = phi_215_;
                let _e97 = phi_216_;
                if _e97 {
                    phi_221_ = type_19(_e77, _e80);
                } else {
                    phi_221_ = _e95;
                }
                let _e100 = phi_221_;
                phi_225_ = _e100;
            } else {
                phi_225_ = _e51;
            }
            let _e102 = phi_225_;
            phi_133_ = _e102;
        } else {
            phi_133_ = type_19();
        }
        let _e104 = phi_133_;
        continue;
        continuing {
            phi_129_ = _e63;
            phi_132_ = _e104;
            break if !(_e69);
        }
    }
    let _e107 = local;
    let _e111 = atomicMin((&least[0u]), bitcast<u32>(_e107.member));
    workgroupBarrier();
    let _e113 = local_1;
    let _e117 = atomicLoad((&least[0u]));
    if (bitcast<u32>(_e113.member) == _e117) {
        let _e120 = local_2;
        let _e123 = atomicMin((&least[1u]), _e120.member_1);
    }
    workgroupBarrier();
    if (_e17 == 0u) {
        let _e126 = atomicLoad((&least[1u]));
        let _e128 = items.member[_e29];
        let _e130 = items.member[_e126];
        items.member[_e126] = _e128;
        items.member[_e29] = _e130;
        found.member[0u] = (_e29 + 1u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_swap(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
