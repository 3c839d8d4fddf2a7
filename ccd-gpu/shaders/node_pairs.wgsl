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

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
@group(0) @binding(2) 
var<storage> input: type_11;
@group(0) @binding(3) 
var<storage, read_write> output: type_30;
var<workgroup> rows: array<u32, 4>;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 384>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_155_: u32;
    var phi_182_: u32;
    var phi_269_: u32;
    var phi_449_: bool;
    var phi_485_: type_9;
    var phi_488_: u32;
    var phi_489_: u32;
    var local: u32;
    var local_1: u32;
    var phi_707_: type_9;
    var phi_710_: u32;
    var phi_711_: u32;
    var phi_775_: u32;
    var phi_776_: u32;
    var phi_809_: type_9;
    var phi_859_: type_9;
    var phi_862_: u32;
    var phi_864_: u32;
    var phi_866_: u32;
    var phi_863_: u32;
    var phi_865_: u32;
    var phi_867_: u32;
    var phi_1029_: u32;
    var phi_1036_: type_9;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_270_: u32;
    var local_2: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e39 = id_2;
    let _e40 = n_2;
    let _e41 = lane_2;
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    let _e60 = select(_e58, _e56, (_e56 < _e58));
    let _e63 = params.member.member_1.member_1;
    if (_e60 > _e63) {
        let _e67 = params.member.member_1.member_1;
        phi_155_ = (_e60 - _e67);
    } else {
        phi_155_ = 0u;
    }
    let _e70 = phi_155_;
    let _e73 = params.member.member_2.member_3;
    if (_e73 == 1u) {
        phi_182_ = _e70;
    } else {
        let _e77 = params.member.member_2.member_3;
        if (_e77 == 0u) {
            return;
        }
        let _e79 = (_e70 / _e77);
        if (_e77 == 0u) {
            return;
        }
        phi_182_ = select(_e79, (_e79 + 1u), ((_e70 % _e77) > 0u));
    }
    let _e86 = phi_182_;
    let _e89 = params.member.member_2.member_4;
    let _e91 = select(_e86, _e89, (_e89 < _e86));
    let _e95 = params.member.member_2.member_2;
    let _e97 = params.member.member_2.member_1;
    let _e98 = (_e97 == 0u);
    let _e99 = select(1u, 0u, _e98);
    let _e104 = params.member.member_2.member[_e95][_e99];
    let _e109 = params.member.member_2.member[(_e95 - 1u)][_e99];
    let _e114 = params.member.member_2.member[(_e95 - 1u)][select(1u, 2u, _e98)];
    phi_269_ = ((_e39.y * _e40.x) + _e39.x);
    loop {
        let _e116 = phi_269_;
        let _e117 = (_e91 / 4u);
        let _e122 = (_e116 < select(_e117, (_e117 + 1u), ((_e91 % 4u) > 0u)));
        if _e122 {
            let _e125 = ((_e116 * 4u) + (_e41 / 32u));
            let _e126 = (_e125 < _e91);
            let _e129 = params.member.member_1.member_1;
            let _e132 = params.member.member_2.member_3;
            let _e136 = (2u * (_e129 + select(0u, (_e125 * _e132), _e126)));
            let _e139 = input.member[(4u + _e136)];
            let _e142 = input.member[(_e136 + 5u)];
            if (_e41 <= 5u) {
                atomicStore((&counters[_e41]), 0u);
            }
            workgroupBarrier();
            let _e148 = params.member.member_2.member_1;
            let _e151 = select(false, (_e139 == _e142), (_e148 == 1u));
            let _e152 = (_e41 / 32u);
            let _e153 = (_e41 % 32u);
            let _e156 = ((_e109 + (_e139 * 32u)) + _e153);
            let _e159 = ((_e114 + (_e142 * 32u)) + _e153);
            let _e162 = nodes.member[(_e104 + _e139)];
            let _e176 = nodes.member[_e156];
            let _e190 = nodes.member[_e159];
            if (_e153 == 0u) {
                rows[_e152] = _e156;
            }
            if _e126 {
                if _e151 {
                    phi_449_ = true;
                } else {
                    phi_449_ = ((((((_e190.member.x <= _e162.member_1.y) && (_e162.member.x <= _e190.member_1.y)) && (_e190.member.y <= _e162.member_2.x)) && (_e162.member.y <= _e190.member_2.x)) && (_e190.member_1.x <= _e162.member_2.y)) && (_e162.member_1.x <= _e190.member_2.y));
                }
                let _e217 = phi_449_;
                if _e217 {
                    let _e219 = atomicAdd((&counters[_e152]), 1u);
                    let _e222 = ((_e152 * 32u) + select(_e219, _e153, _e151));
                    columns[_e222] = type_24(array<f32, 3>(_e190.member.x, _e190.member.y, _e190.member_1.x), array<f32, 3>(_e190.member_1.y, _e190.member_2.x, _e190.member_2.y));
                    names[_e222] = _e159;
                }
            }
            workgroupBarrier();
            let _e228 = (_e41 / 32u);
            let _e230 = (_e228 * 32u);
            let _e232 = atomicLoad((&counters[_e228]));
            phi_485_ = type_9(0u, ((_e232 + 3u) / 4u));
            phi_488_ = 0u;
            loop {
                let _e237 = phi_485_;
                let _e239 = phi_488_;
                local = _e239;
                local_1 = _e239;
                let _e242 = (_e237.member < _e237.member_1);
                let _e255 = (bitcast<i32>(select(0u, 1u, _e242)) != 0i);
                if _e255 {
                    let _e256 = (4u * select(type_9().member_1, _e237.member, _e242));
                    let _e259 = columns[(_e230 + _e256)];
                    let _e283 = columns[((_e230 + _e256) + 1u)];
                    let _e310 = columns[((_e230 + _e256) + 2u)];
                    let _e337 = columns[((_e230 + _e256) + 3u)];
                    phi_489_ = (_e239 | ((((select(0u, 1u, ((((((_e176.member.x <= _e259.member_1[0]) && (_e259.member[0] <= _e176.member_1.y)) && (_e176.member.y <= _e259.member_1[1])) && (_e259.member[1] <= _e176.member_2.x)) && (_e176.member_1.x <= _e259.member_1[2])) && (_e259.member[2] <= _e176.member_2.y))) | (select(0u, 1u, ((((((_e176.member.x <= _e283.member_1[0]) && (_e283.member[0] <= _e176.member_1.y)) && (_e176.member.y <= _e283.member_1[1])) && (_e283.member[1] <= _e176.member_2.x)) && (_e176.member_1.x <= _e283.member_1[2])) && (_e283.member[2] <= _e176.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e176.member.x <= _e310.member_1[0]) && (_e310.member[0] <= _e176.member_1.y)) && (_e176.member.y <= _e310.member_1[1])) && (_e310.member[1] <= _e176.member_2.x)) && (_e176.member_1.x <= _e310.member_1[2])) && (_e310.member[2] <= _e176.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e176.member.x <= _e337.member_1[0]) && (_e337.member[0] <= _e176.member_1.y)) && (_e176.member.y <= _e337.member_1[1])) && (_e337.member[1] <= _e176.member_2.x)) && (_e176.member_1.x <= _e337.member_1[2])) && (_e337.member[2] <= _e176.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e256 & 31u))));
                } else {
                    phi_489_ = u32();
                }
                let _e366 = phi_489_;
                continue;
                continuing {
                    phi_485_ = type_9(select(_e237.member, (_e237.member + 1u), _e242), select(_e237.member_1, _e237.member_1, _e242));
                    phi_488_ = _e366;
                    break if !(_e255);
                }
            }
            let _e374 = local;
            let _e377 = local_1;
            let _e378 = select(_e377, (_e374 & ((1u << bitcast<u32>((_e232 & 31u))) - 1u)), (_e232 < 32u));
            let _e383 = select(_e378, (_e378 & (4294967295u << bitcast<u32>(((_e41 % 32u) & 31u)))), _e151);
            let _e386 = params.member.member.member_1;
            if ((_e386 & 256u) != 0u) {
                if select(!((_e176.member.x <= _e176.member_1.y)), true, ((bitcast<u32>(_e176.member_1.y) & 1u) == 1u)) {
                    phi_707_ = type_9(0u, _e232);
                    phi_710_ = _e383;
                    loop {
                        let _e397 = phi_707_;
                        let _e399 = phi_710_;
                        local_2 = _e399;
                        let _e402 = (_e397.member < _e397.member_1);
                        let _e413 = select(type_9().member_1, _e397.member, _e402);
                        let _e415 = (bitcast<i32>(select(0u, 1u, _e402)) != 0i);
                        if _e415 {
                            let _e418 = columns[(_e230 + _e413)];
                            phi_711_ = select(_e399, (_e399 & ~((1u << bitcast<u32>((_e413 & 31u))))), select(!((_e418.member[0] <= _e418.member_1[0])), true, ((bitcast<u32>(_e418.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_711_ = u32();
                        }
                        let _e436 = phi_711_;
                        continue;
                        continuing {
                            phi_707_ = type_9(select(_e397.member, (_e397.member + 1u), _e402), select(_e397.member_1, _e397.member_1, _e402));
                            phi_710_ = _e436;
                            break if !(_e415);
                        }
                    }
                    let _e656 = local_2;
                    phi_775_ = _e656;
                } else {
                    phi_775_ = _e383;
                }
                let _e439 = phi_775_;
                phi_776_ = _e439;
            } else {
                phi_776_ = _e383;
            }
            let _e441 = phi_776_;
            let _e444 = atomicAdd((&counters[4u]), countOneBits(_e441));
            workgroupBarrier();
            if (_e41 == 0u) {
                let _e447 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e447;
            }
            let _e450 = workgroupUniformLoad((&n_hits[0u]));
            let _e451 = (_e450 / 384u);
            phi_809_ = type_9(0u, select(_e451, (_e451 + 1u), ((_e450 % 384u) > 0u)));
            loop {
                let _e458 = phi_809_;
                let _e461 = (_e458.member < _e458.member_1);
                let _e474 = (bitcast<i32>(select(0u, 1u, _e461)) != 0i);
                if _e474 {
                    let _e475 = (_e41 / 32u);
                    let _e476 = (select(type_9().member_1, _e458.member, _e461) * 384u);
                    if (_e441 == 0u) {
                    } else {
                        let _e483 = atomicLoad((&counters[_e475]));
                        phi_859_ = type_9(0u, ((_e483 + 3u) / 4u));
                        phi_862_ = (_e444 - _e476);
                        phi_864_ = ((_e41 * 128u) + (_e475 * 32u));
                        phi_866_ = _e441;
                        loop {
                            let _e488 = phi_859_;
                            let _e490 = phi_862_;
                            let _e492 = phi_864_;
                            let _e494 = phi_866_;
                            let _e497 = (_e488.member < _e488.member_1);
                            let _e508 = (bitcast<i32>(select(0u, 1u, _e497)) != 0i);
                            if _e508 {
                                let _e509 = (_e494 & 1u);
                                if (_e509 == 0u) {
                                } else {
                                    if (_e490 < 384u) {
                                        hits[_e490] = _e492;
                                    }
                                }
                                let _e515 = select((_e490 + 1u), _e490, (_e509 == 0u));
                                let _e516 = (_e494 & 2u);
                                if (_e516 == 0u) {
                                } else {
                                    if (_e515 < 384u) {
                                        hits[_e515] = (_e492 + 1u);
                                    }
                                }
                                let _e523 = select((_e515 + 1u), _e515, (_e516 == 0u));
                                let _e524 = (_e494 & 4u);
                                if (_e524 == 0u) {
                                } else {
                                    if (_e523 < 384u) {
                                        hits[_e523] = (_e492 + 2u);
                                    }
                                }
                                let _e531 = select((_e523 + 1u), _e523, (_e524 == 0u));
                                let _e532 = (_e494 & 8u);
                                if (_e532 == 0u) {
                                } else {
                                    if (_e531 < 384u) {
                                        hits[_e531] = (_e492 + 3u);
                                    }
                                }
                                phi_863_ = select((_e531 + 1u), _e531, (_e532 == 0u));
                                phi_865_ = (_e492 + 4u);
                                phi_867_ = (_e494 >> bitcast<u32>(4i));
                            } else {
                                phi_863_ = u32();
                                phi_865_ = u32();
                                phi_867_ = u32();
                            }
                            let _e544 = phi_863_;
                            let _e546 = phi_865_;
                            let _e548 = phi_867_;
                            continue;
                            continuing {
                                phi_859_ = type_9(select(_e488.member, (_e488.member + 1u), _e497), select(_e488.member_1, _e488.member_1, _e497));
                                phi_862_ = _e544;
                                phi_864_ = _e546;
                                phi_866_ = _e548;
                                break if !(_e508);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e551 = n_hits[0u];
                    let _e552 = (_e551 - _e476);
                    let _e554 = select(_e552, 384u, (384u < _e552));
                    if (_e41 == 0u) {
                        atomicStore((&counters[5u]), _e554);
                    }
                    workgroupBarrier();
                    if (_e41 == 0u) {
                        let _e559 = atomicLoad((&counters[5u]));
                        if (_e559 > 0u) {
                            let _e563 = params.member.member.member_1;
                            if ((_e563 & 1024u) != 0u) {
                                let _e573 = atomicAdd((&output.member[0u]), _e559);
                                let _e574 = (_e573 + _e559);
                                let _e576 = select(_e574, 4294967295u, (_e574 < _e573));
                                let _e579 = params.member.member_1.member_3;
                                if (_e576 > _e579) {
                                    let _e582 = atomicMax((&output.member[2u]), _e576);
                                }
                                phi_1029_ = _e573;
                            } else {
                                let _e567 = atomicAdd((&output.member[0u]), _e559);
                                if ((_e567 + _e559) < _e567) {
                                    let _e571 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1029_ = _e567;
                            }
                            let _e584 = phi_1029_;
                            atomicStore((&counters[6u]), _e584);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e588 = atomicLoad((&counters[6u]));
                    phi_1036_ = type_9(0u, 3u);
                    loop {
                        let _e590 = phi_1036_;
                        let _e593 = (_e590.member < _e590.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e593)) != 0i) {
                            let _e608 = (_e41 + (select(type_9().member_1, _e590.member, _e593) * 128u));
                            if (_e608 >= _e554) {
                                phi_1102_ = false;
                            } else {
                                let _e611 = hits[_e608];
                                let _e614 = rows[(_e611 / 4096u)];
                                let _e620 = names[(_e611 % 128u)];
                                let _e625 = params.member.member_1.member_3;
                                let _e626 = (_e588 + _e608);
                                if (_e626 < _e625) {
                                    let _e628 = (2u * _e626);
                                    atomicStore((&output.member[(4u + _e628)]), ((_e614 + ((_e611 / 128u) % 32u)) - _e109));
                                    atomicStore((&output.member[(_e628 + 5u)]), (_e620 - _e114));
                                }
                                phi_1102_ = true;
                            }
                            let _e634 = phi_1102_;
                            phi_1103_ = _e634;
                        } else {
                            phi_1103_ = false;
                        }
                        let _e636 = phi_1103_;
                        continue;
                        continuing {
                            phi_1036_ = type_9(select(_e590.member, (_e590.member + 1u), _e593), select(_e590.member_1, _e590.member_1, _e593));
                            break if !(_e636);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_809_ = type_9(select(_e458.member, (_e458.member + 1u), _e461), select(_e458.member_1, _e458.member_1, _e461));
                    break if !(_e474);
                }
            }
            phi_270_ = (_e116 + (_e40.x * _e40.y));
        } else {
            phi_270_ = u32();
        }
        let _e640 = phi_270_;
        continue;
        continuing {
            phi_269_ = _e640;
            break if !(_e122);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
