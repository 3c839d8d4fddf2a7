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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_20 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(2) 
var<storage> leaves: type_22;
@group(0) @binding(1) 
var<storage> nodes: type_26;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_28, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_33;
@group(0) @binding(5) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> output: type_37;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_2844_: bool;
    var phi_2845_: bool;
    var phi_2849_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_2845_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_2844_ = (param_1[0] > param[0]);
        } else {
            phi_2844_ = false;
        }
        let _e14 = phi_2844_;
        phi_2845_ = _e14;
    }
    let _e16 = phi_2845_;
    if _e16 {
        phi_2849_ = param_1;
    } else {
        phi_2849_ = param;
    }
    let _e18 = phi_2849_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2825_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_2821_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_2820_ = (param_2[0] > param_3[0]);
        } else {
            phi_2820_ = false;
        }
        let _e14 = phi_2820_;
        phi_2821_ = _e14;
    }
    let _e16 = phi_2821_;
    if _e16 {
        phi_2825_ = param_3;
    } else {
        phi_2825_ = param_2;
    }
    let _e18 = phi_2825_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2801_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_2797_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_2796_ = (param_5[0] > param_4[0]);
        } else {
            phi_2796_ = false;
        }
        let _e14 = phi_2796_;
        phi_2797_ = _e14;
    }
    let _e16 = phi_2797_;
    if _e16 {
        phi_2801_ = param_5;
    } else {
        phi_2801_ = param_4;
    }
    let _e18 = phi_2801_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_2772_: bool;
    var phi_2773_: bool;
    var phi_2777_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_2773_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_2772_ = (param_6[0] > param_7[0]);
        } else {
            phi_2772_ = false;
        }
        let _e14 = phi_2772_;
        phi_2773_ = _e14;
    }
    let _e16 = phi_2773_;
    if _e16 {
        phi_2777_ = param_7;
    } else {
        phi_2777_ = param_6;
    }
    let _e18 = phi_2777_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_2748_: bool;
    var phi_2749_: bool;
    var phi_2753_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_2749_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_2748_ = (param_9[0] > param_8[0]);
        } else {
            phi_2748_ = false;
        }
        let _e14 = phi_2748_;
        phi_2749_ = _e14;
    }
    let _e16 = phi_2749_;
    if _e16 {
        phi_2753_ = param_9;
    } else {
        phi_2753_ = param_8;
    }
    let _e18 = phi_2753_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2729_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_2725_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_2724_ = (param_10[0] > param_11[0]);
        } else {
            phi_2724_ = false;
        }
        let _e14 = phi_2724_;
        phi_2725_ = _e14;
    }
    let _e16 = phi_2725_;
    if _e16 {
        phi_2729_ = param_11;
    } else {
        phi_2729_ = param_10;
    }
    let _e18 = phi_2729_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_165_: u32;
    var phi_177_: array<u32, 2>;
    var phi_209_: u32;
    var phi_210_: u32;
    var phi_218_: u32;
    var phi_234_: u32;
    var phi_255_: u32;
    var phi_256_: u32;
    var phi_259_: type_13;
    var phi_260_: type_13;
    var phi_283_: type_13;
    var phi_324_: u32;
    var phi_325_: u32;
    var phi_333_: u32;
    var phi_345_: u32;
    var phi_430_: array<u32, 2>;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: type_28;
    var phi_645_: bool;
    var phi_652_: type_13;
    var phi_655_: u32;
    var phi_653_: type_13;
    var phi_678_: type_13;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_750_: bool;
    var phi_768_: u32;
    var phi_769_: u32;
    var phi_770_: u32;
    var phi_656_: u32;
    var phi_773_: type_13;
    var phi_776_: u32;
    var phi_774_: type_13;
    var phi_799_: type_13;
    var phi_919_: bool;
    var phi_925_: bool;
    var phi_893_: bool;
    var phi_900_: bool;
    var phi_908_: bool;
    var phi_927_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_978_: bool;
    var phi_985_: bool;
    var phi_989_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1492_: bool;
    var phi_1493_: bool;
    var phi_1586_: bool;
    var phi_1587_: bool;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1593_: bool;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1605_: bool;
    var phi_1624_: type_13;
    var phi_1629_: type_13;
    var phi_1667_: u32;
    var phi_1668_: bool;
    var phi_777_: u32;
    var phi_1669_: bool;
    var phi_1676_: u32;
    var phi_1679_: type_13;
    var phi_1680_: type_13;
    var phi_1703_: type_13;
    var phi_1831_: bool;
    var phi_1837_: bool;
    var phi_1805_: bool;
    var phi_1812_: bool;
    var phi_1820_: bool;
    var phi_1839_: bool;
    var phi_1843_: bool;
    var phi_1844_: bool;
    var phi_1890_: bool;
    var phi_1897_: bool;
    var phi_1901_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2119_: bool;
    var phi_2120_: bool;
    var phi_2214_: bool;
    var phi_2215_: bool;
    var phi_2308_: bool;
    var phi_2309_: bool;
    var phi_2404_: bool;
    var phi_2405_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2517_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2583_: type_13;
    var phi_2584_: type_13;
    var phi_2607_: type_13;
    var phi_2630_: u32;
    var phi_2685_: type_13;
    var phi_2690_: type_13;
    var phi_2704_: bool;
    var phi_2705_: bool;
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
        phi_165_ = _e65;
    } else {
        phi_165_ = _e67;
    }
    let _e70 = phi_165_;
    let _e71 = (_e47 / 32u);
    let _e72 = (_e47 % 32u);
    let _e75 = params.member.member_2.member_1;
    if (_e75 == 0u) {
        phi_177_ = array<u32, 2>(0u, 2u);
    } else {
        phi_177_ = array<u32, 2>(1u, 1u);
    }
    let _e78 = phi_177_;
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
            phi_209_ = (_e93 + 1u);
        } else {
            phi_209_ = _e93;
        }
        let _e99 = phi_209_;
        phi_210_ = _e99;
    } else {
        phi_210_ = 0u;
    }
    let _e101 = phi_210_;
    let _e104 = params.member.member_2.member_4;
    if (_e104 < _e101) {
        phi_218_ = _e104;
    } else {
        phi_218_ = _e101;
    }
    let _e107 = phi_218_;
    let _e108 = (_e107 / 4u);
    if ((_e107 % 4u) > 0u) {
        phi_234_ = (_e108 + 1u);
    } else {
        phi_234_ = _e108;
    }
    let _e113 = phi_234_;
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
            phi_255_ = (_e117 + 1u);
        } else {
            phi_255_ = _e117;
        }
        let _e123 = phi_255_;
        phi_256_ = _e123;
    } else {
        phi_256_ = 0u;
    }
    let _e125 = phi_256_;
    phi_259_ = type_13(0u, _e125);
    loop {
        let _e128 = phi_259_;
        if (_e128.member < _e128.member_1) {
            phi_260_ = type_13((_e128.member + 1u), _e128.member_1);
            phi_283_ = type_13(1u, _e128.member);
        } else {
            phi_260_ = _e128;
            phi_283_ = type_13(0u, type_13().member_1);
        }
        let _e140 = phi_260_;
        let _e142 = phi_283_;
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
                    phi_324_ = (_e163 + 1u);
                } else {
                    phi_324_ = _e163;
                }
                let _e169 = phi_324_;
                phi_325_ = _e169;
            } else {
                phi_325_ = 0u;
            }
            let _e171 = phi_325_;
            let _e174 = params.member.member_2.member_4;
            if (_e174 < _e171) {
                phi_333_ = _e174;
            } else {
                phi_333_ = _e171;
            }
            let _e177 = phi_333_;
            let _e178 = (_e150 < _e177);
            let _e181 = params.member.member_1.member_1;
            if _e178 {
                let _e184 = params.member.member_2.member_3;
                phi_345_ = (_e150 * _e184);
            } else {
                phi_345_ = 0u;
            }
            let _e187 = phi_345_;
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
                phi_430_ = array<u32, 2>(0u, 2u);
            } else {
                phi_430_ = array<u32, 2>(1u, 1u);
            }
            let _e223 = phi_430_;
            let _e226 = (_e47 / 32u);
            let _e227 = (_e47 % 32u);
            let _e231 = params.member.member_2.member_2;
            let _e235 = params.member.member_2.member[_e231][_e223[0]];
            let _e238 = nodes.member[(_e235 + _e192)];
            let _e254 = params.member.member_2.member_2;
            let _e258 = params.member.member_2.member[_e254][_e223[1]];
            let _e261 = nodes.member[(_e258 + _e195)];
            let _e277 = params.member.member_2.member_2;
            let _e284 = params.member.member_2.member[(_e277 - 1u)][_e223[0]];
            let _e287 = nodes.member[(_e284 + ((_e192 * 32u) + _e227))];
            let _e306 = params.member.member_2.member_2;
            let _e313 = params.member.member_2.member[(_e306 - 1u)][_e223[1]];
            let _e316 = nodes.member[(_e313 + ((_e195 * 32u) + _e227))];
            if _e178 {
                if ((((((_e316.member.x <= _e238.member_1.y) && (_e238.member.x <= _e316.member_1.y)) && (_e316.member.y <= _e238.member_2.x)) && (_e238.member.y <= _e316.member_2.x)) && (_e316.member_1.x <= _e238.member_2.y)) && (_e238.member_1.x <= _e316.member_2.y)) {
                    let _e342 = atomicAdd((&counters[_e226]), 1u);
                    let _e343 = ((_e226 * 32u) + _e342);
                    columns[_e343] = type_28(array<f32, 3>(_e316.member.x, _e316.member.y, _e316.member_1.x), array<f32, 3>(_e316.member_1.y, _e316.member_2.x, _e316.member_2.y));
                    names[_e343] = _e227;
                }
            }
            workgroupBarrier();
            if _e178 {
                if ((((((_e287.member.x <= _e261.member_1.y) && (_e261.member.x <= _e287.member_1.y)) && (_e287.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e287.member_2.x)) && (_e287.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e287.member_2.y)) {
                    phi_634_ = false;
                } else {
                    phi_634_ = true;
                }
                let _e361 = phi_634_;
                phi_635_ = _e361;
            } else {
                phi_635_ = true;
            }
            let _e363 = phi_635_;
            if _e363 {
                phi_639_ = type_28(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_639_ = type_28(array<f32, 3>(_e287.member.x, _e287.member.y, _e287.member_1.x), array<f32, 3>(_e287.member_1.y, _e287.member_2.x, _e287.member_2.y));
            }
            let _e365 = phi_639_;
            if (_e78[0] == _e78[1]) {
                phi_645_ = (_e192 == _e195);
            } else {
                phi_645_ = false;
            }
            let _e369 = phi_645_;
            let _e370 = (_e47 / 32u);
            let _e371 = (_e47 % 32u);
            let _e373 = atomicLoad((&counters[_e370]));
            phi_652_ = type_13(0u, _e373);
            phi_655_ = 0u;
            loop {
                let _e376 = phi_652_;
                let _e378 = phi_655_;
                local = _e378;
                if (_e376.member < _e376.member_1) {
                    phi_653_ = type_13((_e376.member + 1u), _e376.member_1);
                    phi_678_ = type_13(1u, _e376.member);
                } else {
                    phi_653_ = _e376;
                    phi_678_ = type_13(0u, type_13().member_1);
                }
                let _e390 = phi_653_;
                let _e392 = phi_678_;
                let _e396 = (bitcast<i32>(_e392.member) != 0i);
                if _e396 {
                    let _e400 = names[((_e370 * 32u) + _e392.member_1)];
                    let _e404 = columns[((_e370 * 32u) + _e392.member_1)];
                    if ((((((_e365.member[0] <= _e404.member_1[0]) && (_e404.member[0] <= _e365.member_1[0])) && (_e365.member[1] <= _e404.member_1[1])) && (_e404.member[1] <= _e365.member_1[1])) && (_e365.member[2] <= _e404.member_1[2])) && (_e404.member[2] <= _e365.member_1[2])) {
                        if _e369 {
                            let _e436 = (_e371 < _e400);
                            if _e436 {
                                phi_744_ = bool();
                            } else {
                                phi_744_ = false;
                            }
                            let _e438 = phi_744_;
                            phi_745_ = _e438;
                            phi_746_ = _e436;
                        } else {
                            phi_745_ = bool();
                            phi_746_ = true;
                        }
                        let _e440 = phi_745_;
                        let _e442 = phi_746_;
                        if _e442 {
                            phi_750_ = true;
                        } else {
                            phi_750_ = _e440;
                        }
                        let _e444 = phi_750_;
                        if _e444 {
                            let _e446 = atomicAdd((&counters[4u]), 1u);
                            if (_e446 < 2048u) {
                                hits[_e446] = (((_e370 << bitcast<u32>(10i)) | (_e371 << bitcast<u32>(5i))) | _e400);
                                phi_768_ = _e378;
                            } else {
                                phi_768_ = (_e378 | (1u << bitcast<u32>((_e392.member_1 & 31u))));
                            }
                            let _e460 = phi_768_;
                            phi_769_ = _e460;
                        } else {
                            phi_769_ = _e378;
                        }
                        let _e462 = phi_769_;
                        phi_770_ = _e462;
                    } else {
                        phi_770_ = _e378;
                    }
                    let _e464 = phi_770_;
                    phi_656_ = _e464;
                } else {
                    phi_656_ = u32();
                }
                let _e466 = phi_656_;
                continue;
                continuing {
                    phi_652_ = _e390;
                    phi_655_ = _e466;
                    break if !(_e396);
                }
            }
            phi_773_ = type_13(0u, 32u);
            let _e1630 = local;
            phi_776_ = _e1630;
            loop {
                let _e469 = phi_773_;
                let _e471 = phi_776_;
                if (_e469.member < _e469.member_1) {
                    phi_774_ = type_13((_e469.member + 1u), _e469.member_1);
                    phi_799_ = type_13(1u, _e469.member);
                } else {
                    phi_774_ = _e469;
                    phi_799_ = type_13(0u, type_13().member_1);
                }
                let _e483 = phi_774_;
                let _e485 = phi_799_;
                if (bitcast<i32>(_e485.member) != 0i) {
                    if (_e471 == 0u) {
                        phi_1667_ = u32();
                        phi_1668_ = false;
                    } else {
                        let _e496 = names[((_e71 * 32u) + select(firstTrailingBit(_e471), 32u, (_e471 == 0u)))];
                        let _e499 = (_e204 + _e72);
                        let _e500 = (_e211 + _e496);
                        let _e502 = leaves.member[_e499];
                        let _e504 = leaves.member[_e500];
                        let _e506 = nodes.member[_e499];
                        let _e520 = nodes.member[_e500];
                        let _e535 = params.member.member.member_1;
                        if ((_e535 & 1u) != 0u) {
                            if (_e75 == 0u) {
                                if (_e504.member[0] == _e502.member[0]) {
                                    phi_893_ = true;
                                } else {
                                    phi_893_ = (_e504.member[0] == _e502.member[0]);
                                }
                                let _e563 = phi_893_;
                                if (_e504.member[1] == _e502.member[0]) {
                                    phi_900_ = true;
                                } else {
                                    phi_900_ = (_e504.member[1] == _e502.member[0]);
                                }
                                let _e568 = phi_900_;
                                if (_e504.member[2] == _e502.member[0]) {
                                    phi_908_ = true;
                                } else {
                                    phi_908_ = (_e504.member[2] == _e502.member[0]);
                                }
                                let _e574 = phi_908_;
                                phi_927_ = ((_e563 || _e568) || _e574);
                            } else {
                                if (_e504.member[0] == _e502.member[0]) {
                                    phi_919_ = true;
                                } else {
                                    phi_919_ = (_e504.member[0] == _e502.member[1]);
                                }
                                let _e550 = phi_919_;
                                if (_e504.member[1] == _e502.member[0]) {
                                    phi_925_ = true;
                                } else {
                                    phi_925_ = (_e504.member[1] == _e502.member[1]);
                                }
                                let _e554 = phi_925_;
                                phi_927_ = (_e550 || _e554);
                            }
                            let _e577 = phi_927_;
                            if _e577 {
                                phi_931_ = false;
                            } else {
                                phi_931_ = true;
                            }
                            let _e579 = phi_931_;
                            phi_932_ = _e579;
                        } else {
                            phi_932_ = true;
                        }
                        let _e581 = phi_932_;
                        if _e581 {
                            let _e583 = params.member.member.member_1;
                            if ((_e583 & 2u) != 0u) {
                                let _e587 = params.member.member.member_1;
                                let _e593 = bodies.member[_e502.member[0]];
                                let _e597 = bodies.member[_e504.member[0]];
                                if ((_e593 / 2u) != (_e597 / 2u)) {
                                    phi_978_ = true;
                                } else {
                                    phi_978_ = ((_e587 & 4u) != 0u);
                                }
                                let _e602 = phi_978_;
                                if _e602 {
                                    phi_985_ = (((_e593 & _e597) & 1u) == 0u);
                                } else {
                                    phi_985_ = false;
                                }
                                let _e607 = phi_985_;
                                phi_989_ = _e607;
                            } else {
                                phi_989_ = true;
                            }
                            let _e609 = phi_989_;
                            if _e609 {
                                let _e611 = params.member.member.member_1;
                                if ((_e611 & 32u) != 0u) {
                                    let _e615 = params.member.member.member_6;
                                    let _e632 = (((((_e506.member_1.y - _e520.member.x) > _e615) && ((_e520.member_1.y - _e506.member.x) > _e615)) && (((_e506.member_2.x - _e520.member.y) > _e615) && ((_e520.member_2.x - _e506.member.y) > _e615))) && (((_e506.member_2.y - _e520.member_1.x) > _e615) && ((_e520.member_2.y - _e506.member_1.x) > _e615)));
                                    if _e632 {
                                        phi_1591_ = bool();
                                    } else {
                                        let _e636 = keys.member[_e502.member[0]];
                                        let _e641 = keys.member[_e502.member[1]];
                                        let _e643 = function_5(_e636[0], _e641[0]);
                                        let _e647 = keys.member[_e502.member[2]];
                                        let _e649 = function_5(_e643, _e647[0]);
                                        let _e653 = keys.member[_e504.member[0]];
                                        let _e658 = keys.member[_e504.member[1]];
                                        let _e660 = function_4(_e653[3], _e658[3]);
                                        let _e664 = keys.member[_e504.member[2]];
                                        let _e666 = function_4(_e660, _e664[3]);
                                        if (_e649[1] > _e666[1]) {
                                            phi_1114_ = true;
                                        } else {
                                            if (_e649[1] == _e666[1]) {
                                                phi_1113_ = (_e649[0] > _e666[0]);
                                            } else {
                                                phi_1113_ = false;
                                            }
                                            let _e677 = phi_1113_;
                                            phi_1114_ = _e677;
                                        }
                                        let _e679 = phi_1114_;
                                        let _e684 = keys.member[_e504.member[0]];
                                        let _e689 = keys.member[_e504.member[1]];
                                        let _e691 = function_5(_e684[0], _e689[0]);
                                        let _e695 = keys.member[_e504.member[2]];
                                        let _e697 = function_5(_e691, _e695[0]);
                                        let _e701 = keys.member[_e502.member[0]];
                                        let _e706 = keys.member[_e502.member[1]];
                                        let _e708 = function_4(_e701[3], _e706[3]);
                                        let _e712 = keys.member[_e502.member[2]];
                                        let _e714 = function_4(_e708, _e712[3]);
                                        if (_e697[1] > _e714[1]) {
                                            phi_1208_ = true;
                                        } else {
                                            if (_e697[1] == _e714[1]) {
                                                phi_1207_ = (_e697[0] > _e714[0]);
                                            } else {
                                                phi_1207_ = false;
                                            }
                                            let _e725 = phi_1207_;
                                            phi_1208_ = _e725;
                                        }
                                        let _e727 = phi_1208_;
                                        let _e733 = keys.member[_e502.member[0]];
                                        let _e738 = keys.member[_e502.member[1]];
                                        let _e740 = function_3(_e733[1], _e738[1]);
                                        let _e744 = keys.member[_e502.member[2]];
                                        let _e746 = function_3(_e740, _e744[1]);
                                        let _e750 = keys.member[_e504.member[0]];
                                        let _e755 = keys.member[_e504.member[1]];
                                        let _e757 = function_2(_e750[4], _e755[4]);
                                        let _e761 = keys.member[_e504.member[2]];
                                        let _e763 = function_2(_e757, _e761[4]);
                                        if (_e746[1] > _e763[1]) {
                                            phi_1303_ = true;
                                        } else {
                                            if (_e746[1] == _e763[1]) {
                                                phi_1302_ = (_e746[0] > _e763[0]);
                                            } else {
                                                phi_1302_ = false;
                                            }
                                            let _e774 = phi_1302_;
                                            phi_1303_ = _e774;
                                        }
                                        let _e776 = phi_1303_;
                                        let _e781 = keys.member[_e504.member[0]];
                                        let _e786 = keys.member[_e504.member[1]];
                                        let _e788 = function_3(_e781[1], _e786[1]);
                                        let _e792 = keys.member[_e504.member[2]];
                                        let _e794 = function_3(_e788, _e792[1]);
                                        let _e798 = keys.member[_e502.member[0]];
                                        let _e803 = keys.member[_e502.member[1]];
                                        let _e805 = function_2(_e798[4], _e803[4]);
                                        let _e809 = keys.member[_e502.member[2]];
                                        let _e811 = function_2(_e805, _e809[4]);
                                        if (_e794[1] > _e811[1]) {
                                            phi_1397_ = true;
                                        } else {
                                            if (_e794[1] == _e811[1]) {
                                                phi_1396_ = (_e794[0] > _e811[0]);
                                            } else {
                                                phi_1396_ = false;
                                            }
                                            let _e822 = phi_1396_;
                                            phi_1397_ = _e822;
                                        }
                                        let _e824 = phi_1397_;
                                        let _e831 = keys.member[_e502.member[0]];
                                        let _e836 = keys.member[_e502.member[1]];
                                        let _e838 = function_1(_e831[2], _e836[2]);
                                        let _e842 = keys.member[_e502.member[2]];
                                        let _e844 = function_1(_e838, _e842[2]);
                                        let _e848 = keys.member[_e504.member[0]];
                                        let _e853 = keys.member[_e504.member[1]];
                                        let _e855 = function_(_e848[5], _e853[5]);
                                        let _e859 = keys.member[_e504.member[2]];
                                        let _e861 = function_(_e855, _e859[5]);
                                        if (_e844[1] > _e861[1]) {
                                            phi_1493_ = true;
                                        } else {
                                            if (_e844[1] == _e861[1]) {
                                                phi_1492_ = (_e844[0] > _e861[0]);
                                            } else {
                                                phi_1492_ = false;
                                            }
                                            let _e872 = phi_1492_;
                                            phi_1493_ = _e872;
                                        }
                                        let _e874 = phi_1493_;
                                        let _e879 = keys.member[_e504.member[0]];
                                        let _e884 = keys.member[_e504.member[1]];
                                        let _e886 = function_1(_e879[2], _e884[2]);
                                        let _e890 = keys.member[_e504.member[2]];
                                        let _e892 = function_1(_e886, _e890[2]);
                                        let _e896 = keys.member[_e502.member[0]];
                                        let _e901 = keys.member[_e502.member[1]];
                                        let _e903 = function_(_e896[5], _e901[5]);
                                        let _e907 = keys.member[_e502.member[2]];
                                        let _e909 = function_(_e903, _e907[5]);
                                        if (_e892[1] > _e909[1]) {
                                            phi_1587_ = true;
                                        } else {
                                            if (_e892[1] == _e909[1]) {
                                                phi_1586_ = (_e892[0] > _e909[0]);
                                            } else {
                                                phi_1586_ = false;
                                            }
                                            let _e920 = phi_1586_;
                                            phi_1587_ = _e920;
                                        }
                                        let _e922 = phi_1587_;
                                        phi_1591_ = (((!(_e679) && !(_e727)) && (!(_e776) && !(_e824))) && (!(_e874) && !(_e922)));
                                    }
                                    let _e927 = phi_1591_;
                                    phi_1592_ = _e927;
                                    phi_1593_ = _e632;
                                } else {
                                    phi_1592_ = bool();
                                    phi_1593_ = true;
                                }
                                let _e929 = phi_1592_;
                                let _e931 = phi_1593_;
                                if _e931 {
                                    phi_1597_ = false;
                                } else {
                                    phi_1597_ = true;
                                }
                                let _e933 = phi_1597_;
                                phi_1598_ = _e929;
                                phi_1599_ = _e933;
                            } else {
                                phi_1598_ = false;
                                phi_1599_ = true;
                            }
                            let _e935 = phi_1598_;
                            let _e937 = phi_1599_;
                            phi_1600_ = _e935;
                            phi_1601_ = _e937;
                        } else {
                            phi_1600_ = false;
                            phi_1601_ = true;
                        }
                        let _e939 = phi_1600_;
                        let _e941 = phi_1601_;
                        if _e941 {
                            phi_1605_ = _e939;
                        } else {
                            phi_1605_ = true;
                        }
                        let _e943 = phi_1605_;
                        if _e943 {
                            let _e946 = params.member.member_1.member_3;
                            if (_e78[0] == _e78[1]) {
                                if (_e502.member_1 < _e504.member_1) {
                                    phi_1624_ = type_13(_e502.member_1, _e504.member_1);
                                } else {
                                    phi_1624_ = type_13(_e504.member_1, _e502.member_1);
                                }
                                let _e955 = phi_1624_;
                                phi_1629_ = _e955;
                            } else {
                                phi_1629_ = type_13(_e502.member_1, _e504.member_1);
                            }
                            let _e957 = phi_1629_;
                            let _e961 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e961 + 1u) < _e961) {
                                let _e965 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e961 < _e946) {
                                let _e967 = (2u * _e961);
                                atomicStore((&output.member[(4u + _e967)]), _e957.member);
                                atomicStore((&output.member[(_e967 + 5u)]), _e957.member_1);
                            }
                            let _e973 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e973 + 1u) < _e973) {
                                let _e977 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_1667_ = (_e471 & (_e471 - 1u));
                        phi_1668_ = true;
                    }
                    let _e979 = phi_1667_;
                    let _e981 = phi_1668_;
                    phi_777_ = _e979;
                    phi_1669_ = _e981;
                } else {
                    phi_777_ = u32();
                    phi_1669_ = false;
                }
                let _e983 = phi_777_;
                let _e985 = phi_1669_;
                continue;
                continuing {
                    phi_773_ = _e483;
                    phi_776_ = _e983;
                    break if !(_e985);
                }
            }
            workgroupBarrier();
            let _e988 = atomicLoad((&counters[4u]));
            if (2048u < _e988) {
                phi_1676_ = 2048u;
            } else {
                phi_1676_ = _e988;
            }
            let _e991 = phi_1676_;
            phi_1679_ = type_13(0u, 16u);
            loop {
                let _e993 = phi_1679_;
                if (_e993.member < _e993.member_1) {
                    phi_1680_ = type_13((_e993.member + 1u), _e993.member_1);
                    phi_1703_ = type_13(1u, _e993.member);
                } else {
                    phi_1680_ = _e993;
                    phi_1703_ = type_13(0u, type_13().member_1);
                }
                let _e1005 = phi_1680_;
                let _e1007 = phi_1703_;
                if (bitcast<i32>(_e1007.member) != 0i) {
                    let _e1013 = (_e47 + (_e1007.member_1 * 128u));
                    if (_e1013 >= _e991) {
                        phi_2532_ = false;
                    } else {
                        let _e1016 = hits[_e1013];
                        let _e1019 = ((_e1016 >> bitcast<u32>(10i)) & 3u);
                        let _e1026 = firsts[(2u * _e1019)];
                        let _e1027 = (_e1026 + ((_e1016 >> bitcast<u32>(5i)) & 31u));
                        let _e1031 = firsts[((2u * _e1019) + 1u)];
                        let _e1032 = (_e1031 + (_e1016 & 31u));
                        let _e1034 = leaves.member[_e1027];
                        let _e1036 = leaves.member[_e1032];
                        let _e1038 = nodes.member[_e1027];
                        let _e1052 = nodes.member[_e1032];
                        let _e1067 = params.member.member.member_1;
                        if ((_e1067 & 1u) != 0u) {
                            if (_e75 == 0u) {
                                if (_e1036.member[0] == _e1034.member[0]) {
                                    phi_1805_ = true;
                                } else {
                                    phi_1805_ = (_e1036.member[0] == _e1034.member[0]);
                                }
                                let _e1095 = phi_1805_;
                                if (_e1036.member[1] == _e1034.member[0]) {
                                    phi_1812_ = true;
                                } else {
                                    phi_1812_ = (_e1036.member[1] == _e1034.member[0]);
                                }
                                let _e1100 = phi_1812_;
                                if (_e1036.member[2] == _e1034.member[0]) {
                                    phi_1820_ = true;
                                } else {
                                    phi_1820_ = (_e1036.member[2] == _e1034.member[0]);
                                }
                                let _e1106 = phi_1820_;
                                phi_1839_ = ((_e1095 || _e1100) || _e1106);
                            } else {
                                if (_e1036.member[0] == _e1034.member[0]) {
                                    phi_1831_ = true;
                                } else {
                                    phi_1831_ = (_e1036.member[0] == _e1034.member[1]);
                                }
                                let _e1082 = phi_1831_;
                                if (_e1036.member[1] == _e1034.member[0]) {
                                    phi_1837_ = true;
                                } else {
                                    phi_1837_ = (_e1036.member[1] == _e1034.member[1]);
                                }
                                let _e1086 = phi_1837_;
                                phi_1839_ = (_e1082 || _e1086);
                            }
                            let _e1109 = phi_1839_;
                            if _e1109 {
                                phi_1843_ = false;
                            } else {
                                phi_1843_ = true;
                            }
                            let _e1111 = phi_1843_;
                            phi_1844_ = _e1111;
                        } else {
                            phi_1844_ = true;
                        }
                        let _e1113 = phi_1844_;
                        if _e1113 {
                            let _e1115 = params.member.member.member_1;
                            if ((_e1115 & 2u) != 0u) {
                                let _e1119 = params.member.member.member_1;
                                let _e1125 = bodies.member[_e1034.member[0]];
                                let _e1129 = bodies.member[_e1036.member[0]];
                                if ((_e1125 / 2u) != (_e1129 / 2u)) {
                                    phi_1890_ = true;
                                } else {
                                    phi_1890_ = ((_e1119 & 4u) != 0u);
                                }
                                let _e1134 = phi_1890_;
                                if _e1134 {
                                    phi_1897_ = (((_e1125 & _e1129) & 1u) == 0u);
                                } else {
                                    phi_1897_ = false;
                                }
                                let _e1139 = phi_1897_;
                                phi_1901_ = _e1139;
                            } else {
                                phi_1901_ = true;
                            }
                            let _e1141 = phi_1901_;
                            if _e1141 {
                                let _e1143 = params.member.member.member_1;
                                if ((_e1143 & 32u) != 0u) {
                                    let _e1147 = params.member.member.member_6;
                                    let _e1164 = (((((_e1038.member_1.y - _e1052.member.x) > _e1147) && ((_e1052.member_1.y - _e1038.member.x) > _e1147)) && (((_e1038.member_2.x - _e1052.member.y) > _e1147) && ((_e1052.member_2.x - _e1038.member.y) > _e1147))) && (((_e1038.member_2.y - _e1052.member_1.x) > _e1147) && ((_e1052.member_2.y - _e1038.member_1.x) > _e1147)));
                                    if _e1164 {
                                        phi_2503_ = bool();
                                    } else {
                                        let _e1168 = keys.member[_e1034.member[0]];
                                        let _e1173 = keys.member[_e1034.member[1]];
                                        let _e1175 = function_5(_e1168[0], _e1173[0]);
                                        let _e1179 = keys.member[_e1034.member[2]];
                                        let _e1181 = function_5(_e1175, _e1179[0]);
                                        let _e1185 = keys.member[_e1036.member[0]];
                                        let _e1190 = keys.member[_e1036.member[1]];
                                        let _e1192 = function_4(_e1185[3], _e1190[3]);
                                        let _e1196 = keys.member[_e1036.member[2]];
                                        let _e1198 = function_4(_e1192, _e1196[3]);
                                        if (_e1181[1] > _e1198[1]) {
                                            phi_2026_ = true;
                                        } else {
                                            if (_e1181[1] == _e1198[1]) {
                                                phi_2025_ = (_e1181[0] > _e1198[0]);
                                            } else {
                                                phi_2025_ = false;
                                            }
                                            let _e1209 = phi_2025_;
                                            phi_2026_ = _e1209;
                                        }
                                        let _e1211 = phi_2026_;
                                        let _e1216 = keys.member[_e1036.member[0]];
                                        let _e1221 = keys.member[_e1036.member[1]];
                                        let _e1223 = function_5(_e1216[0], _e1221[0]);
                                        let _e1227 = keys.member[_e1036.member[2]];
                                        let _e1229 = function_5(_e1223, _e1227[0]);
                                        let _e1233 = keys.member[_e1034.member[0]];
                                        let _e1238 = keys.member[_e1034.member[1]];
                                        let _e1240 = function_4(_e1233[3], _e1238[3]);
                                        let _e1244 = keys.member[_e1034.member[2]];
                                        let _e1246 = function_4(_e1240, _e1244[3]);
                                        if (_e1229[1] > _e1246[1]) {
                                            phi_2120_ = true;
                                        } else {
                                            if (_e1229[1] == _e1246[1]) {
                                                phi_2119_ = (_e1229[0] > _e1246[0]);
                                            } else {
                                                phi_2119_ = false;
                                            }
                                            let _e1257 = phi_2119_;
                                            phi_2120_ = _e1257;
                                        }
                                        let _e1259 = phi_2120_;
                                        let _e1265 = keys.member[_e1034.member[0]];
                                        let _e1270 = keys.member[_e1034.member[1]];
                                        let _e1272 = function_3(_e1265[1], _e1270[1]);
                                        let _e1276 = keys.member[_e1034.member[2]];
                                        let _e1278 = function_3(_e1272, _e1276[1]);
                                        let _e1282 = keys.member[_e1036.member[0]];
                                        let _e1287 = keys.member[_e1036.member[1]];
                                        let _e1289 = function_2(_e1282[4], _e1287[4]);
                                        let _e1293 = keys.member[_e1036.member[2]];
                                        let _e1295 = function_2(_e1289, _e1293[4]);
                                        if (_e1278[1] > _e1295[1]) {
                                            phi_2215_ = true;
                                        } else {
                                            if (_e1278[1] == _e1295[1]) {
                                                phi_2214_ = (_e1278[0] > _e1295[0]);
                                            } else {
                                                phi_2214_ = false;
                                            }
                                            let _e1306 = phi_2214_;
                                            phi_2215_ = _e1306;
                                        }
                                        let _e1308 = phi_2215_;
                                        let _e1313 = keys.member[_e1036.member[0]];
                                        let _e1318 = keys.member[_e1036.member[1]];
                                        let _e1320 = function_3(_e1313[1], _e1318[1]);
                                        let _e1324 = keys.member[_e1036.member[2]];
                                        let _e1326 = function_3(_e1320, _e1324[1]);
                                        let _e1330 = keys.member[_e1034.member[0]];
                                        let _e1335 = keys.member[_e1034.member[1]];
                                        let _e1337 = function_2(_e1330[4], _e1335[4]);
                                        let _e1341 = keys.member[_e1034.member[2]];
                                        let _e1343 = function_2(_e1337, _e1341[4]);
                                        if (_e1326[1] > _e1343[1]) {
                                            phi_2309_ = true;
                                        } else {
                                            if (_e1326[1] == _e1343[1]) {
                                                phi_2308_ = (_e1326[0] > _e1343[0]);
                                            } else {
                                                phi_2308_ = false;
                                            }
                                            let _e1354 = phi_2308_;
                                            phi_2309_ = _e1354;
                                        }
                                        let _e1356 = phi_2309_;
                                        let _e1363 = keys.member[_e1034.member[0]];
                                        let _e1368 = keys.member[_e1034.member[1]];
                                        let _e1370 = function_1(_e1363[2], _e1368[2]);
                                        let _e1374 = keys.member[_e1034.member[2]];
                                        let _e1376 = function_1(_e1370, _e1374[2]);
                                        let _e1380 = keys.member[_e1036.member[0]];
                                        let _e1385 = keys.member[_e1036.member[1]];
                                        let _e1387 = function_(_e1380[5], _e1385[5]);
                                        let _e1391 = keys.member[_e1036.member[2]];
                                        let _e1393 = function_(_e1387, _e1391[5]);
                                        if (_e1376[1] > _e1393[1]) {
                                            phi_2405_ = true;
                                        } else {
                                            if (_e1376[1] == _e1393[1]) {
                                                phi_2404_ = (_e1376[0] > _e1393[0]);
                                            } else {
                                                phi_2404_ = false;
                                            }
                                            let _e1404 = phi_2404_;
                                            phi_2405_ = _e1404;
                                        }
                                        let _e1406 = phi_2405_;
                                        let _e1411 = keys.member[_e1036.member[0]];
                                        let _e1416 = keys.member[_e1036.member[1]];
                                        let _e1418 = function_1(_e1411[2], _e1416[2]);
                                        let _e1422 = keys.member[_e1036.member[2]];
                                        let _e1424 = function_1(_e1418, _e1422[2]);
                                        let _e1428 = keys.member[_e1034.member[0]];
                                        let _e1433 = keys.member[_e1034.member[1]];
                                        let _e1435 = function_(_e1428[5], _e1433[5]);
                                        let _e1439 = keys.member[_e1034.member[2]];
                                        let _e1441 = function_(_e1435, _e1439[5]);
                                        if (_e1424[1] > _e1441[1]) {
                                            phi_2499_ = true;
                                        } else {
                                            if (_e1424[1] == _e1441[1]) {
                                                phi_2498_ = (_e1424[0] > _e1441[0]);
                                            } else {
                                                phi_2498_ = false;
                                            }
                                            let _e1452 = phi_2498_;
                                            phi_2499_ = _e1452;
                                        }
                                        let _e1454 = phi_2499_;
                                        phi_2503_ = (((!(_e1211) && !(_e1259)) && (!(_e1308) && !(_e1356))) && (!(_e1406) && !(_e1454)));
                                    }
                                    let _e1459 = phi_2503_;
                                    phi_2504_ = _e1459;
                                    phi_2505_ = _e1164;
                                } else {
                                    phi_2504_ = bool();
                                    phi_2505_ = true;
                                }
                                let _e1461 = phi_2504_;
                                let _e1463 = phi_2505_;
                                if _e1463 {
                                    phi_2509_ = false;
                                } else {
                                    phi_2509_ = true;
                                }
                                let _e1465 = phi_2509_;
                                phi_2510_ = _e1461;
                                phi_2511_ = _e1465;
                            } else {
                                phi_2510_ = false;
                                phi_2511_ = true;
                            }
                            let _e1467 = phi_2510_;
                            let _e1469 = phi_2511_;
                            phi_2512_ = _e1467;
                            phi_2513_ = _e1469;
                        } else {
                            phi_2512_ = false;
                            phi_2513_ = true;
                        }
                        let _e1471 = phi_2512_;
                        let _e1473 = phi_2513_;
                        if _e1473 {
                            phi_2517_ = _e1471;
                        } else {
                            phi_2517_ = true;
                        }
                        let _e1475 = phi_2517_;
                        if _e1475 {
                            let _e1477 = atomicAdd((&counters[7u]), 1u);
                            let _e1479 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1013] = ((2147483648u | (_e1479 << bitcast<u32>(12i))) | _e1016);
                        }
                        phi_2532_ = true;
                    }
                    let _e1486 = phi_2532_;
                    phi_2533_ = _e1486;
                } else {
                    phi_2533_ = false;
                }
                let _e1488 = phi_2533_;
                continue;
                continuing {
                    phi_1679_ = _e1005;
                    break if !(_e1488);
                }
            }
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e1492 = atomicLoad((&counters[5u]));
                if (_e1492 > 0u) {
                    let _e1495 = atomicAdd((&output.member[0u]), _e1492);
                    if ((_e1495 + _e1492) < _e1495) {
                        let _e1499 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1495);
                }
            }
            workgroupBarrier();
            let _e1502 = atomicLoad((&counters[6u]));
            if (_e47 == 0u) {
                let _e1505 = atomicLoad((&counters[7u]));
                if (_e1505 > 0u) {
                    let _e1508 = atomicAdd((&output.member[1u]), _e1505);
                    if ((_e1508 + _e1505) < _e1508) {
                        let _e1512 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_2583_ = type_13(0u, 16u);
            loop {
                let _e1514 = phi_2583_;
                if (_e1514.member < _e1514.member_1) {
                    phi_2584_ = type_13((_e1514.member + 1u), _e1514.member_1);
                    phi_2607_ = type_13(1u, _e1514.member);
                } else {
                    phi_2584_ = _e1514;
                    phi_2607_ = type_13(0u, type_13().member_1);
                }
                let _e1526 = phi_2584_;
                let _e1528 = phi_2607_;
                if (bitcast<i32>(_e1528.member) != 0i) {
                    let _e1534 = (_e47 + (_e1528.member_1 * 128u));
                    if (_e1534 >= _e991) {
                        phi_2704_ = false;
                    } else {
                        let _e1537 = hits[_e1534];
                        if ((_e1537 & 2147483648u) == 0u) {
                            phi_2630_ = 4294967295u;
                        } else {
                            phi_2630_ = ((_e1537 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1544 = phi_2630_;
                        if (_e1544 != 4294967295u) {
                            let _e1548 = ((_e1537 >> bitcast<u32>(10i)) & 3u);
                            let _e1555 = firsts[(2u * _e1548)];
                            let _e1558 = leaves.member[(_e1555 + ((_e1537 >> bitcast<u32>(5i)) & 31u))];
                            let _e1562 = firsts[((2u * _e1548) + 1u)];
                            let _e1565 = leaves.member[(_e1562 + (_e1537 & 31u))];
                            let _e1570 = params.member.member_1.member_3;
                            let _e1571 = (_e1502 + _e1544);
                            if (_e78[0] == _e78[1]) {
                                if (_e1558.member_1 < _e1565.member_1) {
                                    phi_2685_ = type_13(_e1558.member_1, _e1565.member_1);
                                } else {
                                    phi_2685_ = type_13(_e1565.member_1, _e1558.member_1);
                                }
                                let _e1578 = phi_2685_;
                                phi_2690_ = _e1578;
                            } else {
                                phi_2690_ = type_13(_e1558.member_1, _e1565.member_1);
                            }
                            let _e1580 = phi_2690_;
                            if (_e1571 < _e1570) {
                                let _e1584 = (2u * _e1571);
                                atomicStore((&output.member[(4u + _e1584)]), _e1580.member);
                                atomicStore((&output.member[(_e1584 + 5u)]), _e1580.member_1);
                            }
                        }
                        phi_2704_ = true;
                    }
                    let _e1590 = phi_2704_;
                    phi_2705_ = _e1590;
                } else {
                    phi_2705_ = false;
                }
                let _e1592 = phi_2705_;
                continue;
                continuing {
                    phi_2583_ = _e1526;
                    break if !(_e1592);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_259_ = _e140;
            break if !(_e146);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
