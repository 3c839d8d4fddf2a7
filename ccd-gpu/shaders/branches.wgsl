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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
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

struct type_19 {
    member: array<vec4<u32>>,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(2) 
var<storage, read_write> branches_1: type_19;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_146_: u32;
    var phi_148_: u32;
    var phi_202_: u32;
    var phi_204_: u32;
    var phi_209_: u32;
    var phi_211_: u32;
    var phi_226_: bool;
    var phi_235_: u32;
    var phi_273_: u32;
    var phi_275_: u32;
    var phi_281_: u32;
    var phi_212_: u32;
    var phi_282_: bool;
    var local: u32;
    var phi_289_: u32;
    var phi_292_: u32;
    var phi_307_: bool;
    var phi_316_: u32;
    var phi_354_: u32;
    var phi_356_: u32;
    var phi_362_: u32;
    var phi_290_: u32;
    var phi_293_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_370_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_379_: u32;
    var phi_417_: u32;
    var phi_419_: u32;
    var phi_421_: u32;
    var phi_424_: u32;
    var phi_447_: u32;
    var phi_455_: bool;
    var phi_464_: u32;
    var phi_502_: u32;
    var phi_504_: u32;
    var phi_510_: u32;
    var phi_422_: u32;
    var phi_425_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_516_: u32;
    var phi_517_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_524_: u32;
    var phi_534_: u32;
    var phi_540_: u32;
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
                phi_146_ = _e54;
            } else {
                let _e56 = (_e26 ^ _e42);
                phi_146_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e56)), 32u, (_e56 == 0u)));
            }
            let _e64 = phi_146_;
            phi_148_ = (1u + _e64);
        } else {
            phi_148_ = 0u;
        }
        let _e67 = phi_148_;
        if (1u <= _e26) {
            let _e69 = (_e26 - 1u);
            let _e72 = keys.member[(_e39 + _e26)];
            let _e75 = keys.member[(_e39 + _e69)];
            let _e76 = (_e72 ^ _e75);
            let _e81 = select((bitcast<u32>(31i) - firstLeadingBit(_e76)), 32u, (_e76 == 0u));
            if (_e81 < 32u) {
                phi_202_ = _e81;
            } else {
                let _e83 = (_e26 ^ _e69);
                phi_202_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e83)), 32u, (_e83 == 0u)));
            }
            let _e91 = phi_202_;
            phi_204_ = (1u + _e91);
        } else {
            phi_204_ = 0u;
        }
        let _e94 = phi_204_;
        let _e95 = (_e67 > _e94);
        if _e95 {
            phi_209_ = _e94;
        } else {
            phi_209_ = _e67;
        }
        let _e97 = phi_209_;
        phi_211_ = 2u;
        loop {
            let _e99 = phi_211_;
            local = _e99;
            if (_e99 < _e33) {
                if _e95 {
                    phi_226_ = (_e99 < (_e33 - _e26));
                } else {
                    phi_226_ = (_e99 <= _e26);
                }
                let _e105 = phi_226_;
                if _e105 {
                    if _e95 {
                        phi_235_ = (_e26 + _e99);
                    } else {
                        phi_235_ = (_e26 - _e99);
                    }
                    let _e109 = phi_235_;
                    let _e112 = keys.member[(_e39 + _e26)];
                    let _e115 = keys.member[(_e39 + _e109)];
                    let _e116 = (_e112 ^ _e115);
                    let _e121 = select((bitcast<u32>(31i) - firstLeadingBit(_e116)), 32u, (_e116 == 0u));
                    if (_e121 < 32u) {
                        phi_273_ = _e121;
                    } else {
                        let _e123 = (_e26 ^ _e109);
                        phi_273_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e123)), 32u, (_e123 == 0u)));
                    }
                    let _e131 = phi_273_;
                    phi_275_ = (1u + _e131);
                } else {
                    phi_275_ = 0u;
                }
                let _e134 = phi_275_;
                let _e135 = (_e134 > _e97);
                if _e135 {
                    phi_281_ = (_e99 * 2u);
                } else {
                    phi_281_ = u32();
                }
                let _e138 = phi_281_;
                phi_212_ = _e138;
                phi_282_ = _e135;
            } else {
                phi_212_ = u32();
                phi_282_ = false;
            }
            let _e140 = phi_212_;
            let _e142 = phi_282_;
            continue;
            continuing {
                phi_211_ = _e140;
                break if !(_e142);
            }
        }
        let _e145 = local;
        phi_289_ = (_e145 / 2u);
        phi_292_ = 0u;
        loop {
            let _e148 = phi_289_;
            let _e150 = phi_292_;
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
                    phi_307_ = (_e152 < (_e33 - _e26));
                } else {
                    phi_307_ = (_e152 <= _e26);
                }
                let _e157 = phi_307_;
                if _e157 {
                    if _e95 {
                        phi_316_ = (_e26 + _e152);
                    } else {
                        phi_316_ = (_e26 - _e152);
                    }
                    let _e161 = phi_316_;
                    let _e164 = keys.member[(_e39 + _e26)];
                    let _e167 = keys.member[(_e39 + _e161)];
                    let _e168 = (_e164 ^ _e167);
                    let _e173 = select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u));
                    if (_e173 < 32u) {
                        phi_354_ = _e173;
                    } else {
                        let _e175 = (_e26 ^ _e161);
                        phi_354_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e175)), 32u, (_e175 == 0u)));
                    }
                    let _e183 = phi_354_;
                    phi_356_ = (1u + _e183);
                } else {
                    phi_356_ = 0u;
                }
                let _e186 = phi_356_;
                if (_e186 > _e97) {
                    phi_362_ = (_e150 + _e148);
                } else {
                    phi_362_ = _e150;
                }
                let _e190 = phi_362_;
                phi_290_ = (_e148 / 2u);
                phi_293_ = _e190;
            } else {
                phi_290_ = u32();
                phi_293_ = u32();
            }
            let _e193 = phi_290_;
            let _e195 = phi_293_;
            continue;
            continuing {
                phi_289_ = _e193;
                phi_292_ = _e195;
                break if !(_e151);
            }
        }
        if _e95 {
            let _e202 = local_2;
            phi_370_ = (_e202 < (_e33 - _e26));
        } else {
            let _e198 = local_1;
            phi_370_ = (_e198 <= _e26);
        }
        let _e205 = phi_370_;
        if _e205 {
            if _e95 {
                let _e210 = local_4;
                phi_379_ = (_e26 + _e210);
            } else {
                let _e207 = local_3;
                phi_379_ = (_e26 - _e207);
            }
            let _e213 = phi_379_;
            let _e216 = keys.member[(_e39 + _e26)];
            let _e219 = keys.member[(_e39 + _e213)];
            let _e220 = (_e216 ^ _e219);
            let _e225 = select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u));
            if (_e225 < 32u) {
                phi_417_ = _e225;
            } else {
                let _e227 = (_e26 ^ _e213);
                phi_417_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u)));
            }
            let _e235 = phi_417_;
            phi_419_ = (1u + _e235);
        } else {
            phi_419_ = 0u;
        }
        let _e238 = phi_419_;
        let _e358 = local_9;
        phi_421_ = _e358;
        phi_424_ = 0u;
        loop {
            let _e240 = phi_421_;
            let _e242 = phi_424_;
            local_7 = _e242;
            local_8 = _e242;
            let _e243 = (_e240 > 1u);
            if _e243 {
                let _e244 = (_e240 / 2u);
                if ((_e240 % 2u) > 0u) {
                    phi_447_ = (_e244 + 1u);
                } else {
                    phi_447_ = _e244;
                }
                let _e249 = phi_447_;
                let _e250 = (_e242 + _e249);
                if _e95 {
                    phi_455_ = (_e250 < (_e33 - _e26));
                } else {
                    phi_455_ = (_e250 <= _e26);
                }
                let _e255 = phi_455_;
                if _e255 {
                    if _e95 {
                        phi_464_ = (_e26 + _e250);
                    } else {
                        phi_464_ = (_e26 - _e250);
                    }
                    let _e259 = phi_464_;
                    let _e262 = keys.member[(_e39 + _e26)];
                    let _e265 = keys.member[(_e39 + _e259)];
                    let _e266 = (_e262 ^ _e265);
                    let _e271 = select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u));
                    if (_e271 < 32u) {
                        phi_502_ = _e271;
                    } else {
                        let _e273 = (_e26 ^ _e259);
                        phi_502_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e273)), 32u, (_e273 == 0u)));
                    }
                    let _e281 = phi_502_;
                    phi_504_ = (1u + _e281);
                } else {
                    phi_504_ = 0u;
                }
                let _e284 = phi_504_;
                if (_e284 > _e238) {
                    phi_510_ = (_e242 + _e249);
                } else {
                    phi_510_ = _e242;
                }
                let _e288 = phi_510_;
                phi_422_ = _e249;
                phi_425_ = _e288;
            } else {
                phi_422_ = u32();
                phi_425_ = u32();
            }
            let _e290 = phi_422_;
            let _e292 = phi_425_;
            continue;
            continuing {
                phi_421_ = _e290;
                phi_424_ = _e292;
                break if !(_e243);
            }
        }
        if _e95 {
            let _e298 = local_6;
            phi_516_ = _e26;
            phi_517_ = (_e26 + _e298);
        } else {
            let _e295 = local_5;
            phi_516_ = (_e26 - _e295);
            phi_517_ = _e26;
        }
        let _e301 = phi_516_;
        let _e303 = phi_517_;
        if _e95 {
            let _e308 = local_8;
            phi_524_ = ((_e26 + _e308) + 1u);
        } else {
            let _e305 = local_7;
            phi_524_ = (_e26 - _e305);
        }
        let _e312 = phi_524_;
        let _e313 = (_e33 - 1u);
        let _e314 = (_e312 - 1u);
        if (_e301 == _e314) {
            phi_534_ = (_e313 + _e301);
        } else {
            phi_534_ = _e314;
        }
        let _e318 = phi_534_;
        if (_e312 == _e303) {
            phi_540_ = (_e313 + _e312);
        } else {
            phi_540_ = _e312;
        }
        let _e322 = phi_540_;
        branches_1.member[_e26] = vec4<u32>(_e318, _e322, _e301, _e303);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
