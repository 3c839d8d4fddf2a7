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
    var phi_213_: type_14;
    var phi_216_: u32;
    var phi_218_: u32;
    var phi_214_: type_14;
    var phi_259_: type_15;
    var phi_290_: u32;
    var phi_291_: u32;
    var phi_292_: bool;
    var phi_217_: u32;
    var phi_219_: u32;
    var phi_293_: bool;
    var local_8: u32;
    var phi_398_: type_9;
    var phi_462_: u32;
    var phi_463_: u32;
    var phi_464_: bool;
    var phi_485_: u32;
    var phi_504_: array<u32, 2>;
    var phi_575_: type_9;
    var phi_784_: type_9;
    var phi_787_: type_24;
    var phi_820_: type_9;
    var phi_823_: bool;
    var phi_824_: bool;
    var local_9: bool;
    var phi_891_: type_24;
    var phi_892_: bool;
    var phi_788_: type_24;
    var phi_893_: bool;
    var local_10: type_24;
    var local_11: type_24;
    var local_12: type_24;
    var local_13: type_24;
    var local_14: type_24;
    var local_15: type_24;
    var local_16: type_24;
    var phi_950_: type_9;
    var phi_1071_: type_9;
    var phi_1178_: array<u32, 3>;
    var phi_1179_: array<u32, 3>;
    var phi_1180_: array<u32, 3>;
    var phi_1183_: type_9;
    var phi_1437_: array<u32, 2>;
    var phi_1438_: array<u32, 2>;
    var phi_1439_: bool;
    var phi_1440_: array<u32, 2>;
    var phi_1441_: bool;
    var phi_1442_: array<u32, 2>;
    var phi_1443_: bool;
    var phi_1449_: array<u32, 2>;
    var phi_1457_: array<u32, 2>;
    var phi_1458_: bool;
    var phi_1459_: array<u32, 2>;
    var phi_1460_: bool;
    var phi_1472_: array<u32, 2>;
    var phi_1473_: array<u32, 2>;
    var phi_1498_: type_14;
    var phi_1501_: u32;
    var phi_1503_: u32;
    var phi_1499_: type_14;
    var phi_1544_: type_15;
    var phi_1575_: u32;
    var phi_1576_: u32;
    var phi_1577_: bool;
    var phi_1502_: u32;
    var phi_1504_: u32;
    var phi_1578_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_1594_: u32;
    var phi_1598_: type_14;
    var phi_1601_: u32;
    var phi_1603_: u32;
    var phi_1599_: type_14;
    var phi_1644_: type_15;
    var phi_1675_: u32;
    var phi_1676_: u32;
    var phi_1677_: bool;
    var phi_1602_: u32;
    var phi_1604_: u32;
    var phi_1678_: bool;
    var local_19: u32;
    var local_20: u32;
    var phi_1712_: u32;
    var phi_1713_: u32;
    var phi_1714_: u32;
    var phi_1715_: u32;
    var phi_1730_: type_9;
    var phi_1789_: u32;
    var phi_1808_: type_9;
    var local_21: u32;
    var local_22: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e79 = id_2;
    let _e80 = n_2;
    let _e81 = lane_2;
    let _e91 = ((_e79.y * _e80.x) + _e79.x);
    let _e94 = params.member.member_2.member;
    let _e97 = params.member.member_2.member_1;
    let _e100 = params.member.member_2.member_2;
    let _e104 = params.member.member.member_2[3u];
    let _e106 = select(1u, 10u, (_e94 == 2u));
    let _e107 = (_e97 == 0u);
    atomicStore((&ranges[_e81]), 4294967295u);
    atomicStore((&ranges[(128u + _e81)]), 0u);
    if (_e81 <= 8u) {
        phi_213_ = type_14(0i, 32i);
        phi_216_ = 0u;
        phi_218_ = _e104;
        loop {
            let _e128 = phi_213_;
            let _e130 = phi_216_;
            let _e132 = phi_218_;
            local_8 = _e130;
            if (_e128.member < _e128.member_1) {
                let _e139 = (_e128.member + 1i);
                phi_214_ = type_14(select(_e139, type_15().member_1, select(false, true, ((false == (_e139 > _e128.member)) != false))), _e128.member_1);
                phi_259_ = type_15(1u, _e128.member);
            } else {
                phi_214_ = _e128;
                phi_259_ = type_15(0u, type_15().member_1);
            }
            let _e150 = phi_214_;
            let _e152 = phi_259_;
            if (bitcast<i32>(_e152.member) != 0i) {
                if (_e130 >= _e132) {
                    phi_290_ = u32();
                    phi_291_ = u32();
                    phi_292_ = false;
                } else {
                    let _e159 = (_e130 + ((_e132 - _e130) / 2u));
                    let _e161 = keys.member[_e159];
                    let _e162 = (_e161 < ((select(select(1u, 2u, _e107), select(1u, 0u, _e107), (_e100 >= (select(1u, 8u, (_e94 == 2u)) * select(1u, 10u, (_e94 == 2u))))) << bitcast<u32>(30u)) + (_e81 << bitcast<u32>(27u))));
                    phi_290_ = select(_e130, (_e159 + 1u), _e162);
                    phi_291_ = select(_e159, _e132, _e162);
                    phi_292_ = true;
                }
                let _e167 = phi_290_;
                let _e169 = phi_291_;
                let _e171 = phi_292_;
                phi_217_ = _e167;
                phi_219_ = _e169;
                phi_293_ = _e171;
            } else {
                phi_217_ = u32();
                phi_219_ = u32();
                phi_293_ = false;
            }
            let _e173 = phi_217_;
            let _e175 = phi_219_;
            let _e177 = phi_293_;
            continue;
            continuing {
                phi_213_ = _e150;
                phi_216_ = _e173;
                phi_218_ = _e175;
                break if !(_e177);
            }
        }
        let _e181 = local_8;
        atomicStore((&ranges[(640u + _e81)]), _e181);
    }
    workgroupBarrier();
    let _e184 = params.member.member_2.member;
    let _e187 = params.member.member_2.member_1;
    let _e188 = (_e187 == 0u);
    let _e197 = select(select(1u, 0u, _e188), select(1u, 2u, _e188), (_e100 >= (select(1u, 8u, (_e184 == 2u)) * select(1u, 10u, (_e184 == 2u)))));
    let _e199 = ((_e91 * 128u) + _e81);
    let _e203 = params.member.member.member_2[_e197];
    let _e204 = (_e203 + _e199);
    let _e208 = params.member.member.member[_e197];
    if (_e199 < _e208) {
        let _e211 = keys.member[_e204];
        let _e213 = sorted.member[_e204];
        local_7 = type_17(array<f32, 3>(_e213.member[0], _e213.member[1], _e213.member[2]), array<f32, 3>(_e213.member_1[0], _e213.member_1[1], _e213.member_1[2]));
        phi_398_ = type_9(0u, select(1u, 8u, (_e94 == 2u)));
        loop {
            let _e229 = phi_398_;
            let _e232 = (_e229.member < _e229.member_1);
            let _e243 = select(type_9().member_1, _e229.member, _e232);
            let _e245 = (bitcast<i32>(select(0u, 1u, _e232)) != 0i);
            if _e245 {
                let _e253 = select(false, (_e100 >= (select(1u, 8u, (_e94 == 2u)) * select(1u, 10u, (_e94 == 2u)))), (_e243 == 0u));
                if (_e94 != 2u) {
                    phi_463_ = u32();
                    phi_464_ = true;
                } else {
                    if _e253 {
                        phi_462_ = u32();
                    } else {
                        let _e258 = (((_e211 >> bitcast<u32>(27u)) % 8u) + _e243);
                        phi_462_ = select(8u, _e258, (_e258 < 8u));
                    }
                    let _e262 = phi_462_;
                    phi_463_ = _e262;
                    phi_464_ = _e253;
                }
                let _e264 = phi_463_;
                let _e266 = phi_464_;
                let _e267 = select(_e264, 8u, _e266);
                let _e269 = select(_e267, 7u, (7u < _e267));
                if (_e267 < 8u) {
                    let _e274 = atomicLoad((&ranges[(_e269 + 641u)]));
                    let _e276 = atomicLoad((&ranges[(640u + _e269)]));
                    phi_485_ = (_e274 - _e276);
                } else {
                    phi_485_ = 0u;
                }
                let _e279 = phi_485_;
                if (_e94 == 2u) {
                    let _e281 = (_e279 == 0u);
                    let _e282 = (_e279 <= 256u);
                    phi_504_ = array<u32, 2>(select(select(0u, 9u, _e282), 0u, _e281), select(select(9u, 10u, _e282), 0u, _e281));
                } else {
                    phi_504_ = array<u32, 2>(0u, 1u);
                }
                let _e289 = phi_504_;
                if (_e289[0] < _e289[1]) {
                    if (_e94 == 2u) {
                        let _e295 = survey.member[6u];
                        let _e302 = bitcast<f32>(select(~(_e295), (_e295 & 2147483647u), ((_e295 >> bitcast<u32>(31i)) == 1u)));
                        let _e304 = survey.member[7u];
                        let _e311 = bitcast<f32>(select(~(_e304), (_e304 & 2147483647u), ((_e304 >> bitcast<u32>(31i)) == 1u)));
                        let _e313 = survey.member[8u];
                        let _e320 = bitcast<f32>(select(~(_e313), (_e313 & 2147483647u), ((_e313 >> bitcast<u32>(31i)) == 1u)));
                        local_5 = type_17(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_575_ = type_9(0u, 3u);
                        loop {
                            let _e322 = phi_575_;
                            let _e325 = (_e322.member < _e322.member_1);
                            let _e336 = select(type_9().member_1, _e322.member, _e325);
                            let _e338 = (bitcast<i32>(select(0u, 1u, _e325)) != 0i);
                            if _e338 {
                                let _e340 = survey.member[_e336];
                                let _e341 = ~(_e340);
                                local_5.member[_e336] = bitcast<f32>(select(~(_e341), (_e341 & 2147483647u), ((_e341 >> bitcast<u32>(31i)) == 1u)));
                                let _e353 = survey.member[(3u + _e336)];
                                local_5.member_1[_e336] = bitcast<f32>(select(~(_e353), (_e353 & 2147483647u), ((_e353 >> bitcast<u32>(31i)) == 1u)));
                            }
                            continue;
                            continuing {
                                phi_575_ = type_9(select(_e322.member, (_e322.member + 1u), _e325), select(_e322.member_1, _e322.member_1, _e325));
                                break if !(_e338);
                            }
                        }
                        let _e364 = local_5;
                        local_6 = type_21(_e364, array<f32, 3>(_e302, _e311, _e320));
                        if (_e243 == 0u) {
                            let _e655 = (_e211 & 134217727u);
                            phi_1178_ = array<u32, 3>((_e655 & 511u), ((_e655 >> bitcast<u32>(9u)) & 511u), (_e655 >> bitcast<u32>(18u)));
                        } else {
                            let _e385 = local_6.member.member_1[0u];
                            let _e389 = local_6.member.member[0u];
                            let _e394 = local_6.member.member_1[1u];
                            let _e398 = local_6.member.member[1u];
                            let _e403 = local_6.member.member_1[2u];
                            let _e407 = local_6.member.member[2u];
                            local_3 = array<f32, 3>(((_e385 * 0.5f) - (_e389 * 0.5f)), ((_e394 * 0.5f) - (_e398 * 0.5f)), ((_e403 * 0.5f) - (_e407 * 0.5f)));
                            phi_784_ = type_9(0u, 9u);
                            phi_787_ = type_24(type_21(type_17(array<f32, 3>(_e364.member[0], _e364.member[1], _e364.member[2]), array<f32, 3>(_e364.member_1[0], _e364.member_1[1], _e364.member_1[2])), array<f32, 3>(_e302, _e311, _e320)), 0u);
                            loop {
                                let _e412 = phi_784_;
                                let _e414 = phi_787_;
                                local_10 = _e414;
                                local_11 = _e414;
                                local_12 = _e414;
                                local_13 = _e414;
                                local_14 = _e414;
                                local_15 = _e414;
                                local_16 = _e414;
                                let _e417 = (_e412.member < _e412.member_1);
                                let _e428 = select(type_9().member_1, _e412.member, _e417);
                                if (bitcast<i32>(select(0u, 1u, _e417)) != 0i) {
                                    phi_820_ = type_9(0u, 3u);
                                    phi_823_ = true;
                                    loop {
                                        let _e432 = phi_820_;
                                        let _e434 = phi_823_;
                                        local_9 = _e434;
                                        let _e437 = (_e432.member < _e432.member_1);
                                        let _e448 = select(type_9().member_1, _e432.member, _e437);
                                        let _e450 = (bitcast<i32>(select(0u, 1u, _e437)) != 0i);
                                        if _e450 {
                                            let _e452 = local_3[_e448];
                                            let _e454 = (_e452 * (1f / 512f));
                                            let _e459 = local_6.member_1[_e448];
                                            phi_824_ = select(_e434, false, ((_e459 * bitcast<f32>(((127u - _e428) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e454, (_e454 > 0.000000000000000000000000000006310887f))));
                                        } else {
                                            phi_824_ = bool();
                                        }
                                        let _e468 = phi_824_;
                                        continue;
                                        continuing {
                                            phi_820_ = type_9(select(_e432.member, (_e432.member + 1u), _e437), select(_e432.member_1, _e432.member_1, _e437));
                                            phi_823_ = _e468;
                                            break if !(_e450);
                                        }
                                    }
                                    let _e471 = local_9;
                                    if _e471 {
                                        phi_891_ = type_24();
                                        phi_892_ = false;
                                    } else {
                                        phi_891_ = type_24(_e414.member, (_e428 + 1u));
                                        phi_892_ = true;
                                    }
                                    let _e476 = phi_891_;
                                    let _e478 = phi_892_;
                                    phi_788_ = _e476;
                                    phi_893_ = _e478;
                                } else {
                                    phi_788_ = type_24();
                                    phi_893_ = false;
                                }
                                let _e480 = phi_788_;
                                let _e482 = phi_893_;
                                continue;
                                continuing {
                                    phi_784_ = type_9(select(_e412.member, (_e412.member + 1u), _e417), select(_e412.member_1, _e412.member_1, _e417));
                                    phi_787_ = _e480;
                                    break if !(_e482);
                                }
                            }
                            let _e487 = (((_e211 >> bitcast<u32>(27u)) % 8u) + _e243);
                            let _e489 = select(8u, _e487, (_e487 < 8u));
                            let _e491 = local_10;
                            let _e496 = local_11;
                            let _e500 = local_12;
                            let _e506 = local_13;
                            let _e513 = bitcast<f32>(((127u - select((_e506.member_1 - _e489), 0u, ((_e489 + 1u) >= select(8u, (_e500.member_1 + 1u), (_e496.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e515 = local_14;
                            let _e521 = local_15;
                            let _e527 = local_16;
                            local_2.member = type_17(array<f32, 3>(_e491.member.member.member[0], _e491.member.member.member[1], _e491.member.member.member[2]), array<f32, 3>(_e491.member.member.member_1[0], _e491.member.member.member_1[1], _e491.member.member.member_1[2]));
                            local_2.member_1 = array<f32, 3>((_e515.member.member_1[0] * _e513), (_e521.member.member_1[1] * _e513), (_e527.member.member_1[2] * _e513));
                            local_1.member = array<f32, 3>(0f, 0f, 0f);
                            local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                            phi_950_ = type_9(0u, 3u);
                            loop {
                                let _e549 = phi_950_;
                                let _e552 = (_e549.member < _e549.member_1);
                                let _e563 = select(type_9().member_1, _e549.member, _e552);
                                let _e565 = (bitcast<i32>(select(0u, 1u, _e552)) != 0i);
                                if _e565 {
                                    let _e569 = local_2.member.member[_e563];
                                    let _e573 = local_2.member.member_1[_e563];
                                    let _e578 = (((_e573 * 0.5f) - (_e569 * 0.5f)) * (1f / 512f));
                                    let _e581 = local_2.member_1[_e563];
                                    let _e584 = local_2.member_1[_e563];
                                    let _e586 = (_e581 + (_e584 * 0.00390625f));
                                    let _e588 = select(_e586, _e578, (_e578 > _e586));
                                    local_1.member[_e563] = (_e569 * 0.25f);
                                    local_1.member_1[_e563] = (1f / select(_e588, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e588)));
                                }
                                continue;
                                continuing {
                                    phi_950_ = type_9(select(_e549.member, (_e549.member + 1u), _e552), select(_e549.member_1, _e549.member_1, _e552));
                                    break if !(_e565);
                                }
                            }
                            let _e598 = local_1;
                            local_4 = _e598;
                            local = array<u32, 3>(0u, 0u, 0u);
                            phi_1071_ = type_9(0u, 3u);
                            loop {
                                let _e600 = phi_1071_;
                                let _e603 = (_e600.member < _e600.member_1);
                                let _e614 = select(type_9().member_1, _e600.member, _e603);
                                let _e616 = (bitcast<i32>(select(0u, 1u, _e603)) != 0i);
                                if _e616 {
                                    let _e619 = local_4.member[_e614];
                                    let _e622 = local_7.member[_e614];
                                    let _e624 = ((_e622 * 0.25f) - _e619);
                                    let _e629 = local_7.member_1[_e614];
                                    let _e631 = ((_e629 * 0.25f) - _e619);
                                    let _e637 = local_4.member_1[_e614];
                                    let _e638 = ((select(0f, _e624, (_e624 > 0f)) + select(0f, _e631, (_e631 > 0f))) * _e637);
                                    local[_e614] = select(select(0u, select(select(u32(_e638), 0u, (_e638 < 0f)), 4294967295u, (_e638 > 4294967000f)), (_e638 > 0f)), 511u, (_e638 >= 511f));
                                }
                                continue;
                                continuing {
                                    phi_1071_ = type_9(select(_e600.member, (_e600.member + 1u), _e603), select(_e600.member_1, _e600.member_1, _e603));
                                    break if !(_e616);
                                }
                            }
                            let _e650 = local;
                            phi_1178_ = array<u32, 3>(_e650[0], _e650[1], _e650[2]);
                        }
                        let _e664 = phi_1178_;
                        phi_1179_ = _e664;
                    } else {
                        phi_1179_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e666 = phi_1179_;
                    phi_1180_ = _e666;
                } else {
                    phi_1180_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e668 = phi_1180_;
                phi_1183_ = type_9(_e289[0], _e289[1]);
                loop {
                    let _e671 = phi_1183_;
                    let _e674 = (_e671.member < _e671.member_1);
                    let _e687 = (bitcast<i32>(select(0u, 1u, _e674)) != 0i);
                    if _e687 {
                        let _e689 = ((_e243 * _e106) + select(type_9().member_1, _e671.member, _e674));
                        let _e690 = (_e100 + _e689);
                        let _e693 = params.member.member_2.member;
                        let _e696 = params.member.member_2.member_1;
                        let _e697 = (_e696 == 0u);
                        let _e708 = keys.member[_e204];
                        let _e710 = sorted.member[_e204];
                        let _e712 = (select(select(1u, 2u, _e697), select(1u, 0u, _e697), (_e690 >= (select(1u, 8u, (_e693 == 2u)) * select(1u, 10u, (_e693 == 2u))))) << bitcast<u32>(30u));
                        if (_e693 == 1u) {
                            let _e825 = survey.member[6u];
                            let _e836 = bitcast<u32>(select(select(_e710.member_1[2], _e710.member_1[1], (_e825 == 1u)), _e710.member_1[0], (_e825 == 0u)));
                            let _e840 = bitcast<u32>(bitcast<f32>(select(_e836, 0u, (_e836 == 2147483648u))));
                            phi_1473_ = array<u32, 2>(((_e712 | (_e708 & 1073741823u)) + _e690), (_e712 | (select((_e840 | 2147483648u), ~(_e840), ((_e840 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i))));
                        } else {
                            if (_e693 == 2u) {
                                let _e716 = (_e690 % 80u);
                                let _e718 = (_e716 % 10u);
                                let _e721 = select(false, ((_e716 / 10u) == 0u), (_e696 == 1u));
                                if (_e267 >= 8u) {
                                    phi_1459_ = array<u32, 2>();
                                    phi_1460_ = true;
                                } else {
                                    if select(true, select(true, false, (_e718 < 4u)), _e721) {
                                        if (_e718 == 9u) {
                                            phi_1449_ = array<u32, 2>(0u, 134217727u);
                                        } else {
                                            let _e729 = (_e668[1] + (_e718 % 3u));
                                            let _e732 = (_e668[2] + (_e718 / 3u));
                                            if (_e729 < 1u) {
                                                phi_1442_ = array<u32, 2>();
                                                phi_1443_ = true;
                                            } else {
                                                if (_e732 < 1u) {
                                                    phi_1440_ = array<u32, 2>();
                                                    phi_1441_ = true;
                                                } else {
                                                    if (_e729 > 512u) {
                                                        phi_1438_ = array<u32, 2>();
                                                        phi_1439_ = true;
                                                    } else {
                                                        let _e736 = (_e732 > 512u);
                                                        if _e736 {
                                                            phi_1437_ = array<u32, 2>();
                                                        } else {
                                                            let _e738 = (_e668[0] > 0u);
                                                            let _e741 = select(true, select(true, false, (_e718 == 4u)), _e721);
                                                            phi_1437_ = array<u32, 2>(((((_e732 - 1u) << bitcast<u32>(18u)) | ((_e729 - 1u) << bitcast<u32>(9u))) | select(select(u32(), select(u32(), (_e668[0] - 1u), _e741), _e738), _e668[0], select(true, select(true, false, _e741), _e738))), ((((_e732 - 1u) << bitcast<u32>(18u)) | ((_e729 - 1u) << bitcast<u32>(9u))) | select(_e668[0], (_e668[0] + 1u), ((_e668[0] + 1u) < 512u))));
                                                        }
                                                        let _e775 = phi_1437_;
                                                        phi_1438_ = _e775;
                                                        phi_1439_ = _e736;
                                                    }
                                                    let _e777 = phi_1438_;
                                                    let _e779 = phi_1439_;
                                                    phi_1440_ = _e777;
                                                    phi_1441_ = _e779;
                                                }
                                                let _e781 = phi_1440_;
                                                let _e783 = phi_1441_;
                                                phi_1442_ = _e781;
                                                phi_1443_ = _e783;
                                            }
                                            let _e785 = phi_1442_;
                                            let _e787 = phi_1443_;
                                            phi_1449_ = array<u32, 2>(select(_e785[0], 1u, _e787), select(_e785[1], 0u, _e787));
                                        }
                                        let _e794 = phi_1449_;
                                        phi_1457_ = array<u32, 2>(((_e267 << bitcast<u32>(27u)) | _e794[0]), ((_e267 << bitcast<u32>(27u)) | _e794[1]));
                                        phi_1458_ = false;
                                    } else {
                                        phi_1457_ = array<u32, 2>();
                                        phi_1458_ = true;
                                    }
                                    let _e805 = phi_1457_;
                                    let _e807 = phi_1458_;
                                    phi_1459_ = _e805;
                                    phi_1460_ = _e807;
                                }
                                let _e809 = phi_1459_;
                                let _e811 = phi_1460_;
                                phi_1472_ = array<u32, 2>((_e712 | select(_e809[0], 1u, _e811)), (_e712 | select(_e809[1], 0u, _e811)));
                            } else {
                                phi_1472_ = array<u32, 2>(_e712, _e712);
                            }
                            let _e820 = phi_1472_;
                            phi_1473_ = _e820;
                        }
                        let _e852 = phi_1473_;
                        if (_e852[0] <= _e852[1]) {
                            let _e857 = atomicMin((&ranges[_e689]), _e852[0]);
                            let _e860 = atomicMax((&ranges[(128u + _e689)]), _e852[1]);
                        }
                    }
                    continue;
                    continuing {
                        phi_1183_ = type_9(select(_e671.member, (_e671.member + 1u), _e674), select(_e671.member_1, _e671.member_1, _e674));
                        break if !(_e687);
                    }
                }
            }
            continue;
            continuing {
                phi_398_ = type_9(select(_e229.member, (_e229.member + 1u), _e232), select(_e229.member_1, _e229.member_1, _e232));
                break if !(_e245);
            }
        }
    }
    workgroupBarrier();
    let _e864 = atomicLoad((&ranges[_e81]));
    let _e867 = atomicLoad((&ranges[(128u + _e81)]));
    if (_e864 <= _e867) {
        phi_1498_ = type_14(0i, 32i);
        phi_1501_ = 0u;
        phi_1503_ = _e104;
        loop {
            let _e870 = phi_1498_;
            let _e872 = phi_1501_;
            let _e874 = phi_1503_;
            local_17 = _e872;
            local_18 = _e872;
            local_21 = _e872;
            if (_e870.member < _e870.member_1) {
                let _e881 = (_e870.member + 1i);
                phi_1499_ = type_14(select(_e881, type_15().member_1, select(false, true, ((false == (_e881 > _e870.member)) != false))), _e870.member_1);
                phi_1544_ = type_15(1u, _e870.member);
            } else {
                phi_1499_ = _e870;
                phi_1544_ = type_15(0u, type_15().member_1);
            }
            let _e892 = phi_1499_;
            let _e894 = phi_1544_;
            if (bitcast<i32>(_e894.member) != 0i) {
                if (_e872 >= _e874) {
                    phi_1575_ = u32();
                    phi_1576_ = u32();
                    phi_1577_ = false;
                } else {
                    let _e901 = (_e872 + ((_e874 - _e872) / 2u));
                    let _e903 = keys.member[_e901];
                    let _e904 = (_e903 < _e864);
                    phi_1575_ = select(_e872, (_e901 + 1u), _e904);
                    phi_1576_ = select(_e901, _e874, _e904);
                    phi_1577_ = true;
                }
                let _e909 = phi_1575_;
                let _e911 = phi_1576_;
                let _e913 = phi_1577_;
                phi_1502_ = _e909;
                phi_1504_ = _e911;
                phi_1578_ = _e913;
            } else {
                phi_1502_ = u32();
                phi_1504_ = u32();
                phi_1578_ = false;
            }
            let _e915 = phi_1502_;
            let _e917 = phi_1504_;
            let _e919 = phi_1578_;
            continue;
            continuing {
                phi_1498_ = _e892;
                phi_1501_ = _e915;
                phi_1503_ = _e917;
                break if !(_e919);
            }
        }
        if (_e97 == 1u) {
            let _e925 = params.member.member.member_2[1u];
            let _e928 = ((_e925 + (_e91 * 128u)) + 1u);
            let _e930 = local_17;
            let _e933 = local_18;
            phi_1594_ = select(_e928, _e933, (_e928 < _e930));
        } else {
            let _e1189 = local_21;
            phi_1594_ = _e1189;
        }
        let _e936 = phi_1594_;
        phi_1598_ = type_14(0i, 32i);
        phi_1601_ = 0u;
        phi_1603_ = _e104;
        loop {
            let _e939 = phi_1598_;
            let _e941 = phi_1601_;
            let _e943 = phi_1603_;
            local_19 = _e941;
            local_20 = _e941;
            local_22 = _e941;
            if (_e939.member < _e939.member_1) {
                let _e950 = (_e939.member + 1i);
                phi_1599_ = type_14(select(_e950, type_15().member_1, select(false, true, ((false == (_e950 > _e939.member)) != false))), _e939.member_1);
                phi_1644_ = type_15(1u, _e939.member);
            } else {
                phi_1599_ = _e939;
                phi_1644_ = type_15(0u, type_15().member_1);
            }
            let _e961 = phi_1599_;
            let _e963 = phi_1644_;
            if (bitcast<i32>(_e963.member) != 0i) {
                if (_e941 >= _e943) {
                    phi_1675_ = u32();
                    phi_1676_ = u32();
                    phi_1677_ = false;
                } else {
                    let _e970 = (_e941 + ((_e943 - _e941) / 2u));
                    let _e972 = keys.member[_e970];
                    let _e973 = (_e972 < (_e867 + 1u));
                    phi_1675_ = select(_e941, (_e970 + 1u), _e973);
                    phi_1676_ = select(_e970, _e943, _e973);
                    phi_1677_ = true;
                }
                let _e978 = phi_1675_;
                let _e980 = phi_1676_;
                let _e982 = phi_1677_;
                phi_1602_ = _e978;
                phi_1604_ = _e980;
                phi_1678_ = _e982;
            } else {
                phi_1602_ = u32();
                phi_1604_ = u32();
                phi_1678_ = false;
            }
            let _e984 = phi_1602_;
            let _e986 = phi_1604_;
            let _e988 = phi_1678_;
            continue;
            continuing {
                phi_1598_ = _e961;
                phi_1601_ = _e984;
                phi_1603_ = _e986;
                break if !(_e988);
            }
        }
        let _e991 = local_19;
        if (_e936 < _e991) {
            let _e994 = local_20;
            let _e995 = (_e994 - _e936);
            let _e996 = (_e995 / 1024u);
            let _e1000 = select(_e996, (_e996 + 1u), ((_e995 % 1024u) > 0u));
            let _e1002 = atomicAdd((&work.member[0u]), _e1000);
            if ((_e1002 + _e1000) < _e1002) {
                let _e1006 = atomicAdd((&work.member[2u]), 1u);
            }
            phi_1712_ = _e1002;
        } else {
            phi_1712_ = 0u;
        }
        let _e1008 = phi_1712_;
        phi_1713_ = _e1008;
        let _e1207 = local_22;
        phi_1714_ = _e1207;
        phi_1715_ = _e936;
    } else {
        phi_1713_ = 0u;
        phi_1714_ = 0u;
        phi_1715_ = 0u;
    }
    let _e1010 = phi_1713_;
    let _e1012 = phi_1714_;
    let _e1014 = phi_1715_;
    atomicStore((&ranges[(256u + _e81)]), _e1014);
    atomicStore((&ranges[(384u + _e81)]), _e1012);
    atomicStore((&ranges[(512u + _e81)]), _e1010);
    workgroupBarrier();
    phi_1730_ = type_9(0u, (select(1u, 8u, (_e94 == 2u)) * _e106));
    loop {
        let _e1026 = phi_1730_;
        let _e1029 = (_e1026.member < _e1026.member_1);
        let _e1040 = select(type_9().member_1, _e1026.member, _e1029);
        let _e1042 = (bitcast<i32>(select(0u, 1u, _e1029)) != 0i);
        if _e1042 {
            let _e1045 = atomicLoad((&ranges[(256u + _e1040)]));
            let _e1048 = atomicLoad((&ranges[(384u + _e1040)]));
            if (_e1045 < _e1048) {
                let _e1050 = (_e1048 - _e1045);
                let _e1051 = (_e1050 / 1024u);
                phi_1789_ = select(_e1051, (_e1051 + 1u), ((_e1050 % 1024u) > 0u));
            } else {
                phi_1789_ = 0u;
            }
            let _e1057 = phi_1789_;
            let _e1058 = (_e1057 / 128u);
            phi_1808_ = type_9(0u, select(_e1058, (_e1058 + 1u), ((_e1057 % 128u) > 0u)));
            loop {
                let _e1065 = phi_1808_;
                let _e1068 = (_e1065.member < _e1065.member_1);
                let _e1081 = (bitcast<i32>(select(0u, 1u, _e1068)) != 0i);
                if _e1081 {
                    let _e1083 = ((select(type_9().member_1, _e1065.member, _e1068) * 128u) + _e81);
                    if (_e1083 < _e1057) {
                        let _e1086 = (_e1045 + (_e1083 * 1024u));
                        let _e1087 = (_e1048 - _e1086);
                        let _e1089 = select(_e1087, 1024u, (1024u < _e1087));
                        let _e1090 = (_e1089 / 128u);
                        let _e1105 = atomicLoad((&ranges[(512u + _e1040)]));
                        let _e1106 = (_e1105 + _e1083);
                        let _e1109 = params.member.member_1.member_3;
                        if (_e1106 < _e1109) {
                            let _e1111 = (2u * _e1106);
                            atomicStore((&work.member[(4u + _e1111)]), (((_e100 + _e1040) << bitcast<u32>(24i)) | _e91));
                            atomicStore((&work.member[(_e1111 + 5u)]), (((select(_e1090, (_e1090 + 1u), ((_e1089 % 128u) > 0u)) - 1u) << bitcast<u32>(29i)) | _e1086));
                        }
                    }
                }
                continue;
                continuing {
                    phi_1808_ = type_9(select(_e1065.member, (_e1065.member + 1u), _e1068), select(_e1065.member_1, _e1065.member_1, _e1068));
                    break if !(_e1081);
                }
            }
        }
        continue;
        continuing {
            phi_1730_ = type_9(select(_e1026.member, (_e1026.member + 1u), _e1029), select(_e1026.member_1, _e1026.member_1, _e1029));
            break if !(_e1042);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
