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
}

struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_14 {
    member: array<type_8>,
}

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(2) 
var<storage, read_write> branches_1: type_14;

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
    let _e31 = params.member.member.member[1u];
    if ((_e26 + 1u) < _e31) {
        let _e36 = params.member.member.member[1u];
        let _e37 = (_e36 - 1u);
        if (1u < (_e36 - _e26)) {
            let _e40 = (_e26 + 1u);
            let _e42 = keys.member[_e26];
            let _e44 = keys.member[_e40];
            let _e45 = (_e42 ^ _e44);
            let _e50 = select((bitcast<u32>(31i) - firstLeadingBit(_e45)), 32u, (_e45 == 0u));
            if (_e50 < 32u) {
                phi_126_ = _e50;
            } else {
                let _e52 = (_e26 ^ _e40);
                phi_126_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e52)), 32u, (_e52 == 0u)));
            }
            let _e60 = phi_126_;
            phi_128_ = (1u + _e60);
        } else {
            phi_128_ = 0u;
        }
        let _e63 = phi_128_;
        if (1u <= _e26) {
            let _e65 = (_e26 - 1u);
            let _e67 = keys.member[_e26];
            let _e69 = keys.member[_e65];
            let _e70 = (_e67 ^ _e69);
            let _e75 = select((bitcast<u32>(31i) - firstLeadingBit(_e70)), 32u, (_e70 == 0u));
            if (_e75 < 32u) {
                phi_180_ = _e75;
            } else {
                let _e77 = (_e26 ^ _e65);
                phi_180_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e77)), 32u, (_e77 == 0u)));
            }
            let _e85 = phi_180_;
            phi_182_ = (1u + _e85);
        } else {
            phi_182_ = 0u;
        }
        let _e88 = phi_182_;
        let _e89 = (_e63 > _e88);
        if _e89 {
            phi_187_ = _e88;
        } else {
            phi_187_ = _e63;
        }
        let _e91 = phi_187_;
        phi_189_ = 2u;
        loop {
            let _e93 = phi_189_;
            local = _e93;
            if (_e93 < _e36) {
                if _e89 {
                    phi_204_ = (_e93 < (_e36 - _e26));
                } else {
                    phi_204_ = (_e93 <= _e26);
                }
                let _e99 = phi_204_;
                if _e99 {
                    if _e89 {
                        phi_213_ = (_e26 + _e93);
                    } else {
                        phi_213_ = (_e26 - _e93);
                    }
                    let _e103 = phi_213_;
                    let _e105 = keys.member[_e26];
                    let _e107 = keys.member[_e103];
                    let _e108 = (_e105 ^ _e107);
                    let _e113 = select((bitcast<u32>(31i) - firstLeadingBit(_e108)), 32u, (_e108 == 0u));
                    if (_e113 < 32u) {
                        phi_249_ = _e113;
                    } else {
                        let _e115 = (_e26 ^ _e103);
                        phi_249_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e115)), 32u, (_e115 == 0u)));
                    }
                    let _e123 = phi_249_;
                    phi_251_ = (1u + _e123);
                } else {
                    phi_251_ = 0u;
                }
                let _e126 = phi_251_;
                let _e127 = (_e126 > _e91);
                if _e127 {
                    phi_257_ = (_e93 * 2u);
                } else {
                    phi_257_ = u32();
                }
                let _e130 = phi_257_;
                phi_190_ = _e130;
                phi_258_ = _e127;
            } else {
                phi_190_ = u32();
                phi_258_ = false;
            }
            let _e132 = phi_190_;
            let _e134 = phi_258_;
            continue;
            continuing {
                phi_189_ = _e132;
                break if !(_e134);
            }
        }
        let _e137 = local;
        phi_265_ = (_e137 / 2u);
        phi_268_ = 0u;
        loop {
            let _e140 = phi_265_;
            let _e142 = phi_268_;
            local_1 = _e142;
            local_2 = _e142;
            local_3 = _e142;
            local_4 = _e142;
            local_9 = _e142;
            local_5 = _e142;
            local_6 = _e142;
            let _e143 = (_e140 > 0u);
            if _e143 {
                let _e144 = (_e142 + _e140);
                if _e89 {
                    phi_283_ = (_e144 < (_e36 - _e26));
                } else {
                    phi_283_ = (_e144 <= _e26);
                }
                let _e149 = phi_283_;
                if _e149 {
                    if _e89 {
                        phi_292_ = (_e26 + _e144);
                    } else {
                        phi_292_ = (_e26 - _e144);
                    }
                    let _e153 = phi_292_;
                    let _e155 = keys.member[_e26];
                    let _e157 = keys.member[_e153];
                    let _e158 = (_e155 ^ _e157);
                    let _e163 = select((bitcast<u32>(31i) - firstLeadingBit(_e158)), 32u, (_e158 == 0u));
                    if (_e163 < 32u) {
                        phi_328_ = _e163;
                    } else {
                        let _e165 = (_e26 ^ _e153);
                        phi_328_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e165)), 32u, (_e165 == 0u)));
                    }
                    let _e173 = phi_328_;
                    phi_330_ = (1u + _e173);
                } else {
                    phi_330_ = 0u;
                }
                let _e176 = phi_330_;
                if (_e176 > _e91) {
                    phi_336_ = (_e142 + _e140);
                } else {
                    phi_336_ = _e142;
                }
                let _e180 = phi_336_;
                phi_266_ = (_e140 / 2u);
                phi_269_ = _e180;
            } else {
                phi_266_ = u32();
                phi_269_ = u32();
            }
            let _e183 = phi_266_;
            let _e185 = phi_269_;
            continue;
            continuing {
                phi_265_ = _e183;
                phi_268_ = _e185;
                break if !(_e143);
            }
        }
        if _e89 {
            let _e192 = local_2;
            phi_344_ = (_e192 < (_e36 - _e26));
        } else {
            let _e188 = local_1;
            phi_344_ = (_e188 <= _e26);
        }
        let _e195 = phi_344_;
        if _e195 {
            if _e89 {
                let _e200 = local_4;
                phi_353_ = (_e26 + _e200);
            } else {
                let _e197 = local_3;
                phi_353_ = (_e26 - _e197);
            }
            let _e203 = phi_353_;
            let _e205 = keys.member[_e26];
            let _e207 = keys.member[_e203];
            let _e208 = (_e205 ^ _e207);
            let _e213 = select((bitcast<u32>(31i) - firstLeadingBit(_e208)), 32u, (_e208 == 0u));
            if (_e213 < 32u) {
                phi_389_ = _e213;
            } else {
                let _e215 = (_e26 ^ _e203);
                phi_389_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u)));
            }
            let _e223 = phi_389_;
            phi_391_ = (1u + _e223);
        } else {
            phi_391_ = 0u;
        }
        let _e226 = phi_391_;
        let _e345 = local_9;
        phi_393_ = _e345;
        phi_396_ = 0u;
        loop {
            let _e228 = phi_393_;
            let _e230 = phi_396_;
            local_7 = _e230;
            local_8 = _e230;
            let _e231 = (_e228 > 1u);
            if _e231 {
                let _e232 = (_e228 / 2u);
                if ((_e228 % 2u) > 0u) {
                    phi_419_ = (_e232 + 1u);
                } else {
                    phi_419_ = _e232;
                }
                let _e237 = phi_419_;
                let _e238 = (_e230 + _e237);
                if _e89 {
                    phi_427_ = (_e238 < (_e36 - _e26));
                } else {
                    phi_427_ = (_e238 <= _e26);
                }
                let _e243 = phi_427_;
                if _e243 {
                    if _e89 {
                        phi_436_ = (_e26 + _e238);
                    } else {
                        phi_436_ = (_e26 - _e238);
                    }
                    let _e247 = phi_436_;
                    let _e249 = keys.member[_e26];
                    let _e251 = keys.member[_e247];
                    let _e252 = (_e249 ^ _e251);
                    let _e257 = select((bitcast<u32>(31i) - firstLeadingBit(_e252)), 32u, (_e252 == 0u));
                    if (_e257 < 32u) {
                        phi_472_ = _e257;
                    } else {
                        let _e259 = (_e26 ^ _e247);
                        phi_472_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e259)), 32u, (_e259 == 0u)));
                    }
                    let _e267 = phi_472_;
                    phi_474_ = (1u + _e267);
                } else {
                    phi_474_ = 0u;
                }
                let _e270 = phi_474_;
                if (_e270 > _e226) {
                    phi_480_ = (_e230 + _e237);
                } else {
                    phi_480_ = _e230;
                }
                let _e274 = phi_480_;
                phi_394_ = _e237;
                phi_397_ = _e274;
            } else {
                phi_394_ = u32();
                phi_397_ = u32();
            }
            let _e276 = phi_394_;
            let _e278 = phi_397_;
            continue;
            continuing {
                phi_393_ = _e276;
                phi_396_ = _e278;
                break if !(_e231);
            }
        }
        if _e89 {
            let _e284 = local_6;
            phi_486_ = _e26;
            phi_487_ = (_e26 + _e284);
        } else {
            let _e281 = local_5;
            phi_486_ = (_e26 - _e281);
            phi_487_ = _e26;
        }
        let _e287 = phi_486_;
        let _e289 = phi_487_;
        if _e89 {
            let _e295 = local_8;
            phi_494_ = (_e26 + _e295);
        } else {
            let _e291 = local_7;
            phi_494_ = ((_e26 - _e291) - 1u);
        }
        let _e298 = phi_494_;
        if (_e287 == _e298) {
            phi_500_ = (_e37 + _e298);
        } else {
            phi_500_ = _e298;
        }
        let _e302 = phi_500_;
        if (_e289 == (_e298 + 1u)) {
            phi_509_ = ((_e37 + _e298) + 1u);
        } else {
            phi_509_ = (_e298 + 1u);
        }
        let _e309 = phi_509_;
        branches_1.member[_e26] = type_8(_e302, _e309, _e287, _e289);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
