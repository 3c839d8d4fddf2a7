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
    var phi_145_: u32;
    var phi_147_: u32;
    var phi_201_: u32;
    var phi_203_: u32;
    var phi_208_: u32;
    var phi_210_: u32;
    var phi_225_: bool;
    var phi_234_: u32;
    var phi_272_: u32;
    var phi_274_: u32;
    var phi_280_: u32;
    var phi_211_: u32;
    var phi_281_: bool;
    var local: u32;
    var phi_288_: u32;
    var phi_291_: u32;
    var phi_306_: bool;
    var phi_315_: u32;
    var phi_353_: u32;
    var phi_355_: u32;
    var phi_361_: u32;
    var phi_289_: u32;
    var phi_292_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_369_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_378_: u32;
    var phi_416_: u32;
    var phi_418_: u32;
    var phi_420_: u32;
    var phi_423_: u32;
    var phi_446_: u32;
    var phi_454_: bool;
    var phi_463_: u32;
    var phi_501_: u32;
    var phi_503_: u32;
    var phi_509_: u32;
    var phi_421_: u32;
    var phi_424_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_515_: u32;
    var phi_516_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_523_: u32;
    var phi_533_: u32;
    var phi_539_: u32;
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
    let _e29 = params.member.member_2.member_1;
    let _e33 = params.member.member.member[_e29];
    if ((_e26 + 1u) < _e33) {
        let _e39 = params.member.member.member_2[_e29];
        if (1u < (_e33 - _e26)) {
            let _e42 = (_e26 + 1u);
            let _e45 = keys.member[(_e39 + _e26)];
            let _e48 = keys.member[(_e39 + _e42)];
            let _e49 = (_e45 ^ _e48);
            let _e54 = select((bitcast<u32>(31i) - firstLeadingBit(_e49)), 32u, (_e49 == 0u));
            if (_e54 < 32u) {
                phi_145_ = _e54;
            } else {
                let _e56 = (_e26 ^ _e42);
                phi_145_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e56)), 32u, (_e56 == 0u)));
            }
            let _e64 = phi_145_;
            phi_147_ = (1u + _e64);
        } else {
            phi_147_ = 0u;
        }
        let _e67 = phi_147_;
        if (1u <= _e26) {
            let _e69 = (_e26 - 1u);
            let _e72 = keys.member[(_e39 + _e26)];
            let _e75 = keys.member[(_e39 + _e69)];
            let _e76 = (_e72 ^ _e75);
            let _e81 = select((bitcast<u32>(31i) - firstLeadingBit(_e76)), 32u, (_e76 == 0u));
            if (_e81 < 32u) {
                phi_201_ = _e81;
            } else {
                let _e83 = (_e26 ^ _e69);
                phi_201_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e83)), 32u, (_e83 == 0u)));
            }
            let _e91 = phi_201_;
            phi_203_ = (1u + _e91);
        } else {
            phi_203_ = 0u;
        }
        let _e94 = phi_203_;
        let _e95 = (_e67 > _e94);
        if _e95 {
            phi_208_ = _e94;
        } else {
            phi_208_ = _e67;
        }
        let _e97 = phi_208_;
        phi_210_ = 2u;
        loop {
            let _e99 = phi_210_;
            local = _e99;
            if (_e99 < _e33) {
                if _e95 {
                    phi_225_ = (_e99 < (_e33 - _e26));
                } else {
                    phi_225_ = (_e99 <= _e26);
                }
                let _e105 = phi_225_;
                if _e105 {
                    if _e95 {
                        phi_234_ = (_e26 + _e99);
                    } else {
                        phi_234_ = (_e26 - _e99);
                    }
                    let _e109 = phi_234_;
                    let _e112 = keys.member[(_e39 + _e26)];
                    let _e115 = keys.member[(_e39 + _e109)];
                    let _e116 = (_e112 ^ _e115);
                    let _e121 = select((bitcast<u32>(31i) - firstLeadingBit(_e116)), 32u, (_e116 == 0u));
                    if (_e121 < 32u) {
                        phi_272_ = _e121;
                    } else {
                        let _e123 = (_e26 ^ _e109);
                        phi_272_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e123)), 32u, (_e123 == 0u)));
                    }
                    let _e131 = phi_272_;
                    phi_274_ = (1u + _e131);
                } else {
                    phi_274_ = 0u;
                }
                let _e134 = phi_274_;
                let _e135 = (_e134 > _e97);
                if _e135 {
                    phi_280_ = (_e99 * 2u);
                } else {
                    phi_280_ = u32();
                }
                let _e138 = phi_280_;
                phi_211_ = _e138;
                phi_281_ = _e135;
            } else {
                phi_211_ = u32();
                phi_281_ = false;
            }
            let _e140 = phi_211_;
            let _e142 = phi_281_;
            continue;
            continuing {
                phi_210_ = _e140;
                break if !(_e142);
            }
        }
        let _e145 = local;
        phi_288_ = (_e145 / 2u);
        phi_291_ = 0u;
        loop {
            let _e148 = phi_288_;
            let _e150 = phi_291_;
            local_1 = _e150;
            local_2 = _e150;
            local_3 = _e150;
            local_4 = _e150;
            local_9 = _e150;
            local_5 = _e150;
            local_6 = _e150;
            let _e151 = (_e148 > 0u);
            if _e151 {
                let _e152 = (_e150 + _e148);
                if _e95 {
                    phi_306_ = (_e152 < (_e33 - _e26));
                } else {
                    phi_306_ = (_e152 <= _e26);
                }
                let _e157 = phi_306_;
                if _e157 {
                    if _e95 {
                        phi_315_ = (_e26 + _e152);
                    } else {
                        phi_315_ = (_e26 - _e152);
                    }
                    let _e161 = phi_315_;
                    let _e164 = keys.member[(_e39 + _e26)];
                    let _e167 = keys.member[(_e39 + _e161)];
                    let _e168 = (_e164 ^ _e167);
                    let _e173 = select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u));
                    if (_e173 < 32u) {
                        phi_353_ = _e173;
                    } else {
                        let _e175 = (_e26 ^ _e161);
                        phi_353_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e175)), 32u, (_e175 == 0u)));
                    }
                    let _e183 = phi_353_;
                    phi_355_ = (1u + _e183);
                } else {
                    phi_355_ = 0u;
                }
                let _e186 = phi_355_;
                if (_e186 > _e97) {
                    phi_361_ = (_e150 + _e148);
                } else {
                    phi_361_ = _e150;
                }
                let _e190 = phi_361_;
                phi_289_ = (_e148 / 2u);
                phi_292_ = _e190;
            } else {
                phi_289_ = u32();
                phi_292_ = u32();
            }
            let _e193 = phi_289_;
            let _e195 = phi_292_;
            continue;
            continuing {
                phi_288_ = _e193;
                phi_291_ = _e195;
                break if !(_e151);
            }
        }
        if _e95 {
            let _e202 = local_2;
            phi_369_ = (_e202 < (_e33 - _e26));
        } else {
            let _e198 = local_1;
            phi_369_ = (_e198 <= _e26);
        }
        let _e205 = phi_369_;
        if _e205 {
            if _e95 {
                let _e210 = local_4;
                phi_378_ = (_e26 + _e210);
            } else {
                let _e207 = local_3;
                phi_378_ = (_e26 - _e207);
            }
            let _e213 = phi_378_;
            let _e216 = keys.member[(_e39 + _e26)];
            let _e219 = keys.member[(_e39 + _e213)];
            let _e220 = (_e216 ^ _e219);
            let _e225 = select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u));
            if (_e225 < 32u) {
                phi_416_ = _e225;
            } else {
                let _e227 = (_e26 ^ _e213);
                phi_416_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u)));
            }
            let _e235 = phi_416_;
            phi_418_ = (1u + _e235);
        } else {
            phi_418_ = 0u;
        }
        let _e238 = phi_418_;
        let _e358 = local_9;
        phi_420_ = _e358;
        phi_423_ = 0u;
        loop {
            let _e240 = phi_420_;
            let _e242 = phi_423_;
            local_7 = _e242;
            local_8 = _e242;
            let _e243 = (_e240 > 1u);
            if _e243 {
                let _e244 = (_e240 / 2u);
                if ((_e240 % 2u) > 0u) {
                    phi_446_ = (_e244 + 1u);
                } else {
                    phi_446_ = _e244;
                }
                let _e249 = phi_446_;
                let _e250 = (_e242 + _e249);
                if _e95 {
                    phi_454_ = (_e250 < (_e33 - _e26));
                } else {
                    phi_454_ = (_e250 <= _e26);
                }
                let _e255 = phi_454_;
                if _e255 {
                    if _e95 {
                        phi_463_ = (_e26 + _e250);
                    } else {
                        phi_463_ = (_e26 - _e250);
                    }
                    let _e259 = phi_463_;
                    let _e262 = keys.member[(_e39 + _e26)];
                    let _e265 = keys.member[(_e39 + _e259)];
                    let _e266 = (_e262 ^ _e265);
                    let _e271 = select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u));
                    if (_e271 < 32u) {
                        phi_501_ = _e271;
                    } else {
                        let _e273 = (_e26 ^ _e259);
                        phi_501_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e273)), 32u, (_e273 == 0u)));
                    }
                    let _e281 = phi_501_;
                    phi_503_ = (1u + _e281);
                } else {
                    phi_503_ = 0u;
                }
                let _e284 = phi_503_;
                if (_e284 > _e238) {
                    phi_509_ = (_e242 + _e249);
                } else {
                    phi_509_ = _e242;
                }
                let _e288 = phi_509_;
                phi_421_ = _e249;
                phi_424_ = _e288;
            } else {
                phi_421_ = u32();
                phi_424_ = u32();
            }
            let _e290 = phi_421_;
            let _e292 = phi_424_;
            continue;
            continuing {
                phi_420_ = _e290;
                phi_423_ = _e292;
                break if !(_e243);
            }
        }
        if _e95 {
            let _e298 = local_6;
            phi_515_ = _e26;
            phi_516_ = (_e26 + _e298);
        } else {
            let _e295 = local_5;
            phi_515_ = (_e26 - _e295);
            phi_516_ = _e26;
        }
        let _e301 = phi_515_;
        let _e303 = phi_516_;
        if _e95 {
            let _e308 = local_8;
            phi_523_ = ((_e26 + _e308) + 1u);
        } else {
            let _e305 = local_7;
            phi_523_ = (_e26 - _e305);
        }
        let _e312 = phi_523_;
        let _e313 = (_e33 - 1u);
        let _e314 = (_e312 - 1u);
        if (_e301 == _e314) {
            phi_533_ = (_e313 + _e301);
        } else {
            phi_533_ = _e314;
        }
        let _e318 = phi_533_;
        if (_e312 == _e303) {
            phi_539_ = (_e313 + _e312);
        } else {
            phi_539_ = _e312;
        }
        let _e322 = phi_539_;
        branches_1.member[_e26] = type_8(_e318, _e322, _e301, _e303);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
