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
    var phi_131_: u32;
    var local: u32;
    var local_1: u32;
    var phi_260_: type_17;
    var phi_284_: u32;
    var phi_310_: type_8;
    var phi_313_: u32;
    var local_2: u32;
    var phi_366_: u32;
    var phi_377_: u32;
    var phi_417_: type_8;
    var phi_420_: type_19;
    var phi_541_: bool;
    var phi_547_: type_19;
    var phi_421_: type_19;
    var local_3: type_19;
    var phi_549_: u32;
    var phi_551_: u32;
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
        let _e60 = (_e55.member < _e55.member_1);
        let _e71 = select(type_8().member_1, _e55.member, _e60);
        let _e73 = (bitcast<i32>(select(0u, 1u, _e60)) != 0i);
        if _e73 {
            let _e76 = counts.member[(_e71 + 1u)];
            phi_131_ = select(_e57, (_e71 + 1u), (_e76 > 0u));
        } else {
            phi_131_ = u32();
        }
        let _e81 = phi_131_;
        continue;
        continuing {
            phi_127_ = type_8(select(_e55.member, (_e55.member + 1u), _e60), select(_e55.member_1, _e55.member_1, _e60));
            phi_130_ = _e81;
            break if !(_e73);
        }
    }
    let _e84 = local;
    let _e86 = counts.member[_e84];
    let _e88 = select(_e86, 256u, (256u < _e86));
    if (_e35 < _e88) {
        let _e91 = local_1;
        let _e93 = ((_e91 % 2u) == 1u);
        if _e93 {
            let _e118 = odd_clusters.member[_e35];
            phi_260_ = type_17(array<f32, 3>(bitcast<f32>(_e118.member.x), bitcast<f32>(_e118.member.y), bitcast<f32>(_e118.member.z)), _e118.member.w, array<f32, 3>(bitcast<f32>(_e118.member_1.x), bitcast<f32>(_e118.member_1.y), bitcast<f32>(_e118.member_1.z)), _e118.member_1.w);
        } else {
            let _e95 = even_clusters.member[_e35];
            phi_260_ = type_17(array<f32, 3>(bitcast<f32>(_e95.member.x), bitcast<f32>(_e95.member.y), bitcast<f32>(_e95.member.z)), _e95.member.w, array<f32, 3>(bitcast<f32>(_e95.member_1.x), bitcast<f32>(_e95.member_1.y), bitcast<f32>(_e95.member_1.z)), _e95.member_1.w);
        }
        let _e141 = phi_260_;
        if _e93 {
            let _e145 = odd_names.member[_e35];
            phi_284_ = _e145;
        } else {
            let _e143 = even_names.member[_e35];
            phi_284_ = _e143;
        }
        let _e147 = phi_284_;
        boxes[_e35] = type_16(array<f32, 3>(_e141.member[0], _e141.member[1], _e141.member[2]), array<f32, 3>(_e141.member_2[0], _e141.member_2[1], _e141.member_2[2]));
        nodes[_e35] = _e141.member_1;
        leaves[_e35] = _e141.member_3;
        names[_e35] = _e147;
    }
    workgroupBarrier();
    let _e167 = params.member.member_1.member;
    phi_310_ = type_8(0u, _e167);
    phi_313_ = _e88;
    loop {
        let _e170 = phi_310_;
        let _e172 = phi_313_;
        let _e175 = (_e170.member < _e170.member_1);
        let _e188 = (bitcast<i32>(select(0u, 1u, _e175)) != 0i);
        if _e188 {
            let _e189 = (_e35 < _e172);
            if _e189 {
                let _e195 = local_2;
                if (_e49 > 1u) {
                    let _e198 = (_e49 - 1u);
                    phi_366_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e198)), 32u, (_e198 == 0u)));
                } else {
                    phi_366_ = 0u;
                }
                let _e206 = phi_366_;
                if (_e172 > 1u) {
                    let _e208 = (_e172 - 1u);
                    phi_377_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e208)), 32u, (_e208 == 0u)));
                } else {
                    phi_377_ = 0u;
                }
                let _e216 = phi_377_;
                if ((_e195 + select(type_8().member_1, _e170.member, _e175)) >= (6u * ((_e206 - _e216) + 1u))) {
                    phi_549_ = select(_e35, (_e35 ^ 1u), ((_e35 ^ 1u) < _e172));
                } else {
                    let _e222 = boxes[_e35];
                    let _e233 = params.member.member_2.member_1;
                    let _e238 = ((_e35 + _e233) + 1u);
                    phi_417_ = type_8((_e35 - select(_e233, _e35, (_e35 < _e233))), select(_e238, _e172, (_e172 < _e238)));
                    phi_420_ = type_19(_e35, 300000000000000000000000000000000000000f);
                    loop {
                        let _e244 = phi_417_;
                        let _e246 = phi_420_;
                        local_3 = _e246;
                        let _e249 = (_e244.member < _e244.member_1);
                        let _e260 = select(type_8().member_1, _e244.member, _e249);
                        let _e262 = (bitcast<i32>(select(0u, 1u, _e249)) != 0i);
                        if _e262 {
                            let _e264 = boxes[_e260];
                            let _e277 = (select(_e264.member_1[0], _e222.member_1[0], (_e222.member_1[0] > _e264.member_1[0])) - select(_e264.member[0], _e222.member[0], (_e222.member[0] < _e264.member[0])));
                            let _e282 = (select(_e264.member_1[1], _e222.member_1[1], (_e222.member_1[1] > _e264.member_1[1])) - select(_e264.member[1], _e222.member[1], (_e222.member[1] < _e264.member[1])));
                            let _e287 = (select(_e264.member_1[2], _e222.member_1[2], (_e222.member_1[2] > _e264.member_1[2])) - select(_e264.member[2], _e222.member[2], (_e222.member[2] < _e264.member[2])));
                            let _e292 = (((_e277 * _e282) + (_e282 * _e287)) + (_e287 * _e277));
                            if (_e260 != _e35) {
                                if (_e292 < _e246.member_1) {
                                    phi_541_ = true;
                                } else {
                                    phi_541_ = select(false, select(((_e35 ^ _e260) < (_e35 ^ _e246.member)), true, (_e246.member == _e35)), (_e292 == _e246.member_1));
                                }
                                let _e306 = phi_541_;
                                phi_547_ = type_19(select(_e246.member, _e260, _e306), select(_e246.member_1, _e292, _e306));
                            } else {
                                phi_547_ = _e246;
                            }
                            let _e313 = phi_547_;
                            phi_421_ = _e313;
                        } else {
                            phi_421_ = type_19();
                        }
                        let _e315 = phi_421_;
                        continue;
                        continuing {
                            phi_417_ = type_8(select(_e244.member, (_e244.member + 1u), _e249), select(_e244.member_1, _e244.member_1, _e249));
                            phi_420_ = _e315;
                            break if !(_e262);
                        }
                    }
                    let _e318 = local_3;
                    phi_549_ = _e318.member;
                }
                let _e321 = phi_549_;
                neighbours[_e35] = _e321;
                phi_551_ = _e321;
            } else {
                phi_551_ = _e35;
            }
            let _e324 = phi_551_;
            if (_e35 < 8u) {
                atomicStore((&masks[_e35]), 0u);
            }
            workgroupBarrier();
            if _e189 {
                let _e328 = neighbours[_e324];
                let _e329 = (_e35 == _e324);
                let _e330 = (_e328 != _e35);
                let _e336 = select(select(select(select(2u, 1u, (_e35 < _e324)), u32(), _e330), u32(), _e329), 0u, select(_e330, true, _e329));
                let _e340 = boxes[_e35];
                let _e353 = nodes[_e35];
                let _e355 = leaves[_e35];
                let _e357 = names[_e35];
                if (_e336 == 1u) {
                    let _e360 = names[_e324];
                    let _e361 = (_e360 - 1u);
                    let _e363 = leaves[_e324];
                    let _e365 = nodes[_e324];
                    let _e366 = (_e361 * 4u);
                    let _e367 = (_e353 * 4u);
                    let _e368 = (_e365 * 4u);
                    joins.member[_e367] = _e361;
                    joins.member[(_e367 + 1u)] = 0u;
                    joins.member[_e368] = _e361;
                    joins.member[(_e368 + 1u)] = _e355;
                    joins.member[(_e366 + 2u)] = _e355;
                    joins.member[(_e366 + 3u)] = (_e355 + _e363);
                    let _e381 = boxes[_e324];
                    phi_717_ = type_16(array<f32, 3>(select(_e381.member[0], _e340.member[0], (_e340.member[0] < _e381.member[0])), select(_e381.member[1], _e340.member[1], (_e340.member[1] < _e381.member[1])), select(_e381.member[2], _e340.member[2], (_e340.member[2] < _e381.member[2]))), array<f32, 3>(select(_e381.member_1[0], _e340.member_1[0], (_e340.member_1[0] > _e381.member_1[0])), select(_e381.member_1[1], _e340.member_1[1], (_e340.member_1[1] > _e381.member_1[1])), select(_e381.member_1[2], _e340.member_1[2], (_e340.member_1[2] > _e381.member_1[2]))));
                    phi_718_ = (_e355 + _e363);
                    phi_719_ = _e361;
                } else {
                    phi_717_ = type_16(array<f32, 3>(_e340.member[0], _e340.member[1], _e340.member[2]), array<f32, 3>(_e340.member_1[0], _e340.member_1[1], _e340.member_1[2]));
                    phi_718_ = _e355;
                    phi_719_ = _e353;
                }
                let _e407 = phi_717_;
                let _e409 = phi_718_;
                let _e411 = phi_719_;
                phi_720_ = _e407;
                phi_721_ = _e357;
                phi_722_ = _e409;
                phi_723_ = _e411;
                phi_724_ = !((_e336 == 2u));
            } else {
                phi_720_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_721_ = 0u;
                phi_722_ = 0u;
                phi_723_ = 0u;
                phi_724_ = false;
            }
            let _e413 = phi_720_;
            let _e415 = phi_721_;
            let _e417 = phi_722_;
            let _e419 = phi_723_;
            let _e421 = phi_724_;
            if _e421 {
                let _e428 = atomicOr((&masks[(_e35 / 32u)]), (1u << bitcast<u32>(((_e35 % 32u) & 31u))));
            }
            workgroupBarrier();
            let _e431 = atomicLoad((&masks[(_e35 / 32u)]));
            phi_745_ = type_8(0u, 8u);
            phi_748_ = countOneBits((_e431 & ((1u << bitcast<u32>(((_e35 % 32u) & 31u))) - 1u)));
            phi_750_ = 0u;
            loop {
                let _e440 = phi_745_;
                let _e442 = phi_748_;
                let _e444 = phi_750_;
                local_4 = _e442;
                local_5 = _e442;
                local_6 = _e442;
                local_7 = _e442;
                local_8 = _e444;
                let _e447 = (_e440.member < _e440.member_1);
                let _e458 = select(type_8().member_1, _e440.member, _e447);
                let _e460 = (bitcast<i32>(select(0u, 1u, _e447)) != 0i);
                if _e460 {
                    let _e462 = atomicLoad((&masks[_e458]));
                    let _e463 = countOneBits(_e462);
                    phi_749_ = select(_e442, (_e442 + _e463), (_e458 < (_e35 / 32u)));
                    phi_751_ = (_e444 + _e463);
                } else {
                    phi_749_ = u32();
                    phi_751_ = u32();
                }
                let _e470 = phi_749_;
                let _e472 = phi_751_;
                continue;
                continuing {
                    phi_745_ = type_8(select(_e440.member, (_e440.member + 1u), _e447), select(_e440.member_1, _e440.member_1, _e447));
                    phi_748_ = _e470;
                    phi_750_ = _e472;
                    break if !(_e460);
                }
            }
            if _e421 {
                let _e475 = local_4;
                boxes[_e475] = type_16(array<f32, 3>(_e413.member[0], _e413.member[1], _e413.member[2]), array<f32, 3>(_e413.member_1[0], _e413.member_1[1], _e413.member_1[2]));
                let _e489 = local_5;
                nodes[_e489] = _e419;
                let _e492 = local_6;
                leaves[_e492] = _e417;
                let _e495 = local_7;
                names[_e495] = _e415;
            }
            workgroupBarrier();
            let _e546 = local_8;
            phi_314_ = _e546;
        } else {
            phi_314_ = u32();
        }
        let _e498 = phi_314_;
        continue;
        continuing {
            phi_310_ = type_8(select(_e170.member, (_e170.member + 1u), _e175), select(_e170.member_1, _e170.member_1, _e175));
            phi_313_ = _e498;
            break if !(_e188);
        }
    }
    if (_e35 == 0u) {
        let _e502 = nodes[0u];
        let _e503 = (_e502 * 4u);
        joins.member[_e503] = 4294967295u;
        joins.member[(_e503 + 1u)] = 0u;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_finish(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
