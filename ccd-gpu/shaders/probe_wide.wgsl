struct type_9 {
    member: i32,
    member_1: i32,
}

struct type_10 {
    member: u32,
    member_1: i32,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_23 {
    member: array<array<u32, 4>>,
}

struct type_27 {
    member: array<array<u32, 24>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> inputs: type_23;
@group(0) @binding(1) 
var<storage, read_write> out: type_27;

fn function_() {
    var local: array<u32, 24>;
    var local_1: array<array<u32, 2>, 12>;
    var phi_151_: f64;
    var phi_161_: f64;
    var phi_171_: f64;
    var phi_202_: type_9;
    var phi_205_: f64;
    var phi_226_: bool;
    var phi_232_: type_10;
    var phi_203_: type_9;
    var phi_246_: type_10;
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
    var phi_432_: type_11;
    var phi_433_: type_11;
    var phi_456_: type_11;

    let _e50 = id_1;
    let _e51 = n_1;
    let _e52 = lane_1;
    let _e63 = ((((_e50.y * _e51.x) + _e50.x) * 64u) + _e52);
    if (_e63 < arrayLength((&inputs.member))) {
        let _e66 = inputs.member[_e63];
        let _e73 = bitcast<f64>(((u64(_e66[1]) * 4294967296lu) + u64(_e66[0])));
        let _e80 = bitcast<f64>(((u64(_e66[3]) * 4294967296lu) + u64(_e66[2])));
        let _e82 = bitcast<u64>((_e73 + _e80));
        let _e87 = bitcast<u64>((_e73 - _e80));
        let _e92 = bitcast<u64>((_e73 * _e80));
        let _e97 = bitcast<u64>((_e73 / _e80));
        if (_e73 < 0.0lf) {
            phi_151_ = -(_e73);
        } else {
            phi_151_ = _e73;
        }
        let _e104 = phi_151_;
        let _e105 = bitcast<u64>(_e104);
        if (_e73 < _e80) {
            phi_161_ = _e73;
        } else {
            phi_161_ = _e80;
        }
        let _e111 = phi_161_;
        let _e112 = bitcast<u64>(_e111);
        if (_e73 > _e80) {
            phi_171_ = _e73;
        } else {
            phi_171_ = _e80;
        }
        let _e118 = phi_171_;
        let _e119 = bitcast<u64>(_e118);
        if (_e73 <= 2.2250738585072014e-308lf) {
            if (_e73 > 0.0lf) {
                phi_195_ = (1.464336215552873e-154lf * 2.0lf);
            } else {
                phi_195_ = 0.0lf;
            }
            let _e184 = phi_195_;
            phi_259_ = _e184;
        } else {
            phi_202_ = type_9(0i, 5i);
            phi_205_ = bitcast<f64>(((bitcast<u64>(_e73) / 2lu) + 2303426169912950784lu));
            loop {
                let _e133 = phi_202_;
                let _e135 = phi_205_;
                local_2 = _e135;
                if (_e133.member < _e133.member_1) {
                    let _e143 = (_e133.member + 1i);
                    if ((false == (_e143 > _e133.member)) != false) {
                        phi_226_ = true;
                    } else {
                        phi_226_ = false;
                    }
                    let _e148 = phi_226_;
                    if _e148 {
                        phi_232_ = type_10(0u, type_10().member_1);
                    } else {
                        phi_232_ = type_10(1u, _e143);
                    }
                    let _e154 = phi_232_;
                    if (bitcast<i32>(_e154.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_203_ = type_9(_e154.member_1, _e133.member_1);
                    phi_246_ = type_10(1u, _e133.member);
                } else {
                    phi_203_ = _e133;
                    phi_246_ = type_10(0u, type_10().member_1);
                }
                let _e164 = phi_203_;
                let _e166 = phi_246_;
                let _e169 = (bitcast<i32>(_e166.member) != 0i);
                if _e169 {
                    phi_206_ = (0.5lf * (_e135 + (_e73 / _e135)));
                } else {
                    phi_206_ = f64();
                }
                let _e174 = phi_206_;
                continue;
                continuing {
                    phi_202_ = _e164;
                    phi_205_ = _e174;
                    break if !(_e169);
                }
            }
            let _e179 = local_2;
            phi_259_ = (_e179 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e186 = phi_259_;
        let _e187 = bitcast<u64>(_e186);
        let _e191 = bitcast<u64>(_e73);
        if ((_e191 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_275_ = (_e73 < 0.0lf);
        } else {
            phi_275_ = true;
        }
        let _e196 = phi_275_;
        if _e196 {
            if (_e73 > 0.0lf) {
                phi_293_ = bitcast<f64>((_e191 + 1lu));
            } else {
                if (_e73 < 0.0lf) {
                    phi_292_ = bitcast<f64>((_e191 - 1lu));
                } else {
                    phi_292_ = 5e-324lf;
                }
                let _e202 = phi_292_;
                phi_293_ = _e202;
            }
            let _e206 = phi_293_;
            phi_294_ = _e206;
        } else {
            phi_294_ = _e73;
        }
        let _e208 = phi_294_;
        let _e209 = bitcast<u64>(_e208);
        let _e213 = -(_e73);
        let _e214 = bitcast<u64>(_e213);
        if ((_e214 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_311_ = (_e213 < 0.0lf);
        } else {
            phi_311_ = true;
        }
        let _e219 = phi_311_;
        if _e219 {
            if (_e213 > 0.0lf) {
                phi_329_ = bitcast<f64>((_e214 + 1lu));
            } else {
                if (_e213 < 0.0lf) {
                    phi_328_ = bitcast<f64>((_e214 - 1lu));
                } else {
                    phi_328_ = 5e-324lf;
                }
                let _e225 = phi_328_;
                phi_329_ = _e225;
            }
            let _e229 = phi_329_;
            phi_330_ = _e229;
        } else {
            phi_330_ = _e213;
        }
        let _e231 = phi_330_;
        let _e233 = bitcast<u64>(-(_e231));
        let _e237 = f32(_e73);
        if (f64(_e237) > _e73) {
            let _e240 = -(_e237);
            let _e241 = bitcast<u32>(_e240);
            if ((_e241 & 2139095040u) == 2139095040u) {
                phi_354_ = (_e240 < 0f);
            } else {
                phi_354_ = true;
            }
            let _e246 = phi_354_;
            if _e246 {
                if (_e240 > 0f) {
                    phi_372_ = bitcast<f32>((_e241 + 1u));
                } else {
                    if (_e240 < 0f) {
                        phi_371_ = bitcast<f32>((_e241 - 1u));
                    } else {
                        phi_371_ = 0.000000000000000000000000000000000000000000001f;
                    }
                    let _e252 = phi_371_;
                    phi_372_ = _e252;
                }
                let _e256 = phi_372_;
                phi_373_ = _e256;
            } else {
                phi_373_ = _e240;
            }
            let _e258 = phi_373_;
            phi_375_ = -(_e258);
        } else {
            phi_375_ = _e237;
        }
        let _e261 = phi_375_;
        local_1[0u] = array<u32, 2>(u32(_e82), u32((_e82 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e87), u32((_e87 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e92), u32((_e92 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e97), u32((_e97 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e105), u32((_e105 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e112), u32((_e112 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e119), u32((_e119 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e73 < _e80)), select(0u, 1u, (_e73 <= _e80)));
        local_1[8u] = array<u32, 2>(u32(_e187), u32((_e187 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e209), u32((_e209 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e233), u32((_e233 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e261), select(0u, 1u, ((bitcast<u64>(_e73) & 9218868437227405312lu) != 9218868437227405312lu)));
        local = array<u32, 24>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_432_ = type_11(0u, 12u);
        loop {
            let _e292 = phi_432_;
            if (_e292.member < _e292.member_1) {
                phi_433_ = type_11((_e292.member + 1u), _e292.member_1);
                phi_456_ = type_11(1u, _e292.member);
            } else {
                phi_433_ = _e292;
                phi_456_ = type_11(0u, type_11().member_1);
            }
            let _e306 = phi_433_;
            let _e308 = phi_456_;
            let _e312 = (bitcast<i32>(_e308.member) != 0i);
            if _e312 {
                if (_e308.member_1 < 12u) {
                } else {
                    return;
                }
                let _e316 = local_1[_e308.member_1][0u];
                let _e317 = (2u * _e308.member_1);
                if (_e317 < 24u) {
                } else {
                    return;
                }
                local[_e317] = _e316;
                if (_e308.member_1 < 12u) {
                } else {
                    return;
                }
                let _e323 = local_1[_e308.member_1][1u];
                let _e325 = ((2u * _e308.member_1) + 1u);
                if (_e325 < 24u) {
                } else {
                    return;
                }
                local[_e325] = _e323;
            }
            continue;
            continuing {
                phi_432_ = _e306;
                break if !(_e312);
            }
        }
        let _e329 = local;
        out.member[_e63] = array<u32, 24>(_e329[0], _e329[1], _e329[2], _e329[3], _e329[4], _e329[5], _e329[6], _e329[7], _e329[8], _e329[9], _e329[10], _e329[11], _e329[12], _e329[13], _e329[14], _e329[15], _e329[16], _e329[17], _e329[18], _e329[19], _e329[20], _e329[21], _e329[22], _e329[23]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
