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
    member_1: u32,
    member_2: u32,
}

struct type_23 {
    member: type_17,
    member_1: array<f32, 3>,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_25 {
    member: type_24,
}

struct type_26 {
    member: type_23,
    member_1: u32,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> order: type_11;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_31;
@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> sorted: type_19;
@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(4) 
var<storage> survey: type_11;
@group(0) @binding(5) 
var<storage> work: type_11;
var<workgroup> boxes: array<type_17, 128>;
var<workgroup> hits: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_17;
    var local_2: type_23;
    var local_3: array<f32, 3>;
    var local_4: type_17;
    var local_5: type_17;
    var local_6: type_23;
    var local_7: type_17;
    var phi_213_: u32;
    var phi_261_: u32;
    var phi_264_: type_9;
    var phi_465_: u32;
    var phi_498_: u32;
    var phi_499_: u32;
    var phi_500_: bool;
    var phi_521_: type_14;
    var phi_524_: u32;
    var phi_526_: u32;
    var phi_522_: type_14;
    var phi_567_: type_15;
    var phi_598_: u32;
    var phi_599_: u32;
    var phi_600_: bool;
    var phi_525_: u32;
    var phi_527_: u32;
    var phi_601_: bool;
    var phi_606_: type_14;
    var phi_609_: u32;
    var phi_611_: u32;
    var phi_607_: type_14;
    var phi_652_: type_15;
    var phi_683_: u32;
    var phi_684_: u32;
    var phi_685_: bool;
    var phi_610_: u32;
    var phi_612_: u32;
    var phi_686_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_688_: u32;
    var phi_716_: bool;
    var phi_786_: type_9;
    var phi_995_: type_9;
    var phi_998_: type_26;
    var phi_1031_: type_9;
    var phi_1034_: bool;
    var phi_1035_: bool;
    var local_10: bool;
    var phi_1102_: type_26;
    var phi_1103_: bool;
    var phi_999_: type_26;
    var phi_1104_: bool;
    var local_11: type_26;
    var local_12: type_26;
    var local_13: type_26;
    var local_14: type_26;
    var local_15: type_26;
    var local_16: type_26;
    var local_17: type_26;
    var phi_1161_: type_9;
    var phi_1254_: f32;
    var phi_1287_: type_9;
    var phi_1394_: array<u32, 3>;
    var phi_1395_: array<u32, 3>;
    var phi_1559_: array<u32, 2>;
    var phi_1560_: array<u32, 2>;
    var phi_1561_: bool;
    var phi_1562_: array<u32, 2>;
    var phi_1563_: bool;
    var phi_1564_: array<u32, 2>;
    var phi_1565_: bool;
    var phi_1571_: array<u32, 2>;
    var phi_1579_: array<u32, 2>;
    var phi_1580_: bool;
    var phi_1581_: array<u32, 2>;
    var phi_1582_: bool;
    var phi_1594_: array<u32, 2>;
    var phi_1431_: f32;
    var phi_1432_: f32;
    var phi_1595_: array<u32, 2>;
    var phi_1606_: array<u32, 3>;
    var phi_1608_: array<u32, 3>;
    var phi_1625_: type_17;
    var phi_1628_: type_9;
    var phi_1687_: type_17;
    var phi_1688_: u32;
    var phi_1709_: type_9;
    var phi_1878_: type_9;
    var phi_1879_: type_9;
    var phi_1940_: type_9;
    var phi_2110_: type_9;
    var phi_2111_: type_9;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e89 = id_2;
    let _e90 = n_2;
    let _e91 = lane_2;
    let _e103 = ((_e89.y * _e90.x) + _e89.x);
    let _e106 = (_e90.x * _e90.y);
    let _e109 = params.member.member_1.member_2;
    let _e111 = work.member[0u];
    let _e113 = select(_e111, _e109, (_e109 < _e111));
    let _e115 = params.member.member_1.member_1;
    if (_e113 > _e115) {
        let _e118 = params.member.member_1.member_1;
        phi_213_ = (_e113 - _e118);
    } else {
        phi_213_ = 0u;
    }
    let _e121 = phi_213_;
    let _e123 = params.member.member_1.member;
    let _e125 = select(_e121, _e123, (_e123 < _e121));
    let _e129 = params.member.member.member_2[3u];
    if (_e125 > _e103) {
        let _e131 = (_e125 - _e103);
        if (_e106 == 0u) {
            return;
        }
        let _e133 = (_e131 / _e106);
        if (_e106 == 0u) {
            return;
        }
        phi_261_ = select(_e133, (_e133 + 1u), ((_e131 % _e106) > 0u));
    } else {
        phi_261_ = 0u;
    }
    let _e140 = phi_261_;
    phi_264_ = type_9(0u, _e140);
    loop {
        let _e143 = phi_264_;
        let _e146 = (_e143.member < _e143.member_1);
        let _e159 = (bitcast<i32>(select(0u, 1u, _e146)) != 0i);
        if _e159 {
            let _e162 = params.member.member_1.member_1;
            let _e166 = (2u * ((_e162 + _e103) + (select(type_9().member_1, _e143.member, _e146) * _e106)));
            let _e169 = work.member[(4u + _e166)];
            let _e172 = work.member[(_e166 + 5u)];
            let _e174 = (_e169 >> bitcast<u32>(24i));
            let _e178 = (_e169 & 16777215u);
            let _e182 = params.member.member_2.member;
            let _e185 = params.member.member_2.member_1;
            let _e186 = (_e185 == 0u);
            let _e195 = select(select(1u, 0u, _e186), select(1u, 2u, _e186), (_e174 >= (select(1u, 8u, (_e182 == 2u)) * select(1u, 10u, (_e182 == 2u)))));
            let _e197 = ((_e178 * 128u) + _e91);
            let _e201 = params.member.member.member_2[_e195];
            let _e202 = (_e201 + _e197);
            let _e206 = params.member.member.member[_e195];
            let _e207 = (_e197 < _e206);
            if _e207 {
                let _e210 = params.member.member_2.member;
                let _e213 = params.member.member_2.member_1;
                let _e214 = (_e213 == 0u);
                let _e223 = select(select(1u, 2u, _e214), select(1u, 0u, _e214), (_e174 >= (select(1u, 8u, (_e210 == 2u)) * select(1u, 10u, (_e210 == 2u)))));
                let _e225 = keys.member[_e202];
                let _e227 = sorted.member[_e202];
                local_7 = type_17(array<f32, 3>(_e227.member[0], _e227.member[1], _e227.member[2]), array<f32, 3>(_e227.member_1[0], _e227.member_1[1], _e227.member_1[2]));
                if (_e210 == 2u) {
                    phi_465_ = ((_e174 % 80u) / 10u);
                } else {
                    phi_465_ = 0u;
                }
                let _e243 = phi_465_;
                let _e251 = select(false, (_e174 >= (select(1u, 8u, (_e210 == 2u)) * select(1u, 10u, (_e210 == 2u)))), (_e243 == 0u));
                if (_e210 != 2u) {
                    phi_499_ = u32();
                    phi_500_ = true;
                } else {
                    if _e251 {
                        phi_498_ = u32();
                    } else {
                        let _e256 = (((_e225 >> bitcast<u32>(27u)) % 8u) + _e243);
                        phi_498_ = select(8u, _e256, (_e256 < 8u));
                    }
                    let _e260 = phi_498_;
                    phi_499_ = _e260;
                    phi_500_ = _e251;
                }
                let _e262 = phi_499_;
                let _e264 = phi_500_;
                let _e265 = select(_e262, 8u, _e264);
                if (_e265 < 8u) {
                    let _e271 = ((_e223 << bitcast<u32>(30u)) + (_e265 << bitcast<u32>(27u)));
                    let _e275 = params.member.member.member_2[3u];
                    phi_521_ = type_14(0i, 32i);
                    phi_524_ = 0u;
                    phi_526_ = _e275;
                    loop {
                        let _e278 = phi_521_;
                        let _e280 = phi_524_;
                        let _e282 = phi_526_;
                        local_8 = _e280;
                        if (_e278.member < _e278.member_1) {
                            let _e289 = (_e278.member + 1i);
                            phi_522_ = type_14(select(_e289, type_15().member_1, select(false, true, ((false == (_e289 > _e278.member)) != false))), _e278.member_1);
                            phi_567_ = type_15(1u, _e278.member);
                        } else {
                            phi_522_ = _e278;
                            phi_567_ = type_15(0u, type_15().member_1);
                        }
                        let _e300 = phi_522_;
                        let _e302 = phi_567_;
                        if (bitcast<i32>(_e302.member) != 0i) {
                            if (_e280 >= _e282) {
                                phi_598_ = u32();
                                phi_599_ = u32();
                                phi_600_ = false;
                            } else {
                                let _e309 = (_e280 + ((_e282 - _e280) / 2u));
                                let _e311 = keys.member[_e309];
                                let _e312 = (_e311 < (_e271 + 134217728u));
                                phi_598_ = select(_e280, (_e309 + 1u), _e312);
                                phi_599_ = select(_e309, _e282, _e312);
                                phi_600_ = true;
                            }
                            let _e317 = phi_598_;
                            let _e319 = phi_599_;
                            let _e321 = phi_600_;
                            phi_525_ = _e317;
                            phi_527_ = _e319;
                            phi_601_ = _e321;
                        } else {
                            phi_525_ = u32();
                            phi_527_ = u32();
                            phi_601_ = false;
                        }
                        let _e323 = phi_525_;
                        let _e325 = phi_527_;
                        let _e327 = phi_601_;
                        continue;
                        continuing {
                            phi_521_ = _e300;
                            phi_524_ = _e323;
                            phi_526_ = _e325;
                            break if !(_e327);
                        }
                    }
                    phi_606_ = type_14(0i, 32i);
                    phi_609_ = 0u;
                    phi_611_ = _e275;
                    loop {
                        let _e330 = phi_606_;
                        let _e332 = phi_609_;
                        let _e334 = phi_611_;
                        local_9 = _e332;
                        if (_e330.member < _e330.member_1) {
                            let _e341 = (_e330.member + 1i);
                            phi_607_ = type_14(select(_e341, type_15().member_1, select(false, true, ((false == (_e341 > _e330.member)) != false))), _e330.member_1);
                            phi_652_ = type_15(1u, _e330.member);
                        } else {
                            phi_607_ = _e330;
                            phi_652_ = type_15(0u, type_15().member_1);
                        }
                        let _e352 = phi_607_;
                        let _e354 = phi_652_;
                        if (bitcast<i32>(_e354.member) != 0i) {
                            if (_e332 >= _e334) {
                                phi_683_ = u32();
                                phi_684_ = u32();
                                phi_685_ = false;
                            } else {
                                let _e361 = (_e332 + ((_e334 - _e332) / 2u));
                                let _e363 = keys.member[_e361];
                                let _e364 = (_e363 < _e271);
                                phi_683_ = select(_e332, (_e361 + 1u), _e364);
                                phi_684_ = select(_e361, _e334, _e364);
                                phi_685_ = true;
                            }
                            let _e369 = phi_683_;
                            let _e371 = phi_684_;
                            let _e373 = phi_685_;
                            phi_610_ = _e369;
                            phi_612_ = _e371;
                            phi_686_ = _e373;
                        } else {
                            phi_610_ = u32();
                            phi_612_ = u32();
                            phi_686_ = false;
                        }
                        let _e375 = phi_610_;
                        let _e377 = phi_612_;
                        let _e379 = phi_686_;
                        continue;
                        continuing {
                            phi_606_ = _e352;
                            phi_609_ = _e375;
                            phi_611_ = _e377;
                            break if !(_e379);
                        }
                    }
                    let _e382 = local_8;
                    let _e384 = local_9;
                    phi_688_ = (_e382 - _e384);
                } else {
                    phi_688_ = 0u;
                }
                let _e387 = phi_688_;
                if (_e210 != 2u) {
                    phi_716_ = true;
                } else {
                    let _e389 = (_e387 == 0u);
                    let _e390 = (_e387 <= 256u);
                    let _e396 = ((_e174 % 80u) % 10u);
                    phi_716_ = select(false, (_e396 < select(select(9u, 10u, _e390), 0u, _e389)), (select(select(0u, 9u, _e390), 0u, _e389) <= _e396));
                }
                let _e401 = phi_716_;
                if _e401 {
                    if (_e210 == 2u) {
                        let _e404 = survey.member[6u];
                        let _e411 = bitcast<f32>(select(~(_e404), (_e404 & 2147483647u), ((_e404 >> bitcast<u32>(31i)) == 1u)));
                        let _e413 = survey.member[7u];
                        let _e420 = bitcast<f32>(select(~(_e413), (_e413 & 2147483647u), ((_e413 >> bitcast<u32>(31i)) == 1u)));
                        let _e422 = survey.member[8u];
                        let _e429 = bitcast<f32>(select(~(_e422), (_e422 & 2147483647u), ((_e422 >> bitcast<u32>(31i)) == 1u)));
                        local_5 = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_786_ = type_9(0u, 3u);
                        loop {
                            let _e431 = phi_786_;
                            let _e434 = (_e431.member < _e431.member_1);
                            let _e445 = select(type_9().member_1, _e431.member, _e434);
                            let _e447 = (bitcast<i32>(select(0u, 1u, _e434)) != 0i);
                            if _e447 {
                                let _e449 = survey.member[_e445];
                                let _e450 = ~(_e449);
                                local_5.member[_e445] = bitcast<f32>(select(~(_e450), (_e450 & 2147483647u), ((_e450 >> bitcast<u32>(31i)) == 1u)));
                                let _e462 = survey.member[(3u + _e445)];
                                local_5.member_1[_e445] = bitcast<f32>(select(~(_e462), (_e462 & 2147483647u), ((_e462 >> bitcast<u32>(31i)) == 1u)));
                            }
                            continue;
                            continuing {
                                phi_786_ = type_9(select(_e431.member, (_e431.member + 1u), _e434), select(_e431.member_1, _e431.member_1, _e434));
                                break if !(_e447);
                            }
                        }
                        let _e473 = local_5;
                        local_6 = type_23(_e473, array<f32, 3>(_e411, _e420, _e429));
                        if (_e243 == 0u) {
                            let _e767 = (_e225 & 134217727u);
                            phi_1394_ = array<u32, 3>((_e767 & 511u), ((_e767 >> bitcast<u32>(9u)) & 511u), (_e767 >> bitcast<u32>(18u)));
                        } else {
                            let _e494 = local_6.member.member_1[0u];
                            let _e498 = local_6.member.member[0u];
                            let _e503 = local_6.member.member_1[1u];
                            let _e507 = local_6.member.member[1u];
                            let _e512 = local_6.member.member_1[2u];
                            let _e516 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e494 * 0.5f) - (_e498 * 0.5f)), ((_e503 * 0.5f) - (_e507 * 0.5f)), ((_e512 * 0.5f) - (_e516 * 0.5f)));
                            phi_995_ = type_9(0u, 9u);
                            phi_998_ = type_26(type_23(type_17(array<f32, 3>(_e473.member[0], _e473.member[1], _e473.member[2]), array<f32, 3>(_e473.member_1[0], _e473.member_1[1], _e473.member_1[2])), array<f32, 3>(_e411, _e420, _e429)), 0u);
                            loop {
                                let _e521 = phi_995_;
                                let _e523 = phi_998_;
                                local_11 = _e523;
                                local_12 = _e523;
                                local_13 = _e523;
                                local_14 = _e523;
                                local_15 = _e523;
                                local_16 = _e523;
                                local_17 = _e523;
                                let _e526 = (_e521.member < _e521.member_1);
                                let _e537 = select(type_9().member_1, _e521.member, _e526);
                                if (bitcast<i32>(select(0u, 1u, _e526)) != 0i) {
                                    phi_1031_ = type_9(0u, 3u);
                                    phi_1034_ = true;
                                    loop {
                                        let _e541 = phi_1031_;
                                        let _e543 = phi_1034_;
                                        local_10 = _e543;
                                        let _e546 = (_e541.member < _e541.member_1);
                                        let _e557 = select(type_9().member_1, _e541.member, _e546);
                                        let _e559 = (bitcast<i32>(select(0u, 1u, _e546)) != 0i);
                                        if _e559 {
                                            let _e561 = local_3[_e557];
                                            let _e563 = (_e561 * (1f / 512f));
                                            let _e568 = local_6.member_1[_e557];
                                            phi_1035_ = select(_e543, false, ((_e568 * bitcast<f32>(((127u - _e537) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e563, (_e563 > 0.000000000000000000000000000006310887f))));
                                        } else {
                                            phi_1035_ = bool();
                                        }
                                        let _e577 = phi_1035_;
                                        continue;
                                        continuing {
                                            phi_1031_ = type_9(select(_e541.member, (_e541.member + 1u), _e546), select(_e541.member_1, _e541.member_1, _e546));
                                            phi_1034_ = _e577;
                                            break if !(_e559);
                                        }
                                    }
                                    let _e580 = local_10;
                                    if _e580 {
                                        phi_1102_ = type_26();
                                        phi_1103_ = false;
                                    } else {
                                        phi_1102_ = type_26(_e523.member, (_e537 + 1u));
                                        phi_1103_ = true;
                                    }
                                    let _e585 = phi_1102_;
                                    let _e587 = phi_1103_;
                                    phi_999_ = _e585;
                                    phi_1104_ = _e587;
                                } else {
                                    phi_999_ = type_26();
                                    phi_1104_ = false;
                                }
                                let _e589 = phi_999_;
                                let _e591 = phi_1104_;
                                continue;
                                continuing {
                                    phi_995_ = type_9(select(_e521.member, (_e521.member + 1u), _e526), select(_e521.member_1, _e521.member_1, _e526));
                                    phi_998_ = _e589;
                                    break if !(_e591);
                                }
                            }
                            let _e596 = (((_e225 >> bitcast<u32>(27u)) % 8u) + _e243);
                            let _e598 = select(8u, _e596, (_e596 < 8u));
                            let _e600 = local_11;
                            let _e605 = local_12;
                            let _e609 = local_13;
                            let _e615 = local_14;
                            let _e622 = bitcast<f32>(((127u - select((_e615.member_1 - _e598), 0u, ((_e598 + 1u) >= select(8u, (_e609.member_1 + 1u), (_e605.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e624 = local_15;
                            let _e630 = local_16;
                            let _e636 = local_17;
                            local_2.member = type_17(array<f32, 3>(_e600.member.member.member[0], _e600.member.member.member[1], _e600.member.member.member[2]), array<f32, 3>(_e600.member.member.member_1[0], _e600.member.member.member_1[1], _e600.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e624.member.member_1[0] * _e622), (_e630.member.member_1[1] * _e622), (_e636.member.member_1[2] * _e622));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_1161_ = type_9(0u, 3u);
                            loop {
                                let _e658 = phi_1161_;
                                let _e661 = (_e658.member < _e658.member_1);
                                let _e672 = select(type_9().member_1, _e658.member, _e661);
                                let _e674 = (bitcast<i32>(select(0u, 1u, _e661)) != 0i);
                                if _e674 {
                                    let _e678 = local_2.member.member[_e672];
                                    let _e682 = local_2.member.member_1[_e672];
                                    let _e687 = (((_e682 * 0.5f) - (_e678 * 0.5f)) * (1f / 512f));
                                    let _e690 = local_2.member_1[_e672];
                                    let _e693 = local_2.member_1[_e672];
                                    let _e695 = (_e690 + (_e693 * 0.00390625f));
                                    let _e697 = select(_e695, _e687, (_e687 > _e695));
                                    let _e699 = select(_e697, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e697));
                                    local_1.member[_e672] = (_e678 * 0.25f);
                                    if (_e699 > 5316912000000000000000000000000000000f) {
                                        phi_1254_ = 0f;
                                    } else {
                                        phi_1254_ = (1f / _e699);
                                    }
                                    let _e706 = phi_1254_;
                                    local_1.member_1[_e672] = _e706;
                                }
                                continue;
                                continuing {
                                    phi_1161_ = type_9(select(_e658.member, (_e658.member + 1u), _e661), select(_e658.member_1, _e658.member_1, _e661));
                                    break if !(_e674);
                                }
                            }
                            let _e710 = local_1;
                            local_4 = _e710;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1287_ = type_9(0u, 3u);
                            loop {
                                let _e712 = phi_1287_;
                                let _e715 = (_e712.member < _e712.member_1);
                                let _e726 = select(type_9().member_1, _e712.member, _e715);
                                let _e728 = (bitcast<i32>(select(0u, 1u, _e715)) != 0i);
                                if _e728 {
                                    let _e731 = local_4.member[_e726];
                                    let _e734 = local_7.member[_e726];
                                    let _e736 = ((_e734 * 0.25f) - _e731);
                                    let _e741 = local_7.member_1[_e726];
                                    let _e743 = ((_e741 * 0.25f) - _e731);
                                    let _e749 = local_4.member_1[_e726];
                                    let _e750 = ((select(0f, _e736, (_e736 > 0f)) + select(0f, _e743, (_e743 > 0f))) * _e749);
                                    local[_e726] = select(select(0u, select(select(u32(_e750), 0u, (_e750 < 0f)), 4294967295u, (_e750 > 4294967000f)), (_e750 > 0f)), 511u, (_e750 >= 511f));
                                }
                                continue;
                                continuing {
                                    phi_1287_ = type_9(select(_e712.member, (_e712.member + 1u), _e715), select(_e712.member_1, _e712.member_1, _e715));
                                    break if !(_e728);
                                }
                            }
                            let _e762 = local;
                            phi_1394_ = array<u32, 3>(_e762[0], _e762[1], _e762[2]);
                        }
                        let _e776 = phi_1394_;
                        phi_1395_ = _e776;
                    } else {
                        phi_1395_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e778 = phi_1395_;
                    let _e780 = (_e223 << bitcast<u32>(30u));
                    if (_e210 == 1u) {
                        let _e894 = survey.member[6u];
                        if (_e894 == 0u) {
                            let _e904 = local_7.member_1[0u];
                            phi_1432_ = _e904;
                        } else {
                            if (_e894 == 1u) {
                                let _e900 = local_7.member_1[1u];
                                phi_1431_ = _e900;
                            } else {
                                let _e898 = local_7.member_1[2u];
                                phi_1431_ = _e898;
                            }
                            let _e902 = phi_1431_;
                            phi_1432_ = _e902;
                        }
                        let _e906 = phi_1432_;
                        let _e907 = bitcast<u32>(_e906);
                        let _e911 = bitcast<u32>(bitcast<f32>(select(_e907, 0u, (_e907 == 2147483648u))));
                        phi_1595_ = array<u32, 2>(((_e780 | (_e225 & 1073741823u)) + _e174), (_e780 | (select((_e911 | 2147483648u), ~(_e911), ((_e911 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i))));
                    } else {
                        if (_e210 == 2u) {
                            let _e784 = (_e174 % 80u);
                            let _e786 = (_e784 % 10u);
                            let _e789 = select(false, ((_e784 / 10u) == 0u), (_e213 == 1u));
                            if (_e265 >= 8u) {
                                phi_1581_ = array<u32, 2>();
                                phi_1582_ = true;
                            } else {
                                if select(true, select(true, false, (_e786 < 4u)), _e789) {
                                    if (_e786 == 9u) {
                                        phi_1571_ = array<u32, 2>(0u, 134217727u);
                                    } else {
                                        let _e797 = (_e778[1] + (_e786 % 3u));
                                        let _e800 = (_e778[2] + (_e786 / 3u));
                                        if (_e797 < 1u) {
                                            phi_1564_ = array<u32, 2>();
                                            phi_1565_ = true;
                                        } else {
                                            if (_e800 < 1u) {
                                                phi_1562_ = array<u32, 2>();
                                                phi_1563_ = true;
                                            } else {
                                                if (_e797 > 512u) {
                                                    phi_1560_ = array<u32, 2>();
                                                    phi_1561_ = true;
                                                } else {
                                                    let _e804 = (_e800 > 512u);
                                                    if _e804 {
                                                        phi_1559_ = array<u32, 2>();
                                                    } else {
                                                        let _e806 = (_e778[0] > 0u);
                                                        let _e809 = select(true, select(true, false, (_e786 == 4u)), _e789);
                                                        phi_1559_ = array<u32, 2>(((((_e800 - 1u) << bitcast<u32>(18u)) | ((_e797 - 1u) << bitcast<u32>(9u))) | select(select(u32(), select(u32(), (_e778[0] - 1u), _e809), _e806), _e778[0], select(true, select(true, false, _e809), _e806))), ((((_e800 - 1u) << bitcast<u32>(18u)) | ((_e797 - 1u) << bitcast<u32>(9u))) | select(_e778[0], (_e778[0] + 1u), ((_e778[0] + 1u) < 512u))));
                                                    }
                                                    let _e843 = phi_1559_;
                                                    phi_1560_ = _e843;
                                                    phi_1561_ = _e804;
                                                }
                                                let _e845 = phi_1560_;
                                                let _e847 = phi_1561_;
                                                phi_1562_ = _e845;
                                                phi_1563_ = _e847;
                                            }
                                            let _e849 = phi_1562_;
                                            let _e851 = phi_1563_;
                                            phi_1564_ = _e849;
                                            phi_1565_ = _e851;
                                        }
                                        let _e853 = phi_1564_;
                                        let _e855 = phi_1565_;
                                        phi_1571_ = array<u32, 2>(select(_e853[0], 1u, _e855), select(_e853[1], 0u, _e855));
                                    }
                                    let _e862 = phi_1571_;
                                    phi_1579_ = array<u32, 2>(((_e265 << bitcast<u32>(27u)) | _e862[0]), ((_e265 << bitcast<u32>(27u)) | _e862[1]));
                                    phi_1580_ = false;
                                } else {
                                    phi_1579_ = array<u32, 2>();
                                    phi_1580_ = true;
                                }
                                let _e873 = phi_1579_;
                                let _e875 = phi_1580_;
                                phi_1581_ = _e873;
                                phi_1582_ = _e875;
                            }
                            let _e877 = phi_1581_;
                            let _e879 = phi_1582_;
                            phi_1594_ = array<u32, 2>((_e780 | select(_e877[0], 1u, _e879)), (_e780 | select(_e877[1], 0u, _e879)));
                        } else {
                            phi_1594_ = array<u32, 2>(_e780, _e780);
                        }
                        let _e888 = phi_1594_;
                        phi_1595_ = _e888;
                    }
                    let _e923 = phi_1595_;
                    phi_1606_ = array<u32, 3>(_e923[0], _e923[1], select(0u, (_e202 + 1u), (_e213 == 1u)));
                } else {
                    phi_1606_ = array<u32, 3>(4294967295u, 0u, 0u);
                }
                let _e931 = phi_1606_;
                phi_1608_ = _e931;
            } else {
                phi_1608_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e933 = phi_1608_;
            if _e207 {
                let _e938 = sorted.member[_e202];
                phi_1625_ = _e938;
            } else {
                phi_1625_ = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e940 = phi_1625_;
            phi_1628_ = type_9(0u, ((_e172 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e943 = phi_1628_;
                let _e946 = (_e943.member < _e943.member_1);
                let _e959 = (bitcast<i32>(select(0u, 1u, _e946)) != 0i);
                if _e959 {
                    let _e961 = ((_e172 & 536870911u) + (select(type_9().member_1, _e943.member, _e946) * 128u));
                    let _e962 = (_e961 + _e91);
                    if (_e962 < _e129) {
                        let _e965 = keys.member[_e962];
                        let _e967 = sorted.member[_e962];
                        phi_1687_ = _e967;
                        phi_1688_ = _e965;
                    } else {
                        phi_1687_ = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1688_ = 4294967295u;
                    }
                    let _e969 = phi_1687_;
                    let _e971 = phi_1688_;
                    names[_e91] = _e971;
                    boxes[_e91] = type_17(array<f32, 3>(_e969.member[0], _e969.member[1], _e969.member[2]), array<f32, 3>(_e969.member_1[0], _e969.member_1[1], _e969.member_1[2]));
                    if (_e91 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1709_ = type_9(0u, 128u);
                    loop {
                        let _e988 = phi_1709_;
                        let _e991 = (_e988.member < _e988.member_1);
                        let _e1002 = select(type_9().member_1, _e988.member, _e991);
                        let _e1004 = (bitcast<i32>(select(0u, 1u, _e991)) != 0i);
                        if _e1004 {
                            let _e1006 = names[_e1002];
                            if (_e1006 >= _e933[0]) {
                                if (_e1006 <= _e933[1]) {
                                    if ((_e961 + _e1002) >= _e933[2]) {
                                        let _e1012 = boxes[_e1002];
                                        if ((((((_e940.member[0] <= _e1012.member_1[0]) && (_e1012.member[0] <= _e940.member_1[0])) && (_e940.member[1] <= _e1012.member_1[1])) && (_e1012.member[1] <= _e940.member_1[1])) && (_e940.member[2] <= _e1012.member_1[2])) && (_e1012.member[2] <= _e940.member_1[2])) {
                                            let _e1045 = atomicAdd((&counters[0u]), 1u);
                                            if (_e1045 < 2048u) {
                                                hits[_e1045] = ((_e91 << bitcast<u32>(7i)) | _e1002);
                                            } else {
                                                let _e1049 = order.member[_e202];
                                                let _e1051 = order.member[(_e961 + _e1002)];
                                                let _e1054 = params.member.member_2.member_1;
                                                if (_e1054 == 1u) {
                                                    let _e1082 = params.member.member.member_2[1u];
                                                    let _e1083 = (_e1049 - _e1082);
                                                    let _e1087 = params.member.member.member_2[1u];
                                                    let _e1088 = (_e1051 - _e1087);
                                                    let _e1089 = (_e1083 < _e1088);
                                                    phi_1879_ = type_9(select(_e1088, _e1083, _e1089), select(_e1083, _e1088, _e1089));
                                                } else {
                                                    let _e1058 = params.member.member_2.member;
                                                    if (_e174 >= (select(1u, 8u, (_e1058 == 2u)) * select(1u, 10u, (_e1058 == 2u)))) {
                                                        let _e1074 = params.member.member.member_2[2u];
                                                        phi_1878_ = type_9(_e1051, (_e1049 - _e1074));
                                                    } else {
                                                        let _e1068 = params.member.member.member_2[2u];
                                                        phi_1878_ = type_9(_e1049, (_e1051 - _e1068));
                                                    }
                                                    let _e1078 = phi_1878_;
                                                    phi_1879_ = _e1078;
                                                }
                                                let _e1094 = phi_1879_;
                                                let _e1099 = params.member.member_1.member_3;
                                                let _e1101 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1101 + 1u) < _e1101) {
                                                    let _e1105 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1101 < _e1099) {
                                                    let _e1107 = (2u * _e1101);
                                                    atomicStore((&pairs.member[(4u + _e1107)]), _e1094.member);
                                                    atomicStore((&pairs.member[(_e1107 + 5u)]), _e1094.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1709_ = type_9(select(_e988.member, (_e988.member + 1u), _e991), select(_e988.member_1, _e988.member_1, _e991));
                            break if !(_e1004);
                        }
                    }
                    workgroupBarrier();
                    let _e1118 = atomicLoad((&counters[0u]));
                    let _e1120 = select(_e1118, 2048u, (2048u < _e1118));
                    if (_e91 == 0u) {
                        if (_e1120 > 0u) {
                            let _e1124 = atomicAdd((&pairs.member[0u]), _e1120);
                            if ((_e1124 + _e1120) < _e1124) {
                                let _e1128 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1124);
                        }
                    }
                    workgroupBarrier();
                    let _e1131 = atomicLoad((&counters[1u]));
                    phi_1940_ = type_9(0u, 16u);
                    loop {
                        let _e1133 = phi_1940_;
                        let _e1136 = (_e1133.member < _e1133.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e1136)) != 0i) {
                            let _e1151 = ((select(type_9().member_1, _e1133.member, _e1136) * 128u) + _e91);
                            if (_e1151 >= _e1120) {
                                phi_2129_ = false;
                            } else {
                                let _e1154 = hits[_e1151];
                                let _e1159 = params.member.member_2.member;
                                let _e1162 = params.member.member_2.member_1;
                                let _e1163 = (_e1162 == 0u);
                                let _e1178 = params.member.member.member_2[select(select(1u, 0u, _e1163), select(1u, 2u, _e1163), (_e174 >= (select(1u, 8u, (_e1159 == 2u)) * select(1u, 10u, (_e1159 == 2u)))))];
                                let _e1183 = order.member[(_e1178 + ((_e178 * 128u) + (_e1154 >> bitcast<u32>(7i))))];
                                let _e1185 = order.member[(_e961 + (_e1154 % 128u))];
                                let _e1188 = params.member.member_2.member_1;
                                if (_e1188 == 1u) {
                                    let _e1216 = params.member.member.member_2[1u];
                                    let _e1217 = (_e1183 - _e1216);
                                    let _e1221 = params.member.member.member_2[1u];
                                    let _e1222 = (_e1185 - _e1221);
                                    let _e1223 = (_e1217 < _e1222);
                                    phi_2111_ = type_9(select(_e1222, _e1217, _e1223), select(_e1217, _e1222, _e1223));
                                } else {
                                    let _e1192 = params.member.member_2.member;
                                    if (_e174 >= (select(1u, 8u, (_e1192 == 2u)) * select(1u, 10u, (_e1192 == 2u)))) {
                                        let _e1208 = params.member.member.member_2[2u];
                                        phi_2110_ = type_9(_e1185, (_e1183 - _e1208));
                                    } else {
                                        let _e1202 = params.member.member.member_2[2u];
                                        phi_2110_ = type_9(_e1183, (_e1185 - _e1202));
                                    }
                                    let _e1212 = phi_2110_;
                                    phi_2111_ = _e1212;
                                }
                                let _e1228 = phi_2111_;
                                let _e1233 = params.member.member_1.member_3;
                                let _e1234 = (_e1131 + _e1151);
                                if (_e1234 < _e1233) {
                                    let _e1236 = (2u * _e1234);
                                    atomicStore((&pairs.member[(4u + _e1236)]), _e1228.member);
                                    atomicStore((&pairs.member[(_e1236 + 5u)]), _e1228.member_1);
                                }
                                phi_2129_ = true;
                            }
                            let _e1242 = phi_2129_;
                            phi_2130_ = _e1242;
                        } else {
                            phi_2130_ = false;
                        }
                        let _e1244 = phi_2130_;
                        continue;
                        continuing {
                            phi_1940_ = type_9(select(_e1133.member, (_e1133.member + 1u), _e1136), select(_e1133.member_1, _e1133.member_1, _e1136));
                            break if !(_e1244);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1628_ = type_9(select(_e943.member, (_e943.member + 1u), _e946), select(_e943.member_1, _e943.member_1, _e946));
                    break if !(_e959);
                }
            }
        }
        continue;
        continuing {
            phi_264_ = type_9(select(_e143.member, (_e143.member + 1u), _e146), select(_e143.member_1, _e143.member_1, _e146));
            break if !(_e159);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
