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

struct type_17 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
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
    member_18: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_27 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_33 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_34 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: array<u32, 2>,
    member_3: array<u32, 2>,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_37;
@group(0) @binding(3) 
var<storage> oriented: type_31;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(4) 
var<storage, read_write> control: type_37;
@group(0) @binding(1) 
var<storage> a: type_19;
@group(0) @binding(2) 
var<storage> b: type_19;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
var<workgroup> sums: array<u32, 256>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_37;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: array<array<u32, 2>, 4>;
    var phi_216_: u32;
    var phi_254_: type_9;
    var phi_255_: type_9;
    var phi_278_: type_9;
    var phi_302_: u32;
    var phi_333_: bool;
    var phi_337_: u32;
    var phi_338_: u32;
    var phi_339_: u32;
    var phi_437_: u32;
    var phi_442_: u32;
    var phi_447_: u32;
    var phi_460_: u32;
    var phi_466_: u32;
    var phi_475_: u32;
    var phi_404_: u32;
    var phi_410_: u32;
    var phi_416_: u32;
    var phi_476_: u32;
    var phi_367_: u32;
    var phi_373_: u32;
    var phi_477_: u32;
    var phi_478_: u32;
    var phi_479_: u32;
    var phi_499_: u32;
    var phi_500_: u32;
    var phi_583_: array<u32, 2>;
    var phi_584_: array<u32, 2>;
    var phi_601_: array<u32, 2>;
    var phi_630_: u32;
    var phi_704_: array<u32, 2>;
    var phi_718_: array<u32, 2>;
    var phi_755_: array<u32, 2>;
    var phi_757_: type_25;
    var phi_758_: type_25;
    var phi_759_: bool;
    var phi_760_: type_25;
    var phi_761_: bool;
    var phi_777_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_932_: array<u32, 2>;
    var phi_961_: array<u32, 2>;
    var phi_990_: array<u32, 2>;
    var phi_1019_: array<u32, 2>;
    var phi_1021_: type_25;
    var phi_1022_: bool;
    var phi_1023_: type_25;
    var phi_1024_: bool;
    var phi_1197_: array<u32, 2>;
    var phi_1229_: array<u32, 2>;
    var phi_1097_: array<u32, 2>;
    var phi_1129_: array<u32, 2>;
    var phi_1231_: type_25;
    var phi_1232_: type_25;
    var phi_1233_: type_25;
    var phi_1234_: bool;
    var phi_1235_: type_25;
    var phi_1236_: type_25;
    var phi_1237_: bool;
    var phi_1241_: type_25;
    var phi_1259_: array<u32, 2>;
    var phi_1290_: array<u32, 2>;
    var phi_1335_: type_9;
    var phi_1336_: type_9;
    var phi_1359_: type_9;
    var phi_1388_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1474_: f32;
    var phi_1480_: f32;
    var phi_1486_: f32;
    var phi_1492_: f32;
    var phi_1498_: f32;
    var phi_1504_: f32;
    var phi_1522_: f32;
    var phi_1527_: f32;
    var phi_1532_: f32;
    var phi_1548_: type_32;
    var phi_1618_: f32;
    var phi_1624_: f32;
    var phi_1630_: f32;
    var phi_1636_: f32;
    var phi_1642_: f32;
    var phi_1648_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1692_: type_32;
    var phi_1882_: f32;
    var phi_1888_: f32;
    var phi_1895_: f32;
    var phi_1904_: f32;
    var phi_1911_: f32;
    var phi_1919_: f32;
    var phi_1928_: f32;
    var phi_1935_: f32;
    var phi_1943_: f32;
    var phi_2036_: f32;
    var phi_2043_: f32;
    var phi_2049_: f32;
    var phi_2055_: f32;
    var phi_2074_: f32;
    var phi_2081_: f32;
    var phi_2087_: f32;
    var phi_2093_: f32;
    var phi_2112_: f32;
    var phi_2119_: f32;
    var phi_2125_: f32;
    var phi_2131_: f32;
    var phi_2150_: f32;
    var phi_2157_: f32;
    var phi_2163_: f32;
    var phi_2169_: f32;
    var phi_2188_: f32;
    var phi_2195_: f32;
    var phi_2201_: f32;
    var phi_2207_: f32;
    var phi_2226_: f32;
    var phi_2233_: f32;
    var phi_2239_: f32;
    var phi_2245_: f32;
    var phi_2260_: f32;
    var phi_2265_: f32;
    var phi_2270_: f32;
    var phi_2275_: f32;
    var phi_2280_: f32;
    var phi_2339_: f32;
    var phi_2362_: f32;
    var phi_2385_: f32;
    var phi_2407_: f32;
    var phi_2423_: f32;
    var phi_2478_: f32;
    var phi_2501_: f32;
    var phi_2524_: f32;
    var phi_2546_: f32;
    var phi_2562_: f32;
    var phi_2617_: f32;
    var phi_2640_: f32;
    var phi_2663_: f32;
    var phi_2685_: f32;
    var phi_2701_: f32;
    var phi_2756_: f32;
    var phi_2779_: f32;
    var phi_2803_: f32;
    var phi_2826_: f32;
    var phi_2842_: f32;
    var phi_2897_: f32;
    var phi_2920_: f32;
    var phi_2944_: f32;
    var phi_2967_: f32;
    var phi_2983_: f32;
    var phi_3038_: f32;
    var phi_3061_: f32;
    var phi_3085_: f32;
    var phi_3108_: f32;
    var phi_3124_: f32;
    var phi_3179_: f32;
    var phi_3202_: f32;
    var phi_3226_: f32;
    var phi_3249_: f32;
    var phi_3265_: f32;
    var phi_3320_: f32;
    var phi_3343_: f32;
    var phi_3367_: f32;
    var phi_3390_: f32;
    var phi_3406_: f32;
    var phi_3461_: f32;
    var phi_3484_: f32;
    var phi_3508_: f32;
    var phi_3531_: f32;
    var phi_3547_: f32;
    var phi_3554_: f32;
    var phi_3559_: f32;
    var phi_3564_: f32;
    var phi_3569_: f32;
    var phi_3574_: f32;
    var phi_3579_: f32;
    var phi_3584_: f32;
    var phi_3589_: f32;
    var phi_3593_: bool;
    var phi_3595_: bool;
    var phi_3596_: bool;
    var phi_3597_: bool;
    var phi_3598_: bool;
    var phi_3602_: bool;
    var phi_3639_: array<array<u32, 2>, 4>;
    var phi_3657_: bool;
    var phi_3658_: bool;
    var phi_3662_: u32;
    var phi_3663_: u32;
    var phi_3675_: type_33;
    var phi_3676_: type_33;
    var phi_3694_: bool;
    var phi_3695_: bool;
    var phi_3699_: u32;
    var phi_3700_: u32;
    var phi_3712_: type_33;
    var phi_3713_: type_33;
    var phi_3731_: bool;
    var phi_3732_: bool;
    var phi_3736_: u32;
    var phi_3737_: u32;
    var phi_3749_: type_33;
    var phi_3750_: type_33;
    var phi_3768_: bool;
    var phi_3769_: bool;
    var phi_3773_: u32;
    var phi_3774_: u32;
    var phi_3786_: type_33;
    var phi_3787_: type_33;
    var phi_3803_: bool;
    var phi_3804_: bool;
    var phi_3808_: u32;
    var phi_3809_: u32;
    var phi_3815_: type_33;
    var phi_3816_: type_33;
    var phi_3817_: type_33;
    var phi_3818_: type_33;
    var phi_3819_: type_33;
    var phi_4139_: u32;
    var phi_4149_: array<u32, 3>;
    var phi_4158_: array<u32, 3>;
    var phi_4167_: array<u32, 3>;
    var phi_4175_: u32;
    var phi_4200_: u32;
    var phi_4219_: u32;
    var phi_4238_: u32;
    var phi_3878_: u32;
    var phi_3885_: type_9;
    var phi_3888_: u32;
    var phi_3890_: u32;
    var phi_3892_: u32;
    var phi_3889_: u32;
    var phi_3886_: type_9;
    var phi_3915_: type_9;
    var phi_3931_: u32;
    var phi_3891_: u32;
    var phi_3893_: u32;
    var local_2: u32;
    var phi_3958_: type_9;
    var phi_3961_: u32;
    var phi_3963_: u32;
    var phi_3965_: u32;
    var phi_3962_: u32;
    var phi_3959_: type_9;
    var phi_3988_: type_9;
    var phi_4004_: u32;
    var phi_3964_: u32;
    var phi_3966_: u32;
    var local_3: u32;
    var phi_4018_: u32;
    var phi_4026_: u32;
    var phi_4045_: u32;
    var phi_4064_: u32;
    var phi_4083_: u32;
    var phi_4241_: type_34;
    var phi_4285_: u32;
    var phi_4471_: type_9;
    var phi_4476_: type_9;
    var phi_4635_: type_9;
    var phi_4640_: type_9;
    var phi_4799_: type_9;
    var phi_4804_: type_9;
    var phi_4963_: type_9;
    var phi_4968_: type_9;
    var phi_5021_: bool;
    var phi_5022_: bool;
    var phi_5045_: u32;
    var phi_5050_: u32;
    var phi_5076_: u32;
    var phi_5082_: u32;
    var phi_5170_: type_9;
    var phi_5171_: type_9;
    var phi_5194_: type_9;
    var phi_5285_: u32;
    var phi_5288_: type_9;
    var phi_5289_: type_9;
    var phi_5312_: type_9;
    var phi_5393_: type_9;
    var phi_5394_: type_9;
    var phi_5417_: type_9;
    var phi_5509_: bool;
    var phi_5510_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e77 = id_2;
    let _e78 = n_2;
    let _e79 = lane_2;
    let _e92 = ((_e77.y * _e78.x) + _e77.x);
    let _e94 = params.member.member_2;
    let _e96 = params.member.member_1;
    let _e99 = (_e96.member_1 % 2u);
    let _e101 = atomicLoad((&control.member[_e96.member_1]));
    if (_e94.member_3 < _e101) {
        phi_216_ = _e94.member_3;
    } else {
        phi_216_ = _e101;
    }
    let _e104 = phi_216_;
    let _e105 = (_e99 * _e94.member_3);
    let _e107 = ((1u - _e99) * _e94.member_3);
    if (_e79 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_254_ = type_9(0u, _e94.member_12);
    loop {
        let _e116 = phi_254_;
        if (_e116.member < _e116.member_1) {
            phi_255_ = type_9((_e116.member + 1u), _e116.member_1);
            phi_278_ = type_9(1u, _e116.member);
        } else {
            phi_255_ = _e116;
            phi_278_ = type_9(0u, type_9().member_1);
        }
        let _e128 = phi_255_;
        let _e130 = phi_278_;
        if (bitcast<i32>(_e130.member) != 0i) {
            if (_e79 == 0u) {
                let _e141 = atomicLoad((&shared_[0u]));
                if (128u < _e141) {
                    phi_302_ = 128u;
                } else {
                    phi_302_ = _e141;
                }
                let _e144 = phi_302_;
                if (_e94.member_9 > 0u) {
                    if (_e130.member_1 >= 16u) {
                        let _e149 = atomicLoad((&control.member[(1024u + _e96.member_1)]));
                        if (_e94.member_9 > 0u) {
                            phi_333_ = ((_e149 * 100u) >= (_e94.member_9 << bitcast<u32>((_e94.member_7 & 31u))));
                        } else {
                            phi_333_ = false;
                        }
                        let _e157 = phi_333_;
                        if _e157 {
                            phi_337_ = 2u;
                        } else {
                            phi_337_ = 0u;
                        }
                        let _e159 = phi_337_;
                        phi_338_ = _e159;
                    } else {
                        phi_338_ = 0u;
                    }
                    let _e161 = phi_338_;
                    phi_339_ = _e161;
                } else {
                    phi_339_ = 0u;
                }
                let _e163 = phi_339_;
                let _e164 = (128u - _e144);
                if (_e163 == 0u) {
                    if (_e164 > 0u) {
                        let _e168 = atomicLoad((&shared_[5u]));
                        if (_e94.member_6 == 0u) {
                            if (_e92 < _e104) {
                                phi_367_ = ((((_e104 - 1u) - _e92) >> bitcast<u32>((_e94.member_7 & 31u))) + 1u);
                            } else {
                                phi_367_ = 0u;
                            }
                            let _e237 = phi_367_;
                            let _e238 = (_e237 - _e168);
                            if (_e164 < _e238) {
                                phi_373_ = _e164;
                            } else {
                                phi_373_ = _e238;
                            }
                            let _e241 = phi_373_;
                            atomicStore((&shared_[3u]), (_e92 + (_e168 << bitcast<u32>((_e94.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e94.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e168 + _e241));
                            phi_477_ = _e241;
                        } else {
                            if (_e94.member_6 == 2u) {
                                let _e209 = (((_e104 + (1u << bitcast<u32>((_e94.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e94.member_7 & 31u)));
                                let _e210 = (_e92 * _e209);
                                if (_e104 < _e210) {
                                    phi_404_ = _e104;
                                } else {
                                    phi_404_ = _e210;
                                }
                                let _e213 = phi_404_;
                                let _e214 = (_e104 - _e213);
                                if (_e214 < _e209) {
                                    phi_410_ = _e214;
                                } else {
                                    phi_410_ = _e209;
                                }
                                let _e217 = phi_410_;
                                let _e218 = (_e217 - _e168);
                                if (_e164 < _e218) {
                                    phi_416_ = _e164;
                                } else {
                                    phi_416_ = _e218;
                                }
                                let _e221 = phi_416_;
                                atomicStore((&shared_[3u]), (_e213 + _e168));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e168 + _e221));
                                phi_476_ = _e221;
                            } else {
                                if (_e168 == 0u) {
                                    let _e175 = (_e104 >> bitcast<u32>(((_e94.member_7 + 2u) & 31u)));
                                    if (_e94.member_8 < _e175) {
                                        phi_437_ = _e175;
                                    } else {
                                        phi_437_ = _e94.member_8;
                                    }
                                    let _e178 = phi_437_;
                                    if (128u < _e178) {
                                        phi_442_ = 128u;
                                    } else {
                                        phi_442_ = _e178;
                                    }
                                    let _e181 = phi_442_;
                                    if (_e164 < _e181) {
                                        phi_447_ = _e164;
                                    } else {
                                        phi_447_ = _e181;
                                    }
                                    let _e184 = phi_447_;
                                    let _e187 = atomicAdd((&control.member[(512u + _e96.member_1)]), _e184);
                                    if (_e104 < _e187) {
                                        phi_460_ = _e104;
                                    } else {
                                        phi_460_ = _e187;
                                    }
                                    let _e190 = phi_460_;
                                    let _e191 = (_e104 - _e190);
                                    if (_e184 < _e191) {
                                        phi_466_ = _e184;
                                    } else {
                                        phi_466_ = _e191;
                                    }
                                    let _e194 = phi_466_;
                                    atomicStore((&shared_[3u]), _e187);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e194 < _e184)));
                                    phi_475_ = _e194;
                                } else {
                                    phi_475_ = 0u;
                                }
                                let _e201 = phi_475_;
                                phi_476_ = _e201;
                            }
                            let _e228 = phi_476_;
                            phi_477_ = _e228;
                        }
                        let _e254 = phi_477_;
                        phi_478_ = _e254;
                    } else {
                        phi_478_ = 0u;
                    }
                    let _e256 = phi_478_;
                    phi_479_ = _e256;
                } else {
                    phi_479_ = 0u;
                }
                let _e258 = phi_479_;
                if (_e163 == 0u) {
                    if ((_e144 + _e258) == 0u) {
                        if (_e94.member_9 > 0u) {
                            let _e265 = atomicAdd((&control.member[(1024u + _e96.member_1)]), 1u);
                        }
                        phi_499_ = 1u;
                    } else {
                        phi_499_ = _e163;
                    }
                    let _e267 = phi_499_;
                    phi_500_ = _e267;
                } else {
                    phi_500_ = _e163;
                }
                let _e269 = phi_500_;
                atomicStore((&shared_[1u]), _e144);
                atomicStore((&shared_[2u]), _e258);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e269;
            }
            let _e277 = workgroupUniformLoad((&state[0u]));
            if (_e277 != 0u) {
                phi_5021_ = false;
            } else {
                let _e280 = atomicLoad((&shared_[1u]));
                let _e282 = atomicLoad((&shared_[2u]));
                if (_e79 < _e280) {
                    let _e305 = atomicLoad((&shared_[0u]));
                    let _e308 = (2u * ((_e305 - 1u) - _e79));
                    let _e310 = stack[_e308];
                    let _e313 = stack[(_e308 + 1u)];
                    phi_584_ = array<u32, 2>(_e310, _e313);
                } else {
                    if (_e79 < (_e280 + _e282)) {
                        let _e287 = atomicLoad((&shared_[3u]));
                        let _e290 = atomicLoad((&shared_[4u]));
                        let _e294 = (2u * (_e105 + (_e287 + ((_e79 - _e280) * _e290))));
                        let _e297 = atomicLoad((&nodes.member[(4u + _e294)]));
                        let _e300 = atomicLoad((&nodes.member[(_e294 + 5u)]));
                        phi_583_ = array<u32, 2>(_e297, _e300);
                    } else {
                        phi_583_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e303 = phi_583_;
                    phi_584_ = _e303;
                }
                let _e316 = phi_584_;
                let _e319 = params.member.member_2.member;
                let _e323 = params.member.member_2.member;
                if (_e323 == 0u) {
                    phi_601_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_601_ = array<u32, 2>(1u, 1u);
                }
                let _e326 = phi_601_;
                let _e332 = params.member.member.member[_e326[0]];
                let _e333 = (_e332 - 1u);
                let _e337 = params.member.member.member[_e326[1]];
                let _e338 = (_e337 - 1u);
                let _e341 = params.member.member_2.member_1;
                if (_e341 == 0u) {
                    phi_630_ = 1u;
                } else {
                    phi_630_ = 0u;
                }
                let _e344 = phi_630_;
                if (_e316[0] != 4294967295u) {
                    let _e350 = a.member[_e316[0]];
                    let _e352 = b.member[_e316[1]];
                    if (_e319 == 1u) {
                        if (_e316[0] == _e316[1]) {
                            if (_e350.member_3 == 4294967295u) {
                                phi_757_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e358 = a.member[_e350.member_1];
                                let _e361 = a.member[_e350.member_3];
                                if !((_e358.member_3 == 4294967295u)) {
                                    phi_704_ = array<u32, 2>(_e350.member_1, _e350.member_1);
                                } else {
                                    phi_704_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e368 = phi_704_;
                                let _e375 = type_25(array<array<u32, 2>, 4>(_e368, type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e387 = type_25(array<array<u32, 2>, 4>(_e375.member[0], array<u32, 2>(_e350.member_1, _e375.member[1][1]), _e375.member[2], _e375.member[3]), _e375.member_1);
                                let _e388 = array<u32, 2>(_e350.member_1, _e350.member_3);
                                let _e395 = type_25(array<array<u32, 2>, 4>(_e387.member[0], _e388, _e387.member[2], _e387.member[3]), _e387.member_1);
                                if !((_e361.member_3 == 4294967295u)) {
                                    phi_718_ = array<u32, 2>(_e350.member_3, _e350.member_3);
                                } else {
                                    phi_718_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e402 = phi_718_;
                                let _e409 = type_25(array<array<u32, 2>, 4>(_e395.member[0], _e395.member[1], _e402, _e395.member[3]), _e395.member_1);
                                let _e412 = type_25(_e409.member, _e409.member);
                                if ((((((_e358.member[0] <= _e361.member_2[0]) && (_e361.member[0] <= _e358.member_2[0])) && (_e358.member[1] <= _e361.member_2[1])) && (_e361.member[1] <= _e358.member_2[1])) && (_e358.member[2] <= _e361.member_2[2])) && (_e361.member[2] <= _e358.member_2[2])) {
                                    phi_755_ = _e388;
                                } else {
                                    phi_755_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e441 = phi_755_;
                                phi_757_ = type_25(_e412.member, array<array<u32, 2>, 4>(_e412.member_1[0], _e441, _e412.member_1[2], _e412.member_1[3]));
                            }
                            let _e450 = phi_757_;
                            phi_758_ = _e450;
                            phi_759_ = false;
                        } else {
                            phi_758_ = type_25();
                            phi_759_ = true;
                        }
                        let _e452 = phi_758_;
                        let _e454 = phi_759_;
                        phi_760_ = _e452;
                        phi_761_ = _e454;
                    } else {
                        phi_760_ = type_25();
                        phi_761_ = true;
                    }
                    let _e456 = phi_760_;
                    let _e458 = phi_761_;
                    if _e458 {
                        let _e461 = !((_e350.member_3 == 4294967295u));
                        let _e464 = !((_e352.member_3 == 4294967295u));
                        if _e461 {
                            phi_777_ = true;
                        } else {
                            phi_777_ = _e464;
                        }
                        let _e466 = phi_777_;
                        if _e466 {
                            if _e461 {
                                if _e464 {
                                    if (_e344 == 0u) {
                                        let _e494 = ((((_e352.member_2[0] - _e352.member[0]) * (_e352.member_2[1] - _e352.member[1])) * (_e352.member_2[2] - _e352.member[2])) > (((_e350.member_2[0] - _e350.member[0]) * (_e350.member_2[1] - _e350.member[1])) * (_e350.member_2[2] - _e350.member[2])));
                                        phi_821_ = _e494;
                                        phi_822_ = !(_e494);
                                    } else {
                                        phi_821_ = _e464;
                                        phi_822_ = _e461;
                                    }
                                    let _e497 = phi_821_;
                                    let _e499 = phi_822_;
                                    phi_823_ = _e497;
                                    phi_824_ = _e499;
                                } else {
                                    phi_823_ = _e464;
                                    phi_824_ = _e461;
                                }
                                let _e501 = phi_823_;
                                let _e503 = phi_824_;
                                phi_825_ = _e501;
                                phi_826_ = _e503;
                            } else {
                                phi_825_ = _e464;
                                phi_826_ = _e461;
                            }
                            let _e505 = phi_825_;
                            let _e507 = phi_826_;
                            if _e507 {
                                if _e505 {
                                    let _e510 = a.member[_e350.member_1];
                                    let _e515 = a.member[_e350.member_3];
                                    let _e520 = b.member[_e352.member_1];
                                    let _e525 = b.member[_e352.member_3];
                                    let _e530 = array<u32, 2>(_e350.member_1, _e352.member_1);
                                    let _e533 = array<u32, 2>(_e350.member_1, _e352.member_3);
                                    let _e536 = array<u32, 2>(_e350.member_3, _e352.member_1);
                                    let _e539 = array<u32, 2>(_e350.member_3, _e352.member_3);
                                    if ((((((_e510.member[0] <= _e520.member_2[0]) && (_e520.member[0] <= _e510.member_2[0])) && (_e510.member[1] <= _e520.member_2[1])) && (_e520.member[1] <= _e510.member_2[1])) && (_e510.member[2] <= _e520.member_2[2])) && (_e520.member[2] <= _e510.member_2[2])) {
                                        phi_932_ = _e530;
                                    } else {
                                        phi_932_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e565 = phi_932_;
                                    if ((((((_e510.member[0] <= _e525.member_2[0]) && (_e525.member[0] <= _e510.member_2[0])) && (_e510.member[1] <= _e525.member_2[1])) && (_e525.member[1] <= _e510.member_2[1])) && (_e510.member[2] <= _e525.member_2[2])) && (_e525.member[2] <= _e510.member_2[2])) {
                                        phi_961_ = _e533;
                                    } else {
                                        phi_961_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e590 = phi_961_;
                                    if ((((((_e515.member[0] <= _e520.member_2[0]) && (_e520.member[0] <= _e515.member_2[0])) && (_e515.member[1] <= _e520.member_2[1])) && (_e520.member[1] <= _e515.member_2[1])) && (_e515.member[2] <= _e520.member_2[2])) && (_e520.member[2] <= _e515.member_2[2])) {
                                        phi_990_ = _e536;
                                    } else {
                                        phi_990_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e615 = phi_990_;
                                    if ((((((_e515.member[0] <= _e525.member_2[0]) && (_e525.member[0] <= _e515.member_2[0])) && (_e515.member[1] <= _e525.member_2[1])) && (_e525.member[1] <= _e515.member_2[1])) && (_e515.member[2] <= _e525.member_2[2])) && (_e525.member[2] <= _e515.member_2[2])) {
                                        phi_1019_ = _e539;
                                    } else {
                                        phi_1019_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e640 = phi_1019_;
                                    phi_1021_ = type_25(array<array<u32, 2>, 4>(_e530, _e533, _e536, _e539), array<array<u32, 2>, 4>(_e565, _e590, _e615, _e640));
                                    phi_1022_ = false;
                                } else {
                                    phi_1021_ = type_25();
                                    phi_1022_ = true;
                                }
                                let _e644 = phi_1021_;
                                let _e646 = phi_1022_;
                                phi_1023_ = _e644;
                                phi_1024_ = _e646;
                            } else {
                                phi_1023_ = type_25();
                                phi_1024_ = true;
                            }
                            let _e648 = phi_1023_;
                            let _e650 = phi_1024_;
                            if _e650 {
                                if _e507 {
                                    let _e738 = a.member[_e350.member_1];
                                    let _e743 = a.member[_e350.member_3];
                                    let _e747 = array<u32, 2>(_e350.member_1, _e316[1]);
                                    let _e749 = array<u32, 2>(_e350.member_3, _e316[1]);
                                    let _e752 = type_25(array<array<u32, 2>, 4>(_e747, _e749, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e738.member[0] <= _e352.member_2[0]) && (_e352.member[0] <= _e738.member_2[0])) && (_e738.member[1] <= _e352.member_2[1])) && (_e352.member[1] <= _e738.member_2[1])) && (_e738.member[2] <= _e352.member_2[2])) && (_e352.member[2] <= _e738.member_2[2])) {
                                        phi_1097_ = _e747;
                                    } else {
                                        phi_1097_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e779 = phi_1097_;
                                    let _e786 = type_25(_e752.member, array<array<u32, 2>, 4>(_e779, _e752.member_1[1], _e752.member_1[2], _e752.member_1[3]));
                                    if ((((((_e743.member[0] <= _e352.member_2[0]) && (_e352.member[0] <= _e743.member_2[0])) && (_e743.member[1] <= _e352.member_2[1])) && (_e352.member[1] <= _e743.member_2[1])) && (_e743.member[2] <= _e352.member_2[2])) && (_e352.member[2] <= _e743.member_2[2])) {
                                        phi_1129_ = _e749;
                                    } else {
                                        phi_1129_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e813 = phi_1129_;
                                    phi_1231_ = type_25(_e786.member, array<array<u32, 2>, 4>(_e786.member_1[0], _e813, _e786.member_1[2], _e786.member_1[3]));
                                } else {
                                    let _e653 = b.member[_e352.member_1];
                                    let _e658 = b.member[_e352.member_3];
                                    let _e662 = array<u32, 2>(_e316[0], _e352.member_1);
                                    let _e664 = array<u32, 2>(_e316[0], _e352.member_3);
                                    let _e667 = type_25(array<array<u32, 2>, 4>(_e662, _e664, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e350.member[0] <= _e653.member_2[0]) && (_e653.member[0] <= _e350.member_2[0])) && (_e350.member[1] <= _e653.member_2[1])) && (_e653.member[1] <= _e350.member_2[1])) && (_e350.member[2] <= _e653.member_2[2])) && (_e653.member[2] <= _e350.member_2[2])) {
                                        phi_1197_ = _e662;
                                    } else {
                                        phi_1197_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e694 = phi_1197_;
                                    let _e701 = type_25(_e667.member, array<array<u32, 2>, 4>(_e694, _e667.member_1[1], _e667.member_1[2], _e667.member_1[3]));
                                    if ((((((_e350.member[0] <= _e658.member_2[0]) && (_e658.member[0] <= _e350.member_2[0])) && (_e350.member[1] <= _e658.member_2[1])) && (_e658.member[1] <= _e350.member_2[1])) && (_e350.member[2] <= _e658.member_2[2])) && (_e658.member[2] <= _e350.member_2[2])) {
                                        phi_1229_ = _e664;
                                    } else {
                                        phi_1229_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e728 = phi_1229_;
                                    phi_1231_ = type_25(_e701.member, array<array<u32, 2>, 4>(_e701.member_1[0], _e728, _e701.member_1[2], _e701.member_1[3]));
                                }
                                let _e822 = phi_1231_;
                                phi_1232_ = _e822;
                            } else {
                                phi_1232_ = _e648;
                            }
                            let _e824 = phi_1232_;
                            phi_1233_ = _e824;
                            phi_1234_ = false;
                        } else {
                            phi_1233_ = type_25();
                            phi_1234_ = true;
                        }
                        let _e826 = phi_1233_;
                        let _e828 = phi_1234_;
                        phi_1235_ = _e826;
                        phi_1236_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1237_ = _e828;
                    } else {
                        phi_1235_ = type_25();
                        phi_1236_ = _e456;
                        phi_1237_ = true;
                    }
                    let _e830 = phi_1235_;
                    let _e832 = phi_1236_;
                    let _e834 = phi_1237_;
                    if _e834 {
                        phi_1241_ = _e832;
                    } else {
                        phi_1241_ = _e830;
                    }
                    let _e836 = phi_1241_;
                    let _e840 = params.member.member_2.member;
                    if (_e840 == 0u) {
                        phi_1259_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1259_ = array<u32, 2>(1u, 1u);
                    }
                    let _e843 = phi_1259_;
                    let _e849 = params.member.member.member[_e843[0]];
                    let _e850 = (_e849 - 1u);
                    let _e854 = params.member.member.member[_e843[1]];
                    let _e855 = (_e854 - 1u);
                    let _e858 = params.member.member_2.member;
                    if (_e858 == 0u) {
                        phi_1290_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1290_ = array<u32, 2>(1u, 1u);
                    }
                    let _e861 = phi_1290_;
                    let _e867 = params.member.member.member_2[_e861[0]];
                    let _e871 = params.member.member.member_2[_e861[1]];
                    let _e874 = params.member.member_2.member;
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e836.member_1[0][0], _e836.member_1[0][1]), array<u32, 2>(_e836.member_1[1][0], _e836.member_1[1][1]), array<u32, 2>(_e836.member_1[2][0], _e836.member_1[2][1]), array<u32, 2>(_e836.member_1[3][0], _e836.member_1[3][1]));
                    phi_1335_ = type_9(0u, 4u);
                    loop {
                        let _e894 = phi_1335_;
                        if (_e894.member < _e894.member_1) {
                            phi_1336_ = type_9((_e894.member + 1u), _e894.member_1);
                            phi_1359_ = type_9(1u, _e894.member);
                        } else {
                            phi_1336_ = _e894;
                            phi_1359_ = type_9(0u, type_9().member_1);
                        }
                        let _e906 = phi_1336_;
                        let _e908 = phi_1359_;
                        let _e912 = (bitcast<i32>(_e908.member) != 0i);
                        if _e912 {
                            let _e914 = local_1[_e908.member_1];
                            if (_e914[0] != 4294967295u) {
                                if (_e874 == 1u) {
                                    phi_1388_ = (_e914[0] == _e914[1]);
                                } else {
                                    phi_1388_ = false;
                                }
                                let _e920 = phi_1388_;
                                if _e920 {
                                    phi_3597_ = bool();
                                    phi_3598_ = true;
                                } else {
                                    if (_e914[0] >= _e850) {
                                        if (_e914[1] >= _e855) {
                                            phi_1400_ = false;
                                        } else {
                                            phi_1400_ = true;
                                        }
                                        let _e924 = phi_1400_;
                                        phi_1401_ = _e924;
                                    } else {
                                        phi_1401_ = true;
                                    }
                                    let _e926 = phi_1401_;
                                    if _e926 {
                                        if (_e914[0] < _e850) {
                                            let _e1006 = oriented.member[(_e867 + _e914[0])];
                                            phi_1548_ = type_32(array<f32, 3>(_e1006.member.x, _e1006.member.y, _e1006.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1006.member.w, _e1006.member_1.x, _e1006.member_1.y), array<f32, 3>(_e1006.member_1.z, _e1006.member_1.w, _e1006.member_2.x), array<f32, 3>(_e1006.member_2.y, _e1006.member_2.z, _e1006.member_2.w)), array<f32, 3>(_e1006.member_3.x, _e1006.member_3.y, _e1006.member_3.z));
                                        } else {
                                            let _e929 = a.member[_e914[0]];
                                            let _e944 = ((_e929.member[0] * 0.5f) + (_e929.member_2[0] * 0.5f));
                                            let _e945 = ((_e929.member[1] * 0.5f) + (_e929.member_2[1] * 0.5f));
                                            let _e946 = ((_e929.member[2] * 0.5f) + (_e929.member_2[2] * 0.5f));
                                            if (_e944 < _e929.member_2[0]) {
                                                phi_1474_ = _e944;
                                            } else {
                                                phi_1474_ = _e929.member_2[0];
                                            }
                                            let _e950 = phi_1474_;
                                            if (_e945 < _e929.member_2[1]) {
                                                phi_1480_ = _e945;
                                            } else {
                                                phi_1480_ = _e929.member_2[1];
                                            }
                                            let _e954 = phi_1480_;
                                            if (_e946 < _e929.member_2[2]) {
                                                phi_1486_ = _e946;
                                            } else {
                                                phi_1486_ = _e929.member_2[2];
                                            }
                                            let _e958 = phi_1486_;
                                            if (_e950 > _e929.member[0]) {
                                                phi_1492_ = _e950;
                                            } else {
                                                phi_1492_ = _e929.member[0];
                                            }
                                            let _e962 = phi_1492_;
                                            if (_e954 > _e929.member[1]) {
                                                phi_1498_ = _e954;
                                            } else {
                                                phi_1498_ = _e929.member[1];
                                            }
                                            let _e966 = phi_1498_;
                                            if (_e958 > _e929.member[2]) {
                                                phi_1504_ = _e958;
                                            } else {
                                                phi_1504_ = _e929.member[2];
                                            }
                                            let _e970 = phi_1504_;
                                            let _e973 = (_e929.member_2[0] - _e962);
                                            let _e975 = (_e929.member_2[1] - _e966);
                                            let _e977 = (_e929.member_2[2] - _e970);
                                            let _e979 = (_e962 - _e929.member[0]);
                                            let _e981 = (_e966 - _e929.member[1]);
                                            let _e983 = (_e970 - _e929.member[2]);
                                            if (_e973 > _e979) {
                                                phi_1522_ = _e973;
                                            } else {
                                                phi_1522_ = _e979;
                                            }
                                            let _e986 = phi_1522_;
                                            if (_e975 > _e981) {
                                                phi_1527_ = _e975;
                                            } else {
                                                phi_1527_ = _e981;
                                            }
                                            let _e989 = phi_1527_;
                                            if (_e977 > _e983) {
                                                phi_1532_ = _e977;
                                            } else {
                                                phi_1532_ = _e983;
                                            }
                                            let _e992 = phi_1532_;
                                            let _e994 = (1f + (0.000000059604645f * 4f));
                                            let _e998 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1548_ = type_32(array<f32, 3>(_e962, _e966, _e970), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e986 * _e994) + _e998), ((_e989 * _e994) + _e998), ((_e992 * _e994) + _e998)));
                                        }
                                        let _e1045 = phi_1548_;
                                        if (_e914[1] < _e855) {
                                            let _e1125 = oriented.member[(_e871 + _e914[1])];
                                            phi_1692_ = type_32(array<f32, 3>(_e1125.member.x, _e1125.member.y, _e1125.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1125.member.w, _e1125.member_1.x, _e1125.member_1.y), array<f32, 3>(_e1125.member_1.z, _e1125.member_1.w, _e1125.member_2.x), array<f32, 3>(_e1125.member_2.y, _e1125.member_2.z, _e1125.member_2.w)), array<f32, 3>(_e1125.member_3.x, _e1125.member_3.y, _e1125.member_3.z));
                                        } else {
                                            let _e1048 = b.member[_e914[1]];
                                            let _e1063 = ((_e1048.member[0] * 0.5f) + (_e1048.member_2[0] * 0.5f));
                                            let _e1064 = ((_e1048.member[1] * 0.5f) + (_e1048.member_2[1] * 0.5f));
                                            let _e1065 = ((_e1048.member[2] * 0.5f) + (_e1048.member_2[2] * 0.5f));
                                            if (_e1063 < _e1048.member_2[0]) {
                                                phi_1618_ = _e1063;
                                            } else {
                                                phi_1618_ = _e1048.member_2[0];
                                            }
                                            let _e1069 = phi_1618_;
                                            if (_e1064 < _e1048.member_2[1]) {
                                                phi_1624_ = _e1064;
                                            } else {
                                                phi_1624_ = _e1048.member_2[1];
                                            }
                                            let _e1073 = phi_1624_;
                                            if (_e1065 < _e1048.member_2[2]) {
                                                phi_1630_ = _e1065;
                                            } else {
                                                phi_1630_ = _e1048.member_2[2];
                                            }
                                            let _e1077 = phi_1630_;
                                            if (_e1069 > _e1048.member[0]) {
                                                phi_1636_ = _e1069;
                                            } else {
                                                phi_1636_ = _e1048.member[0];
                                            }
                                            let _e1081 = phi_1636_;
                                            if (_e1073 > _e1048.member[1]) {
                                                phi_1642_ = _e1073;
                                            } else {
                                                phi_1642_ = _e1048.member[1];
                                            }
                                            let _e1085 = phi_1642_;
                                            if (_e1077 > _e1048.member[2]) {
                                                phi_1648_ = _e1077;
                                            } else {
                                                phi_1648_ = _e1048.member[2];
                                            }
                                            let _e1089 = phi_1648_;
                                            let _e1092 = (_e1048.member_2[0] - _e1081);
                                            let _e1094 = (_e1048.member_2[1] - _e1085);
                                            let _e1096 = (_e1048.member_2[2] - _e1089);
                                            let _e1098 = (_e1081 - _e1048.member[0]);
                                            let _e1100 = (_e1085 - _e1048.member[1]);
                                            let _e1102 = (_e1089 - _e1048.member[2]);
                                            if (_e1092 > _e1098) {
                                                phi_1666_ = _e1092;
                                            } else {
                                                phi_1666_ = _e1098;
                                            }
                                            let _e1105 = phi_1666_;
                                            if (_e1094 > _e1100) {
                                                phi_1671_ = _e1094;
                                            } else {
                                                phi_1671_ = _e1100;
                                            }
                                            let _e1108 = phi_1671_;
                                            if (_e1096 > _e1102) {
                                                phi_1676_ = _e1096;
                                            } else {
                                                phi_1676_ = _e1102;
                                            }
                                            let _e1111 = phi_1676_;
                                            let _e1113 = (1f + (0.000000059604645f * 4f));
                                            let _e1117 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1692_ = type_32(array<f32, 3>(_e1081, _e1085, _e1089), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1105 * _e1113) + _e1117), ((_e1108 * _e1113) + _e1117), ((_e1111 * _e1113) + _e1117)));
                                        }
                                        let _e1164 = phi_1692_;
                                        let _e1169 = (_e1164.member[0] - _e1045.member[0]);
                                        let _e1172 = (_e1164.member[1] - _e1045.member[1]);
                                        let _e1175 = (_e1164.member[2] - _e1045.member[2]);
                                        if (_e1169 < 0f) {
                                            phi_1882_ = -(_e1169);
                                        } else {
                                            phi_1882_ = _e1169;
                                        }
                                        let _e1364 = phi_1882_;
                                        if (_e1172 < 0f) {
                                            phi_1888_ = -(_e1172);
                                        } else {
                                            phi_1888_ = _e1172;
                                        }
                                        let _e1368 = phi_1888_;
                                        if (_e1175 < 0f) {
                                            phi_1895_ = -(_e1175);
                                        } else {
                                            phi_1895_ = _e1175;
                                        }
                                        let _e1373 = phi_1895_;
                                        if (_e1045.member_2[0] < 0f) {
                                            phi_1904_ = -(_e1045.member_2[0]);
                                        } else {
                                            phi_1904_ = _e1045.member_2[0];
                                        }
                                        let _e1380 = phi_1904_;
                                        if (_e1045.member_2[1] < 0f) {
                                            phi_1911_ = -(_e1045.member_2[1]);
                                        } else {
                                            phi_1911_ = _e1045.member_2[1];
                                        }
                                        let _e1385 = phi_1911_;
                                        if (_e1045.member_2[2] < 0f) {
                                            phi_1919_ = -(_e1045.member_2[2]);
                                        } else {
                                            phi_1919_ = _e1045.member_2[2];
                                        }
                                        let _e1391 = phi_1919_;
                                        if (_e1164.member_2[0] < 0f) {
                                            phi_1928_ = -(_e1164.member_2[0]);
                                        } else {
                                            phi_1928_ = _e1164.member_2[0];
                                        }
                                        let _e1398 = phi_1928_;
                                        if (_e1164.member_2[1] < 0f) {
                                            phi_1935_ = -(_e1164.member_2[1]);
                                        } else {
                                            phi_1935_ = _e1164.member_2[1];
                                        }
                                        let _e1403 = phi_1935_;
                                        if (_e1164.member_2[2] < 0f) {
                                            phi_1943_ = -(_e1164.member_2[2]);
                                        } else {
                                            phi_1943_ = _e1164.member_2[2];
                                        }
                                        let _e1409 = phi_1943_;
                                        local = type_27(array<array<f32, 3>, 3>(array<f32, 3>((((_e1164.member_1[0][0] * _e1045.member_1[0][0]) + (_e1164.member_1[0][1] * _e1045.member_1[0][1])) + (_e1164.member_1[0][2] * _e1045.member_1[0][2])), (((_e1164.member_1[1][0] * _e1045.member_1[0][0]) + (_e1164.member_1[1][1] * _e1045.member_1[0][1])) + (_e1164.member_1[1][2] * _e1045.member_1[0][2])), (((_e1164.member_1[2][0] * _e1045.member_1[0][0]) + (_e1164.member_1[2][1] * _e1045.member_1[0][1])) + (_e1164.member_1[2][2] * _e1045.member_1[0][2]))), array<f32, 3>((((_e1164.member_1[0][0] * _e1045.member_1[1][0]) + (_e1164.member_1[0][1] * _e1045.member_1[1][1])) + (_e1164.member_1[0][2] * _e1045.member_1[1][2])), (((_e1164.member_1[1][0] * _e1045.member_1[1][0]) + (_e1164.member_1[1][1] * _e1045.member_1[1][1])) + (_e1164.member_1[1][2] * _e1045.member_1[1][2])), (((_e1164.member_1[2][0] * _e1045.member_1[1][0]) + (_e1164.member_1[2][1] * _e1045.member_1[1][1])) + (_e1164.member_1[2][2] * _e1045.member_1[1][2]))), array<f32, 3>((((_e1164.member_1[0][0] * _e1045.member_1[2][0]) + (_e1164.member_1[0][1] * _e1045.member_1[2][1])) + (_e1164.member_1[0][2] * _e1045.member_1[2][2])), (((_e1164.member_1[1][0] * _e1045.member_1[2][0]) + (_e1164.member_1[1][1] * _e1045.member_1[2][1])) + (_e1164.member_1[1][2] * _e1045.member_1[2][2])), (((_e1164.member_1[2][0] * _e1045.member_1[2][0]) + (_e1164.member_1[2][1] * _e1045.member_1[2][1])) + (_e1164.member_1[2][2] * _e1045.member_1[2][2])))), array<f32, 3>((((_e1045.member_1[0][0] * _e1169) + (_e1045.member_1[0][1] * _e1172)) + (_e1045.member_1[0][2] * _e1175)), (((_e1045.member_1[1][0] * _e1169) + (_e1045.member_1[1][1] * _e1172)) + (_e1045.member_1[1][2] * _e1175)), (((_e1045.member_1[2][0] * _e1169) + (_e1045.member_1[2][1] * _e1172)) + (_e1045.member_1[2][2] * _e1175))), array<f32, 3>((((_e1164.member_1[0][0] * _e1169) + (_e1164.member_1[0][1] * _e1172)) + (_e1164.member_1[0][2] * _e1175)), (((_e1164.member_1[1][0] * _e1169) + (_e1164.member_1[1][1] * _e1172)) + (_e1164.member_1[1][2] * _e1175)), (((_e1164.member_1[2][0] * _e1169) + (_e1164.member_1[2][1] * _e1172)) + (_e1164.member_1[2][2] * _e1175))), array<f32, 3>(_e1045.member_2[0], _e1045.member_2[1], _e1045.member_2[2]), array<f32, 3>(_e1164.member_2[0], _e1164.member_2[1], _e1164.member_2[2]), ((((((_e1364 + _e1368) + _e1373) + (((_e1380 + _e1385) + _e1391) + ((_e1398 + _e1403) + _e1409))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1436 = local.member[0u][0u];
                                        let _e1440 = local.member[0u][1u];
                                        let _e1444 = local.member[0u][2u];
                                        let _e1448 = local.member[1u][0u];
                                        let _e1452 = local.member[1u][1u];
                                        let _e1456 = local.member[1u][2u];
                                        let _e1460 = local.member[2u][0u];
                                        let _e1464 = local.member[2u][1u];
                                        let _e1468 = local.member[2u][2u];
                                        let _e1470 = local.member_3;
                                        let _e1475 = local.member_4;
                                        let _e1481 = local.member_1[0u];
                                        if (_e1481 < 0f) {
                                            phi_2036_ = -(_e1481);
                                        } else {
                                            phi_2036_ = _e1481;
                                        }
                                        let _e1485 = phi_2036_;
                                        if (_e1436 < 0f) {
                                            phi_2043_ = -(_e1436);
                                        } else {
                                            phi_2043_ = _e1436;
                                        }
                                        let _e1489 = phi_2043_;
                                        if (_e1440 < 0f) {
                                            phi_2049_ = -(_e1440);
                                        } else {
                                            phi_2049_ = _e1440;
                                        }
                                        let _e1493 = phi_2049_;
                                        if (_e1444 < 0f) {
                                            phi_2055_ = -(_e1444);
                                        } else {
                                            phi_2055_ = _e1444;
                                        }
                                        let _e1497 = phi_2055_;
                                        let _e1504 = (_e1485 - (_e1470[0] + (((_e1489 * _e1475[0]) + (_e1493 * _e1475[1])) + (_e1497 * _e1475[2]))));
                                        let _e1507 = local.member_1[1u];
                                        if (_e1507 < 0f) {
                                            phi_2074_ = -(_e1507);
                                        } else {
                                            phi_2074_ = _e1507;
                                        }
                                        let _e1511 = phi_2074_;
                                        if (_e1448 < 0f) {
                                            phi_2081_ = -(_e1448);
                                        } else {
                                            phi_2081_ = _e1448;
                                        }
                                        let _e1515 = phi_2081_;
                                        if (_e1452 < 0f) {
                                            phi_2087_ = -(_e1452);
                                        } else {
                                            phi_2087_ = _e1452;
                                        }
                                        let _e1519 = phi_2087_;
                                        if (_e1456 < 0f) {
                                            phi_2093_ = -(_e1456);
                                        } else {
                                            phi_2093_ = _e1456;
                                        }
                                        let _e1523 = phi_2093_;
                                        let _e1530 = (_e1511 - (_e1470[1] + (((_e1515 * _e1475[0]) + (_e1519 * _e1475[1])) + (_e1523 * _e1475[2]))));
                                        let _e1533 = local.member_1[2u];
                                        if (_e1533 < 0f) {
                                            phi_2112_ = -(_e1533);
                                        } else {
                                            phi_2112_ = _e1533;
                                        }
                                        let _e1537 = phi_2112_;
                                        if (_e1460 < 0f) {
                                            phi_2119_ = -(_e1460);
                                        } else {
                                            phi_2119_ = _e1460;
                                        }
                                        let _e1541 = phi_2119_;
                                        if (_e1464 < 0f) {
                                            phi_2125_ = -(_e1464);
                                        } else {
                                            phi_2125_ = _e1464;
                                        }
                                        let _e1545 = phi_2125_;
                                        if (_e1468 < 0f) {
                                            phi_2131_ = -(_e1468);
                                        } else {
                                            phi_2131_ = _e1468;
                                        }
                                        let _e1549 = phi_2131_;
                                        let _e1556 = (_e1537 - (_e1470[2] + (((_e1541 * _e1475[0]) + (_e1545 * _e1475[1])) + (_e1549 * _e1475[2]))));
                                        let _e1559 = local.member_2[0u];
                                        if (_e1559 < 0f) {
                                            phi_2150_ = -(_e1559);
                                        } else {
                                            phi_2150_ = _e1559;
                                        }
                                        let _e1563 = phi_2150_;
                                        if (_e1436 < 0f) {
                                            phi_2157_ = -(_e1436);
                                        } else {
                                            phi_2157_ = _e1436;
                                        }
                                        let _e1567 = phi_2157_;
                                        if (_e1448 < 0f) {
                                            phi_2163_ = -(_e1448);
                                        } else {
                                            phi_2163_ = _e1448;
                                        }
                                        let _e1571 = phi_2163_;
                                        if (_e1460 < 0f) {
                                            phi_2169_ = -(_e1460);
                                        } else {
                                            phi_2169_ = _e1460;
                                        }
                                        let _e1575 = phi_2169_;
                                        let _e1582 = (_e1563 - (_e1475[0] + (((_e1567 * _e1470[0]) + (_e1571 * _e1470[1])) + (_e1575 * _e1470[2]))));
                                        let _e1585 = local.member_2[1u];
                                        if (_e1585 < 0f) {
                                            phi_2188_ = -(_e1585);
                                        } else {
                                            phi_2188_ = _e1585;
                                        }
                                        let _e1589 = phi_2188_;
                                        if (_e1440 < 0f) {
                                            phi_2195_ = -(_e1440);
                                        } else {
                                            phi_2195_ = _e1440;
                                        }
                                        let _e1593 = phi_2195_;
                                        if (_e1452 < 0f) {
                                            phi_2201_ = -(_e1452);
                                        } else {
                                            phi_2201_ = _e1452;
                                        }
                                        let _e1597 = phi_2201_;
                                        if (_e1464 < 0f) {
                                            phi_2207_ = -(_e1464);
                                        } else {
                                            phi_2207_ = _e1464;
                                        }
                                        let _e1601 = phi_2207_;
                                        let _e1608 = (_e1589 - (_e1475[1] + (((_e1593 * _e1470[0]) + (_e1597 * _e1470[1])) + (_e1601 * _e1470[2]))));
                                        let _e1611 = local.member_2[2u];
                                        if (_e1611 < 0f) {
                                            phi_2226_ = -(_e1611);
                                        } else {
                                            phi_2226_ = _e1611;
                                        }
                                        let _e1615 = phi_2226_;
                                        if (_e1444 < 0f) {
                                            phi_2233_ = -(_e1444);
                                        } else {
                                            phi_2233_ = _e1444;
                                        }
                                        let _e1619 = phi_2233_;
                                        if (_e1456 < 0f) {
                                            phi_2239_ = -(_e1456);
                                        } else {
                                            phi_2239_ = _e1456;
                                        }
                                        let _e1623 = phi_2239_;
                                        if (_e1468 < 0f) {
                                            phi_2245_ = -(_e1468);
                                        } else {
                                            phi_2245_ = _e1468;
                                        }
                                        let _e1627 = phi_2245_;
                                        let _e1634 = (_e1615 - (_e1475[2] + (((_e1619 * _e1470[0]) + (_e1623 * _e1470[1])) + (_e1627 * _e1470[2]))));
                                        if (_e1504 > _e1530) {
                                            phi_2260_ = _e1504;
                                        } else {
                                            phi_2260_ = _e1530;
                                        }
                                        let _e1637 = phi_2260_;
                                        if (_e1637 > _e1556) {
                                            phi_2265_ = _e1637;
                                        } else {
                                            phi_2265_ = _e1556;
                                        }
                                        let _e1640 = phi_2265_;
                                        if (_e1582 > _e1608) {
                                            phi_2270_ = _e1582;
                                        } else {
                                            phi_2270_ = _e1608;
                                        }
                                        let _e1643 = phi_2270_;
                                        if (_e1643 > _e1634) {
                                            phi_2275_ = _e1643;
                                        } else {
                                            phi_2275_ = _e1634;
                                        }
                                        let _e1646 = phi_2275_;
                                        if (_e1640 > _e1646) {
                                            phi_2280_ = _e1640;
                                        } else {
                                            phi_2280_ = _e1646;
                                        }
                                        let _e1649 = phi_2280_;
                                        let _e1651 = local.member_5;
                                        if (_e1649 > _e1651) {
                                            phi_3593_ = true;
                                        } else {
                                            let _e1656 = local.member[1u][0u];
                                            let _e1659 = local.member_1[2u];
                                            let _e1664 = local.member[2u][0u];
                                            let _e1667 = local.member_1[1u];
                                            let _e1669 = ((_e1656 * _e1659) - (_e1664 * _e1667));
                                            let _e1673 = local.member[2u][0u];
                                            if (_e1673 < 0f) {
                                                phi_2339_ = -(_e1673);
                                            } else {
                                                phi_2339_ = _e1673;
                                            }
                                            let _e1677 = phi_2339_;
                                            let _e1680 = local.member_3[1u];
                                            let _e1685 = local.member[1u][0u];
                                            if (_e1685 < 0f) {
                                                phi_2362_ = -(_e1685);
                                            } else {
                                                phi_2362_ = _e1685;
                                            }
                                            let _e1689 = phi_2362_;
                                            let _e1692 = local.member_3[2u];
                                            let _e1698 = local.member[0u][2u];
                                            if (_e1698 < 0f) {
                                                phi_2385_ = -(_e1698);
                                            } else {
                                                phi_2385_ = _e1698;
                                            }
                                            let _e1702 = phi_2385_;
                                            let _e1705 = local.member_4[1u];
                                            let _e1710 = local.member[0u][1u];
                                            if (_e1710 < 0f) {
                                                phi_2407_ = -(_e1710);
                                            } else {
                                                phi_2407_ = _e1710;
                                            }
                                            let _e1714 = phi_2407_;
                                            let _e1717 = local.member_4[2u];
                                            if (_e1669 < 0f) {
                                                phi_2423_ = -(_e1669);
                                            } else {
                                                phi_2423_ = _e1669;
                                            }
                                            let _e1723 = phi_2423_;
                                            let _e1725 = (_e1723 - (((_e1677 * _e1680) + (_e1689 * _e1692)) + ((_e1702 * _e1705) + (_e1714 * _e1717))));
                                            let _e1729 = local.member[1u][1u];
                                            let _e1732 = local.member_1[2u];
                                            let _e1737 = local.member[2u][1u];
                                            let _e1740 = local.member_1[1u];
                                            let _e1742 = ((_e1729 * _e1732) - (_e1737 * _e1740));
                                            let _e1746 = local.member[2u][1u];
                                            if (_e1746 < 0f) {
                                                phi_2478_ = -(_e1746);
                                            } else {
                                                phi_2478_ = _e1746;
                                            }
                                            let _e1750 = phi_2478_;
                                            let _e1753 = local.member_3[1u];
                                            let _e1758 = local.member[1u][1u];
                                            if (_e1758 < 0f) {
                                                phi_2501_ = -(_e1758);
                                            } else {
                                                phi_2501_ = _e1758;
                                            }
                                            let _e1762 = phi_2501_;
                                            let _e1765 = local.member_3[2u];
                                            let _e1771 = local.member[0u][0u];
                                            if (_e1771 < 0f) {
                                                phi_2524_ = -(_e1771);
                                            } else {
                                                phi_2524_ = _e1771;
                                            }
                                            let _e1775 = phi_2524_;
                                            let _e1778 = local.member_4[2u];
                                            let _e1783 = local.member[0u][2u];
                                            if (_e1783 < 0f) {
                                                phi_2546_ = -(_e1783);
                                            } else {
                                                phi_2546_ = _e1783;
                                            }
                                            let _e1787 = phi_2546_;
                                            let _e1790 = local.member_4[0u];
                                            if (_e1742 < 0f) {
                                                phi_2562_ = -(_e1742);
                                            } else {
                                                phi_2562_ = _e1742;
                                            }
                                            let _e1796 = phi_2562_;
                                            let _e1798 = (_e1796 - (((_e1750 * _e1753) + (_e1762 * _e1765)) + ((_e1775 * _e1778) + (_e1787 * _e1790))));
                                            let _e1802 = local.member[1u][2u];
                                            let _e1805 = local.member_1[2u];
                                            let _e1810 = local.member[2u][2u];
                                            let _e1813 = local.member_1[1u];
                                            let _e1815 = ((_e1802 * _e1805) - (_e1810 * _e1813));
                                            let _e1819 = local.member[2u][2u];
                                            if (_e1819 < 0f) {
                                                phi_2617_ = -(_e1819);
                                            } else {
                                                phi_2617_ = _e1819;
                                            }
                                            let _e1823 = phi_2617_;
                                            let _e1826 = local.member_3[1u];
                                            let _e1831 = local.member[1u][2u];
                                            if (_e1831 < 0f) {
                                                phi_2640_ = -(_e1831);
                                            } else {
                                                phi_2640_ = _e1831;
                                            }
                                            let _e1835 = phi_2640_;
                                            let _e1838 = local.member_3[2u];
                                            let _e1844 = local.member[0u][1u];
                                            if (_e1844 < 0f) {
                                                phi_2663_ = -(_e1844);
                                            } else {
                                                phi_2663_ = _e1844;
                                            }
                                            let _e1848 = phi_2663_;
                                            let _e1851 = local.member_4[0u];
                                            let _e1856 = local.member[0u][0u];
                                            if (_e1856 < 0f) {
                                                phi_2685_ = -(_e1856);
                                            } else {
                                                phi_2685_ = _e1856;
                                            }
                                            let _e1860 = phi_2685_;
                                            let _e1863 = local.member_4[1u];
                                            if (_e1815 < 0f) {
                                                phi_2701_ = -(_e1815);
                                            } else {
                                                phi_2701_ = _e1815;
                                            }
                                            let _e1869 = phi_2701_;
                                            let _e1871 = (_e1869 - (((_e1823 * _e1826) + (_e1835 * _e1838)) + ((_e1848 * _e1851) + (_e1860 * _e1863))));
                                            let _e1875 = local.member[2u][0u];
                                            let _e1878 = local.member_1[0u];
                                            let _e1883 = local.member[0u][0u];
                                            let _e1886 = local.member_1[2u];
                                            let _e1888 = ((_e1875 * _e1878) - (_e1883 * _e1886));
                                            let _e1892 = local.member[0u][0u];
                                            if (_e1892 < 0f) {
                                                phi_2756_ = -(_e1892);
                                            } else {
                                                phi_2756_ = _e1892;
                                            }
                                            let _e1896 = phi_2756_;
                                            let _e1899 = local.member_3[2u];
                                            let _e1904 = local.member[2u][0u];
                                            if (_e1904 < 0f) {
                                                phi_2779_ = -(_e1904);
                                            } else {
                                                phi_2779_ = _e1904;
                                            }
                                            let _e1908 = phi_2779_;
                                            let _e1911 = local.member_3[0u];
                                            let _e1917 = local.member[1u][2u];
                                            if (_e1917 < 0f) {
                                                phi_2803_ = -(_e1917);
                                            } else {
                                                phi_2803_ = _e1917;
                                            }
                                            let _e1921 = phi_2803_;
                                            let _e1924 = local.member_4[1u];
                                            let _e1929 = local.member[1u][1u];
                                            if (_e1929 < 0f) {
                                                phi_2826_ = -(_e1929);
                                            } else {
                                                phi_2826_ = _e1929;
                                            }
                                            let _e1933 = phi_2826_;
                                            let _e1936 = local.member_4[2u];
                                            if (_e1888 < 0f) {
                                                phi_2842_ = -(_e1888);
                                            } else {
                                                phi_2842_ = _e1888;
                                            }
                                            let _e1942 = phi_2842_;
                                            let _e1944 = (_e1942 - (((_e1896 * _e1899) + (_e1908 * _e1911)) + ((_e1921 * _e1924) + (_e1933 * _e1936))));
                                            let _e1948 = local.member[2u][1u];
                                            let _e1951 = local.member_1[0u];
                                            let _e1956 = local.member[0u][1u];
                                            let _e1959 = local.member_1[2u];
                                            let _e1961 = ((_e1948 * _e1951) - (_e1956 * _e1959));
                                            let _e1965 = local.member[0u][1u];
                                            if (_e1965 < 0f) {
                                                phi_2897_ = -(_e1965);
                                            } else {
                                                phi_2897_ = _e1965;
                                            }
                                            let _e1969 = phi_2897_;
                                            let _e1972 = local.member_3[2u];
                                            let _e1977 = local.member[2u][1u];
                                            if (_e1977 < 0f) {
                                                phi_2920_ = -(_e1977);
                                            } else {
                                                phi_2920_ = _e1977;
                                            }
                                            let _e1981 = phi_2920_;
                                            let _e1984 = local.member_3[0u];
                                            let _e1990 = local.member[1u][0u];
                                            if (_e1990 < 0f) {
                                                phi_2944_ = -(_e1990);
                                            } else {
                                                phi_2944_ = _e1990;
                                            }
                                            let _e1994 = phi_2944_;
                                            let _e1997 = local.member_4[2u];
                                            let _e2002 = local.member[1u][2u];
                                            if (_e2002 < 0f) {
                                                phi_2967_ = -(_e2002);
                                            } else {
                                                phi_2967_ = _e2002;
                                            }
                                            let _e2006 = phi_2967_;
                                            let _e2009 = local.member_4[0u];
                                            if (_e1961 < 0f) {
                                                phi_2983_ = -(_e1961);
                                            } else {
                                                phi_2983_ = _e1961;
                                            }
                                            let _e2015 = phi_2983_;
                                            let _e2017 = (_e2015 - (((_e1969 * _e1972) + (_e1981 * _e1984)) + ((_e1994 * _e1997) + (_e2006 * _e2009))));
                                            let _e2021 = local.member[2u][2u];
                                            let _e2024 = local.member_1[0u];
                                            let _e2029 = local.member[0u][2u];
                                            let _e2032 = local.member_1[2u];
                                            let _e2034 = ((_e2021 * _e2024) - (_e2029 * _e2032));
                                            let _e2038 = local.member[0u][2u];
                                            if (_e2038 < 0f) {
                                                phi_3038_ = -(_e2038);
                                            } else {
                                                phi_3038_ = _e2038;
                                            }
                                            let _e2042 = phi_3038_;
                                            let _e2045 = local.member_3[2u];
                                            let _e2050 = local.member[2u][2u];
                                            if (_e2050 < 0f) {
                                                phi_3061_ = -(_e2050);
                                            } else {
                                                phi_3061_ = _e2050;
                                            }
                                            let _e2054 = phi_3061_;
                                            let _e2057 = local.member_3[0u];
                                            let _e2063 = local.member[1u][1u];
                                            if (_e2063 < 0f) {
                                                phi_3085_ = -(_e2063);
                                            } else {
                                                phi_3085_ = _e2063;
                                            }
                                            let _e2067 = phi_3085_;
                                            let _e2070 = local.member_4[0u];
                                            let _e2075 = local.member[1u][0u];
                                            if (_e2075 < 0f) {
                                                phi_3108_ = -(_e2075);
                                            } else {
                                                phi_3108_ = _e2075;
                                            }
                                            let _e2079 = phi_3108_;
                                            let _e2082 = local.member_4[1u];
                                            if (_e2034 < 0f) {
                                                phi_3124_ = -(_e2034);
                                            } else {
                                                phi_3124_ = _e2034;
                                            }
                                            let _e2088 = phi_3124_;
                                            let _e2090 = (_e2088 - (((_e2042 * _e2045) + (_e2054 * _e2057)) + ((_e2067 * _e2070) + (_e2079 * _e2082))));
                                            let _e2094 = local.member[0u][0u];
                                            let _e2097 = local.member_1[1u];
                                            let _e2102 = local.member[1u][0u];
                                            let _e2105 = local.member_1[0u];
                                            let _e2107 = ((_e2094 * _e2097) - (_e2102 * _e2105));
                                            let _e2111 = local.member[1u][0u];
                                            if (_e2111 < 0f) {
                                                phi_3179_ = -(_e2111);
                                            } else {
                                                phi_3179_ = _e2111;
                                            }
                                            let _e2115 = phi_3179_;
                                            let _e2118 = local.member_3[0u];
                                            let _e2123 = local.member[0u][0u];
                                            if (_e2123 < 0f) {
                                                phi_3202_ = -(_e2123);
                                            } else {
                                                phi_3202_ = _e2123;
                                            }
                                            let _e2127 = phi_3202_;
                                            let _e2130 = local.member_3[1u];
                                            let _e2136 = local.member[2u][2u];
                                            if (_e2136 < 0f) {
                                                phi_3226_ = -(_e2136);
                                            } else {
                                                phi_3226_ = _e2136;
                                            }
                                            let _e2140 = phi_3226_;
                                            let _e2143 = local.member_4[1u];
                                            let _e2148 = local.member[2u][1u];
                                            if (_e2148 < 0f) {
                                                phi_3249_ = -(_e2148);
                                            } else {
                                                phi_3249_ = _e2148;
                                            }
                                            let _e2152 = phi_3249_;
                                            let _e2155 = local.member_4[2u];
                                            if (_e2107 < 0f) {
                                                phi_3265_ = -(_e2107);
                                            } else {
                                                phi_3265_ = _e2107;
                                            }
                                            let _e2161 = phi_3265_;
                                            let _e2163 = (_e2161 - (((_e2115 * _e2118) + (_e2127 * _e2130)) + ((_e2140 * _e2143) + (_e2152 * _e2155))));
                                            let _e2167 = local.member[0u][1u];
                                            let _e2170 = local.member_1[1u];
                                            let _e2175 = local.member[1u][1u];
                                            let _e2178 = local.member_1[0u];
                                            let _e2180 = ((_e2167 * _e2170) - (_e2175 * _e2178));
                                            let _e2184 = local.member[1u][1u];
                                            if (_e2184 < 0f) {
                                                phi_3320_ = -(_e2184);
                                            } else {
                                                phi_3320_ = _e2184;
                                            }
                                            let _e2188 = phi_3320_;
                                            let _e2191 = local.member_3[0u];
                                            let _e2196 = local.member[0u][1u];
                                            if (_e2196 < 0f) {
                                                phi_3343_ = -(_e2196);
                                            } else {
                                                phi_3343_ = _e2196;
                                            }
                                            let _e2200 = phi_3343_;
                                            let _e2203 = local.member_3[1u];
                                            let _e2209 = local.member[2u][0u];
                                            if (_e2209 < 0f) {
                                                phi_3367_ = -(_e2209);
                                            } else {
                                                phi_3367_ = _e2209;
                                            }
                                            let _e2213 = phi_3367_;
                                            let _e2216 = local.member_4[2u];
                                            let _e2221 = local.member[2u][2u];
                                            if (_e2221 < 0f) {
                                                phi_3390_ = -(_e2221);
                                            } else {
                                                phi_3390_ = _e2221;
                                            }
                                            let _e2225 = phi_3390_;
                                            let _e2228 = local.member_4[0u];
                                            if (_e2180 < 0f) {
                                                phi_3406_ = -(_e2180);
                                            } else {
                                                phi_3406_ = _e2180;
                                            }
                                            let _e2234 = phi_3406_;
                                            let _e2236 = (_e2234 - (((_e2188 * _e2191) + (_e2200 * _e2203)) + ((_e2213 * _e2216) + (_e2225 * _e2228))));
                                            let _e2240 = local.member[0u][2u];
                                            let _e2243 = local.member_1[1u];
                                            let _e2248 = local.member[1u][2u];
                                            let _e2251 = local.member_1[0u];
                                            let _e2253 = ((_e2240 * _e2243) - (_e2248 * _e2251));
                                            let _e2257 = local.member[1u][2u];
                                            if (_e2257 < 0f) {
                                                phi_3461_ = -(_e2257);
                                            } else {
                                                phi_3461_ = _e2257;
                                            }
                                            let _e2261 = phi_3461_;
                                            let _e2264 = local.member_3[0u];
                                            let _e2269 = local.member[0u][2u];
                                            if (_e2269 < 0f) {
                                                phi_3484_ = -(_e2269);
                                            } else {
                                                phi_3484_ = _e2269;
                                            }
                                            let _e2273 = phi_3484_;
                                            let _e2276 = local.member_3[1u];
                                            let _e2282 = local.member[2u][1u];
                                            if (_e2282 < 0f) {
                                                phi_3508_ = -(_e2282);
                                            } else {
                                                phi_3508_ = _e2282;
                                            }
                                            let _e2286 = phi_3508_;
                                            let _e2289 = local.member_4[0u];
                                            let _e2294 = local.member[2u][0u];
                                            if (_e2294 < 0f) {
                                                phi_3531_ = -(_e2294);
                                            } else {
                                                phi_3531_ = _e2294;
                                            }
                                            let _e2298 = phi_3531_;
                                            let _e2301 = local.member_4[1u];
                                            if (_e2253 < 0f) {
                                                phi_3547_ = -(_e2253);
                                            } else {
                                                phi_3547_ = _e2253;
                                            }
                                            let _e2307 = phi_3547_;
                                            let _e2309 = (_e2307 - (((_e2261 * _e2264) + (_e2273 * _e2276)) + ((_e2286 * _e2289) + (_e2298 * _e2301))));
                                            if (_e1725 > _e1798) {
                                                phi_3554_ = _e1725;
                                            } else {
                                                phi_3554_ = _e1798;
                                            }
                                            let _e2312 = phi_3554_;
                                            if (_e2312 > _e1871) {
                                                phi_3559_ = _e2312;
                                            } else {
                                                phi_3559_ = _e1871;
                                            }
                                            let _e2315 = phi_3559_;
                                            if (_e1944 > _e2017) {
                                                phi_3564_ = _e1944;
                                            } else {
                                                phi_3564_ = _e2017;
                                            }
                                            let _e2318 = phi_3564_;
                                            if (_e2318 > _e2090) {
                                                phi_3569_ = _e2318;
                                            } else {
                                                phi_3569_ = _e2090;
                                            }
                                            let _e2321 = phi_3569_;
                                            if (_e2315 > _e2321) {
                                                phi_3574_ = _e2315;
                                            } else {
                                                phi_3574_ = _e2321;
                                            }
                                            let _e2324 = phi_3574_;
                                            if (_e2163 > _e2236) {
                                                phi_3579_ = _e2163;
                                            } else {
                                                phi_3579_ = _e2236;
                                            }
                                            let _e2327 = phi_3579_;
                                            if (_e2327 > _e2309) {
                                                phi_3584_ = _e2327;
                                            } else {
                                                phi_3584_ = _e2309;
                                            }
                                            let _e2330 = phi_3584_;
                                            if (_e2324 > _e2330) {
                                                phi_3589_ = _e2324;
                                            } else {
                                                phi_3589_ = _e2330;
                                            }
                                            let _e2333 = phi_3589_;
                                            let _e2335 = local.member_5;
                                            phi_3593_ = (_e2333 > _e2335);
                                        }
                                        let _e2338 = phi_3593_;
                                        phi_3595_ = !(_e2338);
                                        phi_3596_ = false;
                                    } else {
                                        phi_3595_ = bool();
                                        phi_3596_ = true;
                                    }
                                    let _e2341 = phi_3595_;
                                    let _e2343 = phi_3596_;
                                    phi_3597_ = _e2341;
                                    phi_3598_ = _e2343;
                                }
                                let _e2345 = phi_3597_;
                                let _e2347 = phi_3598_;
                                if _e2347 {
                                    phi_3602_ = true;
                                } else {
                                    phi_3602_ = _e2345;
                                }
                                let _e2349 = phi_3602_;
                                if _e2349 {
                                } else {
                                    local_1[_e908.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1335_ = _e906;
                            break if !(_e912);
                        }
                    }
                    let _e2352 = local_1;
                    let _e2356 = array<u32, 2>(_e2352[0][0], _e2352[0][1]);
                    let _e2360 = array<u32, 2>(_e2352[1][0], _e2352[1][1]);
                    let _e2364 = array<u32, 2>(_e2352[2][0], _e2352[2][1]);
                    let _e2368 = array<u32, 2>(_e2352[3][0], _e2352[3][1]);
                    let _e2372 = params.member.member_2.member_4;
                    if (_e2372 > 0u) {
                        phi_3639_ = _e836.member;
                    } else {
                        phi_3639_ = array<array<u32, 2>, 4>(_e2356, _e2360, _e2364, _e2368);
                    }
                    let _e2376 = phi_3639_;
                    if (_e2352[0][0] == 4294967295u) {
                        phi_3663_ = 0u;
                    } else {
                        if (_e2352[0][0] >= _e333) {
                            if (_e2352[0][1] >= _e338) {
                                phi_3657_ = false;
                            } else {
                                phi_3657_ = true;
                            }
                            let _e2382 = phi_3657_;
                            phi_3658_ = _e2382;
                        } else {
                            phi_3658_ = true;
                        }
                        let _e2384 = phi_3658_;
                        if _e2384 {
                            phi_3662_ = 1u;
                        } else {
                            phi_3662_ = 2u;
                        }
                        let _e2386 = phi_3662_;
                        phi_3663_ = _e2386;
                    }
                    let _e2388 = phi_3663_;
                    let _e2389 = type_33(_e2356, _e2388);
                    if (_e2388 == 0u) {
                        if (_e2376[0][0] != 4294967295u) {
                            phi_3675_ = type_33(_e2376[0], 3u);
                        } else {
                            phi_3675_ = _e2389;
                        }
                        let _e2395 = phi_3675_;
                        phi_3676_ = _e2395;
                    } else {
                        phi_3676_ = _e2389;
                    }
                    let _e2397 = phi_3676_;
                    if (_e2352[1][0] == 4294967295u) {
                        phi_3700_ = 0u;
                    } else {
                        if (_e2352[1][0] >= _e333) {
                            if (_e2352[1][1] >= _e338) {
                                phi_3694_ = false;
                            } else {
                                phi_3694_ = true;
                            }
                            let _e2403 = phi_3694_;
                            phi_3695_ = _e2403;
                        } else {
                            phi_3695_ = true;
                        }
                        let _e2405 = phi_3695_;
                        if _e2405 {
                            phi_3699_ = 1u;
                        } else {
                            phi_3699_ = 2u;
                        }
                        let _e2407 = phi_3699_;
                        phi_3700_ = _e2407;
                    }
                    let _e2409 = phi_3700_;
                    let _e2410 = type_33(_e2360, _e2409);
                    if (_e2409 == 0u) {
                        if (_e2376[1][0] != 4294967295u) {
                            phi_3712_ = type_33(_e2376[1], 3u);
                        } else {
                            phi_3712_ = _e2410;
                        }
                        let _e2416 = phi_3712_;
                        phi_3713_ = _e2416;
                    } else {
                        phi_3713_ = _e2410;
                    }
                    let _e2418 = phi_3713_;
                    if (_e2352[2][0] == 4294967295u) {
                        phi_3737_ = 0u;
                    } else {
                        if (_e2352[2][0] >= _e333) {
                            if (_e2352[2][1] >= _e338) {
                                phi_3731_ = false;
                            } else {
                                phi_3731_ = true;
                            }
                            let _e2424 = phi_3731_;
                            phi_3732_ = _e2424;
                        } else {
                            phi_3732_ = true;
                        }
                        let _e2426 = phi_3732_;
                        if _e2426 {
                            phi_3736_ = 1u;
                        } else {
                            phi_3736_ = 2u;
                        }
                        let _e2428 = phi_3736_;
                        phi_3737_ = _e2428;
                    }
                    let _e2430 = phi_3737_;
                    let _e2431 = type_33(_e2364, _e2430);
                    if (_e2430 == 0u) {
                        if (_e2376[2][0] != 4294967295u) {
                            phi_3749_ = type_33(_e2376[2], 3u);
                        } else {
                            phi_3749_ = _e2431;
                        }
                        let _e2437 = phi_3749_;
                        phi_3750_ = _e2437;
                    } else {
                        phi_3750_ = _e2431;
                    }
                    let _e2439 = phi_3750_;
                    if (_e2352[3][0] == 4294967295u) {
                        phi_3774_ = 0u;
                    } else {
                        if (_e2352[3][0] >= _e333) {
                            if (_e2352[3][1] >= _e338) {
                                phi_3768_ = false;
                            } else {
                                phi_3768_ = true;
                            }
                            let _e2445 = phi_3768_;
                            phi_3769_ = _e2445;
                        } else {
                            phi_3769_ = true;
                        }
                        let _e2447 = phi_3769_;
                        if _e2447 {
                            phi_3773_ = 1u;
                        } else {
                            phi_3773_ = 2u;
                        }
                        let _e2449 = phi_3773_;
                        phi_3774_ = _e2449;
                    }
                    let _e2451 = phi_3774_;
                    let _e2452 = type_33(_e2368, _e2451);
                    if (_e2451 == 0u) {
                        if (_e2376[3][0] != 4294967295u) {
                            phi_3786_ = type_33(_e2376[3], 3u);
                        } else {
                            phi_3786_ = _e2452;
                        }
                        let _e2458 = phi_3786_;
                        phi_3787_ = _e2458;
                    } else {
                        phi_3787_ = _e2452;
                    }
                    let _e2460 = phi_3787_;
                    if (_e316[0] == 4294967295u) {
                        phi_3809_ = 0u;
                    } else {
                        if (_e316[0] >= _e333) {
                            if (_e316[1] >= _e338) {
                                phi_3803_ = false;
                            } else {
                                phi_3803_ = true;
                            }
                            let _e2468 = phi_3803_;
                            phi_3804_ = _e2468;
                        } else {
                            phi_3804_ = true;
                        }
                        let _e2470 = phi_3804_;
                        if _e2470 {
                            phi_3808_ = 1u;
                        } else {
                            phi_3808_ = 2u;
                        }
                        let _e2472 = phi_3808_;
                        phi_3809_ = _e2472;
                    }
                    let _e2474 = phi_3809_;
                    if (_e2474 == 2u) {
                        phi_3815_ = type_33(_e316, 2u);
                    } else {
                        phi_3815_ = _e2397;
                    }
                    let _e2478 = phi_3815_;
                    phi_3816_ = _e2478;
                    phi_3817_ = _e2460;
                    phi_3818_ = _e2439;
                    phi_3819_ = _e2418;
                } else {
                    phi_3816_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3817_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3818_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3819_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2480 = phi_3816_;
                let _e2482 = phi_3817_;
                let _e2484 = phi_3818_;
                let _e2486 = phi_3819_;
                if (_e94.member_11 == 1u) {
                    if (_e94.member_4 > 0u) {
                        phi_3878_ = (((select(0u, 1u, (_e2480.member_1 >= 2u)) + select(0u, 1u, (_e2486.member_1 >= 2u))) + select(0u, 1u, (_e2484.member_1 >= 2u))) + select(0u, 1u, (_e2482.member_1 >= 2u)));
                    } else {
                        phi_3878_ = 0u;
                    }
                    let _e2671 = phi_3878_;
                    let _e2674 = ((((select(0u, 1u, (_e2480.member_1 == 1u)) + select(0u, 1u, (_e2486.member_1 == 1u))) + select(0u, 1u, (_e2484.member_1 == 1u))) + select(0u, 1u, (_e2482.member_1 == 1u))) | ((((select(0u, 1u, (_e2480.member_1 == 2u)) + select(0u, 1u, (_e2486.member_1 == 2u))) + select(0u, 1u, (_e2484.member_1 == 2u))) + select(0u, 1u, (_e2482.member_1 == 2u))) << bitcast<u32>(16i)));
                    sums[_e79] = _e2674;
                    phi_3885_ = type_9(0u, 7u);
                    phi_3888_ = 0u;
                    phi_3890_ = 1u;
                    phi_3892_ = _e2674;
                    phi_3889_ = 128u;
                    loop {
                        let _e2677 = phi_3885_;
                        let _e2679 = phi_3888_;
                        let _e2681 = phi_3890_;
                        let _e2683 = phi_3892_;
                        let _e2685 = phi_3889_;
                        local_2 = _e2683;
                        if (_e2677.member < _e2677.member_1) {
                            phi_3886_ = type_9((_e2677.member + 1u), _e2677.member_1);
                            phi_3915_ = type_9(1u, _e2677.member);
                        } else {
                            phi_3886_ = _e2677;
                            phi_3915_ = type_9(0u, type_9().member_1);
                        }
                        let _e2697 = phi_3886_;
                        let _e2699 = phi_3915_;
                        let _e2702 = (bitcast<i32>(_e2699.member) != 0i);
                        if _e2702 {
                            workgroupBarrier();
                            if (_e79 >= _e2681) {
                                let _e2707 = sums[((_e2679 + _e79) - _e2681)];
                                phi_3931_ = (_e2683 + _e2707);
                            } else {
                                phi_3931_ = _e2683;
                            }
                            let _e2710 = phi_3931_;
                            sums[(_e2685 + _e79)] = _e2710;
                            phi_3891_ = (_e2681 * 2u);
                            phi_3893_ = _e2710;
                        } else {
                            phi_3891_ = u32();
                            phi_3893_ = u32();
                        }
                        let _e2715 = phi_3891_;
                        let _e2717 = phi_3893_;
                        continue;
                        continuing {
                            phi_3885_ = _e2697;
                            phi_3888_ = _e2685;
                            phi_3890_ = _e2715;
                            phi_3892_ = _e2717;
                            phi_3889_ = _e2679;
                            break if !(_e2702);
                        }
                    }
                    workgroupBarrier();
                    let _e2720 = local_2;
                    let _e2721 = (_e2720 - _e2674);
                    if (_e79 == 0u) {
                        let _e2724 = sums[255u];
                        atomicStore((&shared_[6u]), (_e2724 & 65535u));
                        atomicStore((&shared_[7u]), (_e2724 >> bitcast<u32>(16i)));
                    }
                    if (_e94.member_4 > 0u) {
                        sums[_e79] = _e2671;
                        phi_3958_ = type_9(0u, 7u);
                        phi_3961_ = 0u;
                        phi_3963_ = 1u;
                        phi_3965_ = _e2671;
                        phi_3962_ = 128u;
                        loop {
                            let _e2734 = phi_3958_;
                            let _e2736 = phi_3961_;
                            let _e2738 = phi_3963_;
                            let _e2740 = phi_3965_;
                            let _e2742 = phi_3962_;
                            local_3 = _e2740;
                            if (_e2734.member < _e2734.member_1) {
                                phi_3959_ = type_9((_e2734.member + 1u), _e2734.member_1);
                                phi_3988_ = type_9(1u, _e2734.member);
                            } else {
                                phi_3959_ = _e2734;
                                phi_3988_ = type_9(0u, type_9().member_1);
                            }
                            let _e2754 = phi_3959_;
                            let _e2756 = phi_3988_;
                            let _e2759 = (bitcast<i32>(_e2756.member) != 0i);
                            if _e2759 {
                                workgroupBarrier();
                                if (_e79 >= _e2738) {
                                    let _e2764 = sums[((_e2736 + _e79) - _e2738)];
                                    phi_4004_ = (_e2740 + _e2764);
                                } else {
                                    phi_4004_ = _e2740;
                                }
                                let _e2767 = phi_4004_;
                                sums[(_e2742 + _e79)] = _e2767;
                                phi_3964_ = (_e2738 * 2u);
                                phi_3966_ = _e2767;
                            } else {
                                phi_3964_ = u32();
                                phi_3966_ = u32();
                            }
                            let _e2772 = phi_3964_;
                            let _e2774 = phi_3966_;
                            continue;
                            continuing {
                                phi_3958_ = _e2754;
                                phi_3961_ = _e2742;
                                phi_3963_ = _e2772;
                                phi_3965_ = _e2774;
                                phi_3962_ = _e2736;
                                break if !(_e2759);
                            }
                        }
                        workgroupBarrier();
                        let _e2777 = local_3;
                        if (_e79 == 0u) {
                            let _e2781 = sums[255u];
                            atomicStore((&shared_[8u]), _e2781);
                        }
                        phi_4018_ = (_e2777 - _e2671);
                    } else {
                        phi_4018_ = 0u;
                    }
                    let _e2784 = phi_4018_;
                    let _e2785 = (_e2721 & 65535u);
                    let _e2787 = (_e2721 >> bitcast<u32>(16i));
                    if (_e2480.member_1 == 1u) {
                        phi_4026_ = _e2785;
                    } else {
                        phi_4026_ = _e2787;
                    }
                    let _e2791 = phi_4026_;
                    let _e2796 = (_e2785 + select(0u, 1u, (_e2480.member_1 == 1u)));
                    let _e2800 = (_e2787 + select(0u, 1u, (_e2480.member_1 == 2u)));
                    let _e2804 = (_e2784 + select(0u, 1u, (_e2480.member_1 >= 2u)));
                    if (_e2486.member_1 == 1u) {
                        phi_4045_ = _e2796;
                    } else {
                        phi_4045_ = _e2800;
                    }
                    let _e2808 = phi_4045_;
                    let _e2813 = (_e2796 + select(0u, 1u, (_e2486.member_1 == 1u)));
                    let _e2817 = (_e2800 + select(0u, 1u, (_e2486.member_1 == 2u)));
                    let _e2821 = (_e2804 + select(0u, 1u, (_e2486.member_1 >= 2u)));
                    if (_e2484.member_1 == 1u) {
                        phi_4064_ = _e2813;
                    } else {
                        phi_4064_ = _e2817;
                    }
                    let _e2825 = phi_4064_;
                    if (_e2482.member_1 == 1u) {
                        phi_4083_ = (_e2813 + select(0u, 1u, (_e2484.member_1 == 1u)));
                    } else {
                        phi_4083_ = (_e2817 + select(0u, 1u, (_e2484.member_1 == 2u)));
                    }
                    let _e2842 = phi_4083_;
                    phi_4241_ = type_34(array<u32, 2>(_e2791, _e2784), array<u32, 2>(_e2808, _e2804), array<u32, 2>(_e2825, _e2821), array<u32, 2>(_e2842, (_e2821 + select(0u, 1u, (_e2484.member_1 >= 2u)))));
                } else {
                    let _e2526 = (((select(0u, 1u, (_e2480.member_1 == 1u)) + select(0u, 1u, (_e2486.member_1 == 1u))) + select(0u, 1u, (_e2484.member_1 == 1u))) + select(0u, 1u, (_e2482.member_1 == 1u)));
                    let _e2530 = (((select(0u, 1u, (_e2480.member_1 == 2u)) + select(0u, 1u, (_e2486.member_1 == 2u))) + select(0u, 1u, (_e2484.member_1 == 2u))) + select(0u, 1u, (_e2482.member_1 == 2u)));
                    if (_e94.member_4 > 0u) {
                        phi_4139_ = (((select(0u, 1u, (_e2480.member_1 >= 2u)) + select(0u, 1u, (_e2486.member_1 >= 2u))) + select(0u, 1u, (_e2484.member_1 >= 2u))) + select(0u, 1u, (_e2482.member_1 >= 2u)));
                    } else {
                        phi_4139_ = 0u;
                    }
                    let _e2537 = phi_4139_;
                    if (_e2526 > 0u) {
                        let _e2540 = atomicAdd((&shared_[6u]), _e2526);
                        phi_4149_ = array<u32, 3>(_e2540, 0u, 0u);
                    } else {
                        phi_4149_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e2543 = phi_4149_;
                    if (_e2530 > 0u) {
                        let _e2546 = atomicAdd((&shared_[7u]), _e2530);
                        phi_4158_ = array<u32, 3>(_e2543[0], _e2546, _e2543[2]);
                    } else {
                        phi_4158_ = _e2543;
                    }
                    let _e2551 = phi_4158_;
                    if (_e2537 > 0u) {
                        let _e2554 = atomicAdd((&shared_[8u]), _e2537);
                        phi_4167_ = array<u32, 3>(_e2551[0], _e2551[1], _e2554);
                    } else {
                        phi_4167_ = _e2551;
                    }
                    let _e2559 = phi_4167_;
                    if (_e2480.member_1 == 1u) {
                        phi_4175_ = _e2559[0];
                    } else {
                        phi_4175_ = _e2559[1];
                    }
                    let _e2565 = phi_4175_;
                    let _e2572 = (_e2559[0] + select(0u, 1u, (_e2480.member_1 == 1u)));
                    let _e2577 = (_e2559[1] + select(0u, 1u, (_e2480.member_1 == 2u)));
                    let _e2582 = (_e2559[2] + select(0u, 1u, (_e2480.member_1 >= 2u)));
                    if (_e2486.member_1 == 1u) {
                        phi_4200_ = _e2572;
                    } else {
                        phi_4200_ = _e2577;
                    }
                    let _e2586 = phi_4200_;
                    let _e2591 = (_e2572 + select(0u, 1u, (_e2486.member_1 == 1u)));
                    let _e2595 = (_e2577 + select(0u, 1u, (_e2486.member_1 == 2u)));
                    let _e2599 = (_e2582 + select(0u, 1u, (_e2486.member_1 >= 2u)));
                    if (_e2484.member_1 == 1u) {
                        phi_4219_ = _e2591;
                    } else {
                        phi_4219_ = _e2595;
                    }
                    let _e2603 = phi_4219_;
                    if (_e2482.member_1 == 1u) {
                        phi_4238_ = (_e2591 + select(0u, 1u, (_e2484.member_1 == 1u)));
                    } else {
                        phi_4238_ = (_e2595 + select(0u, 1u, (_e2484.member_1 == 2u)));
                    }
                    let _e2620 = phi_4238_;
                    phi_4241_ = type_34(array<u32, 2>(_e2565, _e2559[2]), array<u32, 2>(_e2586, _e2582), array<u32, 2>(_e2603, _e2599), array<u32, 2>(_e2620, (_e2599 + select(0u, 1u, (_e2484.member_1 >= 2u)))));
                }
                let _e2846 = phi_4241_;
                workgroupBarrier();
                if (_e79 == 0u) {
                    let _e2849 = atomicLoad((&shared_[6u]));
                    let _e2851 = atomicLoad((&shared_[7u]));
                    let _e2853 = atomicLoad((&shared_[8u]));
                    let _e2855 = atomicLoad((&shared_[1u]));
                    let _e2857 = atomicLoad((&shared_[2u]));
                    let _e2859 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2859 + 1u));
                    let _e2863 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2863 + _e2855) + _e2857));
                    let _e2868 = atomicLoad((&shared_[0u]));
                    let _e2869 = (_e2868 - _e2855);
                    let _e2871 = (_e94.member_10 - _e2869);
                    if (_e2871 < _e2849) {
                        phi_4285_ = _e2871;
                    } else {
                        phi_4285_ = _e2849;
                    }
                    let _e2874 = phi_4285_;
                    atomicStore((&shared_[9u]), _e2869);
                    atomicStore((&shared_[10u]), _e2874);
                    atomicStore((&shared_[0u]), (_e2869 + _e2874));
                    if (_e2849 > _e2874) {
                        let _e2880 = (_e2849 - _e2874);
                        if (_e94.member_13 == 0u) {
                        } else {
                            let _e2884 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2887 = atomicAdd((&control.member[(_e96.member_1 + 1u)]), _e2880);
                        let _e2890 = atomicMax((&nodes.member[0u]), (_e2887 + _e2880));
                        if ((_e2887 + _e2880) < _e2887) {
                            let _e2894 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2887);
                    }
                    if (_e2851 > 0u) {
                        let _e2898 = atomicAdd((&pairs.member[0u]), _e2851);
                        if ((_e2898 + _e2851) < _e2898) {
                            let _e2902 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2898);
                    }
                    if (_e2853 > 0u) {
                        let _e2906 = atomicAdd((&control.member[1537u]), _e2853);
                        if ((_e2906 + _e2853) < _e2906) {
                            let _e2910 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2906);
                    }
                }
                workgroupBarrier();
                if (_e2480.member_1 == 1u) {
                    let _e2974 = atomicLoad((&shared_[10u]));
                    if (_e2846.member[0] < _e2974) {
                        let _e2994 = atomicLoad((&shared_[9u]));
                        let _e2997 = (2u * (_e2994 + _e2846.member[0]));
                        stack[_e2997] = _e2480.member[0];
                        stack[(_e2997 + 1u)] = _e2480.member[1];
                    } else {
                        let _e2978 = atomicLoad((&shared_[11u]));
                        let _e2981 = ((_e2978 + _e2846.member[0]) - _e2974);
                        if (_e2981 < _e94.member_3) {
                            let _e2984 = (_e107 + _e2981);
                            if (_e2984 < 4294967295u) {
                                let _e2988 = (2u * _e2984);
                                atomicStore((&nodes.member[(4u + _e2988)]), _e2480.member[0]);
                                atomicStore((&nodes.member[(_e2988 + 5u)]), _e2480.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2480.member_1 == 0u) {
                    } else {
                        if (_e2480.member_1 == 2u) {
                            let _e2922 = a.member[_e2480.member[0]];
                            let _e2926 = b.member[_e2480.member[1]];
                            let _e2930 = params.member.member_2.member;
                            if (_e2930 == 1u) {
                                if (_e2922.member_1 < _e2926.member_1) {
                                    phi_4471_ = type_9(_e2922.member_1, _e2926.member_1);
                                } else {
                                    phi_4471_ = type_9(_e2926.member_1, _e2922.member_1);
                                }
                                let _e2937 = phi_4471_;
                                phi_4476_ = _e2937;
                            } else {
                                phi_4476_ = type_9(_e2922.member_1, _e2926.member_1);
                            }
                            let _e2939 = phi_4476_;
                            let _e2943 = params.member.member_1;
                            let _e2946 = atomicLoad((&shared_[12u]));
                            let _e2948 = (_e2946 + _e2846.member[0]);
                            if (_e2948 < _e2943.member_3) {
                                let _e2950 = (2u * _e2948);
                                atomicStore((&pairs.member[(4u + _e2950)]), _e2939.member);
                                atomicStore((&pairs.member[(_e2950 + 5u)]), _e2939.member_1);
                            }
                        }
                        if (_e94.member_4 > 0u) {
                            let _e2958 = atomicLoad((&shared_[13u]));
                            let _e2960 = (_e2958 + _e2846.member[1]);
                            if (_e2960 < _e94.member_4) {
                                let _e2967 = (2u * ((_e94.member_5 * _e94.member_4) + _e2960));
                                front.member[_e2967] = _e2480.member[0];
                                front.member[(_e2967 + 1u)] = _e2480.member[1];
                            }
                        }
                    }
                }
                if (_e2486.member_1 == 1u) {
                    let _e3065 = atomicLoad((&shared_[10u]));
                    if (_e2846.member_1[0] < _e3065) {
                        let _e3085 = atomicLoad((&shared_[9u]));
                        let _e3088 = (2u * (_e3085 + _e2846.member_1[0]));
                        stack[_e3088] = _e2486.member[0];
                        stack[(_e3088 + 1u)] = _e2486.member[1];
                    } else {
                        let _e3069 = atomicLoad((&shared_[11u]));
                        let _e3072 = ((_e3069 + _e2846.member_1[0]) - _e3065);
                        if (_e3072 < _e94.member_3) {
                            let _e3075 = (_e107 + _e3072);
                            if (_e3075 < 4294967295u) {
                                let _e3079 = (2u * _e3075);
                                atomicStore((&nodes.member[(4u + _e3079)]), _e2486.member[0]);
                                atomicStore((&nodes.member[(_e3079 + 5u)]), _e2486.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2486.member_1 == 0u) {
                    } else {
                        if (_e2486.member_1 == 2u) {
                            let _e3013 = a.member[_e2486.member[0]];
                            let _e3017 = b.member[_e2486.member[1]];
                            let _e3021 = params.member.member_2.member;
                            if (_e3021 == 1u) {
                                if (_e3013.member_1 < _e3017.member_1) {
                                    phi_4635_ = type_9(_e3013.member_1, _e3017.member_1);
                                } else {
                                    phi_4635_ = type_9(_e3017.member_1, _e3013.member_1);
                                }
                                let _e3028 = phi_4635_;
                                phi_4640_ = _e3028;
                            } else {
                                phi_4640_ = type_9(_e3013.member_1, _e3017.member_1);
                            }
                            let _e3030 = phi_4640_;
                            let _e3034 = params.member.member_1;
                            let _e3037 = atomicLoad((&shared_[12u]));
                            let _e3039 = (_e3037 + _e2846.member_1[0]);
                            if (_e3039 < _e3034.member_3) {
                                let _e3041 = (2u * _e3039);
                                atomicStore((&pairs.member[(4u + _e3041)]), _e3030.member);
                                atomicStore((&pairs.member[(_e3041 + 5u)]), _e3030.member_1);
                            }
                        }
                        if (_e94.member_4 > 0u) {
                            let _e3049 = atomicLoad((&shared_[13u]));
                            let _e3051 = (_e3049 + _e2846.member_1[1]);
                            if (_e3051 < _e94.member_4) {
                                let _e3058 = (2u * ((_e94.member_5 * _e94.member_4) + _e3051));
                                front.member[_e3058] = _e2486.member[0];
                                front.member[(_e3058 + 1u)] = _e2486.member[1];
                            }
                        }
                    }
                }
                if (_e2484.member_1 == 1u) {
                    let _e3156 = atomicLoad((&shared_[10u]));
                    if (_e2846.member_2[0] < _e3156) {
                        let _e3176 = atomicLoad((&shared_[9u]));
                        let _e3179 = (2u * (_e3176 + _e2846.member_2[0]));
                        stack[_e3179] = _e2484.member[0];
                        stack[(_e3179 + 1u)] = _e2484.member[1];
                    } else {
                        let _e3160 = atomicLoad((&shared_[11u]));
                        let _e3163 = ((_e3160 + _e2846.member_2[0]) - _e3156);
                        if (_e3163 < _e94.member_3) {
                            let _e3166 = (_e107 + _e3163);
                            if (_e3166 < 4294967295u) {
                                let _e3170 = (2u * _e3166);
                                atomicStore((&nodes.member[(4u + _e3170)]), _e2484.member[0]);
                                atomicStore((&nodes.member[(_e3170 + 5u)]), _e2484.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2484.member_1 == 0u) {
                    } else {
                        if (_e2484.member_1 == 2u) {
                            let _e3104 = a.member[_e2484.member[0]];
                            let _e3108 = b.member[_e2484.member[1]];
                            let _e3112 = params.member.member_2.member;
                            if (_e3112 == 1u) {
                                if (_e3104.member_1 < _e3108.member_1) {
                                    phi_4799_ = type_9(_e3104.member_1, _e3108.member_1);
                                } else {
                                    phi_4799_ = type_9(_e3108.member_1, _e3104.member_1);
                                }
                                let _e3119 = phi_4799_;
                                phi_4804_ = _e3119;
                            } else {
                                phi_4804_ = type_9(_e3104.member_1, _e3108.member_1);
                            }
                            let _e3121 = phi_4804_;
                            let _e3125 = params.member.member_1;
                            let _e3128 = atomicLoad((&shared_[12u]));
                            let _e3130 = (_e3128 + _e2846.member_2[0]);
                            if (_e3130 < _e3125.member_3) {
                                let _e3132 = (2u * _e3130);
                                atomicStore((&pairs.member[(4u + _e3132)]), _e3121.member);
                                atomicStore((&pairs.member[(_e3132 + 5u)]), _e3121.member_1);
                            }
                        }
                        if (_e94.member_4 > 0u) {
                            let _e3140 = atomicLoad((&shared_[13u]));
                            let _e3142 = (_e3140 + _e2846.member_2[1]);
                            if (_e3142 < _e94.member_4) {
                                let _e3149 = (2u * ((_e94.member_5 * _e94.member_4) + _e3142));
                                front.member[_e3149] = _e2484.member[0];
                                front.member[(_e3149 + 1u)] = _e2484.member[1];
                            }
                        }
                    }
                }
                if (_e2482.member_1 == 1u) {
                    let _e3247 = atomicLoad((&shared_[10u]));
                    if (_e2846.member_3[0] < _e3247) {
                        let _e3267 = atomicLoad((&shared_[9u]));
                        let _e3270 = (2u * (_e3267 + _e2846.member_3[0]));
                        stack[_e3270] = _e2482.member[0];
                        stack[(_e3270 + 1u)] = _e2482.member[1];
                    } else {
                        let _e3251 = atomicLoad((&shared_[11u]));
                        let _e3254 = ((_e3251 + _e2846.member_3[0]) - _e3247);
                        if (_e3254 < _e94.member_3) {
                            let _e3257 = (_e107 + _e3254);
                            if (_e3257 < 4294967295u) {
                                let _e3261 = (2u * _e3257);
                                atomicStore((&nodes.member[(4u + _e3261)]), _e2482.member[0]);
                                atomicStore((&nodes.member[(_e3261 + 5u)]), _e2482.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2482.member_1 == 0u) {
                    } else {
                        if (_e2482.member_1 == 2u) {
                            let _e3195 = a.member[_e2482.member[0]];
                            let _e3199 = b.member[_e2482.member[1]];
                            let _e3203 = params.member.member_2.member;
                            if (_e3203 == 1u) {
                                if (_e3195.member_1 < _e3199.member_1) {
                                    phi_4963_ = type_9(_e3195.member_1, _e3199.member_1);
                                } else {
                                    phi_4963_ = type_9(_e3199.member_1, _e3195.member_1);
                                }
                                let _e3210 = phi_4963_;
                                phi_4968_ = _e3210;
                            } else {
                                phi_4968_ = type_9(_e3195.member_1, _e3199.member_1);
                            }
                            let _e3212 = phi_4968_;
                            let _e3216 = params.member.member_1;
                            let _e3219 = atomicLoad((&shared_[12u]));
                            let _e3221 = (_e3219 + _e2846.member_3[0]);
                            if (_e3221 < _e3216.member_3) {
                                let _e3223 = (2u * _e3221);
                                atomicStore((&pairs.member[(4u + _e3223)]), _e3212.member);
                                atomicStore((&pairs.member[(_e3223 + 5u)]), _e3212.member_1);
                            }
                        }
                        if (_e94.member_4 > 0u) {
                            let _e3231 = atomicLoad((&shared_[13u]));
                            let _e3233 = (_e3231 + _e2846.member_3[1]);
                            if (_e3233 < _e94.member_4) {
                                let _e3240 = (2u * ((_e94.member_5 * _e94.member_4) + _e3233));
                                front.member[_e3240] = _e2482.member[0];
                                front.member[(_e3240 + 1u)] = _e2482.member[1];
                            }
                        }
                    }
                }
                phi_5021_ = true;
            }
            let _e3277 = phi_5021_;
            phi_5022_ = _e3277;
        } else {
            phi_5022_ = false;
        }
        let _e3279 = phi_5022_;
        continue;
        continuing {
            phi_254_ = _e128;
            break if !(_e3279);
        }
    }
    if (_e79 == 0u) {
        if (_e94.member_6 == 0u) {
            if (_e92 < _e104) {
                phi_5045_ = ((((_e104 - 1u) - _e92) >> bitcast<u32>((_e94.member_7 & 31u))) + 1u);
            } else {
                phi_5045_ = 0u;
            }
            let _e3293 = phi_5045_;
            let _e3295 = atomicLoad((&shared_[5u]));
            phi_5050_ = (_e3293 - _e3295);
        } else {
            phi_5050_ = 0u;
        }
        let _e3298 = phi_5050_;
        atomicStore((&shared_[14u]), _e3298);
        let _e3301 = atomicLoad((&shared_[0u]));
        let _e3302 = (_e3301 + _e3298);
        if (_e94.member_6 == 2u) {
            let _e3329 = (((_e104 + (1u << bitcast<u32>((_e94.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e94.member_7 & 31u)));
            let _e3330 = (_e92 * _e3329);
            if (_e104 < _e3330) {
                phi_5076_ = _e104;
            } else {
                phi_5076_ = _e3330;
            }
            let _e3333 = phi_5076_;
            let _e3334 = (_e104 - _e3333);
            if (_e3334 < _e3329) {
                phi_5082_ = _e3334;
            } else {
                phi_5082_ = _e3329;
            }
            let _e3337 = phi_5082_;
            let _e3344 = ((1540u + (2u * (1u << bitcast<u32>((_e94.member_7 & 31u))))) + (2u * _e92));
            let _e3346 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e3344]), _e3346);
            let _e3350 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e3344 + 1u)]), (_e3337 - _e3350));
        } else {
            if (_e3302 > 0u) {
                if (_e94.member_13 == 0u) {
                } else {
                    let _e3309 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e3312 = atomicAdd((&control.member[(_e96.member_1 + 1u)]), _e3302);
                let _e3315 = atomicMax((&nodes.member[0u]), (_e3312 + _e3302));
                if ((_e3312 + _e3302) < _e3312) {
                    let _e3319 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e3312);
            }
        }
        let _e3356 = atomicLoad((&shared_[15u]));
        let _e3358 = atomicAdd((&control.member[(1540u + (2u * _e92))]), _e3356);
        let _e3362 = atomicLoad((&shared_[16u]));
        let _e3364 = atomicAdd((&control.member[((2u * _e92) + 1541u)]), _e3362);
    }
    workgroupBarrier();
    let _e3366 = atomicLoad((&shared_[0u]));
    let _e3368 = atomicLoad((&shared_[17u]));
    let _e3370 = atomicLoad((&shared_[14u]));
    phi_5170_ = type_9(0u, 8u);
    loop {
        let _e3372 = phi_5170_;
        if (_e3372.member < _e3372.member_1) {
            phi_5171_ = type_9((_e3372.member + 1u), _e3372.member_1);
            phi_5194_ = type_9(1u, _e3372.member);
        } else {
            phi_5171_ = _e3372;
            phi_5194_ = type_9(0u, type_9().member_1);
        }
        let _e3384 = phi_5171_;
        let _e3386 = phi_5194_;
        let _e3390 = (bitcast<i32>(_e3386.member) != 0i);
        if _e3390 {
            let _e3392 = ((_e3386.member_1 * 128u) + _e79);
            if (_e3392 < _e3366) {
                let _e3396 = stack[(2u * _e3392)];
                let _e3400 = stack[((2u * _e3392) + 1u)];
                if (_e94.member_6 == 2u) {
                    let _e3432 = ((((((1540u + (2u * (1u << bitcast<u32>((_e94.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e94.member_7 & 31u))))) + (1u << bitcast<u32>((_e94.member_7 & 31u)))) + 1u) + (_e92 * 2048u)) + (2u * _e3392));
                    atomicStore((&control.member[_e3432]), _e3396);
                    atomicStore((&control.member[(_e3432 + 1u)]), _e3400);
                } else {
                    let _e3403 = (_e3368 + _e3392);
                    if (_e3403 < _e94.member_3) {
                        let _e3406 = (_e107 + _e3403);
                        if (_e3406 < 4294967295u) {
                            let _e3408 = (2u * _e3406);
                            atomicStore((&nodes.member[(4u + _e3408)]), _e3396);
                            atomicStore((&nodes.member[(_e3408 + 5u)]), _e3400);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5170_ = _e3384;
            break if !(_e3390);
        }
    }
    let _e3438 = atomicLoad((&shared_[5u]));
    let _e3439 = (_e3370 / 128u);
    if ((_e3370 % 128u) > 0u) {
        phi_5285_ = (_e3439 + 1u);
    } else {
        phi_5285_ = _e3439;
    }
    let _e3444 = phi_5285_;
    phi_5288_ = type_9(0u, _e3444);
    loop {
        let _e3447 = phi_5288_;
        if (_e3447.member < _e3447.member_1) {
            phi_5289_ = type_9((_e3447.member + 1u), _e3447.member_1);
            phi_5312_ = type_9(1u, _e3447.member);
        } else {
            phi_5289_ = _e3447;
            phi_5312_ = type_9(0u, type_9().member_1);
        }
        let _e3459 = phi_5289_;
        let _e3461 = phi_5312_;
        let _e3465 = (bitcast<i32>(_e3461.member) != 0i);
        if _e3465 {
            let _e3467 = ((_e3461.member_1 * 128u) + _e79);
            if (_e3467 < _e3370) {
                let _e3476 = (2u * ((_e105 + _e92) + ((_e3438 + _e3467) << bitcast<u32>((_e94.member_7 & 31u)))));
                let _e3479 = atomicLoad((&nodes.member[(4u + _e3476)]));
                let _e3482 = atomicLoad((&nodes.member[(_e3476 + 5u)]));
                let _e3484 = ((_e3368 + _e3366) + _e3467);
                if (_e3484 < _e94.member_3) {
                    let _e3487 = (_e107 + _e3484);
                    if (_e3487 < 4294967295u) {
                        let _e3489 = (2u * _e3487);
                        atomicStore((&nodes.member[(4u + _e3489)]), _e3479);
                        atomicStore((&nodes.member[(_e3489 + 5u)]), _e3482);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5288_ = _e3459;
            break if !(_e3465);
        }
    }
    if (_e94.member_6 == 1u) {
        if (_e3438 == 0u) {
            phi_5393_ = type_9(0u, _e104);
            loop {
                let _e3500 = phi_5393_;
                if (_e3500.member < _e3500.member_1) {
                    phi_5394_ = type_9((_e3500.member + 1u), _e3500.member_1);
                    phi_5417_ = type_9(1u, _e3500.member);
                } else {
                    phi_5394_ = _e3500;
                    phi_5417_ = type_9(0u, type_9().member_1);
                }
                let _e3512 = phi_5394_;
                let _e3514 = phi_5417_;
                if (bitcast<i32>(_e3514.member) != 0i) {
                    let _e3520 = atomicAdd((&control.member[(512u + _e96.member_1)]), 1u);
                    if (_e3520 >= _e104) {
                        phi_5509_ = false;
                    } else {
                        let _e3523 = (2u * (_e105 + _e3520));
                        let _e3526 = atomicLoad((&nodes.member[(4u + _e3523)]));
                        let _e3529 = atomicLoad((&nodes.member[(_e3523 + 5u)]));
                        if (_e94.member_13 == 0u) {
                        } else {
                            let _e3533 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3536 = atomicAdd((&control.member[(_e96.member_1 + 1u)]), 1u);
                        let _e3539 = atomicMax((&nodes.member[0u]), (_e3536 + 1u));
                        if ((_e3536 + 1u) < _e3536) {
                            let _e3543 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3536 < _e94.member_3) {
                            let _e3546 = (_e107 + _e3536);
                            if (_e3546 < 4294967295u) {
                                let _e3548 = (2u * _e3546);
                                atomicStore((&nodes.member[(4u + _e3548)]), _e3526);
                                atomicStore((&nodes.member[(_e3548 + 5u)]), _e3529);
                            }
                        }
                        phi_5509_ = true;
                    }
                    let _e3554 = phi_5509_;
                    phi_5510_ = _e3554;
                } else {
                    phi_5510_ = false;
                }
                let _e3556 = phi_5510_;
                continue;
                continuing {
                    phi_5393_ = _e3512;
                    break if !(_e3556);
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
