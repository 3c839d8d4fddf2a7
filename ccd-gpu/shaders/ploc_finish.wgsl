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

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
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

struct type_19 {
    member: u32,
    member_1: f32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_21 {
    member: type_6,
    member_1: type_7,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_25 {
    member: array<type_23>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> counts: type_10;
@group(0) @binding(2) 
var<storage> even_clusters: type_25;
@group(0) @binding(3) 
var<storage> even_names: type_10;
@group(0) @binding(4) 
var<storage> odd_clusters: type_25;
@group(0) @binding(5) 
var<storage> odd_names: type_10;
@group(0) @binding(6) 
var<storage, read_write> joins: type_10;
var<workgroup> boxes: array<type_16, 256>;
var<workgroup> nodes: array<u32, 256>;
var<workgroup> leaves: array<u32, 256>;
var<workgroup> names: array<u32, 256>;
var<workgroup> neighbours: array<u32, 256>;
var<workgroup> masks: array<atomic<u32>, 8>;

fn function_(lane_1: u32) {
    var phi_127_: type_8;
    var phi_130_: u32;
    var phi_128_: type_8;
    var phi_153_: type_8;
    var phi_177_: u32;
    var phi_131_: u32;
    var local: u32;
    var phi_192_: u32;
    var local_1: u32;
    var phi_260_: type_17;
    var phi_284_: u32;
    var phi_310_: type_8;
    var phi_313_: u32;
    var phi_311_: type_8;
    var phi_336_: type_8;
    var phi_354_: u32;
    var local_2: u32;
    var phi_366_: u32;
    var phi_377_: u32;
    var phi_405_: u32;
    var phi_413_: u32;
    var phi_417_: type_8;
    var phi_420_: type_19;
    var phi_418_: type_8;
    var phi_443_: type_8;
    var phi_470_: f32;
    var phi_477_: f32;
    var phi_485_: f32;
    var phi_492_: f32;
    var phi_500_: f32;
    var phi_507_: f32;
    var phi_536_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_546_: type_19;
    var phi_547_: type_19;
    var phi_421_: type_19;
    var local_3: type_19;
    var phi_549_: u32;
    var phi_551_: u32;
    var phi_574_: u32;
    var phi_575_: u32;
    var phi_576_: u32;
    var phi_577_: bool;
    var phi_581_: u32;
    var phi_677_: f32;
    var phi_684_: f32;
    var phi_691_: f32;
    var phi_699_: f32;
    var phi_706_: f32;
    var phi_713_: f32;
    var phi_717_: type_16;
    var phi_718_: u32;
    var phi_719_: u32;
    var phi_720_: type_16;
    var phi_721_: u32;
    var phi_722_: u32;
    var phi_723_: u32;
    var phi_724_: bool;
    var phi_745_: type_8;
    var phi_748_: u32;
    var phi_750_: u32;
    var phi_746_: type_8;
    var phi_773_: type_8;
    var phi_791_: u32;
    var phi_749_: u32;
    var phi_751_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_314_: u32;
    var local_8: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e35 = lane_2;
    let _e45 = params.member.member_2.member;
    let _e49 = params.member.member.member[_e45];
    let _e52 = params.member.member_2.member_2;
    phi_127_ = type_8(0u, _e52);
    phi_130_ = 0u;
    loop {
        let _e55 = phi_127_;
        let _e57 = phi_130_;
        local = _e57;
        local_1 = _e57;
        local_2 = _e57;
        if (_e55.member < _e55.member_1) {
            phi_128_ = type_8((_e55.member + 1u), _e55.member_1);
            phi_153_ = type_8(1u, _e55.member);
        } else {
            phi_128_ = _e55;
            phi_153_ = type_8(0u, type_8().member_1);
        }
        let _e69 = phi_128_;
        let _e71 = phi_153_;
        let _e75 = (bitcast<i32>(_e71.member) != 0i);
        if _e75 {
            let _e78 = counts.member[(_e71.member_1 + 1u)];
            if (_e78 > 0u) {
                phi_177_ = (_e71.member_1 + 1u);
            } else {
                phi_177_ = _e57;
            }
            let _e82 = phi_177_;
            phi_131_ = _e82;
        } else {
            phi_131_ = u32();
        }
        let _e84 = phi_131_;
        continue;
        continuing {
            phi_127_ = _e69;
            phi_130_ = _e84;
            break if !(_e75);
        }
    }
    let _e87 = local;
    let _e89 = counts.member[_e87];
    if (256u < _e89) {
        phi_192_ = 256u;
    } else {
        phi_192_ = _e89;
    }
    let _e92 = phi_192_;
    if (_e35 < _e92) {
        let _e95 = local_1;
        let _e97 = ((_e95 % 2u) == 1u);
        if _e97 {
            let _e122 = odd_clusters.member[_e35];
            phi_260_ = type_17(array<f32, 3>(bitcast<f32>(_e122.member.x), bitcast<f32>(_e122.member.y), bitcast<f32>(_e122.member.z)), _e122.member.w, array<f32, 3>(bitcast<f32>(_e122.member_1.x), bitcast<f32>(_e122.member_1.y), bitcast<f32>(_e122.member_1.z)), _e122.member_1.w);
        } else {
            let _e99 = even_clusters.member[_e35];
            phi_260_ = type_17(array<f32, 3>(bitcast<f32>(_e99.member.x), bitcast<f32>(_e99.member.y), bitcast<f32>(_e99.member.z)), _e99.member.w, array<f32, 3>(bitcast<f32>(_e99.member_1.x), bitcast<f32>(_e99.member_1.y), bitcast<f32>(_e99.member_1.z)), _e99.member_1.w);
        }
        let _e145 = phi_260_;
        if _e97 {
            let _e149 = odd_names.member[_e35];
            phi_284_ = _e149;
        } else {
            let _e147 = even_names.member[_e35];
            phi_284_ = _e147;
        }
        let _e151 = phi_284_;
        boxes[_e35] = type_16(array<f32, 3>(_e145.member[0], _e145.member[1], _e145.member[2]), array<f32, 3>(_e145.member_2[0], _e145.member_2[1], _e145.member_2[2]));
        nodes[_e35] = _e145.member_1;
        leaves[_e35] = _e145.member_3;
        names[_e35] = _e151;
    }
    workgroupBarrier();
    let _e171 = params.member.member_1.member;
    phi_310_ = type_8(0u, _e171);
    phi_313_ = _e92;
    loop {
        let _e174 = phi_310_;
        let _e176 = phi_313_;
        if (_e174.member < _e174.member_1) {
            phi_311_ = type_8((_e174.member + 1u), _e174.member_1);
            phi_336_ = type_8(1u, _e174.member);
        } else {
            phi_311_ = _e174;
            phi_336_ = type_8(0u, type_8().member_1);
        }
        let _e188 = phi_311_;
        let _e190 = phi_336_;
        let _e194 = (bitcast<i32>(_e190.member) != 0i);
        if _e194 {
            let _e195 = (_e35 < _e176);
            if _e195 {
                if ((_e35 ^ 1u) < _e176) {
                    phi_354_ = (_e35 ^ 1u);
                } else {
                    phi_354_ = _e35;
                }
                let _e200 = phi_354_;
                let _e202 = local_2;
                if (_e49 > 1u) {
                    let _e205 = (_e49 - 1u);
                    phi_366_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e205)), 32u, (_e205 == 0u)));
                } else {
                    phi_366_ = 0u;
                }
                let _e213 = phi_366_;
                if (_e176 > 1u) {
                    let _e215 = (_e176 - 1u);
                    phi_377_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u)));
                } else {
                    phi_377_ = 0u;
                }
                let _e223 = phi_377_;
                if ((_e202 + _e190.member_1) >= (6u * ((_e213 - _e223) + 1u))) {
                    phi_549_ = _e200;
                } else {
                    let _e229 = boxes[_e35];
                    let _e240 = params.member.member_2.member_1;
                    if (_e35 < _e240) {
                        phi_405_ = _e35;
                    } else {
                        phi_405_ = _e240;
                    }
                    let _e243 = phi_405_;
                    let _e246 = ((_e35 + _e240) + 1u);
                    if (_e176 < _e246) {
                        phi_413_ = _e176;
                    } else {
                        phi_413_ = _e246;
                    }
                    let _e249 = phi_413_;
                    phi_417_ = type_8((_e35 - _e243), _e249);
                    phi_420_ = type_19(_e35, 300000000000000000000000000000000000000f);
                    loop {
                        let _e253 = phi_417_;
                        let _e255 = phi_420_;
                        local_3 = _e255;
                        if (_e253.member < _e253.member_1) {
                            phi_418_ = type_8((_e253.member + 1u), _e253.member_1);
                            phi_443_ = type_8(1u, _e253.member);
                        } else {
                            phi_418_ = _e253;
                            phi_443_ = type_8(0u, type_8().member_1);
                        }
                        let _e267 = phi_418_;
                        let _e269 = phi_443_;
                        let _e273 = (bitcast<i32>(_e269.member) != 0i);
                        if _e273 {
                            let _e275 = boxes[_e269.member_1];
                            if (_e229.member_1[0] > _e275.member_1[0]) {
                                phi_470_ = _e229.member_1[0];
                            } else {
                                phi_470_ = _e275.member_1[0];
                            }
                            let _e286 = phi_470_;
                            if (_e229.member[0] < _e275.member[0]) {
                                phi_477_ = _e229.member[0];
                            } else {
                                phi_477_ = _e275.member[0];
                            }
                            let _e289 = phi_477_;
                            let _e290 = (_e286 - _e289);
                            if (_e229.member_1[1] > _e275.member_1[1]) {
                                phi_485_ = _e229.member_1[1];
                            } else {
                                phi_485_ = _e275.member_1[1];
                            }
                            let _e293 = phi_485_;
                            if (_e229.member[1] < _e275.member[1]) {
                                phi_492_ = _e229.member[1];
                            } else {
                                phi_492_ = _e275.member[1];
                            }
                            let _e296 = phi_492_;
                            let _e297 = (_e293 - _e296);
                            if (_e229.member_1[2] > _e275.member_1[2]) {
                                phi_500_ = _e229.member_1[2];
                            } else {
                                phi_500_ = _e275.member_1[2];
                            }
                            let _e300 = phi_500_;
                            if (_e229.member[2] < _e275.member[2]) {
                                phi_507_ = _e229.member[2];
                            } else {
                                phi_507_ = _e275.member[2];
                            }
                            let _e303 = phi_507_;
                            let _e304 = (_e300 - _e303);
                            let _e309 = (((_e290 * _e297) + (_e297 * _e304)) + (_e304 * _e290));
                            if (_e269.member_1 != _e35) {
                                if (_e309 < _e255.member_1) {
                                    phi_541_ = true;
                                } else {
                                    if (_e309 == _e255.member_1) {
                                        if (_e255.member == _e35) {
                                            phi_536_ = true;
                                        } else {
                                            phi_536_ = ((_e35 ^ _e269.member_1) < (_e35 ^ _e255.member));
                                        }
                                        let _e321 = phi_536_;
                                        phi_540_ = _e321;
                                    } else {
                                        phi_540_ = false;
                                    }
                                    let _e323 = phi_540_;
                                    phi_541_ = _e323;
                                }
                                let _e325 = phi_541_;
                                if _e325 {
                                    phi_546_ = type_19(_e269.member_1, _e309);
                                } else {
                                    phi_546_ = _e255;
                                }
                                let _e328 = phi_546_;
                                phi_547_ = _e328;
                            } else {
                                phi_547_ = _e255;
                            }
                            let _e330 = phi_547_;
                            phi_421_ = _e330;
                        } else {
                            phi_421_ = type_19();
                        }
                        let _e332 = phi_421_;
                        continue;
                        continuing {
                            phi_417_ = _e267;
                            phi_420_ = _e332;
                            break if !(_e273);
                        }
                    }
                    let _e335 = local_3;
                    phi_549_ = _e335.member;
                }
                let _e338 = phi_549_;
                neighbours[_e35] = _e338;
                phi_551_ = _e338;
            } else {
                phi_551_ = _e35;
            }
            let _e341 = phi_551_;
            if (_e35 < 8u) {
                atomicStore((&masks[_e35]), 0u);
            }
            workgroupBarrier();
            if _e195 {
                let _e345 = neighbours[_e341];
                if (_e35 == _e341) {
                    phi_576_ = u32();
                    phi_577_ = true;
                } else {
                    let _e347 = (_e345 != _e35);
                    if _e347 {
                        phi_575_ = u32();
                    } else {
                        if (_e35 < _e341) {
                            phi_574_ = 1u;
                        } else {
                            phi_574_ = 2u;
                        }
                        let _e350 = phi_574_;
                        phi_575_ = _e350;
                    }
                    let _e352 = phi_575_;
                    phi_576_ = _e352;
                    phi_577_ = _e347;
                }
                let _e354 = phi_576_;
                let _e356 = phi_577_;
                if _e356 {
                    phi_581_ = 0u;
                } else {
                    phi_581_ = _e354;
                }
                let _e358 = phi_581_;
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
                        phi_677_ = _e362.member[0];
                    } else {
                        phi_677_ = _e403.member[0];
                    }
                    let _e414 = phi_677_;
                    if (_e362.member[1] < _e403.member[1]) {
                        phi_684_ = _e362.member[1];
                    } else {
                        phi_684_ = _e403.member[1];
                    }
                    let _e417 = phi_684_;
                    if (_e362.member[2] < _e403.member[2]) {
                        phi_691_ = _e362.member[2];
                    } else {
                        phi_691_ = _e403.member[2];
                    }
                    let _e420 = phi_691_;
                    if (_e362.member_1[0] > _e403.member_1[0]) {
                        phi_699_ = _e362.member_1[0];
                    } else {
                        phi_699_ = _e403.member_1[0];
                    }
                    let _e424 = phi_699_;
                    if (_e362.member_1[1] > _e403.member_1[1]) {
                        phi_706_ = _e362.member_1[1];
                    } else {
                        phi_706_ = _e403.member_1[1];
                    }
                    let _e427 = phi_706_;
                    if (_e362.member_1[2] > _e403.member_1[2]) {
                        phi_713_ = _e362.member_1[2];
                    } else {
                        phi_713_ = _e403.member_1[2];
                    }
                    let _e430 = phi_713_;
                    phi_717_ = type_16(array<f32, 3>(_e414, _e417, _e420), array<f32, 3>(_e424, _e427, _e430));
                    phi_718_ = (_e377 + _e385);
                    phi_719_ = _e383;
                } else {
                    phi_717_ = type_16(array<f32, 3>(_e362.member[0], _e362.member[1], _e362.member[2]), array<f32, 3>(_e362.member_1[0], _e362.member_1[1], _e362.member_1[2]));
                    phi_718_ = _e377;
                    phi_719_ = _e375;
                }
                let _e435 = phi_717_;
                let _e437 = phi_718_;
                let _e439 = phi_719_;
                phi_720_ = _e435;
                phi_721_ = _e379;
                phi_722_ = _e437;
                phi_723_ = _e439;
                phi_724_ = !((_e358 == 2u));
            } else {
                phi_720_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_721_ = 0u;
                phi_722_ = 0u;
                phi_723_ = 0u;
                phi_724_ = false;
            }
            let _e441 = phi_720_;
            let _e443 = phi_721_;
            let _e445 = phi_722_;
            let _e447 = phi_723_;
            let _e449 = phi_724_;
            if _e449 {
                let _e456 = atomicOr((&masks[(_e35 / 32u)]), (1u << bitcast<u32>(((_e35 % 32u) & 31u))));
            }
            workgroupBarrier();
            let _e459 = atomicLoad((&masks[(_e35 / 32u)]));
            phi_745_ = type_8(0u, 8u);
            phi_748_ = countOneBits((_e459 & ((1u << bitcast<u32>(((_e35 % 32u) & 31u))) - 1u)));
            phi_750_ = 0u;
            loop {
                let _e468 = phi_745_;
                let _e470 = phi_748_;
                let _e472 = phi_750_;
                local_4 = _e470;
                local_5 = _e470;
                local_6 = _e470;
                local_7 = _e470;
                local_8 = _e472;
                if (_e468.member < _e468.member_1) {
                    phi_746_ = type_8((_e468.member + 1u), _e468.member_1);
                    phi_773_ = type_8(1u, _e468.member);
                } else {
                    phi_746_ = _e468;
                    phi_773_ = type_8(0u, type_8().member_1);
                }
                let _e484 = phi_746_;
                let _e486 = phi_773_;
                let _e490 = (bitcast<i32>(_e486.member) != 0i);
                if _e490 {
                    let _e492 = atomicLoad((&masks[_e486.member_1]));
                    let _e493 = countOneBits(_e492);
                    if (_e486.member_1 < (_e35 / 32u)) {
                        phi_791_ = (_e470 + _e493);
                    } else {
                        phi_791_ = _e470;
                    }
                    let _e499 = phi_791_;
                    phi_749_ = _e499;
                    phi_751_ = (_e472 + _e493);
                } else {
                    phi_749_ = u32();
                    phi_751_ = u32();
                }
                let _e501 = phi_749_;
                let _e503 = phi_751_;
                continue;
                continuing {
                    phi_745_ = _e484;
                    phi_748_ = _e501;
                    phi_750_ = _e503;
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
            phi_314_ = _e611;
        } else {
            phi_314_ = u32();
        }
        let _e529 = phi_314_;
        continue;
        continuing {
            phi_310_ = _e188;
            phi_313_ = _e529;
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
