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
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: f32,
    member_1: f32,
}

struct type_19 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
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

struct type_24 {
    member: array<vec4<u32>>,
}

struct type_26 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<vec4<f32>>,
}

struct type_35 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: array<type_35>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> boxes: type_28;
@group(0) @binding(2) 
var<storage> leaves: type_24;
@group(0) @binding(4) 
var<storage> bodies: type_11;
var<workgroup> shared_: array<type_30, 256>;
@group(0) @binding(3) 
var<storage> paths: type_37;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_28;
@group(0) @binding(6) 
var<storage, read_write> ends: type_33;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: f32) -> type_17 {
    return type_17(param_2, param_2);
}

fn function_2(param_3: f32) -> type_17 {
    return type_17(param_3, param_3);
}

fn function_3(param_4: f32, param_5: f32) -> f32 {
    return select(param_4, param_5, select((param_5 <= param_4), true, (param_4 != param_4)));
}

fn function_4(param_6: array<f32, 4>, param_7: array<f32, 4>, param_8: array<f32, 4>) -> type_30 {
    let _e9 = function_3(param_6[0], param_7[0]);
    let _e10 = function_3(param_6[1], param_7[1]);
    let _e11 = function_3(param_6[2], param_7[2]);
    let _e12 = function_(param_6[0], param_7[0]);
    let _e13 = function_(param_6[1], param_7[1]);
    let _e14 = function_(param_6[2], param_7[2]);
    let _e18 = function_3(_e9, param_8[0]);
    let _e19 = function_3(_e10, param_8[1]);
    let _e20 = function_3(_e11, param_8[2]);
    let _e22 = function_(_e9, param_8[0]);
    let _e23 = function_(_e10, param_8[1]);
    let _e24 = function_(_e11, param_8[2]);
    let _e28 = function_3(_e12, param_8[0]);
    let _e29 = function_3(_e13, param_8[1]);
    let _e30 = function_3(_e14, param_8[2]);
    let _e31 = function_(_e12, param_8[0]);
    let _e32 = function_(_e13, param_8[1]);
    let _e33 = function_(_e14, param_8[2]);
    return type_30(array<f32, 3>(_e18, _e19, _e20), array<f32, 3>(_e31, _e32, _e33));
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var phi_188_: u32;
    var phi_207_: u32;
    var phi_208_: array<u32, 3>;
    var phi_229_: bool;
    var phi_362_: type_9;
    var phi_522_: type_9;
    var phi_671_: type_30;
    var phi_796_: type_30;
    var phi_797_: type_30;
    var phi_798_: type_30;
    var phi_874_: type_30;
    var phi_875_: type_30;
    var phi_876_: type_30;
    var phi_891_: type_15;
    var phi_894_: type_30;
    var phi_896_: u32;
    var phi_892_: type_15;
    var phi_937_: type_16;
    var phi_1089_: type_30;
    var phi_1090_: type_30;
    var phi_1136_: type_30;
    var phi_1149_: type_30;
    var phi_895_: type_30;
    var phi_897_: u32;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_30;
    var local_6: type_30;
    var local_7: type_30;
    var local_8: type_30;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e61 = ((((_e45.y * _e46.x) + _e45.x) * 256u) + _e47);
    let _e66 = params.member.member_2.member[0u][3u];
    let _e67 = (_e61 < _e66);
    let _e72 = params.member.member_2.member[0u][2u];
    if (_e61 >= _e72) {
        phi_188_ = 2u;
    } else {
        let _e75 = params.member.member_2.member[0u][1u];
        phi_188_ = select(0u, 1u, (_e61 >= _e75));
    }
    let _e79 = phi_188_;
    if _e67 {
        let _e81 = leaves.member[_e61];
        phi_207_ = _e81.w;
        phi_208_ = array<u32, 3>(_e81.x, _e81.y, _e81.z);
    } else {
        phi_207_ = 4294967295u;
        phi_208_ = array<u32, 3>(0u, 0u, 0u);
    }
    let _e88 = phi_207_;
    let _e90 = phi_208_;
    if (_e88 != 4294967295u) {
        let _e94 = params.member.member.member_1;
        let _e96 = ((_e94 & 4096u) != 0u);
        if _e96 {
            phi_229_ = true;
        } else {
            let _e99 = params.member.member.member_1;
            phi_229_ = ((_e99 & 512u) != 0u);
        }
        let _e103 = phi_229_;
        if _e103 {
            let _e106 = paths.member[_e90[0]];
            let _e127 = paths.member[_e90[1]];
            let _e148 = paths.member[_e90[2]];
            let _e167 = function_4(array<f32, 4>(_e106.member.x, _e106.member.y, _e106.member.z, _e106.member.w), array<f32, 4>(_e127.member.x, _e127.member.y, _e127.member.z, _e127.member.w), array<f32, 4>(_e148.member.x, _e148.member.y, _e148.member.z, _e148.member.w));
            let _e168 = function_4(array<f32, 4>(_e106.member_1.x, _e106.member_1.y, _e106.member_1.z, _e106.member_1.w), array<f32, 4>(_e127.member_1.x, _e127.member_1.y, _e127.member_1.z, _e127.member_1.w), array<f32, 4>(_e148.member_1.x, _e148.member_1.y, _e148.member_1.z, _e148.member_1.w));
            let _e171 = params.member.member.member_3;
            let _e177 = select(_e168.member[0], _e167.member[0], (_e167.member[0] < _e168.member[0]));
            let _e183 = select(_e168.member[1], _e167.member[1], (_e167.member[1] < _e168.member[1]));
            let _e189 = select(_e168.member[2], _e167.member[2], (_e167.member[2] < _e168.member[2]));
            let _e195 = select(_e168.member_1[0], _e167.member_1[0], (_e167.member_1[0] > _e168.member_1[0]));
            let _e201 = select(_e168.member_1[1], _e167.member_1[1], (_e167.member_1[1] > _e168.member_1[1]));
            let _e207 = select(_e168.member_1[2], _e167.member_1[2], (_e167.member_1[2] > _e168.member_1[2]));
            if (_e171 > 0f) {
                local_1 = type_30(array<f32, 3>(_e177, _e183, _e189), array<f32, 3>(_e195, _e201, _e207));
                phi_362_ = type_9(0u, 3u);
                loop {
                    let _e216 = phi_362_;
                    let _e219 = (_e216.member < _e216.member_1);
                    let _e230 = select(type_9().member_1, _e216.member, _e219);
                    let _e232 = (bitcast<i32>(select(0u, 1u, _e219)) != 0i);
                    if _e232 {
                        let _e235 = local_1.member[_e230];
                        let _e237 = -((_e235 - _e171));
                        let _e238 = bitcast<u32>(_e237);
                        local_1.member[_e230] = -(select(_e237, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e238 - 1u)), (_e237 < 0f)), bitcast<f32>((_e238 + 1u)), (_e237 > 0f)), select(true, (_e237 < 0f), ((_e238 & 2139095040u) == 2139095040u))));
                        let _e257 = local_1.member_1[_e230];
                        let _e258 = (_e257 + _e171);
                        let _e259 = bitcast<u32>(_e258);
                        local_1.member_1[_e230] = select(_e258, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e259 - 1u)), (_e258 < 0f)), bitcast<f32>((_e259 + 1u)), (_e258 > 0f)), select(true, (_e258 < 0f), ((_e259 & 2139095040u) == 2139095040u)));
                    }
                    continue;
                    continuing {
                        phi_362_ = type_9(select(_e216.member, (_e216.member + 1u), _e219), select(_e216.member_1, _e216.member_1, _e219));
                        break if !(_e232);
                    }
                }
            } else {
                local_1 = type_30(array<f32, 3>(_e177, _e183, _e189), array<f32, 3>(_e195, _e201, _e207));
            }
            let _e276 = local_1;
            local_2 = _e276;
            local = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_522_ = type_9(0u, 3u);
            loop {
                let _e278 = phi_522_;
                let _e281 = (_e278.member < _e278.member_1);
                let _e292 = select(type_9().member_1, _e278.member, _e281);
                let _e294 = (bitcast<i32>(select(0u, 1u, _e281)) != 0i);
                if _e294 {
                    let _e297 = local_2.member[_e292];
                    let _e298 = function_2(_e297);
                    let _e300 = -(290000000000000000000000000000000000000f);
                    let _e302 = select(_e300, _e298.member, (_e298.member > _e300));
                    local.member[_e292] = select(290000000000000000000000000000000000000f, _e302, (_e302 < 290000000000000000000000000000000000000f));
                    let _e309 = local_2.member_1[_e292];
                    let _e310 = function_1(_e309);
                    let _e312 = -(290000000000000000000000000000000000000f);
                    let _e314 = select(_e312, _e310.member_1, (_e310.member_1 > _e312));
                    local.member_1[_e292] = select(290000000000000000000000000000000000000f, _e314, (_e314 < 290000000000000000000000000000000000000f));
                }
                continue;
                continuing {
                    phi_522_ = type_9(select(_e278.member, (_e278.member + 1u), _e281), select(_e278.member_1, _e278.member_1, _e281));
                    break if !(_e294);
                }
            }
            let _e320 = local;
            let _e334 = params.member.member.member_1;
            if ((_e334 & 512u) != 0u) {
                ends.member[((3u * _e61) - (2u * (_e61 % 32u)))] = vec4<f32>(_e167.member[0], _e167.member[1], _e167.member[2], _e167.member_1[0]);
                ends.member[(((3u * _e61) - (2u * (_e61 % 32u))) + 32u)] = vec4<f32>(_e167.member_1[1], _e167.member_1[2], _e168.member[0], _e168.member[1]);
                ends.member[(((3u * _e61) - (2u * (_e61 % 32u))) + 64u)] = vec4<f32>(_e168.member[2], _e168.member_1[0], _e168.member_1[1], _e168.member_1[2]);
            }
            phi_671_ = type_30(array<f32, 3>(_e320.member[0], _e320.member[1], _e320.member[2]), array<f32, 3>(_e320.member_1[0], _e320.member_1[1], _e320.member_1[2]));
        } else {
            phi_671_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e374 = phi_671_;
        if _e96 {
            phi_797_ = _e374;
        } else {
            let _e379 = boxes.member[_e90[0]];
            if (_e79 > 0u) {
                let _e397 = boxes.member[_e90[1]];
                let _e411 = select(_e397.member.x, _e379.member.x, (_e379.member.x < _e397.member.x));
                let _e413 = select(_e397.member.y, _e379.member.y, (_e379.member.y < _e397.member.y));
                let _e415 = select(_e397.member_1.x, _e379.member_1.x, (_e379.member_1.x < _e397.member_1.x));
                let _e417 = select(_e397.member_1.y, _e379.member_1.y, (_e379.member_1.y > _e397.member_1.y));
                let _e419 = select(_e397.member_2.x, _e379.member_2.x, (_e379.member_2.x > _e397.member_2.x));
                let _e421 = select(_e397.member_2.y, _e379.member_2.y, (_e379.member_2.y > _e397.member_2.y));
                let _e423 = boxes.member[_e90[2]];
                phi_796_ = type_30(array<f32, 3>(select(_e423.member.x, _e411, (_e411 < _e423.member.x)), select(_e423.member.y, _e413, (_e413 < _e423.member.y)), select(_e423.member_1.x, _e415, (_e415 < _e423.member_1.x))), array<f32, 3>(select(_e423.member_1.y, _e417, (_e417 > _e423.member_1.y)), select(_e423.member_2.x, _e419, (_e419 > _e423.member_2.x)), select(_e423.member_2.y, _e421, (_e421 > _e423.member_2.y))));
            } else {
                phi_796_ = type_30(array<f32, 3>(_e379.member.x, _e379.member.y, _e379.member_1.x), array<f32, 3>(_e379.member_1.y, _e379.member_2.x, _e379.member_2.y));
            }
            let _e452 = phi_796_;
            phi_797_ = _e452;
        }
        let _e454 = phi_797_;
        phi_798_ = _e454;
    } else {
        phi_798_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e456 = phi_798_;
    let _e459 = params.member.member.member_1;
    let _e461 = ((_e459 & 256u) != 0u);
    if _e461 {
        let _e464 = bodies.member[_e90[0]];
        if (_e456.member[0] <= _e456.member_1[0]) {
            if (((bitcast<u32>(_e456.member_1[0]) & 1u) == 1u) != ((_e464 & 1u) == 1u)) {
                let _e480 = bitcast<u32>(_e456.member_1[0]);
                let _e483 = ((_e480 >> bitcast<u32>(31i)) == 1u);
                let _e484 = (_e480 & 2147483647u);
                let _e485 = (_e484 < 8388608u);
                let _e488 = select(true, select(true, false, (_e484 == 8388608u)), _e483);
                phi_874_ = type_30(_e456.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e480 + 1u), (_e480 - 1u), _e483), _e488), u32(), _e485), (8388608u | ((_e480 & 1u) ^ 1u)), select(select(true, false, _e488), true, _e485))), _e456.member_1[1], _e456.member_1[2]));
            } else {
                phi_874_ = _e456;
            }
            let _e508 = phi_874_;
            phi_875_ = _e508;
        } else {
            phi_875_ = _e456;
        }
        let _e510 = phi_875_;
        phi_876_ = _e510;
    } else {
        phi_876_ = _e456;
    }
    let _e512 = phi_876_;
    shared_[_e47] = type_30(array<f32, 3>(_e512.member[0], _e512.member[1], _e512.member[2]), array<f32, 3>(_e512.member_1[0], _e512.member_1[1], _e512.member_1[2]));
    phi_891_ = type_15(0i, 5i);
    phi_894_ = _e512;
    phi_896_ = 16u;
    loop {
        let _e526 = phi_891_;
        let _e528 = phi_894_;
        let _e530 = phi_896_;
        local_3 = _e528;
        local_4 = _e528;
        local_5 = _e528;
        local_6 = _e528;
        local_7 = _e528;
        local_8 = _e528;
        if (_e526.member < _e526.member_1) {
            let _e537 = (_e526.member + 1i);
            phi_892_ = type_15(select(_e537, type_16().member_1, select(false, true, ((false == (_e537 > _e526.member)) != false))), _e526.member_1);
            phi_937_ = type_16(1u, _e526.member);
        } else {
            phi_892_ = _e526;
            phi_937_ = type_16(0u, type_16().member_1);
        }
        let _e548 = phi_892_;
        let _e550 = phi_937_;
        let _e553 = (bitcast<i32>(_e550.member) != 0i);
        if _e553 {
            workgroupBarrier();
            if ((_e47 % 32u) < _e530) {
                let _e558 = shared_[(_e47 + _e530)];
                if _e461 {
                    let _e597 = select(_e558.member[0], _e528.member[0], (_e528.member[0] < _e558.member[0]));
                    let _e610 = select(_e558.member_1[0], _e528.member_1[0], (_e528.member_1[0] > _e558.member_1[0]));
                    let _e620 = type_30(array<f32, 3>(_e597, select(_e558.member[1], _e528.member[1], (_e528.member[1] < _e558.member[1])), select(_e558.member[2], _e528.member[2], (_e528.member[2] < _e558.member[2]))), array<f32, 3>(_e610, select(_e558.member_1[1], _e528.member_1[1], (_e528.member_1[1] > _e558.member_1[1])), select(_e558.member_1[2], _e528.member_1[2], (_e528.member_1[2] > _e558.member_1[2]))));
                    if (_e597 <= _e610) {
                        if (((bitcast<u32>(_e610) & 1u) == 1u) != select(false, select(!((_e558.member[0] <= _e558.member_1[0])), true, ((bitcast<u32>(_e558.member_1[0]) & 1u) == 1u)), select(!((_e528.member[0] <= _e528.member_1[0])), true, ((bitcast<u32>(_e528.member_1[0]) & 1u) == 1u)))) {
                            let _e645 = bitcast<u32>(_e610);
                            let _e648 = ((_e645 >> bitcast<u32>(31i)) == 1u);
                            let _e649 = (_e645 & 2147483647u);
                            let _e650 = (_e649 < 8388608u);
                            let _e653 = select(true, select(true, false, (_e649 == 8388608u)), _e648);
                            phi_1089_ = type_30(_e620.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e645 + 1u), (_e645 - 1u), _e648), _e653), u32(), _e650), (8388608u | ((_e645 & 1u) ^ 1u)), select(select(true, false, _e653), true, _e650))), _e620.member_1[1], _e620.member_1[2]));
                        } else {
                            phi_1089_ = _e620;
                        }
                        let _e673 = phi_1089_;
                        phi_1090_ = _e673;
                    } else {
                        phi_1090_ = _e620;
                    }
                    let _e675 = phi_1090_;
                    phi_1136_ = _e675;
                } else {
                    phi_1136_ = type_30(array<f32, 3>(select(_e558.member[0], _e528.member[0], (_e528.member[0] < _e558.member[0])), select(_e558.member[1], _e528.member[1], (_e528.member[1] < _e558.member[1])), select(_e558.member[2], _e528.member[2], (_e528.member[2] < _e558.member[2]))), array<f32, 3>(select(_e558.member_1[0], _e528.member_1[0], (_e528.member_1[0] > _e558.member_1[0])), select(_e558.member_1[1], _e528.member_1[1], (_e528.member_1[1] > _e558.member_1[1])), select(_e558.member_1[2], _e528.member_1[2], (_e528.member_1[2] > _e558.member_1[2]))));
                }
                let _e677 = phi_1136_;
                shared_[_e47] = type_30(array<f32, 3>(_e677.member[0], _e677.member[1], _e677.member[2]), array<f32, 3>(_e677.member_1[0], _e677.member_1[1], _e677.member_1[2]));
                phi_1149_ = _e677;
            } else {
                phi_1149_ = _e528;
            }
            let _e691 = phi_1149_;
            phi_895_ = _e691;
            phi_897_ = (_e530 / 2u);
        } else {
            phi_895_ = type_30();
            phi_897_ = u32();
        }
        let _e694 = phi_895_;
        let _e696 = phi_897_;
        continue;
        continuing {
            phi_891_ = _e548;
            phi_894_ = _e694;
            phi_896_ = _e696;
            break if !(_e553);
        }
    }
    if _e67 {
        nodes.member[_e61] = type_26(vec2<f32>(_e456.member[0], _e456.member[1]), vec2<f32>(_e456.member[2], _e456.member_1[0]), vec2<f32>(_e456.member_1[1], _e456.member_1[2]));
        if ((_e47 % 32u) == 0u) {
            let _e721 = params.member.member_2.member[0u][_e79];
            let _e728 = params.member.member_2.member[1u][_e79];
            let _e731 = local_3;
            let _e735 = local_4;
            let _e739 = local_5;
            let _e743 = local_6;
            let _e747 = local_7;
            let _e751 = local_8;
            nodes.member[(_e728 + ((_e61 - _e721) / 32u))] = type_26(vec2<f32>(_e731.member[0], _e735.member[1]), vec2<f32>(_e739.member[2], _e743.member_1[0]), vec2<f32>(_e747.member_1[1], _e751.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
