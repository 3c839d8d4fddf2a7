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
    var phi_177_: u32;
    var phi_204_: u32;
    var phi_250_: u32;
    var phi_558_: bool;
    var phi_596_: type_27;
    var phi_628_: type_9;
    var phi_631_: u32;
    var phi_632_: u32;
    var local: u32;
    var local_1: u32;
    var phi_949_: type_9;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_1022_: u32;
    var phi_1067_: type_9;
    var phi_1129_: type_9;
    var phi_1132_: u32;
    var phi_1133_: u32;
    var phi_1252_: type_9;
    var phi_1255_: u32;
    var phi_1472_: bool;
    var phi_1552_: bool;
    var phi_1553_: bool;
    var phi_1571_: u32;
    var phi_1572_: u32;
    var phi_1573_: bool;
    var phi_1256_: u32;
    var phi_1574_: bool;
    var local_2: u32;
    var phi_1633_: u32;
    var phi_1641_: type_9;
    var phi_1644_: u32;
    var local_3: u32;
    var phi_1742_: type_9;
    var phi_1757_: u32;
    var phi_1645_: u32;
    var phi_251_: u32;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e63 = params.member.member_1.member_2;
    let _e65 = input.member[0u];
    let _e67 = select(_e65, _e63, (_e63 < _e65));
    let _e70 = params.member.member_1.member_1;
    if (_e67 > _e70) {
        let _e74 = params.member.member_1.member_1;
        phi_177_ = (_e67 - _e74);
    } else {
        phi_177_ = 0u;
    }
    let _e77 = phi_177_;
    let _e80 = params.member.member_2.member_3;
    if (_e80 == 1u) {
        phi_204_ = _e77;
    } else {
        let _e84 = params.member.member_2.member_3;
        if (_e84 == 0u) {
            return;
        }
        let _e86 = (_e77 / _e84);
        if (_e84 == 0u) {
            return;
        }
        phi_204_ = select(_e86, (_e86 + 1u), ((_e77 % _e84) > 0u));
    }
    let _e93 = phi_204_;
    let _e96 = params.member.member_2.member_4;
    let _e98 = select(_e93, _e96, (_e96 < _e93));
    let _e100 = params.member.member;
    let _e103 = params.member.member_2.member_1;
    let _e113 = (((_e100.member_5 + (2f * _e100.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e46 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_250_ = ((_e44.y * _e45.x) + _e44.x);
    loop {
        let _e117 = phi_250_;
        let _e118 = (_e98 / 4u);
        let _e123 = (_e117 < select(_e118, (_e118 + 1u), ((_e98 % 4u) > 0u)));
        if _e123 {
            let _e126 = ((_e117 * 4u) + (_e46 / 32u));
            let _e127 = (_e126 < _e98);
            let _e130 = params.member.member_1.member_1;
            let _e133 = params.member.member_2.member_3;
            let _e137 = (2u * (_e130 + select(0u, (_e126 * _e133), _e127)));
            let _e140 = input.member[(4u + _e137)];
            let _e143 = input.member[(_e137 + 5u)];
            if (_e46 <= 5u) {
                atomicStore((&counters[_e46]), 0u);
            }
            workgroupBarrier();
            let _e146 = (_e103 == 0u);
            if ((_e46 % 32u) == 0u) {
                let _e152 = (_e46 / 32u);
                let _e158 = params.member.member_2.member[0u][select(1u, 0u, _e146)];
                firsts[(2u * _e152)] = (_e158 + (_e140 * 32u));
                let _e167 = params.member.member_2.member[0u][select(1u, 2u, _e146)];
                firsts[((2u * _e152) + 1u)] = (_e167 + (_e143 * 32u));
            }
            let _e172 = params.member.member_2.member_1;
            let _e173 = (_e172 == 0u);
            let _e174 = select(1u, 0u, _e173);
            let _e175 = select(1u, 2u, _e173);
            let _e176 = (_e46 / 32u);
            let _e177 = (_e46 % 32u);
            let _e179 = params.member.member_2.member_2;
            let _e183 = params.member.member_2.member[_e179][_e174];
            let _e186 = nodes.member[(_e183 + _e140)];
            let _e200 = params.member.member_2.member_2;
            let _e204 = params.member.member_2.member[_e200][_e175];
            let _e207 = nodes.member[(_e204 + _e143)];
            let _e221 = params.member.member_2.member_2;
            let _e228 = params.member.member_2.member[(_e221 - 1u)][_e174];
            let _e231 = nodes.member[(_e228 + ((_e140 * 32u) + _e177))];
            let _e248 = params.member.member_2.member_2;
            let _e255 = params.member.member_2.member[(_e248 - 1u)][_e175];
            let _e258 = nodes.member[(_e255 + ((_e143 * 32u) + _e177))];
            if _e127 {
                phi_558_ = ((((((_e231.member.x <= _e207.member_1.y) && (_e207.member.x <= _e231.member_1.y)) && (_e231.member.y <= _e207.member_2.x)) && (_e207.member.y <= _e231.member_2.x)) && (_e231.member_1.x <= _e207.member_2.y)) && (_e207.member_1.x <= _e231.member_2.y));
            } else {
                phi_558_ = false;
            }
            let _e283 = phi_558_;
            if _e127 {
                if ((((((_e258.member.x <= _e186.member_1.y) && (_e186.member.x <= _e258.member_1.y)) && (_e258.member.y <= _e186.member_2.x)) && (_e186.member.y <= _e258.member_2.x)) && (_e258.member_1.x <= _e186.member_2.y)) && (_e186.member_1.x <= _e258.member_2.y)) {
                    let _e297 = atomicAdd((&counters[_e176]), 1u);
                    let _e298 = ((_e176 * 32u) + _e297);
                    columns[_e298] = type_27(array<f32, 3>(_e258.member.x, _e258.member.y, _e258.member_1.x), array<f32, 3>(_e258.member_1.y, _e258.member_2.x, _e258.member_2.y));
                    names[_e298] = _e177;
                }
            }
            if _e283 {
                phi_596_ = type_27(array<f32, 3>(_e231.member.x, _e231.member.y, _e231.member_1.x), array<f32, 3>(_e231.member_1.y, _e231.member_2.x, _e231.member_2.y));
            } else {
                phi_596_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e305 = phi_596_;
            workgroupBarrier();
            let _e308 = select(false, (_e140 == _e143), (_e103 == 1u));
            let _e309 = (_e46 / 32u);
            let _e311 = (_e309 * 32u);
            let _e313 = atomicLoad((&counters[_e309]));
            let _e314 = (_e313 / 4u);
            phi_628_ = type_9(0u, select(_e314, (_e314 + 1u), ((_e313 % 4u) > 0u)));
            phi_631_ = 0u;
            loop {
                let _e321 = phi_628_;
                let _e323 = phi_631_;
                local = _e323;
                local_1 = _e323;
                let _e326 = (_e321.member < _e321.member_1);
                let _e339 = (bitcast<i32>(select(0u, 1u, _e326)) != 0i);
                if _e339 {
                    let _e340 = (4u * select(type_9().member_1, _e321.member, _e326));
                    let _e343 = columns[(_e311 + _e340)];
                    let _e382 = columns[((_e311 + _e340) + 1u)];
                    let _e423 = columns[((_e311 + _e340) + 2u)];
                    let _e464 = columns[((_e311 + _e340) + 3u)];
                    phi_632_ = (_e323 | ((((select(0u, 1u, ((((((_e305.member[0] <= _e343.member_1[0]) && (_e343.member[0] <= _e305.member_1[0])) && (_e305.member[1] <= _e343.member_1[1])) && (_e343.member[1] <= _e305.member_1[1])) && (_e305.member[2] <= _e343.member_1[2])) && (_e343.member[2] <= _e305.member_1[2]))) << bitcast<u32>((_e340 & 31u))) | (select(0u, 1u, ((((((_e305.member[0] <= _e382.member_1[0]) && (_e382.member[0] <= _e305.member_1[0])) && (_e305.member[1] <= _e382.member_1[1])) && (_e382.member[1] <= _e305.member_1[1])) && (_e305.member[2] <= _e382.member_1[2])) && (_e382.member[2] <= _e305.member_1[2]))) << bitcast<u32>(((_e340 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e305.member[0] <= _e423.member_1[0]) && (_e423.member[0] <= _e305.member_1[0])) && (_e305.member[1] <= _e423.member_1[1])) && (_e423.member[1] <= _e305.member_1[1])) && (_e305.member[2] <= _e423.member_1[2])) && (_e423.member[2] <= _e305.member_1[2]))) << bitcast<u32>(((_e340 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e305.member[0] <= _e464.member_1[0]) && (_e464.member[0] <= _e305.member_1[0])) && (_e305.member[1] <= _e464.member_1[1])) && (_e464.member[1] <= _e305.member_1[1])) && (_e305.member[2] <= _e464.member_1[2])) && (_e464.member[2] <= _e305.member_1[2]))) << bitcast<u32>(((_e340 + 3u) & 31u)))));
                } else {
                    phi_632_ = u32();
                }
                let _e504 = phi_632_;
                continue;
                continuing {
                    phi_628_ = type_9(select(_e321.member, (_e321.member + 1u), _e326), select(_e321.member_1, _e321.member_1, _e326));
                    phi_631_ = _e504;
                    break if !(_e339);
                }
            }
            let _e512 = local;
            let _e515 = local_1;
            let _e516 = select(_e515, (_e512 & ((1u << bitcast<u32>((_e313 & 31u))) - 1u)), (_e313 < 32u));
            if _e308 {
                phi_949_ = type_9(0u, _e313);
                phi_952_ = _e516;
                loop {
                    let _e519 = phi_949_;
                    let _e521 = phi_952_;
                    local_4 = _e521;
                    let _e524 = (_e519.member < _e519.member_1);
                    let _e535 = select(type_9().member_1, _e519.member, _e524);
                    let _e537 = (bitcast<i32>(select(0u, 1u, _e524)) != 0i);
                    if _e537 {
                        let _e540 = names[(_e311 + _e535)];
                        let _e541 = ((_e46 % 32u) < _e540);
                        phi_953_ = select(_e521, (_e521 & ~((1u << bitcast<u32>((_e535 & 31u))))), select(true, false, select(select(bool(), select(false, bool(), _e541), _e308), true, select(true, _e541, _e308))));
                    } else {
                        phi_953_ = u32();
                    }
                    let _e554 = phi_953_;
                    continue;
                    continuing {
                        phi_949_ = type_9(select(_e519.member, (_e519.member + 1u), _e524), select(_e519.member_1, _e519.member_1, _e524));
                        phi_952_ = _e554;
                        break if !(_e537);
                    }
                }
                let _e1047 = local_4;
                phi_1022_ = _e1047;
            } else {
                phi_1022_ = _e516;
            }
            let _e557 = phi_1022_;
            let _e561 = atomicAdd((&counters[4u]), countOneBits(_e557));
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e564 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e564;
            }
            let _e567 = workgroupUniformLoad((&n_hits[0u]));
            let _e568 = (_e567 / 512u);
            if (_e46 == 0u) {
                let _e575 = atomicLoad((&counters[7u]));
                let _e577 = n_hits[0u];
                atomicStore((&counters[7u]), (_e575 + _e577));
            }
            phi_1067_ = type_9(0u, select(_e568, (_e568 + 1u), ((_e567 % 512u) > 0u)));
            loop {
                let _e582 = phi_1067_;
                let _e585 = (_e582.member < _e582.member_1);
                let _e598 = (bitcast<i32>(select(0u, 1u, _e585)) != 0i);
                if _e598 {
                    let _e599 = (_e46 / 32u);
                    let _e605 = ((_e599 << bitcast<u32>(10i)) | ((_e46 % 32u) << bitcast<u32>(5i)));
                    let _e606 = (select(type_9().member_1, _e582.member, _e585) * 512u);
                    let _e609 = atomicLoad((&counters[_e599]));
                    let _e610 = (_e609 / 4u);
                    phi_1129_ = type_9(0u, select(_e610, (_e610 + 1u), ((_e609 % 4u) > 0u)));
                    phi_1132_ = (_e561 - _e606);
                    loop {
                        let _e617 = phi_1129_;
                        let _e619 = phi_1132_;
                        let _e622 = (_e617.member < _e617.member_1);
                        let _e635 = (bitcast<i32>(select(0u, 1u, _e622)) != 0i);
                        if _e635 {
                            let _e636 = (4u * select(type_9().member_1, _e617.member, _e622));
                            let _e642 = (((_e557 >> bitcast<u32>((_e636 & 31u))) & 1u) == 1u);
                            if _e642 {
                                if (_e619 < 512u) {
                                    hits[_e619] = (_e605 + _e636);
                                }
                            }
                            let _e646 = select(_e619, (_e619 + 1u), _e642);
                            let _e654 = (((_e557 >> bitcast<u32>(((_e636 + 1u) & 31u))) & 1u) == 1u);
                            if _e654 {
                                if (_e646 < 512u) {
                                    hits[_e646] = ((_e605 + _e636) + 1u);
                                }
                            }
                            let _e658 = select(_e646, (_e646 + 1u), _e654);
                            let _e666 = (((_e557 >> bitcast<u32>(((_e636 + 2u) & 31u))) & 1u) == 1u);
                            if _e666 {
                                if (_e658 < 512u) {
                                    hits[_e658] = ((_e605 + _e636) + 2u);
                                }
                            }
                            let _e670 = select(_e658, (_e658 + 1u), _e666);
                            let _e678 = (((_e557 >> bitcast<u32>(((_e636 + 3u) & 31u))) & 1u) == 1u);
                            if _e678 {
                                if (_e670 < 512u) {
                                    hits[_e670] = ((_e605 + _e636) + 3u);
                                }
                            }
                            phi_1133_ = select(_e670, (_e670 + 1u), _e678);
                        } else {
                            phi_1133_ = u32();
                        }
                        let _e684 = phi_1133_;
                        continue;
                        continuing {
                            phi_1129_ = type_9(select(_e617.member, (_e617.member + 1u), _e622), select(_e617.member_1, _e617.member_1, _e622));
                            phi_1132_ = _e684;
                            break if !(_e635);
                        }
                    }
                    workgroupBarrier();
                    let _e687 = n_hits[0u];
                    let _e688 = (_e687 - _e606);
                    phi_1252_ = type_9(0u, 4u);
                    phi_1255_ = 0u;
                    loop {
                        let _e692 = phi_1252_;
                        let _e694 = phi_1255_;
                        local_2 = _e694;
                        local_3 = _e694;
                        let _e697 = (_e692.member < _e692.member_1);
                        let _e708 = select(type_9().member_1, _e692.member, _e697);
                        if (bitcast<i32>(select(0u, 1u, _e697)) != 0i) {
                            let _e712 = (_e46 + (_e708 * 128u));
                            if (_e712 >= select(_e688, 512u, (512u < _e688))) {
                                phi_1572_ = u32();
                                phi_1573_ = false;
                            } else {
                                let _e715 = hits[_e712];
                                let _e718 = ((_e715 >> bitcast<u32>(10i)) & 3u);
                                let _e726 = names[((_e718 * 32u) + (_e715 & 31u))];
                                let _e729 = firsts[(2u * _e718)];
                                let _e730 = (_e729 + ((_e715 >> bitcast<u32>(5i)) & 31u));
                                let _e734 = firsts[((2u * _e718) + 1u)];
                                let _e735 = (_e734 + _e726);
                                if ((_e100.member_1 & 512u) != 0u) {
                                    let _e741 = ends.member[(((_e730 / 32u) * 96u) + (_e730 % 32u))];
                                    let _e749 = ends.member[(((((_e730 / 32u) * 3u) + 1u) * 32u) + (_e730 % 32u))];
                                    let _e765 = ends.member[(((((_e730 / 32u) * 3u) + 2u) * 32u) + (_e730 % 32u))];
                                    let _e775 = ends.member[(((_e735 / 32u) * 96u) + (_e735 % 32u))];
                                    let _e783 = ends.member[(((((_e735 / 32u) * 3u) + 1u) * 32u) + (_e735 % 32u))];
                                    let _e799 = ends.member[(((((_e735 / 32u) * 3u) + 2u) * 32u) + (_e735 % 32u))];
                                    phi_1472_ = !(((((((_e741.x - _e775.w) > _e113) && ((_e749.z - _e799.y) > _e113)) || (((_e775.x - _e741.w) > _e113) && ((_e783.z - _e765.y) > _e113))) || ((((_e741.y - _e783.x) > _e113) && ((_e749.w - _e799.z) > _e113)) || (((_e775.y - _e749.x) > _e113) && ((_e783.w - _e765.z) > _e113)))) || ((((_e741.z - _e783.y) > _e113) && ((_e765.x - _e799.w) > _e113)) || (((_e775.z - _e749.y) > _e113) && ((_e799.x - _e765.w) > _e113)))));
                                } else {
                                    phi_1472_ = true;
                                }
                                let _e841 = phi_1472_;
                                if select(false, true, _e841) {
                                    let _e844 = leaves.member[_e730];
                                    let _e848 = leaves.member[_e735];
                                    if ((_e100.member_1 & 1u) != 0u) {
                                        if (_e103 == 0u) {
                                            phi_1552_ = ((select((_e848.x == _e844.x), true, (_e848.x == _e844.x)) || select((_e848.y == _e844.x), true, (_e848.y == _e844.x))) || select((_e848.z == _e844.x), true, (_e848.z == _e844.x)));
                                        } else {
                                            phi_1552_ = (select((_e848.x == _e844.y), true, (_e848.x == _e844.x)) || select((_e848.y == _e844.y), true, (_e848.y == _e844.x)));
                                        }
                                        let _e875 = phi_1552_;
                                        phi_1553_ = _e875;
                                    } else {
                                        phi_1553_ = false;
                                    }
                                    let _e877 = phi_1553_;
                                    let _e878 = !(_e877);
                                    if _e878 {
                                    } else {
                                        let _e880 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_1571_ = select(_e694, select(_e694, (_e694 | (1u << bitcast<u32>((_e708 & 31u)))), _e841), _e878);
                                } else {
                                    phi_1571_ = _e694;
                                }
                                let _e888 = phi_1571_;
                                phi_1572_ = _e888;
                                phi_1573_ = true;
                            }
                            let _e890 = phi_1572_;
                            let _e892 = phi_1573_;
                            phi_1256_ = _e890;
                            phi_1574_ = _e892;
                        } else {
                            phi_1256_ = u32();
                            phi_1574_ = false;
                        }
                        let _e894 = phi_1256_;
                        let _e896 = phi_1574_;
                        continue;
                        continuing {
                            phi_1252_ = type_9(select(_e692.member, (_e692.member + 1u), _e697), select(_e692.member_1, _e692.member_1, _e697));
                            phi_1255_ = _e894;
                            break if !(_e896);
                        }
                    }
                    let _e900 = params.member.member_1.member_3;
                    let _e902 = local_2;
                    let _e905 = atomicAdd((&counters[5u]), countOneBits(_e902));
                    workgroupBarrier();
                    if (_e46 == 0u) {
                        let _e908 = atomicLoad((&counters[5u]));
                        if (_e908 > 0u) {
                            let _e912 = params.member.member.member_1;
                            if ((_e912 & 1024u) != 0u) {
                                let _e922 = atomicAdd((&output.member[0u]), _e908);
                                let _e923 = (_e922 + _e908);
                                let _e925 = select(_e923, 4294967295u, (_e923 < _e922));
                                let _e928 = params.member.member_1.member_3;
                                if (_e925 > _e928) {
                                    let _e931 = atomicMax((&output.member[2u]), _e925);
                                }
                                phi_1633_ = _e922;
                            } else {
                                let _e916 = atomicAdd((&output.member[0u]), _e908);
                                if ((_e916 + _e908) < _e916) {
                                    let _e920 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1633_ = _e916;
                            }
                            let _e933 = phi_1633_;
                            atomicStore((&counters[6u]), _e933);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e937 = atomicLoad((&counters[6u]));
                    phi_1641_ = type_9(0u, 4u);
                    phi_1644_ = (_e905 + _e937);
                    loop {
                        let _e940 = phi_1641_;
                        let _e942 = phi_1644_;
                        let _e945 = (_e940.member < _e940.member_1);
                        let _e956 = select(type_9().member_1, _e940.member, _e945);
                        let _e958 = (bitcast<i32>(select(0u, 1u, _e945)) != 0i);
                        if _e958 {
                            let _e961 = local_3;
                            if (((_e961 >> bitcast<u32>((_e956 & 31u))) & 1u) == 1u) {
                                let _e969 = hits[(_e46 + (_e956 * 128u))];
                                let _e972 = ((_e969 >> bitcast<u32>(10i)) & 3u);
                                let _e980 = names[((_e972 * 32u) + (_e969 & 31u))];
                                let _e983 = firsts[(2u * _e972)];
                                let _e988 = firsts[((2u * _e972) + 1u)];
                                let _e991 = leaves.member[(_e983 + ((_e969 >> bitcast<u32>(5i)) & 31u))];
                                let _e994 = leaves.member[(_e988 + _e980)];
                                if (_e103 == 1u) {
                                    let _e998 = (_e991.w < _e994.w);
                                    phi_1742_ = type_9(select(_e994.w, _e991.w, _e998), select(_e991.w, _e994.w, _e998));
                                } else {
                                    phi_1742_ = type_9(_e991.w, _e994.w);
                                }
                                let _e1003 = phi_1742_;
                                if (_e942 < _e900) {
                                    let _e1007 = (2u * _e942);
                                    atomicStore((&output.member[(4u + _e1007)]), _e1003.member);
                                    atomicStore((&output.member[(_e1007 + 5u)]), _e1003.member_1);
                                }
                                phi_1757_ = (_e942 + 1u);
                            } else {
                                phi_1757_ = _e942;
                            }
                            let _e1014 = phi_1757_;
                            phi_1645_ = _e1014;
                        } else {
                            phi_1645_ = u32();
                        }
                        let _e1016 = phi_1645_;
                        continue;
                        continuing {
                            phi_1641_ = type_9(select(_e940.member, (_e940.member + 1u), _e945), select(_e940.member_1, _e940.member_1, _e945));
                            phi_1644_ = _e1016;
                            break if !(_e958);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1067_ = type_9(select(_e582.member, (_e582.member + 1u), _e585), select(_e582.member_1, _e582.member_1, _e585));
                    break if !(_e598);
                }
            }
            phi_251_ = (_e117 + (_e45.x * _e45.y));
        } else {
            phi_251_ = u32();
        }
        let _e1020 = phi_251_;
        continue;
        continuing {
            phi_250_ = _e1020;
            break if !(_e123);
        }
    }
    if (_e46 == 0u) {
        let _e1024 = atomicLoad((&counters[7u]));
        if (_e1024 > 0u) {
            let _e1027 = atomicAdd((&output.member[1u]), _e1024);
            if ((_e1027 + _e1024) < _e1027) {
                let _e1031 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
