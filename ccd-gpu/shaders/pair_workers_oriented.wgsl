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

struct type_16 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
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

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_26 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_32 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_35 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_35;
@group(0) @binding(3) 
var<storage> oriented: type_30;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(4) 
var<storage, read_write> control: type_35;
@group(0) @binding(1) 
var<storage> a: type_18;
@group(0) @binding(2) 
var<storage> b: type_18;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_35;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<u32, 2>, 4>;
    var phi_208_: u32;
    var phi_246_: type_9;
    var phi_247_: type_9;
    var phi_270_: type_9;
    var phi_294_: u32;
    var phi_325_: bool;
    var phi_329_: u32;
    var phi_330_: u32;
    var phi_331_: u32;
    var phi_391_: u32;
    var phi_396_: u32;
    var phi_401_: u32;
    var phi_414_: u32;
    var phi_420_: u32;
    var phi_429_: u32;
    var phi_359_: u32;
    var phi_365_: u32;
    var phi_430_: u32;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_452_: u32;
    var phi_453_: u32;
    var phi_536_: array<u32, 2>;
    var phi_537_: array<u32, 2>;
    var phi_554_: array<u32, 2>;
    var phi_583_: u32;
    var phi_657_: array<u32, 2>;
    var phi_671_: array<u32, 2>;
    var phi_708_: array<u32, 2>;
    var phi_710_: type_24;
    var phi_711_: type_24;
    var phi_712_: bool;
    var phi_713_: type_24;
    var phi_714_: bool;
    var phi_730_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_885_: array<u32, 2>;
    var phi_914_: array<u32, 2>;
    var phi_943_: array<u32, 2>;
    var phi_972_: array<u32, 2>;
    var phi_974_: type_24;
    var phi_975_: bool;
    var phi_976_: type_24;
    var phi_977_: bool;
    var phi_1150_: array<u32, 2>;
    var phi_1182_: array<u32, 2>;
    var phi_1050_: array<u32, 2>;
    var phi_1082_: array<u32, 2>;
    var phi_1184_: type_24;
    var phi_1185_: type_24;
    var phi_1186_: type_24;
    var phi_1187_: bool;
    var phi_1188_: type_24;
    var phi_1189_: type_24;
    var phi_1190_: bool;
    var phi_1194_: type_24;
    var phi_1212_: array<u32, 2>;
    var phi_1243_: array<u32, 2>;
    var phi_1288_: type_9;
    var phi_1289_: type_9;
    var phi_1312_: type_9;
    var phi_1341_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1427_: f32;
    var phi_1433_: f32;
    var phi_1439_: f32;
    var phi_1445_: f32;
    var phi_1451_: f32;
    var phi_1457_: f32;
    var phi_1475_: f32;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1501_: type_31;
    var phi_1571_: f32;
    var phi_1577_: f32;
    var phi_1583_: f32;
    var phi_1589_: f32;
    var phi_1595_: f32;
    var phi_1601_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1629_: f32;
    var phi_1645_: type_31;
    var phi_1835_: f32;
    var phi_1841_: f32;
    var phi_1848_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1872_: f32;
    var phi_1881_: f32;
    var phi_1888_: f32;
    var phi_1896_: f32;
    var phi_1989_: f32;
    var phi_1996_: f32;
    var phi_2002_: f32;
    var phi_2008_: f32;
    var phi_2027_: f32;
    var phi_2034_: f32;
    var phi_2040_: f32;
    var phi_2046_: f32;
    var phi_2065_: f32;
    var phi_2072_: f32;
    var phi_2078_: f32;
    var phi_2084_: f32;
    var phi_2103_: f32;
    var phi_2110_: f32;
    var phi_2116_: f32;
    var phi_2122_: f32;
    var phi_2141_: f32;
    var phi_2148_: f32;
    var phi_2154_: f32;
    var phi_2160_: f32;
    var phi_2179_: f32;
    var phi_2186_: f32;
    var phi_2192_: f32;
    var phi_2198_: f32;
    var phi_2213_: f32;
    var phi_2218_: f32;
    var phi_2223_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2292_: f32;
    var phi_2315_: f32;
    var phi_2338_: f32;
    var phi_2360_: f32;
    var phi_2376_: f32;
    var phi_2431_: f32;
    var phi_2454_: f32;
    var phi_2477_: f32;
    var phi_2499_: f32;
    var phi_2515_: f32;
    var phi_2570_: f32;
    var phi_2593_: f32;
    var phi_2616_: f32;
    var phi_2638_: f32;
    var phi_2654_: f32;
    var phi_2709_: f32;
    var phi_2732_: f32;
    var phi_2756_: f32;
    var phi_2779_: f32;
    var phi_2795_: f32;
    var phi_2850_: f32;
    var phi_2873_: f32;
    var phi_2897_: f32;
    var phi_2920_: f32;
    var phi_2936_: f32;
    var phi_2991_: f32;
    var phi_3014_: f32;
    var phi_3038_: f32;
    var phi_3061_: f32;
    var phi_3077_: f32;
    var phi_3132_: f32;
    var phi_3155_: f32;
    var phi_3179_: f32;
    var phi_3202_: f32;
    var phi_3218_: f32;
    var phi_3273_: f32;
    var phi_3296_: f32;
    var phi_3320_: f32;
    var phi_3343_: f32;
    var phi_3359_: f32;
    var phi_3414_: f32;
    var phi_3437_: f32;
    var phi_3461_: f32;
    var phi_3484_: f32;
    var phi_3500_: f32;
    var phi_3507_: f32;
    var phi_3512_: f32;
    var phi_3517_: f32;
    var phi_3522_: f32;
    var phi_3527_: f32;
    var phi_3532_: f32;
    var phi_3537_: f32;
    var phi_3542_: f32;
    var phi_3546_: bool;
    var phi_3548_: bool;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3551_: bool;
    var phi_3555_: bool;
    var phi_3592_: array<array<u32, 2>, 4>;
    var phi_3610_: bool;
    var phi_3611_: bool;
    var phi_3615_: u32;
    var phi_3616_: u32;
    var phi_3628_: type_32;
    var phi_3629_: type_32;
    var phi_3647_: bool;
    var phi_3648_: bool;
    var phi_3652_: u32;
    var phi_3653_: u32;
    var phi_3665_: type_32;
    var phi_3666_: type_32;
    var phi_3684_: bool;
    var phi_3685_: bool;
    var phi_3689_: u32;
    var phi_3690_: u32;
    var phi_3702_: type_32;
    var phi_3703_: type_32;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3726_: u32;
    var phi_3727_: u32;
    var phi_3739_: type_32;
    var phi_3740_: type_32;
    var phi_3756_: bool;
    var phi_3757_: bool;
    var phi_3761_: u32;
    var phi_3762_: u32;
    var phi_3768_: type_32;
    var phi_3769_: type_32;
    var phi_3770_: type_32;
    var phi_3771_: type_32;
    var phi_3772_: type_32;
    var phi_3792_: array<u32, 2>;
    var phi_3793_: array<u32, 2>;
    var phi_3805_: array<u32, 2>;
    var phi_3806_: array<u32, 2>;
    var phi_3823_: array<u32, 2>;
    var phi_3824_: array<u32, 2>;
    var phi_3836_: array<u32, 2>;
    var phi_3837_: array<u32, 2>;
    var phi_3854_: array<u32, 2>;
    var phi_3855_: array<u32, 2>;
    var phi_3867_: array<u32, 2>;
    var phi_3868_: array<u32, 2>;
    var phi_3885_: array<u32, 2>;
    var phi_3886_: array<u32, 2>;
    var phi_3898_: array<u32, 2>;
    var phi_3899_: array<u32, 2>;
    var phi_3943_: u32;
    var phi_4128_: type_9;
    var phi_4133_: type_9;
    var phi_4291_: type_9;
    var phi_4296_: type_9;
    var phi_4454_: type_9;
    var phi_4459_: type_9;
    var phi_4617_: type_9;
    var phi_4622_: type_9;
    var phi_4675_: bool;
    var phi_4676_: bool;
    var phi_4699_: u32;
    var phi_4704_: u32;
    var phi_4777_: type_9;
    var phi_4778_: type_9;
    var phi_4801_: type_9;
    var phi_4861_: u32;
    var phi_4864_: type_9;
    var phi_4865_: type_9;
    var phi_4888_: type_9;
    var phi_4969_: type_9;
    var phi_4970_: type_9;
    var phi_4993_: type_9;
    var phi_5085_: bool;
    var phi_5086_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e70 = id_2;
    let _e71 = n_2;
    let _e72 = lane_2;
    let _e85 = ((_e70.y * _e71.x) + _e70.x);
    let _e87 = params.member.member_2;
    let _e89 = params.member.member_1;
    let _e92 = (_e89.member_1 % 2u);
    let _e94 = atomicLoad((&control.member[_e89.member_1]));
    if (_e87.member_3 < _e94) {
        phi_208_ = _e87.member_3;
    } else {
        phi_208_ = _e94;
    }
    let _e97 = phi_208_;
    let _e98 = (_e92 * _e87.member_3);
    let _e100 = ((1u - _e92) * _e87.member_3);
    if (_e72 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_246_ = type_9(0u, _e87.member_11);
    loop {
        let _e109 = phi_246_;
        if (_e109.member < _e109.member_1) {
            phi_247_ = type_9((_e109.member + 1u), _e109.member_1);
            phi_270_ = type_9(1u, _e109.member);
        } else {
            phi_247_ = _e109;
            phi_270_ = type_9(0u, type_9().member_1);
        }
        let _e121 = phi_247_;
        let _e123 = phi_270_;
        if (bitcast<i32>(_e123.member) != 0i) {
            if (_e72 == 0u) {
                let _e134 = atomicLoad((&shared_[0u]));
                if (128u < _e134) {
                    phi_294_ = 128u;
                } else {
                    phi_294_ = _e134;
                }
                let _e137 = phi_294_;
                if (_e87.member_9 > 0u) {
                    if (_e123.member_1 >= 16u) {
                        let _e142 = atomicLoad((&control.member[(1024u + _e89.member_1)]));
                        if (_e87.member_9 > 0u) {
                            phi_325_ = ((_e142 * 100u) >= (_e87.member_9 << bitcast<u32>((_e87.member_7 & 31u))));
                        } else {
                            phi_325_ = false;
                        }
                        let _e150 = phi_325_;
                        if _e150 {
                            phi_329_ = 2u;
                        } else {
                            phi_329_ = 0u;
                        }
                        let _e152 = phi_329_;
                        phi_330_ = _e152;
                    } else {
                        phi_330_ = 0u;
                    }
                    let _e154 = phi_330_;
                    phi_331_ = _e154;
                } else {
                    phi_331_ = 0u;
                }
                let _e156 = phi_331_;
                let _e157 = (128u - _e137);
                if (_e156 == 0u) {
                    if (_e157 > 0u) {
                        let _e161 = atomicLoad((&shared_[5u]));
                        if (_e87.member_6 == 0u) {
                            if (_e85 < _e97) {
                                phi_359_ = ((((_e97 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
                            } else {
                                phi_359_ = 0u;
                            }
                            let _e202 = phi_359_;
                            let _e203 = (_e202 - _e161);
                            if (_e157 < _e203) {
                                phi_365_ = _e157;
                            } else {
                                phi_365_ = _e203;
                            }
                            let _e206 = phi_365_;
                            atomicStore((&shared_[3u]), (_e85 + (_e161 << bitcast<u32>((_e87.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e87.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e161 + _e206));
                            phi_430_ = _e206;
                        } else {
                            if (_e161 == 0u) {
                                let _e167 = (_e97 >> bitcast<u32>(((_e87.member_7 + 2u) & 31u)));
                                if (_e87.member_8 < _e167) {
                                    phi_391_ = _e167;
                                } else {
                                    phi_391_ = _e87.member_8;
                                }
                                let _e170 = phi_391_;
                                if (128u < _e170) {
                                    phi_396_ = 128u;
                                } else {
                                    phi_396_ = _e170;
                                }
                                let _e173 = phi_396_;
                                if (_e157 < _e173) {
                                    phi_401_ = _e157;
                                } else {
                                    phi_401_ = _e173;
                                }
                                let _e176 = phi_401_;
                                let _e179 = atomicAdd((&control.member[(512u + _e89.member_1)]), _e176);
                                if (_e97 < _e179) {
                                    phi_414_ = _e97;
                                } else {
                                    phi_414_ = _e179;
                                }
                                let _e182 = phi_414_;
                                let _e183 = (_e97 - _e182);
                                if (_e176 < _e183) {
                                    phi_420_ = _e176;
                                } else {
                                    phi_420_ = _e183;
                                }
                                let _e186 = phi_420_;
                                atomicStore((&shared_[3u]), _e179);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e186 < _e176)));
                                phi_429_ = _e186;
                            } else {
                                phi_429_ = 0u;
                            }
                            let _e193 = phi_429_;
                            phi_430_ = _e193;
                        }
                        let _e219 = phi_430_;
                        phi_431_ = _e219;
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e221 = phi_431_;
                    phi_432_ = _e221;
                } else {
                    phi_432_ = 0u;
                }
                let _e223 = phi_432_;
                if (_e156 == 0u) {
                    if ((_e137 + _e223) == 0u) {
                        if (_e87.member_9 > 0u) {
                            let _e230 = atomicAdd((&control.member[(1024u + _e89.member_1)]), 1u);
                        }
                        phi_452_ = 1u;
                    } else {
                        phi_452_ = _e156;
                    }
                    let _e232 = phi_452_;
                    phi_453_ = _e232;
                } else {
                    phi_453_ = _e156;
                }
                let _e234 = phi_453_;
                atomicStore((&shared_[1u]), _e137);
                atomicStore((&shared_[2u]), _e223);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e234;
            }
            let _e242 = workgroupUniformLoad((&state[0u]));
            if (_e242 != 0u) {
                phi_4675_ = false;
            } else {
                let _e245 = atomicLoad((&shared_[1u]));
                let _e247 = atomicLoad((&shared_[2u]));
                if (_e72 < _e245) {
                    let _e270 = atomicLoad((&shared_[0u]));
                    let _e273 = (2u * ((_e270 - 1u) - _e72));
                    let _e275 = stack[_e273];
                    let _e278 = stack[(_e273 + 1u)];
                    phi_537_ = array<u32, 2>(_e275, _e278);
                } else {
                    if (_e72 < (_e245 + _e247)) {
                        let _e252 = atomicLoad((&shared_[3u]));
                        let _e255 = atomicLoad((&shared_[4u]));
                        let _e259 = (2u * (_e98 + (_e252 + ((_e72 - _e245) * _e255))));
                        let _e262 = atomicLoad((&nodes.member[(4u + _e259)]));
                        let _e265 = atomicLoad((&nodes.member[(_e259 + 5u)]));
                        phi_536_ = array<u32, 2>(_e262, _e265);
                    } else {
                        phi_536_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e268 = phi_536_;
                    phi_537_ = _e268;
                }
                let _e281 = phi_537_;
                let _e284 = params.member.member_2.member;
                let _e288 = params.member.member_2.member;
                if (_e288 == 0u) {
                    phi_554_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_554_ = array<u32, 2>(1u, 1u);
                }
                let _e291 = phi_554_;
                let _e297 = params.member.member.member[_e291[0]];
                let _e298 = (_e297 - 1u);
                let _e302 = params.member.member.member[_e291[1]];
                let _e303 = (_e302 - 1u);
                let _e306 = params.member.member_2.member_1;
                if (_e306 == 0u) {
                    phi_583_ = 1u;
                } else {
                    phi_583_ = 0u;
                }
                let _e309 = phi_583_;
                if (_e281[0] != 4294967295u) {
                    let _e315 = a.member[_e281[0]];
                    let _e317 = b.member[_e281[1]];
                    if (_e284 == 1u) {
                        if (_e281[0] == _e281[1]) {
                            if (_e315.member_3 == 4294967295u) {
                                phi_710_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e323 = a.member[_e315.member_1];
                                let _e326 = a.member[_e315.member_3];
                                if !((_e323.member_3 == 4294967295u)) {
                                    phi_657_ = array<u32, 2>(_e315.member_1, _e315.member_1);
                                } else {
                                    phi_657_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e333 = phi_657_;
                                let _e340 = type_24(array<array<u32, 2>, 4>(_e333, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e352 = type_24(array<array<u32, 2>, 4>(_e340.member[0], array<u32, 2>(_e315.member_1, _e340.member[1][1]), _e340.member[2], _e340.member[3]), _e340.member_1);
                                let _e353 = array<u32, 2>(_e315.member_1, _e315.member_3);
                                let _e360 = type_24(array<array<u32, 2>, 4>(_e352.member[0], _e353, _e352.member[2], _e352.member[3]), _e352.member_1);
                                if !((_e326.member_3 == 4294967295u)) {
                                    phi_671_ = array<u32, 2>(_e315.member_3, _e315.member_3);
                                } else {
                                    phi_671_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e367 = phi_671_;
                                let _e374 = type_24(array<array<u32, 2>, 4>(_e360.member[0], _e360.member[1], _e367, _e360.member[3]), _e360.member_1);
                                let _e377 = type_24(_e374.member, _e374.member);
                                if ((((((_e323.member[0] <= _e326.member_2[0]) && (_e326.member[0] <= _e323.member_2[0])) && (_e323.member[1] <= _e326.member_2[1])) && (_e326.member[1] <= _e323.member_2[1])) && (_e323.member[2] <= _e326.member_2[2])) && (_e326.member[2] <= _e323.member_2[2])) {
                                    phi_708_ = _e353;
                                } else {
                                    phi_708_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e406 = phi_708_;
                                phi_710_ = type_24(_e377.member, array<array<u32, 2>, 4>(_e377.member_1[0], _e406, _e377.member_1[2], _e377.member_1[3]));
                            }
                            let _e415 = phi_710_;
                            phi_711_ = _e415;
                            phi_712_ = false;
                        } else {
                            phi_711_ = type_24();
                            phi_712_ = true;
                        }
                        let _e417 = phi_711_;
                        let _e419 = phi_712_;
                        phi_713_ = _e417;
                        phi_714_ = _e419;
                    } else {
                        phi_713_ = type_24();
                        phi_714_ = true;
                    }
                    let _e421 = phi_713_;
                    let _e423 = phi_714_;
                    if _e423 {
                        let _e426 = !((_e315.member_3 == 4294967295u));
                        let _e429 = !((_e317.member_3 == 4294967295u));
                        if _e426 {
                            phi_730_ = true;
                        } else {
                            phi_730_ = _e429;
                        }
                        let _e431 = phi_730_;
                        if _e431 {
                            if _e426 {
                                if _e429 {
                                    if (_e309 == 0u) {
                                        let _e459 = ((((_e317.member_2[0] - _e317.member[0]) * (_e317.member_2[1] - _e317.member[1])) * (_e317.member_2[2] - _e317.member[2])) > (((_e315.member_2[0] - _e315.member[0]) * (_e315.member_2[1] - _e315.member[1])) * (_e315.member_2[2] - _e315.member[2])));
                                        phi_774_ = _e459;
                                        phi_775_ = !(_e459);
                                    } else {
                                        phi_774_ = _e429;
                                        phi_775_ = _e426;
                                    }
                                    let _e462 = phi_774_;
                                    let _e464 = phi_775_;
                                    phi_776_ = _e462;
                                    phi_777_ = _e464;
                                } else {
                                    phi_776_ = _e429;
                                    phi_777_ = _e426;
                                }
                                let _e466 = phi_776_;
                                let _e468 = phi_777_;
                                phi_778_ = _e466;
                                phi_779_ = _e468;
                            } else {
                                phi_778_ = _e429;
                                phi_779_ = _e426;
                            }
                            let _e470 = phi_778_;
                            let _e472 = phi_779_;
                            if _e472 {
                                if _e470 {
                                    let _e475 = a.member[_e315.member_1];
                                    let _e480 = a.member[_e315.member_3];
                                    let _e485 = b.member[_e317.member_1];
                                    let _e490 = b.member[_e317.member_3];
                                    let _e495 = array<u32, 2>(_e315.member_1, _e317.member_1);
                                    let _e498 = array<u32, 2>(_e315.member_1, _e317.member_3);
                                    let _e501 = array<u32, 2>(_e315.member_3, _e317.member_1);
                                    let _e504 = array<u32, 2>(_e315.member_3, _e317.member_3);
                                    if ((((((_e475.member[0] <= _e485.member_2[0]) && (_e485.member[0] <= _e475.member_2[0])) && (_e475.member[1] <= _e485.member_2[1])) && (_e485.member[1] <= _e475.member_2[1])) && (_e475.member[2] <= _e485.member_2[2])) && (_e485.member[2] <= _e475.member_2[2])) {
                                        phi_885_ = _e495;
                                    } else {
                                        phi_885_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e530 = phi_885_;
                                    if ((((((_e475.member[0] <= _e490.member_2[0]) && (_e490.member[0] <= _e475.member_2[0])) && (_e475.member[1] <= _e490.member_2[1])) && (_e490.member[1] <= _e475.member_2[1])) && (_e475.member[2] <= _e490.member_2[2])) && (_e490.member[2] <= _e475.member_2[2])) {
                                        phi_914_ = _e498;
                                    } else {
                                        phi_914_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e555 = phi_914_;
                                    if ((((((_e480.member[0] <= _e485.member_2[0]) && (_e485.member[0] <= _e480.member_2[0])) && (_e480.member[1] <= _e485.member_2[1])) && (_e485.member[1] <= _e480.member_2[1])) && (_e480.member[2] <= _e485.member_2[2])) && (_e485.member[2] <= _e480.member_2[2])) {
                                        phi_943_ = _e501;
                                    } else {
                                        phi_943_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e580 = phi_943_;
                                    if ((((((_e480.member[0] <= _e490.member_2[0]) && (_e490.member[0] <= _e480.member_2[0])) && (_e480.member[1] <= _e490.member_2[1])) && (_e490.member[1] <= _e480.member_2[1])) && (_e480.member[2] <= _e490.member_2[2])) && (_e490.member[2] <= _e480.member_2[2])) {
                                        phi_972_ = _e504;
                                    } else {
                                        phi_972_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e605 = phi_972_;
                                    phi_974_ = type_24(array<array<u32, 2>, 4>(_e495, _e498, _e501, _e504), array<array<u32, 2>, 4>(_e530, _e555, _e580, _e605));
                                    phi_975_ = false;
                                } else {
                                    phi_974_ = type_24();
                                    phi_975_ = true;
                                }
                                let _e609 = phi_974_;
                                let _e611 = phi_975_;
                                phi_976_ = _e609;
                                phi_977_ = _e611;
                            } else {
                                phi_976_ = type_24();
                                phi_977_ = true;
                            }
                            let _e613 = phi_976_;
                            let _e615 = phi_977_;
                            if _e615 {
                                if _e472 {
                                    let _e703 = a.member[_e315.member_1];
                                    let _e708 = a.member[_e315.member_3];
                                    let _e712 = array<u32, 2>(_e315.member_1, _e281[1]);
                                    let _e714 = array<u32, 2>(_e315.member_3, _e281[1]);
                                    let _e717 = type_24(array<array<u32, 2>, 4>(_e712, _e714, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e703.member[0] <= _e317.member_2[0]) && (_e317.member[0] <= _e703.member_2[0])) && (_e703.member[1] <= _e317.member_2[1])) && (_e317.member[1] <= _e703.member_2[1])) && (_e703.member[2] <= _e317.member_2[2])) && (_e317.member[2] <= _e703.member_2[2])) {
                                        phi_1050_ = _e712;
                                    } else {
                                        phi_1050_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e744 = phi_1050_;
                                    let _e751 = type_24(_e717.member, array<array<u32, 2>, 4>(_e744, _e717.member_1[1], _e717.member_1[2], _e717.member_1[3]));
                                    if ((((((_e708.member[0] <= _e317.member_2[0]) && (_e317.member[0] <= _e708.member_2[0])) && (_e708.member[1] <= _e317.member_2[1])) && (_e317.member[1] <= _e708.member_2[1])) && (_e708.member[2] <= _e317.member_2[2])) && (_e317.member[2] <= _e708.member_2[2])) {
                                        phi_1082_ = _e714;
                                    } else {
                                        phi_1082_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e778 = phi_1082_;
                                    phi_1184_ = type_24(_e751.member, array<array<u32, 2>, 4>(_e751.member_1[0], _e778, _e751.member_1[2], _e751.member_1[3]));
                                } else {
                                    let _e618 = b.member[_e317.member_1];
                                    let _e623 = b.member[_e317.member_3];
                                    let _e627 = array<u32, 2>(_e281[0], _e317.member_1);
                                    let _e629 = array<u32, 2>(_e281[0], _e317.member_3);
                                    let _e632 = type_24(array<array<u32, 2>, 4>(_e627, _e629, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e315.member[0] <= _e618.member_2[0]) && (_e618.member[0] <= _e315.member_2[0])) && (_e315.member[1] <= _e618.member_2[1])) && (_e618.member[1] <= _e315.member_2[1])) && (_e315.member[2] <= _e618.member_2[2])) && (_e618.member[2] <= _e315.member_2[2])) {
                                        phi_1150_ = _e627;
                                    } else {
                                        phi_1150_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e659 = phi_1150_;
                                    let _e666 = type_24(_e632.member, array<array<u32, 2>, 4>(_e659, _e632.member_1[1], _e632.member_1[2], _e632.member_1[3]));
                                    if ((((((_e315.member[0] <= _e623.member_2[0]) && (_e623.member[0] <= _e315.member_2[0])) && (_e315.member[1] <= _e623.member_2[1])) && (_e623.member[1] <= _e315.member_2[1])) && (_e315.member[2] <= _e623.member_2[2])) && (_e623.member[2] <= _e315.member_2[2])) {
                                        phi_1182_ = _e629;
                                    } else {
                                        phi_1182_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e693 = phi_1182_;
                                    phi_1184_ = type_24(_e666.member, array<array<u32, 2>, 4>(_e666.member_1[0], _e693, _e666.member_1[2], _e666.member_1[3]));
                                }
                                let _e787 = phi_1184_;
                                phi_1185_ = _e787;
                            } else {
                                phi_1185_ = _e613;
                            }
                            let _e789 = phi_1185_;
                            phi_1186_ = _e789;
                            phi_1187_ = false;
                        } else {
                            phi_1186_ = type_24();
                            phi_1187_ = true;
                        }
                        let _e791 = phi_1186_;
                        let _e793 = phi_1187_;
                        phi_1188_ = _e791;
                        phi_1189_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1190_ = _e793;
                    } else {
                        phi_1188_ = type_24();
                        phi_1189_ = _e421;
                        phi_1190_ = true;
                    }
                    let _e795 = phi_1188_;
                    let _e797 = phi_1189_;
                    let _e799 = phi_1190_;
                    if _e799 {
                        phi_1194_ = _e797;
                    } else {
                        phi_1194_ = _e795;
                    }
                    let _e801 = phi_1194_;
                    let _e805 = params.member.member_2.member;
                    if (_e805 == 0u) {
                        phi_1212_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1212_ = array<u32, 2>(1u, 1u);
                    }
                    let _e808 = phi_1212_;
                    let _e814 = params.member.member.member[_e808[0]];
                    let _e815 = (_e814 - 1u);
                    let _e819 = params.member.member.member[_e808[1]];
                    let _e820 = (_e819 - 1u);
                    let _e823 = params.member.member_2.member;
                    if (_e823 == 0u) {
                        phi_1243_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1243_ = array<u32, 2>(1u, 1u);
                    }
                    let _e826 = phi_1243_;
                    let _e832 = params.member.member.member_2[_e826[0]];
                    let _e836 = params.member.member.member_2[_e826[1]];
                    let _e839 = params.member.member_2.member;
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e801.member_1[0][0], _e801.member_1[0][1]), array<u32, 2>(_e801.member_1[1][0], _e801.member_1[1][1]), array<u32, 2>(_e801.member_1[2][0], _e801.member_1[2][1]), array<u32, 2>(_e801.member_1[3][0], _e801.member_1[3][1]));
                    phi_1288_ = type_9(0u, 4u);
                    loop {
                        let _e859 = phi_1288_;
                        if (_e859.member < _e859.member_1) {
                            phi_1289_ = type_9((_e859.member + 1u), _e859.member_1);
                            phi_1312_ = type_9(1u, _e859.member);
                        } else {
                            phi_1289_ = _e859;
                            phi_1312_ = type_9(0u, type_9().member_1);
                        }
                        let _e871 = phi_1289_;
                        let _e873 = phi_1312_;
                        let _e877 = (bitcast<i32>(_e873.member) != 0i);
                        if _e877 {
                            let _e879 = local_1[_e873.member_1];
                            if (_e879[0] != 4294967295u) {
                                if (_e839 == 1u) {
                                    phi_1341_ = (_e879[0] == _e879[1]);
                                } else {
                                    phi_1341_ = false;
                                }
                                let _e885 = phi_1341_;
                                if _e885 {
                                    phi_3550_ = bool();
                                    phi_3551_ = true;
                                } else {
                                    if (_e879[0] >= _e815) {
                                        if (_e879[1] >= _e820) {
                                            phi_1353_ = false;
                                        } else {
                                            phi_1353_ = true;
                                        }
                                        let _e889 = phi_1353_;
                                        phi_1354_ = _e889;
                                    } else {
                                        phi_1354_ = true;
                                    }
                                    let _e891 = phi_1354_;
                                    if _e891 {
                                        if (_e879[0] < _e815) {
                                            let _e971 = oriented.member[(_e832 + _e879[0])];
                                            phi_1501_ = type_31(array<f32, 3>(_e971.member.x, _e971.member.y, _e971.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e971.member.w, _e971.member_1.x, _e971.member_1.y), array<f32, 3>(_e971.member_1.z, _e971.member_1.w, _e971.member_2.x), array<f32, 3>(_e971.member_2.y, _e971.member_2.z, _e971.member_2.w)), array<f32, 3>(_e971.member_3.x, _e971.member_3.y, _e971.member_3.z));
                                        } else {
                                            let _e894 = a.member[_e879[0]];
                                            let _e909 = ((_e894.member[0] * 0.5f) + (_e894.member_2[0] * 0.5f));
                                            let _e910 = ((_e894.member[1] * 0.5f) + (_e894.member_2[1] * 0.5f));
                                            let _e911 = ((_e894.member[2] * 0.5f) + (_e894.member_2[2] * 0.5f));
                                            if (_e909 < _e894.member_2[0]) {
                                                phi_1427_ = _e909;
                                            } else {
                                                phi_1427_ = _e894.member_2[0];
                                            }
                                            let _e915 = phi_1427_;
                                            if (_e910 < _e894.member_2[1]) {
                                                phi_1433_ = _e910;
                                            } else {
                                                phi_1433_ = _e894.member_2[1];
                                            }
                                            let _e919 = phi_1433_;
                                            if (_e911 < _e894.member_2[2]) {
                                                phi_1439_ = _e911;
                                            } else {
                                                phi_1439_ = _e894.member_2[2];
                                            }
                                            let _e923 = phi_1439_;
                                            if (_e915 > _e894.member[0]) {
                                                phi_1445_ = _e915;
                                            } else {
                                                phi_1445_ = _e894.member[0];
                                            }
                                            let _e927 = phi_1445_;
                                            if (_e919 > _e894.member[1]) {
                                                phi_1451_ = _e919;
                                            } else {
                                                phi_1451_ = _e894.member[1];
                                            }
                                            let _e931 = phi_1451_;
                                            if (_e923 > _e894.member[2]) {
                                                phi_1457_ = _e923;
                                            } else {
                                                phi_1457_ = _e894.member[2];
                                            }
                                            let _e935 = phi_1457_;
                                            let _e938 = (_e894.member_2[0] - _e927);
                                            let _e940 = (_e894.member_2[1] - _e931);
                                            let _e942 = (_e894.member_2[2] - _e935);
                                            let _e944 = (_e927 - _e894.member[0]);
                                            let _e946 = (_e931 - _e894.member[1]);
                                            let _e948 = (_e935 - _e894.member[2]);
                                            if (_e938 > _e944) {
                                                phi_1475_ = _e938;
                                            } else {
                                                phi_1475_ = _e944;
                                            }
                                            let _e951 = phi_1475_;
                                            if (_e940 > _e946) {
                                                phi_1480_ = _e940;
                                            } else {
                                                phi_1480_ = _e946;
                                            }
                                            let _e954 = phi_1480_;
                                            if (_e942 > _e948) {
                                                phi_1485_ = _e942;
                                            } else {
                                                phi_1485_ = _e948;
                                            }
                                            let _e957 = phi_1485_;
                                            let _e959 = (1f + (0.000000059604645f * 4f));
                                            let _e963 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1501_ = type_31(array<f32, 3>(_e927, _e931, _e935), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e951 * _e959) + _e963), ((_e954 * _e959) + _e963), ((_e957 * _e959) + _e963)));
                                        }
                                        let _e1010 = phi_1501_;
                                        if (_e879[1] < _e820) {
                                            let _e1090 = oriented.member[(_e836 + _e879[1])];
                                            phi_1645_ = type_31(array<f32, 3>(_e1090.member.x, _e1090.member.y, _e1090.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1090.member.w, _e1090.member_1.x, _e1090.member_1.y), array<f32, 3>(_e1090.member_1.z, _e1090.member_1.w, _e1090.member_2.x), array<f32, 3>(_e1090.member_2.y, _e1090.member_2.z, _e1090.member_2.w)), array<f32, 3>(_e1090.member_3.x, _e1090.member_3.y, _e1090.member_3.z));
                                        } else {
                                            let _e1013 = b.member[_e879[1]];
                                            let _e1028 = ((_e1013.member[0] * 0.5f) + (_e1013.member_2[0] * 0.5f));
                                            let _e1029 = ((_e1013.member[1] * 0.5f) + (_e1013.member_2[1] * 0.5f));
                                            let _e1030 = ((_e1013.member[2] * 0.5f) + (_e1013.member_2[2] * 0.5f));
                                            if (_e1028 < _e1013.member_2[0]) {
                                                phi_1571_ = _e1028;
                                            } else {
                                                phi_1571_ = _e1013.member_2[0];
                                            }
                                            let _e1034 = phi_1571_;
                                            if (_e1029 < _e1013.member_2[1]) {
                                                phi_1577_ = _e1029;
                                            } else {
                                                phi_1577_ = _e1013.member_2[1];
                                            }
                                            let _e1038 = phi_1577_;
                                            if (_e1030 < _e1013.member_2[2]) {
                                                phi_1583_ = _e1030;
                                            } else {
                                                phi_1583_ = _e1013.member_2[2];
                                            }
                                            let _e1042 = phi_1583_;
                                            if (_e1034 > _e1013.member[0]) {
                                                phi_1589_ = _e1034;
                                            } else {
                                                phi_1589_ = _e1013.member[0];
                                            }
                                            let _e1046 = phi_1589_;
                                            if (_e1038 > _e1013.member[1]) {
                                                phi_1595_ = _e1038;
                                            } else {
                                                phi_1595_ = _e1013.member[1];
                                            }
                                            let _e1050 = phi_1595_;
                                            if (_e1042 > _e1013.member[2]) {
                                                phi_1601_ = _e1042;
                                            } else {
                                                phi_1601_ = _e1013.member[2];
                                            }
                                            let _e1054 = phi_1601_;
                                            let _e1057 = (_e1013.member_2[0] - _e1046);
                                            let _e1059 = (_e1013.member_2[1] - _e1050);
                                            let _e1061 = (_e1013.member_2[2] - _e1054);
                                            let _e1063 = (_e1046 - _e1013.member[0]);
                                            let _e1065 = (_e1050 - _e1013.member[1]);
                                            let _e1067 = (_e1054 - _e1013.member[2]);
                                            if (_e1057 > _e1063) {
                                                phi_1619_ = _e1057;
                                            } else {
                                                phi_1619_ = _e1063;
                                            }
                                            let _e1070 = phi_1619_;
                                            if (_e1059 > _e1065) {
                                                phi_1624_ = _e1059;
                                            } else {
                                                phi_1624_ = _e1065;
                                            }
                                            let _e1073 = phi_1624_;
                                            if (_e1061 > _e1067) {
                                                phi_1629_ = _e1061;
                                            } else {
                                                phi_1629_ = _e1067;
                                            }
                                            let _e1076 = phi_1629_;
                                            let _e1078 = (1f + (0.000000059604645f * 4f));
                                            let _e1082 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1645_ = type_31(array<f32, 3>(_e1046, _e1050, _e1054), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1070 * _e1078) + _e1082), ((_e1073 * _e1078) + _e1082), ((_e1076 * _e1078) + _e1082)));
                                        }
                                        let _e1129 = phi_1645_;
                                        let _e1134 = (_e1129.member[0] - _e1010.member[0]);
                                        let _e1137 = (_e1129.member[1] - _e1010.member[1]);
                                        let _e1140 = (_e1129.member[2] - _e1010.member[2]);
                                        if (_e1134 < 0f) {
                                            phi_1835_ = -(_e1134);
                                        } else {
                                            phi_1835_ = _e1134;
                                        }
                                        let _e1329 = phi_1835_;
                                        if (_e1137 < 0f) {
                                            phi_1841_ = -(_e1137);
                                        } else {
                                            phi_1841_ = _e1137;
                                        }
                                        let _e1333 = phi_1841_;
                                        if (_e1140 < 0f) {
                                            phi_1848_ = -(_e1140);
                                        } else {
                                            phi_1848_ = _e1140;
                                        }
                                        let _e1338 = phi_1848_;
                                        if (_e1010.member_2[0] < 0f) {
                                            phi_1857_ = -(_e1010.member_2[0]);
                                        } else {
                                            phi_1857_ = _e1010.member_2[0];
                                        }
                                        let _e1345 = phi_1857_;
                                        if (_e1010.member_2[1] < 0f) {
                                            phi_1864_ = -(_e1010.member_2[1]);
                                        } else {
                                            phi_1864_ = _e1010.member_2[1];
                                        }
                                        let _e1350 = phi_1864_;
                                        if (_e1010.member_2[2] < 0f) {
                                            phi_1872_ = -(_e1010.member_2[2]);
                                        } else {
                                            phi_1872_ = _e1010.member_2[2];
                                        }
                                        let _e1356 = phi_1872_;
                                        if (_e1129.member_2[0] < 0f) {
                                            phi_1881_ = -(_e1129.member_2[0]);
                                        } else {
                                            phi_1881_ = _e1129.member_2[0];
                                        }
                                        let _e1363 = phi_1881_;
                                        if (_e1129.member_2[1] < 0f) {
                                            phi_1888_ = -(_e1129.member_2[1]);
                                        } else {
                                            phi_1888_ = _e1129.member_2[1];
                                        }
                                        let _e1368 = phi_1888_;
                                        if (_e1129.member_2[2] < 0f) {
                                            phi_1896_ = -(_e1129.member_2[2]);
                                        } else {
                                            phi_1896_ = _e1129.member_2[2];
                                        }
                                        let _e1374 = phi_1896_;
                                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e1129.member_1[0][0] * _e1010.member_1[0][0]) + (_e1129.member_1[0][1] * _e1010.member_1[0][1])) + (_e1129.member_1[0][2] * _e1010.member_1[0][2])), (((_e1129.member_1[1][0] * _e1010.member_1[0][0]) + (_e1129.member_1[1][1] * _e1010.member_1[0][1])) + (_e1129.member_1[1][2] * _e1010.member_1[0][2])), (((_e1129.member_1[2][0] * _e1010.member_1[0][0]) + (_e1129.member_1[2][1] * _e1010.member_1[0][1])) + (_e1129.member_1[2][2] * _e1010.member_1[0][2]))), array<f32, 3>((((_e1129.member_1[0][0] * _e1010.member_1[1][0]) + (_e1129.member_1[0][1] * _e1010.member_1[1][1])) + (_e1129.member_1[0][2] * _e1010.member_1[1][2])), (((_e1129.member_1[1][0] * _e1010.member_1[1][0]) + (_e1129.member_1[1][1] * _e1010.member_1[1][1])) + (_e1129.member_1[1][2] * _e1010.member_1[1][2])), (((_e1129.member_1[2][0] * _e1010.member_1[1][0]) + (_e1129.member_1[2][1] * _e1010.member_1[1][1])) + (_e1129.member_1[2][2] * _e1010.member_1[1][2]))), array<f32, 3>((((_e1129.member_1[0][0] * _e1010.member_1[2][0]) + (_e1129.member_1[0][1] * _e1010.member_1[2][1])) + (_e1129.member_1[0][2] * _e1010.member_1[2][2])), (((_e1129.member_1[1][0] * _e1010.member_1[2][0]) + (_e1129.member_1[1][1] * _e1010.member_1[2][1])) + (_e1129.member_1[1][2] * _e1010.member_1[2][2])), (((_e1129.member_1[2][0] * _e1010.member_1[2][0]) + (_e1129.member_1[2][1] * _e1010.member_1[2][1])) + (_e1129.member_1[2][2] * _e1010.member_1[2][2])))), array<f32, 3>((((_e1010.member_1[0][0] * _e1134) + (_e1010.member_1[0][1] * _e1137)) + (_e1010.member_1[0][2] * _e1140)), (((_e1010.member_1[1][0] * _e1134) + (_e1010.member_1[1][1] * _e1137)) + (_e1010.member_1[1][2] * _e1140)), (((_e1010.member_1[2][0] * _e1134) + (_e1010.member_1[2][1] * _e1137)) + (_e1010.member_1[2][2] * _e1140))), array<f32, 3>((((_e1129.member_1[0][0] * _e1134) + (_e1129.member_1[0][1] * _e1137)) + (_e1129.member_1[0][2] * _e1140)), (((_e1129.member_1[1][0] * _e1134) + (_e1129.member_1[1][1] * _e1137)) + (_e1129.member_1[1][2] * _e1140)), (((_e1129.member_1[2][0] * _e1134) + (_e1129.member_1[2][1] * _e1137)) + (_e1129.member_1[2][2] * _e1140))), array<f32, 3>(_e1010.member_2[0], _e1010.member_2[1], _e1010.member_2[2]), array<f32, 3>(_e1129.member_2[0], _e1129.member_2[1], _e1129.member_2[2]), ((((((_e1329 + _e1333) + _e1338) + (((_e1345 + _e1350) + _e1356) + ((_e1363 + _e1368) + _e1374))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1401 = local.member[0u][0u];
                                        let _e1405 = local.member[0u][1u];
                                        let _e1409 = local.member[0u][2u];
                                        let _e1413 = local.member[1u][0u];
                                        let _e1417 = local.member[1u][1u];
                                        let _e1421 = local.member[1u][2u];
                                        let _e1425 = local.member[2u][0u];
                                        let _e1429 = local.member[2u][1u];
                                        let _e1433 = local.member[2u][2u];
                                        let _e1435 = local.member_3;
                                        let _e1440 = local.member_4;
                                        let _e1446 = local.member_1[0u];
                                        if (_e1446 < 0f) {
                                            phi_1989_ = -(_e1446);
                                        } else {
                                            phi_1989_ = _e1446;
                                        }
                                        let _e1450 = phi_1989_;
                                        if (_e1401 < 0f) {
                                            phi_1996_ = -(_e1401);
                                        } else {
                                            phi_1996_ = _e1401;
                                        }
                                        let _e1454 = phi_1996_;
                                        if (_e1405 < 0f) {
                                            phi_2002_ = -(_e1405);
                                        } else {
                                            phi_2002_ = _e1405;
                                        }
                                        let _e1458 = phi_2002_;
                                        if (_e1409 < 0f) {
                                            phi_2008_ = -(_e1409);
                                        } else {
                                            phi_2008_ = _e1409;
                                        }
                                        let _e1462 = phi_2008_;
                                        let _e1469 = (_e1450 - (_e1435[0] + (((_e1454 * _e1440[0]) + (_e1458 * _e1440[1])) + (_e1462 * _e1440[2]))));
                                        let _e1472 = local.member_1[1u];
                                        if (_e1472 < 0f) {
                                            phi_2027_ = -(_e1472);
                                        } else {
                                            phi_2027_ = _e1472;
                                        }
                                        let _e1476 = phi_2027_;
                                        if (_e1413 < 0f) {
                                            phi_2034_ = -(_e1413);
                                        } else {
                                            phi_2034_ = _e1413;
                                        }
                                        let _e1480 = phi_2034_;
                                        if (_e1417 < 0f) {
                                            phi_2040_ = -(_e1417);
                                        } else {
                                            phi_2040_ = _e1417;
                                        }
                                        let _e1484 = phi_2040_;
                                        if (_e1421 < 0f) {
                                            phi_2046_ = -(_e1421);
                                        } else {
                                            phi_2046_ = _e1421;
                                        }
                                        let _e1488 = phi_2046_;
                                        let _e1495 = (_e1476 - (_e1435[1] + (((_e1480 * _e1440[0]) + (_e1484 * _e1440[1])) + (_e1488 * _e1440[2]))));
                                        let _e1498 = local.member_1[2u];
                                        if (_e1498 < 0f) {
                                            phi_2065_ = -(_e1498);
                                        } else {
                                            phi_2065_ = _e1498;
                                        }
                                        let _e1502 = phi_2065_;
                                        if (_e1425 < 0f) {
                                            phi_2072_ = -(_e1425);
                                        } else {
                                            phi_2072_ = _e1425;
                                        }
                                        let _e1506 = phi_2072_;
                                        if (_e1429 < 0f) {
                                            phi_2078_ = -(_e1429);
                                        } else {
                                            phi_2078_ = _e1429;
                                        }
                                        let _e1510 = phi_2078_;
                                        if (_e1433 < 0f) {
                                            phi_2084_ = -(_e1433);
                                        } else {
                                            phi_2084_ = _e1433;
                                        }
                                        let _e1514 = phi_2084_;
                                        let _e1521 = (_e1502 - (_e1435[2] + (((_e1506 * _e1440[0]) + (_e1510 * _e1440[1])) + (_e1514 * _e1440[2]))));
                                        let _e1524 = local.member_2[0u];
                                        if (_e1524 < 0f) {
                                            phi_2103_ = -(_e1524);
                                        } else {
                                            phi_2103_ = _e1524;
                                        }
                                        let _e1528 = phi_2103_;
                                        if (_e1401 < 0f) {
                                            phi_2110_ = -(_e1401);
                                        } else {
                                            phi_2110_ = _e1401;
                                        }
                                        let _e1532 = phi_2110_;
                                        if (_e1413 < 0f) {
                                            phi_2116_ = -(_e1413);
                                        } else {
                                            phi_2116_ = _e1413;
                                        }
                                        let _e1536 = phi_2116_;
                                        if (_e1425 < 0f) {
                                            phi_2122_ = -(_e1425);
                                        } else {
                                            phi_2122_ = _e1425;
                                        }
                                        let _e1540 = phi_2122_;
                                        let _e1547 = (_e1528 - (_e1440[0] + (((_e1532 * _e1435[0]) + (_e1536 * _e1435[1])) + (_e1540 * _e1435[2]))));
                                        let _e1550 = local.member_2[1u];
                                        if (_e1550 < 0f) {
                                            phi_2141_ = -(_e1550);
                                        } else {
                                            phi_2141_ = _e1550;
                                        }
                                        let _e1554 = phi_2141_;
                                        if (_e1405 < 0f) {
                                            phi_2148_ = -(_e1405);
                                        } else {
                                            phi_2148_ = _e1405;
                                        }
                                        let _e1558 = phi_2148_;
                                        if (_e1417 < 0f) {
                                            phi_2154_ = -(_e1417);
                                        } else {
                                            phi_2154_ = _e1417;
                                        }
                                        let _e1562 = phi_2154_;
                                        if (_e1429 < 0f) {
                                            phi_2160_ = -(_e1429);
                                        } else {
                                            phi_2160_ = _e1429;
                                        }
                                        let _e1566 = phi_2160_;
                                        let _e1573 = (_e1554 - (_e1440[1] + (((_e1558 * _e1435[0]) + (_e1562 * _e1435[1])) + (_e1566 * _e1435[2]))));
                                        let _e1576 = local.member_2[2u];
                                        if (_e1576 < 0f) {
                                            phi_2179_ = -(_e1576);
                                        } else {
                                            phi_2179_ = _e1576;
                                        }
                                        let _e1580 = phi_2179_;
                                        if (_e1409 < 0f) {
                                            phi_2186_ = -(_e1409);
                                        } else {
                                            phi_2186_ = _e1409;
                                        }
                                        let _e1584 = phi_2186_;
                                        if (_e1421 < 0f) {
                                            phi_2192_ = -(_e1421);
                                        } else {
                                            phi_2192_ = _e1421;
                                        }
                                        let _e1588 = phi_2192_;
                                        if (_e1433 < 0f) {
                                            phi_2198_ = -(_e1433);
                                        } else {
                                            phi_2198_ = _e1433;
                                        }
                                        let _e1592 = phi_2198_;
                                        let _e1599 = (_e1580 - (_e1440[2] + (((_e1584 * _e1435[0]) + (_e1588 * _e1435[1])) + (_e1592 * _e1435[2]))));
                                        if (_e1469 > _e1495) {
                                            phi_2213_ = _e1469;
                                        } else {
                                            phi_2213_ = _e1495;
                                        }
                                        let _e1602 = phi_2213_;
                                        if (_e1602 > _e1521) {
                                            phi_2218_ = _e1602;
                                        } else {
                                            phi_2218_ = _e1521;
                                        }
                                        let _e1605 = phi_2218_;
                                        if (_e1547 > _e1573) {
                                            phi_2223_ = _e1547;
                                        } else {
                                            phi_2223_ = _e1573;
                                        }
                                        let _e1608 = phi_2223_;
                                        if (_e1608 > _e1599) {
                                            phi_2228_ = _e1608;
                                        } else {
                                            phi_2228_ = _e1599;
                                        }
                                        let _e1611 = phi_2228_;
                                        if (_e1605 > _e1611) {
                                            phi_2233_ = _e1605;
                                        } else {
                                            phi_2233_ = _e1611;
                                        }
                                        let _e1614 = phi_2233_;
                                        let _e1616 = local.member_5;
                                        if (_e1614 > _e1616) {
                                            phi_3546_ = true;
                                        } else {
                                            let _e1621 = local.member[1u][0u];
                                            let _e1624 = local.member_1[2u];
                                            let _e1629 = local.member[2u][0u];
                                            let _e1632 = local.member_1[1u];
                                            let _e1634 = ((_e1621 * _e1624) - (_e1629 * _e1632));
                                            let _e1638 = local.member[2u][0u];
                                            if (_e1638 < 0f) {
                                                phi_2292_ = -(_e1638);
                                            } else {
                                                phi_2292_ = _e1638;
                                            }
                                            let _e1642 = phi_2292_;
                                            let _e1645 = local.member_3[1u];
                                            let _e1650 = local.member[1u][0u];
                                            if (_e1650 < 0f) {
                                                phi_2315_ = -(_e1650);
                                            } else {
                                                phi_2315_ = _e1650;
                                            }
                                            let _e1654 = phi_2315_;
                                            let _e1657 = local.member_3[2u];
                                            let _e1663 = local.member[0u][2u];
                                            if (_e1663 < 0f) {
                                                phi_2338_ = -(_e1663);
                                            } else {
                                                phi_2338_ = _e1663;
                                            }
                                            let _e1667 = phi_2338_;
                                            let _e1670 = local.member_4[1u];
                                            let _e1675 = local.member[0u][1u];
                                            if (_e1675 < 0f) {
                                                phi_2360_ = -(_e1675);
                                            } else {
                                                phi_2360_ = _e1675;
                                            }
                                            let _e1679 = phi_2360_;
                                            let _e1682 = local.member_4[2u];
                                            if (_e1634 < 0f) {
                                                phi_2376_ = -(_e1634);
                                            } else {
                                                phi_2376_ = _e1634;
                                            }
                                            let _e1688 = phi_2376_;
                                            let _e1690 = (_e1688 - (((_e1642 * _e1645) + (_e1654 * _e1657)) + ((_e1667 * _e1670) + (_e1679 * _e1682))));
                                            let _e1694 = local.member[1u][1u];
                                            let _e1697 = local.member_1[2u];
                                            let _e1702 = local.member[2u][1u];
                                            let _e1705 = local.member_1[1u];
                                            let _e1707 = ((_e1694 * _e1697) - (_e1702 * _e1705));
                                            let _e1711 = local.member[2u][1u];
                                            if (_e1711 < 0f) {
                                                phi_2431_ = -(_e1711);
                                            } else {
                                                phi_2431_ = _e1711;
                                            }
                                            let _e1715 = phi_2431_;
                                            let _e1718 = local.member_3[1u];
                                            let _e1723 = local.member[1u][1u];
                                            if (_e1723 < 0f) {
                                                phi_2454_ = -(_e1723);
                                            } else {
                                                phi_2454_ = _e1723;
                                            }
                                            let _e1727 = phi_2454_;
                                            let _e1730 = local.member_3[2u];
                                            let _e1736 = local.member[0u][0u];
                                            if (_e1736 < 0f) {
                                                phi_2477_ = -(_e1736);
                                            } else {
                                                phi_2477_ = _e1736;
                                            }
                                            let _e1740 = phi_2477_;
                                            let _e1743 = local.member_4[2u];
                                            let _e1748 = local.member[0u][2u];
                                            if (_e1748 < 0f) {
                                                phi_2499_ = -(_e1748);
                                            } else {
                                                phi_2499_ = _e1748;
                                            }
                                            let _e1752 = phi_2499_;
                                            let _e1755 = local.member_4[0u];
                                            if (_e1707 < 0f) {
                                                phi_2515_ = -(_e1707);
                                            } else {
                                                phi_2515_ = _e1707;
                                            }
                                            let _e1761 = phi_2515_;
                                            let _e1763 = (_e1761 - (((_e1715 * _e1718) + (_e1727 * _e1730)) + ((_e1740 * _e1743) + (_e1752 * _e1755))));
                                            let _e1767 = local.member[1u][2u];
                                            let _e1770 = local.member_1[2u];
                                            let _e1775 = local.member[2u][2u];
                                            let _e1778 = local.member_1[1u];
                                            let _e1780 = ((_e1767 * _e1770) - (_e1775 * _e1778));
                                            let _e1784 = local.member[2u][2u];
                                            if (_e1784 < 0f) {
                                                phi_2570_ = -(_e1784);
                                            } else {
                                                phi_2570_ = _e1784;
                                            }
                                            let _e1788 = phi_2570_;
                                            let _e1791 = local.member_3[1u];
                                            let _e1796 = local.member[1u][2u];
                                            if (_e1796 < 0f) {
                                                phi_2593_ = -(_e1796);
                                            } else {
                                                phi_2593_ = _e1796;
                                            }
                                            let _e1800 = phi_2593_;
                                            let _e1803 = local.member_3[2u];
                                            let _e1809 = local.member[0u][1u];
                                            if (_e1809 < 0f) {
                                                phi_2616_ = -(_e1809);
                                            } else {
                                                phi_2616_ = _e1809;
                                            }
                                            let _e1813 = phi_2616_;
                                            let _e1816 = local.member_4[0u];
                                            let _e1821 = local.member[0u][0u];
                                            if (_e1821 < 0f) {
                                                phi_2638_ = -(_e1821);
                                            } else {
                                                phi_2638_ = _e1821;
                                            }
                                            let _e1825 = phi_2638_;
                                            let _e1828 = local.member_4[1u];
                                            if (_e1780 < 0f) {
                                                phi_2654_ = -(_e1780);
                                            } else {
                                                phi_2654_ = _e1780;
                                            }
                                            let _e1834 = phi_2654_;
                                            let _e1836 = (_e1834 - (((_e1788 * _e1791) + (_e1800 * _e1803)) + ((_e1813 * _e1816) + (_e1825 * _e1828))));
                                            let _e1840 = local.member[2u][0u];
                                            let _e1843 = local.member_1[0u];
                                            let _e1848 = local.member[0u][0u];
                                            let _e1851 = local.member_1[2u];
                                            let _e1853 = ((_e1840 * _e1843) - (_e1848 * _e1851));
                                            let _e1857 = local.member[0u][0u];
                                            if (_e1857 < 0f) {
                                                phi_2709_ = -(_e1857);
                                            } else {
                                                phi_2709_ = _e1857;
                                            }
                                            let _e1861 = phi_2709_;
                                            let _e1864 = local.member_3[2u];
                                            let _e1869 = local.member[2u][0u];
                                            if (_e1869 < 0f) {
                                                phi_2732_ = -(_e1869);
                                            } else {
                                                phi_2732_ = _e1869;
                                            }
                                            let _e1873 = phi_2732_;
                                            let _e1876 = local.member_3[0u];
                                            let _e1882 = local.member[1u][2u];
                                            if (_e1882 < 0f) {
                                                phi_2756_ = -(_e1882);
                                            } else {
                                                phi_2756_ = _e1882;
                                            }
                                            let _e1886 = phi_2756_;
                                            let _e1889 = local.member_4[1u];
                                            let _e1894 = local.member[1u][1u];
                                            if (_e1894 < 0f) {
                                                phi_2779_ = -(_e1894);
                                            } else {
                                                phi_2779_ = _e1894;
                                            }
                                            let _e1898 = phi_2779_;
                                            let _e1901 = local.member_4[2u];
                                            if (_e1853 < 0f) {
                                                phi_2795_ = -(_e1853);
                                            } else {
                                                phi_2795_ = _e1853;
                                            }
                                            let _e1907 = phi_2795_;
                                            let _e1909 = (_e1907 - (((_e1861 * _e1864) + (_e1873 * _e1876)) + ((_e1886 * _e1889) + (_e1898 * _e1901))));
                                            let _e1913 = local.member[2u][1u];
                                            let _e1916 = local.member_1[0u];
                                            let _e1921 = local.member[0u][1u];
                                            let _e1924 = local.member_1[2u];
                                            let _e1926 = ((_e1913 * _e1916) - (_e1921 * _e1924));
                                            let _e1930 = local.member[0u][1u];
                                            if (_e1930 < 0f) {
                                                phi_2850_ = -(_e1930);
                                            } else {
                                                phi_2850_ = _e1930;
                                            }
                                            let _e1934 = phi_2850_;
                                            let _e1937 = local.member_3[2u];
                                            let _e1942 = local.member[2u][1u];
                                            if (_e1942 < 0f) {
                                                phi_2873_ = -(_e1942);
                                            } else {
                                                phi_2873_ = _e1942;
                                            }
                                            let _e1946 = phi_2873_;
                                            let _e1949 = local.member_3[0u];
                                            let _e1955 = local.member[1u][0u];
                                            if (_e1955 < 0f) {
                                                phi_2897_ = -(_e1955);
                                            } else {
                                                phi_2897_ = _e1955;
                                            }
                                            let _e1959 = phi_2897_;
                                            let _e1962 = local.member_4[2u];
                                            let _e1967 = local.member[1u][2u];
                                            if (_e1967 < 0f) {
                                                phi_2920_ = -(_e1967);
                                            } else {
                                                phi_2920_ = _e1967;
                                            }
                                            let _e1971 = phi_2920_;
                                            let _e1974 = local.member_4[0u];
                                            if (_e1926 < 0f) {
                                                phi_2936_ = -(_e1926);
                                            } else {
                                                phi_2936_ = _e1926;
                                            }
                                            let _e1980 = phi_2936_;
                                            let _e1982 = (_e1980 - (((_e1934 * _e1937) + (_e1946 * _e1949)) + ((_e1959 * _e1962) + (_e1971 * _e1974))));
                                            let _e1986 = local.member[2u][2u];
                                            let _e1989 = local.member_1[0u];
                                            let _e1994 = local.member[0u][2u];
                                            let _e1997 = local.member_1[2u];
                                            let _e1999 = ((_e1986 * _e1989) - (_e1994 * _e1997));
                                            let _e2003 = local.member[0u][2u];
                                            if (_e2003 < 0f) {
                                                phi_2991_ = -(_e2003);
                                            } else {
                                                phi_2991_ = _e2003;
                                            }
                                            let _e2007 = phi_2991_;
                                            let _e2010 = local.member_3[2u];
                                            let _e2015 = local.member[2u][2u];
                                            if (_e2015 < 0f) {
                                                phi_3014_ = -(_e2015);
                                            } else {
                                                phi_3014_ = _e2015;
                                            }
                                            let _e2019 = phi_3014_;
                                            let _e2022 = local.member_3[0u];
                                            let _e2028 = local.member[1u][1u];
                                            if (_e2028 < 0f) {
                                                phi_3038_ = -(_e2028);
                                            } else {
                                                phi_3038_ = _e2028;
                                            }
                                            let _e2032 = phi_3038_;
                                            let _e2035 = local.member_4[0u];
                                            let _e2040 = local.member[1u][0u];
                                            if (_e2040 < 0f) {
                                                phi_3061_ = -(_e2040);
                                            } else {
                                                phi_3061_ = _e2040;
                                            }
                                            let _e2044 = phi_3061_;
                                            let _e2047 = local.member_4[1u];
                                            if (_e1999 < 0f) {
                                                phi_3077_ = -(_e1999);
                                            } else {
                                                phi_3077_ = _e1999;
                                            }
                                            let _e2053 = phi_3077_;
                                            let _e2055 = (_e2053 - (((_e2007 * _e2010) + (_e2019 * _e2022)) + ((_e2032 * _e2035) + (_e2044 * _e2047))));
                                            let _e2059 = local.member[0u][0u];
                                            let _e2062 = local.member_1[1u];
                                            let _e2067 = local.member[1u][0u];
                                            let _e2070 = local.member_1[0u];
                                            let _e2072 = ((_e2059 * _e2062) - (_e2067 * _e2070));
                                            let _e2076 = local.member[1u][0u];
                                            if (_e2076 < 0f) {
                                                phi_3132_ = -(_e2076);
                                            } else {
                                                phi_3132_ = _e2076;
                                            }
                                            let _e2080 = phi_3132_;
                                            let _e2083 = local.member_3[0u];
                                            let _e2088 = local.member[0u][0u];
                                            if (_e2088 < 0f) {
                                                phi_3155_ = -(_e2088);
                                            } else {
                                                phi_3155_ = _e2088;
                                            }
                                            let _e2092 = phi_3155_;
                                            let _e2095 = local.member_3[1u];
                                            let _e2101 = local.member[2u][2u];
                                            if (_e2101 < 0f) {
                                                phi_3179_ = -(_e2101);
                                            } else {
                                                phi_3179_ = _e2101;
                                            }
                                            let _e2105 = phi_3179_;
                                            let _e2108 = local.member_4[1u];
                                            let _e2113 = local.member[2u][1u];
                                            if (_e2113 < 0f) {
                                                phi_3202_ = -(_e2113);
                                            } else {
                                                phi_3202_ = _e2113;
                                            }
                                            let _e2117 = phi_3202_;
                                            let _e2120 = local.member_4[2u];
                                            if (_e2072 < 0f) {
                                                phi_3218_ = -(_e2072);
                                            } else {
                                                phi_3218_ = _e2072;
                                            }
                                            let _e2126 = phi_3218_;
                                            let _e2128 = (_e2126 - (((_e2080 * _e2083) + (_e2092 * _e2095)) + ((_e2105 * _e2108) + (_e2117 * _e2120))));
                                            let _e2132 = local.member[0u][1u];
                                            let _e2135 = local.member_1[1u];
                                            let _e2140 = local.member[1u][1u];
                                            let _e2143 = local.member_1[0u];
                                            let _e2145 = ((_e2132 * _e2135) - (_e2140 * _e2143));
                                            let _e2149 = local.member[1u][1u];
                                            if (_e2149 < 0f) {
                                                phi_3273_ = -(_e2149);
                                            } else {
                                                phi_3273_ = _e2149;
                                            }
                                            let _e2153 = phi_3273_;
                                            let _e2156 = local.member_3[0u];
                                            let _e2161 = local.member[0u][1u];
                                            if (_e2161 < 0f) {
                                                phi_3296_ = -(_e2161);
                                            } else {
                                                phi_3296_ = _e2161;
                                            }
                                            let _e2165 = phi_3296_;
                                            let _e2168 = local.member_3[1u];
                                            let _e2174 = local.member[2u][0u];
                                            if (_e2174 < 0f) {
                                                phi_3320_ = -(_e2174);
                                            } else {
                                                phi_3320_ = _e2174;
                                            }
                                            let _e2178 = phi_3320_;
                                            let _e2181 = local.member_4[2u];
                                            let _e2186 = local.member[2u][2u];
                                            if (_e2186 < 0f) {
                                                phi_3343_ = -(_e2186);
                                            } else {
                                                phi_3343_ = _e2186;
                                            }
                                            let _e2190 = phi_3343_;
                                            let _e2193 = local.member_4[0u];
                                            if (_e2145 < 0f) {
                                                phi_3359_ = -(_e2145);
                                            } else {
                                                phi_3359_ = _e2145;
                                            }
                                            let _e2199 = phi_3359_;
                                            let _e2201 = (_e2199 - (((_e2153 * _e2156) + (_e2165 * _e2168)) + ((_e2178 * _e2181) + (_e2190 * _e2193))));
                                            let _e2205 = local.member[0u][2u];
                                            let _e2208 = local.member_1[1u];
                                            let _e2213 = local.member[1u][2u];
                                            let _e2216 = local.member_1[0u];
                                            let _e2218 = ((_e2205 * _e2208) - (_e2213 * _e2216));
                                            let _e2222 = local.member[1u][2u];
                                            if (_e2222 < 0f) {
                                                phi_3414_ = -(_e2222);
                                            } else {
                                                phi_3414_ = _e2222;
                                            }
                                            let _e2226 = phi_3414_;
                                            let _e2229 = local.member_3[0u];
                                            let _e2234 = local.member[0u][2u];
                                            if (_e2234 < 0f) {
                                                phi_3437_ = -(_e2234);
                                            } else {
                                                phi_3437_ = _e2234;
                                            }
                                            let _e2238 = phi_3437_;
                                            let _e2241 = local.member_3[1u];
                                            let _e2247 = local.member[2u][1u];
                                            if (_e2247 < 0f) {
                                                phi_3461_ = -(_e2247);
                                            } else {
                                                phi_3461_ = _e2247;
                                            }
                                            let _e2251 = phi_3461_;
                                            let _e2254 = local.member_4[0u];
                                            let _e2259 = local.member[2u][0u];
                                            if (_e2259 < 0f) {
                                                phi_3484_ = -(_e2259);
                                            } else {
                                                phi_3484_ = _e2259;
                                            }
                                            let _e2263 = phi_3484_;
                                            let _e2266 = local.member_4[1u];
                                            if (_e2218 < 0f) {
                                                phi_3500_ = -(_e2218);
                                            } else {
                                                phi_3500_ = _e2218;
                                            }
                                            let _e2272 = phi_3500_;
                                            let _e2274 = (_e2272 - (((_e2226 * _e2229) + (_e2238 * _e2241)) + ((_e2251 * _e2254) + (_e2263 * _e2266))));
                                            if (_e1690 > _e1763) {
                                                phi_3507_ = _e1690;
                                            } else {
                                                phi_3507_ = _e1763;
                                            }
                                            let _e2277 = phi_3507_;
                                            if (_e2277 > _e1836) {
                                                phi_3512_ = _e2277;
                                            } else {
                                                phi_3512_ = _e1836;
                                            }
                                            let _e2280 = phi_3512_;
                                            if (_e1909 > _e1982) {
                                                phi_3517_ = _e1909;
                                            } else {
                                                phi_3517_ = _e1982;
                                            }
                                            let _e2283 = phi_3517_;
                                            if (_e2283 > _e2055) {
                                                phi_3522_ = _e2283;
                                            } else {
                                                phi_3522_ = _e2055;
                                            }
                                            let _e2286 = phi_3522_;
                                            if (_e2280 > _e2286) {
                                                phi_3527_ = _e2280;
                                            } else {
                                                phi_3527_ = _e2286;
                                            }
                                            let _e2289 = phi_3527_;
                                            if (_e2128 > _e2201) {
                                                phi_3532_ = _e2128;
                                            } else {
                                                phi_3532_ = _e2201;
                                            }
                                            let _e2292 = phi_3532_;
                                            if (_e2292 > _e2274) {
                                                phi_3537_ = _e2292;
                                            } else {
                                                phi_3537_ = _e2274;
                                            }
                                            let _e2295 = phi_3537_;
                                            if (_e2289 > _e2295) {
                                                phi_3542_ = _e2289;
                                            } else {
                                                phi_3542_ = _e2295;
                                            }
                                            let _e2298 = phi_3542_;
                                            let _e2300 = local.member_5;
                                            phi_3546_ = (_e2298 > _e2300);
                                        }
                                        let _e2303 = phi_3546_;
                                        phi_3548_ = !(_e2303);
                                        phi_3549_ = false;
                                    } else {
                                        phi_3548_ = bool();
                                        phi_3549_ = true;
                                    }
                                    let _e2306 = phi_3548_;
                                    let _e2308 = phi_3549_;
                                    phi_3550_ = _e2306;
                                    phi_3551_ = _e2308;
                                }
                                let _e2310 = phi_3550_;
                                let _e2312 = phi_3551_;
                                if _e2312 {
                                    phi_3555_ = true;
                                } else {
                                    phi_3555_ = _e2310;
                                }
                                let _e2314 = phi_3555_;
                                if _e2314 {
                                } else {
                                    local_1[_e873.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1288_ = _e871;
                            break if !(_e877);
                        }
                    }
                    let _e2317 = local_1;
                    let _e2321 = array<u32, 2>(_e2317[0][0], _e2317[0][1]);
                    let _e2325 = array<u32, 2>(_e2317[1][0], _e2317[1][1]);
                    let _e2329 = array<u32, 2>(_e2317[2][0], _e2317[2][1]);
                    let _e2333 = array<u32, 2>(_e2317[3][0], _e2317[3][1]);
                    let _e2337 = params.member.member_2.member_4;
                    if (_e2337 > 0u) {
                        phi_3592_ = _e801.member;
                    } else {
                        phi_3592_ = array<array<u32, 2>, 4>(_e2321, _e2325, _e2329, _e2333);
                    }
                    let _e2341 = phi_3592_;
                    if (_e2317[0][0] == 4294967295u) {
                        phi_3616_ = 0u;
                    } else {
                        if (_e2317[0][0] >= _e298) {
                            if (_e2317[0][1] >= _e303) {
                                phi_3610_ = false;
                            } else {
                                phi_3610_ = true;
                            }
                            let _e2347 = phi_3610_;
                            phi_3611_ = _e2347;
                        } else {
                            phi_3611_ = true;
                        }
                        let _e2349 = phi_3611_;
                        if _e2349 {
                            phi_3615_ = 1u;
                        } else {
                            phi_3615_ = 2u;
                        }
                        let _e2351 = phi_3615_;
                        phi_3616_ = _e2351;
                    }
                    let _e2353 = phi_3616_;
                    let _e2354 = type_32(_e2321, _e2353);
                    if (_e2353 == 0u) {
                        if (_e2341[0][0] != 4294967295u) {
                            phi_3628_ = type_32(_e2341[0], 3u);
                        } else {
                            phi_3628_ = _e2354;
                        }
                        let _e2360 = phi_3628_;
                        phi_3629_ = _e2360;
                    } else {
                        phi_3629_ = _e2354;
                    }
                    let _e2362 = phi_3629_;
                    if (_e2317[1][0] == 4294967295u) {
                        phi_3653_ = 0u;
                    } else {
                        if (_e2317[1][0] >= _e298) {
                            if (_e2317[1][1] >= _e303) {
                                phi_3647_ = false;
                            } else {
                                phi_3647_ = true;
                            }
                            let _e2368 = phi_3647_;
                            phi_3648_ = _e2368;
                        } else {
                            phi_3648_ = true;
                        }
                        let _e2370 = phi_3648_;
                        if _e2370 {
                            phi_3652_ = 1u;
                        } else {
                            phi_3652_ = 2u;
                        }
                        let _e2372 = phi_3652_;
                        phi_3653_ = _e2372;
                    }
                    let _e2374 = phi_3653_;
                    let _e2375 = type_32(_e2325, _e2374);
                    if (_e2374 == 0u) {
                        if (_e2341[1][0] != 4294967295u) {
                            phi_3665_ = type_32(_e2341[1], 3u);
                        } else {
                            phi_3665_ = _e2375;
                        }
                        let _e2381 = phi_3665_;
                        phi_3666_ = _e2381;
                    } else {
                        phi_3666_ = _e2375;
                    }
                    let _e2383 = phi_3666_;
                    if (_e2317[2][0] == 4294967295u) {
                        phi_3690_ = 0u;
                    } else {
                        if (_e2317[2][0] >= _e298) {
                            if (_e2317[2][1] >= _e303) {
                                phi_3684_ = false;
                            } else {
                                phi_3684_ = true;
                            }
                            let _e2389 = phi_3684_;
                            phi_3685_ = _e2389;
                        } else {
                            phi_3685_ = true;
                        }
                        let _e2391 = phi_3685_;
                        if _e2391 {
                            phi_3689_ = 1u;
                        } else {
                            phi_3689_ = 2u;
                        }
                        let _e2393 = phi_3689_;
                        phi_3690_ = _e2393;
                    }
                    let _e2395 = phi_3690_;
                    let _e2396 = type_32(_e2329, _e2395);
                    if (_e2395 == 0u) {
                        if (_e2341[2][0] != 4294967295u) {
                            phi_3702_ = type_32(_e2341[2], 3u);
                        } else {
                            phi_3702_ = _e2396;
                        }
                        let _e2402 = phi_3702_;
                        phi_3703_ = _e2402;
                    } else {
                        phi_3703_ = _e2396;
                    }
                    let _e2404 = phi_3703_;
                    if (_e2317[3][0] == 4294967295u) {
                        phi_3727_ = 0u;
                    } else {
                        if (_e2317[3][0] >= _e298) {
                            if (_e2317[3][1] >= _e303) {
                                phi_3721_ = false;
                            } else {
                                phi_3721_ = true;
                            }
                            let _e2410 = phi_3721_;
                            phi_3722_ = _e2410;
                        } else {
                            phi_3722_ = true;
                        }
                        let _e2412 = phi_3722_;
                        if _e2412 {
                            phi_3726_ = 1u;
                        } else {
                            phi_3726_ = 2u;
                        }
                        let _e2414 = phi_3726_;
                        phi_3727_ = _e2414;
                    }
                    let _e2416 = phi_3727_;
                    let _e2417 = type_32(_e2333, _e2416);
                    if (_e2416 == 0u) {
                        if (_e2341[3][0] != 4294967295u) {
                            phi_3739_ = type_32(_e2341[3], 3u);
                        } else {
                            phi_3739_ = _e2417;
                        }
                        let _e2423 = phi_3739_;
                        phi_3740_ = _e2423;
                    } else {
                        phi_3740_ = _e2417;
                    }
                    let _e2425 = phi_3740_;
                    if (_e281[0] == 4294967295u) {
                        phi_3762_ = 0u;
                    } else {
                        if (_e281[0] >= _e298) {
                            if (_e281[1] >= _e303) {
                                phi_3756_ = false;
                            } else {
                                phi_3756_ = true;
                            }
                            let _e2433 = phi_3756_;
                            phi_3757_ = _e2433;
                        } else {
                            phi_3757_ = true;
                        }
                        let _e2435 = phi_3757_;
                        if _e2435 {
                            phi_3761_ = 1u;
                        } else {
                            phi_3761_ = 2u;
                        }
                        let _e2437 = phi_3761_;
                        phi_3762_ = _e2437;
                    }
                    let _e2439 = phi_3762_;
                    if (_e2439 == 2u) {
                        phi_3768_ = type_32(_e281, 2u);
                    } else {
                        phi_3768_ = _e2362;
                    }
                    let _e2443 = phi_3768_;
                    phi_3769_ = _e2443;
                    phi_3770_ = _e2425;
                    phi_3771_ = _e2404;
                    phi_3772_ = _e2383;
                } else {
                    phi_3769_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3770_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3771_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3772_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2445 = phi_3769_;
                let _e2447 = phi_3770_;
                let _e2449 = phi_3771_;
                let _e2451 = phi_3772_;
                if (_e2445.member_1 == 1u) {
                    let _e2462 = atomicAdd((&shared_[6u]), 1u);
                    phi_3793_ = array<u32, 2>(_e2462, 0u);
                } else {
                    if (_e2445.member_1 == 2u) {
                        let _e2457 = atomicAdd((&shared_[7u]), 1u);
                        phi_3792_ = array<u32, 2>(_e2457, 0u);
                    } else {
                        phi_3792_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2460 = phi_3792_;
                    phi_3793_ = _e2460;
                }
                let _e2465 = phi_3793_;
                if (_e2445.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2469 = atomicAdd((&shared_[8u]), 1u);
                        phi_3805_ = array<u32, 2>(_e2465[0], _e2469);
                    } else {
                        phi_3805_ = _e2465;
                    }
                    let _e2473 = phi_3805_;
                    phi_3806_ = _e2473;
                } else {
                    phi_3806_ = _e2465;
                }
                let _e2475 = phi_3806_;
                if (_e2451.member_1 == 1u) {
                    let _e2485 = atomicAdd((&shared_[6u]), 1u);
                    phi_3824_ = array<u32, 2>(_e2485, 0u);
                } else {
                    if (_e2451.member_1 == 2u) {
                        let _e2480 = atomicAdd((&shared_[7u]), 1u);
                        phi_3823_ = array<u32, 2>(_e2480, 0u);
                    } else {
                        phi_3823_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2483 = phi_3823_;
                    phi_3824_ = _e2483;
                }
                let _e2488 = phi_3824_;
                if (_e2451.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2492 = atomicAdd((&shared_[8u]), 1u);
                        phi_3836_ = array<u32, 2>(_e2488[0], _e2492);
                    } else {
                        phi_3836_ = _e2488;
                    }
                    let _e2496 = phi_3836_;
                    phi_3837_ = _e2496;
                } else {
                    phi_3837_ = _e2488;
                }
                let _e2498 = phi_3837_;
                if (_e2449.member_1 == 1u) {
                    let _e2508 = atomicAdd((&shared_[6u]), 1u);
                    phi_3855_ = array<u32, 2>(_e2508, 0u);
                } else {
                    if (_e2449.member_1 == 2u) {
                        let _e2503 = atomicAdd((&shared_[7u]), 1u);
                        phi_3854_ = array<u32, 2>(_e2503, 0u);
                    } else {
                        phi_3854_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2506 = phi_3854_;
                    phi_3855_ = _e2506;
                }
                let _e2511 = phi_3855_;
                if (_e2449.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2515 = atomicAdd((&shared_[8u]), 1u);
                        phi_3867_ = array<u32, 2>(_e2511[0], _e2515);
                    } else {
                        phi_3867_ = _e2511;
                    }
                    let _e2519 = phi_3867_;
                    phi_3868_ = _e2519;
                } else {
                    phi_3868_ = _e2511;
                }
                let _e2521 = phi_3868_;
                if (_e2447.member_1 == 1u) {
                    let _e2531 = atomicAdd((&shared_[6u]), 1u);
                    phi_3886_ = array<u32, 2>(_e2531, 0u);
                } else {
                    if (_e2447.member_1 == 2u) {
                        let _e2526 = atomicAdd((&shared_[7u]), 1u);
                        phi_3885_ = array<u32, 2>(_e2526, 0u);
                    } else {
                        phi_3885_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2529 = phi_3885_;
                    phi_3886_ = _e2529;
                }
                let _e2534 = phi_3886_;
                if (_e2447.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2538 = atomicAdd((&shared_[8u]), 1u);
                        phi_3898_ = array<u32, 2>(_e2534[0], _e2538);
                    } else {
                        phi_3898_ = _e2534;
                    }
                    let _e2542 = phi_3898_;
                    phi_3899_ = _e2542;
                } else {
                    phi_3899_ = _e2534;
                }
                let _e2544 = phi_3899_;
                workgroupBarrier();
                if (_e72 == 0u) {
                    let _e2547 = atomicLoad((&shared_[6u]));
                    let _e2549 = atomicLoad((&shared_[7u]));
                    let _e2551 = atomicLoad((&shared_[8u]));
                    let _e2553 = atomicLoad((&shared_[1u]));
                    let _e2555 = atomicLoad((&shared_[2u]));
                    let _e2557 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2557 + 1u));
                    let _e2561 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2561 + _e2553) + _e2555));
                    let _e2566 = atomicLoad((&shared_[0u]));
                    let _e2567 = (_e2566 - _e2553);
                    let _e2569 = (_e87.member_10 - _e2567);
                    if (_e2569 < _e2547) {
                        phi_3943_ = _e2569;
                    } else {
                        phi_3943_ = _e2547;
                    }
                    let _e2572 = phi_3943_;
                    atomicStore((&shared_[9u]), _e2567);
                    atomicStore((&shared_[10u]), _e2572);
                    atomicStore((&shared_[0u]), (_e2567 + _e2572));
                    if (_e2547 > _e2572) {
                        let _e2578 = (_e2547 - _e2572);
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e2582 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2585 = atomicAdd((&control.member[(_e89.member_1 + 1u)]), _e2578);
                        let _e2588 = atomicMax((&nodes.member[0u]), (_e2585 + _e2578));
                        if ((_e2585 + _e2578) < _e2585) {
                            let _e2592 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2585);
                    }
                    if (_e2549 > 0u) {
                        let _e2596 = atomicAdd((&pairs.member[0u]), _e2549);
                        if ((_e2596 + _e2549) < _e2596) {
                            let _e2600 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2596);
                    }
                    if (_e2551 > 0u) {
                        let _e2604 = atomicAdd((&control.member[1537u]), _e2551);
                        if ((_e2604 + _e2551) < _e2604) {
                            let _e2608 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2604);
                    }
                }
                workgroupBarrier();
                if (_e2445.member_1 == 1u) {
                    let _e2671 = atomicLoad((&shared_[10u]));
                    if (_e2475[0] < _e2671) {
                        let _e2691 = atomicLoad((&shared_[9u]));
                        let _e2694 = (2u * (_e2691 + _e2475[0]));
                        stack[_e2694] = _e2445.member[0];
                        stack[(_e2694 + 1u)] = _e2445.member[1];
                    } else {
                        let _e2675 = atomicLoad((&shared_[11u]));
                        let _e2678 = ((_e2675 + _e2475[0]) - _e2671);
                        if (_e2678 < _e87.member_3) {
                            let _e2681 = (_e100 + _e2678);
                            if (_e2681 < 4294967295u) {
                                let _e2685 = (2u * _e2681);
                                atomicStore((&nodes.member[(4u + _e2685)]), _e2445.member[0]);
                                atomicStore((&nodes.member[(_e2685 + 5u)]), _e2445.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2445.member_1 == 0u) {
                    } else {
                        if (_e2445.member_1 == 2u) {
                            let _e2619 = a.member[_e2445.member[0]];
                            let _e2623 = b.member[_e2445.member[1]];
                            let _e2627 = params.member.member_2.member;
                            if (_e2627 == 1u) {
                                if (_e2619.member_1 < _e2623.member_1) {
                                    phi_4128_ = type_9(_e2619.member_1, _e2623.member_1);
                                } else {
                                    phi_4128_ = type_9(_e2623.member_1, _e2619.member_1);
                                }
                                let _e2634 = phi_4128_;
                                phi_4133_ = _e2634;
                            } else {
                                phi_4133_ = type_9(_e2619.member_1, _e2623.member_1);
                            }
                            let _e2636 = phi_4133_;
                            let _e2640 = params.member.member_1;
                            let _e2643 = atomicLoad((&shared_[12u]));
                            let _e2645 = (_e2643 + _e2475[0]);
                            if (_e2645 < _e2640.member_3) {
                                let _e2647 = (2u * _e2645);
                                atomicStore((&pairs.member[(4u + _e2647)]), _e2636.member);
                                atomicStore((&pairs.member[(_e2647 + 5u)]), _e2636.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2655 = atomicLoad((&shared_[13u]));
                            let _e2657 = (_e2655 + _e2475[1]);
                            if (_e2657 < _e87.member_4) {
                                let _e2664 = (2u * ((_e87.member_5 * _e87.member_4) + _e2657));
                                front.member[_e2664] = _e2445.member[0];
                                front.member[(_e2664 + 1u)] = _e2445.member[1];
                            }
                        }
                    }
                }
                if (_e2451.member_1 == 1u) {
                    let _e2761 = atomicLoad((&shared_[10u]));
                    if (_e2498[0] < _e2761) {
                        let _e2781 = atomicLoad((&shared_[9u]));
                        let _e2784 = (2u * (_e2781 + _e2498[0]));
                        stack[_e2784] = _e2451.member[0];
                        stack[(_e2784 + 1u)] = _e2451.member[1];
                    } else {
                        let _e2765 = atomicLoad((&shared_[11u]));
                        let _e2768 = ((_e2765 + _e2498[0]) - _e2761);
                        if (_e2768 < _e87.member_3) {
                            let _e2771 = (_e100 + _e2768);
                            if (_e2771 < 4294967295u) {
                                let _e2775 = (2u * _e2771);
                                atomicStore((&nodes.member[(4u + _e2775)]), _e2451.member[0]);
                                atomicStore((&nodes.member[(_e2775 + 5u)]), _e2451.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2451.member_1 == 0u) {
                    } else {
                        if (_e2451.member_1 == 2u) {
                            let _e2709 = a.member[_e2451.member[0]];
                            let _e2713 = b.member[_e2451.member[1]];
                            let _e2717 = params.member.member_2.member;
                            if (_e2717 == 1u) {
                                if (_e2709.member_1 < _e2713.member_1) {
                                    phi_4291_ = type_9(_e2709.member_1, _e2713.member_1);
                                } else {
                                    phi_4291_ = type_9(_e2713.member_1, _e2709.member_1);
                                }
                                let _e2724 = phi_4291_;
                                phi_4296_ = _e2724;
                            } else {
                                phi_4296_ = type_9(_e2709.member_1, _e2713.member_1);
                            }
                            let _e2726 = phi_4296_;
                            let _e2730 = params.member.member_1;
                            let _e2733 = atomicLoad((&shared_[12u]));
                            let _e2735 = (_e2733 + _e2498[0]);
                            if (_e2735 < _e2730.member_3) {
                                let _e2737 = (2u * _e2735);
                                atomicStore((&pairs.member[(4u + _e2737)]), _e2726.member);
                                atomicStore((&pairs.member[(_e2737 + 5u)]), _e2726.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2745 = atomicLoad((&shared_[13u]));
                            let _e2747 = (_e2745 + _e2498[1]);
                            if (_e2747 < _e87.member_4) {
                                let _e2754 = (2u * ((_e87.member_5 * _e87.member_4) + _e2747));
                                front.member[_e2754] = _e2451.member[0];
                                front.member[(_e2754 + 1u)] = _e2451.member[1];
                            }
                        }
                    }
                }
                if (_e2449.member_1 == 1u) {
                    let _e2851 = atomicLoad((&shared_[10u]));
                    if (_e2521[0] < _e2851) {
                        let _e2871 = atomicLoad((&shared_[9u]));
                        let _e2874 = (2u * (_e2871 + _e2521[0]));
                        stack[_e2874] = _e2449.member[0];
                        stack[(_e2874 + 1u)] = _e2449.member[1];
                    } else {
                        let _e2855 = atomicLoad((&shared_[11u]));
                        let _e2858 = ((_e2855 + _e2521[0]) - _e2851);
                        if (_e2858 < _e87.member_3) {
                            let _e2861 = (_e100 + _e2858);
                            if (_e2861 < 4294967295u) {
                                let _e2865 = (2u * _e2861);
                                atomicStore((&nodes.member[(4u + _e2865)]), _e2449.member[0]);
                                atomicStore((&nodes.member[(_e2865 + 5u)]), _e2449.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2449.member_1 == 0u) {
                    } else {
                        if (_e2449.member_1 == 2u) {
                            let _e2799 = a.member[_e2449.member[0]];
                            let _e2803 = b.member[_e2449.member[1]];
                            let _e2807 = params.member.member_2.member;
                            if (_e2807 == 1u) {
                                if (_e2799.member_1 < _e2803.member_1) {
                                    phi_4454_ = type_9(_e2799.member_1, _e2803.member_1);
                                } else {
                                    phi_4454_ = type_9(_e2803.member_1, _e2799.member_1);
                                }
                                let _e2814 = phi_4454_;
                                phi_4459_ = _e2814;
                            } else {
                                phi_4459_ = type_9(_e2799.member_1, _e2803.member_1);
                            }
                            let _e2816 = phi_4459_;
                            let _e2820 = params.member.member_1;
                            let _e2823 = atomicLoad((&shared_[12u]));
                            let _e2825 = (_e2823 + _e2521[0]);
                            if (_e2825 < _e2820.member_3) {
                                let _e2827 = (2u * _e2825);
                                atomicStore((&pairs.member[(4u + _e2827)]), _e2816.member);
                                atomicStore((&pairs.member[(_e2827 + 5u)]), _e2816.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2835 = atomicLoad((&shared_[13u]));
                            let _e2837 = (_e2835 + _e2521[1]);
                            if (_e2837 < _e87.member_4) {
                                let _e2844 = (2u * ((_e87.member_5 * _e87.member_4) + _e2837));
                                front.member[_e2844] = _e2449.member[0];
                                front.member[(_e2844 + 1u)] = _e2449.member[1];
                            }
                        }
                    }
                }
                if (_e2447.member_1 == 1u) {
                    let _e2941 = atomicLoad((&shared_[10u]));
                    if (_e2544[0] < _e2941) {
                        let _e2961 = atomicLoad((&shared_[9u]));
                        let _e2964 = (2u * (_e2961 + _e2544[0]));
                        stack[_e2964] = _e2447.member[0];
                        stack[(_e2964 + 1u)] = _e2447.member[1];
                    } else {
                        let _e2945 = atomicLoad((&shared_[11u]));
                        let _e2948 = ((_e2945 + _e2544[0]) - _e2941);
                        if (_e2948 < _e87.member_3) {
                            let _e2951 = (_e100 + _e2948);
                            if (_e2951 < 4294967295u) {
                                let _e2955 = (2u * _e2951);
                                atomicStore((&nodes.member[(4u + _e2955)]), _e2447.member[0]);
                                atomicStore((&nodes.member[(_e2955 + 5u)]), _e2447.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2447.member_1 == 0u) {
                    } else {
                        if (_e2447.member_1 == 2u) {
                            let _e2889 = a.member[_e2447.member[0]];
                            let _e2893 = b.member[_e2447.member[1]];
                            let _e2897 = params.member.member_2.member;
                            if (_e2897 == 1u) {
                                if (_e2889.member_1 < _e2893.member_1) {
                                    phi_4617_ = type_9(_e2889.member_1, _e2893.member_1);
                                } else {
                                    phi_4617_ = type_9(_e2893.member_1, _e2889.member_1);
                                }
                                let _e2904 = phi_4617_;
                                phi_4622_ = _e2904;
                            } else {
                                phi_4622_ = type_9(_e2889.member_1, _e2893.member_1);
                            }
                            let _e2906 = phi_4622_;
                            let _e2910 = params.member.member_1;
                            let _e2913 = atomicLoad((&shared_[12u]));
                            let _e2915 = (_e2913 + _e2544[0]);
                            if (_e2915 < _e2910.member_3) {
                                let _e2917 = (2u * _e2915);
                                atomicStore((&pairs.member[(4u + _e2917)]), _e2906.member);
                                atomicStore((&pairs.member[(_e2917 + 5u)]), _e2906.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2925 = atomicLoad((&shared_[13u]));
                            let _e2927 = (_e2925 + _e2544[1]);
                            if (_e2927 < _e87.member_4) {
                                let _e2934 = (2u * ((_e87.member_5 * _e87.member_4) + _e2927));
                                front.member[_e2934] = _e2447.member[0];
                                front.member[(_e2934 + 1u)] = _e2447.member[1];
                            }
                        }
                    }
                }
                phi_4675_ = true;
            }
            let _e2971 = phi_4675_;
            phi_4676_ = _e2971;
        } else {
            phi_4676_ = false;
        }
        let _e2973 = phi_4676_;
        continue;
        continuing {
            phi_246_ = _e121;
            break if !(_e2973);
        }
    }
    if (_e72 == 0u) {
        if (_e87.member_6 == 0u) {
            if (_e85 < _e97) {
                phi_4699_ = ((((_e97 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
            } else {
                phi_4699_ = 0u;
            }
            let _e2987 = phi_4699_;
            let _e2989 = atomicLoad((&shared_[5u]));
            phi_4704_ = (_e2987 - _e2989);
        } else {
            phi_4704_ = 0u;
        }
        let _e2992 = phi_4704_;
        atomicStore((&shared_[14u]), _e2992);
        let _e2995 = atomicLoad((&shared_[0u]));
        let _e2996 = (_e2995 + _e2992);
        if (_e2996 > 0u) {
            if (_e87.member_12 == 0u) {
            } else {
                let _e3001 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e3004 = atomicAdd((&control.member[(_e89.member_1 + 1u)]), _e2996);
            let _e3007 = atomicMax((&nodes.member[0u]), (_e3004 + _e2996));
            if ((_e3004 + _e2996) < _e3004) {
                let _e3011 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e3004);
        }
        let _e3016 = atomicLoad((&shared_[15u]));
        let _e3018 = atomicAdd((&control.member[(1540u + (2u * _e85))]), _e3016);
        let _e3022 = atomicLoad((&shared_[16u]));
        let _e3024 = atomicAdd((&control.member[((2u * _e85) + 1541u)]), _e3022);
    }
    workgroupBarrier();
    let _e3026 = atomicLoad((&shared_[0u]));
    let _e3028 = atomicLoad((&shared_[17u]));
    let _e3030 = atomicLoad((&shared_[14u]));
    phi_4777_ = type_9(0u, 8u);
    loop {
        let _e3032 = phi_4777_;
        if (_e3032.member < _e3032.member_1) {
            phi_4778_ = type_9((_e3032.member + 1u), _e3032.member_1);
            phi_4801_ = type_9(1u, _e3032.member);
        } else {
            phi_4778_ = _e3032;
            phi_4801_ = type_9(0u, type_9().member_1);
        }
        let _e3044 = phi_4778_;
        let _e3046 = phi_4801_;
        let _e3050 = (bitcast<i32>(_e3046.member) != 0i);
        if _e3050 {
            let _e3052 = ((_e3046.member_1 * 128u) + _e72);
            if (_e3052 < _e3026) {
                let _e3056 = stack[(2u * _e3052)];
                let _e3060 = stack[((2u * _e3052) + 1u)];
                let _e3061 = (_e3028 + _e3052);
                if (_e3061 < _e87.member_3) {
                    let _e3064 = (_e100 + _e3061);
                    if (_e3064 < 4294967295u) {
                        let _e3066 = (2u * _e3064);
                        atomicStore((&nodes.member[(4u + _e3066)]), _e3056);
                        atomicStore((&nodes.member[(_e3066 + 5u)]), _e3060);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4777_ = _e3044;
            break if !(_e3050);
        }
    }
    let _e3073 = atomicLoad((&shared_[5u]));
    let _e3074 = (_e3030 / 128u);
    if ((_e3030 % 128u) > 0u) {
        phi_4861_ = (_e3074 + 1u);
    } else {
        phi_4861_ = _e3074;
    }
    let _e3079 = phi_4861_;
    phi_4864_ = type_9(0u, _e3079);
    loop {
        let _e3082 = phi_4864_;
        if (_e3082.member < _e3082.member_1) {
            phi_4865_ = type_9((_e3082.member + 1u), _e3082.member_1);
            phi_4888_ = type_9(1u, _e3082.member);
        } else {
            phi_4865_ = _e3082;
            phi_4888_ = type_9(0u, type_9().member_1);
        }
        let _e3094 = phi_4865_;
        let _e3096 = phi_4888_;
        let _e3100 = (bitcast<i32>(_e3096.member) != 0i);
        if _e3100 {
            let _e3102 = ((_e3096.member_1 * 128u) + _e72);
            if (_e3102 < _e3030) {
                let _e3111 = (2u * ((_e98 + _e85) + ((_e3073 + _e3102) << bitcast<u32>((_e87.member_7 & 31u)))));
                let _e3114 = atomicLoad((&nodes.member[(4u + _e3111)]));
                let _e3117 = atomicLoad((&nodes.member[(_e3111 + 5u)]));
                let _e3119 = ((_e3028 + _e3026) + _e3102);
                if (_e3119 < _e87.member_3) {
                    let _e3122 = (_e100 + _e3119);
                    if (_e3122 < 4294967295u) {
                        let _e3124 = (2u * _e3122);
                        atomicStore((&nodes.member[(4u + _e3124)]), _e3114);
                        atomicStore((&nodes.member[(_e3124 + 5u)]), _e3117);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4864_ = _e3094;
            break if !(_e3100);
        }
    }
    if (_e87.member_6 == 1u) {
        if (_e3073 == 0u) {
            phi_4969_ = type_9(0u, _e97);
            loop {
                let _e3135 = phi_4969_;
                if (_e3135.member < _e3135.member_1) {
                    phi_4970_ = type_9((_e3135.member + 1u), _e3135.member_1);
                    phi_4993_ = type_9(1u, _e3135.member);
                } else {
                    phi_4970_ = _e3135;
                    phi_4993_ = type_9(0u, type_9().member_1);
                }
                let _e3147 = phi_4970_;
                let _e3149 = phi_4993_;
                if (bitcast<i32>(_e3149.member) != 0i) {
                    let _e3155 = atomicAdd((&control.member[(512u + _e89.member_1)]), 1u);
                    if (_e3155 >= _e97) {
                        phi_5085_ = false;
                    } else {
                        let _e3158 = (2u * (_e98 + _e3155));
                        let _e3161 = atomicLoad((&nodes.member[(4u + _e3158)]));
                        let _e3164 = atomicLoad((&nodes.member[(_e3158 + 5u)]));
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e3168 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3171 = atomicAdd((&control.member[(_e89.member_1 + 1u)]), 1u);
                        let _e3174 = atomicMax((&nodes.member[0u]), (_e3171 + 1u));
                        if ((_e3171 + 1u) < _e3171) {
                            let _e3178 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3171 < _e87.member_3) {
                            let _e3181 = (_e100 + _e3171);
                            if (_e3181 < 4294967295u) {
                                let _e3183 = (2u * _e3181);
                                atomicStore((&nodes.member[(4u + _e3183)]), _e3161);
                                atomicStore((&nodes.member[(_e3183 + 5u)]), _e3164);
                            }
                        }
                        phi_5085_ = true;
                    }
                    let _e3189 = phi_5085_;
                    phi_5086_ = _e3189;
                } else {
                    phi_5086_ = false;
                }
                let _e3191 = phi_5086_;
                continue;
                continuing {
                    phi_4969_ = _e3147;
                    break if !(_e3191);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
