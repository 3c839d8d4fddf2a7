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
    var phi_3573_: bool;
    var phi_3574_: bool;
    var phi_3578_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_3574_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_3573_ = (param_1[0] > param[0]);
        } else {
            phi_3573_ = false;
        }
        let _e14 = phi_3573_;
        phi_3574_ = _e14;
    }
    let _e16 = phi_3574_;
    if _e16 {
        phi_3578_ = param_1;
    } else {
        phi_3578_ = param;
    }
    let _e18 = phi_3578_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3554_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_3550_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_3549_ = (param_2[0] > param_3[0]);
        } else {
            phi_3549_ = false;
        }
        let _e14 = phi_3549_;
        phi_3550_ = _e14;
    }
    let _e16 = phi_3550_;
    if _e16 {
        phi_3554_ = param_3;
    } else {
        phi_3554_ = param_2;
    }
    let _e18 = phi_3554_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_3525_: bool;
    var phi_3526_: bool;
    var phi_3530_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_3526_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_3525_ = (param_5[0] > param_4[0]);
        } else {
            phi_3525_ = false;
        }
        let _e14 = phi_3525_;
        phi_3526_ = _e14;
    }
    let _e16 = phi_3526_;
    if _e16 {
        phi_3530_ = param_5;
    } else {
        phi_3530_ = param_4;
    }
    let _e18 = phi_3530_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_3501_: bool;
    var phi_3502_: bool;
    var phi_3506_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_3502_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_3501_ = (param_6[0] > param_7[0]);
        } else {
            phi_3501_ = false;
        }
        let _e14 = phi_3501_;
        phi_3502_ = _e14;
    }
    let _e16 = phi_3502_;
    if _e16 {
        phi_3506_ = param_7;
    } else {
        phi_3506_ = param_6;
    }
    let _e18 = phi_3506_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_3477_: bool;
    var phi_3478_: bool;
    var phi_3482_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_3478_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_3477_ = (param_9[0] > param_8[0]);
        } else {
            phi_3477_ = false;
        }
        let _e14 = phi_3477_;
        phi_3478_ = _e14;
    }
    let _e16 = phi_3478_;
    if _e16 {
        phi_3482_ = param_9;
    } else {
        phi_3482_ = param_8;
    }
    let _e18 = phi_3482_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_3453_: bool;
    var phi_3454_: bool;
    var phi_3458_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_3454_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_3453_ = (param_10[0] > param_11[0]);
        } else {
            phi_3453_ = false;
        }
        let _e14 = phi_3453_;
        phi_3454_ = _e14;
    }
    let _e16 = phi_3454_;
    if _e16 {
        phi_3458_ = param_11;
    } else {
        phi_3458_ = param_10;
    }
    let _e18 = phi_3458_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_170_: u32;
    var phi_182_: array<u32, 2>;
    var phi_214_: u32;
    var phi_215_: u32;
    var phi_223_: u32;
    var phi_239_: u32;
    var phi_260_: u32;
    var phi_261_: u32;
    var phi_264_: type_9;
    var phi_265_: type_9;
    var phi_288_: type_9;
    var phi_329_: u32;
    var phi_330_: u32;
    var phi_338_: u32;
    var phi_350_: u32;
    var phi_435_: array<u32, 2>;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_644_: type_29;
    var phi_650_: bool;
    var phi_657_: type_9;
    var phi_660_: u32;
    var phi_658_: type_9;
    var phi_683_: type_9;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_773_: u32;
    var phi_774_: u32;
    var phi_775_: u32;
    var phi_661_: u32;
    var phi_778_: type_9;
    var phi_781_: u32;
    var phi_779_: type_9;
    var phi_804_: type_9;
    var phi_924_: bool;
    var phi_930_: bool;
    var phi_898_: bool;
    var phi_905_: bool;
    var phi_913_: bool;
    var phi_932_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_989_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1143_: u32;
    var phi_1144_: u32;
    var phi_1145_: u32;
    var phi_1146_: u32;
    var phi_1149_: type_15;
    var phi_1152_: u32;
    var phi_1154_: u32;
    var phi_1175_: bool;
    var phi_1181_: type_16;
    var phi_1150_: type_15;
    var phi_1195_: type_16;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1276_: u32;
    var phi_1277_: u32;
    var phi_1278_: u32;
    var phi_1279_: u32;
    var phi_1280_: bool;
    var phi_1153_: u32;
    var phi_1155_: u32;
    var phi_1281_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1341_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1480_: bool;
    var phi_1481_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1953_: bool;
    var phi_1954_: bool;
    var phi_1958_: bool;
    var phi_1959_: bool;
    var phi_1960_: bool;
    var phi_1964_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1968_: bool;
    var phi_1972_: bool;
    var phi_1988_: type_9;
    var phi_1993_: type_9;
    var phi_2034_: u32;
    var phi_2035_: bool;
    var phi_782_: u32;
    var phi_2036_: bool;
    var phi_2043_: u32;
    var phi_2046_: type_9;
    var phi_2047_: type_9;
    var phi_2070_: type_9;
    var phi_2198_: bool;
    var phi_2204_: bool;
    var phi_2172_: bool;
    var phi_2179_: bool;
    var phi_2187_: bool;
    var phi_2206_: bool;
    var phi_2210_: bool;
    var phi_2211_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2263_: bool;
    var phi_2379_: bool;
    var phi_2380_: bool;
    var phi_2417_: u32;
    var phi_2418_: u32;
    var phi_2419_: u32;
    var phi_2420_: u32;
    var phi_2423_: type_15;
    var phi_2426_: u32;
    var phi_2428_: u32;
    var phi_2449_: bool;
    var phi_2455_: type_16;
    var phi_2424_: type_15;
    var phi_2469_: type_16;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2550_: u32;
    var phi_2551_: u32;
    var phi_2552_: u32;
    var phi_2553_: u32;
    var phi_2554_: bool;
    var phi_2427_: u32;
    var phi_2429_: u32;
    var phi_2555_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2610_: bool;
    var phi_2611_: bool;
    var phi_2615_: bool;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2754_: bool;
    var phi_2755_: bool;
    var phi_2848_: bool;
    var phi_2849_: bool;
    var phi_2943_: bool;
    var phi_2944_: bool;
    var phi_3037_: bool;
    var phi_3038_: bool;
    var phi_3133_: bool;
    var phi_3134_: bool;
    var phi_3227_: bool;
    var phi_3228_: bool;
    var phi_3232_: bool;
    var phi_3233_: bool;
    var phi_3234_: bool;
    var phi_3238_: bool;
    var phi_3239_: bool;
    var phi_3240_: bool;
    var phi_3241_: bool;
    var phi_3242_: bool;
    var phi_3246_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3312_: type_9;
    var phi_3313_: type_9;
    var phi_3336_: type_9;
    var phi_3359_: u32;
    var phi_3414_: type_9;
    var phi_3419_: type_9;
    var phi_3433_: bool;
    var phi_3434_: bool;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e49 = id_2;
    let _e50 = n_2;
    let _e51 = lane_2;
    let _e63 = ((_e49.y * _e50.x) + _e49.x);
    let _e66 = (_e50.x * _e50.y);
    let _e69 = params.member.member_1.member_2;
    let _e71 = input.member[0u];
    if (_e69 < _e71) {
        phi_170_ = _e69;
    } else {
        phi_170_ = _e71;
    }
    let _e74 = phi_170_;
    let _e75 = (_e51 / 32u);
    let _e76 = (_e51 % 32u);
    let _e79 = params.member.member_2.member_1;
    if (_e79 == 0u) {
        phi_182_ = array<u32, 2>(0u, 2u);
    } else {
        phi_182_ = array<u32, 2>(1u, 1u);
    }
    let _e82 = phi_182_;
    let _e87 = params.member.member_1.member_1;
    if (_e74 > _e87) {
        let _e91 = params.member.member_1.member_1;
        let _e92 = (_e74 - _e91);
        let _e95 = params.member.member_2.member_3;
        if (_e95 == 0u) {
            return;
        }
        let _e97 = (_e92 / _e95);
        if (_e95 == 0u) {
            return;
        }
        if ((_e92 % _e95) > 0u) {
            phi_214_ = (_e97 + 1u);
        } else {
            phi_214_ = _e97;
        }
        let _e103 = phi_214_;
        phi_215_ = _e103;
    } else {
        phi_215_ = 0u;
    }
    let _e105 = phi_215_;
    let _e108 = params.member.member_2.member_4;
    if (_e108 < _e105) {
        phi_223_ = _e108;
    } else {
        phi_223_ = _e105;
    }
    let _e111 = phi_223_;
    let _e112 = (_e111 / 4u);
    if ((_e111 % 4u) > 0u) {
        phi_239_ = (_e112 + 1u);
    } else {
        phi_239_ = _e112;
    }
    let _e117 = phi_239_;
    if (_e117 > _e63) {
        let _e119 = (_e117 - _e63);
        if (_e66 == 0u) {
            return;
        }
        let _e121 = (_e119 / _e66);
        if (_e66 == 0u) {
            return;
        }
        if ((_e119 % _e66) > 0u) {
            phi_260_ = (_e121 + 1u);
        } else {
            phi_260_ = _e121;
        }
        let _e127 = phi_260_;
        phi_261_ = _e127;
    } else {
        phi_261_ = 0u;
    }
    let _e129 = phi_261_;
    phi_264_ = type_9(0u, _e129);
    loop {
        let _e132 = phi_264_;
        if (_e132.member < _e132.member_1) {
            phi_265_ = type_9((_e132.member + 1u), _e132.member_1);
            phi_288_ = type_9(1u, _e132.member);
        } else {
            phi_265_ = _e132;
            phi_288_ = type_9(0u, type_9().member_1);
        }
        let _e144 = phi_265_;
        let _e146 = phi_288_;
        let _e150 = (bitcast<i32>(_e146.member) != 0i);
        if _e150 {
            let _e154 = (((_e63 + (_e146.member_1 * _e66)) * 4u) + _e75);
            let _e157 = params.member.member_1.member_1;
            if (_e74 > _e157) {
                let _e161 = params.member.member_1.member_1;
                let _e162 = (_e74 - _e161);
                let _e165 = params.member.member_2.member_3;
                if (_e165 == 0u) {
                    return;
                }
                let _e167 = (_e162 / _e165);
                if (_e165 == 0u) {
                    return;
                }
                if ((_e162 % _e165) > 0u) {
                    phi_329_ = (_e167 + 1u);
                } else {
                    phi_329_ = _e167;
                }
                let _e173 = phi_329_;
                phi_330_ = _e173;
            } else {
                phi_330_ = 0u;
            }
            let _e175 = phi_330_;
            let _e178 = params.member.member_2.member_4;
            if (_e178 < _e175) {
                phi_338_ = _e178;
            } else {
                phi_338_ = _e175;
            }
            let _e181 = phi_338_;
            let _e182 = (_e154 < _e181);
            let _e185 = params.member.member_1.member_1;
            if _e182 {
                let _e188 = params.member.member_2.member_3;
                phi_350_ = (_e154 * _e188);
            } else {
                phi_350_ = 0u;
            }
            let _e191 = phi_350_;
            let _e193 = (2u * (_e185 + _e191));
            let _e196 = input.member[(4u + _e193)];
            let _e199 = input.member[(_e193 + 5u)];
            if (_e51 < 8u) {
                atomicStore((&counters[_e51]), 0u);
            }
            workgroupBarrier();
            let _e207 = params.member.member_2.member[0u][_e82[0]];
            let _e208 = (_e207 + (_e196 * 32u));
            let _e214 = params.member.member_2.member[0u][_e82[1]];
            let _e215 = (_e214 + (_e199 * 32u));
            if (_e76 == 0u) {
                firsts[(2u * _e75)] = _e208;
                firsts[((2u * _e75) + 1u)] = _e215;
            }
            let _e224 = params.member.member_2.member_1;
            if (_e224 == 0u) {
                phi_435_ = array<u32, 2>(0u, 2u);
            } else {
                phi_435_ = array<u32, 2>(1u, 1u);
            }
            let _e227 = phi_435_;
            let _e230 = (_e51 / 32u);
            let _e231 = (_e51 % 32u);
            let _e235 = params.member.member_2.member_2;
            let _e239 = params.member.member_2.member[_e235][_e227[0]];
            let _e242 = nodes.member[(_e239 + _e196)];
            let _e258 = params.member.member_2.member_2;
            let _e262 = params.member.member_2.member[_e258][_e227[1]];
            let _e265 = nodes.member[(_e262 + _e199)];
            let _e281 = params.member.member_2.member_2;
            let _e288 = params.member.member_2.member[(_e281 - 1u)][_e227[0]];
            let _e291 = nodes.member[(_e288 + ((_e196 * 32u) + _e231))];
            let _e310 = params.member.member_2.member_2;
            let _e317 = params.member.member_2.member[(_e310 - 1u)][_e227[1]];
            let _e320 = nodes.member[(_e317 + ((_e199 * 32u) + _e231))];
            if _e182 {
                if ((((((_e320.member.x <= _e242.member_1.y) && (_e242.member.x <= _e320.member_1.y)) && (_e320.member.y <= _e242.member_2.x)) && (_e242.member.y <= _e320.member_2.x)) && (_e320.member_1.x <= _e242.member_2.y)) && (_e242.member_1.x <= _e320.member_2.y)) {
                    let _e346 = atomicAdd((&counters[_e230]), 1u);
                    let _e347 = ((_e230 * 32u) + _e346);
                    columns[_e347] = type_29(array<f32, 3>(_e320.member.x, _e320.member.y, _e320.member_1.x), array<f32, 3>(_e320.member_1.y, _e320.member_2.x, _e320.member_2.y));
                    names[_e347] = _e231;
                }
            }
            workgroupBarrier();
            if _e182 {
                if ((((((_e291.member.x <= _e265.member_1.y) && (_e265.member.x <= _e291.member_1.y)) && (_e291.member.y <= _e265.member_2.x)) && (_e265.member.y <= _e291.member_2.x)) && (_e291.member_1.x <= _e265.member_2.y)) && (_e265.member_1.x <= _e291.member_2.y)) {
                    phi_639_ = false;
                } else {
                    phi_639_ = true;
                }
                let _e365 = phi_639_;
                phi_640_ = _e365;
            } else {
                phi_640_ = true;
            }
            let _e367 = phi_640_;
            if _e367 {
                phi_644_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_644_ = type_29(array<f32, 3>(_e291.member.x, _e291.member.y, _e291.member_1.x), array<f32, 3>(_e291.member_1.y, _e291.member_2.x, _e291.member_2.y));
            }
            let _e369 = phi_644_;
            if (_e82[0] == _e82[1]) {
                phi_650_ = (_e196 == _e199);
            } else {
                phi_650_ = false;
            }
            let _e373 = phi_650_;
            let _e374 = (_e51 / 32u);
            let _e375 = (_e51 % 32u);
            let _e377 = atomicLoad((&counters[_e374]));
            phi_657_ = type_9(0u, _e377);
            phi_660_ = 0u;
            loop {
                let _e380 = phi_657_;
                let _e382 = phi_660_;
                local_4 = _e382;
                if (_e380.member < _e380.member_1) {
                    phi_658_ = type_9((_e380.member + 1u), _e380.member_1);
                    phi_683_ = type_9(1u, _e380.member);
                } else {
                    phi_658_ = _e380;
                    phi_683_ = type_9(0u, type_9().member_1);
                }
                let _e394 = phi_658_;
                let _e396 = phi_683_;
                let _e400 = (bitcast<i32>(_e396.member) != 0i);
                if _e400 {
                    let _e404 = names[((_e374 * 32u) + _e396.member_1)];
                    let _e408 = columns[((_e374 * 32u) + _e396.member_1)];
                    if ((((((_e369.member[0] <= _e408.member_1[0]) && (_e408.member[0] <= _e369.member_1[0])) && (_e369.member[1] <= _e408.member_1[1])) && (_e408.member[1] <= _e369.member_1[1])) && (_e369.member[2] <= _e408.member_1[2])) && (_e408.member[2] <= _e369.member_1[2])) {
                        if _e373 {
                            let _e440 = (_e375 < _e404);
                            if _e440 {
                                phi_749_ = bool();
                            } else {
                                phi_749_ = false;
                            }
                            let _e442 = phi_749_;
                            phi_750_ = _e442;
                            phi_751_ = _e440;
                        } else {
                            phi_750_ = bool();
                            phi_751_ = true;
                        }
                        let _e444 = phi_750_;
                        let _e446 = phi_751_;
                        if _e446 {
                            phi_755_ = true;
                        } else {
                            phi_755_ = _e444;
                        }
                        let _e448 = phi_755_;
                        if _e448 {
                            let _e450 = atomicAdd((&counters[4u]), 1u);
                            if (_e450 < 2048u) {
                                hits[_e450] = (((_e374 << bitcast<u32>(10i)) | (_e375 << bitcast<u32>(5i))) | _e404);
                                phi_773_ = _e382;
                            } else {
                                phi_773_ = (_e382 | (1u << bitcast<u32>((_e396.member_1 & 31u))));
                            }
                            let _e464 = phi_773_;
                            phi_774_ = _e464;
                        } else {
                            phi_774_ = _e382;
                        }
                        let _e466 = phi_774_;
                        phi_775_ = _e466;
                    } else {
                        phi_775_ = _e382;
                    }
                    let _e468 = phi_775_;
                    phi_661_ = _e468;
                } else {
                    phi_661_ = u32();
                }
                let _e470 = phi_661_;
                continue;
                continuing {
                    phi_657_ = _e394;
                    phi_660_ = _e470;
                    break if !(_e400);
                }
            }
            phi_778_ = type_9(0u, 32u);
            let _e2036 = local_4;
            phi_781_ = _e2036;
            loop {
                let _e473 = phi_778_;
                let _e475 = phi_781_;
                if (_e473.member < _e473.member_1) {
                    phi_779_ = type_9((_e473.member + 1u), _e473.member_1);
                    phi_804_ = type_9(1u, _e473.member);
                } else {
                    phi_779_ = _e473;
                    phi_804_ = type_9(0u, type_9().member_1);
                }
                let _e487 = phi_779_;
                let _e489 = phi_804_;
                if (bitcast<i32>(_e489.member) != 0i) {
                    if (_e475 == 0u) {
                        phi_2034_ = u32();
                        phi_2035_ = false;
                    } else {
                        let _e500 = names[((_e75 * 32u) + select(firstTrailingBit(_e475), 32u, (_e475 == 0u)))];
                        let _e503 = (_e208 + _e76);
                        let _e504 = (_e215 + _e500);
                        let _e506 = leaves.member[_e503];
                        let _e508 = leaves.member[_e504];
                        let _e510 = nodes.member[_e503];
                        let _e524 = nodes.member[_e504];
                        let _e539 = params.member.member.member_1;
                        if ((_e539 & 1u) != 0u) {
                            if (_e79 == 0u) {
                                if (_e508.member[0] == _e506.member[0]) {
                                    phi_898_ = true;
                                } else {
                                    phi_898_ = (_e508.member[0] == _e506.member[0]);
                                }
                                let _e567 = phi_898_;
                                if (_e508.member[1] == _e506.member[0]) {
                                    phi_905_ = true;
                                } else {
                                    phi_905_ = (_e508.member[1] == _e506.member[0]);
                                }
                                let _e572 = phi_905_;
                                if (_e508.member[2] == _e506.member[0]) {
                                    phi_913_ = true;
                                } else {
                                    phi_913_ = (_e508.member[2] == _e506.member[0]);
                                }
                                let _e578 = phi_913_;
                                phi_932_ = ((_e567 || _e572) || _e578);
                            } else {
                                if (_e508.member[0] == _e506.member[0]) {
                                    phi_924_ = true;
                                } else {
                                    phi_924_ = (_e508.member[0] == _e506.member[1]);
                                }
                                let _e554 = phi_924_;
                                if (_e508.member[1] == _e506.member[0]) {
                                    phi_930_ = true;
                                } else {
                                    phi_930_ = (_e508.member[1] == _e506.member[1]);
                                }
                                let _e558 = phi_930_;
                                phi_932_ = (_e554 || _e558);
                            }
                            let _e581 = phi_932_;
                            if _e581 {
                                phi_936_ = false;
                            } else {
                                phi_936_ = true;
                            }
                            let _e583 = phi_936_;
                            phi_937_ = _e583;
                        } else {
                            phi_937_ = true;
                        }
                        let _e585 = phi_937_;
                        if _e585 {
                            let _e587 = params.member.member.member_1;
                            if ((_e587 & 2u) != 0u) {
                                let _e593 = bodies.member[_e506.member[0]];
                                let _e597 = bodies.member[_e508.member[0]];
                                if ((_e593 / 4u) != (_e597 / 4u)) {
                                    phi_982_ = true;
                                } else {
                                    if ((_e593 & 2u) == 0u) {
                                        phi_981_ = false;
                                    } else {
                                        phi_981_ = true;
                                    }
                                    let _e604 = phi_981_;
                                    phi_982_ = _e604;
                                }
                                let _e606 = phi_982_;
                                if _e606 {
                                    phi_989_ = (((_e593 & _e597) & 1u) == 0u);
                                } else {
                                    phi_989_ = false;
                                }
                                let _e611 = phi_989_;
                                if _e611 {
                                    let _e613 = params.member.member.member_1;
                                    if ((_e613 & 4u) != 0u) {
                                        let _e618 = params.member.member.member[0u];
                                        let _e620 = bodies.member[_e618];
                                        let _e623 = bodies.member[(_e618 + 1u)];
                                        let _e628 = ((_e618 + 4u) + (2u * (_e593 >> bitcast<u32>(2i))));
                                        let _e633 = ((_e618 + 4u) + (2u * (_e597 >> bitcast<u32>(2i))));
                                        let _e635 = bodies.member[_e628];
                                        let _e637 = bodies.member[_e633];
                                        let _e646 = bodies.member[((((_e618 + 4u) + (2u * _e620)) + (_e635 * _e623)) + (_e637 / 32u))];
                                        let _e649 = bodies.member[(_e628 + 1u)];
                                        let _e652 = bodies.member[(_e633 + 1u)];
                                        if (_e649 == _e652) {
                                            if (((_e646 >> bitcast<u32>(((_e637 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1105_ = true;
                                            } else {
                                                phi_1105_ = ((_e593 >> bitcast<u32>(2i)) == (_e597 >> bitcast<u32>(2i)));
                                            }
                                            let _e666 = phi_1105_;
                                            phi_1106_ = _e666;
                                        } else {
                                            phi_1106_ = false;
                                        }
                                        let _e668 = phi_1106_;
                                        if _e668 {
                                            let _e673 = bodies.member[(_e618 + 2u)];
                                            let _e676 = bodies.member[(_e618 + 3u)];
                                            let _e677 = (_e676 + _e618);
                                            if (_e79 == 1u) {
                                                if (_e508.member_1 < _e506.member_1) {
                                                    phi_1143_ = _e506.member_1;
                                                    phi_1144_ = _e508.member_1;
                                                } else {
                                                    phi_1143_ = _e508.member_1;
                                                    phi_1144_ = _e506.member_1;
                                                }
                                                let _e681 = phi_1143_;
                                                let _e683 = phi_1144_;
                                                phi_1145_ = _e681;
                                                phi_1146_ = _e683;
                                            } else {
                                                phi_1145_ = _e508.member_1;
                                                phi_1146_ = _e506.member_1;
                                            }
                                            let _e685 = phi_1145_;
                                            let _e687 = phi_1146_;
                                            phi_1149_ = type_15(0i, 32i);
                                            phi_1152_ = _e673;
                                            phi_1154_ = 0u;
                                            loop {
                                                let _e689 = phi_1149_;
                                                let _e691 = phi_1152_;
                                                let _e693 = phi_1154_;
                                                local = _e693;
                                                local_1 = _e693;
                                                if (_e689.member < _e689.member_1) {
                                                    let _e700 = (_e689.member + 1i);
                                                    if ((false == (_e700 > _e689.member)) != false) {
                                                        phi_1175_ = true;
                                                    } else {
                                                        phi_1175_ = false;
                                                    }
                                                    let _e705 = phi_1175_;
                                                    if _e705 {
                                                        phi_1181_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1181_ = type_16(1u, _e700);
                                                    }
                                                    let _e710 = phi_1181_;
                                                    phi_1150_ = type_15(_e710.member_1, _e689.member_1);
                                                    phi_1195_ = type_16(1u, _e689.member);
                                                } else {
                                                    phi_1150_ = _e689;
                                                    phi_1195_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e716 = phi_1150_;
                                                let _e718 = phi_1195_;
                                                if (bitcast<i32>(_e718.member) != 0i) {
                                                    if (_e693 >= _e691) {
                                                        phi_1278_ = u32();
                                                        phi_1279_ = u32();
                                                        phi_1280_ = false;
                                                    } else {
                                                        let _e725 = (_e693 + ((_e691 - _e693) / 2u));
                                                        let _e727 = (_e677 + (3u * _e725));
                                                        let _e729 = bodies.member[_e727];
                                                        let _e732 = bodies.member[(_e727 + 1u)];
                                                        let _e735 = bodies.member[(_e727 + 2u)];
                                                        if (_e729 < _e79) {
                                                            phi_1271_ = true;
                                                        } else {
                                                            if (_e729 == _e79) {
                                                                if (_e732 < _e687) {
                                                                    phi_1265_ = false;
                                                                } else {
                                                                    if (_e732 == _e687) {
                                                                        if (_e735 < _e685) {
                                                                            phi_1263_ = false;
                                                                        } else {
                                                                            phi_1263_ = true;
                                                                        }
                                                                        let _e742 = phi_1263_;
                                                                        phi_1264_ = _e742;
                                                                    } else {
                                                                        phi_1264_ = true;
                                                                    }
                                                                    let _e744 = phi_1264_;
                                                                    phi_1265_ = _e744;
                                                                }
                                                                let _e746 = phi_1265_;
                                                                phi_1266_ = _e746;
                                                            } else {
                                                                phi_1266_ = true;
                                                            }
                                                            let _e748 = phi_1266_;
                                                            if _e748 {
                                                                phi_1270_ = false;
                                                            } else {
                                                                phi_1270_ = true;
                                                            }
                                                            let _e750 = phi_1270_;
                                                            phi_1271_ = _e750;
                                                        }
                                                        let _e752 = phi_1271_;
                                                        if _e752 {
                                                            phi_1276_ = _e691;
                                                            phi_1277_ = (_e725 + 1u);
                                                        } else {
                                                            phi_1276_ = _e725;
                                                            phi_1277_ = _e693;
                                                        }
                                                        let _e755 = phi_1276_;
                                                        let _e757 = phi_1277_;
                                                        phi_1278_ = _e755;
                                                        phi_1279_ = _e757;
                                                        phi_1280_ = true;
                                                    }
                                                    let _e759 = phi_1278_;
                                                    let _e761 = phi_1279_;
                                                    let _e763 = phi_1280_;
                                                    phi_1153_ = _e759;
                                                    phi_1155_ = _e761;
                                                    phi_1281_ = _e763;
                                                } else {
                                                    phi_1153_ = u32();
                                                    phi_1155_ = u32();
                                                    phi_1281_ = false;
                                                }
                                                let _e765 = phi_1153_;
                                                let _e767 = phi_1155_;
                                                let _e769 = phi_1281_;
                                                continue;
                                                continuing {
                                                    phi_1149_ = _e716;
                                                    phi_1152_ = _e765;
                                                    phi_1154_ = _e767;
                                                    break if !(_e769);
                                                }
                                            }
                                            let _e772 = local;
                                            if (_e772 < _e673) {
                                                let _e775 = local_1;
                                                let _e777 = (_e677 + (3u * _e775));
                                                let _e779 = bodies.member[_e777];
                                                if (_e779 == _e79) {
                                                    let _e783 = bodies.member[(_e777 + 1u)];
                                                    if (_e783 == _e687) {
                                                        let _e787 = bodies.member[(_e777 + 2u)];
                                                        phi_1329_ = (_e787 == _e685);
                                                        phi_1330_ = false;
                                                    } else {
                                                        phi_1329_ = bool();
                                                        phi_1330_ = true;
                                                    }
                                                    let _e790 = phi_1329_;
                                                    let _e792 = phi_1330_;
                                                    phi_1331_ = _e790;
                                                    phi_1332_ = _e792;
                                                } else {
                                                    phi_1331_ = bool();
                                                    phi_1332_ = true;
                                                }
                                                let _e794 = phi_1331_;
                                                let _e796 = phi_1332_;
                                                if _e796 {
                                                    phi_1336_ = false;
                                                } else {
                                                    phi_1336_ = _e794;
                                                }
                                                let _e798 = phi_1336_;
                                                phi_1337_ = _e798;
                                            } else {
                                                phi_1337_ = false;
                                            }
                                            let _e800 = phi_1337_;
                                            phi_1341_ = _e800;
                                        } else {
                                            phi_1341_ = true;
                                        }
                                        let _e802 = phi_1341_;
                                        if _e802 {
                                            phi_1345_ = false;
                                        } else {
                                            phi_1345_ = true;
                                        }
                                        let _e804 = phi_1345_;
                                        phi_1346_ = _e804;
                                    } else {
                                        phi_1346_ = true;
                                    }
                                    let _e806 = phi_1346_;
                                    if _e806 {
                                        phi_1350_ = false;
                                    } else {
                                        phi_1350_ = true;
                                    }
                                    let _e808 = phi_1350_;
                                    phi_1351_ = _e808;
                                } else {
                                    phi_1351_ = true;
                                }
                                let _e810 = phi_1351_;
                                if _e810 {
                                    phi_1355_ = false;
                                } else {
                                    phi_1355_ = true;
                                }
                                let _e812 = phi_1355_;
                                phi_1356_ = _e812;
                            } else {
                                phi_1356_ = true;
                            }
                            let _e814 = phi_1356_;
                            if _e814 {
                                let _e816 = params.member.member.member_1;
                                if ((_e816 & 32u) != 0u) {
                                    let _e820 = params.member.member.member_6;
                                    let _e837 = (((((_e510.member_1.y - _e524.member.x) > _e820) && ((_e524.member_1.y - _e510.member.x) > _e820)) && (((_e510.member_2.x - _e524.member.y) > _e820) && ((_e524.member_2.x - _e510.member.y) > _e820))) && (((_e510.member_2.y - _e524.member_1.x) > _e820) && ((_e524.member_2.y - _e510.member_1.x) > _e820)));
                                    if _e837 {
                                        phi_1958_ = bool();
                                    } else {
                                        let _e841 = keys.member[_e506.member[0]];
                                        let _e846 = keys.member[_e506.member[1]];
                                        let _e848 = function_5(_e841[0], _e846[0]);
                                        let _e852 = keys.member[_e506.member[2]];
                                        let _e854 = function_5(_e848, _e852[0]);
                                        let _e858 = keys.member[_e508.member[0]];
                                        let _e863 = keys.member[_e508.member[1]];
                                        let _e865 = function_4(_e858[3], _e863[3]);
                                        let _e869 = keys.member[_e508.member[2]];
                                        let _e871 = function_4(_e865, _e869[3]);
                                        if (_e854[1] > _e871[1]) {
                                            phi_1481_ = true;
                                        } else {
                                            if (_e854[1] == _e871[1]) {
                                                phi_1480_ = (_e854[0] > _e871[0]);
                                            } else {
                                                phi_1480_ = false;
                                            }
                                            let _e882 = phi_1480_;
                                            phi_1481_ = _e882;
                                        }
                                        let _e884 = phi_1481_;
                                        let _e889 = keys.member[_e508.member[0]];
                                        let _e894 = keys.member[_e508.member[1]];
                                        let _e896 = function_5(_e889[0], _e894[0]);
                                        let _e900 = keys.member[_e508.member[2]];
                                        let _e902 = function_5(_e896, _e900[0]);
                                        let _e906 = keys.member[_e506.member[0]];
                                        let _e911 = keys.member[_e506.member[1]];
                                        let _e913 = function_4(_e906[3], _e911[3]);
                                        let _e917 = keys.member[_e506.member[2]];
                                        let _e919 = function_4(_e913, _e917[3]);
                                        if (_e902[1] > _e919[1]) {
                                            phi_1575_ = true;
                                        } else {
                                            if (_e902[1] == _e919[1]) {
                                                phi_1574_ = (_e902[0] > _e919[0]);
                                            } else {
                                                phi_1574_ = false;
                                            }
                                            let _e930 = phi_1574_;
                                            phi_1575_ = _e930;
                                        }
                                        let _e932 = phi_1575_;
                                        let _e938 = keys.member[_e506.member[0]];
                                        let _e943 = keys.member[_e506.member[1]];
                                        let _e945 = function_3(_e938[1], _e943[1]);
                                        let _e949 = keys.member[_e506.member[2]];
                                        let _e951 = function_3(_e945, _e949[1]);
                                        let _e955 = keys.member[_e508.member[0]];
                                        let _e960 = keys.member[_e508.member[1]];
                                        let _e962 = function_2(_e955[4], _e960[4]);
                                        let _e966 = keys.member[_e508.member[2]];
                                        let _e968 = function_2(_e962, _e966[4]);
                                        if (_e951[1] > _e968[1]) {
                                            phi_1670_ = true;
                                        } else {
                                            if (_e951[1] == _e968[1]) {
                                                phi_1669_ = (_e951[0] > _e968[0]);
                                            } else {
                                                phi_1669_ = false;
                                            }
                                            let _e979 = phi_1669_;
                                            phi_1670_ = _e979;
                                        }
                                        let _e981 = phi_1670_;
                                        let _e986 = keys.member[_e508.member[0]];
                                        let _e991 = keys.member[_e508.member[1]];
                                        let _e993 = function_3(_e986[1], _e991[1]);
                                        let _e997 = keys.member[_e508.member[2]];
                                        let _e999 = function_3(_e993, _e997[1]);
                                        let _e1003 = keys.member[_e506.member[0]];
                                        let _e1008 = keys.member[_e506.member[1]];
                                        let _e1010 = function_2(_e1003[4], _e1008[4]);
                                        let _e1014 = keys.member[_e506.member[2]];
                                        let _e1016 = function_2(_e1010, _e1014[4]);
                                        if (_e999[1] > _e1016[1]) {
                                            phi_1764_ = true;
                                        } else {
                                            if (_e999[1] == _e1016[1]) {
                                                phi_1763_ = (_e999[0] > _e1016[0]);
                                            } else {
                                                phi_1763_ = false;
                                            }
                                            let _e1027 = phi_1763_;
                                            phi_1764_ = _e1027;
                                        }
                                        let _e1029 = phi_1764_;
                                        let _e1036 = keys.member[_e506.member[0]];
                                        let _e1041 = keys.member[_e506.member[1]];
                                        let _e1043 = function_1(_e1036[2], _e1041[2]);
                                        let _e1047 = keys.member[_e506.member[2]];
                                        let _e1049 = function_1(_e1043, _e1047[2]);
                                        let _e1053 = keys.member[_e508.member[0]];
                                        let _e1058 = keys.member[_e508.member[1]];
                                        let _e1060 = function_(_e1053[5], _e1058[5]);
                                        let _e1064 = keys.member[_e508.member[2]];
                                        let _e1066 = function_(_e1060, _e1064[5]);
                                        if (_e1049[1] > _e1066[1]) {
                                            phi_1860_ = true;
                                        } else {
                                            if (_e1049[1] == _e1066[1]) {
                                                phi_1859_ = (_e1049[0] > _e1066[0]);
                                            } else {
                                                phi_1859_ = false;
                                            }
                                            let _e1077 = phi_1859_;
                                            phi_1860_ = _e1077;
                                        }
                                        let _e1079 = phi_1860_;
                                        let _e1084 = keys.member[_e508.member[0]];
                                        let _e1089 = keys.member[_e508.member[1]];
                                        let _e1091 = function_1(_e1084[2], _e1089[2]);
                                        let _e1095 = keys.member[_e508.member[2]];
                                        let _e1097 = function_1(_e1091, _e1095[2]);
                                        let _e1101 = keys.member[_e506.member[0]];
                                        let _e1106 = keys.member[_e506.member[1]];
                                        let _e1108 = function_(_e1101[5], _e1106[5]);
                                        let _e1112 = keys.member[_e506.member[2]];
                                        let _e1114 = function_(_e1108, _e1112[5]);
                                        if (_e1097[1] > _e1114[1]) {
                                            phi_1954_ = true;
                                        } else {
                                            if (_e1097[1] == _e1114[1]) {
                                                phi_1953_ = (_e1097[0] > _e1114[0]);
                                            } else {
                                                phi_1953_ = false;
                                            }
                                            let _e1125 = phi_1953_;
                                            phi_1954_ = _e1125;
                                        }
                                        let _e1127 = phi_1954_;
                                        phi_1958_ = (((!(_e884) && !(_e932)) && (!(_e981) && !(_e1029))) && (!(_e1079) && !(_e1127)));
                                    }
                                    let _e1132 = phi_1958_;
                                    phi_1959_ = _e1132;
                                    phi_1960_ = _e837;
                                } else {
                                    phi_1959_ = bool();
                                    phi_1960_ = true;
                                }
                                let _e1134 = phi_1959_;
                                let _e1136 = phi_1960_;
                                if _e1136 {
                                    phi_1964_ = false;
                                } else {
                                    phi_1964_ = true;
                                }
                                let _e1138 = phi_1964_;
                                phi_1965_ = _e1134;
                                phi_1966_ = _e1138;
                            } else {
                                phi_1965_ = false;
                                phi_1966_ = true;
                            }
                            let _e1140 = phi_1965_;
                            let _e1142 = phi_1966_;
                            phi_1967_ = _e1140;
                            phi_1968_ = _e1142;
                        } else {
                            phi_1967_ = false;
                            phi_1968_ = true;
                        }
                        let _e1144 = phi_1967_;
                        let _e1146 = phi_1968_;
                        if _e1146 {
                            phi_1972_ = _e1144;
                        } else {
                            phi_1972_ = true;
                        }
                        let _e1148 = phi_1972_;
                        if _e1148 {
                            if (_e82[0] == _e82[1]) {
                                if (_e506.member_1 < _e508.member_1) {
                                    phi_1988_ = type_9(_e506.member_1, _e508.member_1);
                                } else {
                                    phi_1988_ = type_9(_e508.member_1, _e506.member_1);
                                }
                                let _e1157 = phi_1988_;
                                phi_1993_ = _e1157;
                            } else {
                                phi_1993_ = type_9(_e506.member_1, _e508.member_1);
                            }
                            let _e1159 = phi_1993_;
                            let _e1164 = params.member.member_1.member_3;
                            let _e1166 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1166 + 1u) < _e1166) {
                                let _e1170 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1166 < _e1164) {
                                let _e1172 = (2u * _e1166);
                                atomicStore((&output.member[(4u + _e1172)]), _e1159.member);
                                atomicStore((&output.member[(_e1172 + 5u)]), _e1159.member_1);
                            }
                            let _e1178 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1178 + 1u) < _e1178) {
                                let _e1182 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2034_ = (_e475 & (_e475 - 1u));
                        phi_2035_ = true;
                    }
                    let _e1184 = phi_2034_;
                    let _e1186 = phi_2035_;
                    phi_782_ = _e1184;
                    phi_2036_ = _e1186;
                } else {
                    phi_782_ = u32();
                    phi_2036_ = false;
                }
                let _e1188 = phi_782_;
                let _e1190 = phi_2036_;
                continue;
                continuing {
                    phi_778_ = _e487;
                    phi_781_ = _e1188;
                    break if !(_e1190);
                }
            }
            workgroupBarrier();
            let _e1193 = atomicLoad((&counters[4u]));
            if (2048u < _e1193) {
                phi_2043_ = 2048u;
            } else {
                phi_2043_ = _e1193;
            }
            let _e1196 = phi_2043_;
            phi_2046_ = type_9(0u, 16u);
            loop {
                let _e1198 = phi_2046_;
                if (_e1198.member < _e1198.member_1) {
                    phi_2047_ = type_9((_e1198.member + 1u), _e1198.member_1);
                    phi_2070_ = type_9(1u, _e1198.member);
                } else {
                    phi_2047_ = _e1198;
                    phi_2070_ = type_9(0u, type_9().member_1);
                }
                let _e1210 = phi_2047_;
                let _e1212 = phi_2070_;
                if (bitcast<i32>(_e1212.member) != 0i) {
                    let _e1218 = (_e51 + (_e1212.member_1 * 128u));
                    if (_e1218 >= _e1196) {
                        phi_3261_ = false;
                    } else {
                        let _e1221 = hits[_e1218];
                        let _e1224 = ((_e1221 >> bitcast<u32>(10i)) & 3u);
                        let _e1231 = firsts[(2u * _e1224)];
                        let _e1232 = (_e1231 + ((_e1221 >> bitcast<u32>(5i)) & 31u));
                        let _e1236 = firsts[((2u * _e1224) + 1u)];
                        let _e1237 = (_e1236 + (_e1221 & 31u));
                        let _e1239 = leaves.member[_e1232];
                        let _e1241 = leaves.member[_e1237];
                        let _e1243 = nodes.member[_e1232];
                        let _e1257 = nodes.member[_e1237];
                        let _e1272 = params.member.member.member_1;
                        if ((_e1272 & 1u) != 0u) {
                            if (_e79 == 0u) {
                                if (_e1241.member[0] == _e1239.member[0]) {
                                    phi_2172_ = true;
                                } else {
                                    phi_2172_ = (_e1241.member[0] == _e1239.member[0]);
                                }
                                let _e1300 = phi_2172_;
                                if (_e1241.member[1] == _e1239.member[0]) {
                                    phi_2179_ = true;
                                } else {
                                    phi_2179_ = (_e1241.member[1] == _e1239.member[0]);
                                }
                                let _e1305 = phi_2179_;
                                if (_e1241.member[2] == _e1239.member[0]) {
                                    phi_2187_ = true;
                                } else {
                                    phi_2187_ = (_e1241.member[2] == _e1239.member[0]);
                                }
                                let _e1311 = phi_2187_;
                                phi_2206_ = ((_e1300 || _e1305) || _e1311);
                            } else {
                                if (_e1241.member[0] == _e1239.member[0]) {
                                    phi_2198_ = true;
                                } else {
                                    phi_2198_ = (_e1241.member[0] == _e1239.member[1]);
                                }
                                let _e1287 = phi_2198_;
                                if (_e1241.member[1] == _e1239.member[0]) {
                                    phi_2204_ = true;
                                } else {
                                    phi_2204_ = (_e1241.member[1] == _e1239.member[1]);
                                }
                                let _e1291 = phi_2204_;
                                phi_2206_ = (_e1287 || _e1291);
                            }
                            let _e1314 = phi_2206_;
                            if _e1314 {
                                phi_2210_ = false;
                            } else {
                                phi_2210_ = true;
                            }
                            let _e1316 = phi_2210_;
                            phi_2211_ = _e1316;
                        } else {
                            phi_2211_ = true;
                        }
                        let _e1318 = phi_2211_;
                        if _e1318 {
                            let _e1320 = params.member.member.member_1;
                            if ((_e1320 & 2u) != 0u) {
                                let _e1326 = bodies.member[_e1239.member[0]];
                                let _e1330 = bodies.member[_e1241.member[0]];
                                if ((_e1326 / 4u) != (_e1330 / 4u)) {
                                    phi_2256_ = true;
                                } else {
                                    if ((_e1326 & 2u) == 0u) {
                                        phi_2255_ = false;
                                    } else {
                                        phi_2255_ = true;
                                    }
                                    let _e1337 = phi_2255_;
                                    phi_2256_ = _e1337;
                                }
                                let _e1339 = phi_2256_;
                                if _e1339 {
                                    phi_2263_ = (((_e1326 & _e1330) & 1u) == 0u);
                                } else {
                                    phi_2263_ = false;
                                }
                                let _e1344 = phi_2263_;
                                if _e1344 {
                                    let _e1346 = params.member.member.member_1;
                                    if ((_e1346 & 4u) != 0u) {
                                        let _e1351 = params.member.member.member[0u];
                                        let _e1353 = bodies.member[_e1351];
                                        let _e1356 = bodies.member[(_e1351 + 1u)];
                                        let _e1361 = ((_e1351 + 4u) + (2u * (_e1326 >> bitcast<u32>(2i))));
                                        let _e1366 = ((_e1351 + 4u) + (2u * (_e1330 >> bitcast<u32>(2i))));
                                        let _e1368 = bodies.member[_e1361];
                                        let _e1370 = bodies.member[_e1366];
                                        let _e1379 = bodies.member[((((_e1351 + 4u) + (2u * _e1353)) + (_e1368 * _e1356)) + (_e1370 / 32u))];
                                        let _e1382 = bodies.member[(_e1361 + 1u)];
                                        let _e1385 = bodies.member[(_e1366 + 1u)];
                                        if (_e1382 == _e1385) {
                                            if (((_e1379 >> bitcast<u32>(((_e1370 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2379_ = true;
                                            } else {
                                                phi_2379_ = ((_e1326 >> bitcast<u32>(2i)) == (_e1330 >> bitcast<u32>(2i)));
                                            }
                                            let _e1399 = phi_2379_;
                                            phi_2380_ = _e1399;
                                        } else {
                                            phi_2380_ = false;
                                        }
                                        let _e1401 = phi_2380_;
                                        if _e1401 {
                                            let _e1406 = bodies.member[(_e1351 + 2u)];
                                            let _e1409 = bodies.member[(_e1351 + 3u)];
                                            let _e1410 = (_e1409 + _e1351);
                                            if (_e79 == 1u) {
                                                if (_e1241.member_1 < _e1239.member_1) {
                                                    phi_2417_ = _e1239.member_1;
                                                    phi_2418_ = _e1241.member_1;
                                                } else {
                                                    phi_2417_ = _e1241.member_1;
                                                    phi_2418_ = _e1239.member_1;
                                                }
                                                let _e1414 = phi_2417_;
                                                let _e1416 = phi_2418_;
                                                phi_2419_ = _e1414;
                                                phi_2420_ = _e1416;
                                            } else {
                                                phi_2419_ = _e1241.member_1;
                                                phi_2420_ = _e1239.member_1;
                                            }
                                            let _e1418 = phi_2419_;
                                            let _e1420 = phi_2420_;
                                            phi_2423_ = type_15(0i, 32i);
                                            phi_2426_ = _e1406;
                                            phi_2428_ = 0u;
                                            loop {
                                                let _e1422 = phi_2423_;
                                                let _e1424 = phi_2426_;
                                                let _e1426 = phi_2428_;
                                                local_2 = _e1426;
                                                local_3 = _e1426;
                                                if (_e1422.member < _e1422.member_1) {
                                                    let _e1433 = (_e1422.member + 1i);
                                                    if ((false == (_e1433 > _e1422.member)) != false) {
                                                        phi_2449_ = true;
                                                    } else {
                                                        phi_2449_ = false;
                                                    }
                                                    let _e1438 = phi_2449_;
                                                    if _e1438 {
                                                        phi_2455_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2455_ = type_16(1u, _e1433);
                                                    }
                                                    let _e1443 = phi_2455_;
                                                    phi_2424_ = type_15(_e1443.member_1, _e1422.member_1);
                                                    phi_2469_ = type_16(1u, _e1422.member);
                                                } else {
                                                    phi_2424_ = _e1422;
                                                    phi_2469_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1449 = phi_2424_;
                                                let _e1451 = phi_2469_;
                                                if (bitcast<i32>(_e1451.member) != 0i) {
                                                    if (_e1426 >= _e1424) {
                                                        phi_2552_ = u32();
                                                        phi_2553_ = u32();
                                                        phi_2554_ = false;
                                                    } else {
                                                        let _e1458 = (_e1426 + ((_e1424 - _e1426) / 2u));
                                                        let _e1460 = (_e1410 + (3u * _e1458));
                                                        let _e1462 = bodies.member[_e1460];
                                                        let _e1465 = bodies.member[(_e1460 + 1u)];
                                                        let _e1468 = bodies.member[(_e1460 + 2u)];
                                                        if (_e1462 < _e79) {
                                                            phi_2545_ = true;
                                                        } else {
                                                            if (_e1462 == _e79) {
                                                                if (_e1465 < _e1420) {
                                                                    phi_2539_ = false;
                                                                } else {
                                                                    if (_e1465 == _e1420) {
                                                                        if (_e1468 < _e1418) {
                                                                            phi_2537_ = false;
                                                                        } else {
                                                                            phi_2537_ = true;
                                                                        }
                                                                        let _e1475 = phi_2537_;
                                                                        phi_2538_ = _e1475;
                                                                    } else {
                                                                        phi_2538_ = true;
                                                                    }
                                                                    let _e1477 = phi_2538_;
                                                                    phi_2539_ = _e1477;
                                                                }
                                                                let _e1479 = phi_2539_;
                                                                phi_2540_ = _e1479;
                                                            } else {
                                                                phi_2540_ = true;
                                                            }
                                                            let _e1481 = phi_2540_;
                                                            if _e1481 {
                                                                phi_2544_ = false;
                                                            } else {
                                                                phi_2544_ = true;
                                                            }
                                                            let _e1483 = phi_2544_;
                                                            phi_2545_ = _e1483;
                                                        }
                                                        let _e1485 = phi_2545_;
                                                        if _e1485 {
                                                            phi_2550_ = _e1424;
                                                            phi_2551_ = (_e1458 + 1u);
                                                        } else {
                                                            phi_2550_ = _e1458;
                                                            phi_2551_ = _e1426;
                                                        }
                                                        let _e1488 = phi_2550_;
                                                        let _e1490 = phi_2551_;
                                                        phi_2552_ = _e1488;
                                                        phi_2553_ = _e1490;
                                                        phi_2554_ = true;
                                                    }
                                                    let _e1492 = phi_2552_;
                                                    let _e1494 = phi_2553_;
                                                    let _e1496 = phi_2554_;
                                                    phi_2427_ = _e1492;
                                                    phi_2429_ = _e1494;
                                                    phi_2555_ = _e1496;
                                                } else {
                                                    phi_2427_ = u32();
                                                    phi_2429_ = u32();
                                                    phi_2555_ = false;
                                                }
                                                let _e1498 = phi_2427_;
                                                let _e1500 = phi_2429_;
                                                let _e1502 = phi_2555_;
                                                continue;
                                                continuing {
                                                    phi_2423_ = _e1449;
                                                    phi_2426_ = _e1498;
                                                    phi_2428_ = _e1500;
                                                    break if !(_e1502);
                                                }
                                            }
                                            let _e1505 = local_2;
                                            if (_e1505 < _e1406) {
                                                let _e1508 = local_3;
                                                let _e1510 = (_e1410 + (3u * _e1508));
                                                let _e1512 = bodies.member[_e1510];
                                                if (_e1512 == _e79) {
                                                    let _e1516 = bodies.member[(_e1510 + 1u)];
                                                    if (_e1516 == _e1420) {
                                                        let _e1520 = bodies.member[(_e1510 + 2u)];
                                                        phi_2603_ = (_e1520 == _e1418);
                                                        phi_2604_ = false;
                                                    } else {
                                                        phi_2603_ = bool();
                                                        phi_2604_ = true;
                                                    }
                                                    let _e1523 = phi_2603_;
                                                    let _e1525 = phi_2604_;
                                                    phi_2605_ = _e1523;
                                                    phi_2606_ = _e1525;
                                                } else {
                                                    phi_2605_ = bool();
                                                    phi_2606_ = true;
                                                }
                                                let _e1527 = phi_2605_;
                                                let _e1529 = phi_2606_;
                                                if _e1529 {
                                                    phi_2610_ = false;
                                                } else {
                                                    phi_2610_ = _e1527;
                                                }
                                                let _e1531 = phi_2610_;
                                                phi_2611_ = _e1531;
                                            } else {
                                                phi_2611_ = false;
                                            }
                                            let _e1533 = phi_2611_;
                                            phi_2615_ = _e1533;
                                        } else {
                                            phi_2615_ = true;
                                        }
                                        let _e1535 = phi_2615_;
                                        if _e1535 {
                                            phi_2619_ = false;
                                        } else {
                                            phi_2619_ = true;
                                        }
                                        let _e1537 = phi_2619_;
                                        phi_2620_ = _e1537;
                                    } else {
                                        phi_2620_ = true;
                                    }
                                    let _e1539 = phi_2620_;
                                    if _e1539 {
                                        phi_2624_ = false;
                                    } else {
                                        phi_2624_ = true;
                                    }
                                    let _e1541 = phi_2624_;
                                    phi_2625_ = _e1541;
                                } else {
                                    phi_2625_ = true;
                                }
                                let _e1543 = phi_2625_;
                                if _e1543 {
                                    phi_2629_ = false;
                                } else {
                                    phi_2629_ = true;
                                }
                                let _e1545 = phi_2629_;
                                phi_2630_ = _e1545;
                            } else {
                                phi_2630_ = true;
                            }
                            let _e1547 = phi_2630_;
                            if _e1547 {
                                let _e1549 = params.member.member.member_1;
                                if ((_e1549 & 32u) != 0u) {
                                    let _e1553 = params.member.member.member_6;
                                    let _e1570 = (((((_e1243.member_1.y - _e1257.member.x) > _e1553) && ((_e1257.member_1.y - _e1243.member.x) > _e1553)) && (((_e1243.member_2.x - _e1257.member.y) > _e1553) && ((_e1257.member_2.x - _e1243.member.y) > _e1553))) && (((_e1243.member_2.y - _e1257.member_1.x) > _e1553) && ((_e1257.member_2.y - _e1243.member_1.x) > _e1553)));
                                    if _e1570 {
                                        phi_3232_ = bool();
                                    } else {
                                        let _e1574 = keys.member[_e1239.member[0]];
                                        let _e1579 = keys.member[_e1239.member[1]];
                                        let _e1581 = function_5(_e1574[0], _e1579[0]);
                                        let _e1585 = keys.member[_e1239.member[2]];
                                        let _e1587 = function_5(_e1581, _e1585[0]);
                                        let _e1591 = keys.member[_e1241.member[0]];
                                        let _e1596 = keys.member[_e1241.member[1]];
                                        let _e1598 = function_4(_e1591[3], _e1596[3]);
                                        let _e1602 = keys.member[_e1241.member[2]];
                                        let _e1604 = function_4(_e1598, _e1602[3]);
                                        if (_e1587[1] > _e1604[1]) {
                                            phi_2755_ = true;
                                        } else {
                                            if (_e1587[1] == _e1604[1]) {
                                                phi_2754_ = (_e1587[0] > _e1604[0]);
                                            } else {
                                                phi_2754_ = false;
                                            }
                                            let _e1615 = phi_2754_;
                                            phi_2755_ = _e1615;
                                        }
                                        let _e1617 = phi_2755_;
                                        let _e1622 = keys.member[_e1241.member[0]];
                                        let _e1627 = keys.member[_e1241.member[1]];
                                        let _e1629 = function_5(_e1622[0], _e1627[0]);
                                        let _e1633 = keys.member[_e1241.member[2]];
                                        let _e1635 = function_5(_e1629, _e1633[0]);
                                        let _e1639 = keys.member[_e1239.member[0]];
                                        let _e1644 = keys.member[_e1239.member[1]];
                                        let _e1646 = function_4(_e1639[3], _e1644[3]);
                                        let _e1650 = keys.member[_e1239.member[2]];
                                        let _e1652 = function_4(_e1646, _e1650[3]);
                                        if (_e1635[1] > _e1652[1]) {
                                            phi_2849_ = true;
                                        } else {
                                            if (_e1635[1] == _e1652[1]) {
                                                phi_2848_ = (_e1635[0] > _e1652[0]);
                                            } else {
                                                phi_2848_ = false;
                                            }
                                            let _e1663 = phi_2848_;
                                            phi_2849_ = _e1663;
                                        }
                                        let _e1665 = phi_2849_;
                                        let _e1671 = keys.member[_e1239.member[0]];
                                        let _e1676 = keys.member[_e1239.member[1]];
                                        let _e1678 = function_3(_e1671[1], _e1676[1]);
                                        let _e1682 = keys.member[_e1239.member[2]];
                                        let _e1684 = function_3(_e1678, _e1682[1]);
                                        let _e1688 = keys.member[_e1241.member[0]];
                                        let _e1693 = keys.member[_e1241.member[1]];
                                        let _e1695 = function_2(_e1688[4], _e1693[4]);
                                        let _e1699 = keys.member[_e1241.member[2]];
                                        let _e1701 = function_2(_e1695, _e1699[4]);
                                        if (_e1684[1] > _e1701[1]) {
                                            phi_2944_ = true;
                                        } else {
                                            if (_e1684[1] == _e1701[1]) {
                                                phi_2943_ = (_e1684[0] > _e1701[0]);
                                            } else {
                                                phi_2943_ = false;
                                            }
                                            let _e1712 = phi_2943_;
                                            phi_2944_ = _e1712;
                                        }
                                        let _e1714 = phi_2944_;
                                        let _e1719 = keys.member[_e1241.member[0]];
                                        let _e1724 = keys.member[_e1241.member[1]];
                                        let _e1726 = function_3(_e1719[1], _e1724[1]);
                                        let _e1730 = keys.member[_e1241.member[2]];
                                        let _e1732 = function_3(_e1726, _e1730[1]);
                                        let _e1736 = keys.member[_e1239.member[0]];
                                        let _e1741 = keys.member[_e1239.member[1]];
                                        let _e1743 = function_2(_e1736[4], _e1741[4]);
                                        let _e1747 = keys.member[_e1239.member[2]];
                                        let _e1749 = function_2(_e1743, _e1747[4]);
                                        if (_e1732[1] > _e1749[1]) {
                                            phi_3038_ = true;
                                        } else {
                                            if (_e1732[1] == _e1749[1]) {
                                                phi_3037_ = (_e1732[0] > _e1749[0]);
                                            } else {
                                                phi_3037_ = false;
                                            }
                                            let _e1760 = phi_3037_;
                                            phi_3038_ = _e1760;
                                        }
                                        let _e1762 = phi_3038_;
                                        let _e1769 = keys.member[_e1239.member[0]];
                                        let _e1774 = keys.member[_e1239.member[1]];
                                        let _e1776 = function_1(_e1769[2], _e1774[2]);
                                        let _e1780 = keys.member[_e1239.member[2]];
                                        let _e1782 = function_1(_e1776, _e1780[2]);
                                        let _e1786 = keys.member[_e1241.member[0]];
                                        let _e1791 = keys.member[_e1241.member[1]];
                                        let _e1793 = function_(_e1786[5], _e1791[5]);
                                        let _e1797 = keys.member[_e1241.member[2]];
                                        let _e1799 = function_(_e1793, _e1797[5]);
                                        if (_e1782[1] > _e1799[1]) {
                                            phi_3134_ = true;
                                        } else {
                                            if (_e1782[1] == _e1799[1]) {
                                                phi_3133_ = (_e1782[0] > _e1799[0]);
                                            } else {
                                                phi_3133_ = false;
                                            }
                                            let _e1810 = phi_3133_;
                                            phi_3134_ = _e1810;
                                        }
                                        let _e1812 = phi_3134_;
                                        let _e1817 = keys.member[_e1241.member[0]];
                                        let _e1822 = keys.member[_e1241.member[1]];
                                        let _e1824 = function_1(_e1817[2], _e1822[2]);
                                        let _e1828 = keys.member[_e1241.member[2]];
                                        let _e1830 = function_1(_e1824, _e1828[2]);
                                        let _e1834 = keys.member[_e1239.member[0]];
                                        let _e1839 = keys.member[_e1239.member[1]];
                                        let _e1841 = function_(_e1834[5], _e1839[5]);
                                        let _e1845 = keys.member[_e1239.member[2]];
                                        let _e1847 = function_(_e1841, _e1845[5]);
                                        if (_e1830[1] > _e1847[1]) {
                                            phi_3228_ = true;
                                        } else {
                                            if (_e1830[1] == _e1847[1]) {
                                                phi_3227_ = (_e1830[0] > _e1847[0]);
                                            } else {
                                                phi_3227_ = false;
                                            }
                                            let _e1858 = phi_3227_;
                                            phi_3228_ = _e1858;
                                        }
                                        let _e1860 = phi_3228_;
                                        phi_3232_ = (((!(_e1617) && !(_e1665)) && (!(_e1714) && !(_e1762))) && (!(_e1812) && !(_e1860)));
                                    }
                                    let _e1865 = phi_3232_;
                                    phi_3233_ = _e1865;
                                    phi_3234_ = _e1570;
                                } else {
                                    phi_3233_ = bool();
                                    phi_3234_ = true;
                                }
                                let _e1867 = phi_3233_;
                                let _e1869 = phi_3234_;
                                if _e1869 {
                                    phi_3238_ = false;
                                } else {
                                    phi_3238_ = true;
                                }
                                let _e1871 = phi_3238_;
                                phi_3239_ = _e1867;
                                phi_3240_ = _e1871;
                            } else {
                                phi_3239_ = false;
                                phi_3240_ = true;
                            }
                            let _e1873 = phi_3239_;
                            let _e1875 = phi_3240_;
                            phi_3241_ = _e1873;
                            phi_3242_ = _e1875;
                        } else {
                            phi_3241_ = false;
                            phi_3242_ = true;
                        }
                        let _e1877 = phi_3241_;
                        let _e1879 = phi_3242_;
                        if _e1879 {
                            phi_3246_ = _e1877;
                        } else {
                            phi_3246_ = true;
                        }
                        let _e1881 = phi_3246_;
                        if _e1881 {
                            let _e1883 = atomicAdd((&counters[7u]), 1u);
                            let _e1885 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1218] = ((2147483648u | (_e1885 << bitcast<u32>(12i))) | _e1221);
                        }
                        phi_3261_ = true;
                    }
                    let _e1892 = phi_3261_;
                    phi_3262_ = _e1892;
                } else {
                    phi_3262_ = false;
                }
                let _e1894 = phi_3262_;
                continue;
                continuing {
                    phi_2046_ = _e1210;
                    break if !(_e1894);
                }
            }
            workgroupBarrier();
            if (_e51 == 0u) {
                let _e1898 = atomicLoad((&counters[5u]));
                if (_e1898 > 0u) {
                    let _e1901 = atomicAdd((&output.member[0u]), _e1898);
                    if ((_e1901 + _e1898) < _e1901) {
                        let _e1905 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1901);
                }
            }
            workgroupBarrier();
            let _e1908 = atomicLoad((&counters[6u]));
            if (_e51 == 0u) {
                let _e1911 = atomicLoad((&counters[7u]));
                if (_e1911 > 0u) {
                    let _e1914 = atomicAdd((&output.member[1u]), _e1911);
                    if ((_e1914 + _e1911) < _e1914) {
                        let _e1918 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_3312_ = type_9(0u, 16u);
            loop {
                let _e1920 = phi_3312_;
                if (_e1920.member < _e1920.member_1) {
                    phi_3313_ = type_9((_e1920.member + 1u), _e1920.member_1);
                    phi_3336_ = type_9(1u, _e1920.member);
                } else {
                    phi_3313_ = _e1920;
                    phi_3336_ = type_9(0u, type_9().member_1);
                }
                let _e1932 = phi_3313_;
                let _e1934 = phi_3336_;
                if (bitcast<i32>(_e1934.member) != 0i) {
                    let _e1940 = (_e51 + (_e1934.member_1 * 128u));
                    if (_e1940 >= _e1196) {
                        phi_3433_ = false;
                    } else {
                        let _e1943 = hits[_e1940];
                        if ((_e1943 & 2147483648u) == 0u) {
                            phi_3359_ = 4294967295u;
                        } else {
                            phi_3359_ = ((_e1943 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1950 = phi_3359_;
                        if (_e1950 != 4294967295u) {
                            let _e1954 = ((_e1943 >> bitcast<u32>(10i)) & 3u);
                            let _e1961 = firsts[(2u * _e1954)];
                            let _e1964 = leaves.member[(_e1961 + ((_e1943 >> bitcast<u32>(5i)) & 31u))];
                            let _e1968 = firsts[((2u * _e1954) + 1u)];
                            let _e1971 = leaves.member[(_e1968 + (_e1943 & 31u))];
                            let _e1976 = params.member.member_1.member_3;
                            let _e1977 = (_e1908 + _e1950);
                            if (_e82[0] == _e82[1]) {
                                if (_e1964.member_1 < _e1971.member_1) {
                                    phi_3414_ = type_9(_e1964.member_1, _e1971.member_1);
                                } else {
                                    phi_3414_ = type_9(_e1971.member_1, _e1964.member_1);
                                }
                                let _e1984 = phi_3414_;
                                phi_3419_ = _e1984;
                            } else {
                                phi_3419_ = type_9(_e1964.member_1, _e1971.member_1);
                            }
                            let _e1986 = phi_3419_;
                            if (_e1977 < _e1976) {
                                let _e1990 = (2u * _e1977);
                                atomicStore((&output.member[(4u + _e1990)]), _e1986.member);
                                atomicStore((&output.member[(_e1990 + 5u)]), _e1986.member_1);
                            }
                        }
                        phi_3433_ = true;
                    }
                    let _e1996 = phi_3433_;
                    phi_3434_ = _e1996;
                } else {
                    phi_3434_ = false;
                }
                let _e1998 = phi_3434_;
                continue;
                continuing {
                    phi_3312_ = _e1932;
                    break if !(_e1998);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_264_ = _e144;
            break if !(_e150);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
