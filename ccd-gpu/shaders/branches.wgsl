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

struct type_15 {
    member: array<vec4<u32>>,
}

struct type_16 {
    member: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage, read_write> branches_1: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_127_: u32;
    var phi_129_: u32;
    var phi_181_: u32;
    var phi_183_: u32;
    var phi_188_: u32;
    var phi_190_: u32;
    var phi_205_: bool;
    var phi_214_: u32;
    var phi_250_: u32;
    var phi_252_: u32;
    var phi_258_: u32;
    var phi_191_: u32;
    var phi_259_: bool;
    var local: u32;
    var phi_266_: u32;
    var phi_269_: u32;
    var phi_284_: bool;
    var phi_293_: u32;
    var phi_329_: u32;
    var phi_331_: u32;
    var phi_337_: u32;
    var phi_267_: u32;
    var phi_270_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_345_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_354_: u32;
    var phi_390_: u32;
    var phi_392_: u32;
    var phi_394_: u32;
    var phi_397_: u32;
    var phi_420_: u32;
    var phi_428_: bool;
    var phi_437_: u32;
    var phi_473_: u32;
    var phi_475_: u32;
    var phi_481_: u32;
    var phi_395_: u32;
    var phi_398_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_487_: u32;
    var phi_488_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_495_: u32;
    var phi_501_: u32;
    var phi_510_: u32;
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
                phi_127_ = _e50;
            } else {
                let _e52 = (_e26 ^ _e40);
                phi_127_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e52)), 32u, (_e52 == 0u)));
            }
            let _e60 = phi_127_;
            phi_129_ = (1u + _e60);
        } else {
            phi_129_ = 0u;
        }
        let _e63 = phi_129_;
        if (1u <= _e26) {
            let _e65 = (_e26 - 1u);
            let _e67 = keys.member[_e26];
            let _e69 = keys.member[_e65];
            let _e70 = (_e67 ^ _e69);
            let _e75 = select((bitcast<u32>(31i) - firstLeadingBit(_e70)), 32u, (_e70 == 0u));
            if (_e75 < 32u) {
                phi_181_ = _e75;
            } else {
                let _e77 = (_e26 ^ _e65);
                phi_181_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e77)), 32u, (_e77 == 0u)));
            }
            let _e85 = phi_181_;
            phi_183_ = (1u + _e85);
        } else {
            phi_183_ = 0u;
        }
        let _e88 = phi_183_;
        let _e89 = (_e63 > _e88);
        if _e89 {
            phi_188_ = _e88;
        } else {
            phi_188_ = _e63;
        }
        let _e91 = phi_188_;
        phi_190_ = 2u;
        loop {
            let _e93 = phi_190_;
            local = _e93;
            if (_e93 < _e36) {
                if _e89 {
                    phi_205_ = (_e93 < (_e36 - _e26));
                } else {
                    phi_205_ = (_e93 <= _e26);
                }
                let _e99 = phi_205_;
                if _e99 {
                    if _e89 {
                        phi_214_ = (_e26 + _e93);
                    } else {
                        phi_214_ = (_e26 - _e93);
                    }
                    let _e103 = phi_214_;
                    let _e105 = keys.member[_e26];
                    let _e107 = keys.member[_e103];
                    let _e108 = (_e105 ^ _e107);
                    let _e113 = select((bitcast<u32>(31i) - firstLeadingBit(_e108)), 32u, (_e108 == 0u));
                    if (_e113 < 32u) {
                        phi_250_ = _e113;
                    } else {
                        let _e115 = (_e26 ^ _e103);
                        phi_250_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e115)), 32u, (_e115 == 0u)));
                    }
                    let _e123 = phi_250_;
                    phi_252_ = (1u + _e123);
                } else {
                    phi_252_ = 0u;
                }
                let _e126 = phi_252_;
                let _e127 = (_e126 > _e91);
                if _e127 {
                    phi_258_ = (_e93 * 2u);
                } else {
                    phi_258_ = u32();
                }
                let _e130 = phi_258_;
                phi_191_ = _e130;
                phi_259_ = _e127;
            } else {
                phi_191_ = u32();
                phi_259_ = false;
            }
            let _e132 = phi_191_;
            let _e134 = phi_259_;
            continue;
            continuing {
                phi_190_ = _e132;
                break if !(_e134);
            }
        }
        let _e137 = local;
        phi_266_ = (_e137 / 2u);
        phi_269_ = 0u;
        loop {
            let _e140 = phi_266_;
            let _e142 = phi_269_;
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
                    phi_284_ = (_e144 < (_e36 - _e26));
                } else {
                    phi_284_ = (_e144 <= _e26);
                }
                let _e149 = phi_284_;
                if _e149 {
                    if _e89 {
                        phi_293_ = (_e26 + _e144);
                    } else {
                        phi_293_ = (_e26 - _e144);
                    }
                    let _e153 = phi_293_;
                    let _e155 = keys.member[_e26];
                    let _e157 = keys.member[_e153];
                    let _e158 = (_e155 ^ _e157);
                    let _e163 = select((bitcast<u32>(31i) - firstLeadingBit(_e158)), 32u, (_e158 == 0u));
                    if (_e163 < 32u) {
                        phi_329_ = _e163;
                    } else {
                        let _e165 = (_e26 ^ _e153);
                        phi_329_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e165)), 32u, (_e165 == 0u)));
                    }
                    let _e173 = phi_329_;
                    phi_331_ = (1u + _e173);
                } else {
                    phi_331_ = 0u;
                }
                let _e176 = phi_331_;
                if (_e176 > _e91) {
                    phi_337_ = (_e142 + _e140);
                } else {
                    phi_337_ = _e142;
                }
                let _e180 = phi_337_;
                phi_267_ = (_e140 / 2u);
                phi_270_ = _e180;
            } else {
                phi_267_ = u32();
                phi_270_ = u32();
            }
            let _e183 = phi_267_;
            let _e185 = phi_270_;
            continue;
            continuing {
                phi_266_ = _e183;
                phi_269_ = _e185;
                break if !(_e143);
            }
        }
        if _e89 {
            let _e192 = local_2;
            phi_345_ = (_e192 < (_e36 - _e26));
        } else {
            let _e188 = local_1;
            phi_345_ = (_e188 <= _e26);
        }
        let _e195 = phi_345_;
        if _e195 {
            if _e89 {
                let _e200 = local_4;
                phi_354_ = (_e26 + _e200);
            } else {
                let _e197 = local_3;
                phi_354_ = (_e26 - _e197);
            }
            let _e203 = phi_354_;
            let _e205 = keys.member[_e26];
            let _e207 = keys.member[_e203];
            let _e208 = (_e205 ^ _e207);
            let _e213 = select((bitcast<u32>(31i) - firstLeadingBit(_e208)), 32u, (_e208 == 0u));
            if (_e213 < 32u) {
                phi_390_ = _e213;
            } else {
                let _e215 = (_e26 ^ _e203);
                phi_390_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u)));
            }
            let _e223 = phi_390_;
            phi_392_ = (1u + _e223);
        } else {
            phi_392_ = 0u;
        }
        let _e226 = phi_392_;
        let _e345 = local_9;
        phi_394_ = _e345;
        phi_397_ = 0u;
        loop {
            let _e228 = phi_394_;
            let _e230 = phi_397_;
            local_7 = _e230;
            local_8 = _e230;
            let _e231 = (_e228 > 1u);
            if _e231 {
                let _e232 = (_e228 / 2u);
                if ((_e228 % 2u) > 0u) {
                    phi_420_ = (_e232 + 1u);
                } else {
                    phi_420_ = _e232;
                }
                let _e237 = phi_420_;
                let _e238 = (_e230 + _e237);
                if _e89 {
                    phi_428_ = (_e238 < (_e36 - _e26));
                } else {
                    phi_428_ = (_e238 <= _e26);
                }
                let _e243 = phi_428_;
                if _e243 {
                    if _e89 {
                        phi_437_ = (_e26 + _e238);
                    } else {
                        phi_437_ = (_e26 - _e238);
                    }
                    let _e247 = phi_437_;
                    let _e249 = keys.member[_e26];
                    let _e251 = keys.member[_e247];
                    let _e252 = (_e249 ^ _e251);
                    let _e257 = select((bitcast<u32>(31i) - firstLeadingBit(_e252)), 32u, (_e252 == 0u));
                    if (_e257 < 32u) {
                        phi_473_ = _e257;
                    } else {
                        let _e259 = (_e26 ^ _e247);
                        phi_473_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e259)), 32u, (_e259 == 0u)));
                    }
                    let _e267 = phi_473_;
                    phi_475_ = (1u + _e267);
                } else {
                    phi_475_ = 0u;
                }
                let _e270 = phi_475_;
                if (_e270 > _e226) {
                    phi_481_ = (_e230 + _e237);
                } else {
                    phi_481_ = _e230;
                }
                let _e274 = phi_481_;
                phi_395_ = _e237;
                phi_398_ = _e274;
            } else {
                phi_395_ = u32();
                phi_398_ = u32();
            }
            let _e276 = phi_395_;
            let _e278 = phi_398_;
            continue;
            continuing {
                phi_394_ = _e276;
                phi_397_ = _e278;
                break if !(_e231);
            }
        }
        if _e89 {
            let _e284 = local_6;
            phi_487_ = _e26;
            phi_488_ = (_e26 + _e284);
        } else {
            let _e281 = local_5;
            phi_487_ = (_e26 - _e281);
            phi_488_ = _e26;
        }
        let _e287 = phi_487_;
        let _e289 = phi_488_;
        if _e89 {
            let _e295 = local_8;
            phi_495_ = (_e26 + _e295);
        } else {
            let _e291 = local_7;
            phi_495_ = ((_e26 - _e291) - 1u);
        }
        let _e298 = phi_495_;
        if (_e287 == _e298) {
            phi_501_ = (_e37 + _e298);
        } else {
            phi_501_ = _e298;
        }
        let _e302 = phi_501_;
        if (_e289 == (_e298 + 1u)) {
            phi_510_ = ((_e37 + _e298) + 1u);
        } else {
            phi_510_ = (_e298 + 1u);
        }
        let _e309 = phi_510_;
        branches_1.member[_e26] = vec4<u32>(_e302, _e309, _e287, _e289);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
