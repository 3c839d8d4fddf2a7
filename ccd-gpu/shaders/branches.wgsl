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
    var phi_530_: u32;
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
        let _e40 = (_e33 - 1u);
        if (1u < (_e33 - _e26)) {
            let _e43 = (_e26 + 1u);
            let _e46 = keys.member[(_e39 + _e26)];
            let _e49 = keys.member[(_e39 + _e43)];
            let _e50 = (_e46 ^ _e49);
            let _e55 = select((bitcast<u32>(31i) - firstLeadingBit(_e50)), 32u, (_e50 == 0u));
            if (_e55 < 32u) {
                phi_146_ = _e55;
            } else {
                let _e57 = (_e26 ^ _e43);
                phi_146_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e57)), 32u, (_e57 == 0u)));
            }
            let _e65 = phi_146_;
            phi_148_ = (1u + _e65);
        } else {
            phi_148_ = 0u;
        }
        let _e68 = phi_148_;
        if (1u <= _e26) {
            let _e70 = (_e26 - 1u);
            let _e73 = keys.member[(_e39 + _e26)];
            let _e76 = keys.member[(_e39 + _e70)];
            let _e77 = (_e73 ^ _e76);
            let _e82 = select((bitcast<u32>(31i) - firstLeadingBit(_e77)), 32u, (_e77 == 0u));
            if (_e82 < 32u) {
                phi_202_ = _e82;
            } else {
                let _e84 = (_e26 ^ _e70);
                phi_202_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e84)), 32u, (_e84 == 0u)));
            }
            let _e92 = phi_202_;
            phi_204_ = (1u + _e92);
        } else {
            phi_204_ = 0u;
        }
        let _e95 = phi_204_;
        let _e96 = (_e68 > _e95);
        if _e96 {
            phi_209_ = _e95;
        } else {
            phi_209_ = _e68;
        }
        let _e98 = phi_209_;
        phi_211_ = 2u;
        loop {
            let _e100 = phi_211_;
            local = _e100;
            if (_e100 < _e33) {
                if _e96 {
                    phi_226_ = (_e100 < (_e33 - _e26));
                } else {
                    phi_226_ = (_e100 <= _e26);
                }
                let _e106 = phi_226_;
                if _e106 {
                    if _e96 {
                        phi_235_ = (_e26 + _e100);
                    } else {
                        phi_235_ = (_e26 - _e100);
                    }
                    let _e110 = phi_235_;
                    let _e113 = keys.member[(_e39 + _e26)];
                    let _e116 = keys.member[(_e39 + _e110)];
                    let _e117 = (_e113 ^ _e116);
                    let _e122 = select((bitcast<u32>(31i) - firstLeadingBit(_e117)), 32u, (_e117 == 0u));
                    if (_e122 < 32u) {
                        phi_273_ = _e122;
                    } else {
                        let _e124 = (_e26 ^ _e110);
                        phi_273_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e124)), 32u, (_e124 == 0u)));
                    }
                    let _e132 = phi_273_;
                    phi_275_ = (1u + _e132);
                } else {
                    phi_275_ = 0u;
                }
                let _e135 = phi_275_;
                let _e136 = (_e135 > _e98);
                if _e136 {
                    phi_281_ = (_e100 * 2u);
                } else {
                    phi_281_ = u32();
                }
                let _e139 = phi_281_;
                phi_212_ = _e139;
                phi_282_ = _e136;
            } else {
                phi_212_ = u32();
                phi_282_ = false;
            }
            let _e141 = phi_212_;
            let _e143 = phi_282_;
            continue;
            continuing {
                phi_211_ = _e141;
                break if !(_e143);
            }
        }
        let _e146 = local;
        phi_289_ = (_e146 / 2u);
        phi_292_ = 0u;
        loop {
            let _e149 = phi_289_;
            let _e151 = phi_292_;
            local_1 = _e151;
            local_2 = _e151;
            local_3 = _e151;
            local_4 = _e151;
            local_9 = _e151;
            local_5 = _e151;
            local_6 = _e151;
            let _e152 = (_e149 > 0u);
            if _e152 {
                let _e153 = (_e151 + _e149);
                if _e96 {
                    phi_307_ = (_e153 < (_e33 - _e26));
                } else {
                    phi_307_ = (_e153 <= _e26);
                }
                let _e158 = phi_307_;
                if _e158 {
                    if _e96 {
                        phi_316_ = (_e26 + _e153);
                    } else {
                        phi_316_ = (_e26 - _e153);
                    }
                    let _e162 = phi_316_;
                    let _e165 = keys.member[(_e39 + _e26)];
                    let _e168 = keys.member[(_e39 + _e162)];
                    let _e169 = (_e165 ^ _e168);
                    let _e174 = select((bitcast<u32>(31i) - firstLeadingBit(_e169)), 32u, (_e169 == 0u));
                    if (_e174 < 32u) {
                        phi_354_ = _e174;
                    } else {
                        let _e176 = (_e26 ^ _e162);
                        phi_354_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e176)), 32u, (_e176 == 0u)));
                    }
                    let _e184 = phi_354_;
                    phi_356_ = (1u + _e184);
                } else {
                    phi_356_ = 0u;
                }
                let _e187 = phi_356_;
                if (_e187 > _e98) {
                    phi_362_ = (_e151 + _e149);
                } else {
                    phi_362_ = _e151;
                }
                let _e191 = phi_362_;
                phi_290_ = (_e149 / 2u);
                phi_293_ = _e191;
            } else {
                phi_290_ = u32();
                phi_293_ = u32();
            }
            let _e194 = phi_290_;
            let _e196 = phi_293_;
            continue;
            continuing {
                phi_289_ = _e194;
                phi_292_ = _e196;
                break if !(_e152);
            }
        }
        if _e96 {
            let _e203 = local_2;
            phi_370_ = (_e203 < (_e33 - _e26));
        } else {
            let _e199 = local_1;
            phi_370_ = (_e199 <= _e26);
        }
        let _e206 = phi_370_;
        if _e206 {
            if _e96 {
                let _e211 = local_4;
                phi_379_ = (_e26 + _e211);
            } else {
                let _e208 = local_3;
                phi_379_ = (_e26 - _e208);
            }
            let _e214 = phi_379_;
            let _e217 = keys.member[(_e39 + _e26)];
            let _e220 = keys.member[(_e39 + _e214)];
            let _e221 = (_e217 ^ _e220);
            let _e226 = select((bitcast<u32>(31i) - firstLeadingBit(_e221)), 32u, (_e221 == 0u));
            if (_e226 < 32u) {
                phi_417_ = _e226;
            } else {
                let _e228 = (_e26 ^ _e214);
                phi_417_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u)));
            }
            let _e236 = phi_417_;
            phi_419_ = (1u + _e236);
        } else {
            phi_419_ = 0u;
        }
        let _e239 = phi_419_;
        let _e360 = local_9;
        phi_421_ = _e360;
        phi_424_ = 0u;
        loop {
            let _e241 = phi_421_;
            let _e243 = phi_424_;
            local_7 = _e243;
            local_8 = _e243;
            let _e244 = (_e241 > 1u);
            if _e244 {
                let _e245 = (_e241 / 2u);
                if ((_e241 % 2u) > 0u) {
                    phi_447_ = (_e245 + 1u);
                } else {
                    phi_447_ = _e245;
                }
                let _e250 = phi_447_;
                let _e251 = (_e243 + _e250);
                if _e96 {
                    phi_455_ = (_e251 < (_e33 - _e26));
                } else {
                    phi_455_ = (_e251 <= _e26);
                }
                let _e256 = phi_455_;
                if _e256 {
                    if _e96 {
                        phi_464_ = (_e26 + _e251);
                    } else {
                        phi_464_ = (_e26 - _e251);
                    }
                    let _e260 = phi_464_;
                    let _e263 = keys.member[(_e39 + _e26)];
                    let _e266 = keys.member[(_e39 + _e260)];
                    let _e267 = (_e263 ^ _e266);
                    let _e272 = select((bitcast<u32>(31i) - firstLeadingBit(_e267)), 32u, (_e267 == 0u));
                    if (_e272 < 32u) {
                        phi_502_ = _e272;
                    } else {
                        let _e274 = (_e26 ^ _e260);
                        phi_502_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e274)), 32u, (_e274 == 0u)));
                    }
                    let _e282 = phi_502_;
                    phi_504_ = (1u + _e282);
                } else {
                    phi_504_ = 0u;
                }
                let _e285 = phi_504_;
                if (_e285 > _e239) {
                    phi_510_ = (_e243 + _e250);
                } else {
                    phi_510_ = _e243;
                }
                let _e289 = phi_510_;
                phi_422_ = _e250;
                phi_425_ = _e289;
            } else {
                phi_422_ = u32();
                phi_425_ = u32();
            }
            let _e291 = phi_422_;
            let _e293 = phi_425_;
            continue;
            continuing {
                phi_421_ = _e291;
                phi_424_ = _e293;
                break if !(_e244);
            }
        }
        if _e96 {
            let _e299 = local_6;
            phi_516_ = _e26;
            phi_517_ = (_e26 + _e299);
        } else {
            let _e296 = local_5;
            phi_516_ = (_e26 - _e296);
            phi_517_ = _e26;
        }
        let _e302 = phi_516_;
        let _e304 = phi_517_;
        if _e96 {
            let _e310 = local_8;
            phi_524_ = (_e26 + _e310);
        } else {
            let _e306 = local_7;
            phi_524_ = ((_e26 - _e306) - 1u);
        }
        let _e313 = phi_524_;
        if (_e302 == _e313) {
            phi_530_ = (_e40 + _e313);
        } else {
            phi_530_ = _e313;
        }
        let _e317 = phi_530_;
        if (_e304 == (_e313 + 1u)) {
            phi_539_ = ((_e40 + _e313) + 1u);
        } else {
            phi_539_ = (_e313 + 1u);
        }
        let _e324 = phi_539_;
        branches_1.member[_e26] = type_8(_e317, _e324, _e302, _e304);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
