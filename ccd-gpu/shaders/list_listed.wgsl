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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_25 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage, read_write> output: type_29;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(2) 
var<storage> elements: type_13;
@group(0) @binding(3) 
var<storage> bodies: type_13;
@group(0) @binding(4) 
var<storage> keys: type_24;
@group(0) @binding(5) 
var<storage> input: type_13;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param[0] > param_1[0]), (param[1] == param_1[1])), true, (param[1] > param_1[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_3[0] > param_2[0]), (param_3[1] == param_2[1])), true, (param_3[1] > param_2[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_4[0] > param_5[0]), (param_4[1] == param_5[1])), true, (param_4[1] > param_5[1]));
    return array<u32, 2>(select(param_4[0], param_5[0], _e14), select(param_4[1], param_5[1], _e14));
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_7[0] > param_6[0]), (param_7[1] == param_6[1])), true, (param_7[1] > param_6[1]));
    return array<u32, 2>(select(param_6[0], param_7[0], _e14), select(param_6[1], param_7[1], _e14));
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_8[0] > param_9[0]), (param_8[1] == param_9[1])), true, (param_8[1] > param_9[1]));
    return array<u32, 2>(select(param_8[0], param_9[0], _e14), select(param_8[1], param_9[1], _e14));
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_11[0] > param_10[0]), (param_11[1] == param_10[1])), true, (param_11[1] > param_10[1]));
    return array<u32, 2>(select(param_10[0], param_11[0], _e14), select(param_10[1], param_11[1], _e14));
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_290_: u32;
    var phi_335_: u32;
    var phi_338_: type_9;
    var phi_496_: type_25;
    var phi_533_: array<u32, 2>;
    var phi_609_: bool;
    var phi_614_: bool;
    var phi_783_: bool;
    var phi_824_: type_16;
    var phi_827_: u32;
    var phi_829_: u32;
    var phi_825_: type_16;
    var phi_870_: type_17;
    var phi_946_: bool;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: bool;
    var phi_828_: u32;
    var phi_830_: u32;
    var phi_956_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1012_: bool;
    var phi_1016_: bool;
    var phi_1021_: bool;
    var phi_1026_: bool;
    var phi_1031_: bool;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1665_: u32;
    var phi_1666_: u32;
    var phi_1667_: bool;
    var phi_1668_: type_9;
    var phi_1718_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e47 = ((_e33.y * _e34.x) + _e33.x);
    let _e50 = (_e34.x * _e34.y);
    let _e54 = params.member.member_2.member;
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    let _e60 = select(_e58, _e56, (_e56 < _e58));
    let _e62 = params.member.member_1.member_1;
    if (_e60 > _e62) {
        let _e65 = params.member.member_1.member_1;
        phi_290_ = (_e60 - _e65);
    } else {
        phi_290_ = 0u;
    }
    let _e68 = phi_290_;
    let _e70 = params.member.member_1.member;
    let _e72 = select(_e68, _e70, (_e70 < _e68));
    let _e73 = (_e72 / 128u);
    let _e77 = select(_e73, (_e73 + 1u), ((_e72 % 128u) > 0u));
    if (_e77 > _e47) {
        let _e79 = (_e77 - _e47);
        if (_e50 == 0u) {
            return;
        }
        let _e81 = (_e79 / _e50);
        if (_e50 == 0u) {
            return;
        }
        phi_335_ = select(_e81, (_e81 + 1u), ((_e79 % _e50) > 0u));
    } else {
        phi_335_ = 0u;
    }
    let _e88 = phi_335_;
    phi_338_ = type_9(0u, _e88);
    loop {
        let _e91 = phi_338_;
        let _e94 = (_e91.member < _e91.member_1);
        let _e107 = (bitcast<i32>(select(0u, 1u, _e94)) != 0i);
        if _e107 {
            let _e111 = (((_e47 + (select(type_9().member_1, _e91.member, _e94) * _e50)) * 128u) + _e35);
            if (_e35 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if (_e111 < _e72) {
                let _e116 = params.member.member_1.member_1;
                let _e118 = (2u * (_e116 + _e111));
                let _e121 = input.member[(4u + _e118)];
                let _e124 = input.member[(_e118 + 5u)];
                if (_e54 == 0u) {
                    let _e141 = (3u * _e124);
                    let _e143 = elements.member[_e141];
                    let _e146 = elements.member[(_e141 + 1u)];
                    let _e149 = elements.member[(_e141 + 2u)];
                    phi_496_ = type_25(0u, array<u32, 4>(_e121, _e143, _e146, _e149));
                } else {
                    let _e127 = (2u * _e121);
                    let _e128 = (2u * _e124);
                    let _e130 = elements.member[_e127];
                    let _e132 = elements.member[_e128];
                    let _e135 = elements.member[(_e127 + 1u)];
                    let _e138 = elements.member[(_e128 + 1u)];
                    phi_496_ = type_25(1u, array<u32, 4>(_e130, _e135, _e132, _e138));
                }
                let _e153 = phi_496_;
                let _e159 = (_e54 == 0u);
                let _e160 = select(_e153.member_1[2], _e153.member_1[1], _e159);
                let _e161 = select(_e153.member_1[3], _e153.member_1[2], _e159);
                let _e162 = select(_e153.member_1[1], _e153.member_1[0], _e159);
                let _e163 = select(_e153.member_1[1], _e153.member_1[0], _e159);
                if (_e54 == 0u) {
                    let _e177 = params.member.member.member_2[2u];
                    phi_533_ = array<u32, 2>(_e121, (_e177 + _e124));
                } else {
                    let _e168 = params.member.member.member_2[1u];
                    let _e172 = params.member.member.member_2[1u];
                    phi_533_ = array<u32, 2>((_e168 + _e121), (_e172 + _e124));
                }
                let _e181 = phi_533_;
                let _e185 = boxes.member[_e181[0]];
                let _e187 = boxes.member[_e181[1]];
                let _e190 = params.member.member.member_1;
                if ((_e190 & 1u) != 0u) {
                    if (_e54 == 0u) {
                        phi_609_ = ((select((_e160 == _e153.member_1[0]), true, (_e160 == _e153.member_1[0])) || select((_e161 == _e153.member_1[0]), true, (_e161 == _e153.member_1[0]))) || select((_e153.member_1[3] == _e153.member_1[0]), true, (_e153.member_1[3] == _e153.member_1[0])));
                    } else {
                        phi_609_ = (select((_e160 == _e162), true, (_e160 == _e153.member_1[0])) || select((_e161 == _e162), true, (_e161 == _e153.member_1[0])));
                    }
                    let _e213 = phi_609_;
                    phi_614_ = select(true, false, _e213);
                } else {
                    phi_614_ = true;
                }
                let _e216 = phi_614_;
                if _e216 {
                    let _e218 = params.member.member.member_1;
                    if ((_e218 & 2u) != 0u) {
                        let _e222 = bodies.member[_e153.member_1[0]];
                        let _e224 = bodies.member[_e160];
                        if select(false, (((_e222 & _e224) & 1u) == 0u), select(select(true, false, ((_e222 & 2u) == 0u)), true, ((_e222 / 4u) != (_e224 / 4u)))) {
                            let _e237 = params.member.member.member_1;
                            if ((_e237 & 4u) != 0u) {
                                let _e242 = params.member.member.member[0u];
                                let _e244 = bodies.member[_e242];
                                let _e247 = bodies.member[(_e242 + 1u)];
                                let _e252 = ((_e242 + 4u) + (2u * (_e222 >> bitcast<u32>(2i))));
                                let _e257 = ((_e242 + 4u) + (2u * (_e224 >> bitcast<u32>(2i))));
                                let _e259 = bodies.member[_e252];
                                let _e261 = bodies.member[_e257];
                                let _e270 = bodies.member[((((_e242 + 4u) + (2u * _e244)) + (_e259 * _e247)) + (_e261 / 32u))];
                                let _e273 = bodies.member[(_e252 + 1u)];
                                let _e276 = bodies.member[(_e257 + 1u)];
                                if (_e273 == _e276) {
                                    phi_783_ = select(((_e222 >> bitcast<u32>(2i)) == (_e224 >> bitcast<u32>(2i))), true, (((_e270 >> bitcast<u32>(((_e261 % 32u) & 31u))) & 1u) == 1u));
                                } else {
                                    phi_783_ = false;
                                }
                                let _e291 = phi_783_;
                                if _e291 {
                                    let _e294 = bodies.member[(_e242 + 2u)];
                                    let _e297 = bodies.member[(_e242 + 3u)];
                                    let _e298 = (_e297 + _e242);
                                    let _e299 = (_e54 == 1u);
                                    let _e300 = (_e124 < _e121);
                                    let _e303 = select(_e124, select(_e124, _e121, _e300), _e299);
                                    let _e304 = select(_e121, select(_e121, _e124, _e300), _e299);
                                    phi_824_ = type_16(0i, 32i);
                                    phi_827_ = _e294;
                                    phi_829_ = 0u;
                                    loop {
                                        let _e306 = phi_824_;
                                        let _e308 = phi_827_;
                                        let _e310 = phi_829_;
                                        local = _e310;
                                        local_1 = _e310;
                                        if (_e306.member < _e306.member_1) {
                                            let _e317 = (_e306.member + 1i);
                                            phi_825_ = type_16(select(_e317, type_17().member_1, select(false, true, ((false == (_e317 > _e306.member)) != false))), _e306.member_1);
                                            phi_870_ = type_17(1u, _e306.member);
                                        } else {
                                            phi_825_ = _e306;
                                            phi_870_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e328 = phi_825_;
                                        let _e330 = phi_870_;
                                        if (bitcast<i32>(_e330.member) != 0i) {
                                            if (_e310 >= _e308) {
                                                phi_953_ = u32();
                                                phi_954_ = u32();
                                                phi_955_ = false;
                                            } else {
                                                let _e337 = (_e310 + ((_e308 - _e310) / 2u));
                                                let _e339 = (_e298 + (3u * _e337));
                                                let _e341 = bodies.member[_e339];
                                                let _e344 = bodies.member[(_e339 + 1u)];
                                                let _e347 = bodies.member[(_e339 + 2u)];
                                                if (_e341 < _e54) {
                                                    phi_946_ = true;
                                                } else {
                                                    phi_946_ = select(true, false, select(true, select(select(true, select(true, false, (_e347 < _e303)), (_e344 == _e304)), false, (_e344 < _e304)), (_e341 == _e54)));
                                                }
                                                let _e359 = phi_946_;
                                                phi_953_ = select(_e337, _e308, _e359);
                                                phi_954_ = select(_e310, (_e337 + 1u), _e359);
                                                phi_955_ = true;
                                            }
                                            let _e364 = phi_953_;
                                            let _e366 = phi_954_;
                                            let _e368 = phi_955_;
                                            phi_828_ = _e364;
                                            phi_830_ = _e366;
                                            phi_956_ = _e368;
                                        } else {
                                            phi_828_ = u32();
                                            phi_830_ = u32();
                                            phi_956_ = false;
                                        }
                                        let _e370 = phi_828_;
                                        let _e372 = phi_830_;
                                        let _e374 = phi_956_;
                                        continue;
                                        continuing {
                                            phi_824_ = _e328;
                                            phi_827_ = _e370;
                                            phi_829_ = _e372;
                                            break if !(_e374);
                                        }
                                    }
                                    let _e377 = local;
                                    if (_e377 < _e294) {
                                        let _e380 = local_1;
                                        let _e382 = (_e298 + (3u * _e380));
                                        let _e384 = bodies.member[_e382];
                                        if (_e384 == _e54) {
                                            let _e388 = bodies.member[(_e382 + 1u)];
                                            if (_e388 == _e304) {
                                                let _e392 = bodies.member[(_e382 + 2u)];
                                                phi_1004_ = (_e392 == _e303);
                                                phi_1005_ = false;
                                            } else {
                                                phi_1004_ = bool();
                                                phi_1005_ = true;
                                            }
                                            let _e395 = phi_1004_;
                                            let _e397 = phi_1005_;
                                            phi_1006_ = _e395;
                                            phi_1007_ = _e397;
                                        } else {
                                            phi_1006_ = bool();
                                            phi_1007_ = true;
                                        }
                                        let _e399 = phi_1006_;
                                        let _e401 = phi_1007_;
                                        phi_1012_ = select(_e399, false, _e401);
                                    } else {
                                        phi_1012_ = false;
                                    }
                                    let _e404 = phi_1012_;
                                    phi_1016_ = _e404;
                                } else {
                                    phi_1016_ = true;
                                }
                                let _e406 = phi_1016_;
                                phi_1021_ = select(true, false, _e406);
                            } else {
                                phi_1021_ = true;
                            }
                            let _e409 = phi_1021_;
                            phi_1026_ = select(true, false, _e409);
                        } else {
                            phi_1026_ = true;
                        }
                        let _e412 = phi_1026_;
                        phi_1031_ = select(true, false, _e412);
                    } else {
                        phi_1031_ = true;
                    }
                    let _e415 = phi_1031_;
                    if _e415 {
                        let _e417 = params.member.member.member_1;
                        if ((_e417 & 32u) != 0u) {
                            let _e421 = params.member.member.member_6;
                            let _e462 = (((((_e185.member_1[0] - _e187.member[0]) > _e421) && ((_e187.member_1[0] - _e185.member[0]) > _e421)) && (((_e185.member_1[1] - _e187.member[1]) > _e421) && ((_e187.member_1[1] - _e185.member[1]) > _e421))) && (((_e185.member_1[2] - _e187.member[2]) > _e421) && ((_e187.member_1[2] - _e185.member[2]) > _e421)));
                            if _e462 {
                                phi_1645_ = bool();
                            } else {
                                let _e464 = keys.member[_e153.member_1[0]];
                                let _e467 = keys.member[_e162];
                                let _e469 = function_(_e464[0], _e467[0]);
                                let _e471 = keys.member[_e163];
                                let _e473 = function_(_e469, _e471[0]);
                                let _e475 = keys.member[_e160];
                                let _e478 = keys.member[_e161];
                                let _e480 = function_1(_e475[3], _e478[3]);
                                let _e482 = keys.member[_e153.member_1[3]];
                                let _e484 = function_1(_e480, _e482[3]);
                                let _e498 = keys.member[_e160];
                                let _e501 = keys.member[_e161];
                                let _e503 = function_(_e498[0], _e501[0]);
                                let _e505 = keys.member[_e153.member_1[3]];
                                let _e507 = function_(_e503, _e505[0]);
                                let _e509 = keys.member[_e153.member_1[0]];
                                let _e512 = keys.member[_e162];
                                let _e514 = function_1(_e509[3], _e512[3]);
                                let _e516 = keys.member[_e163];
                                let _e518 = function_1(_e514, _e516[3]);
                                let _e533 = keys.member[_e153.member_1[0]];
                                let _e536 = keys.member[_e162];
                                let _e538 = function_2(_e533[1], _e536[1]);
                                let _e540 = keys.member[_e163];
                                let _e542 = function_2(_e538, _e540[1]);
                                let _e544 = keys.member[_e160];
                                let _e547 = keys.member[_e161];
                                let _e549 = function_3(_e544[4], _e547[4]);
                                let _e551 = keys.member[_e153.member_1[3]];
                                let _e553 = function_3(_e549, _e551[4]);
                                let _e567 = keys.member[_e160];
                                let _e570 = keys.member[_e161];
                                let _e572 = function_2(_e567[1], _e570[1]);
                                let _e574 = keys.member[_e153.member_1[3]];
                                let _e576 = function_2(_e572, _e574[1]);
                                let _e578 = keys.member[_e153.member_1[0]];
                                let _e581 = keys.member[_e162];
                                let _e583 = function_3(_e578[4], _e581[4]);
                                let _e585 = keys.member[_e163];
                                let _e587 = function_3(_e583, _e585[4]);
                                let _e603 = keys.member[_e153.member_1[0]];
                                let _e606 = keys.member[_e162];
                                let _e608 = function_4(_e603[2], _e606[2]);
                                let _e610 = keys.member[_e163];
                                let _e612 = function_4(_e608, _e610[2]);
                                let _e614 = keys.member[_e160];
                                let _e617 = keys.member[_e161];
                                let _e619 = function_5(_e614[5], _e617[5]);
                                let _e621 = keys.member[_e153.member_1[3]];
                                let _e623 = function_5(_e619, _e621[5]);
                                let _e637 = keys.member[_e160];
                                let _e640 = keys.member[_e161];
                                let _e642 = function_4(_e637[2], _e640[2]);
                                let _e644 = keys.member[_e153.member_1[3]];
                                let _e646 = function_4(_e642, _e644[2]);
                                let _e648 = keys.member[_e153.member_1[0]];
                                let _e651 = keys.member[_e162];
                                let _e653 = function_5(_e648[5], _e651[5]);
                                let _e655 = keys.member[_e163];
                                let _e657 = function_5(_e653, _e655[5]);
                                phi_1645_ = (((!(select(select(false, (_e473[0] > _e484[0]), (_e473[1] == _e484[1])), true, (_e473[1] > _e484[1]))) && !(select(select(false, (_e507[0] > _e518[0]), (_e507[1] == _e518[1])), true, (_e507[1] > _e518[1])))) && (!(select(select(false, (_e542[0] > _e553[0]), (_e542[1] == _e553[1])), true, (_e542[1] > _e553[1]))) && !(select(select(false, (_e576[0] > _e587[0]), (_e576[1] == _e587[1])), true, (_e576[1] > _e587[1]))))) && (!(select(select(false, (_e612[0] > _e623[0]), (_e612[1] == _e623[1])), true, (_e612[1] > _e623[1]))) && !(select(select(false, (_e646[0] > _e657[0]), (_e646[1] == _e657[1])), true, (_e646[1] > _e657[1])))));
                            }
                            let _e673 = phi_1645_;
                            phi_1646_ = _e673;
                            phi_1647_ = _e462;
                        } else {
                            phi_1646_ = bool();
                            phi_1647_ = true;
                        }
                        let _e675 = phi_1646_;
                        let _e677 = phi_1647_;
                        phi_1652_ = _e675;
                        phi_1653_ = select(true, false, _e677);
                    } else {
                        phi_1652_ = false;
                        phi_1653_ = true;
                    }
                    let _e680 = phi_1652_;
                    let _e682 = phi_1653_;
                    phi_1654_ = _e680;
                    phi_1655_ = _e682;
                } else {
                    phi_1654_ = false;
                    phi_1655_ = true;
                }
                let _e684 = phi_1654_;
                let _e686 = phi_1655_;
                let _e687 = select(true, _e684, _e686);
                if _e687 {
                    let _e689 = atomicAdd((&counters[0u]), 1u);
                    phi_1665_ = _e689;
                } else {
                    phi_1665_ = 0u;
                }
                let _e691 = phi_1665_;
                phi_1666_ = _e691;
                phi_1667_ = _e687;
                phi_1668_ = type_9(_e121, _e124);
            } else {
                phi_1666_ = 0u;
                phi_1667_ = false;
                phi_1668_ = type_9(0u, 0u);
            }
            let _e693 = phi_1666_;
            let _e695 = phi_1667_;
            let _e697 = phi_1668_;
            workgroupBarrier();
            if (_e35 == 0u) {
                let _e700 = atomicLoad((&counters[0u]));
                if (_e700 > 0u) {
                    let _e704 = params.member.member.member_1;
                    if ((_e704 & 1024u) != 0u) {
                        let _e714 = atomicAdd((&output.member[0u]), _e700);
                        let _e715 = (_e714 + _e700);
                        let _e717 = select(_e715, 4294967295u, (_e715 < _e714));
                        let _e720 = params.member.member_1.member_3;
                        if (_e717 > _e720) {
                            let _e723 = atomicMax((&output.member[2u]), _e717);
                        }
                        phi_1718_ = _e714;
                    } else {
                        let _e708 = atomicAdd((&output.member[0u]), _e700);
                        if ((_e708 + _e700) < _e708) {
                            let _e712 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_1718_ = _e708;
                    }
                    let _e725 = phi_1718_;
                    atomicStore((&counters[1u]), _e725);
                    let _e728 = atomicAdd((&output.member[1u]), _e700);
                    if ((_e728 + _e700) < _e728) {
                        let _e732 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e695 {
                let _e734 = params.member.member_1.member_3;
                let _e736 = atomicLoad((&counters[1u]));
                let _e737 = (_e736 + _e693);
                if (_e737 < _e734) {
                    let _e741 = (2u * _e737);
                    atomicStore((&output.member[(4u + _e741)]), _e697.member);
                    atomicStore((&output.member[(_e741 + 5u)]), _e697.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_338_ = type_9(select(_e91.member, (_e91.member + 1u), _e94), select(_e91.member_1, _e91.member_1, _e94));
            break if !(_e107);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
