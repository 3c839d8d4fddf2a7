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

struct type_15 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_27 {
    member: array<array<f64, 3>>,
}

struct type_28 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_31 {
    member: array<array<array<u32, 2>, 6>>,
}

@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(1) 
var<storage> positions: type_27;
@group(0) @binding(2) 
var<storage, read_write> paths: type_17;
@group(0) @binding(3) 
var<storage, read_write> keys: type_31;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_21;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var local_1: type_19;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_15;
    var local_5: type_28;
    var local_6: array<f64, 3>;
    var local_7: array<f64, 3>;
    var local_8: type_28;
    var local_9: type_28;
    var phi_194_: type_9;
    var phi_333_: type_9;
    var phi_493_: type_9;
    var phi_604_: bool;
    var phi_605_: u32;
    var phi_606_: bool;
    var phi_607_: u32;
    var phi_608_: bool;
    var phi_609_: u32;
    var phi_610_: bool;
    var phi_611_: u32;
    var phi_672_: bool;
    var phi_673_: u32;
    var phi_674_: bool;
    var phi_675_: u32;
    var phi_676_: bool;
    var phi_677_: u32;
    var phi_678_: bool;
    var phi_679_: u32;
    var phi_784_: bool;
    var phi_785_: u32;
    var phi_786_: bool;
    var phi_787_: u32;
    var phi_788_: bool;
    var phi_789_: u32;
    var phi_790_: bool;
    var phi_791_: u32;
    var phi_852_: bool;
    var phi_853_: u32;
    var phi_854_: bool;
    var phi_855_: u32;
    var phi_856_: bool;
    var phi_857_: u32;
    var phi_858_: bool;
    var phi_859_: u32;
    var phi_1063_: type_9;
    var phi_1148_: bool;
    var phi_1149_: u32;
    var phi_1150_: bool;
    var phi_1151_: u32;
    var phi_1152_: bool;
    var phi_1153_: u32;
    var phi_1154_: bool;
    var phi_1155_: u32;
    var phi_1241_: bool;
    var phi_1242_: u32;
    var phi_1243_: bool;
    var phi_1244_: u32;
    var phi_1245_: bool;
    var phi_1246_: u32;
    var phi_1247_: bool;
    var phi_1248_: u32;
    var phi_1306_: type_9;
    var phi_1387_: f32;
    var phi_1444_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e54 = id_2;
    let _e55 = n_2;
    let _e56 = lane_2;
    let _e68 = ((((_e54.y * _e55.x) + _e54.x) * 256u) + _e56);
    let _e72 = params.member.member.member[0u];
    if (_e68 < _e72) {
        let _e76 = positions.member[_e68];
        let _e79 = params.member.member.member[0u];
        let _e82 = positions.member[(_e79 + _e68)];
        local_6 = array<f64, 3>(_e76[0], _e76[1], _e76[2]);
        local_7 = array<f64, 3>(_e82[0], _e82[1], _e82[2]);
        let _e93 = local_6;
        local_8.member = _e93;
        let _e95 = local_7;
        local_8.member_1 = _e95;
        phi_194_ = type_9(0u, 3u);
        loop {
            let _e97 = phi_194_;
            let _e100 = (_e97.member < _e97.member_1);
            let _e111 = select(type_9().member_1, _e97.member, _e100);
            let _e113 = (bitcast<i32>(select(0u, 1u, _e100)) != 0i);
            if _e113 {
                let _e115 = local_6[_e111];
                let _e116 = bitcast<u64>(_e115);
                let _e117 = u32(_e116);
                let _e119 = u32((_e116 / 4294967296lu));
                let _e129 = (0u - select(0u, 1u, (((_e119 >> bitcast<u32>(31i)) == 1u) && !(((_e119 == 2147483648u) && (_e117 == 0u))))));
                let _e134 = ((_e119 ^ _e129) | (~(_e129) & 2147483648u));
                let _e136 = local_7[_e111];
                let _e137 = bitcast<u64>(_e136);
                let _e138 = u32(_e137);
                let _e140 = u32((_e137 / 4294967296lu));
                let _e150 = (0u - select(0u, 1u, (((_e140 >> bitcast<u32>(31i)) == 1u) && !(((_e140 == 2147483648u) && (_e138 == 0u))))));
                let _e155 = ((_e140 ^ _e150) | (~(_e150) & 2147483648u));
                if select(select(false, ((_e117 ^ _e129) > (_e138 ^ _e150)), (_e134 == _e155)), true, (_e134 > _e155)) {
                    let _e162 = local_7[_e111];
                    local_8.member[_e111] = _e162;
                    let _e166 = local_6[_e111];
                    local_8.member_1[_e111] = _e166;
                }
            }
            continue;
            continuing {
                phi_194_ = type_9(select(_e97.member, (_e97.member + 1u), _e100), select(_e97.member_1, _e97.member_1, _e100));
                break if !(_e113);
            }
        }
        let _e171 = params.member.member.member_9;
        let _e178 = bitcast<f64>(((u64(_e171[1]) * 4294967296lu) + u64(_e171[0])));
        if (_e178 > f64(0f)) {
            let _e182 = local_8;
            local_5 = _e182;
            phi_333_ = type_9(0u, 3u);
            loop {
                let _e184 = phi_333_;
                let _e187 = (_e184.member < _e184.member_1);
                let _e198 = select(type_9().member_1, _e184.member, _e187);
                let _e200 = (bitcast<i32>(select(0u, 1u, _e187)) != 0i);
                if _e200 {
                    let _e203 = local_5.member[_e198];
                    let _e205 = -((_e203 - _e178));
                    let _e206 = bitcast<u64>(_e205);
                    local_5.member[_e198] = -(select(_e205, select(select(5e-324lf, bitcast<f64>((_e206 - 1lu)), (_e205 < 0.0lf)), bitcast<f64>((_e206 + 1lu)), (_e205 > 0.0lf)), select(true, (_e205 < 0.0lf), ((_e206 & 9218868437227405312lu) == 9218868437227405312lu))));
                    let _e225 = local_5.member_1[_e198];
                    let _e226 = (_e225 + _e178);
                    let _e227 = bitcast<u64>(_e226);
                    local_5.member_1[_e198] = select(_e226, select(select(5e-324lf, bitcast<f64>((_e227 - 1lu)), (_e226 < 0.0lf)), bitcast<f64>((_e227 + 1lu)), (_e226 > 0.0lf)), select(true, (_e226 < 0.0lf), ((_e227 & 9218868437227405312lu) == 9218868437227405312lu)));
                }
                continue;
                continuing {
                    phi_333_ = type_9(select(_e184.member, (_e184.member + 1u), _e187), select(_e184.member_1, _e184.member_1, _e187));
                    break if !(_e200);
                }
            }
        } else {
            let _e181 = local_8;
            local_5 = _e181;
        }
        let _e244 = local_5;
        local_9 = _e244;
        local_2 = array<f64, 3>(_e76[0], _e76[1], _e76[2]);
        local_3 = array<f64, 3>(_e82[0], _e82[1], _e82[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_493_ = type_9(0u, 3u);
        loop {
            let _e257 = phi_493_;
            let _e260 = (_e257.member < _e257.member_1);
            let _e271 = select(type_9().member_1, _e257.member, _e260);
            let _e273 = (bitcast<i32>(select(0u, 1u, _e260)) != 0i);
            if _e273 {
                let _e276 = params.member.member.member_8[_e271];
                let _e283 = bitcast<f64>(((u64(_e276[1]) * 4294967296lu) + u64(_e276[0])));
                let _e285 = params.member.member.member_10;
                let _e292 = bitcast<f64>(((u64(_e285[1]) * 4294967296lu) + u64(_e285[0])));
                let _e294 = local_2[_e271];
                let _e296 = ((_e294 - _e283) * _e292);
                let _e297 = bitcast<u64>(_e296);
                let _e298 = u32(_e297);
                let _e300 = u32((_e297 / 4294967296lu));
                let _e301 = (_e300 & 2147483648u);
                let _e304 = ((_e300 >> bitcast<u32>(20i)) & 2047u);
                let _e310 = (((_e300 & 1048575u) << bitcast<u32>(3i)) | (_e298 >> bitcast<u32>(29i)));
                let _e311 = (_e298 & 536870911u);
                if (_e304 == 2047u) {
                    phi_610_ = false;
                    phi_611_ = (2139095040u | _e310);
                } else {
                    if (_e304 > 1150u) {
                        phi_608_ = true;
                        phi_609_ = 2139095039u;
                    } else {
                        if (_e304 > 896u) {
                            phi_606_ = (_e311 != 0u);
                            phi_607_ = (((_e304 - 896u) << bitcast<u32>(23i)) | _e310);
                        } else {
                            if (_e304 >= 873u) {
                                let _e319 = (8388608u | _e310);
                                let _e320 = (897u - _e304);
                                phi_604_ = (((_e319 & ((1u << bitcast<u32>((_e320 & 31u))) - 1u)) | _e311) != 0u);
                                phi_605_ = (_e319 >> bitcast<u32>((_e320 & 31u)));
                            } else {
                                phi_604_ = (((_e300 & 2147483647u) | _e298) != 0u);
                                phi_605_ = 0u;
                            }
                            let _e332 = phi_604_;
                            let _e334 = phi_605_;
                            phi_606_ = _e332;
                            phi_607_ = _e334;
                        }
                        let _e341 = phi_606_;
                        let _e343 = phi_607_;
                        phi_608_ = _e341;
                        phi_609_ = _e343;
                    }
                    let _e345 = phi_608_;
                    let _e347 = phi_609_;
                    phi_610_ = _e345;
                    phi_611_ = _e347;
                }
                let _e350 = phi_610_;
                let _e352 = phi_611_;
                let _e360 = select(bitcast<f32>(((_e301 | _e352) + select(0u, 1u, _e350))), bitcast<f32>((_e301 | _e352)), (_e301 == 0u));
                let _e361 = bitcast<u64>(_e296);
                let _e362 = u32(_e361);
                let _e364 = u32((_e361 / 4294967296lu));
                let _e365 = (_e364 & 2147483648u);
                let _e368 = ((_e364 >> bitcast<u32>(20i)) & 2047u);
                let _e374 = (((_e364 & 1048575u) << bitcast<u32>(3i)) | (_e362 >> bitcast<u32>(29i)));
                let _e375 = (_e362 & 536870911u);
                if (_e368 == 2047u) {
                    phi_678_ = false;
                    phi_679_ = (2139095040u | _e374);
                } else {
                    if (_e368 > 1150u) {
                        phi_676_ = true;
                        phi_677_ = 2139095039u;
                    } else {
                        if (_e368 > 896u) {
                            phi_674_ = (_e375 != 0u);
                            phi_675_ = (((_e368 - 896u) << bitcast<u32>(23i)) | _e374);
                        } else {
                            if (_e368 >= 873u) {
                                let _e383 = (8388608u | _e374);
                                let _e384 = (897u - _e368);
                                phi_672_ = (((_e383 & ((1u << bitcast<u32>((_e384 & 31u))) - 1u)) | _e375) != 0u);
                                phi_673_ = (_e383 >> bitcast<u32>((_e384 & 31u)));
                            } else {
                                phi_672_ = (((_e364 & 2147483647u) | _e362) != 0u);
                                phi_673_ = 0u;
                            }
                            let _e396 = phi_672_;
                            let _e398 = phi_673_;
                            phi_674_ = _e396;
                            phi_675_ = _e398;
                        }
                        let _e405 = phi_674_;
                        let _e407 = phi_675_;
                        phi_676_ = _e405;
                        phi_677_ = _e407;
                    }
                    let _e409 = phi_676_;
                    let _e411 = phi_677_;
                    phi_678_ = _e409;
                    phi_679_ = _e411;
                }
                let _e414 = phi_678_;
                let _e416 = phi_679_;
                let _e424 = select(bitcast<f32>((_e365 | _e416)), bitcast<f32>(((_e365 | _e416) + select(0u, 1u, _e414))), (_e365 == 0u));
                let _e426 = (_e296 - f64(_e360));
                let _e428 = (f64(_e424) - _e296);
                local_4.member[_e271] = select(_e424, _e360, select(select(true, false, select(true, select(true, false, ((bitcast<u32>(_e360) & 1u) == 0u)), (_e426 == _e428))), true, (_e426 < _e428)));
                let _e442 = local_3[_e271];
                let _e444 = ((_e442 - _e283) * _e292);
                let _e445 = bitcast<u64>(_e444);
                let _e446 = u32(_e445);
                let _e448 = u32((_e445 / 4294967296lu));
                let _e449 = (_e448 & 2147483648u);
                let _e452 = ((_e448 >> bitcast<u32>(20i)) & 2047u);
                let _e458 = (((_e448 & 1048575u) << bitcast<u32>(3i)) | (_e446 >> bitcast<u32>(29i)));
                let _e459 = (_e446 & 536870911u);
                if (_e452 == 2047u) {
                    phi_790_ = false;
                    phi_791_ = (2139095040u | _e458);
                } else {
                    if (_e452 > 1150u) {
                        phi_788_ = true;
                        phi_789_ = 2139095039u;
                    } else {
                        if (_e452 > 896u) {
                            phi_786_ = (_e459 != 0u);
                            phi_787_ = (((_e452 - 896u) << bitcast<u32>(23i)) | _e458);
                        } else {
                            if (_e452 >= 873u) {
                                let _e467 = (8388608u | _e458);
                                let _e468 = (897u - _e452);
                                phi_784_ = (((_e467 & ((1u << bitcast<u32>((_e468 & 31u))) - 1u)) | _e459) != 0u);
                                phi_785_ = (_e467 >> bitcast<u32>((_e468 & 31u)));
                            } else {
                                phi_784_ = (((_e448 & 2147483647u) | _e446) != 0u);
                                phi_785_ = 0u;
                            }
                            let _e480 = phi_784_;
                            let _e482 = phi_785_;
                            phi_786_ = _e480;
                            phi_787_ = _e482;
                        }
                        let _e489 = phi_786_;
                        let _e491 = phi_787_;
                        phi_788_ = _e489;
                        phi_789_ = _e491;
                    }
                    let _e493 = phi_788_;
                    let _e495 = phi_789_;
                    phi_790_ = _e493;
                    phi_791_ = _e495;
                }
                let _e498 = phi_790_;
                let _e500 = phi_791_;
                let _e508 = select(bitcast<f32>(((_e449 | _e500) + select(0u, 1u, _e498))), bitcast<f32>((_e449 | _e500)), (_e449 == 0u));
                let _e509 = bitcast<u64>(_e444);
                let _e510 = u32(_e509);
                let _e512 = u32((_e509 / 4294967296lu));
                let _e513 = (_e512 & 2147483648u);
                let _e516 = ((_e512 >> bitcast<u32>(20i)) & 2047u);
                let _e522 = (((_e512 & 1048575u) << bitcast<u32>(3i)) | (_e510 >> bitcast<u32>(29i)));
                let _e523 = (_e510 & 536870911u);
                if (_e516 == 2047u) {
                    phi_858_ = false;
                    phi_859_ = (2139095040u | _e522);
                } else {
                    if (_e516 > 1150u) {
                        phi_856_ = true;
                        phi_857_ = 2139095039u;
                    } else {
                        if (_e516 > 896u) {
                            phi_854_ = (_e523 != 0u);
                            phi_855_ = (((_e516 - 896u) << bitcast<u32>(23i)) | _e522);
                        } else {
                            if (_e516 >= 873u) {
                                let _e531 = (8388608u | _e522);
                                let _e532 = (897u - _e516);
                                phi_852_ = (((_e531 & ((1u << bitcast<u32>((_e532 & 31u))) - 1u)) | _e523) != 0u);
                                phi_853_ = (_e531 >> bitcast<u32>((_e532 & 31u)));
                            } else {
                                phi_852_ = (((_e512 & 2147483647u) | _e510) != 0u);
                                phi_853_ = 0u;
                            }
                            let _e544 = phi_852_;
                            let _e546 = phi_853_;
                            phi_854_ = _e544;
                            phi_855_ = _e546;
                        }
                        let _e553 = phi_854_;
                        let _e555 = phi_855_;
                        phi_856_ = _e553;
                        phi_857_ = _e555;
                    }
                    let _e557 = phi_856_;
                    let _e559 = phi_857_;
                    phi_858_ = _e557;
                    phi_859_ = _e559;
                }
                let _e562 = phi_858_;
                let _e564 = phi_859_;
                let _e572 = select(bitcast<f32>((_e513 | _e564)), bitcast<f32>(((_e513 | _e564) + select(0u, 1u, _e562))), (_e513 == 0u));
                let _e574 = (_e444 - f64(_e508));
                let _e576 = (f64(_e572) - _e444);
                local_4.member_1[_e271] = select(_e572, _e508, select(select(true, false, select(true, select(true, false, ((bitcast<u32>(_e508) & 1u) == 0u)), (_e574 == _e576))), true, (_e574 < _e576)));
            }
            continue;
            continuing {
                phi_493_ = type_9(select(_e257.member, (_e257.member + 1u), _e260), select(_e257.member_1, _e257.member_1, _e260));
                break if !(_e273);
            }
        }
        let _e590 = local_4;
        paths.member[_e68] = type_15(array<f32, 4>(_e590.member[0], _e590.member[1], _e590.member[2], _e590.member[3]), array<f32, 4>(_e590.member_1[0], _e590.member_1[1], _e590.member_1[2], _e590.member_1[3]));
        let _e606 = local_9.member;
        let _e611 = local_9.member_1;
        let _e615 = bitcast<u64>(_e606[0]);
        let _e616 = u32(_e615);
        let _e618 = u32((_e615 / 4294967296lu));
        let _e628 = (0u - select(0u, 1u, (((_e618 >> bitcast<u32>(31i)) == 1u) && !(((_e618 == 2147483648u) && (_e616 == 0u))))));
        let _e635 = bitcast<u64>(_e606[1]);
        let _e636 = u32(_e635);
        let _e638 = u32((_e635 / 4294967296lu));
        let _e648 = (0u - select(0u, 1u, (((_e638 >> bitcast<u32>(31i)) == 1u) && !(((_e638 == 2147483648u) && (_e636 == 0u))))));
        let _e655 = bitcast<u64>(_e606[2]);
        let _e656 = u32(_e655);
        let _e658 = u32((_e655 / 4294967296lu));
        let _e668 = (0u - select(0u, 1u, (((_e658 >> bitcast<u32>(31i)) == 1u) && !(((_e658 == 2147483648u) && (_e656 == 0u))))));
        let _e675 = bitcast<u64>(_e611[0]);
        let _e676 = u32(_e675);
        let _e678 = u32((_e675 / 4294967296lu));
        let _e688 = (0u - select(0u, 1u, (((_e678 >> bitcast<u32>(31i)) == 1u) && !(((_e678 == 2147483648u) && (_e676 == 0u))))));
        let _e695 = bitcast<u64>(_e611[1]);
        let _e696 = u32(_e695);
        let _e698 = u32((_e695 / 4294967296lu));
        let _e708 = (0u - select(0u, 1u, (((_e698 >> bitcast<u32>(31i)) == 1u) && !(((_e698 == 2147483648u) && (_e696 == 0u))))));
        let _e715 = bitcast<u64>(_e611[2]);
        let _e716 = u32(_e715);
        let _e718 = u32((_e715 / 4294967296lu));
        let _e728 = (0u - select(0u, 1u, (((_e718 >> bitcast<u32>(31i)) == 1u) && !(((_e718 == 2147483648u) && (_e716 == 0u))))));
        keys.member[_e68] = array<array<u32, 2>, 6>(array<u32, 2>((_e616 ^ _e628), ((_e618 ^ _e628) | (~(_e628) & 2147483648u))), array<u32, 2>((_e636 ^ _e648), ((_e638 ^ _e648) | (~(_e648) & 2147483648u))), array<u32, 2>((_e656 ^ _e668), ((_e658 ^ _e668) | (~(_e668) & 2147483648u))), array<u32, 2>((_e676 ^ _e688), ((_e678 ^ _e688) | (~(_e688) & 2147483648u))), array<u32, 2>((_e696 ^ _e708), ((_e698 ^ _e708) | (~(_e708) & 2147483648u))), array<u32, 2>((_e716 ^ _e728), ((_e718 ^ _e728) | (~(_e728) & 2147483648u))));
        local_1 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1063_ = type_9(0u, 3u);
        loop {
            let _e738 = phi_1063_;
            let _e741 = (_e738.member < _e738.member_1);
            let _e752 = select(type_9().member_1, _e738.member, _e741);
            let _e754 = (bitcast<i32>(select(0u, 1u, _e741)) != 0i);
            if _e754 {
                let _e757 = local_9.member[_e752];
                let _e758 = bitcast<u64>(_e757);
                let _e759 = u32(_e758);
                let _e761 = u32((_e758 / 4294967296lu));
                let _e762 = (_e761 & 2147483648u);
                let _e765 = ((_e761 >> bitcast<u32>(20i)) & 2047u);
                let _e771 = (((_e761 & 1048575u) << bitcast<u32>(3i)) | (_e759 >> bitcast<u32>(29i)));
                let _e772 = (_e759 & 536870911u);
                if (_e765 == 2047u) {
                    phi_1154_ = false;
                    phi_1155_ = (2139095040u | _e771);
                } else {
                    if (_e765 > 1150u) {
                        phi_1152_ = true;
                        phi_1153_ = 2139095039u;
                    } else {
                        if (_e765 > 896u) {
                            phi_1150_ = (_e772 != 0u);
                            phi_1151_ = (((_e765 - 896u) << bitcast<u32>(23i)) | _e771);
                        } else {
                            if (_e765 >= 873u) {
                                let _e780 = (8388608u | _e771);
                                let _e781 = (897u - _e765);
                                phi_1148_ = (((_e780 & ((1u << bitcast<u32>((_e781 & 31u))) - 1u)) | _e772) != 0u);
                                phi_1149_ = (_e780 >> bitcast<u32>((_e781 & 31u)));
                            } else {
                                phi_1148_ = (((_e761 & 2147483647u) | _e759) != 0u);
                                phi_1149_ = 0u;
                            }
                            let _e793 = phi_1148_;
                            let _e795 = phi_1149_;
                            phi_1150_ = _e793;
                            phi_1151_ = _e795;
                        }
                        let _e802 = phi_1150_;
                        let _e804 = phi_1151_;
                        phi_1152_ = _e802;
                        phi_1153_ = _e804;
                    }
                    let _e806 = phi_1152_;
                    let _e808 = phi_1153_;
                    phi_1154_ = _e806;
                    phi_1155_ = _e808;
                }
                let _e811 = phi_1154_;
                let _e813 = phi_1155_;
                let _e821 = select(bitcast<f32>(((_e762 | _e813) + select(0u, 1u, _e811))), bitcast<f32>((_e762 | _e813)), (_e762 == 0u));
                let _e822 = -(290000000000000000000000000000000000000f);
                let _e824 = select(_e822, _e821, (_e821 > _e822));
                local_1.member[_e752] = select(290000000000000000000000000000000000000f, _e824, (_e824 < 290000000000000000000000000000000000000f));
                let _e831 = local_9.member_1[_e752];
                let _e832 = bitcast<u64>(_e831);
                let _e833 = u32(_e832);
                let _e835 = u32((_e832 / 4294967296lu));
                let _e836 = (_e835 & 2147483648u);
                let _e839 = ((_e835 >> bitcast<u32>(20i)) & 2047u);
                let _e845 = (((_e835 & 1048575u) << bitcast<u32>(3i)) | (_e833 >> bitcast<u32>(29i)));
                let _e846 = (_e833 & 536870911u);
                if (_e839 == 2047u) {
                    phi_1247_ = false;
                    phi_1248_ = (2139095040u | _e845);
                } else {
                    if (_e839 > 1150u) {
                        phi_1245_ = true;
                        phi_1246_ = 2139095039u;
                    } else {
                        if (_e839 > 896u) {
                            phi_1243_ = (_e846 != 0u);
                            phi_1244_ = (((_e839 - 896u) << bitcast<u32>(23i)) | _e845);
                        } else {
                            if (_e839 >= 873u) {
                                let _e854 = (8388608u | _e845);
                                let _e855 = (897u - _e839);
                                phi_1241_ = (((_e854 & ((1u << bitcast<u32>((_e855 & 31u))) - 1u)) | _e846) != 0u);
                                phi_1242_ = (_e854 >> bitcast<u32>((_e855 & 31u)));
                            } else {
                                phi_1241_ = (((_e835 & 2147483647u) | _e833) != 0u);
                                phi_1242_ = 0u;
                            }
                            let _e867 = phi_1241_;
                            let _e869 = phi_1242_;
                            phi_1243_ = _e867;
                            phi_1244_ = _e869;
                        }
                        let _e876 = phi_1243_;
                        let _e878 = phi_1244_;
                        phi_1245_ = _e876;
                        phi_1246_ = _e878;
                    }
                    let _e880 = phi_1245_;
                    let _e882 = phi_1246_;
                    phi_1247_ = _e880;
                    phi_1248_ = _e882;
                }
                let _e885 = phi_1247_;
                let _e887 = phi_1248_;
                let _e895 = select(bitcast<f32>((_e836 | _e887)), bitcast<f32>(((_e836 | _e887) + select(0u, 1u, _e885))), (_e836 == 0u));
                let _e896 = -(290000000000000000000000000000000000000f);
                let _e898 = select(_e896, _e895, (_e895 > _e896));
                local_1.member_1[_e752] = select(290000000000000000000000000000000000000f, _e898, (_e898 < 290000000000000000000000000000000000000f));
            }
            continue;
            continuing {
                phi_1063_ = type_9(select(_e738.member, (_e738.member + 1u), _e741), select(_e738.member_1, _e738.member_1, _e741));
                break if !(_e754);
            }
        }
        let _e904 = local_1;
        local = _e904;
        phi_1306_ = type_9(0u, 3u);
        loop {
            let _e906 = phi_1306_;
            let _e909 = (_e906.member < _e906.member_1);
            let _e920 = select(type_9().member_1, _e906.member, _e909);
            let _e922 = (bitcast<i32>(select(0u, 1u, _e909)) != 0i);
            if _e922 {
                let _e925 = local.member[_e920];
                if select(false, (_e925 > -(0.000000000000000000000000000000000000011754944f)), (_e925 < 0.000000000000000000000000000000000000011754944f)) {
                    let _e935 = local_9.member[_e920];
                    let _e937 = bitcast<u64>(-(_e935));
                    let _e940 = u32((_e937 / 4294967296lu));
                    phi_1387_ = -(select(0f, 0.000000000000000000000000000000000000011754944f, select(false, ((u32(_e937) | _e940) != 0u), ((_e940 >> bitcast<u32>(31i)) == 0u))));
                } else {
                    let _e932 = local.member[_e920];
                    phi_1387_ = _e932;
                }
                let _e950 = phi_1387_;
                local.member[_e920] = _e950;
                let _e955 = local.member_1[_e920];
                if select(false, (_e955 > -(0.000000000000000000000000000000000000011754944f)), (_e955 < 0.000000000000000000000000000000000000011754944f)) {
                    let _e965 = local_9.member_1[_e920];
                    let _e966 = bitcast<u64>(_e965);
                    let _e969 = u32((_e966 / 4294967296lu));
                    phi_1444_ = select(0f, 0.000000000000000000000000000000000000011754944f, select(false, ((u32(_e966) | _e969) != 0u), ((_e969 >> bitcast<u32>(31i)) == 0u)));
                } else {
                    let _e962 = local.member_1[_e920];
                    phi_1444_ = _e962;
                }
                let _e978 = phi_1444_;
                local.member_1[_e920] = _e978;
            }
            continue;
            continuing {
                phi_1306_ = type_9(select(_e906.member, (_e906.member + 1u), _e909), select(_e906.member_1, _e906.member_1, _e909));
                break if !(_e922);
            }
        }
        let _e982 = local;
        boxes.member[_e68] = type_19(array<f32, 3>(_e982.member[0], _e982.member[1], _e982.member[2]), array<f32, 3>(_e982.member_1[0], _e982.member_1[1], _e982.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
