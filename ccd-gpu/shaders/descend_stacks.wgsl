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

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<u32, 64>,
    member_1: array<u32, 64>,
    member_2: u32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member_18: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(4) 
var<storage, read_write> rounds: type_27;
@group(0) @binding(5) 
var<storage, read_write> output: type_27;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_270_: array<u32, 2>;
    var phi_271_: array<u32, 2>;
    var phi_272_: array<u32, 2>;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_395_: array<u32, 2>;
    var phi_396_: array<u32, 2>;
    var phi_397_: array<u32, 2>;
    var phi_171_: array<u32, 2>;
    var phi_398_: array<u32, 2>;
    var phi_642_: type_9;
    var phi_755_: type_9;
    var phi_814_: array<u32, 2>;
    var phi_955_: type_24;
    var phi_956_: type_24;
    var phi_957_: bool;
    var phi_958_: type_24;
    var phi_959_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1219_: type_24;
    var phi_1220_: bool;
    var phi_1221_: type_24;
    var phi_1222_: bool;
    var phi_1429_: type_24;
    var phi_1430_: type_24;
    var phi_1431_: type_24;
    var phi_1432_: bool;
    var phi_1433_: type_24;
    var phi_1434_: type_24;
    var phi_1435_: bool;
    var phi_1439_: type_24;
    var phi_1550_: type_9;
    var phi_1767_: type_9;
    var phi_1984_: type_9;
    var phi_2201_: type_9;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2313_: type_9;
    var phi_2372_: array<u32, 2>;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e45 = ((((_e29.y * _e30.x) + _e29.x) * 128u) + _e31);
    let _e49 = params.member.member_1.member_1;
    if (_e49 > 0u) {
        let _e164 = params.member.member_1.member_1;
        let _e166 = atomicLoad((&rounds.member[_e164]));
        let _e169 = params.member.member_1.member_2;
        if (_e45 < select(_e166, _e169, (_e169 < _e166))) {
            let _e173 = (2u * _e45);
            let _e176 = input.member[(4u + _e173)];
            let _e179 = input.member[(_e173 + 5u)];
            phi_171_ = array<u32, 2>(_e176, _e179);
        } else {
            phi_171_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e182 = phi_171_;
        phi_398_ = _e182;
    } else {
        let _e53 = params.member.member_2.member_2;
        let _e56 = params.member.member_2.member_2;
        if (_e45 < (_e53 * _e56)) {
            let _e60 = params.member.member_2.member_2;
            if (_e60 == 0u) {
                return;
            }
            let _e62 = (_e45 / _e60);
            let _e64 = params.member.member_2.member_2;
            if (_e64 == 0u) {
                return;
            }
            let _e66 = (_e45 % _e64);
            let _e68 = params.member.member_2.member;
            let _e69 = (_e68 == 1u);
            let _e71 = (select(1u, 0u, _e69) * 1028u);
            let _e73 = input.member[0u];
            if (_e62 < _e73) {
                let _e76 = input.member[_e71];
                if (_e66 < _e76) {
                    if select(true, (_e62 <= _e66), _e69) {
                        let _e82 = input.member[(4u + _e62)];
                        let _e86 = input.member[((_e71 + 4u) + _e66)];
                        phi_270_ = array<u32, 2>(_e82, _e86);
                    } else {
                        phi_270_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e89 = phi_270_;
                    phi_271_ = _e89;
                } else {
                    phi_271_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e91 = phi_271_;
                phi_272_ = _e91;
            } else {
                phi_272_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e93 = phi_272_;
            if (_e93[0] != 4294967295u) {
                let _e98 = params.member.member_2.member;
                if (_e98 == 1u) {
                    if (_e93[0] == _e93[1]) {
                        let _e105 = a_nodes.member[_e93[0]];
                        phi_321_ = (_e105.member_3 == 4294967295u);
                        phi_322_ = false;
                    } else {
                        phi_321_ = bool();
                        phi_322_ = true;
                    }
                    let _e109 = phi_321_;
                    let _e111 = phi_322_;
                    phi_323_ = _e109;
                    phi_324_ = _e111;
                } else {
                    phi_323_ = bool();
                    phi_324_ = true;
                }
                let _e113 = phi_323_;
                let _e115 = phi_324_;
                if select(_e113, false, _e115) {
                    phi_395_ = array<u32, 2>(4294967295u, 4294967295u);
                } else {
                    let _e119 = a_nodes.member[_e93[0]];
                    let _e122 = b_nodes.member[_e93[1]];
                    let _e150 = select(false, true, ((((((_e119.member[0] <= _e122.member_2[0]) && (_e122.member[0] <= _e119.member_2[0])) && (_e119.member[1] <= _e122.member_2[1])) && (_e122.member[1] <= _e119.member_2[1])) && (_e119.member[2] <= _e122.member_2[2])) && (_e122.member[2] <= _e119.member_2[2])));
                    phi_395_ = array<u32, 2>(select(4294967295u, _e93[0], _e150), select(4294967295u, _e93[1], _e150));
                }
                let _e157 = phi_395_;
                phi_396_ = _e157;
            } else {
                phi_396_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e159 = phi_396_;
            phi_397_ = _e159;
        } else {
            phi_397_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e161 = phi_397_;
        phi_398_ = _e161;
    }
    let _e184 = phi_398_;
    local = type_19(array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u);
    let _e187 = params.member.member_2.member;
    let _e188 = (_e187 == 0u);
    let _e194 = params.member.member.member[select(1u, 0u, _e188)];
    let _e199 = params.member.member.member[select(1u, 2u, _e188)];
    let _e210 = select(select(2u, 1u, select(true, select(true, false, (_e184[1] >= (_e199 - 1u))), (_e184[0] >= (_e194 - 1u)))), 0u, (_e184[0] == 4294967295u));
    if (_e210 == 2u) {
        let _e261 = params.member.member_1.member_3;
        let _e264 = a_nodes.member[_e184[0]];
        let _e268 = b_nodes.member[_e184[1]];
        let _e272 = params.member.member_2.member;
        if (_e272 == 1u) {
            let _e275 = (_e264.member_1 < _e268.member_1);
            phi_642_ = type_9(select(_e268.member_1, _e264.member_1, _e275), select(_e264.member_1, _e268.member_1, _e275));
        } else {
            phi_642_ = type_9(_e264.member_1, _e268.member_1);
        }
        let _e280 = phi_642_;
        let _e284 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e284 + 1u) < _e284) {
            let _e288 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e284 < _e261) {
            let _e290 = (2u * _e284);
            atomicStore((&pairs.member[(4u + _e290)]), _e280.member);
            atomicStore((&pairs.member[(_e290 + 5u)]), _e280.member_1);
        }
    } else {
        if (_e210 == 1u) {
            let _e215 = params.member.member_2.member_10;
            let _e217 = local.member_2;
            let _e220 = (_e217 < select(_e215, 64u, (64u < _e215)));
            if _e220 {
                let _e223 = local.member_2;
                local.member[_e223] = _e184[0];
                let _e228 = local.member_2;
                local.member_1[_e228] = _e184[1];
                let _e233 = local.member_2;
                local.member_2 = (_e233 + 1u);
            }
            if _e220 {
            } else {
                let _e237 = params.member.member_1.member_1;
                let _e240 = atomicAdd((&rounds.member[(_e237 + 1u)]), 1u);
                let _e243 = atomicMax((&output.member[0u]), (_e240 + 1u));
                if ((_e240 + 1u) < _e240) {
                    let _e247 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e250 = params.member.member_2.member_3;
                if (_e240 < _e250) {
                    let _e254 = (2u * _e240);
                    atomicStore((&output.member[(4u + _e254)]), _e184[0]);
                    atomicStore((&output.member[(_e254 + 5u)]), _e184[1]);
                }
            }
        }
    }
    let _e297 = params.member.member_2.member_12;
    phi_755_ = type_9(0u, _e297);
    loop {
        let _e300 = phi_755_;
        let _e303 = (_e300.member < _e300.member_1);
        if (bitcast<i32>(select(0u, 1u, _e303)) != 0i) {
            let _e316 = local.member_2;
            if (_e316 > 0u) {
                let _e320 = local.member_2;
                local.member_2 = (_e320 - 1u);
                let _e323 = local.member_2;
                let _e326 = local.member[_e323];
                let _e329 = local.member_1[_e323];
                phi_814_ = array<u32, 2>(_e326, _e329);
            } else {
                phi_814_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e332 = phi_814_;
            if (_e332[0] == 4294967295u) {
                phi_2309_ = false;
            } else {
                let _e337 = params.member.member_2.member_1;
                let _e342 = params.member.member_2.member;
                let _e347 = a_nodes.member[_e332[0]];
                let _e349 = b_nodes.member[_e332[1]];
                if (_e342 == 1u) {
                    if (_e332[0] == _e332[1]) {
                        if (_e347.member_3 == 4294967295u) {
                            phi_955_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e355 = a_nodes.member[_e347.member_1];
                            let _e358 = a_nodes.member[_e347.member_3];
                            let _e361 = !((_e355.member_3 == 4294967295u));
                            let _e372 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e347.member_1, _e361), select(4294967295u, _e347.member_1, _e361)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e384 = type_24(array<array<u32, 2>, 4>(_e372.member[0], array<u32, 2>(_e347.member_1, _e372.member[1][1]), _e372.member[2], _e372.member[3]), _e372.member_1);
                            let _e392 = type_24(array<array<u32, 2>, 4>(_e384.member[0], array<u32, 2>(_e347.member_1, _e347.member_3), _e384.member[2], _e384.member[3]), _e384.member_1);
                            let _e395 = !((_e358.member_3 == 4294967295u));
                            let _e406 = type_24(array<array<u32, 2>, 4>(_e392.member[0], _e392.member[1], array<u32, 2>(select(4294967295u, _e347.member_3, _e395), select(4294967295u, _e347.member_3, _e395)), _e392.member[3]), _e392.member_1);
                            let _e409 = type_24(_e406.member, _e406.member);
                            let _e436 = ((((((_e355.member[0] <= _e358.member_2[0]) && (_e358.member[0] <= _e355.member_2[0])) && (_e355.member[1] <= _e358.member_2[1])) && (_e358.member[1] <= _e355.member_2[1])) && (_e355.member[2] <= _e358.member_2[2])) && (_e358.member[2] <= _e355.member_2[2]));
                            phi_955_ = type_24(_e409.member, array<array<u32, 2>, 4>(_e409.member_1[0], array<u32, 2>(select(4294967295u, _e347.member_1, _e436), select(4294967295u, _e347.member_3, _e436)), _e409.member_1[2], _e409.member_1[3]));
                        }
                        let _e448 = phi_955_;
                        phi_956_ = _e448;
                        phi_957_ = false;
                    } else {
                        phi_956_ = type_24();
                        phi_957_ = true;
                    }
                    let _e450 = phi_956_;
                    let _e452 = phi_957_;
                    phi_958_ = _e450;
                    phi_959_ = _e452;
                } else {
                    phi_958_ = type_24();
                    phi_959_ = true;
                }
                let _e454 = phi_958_;
                let _e456 = phi_959_;
                if _e456 {
                    let _e459 = !((_e347.member_3 == 4294967295u));
                    let _e462 = !((_e349.member_3 == 4294967295u));
                    if select(_e462, true, _e459) {
                        if _e459 {
                            if _e462 {
                                if (select(0u, 1u, (_e337 == 0u)) == 0u) {
                                    let _e491 = ((((_e349.member_2[0] - _e349.member[0]) * (_e349.member_2[1] - _e349.member[1])) * (_e349.member_2[2] - _e349.member[2])) > (((_e347.member_2[0] - _e347.member[0]) * (_e347.member_2[1] - _e347.member[1])) * (_e347.member_2[2] - _e347.member[2])));
                                    phi_1019_ = _e491;
                                    phi_1020_ = !(_e491);
                                } else {
                                    phi_1019_ = _e462;
                                    phi_1020_ = _e459;
                                }
                                let _e494 = phi_1019_;
                                let _e496 = phi_1020_;
                                phi_1021_ = _e494;
                                phi_1022_ = _e496;
                            } else {
                                phi_1021_ = _e462;
                                phi_1022_ = _e459;
                            }
                            let _e498 = phi_1021_;
                            let _e500 = phi_1022_;
                            phi_1023_ = _e498;
                            phi_1024_ = _e500;
                        } else {
                            phi_1023_ = _e462;
                            phi_1024_ = _e459;
                        }
                        let _e502 = phi_1023_;
                        let _e504 = phi_1024_;
                        if _e504 {
                            if _e502 {
                                let _e507 = a_nodes.member[_e347.member_1];
                                let _e512 = a_nodes.member[_e347.member_3];
                                let _e517 = b_nodes.member[_e349.member_1];
                                let _e522 = b_nodes.member[_e349.member_3];
                                let _e560 = ((((((_e507.member[0] <= _e517.member_2[0]) && (_e517.member[0] <= _e507.member_2[0])) && (_e507.member[1] <= _e517.member_2[1])) && (_e517.member[1] <= _e507.member_2[1])) && (_e507.member[2] <= _e517.member_2[2])) && (_e517.member[2] <= _e507.member_2[2]));
                                let _e586 = ((((((_e507.member[0] <= _e522.member_2[0]) && (_e522.member[0] <= _e507.member_2[0])) && (_e507.member[1] <= _e522.member_2[1])) && (_e522.member[1] <= _e507.member_2[1])) && (_e507.member[2] <= _e522.member_2[2])) && (_e522.member[2] <= _e507.member_2[2]));
                                let _e612 = ((((((_e512.member[0] <= _e517.member_2[0]) && (_e517.member[0] <= _e512.member_2[0])) && (_e512.member[1] <= _e517.member_2[1])) && (_e517.member[1] <= _e512.member_2[1])) && (_e512.member[2] <= _e517.member_2[2])) && (_e517.member[2] <= _e512.member_2[2]));
                                let _e638 = ((((((_e512.member[0] <= _e522.member_2[0]) && (_e522.member[0] <= _e512.member_2[0])) && (_e512.member[1] <= _e522.member_2[1])) && (_e522.member[1] <= _e512.member_2[1])) && (_e512.member[2] <= _e522.member_2[2])) && (_e522.member[2] <= _e512.member_2[2]));
                                phi_1219_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e347.member_1, _e349.member_1), array<u32, 2>(_e347.member_1, _e349.member_3), array<u32, 2>(_e347.member_3, _e349.member_1), array<u32, 2>(_e347.member_3, _e349.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e347.member_1, _e560), select(4294967295u, _e349.member_1, _e560)), array<u32, 2>(select(4294967295u, _e347.member_1, _e586), select(4294967295u, _e349.member_3, _e586)), array<u32, 2>(select(4294967295u, _e347.member_3, _e612), select(4294967295u, _e349.member_1, _e612)), array<u32, 2>(select(4294967295u, _e347.member_3, _e638), select(4294967295u, _e349.member_3, _e638))));
                                phi_1220_ = false;
                            } else {
                                phi_1219_ = type_24();
                                phi_1220_ = true;
                            }
                            let _e645 = phi_1219_;
                            let _e647 = phi_1220_;
                            phi_1221_ = _e645;
                            phi_1222_ = _e647;
                        } else {
                            phi_1221_ = type_24();
                            phi_1222_ = true;
                        }
                        let _e649 = phi_1221_;
                        let _e651 = phi_1222_;
                        if _e651 {
                            if _e504 {
                                let _e736 = a_nodes.member[_e347.member_1];
                                let _e741 = a_nodes.member[_e347.member_3];
                                let _e770 = ((((((_e736.member[0] <= _e349.member_2[0]) && (_e349.member[0] <= _e736.member_2[0])) && (_e736.member[1] <= _e349.member_2[1])) && (_e349.member[1] <= _e736.member_2[1])) && (_e736.member[2] <= _e349.member_2[2])) && (_e349.member[2] <= _e736.member_2[2]));
                                let _e780 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e347.member_1, _e770), select(4294967295u, _e332[1], _e770)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e805 = ((((((_e741.member[0] <= _e349.member_2[0]) && (_e349.member[0] <= _e741.member_2[0])) && (_e741.member[1] <= _e349.member_2[1])) && (_e349.member[1] <= _e741.member_2[1])) && (_e741.member[2] <= _e349.member_2[2])) && (_e349.member[2] <= _e741.member_2[2]));
                                phi_1429_ = type_24(_e780.member, array<array<u32, 2>, 4>(_e780.member_1[0], array<u32, 2>(select(4294967295u, _e347.member_3, _e805), select(4294967295u, _e332[1], _e805)), _e780.member_1[2], _e780.member_1[3]));
                            } else {
                                let _e654 = b_nodes.member[_e349.member_1];
                                let _e659 = b_nodes.member[_e349.member_3];
                                let _e688 = ((((((_e347.member[0] <= _e654.member_2[0]) && (_e654.member[0] <= _e347.member_2[0])) && (_e347.member[1] <= _e654.member_2[1])) && (_e654.member[1] <= _e347.member_2[1])) && (_e347.member[2] <= _e654.member_2[2])) && (_e654.member[2] <= _e347.member_2[2]));
                                let _e698 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e332[0], _e688), select(4294967295u, _e349.member_1, _e688)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e723 = ((((((_e347.member[0] <= _e659.member_2[0]) && (_e659.member[0] <= _e347.member_2[0])) && (_e347.member[1] <= _e659.member_2[1])) && (_e659.member[1] <= _e347.member_2[1])) && (_e347.member[2] <= _e659.member_2[2])) && (_e659.member[2] <= _e347.member_2[2]));
                                phi_1429_ = type_24(_e698.member, array<array<u32, 2>, 4>(_e698.member_1[0], array<u32, 2>(select(4294967295u, _e332[0], _e723), select(4294967295u, _e349.member_3, _e723)), _e698.member_1[2], _e698.member_1[3]));
                            }
                            let _e817 = phi_1429_;
                            phi_1430_ = _e817;
                        } else {
                            phi_1430_ = _e649;
                        }
                        let _e819 = phi_1430_;
                        phi_1431_ = _e819;
                        phi_1432_ = false;
                    } else {
                        phi_1431_ = type_24();
                        phi_1432_ = true;
                    }
                    let _e821 = phi_1431_;
                    let _e823 = phi_1432_;
                    phi_1433_ = _e821;
                    phi_1434_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_1435_ = _e823;
                } else {
                    phi_1433_ = type_24();
                    phi_1434_ = _e454;
                    phi_1435_ = true;
                }
                let _e825 = phi_1433_;
                let _e827 = phi_1434_;
                let _e829 = phi_1435_;
                if _e829 {
                    phi_1439_ = _e827;
                } else {
                    phi_1439_ = _e825;
                }
                let _e831 = phi_1439_;
                let _e836 = params.member.member_2.member;
                let _e837 = (_e836 == 0u);
                let _e843 = params.member.member.member[select(1u, 0u, _e837)];
                let _e848 = params.member.member.member[select(1u, 2u, _e837)];
                let _e859 = select(select(2u, 1u, select(true, select(true, false, (_e831.member_1[0][1] >= (_e848 - 1u))), (_e831.member_1[0][0] >= (_e843 - 1u)))), 0u, (_e831.member_1[0][0] == 4294967295u));
                if (_e859 == 2u) {
                    let _e910 = params.member.member_1.member_3;
                    let _e913 = a_nodes.member[_e831.member_1[0][0]];
                    let _e917 = b_nodes.member[_e831.member_1[0][1]];
                    let _e921 = params.member.member_2.member;
                    if (_e921 == 1u) {
                        let _e924 = (_e913.member_1 < _e917.member_1);
                        phi_1550_ = type_9(select(_e917.member_1, _e913.member_1, _e924), select(_e913.member_1, _e917.member_1, _e924));
                    } else {
                        phi_1550_ = type_9(_e913.member_1, _e917.member_1);
                    }
                    let _e929 = phi_1550_;
                    let _e933 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e933 + 1u) < _e933) {
                        let _e937 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e933 < _e910) {
                        let _e939 = (2u * _e933);
                        atomicStore((&pairs.member[(4u + _e939)]), _e929.member);
                        atomicStore((&pairs.member[(_e939 + 5u)]), _e929.member_1);
                    }
                } else {
                    if (_e859 == 1u) {
                        let _e864 = params.member.member_2.member_10;
                        let _e866 = local.member_2;
                        let _e869 = (_e866 < select(_e864, 64u, (64u < _e864)));
                        if _e869 {
                            let _e872 = local.member_2;
                            local.member[_e872] = _e831.member_1[0][0];
                            let _e877 = local.member_2;
                            local.member_1[_e877] = _e831.member_1[0][1];
                            let _e882 = local.member_2;
                            local.member_2 = (_e882 + 1u);
                        }
                        if _e869 {
                        } else {
                            let _e886 = params.member.member_1.member_1;
                            let _e889 = atomicAdd((&rounds.member[(_e886 + 1u)]), 1u);
                            let _e892 = atomicMax((&output.member[0u]), (_e889 + 1u));
                            if ((_e889 + 1u) < _e889) {
                                let _e896 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e899 = params.member.member_2.member_3;
                            if (_e889 < _e899) {
                                let _e903 = (2u * _e889);
                                atomicStore((&output.member[(4u + _e903)]), _e831.member_1[0][0]);
                                atomicStore((&output.member[(_e903 + 5u)]), _e831.member_1[0][1]);
                            }
                        }
                    }
                }
                let _e947 = params.member.member_2.member;
                let _e948 = (_e947 == 0u);
                let _e954 = params.member.member.member[select(1u, 0u, _e948)];
                let _e959 = params.member.member.member[select(1u, 2u, _e948)];
                let _e970 = select(select(2u, 1u, select(true, select(true, false, (_e831.member_1[1][1] >= (_e959 - 1u))), (_e831.member_1[1][0] >= (_e954 - 1u)))), 0u, (_e831.member_1[1][0] == 4294967295u));
                if (_e970 == 2u) {
                    let _e1021 = params.member.member_1.member_3;
                    let _e1024 = a_nodes.member[_e831.member_1[1][0]];
                    let _e1028 = b_nodes.member[_e831.member_1[1][1]];
                    let _e1032 = params.member.member_2.member;
                    if (_e1032 == 1u) {
                        let _e1035 = (_e1024.member_1 < _e1028.member_1);
                        phi_1767_ = type_9(select(_e1028.member_1, _e1024.member_1, _e1035), select(_e1024.member_1, _e1028.member_1, _e1035));
                    } else {
                        phi_1767_ = type_9(_e1024.member_1, _e1028.member_1);
                    }
                    let _e1040 = phi_1767_;
                    let _e1044 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1044 + 1u) < _e1044) {
                        let _e1048 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1044 < _e1021) {
                        let _e1050 = (2u * _e1044);
                        atomicStore((&pairs.member[(4u + _e1050)]), _e1040.member);
                        atomicStore((&pairs.member[(_e1050 + 5u)]), _e1040.member_1);
                    }
                } else {
                    if (_e970 == 1u) {
                        let _e975 = params.member.member_2.member_10;
                        let _e977 = local.member_2;
                        let _e980 = (_e977 < select(_e975, 64u, (64u < _e975)));
                        if _e980 {
                            let _e983 = local.member_2;
                            local.member[_e983] = _e831.member_1[1][0];
                            let _e988 = local.member_2;
                            local.member_1[_e988] = _e831.member_1[1][1];
                            let _e993 = local.member_2;
                            local.member_2 = (_e993 + 1u);
                        }
                        if _e980 {
                        } else {
                            let _e997 = params.member.member_1.member_1;
                            let _e1000 = atomicAdd((&rounds.member[(_e997 + 1u)]), 1u);
                            let _e1003 = atomicMax((&output.member[0u]), (_e1000 + 1u));
                            if ((_e1000 + 1u) < _e1000) {
                                let _e1007 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1010 = params.member.member_2.member_3;
                            if (_e1000 < _e1010) {
                                let _e1014 = (2u * _e1000);
                                atomicStore((&output.member[(4u + _e1014)]), _e831.member_1[1][0]);
                                atomicStore((&output.member[(_e1014 + 5u)]), _e831.member_1[1][1]);
                            }
                        }
                    }
                }
                let _e1058 = params.member.member_2.member;
                let _e1059 = (_e1058 == 0u);
                let _e1065 = params.member.member.member[select(1u, 0u, _e1059)];
                let _e1070 = params.member.member.member[select(1u, 2u, _e1059)];
                let _e1081 = select(select(2u, 1u, select(true, select(true, false, (_e831.member_1[2][1] >= (_e1070 - 1u))), (_e831.member_1[2][0] >= (_e1065 - 1u)))), 0u, (_e831.member_1[2][0] == 4294967295u));
                if (_e1081 == 2u) {
                    let _e1132 = params.member.member_1.member_3;
                    let _e1135 = a_nodes.member[_e831.member_1[2][0]];
                    let _e1139 = b_nodes.member[_e831.member_1[2][1]];
                    let _e1143 = params.member.member_2.member;
                    if (_e1143 == 1u) {
                        let _e1146 = (_e1135.member_1 < _e1139.member_1);
                        phi_1984_ = type_9(select(_e1139.member_1, _e1135.member_1, _e1146), select(_e1135.member_1, _e1139.member_1, _e1146));
                    } else {
                        phi_1984_ = type_9(_e1135.member_1, _e1139.member_1);
                    }
                    let _e1151 = phi_1984_;
                    let _e1155 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1155 + 1u) < _e1155) {
                        let _e1159 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1155 < _e1132) {
                        let _e1161 = (2u * _e1155);
                        atomicStore((&pairs.member[(4u + _e1161)]), _e1151.member);
                        atomicStore((&pairs.member[(_e1161 + 5u)]), _e1151.member_1);
                    }
                } else {
                    if (_e1081 == 1u) {
                        let _e1086 = params.member.member_2.member_10;
                        let _e1088 = local.member_2;
                        let _e1091 = (_e1088 < select(_e1086, 64u, (64u < _e1086)));
                        if _e1091 {
                            let _e1094 = local.member_2;
                            local.member[_e1094] = _e831.member_1[2][0];
                            let _e1099 = local.member_2;
                            local.member_1[_e1099] = _e831.member_1[2][1];
                            let _e1104 = local.member_2;
                            local.member_2 = (_e1104 + 1u);
                        }
                        if _e1091 {
                        } else {
                            let _e1108 = params.member.member_1.member_1;
                            let _e1111 = atomicAdd((&rounds.member[(_e1108 + 1u)]), 1u);
                            let _e1114 = atomicMax((&output.member[0u]), (_e1111 + 1u));
                            if ((_e1111 + 1u) < _e1111) {
                                let _e1118 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1121 = params.member.member_2.member_3;
                            if (_e1111 < _e1121) {
                                let _e1125 = (2u * _e1111);
                                atomicStore((&output.member[(4u + _e1125)]), _e831.member_1[2][0]);
                                atomicStore((&output.member[(_e1125 + 5u)]), _e831.member_1[2][1]);
                            }
                        }
                    }
                }
                let _e1169 = params.member.member_2.member;
                let _e1170 = (_e1169 == 0u);
                let _e1176 = params.member.member.member[select(1u, 0u, _e1170)];
                let _e1181 = params.member.member.member[select(1u, 2u, _e1170)];
                let _e1192 = select(select(2u, 1u, select(true, select(true, false, (_e831.member_1[3][1] >= (_e1181 - 1u))), (_e831.member_1[3][0] >= (_e1176 - 1u)))), 0u, (_e831.member_1[3][0] == 4294967295u));
                if (_e1192 == 2u) {
                    let _e1243 = params.member.member_1.member_3;
                    let _e1246 = a_nodes.member[_e831.member_1[3][0]];
                    let _e1250 = b_nodes.member[_e831.member_1[3][1]];
                    let _e1254 = params.member.member_2.member;
                    if (_e1254 == 1u) {
                        let _e1257 = (_e1246.member_1 < _e1250.member_1);
                        phi_2201_ = type_9(select(_e1250.member_1, _e1246.member_1, _e1257), select(_e1246.member_1, _e1250.member_1, _e1257));
                    } else {
                        phi_2201_ = type_9(_e1246.member_1, _e1250.member_1);
                    }
                    let _e1262 = phi_2201_;
                    let _e1266 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1266 + 1u) < _e1266) {
                        let _e1270 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1266 < _e1243) {
                        let _e1272 = (2u * _e1266);
                        atomicStore((&pairs.member[(4u + _e1272)]), _e1262.member);
                        atomicStore((&pairs.member[(_e1272 + 5u)]), _e1262.member_1);
                    }
                } else {
                    if (_e1192 == 1u) {
                        let _e1197 = params.member.member_2.member_10;
                        let _e1199 = local.member_2;
                        let _e1202 = (_e1199 < select(_e1197, 64u, (64u < _e1197)));
                        if _e1202 {
                            let _e1205 = local.member_2;
                            local.member[_e1205] = _e831.member_1[3][0];
                            let _e1210 = local.member_2;
                            local.member_1[_e1210] = _e831.member_1[3][1];
                            let _e1215 = local.member_2;
                            local.member_2 = (_e1215 + 1u);
                        }
                        if _e1202 {
                        } else {
                            let _e1219 = params.member.member_1.member_1;
                            let _e1222 = atomicAdd((&rounds.member[(_e1219 + 1u)]), 1u);
                            let _e1225 = atomicMax((&output.member[0u]), (_e1222 + 1u));
                            if ((_e1222 + 1u) < _e1222) {
                                let _e1229 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1232 = params.member.member_2.member_3;
                            if (_e1222 < _e1232) {
                                let _e1236 = (2u * _e1222);
                                atomicStore((&output.member[(4u + _e1236)]), _e831.member_1[3][0]);
                                atomicStore((&output.member[(_e1236 + 5u)]), _e831.member_1[3][1]);
                            }
                        }
                    }
                }
                phi_2309_ = true;
            }
            let _e1278 = phi_2309_;
            phi_2310_ = _e1278;
        } else {
            phi_2310_ = false;
        }
        let _e1280 = phi_2310_;
        continue;
        continuing {
            phi_755_ = type_9(select(_e300.member, (_e300.member + 1u), _e303), select(_e300.member_1, _e300.member_1, _e303));
            break if !(_e1280);
        }
    }
    phi_2313_ = type_9(0u, 64u);
    loop {
        let _e1283 = phi_2313_;
        let _e1286 = (_e1283.member < _e1283.member_1);
        if (bitcast<i32>(select(0u, 1u, _e1286)) != 0i) {
            let _e1299 = local.member_2;
            if (_e1299 > 0u) {
                let _e1303 = local.member_2;
                local.member_2 = (_e1303 - 1u);
                let _e1306 = local.member_2;
                let _e1309 = local.member[_e1306];
                let _e1312 = local.member_1[_e1306];
                phi_2372_ = array<u32, 2>(_e1309, _e1312);
            } else {
                phi_2372_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1315 = phi_2372_;
            if (_e1315[0] == 4294967295u) {
                phi_2415_ = false;
            } else {
                let _e1320 = params.member.member_1.member_1;
                let _e1323 = atomicAdd((&rounds.member[(_e1320 + 1u)]), 1u);
                let _e1326 = atomicMax((&output.member[0u]), (_e1323 + 1u));
                if ((_e1323 + 1u) < _e1323) {
                    let _e1330 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1333 = params.member.member_2.member_3;
                if (_e1323 < _e1333) {
                    let _e1337 = (2u * _e1323);
                    atomicStore((&output.member[(4u + _e1337)]), _e1315[0]);
                    atomicStore((&output.member[(_e1337 + 5u)]), _e1315[1]);
                }
                phi_2415_ = true;
            }
            let _e1343 = phi_2415_;
            phi_2416_ = _e1343;
        } else {
            phi_2416_ = false;
        }
        let _e1345 = phi_2416_;
        continue;
        continuing {
            phi_2313_ = type_9(select(_e1283.member, (_e1283.member + 1u), _e1286), select(_e1283.member_1, _e1283.member_1, _e1286));
            break if !(_e1345);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
