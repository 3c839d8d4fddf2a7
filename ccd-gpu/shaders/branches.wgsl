struct type_10 {
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

struct type_12 {
    member: type_10,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_24 {
    member: array<type_21>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> keys: type_16;
@group(0) @binding(2) 
var<storage, read_write> out: type_24;

fn function_() {
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

    let _e17 = id_1;
    let _e18 = n_1;
    let _e19 = lane_1;
    let _e29 = ((((_e17.y * _e18.x) + _e17.x) * 256u) + _e19);
    let _e33 = params.member.member[1u];
    if ((_e29 + 1u) < _e33) {
        let _e37 = params.member.member[1u];
        let _e38 = (_e37 - 1u);
        if (1u < (_e37 - _e29)) {
            let _e41 = (_e29 + 1u);
            let _e43 = keys.member[_e29];
            let _e45 = keys.member[_e41];
            let _e46 = (_e43 ^ _e45);
            let _e51 = select((bitcast<u32>(31i) - firstLeadingBit(_e46)), 32u, (_e46 == 0u));
            if (_e51 < 32u) {
                phi_126_ = _e51;
            } else {
                let _e53 = (_e29 ^ _e41);
                phi_126_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e53)), 32u, (_e53 == 0u)));
            }
            let _e61 = phi_126_;
            phi_128_ = (1u + _e61);
        } else {
            phi_128_ = 0u;
        }
        let _e64 = phi_128_;
        if (1u <= _e29) {
            let _e66 = (_e29 - 1u);
            let _e68 = keys.member[_e29];
            let _e70 = keys.member[_e66];
            let _e71 = (_e68 ^ _e70);
            let _e76 = select((bitcast<u32>(31i) - firstLeadingBit(_e71)), 32u, (_e71 == 0u));
            if (_e76 < 32u) {
                phi_180_ = _e76;
            } else {
                let _e78 = (_e29 ^ _e66);
                phi_180_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e78)), 32u, (_e78 == 0u)));
            }
            let _e86 = phi_180_;
            phi_182_ = (1u + _e86);
        } else {
            phi_182_ = 0u;
        }
        let _e89 = phi_182_;
        let _e90 = (_e64 > _e89);
        if _e90 {
            phi_187_ = _e89;
        } else {
            phi_187_ = _e64;
        }
        let _e92 = phi_187_;
        phi_189_ = 2u;
        loop {
            let _e94 = phi_189_;
            local = _e94;
            if (_e94 < _e37) {
                if _e90 {
                    phi_204_ = (_e94 < (_e37 - _e29));
                } else {
                    phi_204_ = (_e94 <= _e29);
                }
                let _e100 = phi_204_;
                if _e100 {
                    if _e90 {
                        phi_213_ = (_e29 + _e94);
                    } else {
                        phi_213_ = (_e29 - _e94);
                    }
                    let _e104 = phi_213_;
                    let _e106 = keys.member[_e29];
                    let _e108 = keys.member[_e104];
                    let _e109 = (_e106 ^ _e108);
                    let _e114 = select((bitcast<u32>(31i) - firstLeadingBit(_e109)), 32u, (_e109 == 0u));
                    if (_e114 < 32u) {
                        phi_249_ = _e114;
                    } else {
                        let _e116 = (_e29 ^ _e104);
                        phi_249_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e116)), 32u, (_e116 == 0u)));
                    }
                    let _e124 = phi_249_;
                    phi_251_ = (1u + _e124);
                } else {
                    phi_251_ = 0u;
                }
                let _e127 = phi_251_;
                let _e128 = (_e127 > _e92);
                if _e128 {
                    phi_257_ = (_e94 * 2u);
                } else {
                    phi_257_ = u32();
                }
                let _e131 = phi_257_;
                phi_190_ = _e131;
                phi_258_ = _e128;
            } else {
                phi_190_ = u32();
                phi_258_ = false;
            }
            let _e133 = phi_190_;
            let _e135 = phi_258_;
            continue;
            continuing {
                phi_189_ = _e133;
                break if !(_e135);
            }
        }
        let _e138 = local;
        phi_265_ = (_e138 / 2u);
        phi_268_ = 0u;
        loop {
            let _e141 = phi_265_;
            let _e143 = phi_268_;
            local_1 = _e143;
            local_2 = _e143;
            local_3 = _e143;
            local_4 = _e143;
            local_9 = _e143;
            local_5 = _e143;
            local_6 = _e143;
            let _e144 = (_e141 > 0u);
            if _e144 {
                let _e145 = (_e143 + _e141);
                if _e90 {
                    phi_283_ = (_e145 < (_e37 - _e29));
                } else {
                    phi_283_ = (_e145 <= _e29);
                }
                let _e150 = phi_283_;
                if _e150 {
                    if _e90 {
                        phi_292_ = (_e29 + _e145);
                    } else {
                        phi_292_ = (_e29 - _e145);
                    }
                    let _e154 = phi_292_;
                    let _e156 = keys.member[_e29];
                    let _e158 = keys.member[_e154];
                    let _e159 = (_e156 ^ _e158);
                    let _e164 = select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, (_e159 == 0u));
                    if (_e164 < 32u) {
                        phi_328_ = _e164;
                    } else {
                        let _e166 = (_e29 ^ _e154);
                        phi_328_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e166)), 32u, (_e166 == 0u)));
                    }
                    let _e174 = phi_328_;
                    phi_330_ = (1u + _e174);
                } else {
                    phi_330_ = 0u;
                }
                let _e177 = phi_330_;
                if (_e177 > _e92) {
                    phi_336_ = (_e143 + _e141);
                } else {
                    phi_336_ = _e143;
                }
                let _e181 = phi_336_;
                phi_266_ = (_e141 / 2u);
                phi_269_ = _e181;
            } else {
                phi_266_ = u32();
                phi_269_ = u32();
            }
            let _e184 = phi_266_;
            let _e186 = phi_269_;
            continue;
            continuing {
                phi_265_ = _e184;
                phi_268_ = _e186;
                break if !(_e144);
            }
        }
        if _e90 {
            let _e193 = local_2;
            phi_344_ = (_e193 < (_e37 - _e29));
        } else {
            let _e189 = local_1;
            phi_344_ = (_e189 <= _e29);
        }
        let _e196 = phi_344_;
        if _e196 {
            if _e90 {
                let _e201 = local_4;
                phi_353_ = (_e29 + _e201);
            } else {
                let _e198 = local_3;
                phi_353_ = (_e29 - _e198);
            }
            let _e204 = phi_353_;
            let _e206 = keys.member[_e29];
            let _e208 = keys.member[_e204];
            let _e209 = (_e206 ^ _e208);
            let _e214 = select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u));
            if (_e214 < 32u) {
                phi_389_ = _e214;
            } else {
                let _e216 = (_e29 ^ _e204);
                phi_389_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e216)), 32u, (_e216 == 0u)));
            }
            let _e224 = phi_389_;
            phi_391_ = (1u + _e224);
        } else {
            phi_391_ = 0u;
        }
        let _e227 = phi_391_;
        let _e346 = local_9;
        phi_393_ = _e346;
        phi_396_ = 0u;
        loop {
            let _e229 = phi_393_;
            let _e231 = phi_396_;
            local_7 = _e231;
            local_8 = _e231;
            let _e232 = (_e229 > 1u);
            if _e232 {
                let _e233 = (_e229 / 2u);
                if ((_e229 % 2u) > 0u) {
                    phi_419_ = (_e233 + 1u);
                } else {
                    phi_419_ = _e233;
                }
                let _e238 = phi_419_;
                let _e239 = (_e231 + _e238);
                if _e90 {
                    phi_427_ = (_e239 < (_e37 - _e29));
                } else {
                    phi_427_ = (_e239 <= _e29);
                }
                let _e244 = phi_427_;
                if _e244 {
                    if _e90 {
                        phi_436_ = (_e29 + _e239);
                    } else {
                        phi_436_ = (_e29 - _e239);
                    }
                    let _e248 = phi_436_;
                    let _e250 = keys.member[_e29];
                    let _e252 = keys.member[_e248];
                    let _e253 = (_e250 ^ _e252);
                    let _e258 = select((bitcast<u32>(31i) - firstLeadingBit(_e253)), 32u, (_e253 == 0u));
                    if (_e258 < 32u) {
                        phi_472_ = _e258;
                    } else {
                        let _e260 = (_e29 ^ _e248);
                        phi_472_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e260)), 32u, (_e260 == 0u)));
                    }
                    let _e268 = phi_472_;
                    phi_474_ = (1u + _e268);
                } else {
                    phi_474_ = 0u;
                }
                let _e271 = phi_474_;
                if (_e271 > _e227) {
                    phi_480_ = (_e231 + _e238);
                } else {
                    phi_480_ = _e231;
                }
                let _e275 = phi_480_;
                phi_394_ = _e238;
                phi_397_ = _e275;
            } else {
                phi_394_ = u32();
                phi_397_ = u32();
            }
            let _e277 = phi_394_;
            let _e279 = phi_397_;
            continue;
            continuing {
                phi_393_ = _e277;
                phi_396_ = _e279;
                break if !(_e232);
            }
        }
        if _e90 {
            let _e285 = local_6;
            phi_486_ = _e29;
            phi_487_ = (_e29 + _e285);
        } else {
            let _e282 = local_5;
            phi_486_ = (_e29 - _e282);
            phi_487_ = _e29;
        }
        let _e288 = phi_486_;
        let _e290 = phi_487_;
        if _e90 {
            let _e296 = local_8;
            phi_494_ = (_e29 + _e296);
        } else {
            let _e292 = local_7;
            phi_494_ = ((_e29 - _e292) - 1u);
        }
        let _e299 = phi_494_;
        if (_e288 == _e299) {
            phi_500_ = (_e38 + _e299);
        } else {
            phi_500_ = _e299;
        }
        let _e303 = phi_500_;
        if (_e290 == (_e299 + 1u)) {
            phi_509_ = ((_e38 + _e299) + 1u);
        } else {
            phi_509_ = (_e299 + 1u);
        }
        let _e310 = phi_509_;
        out.member[_e29] = type_21(_e303, _e310, _e288, _e290);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
