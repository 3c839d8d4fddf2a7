// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<array<u32, 4>>,
}

struct type_13 {
    member: array<array<u32, 26>>,
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
    var local: array<u32, 26>;
    var local_1: array<array<u32, 2>, 13>;
    var phi_152_: f64;
    var phi_162_: f64;
    var phi_172_: f64;
    var phi_203_: type_16;
    var phi_206_: f64;
    var phi_227_: bool;
    var phi_233_: type_17;
    var phi_204_: type_16;
    var phi_247_: type_17;
    var phi_207_: f64;
    var local_2: f64;
    var phi_196_: f64;
    var phi_260_: f64;
    var phi_276_: bool;
    var phi_293_: f64;
    var phi_294_: f64;
    var phi_295_: f64;
    var phi_312_: bool;
    var phi_329_: f64;
    var phi_330_: f64;
    var phi_331_: f64;
    var phi_355_: bool;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_376_: f32;
    var phi_445_: type_4;
    var phi_446_: type_4;
    var phi_469_: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e61 = ((((_e48.y * _e49.x) + _e48.x) * 64u) + _e50);
    if (_e61 < arrayLength((&inputs.member))) {
        let _e64 = inputs.member[_e61];
        let _e71 = bitcast<f64>(((u64(_e64[1]) * 4294967296lu) + u64(_e64[0])));
        let _e78 = bitcast<f64>(((u64(_e64[3]) * 4294967296lu) + u64(_e64[2])));
        let _e80 = bitcast<u64>((_e71 + _e78));
        let _e85 = bitcast<u64>((_e71 - _e78));
        let _e90 = bitcast<u64>((_e71 * _e78));
        let _e95 = bitcast<u64>((_e71 / _e78));
        if (_e71 < 0.0lf) {
            phi_152_ = -(_e71);
        } else {
            phi_152_ = _e71;
        }
        let _e102 = phi_152_;
        let _e103 = bitcast<u64>(_e102);
        if (_e71 < _e78) {
            phi_162_ = _e71;
        } else {
            phi_162_ = _e78;
        }
        let _e109 = phi_162_;
        let _e110 = bitcast<u64>(_e109);
        if (_e71 > _e78) {
            phi_172_ = _e71;
        } else {
            phi_172_ = _e78;
        }
        let _e116 = phi_172_;
        let _e117 = bitcast<u64>(_e116);
        if (_e71 <= 2.2250738585072014e-308lf) {
            if (_e71 > 0.0lf) {
                phi_196_ = (1.464336215552873e-154lf * 2.0lf);
            } else {
                phi_196_ = 0.0lf;
            }
            let _e176 = phi_196_;
            phi_260_ = _e176;
        } else {
            phi_203_ = type_16(0i, 5i);
            phi_206_ = bitcast<f64>(((bitcast<u64>(_e71) / 2lu) + 2303426169912950784lu));
            loop {
                let _e131 = phi_203_;
                let _e133 = phi_206_;
                local_2 = _e133;
                if (_e131.member < _e131.member_1) {
                    let _e140 = (_e131.member + 1i);
                    if ((false == (_e140 > _e131.member)) != false) {
                        phi_227_ = true;
                    } else {
                        phi_227_ = false;
                    }
                    let _e145 = phi_227_;
                    if _e145 {
                        phi_233_ = type_17(0u, type_17().member_1);
                    } else {
                        phi_233_ = type_17(1u, _e140);
                    }
                    let _e150 = phi_233_;
                    phi_204_ = type_16(_e150.member_1, _e131.member_1);
                    phi_247_ = type_17(1u, _e131.member);
                } else {
                    phi_204_ = _e131;
                    phi_247_ = type_17(0u, type_17().member_1);
                }
                let _e156 = phi_204_;
                let _e158 = phi_247_;
                let _e161 = (bitcast<i32>(_e158.member) != 0i);
                if _e161 {
                    phi_207_ = (0.5lf * (_e133 + (_e71 / _e133)));
                } else {
                    phi_207_ = f64();
                }
                let _e166 = phi_207_;
                continue;
                continuing {
                    phi_203_ = _e156;
                    phi_206_ = _e166;
                    break if !(_e161);
                }
            }
            let _e171 = local_2;
            phi_260_ = (_e171 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e178 = phi_260_;
        let _e179 = bitcast<u64>(_e178);
        let _e183 = bitcast<u64>(_e71);
        if ((_e183 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_276_ = (_e71 < 0.0lf);
        } else {
            phi_276_ = true;
        }
        let _e188 = phi_276_;
        if _e188 {
            if (_e71 > 0.0lf) {
                phi_294_ = bitcast<f64>((_e183 + 1lu));
            } else {
                if (_e71 < 0.0lf) {
                    phi_293_ = bitcast<f64>((_e183 - 1lu));
                } else {
                    phi_293_ = 5e-324lf;
                }
                let _e194 = phi_293_;
                phi_294_ = _e194;
            }
            let _e198 = phi_294_;
            phi_295_ = _e198;
        } else {
            phi_295_ = _e71;
        }
        let _e200 = phi_295_;
        let _e201 = bitcast<u64>(_e200);
        let _e205 = -(_e71);
        let _e206 = bitcast<u64>(_e205);
        if ((_e206 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_312_ = (_e205 < 0.0lf);
        } else {
            phi_312_ = true;
        }
        let _e211 = phi_312_;
        if _e211 {
            if (_e205 > 0.0lf) {
                phi_330_ = bitcast<f64>((_e206 + 1lu));
            } else {
                if (_e205 < 0.0lf) {
                    phi_329_ = bitcast<f64>((_e206 - 1lu));
                } else {
                    phi_329_ = 5e-324lf;
                }
                let _e217 = phi_329_;
                phi_330_ = _e217;
            }
            let _e221 = phi_330_;
            phi_331_ = _e221;
        } else {
            phi_331_ = _e205;
        }
        let _e223 = phi_331_;
        let _e225 = bitcast<u64>(-(_e223));
        let _e229 = f32(_e71);
        if (f64(_e229) > _e71) {
            let _e232 = -(_e229);
            let _e233 = bitcast<u32>(_e232);
            if ((_e233 & 2139095040u) == 2139095040u) {
                phi_355_ = (_e232 < 0f);
            } else {
                phi_355_ = true;
            }
            let _e238 = phi_355_;
            if _e238 {
                if (_e232 > 0f) {
                    phi_373_ = bitcast<f32>((_e233 + 1u));
                } else {
                    if (_e232 < 0f) {
                        phi_372_ = bitcast<f32>((_e233 - 1u));
                    } else {
                        phi_372_ = 0.000000000000000000000000000000000000000000001f;
                    }
                    let _e244 = phi_372_;
                    phi_373_ = _e244;
                }
                let _e248 = phi_373_;
                phi_374_ = _e248;
            } else {
                phi_374_ = _e232;
            }
            let _e250 = phi_374_;
            phi_376_ = -(_e250);
        } else {
            phi_376_ = _e229;
        }
        let _e253 = phi_376_;
        let _e262 = bitcast<u64>(f64(bitcast<f32>(_e64[0])));
        local_1[0u] = array<u32, 2>(u32(_e80), u32((_e80 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e85), u32((_e85 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e90), u32((_e90 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e103), u32((_e103 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e110), u32((_e110 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e117), u32((_e117 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e71 < _e78)), select(0u, 1u, (_e71 <= _e78)));
        local_1[8u] = array<u32, 2>(u32(_e179), u32((_e179 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e201), u32((_e201 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e225), u32((_e225 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e253), select(0u, 1u, ((bitcast<u64>(_e71) & 9218868437227405312lu) != 9218868437227405312lu)));
        local_1[12u] = array<u32, 2>(u32(_e262), u32((_e262 / 4294967296lu)));
        local = array<u32, 26>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_445_ = type_4(0u, 13u);
        loop {
            let _e293 = phi_445_;
            if (_e293.member < _e293.member_1) {
                phi_446_ = type_4((_e293.member + 1u), _e293.member_1);
                phi_469_ = type_4(1u, _e293.member);
            } else {
                phi_446_ = _e293;
                phi_469_ = type_4(0u, type_4().member_1);
            }
            let _e305 = phi_446_;
            let _e307 = phi_469_;
            let _e311 = (bitcast<i32>(_e307.member) != 0i);
            if _e311 {
                let _e314 = local_1[_e307.member_1][0u];
                local[(2u * _e307.member_1)] = _e314;
                let _e319 = local_1[_e307.member_1][1u];
                local[((2u * _e307.member_1) + 1u)] = _e319;
            }
            continue;
            continuing {
                phi_445_ = _e305;
                break if !(_e311);
            }
        }
        let _e324 = local;
        results.member[_e61] = array<u32, 26>(_e324[0], _e324[1], _e324[2], _e324[3], _e324[4], _e324[5], _e324[6], _e324[7], _e324[8], _e324[9], _e324[10], _e324[11], _e324[12], _e324[13], _e324[14], _e324[15], _e324[16], _e324[17], _e324[18], _e324[19], _e324[20], _e324[21], _e324[22], _e324[23], _e324[24], _e324[25]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
