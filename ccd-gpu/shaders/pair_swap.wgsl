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
var<workgroup> least: array<atomic<u32>, 2>;
@group(0) @binding(1) 
var<storage, read_write> items: type_15;

fn function_(lane_1: u32) {
    var phi_99_: u32;
    var phi_123_: u32;
    var phi_126_: type_8;
    var phi_129_: type_19;
    var phi_127_: type_8;
    var phi_152_: type_8;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_210_: type_19;
    var phi_211_: bool;
    var phi_212_: type_19;
    var phi_213_: bool;
    var phi_218_: type_19;
    var phi_222_: type_19;
    var phi_130_: type_19;
    var local: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e17 = lane_2;
    let _e22 = found.member[0u];
    let _e23 = (_e22 + 1u);
    let _e26 = params.member.member_1.member;
    let _e27 = (_e26 - _e23);
    let _e28 = (_e27 / 256u);
    if ((_e27 % 256u) > 0u) {
        phi_99_ = (_e28 + 1u);
    } else {
        phi_99_ = _e28;
    }
    let _e33 = phi_99_;
    if (_e17 == 0u) {
        atomicStore((&least[0u]), 2137108966u);
        atomicStore((&least[1u]), 4294967295u);
    }
    workgroupBarrier();
    let _e38 = (_e33 / 256u);
    if ((_e33 % 256u) > 0u) {
        phi_123_ = (_e38 + 1u);
    } else {
        phi_123_ = _e38;
    }
    let _e43 = phi_123_;
    phi_126_ = type_8(0u, _e43);
    phi_129_ = type_19(300000000000000000000000000000000000000f, _e23);
    loop {
        let _e46 = phi_126_;
        let _e48 = phi_129_;
        local = _e48;
        local_1 = _e48;
        local_2 = _e48;
        if (_e46.member < _e46.member_1) {
            phi_127_ = type_8((_e46.member + 1u), _e46.member_1);
            phi_152_ = type_8(1u, _e46.member);
        } else {
            phi_127_ = _e46;
            phi_152_ = type_8(0u, type_8().member_1);
        }
        let _e60 = phi_127_;
        let _e62 = phi_152_;
        let _e66 = (bitcast<i32>(_e62.member) != 0i);
        if _e66 {
            let _e68 = ((_e62.member_1 * 256u) + _e17);
            if (_e68 < _e33) {
                let _e70 = (2u * _e68);
                let _e73 = found.member[(1u + _e70)];
                let _e74 = bitcast<f32>(_e73);
                let _e77 = found.member[(_e70 + 2u)];
                if (_e74 < _e48.member) {
                    phi_212_ = type_19();
                    phi_213_ = true;
                } else {
                    if (_e74 == _e48.member) {
                        if (_e77 < _e48.member_1) {
                            phi_204_ = false;
                        } else {
                            phi_204_ = true;
                        }
                        let _e84 = phi_204_;
                        phi_205_ = _e84;
                    } else {
                        phi_205_ = true;
                    }
                    let _e86 = phi_205_;
                    if _e86 {
                        phi_210_ = _e48;
                        phi_211_ = false;
                    } else {
                        phi_210_ = type_19();
                        phi_211_ = true;
                    }
                    let _e88 = phi_210_;
                    let _e90 = phi_211_;
                    phi_212_ = _e88;
                    phi_213_ = _e90;
                }
                let _e92 = phi_212_;
                let _e94 = phi_213_;
                if _e94 {
                    phi_218_ = type_19(_e74, _e77);
                } else {
                    phi_218_ = _e92;
                }
                let _e97 = phi_218_;
                phi_222_ = _e97;
            } else {
                phi_222_ = _e48;
            }
            let _e99 = phi_222_;
            phi_130_ = _e99;
        } else {
            phi_130_ = type_19();
        }
        let _e101 = phi_130_;
        continue;
        continuing {
            phi_126_ = _e60;
            phi_129_ = _e101;
            break if !(_e66);
        }
    }
    let _e104 = local;
    let _e108 = atomicMin((&least[0u]), bitcast<u32>(_e104.member));
    workgroupBarrier();
    let _e110 = local_1;
    let _e114 = atomicLoad((&least[0u]));
    if (bitcast<u32>(_e110.member) == _e114) {
        let _e117 = local_2;
        let _e120 = atomicMin((&least[1u]), _e117.member_1);
    }
    workgroupBarrier();
    if (_e17 == 0u) {
        let _e123 = atomicLoad((&least[1u]));
        let _e125 = items.member[_e23];
        let _e127 = items.member[_e123];
        items.member[_e123] = _e125;
        items.member[_e23] = _e127;
        found.member[0u] = (_e22 + 2u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_swap(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
