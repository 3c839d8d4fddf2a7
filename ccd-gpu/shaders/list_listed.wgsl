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

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_27 {
    member: array<atomic<u32>>,
}

var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage, read_write> output: type_27;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> elements: type_11;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_11;
@group(0) @binding(5) 
var<storage> input: type_11;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param[0] > param_1[0]), (param[1] == param_1[1])), true, (param[1] > param_1[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_3[0] > param_2[0]), (param_3[1] == param_2[1])), true, (param_3[1] > param_2[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_194_: u32;
    var phi_239_: u32;
    var phi_242_: type_9;
    var phi_405_: type_23;
    var phi_442_: array<u32, 2>;
    var phi_511_: bool;
    var phi_680_: bool;
    var phi_721_: type_14;
    var phi_724_: u32;
    var phi_722_: type_14;
    var phi_765_: type_15;
    var phi_844_: u32;
    var phi_725_: u32;
    var local: u32;
    var local_1: u32;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_900_: bool;
    var phi_904_: bool;
    var phi_909_: bool;
    var phi_914_: bool;
    var phi_919_: bool;
    var phi_966_: type_9;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1428_: bool;
    var phi_1429_: bool;
    var local_2: bool;
    var local_3: bool;
    var local_4: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1453_: bool;
    var phi_1454_: bool;
    var phi_1455_: bool;
    var phi_1456_: bool;
    var phi_1466_: u32;
    var phi_1467_: u32;
    var phi_1468_: bool;
    var phi_1469_: type_9;
    var phi_1519_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e36 = id_2;
    let _e37 = n_2;
    let _e38 = lane_2;
    let _e50 = ((_e36.y * _e37.x) + _e36.x);
    let _e53 = (_e37.x * _e37.y);
    let _e57 = params.member.member_2.member;
    let _e59 = params.member.member_1.member_2;
    let _e61 = input.member[0u];
    let _e63 = select(_e61, _e59, (_e59 < _e61));
    let _e65 = params.member.member_1.member_1;
    if (_e63 > _e65) {
        let _e68 = params.member.member_1.member_1;
        phi_194_ = (_e63 - _e68);
    } else {
        phi_194_ = 0u;
    }
    let _e71 = phi_194_;
    let _e73 = params.member.member_1.member;
    let _e75 = select(_e71, _e73, (_e73 < _e71));
    let _e76 = (_e75 / 128u);
    let _e80 = select(_e76, (_e76 + 1u), ((_e75 % 128u) > 0u));
    if (_e80 > _e50) {
        let _e82 = (_e80 - _e50);
        if (_e53 == 0u) {
            return;
        }
        let _e84 = (_e82 / _e53);
        if (_e53 == 0u) {
            return;
        }
        phi_239_ = select(_e84, (_e84 + 1u), ((_e82 % _e53) > 0u));
    } else {
        phi_239_ = 0u;
    }
    let _e91 = phi_239_;
    phi_242_ = type_9(0u, _e91);
    loop {
        let _e94 = phi_242_;
        let _e97 = (_e94.member < _e94.member_1);
        let _e110 = (bitcast<i32>(select(0u, 1u, _e97)) != 0i);
        if _e110 {
            let _e114 = (((_e50 + (select(type_9().member_1, _e94.member, _e97) * _e53)) * 128u) + _e38);
            if (_e38 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if (_e114 < _e75) {
                let _e119 = params.member.member_1.member_1;
                let _e121 = (2u * (_e119 + _e114));
                let _e124 = input.member[(4u + _e121)];
                let _e127 = input.member[(_e121 + 5u)];
                if (_e57 == 0u) {
                    let _e147 = params.member.member.member[1u];
                    let _e150 = ((2u * _e147) + (3u * _e127));
                    let _e152 = elements.member[_e150];
                    let _e155 = elements.member[(_e150 + 1u)];
                    let _e158 = elements.member[(_e150 + 2u)];
                    phi_405_ = type_23(0u, array<u32, 4>(_e124, _e152, _e155, _e158));
                } else {
                    let _e131 = (2u * _e124);
                    let _e133 = elements.member[_e131];
                    let _e136 = elements.member[(_e131 + 1u)];
                    let _e137 = (2u * _e127);
                    let _e139 = elements.member[_e137];
                    let _e142 = elements.member[(_e137 + 1u)];
                    phi_405_ = type_23(1u, array<u32, 4>(_e133, _e136, _e139, _e142));
                }
                let _e162 = phi_405_;
                let _e168 = (_e57 == 0u);
                let _e169 = select(_e162.member_1[2], _e162.member_1[1], _e168);
                let _e170 = select(_e162.member_1[3], _e162.member_1[2], _e168);
                let _e171 = select(_e162.member_1[1], _e162.member_1[0], _e168);
                let _e172 = select(_e162.member_1[1], _e162.member_1[0], _e168);
                if (_e57 == 0u) {
                    let _e186 = params.member.member.member_2[2u];
                    phi_442_ = array<u32, 2>(_e124, (_e186 + _e127));
                } else {
                    let _e177 = params.member.member.member_2[1u];
                    let _e181 = params.member.member.member_2[1u];
                    phi_442_ = array<u32, 2>((_e177 + _e124), (_e181 + _e127));
                }
                let _e190 = phi_442_;
                let _e194 = boxes.member[_e190[0]];
                let _e196 = boxes.member[_e190[1]];
                if (_e57 == 0u) {
                    phi_511_ = ((select((_e169 == _e162.member_1[0]), true, (_e169 == _e162.member_1[0])) || select((_e170 == _e162.member_1[0]), true, (_e170 == _e162.member_1[0]))) || select((_e162.member_1[3] == _e162.member_1[0]), true, (_e162.member_1[3] == _e162.member_1[0])));
                } else {
                    phi_511_ = (select((_e169 == _e171), true, (_e169 == _e162.member_1[0])) || select((_e170 == _e171), true, (_e170 == _e162.member_1[0])));
                }
                let _e218 = phi_511_;
                if _e218 {
                    phi_1455_ = false;
                    phi_1456_ = true;
                } else {
                    let _e220 = params.member.member.member_1;
                    if ((_e220 & 2u) != 0u) {
                        let _e224 = bodies.member[_e162.member_1[0]];
                        let _e226 = bodies.member[_e169];
                        if select(false, (((_e224 & _e226) & 1u) == 0u), select(select(true, false, ((_e224 & 2u) == 0u)), true, ((_e224 / 4u) != (_e226 / 4u)))) {
                            let _e239 = params.member.member.member_1;
                            if ((_e239 & 4u) != 0u) {
                                let _e244 = params.member.member.member[0u];
                                let _e246 = bodies.member[_e244];
                                let _e249 = bodies.member[(_e244 + 1u)];
                                let _e254 = ((_e244 + 4u) + (2u * (_e224 >> bitcast<u32>(2i))));
                                let _e259 = ((_e244 + 4u) + (2u * (_e226 >> bitcast<u32>(2i))));
                                let _e261 = bodies.member[_e254];
                                let _e263 = bodies.member[_e259];
                                let _e272 = bodies.member[((((_e244 + 4u) + (2u * _e246)) + (_e261 * _e249)) + (_e263 / 32u))];
                                let _e275 = bodies.member[(_e254 + 1u)];
                                let _e278 = bodies.member[(_e259 + 1u)];
                                if (_e275 == _e278) {
                                    phi_680_ = select(((_e224 >> bitcast<u32>(2i)) == (_e226 >> bitcast<u32>(2i))), true, (((_e272 >> bitcast<u32>(((_e263 % 32u) & 31u))) & 1u) == 1u));
                                } else {
                                    phi_680_ = false;
                                }
                                let _e293 = phi_680_;
                                if _e293 {
                                    let _e296 = bodies.member[(_e244 + 2u)];
                                    let _e299 = bodies.member[(_e244 + 3u)];
                                    let _e300 = (_e299 + _e244);
                                    let _e301 = (_e57 == 1u);
                                    let _e302 = (_e127 < _e124);
                                    let _e305 = select(_e127, select(_e127, _e124, _e302), _e301);
                                    let _e306 = select(_e124, select(_e124, _e127, _e302), _e301);
                                    phi_721_ = type_14(0i, 32i);
                                    phi_724_ = 0u;
                                    loop {
                                        let _e308 = phi_721_;
                                        let _e310 = phi_724_;
                                        local = _e310;
                                        local_1 = _e310;
                                        if (_e308.member < _e308.member_1) {
                                            let _e317 = (_e308.member + 1i);
                                            phi_722_ = type_14(select(_e317, type_15().member_1, select(false, true, ((false == (_e317 > _e308.member)) != false))), _e308.member_1);
                                            phi_765_ = type_15(1u, _e308.member);
                                        } else {
                                            phi_722_ = _e308;
                                            phi_765_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e328 = phi_722_;
                                        let _e330 = phi_765_;
                                        let _e334 = (bitcast<i32>(_e330.member) != 0i);
                                        if _e334 {
                                            let _e339 = (_e310 | (1u << bitcast<u32>(((31i - _e330.member_1) & 31i))));
                                            if (_e339 <= _e296) {
                                                let _e343 = (_e300 + (3u * (_e339 - 1u)));
                                                let _e345 = bodies.member[_e343];
                                                let _e348 = bodies.member[(_e343 + 1u)];
                                                let _e351 = bodies.member[(_e343 + 2u)];
                                                phi_844_ = select(_e310, _e339, select(select(false, select(select(false, (_e351 < _e305), (_e348 == _e306)), true, (_e348 < _e306)), (_e345 == _e57)), true, (_e345 < _e57)));
                                            } else {
                                                phi_844_ = _e310;
                                            }
                                            let _e363 = phi_844_;
                                            phi_725_ = _e363;
                                        } else {
                                            phi_725_ = u32();
                                        }
                                        let _e365 = phi_725_;
                                        continue;
                                        continuing {
                                            phi_721_ = _e328;
                                            phi_724_ = _e365;
                                            break if !(_e334);
                                        }
                                    }
                                    let _e368 = local;
                                    if (_e368 < _e296) {
                                        let _e371 = local_1;
                                        let _e373 = (_e300 + (3u * _e371));
                                        let _e375 = bodies.member[_e373];
                                        if (_e375 == _e57) {
                                            let _e379 = bodies.member[(_e373 + 1u)];
                                            if (_e379 == _e306) {
                                                let _e383 = bodies.member[(_e373 + 2u)];
                                                phi_892_ = (_e383 == _e305);
                                                phi_893_ = false;
                                            } else {
                                                phi_892_ = bool();
                                                phi_893_ = true;
                                            }
                                            let _e386 = phi_892_;
                                            let _e388 = phi_893_;
                                            phi_894_ = _e386;
                                            phi_895_ = _e388;
                                        } else {
                                            phi_894_ = bool();
                                            phi_895_ = true;
                                        }
                                        let _e390 = phi_894_;
                                        let _e392 = phi_895_;
                                        phi_900_ = select(_e390, false, _e392);
                                    } else {
                                        phi_900_ = false;
                                    }
                                    let _e395 = phi_900_;
                                    phi_904_ = _e395;
                                } else {
                                    phi_904_ = true;
                                }
                                let _e397 = phi_904_;
                                phi_909_ = select(true, false, _e397);
                            } else {
                                phi_909_ = true;
                            }
                            let _e400 = phi_909_;
                            phi_914_ = select(true, false, _e400);
                        } else {
                            phi_914_ = true;
                        }
                        let _e403 = phi_914_;
                        phi_919_ = select(true, false, _e403);
                    } else {
                        phi_919_ = true;
                    }
                    let _e406 = phi_919_;
                    if _e406 {
                        let _e408 = params.member.member.member_1;
                        if ((_e408 & 32u) != 0u) {
                            let _e412 = params.member.member.member_6;
                            let _e453 = (((((_e194.member_1[0] - _e196.member[0]) > _e412) && ((_e196.member_1[0] - _e194.member[0]) > _e412)) && (((_e194.member_1[1] - _e196.member[1]) > _e412) && ((_e196.member_1[1] - _e194.member[1]) > _e412))) && (((_e194.member_1[2] - _e196.member[2]) > _e412) && ((_e196.member_1[2] - _e194.member[2]) > _e412)));
                            if _e453 {
                                phi_1446_ = bool();
                            } else {
                                phi_966_ = type_9(0u, 3u);
                                loop {
                                    let _e455 = phi_966_;
                                    let _e458 = (_e455.member < _e455.member_1);
                                    let _e469 = select(type_9().member_1, _e455.member, _e458);
                                    if (bitcast<i32>(select(0u, 1u, _e458)) != 0i) {
                                        let _e473 = ((6u * _e162.member_1[0]) + _e469);
                                        let _e476 = keys.member[(2u * _e473)];
                                        let _e480 = keys.member[((2u * _e473) + 1u)];
                                        let _e483 = ((6u * _e171) + _e469);
                                        let _e486 = keys.member[(2u * _e483)];
                                        let _e490 = keys.member[((2u * _e483) + 1u)];
                                        let _e492 = function_(array<u32, 2>(_e476, _e480), array<u32, 2>(_e486, _e490));
                                        let _e494 = ((6u * _e172) + _e469);
                                        let _e497 = keys.member[(2u * _e494)];
                                        let _e501 = keys.member[((2u * _e494) + 1u)];
                                        let _e503 = function_(_e492, array<u32, 2>(_e497, _e501));
                                        let _e506 = (((6u * _e169) + 3u) + _e469);
                                        let _e509 = keys.member[(2u * _e506)];
                                        let _e513 = keys.member[((2u * _e506) + 1u)];
                                        let _e517 = (((6u * _e170) + 3u) + _e469);
                                        let _e520 = keys.member[(2u * _e517)];
                                        let _e524 = keys.member[((2u * _e517) + 1u)];
                                        let _e526 = function_1(array<u32, 2>(_e509, _e513), array<u32, 2>(_e520, _e524));
                                        let _e529 = (((6u * _e162.member_1[3]) + 3u) + _e469);
                                        let _e532 = keys.member[(2u * _e529)];
                                        let _e536 = keys.member[((2u * _e529) + 1u)];
                                        let _e538 = function_1(_e526, array<u32, 2>(_e532, _e536));
                                        let _e549 = select(select(false, (_e503[0] > _e538[0]), (_e503[1] == _e538[1])), true, (_e503[1] > _e538[1]));
                                        if _e549 {
                                            phi_1425_ = false;
                                            phi_1426_ = false;
                                        } else {
                                            let _e551 = ((6u * _e169) + _e469);
                                            let _e554 = keys.member[(2u * _e551)];
                                            let _e558 = keys.member[((2u * _e551) + 1u)];
                                            let _e561 = ((6u * _e170) + _e469);
                                            let _e564 = keys.member[(2u * _e561)];
                                            let _e568 = keys.member[((2u * _e561) + 1u)];
                                            let _e570 = function_(array<u32, 2>(_e554, _e558), array<u32, 2>(_e564, _e568));
                                            let _e572 = ((6u * _e162.member_1[3]) + _e469);
                                            let _e575 = keys.member[(2u * _e572)];
                                            let _e579 = keys.member[((2u * _e572) + 1u)];
                                            let _e581 = function_(_e570, array<u32, 2>(_e575, _e579));
                                            let _e584 = (((6u * _e162.member_1[0]) + 3u) + _e469);
                                            let _e587 = keys.member[(2u * _e584)];
                                            let _e591 = keys.member[((2u * _e584) + 1u)];
                                            let _e595 = (((6u * _e171) + 3u) + _e469);
                                            let _e598 = keys.member[(2u * _e595)];
                                            let _e602 = keys.member[((2u * _e595) + 1u)];
                                            let _e604 = function_1(array<u32, 2>(_e587, _e591), array<u32, 2>(_e598, _e602));
                                            let _e607 = (((6u * _e172) + 3u) + _e469);
                                            let _e610 = keys.member[(2u * _e607)];
                                            let _e614 = keys.member[((2u * _e607) + 1u)];
                                            let _e616 = function_1(_e604, array<u32, 2>(_e610, _e614));
                                            let _e627 = select(select(false, (_e581[0] > _e616[0]), (_e581[1] == _e616[1])), true, (_e581[1] > _e616[1]));
                                            phi_1425_ = select(true, false, _e627);
                                            phi_1426_ = _e627;
                                        }
                                        let _e630 = phi_1425_;
                                        let _e632 = phi_1426_;
                                        phi_1427_ = _e630;
                                        phi_1428_ = _e549;
                                        phi_1429_ = _e632;
                                    } else {
                                        phi_1427_ = false;
                                        phi_1428_ = false;
                                        phi_1429_ = false;
                                    }
                                    let _e634 = phi_1427_;
                                    let _e636 = phi_1428_;
                                    let _e638 = phi_1429_;
                                    local_2 = _e636;
                                    local_3 = _e638;
                                    local_4 = _e636;
                                    continue;
                                    continuing {
                                        phi_966_ = type_9(select(_e455.member, (_e455.member + 1u), _e458), select(_e455.member_1, _e455.member_1, _e458));
                                        break if !(_e634);
                                    }
                                }
                                let _e641 = local_2;
                                let _e643 = local_3;
                                let _e646 = local_4;
                                phi_1446_ = select(false, true, select(true, false, select(_e646, true, select(_e643, false, _e641))));
                            }
                            let _e651 = phi_1446_;
                            phi_1447_ = _e651;
                            phi_1448_ = _e453;
                        } else {
                            phi_1447_ = bool();
                            phi_1448_ = true;
                        }
                        let _e653 = phi_1447_;
                        let _e655 = phi_1448_;
                        phi_1453_ = _e653;
                        phi_1454_ = select(true, false, _e655);
                    } else {
                        phi_1453_ = false;
                        phi_1454_ = true;
                    }
                    let _e658 = phi_1453_;
                    let _e660 = phi_1454_;
                    phi_1455_ = _e658;
                    phi_1456_ = _e660;
                }
                let _e662 = phi_1455_;
                let _e664 = phi_1456_;
                let _e665 = select(true, _e662, _e664);
                if _e665 {
                    let _e667 = atomicAdd((&counters[0u]), 1u);
                    phi_1466_ = _e667;
                } else {
                    phi_1466_ = 0u;
                }
                let _e669 = phi_1466_;
                phi_1467_ = _e669;
                phi_1468_ = _e665;
                phi_1469_ = type_9(_e124, _e127);
            } else {
                phi_1467_ = 0u;
                phi_1468_ = false;
                phi_1469_ = type_9(0u, 0u);
            }
            let _e671 = phi_1467_;
            let _e673 = phi_1468_;
            let _e675 = phi_1469_;
            workgroupBarrier();
            if (_e38 == 0u) {
                let _e678 = atomicLoad((&counters[0u]));
                if (_e678 > 0u) {
                    let _e682 = params.member.member.member_1;
                    if ((_e682 & 1024u) != 0u) {
                        let _e692 = atomicAdd((&output.member[0u]), _e678);
                        let _e693 = (_e692 + _e678);
                        let _e695 = select(_e693, 4294967295u, (_e693 < _e692));
                        let _e698 = params.member.member_1.member_3;
                        if (_e695 > _e698) {
                            let _e701 = atomicMax((&output.member[2u]), _e695);
                        }
                        phi_1519_ = _e692;
                    } else {
                        let _e686 = atomicAdd((&output.member[0u]), _e678);
                        if ((_e686 + _e678) < _e686) {
                            let _e690 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_1519_ = _e686;
                    }
                    let _e703 = phi_1519_;
                    atomicStore((&counters[1u]), _e703);
                    let _e706 = atomicAdd((&output.member[1u]), _e678);
                    if ((_e706 + _e678) < _e706) {
                        let _e710 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e673 {
                let _e712 = params.member.member_1.member_3;
                let _e714 = atomicLoad((&counters[1u]));
                let _e715 = (_e714 + _e671);
                if (_e715 < _e712) {
                    let _e719 = (2u * _e715);
                    atomicStore((&output.member[(4u + _e719)]), _e675.member);
                    atomicStore((&output.member[(_e719 + 5u)]), _e675.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_242_ = type_9(select(_e94.member, (_e94.member + 1u), _e97), select(_e94.member_1, _e94.member_1, _e97));
            break if !(_e110);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
