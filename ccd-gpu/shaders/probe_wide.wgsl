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

struct type_18 {
    member: f32,
    member_1: f32,
}

@group(0) @binding(0) 
var<storage> inputs: type_11;
@group(0) @binding(1) 
var<storage, read_write> results: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 26>;
    var local_1: array<array<u32, 2>, 13>;
    var phi_168_: f64;
    var phi_178_: f64;
    var phi_188_: f64;
    var phi_219_: type_16;
    var phi_222_: f64;
    var phi_243_: bool;
    var phi_249_: type_17;
    var phi_220_: type_16;
    var phi_263_: type_17;
    var phi_223_: f64;
    var local_2: f64;
    var phi_212_: f64;
    var phi_276_: f64;
    var phi_292_: bool;
    var phi_309_: f64;
    var phi_310_: f64;
    var phi_311_: f64;
    var phi_328_: bool;
    var phi_345_: f64;
    var phi_346_: f64;
    var phi_347_: f64;
    var phi_400_: bool;
    var phi_401_: u32;
    var phi_402_: bool;
    var phi_403_: u32;
    var phi_404_: bool;
    var phi_405_: u32;
    var phi_406_: bool;
    var phi_407_: u32;
    var phi_420_: type_18;
    var phi_490_: type_4;
    var phi_491_: type_4;
    var phi_514_: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e62 = id_2;
    let _e63 = n_2;
    let _e64 = lane_2;
    let _e75 = ((((_e62.y * _e63.x) + _e62.x) * 64u) + _e64);
    if (_e75 < arrayLength((&inputs.member))) {
        let _e78 = inputs.member[_e75];
        let _e85 = bitcast<f64>(((u64(_e78[1]) * 4294967296lu) + u64(_e78[0])));
        let _e92 = bitcast<f64>(((u64(_e78[3]) * 4294967296lu) + u64(_e78[2])));
        let _e94 = bitcast<u64>((_e85 + _e92));
        let _e99 = bitcast<u64>((_e85 - _e92));
        let _e104 = bitcast<u64>((_e85 * _e92));
        let _e109 = bitcast<u64>((_e85 / _e92));
        if (_e85 < 0.0lf) {
            phi_168_ = -(_e85);
        } else {
            phi_168_ = _e85;
        }
        let _e116 = phi_168_;
        let _e117 = bitcast<u64>(_e116);
        if (_e85 < _e92) {
            phi_178_ = _e85;
        } else {
            phi_178_ = _e92;
        }
        let _e123 = phi_178_;
        let _e124 = bitcast<u64>(_e123);
        if (_e85 > _e92) {
            phi_188_ = _e85;
        } else {
            phi_188_ = _e92;
        }
        let _e130 = phi_188_;
        let _e131 = bitcast<u64>(_e130);
        if (_e85 <= 2.2250738585072014e-308lf) {
            if (_e85 > 0.0lf) {
                phi_212_ = (1.464336215552873e-154lf * 2.0lf);
            } else {
                phi_212_ = 0.0lf;
            }
            let _e190 = phi_212_;
            phi_276_ = _e190;
        } else {
            phi_219_ = type_16(0i, 5i);
            phi_222_ = bitcast<f64>(((bitcast<u64>(_e85) / 2lu) + 2303426169912950784lu));
            loop {
                let _e145 = phi_219_;
                let _e147 = phi_222_;
                local_2 = _e147;
                if (_e145.member < _e145.member_1) {
                    let _e154 = (_e145.member + 1i);
                    if ((false == (_e154 > _e145.member)) != false) {
                        phi_243_ = true;
                    } else {
                        phi_243_ = false;
                    }
                    let _e159 = phi_243_;
                    if _e159 {
                        phi_249_ = type_17(0u, type_17().member_1);
                    } else {
                        phi_249_ = type_17(1u, _e154);
                    }
                    let _e164 = phi_249_;
                    phi_220_ = type_16(_e164.member_1, _e145.member_1);
                    phi_263_ = type_17(1u, _e145.member);
                } else {
                    phi_220_ = _e145;
                    phi_263_ = type_17(0u, type_17().member_1);
                }
                let _e170 = phi_220_;
                let _e172 = phi_263_;
                let _e175 = (bitcast<i32>(_e172.member) != 0i);
                if _e175 {
                    phi_223_ = (0.5lf * (_e147 + (_e85 / _e147)));
                } else {
                    phi_223_ = f64();
                }
                let _e180 = phi_223_;
                continue;
                continuing {
                    phi_219_ = _e170;
                    phi_222_ = _e180;
                    break if !(_e175);
                }
            }
            let _e185 = local_2;
            phi_276_ = (_e185 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e192 = phi_276_;
        let _e193 = bitcast<u64>(_e192);
        let _e197 = bitcast<u64>(_e85);
        if ((_e197 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_292_ = (_e85 < 0.0lf);
        } else {
            phi_292_ = true;
        }
        let _e202 = phi_292_;
        if _e202 {
            if (_e85 > 0.0lf) {
                phi_310_ = bitcast<f64>((_e197 + 1lu));
            } else {
                if (_e85 < 0.0lf) {
                    phi_309_ = bitcast<f64>((_e197 - 1lu));
                } else {
                    phi_309_ = 5e-324lf;
                }
                let _e208 = phi_309_;
                phi_310_ = _e208;
            }
            let _e212 = phi_310_;
            phi_311_ = _e212;
        } else {
            phi_311_ = _e85;
        }
        let _e214 = phi_311_;
        let _e215 = bitcast<u64>(_e214);
        let _e219 = -(_e85);
        let _e220 = bitcast<u64>(_e219);
        if ((_e220 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_328_ = (_e219 < 0.0lf);
        } else {
            phi_328_ = true;
        }
        let _e225 = phi_328_;
        if _e225 {
            if (_e219 > 0.0lf) {
                phi_346_ = bitcast<f64>((_e220 + 1lu));
            } else {
                if (_e219 < 0.0lf) {
                    phi_345_ = bitcast<f64>((_e220 - 1lu));
                } else {
                    phi_345_ = 5e-324lf;
                }
                let _e231 = phi_345_;
                phi_346_ = _e231;
            }
            let _e235 = phi_346_;
            phi_347_ = _e235;
        } else {
            phi_347_ = _e219;
        }
        let _e237 = phi_347_;
        let _e239 = bitcast<u64>(-(_e237));
        let _e243 = bitcast<u64>(_e85);
        let _e244 = u32(_e243);
        let _e246 = u32((_e243 / 4294967296lu));
        let _e247 = (_e246 & 2147483648u);
        let _e250 = ((_e246 >> bitcast<u32>(20i)) & 2047u);
        let _e256 = (((_e246 & 1048575u) << bitcast<u32>(3i)) | (_e244 >> bitcast<u32>(29i)));
        let _e257 = (_e244 & 536870911u);
        if (_e250 == 2047u) {
            phi_406_ = false;
            phi_407_ = (2139095040u | _e256);
        } else {
            if (_e250 > 1150u) {
                phi_404_ = true;
                phi_405_ = 2139095039u;
            } else {
                if (_e250 > 896u) {
                    phi_402_ = (_e257 != 0u);
                    phi_403_ = (((_e250 - 896u) << bitcast<u32>(23i)) | _e256);
                } else {
                    if (_e250 >= 873u) {
                        let _e265 = (8388608u | _e256);
                        let _e266 = (897u - _e250);
                        phi_400_ = (((_e265 & ((1u << bitcast<u32>((_e266 & 31u))) - 1u)) | _e257) != 0u);
                        phi_401_ = (_e265 >> bitcast<u32>((_e266 & 31u)));
                    } else {
                        phi_400_ = (((_e246 & 2147483647u) | _e244) != 0u);
                        phi_401_ = 0u;
                    }
                    let _e278 = phi_400_;
                    let _e280 = phi_401_;
                    phi_402_ = _e278;
                    phi_403_ = _e280;
                }
                let _e287 = phi_402_;
                let _e289 = phi_403_;
                phi_404_ = _e287;
                phi_405_ = _e289;
            }
            let _e291 = phi_404_;
            let _e293 = phi_405_;
            phi_406_ = _e291;
            phi_407_ = _e293;
        }
        let _e296 = phi_406_;
        let _e298 = phi_407_;
        let _e300 = bitcast<f32>((_e247 | _e298));
        let _e304 = bitcast<f32>(((_e247 | _e298) + select(0u, 1u, _e296)));
        if (_e247 == 0u) {
            phi_420_ = type_18(_e300, _e304);
        } else {
            phi_420_ = type_18(_e304, _e300);
        }
        let _e309 = phi_420_;
        let _e319 = bitcast<u64>(f64(bitcast<f32>(_e78[0])));
        local_1[0u] = array<u32, 2>(u32(_e94), u32((_e94 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e99), u32((_e99 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e104), u32((_e104 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e109), u32((_e109 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e117), u32((_e117 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e124), u32((_e124 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e131), u32((_e131 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e85 < _e92)), select(0u, 1u, (_e85 <= _e92)));
        local_1[8u] = array<u32, 2>(u32(_e193), u32((_e193 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e215), u32((_e215 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e239), u32((_e239 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e309.member), select(0u, 1u, ((bitcast<u64>(_e85) & 9218868437227405312lu) != 9218868437227405312lu)));
        local_1[12u] = array<u32, 2>(u32(_e319), u32((_e319 / 4294967296lu)));
        local = array<u32, 26>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_490_ = type_4(0u, 13u);
        loop {
            let _e350 = phi_490_;
            if (_e350.member < _e350.member_1) {
                phi_491_ = type_4((_e350.member + 1u), _e350.member_1);
                phi_514_ = type_4(1u, _e350.member);
            } else {
                phi_491_ = _e350;
                phi_514_ = type_4(0u, type_4().member_1);
            }
            let _e362 = phi_491_;
            let _e364 = phi_514_;
            let _e368 = (bitcast<i32>(_e364.member) != 0i);
            if _e368 {
                let _e371 = local_1[_e364.member_1][0u];
                local[(2u * _e364.member_1)] = _e371;
                let _e376 = local_1[_e364.member_1][1u];
                local[((2u * _e364.member_1) + 1u)] = _e376;
            }
            continue;
            continuing {
                phi_490_ = _e362;
                break if !(_e368);
            }
        }
        let _e381 = local;
        results.member[_e75] = array<u32, 26>(_e381[0], _e381[1], _e381[2], _e381[3], _e381[4], _e381[5], _e381[6], _e381[7], _e381[8], _e381[9], _e381[10], _e381[11], _e381[12], _e381[13], _e381[14], _e381[15], _e381[16], _e381[17], _e381[18], _e381[19], _e381[20], _e381[21], _e381[22], _e381[23], _e381[24], _e381[25]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
