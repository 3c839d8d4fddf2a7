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

struct type_21 {
    member: array<array<u32, 4>>,
}

struct type_25 {
    member: array<array<u32, 24>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> inputs: type_21;
@group(0) @binding(1) 
var<storage, read_write> out: type_25;

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
    var phi_284_: f64;
    var phi_285_: f64;
    var phi_286_: f64;
    var phi_312_: f64;
    var phi_313_: f64;
    var phi_314_: f64;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_349_: f32;
    var phi_351_: f32;
    var phi_408_: type_11;
    var phi_409_: type_11;
    var phi_432_: type_11;

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
            phi_259_ = (_e179 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
        }
        let _e186 = phi_259_;
        let _e187 = bitcast<u64>(_e186);
        let _e191 = bitcast<u64>(_e73);
        if ((_e191 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_286_ = _e73;
        } else {
            if (_e73 > 0.0lf) {
                phi_285_ = bitcast<f64>((_e191 + 1lu));
            } else {
                if (_e73 < 0.0lf) {
                    phi_284_ = bitcast<f64>((_e191 - 1lu));
                } else {
                    phi_284_ = 5e-324lf;
                }
                let _e199 = phi_284_;
                phi_285_ = _e199;
            }
            let _e203 = phi_285_;
            phi_286_ = _e203;
        }
        let _e205 = phi_286_;
        let _e206 = bitcast<u64>(_e205);
        let _e210 = -(_e73);
        let _e211 = bitcast<u64>(_e210);
        if ((_e211 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_314_ = _e210;
        } else {
            if (_e210 > 0.0lf) {
                phi_313_ = bitcast<f64>((_e211 + 1lu));
            } else {
                if (_e210 < 0.0lf) {
                    phi_312_ = bitcast<f64>((_e211 - 1lu));
                } else {
                    phi_312_ = 5e-324lf;
                }
                let _e219 = phi_312_;
                phi_313_ = _e219;
            }
            let _e223 = phi_313_;
            phi_314_ = _e223;
        }
        let _e225 = phi_314_;
        let _e227 = bitcast<u64>(-(_e225));
        let _e231 = f32(_e73);
        if (f64(_e231) > _e73) {
            let _e234 = -(_e231);
            let _e235 = bitcast<u32>(_e234);
            if ((_e235 & 2139095040u) == 2139095040u) {
                phi_349_ = _e234;
            } else {
                if (_e234 > 0f) {
                    phi_348_ = bitcast<f32>((_e235 + 1u));
                } else {
                    if (_e234 < 0f) {
                        phi_347_ = bitcast<f32>((_e235 - 1u));
                    } else {
                        phi_347_ = 0.000000000000000000000000000000000000000000001f;
                    }
                    let _e243 = phi_347_;
                    phi_348_ = _e243;
                }
                let _e247 = phi_348_;
                phi_349_ = _e247;
            }
            let _e249 = phi_349_;
            phi_351_ = -(_e249);
        } else {
            phi_351_ = _e231;
        }
        let _e252 = phi_351_;
        local_1[0u] = array<u32, 2>(u32(_e82), u32((_e82 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e87), u32((_e87 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e92), u32((_e92 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e97), u32((_e97 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e105), u32((_e105 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e112), u32((_e112 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e119), u32((_e119 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e73 < _e80)), select(0u, 1u, (_e73 <= _e80)));
        local_1[8u] = array<u32, 2>(u32(_e187), u32((_e187 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e206), u32((_e206 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e227), u32((_e227 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e252), select(0u, 1u, ((bitcast<u64>(_e73) & 9218868437227405312lu) != 9218868437227405312lu)));
        local = array<u32, 24>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_408_ = type_11(0u, 12u);
        loop {
            let _e283 = phi_408_;
            if (_e283.member < _e283.member_1) {
                phi_409_ = type_11((_e283.member + 1u), _e283.member_1);
                phi_432_ = type_11(1u, _e283.member);
            } else {
                phi_409_ = _e283;
                phi_432_ = type_11(0u, type_11().member_1);
            }
            let _e297 = phi_409_;
            let _e299 = phi_432_;
            let _e303 = (bitcast<i32>(_e299.member) != 0i);
            if _e303 {
                if (_e299.member_1 < 12u) {
                } else {
                    return;
                }
                let _e307 = local_1[_e299.member_1][0u];
                let _e308 = (2u * _e299.member_1);
                if (_e308 < 24u) {
                } else {
                    return;
                }
                local[_e308] = _e307;
                if (_e299.member_1 < 12u) {
                } else {
                    return;
                }
                let _e314 = local_1[_e299.member_1][1u];
                let _e316 = ((2u * _e299.member_1) + 1u);
                if (_e316 < 24u) {
                } else {
                    return;
                }
                local[_e316] = _e314;
            }
            continue;
            continuing {
                phi_408_ = _e297;
                break if !(_e303);
            }
        }
        let _e320 = local;
        out.member[_e63] = array<u32, 24>(_e320[0], _e320[1], _e320[2], _e320[3], _e320[4], _e320[5], _e320[6], _e320[7], _e320[8], _e320[9], _e320[10], _e320[11], _e320[12], _e320[13], _e320[14], _e320[15], _e320[16], _e320[17], _e320[18], _e320[19], _e320[20], _e320[21], _e320[22], _e320[23]);
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
