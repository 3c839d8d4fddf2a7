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

struct type_21 {
    member: type_17,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_23 {
    member: type_22,
}

struct type_24 {
    member: type_21,
    member_1: u32,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> sorted: type_19;
@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(3) 
var<storage> survey: type_11;
@group(0) @binding(4) 
var<storage, read_write> work: type_27;
var<workgroup> ranges: array<atomic<u32>, 656>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_17;
    var local_2: type_21;
    var local_3: array<f32, 3>;
    var local_4: type_17;
    var local_5: type_17;
    var local_6: type_21;
    var local_7: type_17;
    var phi_214_: type_14;
    var phi_217_: u32;
    var phi_219_: u32;
    var phi_215_: type_14;
    var phi_260_: type_15;
    var phi_291_: u32;
    var phi_292_: u32;
    var phi_293_: bool;
    var phi_218_: u32;
    var phi_220_: u32;
    var phi_294_: bool;
    var local_8: u32;
    var phi_399_: type_9;
    var phi_463_: u32;
    var phi_464_: u32;
    var phi_465_: bool;
    var phi_486_: u32;
    var phi_505_: array<u32, 2>;
    var phi_576_: type_9;
    var phi_785_: type_9;
    var phi_788_: type_24;
    var phi_821_: type_9;
    var phi_824_: bool;
    var phi_825_: bool;
    var local_9: bool;
    var phi_892_: type_24;
    var phi_893_: bool;
    var phi_789_: type_24;
    var phi_894_: bool;
    var local_10: type_24;
    var local_11: type_24;
    var local_12: type_24;
    var local_13: type_24;
    var local_14: type_24;
    var local_15: type_24;
    var local_16: type_24;
    var phi_951_: type_9;
    var phi_1044_: f32;
    var phi_1077_: type_9;
    var phi_1184_: array<u32, 3>;
    var phi_1185_: array<u32, 3>;
    var phi_1186_: array<u32, 3>;
    var phi_1189_: type_9;
    var phi_1443_: array<u32, 2>;
    var phi_1444_: array<u32, 2>;
    var phi_1445_: bool;
    var phi_1446_: array<u32, 2>;
    var phi_1447_: bool;
    var phi_1448_: array<u32, 2>;
    var phi_1449_: bool;
    var phi_1455_: array<u32, 2>;
    var phi_1463_: array<u32, 2>;
    var phi_1464_: bool;
    var phi_1465_: array<u32, 2>;
    var phi_1466_: bool;
    var phi_1478_: array<u32, 2>;
    var phi_1479_: array<u32, 2>;
    var phi_1504_: type_14;
    var phi_1507_: u32;
    var phi_1509_: u32;
    var phi_1505_: type_14;
    var phi_1550_: type_15;
    var phi_1581_: u32;
    var phi_1582_: u32;
    var phi_1583_: bool;
    var phi_1508_: u32;
    var phi_1510_: u32;
    var phi_1584_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_1600_: u32;
    var phi_1604_: type_14;
    var phi_1607_: u32;
    var phi_1609_: u32;
    var phi_1605_: type_14;
    var phi_1650_: type_15;
    var phi_1681_: u32;
    var phi_1682_: u32;
    var phi_1683_: bool;
    var phi_1608_: u32;
    var phi_1610_: u32;
    var phi_1684_: bool;
    var local_19: u32;
    var local_20: u32;
    var phi_1718_: u32;
    var phi_1719_: u32;
    var phi_1720_: u32;
    var phi_1721_: u32;
    var phi_1736_: type_9;
    var phi_1795_: u32;
    var phi_1814_: type_9;
    var local_21: u32;
    var local_22: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e80 = id_2;
    let _e81 = n_2;
    let _e82 = lane_2;
    let _e92 = ((_e80.y * _e81.x) + _e80.x);
    let _e95 = params.member.member_2.member;
    let _e98 = params.member.member_2.member_1;
    let _e101 = params.member.member_2.member_2;
    let _e105 = params.member.member.member_2[3u];
    let _e107 = select(1u, 10u, (_e95 == 2u));
    let _e108 = (_e98 == 0u);
    atomicStore((&ranges[_e82]), 4294967295u);
    atomicStore((&ranges[(128u + _e82)]), 0u);
    if (_e82 <= 8u) {
        phi_214_ = type_14(0i, 32i);
        phi_217_ = 0u;
        phi_219_ = _e105;
        loop {
            let _e129 = phi_214_;
            let _e131 = phi_217_;
            let _e133 = phi_219_;
            local_8 = _e131;
            if (_e129.member < _e129.member_1) {
                let _e140 = (_e129.member + 1i);
                phi_215_ = type_14(select(_e140, type_15().member_1, select(false, true, ((false == (_e140 > _e129.member)) != false))), _e129.member_1);
                phi_260_ = type_15(1u, _e129.member);
            } else {
                phi_215_ = _e129;
                phi_260_ = type_15(0u, type_15().member_1);
            }
            let _e151 = phi_215_;
            let _e153 = phi_260_;
            if (bitcast<i32>(_e153.member) != 0i) {
                if (_e131 >= _e133) {
                    phi_291_ = u32();
                    phi_292_ = u32();
                    phi_293_ = false;
                } else {
                    let _e160 = (_e131 + ((_e133 - _e131) / 2u));
                    let _e162 = keys.member[_e160];
                    let _e163 = (_e162 < ((select(select(1u, 2u, _e108), select(1u, 0u, _e108), (_e101 >= (select(1u, 8u, (_e95 == 2u)) * select(1u, 10u, (_e95 == 2u))))) << bitcast<u32>(30u)) + (_e82 << bitcast<u32>(27u))));
                    phi_291_ = select(_e131, (_e160 + 1u), _e163);
                    phi_292_ = select(_e160, _e133, _e163);
                    phi_293_ = true;
                }
                let _e168 = phi_291_;
                let _e170 = phi_292_;
                let _e172 = phi_293_;
                phi_218_ = _e168;
                phi_220_ = _e170;
                phi_294_ = _e172;
            } else {
                phi_218_ = u32();
                phi_220_ = u32();
                phi_294_ = false;
            }
            let _e174 = phi_218_;
            let _e176 = phi_220_;
            let _e178 = phi_294_;
            continue;
            continuing {
                phi_214_ = _e151;
                phi_217_ = _e174;
                phi_219_ = _e176;
                break if !(_e178);
            }
        }
        let _e182 = local_8;
        atomicStore((&ranges[(640u + _e82)]), _e182);
    }
    workgroupBarrier();
    let _e185 = params.member.member_2.member;
    let _e188 = params.member.member_2.member_1;
    let _e189 = (_e188 == 0u);
    let _e198 = select(select(1u, 0u, _e189), select(1u, 2u, _e189), (_e101 >= (select(1u, 8u, (_e185 == 2u)) * select(1u, 10u, (_e185 == 2u)))));
    let _e200 = ((_e92 * 128u) + _e82);
    let _e204 = params.member.member.member_2[_e198];
    let _e205 = (_e204 + _e200);
    let _e209 = params.member.member.member[_e198];
    if (_e200 < _e209) {
        let _e212 = keys.member[_e205];
        let _e214 = sorted.member[_e205];
        local_7 = type_17(array<f32, 3>(_e214.member[0], _e214.member[1], _e214.member[2]), array<f32, 3>(_e214.member_1[0], _e214.member_1[1], _e214.member_1[2]));
        phi_399_ = type_9(0u, select(1u, 8u, (_e95 == 2u)));
        loop {
            let _e230 = phi_399_;
            let _e233 = (_e230.member < _e230.member_1);
            let _e244 = select(type_9().member_1, _e230.member, _e233);
            let _e246 = (bitcast<i32>(select(0u, 1u, _e233)) != 0i);
            if _e246 {
                let _e254 = select(false, (_e101 >= (select(1u, 8u, (_e95 == 2u)) * select(1u, 10u, (_e95 == 2u)))), (_e244 == 0u));
                if (_e95 != 2u) {
                    phi_464_ = u32();
                    phi_465_ = true;
                } else {
                    if _e254 {
                        phi_463_ = u32();
                    } else {
                        let _e259 = (((_e212 >> bitcast<u32>(27u)) % 8u) + _e244);
                        phi_463_ = select(8u, _e259, (_e259 < 8u));
                    }
                    let _e263 = phi_463_;
                    phi_464_ = _e263;
                    phi_465_ = _e254;
                }
                let _e265 = phi_464_;
                let _e267 = phi_465_;
                let _e268 = select(_e265, 8u, _e267);
                let _e270 = select(_e268, 7u, (7u < _e268));
                if (_e268 < 8u) {
                    let _e275 = atomicLoad((&ranges[(_e270 + 641u)]));
                    let _e277 = atomicLoad((&ranges[(640u + _e270)]));
                    phi_486_ = (_e275 - _e277);
                } else {
                    phi_486_ = 0u;
                }
                let _e280 = phi_486_;
                if (_e95 == 2u) {
                    let _e282 = (_e280 == 0u);
                    let _e283 = (_e280 <= 256u);
                    phi_505_ = array<u32, 2>(select(select(0u, 9u, _e283), 0u, _e282), select(select(9u, 10u, _e283), 0u, _e282));
                } else {
                    phi_505_ = array<u32, 2>(0u, 1u);
                }
                let _e290 = phi_505_;
                if (_e290[0] < _e290[1]) {
                    if (_e95 == 2u) {
                        let _e296 = survey.member[6u];
                        let _e303 = bitcast<f32>(select(~(_e296), (_e296 & 2147483647u), ((_e296 >> bitcast<u32>(31i)) == 1u)));
                        let _e305 = survey.member[7u];
                        let _e312 = bitcast<f32>(select(~(_e305), (_e305 & 2147483647u), ((_e305 >> bitcast<u32>(31i)) == 1u)));
                        let _e314 = survey.member[8u];
                        let _e321 = bitcast<f32>(select(~(_e314), (_e314 & 2147483647u), ((_e314 >> bitcast<u32>(31i)) == 1u)));
                        local_5 = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_576_ = type_9(0u, 3u);
                        loop {
                            let _e323 = phi_576_;
                            let _e326 = (_e323.member < _e323.member_1);
                            let _e337 = select(type_9().member_1, _e323.member, _e326);
                            let _e339 = (bitcast<i32>(select(0u, 1u, _e326)) != 0i);
                            if _e339 {
                                let _e341 = survey.member[_e337];
                                let _e342 = ~(_e341);
                                local_5.member[_e337] = bitcast<f32>(select(~(_e342), (_e342 & 2147483647u), ((_e342 >> bitcast<u32>(31i)) == 1u)));
                                let _e354 = survey.member[(3u + _e337)];
                                local_5.member_1[_e337] = bitcast<f32>(select(~(_e354), (_e354 & 2147483647u), ((_e354 >> bitcast<u32>(31i)) == 1u)));
                            }
                            continue;
                            continuing {
                                phi_576_ = type_9(select(_e323.member, (_e323.member + 1u), _e326), select(_e323.member_1, _e323.member_1, _e326));
                                break if !(_e339);
                            }
                        }
                        let _e365 = local_5;
                        local_6 = type_21(_e365, array<f32, 3>(_e303, _e312, _e321));
                        if (_e244 == 0u) {
                            let _e659 = (_e212 & 134217727u);
                            phi_1184_ = array<u32, 3>((_e659 & 511u), ((_e659 >> bitcast<u32>(9u)) & 511u), (_e659 >> bitcast<u32>(18u)));
                        } else {
                            let _e386 = local_6.member.member_1[0u];
                            let _e390 = local_6.member.member[0u];
                            let _e395 = local_6.member.member_1[1u];
                            let _e399 = local_6.member.member[1u];
                            let _e404 = local_6.member.member_1[2u];
                            let _e408 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e386 * 0.5f) - (_e390 * 0.5f)), ((_e395 * 0.5f) - (_e399 * 0.5f)), ((_e404 * 0.5f) - (_e408 * 0.5f)));
                            phi_785_ = type_9(0u, 9u);
                            phi_788_ = type_24(type_21(type_17(array<f32, 3>(_e365.member[0], _e365.member[1], _e365.member[2]), array<f32, 3>(_e365.member_1[0], _e365.member_1[1], _e365.member_1[2])), array<f32, 3>(_e303, _e312, _e321)), 0u);
                            loop {
                                let _e413 = phi_785_;
                                let _e415 = phi_788_;
                                local_10 = _e415;
                                local_11 = _e415;
                                local_12 = _e415;
                                local_13 = _e415;
                                local_14 = _e415;
                                local_15 = _e415;
                                local_16 = _e415;
                                let _e418 = (_e413.member < _e413.member_1);
                                let _e429 = select(type_9().member_1, _e413.member, _e418);
                                if (bitcast<i32>(select(0u, 1u, _e418)) != 0i) {
                                    phi_821_ = type_9(0u, 3u);
                                    phi_824_ = true;
                                    loop {
                                        let _e433 = phi_821_;
                                        let _e435 = phi_824_;
                                        local_9 = _e435;
                                        let _e438 = (_e433.member < _e433.member_1);
                                        let _e449 = select(type_9().member_1, _e433.member, _e438);
                                        let _e451 = (bitcast<i32>(select(0u, 1u, _e438)) != 0i);
                                        if _e451 {
                                            let _e453 = local_3[_e449];
                                            let _e455 = (_e453 * (1f / 512f));
                                            let _e460 = local_6.member_1[_e449];
                                            phi_825_ = select(_e435, false, ((_e460 * bitcast<f32>(((127u - _e429) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e455, (_e455 > 0.000000000000000000000000000006310887f))));
                                        } else {
                                            phi_825_ = bool();
                                        }
                                        let _e469 = phi_825_;
                                        continue;
                                        continuing {
                                            phi_821_ = type_9(select(_e433.member, (_e433.member + 1u), _e438), select(_e433.member_1, _e433.member_1, _e438));
                                            phi_824_ = _e469;
                                            break if !(_e451);
                                        }
                                    }
                                    let _e472 = local_9;
                                    if _e472 {
                                        phi_892_ = type_24();
                                        phi_893_ = false;
                                    } else {
                                        phi_892_ = type_24(_e415.member, (_e429 + 1u));
                                        phi_893_ = true;
                                    }
                                    let _e477 = phi_892_;
                                    let _e479 = phi_893_;
                                    phi_789_ = _e477;
                                    phi_894_ = _e479;
                                } else {
                                    phi_789_ = type_24();
                                    phi_894_ = false;
                                }
                                let _e481 = phi_789_;
                                let _e483 = phi_894_;
                                continue;
                                continuing {
                                    phi_785_ = type_9(select(_e413.member, (_e413.member + 1u), _e418), select(_e413.member_1, _e413.member_1, _e418));
                                    phi_788_ = _e481;
                                    break if !(_e483);
                                }
                            }
                            let _e488 = (((_e212 >> bitcast<u32>(27u)) % 8u) + _e244);
                            let _e490 = select(8u, _e488, (_e488 < 8u));
                            let _e492 = local_10;
                            let _e497 = local_11;
                            let _e501 = local_12;
                            let _e507 = local_13;
                            let _e514 = bitcast<f32>(((127u - select((_e507.member_1 - _e490), 0u, ((_e490 + 1u) >= select(8u, (_e501.member_1 + 1u), (_e497.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e516 = local_14;
                            let _e522 = local_15;
                            let _e528 = local_16;
                            local_2.member = type_17(array<f32, 3>(_e492.member.member.member[0], _e492.member.member.member[1], _e492.member.member.member[2]), array<f32, 3>(_e492.member.member.member_1[0], _e492.member.member.member_1[1], _e492.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e516.member.member_1[0] * _e514), (_e522.member.member_1[1] * _e514), (_e528.member.member_1[2] * _e514));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_951_ = type_9(0u, 3u);
                            loop {
                                let _e550 = phi_951_;
                                let _e553 = (_e550.member < _e550.member_1);
                                let _e564 = select(type_9().member_1, _e550.member, _e553);
                                let _e566 = (bitcast<i32>(select(0u, 1u, _e553)) != 0i);
                                if _e566 {
                                    let _e570 = local_2.member.member[_e564];
                                    let _e574 = local_2.member.member_1[_e564];
                                    let _e579 = (((_e574 * 0.5f) - (_e570 * 0.5f)) * (1f / 512f));
                                    let _e582 = local_2.member_1[_e564];
                                    let _e585 = local_2.member_1[_e564];
                                    let _e587 = (_e582 + (_e585 * 0.00390625f));
                                    let _e589 = select(_e587, _e579, (_e579 > _e587));
                                    let _e591 = select(_e589, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e589));
                                    local_1.member[_e564] = (_e570 * 0.25f);
                                    if (_e591 > 5316912000000000000000000000000000000f) {
                                        phi_1044_ = 0f;
                                    } else {
                                        phi_1044_ = (1f / _e591);
                                    }
                                    let _e598 = phi_1044_;
                                    local_1.member_1[_e564] = _e598;
                                }
                                continue;
                                continuing {
                                    phi_951_ = type_9(select(_e550.member, (_e550.member + 1u), _e553), select(_e550.member_1, _e550.member_1, _e553));
                                    break if !(_e566);
                                }
                            }
                            let _e602 = local_1;
                            local_4 = _e602;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1077_ = type_9(0u, 3u);
                            loop {
                                let _e604 = phi_1077_;
                                let _e607 = (_e604.member < _e604.member_1);
                                let _e618 = select(type_9().member_1, _e604.member, _e607);
                                let _e620 = (bitcast<i32>(select(0u, 1u, _e607)) != 0i);
                                if _e620 {
                                    let _e623 = local_4.member[_e618];
                                    let _e626 = local_7.member[_e618];
                                    let _e628 = ((_e626 * 0.25f) - _e623);
                                    let _e633 = local_7.member_1[_e618];
                                    let _e635 = ((_e633 * 0.25f) - _e623);
                                    let _e641 = local_4.member_1[_e618];
                                    let _e642 = ((select(0f, _e628, (_e628 > 0f)) + select(0f, _e635, (_e635 > 0f))) * _e641);
                                    local[_e618] = select(select(0u, select(select(u32(_e642), 0u, (_e642 < 0f)), 4294967295u, (_e642 > 4294967000f)), (_e642 > 0f)), 511u, (_e642 >= 511f));
                                }
                                continue;
                                continuing {
                                    phi_1077_ = type_9(select(_e604.member, (_e604.member + 1u), _e607), select(_e604.member_1, _e604.member_1, _e607));
                                    break if !(_e620);
                                }
                            }
                            let _e654 = local;
                            phi_1184_ = array<u32, 3>(_e654[0], _e654[1], _e654[2]);
                        }
                        let _e668 = phi_1184_;
                        phi_1185_ = _e668;
                    } else {
                        phi_1185_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e670 = phi_1185_;
                    phi_1186_ = _e670;
                } else {
                    phi_1186_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e672 = phi_1186_;
                phi_1189_ = type_9(_e290[0], _e290[1]);
                loop {
                    let _e675 = phi_1189_;
                    let _e678 = (_e675.member < _e675.member_1);
                    let _e691 = (bitcast<i32>(select(0u, 1u, _e678)) != 0i);
                    if _e691 {
                        let _e693 = ((_e244 * _e107) + select(type_9().member_1, _e675.member, _e678));
                        let _e694 = (_e101 + _e693);
                        let _e697 = params.member.member_2.member;
                        let _e700 = params.member.member_2.member_1;
                        let _e701 = (_e700 == 0u);
                        let _e712 = keys.member[_e205];
                        let _e714 = sorted.member[_e205];
                        let _e716 = (select(select(1u, 2u, _e701), select(1u, 0u, _e701), (_e694 >= (select(1u, 8u, (_e697 == 2u)) * select(1u, 10u, (_e697 == 2u))))) << bitcast<u32>(30u));
                        if (_e697 == 1u) {
                            let _e829 = survey.member[6u];
                            let _e840 = bitcast<u32>(select(select(_e714.member_1[2], _e714.member_1[1], (_e829 == 1u)), _e714.member_1[0], (_e829 == 0u)));
                            let _e844 = bitcast<u32>(bitcast<f32>(select(_e840, 0u, (_e840 == 2147483648u))));
                            phi_1479_ = array<u32, 2>(((_e716 | (_e712 & 1073741823u)) + _e694), (_e716 | (select((_e844 | 2147483648u), ~(_e844), ((_e844 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i))));
                        } else {
                            if (_e697 == 2u) {
                                let _e720 = (_e694 % 80u);
                                let _e722 = (_e720 % 10u);
                                let _e725 = select(false, ((_e720 / 10u) == 0u), (_e700 == 1u));
                                if (_e268 >= 8u) {
                                    phi_1465_ = array<u32, 2>();
                                    phi_1466_ = true;
                                } else {
                                    if select(true, select(true, false, (_e722 < 4u)), _e725) {
                                        if (_e722 == 9u) {
                                            phi_1455_ = array<u32, 2>(0u, 134217727u);
                                        } else {
                                            let _e733 = (_e672[1] + (_e722 % 3u));
                                            let _e736 = (_e672[2] + (_e722 / 3u));
                                            if (_e733 < 1u) {
                                                phi_1448_ = array<u32, 2>();
                                                phi_1449_ = true;
                                            } else {
                                                if (_e736 < 1u) {
                                                    phi_1446_ = array<u32, 2>();
                                                    phi_1447_ = true;
                                                } else {
                                                    if (_e733 > 512u) {
                                                        phi_1444_ = array<u32, 2>();
                                                        phi_1445_ = true;
                                                    } else {
                                                        let _e740 = (_e736 > 512u);
                                                        if _e740 {
                                                            phi_1443_ = array<u32, 2>();
                                                        } else {
                                                            let _e742 = (_e672[0] > 0u);
                                                            let _e745 = select(true, select(true, false, (_e722 == 4u)), _e725);
                                                            phi_1443_ = array<u32, 2>(((((_e736 - 1u) << bitcast<u32>(18u)) | ((_e733 - 1u) << bitcast<u32>(9u))) | select(select(u32(), select(u32(), (_e672[0] - 1u), _e745), _e742), _e672[0], select(true, select(true, false, _e745), _e742))), ((((_e736 - 1u) << bitcast<u32>(18u)) | ((_e733 - 1u) << bitcast<u32>(9u))) | select(_e672[0], (_e672[0] + 1u), ((_e672[0] + 1u) < 512u))));
                                                        }
                                                        let _e779 = phi_1443_;
                                                        phi_1444_ = _e779;
                                                        phi_1445_ = _e740;
                                                    }
                                                    let _e781 = phi_1444_;
                                                    let _e783 = phi_1445_;
                                                    phi_1446_ = _e781;
                                                    phi_1447_ = _e783;
                                                }
                                                let _e785 = phi_1446_;
                                                let _e787 = phi_1447_;
                                                phi_1448_ = _e785;
                                                phi_1449_ = _e787;
                                            }
                                            let _e789 = phi_1448_;
                                            let _e791 = phi_1449_;
                                            phi_1455_ = array<u32, 2>(select(_e789[0], 1u, _e791), select(_e789[1], 0u, _e791));
                                        }
                                        let _e798 = phi_1455_;
                                        phi_1463_ = array<u32, 2>(((_e268 << bitcast<u32>(27u)) | _e798[0]), ((_e268 << bitcast<u32>(27u)) | _e798[1]));
                                        phi_1464_ = false;
                                    } else {
                                        phi_1463_ = array<u32, 2>();
                                        phi_1464_ = true;
                                    }
                                    let _e809 = phi_1463_;
                                    let _e811 = phi_1464_;
                                    phi_1465_ = _e809;
                                    phi_1466_ = _e811;
                                }
                                let _e813 = phi_1465_;
                                let _e815 = phi_1466_;
                                phi_1478_ = array<u32, 2>((_e716 | select(_e813[0], 1u, _e815)), (_e716 | select(_e813[1], 0u, _e815)));
                            } else {
                                phi_1478_ = array<u32, 2>(_e716, _e716);
                            }
                            let _e824 = phi_1478_;
                            phi_1479_ = _e824;
                        }
                        let _e856 = phi_1479_;
                        if (_e856[0] <= _e856[1]) {
                            let _e861 = atomicMin((&ranges[_e693]), _e856[0]);
                            let _e864 = atomicMax((&ranges[(128u + _e693)]), _e856[1]);
                        }
                    }
                    continue;
                    continuing {
                        phi_1189_ = type_9(select(_e675.member, (_e675.member + 1u), _e678), select(_e675.member_1, _e675.member_1, _e678));
                        break if !(_e691);
                    }
                }
            }
            continue;
            continuing {
                phi_399_ = type_9(select(_e230.member, (_e230.member + 1u), _e233), select(_e230.member_1, _e230.member_1, _e233));
                break if !(_e246);
            }
        }
    }
    workgroupBarrier();
    let _e868 = atomicLoad((&ranges[_e82]));
    let _e871 = atomicLoad((&ranges[(128u + _e82)]));
    if (_e868 <= _e871) {
        phi_1504_ = type_14(0i, 32i);
        phi_1507_ = 0u;
        phi_1509_ = _e105;
        loop {
            let _e874 = phi_1504_;
            let _e876 = phi_1507_;
            let _e878 = phi_1509_;
            local_17 = _e876;
            local_18 = _e876;
            local_21 = _e876;
            if (_e874.member < _e874.member_1) {
                let _e885 = (_e874.member + 1i);
                phi_1505_ = type_14(select(_e885, type_15().member_1, select(false, true, ((false == (_e885 > _e874.member)) != false))), _e874.member_1);
                phi_1550_ = type_15(1u, _e874.member);
            } else {
                phi_1505_ = _e874;
                phi_1550_ = type_15(0u, type_15().member_1);
            }
            let _e896 = phi_1505_;
            let _e898 = phi_1550_;
            if (bitcast<i32>(_e898.member) != 0i) {
                if (_e876 >= _e878) {
                    phi_1581_ = u32();
                    phi_1582_ = u32();
                    phi_1583_ = false;
                } else {
                    let _e905 = (_e876 + ((_e878 - _e876) / 2u));
                    let _e907 = keys.member[_e905];
                    let _e908 = (_e907 < _e868);
                    phi_1581_ = select(_e876, (_e905 + 1u), _e908);
                    phi_1582_ = select(_e905, _e878, _e908);
                    phi_1583_ = true;
                }
                let _e913 = phi_1581_;
                let _e915 = phi_1582_;
                let _e917 = phi_1583_;
                phi_1508_ = _e913;
                phi_1510_ = _e915;
                phi_1584_ = _e917;
            } else {
                phi_1508_ = u32();
                phi_1510_ = u32();
                phi_1584_ = false;
            }
            let _e919 = phi_1508_;
            let _e921 = phi_1510_;
            let _e923 = phi_1584_;
            continue;
            continuing {
                phi_1504_ = _e896;
                phi_1507_ = _e919;
                phi_1509_ = _e921;
                break if !(_e923);
            }
        }
        if (_e98 == 1u) {
            let _e929 = params.member.member.member_2[1u];
            let _e932 = ((_e929 + (_e92 * 128u)) + 1u);
            let _e934 = local_17;
            let _e937 = local_18;
            phi_1600_ = select(_e932, _e937, (_e932 < _e934));
        } else {
            let _e1194 = local_21;
            phi_1600_ = _e1194;
        }
        let _e940 = phi_1600_;
        phi_1604_ = type_14(0i, 32i);
        phi_1607_ = 0u;
        phi_1609_ = _e105;
        loop {
            let _e943 = phi_1604_;
            let _e945 = phi_1607_;
            let _e947 = phi_1609_;
            local_19 = _e945;
            local_20 = _e945;
            local_22 = _e945;
            if (_e943.member < _e943.member_1) {
                let _e954 = (_e943.member + 1i);
                phi_1605_ = type_14(select(_e954, type_15().member_1, select(false, true, ((false == (_e954 > _e943.member)) != false))), _e943.member_1);
                phi_1650_ = type_15(1u, _e943.member);
            } else {
                phi_1605_ = _e943;
                phi_1650_ = type_15(0u, type_15().member_1);
            }
            let _e965 = phi_1605_;
            let _e967 = phi_1650_;
            if (bitcast<i32>(_e967.member) != 0i) {
                if (_e945 >= _e947) {
                    phi_1681_ = u32();
                    phi_1682_ = u32();
                    phi_1683_ = false;
                } else {
                    let _e974 = (_e945 + ((_e947 - _e945) / 2u));
                    let _e976 = keys.member[_e974];
                    let _e977 = (_e976 < (_e871 + 1u));
                    phi_1681_ = select(_e945, (_e974 + 1u), _e977);
                    phi_1682_ = select(_e974, _e947, _e977);
                    phi_1683_ = true;
                }
                let _e982 = phi_1681_;
                let _e984 = phi_1682_;
                let _e986 = phi_1683_;
                phi_1608_ = _e982;
                phi_1610_ = _e984;
                phi_1684_ = _e986;
            } else {
                phi_1608_ = u32();
                phi_1610_ = u32();
                phi_1684_ = false;
            }
            let _e988 = phi_1608_;
            let _e990 = phi_1610_;
            let _e992 = phi_1684_;
            continue;
            continuing {
                phi_1604_ = _e965;
                phi_1607_ = _e988;
                phi_1609_ = _e990;
                break if !(_e992);
            }
        }
        let _e995 = local_19;
        if (_e940 < _e995) {
            let _e998 = local_20;
            let _e999 = (_e998 - _e940);
            let _e1000 = (_e999 / 1024u);
            let _e1004 = select(_e1000, (_e1000 + 1u), ((_e999 % 1024u) > 0u));
            let _e1006 = atomicAdd((&work.member[0u]), _e1004);
            if ((_e1006 + _e1004) < _e1006) {
                let _e1010 = atomicAdd((&work.member[2u]), 1u);
            }
            phi_1718_ = _e1006;
        } else {
            phi_1718_ = 0u;
        }
        let _e1012 = phi_1718_;
        phi_1719_ = _e1012;
        let _e1212 = local_22;
        phi_1720_ = _e1212;
        phi_1721_ = _e940;
    } else {
        phi_1719_ = 0u;
        phi_1720_ = 0u;
        phi_1721_ = 0u;
    }
    let _e1014 = phi_1719_;
    let _e1016 = phi_1720_;
    let _e1018 = phi_1721_;
    atomicStore((&ranges[(256u + _e82)]), _e1018);
    atomicStore((&ranges[(384u + _e82)]), _e1016);
    atomicStore((&ranges[(512u + _e82)]), _e1014);
    workgroupBarrier();
    phi_1736_ = type_9(0u, (select(1u, 8u, (_e95 == 2u)) * _e107));
    loop {
        let _e1030 = phi_1736_;
        let _e1033 = (_e1030.member < _e1030.member_1);
        let _e1044 = select(type_9().member_1, _e1030.member, _e1033);
        let _e1046 = (bitcast<i32>(select(0u, 1u, _e1033)) != 0i);
        if _e1046 {
            let _e1049 = atomicLoad((&ranges[(256u + _e1044)]));
            let _e1052 = atomicLoad((&ranges[(384u + _e1044)]));
            if (_e1049 < _e1052) {
                let _e1054 = (_e1052 - _e1049);
                let _e1055 = (_e1054 / 1024u);
                phi_1795_ = select(_e1055, (_e1055 + 1u), ((_e1054 % 1024u) > 0u));
            } else {
                phi_1795_ = 0u;
            }
            let _e1061 = phi_1795_;
            let _e1062 = (_e1061 / 128u);
            phi_1814_ = type_9(0u, select(_e1062, (_e1062 + 1u), ((_e1061 % 128u) > 0u)));
            loop {
                let _e1069 = phi_1814_;
                let _e1072 = (_e1069.member < _e1069.member_1);
                let _e1085 = (bitcast<i32>(select(0u, 1u, _e1072)) != 0i);
                if _e1085 {
                    let _e1087 = ((select(type_9().member_1, _e1069.member, _e1072) * 128u) + _e82);
                    if (_e1087 < _e1061) {
                        let _e1090 = (_e1049 + (_e1087 * 1024u));
                        let _e1091 = (_e1052 - _e1090);
                        let _e1093 = select(_e1091, 1024u, (1024u < _e1091));
                        let _e1094 = (_e1093 / 128u);
                        let _e1109 = atomicLoad((&ranges[(512u + _e1044)]));
                        let _e1110 = (_e1109 + _e1087);
                        let _e1113 = params.member.member_1.member_3;
                        if (_e1110 < _e1113) {
                            let _e1115 = (2u * _e1110);
                            atomicStore((&work.member[(4u + _e1115)]), (((_e101 + _e1044) << bitcast<u32>(24i)) | _e92));
                            atomicStore((&work.member[(_e1115 + 5u)]), (((select(_e1094, (_e1094 + 1u), ((_e1093 % 128u) > 0u)) - 1u) << bitcast<u32>(29i)) | _e1090));
                        }
                    }
                }
                continue;
                continuing {
                    phi_1814_ = type_9(select(_e1069.member, (_e1069.member + 1u), _e1072), select(_e1069.member_1, _e1069.member_1, _e1072));
                    break if !(_e1085);
                }
            }
        }
        continue;
        continuing {
            phi_1736_ = type_9(select(_e1030.member, (_e1030.member + 1u), _e1033), select(_e1030.member_1, _e1030.member_1, _e1033));
            break if !(_e1046);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
