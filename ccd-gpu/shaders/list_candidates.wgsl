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
    var phi_2692_: bool;
    var phi_2693_: bool;
    var phi_2697_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2693_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2692_ = (param_1[0] > param[0]);
        } else {
            phi_2692_ = false;
        }
        let _e14 = phi_2692_;
        phi_2693_ = _e14;
    }
    let _e16 = phi_2693_;
    if _e16 {
        phi_2697_ = param_1;
    } else {
        phi_2697_ = param;
    }
    let _e18 = phi_2697_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2673_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2669_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2668_ = (param_2[0] > param_3[0]);
        } else {
            phi_2668_ = false;
        }
        let _e14 = phi_2668_;
        phi_2669_ = _e14;
    }
    let _e16 = phi_2669_;
    if _e16 {
        phi_2673_ = param_3;
    } else {
        phi_2673_ = param_2;
    }
    let _e18 = phi_2673_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2644_: bool;
    var phi_2645_: bool;
    var phi_2649_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2645_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2644_ = (param_5[0] > param_4[0]);
        } else {
            phi_2644_ = false;
        }
        let _e14 = phi_2644_;
        phi_2645_ = _e14;
    }
    let _e16 = phi_2645_;
    if _e16 {
        phi_2649_ = param_5;
    } else {
        phi_2649_ = param_4;
    }
    let _e18 = phi_2649_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2625_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2621_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2620_ = (param_6[0] > param_7[0]);
        } else {
            phi_2620_ = false;
        }
        let _e14 = phi_2620_;
        phi_2621_ = _e14;
    }
    let _e16 = phi_2621_;
    if _e16 {
        phi_2625_ = param_7;
    } else {
        phi_2625_ = param_6;
    }
    let _e18 = phi_2625_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2601_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2597_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2596_ = (param_9[0] > param_8[0]);
        } else {
            phi_2596_ = false;
        }
        let _e14 = phi_2596_;
        phi_2597_ = _e14;
    }
    let _e16 = phi_2597_;
    if _e16 {
        phi_2601_ = param_9;
    } else {
        phi_2601_ = param_8;
    }
    let _e18 = phi_2601_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2572_: bool;
    var phi_2573_: bool;
    var phi_2577_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2573_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2572_ = (param_10[0] > param_11[0]);
        } else {
            phi_2572_ = false;
        }
        let _e14 = phi_2572_;
        phi_2573_ = _e14;
    }
    let _e16 = phi_2573_;
    if _e16 {
        phi_2577_ = param_11;
    } else {
        phi_2577_ = param_10;
    }
    let _e18 = phi_2577_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_191_: u32;
    var phi_240_: u32;
    var phi_241_: u32;
    var phi_249_: u32;
    var phi_265_: u32;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_292_: type_9;
    var phi_293_: type_9;
    var phi_318_: type_9;
    var phi_365_: u32;
    var phi_366_: u32;
    var phi_374_: u32;
    var phi_388_: u32;
    var phi_431_: array<u32, 2>;
    var phi_491_: array<u32, 2>;
    var phi_652_: bool;
    var phi_690_: type_29;
    var phi_696_: bool;
    var phi_719_: u32;
    var phi_722_: type_9;
    var phi_725_: u32;
    var phi_723_: type_9;
    var phi_748_: type_9;
    var phi_726_: u32;
    var local: u32;
    var phi_937_: u32;
    var phi_943_: type_9;
    var phi_946_: u32;
    var phi_944_: type_9;
    var phi_969_: type_9;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_999_: bool;
    var phi_1007_: bool;
    var phi_1015_: u32;
    var phi_947_: u32;
    var phi_1016_: u32;
    var phi_1026_: type_9;
    var phi_1052_: u32;
    var phi_1055_: type_9;
    var phi_1058_: type_9;
    var phi_1056_: type_9;
    var phi_1083_: type_9;
    var phi_1100_: type_9;
    var phi_1103_: type_9;
    var phi_1104_: type_9;
    var phi_1126_: type_9;
    var phi_1160_: type_9;
    var phi_1161_: bool;
    var phi_1101_: type_9;
    var phi_1162_: bool;
    var phi_1170_: u32;
    var phi_1173_: type_9;
    var phi_1174_: type_9;
    var phi_1199_: type_9;
    var phi_1354_: bool;
    var phi_1360_: bool;
    var phi_1332_: bool;
    var phi_1339_: bool;
    var phi_1347_: bool;
    var phi_1362_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1416_: bool;
    var phi_1530_: bool;
    var phi_1531_: bool;
    var phi_1566_: u32;
    var phi_1567_: u32;
    var phi_1568_: u32;
    var phi_1569_: u32;
    var phi_1572_: type_15;
    var phi_1575_: u32;
    var phi_1577_: u32;
    var phi_1598_: bool;
    var phi_1604_: type_16;
    var phi_1573_: type_15;
    var phi_1618_: type_16;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1699_: u32;
    var phi_1700_: u32;
    var phi_1701_: u32;
    var phi_1702_: u32;
    var phi_1703_: bool;
    var phi_1576_: u32;
    var phi_1578_: u32;
    var phi_1704_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1764_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1895_: bool;
    var phi_1896_: bool;
    var phi_1983_: bool;
    var phi_1984_: bool;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2345_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2357_: bool;
    var phi_2373_: bool;
    var phi_2374_: bool;
    var phi_2410_: type_9;
    var phi_2411_: type_9;
    var phi_2434_: type_9;
    var phi_2458_: u32;
    var phi_2510_: type_9;
    var phi_2515_: type_9;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_1059_: type_9;
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
        phi_191_ = _e75;
    } else {
        phi_191_ = _e77;
    }
    let _e80 = phi_191_;
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
            phi_240_ = (_e95 + 1u);
        } else {
            phi_240_ = _e95;
        }
        let _e101 = phi_240_;
        phi_241_ = _e101;
    } else {
        phi_241_ = 0u;
    }
    let _e103 = phi_241_;
    let _e106 = params.member.member_2.member_4;
    if (_e106 < _e103) {
        phi_249_ = _e106;
    } else {
        phi_249_ = _e103;
    }
    let _e109 = phi_249_;
    let _e110 = (_e109 / 4u);
    if ((_e109 % 4u) > 0u) {
        phi_265_ = (_e110 + 1u);
    } else {
        phi_265_ = _e110;
    }
    let _e115 = phi_265_;
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
            phi_288_ = (_e119 + 1u);
        } else {
            phi_288_ = _e119;
        }
        let _e125 = phi_288_;
        phi_289_ = _e125;
    } else {
        phi_289_ = 0u;
    }
    let _e127 = phi_289_;
    phi_292_ = type_9(0u, _e127);
    loop {
        let _e130 = phi_292_;
        if (_e130.member < _e130.member_1) {
            phi_293_ = type_9((_e130.member + 1u), _e130.member_1);
            phi_318_ = type_9(1u, _e130.member);
        } else {
            phi_293_ = _e130;
            phi_318_ = type_9(0u, type_9().member_1);
        }
        let _e142 = phi_293_;
        let _e144 = phi_318_;
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
                    phi_365_ = (_e166 + 1u);
                } else {
                    phi_365_ = _e166;
                }
                let _e172 = phi_365_;
                phi_366_ = _e172;
            } else {
                phi_366_ = 0u;
            }
            let _e174 = phi_366_;
            let _e177 = params.member.member_2.member_4;
            if (_e177 < _e174) {
                phi_374_ = _e177;
            } else {
                phi_374_ = _e174;
            }
            let _e180 = phi_374_;
            let _e181 = (_e153 < _e180);
            let _e184 = params.member.member_1.member_1;
            let _e187 = params.member.member_2.member_3;
            if _e181 {
                phi_388_ = (_e153 * _e187);
            } else {
                phi_388_ = 0u;
            }
            let _e190 = phi_388_;
            let _e192 = (2u * (_e184 + _e190));
            let _e195 = input.member[(4u + _e192)];
            let _e198 = input.member[(_e192 + 5u)];
            if (_e52 <= 7u) {
                atomicStore((&counters[_e52]), 0u);
            }
            workgroupBarrier();
            if (_e72 == 0u) {
                phi_431_ = array<u32, 2>(0u, 2u);
            } else {
                phi_431_ = array<u32, 2>(1u, 1u);
            }
            let _e203 = phi_431_;
            if ((_e52 % 32u) == 0u) {
                let _e209 = (_e52 / 32u);
                let _e215 = params.member.member_2.member[0u][_e203[0]];
                firsts[(2u * _e209)] = (_e215 + (_e195 * 32u));
                let _e224 = params.member.member_2.member[0u][_e203[1]];
                firsts[((2u * _e209) + 1u)] = (_e224 + (_e198 * 32u));
            }
            let _e229 = params.member.member_2.member_1;
            if (_e229 == 0u) {
                phi_491_ = array<u32, 2>(0u, 2u);
            } else {
                phi_491_ = array<u32, 2>(1u, 1u);
            }
            let _e232 = phi_491_;
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
                phi_652_ = ((((((_e290.member.x <= _e266.member_1.y) && (_e266.member.x <= _e290.member_1.y)) && (_e290.member.y <= _e266.member_2.x)) && (_e266.member.y <= _e290.member_2.x)) && (_e290.member_1.x <= _e266.member_2.y)) && (_e266.member_1.x <= _e290.member_2.y));
            } else {
                phi_652_ = false;
            }
            let _e342 = phi_652_;
            if _e181 {
                if ((((((_e317.member.x <= _e245.member_1.y) && (_e245.member.x <= _e317.member_1.y)) && (_e317.member.y <= _e245.member_2.x)) && (_e245.member.y <= _e317.member_2.x)) && (_e317.member_1.x <= _e245.member_2.y)) && (_e245.member_1.x <= _e317.member_2.y)) {
                    let _e356 = atomicAdd((&counters[_e235]), 1u);
                    let _e357 = ((_e235 * 32u) + _e356);
                    columns[_e357] = type_29(array<f32, 3>(_e317.member.x, _e317.member.y, _e317.member_1.x), array<f32, 3>(_e317.member_1.y, _e317.member_2.x, _e317.member_2.y));
                    names[_e357] = _e236;
                }
            }
            if _e342 {
                phi_690_ = type_29(array<f32, 3>(_e290.member.x, _e290.member.y, _e290.member_1.x), array<f32, 3>(_e290.member_1.y, _e290.member_2.x, _e290.member_2.y));
            } else {
                phi_690_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e364 = phi_690_;
            workgroupBarrier();
            if (_e72 == 1u) {
                phi_696_ = (_e195 == _e198);
            } else {
                phi_696_ = false;
            }
            let _e368 = phi_696_;
            let _e369 = (_e52 / 32u);
            let _e371 = (_e369 * 32u);
            let _e373 = atomicLoad((&counters[_e369]));
            let _e374 = (_e373 / 4u);
            if ((_e373 % 4u) > 0u) {
                phi_719_ = (_e374 + 1u);
            } else {
                phi_719_ = _e374;
            }
            let _e379 = phi_719_;
            phi_722_ = type_9(0u, _e379);
            phi_725_ = 0u;
            loop {
                let _e382 = phi_722_;
                let _e384 = phi_725_;
                local = _e384;
                local_3 = _e384;
                if (_e382.member < _e382.member_1) {
                    phi_723_ = type_9((_e382.member + 1u), _e382.member_1);
                    phi_748_ = type_9(1u, _e382.member);
                } else {
                    phi_723_ = _e382;
                    phi_748_ = type_9(0u, type_9().member_1);
                }
                let _e396 = phi_723_;
                let _e398 = phi_748_;
                let _e402 = (bitcast<i32>(_e398.member) != 0i);
                if _e402 {
                    let _e403 = (4u * _e398.member_1);
                    let _e406 = columns[(_e371 + _e403)];
                    let _e445 = columns[((_e371 + _e403) + 1u)];
                    let _e486 = columns[((_e371 + _e403) + 2u)];
                    let _e527 = columns[((_e371 + _e403) + 3u)];
                    phi_726_ = (_e384 | ((((select(0u, 1u, ((((((_e364.member[0] <= _e406.member_1[0]) && (_e406.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e406.member_1[1])) && (_e406.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e406.member_1[2])) && (_e406.member[2] <= _e364.member_1[2]))) << bitcast<u32>((_e403 & 31u))) | (select(0u, 1u, ((((((_e364.member[0] <= _e445.member_1[0]) && (_e445.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e445.member_1[1])) && (_e445.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e445.member_1[2])) && (_e445.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e364.member[0] <= _e486.member_1[0]) && (_e486.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e486.member_1[1])) && (_e486.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e486.member_1[2])) && (_e486.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e364.member[0] <= _e527.member_1[0]) && (_e527.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e527.member_1[1])) && (_e527.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e527.member_1[2])) && (_e527.member[2] <= _e364.member_1[2]))) << bitcast<u32>(((_e403 + 3u) & 31u)))));
                } else {
                    phi_726_ = u32();
                }
                let _e567 = phi_726_;
                continue;
                continuing {
                    phi_722_ = _e396;
                    phi_725_ = _e567;
                    break if !(_e402);
                }
            }
            if (_e373 < 32u) {
                let _e575 = local;
                phi_937_ = (_e575 & ((1u << bitcast<u32>((_e373 & 31u))) - 1u));
            } else {
                let _e1501 = local_3;
                phi_937_ = _e1501;
            }
            let _e578 = phi_937_;
            if _e368 {
                phi_943_ = type_9(0u, _e373);
                phi_946_ = _e578;
                loop {
                    let _e581 = phi_943_;
                    let _e583 = phi_946_;
                    local_4 = _e583;
                    if (_e581.member < _e581.member_1) {
                        phi_944_ = type_9((_e581.member + 1u), _e581.member_1);
                        phi_969_ = type_9(1u, _e581.member);
                    } else {
                        phi_944_ = _e581;
                        phi_969_ = type_9(0u, type_9().member_1);
                    }
                    let _e595 = phi_944_;
                    let _e597 = phi_969_;
                    let _e601 = (bitcast<i32>(_e597.member) != 0i);
                    if _e601 {
                        let _e604 = names[(_e371 + _e597.member_1)];
                        if _e368 {
                            let _e605 = ((_e52 % 32u) < _e604);
                            if _e605 {
                                phi_993_ = bool();
                            } else {
                                phi_993_ = false;
                            }
                            let _e607 = phi_993_;
                            phi_994_ = _e607;
                            phi_995_ = _e605;
                        } else {
                            phi_994_ = bool();
                            phi_995_ = true;
                        }
                        let _e609 = phi_994_;
                        let _e611 = phi_995_;
                        if _e611 {
                            phi_999_ = true;
                        } else {
                            phi_999_ = _e609;
                        }
                        let _e613 = phi_999_;
                        if _e613 {
                            phi_1007_ = false;
                        } else {
                            phi_1007_ = true;
                        }
                        let _e615 = phi_1007_;
                        if _e615 {
                            phi_1015_ = (_e583 & ~((1u << bitcast<u32>((_e597.member_1 & 31u)))));
                        } else {
                            phi_1015_ = _e583;
                        }
                        let _e622 = phi_1015_;
                        phi_947_ = _e622;
                    } else {
                        phi_947_ = u32();
                    }
                    let _e624 = phi_947_;
                    continue;
                    continuing {
                        phi_943_ = _e595;
                        phi_946_ = _e624;
                        break if !(_e601);
                    }
                }
                let _e1515 = local_4;
                phi_1016_ = _e1515;
            } else {
                phi_1016_ = _e578;
            }
            let _e627 = phi_1016_;
            let _e629 = countOneBits(_e627);
            if (_e629 > 0u) {
                let _e632 = atomicAdd((&counters[4u]), _e629);
                phi_1026_ = type_9(_e627, _e632);
            } else {
                phi_1026_ = type_9(_e627, 0u);
            }
            let _e635 = phi_1026_;
            workgroupBarrier();
            if (_e52 == 0u) {
                let _e638 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e638;
            }
            let _e641 = workgroupUniformLoad((&n_hits[0u]));
            let _e642 = (_e641 / 512u);
            if ((_e641 % 512u) > 0u) {
                phi_1052_ = (_e642 + 1u);
            } else {
                phi_1052_ = _e642;
            }
            let _e647 = phi_1052_;
            phi_1055_ = type_9(0u, _e647);
            phi_1058_ = _e635;
            loop {
                let _e650 = phi_1055_;
                let _e652 = phi_1058_;
                if (_e650.member < _e650.member_1) {
                    phi_1056_ = type_9((_e650.member + 1u), _e650.member_1);
                    phi_1083_ = type_9(1u, _e650.member);
                } else {
                    phi_1056_ = _e650;
                    phi_1083_ = type_9(0u, type_9().member_1);
                }
                let _e664 = phi_1056_;
                let _e666 = phi_1083_;
                let _e670 = (bitcast<i32>(_e666.member) != 0i);
                if _e670 {
                    let _e671 = (_e52 / 32u);
                    let _e673 = (_e666.member_1 * 512u);
                    phi_1100_ = _e652;
                    phi_1103_ = type_9(0u, countOneBits(_e652.member));
                    loop {
                        let _e678 = phi_1100_;
                        let _e680 = phi_1103_;
                        local_5 = _e678;
                        if (_e680.member < _e680.member_1) {
                            phi_1104_ = type_9((_e680.member + 1u), _e680.member_1);
                            phi_1126_ = type_9(1u, _e680.member);
                        } else {
                            phi_1104_ = _e680;
                            phi_1126_ = type_9(0u, type_9().member_1);
                        }
                        let _e692 = phi_1104_;
                        let _e694 = phi_1126_;
                        if (bitcast<i32>(_e694.member) != 0i) {
                            let _e699 = (_e678.member_1 - _e673);
                            if (_e699 >= 512u) {
                                phi_1160_ = type_9();
                                phi_1161_ = false;
                            } else {
                                let _e708 = names[((_e671 * 32u) + select(firstTrailingBit(_e678.member), 32u, (_e678.member == 0u)))];
                                hits[_e699] = (((_e671 << bitcast<u32>(10i)) | ((_e52 % 32u) << bitcast<u32>(5i))) | _e708);
                                phi_1160_ = type_9((_e678.member & (_e678.member - 1u)), (_e678.member_1 + 1u));
                                phi_1161_ = true;
                            }
                            let _e724 = phi_1160_;
                            let _e726 = phi_1161_;
                            phi_1101_ = _e724;
                            phi_1162_ = _e726;
                        } else {
                            phi_1101_ = type_9();
                            phi_1162_ = false;
                        }
                        let _e728 = phi_1101_;
                        let _e730 = phi_1162_;
                        continue;
                        continuing {
                            phi_1100_ = _e728;
                            phi_1103_ = _e692;
                            break if !(_e730);
                        }
                    }
                    workgroupBarrier();
                    let _e733 = n_hits[0u];
                    let _e734 = (_e733 - _e673);
                    if (512u < _e734) {
                        phi_1170_ = 512u;
                    } else {
                        phi_1170_ = _e734;
                    }
                    let _e737 = phi_1170_;
                    phi_1173_ = type_9(0u, 4u);
                    loop {
                        let _e739 = phi_1173_;
                        if (_e739.member < _e739.member_1) {
                            phi_1174_ = type_9((_e739.member + 1u), _e739.member_1);
                            phi_1199_ = type_9(1u, _e739.member);
                        } else {
                            phi_1174_ = _e739;
                            phi_1199_ = type_9(0u, type_9().member_1);
                        }
                        let _e751 = phi_1174_;
                        let _e753 = phi_1199_;
                        if (bitcast<i32>(_e753.member) != 0i) {
                            let _e759 = (_e52 + (_e753.member_1 * 128u));
                            if (_e759 >= _e737) {
                                phi_2373_ = false;
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
                                            phi_1332_ = true;
                                        } else {
                                            phi_1332_ = (_e786.x == _e780.x);
                                        }
                                        let _e851 = phi_1332_;
                                        if (_e786.y == _e780.x) {
                                            phi_1339_ = true;
                                        } else {
                                            phi_1339_ = (_e786.y == _e780.x);
                                        }
                                        let _e855 = phi_1339_;
                                        if (_e786.z == _e780.x) {
                                            phi_1347_ = true;
                                        } else {
                                            phi_1347_ = (_e786.z == _e780.x);
                                        }
                                        let _e860 = phi_1347_;
                                        phi_1362_ = ((_e851 || _e855) || _e860);
                                    } else {
                                        if (_e786.x == _e780.x) {
                                            phi_1354_ = true;
                                        } else {
                                            phi_1354_ = (_e786.x == _e780.y);
                                        }
                                        let _e842 = phi_1354_;
                                        if (_e786.y == _e780.x) {
                                            phi_1360_ = true;
                                        } else {
                                            phi_1360_ = (_e786.y == _e780.y);
                                        }
                                        let _e846 = phi_1360_;
                                        phi_1362_ = (_e842 || _e846);
                                    }
                                    let _e863 = phi_1362_;
                                    if _e863 {
                                        phi_1366_ = false;
                                    } else {
                                        phi_1366_ = true;
                                    }
                                    let _e865 = phi_1366_;
                                    phi_1367_ = _e865;
                                } else {
                                    phi_1367_ = true;
                                }
                                let _e867 = phi_1367_;
                                if _e867 {
                                    if ((_e69.member_1 & 2u) != 0u) {
                                        let _e872 = bodies.member[_e780.x];
                                        let _e874 = bodies.member[_e786.x];
                                        if ((_e872 / 4u) != (_e874 / 4u)) {
                                            phi_1409_ = true;
                                        } else {
                                            if ((_e872 & 2u) == 0u) {
                                                phi_1408_ = false;
                                            } else {
                                                phi_1408_ = true;
                                            }
                                            let _e881 = phi_1408_;
                                            phi_1409_ = _e881;
                                        }
                                        let _e883 = phi_1409_;
                                        if _e883 {
                                            phi_1416_ = (((_e872 & _e874) & 1u) == 0u);
                                        } else {
                                            phi_1416_ = false;
                                        }
                                        let _e888 = phi_1416_;
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
                                                        phi_1530_ = true;
                                                    } else {
                                                        phi_1530_ = ((_e872 >> bitcast<u32>(2i)) == (_e874 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e941 = phi_1530_;
                                                    phi_1531_ = _e941;
                                                } else {
                                                    phi_1531_ = false;
                                                }
                                                let _e943 = phi_1531_;
                                                if _e943 {
                                                    let _e946 = bodies.member[(_e69.member[0] + 2u)];
                                                    let _e949 = bodies.member[(_e69.member[0] + 3u)];
                                                    let _e950 = (_e949 + _e69.member[0]);
                                                    if (_e72 == 1u) {
                                                        if (_e786.w < _e780.w) {
                                                            phi_1566_ = _e780.w;
                                                            phi_1567_ = _e786.w;
                                                        } else {
                                                            phi_1566_ = _e786.w;
                                                            phi_1567_ = _e780.w;
                                                        }
                                                        let _e954 = phi_1566_;
                                                        let _e956 = phi_1567_;
                                                        phi_1568_ = _e954;
                                                        phi_1569_ = _e956;
                                                    } else {
                                                        phi_1568_ = _e786.w;
                                                        phi_1569_ = _e780.w;
                                                    }
                                                    let _e958 = phi_1568_;
                                                    let _e960 = phi_1569_;
                                                    phi_1572_ = type_15(0i, 32i);
                                                    phi_1575_ = _e946;
                                                    phi_1577_ = 0u;
                                                    loop {
                                                        let _e962 = phi_1572_;
                                                        let _e964 = phi_1575_;
                                                        let _e966 = phi_1577_;
                                                        local_1 = _e966;
                                                        local_2 = _e966;
                                                        if (_e962.member < _e962.member_1) {
                                                            let _e973 = (_e962.member + 1i);
                                                            if ((false == (_e973 > _e962.member)) != false) {
                                                                phi_1598_ = true;
                                                            } else {
                                                                phi_1598_ = false;
                                                            }
                                                            let _e978 = phi_1598_;
                                                            if _e978 {
                                                                phi_1604_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1604_ = type_16(1u, _e973);
                                                            }
                                                            let _e983 = phi_1604_;
                                                            phi_1573_ = type_15(_e983.member_1, _e962.member_1);
                                                            phi_1618_ = type_16(1u, _e962.member);
                                                        } else {
                                                            phi_1573_ = _e962;
                                                            phi_1618_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e989 = phi_1573_;
                                                        let _e991 = phi_1618_;
                                                        if (bitcast<i32>(_e991.member) != 0i) {
                                                            if (_e966 >= _e964) {
                                                                phi_1701_ = u32();
                                                                phi_1702_ = u32();
                                                                phi_1703_ = false;
                                                            } else {
                                                                let _e998 = (_e966 + ((_e964 - _e966) / 2u));
                                                                let _e1000 = (_e950 + (3u * _e998));
                                                                let _e1002 = bodies.member[_e1000];
                                                                let _e1005 = bodies.member[(_e1000 + 1u)];
                                                                let _e1008 = bodies.member[(_e1000 + 2u)];
                                                                if (_e1002 < _e72) {
                                                                    phi_1694_ = true;
                                                                } else {
                                                                    if (_e1002 == _e72) {
                                                                        if (_e1005 < _e960) {
                                                                            phi_1688_ = false;
                                                                        } else {
                                                                            if (_e1005 == _e960) {
                                                                                if (_e1008 < _e958) {
                                                                                    phi_1686_ = false;
                                                                                } else {
                                                                                    phi_1686_ = true;
                                                                                }
                                                                                let _e1015 = phi_1686_;
                                                                                phi_1687_ = _e1015;
                                                                            } else {
                                                                                phi_1687_ = true;
                                                                            }
                                                                            let _e1017 = phi_1687_;
                                                                            phi_1688_ = _e1017;
                                                                        }
                                                                        let _e1019 = phi_1688_;
                                                                        phi_1689_ = _e1019;
                                                                    } else {
                                                                        phi_1689_ = true;
                                                                    }
                                                                    let _e1021 = phi_1689_;
                                                                    if _e1021 {
                                                                        phi_1693_ = false;
                                                                    } else {
                                                                        phi_1693_ = true;
                                                                    }
                                                                    let _e1023 = phi_1693_;
                                                                    phi_1694_ = _e1023;
                                                                }
                                                                let _e1025 = phi_1694_;
                                                                if _e1025 {
                                                                    phi_1699_ = _e964;
                                                                    phi_1700_ = (_e998 + 1u);
                                                                } else {
                                                                    phi_1699_ = _e998;
                                                                    phi_1700_ = _e966;
                                                                }
                                                                let _e1028 = phi_1699_;
                                                                let _e1030 = phi_1700_;
                                                                phi_1701_ = _e1028;
                                                                phi_1702_ = _e1030;
                                                                phi_1703_ = true;
                                                            }
                                                            let _e1032 = phi_1701_;
                                                            let _e1034 = phi_1702_;
                                                            let _e1036 = phi_1703_;
                                                            phi_1576_ = _e1032;
                                                            phi_1578_ = _e1034;
                                                            phi_1704_ = _e1036;
                                                        } else {
                                                            phi_1576_ = u32();
                                                            phi_1578_ = u32();
                                                            phi_1704_ = false;
                                                        }
                                                        let _e1038 = phi_1576_;
                                                        let _e1040 = phi_1578_;
                                                        let _e1042 = phi_1704_;
                                                        continue;
                                                        continuing {
                                                            phi_1572_ = _e989;
                                                            phi_1575_ = _e1038;
                                                            phi_1577_ = _e1040;
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
                                                                phi_1752_ = (_e1060 == _e958);
                                                                phi_1753_ = false;
                                                            } else {
                                                                phi_1752_ = bool();
                                                                phi_1753_ = true;
                                                            }
                                                            let _e1063 = phi_1752_;
                                                            let _e1065 = phi_1753_;
                                                            phi_1754_ = _e1063;
                                                            phi_1755_ = _e1065;
                                                        } else {
                                                            phi_1754_ = bool();
                                                            phi_1755_ = true;
                                                        }
                                                        let _e1067 = phi_1754_;
                                                        let _e1069 = phi_1755_;
                                                        if _e1069 {
                                                            phi_1759_ = false;
                                                        } else {
                                                            phi_1759_ = _e1067;
                                                        }
                                                        let _e1071 = phi_1759_;
                                                        phi_1760_ = _e1071;
                                                    } else {
                                                        phi_1760_ = false;
                                                    }
                                                    let _e1073 = phi_1760_;
                                                    phi_1764_ = _e1073;
                                                } else {
                                                    phi_1764_ = true;
                                                }
                                                let _e1075 = phi_1764_;
                                                if _e1075 {
                                                    phi_1768_ = false;
                                                } else {
                                                    phi_1768_ = true;
                                                }
                                                let _e1077 = phi_1768_;
                                                phi_1769_ = _e1077;
                                            } else {
                                                phi_1769_ = true;
                                            }
                                            let _e1079 = phi_1769_;
                                            if _e1079 {
                                                phi_1773_ = false;
                                            } else {
                                                phi_1773_ = true;
                                            }
                                            let _e1081 = phi_1773_;
                                            phi_1774_ = _e1081;
                                        } else {
                                            phi_1774_ = true;
                                        }
                                        let _e1083 = phi_1774_;
                                        if _e1083 {
                                            phi_1778_ = false;
                                        } else {
                                            phi_1778_ = true;
                                        }
                                        let _e1085 = phi_1778_;
                                        phi_1779_ = _e1085;
                                    } else {
                                        phi_1779_ = true;
                                    }
                                    let _e1087 = phi_1779_;
                                    if _e1087 {
                                        if ((_e69.member_1 & 32u) != 0u) {
                                            let _e1108 = (((((_e808.member_1.y - _e822.member.x) > _e69.member_6) && ((_e822.member_1.y - _e808.member.x) > _e69.member_6)) && (((_e808.member_2.x - _e822.member.y) > _e69.member_6) && ((_e822.member_2.x - _e808.member.y) > _e69.member_6))) && (((_e808.member_2.y - _e822.member_1.x) > _e69.member_6) && ((_e822.member_2.y - _e808.member_1.x) > _e69.member_6)));
                                            if _e1108 {
                                                phi_2343_ = bool();
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
                                                    phi_1896_ = true;
                                                } else {
                                                    if (_e1119[1] == _e1130[1]) {
                                                        phi_1895_ = (_e1119[0] > _e1130[0]);
                                                    } else {
                                                        phi_1895_ = false;
                                                    }
                                                    let _e1141 = phi_1895_;
                                                    phi_1896_ = _e1141;
                                                }
                                                let _e1143 = phi_1896_;
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
                                                    phi_1984_ = true;
                                                } else {
                                                    if (_e1155[1] == _e1166[1]) {
                                                        phi_1983_ = (_e1155[0] > _e1166[0]);
                                                    } else {
                                                        phi_1983_ = false;
                                                    }
                                                    let _e1177 = phi_1983_;
                                                    phi_1984_ = _e1177;
                                                }
                                                let _e1179 = phi_1984_;
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
                                                    phi_2073_ = true;
                                                } else {
                                                    if (_e1192[1] == _e1203[1]) {
                                                        phi_2072_ = (_e1192[0] > _e1203[0]);
                                                    } else {
                                                        phi_2072_ = false;
                                                    }
                                                    let _e1214 = phi_2072_;
                                                    phi_2073_ = _e1214;
                                                }
                                                let _e1216 = phi_2073_;
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
                                                    phi_2161_ = true;
                                                } else {
                                                    if (_e1228[1] == _e1239[1]) {
                                                        phi_2160_ = (_e1228[0] > _e1239[0]);
                                                    } else {
                                                        phi_2160_ = false;
                                                    }
                                                    let _e1250 = phi_2160_;
                                                    phi_2161_ = _e1250;
                                                }
                                                let _e1252 = phi_2161_;
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
                                                    phi_2251_ = true;
                                                } else {
                                                    if (_e1266[1] == _e1277[1]) {
                                                        phi_2250_ = (_e1266[0] > _e1277[0]);
                                                    } else {
                                                        phi_2250_ = false;
                                                    }
                                                    let _e1288 = phi_2250_;
                                                    phi_2251_ = _e1288;
                                                }
                                                let _e1290 = phi_2251_;
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
                                                    phi_2339_ = true;
                                                } else {
                                                    if (_e1302[1] == _e1313[1]) {
                                                        phi_2338_ = (_e1302[0] > _e1313[0]);
                                                    } else {
                                                        phi_2338_ = false;
                                                    }
                                                    let _e1324 = phi_2338_;
                                                    phi_2339_ = _e1324;
                                                }
                                                let _e1326 = phi_2339_;
                                                phi_2343_ = (((!(_e1143) && !(_e1179)) && (!(_e1216) && !(_e1252))) && (!(_e1290) && !(_e1326)));
                                            }
                                            let _e1331 = phi_2343_;
                                            phi_2344_ = _e1331;
                                            phi_2345_ = _e1108;
                                        } else {
                                            phi_2344_ = bool();
                                            phi_2345_ = true;
                                        }
                                        let _e1333 = phi_2344_;
                                        let _e1335 = phi_2345_;
                                        if _e1335 {
                                            phi_2349_ = false;
                                        } else {
                                            phi_2349_ = true;
                                        }
                                        let _e1337 = phi_2349_;
                                        phi_2350_ = _e1333;
                                        phi_2351_ = _e1337;
                                    } else {
                                        phi_2350_ = false;
                                        phi_2351_ = true;
                                    }
                                    let _e1339 = phi_2350_;
                                    let _e1341 = phi_2351_;
                                    phi_2352_ = _e1339;
                                    phi_2353_ = _e1341;
                                } else {
                                    phi_2352_ = false;
                                    phi_2353_ = true;
                                }
                                let _e1343 = phi_2352_;
                                let _e1345 = phi_2353_;
                                if _e1345 {
                                    phi_2357_ = _e1343;
                                } else {
                                    phi_2357_ = true;
                                }
                                let _e1347 = phi_2357_;
                                if _e1347 {
                                    let _e1349 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1347 {
                                    let _e1351 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e759] = ((2147483648u | (_e1351 << bitcast<u32>(12i))) | _e762);
                                }
                                phi_2373_ = true;
                            }
                            let _e1358 = phi_2373_;
                            phi_2374_ = _e1358;
                        } else {
                            phi_2374_ = false;
                        }
                        let _e1360 = phi_2374_;
                        continue;
                        continuing {
                            phi_1173_ = _e751;
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
                    phi_2410_ = type_9(0u, 4u);
                    loop {
                        let _e1382 = phi_2410_;
                        if (_e1382.member < _e1382.member_1) {
                            phi_2411_ = type_9((_e1382.member + 1u), _e1382.member_1);
                            phi_2434_ = type_9(1u, _e1382.member);
                        } else {
                            phi_2411_ = _e1382;
                            phi_2434_ = type_9(0u, type_9().member_1);
                        }
                        let _e1394 = phi_2411_;
                        let _e1396 = phi_2434_;
                        if (bitcast<i32>(_e1396.member) != 0i) {
                            let _e1402 = (_e52 + (_e1396.member_1 * 128u));
                            if (_e1402 >= _e737) {
                                phi_2529_ = false;
                            } else {
                                let _e1405 = hits[_e1402];
                                if ((_e1405 & 2147483648u) == 0u) {
                                    phi_2458_ = 4294967295u;
                                } else {
                                    phi_2458_ = ((_e1405 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e1412 = phi_2458_;
                                if (_e1412 != 4294967295u) {
                                    let _e1416 = ((_e1405 >> bitcast<u32>(10i)) & 3u);
                                    let _e1423 = firsts[(2u * _e1416)];
                                    let _e1428 = firsts[((2u * _e1416) + 1u)];
                                    let _e1431 = leaves.member[(_e1423 + ((_e1405 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1434 = leaves.member[(_e1428 + (_e1405 & 31u))];
                                    let _e1436 = (_e1380 + _e1412);
                                    if (_e72 == 1u) {
                                        if (_e1431.w < _e1434.w) {
                                            phi_2510_ = type_9(_e1431.w, _e1434.w);
                                        } else {
                                            phi_2510_ = type_9(_e1434.w, _e1431.w);
                                        }
                                        let _e1443 = phi_2510_;
                                        phi_2515_ = _e1443;
                                    } else {
                                        phi_2515_ = type_9(_e1431.w, _e1434.w);
                                    }
                                    let _e1445 = phi_2515_;
                                    if (_e1436 < _e1364) {
                                        let _e1449 = (2u * _e1436);
                                        atomicStore((&output.member[(4u + _e1449)]), _e1445.member);
                                        atomicStore((&output.member[(_e1449 + 5u)]), _e1445.member_1);
                                    }
                                }
                                phi_2529_ = true;
                            }
                            let _e1455 = phi_2529_;
                            phi_2530_ = _e1455;
                        } else {
                            phi_2530_ = false;
                        }
                        let _e1457 = phi_2530_;
                        continue;
                        continuing {
                            phi_2410_ = _e1394;
                            break if !(_e1457);
                        }
                    }
                    workgroupBarrier();
                    let _e1620 = local_5;
                    phi_1059_ = _e1620;
                } else {
                    phi_1059_ = type_9();
                }
                let _e1460 = phi_1059_;
                continue;
                continuing {
                    phi_1055_ = _e664;
                    phi_1058_ = _e1460;
                    break if !(_e670);
                }
            }
        }
        continue;
        continuing {
            phi_292_ = _e142;
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
