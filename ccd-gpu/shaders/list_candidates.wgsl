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
    var phi_1823_: u32;
    var phi_1824_: bool;
    var phi_769_: u32;
    var phi_1825_: bool;
    var phi_1832_: u32;
    var phi_1835_: type_36;
    var phi_1836_: type_36;
    var phi_1859_: type_36;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2017_: bool;
    var phi_2021_: bool;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1983_: bool;
    var phi_2022_: bool;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2073_: bool;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2138_: type_36;
    var phi_2141_: bool;
    var phi_2139_: type_36;
    var phi_2164_: type_36;
    var phi_2221_: type_36;
    var phi_2224_: array<u32, 2>;
    var phi_2222_: type_36;
    var phi_2247_: type_36;
    var phi_2322_: bool;
    var phi_2323_: bool;
    var phi_2327_: array<u32, 2>;
    var phi_2225_: array<u32, 2>;
    var phi_2378_: type_36;
    var phi_2381_: array<u32, 2>;
    var phi_2379_: type_36;
    var phi_2404_: type_36;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2485_: array<u32, 2>;
    var phi_2382_: array<u32, 2>;
    var local_32: array<u32, 2>;
    var local_33: array<u32, 2>;
    var local_34: array<u32, 2>;
    var local_35: array<u32, 2>;
    var local_36: array<u32, 2>;
    var local_37: array<u32, 2>;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2553_: type_36;
    var phi_2556_: array<u32, 2>;
    var phi_2554_: type_36;
    var phi_2579_: type_36;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2659_: array<u32, 2>;
    var phi_2557_: array<u32, 2>;
    var phi_2710_: type_36;
    var phi_2713_: array<u32, 2>;
    var phi_2711_: type_36;
    var phi_2736_: type_36;
    var phi_2812_: bool;
    var phi_2813_: bool;
    var phi_2817_: array<u32, 2>;
    var phi_2714_: array<u32, 2>;
    var local_38: array<u32, 2>;
    var local_39: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var phi_2833_: bool;
    var phi_2834_: bool;
    var phi_2142_: bool;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var phi_2840_: bool;
    var phi_2844_: bool;
    var phi_2845_: bool;
    var phi_2846_: bool;
    var phi_2847_: bool;
    var phi_2848_: bool;
    var phi_2852_: bool;
    var phi_2867_: bool;
    var phi_2868_: bool;
    var phi_2900_: type_36;
    var phi_2901_: type_36;
    var phi_2924_: type_36;
    var phi_2947_: u32;
    var phi_3001_: type_36;
    var phi_3006_: type_36;
    var phi_3022_: bool;
    var phi_3023_: bool;
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
            let _e2230 = local_44;
            phi_768_ = _e2230;
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
                        phi_1823_ = u32();
                        phi_1824_ = false;
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
                                        let _e2306 = local_45;
                                        phi_1762_ = _e2306;
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
                            if (_e1284 < _e1267) {
                                atomicStore((&output.member[(4u + (2u * _e1284))]), _e1280.member);
                                atomicStore((&output.member[((2u * _e1284) + 5u)]), _e1280.member_1);
                            }
                            let _e1293 = atomicAdd((&output.member[1u]), 1u);
                        }
                        phi_1823_ = (_e503 & (_e503 - 1u));
                        phi_1824_ = true;
                    }
                    let _e1295 = phi_1823_;
                    let _e1297 = phi_1824_;
                    phi_769_ = _e1295;
                    phi_1825_ = _e1297;
                } else {
                    phi_769_ = u32();
                    phi_1825_ = false;
                }
                let _e1299 = phi_769_;
                let _e1301 = phi_1825_;
                continue;
                continuing {
                    phi_765_ = _e517;
                    phi_768_ = _e1299;
                    break if !(_e1301);
                }
            }
            workgroupBarrier();
            let _e1304 = atomicLoad((&counters[4u]));
            if (2048u < _e1304) {
                phi_1832_ = 2048u;
            } else {
                phi_1832_ = _e1304;
            }
            let _e1307 = phi_1832_;
            phi_1835_ = type_36(0u, 16u);
            loop {
                let _e1309 = phi_1835_;
                if (_e1309.member < _e1309.member_1) {
                    phi_1836_ = type_36((_e1309.member + 1u), _e1309.member_1);
                    phi_1859_ = type_36(1u, _e1309.member);
                } else {
                    phi_1836_ = _e1309;
                    phi_1859_ = type_36(0u, type_36().member_1);
                }
                let _e1323 = phi_1836_;
                let _e1325 = phi_1859_;
                if (bitcast<i32>(_e1325.member) != 0i) {
                    let _e1331 = (_e83 + (_e1325.member_1 * 128u));
                    if (_e1331 >= _e1307) {
                        phi_2867_ = false;
                    } else {
                        let _e1334 = hits[_e1331];
                        let _e1337 = ((_e1334 >> bitcast<u32>(10i)) & 3u);
                        let _e1344 = firsts[(2u * _e1337)];
                        let _e1345 = (_e1344 + ((_e1334 >> bitcast<u32>(5i)) & 31u));
                        let _e1349 = firsts[((2u * _e1337) + 1u)];
                        let _e1350 = (_e1349 + (_e1334 & 31u));
                        let _e1352 = leaves.member[_e1345];
                        let _e1354 = leaves.member[_e1350];
                        local_18 = type_24(array<u32, 3>(_e1352.member[0], _e1352.member[1], _e1352.member[2]), _e1352.member_1);
                        local_19 = type_24(array<u32, 3>(_e1354.member[0], _e1354.member[1], _e1354.member[2]), _e1354.member_1);
                        let _e1370 = nodes.member[_e1345];
                        let _e1372 = nodes.member[_e1350];
                        let _e1374 = params.member.member_1;
                        if ((_e1374 & 1u) != 0u) {
                            let _e1378 = params.member.member_8;
                            if (_e1378 == 0u) {
                                let _e1422 = local_18.member[0u];
                                let _e1425 = local_19.member[0u];
                                if (_e1422 == _e1425) {
                                    phi_1978_ = bool();
                                    phi_1979_ = true;
                                } else {
                                    let _e1429 = local_18.member[0u];
                                    let _e1432 = local_19.member[1u];
                                    let _e1433 = (_e1429 == _e1432);
                                    if _e1433 {
                                        phi_1977_ = bool();
                                    } else {
                                        let _e1436 = local_18.member[0u];
                                        let _e1439 = local_19.member[2u];
                                        phi_1977_ = (_e1436 == _e1439);
                                    }
                                    let _e1442 = phi_1977_;
                                    phi_1978_ = _e1442;
                                    phi_1979_ = _e1433;
                                }
                                let _e1444 = phi_1978_;
                                let _e1446 = phi_1979_;
                                if _e1446 {
                                    phi_1983_ = true;
                                } else {
                                    phi_1983_ = _e1444;
                                }
                                let _e1448 = phi_1983_;
                                phi_2022_ = _e1448;
                            } else {
                                let _e1382 = local_18.member[0u];
                                let _e1385 = local_19.member[0u];
                                if (_e1382 == _e1385) {
                                    phi_2016_ = bool();
                                    phi_2017_ = true;
                                } else {
                                    let _e1389 = local_18.member[0u];
                                    let _e1392 = local_19.member[1u];
                                    if (_e1389 == _e1392) {
                                        phi_2014_ = bool();
                                        phi_2015_ = true;
                                    } else {
                                        let _e1396 = local_18.member[1u];
                                        let _e1399 = local_19.member[0u];
                                        let _e1400 = (_e1396 == _e1399);
                                        if _e1400 {
                                            phi_2013_ = bool();
                                        } else {
                                            let _e1403 = local_18.member[1u];
                                            let _e1406 = local_19.member[1u];
                                            phi_2013_ = (_e1403 == _e1406);
                                        }
                                        let _e1409 = phi_2013_;
                                        phi_2014_ = _e1409;
                                        phi_2015_ = _e1400;
                                    }
                                    let _e1411 = phi_2014_;
                                    let _e1413 = phi_2015_;
                                    phi_2016_ = _e1411;
                                    phi_2017_ = _e1413;
                                }
                                let _e1415 = phi_2016_;
                                let _e1417 = phi_2017_;
                                if _e1417 {
                                    phi_2021_ = true;
                                } else {
                                    phi_2021_ = _e1415;
                                }
                                let _e1419 = phi_2021_;
                                phi_2022_ = _e1419;
                            }
                            let _e1450 = phi_2022_;
                            if _e1450 {
                                phi_2026_ = false;
                            } else {
                                phi_2026_ = true;
                            }
                            let _e1452 = phi_2026_;
                            phi_2027_ = _e1452;
                        } else {
                            phi_2027_ = true;
                        }
                        let _e1454 = phi_2027_;
                        if _e1454 {
                            let _e1456 = params.member.member_1;
                            if ((_e1456 & 2u) != 0u) {
                                let _e1461 = local_18.member[0u];
                                let _e1463 = bodies.member[_e1461];
                                let _e1466 = local_19.member[0u];
                                let _e1468 = bodies.member[_e1466];
                                if ((_e1463 / 2u) == (_e1468 / 2u)) {
                                    let _e1473 = params.member.member_1;
                                    phi_2073_ = !(((_e1473 & 4u) != 0u));
                                } else {
                                    phi_2073_ = false;
                                }
                                let _e1478 = phi_2073_;
                                if _e1478 {
                                    phi_2084_ = true;
                                } else {
                                    if (((_e1463 & _e1468) & 1u) == 0u) {
                                        phi_2083_ = false;
                                    } else {
                                        phi_2083_ = true;
                                    }
                                    let _e1483 = phi_2083_;
                                    phi_2084_ = _e1483;
                                }
                                let _e1485 = phi_2084_;
                                if _e1485 {
                                    phi_2088_ = false;
                                } else {
                                    phi_2088_ = true;
                                }
                                let _e1487 = phi_2088_;
                                phi_2089_ = _e1487;
                            } else {
                                phi_2089_ = true;
                            }
                            let _e1489 = phi_2089_;
                            if _e1489 {
                                let _e1491 = params.member.member_1;
                                if ((_e1491 & 32u) != 0u) {
                                    let _e1495 = params.member.member_6;
                                    let _e1536 = (((((((_e1370.member_1[0] - _e1372.member[0]) > _e1495) && ((_e1372.member_1[0] - _e1370.member[0]) > _e1495)) && ((_e1370.member_1[1] - _e1372.member[1]) > _e1495)) && ((_e1372.member_1[1] - _e1370.member[1]) > _e1495)) && ((_e1370.member_1[2] - _e1372.member[2]) > _e1495)) && ((_e1372.member_1[2] - _e1370.member[2]) > _e1495));
                                    if _e1536 {
                                        phi_2838_ = bool();
                                    } else {
                                        phi_2138_ = type_36(0u, 3u);
                                        phi_2141_ = true;
                                        loop {
                                            let _e1540 = phi_2138_;
                                            let _e1542 = phi_2141_;
                                            local_46 = _e1542;
                                            if (_e1540.member < _e1540.member_1) {
                                                phi_2139_ = type_36((_e1540.member + 1u), _e1540.member_1);
                                                phi_2164_ = type_36(1u, _e1540.member);
                                            } else {
                                                phi_2139_ = _e1540;
                                                phi_2164_ = type_36(0u, type_36().member_1);
                                            }
                                            let _e1556 = phi_2139_;
                                            let _e1558 = phi_2164_;
                                            let _e1562 = (bitcast<i32>(_e1558.member) != 0i);
                                            if _e1562 {
                                                let _e1564 = local_18.member[0u];
                                                let _e1566 = keys.member[_e1564];
                                                local_6 = array<array<u32, 2>, 6>(array<u32, 2>(_e1566[0][0], _e1566[0][1]), array<u32, 2>(_e1566[1][0], _e1566[1][1]), array<u32, 2>(_e1566[2][0], _e1566[2][1]), array<u32, 2>(_e1566[3][0], _e1566[3][1]), array<u32, 2>(_e1566[4][0], _e1566[4][1]), array<u32, 2>(_e1566[5][0], _e1566[5][1]));
                                                if (_e1558.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1594 = local_6[_e1558.member_1];
                                                phi_2221_ = type_36(1u, 3u);
                                                phi_2224_ = array<u32, 2>(_e1594[0], _e1594[1]);
                                                loop {
                                                    let _e1599 = phi_2221_;
                                                    let _e1601 = phi_2224_;
                                                    local_32 = _e1601;
                                                    local_34 = _e1601;
                                                    local_36 = _e1601;
                                                    if (_e1599.member < _e1599.member_1) {
                                                        phi_2222_ = type_36((_e1599.member + 1u), _e1599.member_1);
                                                        phi_2247_ = type_36(1u, _e1599.member);
                                                    } else {
                                                        phi_2222_ = _e1599;
                                                        phi_2247_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1615 = phi_2222_;
                                                    let _e1617 = phi_2247_;
                                                    let _e1621 = (bitcast<i32>(_e1617.member) != 0i);
                                                    if _e1621 {
                                                        if (_e1617.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1624 = local_18.member[_e1617.member_1];
                                                        let _e1626 = keys.member[_e1624];
                                                        local_7 = array<array<u32, 2>, 6>(array<u32, 2>(_e1626[0][0], _e1626[0][1]), array<u32, 2>(_e1626[1][0], _e1626[1][1]), array<u32, 2>(_e1626[2][0], _e1626[2][1]), array<u32, 2>(_e1626[3][0], _e1626[3][1]), array<u32, 2>(_e1626[4][0], _e1626[4][1]), array<u32, 2>(_e1626[5][0], _e1626[5][1]));
                                                        if (_e1558.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1654 = local_7[_e1558.member_1];
                                                        if (_e1601[1] > _e1654[1]) {
                                                            phi_2323_ = true;
                                                        } else {
                                                            if (_e1601[1] == _e1654[1]) {
                                                                phi_2322_ = (_e1601[0] > _e1654[0]);
                                                            } else {
                                                                phi_2322_ = false;
                                                            }
                                                            let _e1665 = phi_2322_;
                                                            phi_2323_ = _e1665;
                                                        }
                                                        let _e1667 = phi_2323_;
                                                        if _e1667 {
                                                            phi_2327_ = array<u32, 2>(_e1654[0], _e1654[1]);
                                                        } else {
                                                            phi_2327_ = _e1601;
                                                        }
                                                        let _e1669 = phi_2327_;
                                                        phi_2225_ = _e1669;
                                                    } else {
                                                        phi_2225_ = array<u32, 2>();
                                                    }
                                                    let _e1671 = phi_2225_;
                                                    continue;
                                                    continuing {
                                                        phi_2221_ = _e1615;
                                                        phi_2224_ = _e1671;
                                                        break if !(_e1621);
                                                    }
                                                }
                                                let _e1674 = local_19.member[0u];
                                                let _e1676 = keys.member[_e1674];
                                                local_4 = array<array<u32, 2>, 6>(array<u32, 2>(_e1676[0][0], _e1676[0][1]), array<u32, 2>(_e1676[1][0], _e1676[1][1]), array<u32, 2>(_e1676[2][0], _e1676[2][1]), array<u32, 2>(_e1676[3][0], _e1676[3][1]), array<u32, 2>(_e1676[4][0], _e1676[4][1]), array<u32, 2>(_e1676[5][0], _e1676[5][1]));
                                                let _e1702 = (3u + _e1558.member_1);
                                                if (_e1702 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1705 = local_4[_e1702];
                                                phi_2378_ = type_36(1u, 3u);
                                                phi_2381_ = array<u32, 2>(_e1705[0], _e1705[1]);
                                                loop {
                                                    let _e1710 = phi_2378_;
                                                    let _e1712 = phi_2381_;
                                                    local_33 = _e1712;
                                                    local_35 = _e1712;
                                                    local_37 = _e1712;
                                                    if (_e1710.member < _e1710.member_1) {
                                                        phi_2379_ = type_36((_e1710.member + 1u), _e1710.member_1);
                                                        phi_2404_ = type_36(1u, _e1710.member);
                                                    } else {
                                                        phi_2379_ = _e1710;
                                                        phi_2404_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1726 = phi_2379_;
                                                    let _e1728 = phi_2404_;
                                                    let _e1732 = (bitcast<i32>(_e1728.member) != 0i);
                                                    if _e1732 {
                                                        if (_e1728.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1735 = local_19.member[_e1728.member_1];
                                                        let _e1737 = keys.member[_e1735];
                                                        local_5 = array<array<u32, 2>, 6>(array<u32, 2>(_e1737[0][0], _e1737[0][1]), array<u32, 2>(_e1737[1][0], _e1737[1][1]), array<u32, 2>(_e1737[2][0], _e1737[2][1]), array<u32, 2>(_e1737[3][0], _e1737[3][1]), array<u32, 2>(_e1737[4][0], _e1737[4][1]), array<u32, 2>(_e1737[5][0], _e1737[5][1]));
                                                        let _e1763 = (3u + _e1558.member_1);
                                                        if (_e1763 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1766 = local_5[_e1763];
                                                        if (_e1766[1] > _e1712[1]) {
                                                            phi_2481_ = true;
                                                        } else {
                                                            if (_e1766[1] == _e1712[1]) {
                                                                phi_2480_ = (_e1766[0] > _e1712[0]);
                                                            } else {
                                                                phi_2480_ = false;
                                                            }
                                                            let _e1777 = phi_2480_;
                                                            phi_2481_ = _e1777;
                                                        }
                                                        let _e1779 = phi_2481_;
                                                        if _e1779 {
                                                            phi_2485_ = array<u32, 2>(_e1766[0], _e1766[1]);
                                                        } else {
                                                            phi_2485_ = _e1712;
                                                        }
                                                        let _e1781 = phi_2485_;
                                                        phi_2382_ = _e1781;
                                                    } else {
                                                        phi_2382_ = array<u32, 2>();
                                                    }
                                                    let _e1783 = phi_2382_;
                                                    continue;
                                                    continuing {
                                                        phi_2378_ = _e1726;
                                                        phi_2381_ = _e1783;
                                                        break if !(_e1732);
                                                    }
                                                }
                                                let _e1786 = local_32;
                                                let _e1789 = local_33;
                                                if (_e1786[1] > _e1789[1]) {
                                                    phi_2502_ = true;
                                                } else {
                                                    let _e1793 = local_34;
                                                    let _e1796 = local_35;
                                                    if (_e1793[1] == _e1796[1]) {
                                                        let _e1800 = local_36;
                                                        let _e1803 = local_37;
                                                        phi_2501_ = (_e1800[0] > _e1803[0]);
                                                    } else {
                                                        phi_2501_ = false;
                                                    }
                                                    let _e1807 = phi_2501_;
                                                    phi_2502_ = _e1807;
                                                }
                                                let _e1809 = phi_2502_;
                                                let _e1812 = local_19.member[0u];
                                                let _e1814 = keys.member[_e1812];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e1814[0][0], _e1814[0][1]), array<u32, 2>(_e1814[1][0], _e1814[1][1]), array<u32, 2>(_e1814[2][0], _e1814[2][1]), array<u32, 2>(_e1814[3][0], _e1814[3][1]), array<u32, 2>(_e1814[4][0], _e1814[4][1]), array<u32, 2>(_e1814[5][0], _e1814[5][1]));
                                                if (_e1558.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1842 = local_2[_e1558.member_1];
                                                phi_2553_ = type_36(1u, 3u);
                                                phi_2556_ = array<u32, 2>(_e1842[0], _e1842[1]);
                                                loop {
                                                    let _e1847 = phi_2553_;
                                                    let _e1849 = phi_2556_;
                                                    local_38 = _e1849;
                                                    local_40 = _e1849;
                                                    local_42 = _e1849;
                                                    if (_e1847.member < _e1847.member_1) {
                                                        phi_2554_ = type_36((_e1847.member + 1u), _e1847.member_1);
                                                        phi_2579_ = type_36(1u, _e1847.member);
                                                    } else {
                                                        phi_2554_ = _e1847;
                                                        phi_2579_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1863 = phi_2554_;
                                                    let _e1865 = phi_2579_;
                                                    let _e1869 = (bitcast<i32>(_e1865.member) != 0i);
                                                    if _e1869 {
                                                        if (_e1865.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1872 = local_19.member[_e1865.member_1];
                                                        let _e1874 = keys.member[_e1872];
                                                        local_3 = array<array<u32, 2>, 6>(array<u32, 2>(_e1874[0][0], _e1874[0][1]), array<u32, 2>(_e1874[1][0], _e1874[1][1]), array<u32, 2>(_e1874[2][0], _e1874[2][1]), array<u32, 2>(_e1874[3][0], _e1874[3][1]), array<u32, 2>(_e1874[4][0], _e1874[4][1]), array<u32, 2>(_e1874[5][0], _e1874[5][1]));
                                                        if (_e1558.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1902 = local_3[_e1558.member_1];
                                                        if (_e1849[1] > _e1902[1]) {
                                                            phi_2655_ = true;
                                                        } else {
                                                            if (_e1849[1] == _e1902[1]) {
                                                                phi_2654_ = (_e1849[0] > _e1902[0]);
                                                            } else {
                                                                phi_2654_ = false;
                                                            }
                                                            let _e1913 = phi_2654_;
                                                            phi_2655_ = _e1913;
                                                        }
                                                        let _e1915 = phi_2655_;
                                                        if _e1915 {
                                                            phi_2659_ = array<u32, 2>(_e1902[0], _e1902[1]);
                                                        } else {
                                                            phi_2659_ = _e1849;
                                                        }
                                                        let _e1917 = phi_2659_;
                                                        phi_2557_ = _e1917;
                                                    } else {
                                                        phi_2557_ = array<u32, 2>();
                                                    }
                                                    let _e1919 = phi_2557_;
                                                    continue;
                                                    continuing {
                                                        phi_2553_ = _e1863;
                                                        phi_2556_ = _e1919;
                                                        break if !(_e1869);
                                                    }
                                                }
                                                let _e1922 = local_18.member[0u];
                                                let _e1924 = keys.member[_e1922];
                                                local = array<array<u32, 2>, 6>(array<u32, 2>(_e1924[0][0], _e1924[0][1]), array<u32, 2>(_e1924[1][0], _e1924[1][1]), array<u32, 2>(_e1924[2][0], _e1924[2][1]), array<u32, 2>(_e1924[3][0], _e1924[3][1]), array<u32, 2>(_e1924[4][0], _e1924[4][1]), array<u32, 2>(_e1924[5][0], _e1924[5][1]));
                                                let _e1950 = (3u + _e1558.member_1);
                                                if (_e1950 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1953 = local[_e1950];
                                                phi_2710_ = type_36(1u, 3u);
                                                phi_2713_ = array<u32, 2>(_e1953[0], _e1953[1]);
                                                loop {
                                                    let _e1958 = phi_2710_;
                                                    let _e1960 = phi_2713_;
                                                    local_39 = _e1960;
                                                    local_41 = _e1960;
                                                    local_43 = _e1960;
                                                    if (_e1958.member < _e1958.member_1) {
                                                        phi_2711_ = type_36((_e1958.member + 1u), _e1958.member_1);
                                                        phi_2736_ = type_36(1u, _e1958.member);
                                                    } else {
                                                        phi_2711_ = _e1958;
                                                        phi_2736_ = type_36(0u, type_36().member_1);
                                                    }
                                                    let _e1974 = phi_2711_;
                                                    let _e1976 = phi_2736_;
                                                    let _e1980 = (bitcast<i32>(_e1976.member) != 0i);
                                                    if _e1980 {
                                                        if (_e1976.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1983 = local_18.member[_e1976.member_1];
                                                        let _e1985 = keys.member[_e1983];
                                                        local_1 = array<array<u32, 2>, 6>(array<u32, 2>(_e1985[0][0], _e1985[0][1]), array<u32, 2>(_e1985[1][0], _e1985[1][1]), array<u32, 2>(_e1985[2][0], _e1985[2][1]), array<u32, 2>(_e1985[3][0], _e1985[3][1]), array<u32, 2>(_e1985[4][0], _e1985[4][1]), array<u32, 2>(_e1985[5][0], _e1985[5][1]));
                                                        let _e2011 = (3u + _e1558.member_1);
                                                        if (_e2011 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2014 = local_1[_e2011];
                                                        if (_e2014[1] > _e1960[1]) {
                                                            phi_2813_ = true;
                                                        } else {
                                                            if (_e2014[1] == _e1960[1]) {
                                                                phi_2812_ = (_e2014[0] > _e1960[0]);
                                                            } else {
                                                                phi_2812_ = false;
                                                            }
                                                            let _e2025 = phi_2812_;
                                                            phi_2813_ = _e2025;
                                                        }
                                                        let _e2027 = phi_2813_;
                                                        if _e2027 {
                                                            phi_2817_ = array<u32, 2>(_e2014[0], _e2014[1]);
                                                        } else {
                                                            phi_2817_ = _e1960;
                                                        }
                                                        let _e2029 = phi_2817_;
                                                        phi_2714_ = _e2029;
                                                    } else {
                                                        phi_2714_ = array<u32, 2>();
                                                    }
                                                    let _e2031 = phi_2714_;
                                                    continue;
                                                    continuing {
                                                        phi_2710_ = _e1974;
                                                        phi_2713_ = _e2031;
                                                        break if !(_e1980);
                                                    }
                                                }
                                                let _e2034 = local_38;
                                                let _e2037 = local_39;
                                                if (_e2034[1] > _e2037[1]) {
                                                    phi_2834_ = true;
                                                } else {
                                                    let _e2041 = local_40;
                                                    let _e2044 = local_41;
                                                    if (_e2041[1] == _e2044[1]) {
                                                        let _e2048 = local_42;
                                                        let _e2051 = local_43;
                                                        phi_2833_ = (_e2048[0] > _e2051[0]);
                                                    } else {
                                                        phi_2833_ = false;
                                                    }
                                                    let _e2055 = phi_2833_;
                                                    phi_2834_ = _e2055;
                                                }
                                                let _e2057 = phi_2834_;
                                                phi_2142_ = (_e1542 && (!(_e1809) && !(_e2057)));
                                            } else {
                                                phi_2142_ = bool();
                                            }
                                            let _e2062 = phi_2142_;
                                            continue;
                                            continuing {
                                                phi_2138_ = _e1556;
                                                phi_2141_ = _e2062;
                                                break if !(_e1562);
                                            }
                                        }
                                        let _e2398 = local_46;
                                        phi_2838_ = _e2398;
                                    }
                                    let _e2065 = phi_2838_;
                                    phi_2839_ = _e2065;
                                    phi_2840_ = _e1536;
                                } else {
                                    phi_2839_ = bool();
                                    phi_2840_ = true;
                                }
                                let _e2067 = phi_2839_;
                                let _e2069 = phi_2840_;
                                if _e2069 {
                                    phi_2844_ = false;
                                } else {
                                    phi_2844_ = true;
                                }
                                let _e2071 = phi_2844_;
                                phi_2845_ = _e2067;
                                phi_2846_ = _e2071;
                            } else {
                                phi_2845_ = false;
                                phi_2846_ = true;
                            }
                            let _e2073 = phi_2845_;
                            let _e2075 = phi_2846_;
                            phi_2847_ = _e2073;
                            phi_2848_ = _e2075;
                        } else {
                            phi_2847_ = false;
                            phi_2848_ = true;
                        }
                        let _e2077 = phi_2847_;
                        let _e2079 = phi_2848_;
                        if _e2079 {
                            phi_2852_ = _e2077;
                        } else {
                            phi_2852_ = true;
                        }
                        let _e2081 = phi_2852_;
                        if _e2081 {
                            let _e2083 = atomicAdd((&counters[7u]), 1u);
                            let _e2085 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1331] = ((2147483648u | (_e2085 << bitcast<u32>(12i))) | _e1334);
                        }
                        phi_2867_ = true;
                    }
                    let _e2092 = phi_2867_;
                    phi_2868_ = _e2092;
                } else {
                    phi_2868_ = false;
                }
                let _e2094 = phi_2868_;
                continue;
                continuing {
                    phi_1835_ = _e1323;
                    break if !(_e2094);
                }
            }
            workgroupBarrier();
            if (_e83 == 0u) {
                let _e2098 = atomicLoad((&counters[5u]));
                if (_e2098 > 0u) {
                    let _e2101 = atomicAdd((&output.member[0u]), _e2098);
                    atomicStore((&counters[6u]), _e2101);
                }
            }
            workgroupBarrier();
            let _e2104 = atomicLoad((&counters[6u]));
            if (_e83 == 0u) {
                let _e2107 = atomicLoad((&counters[7u]));
                if (_e2107 > 0u) {
                    let _e2110 = atomicAdd((&output.member[1u]), _e2107);
                }
            }
            phi_2900_ = type_36(0u, 16u);
            loop {
                let _e2112 = phi_2900_;
                if (_e2112.member < _e2112.member_1) {
                    phi_2901_ = type_36((_e2112.member + 1u), _e2112.member_1);
                    phi_2924_ = type_36(1u, _e2112.member);
                } else {
                    phi_2901_ = _e2112;
                    phi_2924_ = type_36(0u, type_36().member_1);
                }
                let _e2126 = phi_2901_;
                let _e2128 = phi_2924_;
                if (bitcast<i32>(_e2128.member) != 0i) {
                    let _e2134 = (_e83 + (_e2128.member_1 * 128u));
                    if (_e2134 >= _e1307) {
                        phi_3022_ = false;
                    } else {
                        let _e2137 = hits[_e2134];
                        if ((_e2137 & 2147483648u) == 0u) {
                            phi_2947_ = 4294967295u;
                        } else {
                            phi_2947_ = ((_e2137 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e2144 = phi_2947_;
                        if (_e2144 != 4294967295u) {
                            let _e2148 = ((_e2137 >> bitcast<u32>(10i)) & 3u);
                            let _e2155 = firsts[(2u * _e2148)];
                            let _e2158 = leaves.member[(_e2155 + ((_e2137 >> bitcast<u32>(5i)) & 31u))];
                            let _e2162 = firsts[((2u * _e2148) + 1u)];
                            let _e2165 = leaves.member[(_e2162 + (_e2137 & 31u))];
                            let _e2169 = params.member.member_16;
                            let _e2170 = (_e2104 + _e2144);
                            if (_e112[0] == _e112[1]) {
                                if (_e2158.member_1 < _e2165.member_1) {
                                    phi_3001_ = type_36(_e2158.member_1, _e2165.member_1);
                                } else {
                                    phi_3001_ = type_36(_e2165.member_1, _e2158.member_1);
                                }
                                let _e2177 = phi_3001_;
                                phi_3006_ = _e2177;
                            } else {
                                phi_3006_ = type_36(_e2158.member_1, _e2165.member_1);
                            }
                            let _e2179 = phi_3006_;
                            if (_e2170 < _e2169) {
                                atomicStore((&output.member[(4u + (2u * _e2170))]), _e2179.member);
                                atomicStore((&output.member[((2u * _e2170) + 5u)]), _e2179.member_1);
                            }
                        }
                        phi_3022_ = true;
                    }
                    let _e2190 = phi_3022_;
                    phi_3023_ = _e2190;
                } else {
                    phi_3023_ = false;
                }
                let _e2192 = phi_3023_;
                continue;
                continuing {
                    phi_2900_ = _e2126;
                    break if !(_e2192);
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
