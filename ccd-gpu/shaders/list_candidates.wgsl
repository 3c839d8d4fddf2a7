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

struct type_21 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_23 {
    member: array<type_21>,
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

struct type_35 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(6) 
var<storage, read_write> output: type_39;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_35;
@group(0) @binding(5) 
var<storage> input: type_11;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_3599_: bool;
    var phi_3600_: bool;
    var phi_3604_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_3600_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_3599_ = (param_1[0] > param[0]);
        } else {
            phi_3599_ = false;
        }
        let _e14 = phi_3599_;
        phi_3600_ = _e14;
    }
    let _e16 = phi_3600_;
    if _e16 {
        phi_3604_ = param_1;
    } else {
        phi_3604_ = param;
    }
    let _e18 = phi_3604_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_3575_: bool;
    var phi_3576_: bool;
    var phi_3580_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_3576_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_3575_ = (param_2[0] > param_3[0]);
        } else {
            phi_3575_ = false;
        }
        let _e14 = phi_3575_;
        phi_3576_ = _e14;
    }
    let _e16 = phi_3576_;
    if _e16 {
        phi_3580_ = param_3;
    } else {
        phi_3580_ = param_2;
    }
    let _e18 = phi_3580_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_3551_: bool;
    var phi_3552_: bool;
    var phi_3556_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_3552_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_3551_ = (param_5[0] > param_4[0]);
        } else {
            phi_3551_ = false;
        }
        let _e14 = phi_3551_;
        phi_3552_ = _e14;
    }
    let _e16 = phi_3552_;
    if _e16 {
        phi_3556_ = param_5;
    } else {
        phi_3556_ = param_4;
    }
    let _e18 = phi_3556_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_3527_: bool;
    var phi_3528_: bool;
    var phi_3532_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_3528_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_3527_ = (param_6[0] > param_7[0]);
        } else {
            phi_3527_ = false;
        }
        let _e14 = phi_3527_;
        phi_3528_ = _e14;
    }
    let _e16 = phi_3528_;
    if _e16 {
        phi_3532_ = param_7;
    } else {
        phi_3532_ = param_6;
    }
    let _e18 = phi_3532_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3508_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_3504_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_3503_ = (param_9[0] > param_8[0]);
        } else {
            phi_3503_ = false;
        }
        let _e14 = phi_3503_;
        phi_3504_ = _e14;
    }
    let _e16 = phi_3504_;
    if _e16 {
        phi_3508_ = param_9;
    } else {
        phi_3508_ = param_8;
    }
    let _e18 = phi_3508_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_3479_: bool;
    var phi_3480_: bool;
    var phi_3484_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_3480_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_3479_ = (param_10[0] > param_11[0]);
        } else {
            phi_3479_ = false;
        }
        let _e14 = phi_3479_;
        phi_3480_ = _e14;
    }
    let _e16 = phi_3480_;
    if _e16 {
        phi_3484_ = param_11;
    } else {
        phi_3484_ = param_10;
    }
    let _e18 = phi_3484_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_172_: u32;
    var phi_184_: array<u32, 2>;
    var phi_216_: u32;
    var phi_217_: u32;
    var phi_225_: u32;
    var phi_241_: u32;
    var phi_262_: u32;
    var phi_263_: u32;
    var phi_266_: type_9;
    var phi_267_: type_9;
    var phi_290_: type_9;
    var phi_331_: u32;
    var phi_332_: u32;
    var phi_340_: u32;
    var phi_352_: u32;
    var phi_437_: array<u32, 2>;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_646_: type_29;
    var phi_652_: bool;
    var phi_659_: type_9;
    var phi_662_: u32;
    var phi_660_: type_9;
    var phi_685_: type_9;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_800_: u32;
    var phi_801_: u32;
    var phi_663_: u32;
    var phi_804_: type_9;
    var phi_807_: u32;
    var phi_805_: type_9;
    var phi_830_: type_9;
    var phi_950_: bool;
    var phi_956_: bool;
    var phi_924_: bool;
    var phi_931_: bool;
    var phi_939_: bool;
    var phi_958_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1015_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1169_: u32;
    var phi_1170_: u32;
    var phi_1171_: u32;
    var phi_1172_: u32;
    var phi_1175_: type_15;
    var phi_1178_: u32;
    var phi_1180_: u32;
    var phi_1201_: bool;
    var phi_1207_: type_16;
    var phi_1176_: type_15;
    var phi_1221_: type_16;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1302_: u32;
    var phi_1303_: u32;
    var phi_1304_: u32;
    var phi_1305_: u32;
    var phi_1306_: bool;
    var phi_1179_: u32;
    var phi_1181_: u32;
    var phi_1307_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1367_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1381_: bool;
    var phi_1382_: bool;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1885_: bool;
    var phi_1886_: bool;
    var phi_1979_: bool;
    var phi_1980_: bool;
    var phi_1984_: bool;
    var phi_1985_: bool;
    var phi_1986_: bool;
    var phi_1990_: bool;
    var phi_1991_: bool;
    var phi_1992_: bool;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_1998_: bool;
    var phi_2014_: type_9;
    var phi_2019_: type_9;
    var phi_2060_: u32;
    var phi_2061_: bool;
    var phi_808_: u32;
    var phi_2062_: bool;
    var phi_2069_: u32;
    var phi_2072_: type_9;
    var phi_2073_: type_9;
    var phi_2096_: type_9;
    var phi_2224_: bool;
    var phi_2230_: bool;
    var phi_2198_: bool;
    var phi_2205_: bool;
    var phi_2213_: bool;
    var phi_2232_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2281_: bool;
    var phi_2282_: bool;
    var phi_2289_: bool;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2443_: u32;
    var phi_2444_: u32;
    var phi_2445_: u32;
    var phi_2446_: u32;
    var phi_2449_: type_15;
    var phi_2452_: u32;
    var phi_2454_: u32;
    var phi_2475_: bool;
    var phi_2481_: type_16;
    var phi_2450_: type_15;
    var phi_2495_: type_16;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2565_: bool;
    var phi_2566_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2576_: u32;
    var phi_2577_: u32;
    var phi_2578_: u32;
    var phi_2579_: u32;
    var phi_2580_: bool;
    var phi_2453_: u32;
    var phi_2455_: u32;
    var phi_2581_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2632_: bool;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2641_: bool;
    var phi_2645_: bool;
    var phi_2646_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2780_: bool;
    var phi_2781_: bool;
    var phi_2874_: bool;
    var phi_2875_: bool;
    var phi_2969_: bool;
    var phi_2970_: bool;
    var phi_3063_: bool;
    var phi_3064_: bool;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3253_: bool;
    var phi_3254_: bool;
    var phi_3258_: bool;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3272_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3338_: type_9;
    var phi_3339_: type_9;
    var phi_3362_: type_9;
    var phi_3385_: u32;
    var phi_3440_: type_9;
    var phi_3445_: type_9;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e65 = ((_e51.y * _e52.x) + _e51.x);
    let _e68 = (_e52.x * _e52.y);
    let _e71 = params.member.member_1.member_2;
    let _e73 = input.member[0u];
    if (_e71 < _e73) {
        phi_172_ = _e71;
    } else {
        phi_172_ = _e73;
    }
    let _e76 = phi_172_;
    let _e77 = (_e53 / 32u);
    let _e78 = (_e53 % 32u);
    let _e81 = params.member.member_2.member_1;
    if (_e81 == 0u) {
        phi_184_ = array<u32, 2>(0u, 2u);
    } else {
        phi_184_ = array<u32, 2>(1u, 1u);
    }
    let _e84 = phi_184_;
    let _e89 = params.member.member_1.member_1;
    if (_e76 > _e89) {
        let _e93 = params.member.member_1.member_1;
        let _e94 = (_e76 - _e93);
        let _e97 = params.member.member_2.member_3;
        if (_e97 == 0u) {
            return;
        }
        let _e99 = (_e94 / _e97);
        if (_e97 == 0u) {
            return;
        }
        if ((_e94 % _e97) > 0u) {
            phi_216_ = (_e99 + 1u);
        } else {
            phi_216_ = _e99;
        }
        let _e105 = phi_216_;
        phi_217_ = _e105;
    } else {
        phi_217_ = 0u;
    }
    let _e107 = phi_217_;
    let _e110 = params.member.member_2.member_4;
    if (_e110 < _e107) {
        phi_225_ = _e110;
    } else {
        phi_225_ = _e107;
    }
    let _e113 = phi_225_;
    let _e114 = (_e113 / 4u);
    if ((_e113 % 4u) > 0u) {
        phi_241_ = (_e114 + 1u);
    } else {
        phi_241_ = _e114;
    }
    let _e119 = phi_241_;
    if (_e119 > _e65) {
        let _e121 = (_e119 - _e65);
        if (_e68 == 0u) {
            return;
        }
        let _e123 = (_e121 / _e68);
        if (_e68 == 0u) {
            return;
        }
        if ((_e121 % _e68) > 0u) {
            phi_262_ = (_e123 + 1u);
        } else {
            phi_262_ = _e123;
        }
        let _e129 = phi_262_;
        phi_263_ = _e129;
    } else {
        phi_263_ = 0u;
    }
    let _e131 = phi_263_;
    phi_266_ = type_9(0u, _e131);
    loop {
        let _e134 = phi_266_;
        if (_e134.member < _e134.member_1) {
            phi_267_ = type_9((_e134.member + 1u), _e134.member_1);
            phi_290_ = type_9(1u, _e134.member);
        } else {
            phi_267_ = _e134;
            phi_290_ = type_9(0u, type_9().member_1);
        }
        let _e146 = phi_267_;
        let _e148 = phi_290_;
        let _e152 = (bitcast<i32>(_e148.member) != 0i);
        if _e152 {
            let _e156 = (((_e65 + (_e148.member_1 * _e68)) * 4u) + _e77);
            let _e159 = params.member.member_1.member_1;
            if (_e76 > _e159) {
                let _e163 = params.member.member_1.member_1;
                let _e164 = (_e76 - _e163);
                let _e167 = params.member.member_2.member_3;
                if (_e167 == 0u) {
                    return;
                }
                let _e169 = (_e164 / _e167);
                if (_e167 == 0u) {
                    return;
                }
                if ((_e164 % _e167) > 0u) {
                    phi_331_ = (_e169 + 1u);
                } else {
                    phi_331_ = _e169;
                }
                let _e175 = phi_331_;
                phi_332_ = _e175;
            } else {
                phi_332_ = 0u;
            }
            let _e177 = phi_332_;
            let _e180 = params.member.member_2.member_4;
            if (_e180 < _e177) {
                phi_340_ = _e180;
            } else {
                phi_340_ = _e177;
            }
            let _e183 = phi_340_;
            let _e184 = (_e156 < _e183);
            let _e187 = params.member.member_1.member_1;
            if _e184 {
                let _e190 = params.member.member_2.member_3;
                phi_352_ = (_e156 * _e190);
            } else {
                phi_352_ = 0u;
            }
            let _e193 = phi_352_;
            let _e195 = (2u * (_e187 + _e193));
            let _e198 = input.member[(4u + _e195)];
            let _e201 = input.member[(_e195 + 5u)];
            if (_e53 < 8u) {
                atomicStore((&counters[_e53]), 0u);
            }
            workgroupBarrier();
            let _e209 = params.member.member_2.member[0u][_e84[0]];
            let _e210 = (_e209 + (_e198 * 32u));
            let _e216 = params.member.member_2.member[0u][_e84[1]];
            let _e217 = (_e216 + (_e201 * 32u));
            if (_e78 == 0u) {
                firsts[(2u * _e77)] = _e210;
                firsts[((2u * _e77) + 1u)] = _e217;
            }
            let _e226 = params.member.member_2.member_1;
            if (_e226 == 0u) {
                phi_437_ = array<u32, 2>(0u, 2u);
            } else {
                phi_437_ = array<u32, 2>(1u, 1u);
            }
            let _e229 = phi_437_;
            let _e232 = (_e53 / 32u);
            let _e233 = (_e53 % 32u);
            let _e237 = params.member.member_2.member_2;
            let _e241 = params.member.member_2.member[_e237][_e229[0]];
            let _e244 = nodes.member[(_e241 + _e198)];
            let _e260 = params.member.member_2.member_2;
            let _e264 = params.member.member_2.member[_e260][_e229[1]];
            let _e267 = nodes.member[(_e264 + _e201)];
            let _e283 = params.member.member_2.member_2;
            let _e290 = params.member.member_2.member[(_e283 - 1u)][_e229[0]];
            let _e293 = nodes.member[(_e290 + ((_e198 * 32u) + _e233))];
            let _e312 = params.member.member_2.member_2;
            let _e319 = params.member.member_2.member[(_e312 - 1u)][_e229[1]];
            let _e322 = nodes.member[(_e319 + ((_e201 * 32u) + _e233))];
            if _e184 {
                if ((((((_e322.member.x <= _e244.member_1.y) && (_e244.member.x <= _e322.member_1.y)) && (_e322.member.y <= _e244.member_2.x)) && (_e244.member.y <= _e322.member_2.x)) && (_e322.member_1.x <= _e244.member_2.y)) && (_e244.member_1.x <= _e322.member_2.y)) {
                    let _e348 = atomicAdd((&counters[_e232]), 1u);
                    let _e349 = ((_e232 * 32u) + _e348);
                    columns[_e349] = type_29(array<f32, 3>(_e322.member.x, _e322.member.y, _e322.member_1.x), array<f32, 3>(_e322.member_1.y, _e322.member_2.x, _e322.member_2.y));
                    names[_e349] = _e233;
                }
            }
            workgroupBarrier();
            if _e184 {
                if ((((((_e293.member.x <= _e267.member_1.y) && (_e267.member.x <= _e293.member_1.y)) && (_e293.member.y <= _e267.member_2.x)) && (_e267.member.y <= _e293.member_2.x)) && (_e293.member_1.x <= _e267.member_2.y)) && (_e267.member_1.x <= _e293.member_2.y)) {
                    phi_641_ = false;
                } else {
                    phi_641_ = true;
                }
                let _e367 = phi_641_;
                phi_642_ = _e367;
            } else {
                phi_642_ = true;
            }
            let _e369 = phi_642_;
            if _e369 {
                phi_646_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_646_ = type_29(array<f32, 3>(_e293.member.x, _e293.member.y, _e293.member_1.x), array<f32, 3>(_e293.member_1.y, _e293.member_2.x, _e293.member_2.y));
            }
            let _e371 = phi_646_;
            if (_e84[0] == _e84[1]) {
                phi_652_ = (_e198 == _e201);
            } else {
                phi_652_ = false;
            }
            let _e375 = phi_652_;
            let _e376 = (_e53 / 32u);
            let _e377 = (_e53 % 32u);
            let _e379 = atomicLoad((&counters[_e376]));
            phi_659_ = type_9(0u, _e379);
            phi_662_ = 0u;
            loop {
                let _e382 = phi_659_;
                let _e384 = phi_662_;
                local_4 = _e384;
                if (_e382.member < _e382.member_1) {
                    phi_660_ = type_9((_e382.member + 1u), _e382.member_1);
                    phi_685_ = type_9(1u, _e382.member);
                } else {
                    phi_660_ = _e382;
                    phi_685_ = type_9(0u, type_9().member_1);
                }
                let _e396 = phi_660_;
                let _e398 = phi_685_;
                let _e402 = (bitcast<i32>(_e398.member) != 0i);
                if _e402 {
                    let _e406 = names[((_e376 * 32u) + _e398.member_1)];
                    let _e410 = columns[((_e376 * 32u) + _e398.member_1)];
                    if ((((((_e371.member[0] <= _e410.member_1[0]) && (_e410.member[0] <= _e371.member_1[0])) && (_e371.member[1] <= _e410.member_1[1])) && (_e410.member[1] <= _e371.member_1[1])) && (_e371.member[2] <= _e410.member_1[2])) && (_e410.member[2] <= _e371.member_1[2])) {
                        if _e375 {
                            let _e442 = (_e377 < _e406);
                            if _e442 {
                                phi_751_ = bool();
                            } else {
                                phi_751_ = false;
                            }
                            let _e444 = phi_751_;
                            phi_752_ = _e444;
                            phi_753_ = _e442;
                        } else {
                            phi_752_ = bool();
                            phi_753_ = true;
                        }
                        let _e446 = phi_752_;
                        let _e448 = phi_753_;
                        if _e448 {
                            phi_757_ = true;
                        } else {
                            phi_757_ = _e446;
                        }
                        let _e450 = phi_757_;
                        phi_758_ = _e450;
                    } else {
                        phi_758_ = false;
                    }
                    let _e452 = phi_758_;
                    if false {
                        if _e452 {
                            let _e456 = firsts[((_e376 * 32u) + _e406)];
                            if ((u32() >> bitcast<u32>(16i)) <= (_e456 & 65535u)) {
                                phi_780_ = ((_e456 >> bitcast<u32>(16i)) <= (u32() & 65535u));
                            } else {
                                phi_780_ = false;
                            }
                            let _e466 = phi_780_;
                            phi_781_ = _e466;
                        } else {
                            phi_781_ = false;
                        }
                        let _e468 = phi_781_;
                        phi_782_ = _e468;
                    } else {
                        phi_782_ = _e452;
                    }
                    let _e470 = phi_782_;
                    if _e470 {
                        let _e472 = atomicAdd((&counters[4u]), 1u);
                        if (_e472 < 2048u) {
                            hits[_e472] = (((_e376 << bitcast<u32>(10i)) | (_e377 << bitcast<u32>(5i))) | _e406);
                            phi_800_ = _e384;
                        } else {
                            phi_800_ = (_e384 | (1u << bitcast<u32>((_e398.member_1 & 31u))));
                        }
                        let _e486 = phi_800_;
                        phi_801_ = _e486;
                    } else {
                        phi_801_ = _e384;
                    }
                    let _e488 = phi_801_;
                    phi_663_ = _e488;
                } else {
                    phi_663_ = u32();
                }
                let _e490 = phi_663_;
                continue;
                continuing {
                    phi_659_ = _e396;
                    phi_662_ = _e490;
                    break if !(_e402);
                }
            }
            phi_804_ = type_9(0u, 32u);
            let _e2059 = local_4;
            phi_807_ = _e2059;
            loop {
                let _e493 = phi_804_;
                let _e495 = phi_807_;
                if (_e493.member < _e493.member_1) {
                    phi_805_ = type_9((_e493.member + 1u), _e493.member_1);
                    phi_830_ = type_9(1u, _e493.member);
                } else {
                    phi_805_ = _e493;
                    phi_830_ = type_9(0u, type_9().member_1);
                }
                let _e507 = phi_805_;
                let _e509 = phi_830_;
                if (bitcast<i32>(_e509.member) != 0i) {
                    if (_e495 == 0u) {
                        phi_2060_ = u32();
                        phi_2061_ = false;
                    } else {
                        let _e520 = names[((_e77 * 32u) + select(firstTrailingBit(_e495), 32u, (_e495 == 0u)))];
                        let _e523 = (_e210 + _e78);
                        let _e524 = (_e217 + _e520);
                        let _e526 = leaves.member[_e523];
                        let _e528 = leaves.member[_e524];
                        let _e530 = nodes.member[_e523];
                        let _e544 = nodes.member[_e524];
                        let _e559 = params.member.member.member_1;
                        if ((_e559 & 1u) != 0u) {
                            if (_e81 == 0u) {
                                if (_e528.member[0] == _e526.member[0]) {
                                    phi_924_ = true;
                                } else {
                                    phi_924_ = (_e528.member[0] == _e526.member[0]);
                                }
                                let _e587 = phi_924_;
                                if (_e528.member[1] == _e526.member[0]) {
                                    phi_931_ = true;
                                } else {
                                    phi_931_ = (_e528.member[1] == _e526.member[0]);
                                }
                                let _e592 = phi_931_;
                                if (_e528.member[2] == _e526.member[0]) {
                                    phi_939_ = true;
                                } else {
                                    phi_939_ = (_e528.member[2] == _e526.member[0]);
                                }
                                let _e598 = phi_939_;
                                phi_958_ = ((_e587 || _e592) || _e598);
                            } else {
                                if (_e528.member[0] == _e526.member[0]) {
                                    phi_950_ = true;
                                } else {
                                    phi_950_ = (_e528.member[0] == _e526.member[1]);
                                }
                                let _e574 = phi_950_;
                                if (_e528.member[1] == _e526.member[0]) {
                                    phi_956_ = true;
                                } else {
                                    phi_956_ = (_e528.member[1] == _e526.member[1]);
                                }
                                let _e578 = phi_956_;
                                phi_958_ = (_e574 || _e578);
                            }
                            let _e601 = phi_958_;
                            if _e601 {
                                phi_962_ = false;
                            } else {
                                phi_962_ = true;
                            }
                            let _e603 = phi_962_;
                            phi_963_ = _e603;
                        } else {
                            phi_963_ = true;
                        }
                        let _e605 = phi_963_;
                        if _e605 {
                            let _e607 = params.member.member.member_1;
                            if ((_e607 & 2u) != 0u) {
                                let _e613 = bodies.member[_e526.member[0]];
                                let _e617 = bodies.member[_e528.member[0]];
                                if ((_e613 / 4u) != (_e617 / 4u)) {
                                    phi_1008_ = true;
                                } else {
                                    if ((_e613 & 2u) == 0u) {
                                        phi_1007_ = false;
                                    } else {
                                        phi_1007_ = true;
                                    }
                                    let _e624 = phi_1007_;
                                    phi_1008_ = _e624;
                                }
                                let _e626 = phi_1008_;
                                if _e626 {
                                    phi_1015_ = (((_e613 & _e617) & 1u) == 0u);
                                } else {
                                    phi_1015_ = false;
                                }
                                let _e631 = phi_1015_;
                                if _e631 {
                                    let _e633 = params.member.member.member_1;
                                    if ((_e633 & 4u) != 0u) {
                                        let _e638 = params.member.member.member[0u];
                                        let _e640 = bodies.member[_e638];
                                        let _e643 = bodies.member[(_e638 + 1u)];
                                        let _e648 = ((_e638 + 4u) + (2u * (_e613 >> bitcast<u32>(2i))));
                                        let _e653 = ((_e638 + 4u) + (2u * (_e617 >> bitcast<u32>(2i))));
                                        let _e655 = bodies.member[_e648];
                                        let _e657 = bodies.member[_e653];
                                        let _e666 = bodies.member[((((_e638 + 4u) + (2u * _e640)) + (_e655 * _e643)) + (_e657 / 32u))];
                                        let _e669 = bodies.member[(_e648 + 1u)];
                                        let _e672 = bodies.member[(_e653 + 1u)];
                                        if (_e669 == _e672) {
                                            if (((_e666 >> bitcast<u32>(((_e657 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1131_ = true;
                                            } else {
                                                phi_1131_ = ((_e613 >> bitcast<u32>(2i)) == (_e617 >> bitcast<u32>(2i)));
                                            }
                                            let _e686 = phi_1131_;
                                            phi_1132_ = _e686;
                                        } else {
                                            phi_1132_ = false;
                                        }
                                        let _e688 = phi_1132_;
                                        if _e688 {
                                            let _e693 = bodies.member[(_e638 + 2u)];
                                            let _e696 = bodies.member[(_e638 + 3u)];
                                            let _e697 = (_e696 + _e638);
                                            if (_e81 == 1u) {
                                                if (_e528.member_1 < _e526.member_1) {
                                                    phi_1169_ = _e526.member_1;
                                                    phi_1170_ = _e528.member_1;
                                                } else {
                                                    phi_1169_ = _e528.member_1;
                                                    phi_1170_ = _e526.member_1;
                                                }
                                                let _e701 = phi_1169_;
                                                let _e703 = phi_1170_;
                                                phi_1171_ = _e701;
                                                phi_1172_ = _e703;
                                            } else {
                                                phi_1171_ = _e528.member_1;
                                                phi_1172_ = _e526.member_1;
                                            }
                                            let _e705 = phi_1171_;
                                            let _e707 = phi_1172_;
                                            phi_1175_ = type_15(0i, 32i);
                                            phi_1178_ = _e693;
                                            phi_1180_ = 0u;
                                            loop {
                                                let _e709 = phi_1175_;
                                                let _e711 = phi_1178_;
                                                let _e713 = phi_1180_;
                                                local = _e713;
                                                local_1 = _e713;
                                                if (_e709.member < _e709.member_1) {
                                                    let _e720 = (_e709.member + 1i);
                                                    if ((false == (_e720 > _e709.member)) != false) {
                                                        phi_1201_ = true;
                                                    } else {
                                                        phi_1201_ = false;
                                                    }
                                                    let _e725 = phi_1201_;
                                                    if _e725 {
                                                        phi_1207_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1207_ = type_16(1u, _e720);
                                                    }
                                                    let _e730 = phi_1207_;
                                                    phi_1176_ = type_15(_e730.member_1, _e709.member_1);
                                                    phi_1221_ = type_16(1u, _e709.member);
                                                } else {
                                                    phi_1176_ = _e709;
                                                    phi_1221_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e736 = phi_1176_;
                                                let _e738 = phi_1221_;
                                                if (bitcast<i32>(_e738.member) != 0i) {
                                                    if (_e713 >= _e711) {
                                                        phi_1304_ = u32();
                                                        phi_1305_ = u32();
                                                        phi_1306_ = false;
                                                    } else {
                                                        let _e745 = (_e713 + ((_e711 - _e713) / 2u));
                                                        let _e747 = (_e697 + (3u * _e745));
                                                        let _e749 = bodies.member[_e747];
                                                        let _e752 = bodies.member[(_e747 + 1u)];
                                                        let _e755 = bodies.member[(_e747 + 2u)];
                                                        if (_e749 < _e81) {
                                                            phi_1297_ = true;
                                                        } else {
                                                            if (_e749 == _e81) {
                                                                if (_e752 < _e707) {
                                                                    phi_1291_ = false;
                                                                } else {
                                                                    if (_e752 == _e707) {
                                                                        if (_e755 < _e705) {
                                                                            phi_1289_ = false;
                                                                        } else {
                                                                            phi_1289_ = true;
                                                                        }
                                                                        let _e762 = phi_1289_;
                                                                        phi_1290_ = _e762;
                                                                    } else {
                                                                        phi_1290_ = true;
                                                                    }
                                                                    let _e764 = phi_1290_;
                                                                    phi_1291_ = _e764;
                                                                }
                                                                let _e766 = phi_1291_;
                                                                phi_1292_ = _e766;
                                                            } else {
                                                                phi_1292_ = true;
                                                            }
                                                            let _e768 = phi_1292_;
                                                            if _e768 {
                                                                phi_1296_ = false;
                                                            } else {
                                                                phi_1296_ = true;
                                                            }
                                                            let _e770 = phi_1296_;
                                                            phi_1297_ = _e770;
                                                        }
                                                        let _e772 = phi_1297_;
                                                        if _e772 {
                                                            phi_1302_ = _e711;
                                                            phi_1303_ = (_e745 + 1u);
                                                        } else {
                                                            phi_1302_ = _e745;
                                                            phi_1303_ = _e713;
                                                        }
                                                        let _e775 = phi_1302_;
                                                        let _e777 = phi_1303_;
                                                        phi_1304_ = _e775;
                                                        phi_1305_ = _e777;
                                                        phi_1306_ = true;
                                                    }
                                                    let _e779 = phi_1304_;
                                                    let _e781 = phi_1305_;
                                                    let _e783 = phi_1306_;
                                                    phi_1179_ = _e779;
                                                    phi_1181_ = _e781;
                                                    phi_1307_ = _e783;
                                                } else {
                                                    phi_1179_ = u32();
                                                    phi_1181_ = u32();
                                                    phi_1307_ = false;
                                                }
                                                let _e785 = phi_1179_;
                                                let _e787 = phi_1181_;
                                                let _e789 = phi_1307_;
                                                continue;
                                                continuing {
                                                    phi_1175_ = _e736;
                                                    phi_1178_ = _e785;
                                                    phi_1180_ = _e787;
                                                    break if !(_e789);
                                                }
                                            }
                                            let _e792 = local;
                                            if (_e792 < _e693) {
                                                let _e795 = local_1;
                                                let _e797 = (_e697 + (3u * _e795));
                                                let _e799 = bodies.member[_e797];
                                                if (_e799 == _e81) {
                                                    let _e803 = bodies.member[(_e797 + 1u)];
                                                    if (_e803 == _e707) {
                                                        let _e807 = bodies.member[(_e797 + 2u)];
                                                        phi_1355_ = (_e807 == _e705);
                                                        phi_1356_ = false;
                                                    } else {
                                                        phi_1355_ = bool();
                                                        phi_1356_ = true;
                                                    }
                                                    let _e810 = phi_1355_;
                                                    let _e812 = phi_1356_;
                                                    phi_1357_ = _e810;
                                                    phi_1358_ = _e812;
                                                } else {
                                                    phi_1357_ = bool();
                                                    phi_1358_ = true;
                                                }
                                                let _e814 = phi_1357_;
                                                let _e816 = phi_1358_;
                                                if _e816 {
                                                    phi_1362_ = false;
                                                } else {
                                                    phi_1362_ = _e814;
                                                }
                                                let _e818 = phi_1362_;
                                                phi_1363_ = _e818;
                                            } else {
                                                phi_1363_ = false;
                                            }
                                            let _e820 = phi_1363_;
                                            phi_1367_ = _e820;
                                        } else {
                                            phi_1367_ = true;
                                        }
                                        let _e822 = phi_1367_;
                                        if _e822 {
                                            phi_1371_ = false;
                                        } else {
                                            phi_1371_ = true;
                                        }
                                        let _e824 = phi_1371_;
                                        phi_1372_ = _e824;
                                    } else {
                                        phi_1372_ = true;
                                    }
                                    let _e826 = phi_1372_;
                                    if _e826 {
                                        phi_1376_ = false;
                                    } else {
                                        phi_1376_ = true;
                                    }
                                    let _e828 = phi_1376_;
                                    phi_1377_ = _e828;
                                } else {
                                    phi_1377_ = true;
                                }
                                let _e830 = phi_1377_;
                                if _e830 {
                                    phi_1381_ = false;
                                } else {
                                    phi_1381_ = true;
                                }
                                let _e832 = phi_1381_;
                                phi_1382_ = _e832;
                            } else {
                                phi_1382_ = true;
                            }
                            let _e834 = phi_1382_;
                            if _e834 {
                                let _e836 = params.member.member.member_1;
                                if ((_e836 & 32u) != 0u) {
                                    let _e840 = params.member.member.member_6;
                                    let _e857 = (((((_e530.member_1.y - _e544.member.x) > _e840) && ((_e544.member_1.y - _e530.member.x) > _e840)) && (((_e530.member_2.x - _e544.member.y) > _e840) && ((_e544.member_2.x - _e530.member.y) > _e840))) && (((_e530.member_2.y - _e544.member_1.x) > _e840) && ((_e544.member_2.y - _e530.member_1.x) > _e840)));
                                    if _e857 {
                                        phi_1984_ = bool();
                                    } else {
                                        let _e861 = keys.member[_e526.member[0]];
                                        let _e866 = keys.member[_e526.member[1]];
                                        let _e868 = function_5(_e861[0], _e866[0]);
                                        let _e872 = keys.member[_e526.member[2]];
                                        let _e874 = function_5(_e868, _e872[0]);
                                        let _e878 = keys.member[_e528.member[0]];
                                        let _e883 = keys.member[_e528.member[1]];
                                        let _e885 = function_4(_e878[3], _e883[3]);
                                        let _e889 = keys.member[_e528.member[2]];
                                        let _e891 = function_4(_e885, _e889[3]);
                                        if (_e874[1] > _e891[1]) {
                                            phi_1507_ = true;
                                        } else {
                                            if (_e874[1] == _e891[1]) {
                                                phi_1506_ = (_e874[0] > _e891[0]);
                                            } else {
                                                phi_1506_ = false;
                                            }
                                            let _e902 = phi_1506_;
                                            phi_1507_ = _e902;
                                        }
                                        let _e904 = phi_1507_;
                                        let _e909 = keys.member[_e528.member[0]];
                                        let _e914 = keys.member[_e528.member[1]];
                                        let _e916 = function_5(_e909[0], _e914[0]);
                                        let _e920 = keys.member[_e528.member[2]];
                                        let _e922 = function_5(_e916, _e920[0]);
                                        let _e926 = keys.member[_e526.member[0]];
                                        let _e931 = keys.member[_e526.member[1]];
                                        let _e933 = function_4(_e926[3], _e931[3]);
                                        let _e937 = keys.member[_e526.member[2]];
                                        let _e939 = function_4(_e933, _e937[3]);
                                        if (_e922[1] > _e939[1]) {
                                            phi_1601_ = true;
                                        } else {
                                            if (_e922[1] == _e939[1]) {
                                                phi_1600_ = (_e922[0] > _e939[0]);
                                            } else {
                                                phi_1600_ = false;
                                            }
                                            let _e950 = phi_1600_;
                                            phi_1601_ = _e950;
                                        }
                                        let _e952 = phi_1601_;
                                        let _e958 = keys.member[_e526.member[0]];
                                        let _e963 = keys.member[_e526.member[1]];
                                        let _e965 = function_3(_e958[1], _e963[1]);
                                        let _e969 = keys.member[_e526.member[2]];
                                        let _e971 = function_3(_e965, _e969[1]);
                                        let _e975 = keys.member[_e528.member[0]];
                                        let _e980 = keys.member[_e528.member[1]];
                                        let _e982 = function_2(_e975[4], _e980[4]);
                                        let _e986 = keys.member[_e528.member[2]];
                                        let _e988 = function_2(_e982, _e986[4]);
                                        if (_e971[1] > _e988[1]) {
                                            phi_1696_ = true;
                                        } else {
                                            if (_e971[1] == _e988[1]) {
                                                phi_1695_ = (_e971[0] > _e988[0]);
                                            } else {
                                                phi_1695_ = false;
                                            }
                                            let _e999 = phi_1695_;
                                            phi_1696_ = _e999;
                                        }
                                        let _e1001 = phi_1696_;
                                        let _e1006 = keys.member[_e528.member[0]];
                                        let _e1011 = keys.member[_e528.member[1]];
                                        let _e1013 = function_3(_e1006[1], _e1011[1]);
                                        let _e1017 = keys.member[_e528.member[2]];
                                        let _e1019 = function_3(_e1013, _e1017[1]);
                                        let _e1023 = keys.member[_e526.member[0]];
                                        let _e1028 = keys.member[_e526.member[1]];
                                        let _e1030 = function_2(_e1023[4], _e1028[4]);
                                        let _e1034 = keys.member[_e526.member[2]];
                                        let _e1036 = function_2(_e1030, _e1034[4]);
                                        if (_e1019[1] > _e1036[1]) {
                                            phi_1790_ = true;
                                        } else {
                                            if (_e1019[1] == _e1036[1]) {
                                                phi_1789_ = (_e1019[0] > _e1036[0]);
                                            } else {
                                                phi_1789_ = false;
                                            }
                                            let _e1047 = phi_1789_;
                                            phi_1790_ = _e1047;
                                        }
                                        let _e1049 = phi_1790_;
                                        let _e1056 = keys.member[_e526.member[0]];
                                        let _e1061 = keys.member[_e526.member[1]];
                                        let _e1063 = function_1(_e1056[2], _e1061[2]);
                                        let _e1067 = keys.member[_e526.member[2]];
                                        let _e1069 = function_1(_e1063, _e1067[2]);
                                        let _e1073 = keys.member[_e528.member[0]];
                                        let _e1078 = keys.member[_e528.member[1]];
                                        let _e1080 = function_(_e1073[5], _e1078[5]);
                                        let _e1084 = keys.member[_e528.member[2]];
                                        let _e1086 = function_(_e1080, _e1084[5]);
                                        if (_e1069[1] > _e1086[1]) {
                                            phi_1886_ = true;
                                        } else {
                                            if (_e1069[1] == _e1086[1]) {
                                                phi_1885_ = (_e1069[0] > _e1086[0]);
                                            } else {
                                                phi_1885_ = false;
                                            }
                                            let _e1097 = phi_1885_;
                                            phi_1886_ = _e1097;
                                        }
                                        let _e1099 = phi_1886_;
                                        let _e1104 = keys.member[_e528.member[0]];
                                        let _e1109 = keys.member[_e528.member[1]];
                                        let _e1111 = function_1(_e1104[2], _e1109[2]);
                                        let _e1115 = keys.member[_e528.member[2]];
                                        let _e1117 = function_1(_e1111, _e1115[2]);
                                        let _e1121 = keys.member[_e526.member[0]];
                                        let _e1126 = keys.member[_e526.member[1]];
                                        let _e1128 = function_(_e1121[5], _e1126[5]);
                                        let _e1132 = keys.member[_e526.member[2]];
                                        let _e1134 = function_(_e1128, _e1132[5]);
                                        if (_e1117[1] > _e1134[1]) {
                                            phi_1980_ = true;
                                        } else {
                                            if (_e1117[1] == _e1134[1]) {
                                                phi_1979_ = (_e1117[0] > _e1134[0]);
                                            } else {
                                                phi_1979_ = false;
                                            }
                                            let _e1145 = phi_1979_;
                                            phi_1980_ = _e1145;
                                        }
                                        let _e1147 = phi_1980_;
                                        phi_1984_ = (((!(_e904) && !(_e952)) && (!(_e1001) && !(_e1049))) && (!(_e1099) && !(_e1147)));
                                    }
                                    let _e1152 = phi_1984_;
                                    phi_1985_ = _e1152;
                                    phi_1986_ = _e857;
                                } else {
                                    phi_1985_ = bool();
                                    phi_1986_ = true;
                                }
                                let _e1154 = phi_1985_;
                                let _e1156 = phi_1986_;
                                if _e1156 {
                                    phi_1990_ = false;
                                } else {
                                    phi_1990_ = true;
                                }
                                let _e1158 = phi_1990_;
                                phi_1991_ = _e1154;
                                phi_1992_ = _e1158;
                            } else {
                                phi_1991_ = false;
                                phi_1992_ = true;
                            }
                            let _e1160 = phi_1991_;
                            let _e1162 = phi_1992_;
                            phi_1993_ = _e1160;
                            phi_1994_ = _e1162;
                        } else {
                            phi_1993_ = false;
                            phi_1994_ = true;
                        }
                        let _e1164 = phi_1993_;
                        let _e1166 = phi_1994_;
                        if _e1166 {
                            phi_1998_ = _e1164;
                        } else {
                            phi_1998_ = true;
                        }
                        let _e1168 = phi_1998_;
                        if _e1168 {
                            if (_e84[0] == _e84[1]) {
                                if (_e526.member_1 < _e528.member_1) {
                                    phi_2014_ = type_9(_e526.member_1, _e528.member_1);
                                } else {
                                    phi_2014_ = type_9(_e528.member_1, _e526.member_1);
                                }
                                let _e1177 = phi_2014_;
                                phi_2019_ = _e1177;
                            } else {
                                phi_2019_ = type_9(_e526.member_1, _e528.member_1);
                            }
                            let _e1179 = phi_2019_;
                            let _e1184 = params.member.member_1.member_3;
                            let _e1186 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1186 + 1u) < _e1186) {
                                let _e1190 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1186 < _e1184) {
                                let _e1192 = (2u * _e1186);
                                atomicStore((&output.member[(4u + _e1192)]), _e1179.member);
                                atomicStore((&output.member[(_e1192 + 5u)]), _e1179.member_1);
                            }
                            let _e1198 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1198 + 1u) < _e1198) {
                                let _e1202 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2060_ = (_e495 & (_e495 - 1u));
                        phi_2061_ = true;
                    }
                    let _e1204 = phi_2060_;
                    let _e1206 = phi_2061_;
                    phi_808_ = _e1204;
                    phi_2062_ = _e1206;
                } else {
                    phi_808_ = u32();
                    phi_2062_ = false;
                }
                let _e1208 = phi_808_;
                let _e1210 = phi_2062_;
                continue;
                continuing {
                    phi_804_ = _e507;
                    phi_807_ = _e1208;
                    break if !(_e1210);
                }
            }
            workgroupBarrier();
            let _e1213 = atomicLoad((&counters[4u]));
            if (2048u < _e1213) {
                phi_2069_ = 2048u;
            } else {
                phi_2069_ = _e1213;
            }
            let _e1216 = phi_2069_;
            phi_2072_ = type_9(0u, 16u);
            loop {
                let _e1218 = phi_2072_;
                if (_e1218.member < _e1218.member_1) {
                    phi_2073_ = type_9((_e1218.member + 1u), _e1218.member_1);
                    phi_2096_ = type_9(1u, _e1218.member);
                } else {
                    phi_2073_ = _e1218;
                    phi_2096_ = type_9(0u, type_9().member_1);
                }
                let _e1230 = phi_2073_;
                let _e1232 = phi_2096_;
                if (bitcast<i32>(_e1232.member) != 0i) {
                    let _e1238 = (_e53 + (_e1232.member_1 * 128u));
                    if (_e1238 >= _e1216) {
                        phi_3287_ = false;
                    } else {
                        let _e1241 = hits[_e1238];
                        let _e1244 = ((_e1241 >> bitcast<u32>(10i)) & 3u);
                        let _e1251 = firsts[(2u * _e1244)];
                        let _e1252 = (_e1251 + ((_e1241 >> bitcast<u32>(5i)) & 31u));
                        let _e1256 = firsts[((2u * _e1244) + 1u)];
                        let _e1257 = (_e1256 + (_e1241 & 31u));
                        let _e1259 = leaves.member[_e1252];
                        let _e1261 = leaves.member[_e1257];
                        let _e1263 = nodes.member[_e1252];
                        let _e1277 = nodes.member[_e1257];
                        let _e1292 = params.member.member.member_1;
                        if ((_e1292 & 1u) != 0u) {
                            if (_e81 == 0u) {
                                if (_e1261.member[0] == _e1259.member[0]) {
                                    phi_2198_ = true;
                                } else {
                                    phi_2198_ = (_e1261.member[0] == _e1259.member[0]);
                                }
                                let _e1320 = phi_2198_;
                                if (_e1261.member[1] == _e1259.member[0]) {
                                    phi_2205_ = true;
                                } else {
                                    phi_2205_ = (_e1261.member[1] == _e1259.member[0]);
                                }
                                let _e1325 = phi_2205_;
                                if (_e1261.member[2] == _e1259.member[0]) {
                                    phi_2213_ = true;
                                } else {
                                    phi_2213_ = (_e1261.member[2] == _e1259.member[0]);
                                }
                                let _e1331 = phi_2213_;
                                phi_2232_ = ((_e1320 || _e1325) || _e1331);
                            } else {
                                if (_e1261.member[0] == _e1259.member[0]) {
                                    phi_2224_ = true;
                                } else {
                                    phi_2224_ = (_e1261.member[0] == _e1259.member[1]);
                                }
                                let _e1307 = phi_2224_;
                                if (_e1261.member[1] == _e1259.member[0]) {
                                    phi_2230_ = true;
                                } else {
                                    phi_2230_ = (_e1261.member[1] == _e1259.member[1]);
                                }
                                let _e1311 = phi_2230_;
                                phi_2232_ = (_e1307 || _e1311);
                            }
                            let _e1334 = phi_2232_;
                            if _e1334 {
                                phi_2236_ = false;
                            } else {
                                phi_2236_ = true;
                            }
                            let _e1336 = phi_2236_;
                            phi_2237_ = _e1336;
                        } else {
                            phi_2237_ = true;
                        }
                        let _e1338 = phi_2237_;
                        if _e1338 {
                            let _e1340 = params.member.member.member_1;
                            if ((_e1340 & 2u) != 0u) {
                                let _e1346 = bodies.member[_e1259.member[0]];
                                let _e1350 = bodies.member[_e1261.member[0]];
                                if ((_e1346 / 4u) != (_e1350 / 4u)) {
                                    phi_2282_ = true;
                                } else {
                                    if ((_e1346 & 2u) == 0u) {
                                        phi_2281_ = false;
                                    } else {
                                        phi_2281_ = true;
                                    }
                                    let _e1357 = phi_2281_;
                                    phi_2282_ = _e1357;
                                }
                                let _e1359 = phi_2282_;
                                if _e1359 {
                                    phi_2289_ = (((_e1346 & _e1350) & 1u) == 0u);
                                } else {
                                    phi_2289_ = false;
                                }
                                let _e1364 = phi_2289_;
                                if _e1364 {
                                    let _e1366 = params.member.member.member_1;
                                    if ((_e1366 & 4u) != 0u) {
                                        let _e1371 = params.member.member.member[0u];
                                        let _e1373 = bodies.member[_e1371];
                                        let _e1376 = bodies.member[(_e1371 + 1u)];
                                        let _e1381 = ((_e1371 + 4u) + (2u * (_e1346 >> bitcast<u32>(2i))));
                                        let _e1386 = ((_e1371 + 4u) + (2u * (_e1350 >> bitcast<u32>(2i))));
                                        let _e1388 = bodies.member[_e1381];
                                        let _e1390 = bodies.member[_e1386];
                                        let _e1399 = bodies.member[((((_e1371 + 4u) + (2u * _e1373)) + (_e1388 * _e1376)) + (_e1390 / 32u))];
                                        let _e1402 = bodies.member[(_e1381 + 1u)];
                                        let _e1405 = bodies.member[(_e1386 + 1u)];
                                        if (_e1402 == _e1405) {
                                            if (((_e1399 >> bitcast<u32>(((_e1390 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2405_ = true;
                                            } else {
                                                phi_2405_ = ((_e1346 >> bitcast<u32>(2i)) == (_e1350 >> bitcast<u32>(2i)));
                                            }
                                            let _e1419 = phi_2405_;
                                            phi_2406_ = _e1419;
                                        } else {
                                            phi_2406_ = false;
                                        }
                                        let _e1421 = phi_2406_;
                                        if _e1421 {
                                            let _e1426 = bodies.member[(_e1371 + 2u)];
                                            let _e1429 = bodies.member[(_e1371 + 3u)];
                                            let _e1430 = (_e1429 + _e1371);
                                            if (_e81 == 1u) {
                                                if (_e1261.member_1 < _e1259.member_1) {
                                                    phi_2443_ = _e1259.member_1;
                                                    phi_2444_ = _e1261.member_1;
                                                } else {
                                                    phi_2443_ = _e1261.member_1;
                                                    phi_2444_ = _e1259.member_1;
                                                }
                                                let _e1434 = phi_2443_;
                                                let _e1436 = phi_2444_;
                                                phi_2445_ = _e1434;
                                                phi_2446_ = _e1436;
                                            } else {
                                                phi_2445_ = _e1261.member_1;
                                                phi_2446_ = _e1259.member_1;
                                            }
                                            let _e1438 = phi_2445_;
                                            let _e1440 = phi_2446_;
                                            phi_2449_ = type_15(0i, 32i);
                                            phi_2452_ = _e1426;
                                            phi_2454_ = 0u;
                                            loop {
                                                let _e1442 = phi_2449_;
                                                let _e1444 = phi_2452_;
                                                let _e1446 = phi_2454_;
                                                local_2 = _e1446;
                                                local_3 = _e1446;
                                                if (_e1442.member < _e1442.member_1) {
                                                    let _e1453 = (_e1442.member + 1i);
                                                    if ((false == (_e1453 > _e1442.member)) != false) {
                                                        phi_2475_ = true;
                                                    } else {
                                                        phi_2475_ = false;
                                                    }
                                                    let _e1458 = phi_2475_;
                                                    if _e1458 {
                                                        phi_2481_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2481_ = type_16(1u, _e1453);
                                                    }
                                                    let _e1463 = phi_2481_;
                                                    phi_2450_ = type_15(_e1463.member_1, _e1442.member_1);
                                                    phi_2495_ = type_16(1u, _e1442.member);
                                                } else {
                                                    phi_2450_ = _e1442;
                                                    phi_2495_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1469 = phi_2450_;
                                                let _e1471 = phi_2495_;
                                                if (bitcast<i32>(_e1471.member) != 0i) {
                                                    if (_e1446 >= _e1444) {
                                                        phi_2578_ = u32();
                                                        phi_2579_ = u32();
                                                        phi_2580_ = false;
                                                    } else {
                                                        let _e1478 = (_e1446 + ((_e1444 - _e1446) / 2u));
                                                        let _e1480 = (_e1430 + (3u * _e1478));
                                                        let _e1482 = bodies.member[_e1480];
                                                        let _e1485 = bodies.member[(_e1480 + 1u)];
                                                        let _e1488 = bodies.member[(_e1480 + 2u)];
                                                        if (_e1482 < _e81) {
                                                            phi_2571_ = true;
                                                        } else {
                                                            if (_e1482 == _e81) {
                                                                if (_e1485 < _e1440) {
                                                                    phi_2565_ = false;
                                                                } else {
                                                                    if (_e1485 == _e1440) {
                                                                        if (_e1488 < _e1438) {
                                                                            phi_2563_ = false;
                                                                        } else {
                                                                            phi_2563_ = true;
                                                                        }
                                                                        let _e1495 = phi_2563_;
                                                                        phi_2564_ = _e1495;
                                                                    } else {
                                                                        phi_2564_ = true;
                                                                    }
                                                                    let _e1497 = phi_2564_;
                                                                    phi_2565_ = _e1497;
                                                                }
                                                                let _e1499 = phi_2565_;
                                                                phi_2566_ = _e1499;
                                                            } else {
                                                                phi_2566_ = true;
                                                            }
                                                            let _e1501 = phi_2566_;
                                                            if _e1501 {
                                                                phi_2570_ = false;
                                                            } else {
                                                                phi_2570_ = true;
                                                            }
                                                            let _e1503 = phi_2570_;
                                                            phi_2571_ = _e1503;
                                                        }
                                                        let _e1505 = phi_2571_;
                                                        if _e1505 {
                                                            phi_2576_ = _e1444;
                                                            phi_2577_ = (_e1478 + 1u);
                                                        } else {
                                                            phi_2576_ = _e1478;
                                                            phi_2577_ = _e1446;
                                                        }
                                                        let _e1508 = phi_2576_;
                                                        let _e1510 = phi_2577_;
                                                        phi_2578_ = _e1508;
                                                        phi_2579_ = _e1510;
                                                        phi_2580_ = true;
                                                    }
                                                    let _e1512 = phi_2578_;
                                                    let _e1514 = phi_2579_;
                                                    let _e1516 = phi_2580_;
                                                    phi_2453_ = _e1512;
                                                    phi_2455_ = _e1514;
                                                    phi_2581_ = _e1516;
                                                } else {
                                                    phi_2453_ = u32();
                                                    phi_2455_ = u32();
                                                    phi_2581_ = false;
                                                }
                                                let _e1518 = phi_2453_;
                                                let _e1520 = phi_2455_;
                                                let _e1522 = phi_2581_;
                                                continue;
                                                continuing {
                                                    phi_2449_ = _e1469;
                                                    phi_2452_ = _e1518;
                                                    phi_2454_ = _e1520;
                                                    break if !(_e1522);
                                                }
                                            }
                                            let _e1525 = local_2;
                                            if (_e1525 < _e1426) {
                                                let _e1528 = local_3;
                                                let _e1530 = (_e1430 + (3u * _e1528));
                                                let _e1532 = bodies.member[_e1530];
                                                if (_e1532 == _e81) {
                                                    let _e1536 = bodies.member[(_e1530 + 1u)];
                                                    if (_e1536 == _e1440) {
                                                        let _e1540 = bodies.member[(_e1530 + 2u)];
                                                        phi_2629_ = (_e1540 == _e1438);
                                                        phi_2630_ = false;
                                                    } else {
                                                        phi_2629_ = bool();
                                                        phi_2630_ = true;
                                                    }
                                                    let _e1543 = phi_2629_;
                                                    let _e1545 = phi_2630_;
                                                    phi_2631_ = _e1543;
                                                    phi_2632_ = _e1545;
                                                } else {
                                                    phi_2631_ = bool();
                                                    phi_2632_ = true;
                                                }
                                                let _e1547 = phi_2631_;
                                                let _e1549 = phi_2632_;
                                                if _e1549 {
                                                    phi_2636_ = false;
                                                } else {
                                                    phi_2636_ = _e1547;
                                                }
                                                let _e1551 = phi_2636_;
                                                phi_2637_ = _e1551;
                                            } else {
                                                phi_2637_ = false;
                                            }
                                            let _e1553 = phi_2637_;
                                            phi_2641_ = _e1553;
                                        } else {
                                            phi_2641_ = true;
                                        }
                                        let _e1555 = phi_2641_;
                                        if _e1555 {
                                            phi_2645_ = false;
                                        } else {
                                            phi_2645_ = true;
                                        }
                                        let _e1557 = phi_2645_;
                                        phi_2646_ = _e1557;
                                    } else {
                                        phi_2646_ = true;
                                    }
                                    let _e1559 = phi_2646_;
                                    if _e1559 {
                                        phi_2650_ = false;
                                    } else {
                                        phi_2650_ = true;
                                    }
                                    let _e1561 = phi_2650_;
                                    phi_2651_ = _e1561;
                                } else {
                                    phi_2651_ = true;
                                }
                                let _e1563 = phi_2651_;
                                if _e1563 {
                                    phi_2655_ = false;
                                } else {
                                    phi_2655_ = true;
                                }
                                let _e1565 = phi_2655_;
                                phi_2656_ = _e1565;
                            } else {
                                phi_2656_ = true;
                            }
                            let _e1567 = phi_2656_;
                            if _e1567 {
                                let _e1569 = params.member.member.member_1;
                                if ((_e1569 & 32u) != 0u) {
                                    let _e1573 = params.member.member.member_6;
                                    let _e1590 = (((((_e1263.member_1.y - _e1277.member.x) > _e1573) && ((_e1277.member_1.y - _e1263.member.x) > _e1573)) && (((_e1263.member_2.x - _e1277.member.y) > _e1573) && ((_e1277.member_2.x - _e1263.member.y) > _e1573))) && (((_e1263.member_2.y - _e1277.member_1.x) > _e1573) && ((_e1277.member_2.y - _e1263.member_1.x) > _e1573)));
                                    if _e1590 {
                                        phi_3258_ = bool();
                                    } else {
                                        let _e1594 = keys.member[_e1259.member[0]];
                                        let _e1599 = keys.member[_e1259.member[1]];
                                        let _e1601 = function_5(_e1594[0], _e1599[0]);
                                        let _e1605 = keys.member[_e1259.member[2]];
                                        let _e1607 = function_5(_e1601, _e1605[0]);
                                        let _e1611 = keys.member[_e1261.member[0]];
                                        let _e1616 = keys.member[_e1261.member[1]];
                                        let _e1618 = function_4(_e1611[3], _e1616[3]);
                                        let _e1622 = keys.member[_e1261.member[2]];
                                        let _e1624 = function_4(_e1618, _e1622[3]);
                                        if (_e1607[1] > _e1624[1]) {
                                            phi_2781_ = true;
                                        } else {
                                            if (_e1607[1] == _e1624[1]) {
                                                phi_2780_ = (_e1607[0] > _e1624[0]);
                                            } else {
                                                phi_2780_ = false;
                                            }
                                            let _e1635 = phi_2780_;
                                            phi_2781_ = _e1635;
                                        }
                                        let _e1637 = phi_2781_;
                                        let _e1642 = keys.member[_e1261.member[0]];
                                        let _e1647 = keys.member[_e1261.member[1]];
                                        let _e1649 = function_5(_e1642[0], _e1647[0]);
                                        let _e1653 = keys.member[_e1261.member[2]];
                                        let _e1655 = function_5(_e1649, _e1653[0]);
                                        let _e1659 = keys.member[_e1259.member[0]];
                                        let _e1664 = keys.member[_e1259.member[1]];
                                        let _e1666 = function_4(_e1659[3], _e1664[3]);
                                        let _e1670 = keys.member[_e1259.member[2]];
                                        let _e1672 = function_4(_e1666, _e1670[3]);
                                        if (_e1655[1] > _e1672[1]) {
                                            phi_2875_ = true;
                                        } else {
                                            if (_e1655[1] == _e1672[1]) {
                                                phi_2874_ = (_e1655[0] > _e1672[0]);
                                            } else {
                                                phi_2874_ = false;
                                            }
                                            let _e1683 = phi_2874_;
                                            phi_2875_ = _e1683;
                                        }
                                        let _e1685 = phi_2875_;
                                        let _e1691 = keys.member[_e1259.member[0]];
                                        let _e1696 = keys.member[_e1259.member[1]];
                                        let _e1698 = function_3(_e1691[1], _e1696[1]);
                                        let _e1702 = keys.member[_e1259.member[2]];
                                        let _e1704 = function_3(_e1698, _e1702[1]);
                                        let _e1708 = keys.member[_e1261.member[0]];
                                        let _e1713 = keys.member[_e1261.member[1]];
                                        let _e1715 = function_2(_e1708[4], _e1713[4]);
                                        let _e1719 = keys.member[_e1261.member[2]];
                                        let _e1721 = function_2(_e1715, _e1719[4]);
                                        if (_e1704[1] > _e1721[1]) {
                                            phi_2970_ = true;
                                        } else {
                                            if (_e1704[1] == _e1721[1]) {
                                                phi_2969_ = (_e1704[0] > _e1721[0]);
                                            } else {
                                                phi_2969_ = false;
                                            }
                                            let _e1732 = phi_2969_;
                                            phi_2970_ = _e1732;
                                        }
                                        let _e1734 = phi_2970_;
                                        let _e1739 = keys.member[_e1261.member[0]];
                                        let _e1744 = keys.member[_e1261.member[1]];
                                        let _e1746 = function_3(_e1739[1], _e1744[1]);
                                        let _e1750 = keys.member[_e1261.member[2]];
                                        let _e1752 = function_3(_e1746, _e1750[1]);
                                        let _e1756 = keys.member[_e1259.member[0]];
                                        let _e1761 = keys.member[_e1259.member[1]];
                                        let _e1763 = function_2(_e1756[4], _e1761[4]);
                                        let _e1767 = keys.member[_e1259.member[2]];
                                        let _e1769 = function_2(_e1763, _e1767[4]);
                                        if (_e1752[1] > _e1769[1]) {
                                            phi_3064_ = true;
                                        } else {
                                            if (_e1752[1] == _e1769[1]) {
                                                phi_3063_ = (_e1752[0] > _e1769[0]);
                                            } else {
                                                phi_3063_ = false;
                                            }
                                            let _e1780 = phi_3063_;
                                            phi_3064_ = _e1780;
                                        }
                                        let _e1782 = phi_3064_;
                                        let _e1789 = keys.member[_e1259.member[0]];
                                        let _e1794 = keys.member[_e1259.member[1]];
                                        let _e1796 = function_1(_e1789[2], _e1794[2]);
                                        let _e1800 = keys.member[_e1259.member[2]];
                                        let _e1802 = function_1(_e1796, _e1800[2]);
                                        let _e1806 = keys.member[_e1261.member[0]];
                                        let _e1811 = keys.member[_e1261.member[1]];
                                        let _e1813 = function_(_e1806[5], _e1811[5]);
                                        let _e1817 = keys.member[_e1261.member[2]];
                                        let _e1819 = function_(_e1813, _e1817[5]);
                                        if (_e1802[1] > _e1819[1]) {
                                            phi_3160_ = true;
                                        } else {
                                            if (_e1802[1] == _e1819[1]) {
                                                phi_3159_ = (_e1802[0] > _e1819[0]);
                                            } else {
                                                phi_3159_ = false;
                                            }
                                            let _e1830 = phi_3159_;
                                            phi_3160_ = _e1830;
                                        }
                                        let _e1832 = phi_3160_;
                                        let _e1837 = keys.member[_e1261.member[0]];
                                        let _e1842 = keys.member[_e1261.member[1]];
                                        let _e1844 = function_1(_e1837[2], _e1842[2]);
                                        let _e1848 = keys.member[_e1261.member[2]];
                                        let _e1850 = function_1(_e1844, _e1848[2]);
                                        let _e1854 = keys.member[_e1259.member[0]];
                                        let _e1859 = keys.member[_e1259.member[1]];
                                        let _e1861 = function_(_e1854[5], _e1859[5]);
                                        let _e1865 = keys.member[_e1259.member[2]];
                                        let _e1867 = function_(_e1861, _e1865[5]);
                                        if (_e1850[1] > _e1867[1]) {
                                            phi_3254_ = true;
                                        } else {
                                            if (_e1850[1] == _e1867[1]) {
                                                phi_3253_ = (_e1850[0] > _e1867[0]);
                                            } else {
                                                phi_3253_ = false;
                                            }
                                            let _e1878 = phi_3253_;
                                            phi_3254_ = _e1878;
                                        }
                                        let _e1880 = phi_3254_;
                                        phi_3258_ = (((!(_e1637) && !(_e1685)) && (!(_e1734) && !(_e1782))) && (!(_e1832) && !(_e1880)));
                                    }
                                    let _e1885 = phi_3258_;
                                    phi_3259_ = _e1885;
                                    phi_3260_ = _e1590;
                                } else {
                                    phi_3259_ = bool();
                                    phi_3260_ = true;
                                }
                                let _e1887 = phi_3259_;
                                let _e1889 = phi_3260_;
                                if _e1889 {
                                    phi_3264_ = false;
                                } else {
                                    phi_3264_ = true;
                                }
                                let _e1891 = phi_3264_;
                                phi_3265_ = _e1887;
                                phi_3266_ = _e1891;
                            } else {
                                phi_3265_ = false;
                                phi_3266_ = true;
                            }
                            let _e1893 = phi_3265_;
                            let _e1895 = phi_3266_;
                            phi_3267_ = _e1893;
                            phi_3268_ = _e1895;
                        } else {
                            phi_3267_ = false;
                            phi_3268_ = true;
                        }
                        let _e1897 = phi_3267_;
                        let _e1899 = phi_3268_;
                        if _e1899 {
                            phi_3272_ = _e1897;
                        } else {
                            phi_3272_ = true;
                        }
                        let _e1901 = phi_3272_;
                        if _e1901 {
                            let _e1903 = atomicAdd((&counters[7u]), 1u);
                            let _e1905 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1238] = ((2147483648u | (_e1905 << bitcast<u32>(12i))) | _e1241);
                        }
                        phi_3287_ = true;
                    }
                    let _e1912 = phi_3287_;
                    phi_3288_ = _e1912;
                } else {
                    phi_3288_ = false;
                }
                let _e1914 = phi_3288_;
                continue;
                continuing {
                    phi_2072_ = _e1230;
                    break if !(_e1914);
                }
            }
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e1918 = atomicLoad((&counters[5u]));
                if (_e1918 > 0u) {
                    let _e1921 = atomicAdd((&output.member[0u]), _e1918);
                    if ((_e1921 + _e1918) < _e1921) {
                        let _e1925 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1921);
                }
            }
            workgroupBarrier();
            let _e1928 = atomicLoad((&counters[6u]));
            if (_e53 == 0u) {
                let _e1931 = atomicLoad((&counters[7u]));
                if (_e1931 > 0u) {
                    let _e1934 = atomicAdd((&output.member[1u]), _e1931);
                    if ((_e1934 + _e1931) < _e1934) {
                        let _e1938 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_3338_ = type_9(0u, 16u);
            loop {
                let _e1940 = phi_3338_;
                if (_e1940.member < _e1940.member_1) {
                    phi_3339_ = type_9((_e1940.member + 1u), _e1940.member_1);
                    phi_3362_ = type_9(1u, _e1940.member);
                } else {
                    phi_3339_ = _e1940;
                    phi_3362_ = type_9(0u, type_9().member_1);
                }
                let _e1952 = phi_3339_;
                let _e1954 = phi_3362_;
                if (bitcast<i32>(_e1954.member) != 0i) {
                    let _e1960 = (_e53 + (_e1954.member_1 * 128u));
                    if (_e1960 >= _e1216) {
                        phi_3459_ = false;
                    } else {
                        let _e1963 = hits[_e1960];
                        if ((_e1963 & 2147483648u) == 0u) {
                            phi_3385_ = 4294967295u;
                        } else {
                            phi_3385_ = ((_e1963 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1970 = phi_3385_;
                        if (_e1970 != 4294967295u) {
                            let _e1974 = ((_e1963 >> bitcast<u32>(10i)) & 3u);
                            let _e1981 = firsts[(2u * _e1974)];
                            let _e1984 = leaves.member[(_e1981 + ((_e1963 >> bitcast<u32>(5i)) & 31u))];
                            let _e1988 = firsts[((2u * _e1974) + 1u)];
                            let _e1991 = leaves.member[(_e1988 + (_e1963 & 31u))];
                            let _e1996 = params.member.member_1.member_3;
                            let _e1997 = (_e1928 + _e1970);
                            if (_e84[0] == _e84[1]) {
                                if (_e1984.member_1 < _e1991.member_1) {
                                    phi_3440_ = type_9(_e1984.member_1, _e1991.member_1);
                                } else {
                                    phi_3440_ = type_9(_e1991.member_1, _e1984.member_1);
                                }
                                let _e2004 = phi_3440_;
                                phi_3445_ = _e2004;
                            } else {
                                phi_3445_ = type_9(_e1984.member_1, _e1991.member_1);
                            }
                            let _e2006 = phi_3445_;
                            if (_e1997 < _e1996) {
                                let _e2010 = (2u * _e1997);
                                atomicStore((&output.member[(4u + _e2010)]), _e2006.member);
                                atomicStore((&output.member[(_e2010 + 5u)]), _e2006.member_1);
                            }
                        }
                        phi_3459_ = true;
                    }
                    let _e2016 = phi_3459_;
                    phi_3460_ = _e2016;
                } else {
                    phi_3460_ = false;
                }
                let _e2018 = phi_3460_;
                continue;
                continuing {
                    phi_3338_ = _e1952;
                    break if !(_e2018);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_266_ = _e146;
            break if !(_e152);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
