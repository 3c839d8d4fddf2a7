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
    var phi_212_: u32;
    var phi_260_: u32;
    var phi_263_: type_9;
    var phi_464_: u32;
    var phi_497_: u32;
    var phi_498_: u32;
    var phi_499_: bool;
    var phi_520_: type_14;
    var phi_523_: u32;
    var phi_525_: u32;
    var phi_521_: type_14;
    var phi_566_: type_15;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_599_: bool;
    var phi_524_: u32;
    var phi_526_: u32;
    var phi_600_: bool;
    var phi_605_: type_14;
    var phi_608_: u32;
    var phi_610_: u32;
    var phi_606_: type_14;
    var phi_651_: type_15;
    var phi_682_: u32;
    var phi_683_: u32;
    var phi_684_: bool;
    var phi_609_: u32;
    var phi_611_: u32;
    var phi_685_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_687_: u32;
    var phi_715_: bool;
    var phi_785_: type_9;
    var phi_994_: type_9;
    var phi_997_: type_26;
    var phi_1030_: type_9;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var local_10: bool;
    var phi_1101_: type_26;
    var phi_1102_: bool;
    var phi_998_: type_26;
    var phi_1103_: bool;
    var local_11: type_26;
    var local_12: type_26;
    var local_13: type_26;
    var local_14: type_26;
    var local_15: type_26;
    var local_16: type_26;
    var local_17: type_26;
    var phi_1160_: type_9;
    var phi_1281_: type_9;
    var phi_1388_: array<u32, 3>;
    var phi_1389_: array<u32, 3>;
    var phi_1553_: array<u32, 2>;
    var phi_1554_: array<u32, 2>;
    var phi_1555_: bool;
    var phi_1556_: array<u32, 2>;
    var phi_1557_: bool;
    var phi_1558_: array<u32, 2>;
    var phi_1559_: bool;
    var phi_1565_: array<u32, 2>;
    var phi_1573_: array<u32, 2>;
    var phi_1574_: bool;
    var phi_1575_: array<u32, 2>;
    var phi_1576_: bool;
    var phi_1588_: array<u32, 2>;
    var phi_1425_: f32;
    var phi_1426_: f32;
    var phi_1589_: array<u32, 2>;
    var phi_1600_: array<u32, 3>;
    var phi_1602_: array<u32, 3>;
    var phi_1619_: type_17;
    var phi_1622_: type_9;
    var phi_1681_: type_17;
    var phi_1682_: u32;
    var phi_1703_: type_9;
    var phi_1872_: type_9;
    var phi_1873_: type_9;
    var phi_1934_: type_9;
    var phi_2104_: type_9;
    var phi_2105_: type_9;
    var phi_2123_: bool;
    var phi_2124_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e88 = id_2;
    let _e89 = n_2;
    let _e90 = lane_2;
    let _e102 = ((_e88.y * _e89.x) + _e88.x);
    let _e105 = (_e89.x * _e89.y);
    let _e108 = params.member.member_1.member_2;
    let _e110 = work.member[0u];
    let _e112 = select(_e110, _e108, (_e108 < _e110));
    let _e114 = params.member.member_1.member_1;
    if (_e112 > _e114) {
        let _e117 = params.member.member_1.member_1;
        phi_212_ = (_e112 - _e117);
    } else {
        phi_212_ = 0u;
    }
    let _e120 = phi_212_;
    let _e122 = params.member.member_1.member;
    let _e124 = select(_e120, _e122, (_e122 < _e120));
    let _e128 = params.member.member.member_2[3u];
    if (_e124 > _e102) {
        let _e130 = (_e124 - _e102);
        if (_e105 == 0u) {
            return;
        }
        let _e132 = (_e130 / _e105);
        if (_e105 == 0u) {
            return;
        }
        phi_260_ = select(_e132, (_e132 + 1u), ((_e130 % _e105) > 0u));
    } else {
        phi_260_ = 0u;
    }
    let _e139 = phi_260_;
    phi_263_ = type_9(0u, _e139);
    loop {
        let _e142 = phi_263_;
        let _e145 = (_e142.member < _e142.member_1);
        let _e158 = (bitcast<i32>(select(0u, 1u, _e145)) != 0i);
        if _e158 {
            let _e161 = params.member.member_1.member_1;
            let _e165 = (2u * ((_e161 + _e102) + (select(type_9().member_1, _e142.member, _e145) * _e105)));
            let _e168 = work.member[(4u + _e165)];
            let _e171 = work.member[(_e165 + 5u)];
            let _e173 = (_e168 >> bitcast<u32>(24i));
            let _e177 = (_e168 & 16777215u);
            let _e181 = params.member.member_2.member;
            let _e184 = params.member.member_2.member_1;
            let _e185 = (_e184 == 0u);
            let _e194 = select(select(1u, 0u, _e185), select(1u, 2u, _e185), (_e173 >= (select(1u, 8u, (_e181 == 2u)) * select(1u, 10u, (_e181 == 2u)))));
            let _e196 = ((_e177 * 128u) + _e90);
            let _e200 = params.member.member.member_2[_e194];
            let _e201 = (_e200 + _e196);
            let _e205 = params.member.member.member[_e194];
            let _e206 = (_e196 < _e205);
            if _e206 {
                let _e209 = params.member.member_2.member;
                let _e212 = params.member.member_2.member_1;
                let _e213 = (_e212 == 0u);
                let _e222 = select(select(1u, 2u, _e213), select(1u, 0u, _e213), (_e173 >= (select(1u, 8u, (_e209 == 2u)) * select(1u, 10u, (_e209 == 2u)))));
                let _e224 = keys.member[_e201];
                let _e226 = sorted.member[_e201];
                local_7 = type_17(array<f32, 3>(_e226.member[0], _e226.member[1], _e226.member[2]), array<f32, 3>(_e226.member_1[0], _e226.member_1[1], _e226.member_1[2]));
                if (_e209 == 2u) {
                    phi_464_ = ((_e173 % 80u) / 10u);
                } else {
                    phi_464_ = 0u;
                }
                let _e242 = phi_464_;
                let _e250 = select(false, (_e173 >= (select(1u, 8u, (_e209 == 2u)) * select(1u, 10u, (_e209 == 2u)))), (_e242 == 0u));
                if (_e209 != 2u) {
                    phi_498_ = u32();
                    phi_499_ = true;
                } else {
                    if _e250 {
                        phi_497_ = u32();
                    } else {
                        let _e255 = (((_e224 >> bitcast<u32>(27u)) % 8u) + _e242);
                        phi_497_ = select(8u, _e255, (_e255 < 8u));
                    }
                    let _e259 = phi_497_;
                    phi_498_ = _e259;
                    phi_499_ = _e250;
                }
                let _e261 = phi_498_;
                let _e263 = phi_499_;
                let _e264 = select(_e261, 8u, _e263);
                if (_e264 < 8u) {
                    let _e270 = ((_e222 << bitcast<u32>(30u)) + (_e264 << bitcast<u32>(27u)));
                    let _e274 = params.member.member.member_2[3u];
                    phi_520_ = type_14(0i, 32i);
                    phi_523_ = 0u;
                    phi_525_ = _e274;
                    loop {
                        let _e277 = phi_520_;
                        let _e279 = phi_523_;
                        let _e281 = phi_525_;
                        local_8 = _e279;
                        if (_e277.member < _e277.member_1) {
                            let _e288 = (_e277.member + 1i);
                            phi_521_ = type_14(select(_e288, type_15().member_1, select(false, true, ((false == (_e288 > _e277.member)) != false))), _e277.member_1);
                            phi_566_ = type_15(1u, _e277.member);
                        } else {
                            phi_521_ = _e277;
                            phi_566_ = type_15(0u, type_15().member_1);
                        }
                        let _e299 = phi_521_;
                        let _e301 = phi_566_;
                        if (bitcast<i32>(_e301.member) != 0i) {
                            if (_e279 >= _e281) {
                                phi_597_ = u32();
                                phi_598_ = u32();
                                phi_599_ = false;
                            } else {
                                let _e308 = (_e279 + ((_e281 - _e279) / 2u));
                                let _e310 = keys.member[_e308];
                                let _e311 = (_e310 < (_e270 + 134217728u));
                                phi_597_ = select(_e279, (_e308 + 1u), _e311);
                                phi_598_ = select(_e308, _e281, _e311);
                                phi_599_ = true;
                            }
                            let _e316 = phi_597_;
                            let _e318 = phi_598_;
                            let _e320 = phi_599_;
                            phi_524_ = _e316;
                            phi_526_ = _e318;
                            phi_600_ = _e320;
                        } else {
                            phi_524_ = u32();
                            phi_526_ = u32();
                            phi_600_ = false;
                        }
                        let _e322 = phi_524_;
                        let _e324 = phi_526_;
                        let _e326 = phi_600_;
                        continue;
                        continuing {
                            phi_520_ = _e299;
                            phi_523_ = _e322;
                            phi_525_ = _e324;
                            break if !(_e326);
                        }
                    }
                    phi_605_ = type_14(0i, 32i);
                    phi_608_ = 0u;
                    phi_610_ = _e274;
                    loop {
                        let _e329 = phi_605_;
                        let _e331 = phi_608_;
                        let _e333 = phi_610_;
                        local_9 = _e331;
                        if (_e329.member < _e329.member_1) {
                            let _e340 = (_e329.member + 1i);
                            phi_606_ = type_14(select(_e340, type_15().member_1, select(false, true, ((false == (_e340 > _e329.member)) != false))), _e329.member_1);
                            phi_651_ = type_15(1u, _e329.member);
                        } else {
                            phi_606_ = _e329;
                            phi_651_ = type_15(0u, type_15().member_1);
                        }
                        let _e351 = phi_606_;
                        let _e353 = phi_651_;
                        if (bitcast<i32>(_e353.member) != 0i) {
                            if (_e331 >= _e333) {
                                phi_682_ = u32();
                                phi_683_ = u32();
                                phi_684_ = false;
                            } else {
                                let _e360 = (_e331 + ((_e333 - _e331) / 2u));
                                let _e362 = keys.member[_e360];
                                let _e363 = (_e362 < _e270);
                                phi_682_ = select(_e331, (_e360 + 1u), _e363);
                                phi_683_ = select(_e360, _e333, _e363);
                                phi_684_ = true;
                            }
                            let _e368 = phi_682_;
                            let _e370 = phi_683_;
                            let _e372 = phi_684_;
                            phi_609_ = _e368;
                            phi_611_ = _e370;
                            phi_685_ = _e372;
                        } else {
                            phi_609_ = u32();
                            phi_611_ = u32();
                            phi_685_ = false;
                        }
                        let _e374 = phi_609_;
                        let _e376 = phi_611_;
                        let _e378 = phi_685_;
                        continue;
                        continuing {
                            phi_605_ = _e351;
                            phi_608_ = _e374;
                            phi_610_ = _e376;
                            break if !(_e378);
                        }
                    }
                    let _e381 = local_8;
                    let _e383 = local_9;
                    phi_687_ = (_e381 - _e383);
                } else {
                    phi_687_ = 0u;
                }
                let _e386 = phi_687_;
                if (_e209 != 2u) {
                    phi_715_ = true;
                } else {
                    let _e388 = (_e386 == 0u);
                    let _e389 = (_e386 <= 256u);
                    let _e395 = ((_e173 % 80u) % 10u);
                    phi_715_ = select(false, (_e395 < select(select(9u, 10u, _e389), 0u, _e388)), (select(select(0u, 9u, _e389), 0u, _e388) <= _e395));
                }
                let _e400 = phi_715_;
                if _e400 {
                    if (_e209 == 2u) {
                        let _e403 = survey.member[6u];
                        let _e410 = bitcast<f32>(select(~(_e403), (_e403 & 2147483647u), ((_e403 >> bitcast<u32>(31i)) == 1u)));
                        let _e412 = survey.member[7u];
                        let _e419 = bitcast<f32>(select(~(_e412), (_e412 & 2147483647u), ((_e412 >> bitcast<u32>(31i)) == 1u)));
                        let _e421 = survey.member[8u];
                        let _e428 = bitcast<f32>(select(~(_e421), (_e421 & 2147483647u), ((_e421 >> bitcast<u32>(31i)) == 1u)));
                        local_5 = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_785_ = type_9(0u, 3u);
                        loop {
                            let _e430 = phi_785_;
                            let _e433 = (_e430.member < _e430.member_1);
                            let _e444 = select(type_9().member_1, _e430.member, _e433);
                            let _e446 = (bitcast<i32>(select(0u, 1u, _e433)) != 0i);
                            if _e446 {
                                let _e448 = survey.member[_e444];
                                let _e449 = ~(_e448);
                                local_5.member[_e444] = bitcast<f32>(select(~(_e449), (_e449 & 2147483647u), ((_e449 >> bitcast<u32>(31i)) == 1u)));
                                let _e461 = survey.member[(3u + _e444)];
                                local_5.member_1[_e444] = bitcast<f32>(select(~(_e461), (_e461 & 2147483647u), ((_e461 >> bitcast<u32>(31i)) == 1u)));
                            }
                            continue;
                            continuing {
                                phi_785_ = type_9(select(_e430.member, (_e430.member + 1u), _e433), select(_e430.member_1, _e430.member_1, _e433));
                                break if !(_e446);
                            }
                        }
                        let _e472 = local_5;
                        local_6 = type_23(_e472, array<f32, 3>(_e410, _e419, _e428));
                        if (_e242 == 0u) {
                            let _e763 = (_e224 & 134217727u);
                            phi_1388_ = array<u32, 3>((_e763 & 511u), ((_e763 >> bitcast<u32>(9u)) & 511u), (_e763 >> bitcast<u32>(18u)));
                        } else {
                            let _e493 = local_6.member.member_1[0u];
                            let _e497 = local_6.member.member[0u];
                            let _e502 = local_6.member.member_1[1u];
                            let _e506 = local_6.member.member[1u];
                            let _e511 = local_6.member.member_1[2u];
                            let _e515 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e493 * 0.5f) - (_e497 * 0.5f)), ((_e502 * 0.5f) - (_e506 * 0.5f)), ((_e511 * 0.5f) - (_e515 * 0.5f)));
                            phi_994_ = type_9(0u, 9u);
                            phi_997_ = type_26(type_23(type_17(array<f32, 3>(_e472.member[0], _e472.member[1], _e472.member[2]), array<f32, 3>(_e472.member_1[0], _e472.member_1[1], _e472.member_1[2])), array<f32, 3>(_e410, _e419, _e428)), 0u);
                            loop {
                                let _e520 = phi_994_;
                                let _e522 = phi_997_;
                                local_11 = _e522;
                                local_12 = _e522;
                                local_13 = _e522;
                                local_14 = _e522;
                                local_15 = _e522;
                                local_16 = _e522;
                                local_17 = _e522;
                                let _e525 = (_e520.member < _e520.member_1);
                                let _e536 = select(type_9().member_1, _e520.member, _e525);
                                if (bitcast<i32>(select(0u, 1u, _e525)) != 0i) {
                                    phi_1030_ = type_9(0u, 3u);
                                    phi_1033_ = true;
                                    loop {
                                        let _e540 = phi_1030_;
                                        let _e542 = phi_1033_;
                                        local_10 = _e542;
                                        let _e545 = (_e540.member < _e540.member_1);
                                        let _e556 = select(type_9().member_1, _e540.member, _e545);
                                        let _e558 = (bitcast<i32>(select(0u, 1u, _e545)) != 0i);
                                        if _e558 {
                                            let _e560 = local_3[_e556];
                                            let _e562 = (_e560 * (1f / 512f));
                                            let _e567 = local_6.member_1[_e556];
                                            phi_1034_ = select(_e542, false, ((_e567 * bitcast<f32>(((127u - _e536) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e562, (_e562 > 0.000000000000000000000000000006310887f))));
                                        } else {
                                            phi_1034_ = bool();
                                        }
                                        let _e576 = phi_1034_;
                                        continue;
                                        continuing {
                                            phi_1030_ = type_9(select(_e540.member, (_e540.member + 1u), _e545), select(_e540.member_1, _e540.member_1, _e545));
                                            phi_1033_ = _e576;
                                            break if !(_e558);
                                        }
                                    }
                                    let _e579 = local_10;
                                    if _e579 {
                                        phi_1101_ = type_26();
                                        phi_1102_ = false;
                                    } else {
                                        phi_1101_ = type_26(_e522.member, (_e536 + 1u));
                                        phi_1102_ = true;
                                    }
                                    let _e584 = phi_1101_;
                                    let _e586 = phi_1102_;
                                    phi_998_ = _e584;
                                    phi_1103_ = _e586;
                                } else {
                                    phi_998_ = type_26();
                                    phi_1103_ = false;
                                }
                                let _e588 = phi_998_;
                                let _e590 = phi_1103_;
                                continue;
                                continuing {
                                    phi_994_ = type_9(select(_e520.member, (_e520.member + 1u), _e525), select(_e520.member_1, _e520.member_1, _e525));
                                    phi_997_ = _e588;
                                    break if !(_e590);
                                }
                            }
                            let _e595 = (((_e224 >> bitcast<u32>(27u)) % 8u) + _e242);
                            let _e597 = select(8u, _e595, (_e595 < 8u));
                            let _e599 = local_11;
                            let _e604 = local_12;
                            let _e608 = local_13;
                            let _e614 = local_14;
                            let _e621 = bitcast<f32>(((127u - select((_e614.member_1 - _e597), 0u, ((_e597 + 1u) >= select(8u, (_e608.member_1 + 1u), (_e604.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e623 = local_15;
                            let _e629 = local_16;
                            let _e635 = local_17;
                            local_2.member = type_17(array<f32, 3>(_e599.member.member.member[0], _e599.member.member.member[1], _e599.member.member.member[2]), array<f32, 3>(_e599.member.member.member_1[0], _e599.member.member.member_1[1], _e599.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e623.member.member_1[0] * _e621), (_e629.member.member_1[1] * _e621), (_e635.member.member_1[2] * _e621));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_1160_ = type_9(0u, 3u);
                            loop {
                                let _e657 = phi_1160_;
                                let _e660 = (_e657.member < _e657.member_1);
                                let _e671 = select(type_9().member_1, _e657.member, _e660);
                                let _e673 = (bitcast<i32>(select(0u, 1u, _e660)) != 0i);
                                if _e673 {
                                    let _e677 = local_2.member.member[_e671];
                                    let _e681 = local_2.member.member_1[_e671];
                                    let _e686 = (((_e681 * 0.5f) - (_e677 * 0.5f)) * (1f / 512f));
                                    let _e689 = local_2.member_1[_e671];
                                    let _e692 = local_2.member_1[_e671];
                                    let _e694 = (_e689 + (_e692 * 0.00390625f));
                                    let _e696 = select(_e694, _e686, (_e686 > _e694));
                                    local_1.member[_e671] = (_e677 * 0.25f);
                                    local_1.member_1[_e671] = (1f / select(_e696, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e696)));
                                }
                                continue;
                                continuing {
                                    phi_1160_ = type_9(select(_e657.member, (_e657.member + 1u), _e660), select(_e657.member_1, _e657.member_1, _e660));
                                    break if !(_e673);
                                }
                            }
                            let _e706 = local_1;
                            local_4 = _e706;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1281_ = type_9(0u, 3u);
                            loop {
                                let _e708 = phi_1281_;
                                let _e711 = (_e708.member < _e708.member_1);
                                let _e722 = select(type_9().member_1, _e708.member, _e711);
                                let _e724 = (bitcast<i32>(select(0u, 1u, _e711)) != 0i);
                                if _e724 {
                                    let _e727 = local_4.member[_e722];
                                    let _e730 = local_7.member[_e722];
                                    let _e732 = ((_e730 * 0.25f) - _e727);
                                    let _e737 = local_7.member_1[_e722];
                                    let _e739 = ((_e737 * 0.25f) - _e727);
                                    let _e745 = local_4.member_1[_e722];
                                    let _e746 = ((select(0f, _e732, (_e732 > 0f)) + select(0f, _e739, (_e739 > 0f))) * _e745);
                                    local[_e722] = select(select(0u, select(select(u32(_e746), 0u, (_e746 < 0f)), 4294967295u, (_e746 > 4294967000f)), (_e746 > 0f)), 511u, (_e746 >= 511f));
                                }
                                continue;
                                continuing {
                                    phi_1281_ = type_9(select(_e708.member, (_e708.member + 1u), _e711), select(_e708.member_1, _e708.member_1, _e711));
                                    break if !(_e724);
                                }
                            }
                            let _e758 = local;
                            phi_1388_ = array<u32, 3>(_e758[0], _e758[1], _e758[2]);
                        }
                        let _e772 = phi_1388_;
                        phi_1389_ = _e772;
                    } else {
                        phi_1389_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e774 = phi_1389_;
                    let _e776 = (_e222 << bitcast<u32>(30u));
                    if (_e209 == 1u) {
                        let _e890 = survey.member[6u];
                        if (_e890 == 0u) {
                            let _e900 = local_7.member_1[0u];
                            phi_1426_ = _e900;
                        } else {
                            if (_e890 == 1u) {
                                let _e896 = local_7.member_1[1u];
                                phi_1425_ = _e896;
                            } else {
                                let _e894 = local_7.member_1[2u];
                                phi_1425_ = _e894;
                            }
                            let _e898 = phi_1425_;
                            phi_1426_ = _e898;
                        }
                        let _e902 = phi_1426_;
                        let _e903 = bitcast<u32>(_e902);
                        let _e907 = bitcast<u32>(bitcast<f32>(select(_e903, 0u, (_e903 == 2147483648u))));
                        phi_1589_ = array<u32, 2>(((_e776 | (_e224 & 1073741823u)) + _e173), (_e776 | (select((_e907 | 2147483648u), ~(_e907), ((_e907 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i))));
                    } else {
                        if (_e209 == 2u) {
                            let _e780 = (_e173 % 80u);
                            let _e782 = (_e780 % 10u);
                            let _e785 = select(false, ((_e780 / 10u) == 0u), (_e212 == 1u));
                            if (_e264 >= 8u) {
                                phi_1575_ = array<u32, 2>();
                                phi_1576_ = true;
                            } else {
                                if select(true, select(true, false, (_e782 < 4u)), _e785) {
                                    if (_e782 == 9u) {
                                        phi_1565_ = array<u32, 2>(0u, 134217727u);
                                    } else {
                                        let _e793 = (_e774[1] + (_e782 % 3u));
                                        let _e796 = (_e774[2] + (_e782 / 3u));
                                        if (_e793 < 1u) {
                                            phi_1558_ = array<u32, 2>();
                                            phi_1559_ = true;
                                        } else {
                                            if (_e796 < 1u) {
                                                phi_1556_ = array<u32, 2>();
                                                phi_1557_ = true;
                                            } else {
                                                if (_e793 > 512u) {
                                                    phi_1554_ = array<u32, 2>();
                                                    phi_1555_ = true;
                                                } else {
                                                    let _e800 = (_e796 > 512u);
                                                    if _e800 {
                                                        phi_1553_ = array<u32, 2>();
                                                    } else {
                                                        let _e802 = (_e774[0] > 0u);
                                                        let _e805 = select(true, select(true, false, (_e782 == 4u)), _e785);
                                                        phi_1553_ = array<u32, 2>(((((_e796 - 1u) << bitcast<u32>(18u)) | ((_e793 - 1u) << bitcast<u32>(9u))) | select(select(u32(), select(u32(), (_e774[0] - 1u), _e805), _e802), _e774[0], select(true, select(true, false, _e805), _e802))), ((((_e796 - 1u) << bitcast<u32>(18u)) | ((_e793 - 1u) << bitcast<u32>(9u))) | select(_e774[0], (_e774[0] + 1u), ((_e774[0] + 1u) < 512u))));
                                                    }
                                                    let _e839 = phi_1553_;
                                                    phi_1554_ = _e839;
                                                    phi_1555_ = _e800;
                                                }
                                                let _e841 = phi_1554_;
                                                let _e843 = phi_1555_;
                                                phi_1556_ = _e841;
                                                phi_1557_ = _e843;
                                            }
                                            let _e845 = phi_1556_;
                                            let _e847 = phi_1557_;
                                            phi_1558_ = _e845;
                                            phi_1559_ = _e847;
                                        }
                                        let _e849 = phi_1558_;
                                        let _e851 = phi_1559_;
                                        phi_1565_ = array<u32, 2>(select(_e849[0], 1u, _e851), select(_e849[1], 0u, _e851));
                                    }
                                    let _e858 = phi_1565_;
                                    phi_1573_ = array<u32, 2>(((_e264 << bitcast<u32>(27u)) | _e858[0]), ((_e264 << bitcast<u32>(27u)) | _e858[1]));
                                    phi_1574_ = false;
                                } else {
                                    phi_1573_ = array<u32, 2>();
                                    phi_1574_ = true;
                                }
                                let _e869 = phi_1573_;
                                let _e871 = phi_1574_;
                                phi_1575_ = _e869;
                                phi_1576_ = _e871;
                            }
                            let _e873 = phi_1575_;
                            let _e875 = phi_1576_;
                            phi_1588_ = array<u32, 2>((_e776 | select(_e873[0], 1u, _e875)), (_e776 | select(_e873[1], 0u, _e875)));
                        } else {
                            phi_1588_ = array<u32, 2>(_e776, _e776);
                        }
                        let _e884 = phi_1588_;
                        phi_1589_ = _e884;
                    }
                    let _e919 = phi_1589_;
                    phi_1600_ = array<u32, 3>(_e919[0], _e919[1], select(0u, (_e201 + 1u), (_e212 == 1u)));
                } else {
                    phi_1600_ = array<u32, 3>(4294967295u, 0u, 0u);
                }
                let _e927 = phi_1600_;
                phi_1602_ = _e927;
            } else {
                phi_1602_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e929 = phi_1602_;
            if _e206 {
                let _e934 = sorted.member[_e201];
                phi_1619_ = _e934;
            } else {
                phi_1619_ = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e936 = phi_1619_;
            phi_1622_ = type_9(0u, ((_e171 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e939 = phi_1622_;
                let _e942 = (_e939.member < _e939.member_1);
                let _e955 = (bitcast<i32>(select(0u, 1u, _e942)) != 0i);
                if _e955 {
                    let _e957 = ((_e171 & 536870911u) + (select(type_9().member_1, _e939.member, _e942) * 128u));
                    let _e958 = (_e957 + _e90);
                    if (_e958 < _e128) {
                        let _e961 = keys.member[_e958];
                        let _e963 = sorted.member[_e958];
                        phi_1681_ = _e963;
                        phi_1682_ = _e961;
                    } else {
                        phi_1681_ = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1682_ = 4294967295u;
                    }
                    let _e965 = phi_1681_;
                    let _e967 = phi_1682_;
                    names[_e90] = _e967;
                    boxes[_e90] = type_17(array<f32, 3>(_e965.member[0], _e965.member[1], _e965.member[2]), array<f32, 3>(_e965.member_1[0], _e965.member_1[1], _e965.member_1[2]));
                    if (_e90 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1703_ = type_9(0u, 128u);
                    loop {
                        let _e984 = phi_1703_;
                        let _e987 = (_e984.member < _e984.member_1);
                        let _e998 = select(type_9().member_1, _e984.member, _e987);
                        let _e1000 = (bitcast<i32>(select(0u, 1u, _e987)) != 0i);
                        if _e1000 {
                            let _e1002 = names[_e998];
                            if (_e1002 >= _e929[0]) {
                                if (_e1002 <= _e929[1]) {
                                    if ((_e957 + _e998) >= _e929[2]) {
                                        let _e1008 = boxes[_e998];
                                        if ((((((_e936.member[0] <= _e1008.member_1[0]) && (_e1008.member[0] <= _e936.member_1[0])) && (_e936.member[1] <= _e1008.member_1[1])) && (_e1008.member[1] <= _e936.member_1[1])) && (_e936.member[2] <= _e1008.member_1[2])) && (_e1008.member[2] <= _e936.member_1[2])) {
                                            let _e1041 = atomicAdd((&counters[0u]), 1u);
                                            if (_e1041 < 2048u) {
                                                hits[_e1041] = ((_e90 << bitcast<u32>(7i)) | _e998);
                                            } else {
                                                let _e1045 = order.member[_e201];
                                                let _e1047 = order.member[(_e957 + _e998)];
                                                let _e1050 = params.member.member_2.member_1;
                                                if (_e1050 == 1u) {
                                                    let _e1078 = params.member.member.member_2[1u];
                                                    let _e1079 = (_e1045 - _e1078);
                                                    let _e1083 = params.member.member.member_2[1u];
                                                    let _e1084 = (_e1047 - _e1083);
                                                    let _e1085 = (_e1079 < _e1084);
                                                    phi_1873_ = type_9(select(_e1084, _e1079, _e1085), select(_e1079, _e1084, _e1085));
                                                } else {
                                                    let _e1054 = params.member.member_2.member;
                                                    if (_e173 >= (select(1u, 8u, (_e1054 == 2u)) * select(1u, 10u, (_e1054 == 2u)))) {
                                                        let _e1070 = params.member.member.member_2[2u];
                                                        phi_1872_ = type_9(_e1047, (_e1045 - _e1070));
                                                    } else {
                                                        let _e1064 = params.member.member.member_2[2u];
                                                        phi_1872_ = type_9(_e1045, (_e1047 - _e1064));
                                                    }
                                                    let _e1074 = phi_1872_;
                                                    phi_1873_ = _e1074;
                                                }
                                                let _e1090 = phi_1873_;
                                                let _e1095 = params.member.member_1.member_3;
                                                let _e1097 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1097 + 1u) < _e1097) {
                                                    let _e1101 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1097 < _e1095) {
                                                    let _e1103 = (2u * _e1097);
                                                    atomicStore((&pairs.member[(4u + _e1103)]), _e1090.member);
                                                    atomicStore((&pairs.member[(_e1103 + 5u)]), _e1090.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1703_ = type_9(select(_e984.member, (_e984.member + 1u), _e987), select(_e984.member_1, _e984.member_1, _e987));
                            break if !(_e1000);
                        }
                    }
                    workgroupBarrier();
                    let _e1114 = atomicLoad((&counters[0u]));
                    let _e1116 = select(_e1114, 2048u, (2048u < _e1114));
                    if (_e90 == 0u) {
                        if (_e1116 > 0u) {
                            let _e1120 = atomicAdd((&pairs.member[0u]), _e1116);
                            if ((_e1120 + _e1116) < _e1120) {
                                let _e1124 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1120);
                        }
                    }
                    workgroupBarrier();
                    let _e1127 = atomicLoad((&counters[1u]));
                    phi_1934_ = type_9(0u, 16u);
                    loop {
                        let _e1129 = phi_1934_;
                        let _e1132 = (_e1129.member < _e1129.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e1132)) != 0i) {
                            let _e1147 = ((select(type_9().member_1, _e1129.member, _e1132) * 128u) + _e90);
                            if (_e1147 >= _e1116) {
                                phi_2123_ = false;
                            } else {
                                let _e1150 = hits[_e1147];
                                let _e1155 = params.member.member_2.member;
                                let _e1158 = params.member.member_2.member_1;
                                let _e1159 = (_e1158 == 0u);
                                let _e1174 = params.member.member.member_2[select(select(1u, 0u, _e1159), select(1u, 2u, _e1159), (_e173 >= (select(1u, 8u, (_e1155 == 2u)) * select(1u, 10u, (_e1155 == 2u)))))];
                                let _e1179 = order.member[(_e1174 + ((_e177 * 128u) + (_e1150 >> bitcast<u32>(7i))))];
                                let _e1181 = order.member[(_e957 + (_e1150 % 128u))];
                                let _e1184 = params.member.member_2.member_1;
                                if (_e1184 == 1u) {
                                    let _e1212 = params.member.member.member_2[1u];
                                    let _e1213 = (_e1179 - _e1212);
                                    let _e1217 = params.member.member.member_2[1u];
                                    let _e1218 = (_e1181 - _e1217);
                                    let _e1219 = (_e1213 < _e1218);
                                    phi_2105_ = type_9(select(_e1218, _e1213, _e1219), select(_e1213, _e1218, _e1219));
                                } else {
                                    let _e1188 = params.member.member_2.member;
                                    if (_e173 >= (select(1u, 8u, (_e1188 == 2u)) * select(1u, 10u, (_e1188 == 2u)))) {
                                        let _e1204 = params.member.member.member_2[2u];
                                        phi_2104_ = type_9(_e1181, (_e1179 - _e1204));
                                    } else {
                                        let _e1198 = params.member.member.member_2[2u];
                                        phi_2104_ = type_9(_e1179, (_e1181 - _e1198));
                                    }
                                    let _e1208 = phi_2104_;
                                    phi_2105_ = _e1208;
                                }
                                let _e1224 = phi_2105_;
                                let _e1229 = params.member.member_1.member_3;
                                let _e1230 = (_e1127 + _e1147);
                                if (_e1230 < _e1229) {
                                    let _e1232 = (2u * _e1230);
                                    atomicStore((&pairs.member[(4u + _e1232)]), _e1224.member);
                                    atomicStore((&pairs.member[(_e1232 + 5u)]), _e1224.member_1);
                                }
                                phi_2123_ = true;
                            }
                            let _e1238 = phi_2123_;
                            phi_2124_ = _e1238;
                        } else {
                            phi_2124_ = false;
                        }
                        let _e1240 = phi_2124_;
                        continue;
                        continuing {
                            phi_1934_ = type_9(select(_e1129.member, (_e1129.member + 1u), _e1132), select(_e1129.member_1, _e1129.member_1, _e1132));
                            break if !(_e1240);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1622_ = type_9(select(_e939.member, (_e939.member + 1u), _e942), select(_e939.member_1, _e939.member_1, _e942));
                    break if !(_e955);
                }
            }
        }
        continue;
        continuing {
            phi_263_ = type_9(select(_e142.member, (_e142.member + 1u), _e145), select(_e142.member_1, _e142.member_1, _e145));
            break if !(_e158);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
