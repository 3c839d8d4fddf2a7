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

struct type_34 {
    member: array<vec4<f32>>,
}

struct type_38 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_25;
var<workgroup> columns: array<type_27, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(5) 
var<storage, read_write> output: type_38;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(2) 
var<storage> leaves: type_21;
@group(0) @binding(3) 
var<storage> ends: type_34;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_176_: u32;
    var phi_203_: u32;
    var phi_249_: u32;
    var phi_528_: bool;
    var phi_578_: type_9;
    var phi_581_: u32;
    var phi_582_: u32;
    var local: u32;
    var local_1: u32;
    var phi_915_: type_9;
    var phi_981_: type_9;
    var phi_984_: u32;
    var phi_986_: u32;
    var phi_988_: u32;
    var phi_985_: u32;
    var phi_987_: u32;
    var phi_989_: u32;
    var phi_1097_: type_9;
    var phi_1100_: u32;
    var phi_1317_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1416_: u32;
    var phi_1417_: u32;
    var phi_1418_: bool;
    var phi_1101_: u32;
    var phi_1419_: bool;
    var local_2: u32;
    var phi_1478_: u32;
    var phi_1502_: type_9;
    var phi_1505_: u32;
    var local_3: u32;
    var phi_1603_: type_9;
    var phi_1618_: u32;
    var phi_1506_: u32;
    var phi_250_: u32;
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
        phi_176_ = (_e71 - _e78);
    } else {
        phi_176_ = 0u;
    }
    let _e81 = phi_176_;
    let _e84 = params.member.member_2.member_3;
    if (_e84 == 1u) {
        phi_203_ = _e81;
    } else {
        let _e88 = params.member.member_2.member_3;
        if (_e88 == 0u) {
            return;
        }
        let _e90 = (_e81 / _e88);
        if (_e88 == 0u) {
            return;
        }
        phi_203_ = select(_e90, (_e90 + 1u), ((_e81 % _e88) > 0u));
    }
    let _e97 = phi_203_;
    let _e100 = params.member.member_2.member_4;
    let _e102 = select(_e97, _e100, (_e100 < _e97));
    let _e104 = params.member.member;
    let _e107 = params.member.member_2.member_1;
    let _e117 = (((_e104.member_5 + (2f * _e104.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e50 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_249_ = ((_e48.y * _e49.x) + _e48.x);
    loop {
        let _e121 = phi_249_;
        let _e122 = (_e102 / 4u);
        let _e127 = (_e121 < select(_e122, (_e122 + 1u), ((_e102 % 4u) > 0u)));
        if _e127 {
            let _e130 = ((_e121 * 4u) + (_e50 / 32u));
            let _e131 = (_e130 < _e102);
            let _e134 = params.member.member_1.member_1;
            let _e137 = params.member.member_2.member_3;
            let _e141 = (2u * (_e134 + select(0u, (_e130 * _e137), _e131)));
            let _e144 = input.member[(4u + _e141)];
            let _e147 = input.member[(_e141 + 5u)];
            if (_e50 <= 5u) {
                atomicStore((&counters[_e50]), 0u);
            }
            workgroupBarrier();
            let _e150 = (_e107 == 0u);
            if ((_e50 % 32u) == 0u) {
                let _e156 = (_e50 / 32u);
                let _e162 = params.member.member_2.member[0u][select(1u, 0u, _e150)];
                firsts[(2u * _e156)] = (_e162 + (_e144 * 32u));
                let _e171 = params.member.member_2.member[0u][select(1u, 2u, _e150)];
                firsts[((2u * _e156) + 1u)] = (_e171 + (_e147 * 32u));
            }
            let _e176 = select(false, (_e144 == _e147), (_e107 == 1u));
            let _e179 = params.member.member_2.member_1;
            let _e180 = (_e179 == 0u);
            let _e181 = select(1u, 0u, _e180);
            let _e183 = (_e50 / 32u);
            let _e184 = (_e50 % 32u);
            let _e188 = params.member.member_2.member[1u][_e181];
            let _e191 = nodes.member[(_e188 + _e144)];
            let _e209 = params.member.member_2.member[0u][_e181];
            let _e212 = nodes.member[(_e209 + ((_e144 * 32u) + _e184))];
            let _e230 = params.member.member_2.member[0u][select(1u, 2u, _e180)];
            let _e233 = nodes.member[(_e230 + ((_e147 * 32u) + _e184))];
            if _e131 {
                if _e176 {
                    phi_528_ = true;
                } else {
                    phi_528_ = ((((((_e233.member.x <= _e191.member_1.y) && (_e191.member.x <= _e233.member_1.y)) && (_e233.member.y <= _e191.member_2.x)) && (_e191.member.y <= _e233.member_2.x)) && (_e233.member_1.x <= _e191.member_2.y)) && (_e191.member_1.x <= _e233.member_2.y));
                }
                let _e258 = phi_528_;
                if _e258 {
                    let _e260 = atomicAdd((&counters[_e183]), 1u);
                    let _e263 = ((_e183 * 32u) + select(_e260, _e184, _e176));
                    columns[_e263] = type_27(array<f32, 3>(_e233.member.x, _e233.member.y, _e233.member_1.x), array<f32, 3>(_e233.member_1.y, _e233.member_2.x, _e233.member_2.y));
                    names[_e263] = _e184;
                }
            }
            workgroupBarrier();
            let _e269 = (_e50 / 32u);
            let _e271 = (_e269 * 32u);
            let _e273 = atomicLoad((&counters[_e269]));
            let _e274 = (_e273 / 4u);
            phi_578_ = type_9(0u, select(_e274, (_e274 + 1u), ((_e273 % 4u) > 0u)));
            phi_581_ = 0u;
            loop {
                let _e281 = phi_578_;
                let _e283 = phi_581_;
                local = _e283;
                local_1 = _e283;
                let _e286 = (_e281.member < _e281.member_1);
                let _e299 = (bitcast<i32>(select(0u, 1u, _e286)) != 0i);
                if _e299 {
                    let _e300 = (4u * select(type_9().member_1, _e281.member, _e286));
                    let _e303 = columns[(_e271 + _e300)];
                    let _e327 = columns[((_e271 + _e300) + 1u)];
                    let _e354 = columns[((_e271 + _e300) + 2u)];
                    let _e381 = columns[((_e271 + _e300) + 3u)];
                    phi_582_ = (_e283 | ((((select(0u, 1u, ((((((_e212.member.x <= _e303.member_1[0]) && (_e303.member[0] <= _e212.member_1.y)) && (_e212.member.y <= _e303.member_1[1])) && (_e303.member[1] <= _e212.member_2.x)) && (_e212.member_1.x <= _e303.member_1[2])) && (_e303.member[2] <= _e212.member_2.y))) | (select(0u, 1u, ((((((_e212.member.x <= _e327.member_1[0]) && (_e327.member[0] <= _e212.member_1.y)) && (_e212.member.y <= _e327.member_1[1])) && (_e327.member[1] <= _e212.member_2.x)) && (_e212.member_1.x <= _e327.member_1[2])) && (_e327.member[2] <= _e212.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e212.member.x <= _e354.member_1[0]) && (_e354.member[0] <= _e212.member_1.y)) && (_e212.member.y <= _e354.member_1[1])) && (_e354.member[1] <= _e212.member_2.x)) && (_e212.member_1.x <= _e354.member_1[2])) && (_e354.member[2] <= _e212.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e212.member.x <= _e381.member_1[0]) && (_e381.member[0] <= _e212.member_1.y)) && (_e212.member.y <= _e381.member_1[1])) && (_e381.member[1] <= _e212.member_2.x)) && (_e212.member_1.x <= _e381.member_1[2])) && (_e381.member[2] <= _e212.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e300 & 31u))));
                } else {
                    phi_582_ = u32();
                }
                let _e410 = phi_582_;
                continue;
                continuing {
                    phi_578_ = type_9(select(_e281.member, (_e281.member + 1u), _e286), select(_e281.member_1, _e281.member_1, _e286));
                    phi_581_ = _e410;
                    break if !(_e299);
                }
            }
            let _e418 = local;
            let _e421 = local_1;
            let _e422 = select(_e421, (_e418 & ((1u << bitcast<u32>((_e273 & 31u))) - 1u)), (_e273 < 32u));
            let _e427 = select(_e422, (_e422 & (4294967294u << bitcast<u32>(((_e50 % 32u) & 31u)))), _e176);
            let _e431 = atomicAdd((&counters[4u]), countOneBits(_e427));
            workgroupBarrier();
            if (_e50 == 0u) {
                let _e434 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e434;
            }
            let _e437 = workgroupUniformLoad((&n_hits[0u]));
            let _e438 = (_e437 / 512u);
            if (_e50 == 0u) {
                let _e445 = atomicLoad((&counters[7u]));
                let _e447 = n_hits[0u];
                atomicStore((&counters[7u]), (_e445 + _e447));
            }
            phi_915_ = type_9(0u, select(_e438, (_e438 + 1u), ((_e437 % 512u) > 0u)));
            loop {
                let _e452 = phi_915_;
                let _e455 = (_e452.member < _e452.member_1);
                let _e468 = (bitcast<i32>(select(0u, 1u, _e455)) != 0i);
                if _e468 {
                    let _e469 = (_e50 / 32u);
                    let _e471 = (select(type_9().member_1, _e452.member, _e455) * 512u);
                    if (_e427 == 0u) {
                    } else {
                        let _e480 = atomicLoad((&counters[_e469]));
                        let _e481 = (_e480 / 4u);
                        phi_981_ = type_9(0u, select(_e481, (_e481 + 1u), ((_e480 % 4u) > 0u)));
                        phi_984_ = (_e431 - _e471);
                        phi_986_ = ((_e469 << bitcast<u32>(10i)) | ((_e50 % 32u) << bitcast<u32>(5i)));
                        phi_988_ = _e427;
                        loop {
                            let _e488 = phi_981_;
                            let _e490 = phi_984_;
                            let _e492 = phi_986_;
                            let _e494 = phi_988_;
                            let _e497 = (_e488.member < _e488.member_1);
                            let _e508 = (bitcast<i32>(select(0u, 1u, _e497)) != 0i);
                            if _e508 {
                                let _e509 = (_e494 & 1u);
                                if (_e509 == 0u) {
                                } else {
                                    if (_e490 < 512u) {
                                        hits[_e490] = _e492;
                                    }
                                }
                                let _e515 = select((_e490 + 1u), _e490, (_e509 == 0u));
                                let _e516 = (_e494 & 2u);
                                if (_e516 == 0u) {
                                } else {
                                    if (_e515 < 512u) {
                                        hits[_e515] = (_e492 + 1u);
                                    }
                                }
                                let _e523 = select((_e515 + 1u), _e515, (_e516 == 0u));
                                let _e524 = (_e494 & 4u);
                                if (_e524 == 0u) {
                                } else {
                                    if (_e523 < 512u) {
                                        hits[_e523] = (_e492 + 2u);
                                    }
                                }
                                let _e531 = select((_e523 + 1u), _e523, (_e524 == 0u));
                                let _e532 = (_e494 & 8u);
                                if (_e532 == 0u) {
                                } else {
                                    if (_e531 < 512u) {
                                        hits[_e531] = (_e492 + 3u);
                                    }
                                }
                                phi_985_ = select((_e531 + 1u), _e531, (_e532 == 0u));
                                phi_987_ = (_e492 + 4u);
                                phi_989_ = (_e494 >> bitcast<u32>(4i));
                            } else {
                                phi_985_ = u32();
                                phi_987_ = u32();
                                phi_989_ = u32();
                            }
                            let _e544 = phi_985_;
                            let _e546 = phi_987_;
                            let _e548 = phi_989_;
                            continue;
                            continuing {
                                phi_981_ = type_9(select(_e488.member, (_e488.member + 1u), _e497), select(_e488.member_1, _e488.member_1, _e497));
                                phi_984_ = _e544;
                                phi_986_ = _e546;
                                phi_988_ = _e548;
                                break if !(_e508);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e551 = n_hits[0u];
                    let _e552 = (_e551 - _e471);
                    let _e554 = select(_e552, 512u, (512u < _e552));
                    phi_1097_ = type_9(0u, 4u);
                    phi_1100_ = 0u;
                    loop {
                        let _e556 = phi_1097_;
                        let _e558 = phi_1100_;
                        local_2 = _e558;
                        local_3 = _e558;
                        let _e561 = (_e556.member < _e556.member_1);
                        let _e572 = select(type_9().member_1, _e556.member, _e561);
                        if (bitcast<i32>(select(0u, 1u, _e561)) != 0i) {
                            let _e576 = (_e50 + (_e572 * 128u));
                            if (_e576 >= _e554) {
                                phi_1417_ = u32();
                                phi_1418_ = false;
                            } else {
                                let _e579 = hits[_e576];
                                let _e582 = ((_e579 >> bitcast<u32>(10i)) & 3u);
                                let _e590 = names[((_e582 * 32u) + (_e579 & 31u))];
                                let _e593 = firsts[(2u * _e582)];
                                let _e594 = (_e593 + ((_e579 >> bitcast<u32>(5i)) & 31u));
                                let _e598 = firsts[((2u * _e582) + 1u)];
                                let _e599 = (_e598 + _e590);
                                if ((_e104.member_1 & 512u) != 0u) {
                                    let _e605 = ends.member[(((_e594 / 32u) * 96u) + (_e594 % 32u))];
                                    let _e613 = ends.member[(((((_e594 / 32u) * 3u) + 1u) * 32u) + (_e594 % 32u))];
                                    let _e629 = ends.member[(((((_e594 / 32u) * 3u) + 2u) * 32u) + (_e594 % 32u))];
                                    let _e639 = ends.member[(((_e599 / 32u) * 96u) + (_e599 % 32u))];
                                    let _e647 = ends.member[(((((_e599 / 32u) * 3u) + 1u) * 32u) + (_e599 % 32u))];
                                    let _e663 = ends.member[(((((_e599 / 32u) * 3u) + 2u) * 32u) + (_e599 % 32u))];
                                    phi_1317_ = !(((((((_e605.x - _e639.w) > _e117) && ((_e613.z - _e663.y) > _e117)) || (((_e639.x - _e605.w) > _e117) && ((_e647.z - _e629.y) > _e117))) || ((((_e605.y - _e647.x) > _e117) && ((_e613.w - _e663.z) > _e117)) || (((_e639.y - _e613.x) > _e117) && ((_e647.w - _e629.z) > _e117)))) || ((((_e605.z - _e647.y) > _e117) && ((_e629.x - _e663.w) > _e117)) || (((_e639.z - _e613.y) > _e117) && ((_e663.x - _e629.w) > _e117)))));
                                } else {
                                    phi_1317_ = true;
                                }
                                let _e705 = phi_1317_;
                                if select(false, true, _e705) {
                                    let _e708 = leaves.member[_e594];
                                    let _e712 = leaves.member[_e599];
                                    if ((_e104.member_1 & 1u) != 0u) {
                                        if (_e107 == 0u) {
                                            phi_1397_ = ((select((_e712.x == _e708.x), true, (_e712.x == _e708.x)) || select((_e712.y == _e708.x), true, (_e712.y == _e708.x))) || select((_e712.z == _e708.x), true, (_e712.z == _e708.x)));
                                        } else {
                                            phi_1397_ = (select((_e712.x == _e708.y), true, (_e712.x == _e708.x)) || select((_e712.y == _e708.y), true, (_e712.y == _e708.x)));
                                        }
                                        let _e739 = phi_1397_;
                                        phi_1398_ = _e739;
                                    } else {
                                        phi_1398_ = false;
                                    }
                                    let _e741 = phi_1398_;
                                    let _e742 = !(_e741);
                                    if _e742 {
                                    } else {
                                        let _e744 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_1416_ = select(_e558, select(_e558, (_e558 | (1u << bitcast<u32>((_e572 & 31u)))), _e705), _e742);
                                } else {
                                    phi_1416_ = _e558;
                                }
                                let _e752 = phi_1416_;
                                phi_1417_ = _e752;
                                phi_1418_ = true;
                            }
                            let _e754 = phi_1417_;
                            let _e756 = phi_1418_;
                            phi_1101_ = _e754;
                            phi_1419_ = _e756;
                        } else {
                            phi_1101_ = u32();
                            phi_1419_ = false;
                        }
                        let _e758 = phi_1101_;
                        let _e760 = phi_1419_;
                        continue;
                        continuing {
                            phi_1097_ = type_9(select(_e556.member, (_e556.member + 1u), _e561), select(_e556.member_1, _e556.member_1, _e561));
                            phi_1100_ = _e758;
                            break if !(_e760);
                        }
                    }
                    let _e764 = params.member.member_1.member_3;
                    let _e766 = local_2;
                    let _e769 = atomicAdd((&counters[5u]), countOneBits(_e766));
                    workgroupBarrier();
                    if (_e50 == 0u) {
                        let _e772 = atomicLoad((&counters[5u]));
                        if (_e772 > 0u) {
                            let _e776 = params.member.member.member_1;
                            if ((_e776 & 1024u) != 0u) {
                                let _e786 = atomicAdd((&output.member[0u]), _e772);
                                let _e787 = (_e786 + _e772);
                                let _e789 = select(_e787, 4294967295u, (_e787 < _e786));
                                let _e792 = params.member.member_1.member_3;
                                if (_e789 > _e792) {
                                    let _e795 = atomicMax((&output.member[2u]), _e789);
                                }
                                phi_1478_ = _e786;
                            } else {
                                let _e780 = atomicAdd((&output.member[0u]), _e772);
                                if ((_e780 + _e772) < _e780) {
                                    let _e784 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1478_ = _e780;
                            }
                            let _e797 = phi_1478_;
                            atomicStore((&counters[6u]), _e797);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e801 = atomicLoad((&counters[6u]));
                    let _e803 = (_e554 / 128u);
                    phi_1502_ = type_9(0u, select(_e803, (_e803 + 1u), ((_e554 % 128u) > 0u)));
                    phi_1505_ = (_e769 + _e801);
                    loop {
                        let _e810 = phi_1502_;
                        let _e812 = phi_1505_;
                        let _e815 = (_e810.member < _e810.member_1);
                        let _e826 = select(type_9().member_1, _e810.member, _e815);
                        let _e828 = (bitcast<i32>(select(0u, 1u, _e815)) != 0i);
                        if _e828 {
                            let _e831 = local_3;
                            if (((_e831 >> bitcast<u32>((_e826 & 31u))) & 1u) == 1u) {
                                let _e839 = hits[(_e50 + (_e826 * 128u))];
                                let _e842 = ((_e839 >> bitcast<u32>(10i)) & 3u);
                                let _e850 = names[((_e842 * 32u) + (_e839 & 31u))];
                                let _e853 = firsts[(2u * _e842)];
                                let _e858 = firsts[((2u * _e842) + 1u)];
                                let _e861 = leaves.member[(_e853 + ((_e839 >> bitcast<u32>(5i)) & 31u))];
                                let _e864 = leaves.member[(_e858 + _e850)];
                                if (_e107 == 1u) {
                                    let _e868 = (_e861.w < _e864.w);
                                    phi_1603_ = type_9(select(_e864.w, _e861.w, _e868), select(_e861.w, _e864.w, _e868));
                                } else {
                                    phi_1603_ = type_9(_e861.w, _e864.w);
                                }
                                let _e873 = phi_1603_;
                                if (_e812 < _e764) {
                                    let _e877 = (2u * _e812);
                                    atomicStore((&output.member[(4u + _e877)]), _e873.member);
                                    atomicStore((&output.member[(_e877 + 5u)]), _e873.member_1);
                                }
                                phi_1618_ = (_e812 + 1u);
                            } else {
                                phi_1618_ = _e812;
                            }
                            let _e884 = phi_1618_;
                            phi_1506_ = _e884;
                        } else {
                            phi_1506_ = u32();
                        }
                        let _e886 = phi_1506_;
                        continue;
                        continuing {
                            phi_1502_ = type_9(select(_e810.member, (_e810.member + 1u), _e815), select(_e810.member_1, _e810.member_1, _e815));
                            phi_1505_ = _e886;
                            break if !(_e828);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_915_ = type_9(select(_e452.member, (_e452.member + 1u), _e455), select(_e452.member_1, _e452.member_1, _e455));
                    break if !(_e468);
                }
            }
            phi_250_ = (_e121 + (_e49.x * _e49.y));
        } else {
            phi_250_ = u32();
        }
        let _e890 = phi_250_;
        continue;
        continuing {
            phi_249_ = _e890;
            break if !(_e127);
        }
    }
    if (_e50 == 0u) {
        let _e894 = atomicLoad((&counters[7u]));
        if (_e894 > 0u) {
            let _e897 = atomicAdd((&output.member[1u]), _e894);
            if ((_e897 + _e894) < _e897) {
                let _e901 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
