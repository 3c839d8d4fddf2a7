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
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_439_: u32;
    var phi_452_: u32;
    var phi_458_: u32;
    var phi_467_: u32;
    var phi_396_: u32;
    var phi_402_: u32;
    var phi_408_: u32;
    var phi_468_: u32;
    var phi_359_: u32;
    var phi_365_: u32;
    var phi_469_: u32;
    var phi_470_: u32;
    var phi_471_: u32;
    var phi_491_: u32;
    var phi_492_: u32;
    var phi_575_: array<u32, 2>;
    var phi_576_: array<u32, 2>;
    var phi_593_: array<u32, 2>;
    var phi_622_: u32;
    var phi_696_: array<u32, 2>;
    var phi_710_: array<u32, 2>;
    var phi_747_: array<u32, 2>;
    var phi_749_: type_24;
    var phi_750_: type_24;
    var phi_751_: bool;
    var phi_752_: type_24;
    var phi_753_: bool;
    var phi_769_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_924_: array<u32, 2>;
    var phi_953_: array<u32, 2>;
    var phi_982_: array<u32, 2>;
    var phi_1011_: array<u32, 2>;
    var phi_1013_: type_24;
    var phi_1014_: bool;
    var phi_1015_: type_24;
    var phi_1016_: bool;
    var phi_1189_: array<u32, 2>;
    var phi_1221_: array<u32, 2>;
    var phi_1089_: array<u32, 2>;
    var phi_1121_: array<u32, 2>;
    var phi_1223_: type_24;
    var phi_1224_: type_24;
    var phi_1225_: type_24;
    var phi_1226_: bool;
    var phi_1227_: type_24;
    var phi_1228_: type_24;
    var phi_1229_: bool;
    var phi_1233_: type_24;
    var phi_1251_: array<u32, 2>;
    var phi_1282_: array<u32, 2>;
    var phi_1327_: type_9;
    var phi_1328_: type_9;
    var phi_1351_: type_9;
    var phi_1380_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1466_: f32;
    var phi_1472_: f32;
    var phi_1478_: f32;
    var phi_1484_: f32;
    var phi_1490_: f32;
    var phi_1496_: f32;
    var phi_1514_: f32;
    var phi_1519_: f32;
    var phi_1524_: f32;
    var phi_1540_: type_31;
    var phi_1610_: f32;
    var phi_1616_: f32;
    var phi_1622_: f32;
    var phi_1628_: f32;
    var phi_1634_: f32;
    var phi_1640_: f32;
    var phi_1658_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1684_: type_31;
    var phi_1874_: f32;
    var phi_1880_: f32;
    var phi_1887_: f32;
    var phi_1896_: f32;
    var phi_1903_: f32;
    var phi_1911_: f32;
    var phi_1920_: f32;
    var phi_1927_: f32;
    var phi_1935_: f32;
    var phi_2028_: f32;
    var phi_2035_: f32;
    var phi_2041_: f32;
    var phi_2047_: f32;
    var phi_2066_: f32;
    var phi_2073_: f32;
    var phi_2079_: f32;
    var phi_2085_: f32;
    var phi_2104_: f32;
    var phi_2111_: f32;
    var phi_2117_: f32;
    var phi_2123_: f32;
    var phi_2142_: f32;
    var phi_2149_: f32;
    var phi_2155_: f32;
    var phi_2161_: f32;
    var phi_2180_: f32;
    var phi_2187_: f32;
    var phi_2193_: f32;
    var phi_2199_: f32;
    var phi_2218_: f32;
    var phi_2225_: f32;
    var phi_2231_: f32;
    var phi_2237_: f32;
    var phi_2252_: f32;
    var phi_2257_: f32;
    var phi_2262_: f32;
    var phi_2267_: f32;
    var phi_2272_: f32;
    var phi_2331_: f32;
    var phi_2354_: f32;
    var phi_2377_: f32;
    var phi_2399_: f32;
    var phi_2415_: f32;
    var phi_2470_: f32;
    var phi_2493_: f32;
    var phi_2516_: f32;
    var phi_2538_: f32;
    var phi_2554_: f32;
    var phi_2609_: f32;
    var phi_2632_: f32;
    var phi_2655_: f32;
    var phi_2677_: f32;
    var phi_2693_: f32;
    var phi_2748_: f32;
    var phi_2771_: f32;
    var phi_2795_: f32;
    var phi_2818_: f32;
    var phi_2834_: f32;
    var phi_2889_: f32;
    var phi_2912_: f32;
    var phi_2936_: f32;
    var phi_2959_: f32;
    var phi_2975_: f32;
    var phi_3030_: f32;
    var phi_3053_: f32;
    var phi_3077_: f32;
    var phi_3100_: f32;
    var phi_3116_: f32;
    var phi_3171_: f32;
    var phi_3194_: f32;
    var phi_3218_: f32;
    var phi_3241_: f32;
    var phi_3257_: f32;
    var phi_3312_: f32;
    var phi_3335_: f32;
    var phi_3359_: f32;
    var phi_3382_: f32;
    var phi_3398_: f32;
    var phi_3453_: f32;
    var phi_3476_: f32;
    var phi_3500_: f32;
    var phi_3523_: f32;
    var phi_3539_: f32;
    var phi_3546_: f32;
    var phi_3551_: f32;
    var phi_3556_: f32;
    var phi_3561_: f32;
    var phi_3566_: f32;
    var phi_3571_: f32;
    var phi_3576_: f32;
    var phi_3581_: f32;
    var phi_3585_: bool;
    var phi_3587_: bool;
    var phi_3588_: bool;
    var phi_3589_: bool;
    var phi_3590_: bool;
    var phi_3594_: bool;
    var phi_3631_: array<array<u32, 2>, 4>;
    var phi_3649_: bool;
    var phi_3650_: bool;
    var phi_3654_: u32;
    var phi_3655_: u32;
    var phi_3667_: type_32;
    var phi_3668_: type_32;
    var phi_3686_: bool;
    var phi_3687_: bool;
    var phi_3691_: u32;
    var phi_3692_: u32;
    var phi_3704_: type_32;
    var phi_3705_: type_32;
    var phi_3723_: bool;
    var phi_3724_: bool;
    var phi_3728_: u32;
    var phi_3729_: u32;
    var phi_3741_: type_32;
    var phi_3742_: type_32;
    var phi_3760_: bool;
    var phi_3761_: bool;
    var phi_3765_: u32;
    var phi_3766_: u32;
    var phi_3778_: type_32;
    var phi_3779_: type_32;
    var phi_3795_: bool;
    var phi_3796_: bool;
    var phi_3800_: u32;
    var phi_3801_: u32;
    var phi_3807_: type_32;
    var phi_3808_: type_32;
    var phi_3809_: type_32;
    var phi_3810_: type_32;
    var phi_3811_: type_32;
    var phi_3831_: array<u32, 2>;
    var phi_3832_: array<u32, 2>;
    var phi_3844_: array<u32, 2>;
    var phi_3845_: array<u32, 2>;
    var phi_3862_: array<u32, 2>;
    var phi_3863_: array<u32, 2>;
    var phi_3875_: array<u32, 2>;
    var phi_3876_: array<u32, 2>;
    var phi_3893_: array<u32, 2>;
    var phi_3894_: array<u32, 2>;
    var phi_3906_: array<u32, 2>;
    var phi_3907_: array<u32, 2>;
    var phi_3924_: array<u32, 2>;
    var phi_3925_: array<u32, 2>;
    var phi_3937_: array<u32, 2>;
    var phi_3938_: array<u32, 2>;
    var phi_3982_: u32;
    var phi_4167_: type_9;
    var phi_4172_: type_9;
    var phi_4330_: type_9;
    var phi_4335_: type_9;
    var phi_4493_: type_9;
    var phi_4498_: type_9;
    var phi_4656_: type_9;
    var phi_4661_: type_9;
    var phi_4714_: bool;
    var phi_4715_: bool;
    var phi_4738_: u32;
    var phi_4743_: u32;
    var phi_4769_: u32;
    var phi_4775_: u32;
    var phi_4863_: type_9;
    var phi_4864_: type_9;
    var phi_4887_: type_9;
    var phi_4978_: u32;
    var phi_4981_: type_9;
    var phi_4982_: type_9;
    var phi_5005_: type_9;
    var phi_5086_: type_9;
    var phi_5087_: type_9;
    var phi_5110_: type_9;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e71 = id_2;
    let _e72 = n_2;
    let _e73 = lane_2;
    let _e86 = ((_e71.y * _e72.x) + _e71.x);
    let _e88 = params.member.member_2;
    let _e90 = params.member.member_1;
    let _e93 = (_e90.member_1 % 2u);
    let _e95 = atomicLoad((&control.member[_e90.member_1]));
    if (_e88.member_3 < _e95) {
        phi_208_ = _e88.member_3;
    } else {
        phi_208_ = _e95;
    }
    let _e98 = phi_208_;
    let _e99 = (_e93 * _e88.member_3);
    let _e101 = ((1u - _e93) * _e88.member_3);
    if (_e73 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_246_ = type_9(0u, _e88.member_11);
    loop {
        let _e110 = phi_246_;
        if (_e110.member < _e110.member_1) {
            phi_247_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_270_ = type_9(1u, _e110.member);
        } else {
            phi_247_ = _e110;
            phi_270_ = type_9(0u, type_9().member_1);
        }
        let _e122 = phi_247_;
        let _e124 = phi_270_;
        if (bitcast<i32>(_e124.member) != 0i) {
            if (_e73 == 0u) {
                let _e135 = atomicLoad((&shared_[0u]));
                if (128u < _e135) {
                    phi_294_ = 128u;
                } else {
                    phi_294_ = _e135;
                }
                let _e138 = phi_294_;
                if (_e88.member_9 > 0u) {
                    if (_e124.member_1 >= 16u) {
                        let _e143 = atomicLoad((&control.member[(1024u + _e90.member_1)]));
                        if (_e88.member_9 > 0u) {
                            phi_325_ = ((_e143 * 100u) >= (_e88.member_9 << bitcast<u32>((_e88.member_7 & 31u))));
                        } else {
                            phi_325_ = false;
                        }
                        let _e151 = phi_325_;
                        if _e151 {
                            phi_329_ = 2u;
                        } else {
                            phi_329_ = 0u;
                        }
                        let _e153 = phi_329_;
                        phi_330_ = _e153;
                    } else {
                        phi_330_ = 0u;
                    }
                    let _e155 = phi_330_;
                    phi_331_ = _e155;
                } else {
                    phi_331_ = 0u;
                }
                let _e157 = phi_331_;
                let _e158 = (128u - _e138);
                if (_e157 == 0u) {
                    if (_e158 > 0u) {
                        let _e162 = atomicLoad((&shared_[5u]));
                        if (_e88.member_6 == 0u) {
                            if (_e86 < _e98) {
                                phi_359_ = ((((_e98 - 1u) - _e86) >> bitcast<u32>((_e88.member_7 & 31u))) + 1u);
                            } else {
                                phi_359_ = 0u;
                            }
                            let _e231 = phi_359_;
                            let _e232 = (_e231 - _e162);
                            if (_e158 < _e232) {
                                phi_365_ = _e158;
                            } else {
                                phi_365_ = _e232;
                            }
                            let _e235 = phi_365_;
                            atomicStore((&shared_[3u]), (_e86 + (_e162 << bitcast<u32>((_e88.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e88.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e162 + _e235));
                            phi_469_ = _e235;
                        } else {
                            if (_e88.member_6 == 2u) {
                                let _e203 = (((_e98 + (1u << bitcast<u32>((_e88.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e88.member_7 & 31u)));
                                let _e204 = (_e86 * _e203);
                                if (_e98 < _e204) {
                                    phi_396_ = _e98;
                                } else {
                                    phi_396_ = _e204;
                                }
                                let _e207 = phi_396_;
                                let _e208 = (_e98 - _e207);
                                if (_e208 < _e203) {
                                    phi_402_ = _e208;
                                } else {
                                    phi_402_ = _e203;
                                }
                                let _e211 = phi_402_;
                                let _e212 = (_e211 - _e162);
                                if (_e158 < _e212) {
                                    phi_408_ = _e158;
                                } else {
                                    phi_408_ = _e212;
                                }
                                let _e215 = phi_408_;
                                atomicStore((&shared_[3u]), (_e207 + _e162));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e162 + _e215));
                                phi_468_ = _e215;
                            } else {
                                if (_e162 == 0u) {
                                    let _e169 = (_e98 >> bitcast<u32>(((_e88.member_7 + 2u) & 31u)));
                                    if (_e88.member_8 < _e169) {
                                        phi_429_ = _e169;
                                    } else {
                                        phi_429_ = _e88.member_8;
                                    }
                                    let _e172 = phi_429_;
                                    if (128u < _e172) {
                                        phi_434_ = 128u;
                                    } else {
                                        phi_434_ = _e172;
                                    }
                                    let _e175 = phi_434_;
                                    if (_e158 < _e175) {
                                        phi_439_ = _e158;
                                    } else {
                                        phi_439_ = _e175;
                                    }
                                    let _e178 = phi_439_;
                                    let _e181 = atomicAdd((&control.member[(512u + _e90.member_1)]), _e178);
                                    if (_e98 < _e181) {
                                        phi_452_ = _e98;
                                    } else {
                                        phi_452_ = _e181;
                                    }
                                    let _e184 = phi_452_;
                                    let _e185 = (_e98 - _e184);
                                    if (_e178 < _e185) {
                                        phi_458_ = _e178;
                                    } else {
                                        phi_458_ = _e185;
                                    }
                                    let _e188 = phi_458_;
                                    atomicStore((&shared_[3u]), _e181);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e188 < _e178)));
                                    phi_467_ = _e188;
                                } else {
                                    phi_467_ = 0u;
                                }
                                let _e195 = phi_467_;
                                phi_468_ = _e195;
                            }
                            let _e222 = phi_468_;
                            phi_469_ = _e222;
                        }
                        let _e248 = phi_469_;
                        phi_470_ = _e248;
                    } else {
                        phi_470_ = 0u;
                    }
                    let _e250 = phi_470_;
                    phi_471_ = _e250;
                } else {
                    phi_471_ = 0u;
                }
                let _e252 = phi_471_;
                if (_e157 == 0u) {
                    if ((_e138 + _e252) == 0u) {
                        if (_e88.member_9 > 0u) {
                            let _e259 = atomicAdd((&control.member[(1024u + _e90.member_1)]), 1u);
                        }
                        phi_491_ = 1u;
                    } else {
                        phi_491_ = _e157;
                    }
                    let _e261 = phi_491_;
                    phi_492_ = _e261;
                } else {
                    phi_492_ = _e157;
                }
                let _e263 = phi_492_;
                atomicStore((&shared_[1u]), _e138);
                atomicStore((&shared_[2u]), _e252);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e263;
            }
            let _e271 = workgroupUniformLoad((&state[0u]));
            if (_e271 != 0u) {
                phi_4714_ = false;
            } else {
                let _e274 = atomicLoad((&shared_[1u]));
                let _e276 = atomicLoad((&shared_[2u]));
                if (_e73 < _e274) {
                    let _e299 = atomicLoad((&shared_[0u]));
                    let _e302 = (2u * ((_e299 - 1u) - _e73));
                    let _e304 = stack[_e302];
                    let _e307 = stack[(_e302 + 1u)];
                    phi_576_ = array<u32, 2>(_e304, _e307);
                } else {
                    if (_e73 < (_e274 + _e276)) {
                        let _e281 = atomicLoad((&shared_[3u]));
                        let _e284 = atomicLoad((&shared_[4u]));
                        let _e288 = (2u * (_e99 + (_e281 + ((_e73 - _e274) * _e284))));
                        let _e291 = atomicLoad((&nodes.member[(4u + _e288)]));
                        let _e294 = atomicLoad((&nodes.member[(_e288 + 5u)]));
                        phi_575_ = array<u32, 2>(_e291, _e294);
                    } else {
                        phi_575_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e297 = phi_575_;
                    phi_576_ = _e297;
                }
                let _e310 = phi_576_;
                let _e313 = params.member.member_2.member;
                let _e317 = params.member.member_2.member;
                if (_e317 == 0u) {
                    phi_593_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_593_ = array<u32, 2>(1u, 1u);
                }
                let _e320 = phi_593_;
                let _e326 = params.member.member.member[_e320[0]];
                let _e327 = (_e326 - 1u);
                let _e331 = params.member.member.member[_e320[1]];
                let _e332 = (_e331 - 1u);
                let _e335 = params.member.member_2.member_1;
                if (_e335 == 0u) {
                    phi_622_ = 1u;
                } else {
                    phi_622_ = 0u;
                }
                let _e338 = phi_622_;
                if (_e310[0] != 4294967295u) {
                    let _e344 = a.member[_e310[0]];
                    let _e346 = b.member[_e310[1]];
                    if (_e313 == 1u) {
                        if (_e310[0] == _e310[1]) {
                            if (_e344.member_3 == 4294967295u) {
                                phi_749_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e352 = a.member[_e344.member_1];
                                let _e355 = a.member[_e344.member_3];
                                if !((_e352.member_3 == 4294967295u)) {
                                    phi_696_ = array<u32, 2>(_e344.member_1, _e344.member_1);
                                } else {
                                    phi_696_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e362 = phi_696_;
                                let _e369 = type_24(array<array<u32, 2>, 4>(_e362, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e381 = type_24(array<array<u32, 2>, 4>(_e369.member[0], array<u32, 2>(_e344.member_1, _e369.member[1][1]), _e369.member[2], _e369.member[3]), _e369.member_1);
                                let _e382 = array<u32, 2>(_e344.member_1, _e344.member_3);
                                let _e389 = type_24(array<array<u32, 2>, 4>(_e381.member[0], _e382, _e381.member[2], _e381.member[3]), _e381.member_1);
                                if !((_e355.member_3 == 4294967295u)) {
                                    phi_710_ = array<u32, 2>(_e344.member_3, _e344.member_3);
                                } else {
                                    phi_710_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e396 = phi_710_;
                                let _e403 = type_24(array<array<u32, 2>, 4>(_e389.member[0], _e389.member[1], _e396, _e389.member[3]), _e389.member_1);
                                let _e406 = type_24(_e403.member, _e403.member);
                                if ((((((_e352.member[0] <= _e355.member_2[0]) && (_e355.member[0] <= _e352.member_2[0])) && (_e352.member[1] <= _e355.member_2[1])) && (_e355.member[1] <= _e352.member_2[1])) && (_e352.member[2] <= _e355.member_2[2])) && (_e355.member[2] <= _e352.member_2[2])) {
                                    phi_747_ = _e382;
                                } else {
                                    phi_747_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e435 = phi_747_;
                                phi_749_ = type_24(_e406.member, array<array<u32, 2>, 4>(_e406.member_1[0], _e435, _e406.member_1[2], _e406.member_1[3]));
                            }
                            let _e444 = phi_749_;
                            phi_750_ = _e444;
                            phi_751_ = false;
                        } else {
                            phi_750_ = type_24();
                            phi_751_ = true;
                        }
                        let _e446 = phi_750_;
                        let _e448 = phi_751_;
                        phi_752_ = _e446;
                        phi_753_ = _e448;
                    } else {
                        phi_752_ = type_24();
                        phi_753_ = true;
                    }
                    let _e450 = phi_752_;
                    let _e452 = phi_753_;
                    if _e452 {
                        let _e455 = !((_e344.member_3 == 4294967295u));
                        let _e458 = !((_e346.member_3 == 4294967295u));
                        if _e455 {
                            phi_769_ = true;
                        } else {
                            phi_769_ = _e458;
                        }
                        let _e460 = phi_769_;
                        if _e460 {
                            if _e455 {
                                if _e458 {
                                    if (_e338 == 0u) {
                                        let _e488 = ((((_e346.member_2[0] - _e346.member[0]) * (_e346.member_2[1] - _e346.member[1])) * (_e346.member_2[2] - _e346.member[2])) > (((_e344.member_2[0] - _e344.member[0]) * (_e344.member_2[1] - _e344.member[1])) * (_e344.member_2[2] - _e344.member[2])));
                                        phi_813_ = _e488;
                                        phi_814_ = !(_e488);
                                    } else {
                                        phi_813_ = _e458;
                                        phi_814_ = _e455;
                                    }
                                    let _e491 = phi_813_;
                                    let _e493 = phi_814_;
                                    phi_815_ = _e491;
                                    phi_816_ = _e493;
                                } else {
                                    phi_815_ = _e458;
                                    phi_816_ = _e455;
                                }
                                let _e495 = phi_815_;
                                let _e497 = phi_816_;
                                phi_817_ = _e495;
                                phi_818_ = _e497;
                            } else {
                                phi_817_ = _e458;
                                phi_818_ = _e455;
                            }
                            let _e499 = phi_817_;
                            let _e501 = phi_818_;
                            if _e501 {
                                if _e499 {
                                    let _e504 = a.member[_e344.member_1];
                                    let _e509 = a.member[_e344.member_3];
                                    let _e514 = b.member[_e346.member_1];
                                    let _e519 = b.member[_e346.member_3];
                                    let _e524 = array<u32, 2>(_e344.member_1, _e346.member_1);
                                    let _e527 = array<u32, 2>(_e344.member_1, _e346.member_3);
                                    let _e530 = array<u32, 2>(_e344.member_3, _e346.member_1);
                                    let _e533 = array<u32, 2>(_e344.member_3, _e346.member_3);
                                    if ((((((_e504.member[0] <= _e514.member_2[0]) && (_e514.member[0] <= _e504.member_2[0])) && (_e504.member[1] <= _e514.member_2[1])) && (_e514.member[1] <= _e504.member_2[1])) && (_e504.member[2] <= _e514.member_2[2])) && (_e514.member[2] <= _e504.member_2[2])) {
                                        phi_924_ = _e524;
                                    } else {
                                        phi_924_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e559 = phi_924_;
                                    if ((((((_e504.member[0] <= _e519.member_2[0]) && (_e519.member[0] <= _e504.member_2[0])) && (_e504.member[1] <= _e519.member_2[1])) && (_e519.member[1] <= _e504.member_2[1])) && (_e504.member[2] <= _e519.member_2[2])) && (_e519.member[2] <= _e504.member_2[2])) {
                                        phi_953_ = _e527;
                                    } else {
                                        phi_953_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e584 = phi_953_;
                                    if ((((((_e509.member[0] <= _e514.member_2[0]) && (_e514.member[0] <= _e509.member_2[0])) && (_e509.member[1] <= _e514.member_2[1])) && (_e514.member[1] <= _e509.member_2[1])) && (_e509.member[2] <= _e514.member_2[2])) && (_e514.member[2] <= _e509.member_2[2])) {
                                        phi_982_ = _e530;
                                    } else {
                                        phi_982_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e609 = phi_982_;
                                    if ((((((_e509.member[0] <= _e519.member_2[0]) && (_e519.member[0] <= _e509.member_2[0])) && (_e509.member[1] <= _e519.member_2[1])) && (_e519.member[1] <= _e509.member_2[1])) && (_e509.member[2] <= _e519.member_2[2])) && (_e519.member[2] <= _e509.member_2[2])) {
                                        phi_1011_ = _e533;
                                    } else {
                                        phi_1011_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e634 = phi_1011_;
                                    phi_1013_ = type_24(array<array<u32, 2>, 4>(_e524, _e527, _e530, _e533), array<array<u32, 2>, 4>(_e559, _e584, _e609, _e634));
                                    phi_1014_ = false;
                                } else {
                                    phi_1013_ = type_24();
                                    phi_1014_ = true;
                                }
                                let _e638 = phi_1013_;
                                let _e640 = phi_1014_;
                                phi_1015_ = _e638;
                                phi_1016_ = _e640;
                            } else {
                                phi_1015_ = type_24();
                                phi_1016_ = true;
                            }
                            let _e642 = phi_1015_;
                            let _e644 = phi_1016_;
                            if _e644 {
                                if _e501 {
                                    let _e732 = a.member[_e344.member_1];
                                    let _e737 = a.member[_e344.member_3];
                                    let _e741 = array<u32, 2>(_e344.member_1, _e310[1]);
                                    let _e743 = array<u32, 2>(_e344.member_3, _e310[1]);
                                    let _e746 = type_24(array<array<u32, 2>, 4>(_e741, _e743, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e732.member[0] <= _e346.member_2[0]) && (_e346.member[0] <= _e732.member_2[0])) && (_e732.member[1] <= _e346.member_2[1])) && (_e346.member[1] <= _e732.member_2[1])) && (_e732.member[2] <= _e346.member_2[2])) && (_e346.member[2] <= _e732.member_2[2])) {
                                        phi_1089_ = _e741;
                                    } else {
                                        phi_1089_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e773 = phi_1089_;
                                    let _e780 = type_24(_e746.member, array<array<u32, 2>, 4>(_e773, _e746.member_1[1], _e746.member_1[2], _e746.member_1[3]));
                                    if ((((((_e737.member[0] <= _e346.member_2[0]) && (_e346.member[0] <= _e737.member_2[0])) && (_e737.member[1] <= _e346.member_2[1])) && (_e346.member[1] <= _e737.member_2[1])) && (_e737.member[2] <= _e346.member_2[2])) && (_e346.member[2] <= _e737.member_2[2])) {
                                        phi_1121_ = _e743;
                                    } else {
                                        phi_1121_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e807 = phi_1121_;
                                    phi_1223_ = type_24(_e780.member, array<array<u32, 2>, 4>(_e780.member_1[0], _e807, _e780.member_1[2], _e780.member_1[3]));
                                } else {
                                    let _e647 = b.member[_e346.member_1];
                                    let _e652 = b.member[_e346.member_3];
                                    let _e656 = array<u32, 2>(_e310[0], _e346.member_1);
                                    let _e658 = array<u32, 2>(_e310[0], _e346.member_3);
                                    let _e661 = type_24(array<array<u32, 2>, 4>(_e656, _e658, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e344.member[0] <= _e647.member_2[0]) && (_e647.member[0] <= _e344.member_2[0])) && (_e344.member[1] <= _e647.member_2[1])) && (_e647.member[1] <= _e344.member_2[1])) && (_e344.member[2] <= _e647.member_2[2])) && (_e647.member[2] <= _e344.member_2[2])) {
                                        phi_1189_ = _e656;
                                    } else {
                                        phi_1189_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e688 = phi_1189_;
                                    let _e695 = type_24(_e661.member, array<array<u32, 2>, 4>(_e688, _e661.member_1[1], _e661.member_1[2], _e661.member_1[3]));
                                    if ((((((_e344.member[0] <= _e652.member_2[0]) && (_e652.member[0] <= _e344.member_2[0])) && (_e344.member[1] <= _e652.member_2[1])) && (_e652.member[1] <= _e344.member_2[1])) && (_e344.member[2] <= _e652.member_2[2])) && (_e652.member[2] <= _e344.member_2[2])) {
                                        phi_1221_ = _e658;
                                    } else {
                                        phi_1221_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e722 = phi_1221_;
                                    phi_1223_ = type_24(_e695.member, array<array<u32, 2>, 4>(_e695.member_1[0], _e722, _e695.member_1[2], _e695.member_1[3]));
                                }
                                let _e816 = phi_1223_;
                                phi_1224_ = _e816;
                            } else {
                                phi_1224_ = _e642;
                            }
                            let _e818 = phi_1224_;
                            phi_1225_ = _e818;
                            phi_1226_ = false;
                        } else {
                            phi_1225_ = type_24();
                            phi_1226_ = true;
                        }
                        let _e820 = phi_1225_;
                        let _e822 = phi_1226_;
                        phi_1227_ = _e820;
                        phi_1228_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1229_ = _e822;
                    } else {
                        phi_1227_ = type_24();
                        phi_1228_ = _e450;
                        phi_1229_ = true;
                    }
                    let _e824 = phi_1227_;
                    let _e826 = phi_1228_;
                    let _e828 = phi_1229_;
                    if _e828 {
                        phi_1233_ = _e826;
                    } else {
                        phi_1233_ = _e824;
                    }
                    let _e830 = phi_1233_;
                    let _e834 = params.member.member_2.member;
                    if (_e834 == 0u) {
                        phi_1251_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1251_ = array<u32, 2>(1u, 1u);
                    }
                    let _e837 = phi_1251_;
                    let _e843 = params.member.member.member[_e837[0]];
                    let _e844 = (_e843 - 1u);
                    let _e848 = params.member.member.member[_e837[1]];
                    let _e849 = (_e848 - 1u);
                    let _e852 = params.member.member_2.member;
                    if (_e852 == 0u) {
                        phi_1282_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1282_ = array<u32, 2>(1u, 1u);
                    }
                    let _e855 = phi_1282_;
                    let _e861 = params.member.member.member_2[_e855[0]];
                    let _e865 = params.member.member.member_2[_e855[1]];
                    let _e868 = params.member.member_2.member;
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e830.member_1[0][0], _e830.member_1[0][1]), array<u32, 2>(_e830.member_1[1][0], _e830.member_1[1][1]), array<u32, 2>(_e830.member_1[2][0], _e830.member_1[2][1]), array<u32, 2>(_e830.member_1[3][0], _e830.member_1[3][1]));
                    phi_1327_ = type_9(0u, 4u);
                    loop {
                        let _e888 = phi_1327_;
                        if (_e888.member < _e888.member_1) {
                            phi_1328_ = type_9((_e888.member + 1u), _e888.member_1);
                            phi_1351_ = type_9(1u, _e888.member);
                        } else {
                            phi_1328_ = _e888;
                            phi_1351_ = type_9(0u, type_9().member_1);
                        }
                        let _e900 = phi_1328_;
                        let _e902 = phi_1351_;
                        let _e906 = (bitcast<i32>(_e902.member) != 0i);
                        if _e906 {
                            let _e908 = local_1[_e902.member_1];
                            if (_e908[0] != 4294967295u) {
                                if (_e868 == 1u) {
                                    phi_1380_ = (_e908[0] == _e908[1]);
                                } else {
                                    phi_1380_ = false;
                                }
                                let _e914 = phi_1380_;
                                if _e914 {
                                    phi_3589_ = bool();
                                    phi_3590_ = true;
                                } else {
                                    if (_e908[0] >= _e844) {
                                        if (_e908[1] >= _e849) {
                                            phi_1392_ = false;
                                        } else {
                                            phi_1392_ = true;
                                        }
                                        let _e918 = phi_1392_;
                                        phi_1393_ = _e918;
                                    } else {
                                        phi_1393_ = true;
                                    }
                                    let _e920 = phi_1393_;
                                    if _e920 {
                                        if (_e908[0] < _e844) {
                                            let _e1000 = oriented.member[(_e861 + _e908[0])];
                                            phi_1540_ = type_31(array<f32, 3>(_e1000.member.x, _e1000.member.y, _e1000.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1000.member.w, _e1000.member_1.x, _e1000.member_1.y), array<f32, 3>(_e1000.member_1.z, _e1000.member_1.w, _e1000.member_2.x), array<f32, 3>(_e1000.member_2.y, _e1000.member_2.z, _e1000.member_2.w)), array<f32, 3>(_e1000.member_3.x, _e1000.member_3.y, _e1000.member_3.z));
                                        } else {
                                            let _e923 = a.member[_e908[0]];
                                            let _e938 = ((_e923.member[0] * 0.5f) + (_e923.member_2[0] * 0.5f));
                                            let _e939 = ((_e923.member[1] * 0.5f) + (_e923.member_2[1] * 0.5f));
                                            let _e940 = ((_e923.member[2] * 0.5f) + (_e923.member_2[2] * 0.5f));
                                            if (_e938 < _e923.member_2[0]) {
                                                phi_1466_ = _e938;
                                            } else {
                                                phi_1466_ = _e923.member_2[0];
                                            }
                                            let _e944 = phi_1466_;
                                            if (_e939 < _e923.member_2[1]) {
                                                phi_1472_ = _e939;
                                            } else {
                                                phi_1472_ = _e923.member_2[1];
                                            }
                                            let _e948 = phi_1472_;
                                            if (_e940 < _e923.member_2[2]) {
                                                phi_1478_ = _e940;
                                            } else {
                                                phi_1478_ = _e923.member_2[2];
                                            }
                                            let _e952 = phi_1478_;
                                            if (_e944 > _e923.member[0]) {
                                                phi_1484_ = _e944;
                                            } else {
                                                phi_1484_ = _e923.member[0];
                                            }
                                            let _e956 = phi_1484_;
                                            if (_e948 > _e923.member[1]) {
                                                phi_1490_ = _e948;
                                            } else {
                                                phi_1490_ = _e923.member[1];
                                            }
                                            let _e960 = phi_1490_;
                                            if (_e952 > _e923.member[2]) {
                                                phi_1496_ = _e952;
                                            } else {
                                                phi_1496_ = _e923.member[2];
                                            }
                                            let _e964 = phi_1496_;
                                            let _e967 = (_e923.member_2[0] - _e956);
                                            let _e969 = (_e923.member_2[1] - _e960);
                                            let _e971 = (_e923.member_2[2] - _e964);
                                            let _e973 = (_e956 - _e923.member[0]);
                                            let _e975 = (_e960 - _e923.member[1]);
                                            let _e977 = (_e964 - _e923.member[2]);
                                            if (_e967 > _e973) {
                                                phi_1514_ = _e967;
                                            } else {
                                                phi_1514_ = _e973;
                                            }
                                            let _e980 = phi_1514_;
                                            if (_e969 > _e975) {
                                                phi_1519_ = _e969;
                                            } else {
                                                phi_1519_ = _e975;
                                            }
                                            let _e983 = phi_1519_;
                                            if (_e971 > _e977) {
                                                phi_1524_ = _e971;
                                            } else {
                                                phi_1524_ = _e977;
                                            }
                                            let _e986 = phi_1524_;
                                            let _e988 = (1f + (0.000000059604645f * 4f));
                                            let _e992 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1540_ = type_31(array<f32, 3>(_e956, _e960, _e964), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e980 * _e988) + _e992), ((_e983 * _e988) + _e992), ((_e986 * _e988) + _e992)));
                                        }
                                        let _e1039 = phi_1540_;
                                        if (_e908[1] < _e849) {
                                            let _e1119 = oriented.member[(_e865 + _e908[1])];
                                            phi_1684_ = type_31(array<f32, 3>(_e1119.member.x, _e1119.member.y, _e1119.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1119.member.w, _e1119.member_1.x, _e1119.member_1.y), array<f32, 3>(_e1119.member_1.z, _e1119.member_1.w, _e1119.member_2.x), array<f32, 3>(_e1119.member_2.y, _e1119.member_2.z, _e1119.member_2.w)), array<f32, 3>(_e1119.member_3.x, _e1119.member_3.y, _e1119.member_3.z));
                                        } else {
                                            let _e1042 = b.member[_e908[1]];
                                            let _e1057 = ((_e1042.member[0] * 0.5f) + (_e1042.member_2[0] * 0.5f));
                                            let _e1058 = ((_e1042.member[1] * 0.5f) + (_e1042.member_2[1] * 0.5f));
                                            let _e1059 = ((_e1042.member[2] * 0.5f) + (_e1042.member_2[2] * 0.5f));
                                            if (_e1057 < _e1042.member_2[0]) {
                                                phi_1610_ = _e1057;
                                            } else {
                                                phi_1610_ = _e1042.member_2[0];
                                            }
                                            let _e1063 = phi_1610_;
                                            if (_e1058 < _e1042.member_2[1]) {
                                                phi_1616_ = _e1058;
                                            } else {
                                                phi_1616_ = _e1042.member_2[1];
                                            }
                                            let _e1067 = phi_1616_;
                                            if (_e1059 < _e1042.member_2[2]) {
                                                phi_1622_ = _e1059;
                                            } else {
                                                phi_1622_ = _e1042.member_2[2];
                                            }
                                            let _e1071 = phi_1622_;
                                            if (_e1063 > _e1042.member[0]) {
                                                phi_1628_ = _e1063;
                                            } else {
                                                phi_1628_ = _e1042.member[0];
                                            }
                                            let _e1075 = phi_1628_;
                                            if (_e1067 > _e1042.member[1]) {
                                                phi_1634_ = _e1067;
                                            } else {
                                                phi_1634_ = _e1042.member[1];
                                            }
                                            let _e1079 = phi_1634_;
                                            if (_e1071 > _e1042.member[2]) {
                                                phi_1640_ = _e1071;
                                            } else {
                                                phi_1640_ = _e1042.member[2];
                                            }
                                            let _e1083 = phi_1640_;
                                            let _e1086 = (_e1042.member_2[0] - _e1075);
                                            let _e1088 = (_e1042.member_2[1] - _e1079);
                                            let _e1090 = (_e1042.member_2[2] - _e1083);
                                            let _e1092 = (_e1075 - _e1042.member[0]);
                                            let _e1094 = (_e1079 - _e1042.member[1]);
                                            let _e1096 = (_e1083 - _e1042.member[2]);
                                            if (_e1086 > _e1092) {
                                                phi_1658_ = _e1086;
                                            } else {
                                                phi_1658_ = _e1092;
                                            }
                                            let _e1099 = phi_1658_;
                                            if (_e1088 > _e1094) {
                                                phi_1663_ = _e1088;
                                            } else {
                                                phi_1663_ = _e1094;
                                            }
                                            let _e1102 = phi_1663_;
                                            if (_e1090 > _e1096) {
                                                phi_1668_ = _e1090;
                                            } else {
                                                phi_1668_ = _e1096;
                                            }
                                            let _e1105 = phi_1668_;
                                            let _e1107 = (1f + (0.000000059604645f * 4f));
                                            let _e1111 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1684_ = type_31(array<f32, 3>(_e1075, _e1079, _e1083), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1099 * _e1107) + _e1111), ((_e1102 * _e1107) + _e1111), ((_e1105 * _e1107) + _e1111)));
                                        }
                                        let _e1158 = phi_1684_;
                                        let _e1163 = (_e1158.member[0] - _e1039.member[0]);
                                        let _e1166 = (_e1158.member[1] - _e1039.member[1]);
                                        let _e1169 = (_e1158.member[2] - _e1039.member[2]);
                                        if (_e1163 < 0f) {
                                            phi_1874_ = -(_e1163);
                                        } else {
                                            phi_1874_ = _e1163;
                                        }
                                        let _e1358 = phi_1874_;
                                        if (_e1166 < 0f) {
                                            phi_1880_ = -(_e1166);
                                        } else {
                                            phi_1880_ = _e1166;
                                        }
                                        let _e1362 = phi_1880_;
                                        if (_e1169 < 0f) {
                                            phi_1887_ = -(_e1169);
                                        } else {
                                            phi_1887_ = _e1169;
                                        }
                                        let _e1367 = phi_1887_;
                                        if (_e1039.member_2[0] < 0f) {
                                            phi_1896_ = -(_e1039.member_2[0]);
                                        } else {
                                            phi_1896_ = _e1039.member_2[0];
                                        }
                                        let _e1374 = phi_1896_;
                                        if (_e1039.member_2[1] < 0f) {
                                            phi_1903_ = -(_e1039.member_2[1]);
                                        } else {
                                            phi_1903_ = _e1039.member_2[1];
                                        }
                                        let _e1379 = phi_1903_;
                                        if (_e1039.member_2[2] < 0f) {
                                            phi_1911_ = -(_e1039.member_2[2]);
                                        } else {
                                            phi_1911_ = _e1039.member_2[2];
                                        }
                                        let _e1385 = phi_1911_;
                                        if (_e1158.member_2[0] < 0f) {
                                            phi_1920_ = -(_e1158.member_2[0]);
                                        } else {
                                            phi_1920_ = _e1158.member_2[0];
                                        }
                                        let _e1392 = phi_1920_;
                                        if (_e1158.member_2[1] < 0f) {
                                            phi_1927_ = -(_e1158.member_2[1]);
                                        } else {
                                            phi_1927_ = _e1158.member_2[1];
                                        }
                                        let _e1397 = phi_1927_;
                                        if (_e1158.member_2[2] < 0f) {
                                            phi_1935_ = -(_e1158.member_2[2]);
                                        } else {
                                            phi_1935_ = _e1158.member_2[2];
                                        }
                                        let _e1403 = phi_1935_;
                                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e1158.member_1[0][0] * _e1039.member_1[0][0]) + (_e1158.member_1[0][1] * _e1039.member_1[0][1])) + (_e1158.member_1[0][2] * _e1039.member_1[0][2])), (((_e1158.member_1[1][0] * _e1039.member_1[0][0]) + (_e1158.member_1[1][1] * _e1039.member_1[0][1])) + (_e1158.member_1[1][2] * _e1039.member_1[0][2])), (((_e1158.member_1[2][0] * _e1039.member_1[0][0]) + (_e1158.member_1[2][1] * _e1039.member_1[0][1])) + (_e1158.member_1[2][2] * _e1039.member_1[0][2]))), array<f32, 3>((((_e1158.member_1[0][0] * _e1039.member_1[1][0]) + (_e1158.member_1[0][1] * _e1039.member_1[1][1])) + (_e1158.member_1[0][2] * _e1039.member_1[1][2])), (((_e1158.member_1[1][0] * _e1039.member_1[1][0]) + (_e1158.member_1[1][1] * _e1039.member_1[1][1])) + (_e1158.member_1[1][2] * _e1039.member_1[1][2])), (((_e1158.member_1[2][0] * _e1039.member_1[1][0]) + (_e1158.member_1[2][1] * _e1039.member_1[1][1])) + (_e1158.member_1[2][2] * _e1039.member_1[1][2]))), array<f32, 3>((((_e1158.member_1[0][0] * _e1039.member_1[2][0]) + (_e1158.member_1[0][1] * _e1039.member_1[2][1])) + (_e1158.member_1[0][2] * _e1039.member_1[2][2])), (((_e1158.member_1[1][0] * _e1039.member_1[2][0]) + (_e1158.member_1[1][1] * _e1039.member_1[2][1])) + (_e1158.member_1[1][2] * _e1039.member_1[2][2])), (((_e1158.member_1[2][0] * _e1039.member_1[2][0]) + (_e1158.member_1[2][1] * _e1039.member_1[2][1])) + (_e1158.member_1[2][2] * _e1039.member_1[2][2])))), array<f32, 3>((((_e1039.member_1[0][0] * _e1163) + (_e1039.member_1[0][1] * _e1166)) + (_e1039.member_1[0][2] * _e1169)), (((_e1039.member_1[1][0] * _e1163) + (_e1039.member_1[1][1] * _e1166)) + (_e1039.member_1[1][2] * _e1169)), (((_e1039.member_1[2][0] * _e1163) + (_e1039.member_1[2][1] * _e1166)) + (_e1039.member_1[2][2] * _e1169))), array<f32, 3>((((_e1158.member_1[0][0] * _e1163) + (_e1158.member_1[0][1] * _e1166)) + (_e1158.member_1[0][2] * _e1169)), (((_e1158.member_1[1][0] * _e1163) + (_e1158.member_1[1][1] * _e1166)) + (_e1158.member_1[1][2] * _e1169)), (((_e1158.member_1[2][0] * _e1163) + (_e1158.member_1[2][1] * _e1166)) + (_e1158.member_1[2][2] * _e1169))), array<f32, 3>(_e1039.member_2[0], _e1039.member_2[1], _e1039.member_2[2]), array<f32, 3>(_e1158.member_2[0], _e1158.member_2[1], _e1158.member_2[2]), ((((((_e1358 + _e1362) + _e1367) + (((_e1374 + _e1379) + _e1385) + ((_e1392 + _e1397) + _e1403))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1430 = local.member[0u][0u];
                                        let _e1434 = local.member[0u][1u];
                                        let _e1438 = local.member[0u][2u];
                                        let _e1442 = local.member[1u][0u];
                                        let _e1446 = local.member[1u][1u];
                                        let _e1450 = local.member[1u][2u];
                                        let _e1454 = local.member[2u][0u];
                                        let _e1458 = local.member[2u][1u];
                                        let _e1462 = local.member[2u][2u];
                                        let _e1464 = local.member_3;
                                        let _e1469 = local.member_4;
                                        let _e1475 = local.member_1[0u];
                                        if (_e1475 < 0f) {
                                            phi_2028_ = -(_e1475);
                                        } else {
                                            phi_2028_ = _e1475;
                                        }
                                        let _e1479 = phi_2028_;
                                        if (_e1430 < 0f) {
                                            phi_2035_ = -(_e1430);
                                        } else {
                                            phi_2035_ = _e1430;
                                        }
                                        let _e1483 = phi_2035_;
                                        if (_e1434 < 0f) {
                                            phi_2041_ = -(_e1434);
                                        } else {
                                            phi_2041_ = _e1434;
                                        }
                                        let _e1487 = phi_2041_;
                                        if (_e1438 < 0f) {
                                            phi_2047_ = -(_e1438);
                                        } else {
                                            phi_2047_ = _e1438;
                                        }
                                        let _e1491 = phi_2047_;
                                        let _e1498 = (_e1479 - (_e1464[0] + (((_e1483 * _e1469[0]) + (_e1487 * _e1469[1])) + (_e1491 * _e1469[2]))));
                                        let _e1501 = local.member_1[1u];
                                        if (_e1501 < 0f) {
                                            phi_2066_ = -(_e1501);
                                        } else {
                                            phi_2066_ = _e1501;
                                        }
                                        let _e1505 = phi_2066_;
                                        if (_e1442 < 0f) {
                                            phi_2073_ = -(_e1442);
                                        } else {
                                            phi_2073_ = _e1442;
                                        }
                                        let _e1509 = phi_2073_;
                                        if (_e1446 < 0f) {
                                            phi_2079_ = -(_e1446);
                                        } else {
                                            phi_2079_ = _e1446;
                                        }
                                        let _e1513 = phi_2079_;
                                        if (_e1450 < 0f) {
                                            phi_2085_ = -(_e1450);
                                        } else {
                                            phi_2085_ = _e1450;
                                        }
                                        let _e1517 = phi_2085_;
                                        let _e1524 = (_e1505 - (_e1464[1] + (((_e1509 * _e1469[0]) + (_e1513 * _e1469[1])) + (_e1517 * _e1469[2]))));
                                        let _e1527 = local.member_1[2u];
                                        if (_e1527 < 0f) {
                                            phi_2104_ = -(_e1527);
                                        } else {
                                            phi_2104_ = _e1527;
                                        }
                                        let _e1531 = phi_2104_;
                                        if (_e1454 < 0f) {
                                            phi_2111_ = -(_e1454);
                                        } else {
                                            phi_2111_ = _e1454;
                                        }
                                        let _e1535 = phi_2111_;
                                        if (_e1458 < 0f) {
                                            phi_2117_ = -(_e1458);
                                        } else {
                                            phi_2117_ = _e1458;
                                        }
                                        let _e1539 = phi_2117_;
                                        if (_e1462 < 0f) {
                                            phi_2123_ = -(_e1462);
                                        } else {
                                            phi_2123_ = _e1462;
                                        }
                                        let _e1543 = phi_2123_;
                                        let _e1550 = (_e1531 - (_e1464[2] + (((_e1535 * _e1469[0]) + (_e1539 * _e1469[1])) + (_e1543 * _e1469[2]))));
                                        let _e1553 = local.member_2[0u];
                                        if (_e1553 < 0f) {
                                            phi_2142_ = -(_e1553);
                                        } else {
                                            phi_2142_ = _e1553;
                                        }
                                        let _e1557 = phi_2142_;
                                        if (_e1430 < 0f) {
                                            phi_2149_ = -(_e1430);
                                        } else {
                                            phi_2149_ = _e1430;
                                        }
                                        let _e1561 = phi_2149_;
                                        if (_e1442 < 0f) {
                                            phi_2155_ = -(_e1442);
                                        } else {
                                            phi_2155_ = _e1442;
                                        }
                                        let _e1565 = phi_2155_;
                                        if (_e1454 < 0f) {
                                            phi_2161_ = -(_e1454);
                                        } else {
                                            phi_2161_ = _e1454;
                                        }
                                        let _e1569 = phi_2161_;
                                        let _e1576 = (_e1557 - (_e1469[0] + (((_e1561 * _e1464[0]) + (_e1565 * _e1464[1])) + (_e1569 * _e1464[2]))));
                                        let _e1579 = local.member_2[1u];
                                        if (_e1579 < 0f) {
                                            phi_2180_ = -(_e1579);
                                        } else {
                                            phi_2180_ = _e1579;
                                        }
                                        let _e1583 = phi_2180_;
                                        if (_e1434 < 0f) {
                                            phi_2187_ = -(_e1434);
                                        } else {
                                            phi_2187_ = _e1434;
                                        }
                                        let _e1587 = phi_2187_;
                                        if (_e1446 < 0f) {
                                            phi_2193_ = -(_e1446);
                                        } else {
                                            phi_2193_ = _e1446;
                                        }
                                        let _e1591 = phi_2193_;
                                        if (_e1458 < 0f) {
                                            phi_2199_ = -(_e1458);
                                        } else {
                                            phi_2199_ = _e1458;
                                        }
                                        let _e1595 = phi_2199_;
                                        let _e1602 = (_e1583 - (_e1469[1] + (((_e1587 * _e1464[0]) + (_e1591 * _e1464[1])) + (_e1595 * _e1464[2]))));
                                        let _e1605 = local.member_2[2u];
                                        if (_e1605 < 0f) {
                                            phi_2218_ = -(_e1605);
                                        } else {
                                            phi_2218_ = _e1605;
                                        }
                                        let _e1609 = phi_2218_;
                                        if (_e1438 < 0f) {
                                            phi_2225_ = -(_e1438);
                                        } else {
                                            phi_2225_ = _e1438;
                                        }
                                        let _e1613 = phi_2225_;
                                        if (_e1450 < 0f) {
                                            phi_2231_ = -(_e1450);
                                        } else {
                                            phi_2231_ = _e1450;
                                        }
                                        let _e1617 = phi_2231_;
                                        if (_e1462 < 0f) {
                                            phi_2237_ = -(_e1462);
                                        } else {
                                            phi_2237_ = _e1462;
                                        }
                                        let _e1621 = phi_2237_;
                                        let _e1628 = (_e1609 - (_e1469[2] + (((_e1613 * _e1464[0]) + (_e1617 * _e1464[1])) + (_e1621 * _e1464[2]))));
                                        if (_e1498 > _e1524) {
                                            phi_2252_ = _e1498;
                                        } else {
                                            phi_2252_ = _e1524;
                                        }
                                        let _e1631 = phi_2252_;
                                        if (_e1631 > _e1550) {
                                            phi_2257_ = _e1631;
                                        } else {
                                            phi_2257_ = _e1550;
                                        }
                                        let _e1634 = phi_2257_;
                                        if (_e1576 > _e1602) {
                                            phi_2262_ = _e1576;
                                        } else {
                                            phi_2262_ = _e1602;
                                        }
                                        let _e1637 = phi_2262_;
                                        if (_e1637 > _e1628) {
                                            phi_2267_ = _e1637;
                                        } else {
                                            phi_2267_ = _e1628;
                                        }
                                        let _e1640 = phi_2267_;
                                        if (_e1634 > _e1640) {
                                            phi_2272_ = _e1634;
                                        } else {
                                            phi_2272_ = _e1640;
                                        }
                                        let _e1643 = phi_2272_;
                                        let _e1645 = local.member_5;
                                        if (_e1643 > _e1645) {
                                            phi_3585_ = true;
                                        } else {
                                            let _e1650 = local.member[1u][0u];
                                            let _e1653 = local.member_1[2u];
                                            let _e1658 = local.member[2u][0u];
                                            let _e1661 = local.member_1[1u];
                                            let _e1663 = ((_e1650 * _e1653) - (_e1658 * _e1661));
                                            let _e1667 = local.member[2u][0u];
                                            if (_e1667 < 0f) {
                                                phi_2331_ = -(_e1667);
                                            } else {
                                                phi_2331_ = _e1667;
                                            }
                                            let _e1671 = phi_2331_;
                                            let _e1674 = local.member_3[1u];
                                            let _e1679 = local.member[1u][0u];
                                            if (_e1679 < 0f) {
                                                phi_2354_ = -(_e1679);
                                            } else {
                                                phi_2354_ = _e1679;
                                            }
                                            let _e1683 = phi_2354_;
                                            let _e1686 = local.member_3[2u];
                                            let _e1692 = local.member[0u][2u];
                                            if (_e1692 < 0f) {
                                                phi_2377_ = -(_e1692);
                                            } else {
                                                phi_2377_ = _e1692;
                                            }
                                            let _e1696 = phi_2377_;
                                            let _e1699 = local.member_4[1u];
                                            let _e1704 = local.member[0u][1u];
                                            if (_e1704 < 0f) {
                                                phi_2399_ = -(_e1704);
                                            } else {
                                                phi_2399_ = _e1704;
                                            }
                                            let _e1708 = phi_2399_;
                                            let _e1711 = local.member_4[2u];
                                            if (_e1663 < 0f) {
                                                phi_2415_ = -(_e1663);
                                            } else {
                                                phi_2415_ = _e1663;
                                            }
                                            let _e1717 = phi_2415_;
                                            let _e1719 = (_e1717 - (((_e1671 * _e1674) + (_e1683 * _e1686)) + ((_e1696 * _e1699) + (_e1708 * _e1711))));
                                            let _e1723 = local.member[1u][1u];
                                            let _e1726 = local.member_1[2u];
                                            let _e1731 = local.member[2u][1u];
                                            let _e1734 = local.member_1[1u];
                                            let _e1736 = ((_e1723 * _e1726) - (_e1731 * _e1734));
                                            let _e1740 = local.member[2u][1u];
                                            if (_e1740 < 0f) {
                                                phi_2470_ = -(_e1740);
                                            } else {
                                                phi_2470_ = _e1740;
                                            }
                                            let _e1744 = phi_2470_;
                                            let _e1747 = local.member_3[1u];
                                            let _e1752 = local.member[1u][1u];
                                            if (_e1752 < 0f) {
                                                phi_2493_ = -(_e1752);
                                            } else {
                                                phi_2493_ = _e1752;
                                            }
                                            let _e1756 = phi_2493_;
                                            let _e1759 = local.member_3[2u];
                                            let _e1765 = local.member[0u][0u];
                                            if (_e1765 < 0f) {
                                                phi_2516_ = -(_e1765);
                                            } else {
                                                phi_2516_ = _e1765;
                                            }
                                            let _e1769 = phi_2516_;
                                            let _e1772 = local.member_4[2u];
                                            let _e1777 = local.member[0u][2u];
                                            if (_e1777 < 0f) {
                                                phi_2538_ = -(_e1777);
                                            } else {
                                                phi_2538_ = _e1777;
                                            }
                                            let _e1781 = phi_2538_;
                                            let _e1784 = local.member_4[0u];
                                            if (_e1736 < 0f) {
                                                phi_2554_ = -(_e1736);
                                            } else {
                                                phi_2554_ = _e1736;
                                            }
                                            let _e1790 = phi_2554_;
                                            let _e1792 = (_e1790 - (((_e1744 * _e1747) + (_e1756 * _e1759)) + ((_e1769 * _e1772) + (_e1781 * _e1784))));
                                            let _e1796 = local.member[1u][2u];
                                            let _e1799 = local.member_1[2u];
                                            let _e1804 = local.member[2u][2u];
                                            let _e1807 = local.member_1[1u];
                                            let _e1809 = ((_e1796 * _e1799) - (_e1804 * _e1807));
                                            let _e1813 = local.member[2u][2u];
                                            if (_e1813 < 0f) {
                                                phi_2609_ = -(_e1813);
                                            } else {
                                                phi_2609_ = _e1813;
                                            }
                                            let _e1817 = phi_2609_;
                                            let _e1820 = local.member_3[1u];
                                            let _e1825 = local.member[1u][2u];
                                            if (_e1825 < 0f) {
                                                phi_2632_ = -(_e1825);
                                            } else {
                                                phi_2632_ = _e1825;
                                            }
                                            let _e1829 = phi_2632_;
                                            let _e1832 = local.member_3[2u];
                                            let _e1838 = local.member[0u][1u];
                                            if (_e1838 < 0f) {
                                                phi_2655_ = -(_e1838);
                                            } else {
                                                phi_2655_ = _e1838;
                                            }
                                            let _e1842 = phi_2655_;
                                            let _e1845 = local.member_4[0u];
                                            let _e1850 = local.member[0u][0u];
                                            if (_e1850 < 0f) {
                                                phi_2677_ = -(_e1850);
                                            } else {
                                                phi_2677_ = _e1850;
                                            }
                                            let _e1854 = phi_2677_;
                                            let _e1857 = local.member_4[1u];
                                            if (_e1809 < 0f) {
                                                phi_2693_ = -(_e1809);
                                            } else {
                                                phi_2693_ = _e1809;
                                            }
                                            let _e1863 = phi_2693_;
                                            let _e1865 = (_e1863 - (((_e1817 * _e1820) + (_e1829 * _e1832)) + ((_e1842 * _e1845) + (_e1854 * _e1857))));
                                            let _e1869 = local.member[2u][0u];
                                            let _e1872 = local.member_1[0u];
                                            let _e1877 = local.member[0u][0u];
                                            let _e1880 = local.member_1[2u];
                                            let _e1882 = ((_e1869 * _e1872) - (_e1877 * _e1880));
                                            let _e1886 = local.member[0u][0u];
                                            if (_e1886 < 0f) {
                                                phi_2748_ = -(_e1886);
                                            } else {
                                                phi_2748_ = _e1886;
                                            }
                                            let _e1890 = phi_2748_;
                                            let _e1893 = local.member_3[2u];
                                            let _e1898 = local.member[2u][0u];
                                            if (_e1898 < 0f) {
                                                phi_2771_ = -(_e1898);
                                            } else {
                                                phi_2771_ = _e1898;
                                            }
                                            let _e1902 = phi_2771_;
                                            let _e1905 = local.member_3[0u];
                                            let _e1911 = local.member[1u][2u];
                                            if (_e1911 < 0f) {
                                                phi_2795_ = -(_e1911);
                                            } else {
                                                phi_2795_ = _e1911;
                                            }
                                            let _e1915 = phi_2795_;
                                            let _e1918 = local.member_4[1u];
                                            let _e1923 = local.member[1u][1u];
                                            if (_e1923 < 0f) {
                                                phi_2818_ = -(_e1923);
                                            } else {
                                                phi_2818_ = _e1923;
                                            }
                                            let _e1927 = phi_2818_;
                                            let _e1930 = local.member_4[2u];
                                            if (_e1882 < 0f) {
                                                phi_2834_ = -(_e1882);
                                            } else {
                                                phi_2834_ = _e1882;
                                            }
                                            let _e1936 = phi_2834_;
                                            let _e1938 = (_e1936 - (((_e1890 * _e1893) + (_e1902 * _e1905)) + ((_e1915 * _e1918) + (_e1927 * _e1930))));
                                            let _e1942 = local.member[2u][1u];
                                            let _e1945 = local.member_1[0u];
                                            let _e1950 = local.member[0u][1u];
                                            let _e1953 = local.member_1[2u];
                                            let _e1955 = ((_e1942 * _e1945) - (_e1950 * _e1953));
                                            let _e1959 = local.member[0u][1u];
                                            if (_e1959 < 0f) {
                                                phi_2889_ = -(_e1959);
                                            } else {
                                                phi_2889_ = _e1959;
                                            }
                                            let _e1963 = phi_2889_;
                                            let _e1966 = local.member_3[2u];
                                            let _e1971 = local.member[2u][1u];
                                            if (_e1971 < 0f) {
                                                phi_2912_ = -(_e1971);
                                            } else {
                                                phi_2912_ = _e1971;
                                            }
                                            let _e1975 = phi_2912_;
                                            let _e1978 = local.member_3[0u];
                                            let _e1984 = local.member[1u][0u];
                                            if (_e1984 < 0f) {
                                                phi_2936_ = -(_e1984);
                                            } else {
                                                phi_2936_ = _e1984;
                                            }
                                            let _e1988 = phi_2936_;
                                            let _e1991 = local.member_4[2u];
                                            let _e1996 = local.member[1u][2u];
                                            if (_e1996 < 0f) {
                                                phi_2959_ = -(_e1996);
                                            } else {
                                                phi_2959_ = _e1996;
                                            }
                                            let _e2000 = phi_2959_;
                                            let _e2003 = local.member_4[0u];
                                            if (_e1955 < 0f) {
                                                phi_2975_ = -(_e1955);
                                            } else {
                                                phi_2975_ = _e1955;
                                            }
                                            let _e2009 = phi_2975_;
                                            let _e2011 = (_e2009 - (((_e1963 * _e1966) + (_e1975 * _e1978)) + ((_e1988 * _e1991) + (_e2000 * _e2003))));
                                            let _e2015 = local.member[2u][2u];
                                            let _e2018 = local.member_1[0u];
                                            let _e2023 = local.member[0u][2u];
                                            let _e2026 = local.member_1[2u];
                                            let _e2028 = ((_e2015 * _e2018) - (_e2023 * _e2026));
                                            let _e2032 = local.member[0u][2u];
                                            if (_e2032 < 0f) {
                                                phi_3030_ = -(_e2032);
                                            } else {
                                                phi_3030_ = _e2032;
                                            }
                                            let _e2036 = phi_3030_;
                                            let _e2039 = local.member_3[2u];
                                            let _e2044 = local.member[2u][2u];
                                            if (_e2044 < 0f) {
                                                phi_3053_ = -(_e2044);
                                            } else {
                                                phi_3053_ = _e2044;
                                            }
                                            let _e2048 = phi_3053_;
                                            let _e2051 = local.member_3[0u];
                                            let _e2057 = local.member[1u][1u];
                                            if (_e2057 < 0f) {
                                                phi_3077_ = -(_e2057);
                                            } else {
                                                phi_3077_ = _e2057;
                                            }
                                            let _e2061 = phi_3077_;
                                            let _e2064 = local.member_4[0u];
                                            let _e2069 = local.member[1u][0u];
                                            if (_e2069 < 0f) {
                                                phi_3100_ = -(_e2069);
                                            } else {
                                                phi_3100_ = _e2069;
                                            }
                                            let _e2073 = phi_3100_;
                                            let _e2076 = local.member_4[1u];
                                            if (_e2028 < 0f) {
                                                phi_3116_ = -(_e2028);
                                            } else {
                                                phi_3116_ = _e2028;
                                            }
                                            let _e2082 = phi_3116_;
                                            let _e2084 = (_e2082 - (((_e2036 * _e2039) + (_e2048 * _e2051)) + ((_e2061 * _e2064) + (_e2073 * _e2076))));
                                            let _e2088 = local.member[0u][0u];
                                            let _e2091 = local.member_1[1u];
                                            let _e2096 = local.member[1u][0u];
                                            let _e2099 = local.member_1[0u];
                                            let _e2101 = ((_e2088 * _e2091) - (_e2096 * _e2099));
                                            let _e2105 = local.member[1u][0u];
                                            if (_e2105 < 0f) {
                                                phi_3171_ = -(_e2105);
                                            } else {
                                                phi_3171_ = _e2105;
                                            }
                                            let _e2109 = phi_3171_;
                                            let _e2112 = local.member_3[0u];
                                            let _e2117 = local.member[0u][0u];
                                            if (_e2117 < 0f) {
                                                phi_3194_ = -(_e2117);
                                            } else {
                                                phi_3194_ = _e2117;
                                            }
                                            let _e2121 = phi_3194_;
                                            let _e2124 = local.member_3[1u];
                                            let _e2130 = local.member[2u][2u];
                                            if (_e2130 < 0f) {
                                                phi_3218_ = -(_e2130);
                                            } else {
                                                phi_3218_ = _e2130;
                                            }
                                            let _e2134 = phi_3218_;
                                            let _e2137 = local.member_4[1u];
                                            let _e2142 = local.member[2u][1u];
                                            if (_e2142 < 0f) {
                                                phi_3241_ = -(_e2142);
                                            } else {
                                                phi_3241_ = _e2142;
                                            }
                                            let _e2146 = phi_3241_;
                                            let _e2149 = local.member_4[2u];
                                            if (_e2101 < 0f) {
                                                phi_3257_ = -(_e2101);
                                            } else {
                                                phi_3257_ = _e2101;
                                            }
                                            let _e2155 = phi_3257_;
                                            let _e2157 = (_e2155 - (((_e2109 * _e2112) + (_e2121 * _e2124)) + ((_e2134 * _e2137) + (_e2146 * _e2149))));
                                            let _e2161 = local.member[0u][1u];
                                            let _e2164 = local.member_1[1u];
                                            let _e2169 = local.member[1u][1u];
                                            let _e2172 = local.member_1[0u];
                                            let _e2174 = ((_e2161 * _e2164) - (_e2169 * _e2172));
                                            let _e2178 = local.member[1u][1u];
                                            if (_e2178 < 0f) {
                                                phi_3312_ = -(_e2178);
                                            } else {
                                                phi_3312_ = _e2178;
                                            }
                                            let _e2182 = phi_3312_;
                                            let _e2185 = local.member_3[0u];
                                            let _e2190 = local.member[0u][1u];
                                            if (_e2190 < 0f) {
                                                phi_3335_ = -(_e2190);
                                            } else {
                                                phi_3335_ = _e2190;
                                            }
                                            let _e2194 = phi_3335_;
                                            let _e2197 = local.member_3[1u];
                                            let _e2203 = local.member[2u][0u];
                                            if (_e2203 < 0f) {
                                                phi_3359_ = -(_e2203);
                                            } else {
                                                phi_3359_ = _e2203;
                                            }
                                            let _e2207 = phi_3359_;
                                            let _e2210 = local.member_4[2u];
                                            let _e2215 = local.member[2u][2u];
                                            if (_e2215 < 0f) {
                                                phi_3382_ = -(_e2215);
                                            } else {
                                                phi_3382_ = _e2215;
                                            }
                                            let _e2219 = phi_3382_;
                                            let _e2222 = local.member_4[0u];
                                            if (_e2174 < 0f) {
                                                phi_3398_ = -(_e2174);
                                            } else {
                                                phi_3398_ = _e2174;
                                            }
                                            let _e2228 = phi_3398_;
                                            let _e2230 = (_e2228 - (((_e2182 * _e2185) + (_e2194 * _e2197)) + ((_e2207 * _e2210) + (_e2219 * _e2222))));
                                            let _e2234 = local.member[0u][2u];
                                            let _e2237 = local.member_1[1u];
                                            let _e2242 = local.member[1u][2u];
                                            let _e2245 = local.member_1[0u];
                                            let _e2247 = ((_e2234 * _e2237) - (_e2242 * _e2245));
                                            let _e2251 = local.member[1u][2u];
                                            if (_e2251 < 0f) {
                                                phi_3453_ = -(_e2251);
                                            } else {
                                                phi_3453_ = _e2251;
                                            }
                                            let _e2255 = phi_3453_;
                                            let _e2258 = local.member_3[0u];
                                            let _e2263 = local.member[0u][2u];
                                            if (_e2263 < 0f) {
                                                phi_3476_ = -(_e2263);
                                            } else {
                                                phi_3476_ = _e2263;
                                            }
                                            let _e2267 = phi_3476_;
                                            let _e2270 = local.member_3[1u];
                                            let _e2276 = local.member[2u][1u];
                                            if (_e2276 < 0f) {
                                                phi_3500_ = -(_e2276);
                                            } else {
                                                phi_3500_ = _e2276;
                                            }
                                            let _e2280 = phi_3500_;
                                            let _e2283 = local.member_4[0u];
                                            let _e2288 = local.member[2u][0u];
                                            if (_e2288 < 0f) {
                                                phi_3523_ = -(_e2288);
                                            } else {
                                                phi_3523_ = _e2288;
                                            }
                                            let _e2292 = phi_3523_;
                                            let _e2295 = local.member_4[1u];
                                            if (_e2247 < 0f) {
                                                phi_3539_ = -(_e2247);
                                            } else {
                                                phi_3539_ = _e2247;
                                            }
                                            let _e2301 = phi_3539_;
                                            let _e2303 = (_e2301 - (((_e2255 * _e2258) + (_e2267 * _e2270)) + ((_e2280 * _e2283) + (_e2292 * _e2295))));
                                            if (_e1719 > _e1792) {
                                                phi_3546_ = _e1719;
                                            } else {
                                                phi_3546_ = _e1792;
                                            }
                                            let _e2306 = phi_3546_;
                                            if (_e2306 > _e1865) {
                                                phi_3551_ = _e2306;
                                            } else {
                                                phi_3551_ = _e1865;
                                            }
                                            let _e2309 = phi_3551_;
                                            if (_e1938 > _e2011) {
                                                phi_3556_ = _e1938;
                                            } else {
                                                phi_3556_ = _e2011;
                                            }
                                            let _e2312 = phi_3556_;
                                            if (_e2312 > _e2084) {
                                                phi_3561_ = _e2312;
                                            } else {
                                                phi_3561_ = _e2084;
                                            }
                                            let _e2315 = phi_3561_;
                                            if (_e2309 > _e2315) {
                                                phi_3566_ = _e2309;
                                            } else {
                                                phi_3566_ = _e2315;
                                            }
                                            let _e2318 = phi_3566_;
                                            if (_e2157 > _e2230) {
                                                phi_3571_ = _e2157;
                                            } else {
                                                phi_3571_ = _e2230;
                                            }
                                            let _e2321 = phi_3571_;
                                            if (_e2321 > _e2303) {
                                                phi_3576_ = _e2321;
                                            } else {
                                                phi_3576_ = _e2303;
                                            }
                                            let _e2324 = phi_3576_;
                                            if (_e2318 > _e2324) {
                                                phi_3581_ = _e2318;
                                            } else {
                                                phi_3581_ = _e2324;
                                            }
                                            let _e2327 = phi_3581_;
                                            let _e2329 = local.member_5;
                                            phi_3585_ = (_e2327 > _e2329);
                                        }
                                        let _e2332 = phi_3585_;
                                        phi_3587_ = !(_e2332);
                                        phi_3588_ = false;
                                    } else {
                                        phi_3587_ = bool();
                                        phi_3588_ = true;
                                    }
                                    let _e2335 = phi_3587_;
                                    let _e2337 = phi_3588_;
                                    phi_3589_ = _e2335;
                                    phi_3590_ = _e2337;
                                }
                                let _e2339 = phi_3589_;
                                let _e2341 = phi_3590_;
                                if _e2341 {
                                    phi_3594_ = true;
                                } else {
                                    phi_3594_ = _e2339;
                                }
                                let _e2343 = phi_3594_;
                                if _e2343 {
                                } else {
                                    local_1[_e902.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1327_ = _e900;
                            break if !(_e906);
                        }
                    }
                    let _e2346 = local_1;
                    let _e2350 = array<u32, 2>(_e2346[0][0], _e2346[0][1]);
                    let _e2354 = array<u32, 2>(_e2346[1][0], _e2346[1][1]);
                    let _e2358 = array<u32, 2>(_e2346[2][0], _e2346[2][1]);
                    let _e2362 = array<u32, 2>(_e2346[3][0], _e2346[3][1]);
                    let _e2366 = params.member.member_2.member_4;
                    if (_e2366 > 0u) {
                        phi_3631_ = _e830.member;
                    } else {
                        phi_3631_ = array<array<u32, 2>, 4>(_e2350, _e2354, _e2358, _e2362);
                    }
                    let _e2370 = phi_3631_;
                    if (_e2346[0][0] == 4294967295u) {
                        phi_3655_ = 0u;
                    } else {
                        if (_e2346[0][0] >= _e327) {
                            if (_e2346[0][1] >= _e332) {
                                phi_3649_ = false;
                            } else {
                                phi_3649_ = true;
                            }
                            let _e2376 = phi_3649_;
                            phi_3650_ = _e2376;
                        } else {
                            phi_3650_ = true;
                        }
                        let _e2378 = phi_3650_;
                        if _e2378 {
                            phi_3654_ = 1u;
                        } else {
                            phi_3654_ = 2u;
                        }
                        let _e2380 = phi_3654_;
                        phi_3655_ = _e2380;
                    }
                    let _e2382 = phi_3655_;
                    let _e2383 = type_32(_e2350, _e2382);
                    if (_e2382 == 0u) {
                        if (_e2370[0][0] != 4294967295u) {
                            phi_3667_ = type_32(_e2370[0], 3u);
                        } else {
                            phi_3667_ = _e2383;
                        }
                        let _e2389 = phi_3667_;
                        phi_3668_ = _e2389;
                    } else {
                        phi_3668_ = _e2383;
                    }
                    let _e2391 = phi_3668_;
                    if (_e2346[1][0] == 4294967295u) {
                        phi_3692_ = 0u;
                    } else {
                        if (_e2346[1][0] >= _e327) {
                            if (_e2346[1][1] >= _e332) {
                                phi_3686_ = false;
                            } else {
                                phi_3686_ = true;
                            }
                            let _e2397 = phi_3686_;
                            phi_3687_ = _e2397;
                        } else {
                            phi_3687_ = true;
                        }
                        let _e2399 = phi_3687_;
                        if _e2399 {
                            phi_3691_ = 1u;
                        } else {
                            phi_3691_ = 2u;
                        }
                        let _e2401 = phi_3691_;
                        phi_3692_ = _e2401;
                    }
                    let _e2403 = phi_3692_;
                    let _e2404 = type_32(_e2354, _e2403);
                    if (_e2403 == 0u) {
                        if (_e2370[1][0] != 4294967295u) {
                            phi_3704_ = type_32(_e2370[1], 3u);
                        } else {
                            phi_3704_ = _e2404;
                        }
                        let _e2410 = phi_3704_;
                        phi_3705_ = _e2410;
                    } else {
                        phi_3705_ = _e2404;
                    }
                    let _e2412 = phi_3705_;
                    if (_e2346[2][0] == 4294967295u) {
                        phi_3729_ = 0u;
                    } else {
                        if (_e2346[2][0] >= _e327) {
                            if (_e2346[2][1] >= _e332) {
                                phi_3723_ = false;
                            } else {
                                phi_3723_ = true;
                            }
                            let _e2418 = phi_3723_;
                            phi_3724_ = _e2418;
                        } else {
                            phi_3724_ = true;
                        }
                        let _e2420 = phi_3724_;
                        if _e2420 {
                            phi_3728_ = 1u;
                        } else {
                            phi_3728_ = 2u;
                        }
                        let _e2422 = phi_3728_;
                        phi_3729_ = _e2422;
                    }
                    let _e2424 = phi_3729_;
                    let _e2425 = type_32(_e2358, _e2424);
                    if (_e2424 == 0u) {
                        if (_e2370[2][0] != 4294967295u) {
                            phi_3741_ = type_32(_e2370[2], 3u);
                        } else {
                            phi_3741_ = _e2425;
                        }
                        let _e2431 = phi_3741_;
                        phi_3742_ = _e2431;
                    } else {
                        phi_3742_ = _e2425;
                    }
                    let _e2433 = phi_3742_;
                    if (_e2346[3][0] == 4294967295u) {
                        phi_3766_ = 0u;
                    } else {
                        if (_e2346[3][0] >= _e327) {
                            if (_e2346[3][1] >= _e332) {
                                phi_3760_ = false;
                            } else {
                                phi_3760_ = true;
                            }
                            let _e2439 = phi_3760_;
                            phi_3761_ = _e2439;
                        } else {
                            phi_3761_ = true;
                        }
                        let _e2441 = phi_3761_;
                        if _e2441 {
                            phi_3765_ = 1u;
                        } else {
                            phi_3765_ = 2u;
                        }
                        let _e2443 = phi_3765_;
                        phi_3766_ = _e2443;
                    }
                    let _e2445 = phi_3766_;
                    let _e2446 = type_32(_e2362, _e2445);
                    if (_e2445 == 0u) {
                        if (_e2370[3][0] != 4294967295u) {
                            phi_3778_ = type_32(_e2370[3], 3u);
                        } else {
                            phi_3778_ = _e2446;
                        }
                        let _e2452 = phi_3778_;
                        phi_3779_ = _e2452;
                    } else {
                        phi_3779_ = _e2446;
                    }
                    let _e2454 = phi_3779_;
                    if (_e310[0] == 4294967295u) {
                        phi_3801_ = 0u;
                    } else {
                        if (_e310[0] >= _e327) {
                            if (_e310[1] >= _e332) {
                                phi_3795_ = false;
                            } else {
                                phi_3795_ = true;
                            }
                            let _e2462 = phi_3795_;
                            phi_3796_ = _e2462;
                        } else {
                            phi_3796_ = true;
                        }
                        let _e2464 = phi_3796_;
                        if _e2464 {
                            phi_3800_ = 1u;
                        } else {
                            phi_3800_ = 2u;
                        }
                        let _e2466 = phi_3800_;
                        phi_3801_ = _e2466;
                    }
                    let _e2468 = phi_3801_;
                    if (_e2468 == 2u) {
                        phi_3807_ = type_32(_e310, 2u);
                    } else {
                        phi_3807_ = _e2391;
                    }
                    let _e2472 = phi_3807_;
                    phi_3808_ = _e2472;
                    phi_3809_ = _e2454;
                    phi_3810_ = _e2433;
                    phi_3811_ = _e2412;
                } else {
                    phi_3808_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3809_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3810_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3811_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2474 = phi_3808_;
                let _e2476 = phi_3809_;
                let _e2478 = phi_3810_;
                let _e2480 = phi_3811_;
                if (_e2474.member_1 == 1u) {
                    let _e2491 = atomicAdd((&shared_[6u]), 1u);
                    phi_3832_ = array<u32, 2>(_e2491, 0u);
                } else {
                    if (_e2474.member_1 == 2u) {
                        let _e2486 = atomicAdd((&shared_[7u]), 1u);
                        phi_3831_ = array<u32, 2>(_e2486, 0u);
                    } else {
                        phi_3831_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2489 = phi_3831_;
                    phi_3832_ = _e2489;
                }
                let _e2494 = phi_3832_;
                if (_e2474.member_1 >= 2u) {
                    if (_e88.member_4 > 0u) {
                        let _e2498 = atomicAdd((&shared_[8u]), 1u);
                        phi_3844_ = array<u32, 2>(_e2494[0], _e2498);
                    } else {
                        phi_3844_ = _e2494;
                    }
                    let _e2502 = phi_3844_;
                    phi_3845_ = _e2502;
                } else {
                    phi_3845_ = _e2494;
                }
                let _e2504 = phi_3845_;
                if (_e2480.member_1 == 1u) {
                    let _e2514 = atomicAdd((&shared_[6u]), 1u);
                    phi_3863_ = array<u32, 2>(_e2514, 0u);
                } else {
                    if (_e2480.member_1 == 2u) {
                        let _e2509 = atomicAdd((&shared_[7u]), 1u);
                        phi_3862_ = array<u32, 2>(_e2509, 0u);
                    } else {
                        phi_3862_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2512 = phi_3862_;
                    phi_3863_ = _e2512;
                }
                let _e2517 = phi_3863_;
                if (_e2480.member_1 >= 2u) {
                    if (_e88.member_4 > 0u) {
                        let _e2521 = atomicAdd((&shared_[8u]), 1u);
                        phi_3875_ = array<u32, 2>(_e2517[0], _e2521);
                    } else {
                        phi_3875_ = _e2517;
                    }
                    let _e2525 = phi_3875_;
                    phi_3876_ = _e2525;
                } else {
                    phi_3876_ = _e2517;
                }
                let _e2527 = phi_3876_;
                if (_e2478.member_1 == 1u) {
                    let _e2537 = atomicAdd((&shared_[6u]), 1u);
                    phi_3894_ = array<u32, 2>(_e2537, 0u);
                } else {
                    if (_e2478.member_1 == 2u) {
                        let _e2532 = atomicAdd((&shared_[7u]), 1u);
                        phi_3893_ = array<u32, 2>(_e2532, 0u);
                    } else {
                        phi_3893_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2535 = phi_3893_;
                    phi_3894_ = _e2535;
                }
                let _e2540 = phi_3894_;
                if (_e2478.member_1 >= 2u) {
                    if (_e88.member_4 > 0u) {
                        let _e2544 = atomicAdd((&shared_[8u]), 1u);
                        phi_3906_ = array<u32, 2>(_e2540[0], _e2544);
                    } else {
                        phi_3906_ = _e2540;
                    }
                    let _e2548 = phi_3906_;
                    phi_3907_ = _e2548;
                } else {
                    phi_3907_ = _e2540;
                }
                let _e2550 = phi_3907_;
                if (_e2476.member_1 == 1u) {
                    let _e2560 = atomicAdd((&shared_[6u]), 1u);
                    phi_3925_ = array<u32, 2>(_e2560, 0u);
                } else {
                    if (_e2476.member_1 == 2u) {
                        let _e2555 = atomicAdd((&shared_[7u]), 1u);
                        phi_3924_ = array<u32, 2>(_e2555, 0u);
                    } else {
                        phi_3924_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2558 = phi_3924_;
                    phi_3925_ = _e2558;
                }
                let _e2563 = phi_3925_;
                if (_e2476.member_1 >= 2u) {
                    if (_e88.member_4 > 0u) {
                        let _e2567 = atomicAdd((&shared_[8u]), 1u);
                        phi_3937_ = array<u32, 2>(_e2563[0], _e2567);
                    } else {
                        phi_3937_ = _e2563;
                    }
                    let _e2571 = phi_3937_;
                    phi_3938_ = _e2571;
                } else {
                    phi_3938_ = _e2563;
                }
                let _e2573 = phi_3938_;
                workgroupBarrier();
                if (_e73 == 0u) {
                    let _e2576 = atomicLoad((&shared_[6u]));
                    let _e2578 = atomicLoad((&shared_[7u]));
                    let _e2580 = atomicLoad((&shared_[8u]));
                    let _e2582 = atomicLoad((&shared_[1u]));
                    let _e2584 = atomicLoad((&shared_[2u]));
                    let _e2586 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2586 + 1u));
                    let _e2590 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2590 + _e2582) + _e2584));
                    let _e2595 = atomicLoad((&shared_[0u]));
                    let _e2596 = (_e2595 - _e2582);
                    let _e2598 = (_e88.member_10 - _e2596);
                    if (_e2598 < _e2576) {
                        phi_3982_ = _e2598;
                    } else {
                        phi_3982_ = _e2576;
                    }
                    let _e2601 = phi_3982_;
                    atomicStore((&shared_[9u]), _e2596);
                    atomicStore((&shared_[10u]), _e2601);
                    atomicStore((&shared_[0u]), (_e2596 + _e2601));
                    if (_e2576 > _e2601) {
                        let _e2607 = (_e2576 - _e2601);
                        if (_e88.member_12 == 0u) {
                        } else {
                            let _e2611 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2614 = atomicAdd((&control.member[(_e90.member_1 + 1u)]), _e2607);
                        let _e2617 = atomicMax((&nodes.member[0u]), (_e2614 + _e2607));
                        if ((_e2614 + _e2607) < _e2614) {
                            let _e2621 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2614);
                    }
                    if (_e2578 > 0u) {
                        let _e2625 = atomicAdd((&pairs.member[0u]), _e2578);
                        if ((_e2625 + _e2578) < _e2625) {
                            let _e2629 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2625);
                    }
                    if (_e2580 > 0u) {
                        let _e2633 = atomicAdd((&control.member[1537u]), _e2580);
                        if ((_e2633 + _e2580) < _e2633) {
                            let _e2637 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2633);
                    }
                }
                workgroupBarrier();
                if (_e2474.member_1 == 1u) {
                    let _e2700 = atomicLoad((&shared_[10u]));
                    if (_e2504[0] < _e2700) {
                        let _e2720 = atomicLoad((&shared_[9u]));
                        let _e2723 = (2u * (_e2720 + _e2504[0]));
                        stack[_e2723] = _e2474.member[0];
                        stack[(_e2723 + 1u)] = _e2474.member[1];
                    } else {
                        let _e2704 = atomicLoad((&shared_[11u]));
                        let _e2707 = ((_e2704 + _e2504[0]) - _e2700);
                        if (_e2707 < _e88.member_3) {
                            let _e2710 = (_e101 + _e2707);
                            if (_e2710 < 4294967295u) {
                                let _e2714 = (2u * _e2710);
                                atomicStore((&nodes.member[(4u + _e2714)]), _e2474.member[0]);
                                atomicStore((&nodes.member[(_e2714 + 5u)]), _e2474.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2474.member_1 == 0u) {
                    } else {
                        if (_e2474.member_1 == 2u) {
                            let _e2648 = a.member[_e2474.member[0]];
                            let _e2652 = b.member[_e2474.member[1]];
                            let _e2656 = params.member.member_2.member;
                            if (_e2656 == 1u) {
                                if (_e2648.member_1 < _e2652.member_1) {
                                    phi_4167_ = type_9(_e2648.member_1, _e2652.member_1);
                                } else {
                                    phi_4167_ = type_9(_e2652.member_1, _e2648.member_1);
                                }
                                let _e2663 = phi_4167_;
                                phi_4172_ = _e2663;
                            } else {
                                phi_4172_ = type_9(_e2648.member_1, _e2652.member_1);
                            }
                            let _e2665 = phi_4172_;
                            let _e2669 = params.member.member_1;
                            let _e2672 = atomicLoad((&shared_[12u]));
                            let _e2674 = (_e2672 + _e2504[0]);
                            if (_e2674 < _e2669.member_3) {
                                let _e2676 = (2u * _e2674);
                                atomicStore((&pairs.member[(4u + _e2676)]), _e2665.member);
                                atomicStore((&pairs.member[(_e2676 + 5u)]), _e2665.member_1);
                            }
                        }
                        if (_e88.member_4 > 0u) {
                            let _e2684 = atomicLoad((&shared_[13u]));
                            let _e2686 = (_e2684 + _e2504[1]);
                            if (_e2686 < _e88.member_4) {
                                let _e2693 = (2u * ((_e88.member_5 * _e88.member_4) + _e2686));
                                front.member[_e2693] = _e2474.member[0];
                                front.member[(_e2693 + 1u)] = _e2474.member[1];
                            }
                        }
                    }
                }
                if (_e2480.member_1 == 1u) {
                    let _e2790 = atomicLoad((&shared_[10u]));
                    if (_e2527[0] < _e2790) {
                        let _e2810 = atomicLoad((&shared_[9u]));
                        let _e2813 = (2u * (_e2810 + _e2527[0]));
                        stack[_e2813] = _e2480.member[0];
                        stack[(_e2813 + 1u)] = _e2480.member[1];
                    } else {
                        let _e2794 = atomicLoad((&shared_[11u]));
                        let _e2797 = ((_e2794 + _e2527[0]) - _e2790);
                        if (_e2797 < _e88.member_3) {
                            let _e2800 = (_e101 + _e2797);
                            if (_e2800 < 4294967295u) {
                                let _e2804 = (2u * _e2800);
                                atomicStore((&nodes.member[(4u + _e2804)]), _e2480.member[0]);
                                atomicStore((&nodes.member[(_e2804 + 5u)]), _e2480.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2480.member_1 == 0u) {
                    } else {
                        if (_e2480.member_1 == 2u) {
                            let _e2738 = a.member[_e2480.member[0]];
                            let _e2742 = b.member[_e2480.member[1]];
                            let _e2746 = params.member.member_2.member;
                            if (_e2746 == 1u) {
                                if (_e2738.member_1 < _e2742.member_1) {
                                    phi_4330_ = type_9(_e2738.member_1, _e2742.member_1);
                                } else {
                                    phi_4330_ = type_9(_e2742.member_1, _e2738.member_1);
                                }
                                let _e2753 = phi_4330_;
                                phi_4335_ = _e2753;
                            } else {
                                phi_4335_ = type_9(_e2738.member_1, _e2742.member_1);
                            }
                            let _e2755 = phi_4335_;
                            let _e2759 = params.member.member_1;
                            let _e2762 = atomicLoad((&shared_[12u]));
                            let _e2764 = (_e2762 + _e2527[0]);
                            if (_e2764 < _e2759.member_3) {
                                let _e2766 = (2u * _e2764);
                                atomicStore((&pairs.member[(4u + _e2766)]), _e2755.member);
                                atomicStore((&pairs.member[(_e2766 + 5u)]), _e2755.member_1);
                            }
                        }
                        if (_e88.member_4 > 0u) {
                            let _e2774 = atomicLoad((&shared_[13u]));
                            let _e2776 = (_e2774 + _e2527[1]);
                            if (_e2776 < _e88.member_4) {
                                let _e2783 = (2u * ((_e88.member_5 * _e88.member_4) + _e2776));
                                front.member[_e2783] = _e2480.member[0];
                                front.member[(_e2783 + 1u)] = _e2480.member[1];
                            }
                        }
                    }
                }
                if (_e2478.member_1 == 1u) {
                    let _e2880 = atomicLoad((&shared_[10u]));
                    if (_e2550[0] < _e2880) {
                        let _e2900 = atomicLoad((&shared_[9u]));
                        let _e2903 = (2u * (_e2900 + _e2550[0]));
                        stack[_e2903] = _e2478.member[0];
                        stack[(_e2903 + 1u)] = _e2478.member[1];
                    } else {
                        let _e2884 = atomicLoad((&shared_[11u]));
                        let _e2887 = ((_e2884 + _e2550[0]) - _e2880);
                        if (_e2887 < _e88.member_3) {
                            let _e2890 = (_e101 + _e2887);
                            if (_e2890 < 4294967295u) {
                                let _e2894 = (2u * _e2890);
                                atomicStore((&nodes.member[(4u + _e2894)]), _e2478.member[0]);
                                atomicStore((&nodes.member[(_e2894 + 5u)]), _e2478.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2478.member_1 == 0u) {
                    } else {
                        if (_e2478.member_1 == 2u) {
                            let _e2828 = a.member[_e2478.member[0]];
                            let _e2832 = b.member[_e2478.member[1]];
                            let _e2836 = params.member.member_2.member;
                            if (_e2836 == 1u) {
                                if (_e2828.member_1 < _e2832.member_1) {
                                    phi_4493_ = type_9(_e2828.member_1, _e2832.member_1);
                                } else {
                                    phi_4493_ = type_9(_e2832.member_1, _e2828.member_1);
                                }
                                let _e2843 = phi_4493_;
                                phi_4498_ = _e2843;
                            } else {
                                phi_4498_ = type_9(_e2828.member_1, _e2832.member_1);
                            }
                            let _e2845 = phi_4498_;
                            let _e2849 = params.member.member_1;
                            let _e2852 = atomicLoad((&shared_[12u]));
                            let _e2854 = (_e2852 + _e2550[0]);
                            if (_e2854 < _e2849.member_3) {
                                let _e2856 = (2u * _e2854);
                                atomicStore((&pairs.member[(4u + _e2856)]), _e2845.member);
                                atomicStore((&pairs.member[(_e2856 + 5u)]), _e2845.member_1);
                            }
                        }
                        if (_e88.member_4 > 0u) {
                            let _e2864 = atomicLoad((&shared_[13u]));
                            let _e2866 = (_e2864 + _e2550[1]);
                            if (_e2866 < _e88.member_4) {
                                let _e2873 = (2u * ((_e88.member_5 * _e88.member_4) + _e2866));
                                front.member[_e2873] = _e2478.member[0];
                                front.member[(_e2873 + 1u)] = _e2478.member[1];
                            }
                        }
                    }
                }
                if (_e2476.member_1 == 1u) {
                    let _e2970 = atomicLoad((&shared_[10u]));
                    if (_e2573[0] < _e2970) {
                        let _e2990 = atomicLoad((&shared_[9u]));
                        let _e2993 = (2u * (_e2990 + _e2573[0]));
                        stack[_e2993] = _e2476.member[0];
                        stack[(_e2993 + 1u)] = _e2476.member[1];
                    } else {
                        let _e2974 = atomicLoad((&shared_[11u]));
                        let _e2977 = ((_e2974 + _e2573[0]) - _e2970);
                        if (_e2977 < _e88.member_3) {
                            let _e2980 = (_e101 + _e2977);
                            if (_e2980 < 4294967295u) {
                                let _e2984 = (2u * _e2980);
                                atomicStore((&nodes.member[(4u + _e2984)]), _e2476.member[0]);
                                atomicStore((&nodes.member[(_e2984 + 5u)]), _e2476.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2476.member_1 == 0u) {
                    } else {
                        if (_e2476.member_1 == 2u) {
                            let _e2918 = a.member[_e2476.member[0]];
                            let _e2922 = b.member[_e2476.member[1]];
                            let _e2926 = params.member.member_2.member;
                            if (_e2926 == 1u) {
                                if (_e2918.member_1 < _e2922.member_1) {
                                    phi_4656_ = type_9(_e2918.member_1, _e2922.member_1);
                                } else {
                                    phi_4656_ = type_9(_e2922.member_1, _e2918.member_1);
                                }
                                let _e2933 = phi_4656_;
                                phi_4661_ = _e2933;
                            } else {
                                phi_4661_ = type_9(_e2918.member_1, _e2922.member_1);
                            }
                            let _e2935 = phi_4661_;
                            let _e2939 = params.member.member_1;
                            let _e2942 = atomicLoad((&shared_[12u]));
                            let _e2944 = (_e2942 + _e2573[0]);
                            if (_e2944 < _e2939.member_3) {
                                let _e2946 = (2u * _e2944);
                                atomicStore((&pairs.member[(4u + _e2946)]), _e2935.member);
                                atomicStore((&pairs.member[(_e2946 + 5u)]), _e2935.member_1);
                            }
                        }
                        if (_e88.member_4 > 0u) {
                            let _e2954 = atomicLoad((&shared_[13u]));
                            let _e2956 = (_e2954 + _e2573[1]);
                            if (_e2956 < _e88.member_4) {
                                let _e2963 = (2u * ((_e88.member_5 * _e88.member_4) + _e2956));
                                front.member[_e2963] = _e2476.member[0];
                                front.member[(_e2963 + 1u)] = _e2476.member[1];
                            }
                        }
                    }
                }
                phi_4714_ = true;
            }
            let _e3000 = phi_4714_;
            phi_4715_ = _e3000;
        } else {
            phi_4715_ = false;
        }
        let _e3002 = phi_4715_;
        continue;
        continuing {
            phi_246_ = _e122;
            break if !(_e3002);
        }
    }
    if (_e73 == 0u) {
        if (_e88.member_6 == 0u) {
            if (_e86 < _e98) {
                phi_4738_ = ((((_e98 - 1u) - _e86) >> bitcast<u32>((_e88.member_7 & 31u))) + 1u);
            } else {
                phi_4738_ = 0u;
            }
            let _e3016 = phi_4738_;
            let _e3018 = atomicLoad((&shared_[5u]));
            phi_4743_ = (_e3016 - _e3018);
        } else {
            phi_4743_ = 0u;
        }
        let _e3021 = phi_4743_;
        atomicStore((&shared_[14u]), _e3021);
        let _e3024 = atomicLoad((&shared_[0u]));
        let _e3025 = (_e3024 + _e3021);
        if (_e88.member_6 == 2u) {
            let _e3052 = (((_e98 + (1u << bitcast<u32>((_e88.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e88.member_7 & 31u)));
            let _e3053 = (_e86 * _e3052);
            if (_e98 < _e3053) {
                phi_4769_ = _e98;
            } else {
                phi_4769_ = _e3053;
            }
            let _e3056 = phi_4769_;
            let _e3057 = (_e98 - _e3056);
            if (_e3057 < _e3052) {
                phi_4775_ = _e3057;
            } else {
                phi_4775_ = _e3052;
            }
            let _e3060 = phi_4775_;
            let _e3067 = ((1540u + (2u * (1u << bitcast<u32>((_e88.member_7 & 31u))))) + (2u * _e86));
            let _e3069 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e3067]), _e3069);
            let _e3073 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e3067 + 1u)]), (_e3060 - _e3073));
        } else {
            if (_e3025 > 0u) {
                if (_e88.member_12 == 0u) {
                } else {
                    let _e3032 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e3035 = atomicAdd((&control.member[(_e90.member_1 + 1u)]), _e3025);
                let _e3038 = atomicMax((&nodes.member[0u]), (_e3035 + _e3025));
                if ((_e3035 + _e3025) < _e3035) {
                    let _e3042 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e3035);
            }
        }
        let _e3079 = atomicLoad((&shared_[15u]));
        let _e3081 = atomicAdd((&control.member[(1540u + (2u * _e86))]), _e3079);
        let _e3085 = atomicLoad((&shared_[16u]));
        let _e3087 = atomicAdd((&control.member[((2u * _e86) + 1541u)]), _e3085);
    }
    workgroupBarrier();
    let _e3089 = atomicLoad((&shared_[0u]));
    let _e3091 = atomicLoad((&shared_[17u]));
    let _e3093 = atomicLoad((&shared_[14u]));
    phi_4863_ = type_9(0u, 8u);
    loop {
        let _e3095 = phi_4863_;
        if (_e3095.member < _e3095.member_1) {
            phi_4864_ = type_9((_e3095.member + 1u), _e3095.member_1);
            phi_4887_ = type_9(1u, _e3095.member);
        } else {
            phi_4864_ = _e3095;
            phi_4887_ = type_9(0u, type_9().member_1);
        }
        let _e3107 = phi_4864_;
        let _e3109 = phi_4887_;
        let _e3113 = (bitcast<i32>(_e3109.member) != 0i);
        if _e3113 {
            let _e3115 = ((_e3109.member_1 * 128u) + _e73);
            if (_e3115 < _e3089) {
                let _e3119 = stack[(2u * _e3115)];
                let _e3123 = stack[((2u * _e3115) + 1u)];
                if (_e88.member_6 == 2u) {
                    let _e3155 = ((((((1540u + (2u * (1u << bitcast<u32>((_e88.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e88.member_7 & 31u))))) + (1u << bitcast<u32>((_e88.member_7 & 31u)))) + 1u) + (_e86 * 2048u)) + (2u * _e3115));
                    atomicStore((&control.member[_e3155]), _e3119);
                    atomicStore((&control.member[(_e3155 + 1u)]), _e3123);
                } else {
                    let _e3126 = (_e3091 + _e3115);
                    if (_e3126 < _e88.member_3) {
                        let _e3129 = (_e101 + _e3126);
                        if (_e3129 < 4294967295u) {
                            let _e3131 = (2u * _e3129);
                            atomicStore((&nodes.member[(4u + _e3131)]), _e3119);
                            atomicStore((&nodes.member[(_e3131 + 5u)]), _e3123);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4863_ = _e3107;
            break if !(_e3113);
        }
    }
    let _e3161 = atomicLoad((&shared_[5u]));
    let _e3162 = (_e3093 / 128u);
    if ((_e3093 % 128u) > 0u) {
        phi_4978_ = (_e3162 + 1u);
    } else {
        phi_4978_ = _e3162;
    }
    let _e3167 = phi_4978_;
    phi_4981_ = type_9(0u, _e3167);
    loop {
        let _e3170 = phi_4981_;
        if (_e3170.member < _e3170.member_1) {
            phi_4982_ = type_9((_e3170.member + 1u), _e3170.member_1);
            phi_5005_ = type_9(1u, _e3170.member);
        } else {
            phi_4982_ = _e3170;
            phi_5005_ = type_9(0u, type_9().member_1);
        }
        let _e3182 = phi_4982_;
        let _e3184 = phi_5005_;
        let _e3188 = (bitcast<i32>(_e3184.member) != 0i);
        if _e3188 {
            let _e3190 = ((_e3184.member_1 * 128u) + _e73);
            if (_e3190 < _e3093) {
                let _e3199 = (2u * ((_e99 + _e86) + ((_e3161 + _e3190) << bitcast<u32>((_e88.member_7 & 31u)))));
                let _e3202 = atomicLoad((&nodes.member[(4u + _e3199)]));
                let _e3205 = atomicLoad((&nodes.member[(_e3199 + 5u)]));
                let _e3207 = ((_e3091 + _e3089) + _e3190);
                if (_e3207 < _e88.member_3) {
                    let _e3210 = (_e101 + _e3207);
                    if (_e3210 < 4294967295u) {
                        let _e3212 = (2u * _e3210);
                        atomicStore((&nodes.member[(4u + _e3212)]), _e3202);
                        atomicStore((&nodes.member[(_e3212 + 5u)]), _e3205);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4981_ = _e3182;
            break if !(_e3188);
        }
    }
    if (_e88.member_6 == 1u) {
        if (_e3161 == 0u) {
            phi_5086_ = type_9(0u, _e98);
            loop {
                let _e3223 = phi_5086_;
                if (_e3223.member < _e3223.member_1) {
                    phi_5087_ = type_9((_e3223.member + 1u), _e3223.member_1);
                    phi_5110_ = type_9(1u, _e3223.member);
                } else {
                    phi_5087_ = _e3223;
                    phi_5110_ = type_9(0u, type_9().member_1);
                }
                let _e3235 = phi_5087_;
                let _e3237 = phi_5110_;
                if (bitcast<i32>(_e3237.member) != 0i) {
                    let _e3243 = atomicAdd((&control.member[(512u + _e90.member_1)]), 1u);
                    if (_e3243 >= _e98) {
                        phi_5202_ = false;
                    } else {
                        let _e3246 = (2u * (_e99 + _e3243));
                        let _e3249 = atomicLoad((&nodes.member[(4u + _e3246)]));
                        let _e3252 = atomicLoad((&nodes.member[(_e3246 + 5u)]));
                        if (_e88.member_12 == 0u) {
                        } else {
                            let _e3256 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3259 = atomicAdd((&control.member[(_e90.member_1 + 1u)]), 1u);
                        let _e3262 = atomicMax((&nodes.member[0u]), (_e3259 + 1u));
                        if ((_e3259 + 1u) < _e3259) {
                            let _e3266 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3259 < _e88.member_3) {
                            let _e3269 = (_e101 + _e3259);
                            if (_e3269 < 4294967295u) {
                                let _e3271 = (2u * _e3269);
                                atomicStore((&nodes.member[(4u + _e3271)]), _e3249);
                                atomicStore((&nodes.member[(_e3271 + 5u)]), _e3252);
                            }
                        }
                        phi_5202_ = true;
                    }
                    let _e3277 = phi_5202_;
                    phi_5203_ = _e3277;
                } else {
                    phi_5203_ = false;
                }
                let _e3279 = phi_5203_;
                continue;
                continuing {
                    phi_5086_ = _e3235;
                    break if !(_e3279);
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
