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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
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
    member: u32,
    member_1: u32,
    member_2: bool,
}

struct type_24 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage> points: type_11;
@group(0) @binding(3) 
var<storage, read_write> pairs: type_24;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_112_: u32;
    var phi_130_: array<u32, 2>;
    var phi_165_: type_9;
    var phi_168_: type_21;
    var phi_166_: type_9;
    var phi_191_: type_9;
    var phi_225_: u32;
    var phi_241_: bool;
    var phi_284_: array<u32, 2>;
    var phi_293_: type_9;
    var phi_335_: type_21;
    var phi_169_: type_21;
    var phi_336_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e35 = ((((_e22.y * _e23.x) + _e22.x) * 128u) + _e24);
    let _e38 = params.member.member_1.member;
    if (_e35 < _e38) {
        let _e42 = params.member.member_1.member_1;
        let _e43 = (_e42 + _e35);
        let _e49 = params.member.member.member[0u];
        let _e51 = params.member.member.member[2u];
        if (_e43 < (2u * (_e49 + _e51))) {
            phi_112_ = 0u;
        } else {
            phi_112_ = 1u;
        }
        let _e56 = phi_112_;
        let _e60 = params.member.member.member[0u];
        let _e62 = params.member.member.member[2u];
        let _e64 = (2u * (_e60 + _e62));
        if (_e56 == 1u) {
            let _e68 = params.member.member.member[1u];
            phi_130_ = array<u32, 2>(_e64, (_e64 + (2u * _e68)));
        } else {
            phi_130_ = array<u32, 2>(0u, _e64);
        }
        let _e73 = phi_130_;
        let _e76 = points.member[_e43];
        let _e81 = (_e76 >> bitcast<u32>(1i));
        let _e83 = boxes.member[_e81];
        phi_165_ = type_9((_e43 + 1u), _e73[1]);
        phi_168_ = type_21(_e76, _e43, ((_e76 & 1u) == 0u));
        loop {
            let _e99 = phi_165_;
            let _e101 = phi_168_;
            if (_e99.member < _e99.member_1) {
                phi_166_ = type_9((_e99.member + 1u), _e99.member_1);
                phi_191_ = type_9(1u, _e99.member);
            } else {
                phi_166_ = _e99;
                phi_191_ = type_9(0u, type_9().member_1);
            }
            let _e113 = phi_166_;
            let _e115 = phi_191_;
            if (bitcast<i32>(_e115.member) != 0i) {
                if _e101.member_2 {
                    let _e121 = (_e101.member_1 + 1u);
                    let _e124 = type_21(_e101.member, _e121, _e101.member_2);
                    let _e126 = points.member[_e121];
                    if ((_e126 & 1u) == 0u) {
                        phi_225_ = (_e126 >> bitcast<u32>(1i));
                    } else {
                        phi_225_ = 4294967295u;
                    }
                    let _e138 = phi_225_;
                    if (_e138 != 4294967295u) {
                        if (_e56 == 1u) {
                            phi_241_ = true;
                        } else {
                            let _e142 = params.member.member.member_2[1u];
                            let _e145 = params.member.member.member_2[1u];
                            phi_241_ = ((_e81 < _e142) != (_e138 < _e145));
                        }
                        let _e149 = phi_241_;
                        if _e149 {
                            let _e151 = boxes.member[_e138];
                            if ((((((_e83.member.x <= _e151.member_1.y) && (_e151.member.x <= _e83.member_1.y)) && (_e83.member.y <= _e151.member_2.x)) && (_e151.member.y <= _e83.member_2.x)) && (_e83.member_1.x <= _e151.member_2.y)) && (_e151.member_1.x <= _e83.member_2.y)) {
                                let _e177 = params.member.member_1.member_3;
                                if (_e56 == 0u) {
                                    phi_284_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_284_ = array<u32, 2>(1u, 1u);
                                }
                                let _e180 = phi_284_;
                                if (_e81 < _e138) {
                                    phi_293_ = type_9(_e81, _e138);
                                } else {
                                    phi_293_ = type_9(_e138, _e81);
                                }
                                let _e187 = phi_293_;
                                let _e191 = params.member.member.member_2[_e180[0]];
                                let _e194 = params.member.member.member_2[_e180[1]];
                                let _e197 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e197 + 1u) < _e197) {
                                    let _e201 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e197 < _e177) {
                                    let _e203 = (2u * _e197);
                                    atomicStore((&pairs.member[(4u + _e203)]), (_e187.member - _e191));
                                    atomicStore((&pairs.member[(_e203 + 5u)]), (_e187.member_1 - _e194));
                                }
                            }
                        }
                    }
                    phi_335_ = type_21(_e124.member, _e124.member_1, (_e126 != (_e101.member | 1u)));
                } else {
                    phi_335_ = type_21();
                }
                let _e209 = phi_335_;
                phi_169_ = _e209;
                phi_336_ = _e101.member_2;
            } else {
                phi_169_ = type_21();
                phi_336_ = false;
            }
            let _e211 = phi_169_;
            let _e213 = phi_336_;
            continue;
            continuing {
                phi_165_ = _e113;
                phi_168_ = _e211;
                break if !(_e213);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sweep_end_points(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
