struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_11 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<type_6>,
}

struct type_21 {
    member: array<u32>,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_26 {
    member: array<type_23>,
}

struct type_35 {
    member: u32,
    member_1: u32,
}

struct type_54 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_61 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_6, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> leaves: type_26;
@group(0) @binding(3) 
var<storage> bodies: type_21;
@group(0) @binding(4) 
var<storage> keys: type_54;
@group(0) @binding(5) 
var<storage> input: type_21;
@group(0) @binding(6) 
var<storage, read_write> output: type_61;

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
    var local_16: type_23;
    var local_17: type_23;
    var local_18: type_23;
    var local_19: type_23;
    var phi_183_: u32;
    var phi_194_: array<u32, 2>;
    var phi_223_: u32;
    var phi_224_: u32;
    var phi_231_: u32;
    var phi_247_: u32;
    var phi_268_: u32;
    var phi_269_: u32;
    var phi_272_: type_35;
    var phi_273_: type_35;
    var phi_296_: type_35;
    var phi_334_: u32;
    var phi_335_: u32;
    var phi_342_: u32;
    var phi_352_: u32;
    var phi_431_: array<u32, 2>;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_630_: type_6;
    var phi_636_: bool;
    var phi_643_: type_35;
    var phi_646_: u32;
    var phi_644_: type_35;
    var phi_669_: type_35;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_741_: bool;
    var phi_759_: u32;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_647_: u32;
    var phi_764_: type_35;
    var phi_767_: u32;
    var phi_765_: type_35;
    var phi_790_: type_35;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_944_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_906_: bool;
    var phi_945_: bool;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_996_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1061_: type_35;
    var phi_1064_: bool;
    var phi_1062_: type_35;
    var phi_1087_: type_35;
    var phi_1144_: type_35;
    var phi_1147_: array<u32, 2>;
    var phi_1145_: type_35;
    var phi_1170_: type_35;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: array<u32, 2>;
    var phi_1148_: array<u32, 2>;
    var phi_1301_: type_35;
    var phi_1304_: array<u32, 2>;
    var phi_1302_: type_35;
    var phi_1327_: type_35;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1408_: array<u32, 2>;
    var phi_1305_: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var local_22: array<u32, 2>;
    var local_23: array<u32, 2>;
    var local_24: array<u32, 2>;
    var local_25: array<u32, 2>;
    var phi_1424_: bool;
    var phi_1425_: bool;
    var phi_1476_: type_35;
    var phi_1479_: array<u32, 2>;
    var phi_1477_: type_35;
    var phi_1502_: type_35;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1582_: array<u32, 2>;
    var phi_1480_: array<u32, 2>;
    var phi_1633_: type_35;
    var phi_1636_: array<u32, 2>;
    var phi_1634_: type_35;
    var phi_1659_: type_35;
    var phi_1735_: bool;
    var phi_1736_: bool;
    var phi_1740_: array<u32, 2>;
    var phi_1637_: array<u32, 2>;
    var local_26: array<u32, 2>;
    var local_27: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var local_30: array<u32, 2>;
    var local_31: array<u32, 2>;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1065_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1795_: type_35;
    var phi_1800_: type_35;
    var phi_1822_: u32;
    var phi_1823_: bool;
    var phi_768_: u32;
    var phi_1824_: bool;
    var phi_1831_: u32;
    var phi_1834_: type_35;
    var phi_1835_: type_35;
    var phi_1858_: type_35;
    var phi_2012_: bool;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2020_: bool;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1982_: bool;
    var phi_2021_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2072_: bool;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2087_: bool;
    var phi_2088_: bool;
    var phi_2137_: type_35;
    var phi_2140_: bool;
    var phi_2138_: type_35;
    var phi_2163_: type_35;
    var phi_2220_: type_35;
    var phi_2223_: array<u32, 2>;
    var phi_2221_: type_35;
    var phi_2246_: type_35;
    var phi_2321_: bool;
    var phi_2322_: bool;
    var phi_2326_: array<u32, 2>;
    var phi_2224_: array<u32, 2>;
    var phi_2377_: type_35;
    var phi_2380_: array<u32, 2>;
    var phi_2378_: type_35;
    var phi_2403_: type_35;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2484_: array<u32, 2>;
    var phi_2381_: array<u32, 2>;
    var local_32: array<u32, 2>;
    var local_33: array<u32, 2>;
    var local_34: array<u32, 2>;
    var local_35: array<u32, 2>;
    var local_36: array<u32, 2>;
    var local_37: array<u32, 2>;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var phi_2552_: type_35;
    var phi_2555_: array<u32, 2>;
    var phi_2553_: type_35;
    var phi_2578_: type_35;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2658_: array<u32, 2>;
    var phi_2556_: array<u32, 2>;
    var phi_2709_: type_35;
    var phi_2712_: array<u32, 2>;
    var phi_2710_: type_35;
    var phi_2735_: type_35;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2816_: array<u32, 2>;
    var phi_2713_: array<u32, 2>;
    var local_38: array<u32, 2>;
    var local_39: array<u32, 2>;
    var local_40: array<u32, 2>;
    var local_41: array<u32, 2>;
    var local_42: array<u32, 2>;
    var local_43: array<u32, 2>;
    var phi_2832_: bool;
    var phi_2833_: bool;
    var phi_2141_: bool;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var phi_2843_: bool;
    var phi_2844_: bool;
    var phi_2845_: bool;
    var phi_2846_: bool;
    var phi_2847_: bool;
    var phi_2851_: bool;
    var phi_2866_: bool;
    var phi_2867_: bool;
    var phi_2899_: type_35;
    var phi_2900_: type_35;
    var phi_2923_: type_35;
    var phi_2946_: u32;
    var phi_3000_: type_35;
    var phi_3005_: type_35;
    var phi_3021_: bool;
    var phi_3022_: bool;
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
        phi_183_ = _e100;
    } else {
        phi_183_ = _e102;
    }
    let _e105 = phi_183_;
    let _e106 = (_e83 / 32u);
    let _e107 = (_e83 % 32u);
    let _e109 = params.member.member_8;
    if (_e109 == 0u) {
        phi_194_ = array<u32, 2>(0u, 2u);
    } else {
        phi_194_ = array<u32, 2>(1u, 1u);
    }
    let _e112 = phi_194_;
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
            phi_223_ = (_e124 + 1u);
        } else {
            phi_223_ = _e124;
        }
        let _e130 = phi_223_;
        phi_224_ = _e130;
    } else {
        phi_224_ = 0u;
    }
    let _e132 = phi_224_;
    let _e134 = params.member.member_14;
    if (_e134 < _e132) {
        phi_231_ = _e134;
    } else {
        phi_231_ = _e132;
    }
    let _e137 = phi_231_;
    let _e138 = (_e137 / 4u);
    if ((_e137 % 4u) > 0u) {
        phi_247_ = (_e138 + 1u);
    } else {
        phi_247_ = _e138;
    }
    let _e143 = phi_247_;
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
            phi_268_ = (_e147 + 1u);
        } else {
            phi_268_ = _e147;
        }
        let _e153 = phi_268_;
        phi_269_ = _e153;
    } else {
        phi_269_ = 0u;
    }
    let _e155 = phi_269_;
    phi_272_ = type_35(0u, _e155);
    loop {
        let _e158 = phi_272_;
        if (_e158.member < _e158.member_1) {
            phi_273_ = type_35((_e158.member + 1u), _e158.member_1);
            phi_296_ = type_35(1u, _e158.member);
        } else {
            phi_273_ = _e158;
            phi_296_ = type_35(0u, type_35().member_1);
        }
        let _e172 = phi_273_;
        let _e174 = phi_296_;
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
                    phi_334_ = (_e192 + 1u);
                } else {
                    phi_334_ = _e192;
                }
                let _e198 = phi_334_;
                phi_335_ = _e198;
            } else {
                phi_335_ = 0u;
            }
            let _e200 = phi_335_;
            let _e202 = params.member.member_14;
            if (_e202 < _e200) {
                phi_342_ = _e202;
            } else {
                phi_342_ = _e200;
            }
            let _e205 = phi_342_;
            let _e206 = (_e182 < _e205);
            let _e208 = params.member.member_12;
            if _e206 {
                let _e210 = params.member.member_13;
                phi_352_ = (_e182 * _e210);
            } else {
                phi_352_ = 0u;
            }
            let _e213 = phi_352_;
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
            let _e229 = params.member.member_18[0u][_e112[0]];
            let _e230 = (_e229 + (_e218 * 32u));
            if (_e112[1] < 4u) {
            } else {
                return;
            }
            let _e236 = params.member.member_18[0u][_e112[1]];
            let _e237 = (_e236 + (_e221 * 32u));
            if (_e107 == 0u) {
                firsts[(2u * _e106)] = _e230;
                firsts[((2u * _e106) + 1u)] = _e237;
            }
            let _e245 = params.member.member_8;
            if (_e245 == 0u) {
                phi_431_ = array<u32, 2>(0u, 2u);
            } else {
                phi_431_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_431_;
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
            let _e260 = params.member.member_18[_e254][_e248[0]];
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
            let _e271 = params.member.member_18[_e265][_e248[1]];
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
            let _e285 = params.member.member_18[_e277][_e248[0]];
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
            let _e299 = params.member.member_18[_e291][_e248[1]];
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
                    phi_625_ = false;
                } else {
                    phi_625_ = true;
                }
                let _e391 = phi_625_;
                phi_626_ = _e391;
            } else {
                phi_626_ = true;
            }
            let _e393 = phi_626_;
            if _e393 {
                phi_630_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_630_ = _e288;
            }
            let _e395 = phi_630_;
            if (_e112[0] == _e112[1]) {
                phi_636_ = (_e218 == _e221);
            } else {
                phi_636_ = false;
            }
            let _e399 = phi_636_;
            let _e400 = (_e83 / 32u);
            let _e401 = (_e83 % 32u);
            let _e403 = atomicLoad((&counters[_e400]));
            phi_643_ = type_35(0u, _e403);
            phi_646_ = 0u;
            loop {
                let _e406 = phi_643_;
                let _e408 = phi_646_;
                local_44 = _e408;
                if (_e406.member < _e406.member_1) {
                    phi_644_ = type_35((_e406.member + 1u), _e406.member_1);
                    phi_669_ = type_35(1u, _e406.member);
                } else {
                    phi_644_ = _e406;
                    phi_669_ = type_35(0u, type_35().member_1);
                }
                let _e422 = phi_644_;
                let _e424 = phi_669_;
                let _e428 = (bitcast<i32>(_e424.member) != 0i);
                if _e428 {
                    let _e432 = names[((_e400 * 32u) + _e424.member_1)];
                    let _e436 = columns[((_e400 * 32u) + _e424.member_1)];
                    if ((((((_e395.member[0] <= _e436.member_1[0]) && (_e436.member[0] <= _e395.member_1[0])) && (_e395.member[1] <= _e436.member_1[1])) && (_e436.member[1] <= _e395.member_1[1])) && (_e395.member[2] <= _e436.member_1[2])) && (_e436.member[2] <= _e395.member_1[2])) {
                        if _e399 {
                            let _e468 = (_e401 < _e432);
                            if _e468 {
                                phi_735_ = bool();
                            } else {
                                phi_735_ = false;
                            }
                            let _e470 = phi_735_;
                            phi_736_ = _e470;
                            phi_737_ = _e468;
                        } else {
                            phi_736_ = bool();
                            phi_737_ = true;
                        }
                        let _e472 = phi_736_;
                        let _e474 = phi_737_;
                        if _e474 {
                            phi_741_ = true;
                        } else {
                            phi_741_ = _e472;
                        }
                        let _e476 = phi_741_;
                        if _e476 {
                            let _e478 = atomicAdd((&counters[4u]), 1u);
                            if (_e478 < 2048u) {
                                hits[_e478] = (((_e400 << bitcast<u32>(10i)) | (_e401 << bitcast<u32>(5i))) | _e432);
                                phi_759_ = _e408;
                            } else {
                                phi_759_ = (_e408 | (1u << bitcast<u32>((_e424.member_1 & 31u))));
                            }
                            let _e492 = phi_759_;
                            phi_760_ = _e492;
                        } else {
                            phi_760_ = _e408;
                        }
                        let _e494 = phi_760_;
                        phi_761_ = _e494;
                    } else {
                        phi_761_ = _e408;
                    }
                    let _e496 = phi_761_;
                    phi_647_ = _e496;
                } else {
                    phi_647_ = u32();
                }
                let _e498 = phi_647_;
                continue;
                continuing {
                    phi_643_ = _e422;
                    phi_646_ = _e498;
                    break if !(_e428);
                }
            }
            phi_764_ = type_35(0u, 32u);
            let _e2230 = local_44;
            phi_767_ = _e2230;
            loop {
                let _e501 = phi_764_;
                let _e503 = phi_767_;
                if (_e501.member < _e501.member_1) {
                    phi_765_ = type_35((_e501.member + 1u), _e501.member_1);
                    phi_790_ = type_35(1u, _e501.member);
                } else {
                    phi_765_ = _e501;
                    phi_790_ = type_35(0u, type_35().member_1);
                }
                let _e517 = phi_765_;
                let _e519 = phi_790_;
                if (bitcast<i32>(_e519.member) != 0i) {
                    if (_e503 == 0u) {
                        phi_1822_ = u32();
                        phi_1823_ = false;
                    } else {
                        let _e530 = names[((_e106 * 32u) + select(firstTrailingBit(_e503), 32u, (_e503 == 0u)))];
                        let _e533 = (_e230 + _e107);
                        let _e534 = (_e237 + _e530);
                        let _e536 = leaves.member[_e533];
                        let _e538 = leaves.member[_e534];
                        local_16 = type_23(array<u32, 3>(_e536.member[0], _e536.member[1], _e536.member[2]), _e536.member_1);
                        local_17 = type_23(array<u32, 3>(_e538.member[0], _e538.member[1], _e538.member[2]), _e538.member_1);
                        let _e554 = nodes.member[_e533];
                        let _e556 = nodes.member[_e534];
                        let _e558 = params.member.member_1;
                        if ((_e558 & 1u) != 0u) {
                            let _e562 = params.member.member_8;
                            if (_e562 == 0u) {
                                let _e606 = local_16.member[0u];
                                let _e609 = local_17.member[0u];
                                if (_e606 == _e609) {
                                    phi_901_ = bool();
                                    phi_902_ = true;
                                } else {
                                    let _e613 = local_16.member[0u];
                                    let _e616 = local_17.member[1u];
                                    let _e617 = (_e613 == _e616);
                                    if _e617 {
                                        phi_900_ = bool();
                                    } else {
                                        let _e620 = local_16.member[0u];
                                        let _e623 = local_17.member[2u];
                                        phi_900_ = (_e620 == _e623);
                                    }
                                    let _e626 = phi_900_;
                                    phi_901_ = _e626;
                                    phi_902_ = _e617;
                                }
                                let _e628 = phi_901_;
                                let _e630 = phi_902_;
                                if _e630 {
                                    phi_906_ = true;
                                } else {
                                    phi_906_ = _e628;
                                }
                                let _e632 = phi_906_;
                                phi_945_ = _e632;
                            } else {
                                let _e566 = local_16.member[0u];
                                let _e569 = local_17.member[0u];
                                if (_e566 == _e569) {
                                    phi_939_ = bool();
                                    phi_940_ = true;
                                } else {
                                    let _e573 = local_16.member[0u];
                                    let _e576 = local_17.member[1u];
                                    if (_e573 == _e576) {
                                        phi_937_ = bool();
                                        phi_938_ = true;
                                    } else {
                                        let _e580 = local_16.member[1u];
                                        let _e583 = local_17.member[0u];
                                        let _e584 = (_e580 == _e583);
                                        if _e584 {
                                            phi_936_ = bool();
                                        } else {
                                            let _e587 = local_16.member[1u];
                                            let _e590 = local_17.member[1u];
                                            phi_936_ = (_e587 == _e590);
                                        }
                                        let _e593 = phi_936_;
                                        phi_937_ = _e593;
                                        phi_938_ = _e584;
                                    }
                                    let _e595 = phi_937_;
                                    let _e597 = phi_938_;
                                    phi_939_ = _e595;
                                    phi_940_ = _e597;
                                }
                                let _e599 = phi_939_;
                                let _e601 = phi_940_;
                                if _e601 {
                                    phi_944_ = true;
                                } else {
                                    phi_944_ = _e599;
                                }
                                let _e603 = phi_944_;
                                phi_945_ = _e603;
                            }
                            let _e634 = phi_945_;
                            if _e634 {
                                phi_949_ = false;
                            } else {
                                phi_949_ = true;
                            }
                            let _e636 = phi_949_;
                            phi_950_ = _e636;
                        } else {
                            phi_950_ = true;
                        }
                        let _e638 = phi_950_;
                        if _e638 {
                            let _e640 = params.member.member_1;
                            if ((_e640 & 2u) != 0u) {
                                let _e645 = local_16.member[0u];
                                let _e647 = bodies.member[_e645];
                                let _e650 = local_17.member[0u];
                                let _e652 = bodies.member[_e650];
                                if ((_e647 / 2u) == (_e652 / 2u)) {
                                    let _e657 = params.member.member_1;
                                    phi_996_ = !(((_e657 & 4u) != 0u));
                                } else {
                                    phi_996_ = false;
                                }
                                let _e662 = phi_996_;
                                if _e662 {
                                    phi_1007_ = true;
                                } else {
                                    if (((_e647 & _e652) & 1u) == 0u) {
                                        phi_1006_ = false;
                                    } else {
                                        phi_1006_ = true;
                                    }
                                    let _e667 = phi_1006_;
                                    phi_1007_ = _e667;
                                }
                                let _e669 = phi_1007_;
                                if _e669 {
                                    phi_1011_ = false;
                                } else {
                                    phi_1011_ = true;
                                }
                                let _e671 = phi_1011_;
                                phi_1012_ = _e671;
                            } else {
                                phi_1012_ = true;
                            }
                            let _e673 = phi_1012_;
                            if _e673 {
                                let _e675 = params.member.member_1;
                                if ((_e675 & 32u) != 0u) {
                                    let _e679 = params.member.member_6;
                                    let _e720 = (((((((_e554.member_1[0] - _e556.member[0]) > _e679) && ((_e556.member_1[0] - _e554.member[0]) > _e679)) && ((_e554.member_1[1] - _e556.member[1]) > _e679)) && ((_e556.member_1[1] - _e554.member[1]) > _e679)) && ((_e554.member_1[2] - _e556.member[2]) > _e679)) && ((_e556.member_1[2] - _e554.member[2]) > _e679));
                                    if _e720 {
                                        phi_1761_ = bool();
                                    } else {
                                        phi_1061_ = type_35(0u, 3u);
                                        phi_1064_ = true;
                                        loop {
                                            let _e724 = phi_1061_;
                                            let _e726 = phi_1064_;
                                            local_45 = _e726;
                                            if (_e724.member < _e724.member_1) {
                                                phi_1062_ = type_35((_e724.member + 1u), _e724.member_1);
                                                phi_1087_ = type_35(1u, _e724.member);
                                            } else {
                                                phi_1062_ = _e724;
                                                phi_1087_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e740 = phi_1062_;
                                            let _e742 = phi_1087_;
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
                                                phi_1144_ = type_35(1u, 3u);
                                                phi_1147_ = array<u32, 2>(_e778[0], _e778[1]);
                                                loop {
                                                    let _e783 = phi_1144_;
                                                    let _e785 = phi_1147_;
                                                    local_20 = _e785;
                                                    local_22 = _e785;
                                                    local_24 = _e785;
                                                    if (_e783.member < _e783.member_1) {
                                                        phi_1145_ = type_35((_e783.member + 1u), _e783.member_1);
                                                        phi_1170_ = type_35(1u, _e783.member);
                                                    } else {
                                                        phi_1145_ = _e783;
                                                        phi_1170_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e799 = phi_1145_;
                                                    let _e801 = phi_1170_;
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
                                                            phi_1246_ = true;
                                                        } else {
                                                            if (_e785[1] == _e838[1]) {
                                                                phi_1245_ = (_e785[0] > _e838[0]);
                                                            } else {
                                                                phi_1245_ = false;
                                                            }
                                                            let _e849 = phi_1245_;
                                                            phi_1246_ = _e849;
                                                        }
                                                        let _e851 = phi_1246_;
                                                        if _e851 {
                                                            phi_1250_ = array<u32, 2>(_e838[0], _e838[1]);
                                                        } else {
                                                            phi_1250_ = _e785;
                                                        }
                                                        let _e853 = phi_1250_;
                                                        phi_1148_ = _e853;
                                                    } else {
                                                        phi_1148_ = array<u32, 2>();
                                                    }
                                                    let _e855 = phi_1148_;
                                                    continue;
                                                    continuing {
                                                        phi_1144_ = _e799;
                                                        phi_1147_ = _e855;
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
                                                phi_1301_ = type_35(1u, 3u);
                                                phi_1304_ = array<u32, 2>(_e889[0], _e889[1]);
                                                loop {
                                                    let _e894 = phi_1301_;
                                                    let _e896 = phi_1304_;
                                                    local_21 = _e896;
                                                    local_23 = _e896;
                                                    local_25 = _e896;
                                                    if (_e894.member < _e894.member_1) {
                                                        phi_1302_ = type_35((_e894.member + 1u), _e894.member_1);
                                                        phi_1327_ = type_35(1u, _e894.member);
                                                    } else {
                                                        phi_1302_ = _e894;
                                                        phi_1327_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e910 = phi_1302_;
                                                    let _e912 = phi_1327_;
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
                                                            phi_1404_ = true;
                                                        } else {
                                                            if (_e950[1] == _e896[1]) {
                                                                phi_1403_ = (_e950[0] > _e896[0]);
                                                            } else {
                                                                phi_1403_ = false;
                                                            }
                                                            let _e961 = phi_1403_;
                                                            phi_1404_ = _e961;
                                                        }
                                                        let _e963 = phi_1404_;
                                                        if _e963 {
                                                            phi_1408_ = array<u32, 2>(_e950[0], _e950[1]);
                                                        } else {
                                                            phi_1408_ = _e896;
                                                        }
                                                        let _e965 = phi_1408_;
                                                        phi_1305_ = _e965;
                                                    } else {
                                                        phi_1305_ = array<u32, 2>();
                                                    }
                                                    let _e967 = phi_1305_;
                                                    continue;
                                                    continuing {
                                                        phi_1301_ = _e910;
                                                        phi_1304_ = _e967;
                                                        break if !(_e916);
                                                    }
                                                }
                                                let _e970 = local_20;
                                                let _e973 = local_21;
                                                if (_e970[1] > _e973[1]) {
                                                    phi_1425_ = true;
                                                } else {
                                                    let _e977 = local_22;
                                                    let _e980 = local_23;
                                                    if (_e977[1] == _e980[1]) {
                                                        let _e984 = local_24;
                                                        let _e987 = local_25;
                                                        phi_1424_ = (_e984[0] > _e987[0]);
                                                    } else {
                                                        phi_1424_ = false;
                                                    }
                                                    let _e991 = phi_1424_;
                                                    phi_1425_ = _e991;
                                                }
                                                let _e993 = phi_1425_;
                                                let _e996 = local_17.member[0u];
                                                let _e998 = keys.member[_e996];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e998[0][0], _e998[0][1]), array<u32, 2>(_e998[1][0], _e998[1][1]), array<u32, 2>(_e998[2][0], _e998[2][1]), array<u32, 2>(_e998[3][0], _e998[3][1]), array<u32, 2>(_e998[4][0], _e998[4][1]), array<u32, 2>(_e998[5][0], _e998[5][1]));
                                                if (_e742.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1026 = local_10[_e742.member_1];
                                                phi_1476_ = type_35(1u, 3u);
                                                phi_1479_ = array<u32, 2>(_e1026[0], _e1026[1]);
                                                loop {
                                                    let _e1031 = phi_1476_;
                                                    let _e1033 = phi_1479_;
                                                    local_26 = _e1033;
                                                    local_28 = _e1033;
                                                    local_30 = _e1033;
                                                    if (_e1031.member < _e1031.member_1) {
                                                        phi_1477_ = type_35((_e1031.member + 1u), _e1031.member_1);
                                                        phi_1502_ = type_35(1u, _e1031.member);
                                                    } else {
                                                        phi_1477_ = _e1031;
                                                        phi_1502_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1047 = phi_1477_;
                                                    let _e1049 = phi_1502_;
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
                                                            phi_1578_ = true;
                                                        } else {
                                                            if (_e1033[1] == _e1086[1]) {
                                                                phi_1577_ = (_e1033[0] > _e1086[0]);
                                                            } else {
                                                                phi_1577_ = false;
                                                            }
                                                            let _e1097 = phi_1577_;
                                                            phi_1578_ = _e1097;
                                                        }
                                                        let _e1099 = phi_1578_;
                                                        if _e1099 {
                                                            phi_1582_ = array<u32, 2>(_e1086[0], _e1086[1]);
                                                        } else {
                                                            phi_1582_ = _e1033;
                                                        }
                                                        let _e1101 = phi_1582_;
                                                        phi_1480_ = _e1101;
                                                    } else {
                                                        phi_1480_ = array<u32, 2>();
                                                    }
                                                    let _e1103 = phi_1480_;
                                                    continue;
                                                    continuing {
                                                        phi_1476_ = _e1047;
                                                        phi_1479_ = _e1103;
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
                                                phi_1633_ = type_35(1u, 3u);
                                                phi_1636_ = array<u32, 2>(_e1137[0], _e1137[1]);
                                                loop {
                                                    let _e1142 = phi_1633_;
                                                    let _e1144 = phi_1636_;
                                                    local_27 = _e1144;
                                                    local_29 = _e1144;
                                                    local_31 = _e1144;
                                                    if (_e1142.member < _e1142.member_1) {
                                                        phi_1634_ = type_35((_e1142.member + 1u), _e1142.member_1);
                                                        phi_1659_ = type_35(1u, _e1142.member);
                                                    } else {
                                                        phi_1634_ = _e1142;
                                                        phi_1659_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1158 = phi_1634_;
                                                    let _e1160 = phi_1659_;
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
                                                            phi_1736_ = true;
                                                        } else {
                                                            if (_e1198[1] == _e1144[1]) {
                                                                phi_1735_ = (_e1198[0] > _e1144[0]);
                                                            } else {
                                                                phi_1735_ = false;
                                                            }
                                                            let _e1209 = phi_1735_;
                                                            phi_1736_ = _e1209;
                                                        }
                                                        let _e1211 = phi_1736_;
                                                        if _e1211 {
                                                            phi_1740_ = array<u32, 2>(_e1198[0], _e1198[1]);
                                                        } else {
                                                            phi_1740_ = _e1144;
                                                        }
                                                        let _e1213 = phi_1740_;
                                                        phi_1637_ = _e1213;
                                                    } else {
                                                        phi_1637_ = array<u32, 2>();
                                                    }
                                                    let _e1215 = phi_1637_;
                                                    continue;
                                                    continuing {
                                                        phi_1633_ = _e1158;
                                                        phi_1636_ = _e1215;
                                                        break if !(_e1164);
                                                    }
                                                }
                                                let _e1218 = local_26;
                                                let _e1221 = local_27;
                                                if (_e1218[1] > _e1221[1]) {
                                                    phi_1757_ = true;
                                                } else {
                                                    let _e1225 = local_28;
                                                    let _e1228 = local_29;
                                                    if (_e1225[1] == _e1228[1]) {
                                                        let _e1232 = local_30;
                                                        let _e1235 = local_31;
                                                        phi_1756_ = (_e1232[0] > _e1235[0]);
                                                    } else {
                                                        phi_1756_ = false;
                                                    }
                                                    let _e1239 = phi_1756_;
                                                    phi_1757_ = _e1239;
                                                }
                                                let _e1241 = phi_1757_;
                                                phi_1065_ = (_e726 && (!(_e993) && !(_e1241)));
                                            } else {
                                                phi_1065_ = bool();
                                            }
                                            let _e1246 = phi_1065_;
                                            continue;
                                            continuing {
                                                phi_1061_ = _e740;
                                                phi_1064_ = _e1246;
                                                break if !(_e746);
                                            }
                                        }
                                        let _e2306 = local_45;
                                        phi_1761_ = _e2306;
                                    }
                                    let _e1249 = phi_1761_;
                                    phi_1762_ = _e1249;
                                    phi_1763_ = _e720;
                                } else {
                                    phi_1762_ = bool();
                                    phi_1763_ = true;
                                }
                                let _e1251 = phi_1762_;
                                let _e1253 = phi_1763_;
                                if _e1253 {
                                    phi_1767_ = false;
                                } else {
                                    phi_1767_ = true;
                                }
                                let _e1255 = phi_1767_;
                                phi_1768_ = _e1251;
                                phi_1769_ = _e1255;
                            } else {
                                phi_1768_ = false;
                                phi_1769_ = true;
                            }
                            let _e1257 = phi_1768_;
                            let _e1259 = phi_1769_;
                            phi_1770_ = _e1257;
                            phi_1771_ = _e1259;
                        } else {
                            phi_1770_ = false;
                            phi_1771_ = true;
                        }
                        let _e1261 = phi_1770_;
                        let _e1263 = phi_1771_;
                        if _e1263 {
                            phi_1775_ = _e1261;
                        } else {
                            phi_1775_ = true;
                        }
                        let _e1265 = phi_1775_;
                        if _e1265 {
                            let _e1267 = params.member.member_16;
                            let _e1270 = local_16.member_1;
                            let _e1272 = local_17.member_1;
                            if (_e112[0] == _e112[1]) {
                                if (_e1270 < _e1272) {
                                    phi_1795_ = type_35(_e1270, _e1272);
                                } else {
                                    phi_1795_ = type_35(_e1272, _e1270);
                                }
                                let _e1278 = phi_1795_;
                                phi_1800_ = _e1278;
                            } else {
                                phi_1800_ = type_35(_e1270, _e1272);
                            }
                            let _e1280 = phi_1800_;
                            let _e1284 = atomicAdd((&output.member[0u]), 1u);
                            if (_e1284 < _e1267) {
                                atomicStore((&output.member[(4u + (2u * _e1284))]), _e1280.member);
                                atomicStore((&output.member[((2u * _e1284) + 5u)]), _e1280.member_1);
                            }
                            let _e1293 = atomicAdd((&output.member[1u]), 1u);
                        }
                        phi_1822_ = (_e503 & (_e503 - 1u));
                        phi_1823_ = true;
                    }
                    let _e1295 = phi_1822_;
                    let _e1297 = phi_1823_;
                    phi_768_ = _e1295;
                    phi_1824_ = _e1297;
                } else {
                    phi_768_ = u32();
                    phi_1824_ = false;
                }
                let _e1299 = phi_768_;
                let _e1301 = phi_1824_;
                continue;
                continuing {
                    phi_764_ = _e517;
                    phi_767_ = _e1299;
                    break if !(_e1301);
                }
            }
            workgroupBarrier();
            let _e1304 = atomicLoad((&counters[4u]));
            if (2048u < _e1304) {
                phi_1831_ = 2048u;
            } else {
                phi_1831_ = _e1304;
            }
            let _e1307 = phi_1831_;
            phi_1834_ = type_35(0u, 16u);
            loop {
                let _e1309 = phi_1834_;
                if (_e1309.member < _e1309.member_1) {
                    phi_1835_ = type_35((_e1309.member + 1u), _e1309.member_1);
                    phi_1858_ = type_35(1u, _e1309.member);
                } else {
                    phi_1835_ = _e1309;
                    phi_1858_ = type_35(0u, type_35().member_1);
                }
                let _e1323 = phi_1835_;
                let _e1325 = phi_1858_;
                if (bitcast<i32>(_e1325.member) != 0i) {
                    let _e1331 = (_e83 + (_e1325.member_1 * 128u));
                    if (_e1331 >= _e1307) {
                        phi_2866_ = false;
                    } else {
                        let _e1334 = hits[_e1331];
                        let _e1337 = ((_e1334 >> bitcast<u32>(10i)) & 3u);
                        let _e1344 = firsts[(2u * _e1337)];
                        let _e1345 = (_e1344 + ((_e1334 >> bitcast<u32>(5i)) & 31u));
                        let _e1349 = firsts[((2u * _e1337) + 1u)];
                        let _e1350 = (_e1349 + (_e1334 & 31u));
                        let _e1352 = leaves.member[_e1345];
                        let _e1354 = leaves.member[_e1350];
                        local_18 = type_23(array<u32, 3>(_e1352.member[0], _e1352.member[1], _e1352.member[2]), _e1352.member_1);
                        local_19 = type_23(array<u32, 3>(_e1354.member[0], _e1354.member[1], _e1354.member[2]), _e1354.member_1);
                        let _e1370 = nodes.member[_e1345];
                        let _e1372 = nodes.member[_e1350];
                        let _e1374 = params.member.member_1;
                        if ((_e1374 & 1u) != 0u) {
                            let _e1378 = params.member.member_8;
                            if (_e1378 == 0u) {
                                let _e1422 = local_18.member[0u];
                                let _e1425 = local_19.member[0u];
                                if (_e1422 == _e1425) {
                                    phi_1977_ = bool();
                                    phi_1978_ = true;
                                } else {
                                    let _e1429 = local_18.member[0u];
                                    let _e1432 = local_19.member[1u];
                                    let _e1433 = (_e1429 == _e1432);
                                    if _e1433 {
                                        phi_1976_ = bool();
                                    } else {
                                        let _e1436 = local_18.member[0u];
                                        let _e1439 = local_19.member[2u];
                                        phi_1976_ = (_e1436 == _e1439);
                                    }
                                    let _e1442 = phi_1976_;
                                    phi_1977_ = _e1442;
                                    phi_1978_ = _e1433;
                                }
                                let _e1444 = phi_1977_;
                                let _e1446 = phi_1978_;
                                if _e1446 {
                                    phi_1982_ = true;
                                } else {
                                    phi_1982_ = _e1444;
                                }
                                let _e1448 = phi_1982_;
                                phi_2021_ = _e1448;
                            } else {
                                let _e1382 = local_18.member[0u];
                                let _e1385 = local_19.member[0u];
                                if (_e1382 == _e1385) {
                                    phi_2015_ = bool();
                                    phi_2016_ = true;
                                } else {
                                    let _e1389 = local_18.member[0u];
                                    let _e1392 = local_19.member[1u];
                                    if (_e1389 == _e1392) {
                                        phi_2013_ = bool();
                                        phi_2014_ = true;
                                    } else {
                                        let _e1396 = local_18.member[1u];
                                        let _e1399 = local_19.member[0u];
                                        let _e1400 = (_e1396 == _e1399);
                                        if _e1400 {
                                            phi_2012_ = bool();
                                        } else {
                                            let _e1403 = local_18.member[1u];
                                            let _e1406 = local_19.member[1u];
                                            phi_2012_ = (_e1403 == _e1406);
                                        }
                                        let _e1409 = phi_2012_;
                                        phi_2013_ = _e1409;
                                        phi_2014_ = _e1400;
                                    }
                                    let _e1411 = phi_2013_;
                                    let _e1413 = phi_2014_;
                                    phi_2015_ = _e1411;
                                    phi_2016_ = _e1413;
                                }
                                let _e1415 = phi_2015_;
                                let _e1417 = phi_2016_;
                                if _e1417 {
                                    phi_2020_ = true;
                                } else {
                                    phi_2020_ = _e1415;
                                }
                                let _e1419 = phi_2020_;
                                phi_2021_ = _e1419;
                            }
                            let _e1450 = phi_2021_;
                            if _e1450 {
                                phi_2025_ = false;
                            } else {
                                phi_2025_ = true;
                            }
                            let _e1452 = phi_2025_;
                            phi_2026_ = _e1452;
                        } else {
                            phi_2026_ = true;
                        }
                        let _e1454 = phi_2026_;
                        if _e1454 {
                            let _e1456 = params.member.member_1;
                            if ((_e1456 & 2u) != 0u) {
                                let _e1461 = local_18.member[0u];
                                let _e1463 = bodies.member[_e1461];
                                let _e1466 = local_19.member[0u];
                                let _e1468 = bodies.member[_e1466];
                                if ((_e1463 / 2u) == (_e1468 / 2u)) {
                                    let _e1473 = params.member.member_1;
                                    phi_2072_ = !(((_e1473 & 4u) != 0u));
                                } else {
                                    phi_2072_ = false;
                                }
                                let _e1478 = phi_2072_;
                                if _e1478 {
                                    phi_2083_ = true;
                                } else {
                                    if (((_e1463 & _e1468) & 1u) == 0u) {
                                        phi_2082_ = false;
                                    } else {
                                        phi_2082_ = true;
                                    }
                                    let _e1483 = phi_2082_;
                                    phi_2083_ = _e1483;
                                }
                                let _e1485 = phi_2083_;
                                if _e1485 {
                                    phi_2087_ = false;
                                } else {
                                    phi_2087_ = true;
                                }
                                let _e1487 = phi_2087_;
                                phi_2088_ = _e1487;
                            } else {
                                phi_2088_ = true;
                            }
                            let _e1489 = phi_2088_;
                            if _e1489 {
                                let _e1491 = params.member.member_1;
                                if ((_e1491 & 32u) != 0u) {
                                    let _e1495 = params.member.member_6;
                                    let _e1536 = (((((((_e1370.member_1[0] - _e1372.member[0]) > _e1495) && ((_e1372.member_1[0] - _e1370.member[0]) > _e1495)) && ((_e1370.member_1[1] - _e1372.member[1]) > _e1495)) && ((_e1372.member_1[1] - _e1370.member[1]) > _e1495)) && ((_e1370.member_1[2] - _e1372.member[2]) > _e1495)) && ((_e1372.member_1[2] - _e1370.member[2]) > _e1495));
                                    if _e1536 {
                                        phi_2837_ = bool();
                                    } else {
                                        phi_2137_ = type_35(0u, 3u);
                                        phi_2140_ = true;
                                        loop {
                                            let _e1540 = phi_2137_;
                                            let _e1542 = phi_2140_;
                                            local_46 = _e1542;
                                            if (_e1540.member < _e1540.member_1) {
                                                phi_2138_ = type_35((_e1540.member + 1u), _e1540.member_1);
                                                phi_2163_ = type_35(1u, _e1540.member);
                                            } else {
                                                phi_2138_ = _e1540;
                                                phi_2163_ = type_35(0u, type_35().member_1);
                                            }
                                            let _e1556 = phi_2138_;
                                            let _e1558 = phi_2163_;
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
                                                phi_2220_ = type_35(1u, 3u);
                                                phi_2223_ = array<u32, 2>(_e1594[0], _e1594[1]);
                                                loop {
                                                    let _e1599 = phi_2220_;
                                                    let _e1601 = phi_2223_;
                                                    local_32 = _e1601;
                                                    local_34 = _e1601;
                                                    local_36 = _e1601;
                                                    if (_e1599.member < _e1599.member_1) {
                                                        phi_2221_ = type_35((_e1599.member + 1u), _e1599.member_1);
                                                        phi_2246_ = type_35(1u, _e1599.member);
                                                    } else {
                                                        phi_2221_ = _e1599;
                                                        phi_2246_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1615 = phi_2221_;
                                                    let _e1617 = phi_2246_;
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
                                                            phi_2322_ = true;
                                                        } else {
                                                            if (_e1601[1] == _e1654[1]) {
                                                                phi_2321_ = (_e1601[0] > _e1654[0]);
                                                            } else {
                                                                phi_2321_ = false;
                                                            }
                                                            let _e1665 = phi_2321_;
                                                            phi_2322_ = _e1665;
                                                        }
                                                        let _e1667 = phi_2322_;
                                                        if _e1667 {
                                                            phi_2326_ = array<u32, 2>(_e1654[0], _e1654[1]);
                                                        } else {
                                                            phi_2326_ = _e1601;
                                                        }
                                                        let _e1669 = phi_2326_;
                                                        phi_2224_ = _e1669;
                                                    } else {
                                                        phi_2224_ = array<u32, 2>();
                                                    }
                                                    let _e1671 = phi_2224_;
                                                    continue;
                                                    continuing {
                                                        phi_2220_ = _e1615;
                                                        phi_2223_ = _e1671;
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
                                                phi_2377_ = type_35(1u, 3u);
                                                phi_2380_ = array<u32, 2>(_e1705[0], _e1705[1]);
                                                loop {
                                                    let _e1710 = phi_2377_;
                                                    let _e1712 = phi_2380_;
                                                    local_33 = _e1712;
                                                    local_35 = _e1712;
                                                    local_37 = _e1712;
                                                    if (_e1710.member < _e1710.member_1) {
                                                        phi_2378_ = type_35((_e1710.member + 1u), _e1710.member_1);
                                                        phi_2403_ = type_35(1u, _e1710.member);
                                                    } else {
                                                        phi_2378_ = _e1710;
                                                        phi_2403_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1726 = phi_2378_;
                                                    let _e1728 = phi_2403_;
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
                                                            phi_2480_ = true;
                                                        } else {
                                                            if (_e1766[1] == _e1712[1]) {
                                                                phi_2479_ = (_e1766[0] > _e1712[0]);
                                                            } else {
                                                                phi_2479_ = false;
                                                            }
                                                            let _e1777 = phi_2479_;
                                                            phi_2480_ = _e1777;
                                                        }
                                                        let _e1779 = phi_2480_;
                                                        if _e1779 {
                                                            phi_2484_ = array<u32, 2>(_e1766[0], _e1766[1]);
                                                        } else {
                                                            phi_2484_ = _e1712;
                                                        }
                                                        let _e1781 = phi_2484_;
                                                        phi_2381_ = _e1781;
                                                    } else {
                                                        phi_2381_ = array<u32, 2>();
                                                    }
                                                    let _e1783 = phi_2381_;
                                                    continue;
                                                    continuing {
                                                        phi_2377_ = _e1726;
                                                        phi_2380_ = _e1783;
                                                        break if !(_e1732);
                                                    }
                                                }
                                                let _e1786 = local_32;
                                                let _e1789 = local_33;
                                                if (_e1786[1] > _e1789[1]) {
                                                    phi_2501_ = true;
                                                } else {
                                                    let _e1793 = local_34;
                                                    let _e1796 = local_35;
                                                    if (_e1793[1] == _e1796[1]) {
                                                        let _e1800 = local_36;
                                                        let _e1803 = local_37;
                                                        phi_2500_ = (_e1800[0] > _e1803[0]);
                                                    } else {
                                                        phi_2500_ = false;
                                                    }
                                                    let _e1807 = phi_2500_;
                                                    phi_2501_ = _e1807;
                                                }
                                                let _e1809 = phi_2501_;
                                                let _e1812 = local_19.member[0u];
                                                let _e1814 = keys.member[_e1812];
                                                local_2 = array<array<u32, 2>, 6>(array<u32, 2>(_e1814[0][0], _e1814[0][1]), array<u32, 2>(_e1814[1][0], _e1814[1][1]), array<u32, 2>(_e1814[2][0], _e1814[2][1]), array<u32, 2>(_e1814[3][0], _e1814[3][1]), array<u32, 2>(_e1814[4][0], _e1814[4][1]), array<u32, 2>(_e1814[5][0], _e1814[5][1]));
                                                if (_e1558.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1842 = local_2[_e1558.member_1];
                                                phi_2552_ = type_35(1u, 3u);
                                                phi_2555_ = array<u32, 2>(_e1842[0], _e1842[1]);
                                                loop {
                                                    let _e1847 = phi_2552_;
                                                    let _e1849 = phi_2555_;
                                                    local_38 = _e1849;
                                                    local_40 = _e1849;
                                                    local_42 = _e1849;
                                                    if (_e1847.member < _e1847.member_1) {
                                                        phi_2553_ = type_35((_e1847.member + 1u), _e1847.member_1);
                                                        phi_2578_ = type_35(1u, _e1847.member);
                                                    } else {
                                                        phi_2553_ = _e1847;
                                                        phi_2578_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1863 = phi_2553_;
                                                    let _e1865 = phi_2578_;
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
                                                            phi_2654_ = true;
                                                        } else {
                                                            if (_e1849[1] == _e1902[1]) {
                                                                phi_2653_ = (_e1849[0] > _e1902[0]);
                                                            } else {
                                                                phi_2653_ = false;
                                                            }
                                                            let _e1913 = phi_2653_;
                                                            phi_2654_ = _e1913;
                                                        }
                                                        let _e1915 = phi_2654_;
                                                        if _e1915 {
                                                            phi_2658_ = array<u32, 2>(_e1902[0], _e1902[1]);
                                                        } else {
                                                            phi_2658_ = _e1849;
                                                        }
                                                        let _e1917 = phi_2658_;
                                                        phi_2556_ = _e1917;
                                                    } else {
                                                        phi_2556_ = array<u32, 2>();
                                                    }
                                                    let _e1919 = phi_2556_;
                                                    continue;
                                                    continuing {
                                                        phi_2552_ = _e1863;
                                                        phi_2555_ = _e1919;
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
                                                phi_2709_ = type_35(1u, 3u);
                                                phi_2712_ = array<u32, 2>(_e1953[0], _e1953[1]);
                                                loop {
                                                    let _e1958 = phi_2709_;
                                                    let _e1960 = phi_2712_;
                                                    local_39 = _e1960;
                                                    local_41 = _e1960;
                                                    local_43 = _e1960;
                                                    if (_e1958.member < _e1958.member_1) {
                                                        phi_2710_ = type_35((_e1958.member + 1u), _e1958.member_1);
                                                        phi_2735_ = type_35(1u, _e1958.member);
                                                    } else {
                                                        phi_2710_ = _e1958;
                                                        phi_2735_ = type_35(0u, type_35().member_1);
                                                    }
                                                    let _e1974 = phi_2710_;
                                                    let _e1976 = phi_2735_;
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
                                                            phi_2812_ = true;
                                                        } else {
                                                            if (_e2014[1] == _e1960[1]) {
                                                                phi_2811_ = (_e2014[0] > _e1960[0]);
                                                            } else {
                                                                phi_2811_ = false;
                                                            }
                                                            let _e2025 = phi_2811_;
                                                            phi_2812_ = _e2025;
                                                        }
                                                        let _e2027 = phi_2812_;
                                                        if _e2027 {
                                                            phi_2816_ = array<u32, 2>(_e2014[0], _e2014[1]);
                                                        } else {
                                                            phi_2816_ = _e1960;
                                                        }
                                                        let _e2029 = phi_2816_;
                                                        phi_2713_ = _e2029;
                                                    } else {
                                                        phi_2713_ = array<u32, 2>();
                                                    }
                                                    let _e2031 = phi_2713_;
                                                    continue;
                                                    continuing {
                                                        phi_2709_ = _e1974;
                                                        phi_2712_ = _e2031;
                                                        break if !(_e1980);
                                                    }
                                                }
                                                let _e2034 = local_38;
                                                let _e2037 = local_39;
                                                if (_e2034[1] > _e2037[1]) {
                                                    phi_2833_ = true;
                                                } else {
                                                    let _e2041 = local_40;
                                                    let _e2044 = local_41;
                                                    if (_e2041[1] == _e2044[1]) {
                                                        let _e2048 = local_42;
                                                        let _e2051 = local_43;
                                                        phi_2832_ = (_e2048[0] > _e2051[0]);
                                                    } else {
                                                        phi_2832_ = false;
                                                    }
                                                    let _e2055 = phi_2832_;
                                                    phi_2833_ = _e2055;
                                                }
                                                let _e2057 = phi_2833_;
                                                phi_2141_ = (_e1542 && (!(_e1809) && !(_e2057)));
                                            } else {
                                                phi_2141_ = bool();
                                            }
                                            let _e2062 = phi_2141_;
                                            continue;
                                            continuing {
                                                phi_2137_ = _e1556;
                                                phi_2140_ = _e2062;
                                                break if !(_e1562);
                                            }
                                        }
                                        let _e2398 = local_46;
                                        phi_2837_ = _e2398;
                                    }
                                    let _e2065 = phi_2837_;
                                    phi_2838_ = _e2065;
                                    phi_2839_ = _e1536;
                                } else {
                                    phi_2838_ = bool();
                                    phi_2839_ = true;
                                }
                                let _e2067 = phi_2838_;
                                let _e2069 = phi_2839_;
                                if _e2069 {
                                    phi_2843_ = false;
                                } else {
                                    phi_2843_ = true;
                                }
                                let _e2071 = phi_2843_;
                                phi_2844_ = _e2067;
                                phi_2845_ = _e2071;
                            } else {
                                phi_2844_ = false;
                                phi_2845_ = true;
                            }
                            let _e2073 = phi_2844_;
                            let _e2075 = phi_2845_;
                            phi_2846_ = _e2073;
                            phi_2847_ = _e2075;
                        } else {
                            phi_2846_ = false;
                            phi_2847_ = true;
                        }
                        let _e2077 = phi_2846_;
                        let _e2079 = phi_2847_;
                        if _e2079 {
                            phi_2851_ = _e2077;
                        } else {
                            phi_2851_ = true;
                        }
                        let _e2081 = phi_2851_;
                        if _e2081 {
                            let _e2083 = atomicAdd((&counters[7u]), 1u);
                            let _e2085 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1331] = ((2147483648u | (_e2085 << bitcast<u32>(12i))) | _e1334);
                        }
                        phi_2866_ = true;
                    }
                    let _e2092 = phi_2866_;
                    phi_2867_ = _e2092;
                } else {
                    phi_2867_ = false;
                }
                let _e2094 = phi_2867_;
                continue;
                continuing {
                    phi_1834_ = _e1323;
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
            phi_2899_ = type_35(0u, 16u);
            loop {
                let _e2112 = phi_2899_;
                if (_e2112.member < _e2112.member_1) {
                    phi_2900_ = type_35((_e2112.member + 1u), _e2112.member_1);
                    phi_2923_ = type_35(1u, _e2112.member);
                } else {
                    phi_2900_ = _e2112;
                    phi_2923_ = type_35(0u, type_35().member_1);
                }
                let _e2126 = phi_2900_;
                let _e2128 = phi_2923_;
                if (bitcast<i32>(_e2128.member) != 0i) {
                    let _e2134 = (_e83 + (_e2128.member_1 * 128u));
                    if (_e2134 >= _e1307) {
                        phi_3021_ = false;
                    } else {
                        let _e2137 = hits[_e2134];
                        if ((_e2137 & 2147483648u) == 0u) {
                            phi_2946_ = 4294967295u;
                        } else {
                            phi_2946_ = ((_e2137 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e2144 = phi_2946_;
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
                                    phi_3000_ = type_35(_e2158.member_1, _e2165.member_1);
                                } else {
                                    phi_3000_ = type_35(_e2165.member_1, _e2158.member_1);
                                }
                                let _e2177 = phi_3000_;
                                phi_3005_ = _e2177;
                            } else {
                                phi_3005_ = type_35(_e2158.member_1, _e2165.member_1);
                            }
                            let _e2179 = phi_3005_;
                            if (_e2170 < _e2169) {
                                atomicStore((&output.member[(4u + (2u * _e2170))]), _e2179.member);
                                atomicStore((&output.member[((2u * _e2170) + 5u)]), _e2179.member_1);
                            }
                        }
                        phi_3021_ = true;
                    }
                    let _e2190 = phi_3021_;
                    phi_3022_ = _e2190;
                } else {
                    phi_3022_ = false;
                }
                let _e2192 = phi_3022_;
                continue;
                continuing {
                    phi_2899_ = _e2126;
                    break if !(_e2192);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_272_ = _e172;
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
