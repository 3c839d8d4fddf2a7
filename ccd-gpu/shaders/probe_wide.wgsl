// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<array<u32, 4>>,
}

struct type_13 {
    member: array<array<u32, 24>>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

@group(0) @binding(0) 
var<storage> inputs: type_11;
@group(0) @binding(1) 
var<storage, read_write> results: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 24>;
    var local_1: array<array<u32, 2>, 12>;
    var phi_151_: f64;
    var phi_161_: f64;
    var phi_171_: f64;
    var phi_202_: type_16;
    var phi_205_: f64;
    var phi_226_: bool;
    var phi_232_: type_17;
    var phi_203_: type_16;
    var phi_246_: type_17;
    var phi_206_: f64;
    var local_2: f64;
    var phi_195_: f64;
    var phi_259_: f64;
    var phi_275_: bool;
    var phi_292_: f64;
    var phi_293_: f64;
    var phi_294_: f64;
    var phi_311_: bool;
    var phi_328_: f64;
    var phi_329_: f64;
    var phi_330_: f64;
    var phi_354_: bool;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_375_: f32;
    var phi_432_: type_5;
    var phi_433_: type_5;
    var phi_456_: type_5;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e47 = id_2;
    let _e48 = n_2;
    let _e49 = lane_2;
    let _e60 = ((((_e47.y * _e48.x) + _e47.x) * 64u) + _e49);
    if (_e60 < arrayLength((&inputs.member))) {
        let _e63 = inputs.member[_e60];
        let _e70 = bitcast<f64>(((u64(_e63[1]) * 4294967296lu) + u64(_e63[0])));
        let _e77 = bitcast<f64>(((u64(_e63[3]) * 4294967296lu) + u64(_e63[2])));
        let _e79 = bitcast<u64>((_e70 + _e77));
        let _e84 = bitcast<u64>((_e70 - _e77));
        let _e89 = bitcast<u64>((_e70 * _e77));
        let _e94 = bitcast<u64>((_e70 / _e77));
        if (_e70 < 0.0lf) {
            phi_151_ = -(_e70);
        } else {
            phi_151_ = _e70;
        }
        let _e101 = phi_151_;
        let _e102 = bitcast<u64>(_e101);
        if (_e70 < _e77) {
            phi_161_ = _e70;
        } else {
            phi_161_ = _e77;
        }
        let _e108 = phi_161_;
        let _e109 = bitcast<u64>(_e108);
        if (_e70 > _e77) {
            phi_171_ = _e70;
        } else {
            phi_171_ = _e77;
        }
        let _e115 = phi_171_;
        let _e116 = bitcast<u64>(_e115);
        if (_e70 <= 2.2250738585072014e-308lf) {
            if (_e70 > 0.0lf) {
                phi_195_ = (1.464336215552873e-154lf * 2.0lf);
            } else {
                phi_195_ = 0.0lf;
            }
            let _e175 = phi_195_;
            phi_259_ = _e175;
        } else {
            phi_202_ = type_16(0i, 5i);
            phi_205_ = bitcast<f64>(((bitcast<u64>(_e70) / 2lu) + 2303426169912950784lu));
            loop {
                let _e130 = phi_202_;
                let _e132 = phi_205_;
                local_2 = _e132;
                if (_e130.member < _e130.member_1) {
                    let _e139 = (_e130.member + 1i);
                    if ((false == (_e139 > _e130.member)) != false) {
                        phi_226_ = true;
                    } else {
                        phi_226_ = false;
                    }
                    let _e144 = phi_226_;
                    if _e144 {
                        phi_232_ = type_17(0u, type_17().member_1);
                    } else {
                        phi_232_ = type_17(1u, _e139);
                    }
                    let _e149 = phi_232_;
                    phi_203_ = type_16(_e149.member_1, _e130.member_1);
                    phi_246_ = type_17(1u, _e130.member);
                } else {
                    phi_203_ = _e130;
                    phi_246_ = type_17(0u, type_17().member_1);
                }
                let _e155 = phi_203_;
                let _e157 = phi_246_;
                let _e160 = (bitcast<i32>(_e157.member) != 0i);
                if _e160 {
                    phi_206_ = (0.5lf * (_e132 + (_e70 / _e132)));
                } else {
                    phi_206_ = f64();
                }
                let _e165 = phi_206_;
                continue;
                continuing {
                    phi_202_ = _e155;
                    phi_205_ = _e165;
                    break if !(_e160);
                }
            }
            let _e170 = local_2;
            phi_259_ = (_e170 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e177 = phi_259_;
        let _e178 = bitcast<u64>(_e177);
        let _e182 = bitcast<u64>(_e70);
        if ((_e182 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_275_ = (_e70 < 0.0lf);
        } else {
            phi_275_ = true;
        }
        let _e187 = phi_275_;
        if _e187 {
            if (_e70 > 0.0lf) {
                phi_293_ = bitcast<f64>((_e182 + 1lu));
            } else {
                if (_e70 < 0.0lf) {
                    phi_292_ = bitcast<f64>((_e182 - 1lu));
                } else {
                    phi_292_ = 5e-324lf;
                }
                let _e193 = phi_292_;
                phi_293_ = _e193;
            }
            let _e197 = phi_293_;
            phi_294_ = _e197;
        } else {
            phi_294_ = _e70;
        }
        let _e199 = phi_294_;
        let _e200 = bitcast<u64>(_e199);
        let _e204 = -(_e70);
        let _e205 = bitcast<u64>(_e204);
        if ((_e205 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_311_ = (_e204 < 0.0lf);
        } else {
            phi_311_ = true;
        }
        let _e210 = phi_311_;
        if _e210 {
            if (_e204 > 0.0lf) {
                phi_329_ = bitcast<f64>((_e205 + 1lu));
            } else {
                if (_e204 < 0.0lf) {
                    phi_328_ = bitcast<f64>((_e205 - 1lu));
                } else {
                    phi_328_ = 5e-324lf;
                }
                let _e216 = phi_328_;
                phi_329_ = _e216;
            }
            let _e220 = phi_329_;
            phi_330_ = _e220;
        } else {
            phi_330_ = _e204;
        }
        let _e222 = phi_330_;
        let _e224 = bitcast<u64>(-(_e222));
        let _e228 = f32(_e70);
        if (f64(_e228) > _e70) {
            let _e231 = -(_e228);
            let _e232 = bitcast<u32>(_e231);
            if ((_e232 & 2139095040u) == 2139095040u) {
                phi_354_ = (_e231 < 0f);
            } else {
                phi_354_ = true;
            }
            let _e237 = phi_354_;
            if _e237 {
                if (_e231 > 0f) {
                    phi_372_ = bitcast<f32>((_e232 + 1u));
                } else {
                    if (_e231 < 0f) {
                        phi_371_ = bitcast<f32>((_e232 - 1u));
                    } else {
                        phi_371_ = 0.000000000000000000000000000000000000000000001f;
                    }
                    let _e243 = phi_371_;
                    phi_372_ = _e243;
                }
                let _e247 = phi_372_;
                phi_373_ = _e247;
            } else {
                phi_373_ = _e231;
            }
            let _e249 = phi_373_;
            phi_375_ = -(_e249);
        } else {
            phi_375_ = _e228;
        }
        let _e252 = phi_375_;
        local_1[0u] = array<u32, 2>(u32(_e79), u32((_e79 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e84), u32((_e84 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e89), u32((_e89 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e94), u32((_e94 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e102), u32((_e102 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e109), u32((_e109 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e116), u32((_e116 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e70 < _e77)), select(0u, 1u, (_e70 <= _e77)));
        local_1[8u] = array<u32, 2>(u32(_e178), u32((_e178 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e200), u32((_e200 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e224), u32((_e224 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e252), select(0u, 1u, ((bitcast<u64>(_e70) & 9218868437227405312lu) != 9218868437227405312lu)));
        local = array<u32, 24>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_432_ = type_5(0u, 12u);
        loop {
            let _e283 = phi_432_;
            if (_e283.member < _e283.member_1) {
                phi_433_ = type_5((_e283.member + 1u), _e283.member_1);
                phi_456_ = type_5(1u, _e283.member);
            } else {
                phi_433_ = _e283;
                phi_456_ = type_5(0u, type_5().member_1);
            }
            let _e295 = phi_433_;
            let _e297 = phi_456_;
            let _e301 = (bitcast<i32>(_e297.member) != 0i);
            if _e301 {
                let _e304 = local_1[_e297.member_1][0u];
                local[(2u * _e297.member_1)] = _e304;
                let _e309 = local_1[_e297.member_1][1u];
                local[((2u * _e297.member_1) + 1u)] = _e309;
            }
            continue;
            continuing {
                phi_432_ = _e295;
                break if !(_e301);
            }
        }
        let _e314 = local;
        results.member[_e60] = array<u32, 24>(_e314[0], _e314[1], _e314[2], _e314[3], _e314[4], _e314[5], _e314[6], _e314[7], _e314[8], _e314[9], _e314[10], _e314[11], _e314[12], _e314[13], _e314[14], _e314[15], _e314[16], _e314[17], _e314[18], _e314[19], _e314[20], _e314[21], _e314[22], _e314[23]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
