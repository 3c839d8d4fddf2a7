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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(6) 
var<storage, read_write> output: type_31;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(3) 
var<storage> oriented: type_27;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(5) 
var<storage, read_write> levels: type_31;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_31;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_23;
    var local_1: array<array<u32, 2>, 4>;
    var phi_143_: array<u32, 2>;
    var phi_185_: u32;
    var phi_203_: u32;
    var phi_223_: u32;
    var phi_226_: type_12;
    var phi_227_: type_12;
    var phi_250_: type_12;
    var phi_360_: array<u32, 2>;
    var phi_396_: array<u32, 2>;
    var phi_406_: array<u32, 2>;
    var phi_408_: array<array<u32, 2>, 4>;
    var phi_409_: array<array<u32, 2>, 4>;
    var phi_410_: bool;
    var phi_411_: array<array<u32, 2>, 4>;
    var phi_412_: bool;
    var phi_424_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_445_: bool;
    var phi_450_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_498_: bool;
    var phi_500_: bool;
    var phi_509_: bool;
    var phi_514_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_562_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_681_: array<u32, 2>;
    var phi_711_: array<u32, 2>;
    var phi_741_: array<u32, 2>;
    var phi_771_: array<u32, 2>;
    var phi_773_: array<array<u32, 2>, 4>;
    var phi_774_: bool;
    var phi_775_: array<array<u32, 2>, 4>;
    var phi_776_: bool;
    var phi_935_: array<u32, 2>;
    var phi_967_: array<u32, 2>;
    var phi_842_: array<u32, 2>;
    var phi_874_: array<u32, 2>;
    var phi_969_: array<array<u32, 2>, 4>;
    var phi_970_: array<array<u32, 2>, 4>;
    var phi_971_: array<array<u32, 2>, 4>;
    var phi_972_: bool;
    var phi_973_: array<array<u32, 2>, 4>;
    var phi_974_: bool;
    var phi_978_: array<array<u32, 2>, 4>;
    var phi_979_: array<array<u32, 2>, 4>;
    var phi_980_: bool;
    var phi_984_: array<array<u32, 2>, 4>;
    var phi_1005_: type_12;
    var phi_1006_: type_12;
    var phi_1029_: type_12;
    var phi_1058_: bool;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1144_: f32;
    var phi_1150_: f32;
    var phi_1156_: f32;
    var phi_1162_: f32;
    var phi_1168_: f32;
    var phi_1174_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1202_: f32;
    var phi_1218_: type_28;
    var phi_1288_: f32;
    var phi_1294_: f32;
    var phi_1300_: f32;
    var phi_1306_: f32;
    var phi_1312_: f32;
    var phi_1318_: f32;
    var phi_1336_: f32;
    var phi_1341_: f32;
    var phi_1346_: f32;
    var phi_1362_: type_28;
    var phi_1552_: f32;
    var phi_1558_: f32;
    var phi_1565_: f32;
    var phi_1574_: f32;
    var phi_1581_: f32;
    var phi_1589_: f32;
    var phi_1598_: f32;
    var phi_1605_: f32;
    var phi_1613_: f32;
    var phi_1706_: f32;
    var phi_1713_: f32;
    var phi_1719_: f32;
    var phi_1725_: f32;
    var phi_1744_: f32;
    var phi_1751_: f32;
    var phi_1757_: f32;
    var phi_1763_: f32;
    var phi_1782_: f32;
    var phi_1789_: f32;
    var phi_1795_: f32;
    var phi_1801_: f32;
    var phi_1820_: f32;
    var phi_1827_: f32;
    var phi_1833_: f32;
    var phi_1839_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1871_: f32;
    var phi_1877_: f32;
    var phi_1896_: f32;
    var phi_1903_: f32;
    var phi_1909_: f32;
    var phi_1915_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1945_: f32;
    var phi_1950_: f32;
    var phi_2009_: f32;
    var phi_2032_: f32;
    var phi_2055_: f32;
    var phi_2077_: f32;
    var phi_2093_: f32;
    var phi_2148_: f32;
    var phi_2171_: f32;
    var phi_2194_: f32;
    var phi_2216_: f32;
    var phi_2232_: f32;
    var phi_2287_: f32;
    var phi_2310_: f32;
    var phi_2333_: f32;
    var phi_2355_: f32;
    var phi_2371_: f32;
    var phi_2426_: f32;
    var phi_2449_: f32;
    var phi_2473_: f32;
    var phi_2496_: f32;
    var phi_2512_: f32;
    var phi_2567_: f32;
    var phi_2590_: f32;
    var phi_2614_: f32;
    var phi_2637_: f32;
    var phi_2653_: f32;
    var phi_2708_: f32;
    var phi_2731_: f32;
    var phi_2755_: f32;
    var phi_2778_: f32;
    var phi_2794_: f32;
    var phi_2849_: f32;
    var phi_2872_: f32;
    var phi_2896_: f32;
    var phi_2919_: f32;
    var phi_2935_: f32;
    var phi_2990_: f32;
    var phi_3013_: f32;
    var phi_3037_: f32;
    var phi_3060_: f32;
    var phi_3076_: f32;
    var phi_3131_: f32;
    var phi_3154_: f32;
    var phi_3178_: f32;
    var phi_3201_: f32;
    var phi_3217_: f32;
    var phi_3224_: f32;
    var phi_3229_: f32;
    var phi_3234_: f32;
    var phi_3239_: f32;
    var phi_3244_: f32;
    var phi_3249_: f32;
    var phi_3254_: f32;
    var phi_3259_: f32;
    var phi_3263_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3272_: bool;
    var phi_3316_: bool;
    var phi_3317_: bool;
    var phi_3321_: u32;
    var phi_3322_: u32;
    var phi_3328_: array<u32, 2>;
    var phi_3329_: array<u32, 2>;
    var phi_3330_: array<u32, 2>;
    var phi_3331_: array<u32, 2>;
    var phi_3332_: array<u32, 2>;
    var phi_3348_: bool;
    var phi_3349_: bool;
    var phi_3353_: u32;
    var phi_3354_: u32;
    var phi_3363_: u32;
    var phi_3366_: u32;
    var phi_3382_: bool;
    var phi_3383_: bool;
    var phi_3387_: u32;
    var phi_3388_: u32;
    var phi_3397_: u32;
    var phi_3400_: u32;
    var phi_3416_: bool;
    var phi_3417_: bool;
    var phi_3421_: u32;
    var phi_3422_: u32;
    var phi_3431_: u32;
    var phi_3434_: u32;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3455_: u32;
    var phi_3456_: u32;
    var phi_3465_: u32;
    var phi_3468_: u32;
    var phi_3534_: bool;
    var phi_3535_: bool;
    var phi_3539_: u32;
    var phi_3540_: u32;
    var phi_3603_: type_12;
    var phi_3608_: type_12;
    var phi_3641_: bool;
    var phi_3642_: bool;
    var phi_3646_: u32;
    var phi_3647_: u32;
    var phi_3710_: type_12;
    var phi_3715_: type_12;
    var phi_3748_: bool;
    var phi_3749_: bool;
    var phi_3753_: u32;
    var phi_3754_: u32;
    var phi_3817_: type_12;
    var phi_3822_: type_12;
    var phi_3855_: bool;
    var phi_3856_: bool;
    var phi_3860_: u32;
    var phi_3861_: u32;
    var phi_3924_: type_12;
    var phi_3929_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e62 = (_e45.x * _e45.y);
    let _e65 = params.member.member_2.member;
    let _e68 = params.member.member_1.member_1;
    if (_e65 == 0u) {
        phi_143_ = array<u32, 2>(0u, 2u);
    } else {
        phi_143_ = array<u32, 2>(1u, 1u);
    }
    let _e71 = phi_143_;
    let _e77 = params.member.member.member[_e71[0]];
    let _e78 = (_e77 - 1u);
    let _e82 = params.member.member.member[_e71[1]];
    let _e83 = (_e82 - 1u);
    let _e87 = params.member.member.member_2[_e71[0]];
    let _e91 = params.member.member.member_2[_e71[1]];
    let _e94 = params.member.member_2.member_1;
    if (_e94 == 0u) {
        phi_185_ = 1u;
    } else {
        phi_185_ = 0u;
    }
    let _e97 = phi_185_;
    let _e99 = atomicLoad((&levels.member[_e68]));
    let _e102 = params.member.member_1.member_2;
    if (_e102 < _e99) {
        phi_203_ = _e102;
    } else {
        phi_203_ = _e99;
    }
    let _e105 = phi_203_;
    let _e108 = params.member.member_1.member_2;
    let _e109 = (_e62 * 128u);
    if (_e109 == 0u) {
        return;
    }
    let _e111 = (_e108 / _e109);
    if (_e109 == 0u) {
        return;
    }
    if ((_e108 % _e109) > 0u) {
        phi_223_ = (_e111 + 1u);
    } else {
        phi_223_ = _e111;
    }
    let _e117 = phi_223_;
    phi_226_ = type_12(0u, _e117);
    loop {
        let _e120 = phi_226_;
        if (_e120.member < _e120.member_1) {
            phi_227_ = type_12((_e120.member + 1u), _e120.member_1);
            phi_250_ = type_12(1u, _e120.member);
        } else {
            phi_227_ = _e120;
            phi_250_ = type_12(0u, type_12().member_1);
        }
        let _e132 = phi_227_;
        let _e134 = phi_250_;
        let _e138 = (bitcast<i32>(_e134.member) != 0i);
        if _e138 {
            let _e142 = (((((_e44.y * _e45.x) + _e44.x) + (_e134.member_1 * _e62)) * 128u) + _e46);
            if (_e46 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e142 < _e105) {
                let _e147 = (2u * _e142);
                let _e150 = input.member[(4u + _e147)];
                let _e153 = input.member[(_e147 + 5u)];
                let _e156 = a_nodes.member[_e150];
                let _e158 = b_nodes.member[_e153];
                if (_e65 == 1u) {
                    if (_e150 == _e153) {
                        if (_e156.member_3 == 4294967295u) {
                            phi_408_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        } else {
                            let _e164 = a_nodes.member[_e156.member_1];
                            let _e167 = a_nodes.member[_e156.member_3];
                            if !((_e164.member_3 == 4294967295u)) {
                                phi_360_ = array<u32, 2>(_e156.member_1, _e156.member_1);
                            } else {
                                phi_360_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e175 = phi_360_;
                            if ((((((_e164.member[0] <= _e167.member_2[0]) && (_e167.member[0] <= _e164.member_2[0])) && (_e164.member[1] <= _e167.member_2[1])) && (_e167.member[1] <= _e164.member_2[1])) && (_e164.member[2] <= _e167.member_2[2])) && (_e167.member[2] <= _e164.member_2[2])) {
                                phi_396_ = array<u32, 2>(_e156.member_1, _e156.member_3);
                            } else {
                                phi_396_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e207 = phi_396_;
                            if !((_e167.member_3 == 4294967295u)) {
                                phi_406_ = array<u32, 2>(_e156.member_3, _e156.member_3);
                            } else {
                                phi_406_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e215 = phi_406_;
                            phi_408_ = array<array<u32, 2>, 4>(_e175, _e207, _e215, array<u32, 2>(4294967295u, 4294967295u));
                        }
                        let _e218 = phi_408_;
                        phi_409_ = _e218;
                        phi_410_ = false;
                    } else {
                        phi_409_ = array<array<u32, 2>, 4>();
                        phi_410_ = true;
                    }
                    let _e220 = phi_409_;
                    let _e222 = phi_410_;
                    phi_411_ = _e220;
                    phi_412_ = _e222;
                } else {
                    phi_411_ = array<array<u32, 2>, 4>();
                    phi_412_ = true;
                }
                let _e224 = phi_411_;
                let _e226 = phi_412_;
                if _e226 {
                    if (_e156.member_3 == 4294967295u) {
                        phi_424_ = false;
                    } else {
                        phi_424_ = !((_e158.member_3 == 4294967295u));
                    }
                    let _e233 = phi_424_;
                    if _e233 {
                        if (_e97 == 1u) {
                            phi_432_ = false;
                        } else {
                            phi_432_ = true;
                        }
                        let _e236 = phi_432_;
                        phi_433_ = _e236;
                    } else {
                        phi_433_ = true;
                    }
                    let _e238 = phi_433_;
                    if _e238 {
                        if (_e156.member_3 == 4294967295u) {
                            phi_445_ = false;
                        } else {
                            phi_445_ = !((_e158.member_3 == 4294967295u));
                        }
                        let _e245 = phi_445_;
                        if _e245 {
                            phi_450_ = (_e97 == 1u);
                        } else {
                            phi_450_ = false;
                        }
                        let _e248 = phi_450_;
                        if _e248 {
                            phi_493_ = bool();
                            phi_494_ = true;
                        } else {
                            let _e250 = (_e156.member_3 == 4294967295u);
                            if _e250 {
                                phi_492_ = bool();
                            } else {
                                if _e245 {
                                    phi_491_ = ((((_e158.member_2[0] - _e158.member[0]) * (_e158.member_2[1] - _e158.member[1])) * (_e158.member_2[2] - _e158.member[2])) > (((_e156.member_2[0] - _e156.member[0]) * (_e156.member_2[1] - _e156.member[1])) * (_e156.member_2[2] - _e156.member[2])));
                                } else {
                                    phi_491_ = false;
                                }
                                let _e279 = phi_491_;
                                phi_492_ = _e279;
                            }
                            let _e281 = phi_492_;
                            phi_493_ = _e281;
                            phi_494_ = _e250;
                        }
                        let _e283 = phi_493_;
                        let _e285 = phi_494_;
                        if _e285 {
                            phi_498_ = true;
                        } else {
                            phi_498_ = _e283;
                        }
                        let _e287 = phi_498_;
                        phi_500_ = !(_e287);
                    } else {
                        phi_500_ = true;
                    }
                    let _e290 = phi_500_;
                    if (_e156.member_3 == 4294967295u) {
                        phi_509_ = false;
                    } else {
                        phi_509_ = !((_e158.member_3 == 4294967295u));
                    }
                    let _e297 = phi_509_;
                    if _e297 {
                        phi_514_ = (_e97 == 1u);
                    } else {
                        phi_514_ = false;
                    }
                    let _e300 = phi_514_;
                    if _e300 {
                        phi_557_ = bool();
                        phi_558_ = true;
                    } else {
                        let _e302 = (_e156.member_3 == 4294967295u);
                        if _e302 {
                            phi_556_ = bool();
                        } else {
                            if _e297 {
                                phi_555_ = ((((_e158.member_2[0] - _e158.member[0]) * (_e158.member_2[1] - _e158.member[1])) * (_e158.member_2[2] - _e158.member[2])) > (((_e156.member_2[0] - _e156.member[0]) * (_e156.member_2[1] - _e156.member[1])) * (_e156.member_2[2] - _e156.member[2])));
                            } else {
                                phi_555_ = false;
                            }
                            let _e331 = phi_555_;
                            phi_556_ = _e331;
                        }
                        let _e333 = phi_556_;
                        phi_557_ = _e333;
                        phi_558_ = _e302;
                    }
                    let _e335 = phi_557_;
                    let _e337 = phi_558_;
                    if _e337 {
                        phi_562_ = true;
                    } else {
                        phi_562_ = _e335;
                    }
                    let _e339 = phi_562_;
                    if _e290 {
                        if (_e156.member_3 == 4294967295u) {
                            phi_572_ = false;
                        } else {
                            phi_572_ = true;
                        }
                        let _e343 = phi_572_;
                        phi_573_ = _e343;
                    } else {
                        phi_573_ = true;
                    }
                    let _e345 = phi_573_;
                    if _e345 {
                        if _e339 {
                            if (_e158.member_3 == 4294967295u) {
                                phi_585_ = false;
                            } else {
                                phi_585_ = true;
                            }
                            let _e349 = phi_585_;
                            phi_586_ = _e349;
                        } else {
                            phi_586_ = true;
                        }
                        let _e351 = phi_586_;
                        if _e351 {
                            if _e290 {
                                if _e339 {
                                    let _e354 = a_nodes.member[_e156.member_1];
                                    let _e359 = a_nodes.member[_e156.member_3];
                                    let _e364 = b_nodes.member[_e158.member_1];
                                    let _e369 = b_nodes.member[_e158.member_3];
                                    if ((((((_e354.member[0] <= _e364.member_2[0]) && (_e364.member[0] <= _e354.member_2[0])) && (_e354.member[1] <= _e364.member_2[1])) && (_e364.member[1] <= _e354.member_2[1])) && (_e354.member[2] <= _e364.member_2[2])) && (_e364.member[2] <= _e354.member_2[2])) {
                                        phi_681_ = array<u32, 2>(_e156.member_1, _e158.member_1);
                                    } else {
                                        phi_681_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e399 = phi_681_;
                                    if ((((((_e354.member[0] <= _e369.member_2[0]) && (_e369.member[0] <= _e354.member_2[0])) && (_e354.member[1] <= _e369.member_2[1])) && (_e369.member[1] <= _e354.member_2[1])) && (_e354.member[2] <= _e369.member_2[2])) && (_e369.member[2] <= _e354.member_2[2])) {
                                        phi_711_ = array<u32, 2>(_e156.member_1, _e158.member_3);
                                    } else {
                                        phi_711_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e427 = phi_711_;
                                    if ((((((_e359.member[0] <= _e364.member_2[0]) && (_e364.member[0] <= _e359.member_2[0])) && (_e359.member[1] <= _e364.member_2[1])) && (_e364.member[1] <= _e359.member_2[1])) && (_e359.member[2] <= _e364.member_2[2])) && (_e364.member[2] <= _e359.member_2[2])) {
                                        phi_741_ = array<u32, 2>(_e156.member_3, _e158.member_1);
                                    } else {
                                        phi_741_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e455 = phi_741_;
                                    if ((((((_e359.member[0] <= _e369.member_2[0]) && (_e369.member[0] <= _e359.member_2[0])) && (_e359.member[1] <= _e369.member_2[1])) && (_e369.member[1] <= _e359.member_2[1])) && (_e359.member[2] <= _e369.member_2[2])) && (_e369.member[2] <= _e359.member_2[2])) {
                                        phi_771_ = array<u32, 2>(_e156.member_3, _e158.member_3);
                                    } else {
                                        phi_771_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e483 = phi_771_;
                                    phi_773_ = array<array<u32, 2>, 4>(_e399, _e427, _e455, _e483);
                                    phi_774_ = false;
                                } else {
                                    phi_773_ = array<array<u32, 2>, 4>();
                                    phi_774_ = true;
                                }
                                let _e486 = phi_773_;
                                let _e488 = phi_774_;
                                phi_775_ = _e486;
                                phi_776_ = _e488;
                            } else {
                                phi_775_ = array<array<u32, 2>, 4>();
                                phi_776_ = true;
                            }
                            let _e490 = phi_775_;
                            let _e492 = phi_776_;
                            if _e492 {
                                if _e290 {
                                    let _e564 = a_nodes.member[_e156.member_1];
                                    let _e569 = a_nodes.member[_e156.member_3];
                                    if ((((((_e564.member[0] <= _e158.member_2[0]) && (_e158.member[0] <= _e564.member_2[0])) && (_e564.member[1] <= _e158.member_2[1])) && (_e158.member[1] <= _e564.member_2[1])) && (_e564.member[2] <= _e158.member_2[2])) && (_e158.member[2] <= _e564.member_2[2])) {
                                        phi_842_ = array<u32, 2>(_e156.member_1, _e153);
                                    } else {
                                        phi_842_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e600 = phi_842_;
                                    if ((((((_e569.member[0] <= _e158.member_2[0]) && (_e158.member[0] <= _e569.member_2[0])) && (_e569.member[1] <= _e158.member_2[1])) && (_e158.member[1] <= _e569.member_2[1])) && (_e569.member[2] <= _e158.member_2[2])) && (_e158.member[2] <= _e569.member_2[2])) {
                                        phi_874_ = array<u32, 2>(_e156.member_3, _e153);
                                    } else {
                                        phi_874_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e629 = phi_874_;
                                    phi_969_ = array<array<u32, 2>, 4>(_e600, _e629, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e495 = b_nodes.member[_e158.member_1];
                                    let _e500 = b_nodes.member[_e158.member_3];
                                    if ((((((_e156.member[0] <= _e495.member_2[0]) && (_e495.member[0] <= _e156.member_2[0])) && (_e156.member[1] <= _e495.member_2[1])) && (_e495.member[1] <= _e156.member_2[1])) && (_e156.member[2] <= _e495.member_2[2])) && (_e495.member[2] <= _e156.member_2[2])) {
                                        phi_935_ = array<u32, 2>(_e150, _e158.member_1);
                                    } else {
                                        phi_935_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e531 = phi_935_;
                                    if ((((((_e156.member[0] <= _e500.member_2[0]) && (_e500.member[0] <= _e156.member_2[0])) && (_e156.member[1] <= _e500.member_2[1])) && (_e500.member[1] <= _e156.member_2[1])) && (_e156.member[2] <= _e500.member_2[2])) && (_e500.member[2] <= _e156.member_2[2])) {
                                        phi_967_ = array<u32, 2>(_e150, _e158.member_3);
                                    } else {
                                        phi_967_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e560 = phi_967_;
                                    phi_969_ = array<array<u32, 2>, 4>(_e531, _e560, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e632 = phi_969_;
                                phi_970_ = _e632;
                            } else {
                                phi_970_ = _e490;
                            }
                            let _e634 = phi_970_;
                            phi_971_ = _e634;
                            phi_972_ = false;
                        } else {
                            phi_971_ = array<array<u32, 2>, 4>();
                            phi_972_ = true;
                        }
                        let _e636 = phi_971_;
                        let _e638 = phi_972_;
                        phi_973_ = _e636;
                        phi_974_ = _e638;
                    } else {
                        phi_973_ = array<array<u32, 2>, 4>();
                        phi_974_ = true;
                    }
                    let _e640 = phi_973_;
                    let _e642 = phi_974_;
                    phi_978_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                    phi_979_ = _e640;
                    phi_980_ = _e642;
                } else {
                    phi_978_ = _e224;
                    phi_979_ = array<array<u32, 2>, 4>();
                    phi_980_ = true;
                }
                let _e644 = phi_978_;
                let _e646 = phi_979_;
                let _e648 = phi_980_;
                if _e648 {
                    phi_984_ = _e644;
                } else {
                    phi_984_ = _e646;
                }
                let _e650 = phi_984_;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e650[0][0], _e650[0][1]), array<u32, 2>(_e650[1][0], _e650[1][1]), array<u32, 2>(_e650[2][0], _e650[2][1]), array<u32, 2>(_e650[3][0], _e650[3][1]));
                phi_1005_ = type_12(0u, 4u);
                loop {
                    let _e670 = phi_1005_;
                    if (_e670.member < _e670.member_1) {
                        phi_1006_ = type_12((_e670.member + 1u), _e670.member_1);
                        phi_1029_ = type_12(1u, _e670.member);
                    } else {
                        phi_1006_ = _e670;
                        phi_1029_ = type_12(0u, type_12().member_1);
                    }
                    let _e682 = phi_1006_;
                    let _e684 = phi_1029_;
                    let _e688 = (bitcast<i32>(_e684.member) != 0i);
                    if _e688 {
                        let _e690 = local_1[_e684.member_1];
                        if (_e690[0] != 4294967295u) {
                            if (_e65 == 1u) {
                                phi_1058_ = (_e690[0] == _e690[1]);
                            } else {
                                phi_1058_ = false;
                            }
                            let _e696 = phi_1058_;
                            if _e696 {
                                phi_3267_ = bool();
                                phi_3268_ = true;
                            } else {
                                if (_e690[0] >= _e78) {
                                    if (_e690[1] >= _e83) {
                                        phi_1070_ = false;
                                    } else {
                                        phi_1070_ = true;
                                    }
                                    let _e700 = phi_1070_;
                                    phi_1071_ = _e700;
                                } else {
                                    phi_1071_ = true;
                                }
                                let _e702 = phi_1071_;
                                if _e702 {
                                    if (_e690[0] < _e78) {
                                        let _e782 = oriented.member[(_e87 + _e690[0])];
                                        phi_1218_ = type_28(array<f32, 3>(_e782.member.x, _e782.member.y, _e782.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e782.member.w, _e782.member_1.x, _e782.member_1.y), array<f32, 3>(_e782.member_1.z, _e782.member_1.w, _e782.member_2.x), array<f32, 3>(_e782.member_2.y, _e782.member_2.z, _e782.member_2.w)), array<f32, 3>(_e782.member_3.x, _e782.member_3.y, _e782.member_3.z));
                                    } else {
                                        let _e705 = a_nodes.member[_e690[0]];
                                        let _e720 = ((_e705.member[0] * 0.5f) + (_e705.member_2[0] * 0.5f));
                                        let _e721 = ((_e705.member[1] * 0.5f) + (_e705.member_2[1] * 0.5f));
                                        let _e722 = ((_e705.member[2] * 0.5f) + (_e705.member_2[2] * 0.5f));
                                        if (_e720 < _e705.member_2[0]) {
                                            phi_1144_ = _e720;
                                        } else {
                                            phi_1144_ = _e705.member_2[0];
                                        }
                                        let _e726 = phi_1144_;
                                        if (_e721 < _e705.member_2[1]) {
                                            phi_1150_ = _e721;
                                        } else {
                                            phi_1150_ = _e705.member_2[1];
                                        }
                                        let _e730 = phi_1150_;
                                        if (_e722 < _e705.member_2[2]) {
                                            phi_1156_ = _e722;
                                        } else {
                                            phi_1156_ = _e705.member_2[2];
                                        }
                                        let _e734 = phi_1156_;
                                        if (_e726 > _e705.member[0]) {
                                            phi_1162_ = _e726;
                                        } else {
                                            phi_1162_ = _e705.member[0];
                                        }
                                        let _e738 = phi_1162_;
                                        if (_e730 > _e705.member[1]) {
                                            phi_1168_ = _e730;
                                        } else {
                                            phi_1168_ = _e705.member[1];
                                        }
                                        let _e742 = phi_1168_;
                                        if (_e734 > _e705.member[2]) {
                                            phi_1174_ = _e734;
                                        } else {
                                            phi_1174_ = _e705.member[2];
                                        }
                                        let _e746 = phi_1174_;
                                        let _e749 = (_e705.member_2[0] - _e738);
                                        let _e751 = (_e705.member_2[1] - _e742);
                                        let _e753 = (_e705.member_2[2] - _e746);
                                        let _e755 = (_e738 - _e705.member[0]);
                                        let _e757 = (_e742 - _e705.member[1]);
                                        let _e759 = (_e746 - _e705.member[2]);
                                        if (_e749 > _e755) {
                                            phi_1192_ = _e749;
                                        } else {
                                            phi_1192_ = _e755;
                                        }
                                        let _e762 = phi_1192_;
                                        if (_e751 > _e757) {
                                            phi_1197_ = _e751;
                                        } else {
                                            phi_1197_ = _e757;
                                        }
                                        let _e765 = phi_1197_;
                                        if (_e753 > _e759) {
                                            phi_1202_ = _e753;
                                        } else {
                                            phi_1202_ = _e759;
                                        }
                                        let _e768 = phi_1202_;
                                        let _e770 = (1f + (0.000000059604645f * 4f));
                                        let _e774 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1218_ = type_28(array<f32, 3>(_e738, _e742, _e746), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e762 * _e770) + _e774), ((_e765 * _e770) + _e774), ((_e768 * _e770) + _e774)));
                                    }
                                    let _e821 = phi_1218_;
                                    if (_e690[1] < _e83) {
                                        let _e901 = oriented.member[(_e91 + _e690[1])];
                                        phi_1362_ = type_28(array<f32, 3>(_e901.member.x, _e901.member.y, _e901.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e901.member.w, _e901.member_1.x, _e901.member_1.y), array<f32, 3>(_e901.member_1.z, _e901.member_1.w, _e901.member_2.x), array<f32, 3>(_e901.member_2.y, _e901.member_2.z, _e901.member_2.w)), array<f32, 3>(_e901.member_3.x, _e901.member_3.y, _e901.member_3.z));
                                    } else {
                                        let _e824 = b_nodes.member[_e690[1]];
                                        let _e839 = ((_e824.member[0] * 0.5f) + (_e824.member_2[0] * 0.5f));
                                        let _e840 = ((_e824.member[1] * 0.5f) + (_e824.member_2[1] * 0.5f));
                                        let _e841 = ((_e824.member[2] * 0.5f) + (_e824.member_2[2] * 0.5f));
                                        if (_e839 < _e824.member_2[0]) {
                                            phi_1288_ = _e839;
                                        } else {
                                            phi_1288_ = _e824.member_2[0];
                                        }
                                        let _e845 = phi_1288_;
                                        if (_e840 < _e824.member_2[1]) {
                                            phi_1294_ = _e840;
                                        } else {
                                            phi_1294_ = _e824.member_2[1];
                                        }
                                        let _e849 = phi_1294_;
                                        if (_e841 < _e824.member_2[2]) {
                                            phi_1300_ = _e841;
                                        } else {
                                            phi_1300_ = _e824.member_2[2];
                                        }
                                        let _e853 = phi_1300_;
                                        if (_e845 > _e824.member[0]) {
                                            phi_1306_ = _e845;
                                        } else {
                                            phi_1306_ = _e824.member[0];
                                        }
                                        let _e857 = phi_1306_;
                                        if (_e849 > _e824.member[1]) {
                                            phi_1312_ = _e849;
                                        } else {
                                            phi_1312_ = _e824.member[1];
                                        }
                                        let _e861 = phi_1312_;
                                        if (_e853 > _e824.member[2]) {
                                            phi_1318_ = _e853;
                                        } else {
                                            phi_1318_ = _e824.member[2];
                                        }
                                        let _e865 = phi_1318_;
                                        let _e868 = (_e824.member_2[0] - _e857);
                                        let _e870 = (_e824.member_2[1] - _e861);
                                        let _e872 = (_e824.member_2[2] - _e865);
                                        let _e874 = (_e857 - _e824.member[0]);
                                        let _e876 = (_e861 - _e824.member[1]);
                                        let _e878 = (_e865 - _e824.member[2]);
                                        if (_e868 > _e874) {
                                            phi_1336_ = _e868;
                                        } else {
                                            phi_1336_ = _e874;
                                        }
                                        let _e881 = phi_1336_;
                                        if (_e870 > _e876) {
                                            phi_1341_ = _e870;
                                        } else {
                                            phi_1341_ = _e876;
                                        }
                                        let _e884 = phi_1341_;
                                        if (_e872 > _e878) {
                                            phi_1346_ = _e872;
                                        } else {
                                            phi_1346_ = _e878;
                                        }
                                        let _e887 = phi_1346_;
                                        let _e889 = (1f + (0.000000059604645f * 4f));
                                        let _e893 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1362_ = type_28(array<f32, 3>(_e857, _e861, _e865), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e881 * _e889) + _e893), ((_e884 * _e889) + _e893), ((_e887 * _e889) + _e893)));
                                    }
                                    let _e940 = phi_1362_;
                                    let _e945 = (_e940.member[0] - _e821.member[0]);
                                    let _e948 = (_e940.member[1] - _e821.member[1]);
                                    let _e951 = (_e940.member[2] - _e821.member[2]);
                                    if (_e945 < 0f) {
                                        phi_1552_ = -(_e945);
                                    } else {
                                        phi_1552_ = _e945;
                                    }
                                    let _e1140 = phi_1552_;
                                    if (_e948 < 0f) {
                                        phi_1558_ = -(_e948);
                                    } else {
                                        phi_1558_ = _e948;
                                    }
                                    let _e1144 = phi_1558_;
                                    if (_e951 < 0f) {
                                        phi_1565_ = -(_e951);
                                    } else {
                                        phi_1565_ = _e951;
                                    }
                                    let _e1149 = phi_1565_;
                                    if (_e821.member_2[0] < 0f) {
                                        phi_1574_ = -(_e821.member_2[0]);
                                    } else {
                                        phi_1574_ = _e821.member_2[0];
                                    }
                                    let _e1156 = phi_1574_;
                                    if (_e821.member_2[1] < 0f) {
                                        phi_1581_ = -(_e821.member_2[1]);
                                    } else {
                                        phi_1581_ = _e821.member_2[1];
                                    }
                                    let _e1161 = phi_1581_;
                                    if (_e821.member_2[2] < 0f) {
                                        phi_1589_ = -(_e821.member_2[2]);
                                    } else {
                                        phi_1589_ = _e821.member_2[2];
                                    }
                                    let _e1167 = phi_1589_;
                                    if (_e940.member_2[0] < 0f) {
                                        phi_1598_ = -(_e940.member_2[0]);
                                    } else {
                                        phi_1598_ = _e940.member_2[0];
                                    }
                                    let _e1174 = phi_1598_;
                                    if (_e940.member_2[1] < 0f) {
                                        phi_1605_ = -(_e940.member_2[1]);
                                    } else {
                                        phi_1605_ = _e940.member_2[1];
                                    }
                                    let _e1179 = phi_1605_;
                                    if (_e940.member_2[2] < 0f) {
                                        phi_1613_ = -(_e940.member_2[2]);
                                    } else {
                                        phi_1613_ = _e940.member_2[2];
                                    }
                                    let _e1185 = phi_1613_;
                                    local = type_23(array<array<f32, 3>, 3>(array<f32, 3>((((_e940.member_1[0][0] * _e821.member_1[0][0]) + (_e940.member_1[0][1] * _e821.member_1[0][1])) + (_e940.member_1[0][2] * _e821.member_1[0][2])), (((_e940.member_1[1][0] * _e821.member_1[0][0]) + (_e940.member_1[1][1] * _e821.member_1[0][1])) + (_e940.member_1[1][2] * _e821.member_1[0][2])), (((_e940.member_1[2][0] * _e821.member_1[0][0]) + (_e940.member_1[2][1] * _e821.member_1[0][1])) + (_e940.member_1[2][2] * _e821.member_1[0][2]))), array<f32, 3>((((_e940.member_1[0][0] * _e821.member_1[1][0]) + (_e940.member_1[0][1] * _e821.member_1[1][1])) + (_e940.member_1[0][2] * _e821.member_1[1][2])), (((_e940.member_1[1][0] * _e821.member_1[1][0]) + (_e940.member_1[1][1] * _e821.member_1[1][1])) + (_e940.member_1[1][2] * _e821.member_1[1][2])), (((_e940.member_1[2][0] * _e821.member_1[1][0]) + (_e940.member_1[2][1] * _e821.member_1[1][1])) + (_e940.member_1[2][2] * _e821.member_1[1][2]))), array<f32, 3>((((_e940.member_1[0][0] * _e821.member_1[2][0]) + (_e940.member_1[0][1] * _e821.member_1[2][1])) + (_e940.member_1[0][2] * _e821.member_1[2][2])), (((_e940.member_1[1][0] * _e821.member_1[2][0]) + (_e940.member_1[1][1] * _e821.member_1[2][1])) + (_e940.member_1[1][2] * _e821.member_1[2][2])), (((_e940.member_1[2][0] * _e821.member_1[2][0]) + (_e940.member_1[2][1] * _e821.member_1[2][1])) + (_e940.member_1[2][2] * _e821.member_1[2][2])))), array<f32, 3>((((_e821.member_1[0][0] * _e945) + (_e821.member_1[0][1] * _e948)) + (_e821.member_1[0][2] * _e951)), (((_e821.member_1[1][0] * _e945) + (_e821.member_1[1][1] * _e948)) + (_e821.member_1[1][2] * _e951)), (((_e821.member_1[2][0] * _e945) + (_e821.member_1[2][1] * _e948)) + (_e821.member_1[2][2] * _e951))), array<f32, 3>((((_e940.member_1[0][0] * _e945) + (_e940.member_1[0][1] * _e948)) + (_e940.member_1[0][2] * _e951)), (((_e940.member_1[1][0] * _e945) + (_e940.member_1[1][1] * _e948)) + (_e940.member_1[1][2] * _e951)), (((_e940.member_1[2][0] * _e945) + (_e940.member_1[2][1] * _e948)) + (_e940.member_1[2][2] * _e951))), array<f32, 3>(_e821.member_2[0], _e821.member_2[1], _e821.member_2[2]), array<f32, 3>(_e940.member_2[0], _e940.member_2[1], _e940.member_2[2]), ((((((_e1140 + _e1144) + _e1149) + (((_e1156 + _e1161) + _e1167) + ((_e1174 + _e1179) + _e1185))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1212 = local.member[0u][0u];
                                    let _e1216 = local.member[0u][1u];
                                    let _e1220 = local.member[0u][2u];
                                    let _e1224 = local.member[1u][0u];
                                    let _e1228 = local.member[1u][1u];
                                    let _e1232 = local.member[1u][2u];
                                    let _e1236 = local.member[2u][0u];
                                    let _e1240 = local.member[2u][1u];
                                    let _e1244 = local.member[2u][2u];
                                    let _e1246 = local.member_3;
                                    let _e1251 = local.member_4;
                                    let _e1257 = local.member_1[0u];
                                    if (_e1257 < 0f) {
                                        phi_1706_ = -(_e1257);
                                    } else {
                                        phi_1706_ = _e1257;
                                    }
                                    let _e1261 = phi_1706_;
                                    if (_e1212 < 0f) {
                                        phi_1713_ = -(_e1212);
                                    } else {
                                        phi_1713_ = _e1212;
                                    }
                                    let _e1265 = phi_1713_;
                                    if (_e1216 < 0f) {
                                        phi_1719_ = -(_e1216);
                                    } else {
                                        phi_1719_ = _e1216;
                                    }
                                    let _e1269 = phi_1719_;
                                    if (_e1220 < 0f) {
                                        phi_1725_ = -(_e1220);
                                    } else {
                                        phi_1725_ = _e1220;
                                    }
                                    let _e1273 = phi_1725_;
                                    let _e1280 = (_e1261 - (_e1246[0] + (((_e1265 * _e1251[0]) + (_e1269 * _e1251[1])) + (_e1273 * _e1251[2]))));
                                    let _e1283 = local.member_1[1u];
                                    if (_e1283 < 0f) {
                                        phi_1744_ = -(_e1283);
                                    } else {
                                        phi_1744_ = _e1283;
                                    }
                                    let _e1287 = phi_1744_;
                                    if (_e1224 < 0f) {
                                        phi_1751_ = -(_e1224);
                                    } else {
                                        phi_1751_ = _e1224;
                                    }
                                    let _e1291 = phi_1751_;
                                    if (_e1228 < 0f) {
                                        phi_1757_ = -(_e1228);
                                    } else {
                                        phi_1757_ = _e1228;
                                    }
                                    let _e1295 = phi_1757_;
                                    if (_e1232 < 0f) {
                                        phi_1763_ = -(_e1232);
                                    } else {
                                        phi_1763_ = _e1232;
                                    }
                                    let _e1299 = phi_1763_;
                                    let _e1306 = (_e1287 - (_e1246[1] + (((_e1291 * _e1251[0]) + (_e1295 * _e1251[1])) + (_e1299 * _e1251[2]))));
                                    let _e1309 = local.member_1[2u];
                                    if (_e1309 < 0f) {
                                        phi_1782_ = -(_e1309);
                                    } else {
                                        phi_1782_ = _e1309;
                                    }
                                    let _e1313 = phi_1782_;
                                    if (_e1236 < 0f) {
                                        phi_1789_ = -(_e1236);
                                    } else {
                                        phi_1789_ = _e1236;
                                    }
                                    let _e1317 = phi_1789_;
                                    if (_e1240 < 0f) {
                                        phi_1795_ = -(_e1240);
                                    } else {
                                        phi_1795_ = _e1240;
                                    }
                                    let _e1321 = phi_1795_;
                                    if (_e1244 < 0f) {
                                        phi_1801_ = -(_e1244);
                                    } else {
                                        phi_1801_ = _e1244;
                                    }
                                    let _e1325 = phi_1801_;
                                    let _e1332 = (_e1313 - (_e1246[2] + (((_e1317 * _e1251[0]) + (_e1321 * _e1251[1])) + (_e1325 * _e1251[2]))));
                                    let _e1335 = local.member_2[0u];
                                    if (_e1335 < 0f) {
                                        phi_1820_ = -(_e1335);
                                    } else {
                                        phi_1820_ = _e1335;
                                    }
                                    let _e1339 = phi_1820_;
                                    if (_e1212 < 0f) {
                                        phi_1827_ = -(_e1212);
                                    } else {
                                        phi_1827_ = _e1212;
                                    }
                                    let _e1343 = phi_1827_;
                                    if (_e1224 < 0f) {
                                        phi_1833_ = -(_e1224);
                                    } else {
                                        phi_1833_ = _e1224;
                                    }
                                    let _e1347 = phi_1833_;
                                    if (_e1236 < 0f) {
                                        phi_1839_ = -(_e1236);
                                    } else {
                                        phi_1839_ = _e1236;
                                    }
                                    let _e1351 = phi_1839_;
                                    let _e1358 = (_e1339 - (_e1251[0] + (((_e1343 * _e1246[0]) + (_e1347 * _e1246[1])) + (_e1351 * _e1246[2]))));
                                    let _e1361 = local.member_2[1u];
                                    if (_e1361 < 0f) {
                                        phi_1858_ = -(_e1361);
                                    } else {
                                        phi_1858_ = _e1361;
                                    }
                                    let _e1365 = phi_1858_;
                                    if (_e1216 < 0f) {
                                        phi_1865_ = -(_e1216);
                                    } else {
                                        phi_1865_ = _e1216;
                                    }
                                    let _e1369 = phi_1865_;
                                    if (_e1228 < 0f) {
                                        phi_1871_ = -(_e1228);
                                    } else {
                                        phi_1871_ = _e1228;
                                    }
                                    let _e1373 = phi_1871_;
                                    if (_e1240 < 0f) {
                                        phi_1877_ = -(_e1240);
                                    } else {
                                        phi_1877_ = _e1240;
                                    }
                                    let _e1377 = phi_1877_;
                                    let _e1384 = (_e1365 - (_e1251[1] + (((_e1369 * _e1246[0]) + (_e1373 * _e1246[1])) + (_e1377 * _e1246[2]))));
                                    let _e1387 = local.member_2[2u];
                                    if (_e1387 < 0f) {
                                        phi_1896_ = -(_e1387);
                                    } else {
                                        phi_1896_ = _e1387;
                                    }
                                    let _e1391 = phi_1896_;
                                    if (_e1220 < 0f) {
                                        phi_1903_ = -(_e1220);
                                    } else {
                                        phi_1903_ = _e1220;
                                    }
                                    let _e1395 = phi_1903_;
                                    if (_e1232 < 0f) {
                                        phi_1909_ = -(_e1232);
                                    } else {
                                        phi_1909_ = _e1232;
                                    }
                                    let _e1399 = phi_1909_;
                                    if (_e1244 < 0f) {
                                        phi_1915_ = -(_e1244);
                                    } else {
                                        phi_1915_ = _e1244;
                                    }
                                    let _e1403 = phi_1915_;
                                    let _e1410 = (_e1391 - (_e1251[2] + (((_e1395 * _e1246[0]) + (_e1399 * _e1246[1])) + (_e1403 * _e1246[2]))));
                                    if (_e1280 > _e1306) {
                                        phi_1930_ = _e1280;
                                    } else {
                                        phi_1930_ = _e1306;
                                    }
                                    let _e1413 = phi_1930_;
                                    if (_e1413 > _e1332) {
                                        phi_1935_ = _e1413;
                                    } else {
                                        phi_1935_ = _e1332;
                                    }
                                    let _e1416 = phi_1935_;
                                    if (_e1358 > _e1384) {
                                        phi_1940_ = _e1358;
                                    } else {
                                        phi_1940_ = _e1384;
                                    }
                                    let _e1419 = phi_1940_;
                                    if (_e1419 > _e1410) {
                                        phi_1945_ = _e1419;
                                    } else {
                                        phi_1945_ = _e1410;
                                    }
                                    let _e1422 = phi_1945_;
                                    if (_e1416 > _e1422) {
                                        phi_1950_ = _e1416;
                                    } else {
                                        phi_1950_ = _e1422;
                                    }
                                    let _e1425 = phi_1950_;
                                    let _e1427 = local.member_5;
                                    if (_e1425 > _e1427) {
                                        phi_3263_ = true;
                                    } else {
                                        let _e1432 = local.member[1u][0u];
                                        let _e1435 = local.member_1[2u];
                                        let _e1440 = local.member[2u][0u];
                                        let _e1443 = local.member_1[1u];
                                        let _e1445 = ((_e1432 * _e1435) - (_e1440 * _e1443));
                                        let _e1449 = local.member[2u][0u];
                                        if (_e1449 < 0f) {
                                            phi_2009_ = -(_e1449);
                                        } else {
                                            phi_2009_ = _e1449;
                                        }
                                        let _e1453 = phi_2009_;
                                        let _e1456 = local.member_3[1u];
                                        let _e1461 = local.member[1u][0u];
                                        if (_e1461 < 0f) {
                                            phi_2032_ = -(_e1461);
                                        } else {
                                            phi_2032_ = _e1461;
                                        }
                                        let _e1465 = phi_2032_;
                                        let _e1468 = local.member_3[2u];
                                        let _e1474 = local.member[0u][2u];
                                        if (_e1474 < 0f) {
                                            phi_2055_ = -(_e1474);
                                        } else {
                                            phi_2055_ = _e1474;
                                        }
                                        let _e1478 = phi_2055_;
                                        let _e1481 = local.member_4[1u];
                                        let _e1486 = local.member[0u][1u];
                                        if (_e1486 < 0f) {
                                            phi_2077_ = -(_e1486);
                                        } else {
                                            phi_2077_ = _e1486;
                                        }
                                        let _e1490 = phi_2077_;
                                        let _e1493 = local.member_4[2u];
                                        if (_e1445 < 0f) {
                                            phi_2093_ = -(_e1445);
                                        } else {
                                            phi_2093_ = _e1445;
                                        }
                                        let _e1499 = phi_2093_;
                                        let _e1501 = (_e1499 - (((_e1453 * _e1456) + (_e1465 * _e1468)) + ((_e1478 * _e1481) + (_e1490 * _e1493))));
                                        let _e1505 = local.member[1u][1u];
                                        let _e1508 = local.member_1[2u];
                                        let _e1513 = local.member[2u][1u];
                                        let _e1516 = local.member_1[1u];
                                        let _e1518 = ((_e1505 * _e1508) - (_e1513 * _e1516));
                                        let _e1522 = local.member[2u][1u];
                                        if (_e1522 < 0f) {
                                            phi_2148_ = -(_e1522);
                                        } else {
                                            phi_2148_ = _e1522;
                                        }
                                        let _e1526 = phi_2148_;
                                        let _e1529 = local.member_3[1u];
                                        let _e1534 = local.member[1u][1u];
                                        if (_e1534 < 0f) {
                                            phi_2171_ = -(_e1534);
                                        } else {
                                            phi_2171_ = _e1534;
                                        }
                                        let _e1538 = phi_2171_;
                                        let _e1541 = local.member_3[2u];
                                        let _e1547 = local.member[0u][0u];
                                        if (_e1547 < 0f) {
                                            phi_2194_ = -(_e1547);
                                        } else {
                                            phi_2194_ = _e1547;
                                        }
                                        let _e1551 = phi_2194_;
                                        let _e1554 = local.member_4[2u];
                                        let _e1559 = local.member[0u][2u];
                                        if (_e1559 < 0f) {
                                            phi_2216_ = -(_e1559);
                                        } else {
                                            phi_2216_ = _e1559;
                                        }
                                        let _e1563 = phi_2216_;
                                        let _e1566 = local.member_4[0u];
                                        if (_e1518 < 0f) {
                                            phi_2232_ = -(_e1518);
                                        } else {
                                            phi_2232_ = _e1518;
                                        }
                                        let _e1572 = phi_2232_;
                                        let _e1574 = (_e1572 - (((_e1526 * _e1529) + (_e1538 * _e1541)) + ((_e1551 * _e1554) + (_e1563 * _e1566))));
                                        let _e1578 = local.member[1u][2u];
                                        let _e1581 = local.member_1[2u];
                                        let _e1586 = local.member[2u][2u];
                                        let _e1589 = local.member_1[1u];
                                        let _e1591 = ((_e1578 * _e1581) - (_e1586 * _e1589));
                                        let _e1595 = local.member[2u][2u];
                                        if (_e1595 < 0f) {
                                            phi_2287_ = -(_e1595);
                                        } else {
                                            phi_2287_ = _e1595;
                                        }
                                        let _e1599 = phi_2287_;
                                        let _e1602 = local.member_3[1u];
                                        let _e1607 = local.member[1u][2u];
                                        if (_e1607 < 0f) {
                                            phi_2310_ = -(_e1607);
                                        } else {
                                            phi_2310_ = _e1607;
                                        }
                                        let _e1611 = phi_2310_;
                                        let _e1614 = local.member_3[2u];
                                        let _e1620 = local.member[0u][1u];
                                        if (_e1620 < 0f) {
                                            phi_2333_ = -(_e1620);
                                        } else {
                                            phi_2333_ = _e1620;
                                        }
                                        let _e1624 = phi_2333_;
                                        let _e1627 = local.member_4[0u];
                                        let _e1632 = local.member[0u][0u];
                                        if (_e1632 < 0f) {
                                            phi_2355_ = -(_e1632);
                                        } else {
                                            phi_2355_ = _e1632;
                                        }
                                        let _e1636 = phi_2355_;
                                        let _e1639 = local.member_4[1u];
                                        if (_e1591 < 0f) {
                                            phi_2371_ = -(_e1591);
                                        } else {
                                            phi_2371_ = _e1591;
                                        }
                                        let _e1645 = phi_2371_;
                                        let _e1647 = (_e1645 - (((_e1599 * _e1602) + (_e1611 * _e1614)) + ((_e1624 * _e1627) + (_e1636 * _e1639))));
                                        let _e1651 = local.member[2u][0u];
                                        let _e1654 = local.member_1[0u];
                                        let _e1659 = local.member[0u][0u];
                                        let _e1662 = local.member_1[2u];
                                        let _e1664 = ((_e1651 * _e1654) - (_e1659 * _e1662));
                                        let _e1668 = local.member[0u][0u];
                                        if (_e1668 < 0f) {
                                            phi_2426_ = -(_e1668);
                                        } else {
                                            phi_2426_ = _e1668;
                                        }
                                        let _e1672 = phi_2426_;
                                        let _e1675 = local.member_3[2u];
                                        let _e1680 = local.member[2u][0u];
                                        if (_e1680 < 0f) {
                                            phi_2449_ = -(_e1680);
                                        } else {
                                            phi_2449_ = _e1680;
                                        }
                                        let _e1684 = phi_2449_;
                                        let _e1687 = local.member_3[0u];
                                        let _e1693 = local.member[1u][2u];
                                        if (_e1693 < 0f) {
                                            phi_2473_ = -(_e1693);
                                        } else {
                                            phi_2473_ = _e1693;
                                        }
                                        let _e1697 = phi_2473_;
                                        let _e1700 = local.member_4[1u];
                                        let _e1705 = local.member[1u][1u];
                                        if (_e1705 < 0f) {
                                            phi_2496_ = -(_e1705);
                                        } else {
                                            phi_2496_ = _e1705;
                                        }
                                        let _e1709 = phi_2496_;
                                        let _e1712 = local.member_4[2u];
                                        if (_e1664 < 0f) {
                                            phi_2512_ = -(_e1664);
                                        } else {
                                            phi_2512_ = _e1664;
                                        }
                                        let _e1718 = phi_2512_;
                                        let _e1720 = (_e1718 - (((_e1672 * _e1675) + (_e1684 * _e1687)) + ((_e1697 * _e1700) + (_e1709 * _e1712))));
                                        let _e1724 = local.member[2u][1u];
                                        let _e1727 = local.member_1[0u];
                                        let _e1732 = local.member[0u][1u];
                                        let _e1735 = local.member_1[2u];
                                        let _e1737 = ((_e1724 * _e1727) - (_e1732 * _e1735));
                                        let _e1741 = local.member[0u][1u];
                                        if (_e1741 < 0f) {
                                            phi_2567_ = -(_e1741);
                                        } else {
                                            phi_2567_ = _e1741;
                                        }
                                        let _e1745 = phi_2567_;
                                        let _e1748 = local.member_3[2u];
                                        let _e1753 = local.member[2u][1u];
                                        if (_e1753 < 0f) {
                                            phi_2590_ = -(_e1753);
                                        } else {
                                            phi_2590_ = _e1753;
                                        }
                                        let _e1757 = phi_2590_;
                                        let _e1760 = local.member_3[0u];
                                        let _e1766 = local.member[1u][0u];
                                        if (_e1766 < 0f) {
                                            phi_2614_ = -(_e1766);
                                        } else {
                                            phi_2614_ = _e1766;
                                        }
                                        let _e1770 = phi_2614_;
                                        let _e1773 = local.member_4[2u];
                                        let _e1778 = local.member[1u][2u];
                                        if (_e1778 < 0f) {
                                            phi_2637_ = -(_e1778);
                                        } else {
                                            phi_2637_ = _e1778;
                                        }
                                        let _e1782 = phi_2637_;
                                        let _e1785 = local.member_4[0u];
                                        if (_e1737 < 0f) {
                                            phi_2653_ = -(_e1737);
                                        } else {
                                            phi_2653_ = _e1737;
                                        }
                                        let _e1791 = phi_2653_;
                                        let _e1793 = (_e1791 - (((_e1745 * _e1748) + (_e1757 * _e1760)) + ((_e1770 * _e1773) + (_e1782 * _e1785))));
                                        let _e1797 = local.member[2u][2u];
                                        let _e1800 = local.member_1[0u];
                                        let _e1805 = local.member[0u][2u];
                                        let _e1808 = local.member_1[2u];
                                        let _e1810 = ((_e1797 * _e1800) - (_e1805 * _e1808));
                                        let _e1814 = local.member[0u][2u];
                                        if (_e1814 < 0f) {
                                            phi_2708_ = -(_e1814);
                                        } else {
                                            phi_2708_ = _e1814;
                                        }
                                        let _e1818 = phi_2708_;
                                        let _e1821 = local.member_3[2u];
                                        let _e1826 = local.member[2u][2u];
                                        if (_e1826 < 0f) {
                                            phi_2731_ = -(_e1826);
                                        } else {
                                            phi_2731_ = _e1826;
                                        }
                                        let _e1830 = phi_2731_;
                                        let _e1833 = local.member_3[0u];
                                        let _e1839 = local.member[1u][1u];
                                        if (_e1839 < 0f) {
                                            phi_2755_ = -(_e1839);
                                        } else {
                                            phi_2755_ = _e1839;
                                        }
                                        let _e1843 = phi_2755_;
                                        let _e1846 = local.member_4[0u];
                                        let _e1851 = local.member[1u][0u];
                                        if (_e1851 < 0f) {
                                            phi_2778_ = -(_e1851);
                                        } else {
                                            phi_2778_ = _e1851;
                                        }
                                        let _e1855 = phi_2778_;
                                        let _e1858 = local.member_4[1u];
                                        if (_e1810 < 0f) {
                                            phi_2794_ = -(_e1810);
                                        } else {
                                            phi_2794_ = _e1810;
                                        }
                                        let _e1864 = phi_2794_;
                                        let _e1866 = (_e1864 - (((_e1818 * _e1821) + (_e1830 * _e1833)) + ((_e1843 * _e1846) + (_e1855 * _e1858))));
                                        let _e1870 = local.member[0u][0u];
                                        let _e1873 = local.member_1[1u];
                                        let _e1878 = local.member[1u][0u];
                                        let _e1881 = local.member_1[0u];
                                        let _e1883 = ((_e1870 * _e1873) - (_e1878 * _e1881));
                                        let _e1887 = local.member[1u][0u];
                                        if (_e1887 < 0f) {
                                            phi_2849_ = -(_e1887);
                                        } else {
                                            phi_2849_ = _e1887;
                                        }
                                        let _e1891 = phi_2849_;
                                        let _e1894 = local.member_3[0u];
                                        let _e1899 = local.member[0u][0u];
                                        if (_e1899 < 0f) {
                                            phi_2872_ = -(_e1899);
                                        } else {
                                            phi_2872_ = _e1899;
                                        }
                                        let _e1903 = phi_2872_;
                                        let _e1906 = local.member_3[1u];
                                        let _e1912 = local.member[2u][2u];
                                        if (_e1912 < 0f) {
                                            phi_2896_ = -(_e1912);
                                        } else {
                                            phi_2896_ = _e1912;
                                        }
                                        let _e1916 = phi_2896_;
                                        let _e1919 = local.member_4[1u];
                                        let _e1924 = local.member[2u][1u];
                                        if (_e1924 < 0f) {
                                            phi_2919_ = -(_e1924);
                                        } else {
                                            phi_2919_ = _e1924;
                                        }
                                        let _e1928 = phi_2919_;
                                        let _e1931 = local.member_4[2u];
                                        if (_e1883 < 0f) {
                                            phi_2935_ = -(_e1883);
                                        } else {
                                            phi_2935_ = _e1883;
                                        }
                                        let _e1937 = phi_2935_;
                                        let _e1939 = (_e1937 - (((_e1891 * _e1894) + (_e1903 * _e1906)) + ((_e1916 * _e1919) + (_e1928 * _e1931))));
                                        let _e1943 = local.member[0u][1u];
                                        let _e1946 = local.member_1[1u];
                                        let _e1951 = local.member[1u][1u];
                                        let _e1954 = local.member_1[0u];
                                        let _e1956 = ((_e1943 * _e1946) - (_e1951 * _e1954));
                                        let _e1960 = local.member[1u][1u];
                                        if (_e1960 < 0f) {
                                            phi_2990_ = -(_e1960);
                                        } else {
                                            phi_2990_ = _e1960;
                                        }
                                        let _e1964 = phi_2990_;
                                        let _e1967 = local.member_3[0u];
                                        let _e1972 = local.member[0u][1u];
                                        if (_e1972 < 0f) {
                                            phi_3013_ = -(_e1972);
                                        } else {
                                            phi_3013_ = _e1972;
                                        }
                                        let _e1976 = phi_3013_;
                                        let _e1979 = local.member_3[1u];
                                        let _e1985 = local.member[2u][0u];
                                        if (_e1985 < 0f) {
                                            phi_3037_ = -(_e1985);
                                        } else {
                                            phi_3037_ = _e1985;
                                        }
                                        let _e1989 = phi_3037_;
                                        let _e1992 = local.member_4[2u];
                                        let _e1997 = local.member[2u][2u];
                                        if (_e1997 < 0f) {
                                            phi_3060_ = -(_e1997);
                                        } else {
                                            phi_3060_ = _e1997;
                                        }
                                        let _e2001 = phi_3060_;
                                        let _e2004 = local.member_4[0u];
                                        if (_e1956 < 0f) {
                                            phi_3076_ = -(_e1956);
                                        } else {
                                            phi_3076_ = _e1956;
                                        }
                                        let _e2010 = phi_3076_;
                                        let _e2012 = (_e2010 - (((_e1964 * _e1967) + (_e1976 * _e1979)) + ((_e1989 * _e1992) + (_e2001 * _e2004))));
                                        let _e2016 = local.member[0u][2u];
                                        let _e2019 = local.member_1[1u];
                                        let _e2024 = local.member[1u][2u];
                                        let _e2027 = local.member_1[0u];
                                        let _e2029 = ((_e2016 * _e2019) - (_e2024 * _e2027));
                                        let _e2033 = local.member[1u][2u];
                                        if (_e2033 < 0f) {
                                            phi_3131_ = -(_e2033);
                                        } else {
                                            phi_3131_ = _e2033;
                                        }
                                        let _e2037 = phi_3131_;
                                        let _e2040 = local.member_3[0u];
                                        let _e2045 = local.member[0u][2u];
                                        if (_e2045 < 0f) {
                                            phi_3154_ = -(_e2045);
                                        } else {
                                            phi_3154_ = _e2045;
                                        }
                                        let _e2049 = phi_3154_;
                                        let _e2052 = local.member_3[1u];
                                        let _e2058 = local.member[2u][1u];
                                        if (_e2058 < 0f) {
                                            phi_3178_ = -(_e2058);
                                        } else {
                                            phi_3178_ = _e2058;
                                        }
                                        let _e2062 = phi_3178_;
                                        let _e2065 = local.member_4[0u];
                                        let _e2070 = local.member[2u][0u];
                                        if (_e2070 < 0f) {
                                            phi_3201_ = -(_e2070);
                                        } else {
                                            phi_3201_ = _e2070;
                                        }
                                        let _e2074 = phi_3201_;
                                        let _e2077 = local.member_4[1u];
                                        if (_e2029 < 0f) {
                                            phi_3217_ = -(_e2029);
                                        } else {
                                            phi_3217_ = _e2029;
                                        }
                                        let _e2083 = phi_3217_;
                                        let _e2085 = (_e2083 - (((_e2037 * _e2040) + (_e2049 * _e2052)) + ((_e2062 * _e2065) + (_e2074 * _e2077))));
                                        if (_e1501 > _e1574) {
                                            phi_3224_ = _e1501;
                                        } else {
                                            phi_3224_ = _e1574;
                                        }
                                        let _e2088 = phi_3224_;
                                        if (_e2088 > _e1647) {
                                            phi_3229_ = _e2088;
                                        } else {
                                            phi_3229_ = _e1647;
                                        }
                                        let _e2091 = phi_3229_;
                                        if (_e1720 > _e1793) {
                                            phi_3234_ = _e1720;
                                        } else {
                                            phi_3234_ = _e1793;
                                        }
                                        let _e2094 = phi_3234_;
                                        if (_e2094 > _e1866) {
                                            phi_3239_ = _e2094;
                                        } else {
                                            phi_3239_ = _e1866;
                                        }
                                        let _e2097 = phi_3239_;
                                        if (_e2091 > _e2097) {
                                            phi_3244_ = _e2091;
                                        } else {
                                            phi_3244_ = _e2097;
                                        }
                                        let _e2100 = phi_3244_;
                                        if (_e1939 > _e2012) {
                                            phi_3249_ = _e1939;
                                        } else {
                                            phi_3249_ = _e2012;
                                        }
                                        let _e2103 = phi_3249_;
                                        if (_e2103 > _e2085) {
                                            phi_3254_ = _e2103;
                                        } else {
                                            phi_3254_ = _e2085;
                                        }
                                        let _e2106 = phi_3254_;
                                        if (_e2100 > _e2106) {
                                            phi_3259_ = _e2100;
                                        } else {
                                            phi_3259_ = _e2106;
                                        }
                                        let _e2109 = phi_3259_;
                                        let _e2111 = local.member_5;
                                        phi_3263_ = (_e2109 > _e2111);
                                    }
                                    let _e2114 = phi_3263_;
                                    phi_3265_ = !(_e2114);
                                    phi_3266_ = false;
                                } else {
                                    phi_3265_ = bool();
                                    phi_3266_ = true;
                                }
                                let _e2117 = phi_3265_;
                                let _e2119 = phi_3266_;
                                phi_3267_ = _e2117;
                                phi_3268_ = _e2119;
                            }
                            let _e2121 = phi_3267_;
                            let _e2123 = phi_3268_;
                            if _e2123 {
                                phi_3272_ = true;
                            } else {
                                phi_3272_ = _e2121;
                            }
                            let _e2125 = phi_3272_;
                            if _e2125 {
                            } else {
                                local_1[_e684.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_1005_ = _e682;
                        break if !(_e688);
                    }
                }
                let _e2128 = local_1;
                if (_e150 == 4294967295u) {
                    phi_3322_ = 0u;
                } else {
                    if (_e150 >= _e78) {
                        if (_e153 >= _e83) {
                            phi_3316_ = false;
                        } else {
                            phi_3316_ = true;
                        }
                        let _e2149 = phi_3316_;
                        phi_3317_ = _e2149;
                    } else {
                        phi_3317_ = true;
                    }
                    let _e2151 = phi_3317_;
                    if _e2151 {
                        phi_3321_ = 1u;
                    } else {
                        phi_3321_ = 2u;
                    }
                    let _e2153 = phi_3321_;
                    phi_3322_ = _e2153;
                }
                let _e2155 = phi_3322_;
                if (_e2155 == 2u) {
                    phi_3328_ = array<u32, 2>(_e150, _e153);
                } else {
                    phi_3328_ = array<u32, 2>(_e2128[0][0], _e2128[0][1]);
                }
                let _e2159 = phi_3328_;
                phi_3329_ = array<u32, 2>(_e2128[3][0], _e2128[3][1]);
                phi_3330_ = array<u32, 2>(_e2128[2][0], _e2128[2][1]);
                phi_3331_ = array<u32, 2>(_e2128[1][0], _e2128[1][1]);
                phi_3332_ = _e2159;
            } else {
                phi_3329_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3330_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3331_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3332_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2161 = phi_3329_;
            let _e2163 = phi_3330_;
            let _e2165 = phi_3331_;
            let _e2167 = phi_3332_;
            if (_e2167[0] == 4294967295u) {
                phi_3354_ = 0u;
            } else {
                if (_e2167[0] >= _e78) {
                    if (_e2167[1] >= _e83) {
                        phi_3348_ = false;
                    } else {
                        phi_3348_ = true;
                    }
                    let _e2175 = phi_3348_;
                    phi_3349_ = _e2175;
                } else {
                    phi_3349_ = true;
                }
                let _e2177 = phi_3349_;
                if _e2177 {
                    phi_3353_ = 1u;
                } else {
                    phi_3353_ = 2u;
                }
                let _e2179 = phi_3353_;
                phi_3354_ = _e2179;
            }
            let _e2181 = phi_3354_;
            if (_e2181 == 0u) {
                phi_3366_ = 0u;
            } else {
                if (_e2181 == 1u) {
                    phi_3363_ = 0u;
                } else {
                    phi_3363_ = 1u;
                }
                let _e2185 = phi_3363_;
                let _e2187 = atomicAdd((&counters[_e2185]), 1u);
                phi_3366_ = _e2187;
            }
            let _e2189 = phi_3366_;
            if (_e2165[0] == 4294967295u) {
                phi_3388_ = 0u;
            } else {
                if (_e2165[0] >= _e78) {
                    if (_e2165[1] >= _e83) {
                        phi_3382_ = false;
                    } else {
                        phi_3382_ = true;
                    }
                    let _e2197 = phi_3382_;
                    phi_3383_ = _e2197;
                } else {
                    phi_3383_ = true;
                }
                let _e2199 = phi_3383_;
                if _e2199 {
                    phi_3387_ = 1u;
                } else {
                    phi_3387_ = 2u;
                }
                let _e2201 = phi_3387_;
                phi_3388_ = _e2201;
            }
            let _e2203 = phi_3388_;
            if (_e2203 == 0u) {
                phi_3400_ = 0u;
            } else {
                if (_e2203 == 1u) {
                    phi_3397_ = 0u;
                } else {
                    phi_3397_ = 1u;
                }
                let _e2207 = phi_3397_;
                let _e2209 = atomicAdd((&counters[_e2207]), 1u);
                phi_3400_ = _e2209;
            }
            let _e2211 = phi_3400_;
            if (_e2163[0] == 4294967295u) {
                phi_3422_ = 0u;
            } else {
                if (_e2163[0] >= _e78) {
                    if (_e2163[1] >= _e83) {
                        phi_3416_ = false;
                    } else {
                        phi_3416_ = true;
                    }
                    let _e2219 = phi_3416_;
                    phi_3417_ = _e2219;
                } else {
                    phi_3417_ = true;
                }
                let _e2221 = phi_3417_;
                if _e2221 {
                    phi_3421_ = 1u;
                } else {
                    phi_3421_ = 2u;
                }
                let _e2223 = phi_3421_;
                phi_3422_ = _e2223;
            }
            let _e2225 = phi_3422_;
            if (_e2225 == 0u) {
                phi_3434_ = 0u;
            } else {
                if (_e2225 == 1u) {
                    phi_3431_ = 0u;
                } else {
                    phi_3431_ = 1u;
                }
                let _e2229 = phi_3431_;
                let _e2231 = atomicAdd((&counters[_e2229]), 1u);
                phi_3434_ = _e2231;
            }
            let _e2233 = phi_3434_;
            if (_e2161[0] == 4294967295u) {
                phi_3456_ = 0u;
            } else {
                if (_e2161[0] >= _e78) {
                    if (_e2161[1] >= _e83) {
                        phi_3450_ = false;
                    } else {
                        phi_3450_ = true;
                    }
                    let _e2241 = phi_3450_;
                    phi_3451_ = _e2241;
                } else {
                    phi_3451_ = true;
                }
                let _e2243 = phi_3451_;
                if _e2243 {
                    phi_3455_ = 1u;
                } else {
                    phi_3455_ = 2u;
                }
                let _e2245 = phi_3455_;
                phi_3456_ = _e2245;
            }
            let _e2247 = phi_3456_;
            if (_e2247 == 0u) {
                phi_3468_ = 0u;
            } else {
                if (_e2247 == 1u) {
                    phi_3465_ = 0u;
                } else {
                    phi_3465_ = 1u;
                }
                let _e2251 = phi_3465_;
                let _e2253 = atomicAdd((&counters[_e2251]), 1u);
                phi_3468_ = _e2253;
            }
            let _e2255 = phi_3468_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e2258 = atomicLoad((&counters[0u]));
                let _e2260 = atomicLoad((&counters[1u]));
                if (_e2258 > 0u) {
                    let _e2264 = atomicAdd((&levels.member[(_e68 + 1u)]), _e2258);
                    let _e2267 = atomicMax((&output.member[0u]), (_e2264 + _e2258));
                    if ((_e2264 + _e2258) < _e2264) {
                        let _e2271 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2264);
                }
                if (_e2260 > 0u) {
                    let _e2275 = atomicAdd((&pairs.member[0u]), _e2260);
                    if ((_e2275 + _e2260) < _e2275) {
                        let _e2279 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2275);
                }
            }
            workgroupBarrier();
            let _e2282 = atomicLoad((&counters[2u]));
            let _e2284 = atomicLoad((&counters[3u]));
            if (_e2167[0] == 4294967295u) {
                phi_3540_ = 0u;
            } else {
                if (_e2167[0] >= _e78) {
                    if (_e2167[1] >= _e83) {
                        phi_3534_ = false;
                    } else {
                        phi_3534_ = true;
                    }
                    let _e2292 = phi_3534_;
                    phi_3535_ = _e2292;
                } else {
                    phi_3535_ = true;
                }
                let _e2294 = phi_3535_;
                if _e2294 {
                    phi_3539_ = 1u;
                } else {
                    phi_3539_ = 2u;
                }
                let _e2296 = phi_3539_;
                phi_3540_ = _e2296;
            }
            let _e2298 = phi_3540_;
            if (_e2298 == 1u) {
                let _e2337 = params.member.member_2.member_3;
                let _e2338 = (_e2282 + _e2189);
                if (_e2338 < _e2337) {
                    let _e2340 = (2u * _e2338);
                    atomicStore((&output.member[(4u + _e2340)]), _e2167[0]);
                    atomicStore((&output.member[(_e2340 + 5u)]), _e2167[1]);
                }
            } else {
                if (_e2298 == 2u) {
                    let _e2303 = a_nodes.member[_e2167[0]];
                    let _e2307 = b_nodes.member[_e2167[1]];
                    let _e2311 = params.member.member_2.member;
                    if (_e2311 == 1u) {
                        if (_e2303.member_1 < _e2307.member_1) {
                            phi_3603_ = type_12(_e2303.member_1, _e2307.member_1);
                        } else {
                            phi_3603_ = type_12(_e2307.member_1, _e2303.member_1);
                        }
                        let _e2318 = phi_3603_;
                        phi_3608_ = _e2318;
                    } else {
                        phi_3608_ = type_12(_e2303.member_1, _e2307.member_1);
                    }
                    let _e2320 = phi_3608_;
                    let _e2323 = params.member.member_1.member_3;
                    let _e2324 = (_e2284 + _e2189);
                    if (_e2324 < _e2323) {
                        let _e2328 = (2u * _e2324);
                        atomicStore((&pairs.member[(4u + _e2328)]), _e2320.member);
                        atomicStore((&pairs.member[(_e2328 + 5u)]), _e2320.member_1);
                    }
                }
            }
            if (_e2165[0] == 4294967295u) {
                phi_3647_ = 0u;
            } else {
                if (_e2165[0] >= _e78) {
                    if (_e2165[1] >= _e83) {
                        phi_3641_ = false;
                    } else {
                        phi_3641_ = true;
                    }
                    let _e2352 = phi_3641_;
                    phi_3642_ = _e2352;
                } else {
                    phi_3642_ = true;
                }
                let _e2354 = phi_3642_;
                if _e2354 {
                    phi_3646_ = 1u;
                } else {
                    phi_3646_ = 2u;
                }
                let _e2356 = phi_3646_;
                phi_3647_ = _e2356;
            }
            let _e2358 = phi_3647_;
            if (_e2358 == 1u) {
                let _e2397 = params.member.member_2.member_3;
                let _e2398 = (_e2282 + _e2211);
                if (_e2398 < _e2397) {
                    let _e2400 = (2u * _e2398);
                    atomicStore((&output.member[(4u + _e2400)]), _e2165[0]);
                    atomicStore((&output.member[(_e2400 + 5u)]), _e2165[1]);
                }
            } else {
                if (_e2358 == 2u) {
                    let _e2363 = a_nodes.member[_e2165[0]];
                    let _e2367 = b_nodes.member[_e2165[1]];
                    let _e2371 = params.member.member_2.member;
                    if (_e2371 == 1u) {
                        if (_e2363.member_1 < _e2367.member_1) {
                            phi_3710_ = type_12(_e2363.member_1, _e2367.member_1);
                        } else {
                            phi_3710_ = type_12(_e2367.member_1, _e2363.member_1);
                        }
                        let _e2378 = phi_3710_;
                        phi_3715_ = _e2378;
                    } else {
                        phi_3715_ = type_12(_e2363.member_1, _e2367.member_1);
                    }
                    let _e2380 = phi_3715_;
                    let _e2383 = params.member.member_1.member_3;
                    let _e2384 = (_e2284 + _e2211);
                    if (_e2384 < _e2383) {
                        let _e2388 = (2u * _e2384);
                        atomicStore((&pairs.member[(4u + _e2388)]), _e2380.member);
                        atomicStore((&pairs.member[(_e2388 + 5u)]), _e2380.member_1);
                    }
                }
            }
            if (_e2163[0] == 4294967295u) {
                phi_3754_ = 0u;
            } else {
                if (_e2163[0] >= _e78) {
                    if (_e2163[1] >= _e83) {
                        phi_3748_ = false;
                    } else {
                        phi_3748_ = true;
                    }
                    let _e2412 = phi_3748_;
                    phi_3749_ = _e2412;
                } else {
                    phi_3749_ = true;
                }
                let _e2414 = phi_3749_;
                if _e2414 {
                    phi_3753_ = 1u;
                } else {
                    phi_3753_ = 2u;
                }
                let _e2416 = phi_3753_;
                phi_3754_ = _e2416;
            }
            let _e2418 = phi_3754_;
            if (_e2418 == 1u) {
                let _e2457 = params.member.member_2.member_3;
                let _e2458 = (_e2282 + _e2233);
                if (_e2458 < _e2457) {
                    let _e2460 = (2u * _e2458);
                    atomicStore((&output.member[(4u + _e2460)]), _e2163[0]);
                    atomicStore((&output.member[(_e2460 + 5u)]), _e2163[1]);
                }
            } else {
                if (_e2418 == 2u) {
                    let _e2423 = a_nodes.member[_e2163[0]];
                    let _e2427 = b_nodes.member[_e2163[1]];
                    let _e2431 = params.member.member_2.member;
                    if (_e2431 == 1u) {
                        if (_e2423.member_1 < _e2427.member_1) {
                            phi_3817_ = type_12(_e2423.member_1, _e2427.member_1);
                        } else {
                            phi_3817_ = type_12(_e2427.member_1, _e2423.member_1);
                        }
                        let _e2438 = phi_3817_;
                        phi_3822_ = _e2438;
                    } else {
                        phi_3822_ = type_12(_e2423.member_1, _e2427.member_1);
                    }
                    let _e2440 = phi_3822_;
                    let _e2443 = params.member.member_1.member_3;
                    let _e2444 = (_e2284 + _e2233);
                    if (_e2444 < _e2443) {
                        let _e2448 = (2u * _e2444);
                        atomicStore((&pairs.member[(4u + _e2448)]), _e2440.member);
                        atomicStore((&pairs.member[(_e2448 + 5u)]), _e2440.member_1);
                    }
                }
            }
            if (_e2161[0] == 4294967295u) {
                phi_3861_ = 0u;
            } else {
                if (_e2161[0] >= _e78) {
                    if (_e2161[1] >= _e83) {
                        phi_3855_ = false;
                    } else {
                        phi_3855_ = true;
                    }
                    let _e2472 = phi_3855_;
                    phi_3856_ = _e2472;
                } else {
                    phi_3856_ = true;
                }
                let _e2474 = phi_3856_;
                if _e2474 {
                    phi_3860_ = 1u;
                } else {
                    phi_3860_ = 2u;
                }
                let _e2476 = phi_3860_;
                phi_3861_ = _e2476;
            }
            let _e2478 = phi_3861_;
            if (_e2478 == 1u) {
                let _e2517 = params.member.member_2.member_3;
                let _e2518 = (_e2282 + _e2255);
                if (_e2518 < _e2517) {
                    let _e2520 = (2u * _e2518);
                    atomicStore((&output.member[(4u + _e2520)]), _e2161[0]);
                    atomicStore((&output.member[(_e2520 + 5u)]), _e2161[1]);
                }
            } else {
                if (_e2478 == 2u) {
                    let _e2483 = a_nodes.member[_e2161[0]];
                    let _e2487 = b_nodes.member[_e2161[1]];
                    let _e2491 = params.member.member_2.member;
                    if (_e2491 == 1u) {
                        if (_e2483.member_1 < _e2487.member_1) {
                            phi_3924_ = type_12(_e2483.member_1, _e2487.member_1);
                        } else {
                            phi_3924_ = type_12(_e2487.member_1, _e2483.member_1);
                        }
                        let _e2498 = phi_3924_;
                        phi_3929_ = _e2498;
                    } else {
                        phi_3929_ = type_12(_e2483.member_1, _e2487.member_1);
                    }
                    let _e2500 = phi_3929_;
                    let _e2503 = params.member.member_1.member_3;
                    let _e2504 = (_e2284 + _e2255);
                    if (_e2504 < _e2503) {
                        let _e2508 = (2u * _e2504);
                        atomicStore((&pairs.member[(4u + _e2508)]), _e2500.member);
                        atomicStore((&pairs.member[(_e2508 + 5u)]), _e2500.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_226_ = _e132;
            break if !(_e138);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
