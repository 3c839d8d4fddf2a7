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
    member_1: u32,
}

struct type_20 {
    member: type_19,
    member_1: type_19,
}

struct type_21 {
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

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(4) 
var<storage, read_write> rounds: type_28;
@group(0) @binding(5) 
var<storage, read_write> output: type_28;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_28;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_274_: array<u32, 2>;
    var phi_275_: array<u32, 2>;
    var phi_276_: array<u32, 2>;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_399_: array<u32, 2>;
    var phi_400_: array<u32, 2>;
    var phi_401_: array<u32, 2>;
    var phi_175_: array<u32, 2>;
    var phi_402_: array<u32, 2>;
    var phi_655_: type_9;
    var phi_776_: type_9;
    var phi_843_: array<u32, 2>;
    var phi_984_: type_25;
    var phi_985_: type_25;
    var phi_986_: bool;
    var phi_987_: type_25;
    var phi_988_: bool;
    var phi_1048_: bool;
    var phi_1049_: bool;
    var phi_1050_: bool;
    var phi_1051_: bool;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1248_: type_25;
    var phi_1249_: bool;
    var phi_1250_: type_25;
    var phi_1251_: bool;
    var phi_1458_: type_25;
    var phi_1459_: type_25;
    var phi_1460_: type_25;
    var phi_1461_: bool;
    var phi_1462_: type_25;
    var phi_1463_: type_25;
    var phi_1464_: bool;
    var phi_1468_: type_25;
    var phi_1579_: type_9;
    var phi_1804_: type_9;
    var phi_2029_: type_9;
    var phi_2254_: type_9;
    var phi_2370_: bool;
    var phi_2371_: bool;
    var phi_2374_: type_9;
    var phi_2441_: array<u32, 2>;
    var phi_2484_: bool;
    var phi_2485_: bool;
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
            phi_175_ = array<u32, 2>(_e176, _e179);
        } else {
            phi_175_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e182 = phi_175_;
        phi_402_ = _e182;
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
                        phi_274_ = array<u32, 2>(_e82, _e86);
                    } else {
                        phi_274_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e89 = phi_274_;
                    phi_275_ = _e89;
                } else {
                    phi_275_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e91 = phi_275_;
                phi_276_ = _e91;
            } else {
                phi_276_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e93 = phi_276_;
            if (_e93[0] != 4294967295u) {
                let _e98 = params.member.member_2.member;
                if (_e98 == 1u) {
                    if (_e93[0] == _e93[1]) {
                        let _e105 = a_nodes.member[_e93[0]];
                        phi_325_ = (_e105.member_3 == 4294967295u);
                        phi_326_ = false;
                    } else {
                        phi_325_ = bool();
                        phi_326_ = true;
                    }
                    let _e109 = phi_325_;
                    let _e111 = phi_326_;
                    phi_327_ = _e109;
                    phi_328_ = _e111;
                } else {
                    phi_327_ = bool();
                    phi_328_ = true;
                }
                let _e113 = phi_327_;
                let _e115 = phi_328_;
                if select(_e113, false, _e115) {
                    phi_399_ = array<u32, 2>(4294967295u, 4294967295u);
                } else {
                    let _e119 = a_nodes.member[_e93[0]];
                    let _e122 = b_nodes.member[_e93[1]];
                    let _e150 = select(false, true, ((((((_e119.member[0] <= _e122.member_2[0]) && (_e122.member[0] <= _e119.member_2[0])) && (_e119.member[1] <= _e122.member_2[1])) && (_e122.member[1] <= _e119.member_2[1])) && (_e119.member[2] <= _e122.member_2[2])) && (_e122.member[2] <= _e119.member_2[2])));
                    phi_399_ = array<u32, 2>(select(4294967295u, _e93[0], _e150), select(4294967295u, _e93[1], _e150));
                }
                let _e157 = phi_399_;
                phi_400_ = _e157;
            } else {
                phi_400_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e159 = phi_400_;
            phi_401_ = _e159;
        } else {
            phi_401_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e161 = phi_401_;
        phi_402_ = _e161;
    }
    let _e184 = phi_402_;
    local = type_20(type_19(array<u32, 64>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), type_19(array<u32, 64>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u));
    let _e192 = params.member.member_2.member;
    let _e193 = (_e192 == 0u);
    let _e199 = params.member.member.member[select(1u, 0u, _e193)];
    let _e204 = params.member.member.member[select(1u, 2u, _e193)];
    let _e215 = select(select(2u, 1u, select(true, select(true, false, (_e184[1] >= (_e204 - 1u))), (_e184[0] >= (_e199 - 1u)))), 0u, (_e184[0] == 4294967295u));
    if (_e215 == 2u) {
        let _e275 = params.member.member_1.member_3;
        let _e278 = a_nodes.member[_e184[0]];
        let _e282 = b_nodes.member[_e184[1]];
        let _e286 = params.member.member_2.member;
        if (_e286 == 1u) {
            let _e289 = (_e278.member_1 < _e282.member_1);
            phi_655_ = type_9(select(_e282.member_1, _e278.member_1, _e289), select(_e278.member_1, _e282.member_1, _e289));
        } else {
            phi_655_ = type_9(_e278.member_1, _e282.member_1);
        }
        let _e294 = phi_655_;
        let _e298 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e298 + 1u) < _e298) {
            let _e302 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e298 < _e275) {
            let _e304 = (2u * _e298);
            atomicStore((&pairs.member[(4u + _e304)]), _e294.member);
            atomicStore((&pairs.member[(_e304 + 5u)]), _e294.member_1);
        }
    } else {
        if (_e215 == 1u) {
            let _e220 = params.member.member_2.member_10;
            let _e223 = local.member.member_1;
            let _e226 = (_e223 < select(_e220, 64u, (64u < _e220)));
            if _e226 {
                let _e229 = function_(_e184[0]);
                let _e231 = local.member.member_1;
                local.member.member[_e231] = _e229;
                let _e236 = local.member.member_1;
                local.member.member_1 = (_e236 + 1u);
                let _e240 = function_(_e184[1]);
                let _e242 = local.member_1.member_1;
                local.member_1.member[_e242] = _e240;
                let _e247 = local.member_1.member_1;
                local.member_1.member_1 = (_e247 + 1u);
            }
            if _e226 {
            } else {
                let _e251 = params.member.member_1.member_1;
                let _e254 = atomicAdd((&rounds.member[(_e251 + 1u)]), 1u);
                let _e257 = atomicMax((&output.member[0u]), (_e254 + 1u));
                if ((_e254 + 1u) < _e254) {
                    let _e261 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e264 = params.member.member_2.member_3;
                if (_e254 < _e264) {
                    let _e268 = (2u * _e254);
                    atomicStore((&output.member[(4u + _e268)]), _e184[0]);
                    atomicStore((&output.member[(_e268 + 5u)]), _e184[1]);
                }
            }
        }
    }
    let _e311 = params.member.member_2.member_12;
    phi_776_ = type_9(0u, _e311);
    loop {
        let _e314 = phi_776_;
        let _e317 = (_e314.member < _e314.member_1);
        if (bitcast<i32>(select(0u, 1u, _e317)) != 0i) {
            let _e331 = local.member.member_1;
            if (_e331 > 0u) {
                let _e336 = local.member.member_1;
                local.member.member_1 = (_e336 - 1u);
                let _e339 = local.member.member_1;
                let _e342 = local.member.member[_e339];
                let _e346 = local.member_1.member_1;
                local.member_1.member_1 = (_e346 - 1u);
                let _e349 = local.member_1.member_1;
                let _e352 = local.member_1.member[_e349];
                phi_843_ = array<u32, 2>(_e342, _e352);
            } else {
                phi_843_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e355 = phi_843_;
            if (_e355[0] == 4294967295u) {
                phi_2370_ = false;
            } else {
                let _e360 = params.member.member_2.member_1;
                let _e365 = params.member.member_2.member;
                let _e370 = a_nodes.member[_e355[0]];
                let _e372 = b_nodes.member[_e355[1]];
                if (_e365 == 1u) {
                    if (_e355[0] == _e355[1]) {
                        if (_e370.member_3 == 4294967295u) {
                            phi_984_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e378 = a_nodes.member[_e370.member_1];
                            let _e381 = a_nodes.member[_e370.member_3];
                            let _e384 = !((_e378.member_3 == 4294967295u));
                            let _e395 = type_25(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e370.member_1, _e384), select(4294967295u, _e370.member_1, _e384)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e407 = type_25(array<array<u32, 2>, 4>(_e395.member[0], array<u32, 2>(_e370.member_1, _e395.member[1][1]), _e395.member[2], _e395.member[3]), _e395.member_1);
                            let _e415 = type_25(array<array<u32, 2>, 4>(_e407.member[0], array<u32, 2>(_e370.member_1, _e370.member_3), _e407.member[2], _e407.member[3]), _e407.member_1);
                            let _e418 = !((_e381.member_3 == 4294967295u));
                            let _e429 = type_25(array<array<u32, 2>, 4>(_e415.member[0], _e415.member[1], array<u32, 2>(select(4294967295u, _e370.member_3, _e418), select(4294967295u, _e370.member_3, _e418)), _e415.member[3]), _e415.member_1);
                            let _e432 = type_25(_e429.member, _e429.member);
                            let _e459 = ((((((_e378.member[0] <= _e381.member_2[0]) && (_e381.member[0] <= _e378.member_2[0])) && (_e378.member[1] <= _e381.member_2[1])) && (_e381.member[1] <= _e378.member_2[1])) && (_e378.member[2] <= _e381.member_2[2])) && (_e381.member[2] <= _e378.member_2[2]));
                            phi_984_ = type_25(_e432.member, array<array<u32, 2>, 4>(_e432.member_1[0], array<u32, 2>(select(4294967295u, _e370.member_1, _e459), select(4294967295u, _e370.member_3, _e459)), _e432.member_1[2], _e432.member_1[3]));
                        }
                        let _e471 = phi_984_;
                        phi_985_ = _e471;
                        phi_986_ = false;
                    } else {
                        phi_985_ = type_25();
                        phi_986_ = true;
                    }
                    let _e473 = phi_985_;
                    let _e475 = phi_986_;
                    phi_987_ = _e473;
                    phi_988_ = _e475;
                } else {
                    phi_987_ = type_25();
                    phi_988_ = true;
                }
                let _e477 = phi_987_;
                let _e479 = phi_988_;
                if _e479 {
                    let _e482 = !((_e370.member_3 == 4294967295u));
                    let _e485 = !((_e372.member_3 == 4294967295u));
                    if select(_e485, true, _e482) {
                        if _e482 {
                            if _e485 {
                                if (select(0u, 1u, (_e360 == 0u)) == 0u) {
                                    let _e514 = ((((_e372.member_2[0] - _e372.member[0]) * (_e372.member_2[1] - _e372.member[1])) * (_e372.member_2[2] - _e372.member[2])) > (((_e370.member_2[0] - _e370.member[0]) * (_e370.member_2[1] - _e370.member[1])) * (_e370.member_2[2] - _e370.member[2])));
                                    phi_1048_ = _e514;
                                    phi_1049_ = !(_e514);
                                } else {
                                    phi_1048_ = _e485;
                                    phi_1049_ = _e482;
                                }
                                let _e517 = phi_1048_;
                                let _e519 = phi_1049_;
                                phi_1050_ = _e517;
                                phi_1051_ = _e519;
                            } else {
                                phi_1050_ = _e485;
                                phi_1051_ = _e482;
                            }
                            let _e521 = phi_1050_;
                            let _e523 = phi_1051_;
                            phi_1052_ = _e521;
                            phi_1053_ = _e523;
                        } else {
                            phi_1052_ = _e485;
                            phi_1053_ = _e482;
                        }
                        let _e525 = phi_1052_;
                        let _e527 = phi_1053_;
                        if _e527 {
                            if _e525 {
                                let _e530 = a_nodes.member[_e370.member_1];
                                let _e535 = a_nodes.member[_e370.member_3];
                                let _e540 = b_nodes.member[_e372.member_1];
                                let _e545 = b_nodes.member[_e372.member_3];
                                let _e583 = ((((((_e530.member[0] <= _e540.member_2[0]) && (_e540.member[0] <= _e530.member_2[0])) && (_e530.member[1] <= _e540.member_2[1])) && (_e540.member[1] <= _e530.member_2[1])) && (_e530.member[2] <= _e540.member_2[2])) && (_e540.member[2] <= _e530.member_2[2]));
                                let _e609 = ((((((_e530.member[0] <= _e545.member_2[0]) && (_e545.member[0] <= _e530.member_2[0])) && (_e530.member[1] <= _e545.member_2[1])) && (_e545.member[1] <= _e530.member_2[1])) && (_e530.member[2] <= _e545.member_2[2])) && (_e545.member[2] <= _e530.member_2[2]));
                                let _e635 = ((((((_e535.member[0] <= _e540.member_2[0]) && (_e540.member[0] <= _e535.member_2[0])) && (_e535.member[1] <= _e540.member_2[1])) && (_e540.member[1] <= _e535.member_2[1])) && (_e535.member[2] <= _e540.member_2[2])) && (_e540.member[2] <= _e535.member_2[2]));
                                let _e661 = ((((((_e535.member[0] <= _e545.member_2[0]) && (_e545.member[0] <= _e535.member_2[0])) && (_e535.member[1] <= _e545.member_2[1])) && (_e545.member[1] <= _e535.member_2[1])) && (_e535.member[2] <= _e545.member_2[2])) && (_e545.member[2] <= _e535.member_2[2]));
                                phi_1248_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(_e370.member_1, _e372.member_1), array<u32, 2>(_e370.member_1, _e372.member_3), array<u32, 2>(_e370.member_3, _e372.member_1), array<u32, 2>(_e370.member_3, _e372.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e370.member_1, _e583), select(4294967295u, _e372.member_1, _e583)), array<u32, 2>(select(4294967295u, _e370.member_1, _e609), select(4294967295u, _e372.member_3, _e609)), array<u32, 2>(select(4294967295u, _e370.member_3, _e635), select(4294967295u, _e372.member_1, _e635)), array<u32, 2>(select(4294967295u, _e370.member_3, _e661), select(4294967295u, _e372.member_3, _e661))));
                                phi_1249_ = false;
                            } else {
                                phi_1248_ = type_25();
                                phi_1249_ = true;
                            }
                            let _e668 = phi_1248_;
                            let _e670 = phi_1249_;
                            phi_1250_ = _e668;
                            phi_1251_ = _e670;
                        } else {
                            phi_1250_ = type_25();
                            phi_1251_ = true;
                        }
                        let _e672 = phi_1250_;
                        let _e674 = phi_1251_;
                        if _e674 {
                            if _e527 {
                                let _e759 = a_nodes.member[_e370.member_1];
                                let _e764 = a_nodes.member[_e370.member_3];
                                let _e793 = ((((((_e759.member[0] <= _e372.member_2[0]) && (_e372.member[0] <= _e759.member_2[0])) && (_e759.member[1] <= _e372.member_2[1])) && (_e372.member[1] <= _e759.member_2[1])) && (_e759.member[2] <= _e372.member_2[2])) && (_e372.member[2] <= _e759.member_2[2]));
                                let _e803 = type_25(type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e370.member_1, _e793), select(4294967295u, _e355[1], _e793)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e828 = ((((((_e764.member[0] <= _e372.member_2[0]) && (_e372.member[0] <= _e764.member_2[0])) && (_e764.member[1] <= _e372.member_2[1])) && (_e372.member[1] <= _e764.member_2[1])) && (_e764.member[2] <= _e372.member_2[2])) && (_e372.member[2] <= _e764.member_2[2]));
                                phi_1458_ = type_25(_e803.member, array<array<u32, 2>, 4>(_e803.member_1[0], array<u32, 2>(select(4294967295u, _e370.member_3, _e828), select(4294967295u, _e355[1], _e828)), _e803.member_1[2], _e803.member_1[3]));
                            } else {
                                let _e677 = b_nodes.member[_e372.member_1];
                                let _e682 = b_nodes.member[_e372.member_3];
                                let _e711 = ((((((_e370.member[0] <= _e677.member_2[0]) && (_e677.member[0] <= _e370.member_2[0])) && (_e370.member[1] <= _e677.member_2[1])) && (_e677.member[1] <= _e370.member_2[1])) && (_e370.member[2] <= _e677.member_2[2])) && (_e677.member[2] <= _e370.member_2[2]));
                                let _e721 = type_25(type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e355[0], _e711), select(4294967295u, _e372.member_1, _e711)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e746 = ((((((_e370.member[0] <= _e682.member_2[0]) && (_e682.member[0] <= _e370.member_2[0])) && (_e370.member[1] <= _e682.member_2[1])) && (_e682.member[1] <= _e370.member_2[1])) && (_e370.member[2] <= _e682.member_2[2])) && (_e682.member[2] <= _e370.member_2[2]));
                                phi_1458_ = type_25(_e721.member, array<array<u32, 2>, 4>(_e721.member_1[0], array<u32, 2>(select(4294967295u, _e355[0], _e746), select(4294967295u, _e372.member_3, _e746)), _e721.member_1[2], _e721.member_1[3]));
                            }
                            let _e840 = phi_1458_;
                            phi_1459_ = _e840;
                        } else {
                            phi_1459_ = _e672;
                        }
                        let _e842 = phi_1459_;
                        phi_1460_ = _e842;
                        phi_1461_ = false;
                    } else {
                        phi_1460_ = type_25();
                        phi_1461_ = true;
                    }
                    let _e844 = phi_1460_;
                    let _e846 = phi_1461_;
                    phi_1462_ = _e844;
                    phi_1463_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_1464_ = _e846;
                } else {
                    phi_1462_ = type_25();
                    phi_1463_ = _e477;
                    phi_1464_ = true;
                }
                let _e848 = phi_1462_;
                let _e850 = phi_1463_;
                let _e852 = phi_1464_;
                if _e852 {
                    phi_1468_ = _e850;
                } else {
                    phi_1468_ = _e848;
                }
                let _e854 = phi_1468_;
                let _e859 = params.member.member_2.member;
                let _e860 = (_e859 == 0u);
                let _e866 = params.member.member.member[select(1u, 0u, _e860)];
                let _e871 = params.member.member.member[select(1u, 2u, _e860)];
                let _e882 = select(select(2u, 1u, select(true, select(true, false, (_e854.member_1[0][1] >= (_e871 - 1u))), (_e854.member_1[0][0] >= (_e866 - 1u)))), 0u, (_e854.member_1[0][0] == 4294967295u));
                if (_e882 == 2u) {
                    let _e942 = params.member.member_1.member_3;
                    let _e945 = a_nodes.member[_e854.member_1[0][0]];
                    let _e949 = b_nodes.member[_e854.member_1[0][1]];
                    let _e953 = params.member.member_2.member;
                    if (_e953 == 1u) {
                        let _e956 = (_e945.member_1 < _e949.member_1);
                        phi_1579_ = type_9(select(_e949.member_1, _e945.member_1, _e956), select(_e945.member_1, _e949.member_1, _e956));
                    } else {
                        phi_1579_ = type_9(_e945.member_1, _e949.member_1);
                    }
                    let _e961 = phi_1579_;
                    let _e965 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e965 + 1u) < _e965) {
                        let _e969 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e965 < _e942) {
                        let _e971 = (2u * _e965);
                        atomicStore((&pairs.member[(4u + _e971)]), _e961.member);
                        atomicStore((&pairs.member[(_e971 + 5u)]), _e961.member_1);
                    }
                } else {
                    if (_e882 == 1u) {
                        let _e887 = params.member.member_2.member_10;
                        let _e890 = local.member.member_1;
                        let _e893 = (_e890 < select(_e887, 64u, (64u < _e887)));
                        if _e893 {
                            let _e896 = function_(_e854.member_1[0][0]);
                            let _e898 = local.member.member_1;
                            local.member.member[_e898] = _e896;
                            let _e903 = local.member.member_1;
                            local.member.member_1 = (_e903 + 1u);
                            let _e907 = function_(_e854.member_1[0][1]);
                            let _e909 = local.member_1.member_1;
                            local.member_1.member[_e909] = _e907;
                            let _e914 = local.member_1.member_1;
                            local.member_1.member_1 = (_e914 + 1u);
                        }
                        if _e893 {
                        } else {
                            let _e918 = params.member.member_1.member_1;
                            let _e921 = atomicAdd((&rounds.member[(_e918 + 1u)]), 1u);
                            let _e924 = atomicMax((&output.member[0u]), (_e921 + 1u));
                            if ((_e921 + 1u) < _e921) {
                                let _e928 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e931 = params.member.member_2.member_3;
                            if (_e921 < _e931) {
                                let _e935 = (2u * _e921);
                                atomicStore((&output.member[(4u + _e935)]), _e854.member_1[0][0]);
                                atomicStore((&output.member[(_e935 + 5u)]), _e854.member_1[0][1]);
                            }
                        }
                    }
                }
                let _e979 = params.member.member_2.member;
                let _e980 = (_e979 == 0u);
                let _e986 = params.member.member.member[select(1u, 0u, _e980)];
                let _e991 = params.member.member.member[select(1u, 2u, _e980)];
                let _e1002 = select(select(2u, 1u, select(true, select(true, false, (_e854.member_1[1][1] >= (_e991 - 1u))), (_e854.member_1[1][0] >= (_e986 - 1u)))), 0u, (_e854.member_1[1][0] == 4294967295u));
                if (_e1002 == 2u) {
                    let _e1062 = params.member.member_1.member_3;
                    let _e1065 = a_nodes.member[_e854.member_1[1][0]];
                    let _e1069 = b_nodes.member[_e854.member_1[1][1]];
                    let _e1073 = params.member.member_2.member;
                    if (_e1073 == 1u) {
                        let _e1076 = (_e1065.member_1 < _e1069.member_1);
                        phi_1804_ = type_9(select(_e1069.member_1, _e1065.member_1, _e1076), select(_e1065.member_1, _e1069.member_1, _e1076));
                    } else {
                        phi_1804_ = type_9(_e1065.member_1, _e1069.member_1);
                    }
                    let _e1081 = phi_1804_;
                    let _e1085 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1085 + 1u) < _e1085) {
                        let _e1089 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1085 < _e1062) {
                        let _e1091 = (2u * _e1085);
                        atomicStore((&pairs.member[(4u + _e1091)]), _e1081.member);
                        atomicStore((&pairs.member[(_e1091 + 5u)]), _e1081.member_1);
                    }
                } else {
                    if (_e1002 == 1u) {
                        let _e1007 = params.member.member_2.member_10;
                        let _e1010 = local.member.member_1;
                        let _e1013 = (_e1010 < select(_e1007, 64u, (64u < _e1007)));
                        if _e1013 {
                            let _e1016 = function_(_e854.member_1[1][0]);
                            let _e1018 = local.member.member_1;
                            local.member.member[_e1018] = _e1016;
                            let _e1023 = local.member.member_1;
                            local.member.member_1 = (_e1023 + 1u);
                            let _e1027 = function_(_e854.member_1[1][1]);
                            let _e1029 = local.member_1.member_1;
                            local.member_1.member[_e1029] = _e1027;
                            let _e1034 = local.member_1.member_1;
                            local.member_1.member_1 = (_e1034 + 1u);
                        }
                        if _e1013 {
                        } else {
                            let _e1038 = params.member.member_1.member_1;
                            let _e1041 = atomicAdd((&rounds.member[(_e1038 + 1u)]), 1u);
                            let _e1044 = atomicMax((&output.member[0u]), (_e1041 + 1u));
                            if ((_e1041 + 1u) < _e1041) {
                                let _e1048 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1051 = params.member.member_2.member_3;
                            if (_e1041 < _e1051) {
                                let _e1055 = (2u * _e1041);
                                atomicStore((&output.member[(4u + _e1055)]), _e854.member_1[1][0]);
                                atomicStore((&output.member[(_e1055 + 5u)]), _e854.member_1[1][1]);
                            }
                        }
                    }
                }
                let _e1099 = params.member.member_2.member;
                let _e1100 = (_e1099 == 0u);
                let _e1106 = params.member.member.member[select(1u, 0u, _e1100)];
                let _e1111 = params.member.member.member[select(1u, 2u, _e1100)];
                let _e1122 = select(select(2u, 1u, select(true, select(true, false, (_e854.member_1[2][1] >= (_e1111 - 1u))), (_e854.member_1[2][0] >= (_e1106 - 1u)))), 0u, (_e854.member_1[2][0] == 4294967295u));
                if (_e1122 == 2u) {
                    let _e1182 = params.member.member_1.member_3;
                    let _e1185 = a_nodes.member[_e854.member_1[2][0]];
                    let _e1189 = b_nodes.member[_e854.member_1[2][1]];
                    let _e1193 = params.member.member_2.member;
                    if (_e1193 == 1u) {
                        let _e1196 = (_e1185.member_1 < _e1189.member_1);
                        phi_2029_ = type_9(select(_e1189.member_1, _e1185.member_1, _e1196), select(_e1185.member_1, _e1189.member_1, _e1196));
                    } else {
                        phi_2029_ = type_9(_e1185.member_1, _e1189.member_1);
                    }
                    let _e1201 = phi_2029_;
                    let _e1205 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1205 + 1u) < _e1205) {
                        let _e1209 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1205 < _e1182) {
                        let _e1211 = (2u * _e1205);
                        atomicStore((&pairs.member[(4u + _e1211)]), _e1201.member);
                        atomicStore((&pairs.member[(_e1211 + 5u)]), _e1201.member_1);
                    }
                } else {
                    if (_e1122 == 1u) {
                        let _e1127 = params.member.member_2.member_10;
                        let _e1130 = local.member.member_1;
                        let _e1133 = (_e1130 < select(_e1127, 64u, (64u < _e1127)));
                        if _e1133 {
                            let _e1136 = function_(_e854.member_1[2][0]);
                            let _e1138 = local.member.member_1;
                            local.member.member[_e1138] = _e1136;
                            let _e1143 = local.member.member_1;
                            local.member.member_1 = (_e1143 + 1u);
                            let _e1147 = function_(_e854.member_1[2][1]);
                            let _e1149 = local.member_1.member_1;
                            local.member_1.member[_e1149] = _e1147;
                            let _e1154 = local.member_1.member_1;
                            local.member_1.member_1 = (_e1154 + 1u);
                        }
                        if _e1133 {
                        } else {
                            let _e1158 = params.member.member_1.member_1;
                            let _e1161 = atomicAdd((&rounds.member[(_e1158 + 1u)]), 1u);
                            let _e1164 = atomicMax((&output.member[0u]), (_e1161 + 1u));
                            if ((_e1161 + 1u) < _e1161) {
                                let _e1168 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1171 = params.member.member_2.member_3;
                            if (_e1161 < _e1171) {
                                let _e1175 = (2u * _e1161);
                                atomicStore((&output.member[(4u + _e1175)]), _e854.member_1[2][0]);
                                atomicStore((&output.member[(_e1175 + 5u)]), _e854.member_1[2][1]);
                            }
                        }
                    }
                }
                let _e1219 = params.member.member_2.member;
                let _e1220 = (_e1219 == 0u);
                let _e1226 = params.member.member.member[select(1u, 0u, _e1220)];
                let _e1231 = params.member.member.member[select(1u, 2u, _e1220)];
                let _e1242 = select(select(2u, 1u, select(true, select(true, false, (_e854.member_1[3][1] >= (_e1231 - 1u))), (_e854.member_1[3][0] >= (_e1226 - 1u)))), 0u, (_e854.member_1[3][0] == 4294967295u));
                if (_e1242 == 2u) {
                    let _e1302 = params.member.member_1.member_3;
                    let _e1305 = a_nodes.member[_e854.member_1[3][0]];
                    let _e1309 = b_nodes.member[_e854.member_1[3][1]];
                    let _e1313 = params.member.member_2.member;
                    if (_e1313 == 1u) {
                        let _e1316 = (_e1305.member_1 < _e1309.member_1);
                        phi_2254_ = type_9(select(_e1309.member_1, _e1305.member_1, _e1316), select(_e1305.member_1, _e1309.member_1, _e1316));
                    } else {
                        phi_2254_ = type_9(_e1305.member_1, _e1309.member_1);
                    }
                    let _e1321 = phi_2254_;
                    let _e1325 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1325 + 1u) < _e1325) {
                        let _e1329 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1325 < _e1302) {
                        let _e1331 = (2u * _e1325);
                        atomicStore((&pairs.member[(4u + _e1331)]), _e1321.member);
                        atomicStore((&pairs.member[(_e1331 + 5u)]), _e1321.member_1);
                    }
                } else {
                    if (_e1242 == 1u) {
                        let _e1247 = params.member.member_2.member_10;
                        let _e1250 = local.member.member_1;
                        let _e1253 = (_e1250 < select(_e1247, 64u, (64u < _e1247)));
                        if _e1253 {
                            let _e1256 = function_(_e854.member_1[3][0]);
                            let _e1258 = local.member.member_1;
                            local.member.member[_e1258] = _e1256;
                            let _e1263 = local.member.member_1;
                            local.member.member_1 = (_e1263 + 1u);
                            let _e1267 = function_(_e854.member_1[3][1]);
                            let _e1269 = local.member_1.member_1;
                            local.member_1.member[_e1269] = _e1267;
                            let _e1274 = local.member_1.member_1;
                            local.member_1.member_1 = (_e1274 + 1u);
                        }
                        if _e1253 {
                        } else {
                            let _e1278 = params.member.member_1.member_1;
                            let _e1281 = atomicAdd((&rounds.member[(_e1278 + 1u)]), 1u);
                            let _e1284 = atomicMax((&output.member[0u]), (_e1281 + 1u));
                            if ((_e1281 + 1u) < _e1281) {
                                let _e1288 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1291 = params.member.member_2.member_3;
                            if (_e1281 < _e1291) {
                                let _e1295 = (2u * _e1281);
                                atomicStore((&output.member[(4u + _e1295)]), _e854.member_1[3][0]);
                                atomicStore((&output.member[(_e1295 + 5u)]), _e854.member_1[3][1]);
                            }
                        }
                    }
                }
                phi_2370_ = true;
            }
            let _e1337 = phi_2370_;
            phi_2371_ = _e1337;
        } else {
            phi_2371_ = false;
        }
        let _e1339 = phi_2371_;
        continue;
        continuing {
            phi_776_ = type_9(select(_e314.member, (_e314.member + 1u), _e317), select(_e314.member_1, _e314.member_1, _e317));
            break if !(_e1339);
        }
    }
    phi_2374_ = type_9(0u, 64u);
    loop {
        let _e1342 = phi_2374_;
        let _e1345 = (_e1342.member < _e1342.member_1);
        if (bitcast<i32>(select(0u, 1u, _e1345)) != 0i) {
            let _e1359 = local.member.member_1;
            if (_e1359 > 0u) {
                let _e1364 = local.member.member_1;
                local.member.member_1 = (_e1364 - 1u);
                let _e1367 = local.member.member_1;
                let _e1370 = local.member.member[_e1367];
                let _e1374 = local.member_1.member_1;
                local.member_1.member_1 = (_e1374 - 1u);
                let _e1377 = local.member_1.member_1;
                let _e1380 = local.member_1.member[_e1377];
                phi_2441_ = array<u32, 2>(_e1370, _e1380);
            } else {
                phi_2441_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1383 = phi_2441_;
            if (_e1383[0] == 4294967295u) {
                phi_2484_ = false;
            } else {
                let _e1388 = params.member.member_1.member_1;
                let _e1391 = atomicAdd((&rounds.member[(_e1388 + 1u)]), 1u);
                let _e1394 = atomicMax((&output.member[0u]), (_e1391 + 1u));
                if ((_e1391 + 1u) < _e1391) {
                    let _e1398 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1401 = params.member.member_2.member_3;
                if (_e1391 < _e1401) {
                    let _e1405 = (2u * _e1391);
                    atomicStore((&output.member[(4u + _e1405)]), _e1383[0]);
                    atomicStore((&output.member[(_e1405 + 5u)]), _e1383[1]);
                }
                phi_2484_ = true;
            }
            let _e1411 = phi_2484_;
            phi_2485_ = _e1411;
        } else {
            phi_2485_ = false;
        }
        let _e1413 = phi_2485_;
        continue;
        continuing {
            phi_2374_ = type_9(select(_e1342.member, (_e1342.member + 1u), _e1345), select(_e1342.member_1, _e1342.member_1, _e1345));
            break if !(_e1413);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
