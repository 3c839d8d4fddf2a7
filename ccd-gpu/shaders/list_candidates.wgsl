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
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(6) 
var<storage, read_write> output: type_39;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_35;
@group(0) @binding(5) 
var<storage> input: type_11;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_3603_: bool;
    var phi_3604_: bool;
    var phi_3608_: array<u32, 2>;

    if (param_1[1] > param[1]) {
        phi_3604_ = true;
    } else {
        if (param_1[1] == param[1]) {
            phi_3603_ = (param_1[0] > param[0]);
        } else {
            phi_3603_ = false;
        }
        let _e14 = phi_3603_;
        phi_3604_ = _e14;
    }
    let _e16 = phi_3604_;
    if _e16 {
        phi_3608_ = param_1;
    } else {
        phi_3608_ = param;
    }
    let _e18 = phi_3608_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_3579_: bool;
    var phi_3580_: bool;
    var phi_3584_: array<u32, 2>;

    if (param_2[1] > param_3[1]) {
        phi_3580_ = true;
    } else {
        if (param_2[1] == param_3[1]) {
            phi_3579_ = (param_2[0] > param_3[0]);
        } else {
            phi_3579_ = false;
        }
        let _e14 = phi_3579_;
        phi_3580_ = _e14;
    }
    let _e16 = phi_3580_;
    if _e16 {
        phi_3584_ = param_3;
    } else {
        phi_3584_ = param_2;
    }
    let _e18 = phi_3584_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_3555_: bool;
    var phi_3556_: bool;
    var phi_3560_: array<u32, 2>;

    if (param_5[1] > param_4[1]) {
        phi_3556_ = true;
    } else {
        if (param_5[1] == param_4[1]) {
            phi_3555_ = (param_5[0] > param_4[0]);
        } else {
            phi_3555_ = false;
        }
        let _e14 = phi_3555_;
        phi_3556_ = _e14;
    }
    let _e16 = phi_3556_;
    if _e16 {
        phi_3560_ = param_5;
    } else {
        phi_3560_ = param_4;
    }
    let _e18 = phi_3560_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_3531_: bool;
    var phi_3532_: bool;
    var phi_3536_: array<u32, 2>;

    if (param_6[1] > param_7[1]) {
        phi_3532_ = true;
    } else {
        if (param_6[1] == param_7[1]) {
            phi_3531_ = (param_6[0] > param_7[0]);
        } else {
            phi_3531_ = false;
        }
        let _e14 = phi_3531_;
        phi_3532_ = _e14;
    }
    let _e16 = phi_3532_;
    if _e16 {
        phi_3536_ = param_7;
    } else {
        phi_3536_ = param_6;
    }
    let _e18 = phi_3536_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3512_: array<u32, 2>;

    if (param_9[1] > param_8[1]) {
        phi_3508_ = true;
    } else {
        if (param_9[1] == param_8[1]) {
            phi_3507_ = (param_9[0] > param_8[0]);
        } else {
            phi_3507_ = false;
        }
        let _e14 = phi_3507_;
        phi_3508_ = _e14;
    }
    let _e16 = phi_3508_;
    if _e16 {
        phi_3512_ = param_9;
    } else {
        phi_3512_ = param_8;
    }
    let _e18 = phi_3512_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_3483_: bool;
    var phi_3484_: bool;
    var phi_3488_: array<u32, 2>;

    if (param_10[1] > param_11[1]) {
        phi_3484_ = true;
    } else {
        if (param_10[1] == param_11[1]) {
            phi_3483_ = (param_10[0] > param_11[0]);
        } else {
            phi_3483_ = false;
        }
        let _e14 = phi_3483_;
        phi_3484_ = _e14;
    }
    let _e16 = phi_3484_;
    if _e16 {
        phi_3488_ = param_11;
    } else {
        phi_3488_ = param_10;
    }
    let _e18 = phi_3488_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_182_: u32;
    var phi_194_: array<u32, 2>;
    var phi_238_: u32;
    var phi_239_: u32;
    var phi_247_: u32;
    var phi_263_: u32;
    var phi_286_: u32;
    var phi_287_: u32;
    var phi_290_: type_9;
    var phi_291_: type_9;
    var phi_314_: type_9;
    var phi_361_: u32;
    var phi_362_: u32;
    var phi_370_: u32;
    var phi_384_: u32;
    var phi_474_: array<u32, 2>;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: type_29;
    var phi_683_: bool;
    var phi_692_: type_9;
    var phi_695_: u32;
    var phi_693_: type_9;
    var phi_718_: type_9;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_790_: bool;
    var phi_808_: u32;
    var phi_809_: u32;
    var phi_810_: u32;
    var phi_696_: u32;
    var phi_813_: type_9;
    var phi_816_: u32;
    var phi_814_: type_9;
    var phi_839_: type_9;
    var phi_959_: bool;
    var phi_965_: bool;
    var phi_933_: bool;
    var phi_940_: bool;
    var phi_948_: bool;
    var phi_967_: bool;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1024_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1178_: u32;
    var phi_1179_: u32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1184_: type_15;
    var phi_1187_: u32;
    var phi_1189_: u32;
    var phi_1210_: bool;
    var phi_1216_: type_16;
    var phi_1185_: type_15;
    var phi_1230_: type_16;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1313_: u32;
    var phi_1314_: u32;
    var phi_1315_: bool;
    var phi_1188_: u32;
    var phi_1190_: u32;
    var phi_1316_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1376_: bool;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1988_: bool;
    var phi_1989_: bool;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_1995_: bool;
    var phi_1999_: bool;
    var phi_2000_: bool;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2003_: bool;
    var phi_2007_: bool;
    var phi_2023_: type_9;
    var phi_2028_: type_9;
    var phi_2066_: u32;
    var phi_2067_: bool;
    var phi_817_: u32;
    var phi_2068_: bool;
    var phi_2075_: u32;
    var phi_2078_: type_9;
    var phi_2079_: type_9;
    var phi_2102_: type_9;
    var phi_2230_: bool;
    var phi_2236_: bool;
    var phi_2204_: bool;
    var phi_2211_: bool;
    var phi_2219_: bool;
    var phi_2238_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2295_: bool;
    var phi_2411_: bool;
    var phi_2412_: bool;
    var phi_2449_: u32;
    var phi_2450_: u32;
    var phi_2451_: u32;
    var phi_2452_: u32;
    var phi_2455_: type_15;
    var phi_2458_: u32;
    var phi_2460_: u32;
    var phi_2481_: bool;
    var phi_2487_: type_16;
    var phi_2456_: type_15;
    var phi_2501_: type_16;
    var phi_2569_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2576_: bool;
    var phi_2577_: bool;
    var phi_2582_: u32;
    var phi_2583_: u32;
    var phi_2584_: u32;
    var phi_2585_: u32;
    var phi_2586_: bool;
    var phi_2459_: u32;
    var phi_2461_: u32;
    var phi_2587_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2642_: bool;
    var phi_2643_: bool;
    var phi_2647_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2880_: bool;
    var phi_2881_: bool;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var phi_3069_: bool;
    var phi_3070_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3278_: bool;
    var phi_3293_: bool;
    var phi_3294_: bool;
    var phi_3345_: type_9;
    var phi_3346_: type_9;
    var phi_3369_: type_9;
    var phi_3392_: u32;
    var phi_3443_: type_9;
    var phi_3448_: type_9;
    var phi_3463_: bool;
    var phi_3464_: bool;
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
    let _e69 = params.member.member_1.member_3;
    let _e72 = params.member.member_1.member_2;
    let _e74 = input.member[0u];
    if (_e72 < _e74) {
        phi_182_ = _e72;
    } else {
        phi_182_ = _e74;
    }
    let _e77 = phi_182_;
    let _e78 = (_e51 / 32u);
    let _e79 = (_e51 % 32u);
    let _e82 = params.member.member_2.member_1;
    if (_e82 == 0u) {
        phi_194_ = array<u32, 2>(0u, 2u);
    } else {
        phi_194_ = array<u32, 2>(1u, 1u);
    }
    let _e85 = phi_194_;
    let _e90 = params.member.member_1.member_1;
    if (_e77 > _e90) {
        let _e94 = params.member.member_1.member_1;
        let _e95 = (_e77 - _e94);
        let _e98 = params.member.member_2.member_3;
        if (_e98 == 0u) {
            return;
        }
        let _e100 = (_e95 / _e98);
        if (_e98 == 0u) {
            return;
        }
        if ((_e95 % _e98) > 0u) {
            phi_238_ = (_e100 + 1u);
        } else {
            phi_238_ = _e100;
        }
        let _e106 = phi_238_;
        phi_239_ = _e106;
    } else {
        phi_239_ = 0u;
    }
    let _e108 = phi_239_;
    let _e111 = params.member.member_2.member_4;
    if (_e111 < _e108) {
        phi_247_ = _e111;
    } else {
        phi_247_ = _e108;
    }
    let _e114 = phi_247_;
    let _e115 = (_e114 / 4u);
    if ((_e114 % 4u) > 0u) {
        phi_263_ = (_e115 + 1u);
    } else {
        phi_263_ = _e115;
    }
    let _e120 = phi_263_;
    if (_e120 > _e63) {
        let _e122 = (_e120 - _e63);
        if (_e66 == 0u) {
            return;
        }
        let _e124 = (_e122 / _e66);
        if (_e66 == 0u) {
            return;
        }
        if ((_e122 % _e66) > 0u) {
            phi_286_ = (_e124 + 1u);
        } else {
            phi_286_ = _e124;
        }
        let _e130 = phi_286_;
        phi_287_ = _e130;
    } else {
        phi_287_ = 0u;
    }
    let _e132 = phi_287_;
    phi_290_ = type_9(0u, _e132);
    loop {
        let _e135 = phi_290_;
        if (_e135.member < _e135.member_1) {
            phi_291_ = type_9((_e135.member + 1u), _e135.member_1);
            phi_314_ = type_9(1u, _e135.member);
        } else {
            phi_291_ = _e135;
            phi_314_ = type_9(0u, type_9().member_1);
        }
        let _e147 = phi_291_;
        let _e149 = phi_314_;
        let _e153 = (bitcast<i32>(_e149.member) != 0i);
        if _e153 {
            let _e158 = (((_e63 + (_e149.member_1 * _e66)) * 4u) + (_e51 / 32u));
            let _e161 = params.member.member_1.member_1;
            if (_e77 > _e161) {
                let _e165 = params.member.member_1.member_1;
                let _e166 = (_e77 - _e165);
                let _e169 = params.member.member_2.member_3;
                if (_e169 == 0u) {
                    return;
                }
                let _e171 = (_e166 / _e169);
                if (_e169 == 0u) {
                    return;
                }
                if ((_e166 % _e169) > 0u) {
                    phi_361_ = (_e171 + 1u);
                } else {
                    phi_361_ = _e171;
                }
                let _e177 = phi_361_;
                phi_362_ = _e177;
            } else {
                phi_362_ = 0u;
            }
            let _e179 = phi_362_;
            let _e182 = params.member.member_2.member_4;
            if (_e182 < _e179) {
                phi_370_ = _e182;
            } else {
                phi_370_ = _e179;
            }
            let _e185 = phi_370_;
            let _e186 = (_e158 < _e185);
            let _e189 = params.member.member_1.member_1;
            let _e192 = params.member.member_2.member_3;
            if _e186 {
                phi_384_ = (_e158 * _e192);
            } else {
                phi_384_ = 0u;
            }
            let _e195 = phi_384_;
            let _e197 = (2u * (_e189 + _e195));
            let _e200 = input.member[(4u + _e197)];
            let _e203 = input.member[(_e197 + 5u)];
            if (_e51 < 8u) {
                atomicStore((&counters[_e51]), 0u);
            }
            workgroupBarrier();
            let _e211 = params.member.member_2.member[0u][_e85[0]];
            let _e212 = (_e211 + (_e200 * 32u));
            let _e218 = params.member.member_2.member[0u][_e85[1]];
            let _e219 = (_e218 + (_e203 * 32u));
            if (_e79 == 0u) {
                firsts[(2u * _e78)] = _e212;
                firsts[((2u * _e78) + 1u)] = _e219;
            }
            let _e228 = params.member.member_2.member_1;
            if (_e228 == 0u) {
                phi_474_ = array<u32, 2>(0u, 2u);
            } else {
                phi_474_ = array<u32, 2>(1u, 1u);
            }
            let _e231 = phi_474_;
            let _e234 = (_e51 / 32u);
            let _e235 = (_e51 % 32u);
            let _e237 = params.member.member_2.member_2;
            let _e241 = params.member.member_2.member[_e237][_e231[0]];
            let _e244 = nodes.member[(_e241 + _e200)];
            let _e258 = params.member.member_2.member_2;
            let _e262 = params.member.member_2.member[_e258][_e231[1]];
            let _e265 = nodes.member[(_e262 + _e203)];
            let _e279 = params.member.member_2.member_2;
            let _e286 = params.member.member_2.member[(_e279 - 1u)][_e231[0]];
            let _e289 = nodes.member[(_e286 + ((_e200 * 32u) + _e235))];
            let _e306 = params.member.member_2.member_2;
            let _e313 = params.member.member_2.member[(_e306 - 1u)][_e231[1]];
            let _e316 = nodes.member[(_e313 + ((_e203 * 32u) + _e235))];
            if _e186 {
                if ((((((_e316.member.x <= _e244.member_1.y) && (_e244.member.x <= _e316.member_1.y)) && (_e316.member.y <= _e244.member_2.x)) && (_e244.member.y <= _e316.member_2.x)) && (_e316.member_1.x <= _e244.member_2.y)) && (_e244.member_1.x <= _e316.member_2.y)) {
                    let _e342 = atomicAdd((&counters[_e234]), 1u);
                    let _e343 = ((_e234 * 32u) + _e342);
                    columns[_e343] = type_29(array<f32, 3>(_e316.member.x, _e316.member.y, _e316.member_1.x), array<f32, 3>(_e316.member_1.y, _e316.member_2.x, _e316.member_2.y));
                    names[_e343] = _e235;
                }
            }
            workgroupBarrier();
            if _e186 {
                if ((((((_e289.member.x <= _e265.member_1.y) && (_e265.member.x <= _e289.member_1.y)) && (_e289.member.y <= _e265.member_2.x)) && (_e265.member.y <= _e289.member_2.x)) && (_e289.member_1.x <= _e265.member_2.y)) && (_e265.member_1.x <= _e289.member_2.y)) {
                    phi_672_ = false;
                } else {
                    phi_672_ = true;
                }
                let _e361 = phi_672_;
                phi_673_ = _e361;
            } else {
                phi_673_ = true;
            }
            let _e363 = phi_673_;
            if _e363 {
                phi_677_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_677_ = type_29(array<f32, 3>(_e289.member.x, _e289.member.y, _e289.member_1.x), array<f32, 3>(_e289.member_1.y, _e289.member_2.x, _e289.member_2.y));
            }
            let _e365 = phi_677_;
            if (_e85[0] == _e85[1]) {
                phi_683_ = (_e200 == _e203);
            } else {
                phi_683_ = false;
            }
            let _e369 = phi_683_;
            let _e370 = (_e51 / 32u);
            let _e371 = (_e51 % 32u);
            let _e373 = atomicLoad((&counters[_e370]));
            phi_692_ = type_9(0u, _e373);
            phi_695_ = 0u;
            loop {
                let _e376 = phi_692_;
                let _e378 = phi_695_;
                local_4 = _e378;
                if (_e376.member < _e376.member_1) {
                    phi_693_ = type_9((_e376.member + 1u), _e376.member_1);
                    phi_718_ = type_9(1u, _e376.member);
                } else {
                    phi_693_ = _e376;
                    phi_718_ = type_9(0u, type_9().member_1);
                }
                let _e390 = phi_693_;
                let _e392 = phi_718_;
                let _e396 = (bitcast<i32>(_e392.member) != 0i);
                if _e396 {
                    let _e400 = names[((_e370 * 32u) + _e392.member_1)];
                    let _e404 = columns[((_e370 * 32u) + _e392.member_1)];
                    if ((((((_e365.member[0] <= _e404.member_1[0]) && (_e404.member[0] <= _e365.member_1[0])) && (_e365.member[1] <= _e404.member_1[1])) && (_e404.member[1] <= _e365.member_1[1])) && (_e365.member[2] <= _e404.member_1[2])) && (_e404.member[2] <= _e365.member_1[2])) {
                        if _e369 {
                            let _e436 = (_e371 < _e400);
                            if _e436 {
                                phi_784_ = bool();
                            } else {
                                phi_784_ = false;
                            }
                            let _e438 = phi_784_;
                            phi_785_ = _e438;
                            phi_786_ = _e436;
                        } else {
                            phi_785_ = bool();
                            phi_786_ = true;
                        }
                        let _e440 = phi_785_;
                        let _e442 = phi_786_;
                        if _e442 {
                            phi_790_ = true;
                        } else {
                            phi_790_ = _e440;
                        }
                        let _e444 = phi_790_;
                        if _e444 {
                            let _e446 = atomicAdd((&counters[4u]), 1u);
                            if (_e446 < 2048u) {
                                hits[_e446] = (((_e370 << bitcast<u32>(10i)) | (_e371 << bitcast<u32>(5i))) | _e400);
                                phi_808_ = _e378;
                            } else {
                                phi_808_ = (_e378 | (1u << bitcast<u32>((_e392.member_1 & 31u))));
                            }
                            let _e460 = phi_808_;
                            phi_809_ = _e460;
                        } else {
                            phi_809_ = _e378;
                        }
                        let _e462 = phi_809_;
                        phi_810_ = _e462;
                    } else {
                        phi_810_ = _e378;
                    }
                    let _e464 = phi_810_;
                    phi_696_ = _e464;
                } else {
                    phi_696_ = u32();
                }
                let _e466 = phi_696_;
                continue;
                continuing {
                    phi_692_ = _e390;
                    phi_695_ = _e466;
                    break if !(_e396);
                }
            }
            phi_813_ = type_9(0u, 32u);
            let _e2026 = local_4;
            phi_816_ = _e2026;
            loop {
                let _e469 = phi_813_;
                let _e471 = phi_816_;
                if (_e469.member < _e469.member_1) {
                    phi_814_ = type_9((_e469.member + 1u), _e469.member_1);
                    phi_839_ = type_9(1u, _e469.member);
                } else {
                    phi_814_ = _e469;
                    phi_839_ = type_9(0u, type_9().member_1);
                }
                let _e483 = phi_814_;
                let _e485 = phi_839_;
                if (bitcast<i32>(_e485.member) != 0i) {
                    if (_e471 == 0u) {
                        phi_2066_ = u32();
                        phi_2067_ = false;
                    } else {
                        let _e496 = names[((_e78 * 32u) + select(firstTrailingBit(_e471), 32u, (_e471 == 0u)))];
                        let _e499 = (_e212 + _e79);
                        let _e500 = (_e219 + _e496);
                        let _e502 = leaves.member[_e499];
                        let _e504 = leaves.member[_e500];
                        let _e506 = nodes.member[_e499];
                        let _e520 = nodes.member[_e500];
                        let _e535 = params.member.member.member_1;
                        if ((_e535 & 1u) != 0u) {
                            if (_e82 == 0u) {
                                if (_e504.member[0] == _e502.member[0]) {
                                    phi_933_ = true;
                                } else {
                                    phi_933_ = (_e504.member[0] == _e502.member[0]);
                                }
                                let _e563 = phi_933_;
                                if (_e504.member[1] == _e502.member[0]) {
                                    phi_940_ = true;
                                } else {
                                    phi_940_ = (_e504.member[1] == _e502.member[0]);
                                }
                                let _e568 = phi_940_;
                                if (_e504.member[2] == _e502.member[0]) {
                                    phi_948_ = true;
                                } else {
                                    phi_948_ = (_e504.member[2] == _e502.member[0]);
                                }
                                let _e574 = phi_948_;
                                phi_967_ = ((_e563 || _e568) || _e574);
                            } else {
                                if (_e504.member[0] == _e502.member[0]) {
                                    phi_959_ = true;
                                } else {
                                    phi_959_ = (_e504.member[0] == _e502.member[1]);
                                }
                                let _e550 = phi_959_;
                                if (_e504.member[1] == _e502.member[0]) {
                                    phi_965_ = true;
                                } else {
                                    phi_965_ = (_e504.member[1] == _e502.member[1]);
                                }
                                let _e554 = phi_965_;
                                phi_967_ = (_e550 || _e554);
                            }
                            let _e577 = phi_967_;
                            if _e577 {
                                phi_971_ = false;
                            } else {
                                phi_971_ = true;
                            }
                            let _e579 = phi_971_;
                            phi_972_ = _e579;
                        } else {
                            phi_972_ = true;
                        }
                        let _e581 = phi_972_;
                        if _e581 {
                            let _e583 = params.member.member.member_1;
                            if ((_e583 & 2u) != 0u) {
                                let _e589 = bodies.member[_e502.member[0]];
                                let _e593 = bodies.member[_e504.member[0]];
                                if ((_e589 / 4u) != (_e593 / 4u)) {
                                    phi_1017_ = true;
                                } else {
                                    if ((_e589 & 2u) == 0u) {
                                        phi_1016_ = false;
                                    } else {
                                        phi_1016_ = true;
                                    }
                                    let _e600 = phi_1016_;
                                    phi_1017_ = _e600;
                                }
                                let _e602 = phi_1017_;
                                if _e602 {
                                    phi_1024_ = (((_e589 & _e593) & 1u) == 0u);
                                } else {
                                    phi_1024_ = false;
                                }
                                let _e607 = phi_1024_;
                                if _e607 {
                                    let _e609 = params.member.member.member_1;
                                    if ((_e609 & 4u) != 0u) {
                                        let _e614 = params.member.member.member[0u];
                                        let _e616 = bodies.member[_e614];
                                        let _e619 = bodies.member[(_e614 + 1u)];
                                        let _e624 = ((_e614 + 4u) + (2u * (_e589 >> bitcast<u32>(2i))));
                                        let _e629 = ((_e614 + 4u) + (2u * (_e593 >> bitcast<u32>(2i))));
                                        let _e631 = bodies.member[_e624];
                                        let _e633 = bodies.member[_e629];
                                        let _e642 = bodies.member[((((_e614 + 4u) + (2u * _e616)) + (_e631 * _e619)) + (_e633 / 32u))];
                                        let _e645 = bodies.member[(_e624 + 1u)];
                                        let _e648 = bodies.member[(_e629 + 1u)];
                                        if (_e645 == _e648) {
                                            if (((_e642 >> bitcast<u32>(((_e633 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1140_ = true;
                                            } else {
                                                phi_1140_ = ((_e589 >> bitcast<u32>(2i)) == (_e593 >> bitcast<u32>(2i)));
                                            }
                                            let _e662 = phi_1140_;
                                            phi_1141_ = _e662;
                                        } else {
                                            phi_1141_ = false;
                                        }
                                        let _e664 = phi_1141_;
                                        if _e664 {
                                            let _e669 = bodies.member[(_e614 + 2u)];
                                            let _e672 = bodies.member[(_e614 + 3u)];
                                            let _e673 = (_e672 + _e614);
                                            if (_e82 == 1u) {
                                                if (_e504.member_1 < _e502.member_1) {
                                                    phi_1178_ = _e502.member_1;
                                                    phi_1179_ = _e504.member_1;
                                                } else {
                                                    phi_1178_ = _e504.member_1;
                                                    phi_1179_ = _e502.member_1;
                                                }
                                                let _e677 = phi_1178_;
                                                let _e679 = phi_1179_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e679;
                                            } else {
                                                phi_1180_ = _e504.member_1;
                                                phi_1181_ = _e502.member_1;
                                            }
                                            let _e681 = phi_1180_;
                                            let _e683 = phi_1181_;
                                            phi_1184_ = type_15(0i, 32i);
                                            phi_1187_ = _e669;
                                            phi_1189_ = 0u;
                                            loop {
                                                let _e685 = phi_1184_;
                                                let _e687 = phi_1187_;
                                                let _e689 = phi_1189_;
                                                local = _e689;
                                                local_1 = _e689;
                                                if (_e685.member < _e685.member_1) {
                                                    let _e696 = (_e685.member + 1i);
                                                    if ((false == (_e696 > _e685.member)) != false) {
                                                        phi_1210_ = true;
                                                    } else {
                                                        phi_1210_ = false;
                                                    }
                                                    let _e701 = phi_1210_;
                                                    if _e701 {
                                                        phi_1216_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1216_ = type_16(1u, _e696);
                                                    }
                                                    let _e706 = phi_1216_;
                                                    phi_1185_ = type_15(_e706.member_1, _e685.member_1);
                                                    phi_1230_ = type_16(1u, _e685.member);
                                                } else {
                                                    phi_1185_ = _e685;
                                                    phi_1230_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e712 = phi_1185_;
                                                let _e714 = phi_1230_;
                                                if (bitcast<i32>(_e714.member) != 0i) {
                                                    if (_e689 >= _e687) {
                                                        phi_1313_ = u32();
                                                        phi_1314_ = u32();
                                                        phi_1315_ = false;
                                                    } else {
                                                        let _e721 = (_e689 + ((_e687 - _e689) / 2u));
                                                        let _e723 = (_e673 + (3u * _e721));
                                                        let _e725 = bodies.member[_e723];
                                                        let _e728 = bodies.member[(_e723 + 1u)];
                                                        let _e731 = bodies.member[(_e723 + 2u)];
                                                        if (_e725 < _e82) {
                                                            phi_1306_ = true;
                                                        } else {
                                                            if (_e725 == _e82) {
                                                                if (_e728 < _e683) {
                                                                    phi_1300_ = false;
                                                                } else {
                                                                    if (_e728 == _e683) {
                                                                        if (_e731 < _e681) {
                                                                            phi_1298_ = false;
                                                                        } else {
                                                                            phi_1298_ = true;
                                                                        }
                                                                        let _e738 = phi_1298_;
                                                                        phi_1299_ = _e738;
                                                                    } else {
                                                                        phi_1299_ = true;
                                                                    }
                                                                    let _e740 = phi_1299_;
                                                                    phi_1300_ = _e740;
                                                                }
                                                                let _e742 = phi_1300_;
                                                                phi_1301_ = _e742;
                                                            } else {
                                                                phi_1301_ = true;
                                                            }
                                                            let _e744 = phi_1301_;
                                                            if _e744 {
                                                                phi_1305_ = false;
                                                            } else {
                                                                phi_1305_ = true;
                                                            }
                                                            let _e746 = phi_1305_;
                                                            phi_1306_ = _e746;
                                                        }
                                                        let _e748 = phi_1306_;
                                                        if _e748 {
                                                            phi_1311_ = _e687;
                                                            phi_1312_ = (_e721 + 1u);
                                                        } else {
                                                            phi_1311_ = _e721;
                                                            phi_1312_ = _e689;
                                                        }
                                                        let _e751 = phi_1311_;
                                                        let _e753 = phi_1312_;
                                                        phi_1313_ = _e751;
                                                        phi_1314_ = _e753;
                                                        phi_1315_ = true;
                                                    }
                                                    let _e755 = phi_1313_;
                                                    let _e757 = phi_1314_;
                                                    let _e759 = phi_1315_;
                                                    phi_1188_ = _e755;
                                                    phi_1190_ = _e757;
                                                    phi_1316_ = _e759;
                                                } else {
                                                    phi_1188_ = u32();
                                                    phi_1190_ = u32();
                                                    phi_1316_ = false;
                                                }
                                                let _e761 = phi_1188_;
                                                let _e763 = phi_1190_;
                                                let _e765 = phi_1316_;
                                                continue;
                                                continuing {
                                                    phi_1184_ = _e712;
                                                    phi_1187_ = _e761;
                                                    phi_1189_ = _e763;
                                                    break if !(_e765);
                                                }
                                            }
                                            let _e768 = local;
                                            if (_e768 < _e669) {
                                                let _e771 = local_1;
                                                let _e773 = (_e673 + (3u * _e771));
                                                let _e775 = bodies.member[_e773];
                                                if (_e775 == _e82) {
                                                    let _e779 = bodies.member[(_e773 + 1u)];
                                                    if (_e779 == _e683) {
                                                        let _e783 = bodies.member[(_e773 + 2u)];
                                                        phi_1364_ = (_e783 == _e681);
                                                        phi_1365_ = false;
                                                    } else {
                                                        phi_1364_ = bool();
                                                        phi_1365_ = true;
                                                    }
                                                    let _e786 = phi_1364_;
                                                    let _e788 = phi_1365_;
                                                    phi_1366_ = _e786;
                                                    phi_1367_ = _e788;
                                                } else {
                                                    phi_1366_ = bool();
                                                    phi_1367_ = true;
                                                }
                                                let _e790 = phi_1366_;
                                                let _e792 = phi_1367_;
                                                if _e792 {
                                                    phi_1371_ = false;
                                                } else {
                                                    phi_1371_ = _e790;
                                                }
                                                let _e794 = phi_1371_;
                                                phi_1372_ = _e794;
                                            } else {
                                                phi_1372_ = false;
                                            }
                                            let _e796 = phi_1372_;
                                            phi_1376_ = _e796;
                                        } else {
                                            phi_1376_ = true;
                                        }
                                        let _e798 = phi_1376_;
                                        if _e798 {
                                            phi_1380_ = false;
                                        } else {
                                            phi_1380_ = true;
                                        }
                                        let _e800 = phi_1380_;
                                        phi_1381_ = _e800;
                                    } else {
                                        phi_1381_ = true;
                                    }
                                    let _e802 = phi_1381_;
                                    if _e802 {
                                        phi_1385_ = false;
                                    } else {
                                        phi_1385_ = true;
                                    }
                                    let _e804 = phi_1385_;
                                    phi_1386_ = _e804;
                                } else {
                                    phi_1386_ = true;
                                }
                                let _e806 = phi_1386_;
                                if _e806 {
                                    phi_1390_ = false;
                                } else {
                                    phi_1390_ = true;
                                }
                                let _e808 = phi_1390_;
                                phi_1391_ = _e808;
                            } else {
                                phi_1391_ = true;
                            }
                            let _e810 = phi_1391_;
                            if _e810 {
                                let _e812 = params.member.member.member_1;
                                if ((_e812 & 32u) != 0u) {
                                    let _e816 = params.member.member.member_6;
                                    let _e833 = (((((_e506.member_1.y - _e520.member.x) > _e816) && ((_e520.member_1.y - _e506.member.x) > _e816)) && (((_e506.member_2.x - _e520.member.y) > _e816) && ((_e520.member_2.x - _e506.member.y) > _e816))) && (((_e506.member_2.y - _e520.member_1.x) > _e816) && ((_e520.member_2.y - _e506.member_1.x) > _e816)));
                                    if _e833 {
                                        phi_1993_ = bool();
                                    } else {
                                        let _e837 = keys.member[_e502.member[0]];
                                        let _e842 = keys.member[_e502.member[1]];
                                        let _e844 = function_5(_e837[0], _e842[0]);
                                        let _e848 = keys.member[_e502.member[2]];
                                        let _e850 = function_5(_e844, _e848[0]);
                                        let _e854 = keys.member[_e504.member[0]];
                                        let _e859 = keys.member[_e504.member[1]];
                                        let _e861 = function_4(_e854[3], _e859[3]);
                                        let _e865 = keys.member[_e504.member[2]];
                                        let _e867 = function_4(_e861, _e865[3]);
                                        if (_e850[1] > _e867[1]) {
                                            phi_1516_ = true;
                                        } else {
                                            if (_e850[1] == _e867[1]) {
                                                phi_1515_ = (_e850[0] > _e867[0]);
                                            } else {
                                                phi_1515_ = false;
                                            }
                                            let _e878 = phi_1515_;
                                            phi_1516_ = _e878;
                                        }
                                        let _e880 = phi_1516_;
                                        let _e885 = keys.member[_e504.member[0]];
                                        let _e890 = keys.member[_e504.member[1]];
                                        let _e892 = function_5(_e885[0], _e890[0]);
                                        let _e896 = keys.member[_e504.member[2]];
                                        let _e898 = function_5(_e892, _e896[0]);
                                        let _e902 = keys.member[_e502.member[0]];
                                        let _e907 = keys.member[_e502.member[1]];
                                        let _e909 = function_4(_e902[3], _e907[3]);
                                        let _e913 = keys.member[_e502.member[2]];
                                        let _e915 = function_4(_e909, _e913[3]);
                                        if (_e898[1] > _e915[1]) {
                                            phi_1610_ = true;
                                        } else {
                                            if (_e898[1] == _e915[1]) {
                                                phi_1609_ = (_e898[0] > _e915[0]);
                                            } else {
                                                phi_1609_ = false;
                                            }
                                            let _e926 = phi_1609_;
                                            phi_1610_ = _e926;
                                        }
                                        let _e928 = phi_1610_;
                                        let _e934 = keys.member[_e502.member[0]];
                                        let _e939 = keys.member[_e502.member[1]];
                                        let _e941 = function_3(_e934[1], _e939[1]);
                                        let _e945 = keys.member[_e502.member[2]];
                                        let _e947 = function_3(_e941, _e945[1]);
                                        let _e951 = keys.member[_e504.member[0]];
                                        let _e956 = keys.member[_e504.member[1]];
                                        let _e958 = function_2(_e951[4], _e956[4]);
                                        let _e962 = keys.member[_e504.member[2]];
                                        let _e964 = function_2(_e958, _e962[4]);
                                        if (_e947[1] > _e964[1]) {
                                            phi_1705_ = true;
                                        } else {
                                            if (_e947[1] == _e964[1]) {
                                                phi_1704_ = (_e947[0] > _e964[0]);
                                            } else {
                                                phi_1704_ = false;
                                            }
                                            let _e975 = phi_1704_;
                                            phi_1705_ = _e975;
                                        }
                                        let _e977 = phi_1705_;
                                        let _e982 = keys.member[_e504.member[0]];
                                        let _e987 = keys.member[_e504.member[1]];
                                        let _e989 = function_3(_e982[1], _e987[1]);
                                        let _e993 = keys.member[_e504.member[2]];
                                        let _e995 = function_3(_e989, _e993[1]);
                                        let _e999 = keys.member[_e502.member[0]];
                                        let _e1004 = keys.member[_e502.member[1]];
                                        let _e1006 = function_2(_e999[4], _e1004[4]);
                                        let _e1010 = keys.member[_e502.member[2]];
                                        let _e1012 = function_2(_e1006, _e1010[4]);
                                        if (_e995[1] > _e1012[1]) {
                                            phi_1799_ = true;
                                        } else {
                                            if (_e995[1] == _e1012[1]) {
                                                phi_1798_ = (_e995[0] > _e1012[0]);
                                            } else {
                                                phi_1798_ = false;
                                            }
                                            let _e1023 = phi_1798_;
                                            phi_1799_ = _e1023;
                                        }
                                        let _e1025 = phi_1799_;
                                        let _e1032 = keys.member[_e502.member[0]];
                                        let _e1037 = keys.member[_e502.member[1]];
                                        let _e1039 = function_1(_e1032[2], _e1037[2]);
                                        let _e1043 = keys.member[_e502.member[2]];
                                        let _e1045 = function_1(_e1039, _e1043[2]);
                                        let _e1049 = keys.member[_e504.member[0]];
                                        let _e1054 = keys.member[_e504.member[1]];
                                        let _e1056 = function_(_e1049[5], _e1054[5]);
                                        let _e1060 = keys.member[_e504.member[2]];
                                        let _e1062 = function_(_e1056, _e1060[5]);
                                        if (_e1045[1] > _e1062[1]) {
                                            phi_1895_ = true;
                                        } else {
                                            if (_e1045[1] == _e1062[1]) {
                                                phi_1894_ = (_e1045[0] > _e1062[0]);
                                            } else {
                                                phi_1894_ = false;
                                            }
                                            let _e1073 = phi_1894_;
                                            phi_1895_ = _e1073;
                                        }
                                        let _e1075 = phi_1895_;
                                        let _e1080 = keys.member[_e504.member[0]];
                                        let _e1085 = keys.member[_e504.member[1]];
                                        let _e1087 = function_1(_e1080[2], _e1085[2]);
                                        let _e1091 = keys.member[_e504.member[2]];
                                        let _e1093 = function_1(_e1087, _e1091[2]);
                                        let _e1097 = keys.member[_e502.member[0]];
                                        let _e1102 = keys.member[_e502.member[1]];
                                        let _e1104 = function_(_e1097[5], _e1102[5]);
                                        let _e1108 = keys.member[_e502.member[2]];
                                        let _e1110 = function_(_e1104, _e1108[5]);
                                        if (_e1093[1] > _e1110[1]) {
                                            phi_1989_ = true;
                                        } else {
                                            if (_e1093[1] == _e1110[1]) {
                                                phi_1988_ = (_e1093[0] > _e1110[0]);
                                            } else {
                                                phi_1988_ = false;
                                            }
                                            let _e1121 = phi_1988_;
                                            phi_1989_ = _e1121;
                                        }
                                        let _e1123 = phi_1989_;
                                        phi_1993_ = (((!(_e880) && !(_e928)) && (!(_e977) && !(_e1025))) && (!(_e1075) && !(_e1123)));
                                    }
                                    let _e1128 = phi_1993_;
                                    phi_1994_ = _e1128;
                                    phi_1995_ = _e833;
                                } else {
                                    phi_1994_ = bool();
                                    phi_1995_ = true;
                                }
                                let _e1130 = phi_1994_;
                                let _e1132 = phi_1995_;
                                if _e1132 {
                                    phi_1999_ = false;
                                } else {
                                    phi_1999_ = true;
                                }
                                let _e1134 = phi_1999_;
                                phi_2000_ = _e1130;
                                phi_2001_ = _e1134;
                            } else {
                                phi_2000_ = false;
                                phi_2001_ = true;
                            }
                            let _e1136 = phi_2000_;
                            let _e1138 = phi_2001_;
                            phi_2002_ = _e1136;
                            phi_2003_ = _e1138;
                        } else {
                            phi_2002_ = false;
                            phi_2003_ = true;
                        }
                        let _e1140 = phi_2002_;
                        let _e1142 = phi_2003_;
                        if _e1142 {
                            phi_2007_ = _e1140;
                        } else {
                            phi_2007_ = true;
                        }
                        let _e1144 = phi_2007_;
                        if _e1144 {
                            if (_e85[0] == _e85[1]) {
                                if (_e502.member_1 < _e504.member_1) {
                                    phi_2023_ = type_9(_e502.member_1, _e504.member_1);
                                } else {
                                    phi_2023_ = type_9(_e504.member_1, _e502.member_1);
                                }
                                let _e1153 = phi_2023_;
                                phi_2028_ = _e1153;
                            } else {
                                phi_2028_ = type_9(_e502.member_1, _e504.member_1);
                            }
                            let _e1155 = phi_2028_;
                            let _e1159 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1159 + 1u) < _e1159) {
                                let _e1163 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1159 < _e69) {
                                let _e1165 = (2u * _e1159);
                                atomicStore((&output.member[(4u + _e1165)]), _e1155.member);
                                atomicStore((&output.member[(_e1165 + 5u)]), _e1155.member_1);
                            }
                            let _e1171 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1171 + 1u) < _e1171) {
                                let _e1175 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2066_ = (_e471 & (_e471 - 1u));
                        phi_2067_ = true;
                    }
                    let _e1177 = phi_2066_;
                    let _e1179 = phi_2067_;
                    phi_817_ = _e1177;
                    phi_2068_ = _e1179;
                } else {
                    phi_817_ = u32();
                    phi_2068_ = false;
                }
                let _e1181 = phi_817_;
                let _e1183 = phi_2068_;
                continue;
                continuing {
                    phi_813_ = _e483;
                    phi_816_ = _e1181;
                    break if !(_e1183);
                }
            }
            workgroupBarrier();
            let _e1186 = atomicLoad((&counters[4u]));
            if (2048u < _e1186) {
                phi_2075_ = 2048u;
            } else {
                phi_2075_ = _e1186;
            }
            let _e1189 = phi_2075_;
            phi_2078_ = type_9(0u, 16u);
            loop {
                let _e1191 = phi_2078_;
                if (_e1191.member < _e1191.member_1) {
                    phi_2079_ = type_9((_e1191.member + 1u), _e1191.member_1);
                    phi_2102_ = type_9(1u, _e1191.member);
                } else {
                    phi_2079_ = _e1191;
                    phi_2102_ = type_9(0u, type_9().member_1);
                }
                let _e1203 = phi_2079_;
                let _e1205 = phi_2102_;
                if (bitcast<i32>(_e1205.member) != 0i) {
                    let _e1211 = (_e51 + (_e1205.member_1 * 128u));
                    if (_e1211 >= _e1189) {
                        phi_3293_ = false;
                    } else {
                        let _e1214 = hits[_e1211];
                        let _e1217 = ((_e1214 >> bitcast<u32>(10i)) & 3u);
                        let _e1224 = firsts[(2u * _e1217)];
                        let _e1225 = (_e1224 + ((_e1214 >> bitcast<u32>(5i)) & 31u));
                        let _e1229 = firsts[((2u * _e1217) + 1u)];
                        let _e1230 = (_e1229 + (_e1214 & 31u));
                        let _e1232 = leaves.member[_e1225];
                        let _e1234 = leaves.member[_e1230];
                        let _e1236 = nodes.member[_e1225];
                        let _e1250 = nodes.member[_e1230];
                        let _e1265 = params.member.member.member_1;
                        if ((_e1265 & 1u) != 0u) {
                            if (_e82 == 0u) {
                                if (_e1234.member[0] == _e1232.member[0]) {
                                    phi_2204_ = true;
                                } else {
                                    phi_2204_ = (_e1234.member[0] == _e1232.member[0]);
                                }
                                let _e1293 = phi_2204_;
                                if (_e1234.member[1] == _e1232.member[0]) {
                                    phi_2211_ = true;
                                } else {
                                    phi_2211_ = (_e1234.member[1] == _e1232.member[0]);
                                }
                                let _e1298 = phi_2211_;
                                if (_e1234.member[2] == _e1232.member[0]) {
                                    phi_2219_ = true;
                                } else {
                                    phi_2219_ = (_e1234.member[2] == _e1232.member[0]);
                                }
                                let _e1304 = phi_2219_;
                                phi_2238_ = ((_e1293 || _e1298) || _e1304);
                            } else {
                                if (_e1234.member[0] == _e1232.member[0]) {
                                    phi_2230_ = true;
                                } else {
                                    phi_2230_ = (_e1234.member[0] == _e1232.member[1]);
                                }
                                let _e1280 = phi_2230_;
                                if (_e1234.member[1] == _e1232.member[0]) {
                                    phi_2236_ = true;
                                } else {
                                    phi_2236_ = (_e1234.member[1] == _e1232.member[1]);
                                }
                                let _e1284 = phi_2236_;
                                phi_2238_ = (_e1280 || _e1284);
                            }
                            let _e1307 = phi_2238_;
                            if _e1307 {
                                phi_2242_ = false;
                            } else {
                                phi_2242_ = true;
                            }
                            let _e1309 = phi_2242_;
                            phi_2243_ = _e1309;
                        } else {
                            phi_2243_ = true;
                        }
                        let _e1311 = phi_2243_;
                        if _e1311 {
                            let _e1313 = params.member.member.member_1;
                            if ((_e1313 & 2u) != 0u) {
                                let _e1319 = bodies.member[_e1232.member[0]];
                                let _e1323 = bodies.member[_e1234.member[0]];
                                if ((_e1319 / 4u) != (_e1323 / 4u)) {
                                    phi_2288_ = true;
                                } else {
                                    if ((_e1319 & 2u) == 0u) {
                                        phi_2287_ = false;
                                    } else {
                                        phi_2287_ = true;
                                    }
                                    let _e1330 = phi_2287_;
                                    phi_2288_ = _e1330;
                                }
                                let _e1332 = phi_2288_;
                                if _e1332 {
                                    phi_2295_ = (((_e1319 & _e1323) & 1u) == 0u);
                                } else {
                                    phi_2295_ = false;
                                }
                                let _e1337 = phi_2295_;
                                if _e1337 {
                                    let _e1339 = params.member.member.member_1;
                                    if ((_e1339 & 4u) != 0u) {
                                        let _e1344 = params.member.member.member[0u];
                                        let _e1346 = bodies.member[_e1344];
                                        let _e1349 = bodies.member[(_e1344 + 1u)];
                                        let _e1354 = ((_e1344 + 4u) + (2u * (_e1319 >> bitcast<u32>(2i))));
                                        let _e1359 = ((_e1344 + 4u) + (2u * (_e1323 >> bitcast<u32>(2i))));
                                        let _e1361 = bodies.member[_e1354];
                                        let _e1363 = bodies.member[_e1359];
                                        let _e1372 = bodies.member[((((_e1344 + 4u) + (2u * _e1346)) + (_e1361 * _e1349)) + (_e1363 / 32u))];
                                        let _e1375 = bodies.member[(_e1354 + 1u)];
                                        let _e1378 = bodies.member[(_e1359 + 1u)];
                                        if (_e1375 == _e1378) {
                                            if (((_e1372 >> bitcast<u32>(((_e1363 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2411_ = true;
                                            } else {
                                                phi_2411_ = ((_e1319 >> bitcast<u32>(2i)) == (_e1323 >> bitcast<u32>(2i)));
                                            }
                                            let _e1392 = phi_2411_;
                                            phi_2412_ = _e1392;
                                        } else {
                                            phi_2412_ = false;
                                        }
                                        let _e1394 = phi_2412_;
                                        if _e1394 {
                                            let _e1399 = bodies.member[(_e1344 + 2u)];
                                            let _e1402 = bodies.member[(_e1344 + 3u)];
                                            let _e1403 = (_e1402 + _e1344);
                                            if (_e82 == 1u) {
                                                if (_e1234.member_1 < _e1232.member_1) {
                                                    phi_2449_ = _e1232.member_1;
                                                    phi_2450_ = _e1234.member_1;
                                                } else {
                                                    phi_2449_ = _e1234.member_1;
                                                    phi_2450_ = _e1232.member_1;
                                                }
                                                let _e1407 = phi_2449_;
                                                let _e1409 = phi_2450_;
                                                phi_2451_ = _e1407;
                                                phi_2452_ = _e1409;
                                            } else {
                                                phi_2451_ = _e1234.member_1;
                                                phi_2452_ = _e1232.member_1;
                                            }
                                            let _e1411 = phi_2451_;
                                            let _e1413 = phi_2452_;
                                            phi_2455_ = type_15(0i, 32i);
                                            phi_2458_ = _e1399;
                                            phi_2460_ = 0u;
                                            loop {
                                                let _e1415 = phi_2455_;
                                                let _e1417 = phi_2458_;
                                                let _e1419 = phi_2460_;
                                                local_2 = _e1419;
                                                local_3 = _e1419;
                                                if (_e1415.member < _e1415.member_1) {
                                                    let _e1426 = (_e1415.member + 1i);
                                                    if ((false == (_e1426 > _e1415.member)) != false) {
                                                        phi_2481_ = true;
                                                    } else {
                                                        phi_2481_ = false;
                                                    }
                                                    let _e1431 = phi_2481_;
                                                    if _e1431 {
                                                        phi_2487_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2487_ = type_16(1u, _e1426);
                                                    }
                                                    let _e1436 = phi_2487_;
                                                    phi_2456_ = type_15(_e1436.member_1, _e1415.member_1);
                                                    phi_2501_ = type_16(1u, _e1415.member);
                                                } else {
                                                    phi_2456_ = _e1415;
                                                    phi_2501_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1442 = phi_2456_;
                                                let _e1444 = phi_2501_;
                                                if (bitcast<i32>(_e1444.member) != 0i) {
                                                    if (_e1419 >= _e1417) {
                                                        phi_2584_ = u32();
                                                        phi_2585_ = u32();
                                                        phi_2586_ = false;
                                                    } else {
                                                        let _e1451 = (_e1419 + ((_e1417 - _e1419) / 2u));
                                                        let _e1453 = (_e1403 + (3u * _e1451));
                                                        let _e1455 = bodies.member[_e1453];
                                                        let _e1458 = bodies.member[(_e1453 + 1u)];
                                                        let _e1461 = bodies.member[(_e1453 + 2u)];
                                                        if (_e1455 < _e82) {
                                                            phi_2577_ = true;
                                                        } else {
                                                            if (_e1455 == _e82) {
                                                                if (_e1458 < _e1413) {
                                                                    phi_2571_ = false;
                                                                } else {
                                                                    if (_e1458 == _e1413) {
                                                                        if (_e1461 < _e1411) {
                                                                            phi_2569_ = false;
                                                                        } else {
                                                                            phi_2569_ = true;
                                                                        }
                                                                        let _e1468 = phi_2569_;
                                                                        phi_2570_ = _e1468;
                                                                    } else {
                                                                        phi_2570_ = true;
                                                                    }
                                                                    let _e1470 = phi_2570_;
                                                                    phi_2571_ = _e1470;
                                                                }
                                                                let _e1472 = phi_2571_;
                                                                phi_2572_ = _e1472;
                                                            } else {
                                                                phi_2572_ = true;
                                                            }
                                                            let _e1474 = phi_2572_;
                                                            if _e1474 {
                                                                phi_2576_ = false;
                                                            } else {
                                                                phi_2576_ = true;
                                                            }
                                                            let _e1476 = phi_2576_;
                                                            phi_2577_ = _e1476;
                                                        }
                                                        let _e1478 = phi_2577_;
                                                        if _e1478 {
                                                            phi_2582_ = _e1417;
                                                            phi_2583_ = (_e1451 + 1u);
                                                        } else {
                                                            phi_2582_ = _e1451;
                                                            phi_2583_ = _e1419;
                                                        }
                                                        let _e1481 = phi_2582_;
                                                        let _e1483 = phi_2583_;
                                                        phi_2584_ = _e1481;
                                                        phi_2585_ = _e1483;
                                                        phi_2586_ = true;
                                                    }
                                                    let _e1485 = phi_2584_;
                                                    let _e1487 = phi_2585_;
                                                    let _e1489 = phi_2586_;
                                                    phi_2459_ = _e1485;
                                                    phi_2461_ = _e1487;
                                                    phi_2587_ = _e1489;
                                                } else {
                                                    phi_2459_ = u32();
                                                    phi_2461_ = u32();
                                                    phi_2587_ = false;
                                                }
                                                let _e1491 = phi_2459_;
                                                let _e1493 = phi_2461_;
                                                let _e1495 = phi_2587_;
                                                continue;
                                                continuing {
                                                    phi_2455_ = _e1442;
                                                    phi_2458_ = _e1491;
                                                    phi_2460_ = _e1493;
                                                    break if !(_e1495);
                                                }
                                            }
                                            let _e1498 = local_2;
                                            if (_e1498 < _e1399) {
                                                let _e1501 = local_3;
                                                let _e1503 = (_e1403 + (3u * _e1501));
                                                let _e1505 = bodies.member[_e1503];
                                                if (_e1505 == _e82) {
                                                    let _e1509 = bodies.member[(_e1503 + 1u)];
                                                    if (_e1509 == _e1413) {
                                                        let _e1513 = bodies.member[(_e1503 + 2u)];
                                                        phi_2635_ = (_e1513 == _e1411);
                                                        phi_2636_ = false;
                                                    } else {
                                                        phi_2635_ = bool();
                                                        phi_2636_ = true;
                                                    }
                                                    let _e1516 = phi_2635_;
                                                    let _e1518 = phi_2636_;
                                                    phi_2637_ = _e1516;
                                                    phi_2638_ = _e1518;
                                                } else {
                                                    phi_2637_ = bool();
                                                    phi_2638_ = true;
                                                }
                                                let _e1520 = phi_2637_;
                                                let _e1522 = phi_2638_;
                                                if _e1522 {
                                                    phi_2642_ = false;
                                                } else {
                                                    phi_2642_ = _e1520;
                                                }
                                                let _e1524 = phi_2642_;
                                                phi_2643_ = _e1524;
                                            } else {
                                                phi_2643_ = false;
                                            }
                                            let _e1526 = phi_2643_;
                                            phi_2647_ = _e1526;
                                        } else {
                                            phi_2647_ = true;
                                        }
                                        let _e1528 = phi_2647_;
                                        if _e1528 {
                                            phi_2651_ = false;
                                        } else {
                                            phi_2651_ = true;
                                        }
                                        let _e1530 = phi_2651_;
                                        phi_2652_ = _e1530;
                                    } else {
                                        phi_2652_ = true;
                                    }
                                    let _e1532 = phi_2652_;
                                    if _e1532 {
                                        phi_2656_ = false;
                                    } else {
                                        phi_2656_ = true;
                                    }
                                    let _e1534 = phi_2656_;
                                    phi_2657_ = _e1534;
                                } else {
                                    phi_2657_ = true;
                                }
                                let _e1536 = phi_2657_;
                                if _e1536 {
                                    phi_2661_ = false;
                                } else {
                                    phi_2661_ = true;
                                }
                                let _e1538 = phi_2661_;
                                phi_2662_ = _e1538;
                            } else {
                                phi_2662_ = true;
                            }
                            let _e1540 = phi_2662_;
                            if _e1540 {
                                let _e1542 = params.member.member.member_1;
                                if ((_e1542 & 32u) != 0u) {
                                    let _e1546 = params.member.member.member_6;
                                    let _e1563 = (((((_e1236.member_1.y - _e1250.member.x) > _e1546) && ((_e1250.member_1.y - _e1236.member.x) > _e1546)) && (((_e1236.member_2.x - _e1250.member.y) > _e1546) && ((_e1250.member_2.x - _e1236.member.y) > _e1546))) && (((_e1236.member_2.y - _e1250.member_1.x) > _e1546) && ((_e1250.member_2.y - _e1236.member_1.x) > _e1546)));
                                    if _e1563 {
                                        phi_3264_ = bool();
                                    } else {
                                        let _e1567 = keys.member[_e1232.member[0]];
                                        let _e1572 = keys.member[_e1232.member[1]];
                                        let _e1574 = function_5(_e1567[0], _e1572[0]);
                                        let _e1578 = keys.member[_e1232.member[2]];
                                        let _e1580 = function_5(_e1574, _e1578[0]);
                                        let _e1584 = keys.member[_e1234.member[0]];
                                        let _e1589 = keys.member[_e1234.member[1]];
                                        let _e1591 = function_4(_e1584[3], _e1589[3]);
                                        let _e1595 = keys.member[_e1234.member[2]];
                                        let _e1597 = function_4(_e1591, _e1595[3]);
                                        if (_e1580[1] > _e1597[1]) {
                                            phi_2787_ = true;
                                        } else {
                                            if (_e1580[1] == _e1597[1]) {
                                                phi_2786_ = (_e1580[0] > _e1597[0]);
                                            } else {
                                                phi_2786_ = false;
                                            }
                                            let _e1608 = phi_2786_;
                                            phi_2787_ = _e1608;
                                        }
                                        let _e1610 = phi_2787_;
                                        let _e1615 = keys.member[_e1234.member[0]];
                                        let _e1620 = keys.member[_e1234.member[1]];
                                        let _e1622 = function_5(_e1615[0], _e1620[0]);
                                        let _e1626 = keys.member[_e1234.member[2]];
                                        let _e1628 = function_5(_e1622, _e1626[0]);
                                        let _e1632 = keys.member[_e1232.member[0]];
                                        let _e1637 = keys.member[_e1232.member[1]];
                                        let _e1639 = function_4(_e1632[3], _e1637[3]);
                                        let _e1643 = keys.member[_e1232.member[2]];
                                        let _e1645 = function_4(_e1639, _e1643[3]);
                                        if (_e1628[1] > _e1645[1]) {
                                            phi_2881_ = true;
                                        } else {
                                            if (_e1628[1] == _e1645[1]) {
                                                phi_2880_ = (_e1628[0] > _e1645[0]);
                                            } else {
                                                phi_2880_ = false;
                                            }
                                            let _e1656 = phi_2880_;
                                            phi_2881_ = _e1656;
                                        }
                                        let _e1658 = phi_2881_;
                                        let _e1664 = keys.member[_e1232.member[0]];
                                        let _e1669 = keys.member[_e1232.member[1]];
                                        let _e1671 = function_3(_e1664[1], _e1669[1]);
                                        let _e1675 = keys.member[_e1232.member[2]];
                                        let _e1677 = function_3(_e1671, _e1675[1]);
                                        let _e1681 = keys.member[_e1234.member[0]];
                                        let _e1686 = keys.member[_e1234.member[1]];
                                        let _e1688 = function_2(_e1681[4], _e1686[4]);
                                        let _e1692 = keys.member[_e1234.member[2]];
                                        let _e1694 = function_2(_e1688, _e1692[4]);
                                        if (_e1677[1] > _e1694[1]) {
                                            phi_2976_ = true;
                                        } else {
                                            if (_e1677[1] == _e1694[1]) {
                                                phi_2975_ = (_e1677[0] > _e1694[0]);
                                            } else {
                                                phi_2975_ = false;
                                            }
                                            let _e1705 = phi_2975_;
                                            phi_2976_ = _e1705;
                                        }
                                        let _e1707 = phi_2976_;
                                        let _e1712 = keys.member[_e1234.member[0]];
                                        let _e1717 = keys.member[_e1234.member[1]];
                                        let _e1719 = function_3(_e1712[1], _e1717[1]);
                                        let _e1723 = keys.member[_e1234.member[2]];
                                        let _e1725 = function_3(_e1719, _e1723[1]);
                                        let _e1729 = keys.member[_e1232.member[0]];
                                        let _e1734 = keys.member[_e1232.member[1]];
                                        let _e1736 = function_2(_e1729[4], _e1734[4]);
                                        let _e1740 = keys.member[_e1232.member[2]];
                                        let _e1742 = function_2(_e1736, _e1740[4]);
                                        if (_e1725[1] > _e1742[1]) {
                                            phi_3070_ = true;
                                        } else {
                                            if (_e1725[1] == _e1742[1]) {
                                                phi_3069_ = (_e1725[0] > _e1742[0]);
                                            } else {
                                                phi_3069_ = false;
                                            }
                                            let _e1753 = phi_3069_;
                                            phi_3070_ = _e1753;
                                        }
                                        let _e1755 = phi_3070_;
                                        let _e1762 = keys.member[_e1232.member[0]];
                                        let _e1767 = keys.member[_e1232.member[1]];
                                        let _e1769 = function_1(_e1762[2], _e1767[2]);
                                        let _e1773 = keys.member[_e1232.member[2]];
                                        let _e1775 = function_1(_e1769, _e1773[2]);
                                        let _e1779 = keys.member[_e1234.member[0]];
                                        let _e1784 = keys.member[_e1234.member[1]];
                                        let _e1786 = function_(_e1779[5], _e1784[5]);
                                        let _e1790 = keys.member[_e1234.member[2]];
                                        let _e1792 = function_(_e1786, _e1790[5]);
                                        if (_e1775[1] > _e1792[1]) {
                                            phi_3166_ = true;
                                        } else {
                                            if (_e1775[1] == _e1792[1]) {
                                                phi_3165_ = (_e1775[0] > _e1792[0]);
                                            } else {
                                                phi_3165_ = false;
                                            }
                                            let _e1803 = phi_3165_;
                                            phi_3166_ = _e1803;
                                        }
                                        let _e1805 = phi_3166_;
                                        let _e1810 = keys.member[_e1234.member[0]];
                                        let _e1815 = keys.member[_e1234.member[1]];
                                        let _e1817 = function_1(_e1810[2], _e1815[2]);
                                        let _e1821 = keys.member[_e1234.member[2]];
                                        let _e1823 = function_1(_e1817, _e1821[2]);
                                        let _e1827 = keys.member[_e1232.member[0]];
                                        let _e1832 = keys.member[_e1232.member[1]];
                                        let _e1834 = function_(_e1827[5], _e1832[5]);
                                        let _e1838 = keys.member[_e1232.member[2]];
                                        let _e1840 = function_(_e1834, _e1838[5]);
                                        if (_e1823[1] > _e1840[1]) {
                                            phi_3260_ = true;
                                        } else {
                                            if (_e1823[1] == _e1840[1]) {
                                                phi_3259_ = (_e1823[0] > _e1840[0]);
                                            } else {
                                                phi_3259_ = false;
                                            }
                                            let _e1851 = phi_3259_;
                                            phi_3260_ = _e1851;
                                        }
                                        let _e1853 = phi_3260_;
                                        phi_3264_ = (((!(_e1610) && !(_e1658)) && (!(_e1707) && !(_e1755))) && (!(_e1805) && !(_e1853)));
                                    }
                                    let _e1858 = phi_3264_;
                                    phi_3265_ = _e1858;
                                    phi_3266_ = _e1563;
                                } else {
                                    phi_3265_ = bool();
                                    phi_3266_ = true;
                                }
                                let _e1860 = phi_3265_;
                                let _e1862 = phi_3266_;
                                if _e1862 {
                                    phi_3270_ = false;
                                } else {
                                    phi_3270_ = true;
                                }
                                let _e1864 = phi_3270_;
                                phi_3271_ = _e1860;
                                phi_3272_ = _e1864;
                            } else {
                                phi_3271_ = false;
                                phi_3272_ = true;
                            }
                            let _e1866 = phi_3271_;
                            let _e1868 = phi_3272_;
                            phi_3273_ = _e1866;
                            phi_3274_ = _e1868;
                        } else {
                            phi_3273_ = false;
                            phi_3274_ = true;
                        }
                        let _e1870 = phi_3273_;
                        let _e1872 = phi_3274_;
                        if _e1872 {
                            phi_3278_ = _e1870;
                        } else {
                            phi_3278_ = true;
                        }
                        let _e1874 = phi_3278_;
                        if _e1874 {
                            let _e1876 = atomicAdd((&counters[7u]), 1u);
                            let _e1878 = atomicAdd((&counters[5u]), 1u);
                            hits[_e1211] = ((2147483648u | (_e1878 << bitcast<u32>(12i))) | _e1214);
                        }
                        phi_3293_ = true;
                    }
                    let _e1885 = phi_3293_;
                    phi_3294_ = _e1885;
                } else {
                    phi_3294_ = false;
                }
                let _e1887 = phi_3294_;
                continue;
                continuing {
                    phi_2078_ = _e1203;
                    break if !(_e1887);
                }
            }
            workgroupBarrier();
            if (_e51 == 0u) {
                let _e1891 = atomicLoad((&counters[5u]));
                if (_e1891 > 0u) {
                    let _e1894 = atomicAdd((&output.member[0u]), _e1891);
                    if ((_e1894 + _e1891) < _e1894) {
                        let _e1898 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e1894);
                }
            }
            workgroupBarrier();
            let _e1901 = atomicLoad((&counters[6u]));
            if (_e51 == 0u) {
                let _e1904 = atomicLoad((&counters[7u]));
                if (_e1904 > 0u) {
                    let _e1907 = atomicAdd((&output.member[1u]), _e1904);
                    if ((_e1907 + _e1904) < _e1907) {
                        let _e1911 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_3345_ = type_9(0u, 16u);
            loop {
                let _e1913 = phi_3345_;
                if (_e1913.member < _e1913.member_1) {
                    phi_3346_ = type_9((_e1913.member + 1u), _e1913.member_1);
                    phi_3369_ = type_9(1u, _e1913.member);
                } else {
                    phi_3346_ = _e1913;
                    phi_3369_ = type_9(0u, type_9().member_1);
                }
                let _e1925 = phi_3346_;
                let _e1927 = phi_3369_;
                if (bitcast<i32>(_e1927.member) != 0i) {
                    let _e1933 = (_e51 + (_e1927.member_1 * 128u));
                    if (_e1933 >= _e1189) {
                        phi_3463_ = false;
                    } else {
                        let _e1936 = hits[_e1933];
                        if ((_e1936 & 2147483648u) == 0u) {
                            phi_3392_ = 4294967295u;
                        } else {
                            phi_3392_ = ((_e1936 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e1943 = phi_3392_;
                        if (_e1943 != 4294967295u) {
                            let _e1947 = ((_e1936 >> bitcast<u32>(10i)) & 3u);
                            let _e1954 = firsts[(2u * _e1947)];
                            let _e1959 = firsts[((2u * _e1947) + 1u)];
                            let _e1962 = leaves.member[(_e1954 + ((_e1936 >> bitcast<u32>(5i)) & 31u))];
                            let _e1964 = leaves.member[(_e1959 + (_e1936 & 31u))];
                            if (_e85[0] == _e85[1]) {
                                if (_e1962.member_1 < _e1964.member_1) {
                                    phi_3443_ = type_9(_e1962.member_1, _e1964.member_1);
                                } else {
                                    phi_3443_ = type_9(_e1964.member_1, _e1962.member_1);
                                }
                                let _e1973 = phi_3443_;
                                phi_3448_ = _e1973;
                            } else {
                                phi_3448_ = type_9(_e1962.member_1, _e1964.member_1);
                            }
                            let _e1975 = phi_3448_;
                            let _e1978 = (_e1901 + _e1943);
                            if (_e1978 < _e69) {
                                let _e1980 = (2u * _e1978);
                                atomicStore((&output.member[(4u + _e1980)]), _e1975.member);
                                atomicStore((&output.member[(_e1980 + 5u)]), _e1975.member_1);
                            }
                        }
                        phi_3463_ = true;
                    }
                    let _e1986 = phi_3463_;
                    phi_3464_ = _e1986;
                } else {
                    phi_3464_ = false;
                }
                let _e1988 = phi_3464_;
                continue;
                continuing {
                    phi_3345_ = _e1925;
                    break if !(_e1988);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_290_ = _e147;
            break if !(_e153);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
