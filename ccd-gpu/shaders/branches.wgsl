struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> keys: type_11;
@group(0) @binding(2) 
var<storage, read_write> out: type_16;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_126_: u32;
    var phi_128_: u32;
    var phi_180_: u32;
    var phi_182_: u32;
    var phi_187_: u32;
    var phi_189_: u32;
    var phi_204_: bool;
    var phi_213_: u32;
    var phi_249_: u32;
    var phi_251_: u32;
    var phi_257_: u32;
    var phi_190_: u32;
    var phi_258_: bool;
    var local: u32;
    var phi_265_: u32;
    var phi_268_: u32;
    var phi_283_: bool;
    var phi_292_: u32;
    var phi_328_: u32;
    var phi_330_: u32;
    var phi_336_: u32;
    var phi_266_: u32;
    var phi_269_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_344_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_353_: u32;
    var phi_389_: u32;
    var phi_391_: u32;
    var phi_393_: u32;
    var phi_396_: u32;
    var phi_419_: u32;
    var phi_427_: bool;
    var phi_436_: u32;
    var phi_472_: u32;
    var phi_474_: u32;
    var phi_480_: u32;
    var phi_394_: u32;
    var phi_397_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_486_: u32;
    var phi_487_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_494_: u32;
    var phi_500_: u32;
    var phi_509_: u32;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e26 = ((((_e14.y * _e15.x) + _e14.x) * 256u) + _e16);
    let _e30 = params.member.member[1u];
    if ((_e26 + 1u) < _e30) {
        let _e34 = params.member.member[1u];
        let _e35 = (_e34 - 1u);
        if (1u < (_e34 - _e26)) {
            let _e38 = (_e26 + 1u);
            let _e40 = keys.member[_e26];
            let _e42 = keys.member[_e38];
            let _e43 = (_e40 ^ _e42);
            let _e48 = select((bitcast<u32>(31i) - firstLeadingBit(_e43)), 32u, (_e43 == 0u));
            if (_e48 < 32u) {
                phi_126_ = _e48;
            } else {
                let _e50 = (_e26 ^ _e38);
                phi_126_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e50)), 32u, (_e50 == 0u)));
            }
            let _e58 = phi_126_;
            phi_128_ = (1u + _e58);
        } else {
            phi_128_ = 0u;
        }
        let _e61 = phi_128_;
        if (1u <= _e26) {
            let _e63 = (_e26 - 1u);
            let _e65 = keys.member[_e26];
            let _e67 = keys.member[_e63];
            let _e68 = (_e65 ^ _e67);
            let _e73 = select((bitcast<u32>(31i) - firstLeadingBit(_e68)), 32u, (_e68 == 0u));
            if (_e73 < 32u) {
                phi_180_ = _e73;
            } else {
                let _e75 = (_e26 ^ _e63);
                phi_180_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e75)), 32u, (_e75 == 0u)));
            }
            let _e83 = phi_180_;
            phi_182_ = (1u + _e83);
        } else {
            phi_182_ = 0u;
        }
        let _e86 = phi_182_;
        let _e87 = (_e61 > _e86);
        if _e87 {
            phi_187_ = _e86;
        } else {
            phi_187_ = _e61;
        }
        let _e89 = phi_187_;
        phi_189_ = 2u;
        loop {
            let _e91 = phi_189_;
            local = _e91;
            if (_e91 < _e34) {
                if _e87 {
                    phi_204_ = (_e91 < (_e34 - _e26));
                } else {
                    phi_204_ = (_e91 <= _e26);
                }
                let _e97 = phi_204_;
                if _e97 {
                    if _e87 {
                        phi_213_ = (_e26 + _e91);
                    } else {
                        phi_213_ = (_e26 - _e91);
                    }
                    let _e101 = phi_213_;
                    let _e103 = keys.member[_e26];
                    let _e105 = keys.member[_e101];
                    let _e106 = (_e103 ^ _e105);
                    let _e111 = select((bitcast<u32>(31i) - firstLeadingBit(_e106)), 32u, (_e106 == 0u));
                    if (_e111 < 32u) {
                        phi_249_ = _e111;
                    } else {
                        let _e113 = (_e26 ^ _e101);
                        phi_249_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e113)), 32u, (_e113 == 0u)));
                    }
                    let _e121 = phi_249_;
                    phi_251_ = (1u + _e121);
                } else {
                    phi_251_ = 0u;
                }
                let _e124 = phi_251_;
                let _e125 = (_e124 > _e89);
                if _e125 {
                    phi_257_ = (_e91 * 2u);
                } else {
                    phi_257_ = u32();
                }
                let _e128 = phi_257_;
                phi_190_ = _e128;
                phi_258_ = _e125;
            } else {
                phi_190_ = u32();
                phi_258_ = false;
            }
            let _e130 = phi_190_;
            let _e132 = phi_258_;
            continue;
            continuing {
                phi_189_ = _e130;
                break if !(_e132);
            }
        }
        let _e135 = local;
        phi_265_ = (_e135 / 2u);
        phi_268_ = 0u;
        loop {
            let _e138 = phi_265_;
            let _e140 = phi_268_;
            local_1 = _e140;
            local_2 = _e140;
            local_3 = _e140;
            local_4 = _e140;
            local_9 = _e140;
            local_5 = _e140;
            local_6 = _e140;
            let _e141 = (_e138 > 0u);
            if _e141 {
                let _e142 = (_e140 + _e138);
                if _e87 {
                    phi_283_ = (_e142 < (_e34 - _e26));
                } else {
                    phi_283_ = (_e142 <= _e26);
                }
                let _e147 = phi_283_;
                if _e147 {
                    if _e87 {
                        phi_292_ = (_e26 + _e142);
                    } else {
                        phi_292_ = (_e26 - _e142);
                    }
                    let _e151 = phi_292_;
                    let _e153 = keys.member[_e26];
                    let _e155 = keys.member[_e151];
                    let _e156 = (_e153 ^ _e155);
                    let _e161 = select((bitcast<u32>(31i) - firstLeadingBit(_e156)), 32u, (_e156 == 0u));
                    if (_e161 < 32u) {
                        phi_328_ = _e161;
                    } else {
                        let _e163 = (_e26 ^ _e151);
                        phi_328_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u)));
                    }
                    let _e171 = phi_328_;
                    phi_330_ = (1u + _e171);
                } else {
                    phi_330_ = 0u;
                }
                let _e174 = phi_330_;
                if (_e174 > _e89) {
                    phi_336_ = (_e140 + _e138);
                } else {
                    phi_336_ = _e140;
                }
                let _e178 = phi_336_;
                phi_266_ = (_e138 / 2u);
                phi_269_ = _e178;
            } else {
                phi_266_ = u32();
                phi_269_ = u32();
            }
            let _e181 = phi_266_;
            let _e183 = phi_269_;
            continue;
            continuing {
                phi_265_ = _e181;
                phi_268_ = _e183;
                break if !(_e141);
            }
        }
        if _e87 {
            let _e190 = local_2;
            phi_344_ = (_e190 < (_e34 - _e26));
        } else {
            let _e186 = local_1;
            phi_344_ = (_e186 <= _e26);
        }
        let _e193 = phi_344_;
        if _e193 {
            if _e87 {
                let _e198 = local_4;
                phi_353_ = (_e26 + _e198);
            } else {
                let _e195 = local_3;
                phi_353_ = (_e26 - _e195);
            }
            let _e201 = phi_353_;
            let _e203 = keys.member[_e26];
            let _e205 = keys.member[_e201];
            let _e206 = (_e203 ^ _e205);
            let _e211 = select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u));
            if (_e211 < 32u) {
                phi_389_ = _e211;
            } else {
                let _e213 = (_e26 ^ _e201);
                phi_389_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u)));
            }
            let _e221 = phi_389_;
            phi_391_ = (1u + _e221);
        } else {
            phi_391_ = 0u;
        }
        let _e224 = phi_391_;
        let _e343 = local_9;
        phi_393_ = _e343;
        phi_396_ = 0u;
        loop {
            let _e226 = phi_393_;
            let _e228 = phi_396_;
            local_7 = _e228;
            local_8 = _e228;
            let _e229 = (_e226 > 1u);
            if _e229 {
                let _e230 = (_e226 / 2u);
                if ((_e226 % 2u) > 0u) {
                    phi_419_ = (_e230 + 1u);
                } else {
                    phi_419_ = _e230;
                }
                let _e235 = phi_419_;
                let _e236 = (_e228 + _e235);
                if _e87 {
                    phi_427_ = (_e236 < (_e34 - _e26));
                } else {
                    phi_427_ = (_e236 <= _e26);
                }
                let _e241 = phi_427_;
                if _e241 {
                    if _e87 {
                        phi_436_ = (_e26 + _e236);
                    } else {
                        phi_436_ = (_e26 - _e236);
                    }
                    let _e245 = phi_436_;
                    let _e247 = keys.member[_e26];
                    let _e249 = keys.member[_e245];
                    let _e250 = (_e247 ^ _e249);
                    let _e255 = select((bitcast<u32>(31i) - firstLeadingBit(_e250)), 32u, (_e250 == 0u));
                    if (_e255 < 32u) {
                        phi_472_ = _e255;
                    } else {
                        let _e257 = (_e26 ^ _e245);
                        phi_472_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e257)), 32u, (_e257 == 0u)));
                    }
                    let _e265 = phi_472_;
                    phi_474_ = (1u + _e265);
                } else {
                    phi_474_ = 0u;
                }
                let _e268 = phi_474_;
                if (_e268 > _e224) {
                    phi_480_ = (_e228 + _e235);
                } else {
                    phi_480_ = _e228;
                }
                let _e272 = phi_480_;
                phi_394_ = _e235;
                phi_397_ = _e272;
            } else {
                phi_394_ = u32();
                phi_397_ = u32();
            }
            let _e274 = phi_394_;
            let _e276 = phi_397_;
            continue;
            continuing {
                phi_393_ = _e274;
                phi_396_ = _e276;
                break if !(_e229);
            }
        }
        if _e87 {
            let _e282 = local_6;
            phi_486_ = _e26;
            phi_487_ = (_e26 + _e282);
        } else {
            let _e279 = local_5;
            phi_486_ = (_e26 - _e279);
            phi_487_ = _e26;
        }
        let _e285 = phi_486_;
        let _e287 = phi_487_;
        if _e87 {
            let _e293 = local_8;
            phi_494_ = (_e26 + _e293);
        } else {
            let _e289 = local_7;
            phi_494_ = ((_e26 - _e289) - 1u);
        }
        let _e296 = phi_494_;
        if (_e285 == _e296) {
            phi_500_ = (_e35 + _e296);
        } else {
            phi_500_ = _e296;
        }
        let _e300 = phi_500_;
        if (_e287 == (_e296 + 1u)) {
            phi_509_ = ((_e35 + _e296) + 1u);
        } else {
            phi_509_ = (_e296 + 1u);
        }
        let _e307 = phi_509_;
        out.member[_e26] = type_14(_e300, _e307, _e285, _e287);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
