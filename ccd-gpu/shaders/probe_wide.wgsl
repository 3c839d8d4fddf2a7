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
    var phi_150_: f64;
    var phi_160_: f64;
    var phi_170_: f64;
    var phi_201_: type_9;
    var phi_204_: f64;
    var phi_225_: bool;
    var phi_231_: type_10;
    var phi_202_: type_9;
    var phi_245_: type_10;
    var phi_205_: f64;
    var local_2: f64;
    var phi_194_: f64;
    var phi_258_: f64;
    var phi_283_: f64;
    var phi_284_: f64;
    var phi_285_: f64;
    var phi_311_: f64;
    var phi_312_: f64;
    var phi_313_: f64;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_350_: f32;
    var phi_407_: type_11;
    var phi_408_: type_11;
    var phi_431_: type_11;

    let _e49 = id_1;
    let _e50 = n_1;
    let _e51 = lane_1;
    let _e62 = ((((_e49.y * _e50.x) + _e49.x) * 64u) + _e51);
    if (_e62 < arrayLength((&inputs.member))) {
        let _e65 = inputs.member[_e62];
        let _e73 = bitcast<f64>(((u64(_e65[1]) << bitcast<u64>(32lu)) | u64(_e65[0])));
        let _e81 = bitcast<f64>(((u64(_e65[3]) << bitcast<u64>(32lu)) | u64(_e65[2])));
        let _e83 = bitcast<u64>((_e73 + _e81));
        let _e89 = bitcast<u64>((_e73 - _e81));
        let _e95 = bitcast<u64>((_e73 * _e81));
        let _e101 = bitcast<u64>((_e73 / _e81));
        if (_e73 < 0.0lf) {
            phi_150_ = -(_e73);
        } else {
            phi_150_ = _e73;
        }
        let _e109 = phi_150_;
        let _e110 = bitcast<u64>(_e109);
        if (_e73 < _e81) {
            phi_160_ = _e73;
        } else {
            phi_160_ = _e81;
        }
        let _e117 = phi_160_;
        let _e118 = bitcast<u64>(_e117);
        if (_e73 > _e81) {
            phi_170_ = _e73;
        } else {
            phi_170_ = _e81;
        }
        let _e125 = phi_170_;
        let _e126 = bitcast<u64>(_e125);
        if (_e73 <= 2.2250738585072014e-308lf) {
            if (_e73 > 0.0lf) {
                phi_194_ = (bitcast<f64>(((4503599627370496lu >> bitcast<u64>(1lu)) + 2303426169912950784lu)) * 2.0lf);
            } else {
                phi_194_ = 0.0lf;
            }
            let _e197 = phi_194_;
            phi_258_ = _e197;
        } else {
            phi_201_ = type_9(0i, 5i);
            phi_204_ = bitcast<f64>(((bitcast<u64>(_e73) >> bitcast<u64>(1lu)) + 2303426169912950784lu));
            loop {
                let _e142 = phi_201_;
                let _e144 = phi_204_;
                local_2 = _e144;
                if (_e142.member < _e142.member_1) {
                    let _e152 = (_e142.member + 1i);
                    if ((false == (_e152 > _e142.member)) != false) {
                        phi_225_ = true;
                    } else {
                        phi_225_ = false;
                    }
                    let _e157 = phi_225_;
                    if _e157 {
                        phi_231_ = type_10(0u, type_10().member_1);
                    } else {
                        phi_231_ = type_10(1u, _e152);
                    }
                    let _e163 = phi_231_;
                    if (bitcast<i32>(_e163.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_202_ = type_9(_e163.member_1, _e142.member_1);
                    phi_245_ = type_10(1u, _e142.member);
                } else {
                    phi_202_ = _e142;
                    phi_245_ = type_10(0u, type_10().member_1);
                }
                let _e173 = phi_202_;
                let _e175 = phi_245_;
                let _e178 = (bitcast<i32>(_e175.member) != 0i);
                if _e178 {
                    phi_205_ = (0.5lf * (_e144 + (_e73 / _e144)));
                } else {
                    phi_205_ = f64();
                }
                let _e183 = phi_205_;
                continue;
                continuing {
                    phi_201_ = _e173;
                    phi_204_ = _e183;
                    break if !(_e178);
                }
            }
            let _e188 = local_2;
            phi_258_ = (_e188 * (1.0lf + (4.0lf * 1.1102230246251565e-16lf)));
        }
        let _e199 = phi_258_;
        let _e200 = bitcast<u64>(_e199);
        let _e205 = bitcast<u64>(_e73);
        if ((_e205 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_285_ = _e73;
        } else {
            if (_e73 > 0.0lf) {
                phi_284_ = bitcast<f64>((_e205 + 1lu));
            } else {
                if (_e73 < 0.0lf) {
                    phi_283_ = bitcast<f64>((_e205 - 1lu));
                } else {
                    phi_283_ = 5e-324lf;
                }
                let _e213 = phi_283_;
                phi_284_ = _e213;
            }
            let _e217 = phi_284_;
            phi_285_ = _e217;
        }
        let _e219 = phi_285_;
        let _e220 = bitcast<u64>(_e219);
        let _e225 = -(_e73);
        let _e226 = bitcast<u64>(_e225);
        if ((_e226 & 9218868437227405312lu) == 9218868437227405312lu) {
            phi_313_ = _e225;
        } else {
            if (_e225 > 0.0lf) {
                phi_312_ = bitcast<f64>((_e226 + 1lu));
            } else {
                if (_e225 < 0.0lf) {
                    phi_311_ = bitcast<f64>((_e226 - 1lu));
                } else {
                    phi_311_ = 5e-324lf;
                }
                let _e234 = phi_311_;
                phi_312_ = _e234;
            }
            let _e238 = phi_312_;
            phi_313_ = _e238;
        }
        let _e240 = phi_313_;
        let _e242 = bitcast<u64>(-(_e240));
        let _e247 = f32(_e73);
        if (f64(_e247) > _e73) {
            let _e250 = -(_e247);
            let _e251 = bitcast<u32>(_e250);
            if ((_e251 & 2139095040u) == 2139095040u) {
                phi_348_ = _e250;
            } else {
                if (_e250 > 0f) {
                    phi_347_ = bitcast<f32>((_e251 + 1u));
                } else {
                    if (_e250 < 0f) {
                        phi_346_ = bitcast<f32>((_e251 - 1u));
                    } else {
                        phi_346_ = 0.000000000000000000000000000000000000000000001f;
                    }
                    let _e259 = phi_346_;
                    phi_347_ = _e259;
                }
                let _e263 = phi_347_;
                phi_348_ = _e263;
            }
            let _e265 = phi_348_;
            phi_350_ = -(_e265);
        } else {
            phi_350_ = _e247;
        }
        let _e268 = phi_350_;
        local_1[0u] = array<u32, 2>(u32(_e83), u32((_e83 >> bitcast<u64>(32lu))));
        local_1[1u] = array<u32, 2>(u32(_e89), u32((_e89 >> bitcast<u64>(32lu))));
        local_1[2u] = array<u32, 2>(u32(_e95), u32((_e95 >> bitcast<u64>(32lu))));
        local_1[3u] = array<u32, 2>(u32(_e101), u32((_e101 >> bitcast<u64>(32lu))));
        local_1[4u] = array<u32, 2>(u32(_e110), u32((_e110 >> bitcast<u64>(32lu))));
        local_1[5u] = array<u32, 2>(u32(_e118), u32((_e118 >> bitcast<u64>(32lu))));
        local_1[6u] = array<u32, 2>(u32(_e126), u32((_e126 >> bitcast<u64>(32lu))));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e73 < _e81)), select(0u, 1u, (_e73 <= _e81)));
        local_1[8u] = array<u32, 2>(u32(_e200), u32((_e200 >> bitcast<u64>(32lu))));
        local_1[9u] = array<u32, 2>(u32(_e220), u32((_e220 >> bitcast<u64>(32lu))));
        local_1[10u] = array<u32, 2>(u32(_e242), u32((_e242 >> bitcast<u64>(32lu))));
        local_1[11u] = array<u32, 2>(bitcast<u32>(_e268), select(0u, 1u, ((bitcast<u64>(_e73) & 9218868437227405312lu) != 9218868437227405312lu)));
        local = array<u32, 24>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_407_ = type_11(0u, 12u);
        loop {
            let _e299 = phi_407_;
            if (_e299.member < _e299.member_1) {
                phi_408_ = type_11((_e299.member + 1u), _e299.member_1);
                phi_431_ = type_11(1u, _e299.member);
            } else {
                phi_408_ = _e299;
                phi_431_ = type_11(0u, type_11().member_1);
            }
            let _e313 = phi_408_;
            let _e315 = phi_431_;
            let _e319 = (bitcast<i32>(_e315.member) != 0i);
            if _e319 {
                if (_e315.member_1 < 12u) {
                } else {
                    return;
                }
                let _e323 = local_1[_e315.member_1][0u];
                let _e324 = (2u * _e315.member_1);
                if (_e324 < 24u) {
                } else {
                    return;
                }
                local[_e324] = _e323;
                if (_e315.member_1 < 12u) {
                } else {
                    return;
                }
                let _e330 = local_1[_e315.member_1][1u];
                let _e332 = ((2u * _e315.member_1) + 1u);
                if (_e332 < 24u) {
                } else {
                    return;
                }
                local[_e332] = _e330;
            }
            continue;
            continuing {
                phi_407_ = _e313;
                break if !(_e319);
            }
        }
        let _e336 = local;
        out.member[_e62] = array<u32, 24>(_e336[0], _e336[1], _e336[2], _e336[3], _e336[4], _e336[5], _e336[6], _e336[7], _e336[8], _e336[9], _e336[10], _e336[11], _e336[12], _e336[13], _e336[14], _e336[15], _e336[16], _e336[17], _e336[18], _e336[19], _e336[20], _e336[21], _e336[22], _e336[23]);
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
