struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_15 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: u32,
    member_1: u32,
}

struct type_25 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> nodes: type_13;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_4, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_18;
@group(0) @binding(3) 
var<storage> bodies: type_15;
@group(0) @binding(4) 
var<storage> keys: type_25;
@group(0) @binding(5) 
var<storage> input: type_15;
@group(0) @binding(6) 
var<storage, read_write> output: type_32;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<u32, 2>, 6>;
    var local_1: array<array<u32, 2>, 6>;
    var local_2: array<array<u32, 2>, 6>;
    var local_3: array<array<u32, 2>, 6>;
    var local_4: array<array<u32, 2>, 6>;
    var local_5: array<array<u32, 2>, 6>;
    var local_6: array<array<u32, 2>, 6>;
    var local_7: array<array<u32, 2>, 6>;
    var local_8: array<array<u32, 2>, 6>;
    var local_9: array<array<u32, 2>, 6>;
    var local_10: array<array<u32, 2>, 6>;
    var local_11: array<array<u32, 2>, 6>;
    var local_12: array<array<u32, 2>, 6>;
    var local_13: array<array<u32, 2>, 6>;
    var local_14: array<array<u32, 2>, 6>;
    var local_15: array<array<u32, 2>, 6>;
    var local_16: type_16;
    var local_17: type_16;
    var local_18: type_16;
    var local_19: type_16;
    var phi_184_: u32;
    var phi_195_: array<u32, 2>;
    var phi_224_: u32;
    var phi_225_: u32;
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_21;
    var phi_274_: type_21;
    var phi_297_: type_21;
    var phi_335_: u32;
    var phi_336_: u32;
    var phi_343_: u32;
    var phi_353_: u32;
    var phi_432_: array<u32, 2>;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_631_: type_4;
    var phi_637_: bool;
    var phi_644_: type_21;
    var phi_647_: u32;
    var phi_645_: type_21;
    var phi_670_: type_21;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_742_: bool;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_762_: u32;
    var phi_648_: u32;
    var phi_765_: type_21;
    var phi_768_: u32;
    var phi_766_: type_21;
    var phi_791_: type_21;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_945_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_907_: bool;
    var phi_946_: bool;
    var phi_950_: bool;
    var phi_951_: bool;
    var phi_997_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1062_: type_21;
    var phi_1065_: bool;
    var phi_1063_: type_21;
    var phi_1088_: type_21;
    var phi_1145_: type_21;
    var phi_1148_: array<u32, 2>;
    var phi_1146_: type_21;
    var phi_1171_: type_21;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1251_: array<u32, 2>;
    var phi_1149_: array<u32, 2>;
    var phi_1302_: type_21;
    var phi_1305_: array<u32, 2>;
    var phi_1303_: type_21;
    var phi_1328_: type_21;
    var phi_1404_: bool;
    var phi_1405_: bool;
    var phi_1409_: array<u32, 2>;
    var phi_1306_: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var local_22: array<u32, 2>;
    var local_23: array<u32, 2>;
    var local_24: array<u32, 2>;
    var local_25: array<u32, 2>;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1477_: type_21;
    var phi_1480_: array<u32, 2>;
    var phi_1478_: type_21;
    var phi_1503_: type_21;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1583_: array<u32, 2>;
    var phi_1481_: array<u32, 2>;
    var phi_1634_: type_21;
    var phi_1637_: array<u32, 2>;
    var phi_1635_: type_21;
    var phi_1660_: type_21;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1741_: array<u32, 2>;
    var phi_1638_: array<u32, 2>;
    var local_26: array<u32, 2>;
    var local_27: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var local_30: array<u32, 2>;
    var local_31: array<u32, 2>;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1066_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1776_: bool;
    var phi_1796_: type_21;
    var phi_1801_: type_21;
    var phi_1841_: u32;
    var phi_1842_: bool;
    var phi_769_: u32;
    var phi_1843_: bool;
    var phi_1850_: u32;
    var phi_1853_: type_21;
    var phi_1854_: type_21;
    var phi_1877_: type_21;
    var phi_2031_: bool;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2034_: bool;
    var phi_2035_: bool;
    var phi_2039_: bool;
    var phi_1995_: bool;
    var phi_1996_: bool;
    var phi_1997_: bool;
    var phi_2001_: bool;
    var phi_2040_: bool;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2091_: bool;
    var phi_2101_: bool;
    var phi_2102_: bool;
    var phi_2106_: bool;
    var phi_2107_: bool;
    var phi_2156_: type_21;
    var phi_2159_: bool;
    var phi_2157_: type_21;
    var phi_2182_: type_21;
    var phi_2239_: type_21;
    var phi_2242_: array<u32, 2>;
    var phi_2240_: type_21;
    var phi_2265_: type_21;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var phi_2345_: array<u32, 2>;
    var phi_2243_: array<u32, 2>;
    var phi_2396_: type_21;
    var phi_2399_: array<u32, 2>;
    var phi_2397_: type_21;
    var phi_2422_: type_21;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2503_: array<u32, 2>;
    var phi_2400_: array<u32, 2>;
    var local_32: array<u32, 2>;
    var local_33: array<u32, 2>;
    var local_34: array<u32, 2>;
    var local_35: array<u32, 2>;
    var local_36: array<u32, 2>;
    var local_37: array<u32, 2>;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2571_: type_21;
    var phi_2574_: array<u32, 2>;
    var phi_2572_: type_21;
    var phi_2597_: type_21;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: array<u32, 2>;
    var phi_2575_: array<u32, 2>;
    var phi_2728_: type_21;
    var phi_2731_: array<u32, 2>;
    var phi_2729_: type_21;
    var phi_2754_: type_21;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2835_: array<u32, 2>;
    var phi_2732_: array<u32, 2>;
    var local_38: array<u32, 2>;
    var local_39: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var phi_2851_: bool;
    var phi_2852_: bool;
    var phi_2160_: bool;
    var phi_2856_: bool;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var phi_2862_: bool;
    var phi_2863_: bool;
    var phi_2864_: bool;
    var phi_2865_: bool;
    var phi_2866_: bool;
    var phi_2870_: bool;
    var phi_2885_: bool;
    var phi_2886_: bool;
    var phi_2936_: type_21;
    var phi_2937_: type_21;
    var phi_2960_: type_21;
    var phi_2983_: u32;
    var phi_3037_: type_21;
    var phi_3042_: type_21;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var local_44: u32;
    var local_45: bool;
    var local_46: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e68 = id_2;
    let _e69 = n_2;
    let _e70 = lane_2;
    let _e82 = ((_e68.y * _e69.x) + _e68.x);
    let _e85 = (_e69.x * _e69.y);
    let _e87 = params.member.member_15;
    let _e89 = input.member[0u];
    if (_e87 < _e89) {
        phi_184_ = _e87;
    } else {
        phi_184_ = _e89;
    }
    let _e92 = phi_184_;
    let _e93 = (_e70 / 32u);
    let _e94 = (_e70 % 32u);
    let _e96 = params.member.member_8;
    if (_e96 == 0u) {
        phi_195_ = array<u32, 2>(0u, 2u);
    } else {
        phi_195_ = array<u32, 2>(1u, 1u);
    }
    let _e99 = phi_195_;
    let _e103 = params.member.member_12;
    if (_e92 > _e103) {
        let _e106 = params.member.member_12;
        let _e107 = (_e92 - _e106);
        let _e109 = params.member.member_13;
        if (_e109 == 0u) {
            return;
        }
        let _e111 = (_e107 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e107 % _e109) > 0u) {
            phi_224_ = (_e111 + 1u);
        } else {
            phi_224_ = _e111;
        }
        let _e117 = phi_224_;
        phi_225_ = _e117;
    } else {
        phi_225_ = 0u;
    }
    let _e119 = phi_225_;
    let _e121 = params.member.member_14;
    if (_e121 < _e119) {
        phi_232_ = _e121;
    } else {
        phi_232_ = _e119;
    }
    let _e124 = phi_232_;
    let _e125 = (_e124 / 4u);
    if ((_e124 % 4u) > 0u) {
        phi_248_ = (_e125 + 1u);
    } else {
        phi_248_ = _e125;
    }
    let _e130 = phi_248_;
    if (_e130 > _e82) {
        let _e132 = (_e130 - _e82);
        if (_e85 == 0u) {
            return;
        }
        let _e134 = (_e132 / _e85);
        if (_e85 == 0u) {
            return;
        }
        if ((_e132 % _e85) > 0u) {
            phi_269_ = (_e134 + 1u);
        } else {
            phi_269_ = _e134;
        }
        let _e140 = phi_269_;
        phi_270_ = _e140;
    } else {
        phi_270_ = 0u;
    }
    let _e142 = phi_270_;
    phi_273_ = type_21(0u, _e142);
    loop {
        let _e145 = phi_273_;
        if (_e145.member < _e145.member_1) {
            phi_274_ = type_21((_e145.member + 1u), _e145.member_1);
            phi_297_ = type_21(1u, _e145.member);
        } else {
            phi_274_ = _e145;
            phi_297_ = type_21(0u, type_21().member_1);
        }
        let _e157 = phi_274_;
        let _e159 = phi_297_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e167 = (((_e82 + (_e159.member_1 * _e85)) * 4u) + _e93);
            let _e169 = params.member.member_12;
            if (_e92 > _e169) {
                let _e172 = params.member.member_12;
                let _e173 = (_e92 - _e172);
                let _e175 = params.member.member_13;
                if (_e175 == 0u) {
                    return;
                }
                let _e177 = (_e173 / _e175);
                if (_e175 == 0u) {
                    return;
                }
                if ((_e173 % _e175) > 0u) {
                    phi_335_ = (_e177 + 1u);
                } else {
                    phi_335_ = _e177;
                }
                let _e183 = phi_335_;
                phi_336_ = _e183;
            } else {
                phi_336_ = 0u;
            }
            let _e185 = phi_336_;
            let _e187 = params.member.member_14;
            if (_e187 < _e185) {
                phi_343_ = _e187;
            } else {
                phi_343_ = _e185;
            }
            let _e190 = phi_343_;
            let _e191 = (_e167 < _e190);
            let _e193 = params.member.member_12;
            if _e191 {
                let _e195 = params.member.member_13;
                phi_353_ = (_e167 * _e195);
            } else {
                phi_353_ = 0u;
            }
            let _e198 = phi_353_;
            let _e200 = (2u * (_e193 + _e198));
            let _e203 = input.member[(4u + _e200)];
            let _e206 = input.member[(_e200 + 5u)];
            if (_e70 < 8u) {
                atomicStore((&counters[_e70]), 0u);
            }
            workgroupBarrier();
            let _e213 = params.member.member_20[0u][_e99[0]];
            let _e214 = (_e213 + (_e203 * 32u));
            let _e219 = params.member.member_20[0u][_e99[1]];
            let _e220 = (_e219 + (_e206 * 32u));
            if (_e94 == 0u) {
                firsts[(2u * _e93)] = _e214;
                firsts[((2u * _e93) + 1u)] = _e220;
            }
            let _e228 = params.member.member_8;
            if (_e228 == 0u) {
                phi_432_ = array<u32, 2>(0u, 2u);
            } else {
                phi_432_ = array<u32, 2>(1u, 1u);
            }
            let _e231 = phi_432_;
            let _e234 = (_e70 / 32u);
            let _e235 = (_e70 % 32u);
            let _e237 = params.member.member_9;
            let _e241 = params.member.member_20[_e237][_e231[0]];
            let _e244 = nodes.member[(_e241 + _e203)];
            let _e246 = params.member.member_9;
            let _e250 = params.member.member_20[_e246][_e231[1]];
            let _e253 = nodes.member[(_e250 + _e206)];
            let _e255 = params.member.member_9;
            let _e262 = params.member.member_20[(_e255 - 1u)][_e231[0]];
            let _e265 = nodes.member[(_e262 + ((_e203 * 32u) + _e235))];
            let _e267 = params.member.member_9;
            let _e274 = params.member.member_20[(_e267 - 1u)][_e231[1]];
            let _e277 = nodes.member[(_e274 + ((_e206 * 32u) + _e235))];
            if _e191 {
                if ((((((_e277.member[0] <= _e244.member_1[0]) && (_e244.member[0] <= _e277.member_1[0])) && (_e277.member[1] <= _e244.member_1[1])) && (_e244.member[1] <= _e277.member_1[1])) && (_e277.member[2] <= _e244.member_1[2])) && (_e244.member[2] <= _e277.member_1[2])) {
                    let _e315 = atomicAdd((&counters[_e234]), 1u);
                    let _e316 = ((_e234 * 32u) + _e315);
                    columns[_e316] = type_4(array<f32, 3>(_e277.member[0], _e277.member[1], _e277.member[2]), array<f32, 3>(_e277.member_1[0], _e277.member_1[1], _e277.member_1[2]));
                    names[_e316] = _e235;
                }
            }
            workgroupBarrier();
            if _e191 {
                if ((((((_e265.member[0] <= _e253.member_1[0]) && (_e253.member[0] <= _e265.member_1[0])) && (_e265.member[1] <= _e253.member_1[1])) && (_e253.member[1] <= _e265.member_1[1])) && (_e265.member[2] <= _e253.member_1[2])) && (_e253.member[2] <= _e265.member_1[2])) {
                    phi_626_ = false;
                } else {
                    phi_626_ = true;
                }
                let _e366 = phi_626_;
                phi_627_ = _e366;
            } else {
                phi_627_ = true;
            }
            let _e368 = phi_627_;
            if _e368 {
                phi_631_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_631_ = _e265;
            }
            let _e370 = phi_631_;
            if (_e99[0] == _e99[1]) {
                phi_637_ = (_e203 == _e206);
            } else {
                phi_637_ = false;
            }
            let _e374 = phi_637_;
            let _e375 = (_e70 / 32u);
            let _e376 = (_e70 % 32u);
            let _e378 = atomicLoad((&counters[_e375]));
            phi_644_ = type_21(0u, _e378);
            phi_647_ = 0u;
            loop {
                let _e381 = phi_644_;
                let _e383 = phi_647_;
                local_44 = _e383;
                if (_e381.member < _e381.member_1) {
                    phi_645_ = type_21((_e381.member + 1u), _e381.member_1);
                    phi_670_ = type_21(1u, _e381.member);
                } else {
                    phi_645_ = _e381;
                    phi_670_ = type_21(0u, type_21().member_1);
                }
                let _e395 = phi_645_;
                let _e397 = phi_670_;
                let _e401 = (bitcast<i32>(_e397.member) != 0i);
                if _e401 {
                    let _e405 = names[((_e375 * 32u) + _e397.member_1)];
                    let _e409 = columns[((_e375 * 32u) + _e397.member_1)];
                    if ((((((_e370.member[0] <= _e409.member_1[0]) && (_e409.member[0] <= _e370.member_1[0])) && (_e370.member[1] <= _e409.member_1[1])) && (_e409.member[1] <= _e370.member_1[1])) && (_e370.member[2] <= _e409.member_1[2])) && (_e409.member[2] <= _e370.member_1[2])) {
                        if _e374 {
                            let _e441 = (_e376 < _e405);
                            if _e441 {
                                phi_736_ = bool();
                            } else {
                                phi_736_ = false;
                            }
                            let _e443 = phi_736_;
                            phi_737_ = _e443;
                            phi_738_ = _e441;
                        } else {
                            phi_737_ = bool();
                            phi_738_ = true;
                        }
                        let _e445 = phi_737_;
                        let _e447 = phi_738_;
                        if _e447 {
                            phi_742_ = true;
                        } else {
                            phi_742_ = _e445;
                        }
                        let _e449 = phi_742_;
                        if _e449 {
                            let _e451 = atomicAdd((&counters[4u]), 1u);
                            if (_e451 < 2048u) {
                                hits[_e451] = (((_e375 << bitcast<u32>(10i)) | (_e376 << bitcast<u32>(5i))) | _e405);
                                phi_760_ = _e383;
                            } else {
                                phi_760_ = (_e383 | (1u << bitcast<u32>((_e397.member_1 & 31u))));
                            }
                            let _e465 = phi_760_;
                            phi_761_ = _e465;
                        } else {
                            phi_761_ = _e383;
                        }
                        let _e467 = phi_761_;
                        phi_762_ = _e467;
                    } else {
                        phi_762_ = _e383;
                    }
                    let _e469 = phi_762_;
                    phi_648_ = _e469;
                } else {
                    phi_648_ = u32();
                }
                let _e471 = phi_648_;
                continue;
                continuing {
                    phi_644_ = _e395;
                    phi_647_ = _e471;
                    break if !(_e401);
                }
            }
            phi_765_ = type_21(0u, 32u);
            let _e2169 = local_44;
            phi_768_ = _e2169;
            loop {
                let _e474 = phi_765_;
                let _e476 = phi_768_;
                if (_e474.member < _e474.member_1) {
                    phi_766_ = type_21((_e474.member + 1u), _e474.member_1);
                    phi_791_ = type_21(1u, _e474.member);
                } else {
                    phi_766_ = _e474;
                    phi_791_ = type_21(0u, type_21().member_1);
                }
                let _e488 = phi_766_;
                let _e490 = phi_791_;
                if (bitcast<i32>(_e490.member) != 0i) {
                    if (_e476 == 0u) {
                        phi_1841_ = u32();
                        phi_1842_ = false;
                    } else {
                        let _e501 = names[((_e93 * 32u) + select(firstTrailingBit(_e476), 32u, (_e476 == 0u)))];
                        let _e504 = (_e214 + _e94);
                        let _e505 = (_e220 + _e501);
                        let _e507 = leaves.member[_e504];
                        let _e509 = leaves.member[_e505];
                        local_16 = type_16(array<u32, 3>(_e507.member[0], _e507.member[1], _e507.member[2]), _e507.member_1);
                        local_17 = type_16(array<u32, 3>(_e509.member[0], _e509.member[1], _e509.member[2]), _e509.member_1);
                        let _e525 = nodes.member[_e504];
                        let _e527 = nodes.member[_e505];
                        let _e529 = params.member.member_1;
                        if ((_e529 & 1u) != 0u) {
                            let _e533 = params.member.member_8;
                            if (_e533 == 0u) {
                                let _e577 = local_16.member[0u];
                                let _e580 = local_17.member[0u];
                                if (_e577 == _e580) {
                                    phi_902_ = bool();
                                    phi_903_ = true;
                                } else {
                                    let _e584 = local_16.member[0u];
                                    let _e587 = local_17.member[1u];
                                    let _e588 = (_e584 == _e587);
                                    if _e588 {
                                        phi_901_ = bool();
                                    } else {
                                        let _e591 = local_16.member[0u];
                                        let _e594 = local_17.member[2u];
                                        phi_901_ = (_e591 == _e594);
                                    }
                                    let _e597 = phi_901_;
                                    phi_902_ = _e597;
                                    phi_903_ = _e588;
                                }
                                let _e599 = phi_902_;
                                let _e601 = phi_903_;
                                if _e601 {
                                    phi_907_ = true;
                                } else {
                                    phi_907_ = _e599;
                                }
                                let _e603 = phi_907_;
                                phi_946_ = _e603;
                            } else {
                                let _e537 = local_16.member[0u];
                                let _e540 = local_17.member[0u];
                                if (_e537 == _e540) {
                                    phi_940_ = bool();
                                    phi_941_ = true;
                                } else {
                                    let _e544 = local_16.member[0u];
                                    let _e547 = local_17.member[1u];
                                    if (_e544 == _e547) {
                                        phi_938_ = bool();
                                        phi_939_ = true;
                                    } else {
                                        let _e551 = local_16.member[1u];
                                        let _e554 = local_17.member[0u];
                                        let _e555 = (_e551 == _e554);
                                        if _e555 {
                                            phi_937_ = bool();
                                        } else {
                                            let _e558 = local_16.member[1u];
                                            let _e561 = local_17.member[1u];
                                            phi_937_ = (_e558 == _e561);
                                        }
                                        let _e564 = phi_937_;
                                        phi_938_ = _e564;
                                        phi_939_ = _e555;
                                    }
                                    let _e566 = phi_938_;
                                    let _e568 = phi_939_;
                                    phi_940_ = _e566;
                                    phi_941_ = _e568;
                                }
                                let _e570 = phi_940_;
                                let _e572 = phi_941_;
                                if _e572 {
                                    phi_945_ = true;
                                } else {
                                    phi_945_ = _e570;
                                }
                                let _e574 = phi_945_;
                                phi_946_ = _e574;
                            }
                            let _e605 = phi_946_;
                            if _e605 {
                                phi_950_ = false;
                            } else {
                                phi_950_ = true;
                            }
                            let _e607 = phi_950_;
                            phi_951_ = _e607;
                        } else {
                            phi_951_ = true;
                        }
                        let _e609 = phi_951_;
                        if _e609 {
                            let _e611 = params.member.member_1;
                            if ((_e611 & 2u) != 0u) {
                                let _e616 = local_16.member[0u];
                                let _e618 = bodies.member[_e616];
                                let _e621 = local_17.member[0u];
                                let _e623 = bodies.member[_e621];
                                if ((_e618 / 2u) == (_e623 / 2u)) {
                                    let _e628 = params.member.member_1;
                                    phi_997_ = !(((_e628 & 4u) != 0u));
                                } else {
                                    phi_997_ = false;
                                }
                                let _e633 = phi_997_;
                                if _e633 {
                                    phi_1008_ = true;
                                } else {
                                    if (((_e618 & _e623) & 1u) == 0u) {
                                        phi_1007_ = false;
                                    } else {
                                        phi_1007_ = true;
                                    }
                                    let _e638 = phi_1007_;
                                    phi_1008_ = _e638;
                                }
                                let _e640 = phi_1008_;
                                if _e640 {
                                    phi_1012_ = false;
                                } else {
                                    phi_1012_ = true;
                                }
                                let _e642 = phi_1012_;
                                phi_1013_ = _e642;
                            } else {
                                phi_1013_ = true;
                            }
                            let _e644 = phi_1013_;
                            if _e644 {
                                let _e646 = params.member.member_1;
                                if ((_e646 & 32u) != 0u) {
                                    let _e650 = params.member.member_6;
                                    let _e691 = (((((((_e525.member_1[0] - _e527.member[0]) > _e650) && ((_e527.member_1[0] - _e525.member[0]) > _e650)) && ((_e525.member_1[1] - _e527.member[1]) > _e650)) && ((_e527.member_1[1] - _e525.member[1]) > _e650)) && ((_e525.member_1[2] - _e527.member[2]) > _e650)) && ((_e527.member_1[2] - _e525.member[2]) > _e650));
                                    if _e691 {
                                        phi_1762_ = bool();
                                    } else {
                                        phi_1062_ = type_21(0u, 3u);
                                        phi_1065_ = true;
                                        loop {
                                            let _e695 = phi_1062_;
                                            let _e697 = phi_1065_;
                                            local_45 = _e697;
                                            if (_e695.member < _e695.member_1) {
                                                phi_1063_ = type_21((_e695.member + 1u), _e695.member_1);
                                                phi_1088_ = type_21(1u, _e695.member);
                                            } else {
                                                phi_1063_ = _e695;
                                                phi_1088_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e709 = phi_1063_;
                                            let _e711 = phi_1088_;
                                            let _e715 = (bitcast<i32>(_e711.member) != 0i);
                                            if _e715 {
                                                let _e717 = local_16.member[0u];
                                                let _e719 = keys.member[_e717];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e719[0][0], _e719[0][1]), array<u32, 2>(_e719[1][0], _e719[1][1]), array<u32, 2>(_e719[2][0], _e719[2][1]), array<u32, 2>(_e719[3][0], _e719[3][1]), array<u32, 2>(_e719[4][0], _e719[4][1]), array<u32, 2>(_e719[5][0], _e719[5][1]));
                                                let _e746 = local_14[_e711.member_1];
                                                phi_1145_ = type_21(1u, 3u);
                                                phi_1148_ = array<u32, 2>(_e746[0], _e746[1]);
                                                loop {
                                                    let _e751 = phi_1145_;
                                                    let _e753 = phi_1148_;
                                                    local_20 = _e753;
                                                    local_22 = _e753;
                                                    local_24 = _e753;
                                                    if (_e751.member < _e751.member_1) {
                                                        phi_1146_ = type_21((_e751.member + 1u), _e751.member_1);
                                                        phi_1171_ = type_21(1u, _e751.member);
                                                    } else {
                                                        phi_1146_ = _e751;
                                                        phi_1171_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e765 = phi_1146_;
                                                    let _e767 = phi_1171_;
                                                    let _e771 = (bitcast<i32>(_e767.member) != 0i);
                                                    if _e771 {
                                                        let _e773 = local_16.member[_e767.member_1];
                                                        let _e775 = keys.member[_e773];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e775[0][0], _e775[0][1]), array<u32, 2>(_e775[1][0], _e775[1][1]), array<u32, 2>(_e775[2][0], _e775[2][1]), array<u32, 2>(_e775[3][0], _e775[3][1]), array<u32, 2>(_e775[4][0], _e775[4][1]), array<u32, 2>(_e775[5][0], _e775[5][1]));
                                                        let _e802 = local_15[_e711.member_1];
                                                        if (_e753[1] > _e802[1]) {
                                                            phi_1247_ = true;
                                                        } else {
                                                            if (_e753[1] == _e802[1]) {
                                                                phi_1246_ = (_e753[0] > _e802[0]);
                                                            } else {
                                                                phi_1246_ = false;
                                                            }
                                                            let _e813 = phi_1246_;
                                                            phi_1247_ = _e813;
                                                        }
                                                        let _e815 = phi_1247_;
                                                        if _e815 {
                                                            phi_1251_ = array<u32, 2>(_e802[0], _e802[1]);
                                                        } else {
                                                            phi_1251_ = _e753;
                                                        }
                                                        let _e817 = phi_1251_;
                                                        phi_1149_ = _e817;
                                                    } else {
                                                        phi_1149_ = array<u32, 2>();
                                                    }
                                                    let _e819 = phi_1149_;
                                                    continue;
                                                    continuing {
                                                        phi_1145_ = _e765;
                                                        phi_1148_ = _e819;
                                                        break if !(_e771);
                                                    }
                                                }
                                                let _e822 = local_17.member[0u];
                                                let _e824 = keys.member[_e822];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e824[0][0], _e824[0][1]), array<u32, 2>(_e824[1][0], _e824[1][1]), array<u32, 2>(_e824[2][0], _e824[2][1]), array<u32, 2>(_e824[3][0], _e824[3][1]), array<u32, 2>(_e824[4][0], _e824[4][1]), array<u32, 2>(_e824[5][0], _e824[5][1]));
                                                let _e852 = local_12[(3u + _e711.member_1)];
                                                phi_1302_ = type_21(1u, 3u);
                                                phi_1305_ = array<u32, 2>(_e852[0], _e852[1]);
                                                loop {
                                                    let _e857 = phi_1302_;
                                                    let _e859 = phi_1305_;
                                                    local_21 = _e859;
                                                    local_23 = _e859;
                                                    local_25 = _e859;
                                                    if (_e857.member < _e857.member_1) {
                                                        phi_1303_ = type_21((_e857.member + 1u), _e857.member_1);
                                                        phi_1328_ = type_21(1u, _e857.member);
                                                    } else {
                                                        phi_1303_ = _e857;
                                                        phi_1328_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e871 = phi_1303_;
                                                    let _e873 = phi_1328_;
                                                    let _e877 = (bitcast<i32>(_e873.member) != 0i);
                                                    if _e877 {
                                                        let _e879 = local_17.member[_e873.member_1];
                                                        let _e881 = keys.member[_e879];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e881[0][0], _e881[0][1]), array<u32, 2>(_e881[1][0], _e881[1][1]), array<u32, 2>(_e881[2][0], _e881[2][1]), array<u32, 2>(_e881[3][0], _e881[3][1]), array<u32, 2>(_e881[4][0], _e881[4][1]), array<u32, 2>(_e881[5][0], _e881[5][1]));
                                                        let _e909 = local_13[(3u + _e711.member_1)];
                                                        if (_e909[1] > _e859[1]) {
                                                            phi_1405_ = true;
                                                        } else {
                                                            if (_e909[1] == _e859[1]) {
                                                                phi_1404_ = (_e909[0] > _e859[0]);
                                                            } else {
                                                                phi_1404_ = false;
                                                            }
                                                            let _e920 = phi_1404_;
                                                            phi_1405_ = _e920;
                                                        }
                                                        let _e922 = phi_1405_;
                                                        if _e922 {
                                                            phi_1409_ = array<u32, 2>(_e909[0], _e909[1]);
                                                        } else {
                                                            phi_1409_ = _e859;
                                                        }
                                                        let _e924 = phi_1409_;
                                                        phi_1306_ = _e924;
                                                    } else {
                                                        phi_1306_ = array<u32, 2>();
                                                    }
                                                    let _e926 = phi_1306_;
                                                    continue;
                                                    continuing {
                                                        phi_1302_ = _e871;
                                                        phi_1305_ = _e926;
                                                        break if !(_e877);
                                                    }
                                                }
                                                let _e929 = local_20;
                                                let _e932 = local_21;
                                                if (_e929[1] > _e932[1]) {
                                                    phi_1426_ = true;
                                                } else {
                                                    let _e936 = local_22;
                                                    let _e939 = local_23;
                                                    if (_e936[1] == _e939[1]) {
                                                        let _e943 = local_24;
                                                        let _e946 = local_25;
                                                        phi_1425_ = (_e943[0] > _e946[0]);
                                                    } else {
                                                        phi_1425_ = false;
                                                    }
                                                    let _e950 = phi_1425_;
                                                    phi_1426_ = _e950;
                                                }
                                                let _e952 = phi_1426_;
                                                let _e955 = local_17.member[0u];
                                                let _e957 = keys.member[_e955];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e957[0][0], _e957[0][1]), array<u32, 2>(_e957[1][0], _e957[1][1]), array<u32, 2>(_e957[2][0], _e957[2][1]), array<u32, 2>(_e957[3][0], _e957[3][1]), array<u32, 2>(_e957[4][0], _e957[4][1]), array<u32, 2>(_e957[5][0], _e957[5][1]));
                                                let _e984 = local_10[_e711.member_1];
                                                phi_1477_ = type_21(1u, 3u);
                                                phi_1480_ = array<u32, 2>(_e984[0], _e984[1]);
                                                loop {
                                                    let _e989 = phi_1477_;
                                                    let _e991 = phi_1480_;
                                                    local_26 = _e991;
                                                    local_28 = _e991;
                                                    local_30 = _e991;
                                                    if (_e989.member < _e989.member_1) {
                                                        phi_1478_ = type_21((_e989.member + 1u), _e989.member_1);
                                                        phi_1503_ = type_21(1u, _e989.member);
                                                    } else {
                                                        phi_1478_ = _e989;
                                                        phi_1503_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1003 = phi_1478_;
                                                    let _e1005 = phi_1503_;
                                                    let _e1009 = (bitcast<i32>(_e1005.member) != 0i);
                                                    if _e1009 {
                                                        let _e1011 = local_17.member[_e1005.member_1];
                                                        let _e1013 = keys.member[_e1011];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1013[0][0], _e1013[0][1]), array<u32, 2>(_e1013[1][0], _e1013[1][1]), array<u32, 2>(_e1013[2][0], _e1013[2][1]), array<u32, 2>(_e1013[3][0], _e1013[3][1]), array<u32, 2>(_e1013[4][0], _e1013[4][1]), array<u32, 2>(_e1013[5][0], _e1013[5][1]));
                                                        let _e1040 = local_11[_e711.member_1];
                                                        if (_e991[1] > _e1040[1]) {
                                                            phi_1579_ = true;
                                                        } else {
                                                            if (_e991[1] == _e1040[1]) {
                                                                phi_1578_ = (_e991[0] > _e1040[0]);
                                                            } else {
                                                                phi_1578_ = false;
                                                            }
                                                            let _e1051 = phi_1578_;
                                                            phi_1579_ = _e1051;
                                                        }
                                                        let _e1053 = phi_1579_;
                                                        if _e1053 {
                                                            phi_1583_ = array<u32, 2>(_e1040[0], _e1040[1]);
                                                        } else {
                                                            phi_1583_ = _e991;
                                                        }
                                                        let _e1055 = phi_1583_;
                                                        phi_1481_ = _e1055;
                                                    } else {
                                                        phi_1481_ = array<u32, 2>();
                                                    }
                                                    let _e1057 = phi_1481_;
                                                    continue;
                                                    continuing {
                                                        phi_1477_ = _e1003;
                                                        phi_1480_ = _e1057;
                                                        break if !(_e1009);
                                                    }
                                                }
                                                let _e1060 = local_16.member[0u];
                                                let _e1062 = keys.member[_e1060];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1062[0][0], _e1062[0][1]), array<u32, 2>(_e1062[1][0], _e1062[1][1]), array<u32, 2>(_e1062[2][0], _e1062[2][1]), array<u32, 2>(_e1062[3][0], _e1062[3][1]), array<u32, 2>(_e1062[4][0], _e1062[4][1]), array<u32, 2>(_e1062[5][0], _e1062[5][1]));
                                                let _e1090 = local_8[(3u + _e711.member_1)];
                                                phi_1634_ = type_21(1u, 3u);
                                                phi_1637_ = array<u32, 2>(_e1090[0], _e1090[1]);
                                                loop {
                                                    let _e1095 = phi_1634_;
                                                    let _e1097 = phi_1637_;
                                                    local_27 = _e1097;
                                                    local_29 = _e1097;
                                                    local_31 = _e1097;
                                                    if (_e1095.member < _e1095.member_1) {
                                                        phi_1635_ = type_21((_e1095.member + 1u), _e1095.member_1);
                                                        phi_1660_ = type_21(1u, _e1095.member);
                                                    } else {
                                                        phi_1635_ = _e1095;
                                                        phi_1660_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1109 = phi_1635_;
                                                    let _e1111 = phi_1660_;
                                                    let _e1115 = (bitcast<i32>(_e1111.member) != 0i);
                                                    if _e1115 {
                                                        let _e1117 = local_16.member[_e1111.member_1];
                                                        let _e1119 = keys.member[_e1117];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1119[0][0], _e1119[0][1]), array<u32, 2>(_e1119[1][0], _e1119[1][1]), array<u32, 2>(_e1119[2][0], _e1119[2][1]), array<u32, 2>(_e1119[3][0], _e1119[3][1]), array<u32, 2>(_e1119[4][0], _e1119[4][1]), array<u32, 2>(_e1119[5][0], _e1119[5][1]));
                                                        let _e1147 = local_9[(3u + _e711.member_1)];
                                                        if (_e1147[1] > _e1097[1]) {
                                                            phi_1737_ = true;
                                                        } else {
                                                            if (_e1147[1] == _e1097[1]) {
                                                                phi_1736_ = (_e1147[0] > _e1097[0]);
                                                            } else {
                                                                phi_1736_ = false;
                                                            }
                                                            let _e1158 = phi_1736_;
                                                            phi_1737_ = _e1158;
                                                        }
                                                        let _e1160 = phi_1737_;
                                                        if _e1160 {
                                                            phi_1741_ = array<u32, 2>(_e1147[0], _e1147[1]);
                                                        } else {
                                                            phi_1741_ = _e1097;
                                                        }
                                                        let _e1162 = phi_1741_;
                                                        phi_1638_ = _e1162;
                                                    } else {
                                                        phi_1638_ = array<u32, 2>();
                                                    }
                                                    let _e1164 = phi_1638_;
                                                    continue;
                                                    continuing {
                                                        phi_1634_ = _e1109;
                                                        phi_1637_ = _e1164;
                                                        break if !(_e1115);
                                                    }
                                                }
                                                let _e1167 = local_26;
                                                let _e1170 = local_27;
                                                if (_e1167[1] > _e1170[1]) {
                                                    phi_1758_ = true;
                                                } else {
                                                    let _e1174 = local_28;
                                                    let _e1177 = local_29;
                                                    if (_e1174[1] == _e1177[1]) {
                                                        let _e1181 = local_30;
                                                        let _e1184 = local_31;
                                                        phi_1757_ = (_e1181[0] > _e1184[0]);
                                                    } else {
                                                        phi_1757_ = false;
                                                    }
                                                    let _e1188 = phi_1757_;
                                                    phi_1758_ = _e1188;
                                                }
                                                let _e1190 = phi_1758_;
                                                phi_1066_ = (_e697 && (!(_e952) && !(_e1190)));
                                            } else {
                                                phi_1066_ = bool();
                                            }
                                            let _e1195 = phi_1066_;
                                            continue;
                                            continuing {
                                                phi_1062_ = _e709;
                                                phi_1065_ = _e1195;
                                                break if !(_e715);
                                            }
                                        }
                                        let _e2245 = local_45;
                                        phi_1762_ = _e2245;
                                    }
                                    let _e1198 = phi_1762_;
                                    phi_1763_ = _e1198;
                                    phi_1764_ = _e691;
                                } else {
                                    phi_1763_ = bool();
                                    phi_1764_ = true;
                                }
                                let _e1200 = phi_1763_;
                                let _e1202 = phi_1764_;
                                if _e1202 {
                                    phi_1768_ = false;
                                } else {
                                    phi_1768_ = true;
                                }
                                let _e1204 = phi_1768_;
                                phi_1769_ = _e1200;
                                phi_1770_ = _e1204;
                            } else {
                                phi_1769_ = false;
                                phi_1770_ = true;
                            }
                            let _e1206 = phi_1769_;
                            let _e1208 = phi_1770_;
                            phi_1771_ = _e1206;
                            phi_1772_ = _e1208;
                        } else {
                            phi_1771_ = false;
                            phi_1772_ = true;
                        }
                        let _e1210 = phi_1771_;
                        let _e1212 = phi_1772_;
                        if _e1212 {
                            phi_1776_ = _e1210;
                        } else {
                            phi_1776_ = true;
                        }
                        let _e1214 = phi_1776_;
                        if _e1214 {
                            let _e1216 = params.member.member_16;
                            let _e1219 = local_16.member_1;
                            let _e1221 = local_17.member_1;
                            if (_e99[0] == _e99[1]) {
                                if (_e1219 < _e1221) {
                                    phi_1796_ = type_21(_e1219, _e1221);
                                } else {
                                    phi_1796_ = type_21(_e1221, _e1219);
                                }
                                let _e1227 = phi_1796_;
                                phi_1801_ = _e1227;
                            } else {
                                phi_1801_ = type_21(_e1219, _e1221);
                            }
                            let _e1229 = phi_1801_;
                            let _e1233 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1233 + 1u) < _e1233) {
                                let _e1237 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1233 < _e1216) {
                                atomicStore((&output.member[(4u + (2u * _e1233))]), _e1229.member);
                                atomicStore((&output.member[((2u * _e1233) + 5u)]), _e1229.member_1);
                            }
                            let _e1246 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1246 + 1u) < _e1246) {
                                let _e1250 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1841_ = (_e476 & (_e476 - 1u));
                        phi_1842_ = true;
                    }
                    let _e1252 = phi_1841_;
                    let _e1254 = phi_1842_;
                    phi_769_ = _e1252;
                    phi_1843_ = _e1254;
                } else {
                    phi_769_ = u32();
                    phi_1843_ = false;
                }
                let _e1256 = phi_769_;
                let _e1258 = phi_1843_;
                continue;
                continuing {
                    phi_765_ = _e488;
                    phi_768_ = _e1256;
                    break if !(_e1258);
                }
            }
            workgroupBarrier();
            let _e1261 = atomicLoad((&counters[4u]));
            if (2048u < _e1261) {
                phi_1850_ = 2048u;
            } else {
                phi_1850_ = _e1261;
            }
            let _e1264 = phi_1850_;
            phi_1853_ = type_21(0u, 16u);
            loop {
                let _e1266 = phi_1853_;
                if (_e1266.member < _e1266.member_1) {
                    phi_1854_ = type_21((_e1266.member + 1u), _e1266.member_1);
                    phi_1877_ = type_21(1u, _e1266.member);
                } else {
                    phi_1854_ = _e1266;
                    phi_1877_ = type_21(0u, type_21().member_1);
                }
                let _e1278 = phi_1854_;
                let _e1280 = phi_1877_;
                if (bitcast<i32>(_e1280.member) != 0i) {
                    let _e1286 = (_e70 + (_e1280.member_1 * 128u));
                    if (_e1286 >= _e1264) {
                        phi_2885_ = false;
                    } else {
                        let _e1289 = hits[_e1286];
                        let _e1292 = ((_e1289 >> bitcast<u32>(10i)) & 3u);
                        let _e1299 = firsts[(2u * _e1292)];
                        let _e1300 = (_e1299 + ((_e1289 >> bitcast<u32>(5i)) & 31u));
                        let _e1304 = firsts[((2u * _e1292) + 1u)];
                        let _e1305 = (_e1304 + (_e1289 & 31u));
                        let _e1307 = leaves.member[_e1300];
                        let _e1309 = leaves.member[_e1305];
                        local_18 = type_16(array<u32, 3>(_e1307.member[0], _e1307.member[1], _e1307.member[2]), _e1307.member_1);
                        local_19 = type_16(array<u32, 3>(_e1309.member[0], _e1309.member[1], _e1309.member[2]), _e1309.member_1);
                        let _e1325 = nodes.member[_e1300];
                        let _e1327 = nodes.member[_e1305];
                        let _e1329 = params.member.member_1;
                        if ((_e1329 & 1u) != 0u) {
                            let _e1333 = params.member.member_8;
                            if (_e1333 == 0u) {
                                let _e1377 = local_18.member[0u];
                                let _e1380 = local_19.member[0u];
                                if (_e1377 == _e1380) {
                                    phi_1996_ = bool();
                                    phi_1997_ = true;
                                } else {
                                    let _e1384 = local_18.member[0u];
                                    let _e1387 = local_19.member[1u];
                                    let _e1388 = (_e1384 == _e1387);
                                    if _e1388 {
                                        phi_1995_ = bool();
                                    } else {
                                        let _e1391 = local_18.member[0u];
                                        let _e1394 = local_19.member[2u];
                                        phi_1995_ = (_e1391 == _e1394);
                                    }
                                    let _e1397 = phi_1995_;
                                    phi_1996_ = _e1397;
                                    phi_1997_ = _e1388;
                                }
                                let _e1399 = phi_1996_;
                                let _e1401 = phi_1997_;
                                if _e1401 {
                                    phi_2001_ = true;
                                } else {
                                    phi_2001_ = _e1399;
                                }
                                let _e1403 = phi_2001_;
                                phi_2040_ = _e1403;
                            } else {
                                let _e1337 = local_18.member[0u];
                                let _e1340 = local_19.member[0u];
                                if (_e1337 == _e1340) {
                                    phi_2034_ = bool();
                                    phi_2035_ = true;
                                } else {
                                    let _e1344 = local_18.member[0u];
                                    let _e1347 = local_19.member[1u];
                                    if (_e1344 == _e1347) {
                                        phi_2032_ = bool();
                                        phi_2033_ = true;
                                    } else {
                                        let _e1351 = local_18.member[1u];
                                        let _e1354 = local_19.member[0u];
                                        let _e1355 = (_e1351 == _e1354);
                                        if _e1355 {
                                            phi_2031_ = bool();
                                        } else {
                                            let _e1358 = local_18.member[1u];
                                            let _e1361 = local_19.member[1u];
                                            phi_2031_ = (_e1358 == _e1361);
                                        }
                                        let _e1364 = phi_2031_;
                                        phi_2032_ = _e1364;
                                        phi_2033_ = _e1355;
                                    }
                                    let _e1366 = phi_2032_;
                                    let _e1368 = phi_2033_;
                                    phi_2034_ = _e1366;
                                    phi_2035_ = _e1368;
                                }
                                let _e1370 = phi_2034_;
                                let _e1372 = phi_2035_;
                                if _e1372 {
                                    phi_2039_ = true;
                                } else {
                                    phi_2039_ = _e1370;
                                }
                                let _e1374 = phi_2039_;
                                phi_2040_ = _e1374;
                            }
                            let _e1405 = phi_2040_;
                            if _e1405 {
                                phi_2044_ = false;
                            } else {
                                phi_2044_ = true;
                            }
                            let _e1407 = phi_2044_;
                            phi_2045_ = _e1407;
                        } else {
                            phi_2045_ = true;
                        }
                        let _e1409 = phi_2045_;
                        if _e1409 {
                            let _e1411 = params.member.member_1;
                            if ((_e1411 & 2u) != 0u) {
                                let _e1416 = local_18.member[0u];
                                let _e1418 = bodies.member[_e1416];
                                let _e1421 = local_19.member[0u];
                                let _e1423 = bodies.member[_e1421];
                                if ((_e1418 / 2u) == (_e1423 / 2u)) {
                                    let _e1428 = params.member.member_1;
                                    phi_2091_ = !(((_e1428 & 4u) != 0u));
                                } else {
                                    phi_2091_ = false;
                                }
                                let _e1433 = phi_2091_;
                                if _e1433 {
                                    phi_2102_ = true;
                                } else {
                                    if (((_e1418 & _e1423) & 1u) == 0u) {
                                        phi_2101_ = false;
                                    } else {
                                        phi_2101_ = true;
                                    }
                                    let _e1438 = phi_2101_;
                                    phi_2102_ = _e1438;
                                }
                                let _e1440 = phi_2102_;
                                if _e1440 {
                                    phi_2106_ = false;
                                } else {
                                    phi_2106_ = true;
                                }
                                let _e1442 = phi_2106_;
                                phi_2107_ = _e1442;
                            } else {
                                phi_2107_ = true;
                            }
                            let _e1444 = phi_2107_;
                            if _e1444 {
                                let _e1446 = params.member.member_1;
                                if ((_e1446 & 32u) != 0u) {
                                    let _e1450 = params.member.member_6;
                                    let _e1491 = (((((((_e1325.member_1[0] - _e1327.member[0]) > _e1450) && ((_e1327.member_1[0] - _e1325.member[0]) > _e1450)) && ((_e1325.member_1[1] - _e1327.member[1]) > _e1450)) && ((_e1327.member_1[1] - _e1325.member[1]) > _e1450)) && ((_e1325.member_1[2] - _e1327.member[2]) > _e1450)) && ((_e1327.member_1[2] - _e1325.member[2]) > _e1450));
                                    if _e1491 {
                                        phi_2856_ = bool();
                                    } else {
                                        phi_2156_ = type_21(0u, 3u);
                                        phi_2159_ = true;
                                        loop {
                                            let _e1495 = phi_2156_;
                                            let _e1497 = phi_2159_;
                                            local_46 = _e1497;
                                            if (_e1495.member < _e1495.member_1) {
                                                phi_2157_ = type_21((_e1495.member + 1u), _e1495.member_1);
                                                phi_2182_ = type_21(1u, _e1495.member);
                                            } else {
                                                phi_2157_ = _e1495;
                                                phi_2182_ = type_21(0u, type_21().member_1);
                                            }
                                            let _e1509 = phi_2157_;
                                            let _e1511 = phi_2182_;
                                            let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                                            if _e1515 {
                                                let _e1517 = local_18.member[0u];
                                                let _e1519 = keys.member[_e1517];
                                                local_6 = array<array<u32, 2>, 6>(array<u32, 2>(_e1519[0][0], _e1519[0][1]), array<u32, 2>(_e1519[1][0], _e1519[1][1]), array<u32, 2>(_e1519[2][0], _e1519[2][1]), array<u32, 2>(_e1519[3][0], _e1519[3][1]), array<u32, 2>(_e1519[4][0], _e1519[4][1]), array<u32, 2>(_e1519[5][0], _e1519[5][1]));
                                                let _e1546 = local_6[_e1511.member_1];
                                                phi_2239_ = type_21(1u, 3u);
                                                phi_2242_ = array<u32, 2>(_e1546[0], _e1546[1]);
                                                loop {
                                                    let _e1551 = phi_2239_;
                                                    let _e1553 = phi_2242_;
                                                    local_32 = _e1553;
                                                    local_34 = _e1553;
                                                    local_36 = _e1553;
                                                    if (_e1551.member < _e1551.member_1) {
                                                        phi_2240_ = type_21((_e1551.member + 1u), _e1551.member_1);
                                                        phi_2265_ = type_21(1u, _e1551.member);
                                                    } else {
                                                        phi_2240_ = _e1551;
                                                        phi_2265_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1565 = phi_2240_;
                                                    let _e1567 = phi_2265_;
                                                    let _e1571 = (bitcast<i32>(_e1567.member) != 0i);
                                                    if _e1571 {
                                                        let _e1573 = local_18.member[_e1567.member_1];
                                                        let _e1575 = keys.member[_e1573];
                                                        local_7 = array<array<u32, 2>, 6>(array<u32, 2>(_e1575[0][0], _e1575[0][1]), array<u32, 2>(_e1575[1][0], _e1575[1][1]), array<u32, 2>(_e1575[2][0], _e1575[2][1]), array<u32, 2>(_e1575[3][0], _e1575[3][1]), array<u32, 2>(_e1575[4][0], _e1575[4][1]), array<u32, 2>(_e1575[5][0], _e1575[5][1]));
                                                        let _e1602 = local_7[_e1511.member_1];
                                                        if (_e1553[1] > _e1602[1]) {
                                                            phi_2341_ = true;
                                                        } else {
                                                            if (_e1553[1] == _e1602[1]) {
                                                                phi_2340_ = (_e1553[0] > _e1602[0]);
                                                            } else {
                                                                phi_2340_ = false;
                                                            }
                                                            let _e1613 = phi_2340_;
                                                            phi_2341_ = _e1613;
                                                        }
                                                        let _e1615 = phi_2341_;
                                                        if _e1615 {
                                                            phi_2345_ = array<u32, 2>(_e1602[0], _e1602[1]);
                                                        } else {
                                                            phi_2345_ = _e1553;
                                                        }
                                                        let _e1617 = phi_2345_;
                                                        phi_2243_ = _e1617;
                                                    } else {
                                                        phi_2243_ = array<u32, 2>();
                                                    }
                                                    let _e1619 = phi_2243_;
                                                    continue;
                                                    continuing {
                                                        phi_2239_ = _e1565;
                                                        phi_2242_ = _e1619;
                                                        break if !(_e1571);
                                                    }
                                                }
                                                let _e1622 = local_19.member[0u];
                                                let _e1624 = keys.member[_e1622];
                                                local_4 = array<array<u32, 2>, 6>(array<u32, 2>(_e1624[0][0], _e1624[0][1]), array<u32, 2>(_e1624[1][0], _e1624[1][1]), array<u32, 2>(_e1624[2][0], _e1624[2][1]), array<u32, 2>(_e1624[3][0], _e1624[3][1]), array<u32, 2>(_e1624[4][0], _e1624[4][1]), array<u32, 2>(_e1624[5][0], _e1624[5][1]));
                                                let _e1652 = local_4[(3u + _e1511.member_1)];
                                                phi_2396_ = type_21(1u, 3u);
                                                phi_2399_ = array<u32, 2>(_e1652[0], _e1652[1]);
                                                loop {
                                                    let _e1657 = phi_2396_;
                                                    let _e1659 = phi_2399_;
                                                    local_33 = _e1659;
                                                    local_35 = _e1659;
                                                    local_37 = _e1659;
                                                    if (_e1657.member < _e1657.member_1) {
                                                        phi_2397_ = type_21((_e1657.member + 1u), _e1657.member_1);
                                                        phi_2422_ = type_21(1u, _e1657.member);
                                                    } else {
                                                        phi_2397_ = _e1657;
                                                        phi_2422_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1671 = phi_2397_;
                                                    let _e1673 = phi_2422_;
                                                    let _e1677 = (bitcast<i32>(_e1673.member) != 0i);
                                                    if _e1677 {
                                                        let _e1679 = local_19.member[_e1673.member_1];
                                                        let _e1681 = keys.member[_e1679];
                                                        local_5 = array<array<u32, 2>, 6>(array<u32, 2>(_e1681[0][0], _e1681[0][1]), array<u32, 2>(_e1681[1][0], _e1681[1][1]), array<u32, 2>(_e1681[2][0], _e1681[2][1]), array<u32, 2>(_e1681[3][0], _e1681[3][1]), array<u32, 2>(_e1681[4][0], _e1681[4][1]), array<u32, 2>(_e1681[5][0], _e1681[5][1]));
                                                        let _e1709 = local_5[(3u + _e1511.member_1)];
                                                        if (_e1709[1] > _e1659[1]) {
                                                            phi_2499_ = true;
                                                        } else {
                                                            if (_e1709[1] == _e1659[1]) {
                                                                phi_2498_ = (_e1709[0] > _e1659[0]);
                                                            } else {
                                                                phi_2498_ = false;
                                                            }
                                                            let _e1720 = phi_2498_;
                                                            phi_2499_ = _e1720;
                                                        }
                                                        let _e1722 = phi_2499_;
                                                        if _e1722 {
                                                            phi_2503_ = array<u32, 2>(_e1709[0], _e1709[1]);
                                                        } else {
                                                            phi_2503_ = _e1659;
                                                        }
                                                        let _e1724 = phi_2503_;
                                                        phi_2400_ = _e1724;
                                                    } else {
                                                        phi_2400_ = array<u32, 2>();
                                                    }
                                                    let _e1726 = phi_2400_;
                                                    continue;
                                                    continuing {
                                                        phi_2396_ = _e1671;
                                                        phi_2399_ = _e1726;
                                                        break if !(_e1677);
                                                    }
                                                }
                                                let _e1729 = local_32;
                                                let _e1732 = local_33;
                                                if (_e1729[1] > _e1732[1]) {
                                                    phi_2520_ = true;
                                                } else {
                                                    let _e1736 = local_34;
                                                    let _e1739 = local_35;
                                                    if (_e1736[1] == _e1739[1]) {
                                                        let _e1743 = local_36;
                                                        let _e1746 = local_37;
                                                        phi_2519_ = (_e1743[0] > _e1746[0]);
                                                    } else {
                                                        phi_2519_ = false;
                                                    }
                                                    let _e1750 = phi_2519_;
                                                    phi_2520_ = _e1750;
                                                }
                                                let _e1752 = phi_2520_;
                                                let _e1755 = local_19.member[0u];
                                                let _e1757 = keys.member[_e1755];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e1757[0][0], _e1757[0][1]), array<u32, 2>(_e1757[1][0], _e1757[1][1]), array<u32, 2>(_e1757[2][0], _e1757[2][1]), array<u32, 2>(_e1757[3][0], _e1757[3][1]), array<u32, 2>(_e1757[4][0], _e1757[4][1]), array<u32, 2>(_e1757[5][0], _e1757[5][1]));
                                                let _e1784 = local_2[_e1511.member_1];
                                                phi_2571_ = type_21(1u, 3u);
                                                phi_2574_ = array<u32, 2>(_e1784[0], _e1784[1]);
                                                loop {
                                                    let _e1789 = phi_2571_;
                                                    let _e1791 = phi_2574_;
                                                    local_38 = _e1791;
                                                    local_40 = _e1791;
                                                    local_42 = _e1791;
                                                    if (_e1789.member < _e1789.member_1) {
                                                        phi_2572_ = type_21((_e1789.member + 1u), _e1789.member_1);
                                                        phi_2597_ = type_21(1u, _e1789.member);
                                                    } else {
                                                        phi_2572_ = _e1789;
                                                        phi_2597_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1803 = phi_2572_;
                                                    let _e1805 = phi_2597_;
                                                    let _e1809 = (bitcast<i32>(_e1805.member) != 0i);
                                                    if _e1809 {
                                                        let _e1811 = local_19.member[_e1805.member_1];
                                                        let _e1813 = keys.member[_e1811];
                                                        local_3 = array<array<u32, 2>, 6>(array<u32, 2>(_e1813[0][0], _e1813[0][1]), array<u32, 2>(_e1813[1][0], _e1813[1][1]), array<u32, 2>(_e1813[2][0], _e1813[2][1]), array<u32, 2>(_e1813[3][0], _e1813[3][1]), array<u32, 2>(_e1813[4][0], _e1813[4][1]), array<u32, 2>(_e1813[5][0], _e1813[5][1]));
                                                        let _e1840 = local_3[_e1511.member_1];
                                                        if (_e1791[1] > _e1840[1]) {
                                                            phi_2673_ = true;
                                                        } else {
                                                            if (_e1791[1] == _e1840[1]) {
                                                                phi_2672_ = (_e1791[0] > _e1840[0]);
                                                            } else {
                                                                phi_2672_ = false;
                                                            }
                                                            let _e1851 = phi_2672_;
                                                            phi_2673_ = _e1851;
                                                        }
                                                        let _e1853 = phi_2673_;
                                                        if _e1853 {
                                                            phi_2677_ = array<u32, 2>(_e1840[0], _e1840[1]);
                                                        } else {
                                                            phi_2677_ = _e1791;
                                                        }
                                                        let _e1855 = phi_2677_;
                                                        phi_2575_ = _e1855;
                                                    } else {
                                                        phi_2575_ = array<u32, 2>();
                                                    }
                                                    let _e1857 = phi_2575_;
                                                    continue;
                                                    continuing {
                                                        phi_2571_ = _e1803;
                                                        phi_2574_ = _e1857;
                                                        break if !(_e1809);
                                                    }
                                                }
                                                let _e1860 = local_18.member[0u];
                                                let _e1862 = keys.member[_e1860];
                                                local = array<array<u32, 2>, 6>(array<u32, 2>(_e1862[0][0], _e1862[0][1]), array<u32, 2>(_e1862[1][0], _e1862[1][1]), array<u32, 2>(_e1862[2][0], _e1862[2][1]), array<u32, 2>(_e1862[3][0], _e1862[3][1]), array<u32, 2>(_e1862[4][0], _e1862[4][1]), array<u32, 2>(_e1862[5][0], _e1862[5][1]));
                                                let _e1890 = local[(3u + _e1511.member_1)];
                                                phi_2728_ = type_21(1u, 3u);
                                                phi_2731_ = array<u32, 2>(_e1890[0], _e1890[1]);
                                                loop {
                                                    let _e1895 = phi_2728_;
                                                    let _e1897 = phi_2731_;
                                                    local_39 = _e1897;
                                                    local_41 = _e1897;
                                                    local_43 = _e1897;
                                                    if (_e1895.member < _e1895.member_1) {
                                                        phi_2729_ = type_21((_e1895.member + 1u), _e1895.member_1);
                                                        phi_2754_ = type_21(1u, _e1895.member);
                                                    } else {
                                                        phi_2729_ = _e1895;
                                                        phi_2754_ = type_21(0u, type_21().member_1);
                                                    }
                                                    let _e1909 = phi_2729_;
                                                    let _e1911 = phi_2754_;
                                                    let _e1915 = (bitcast<i32>(_e1911.member) != 0i);
                                                    if _e1915 {
                                                        let _e1917 = local_18.member[_e1911.member_1];
                                                        let _e1919 = keys.member[_e1917];
                                                        local_1 = array<array<u32, 2>, 6>(array<u32, 2>(_e1919[0][0], _e1919[0][1]), array<u32, 2>(_e1919[1][0], _e1919[1][1]), array<u32, 2>(_e1919[2][0], _e1919[2][1]), array<u32, 2>(_e1919[3][0], _e1919[3][1]), array<u32, 2>(_e1919[4][0], _e1919[4][1]), array<u32, 2>(_e1919[5][0], _e1919[5][1]));
                                                        let _e1947 = local_1[(3u + _e1511.member_1)];
                                                        if (_e1947[1] > _e1897[1]) {
                                                            phi_2831_ = true;
                                                        } else {
                                                            if (_e1947[1] == _e1897[1]) {
                                                                phi_2830_ = (_e1947[0] > _e1897[0]);
                                                            } else {
                                                                phi_2830_ = false;
                                                            }
                                                            let _e1958 = phi_2830_;
                                                            phi_2831_ = _e1958;
                                                        }
                                                        let _e1960 = phi_2831_;
                                                        if _e1960 {
                                                            phi_2835_ = array<u32, 2>(_e1947[0], _e1947[1]);
                                                        } else {
                                                            phi_2835_ = _e1897;
                                                        }
                                                        let _e1962 = phi_2835_;
                                                        phi_2732_ = _e1962;
                                                    } else {
                                                        phi_2732_ = array<u32, 2>();
                                                    }
                                                    let _e1964 = phi_2732_;
                                                    continue;
                                                    continuing {
                                                        phi_2728_ = _e1909;
                                                        phi_2731_ = _e1964;
                                                        break if !(_e1915);
                                                    }
                                                }
                                                let _e1967 = local_38;
                                                let _e1970 = local_39;
                                                if (_e1967[1] > _e1970[1]) {
                                                    phi_2852_ = true;
                                                } else {
                                                    let _e1974 = local_40;
                                                    let _e1977 = local_41;
                                                    if (_e1974[1] == _e1977[1]) {
                                                        let _e1981 = local_42;
                                                        let _e1984 = local_43;
                                                        phi_2851_ = (_e1981[0] > _e1984[0]);
                                                    } else {
                                                        phi_2851_ = false;
                                                    }
                                                    let _e1988 = phi_2851_;
                                                    phi_2852_ = _e1988;
                                                }
                                                let _e1990 = phi_2852_;
                                                phi_2160_ = (_e1497 && (!(_e1752) && !(_e1990)));
                                            } else {
                                                phi_2160_ = bool();
                                            }
                                            let _e1995 = phi_2160_;
                                            continue;
                                            continuing {
                                                phi_2156_ = _e1509;
                                                phi_2159_ = _e1995;
                                                break if !(_e1515);
                                            }
                                        }
                                        let _e2337 = local_46;
                                        phi_2856_ = _e2337;
                                    }
                                    let _e1998 = phi_2856_;
                                    phi_2857_ = _e1998;
                                    phi_2858_ = _e1491;
                                } else {
                                    phi_2857_ = bool();
                                    phi_2858_ = true;
                                }
                                let _e2000 = phi_2857_;
                                let _e2002 = phi_2858_;
                                if _e2002 {
                                    phi_2862_ = false;
                                } else {
                                    phi_2862_ = true;
                                }
                                let _e2004 = phi_2862_;
                                phi_2863_ = _e2000;
                                phi_2864_ = _e2004;
                            } else {
                                phi_2863_ = false;
                                phi_2864_ = true;
                            }
                            let _e2006 = phi_2863_;
                            let _e2008 = phi_2864_;
                            phi_2865_ = _e2006;
                            phi_2866_ = _e2008;
                        } else {
                            phi_2865_ = false;
                            phi_2866_ = true;
                        }
                        let _e2010 = phi_2865_;
                        let _e2012 = phi_2866_;
                        if _e2012 {
                            phi_2870_ = _e2010;
                        } else {
                            phi_2870_ = true;
                        }
                        let _e2014 = phi_2870_;
                        if _e2014 {
                            let _e2016 = atomicAdd((&counters[7u]), 1u);
                            let _e2018 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1286] = ((2147483648u | (_e2018 << bitcast<u32>(12i))) | _e1289);
                        }
                        phi_2885_ = true;
                    }
                    let _e2025 = phi_2885_;
                    phi_2886_ = _e2025;
                } else {
                    phi_2886_ = false;
                }
                let _e2027 = phi_2886_;
                continue;
                continuing {
                    phi_1853_ = _e1278;
                    break if !(_e2027);
                }
            }
            workgroupBarrier();
            if (_e70 == 0u) {
                let _e2031 = atomicLoad((&counters[5u]));
                if (_e2031 > 0u) {
                    let _e2034 = atomicAdd((&output.member[0u]), _e2031);
                    if ((_e2034 + _e2031) < _e2034) {
                        let _e2038 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e2034);
                }
            }
            workgroupBarrier();
            let _e2041 = atomicLoad((&counters[6u]));
            if (_e70 == 0u) {
                let _e2044 = atomicLoad((&counters[7u]));
                if (_e2044 > 0u) {
                    let _e2047 = atomicAdd((&output.member[1u]), _e2044);
                    if ((_e2047 + _e2044) < _e2047) {
                        let _e2051 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2936_ = type_21(0u, 16u);
            loop {
                let _e2053 = phi_2936_;
                if (_e2053.member < _e2053.member_1) {
                    phi_2937_ = type_21((_e2053.member + 1u), _e2053.member_1);
                    phi_2960_ = type_21(1u, _e2053.member);
                } else {
                    phi_2937_ = _e2053;
                    phi_2960_ = type_21(0u, type_21().member_1);
                }
                let _e2065 = phi_2937_;
                let _e2067 = phi_2960_;
                if (bitcast<i32>(_e2067.member) != 0i) {
                    let _e2073 = (_e70 + (_e2067.member_1 * 128u));
                    if (_e2073 >= _e1264) {
                        phi_3058_ = false;
                    } else {
                        let _e2076 = hits[_e2073];
                        if ((_e2076 & 2147483648u) == 0u) {
                            phi_2983_ = 4294967295u;
                        } else {
                            phi_2983_ = ((_e2076 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e2083 = phi_2983_;
                        if (_e2083 != 4294967295u) {
                            let _e2087 = ((_e2076 >> bitcast<u32>(10i)) & 3u);
                            let _e2094 = firsts[(2u * _e2087)];
                            let _e2097 = leaves.member[(_e2094 + ((_e2076 >> bitcast<u32>(5i)) & 31u))];
                            let _e2101 = firsts[((2u * _e2087) + 1u)];
                            let _e2104 = leaves.member[(_e2101 + (_e2076 & 31u))];
                            let _e2108 = params.member.member_16;
                            let _e2109 = (_e2041 + _e2083);
                            if (_e99[0] == _e99[1]) {
                                if (_e2097.member_1 < _e2104.member_1) {
                                    phi_3037_ = type_21(_e2097.member_1, _e2104.member_1);
                                } else {
                                    phi_3037_ = type_21(_e2104.member_1, _e2097.member_1);
                                }
                                let _e2116 = phi_3037_;
                                phi_3042_ = _e2116;
                            } else {
                                phi_3042_ = type_21(_e2097.member_1, _e2104.member_1);
                            }
                            let _e2118 = phi_3042_;
                            if (_e2109 < _e2108) {
                                atomicStore((&output.member[(4u + (2u * _e2109))]), _e2118.member);
                                atomicStore((&output.member[((2u * _e2109) + 5u)]), _e2118.member_1);
                            }
                        }
                        phi_3058_ = true;
                    }
                    let _e2129 = phi_3058_;
                    phi_3059_ = _e2129;
                } else {
                    phi_3059_ = false;
                }
                let _e2131 = phi_3059_;
                continue;
                continuing {
                    phi_2936_ = _e2065;
                    break if !(_e2131);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_273_ = _e157;
            break if !(_e163);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
