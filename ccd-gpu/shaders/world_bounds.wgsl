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
    var phi_92_: type_9;
    var phi_115_: type_9;
    var phi_163_: f32;
    var phi_170_: f32;
    var phi_177_: f32;
    var phi_186_: f32;
    var phi_194_: f32;
    var phi_202_: f32;
    var phi_226_: bool;
    var phi_242_: bool;
    var phi_248_: type_9;
    var phi_249_: type_9;
    var phi_272_: type_9;
    var phi_318_: u32;
    var phi_299_: u32;
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
        if (_e39.member < _e39.member_1) {
            phi_92_ = type_9((_e39.member + 1u), _e39.member_1);
            phi_115_ = type_9(1u, _e39.member);
        } else {
            phi_92_ = _e39;
            phi_115_ = type_9(0u, type_9().member_1);
        }
        let _e51 = phi_92_;
        let _e53 = phi_115_;
        let _e57 = (bitcast<i32>(_e53.member) != 0i);
        if _e57 {
            let _e58 = ((((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25) * 8u) + _e53.member_1);
            let _e61 = params.member.member_1.member;
            if (_e58 < _e61) {
                let _e64 = worlds.member[_e58];
                let _e66 = boxes.member[_e58];
                let _e81 = local.member[0u];
                if (_e81 < _e66.member.x) {
                    phi_163_ = _e81;
                } else {
                    phi_163_ = _e66.member.x;
                }
                let _e84 = phi_163_;
                let _e87 = local.member[1u];
                if (_e87 < _e66.member.y) {
                    phi_170_ = _e87;
                } else {
                    phi_170_ = _e66.member.y;
                }
                let _e90 = phi_170_;
                let _e93 = local.member[2u];
                if (_e93 < _e66.member_1.x) {
                    phi_177_ = _e93;
                } else {
                    phi_177_ = _e66.member_1.x;
                }
                let _e96 = phi_177_;
                let _e99 = local.member_1[0u];
                if (_e99 > _e66.member_1.y) {
                    phi_186_ = _e99;
                } else {
                    phi_186_ = _e66.member_1.y;
                }
                let _e102 = phi_186_;
                let _e105 = local.member_1[1u];
                if (_e105 > _e66.member_2.x) {
                    phi_194_ = _e105;
                } else {
                    phi_194_ = _e66.member_2.x;
                }
                let _e108 = phi_194_;
                let _e111 = local.member_1[2u];
                if (_e111 > _e66.member_2.y) {
                    phi_202_ = _e111;
                } else {
                    phi_202_ = _e66.member_2.y;
                }
                let _e114 = phi_202_;
                local = type_19(array<f32, 3>(_e84, _e90, _e96), array<f32, 3>(_e102, _e108, _e114));
                if ((_e53.member_1 + 1u) == 8u) {
                    phi_226_ = true;
                } else {
                    let _e123 = params.member.member_1.member;
                    phi_226_ = ((_e58 + 1u) == _e123);
                }
                let _e126 = phi_226_;
                if _e126 {
                    phi_242_ = _e126;
                } else {
                    let _e129 = worlds.member[(_e58 + 1u)];
                    phi_242_ = (_e129 != _e64);
                }
                let _e132 = phi_242_;
                if _e132 {
                    phi_248_ = type_9(0u, 6u);
                    loop {
                        let _e134 = phi_248_;
                        if (_e134.member < _e134.member_1) {
                            phi_249_ = type_9((_e134.member + 1u), _e134.member_1);
                            phi_272_ = type_9(1u, _e134.member);
                        } else {
                            phi_249_ = _e134;
                            phi_272_ = type_9(0u, type_9().member_1);
                        }
                        let _e146 = phi_249_;
                        let _e148 = phi_272_;
                        let _e152 = (bitcast<i32>(_e148.member) != 0i);
                        if _e152 {
                            if (_e148.member_1 < 3u) {
                                let _e168 = local.member[_e148.member_1];
                                let _e169 = bitcast<u32>(_e168);
                                if ((_e169 >> bitcast<u32>(31i)) == 1u) {
                                    phi_299_ = ~(_e169);
                                } else {
                                    phi_299_ = (_e169 | 2147483648u);
                                }
                                let _e176 = phi_299_;
                                phi_319_ = ~(_e176);
                            } else {
                                let _e157 = local.member_1[(_e148.member_1 - 3u)];
                                let _e158 = bitcast<u32>(_e157);
                                if ((_e158 >> bitcast<u32>(31i)) == 1u) {
                                    phi_318_ = ~(_e158);
                                } else {
                                    phi_318_ = (_e158 | 2147483648u);
                                }
                                let _e165 = phi_318_;
                                phi_319_ = _e165;
                            }
                            let _e179 = phi_319_;
                            let _e183 = atomicMax((&words.member[((6u * _e64) + _e148.member_1)]), _e179);
                        }
                        continue;
                        continuing {
                            phi_248_ = _e146;
                            break if !(_e152);
                        }
                    }
                    local = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                }
            }
        }
        continue;
        continuing {
            phi_91_ = _e51;
            break if !(_e57);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
