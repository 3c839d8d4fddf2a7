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
var<storage> input: type_11;
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
    var phi_226_: type_9;
    var phi_227_: type_9;
    var phi_250_: type_9;
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
    var phi_1005_: type_9;
    var phi_1006_: type_9;
    var phi_1029_: type_9;
    var phi_1058_: bool;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1156_: f32;
    var phi_1161_: f32;
    var phi_1166_: f32;
    var phi_1182_: type_28;
    var phi_1264_: f32;
    var phi_1269_: f32;
    var phi_1274_: f32;
    var phi_1290_: type_28;
    var phi_1480_: f32;
    var phi_1486_: f32;
    var phi_1493_: f32;
    var phi_1502_: f32;
    var phi_1509_: f32;
    var phi_1517_: f32;
    var phi_1526_: f32;
    var phi_1533_: f32;
    var phi_1541_: f32;
    var phi_1634_: f32;
    var phi_1641_: f32;
    var phi_1647_: f32;
    var phi_1653_: f32;
    var phi_1672_: f32;
    var phi_1679_: f32;
    var phi_1685_: f32;
    var phi_1691_: f32;
    var phi_1710_: f32;
    var phi_1717_: f32;
    var phi_1723_: f32;
    var phi_1729_: f32;
    var phi_1748_: f32;
    var phi_1755_: f32;
    var phi_1761_: f32;
    var phi_1767_: f32;
    var phi_1786_: f32;
    var phi_1793_: f32;
    var phi_1799_: f32;
    var phi_1805_: f32;
    var phi_1824_: f32;
    var phi_1831_: f32;
    var phi_1837_: f32;
    var phi_1843_: f32;
    var phi_1858_: f32;
    var phi_1863_: f32;
    var phi_1868_: f32;
    var phi_1873_: f32;
    var phi_1878_: f32;
    var phi_1937_: f32;
    var phi_1960_: f32;
    var phi_1983_: f32;
    var phi_2005_: f32;
    var phi_2021_: f32;
    var phi_2076_: f32;
    var phi_2099_: f32;
    var phi_2122_: f32;
    var phi_2144_: f32;
    var phi_2160_: f32;
    var phi_2215_: f32;
    var phi_2238_: f32;
    var phi_2261_: f32;
    var phi_2283_: f32;
    var phi_2299_: f32;
    var phi_2354_: f32;
    var phi_2377_: f32;
    var phi_2401_: f32;
    var phi_2424_: f32;
    var phi_2440_: f32;
    var phi_2495_: f32;
    var phi_2518_: f32;
    var phi_2542_: f32;
    var phi_2565_: f32;
    var phi_2581_: f32;
    var phi_2636_: f32;
    var phi_2659_: f32;
    var phi_2683_: f32;
    var phi_2706_: f32;
    var phi_2722_: f32;
    var phi_2777_: f32;
    var phi_2800_: f32;
    var phi_2824_: f32;
    var phi_2847_: f32;
    var phi_2863_: f32;
    var phi_2918_: f32;
    var phi_2941_: f32;
    var phi_2965_: f32;
    var phi_2988_: f32;
    var phi_3004_: f32;
    var phi_3059_: f32;
    var phi_3082_: f32;
    var phi_3106_: f32;
    var phi_3129_: f32;
    var phi_3145_: f32;
    var phi_3152_: f32;
    var phi_3157_: f32;
    var phi_3162_: f32;
    var phi_3167_: f32;
    var phi_3172_: f32;
    var phi_3177_: f32;
    var phi_3182_: f32;
    var phi_3187_: f32;
    var phi_3191_: bool;
    var phi_3193_: bool;
    var phi_3194_: bool;
    var phi_3195_: bool;
    var phi_3196_: bool;
    var phi_3200_: bool;
    var phi_3244_: bool;
    var phi_3245_: bool;
    var phi_3249_: u32;
    var phi_3250_: u32;
    var phi_3256_: array<u32, 2>;
    var phi_3257_: array<u32, 2>;
    var phi_3258_: array<u32, 2>;
    var phi_3259_: array<u32, 2>;
    var phi_3260_: array<u32, 2>;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3281_: u32;
    var phi_3282_: u32;
    var phi_3291_: u32;
    var phi_3294_: u32;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3315_: u32;
    var phi_3316_: u32;
    var phi_3325_: u32;
    var phi_3328_: u32;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3349_: u32;
    var phi_3350_: u32;
    var phi_3359_: u32;
    var phi_3362_: u32;
    var phi_3378_: bool;
    var phi_3379_: bool;
    var phi_3383_: u32;
    var phi_3384_: u32;
    var phi_3393_: u32;
    var phi_3396_: u32;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3467_: u32;
    var phi_3468_: u32;
    var phi_3531_: type_9;
    var phi_3536_: type_9;
    var phi_3569_: bool;
    var phi_3570_: bool;
    var phi_3574_: u32;
    var phi_3575_: u32;
    var phi_3638_: type_9;
    var phi_3643_: type_9;
    var phi_3676_: bool;
    var phi_3677_: bool;
    var phi_3681_: u32;
    var phi_3682_: u32;
    var phi_3745_: type_9;
    var phi_3750_: type_9;
    var phi_3783_: bool;
    var phi_3784_: bool;
    var phi_3788_: u32;
    var phi_3789_: u32;
    var phi_3852_: type_9;
    var phi_3857_: type_9;
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
    phi_226_ = type_9(0u, _e117);
    loop {
        let _e120 = phi_226_;
        if (_e120.member < _e120.member_1) {
            phi_227_ = type_9((_e120.member + 1u), _e120.member_1);
            phi_250_ = type_9(1u, _e120.member);
        } else {
            phi_227_ = _e120;
            phi_250_ = type_9(0u, type_9().member_1);
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
                phi_1005_ = type_9(0u, 4u);
                loop {
                    let _e670 = phi_1005_;
                    if (_e670.member < _e670.member_1) {
                        phi_1006_ = type_9((_e670.member + 1u), _e670.member_1);
                        phi_1029_ = type_9(1u, _e670.member);
                    } else {
                        phi_1006_ = _e670;
                        phi_1029_ = type_9(0u, type_9().member_1);
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
                                phi_3195_ = bool();
                                phi_3196_ = true;
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
                                        let _e758 = oriented.member[(_e87 + _e690[0])];
                                        phi_1182_ = type_28(array<f32, 3>(_e758.member.x, _e758.member.y, _e758.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e758.member.w, _e758.member_1.x, _e758.member_1.y), array<f32, 3>(_e758.member_1.z, _e758.member_1.w, _e758.member_2.x), array<f32, 3>(_e758.member_2.y, _e758.member_2.z, _e758.member_2.w)), array<f32, 3>(_e758.member_3.x, _e758.member_3.y, _e758.member_3.z));
                                    } else {
                                        let _e705 = a_nodes.member[_e690[0]];
                                        let _e720 = ((_e705.member[0] * 0.5f) + (_e705.member_2[0] * 0.5f));
                                        let _e721 = ((_e705.member[1] * 0.5f) + (_e705.member_2[1] * 0.5f));
                                        let _e722 = ((_e705.member[2] * 0.5f) + (_e705.member_2[2] * 0.5f));
                                        let _e725 = (_e705.member_2[0] - _e720);
                                        let _e727 = (_e705.member_2[1] - _e721);
                                        let _e729 = (_e705.member_2[2] - _e722);
                                        let _e731 = (_e720 - _e705.member[0]);
                                        let _e733 = (_e721 - _e705.member[1]);
                                        let _e735 = (_e722 - _e705.member[2]);
                                        if (_e725 > _e731) {
                                            phi_1156_ = _e725;
                                        } else {
                                            phi_1156_ = _e731;
                                        }
                                        let _e738 = phi_1156_;
                                        if (_e727 > _e733) {
                                            phi_1161_ = _e727;
                                        } else {
                                            phi_1161_ = _e733;
                                        }
                                        let _e741 = phi_1161_;
                                        if (_e729 > _e735) {
                                            phi_1166_ = _e729;
                                        } else {
                                            phi_1166_ = _e735;
                                        }
                                        let _e744 = phi_1166_;
                                        let _e746 = (1f + (0.000000059604645f * 4f));
                                        let _e750 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1182_ = type_28(array<f32, 3>(_e720, _e721, _e722), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e738 * _e746) + _e750), ((_e741 * _e746) + _e750), ((_e744 * _e746) + _e750)));
                                    }
                                    let _e797 = phi_1182_;
                                    if (_e690[1] < _e83) {
                                        let _e853 = oriented.member[(_e91 + _e690[1])];
                                        phi_1290_ = type_28(array<f32, 3>(_e853.member.x, _e853.member.y, _e853.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e853.member.w, _e853.member_1.x, _e853.member_1.y), array<f32, 3>(_e853.member_1.z, _e853.member_1.w, _e853.member_2.x), array<f32, 3>(_e853.member_2.y, _e853.member_2.z, _e853.member_2.w)), array<f32, 3>(_e853.member_3.x, _e853.member_3.y, _e853.member_3.z));
                                    } else {
                                        let _e800 = b_nodes.member[_e690[1]];
                                        let _e815 = ((_e800.member[0] * 0.5f) + (_e800.member_2[0] * 0.5f));
                                        let _e816 = ((_e800.member[1] * 0.5f) + (_e800.member_2[1] * 0.5f));
                                        let _e817 = ((_e800.member[2] * 0.5f) + (_e800.member_2[2] * 0.5f));
                                        let _e820 = (_e800.member_2[0] - _e815);
                                        let _e822 = (_e800.member_2[1] - _e816);
                                        let _e824 = (_e800.member_2[2] - _e817);
                                        let _e826 = (_e815 - _e800.member[0]);
                                        let _e828 = (_e816 - _e800.member[1]);
                                        let _e830 = (_e817 - _e800.member[2]);
                                        if (_e820 > _e826) {
                                            phi_1264_ = _e820;
                                        } else {
                                            phi_1264_ = _e826;
                                        }
                                        let _e833 = phi_1264_;
                                        if (_e822 > _e828) {
                                            phi_1269_ = _e822;
                                        } else {
                                            phi_1269_ = _e828;
                                        }
                                        let _e836 = phi_1269_;
                                        if (_e824 > _e830) {
                                            phi_1274_ = _e824;
                                        } else {
                                            phi_1274_ = _e830;
                                        }
                                        let _e839 = phi_1274_;
                                        let _e841 = (1f + (0.000000059604645f * 4f));
                                        let _e845 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1290_ = type_28(array<f32, 3>(_e815, _e816, _e817), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e833 * _e841) + _e845), ((_e836 * _e841) + _e845), ((_e839 * _e841) + _e845)));
                                    }
                                    let _e892 = phi_1290_;
                                    let _e897 = (_e892.member[0] - _e797.member[0]);
                                    let _e900 = (_e892.member[1] - _e797.member[1]);
                                    let _e903 = (_e892.member[2] - _e797.member[2]);
                                    if (_e897 < 0f) {
                                        phi_1480_ = -(_e897);
                                    } else {
                                        phi_1480_ = _e897;
                                    }
                                    let _e1092 = phi_1480_;
                                    if (_e900 < 0f) {
                                        phi_1486_ = -(_e900);
                                    } else {
                                        phi_1486_ = _e900;
                                    }
                                    let _e1096 = phi_1486_;
                                    if (_e903 < 0f) {
                                        phi_1493_ = -(_e903);
                                    } else {
                                        phi_1493_ = _e903;
                                    }
                                    let _e1101 = phi_1493_;
                                    if (_e797.member_2[0] < 0f) {
                                        phi_1502_ = -(_e797.member_2[0]);
                                    } else {
                                        phi_1502_ = _e797.member_2[0];
                                    }
                                    let _e1108 = phi_1502_;
                                    if (_e797.member_2[1] < 0f) {
                                        phi_1509_ = -(_e797.member_2[1]);
                                    } else {
                                        phi_1509_ = _e797.member_2[1];
                                    }
                                    let _e1113 = phi_1509_;
                                    if (_e797.member_2[2] < 0f) {
                                        phi_1517_ = -(_e797.member_2[2]);
                                    } else {
                                        phi_1517_ = _e797.member_2[2];
                                    }
                                    let _e1119 = phi_1517_;
                                    if (_e892.member_2[0] < 0f) {
                                        phi_1526_ = -(_e892.member_2[0]);
                                    } else {
                                        phi_1526_ = _e892.member_2[0];
                                    }
                                    let _e1126 = phi_1526_;
                                    if (_e892.member_2[1] < 0f) {
                                        phi_1533_ = -(_e892.member_2[1]);
                                    } else {
                                        phi_1533_ = _e892.member_2[1];
                                    }
                                    let _e1131 = phi_1533_;
                                    if (_e892.member_2[2] < 0f) {
                                        phi_1541_ = -(_e892.member_2[2]);
                                    } else {
                                        phi_1541_ = _e892.member_2[2];
                                    }
                                    let _e1137 = phi_1541_;
                                    local = type_23(array<array<f32, 3>, 3>(array<f32, 3>((((_e892.member_1[0][0] * _e797.member_1[0][0]) + (_e892.member_1[0][1] * _e797.member_1[0][1])) + (_e892.member_1[0][2] * _e797.member_1[0][2])), (((_e892.member_1[1][0] * _e797.member_1[0][0]) + (_e892.member_1[1][1] * _e797.member_1[0][1])) + (_e892.member_1[1][2] * _e797.member_1[0][2])), (((_e892.member_1[2][0] * _e797.member_1[0][0]) + (_e892.member_1[2][1] * _e797.member_1[0][1])) + (_e892.member_1[2][2] * _e797.member_1[0][2]))), array<f32, 3>((((_e892.member_1[0][0] * _e797.member_1[1][0]) + (_e892.member_1[0][1] * _e797.member_1[1][1])) + (_e892.member_1[0][2] * _e797.member_1[1][2])), (((_e892.member_1[1][0] * _e797.member_1[1][0]) + (_e892.member_1[1][1] * _e797.member_1[1][1])) + (_e892.member_1[1][2] * _e797.member_1[1][2])), (((_e892.member_1[2][0] * _e797.member_1[1][0]) + (_e892.member_1[2][1] * _e797.member_1[1][1])) + (_e892.member_1[2][2] * _e797.member_1[1][2]))), array<f32, 3>((((_e892.member_1[0][0] * _e797.member_1[2][0]) + (_e892.member_1[0][1] * _e797.member_1[2][1])) + (_e892.member_1[0][2] * _e797.member_1[2][2])), (((_e892.member_1[1][0] * _e797.member_1[2][0]) + (_e892.member_1[1][1] * _e797.member_1[2][1])) + (_e892.member_1[1][2] * _e797.member_1[2][2])), (((_e892.member_1[2][0] * _e797.member_1[2][0]) + (_e892.member_1[2][1] * _e797.member_1[2][1])) + (_e892.member_1[2][2] * _e797.member_1[2][2])))), array<f32, 3>((((_e797.member_1[0][0] * _e897) + (_e797.member_1[0][1] * _e900)) + (_e797.member_1[0][2] * _e903)), (((_e797.member_1[1][0] * _e897) + (_e797.member_1[1][1] * _e900)) + (_e797.member_1[1][2] * _e903)), (((_e797.member_1[2][0] * _e897) + (_e797.member_1[2][1] * _e900)) + (_e797.member_1[2][2] * _e903))), array<f32, 3>((((_e892.member_1[0][0] * _e897) + (_e892.member_1[0][1] * _e900)) + (_e892.member_1[0][2] * _e903)), (((_e892.member_1[1][0] * _e897) + (_e892.member_1[1][1] * _e900)) + (_e892.member_1[1][2] * _e903)), (((_e892.member_1[2][0] * _e897) + (_e892.member_1[2][1] * _e900)) + (_e892.member_1[2][2] * _e903))), array<f32, 3>(_e797.member_2[0], _e797.member_2[1], _e797.member_2[2]), array<f32, 3>(_e892.member_2[0], _e892.member_2[1], _e892.member_2[2]), ((((((_e1092 + _e1096) + _e1101) + (((_e1108 + _e1113) + _e1119) + ((_e1126 + _e1131) + _e1137))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1164 = local.member[0u][0u];
                                    let _e1168 = local.member[0u][1u];
                                    let _e1172 = local.member[0u][2u];
                                    let _e1176 = local.member[1u][0u];
                                    let _e1180 = local.member[1u][1u];
                                    let _e1184 = local.member[1u][2u];
                                    let _e1188 = local.member[2u][0u];
                                    let _e1192 = local.member[2u][1u];
                                    let _e1196 = local.member[2u][2u];
                                    let _e1198 = local.member_3;
                                    let _e1203 = local.member_4;
                                    let _e1209 = local.member_1[0u];
                                    if (_e1209 < 0f) {
                                        phi_1634_ = -(_e1209);
                                    } else {
                                        phi_1634_ = _e1209;
                                    }
                                    let _e1213 = phi_1634_;
                                    if (_e1164 < 0f) {
                                        phi_1641_ = -(_e1164);
                                    } else {
                                        phi_1641_ = _e1164;
                                    }
                                    let _e1217 = phi_1641_;
                                    if (_e1168 < 0f) {
                                        phi_1647_ = -(_e1168);
                                    } else {
                                        phi_1647_ = _e1168;
                                    }
                                    let _e1221 = phi_1647_;
                                    if (_e1172 < 0f) {
                                        phi_1653_ = -(_e1172);
                                    } else {
                                        phi_1653_ = _e1172;
                                    }
                                    let _e1225 = phi_1653_;
                                    let _e1232 = (_e1213 - (_e1198[0] + (((_e1217 * _e1203[0]) + (_e1221 * _e1203[1])) + (_e1225 * _e1203[2]))));
                                    let _e1235 = local.member_1[1u];
                                    if (_e1235 < 0f) {
                                        phi_1672_ = -(_e1235);
                                    } else {
                                        phi_1672_ = _e1235;
                                    }
                                    let _e1239 = phi_1672_;
                                    if (_e1176 < 0f) {
                                        phi_1679_ = -(_e1176);
                                    } else {
                                        phi_1679_ = _e1176;
                                    }
                                    let _e1243 = phi_1679_;
                                    if (_e1180 < 0f) {
                                        phi_1685_ = -(_e1180);
                                    } else {
                                        phi_1685_ = _e1180;
                                    }
                                    let _e1247 = phi_1685_;
                                    if (_e1184 < 0f) {
                                        phi_1691_ = -(_e1184);
                                    } else {
                                        phi_1691_ = _e1184;
                                    }
                                    let _e1251 = phi_1691_;
                                    let _e1258 = (_e1239 - (_e1198[1] + (((_e1243 * _e1203[0]) + (_e1247 * _e1203[1])) + (_e1251 * _e1203[2]))));
                                    let _e1261 = local.member_1[2u];
                                    if (_e1261 < 0f) {
                                        phi_1710_ = -(_e1261);
                                    } else {
                                        phi_1710_ = _e1261;
                                    }
                                    let _e1265 = phi_1710_;
                                    if (_e1188 < 0f) {
                                        phi_1717_ = -(_e1188);
                                    } else {
                                        phi_1717_ = _e1188;
                                    }
                                    let _e1269 = phi_1717_;
                                    if (_e1192 < 0f) {
                                        phi_1723_ = -(_e1192);
                                    } else {
                                        phi_1723_ = _e1192;
                                    }
                                    let _e1273 = phi_1723_;
                                    if (_e1196 < 0f) {
                                        phi_1729_ = -(_e1196);
                                    } else {
                                        phi_1729_ = _e1196;
                                    }
                                    let _e1277 = phi_1729_;
                                    let _e1284 = (_e1265 - (_e1198[2] + (((_e1269 * _e1203[0]) + (_e1273 * _e1203[1])) + (_e1277 * _e1203[2]))));
                                    let _e1287 = local.member_2[0u];
                                    if (_e1287 < 0f) {
                                        phi_1748_ = -(_e1287);
                                    } else {
                                        phi_1748_ = _e1287;
                                    }
                                    let _e1291 = phi_1748_;
                                    if (_e1164 < 0f) {
                                        phi_1755_ = -(_e1164);
                                    } else {
                                        phi_1755_ = _e1164;
                                    }
                                    let _e1295 = phi_1755_;
                                    if (_e1176 < 0f) {
                                        phi_1761_ = -(_e1176);
                                    } else {
                                        phi_1761_ = _e1176;
                                    }
                                    let _e1299 = phi_1761_;
                                    if (_e1188 < 0f) {
                                        phi_1767_ = -(_e1188);
                                    } else {
                                        phi_1767_ = _e1188;
                                    }
                                    let _e1303 = phi_1767_;
                                    let _e1310 = (_e1291 - (_e1203[0] + (((_e1295 * _e1198[0]) + (_e1299 * _e1198[1])) + (_e1303 * _e1198[2]))));
                                    let _e1313 = local.member_2[1u];
                                    if (_e1313 < 0f) {
                                        phi_1786_ = -(_e1313);
                                    } else {
                                        phi_1786_ = _e1313;
                                    }
                                    let _e1317 = phi_1786_;
                                    if (_e1168 < 0f) {
                                        phi_1793_ = -(_e1168);
                                    } else {
                                        phi_1793_ = _e1168;
                                    }
                                    let _e1321 = phi_1793_;
                                    if (_e1180 < 0f) {
                                        phi_1799_ = -(_e1180);
                                    } else {
                                        phi_1799_ = _e1180;
                                    }
                                    let _e1325 = phi_1799_;
                                    if (_e1192 < 0f) {
                                        phi_1805_ = -(_e1192);
                                    } else {
                                        phi_1805_ = _e1192;
                                    }
                                    let _e1329 = phi_1805_;
                                    let _e1336 = (_e1317 - (_e1203[1] + (((_e1321 * _e1198[0]) + (_e1325 * _e1198[1])) + (_e1329 * _e1198[2]))));
                                    let _e1339 = local.member_2[2u];
                                    if (_e1339 < 0f) {
                                        phi_1824_ = -(_e1339);
                                    } else {
                                        phi_1824_ = _e1339;
                                    }
                                    let _e1343 = phi_1824_;
                                    if (_e1172 < 0f) {
                                        phi_1831_ = -(_e1172);
                                    } else {
                                        phi_1831_ = _e1172;
                                    }
                                    let _e1347 = phi_1831_;
                                    if (_e1184 < 0f) {
                                        phi_1837_ = -(_e1184);
                                    } else {
                                        phi_1837_ = _e1184;
                                    }
                                    let _e1351 = phi_1837_;
                                    if (_e1196 < 0f) {
                                        phi_1843_ = -(_e1196);
                                    } else {
                                        phi_1843_ = _e1196;
                                    }
                                    let _e1355 = phi_1843_;
                                    let _e1362 = (_e1343 - (_e1203[2] + (((_e1347 * _e1198[0]) + (_e1351 * _e1198[1])) + (_e1355 * _e1198[2]))));
                                    if (_e1232 > _e1258) {
                                        phi_1858_ = _e1232;
                                    } else {
                                        phi_1858_ = _e1258;
                                    }
                                    let _e1365 = phi_1858_;
                                    if (_e1365 > _e1284) {
                                        phi_1863_ = _e1365;
                                    } else {
                                        phi_1863_ = _e1284;
                                    }
                                    let _e1368 = phi_1863_;
                                    if (_e1310 > _e1336) {
                                        phi_1868_ = _e1310;
                                    } else {
                                        phi_1868_ = _e1336;
                                    }
                                    let _e1371 = phi_1868_;
                                    if (_e1371 > _e1362) {
                                        phi_1873_ = _e1371;
                                    } else {
                                        phi_1873_ = _e1362;
                                    }
                                    let _e1374 = phi_1873_;
                                    if (_e1368 > _e1374) {
                                        phi_1878_ = _e1368;
                                    } else {
                                        phi_1878_ = _e1374;
                                    }
                                    let _e1377 = phi_1878_;
                                    let _e1379 = local.member_5;
                                    if (_e1377 > _e1379) {
                                        phi_3191_ = true;
                                    } else {
                                        let _e1384 = local.member[1u][0u];
                                        let _e1387 = local.member_1[2u];
                                        let _e1392 = local.member[2u][0u];
                                        let _e1395 = local.member_1[1u];
                                        let _e1397 = ((_e1384 * _e1387) - (_e1392 * _e1395));
                                        let _e1401 = local.member[2u][0u];
                                        if (_e1401 < 0f) {
                                            phi_1937_ = -(_e1401);
                                        } else {
                                            phi_1937_ = _e1401;
                                        }
                                        let _e1405 = phi_1937_;
                                        let _e1408 = local.member_3[1u];
                                        let _e1413 = local.member[1u][0u];
                                        if (_e1413 < 0f) {
                                            phi_1960_ = -(_e1413);
                                        } else {
                                            phi_1960_ = _e1413;
                                        }
                                        let _e1417 = phi_1960_;
                                        let _e1420 = local.member_3[2u];
                                        let _e1426 = local.member[0u][2u];
                                        if (_e1426 < 0f) {
                                            phi_1983_ = -(_e1426);
                                        } else {
                                            phi_1983_ = _e1426;
                                        }
                                        let _e1430 = phi_1983_;
                                        let _e1433 = local.member_4[1u];
                                        let _e1438 = local.member[0u][1u];
                                        if (_e1438 < 0f) {
                                            phi_2005_ = -(_e1438);
                                        } else {
                                            phi_2005_ = _e1438;
                                        }
                                        let _e1442 = phi_2005_;
                                        let _e1445 = local.member_4[2u];
                                        if (_e1397 < 0f) {
                                            phi_2021_ = -(_e1397);
                                        } else {
                                            phi_2021_ = _e1397;
                                        }
                                        let _e1451 = phi_2021_;
                                        let _e1453 = (_e1451 - (((_e1405 * _e1408) + (_e1417 * _e1420)) + ((_e1430 * _e1433) + (_e1442 * _e1445))));
                                        let _e1457 = local.member[1u][1u];
                                        let _e1460 = local.member_1[2u];
                                        let _e1465 = local.member[2u][1u];
                                        let _e1468 = local.member_1[1u];
                                        let _e1470 = ((_e1457 * _e1460) - (_e1465 * _e1468));
                                        let _e1474 = local.member[2u][1u];
                                        if (_e1474 < 0f) {
                                            phi_2076_ = -(_e1474);
                                        } else {
                                            phi_2076_ = _e1474;
                                        }
                                        let _e1478 = phi_2076_;
                                        let _e1481 = local.member_3[1u];
                                        let _e1486 = local.member[1u][1u];
                                        if (_e1486 < 0f) {
                                            phi_2099_ = -(_e1486);
                                        } else {
                                            phi_2099_ = _e1486;
                                        }
                                        let _e1490 = phi_2099_;
                                        let _e1493 = local.member_3[2u];
                                        let _e1499 = local.member[0u][0u];
                                        if (_e1499 < 0f) {
                                            phi_2122_ = -(_e1499);
                                        } else {
                                            phi_2122_ = _e1499;
                                        }
                                        let _e1503 = phi_2122_;
                                        let _e1506 = local.member_4[2u];
                                        let _e1511 = local.member[0u][2u];
                                        if (_e1511 < 0f) {
                                            phi_2144_ = -(_e1511);
                                        } else {
                                            phi_2144_ = _e1511;
                                        }
                                        let _e1515 = phi_2144_;
                                        let _e1518 = local.member_4[0u];
                                        if (_e1470 < 0f) {
                                            phi_2160_ = -(_e1470);
                                        } else {
                                            phi_2160_ = _e1470;
                                        }
                                        let _e1524 = phi_2160_;
                                        let _e1526 = (_e1524 - (((_e1478 * _e1481) + (_e1490 * _e1493)) + ((_e1503 * _e1506) + (_e1515 * _e1518))));
                                        let _e1530 = local.member[1u][2u];
                                        let _e1533 = local.member_1[2u];
                                        let _e1538 = local.member[2u][2u];
                                        let _e1541 = local.member_1[1u];
                                        let _e1543 = ((_e1530 * _e1533) - (_e1538 * _e1541));
                                        let _e1547 = local.member[2u][2u];
                                        if (_e1547 < 0f) {
                                            phi_2215_ = -(_e1547);
                                        } else {
                                            phi_2215_ = _e1547;
                                        }
                                        let _e1551 = phi_2215_;
                                        let _e1554 = local.member_3[1u];
                                        let _e1559 = local.member[1u][2u];
                                        if (_e1559 < 0f) {
                                            phi_2238_ = -(_e1559);
                                        } else {
                                            phi_2238_ = _e1559;
                                        }
                                        let _e1563 = phi_2238_;
                                        let _e1566 = local.member_3[2u];
                                        let _e1572 = local.member[0u][1u];
                                        if (_e1572 < 0f) {
                                            phi_2261_ = -(_e1572);
                                        } else {
                                            phi_2261_ = _e1572;
                                        }
                                        let _e1576 = phi_2261_;
                                        let _e1579 = local.member_4[0u];
                                        let _e1584 = local.member[0u][0u];
                                        if (_e1584 < 0f) {
                                            phi_2283_ = -(_e1584);
                                        } else {
                                            phi_2283_ = _e1584;
                                        }
                                        let _e1588 = phi_2283_;
                                        let _e1591 = local.member_4[1u];
                                        if (_e1543 < 0f) {
                                            phi_2299_ = -(_e1543);
                                        } else {
                                            phi_2299_ = _e1543;
                                        }
                                        let _e1597 = phi_2299_;
                                        let _e1599 = (_e1597 - (((_e1551 * _e1554) + (_e1563 * _e1566)) + ((_e1576 * _e1579) + (_e1588 * _e1591))));
                                        let _e1603 = local.member[2u][0u];
                                        let _e1606 = local.member_1[0u];
                                        let _e1611 = local.member[0u][0u];
                                        let _e1614 = local.member_1[2u];
                                        let _e1616 = ((_e1603 * _e1606) - (_e1611 * _e1614));
                                        let _e1620 = local.member[0u][0u];
                                        if (_e1620 < 0f) {
                                            phi_2354_ = -(_e1620);
                                        } else {
                                            phi_2354_ = _e1620;
                                        }
                                        let _e1624 = phi_2354_;
                                        let _e1627 = local.member_3[2u];
                                        let _e1632 = local.member[2u][0u];
                                        if (_e1632 < 0f) {
                                            phi_2377_ = -(_e1632);
                                        } else {
                                            phi_2377_ = _e1632;
                                        }
                                        let _e1636 = phi_2377_;
                                        let _e1639 = local.member_3[0u];
                                        let _e1645 = local.member[1u][2u];
                                        if (_e1645 < 0f) {
                                            phi_2401_ = -(_e1645);
                                        } else {
                                            phi_2401_ = _e1645;
                                        }
                                        let _e1649 = phi_2401_;
                                        let _e1652 = local.member_4[1u];
                                        let _e1657 = local.member[1u][1u];
                                        if (_e1657 < 0f) {
                                            phi_2424_ = -(_e1657);
                                        } else {
                                            phi_2424_ = _e1657;
                                        }
                                        let _e1661 = phi_2424_;
                                        let _e1664 = local.member_4[2u];
                                        if (_e1616 < 0f) {
                                            phi_2440_ = -(_e1616);
                                        } else {
                                            phi_2440_ = _e1616;
                                        }
                                        let _e1670 = phi_2440_;
                                        let _e1672 = (_e1670 - (((_e1624 * _e1627) + (_e1636 * _e1639)) + ((_e1649 * _e1652) + (_e1661 * _e1664))));
                                        let _e1676 = local.member[2u][1u];
                                        let _e1679 = local.member_1[0u];
                                        let _e1684 = local.member[0u][1u];
                                        let _e1687 = local.member_1[2u];
                                        let _e1689 = ((_e1676 * _e1679) - (_e1684 * _e1687));
                                        let _e1693 = local.member[0u][1u];
                                        if (_e1693 < 0f) {
                                            phi_2495_ = -(_e1693);
                                        } else {
                                            phi_2495_ = _e1693;
                                        }
                                        let _e1697 = phi_2495_;
                                        let _e1700 = local.member_3[2u];
                                        let _e1705 = local.member[2u][1u];
                                        if (_e1705 < 0f) {
                                            phi_2518_ = -(_e1705);
                                        } else {
                                            phi_2518_ = _e1705;
                                        }
                                        let _e1709 = phi_2518_;
                                        let _e1712 = local.member_3[0u];
                                        let _e1718 = local.member[1u][0u];
                                        if (_e1718 < 0f) {
                                            phi_2542_ = -(_e1718);
                                        } else {
                                            phi_2542_ = _e1718;
                                        }
                                        let _e1722 = phi_2542_;
                                        let _e1725 = local.member_4[2u];
                                        let _e1730 = local.member[1u][2u];
                                        if (_e1730 < 0f) {
                                            phi_2565_ = -(_e1730);
                                        } else {
                                            phi_2565_ = _e1730;
                                        }
                                        let _e1734 = phi_2565_;
                                        let _e1737 = local.member_4[0u];
                                        if (_e1689 < 0f) {
                                            phi_2581_ = -(_e1689);
                                        } else {
                                            phi_2581_ = _e1689;
                                        }
                                        let _e1743 = phi_2581_;
                                        let _e1745 = (_e1743 - (((_e1697 * _e1700) + (_e1709 * _e1712)) + ((_e1722 * _e1725) + (_e1734 * _e1737))));
                                        let _e1749 = local.member[2u][2u];
                                        let _e1752 = local.member_1[0u];
                                        let _e1757 = local.member[0u][2u];
                                        let _e1760 = local.member_1[2u];
                                        let _e1762 = ((_e1749 * _e1752) - (_e1757 * _e1760));
                                        let _e1766 = local.member[0u][2u];
                                        if (_e1766 < 0f) {
                                            phi_2636_ = -(_e1766);
                                        } else {
                                            phi_2636_ = _e1766;
                                        }
                                        let _e1770 = phi_2636_;
                                        let _e1773 = local.member_3[2u];
                                        let _e1778 = local.member[2u][2u];
                                        if (_e1778 < 0f) {
                                            phi_2659_ = -(_e1778);
                                        } else {
                                            phi_2659_ = _e1778;
                                        }
                                        let _e1782 = phi_2659_;
                                        let _e1785 = local.member_3[0u];
                                        let _e1791 = local.member[1u][1u];
                                        if (_e1791 < 0f) {
                                            phi_2683_ = -(_e1791);
                                        } else {
                                            phi_2683_ = _e1791;
                                        }
                                        let _e1795 = phi_2683_;
                                        let _e1798 = local.member_4[0u];
                                        let _e1803 = local.member[1u][0u];
                                        if (_e1803 < 0f) {
                                            phi_2706_ = -(_e1803);
                                        } else {
                                            phi_2706_ = _e1803;
                                        }
                                        let _e1807 = phi_2706_;
                                        let _e1810 = local.member_4[1u];
                                        if (_e1762 < 0f) {
                                            phi_2722_ = -(_e1762);
                                        } else {
                                            phi_2722_ = _e1762;
                                        }
                                        let _e1816 = phi_2722_;
                                        let _e1818 = (_e1816 - (((_e1770 * _e1773) + (_e1782 * _e1785)) + ((_e1795 * _e1798) + (_e1807 * _e1810))));
                                        let _e1822 = local.member[0u][0u];
                                        let _e1825 = local.member_1[1u];
                                        let _e1830 = local.member[1u][0u];
                                        let _e1833 = local.member_1[0u];
                                        let _e1835 = ((_e1822 * _e1825) - (_e1830 * _e1833));
                                        let _e1839 = local.member[1u][0u];
                                        if (_e1839 < 0f) {
                                            phi_2777_ = -(_e1839);
                                        } else {
                                            phi_2777_ = _e1839;
                                        }
                                        let _e1843 = phi_2777_;
                                        let _e1846 = local.member_3[0u];
                                        let _e1851 = local.member[0u][0u];
                                        if (_e1851 < 0f) {
                                            phi_2800_ = -(_e1851);
                                        } else {
                                            phi_2800_ = _e1851;
                                        }
                                        let _e1855 = phi_2800_;
                                        let _e1858 = local.member_3[1u];
                                        let _e1864 = local.member[2u][2u];
                                        if (_e1864 < 0f) {
                                            phi_2824_ = -(_e1864);
                                        } else {
                                            phi_2824_ = _e1864;
                                        }
                                        let _e1868 = phi_2824_;
                                        let _e1871 = local.member_4[1u];
                                        let _e1876 = local.member[2u][1u];
                                        if (_e1876 < 0f) {
                                            phi_2847_ = -(_e1876);
                                        } else {
                                            phi_2847_ = _e1876;
                                        }
                                        let _e1880 = phi_2847_;
                                        let _e1883 = local.member_4[2u];
                                        if (_e1835 < 0f) {
                                            phi_2863_ = -(_e1835);
                                        } else {
                                            phi_2863_ = _e1835;
                                        }
                                        let _e1889 = phi_2863_;
                                        let _e1891 = (_e1889 - (((_e1843 * _e1846) + (_e1855 * _e1858)) + ((_e1868 * _e1871) + (_e1880 * _e1883))));
                                        let _e1895 = local.member[0u][1u];
                                        let _e1898 = local.member_1[1u];
                                        let _e1903 = local.member[1u][1u];
                                        let _e1906 = local.member_1[0u];
                                        let _e1908 = ((_e1895 * _e1898) - (_e1903 * _e1906));
                                        let _e1912 = local.member[1u][1u];
                                        if (_e1912 < 0f) {
                                            phi_2918_ = -(_e1912);
                                        } else {
                                            phi_2918_ = _e1912;
                                        }
                                        let _e1916 = phi_2918_;
                                        let _e1919 = local.member_3[0u];
                                        let _e1924 = local.member[0u][1u];
                                        if (_e1924 < 0f) {
                                            phi_2941_ = -(_e1924);
                                        } else {
                                            phi_2941_ = _e1924;
                                        }
                                        let _e1928 = phi_2941_;
                                        let _e1931 = local.member_3[1u];
                                        let _e1937 = local.member[2u][0u];
                                        if (_e1937 < 0f) {
                                            phi_2965_ = -(_e1937);
                                        } else {
                                            phi_2965_ = _e1937;
                                        }
                                        let _e1941 = phi_2965_;
                                        let _e1944 = local.member_4[2u];
                                        let _e1949 = local.member[2u][2u];
                                        if (_e1949 < 0f) {
                                            phi_2988_ = -(_e1949);
                                        } else {
                                            phi_2988_ = _e1949;
                                        }
                                        let _e1953 = phi_2988_;
                                        let _e1956 = local.member_4[0u];
                                        if (_e1908 < 0f) {
                                            phi_3004_ = -(_e1908);
                                        } else {
                                            phi_3004_ = _e1908;
                                        }
                                        let _e1962 = phi_3004_;
                                        let _e1964 = (_e1962 - (((_e1916 * _e1919) + (_e1928 * _e1931)) + ((_e1941 * _e1944) + (_e1953 * _e1956))));
                                        let _e1968 = local.member[0u][2u];
                                        let _e1971 = local.member_1[1u];
                                        let _e1976 = local.member[1u][2u];
                                        let _e1979 = local.member_1[0u];
                                        let _e1981 = ((_e1968 * _e1971) - (_e1976 * _e1979));
                                        let _e1985 = local.member[1u][2u];
                                        if (_e1985 < 0f) {
                                            phi_3059_ = -(_e1985);
                                        } else {
                                            phi_3059_ = _e1985;
                                        }
                                        let _e1989 = phi_3059_;
                                        let _e1992 = local.member_3[0u];
                                        let _e1997 = local.member[0u][2u];
                                        if (_e1997 < 0f) {
                                            phi_3082_ = -(_e1997);
                                        } else {
                                            phi_3082_ = _e1997;
                                        }
                                        let _e2001 = phi_3082_;
                                        let _e2004 = local.member_3[1u];
                                        let _e2010 = local.member[2u][1u];
                                        if (_e2010 < 0f) {
                                            phi_3106_ = -(_e2010);
                                        } else {
                                            phi_3106_ = _e2010;
                                        }
                                        let _e2014 = phi_3106_;
                                        let _e2017 = local.member_4[0u];
                                        let _e2022 = local.member[2u][0u];
                                        if (_e2022 < 0f) {
                                            phi_3129_ = -(_e2022);
                                        } else {
                                            phi_3129_ = _e2022;
                                        }
                                        let _e2026 = phi_3129_;
                                        let _e2029 = local.member_4[1u];
                                        if (_e1981 < 0f) {
                                            phi_3145_ = -(_e1981);
                                        } else {
                                            phi_3145_ = _e1981;
                                        }
                                        let _e2035 = phi_3145_;
                                        let _e2037 = (_e2035 - (((_e1989 * _e1992) + (_e2001 * _e2004)) + ((_e2014 * _e2017) + (_e2026 * _e2029))));
                                        if (_e1453 > _e1526) {
                                            phi_3152_ = _e1453;
                                        } else {
                                            phi_3152_ = _e1526;
                                        }
                                        let _e2040 = phi_3152_;
                                        if (_e2040 > _e1599) {
                                            phi_3157_ = _e2040;
                                        } else {
                                            phi_3157_ = _e1599;
                                        }
                                        let _e2043 = phi_3157_;
                                        if (_e1672 > _e1745) {
                                            phi_3162_ = _e1672;
                                        } else {
                                            phi_3162_ = _e1745;
                                        }
                                        let _e2046 = phi_3162_;
                                        if (_e2046 > _e1818) {
                                            phi_3167_ = _e2046;
                                        } else {
                                            phi_3167_ = _e1818;
                                        }
                                        let _e2049 = phi_3167_;
                                        if (_e2043 > _e2049) {
                                            phi_3172_ = _e2043;
                                        } else {
                                            phi_3172_ = _e2049;
                                        }
                                        let _e2052 = phi_3172_;
                                        if (_e1891 > _e1964) {
                                            phi_3177_ = _e1891;
                                        } else {
                                            phi_3177_ = _e1964;
                                        }
                                        let _e2055 = phi_3177_;
                                        if (_e2055 > _e2037) {
                                            phi_3182_ = _e2055;
                                        } else {
                                            phi_3182_ = _e2037;
                                        }
                                        let _e2058 = phi_3182_;
                                        if (_e2052 > _e2058) {
                                            phi_3187_ = _e2052;
                                        } else {
                                            phi_3187_ = _e2058;
                                        }
                                        let _e2061 = phi_3187_;
                                        let _e2063 = local.member_5;
                                        phi_3191_ = (_e2061 > _e2063);
                                    }
                                    let _e2066 = phi_3191_;
                                    phi_3193_ = !(_e2066);
                                    phi_3194_ = false;
                                } else {
                                    phi_3193_ = bool();
                                    phi_3194_ = true;
                                }
                                let _e2069 = phi_3193_;
                                let _e2071 = phi_3194_;
                                phi_3195_ = _e2069;
                                phi_3196_ = _e2071;
                            }
                            let _e2073 = phi_3195_;
                            let _e2075 = phi_3196_;
                            if _e2075 {
                                phi_3200_ = true;
                            } else {
                                phi_3200_ = _e2073;
                            }
                            let _e2077 = phi_3200_;
                            if _e2077 {
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
                let _e2080 = local_1;
                if (_e150 == 4294967295u) {
                    phi_3250_ = 0u;
                } else {
                    if (_e150 >= _e78) {
                        if (_e153 >= _e83) {
                            phi_3244_ = false;
                        } else {
                            phi_3244_ = true;
                        }
                        let _e2101 = phi_3244_;
                        phi_3245_ = _e2101;
                    } else {
                        phi_3245_ = true;
                    }
                    let _e2103 = phi_3245_;
                    if _e2103 {
                        phi_3249_ = 1u;
                    } else {
                        phi_3249_ = 2u;
                    }
                    let _e2105 = phi_3249_;
                    phi_3250_ = _e2105;
                }
                let _e2107 = phi_3250_;
                if (_e2107 == 2u) {
                    phi_3256_ = array<u32, 2>(_e150, _e153);
                } else {
                    phi_3256_ = array<u32, 2>(_e2080[0][0], _e2080[0][1]);
                }
                let _e2111 = phi_3256_;
                phi_3257_ = array<u32, 2>(_e2080[3][0], _e2080[3][1]);
                phi_3258_ = array<u32, 2>(_e2080[2][0], _e2080[2][1]);
                phi_3259_ = array<u32, 2>(_e2080[1][0], _e2080[1][1]);
                phi_3260_ = _e2111;
            } else {
                phi_3257_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3258_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3259_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3260_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2113 = phi_3257_;
            let _e2115 = phi_3258_;
            let _e2117 = phi_3259_;
            let _e2119 = phi_3260_;
            if (_e2119[0] == 4294967295u) {
                phi_3282_ = 0u;
            } else {
                if (_e2119[0] >= _e78) {
                    if (_e2119[1] >= _e83) {
                        phi_3276_ = false;
                    } else {
                        phi_3276_ = true;
                    }
                    let _e2127 = phi_3276_;
                    phi_3277_ = _e2127;
                } else {
                    phi_3277_ = true;
                }
                let _e2129 = phi_3277_;
                if _e2129 {
                    phi_3281_ = 1u;
                } else {
                    phi_3281_ = 2u;
                }
                let _e2131 = phi_3281_;
                phi_3282_ = _e2131;
            }
            let _e2133 = phi_3282_;
            if (_e2133 == 0u) {
                phi_3294_ = 0u;
            } else {
                if (_e2133 == 1u) {
                    phi_3291_ = 0u;
                } else {
                    phi_3291_ = 1u;
                }
                let _e2137 = phi_3291_;
                let _e2139 = atomicAdd((&counters[_e2137]), 1u);
                phi_3294_ = _e2139;
            }
            let _e2141 = phi_3294_;
            if (_e2117[0] == 4294967295u) {
                phi_3316_ = 0u;
            } else {
                if (_e2117[0] >= _e78) {
                    if (_e2117[1] >= _e83) {
                        phi_3310_ = false;
                    } else {
                        phi_3310_ = true;
                    }
                    let _e2149 = phi_3310_;
                    phi_3311_ = _e2149;
                } else {
                    phi_3311_ = true;
                }
                let _e2151 = phi_3311_;
                if _e2151 {
                    phi_3315_ = 1u;
                } else {
                    phi_3315_ = 2u;
                }
                let _e2153 = phi_3315_;
                phi_3316_ = _e2153;
            }
            let _e2155 = phi_3316_;
            if (_e2155 == 0u) {
                phi_3328_ = 0u;
            } else {
                if (_e2155 == 1u) {
                    phi_3325_ = 0u;
                } else {
                    phi_3325_ = 1u;
                }
                let _e2159 = phi_3325_;
                let _e2161 = atomicAdd((&counters[_e2159]), 1u);
                phi_3328_ = _e2161;
            }
            let _e2163 = phi_3328_;
            if (_e2115[0] == 4294967295u) {
                phi_3350_ = 0u;
            } else {
                if (_e2115[0] >= _e78) {
                    if (_e2115[1] >= _e83) {
                        phi_3344_ = false;
                    } else {
                        phi_3344_ = true;
                    }
                    let _e2171 = phi_3344_;
                    phi_3345_ = _e2171;
                } else {
                    phi_3345_ = true;
                }
                let _e2173 = phi_3345_;
                if _e2173 {
                    phi_3349_ = 1u;
                } else {
                    phi_3349_ = 2u;
                }
                let _e2175 = phi_3349_;
                phi_3350_ = _e2175;
            }
            let _e2177 = phi_3350_;
            if (_e2177 == 0u) {
                phi_3362_ = 0u;
            } else {
                if (_e2177 == 1u) {
                    phi_3359_ = 0u;
                } else {
                    phi_3359_ = 1u;
                }
                let _e2181 = phi_3359_;
                let _e2183 = atomicAdd((&counters[_e2181]), 1u);
                phi_3362_ = _e2183;
            }
            let _e2185 = phi_3362_;
            if (_e2113[0] == 4294967295u) {
                phi_3384_ = 0u;
            } else {
                if (_e2113[0] >= _e78) {
                    if (_e2113[1] >= _e83) {
                        phi_3378_ = false;
                    } else {
                        phi_3378_ = true;
                    }
                    let _e2193 = phi_3378_;
                    phi_3379_ = _e2193;
                } else {
                    phi_3379_ = true;
                }
                let _e2195 = phi_3379_;
                if _e2195 {
                    phi_3383_ = 1u;
                } else {
                    phi_3383_ = 2u;
                }
                let _e2197 = phi_3383_;
                phi_3384_ = _e2197;
            }
            let _e2199 = phi_3384_;
            if (_e2199 == 0u) {
                phi_3396_ = 0u;
            } else {
                if (_e2199 == 1u) {
                    phi_3393_ = 0u;
                } else {
                    phi_3393_ = 1u;
                }
                let _e2203 = phi_3393_;
                let _e2205 = atomicAdd((&counters[_e2203]), 1u);
                phi_3396_ = _e2205;
            }
            let _e2207 = phi_3396_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e2210 = atomicLoad((&counters[0u]));
                let _e2212 = atomicLoad((&counters[1u]));
                if (_e2210 > 0u) {
                    let _e2216 = atomicAdd((&levels.member[(_e68 + 1u)]), _e2210);
                    let _e2219 = atomicMax((&output.member[0u]), (_e2216 + _e2210));
                    if ((_e2216 + _e2210) < _e2216) {
                        let _e2223 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2216);
                }
                if (_e2212 > 0u) {
                    let _e2227 = atomicAdd((&pairs.member[0u]), _e2212);
                    if ((_e2227 + _e2212) < _e2227) {
                        let _e2231 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2227);
                }
            }
            workgroupBarrier();
            let _e2234 = atomicLoad((&counters[2u]));
            let _e2236 = atomicLoad((&counters[3u]));
            if (_e2119[0] == 4294967295u) {
                phi_3468_ = 0u;
            } else {
                if (_e2119[0] >= _e78) {
                    if (_e2119[1] >= _e83) {
                        phi_3462_ = false;
                    } else {
                        phi_3462_ = true;
                    }
                    let _e2244 = phi_3462_;
                    phi_3463_ = _e2244;
                } else {
                    phi_3463_ = true;
                }
                let _e2246 = phi_3463_;
                if _e2246 {
                    phi_3467_ = 1u;
                } else {
                    phi_3467_ = 2u;
                }
                let _e2248 = phi_3467_;
                phi_3468_ = _e2248;
            }
            let _e2250 = phi_3468_;
            if (_e2250 == 1u) {
                let _e2289 = params.member.member_2.member_3;
                let _e2290 = (_e2234 + _e2141);
                if (_e2290 < _e2289) {
                    let _e2292 = (2u * _e2290);
                    atomicStore((&output.member[(4u + _e2292)]), _e2119[0]);
                    atomicStore((&output.member[(_e2292 + 5u)]), _e2119[1]);
                }
            } else {
                if (_e2250 == 2u) {
                    let _e2255 = a_nodes.member[_e2119[0]];
                    let _e2259 = b_nodes.member[_e2119[1]];
                    let _e2263 = params.member.member_2.member;
                    if (_e2263 == 1u) {
                        if (_e2255.member_1 < _e2259.member_1) {
                            phi_3531_ = type_9(_e2255.member_1, _e2259.member_1);
                        } else {
                            phi_3531_ = type_9(_e2259.member_1, _e2255.member_1);
                        }
                        let _e2270 = phi_3531_;
                        phi_3536_ = _e2270;
                    } else {
                        phi_3536_ = type_9(_e2255.member_1, _e2259.member_1);
                    }
                    let _e2272 = phi_3536_;
                    let _e2275 = params.member.member_1.member_3;
                    let _e2276 = (_e2236 + _e2141);
                    if (_e2276 < _e2275) {
                        let _e2280 = (2u * _e2276);
                        atomicStore((&pairs.member[(4u + _e2280)]), _e2272.member);
                        atomicStore((&pairs.member[(_e2280 + 5u)]), _e2272.member_1);
                    }
                }
            }
            if (_e2117[0] == 4294967295u) {
                phi_3575_ = 0u;
            } else {
                if (_e2117[0] >= _e78) {
                    if (_e2117[1] >= _e83) {
                        phi_3569_ = false;
                    } else {
                        phi_3569_ = true;
                    }
                    let _e2304 = phi_3569_;
                    phi_3570_ = _e2304;
                } else {
                    phi_3570_ = true;
                }
                let _e2306 = phi_3570_;
                if _e2306 {
                    phi_3574_ = 1u;
                } else {
                    phi_3574_ = 2u;
                }
                let _e2308 = phi_3574_;
                phi_3575_ = _e2308;
            }
            let _e2310 = phi_3575_;
            if (_e2310 == 1u) {
                let _e2349 = params.member.member_2.member_3;
                let _e2350 = (_e2234 + _e2163);
                if (_e2350 < _e2349) {
                    let _e2352 = (2u * _e2350);
                    atomicStore((&output.member[(4u + _e2352)]), _e2117[0]);
                    atomicStore((&output.member[(_e2352 + 5u)]), _e2117[1]);
                }
            } else {
                if (_e2310 == 2u) {
                    let _e2315 = a_nodes.member[_e2117[0]];
                    let _e2319 = b_nodes.member[_e2117[1]];
                    let _e2323 = params.member.member_2.member;
                    if (_e2323 == 1u) {
                        if (_e2315.member_1 < _e2319.member_1) {
                            phi_3638_ = type_9(_e2315.member_1, _e2319.member_1);
                        } else {
                            phi_3638_ = type_9(_e2319.member_1, _e2315.member_1);
                        }
                        let _e2330 = phi_3638_;
                        phi_3643_ = _e2330;
                    } else {
                        phi_3643_ = type_9(_e2315.member_1, _e2319.member_1);
                    }
                    let _e2332 = phi_3643_;
                    let _e2335 = params.member.member_1.member_3;
                    let _e2336 = (_e2236 + _e2163);
                    if (_e2336 < _e2335) {
                        let _e2340 = (2u * _e2336);
                        atomicStore((&pairs.member[(4u + _e2340)]), _e2332.member);
                        atomicStore((&pairs.member[(_e2340 + 5u)]), _e2332.member_1);
                    }
                }
            }
            if (_e2115[0] == 4294967295u) {
                phi_3682_ = 0u;
            } else {
                if (_e2115[0] >= _e78) {
                    if (_e2115[1] >= _e83) {
                        phi_3676_ = false;
                    } else {
                        phi_3676_ = true;
                    }
                    let _e2364 = phi_3676_;
                    phi_3677_ = _e2364;
                } else {
                    phi_3677_ = true;
                }
                let _e2366 = phi_3677_;
                if _e2366 {
                    phi_3681_ = 1u;
                } else {
                    phi_3681_ = 2u;
                }
                let _e2368 = phi_3681_;
                phi_3682_ = _e2368;
            }
            let _e2370 = phi_3682_;
            if (_e2370 == 1u) {
                let _e2409 = params.member.member_2.member_3;
                let _e2410 = (_e2234 + _e2185);
                if (_e2410 < _e2409) {
                    let _e2412 = (2u * _e2410);
                    atomicStore((&output.member[(4u + _e2412)]), _e2115[0]);
                    atomicStore((&output.member[(_e2412 + 5u)]), _e2115[1]);
                }
            } else {
                if (_e2370 == 2u) {
                    let _e2375 = a_nodes.member[_e2115[0]];
                    let _e2379 = b_nodes.member[_e2115[1]];
                    let _e2383 = params.member.member_2.member;
                    if (_e2383 == 1u) {
                        if (_e2375.member_1 < _e2379.member_1) {
                            phi_3745_ = type_9(_e2375.member_1, _e2379.member_1);
                        } else {
                            phi_3745_ = type_9(_e2379.member_1, _e2375.member_1);
                        }
                        let _e2390 = phi_3745_;
                        phi_3750_ = _e2390;
                    } else {
                        phi_3750_ = type_9(_e2375.member_1, _e2379.member_1);
                    }
                    let _e2392 = phi_3750_;
                    let _e2395 = params.member.member_1.member_3;
                    let _e2396 = (_e2236 + _e2185);
                    if (_e2396 < _e2395) {
                        let _e2400 = (2u * _e2396);
                        atomicStore((&pairs.member[(4u + _e2400)]), _e2392.member);
                        atomicStore((&pairs.member[(_e2400 + 5u)]), _e2392.member_1);
                    }
                }
            }
            if (_e2113[0] == 4294967295u) {
                phi_3789_ = 0u;
            } else {
                if (_e2113[0] >= _e78) {
                    if (_e2113[1] >= _e83) {
                        phi_3783_ = false;
                    } else {
                        phi_3783_ = true;
                    }
                    let _e2424 = phi_3783_;
                    phi_3784_ = _e2424;
                } else {
                    phi_3784_ = true;
                }
                let _e2426 = phi_3784_;
                if _e2426 {
                    phi_3788_ = 1u;
                } else {
                    phi_3788_ = 2u;
                }
                let _e2428 = phi_3788_;
                phi_3789_ = _e2428;
            }
            let _e2430 = phi_3789_;
            if (_e2430 == 1u) {
                let _e2469 = params.member.member_2.member_3;
                let _e2470 = (_e2234 + _e2207);
                if (_e2470 < _e2469) {
                    let _e2472 = (2u * _e2470);
                    atomicStore((&output.member[(4u + _e2472)]), _e2113[0]);
                    atomicStore((&output.member[(_e2472 + 5u)]), _e2113[1]);
                }
            } else {
                if (_e2430 == 2u) {
                    let _e2435 = a_nodes.member[_e2113[0]];
                    let _e2439 = b_nodes.member[_e2113[1]];
                    let _e2443 = params.member.member_2.member;
                    if (_e2443 == 1u) {
                        if (_e2435.member_1 < _e2439.member_1) {
                            phi_3852_ = type_9(_e2435.member_1, _e2439.member_1);
                        } else {
                            phi_3852_ = type_9(_e2439.member_1, _e2435.member_1);
                        }
                        let _e2450 = phi_3852_;
                        phi_3857_ = _e2450;
                    } else {
                        phi_3857_ = type_9(_e2435.member_1, _e2439.member_1);
                    }
                    let _e2452 = phi_3857_;
                    let _e2455 = params.member.member_1.member_3;
                    let _e2456 = (_e2236 + _e2207);
                    if (_e2456 < _e2455) {
                        let _e2460 = (2u * _e2456);
                        atomicStore((&pairs.member[(4u + _e2460)]), _e2452.member);
                        atomicStore((&pairs.member[(_e2460 + 5u)]), _e2452.member_1);
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
