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
    var phi_130_: array<u32, 2>;
    var phi_165_: type_9;
    var phi_168_: type_21;
    var phi_241_: bool;
    var phi_335_: type_21;
    var phi_169_: type_21;
    var phi_336_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e19 = id_2;
    let _e20 = n_2;
    let _e21 = lane_2;
    let _e32 = ((((_e19.y * _e20.x) + _e19.x) * 128u) + _e21);
    let _e35 = params.member.member_1.member;
    if (_e32 < _e35) {
        let _e39 = params.member.member_1.member_1;
        let _e40 = (_e39 + _e32);
        let _e46 = params.member.member.member[0u];
        let _e48 = params.member.member.member[2u];
        let _e52 = select(1u, 0u, (_e40 < (2u * (_e46 + _e48))));
        let _e56 = params.member.member.member[0u];
        let _e58 = params.member.member.member[2u];
        let _e60 = (2u * (_e56 + _e58));
        if (_e52 == 1u) {
            let _e64 = params.member.member.member[1u];
            phi_130_ = array<u32, 2>(_e60, (_e60 + (2u * _e64)));
        } else {
            phi_130_ = array<u32, 2>(0u, _e60);
        }
        let _e69 = phi_130_;
        let _e72 = points.member[_e40];
        let _e77 = (_e72 >> bitcast<u32>(1i));
        let _e79 = boxes.member[_e77];
        phi_165_ = type_9((_e40 + 1u), _e69[1]);
        phi_168_ = type_21(_e72, _e40, ((_e72 & 1u) == 0u));
        loop {
            let _e95 = phi_165_;
            let _e97 = phi_168_;
            let _e100 = (_e95.member < _e95.member_1);
            if (bitcast<i32>(select(0u, 1u, _e100)) != 0i) {
                if _e97.member_2 {
                    let _e114 = (_e97.member_1 + 1u);
                    let _e117 = type_21(_e97.member, _e114, _e97.member_2);
                    let _e119 = points.member[_e114];
                    let _e130 = select(4294967295u, (_e119 >> bitcast<u32>(1i)), ((_e119 & 1u) == 0u));
                    if (_e130 != 4294967295u) {
                        if (_e52 == 1u) {
                            phi_241_ = true;
                        } else {
                            let _e134 = params.member.member.member_2[1u];
                            let _e137 = params.member.member.member_2[1u];
                            phi_241_ = ((_e77 < _e134) != (_e130 < _e137));
                        }
                        let _e141 = phi_241_;
                        if _e141 {
                            let _e143 = boxes.member[_e130];
                            if ((((((_e79.member.x <= _e143.member_1.y) && (_e143.member.x <= _e79.member_1.y)) && (_e79.member.y <= _e143.member_2.x)) && (_e143.member.y <= _e79.member_2.x)) && (_e79.member_1.x <= _e143.member_2.y)) && (_e143.member_1.x <= _e79.member_2.y)) {
                                let _e169 = params.member.member_1.member_3;
                                let _e170 = (_e52 == 0u);
                                let _e173 = (_e77 < _e130);
                                let _e177 = params.member.member.member_2[select(1u, 0u, _e170)];
                                let _e180 = params.member.member.member_2[select(1u, 2u, _e170)];
                                let _e183 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e183 + 1u) < _e183) {
                                    let _e187 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e183 < _e169) {
                                    let _e189 = (2u * _e183);
                                    atomicStore((&pairs.member[(4u + _e189)]), (select(_e130, _e77, _e173) - _e177));
                                    atomicStore((&pairs.member[(_e189 + 5u)]), (select(_e77, _e130, _e173) - _e180));
                                }
                            }
                        }
                    }
                    phi_335_ = type_21(_e117.member, _e117.member_1, (_e119 != (_e97.member | 1u)));
                } else {
                    phi_335_ = type_21();
                }
                let _e195 = phi_335_;
                phi_169_ = _e195;
                phi_336_ = _e97.member_2;
            } else {
                phi_169_ = type_21();
                phi_336_ = false;
            }
            let _e197 = phi_169_;
            let _e199 = phi_336_;
            continue;
            continuing {
                phi_165_ = type_9(select(_e95.member, (_e95.member + 1u), _e100), select(_e95.member_1, _e95.member_1, _e100));
                phi_168_ = _e197;
                break if !(_e199);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sweep_end_points(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
