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

struct type_13 {
    member: array<vec4<u32>>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_6,
    member_1: type_7,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_17 {
    member: f32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage, read_write> items: type_13;
var<workgroup> shared_: array<vec4<u32>, 4>;
var<workgroup> found: array<atomic<u32>, 2>;

fn function_(lane_1: u32) {
    var phi_75_: type_8;
    var phi_76_: type_8;
    var phi_99_: type_8;
    var phi_170_: u32;
    var phi_173_: type_8;
    var phi_176_: type_17;
    var phi_174_: type_8;
    var phi_199_: type_8;
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_253_: type_17;
    var phi_254_: bool;
    var phi_255_: type_17;
    var phi_256_: bool;
    var phi_261_: type_17;
    var phi_177_: type_17;
    var phi_265_: type_17;
    var local: type_17;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e17 = lane_2;
    let _e22 = params.member.member_1.member;
    let _e25 = params.member.member_2.member_2;
    phi_75_ = type_8(0u, _e25);
    loop {
        let _e28 = phi_75_;
        if (_e28.member < _e28.member_1) {
            phi_76_ = type_8((_e28.member + 1u), _e28.member_1);
            phi_99_ = type_8(1u, _e28.member);
        } else {
            phi_76_ = _e28;
            phi_99_ = type_8(0u, type_8().member_1);
        }
        let _e40 = phi_76_;
        let _e42 = phi_99_;
        let _e46 = (bitcast<i32>(_e42.member) != 0i);
        if _e46 {
            let _e49 = params.member.member_1.member_1;
            let _e51 = (_e49 + (2u * _e42.member_1));
            let _e52 = (_e51 + 1u);
            if (_e17 == (_e51 % 256u)) {
                let _e56 = items.member[_e51];
                shared_[0u] = _e56;
            }
            if (_e17 == 0u) {
                atomicStore((&found[0u]), 2137108966u);
                atomicStore((&found[1u]), 4294967295u);
            }
            workgroupBarrier();
            let _e62 = shared_[0u];
            let _e69 = type_17(300000000000000000000000000000000000000f, _e52);
            let _e74 = (_e52 + (((_e17 + 256u) - (_e52 % 256u)) % 256u));
            if (_e74 < _e22) {
                let _e76 = (_e22 - _e74);
                let _e77 = (_e76 / 256u);
                if ((_e76 % 256u) > 0u) {
                    phi_170_ = (_e77 + 1u);
                } else {
                    phi_170_ = _e77;
                }
                let _e82 = phi_170_;
                phi_173_ = type_8(0u, _e82);
                phi_176_ = _e69;
                loop {
                    let _e85 = phi_173_;
                    let _e87 = phi_176_;
                    local = _e87;
                    if (_e85.member < _e85.member_1) {
                        phi_174_ = type_8((_e85.member + 1u), _e85.member_1);
                        phi_199_ = type_8(1u, _e85.member);
                    } else {
                        phi_174_ = _e85;
                        phi_199_ = type_8(0u, type_8().member_1);
                    }
                    let _e99 = phi_174_;
                    let _e101 = phi_199_;
                    let _e105 = (bitcast<i32>(_e101.member) != 0i);
                    if _e105 {
                        let _e107 = (_e74 + (_e101.member_1 * 256u));
                        let _e109 = items.member[_e107];
                        let _e116 = (bitcast<f32>(_e62.x) - bitcast<f32>(_e109.x));
                        let _e117 = (bitcast<f32>(_e62.y) - bitcast<f32>(_e109.y));
                        let _e118 = (bitcast<f32>(_e62.z) - bitcast<f32>(_e109.z));
                        let _e123 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                        if (_e123 < _e87.member) {
                            phi_255_ = type_17();
                            phi_256_ = true;
                        } else {
                            if (_e123 == _e87.member) {
                                if (_e107 < _e87.member_1) {
                                    phi_247_ = false;
                                } else {
                                    phi_247_ = true;
                                }
                                let _e130 = phi_247_;
                                phi_248_ = _e130;
                            } else {
                                phi_248_ = true;
                            }
                            let _e132 = phi_248_;
                            if _e132 {
                                phi_253_ = _e87;
                                phi_254_ = false;
                            } else {
                                phi_253_ = type_17();
                                phi_254_ = true;
                            }
                            let _e134 = phi_253_;
                            let _e136 = phi_254_;
                            phi_255_ = _e134;
                            phi_256_ = _e136;
                        }
                        let _e138 = phi_255_;
                        let _e140 = phi_256_;
                        if _e140 {
                            phi_261_ = type_17(_e123, _e107);
                        } else {
                            phi_261_ = _e138;
                        }
                        let _e143 = phi_261_;
                        phi_177_ = _e143;
                    } else {
                        phi_177_ = type_17();
                    }
                    let _e145 = phi_177_;
                    continue;
                    continuing {
                        phi_173_ = _e99;
                        phi_176_ = _e145;
                        break if !(_e105);
                    }
                }
                let _e199 = local;
                phi_265_ = _e199;
            } else {
                phi_265_ = _e69;
            }
            let _e148 = phi_265_;
            let _e152 = atomicMin((&found[0u]), bitcast<u32>(_e148.member));
            workgroupBarrier();
            let _e156 = atomicLoad((&found[0u]));
            if (bitcast<u32>(_e148.member) == _e156) {
                let _e160 = atomicMin((&found[1u]), _e148.member_1);
            }
            workgroupBarrier();
            let _e162 = atomicLoad((&found[1u]));
            let _e164 = (_e17 == (_e52 % 256u));
            let _e166 = (_e17 == (_e162 % 256u));
            if _e164 {
                let _e168 = items.member[_e52];
                shared_[1u] = _e168;
            }
            if _e166 {
                let _e171 = items.member[_e162];
                shared_[2u] = _e171;
            }
            workgroupBarrier();
            if _e164 {
                let _e174 = shared_[2u];
                items.member[_e52] = _e174;
            }
            if _e166 {
                if (_e162 != _e52) {
                    let _e178 = shared_[1u];
                    items.member[_e162] = _e178;
                }
            }
        }
        continue;
        continuing {
            phi_75_ = _e40;
            break if !(_e46);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_nearest(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
