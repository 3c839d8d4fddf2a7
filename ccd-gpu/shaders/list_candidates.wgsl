struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
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

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_22 {
    member: array<u32>,
}

struct type_24 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_24>,
}

struct type_36 {
    member: u32,
    member_1: u32,
}

struct type_45 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_62 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> nodes: type_18;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_6, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_27;
@group(0) @binding(3) 
var<storage> bodies: type_22;
@group(0) @binding(4) 
var<storage> keys: type_45;
@group(0) @binding(5) 
var<storage> input: type_22;
@group(0) @binding(6) 
var<storage, read_write> output: type_62;

fn function_() {
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
    var local_16: type_24;
    var local_17: type_24;
    var local_18: type_24;
    var local_19: type_24;
    var phi_184_: u32;
    var phi_195_: array<u32, 2>;
    var phi_224_: u32;
    var phi_225_: u32;
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_36;
    var phi_274_: type_36;
    var phi_297_: type_36;
    var phi_335_: u32;
    var phi_336_: u32;
    var phi_343_: u32;
    var phi_353_: u32;
    var phi_432_: array<u32, 2>;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_631_: type_6;
    var phi_637_: bool;
    var phi_644_: type_36;
    var phi_647_: u32;
    var phi_645_: type_36;
    var phi_670_: type_36;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_742_: bool;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_762_: u32;
    var phi_648_: u32;
    var phi_765_: type_36;
    var phi_768_: u32;
    var phi_766_: type_36;
    var phi_791_: type_36;
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
    var phi_1062_: type_36;
    var phi_1065_: bool;
    var phi_1063_: type_36;
    var phi_1088_: type_36;
    var phi_1145_: type_36;
    var phi_1148_: array<u32, 2>;
    var phi_1146_: type_36;
    var phi_1171_: type_36;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1251_: array<u32, 2>;
    var phi_1149_: array<u32, 2>;
    var phi_1302_: type_36;
    var phi_1305_: array<u32, 2>;
    var phi_1303_: type_36;
    var phi_1328_: type_36;
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
    var phi_1477_: type_36;
    var phi_1480_: array<u32, 2>;
    var phi_1478_: type_36;
    var phi_1503_: type_36;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1583_: array<u32, 2>;
    var phi_1481_: array<u32, 2>;
    var phi_1634_: type_36;
    var phi_1637_: array<u32, 2>;
    var phi_1635_: type_36;
    var phi_1660_: type_36;
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
    var phi_1796_: type_36;
    var phi_1801_: type_36;
    var phi_1841_: u32;
    var phi_1842_: bool;
    var phi_769_: u32;
    var phi_1843_: bool;
    var phi_1850_: u32;
    var phi_1853_: type_36;
    var phi_1854_: type_36;
    var phi_1877_: type_36;
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
    var phi_2156_: type_36;
    var phi_2159_: bool;
    var phi_2157_: type_36;
    var phi_2182_: type_36;
    var phi_2239_: type_36;
    var phi_2242_: array<u32, 2>;
    var phi_2240_: type_36;
    var phi_2265_: type_36;
    var phi_2340_: bool;
    var phi_2341_: bool;
    var phi_2345_: array<u32, 2>;
    var phi_2243_: array<u32, 2>;
    var phi_2396_: type_36;
    var phi_2399_: array<u32, 2>;
    var phi_2397_: type_36;
    var phi_2422_: type_36;
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
    var phi_2571_: type_36;
    var phi_2574_: array<u32, 2>;
    var phi_2572_: type_36;
    var phi_2597_: type_36;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: array<u32, 2>;
    var phi_2575_: array<u32, 2>;
    var phi_2728_: type_36;
    var phi_2731_: array<u32, 2>;
    var phi_2729_: type_36;
    var phi_2754_: type_36;
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
    var phi_2936_: type_36;
    var phi_2937_: type_36;
    var phi_2960_: type_36;
    var phi_2983_: u32;
    var phi_3037_: type_36;
    var phi_3042_: type_36;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var local_44: u32;
    var local_45: bool;
    var local_46: bool;

    let _e81 = id_1;
    let _e82 = n_1;
    let _e83 = lane_1;
    let _e95 = ((_e81.y * _e82.x) + _e81.x);
    let _e98 = (_e82.x * _e82.y);
    let _e100 = params.member.member_15;
    let _e102 = input.member[0u];
    if (_e100 < _e102) {
        phi_184_ = _e100;
    } else {
        phi_184_ = _e102;
    }
    let _e105 = phi_184_;
    let _e106 = (_e83 / 32u);
    let _e107 = (_e83 % 32u);
    let _e109 = params.member.member_8;
    if (_e109 == 0u) {
        phi_195_ = array<u32, 2>(0u, 2u);
    } else {
        phi_195_ = array<u32, 2>(1u, 1u);
    }
    let _e112 = phi_195_;
    let _e116 = params.member.member_12;
    if (_e105 > _e116) {
        let _e119 = params.member.member_12;
        let _e120 = (_e105 - _e119);
        let _e122 = params.member.member_13;
        if (_e122 == 0u) {
            return;
        }
        let _e124 = (_e120 / _e122);
        if (_e122 == 0u) {
            return;
        }
        if ((_e120 % _e122) > 0u) {
            phi_224_ = (_e124 + 1u);
        } else {
            phi_224_ = _e124;
        }
        let _e130 = phi_224_;
        phi_225_ = _e130;
    } else {
        phi_225_ = 0u;
    }
    let _e132 = phi_225_;
    let _e134 = params.member.member_14;
    if (_e134 < _e132) {
        phi_232_ = _e134;
    } else {
        phi_232_ = _e132;
    }
    let _e137 = phi_232_;
    let _e138 = (_e137 / 4u);
    if ((_e137 % 4u) > 0u) {
        phi_248_ = (_e138 + 1u);
    } else {
        phi_248_ = _e138;
    }
    let _e143 = phi_248_;
    if (_e143 > _e95) {
        let _e145 = (_e143 - _e95);
        if (_e98 == 0u) {
            return;
        }
        let _e147 = (_e145 / _e98);
        if (_e98 == 0u) {
            return;
        }
        if ((_e145 % _e98) > 0u) {
            phi_269_ = (_e147 + 1u);
        } else {
            phi_269_ = _e147;
        }
        let _e153 = phi_269_;
        phi_270_ = _e153;
    } else {
        phi_270_ = 0u;
    }
    let _e155 = phi_270_;
    phi_273_ = type_36(0u, _e155);
    loop {
        let _e158 = phi_273_;
        if (_e158.member < _e158.member_1) {
            phi_274_ = type_36((_e158.member + 1u), _e158.member_1);
            phi_297_ = type_36(1u, _e158.member);
        } else {
            phi_274_ = _e158;
            phi_297_ = type_36(0u, type_36().member_1);
        }
        let _e172 = phi_274_;
        let _e174 = phi_297_;
        let _e178 = (bitcast<i32>(_e174.member) != 0i);
        if _e178 {
            let _e182 = (((_e95 + (_e174.member_1 * _e98)) * 4u) + _e106);
            let _e184 = params.member.member_12;
            if (_e105 > _e184) {
                let _e187 = params.member.member_12;
                let _e188 = (_e105 - _e187);
                let _e190 = params.member.member_13;
                if (_e190 == 0u) {
                    return;
                }
                let _e192 = (_e188 / _e190);
                if (_e190 == 0u) {
                    return;
                }
                if ((_e188 % _e190) > 0u) {
                    phi_335_ = (_e192 + 1u);
                } else {
                    phi_335_ = _e192;
                }
                let _e198 = phi_335_;
                phi_336_ = _e198;
            } else {
                phi_336_ = 0u;
            }
            let _e200 = phi_336_;
            let _e202 = params.member.member_14;
            if (_e202 < _e200) {
                phi_343_ = _e202;
            } else {
                phi_343_ = _e200;
            }
            let _e205 = phi_343_;
            let _e206 = (_e182 < _e205);
            let _e208 = params.member.member_12;
            if _e206 {
                let _e210 = params.member.member_13;
                phi_353_ = (_e182 * _e210);
            } else {
                phi_353_ = 0u;
            }
            let _e213 = phi_353_;
            let _e215 = (2u * (_e208 + _e213));
            let _e218 = input.member[(4u + _e215)];
            let _e221 = input.member[(_e215 + 5u)];
            if (_e83 < 8u) {
                atomicStore((&counters[_e83]), 0u);
            }
            workgroupBarrier();
            if (_e112[0] < 4u) {
            } else {
                return;
            }
            let _e229 = params.member.member_20[0u][_e112[0]];
            let _e230 = (_e229 + (_e218 * 32u));
            if (_e112[1] < 4u) {
            } else {
                return;
            }
            let _e236 = params.member.member_20[0u][_e112[1]];
            let _e237 = (_e236 + (_e221 * 32u));
            if (_e107 == 0u) {
                firsts[(2u * _e106)] = _e230;
                firsts[((2u * _e106) + 1u)] = _e237;
            }
            let _e245 = params.member.member_8;
            if (_e245 == 0u) {
                phi_432_ = array<u32, 2>(0u, 2u);
            } else {
                phi_432_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_432_;
            let _e251 = (_e83 / 32u);
            let _e252 = (_e83 % 32u);
            let _e254 = params.member.member_9;
            if (_e254 < 8u) {
            } else {
                return;
            }
            if (_e248[0] < 4u) {
            } else {
                return;
            }
            let _e260 = params.member.member_20[_e254][_e248[0]];
            let _e263 = nodes.member[(_e260 + _e218)];
            let _e265 = params.member.member_9;
            if (_e265 < 8u) {
            } else {
                return;
            }
            if (_e248[1] < 4u) {
            } else {
                return;
            }
            let _e271 = params.member.member_20[_e265][_e248[1]];
            let _e274 = nodes.member[(_e271 + _e221)];
            let _e276 = params.member.member_9;
            let _e277 = (_e276 - 1u);
            if (_e277 < 8u) {
            } else {
                return;
            }
            if (_e248[0] < 4u) {
            } else {
                return;
            }
            let _e285 = params.member.member_20[_e277][_e248[0]];
            let _e288 = nodes.member[(_e285 + ((_e218 * 32u) + _e252))];
            let _e290 = params.member.member_9;
            let _e291 = (_e290 - 1u);
            if (_e291 < 8u) {
            } else {
                return;
            }
            if (_e248[1] < 4u) {
            } else {
                return;
            }
            let _e299 = params.member.member_20[_e291][_e248[1]];
            let _e302 = nodes.member[(_e299 + ((_e221 * 32u) + _e252))];
            if _e206 {
                if ((((((_e302.member[0] <= _e263.member_1[0]) && (_e263.member[0] <= _e302.member_1[0])) && (_e302.member[1] <= _e263.member_1[1])) && (_e263.member[1] <= _e302.member_1[1])) && (_e302.member[2] <= _e263.member_1[2])) && (_e263.member[2] <= _e302.member_1[2])) {
                    let _e340 = atomicAdd((&counters[_e251]), 1u);
                    let _e341 = ((_e251 * 32u) + _e340);
                    columns[_e341] = type_6(array<f32, 3>(_e302.member[0], _e302.member[1], _e302.member[2]), array<f32, 3>(_e302.member_1[0], _e302.member_1[1], _e302.member_1[2]));
                    names[_e341] = _e252;
                }
            }
            workgroupBarrier();
            if _e206 {
                if ((((((_e288.member[0] <= _e274.member_1[0]) && (_e274.member[0] <= _e288.member_1[0])) && (_e288.member[1] <= _e274.member_1[1])) && (_e274.member[1] <= _e288.member_1[1])) && (_e288.member[2] <= _e274.member_1[2])) && (_e274.member[2] <= _e288.member_1[2])) {
                    phi_626_ = false;
                } else {
                    phi_626_ = true;
                }
                let _e391 = phi_626_;
                phi_627_ = _e391;
            } else {
                phi_627_ = true;
            }
            let _e393 = phi_627_;
            if _e393 {
                phi_631_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_631_ = _e288;
            }
            let _e395 = phi_631_;
            if (_e112[0] == _e112[1]) {
                phi_637_ = (_e218 == _e221);
            } else {
                phi_637_ = false;
            }
            let _e399 = phi_637_;
            let _e400 = (_e83 / 32u);
            let _e401 = (_e83 % 32u);
            let _e403 = atomicLoad((&counters[_e400]));
            phi_644_ = type_36(0u, _e403);
            phi_647_ = 0u;
            loop {
                let _e406 = phi_644_;
                let _e408 = phi_647_;
                local_44 = _e408;
                if (_e406.member < _e406.member_1) {
                    phi_645_ = type_36((_e406.member + 1u), _e406.member_1);
                    phi_670_ = type_36(1u, _e406.member);
                } else {
                    phi_645_ = _e406;
                    phi_670_ = type_36(0u, type_36().member_1);
                }
                let _e422 = phi_645_;
                let _e424 = phi_670_;
                let _e428 = (bitcast<i32>(_e424.member) != 0i);
                if _e428 {
                    let _e432 = names[((_e400 * 32u) + _e424.member_1)];
                    let _e436 = columns[((_e400 * 32u) + _e424.member_1)];
                    if ((((((_e395.member[0] <= _e436.member_1[0]) && (_e436.member[0] <= _e395.member_1[0])) && (_e395.member[1] <= _e436.member_1[1])) && (_e436.member[1] <= _e395.member_1[1])) && (_e395.member[2] <= _e436.member_1[2])) && (_e436.member[2] <= _e395.member_1[2])) {
                        if _e399 {
                            let _e468 = (_e401 < _e432);
                            if _e468 {
                                phi_736_ = bool();
                            } else {
                                phi_736_ = false;
                            }
                            let _e470 = phi_736_;
                            phi_737_ = _e470;
                            phi_738_ = _e468;
                        } else {
                            phi_737_ = bool();
                            phi_738_ = true;
                        }
                        let _e472 = phi_737_;
                        let _e474 = phi_738_;
                        if _e474 {
                            phi_742_ = true;
                        } else {
                            phi_742_ = _e472;
                        }
                        let _e476 = phi_742_;
                        if _e476 {
                            let _e478 = atomicAdd((&counters[4u]), 1u);
                            if (_e478 < 2048u) {
                                hits[_e478] = (((_e400 << bitcast<u32>(10i)) | (_e401 << bitcast<u32>(5i))) | _e432);
                                phi_760_ = _e408;
                            } else {
                                phi_760_ = (_e408 | (1u << bitcast<u32>((_e424.member_1 & 31u))));
                            }
                            let _e492 = phi_760_;
                            phi_761_ = _e492;
                        } else {
                            phi_761_ = _e408;
                        }
                        let _e494 = phi_761_;
                        phi_762_ = _e494;
                    } else {
                        phi_762_ = _e408;
                    }
                    let _e496 = phi_762_;
                    phi_648_ = _e496;
                } else {
                    phi_648_ = u32();
                }
                let _e498 = phi_648_;
                continue;
                continuing {
                    phi_644_ = _e422;
                    phi_647_ = _e498;
                    break if !(_e428);
                }
            }
            phi_765_ = type_36(0u, 32u);
            let _e2246 = local_44;
            phi_768_ = _e2246;
            loop {
                let _e501 = phi_765_;
                let _e503 = phi_768_;
                if (_e501.member < _e501.member_1) {
                    phi_766_ = type_36((_e501.member + 1u), _e501.member_1);
                    phi_791_ = type_36(1u, _e501.member);
                } else {
                    phi_766_ = _e501;
                    phi_791_ = type_36(0u, type_36().member_1);
                }
                let _e517 = phi_766_;
                let _e519 = phi_791_;
                if (bitcast<i32>(_e519.member) != 0i) {
                    if (_e503 == 0u) {
                        phi_1841_ = u32();
                        phi_1842_ = false;
                    } else {
                        let _e530 = names[((_e106 * 32u) + select(firstTrailingBit(_e503), 32u, (_e503 == 0u)))];
                        let _e533 = (_e230 + _e107);
                        let _e534 = (_e237 + _e530);
                        let _e536 = leaves.member[_e533];
                        let _e538 = leaves.member[_e534];
                        local_16 = type_24(array<u32, 3>(_e536.member[0], _e536.member[1], _e536.member[2]), _e536.member_1);
                        local_17 = type_24(array<u32, 3>(_e538.member[0], _e538.member[1], _e538.member[2]), _e538.member_1);
                        let _e554 = nodes.member[_e533];
                        let _e556 = nodes.member[_e534];
                        let _e558 = params.member.member_1;
                        if ((_e558 & 1u) != 0u) {
                            let _e562 = params.member.member_8;
                            if (_e562 == 0u) {
                                let _e606 = local_16.member[0u];
                                let _e609 = local_17.member[0u];
                                if (_e606 == _e609) {
                                    phi_902_ = bool();
                                    phi_903_ = true;
                                } else {
                                    let _e613 = local_16.member[0u];
                                    let _e616 = local_17.member[1u];
                                    let _e617 = (_e613 == _e616);
                                    if _e617 {
                                        phi_901_ = bool();
                                    } else {
                                        let _e620 = local_16.member[0u];
                                        let _e623 = local_17.member[2u];
                                        phi_901_ = (_e620 == _e623);
                                    }
                                    let _e626 = phi_901_;
                                    phi_902_ = _e626;
                                    phi_903_ = _e617;
                                }
                                let _e628 = phi_902_;
                                let _e630 = phi_903_;
                                if _e630 {
                                    phi_907_ = true;
                                } else {
                                    phi_907_ = _e628;
                                }
                                let _e632 = phi_907_;
                                phi_946_ = _e632;
                            } else {
                                let _e566 = local_16.member[0u];
                                let _e569 = local_17.member[0u];
                                if (_e566 == _e569) {
                                    phi_940_ = bool();
                                    phi_941_ = true;
                                } else {
                                    let _e573 = local_16.member[0u];
                                    let _e576 = local_17.member[1u];
                                    if (_e573 == _e576) {
                                        phi_938_ = bool();
                                        phi_939_ = true;
                                    } else {
                                        let _e580 = local_16.member[1u];
                                        let _e583 = local_17.member[0u];
                                        let _e584 = (_e580 == _e583);
                                        if _e584 {
                                            phi_937_ = bool();
                                        } else {
                                            let _e587 = local_16.member[1u];
                                            let _e590 = local_17.member[1u];
                                            phi_937_ = (_e587 == _e590);
                                        }
                                        let _e593 = phi_937_;
                                        phi_938_ = _e593;
                                        phi_939_ = _e584;
                                    }
                                    let _e595 = phi_938_;
                                    let _e597 = phi_939_;
                                    phi_940_ = _e595;
                                    phi_941_ = _e597;
                                }
                                let _e599 = phi_940_;
                                let _e601 = phi_941_;
                                if _e601 {
                                    phi_945_ = true;
                                } else {
                                    phi_945_ = _e599;
                                }
                                let _e603 = phi_945_;
                                phi_946_ = _e603;
                            }
                            let _e634 = phi_946_;
                            if _e634 {
                                phi_950_ = false;
                            } else {
                                phi_950_ = true;
                            }
                            let _e636 = phi_950_;
                            phi_951_ = _e636;
                        } else {
                            phi_951_ = true;
                        }
                        let _e638 = phi_951_;
                        if _e638 {
                            let _e640 = params.member.member_1;
                            if ((_e640 & 2u) != 0u) {
                                let _e645 = local_16.member[0u];
                                let _e647 = bodies.member[_e645];
                                let _e650 = local_17.member[0u];
                                let _e652 = bodies.member[_e650];
                                if ((_e647 / 2u) == (_e652 / 2u)) {
                                    let _e657 = params.member.member_1;
                                    phi_997_ = !(((_e657 & 4u) != 0u));
                                } else {
                                    phi_997_ = false;
                                }
                                let _e662 = phi_997_;
                                if _e662 {
                                    phi_1008_ = true;
                                } else {
                                    if (((_e647 & _e652) & 1u) == 0u) {
                                        phi_1007_ = false;
                                    } else {
                                        phi_1007_ = true;
                                    }
                                    let _e667 = phi_1007_;
                                    phi_1008_ = _e667;
                                }
                                let _e669 = phi_1008_;
                                if _e669 {
                                    phi_1012_ = false;
                                } else {
                                    phi_1012_ = true;
                                }
                                let _e671 = phi_1012_;
                                phi_1013_ = _e671;
                            } else {
                                phi_1013_ = true;
                            }
                            let _e673 = phi_1013_;
                            if _e673 {
                                let _e675 = params.member.member_1;
                                if ((_e675 & 32u) != 0u) {
                                    let _e679 = params.member.member_6;
                                    let _e720 = (((((((_e554.member_1[0] - _e556.member[0]) > _e679) && ((_e556.member_1[0] - _e554.member[0]) > _e679)) && ((_e554.member_1[1] - _e556.member[1]) > _e679)) && ((_e556.member_1[1] - _e554.member[1]) > _e679)) && ((_e554.member_1[2] - _e556.member[2]) > _e679)) && ((_e556.member_1[2] - _e554.member[2]) > _e679));
                                    if _e720 {
                                        phi_1762_ = bool();
                                    } else {
                                        phi_1062_ = type_36(0u, 3u);
                                        phi_1065_ = true;
                                        loop {
                                            let _e724 = phi_1062_;
                                            let _e726 = phi_1065_;
                                            local_45 = _e726;
                                            if (_e724.member < _e724.member_1) {
                                                phi_1063_ = type_36((_e724.member + 1u), _e724.member_1);
                                                phi_1088_ = type_36(1u, _e724.member);
                                            } else {
                                                phi_1063_ = _e724;
                                                phi_1088_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e740 = phi_1063_;
                                            let _e742 = phi_1088_;
                                            let _e746 = (bitcast<i32>(_e742.member) != 0i);
                                            if _e746 {
                                                let _e748 = local_16.member[0u];
                                                let _e750 = keys.member[_e748];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e750[0][0], _e750[0][1]), array<u32, 2>(_e750[1][0], _e750[1][1]), array<u32, 2>(_e750[2][0], _e750[2][1]), array<u32, 2>(_e750[3][0], _e750[3][1]), array<u32, 2>(_e750[4][0], _e750[4][1]), array<u32, 2>(_e750[5][0], _e750[5][1]));
                                                if (_e742.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e778 = local_14[_e742.member_1];
                                                phi_1145_ = type_36(1u, 3u);
                                                phi_1148_ = array<u32, 2>(_e778[0], _e778[1]);
                                                loop {
                                                    let _e783 = phi_1145_;
                                                    let _e785 = phi_1148_;
                                                    local_20 = _e785;
                                                    local_22 = _e785;
                                                    local_24 = _e785;
                                                    if (_e783.member < _e783.member_1) {
                                                        phi_1146_ = type_36((_e783.member + 1u), _e783.member_1);
                                                        phi_1171_ = type_36(1u, _e783.member);
                                                    } else {
                                                        phi_1146_ = _e783;
                                                        phi_1171_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e799 = phi_1146_;
                                                    let _e801 = phi_1171_;
                                                    let _e805 = (bitcast<i32>(_e801.member) != 0i);
                                                    if _e805 {
                                                        if (_e801.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e808 = local_16.member[_e801.member_1];
                                                        let _e810 = keys.member[_e808];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e810[0][0], _e810[0][1]), array<u32, 2>(_e810[1][0], _e810[1][1]), array<u32, 2>(_e810[2][0], _e810[2][1]), array<u32, 2>(_e810[3][0], _e810[3][1]), array<u32, 2>(_e810[4][0], _e810[4][1]), array<u32, 2>(_e810[5][0], _e810[5][1]));
                                                        if (_e742.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e838 = local_15[_e742.member_1];
                                                        if (_e785[1] > _e838[1]) {
                                                            phi_1247_ = true;
                                                        } else {
                                                            if (_e785[1] == _e838[1]) {
                                                                phi_1246_ = (_e785[0] > _e838[0]);
                                                            } else {
                                                                phi_1246_ = false;
                                                            }
                                                            let _e849 = phi_1246_;
                                                            phi_1247_ = _e849;
                                                        }
                                                        let _e851 = phi_1247_;
                                                        if _e851 {
                                                            phi_1251_ = array<u32, 2>(_e838[0], _e838[1]);
                                                        } else {
                                                            phi_1251_ = _e785;
                                                        }
                                                        let _e853 = phi_1251_;
                                                        phi_1149_ = _e853;
                                                    } else {
                                                        phi_1149_ = array<u32, 2>();
                                                    }
                                                    let _e855 = phi_1149_;
                                                    continue;
                                                    continuing {
                                                        phi_1145_ = _e799;
                                                        phi_1148_ = _e855;
                                                        break if !(_e805);
                                                    }
                                                }
                                                let _e858 = local_17.member[0u];
                                                let _e860 = keys.member[_e858];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e860[0][0], _e860[0][1]), array<u32, 2>(_e860[1][0], _e860[1][1]), array<u32, 2>(_e860[2][0], _e860[2][1]), array<u32, 2>(_e860[3][0], _e860[3][1]), array<u32, 2>(_e860[4][0], _e860[4][1]), array<u32, 2>(_e860[5][0], _e860[5][1]));
                                                let _e886 = (3u + _e742.member_1);
                                                if (_e886 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e889 = local_12[_e886];
                                                phi_1302_ = type_36(1u, 3u);
                                                phi_1305_ = array<u32, 2>(_e889[0], _e889[1]);
                                                loop {
                                                    let _e894 = phi_1302_;
                                                    let _e896 = phi_1305_;
                                                    local_21 = _e896;
                                                    local_23 = _e896;
                                                    local_25 = _e896;
                                                    if (_e894.member < _e894.member_1) {
                                                        phi_1303_ = type_36((_e894.member + 1u), _e894.member_1);
                                                        phi_1328_ = type_36(1u, _e894.member);
                                                    } else {
                                                        phi_1303_ = _e894;
                                                        phi_1328_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e910 = phi_1303_;
                                                    let _e912 = phi_1328_;
                                                    let _e916 = (bitcast<i32>(_e912.member) != 0i);
                                                    if _e916 {
                                                        if (_e912.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e919 = local_17.member[_e912.member_1];
                                                        let _e921 = keys.member[_e919];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e921[0][0], _e921[0][1]), array<u32, 2>(_e921[1][0], _e921[1][1]), array<u32, 2>(_e921[2][0], _e921[2][1]), array<u32, 2>(_e921[3][0], _e921[3][1]), array<u32, 2>(_e921[4][0], _e921[4][1]), array<u32, 2>(_e921[5][0], _e921[5][1]));
                                                        let _e947 = (3u + _e742.member_1);
                                                        if (_e947 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e950 = local_13[_e947];
                                                        if (_e950[1] > _e896[1]) {
                                                            phi_1405_ = true;
                                                        } else {
                                                            if (_e950[1] == _e896[1]) {
                                                                phi_1404_ = (_e950[0] > _e896[0]);
                                                            } else {
                                                                phi_1404_ = false;
                                                            }
                                                            let _e961 = phi_1404_;
                                                            phi_1405_ = _e961;
                                                        }
                                                        let _e963 = phi_1405_;
                                                        if _e963 {
                                                            phi_1409_ = array<u32, 2>(_e950[0], _e950[1]);
                                                        } else {
                                                            phi_1409_ = _e896;
                                                        }
                                                        let _e965 = phi_1409_;
                                                        phi_1306_ = _e965;
                                                    } else {
                                                        phi_1306_ = array<u32, 2>();
                                                    }
                                                    let _e967 = phi_1306_;
                                                    continue;
                                                    continuing {
                                                        phi_1302_ = _e910;
                                                        phi_1305_ = _e967;
                                                        break if !(_e916);
                                                    }
                                                }
                                                let _e970 = local_20;
                                                let _e973 = local_21;
                                                if (_e970[1] > _e973[1]) {
                                                    phi_1426_ = true;
                                                } else {
                                                    let _e977 = local_22;
                                                    let _e980 = local_23;
                                                    if (_e977[1] == _e980[1]) {
                                                        let _e984 = local_24;
                                                        let _e987 = local_25;
                                                        phi_1425_ = (_e984[0] > _e987[0]);
                                                    } else {
                                                        phi_1425_ = false;
                                                    }
                                                    let _e991 = phi_1425_;
                                                    phi_1426_ = _e991;
                                                }
                                                let _e993 = phi_1426_;
                                                let _e996 = local_17.member[0u];
                                                let _e998 = keys.member[_e996];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e998[0][0], _e998[0][1]), array<u32, 2>(_e998[1][0], _e998[1][1]), array<u32, 2>(_e998[2][0], _e998[2][1]), array<u32, 2>(_e998[3][0], _e998[3][1]), array<u32, 2>(_e998[4][0], _e998[4][1]), array<u32, 2>(_e998[5][0], _e998[5][1]));
                                                if (_e742.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1026 = local_10[_e742.member_1];
                                                phi_1477_ = type_36(1u, 3u);
                                                phi_1480_ = array<u32, 2>(_e1026[0], _e1026[1]);
                                                loop {
                                                    let _e1031 = phi_1477_;
                                                    let _e1033 = phi_1480_;
                                                    local_26 = _e1033;
                                                    local_28 = _e1033;
                                                    local_30 = _e1033;
                                                    if (_e1031.member < _e1031.member_1) {
                                                        phi_1478_ = type_36((_e1031.member + 1u), _e1031.member_1);
                                                        phi_1503_ = type_36(1u, _e1031.member);
                                                    } else {
                                                        phi_1478_ = _e1031;
                                                        phi_1503_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1047 = phi_1478_;
                                                    let _e1049 = phi_1503_;
                                                    let _e1053 = (bitcast<i32>(_e1049.member) != 0i);
                                                    if _e1053 {
                                                        if (_e1049.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1056 = local_17.member[_e1049.member_1];
                                                        let _e1058 = keys.member[_e1056];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e1058[0][0], _e1058[0][1]), array<u32, 2>(_e1058[1][0], _e1058[1][1]), array<u32, 2>(_e1058[2][0], _e1058[2][1]), array<u32, 2>(_e1058[3][0], _e1058[3][1]), array<u32, 2>(_e1058[4][0], _e1058[4][1]), array<u32, 2>(_e1058[5][0], _e1058[5][1]));
                                                        if (_e742.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1086 = local_11[_e742.member_1];
                                                        if (_e1033[1] > _e1086[1]) {
                                                            phi_1579_ = true;
                                                        } else {
                                                            if (_e1033[1] == _e1086[1]) {
                                                                phi_1578_ = (_e1033[0] > _e1086[0]);
                                                            } else {
                                                                phi_1578_ = false;
                                                            }
                                                            let _e1097 = phi_1578_;
                                                            phi_1579_ = _e1097;
                                                        }
                                                        let _e1099 = phi_1579_;
                                                        if _e1099 {
                                                            phi_1583_ = array<u32, 2>(_e1086[0], _e1086[1]);
                                                        } else {
                                                            phi_1583_ = _e1033;
                                                        }
                                                        let _e1101 = phi_1583_;
                                                        phi_1481_ = _e1101;
                                                    } else {
                                                        phi_1481_ = array<u32, 2>();
                                                    }
                                                    let _e1103 = phi_1481_;
                                                    continue;
                                                    continuing {
                                                        phi_1477_ = _e1047;
                                                        phi_1480_ = _e1103;
                                                        break if !(_e1053);
                                                    }
                                                }
                                                let _e1106 = local_16.member[0u];
                                                let _e1108 = keys.member[_e1106];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1108[0][0], _e1108[0][1]), array<u32, 2>(_e1108[1][0], _e1108[1][1]), array<u32, 2>(_e1108[2][0], _e1108[2][1]), array<u32, 2>(_e1108[3][0], _e1108[3][1]), array<u32, 2>(_e1108[4][0], _e1108[4][1]), array<u32, 2>(_e1108[5][0], _e1108[5][1]));
                                                let _e1134 = (3u + _e742.member_1);
                                                if (_e1134 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1137 = local_8[_e1134];
                                                phi_1634_ = type_36(1u, 3u);
                                                phi_1637_ = array<u32, 2>(_e1137[0], _e1137[1]);
                                                loop {
                                                    let _e1142 = phi_1634_;
                                                    let _e1144 = phi_1637_;
                                                    local_27 = _e1144;
                                                    local_29 = _e1144;
                                                    local_31 = _e1144;
                                                    if (_e1142.member < _e1142.member_1) {
                                                        phi_1635_ = type_36((_e1142.member + 1u), _e1142.member_1);
                                                        phi_1660_ = type_36(1u, _e1142.member);
                                                    } else {
                                                        phi_1635_ = _e1142;
                                                        phi_1660_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1158 = phi_1635_;
                                                    let _e1160 = phi_1660_;
                                                    let _e1164 = (bitcast<i32>(_e1160.member) != 0i);
                                                    if _e1164 {
                                                        if (_e1160.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1167 = local_16.member[_e1160.member_1];
                                                        let _e1169 = keys.member[_e1167];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1169[0][0], _e1169[0][1]), array<u32, 2>(_e1169[1][0], _e1169[1][1]), array<u32, 2>(_e1169[2][0], _e1169[2][1]), array<u32, 2>(_e1169[3][0], _e1169[3][1]), array<u32, 2>(_e1169[4][0], _e1169[4][1]), array<u32, 2>(_e1169[5][0], _e1169[5][1]));
                                                        let _e1195 = (3u + _e742.member_1);
                                                        if (_e1195 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1198 = local_9[_e1195];
                                                        if (_e1198[1] > _e1144[1]) {
                                                            phi_1737_ = true;
                                                        } else {
                                                            if (_e1198[1] == _e1144[1]) {
                                                                phi_1736_ = (_e1198[0] > _e1144[0]);
                                                            } else {
                                                                phi_1736_ = false;
                                                            }
                                                            let _e1209 = phi_1736_;
                                                            phi_1737_ = _e1209;
                                                        }
                                                        let _e1211 = phi_1737_;
                                                        if _e1211 {
                                                            phi_1741_ = array<u32, 2>(_e1198[0], _e1198[1]);
                                                        } else {
                                                            phi_1741_ = _e1144;
                                                        }
                                                        let _e1213 = phi_1741_;
                                                        phi_1638_ = _e1213;
                                                    } else {
                                                        phi_1638_ = array<u32, 2>();
                                                    }
                                                    let _e1215 = phi_1638_;
                                                    continue;
                                                    continuing {
                                                        phi_1634_ = _e1158;
                                                        phi_1637_ = _e1215;
                                                        break if !(_e1164);
                                                    }
                                                }
                                                let _e1218 = local_26;
                                                let _e1221 = local_27;
                                                if (_e1218[1] > _e1221[1]) {
                                                    phi_1758_ = true;
                                                } else {
                                                    let _e1225 = local_28;
                                                    let _e1228 = local_29;
                                                    if (_e1225[1] == _e1228[1]) {
                                                        let _e1232 = local_30;
                                                        let _e1235 = local_31;
                                                        phi_1757_ = (_e1232[0] > _e1235[0]);
                                                    } else {
                                                        phi_1757_ = false;
                                                    }
                                                    let _e1239 = phi_1757_;
                                                    phi_1758_ = _e1239;
                                                }
                                                let _e1241 = phi_1758_;
                                                phi_1066_ = (_e726 && (!(_e993) && !(_e1241)));
                                            } else {
                                                phi_1066_ = bool();
                                            }
                                            let _e1246 = phi_1066_;
                                            continue;
                                            continuing {
                                                phi_1062_ = _e740;
                                                phi_1065_ = _e1246;
                                                break if !(_e746);
                                            }
                                        }
                                        let _e2322 = local_45;
                                        phi_1762_ = _e2322;
                                    }
                                    let _e1249 = phi_1762_;
                                    phi_1763_ = _e1249;
                                    phi_1764_ = _e720;
                                } else {
                                    phi_1763_ = bool();
                                    phi_1764_ = true;
                                }
                                let _e1251 = phi_1763_;
                                let _e1253 = phi_1764_;
                                if _e1253 {
                                    phi_1768_ = false;
                                } else {
                                    phi_1768_ = true;
                                }
                                let _e1255 = phi_1768_;
                                phi_1769_ = _e1251;
                                phi_1770_ = _e1255;
                            } else {
                                phi_1769_ = false;
                                phi_1770_ = true;
                            }
                            let _e1257 = phi_1769_;
                            let _e1259 = phi_1770_;
                            phi_1771_ = _e1257;
                            phi_1772_ = _e1259;
                        } else {
                            phi_1771_ = false;
                            phi_1772_ = true;
                        }
                        let _e1261 = phi_1771_;
                        let _e1263 = phi_1772_;
                        if _e1263 {
                            phi_1776_ = _e1261;
                        } else {
                            phi_1776_ = true;
                        }
                        let _e1265 = phi_1776_;
                        if _e1265 {
                            let _e1267 = params.member.member_16;
                            let _e1270 = local_16.member_1;
                            let _e1272 = local_17.member_1;
                            if (_e112[0] == _e112[1]) {
                                if (_e1270 < _e1272) {
                                    phi_1796_ = type_36(_e1270, _e1272);
                                } else {
                                    phi_1796_ = type_36(_e1272, _e1270);
                                }
                                let _e1278 = phi_1796_;
                                phi_1801_ = _e1278;
                            } else {
                                phi_1801_ = type_36(_e1270, _e1272);
                            }
                            let _e1280 = phi_1801_;
                            let _e1284 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1284 + 1u) < _e1284) {
                                let _e1288 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1284 < _e1267) {
                                atomicStore((&output.member[(4u + (2u * _e1284))]), _e1280.member);
                                atomicStore((&output.member[((2u * _e1284) + 5u)]), _e1280.member_1);
                            }
                            let _e1297 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1297 + 1u) < _e1297) {
                                let _e1301 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1841_ = (_e503 & (_e503 - 1u));
                        phi_1842_ = true;
                    }
                    let _e1303 = phi_1841_;
                    let _e1305 = phi_1842_;
                    phi_769_ = _e1303;
                    phi_1843_ = _e1305;
                } else {
                    phi_769_ = u32();
                    phi_1843_ = false;
                }
                let _e1307 = phi_769_;
                let _e1309 = phi_1843_;
                continue;
                continuing {
                    phi_765_ = _e517;
                    phi_768_ = _e1307;
                    break if !(_e1309);
                }
            }
            workgroupBarrier();
            let _e1312 = atomicLoad((&counters[4u]));
            if (2048u < _e1312) {
                phi_1850_ = 2048u;
            } else {
                phi_1850_ = _e1312;
            }
            let _e1315 = phi_1850_;
            phi_1853_ = type_36(0u, 16u);
            loop {
                let _e1317 = phi_1853_;
                if (_e1317.member < _e1317.member_1) {
                    phi_1854_ = type_36((_e1317.member + 1u), _e1317.member_1);
                    phi_1877_ = type_36(1u, _e1317.member);
                } else {
                    phi_1854_ = _e1317;
                    phi_1877_ = type_36(0u, type_36().member_1);
                }
                let _e1331 = phi_1854_;
                let _e1333 = phi_1877_;
                if (bitcast<i32>(_e1333.member) != 0i) {
                    let _e1339 = (_e83 + (_e1333.member_1 * 128u));
                    if (_e1339 >= _e1315) {
                        phi_2885_ = false;
                    } else {
                        let _e1342 = hits[_e1339];
                        let _e1345 = ((_e1342 >> bitcast<u32>(10i)) & 3u);
                        let _e1352 = firsts[(2u * _e1345)];
                        let _e1353 = (_e1352 + ((_e1342 >> bitcast<u32>(5i)) & 31u));
                        let _e1357 = firsts[((2u * _e1345) + 1u)];
                        let _e1358 = (_e1357 + (_e1342 & 31u));
                        let _e1360 = leaves.member[_e1353];
                        let _e1362 = leaves.member[_e1358];
                        local_18 = type_24(array<u32, 3>(_e1360.member[0], _e1360.member[1], _e1360.member[2]), _e1360.member_1);
                        local_19 = type_24(array<u32, 3>(_e1362.member[0], _e1362.member[1], _e1362.member[2]), _e1362.member_1);
                        let _e1378 = nodes.member[_e1353];
                        let _e1380 = nodes.member[_e1358];
                        let _e1382 = params.member.member_1;
                        if ((_e1382 & 1u) != 0u) {
                            let _e1386 = params.member.member_8;
                            if (_e1386 == 0u) {
                                let _e1430 = local_18.member[0u];
                                let _e1433 = local_19.member[0u];
                                if (_e1430 == _e1433) {
                                    phi_1996_ = bool();
                                    phi_1997_ = true;
                                } else {
                                    let _e1437 = local_18.member[0u];
                                    let _e1440 = local_19.member[1u];
                                    let _e1441 = (_e1437 == _e1440);
                                    if _e1441 {
                                        phi_1995_ = bool();
                                    } else {
                                        let _e1444 = local_18.member[0u];
                                        let _e1447 = local_19.member[2u];
                                        phi_1995_ = (_e1444 == _e1447);
                                    }
                                    let _e1450 = phi_1995_;
                                    phi_1996_ = _e1450;
                                    phi_1997_ = _e1441;
                                }
                                let _e1452 = phi_1996_;
                                let _e1454 = phi_1997_;
                                if _e1454 {
                                    phi_2001_ = true;
                                } else {
                                    phi_2001_ = _e1452;
                                }
                                let _e1456 = phi_2001_;
                                phi_2040_ = _e1456;
                            } else {
                                let _e1390 = local_18.member[0u];
                                let _e1393 = local_19.member[0u];
                                if (_e1390 == _e1393) {
                                    phi_2034_ = bool();
                                    phi_2035_ = true;
                                } else {
                                    let _e1397 = local_18.member[0u];
                                    let _e1400 = local_19.member[1u];
                                    if (_e1397 == _e1400) {
                                        phi_2032_ = bool();
                                        phi_2033_ = true;
                                    } else {
                                        let _e1404 = local_18.member[1u];
                                        let _e1407 = local_19.member[0u];
                                        let _e1408 = (_e1404 == _e1407);
                                        if _e1408 {
                                            phi_2031_ = bool();
                                        } else {
                                            let _e1411 = local_18.member[1u];
                                            let _e1414 = local_19.member[1u];
                                            phi_2031_ = (_e1411 == _e1414);
                                        }
                                        let _e1417 = phi_2031_;
                                        phi_2032_ = _e1417;
                                        phi_2033_ = _e1408;
                                    }
                                    let _e1419 = phi_2032_;
                                    let _e1421 = phi_2033_;
                                    phi_2034_ = _e1419;
                                    phi_2035_ = _e1421;
                                }
                                let _e1423 = phi_2034_;
                                let _e1425 = phi_2035_;
                                if _e1425 {
                                    phi_2039_ = true;
                                } else {
                                    phi_2039_ = _e1423;
                                }
                                let _e1427 = phi_2039_;
                                phi_2040_ = _e1427;
                            }
                            let _e1458 = phi_2040_;
                            if _e1458 {
                                phi_2044_ = false;
                            } else {
                                phi_2044_ = true;
                            }
                            let _e1460 = phi_2044_;
                            phi_2045_ = _e1460;
                        } else {
                            phi_2045_ = true;
                        }
                        let _e1462 = phi_2045_;
                        if _e1462 {
                            let _e1464 = params.member.member_1;
                            if ((_e1464 & 2u) != 0u) {
                                let _e1469 = local_18.member[0u];
                                let _e1471 = bodies.member[_e1469];
                                let _e1474 = local_19.member[0u];
                                let _e1476 = bodies.member[_e1474];
                                if ((_e1471 / 2u) == (_e1476 / 2u)) {
                                    let _e1481 = params.member.member_1;
                                    phi_2091_ = !(((_e1481 & 4u) != 0u));
                                } else {
                                    phi_2091_ = false;
                                }
                                let _e1486 = phi_2091_;
                                if _e1486 {
                                    phi_2102_ = true;
                                } else {
                                    if (((_e1471 & _e1476) & 1u) == 0u) {
                                        phi_2101_ = false;
                                    } else {
                                        phi_2101_ = true;
                                    }
                                    let _e1491 = phi_2101_;
                                    phi_2102_ = _e1491;
                                }
                                let _e1493 = phi_2102_;
                                if _e1493 {
                                    phi_2106_ = false;
                                } else {
                                    phi_2106_ = true;
                                }
                                let _e1495 = phi_2106_;
                                phi_2107_ = _e1495;
                            } else {
                                phi_2107_ = true;
                            }
                            let _e1497 = phi_2107_;
                            if _e1497 {
                                let _e1499 = params.member.member_1;
                                if ((_e1499 & 32u) != 0u) {
                                    let _e1503 = params.member.member_6;
                                    let _e1544 = (((((((_e1378.member_1[0] - _e1380.member[0]) > _e1503) && ((_e1380.member_1[0] - _e1378.member[0]) > _e1503)) && ((_e1378.member_1[1] - _e1380.member[1]) > _e1503)) && ((_e1380.member_1[1] - _e1378.member[1]) > _e1503)) && ((_e1378.member_1[2] - _e1380.member[2]) > _e1503)) && ((_e1380.member_1[2] - _e1378.member[2]) > _e1503));
                                    if _e1544 {
                                        phi_2856_ = bool();
                                    } else {
                                        phi_2156_ = type_36(0u, 3u);
                                        phi_2159_ = true;
                                        loop {
                                            let _e1548 = phi_2156_;
                                            let _e1550 = phi_2159_;
                                            local_46 = _e1550;
                                            if (_e1548.member < _e1548.member_1) {
                                                phi_2157_ = type_36((_e1548.member + 1u), _e1548.member_1);
                                                phi_2182_ = type_36(1u, _e1548.member);
                                            } else {
                                                phi_2157_ = _e1548;
                                                phi_2182_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1564 = phi_2157_;
                                            let _e1566 = phi_2182_;
                                            let _e1570 = (bitcast<i32>(_e1566.member) != 0i);
                                            if _e1570 {
                                                let _e1572 = local_18.member[0u];
                                                let _e1574 = keys.member[_e1572];
                                                local_6 = array<array<u32, 2>, 6>(array<u32, 2>(_e1574[0][0], _e1574[0][1]), array<u32, 2>(_e1574[1][0], _e1574[1][1]), array<u32, 2>(_e1574[2][0], _e1574[2][1]), array<u32, 2>(_e1574[3][0], _e1574[3][1]), array<u32, 2>(_e1574[4][0], _e1574[4][1]), array<u32, 2>(_e1574[5][0], _e1574[5][1]));
                                                if (_e1566.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1602 = local_6[_e1566.member_1];
                                                phi_2239_ = type_36(1u, 3u);
                                                phi_2242_ = array<u32, 2>(_e1602[0], _e1602[1]);
                                                loop {
                                                    let _e1607 = phi_2239_;
                                                    let _e1609 = phi_2242_;
                                                    local_32 = _e1609;
                                                    local_34 = _e1609;
                                                    local_36 = _e1609;
                                                    if (_e1607.member < _e1607.member_1) {
                                                        phi_2240_ = type_36((_e1607.member + 1u), _e1607.member_1);
                                                        phi_2265_ = type_36(1u, _e1607.member);
                                                    } else {
                                                        phi_2240_ = _e1607;
                                                        phi_2265_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1623 = phi_2240_;
                                                    let _e1625 = phi_2265_;
                                                    let _e1629 = (bitcast<i32>(_e1625.member) != 0i);
                                                    if _e1629 {
                                                        if (_e1625.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1632 = local_18.member[_e1625.member_1];
                                                        let _e1634 = keys.member[_e1632];
                                                        local_7 = array<array<u32, 2>, 6>(array<u32, 2>(_e1634[0][0], _e1634[0][1]), array<u32, 2>(_e1634[1][0], _e1634[1][1]), array<u32, 2>(_e1634[2][0], _e1634[2][1]), array<u32, 2>(_e1634[3][0], _e1634[3][1]), array<u32, 2>(_e1634[4][0], _e1634[4][1]), array<u32, 2>(_e1634[5][0], _e1634[5][1]));
                                                        if (_e1566.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1662 = local_7[_e1566.member_1];
                                                        if (_e1609[1] > _e1662[1]) {
                                                            phi_2341_ = true;
                                                        } else {
                                                            if (_e1609[1] == _e1662[1]) {
                                                                phi_2340_ = (_e1609[0] > _e1662[0]);
                                                            } else {
                                                                phi_2340_ = false;
                                                            }
                                                            let _e1673 = phi_2340_;
                                                            phi_2341_ = _e1673;
                                                        }
                                                        let _e1675 = phi_2341_;
                                                        if _e1675 {
                                                            phi_2345_ = array<u32, 2>(_e1662[0], _e1662[1]);
                                                        } else {
                                                            phi_2345_ = _e1609;
                                                        }
                                                        let _e1677 = phi_2345_;
                                                        phi_2243_ = _e1677;
                                                    } else {
                                                        phi_2243_ = array<u32, 2>();
                                                    }
                                                    let _e1679 = phi_2243_;
                                                    continue;
                                                    continuing {
                                                        phi_2239_ = _e1623;
                                                        phi_2242_ = _e1679;
                                                        break if !(_e1629);
                                                    }
                                                }
                                                let _e1682 = local_19.member[0u];
                                                let _e1684 = keys.member[_e1682];
                                                local_4 = array<array<u32, 2>, 6>(array<u32, 2>(_e1684[0][0], _e1684[0][1]), array<u32, 2>(_e1684[1][0], _e1684[1][1]), array<u32, 2>(_e1684[2][0], _e1684[2][1]), array<u32, 2>(_e1684[3][0], _e1684[3][1]), array<u32, 2>(_e1684[4][0], _e1684[4][1]), array<u32, 2>(_e1684[5][0], _e1684[5][1]));
                                                let _e1710 = (3u + _e1566.member_1);
                                                if (_e1710 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1713 = local_4[_e1710];
                                                phi_2396_ = type_36(1u, 3u);
                                                phi_2399_ = array<u32, 2>(_e1713[0], _e1713[1]);
                                                loop {
                                                    let _e1718 = phi_2396_;
                                                    let _e1720 = phi_2399_;
                                                    local_33 = _e1720;
                                                    local_35 = _e1720;
                                                    local_37 = _e1720;
                                                    if (_e1718.member < _e1718.member_1) {
                                                        phi_2397_ = type_36((_e1718.member + 1u), _e1718.member_1);
                                                        phi_2422_ = type_36(1u, _e1718.member);
                                                    } else {
                                                        phi_2397_ = _e1718;
                                                        phi_2422_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1734 = phi_2397_;
                                                    let _e1736 = phi_2422_;
                                                    let _e1740 = (bitcast<i32>(_e1736.member) != 0i);
                                                    if _e1740 {
                                                        if (_e1736.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1743 = local_19.member[_e1736.member_1];
                                                        let _e1745 = keys.member[_e1743];
                                                        local_5 = array<array<u32, 2>, 6>(array<u32, 2>(_e1745[0][0], _e1745[0][1]), array<u32, 2>(_e1745[1][0], _e1745[1][1]), array<u32, 2>(_e1745[2][0], _e1745[2][1]), array<u32, 2>(_e1745[3][0], _e1745[3][1]), array<u32, 2>(_e1745[4][0], _e1745[4][1]), array<u32, 2>(_e1745[5][0], _e1745[5][1]));
                                                        let _e1771 = (3u + _e1566.member_1);
                                                        if (_e1771 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1774 = local_5[_e1771];
                                                        if (_e1774[1] > _e1720[1]) {
                                                            phi_2499_ = true;
                                                        } else {
                                                            if (_e1774[1] == _e1720[1]) {
                                                                phi_2498_ = (_e1774[0] > _e1720[0]);
                                                            } else {
                                                                phi_2498_ = false;
                                                            }
                                                            let _e1785 = phi_2498_;
                                                            phi_2499_ = _e1785;
                                                        }
                                                        let _e1787 = phi_2499_;
                                                        if _e1787 {
                                                            phi_2503_ = array<u32, 2>(_e1774[0], _e1774[1]);
                                                        } else {
                                                            phi_2503_ = _e1720;
                                                        }
                                                        let _e1789 = phi_2503_;
                                                        phi_2400_ = _e1789;
                                                    } else {
                                                        phi_2400_ = array<u32, 2>();
                                                    }
                                                    let _e1791 = phi_2400_;
                                                    continue;
                                                    continuing {
                                                        phi_2396_ = _e1734;
                                                        phi_2399_ = _e1791;
                                                        break if !(_e1740);
                                                    }
                                                }
                                                let _e1794 = local_32;
                                                let _e1797 = local_33;
                                                if (_e1794[1] > _e1797[1]) {
                                                    phi_2520_ = true;
                                                } else {
                                                    let _e1801 = local_34;
                                                    let _e1804 = local_35;
                                                    if (_e1801[1] == _e1804[1]) {
                                                        let _e1808 = local_36;
                                                        let _e1811 = local_37;
                                                        phi_2519_ = (_e1808[0] > _e1811[0]);
                                                    } else {
                                                        phi_2519_ = false;
                                                    }
                                                    let _e1815 = phi_2519_;
                                                    phi_2520_ = _e1815;
                                                }
                                                let _e1817 = phi_2520_;
                                                let _e1820 = local_19.member[0u];
                                                let _e1822 = keys.member[_e1820];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e1822[0][0], _e1822[0][1]), array<u32, 2>(_e1822[1][0], _e1822[1][1]), array<u32, 2>(_e1822[2][0], _e1822[2][1]), array<u32, 2>(_e1822[3][0], _e1822[3][1]), array<u32, 2>(_e1822[4][0], _e1822[4][1]), array<u32, 2>(_e1822[5][0], _e1822[5][1]));
                                                if (_e1566.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1850 = local_2[_e1566.member_1];
                                                phi_2571_ = type_36(1u, 3u);
                                                phi_2574_ = array<u32, 2>(_e1850[0], _e1850[1]);
                                                loop {
                                                    let _e1855 = phi_2571_;
                                                    let _e1857 = phi_2574_;
                                                    local_38 = _e1857;
                                                    local_40 = _e1857;
                                                    local_42 = _e1857;
                                                    if (_e1855.member < _e1855.member_1) {
                                                        phi_2572_ = type_36((_e1855.member + 1u), _e1855.member_1);
                                                        phi_2597_ = type_36(1u, _e1855.member);
                                                    } else {
                                                        phi_2572_ = _e1855;
                                                        phi_2597_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1871 = phi_2572_;
                                                    let _e1873 = phi_2597_;
                                                    let _e1877 = (bitcast<i32>(_e1873.member) != 0i);
                                                    if _e1877 {
                                                        if (_e1873.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1880 = local_19.member[_e1873.member_1];
                                                        let _e1882 = keys.member[_e1880];
                                                        local_3 = array<array<u32, 2>, 6>(array<u32, 2>(_e1882[0][0], _e1882[0][1]), array<u32, 2>(_e1882[1][0], _e1882[1][1]), array<u32, 2>(_e1882[2][0], _e1882[2][1]), array<u32, 2>(_e1882[3][0], _e1882[3][1]), array<u32, 2>(_e1882[4][0], _e1882[4][1]), array<u32, 2>(_e1882[5][0], _e1882[5][1]));
                                                        if (_e1566.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1910 = local_3[_e1566.member_1];
                                                        if (_e1857[1] > _e1910[1]) {
                                                            phi_2673_ = true;
                                                        } else {
                                                            if (_e1857[1] == _e1910[1]) {
                                                                phi_2672_ = (_e1857[0] > _e1910[0]);
                                                            } else {
                                                                phi_2672_ = false;
                                                            }
                                                            let _e1921 = phi_2672_;
                                                            phi_2673_ = _e1921;
                                                        }
                                                        let _e1923 = phi_2673_;
                                                        if _e1923 {
                                                            phi_2677_ = array<u32, 2>(_e1910[0], _e1910[1]);
                                                        } else {
                                                            phi_2677_ = _e1857;
                                                        }
                                                        let _e1925 = phi_2677_;
                                                        phi_2575_ = _e1925;
                                                    } else {
                                                        phi_2575_ = array<u32, 2>();
                                                    }
                                                    let _e1927 = phi_2575_;
                                                    continue;
                                                    continuing {
                                                        phi_2571_ = _e1871;
                                                        phi_2574_ = _e1927;
                                                        break if !(_e1877);
                                                    }
                                                }
                                                let _e1930 = local_18.member[0u];
                                                let _e1932 = keys.member[_e1930];
                                                local = array<array<u32, 2>, 6>(array<u32, 2>(_e1932[0][0], _e1932[0][1]), array<u32, 2>(_e1932[1][0], _e1932[1][1]), array<u32, 2>(_e1932[2][0], _e1932[2][1]), array<u32, 2>(_e1932[3][0], _e1932[3][1]), array<u32, 2>(_e1932[4][0], _e1932[4][1]), array<u32, 2>(_e1932[5][0], _e1932[5][1]));
                                                let _e1958 = (3u + _e1566.member_1);
                                                if (_e1958 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1961 = local[_e1958];
                                                phi_2728_ = type_36(1u, 3u);
                                                phi_2731_ = array<u32, 2>(_e1961[0], _e1961[1]);
                                                loop {
                                                    let _e1966 = phi_2728_;
                                                    let _e1968 = phi_2731_;
                                                    local_39 = _e1968;
                                                    local_41 = _e1968;
                                                    local_43 = _e1968;
                                                    if (_e1966.member < _e1966.member_1) {
                                                        phi_2729_ = type_36((_e1966.member + 1u), _e1966.member_1);
                                                        phi_2754_ = type_36(1u, _e1966.member);
                                                    } else {
                                                        phi_2729_ = _e1966;
                                                        phi_2754_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1982 = phi_2729_;
                                                    let _e1984 = phi_2754_;
                                                    let _e1988 = (bitcast<i32>(_e1984.member) != 0i);
                                                    if _e1988 {
                                                        if (_e1984.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1991 = local_18.member[_e1984.member_1];
                                                        let _e1993 = keys.member[_e1991];
                                                        local_1 = array<array<u32, 2>, 6>(array<u32, 2>(_e1993[0][0], _e1993[0][1]), array<u32, 2>(_e1993[1][0], _e1993[1][1]), array<u32, 2>(_e1993[2][0], _e1993[2][1]), array<u32, 2>(_e1993[3][0], _e1993[3][1]), array<u32, 2>(_e1993[4][0], _e1993[4][1]), array<u32, 2>(_e1993[5][0], _e1993[5][1]));
                                                        let _e2019 = (3u + _e1566.member_1);
                                                        if (_e2019 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2022 = local_1[_e2019];
                                                        if (_e2022[1] > _e1968[1]) {
                                                            phi_2831_ = true;
                                                        } else {
                                                            if (_e2022[1] == _e1968[1]) {
                                                                phi_2830_ = (_e2022[0] > _e1968[0]);
                                                            } else {
                                                                phi_2830_ = false;
                                                            }
                                                            let _e2033 = phi_2830_;
                                                            phi_2831_ = _e2033;
                                                        }
                                                        let _e2035 = phi_2831_;
                                                        if _e2035 {
                                                            phi_2835_ = array<u32, 2>(_e2022[0], _e2022[1]);
                                                        } else {
                                                            phi_2835_ = _e1968;
                                                        }
                                                        let _e2037 = phi_2835_;
                                                        phi_2732_ = _e2037;
                                                    } else {
                                                        phi_2732_ = array<u32, 2>();
                                                    }
                                                    let _e2039 = phi_2732_;
                                                    continue;
                                                    continuing {
                                                        phi_2728_ = _e1982;
                                                        phi_2731_ = _e2039;
                                                        break if !(_e1988);
                                                    }
                                                }
                                                let _e2042 = local_38;
                                                let _e2045 = local_39;
                                                if (_e2042[1] > _e2045[1]) {
                                                    phi_2852_ = true;
                                                } else {
                                                    let _e2049 = local_40;
                                                    let _e2052 = local_41;
                                                    if (_e2049[1] == _e2052[1]) {
                                                        let _e2056 = local_42;
                                                        let _e2059 = local_43;
                                                        phi_2851_ = (_e2056[0] > _e2059[0]);
                                                    } else {
                                                        phi_2851_ = false;
                                                    }
                                                    let _e2063 = phi_2851_;
                                                    phi_2852_ = _e2063;
                                                }
                                                let _e2065 = phi_2852_;
                                                phi_2160_ = (_e1550 && (!(_e1817) && !(_e2065)));
                                            } else {
                                                phi_2160_ = bool();
                                            }
                                            let _e2070 = phi_2160_;
                                            continue;
                                            continuing {
                                                phi_2156_ = _e1564;
                                                phi_2159_ = _e2070;
                                                break if !(_e1570);
                                            }
                                        }
                                        let _e2414 = local_46;
                                        phi_2856_ = _e2414;
                                    }
                                    let _e2073 = phi_2856_;
                                    phi_2857_ = _e2073;
                                    phi_2858_ = _e1544;
                                } else {
                                    phi_2857_ = bool();
                                    phi_2858_ = true;
                                }
                                let _e2075 = phi_2857_;
                                let _e2077 = phi_2858_;
                                if _e2077 {
                                    phi_2862_ = false;
                                } else {
                                    phi_2862_ = true;
                                }
                                let _e2079 = phi_2862_;
                                phi_2863_ = _e2075;
                                phi_2864_ = _e2079;
                            } else {
                                phi_2863_ = false;
                                phi_2864_ = true;
                            }
                            let _e2081 = phi_2863_;
                            let _e2083 = phi_2864_;
                            phi_2865_ = _e2081;
                            phi_2866_ = _e2083;
                        } else {
                            phi_2865_ = false;
                            phi_2866_ = true;
                        }
                        let _e2085 = phi_2865_;
                        let _e2087 = phi_2866_;
                        if _e2087 {
                            phi_2870_ = _e2085;
                        } else {
                            phi_2870_ = true;
                        }
                        let _e2089 = phi_2870_;
                        if _e2089 {
                            let _e2091 = atomicAdd((&counters[7u]), 1u);
                            let _e2093 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1339] = ((2147483648u | (_e2093 << bitcast<u32>(12i))) | _e1342);
                        }
                        phi_2885_ = true;
                    }
                    let _e2100 = phi_2885_;
                    phi_2886_ = _e2100;
                } else {
                    phi_2886_ = false;
                }
                let _e2102 = phi_2886_;
                continue;
                continuing {
                    phi_1853_ = _e1331;
                    break if !(_e2102);
                }
            }
            workgroupBarrier();
            if (_e83 == 0u) {
                let _e2106 = atomicLoad((&counters[5u]));
                if (_e2106 > 0u) {
                    let _e2109 = atomicAdd((&output.member[0u]), _e2106);
                    if ((_e2109 + _e2106) < _e2109) {
                        let _e2113 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e2109);
                }
            }
            workgroupBarrier();
            let _e2116 = atomicLoad((&counters[6u]));
            if (_e83 == 0u) {
                let _e2119 = atomicLoad((&counters[7u]));
                if (_e2119 > 0u) {
                    let _e2122 = atomicAdd((&output.member[1u]), _e2119);
                    if ((_e2122 + _e2119) < _e2122) {
                        let _e2126 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2936_ = type_36(0u, 16u);
            loop {
                let _e2128 = phi_2936_;
                if (_e2128.member < _e2128.member_1) {
                    phi_2937_ = type_36((_e2128.member + 1u), _e2128.member_1);
                    phi_2960_ = type_36(1u, _e2128.member);
                } else {
                    phi_2937_ = _e2128;
                    phi_2960_ = type_36(0u, type_36().member_1);
                }
                let _e2142 = phi_2937_;
                let _e2144 = phi_2960_;
                if (bitcast<i32>(_e2144.member) != 0i) {
                    let _e2150 = (_e83 + (_e2144.member_1 * 128u));
                    if (_e2150 >= _e1315) {
                        phi_3058_ = false;
                    } else {
                        let _e2153 = hits[_e2150];
                        if ((_e2153 & 2147483648u) == 0u) {
                            phi_2983_ = 4294967295u;
                        } else {
                            phi_2983_ = ((_e2153 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e2160 = phi_2983_;
                        if (_e2160 != 4294967295u) {
                            let _e2164 = ((_e2153 >> bitcast<u32>(10i)) & 3u);
                            let _e2171 = firsts[(2u * _e2164)];
                            let _e2174 = leaves.member[(_e2171 + ((_e2153 >> bitcast<u32>(5i)) & 31u))];
                            let _e2178 = firsts[((2u * _e2164) + 1u)];
                            let _e2181 = leaves.member[(_e2178 + (_e2153 & 31u))];
                            let _e2185 = params.member.member_16;
                            let _e2186 = (_e2116 + _e2160);
                            if (_e112[0] == _e112[1]) {
                                if (_e2174.member_1 < _e2181.member_1) {
                                    phi_3037_ = type_36(_e2174.member_1, _e2181.member_1);
                                } else {
                                    phi_3037_ = type_36(_e2181.member_1, _e2174.member_1);
                                }
                                let _e2193 = phi_3037_;
                                phi_3042_ = _e2193;
                            } else {
                                phi_3042_ = type_36(_e2174.member_1, _e2181.member_1);
                            }
                            let _e2195 = phi_3042_;
                            if (_e2186 < _e2185) {
                                atomicStore((&output.member[(4u + (2u * _e2186))]), _e2195.member);
                                atomicStore((&output.member[((2u * _e2186) + 5u)]), _e2195.member_1);
                            }
                        }
                        phi_3058_ = true;
                    }
                    let _e2206 = phi_3058_;
                    phi_3059_ = _e2206;
                } else {
                    phi_3059_ = false;
                }
                let _e2208 = phi_3059_;
                continue;
                continuing {
                    phi_2936_ = _e2142;
                    break if !(_e2208);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_273_ = _e172;
            break if !(_e178);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
