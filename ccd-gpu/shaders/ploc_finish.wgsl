// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_6,
    member_1: type_7,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: u32,
    member_1: f32,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> counts: type_9;
@group(0) @binding(2) 
var<storage> even_clusters: type_23;
@group(0) @binding(3) 
var<storage> even_names: type_9;
@group(0) @binding(4) 
var<storage> odd_clusters: type_23;
@group(0) @binding(5) 
var<storage> odd_names: type_9;
@group(0) @binding(6) 
var<storage, read_write> joins: type_9;
var<workgroup> boxes: array<type_16, 256>;
var<workgroup> nodes: array<u32, 256>;
var<workgroup> leaves: array<u32, 256>;
var<workgroup> names: array<u32, 256>;
var<workgroup> neighbours: array<u32, 256>;
var<workgroup> masks: array<atomic<u32>, 8>;

fn function_(lane_1: u32) {
    var phi_117_: type_11;
    var phi_120_: u32;
    var phi_118_: type_11;
    var phi_143_: type_11;
    var phi_167_: u32;
    var phi_121_: u32;
    var local: u32;
    var phi_182_: u32;
    var local_1: u32;
    var phi_250_: type_17;
    var phi_274_: u32;
    var phi_300_: type_11;
    var phi_303_: u32;
    var phi_301_: type_11;
    var phi_326_: type_11;
    var phi_344_: u32;
    var local_2: u32;
    var phi_356_: u32;
    var phi_367_: u32;
    var phi_395_: u32;
    var phi_403_: u32;
    var phi_407_: type_11;
    var phi_410_: type_25;
    var phi_408_: type_11;
    var phi_433_: type_11;
    var phi_460_: f32;
    var phi_467_: f32;
    var phi_475_: f32;
    var phi_482_: f32;
    var phi_490_: f32;
    var phi_497_: f32;
    var phi_526_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_536_: type_25;
    var phi_537_: type_25;
    var phi_411_: type_25;
    var local_3: type_25;
    var phi_539_: u32;
    var phi_541_: u32;
    var phi_564_: u32;
    var phi_565_: u32;
    var phi_566_: u32;
    var phi_567_: bool;
    var phi_571_: u32;
    var phi_643_: f32;
    var phi_650_: f32;
    var phi_657_: f32;
    var phi_665_: f32;
    var phi_672_: f32;
    var phi_679_: f32;
    var phi_683_: type_16;
    var phi_684_: u32;
    var phi_685_: u32;
    var phi_686_: type_16;
    var phi_687_: u32;
    var phi_688_: u32;
    var phi_689_: u32;
    var phi_690_: bool;
    var phi_711_: type_11;
    var phi_714_: u32;
    var phi_716_: u32;
    var phi_712_: type_11;
    var phi_739_: type_11;
    var phi_757_: u32;
    var phi_715_: u32;
    var phi_717_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_304_: u32;
    var local_8: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e35 = lane_2;
    let _e45 = params.member.member_2.member;
    let _e49 = params.member.member.member[_e45];
    let _e52 = params.member.member_2.member_2;
    phi_117_ = type_11(0u, _e52);
    phi_120_ = 0u;
    loop {
        let _e55 = phi_117_;
        let _e57 = phi_120_;
        local = _e57;
        local_1 = _e57;
        local_2 = _e57;
        if (_e55.member < _e55.member_1) {
            phi_118_ = type_11((_e55.member + 1u), _e55.member_1);
            phi_143_ = type_11(1u, _e55.member);
        } else {
            phi_118_ = _e55;
            phi_143_ = type_11(0u, type_11().member_1);
        }
        let _e69 = phi_118_;
        let _e71 = phi_143_;
        let _e75 = (bitcast<i32>(_e71.member) != 0i);
        if _e75 {
            let _e78 = counts.member[(_e71.member_1 + 1u)];
            if (_e78 > 0u) {
                phi_167_ = (_e71.member_1 + 1u);
            } else {
                phi_167_ = _e57;
            }
            let _e82 = phi_167_;
            phi_121_ = _e82;
        } else {
            phi_121_ = u32();
        }
        let _e84 = phi_121_;
        continue;
        continuing {
            phi_117_ = _e69;
            phi_120_ = _e84;
            break if !(_e75);
        }
    }
    let _e87 = local;
    let _e89 = counts.member[_e87];
    if (256u < _e89) {
        phi_182_ = 256u;
    } else {
        phi_182_ = _e89;
    }
    let _e92 = phi_182_;
    if (_e35 < _e92) {
        let _e95 = local_1;
        let _e97 = ((_e95 % 2u) == 1u);
        if _e97 {
            let _e122 = odd_clusters.member[_e35];
            phi_250_ = type_17(array<f32, 3>(bitcast<f32>(_e122.member.x), bitcast<f32>(_e122.member.y), bitcast<f32>(_e122.member.z)), _e122.member.w, array<f32, 3>(bitcast<f32>(_e122.member_1.x), bitcast<f32>(_e122.member_1.y), bitcast<f32>(_e122.member_1.z)), _e122.member_1.w);
        } else {
            let _e99 = even_clusters.member[_e35];
            phi_250_ = type_17(array<f32, 3>(bitcast<f32>(_e99.member.x), bitcast<f32>(_e99.member.y), bitcast<f32>(_e99.member.z)), _e99.member.w, array<f32, 3>(bitcast<f32>(_e99.member_1.x), bitcast<f32>(_e99.member_1.y), bitcast<f32>(_e99.member_1.z)), _e99.member_1.w);
        }
        let _e145 = phi_250_;
        if _e97 {
            let _e149 = odd_names.member[_e35];
            phi_274_ = _e149;
        } else {
            let _e147 = even_names.member[_e35];
            phi_274_ = _e147;
        }
        let _e151 = phi_274_;
        boxes[_e35] = type_16(array<f32, 3>(_e145.member[0], _e145.member[1], _e145.member[2]), array<f32, 3>(_e145.member_2[0], _e145.member_2[1], _e145.member_2[2]));
        nodes[_e35] = _e145.member_1;
        leaves[_e35] = _e145.member_3;
        names[_e35] = _e151;
    }
    workgroupBarrier();
    let _e171 = params.member.member_1.member;
    phi_300_ = type_11(0u, _e171);
    phi_303_ = _e92;
    loop {
        let _e174 = phi_300_;
        let _e176 = phi_303_;
        if (_e174.member < _e174.member_1) {
            phi_301_ = type_11((_e174.member + 1u), _e174.member_1);
            phi_326_ = type_11(1u, _e174.member);
        } else {
            phi_301_ = _e174;
            phi_326_ = type_11(0u, type_11().member_1);
        }
        let _e188 = phi_301_;
        let _e190 = phi_326_;
        let _e194 = (bitcast<i32>(_e190.member) != 0i);
        if _e194 {
            let _e195 = (_e35 < _e176);
            if _e195 {
                if ((_e35 ^ 1u) < _e176) {
                    phi_344_ = (_e35 ^ 1u);
                } else {
                    phi_344_ = _e35;
                }
                let _e200 = phi_344_;
                let _e202 = local_2;
                if (_e49 > 1u) {
                    let _e205 = (_e49 - 1u);
                    phi_356_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e205)), 32u, (_e205 == 0u)));
                } else {
                    phi_356_ = 0u;
                }
                let _e213 = phi_356_;
                if (_e176 > 1u) {
                    let _e215 = (_e176 - 1u);
                    phi_367_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u)));
                } else {
                    phi_367_ = 0u;
                }
                let _e223 = phi_367_;
                if ((_e202 + _e190.member_1) >= (6u * ((_e213 - _e223) + 1u))) {
                    phi_539_ = _e200;
                } else {
                    let _e229 = boxes[_e35];
                    let _e240 = params.member.member_2.member_1;
                    if (_e35 < _e240) {
                        phi_395_ = _e35;
                    } else {
                        phi_395_ = _e240;
                    }
                    let _e243 = phi_395_;
                    let _e246 = ((_e35 + _e240) + 1u);
                    if (_e176 < _e246) {
                        phi_403_ = _e176;
                    } else {
                        phi_403_ = _e246;
                    }
                    let _e249 = phi_403_;
                    phi_407_ = type_11((_e35 - _e243), _e249);
                    phi_410_ = type_25(_e35, 300000000000000000000000000000000000000f);
                    loop {
                        let _e253 = phi_407_;
                        let _e255 = phi_410_;
                        local_3 = _e255;
                        if (_e253.member < _e253.member_1) {
                            phi_408_ = type_11((_e253.member + 1u), _e253.member_1);
                            phi_433_ = type_11(1u, _e253.member);
                        } else {
                            phi_408_ = _e253;
                            phi_433_ = type_11(0u, type_11().member_1);
                        }
                        let _e267 = phi_408_;
                        let _e269 = phi_433_;
                        let _e273 = (bitcast<i32>(_e269.member) != 0i);
                        if _e273 {
                            let _e275 = boxes[_e269.member_1];
                            if (_e229.member_1[0] > _e275.member_1[0]) {
                                phi_460_ = _e229.member_1[0];
                            } else {
                                phi_460_ = _e275.member_1[0];
                            }
                            let _e286 = phi_460_;
                            if (_e229.member[0] < _e275.member[0]) {
                                phi_467_ = _e229.member[0];
                            } else {
                                phi_467_ = _e275.member[0];
                            }
                            let _e289 = phi_467_;
                            let _e290 = (_e286 - _e289);
                            if (_e229.member_1[1] > _e275.member_1[1]) {
                                phi_475_ = _e229.member_1[1];
                            } else {
                                phi_475_ = _e275.member_1[1];
                            }
                            let _e293 = phi_475_;
                            if (_e229.member[1] < _e275.member[1]) {
                                phi_482_ = _e229.member[1];
                            } else {
                                phi_482_ = _e275.member[1];
                            }
                            let _e296 = phi_482_;
                            let _e297 = (_e293 - _e296);
                            if (_e229.member_1[2] > _e275.member_1[2]) {
                                phi_490_ = _e229.member_1[2];
                            } else {
                                phi_490_ = _e275.member_1[2];
                            }
                            let _e300 = phi_490_;
                            if (_e229.member[2] < _e275.member[2]) {
                                phi_497_ = _e229.member[2];
                            } else {
                                phi_497_ = _e275.member[2];
                            }
                            let _e303 = phi_497_;
                            let _e304 = (_e300 - _e303);
                            let _e309 = (((_e290 * _e297) + (_e297 * _e304)) + (_e304 * _e290));
                            if (_e269.member_1 != _e35) {
                                if (_e309 < _e255.member_1) {
                                    phi_531_ = true;
                                } else {
                                    if (_e309 == _e255.member_1) {
                                        if (_e255.member == _e35) {
                                            phi_526_ = true;
                                        } else {
                                            phi_526_ = ((_e35 ^ _e269.member_1) < (_e35 ^ _e255.member));
                                        }
                                        let _e321 = phi_526_;
                                        phi_530_ = _e321;
                                    } else {
                                        phi_530_ = false;
                                    }
                                    let _e323 = phi_530_;
                                    phi_531_ = _e323;
                                }
                                let _e325 = phi_531_;
                                if _e325 {
                                    phi_536_ = type_25(_e269.member_1, _e309);
                                } else {
                                    phi_536_ = _e255;
                                }
                                let _e328 = phi_536_;
                                phi_537_ = _e328;
                            } else {
                                phi_537_ = _e255;
                            }
                            let _e330 = phi_537_;
                            phi_411_ = _e330;
                        } else {
                            phi_411_ = type_25();
                        }
                        let _e332 = phi_411_;
                        continue;
                        continuing {
                            phi_407_ = _e267;
                            phi_410_ = _e332;
                            break if !(_e273);
                        }
                    }
                    let _e335 = local_3;
                    phi_539_ = _e335.member;
                }
                let _e338 = phi_539_;
                neighbours[_e35] = _e338;
                phi_541_ = _e338;
            } else {
                phi_541_ = _e35;
            }
            let _e341 = phi_541_;
            if (_e35 < 8u) {
                atomicStore((&masks[_e35]), 0u);
            }
            workgroupBarrier();
            if _e195 {
                let _e345 = neighbours[_e341];
                if (_e35 == _e341) {
                    phi_566_ = u32();
                    phi_567_ = true;
                } else {
                    let _e347 = (_e345 != _e35);
                    if _e347 {
                        phi_565_ = u32();
                    } else {
                        if (_e35 < _e341) {
                            phi_564_ = 1u;
                        } else {
                            phi_564_ = 2u;
                        }
                        let _e350 = phi_564_;
                        phi_565_ = _e350;
                    }
                    let _e352 = phi_565_;
                    phi_566_ = _e352;
                    phi_567_ = _e347;
                }
                let _e354 = phi_566_;
                let _e356 = phi_567_;
                if _e356 {
                    phi_571_ = 0u;
                } else {
                    phi_571_ = _e354;
                }
                let _e358 = phi_571_;
                let _e362 = boxes[_e35];
                let _e375 = nodes[_e35];
                let _e377 = leaves[_e35];
                let _e379 = names[_e35];
                if (_e358 == 1u) {
                    let _e382 = names[_e341];
                    let _e383 = (_e382 - 1u);
                    let _e385 = leaves[_e341];
                    let _e387 = nodes[_e341];
                    let _e388 = (_e383 * 4u);
                    let _e389 = (_e375 * 4u);
                    let _e390 = (_e387 * 4u);
                    joins.member[_e389] = _e383;
                    joins.member[(_e389 + 1u)] = 0u;
                    joins.member[_e390] = _e383;
                    joins.member[(_e390 + 1u)] = _e377;
                    joins.member[(_e388 + 2u)] = _e377;
                    joins.member[(_e388 + 3u)] = (_e377 + _e385);
                    let _e403 = boxes[_e341];
                    if (_e362.member[0] < _e403.member[0]) {
                        phi_643_ = _e362.member[0];
                    } else {
                        phi_643_ = _e403.member[0];
                    }
                    let _e414 = phi_643_;
                    if (_e362.member[1] < _e403.member[1]) {
                        phi_650_ = _e362.member[1];
                    } else {
                        phi_650_ = _e403.member[1];
                    }
                    let _e417 = phi_650_;
                    if (_e362.member[2] < _e403.member[2]) {
                        phi_657_ = _e362.member[2];
                    } else {
                        phi_657_ = _e403.member[2];
                    }
                    let _e420 = phi_657_;
                    if (_e362.member_1[0] > _e403.member_1[0]) {
                        phi_665_ = _e362.member_1[0];
                    } else {
                        phi_665_ = _e403.member_1[0];
                    }
                    let _e424 = phi_665_;
                    if (_e362.member_1[1] > _e403.member_1[1]) {
                        phi_672_ = _e362.member_1[1];
                    } else {
                        phi_672_ = _e403.member_1[1];
                    }
                    let _e427 = phi_672_;
                    if (_e362.member_1[2] > _e403.member_1[2]) {
                        phi_679_ = _e362.member_1[2];
                    } else {
                        phi_679_ = _e403.member_1[2];
                    }
                    let _e430 = phi_679_;
                    phi_683_ = type_16(array<f32, 3>(_e414, _e417, _e420), array<f32, 3>(_e424, _e427, _e430));
                    phi_684_ = (_e377 + _e385);
                    phi_685_ = _e383;
                } else {
                    phi_683_ = type_16(array<f32, 3>(_e362.member[0], _e362.member[1], _e362.member[2]), array<f32, 3>(_e362.member_1[0], _e362.member_1[1], _e362.member_1[2]));
                    phi_684_ = _e377;
                    phi_685_ = _e375;
                }
                let _e435 = phi_683_;
                let _e437 = phi_684_;
                let _e439 = phi_685_;
                phi_686_ = _e435;
                phi_687_ = _e379;
                phi_688_ = _e437;
                phi_689_ = _e439;
                phi_690_ = !((_e358 == 2u));
            } else {
                phi_686_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_687_ = 0u;
                phi_688_ = 0u;
                phi_689_ = 0u;
                phi_690_ = false;
            }
            let _e441 = phi_686_;
            let _e443 = phi_687_;
            let _e445 = phi_688_;
            let _e447 = phi_689_;
            let _e449 = phi_690_;
            if _e449 {
                let _e456 = atomicOr((&masks[(_e35 / 32u)]), (1u << bitcast<u32>(((_e35 % 32u) & 31u))));
            }
            workgroupBarrier();
            let _e459 = atomicLoad((&masks[(_e35 / 32u)]));
            phi_711_ = type_11(0u, 8u);
            phi_714_ = countOneBits((_e459 & ((1u << bitcast<u32>(((_e35 % 32u) & 31u))) - 1u)));
            phi_716_ = 0u;
            loop {
                let _e468 = phi_711_;
                let _e470 = phi_714_;
                let _e472 = phi_716_;
                local_4 = _e470;
                local_5 = _e470;
                local_6 = _e470;
                local_7 = _e470;
                local_8 = _e472;
                if (_e468.member < _e468.member_1) {
                    phi_712_ = type_11((_e468.member + 1u), _e468.member_1);
                    phi_739_ = type_11(1u, _e468.member);
                } else {
                    phi_712_ = _e468;
                    phi_739_ = type_11(0u, type_11().member_1);
                }
                let _e484 = phi_712_;
                let _e486 = phi_739_;
                let _e490 = (bitcast<i32>(_e486.member) != 0i);
                if _e490 {
                    let _e492 = atomicLoad((&masks[_e486.member_1]));
                    let _e493 = countOneBits(_e492);
                    if (_e486.member_1 < (_e35 / 32u)) {
                        phi_757_ = (_e470 + _e493);
                    } else {
                        phi_757_ = _e470;
                    }
                    let _e499 = phi_757_;
                    phi_715_ = _e499;
                    phi_717_ = (_e472 + _e493);
                } else {
                    phi_715_ = u32();
                    phi_717_ = u32();
                }
                let _e501 = phi_715_;
                let _e503 = phi_717_;
                continue;
                continuing {
                    phi_711_ = _e484;
                    phi_714_ = _e501;
                    phi_716_ = _e503;
                    break if !(_e490);
                }
            }
            if _e449 {
                let _e506 = local_4;
                boxes[_e506] = type_16(array<f32, 3>(_e441.member[0], _e441.member[1], _e441.member[2]), array<f32, 3>(_e441.member_1[0], _e441.member_1[1], _e441.member_1[2]));
                let _e520 = local_5;
                nodes[_e520] = _e447;
                let _e523 = local_6;
                leaves[_e523] = _e445;
                let _e526 = local_7;
                names[_e526] = _e443;
            }
            workgroupBarrier();
            let _e611 = local_8;
            phi_304_ = _e611;
        } else {
            phi_304_ = u32();
        }
        let _e529 = phi_304_;
        continue;
        continuing {
            phi_300_ = _e188;
            phi_303_ = _e529;
            break if !(_e194);
        }
    }
    if (_e35 == 0u) {
        let _e533 = nodes[0u];
        let _e534 = (_e533 * 4u);
        joins.member[_e534] = 4294967295u;
        joins.member[(_e534 + 1u)] = 0u;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_finish(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
