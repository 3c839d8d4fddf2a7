// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<array<u32, 4>>,
}

struct type_13 {
    member: array<array<u32, 28>>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: f32,
    member_1: f32,
}

@group(0) @binding(0) 
var<storage> inputs: type_11;
@group(0) @binding(1) 
var<storage, read_write> results: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 28>;
    var local_1: array<array<u32, 2>, 14>;
    var phi_169_: f64;
    var phi_179_: f64;
    var phi_189_: f64;
    var phi_220_: type_16;
    var phi_223_: f64;
    var phi_244_: bool;
    var phi_250_: type_17;
    var phi_221_: type_16;
    var phi_264_: type_17;
    var phi_224_: f64;
    var local_2: f64;
    var phi_213_: f64;
    var phi_277_: f64;
    var phi_293_: bool;
    var phi_310_: f64;
    var phi_311_: f64;
    var phi_312_: f64;
    var phi_329_: bool;
    var phi_346_: f64;
    var phi_347_: f64;
    var phi_348_: f64;
    var phi_401_: bool;
    var phi_402_: u32;
    var phi_403_: bool;
    var phi_404_: u32;
    var phi_405_: bool;
    var phi_406_: u32;
    var phi_407_: bool;
    var phi_408_: u32;
    var phi_421_: type_18;
    var phi_498_: type_4;
    var phi_499_: type_4;
    var phi_522_: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e63 = id_2;
    let _e64 = n_2;
    let _e65 = lane_2;
    let _e76 = ((((_e63.y * _e64.x) + _e63.x) * 64u) + _e65);
    if (_e76 < arrayLength((&inputs.member))) {
        let _e79 = inputs.member[_e76];
        let _e86 = bitcast<f64>(((u64(_e79[1]) * 4294967296lu) + u64(_e79[0])));
        let _e93 = bitcast<f64>(((u64(_e79[3]) * 4294967296lu) + u64(_e79[2])));
        let _e95 = bitcast<u64>((_e86 + _e93));
        let _e100 = bitcast<u64>((_e86 - _e93));
        let _e105 = bitcast<u64>((_e86 * _e93));
        let _e110 = bitcast<u64>((_e86 / _e93));
        if (_e86 < 0.0lf) {
            phi_169_ = -(_e86);
        } else {
            phi_169_ = _e86;
        }
        let _e117 = phi_169_;
        let _e118 = bitcast<u64>(_e117);
        if (_e86 < _e93) {
            phi_179_ = _e86;
        } else {
            phi_179_ = _e93;
        }
        let _e124 = phi_179_;
        let _e125 = bitcast<u64>(_e124);
        if (_e86 > _e93) {
            phi_189_ = _e86;
        } else {
            phi_189_ = _e93;
        }
        let _e131 = phi_189_;
        let _e132 = bitcast<u64>(_e131);
        if (_e86 <= 2.2250738585072014e-308lf) {
            if (_e86 > 0.0lf) {
                phi_213_ = (1.464336215552873e-154lf * 2.0lf);
            } else {
                phi_213_ = 0.0lf;
            }
            let _e191 = phi_213_;
            phi_277_ = _e191;
        } else {
            phi_220_ = type_16(0i, 5i);
            phi_223_ = bitcast<f64>(((bitcast<u64>(_e86) / 2lu) + 2303426169912950784lu));
            loop {
                let _e146 = phi_220_;
                let _e148 = phi_223_;
                local_2 = _e148;
                if (_e146.member < _e146.member_1) {
                    let _e155 = (_e146.member + 1i);
                    if ((false == (_e155 > _e146.member)) != false) {
                        phi_244_ = true;
                    } else {
                        phi_244_ = false;
                    }
                    let _e160 = phi_244_;
                    if _e160 {
                        phi_250_ = type_17(0u, type_17().member_1);
                    } else {
                        phi_250_ = type_17(1u, _e155);
                    }
                    let _e165 = phi_250_;
                    phi_221_ = type_16(_e165.member_1, _e146.member_1);
                    phi_264_ = type_17(1u, _e146.member);
                } else {
                    phi_221_ = _e146;
                    phi_264_ = type_17(0u, type_17().member_1);
                }
                let _e171 = phi_221_;
                let _e173 = phi_264_;
                let _e176 = (bitcast<i32>(_e173.member) != 0i);
                if _e176 {
                    phi_224_ = (0.5lf * (_e148 + (_e86 / _e148)));
                } else {
                    phi_224_ = f64();
                }
                let _e181 = phi_224_;
                continue;
                continuing {
                    phi_220_ = _e171;
                    phi_223_ = _e181;
                    break if !(_e176);
                }
            }
            let _e186 = local_2;
            phi_277_ = (_e186 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e193 = phi_277_;
        let _e194 = bitcast<u64>(_e193);
        let _e198 = bitcast<u64>(_e86);
        if ((_e198 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_293_ = (_e86 < 0.0lf);
        } else {
            phi_293_ = true;
        }
        let _e203 = phi_293_;
        if _e203 {
            if (_e86 > 0.0lf) {
                phi_311_ = bitcast<f64>((_e198 + 1lu));
            } else {
                if (_e86 < 0.0lf) {
                    phi_310_ = bitcast<f64>((_e198 - 1lu));
                } else {
                    phi_310_ = 5e-324lf;
                }
                let _e209 = phi_310_;
                phi_311_ = _e209;
            }
            let _e213 = phi_311_;
            phi_312_ = _e213;
        } else {
            phi_312_ = _e86;
        }
        let _e215 = phi_312_;
        let _e216 = bitcast<u64>(_e215);
        let _e220 = -(_e86);
        let _e221 = bitcast<u64>(_e220);
        if ((_e221 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_329_ = (_e220 < 0.0lf);
        } else {
            phi_329_ = true;
        }
        let _e226 = phi_329_;
        if _e226 {
            if (_e220 > 0.0lf) {
                phi_347_ = bitcast<f64>((_e221 + 1lu));
            } else {
                if (_e220 < 0.0lf) {
                    phi_346_ = bitcast<f64>((_e221 - 1lu));
                } else {
                    phi_346_ = 5e-324lf;
                }
                let _e232 = phi_346_;
                phi_347_ = _e232;
            }
            let _e236 = phi_347_;
            phi_348_ = _e236;
        } else {
            phi_348_ = _e220;
        }
        let _e238 = phi_348_;
        let _e240 = bitcast<u64>(-(_e238));
        let _e244 = bitcast<u64>(_e86);
        let _e245 = u32(_e244);
        let _e247 = u32((_e244 / 4294967296lu));
        let _e248 = (_e247 & 2147483648u);
        let _e251 = ((_e247 >> bitcast<u32>(20i)) & 2047u);
        let _e257 = (((_e247 & 1048575u) << bitcast<u32>(3i)) | (_e245 >> bitcast<u32>(29i)));
        let _e258 = (_e245 & 536870911u);
        if (_e251 == 2047u) {
            phi_407_ = false;
            phi_408_ = (2139095040u | _e257);
        } else {
            if (_e251 > 1150u) {
                phi_405_ = true;
                phi_406_ = 2139095039u;
            } else {
                if (_e251 > 896u) {
                    phi_403_ = (_e258 != 0u);
                    phi_404_ = (((_e251 - 896u) << bitcast<u32>(23i)) | _e257);
                } else {
                    if (_e251 >= 873u) {
                        let _e266 = (8388608u | _e257);
                        let _e267 = (897u - _e251);
                        phi_401_ = (((_e266 & ((1u << bitcast<u32>((_e267 & 31u))) - 1u)) | _e258) != 0u);
                        phi_402_ = (_e266 >> bitcast<u32>((_e267 & 31u)));
                    } else {
                        phi_401_ = (((_e247 & 2147483647u) | _e245) != 0u);
                        phi_402_ = 0u;
                    }
                    let _e279 = phi_401_;
                    let _e281 = phi_402_;
                    phi_403_ = _e279;
                    phi_404_ = _e281;
                }
                let _e288 = phi_403_;
                let _e290 = phi_404_;
                phi_405_ = _e288;
                phi_406_ = _e290;
            }
            let _e292 = phi_405_;
            let _e294 = phi_406_;
            phi_407_ = _e292;
            phi_408_ = _e294;
        }
        let _e297 = phi_407_;
        let _e299 = phi_408_;
        let _e301 = bitcast<f32>((_e248 | _e299));
        let _e305 = bitcast<f32>(((_e248 | _e299) + select(0u, 1u, _e297)));
        if (_e248 == 0u) {
            phi_421_ = type_18(_e301, _e305);
        } else {
            phi_421_ = type_18(_e305, _e301);
        }
        let _e310 = phi_421_;
        let _e320 = bitcast<u64>(f64(bitcast<f32>(_e79[0])));
        local_1[0u] = array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e100), u32((_e100 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e105), u32((_e105 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e110), u32((_e110 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e118), u32((_e118 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e125), u32((_e125 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e132), u32((_e132 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e86 < _e93)), select(0u, 1u, (_e86 <= _e93)));
        local_1[8u] = array<u32, 2>(u32(_e194), u32((_e194 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e216), u32((_e216 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e240), u32((_e240 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e310.member), select(0u, 1u, ((bitcast<u64>(_e86) & 9218868437227405312lu) != 9218868437227405312lu)));
        local_1[12u] = array<u32, 2>(u32(_e320), u32((_e320 / 4294967296lu)));
        local_1[13u] = array<u32, 2>(bitcast<u32>(f32(_e86)), 0u);
        local = array<u32, 28>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_498_ = type_4(0u, 14u);
        loop {
            let _e355 = phi_498_;
            if (_e355.member < _e355.member_1) {
                phi_499_ = type_4((_e355.member + 1u), _e355.member_1);
                phi_522_ = type_4(1u, _e355.member);
            } else {
                phi_499_ = _e355;
                phi_522_ = type_4(0u, type_4().member_1);
            }
            let _e367 = phi_499_;
            let _e369 = phi_522_;
            let _e373 = (bitcast<i32>(_e369.member) != 0i);
            if _e373 {
                let _e376 = local_1[_e369.member_1][0u];
                local[(2u * _e369.member_1)] = _e376;
                let _e381 = local_1[_e369.member_1][1u];
                local[((2u * _e369.member_1) + 1u)] = _e381;
            }
            continue;
            continuing {
                phi_498_ = _e367;
                break if !(_e373);
            }
        }
        let _e386 = local;
        results.member[_e76] = array<u32, 28>(_e386[0], _e386[1], _e386[2], _e386[3], _e386[4], _e386[5], _e386[6], _e386[7], _e386[8], _e386[9], _e386[10], _e386[11], _e386[12], _e386[13], _e386[14], _e386[15], _e386[16], _e386[17], _e386[18], _e386[19], _e386[20], _e386[21], _e386[22], _e386[23], _e386[24], _e386[25], _e386[26], _e386[27]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
