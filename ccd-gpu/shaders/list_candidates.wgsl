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
    var phi_2862_: bool;
    var phi_2863_: bool;
    var phi_2867_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2863_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2862_ = (param_1[0] > param[0]);
        } else {
            phi_2862_ = false;
        }
        let _e14 = phi_2862_;
        phi_2863_ = _e14;
    }
    let _e16 = phi_2863_;
    if _e16 {
        phi_2867_ = param_1;
    } else {
        phi_2867_ = param;
    }
    let _e18 = phi_2867_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2838_: bool;
    var phi_2839_: bool;
    var phi_2843_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2839_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2838_ = (param_2[0] > param_3[0]);
        } else {
            phi_2838_ = false;
        }
        let _e14 = phi_2838_;
        phi_2839_ = _e14;
    }
    let _e16 = phi_2839_;
    if _e16 {
        phi_2843_ = param_3;
    } else {
        phi_2843_ = param_2;
    }
    let _e18 = phi_2843_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2819_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2815_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2814_ = (param_5[0] > param_4[0]);
        } else {
            phi_2814_ = false;
        }
        let _e14 = phi_2814_;
        phi_2815_ = _e14;
    }
    let _e16 = phi_2815_;
    if _e16 {
        phi_2819_ = param_5;
    } else {
        phi_2819_ = param_4;
    }
    let _e18 = phi_2819_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2790_: bool;
    var phi_2791_: bool;
    var phi_2795_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2791_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2790_ = (param_6[0] > param_7[0]);
        } else {
            phi_2790_ = false;
        }
        let _e14 = phi_2790_;
        phi_2791_ = _e14;
    }
    let _e16 = phi_2791_;
    if _e16 {
        phi_2795_ = param_7;
    } else {
        phi_2795_ = param_6;
    }
    let _e18 = phi_2795_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2771_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2767_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2766_ = (param_9[0] > param_8[0]);
        } else {
            phi_2766_ = false;
        }
        let _e14 = phi_2766_;
        phi_2767_ = _e14;
    }
    let _e16 = phi_2767_;
    if _e16 {
        phi_2771_ = param_9;
    } else {
        phi_2771_ = param_8;
    }
    let _e18 = phi_2771_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2747_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2743_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2742_ = (param_10[0] > param_11[0]);
        } else {
            phi_2742_ = false;
        }
        let _e14 = phi_2742_;
        phi_2743_ = _e14;
    }
    let _e16 = phi_2743_;
    if _e16 {
        phi_2747_ = param_11;
    } else {
        phi_2747_ = param_10;
    }
    let _e18 = phi_2747_;
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
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_916_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_966_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1497_: bool;
    var phi_1498_: bool;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1610_: bool;
    var phi_1629_: type_9;
    var phi_1634_: type_9;
    var phi_1672_: u32;
    var phi_1673_: bool;
    var phi_769_: u32;
    var phi_1674_: bool;
    var phi_1681_: u32;
    var phi_1684_: type_9;
    var phi_1685_: type_9;
    var phi_1708_: type_9;
    var phi_1833_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1837_: bool;
    var phi_1841_: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1807_: bool;
    var phi_1811_: bool;
    var phi_1842_: bool;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1891_: bool;
    var phi_1901_: bool;
    var phi_1902_: bool;
    var phi_1906_: bool;
    var phi_1907_: bool;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2326_: bool;
    var phi_2327_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2535_: bool;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2601_: type_9;
    var phi_2602_: type_9;
    var phi_2625_: type_9;
    var phi_2648_: u32;
    var phi_2703_: type_9;
    var phi_2708_: type_9;
    var phi_2722_: bool;
    var phi_2723_: bool;
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
            let _e1681 = local;
            phi_768_ = _e1681;
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
                        phi_1672_ = u32();
                        phi_1673_ = false;
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
                                if (_e507.member[0] == _e509.member[0]) {
                                    phi_881_ = bool();
                                    phi_882_ = true;
                                } else {
                                    let _e561 = (_e507.member[0] == _e509.member[1]);
                                    if _e561 {
                                        phi_880_ = bool();
                                    } else {
                                        phi_880_ = (_e507.member[0] == _e509.member[2]);
                                    }
                                    let _e568 = phi_880_;
                                    phi_881_ = _e568;
                                    phi_882_ = _e561;
                                }
                                let _e570 = phi_881_;
                                let _e572 = phi_882_;
                                if _e572 {
                                    phi_886_ = true;
                                } else {
                                    phi_886_ = _e570;
                                }
                                let _e574 = phi_886_;
                                phi_917_ = _e574;
                            } else {
                                if (_e507.member[0] == _e509.member[0]) {
                                    phi_911_ = bool();
                                    phi_912_ = true;
                                } else {
                                    if (_e507.member[0] == _e509.member[1]) {
                                        phi_909_ = bool();
                                        phi_910_ = true;
                                    } else {
                                        let _e534 = (_e507.member[1] == _e509.member[0]);
                                        if _e534 {
                                            phi_908_ = bool();
                                        } else {
                                            phi_908_ = (_e507.member[1] == _e509.member[1]);
                                        }
                                        let _e541 = phi_908_;
                                        phi_909_ = _e541;
                                        phi_910_ = _e534;
                                    }
                                    let _e543 = phi_909_;
                                    let _e545 = phi_910_;
                                    phi_911_ = _e543;
                                    phi_912_ = _e545;
                                }
                                let _e547 = phi_911_;
                                let _e549 = phi_912_;
                                if _e549 {
                                    phi_916_ = true;
                                } else {
                                    phi_916_ = _e547;
                                }
                                let _e551 = phi_916_;
                                phi_917_ = _e551;
                            }
                            let _e576 = phi_917_;
                            if _e576 {
                                phi_921_ = false;
                            } else {
                                phi_921_ = true;
                            }
                            let _e578 = phi_921_;
                            phi_922_ = _e578;
                        } else {
                            phi_922_ = true;
                        }
                        let _e580 = phi_922_;
                        if _e580 {
                            let _e582 = params.member.member.member_1;
                            if ((_e582 & 2u) != 0u) {
                                let _e588 = bodies.member[_e507.member[0]];
                                let _e592 = bodies.member[_e509.member[0]];
                                if ((_e588 / 2u) == (_e592 / 2u)) {
                                    let _e597 = params.member.member.member_1;
                                    phi_966_ = !(((_e597 & 4u) != 0u));
                                } else {
                                    phi_966_ = false;
                                }
                                let _e602 = phi_966_;
                                if _e602 {
                                    phi_977_ = true;
                                } else {
                                    if (((_e588 & _e592) & 1u) == 0u) {
                                        phi_976_ = false;
                                    } else {
                                        phi_976_ = true;
                                    }
                                    let _e607 = phi_976_;
                                    phi_977_ = _e607;
                                }
                                let _e609 = phi_977_;
                                if _e609 {
                                    phi_981_ = false;
                                } else {
                                    phi_981_ = true;
                                }
                                let _e611 = phi_981_;
                                phi_982_ = _e611;
                            } else {
                                phi_982_ = true;
                            }
                            let _e613 = phi_982_;
                            if _e613 {
                                let _e615 = params.member.member.member_1;
                                if ((_e615 & 32u) != 0u) {
                                    let _e619 = params.member.member.member_6;
                                    let _e660 = (((((((_e511.member_1[0] - _e513.member[0]) > _e619) && ((_e513.member_1[0] - _e511.member[0]) > _e619)) && ((_e511.member_1[1] - _e513.member[1]) > _e619)) && ((_e513.member_1[1] - _e511.member[1]) > _e619)) && ((_e511.member_1[2] - _e513.member[2]) > _e619)) && ((_e513.member_1[2] - _e511.member[2]) > _e619));
                                    if _e660 {
                                        phi_1596_ = bool();
                                    } else {
                                        let _e664 = keys.member[_e507.member[0]];
                                        let _e669 = keys.member[_e507.member[1]];
                                        let _e671 = function_5(_e664[0], _e669[0]);
                                        let _e675 = keys.member[_e507.member[2]];
                                        let _e677 = function_5(_e671, _e675[0]);
                                        let _e681 = keys.member[_e509.member[0]];
                                        let _e686 = keys.member[_e509.member[1]];
                                        let _e688 = function_4(_e681[3], _e686[3]);
                                        let _e692 = keys.member[_e509.member[2]];
                                        let _e694 = function_4(_e688, _e692[3]);
                                        if (_e677[1] > _e694[1]) {
                                            phi_1119_ = true;
                                        } else {
                                            if (_e677[1] == _e694[1]) {
                                                phi_1118_ = (_e677[0] > _e694[0]);
                                            } else {
                                                phi_1118_ = false;
                                            }
                                            let _e705 = phi_1118_;
                                            phi_1119_ = _e705;
                                        }
                                        let _e707 = phi_1119_;
                                        let _e712 = keys.member[_e509.member[0]];
                                        let _e717 = keys.member[_e509.member[1]];
                                        let _e719 = function_5(_e712[0], _e717[0]);
                                        let _e723 = keys.member[_e509.member[2]];
                                        let _e725 = function_5(_e719, _e723[0]);
                                        let _e729 = keys.member[_e507.member[0]];
                                        let _e734 = keys.member[_e507.member[1]];
                                        let _e736 = function_4(_e729[3], _e734[3]);
                                        let _e740 = keys.member[_e507.member[2]];
                                        let _e742 = function_4(_e736, _e740[3]);
                                        if (_e725[1] > _e742[1]) {
                                            phi_1213_ = true;
                                        } else {
                                            if (_e725[1] == _e742[1]) {
                                                phi_1212_ = (_e725[0] > _e742[0]);
                                            } else {
                                                phi_1212_ = false;
                                            }
                                            let _e753 = phi_1212_;
                                            phi_1213_ = _e753;
                                        }
                                        let _e755 = phi_1213_;
                                        let _e761 = keys.member[_e507.member[0]];
                                        let _e766 = keys.member[_e507.member[1]];
                                        let _e768 = function_3(_e761[1], _e766[1]);
                                        let _e772 = keys.member[_e507.member[2]];
                                        let _e774 = function_3(_e768, _e772[1]);
                                        let _e778 = keys.member[_e509.member[0]];
                                        let _e783 = keys.member[_e509.member[1]];
                                        let _e785 = function_2(_e778[4], _e783[4]);
                                        let _e789 = keys.member[_e509.member[2]];
                                        let _e791 = function_2(_e785, _e789[4]);
                                        if (_e774[1] > _e791[1]) {
                                            phi_1308_ = true;
                                        } else {
                                            if (_e774[1] == _e791[1]) {
                                                phi_1307_ = (_e774[0] > _e791[0]);
                                            } else {
                                                phi_1307_ = false;
                                            }
                                            let _e802 = phi_1307_;
                                            phi_1308_ = _e802;
                                        }
                                        let _e804 = phi_1308_;
                                        let _e809 = keys.member[_e509.member[0]];
                                        let _e814 = keys.member[_e509.member[1]];
                                        let _e816 = function_3(_e809[1], _e814[1]);
                                        let _e820 = keys.member[_e509.member[2]];
                                        let _e822 = function_3(_e816, _e820[1]);
                                        let _e826 = keys.member[_e507.member[0]];
                                        let _e831 = keys.member[_e507.member[1]];
                                        let _e833 = function_2(_e826[4], _e831[4]);
                                        let _e837 = keys.member[_e507.member[2]];
                                        let _e839 = function_2(_e833, _e837[4]);
                                        if (_e822[1] > _e839[1]) {
                                            phi_1402_ = true;
                                        } else {
                                            if (_e822[1] == _e839[1]) {
                                                phi_1401_ = (_e822[0] > _e839[0]);
                                            } else {
                                                phi_1401_ = false;
                                            }
                                            let _e850 = phi_1401_;
                                            phi_1402_ = _e850;
                                        }
                                        let _e852 = phi_1402_;
                                        let _e859 = keys.member[_e507.member[0]];
                                        let _e864 = keys.member[_e507.member[1]];
                                        let _e866 = function_1(_e859[2], _e864[2]);
                                        let _e870 = keys.member[_e507.member[2]];
                                        let _e872 = function_1(_e866, _e870[2]);
                                        let _e876 = keys.member[_e509.member[0]];
                                        let _e881 = keys.member[_e509.member[1]];
                                        let _e883 = function_(_e876[5], _e881[5]);
                                        let _e887 = keys.member[_e509.member[2]];
                                        let _e889 = function_(_e883, _e887[5]);
                                        if (_e872[1] > _e889[1]) {
                                            phi_1498_ = true;
                                        } else {
                                            if (_e872[1] == _e889[1]) {
                                                phi_1497_ = (_e872[0] > _e889[0]);
                                            } else {
                                                phi_1497_ = false;
                                            }
                                            let _e900 = phi_1497_;
                                            phi_1498_ = _e900;
                                        }
                                        let _e902 = phi_1498_;
                                        let _e907 = keys.member[_e509.member[0]];
                                        let _e912 = keys.member[_e509.member[1]];
                                        let _e914 = function_1(_e907[2], _e912[2]);
                                        let _e918 = keys.member[_e509.member[2]];
                                        let _e920 = function_1(_e914, _e918[2]);
                                        let _e924 = keys.member[_e507.member[0]];
                                        let _e929 = keys.member[_e507.member[1]];
                                        let _e931 = function_(_e924[5], _e929[5]);
                                        let _e935 = keys.member[_e507.member[2]];
                                        let _e937 = function_(_e931, _e935[5]);
                                        if (_e920[1] > _e937[1]) {
                                            phi_1592_ = true;
                                        } else {
                                            if (_e920[1] == _e937[1]) {
                                                phi_1591_ = (_e920[0] > _e937[0]);
                                            } else {
                                                phi_1591_ = false;
                                            }
                                            let _e948 = phi_1591_;
                                            phi_1592_ = _e948;
                                        }
                                        let _e950 = phi_1592_;
                                        phi_1596_ = (((!(_e707) && !(_e755)) && (!(_e804) && !(_e852))) && (!(_e902) && !(_e950)));
                                    }
                                    let _e955 = phi_1596_;
                                    phi_1597_ = _e955;
                                    phi_1598_ = _e660;
                                } else {
                                    phi_1597_ = bool();
                                    phi_1598_ = true;
                                }
                                let _e957 = phi_1597_;
                                let _e959 = phi_1598_;
                                if _e959 {
                                    phi_1602_ = false;
                                } else {
                                    phi_1602_ = true;
                                }
                                let _e961 = phi_1602_;
                                phi_1603_ = _e957;
                                phi_1604_ = _e961;
                            } else {
                                phi_1603_ = false;
                                phi_1604_ = true;
                            }
                            let _e963 = phi_1603_;
                            let _e965 = phi_1604_;
                            phi_1605_ = _e963;
                            phi_1606_ = _e965;
                        } else {
                            phi_1605_ = false;
                            phi_1606_ = true;
                        }
                        let _e967 = phi_1605_;
                        let _e969 = phi_1606_;
                        if _e969 {
                            phi_1610_ = _e967;
                        } else {
                            phi_1610_ = true;
                        }
                        let _e971 = phi_1610_;
                        if _e971 {
                            let _e974 = params.member.member_1.member_3;
                            if (_e78[0] == _e78[1]) {
                                if (_e507.member_1 < _e509.member_1) {
                                    phi_1629_ = type_9(_e507.member_1, _e509.member_1);
                                } else {
                                    phi_1629_ = type_9(_e509.member_1, _e507.member_1);
                                }
                                let _e983 = phi_1629_;
                                phi_1634_ = _e983;
                            } else {
                                phi_1634_ = type_9(_e507.member_1, _e509.member_1);
                            }
                            let _e985 = phi_1634_;
                            let _e989 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e989 + 1u) < _e989) {
                                let _e993 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e989 < _e974) {
                                let _e995 = (2u * _e989);
                                atomicStore((&output.member[(4u + _e995)]), _e985.member);
                                atomicStore((&output.member[(_e995 + 5u)]), _e985.member_1);
                            }
                            let _e1001 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1001 + 1u) < _e1001) {
                                let _e1005 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1672_ = (_e476 & (_e476 - 1u));
                        phi_1673_ = true;
                    }
                    let _e1007 = phi_1672_;
                    let _e1009 = phi_1673_;
                    phi_769_ = _e1007;
                    phi_1674_ = _e1009;
                } else {
                    phi_769_ = u32();
                    phi_1674_ = false;
                }
                let _e1011 = phi_769_;
                let _e1013 = phi_1674_;
                continue;
                continuing {
                    phi_765_ = _e488;
                    phi_768_ = _e1011;
                    break if !(_e1013);
                }
            }
            workgroupBarrier();
            let _e1016 = atomicLoad((&counters[4u]));
            if (2048u < _e1016) {
                phi_1681_ = 2048u;
            } else {
                phi_1681_ = _e1016;
            }
            let _e1019 = phi_1681_;
            phi_1684_ = type_9(0u, 16u);
            loop {
                let _e1021 = phi_1684_;
                if (_e1021.member < _e1021.member_1) {
                    phi_1685_ = type_9((_e1021.member + 1u), _e1021.member_1);
                    phi_1708_ = type_9(1u, _e1021.member);
                } else {
                    phi_1685_ = _e1021;
                    phi_1708_ = type_9(0u, type_9().member_1);
                }
                let _e1033 = phi_1685_;
                let _e1035 = phi_1708_;
                if (bitcast<i32>(_e1035.member) != 0i) {
                    let _e1041 = (_e47 + (_e1035.member_1 * 128u));
                    if (_e1041 >= _e1019) {
                        phi_2550_ = false;
                    } else {
                        let _e1044 = hits[_e1041];
                        let _e1047 = ((_e1044 >> bitcast<u32>(10i)) & 3u);
                        let _e1054 = firsts[(2u * _e1047)];
                        let _e1055 = (_e1054 + ((_e1044 >> bitcast<u32>(5i)) & 31u));
                        let _e1059 = firsts[((2u * _e1047) + 1u)];
                        let _e1060 = (_e1059 + (_e1044 & 31u));
                        let _e1062 = leaves.member[_e1055];
                        let _e1064 = leaves.member[_e1060];
                        let _e1066 = nodes.member[_e1055];
                        let _e1068 = nodes.member[_e1060];
                        let _e1071 = params.member.member.member_1;
                        if ((_e1071 & 1u) != 0u) {
                            if (_e75 == 0u) {
                                if (_e1062.member[0] == _e1064.member[0]) {
                                    phi_1806_ = bool();
                                    phi_1807_ = true;
                                } else {
                                    let _e1116 = (_e1062.member[0] == _e1064.member[1]);
                                    if _e1116 {
                                        phi_1805_ = bool();
                                    } else {
                                        phi_1805_ = (_e1062.member[0] == _e1064.member[2]);
                                    }
                                    let _e1123 = phi_1805_;
                                    phi_1806_ = _e1123;
                                    phi_1807_ = _e1116;
                                }
                                let _e1125 = phi_1806_;
                                let _e1127 = phi_1807_;
                                if _e1127 {
                                    phi_1811_ = true;
                                } else {
                                    phi_1811_ = _e1125;
                                }
                                let _e1129 = phi_1811_;
                                phi_1842_ = _e1129;
                            } else {
                                if (_e1062.member[0] == _e1064.member[0]) {
                                    phi_1836_ = bool();
                                    phi_1837_ = true;
                                } else {
                                    if (_e1062.member[0] == _e1064.member[1]) {
                                        phi_1834_ = bool();
                                        phi_1835_ = true;
                                    } else {
                                        let _e1089 = (_e1062.member[1] == _e1064.member[0]);
                                        if _e1089 {
                                            phi_1833_ = bool();
                                        } else {
                                            phi_1833_ = (_e1062.member[1] == _e1064.member[1]);
                                        }
                                        let _e1096 = phi_1833_;
                                        phi_1834_ = _e1096;
                                        phi_1835_ = _e1089;
                                    }
                                    let _e1098 = phi_1834_;
                                    let _e1100 = phi_1835_;
                                    phi_1836_ = _e1098;
                                    phi_1837_ = _e1100;
                                }
                                let _e1102 = phi_1836_;
                                let _e1104 = phi_1837_;
                                if _e1104 {
                                    phi_1841_ = true;
                                } else {
                                    phi_1841_ = _e1102;
                                }
                                let _e1106 = phi_1841_;
                                phi_1842_ = _e1106;
                            }
                            let _e1131 = phi_1842_;
                            if _e1131 {
                                phi_1846_ = false;
                            } else {
                                phi_1846_ = true;
                            }
                            let _e1133 = phi_1846_;
                            phi_1847_ = _e1133;
                        } else {
                            phi_1847_ = true;
                        }
                        let _e1135 = phi_1847_;
                        if _e1135 {
                            let _e1137 = params.member.member.member_1;
                            if ((_e1137 & 2u) != 0u) {
                                let _e1143 = bodies.member[_e1062.member[0]];
                                let _e1147 = bodies.member[_e1064.member[0]];
                                if ((_e1143 / 2u) == (_e1147 / 2u)) {
                                    let _e1152 = params.member.member.member_1;
                                    phi_1891_ = !(((_e1152 & 4u) != 0u));
                                } else {
                                    phi_1891_ = false;
                                }
                                let _e1157 = phi_1891_;
                                if _e1157 {
                                    phi_1902_ = true;
                                } else {
                                    if (((_e1143 & _e1147) & 1u) == 0u) {
                                        phi_1901_ = false;
                                    } else {
                                        phi_1901_ = true;
                                    }
                                    let _e1162 = phi_1901_;
                                    phi_1902_ = _e1162;
                                }
                                let _e1164 = phi_1902_;
                                if _e1164 {
                                    phi_1906_ = false;
                                } else {
                                    phi_1906_ = true;
                                }
                                let _e1166 = phi_1906_;
                                phi_1907_ = _e1166;
                            } else {
                                phi_1907_ = true;
                            }
                            let _e1168 = phi_1907_;
                            if _e1168 {
                                let _e1170 = params.member.member.member_1;
                                if ((_e1170 & 32u) != 0u) {
                                    let _e1174 = params.member.member.member_6;
                                    let _e1215 = (((((((_e1066.member_1[0] - _e1068.member[0]) > _e1174) && ((_e1068.member_1[0] - _e1066.member[0]) > _e1174)) && ((_e1066.member_1[1] - _e1068.member[1]) > _e1174)) && ((_e1068.member_1[1] - _e1066.member[1]) > _e1174)) && ((_e1066.member_1[2] - _e1068.member[2]) > _e1174)) && ((_e1068.member_1[2] - _e1066.member[2]) > _e1174));
                                    if _e1215 {
                                        phi_2521_ = bool();
                                    } else {
                                        let _e1219 = keys.member[_e1062.member[0]];
                                        let _e1224 = keys.member[_e1062.member[1]];
                                        let _e1226 = function_5(_e1219[0], _e1224[0]);
                                        let _e1230 = keys.member[_e1062.member[2]];
                                        let _e1232 = function_5(_e1226, _e1230[0]);
                                        let _e1236 = keys.member[_e1064.member[0]];
                                        let _e1241 = keys.member[_e1064.member[1]];
                                        let _e1243 = function_4(_e1236[3], _e1241[3]);
                                        let _e1247 = keys.member[_e1064.member[2]];
                                        let _e1249 = function_4(_e1243, _e1247[3]);
                                        if (_e1232[1] > _e1249[1]) {
                                            phi_2044_ = true;
                                        } else {
                                            if (_e1232[1] == _e1249[1]) {
                                                phi_2043_ = (_e1232[0] > _e1249[0]);
                                            } else {
                                                phi_2043_ = false;
                                            }
                                            let _e1260 = phi_2043_;
                                            phi_2044_ = _e1260;
                                        }
                                        let _e1262 = phi_2044_;
                                        let _e1267 = keys.member[_e1064.member[0]];
                                        let _e1272 = keys.member[_e1064.member[1]];
                                        let _e1274 = function_5(_e1267[0], _e1272[0]);
                                        let _e1278 = keys.member[_e1064.member[2]];
                                        let _e1280 = function_5(_e1274, _e1278[0]);
                                        let _e1284 = keys.member[_e1062.member[0]];
                                        let _e1289 = keys.member[_e1062.member[1]];
                                        let _e1291 = function_4(_e1284[3], _e1289[3]);
                                        let _e1295 = keys.member[_e1062.member[2]];
                                        let _e1297 = function_4(_e1291, _e1295[3]);
                                        if (_e1280[1] > _e1297[1]) {
                                            phi_2138_ = true;
                                        } else {
                                            if (_e1280[1] == _e1297[1]) {
                                                phi_2137_ = (_e1280[0] > _e1297[0]);
                                            } else {
                                                phi_2137_ = false;
                                            }
                                            let _e1308 = phi_2137_;
                                            phi_2138_ = _e1308;
                                        }
                                        let _e1310 = phi_2138_;
                                        let _e1316 = keys.member[_e1062.member[0]];
                                        let _e1321 = keys.member[_e1062.member[1]];
                                        let _e1323 = function_3(_e1316[1], _e1321[1]);
                                        let _e1327 = keys.member[_e1062.member[2]];
                                        let _e1329 = function_3(_e1323, _e1327[1]);
                                        let _e1333 = keys.member[_e1064.member[0]];
                                        let _e1338 = keys.member[_e1064.member[1]];
                                        let _e1340 = function_2(_e1333[4], _e1338[4]);
                                        let _e1344 = keys.member[_e1064.member[2]];
                                        let _e1346 = function_2(_e1340, _e1344[4]);
                                        if (_e1329[1] > _e1346[1]) {
                                            phi_2233_ = true;
                                        } else {
                                            if (_e1329[1] == _e1346[1]) {
                                                phi_2232_ = (_e1329[0] > _e1346[0]);
                                            } else {
                                                phi_2232_ = false;
                                            }
                                            let _e1357 = phi_2232_;
                                            phi_2233_ = _e1357;
                                        }
                                        let _e1359 = phi_2233_;
                                        let _e1364 = keys.member[_e1064.member[0]];
                                        let _e1369 = keys.member[_e1064.member[1]];
                                        let _e1371 = function_3(_e1364[1], _e1369[1]);
                                        let _e1375 = keys.member[_e1064.member[2]];
                                        let _e1377 = function_3(_e1371, _e1375[1]);
                                        let _e1381 = keys.member[_e1062.member[0]];
                                        let _e1386 = keys.member[_e1062.member[1]];
                                        let _e1388 = function_2(_e1381[4], _e1386[4]);
                                        let _e1392 = keys.member[_e1062.member[2]];
                                        let _e1394 = function_2(_e1388, _e1392[4]);
                                        if (_e1377[1] > _e1394[1]) {
                                            phi_2327_ = true;
                                        } else {
                                            if (_e1377[1] == _e1394[1]) {
                                                phi_2326_ = (_e1377[0] > _e1394[0]);
                                            } else {
                                                phi_2326_ = false;
                                            }
                                            let _e1405 = phi_2326_;
                                            phi_2327_ = _e1405;
                                        }
                                        let _e1407 = phi_2327_;
                                        let _e1414 = keys.member[_e1062.member[0]];
                                        let _e1419 = keys.member[_e1062.member[1]];
                                        let _e1421 = function_1(_e1414[2], _e1419[2]);
                                        let _e1425 = keys.member[_e1062.member[2]];
                                        let _e1427 = function_1(_e1421, _e1425[2]);
                                        let _e1431 = keys.member[_e1064.member[0]];
                                        let _e1436 = keys.member[_e1064.member[1]];
                                        let _e1438 = function_(_e1431[5], _e1436[5]);
                                        let _e1442 = keys.member[_e1064.member[2]];
                                        let _e1444 = function_(_e1438, _e1442[5]);
                                        if (_e1427[1] > _e1444[1]) {
                                            phi_2423_ = true;
                                        } else {
                                            if (_e1427[1] == _e1444[1]) {
                                                phi_2422_ = (_e1427[0] > _e1444[0]);
                                            } else {
                                                phi_2422_ = false;
                                            }
                                            let _e1455 = phi_2422_;
                                            phi_2423_ = _e1455;
                                        }
                                        let _e1457 = phi_2423_;
                                        let _e1462 = keys.member[_e1064.member[0]];
                                        let _e1467 = keys.member[_e1064.member[1]];
                                        let _e1469 = function_1(_e1462[2], _e1467[2]);
                                        let _e1473 = keys.member[_e1064.member[2]];
                                        let _e1475 = function_1(_e1469, _e1473[2]);
                                        let _e1479 = keys.member[_e1062.member[0]];
                                        let _e1484 = keys.member[_e1062.member[1]];
                                        let _e1486 = function_(_e1479[5], _e1484[5]);
                                        let _e1490 = keys.member[_e1062.member[2]];
                                        let _e1492 = function_(_e1486, _e1490[5]);
                                        if (_e1475[1] > _e1492[1]) {
                                            phi_2517_ = true;
                                        } else {
                                            if (_e1475[1] == _e1492[1]) {
                                                phi_2516_ = (_e1475[0] > _e1492[0]);
                                            } else {
                                                phi_2516_ = false;
                                            }
                                            let _e1503 = phi_2516_;
                                            phi_2517_ = _e1503;
                                        }
                                        let _e1505 = phi_2517_;
                                        phi_2521_ = (((!(_e1262) && !(_e1310)) && (!(_e1359) && !(_e1407))) && (!(_e1457) && !(_e1505)));
                                    }
                                    let _e1510 = phi_2521_;
                                    phi_2522_ = _e1510;
                                    phi_2523_ = _e1215;
                                } else {
                                    phi_2522_ = bool();
                                    phi_2523_ = true;
                                }
                                let _e1512 = phi_2522_;
                                let _e1514 = phi_2523_;
                                if _e1514 {
                                    phi_2527_ = false;
                                } else {
                                    phi_2527_ = true;
                                }
                                let _e1516 = phi_2527_;
                                phi_2528_ = _e1512;
                                phi_2529_ = _e1516;
                            } else {
                                phi_2528_ = false;
                                phi_2529_ = true;
                            }
                            let _e1518 = phi_2528_;
                            let _e1520 = phi_2529_;
                            phi_2530_ = _e1518;
                            phi_2531_ = _e1520;
                        } else {
                            phi_2530_ = false;
                            phi_2531_ = true;
                        }
                        let _e1522 = phi_2530_;
                        let _e1524 = phi_2531_;
                        if _e1524 {
                            phi_2535_ = _e1522;
                        } else {
                            phi_2535_ = true;
                        }
                        let _e1526 = phi_2535_;
                        if _e1526 {
                            let _e1528 = atomicAdd((&counters[7u]), 1u);
                            let _e1530 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1041] = ((2147483648u | (_e1530 << bitcast<u32>(12i))) | _e1044);
                        }
                        phi_2550_ = true;
                    }
                    let _e1537 = phi_2550_;
                    phi_2551_ = _e1537;
                } else {
                    phi_2551_ = false;
                }
                let _e1539 = phi_2551_;
                continue;
                continuing {
                    phi_1684_ = _e1033;
                    break if !(_e1539);
                }
            }
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e1543 = atomicLoad((&counters[5u]));
                if (_e1543 > 0u) {
                    let _e1546 = atomicAdd((&output.member[0u]), _e1543);
                    if ((_e1546 + _e1543) < _e1546) {
                        let _e1550 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1546);
                }
            }
            workgroupBarrier();
            let _e1553 = atomicLoad((&counters[6u]));
            if (_e47 == 0u) {
                let _e1556 = atomicLoad((&counters[7u]));
                if (_e1556 > 0u) {
                    let _e1559 = atomicAdd((&output.member[1u]), _e1556);
                    if ((_e1559 + _e1556) < _e1559) {
                        let _e1563 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2601_ = type_9(0u, 16u);
            loop {
                let _e1565 = phi_2601_;
                if (_e1565.member < _e1565.member_1) {
                    phi_2602_ = type_9((_e1565.member + 1u), _e1565.member_1);
                    phi_2625_ = type_9(1u, _e1565.member);
                } else {
                    phi_2602_ = _e1565;
                    phi_2625_ = type_9(0u, type_9().member_1);
                }
                let _e1577 = phi_2602_;
                let _e1579 = phi_2625_;
                if (bitcast<i32>(_e1579.member) != 0i) {
                    let _e1585 = (_e47 + (_e1579.member_1 * 128u));
                    if (_e1585 >= _e1019) {
                        phi_2722_ = false;
                    } else {
                        let _e1588 = hits[_e1585];
                        if ((_e1588 & 2147483648u) == 0u) {
                            phi_2648_ = 4294967295u;
                        } else {
                            phi_2648_ = ((_e1588 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1595 = phi_2648_;
                        if (_e1595 != 4294967295u) {
                            let _e1599 = ((_e1588 >> bitcast<u32>(10i)) & 3u);
                            let _e1606 = firsts[(2u * _e1599)];
                            let _e1609 = leaves.member[(_e1606 + ((_e1588 >> bitcast<u32>(5i)) & 31u))];
                            let _e1613 = firsts[((2u * _e1599) + 1u)];
                            let _e1616 = leaves.member[(_e1613 + (_e1588 & 31u))];
                            let _e1621 = params.member.member_1.member_3;
                            let _e1622 = (_e1553 + _e1595);
                            if (_e78[0] == _e78[1]) {
                                if (_e1609.member_1 < _e1616.member_1) {
                                    phi_2703_ = type_9(_e1609.member_1, _e1616.member_1);
                                } else {
                                    phi_2703_ = type_9(_e1616.member_1, _e1609.member_1);
                                }
                                let _e1629 = phi_2703_;
                                phi_2708_ = _e1629;
                            } else {
                                phi_2708_ = type_9(_e1609.member_1, _e1616.member_1);
                            }
                            let _e1631 = phi_2708_;
                            if (_e1622 < _e1621) {
                                let _e1635 = (2u * _e1622);
                                atomicStore((&output.member[(4u + _e1635)]), _e1631.member);
                                atomicStore((&output.member[(_e1635 + 5u)]), _e1631.member_1);
                            }
                        }
                        phi_2722_ = true;
                    }
                    let _e1641 = phi_2722_;
                    phi_2723_ = _e1641;
                } else {
                    phi_2723_ = false;
                }
                let _e1643 = phi_2723_;
                continue;
                continuing {
                    phi_2601_ = _e1577;
                    break if !(_e1643);
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
