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

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_21 {
    member: array<vec4<u32>>,
}

struct type_23 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<vec4<f32>>,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> nodes: type_25;
var<workgroup> rows: array<u32, 4>;
var<workgroup> columns: array<type_27, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 384>;
@group(0) @binding(5) 
var<storage, read_write> output: type_37;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(2) 
var<storage> leaves: type_21;
@group(0) @binding(3) 
var<storage> ends: type_33;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_179_: u32;
    var phi_206_: u32;
    var phi_310_: u32;
    var phi_485_: bool;
    var phi_521_: type_9;
    var phi_524_: u32;
    var phi_525_: u32;
    var local: u32;
    var local_1: u32;
    var phi_858_: type_9;
    var phi_908_: type_9;
    var phi_911_: u32;
    var phi_913_: u32;
    var phi_915_: u32;
    var phi_912_: u32;
    var phi_914_: u32;
    var phi_916_: u32;
    var phi_1024_: type_9;
    var phi_1027_: u32;
    var phi_1235_: bool;
    var phi_1309_: bool;
    var phi_1327_: u32;
    var phi_1328_: u32;
    var phi_1329_: bool;
    var phi_1028_: u32;
    var phi_1330_: bool;
    var local_2: u32;
    var phi_1389_: u32;
    var phi_1413_: type_9;
    var phi_1416_: u32;
    var local_3: u32;
    var phi_1505_: type_9;
    var phi_1520_: u32;
    var phi_1417_: u32;
    var phi_311_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e67 = params.member.member_1.member_2;
    let _e69 = input.member[0u];
    let _e71 = select(_e69, _e67, (_e67 < _e69));
    let _e74 = params.member.member_1.member_1;
    if (_e71 > _e74) {
        let _e78 = params.member.member_1.member_1;
        phi_179_ = (_e71 - _e78);
    } else {
        phi_179_ = 0u;
    }
    let _e81 = phi_179_;
    let _e84 = params.member.member_2.member_3;
    if (_e84 == 1u) {
        phi_206_ = _e81;
    } else {
        let _e88 = params.member.member_2.member_3;
        if (_e88 == 0u) {
            return;
        }
        let _e90 = (_e81 / _e88);
        if (_e88 == 0u) {
            return;
        }
        phi_206_ = select(_e90, (_e90 + 1u), ((_e81 % _e88) > 0u));
    }
    let _e97 = phi_206_;
    let _e100 = params.member.member_2.member_4;
    let _e102 = select(_e97, _e100, (_e100 < _e97));
    let _e105 = params.member.member_2.member_1;
    let _e106 = (_e105 == 0u);
    let _e107 = select(1u, 0u, _e106);
    let _e112 = params.member.member_2.member[1u][_e107];
    let _e116 = params.member.member_2.member[0u][_e107];
    let _e120 = params.member.member_2.member[0u][select(1u, 2u, _e106)];
    let _e122 = params.member.member;
    let _e125 = params.member.member_2.member_1;
    let _e135 = (((_e122.member_5 + (2f * _e122.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e50 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_310_ = ((_e48.y * _e49.x) + _e48.x);
    loop {
        let _e139 = phi_310_;
        let _e140 = (_e102 / 4u);
        let _e145 = (_e139 < select(_e140, (_e140 + 1u), ((_e102 % 4u) > 0u)));
        if _e145 {
            let _e148 = ((_e139 * 4u) + (_e50 / 32u));
            let _e149 = (_e148 < _e102);
            let _e152 = params.member.member_1.member_1;
            let _e155 = params.member.member_2.member_3;
            let _e159 = (2u * (_e152 + select(0u, (_e148 * _e155), _e149)));
            let _e162 = input.member[(4u + _e159)];
            let _e165 = input.member[(_e159 + 5u)];
            if (_e50 <= 5u) {
                atomicStore((&counters[_e50]), 0u);
            }
            workgroupBarrier();
            let _e170 = select(false, (_e162 == _e165), (_e125 == 1u));
            let _e171 = (_e50 / 32u);
            let _e172 = (_e50 % 32u);
            let _e175 = ((_e116 + (_e162 * 32u)) + _e172);
            let _e178 = ((_e120 + (_e165 * 32u)) + _e172);
            let _e181 = nodes.member[(_e112 + _e162)];
            let _e195 = nodes.member[_e175];
            let _e209 = nodes.member[_e178];
            if (_e172 == 0u) {
                rows[_e171] = _e175;
            }
            if _e149 {
                if _e170 {
                    phi_485_ = true;
                } else {
                    phi_485_ = ((((((_e209.member.x <= _e181.member_1.y) && (_e181.member.x <= _e209.member_1.y)) && (_e209.member.y <= _e181.member_2.x)) && (_e181.member.y <= _e209.member_2.x)) && (_e209.member_1.x <= _e181.member_2.y)) && (_e181.member_1.x <= _e209.member_2.y));
                }
                let _e236 = phi_485_;
                if _e236 {
                    let _e238 = atomicAdd((&counters[_e171]), 1u);
                    let _e241 = ((_e171 * 32u) + select(_e238, _e172, _e170));
                    columns[_e241] = type_27(array<f32, 3>(_e209.member.x, _e209.member.y, _e209.member_1.x), array<f32, 3>(_e209.member_1.y, _e209.member_2.x, _e209.member_2.y));
                    names[_e241] = _e178;
                }
            }
            workgroupBarrier();
            let _e247 = (_e50 / 32u);
            let _e249 = (_e247 * 32u);
            let _e251 = atomicLoad((&counters[_e247]));
            phi_521_ = type_9(0u, ((_e251 + 3u) / 4u));
            phi_524_ = 0u;
            loop {
                let _e256 = phi_521_;
                let _e258 = phi_524_;
                local = _e258;
                local_1 = _e258;
                let _e261 = (_e256.member < _e256.member_1);
                let _e274 = (bitcast<i32>(select(0u, 1u, _e261)) != 0i);
                if _e274 {
                    let _e275 = (4u * select(type_9().member_1, _e256.member, _e261));
                    let _e278 = columns[(_e249 + _e275)];
                    let _e302 = columns[((_e249 + _e275) + 1u)];
                    let _e329 = columns[((_e249 + _e275) + 2u)];
                    let _e356 = columns[((_e249 + _e275) + 3u)];
                    phi_525_ = (_e258 | ((((select(0u, 1u, ((((((_e195.member.x <= _e278.member_1[0]) && (_e278.member[0] <= _e195.member_1.y)) && (_e195.member.y <= _e278.member_1[1])) && (_e278.member[1] <= _e195.member_2.x)) && (_e195.member_1.x <= _e278.member_1[2])) && (_e278.member[2] <= _e195.member_2.y))) | (select(0u, 1u, ((((((_e195.member.x <= _e302.member_1[0]) && (_e302.member[0] <= _e195.member_1.y)) && (_e195.member.y <= _e302.member_1[1])) && (_e302.member[1] <= _e195.member_2.x)) && (_e195.member_1.x <= _e302.member_1[2])) && (_e302.member[2] <= _e195.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e195.member.x <= _e329.member_1[0]) && (_e329.member[0] <= _e195.member_1.y)) && (_e195.member.y <= _e329.member_1[1])) && (_e329.member[1] <= _e195.member_2.x)) && (_e195.member_1.x <= _e329.member_1[2])) && (_e329.member[2] <= _e195.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e195.member.x <= _e356.member_1[0]) && (_e356.member[0] <= _e195.member_1.y)) && (_e195.member.y <= _e356.member_1[1])) && (_e356.member[1] <= _e195.member_2.x)) && (_e195.member_1.x <= _e356.member_1[2])) && (_e356.member[2] <= _e195.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e275 & 31u))));
                } else {
                    phi_525_ = u32();
                }
                let _e385 = phi_525_;
                continue;
                continuing {
                    phi_521_ = type_9(select(_e256.member, (_e256.member + 1u), _e261), select(_e256.member_1, _e256.member_1, _e261));
                    phi_524_ = _e385;
                    break if !(_e274);
                }
            }
            let _e393 = local;
            let _e396 = local_1;
            let _e397 = select(_e396, (_e393 & ((1u << bitcast<u32>((_e251 & 31u))) - 1u)), (_e251 < 32u));
            let _e402 = select(_e397, (_e397 & (4294967294u << bitcast<u32>(((_e50 % 32u) & 31u)))), _e170);
            let _e406 = atomicAdd((&counters[4u]), countOneBits(_e402));
            workgroupBarrier();
            if (_e50 == 0u) {
                let _e409 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e409;
            }
            let _e412 = workgroupUniformLoad((&n_hits[0u]));
            let _e413 = (_e412 / 384u);
            if (_e50 == 0u) {
                let _e420 = atomicLoad((&counters[7u]));
                let _e422 = n_hits[0u];
                atomicStore((&counters[7u]), (_e420 + _e422));
            }
            phi_858_ = type_9(0u, select(_e413, (_e413 + 1u), ((_e412 % 384u) > 0u)));
            loop {
                let _e427 = phi_858_;
                let _e430 = (_e427.member < _e427.member_1);
                let _e443 = (bitcast<i32>(select(0u, 1u, _e430)) != 0i);
                if _e443 {
                    let _e444 = (_e50 / 32u);
                    let _e445 = (select(type_9().member_1, _e427.member, _e430) * 384u);
                    if (_e402 == 0u) {
                    } else {
                        let _e452 = atomicLoad((&counters[_e444]));
                        phi_908_ = type_9(0u, ((_e452 + 3u) / 4u));
                        phi_911_ = (_e406 - _e445);
                        phi_913_ = ((_e50 * 128u) + (_e444 * 32u));
                        phi_915_ = _e402;
                        loop {
                            let _e457 = phi_908_;
                            let _e459 = phi_911_;
                            let _e461 = phi_913_;
                            let _e463 = phi_915_;
                            let _e466 = (_e457.member < _e457.member_1);
                            let _e477 = (bitcast<i32>(select(0u, 1u, _e466)) != 0i);
                            if _e477 {
                                let _e478 = (_e463 & 1u);
                                if (_e478 == 0u) {
                                } else {
                                    if (_e459 < 384u) {
                                        hits[_e459] = _e461;
                                    }
                                }
                                let _e484 = select((_e459 + 1u), _e459, (_e478 == 0u));
                                let _e485 = (_e463 & 2u);
                                if (_e485 == 0u) {
                                } else {
                                    if (_e484 < 384u) {
                                        hits[_e484] = (_e461 + 1u);
                                    }
                                }
                                let _e492 = select((_e484 + 1u), _e484, (_e485 == 0u));
                                let _e493 = (_e463 & 4u);
                                if (_e493 == 0u) {
                                } else {
                                    if (_e492 < 384u) {
                                        hits[_e492] = (_e461 + 2u);
                                    }
                                }
                                let _e500 = select((_e492 + 1u), _e492, (_e493 == 0u));
                                let _e501 = (_e463 & 8u);
                                if (_e501 == 0u) {
                                } else {
                                    if (_e500 < 384u) {
                                        hits[_e500] = (_e461 + 3u);
                                    }
                                }
                                phi_912_ = select((_e500 + 1u), _e500, (_e501 == 0u));
                                phi_914_ = (_e461 + 4u);
                                phi_916_ = (_e463 >> bitcast<u32>(4i));
                            } else {
                                phi_912_ = u32();
                                phi_914_ = u32();
                                phi_916_ = u32();
                            }
                            let _e513 = phi_912_;
                            let _e515 = phi_914_;
                            let _e517 = phi_916_;
                            continue;
                            continuing {
                                phi_908_ = type_9(select(_e457.member, (_e457.member + 1u), _e466), select(_e457.member_1, _e457.member_1, _e466));
                                phi_911_ = _e513;
                                phi_913_ = _e515;
                                phi_915_ = _e517;
                                break if !(_e477);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e520 = n_hits[0u];
                    let _e521 = (_e520 - _e445);
                    let _e523 = select(_e521, 384u, (384u < _e521));
                    phi_1024_ = type_9(0u, 3u);
                    phi_1027_ = 0u;
                    loop {
                        let _e525 = phi_1024_;
                        let _e527 = phi_1027_;
                        local_2 = _e527;
                        local_3 = _e527;
                        let _e530 = (_e525.member < _e525.member_1);
                        let _e541 = select(type_9().member_1, _e525.member, _e530);
                        if (bitcast<i32>(select(0u, 1u, _e530)) != 0i) {
                            let _e545 = (_e50 + (_e541 * 128u));
                            if (_e545 >= _e523) {
                                phi_1328_ = u32();
                                phi_1329_ = false;
                            } else {
                                let _e548 = hits[_e545];
                                let _e551 = rows[(_e548 / 4096u)];
                                let _e554 = (_e551 + ((_e548 / 128u) % 32u));
                                let _e557 = names[(_e548 % 128u)];
                                if ((_e122.member_1 & 512u) != 0u) {
                                    let _e563 = ends.member[((3u * _e554) - (2u * (_e554 % 32u)))];
                                    let _e570 = ends.member[(((3u * _e554) - (2u * (_e554 % 32u))) + 32u)];
                                    let _e585 = ends.member[(((3u * _e554) - (2u * (_e554 % 32u))) + 64u)];
                                    let _e595 = ends.member[((3u * _e557) - (2u * (_e557 % 32u)))];
                                    let _e602 = ends.member[(((3u * _e557) - (2u * (_e557 % 32u))) + 32u)];
                                    let _e617 = ends.member[(((3u * _e557) - (2u * (_e557 % 32u))) + 64u)];
                                    phi_1235_ = !(((((((_e563.x - _e595.w) > _e135) && ((_e570.z - _e617.y) > _e135)) || (((_e595.x - _e563.w) > _e135) && ((_e602.z - _e585.y) > _e135))) || ((((_e563.y - _e602.x) > _e135) && ((_e570.w - _e617.z) > _e135)) || (((_e595.y - _e570.x) > _e135) && ((_e602.w - _e585.z) > _e135)))) || ((((_e563.z - _e602.y) > _e135) && ((_e585.x - _e617.w) > _e135)) || (((_e595.z - _e570.y) > _e135) && ((_e617.x - _e585.w) > _e135)))));
                                } else {
                                    phi_1235_ = true;
                                }
                                let _e659 = phi_1235_;
                                if select(false, true, _e659) {
                                    let _e662 = leaves.member[_e554];
                                    let _e666 = leaves.member[_e557];
                                    if (_e125 == 0u) {
                                        phi_1309_ = ((select((_e666.x == _e662.x), true, (_e666.x == _e662.x)) || select((_e666.y == _e662.x), true, (_e666.y == _e662.x))) || select((_e666.z == _e662.x), true, (_e666.z == _e662.x)));
                                    } else {
                                        phi_1309_ = (select((_e666.x == _e662.y), true, (_e666.x == _e662.x)) || select((_e666.y == _e662.y), true, (_e666.y == _e662.x)));
                                    }
                                    let _e690 = phi_1309_;
                                    let _e691 = !(_e690);
                                    if _e691 {
                                    } else {
                                        let _e693 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_1327_ = select(_e527, select(_e527, (_e527 | (1u << bitcast<u32>((_e541 & 31u)))), _e659), _e691);
                                } else {
                                    phi_1327_ = _e527;
                                }
                                let _e701 = phi_1327_;
                                phi_1328_ = _e701;
                                phi_1329_ = true;
                            }
                            let _e703 = phi_1328_;
                            let _e705 = phi_1329_;
                            phi_1028_ = _e703;
                            phi_1330_ = _e705;
                        } else {
                            phi_1028_ = u32();
                            phi_1330_ = false;
                        }
                        let _e707 = phi_1028_;
                        let _e709 = phi_1330_;
                        continue;
                        continuing {
                            phi_1024_ = type_9(select(_e525.member, (_e525.member + 1u), _e530), select(_e525.member_1, _e525.member_1, _e530));
                            phi_1027_ = _e707;
                            break if !(_e709);
                        }
                    }
                    let _e713 = params.member.member_1.member_3;
                    let _e715 = local_2;
                    let _e718 = atomicAdd((&counters[5u]), countOneBits(_e715));
                    workgroupBarrier();
                    if (_e50 == 0u) {
                        let _e721 = atomicLoad((&counters[5u]));
                        if (_e721 > 0u) {
                            let _e725 = params.member.member.member_1;
                            if ((_e725 & 1024u) != 0u) {
                                let _e735 = atomicAdd((&output.member[0u]), _e721);
                                let _e736 = (_e735 + _e721);
                                let _e738 = select(_e736, 4294967295u, (_e736 < _e735));
                                let _e741 = params.member.member_1.member_3;
                                if (_e738 > _e741) {
                                    let _e744 = atomicMax((&output.member[2u]), _e738);
                                }
                                phi_1389_ = _e735;
                            } else {
                                let _e729 = atomicAdd((&output.member[0u]), _e721);
                                if ((_e729 + _e721) < _e729) {
                                    let _e733 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1389_ = _e729;
                            }
                            let _e746 = phi_1389_;
                            atomicStore((&counters[6u]), _e746);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e750 = atomicLoad((&counters[6u]));
                    let _e752 = (_e523 / 128u);
                    phi_1413_ = type_9(0u, select(_e752, (_e752 + 1u), ((_e523 % 128u) > 0u)));
                    phi_1416_ = (_e718 + _e750);
                    loop {
                        let _e759 = phi_1413_;
                        let _e761 = phi_1416_;
                        let _e764 = (_e759.member < _e759.member_1);
                        let _e775 = select(type_9().member_1, _e759.member, _e764);
                        let _e777 = (bitcast<i32>(select(0u, 1u, _e764)) != 0i);
                        if _e777 {
                            let _e780 = local_3;
                            if (((_e780 >> bitcast<u32>((_e775 & 31u))) & 1u) == 1u) {
                                let _e788 = hits[(_e50 + (_e775 * 128u))];
                                let _e791 = rows[(_e788 / 4096u)];
                                let _e797 = names[(_e788 % 128u)];
                                let _e799 = leaves.member[(_e791 + ((_e788 / 128u) % 32u))];
                                let _e802 = leaves.member[_e797];
                                if (_e125 == 1u) {
                                    let _e806 = (_e799.w < _e802.w);
                                    phi_1505_ = type_9(select(_e802.w, _e799.w, _e806), select(_e799.w, _e802.w, _e806));
                                } else {
                                    phi_1505_ = type_9(_e799.w, _e802.w);
                                }
                                let _e811 = phi_1505_;
                                if (_e761 < _e713) {
                                    let _e815 = (2u * _e761);
                                    atomicStore((&output.member[(4u + _e815)]), _e811.member);
                                    atomicStore((&output.member[(_e815 + 5u)]), _e811.member_1);
                                }
                                phi_1520_ = (_e761 + 1u);
                            } else {
                                phi_1520_ = _e761;
                            }
                            let _e822 = phi_1520_;
                            phi_1417_ = _e822;
                        } else {
                            phi_1417_ = u32();
                        }
                        let _e824 = phi_1417_;
                        continue;
                        continuing {
                            phi_1413_ = type_9(select(_e759.member, (_e759.member + 1u), _e764), select(_e759.member_1, _e759.member_1, _e764));
                            phi_1416_ = _e824;
                            break if !(_e777);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_858_ = type_9(select(_e427.member, (_e427.member + 1u), _e430), select(_e427.member_1, _e427.member_1, _e430));
                    break if !(_e443);
                }
            }
            phi_311_ = (_e139 + (_e49.x * _e49.y));
        } else {
            phi_311_ = u32();
        }
        let _e828 = phi_311_;
        continue;
        continuing {
            phi_310_ = _e828;
            break if !(_e145);
        }
    }
    if (_e50 == 0u) {
        let _e832 = atomicLoad((&counters[7u]));
        if (_e832 > 0u) {
            let _e835 = atomicAdd((&output.member[1u]), _e832);
            if ((_e835 + _e832) < _e835) {
                let _e839 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
