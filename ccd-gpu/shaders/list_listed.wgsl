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
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_688_: bool;
    var phi_729_: type_14;
    var phi_732_: u32;
    var phi_730_: type_14;
    var phi_773_: type_15;
    var phi_852_: u32;
    var phi_733_: u32;
    var local: u32;
    var local_1: u32;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_917_: bool;
    var phi_922_: bool;
    var phi_927_: bool;
    var phi_974_: type_9;
    var phi_1433_: bool;
    var phi_1434_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var local_2: bool;
    var local_3: bool;
    var local_4: bool;
    var phi_1454_: bool;
    var phi_1455_: bool;
    var phi_1456_: bool;
    var phi_1461_: bool;
    var phi_1462_: bool;
    var phi_1463_: bool;
    var phi_1464_: bool;
    var phi_1474_: u32;
    var phi_1475_: u32;
    var phi_1476_: bool;
    var phi_1477_: type_9;
    var phi_1527_: u32;
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
                let _e199 = params.member.member.member_1;
                if ((_e199 & 1u) != 0u) {
                    if (_e57 == 0u) {
                        phi_518_ = ((select((_e169 == _e162.member_1[0]), true, (_e169 == _e162.member_1[0])) || select((_e170 == _e162.member_1[0]), true, (_e170 == _e162.member_1[0]))) || select((_e162.member_1[3] == _e162.member_1[0]), true, (_e162.member_1[3] == _e162.member_1[0])));
                    } else {
                        phi_518_ = (select((_e169 == _e171), true, (_e169 == _e162.member_1[0])) || select((_e170 == _e171), true, (_e170 == _e162.member_1[0])));
                    }
                    let _e222 = phi_518_;
                    phi_519_ = _e222;
                } else {
                    phi_519_ = false;
                }
                let _e224 = phi_519_;
                if _e224 {
                    phi_1463_ = false;
                    phi_1464_ = true;
                } else {
                    let _e226 = params.member.member.member_1;
                    if ((_e226 & 2u) != 0u) {
                        let _e230 = bodies.member[_e162.member_1[0]];
                        let _e232 = bodies.member[_e169];
                        if select(false, (((_e230 & _e232) & 1u) == 0u), select(select(true, false, ((_e230 & 2u) == 0u)), true, ((_e230 / 4u) != (_e232 / 4u)))) {
                            let _e245 = params.member.member.member_1;
                            if ((_e245 & 4u) != 0u) {
                                let _e250 = params.member.member.member[0u];
                                let _e252 = bodies.member[_e250];
                                let _e255 = bodies.member[(_e250 + 1u)];
                                let _e260 = ((_e250 + 4u) + (2u * (_e230 >> bitcast<u32>(2i))));
                                let _e265 = ((_e250 + 4u) + (2u * (_e232 >> bitcast<u32>(2i))));
                                let _e267 = bodies.member[_e260];
                                let _e269 = bodies.member[_e265];
                                let _e278 = bodies.member[((((_e250 + 4u) + (2u * _e252)) + (_e267 * _e255)) + (_e269 / 32u))];
                                let _e281 = bodies.member[(_e260 + 1u)];
                                let _e284 = bodies.member[(_e265 + 1u)];
                                if (_e281 == _e284) {
                                    phi_688_ = select(((_e230 >> bitcast<u32>(2i)) == (_e232 >> bitcast<u32>(2i))), true, (((_e278 >> bitcast<u32>(((_e269 % 32u) & 31u))) & 1u) == 1u));
                                } else {
                                    phi_688_ = false;
                                }
                                let _e299 = phi_688_;
                                if _e299 {
                                    let _e302 = bodies.member[(_e250 + 2u)];
                                    let _e305 = bodies.member[(_e250 + 3u)];
                                    let _e306 = (_e305 + _e250);
                                    let _e307 = (_e57 == 1u);
                                    let _e308 = (_e127 < _e124);
                                    let _e311 = select(_e127, select(_e127, _e124, _e308), _e307);
                                    let _e312 = select(_e124, select(_e124, _e127, _e308), _e307);
                                    phi_729_ = type_14(0i, 32i);
                                    phi_732_ = 0u;
                                    loop {
                                        let _e314 = phi_729_;
                                        let _e316 = phi_732_;
                                        local = _e316;
                                        local_1 = _e316;
                                        if (_e314.member < _e314.member_1) {
                                            let _e323 = (_e314.member + 1i);
                                            phi_730_ = type_14(select(_e323, type_15().member_1, select(false, true, ((false == (_e323 > _e314.member)) != false))), _e314.member_1);
                                            phi_773_ = type_15(1u, _e314.member);
                                        } else {
                                            phi_730_ = _e314;
                                            phi_773_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e334 = phi_730_;
                                        let _e336 = phi_773_;
                                        let _e340 = (bitcast<i32>(_e336.member) != 0i);
                                        if _e340 {
                                            let _e345 = (_e316 | (1u << bitcast<u32>(((31i - _e336.member_1) & 31i))));
                                            if (_e345 <= _e302) {
                                                let _e349 = (_e306 + (3u * (_e345 - 1u)));
                                                let _e351 = bodies.member[_e349];
                                                let _e354 = bodies.member[(_e349 + 1u)];
                                                let _e357 = bodies.member[(_e349 + 2u)];
                                                phi_852_ = select(_e316, _e345, select(select(false, select(select(false, (_e357 < _e311), (_e354 == _e312)), true, (_e354 < _e312)), (_e351 == _e57)), true, (_e351 < _e57)));
                                            } else {
                                                phi_852_ = _e316;
                                            }
                                            let _e369 = phi_852_;
                                            phi_733_ = _e369;
                                        } else {
                                            phi_733_ = u32();
                                        }
                                        let _e371 = phi_733_;
                                        continue;
                                        continuing {
                                            phi_729_ = _e334;
                                            phi_732_ = _e371;
                                            break if !(_e340);
                                        }
                                    }
                                    let _e374 = local;
                                    if (_e374 < _e302) {
                                        let _e377 = local_1;
                                        let _e379 = (_e306 + (3u * _e377));
                                        let _e381 = bodies.member[_e379];
                                        if (_e381 == _e57) {
                                            let _e385 = bodies.member[(_e379 + 1u)];
                                            if (_e385 == _e312) {
                                                let _e389 = bodies.member[(_e379 + 2u)];
                                                phi_900_ = (_e389 == _e311);
                                                phi_901_ = false;
                                            } else {
                                                phi_900_ = bool();
                                                phi_901_ = true;
                                            }
                                            let _e392 = phi_900_;
                                            let _e394 = phi_901_;
                                            phi_902_ = _e392;
                                            phi_903_ = _e394;
                                        } else {
                                            phi_902_ = bool();
                                            phi_903_ = true;
                                        }
                                        let _e396 = phi_902_;
                                        let _e398 = phi_903_;
                                        phi_908_ = select(_e396, false, _e398);
                                    } else {
                                        phi_908_ = false;
                                    }
                                    let _e401 = phi_908_;
                                    phi_912_ = _e401;
                                } else {
                                    phi_912_ = true;
                                }
                                let _e403 = phi_912_;
                                phi_917_ = select(true, false, _e403);
                            } else {
                                phi_917_ = true;
                            }
                            let _e406 = phi_917_;
                            phi_922_ = select(true, false, _e406);
                        } else {
                            phi_922_ = true;
                        }
                        let _e409 = phi_922_;
                        phi_927_ = select(true, false, _e409);
                    } else {
                        phi_927_ = true;
                    }
                    let _e412 = phi_927_;
                    if _e412 {
                        let _e414 = params.member.member.member_1;
                        if ((_e414 & 32u) != 0u) {
                            let _e418 = params.member.member.member_6;
                            let _e459 = (((((_e194.member_1[0] - _e196.member[0]) > _e418) && ((_e196.member_1[0] - _e194.member[0]) > _e418)) && (((_e194.member_1[1] - _e196.member[1]) > _e418) && ((_e196.member_1[1] - _e194.member[1]) > _e418))) && (((_e194.member_1[2] - _e196.member[2]) > _e418) && ((_e196.member_1[2] - _e194.member[2]) > _e418)));
                            if _e459 {
                                phi_1454_ = bool();
                            } else {
                                phi_974_ = type_9(0u, 3u);
                                loop {
                                    let _e461 = phi_974_;
                                    let _e464 = (_e461.member < _e461.member_1);
                                    let _e475 = select(type_9().member_1, _e461.member, _e464);
                                    if (bitcast<i32>(select(0u, 1u, _e464)) != 0i) {
                                        let _e479 = ((6u * _e162.member_1[0]) + _e475);
                                        let _e482 = keys.member[(2u * _e479)];
                                        let _e486 = keys.member[((2u * _e479) + 1u)];
                                        let _e489 = ((6u * _e171) + _e475);
                                        let _e492 = keys.member[(2u * _e489)];
                                        let _e496 = keys.member[((2u * _e489) + 1u)];
                                        let _e498 = function_(array<u32, 2>(_e482, _e486), array<u32, 2>(_e492, _e496));
                                        let _e500 = ((6u * _e172) + _e475);
                                        let _e503 = keys.member[(2u * _e500)];
                                        let _e507 = keys.member[((2u * _e500) + 1u)];
                                        let _e509 = function_(_e498, array<u32, 2>(_e503, _e507));
                                        let _e512 = (((6u * _e169) + 3u) + _e475);
                                        let _e515 = keys.member[(2u * _e512)];
                                        let _e519 = keys.member[((2u * _e512) + 1u)];
                                        let _e523 = (((6u * _e170) + 3u) + _e475);
                                        let _e526 = keys.member[(2u * _e523)];
                                        let _e530 = keys.member[((2u * _e523) + 1u)];
                                        let _e532 = function_1(array<u32, 2>(_e515, _e519), array<u32, 2>(_e526, _e530));
                                        let _e535 = (((6u * _e162.member_1[3]) + 3u) + _e475);
                                        let _e538 = keys.member[(2u * _e535)];
                                        let _e542 = keys.member[((2u * _e535) + 1u)];
                                        let _e544 = function_1(_e532, array<u32, 2>(_e538, _e542));
                                        let _e555 = select(select(false, (_e509[0] > _e544[0]), (_e509[1] == _e544[1])), true, (_e509[1] > _e544[1]));
                                        if _e555 {
                                            phi_1433_ = false;
                                            phi_1434_ = false;
                                        } else {
                                            let _e557 = ((6u * _e169) + _e475);
                                            let _e560 = keys.member[(2u * _e557)];
                                            let _e564 = keys.member[((2u * _e557) + 1u)];
                                            let _e567 = ((6u * _e170) + _e475);
                                            let _e570 = keys.member[(2u * _e567)];
                                            let _e574 = keys.member[((2u * _e567) + 1u)];
                                            let _e576 = function_(array<u32, 2>(_e560, _e564), array<u32, 2>(_e570, _e574));
                                            let _e578 = ((6u * _e162.member_1[3]) + _e475);
                                            let _e581 = keys.member[(2u * _e578)];
                                            let _e585 = keys.member[((2u * _e578) + 1u)];
                                            let _e587 = function_(_e576, array<u32, 2>(_e581, _e585));
                                            let _e590 = (((6u * _e162.member_1[0]) + 3u) + _e475);
                                            let _e593 = keys.member[(2u * _e590)];
                                            let _e597 = keys.member[((2u * _e590) + 1u)];
                                            let _e601 = (((6u * _e171) + 3u) + _e475);
                                            let _e604 = keys.member[(2u * _e601)];
                                            let _e608 = keys.member[((2u * _e601) + 1u)];
                                            let _e610 = function_1(array<u32, 2>(_e593, _e597), array<u32, 2>(_e604, _e608));
                                            let _e613 = (((6u * _e172) + 3u) + _e475);
                                            let _e616 = keys.member[(2u * _e613)];
                                            let _e620 = keys.member[((2u * _e613) + 1u)];
                                            let _e622 = function_1(_e610, array<u32, 2>(_e616, _e620));
                                            let _e633 = select(select(false, (_e587[0] > _e622[0]), (_e587[1] == _e622[1])), true, (_e587[1] > _e622[1]));
                                            phi_1433_ = select(true, false, _e633);
                                            phi_1434_ = _e633;
                                        }
                                        let _e636 = phi_1433_;
                                        let _e638 = phi_1434_;
                                        phi_1435_ = _e636;
                                        phi_1436_ = _e555;
                                        phi_1437_ = _e638;
                                    } else {
                                        phi_1435_ = false;
                                        phi_1436_ = false;
                                        phi_1437_ = false;
                                    }
                                    let _e640 = phi_1435_;
                                    let _e642 = phi_1436_;
                                    let _e644 = phi_1437_;
                                    local_2 = _e642;
                                    local_3 = _e644;
                                    local_4 = _e642;
                                    continue;
                                    continuing {
                                        phi_974_ = type_9(select(_e461.member, (_e461.member + 1u), _e464), select(_e461.member_1, _e461.member_1, _e464));
                                        break if !(_e640);
                                    }
                                }
                                let _e647 = local_2;
                                let _e649 = local_3;
                                let _e652 = local_4;
                                phi_1454_ = select(false, true, select(true, false, select(_e652, true, select(_e649, false, _e647))));
                            }
                            let _e657 = phi_1454_;
                            phi_1455_ = _e657;
                            phi_1456_ = _e459;
                        } else {
                            phi_1455_ = bool();
                            phi_1456_ = true;
                        }
                        let _e659 = phi_1455_;
                        let _e661 = phi_1456_;
                        phi_1461_ = _e659;
                        phi_1462_ = select(true, false, _e661);
                    } else {
                        phi_1461_ = false;
                        phi_1462_ = true;
                    }
                    let _e664 = phi_1461_;
                    let _e666 = phi_1462_;
                    phi_1463_ = _e664;
                    phi_1464_ = _e666;
                }
                let _e668 = phi_1463_;
                let _e670 = phi_1464_;
                let _e671 = select(true, _e668, _e670);
                if _e671 {
                    let _e673 = atomicAdd((&counters[0u]), 1u);
                    phi_1474_ = _e673;
                } else {
                    phi_1474_ = 0u;
                }
                let _e675 = phi_1474_;
                phi_1475_ = _e675;
                phi_1476_ = _e671;
                phi_1477_ = type_9(_e124, _e127);
            } else {
                phi_1475_ = 0u;
                phi_1476_ = false;
                phi_1477_ = type_9(0u, 0u);
            }
            let _e677 = phi_1475_;
            let _e679 = phi_1476_;
            let _e681 = phi_1477_;
            workgroupBarrier();
            if (_e38 == 0u) {
                let _e684 = atomicLoad((&counters[0u]));
                if (_e684 > 0u) {
                    let _e688 = params.member.member.member_1;
                    if ((_e688 & 1024u) != 0u) {
                        let _e698 = atomicAdd((&output.member[0u]), _e684);
                        let _e699 = (_e698 + _e684);
                        let _e701 = select(_e699, 4294967295u, (_e699 < _e698));
                        let _e704 = params.member.member_1.member_3;
                        if (_e701 > _e704) {
                            let _e707 = atomicMax((&output.member[2u]), _e701);
                        }
                        phi_1527_ = _e698;
                    } else {
                        let _e692 = atomicAdd((&output.member[0u]), _e684);
                        if ((_e692 + _e684) < _e692) {
                            let _e696 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_1527_ = _e692;
                    }
                    let _e709 = phi_1527_;
                    atomicStore((&counters[1u]), _e709);
                    let _e712 = atomicAdd((&output.member[1u]), _e684);
                    if ((_e712 + _e684) < _e712) {
                        let _e716 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e679 {
                let _e718 = params.member.member_1.member_3;
                let _e720 = atomicLoad((&counters[1u]));
                let _e721 = (_e720 + _e677);
                if (_e721 < _e718) {
                    let _e725 = (2u * _e721);
                    atomicStore((&output.member[(4u + _e725)]), _e681.member);
                    atomicStore((&output.member[(_e725 + 5u)]), _e681.member_1);
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
