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

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
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

@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(3) 
var<storage, read_write> words: type_25;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_91_: type_9;
    var phi_226_: bool;
    var phi_242_: bool;
    var phi_248_: type_9;
    var phi_319_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    local = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_91_ = type_9(0u, 8u);
    loop {
        let _e39 = phi_91_;
        let _e42 = (_e39.member < _e39.member_1);
        let _e53 = select(type_9().member_1, _e39.member, _e42);
        let _e55 = (bitcast<i32>(select(0u, 1u, _e42)) != 0i);
        if _e55 {
            let _e56 = ((((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25) * 8u) + _e53);
            let _e59 = params.member.member_1.member;
            if (_e56 < _e59) {
                let _e62 = worlds.member[_e56];
                let _e64 = boxes.member[_e56];
                let _e79 = local.member[0u];
                let _e84 = local.member[1u];
                let _e89 = local.member[2u];
                let _e94 = local.member_1[0u];
                let _e99 = local.member_1[1u];
                let _e104 = local.member_1[2u];
                local = type_19(array<f32, 3>(select(_e64.member.x, _e79, (_e79 < _e64.member.x)), select(_e64.member.y, _e84, (_e84 < _e64.member.y)), select(_e64.member_1.x, _e89, (_e89 < _e64.member_1.x))), array<f32, 3>(select(_e64.member_1.y, _e94, (_e94 > _e64.member_1.y)), select(_e64.member_2.x, _e99, (_e99 > _e64.member_2.x)), select(_e64.member_2.y, _e104, (_e104 > _e64.member_2.y))));
                if ((_e53 + 1u) == 8u) {
                    phi_226_ = true;
                } else {
                    let _e115 = params.member.member_1.member;
                    phi_226_ = ((_e56 + 1u) == _e115);
                }
                let _e118 = phi_226_;
                if _e118 {
                    phi_242_ = _e118;
                } else {
                    let _e121 = worlds.member[(_e56 + 1u)];
                    phi_242_ = (_e121 != _e62);
                }
                let _e124 = phi_242_;
                if _e124 {
                    phi_248_ = type_9(0u, 6u);
                    loop {
                        let _e126 = phi_248_;
                        let _e129 = (_e126.member < _e126.member_1);
                        let _e140 = select(type_9().member_1, _e126.member, _e129);
                        let _e142 = (bitcast<i32>(select(0u, 1u, _e129)) != 0i);
                        if _e142 {
                            if (_e140 < 3u) {
                                let _e157 = local.member[_e140];
                                let _e158 = bitcast<u32>(_e157);
                                phi_319_ = ~(select((_e158 | 2147483648u), ~(_e158), ((_e158 >> bitcast<u32>(31i)) == 1u)));
                            } else {
                                let _e147 = local.member_1[(_e140 - 3u)];
                                let _e148 = bitcast<u32>(_e147);
                                phi_319_ = select((_e148 | 2147483648u), ~(_e148), ((_e148 >> bitcast<u32>(31i)) == 1u));
                            }
                            let _e167 = phi_319_;
                            let _e171 = atomicMax((&words.member[((6u * _e62) + _e140)]), _e167);
                        }
                        continue;
                        continuing {
                            phi_248_ = type_9(select(_e126.member, (_e126.member + 1u), _e129), select(_e126.member_1, _e126.member_1, _e129));
                            break if !(_e142);
                        }
                    }
                    local = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                }
            }
        }
        continue;
        continuing {
            phi_91_ = type_9(select(_e39.member, (_e39.member + 1u), _e42), select(_e39.member_1, _e39.member_1, _e42));
            break if !(_e55);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
