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
    var phi_123_: type_8;
    var phi_126_: u32;
    var phi_124_: type_8;
    var phi_149_: type_8;
    var phi_173_: u32;
    var phi_127_: u32;
    var local: u32;
    var phi_188_: u32;
    var local_1: u32;
    var phi_256_: type_17;
    var phi_280_: u32;
    var phi_306_: type_8;
    var phi_309_: u32;
    var phi_307_: type_8;
    var phi_332_: type_8;
    var phi_350_: u32;
    var local_2: u32;
    var phi_362_: u32;
    var phi_373_: u32;
    var phi_401_: u32;
    var phi_409_: u32;
    var phi_413_: type_8;
    var phi_416_: type_19;
    var phi_414_: type_8;
    var phi_439_: type_8;
    var phi_466_: f32;
    var phi_473_: f32;
    var phi_481_: f32;
    var phi_488_: f32;
    var phi_496_: f32;
    var phi_503_: f32;
    var phi_532_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_542_: type_19;
    var phi_543_: type_19;
    var phi_417_: type_19;
    var local_3: type_19;
    var phi_545_: u32;
    var phi_547_: u32;
    var phi_570_: u32;
    var phi_571_: u32;
    var phi_572_: u32;
    var phi_573_: bool;
    var phi_577_: u32;
    var phi_649_: f32;
    var phi_656_: f32;
    var phi_663_: f32;
    var phi_671_: f32;
    var phi_678_: f32;
    var phi_685_: f32;
    var phi_689_: type_16;
    var phi_690_: u32;
    var phi_691_: u32;
    var phi_692_: type_16;
    var phi_693_: u32;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_696_: bool;
    var phi_717_: type_8;
    var phi_720_: u32;
    var phi_722_: u32;
    var phi_718_: type_8;
    var phi_745_: type_8;
    var phi_763_: u32;
    var phi_721_: u32;
    var phi_723_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_310_: u32;
    var local_8: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e35 = lane_2;
    let _e45 = params.member.member_2.member;
    let _e49 = params.member.member.member[_e45];
    let _e52 = params.member.member_2.member_2;
    phi_123_ = type_8(0u, _e52);
    phi_126_ = 0u;
    loop {
        let _e55 = phi_123_;
        let _e57 = phi_126_;
        local = _e57;
        local_1 = _e57;
        local_2 = _e57;
        if (_e55.member < _e55.member_1) {
            phi_124_ = type_8((_e55.member + 1u), _e55.member_1);
            phi_149_ = type_8(1u, _e55.member);
        } else {
            phi_124_ = _e55;
            phi_149_ = type_8(0u, type_8().member_1);
        }
        let _e69 = phi_124_;
        let _e71 = phi_149_;
        let _e75 = (bitcast<i32>(_e71.member) != 0i);
        if _e75 {
            let _e78 = counts.member[(_e71.member_1 + 1u)];
            if (_e78 > 0u) {
                phi_173_ = (_e71.member_1 + 1u);
            } else {
                phi_173_ = _e57;
            }
            let _e82 = phi_173_;
            phi_127_ = _e82;
        } else {
            phi_127_ = u32();
        }
        let _e84 = phi_127_;
        continue;
        continuing {
            phi_123_ = _e69;
            phi_126_ = _e84;
            break if !(_e75);
        }
    }
    let _e87 = local;
    let _e89 = counts.member[_e87];
    if (256u < _e89) {
        phi_188_ = 256u;
    } else {
        phi_188_ = _e89;
    }
    let _e92 = phi_188_;
    if (_e35 < _e92) {
        let _e95 = local_1;
        let _e97 = ((_e95 % 2u) == 1u);
        if _e97 {
            let _e122 = odd_clusters.member[_e35];
            phi_256_ = type_17(array<f32, 3>(bitcast<f32>(_e122.member.x), bitcast<f32>(_e122.member.y), bitcast<f32>(_e122.member.z)), _e122.member.w, array<f32, 3>(bitcast<f32>(_e122.member_1.x), bitcast<f32>(_e122.member_1.y), bitcast<f32>(_e122.member_1.z)), _e122.member_1.w);
        } else {
            let _e99 = even_clusters.member[_e35];
            phi_256_ = type_17(array<f32, 3>(bitcast<f32>(_e99.member.x), bitcast<f32>(_e99.member.y), bitcast<f32>(_e99.member.z)), _e99.member.w, array<f32, 3>(bitcast<f32>(_e99.member_1.x), bitcast<f32>(_e99.member_1.y), bitcast<f32>(_e99.member_1.z)), _e99.member_1.w);
        }
        let _e145 = phi_256_;
        if _e97 {
            let _e149 = odd_names.member[_e35];
            phi_280_ = _e149;
        } else {
            let _e147 = even_names.member[_e35];
            phi_280_ = _e147;
        }
        let _e151 = phi_280_;
        boxes[_e35] = type_16(array<f32, 3>(_e145.member[0], _e145.member[1], _e145.member[2]), array<f32, 3>(_e145.member_2[0], _e145.member_2[1], _e145.member_2[2]));
        nodes[_e35] = _e145.member_1;
        leaves[_e35] = _e145.member_3;
        names[_e35] = _e151;
    }
    workgroupBarrier();
    let _e171 = params.member.member_1.member;
    phi_306_ = type_8(0u, _e171);
    phi_309_ = _e92;
    loop {
        let _e174 = phi_306_;
        let _e176 = phi_309_;
        if (_e174.member < _e174.member_1) {
            phi_307_ = type_8((_e174.member + 1u), _e174.member_1);
            phi_332_ = type_8(1u, _e174.member);
        } else {
            phi_307_ = _e174;
            phi_332_ = type_8(0u, type_8().member_1);
        }
        let _e188 = phi_307_;
        let _e190 = phi_332_;
        let _e194 = (bitcast<i32>(_e190.member) != 0i);
        if _e194 {
            let _e195 = (_e35 < _e176);
            if _e195 {
                if ((_e35 ^ 1u) < _e176) {
                    phi_350_ = (_e35 ^ 1u);
                } else {
                    phi_350_ = _e35;
                }
                let _e200 = phi_350_;
                let _e202 = local_2;
                if (_e49 > 1u) {
                    let _e205 = (_e49 - 1u);
                    phi_362_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e205)), 32u, (_e205 == 0u)));
                } else {
                    phi_362_ = 0u;
                }
                let _e213 = phi_362_;
                if (_e176 > 1u) {
                    let _e215 = (_e176 - 1u);
                    phi_373_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u)));
                } else {
                    phi_373_ = 0u;
                }
                let _e223 = phi_373_;
                if ((_e202 + _e190.member_1) >= (6u * ((_e213 - _e223) + 1u))) {
                    phi_545_ = _e200;
                } else {
                    let _e229 = boxes[_e35];
                    let _e240 = params.member.member_2.member_1;
                    if (_e35 < _e240) {
                        phi_401_ = _e35;
                    } else {
                        phi_401_ = _e240;
                    }
                    let _e243 = phi_401_;
                    let _e246 = ((_e35 + _e240) + 1u);
                    if (_e176 < _e246) {
                        phi_409_ = _e176;
                    } else {
                        phi_409_ = _e246;
                    }
                    let _e249 = phi_409_;
                    phi_413_ = type_8((_e35 - _e243), _e249);
                    phi_416_ = type_19(_e35, 300000000000000000000000000000000000000f);
                    loop {
                        let _e253 = phi_413_;
                        let _e255 = phi_416_;
                        local_3 = _e255;
                        if (_e253.member < _e253.member_1) {
                            phi_414_ = type_8((_e253.member + 1u), _e253.member_1);
                            phi_439_ = type_8(1u, _e253.member);
                        } else {
                            phi_414_ = _e253;
                            phi_439_ = type_8(0u, type_8().member_1);
                        }
                        let _e267 = phi_414_;
                        let _e269 = phi_439_;
                        let _e273 = (bitcast<i32>(_e269.member) != 0i);
                        if _e273 {
                            let _e275 = boxes[_e269.member_1];
                            if (_e229.member_1[0] > _e275.member_1[0]) {
                                phi_466_ = _e229.member_1[0];
                            } else {
                                phi_466_ = _e275.member_1[0];
                            }
                            let _e286 = phi_466_;
                            if (_e229.member[0] < _e275.member[0]) {
                                phi_473_ = _e229.member[0];
                            } else {
                                phi_473_ = _e275.member[0];
                            }
                            let _e289 = phi_473_;
                            let _e290 = (_e286 - _e289);
                            if (_e229.member_1[1] > _e275.member_1[1]) {
                                phi_481_ = _e229.member_1[1];
                            } else {
                                phi_481_ = _e275.member_1[1];
                            }
                            let _e293 = phi_481_;
                            if (_e229.member[1] < _e275.member[1]) {
                                phi_488_ = _e229.member[1];
                            } else {
                                phi_488_ = _e275.member[1];
                            }
                            let _e296 = phi_488_;
                            let _e297 = (_e293 - _e296);
                            if (_e229.member_1[2] > _e275.member_1[2]) {
                                phi_496_ = _e229.member_1[2];
                            } else {
                                phi_496_ = _e275.member_1[2];
                            }
                            let _e300 = phi_496_;
                            if (_e229.member[2] < _e275.member[2]) {
                                phi_503_ = _e229.member[2];
                            } else {
                                phi_503_ = _e275.member[2];
                            }
                            let _e303 = phi_503_;
                            let _e304 = (_e300 - _e303);
                            let _e309 = (((_e290 * _e297) + (_e297 * _e304)) + (_e304 * _e290));
                            if (_e269.member_1 != _e35) {
                                if (_e309 < _e255.member_1) {
                                    phi_537_ = true;
                                } else {
                                    if (_e309 == _e255.member_1) {
                                        if (_e255.member == _e35) {
                                            phi_532_ = true;
                                        } else {
                                            phi_532_ = ((_e35 ^ _e269.member_1) < (_e35 ^ _e255.member));
                                        }
                                        let _e321 = phi_532_;
                                        phi_536_ = _e321;
                                    } else {
                                        phi_536_ = false;
                                    }
                                    let _e323 = phi_536_;
                                    phi_537_ = _e323;
                                }
                                let _e325 = phi_537_;
                                if _e325 {
                                    phi_542_ = type_19(_e269.member_1, _e309);
                                } else {
                                    phi_542_ = _e255;
                                }
                                let _e328 = phi_542_;
                                phi_543_ = _e328;
                            } else {
                                phi_543_ = _e255;
                            }
                            let _e330 = phi_543_;
                            phi_417_ = _e330;
                        } else {
                            phi_417_ = type_19();
                        }
                        let _e332 = phi_417_;
                        continue;
                        continuing {
                            phi_413_ = _e267;
                            phi_416_ = _e332;
                            break if !(_e273);
                        }
                    }
                    let _e335 = local_3;
                    phi_545_ = _e335.member;
                }
                let _e338 = phi_545_;
                neighbours[_e35] = _e338;
                phi_547_ = _e338;
            } else {
                phi_547_ = _e35;
            }
            let _e341 = phi_547_;
            if (_e35 < 8u) {
                atomicStore((&masks[_e35]), 0u);
            }
            workgroupBarrier();
            if _e195 {
                let _e345 = neighbours[_e341];
                if (_e35 == _e341) {
                    phi_572_ = u32();
                    phi_573_ = true;
                } else {
                    let _e347 = (_e345 != _e35);
                    if _e347 {
                        phi_571_ = u32();
                    } else {
                        if (_e35 < _e341) {
                            phi_570_ = 1u;
                        } else {
                            phi_570_ = 2u;
                        }
                        let _e350 = phi_570_;
                        phi_571_ = _e350;
                    }
                    let _e352 = phi_571_;
                    phi_572_ = _e352;
                    phi_573_ = _e347;
                }
                let _e354 = phi_572_;
                let _e356 = phi_573_;
                if _e356 {
                    phi_577_ = 0u;
                } else {
                    phi_577_ = _e354;
                }
                let _e358 = phi_577_;
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
                        phi_649_ = _e362.member[0];
                    } else {
                        phi_649_ = _e403.member[0];
                    }
                    let _e414 = phi_649_;
                    if (_e362.member[1] < _e403.member[1]) {
                        phi_656_ = _e362.member[1];
                    } else {
                        phi_656_ = _e403.member[1];
                    }
                    let _e417 = phi_656_;
                    if (_e362.member[2] < _e403.member[2]) {
                        phi_663_ = _e362.member[2];
                    } else {
                        phi_663_ = _e403.member[2];
                    }
                    let _e420 = phi_663_;
                    if (_e362.member_1[0] > _e403.member_1[0]) {
                        phi_671_ = _e362.member_1[0];
                    } else {
                        phi_671_ = _e403.member_1[0];
                    }
                    let _e424 = phi_671_;
                    if (_e362.member_1[1] > _e403.member_1[1]) {
                        phi_678_ = _e362.member_1[1];
                    } else {
                        phi_678_ = _e403.member_1[1];
                    }
                    let _e427 = phi_678_;
                    if (_e362.member_1[2] > _e403.member_1[2]) {
                        phi_685_ = _e362.member_1[2];
                    } else {
                        phi_685_ = _e403.member_1[2];
                    }
                    let _e430 = phi_685_;
                    phi_689_ = type_16(array<f32, 3>(_e414, _e417, _e420), array<f32, 3>(_e424, _e427, _e430));
                    phi_690_ = (_e377 + _e385);
                    phi_691_ = _e383;
                } else {
                    phi_689_ = type_16(array<f32, 3>(_e362.member[0], _e362.member[1], _e362.member[2]), array<f32, 3>(_e362.member_1[0], _e362.member_1[1], _e362.member_1[2]));
                    phi_690_ = _e377;
                    phi_691_ = _e375;
                }
                let _e435 = phi_689_;
                let _e437 = phi_690_;
                let _e439 = phi_691_;
                phi_692_ = _e435;
                phi_693_ = _e379;
                phi_694_ = _e437;
                phi_695_ = _e439;
                phi_696_ = !((_e358 == 2u));
            } else {
                phi_692_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_693_ = 0u;
                phi_694_ = 0u;
                phi_695_ = 0u;
                phi_696_ = false;
            }
            let _e441 = phi_692_;
            let _e443 = phi_693_;
            let _e445 = phi_694_;
            let _e447 = phi_695_;
            let _e449 = phi_696_;
            if _e449 {
                let _e456 = atomicOr((&masks[(_e35 / 32u)]), (1u << bitcast<u32>(((_e35 % 32u) & 31u))));
            }
            workgroupBarrier();
            let _e459 = atomicLoad((&masks[(_e35 / 32u)]));
            phi_717_ = type_8(0u, 8u);
            phi_720_ = countOneBits((_e459 & ((1u << bitcast<u32>(((_e35 % 32u) & 31u))) - 1u)));
            phi_722_ = 0u;
            loop {
                let _e468 = phi_717_;
                let _e470 = phi_720_;
                let _e472 = phi_722_;
                local_4 = _e470;
                local_5 = _e470;
                local_6 = _e470;
                local_7 = _e470;
                local_8 = _e472;
                if (_e468.member < _e468.member_1) {
                    phi_718_ = type_8((_e468.member + 1u), _e468.member_1);
                    phi_745_ = type_8(1u, _e468.member);
                } else {
                    phi_718_ = _e468;
                    phi_745_ = type_8(0u, type_8().member_1);
                }
                let _e484 = phi_718_;
                let _e486 = phi_745_;
                let _e490 = (bitcast<i32>(_e486.member) != 0i);
                if _e490 {
                    let _e492 = atomicLoad((&masks[_e486.member_1]));
                    let _e493 = countOneBits(_e492);
                    if (_e486.member_1 < (_e35 / 32u)) {
                        phi_763_ = (_e470 + _e493);
                    } else {
                        phi_763_ = _e470;
                    }
                    let _e499 = phi_763_;
                    phi_721_ = _e499;
                    phi_723_ = (_e472 + _e493);
                } else {
                    phi_721_ = u32();
                    phi_723_ = u32();
                }
                let _e501 = phi_721_;
                let _e503 = phi_723_;
                continue;
                continuing {
                    phi_717_ = _e484;
                    phi_720_ = _e501;
                    phi_722_ = _e503;
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
            phi_310_ = _e611;
        } else {
            phi_310_ = u32();
        }
        let _e529 = phi_310_;
        continue;
        continuing {
            phi_306_ = _e188;
            phi_309_ = _e529;
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
