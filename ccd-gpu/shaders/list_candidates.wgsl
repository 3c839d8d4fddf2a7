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

struct type_19 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_31 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_35 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> leaves: type_21;
@group(0) @binding(1) 
var<storage> nodes: type_25;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_23, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_31;
@group(0) @binding(5) 
var<storage> input: type_11;
@group(0) @binding(6) 
var<storage, read_write> output: type_35;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_2836_: bool;
    var phi_2837_: bool;
    var phi_2841_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2837_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2836_ = (param_1[0] > param[0]);
        } else {
            phi_2836_ = false;
        }
        let _e14 = phi_2836_;
        phi_2837_ = _e14;
    }
    let _e16 = phi_2837_;
    if _e16 {
        phi_2841_ = param_1;
    } else {
        phi_2841_ = param;
    }
    let _e18 = phi_2841_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2812_: bool;
    var phi_2813_: bool;
    var phi_2817_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2813_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2812_ = (param_2[0] > param_3[0]);
        } else {
            phi_2812_ = false;
        }
        let _e14 = phi_2812_;
        phi_2813_ = _e14;
    }
    let _e16 = phi_2813_;
    if _e16 {
        phi_2817_ = param_3;
    } else {
        phi_2817_ = param_2;
    }
    let _e18 = phi_2817_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2793_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2789_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2788_ = (param_5[0] > param_4[0]);
        } else {
            phi_2788_ = false;
        }
        let _e14 = phi_2788_;
        phi_2789_ = _e14;
    }
    let _e16 = phi_2789_;
    if _e16 {
        phi_2793_ = param_5;
    } else {
        phi_2793_ = param_4;
    }
    let _e18 = phi_2793_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2764_: bool;
    var phi_2765_: bool;
    var phi_2769_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2765_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2764_ = (param_6[0] > param_7[0]);
        } else {
            phi_2764_ = false;
        }
        let _e14 = phi_2764_;
        phi_2765_ = _e14;
    }
    let _e16 = phi_2765_;
    if _e16 {
        phi_2769_ = param_7;
    } else {
        phi_2769_ = param_6;
    }
    let _e18 = phi_2769_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2745_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2741_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2740_ = (param_9[0] > param_8[0]);
        } else {
            phi_2740_ = false;
        }
        let _e14 = phi_2740_;
        phi_2741_ = _e14;
    }
    let _e16 = phi_2741_;
    if _e16 {
        phi_2745_ = param_9;
    } else {
        phi_2745_ = param_8;
    }
    let _e18 = phi_2745_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2716_: bool;
    var phi_2717_: bool;
    var phi_2721_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2717_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2716_ = (param_10[0] > param_11[0]);
        } else {
            phi_2716_ = false;
        }
        let _e14 = phi_2716_;
        phi_2717_ = _e14;
    }
    let _e16 = phi_2717_;
    if _e16 {
        phi_2721_ = param_11;
    } else {
        phi_2721_ = param_10;
    }
    let _e18 = phi_2721_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_163_: u32;
    var phi_175_: array<u32, 2>;
    var phi_207_: u32;
    var phi_208_: u32;
    var phi_216_: u32;
    var phi_232_: u32;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_257_: type_9;
    var phi_258_: type_9;
    var phi_281_: type_9;
    var phi_322_: u32;
    var phi_323_: u32;
    var phi_331_: u32;
    var phi_343_: u32;
    var phi_428_: array<u32, 2>;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_631_: type_23;
    var phi_637_: bool;
    var phi_644_: type_9;
    var phi_647_: u32;
    var phi_645_: type_9;
    var phi_670_: type_9;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_742_: bool;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_762_: u32;
    var phi_648_: u32;
    var phi_765_: type_9;
    var phi_768_: u32;
    var phi_766_: type_9;
    var phi_791_: type_9;
    var phi_899_: bool;
    var phi_905_: bool;
    var phi_873_: bool;
    var phi_880_: bool;
    var phi_888_: bool;
    var phi_907_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_958_: bool;
    var phi_965_: bool;
    var phi_969_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1585_: bool;
    var phi_1589_: bool;
    var phi_1590_: bool;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1593_: bool;
    var phi_1597_: bool;
    var phi_1616_: type_9;
    var phi_1621_: type_9;
    var phi_1659_: u32;
    var phi_1660_: bool;
    var phi_769_: u32;
    var phi_1661_: bool;
    var phi_1668_: u32;
    var phi_1671_: type_9;
    var phi_1672_: type_9;
    var phi_1695_: type_9;
    var phi_1811_: bool;
    var phi_1817_: bool;
    var phi_1785_: bool;
    var phi_1792_: bool;
    var phi_1800_: bool;
    var phi_1819_: bool;
    var phi_1823_: bool;
    var phi_1824_: bool;
    var phi_1870_: bool;
    var phi_1877_: bool;
    var phi_1881_: bool;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2111_: bool;
    var phi_2112_: bool;
    var phi_2206_: bool;
    var phi_2207_: bool;
    var phi_2300_: bool;
    var phi_2301_: bool;
    var phi_2396_: bool;
    var phi_2397_: bool;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2509_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2575_: type_9;
    var phi_2576_: type_9;
    var phi_2599_: type_9;
    var phi_2622_: u32;
    var phi_2677_: type_9;
    var phi_2682_: type_9;
    var phi_2696_: bool;
    var phi_2697_: bool;
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
    let _e65 = params.member.member_1.member_2;
    let _e67 = input.member[0u];
    if (_e65 < _e67) {
        phi_163_ = _e65;
    } else {
        phi_163_ = _e67;
    }
    let _e70 = phi_163_;
    let _e71 = (_e47 / 32u);
    let _e72 = (_e47 % 32u);
    let _e75 = params.member.member_2.member_1;
    if (_e75 == 0u) {
        phi_175_ = array<u32, 2>(0u, 2u);
    } else {
        phi_175_ = array<u32, 2>(1u, 1u);
    }
    let _e78 = phi_175_;
    let _e83 = params.member.member_1.member_1;
    if (_e70 > _e83) {
        let _e87 = params.member.member_1.member_1;
        let _e88 = (_e70 - _e87);
        let _e91 = params.member.member_2.member_3;
        if (_e91 == 0u) {
            return;
        }
        let _e93 = (_e88 / _e91);
        if (_e91 == 0u) {
            return;
        }
        if ((_e88 % _e91) > 0u) {
            phi_207_ = (_e93 + 1u);
        } else {
            phi_207_ = _e93;
        }
        let _e99 = phi_207_;
        phi_208_ = _e99;
    } else {
        phi_208_ = 0u;
    }
    let _e101 = phi_208_;
    let _e104 = params.member.member_2.member_4;
    if (_e104 < _e101) {
        phi_216_ = _e104;
    } else {
        phi_216_ = _e101;
    }
    let _e107 = phi_216_;
    let _e108 = (_e107 / 4u);
    if ((_e107 % 4u) > 0u) {
        phi_232_ = (_e108 + 1u);
    } else {
        phi_232_ = _e108;
    }
    let _e113 = phi_232_;
    if (_e113 > _e59) {
        let _e115 = (_e113 - _e59);
        if (_e62 == 0u) {
            return;
        }
        let _e117 = (_e115 / _e62);
        if (_e62 == 0u) {
            return;
        }
        if ((_e115 % _e62) > 0u) {
            phi_253_ = (_e117 + 1u);
        } else {
            phi_253_ = _e117;
        }
        let _e123 = phi_253_;
        phi_254_ = _e123;
    } else {
        phi_254_ = 0u;
    }
    let _e125 = phi_254_;
    phi_257_ = type_9(0u, _e125);
    loop {
        let _e128 = phi_257_;
        if (_e128.member < _e128.member_1) {
            phi_258_ = type_9((_e128.member + 1u), _e128.member_1);
            phi_281_ = type_9(1u, _e128.member);
        } else {
            phi_258_ = _e128;
            phi_281_ = type_9(0u, type_9().member_1);
        }
        let _e140 = phi_258_;
        let _e142 = phi_281_;
        let _e146 = (bitcast<i32>(_e142.member) != 0i);
        if _e146 {
            let _e150 = (((_e59 + (_e142.member_1 * _e62)) * 4u) + _e71);
            let _e153 = params.member.member_1.member_1;
            if (_e70 > _e153) {
                let _e157 = params.member.member_1.member_1;
                let _e158 = (_e70 - _e157);
                let _e161 = params.member.member_2.member_3;
                if (_e161 == 0u) {
                    return;
                }
                let _e163 = (_e158 / _e161);
                if (_e161 == 0u) {
                    return;
                }
                if ((_e158 % _e161) > 0u) {
                    phi_322_ = (_e163 + 1u);
                } else {
                    phi_322_ = _e163;
                }
                let _e169 = phi_322_;
                phi_323_ = _e169;
            } else {
                phi_323_ = 0u;
            }
            let _e171 = phi_323_;
            let _e174 = params.member.member_2.member_4;
            if (_e174 < _e171) {
                phi_331_ = _e174;
            } else {
                phi_331_ = _e171;
            }
            let _e177 = phi_331_;
            let _e178 = (_e150 < _e177);
            let _e181 = params.member.member_1.member_1;
            if _e178 {
                let _e184 = params.member.member_2.member_3;
                phi_343_ = (_e150 * _e184);
            } else {
                phi_343_ = 0u;
            }
            let _e187 = phi_343_;
            let _e189 = (2u * (_e181 + _e187));
            let _e192 = input.member[(4u + _e189)];
            let _e195 = input.member[(_e189 + 5u)];
            if (_e47 < 8u) {
                atomicStore((&counters[_e47]), 0u);
            }
            workgroupBarrier();
            let _e203 = params.member.member_2.member[0u][_e78[0]];
            let _e204 = (_e203 + (_e192 * 32u));
            let _e210 = params.member.member_2.member[0u][_e78[1]];
            let _e211 = (_e210 + (_e195 * 32u));
            if (_e72 == 0u) {
                firsts[(2u * _e71)] = _e204;
                firsts[((2u * _e71) + 1u)] = _e211;
            }
            let _e220 = params.member.member_2.member_1;
            if (_e220 == 0u) {
                phi_428_ = array<u32, 2>(0u, 2u);
            } else {
                phi_428_ = array<u32, 2>(1u, 1u);
            }
            let _e223 = phi_428_;
            let _e226 = (_e47 / 32u);
            let _e227 = (_e47 % 32u);
            let _e231 = params.member.member_2.member_2;
            let _e235 = params.member.member_2.member[_e231][_e223[0]];
            let _e238 = nodes.member[(_e235 + _e192)];
            let _e242 = params.member.member_2.member_2;
            let _e246 = params.member.member_2.member[_e242][_e223[1]];
            let _e249 = nodes.member[(_e246 + _e195)];
            let _e253 = params.member.member_2.member_2;
            let _e260 = params.member.member_2.member[(_e253 - 1u)][_e223[0]];
            let _e263 = nodes.member[(_e260 + ((_e192 * 32u) + _e227))];
            let _e267 = params.member.member_2.member_2;
            let _e274 = params.member.member_2.member[(_e267 - 1u)][_e223[1]];
            let _e277 = nodes.member[(_e274 + ((_e195 * 32u) + _e227))];
            if _e178 {
                if ((((((_e277.member[0] <= _e238.member_1[0]) && (_e238.member[0] <= _e277.member_1[0])) && (_e277.member[1] <= _e238.member_1[1])) && (_e238.member[1] <= _e277.member_1[1])) && (_e277.member[2] <= _e238.member_1[2])) && (_e238.member[2] <= _e277.member_1[2])) {
                    let _e315 = atomicAdd((&counters[_e226]), 1u);
                    let _e316 = ((_e226 * 32u) + _e315);
                    columns[_e316] = type_23(array<f32, 3>(_e277.member[0], _e277.member[1], _e277.member[2]), array<f32, 3>(_e277.member_1[0], _e277.member_1[1], _e277.member_1[2]));
                    names[_e316] = _e227;
                }
            }
            workgroupBarrier();
            if _e178 {
                if ((((((_e263.member[0] <= _e249.member_1[0]) && (_e249.member[0] <= _e263.member_1[0])) && (_e263.member[1] <= _e249.member_1[1])) && (_e249.member[1] <= _e263.member_1[1])) && (_e263.member[2] <= _e249.member_1[2])) && (_e249.member[2] <= _e263.member_1[2])) {
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
                phi_631_ = type_23(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_631_ = _e263;
            }
            let _e370 = phi_631_;
            if (_e78[0] == _e78[1]) {
                phi_637_ = (_e192 == _e195);
            } else {
                phi_637_ = false;
            }
            let _e374 = phi_637_;
            let _e375 = (_e47 / 32u);
            let _e376 = (_e47 % 32u);
            let _e378 = atomicLoad((&counters[_e375]));
            phi_644_ = type_9(0u, _e378);
            phi_647_ = 0u;
            loop {
                let _e381 = phi_644_;
                let _e383 = phi_647_;
                local = _e383;
                if (_e381.member < _e381.member_1) {
                    phi_645_ = type_9((_e381.member + 1u), _e381.member_1);
                    phi_670_ = type_9(1u, _e381.member);
                } else {
                    phi_645_ = _e381;
                    phi_670_ = type_9(0u, type_9().member_1);
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
            phi_765_ = type_9(0u, 32u);
            let _e1635 = local;
            phi_768_ = _e1635;
            loop {
                let _e474 = phi_765_;
                let _e476 = phi_768_;
                if (_e474.member < _e474.member_1) {
                    phi_766_ = type_9((_e474.member + 1u), _e474.member_1);
                    phi_791_ = type_9(1u, _e474.member);
                } else {
                    phi_766_ = _e474;
                    phi_791_ = type_9(0u, type_9().member_1);
                }
                let _e488 = phi_766_;
                let _e490 = phi_791_;
                if (bitcast<i32>(_e490.member) != 0i) {
                    if (_e476 == 0u) {
                        phi_1659_ = u32();
                        phi_1660_ = false;
                    } else {
                        let _e501 = names[((_e71 * 32u) + select(firstTrailingBit(_e476), 32u, (_e476 == 0u)))];
                        let _e504 = (_e204 + _e72);
                        let _e505 = (_e211 + _e501);
                        let _e507 = leaves.member[_e504];
                        let _e509 = leaves.member[_e505];
                        let _e511 = nodes.member[_e504];
                        let _e513 = nodes.member[_e505];
                        let _e516 = params.member.member.member_1;
                        if ((_e516 & 1u) != 0u) {
                            if (_e75 == 0u) {
                                if (_e509.member[0] == _e507.member[0]) {
                                    phi_873_ = true;
                                } else {
                                    phi_873_ = (_e509.member[0] == _e507.member[0]);
                                }
                                let _e544 = phi_873_;
                                if (_e509.member[1] == _e507.member[0]) {
                                    phi_880_ = true;
                                } else {
                                    phi_880_ = (_e509.member[1] == _e507.member[0]);
                                }
                                let _e549 = phi_880_;
                                if (_e509.member[2] == _e507.member[0]) {
                                    phi_888_ = true;
                                } else {
                                    phi_888_ = (_e509.member[2] == _e507.member[0]);
                                }
                                let _e555 = phi_888_;
                                phi_907_ = ((_e544 || _e549) || _e555);
                            } else {
                                if (_e509.member[0] == _e507.member[0]) {
                                    phi_899_ = true;
                                } else {
                                    phi_899_ = (_e509.member[0] == _e507.member[1]);
                                }
                                let _e531 = phi_899_;
                                if (_e509.member[1] == _e507.member[0]) {
                                    phi_905_ = true;
                                } else {
                                    phi_905_ = (_e509.member[1] == _e507.member[1]);
                                }
                                let _e535 = phi_905_;
                                phi_907_ = (_e531 || _e535);
                            }
                            let _e558 = phi_907_;
                            if _e558 {
                                phi_911_ = false;
                            } else {
                                phi_911_ = true;
                            }
                            let _e560 = phi_911_;
                            phi_912_ = _e560;
                        } else {
                            phi_912_ = true;
                        }
                        let _e562 = phi_912_;
                        if _e562 {
                            let _e564 = params.member.member.member_1;
                            if ((_e564 & 2u) != 0u) {
                                let _e568 = params.member.member.member_1;
                                let _e574 = bodies.member[_e507.member[0]];
                                let _e578 = bodies.member[_e509.member[0]];
                                if ((_e574 / 2u) != (_e578 / 2u)) {
                                    phi_958_ = true;
                                } else {
                                    phi_958_ = ((_e568 & 4u) != 0u);
                                }
                                let _e583 = phi_958_;
                                if _e583 {
                                    phi_965_ = (((_e574 & _e578) & 1u) == 0u);
                                } else {
                                    phi_965_ = false;
                                }
                                let _e588 = phi_965_;
                                phi_969_ = _e588;
                            } else {
                                phi_969_ = true;
                            }
                            let _e590 = phi_969_;
                            if _e590 {
                                let _e592 = params.member.member.member_1;
                                if ((_e592 & 32u) != 0u) {
                                    let _e596 = params.member.member.member_6;
                                    let _e637 = (((((_e511.member_1[0] - _e513.member[0]) > _e596) && ((_e513.member_1[0] - _e511.member[0]) > _e596)) && (((_e511.member_1[1] - _e513.member[1]) > _e596) && ((_e513.member_1[1] - _e511.member[1]) > _e596))) && (((_e511.member_1[2] - _e513.member[2]) > _e596) && ((_e513.member_1[2] - _e511.member[2]) > _e596)));
                                    if _e637 {
                                        phi_1583_ = bool();
                                    } else {
                                        let _e641 = keys.member[_e507.member[0]];
                                        let _e646 = keys.member[_e507.member[1]];
                                        let _e648 = function_5(_e641[0], _e646[0]);
                                        let _e652 = keys.member[_e507.member[2]];
                                        let _e654 = function_5(_e648, _e652[0]);
                                        let _e658 = keys.member[_e509.member[0]];
                                        let _e663 = keys.member[_e509.member[1]];
                                        let _e665 = function_4(_e658[3], _e663[3]);
                                        let _e669 = keys.member[_e509.member[2]];
                                        let _e671 = function_4(_e665, _e669[3]);
                                        if (_e654[1] > _e671[1]) {
                                            phi_1106_ = true;
                                        } else {
                                            if (_e654[1] == _e671[1]) {
                                                phi_1105_ = (_e654[0] > _e671[0]);
                                            } else {
                                                phi_1105_ = false;
                                            }
                                            let _e682 = phi_1105_;
                                            phi_1106_ = _e682;
                                        }
                                        let _e684 = phi_1106_;
                                        let _e689 = keys.member[_e509.member[0]];
                                        let _e694 = keys.member[_e509.member[1]];
                                        let _e696 = function_5(_e689[0], _e694[0]);
                                        let _e700 = keys.member[_e509.member[2]];
                                        let _e702 = function_5(_e696, _e700[0]);
                                        let _e706 = keys.member[_e507.member[0]];
                                        let _e711 = keys.member[_e507.member[1]];
                                        let _e713 = function_4(_e706[3], _e711[3]);
                                        let _e717 = keys.member[_e507.member[2]];
                                        let _e719 = function_4(_e713, _e717[3]);
                                        if (_e702[1] > _e719[1]) {
                                            phi_1200_ = true;
                                        } else {
                                            if (_e702[1] == _e719[1]) {
                                                phi_1199_ = (_e702[0] > _e719[0]);
                                            } else {
                                                phi_1199_ = false;
                                            }
                                            let _e730 = phi_1199_;
                                            phi_1200_ = _e730;
                                        }
                                        let _e732 = phi_1200_;
                                        let _e738 = keys.member[_e507.member[0]];
                                        let _e743 = keys.member[_e507.member[1]];
                                        let _e745 = function_3(_e738[1], _e743[1]);
                                        let _e749 = keys.member[_e507.member[2]];
                                        let _e751 = function_3(_e745, _e749[1]);
                                        let _e755 = keys.member[_e509.member[0]];
                                        let _e760 = keys.member[_e509.member[1]];
                                        let _e762 = function_2(_e755[4], _e760[4]);
                                        let _e766 = keys.member[_e509.member[2]];
                                        let _e768 = function_2(_e762, _e766[4]);
                                        if (_e751[1] > _e768[1]) {
                                            phi_1295_ = true;
                                        } else {
                                            if (_e751[1] == _e768[1]) {
                                                phi_1294_ = (_e751[0] > _e768[0]);
                                            } else {
                                                phi_1294_ = false;
                                            }
                                            let _e779 = phi_1294_;
                                            phi_1295_ = _e779;
                                        }
                                        let _e781 = phi_1295_;
                                        let _e786 = keys.member[_e509.member[0]];
                                        let _e791 = keys.member[_e509.member[1]];
                                        let _e793 = function_3(_e786[1], _e791[1]);
                                        let _e797 = keys.member[_e509.member[2]];
                                        let _e799 = function_3(_e793, _e797[1]);
                                        let _e803 = keys.member[_e507.member[0]];
                                        let _e808 = keys.member[_e507.member[1]];
                                        let _e810 = function_2(_e803[4], _e808[4]);
                                        let _e814 = keys.member[_e507.member[2]];
                                        let _e816 = function_2(_e810, _e814[4]);
                                        if (_e799[1] > _e816[1]) {
                                            phi_1389_ = true;
                                        } else {
                                            if (_e799[1] == _e816[1]) {
                                                phi_1388_ = (_e799[0] > _e816[0]);
                                            } else {
                                                phi_1388_ = false;
                                            }
                                            let _e827 = phi_1388_;
                                            phi_1389_ = _e827;
                                        }
                                        let _e829 = phi_1389_;
                                        let _e836 = keys.member[_e507.member[0]];
                                        let _e841 = keys.member[_e507.member[1]];
                                        let _e843 = function_1(_e836[2], _e841[2]);
                                        let _e847 = keys.member[_e507.member[2]];
                                        let _e849 = function_1(_e843, _e847[2]);
                                        let _e853 = keys.member[_e509.member[0]];
                                        let _e858 = keys.member[_e509.member[1]];
                                        let _e860 = function_(_e853[5], _e858[5]);
                                        let _e864 = keys.member[_e509.member[2]];
                                        let _e866 = function_(_e860, _e864[5]);
                                        if (_e849[1] > _e866[1]) {
                                            phi_1485_ = true;
                                        } else {
                                            if (_e849[1] == _e866[1]) {
                                                phi_1484_ = (_e849[0] > _e866[0]);
                                            } else {
                                                phi_1484_ = false;
                                            }
                                            let _e877 = phi_1484_;
                                            phi_1485_ = _e877;
                                        }
                                        let _e879 = phi_1485_;
                                        let _e884 = keys.member[_e509.member[0]];
                                        let _e889 = keys.member[_e509.member[1]];
                                        let _e891 = function_1(_e884[2], _e889[2]);
                                        let _e895 = keys.member[_e509.member[2]];
                                        let _e897 = function_1(_e891, _e895[2]);
                                        let _e901 = keys.member[_e507.member[0]];
                                        let _e906 = keys.member[_e507.member[1]];
                                        let _e908 = function_(_e901[5], _e906[5]);
                                        let _e912 = keys.member[_e507.member[2]];
                                        let _e914 = function_(_e908, _e912[5]);
                                        if (_e897[1] > _e914[1]) {
                                            phi_1579_ = true;
                                        } else {
                                            if (_e897[1] == _e914[1]) {
                                                phi_1578_ = (_e897[0] > _e914[0]);
                                            } else {
                                                phi_1578_ = false;
                                            }
                                            let _e925 = phi_1578_;
                                            phi_1579_ = _e925;
                                        }
                                        let _e927 = phi_1579_;
                                        phi_1583_ = (((!(_e684) && !(_e732)) && (!(_e781) && !(_e829))) && (!(_e879) && !(_e927)));
                                    }
                                    let _e932 = phi_1583_;
                                    phi_1584_ = _e932;
                                    phi_1585_ = _e637;
                                } else {
                                    phi_1584_ = bool();
                                    phi_1585_ = true;
                                }
                                let _e934 = phi_1584_;
                                let _e936 = phi_1585_;
                                if _e936 {
                                    phi_1589_ = false;
                                } else {
                                    phi_1589_ = true;
                                }
                                let _e938 = phi_1589_;
                                phi_1590_ = _e934;
                                phi_1591_ = _e938;
                            } else {
                                phi_1590_ = false;
                                phi_1591_ = true;
                            }
                            let _e940 = phi_1590_;
                            let _e942 = phi_1591_;
                            phi_1592_ = _e940;
                            phi_1593_ = _e942;
                        } else {
                            phi_1592_ = false;
                            phi_1593_ = true;
                        }
                        let _e944 = phi_1592_;
                        let _e946 = phi_1593_;
                        if _e946 {
                            phi_1597_ = _e944;
                        } else {
                            phi_1597_ = true;
                        }
                        let _e948 = phi_1597_;
                        if _e948 {
                            let _e951 = params.member.member_1.member_3;
                            if (_e78[0] == _e78[1]) {
                                if (_e507.member_1 < _e509.member_1) {
                                    phi_1616_ = type_9(_e507.member_1, _e509.member_1);
                                } else {
                                    phi_1616_ = type_9(_e509.member_1, _e507.member_1);
                                }
                                let _e960 = phi_1616_;
                                phi_1621_ = _e960;
                            } else {
                                phi_1621_ = type_9(_e507.member_1, _e509.member_1);
                            }
                            let _e962 = phi_1621_;
                            let _e966 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e966 + 1u) < _e966) {
                                let _e970 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e966 < _e951) {
                                let _e972 = (2u * _e966);
                                atomicStore((&output.member[(4u + _e972)]), _e962.member);
                                atomicStore((&output.member[(_e972 + 5u)]), _e962.member_1);
                            }
                            let _e978 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e978 + 1u) < _e978) {
                                let _e982 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1659_ = (_e476 & (_e476 - 1u));
                        phi_1660_ = true;
                    }
                    let _e984 = phi_1659_;
                    let _e986 = phi_1660_;
                    phi_769_ = _e984;
                    phi_1661_ = _e986;
                } else {
                    phi_769_ = u32();
                    phi_1661_ = false;
                }
                let _e988 = phi_769_;
                let _e990 = phi_1661_;
                continue;
                continuing {
                    phi_765_ = _e488;
                    phi_768_ = _e988;
                    break if !(_e990);
                }
            }
            workgroupBarrier();
            let _e993 = atomicLoad((&counters[4u]));
            if (2048u < _e993) {
                phi_1668_ = 2048u;
            } else {
                phi_1668_ = _e993;
            }
            let _e996 = phi_1668_;
            phi_1671_ = type_9(0u, 16u);
            loop {
                let _e998 = phi_1671_;
                if (_e998.member < _e998.member_1) {
                    phi_1672_ = type_9((_e998.member + 1u), _e998.member_1);
                    phi_1695_ = type_9(1u, _e998.member);
                } else {
                    phi_1672_ = _e998;
                    phi_1695_ = type_9(0u, type_9().member_1);
                }
                let _e1010 = phi_1672_;
                let _e1012 = phi_1695_;
                if (bitcast<i32>(_e1012.member) != 0i) {
                    let _e1018 = (_e47 + (_e1012.member_1 * 128u));
                    if (_e1018 >= _e996) {
                        phi_2524_ = false;
                    } else {
                        let _e1021 = hits[_e1018];
                        let _e1024 = ((_e1021 >> bitcast<u32>(10i)) & 3u);
                        let _e1031 = firsts[(2u * _e1024)];
                        let _e1032 = (_e1031 + ((_e1021 >> bitcast<u32>(5i)) & 31u));
                        let _e1036 = firsts[((2u * _e1024) + 1u)];
                        let _e1037 = (_e1036 + (_e1021 & 31u));
                        let _e1039 = leaves.member[_e1032];
                        let _e1041 = leaves.member[_e1037];
                        let _e1043 = nodes.member[_e1032];
                        let _e1045 = nodes.member[_e1037];
                        let _e1048 = params.member.member.member_1;
                        if ((_e1048 & 1u) != 0u) {
                            if (_e75 == 0u) {
                                if (_e1041.member[0] == _e1039.member[0]) {
                                    phi_1785_ = true;
                                } else {
                                    phi_1785_ = (_e1041.member[0] == _e1039.member[0]);
                                }
                                let _e1076 = phi_1785_;
                                if (_e1041.member[1] == _e1039.member[0]) {
                                    phi_1792_ = true;
                                } else {
                                    phi_1792_ = (_e1041.member[1] == _e1039.member[0]);
                                }
                                let _e1081 = phi_1792_;
                                if (_e1041.member[2] == _e1039.member[0]) {
                                    phi_1800_ = true;
                                } else {
                                    phi_1800_ = (_e1041.member[2] == _e1039.member[0]);
                                }
                                let _e1087 = phi_1800_;
                                phi_1819_ = ((_e1076 || _e1081) || _e1087);
                            } else {
                                if (_e1041.member[0] == _e1039.member[0]) {
                                    phi_1811_ = true;
                                } else {
                                    phi_1811_ = (_e1041.member[0] == _e1039.member[1]);
                                }
                                let _e1063 = phi_1811_;
                                if (_e1041.member[1] == _e1039.member[0]) {
                                    phi_1817_ = true;
                                } else {
                                    phi_1817_ = (_e1041.member[1] == _e1039.member[1]);
                                }
                                let _e1067 = phi_1817_;
                                phi_1819_ = (_e1063 || _e1067);
                            }
                            let _e1090 = phi_1819_;
                            if _e1090 {
                                phi_1823_ = false;
                            } else {
                                phi_1823_ = true;
                            }
                            let _e1092 = phi_1823_;
                            phi_1824_ = _e1092;
                        } else {
                            phi_1824_ = true;
                        }
                        let _e1094 = phi_1824_;
                        if _e1094 {
                            let _e1096 = params.member.member.member_1;
                            if ((_e1096 & 2u) != 0u) {
                                let _e1100 = params.member.member.member_1;
                                let _e1106 = bodies.member[_e1039.member[0]];
                                let _e1110 = bodies.member[_e1041.member[0]];
                                if ((_e1106 / 2u) != (_e1110 / 2u)) {
                                    phi_1870_ = true;
                                } else {
                                    phi_1870_ = ((_e1100 & 4u) != 0u);
                                }
                                let _e1115 = phi_1870_;
                                if _e1115 {
                                    phi_1877_ = (((_e1106 & _e1110) & 1u) == 0u);
                                } else {
                                    phi_1877_ = false;
                                }
                                let _e1120 = phi_1877_;
                                phi_1881_ = _e1120;
                            } else {
                                phi_1881_ = true;
                            }
                            let _e1122 = phi_1881_;
                            if _e1122 {
                                let _e1124 = params.member.member.member_1;
                                if ((_e1124 & 32u) != 0u) {
                                    let _e1128 = params.member.member.member_6;
                                    let _e1169 = (((((_e1043.member_1[0] - _e1045.member[0]) > _e1128) && ((_e1045.member_1[0] - _e1043.member[0]) > _e1128)) && (((_e1043.member_1[1] - _e1045.member[1]) > _e1128) && ((_e1045.member_1[1] - _e1043.member[1]) > _e1128))) && (((_e1043.member_1[2] - _e1045.member[2]) > _e1128) && ((_e1045.member_1[2] - _e1043.member[2]) > _e1128)));
                                    if _e1169 {
                                        phi_2495_ = bool();
                                    } else {
                                        let _e1173 = keys.member[_e1039.member[0]];
                                        let _e1178 = keys.member[_e1039.member[1]];
                                        let _e1180 = function_5(_e1173[0], _e1178[0]);
                                        let _e1184 = keys.member[_e1039.member[2]];
                                        let _e1186 = function_5(_e1180, _e1184[0]);
                                        let _e1190 = keys.member[_e1041.member[0]];
                                        let _e1195 = keys.member[_e1041.member[1]];
                                        let _e1197 = function_4(_e1190[3], _e1195[3]);
                                        let _e1201 = keys.member[_e1041.member[2]];
                                        let _e1203 = function_4(_e1197, _e1201[3]);
                                        if (_e1186[1] > _e1203[1]) {
                                            phi_2018_ = true;
                                        } else {
                                            if (_e1186[1] == _e1203[1]) {
                                                phi_2017_ = (_e1186[0] > _e1203[0]);
                                            } else {
                                                phi_2017_ = false;
                                            }
                                            let _e1214 = phi_2017_;
                                            phi_2018_ = _e1214;
                                        }
                                        let _e1216 = phi_2018_;
                                        let _e1221 = keys.member[_e1041.member[0]];
                                        let _e1226 = keys.member[_e1041.member[1]];
                                        let _e1228 = function_5(_e1221[0], _e1226[0]);
                                        let _e1232 = keys.member[_e1041.member[2]];
                                        let _e1234 = function_5(_e1228, _e1232[0]);
                                        let _e1238 = keys.member[_e1039.member[0]];
                                        let _e1243 = keys.member[_e1039.member[1]];
                                        let _e1245 = function_4(_e1238[3], _e1243[3]);
                                        let _e1249 = keys.member[_e1039.member[2]];
                                        let _e1251 = function_4(_e1245, _e1249[3]);
                                        if (_e1234[1] > _e1251[1]) {
                                            phi_2112_ = true;
                                        } else {
                                            if (_e1234[1] == _e1251[1]) {
                                                phi_2111_ = (_e1234[0] > _e1251[0]);
                                            } else {
                                                phi_2111_ = false;
                                            }
                                            let _e1262 = phi_2111_;
                                            phi_2112_ = _e1262;
                                        }
                                        let _e1264 = phi_2112_;
                                        let _e1270 = keys.member[_e1039.member[0]];
                                        let _e1275 = keys.member[_e1039.member[1]];
                                        let _e1277 = function_3(_e1270[1], _e1275[1]);
                                        let _e1281 = keys.member[_e1039.member[2]];
                                        let _e1283 = function_3(_e1277, _e1281[1]);
                                        let _e1287 = keys.member[_e1041.member[0]];
                                        let _e1292 = keys.member[_e1041.member[1]];
                                        let _e1294 = function_2(_e1287[4], _e1292[4]);
                                        let _e1298 = keys.member[_e1041.member[2]];
                                        let _e1300 = function_2(_e1294, _e1298[4]);
                                        if (_e1283[1] > _e1300[1]) {
                                            phi_2207_ = true;
                                        } else {
                                            if (_e1283[1] == _e1300[1]) {
                                                phi_2206_ = (_e1283[0] > _e1300[0]);
                                            } else {
                                                phi_2206_ = false;
                                            }
                                            let _e1311 = phi_2206_;
                                            phi_2207_ = _e1311;
                                        }
                                        let _e1313 = phi_2207_;
                                        let _e1318 = keys.member[_e1041.member[0]];
                                        let _e1323 = keys.member[_e1041.member[1]];
                                        let _e1325 = function_3(_e1318[1], _e1323[1]);
                                        let _e1329 = keys.member[_e1041.member[2]];
                                        let _e1331 = function_3(_e1325, _e1329[1]);
                                        let _e1335 = keys.member[_e1039.member[0]];
                                        let _e1340 = keys.member[_e1039.member[1]];
                                        let _e1342 = function_2(_e1335[4], _e1340[4]);
                                        let _e1346 = keys.member[_e1039.member[2]];
                                        let _e1348 = function_2(_e1342, _e1346[4]);
                                        if (_e1331[1] > _e1348[1]) {
                                            phi_2301_ = true;
                                        } else {
                                            if (_e1331[1] == _e1348[1]) {
                                                phi_2300_ = (_e1331[0] > _e1348[0]);
                                            } else {
                                                phi_2300_ = false;
                                            }
                                            let _e1359 = phi_2300_;
                                            phi_2301_ = _e1359;
                                        }
                                        let _e1361 = phi_2301_;
                                        let _e1368 = keys.member[_e1039.member[0]];
                                        let _e1373 = keys.member[_e1039.member[1]];
                                        let _e1375 = function_1(_e1368[2], _e1373[2]);
                                        let _e1379 = keys.member[_e1039.member[2]];
                                        let _e1381 = function_1(_e1375, _e1379[2]);
                                        let _e1385 = keys.member[_e1041.member[0]];
                                        let _e1390 = keys.member[_e1041.member[1]];
                                        let _e1392 = function_(_e1385[5], _e1390[5]);
                                        let _e1396 = keys.member[_e1041.member[2]];
                                        let _e1398 = function_(_e1392, _e1396[5]);
                                        if (_e1381[1] > _e1398[1]) {
                                            phi_2397_ = true;
                                        } else {
                                            if (_e1381[1] == _e1398[1]) {
                                                phi_2396_ = (_e1381[0] > _e1398[0]);
                                            } else {
                                                phi_2396_ = false;
                                            }
                                            let _e1409 = phi_2396_;
                                            phi_2397_ = _e1409;
                                        }
                                        let _e1411 = phi_2397_;
                                        let _e1416 = keys.member[_e1041.member[0]];
                                        let _e1421 = keys.member[_e1041.member[1]];
                                        let _e1423 = function_1(_e1416[2], _e1421[2]);
                                        let _e1427 = keys.member[_e1041.member[2]];
                                        let _e1429 = function_1(_e1423, _e1427[2]);
                                        let _e1433 = keys.member[_e1039.member[0]];
                                        let _e1438 = keys.member[_e1039.member[1]];
                                        let _e1440 = function_(_e1433[5], _e1438[5]);
                                        let _e1444 = keys.member[_e1039.member[2]];
                                        let _e1446 = function_(_e1440, _e1444[5]);
                                        if (_e1429[1] > _e1446[1]) {
                                            phi_2491_ = true;
                                        } else {
                                            if (_e1429[1] == _e1446[1]) {
                                                phi_2490_ = (_e1429[0] > _e1446[0]);
                                            } else {
                                                phi_2490_ = false;
                                            }
                                            let _e1457 = phi_2490_;
                                            phi_2491_ = _e1457;
                                        }
                                        let _e1459 = phi_2491_;
                                        phi_2495_ = (((!(_e1216) && !(_e1264)) && (!(_e1313) && !(_e1361))) && (!(_e1411) && !(_e1459)));
                                    }
                                    let _e1464 = phi_2495_;
                                    phi_2496_ = _e1464;
                                    phi_2497_ = _e1169;
                                } else {
                                    phi_2496_ = bool();
                                    phi_2497_ = true;
                                }
                                let _e1466 = phi_2496_;
                                let _e1468 = phi_2497_;
                                if _e1468 {
                                    phi_2501_ = false;
                                } else {
                                    phi_2501_ = true;
                                }
                                let _e1470 = phi_2501_;
                                phi_2502_ = _e1466;
                                phi_2503_ = _e1470;
                            } else {
                                phi_2502_ = false;
                                phi_2503_ = true;
                            }
                            let _e1472 = phi_2502_;
                            let _e1474 = phi_2503_;
                            phi_2504_ = _e1472;
                            phi_2505_ = _e1474;
                        } else {
                            phi_2504_ = false;
                            phi_2505_ = true;
                        }
                        let _e1476 = phi_2504_;
                        let _e1478 = phi_2505_;
                        if _e1478 {
                            phi_2509_ = _e1476;
                        } else {
                            phi_2509_ = true;
                        }
                        let _e1480 = phi_2509_;
                        if _e1480 {
                            let _e1482 = atomicAdd((&counters[7u]), 1u);
                            let _e1484 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1018] = ((2147483648u | (_e1484 << bitcast<u32>(12i))) | _e1021);
                        }
                        phi_2524_ = true;
                    }
                    let _e1491 = phi_2524_;
                    phi_2525_ = _e1491;
                } else {
                    phi_2525_ = false;
                }
                let _e1493 = phi_2525_;
                continue;
                continuing {
                    phi_1671_ = _e1010;
                    break if !(_e1493);
                }
            }
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e1497 = atomicLoad((&counters[5u]));
                if (_e1497 > 0u) {
                    let _e1500 = atomicAdd((&output.member[0u]), _e1497);
                    if ((_e1500 + _e1497) < _e1500) {
                        let _e1504 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1500);
                }
            }
            workgroupBarrier();
            let _e1507 = atomicLoad((&counters[6u]));
            if (_e47 == 0u) {
                let _e1510 = atomicLoad((&counters[7u]));
                if (_e1510 > 0u) {
                    let _e1513 = atomicAdd((&output.member[1u]), _e1510);
                    if ((_e1513 + _e1510) < _e1513) {
                        let _e1517 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2575_ = type_9(0u, 16u);
            loop {
                let _e1519 = phi_2575_;
                if (_e1519.member < _e1519.member_1) {
                    phi_2576_ = type_9((_e1519.member + 1u), _e1519.member_1);
                    phi_2599_ = type_9(1u, _e1519.member);
                } else {
                    phi_2576_ = _e1519;
                    phi_2599_ = type_9(0u, type_9().member_1);
                }
                let _e1531 = phi_2576_;
                let _e1533 = phi_2599_;
                if (bitcast<i32>(_e1533.member) != 0i) {
                    let _e1539 = (_e47 + (_e1533.member_1 * 128u));
                    if (_e1539 >= _e996) {
                        phi_2696_ = false;
                    } else {
                        let _e1542 = hits[_e1539];
                        if ((_e1542 & 2147483648u) == 0u) {
                            phi_2622_ = 4294967295u;
                        } else {
                            phi_2622_ = ((_e1542 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1549 = phi_2622_;
                        if (_e1549 != 4294967295u) {
                            let _e1553 = ((_e1542 >> bitcast<u32>(10i)) & 3u);
                            let _e1560 = firsts[(2u * _e1553)];
                            let _e1563 = leaves.member[(_e1560 + ((_e1542 >> bitcast<u32>(5i)) & 31u))];
                            let _e1567 = firsts[((2u * _e1553) + 1u)];
                            let _e1570 = leaves.member[(_e1567 + (_e1542 & 31u))];
                            let _e1575 = params.member.member_1.member_3;
                            let _e1576 = (_e1507 + _e1549);
                            if (_e78[0] == _e78[1]) {
                                if (_e1563.member_1 < _e1570.member_1) {
                                    phi_2677_ = type_9(_e1563.member_1, _e1570.member_1);
                                } else {
                                    phi_2677_ = type_9(_e1570.member_1, _e1563.member_1);
                                }
                                let _e1583 = phi_2677_;
                                phi_2682_ = _e1583;
                            } else {
                                phi_2682_ = type_9(_e1563.member_1, _e1570.member_1);
                            }
                            let _e1585 = phi_2682_;
                            if (_e1576 < _e1575) {
                                let _e1589 = (2u * _e1576);
                                atomicStore((&output.member[(4u + _e1589)]), _e1585.member);
                                atomicStore((&output.member[(_e1589 + 5u)]), _e1585.member_1);
                            }
                        }
                        phi_2696_ = true;
                    }
                    let _e1595 = phi_2696_;
                    phi_2697_ = _e1595;
                } else {
                    phi_2697_ = false;
                }
                let _e1597 = phi_2697_;
                continue;
                continuing {
                    phi_2575_ = _e1531;
                    break if !(_e1597);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_257_ = _e140;
            break if !(_e146);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
