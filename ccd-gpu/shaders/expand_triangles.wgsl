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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 2>,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: array<u32, 5>,
    member_1: u32,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 3>,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage> regions: type_11;
@group(0) @binding(5) 
var<storage, read_write> vf: type_28;
@group(0) @binding(6) 
var<storage, read_write> ee: type_28;
@group(0) @binding(7) 
var<storage, read_write> counts: type_28;
var<workgroup> shared_: array<atomic<u32>, 12>;
@group(0) @binding(1) 
var<storage> triangles: type_25;
@group(0) @binding(3) 
var<storage> boxes: type_18;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_160_: u32;
    var phi_210_: u32;
    var phi_213_: type_9;
    var phi_341_: bool;
    var phi_460_: bool;
    var phi_464_: bool;
    var phi_556_: bool;
    var phi_593_: bool;
    var phi_700_: u32;
    var phi_701_: u32;
    var phi_774_: u32;
    var phi_775_: u32;
    var phi_849_: u32;
    var phi_850_: u32;
    var phi_853_: u32;
    var phi_854_: u32;
    var phi_855_: u32;
    var phi_856_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_1028_: u32;
    var phi_1029_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1108_: u32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1159_: type_16;
    var phi_1181_: type_16;
    var phi_1203_: type_16;
    var phi_1233_: type_16;
    var phi_1376_: type_16;
    var phi_1521_: type_16;
    var phi_1648_: u32;
    var phi_1649_: u32;
    var phi_1650_: u32;
    var phi_1651_: u32;
    var phi_1654_: type_22;
    var phi_1655_: type_22;
    var phi_1656_: type_22;
    var phi_1657_: bool;
    var phi_1658_: type_22;
    var phi_1659_: type_22;
    var phi_1660_: bool;
    var phi_1661_: type_22;
    var phi_1662_: type_22;
    var phi_1663_: bool;
    var phi_1667_: type_22;
    var phi_1716_: u32;
    var phi_1717_: u32;
    var phi_1718_: u32;
    var phi_1719_: u32;
    var phi_1720_: u32;
    var phi_1721_: type_9;
    var phi_1776_: type_9;
    var phi_1779_: u32;
    var phi_1919_: type_9;
    var phi_1920_: type_9;
    var phi_1937_: u32;
    var phi_1780_: u32;
    var phi_1940_: type_9;
    var phi_1943_: u32;
    var phi_2083_: type_9;
    var phi_2084_: type_9;
    var phi_2099_: u32;
    var phi_1944_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e63 = ((_e48.y * _e49.x) + _e48.x);
    let _e66 = (_e49.x * _e49.y);
    let _e70 = params.member.member_2.member_1;
    let _e72 = params.member.member_1.member_2;
    let _e74 = input.member[0u];
    let _e76 = select(_e74, _e72, (_e72 < _e74));
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_160_ = (_e76 - _e81);
    } else {
        phi_160_ = 0u;
    }
    let _e84 = phi_160_;
    let _e86 = params.member.member_1.member;
    let _e88 = select(_e84, _e86, (_e86 < _e84));
    if (_e50 < 5u) {
        atomicStore((&shared_[_e50]), 0u);
    }
    workgroupBarrier();
    let _e91 = (_e88 / 128u);
    let _e95 = select(_e91, (_e91 + 1u), ((_e88 % 128u) > 0u));
    if (_e95 > _e63) {
        let _e97 = (_e95 - _e63);
        if (_e66 == 0u) {
            return;
        }
        let _e99 = (_e97 / _e66);
        if (_e66 == 0u) {
            return;
        }
        phi_210_ = select(_e99, (_e99 + 1u), ((_e97 % _e66) > 0u));
    } else {
        phi_210_ = 0u;
    }
    let _e106 = phi_210_;
    phi_213_ = type_9(0u, _e106);
    loop {
        let _e109 = phi_213_;
        let _e112 = (_e109.member < _e109.member_1);
        let _e125 = (bitcast<i32>(select(0u, 1u, _e112)) != 0i);
        if _e125 {
            let _e129 = (((_e63 + (select(type_9().member_1, _e109.member, _e112) * _e66)) * 128u) + _e50);
            if (_e50 == 0u) {
                atomicStore((&shared_[5u]), 0u);
                atomicStore((&shared_[6u]), 0u);
            }
            workgroupBarrier();
            if (_e129 < _e88) {
                let _e135 = params.member.member_1.member_1;
                let _e137 = (2u * (_e135 + _e129));
                let _e140 = input.member[(4u + _e137)];
                let _e143 = input.member[(_e137 + 5u)];
                let _e148 = triangles.member[_e140];
                let _e150 = triangles.member[_e143];
                let _e152 = params.member.member.member_1;
                if ((_e152 & 2u) != 0u) {
                    phi_341_ = select(false, (((_e148.member_3 & _e150.member_3) & 1u) == 0u), select(select(true, false, ((_e148.member_3 & 2u) == 0u)), true, ((_e148.member_3 / 4u) != (_e150.member_3 / 4u))));
                } else {
                    phi_341_ = true;
                }
                let _e169 = phi_341_;
                if _e169 {
                    let _e171 = params.member.member.member_1;
                    if ((_e171 & 4u) != 0u) {
                        let _e177 = params.member.member_2.member_4;
                        let _e179 = regions.member[_e177];
                        let _e182 = regions.member[(_e177 + 1u)];
                        let _e187 = ((_e177 + 4u) + (2u * (_e148.member_3 >> bitcast<u32>(2i))));
                        let _e192 = ((_e177 + 4u) + (2u * (_e150.member_3 >> bitcast<u32>(2i))));
                        let _e194 = regions.member[_e187];
                        let _e196 = regions.member[_e192];
                        let _e205 = regions.member[((((_e177 + 4u) + (2u * _e179)) + (_e194 * _e182)) + (_e196 / 32u))];
                        let _e208 = regions.member[(_e187 + 1u)];
                        let _e211 = regions.member[(_e192 + 1u)];
                        if (_e208 == _e211) {
                            phi_460_ = select(((_e148.member_3 >> bitcast<u32>(2i)) == (_e150.member_3 >> bitcast<u32>(2i))), true, (((_e205 >> bitcast<u32>(((_e196 % 32u) & 31u))) & 1u) == 1u));
                        } else {
                            phi_460_ = false;
                        }
                        let _e226 = phi_460_;
                        phi_464_ = _e226;
                    } else {
                        phi_464_ = true;
                    }
                    let _e228 = phi_464_;
                    if _e228 {
                        let _e230 = params.member.member_2.member;
                        if ((_e230 & 1u) != 0u) {
                            phi_556_ = select(true, false, ((((select((_e150.member[0] == _e148.member[0]), true, (_e150.member[0] == _e148.member[0])) || select((_e150.member[1] == _e148.member[0]), true, (_e150.member[1] == _e148.member[0]))) || select((_e150.member[2] == _e148.member[0]), true, (_e150.member[2] == _e148.member[0]))) || ((select((_e150.member[0] == _e148.member[1]), true, (_e150.member[0] == _e148.member[1])) || select((_e150.member[1] == _e148.member[1]), true, (_e150.member[1] == _e148.member[1]))) || select((_e150.member[2] == _e148.member[1]), true, (_e150.member[2] == _e148.member[1])))) || ((select((_e150.member[0] == _e148.member[2]), true, (_e150.member[0] == _e148.member[2])) || select((_e150.member[1] == _e148.member[2]), true, (_e150.member[1] == _e148.member[2]))) || select((_e150.member[2] == _e148.member[2]), true, (_e150.member[2] == _e148.member[2])))));
                        } else {
                            phi_556_ = true;
                        }
                        let _e288 = phi_556_;
                        if _e288 {
                            let _e290 = params.member.member_2.member;
                            if ((_e290 & 2u) != 0u) {
                                let _e294 = regions.member[_e140];
                                let _e296 = regions.member[_e143];
                                phi_593_ = select(false, (_e294 != 4294967295u), (_e294 == _e296));
                            } else {
                                phi_593_ = false;
                            }
                            let _e301 = phi_593_;
                            if _e301 {
                                phi_1654_ = type_22();
                            } else {
                                let _e304 = countOneBits((_e148.member_1 & 7u));
                                let _e307 = countOneBits((_e150.member_1 & 7u));
                                let _e310 = params.member.member.member[2u];
                                if (_e143 < _e310) {
                                    if (_e304 > 0u) {
                                        let _e315 = params.member.member.member_2[2u];
                                        let _e318 = boxes.member[(_e315 + _e143)];
                                        if ((_e148.member_1 & 1u) == 1u) {
                                            if ((select((_e150.member[0] == _e148.member[0]), true, (_e150.member[0] == _e148.member[0])) || select((_e150.member[1] == _e148.member[0]), true, (_e150.member[1] == _e148.member[0]))) || select((_e150.member[2] == _e148.member[0]), true, (_e150.member[2] == _e148.member[0]))) {
                                                phi_700_ = 0u;
                                            } else {
                                                let _e340 = boxes.member[_e148.member[0]];
                                                phi_700_ = select(0u, 1u, ((((((_e340.member[0] <= _e318.member_1[0]) && (_e318.member[0] <= _e340.member_1[0])) && (_e340.member[1] <= _e318.member_1[1])) && (_e318.member[1] <= _e340.member_1[1])) && (_e340.member[2] <= _e318.member_1[2])) && (_e318.member[2] <= _e340.member_1[2])));
                                            }
                                            let _e378 = phi_700_;
                                            phi_701_ = _e378;
                                        } else {
                                            phi_701_ = 0u;
                                        }
                                        let _e380 = phi_701_;
                                        if (((_e148.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                            if ((select((_e150.member[0] == _e148.member[1]), true, (_e150.member[0] == _e148.member[1])) || select((_e150.member[1] == _e148.member[1]), true, (_e150.member[1] == _e148.member[1]))) || select((_e150.member[2] == _e148.member[1]), true, (_e150.member[2] == _e148.member[1]))) {
                                                phi_774_ = 0u;
                                            } else {
                                                let _e404 = boxes.member[_e148.member[1]];
                                                phi_774_ = (select(0u, 1u, ((((((_e404.member[0] <= _e318.member_1[0]) && (_e318.member[0] <= _e404.member_1[0])) && (_e404.member[1] <= _e318.member_1[1])) && (_e318.member[1] <= _e404.member_1[1])) && (_e404.member[2] <= _e318.member_1[2])) && (_e318.member[2] <= _e404.member_1[2]))) << bitcast<u32>(1u));
                                            }
                                            let _e444 = phi_774_;
                                            phi_775_ = _e444;
                                        } else {
                                            phi_775_ = 0u;
                                        }
                                        let _e446 = phi_775_;
                                        if (((_e148.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                            if ((select((_e150.member[0] == _e148.member[2]), true, (_e150.member[0] == _e148.member[2])) || select((_e150.member[1] == _e148.member[2]), true, (_e150.member[1] == _e148.member[2]))) || select((_e150.member[2] == _e148.member[2]), true, (_e150.member[2] == _e148.member[2]))) {
                                                phi_849_ = 0u;
                                            } else {
                                                let _e471 = boxes.member[_e148.member[2]];
                                                phi_849_ = (select(0u, 1u, ((((((_e471.member[0] <= _e318.member_1[0]) && (_e318.member[0] <= _e471.member_1[0])) && (_e471.member[1] <= _e318.member_1[1])) && (_e318.member[1] <= _e471.member_1[1])) && (_e471.member[2] <= _e318.member_1[2])) && (_e318.member[2] <= _e471.member_1[2]))) << bitcast<u32>(2u));
                                            }
                                            let _e511 = phi_849_;
                                            phi_850_ = _e511;
                                        } else {
                                            phi_850_ = 0u;
                                        }
                                        let _e513 = phi_850_;
                                        phi_853_ = _e304;
                                        phi_854_ = ((_e380 | _e446) | _e513);
                                    } else {
                                        phi_853_ = 0u;
                                        phi_854_ = 0u;
                                    }
                                    let _e516 = phi_853_;
                                    let _e518 = phi_854_;
                                    phi_855_ = _e516;
                                    phi_856_ = _e518;
                                } else {
                                    phi_855_ = 0u;
                                    phi_856_ = 0u;
                                }
                                let _e520 = phi_855_;
                                let _e522 = phi_856_;
                                let _e525 = params.member.member.member[2u];
                                if (_e140 < _e525) {
                                    if (_e307 > 0u) {
                                        let _e531 = params.member.member.member_2[2u];
                                        let _e534 = boxes.member[(_e531 + _e140)];
                                        if ((_e150.member_1 & 1u) == 1u) {
                                            if ((select((_e148.member[0] == _e150.member[0]), true, (_e148.member[0] == _e150.member[0])) || select((_e148.member[1] == _e150.member[0]), true, (_e148.member[1] == _e150.member[0]))) || select((_e148.member[2] == _e150.member[0]), true, (_e148.member[2] == _e150.member[0]))) {
                                                phi_954_ = 0u;
                                            } else {
                                                let _e556 = boxes.member[_e150.member[0]];
                                                phi_954_ = select(0u, 1u, ((((((_e556.member[0] <= _e534.member_1[0]) && (_e534.member[0] <= _e556.member_1[0])) && (_e556.member[1] <= _e534.member_1[1])) && (_e534.member[1] <= _e556.member_1[1])) && (_e556.member[2] <= _e534.member_1[2])) && (_e534.member[2] <= _e556.member_1[2])));
                                            }
                                            let _e594 = phi_954_;
                                            phi_955_ = _e594;
                                        } else {
                                            phi_955_ = 0u;
                                        }
                                        let _e596 = phi_955_;
                                        if (((_e150.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                            if ((select((_e148.member[0] == _e150.member[1]), true, (_e148.member[0] == _e150.member[1])) || select((_e148.member[1] == _e150.member[1]), true, (_e148.member[1] == _e150.member[1]))) || select((_e148.member[2] == _e150.member[1]), true, (_e148.member[2] == _e150.member[1]))) {
                                                phi_1028_ = 0u;
                                            } else {
                                                let _e620 = boxes.member[_e150.member[1]];
                                                phi_1028_ = (select(0u, 1u, ((((((_e620.member[0] <= _e534.member_1[0]) && (_e534.member[0] <= _e620.member_1[0])) && (_e620.member[1] <= _e534.member_1[1])) && (_e534.member[1] <= _e620.member_1[1])) && (_e620.member[2] <= _e534.member_1[2])) && (_e534.member[2] <= _e620.member_1[2]))) << bitcast<u32>(1u));
                                            }
                                            let _e660 = phi_1028_;
                                            phi_1029_ = _e660;
                                        } else {
                                            phi_1029_ = 0u;
                                        }
                                        let _e662 = phi_1029_;
                                        if (((_e150.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                            if ((select((_e148.member[0] == _e150.member[2]), true, (_e148.member[0] == _e150.member[2])) || select((_e148.member[1] == _e150.member[2]), true, (_e148.member[1] == _e150.member[2]))) || select((_e148.member[2] == _e150.member[2]), true, (_e148.member[2] == _e150.member[2]))) {
                                                phi_1103_ = 0u;
                                            } else {
                                                let _e687 = boxes.member[_e150.member[2]];
                                                phi_1103_ = (select(0u, 1u, ((((((_e687.member[0] <= _e534.member_1[0]) && (_e534.member[0] <= _e687.member_1[0])) && (_e687.member[1] <= _e534.member_1[1])) && (_e534.member[1] <= _e687.member_1[1])) && (_e687.member[2] <= _e534.member_1[2])) && (_e534.member[2] <= _e687.member_1[2]))) << bitcast<u32>(2u));
                                            }
                                            let _e727 = phi_1103_;
                                            phi_1104_ = _e727;
                                        } else {
                                            phi_1104_ = 0u;
                                        }
                                        let _e729 = phi_1104_;
                                        phi_1108_ = (_e520 + _e307);
                                        phi_1109_ = (_e522 | (((_e596 | _e662) | _e729) << bitcast<u32>(3i)));
                                    } else {
                                        phi_1108_ = _e520;
                                        phi_1109_ = _e522;
                                    }
                                    let _e735 = phi_1108_;
                                    let _e737 = phi_1109_;
                                    phi_1110_ = _e735;
                                    phi_1111_ = _e737;
                                } else {
                                    phi_1110_ = _e520;
                                    phi_1111_ = _e522;
                                }
                                let _e739 = phi_1110_;
                                let _e741 = phi_1111_;
                                let _e745 = countOneBits((_e148.member_1 >> bitcast<u32>(3i)));
                                let _e749 = countOneBits((_e150.member_1 >> bitcast<u32>(3i)));
                                if (_e745 > 0u) {
                                    if (_e749 > 0u) {
                                        let _e756 = params.member.member.member_2[1u];
                                        if (((_e150.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                            let _e772 = boxes.member[(_e756 + _e150.member_2[0])];
                                            phi_1159_ = _e772;
                                        } else {
                                            phi_1159_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e774 = phi_1159_;
                                        if (((_e150.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                            let _e782 = boxes.member[(_e756 + _e150.member_2[1])];
                                            phi_1181_ = _e782;
                                        } else {
                                            phi_1181_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e784 = phi_1181_;
                                        if (((_e150.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                            let _e792 = boxes.member[(_e756 + _e150.member_2[2])];
                                            phi_1203_ = _e792;
                                        } else {
                                            phi_1203_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e794 = phi_1203_;
                                        if (((_e148.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                            let _e810 = boxes.member[(_e756 + _e148.member_2[0])];
                                            phi_1233_ = _e810;
                                        } else {
                                            phi_1233_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e812 = phi_1233_;
                                        if (((_e148.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                            let _e961 = boxes.member[(_e756 + _e148.member_2[1])];
                                            phi_1376_ = _e961;
                                        } else {
                                            phi_1376_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e963 = phi_1376_;
                                        if (((_e148.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                            let _e1115 = boxes.member[(_e756 + _e148.member_2[2])];
                                            phi_1521_ = _e1115;
                                        } else {
                                            phi_1521_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e1117 = phi_1521_;
                                        phi_1648_ = (_e739 + (_e745 * _e749));
                                        phi_1649_ = (_e741 | (((((((select(0u, 1u, (!((select((_e150.member[0] == _e148.member[1]), true, (_e150.member[0] == _e148.member[0])) || select((_e150.member[1] == _e148.member[1]), true, (_e150.member[1] == _e148.member[0])))) && ((((((_e812.member[0] <= _e774.member_1[0]) && (_e774.member[0] <= _e812.member_1[0])) && (_e812.member[1] <= _e774.member_1[1])) && (_e774.member[1] <= _e812.member_1[1])) && (_e812.member[2] <= _e774.member_1[2])) && (_e774.member[2] <= _e812.member_1[2])))) | (select(0u, 1u, (!((select((_e150.member[1] == _e148.member[1]), true, (_e150.member[1] == _e148.member[0])) || select((_e150.member[2] == _e148.member[1]), true, (_e150.member[2] == _e148.member[0])))) && ((((((_e812.member[0] <= _e784.member_1[0]) && (_e784.member[0] <= _e812.member_1[0])) && (_e812.member[1] <= _e784.member_1[1])) && (_e784.member[1] <= _e812.member_1[1])) && (_e812.member[2] <= _e784.member_1[2])) && (_e784.member[2] <= _e812.member_1[2])))) << bitcast<u32>(1i))) | (select(0u, 1u, (!((select((_e150.member[2] == _e148.member[1]), true, (_e150.member[2] == _e148.member[0])) || select((_e150.member[0] == _e148.member[1]), true, (_e150.member[0] == _e148.member[0])))) && ((((((_e812.member[0] <= _e794.member_1[0]) && (_e794.member[0] <= _e812.member_1[0])) && (_e812.member[1] <= _e794.member_1[1])) && (_e794.member[1] <= _e812.member_1[1])) && (_e812.member[2] <= _e794.member_1[2])) && (_e794.member[2] <= _e812.member_1[2])))) << bitcast<u32>(2i))) | (((select(0u, 1u, (!((select((_e150.member[0] == _e148.member[2]), true, (_e150.member[0] == _e148.member[1])) || select((_e150.member[1] == _e148.member[2]), true, (_e150.member[1] == _e148.member[1])))) && ((((((_e963.member[0] <= _e774.member_1[0]) && (_e774.member[0] <= _e963.member_1[0])) && (_e963.member[1] <= _e774.member_1[1])) && (_e774.member[1] <= _e963.member_1[1])) && (_e963.member[2] <= _e774.member_1[2])) && (_e774.member[2] <= _e963.member_1[2])))) << bitcast<u32>(3i)) | (select(0u, 1u, (!((select((_e150.member[1] == _e148.member[2]), true, (_e150.member[1] == _e148.member[1])) || select((_e150.member[2] == _e148.member[2]), true, (_e150.member[2] == _e148.member[1])))) && ((((((_e963.member[0] <= _e784.member_1[0]) && (_e784.member[0] <= _e963.member_1[0])) && (_e963.member[1] <= _e784.member_1[1])) && (_e784.member[1] <= _e963.member_1[1])) && (_e963.member[2] <= _e784.member_1[2])) && (_e784.member[2] <= _e963.member_1[2])))) << bitcast<u32>(4i))) | (select(0u, 1u, (!((select((_e150.member[2] == _e148.member[2]), true, (_e150.member[2] == _e148.member[1])) || select((_e150.member[0] == _e148.member[2]), true, (_e150.member[0] == _e148.member[1])))) && ((((((_e963.member[0] <= _e794.member_1[0]) && (_e794.member[0] <= _e963.member_1[0])) && (_e963.member[1] <= _e794.member_1[1])) && (_e794.member[1] <= _e963.member_1[1])) && (_e963.member[2] <= _e794.member_1[2])) && (_e794.member[2] <= _e963.member_1[2])))) << bitcast<u32>(5i)))) | (select(0u, 1u, (!((select((_e150.member[0] == _e148.member[0]), true, (_e150.member[0] == _e148.member[2])) || select((_e150.member[1] == _e148.member[0]), true, (_e150.member[1] == _e148.member[2])))) && ((((((_e1117.member[0] <= _e774.member_1[0]) && (_e774.member[0] <= _e1117.member_1[0])) && (_e1117.member[1] <= _e774.member_1[1])) && (_e774.member[1] <= _e1117.member_1[1])) && (_e1117.member[2] <= _e774.member_1[2])) && (_e774.member[2] <= _e1117.member_1[2])))) << bitcast<u32>(6i))) | (select(0u, 1u, (!((select((_e150.member[1] == _e148.member[0]), true, (_e150.member[1] == _e148.member[2])) || select((_e150.member[2] == _e148.member[0]), true, (_e150.member[2] == _e148.member[2])))) && ((((((_e1117.member[0] <= _e784.member_1[0]) && (_e784.member[0] <= _e1117.member_1[0])) && (_e1117.member[1] <= _e784.member_1[1])) && (_e784.member[1] <= _e1117.member_1[1])) && (_e1117.member[2] <= _e784.member_1[2])) && (_e784.member[2] <= _e1117.member_1[2])))) << bitcast<u32>(7i))) | (select(0u, 1u, (!((select((_e150.member[2] == _e148.member[0]), true, (_e150.member[2] == _e148.member[2])) || select((_e150.member[0] == _e148.member[0]), true, (_e150.member[0] == _e148.member[2])))) && ((((((_e1117.member[0] <= _e794.member_1[0]) && (_e794.member[0] <= _e1117.member_1[0])) && (_e1117.member[1] <= _e794.member_1[1])) && (_e794.member[1] <= _e1117.member_1[1])) && (_e1117.member[2] <= _e794.member_1[2])) && (_e794.member[2] <= _e1117.member_1[2])))) << bitcast<u32>(8i))) << bitcast<u32>(6u)));
                                    } else {
                                        phi_1648_ = _e739;
                                        phi_1649_ = _e741;
                                    }
                                    let _e1266 = phi_1648_;
                                    let _e1268 = phi_1649_;
                                    phi_1650_ = _e1266;
                                    phi_1651_ = _e1268;
                                } else {
                                    phi_1650_ = _e739;
                                    phi_1651_ = _e741;
                                }
                                let _e1270 = phi_1650_;
                                let _e1272 = phi_1651_;
                                phi_1654_ = type_22(array<u32, 5>(1u, 0u, 0u, _e1270, 0u), _e1272);
                            }
                            let _e1276 = phi_1654_;
                            phi_1655_ = type_22(array<u32, 5>(1u, 0u, 1u, 0u, 0u), 0u);
                            phi_1656_ = _e1276;
                            phi_1657_ = _e301;
                        } else {
                            phi_1655_ = type_22(array<u32, 5>(1u, 1u, 0u, 0u, 0u), 0u);
                            phi_1656_ = type_22();
                            phi_1657_ = true;
                        }
                        let _e1278 = phi_1655_;
                        let _e1280 = phi_1656_;
                        let _e1282 = phi_1657_;
                        phi_1658_ = _e1278;
                        phi_1659_ = _e1280;
                        phi_1660_ = _e1282;
                    } else {
                        phi_1658_ = type_22(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                        phi_1659_ = type_22();
                        phi_1660_ = true;
                    }
                    let _e1284 = phi_1658_;
                    let _e1286 = phi_1659_;
                    let _e1288 = phi_1660_;
                    phi_1661_ = _e1284;
                    phi_1662_ = _e1286;
                    phi_1663_ = _e1288;
                } else {
                    phi_1661_ = type_22(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                    phi_1662_ = type_22();
                    phi_1663_ = true;
                }
                let _e1290 = phi_1661_;
                let _e1292 = phi_1662_;
                let _e1294 = phi_1663_;
                if _e1294 {
                    phi_1667_ = _e1290;
                } else {
                    phi_1667_ = _e1292;
                }
                let _e1296 = phi_1667_;
                if (_e1296.member[0] == 0u) {
                } else {
                    let _e1309 = atomicAdd((&shared_[0u]), _e1296.member[0]);
                }
                if (_e1296.member[1] == 0u) {
                } else {
                    let _e1312 = atomicAdd((&shared_[1u]), _e1296.member[1]);
                }
                if (_e1296.member[2] == 0u) {
                } else {
                    let _e1315 = atomicAdd((&shared_[2u]), _e1296.member[2]);
                }
                if (_e1296.member[3] == 0u) {
                } else {
                    let _e1318 = atomicAdd((&shared_[3u]), _e1296.member[3]);
                }
                if (_e1296.member[4] == 0u) {
                } else {
                    let _e1321 = atomicAdd((&shared_[4u]), _e1296.member[4]);
                }
                if (_e1296.member_1 == 0u) {
                    phi_1716_ = 0u;
                    phi_1717_ = 0u;
                } else {
                    let _e1327 = atomicAdd((&shared_[5u]), countOneBits((_e1296.member_1 & 63u)));
                    let _e1331 = atomicAdd((&shared_[6u]), countOneBits((_e1296.member_1 & 4294967232u)));
                    phi_1716_ = _e1331;
                    phi_1717_ = _e1327;
                }
                let _e1333 = phi_1716_;
                let _e1335 = phi_1717_;
                phi_1718_ = _e1333;
                phi_1719_ = _e1335;
                phi_1720_ = _e1296.member_1;
                phi_1721_ = type_9(_e140, _e143);
            } else {
                phi_1718_ = 0u;
                phi_1719_ = 0u;
                phi_1720_ = 0u;
                phi_1721_ = type_9(0u, 0u);
            }
            let _e1337 = phi_1718_;
            let _e1339 = phi_1719_;
            let _e1341 = phi_1720_;
            let _e1343 = phi_1721_;
            workgroupBarrier();
            if (_e50 == 0u) {
                let _e1346 = atomicLoad((&shared_[5u]));
                let _e1348 = atomicLoad((&shared_[6u]));
                if (_e1346 > 0u) {
                    let _e1351 = atomicAdd((&vf.member[0u]), _e1346);
                    if ((_e1351 + _e1346) < _e1351) {
                        let _e1355 = atomicAdd((&vf.member[2u]), 1u);
                    }
                    atomicStore((&shared_[7u]), _e1351);
                }
                if (_e1348 > 0u) {
                    let _e1359 = atomicAdd((&ee.member[0u]), _e1348);
                    if ((_e1359 + _e1348) < _e1359) {
                        let _e1363 = atomicAdd((&ee.member[2u]), 1u);
                    }
                    atomicStore((&shared_[8u]), _e1359);
                }
            }
            workgroupBarrier();
            if (_e1341 == 0u) {
            } else {
                let _e1367 = atomicLoad((&shared_[7u]));
                let _e1370 = atomicLoad((&shared_[8u]));
                phi_1776_ = type_9(0u, 6u);
                phi_1779_ = (_e1339 + _e1367);
                loop {
                    let _e1373 = phi_1776_;
                    let _e1375 = phi_1779_;
                    let _e1378 = (_e1373.member < _e1373.member_1);
                    let _e1389 = select(type_9().member_1, _e1373.member, _e1378);
                    let _e1391 = (bitcast<i32>(select(0u, 1u, _e1378)) != 0i);
                    if _e1391 {
                        if (((_e1341 >> bitcast<u32>((_e1389 & 31u))) & 1u) == 1u) {
                            let _e1400 = triangles.member[_e1343.member];
                            let _e1402 = triangles.member[_e1343.member_1];
                            if (_e1389 < 3u) {
                                phi_1920_ = type_9(select(select(_e1400.member[2], _e1400.member[1], (_e1389 == 1u)), _e1400.member[0], (_e1389 == 0u)), _e1343.member_1);
                            } else {
                                if (_e1389 < 6u) {
                                    let _e1430 = (_e1389 - 3u);
                                    phi_1919_ = type_9(select(select(_e1402.member[2], _e1402.member[1], (_e1430 == 1u)), _e1402.member[0], (_e1430 == 0u)), _e1343.member);
                                } else {
                                    let _e1409 = (_e1389 - 6u);
                                    let _e1410 = (_e1409 / 3u);
                                    let _e1417 = select(select(_e1400.member_2[2], _e1400.member_2[1], (_e1410 == 1u)), _e1400.member_2[0], (_e1410 == 0u));
                                    let _e1418 = (_e1409 % 3u);
                                    let _e1425 = select(select(_e1402.member_2[2], _e1402.member_2[1], (_e1418 == 1u)), _e1402.member_2[0], (_e1418 == 0u));
                                    let _e1426 = (_e1417 < _e1425);
                                    phi_1919_ = type_9(select(_e1425, _e1417, _e1426), select(_e1417, _e1425, _e1426));
                                }
                                let _e1440 = phi_1919_;
                                phi_1920_ = _e1440;
                            }
                            let _e1450 = phi_1920_;
                            let _e1454 = params.member.member_1.member_3;
                            if (_e1375 < _e1454) {
                                let _e1456 = (2u * _e1375);
                                atomicStore((&vf.member[(4u + _e1456)]), _e1450.member);
                                atomicStore((&vf.member[(_e1456 + 5u)]), _e1450.member_1);
                            }
                            phi_1937_ = (_e1375 + 1u);
                        } else {
                            phi_1937_ = _e1375;
                        }
                        let _e1463 = phi_1937_;
                        phi_1780_ = _e1463;
                    } else {
                        phi_1780_ = u32();
                    }
                    let _e1465 = phi_1780_;
                    continue;
                    continuing {
                        phi_1776_ = type_9(select(_e1373.member, (_e1373.member + 1u), _e1378), select(_e1373.member_1, _e1373.member_1, _e1378));
                        phi_1779_ = _e1465;
                        break if !(_e1391);
                    }
                }
                phi_1940_ = type_9(6u, 15u);
                phi_1943_ = (_e1337 + _e1370);
                loop {
                    let _e1468 = phi_1940_;
                    let _e1470 = phi_1943_;
                    let _e1473 = (_e1468.member < _e1468.member_1);
                    let _e1484 = select(type_9().member_1, _e1468.member, _e1473);
                    let _e1486 = (bitcast<i32>(select(0u, 1u, _e1473)) != 0i);
                    if _e1486 {
                        if (((_e1341 >> bitcast<u32>((_e1484 & 31u))) & 1u) == 1u) {
                            let _e1495 = triangles.member[_e1343.member];
                            let _e1497 = triangles.member[_e1343.member_1];
                            if (_e1484 < 3u) {
                                phi_2084_ = type_9(select(select(_e1495.member[2], _e1495.member[1], (_e1484 == 1u)), _e1495.member[0], (_e1484 == 0u)), _e1343.member_1);
                            } else {
                                if (_e1484 < 6u) {
                                    let _e1525 = (_e1484 - 3u);
                                    phi_2083_ = type_9(select(select(_e1497.member[2], _e1497.member[1], (_e1525 == 1u)), _e1497.member[0], (_e1525 == 0u)), _e1343.member);
                                } else {
                                    let _e1504 = (_e1484 - 6u);
                                    let _e1505 = (_e1504 / 3u);
                                    let _e1512 = select(select(_e1495.member_2[2], _e1495.member_2[1], (_e1505 == 1u)), _e1495.member_2[0], (_e1505 == 0u));
                                    let _e1513 = (_e1504 % 3u);
                                    let _e1520 = select(select(_e1497.member_2[2], _e1497.member_2[1], (_e1513 == 1u)), _e1497.member_2[0], (_e1513 == 0u));
                                    let _e1521 = (_e1512 < _e1520);
                                    phi_2083_ = type_9(select(_e1520, _e1512, _e1521), select(_e1512, _e1520, _e1521));
                                }
                                let _e1535 = phi_2083_;
                                phi_2084_ = _e1535;
                            }
                            let _e1545 = phi_2084_;
                            if (_e1470 < _e70) {
                                let _e1549 = (2u * _e1470);
                                atomicStore((&ee.member[(4u + _e1549)]), _e1545.member);
                                atomicStore((&ee.member[(_e1549 + 5u)]), _e1545.member_1);
                            }
                            phi_2099_ = (_e1470 + 1u);
                        } else {
                            phi_2099_ = _e1470;
                        }
                        let _e1556 = phi_2099_;
                        phi_1944_ = _e1556;
                    } else {
                        phi_1944_ = u32();
                    }
                    let _e1558 = phi_1944_;
                    continue;
                    continuing {
                        phi_1940_ = type_9(select(_e1468.member, (_e1468.member + 1u), _e1473), select(_e1468.member_1, _e1468.member_1, _e1473));
                        phi_1943_ = _e1558;
                        break if !(_e1486);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_213_ = type_9(select(_e109.member, (_e109.member + 1u), _e112), select(_e109.member_1, _e109.member_1, _e112));
            break if !(_e125);
        }
    }
    workgroupBarrier();
    if (_e50 < 5u) {
        let _e1563 = atomicLoad((&shared_[_e50]));
        if (_e1563 > 0u) {
            let _e1565 = (_e50 * 4u);
            let _e1567 = atomicAdd((&counts.member[_e1565]), _e1563);
            if ((_e1567 + _e1563) < _e1567) {
                let _e1572 = atomicAdd((&counts.member[(_e1565 + 2u)]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_triangles(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
