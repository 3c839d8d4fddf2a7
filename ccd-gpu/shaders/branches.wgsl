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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: array<type_8>,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(2) 
var<storage, read_write> branches_1: type_18;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_78_: array<u32, 2>;
    var phi_154_: u32;
    var phi_156_: u32;
    var phi_210_: u32;
    var phi_212_: u32;
    var phi_217_: u32;
    var phi_219_: u32;
    var phi_234_: bool;
    var phi_243_: u32;
    var phi_281_: u32;
    var phi_283_: u32;
    var phi_289_: u32;
    var phi_220_: u32;
    var phi_290_: bool;
    var local: u32;
    var phi_297_: u32;
    var phi_300_: u32;
    var phi_315_: bool;
    var phi_324_: u32;
    var phi_362_: u32;
    var phi_364_: u32;
    var phi_370_: u32;
    var phi_298_: u32;
    var phi_301_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_378_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_387_: u32;
    var phi_425_: u32;
    var phi_427_: u32;
    var phi_429_: u32;
    var phi_432_: u32;
    var phi_455_: u32;
    var phi_463_: bool;
    var phi_472_: u32;
    var phi_510_: u32;
    var phi_512_: u32;
    var phi_518_: u32;
    var phi_430_: u32;
    var phi_433_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_524_: u32;
    var phi_525_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_532_: u32;
    var phi_538_: u32;
    var phi_547_: u32;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e16 = id_2;
    let _e17 = n_2;
    let _e18 = lane_2;
    let _e28 = ((((_e16.y * _e17.x) + _e16.x) * 256u) + _e18);
    let _e31 = params.member.member_2.member_1;
    if (_e31 == 0u) {
        phi_78_ = array<u32, 2>(0u, 2u);
    } else {
        phi_78_ = array<u32, 2>(1u, 1u);
    }
    let _e34 = phi_78_;
    let _e39 = params.member.member.member[_e34[1]];
    if ((_e28 + 1u) < _e39) {
        let _e45 = params.member.member.member_2[_e34[1]];
        let _e46 = (_e39 - 1u);
        if (1u < (_e39 - _e28)) {
            let _e49 = (_e28 + 1u);
            let _e52 = keys.member[(_e45 + _e28)];
            let _e55 = keys.member[(_e45 + _e49)];
            let _e56 = (_e52 ^ _e55);
            let _e61 = select((bitcast<u32>(31i) - firstLeadingBit(_e56)), 32u, (_e56 == 0u));
            if (_e61 < 32u) {
                phi_154_ = _e61;
            } else {
                let _e63 = (_e28 ^ _e49);
                phi_154_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e63)), 32u, (_e63 == 0u)));
            }
            let _e71 = phi_154_;
            phi_156_ = (1u + _e71);
        } else {
            phi_156_ = 0u;
        }
        let _e74 = phi_156_;
        if (1u <= _e28) {
            let _e76 = (_e28 - 1u);
            let _e79 = keys.member[(_e45 + _e28)];
            let _e82 = keys.member[(_e45 + _e76)];
            let _e83 = (_e79 ^ _e82);
            let _e88 = select((bitcast<u32>(31i) - firstLeadingBit(_e83)), 32u, (_e83 == 0u));
            if (_e88 < 32u) {
                phi_210_ = _e88;
            } else {
                let _e90 = (_e28 ^ _e76);
                phi_210_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u)));
            }
            let _e98 = phi_210_;
            phi_212_ = (1u + _e98);
        } else {
            phi_212_ = 0u;
        }
        let _e101 = phi_212_;
        let _e102 = (_e74 > _e101);
        if _e102 {
            phi_217_ = _e101;
        } else {
            phi_217_ = _e74;
        }
        let _e104 = phi_217_;
        phi_219_ = 2u;
        loop {
            let _e106 = phi_219_;
            local = _e106;
            if (_e106 < _e39) {
                if _e102 {
                    phi_234_ = (_e106 < (_e39 - _e28));
                } else {
                    phi_234_ = (_e106 <= _e28);
                }
                let _e112 = phi_234_;
                if _e112 {
                    if _e102 {
                        phi_243_ = (_e28 + _e106);
                    } else {
                        phi_243_ = (_e28 - _e106);
                    }
                    let _e116 = phi_243_;
                    let _e119 = keys.member[(_e45 + _e28)];
                    let _e122 = keys.member[(_e45 + _e116)];
                    let _e123 = (_e119 ^ _e122);
                    let _e128 = select((bitcast<u32>(31i) - firstLeadingBit(_e123)), 32u, (_e123 == 0u));
                    if (_e128 < 32u) {
                        phi_281_ = _e128;
                    } else {
                        let _e130 = (_e28 ^ _e116);
                        phi_281_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e130)), 32u, (_e130 == 0u)));
                    }
                    let _e138 = phi_281_;
                    phi_283_ = (1u + _e138);
                } else {
                    phi_283_ = 0u;
                }
                let _e141 = phi_283_;
                let _e142 = (_e141 > _e104);
                if _e142 {
                    phi_289_ = (_e106 * 2u);
                } else {
                    phi_289_ = u32();
                }
                let _e145 = phi_289_;
                phi_220_ = _e145;
                phi_290_ = _e142;
            } else {
                phi_220_ = u32();
                phi_290_ = false;
            }
            let _e147 = phi_220_;
            let _e149 = phi_290_;
            continue;
            continuing {
                phi_219_ = _e147;
                break if !(_e149);
            }
        }
        let _e152 = local;
        phi_297_ = (_e152 / 2u);
        phi_300_ = 0u;
        loop {
            let _e155 = phi_297_;
            let _e157 = phi_300_;
            local_1 = _e157;
            local_2 = _e157;
            local_3 = _e157;
            local_4 = _e157;
            local_9 = _e157;
            local_5 = _e157;
            local_6 = _e157;
            let _e158 = (_e155 > 0u);
            if _e158 {
                let _e159 = (_e157 + _e155);
                if _e102 {
                    phi_315_ = (_e159 < (_e39 - _e28));
                } else {
                    phi_315_ = (_e159 <= _e28);
                }
                let _e164 = phi_315_;
                if _e164 {
                    if _e102 {
                        phi_324_ = (_e28 + _e159);
                    } else {
                        phi_324_ = (_e28 - _e159);
                    }
                    let _e168 = phi_324_;
                    let _e171 = keys.member[(_e45 + _e28)];
                    let _e174 = keys.member[(_e45 + _e168)];
                    let _e175 = (_e171 ^ _e174);
                    let _e180 = select((bitcast<u32>(31i) - firstLeadingBit(_e175)), 32u, (_e175 == 0u));
                    if (_e180 < 32u) {
                        phi_362_ = _e180;
                    } else {
                        let _e182 = (_e28 ^ _e168);
                        phi_362_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u)));
                    }
                    let _e190 = phi_362_;
                    phi_364_ = (1u + _e190);
                } else {
                    phi_364_ = 0u;
                }
                let _e193 = phi_364_;
                if (_e193 > _e104) {
                    phi_370_ = (_e157 + _e155);
                } else {
                    phi_370_ = _e157;
                }
                let _e197 = phi_370_;
                phi_298_ = (_e155 / 2u);
                phi_301_ = _e197;
            } else {
                phi_298_ = u32();
                phi_301_ = u32();
            }
            let _e200 = phi_298_;
            let _e202 = phi_301_;
            continue;
            continuing {
                phi_297_ = _e200;
                phi_300_ = _e202;
                break if !(_e158);
            }
        }
        if _e102 {
            let _e209 = local_2;
            phi_378_ = (_e209 < (_e39 - _e28));
        } else {
            let _e205 = local_1;
            phi_378_ = (_e205 <= _e28);
        }
        let _e212 = phi_378_;
        if _e212 {
            if _e102 {
                let _e217 = local_4;
                phi_387_ = (_e28 + _e217);
            } else {
                let _e214 = local_3;
                phi_387_ = (_e28 - _e214);
            }
            let _e220 = phi_387_;
            let _e223 = keys.member[(_e45 + _e28)];
            let _e226 = keys.member[(_e45 + _e220)];
            let _e227 = (_e223 ^ _e226);
            let _e232 = select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u));
            if (_e232 < 32u) {
                phi_425_ = _e232;
            } else {
                let _e234 = (_e28 ^ _e220);
                phi_425_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e234)), 32u, (_e234 == 0u)));
            }
            let _e242 = phi_425_;
            phi_427_ = (1u + _e242);
        } else {
            phi_427_ = 0u;
        }
        let _e245 = phi_427_;
        let _e367 = local_9;
        phi_429_ = _e367;
        phi_432_ = 0u;
        loop {
            let _e247 = phi_429_;
            let _e249 = phi_432_;
            local_7 = _e249;
            local_8 = _e249;
            let _e250 = (_e247 > 1u);
            if _e250 {
                let _e251 = (_e247 / 2u);
                if ((_e247 % 2u) > 0u) {
                    phi_455_ = (_e251 + 1u);
                } else {
                    phi_455_ = _e251;
                }
                let _e256 = phi_455_;
                let _e257 = (_e249 + _e256);
                if _e102 {
                    phi_463_ = (_e257 < (_e39 - _e28));
                } else {
                    phi_463_ = (_e257 <= _e28);
                }
                let _e262 = phi_463_;
                if _e262 {
                    if _e102 {
                        phi_472_ = (_e28 + _e257);
                    } else {
                        phi_472_ = (_e28 - _e257);
                    }
                    let _e266 = phi_472_;
                    let _e269 = keys.member[(_e45 + _e28)];
                    let _e272 = keys.member[(_e45 + _e266)];
                    let _e273 = (_e269 ^ _e272);
                    let _e278 = select((bitcast<u32>(31i) - firstLeadingBit(_e273)), 32u, (_e273 == 0u));
                    if (_e278 < 32u) {
                        phi_510_ = _e278;
                    } else {
                        let _e280 = (_e28 ^ _e266);
                        phi_510_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e280)), 32u, (_e280 == 0u)));
                    }
                    let _e288 = phi_510_;
                    phi_512_ = (1u + _e288);
                } else {
                    phi_512_ = 0u;
                }
                let _e291 = phi_512_;
                if (_e291 > _e245) {
                    phi_518_ = (_e249 + _e256);
                } else {
                    phi_518_ = _e249;
                }
                let _e295 = phi_518_;
                phi_430_ = _e256;
                phi_433_ = _e295;
            } else {
                phi_430_ = u32();
                phi_433_ = u32();
            }
            let _e297 = phi_430_;
            let _e299 = phi_433_;
            continue;
            continuing {
                phi_429_ = _e297;
                phi_432_ = _e299;
                break if !(_e250);
            }
        }
        if _e102 {
            let _e305 = local_6;
            phi_524_ = _e28;
            phi_525_ = (_e28 + _e305);
        } else {
            let _e302 = local_5;
            phi_524_ = (_e28 - _e302);
            phi_525_ = _e28;
        }
        let _e308 = phi_524_;
        let _e310 = phi_525_;
        if _e102 {
            let _e316 = local_8;
            phi_532_ = (_e28 + _e316);
        } else {
            let _e312 = local_7;
            phi_532_ = ((_e28 - _e312) - 1u);
        }
        let _e319 = phi_532_;
        if (_e308 == _e319) {
            phi_538_ = (_e46 + _e319);
        } else {
            phi_538_ = _e319;
        }
        let _e323 = phi_538_;
        if (_e310 == (_e319 + 1u)) {
            phi_547_ = ((_e46 + _e319) + 1u);
        } else {
            phi_547_ = (_e319 + 1u);
        }
        let _e330 = phi_547_;
        branches_1.member[_e28] = type_8(_e323, _e330, _e308, _e310);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
