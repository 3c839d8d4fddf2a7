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

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_36 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 10>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(6) 
var<storage, read_write> output: type_40;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_36;
@group(0) @binding(5) 
var<storage> input: type_11;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_2793_: bool;
    var phi_2794_: bool;
    var phi_2798_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2794_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2793_ = (param_1[0] > param[0]);
        } else {
            phi_2793_ = false;
        }
        let _e14 = phi_2793_;
        phi_2794_ = _e14;
    }
    let _e16 = phi_2794_;
    if _e16 {
        phi_2798_ = param_1;
    } else {
        phi_2798_ = param;
    }
    let _e18 = phi_2798_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2769_: bool;
    var phi_2770_: bool;
    var phi_2774_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2770_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2769_ = (param_2[0] > param_3[0]);
        } else {
            phi_2769_ = false;
        }
        let _e14 = phi_2769_;
        phi_2770_ = _e14;
    }
    let _e16 = phi_2770_;
    if _e16 {
        phi_2774_ = param_3;
    } else {
        phi_2774_ = param_2;
    }
    let _e18 = phi_2774_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2750_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2746_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2745_ = (param_5[0] > param_4[0]);
        } else {
            phi_2745_ = false;
        }
        let _e14 = phi_2745_;
        phi_2746_ = _e14;
    }
    let _e16 = phi_2746_;
    if _e16 {
        phi_2750_ = param_5;
    } else {
        phi_2750_ = param_4;
    }
    let _e18 = phi_2750_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2721_: bool;
    var phi_2722_: bool;
    var phi_2726_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2722_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2721_ = (param_6[0] > param_7[0]);
        } else {
            phi_2721_ = false;
        }
        let _e14 = phi_2721_;
        phi_2722_ = _e14;
    }
    let _e16 = phi_2722_;
    if _e16 {
        phi_2726_ = param_7;
    } else {
        phi_2726_ = param_6;
    }
    let _e18 = phi_2726_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2702_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2698_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2697_ = (param_9[0] > param_8[0]);
        } else {
            phi_2697_ = false;
        }
        let _e14 = phi_2697_;
        phi_2698_ = _e14;
    }
    let _e16 = phi_2698_;
    if _e16 {
        phi_2702_ = param_9;
    } else {
        phi_2702_ = param_8;
    }
    let _e18 = phi_2702_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2673_: bool;
    var phi_2674_: bool;
    var phi_2678_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2674_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2673_ = (param_10[0] > param_11[0]);
        } else {
            phi_2673_ = false;
        }
        let _e14 = phi_2673_;
        phi_2674_ = _e14;
    }
    let _e16 = phi_2674_;
    if _e16 {
        phi_2678_ = param_11;
    } else {
        phi_2678_ = param_10;
    }
    let _e18 = phi_2678_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_192_: u32;
    var phi_241_: u32;
    var phi_242_: u32;
    var phi_250_: u32;
    var phi_266_: u32;
    var phi_289_: u32;
    var phi_290_: u32;
    var phi_293_: type_9;
    var phi_294_: type_9;
    var phi_319_: type_9;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_375_: u32;
    var phi_389_: u32;
    var phi_432_: array<u32, 2>;
    var phi_492_: array<u32, 2>;
    var phi_653_: bool;
    var phi_691_: type_29;
    var phi_697_: bool;
    var phi_720_: u32;
    var phi_723_: type_9;
    var phi_726_: u32;
    var phi_724_: type_9;
    var phi_749_: type_9;
    var phi_727_: u32;
    var local: u32;
    var phi_938_: u32;
    var phi_1044_: type_9;
    var phi_1047_: u32;
    var phi_1045_: type_9;
    var phi_1070_: type_9;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1100_: bool;
    var phi_1108_: bool;
    var phi_1116_: u32;
    var phi_1048_: u32;
    var phi_1117_: u32;
    var phi_1127_: type_9;
    var phi_1153_: u32;
    var phi_1156_: type_9;
    var phi_1159_: type_9;
    var phi_1157_: type_9;
    var phi_1184_: type_9;
    var phi_1201_: type_9;
    var phi_1204_: type_9;
    var phi_1205_: type_9;
    var phi_1227_: type_9;
    var phi_1261_: type_9;
    var phi_1262_: bool;
    var phi_1202_: type_9;
    var phi_1263_: bool;
    var phi_1271_: u32;
    var phi_1274_: type_9;
    var phi_1275_: type_9;
    var phi_1300_: type_9;
    var phi_1455_: bool;
    var phi_1461_: bool;
    var phi_1433_: bool;
    var phi_1440_: bool;
    var phi_1448_: bool;
    var phi_1463_: bool;
    var phi_1467_: bool;
    var phi_1468_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1517_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1667_: u32;
    var phi_1668_: u32;
    var phi_1669_: u32;
    var phi_1670_: u32;
    var phi_1673_: type_15;
    var phi_1676_: u32;
    var phi_1678_: u32;
    var phi_1699_: bool;
    var phi_1705_: type_16;
    var phi_1674_: type_15;
    var phi_1719_: type_16;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1800_: u32;
    var phi_1801_: u32;
    var phi_1802_: u32;
    var phi_1803_: u32;
    var phi_1804_: bool;
    var phi_1677_: u32;
    var phi_1679_: u32;
    var phi_1805_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1865_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1879_: bool;
    var phi_1880_: bool;
    var phi_1996_: bool;
    var phi_1997_: bool;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2450_: bool;
    var phi_2451_: bool;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var phi_2454_: bool;
    var phi_2458_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2511_: type_9;
    var phi_2512_: type_9;
    var phi_2535_: type_9;
    var phi_2559_: u32;
    var phi_2611_: type_9;
    var phi_2616_: type_9;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_1160_: type_9;
    var local_3: u32;
    var local_4: u32;
    var local_5: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e50 = id_2;
    let _e51 = n_2;
    let _e52 = lane_2;
    let _e64 = ((_e50.y * _e51.x) + _e50.x);
    let _e67 = (_e51.x * _e51.y);
    let _e69 = params.member.member;
    let _e72 = params.member.member_2.member_1;
    let _e75 = params.member.member_1.member_2;
    let _e77 = input.member[0u];
    if (_e75 < _e77) {
        phi_192_ = _e75;
    } else {
        phi_192_ = _e77;
    }
    let _e80 = phi_192_;
    if (_e52 == 0u) {
        atomicStore((&counters[9u]), 0u);
    }
    let _e85 = params.member.member_1.member_1;
    if (_e80 > _e85) {
        let _e89 = params.member.member_1.member_1;
        let _e90 = (_e80 - _e89);
        let _e93 = params.member.member_2.member_3;
        if (_e93 == 0u) {
            return;
        }
        let _e95 = (_e90 / _e93);
        if (_e93 == 0u) {
            return;
        }
        if ((_e90 % _e93) > 0u) {
            phi_241_ = (_e95 + 1u);
        } else {
            phi_241_ = _e95;
        }
        let _e101 = phi_241_;
        phi_242_ = _e101;
    } else {
        phi_242_ = 0u;
    }
    let _e103 = phi_242_;
    let _e106 = params.member.member_2.member_4;
    if (_e106 < _e103) {
        phi_250_ = _e106;
    } else {
        phi_250_ = _e103;
    }
    let _e109 = phi_250_;
    let _e110 = (_e109 / 4u);
    if ((_e109 % 4u) > 0u) {
        phi_266_ = (_e110 + 1u);
    } else {
        phi_266_ = _e110;
    }
    let _e115 = phi_266_;
    if (_e115 > _e64) {
        let _e117 = (_e115 - _e64);
        if (_e67 == 0u) {
            return;
        }
        let _e119 = (_e117 / _e67);
        if (_e67 == 0u) {
            return;
        }
        if ((_e117 % _e67) > 0u) {
            phi_289_ = (_e119 + 1u);
        } else {
            phi_289_ = _e119;
        }
        let _e125 = phi_289_;
        phi_290_ = _e125;
    } else {
        phi_290_ = 0u;
    }
    let _e127 = phi_290_;
    phi_293_ = type_9(0u, _e127);
    loop {
        let _e130 = phi_293_;
        if (_e130.member < _e130.member_1) {
            phi_294_ = type_9((_e130.member + 1u), _e130.member_1);
            phi_319_ = type_9(1u, _e130.member);
        } else {
            phi_294_ = _e130;
            phi_319_ = type_9(0u, type_9().member_1);
        }
        let _e142 = phi_294_;
        let _e144 = phi_319_;
        let _e148 = (bitcast<i32>(_e144.member) != 0i);
        if _e148 {
            let _e153 = (((_e64 + (_e144.member_1 * _e67)) * 4u) + (_e52 / 32u));
            let _e156 = params.member.member_1.member_1;
            if (_e80 > _e156) {
                let _e160 = params.member.member_1.member_1;
                let _e161 = (_e80 - _e160);
                let _e164 = params.member.member_2.member_3;
                if (_e164 == 0u) {
                    return;
                }
                let _e166 = (_e161 / _e164);
                if (_e164 == 0u) {
                    return;
                }
                if ((_e161 % _e164) > 0u) {
                    phi_366_ = (_e166 + 1u);
                } else {
                    phi_366_ = _e166;
                }
                let _e172 = phi_366_;
                phi_367_ = _e172;
            } else {
                phi_367_ = 0u;
            }
            let _e174 = phi_367_;
            let _e177 = params.member.member_2.member_4;
            if (_e177 < _e174) {
                phi_375_ = _e177;
            } else {
                phi_375_ = _e174;
            }
            let _e180 = phi_375_;
            let _e181 = (_e153 < _e180);
            let _e184 = params.member.member_1.member_1;
            let _e187 = params.member.member_2.member_3;
            if _e181 {
                phi_389_ = (_e153 * _e187);
            } else {
                phi_389_ = 0u;
            }
            let _e190 = phi_389_;
            let _e192 = (2u * (_e184 + _e190));
            let _e195 = input.member[(4u + _e192)];
            let _e198 = input.member[(_e192 + 5u)];
            if (_e52 <= 7u) {
                atomicStore((&counters[_e52]), 0u);
            }
            workgroupBarrier();
            if (_e72 == 0u) {
                phi_432_ = array<u32, 2>(0u, 2u);
            } else {
                phi_432_ = array<u32, 2>(1u, 1u);
            }
            let _e203 = phi_432_;
            if ((_e52 % 32u) == 0u) {
                let _e209 = (_e52 / 32u);
                let _e215 = params.member.member_2.member[0u][_e203[0]];
                firsts[(2u * _e209)] = (_e215 + (_e195 * 32u));
                let _e224 = params.member.member_2.member[0u][_e203[1]];
                firsts[((2u * _e209) + 1u)] = (_e224 + (_e198 * 32u));
            }
            let _e229 = params.member.member_2.member_1;
            if (_e229 == 0u) {
                phi_492_ = array<u32, 2>(0u, 2u);
            } else {
                phi_492_ = array<u32, 2>(1u, 1u);
            }
            let _e232 = phi_492_;
            let _e235 = (_e52 / 32u);
            let _e236 = (_e52 % 32u);
            let _e238 = params.member.member_2.member_2;
            let _e242 = params.member.member_2.member[_e238][_e232[0]];
            let _e245 = nodes.member[(_e242 + _e195)];
            let _e259 = params.member.member_2.member_2;
            let _e263 = params.member.member_2.member[_e259][_e232[1]];
            let _e266 = nodes.member[(_e263 + _e198)];
            let _e280 = params.member.member_2.member_2;
            let _e287 = params.member.member_2.member[(_e280 - 1u)][_e232[0]];
            let _e290 = nodes.member[(_e287 + ((_e195 * 32u) + _e236))];
            let _e307 = params.member.member_2.member_2;
            let _e314 = params.member.member_2.member[(_e307 - 1u)][_e232[1]];
            let _e317 = nodes.member[(_e314 + ((_e198 * 32u) + _e236))];
            if _e181 {
                phi_653_ = ((((((_e290.member.x <= _e266.member_1.y) && (_e266.member.x <= _e290.member_1.y)) && (_e290.member.y <= _e266.member_2.x)) && (_e266.member.y <= _e290.member_2.x)) && (_e290.member_1.x <= _e266.member_2.y)) && (_e266.member_1.x <= _e290.member_2.y));
            } else {
                phi_653_ = false;
            }
            let _e342 = phi_653_;
            if _e181 {
                if ((((((_e317.member.x <= _e245.member_1.y) && (_e245.member.x <= _e317.member_1.y)) && (_e317.member.y <= _e245.member_2.x)) && (_e245.member.y <= _e317.member_2.x)) && (_e317.member_1.x <= _e245.member_2.y)) && (_e245.member_1.x <= _e317.member_2.y)) {
                    let _e356 = atomicAdd((&counters[_e235]), 1u);
                    let _e357 = ((_e235 * 32u) + _e356);
                    columns[_e357] = type_29(array<f32, 3>(_e317.member.x, _e317.member.y, _e317.member_1.x), array<f32, 3>(_e317.member_1.y, _e317.member_2.x, _e317.member_2.y));
                    names[_e357] = _e236;
                }
            }
            if _e342 {
                phi_691_ = type_29(array<f32, 3>(_e290.member.x, _e290.member.y, _e290.member_1.x), array<f32, 3>(_e290.member_1.y, _e290.member_2.x, _e290.member_2.y));
            } else {
                phi_691_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e364 = phi_691_;
            workgroupBarrier();
            if (_e72 == 1u) {
                phi_697_ = (_e195 == _e198);
            } else {
                phi_697_ = false;
            }
            let _e368 = phi_697_;
            let _e369 = (_e52 / 32u);
            let _e371 = (_e369 * 32u);
            let _e373 = atomicLoad((&counters[_e369]));
            let _e374 = (_e373 / 4u);
            if ((_e373 % 4u) > 0u) {
                phi_720_ = (_e374 + 1u);
            } else {
                phi_720_ = _e374;
            }
            let _e379 = phi_720_;
            phi_723_ = type_9(0u, _e379);
            phi_726_ = 0u;
            loop {
                let _e382 = phi_723_;
                let _e384 = phi_726_;
                local = _e384;
                local_3 = _e384;
                if (_e382.member < _e382.member_1) {
                    phi_724_ = type_9((_e382.member + 1u), _e382.member_1);
                    phi_749_ = type_9(1u, _e382.member);
                } else {
                    phi_724_ = _e382;
                    phi_749_ = type_9(0u, type_9().member_1);
                }
                let _e396 = phi_724_;
                let _e398 = phi_749_;
                let _e402 = (bitcast<i32>(_e398.member) != 0i);
                if _e402 {
                    let _e403 = (4u * _e398.member_1);
                    let _e406 = columns[(_e371 + _e403)];
                    let _e445 = columns[((_e371 + _e403) + 1u)];
                    let _e486 = columns[((_e371 + _e403) + 2u)];
                    let _e527 = columns[((_e371 + _e403) + 3u)];
                    phi_727_ = (_e384 | ((((select(0u, 1u, ((((((_e364.member[0] <= _e406.member_1[0]) && (_e406.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e406.member_1[1])) && (_e406.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e406.member_1[2])) && (_e406.member[2] <= _e364.member_1[2]))) << bitcast<u32>((_e403 & 31u))) | (select(0u, 1u, ((((((_e364.member[0] <= _e445.member_1[0]) && (_e445.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e445.member_1[1])) && (_e445.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e445.member_1[2])) && (_e445.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e364.member[0] <= _e486.member_1[0]) && (_e486.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e486.member_1[1])) && (_e486.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e486.member_1[2])) && (_e486.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e364.member[0] <= _e527.member_1[0]) && (_e527.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e527.member_1[1])) && (_e527.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e527.member_1[2])) && (_e527.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 3u) & 31u)))));
                } else {
                    phi_727_ = u32();
                }
                let _e567 = phi_727_;
                continue;
                continuing {
                    phi_723_ = _e396;
                    phi_726_ = _e567;
                    break if !(_e402);
                }
            }
            if (_e373 < 32u) {
                let _e575 = local;
                phi_938_ = (_e575 & ((1u << bitcast<u32>((_e373 & 31u))) - 1u));
            } else {
                let _e1501 = local_3;
                phi_938_ = _e1501;
            }
            let _e578 = phi_938_;
            if _e368 {
                phi_1044_ = type_9(0u, _e373);
                phi_1047_ = _e578;
                loop {
                    let _e581 = phi_1044_;
                    let _e583 = phi_1047_;
                    local_4 = _e583;
                    if (_e581.member < _e581.member_1) {
                        phi_1045_ = type_9((_e581.member + 1u), _e581.member_1);
                        phi_1070_ = type_9(1u, _e581.member);
                    } else {
                        phi_1045_ = _e581;
                        phi_1070_ = type_9(0u, type_9().member_1);
                    }
                    let _e595 = phi_1045_;
                    let _e597 = phi_1070_;
                    let _e601 = (bitcast<i32>(_e597.member) != 0i);
                    if _e601 {
                        let _e604 = names[(_e371 + _e597.member_1)];
                        if _e368 {
                            let _e605 = ((_e52 % 32u) < _e604);
                            if _e605 {
                                phi_1094_ = bool();
                            } else {
                                phi_1094_ = false;
                            }
                            let _e607 = phi_1094_;
                            phi_1095_ = _e607;
                            phi_1096_ = _e605;
                        } else {
                            phi_1095_ = bool();
                            phi_1096_ = true;
                        }
                        let _e609 = phi_1095_;
                        let _e611 = phi_1096_;
                        if _e611 {
                            phi_1100_ = true;
                        } else {
                            phi_1100_ = _e609;
                        }
                        let _e613 = phi_1100_;
                        if _e613 {
                            phi_1108_ = false;
                        } else {
                            phi_1108_ = true;
                        }
                        let _e615 = phi_1108_;
                        if _e615 {
                            phi_1116_ = (_e583 & ~((1u << bitcast<u32>((_e597.member_1 & 31u)))));
                        } else {
                            phi_1116_ = _e583;
                        }
                        let _e622 = phi_1116_;
                        phi_1048_ = _e622;
                    } else {
                        phi_1048_ = u32();
                    }
                    let _e624 = phi_1048_;
                    continue;
                    continuing {
                        phi_1044_ = _e595;
                        phi_1047_ = _e624;
                        break if !(_e601);
                    }
                }
                let _e1515 = local_4;
                phi_1117_ = _e1515;
            } else {
                phi_1117_ = _e578;
            }
            let _e627 = phi_1117_;
            let _e629 = countOneBits(_e627);
            if (_e629 > 0u) {
                let _e632 = atomicAdd((&counters[4u]), _e629);
                phi_1127_ = type_9(_e627, _e632);
            } else {
                phi_1127_ = type_9(_e627, 0u);
            }
            let _e635 = phi_1127_;
            workgroupBarrier();
            if (_e52 == 0u) {
                let _e638 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e638;
            }
            let _e641 = workgroupUniformLoad((&n_hits[0u]));
            let _e642 = (_e641 / 512u);
            if ((_e641 % 512u) > 0u) {
                phi_1153_ = (_e642 + 1u);
            } else {
                phi_1153_ = _e642;
            }
            let _e647 = phi_1153_;
            phi_1156_ = type_9(0u, _e647);
            phi_1159_ = _e635;
            loop {
                let _e650 = phi_1156_;
                let _e652 = phi_1159_;
                if (_e650.member < _e650.member_1) {
                    phi_1157_ = type_9((_e650.member + 1u), _e650.member_1);
                    phi_1184_ = type_9(1u, _e650.member);
                } else {
                    phi_1157_ = _e650;
                    phi_1184_ = type_9(0u, type_9().member_1);
                }
                let _e664 = phi_1157_;
                let _e666 = phi_1184_;
                let _e670 = (bitcast<i32>(_e666.member) != 0i);
                if _e670 {
                    let _e671 = (_e52 / 32u);
                    let _e673 = (_e666.member_1 * 512u);
                    phi_1201_ = _e652;
                    phi_1204_ = type_9(0u, countOneBits(_e652.member));
                    loop {
                        let _e678 = phi_1201_;
                        let _e680 = phi_1204_;
                        local_5 = _e678;
                        if (_e680.member < _e680.member_1) {
                            phi_1205_ = type_9((_e680.member + 1u), _e680.member_1);
                            phi_1227_ = type_9(1u, _e680.member);
                        } else {
                            phi_1205_ = _e680;
                            phi_1227_ = type_9(0u, type_9().member_1);
                        }
                        let _e692 = phi_1205_;
                        let _e694 = phi_1227_;
                        if (bitcast<i32>(_e694.member) != 0i) {
                            let _e699 = (_e678.member_1 - _e673);
                            if (_e699 >= 512u) {
                                phi_1261_ = type_9();
                                phi_1262_ = false;
                            } else {
                                let _e708 = names[((_e671 * 32u) + select(firstTrailingBit(_e678.member), 32u, (_e678.member == 0u)))];
                                hits[_e699] = (((_e671 << bitcast<u32>(10i)) | ((_e52 % 32u) << bitcast<u32>(5i))) | _e708);
                                phi_1261_ = type_9((_e678.member & (_e678.member - 1u)), (_e678.member_1 + 1u));
                                phi_1262_ = true;
                            }
                            let _e724 = phi_1261_;
                            let _e726 = phi_1262_;
                            phi_1202_ = _e724;
                            phi_1263_ = _e726;
                        } else {
                            phi_1202_ = type_9();
                            phi_1263_ = false;
                        }
                        let _e728 = phi_1202_;
                        let _e730 = phi_1263_;
                        continue;
                        continuing {
                            phi_1201_ = _e728;
                            phi_1204_ = _e692;
                            break if !(_e730);
                        }
                    }
                    workgroupBarrier();
                    let _e733 = n_hits[0u];
                    let _e734 = (_e733 - _e673);
                    if (512u < _e734) {
                        phi_1271_ = 512u;
                    } else {
                        phi_1271_ = _e734;
                    }
                    let _e737 = phi_1271_;
                    phi_1274_ = type_9(0u, 4u);
                    loop {
                        let _e739 = phi_1274_;
                        if (_e739.member < _e739.member_1) {
                            phi_1275_ = type_9((_e739.member + 1u), _e739.member_1);
                            phi_1300_ = type_9(1u, _e739.member);
                        } else {
                            phi_1275_ = _e739;
                            phi_1300_ = type_9(0u, type_9().member_1);
                        }
                        let _e751 = phi_1275_;
                        let _e753 = phi_1300_;
                        if (bitcast<i32>(_e753.member) != 0i) {
                            let _e759 = (_e52 + (_e753.member_1 * 128u));
                            if (_e759 >= _e737) {
                                phi_2474_ = false;
                            } else {
                                let _e762 = hits[_e759];
                                let _e765 = ((_e762 >> bitcast<u32>(10i)) & 3u);
                                let _e772 = firsts[(2u * _e765)];
                                let _e777 = firsts[((2u * _e765) + 1u)];
                                let _e780 = leaves.member[(_e772 + ((_e762 >> bitcast<u32>(5i)) & 31u))];
                                let _e786 = leaves.member[(_e777 + (_e762 & 31u))];
                                let _e793 = ((_e762 >> bitcast<u32>(10i)) & 3u);
                                let _e800 = firsts[(2u * _e793)];
                                let _e805 = firsts[((2u * _e793) + 1u)];
                                let _e808 = nodes.member[(_e800 + ((_e762 >> bitcast<u32>(5i)) & 31u))];
                                let _e822 = nodes.member[(_e805 + (_e762 & 31u))];
                                if ((_e69.member_1 & 1u) != 0u) {
                                    if (_e72 == 0u) {
                                        if (_e786.x == _e780.x) {
                                            phi_1433_ = true;
                                        } else {
                                            phi_1433_ = (_e786.x == _e780.x);
                                        }
                                        let _e851 = phi_1433_;
                                        if (_e786.y == _e780.x) {
                                            phi_1440_ = true;
                                        } else {
                                            phi_1440_ = (_e786.y == _e780.x);
                                        }
                                        let _e855 = phi_1440_;
                                        if (_e786.z == _e780.x) {
                                            phi_1448_ = true;
                                        } else {
                                            phi_1448_ = (_e786.z == _e780.x);
                                        }
                                        let _e860 = phi_1448_;
                                        phi_1463_ = ((_e851 || _e855) || _e860);
                                    } else {
                                        if (_e786.x == _e780.x) {
                                            phi_1455_ = true;
                                        } else {
                                            phi_1455_ = (_e786.x == _e780.y);
                                        }
                                        let _e842 = phi_1455_;
                                        if (_e786.y == _e780.x) {
                                            phi_1461_ = true;
                                        } else {
                                            phi_1461_ = (_e786.y == _e780.y);
                                        }
                                        let _e846 = phi_1461_;
                                        phi_1463_ = (_e842 || _e846);
                                    }
                                    let _e863 = phi_1463_;
                                    if _e863 {
                                        phi_1467_ = false;
                                    } else {
                                        phi_1467_ = true;
                                    }
                                    let _e865 = phi_1467_;
                                    phi_1468_ = _e865;
                                } else {
                                    phi_1468_ = true;
                                }
                                let _e867 = phi_1468_;
                                if _e867 {
                                    if ((_e69.member_1 & 2u) != 0u) {
                                        let _e872 = bodies.member[_e780.x];
                                        let _e874 = bodies.member[_e786.x];
                                        if ((_e872 / 4u) != (_e874 / 4u)) {
                                            phi_1510_ = true;
                                        } else {
                                            if ((_e872 & 2u) == 0u) {
                                                phi_1509_ = false;
                                            } else {
                                                phi_1509_ = true;
                                            }
                                            let _e881 = phi_1509_;
                                            phi_1510_ = _e881;
                                        }
                                        let _e883 = phi_1510_;
                                        if _e883 {
                                            phi_1517_ = (((_e872 & _e874) & 1u) == 0u);
                                        } else {
                                            phi_1517_ = false;
                                        }
                                        let _e888 = phi_1517_;
                                        if _e888 {
                                            if ((_e69.member_1 & 4u) != 0u) {
                                                let _e895 = bodies.member[_e69.member[0]];
                                                let _e898 = bodies.member[(_e69.member[0] + 1u)];
                                                let _e903 = ((_e69.member[0] + 4u) + (2u * (_e872 >> bitcast<u32>(2i))));
                                                let _e908 = ((_e69.member[0] + 4u) + (2u * (_e874 >> bitcast<u32>(2i))));
                                                let _e910 = bodies.member[_e903];
                                                let _e912 = bodies.member[_e908];
                                                let _e921 = bodies.member[((((_e69.member[0] + 4u) + (2u * _e895)) + (_e910 * _e898)) + (_e912 / 32u))];
                                                let _e924 = bodies.member[(_e903 + 1u)];
                                                let _e927 = bodies.member[(_e908 + 1u)];
                                                if (_e924 == _e927) {
                                                    if (((_e921 >> bitcast<u32>(((_e912 % 32u) & 31u))) & 1u) == 1u) {
                                                        phi_1631_ = true;
                                                    } else {
                                                        phi_1631_ = ((_e872 >> bitcast<u32>(2i)) == (_e874 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e941 = phi_1631_;
                                                    phi_1632_ = _e941;
                                                } else {
                                                    phi_1632_ = false;
                                                }
                                                let _e943 = phi_1632_;
                                                if _e943 {
                                                    let _e946 = bodies.member[(_e69.member[0] + 2u)];
                                                    let _e949 = bodies.member[(_e69.member[0] + 3u)];
                                                    let _e950 = (_e949 + _e69.member[0]);
                                                    if (_e72 == 1u) {
                                                        if (_e786.w < _e780.w) {
                                                            phi_1667_ = _e780.w;
                                                            phi_1668_ = _e786.w;
                                                        } else {
                                                            phi_1667_ = _e786.w;
                                                            phi_1668_ = _e780.w;
                                                        }
                                                        let _e954 = phi_1667_;
                                                        let _e956 = phi_1668_;
                                                        phi_1669_ = _e954;
                                                        phi_1670_ = _e956;
                                                    } else {
                                                        phi_1669_ = _e786.w;
                                                        phi_1670_ = _e780.w;
                                                    }
                                                    let _e958 = phi_1669_;
                                                    let _e960 = phi_1670_;
                                                    phi_1673_ = type_15(0i, 32i);
                                                    phi_1676_ = _e946;
                                                    phi_1678_ = 0u;
                                                    loop {
                                                        let _e962 = phi_1673_;
                                                        let _e964 = phi_1676_;
                                                        let _e966 = phi_1678_;
                                                        local_1 = _e966;
                                                        local_2 = _e966;
                                                        if (_e962.member < _e962.member_1) {
                                                            let _e973 = (_e962.member + 1i);
                                                            if ((false == (_e973 > _e962.member)) != false) {
                                                                phi_1699_ = true;
                                                            } else {
                                                                phi_1699_ = false;
                                                            }
                                                            let _e978 = phi_1699_;
                                                            if _e978 {
                                                                phi_1705_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1705_ = type_16(1u, _e973);
                                                            }
                                                            let _e983 = phi_1705_;
                                                            phi_1674_ = type_15(_e983.member_1, _e962.member_1);
                                                            phi_1719_ = type_16(1u, _e962.member);
                                                        } else {
                                                            phi_1674_ = _e962;
                                                            phi_1719_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e989 = phi_1674_;
                                                        let _e991 = phi_1719_;
                                                        if (bitcast<i32>(_e991.member) != 0i) {
                                                            if (_e966 >= _e964) {
                                                                phi_1802_ = u32();
                                                                phi_1803_ = u32();
                                                                phi_1804_ = false;
                                                            } else {
                                                                let _e998 = (_e966 + ((_e964 - _e966) / 2u));
                                                                let _e1000 = (_e950 + (3u * _e998));
                                                                let _e1002 = bodies.member[_e1000];
                                                                let _e1005 = bodies.member[(_e1000 + 1u)];
                                                                let _e1008 = bodies.member[(_e1000 + 2u)];
                                                                if (_e1002 < _e72) {
                                                                    phi_1795_ = true;
                                                                } else {
                                                                    if (_e1002 == _e72) {
                                                                        if (_e1005 < _e960) {
                                                                            phi_1789_ = false;
                                                                        } else {
                                                                            if (_e1005 == _e960) {
                                                                                if (_e1008 < _e958) {
                                                                                    phi_1787_ = false;
                                                                                } else {
                                                                                    phi_1787_ = true;
                                                                                }
                                                                                let _e1015 = phi_1787_;
                                                                                phi_1788_ = _e1015;
                                                                            } else {
                                                                                phi_1788_ = true;
                                                                            }
                                                                            let _e1017 = phi_1788_;
                                                                            phi_1789_ = _e1017;
                                                                        }
                                                                        let _e1019 = phi_1789_;
                                                                        phi_1790_ = _e1019;
                                                                    } else {
                                                                        phi_1790_ = true;
                                                                    }
                                                                    let _e1021 = phi_1790_;
                                                                    if _e1021 {
                                                                        phi_1794_ = false;
                                                                    } else {
                                                                        phi_1794_ = true;
                                                                    }
                                                                    let _e1023 = phi_1794_;
                                                                    phi_1795_ = _e1023;
                                                                }
                                                                let _e1025 = phi_1795_;
                                                                if _e1025 {
                                                                    phi_1800_ = _e964;
                                                                    phi_1801_ = (_e998 + 1u);
                                                                } else {
                                                                    phi_1800_ = _e998;
                                                                    phi_1801_ = _e966;
                                                                }
                                                                let _e1028 = phi_1800_;
                                                                let _e1030 = phi_1801_;
                                                                phi_1802_ = _e1028;
                                                                phi_1803_ = _e1030;
                                                                phi_1804_ = true;
                                                            }
                                                            let _e1032 = phi_1802_;
                                                            let _e1034 = phi_1803_;
                                                            let _e1036 = phi_1804_;
                                                            phi_1677_ = _e1032;
                                                            phi_1679_ = _e1034;
                                                            phi_1805_ = _e1036;
                                                        } else {
                                                            phi_1677_ = u32();
                                                            phi_1679_ = u32();
                                                            phi_1805_ = false;
                                                        }
                                                        let _e1038 = phi_1677_;
                                                        let _e1040 = phi_1679_;
                                                        let _e1042 = phi_1805_;
                                                        continue;
                                                        continuing {
                                                            phi_1673_ = _e989;
                                                            phi_1676_ = _e1038;
                                                            phi_1678_ = _e1040;
                                                            break if !(_e1042);
                                                        }
                                                    }
                                                    let _e1045 = local_1;
                                                    if (_e1045 < _e946) {
                                                        let _e1048 = local_2;
                                                        let _e1050 = (_e950 + (3u * _e1048));
                                                        let _e1052 = bodies.member[_e1050];
                                                        if (_e1052 == _e72) {
                                                            let _e1056 = bodies.member[(_e1050 + 1u)];
                                                            if (_e1056 == _e960) {
                                                                let _e1060 = bodies.member[(_e1050 + 2u)];
                                                                phi_1853_ = (_e1060 == _e958);
                                                                phi_1854_ = false;
                                                            } else {
                                                                phi_1853_ = bool();
                                                                phi_1854_ = true;
                                                            }
                                                            let _e1063 = phi_1853_;
                                                            let _e1065 = phi_1854_;
                                                            phi_1855_ = _e1063;
                                                            phi_1856_ = _e1065;
                                                        } else {
                                                            phi_1855_ = bool();
                                                            phi_1856_ = true;
                                                        }
                                                        let _e1067 = phi_1855_;
                                                        let _e1069 = phi_1856_;
                                                        if _e1069 {
                                                            phi_1860_ = false;
                                                        } else {
                                                            phi_1860_ = _e1067;
                                                        }
                                                        let _e1071 = phi_1860_;
                                                        phi_1861_ = _e1071;
                                                    } else {
                                                        phi_1861_ = false;
                                                    }
                                                    let _e1073 = phi_1861_;
                                                    phi_1865_ = _e1073;
                                                } else {
                                                    phi_1865_ = true;
                                                }
                                                let _e1075 = phi_1865_;
                                                if _e1075 {
                                                    phi_1869_ = false;
                                                } else {
                                                    phi_1869_ = true;
                                                }
                                                let _e1077 = phi_1869_;
                                                phi_1870_ = _e1077;
                                            } else {
                                                phi_1870_ = true;
                                            }
                                            let _e1079 = phi_1870_;
                                            if _e1079 {
                                                phi_1874_ = false;
                                            } else {
                                                phi_1874_ = true;
                                            }
                                            let _e1081 = phi_1874_;
                                            phi_1875_ = _e1081;
                                        } else {
                                            phi_1875_ = true;
                                        }
                                        let _e1083 = phi_1875_;
                                        if _e1083 {
                                            phi_1879_ = false;
                                        } else {
                                            phi_1879_ = true;
                                        }
                                        let _e1085 = phi_1879_;
                                        phi_1880_ = _e1085;
                                    } else {
                                        phi_1880_ = true;
                                    }
                                    let _e1087 = phi_1880_;
                                    if _e1087 {
                                        if ((_e69.member_1 & 32u) != 0u) {
                                            let _e1108 = (((((_e808.member_1.y - _e822.member.x) > _e69.member_6) && ((_e822.member_1.y - _e808.member.x) > _e69.member_6)) && (((_e808.member_2.x - _e822.member.y) > _e69.member_6) && ((_e822.member_2.x - _e808.member.y) > _e69.member_6))) && (((_e808.member_2.y - _e822.member_1.x) > _e69.member_6) && ((_e822.member_2.y - _e808.member_1.x) > _e69.member_6)));
                                            if _e1108 {
                                                phi_2444_ = bool();
                                            } else {
                                                let _e1110 = keys.member[_e780.x];
                                                let _e1113 = keys.member[_e780.y];
                                                let _e1115 = function_5(_e1110[0], _e1113[0]);
                                                let _e1117 = keys.member[_e780.z];
                                                let _e1119 = function_5(_e1115, _e1117[0]);
                                                let _e1121 = keys.member[_e786.x];
                                                let _e1124 = keys.member[_e786.y];
                                                let _e1126 = function_4(_e1121[3], _e1124[3]);
                                                let _e1128 = keys.member[_e786.z];
                                                let _e1130 = function_4(_e1126, _e1128[3]);
                                                if (_e1119[1] > _e1130[1]) {
                                                    phi_1997_ = true;
                                                } else {
                                                    if (_e1119[1] == _e1130[1]) {
                                                        phi_1996_ = (_e1119[0] > _e1130[0]);
                                                    } else {
                                                        phi_1996_ = false;
                                                    }
                                                    let _e1141 = phi_1996_;
                                                    phi_1997_ = _e1141;
                                                }
                                                let _e1143 = phi_1997_;
                                                let _e1146 = keys.member[_e786.x];
                                                let _e1149 = keys.member[_e786.y];
                                                let _e1151 = function_5(_e1146[0], _e1149[0]);
                                                let _e1153 = keys.member[_e786.z];
                                                let _e1155 = function_5(_e1151, _e1153[0]);
                                                let _e1157 = keys.member[_e780.x];
                                                let _e1160 = keys.member[_e780.y];
                                                let _e1162 = function_4(_e1157[3], _e1160[3]);
                                                let _e1164 = keys.member[_e780.z];
                                                let _e1166 = function_4(_e1162, _e1164[3]);
                                                if (_e1155[1] > _e1166[1]) {
                                                    phi_2085_ = true;
                                                } else {
                                                    if (_e1155[1] == _e1166[1]) {
                                                        phi_2084_ = (_e1155[0] > _e1166[0]);
                                                    } else {
                                                        phi_2084_ = false;
                                                    }
                                                    let _e1177 = phi_2084_;
                                                    phi_2085_ = _e1177;
                                                }
                                                let _e1179 = phi_2085_;
                                                let _e1183 = keys.member[_e780.x];
                                                let _e1186 = keys.member[_e780.y];
                                                let _e1188 = function_3(_e1183[1], _e1186[1]);
                                                let _e1190 = keys.member[_e780.z];
                                                let _e1192 = function_3(_e1188, _e1190[1]);
                                                let _e1194 = keys.member[_e786.x];
                                                let _e1197 = keys.member[_e786.y];
                                                let _e1199 = function_2(_e1194[4], _e1197[4]);
                                                let _e1201 = keys.member[_e786.z];
                                                let _e1203 = function_2(_e1199, _e1201[4]);
                                                if (_e1192[1] > _e1203[1]) {
                                                    phi_2174_ = true;
                                                } else {
                                                    if (_e1192[1] == _e1203[1]) {
                                                        phi_2173_ = (_e1192[0] > _e1203[0]);
                                                    } else {
                                                        phi_2173_ = false;
                                                    }
                                                    let _e1214 = phi_2173_;
                                                    phi_2174_ = _e1214;
                                                }
                                                let _e1216 = phi_2174_;
                                                let _e1219 = keys.member[_e786.x];
                                                let _e1222 = keys.member[_e786.y];
                                                let _e1224 = function_3(_e1219[1], _e1222[1]);
                                                let _e1226 = keys.member[_e786.z];
                                                let _e1228 = function_3(_e1224, _e1226[1]);
                                                let _e1230 = keys.member[_e780.x];
                                                let _e1233 = keys.member[_e780.y];
                                                let _e1235 = function_2(_e1230[4], _e1233[4]);
                                                let _e1237 = keys.member[_e780.z];
                                                let _e1239 = function_2(_e1235, _e1237[4]);
                                                if (_e1228[1] > _e1239[1]) {
                                                    phi_2262_ = true;
                                                } else {
                                                    if (_e1228[1] == _e1239[1]) {
                                                        phi_2261_ = (_e1228[0] > _e1239[0]);
                                                    } else {
                                                        phi_2261_ = false;
                                                    }
                                                    let _e1250 = phi_2261_;
                                                    phi_2262_ = _e1250;
                                                }
                                                let _e1252 = phi_2262_;
                                                let _e1257 = keys.member[_e780.x];
                                                let _e1260 = keys.member[_e780.y];
                                                let _e1262 = function_1(_e1257[2], _e1260[2]);
                                                let _e1264 = keys.member[_e780.z];
                                                let _e1266 = function_1(_e1262, _e1264[2]);
                                                let _e1268 = keys.member[_e786.x];
                                                let _e1271 = keys.member[_e786.y];
                                                let _e1273 = function_(_e1268[5], _e1271[5]);
                                                let _e1275 = keys.member[_e786.z];
                                                let _e1277 = function_(_e1273, _e1275[5]);
                                                if (_e1266[1] > _e1277[1]) {
                                                    phi_2352_ = true;
                                                } else {
                                                    if (_e1266[1] == _e1277[1]) {
                                                        phi_2351_ = (_e1266[0] > _e1277[0]);
                                                    } else {
                                                        phi_2351_ = false;
                                                    }
                                                    let _e1288 = phi_2351_;
                                                    phi_2352_ = _e1288;
                                                }
                                                let _e1290 = phi_2352_;
                                                let _e1293 = keys.member[_e786.x];
                                                let _e1296 = keys.member[_e786.y];
                                                let _e1298 = function_1(_e1293[2], _e1296[2]);
                                                let _e1300 = keys.member[_e786.z];
                                                let _e1302 = function_1(_e1298, _e1300[2]);
                                                let _e1304 = keys.member[_e780.x];
                                                let _e1307 = keys.member[_e780.y];
                                                let _e1309 = function_(_e1304[5], _e1307[5]);
                                                let _e1311 = keys.member[_e780.z];
                                                let _e1313 = function_(_e1309, _e1311[5]);
                                                if (_e1302[1] > _e1313[1]) {
                                                    phi_2440_ = true;
                                                } else {
                                                    if (_e1302[1] == _e1313[1]) {
                                                        phi_2439_ = (_e1302[0] > _e1313[0]);
                                                    } else {
                                                        phi_2439_ = false;
                                                    }
                                                    let _e1324 = phi_2439_;
                                                    phi_2440_ = _e1324;
                                                }
                                                let _e1326 = phi_2440_;
                                                phi_2444_ = (((!(_e1143) && !(_e1179)) && (!(_e1216) && !(_e1252))) && (!(_e1290) && !(_e1326)));
                                            }
                                            let _e1331 = phi_2444_;
                                            phi_2445_ = _e1331;
                                            phi_2446_ = _e1108;
                                        } else {
                                            phi_2445_ = bool();
                                            phi_2446_ = true;
                                        }
                                        let _e1333 = phi_2445_;
                                        let _e1335 = phi_2446_;
                                        if _e1335 {
                                            phi_2450_ = false;
                                        } else {
                                            phi_2450_ = true;
                                        }
                                        let _e1337 = phi_2450_;
                                        phi_2451_ = _e1333;
                                        phi_2452_ = _e1337;
                                    } else {
                                        phi_2451_ = false;
                                        phi_2452_ = true;
                                    }
                                    let _e1339 = phi_2451_;
                                    let _e1341 = phi_2452_;
                                    phi_2453_ = _e1339;
                                    phi_2454_ = _e1341;
                                } else {
                                    phi_2453_ = false;
                                    phi_2454_ = true;
                                }
                                let _e1343 = phi_2453_;
                                let _e1345 = phi_2454_;
                                if _e1345 {
                                    phi_2458_ = _e1343;
                                } else {
                                    phi_2458_ = true;
                                }
                                let _e1347 = phi_2458_;
                                if _e1347 {
                                    let _e1349 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1347 {
                                    let _e1351 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e759] = ((2147483648u | (_e1351 << bitcast<u32>(12i))) | _e762);
                                }
                                phi_2474_ = true;
                            }
                            let _e1358 = phi_2474_;
                            phi_2475_ = _e1358;
                        } else {
                            phi_2475_ = false;
                        }
                        let _e1360 = phi_2475_;
                        continue;
                        continuing {
                            phi_1274_ = _e751;
                            break if !(_e1360);
                        }
                    }
                    let _e1364 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e52 == 0u) {
                        let _e1367 = atomicLoad((&counters[7u]));
                        if (_e1367 > 0u) {
                            let _e1370 = atomicAdd((&output.member[0u]), _e1367);
                            if ((_e1370 + _e1367) < _e1370) {
                                let _e1374 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e1370);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1380 = atomicLoad((&counters[8u]));
                    phi_2511_ = type_9(0u, 4u);
                    loop {
                        let _e1382 = phi_2511_;
                        if (_e1382.member < _e1382.member_1) {
                            phi_2512_ = type_9((_e1382.member + 1u), _e1382.member_1);
                            phi_2535_ = type_9(1u, _e1382.member);
                        } else {
                            phi_2512_ = _e1382;
                            phi_2535_ = type_9(0u, type_9().member_1);
                        }
                        let _e1394 = phi_2512_;
                        let _e1396 = phi_2535_;
                        if (bitcast<i32>(_e1396.member) != 0i) {
                            let _e1402 = (_e52 + (_e1396.member_1 * 128u));
                            if (_e1402 >= _e737) {
                                phi_2630_ = false;
                            } else {
                                let _e1405 = hits[_e1402];
                                if ((_e1405 & 2147483648u) == 0u) {
                                    phi_2559_ = 4294967295u;
                                } else {
                                    phi_2559_ = ((_e1405 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e1412 = phi_2559_;
                                if (_e1412 != 4294967295u) {
                                    let _e1416 = ((_e1405 >> bitcast<u32>(10i)) & 3u);
                                    let _e1423 = firsts[(2u * _e1416)];
                                    let _e1428 = firsts[((2u * _e1416) + 1u)];
                                    let _e1431 = leaves.member[(_e1423 + ((_e1405 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1434 = leaves.member[(_e1428 + (_e1405 & 31u))];
                                    let _e1436 = (_e1380 + _e1412);
                                    if (_e72 == 1u) {
                                        if (_e1431.w < _e1434.w) {
                                            phi_2611_ = type_9(_e1431.w, _e1434.w);
                                        } else {
                                            phi_2611_ = type_9(_e1434.w, _e1431.w);
                                        }
                                        let _e1443 = phi_2611_;
                                        phi_2616_ = _e1443;
                                    } else {
                                        phi_2616_ = type_9(_e1431.w, _e1434.w);
                                    }
                                    let _e1445 = phi_2616_;
                                    if (_e1436 < _e1364) {
                                        let _e1449 = (2u * _e1436);
                                        atomicStore((&output.member[(4u + _e1449)]), _e1445.member);
                                        atomicStore((&output.member[(_e1449 + 5u)]), _e1445.member_1);
                                    }
                                }
                                phi_2630_ = true;
                            }
                            let _e1455 = phi_2630_;
                            phi_2631_ = _e1455;
                        } else {
                            phi_2631_ = false;
                        }
                        let _e1457 = phi_2631_;
                        continue;
                        continuing {
                            phi_2511_ = _e1394;
                            break if !(_e1457);
                        }
                    }
                    workgroupBarrier();
                    let _e1620 = local_5;
                    phi_1160_ = _e1620;
                } else {
                    phi_1160_ = type_9();
                }
                let _e1460 = phi_1160_;
                continue;
                continuing {
                    phi_1156_ = _e664;
                    phi_1159_ = _e1460;
                    break if !(_e670);
                }
            }
        }
        continue;
        continuing {
            phi_293_ = _e142;
            break if !(_e148);
        }
    }
    if (_e52 == 0u) {
        let _e1465 = atomicLoad((&counters[9u]));
        if (_e1465 > 0u) {
            let _e1468 = atomicAdd((&output.member[1u]), _e1465);
            if ((_e1468 + _e1465) < _e1468) {
                let _e1472 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
