struct type_8 {
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

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
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
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> nodes: type_13;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_11, 128>;
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

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_2843_: bool;
    var phi_2844_: bool;
    var phi_2848_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2844_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2843_ = (param_1[0] > param[0]);
        } else {
            phi_2843_ = false;
        }
        let _e14 = phi_2843_;
        phi_2844_ = _e14;
    }
    let _e16 = phi_2844_;
    if _e16 {
        phi_2848_ = param_1;
    } else {
        phi_2848_ = param;
    }
    let _e18 = phi_2848_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_2824_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2820_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2819_ = (param_2[0] > param_3[0]);
        } else {
            phi_2819_ = false;
        }
        let _e14 = phi_2819_;
        phi_2820_ = _e14;
    }
    let _e16 = phi_2820_;
    if _e16 {
        phi_2824_ = param_3;
    } else {
        phi_2824_ = param_2;
    }
    let _e18 = phi_2824_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2795_: bool;
    var phi_2796_: bool;
    var phi_2800_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2796_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2795_ = (param_5[0] > param_4[0]);
        } else {
            phi_2795_ = false;
        }
        let _e14 = phi_2795_;
        phi_2796_ = _e14;
    }
    let _e16 = phi_2796_;
    if _e16 {
        phi_2800_ = param_5;
    } else {
        phi_2800_ = param_4;
    }
    let _e18 = phi_2800_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2771_: bool;
    var phi_2772_: bool;
    var phi_2776_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2772_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2771_ = (param_6[0] > param_7[0]);
        } else {
            phi_2771_ = false;
        }
        let _e14 = phi_2771_;
        phi_2772_ = _e14;
    }
    let _e16 = phi_2772_;
    if _e16 {
        phi_2776_ = param_7;
    } else {
        phi_2776_ = param_6;
    }
    let _e18 = phi_2776_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2752_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2748_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2747_ = (param_9[0] > param_8[0]);
        } else {
            phi_2747_ = false;
        }
        let _e14 = phi_2747_;
        phi_2748_ = _e14;
    }
    let _e16 = phi_2748_;
    if _e16 {
        phi_2752_ = param_9;
    } else {
        phi_2752_ = param_8;
    }
    let _e18 = phi_2752_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2723_: bool;
    var phi_2724_: bool;
    var phi_2728_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2724_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2723_ = (param_10[0] > param_11[0]);
        } else {
            phi_2723_ = false;
        }
        let _e14 = phi_2723_;
        phi_2724_ = _e14;
    }
    let _e16 = phi_2724_;
    if _e16 {
        phi_2728_ = param_11;
    } else {
        phi_2728_ = param_10;
    }
    let _e18 = phi_2728_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_161_: u32;
    var phi_172_: array<u32, 2>;
    var phi_201_: u32;
    var phi_202_: u32;
    var phi_209_: u32;
    var phi_225_: u32;
    var phi_246_: u32;
    var phi_247_: u32;
    var phi_250_: type_21;
    var phi_251_: type_21;
    var phi_274_: type_21;
    var phi_312_: u32;
    var phi_313_: u32;
    var phi_320_: u32;
    var phi_330_: u32;
    var phi_409_: array<u32, 2>;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_608_: type_11;
    var phi_614_: bool;
    var phi_621_: type_21;
    var phi_624_: u32;
    var phi_622_: type_21;
    var phi_647_: type_21;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_719_: bool;
    var phi_737_: u32;
    var phi_738_: u32;
    var phi_739_: u32;
    var phi_625_: u32;
    var phi_742_: type_21;
    var phi_745_: u32;
    var phi_743_: type_21;
    var phi_768_: type_21;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_894_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_895_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_944_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1588_: bool;
    var phi_1606_: type_21;
    var phi_1611_: type_21;
    var phi_1651_: u32;
    var phi_1652_: bool;
    var phi_746_: u32;
    var phi_1653_: bool;
    var phi_1660_: u32;
    var phi_1663_: type_21;
    var phi_1664_: type_21;
    var phi_1687_: type_21;
    var phi_1813_: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1821_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1791_: bool;
    var phi_1822_: bool;
    var phi_1826_: bool;
    var phi_1827_: bool;
    var phi_1871_: bool;
    var phi_1881_: bool;
    var phi_1882_: bool;
    var phi_1886_: bool;
    var phi_1887_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2117_: bool;
    var phi_2118_: bool;
    var phi_2212_: bool;
    var phi_2213_: bool;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2402_: bool;
    var phi_2403_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2515_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2581_: type_21;
    var phi_2582_: type_21;
    var phi_2605_: type_21;
    var phi_2628_: u32;
    var phi_2682_: type_21;
    var phi_2687_: type_21;
    var phi_2703_: bool;
    var phi_2704_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e59 = ((_e45.y * _e46.x) + _e45.x);
    let _e62 = (_e46.x * _e46.y);
    let _e64 = params.member.member_15;
    let _e66 = input.member[0u];
    if (_e64 < _e66) {
        phi_161_ = _e64;
    } else {
        phi_161_ = _e66;
    }
    let _e69 = phi_161_;
    let _e70 = (_e47 / 32u);
    let _e71 = (_e47 % 32u);
    let _e73 = params.member.member_8;
    if (_e73 == 0u) {
        phi_172_ = array<u32, 2>(0u, 2u);
    } else {
        phi_172_ = array<u32, 2>(1u, 1u);
    }
    let _e76 = phi_172_;
    let _e80 = params.member.member_12;
    if (_e69 > _e80) {
        let _e83 = params.member.member_12;
        let _e84 = (_e69 - _e83);
        let _e86 = params.member.member_13;
        if (_e86 == 0u) {
            return;
        }
        let _e88 = (_e84 / _e86);
        if (_e86 == 0u) {
            return;
        }
        if ((_e84 % _e86) > 0u) {
            phi_201_ = (_e88 + 1u);
        } else {
            phi_201_ = _e88;
        }
        let _e94 = phi_201_;
        phi_202_ = _e94;
    } else {
        phi_202_ = 0u;
    }
    let _e96 = phi_202_;
    let _e98 = params.member.member_14;
    if (_e98 < _e96) {
        phi_209_ = _e98;
    } else {
        phi_209_ = _e96;
    }
    let _e101 = phi_209_;
    let _e102 = (_e101 / 4u);
    if ((_e101 % 4u) > 0u) {
        phi_225_ = (_e102 + 1u);
    } else {
        phi_225_ = _e102;
    }
    let _e107 = phi_225_;
    if (_e107 > _e59) {
        let _e109 = (_e107 - _e59);
        if (_e62 == 0u) {
            return;
        }
        let _e111 = (_e109 / _e62);
        if (_e62 == 0u) {
            return;
        }
        if ((_e109 % _e62) > 0u) {
            phi_246_ = (_e111 + 1u);
        } else {
            phi_246_ = _e111;
        }
        let _e117 = phi_246_;
        phi_247_ = _e117;
    } else {
        phi_247_ = 0u;
    }
    let _e119 = phi_247_;
    phi_250_ = type_21(0u, _e119);
    loop {
        let _e122 = phi_250_;
        if (_e122.member < _e122.member_1) {
            phi_251_ = type_21((_e122.member + 1u), _e122.member_1);
            phi_274_ = type_21(1u, _e122.member);
        } else {
            phi_251_ = _e122;
            phi_274_ = type_21(0u, type_21().member_1);
        }
        let _e134 = phi_251_;
        let _e136 = phi_274_;
        let _e140 = (bitcast<i32>(_e136.member) != 0i);
        if _e140 {
            let _e144 = (((_e59 + (_e136.member_1 * _e62)) * 4u) + _e70);
            let _e146 = params.member.member_12;
            if (_e69 > _e146) {
                let _e149 = params.member.member_12;
                let _e150 = (_e69 - _e149);
                let _e152 = params.member.member_13;
                if (_e152 == 0u) {
                    return;
                }
                let _e154 = (_e150 / _e152);
                if (_e152 == 0u) {
                    return;
                }
                if ((_e150 % _e152) > 0u) {
                    phi_312_ = (_e154 + 1u);
                } else {
                    phi_312_ = _e154;
                }
                let _e160 = phi_312_;
                phi_313_ = _e160;
            } else {
                phi_313_ = 0u;
            }
            let _e162 = phi_313_;
            let _e164 = params.member.member_14;
            if (_e164 < _e162) {
                phi_320_ = _e164;
            } else {
                phi_320_ = _e162;
            }
            let _e167 = phi_320_;
            let _e168 = (_e144 < _e167);
            let _e170 = params.member.member_12;
            if _e168 {
                let _e172 = params.member.member_13;
                phi_330_ = (_e144 * _e172);
            } else {
                phi_330_ = 0u;
            }
            let _e175 = phi_330_;
            let _e177 = (2u * (_e170 + _e175));
            let _e180 = input.member[(4u + _e177)];
            let _e183 = input.member[(_e177 + 5u)];
            if (_e47 < 8u) {
                atomicStore((&counters[_e47]), 0u);
            }
            workgroupBarrier();
            let _e190 = params.member.member_20[0u][_e76[0]];
            let _e191 = (_e190 + (_e180 * 32u));
            let _e196 = params.member.member_20[0u][_e76[1]];
            let _e197 = (_e196 + (_e183 * 32u));
            if (_e71 == 0u) {
                firsts[(2u * _e70)] = _e191;
                firsts[((2u * _e70) + 1u)] = _e197;
            }
            let _e205 = params.member.member_8;
            if (_e205 == 0u) {
                phi_409_ = array<u32, 2>(0u, 2u);
            } else {
                phi_409_ = array<u32, 2>(1u, 1u);
            }
            let _e208 = phi_409_;
            let _e211 = (_e47 / 32u);
            let _e212 = (_e47 % 32u);
            let _e214 = params.member.member_9;
            let _e218 = params.member.member_20[_e214][_e208[0]];
            let _e221 = nodes.member[(_e218 + _e180)];
            let _e223 = params.member.member_9;
            let _e227 = params.member.member_20[_e223][_e208[1]];
            let _e230 = nodes.member[(_e227 + _e183)];
            let _e232 = params.member.member_9;
            let _e239 = params.member.member_20[(_e232 - 1u)][_e208[0]];
            let _e242 = nodes.member[(_e239 + ((_e180 * 32u) + _e212))];
            let _e244 = params.member.member_9;
            let _e251 = params.member.member_20[(_e244 - 1u)][_e208[1]];
            let _e254 = nodes.member[(_e251 + ((_e183 * 32u) + _e212))];
            if _e168 {
                if ((((((_e254.member[0] <= _e221.member_1[0]) && (_e221.member[0] <= _e254.member_1[0])) && (_e254.member[1] <= _e221.member_1[1])) && (_e221.member[1] <= _e254.member_1[1])) && (_e254.member[2] <= _e221.member_1[2])) && (_e221.member[2] <= _e254.member_1[2])) {
                    let _e292 = atomicAdd((&counters[_e211]), 1u);
                    let _e293 = ((_e211 * 32u) + _e292);
                    columns[_e293] = type_11(array<f32, 3>(_e254.member[0], _e254.member[1], _e254.member[2]), array<f32, 3>(_e254.member_1[0], _e254.member_1[1], _e254.member_1[2]));
                    names[_e293] = _e212;
                }
            }
            workgroupBarrier();
            if _e168 {
                if ((((((_e242.member[0] <= _e230.member_1[0]) && (_e230.member[0] <= _e242.member_1[0])) && (_e242.member[1] <= _e230.member_1[1])) && (_e230.member[1] <= _e242.member_1[1])) && (_e242.member[2] <= _e230.member_1[2])) && (_e230.member[2] <= _e242.member_1[2])) {
                    phi_603_ = false;
                } else {
                    phi_603_ = true;
                }
                let _e343 = phi_603_;
                phi_604_ = _e343;
            } else {
                phi_604_ = true;
            }
            let _e345 = phi_604_;
            if _e345 {
                phi_608_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_608_ = _e242;
            }
            let _e347 = phi_608_;
            if (_e76[0] == _e76[1]) {
                phi_614_ = (_e180 == _e183);
            } else {
                phi_614_ = false;
            }
            let _e351 = phi_614_;
            let _e352 = (_e47 / 32u);
            let _e353 = (_e47 % 32u);
            let _e355 = atomicLoad((&counters[_e352]));
            phi_621_ = type_21(0u, _e355);
            phi_624_ = 0u;
            loop {
                let _e358 = phi_621_;
                let _e360 = phi_624_;
                local = _e360;
                if (_e358.member < _e358.member_1) {
                    phi_622_ = type_21((_e358.member + 1u), _e358.member_1);
                    phi_647_ = type_21(1u, _e358.member);
                } else {
                    phi_622_ = _e358;
                    phi_647_ = type_21(0u, type_21().member_1);
                }
                let _e372 = phi_622_;
                let _e374 = phi_647_;
                let _e378 = (bitcast<i32>(_e374.member) != 0i);
                if _e378 {
                    let _e382 = names[((_e352 * 32u) + _e374.member_1)];
                    let _e386 = columns[((_e352 * 32u) + _e374.member_1)];
                    if ((((((_e347.member[0] <= _e386.member_1[0]) && (_e386.member[0] <= _e347.member_1[0])) && (_e347.member[1] <= _e386.member_1[1])) && (_e386.member[1] <= _e347.member_1[1])) && (_e347.member[2] <= _e386.member_1[2])) && (_e386.member[2] <= _e347.member_1[2])) {
                        if _e351 {
                            let _e418 = (_e353 < _e382);
                            if _e418 {
                                phi_713_ = bool();
                            } else {
                                phi_713_ = false;
                            }
                            let _e420 = phi_713_;
                            phi_714_ = _e420;
                            phi_715_ = _e418;
                        } else {
                            phi_714_ = bool();
                            phi_715_ = true;
                        }
                        let _e422 = phi_714_;
                        let _e424 = phi_715_;
                        if _e424 {
                            phi_719_ = true;
                        } else {
                            phi_719_ = _e422;
                        }
                        let _e426 = phi_719_;
                        if _e426 {
                            let _e428 = atomicAdd((&counters[4u]), 1u);
                            if (_e428 < 2048u) {
                                hits[_e428] = (((_e352 << bitcast<u32>(10i)) | (_e353 << bitcast<u32>(5i))) | _e382);
                                phi_737_ = _e360;
                            } else {
                                phi_737_ = (_e360 | (1u << bitcast<u32>((_e374.member_1 & 31u))));
                            }
                            let _e442 = phi_737_;
                            phi_738_ = _e442;
                        } else {
                            phi_738_ = _e360;
                        }
                        let _e444 = phi_738_;
                        phi_739_ = _e444;
                    } else {
                        phi_739_ = _e360;
                    }
                    let _e446 = phi_739_;
                    phi_625_ = _e446;
                } else {
                    phi_625_ = u32();
                }
                let _e448 = phi_625_;
                continue;
                continuing {
                    phi_621_ = _e372;
                    phi_624_ = _e448;
                    break if !(_e378);
                }
            }
            phi_742_ = type_21(0u, 32u);
            let _e1660 = local;
            phi_745_ = _e1660;
            loop {
                let _e451 = phi_742_;
                let _e453 = phi_745_;
                if (_e451.member < _e451.member_1) {
                    phi_743_ = type_21((_e451.member + 1u), _e451.member_1);
                    phi_768_ = type_21(1u, _e451.member);
                } else {
                    phi_743_ = _e451;
                    phi_768_ = type_21(0u, type_21().member_1);
                }
                let _e465 = phi_743_;
                let _e467 = phi_768_;
                if (bitcast<i32>(_e467.member) != 0i) {
                    if (_e453 == 0u) {
                        phi_1651_ = u32();
                        phi_1652_ = false;
                    } else {
                        let _e478 = names[((_e70 * 32u) + select(firstTrailingBit(_e453), 32u, (_e453 == 0u)))];
                        let _e481 = (_e191 + _e71);
                        let _e482 = (_e197 + _e478);
                        let _e484 = leaves.member[_e481];
                        let _e486 = leaves.member[_e482];
                        let _e488 = nodes.member[_e481];
                        let _e490 = nodes.member[_e482];
                        let _e492 = params.member.member_1;
                        if ((_e492 & 1u) != 0u) {
                            let _e496 = params.member.member_8;
                            if (_e496 == 0u) {
                                if (_e484.member[0] == _e486.member[0]) {
                                    phi_859_ = bool();
                                    phi_860_ = true;
                                } else {
                                    let _e539 = (_e484.member[0] == _e486.member[1]);
                                    if _e539 {
                                        phi_858_ = bool();
                                    } else {
                                        phi_858_ = (_e484.member[0] == _e486.member[2]);
                                    }
                                    let _e546 = phi_858_;
                                    phi_859_ = _e546;
                                    phi_860_ = _e539;
                                }
                                let _e548 = phi_859_;
                                let _e550 = phi_860_;
                                if _e550 {
                                    phi_864_ = true;
                                } else {
                                    phi_864_ = _e548;
                                }
                                let _e552 = phi_864_;
                                phi_895_ = _e552;
                            } else {
                                if (_e484.member[0] == _e486.member[0]) {
                                    phi_889_ = bool();
                                    phi_890_ = true;
                                } else {
                                    if (_e484.member[0] == _e486.member[1]) {
                                        phi_887_ = bool();
                                        phi_888_ = true;
                                    } else {
                                        let _e512 = (_e484.member[1] == _e486.member[0]);
                                        if _e512 {
                                            phi_886_ = bool();
                                        } else {
                                            phi_886_ = (_e484.member[1] == _e486.member[1]);
                                        }
                                        let _e519 = phi_886_;
                                        phi_887_ = _e519;
                                        phi_888_ = _e512;
                                    }
                                    let _e521 = phi_887_;
                                    let _e523 = phi_888_;
                                    phi_889_ = _e521;
                                    phi_890_ = _e523;
                                }
                                let _e525 = phi_889_;
                                let _e527 = phi_890_;
                                if _e527 {
                                    phi_894_ = true;
                                } else {
                                    phi_894_ = _e525;
                                }
                                let _e529 = phi_894_;
                                phi_895_ = _e529;
                            }
                            let _e554 = phi_895_;
                            if _e554 {
                                phi_899_ = false;
                            } else {
                                phi_899_ = true;
                            }
                            let _e556 = phi_899_;
                            phi_900_ = _e556;
                        } else {
                            phi_900_ = true;
                        }
                        let _e558 = phi_900_;
                        if _e558 {
                            let _e560 = params.member.member_1;
                            if ((_e560 & 2u) != 0u) {
                                let _e566 = bodies.member[_e484.member[0]];
                                let _e570 = bodies.member[_e486.member[0]];
                                if ((_e566 / 2u) == (_e570 / 2u)) {
                                    let _e575 = params.member.member_1;
                                    phi_944_ = !(((_e575 & 4u) != 0u));
                                } else {
                                    phi_944_ = false;
                                }
                                let _e580 = phi_944_;
                                if _e580 {
                                    phi_955_ = true;
                                } else {
                                    if (((_e566 & _e570) & 1u) == 0u) {
                                        phi_954_ = false;
                                    } else {
                                        phi_954_ = true;
                                    }
                                    let _e585 = phi_954_;
                                    phi_955_ = _e585;
                                }
                                let _e587 = phi_955_;
                                if _e587 {
                                    phi_959_ = false;
                                } else {
                                    phi_959_ = true;
                                }
                                let _e589 = phi_959_;
                                phi_960_ = _e589;
                            } else {
                                phi_960_ = true;
                            }
                            let _e591 = phi_960_;
                            if _e591 {
                                let _e593 = params.member.member_1;
                                if ((_e593 & 32u) != 0u) {
                                    let _e597 = params.member.member_6;
                                    let _e638 = (((((((_e488.member_1[0] - _e490.member[0]) > _e597) && ((_e490.member_1[0] - _e488.member[0]) > _e597)) && ((_e488.member_1[1] - _e490.member[1]) > _e597)) && ((_e490.member_1[1] - _e488.member[1]) > _e597)) && ((_e488.member_1[2] - _e490.member[2]) > _e597)) && ((_e490.member_1[2] - _e488.member[2]) > _e597));
                                    if _e638 {
                                        phi_1574_ = bool();
                                    } else {
                                        let _e642 = keys.member[_e484.member[0]];
                                        let _e647 = keys.member[_e484.member[1]];
                                        let _e649 = function_5(_e642[0], _e647[0]);
                                        let _e653 = keys.member[_e484.member[2]];
                                        let _e655 = function_5(_e649, _e653[0]);
                                        let _e659 = keys.member[_e486.member[0]];
                                        let _e664 = keys.member[_e486.member[1]];
                                        let _e666 = function_4(_e659[3], _e664[3]);
                                        let _e670 = keys.member[_e486.member[2]];
                                        let _e672 = function_4(_e666, _e670[3]);
                                        if (_e655[1] > _e672[1]) {
                                            phi_1097_ = true;
                                        } else {
                                            if (_e655[1] == _e672[1]) {
                                                phi_1096_ = (_e655[0] > _e672[0]);
                                            } else {
                                                phi_1096_ = false;
                                            }
                                            let _e683 = phi_1096_;
                                            phi_1097_ = _e683;
                                        }
                                        let _e685 = phi_1097_;
                                        let _e690 = keys.member[_e486.member[0]];
                                        let _e695 = keys.member[_e486.member[1]];
                                        let _e697 = function_5(_e690[0], _e695[0]);
                                        let _e701 = keys.member[_e486.member[2]];
                                        let _e703 = function_5(_e697, _e701[0]);
                                        let _e707 = keys.member[_e484.member[0]];
                                        let _e712 = keys.member[_e484.member[1]];
                                        let _e714 = function_4(_e707[3], _e712[3]);
                                        let _e718 = keys.member[_e484.member[2]];
                                        let _e720 = function_4(_e714, _e718[3]);
                                        if (_e703[1] > _e720[1]) {
                                            phi_1191_ = true;
                                        } else {
                                            if (_e703[1] == _e720[1]) {
                                                phi_1190_ = (_e703[0] > _e720[0]);
                                            } else {
                                                phi_1190_ = false;
                                            }
                                            let _e731 = phi_1190_;
                                            phi_1191_ = _e731;
                                        }
                                        let _e733 = phi_1191_;
                                        let _e739 = keys.member[_e484.member[0]];
                                        let _e744 = keys.member[_e484.member[1]];
                                        let _e746 = function_3(_e739[1], _e744[1]);
                                        let _e750 = keys.member[_e484.member[2]];
                                        let _e752 = function_3(_e746, _e750[1]);
                                        let _e756 = keys.member[_e486.member[0]];
                                        let _e761 = keys.member[_e486.member[1]];
                                        let _e763 = function_2(_e756[4], _e761[4]);
                                        let _e767 = keys.member[_e486.member[2]];
                                        let _e769 = function_2(_e763, _e767[4]);
                                        if (_e752[1] > _e769[1]) {
                                            phi_1286_ = true;
                                        } else {
                                            if (_e752[1] == _e769[1]) {
                                                phi_1285_ = (_e752[0] > _e769[0]);
                                            } else {
                                                phi_1285_ = false;
                                            }
                                            let _e780 = phi_1285_;
                                            phi_1286_ = _e780;
                                        }
                                        let _e782 = phi_1286_;
                                        let _e787 = keys.member[_e486.member[0]];
                                        let _e792 = keys.member[_e486.member[1]];
                                        let _e794 = function_3(_e787[1], _e792[1]);
                                        let _e798 = keys.member[_e486.member[2]];
                                        let _e800 = function_3(_e794, _e798[1]);
                                        let _e804 = keys.member[_e484.member[0]];
                                        let _e809 = keys.member[_e484.member[1]];
                                        let _e811 = function_2(_e804[4], _e809[4]);
                                        let _e815 = keys.member[_e484.member[2]];
                                        let _e817 = function_2(_e811, _e815[4]);
                                        if (_e800[1] > _e817[1]) {
                                            phi_1380_ = true;
                                        } else {
                                            if (_e800[1] == _e817[1]) {
                                                phi_1379_ = (_e800[0] > _e817[0]);
                                            } else {
                                                phi_1379_ = false;
                                            }
                                            let _e828 = phi_1379_;
                                            phi_1380_ = _e828;
                                        }
                                        let _e830 = phi_1380_;
                                        let _e837 = keys.member[_e484.member[0]];
                                        let _e842 = keys.member[_e484.member[1]];
                                        let _e844 = function_1(_e837[2], _e842[2]);
                                        let _e848 = keys.member[_e484.member[2]];
                                        let _e850 = function_1(_e844, _e848[2]);
                                        let _e854 = keys.member[_e486.member[0]];
                                        let _e859 = keys.member[_e486.member[1]];
                                        let _e861 = function_(_e854[5], _e859[5]);
                                        let _e865 = keys.member[_e486.member[2]];
                                        let _e867 = function_(_e861, _e865[5]);
                                        if (_e850[1] > _e867[1]) {
                                            phi_1476_ = true;
                                        } else {
                                            if (_e850[1] == _e867[1]) {
                                                phi_1475_ = (_e850[0] > _e867[0]);
                                            } else {
                                                phi_1475_ = false;
                                            }
                                            let _e878 = phi_1475_;
                                            phi_1476_ = _e878;
                                        }
                                        let _e880 = phi_1476_;
                                        let _e885 = keys.member[_e486.member[0]];
                                        let _e890 = keys.member[_e486.member[1]];
                                        let _e892 = function_1(_e885[2], _e890[2]);
                                        let _e896 = keys.member[_e486.member[2]];
                                        let _e898 = function_1(_e892, _e896[2]);
                                        let _e902 = keys.member[_e484.member[0]];
                                        let _e907 = keys.member[_e484.member[1]];
                                        let _e909 = function_(_e902[5], _e907[5]);
                                        let _e913 = keys.member[_e484.member[2]];
                                        let _e915 = function_(_e909, _e913[5]);
                                        if (_e898[1] > _e915[1]) {
                                            phi_1570_ = true;
                                        } else {
                                            if (_e898[1] == _e915[1]) {
                                                phi_1569_ = (_e898[0] > _e915[0]);
                                            } else {
                                                phi_1569_ = false;
                                            }
                                            let _e926 = phi_1569_;
                                            phi_1570_ = _e926;
                                        }
                                        let _e928 = phi_1570_;
                                        phi_1574_ = (((!(_e685) && !(_e733)) && (!(_e782) && !(_e830))) && (!(_e880) && !(_e928)));
                                    }
                                    let _e933 = phi_1574_;
                                    phi_1575_ = _e933;
                                    phi_1576_ = _e638;
                                } else {
                                    phi_1575_ = bool();
                                    phi_1576_ = true;
                                }
                                let _e935 = phi_1575_;
                                let _e937 = phi_1576_;
                                if _e937 {
                                    phi_1580_ = false;
                                } else {
                                    phi_1580_ = true;
                                }
                                let _e939 = phi_1580_;
                                phi_1581_ = _e935;
                                phi_1582_ = _e939;
                            } else {
                                phi_1581_ = false;
                                phi_1582_ = true;
                            }
                            let _e941 = phi_1581_;
                            let _e943 = phi_1582_;
                            phi_1583_ = _e941;
                            phi_1584_ = _e943;
                        } else {
                            phi_1583_ = false;
                            phi_1584_ = true;
                        }
                        let _e945 = phi_1583_;
                        let _e947 = phi_1584_;
                        if _e947 {
                            phi_1588_ = _e945;
                        } else {
                            phi_1588_ = true;
                        }
                        let _e949 = phi_1588_;
                        if _e949 {
                            let _e951 = params.member.member_16;
                            if (_e76[0] == _e76[1]) {
                                if (_e484.member_1 < _e486.member_1) {
                                    phi_1606_ = type_21(_e484.member_1, _e486.member_1);
                                } else {
                                    phi_1606_ = type_21(_e486.member_1, _e484.member_1);
                                }
                                let _e960 = phi_1606_;
                                phi_1611_ = _e960;
                            } else {
                                phi_1611_ = type_21(_e484.member_1, _e486.member_1);
                            }
                            let _e962 = phi_1611_;
                            let _e966 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e966 + 1u) < _e966) {
                                let _e970 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e966 < _e951) {
                                atomicStore((&output.member[(4u + (2u * _e966))]), _e962.member);
                                atomicStore((&output.member[((2u * _e966) + 5u)]), _e962.member_1);
                            }
                            let _e979 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e979 + 1u) < _e979) {
                                let _e983 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1651_ = (_e453 & (_e453 - 1u));
                        phi_1652_ = true;
                    }
                    let _e985 = phi_1651_;
                    let _e987 = phi_1652_;
                    phi_746_ = _e985;
                    phi_1653_ = _e987;
                } else {
                    phi_746_ = u32();
                    phi_1653_ = false;
                }
                let _e989 = phi_746_;
                let _e991 = phi_1653_;
                continue;
                continuing {
                    phi_742_ = _e465;
                    phi_745_ = _e989;
                    break if !(_e991);
                }
            }
            workgroupBarrier();
            let _e994 = atomicLoad((&counters[4u]));
            if (2048u < _e994) {
                phi_1660_ = 2048u;
            } else {
                phi_1660_ = _e994;
            }
            let _e997 = phi_1660_;
            phi_1663_ = type_21(0u, 16u);
            loop {
                let _e999 = phi_1663_;
                if (_e999.member < _e999.member_1) {
                    phi_1664_ = type_21((_e999.member + 1u), _e999.member_1);
                    phi_1687_ = type_21(1u, _e999.member);
                } else {
                    phi_1664_ = _e999;
                    phi_1687_ = type_21(0u, type_21().member_1);
                }
                let _e1011 = phi_1664_;
                let _e1013 = phi_1687_;
                if (bitcast<i32>(_e1013.member) != 0i) {
                    let _e1019 = (_e47 + (_e1013.member_1 * 128u));
                    if (_e1019 >= _e997) {
                        phi_2530_ = false;
                    } else {
                        let _e1022 = hits[_e1019];
                        let _e1025 = ((_e1022 >> bitcast<u32>(10i)) & 3u);
                        let _e1032 = firsts[(2u * _e1025)];
                        let _e1033 = (_e1032 + ((_e1022 >> bitcast<u32>(5i)) & 31u));
                        let _e1037 = firsts[((2u * _e1025) + 1u)];
                        let _e1038 = (_e1037 + (_e1022 & 31u));
                        let _e1040 = leaves.member[_e1033];
                        let _e1042 = leaves.member[_e1038];
                        let _e1044 = nodes.member[_e1033];
                        let _e1046 = nodes.member[_e1038];
                        let _e1048 = params.member.member_1;
                        if ((_e1048 & 1u) != 0u) {
                            let _e1052 = params.member.member_8;
                            if (_e1052 == 0u) {
                                if (_e1040.member[0] == _e1042.member[0]) {
                                    phi_1786_ = bool();
                                    phi_1787_ = true;
                                } else {
                                    let _e1095 = (_e1040.member[0] == _e1042.member[1]);
                                    if _e1095 {
                                        phi_1785_ = bool();
                                    } else {
                                        phi_1785_ = (_e1040.member[0] == _e1042.member[2]);
                                    }
                                    let _e1102 = phi_1785_;
                                    phi_1786_ = _e1102;
                                    phi_1787_ = _e1095;
                                }
                                let _e1104 = phi_1786_;
                                let _e1106 = phi_1787_;
                                if _e1106 {
                                    phi_1791_ = true;
                                } else {
                                    phi_1791_ = _e1104;
                                }
                                let _e1108 = phi_1791_;
                                phi_1822_ = _e1108;
                            } else {
                                if (_e1040.member[0] == _e1042.member[0]) {
                                    phi_1816_ = bool();
                                    phi_1817_ = true;
                                } else {
                                    if (_e1040.member[0] == _e1042.member[1]) {
                                        phi_1814_ = bool();
                                        phi_1815_ = true;
                                    } else {
                                        let _e1068 = (_e1040.member[1] == _e1042.member[0]);
                                        if _e1068 {
                                            phi_1813_ = bool();
                                        } else {
                                            phi_1813_ = (_e1040.member[1] == _e1042.member[1]);
                                        }
                                        let _e1075 = phi_1813_;
                                        phi_1814_ = _e1075;
                                        phi_1815_ = _e1068;
                                    }
                                    let _e1077 = phi_1814_;
                                    let _e1079 = phi_1815_;
                                    phi_1816_ = _e1077;
                                    phi_1817_ = _e1079;
                                }
                                let _e1081 = phi_1816_;
                                let _e1083 = phi_1817_;
                                if _e1083 {
                                    phi_1821_ = true;
                                } else {
                                    phi_1821_ = _e1081;
                                }
                                let _e1085 = phi_1821_;
                                phi_1822_ = _e1085;
                            }
                            let _e1110 = phi_1822_;
                            if _e1110 {
                                phi_1826_ = false;
                            } else {
                                phi_1826_ = true;
                            }
                            let _e1112 = phi_1826_;
                            phi_1827_ = _e1112;
                        } else {
                            phi_1827_ = true;
                        }
                        let _e1114 = phi_1827_;
                        if _e1114 {
                            let _e1116 = params.member.member_1;
                            if ((_e1116 & 2u) != 0u) {
                                let _e1122 = bodies.member[_e1040.member[0]];
                                let _e1126 = bodies.member[_e1042.member[0]];
                                if ((_e1122 / 2u) == (_e1126 / 2u)) {
                                    let _e1131 = params.member.member_1;
                                    phi_1871_ = !(((_e1131 & 4u) != 0u));
                                } else {
                                    phi_1871_ = false;
                                }
                                let _e1136 = phi_1871_;
                                if _e1136 {
                                    phi_1882_ = true;
                                } else {
                                    if (((_e1122 & _e1126) & 1u) == 0u) {
                                        phi_1881_ = false;
                                    } else {
                                        phi_1881_ = true;
                                    }
                                    let _e1141 = phi_1881_;
                                    phi_1882_ = _e1141;
                                }
                                let _e1143 = phi_1882_;
                                if _e1143 {
                                    phi_1886_ = false;
                                } else {
                                    phi_1886_ = true;
                                }
                                let _e1145 = phi_1886_;
                                phi_1887_ = _e1145;
                            } else {
                                phi_1887_ = true;
                            }
                            let _e1147 = phi_1887_;
                            if _e1147 {
                                let _e1149 = params.member.member_1;
                                if ((_e1149 & 32u) != 0u) {
                                    let _e1153 = params.member.member_6;
                                    let _e1194 = (((((((_e1044.member_1[0] - _e1046.member[0]) > _e1153) && ((_e1046.member_1[0] - _e1044.member[0]) > _e1153)) && ((_e1044.member_1[1] - _e1046.member[1]) > _e1153)) && ((_e1046.member_1[1] - _e1044.member[1]) > _e1153)) && ((_e1044.member_1[2] - _e1046.member[2]) > _e1153)) && ((_e1046.member_1[2] - _e1044.member[2]) > _e1153));
                                    if _e1194 {
                                        phi_2501_ = bool();
                                    } else {
                                        let _e1198 = keys.member[_e1040.member[0]];
                                        let _e1203 = keys.member[_e1040.member[1]];
                                        let _e1205 = function_5(_e1198[0], _e1203[0]);
                                        let _e1209 = keys.member[_e1040.member[2]];
                                        let _e1211 = function_5(_e1205, _e1209[0]);
                                        let _e1215 = keys.member[_e1042.member[0]];
                                        let _e1220 = keys.member[_e1042.member[1]];
                                        let _e1222 = function_4(_e1215[3], _e1220[3]);
                                        let _e1226 = keys.member[_e1042.member[2]];
                                        let _e1228 = function_4(_e1222, _e1226[3]);
                                        if (_e1211[1] > _e1228[1]) {
                                            phi_2024_ = true;
                                        } else {
                                            if (_e1211[1] == _e1228[1]) {
                                                phi_2023_ = (_e1211[0] > _e1228[0]);
                                            } else {
                                                phi_2023_ = false;
                                            }
                                            let _e1239 = phi_2023_;
                                            phi_2024_ = _e1239;
                                        }
                                        let _e1241 = phi_2024_;
                                        let _e1246 = keys.member[_e1042.member[0]];
                                        let _e1251 = keys.member[_e1042.member[1]];
                                        let _e1253 = function_5(_e1246[0], _e1251[0]);
                                        let _e1257 = keys.member[_e1042.member[2]];
                                        let _e1259 = function_5(_e1253, _e1257[0]);
                                        let _e1263 = keys.member[_e1040.member[0]];
                                        let _e1268 = keys.member[_e1040.member[1]];
                                        let _e1270 = function_4(_e1263[3], _e1268[3]);
                                        let _e1274 = keys.member[_e1040.member[2]];
                                        let _e1276 = function_4(_e1270, _e1274[3]);
                                        if (_e1259[1] > _e1276[1]) {
                                            phi_2118_ = true;
                                        } else {
                                            if (_e1259[1] == _e1276[1]) {
                                                phi_2117_ = (_e1259[0] > _e1276[0]);
                                            } else {
                                                phi_2117_ = false;
                                            }
                                            let _e1287 = phi_2117_;
                                            phi_2118_ = _e1287;
                                        }
                                        let _e1289 = phi_2118_;
                                        let _e1295 = keys.member[_e1040.member[0]];
                                        let _e1300 = keys.member[_e1040.member[1]];
                                        let _e1302 = function_3(_e1295[1], _e1300[1]);
                                        let _e1306 = keys.member[_e1040.member[2]];
                                        let _e1308 = function_3(_e1302, _e1306[1]);
                                        let _e1312 = keys.member[_e1042.member[0]];
                                        let _e1317 = keys.member[_e1042.member[1]];
                                        let _e1319 = function_2(_e1312[4], _e1317[4]);
                                        let _e1323 = keys.member[_e1042.member[2]];
                                        let _e1325 = function_2(_e1319, _e1323[4]);
                                        if (_e1308[1] > _e1325[1]) {
                                            phi_2213_ = true;
                                        } else {
                                            if (_e1308[1] == _e1325[1]) {
                                                phi_2212_ = (_e1308[0] > _e1325[0]);
                                            } else {
                                                phi_2212_ = false;
                                            }
                                            let _e1336 = phi_2212_;
                                            phi_2213_ = _e1336;
                                        }
                                        let _e1338 = phi_2213_;
                                        let _e1343 = keys.member[_e1042.member[0]];
                                        let _e1348 = keys.member[_e1042.member[1]];
                                        let _e1350 = function_3(_e1343[1], _e1348[1]);
                                        let _e1354 = keys.member[_e1042.member[2]];
                                        let _e1356 = function_3(_e1350, _e1354[1]);
                                        let _e1360 = keys.member[_e1040.member[0]];
                                        let _e1365 = keys.member[_e1040.member[1]];
                                        let _e1367 = function_2(_e1360[4], _e1365[4]);
                                        let _e1371 = keys.member[_e1040.member[2]];
                                        let _e1373 = function_2(_e1367, _e1371[4]);
                                        if (_e1356[1] > _e1373[1]) {
                                            phi_2307_ = true;
                                        } else {
                                            if (_e1356[1] == _e1373[1]) {
                                                phi_2306_ = (_e1356[0] > _e1373[0]);
                                            } else {
                                                phi_2306_ = false;
                                            }
                                            let _e1384 = phi_2306_;
                                            phi_2307_ = _e1384;
                                        }
                                        let _e1386 = phi_2307_;
                                        let _e1393 = keys.member[_e1040.member[0]];
                                        let _e1398 = keys.member[_e1040.member[1]];
                                        let _e1400 = function_1(_e1393[2], _e1398[2]);
                                        let _e1404 = keys.member[_e1040.member[2]];
                                        let _e1406 = function_1(_e1400, _e1404[2]);
                                        let _e1410 = keys.member[_e1042.member[0]];
                                        let _e1415 = keys.member[_e1042.member[1]];
                                        let _e1417 = function_(_e1410[5], _e1415[5]);
                                        let _e1421 = keys.member[_e1042.member[2]];
                                        let _e1423 = function_(_e1417, _e1421[5]);
                                        if (_e1406[1] > _e1423[1]) {
                                            phi_2403_ = true;
                                        } else {
                                            if (_e1406[1] == _e1423[1]) {
                                                phi_2402_ = (_e1406[0] > _e1423[0]);
                                            } else {
                                                phi_2402_ = false;
                                            }
                                            let _e1434 = phi_2402_;
                                            phi_2403_ = _e1434;
                                        }
                                        let _e1436 = phi_2403_;
                                        let _e1441 = keys.member[_e1042.member[0]];
                                        let _e1446 = keys.member[_e1042.member[1]];
                                        let _e1448 = function_1(_e1441[2], _e1446[2]);
                                        let _e1452 = keys.member[_e1042.member[2]];
                                        let _e1454 = function_1(_e1448, _e1452[2]);
                                        let _e1458 = keys.member[_e1040.member[0]];
                                        let _e1463 = keys.member[_e1040.member[1]];
                                        let _e1465 = function_(_e1458[5], _e1463[5]);
                                        let _e1469 = keys.member[_e1040.member[2]];
                                        let _e1471 = function_(_e1465, _e1469[5]);
                                        if (_e1454[1] > _e1471[1]) {
                                            phi_2497_ = true;
                                        } else {
                                            if (_e1454[1] == _e1471[1]) {
                                                phi_2496_ = (_e1454[0] > _e1471[0]);
                                            } else {
                                                phi_2496_ = false;
                                            }
                                            let _e1482 = phi_2496_;
                                            phi_2497_ = _e1482;
                                        }
                                        let _e1484 = phi_2497_;
                                        phi_2501_ = (((!(_e1241) && !(_e1289)) && (!(_e1338) && !(_e1386))) && (!(_e1436) && !(_e1484)));
                                    }
                                    let _e1489 = phi_2501_;
                                    phi_2502_ = _e1489;
                                    phi_2503_ = _e1194;
                                } else {
                                    phi_2502_ = bool();
                                    phi_2503_ = true;
                                }
                                let _e1491 = phi_2502_;
                                let _e1493 = phi_2503_;
                                if _e1493 {
                                    phi_2507_ = false;
                                } else {
                                    phi_2507_ = true;
                                }
                                let _e1495 = phi_2507_;
                                phi_2508_ = _e1491;
                                phi_2509_ = _e1495;
                            } else {
                                phi_2508_ = false;
                                phi_2509_ = true;
                            }
                            let _e1497 = phi_2508_;
                            let _e1499 = phi_2509_;
                            phi_2510_ = _e1497;
                            phi_2511_ = _e1499;
                        } else {
                            phi_2510_ = false;
                            phi_2511_ = true;
                        }
                        let _e1501 = phi_2510_;
                        let _e1503 = phi_2511_;
                        if _e1503 {
                            phi_2515_ = _e1501;
                        } else {
                            phi_2515_ = true;
                        }
                        let _e1505 = phi_2515_;
                        if _e1505 {
                            let _e1507 = atomicAdd((&counters[7u]), 1u);
                            let _e1509 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1019] = ((2147483648u | (_e1509 << bitcast<u32>(12i))) | _e1022);
                        }
                        phi_2530_ = true;
                    }
                    let _e1516 = phi_2530_;
                    phi_2531_ = _e1516;
                } else {
                    phi_2531_ = false;
                }
                let _e1518 = phi_2531_;
                continue;
                continuing {
                    phi_1663_ = _e1011;
                    break if !(_e1518);
                }
            }
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e1522 = atomicLoad((&counters[5u]));
                if (_e1522 > 0u) {
                    let _e1525 = atomicAdd((&output.member[0u]), _e1522);
                    if ((_e1525 + _e1522) < _e1525) {
                        let _e1529 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1525);
                }
            }
            workgroupBarrier();
            let _e1532 = atomicLoad((&counters[6u]));
            if (_e47 == 0u) {
                let _e1535 = atomicLoad((&counters[7u]));
                if (_e1535 > 0u) {
                    let _e1538 = atomicAdd((&output.member[1u]), _e1535);
                    if ((_e1538 + _e1535) < _e1538) {
                        let _e1542 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2581_ = type_21(0u, 16u);
            loop {
                let _e1544 = phi_2581_;
                if (_e1544.member < _e1544.member_1) {
                    phi_2582_ = type_21((_e1544.member + 1u), _e1544.member_1);
                    phi_2605_ = type_21(1u, _e1544.member);
                } else {
                    phi_2582_ = _e1544;
                    phi_2605_ = type_21(0u, type_21().member_1);
                }
                let _e1556 = phi_2582_;
                let _e1558 = phi_2605_;
                if (bitcast<i32>(_e1558.member) != 0i) {
                    let _e1564 = (_e47 + (_e1558.member_1 * 128u));
                    if (_e1564 >= _e997) {
                        phi_2703_ = false;
                    } else {
                        let _e1567 = hits[_e1564];
                        if ((_e1567 & 2147483648u) == 0u) {
                            phi_2628_ = 4294967295u;
                        } else {
                            phi_2628_ = ((_e1567 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1574 = phi_2628_;
                        if (_e1574 != 4294967295u) {
                            let _e1578 = ((_e1567 >> bitcast<u32>(10i)) & 3u);
                            let _e1585 = firsts[(2u * _e1578)];
                            let _e1588 = leaves.member[(_e1585 + ((_e1567 >> bitcast<u32>(5i)) & 31u))];
                            let _e1592 = firsts[((2u * _e1578) + 1u)];
                            let _e1595 = leaves.member[(_e1592 + (_e1567 & 31u))];
                            let _e1599 = params.member.member_16;
                            let _e1600 = (_e1532 + _e1574);
                            if (_e76[0] == _e76[1]) {
                                if (_e1588.member_1 < _e1595.member_1) {
                                    phi_2682_ = type_21(_e1588.member_1, _e1595.member_1);
                                } else {
                                    phi_2682_ = type_21(_e1595.member_1, _e1588.member_1);
                                }
                                let _e1607 = phi_2682_;
                                phi_2687_ = _e1607;
                            } else {
                                phi_2687_ = type_21(_e1588.member_1, _e1595.member_1);
                            }
                            let _e1609 = phi_2687_;
                            if (_e1600 < _e1599) {
                                atomicStore((&output.member[(4u + (2u * _e1600))]), _e1609.member);
                                atomicStore((&output.member[((2u * _e1600) + 5u)]), _e1609.member_1);
                            }
                        }
                        phi_2703_ = true;
                    }
                    let _e1620 = phi_2703_;
                    phi_2704_ = _e1620;
                } else {
                    phi_2704_ = false;
                }
                let _e1622 = phi_2704_;
                continue;
                continuing {
                    phi_2581_ = _e1556;
                    break if !(_e1622);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_250_ = _e134;
            break if !(_e140);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
