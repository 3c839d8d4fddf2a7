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
    member: array<vec4<f32>>,
}

struct type_39 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_43 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> ends: type_36;
@group(0) @binding(4) 
var<storage> bodies: type_11;
@group(0) @binding(5) 
var<storage> keys: type_39;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_43;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_3121_: bool;
    var phi_3122_: bool;
    var phi_3126_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_3122_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_3121_ = (param_1[0] > param[0]);
        } else {
            phi_3121_ = false;
        }
        let _e14 = phi_3121_;
        phi_3122_ = _e14;
    }
    let _e16 = phi_3122_;
    if _e16 {
        phi_3126_ = param_1;
    } else {
        phi_3126_ = param;
    }
    let _e18 = phi_3126_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3102_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_3098_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_3097_ = (param_2[0] > param_3[0]);
        } else {
            phi_3097_ = false;
        }
        let _e14 = phi_3097_;
        phi_3098_ = _e14;
    }
    let _e16 = phi_3098_;
    if _e16 {
        phi_3102_ = param_3;
    } else {
        phi_3102_ = param_2;
    }
    let _e18 = phi_3102_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3078_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_3074_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_3073_ = (param_5[0] > param_4[0]);
        } else {
            phi_3073_ = false;
        }
        let _e14 = phi_3073_;
        phi_3074_ = _e14;
    }
    let _e16 = phi_3074_;
    if _e16 {
        phi_3078_ = param_5;
    } else {
        phi_3078_ = param_4;
    }
    let _e18 = phi_3078_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_3049_: bool;
    var phi_3050_: bool;
    var phi_3054_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_3050_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_3049_ = (param_6[0] > param_7[0]);
        } else {
            phi_3049_ = false;
        }
        let _e14 = phi_3049_;
        phi_3050_ = _e14;
    }
    let _e16 = phi_3050_;
    if _e16 {
        phi_3054_ = param_7;
    } else {
        phi_3054_ = param_6;
    }
    let _e18 = phi_3054_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_3025_: bool;
    var phi_3026_: bool;
    var phi_3030_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_3026_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_3025_ = (param_9[0] > param_8[0]);
        } else {
            phi_3025_ = false;
        }
        let _e14 = phi_3025_;
        phi_3026_ = _e14;
    }
    let _e16 = phi_3026_;
    if _e16 {
        phi_3030_ = param_9;
    } else {
        phi_3030_ = param_8;
    }
    let _e18 = phi_3030_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3006_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_3002_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_3001_ = (param_10[0] > param_11[0]);
        } else {
            phi_3001_ = false;
        }
        let _e14 = phi_3001_;
        phi_3002_ = _e14;
    }
    let _e16 = phi_3002_;
    if _e16 {
        phi_3006_ = param_11;
    } else {
        phi_3006_ = param_10;
    }
    let _e18 = phi_3006_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_205_: u32;
    var phi_254_: u32;
    var phi_255_: u32;
    var phi_263_: u32;
    var phi_279_: u32;
    var phi_302_: u32;
    var phi_303_: u32;
    var phi_306_: type_9;
    var phi_307_: type_9;
    var phi_332_: type_9;
    var phi_379_: u32;
    var phi_380_: u32;
    var phi_388_: u32;
    var phi_402_: u32;
    var phi_445_: array<u32, 2>;
    var phi_505_: array<u32, 2>;
    var phi_666_: bool;
    var phi_704_: type_29;
    var phi_710_: bool;
    var phi_733_: u32;
    var phi_736_: type_9;
    var phi_739_: u32;
    var phi_737_: type_9;
    var phi_762_: type_9;
    var phi_740_: u32;
    var local: u32;
    var phi_951_: u32;
    var phi_1057_: type_9;
    var phi_1060_: u32;
    var phi_1058_: type_9;
    var phi_1083_: type_9;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1113_: bool;
    var phi_1121_: bool;
    var phi_1129_: u32;
    var phi_1061_: u32;
    var phi_1130_: u32;
    var phi_1140_: type_9;
    var phi_1166_: u32;
    var phi_1179_: type_9;
    var phi_1182_: type_9;
    var phi_1180_: type_9;
    var phi_1207_: type_9;
    var phi_1224_: type_9;
    var phi_1227_: type_9;
    var phi_1228_: type_9;
    var phi_1250_: type_9;
    var phi_1284_: type_9;
    var phi_1285_: bool;
    var phi_1225_: type_9;
    var phi_1286_: bool;
    var phi_1294_: u32;
    var phi_1297_: type_9;
    var phi_1298_: type_9;
    var phi_1323_: type_9;
    var phi_1519_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1752_: bool;
    var phi_1758_: bool;
    var phi_1730_: bool;
    var phi_1737_: bool;
    var phi_1745_: bool;
    var phi_1760_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1806_: bool;
    var phi_1807_: bool;
    var phi_1814_: bool;
    var phi_1928_: bool;
    var phi_1929_: bool;
    var phi_1964_: u32;
    var phi_1965_: u32;
    var phi_1966_: u32;
    var phi_1967_: u32;
    var phi_1970_: type_15;
    var phi_1973_: u32;
    var phi_1975_: u32;
    var phi_1996_: bool;
    var phi_2002_: type_16;
    var phi_1971_: type_15;
    var phi_2016_: type_16;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2086_: bool;
    var phi_2087_: bool;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2097_: u32;
    var phi_2098_: u32;
    var phi_2099_: u32;
    var phi_2100_: u32;
    var phi_2101_: bool;
    var phi_1974_: u32;
    var phi_1976_: u32;
    var phi_2102_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2150_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_2153_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2293_: bool;
    var phi_2294_: bool;
    var phi_2381_: bool;
    var phi_2382_: bool;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2749_: bool;
    var phi_2750_: bool;
    var phi_2751_: bool;
    var phi_2755_: bool;
    var phi_2775_: bool;
    var phi_2776_: bool;
    var phi_2809_: u32;
    var phi_2832_: u32;
    var phi_2839_: type_9;
    var phi_2840_: type_9;
    var phi_2863_: type_9;
    var phi_2887_: u32;
    var phi_2939_: type_9;
    var phi_2944_: type_9;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_1183_: type_9;
    var local_3: u32;
    var local_4: u32;
    var local_5: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e70 = ((_e55.y * _e56.x) + _e55.x);
    let _e73 = (_e56.x * _e56.y);
    let _e75 = params.member.member;
    let _e78 = params.member.member_2.member_1;
    let _e84 = params.member.member_1.member_2;
    let _e86 = input.member[0u];
    if (_e84 < _e86) {
        phi_205_ = _e84;
    } else {
        phi_205_ = _e86;
    }
    let _e89 = phi_205_;
    if (_e57 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    let _e94 = params.member.member_1.member_1;
    if (_e89 > _e94) {
        let _e98 = params.member.member_1.member_1;
        let _e99 = (_e89 - _e98);
        let _e102 = params.member.member_2.member_3;
        if (_e102 == 0u) {
            return;
        }
        let _e104 = (_e99 / _e102);
        if (_e102 == 0u) {
            return;
        }
        if ((_e99 % _e102) > 0u) {
            phi_254_ = (_e104 + 1u);
        } else {
            phi_254_ = _e104;
        }
        let _e110 = phi_254_;
        phi_255_ = _e110;
    } else {
        phi_255_ = 0u;
    }
    let _e112 = phi_255_;
    let _e115 = params.member.member_2.member_4;
    if (_e115 < _e112) {
        phi_263_ = _e115;
    } else {
        phi_263_ = _e112;
    }
    let _e118 = phi_263_;
    let _e119 = (_e118 / 4u);
    if ((_e118 % 4u) > 0u) {
        phi_279_ = (_e119 + 1u);
    } else {
        phi_279_ = _e119;
    }
    let _e124 = phi_279_;
    if (_e124 > _e70) {
        let _e126 = (_e124 - _e70);
        if (_e73 == 0u) {
            return;
        }
        let _e128 = (_e126 / _e73);
        if (_e73 == 0u) {
            return;
        }
        if ((_e126 % _e73) > 0u) {
            phi_302_ = (_e128 + 1u);
        } else {
            phi_302_ = _e128;
        }
        let _e134 = phi_302_;
        phi_303_ = _e134;
    } else {
        phi_303_ = 0u;
    }
    let _e136 = phi_303_;
    phi_306_ = type_9(0u, _e136);
    loop {
        let _e139 = phi_306_;
        if (_e139.member < _e139.member_1) {
            phi_307_ = type_9((_e139.member + 1u), _e139.member_1);
            phi_332_ = type_9(1u, _e139.member);
        } else {
            phi_307_ = _e139;
            phi_332_ = type_9(0u, type_9().member_1);
        }
        let _e151 = phi_307_;
        let _e153 = phi_332_;
        let _e157 = (bitcast<i32>(_e153.member) != 0i);
        if _e157 {
            let _e162 = (((_e70 + (_e153.member_1 * _e73)) * 4u) + (_e57 / 32u));
            let _e165 = params.member.member_1.member_1;
            if (_e89 > _e165) {
                let _e169 = params.member.member_1.member_1;
                let _e170 = (_e89 - _e169);
                let _e173 = params.member.member_2.member_3;
                if (_e173 == 0u) {
                    return;
                }
                let _e175 = (_e170 / _e173);
                if (_e173 == 0u) {
                    return;
                }
                if ((_e170 % _e173) > 0u) {
                    phi_379_ = (_e175 + 1u);
                } else {
                    phi_379_ = _e175;
                }
                let _e181 = phi_379_;
                phi_380_ = _e181;
            } else {
                phi_380_ = 0u;
            }
            let _e183 = phi_380_;
            let _e186 = params.member.member_2.member_4;
            if (_e186 < _e183) {
                phi_388_ = _e186;
            } else {
                phi_388_ = _e183;
            }
            let _e189 = phi_388_;
            let _e190 = (_e162 < _e189);
            let _e193 = params.member.member_1.member_1;
            let _e196 = params.member.member_2.member_3;
            if _e190 {
                phi_402_ = (_e162 * _e196);
            } else {
                phi_402_ = 0u;
            }
            let _e199 = phi_402_;
            let _e201 = (2u * (_e193 + _e199));
            let _e204 = input.member[(4u + _e201)];
            let _e207 = input.member[(_e201 + 5u)];
            if (_e57 <= 5u) {
                atomicStore((&counters[_e57]), 0u);
            }
            workgroupBarrier();
            if (_e78 == 0u) {
                phi_445_ = array<u32, 2>(0u, 2u);
            } else {
                phi_445_ = array<u32, 2>(1u, 1u);
            }
            let _e212 = phi_445_;
            if ((_e57 % 32u) == 0u) {
                let _e218 = (_e57 / 32u);
                let _e224 = params.member.member_2.member[0u][_e212[0]];
                firsts[(2u * _e218)] = (_e224 + (_e204 * 32u));
                let _e233 = params.member.member_2.member[0u][_e212[1]];
                firsts[((2u * _e218) + 1u)] = (_e233 + (_e207 * 32u));
            }
            let _e238 = params.member.member_2.member_1;
            if (_e238 == 0u) {
                phi_505_ = array<u32, 2>(0u, 2u);
            } else {
                phi_505_ = array<u32, 2>(1u, 1u);
            }
            let _e241 = phi_505_;
            let _e244 = (_e57 / 32u);
            let _e245 = (_e57 % 32u);
            let _e247 = params.member.member_2.member_2;
            let _e251 = params.member.member_2.member[_e247][_e241[0]];
            let _e254 = nodes.member[(_e251 + _e204)];
            let _e268 = params.member.member_2.member_2;
            let _e272 = params.member.member_2.member[_e268][_e241[1]];
            let _e275 = nodes.member[(_e272 + _e207)];
            let _e289 = params.member.member_2.member_2;
            let _e296 = params.member.member_2.member[(_e289 - 1u)][_e241[0]];
            let _e299 = nodes.member[(_e296 + ((_e204 * 32u) + _e245))];
            let _e316 = params.member.member_2.member_2;
            let _e323 = params.member.member_2.member[(_e316 - 1u)][_e241[1]];
            let _e326 = nodes.member[(_e323 + ((_e207 * 32u) + _e245))];
            if _e190 {
                phi_666_ = ((((((_e299.member.x <= _e275.member_1.y) && (_e275.member.x <= _e299.member_1.y)) && (_e299.member.y <= _e275.member_2.x)) && (_e275.member.y <= _e299.member_2.x)) && (_e299.member_1.x <= _e275.member_2.y)) && (_e275.member_1.x <= _e299.member_2.y));
            } else {
                phi_666_ = false;
            }
            let _e351 = phi_666_;
            if _e190 {
                if ((((((_e326.member.x <= _e254.member_1.y) && (_e254.member.x <= _e326.member_1.y)) && (_e326.member.y <= _e254.member_2.x)) && (_e254.member.y <= _e326.member_2.x)) && (_e326.member_1.x <= _e254.member_2.y)) && (_e254.member_1.x <= _e326.member_2.y)) {
                    let _e365 = atomicAdd((&counters[_e244]), 1u);
                    let _e366 = ((_e244 * 32u) + _e365);
                    columns[_e366] = type_29(array<f32, 3>(_e326.member.x, _e326.member.y, _e326.member_1.x), array<f32, 3>(_e326.member_1.y, _e326.member_2.x, _e326.member_2.y));
                    names[_e366] = _e245;
                }
            }
            if _e351 {
                phi_704_ = type_29(array<f32, 3>(_e299.member.x, _e299.member.y, _e299.member_1.x), array<f32, 3>(_e299.member_1.y, _e299.member_2.x, _e299.member_2.y));
            } else {
                phi_704_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e373 = phi_704_;
            workgroupBarrier();
            if (_e78 == 1u) {
                phi_710_ = (_e204 == _e207);
            } else {
                phi_710_ = false;
            }
            let _e377 = phi_710_;
            let _e378 = (_e57 / 32u);
            let _e380 = (_e378 * 32u);
            let _e382 = atomicLoad((&counters[_e378]));
            let _e383 = (_e382 / 4u);
            if ((_e382 % 4u) > 0u) {
                phi_733_ = (_e383 + 1u);
            } else {
                phi_733_ = _e383;
            }
            let _e388 = phi_733_;
            phi_736_ = type_9(0u, _e388);
            phi_739_ = 0u;
            loop {
                let _e391 = phi_736_;
                let _e393 = phi_739_;
                local = _e393;
                local_3 = _e393;
                if (_e391.member < _e391.member_1) {
                    phi_737_ = type_9((_e391.member + 1u), _e391.member_1);
                    phi_762_ = type_9(1u, _e391.member);
                } else {
                    phi_737_ = _e391;
                    phi_762_ = type_9(0u, type_9().member_1);
                }
                let _e405 = phi_737_;
                let _e407 = phi_762_;
                let _e411 = (bitcast<i32>(_e407.member) != 0i);
                if _e411 {
                    let _e412 = (4u * _e407.member_1);
                    let _e415 = columns[(_e380 + _e412)];
                    let _e454 = columns[((_e380 + _e412) + 1u)];
                    let _e495 = columns[((_e380 + _e412) + 2u)];
                    let _e536 = columns[((_e380 + _e412) + 3u)];
                    phi_740_ = (_e393 | ((((select(0u, 1u, ((((((_e373.member[0] <= _e415.member_1[0]) && (_e415.member[0] <= _e373.member_1[0])) && (_e373.member[1] <= _e415.member_1[1])) && (_e415.member[1] <= _e373.member_1[1])) && (_e373.member[2] <= _e415.member_1[2])) && (_e415.member[2] <= _e373.member_1[2]))) << bitcast<u32>((_e412 & 31u))) | (select(0u, 1u, ((((((_e373.member[0] <= _e454.member_1[0]) && (_e454.member[0] <= _e373.member_1[0])) && (_e373.member[1] <= _e454.member_1[1])) && (_e454.member[1] <= _e373.member_1[1])) && (_e373.member[2] <= _e454.member_1[2])) && (_e454.member[2] <= _e373.member_1[2]))) << bitcast<u32>(((_e412 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e373.member[0] <= _e495.member_1[0]) && (_e495.member[0] <= _e373.member_1[0])) && (_e373.member[1] <= _e495.member_1[1])) && (_e495.member[1] <= _e373.member_1[1])) && (_e373.member[2] <= _e495.member_1[2])) && (_e495.member[2] <= _e373.member_1[2]))) << bitcast<u32>(((_e412 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e373.member[0] <= _e536.member_1[0]) && (_e536.member[0] <= _e373.member_1[0])) && (_e373.member[1] <= _e536.member_1[1])) && (_e536.member[1] <= _e373.member_1[1])) && (_e373.member[2] <= _e536.member_1[2])) && (_e536.member[2] <= _e373.member_1[2]))) << bitcast<u32>(((_e412 + 3u) & 31u)))));
                } else {
                    phi_740_ = u32();
                }
                let _e576 = phi_740_;
                continue;
                continuing {
                    phi_736_ = _e405;
                    phi_739_ = _e576;
                    break if !(_e411);
                }
            }
            if (_e382 < 32u) {
                let _e584 = local;
                phi_951_ = (_e584 & ((1u << bitcast<u32>((_e382 & 31u))) - 1u));
            } else {
                let _e1739 = local_3;
                phi_951_ = _e1739;
            }
            let _e587 = phi_951_;
            if _e377 {
                phi_1057_ = type_9(0u, _e382);
                phi_1060_ = _e587;
                loop {
                    let _e590 = phi_1057_;
                    let _e592 = phi_1060_;
                    local_4 = _e592;
                    if (_e590.member < _e590.member_1) {
                        phi_1058_ = type_9((_e590.member + 1u), _e590.member_1);
                        phi_1083_ = type_9(1u, _e590.member);
                    } else {
                        phi_1058_ = _e590;
                        phi_1083_ = type_9(0u, type_9().member_1);
                    }
                    let _e604 = phi_1058_;
                    let _e606 = phi_1083_;
                    let _e610 = (bitcast<i32>(_e606.member) != 0i);
                    if _e610 {
                        let _e613 = names[(_e380 + _e606.member_1)];
                        if _e377 {
                            let _e614 = ((_e57 % 32u) < _e613);
                            if _e614 {
                                phi_1107_ = bool();
                            } else {
                                phi_1107_ = false;
                            }
                            let _e616 = phi_1107_;
                            phi_1108_ = _e616;
                            phi_1109_ = _e614;
                        } else {
                            phi_1108_ = bool();
                            phi_1109_ = true;
                        }
                        let _e618 = phi_1108_;
                        let _e620 = phi_1109_;
                        if _e620 {
                            phi_1113_ = true;
                        } else {
                            phi_1113_ = _e618;
                        }
                        let _e622 = phi_1113_;
                        if _e622 {
                            phi_1121_ = false;
                        } else {
                            phi_1121_ = true;
                        }
                        let _e624 = phi_1121_;
                        if _e624 {
                            phi_1129_ = (_e592 & ~((1u << bitcast<u32>((_e606.member_1 & 31u)))));
                        } else {
                            phi_1129_ = _e592;
                        }
                        let _e631 = phi_1129_;
                        phi_1061_ = _e631;
                    } else {
                        phi_1061_ = u32();
                    }
                    let _e633 = phi_1061_;
                    continue;
                    continuing {
                        phi_1057_ = _e604;
                        phi_1060_ = _e633;
                        break if !(_e610);
                    }
                }
                let _e1753 = local_4;
                phi_1130_ = _e1753;
            } else {
                phi_1130_ = _e587;
            }
            let _e636 = phi_1130_;
            let _e638 = countOneBits(_e636);
            if (_e638 > 0u) {
                let _e641 = atomicAdd((&counters[4u]), _e638);
                phi_1140_ = type_9(_e636, _e641);
            } else {
                phi_1140_ = type_9(_e636, 0u);
            }
            let _e644 = phi_1140_;
            workgroupBarrier();
            if (_e57 == 0u) {
                let _e647 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e647;
            }
            let _e650 = workgroupUniformLoad((&n_hits[0u]));
            let _e651 = (_e650 / 512u);
            if ((_e650 % 512u) > 0u) {
                phi_1166_ = (_e651 + 1u);
            } else {
                phi_1166_ = _e651;
            }
            let _e656 = phi_1166_;
            if (_e57 == 0u) {
                let _e659 = atomicLoad((&counters[7u]));
                let _e661 = n_hits[0u];
                atomicStore((&counters[7u]), (_e659 + _e661));
            }
            phi_1179_ = type_9(0u, _e656);
            phi_1182_ = _e644;
            loop {
                let _e666 = phi_1179_;
                let _e668 = phi_1182_;
                if (_e666.member < _e666.member_1) {
                    phi_1180_ = type_9((_e666.member + 1u), _e666.member_1);
                    phi_1207_ = type_9(1u, _e666.member);
                } else {
                    phi_1180_ = _e666;
                    phi_1207_ = type_9(0u, type_9().member_1);
                }
                let _e680 = phi_1180_;
                let _e682 = phi_1207_;
                let _e686 = (bitcast<i32>(_e682.member) != 0i);
                if _e686 {
                    let _e687 = (_e57 / 32u);
                    let _e689 = (_e682.member_1 * 512u);
                    phi_1224_ = _e668;
                    phi_1227_ = type_9(0u, countOneBits(_e668.member));
                    loop {
                        let _e694 = phi_1224_;
                        let _e696 = phi_1227_;
                        local_5 = _e694;
                        if (_e696.member < _e696.member_1) {
                            phi_1228_ = type_9((_e696.member + 1u), _e696.member_1);
                            phi_1250_ = type_9(1u, _e696.member);
                        } else {
                            phi_1228_ = _e696;
                            phi_1250_ = type_9(0u, type_9().member_1);
                        }
                        let _e708 = phi_1228_;
                        let _e710 = phi_1250_;
                        if (bitcast<i32>(_e710.member) != 0i) {
                            let _e715 = (_e694.member_1 - _e689);
                            if (_e715 >= 512u) {
                                phi_1284_ = type_9();
                                phi_1285_ = false;
                            } else {
                                let _e724 = names[((_e687 * 32u) + select(firstTrailingBit(_e694.member), 32u, (_e694.member == 0u)))];
                                hits[_e715] = (((_e687 << bitcast<u32>(10i)) | ((_e57 % 32u) << bitcast<u32>(5i))) | _e724);
                                phi_1284_ = type_9((_e694.member & (_e694.member - 1u)), (_e694.member_1 + 1u));
                                phi_1285_ = true;
                            }
                            let _e740 = phi_1284_;
                            let _e742 = phi_1285_;
                            phi_1225_ = _e740;
                            phi_1286_ = _e742;
                        } else {
                            phi_1225_ = type_9();
                            phi_1286_ = false;
                        }
                        let _e744 = phi_1225_;
                        let _e746 = phi_1286_;
                        continue;
                        continuing {
                            phi_1224_ = _e744;
                            phi_1227_ = _e708;
                            break if !(_e746);
                        }
                    }
                    workgroupBarrier();
                    let _e749 = n_hits[0u];
                    let _e750 = (_e749 - _e689);
                    if (512u < _e750) {
                        phi_1294_ = 512u;
                    } else {
                        phi_1294_ = _e750;
                    }
                    let _e753 = phi_1294_;
                    phi_1297_ = type_9(0u, 4u);
                    loop {
                        let _e755 = phi_1297_;
                        if (_e755.member < _e755.member_1) {
                            phi_1298_ = type_9((_e755.member + 1u), _e755.member_1);
                            phi_1323_ = type_9(1u, _e755.member);
                        } else {
                            phi_1298_ = _e755;
                            phi_1323_ = type_9(0u, type_9().member_1);
                        }
                        let _e767 = phi_1298_;
                        let _e769 = phi_1323_;
                        if (bitcast<i32>(_e769.member) != 0i) {
                            let _e775 = (_e57 + (_e769.member_1 * 128u));
                            if (_e775 >= _e753) {
                                phi_2775_ = false;
                            } else {
                                let _e778 = hits[_e775];
                                if ((_e75.member_1 & 512u) != 0u) {
                                    let _e781 = ((_e778 >> bitcast<u32>(10i)) & 3u);
                                    let _e788 = firsts[(2u * _e781)];
                                    let _e789 = (_e788 + ((_e778 >> bitcast<u32>(5i)) & 31u));
                                    let _e793 = firsts[((2u * _e781) + 1u)];
                                    let _e794 = (_e793 + (_e778 & 31u));
                                    let _e800 = ends.member[(((_e789 / 32u) * 96u) + (_e789 % 32u))];
                                    let _e808 = ends.member[(((((_e789 / 32u) * 3u) + 1u) * 32u) + (_e789 % 32u))];
                                    let _e824 = ends.member[(((((_e789 / 32u) * 3u) + 2u) * 32u) + (_e789 % 32u))];
                                    let _e834 = ends.member[(((_e794 / 32u) * 96u) + (_e794 % 32u))];
                                    let _e842 = ends.member[(((((_e794 / 32u) * 3u) + 1u) * 32u) + (_e794 % 32u))];
                                    let _e858 = ends.member[(((((_e794 / 32u) * 3u) + 2u) * 32u) + (_e794 % 32u))];
                                    let _e869 = (((_e75.member_5 + (2f * _e75.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    phi_1519_ = !(((((((_e800.x - _e834.w) > _e869) && ((_e808.z - _e858.y) > _e869)) || (((_e834.x - _e800.w) > _e869) && ((_e842.z - _e824.y) > _e869))) || ((((_e800.y - _e842.x) > _e869) && ((_e808.w - _e858.z) > _e869)) || (((_e834.y - _e808.x) > _e869) && ((_e842.w - _e824.z) > _e869)))) || ((((_e800.z - _e842.y) > _e869) && ((_e824.x - _e858.w) > _e869)) || (((_e834.z - _e808.y) > _e869) && ((_e858.x - _e824.w) > _e869)))));
                                } else {
                                    phi_1519_ = true;
                                }
                                let _e907 = phi_1519_;
                                if _e907 {
                                    phi_1609_ = true;
                                } else {
                                    let _e910 = ((_e778 >> bitcast<u32>(10i)) & 3u);
                                    let _e917 = firsts[(2u * _e910)];
                                    let _e922 = firsts[((2u * _e910) + 1u)];
                                    if ((_e75.member_1 & 2u) != 0u) {
                                        phi_1604_ = false;
                                    } else {
                                        if ((_e75.member_1 & 32u) != 0u) {
                                            let _e931 = nodes.member[(_e917 + ((_e778 >> bitcast<u32>(5i)) & 31u))];
                                            let _e945 = nodes.member[(_e922 + (_e778 & 31u))];
                                            phi_1603_ = (((((_e931.member_1.y - _e945.member.x) > _e75.member_6) && ((_e945.member_1.y - _e931.member.x) > _e75.member_6)) && (((_e931.member_2.x - _e945.member.y) > _e75.member_6) && ((_e945.member_2.x - _e931.member.y) > _e75.member_6))) && (((_e931.member_2.y - _e945.member_1.x) > _e75.member_6) && ((_e945.member_2.y - _e931.member_1.x) > _e75.member_6)));
                                        } else {
                                            phi_1603_ = true;
                                        }
                                        let _e977 = phi_1603_;
                                        phi_1604_ = _e977;
                                    }
                                    let _e979 = phi_1604_;
                                    if _e979 {
                                        phi_1608_ = false;
                                    } else {
                                        phi_1608_ = true;
                                    }
                                    let _e981 = phi_1608_;
                                    phi_1609_ = _e981;
                                }
                                let _e983 = phi_1609_;
                                if _e983 {
                                    let _e986 = ((_e778 >> bitcast<u32>(10i)) & 3u);
                                    let _e993 = firsts[(2u * _e986)];
                                    let _e998 = firsts[((2u * _e986) + 1u)];
                                    let _e1001 = leaves.member[(_e993 + ((_e778 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1007 = leaves.member[(_e998 + (_e778 & 31u))];
                                    let _e1014 = ((_e778 >> bitcast<u32>(10i)) & 3u);
                                    let _e1021 = firsts[(2u * _e1014)];
                                    let _e1026 = firsts[((2u * _e1014) + 1u)];
                                    let _e1029 = nodes.member[(_e1021 + ((_e778 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1043 = nodes.member[(_e1026 + (_e778 & 31u))];
                                    if ((_e75.member_1 & 1u) != 0u) {
                                        if (_e78 == 0u) {
                                            if (_e1007.x == _e1001.x) {
                                                phi_1730_ = true;
                                            } else {
                                                phi_1730_ = (_e1007.x == _e1001.x);
                                            }
                                            let _e1072 = phi_1730_;
                                            if (_e1007.y == _e1001.x) {
                                                phi_1737_ = true;
                                            } else {
                                                phi_1737_ = (_e1007.y == _e1001.x);
                                            }
                                            let _e1076 = phi_1737_;
                                            if (_e1007.z == _e1001.x) {
                                                phi_1745_ = true;
                                            } else {
                                                phi_1745_ = (_e1007.z == _e1001.x);
                                            }
                                            let _e1081 = phi_1745_;
                                            phi_1760_ = ((_e1072 || _e1076) || _e1081);
                                        } else {
                                            if (_e1007.x == _e1001.x) {
                                                phi_1752_ = true;
                                            } else {
                                                phi_1752_ = (_e1007.x == _e1001.y);
                                            }
                                            let _e1063 = phi_1752_;
                                            if (_e1007.y == _e1001.x) {
                                                phi_1758_ = true;
                                            } else {
                                                phi_1758_ = (_e1007.y == _e1001.y);
                                            }
                                            let _e1067 = phi_1758_;
                                            phi_1760_ = (_e1063 || _e1067);
                                        }
                                        let _e1084 = phi_1760_;
                                        if _e1084 {
                                            phi_1764_ = false;
                                        } else {
                                            phi_1764_ = true;
                                        }
                                        let _e1086 = phi_1764_;
                                        phi_1765_ = _e1086;
                                    } else {
                                        phi_1765_ = true;
                                    }
                                    let _e1088 = phi_1765_;
                                    if _e1088 {
                                        if ((_e75.member_1 & 2u) != 0u) {
                                            let _e1093 = bodies.member[_e1001.x];
                                            let _e1095 = bodies.member[_e1007.x];
                                            if ((_e1093 / 4u) != (_e1095 / 4u)) {
                                                phi_1807_ = true;
                                            } else {
                                                if ((_e1093 & 2u) == 0u) {
                                                    phi_1806_ = false;
                                                } else {
                                                    phi_1806_ = true;
                                                }
                                                let _e1102 = phi_1806_;
                                                phi_1807_ = _e1102;
                                            }
                                            let _e1104 = phi_1807_;
                                            if _e1104 {
                                                phi_1814_ = (((_e1093 & _e1095) & 1u) == 0u);
                                            } else {
                                                phi_1814_ = false;
                                            }
                                            let _e1109 = phi_1814_;
                                            if _e1109 {
                                                if ((_e75.member_1 & 4u) != 0u) {
                                                    let _e1116 = bodies.member[_e75.member[0]];
                                                    let _e1119 = bodies.member[(_e75.member[0] + 1u)];
                                                    let _e1124 = ((_e75.member[0] + 4u) + (2u * (_e1093 >> bitcast<u32>(2i))));
                                                    let _e1129 = ((_e75.member[0] + 4u) + (2u * (_e1095 >> bitcast<u32>(2i))));
                                                    let _e1131 = bodies.member[_e1124];
                                                    let _e1133 = bodies.member[_e1129];
                                                    let _e1142 = bodies.member[((((_e75.member[0] + 4u) + (2u * _e1116)) + (_e1131 * _e1119)) + (_e1133 / 32u))];
                                                    let _e1145 = bodies.member[(_e1124 + 1u)];
                                                    let _e1148 = bodies.member[(_e1129 + 1u)];
                                                    if (_e1145 == _e1148) {
                                                        if (((_e1142 >> bitcast<u32>(((_e1133 % 32u) & 31u))) & 1u) == 1u) {
                                                            phi_1928_ = true;
                                                        } else {
                                                            phi_1928_ = ((_e1093 >> bitcast<u32>(2i)) == (_e1095 >> bitcast<u32>(2i)));
                                                        }
                                                        let _e1162 = phi_1928_;
                                                        phi_1929_ = _e1162;
                                                    } else {
                                                        phi_1929_ = false;
                                                    }
                                                    let _e1164 = phi_1929_;
                                                    if _e1164 {
                                                        let _e1167 = bodies.member[(_e75.member[0] + 2u)];
                                                        let _e1170 = bodies.member[(_e75.member[0] + 3u)];
                                                        let _e1171 = (_e1170 + _e75.member[0]);
                                                        if (_e78 == 1u) {
                                                            if (_e1007.w < _e1001.w) {
                                                                phi_1964_ = _e1001.w;
                                                                phi_1965_ = _e1007.w;
                                                            } else {
                                                                phi_1964_ = _e1007.w;
                                                                phi_1965_ = _e1001.w;
                                                            }
                                                            let _e1175 = phi_1964_;
                                                            let _e1177 = phi_1965_;
                                                            phi_1966_ = _e1175;
                                                            phi_1967_ = _e1177;
                                                        } else {
                                                            phi_1966_ = _e1007.w;
                                                            phi_1967_ = _e1001.w;
                                                        }
                                                        let _e1179 = phi_1966_;
                                                        let _e1181 = phi_1967_;
                                                        phi_1970_ = type_15(0i, 32i);
                                                        phi_1973_ = _e1167;
                                                        phi_1975_ = 0u;
                                                        loop {
                                                            let _e1183 = phi_1970_;
                                                            let _e1185 = phi_1973_;
                                                            let _e1187 = phi_1975_;
                                                            local_1 = _e1187;
                                                            local_2 = _e1187;
                                                            if (_e1183.member < _e1183.member_1) {
                                                                let _e1194 = (_e1183.member + 1i);
                                                                if ((false == (_e1194 > _e1183.member)) != false) {
                                                                    phi_1996_ = true;
                                                                } else {
                                                                    phi_1996_ = false;
                                                                }
                                                                let _e1199 = phi_1996_;
                                                                if _e1199 {
                                                                    phi_2002_ = type_16(0u, type_16().member_1);
                                                                } else {
                                                                    phi_2002_ = type_16(1u, _e1194);
                                                                }
                                                                let _e1204 = phi_2002_;
                                                                phi_1971_ = type_15(_e1204.member_1, _e1183.member_1);
                                                                phi_2016_ = type_16(1u, _e1183.member);
                                                            } else {
                                                                phi_1971_ = _e1183;
                                                                phi_2016_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1210 = phi_1971_;
                                                            let _e1212 = phi_2016_;
                                                            if (bitcast<i32>(_e1212.member) != 0i) {
                                                                if (_e1187 >= _e1185) {
                                                                    phi_2099_ = u32();
                                                                    phi_2100_ = u32();
                                                                    phi_2101_ = false;
                                                                } else {
                                                                    let _e1219 = (_e1187 + ((_e1185 - _e1187) / 2u));
                                                                    let _e1221 = (_e1171 + (3u * _e1219));
                                                                    let _e1223 = bodies.member[_e1221];
                                                                    let _e1226 = bodies.member[(_e1221 + 1u)];
                                                                    let _e1229 = bodies.member[(_e1221 + 2u)];
                                                                    if (_e1223 < _e78) {
                                                                        phi_2092_ = true;
                                                                    } else {
                                                                        if (_e1223 == _e78) {
                                                                            if (_e1226 < _e1181) {
                                                                                phi_2086_ = false;
                                                                            } else {
                                                                                if (_e1226 == _e1181) {
                                                                                    if (_e1229 < _e1179) {
                                                                                        phi_2084_ = false;
                                                                                    } else {
                                                                                        phi_2084_ = true;
                                                                                    }
                                                                                    let _e1236 = phi_2084_;
                                                                                    phi_2085_ = _e1236;
                                                                                } else {
                                                                                    phi_2085_ = true;
                                                                                }
                                                                                let _e1238 = phi_2085_;
                                                                                phi_2086_ = _e1238;
                                                                            }
                                                                            let _e1240 = phi_2086_;
                                                                            phi_2087_ = _e1240;
                                                                        } else {
                                                                            phi_2087_ = true;
                                                                        }
                                                                        let _e1242 = phi_2087_;
                                                                        if _e1242 {
                                                                            phi_2091_ = false;
                                                                        } else {
                                                                            phi_2091_ = true;
                                                                        }
                                                                        let _e1244 = phi_2091_;
                                                                        phi_2092_ = _e1244;
                                                                    }
                                                                    let _e1246 = phi_2092_;
                                                                    if _e1246 {
                                                                        phi_2097_ = _e1185;
                                                                        phi_2098_ = (_e1219 + 1u);
                                                                    } else {
                                                                        phi_2097_ = _e1219;
                                                                        phi_2098_ = _e1187;
                                                                    }
                                                                    let _e1249 = phi_2097_;
                                                                    let _e1251 = phi_2098_;
                                                                    phi_2099_ = _e1249;
                                                                    phi_2100_ = _e1251;
                                                                    phi_2101_ = true;
                                                                }
                                                                let _e1253 = phi_2099_;
                                                                let _e1255 = phi_2100_;
                                                                let _e1257 = phi_2101_;
                                                                phi_1974_ = _e1253;
                                                                phi_1976_ = _e1255;
                                                                phi_2102_ = _e1257;
                                                            } else {
                                                                phi_1974_ = u32();
                                                                phi_1976_ = u32();
                                                                phi_2102_ = false;
                                                            }
                                                            let _e1259 = phi_1974_;
                                                            let _e1261 = phi_1976_;
                                                            let _e1263 = phi_2102_;
                                                            continue;
                                                            continuing {
                                                                phi_1970_ = _e1210;
                                                                phi_1973_ = _e1259;
                                                                phi_1975_ = _e1261;
                                                                break if !(_e1263);
                                                            }
                                                        }
                                                        let _e1266 = local_1;
                                                        if (_e1266 < _e1167) {
                                                            let _e1269 = local_2;
                                                            let _e1271 = (_e1171 + (3u * _e1269));
                                                            let _e1273 = bodies.member[_e1271];
                                                            if (_e1273 == _e78) {
                                                                let _e1277 = bodies.member[(_e1271 + 1u)];
                                                                if (_e1277 == _e1181) {
                                                                    let _e1281 = bodies.member[(_e1271 + 2u)];
                                                                    phi_2150_ = (_e1281 == _e1179);
                                                                    phi_2151_ = false;
                                                                } else {
                                                                    phi_2150_ = bool();
                                                                    phi_2151_ = true;
                                                                }
                                                                let _e1284 = phi_2150_;
                                                                let _e1286 = phi_2151_;
                                                                phi_2152_ = _e1284;
                                                                phi_2153_ = _e1286;
                                                            } else {
                                                                phi_2152_ = bool();
                                                                phi_2153_ = true;
                                                            }
                                                            let _e1288 = phi_2152_;
                                                            let _e1290 = phi_2153_;
                                                            if _e1290 {
                                                                phi_2157_ = false;
                                                            } else {
                                                                phi_2157_ = _e1288;
                                                            }
                                                            let _e1292 = phi_2157_;
                                                            phi_2158_ = _e1292;
                                                        } else {
                                                            phi_2158_ = false;
                                                        }
                                                        let _e1294 = phi_2158_;
                                                        phi_2162_ = _e1294;
                                                    } else {
                                                        phi_2162_ = true;
                                                    }
                                                    let _e1296 = phi_2162_;
                                                    if _e1296 {
                                                        phi_2166_ = false;
                                                    } else {
                                                        phi_2166_ = true;
                                                    }
                                                    let _e1298 = phi_2166_;
                                                    phi_2167_ = _e1298;
                                                } else {
                                                    phi_2167_ = true;
                                                }
                                                let _e1300 = phi_2167_;
                                                if _e1300 {
                                                    phi_2171_ = false;
                                                } else {
                                                    phi_2171_ = true;
                                                }
                                                let _e1302 = phi_2171_;
                                                phi_2172_ = _e1302;
                                            } else {
                                                phi_2172_ = true;
                                            }
                                            let _e1304 = phi_2172_;
                                            if _e1304 {
                                                phi_2176_ = false;
                                            } else {
                                                phi_2176_ = true;
                                            }
                                            let _e1306 = phi_2176_;
                                            phi_2177_ = _e1306;
                                        } else {
                                            phi_2177_ = true;
                                        }
                                        let _e1308 = phi_2177_;
                                        if _e1308 {
                                            if ((_e75.member_1 & 32u) != 0u) {
                                                let _e1329 = (((((_e1029.member_1.y - _e1043.member.x) > _e75.member_6) && ((_e1043.member_1.y - _e1029.member.x) > _e75.member_6)) && (((_e1029.member_2.x - _e1043.member.y) > _e75.member_6) && ((_e1043.member_2.x - _e1029.member.y) > _e75.member_6))) && (((_e1029.member_2.y - _e1043.member_1.x) > _e75.member_6) && ((_e1043.member_2.y - _e1029.member_1.x) > _e75.member_6)));
                                                if _e1329 {
                                                    phi_2741_ = bool();
                                                } else {
                                                    let _e1331 = keys.member[_e1001.x];
                                                    let _e1334 = keys.member[_e1001.y];
                                                    let _e1336 = function_5(_e1331[0], _e1334[0]);
                                                    let _e1338 = keys.member[_e1001.z];
                                                    let _e1340 = function_5(_e1336, _e1338[0]);
                                                    let _e1342 = keys.member[_e1007.x];
                                                    let _e1345 = keys.member[_e1007.y];
                                                    let _e1347 = function_4(_e1342[3], _e1345[3]);
                                                    let _e1349 = keys.member[_e1007.z];
                                                    let _e1351 = function_4(_e1347, _e1349[3]);
                                                    if (_e1340[1] > _e1351[1]) {
                                                        phi_2294_ = true;
                                                    } else {
                                                        if (_e1340[1] == _e1351[1]) {
                                                            phi_2293_ = (_e1340[0] > _e1351[0]);
                                                        } else {
                                                            phi_2293_ = false;
                                                        }
                                                        let _e1362 = phi_2293_;
                                                        phi_2294_ = _e1362;
                                                    }
                                                    let _e1364 = phi_2294_;
                                                    let _e1367 = keys.member[_e1007.x];
                                                    let _e1370 = keys.member[_e1007.y];
                                                    let _e1372 = function_5(_e1367[0], _e1370[0]);
                                                    let _e1374 = keys.member[_e1007.z];
                                                    let _e1376 = function_5(_e1372, _e1374[0]);
                                                    let _e1378 = keys.member[_e1001.x];
                                                    let _e1381 = keys.member[_e1001.y];
                                                    let _e1383 = function_4(_e1378[3], _e1381[3]);
                                                    let _e1385 = keys.member[_e1001.z];
                                                    let _e1387 = function_4(_e1383, _e1385[3]);
                                                    if (_e1376[1] > _e1387[1]) {
                                                        phi_2382_ = true;
                                                    } else {
                                                        if (_e1376[1] == _e1387[1]) {
                                                            phi_2381_ = (_e1376[0] > _e1387[0]);
                                                        } else {
                                                            phi_2381_ = false;
                                                        }
                                                        let _e1398 = phi_2381_;
                                                        phi_2382_ = _e1398;
                                                    }
                                                    let _e1400 = phi_2382_;
                                                    let _e1404 = keys.member[_e1001.x];
                                                    let _e1407 = keys.member[_e1001.y];
                                                    let _e1409 = function_3(_e1404[1], _e1407[1]);
                                                    let _e1411 = keys.member[_e1001.z];
                                                    let _e1413 = function_3(_e1409, _e1411[1]);
                                                    let _e1415 = keys.member[_e1007.x];
                                                    let _e1418 = keys.member[_e1007.y];
                                                    let _e1420 = function_2(_e1415[4], _e1418[4]);
                                                    let _e1422 = keys.member[_e1007.z];
                                                    let _e1424 = function_2(_e1420, _e1422[4]);
                                                    if (_e1413[1] > _e1424[1]) {
                                                        phi_2471_ = true;
                                                    } else {
                                                        if (_e1413[1] == _e1424[1]) {
                                                            phi_2470_ = (_e1413[0] > _e1424[0]);
                                                        } else {
                                                            phi_2470_ = false;
                                                        }
                                                        let _e1435 = phi_2470_;
                                                        phi_2471_ = _e1435;
                                                    }
                                                    let _e1437 = phi_2471_;
                                                    let _e1440 = keys.member[_e1007.x];
                                                    let _e1443 = keys.member[_e1007.y];
                                                    let _e1445 = function_3(_e1440[1], _e1443[1]);
                                                    let _e1447 = keys.member[_e1007.z];
                                                    let _e1449 = function_3(_e1445, _e1447[1]);
                                                    let _e1451 = keys.member[_e1001.x];
                                                    let _e1454 = keys.member[_e1001.y];
                                                    let _e1456 = function_2(_e1451[4], _e1454[4]);
                                                    let _e1458 = keys.member[_e1001.z];
                                                    let _e1460 = function_2(_e1456, _e1458[4]);
                                                    if (_e1449[1] > _e1460[1]) {
                                                        phi_2559_ = true;
                                                    } else {
                                                        if (_e1449[1] == _e1460[1]) {
                                                            phi_2558_ = (_e1449[0] > _e1460[0]);
                                                        } else {
                                                            phi_2558_ = false;
                                                        }
                                                        let _e1471 = phi_2558_;
                                                        phi_2559_ = _e1471;
                                                    }
                                                    let _e1473 = phi_2559_;
                                                    let _e1478 = keys.member[_e1001.x];
                                                    let _e1481 = keys.member[_e1001.y];
                                                    let _e1483 = function_1(_e1478[2], _e1481[2]);
                                                    let _e1485 = keys.member[_e1001.z];
                                                    let _e1487 = function_1(_e1483, _e1485[2]);
                                                    let _e1489 = keys.member[_e1007.x];
                                                    let _e1492 = keys.member[_e1007.y];
                                                    let _e1494 = function_(_e1489[5], _e1492[5]);
                                                    let _e1496 = keys.member[_e1007.z];
                                                    let _e1498 = function_(_e1494, _e1496[5]);
                                                    if (_e1487[1] > _e1498[1]) {
                                                        phi_2649_ = true;
                                                    } else {
                                                        if (_e1487[1] == _e1498[1]) {
                                                            phi_2648_ = (_e1487[0] > _e1498[0]);
                                                        } else {
                                                            phi_2648_ = false;
                                                        }
                                                        let _e1509 = phi_2648_;
                                                        phi_2649_ = _e1509;
                                                    }
                                                    let _e1511 = phi_2649_;
                                                    let _e1514 = keys.member[_e1007.x];
                                                    let _e1517 = keys.member[_e1007.y];
                                                    let _e1519 = function_1(_e1514[2], _e1517[2]);
                                                    let _e1521 = keys.member[_e1007.z];
                                                    let _e1523 = function_1(_e1519, _e1521[2]);
                                                    let _e1525 = keys.member[_e1001.x];
                                                    let _e1528 = keys.member[_e1001.y];
                                                    let _e1530 = function_(_e1525[5], _e1528[5]);
                                                    let _e1532 = keys.member[_e1001.z];
                                                    let _e1534 = function_(_e1530, _e1532[5]);
                                                    if (_e1523[1] > _e1534[1]) {
                                                        phi_2737_ = true;
                                                    } else {
                                                        if (_e1523[1] == _e1534[1]) {
                                                            phi_2736_ = (_e1523[0] > _e1534[0]);
                                                        } else {
                                                            phi_2736_ = false;
                                                        }
                                                        let _e1545 = phi_2736_;
                                                        phi_2737_ = _e1545;
                                                    }
                                                    let _e1547 = phi_2737_;
                                                    phi_2741_ = (((!(_e1364) && !(_e1400)) && (!(_e1437) && !(_e1473))) && (!(_e1511) && !(_e1547)));
                                                }
                                                let _e1552 = phi_2741_;
                                                phi_2742_ = _e1552;
                                                phi_2743_ = _e1329;
                                            } else {
                                                phi_2742_ = bool();
                                                phi_2743_ = true;
                                            }
                                            let _e1554 = phi_2742_;
                                            let _e1556 = phi_2743_;
                                            if _e1556 {
                                                phi_2747_ = false;
                                            } else {
                                                phi_2747_ = true;
                                            }
                                            let _e1558 = phi_2747_;
                                            phi_2748_ = _e1554;
                                            phi_2749_ = _e1558;
                                        } else {
                                            phi_2748_ = false;
                                            phi_2749_ = true;
                                        }
                                        let _e1560 = phi_2748_;
                                        let _e1562 = phi_2749_;
                                        phi_2750_ = _e1560;
                                        phi_2751_ = _e1562;
                                    } else {
                                        phi_2750_ = false;
                                        phi_2751_ = true;
                                    }
                                    let _e1564 = phi_2750_;
                                    let _e1566 = phi_2751_;
                                    if _e1566 {
                                        phi_2755_ = _e1564;
                                    } else {
                                        phi_2755_ = true;
                                    }
                                    let _e1568 = phi_2755_;
                                    if _e1568 {
                                    } else {
                                        let _e1570 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    if _e1568 {
                                        if _e907 {
                                            let _e1572 = atomicAdd((&counters[5u]), 1u);
                                            hits[_e775] = ((2147483648u | (_e1572 << bitcast<u32>(12i))) | _e778);
                                        }
                                    }
                                }
                                phi_2775_ = true;
                            }
                            let _e1579 = phi_2775_;
                            phi_2776_ = _e1579;
                        } else {
                            phi_2776_ = false;
                        }
                        let _e1581 = phi_2776_;
                        continue;
                        continuing {
                            phi_1297_ = _e767;
                            break if !(_e1581);
                        }
                    }
                    let _e1585 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e57 == 0u) {
                        let _e1588 = atomicLoad((&counters[5u]));
                        if (_e1588 > 0u) {
                            let _e1592 = params.member.member.member_1;
                            if ((_e1592 & 1024u) != 0u) {
                                let _e1602 = atomicAdd((&output.member[0u]), _e1588);
                                let _e1603 = (_e1602 + _e1588);
                                if (_e1603 < _e1602) {
                                    phi_2809_ = 4294967295u;
                                } else {
                                    phi_2809_ = _e1603;
                                }
                                let _e1606 = phi_2809_;
                                let _e1609 = params.member.member_1.member_3;
                                if (_e1606 > _e1609) {
                                    let _e1612 = atomicMax((&output.member[2u]), _e1606);
                                }
                                phi_2832_ = _e1602;
                            } else {
                                let _e1596 = atomicAdd((&output.member[0u]), _e1588);
                                if ((_e1596 + _e1588) < _e1596) {
                                    let _e1600 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2832_ = _e1596;
                            }
                            let _e1614 = phi_2832_;
                            atomicStore((&counters[6u]), _e1614);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1618 = atomicLoad((&counters[6u]));
                    phi_2839_ = type_9(0u, 4u);
                    loop {
                        let _e1620 = phi_2839_;
                        if (_e1620.member < _e1620.member_1) {
                            phi_2840_ = type_9((_e1620.member + 1u), _e1620.member_1);
                            phi_2863_ = type_9(1u, _e1620.member);
                        } else {
                            phi_2840_ = _e1620;
                            phi_2863_ = type_9(0u, type_9().member_1);
                        }
                        let _e1632 = phi_2840_;
                        let _e1634 = phi_2863_;
                        if (bitcast<i32>(_e1634.member) != 0i) {
                            let _e1640 = (_e57 + (_e1634.member_1 * 128u));
                            if (_e1640 >= _e753) {
                                phi_2958_ = false;
                            } else {
                                let _e1643 = hits[_e1640];
                                if ((_e1643 & 2147483648u) == 0u) {
                                    phi_2887_ = 4294967295u;
                                } else {
                                    phi_2887_ = ((_e1643 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e1650 = phi_2887_;
                                if (_e1650 != 4294967295u) {
                                    let _e1654 = ((_e1643 >> bitcast<u32>(10i)) & 3u);
                                    let _e1661 = firsts[(2u * _e1654)];
                                    let _e1666 = firsts[((2u * _e1654) + 1u)];
                                    let _e1669 = leaves.member[(_e1661 + ((_e1643 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1672 = leaves.member[(_e1666 + (_e1643 & 31u))];
                                    let _e1674 = (_e1618 + _e1650);
                                    if (_e78 == 1u) {
                                        if (_e1669.w < _e1672.w) {
                                            phi_2939_ = type_9(_e1669.w, _e1672.w);
                                        } else {
                                            phi_2939_ = type_9(_e1672.w, _e1669.w);
                                        }
                                        let _e1681 = phi_2939_;
                                        phi_2944_ = _e1681;
                                    } else {
                                        phi_2944_ = type_9(_e1669.w, _e1672.w);
                                    }
                                    let _e1683 = phi_2944_;
                                    if (_e1674 < _e1585) {
                                        let _e1687 = (2u * _e1674);
                                        atomicStore((&output.member[(4u + _e1687)]), _e1683.member);
                                        atomicStore((&output.member[(_e1687 + 5u)]), _e1683.member_1);
                                    }
                                }
                                phi_2958_ = true;
                            }
                            let _e1693 = phi_2958_;
                            phi_2959_ = _e1693;
                        } else {
                            phi_2959_ = false;
                        }
                        let _e1695 = phi_2959_;
                        continue;
                        continuing {
                            phi_2839_ = _e1632;
                            break if !(_e1695);
                        }
                    }
                    workgroupBarrier();
                    let _e1865 = local_5;
                    phi_1183_ = _e1865;
                } else {
                    phi_1183_ = type_9();
                }
                let _e1698 = phi_1183_;
                continue;
                continuing {
                    phi_1179_ = _e680;
                    phi_1182_ = _e1698;
                    break if !(_e686);
                }
            }
        }
        continue;
        continuing {
            phi_306_ = _e151;
            break if !(_e157);
        }
    }
    if (_e57 == 0u) {
        let _e1703 = atomicLoad((&counters[7u]));
        if (_e1703 > 0u) {
            let _e1706 = atomicAdd((&output.member[1u]), _e1703);
            if ((_e1706 + _e1703) < _e1706) {
                let _e1710 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
