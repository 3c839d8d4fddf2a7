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

struct type_12 {
    member: u32,
    member_1: u32,
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

struct type_19 {
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

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_24 {
    member: array<u32, 2>,
    member_1: u32,
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

struct type_34 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> a_nodes: type_18;
@group(0) @binding(2) 
var<storage> b_nodes: type_18;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_34;
@group(0) @binding(4) 
var<storage, read_write> control: type_34;
var<workgroup> shared_: array<atomic<u32>, 18>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> oriented: type_30;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_34;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<u32, 2>, 4>;
    var phi_184_: u32;
    var phi_197_: array<u32, 2>;
    var phi_237_: u32;
    var phi_249_: type_12;
    var phi_250_: type_12;
    var phi_273_: type_12;
    var phi_291_: u32;
    var phi_321_: bool;
    var phi_325_: u32;
    var phi_326_: u32;
    var phi_327_: u32;
    var phi_381_: u32;
    var phi_386_: u32;
    var phi_391_: u32;
    var phi_400_: u32;
    var phi_406_: u32;
    var phi_412_: u32;
    var phi_353_: u32;
    var phi_359_: u32;
    var phi_413_: u32;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_434_: u32;
    var phi_435_: u32;
    var phi_504_: array<u32, 2>;
    var phi_505_: array<u32, 2>;
    var phi_577_: array<u32, 2>;
    var phi_613_: array<u32, 2>;
    var phi_623_: array<u32, 2>;
    var phi_625_: array<array<u32, 2>, 4>;
    var phi_626_: array<array<u32, 2>, 4>;
    var phi_627_: bool;
    var phi_628_: array<array<u32, 2>, 4>;
    var phi_629_: bool;
    var phi_641_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_662_: bool;
    var phi_667_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_717_: bool;
    var phi_726_: bool;
    var phi_731_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_779_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_898_: array<u32, 2>;
    var phi_928_: array<u32, 2>;
    var phi_958_: array<u32, 2>;
    var phi_988_: array<u32, 2>;
    var phi_990_: array<array<u32, 2>, 4>;
    var phi_991_: bool;
    var phi_992_: array<array<u32, 2>, 4>;
    var phi_993_: bool;
    var phi_1152_: array<u32, 2>;
    var phi_1184_: array<u32, 2>;
    var phi_1059_: array<u32, 2>;
    var phi_1091_: array<u32, 2>;
    var phi_1186_: array<array<u32, 2>, 4>;
    var phi_1187_: array<array<u32, 2>, 4>;
    var phi_1188_: array<array<u32, 2>, 4>;
    var phi_1189_: bool;
    var phi_1190_: array<array<u32, 2>, 4>;
    var phi_1191_: bool;
    var phi_1195_: array<array<u32, 2>, 4>;
    var phi_1196_: array<array<u32, 2>, 4>;
    var phi_1197_: bool;
    var phi_1201_: array<array<u32, 2>, 4>;
    var phi_1221_: type_12;
    var phi_1222_: type_12;
    var phi_1245_: type_12;
    var phi_1274_: bool;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1360_: f32;
    var phi_1366_: f32;
    var phi_1372_: f32;
    var phi_1378_: f32;
    var phi_1384_: f32;
    var phi_1390_: f32;
    var phi_1408_: f32;
    var phi_1413_: f32;
    var phi_1418_: f32;
    var phi_1434_: type_31;
    var phi_1504_: f32;
    var phi_1510_: f32;
    var phi_1516_: f32;
    var phi_1522_: f32;
    var phi_1528_: f32;
    var phi_1534_: f32;
    var phi_1552_: f32;
    var phi_1557_: f32;
    var phi_1562_: f32;
    var phi_1578_: type_31;
    var phi_1768_: f32;
    var phi_1774_: f32;
    var phi_1781_: f32;
    var phi_1790_: f32;
    var phi_1797_: f32;
    var phi_1805_: f32;
    var phi_1814_: f32;
    var phi_1821_: f32;
    var phi_1829_: f32;
    var phi_1922_: f32;
    var phi_1929_: f32;
    var phi_1935_: f32;
    var phi_1941_: f32;
    var phi_1960_: f32;
    var phi_1967_: f32;
    var phi_1973_: f32;
    var phi_1979_: f32;
    var phi_1998_: f32;
    var phi_2005_: f32;
    var phi_2011_: f32;
    var phi_2017_: f32;
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
    var phi_2146_: f32;
    var phi_2151_: f32;
    var phi_2156_: f32;
    var phi_2161_: f32;
    var phi_2166_: f32;
    var phi_2225_: f32;
    var phi_2248_: f32;
    var phi_2271_: f32;
    var phi_2293_: f32;
    var phi_2309_: f32;
    var phi_2364_: f32;
    var phi_2387_: f32;
    var phi_2410_: f32;
    var phi_2432_: f32;
    var phi_2448_: f32;
    var phi_2503_: f32;
    var phi_2526_: f32;
    var phi_2549_: f32;
    var phi_2571_: f32;
    var phi_2587_: f32;
    var phi_2642_: f32;
    var phi_2665_: f32;
    var phi_2689_: f32;
    var phi_2712_: f32;
    var phi_2728_: f32;
    var phi_2783_: f32;
    var phi_2806_: f32;
    var phi_2830_: f32;
    var phi_2853_: f32;
    var phi_2869_: f32;
    var phi_2924_: f32;
    var phi_2947_: f32;
    var phi_2971_: f32;
    var phi_2994_: f32;
    var phi_3010_: f32;
    var phi_3065_: f32;
    var phi_3088_: f32;
    var phi_3112_: f32;
    var phi_3135_: f32;
    var phi_3151_: f32;
    var phi_3206_: f32;
    var phi_3229_: f32;
    var phi_3253_: f32;
    var phi_3276_: f32;
    var phi_3292_: f32;
    var phi_3347_: f32;
    var phi_3370_: f32;
    var phi_3394_: f32;
    var phi_3417_: f32;
    var phi_3433_: f32;
    var phi_3440_: f32;
    var phi_3445_: f32;
    var phi_3450_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3479_: bool;
    var phi_3481_: bool;
    var phi_3482_: bool;
    var phi_3483_: bool;
    var phi_3484_: bool;
    var phi_3488_: bool;
    var phi_3574_: array<u32, 2>;
    var phi_3596_: array<u32, 2>;
    var phi_3598_: array<array<u32, 2>, 4>;
    var phi_3599_: array<array<u32, 2>, 4>;
    var phi_3600_: bool;
    var phi_3601_: array<array<u32, 2>, 4>;
    var phi_3602_: bool;
    var phi_3614_: bool;
    var phi_3622_: bool;
    var phi_3623_: bool;
    var phi_3635_: bool;
    var phi_3640_: bool;
    var phi_3681_: bool;
    var phi_3682_: bool;
    var phi_3683_: bool;
    var phi_3684_: bool;
    var phi_3688_: bool;
    var phi_3690_: bool;
    var phi_3699_: bool;
    var phi_3704_: bool;
    var phi_3745_: bool;
    var phi_3746_: bool;
    var phi_3747_: bool;
    var phi_3748_: bool;
    var phi_3752_: bool;
    var phi_3762_: bool;
    var phi_3763_: bool;
    var phi_3775_: bool;
    var phi_3776_: bool;
    var phi_3799_: array<array<u32, 2>, 4>;
    var phi_3800_: bool;
    var phi_3801_: array<array<u32, 2>, 4>;
    var phi_3802_: bool;
    var phi_3819_: array<array<u32, 2>, 4>;
    var phi_3820_: array<array<u32, 2>, 4>;
    var phi_3821_: array<array<u32, 2>, 4>;
    var phi_3822_: bool;
    var phi_3823_: array<array<u32, 2>, 4>;
    var phi_3824_: bool;
    var phi_3828_: array<array<u32, 2>, 4>;
    var phi_3829_: array<array<u32, 2>, 4>;
    var phi_3830_: bool;
    var phi_3834_: array<array<u32, 2>, 4>;
    var phi_3835_: array<array<u32, 2>, 4>;
    var phi_3853_: bool;
    var phi_3854_: bool;
    var phi_3858_: u32;
    var phi_3859_: u32;
    var phi_3871_: type_24;
    var phi_3872_: type_24;
    var phi_3890_: bool;
    var phi_3891_: bool;
    var phi_3895_: u32;
    var phi_3896_: u32;
    var phi_3908_: type_24;
    var phi_3909_: type_24;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3932_: u32;
    var phi_3933_: u32;
    var phi_3945_: type_24;
    var phi_3946_: type_24;
    var phi_3964_: bool;
    var phi_3965_: bool;
    var phi_3969_: u32;
    var phi_3970_: u32;
    var phi_3982_: type_24;
    var phi_3983_: type_24;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var phi_4004_: u32;
    var phi_4005_: u32;
    var phi_4011_: type_24;
    var phi_4012_: type_24;
    var phi_4013_: type_24;
    var phi_4014_: type_24;
    var phi_4015_: type_24;
    var phi_4033_: array<u32, 2>;
    var phi_4034_: array<u32, 2>;
    var phi_4046_: array<u32, 2>;
    var phi_4047_: array<u32, 2>;
    var phi_4064_: array<u32, 2>;
    var phi_4065_: array<u32, 2>;
    var phi_4077_: array<u32, 2>;
    var phi_4078_: array<u32, 2>;
    var phi_4095_: array<u32, 2>;
    var phi_4096_: array<u32, 2>;
    var phi_4108_: array<u32, 2>;
    var phi_4109_: array<u32, 2>;
    var phi_4126_: array<u32, 2>;
    var phi_4127_: array<u32, 2>;
    var phi_4139_: array<u32, 2>;
    var phi_4140_: array<u32, 2>;
    var phi_4173_: u32;
    var phi_4335_: type_12;
    var phi_4340_: type_12;
    var phi_4487_: type_12;
    var phi_4492_: type_12;
    var phi_4639_: type_12;
    var phi_4644_: type_12;
    var phi_4791_: type_12;
    var phi_4796_: type_12;
    var phi_4849_: bool;
    var phi_4850_: bool;
    var phi_4869_: u32;
    var phi_4873_: u32;
    var phi_4930_: type_12;
    var phi_4931_: type_12;
    var phi_4954_: type_12;
    var phi_5010_: u32;
    var phi_5013_: type_12;
    var phi_5014_: type_12;
    var phi_5037_: type_12;
    var phi_5109_: type_12;
    var phi_5110_: type_12;
    var phi_5133_: type_12;
    var phi_5213_: bool;
    var phi_5214_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e70 = id_2;
    let _e71 = n_2;
    let _e72 = lane_2;
    let _e82 = params.member.member_2;
    let _e87 = ((_e70.y * _e71.x) + _e70.x);
    let _e90 = params.member.member_1.member_1;
    let _e93 = params.member.member_2.member_3;
    let _e94 = (_e90 % 2u);
    let _e97 = params.member.member_2.member_7;
    let _e99 = atomicLoad((&control.member[_e90]));
    if (_e93 < _e99) {
        phi_184_ = _e93;
    } else {
        phi_184_ = _e99;
    }
    let _e102 = phi_184_;
    let _e103 = (_e94 * _e93);
    let _e105 = ((1u - _e94) * _e93);
    let _e107 = (_e82.member == 1u);
    if (_e82.member == 0u) {
        phi_197_ = array<u32, 2>(0u, 2u);
    } else {
        phi_197_ = array<u32, 2>(1u, 1u);
    }
    let _e111 = phi_197_;
    let _e117 = params.member.member.member[_e111[0]];
    let _e118 = (_e117 - 1u);
    let _e122 = params.member.member.member[_e111[1]];
    let _e123 = (_e122 - 1u);
    let _e127 = params.member.member.member_2[_e111[0]];
    let _e131 = params.member.member.member_2[_e111[1]];
    if (_e82.member_1 == 0u) {
        phi_237_ = 1u;
    } else {
        phi_237_ = 0u;
    }
    let _e135 = phi_237_;
    if (_e72 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_249_ = type_12(0u, _e82.member_11);
    loop {
        let _e144 = phi_249_;
        if (_e144.member < _e144.member_1) {
            phi_250_ = type_12((_e144.member + 1u), _e144.member_1);
            phi_273_ = type_12(1u, _e144.member);
        } else {
            phi_250_ = _e144;
            phi_273_ = type_12(0u, type_12().member_1);
        }
        let _e156 = phi_250_;
        let _e158 = phi_273_;
        if (bitcast<i32>(_e158.member) != 0i) {
            if (_e72 == 0u) {
                let _e165 = atomicLoad((&shared_[0u]));
                if (128u < _e165) {
                    phi_291_ = 128u;
                } else {
                    phi_291_ = _e165;
                }
                let _e168 = phi_291_;
                if (_e82.member_9 > 0u) {
                    if (_e158.member_1 >= 16u) {
                        let _e174 = atomicLoad((&control.member[(1024u + _e90)]));
                        if (_e82.member_9 > 0u) {
                            phi_321_ = ((_e174 * 100u) >= (_e82.member_9 << bitcast<u32>((_e97 & 31u))));
                        } else {
                            phi_321_ = false;
                        }
                        let _e183 = phi_321_;
                        if _e183 {
                            phi_325_ = 2u;
                        } else {
                            phi_325_ = 0u;
                        }
                        let _e185 = phi_325_;
                        phi_326_ = _e185;
                    } else {
                        phi_326_ = 0u;
                    }
                    let _e187 = phi_326_;
                    phi_327_ = _e187;
                } else {
                    phi_327_ = 0u;
                }
                let _e189 = phi_327_;
                let _e190 = (128u - _e168);
                if (_e189 == 0u) {
                    if (_e190 > 0u) {
                        let _e194 = atomicLoad((&shared_[5u]));
                        if (_e82.member_6 == 0u) {
                            if (_e87 < _e102) {
                                phi_353_ = ((((_e102 - 1u) - _e87) >> bitcast<u32>((_e97 & 31u))) + 1u);
                            } else {
                                phi_353_ = 0u;
                            }
                            let _e237 = phi_353_;
                            let _e238 = (_e237 - _e194);
                            if (_e190 < _e238) {
                                phi_359_ = _e190;
                            } else {
                                phi_359_ = _e238;
                            }
                            let _e241 = phi_359_;
                            atomicStore((&shared_[3u]), (_e87 + (_e194 << bitcast<u32>((_e97 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e97 & 31u))));
                            atomicStore((&shared_[5u]), (_e194 + _e241));
                            phi_413_ = _e241;
                        } else {
                            if (_e194 == 0u) {
                                let _e202 = (_e102 >> bitcast<u32>(((_e97 + 2u) & 31u)));
                                if (_e82.member_8 < _e202) {
                                    phi_381_ = _e202;
                                } else {
                                    phi_381_ = _e82.member_8;
                                }
                                let _e205 = phi_381_;
                                if (128u < _e205) {
                                    phi_386_ = 128u;
                                } else {
                                    phi_386_ = _e205;
                                }
                                let _e208 = phi_386_;
                                if (_e190 < _e208) {
                                    phi_391_ = _e190;
                                } else {
                                    phi_391_ = _e208;
                                }
                                let _e211 = phi_391_;
                                let _e214 = atomicAdd((&control.member[(512u + _e90)]), _e211);
                                if (_e102 < _e214) {
                                    phi_400_ = _e102;
                                } else {
                                    phi_400_ = _e214;
                                }
                                let _e217 = phi_400_;
                                let _e218 = (_e102 - _e217);
                                if (_e211 < _e218) {
                                    phi_406_ = _e211;
                                } else {
                                    phi_406_ = _e218;
                                }
                                let _e221 = phi_406_;
                                atomicStore((&shared_[3u]), _e214);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e221 < _e211)));
                                phi_412_ = _e221;
                            } else {
                                phi_412_ = 0u;
                            }
                            let _e228 = phi_412_;
                            phi_413_ = _e228;
                        }
                        let _e254 = phi_413_;
                        phi_414_ = _e254;
                    } else {
                        phi_414_ = 0u;
                    }
                    let _e256 = phi_414_;
                    phi_415_ = _e256;
                } else {
                    phi_415_ = 0u;
                }
                let _e258 = phi_415_;
                if (_e189 == 0u) {
                    if ((_e168 + _e258) == 0u) {
                        if (_e82.member_9 > 0u) {
                            let _e266 = atomicAdd((&control.member[(1024u + _e90)]), 1u);
                        }
                        phi_434_ = 1u;
                    } else {
                        phi_434_ = _e189;
                    }
                    let _e268 = phi_434_;
                    phi_435_ = _e268;
                } else {
                    phi_435_ = _e189;
                }
                let _e270 = phi_435_;
                atomicStore((&shared_[1u]), _e168);
                atomicStore((&shared_[2u]), _e258);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e270;
            }
            let _e278 = workgroupUniformLoad((&state[0u]));
            if (_e278 != 0u) {
                phi_4849_ = false;
            } else {
                let _e281 = atomicLoad((&shared_[1u]));
                let _e283 = atomicLoad((&shared_[2u]));
                if (_e72 < _e281) {
                    let _e306 = atomicLoad((&shared_[0u]));
                    let _e309 = (2u * ((_e306 - 1u) - _e72));
                    let _e311 = stack[_e309];
                    let _e314 = stack[(_e309 + 1u)];
                    phi_505_ = array<u32, 2>(_e311, _e314);
                } else {
                    if (_e72 < (_e281 + _e283)) {
                        let _e288 = atomicLoad((&shared_[3u]));
                        let _e291 = atomicLoad((&shared_[4u]));
                        let _e295 = (2u * (_e103 + (_e288 + ((_e72 - _e281) * _e291))));
                        let _e298 = atomicLoad((&nodes.member[(4u + _e295)]));
                        let _e301 = atomicLoad((&nodes.member[(_e295 + 5u)]));
                        phi_504_ = array<u32, 2>(_e298, _e301);
                    } else {
                        phi_504_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e304 = phi_504_;
                    phi_505_ = _e304;
                }
                let _e317 = phi_505_;
                if (_e317[0] != 4294967295u) {
                    let _e323 = a_nodes.member[_e317[0]];
                    let _e325 = b_nodes.member[_e317[1]];
                    if _e107 {
                        if (_e317[0] == _e317[1]) {
                            if (_e323.member_3 == 4294967295u) {
                                phi_625_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            } else {
                                let _e331 = a_nodes.member[_e323.member_1];
                                let _e334 = a_nodes.member[_e323.member_3];
                                if !((_e331.member_3 == 4294967295u)) {
                                    phi_577_ = array<u32, 2>(_e323.member_1, _e323.member_1);
                                } else {
                                    phi_577_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e342 = phi_577_;
                                if ((((((_e331.member[0] <= _e334.member_2[0]) && (_e334.member[0] <= _e331.member_2[0])) && (_e331.member[1] <= _e334.member_2[1])) && (_e334.member[1] <= _e331.member_2[1])) && (_e331.member[2] <= _e334.member_2[2])) && (_e334.member[2] <= _e331.member_2[2])) {
                                    phi_613_ = array<u32, 2>(_e323.member_1, _e323.member_3);
                                } else {
                                    phi_613_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e374 = phi_613_;
                                if !((_e334.member_3 == 4294967295u)) {
                                    phi_623_ = array<u32, 2>(_e323.member_3, _e323.member_3);
                                } else {
                                    phi_623_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e382 = phi_623_;
                                phi_625_ = array<array<u32, 2>, 4>(_e342, _e374, _e382, array<u32, 2>(4294967295u, 4294967295u));
                            }
                            let _e385 = phi_625_;
                            phi_626_ = _e385;
                            phi_627_ = false;
                        } else {
                            phi_626_ = array<array<u32, 2>, 4>();
                            phi_627_ = true;
                        }
                        let _e387 = phi_626_;
                        let _e389 = phi_627_;
                        phi_628_ = _e387;
                        phi_629_ = _e389;
                    } else {
                        phi_628_ = array<array<u32, 2>, 4>();
                        phi_629_ = true;
                    }
                    let _e391 = phi_628_;
                    let _e393 = phi_629_;
                    if _e393 {
                        if (_e323.member_3 == 4294967295u) {
                            phi_641_ = false;
                        } else {
                            phi_641_ = !((_e325.member_3 == 4294967295u));
                        }
                        let _e400 = phi_641_;
                        if _e400 {
                            if (_e135 == 1u) {
                                phi_649_ = false;
                            } else {
                                phi_649_ = true;
                            }
                            let _e403 = phi_649_;
                            phi_650_ = _e403;
                        } else {
                            phi_650_ = true;
                        }
                        let _e405 = phi_650_;
                        if _e405 {
                            if (_e323.member_3 == 4294967295u) {
                                phi_662_ = false;
                            } else {
                                phi_662_ = !((_e325.member_3 == 4294967295u));
                            }
                            let _e412 = phi_662_;
                            if _e412 {
                                phi_667_ = (_e135 == 1u);
                            } else {
                                phi_667_ = false;
                            }
                            let _e415 = phi_667_;
                            if _e415 {
                                phi_710_ = bool();
                                phi_711_ = true;
                            } else {
                                let _e417 = (_e323.member_3 == 4294967295u);
                                if _e417 {
                                    phi_709_ = bool();
                                } else {
                                    if _e412 {
                                        phi_708_ = ((((_e325.member_2[0] - _e325.member[0]) * (_e325.member_2[1] - _e325.member[1])) * (_e325.member_2[2] - _e325.member[2])) > (((_e323.member_2[0] - _e323.member[0]) * (_e323.member_2[1] - _e323.member[1])) * (_e323.member_2[2] - _e323.member[2])));
                                    } else {
                                        phi_708_ = false;
                                    }
                                    let _e446 = phi_708_;
                                    phi_709_ = _e446;
                                }
                                let _e448 = phi_709_;
                                phi_710_ = _e448;
                                phi_711_ = _e417;
                            }
                            let _e450 = phi_710_;
                            let _e452 = phi_711_;
                            if _e452 {
                                phi_715_ = true;
                            } else {
                                phi_715_ = _e450;
                            }
                            let _e454 = phi_715_;
                            phi_717_ = !(_e454);
                        } else {
                            phi_717_ = true;
                        }
                        let _e457 = phi_717_;
                        if (_e323.member_3 == 4294967295u) {
                            phi_726_ = false;
                        } else {
                            phi_726_ = !((_e325.member_3 == 4294967295u));
                        }
                        let _e464 = phi_726_;
                        if _e464 {
                            phi_731_ = (_e135 == 1u);
                        } else {
                            phi_731_ = false;
                        }
                        let _e467 = phi_731_;
                        if _e467 {
                            phi_774_ = bool();
                            phi_775_ = true;
                        } else {
                            let _e469 = (_e323.member_3 == 4294967295u);
                            if _e469 {
                                phi_773_ = bool();
                            } else {
                                if _e464 {
                                    phi_772_ = ((((_e325.member_2[0] - _e325.member[0]) * (_e325.member_2[1] - _e325.member[1])) * (_e325.member_2[2] - _e325.member[2])) > (((_e323.member_2[0] - _e323.member[0]) * (_e323.member_2[1] - _e323.member[1])) * (_e323.member_2[2] - _e323.member[2])));
                                } else {
                                    phi_772_ = false;
                                }
                                let _e498 = phi_772_;
                                phi_773_ = _e498;
                            }
                            let _e500 = phi_773_;
                            phi_774_ = _e500;
                            phi_775_ = _e469;
                        }
                        let _e502 = phi_774_;
                        let _e504 = phi_775_;
                        if _e504 {
                            phi_779_ = true;
                        } else {
                            phi_779_ = _e502;
                        }
                        let _e506 = phi_779_;
                        if _e457 {
                            if (_e323.member_3 == 4294967295u) {
                                phi_789_ = false;
                            } else {
                                phi_789_ = true;
                            }
                            let _e510 = phi_789_;
                            phi_790_ = _e510;
                        } else {
                            phi_790_ = true;
                        }
                        let _e512 = phi_790_;
                        if _e512 {
                            if _e506 {
                                if (_e325.member_3 == 4294967295u) {
                                    phi_802_ = false;
                                } else {
                                    phi_802_ = true;
                                }
                                let _e516 = phi_802_;
                                phi_803_ = _e516;
                            } else {
                                phi_803_ = true;
                            }
                            let _e518 = phi_803_;
                            if _e518 {
                                if _e457 {
                                    if _e506 {
                                        let _e521 = a_nodes.member[_e323.member_1];
                                        let _e526 = a_nodes.member[_e323.member_3];
                                        let _e531 = b_nodes.member[_e325.member_1];
                                        let _e536 = b_nodes.member[_e325.member_3];
                                        if ((((((_e521.member[0] <= _e531.member_2[0]) && (_e531.member[0] <= _e521.member_2[0])) && (_e521.member[1] <= _e531.member_2[1])) && (_e531.member[1] <= _e521.member_2[1])) && (_e521.member[2] <= _e531.member_2[2])) && (_e531.member[2] <= _e521.member_2[2])) {
                                            phi_898_ = array<u32, 2>(_e323.member_1, _e325.member_1);
                                        } else {
                                            phi_898_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e566 = phi_898_;
                                        if ((((((_e521.member[0] <= _e536.member_2[0]) && (_e536.member[0] <= _e521.member_2[0])) && (_e521.member[1] <= _e536.member_2[1])) && (_e536.member[1] <= _e521.member_2[1])) && (_e521.member[2] <= _e536.member_2[2])) && (_e536.member[2] <= _e521.member_2[2])) {
                                            phi_928_ = array<u32, 2>(_e323.member_1, _e325.member_3);
                                        } else {
                                            phi_928_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e594 = phi_928_;
                                        if ((((((_e526.member[0] <= _e531.member_2[0]) && (_e531.member[0] <= _e526.member_2[0])) && (_e526.member[1] <= _e531.member_2[1])) && (_e531.member[1] <= _e526.member_2[1])) && (_e526.member[2] <= _e531.member_2[2])) && (_e531.member[2] <= _e526.member_2[2])) {
                                            phi_958_ = array<u32, 2>(_e323.member_3, _e325.member_1);
                                        } else {
                                            phi_958_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e622 = phi_958_;
                                        if ((((((_e526.member[0] <= _e536.member_2[0]) && (_e536.member[0] <= _e526.member_2[0])) && (_e526.member[1] <= _e536.member_2[1])) && (_e536.member[1] <= _e526.member_2[1])) && (_e526.member[2] <= _e536.member_2[2])) && (_e536.member[2] <= _e526.member_2[2])) {
                                            phi_988_ = array<u32, 2>(_e323.member_3, _e325.member_3);
                                        } else {
                                            phi_988_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e650 = phi_988_;
                                        phi_990_ = array<array<u32, 2>, 4>(_e566, _e594, _e622, _e650);
                                        phi_991_ = false;
                                    } else {
                                        phi_990_ = array<array<u32, 2>, 4>();
                                        phi_991_ = true;
                                    }
                                    let _e653 = phi_990_;
                                    let _e655 = phi_991_;
                                    phi_992_ = _e653;
                                    phi_993_ = _e655;
                                } else {
                                    phi_992_ = array<array<u32, 2>, 4>();
                                    phi_993_ = true;
                                }
                                let _e657 = phi_992_;
                                let _e659 = phi_993_;
                                if _e659 {
                                    if _e457 {
                                        let _e731 = a_nodes.member[_e323.member_1];
                                        let _e736 = a_nodes.member[_e323.member_3];
                                        if ((((((_e731.member[0] <= _e325.member_2[0]) && (_e325.member[0] <= _e731.member_2[0])) && (_e731.member[1] <= _e325.member_2[1])) && (_e325.member[1] <= _e731.member_2[1])) && (_e731.member[2] <= _e325.member_2[2])) && (_e325.member[2] <= _e731.member_2[2])) {
                                            phi_1059_ = array<u32, 2>(_e323.member_1, _e317[1]);
                                        } else {
                                            phi_1059_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e767 = phi_1059_;
                                        if ((((((_e736.member[0] <= _e325.member_2[0]) && (_e325.member[0] <= _e736.member_2[0])) && (_e736.member[1] <= _e325.member_2[1])) && (_e325.member[1] <= _e736.member_2[1])) && (_e736.member[2] <= _e325.member_2[2])) && (_e325.member[2] <= _e736.member_2[2])) {
                                            phi_1091_ = array<u32, 2>(_e323.member_3, _e317[1]);
                                        } else {
                                            phi_1091_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e796 = phi_1091_;
                                        phi_1186_ = array<array<u32, 2>, 4>(_e767, _e796, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    } else {
                                        let _e662 = b_nodes.member[_e325.member_1];
                                        let _e667 = b_nodes.member[_e325.member_3];
                                        if ((((((_e323.member[0] <= _e662.member_2[0]) && (_e662.member[0] <= _e323.member_2[0])) && (_e323.member[1] <= _e662.member_2[1])) && (_e662.member[1] <= _e323.member_2[1])) && (_e323.member[2] <= _e662.member_2[2])) && (_e662.member[2] <= _e323.member_2[2])) {
                                            phi_1152_ = array<u32, 2>(_e317[0], _e325.member_1);
                                        } else {
                                            phi_1152_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e698 = phi_1152_;
                                        if ((((((_e323.member[0] <= _e667.member_2[0]) && (_e667.member[0] <= _e323.member_2[0])) && (_e323.member[1] <= _e667.member_2[1])) && (_e667.member[1] <= _e323.member_2[1])) && (_e323.member[2] <= _e667.member_2[2])) && (_e667.member[2] <= _e323.member_2[2])) {
                                            phi_1184_ = array<u32, 2>(_e317[0], _e325.member_3);
                                        } else {
                                            phi_1184_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e727 = phi_1184_;
                                        phi_1186_ = array<array<u32, 2>, 4>(_e698, _e727, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    }
                                    let _e799 = phi_1186_;
                                    phi_1187_ = _e799;
                                } else {
                                    phi_1187_ = _e657;
                                }
                                let _e801 = phi_1187_;
                                phi_1188_ = _e801;
                                phi_1189_ = false;
                            } else {
                                phi_1188_ = array<array<u32, 2>, 4>();
                                phi_1189_ = true;
                            }
                            let _e803 = phi_1188_;
                            let _e805 = phi_1189_;
                            phi_1190_ = _e803;
                            phi_1191_ = _e805;
                        } else {
                            phi_1190_ = array<array<u32, 2>, 4>();
                            phi_1191_ = true;
                        }
                        let _e807 = phi_1190_;
                        let _e809 = phi_1191_;
                        phi_1195_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        phi_1196_ = _e807;
                        phi_1197_ = _e809;
                    } else {
                        phi_1195_ = _e391;
                        phi_1196_ = array<array<u32, 2>, 4>();
                        phi_1197_ = true;
                    }
                    let _e811 = phi_1195_;
                    let _e813 = phi_1196_;
                    let _e815 = phi_1197_;
                    if _e815 {
                        phi_1201_ = _e811;
                    } else {
                        phi_1201_ = _e813;
                    }
                    let _e817 = phi_1201_;
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e817[0][0], _e817[0][1]), array<u32, 2>(_e817[1][0], _e817[1][1]), array<u32, 2>(_e817[2][0], _e817[2][1]), array<u32, 2>(_e817[3][0], _e817[3][1]));
                    phi_1221_ = type_12(0u, 4u);
                    loop {
                        let _e836 = phi_1221_;
                        if (_e836.member < _e836.member_1) {
                            phi_1222_ = type_12((_e836.member + 1u), _e836.member_1);
                            phi_1245_ = type_12(1u, _e836.member);
                        } else {
                            phi_1222_ = _e836;
                            phi_1245_ = type_12(0u, type_12().member_1);
                        }
                        let _e848 = phi_1222_;
                        let _e850 = phi_1245_;
                        let _e854 = (bitcast<i32>(_e850.member) != 0i);
                        if _e854 {
                            let _e856 = local_1[_e850.member_1];
                            if (_e856[0] != 4294967295u) {
                                if _e107 {
                                    phi_1274_ = (_e856[0] == _e856[1]);
                                } else {
                                    phi_1274_ = false;
                                }
                                let _e862 = phi_1274_;
                                if _e862 {
                                    phi_3483_ = bool();
                                    phi_3484_ = true;
                                } else {
                                    if (_e856[0] >= _e118) {
                                        if (_e856[1] >= _e123) {
                                            phi_1286_ = false;
                                        } else {
                                            phi_1286_ = true;
                                        }
                                        let _e866 = phi_1286_;
                                        phi_1287_ = _e866;
                                    } else {
                                        phi_1287_ = true;
                                    }
                                    let _e868 = phi_1287_;
                                    if _e868 {
                                        if (_e856[0] < _e118) {
                                            let _e948 = oriented.member[(_e127 + _e856[0])];
                                            phi_1434_ = type_31(array<f32, 3>(_e948.member.x, _e948.member.y, _e948.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e948.member.w, _e948.member_1.x, _e948.member_1.y), array<f32, 3>(_e948.member_1.z, _e948.member_1.w, _e948.member_2.x), array<f32, 3>(_e948.member_2.y, _e948.member_2.z, _e948.member_2.w)), array<f32, 3>(_e948.member_3.x, _e948.member_3.y, _e948.member_3.z));
                                        } else {
                                            let _e871 = a_nodes.member[_e856[0]];
                                            let _e886 = ((_e871.member[0] * 0.5f) + (_e871.member_2[0] * 0.5f));
                                            let _e887 = ((_e871.member[1] * 0.5f) + (_e871.member_2[1] * 0.5f));
                                            let _e888 = ((_e871.member[2] * 0.5f) + (_e871.member_2[2] * 0.5f));
                                            if (_e886 < _e871.member_2[0]) {
                                                phi_1360_ = _e886;
                                            } else {
                                                phi_1360_ = _e871.member_2[0];
                                            }
                                            let _e892 = phi_1360_;
                                            if (_e887 < _e871.member_2[1]) {
                                                phi_1366_ = _e887;
                                            } else {
                                                phi_1366_ = _e871.member_2[1];
                                            }
                                            let _e896 = phi_1366_;
                                            if (_e888 < _e871.member_2[2]) {
                                                phi_1372_ = _e888;
                                            } else {
                                                phi_1372_ = _e871.member_2[2];
                                            }
                                            let _e900 = phi_1372_;
                                            if (_e892 > _e871.member[0]) {
                                                phi_1378_ = _e892;
                                            } else {
                                                phi_1378_ = _e871.member[0];
                                            }
                                            let _e904 = phi_1378_;
                                            if (_e896 > _e871.member[1]) {
                                                phi_1384_ = _e896;
                                            } else {
                                                phi_1384_ = _e871.member[1];
                                            }
                                            let _e908 = phi_1384_;
                                            if (_e900 > _e871.member[2]) {
                                                phi_1390_ = _e900;
                                            } else {
                                                phi_1390_ = _e871.member[2];
                                            }
                                            let _e912 = phi_1390_;
                                            let _e915 = (_e871.member_2[0] - _e904);
                                            let _e917 = (_e871.member_2[1] - _e908);
                                            let _e919 = (_e871.member_2[2] - _e912);
                                            let _e921 = (_e904 - _e871.member[0]);
                                            let _e923 = (_e908 - _e871.member[1]);
                                            let _e925 = (_e912 - _e871.member[2]);
                                            if (_e915 > _e921) {
                                                phi_1408_ = _e915;
                                            } else {
                                                phi_1408_ = _e921;
                                            }
                                            let _e928 = phi_1408_;
                                            if (_e917 > _e923) {
                                                phi_1413_ = _e917;
                                            } else {
                                                phi_1413_ = _e923;
                                            }
                                            let _e931 = phi_1413_;
                                            if (_e919 > _e925) {
                                                phi_1418_ = _e919;
                                            } else {
                                                phi_1418_ = _e925;
                                            }
                                            let _e934 = phi_1418_;
                                            let _e936 = (1f + (0.000000059604645f * 4f));
                                            let _e940 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1434_ = type_31(array<f32, 3>(_e904, _e908, _e912), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e928 * _e936) + _e940), ((_e931 * _e936) + _e940), ((_e934 * _e936) + _e940)));
                                        }
                                        let _e987 = phi_1434_;
                                        if (_e856[1] < _e123) {
                                            let _e1067 = oriented.member[(_e131 + _e856[1])];
                                            phi_1578_ = type_31(array<f32, 3>(_e1067.member.x, _e1067.member.y, _e1067.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1067.member.w, _e1067.member_1.x, _e1067.member_1.y), array<f32, 3>(_e1067.member_1.z, _e1067.member_1.w, _e1067.member_2.x), array<f32, 3>(_e1067.member_2.y, _e1067.member_2.z, _e1067.member_2.w)), array<f32, 3>(_e1067.member_3.x, _e1067.member_3.y, _e1067.member_3.z));
                                        } else {
                                            let _e990 = b_nodes.member[_e856[1]];
                                            let _e1005 = ((_e990.member[0] * 0.5f) + (_e990.member_2[0] * 0.5f));
                                            let _e1006 = ((_e990.member[1] * 0.5f) + (_e990.member_2[1] * 0.5f));
                                            let _e1007 = ((_e990.member[2] * 0.5f) + (_e990.member_2[2] * 0.5f));
                                            if (_e1005 < _e990.member_2[0]) {
                                                phi_1504_ = _e1005;
                                            } else {
                                                phi_1504_ = _e990.member_2[0];
                                            }
                                            let _e1011 = phi_1504_;
                                            if (_e1006 < _e990.member_2[1]) {
                                                phi_1510_ = _e1006;
                                            } else {
                                                phi_1510_ = _e990.member_2[1];
                                            }
                                            let _e1015 = phi_1510_;
                                            if (_e1007 < _e990.member_2[2]) {
                                                phi_1516_ = _e1007;
                                            } else {
                                                phi_1516_ = _e990.member_2[2];
                                            }
                                            let _e1019 = phi_1516_;
                                            if (_e1011 > _e990.member[0]) {
                                                phi_1522_ = _e1011;
                                            } else {
                                                phi_1522_ = _e990.member[0];
                                            }
                                            let _e1023 = phi_1522_;
                                            if (_e1015 > _e990.member[1]) {
                                                phi_1528_ = _e1015;
                                            } else {
                                                phi_1528_ = _e990.member[1];
                                            }
                                            let _e1027 = phi_1528_;
                                            if (_e1019 > _e990.member[2]) {
                                                phi_1534_ = _e1019;
                                            } else {
                                                phi_1534_ = _e990.member[2];
                                            }
                                            let _e1031 = phi_1534_;
                                            let _e1034 = (_e990.member_2[0] - _e1023);
                                            let _e1036 = (_e990.member_2[1] - _e1027);
                                            let _e1038 = (_e990.member_2[2] - _e1031);
                                            let _e1040 = (_e1023 - _e990.member[0]);
                                            let _e1042 = (_e1027 - _e990.member[1]);
                                            let _e1044 = (_e1031 - _e990.member[2]);
                                            if (_e1034 > _e1040) {
                                                phi_1552_ = _e1034;
                                            } else {
                                                phi_1552_ = _e1040;
                                            }
                                            let _e1047 = phi_1552_;
                                            if (_e1036 > _e1042) {
                                                phi_1557_ = _e1036;
                                            } else {
                                                phi_1557_ = _e1042;
                                            }
                                            let _e1050 = phi_1557_;
                                            if (_e1038 > _e1044) {
                                                phi_1562_ = _e1038;
                                            } else {
                                                phi_1562_ = _e1044;
                                            }
                                            let _e1053 = phi_1562_;
                                            let _e1055 = (1f + (0.000000059604645f * 4f));
                                            let _e1059 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1578_ = type_31(array<f32, 3>(_e1023, _e1027, _e1031), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1047 * _e1055) + _e1059), ((_e1050 * _e1055) + _e1059), ((_e1053 * _e1055) + _e1059)));
                                        }
                                        let _e1106 = phi_1578_;
                                        let _e1111 = (_e1106.member[0] - _e987.member[0]);
                                        let _e1114 = (_e1106.member[1] - _e987.member[1]);
                                        let _e1117 = (_e1106.member[2] - _e987.member[2]);
                                        if (_e1111 < 0f) {
                                            phi_1768_ = -(_e1111);
                                        } else {
                                            phi_1768_ = _e1111;
                                        }
                                        let _e1306 = phi_1768_;
                                        if (_e1114 < 0f) {
                                            phi_1774_ = -(_e1114);
                                        } else {
                                            phi_1774_ = _e1114;
                                        }
                                        let _e1310 = phi_1774_;
                                        if (_e1117 < 0f) {
                                            phi_1781_ = -(_e1117);
                                        } else {
                                            phi_1781_ = _e1117;
                                        }
                                        let _e1315 = phi_1781_;
                                        if (_e987.member_2[0] < 0f) {
                                            phi_1790_ = -(_e987.member_2[0]);
                                        } else {
                                            phi_1790_ = _e987.member_2[0];
                                        }
                                        let _e1322 = phi_1790_;
                                        if (_e987.member_2[1] < 0f) {
                                            phi_1797_ = -(_e987.member_2[1]);
                                        } else {
                                            phi_1797_ = _e987.member_2[1];
                                        }
                                        let _e1327 = phi_1797_;
                                        if (_e987.member_2[2] < 0f) {
                                            phi_1805_ = -(_e987.member_2[2]);
                                        } else {
                                            phi_1805_ = _e987.member_2[2];
                                        }
                                        let _e1333 = phi_1805_;
                                        if (_e1106.member_2[0] < 0f) {
                                            phi_1814_ = -(_e1106.member_2[0]);
                                        } else {
                                            phi_1814_ = _e1106.member_2[0];
                                        }
                                        let _e1340 = phi_1814_;
                                        if (_e1106.member_2[1] < 0f) {
                                            phi_1821_ = -(_e1106.member_2[1]);
                                        } else {
                                            phi_1821_ = _e1106.member_2[1];
                                        }
                                        let _e1345 = phi_1821_;
                                        if (_e1106.member_2[2] < 0f) {
                                            phi_1829_ = -(_e1106.member_2[2]);
                                        } else {
                                            phi_1829_ = _e1106.member_2[2];
                                        }
                                        let _e1351 = phi_1829_;
                                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e1106.member_1[0][0] * _e987.member_1[0][0]) + (_e1106.member_1[0][1] * _e987.member_1[0][1])) + (_e1106.member_1[0][2] * _e987.member_1[0][2])), (((_e1106.member_1[1][0] * _e987.member_1[0][0]) + (_e1106.member_1[1][1] * _e987.member_1[0][1])) + (_e1106.member_1[1][2] * _e987.member_1[0][2])), (((_e1106.member_1[2][0] * _e987.member_1[0][0]) + (_e1106.member_1[2][1] * _e987.member_1[0][1])) + (_e1106.member_1[2][2] * _e987.member_1[0][2]))), array<f32, 3>((((_e1106.member_1[0][0] * _e987.member_1[1][0]) + (_e1106.member_1[0][1] * _e987.member_1[1][1])) + (_e1106.member_1[0][2] * _e987.member_1[1][2])), (((_e1106.member_1[1][0] * _e987.member_1[1][0]) + (_e1106.member_1[1][1] * _e987.member_1[1][1])) + (_e1106.member_1[1][2] * _e987.member_1[1][2])), (((_e1106.member_1[2][0] * _e987.member_1[1][0]) + (_e1106.member_1[2][1] * _e987.member_1[1][1])) + (_e1106.member_1[2][2] * _e987.member_1[1][2]))), array<f32, 3>((((_e1106.member_1[0][0] * _e987.member_1[2][0]) + (_e1106.member_1[0][1] * _e987.member_1[2][1])) + (_e1106.member_1[0][2] * _e987.member_1[2][2])), (((_e1106.member_1[1][0] * _e987.member_1[2][0]) + (_e1106.member_1[1][1] * _e987.member_1[2][1])) + (_e1106.member_1[1][2] * _e987.member_1[2][2])), (((_e1106.member_1[2][0] * _e987.member_1[2][0]) + (_e1106.member_1[2][1] * _e987.member_1[2][1])) + (_e1106.member_1[2][2] * _e987.member_1[2][2])))), array<f32, 3>((((_e987.member_1[0][0] * _e1111) + (_e987.member_1[0][1] * _e1114)) + (_e987.member_1[0][2] * _e1117)), (((_e987.member_1[1][0] * _e1111) + (_e987.member_1[1][1] * _e1114)) + (_e987.member_1[1][2] * _e1117)), (((_e987.member_1[2][0] * _e1111) + (_e987.member_1[2][1] * _e1114)) + (_e987.member_1[2][2] * _e1117))), array<f32, 3>((((_e1106.member_1[0][0] * _e1111) + (_e1106.member_1[0][1] * _e1114)) + (_e1106.member_1[0][2] * _e1117)), (((_e1106.member_1[1][0] * _e1111) + (_e1106.member_1[1][1] * _e1114)) + (_e1106.member_1[1][2] * _e1117)), (((_e1106.member_1[2][0] * _e1111) + (_e1106.member_1[2][1] * _e1114)) + (_e1106.member_1[2][2] * _e1117))), array<f32, 3>(_e987.member_2[0], _e987.member_2[1], _e987.member_2[2]), array<f32, 3>(_e1106.member_2[0], _e1106.member_2[1], _e1106.member_2[2]), ((((((_e1306 + _e1310) + _e1315) + (((_e1322 + _e1327) + _e1333) + ((_e1340 + _e1345) + _e1351))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1378 = local.member[0u][0u];
                                        let _e1382 = local.member[0u][1u];
                                        let _e1386 = local.member[0u][2u];
                                        let _e1390 = local.member[1u][0u];
                                        let _e1394 = local.member[1u][1u];
                                        let _e1398 = local.member[1u][2u];
                                        let _e1402 = local.member[2u][0u];
                                        let _e1406 = local.member[2u][1u];
                                        let _e1410 = local.member[2u][2u];
                                        let _e1412 = local.member_3;
                                        let _e1417 = local.member_4;
                                        let _e1423 = local.member_1[0u];
                                        if (_e1423 < 0f) {
                                            phi_1922_ = -(_e1423);
                                        } else {
                                            phi_1922_ = _e1423;
                                        }
                                        let _e1427 = phi_1922_;
                                        if (_e1378 < 0f) {
                                            phi_1929_ = -(_e1378);
                                        } else {
                                            phi_1929_ = _e1378;
                                        }
                                        let _e1431 = phi_1929_;
                                        if (_e1382 < 0f) {
                                            phi_1935_ = -(_e1382);
                                        } else {
                                            phi_1935_ = _e1382;
                                        }
                                        let _e1435 = phi_1935_;
                                        if (_e1386 < 0f) {
                                            phi_1941_ = -(_e1386);
                                        } else {
                                            phi_1941_ = _e1386;
                                        }
                                        let _e1439 = phi_1941_;
                                        let _e1446 = (_e1427 - (_e1412[0] + (((_e1431 * _e1417[0]) + (_e1435 * _e1417[1])) + (_e1439 * _e1417[2]))));
                                        let _e1449 = local.member_1[1u];
                                        if (_e1449 < 0f) {
                                            phi_1960_ = -(_e1449);
                                        } else {
                                            phi_1960_ = _e1449;
                                        }
                                        let _e1453 = phi_1960_;
                                        if (_e1390 < 0f) {
                                            phi_1967_ = -(_e1390);
                                        } else {
                                            phi_1967_ = _e1390;
                                        }
                                        let _e1457 = phi_1967_;
                                        if (_e1394 < 0f) {
                                            phi_1973_ = -(_e1394);
                                        } else {
                                            phi_1973_ = _e1394;
                                        }
                                        let _e1461 = phi_1973_;
                                        if (_e1398 < 0f) {
                                            phi_1979_ = -(_e1398);
                                        } else {
                                            phi_1979_ = _e1398;
                                        }
                                        let _e1465 = phi_1979_;
                                        let _e1472 = (_e1453 - (_e1412[1] + (((_e1457 * _e1417[0]) + (_e1461 * _e1417[1])) + (_e1465 * _e1417[2]))));
                                        let _e1475 = local.member_1[2u];
                                        if (_e1475 < 0f) {
                                            phi_1998_ = -(_e1475);
                                        } else {
                                            phi_1998_ = _e1475;
                                        }
                                        let _e1479 = phi_1998_;
                                        if (_e1402 < 0f) {
                                            phi_2005_ = -(_e1402);
                                        } else {
                                            phi_2005_ = _e1402;
                                        }
                                        let _e1483 = phi_2005_;
                                        if (_e1406 < 0f) {
                                            phi_2011_ = -(_e1406);
                                        } else {
                                            phi_2011_ = _e1406;
                                        }
                                        let _e1487 = phi_2011_;
                                        if (_e1410 < 0f) {
                                            phi_2017_ = -(_e1410);
                                        } else {
                                            phi_2017_ = _e1410;
                                        }
                                        let _e1491 = phi_2017_;
                                        let _e1498 = (_e1479 - (_e1412[2] + (((_e1483 * _e1417[0]) + (_e1487 * _e1417[1])) + (_e1491 * _e1417[2]))));
                                        let _e1501 = local.member_2[0u];
                                        if (_e1501 < 0f) {
                                            phi_2036_ = -(_e1501);
                                        } else {
                                            phi_2036_ = _e1501;
                                        }
                                        let _e1505 = phi_2036_;
                                        if (_e1378 < 0f) {
                                            phi_2043_ = -(_e1378);
                                        } else {
                                            phi_2043_ = _e1378;
                                        }
                                        let _e1509 = phi_2043_;
                                        if (_e1390 < 0f) {
                                            phi_2049_ = -(_e1390);
                                        } else {
                                            phi_2049_ = _e1390;
                                        }
                                        let _e1513 = phi_2049_;
                                        if (_e1402 < 0f) {
                                            phi_2055_ = -(_e1402);
                                        } else {
                                            phi_2055_ = _e1402;
                                        }
                                        let _e1517 = phi_2055_;
                                        let _e1524 = (_e1505 - (_e1417[0] + (((_e1509 * _e1412[0]) + (_e1513 * _e1412[1])) + (_e1517 * _e1412[2]))));
                                        let _e1527 = local.member_2[1u];
                                        if (_e1527 < 0f) {
                                            phi_2074_ = -(_e1527);
                                        } else {
                                            phi_2074_ = _e1527;
                                        }
                                        let _e1531 = phi_2074_;
                                        if (_e1382 < 0f) {
                                            phi_2081_ = -(_e1382);
                                        } else {
                                            phi_2081_ = _e1382;
                                        }
                                        let _e1535 = phi_2081_;
                                        if (_e1394 < 0f) {
                                            phi_2087_ = -(_e1394);
                                        } else {
                                            phi_2087_ = _e1394;
                                        }
                                        let _e1539 = phi_2087_;
                                        if (_e1406 < 0f) {
                                            phi_2093_ = -(_e1406);
                                        } else {
                                            phi_2093_ = _e1406;
                                        }
                                        let _e1543 = phi_2093_;
                                        let _e1550 = (_e1531 - (_e1417[1] + (((_e1535 * _e1412[0]) + (_e1539 * _e1412[1])) + (_e1543 * _e1412[2]))));
                                        let _e1553 = local.member_2[2u];
                                        if (_e1553 < 0f) {
                                            phi_2112_ = -(_e1553);
                                        } else {
                                            phi_2112_ = _e1553;
                                        }
                                        let _e1557 = phi_2112_;
                                        if (_e1386 < 0f) {
                                            phi_2119_ = -(_e1386);
                                        } else {
                                            phi_2119_ = _e1386;
                                        }
                                        let _e1561 = phi_2119_;
                                        if (_e1398 < 0f) {
                                            phi_2125_ = -(_e1398);
                                        } else {
                                            phi_2125_ = _e1398;
                                        }
                                        let _e1565 = phi_2125_;
                                        if (_e1410 < 0f) {
                                            phi_2131_ = -(_e1410);
                                        } else {
                                            phi_2131_ = _e1410;
                                        }
                                        let _e1569 = phi_2131_;
                                        let _e1576 = (_e1557 - (_e1417[2] + (((_e1561 * _e1412[0]) + (_e1565 * _e1412[1])) + (_e1569 * _e1412[2]))));
                                        if (_e1446 > _e1472) {
                                            phi_2146_ = _e1446;
                                        } else {
                                            phi_2146_ = _e1472;
                                        }
                                        let _e1579 = phi_2146_;
                                        if (_e1579 > _e1498) {
                                            phi_2151_ = _e1579;
                                        } else {
                                            phi_2151_ = _e1498;
                                        }
                                        let _e1582 = phi_2151_;
                                        if (_e1524 > _e1550) {
                                            phi_2156_ = _e1524;
                                        } else {
                                            phi_2156_ = _e1550;
                                        }
                                        let _e1585 = phi_2156_;
                                        if (_e1585 > _e1576) {
                                            phi_2161_ = _e1585;
                                        } else {
                                            phi_2161_ = _e1576;
                                        }
                                        let _e1588 = phi_2161_;
                                        if (_e1582 > _e1588) {
                                            phi_2166_ = _e1582;
                                        } else {
                                            phi_2166_ = _e1588;
                                        }
                                        let _e1591 = phi_2166_;
                                        let _e1593 = local.member_5;
                                        if (_e1591 > _e1593) {
                                            phi_3479_ = true;
                                        } else {
                                            let _e1598 = local.member[1u][0u];
                                            let _e1601 = local.member_1[2u];
                                            let _e1606 = local.member[2u][0u];
                                            let _e1609 = local.member_1[1u];
                                            let _e1611 = ((_e1598 * _e1601) - (_e1606 * _e1609));
                                            let _e1615 = local.member[2u][0u];
                                            if (_e1615 < 0f) {
                                                phi_2225_ = -(_e1615);
                                            } else {
                                                phi_2225_ = _e1615;
                                            }
                                            let _e1619 = phi_2225_;
                                            let _e1622 = local.member_3[1u];
                                            let _e1627 = local.member[1u][0u];
                                            if (_e1627 < 0f) {
                                                phi_2248_ = -(_e1627);
                                            } else {
                                                phi_2248_ = _e1627;
                                            }
                                            let _e1631 = phi_2248_;
                                            let _e1634 = local.member_3[2u];
                                            let _e1640 = local.member[0u][2u];
                                            if (_e1640 < 0f) {
                                                phi_2271_ = -(_e1640);
                                            } else {
                                                phi_2271_ = _e1640;
                                            }
                                            let _e1644 = phi_2271_;
                                            let _e1647 = local.member_4[1u];
                                            let _e1652 = local.member[0u][1u];
                                            if (_e1652 < 0f) {
                                                phi_2293_ = -(_e1652);
                                            } else {
                                                phi_2293_ = _e1652;
                                            }
                                            let _e1656 = phi_2293_;
                                            let _e1659 = local.member_4[2u];
                                            if (_e1611 < 0f) {
                                                phi_2309_ = -(_e1611);
                                            } else {
                                                phi_2309_ = _e1611;
                                            }
                                            let _e1665 = phi_2309_;
                                            let _e1667 = (_e1665 - (((_e1619 * _e1622) + (_e1631 * _e1634)) + ((_e1644 * _e1647) + (_e1656 * _e1659))));
                                            let _e1671 = local.member[1u][1u];
                                            let _e1674 = local.member_1[2u];
                                            let _e1679 = local.member[2u][1u];
                                            let _e1682 = local.member_1[1u];
                                            let _e1684 = ((_e1671 * _e1674) - (_e1679 * _e1682));
                                            let _e1688 = local.member[2u][1u];
                                            if (_e1688 < 0f) {
                                                phi_2364_ = -(_e1688);
                                            } else {
                                                phi_2364_ = _e1688;
                                            }
                                            let _e1692 = phi_2364_;
                                            let _e1695 = local.member_3[1u];
                                            let _e1700 = local.member[1u][1u];
                                            if (_e1700 < 0f) {
                                                phi_2387_ = -(_e1700);
                                            } else {
                                                phi_2387_ = _e1700;
                                            }
                                            let _e1704 = phi_2387_;
                                            let _e1707 = local.member_3[2u];
                                            let _e1713 = local.member[0u][0u];
                                            if (_e1713 < 0f) {
                                                phi_2410_ = -(_e1713);
                                            } else {
                                                phi_2410_ = _e1713;
                                            }
                                            let _e1717 = phi_2410_;
                                            let _e1720 = local.member_4[2u];
                                            let _e1725 = local.member[0u][2u];
                                            if (_e1725 < 0f) {
                                                phi_2432_ = -(_e1725);
                                            } else {
                                                phi_2432_ = _e1725;
                                            }
                                            let _e1729 = phi_2432_;
                                            let _e1732 = local.member_4[0u];
                                            if (_e1684 < 0f) {
                                                phi_2448_ = -(_e1684);
                                            } else {
                                                phi_2448_ = _e1684;
                                            }
                                            let _e1738 = phi_2448_;
                                            let _e1740 = (_e1738 - (((_e1692 * _e1695) + (_e1704 * _e1707)) + ((_e1717 * _e1720) + (_e1729 * _e1732))));
                                            let _e1744 = local.member[1u][2u];
                                            let _e1747 = local.member_1[2u];
                                            let _e1752 = local.member[2u][2u];
                                            let _e1755 = local.member_1[1u];
                                            let _e1757 = ((_e1744 * _e1747) - (_e1752 * _e1755));
                                            let _e1761 = local.member[2u][2u];
                                            if (_e1761 < 0f) {
                                                phi_2503_ = -(_e1761);
                                            } else {
                                                phi_2503_ = _e1761;
                                            }
                                            let _e1765 = phi_2503_;
                                            let _e1768 = local.member_3[1u];
                                            let _e1773 = local.member[1u][2u];
                                            if (_e1773 < 0f) {
                                                phi_2526_ = -(_e1773);
                                            } else {
                                                phi_2526_ = _e1773;
                                            }
                                            let _e1777 = phi_2526_;
                                            let _e1780 = local.member_3[2u];
                                            let _e1786 = local.member[0u][1u];
                                            if (_e1786 < 0f) {
                                                phi_2549_ = -(_e1786);
                                            } else {
                                                phi_2549_ = _e1786;
                                            }
                                            let _e1790 = phi_2549_;
                                            let _e1793 = local.member_4[0u];
                                            let _e1798 = local.member[0u][0u];
                                            if (_e1798 < 0f) {
                                                phi_2571_ = -(_e1798);
                                            } else {
                                                phi_2571_ = _e1798;
                                            }
                                            let _e1802 = phi_2571_;
                                            let _e1805 = local.member_4[1u];
                                            if (_e1757 < 0f) {
                                                phi_2587_ = -(_e1757);
                                            } else {
                                                phi_2587_ = _e1757;
                                            }
                                            let _e1811 = phi_2587_;
                                            let _e1813 = (_e1811 - (((_e1765 * _e1768) + (_e1777 * _e1780)) + ((_e1790 * _e1793) + (_e1802 * _e1805))));
                                            let _e1817 = local.member[2u][0u];
                                            let _e1820 = local.member_1[0u];
                                            let _e1825 = local.member[0u][0u];
                                            let _e1828 = local.member_1[2u];
                                            let _e1830 = ((_e1817 * _e1820) - (_e1825 * _e1828));
                                            let _e1834 = local.member[0u][0u];
                                            if (_e1834 < 0f) {
                                                phi_2642_ = -(_e1834);
                                            } else {
                                                phi_2642_ = _e1834;
                                            }
                                            let _e1838 = phi_2642_;
                                            let _e1841 = local.member_3[2u];
                                            let _e1846 = local.member[2u][0u];
                                            if (_e1846 < 0f) {
                                                phi_2665_ = -(_e1846);
                                            } else {
                                                phi_2665_ = _e1846;
                                            }
                                            let _e1850 = phi_2665_;
                                            let _e1853 = local.member_3[0u];
                                            let _e1859 = local.member[1u][2u];
                                            if (_e1859 < 0f) {
                                                phi_2689_ = -(_e1859);
                                            } else {
                                                phi_2689_ = _e1859;
                                            }
                                            let _e1863 = phi_2689_;
                                            let _e1866 = local.member_4[1u];
                                            let _e1871 = local.member[1u][1u];
                                            if (_e1871 < 0f) {
                                                phi_2712_ = -(_e1871);
                                            } else {
                                                phi_2712_ = _e1871;
                                            }
                                            let _e1875 = phi_2712_;
                                            let _e1878 = local.member_4[2u];
                                            if (_e1830 < 0f) {
                                                phi_2728_ = -(_e1830);
                                            } else {
                                                phi_2728_ = _e1830;
                                            }
                                            let _e1884 = phi_2728_;
                                            let _e1886 = (_e1884 - (((_e1838 * _e1841) + (_e1850 * _e1853)) + ((_e1863 * _e1866) + (_e1875 * _e1878))));
                                            let _e1890 = local.member[2u][1u];
                                            let _e1893 = local.member_1[0u];
                                            let _e1898 = local.member[0u][1u];
                                            let _e1901 = local.member_1[2u];
                                            let _e1903 = ((_e1890 * _e1893) - (_e1898 * _e1901));
                                            let _e1907 = local.member[0u][1u];
                                            if (_e1907 < 0f) {
                                                phi_2783_ = -(_e1907);
                                            } else {
                                                phi_2783_ = _e1907;
                                            }
                                            let _e1911 = phi_2783_;
                                            let _e1914 = local.member_3[2u];
                                            let _e1919 = local.member[2u][1u];
                                            if (_e1919 < 0f) {
                                                phi_2806_ = -(_e1919);
                                            } else {
                                                phi_2806_ = _e1919;
                                            }
                                            let _e1923 = phi_2806_;
                                            let _e1926 = local.member_3[0u];
                                            let _e1932 = local.member[1u][0u];
                                            if (_e1932 < 0f) {
                                                phi_2830_ = -(_e1932);
                                            } else {
                                                phi_2830_ = _e1932;
                                            }
                                            let _e1936 = phi_2830_;
                                            let _e1939 = local.member_4[2u];
                                            let _e1944 = local.member[1u][2u];
                                            if (_e1944 < 0f) {
                                                phi_2853_ = -(_e1944);
                                            } else {
                                                phi_2853_ = _e1944;
                                            }
                                            let _e1948 = phi_2853_;
                                            let _e1951 = local.member_4[0u];
                                            if (_e1903 < 0f) {
                                                phi_2869_ = -(_e1903);
                                            } else {
                                                phi_2869_ = _e1903;
                                            }
                                            let _e1957 = phi_2869_;
                                            let _e1959 = (_e1957 - (((_e1911 * _e1914) + (_e1923 * _e1926)) + ((_e1936 * _e1939) + (_e1948 * _e1951))));
                                            let _e1963 = local.member[2u][2u];
                                            let _e1966 = local.member_1[0u];
                                            let _e1971 = local.member[0u][2u];
                                            let _e1974 = local.member_1[2u];
                                            let _e1976 = ((_e1963 * _e1966) - (_e1971 * _e1974));
                                            let _e1980 = local.member[0u][2u];
                                            if (_e1980 < 0f) {
                                                phi_2924_ = -(_e1980);
                                            } else {
                                                phi_2924_ = _e1980;
                                            }
                                            let _e1984 = phi_2924_;
                                            let _e1987 = local.member_3[2u];
                                            let _e1992 = local.member[2u][2u];
                                            if (_e1992 < 0f) {
                                                phi_2947_ = -(_e1992);
                                            } else {
                                                phi_2947_ = _e1992;
                                            }
                                            let _e1996 = phi_2947_;
                                            let _e1999 = local.member_3[0u];
                                            let _e2005 = local.member[1u][1u];
                                            if (_e2005 < 0f) {
                                                phi_2971_ = -(_e2005);
                                            } else {
                                                phi_2971_ = _e2005;
                                            }
                                            let _e2009 = phi_2971_;
                                            let _e2012 = local.member_4[0u];
                                            let _e2017 = local.member[1u][0u];
                                            if (_e2017 < 0f) {
                                                phi_2994_ = -(_e2017);
                                            } else {
                                                phi_2994_ = _e2017;
                                            }
                                            let _e2021 = phi_2994_;
                                            let _e2024 = local.member_4[1u];
                                            if (_e1976 < 0f) {
                                                phi_3010_ = -(_e1976);
                                            } else {
                                                phi_3010_ = _e1976;
                                            }
                                            let _e2030 = phi_3010_;
                                            let _e2032 = (_e2030 - (((_e1984 * _e1987) + (_e1996 * _e1999)) + ((_e2009 * _e2012) + (_e2021 * _e2024))));
                                            let _e2036 = local.member[0u][0u];
                                            let _e2039 = local.member_1[1u];
                                            let _e2044 = local.member[1u][0u];
                                            let _e2047 = local.member_1[0u];
                                            let _e2049 = ((_e2036 * _e2039) - (_e2044 * _e2047));
                                            let _e2053 = local.member[1u][0u];
                                            if (_e2053 < 0f) {
                                                phi_3065_ = -(_e2053);
                                            } else {
                                                phi_3065_ = _e2053;
                                            }
                                            let _e2057 = phi_3065_;
                                            let _e2060 = local.member_3[0u];
                                            let _e2065 = local.member[0u][0u];
                                            if (_e2065 < 0f) {
                                                phi_3088_ = -(_e2065);
                                            } else {
                                                phi_3088_ = _e2065;
                                            }
                                            let _e2069 = phi_3088_;
                                            let _e2072 = local.member_3[1u];
                                            let _e2078 = local.member[2u][2u];
                                            if (_e2078 < 0f) {
                                                phi_3112_ = -(_e2078);
                                            } else {
                                                phi_3112_ = _e2078;
                                            }
                                            let _e2082 = phi_3112_;
                                            let _e2085 = local.member_4[1u];
                                            let _e2090 = local.member[2u][1u];
                                            if (_e2090 < 0f) {
                                                phi_3135_ = -(_e2090);
                                            } else {
                                                phi_3135_ = _e2090;
                                            }
                                            let _e2094 = phi_3135_;
                                            let _e2097 = local.member_4[2u];
                                            if (_e2049 < 0f) {
                                                phi_3151_ = -(_e2049);
                                            } else {
                                                phi_3151_ = _e2049;
                                            }
                                            let _e2103 = phi_3151_;
                                            let _e2105 = (_e2103 - (((_e2057 * _e2060) + (_e2069 * _e2072)) + ((_e2082 * _e2085) + (_e2094 * _e2097))));
                                            let _e2109 = local.member[0u][1u];
                                            let _e2112 = local.member_1[1u];
                                            let _e2117 = local.member[1u][1u];
                                            let _e2120 = local.member_1[0u];
                                            let _e2122 = ((_e2109 * _e2112) - (_e2117 * _e2120));
                                            let _e2126 = local.member[1u][1u];
                                            if (_e2126 < 0f) {
                                                phi_3206_ = -(_e2126);
                                            } else {
                                                phi_3206_ = _e2126;
                                            }
                                            let _e2130 = phi_3206_;
                                            let _e2133 = local.member_3[0u];
                                            let _e2138 = local.member[0u][1u];
                                            if (_e2138 < 0f) {
                                                phi_3229_ = -(_e2138);
                                            } else {
                                                phi_3229_ = _e2138;
                                            }
                                            let _e2142 = phi_3229_;
                                            let _e2145 = local.member_3[1u];
                                            let _e2151 = local.member[2u][0u];
                                            if (_e2151 < 0f) {
                                                phi_3253_ = -(_e2151);
                                            } else {
                                                phi_3253_ = _e2151;
                                            }
                                            let _e2155 = phi_3253_;
                                            let _e2158 = local.member_4[2u];
                                            let _e2163 = local.member[2u][2u];
                                            if (_e2163 < 0f) {
                                                phi_3276_ = -(_e2163);
                                            } else {
                                                phi_3276_ = _e2163;
                                            }
                                            let _e2167 = phi_3276_;
                                            let _e2170 = local.member_4[0u];
                                            if (_e2122 < 0f) {
                                                phi_3292_ = -(_e2122);
                                            } else {
                                                phi_3292_ = _e2122;
                                            }
                                            let _e2176 = phi_3292_;
                                            let _e2178 = (_e2176 - (((_e2130 * _e2133) + (_e2142 * _e2145)) + ((_e2155 * _e2158) + (_e2167 * _e2170))));
                                            let _e2182 = local.member[0u][2u];
                                            let _e2185 = local.member_1[1u];
                                            let _e2190 = local.member[1u][2u];
                                            let _e2193 = local.member_1[0u];
                                            let _e2195 = ((_e2182 * _e2185) - (_e2190 * _e2193));
                                            let _e2199 = local.member[1u][2u];
                                            if (_e2199 < 0f) {
                                                phi_3347_ = -(_e2199);
                                            } else {
                                                phi_3347_ = _e2199;
                                            }
                                            let _e2203 = phi_3347_;
                                            let _e2206 = local.member_3[0u];
                                            let _e2211 = local.member[0u][2u];
                                            if (_e2211 < 0f) {
                                                phi_3370_ = -(_e2211);
                                            } else {
                                                phi_3370_ = _e2211;
                                            }
                                            let _e2215 = phi_3370_;
                                            let _e2218 = local.member_3[1u];
                                            let _e2224 = local.member[2u][1u];
                                            if (_e2224 < 0f) {
                                                phi_3394_ = -(_e2224);
                                            } else {
                                                phi_3394_ = _e2224;
                                            }
                                            let _e2228 = phi_3394_;
                                            let _e2231 = local.member_4[0u];
                                            let _e2236 = local.member[2u][0u];
                                            if (_e2236 < 0f) {
                                                phi_3417_ = -(_e2236);
                                            } else {
                                                phi_3417_ = _e2236;
                                            }
                                            let _e2240 = phi_3417_;
                                            let _e2243 = local.member_4[1u];
                                            if (_e2195 < 0f) {
                                                phi_3433_ = -(_e2195);
                                            } else {
                                                phi_3433_ = _e2195;
                                            }
                                            let _e2249 = phi_3433_;
                                            let _e2251 = (_e2249 - (((_e2203 * _e2206) + (_e2215 * _e2218)) + ((_e2228 * _e2231) + (_e2240 * _e2243))));
                                            if (_e1667 > _e1740) {
                                                phi_3440_ = _e1667;
                                            } else {
                                                phi_3440_ = _e1740;
                                            }
                                            let _e2254 = phi_3440_;
                                            if (_e2254 > _e1813) {
                                                phi_3445_ = _e2254;
                                            } else {
                                                phi_3445_ = _e1813;
                                            }
                                            let _e2257 = phi_3445_;
                                            if (_e1886 > _e1959) {
                                                phi_3450_ = _e1886;
                                            } else {
                                                phi_3450_ = _e1959;
                                            }
                                            let _e2260 = phi_3450_;
                                            if (_e2260 > _e2032) {
                                                phi_3455_ = _e2260;
                                            } else {
                                                phi_3455_ = _e2032;
                                            }
                                            let _e2263 = phi_3455_;
                                            if (_e2257 > _e2263) {
                                                phi_3460_ = _e2257;
                                            } else {
                                                phi_3460_ = _e2263;
                                            }
                                            let _e2266 = phi_3460_;
                                            if (_e2105 > _e2178) {
                                                phi_3465_ = _e2105;
                                            } else {
                                                phi_3465_ = _e2178;
                                            }
                                            let _e2269 = phi_3465_;
                                            if (_e2269 > _e2251) {
                                                phi_3470_ = _e2269;
                                            } else {
                                                phi_3470_ = _e2251;
                                            }
                                            let _e2272 = phi_3470_;
                                            if (_e2266 > _e2272) {
                                                phi_3475_ = _e2266;
                                            } else {
                                                phi_3475_ = _e2272;
                                            }
                                            let _e2275 = phi_3475_;
                                            let _e2277 = local.member_5;
                                            phi_3479_ = (_e2275 > _e2277);
                                        }
                                        let _e2280 = phi_3479_;
                                        phi_3481_ = !(_e2280);
                                        phi_3482_ = false;
                                    } else {
                                        phi_3481_ = bool();
                                        phi_3482_ = true;
                                    }
                                    let _e2283 = phi_3481_;
                                    let _e2285 = phi_3482_;
                                    phi_3483_ = _e2283;
                                    phi_3484_ = _e2285;
                                }
                                let _e2287 = phi_3483_;
                                let _e2289 = phi_3484_;
                                if _e2289 {
                                    phi_3488_ = true;
                                } else {
                                    phi_3488_ = _e2287;
                                }
                                let _e2291 = phi_3488_;
                                if _e2291 {
                                } else {
                                    local_1[_e850.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1221_ = _e848;
                            break if !(_e854);
                        }
                    }
                    let _e2294 = local_1;
                    let _e2298 = array<u32, 2>(_e2294[0][0], _e2294[0][1]);
                    let _e2302 = array<u32, 2>(_e2294[1][0], _e2294[1][1]);
                    let _e2306 = array<u32, 2>(_e2294[2][0], _e2294[2][1]);
                    let _e2310 = array<u32, 2>(_e2294[3][0], _e2294[3][1]);
                    if (_e82.member_4 > 0u) {
                        let _e2317 = a_nodes.member[_e317[0]];
                        let _e2319 = b_nodes.member[_e317[1]];
                        if _e107 {
                            if (_e317[0] == _e317[1]) {
                                if (_e2317.member_3 == 4294967295u) {
                                    phi_3598_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e2325 = a_nodes.member[_e2317.member_1];
                                    if !((_e2325.member_3 == 4294967295u)) {
                                        phi_3574_ = array<u32, 2>(_e2317.member_1, _e2317.member_1);
                                    } else {
                                        phi_3574_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e2331 = phi_3574_;
                                    let _e2337 = a_nodes.member[_e2317.member_3];
                                    if !((_e2337.member_3 == 4294967295u)) {
                                        phi_3596_ = array<u32, 2>(_e2317.member_3, _e2317.member_3);
                                    } else {
                                        phi_3596_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e2343 = phi_3596_;
                                    phi_3598_ = array<array<u32, 2>, 4>(_e2331, array<u32, 2>(_e2317.member_1, _e2317.member_3), _e2343, array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e2346 = phi_3598_;
                                phi_3599_ = _e2346;
                                phi_3600_ = false;
                            } else {
                                phi_3599_ = array<array<u32, 2>, 4>();
                                phi_3600_ = true;
                            }
                            let _e2348 = phi_3599_;
                            let _e2350 = phi_3600_;
                            phi_3601_ = _e2348;
                            phi_3602_ = _e2350;
                        } else {
                            phi_3601_ = array<array<u32, 2>, 4>();
                            phi_3602_ = true;
                        }
                        let _e2352 = phi_3601_;
                        let _e2354 = phi_3602_;
                        if _e2354 {
                            if (_e2317.member_3 == 4294967295u) {
                                phi_3614_ = false;
                            } else {
                                phi_3614_ = !((_e2319.member_3 == 4294967295u));
                            }
                            let _e2361 = phi_3614_;
                            if _e2361 {
                                if (_e135 == 1u) {
                                    phi_3622_ = false;
                                } else {
                                    phi_3622_ = true;
                                }
                                let _e2364 = phi_3622_;
                                phi_3623_ = _e2364;
                            } else {
                                phi_3623_ = true;
                            }
                            let _e2366 = phi_3623_;
                            if _e2366 {
                                if (_e2317.member_3 == 4294967295u) {
                                    phi_3635_ = false;
                                } else {
                                    phi_3635_ = !((_e2319.member_3 == 4294967295u));
                                }
                                let _e2373 = phi_3635_;
                                if _e2373 {
                                    phi_3640_ = (_e135 == 1u);
                                } else {
                                    phi_3640_ = false;
                                }
                                let _e2376 = phi_3640_;
                                if _e2376 {
                                    phi_3683_ = bool();
                                    phi_3684_ = true;
                                } else {
                                    let _e2378 = (_e2317.member_3 == 4294967295u);
                                    if _e2378 {
                                        phi_3682_ = bool();
                                    } else {
                                        if _e2373 {
                                            phi_3681_ = ((((_e2319.member_2[0] - _e2319.member[0]) * (_e2319.member_2[1] - _e2319.member[1])) * (_e2319.member_2[2] - _e2319.member[2])) > (((_e2317.member_2[0] - _e2317.member[0]) * (_e2317.member_2[1] - _e2317.member[1])) * (_e2317.member_2[2] - _e2317.member[2])));
                                        } else {
                                            phi_3681_ = false;
                                        }
                                        let _e2407 = phi_3681_;
                                        phi_3682_ = _e2407;
                                    }
                                    let _e2409 = phi_3682_;
                                    phi_3683_ = _e2409;
                                    phi_3684_ = _e2378;
                                }
                                let _e2411 = phi_3683_;
                                let _e2413 = phi_3684_;
                                if _e2413 {
                                    phi_3688_ = true;
                                } else {
                                    phi_3688_ = _e2411;
                                }
                                let _e2415 = phi_3688_;
                                phi_3690_ = !(_e2415);
                            } else {
                                phi_3690_ = true;
                            }
                            let _e2418 = phi_3690_;
                            if (_e2317.member_3 == 4294967295u) {
                                phi_3699_ = false;
                            } else {
                                phi_3699_ = !((_e2319.member_3 == 4294967295u));
                            }
                            let _e2425 = phi_3699_;
                            if _e2425 {
                                phi_3704_ = (_e135 == 1u);
                            } else {
                                phi_3704_ = false;
                            }
                            let _e2428 = phi_3704_;
                            if _e2428 {
                                phi_3747_ = bool();
                                phi_3748_ = true;
                            } else {
                                let _e2430 = (_e2317.member_3 == 4294967295u);
                                if _e2430 {
                                    phi_3746_ = bool();
                                } else {
                                    if _e2425 {
                                        phi_3745_ = ((((_e2319.member_2[0] - _e2319.member[0]) * (_e2319.member_2[1] - _e2319.member[1])) * (_e2319.member_2[2] - _e2319.member[2])) > (((_e2317.member_2[0] - _e2317.member[0]) * (_e2317.member_2[1] - _e2317.member[1])) * (_e2317.member_2[2] - _e2317.member[2])));
                                    } else {
                                        phi_3745_ = false;
                                    }
                                    let _e2459 = phi_3745_;
                                    phi_3746_ = _e2459;
                                }
                                let _e2461 = phi_3746_;
                                phi_3747_ = _e2461;
                                phi_3748_ = _e2430;
                            }
                            let _e2463 = phi_3747_;
                            let _e2465 = phi_3748_;
                            if _e2465 {
                                phi_3752_ = true;
                            } else {
                                phi_3752_ = _e2463;
                            }
                            let _e2467 = phi_3752_;
                            if _e2418 {
                                if (_e2317.member_3 == 4294967295u) {
                                    phi_3762_ = false;
                                } else {
                                    phi_3762_ = true;
                                }
                                let _e2471 = phi_3762_;
                                phi_3763_ = _e2471;
                            } else {
                                phi_3763_ = true;
                            }
                            let _e2473 = phi_3763_;
                            if _e2473 {
                                if _e2467 {
                                    if (_e2319.member_3 == 4294967295u) {
                                        phi_3775_ = false;
                                    } else {
                                        phi_3775_ = true;
                                    }
                                    let _e2477 = phi_3775_;
                                    phi_3776_ = _e2477;
                                } else {
                                    phi_3776_ = true;
                                }
                                let _e2479 = phi_3776_;
                                if _e2479 {
                                    if _e2418 {
                                        if _e2467 {
                                            phi_3799_ = array<array<u32, 2>, 4>(array<u32, 2>(_e2317.member_1, _e2319.member_1), array<u32, 2>(_e2317.member_1, _e2319.member_3), array<u32, 2>(_e2317.member_3, _e2319.member_1), array<u32, 2>(_e2317.member_3, _e2319.member_3));
                                            phi_3800_ = false;
                                        } else {
                                            phi_3799_ = array<array<u32, 2>, 4>();
                                            phi_3800_ = true;
                                        }
                                        let _e2494 = phi_3799_;
                                        let _e2496 = phi_3800_;
                                        phi_3801_ = _e2494;
                                        phi_3802_ = _e2496;
                                    } else {
                                        phi_3801_ = array<array<u32, 2>, 4>();
                                        phi_3802_ = true;
                                    }
                                    let _e2498 = phi_3801_;
                                    let _e2500 = phi_3802_;
                                    if _e2500 {
                                        if _e2418 {
                                            phi_3819_ = array<array<u32, 2>, 4>(array<u32, 2>(_e2317.member_1, _e317[1]), array<u32, 2>(_e2317.member_3, _e317[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        } else {
                                            phi_3819_ = array<array<u32, 2>, 4>(array<u32, 2>(_e317[0], _e2319.member_1), array<u32, 2>(_e317[0], _e2319.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        }
                                        let _e2512 = phi_3819_;
                                        phi_3820_ = _e2512;
                                    } else {
                                        phi_3820_ = _e2498;
                                    }
                                    let _e2514 = phi_3820_;
                                    phi_3821_ = _e2514;
                                    phi_3822_ = false;
                                } else {
                                    phi_3821_ = array<array<u32, 2>, 4>();
                                    phi_3822_ = true;
                                }
                                let _e2516 = phi_3821_;
                                let _e2518 = phi_3822_;
                                phi_3823_ = _e2516;
                                phi_3824_ = _e2518;
                            } else {
                                phi_3823_ = array<array<u32, 2>, 4>();
                                phi_3824_ = true;
                            }
                            let _e2520 = phi_3823_;
                            let _e2522 = phi_3824_;
                            phi_3828_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            phi_3829_ = _e2520;
                            phi_3830_ = _e2522;
                        } else {
                            phi_3828_ = _e2352;
                            phi_3829_ = array<array<u32, 2>, 4>();
                            phi_3830_ = true;
                        }
                        let _e2524 = phi_3828_;
                        let _e2526 = phi_3829_;
                        let _e2528 = phi_3830_;
                        if _e2528 {
                            phi_3834_ = _e2524;
                        } else {
                            phi_3834_ = _e2526;
                        }
                        let _e2530 = phi_3834_;
                        phi_3835_ = _e2530;
                    } else {
                        phi_3835_ = array<array<u32, 2>, 4>(_e2298, _e2302, _e2306, _e2310);
                    }
                    let _e2532 = phi_3835_;
                    if (_e2294[0][0] == 4294967295u) {
                        phi_3859_ = 0u;
                    } else {
                        if (_e2294[0][0] >= _e118) {
                            if (_e2294[0][1] >= _e123) {
                                phi_3853_ = false;
                            } else {
                                phi_3853_ = true;
                            }
                            let _e2538 = phi_3853_;
                            phi_3854_ = _e2538;
                        } else {
                            phi_3854_ = true;
                        }
                        let _e2540 = phi_3854_;
                        if _e2540 {
                            phi_3858_ = 1u;
                        } else {
                            phi_3858_ = 2u;
                        }
                        let _e2542 = phi_3858_;
                        phi_3859_ = _e2542;
                    }
                    let _e2544 = phi_3859_;
                    let _e2545 = type_24(_e2298, _e2544);
                    if (_e2544 == 0u) {
                        if (_e2532[0][0] != 4294967295u) {
                            phi_3871_ = type_24(_e2532[0], 3u);
                        } else {
                            phi_3871_ = _e2545;
                        }
                        let _e2551 = phi_3871_;
                        phi_3872_ = _e2551;
                    } else {
                        phi_3872_ = _e2545;
                    }
                    let _e2553 = phi_3872_;
                    if (_e2294[1][0] == 4294967295u) {
                        phi_3896_ = 0u;
                    } else {
                        if (_e2294[1][0] >= _e118) {
                            if (_e2294[1][1] >= _e123) {
                                phi_3890_ = false;
                            } else {
                                phi_3890_ = true;
                            }
                            let _e2559 = phi_3890_;
                            phi_3891_ = _e2559;
                        } else {
                            phi_3891_ = true;
                        }
                        let _e2561 = phi_3891_;
                        if _e2561 {
                            phi_3895_ = 1u;
                        } else {
                            phi_3895_ = 2u;
                        }
                        let _e2563 = phi_3895_;
                        phi_3896_ = _e2563;
                    }
                    let _e2565 = phi_3896_;
                    let _e2566 = type_24(_e2302, _e2565);
                    if (_e2565 == 0u) {
                        if (_e2532[1][0] != 4294967295u) {
                            phi_3908_ = type_24(_e2532[1], 3u);
                        } else {
                            phi_3908_ = _e2566;
                        }
                        let _e2572 = phi_3908_;
                        phi_3909_ = _e2572;
                    } else {
                        phi_3909_ = _e2566;
                    }
                    let _e2574 = phi_3909_;
                    if (_e2294[2][0] == 4294967295u) {
                        phi_3933_ = 0u;
                    } else {
                        if (_e2294[2][0] >= _e118) {
                            if (_e2294[2][1] >= _e123) {
                                phi_3927_ = false;
                            } else {
                                phi_3927_ = true;
                            }
                            let _e2580 = phi_3927_;
                            phi_3928_ = _e2580;
                        } else {
                            phi_3928_ = true;
                        }
                        let _e2582 = phi_3928_;
                        if _e2582 {
                            phi_3932_ = 1u;
                        } else {
                            phi_3932_ = 2u;
                        }
                        let _e2584 = phi_3932_;
                        phi_3933_ = _e2584;
                    }
                    let _e2586 = phi_3933_;
                    let _e2587 = type_24(_e2306, _e2586);
                    if (_e2586 == 0u) {
                        if (_e2532[2][0] != 4294967295u) {
                            phi_3945_ = type_24(_e2532[2], 3u);
                        } else {
                            phi_3945_ = _e2587;
                        }
                        let _e2593 = phi_3945_;
                        phi_3946_ = _e2593;
                    } else {
                        phi_3946_ = _e2587;
                    }
                    let _e2595 = phi_3946_;
                    if (_e2294[3][0] == 4294967295u) {
                        phi_3970_ = 0u;
                    } else {
                        if (_e2294[3][0] >= _e118) {
                            if (_e2294[3][1] >= _e123) {
                                phi_3964_ = false;
                            } else {
                                phi_3964_ = true;
                            }
                            let _e2601 = phi_3964_;
                            phi_3965_ = _e2601;
                        } else {
                            phi_3965_ = true;
                        }
                        let _e2603 = phi_3965_;
                        if _e2603 {
                            phi_3969_ = 1u;
                        } else {
                            phi_3969_ = 2u;
                        }
                        let _e2605 = phi_3969_;
                        phi_3970_ = _e2605;
                    }
                    let _e2607 = phi_3970_;
                    let _e2608 = type_24(_e2310, _e2607);
                    if (_e2607 == 0u) {
                        if (_e2532[3][0] != 4294967295u) {
                            phi_3982_ = type_24(_e2532[3], 3u);
                        } else {
                            phi_3982_ = _e2608;
                        }
                        let _e2614 = phi_3982_;
                        phi_3983_ = _e2614;
                    } else {
                        phi_3983_ = _e2608;
                    }
                    let _e2616 = phi_3983_;
                    if (_e317[0] == 4294967295u) {
                        phi_4005_ = 0u;
                    } else {
                        if (_e317[0] >= _e118) {
                            if (_e317[1] >= _e123) {
                                phi_3999_ = false;
                            } else {
                                phi_3999_ = true;
                            }
                            let _e2624 = phi_3999_;
                            phi_4000_ = _e2624;
                        } else {
                            phi_4000_ = true;
                        }
                        let _e2626 = phi_4000_;
                        if _e2626 {
                            phi_4004_ = 1u;
                        } else {
                            phi_4004_ = 2u;
                        }
                        let _e2628 = phi_4004_;
                        phi_4005_ = _e2628;
                    }
                    let _e2630 = phi_4005_;
                    if (_e2630 == 2u) {
                        phi_4011_ = type_24(_e317, 2u);
                    } else {
                        phi_4011_ = _e2553;
                    }
                    let _e2634 = phi_4011_;
                    phi_4012_ = _e2634;
                    phi_4013_ = _e2616;
                    phi_4014_ = _e2595;
                    phi_4015_ = _e2574;
                } else {
                    phi_4012_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4013_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4014_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4015_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2636 = phi_4012_;
                let _e2638 = phi_4013_;
                let _e2640 = phi_4014_;
                let _e2642 = phi_4015_;
                if (_e2636.member_1 == 1u) {
                    let _e2653 = atomicAdd((&shared_[6u]), 1u);
                    phi_4034_ = array<u32, 2>(_e2653, 0u);
                } else {
                    if (_e2636.member_1 == 2u) {
                        let _e2648 = atomicAdd((&shared_[7u]), 1u);
                        phi_4033_ = array<u32, 2>(_e2648, 0u);
                    } else {
                        phi_4033_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2651 = phi_4033_;
                    phi_4034_ = _e2651;
                }
                let _e2656 = phi_4034_;
                if (_e2636.member_1 >= 2u) {
                    if (_e82.member_4 > 0u) {
                        let _e2660 = atomicAdd((&shared_[8u]), 1u);
                        phi_4046_ = array<u32, 2>(_e2656[0], _e2660);
                    } else {
                        phi_4046_ = _e2656;
                    }
                    let _e2664 = phi_4046_;
                    phi_4047_ = _e2664;
                } else {
                    phi_4047_ = _e2656;
                }
                let _e2666 = phi_4047_;
                if (_e2642.member_1 == 1u) {
                    let _e2676 = atomicAdd((&shared_[6u]), 1u);
                    phi_4065_ = array<u32, 2>(_e2676, 0u);
                } else {
                    if (_e2642.member_1 == 2u) {
                        let _e2671 = atomicAdd((&shared_[7u]), 1u);
                        phi_4064_ = array<u32, 2>(_e2671, 0u);
                    } else {
                        phi_4064_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2674 = phi_4064_;
                    phi_4065_ = _e2674;
                }
                let _e2679 = phi_4065_;
                if (_e2642.member_1 >= 2u) {
                    if (_e82.member_4 > 0u) {
                        let _e2683 = atomicAdd((&shared_[8u]), 1u);
                        phi_4077_ = array<u32, 2>(_e2679[0], _e2683);
                    } else {
                        phi_4077_ = _e2679;
                    }
                    let _e2687 = phi_4077_;
                    phi_4078_ = _e2687;
                } else {
                    phi_4078_ = _e2679;
                }
                let _e2689 = phi_4078_;
                if (_e2640.member_1 == 1u) {
                    let _e2699 = atomicAdd((&shared_[6u]), 1u);
                    phi_4096_ = array<u32, 2>(_e2699, 0u);
                } else {
                    if (_e2640.member_1 == 2u) {
                        let _e2694 = atomicAdd((&shared_[7u]), 1u);
                        phi_4095_ = array<u32, 2>(_e2694, 0u);
                    } else {
                        phi_4095_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2697 = phi_4095_;
                    phi_4096_ = _e2697;
                }
                let _e2702 = phi_4096_;
                if (_e2640.member_1 >= 2u) {
                    if (_e82.member_4 > 0u) {
                        let _e2706 = atomicAdd((&shared_[8u]), 1u);
                        phi_4108_ = array<u32, 2>(_e2702[0], _e2706);
                    } else {
                        phi_4108_ = _e2702;
                    }
                    let _e2710 = phi_4108_;
                    phi_4109_ = _e2710;
                } else {
                    phi_4109_ = _e2702;
                }
                let _e2712 = phi_4109_;
                if (_e2638.member_1 == 1u) {
                    let _e2722 = atomicAdd((&shared_[6u]), 1u);
                    phi_4127_ = array<u32, 2>(_e2722, 0u);
                } else {
                    if (_e2638.member_1 == 2u) {
                        let _e2717 = atomicAdd((&shared_[7u]), 1u);
                        phi_4126_ = array<u32, 2>(_e2717, 0u);
                    } else {
                        phi_4126_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2720 = phi_4126_;
                    phi_4127_ = _e2720;
                }
                let _e2725 = phi_4127_;
                if (_e2638.member_1 >= 2u) {
                    if (_e82.member_4 > 0u) {
                        let _e2729 = atomicAdd((&shared_[8u]), 1u);
                        phi_4139_ = array<u32, 2>(_e2725[0], _e2729);
                    } else {
                        phi_4139_ = _e2725;
                    }
                    let _e2733 = phi_4139_;
                    phi_4140_ = _e2733;
                } else {
                    phi_4140_ = _e2725;
                }
                let _e2735 = phi_4140_;
                workgroupBarrier();
                if (_e72 == 0u) {
                    let _e2738 = atomicLoad((&shared_[6u]));
                    let _e2740 = atomicLoad((&shared_[7u]));
                    let _e2742 = atomicLoad((&shared_[8u]));
                    let _e2744 = atomicLoad((&shared_[1u]));
                    let _e2746 = atomicLoad((&shared_[2u]));
                    let _e2748 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2748 + 1u));
                    let _e2752 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2752 + _e2744) + _e2746));
                    let _e2757 = atomicLoad((&shared_[0u]));
                    let _e2758 = (_e2757 - _e2744);
                    let _e2760 = (_e82.member_10 - _e2758);
                    if (_e2760 < _e2738) {
                        phi_4173_ = _e2760;
                    } else {
                        phi_4173_ = _e2738;
                    }
                    let _e2763 = phi_4173_;
                    atomicStore((&shared_[9u]), _e2758);
                    atomicStore((&shared_[10u]), _e2763);
                    atomicStore((&shared_[0u]), (_e2758 + _e2763));
                    if (_e2738 > _e2763) {
                        let _e2769 = (_e2738 - _e2763);
                        if (_e82.member_12 == 0u) {
                        } else {
                            let _e2773 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2776 = atomicAdd((&control.member[(_e90 + 1u)]), _e2769);
                        let _e2779 = atomicMax((&nodes.member[0u]), (_e2776 + _e2769));
                        if ((_e2776 + _e2769) < _e2776) {
                            let _e2783 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2776);
                    }
                    if (_e2740 > 0u) {
                        let _e2787 = atomicAdd((&pairs.member[0u]), _e2740);
                        if ((_e2787 + _e2740) < _e2787) {
                            let _e2791 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2787);
                    }
                    if (_e2742 > 0u) {
                        let _e2795 = atomicAdd((&control.member[1537u]), _e2742);
                        if ((_e2795 + _e2742) < _e2795) {
                            let _e2799 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2795);
                    }
                }
                workgroupBarrier();
                if (_e2636.member_1 == 1u) {
                    let _e2866 = atomicLoad((&shared_[10u]));
                    if (_e2666[0] < _e2866) {
                        let _e2888 = atomicLoad((&shared_[9u]));
                        let _e2891 = (2u * (_e2888 + _e2666[0]));
                        stack[_e2891] = _e2636.member[0];
                        stack[(_e2891 + 1u)] = _e2636.member[1];
                    } else {
                        let _e2870 = atomicLoad((&shared_[11u]));
                        let _e2873 = ((_e2870 + _e2666[0]) - _e2866);
                        let _e2876 = params.member.member_2.member_3;
                        if (_e2873 < _e2876) {
                            let _e2878 = (_e105 + _e2873);
                            if (_e2878 < 4294967295u) {
                                let _e2882 = (2u * _e2878);
                                atomicStore((&nodes.member[(4u + _e2882)]), _e2636.member[0]);
                                atomicStore((&nodes.member[(_e2882 + 5u)]), _e2636.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2636.member_1 == 0u) {
                    } else {
                        if (_e2636.member_1 == 2u) {
                            let _e2808 = a_nodes.member[_e2636.member[0]];
                            let _e2812 = b_nodes.member[_e2636.member[1]];
                            let _e2816 = params.member.member_2.member;
                            if (_e2816 == 1u) {
                                if (_e2808.member_1 < _e2812.member_1) {
                                    phi_4335_ = type_12(_e2808.member_1, _e2812.member_1);
                                } else {
                                    phi_4335_ = type_12(_e2812.member_1, _e2808.member_1);
                                }
                                let _e2823 = phi_4335_;
                                phi_4340_ = _e2823;
                            } else {
                                phi_4340_ = type_12(_e2808.member_1, _e2812.member_1);
                            }
                            let _e2825 = phi_4340_;
                            let _e2828 = params.member.member_1.member_3;
                            let _e2830 = atomicLoad((&shared_[12u]));
                            let _e2832 = (_e2830 + _e2666[0]);
                            if (_e2832 < _e2828) {
                                let _e2836 = (2u * _e2832);
                                atomicStore((&pairs.member[(4u + _e2836)]), _e2825.member);
                                atomicStore((&pairs.member[(_e2836 + 5u)]), _e2825.member_1);
                            }
                        }
                        let _e2843 = params.member.member_2.member_4;
                        if (_e2843 > 0u) {
                            let _e2847 = atomicLoad((&shared_[13u]));
                            let _e2849 = (_e2847 + _e2666[1]);
                            let _e2851 = params.member.member_2.member_4;
                            if (_e2849 < _e2851) {
                                let _e2854 = params.member.member_2.member_5;
                                let _e2856 = params.member.member_2.member_4;
                                let _e2859 = (2u * ((_e2854 * _e2856) + _e2849));
                                front.member[_e2859] = _e2636.member[0];
                                front.member[(_e2859 + 1u)] = _e2636.member[1];
                            }
                        }
                    }
                }
                if (_e2642.member_1 == 1u) {
                    let _e2962 = atomicLoad((&shared_[10u]));
                    if (_e2689[0] < _e2962) {
                        let _e2984 = atomicLoad((&shared_[9u]));
                        let _e2987 = (2u * (_e2984 + _e2689[0]));
                        stack[_e2987] = _e2642.member[0];
                        stack[(_e2987 + 1u)] = _e2642.member[1];
                    } else {
                        let _e2966 = atomicLoad((&shared_[11u]));
                        let _e2969 = ((_e2966 + _e2689[0]) - _e2962);
                        let _e2972 = params.member.member_2.member_3;
                        if (_e2969 < _e2972) {
                            let _e2974 = (_e105 + _e2969);
                            if (_e2974 < 4294967295u) {
                                let _e2978 = (2u * _e2974);
                                atomicStore((&nodes.member[(4u + _e2978)]), _e2642.member[0]);
                                atomicStore((&nodes.member[(_e2978 + 5u)]), _e2642.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2642.member_1 == 0u) {
                    } else {
                        if (_e2642.member_1 == 2u) {
                            let _e2904 = a_nodes.member[_e2642.member[0]];
                            let _e2908 = b_nodes.member[_e2642.member[1]];
                            let _e2912 = params.member.member_2.member;
                            if (_e2912 == 1u) {
                                if (_e2904.member_1 < _e2908.member_1) {
                                    phi_4487_ = type_12(_e2904.member_1, _e2908.member_1);
                                } else {
                                    phi_4487_ = type_12(_e2908.member_1, _e2904.member_1);
                                }
                                let _e2919 = phi_4487_;
                                phi_4492_ = _e2919;
                            } else {
                                phi_4492_ = type_12(_e2904.member_1, _e2908.member_1);
                            }
                            let _e2921 = phi_4492_;
                            let _e2924 = params.member.member_1.member_3;
                            let _e2926 = atomicLoad((&shared_[12u]));
                            let _e2928 = (_e2926 + _e2689[0]);
                            if (_e2928 < _e2924) {
                                let _e2932 = (2u * _e2928);
                                atomicStore((&pairs.member[(4u + _e2932)]), _e2921.member);
                                atomicStore((&pairs.member[(_e2932 + 5u)]), _e2921.member_1);
                            }
                        }
                        let _e2939 = params.member.member_2.member_4;
                        if (_e2939 > 0u) {
                            let _e2943 = atomicLoad((&shared_[13u]));
                            let _e2945 = (_e2943 + _e2689[1]);
                            let _e2947 = params.member.member_2.member_4;
                            if (_e2945 < _e2947) {
                                let _e2950 = params.member.member_2.member_5;
                                let _e2952 = params.member.member_2.member_4;
                                let _e2955 = (2u * ((_e2950 * _e2952) + _e2945));
                                front.member[_e2955] = _e2642.member[0];
                                front.member[(_e2955 + 1u)] = _e2642.member[1];
                            }
                        }
                    }
                }
                if (_e2640.member_1 == 1u) {
                    let _e3058 = atomicLoad((&shared_[10u]));
                    if (_e2712[0] < _e3058) {
                        let _e3080 = atomicLoad((&shared_[9u]));
                        let _e3083 = (2u * (_e3080 + _e2712[0]));
                        stack[_e3083] = _e2640.member[0];
                        stack[(_e3083 + 1u)] = _e2640.member[1];
                    } else {
                        let _e3062 = atomicLoad((&shared_[11u]));
                        let _e3065 = ((_e3062 + _e2712[0]) - _e3058);
                        let _e3068 = params.member.member_2.member_3;
                        if (_e3065 < _e3068) {
                            let _e3070 = (_e105 + _e3065);
                            if (_e3070 < 4294967295u) {
                                let _e3074 = (2u * _e3070);
                                atomicStore((&nodes.member[(4u + _e3074)]), _e2640.member[0]);
                                atomicStore((&nodes.member[(_e3074 + 5u)]), _e2640.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2640.member_1 == 0u) {
                    } else {
                        if (_e2640.member_1 == 2u) {
                            let _e3000 = a_nodes.member[_e2640.member[0]];
                            let _e3004 = b_nodes.member[_e2640.member[1]];
                            let _e3008 = params.member.member_2.member;
                            if (_e3008 == 1u) {
                                if (_e3000.member_1 < _e3004.member_1) {
                                    phi_4639_ = type_12(_e3000.member_1, _e3004.member_1);
                                } else {
                                    phi_4639_ = type_12(_e3004.member_1, _e3000.member_1);
                                }
                                let _e3015 = phi_4639_;
                                phi_4644_ = _e3015;
                            } else {
                                phi_4644_ = type_12(_e3000.member_1, _e3004.member_1);
                            }
                            let _e3017 = phi_4644_;
                            let _e3020 = params.member.member_1.member_3;
                            let _e3022 = atomicLoad((&shared_[12u]));
                            let _e3024 = (_e3022 + _e2712[0]);
                            if (_e3024 < _e3020) {
                                let _e3028 = (2u * _e3024);
                                atomicStore((&pairs.member[(4u + _e3028)]), _e3017.member);
                                atomicStore((&pairs.member[(_e3028 + 5u)]), _e3017.member_1);
                            }
                        }
                        let _e3035 = params.member.member_2.member_4;
                        if (_e3035 > 0u) {
                            let _e3039 = atomicLoad((&shared_[13u]));
                            let _e3041 = (_e3039 + _e2712[1]);
                            let _e3043 = params.member.member_2.member_4;
                            if (_e3041 < _e3043) {
                                let _e3046 = params.member.member_2.member_5;
                                let _e3048 = params.member.member_2.member_4;
                                let _e3051 = (2u * ((_e3046 * _e3048) + _e3041));
                                front.member[_e3051] = _e2640.member[0];
                                front.member[(_e3051 + 1u)] = _e2640.member[1];
                            }
                        }
                    }
                }
                if (_e2638.member_1 == 1u) {
                    let _e3154 = atomicLoad((&shared_[10u]));
                    if (_e2735[0] < _e3154) {
                        let _e3176 = atomicLoad((&shared_[9u]));
                        let _e3179 = (2u * (_e3176 + _e2735[0]));
                        stack[_e3179] = _e2638.member[0];
                        stack[(_e3179 + 1u)] = _e2638.member[1];
                    } else {
                        let _e3158 = atomicLoad((&shared_[11u]));
                        let _e3161 = ((_e3158 + _e2735[0]) - _e3154);
                        let _e3164 = params.member.member_2.member_3;
                        if (_e3161 < _e3164) {
                            let _e3166 = (_e105 + _e3161);
                            if (_e3166 < 4294967295u) {
                                let _e3170 = (2u * _e3166);
                                atomicStore((&nodes.member[(4u + _e3170)]), _e2638.member[0]);
                                atomicStore((&nodes.member[(_e3170 + 5u)]), _e2638.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2638.member_1 == 0u) {
                    } else {
                        if (_e2638.member_1 == 2u) {
                            let _e3096 = a_nodes.member[_e2638.member[0]];
                            let _e3100 = b_nodes.member[_e2638.member[1]];
                            let _e3104 = params.member.member_2.member;
                            if (_e3104 == 1u) {
                                if (_e3096.member_1 < _e3100.member_1) {
                                    phi_4791_ = type_12(_e3096.member_1, _e3100.member_1);
                                } else {
                                    phi_4791_ = type_12(_e3100.member_1, _e3096.member_1);
                                }
                                let _e3111 = phi_4791_;
                                phi_4796_ = _e3111;
                            } else {
                                phi_4796_ = type_12(_e3096.member_1, _e3100.member_1);
                            }
                            let _e3113 = phi_4796_;
                            let _e3116 = params.member.member_1.member_3;
                            let _e3118 = atomicLoad((&shared_[12u]));
                            let _e3120 = (_e3118 + _e2735[0]);
                            if (_e3120 < _e3116) {
                                let _e3124 = (2u * _e3120);
                                atomicStore((&pairs.member[(4u + _e3124)]), _e3113.member);
                                atomicStore((&pairs.member[(_e3124 + 5u)]), _e3113.member_1);
                            }
                        }
                        let _e3131 = params.member.member_2.member_4;
                        if (_e3131 > 0u) {
                            let _e3135 = atomicLoad((&shared_[13u]));
                            let _e3137 = (_e3135 + _e2735[1]);
                            let _e3139 = params.member.member_2.member_4;
                            if (_e3137 < _e3139) {
                                let _e3142 = params.member.member_2.member_5;
                                let _e3144 = params.member.member_2.member_4;
                                let _e3147 = (2u * ((_e3142 * _e3144) + _e3137));
                                front.member[_e3147] = _e2638.member[0];
                                front.member[(_e3147 + 1u)] = _e2638.member[1];
                            }
                        }
                    }
                }
                phi_4849_ = true;
            }
            let _e3186 = phi_4849_;
            phi_4850_ = _e3186;
        } else {
            phi_4850_ = false;
        }
        let _e3188 = phi_4850_;
        continue;
        continuing {
            phi_249_ = _e156;
            break if !(_e3188);
        }
    }
    if (_e72 == 0u) {
        if (_e82.member_6 == 0u) {
            if (_e87 < _e102) {
                phi_4869_ = ((((_e102 - 1u) - _e87) >> bitcast<u32>((_e97 & 31u))) + 1u);
            } else {
                phi_4869_ = 0u;
            }
            let _e3201 = phi_4869_;
            let _e3203 = atomicLoad((&shared_[5u]));
            phi_4873_ = (_e3201 - _e3203);
        } else {
            phi_4873_ = 0u;
        }
        let _e3206 = phi_4873_;
        atomicStore((&shared_[14u]), _e3206);
        let _e3209 = atomicLoad((&shared_[0u]));
        let _e3210 = (_e3209 + _e3206);
        if (_e3210 > 0u) {
            if (_e82.member_12 == 0u) {
            } else {
                let _e3215 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e3218 = atomicAdd((&control.member[(_e90 + 1u)]), _e3210);
            let _e3221 = atomicMax((&nodes.member[0u]), (_e3218 + _e3210));
            if ((_e3218 + _e3210) < _e3218) {
                let _e3225 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e3218);
        }
        let _e3230 = atomicLoad((&shared_[15u]));
        let _e3232 = atomicAdd((&control.member[(1540u + (2u * _e87))]), _e3230);
        let _e3236 = atomicLoad((&shared_[16u]));
        let _e3238 = atomicAdd((&control.member[((2u * _e87) + 1541u)]), _e3236);
    }
    workgroupBarrier();
    let _e3240 = atomicLoad((&shared_[0u]));
    let _e3242 = atomicLoad((&shared_[17u]));
    let _e3244 = atomicLoad((&shared_[14u]));
    phi_4930_ = type_12(0u, 8u);
    loop {
        let _e3246 = phi_4930_;
        if (_e3246.member < _e3246.member_1) {
            phi_4931_ = type_12((_e3246.member + 1u), _e3246.member_1);
            phi_4954_ = type_12(1u, _e3246.member);
        } else {
            phi_4931_ = _e3246;
            phi_4954_ = type_12(0u, type_12().member_1);
        }
        let _e3258 = phi_4931_;
        let _e3260 = phi_4954_;
        let _e3264 = (bitcast<i32>(_e3260.member) != 0i);
        if _e3264 {
            let _e3266 = ((_e3260.member_1 * 128u) + _e72);
            if (_e3266 < _e3240) {
                let _e3270 = stack[(2u * _e3266)];
                let _e3274 = stack[((2u * _e3266) + 1u)];
                let _e3275 = (_e3242 + _e3266);
                if (_e3275 < _e82.member_3) {
                    let _e3278 = (_e105 + _e3275);
                    if (_e3278 < 4294967295u) {
                        let _e3280 = (2u * _e3278);
                        atomicStore((&nodes.member[(4u + _e3280)]), _e3270);
                        atomicStore((&nodes.member[(_e3280 + 5u)]), _e3274);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4930_ = _e3258;
            break if !(_e3264);
        }
    }
    let _e3287 = atomicLoad((&shared_[5u]));
    let _e3288 = (_e3244 / 128u);
    if ((_e3244 % 128u) > 0u) {
        phi_5010_ = (_e3288 + 1u);
    } else {
        phi_5010_ = _e3288;
    }
    let _e3293 = phi_5010_;
    phi_5013_ = type_12(0u, _e3293);
    loop {
        let _e3296 = phi_5013_;
        if (_e3296.member < _e3296.member_1) {
            phi_5014_ = type_12((_e3296.member + 1u), _e3296.member_1);
            phi_5037_ = type_12(1u, _e3296.member);
        } else {
            phi_5014_ = _e3296;
            phi_5037_ = type_12(0u, type_12().member_1);
        }
        let _e3308 = phi_5014_;
        let _e3310 = phi_5037_;
        let _e3314 = (bitcast<i32>(_e3310.member) != 0i);
        if _e3314 {
            let _e3316 = ((_e3310.member_1 * 128u) + _e72);
            if (_e3316 < _e3244) {
                let _e3324 = (2u * ((_e103 + _e87) + ((_e3287 + _e3316) << bitcast<u32>((_e97 & 31u)))));
                let _e3327 = atomicLoad((&nodes.member[(4u + _e3324)]));
                let _e3330 = atomicLoad((&nodes.member[(_e3324 + 5u)]));
                let _e3332 = ((_e3242 + _e3240) + _e3316);
                if (_e3332 < _e82.member_3) {
                    let _e3335 = (_e105 + _e3332);
                    if (_e3335 < 4294967295u) {
                        let _e3337 = (2u * _e3335);
                        atomicStore((&nodes.member[(4u + _e3337)]), _e3327);
                        atomicStore((&nodes.member[(_e3337 + 5u)]), _e3330);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5013_ = _e3308;
            break if !(_e3314);
        }
    }
    if (_e82.member_6 == 1u) {
        if (_e3287 == 0u) {
            phi_5109_ = type_12(0u, _e102);
            loop {
                let _e3348 = phi_5109_;
                if (_e3348.member < _e3348.member_1) {
                    phi_5110_ = type_12((_e3348.member + 1u), _e3348.member_1);
                    phi_5133_ = type_12(1u, _e3348.member);
                } else {
                    phi_5110_ = _e3348;
                    phi_5133_ = type_12(0u, type_12().member_1);
                }
                let _e3360 = phi_5110_;
                let _e3362 = phi_5133_;
                if (bitcast<i32>(_e3362.member) != 0i) {
                    let _e3368 = atomicAdd((&control.member[(512u + _e90)]), 1u);
                    if (_e3368 >= _e102) {
                        phi_5213_ = false;
                    } else {
                        let _e3371 = (2u * (_e103 + _e3368));
                        let _e3374 = atomicLoad((&nodes.member[(4u + _e3371)]));
                        let _e3377 = atomicLoad((&nodes.member[(_e3371 + 5u)]));
                        if (_e82.member_12 == 0u) {
                        } else {
                            let _e3381 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3384 = atomicAdd((&control.member[(_e90 + 1u)]), 1u);
                        let _e3387 = atomicMax((&nodes.member[0u]), (_e3384 + 1u));
                        if ((_e3384 + 1u) < _e3384) {
                            let _e3391 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3384 < _e82.member_3) {
                            let _e3394 = (_e105 + _e3384);
                            if (_e3394 < 4294967295u) {
                                let _e3396 = (2u * _e3394);
                                atomicStore((&nodes.member[(4u + _e3396)]), _e3374);
                                atomicStore((&nodes.member[(_e3396 + 5u)]), _e3377);
                            }
                        }
                        phi_5213_ = true;
                    }
                    let _e3402 = phi_5213_;
                    phi_5214_ = _e3402;
                } else {
                    phi_5214_ = false;
                }
                let _e3404 = phi_5214_;
                continue;
                continuing {
                    phi_5109_ = _e3360;
                    break if !(_e3404);
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
