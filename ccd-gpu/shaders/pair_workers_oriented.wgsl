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

struct type_23 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_25 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_27 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_30 {
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
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> a_nodes: type_18;
@group(0) @binding(2) 
var<storage> b_nodes: type_18;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_35;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(3) 
var<storage> oriented: type_29;
@group(0) @binding(4) 
var<storage, read_write> control: type_35;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_35;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_25;
    var local_1: array<array<u32, 2>, 4>;
    var phi_184_: u32;
    var phi_201_: type_9;
    var phi_202_: type_9;
    var phi_225_: type_9;
    var phi_243_: u32;
    var phi_273_: bool;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_333_: u32;
    var phi_338_: u32;
    var phi_343_: u32;
    var phi_352_: u32;
    var phi_358_: u32;
    var phi_364_: u32;
    var phi_305_: u32;
    var phi_311_: u32;
    var phi_365_: u32;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_386_: u32;
    var phi_387_: u32;
    var phi_456_: array<u32, 2>;
    var phi_457_: array<u32, 2>;
    var phi_471_: array<u32, 2>;
    var phi_497_: u32;
    var phi_567_: array<u32, 2>;
    var phi_581_: array<u32, 2>;
    var phi_618_: array<u32, 2>;
    var phi_620_: type_23;
    var phi_621_: type_23;
    var phi_622_: bool;
    var phi_623_: type_23;
    var phi_624_: bool;
    var phi_640_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_795_: array<u32, 2>;
    var phi_824_: array<u32, 2>;
    var phi_853_: array<u32, 2>;
    var phi_882_: array<u32, 2>;
    var phi_884_: type_23;
    var phi_885_: bool;
    var phi_886_: type_23;
    var phi_887_: bool;
    var phi_1060_: array<u32, 2>;
    var phi_1092_: array<u32, 2>;
    var phi_960_: array<u32, 2>;
    var phi_992_: array<u32, 2>;
    var phi_1094_: type_23;
    var phi_1095_: type_23;
    var phi_1096_: type_23;
    var phi_1097_: bool;
    var phi_1098_: type_23;
    var phi_1099_: type_23;
    var phi_1100_: bool;
    var phi_1104_: type_23;
    var phi_1119_: array<u32, 2>;
    var phi_1147_: array<u32, 2>;
    var phi_1185_: type_9;
    var phi_1186_: type_9;
    var phi_1209_: type_9;
    var phi_1238_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1324_: f32;
    var phi_1330_: f32;
    var phi_1336_: f32;
    var phi_1342_: f32;
    var phi_1348_: f32;
    var phi_1354_: f32;
    var phi_1372_: f32;
    var phi_1377_: f32;
    var phi_1382_: f32;
    var phi_1398_: type_30;
    var phi_1468_: f32;
    var phi_1474_: f32;
    var phi_1480_: f32;
    var phi_1486_: f32;
    var phi_1492_: f32;
    var phi_1498_: f32;
    var phi_1516_: f32;
    var phi_1521_: f32;
    var phi_1526_: f32;
    var phi_1542_: type_30;
    var phi_1732_: f32;
    var phi_1738_: f32;
    var phi_1745_: f32;
    var phi_1754_: f32;
    var phi_1761_: f32;
    var phi_1769_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1793_: f32;
    var phi_1886_: f32;
    var phi_1893_: f32;
    var phi_1899_: f32;
    var phi_1905_: f32;
    var phi_1924_: f32;
    var phi_1931_: f32;
    var phi_1937_: f32;
    var phi_1943_: f32;
    var phi_1962_: f32;
    var phi_1969_: f32;
    var phi_1975_: f32;
    var phi_1981_: f32;
    var phi_2000_: f32;
    var phi_2007_: f32;
    var phi_2013_: f32;
    var phi_2019_: f32;
    var phi_2038_: f32;
    var phi_2045_: f32;
    var phi_2051_: f32;
    var phi_2057_: f32;
    var phi_2076_: f32;
    var phi_2083_: f32;
    var phi_2089_: f32;
    var phi_2095_: f32;
    var phi_2110_: f32;
    var phi_2115_: f32;
    var phi_2120_: f32;
    var phi_2125_: f32;
    var phi_2130_: f32;
    var phi_2189_: f32;
    var phi_2212_: f32;
    var phi_2235_: f32;
    var phi_2257_: f32;
    var phi_2273_: f32;
    var phi_2328_: f32;
    var phi_2351_: f32;
    var phi_2374_: f32;
    var phi_2396_: f32;
    var phi_2412_: f32;
    var phi_2467_: f32;
    var phi_2490_: f32;
    var phi_2513_: f32;
    var phi_2535_: f32;
    var phi_2551_: f32;
    var phi_2606_: f32;
    var phi_2629_: f32;
    var phi_2653_: f32;
    var phi_2676_: f32;
    var phi_2692_: f32;
    var phi_2747_: f32;
    var phi_2770_: f32;
    var phi_2794_: f32;
    var phi_2817_: f32;
    var phi_2833_: f32;
    var phi_2888_: f32;
    var phi_2911_: f32;
    var phi_2935_: f32;
    var phi_2958_: f32;
    var phi_2974_: f32;
    var phi_3029_: f32;
    var phi_3052_: f32;
    var phi_3076_: f32;
    var phi_3099_: f32;
    var phi_3115_: f32;
    var phi_3170_: f32;
    var phi_3193_: f32;
    var phi_3217_: f32;
    var phi_3240_: f32;
    var phi_3256_: f32;
    var phi_3311_: f32;
    var phi_3334_: f32;
    var phi_3358_: f32;
    var phi_3381_: f32;
    var phi_3397_: f32;
    var phi_3404_: f32;
    var phi_3409_: f32;
    var phi_3414_: f32;
    var phi_3419_: f32;
    var phi_3424_: f32;
    var phi_3429_: f32;
    var phi_3434_: f32;
    var phi_3439_: f32;
    var phi_3443_: bool;
    var phi_3445_: bool;
    var phi_3446_: bool;
    var phi_3447_: bool;
    var phi_3448_: bool;
    var phi_3452_: bool;
    var phi_3488_: array<array<u32, 2>, 4>;
    var phi_3506_: bool;
    var phi_3507_: bool;
    var phi_3511_: u32;
    var phi_3512_: u32;
    var phi_3524_: type_32;
    var phi_3525_: type_32;
    var phi_3543_: bool;
    var phi_3544_: bool;
    var phi_3548_: u32;
    var phi_3549_: u32;
    var phi_3561_: type_32;
    var phi_3562_: type_32;
    var phi_3580_: bool;
    var phi_3581_: bool;
    var phi_3585_: u32;
    var phi_3586_: u32;
    var phi_3598_: type_32;
    var phi_3599_: type_32;
    var phi_3617_: bool;
    var phi_3618_: bool;
    var phi_3622_: u32;
    var phi_3623_: u32;
    var phi_3635_: type_32;
    var phi_3636_: type_32;
    var phi_3652_: bool;
    var phi_3653_: bool;
    var phi_3657_: u32;
    var phi_3658_: u32;
    var phi_3664_: type_32;
    var phi_3665_: type_32;
    var phi_3666_: type_32;
    var phi_3667_: type_32;
    var phi_3668_: type_32;
    var phi_3687_: array<u32, 2>;
    var phi_3688_: array<u32, 2>;
    var phi_3700_: array<u32, 2>;
    var phi_3701_: array<u32, 2>;
    var phi_3718_: array<u32, 2>;
    var phi_3719_: array<u32, 2>;
    var phi_3731_: array<u32, 2>;
    var phi_3732_: array<u32, 2>;
    var phi_3749_: array<u32, 2>;
    var phi_3750_: array<u32, 2>;
    var phi_3762_: array<u32, 2>;
    var phi_3763_: array<u32, 2>;
    var phi_3780_: array<u32, 2>;
    var phi_3781_: array<u32, 2>;
    var phi_3793_: array<u32, 2>;
    var phi_3794_: array<u32, 2>;
    var phi_3827_: u32;
    var phi_3987_: type_9;
    var phi_3992_: type_9;
    var phi_4128_: type_9;
    var phi_4133_: type_9;
    var phi_4269_: type_9;
    var phi_4274_: type_9;
    var phi_4410_: type_9;
    var phi_4415_: type_9;
    var phi_4459_: bool;
    var phi_4460_: bool;
    var phi_4479_: u32;
    var phi_4483_: u32;
    var phi_4540_: type_9;
    var phi_4541_: type_9;
    var phi_4564_: type_9;
    var phi_4620_: u32;
    var phi_4623_: type_9;
    var phi_4624_: type_9;
    var phi_4647_: type_9;
    var phi_4719_: type_9;
    var phi_4720_: type_9;
    var phi_4743_: type_9;
    var phi_4823_: bool;
    var phi_4824_: bool;
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
    let _e90 = params.member.member_1.member_1;
    let _e92 = (_e90 % 2u);
    let _e95 = atomicLoad((&control.member[_e90]));
    if (_e87.member_3 < _e95) {
        phi_184_ = _e87.member_3;
    } else {
        phi_184_ = _e95;
    }
    let _e98 = phi_184_;
    let _e99 = (_e92 * _e87.member_3);
    let _e101 = ((1u - _e92) * _e87.member_3);
    let _e103 = params.member.member_1.member_3;
    if (_e72 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_201_ = type_9(0u, _e87.member_11);
    loop {
        let _e112 = phi_201_;
        if (_e112.member < _e112.member_1) {
            phi_202_ = type_9((_e112.member + 1u), _e112.member_1);
            phi_225_ = type_9(1u, _e112.member);
        } else {
            phi_202_ = _e112;
            phi_225_ = type_9(0u, type_9().member_1);
        }
        let _e124 = phi_202_;
        let _e126 = phi_225_;
        if (bitcast<i32>(_e126.member) != 0i) {
            if (_e72 == 0u) {
                let _e133 = atomicLoad((&shared_[0u]));
                if (128u < _e133) {
                    phi_243_ = 128u;
                } else {
                    phi_243_ = _e133;
                }
                let _e136 = phi_243_;
                if (_e87.member_9 > 0u) {
                    if (_e126.member_1 >= 16u) {
                        let _e142 = atomicLoad((&control.member[(1024u + _e90)]));
                        if (_e87.member_9 > 0u) {
                            phi_273_ = ((_e142 * 100u) >= (_e87.member_9 << bitcast<u32>((_e87.member_7 & 31u))));
                        } else {
                            phi_273_ = false;
                        }
                        let _e151 = phi_273_;
                        if _e151 {
                            phi_277_ = 2u;
                        } else {
                            phi_277_ = 0u;
                        }
                        let _e153 = phi_277_;
                        phi_278_ = _e153;
                    } else {
                        phi_278_ = 0u;
                    }
                    let _e155 = phi_278_;
                    phi_279_ = _e155;
                } else {
                    phi_279_ = 0u;
                }
                let _e157 = phi_279_;
                let _e158 = (128u - _e136);
                if (_e157 == 0u) {
                    if (_e158 > 0u) {
                        let _e162 = atomicLoad((&shared_[5u]));
                        if (_e87.member_6 == 0u) {
                            if (_e85 < _e98) {
                                phi_305_ = ((((_e98 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
                            } else {
                                phi_305_ = 0u;
                            }
                            let _e205 = phi_305_;
                            let _e206 = (_e205 - _e162);
                            if (_e158 < _e206) {
                                phi_311_ = _e158;
                            } else {
                                phi_311_ = _e206;
                            }
                            let _e209 = phi_311_;
                            atomicStore((&shared_[3u]), (_e85 + (_e162 << bitcast<u32>((_e87.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e87.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e162 + _e209));
                            phi_365_ = _e209;
                        } else {
                            if (_e162 == 0u) {
                                let _e170 = (_e98 >> bitcast<u32>(((_e87.member_7 + 2u) & 31u)));
                                if (_e87.member_8 < _e170) {
                                    phi_333_ = _e170;
                                } else {
                                    phi_333_ = _e87.member_8;
                                }
                                let _e173 = phi_333_;
                                if (128u < _e173) {
                                    phi_338_ = 128u;
                                } else {
                                    phi_338_ = _e173;
                                }
                                let _e176 = phi_338_;
                                if (_e158 < _e176) {
                                    phi_343_ = _e158;
                                } else {
                                    phi_343_ = _e176;
                                }
                                let _e179 = phi_343_;
                                let _e182 = atomicAdd((&control.member[(512u + _e90)]), _e179);
                                if (_e98 < _e182) {
                                    phi_352_ = _e98;
                                } else {
                                    phi_352_ = _e182;
                                }
                                let _e185 = phi_352_;
                                let _e186 = (_e98 - _e185);
                                if (_e179 < _e186) {
                                    phi_358_ = _e179;
                                } else {
                                    phi_358_ = _e186;
                                }
                                let _e189 = phi_358_;
                                atomicStore((&shared_[3u]), _e182);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e189 < _e179)));
                                phi_364_ = _e189;
                            } else {
                                phi_364_ = 0u;
                            }
                            let _e196 = phi_364_;
                            phi_365_ = _e196;
                        }
                        let _e222 = phi_365_;
                        phi_366_ = _e222;
                    } else {
                        phi_366_ = 0u;
                    }
                    let _e224 = phi_366_;
                    phi_367_ = _e224;
                } else {
                    phi_367_ = 0u;
                }
                let _e226 = phi_367_;
                if (_e157 == 0u) {
                    if ((_e136 + _e226) == 0u) {
                        if (_e87.member_9 > 0u) {
                            let _e234 = atomicAdd((&control.member[(1024u + _e90)]), 1u);
                        }
                        phi_386_ = 1u;
                    } else {
                        phi_386_ = _e157;
                    }
                    let _e236 = phi_386_;
                    phi_387_ = _e236;
                } else {
                    phi_387_ = _e157;
                }
                let _e238 = phi_387_;
                atomicStore((&shared_[1u]), _e136);
                atomicStore((&shared_[2u]), _e226);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e238;
            }
            let _e246 = workgroupUniformLoad((&state[0u]));
            if (_e246 != 0u) {
                phi_4459_ = false;
            } else {
                let _e249 = atomicLoad((&shared_[1u]));
                let _e251 = atomicLoad((&shared_[2u]));
                if (_e72 < _e249) {
                    let _e274 = atomicLoad((&shared_[0u]));
                    let _e277 = (2u * ((_e274 - 1u) - _e72));
                    let _e279 = stack[_e277];
                    let _e282 = stack[(_e277 + 1u)];
                    phi_457_ = array<u32, 2>(_e279, _e282);
                } else {
                    if (_e72 < (_e249 + _e251)) {
                        let _e256 = atomicLoad((&shared_[3u]));
                        let _e259 = atomicLoad((&shared_[4u]));
                        let _e263 = (2u * (_e99 + (_e256 + ((_e72 - _e249) * _e259))));
                        let _e266 = atomicLoad((&nodes.member[(4u + _e263)]));
                        let _e269 = atomicLoad((&nodes.member[(_e263 + 5u)]));
                        phi_456_ = array<u32, 2>(_e266, _e269);
                    } else {
                        phi_456_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e272 = phi_456_;
                    phi_457_ = _e272;
                }
                let _e285 = phi_457_;
                let _e288 = params.member.member_2.member;
                let _e292 = params.member.member_2.member;
                if (_e292 == 0u) {
                    phi_471_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_471_ = array<u32, 2>(1u, 1u);
                }
                let _e295 = phi_471_;
                let _e301 = params.member.member.member[_e295[0]];
                let _e302 = (_e301 - 1u);
                let _e306 = params.member.member.member[_e295[1]];
                let _e307 = (_e306 - 1u);
                let _e310 = params.member.member_2.member_1;
                if (_e310 == 0u) {
                    phi_497_ = 1u;
                } else {
                    phi_497_ = 0u;
                }
                let _e313 = phi_497_;
                if (_e285[0] != 4294967295u) {
                    let _e319 = a_nodes.member[_e285[0]];
                    let _e321 = b_nodes.member[_e285[1]];
                    if (_e288 == 1u) {
                        if (_e285[0] == _e285[1]) {
                            if (_e319.member_3 == 4294967295u) {
                                phi_620_ = type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e327 = a_nodes.member[_e319.member_1];
                                let _e330 = a_nodes.member[_e319.member_3];
                                if !((_e327.member_3 == 4294967295u)) {
                                    phi_567_ = array<u32, 2>(_e319.member_1, _e319.member_1);
                                } else {
                                    phi_567_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e337 = phi_567_;
                                let _e344 = type_23(array<array<u32, 2>, 4>(_e337, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e356 = type_23(array<array<u32, 2>, 4>(_e344.member[0], array<u32, 2>(_e319.member_1, _e344.member[1][1]), _e344.member[2], _e344.member[3]), _e344.member_1);
                                let _e357 = array<u32, 2>(_e319.member_1, _e319.member_3);
                                let _e364 = type_23(array<array<u32, 2>, 4>(_e356.member[0], _e357, _e356.member[2], _e356.member[3]), _e356.member_1);
                                if !((_e330.member_3 == 4294967295u)) {
                                    phi_581_ = array<u32, 2>(_e319.member_3, _e319.member_3);
                                } else {
                                    phi_581_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e371 = phi_581_;
                                let _e378 = type_23(array<array<u32, 2>, 4>(_e364.member[0], _e364.member[1], _e371, _e364.member[3]), _e364.member_1);
                                let _e381 = type_23(_e378.member, _e378.member);
                                if ((((((_e327.member[0] <= _e330.member_2[0]) && (_e330.member[0] <= _e327.member_2[0])) && (_e327.member[1] <= _e330.member_2[1])) && (_e330.member[1] <= _e327.member_2[1])) && (_e327.member[2] <= _e330.member_2[2])) && (_e330.member[2] <= _e327.member_2[2])) {
                                    phi_618_ = _e357;
                                } else {
                                    phi_618_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e410 = phi_618_;
                                phi_620_ = type_23(_e381.member, array<array<u32, 2>, 4>(_e381.member_1[0], _e410, _e381.member_1[2], _e381.member_1[3]));
                            }
                            let _e419 = phi_620_;
                            phi_621_ = _e419;
                            phi_622_ = false;
                        } else {
                            phi_621_ = type_23();
                            phi_622_ = true;
                        }
                        let _e421 = phi_621_;
                        let _e423 = phi_622_;
                        phi_623_ = _e421;
                        phi_624_ = _e423;
                    } else {
                        phi_623_ = type_23();
                        phi_624_ = true;
                    }
                    let _e425 = phi_623_;
                    let _e427 = phi_624_;
                    if _e427 {
                        let _e430 = !((_e319.member_3 == 4294967295u));
                        let _e433 = !((_e321.member_3 == 4294967295u));
                        if _e430 {
                            phi_640_ = true;
                        } else {
                            phi_640_ = _e433;
                        }
                        let _e435 = phi_640_;
                        if _e435 {
                            if _e430 {
                                if _e433 {
                                    if (_e313 == 0u) {
                                        let _e463 = ((((_e321.member_2[0] - _e321.member[0]) * (_e321.member_2[1] - _e321.member[1])) * (_e321.member_2[2] - _e321.member[2])) > (((_e319.member_2[0] - _e319.member[0]) * (_e319.member_2[1] - _e319.member[1])) * (_e319.member_2[2] - _e319.member[2])));
                                        phi_684_ = _e463;
                                        phi_685_ = !(_e463);
                                    } else {
                                        phi_684_ = _e433;
                                        phi_685_ = _e430;
                                    }
                                    let _e466 = phi_684_;
                                    let _e468 = phi_685_;
                                    phi_686_ = _e466;
                                    phi_687_ = _e468;
                                } else {
                                    phi_686_ = _e433;
                                    phi_687_ = _e430;
                                }
                                let _e470 = phi_686_;
                                let _e472 = phi_687_;
                                phi_688_ = _e470;
                                phi_689_ = _e472;
                            } else {
                                phi_688_ = _e433;
                                phi_689_ = _e430;
                            }
                            let _e474 = phi_688_;
                            let _e476 = phi_689_;
                            if _e476 {
                                if _e474 {
                                    let _e479 = a_nodes.member[_e319.member_1];
                                    let _e484 = a_nodes.member[_e319.member_3];
                                    let _e489 = b_nodes.member[_e321.member_1];
                                    let _e494 = b_nodes.member[_e321.member_3];
                                    let _e499 = array<u32, 2>(_e319.member_1, _e321.member_1);
                                    let _e502 = array<u32, 2>(_e319.member_1, _e321.member_3);
                                    let _e505 = array<u32, 2>(_e319.member_3, _e321.member_1);
                                    let _e508 = array<u32, 2>(_e319.member_3, _e321.member_3);
                                    if ((((((_e479.member[0] <= _e489.member_2[0]) && (_e489.member[0] <= _e479.member_2[0])) && (_e479.member[1] <= _e489.member_2[1])) && (_e489.member[1] <= _e479.member_2[1])) && (_e479.member[2] <= _e489.member_2[2])) && (_e489.member[2] <= _e479.member_2[2])) {
                                        phi_795_ = _e499;
                                    } else {
                                        phi_795_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e534 = phi_795_;
                                    if ((((((_e479.member[0] <= _e494.member_2[0]) && (_e494.member[0] <= _e479.member_2[0])) && (_e479.member[1] <= _e494.member_2[1])) && (_e494.member[1] <= _e479.member_2[1])) && (_e479.member[2] <= _e494.member_2[2])) && (_e494.member[2] <= _e479.member_2[2])) {
                                        phi_824_ = _e502;
                                    } else {
                                        phi_824_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e559 = phi_824_;
                                    if ((((((_e484.member[0] <= _e489.member_2[0]) && (_e489.member[0] <= _e484.member_2[0])) && (_e484.member[1] <= _e489.member_2[1])) && (_e489.member[1] <= _e484.member_2[1])) && (_e484.member[2] <= _e489.member_2[2])) && (_e489.member[2] <= _e484.member_2[2])) {
                                        phi_853_ = _e505;
                                    } else {
                                        phi_853_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e584 = phi_853_;
                                    if ((((((_e484.member[0] <= _e494.member_2[0]) && (_e494.member[0] <= _e484.member_2[0])) && (_e484.member[1] <= _e494.member_2[1])) && (_e494.member[1] <= _e484.member_2[1])) && (_e484.member[2] <= _e494.member_2[2])) && (_e494.member[2] <= _e484.member_2[2])) {
                                        phi_882_ = _e508;
                                    } else {
                                        phi_882_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e609 = phi_882_;
                                    phi_884_ = type_23(array<array<u32, 2>, 4>(_e499, _e502, _e505, _e508), array<array<u32, 2>, 4>(_e534, _e559, _e584, _e609));
                                    phi_885_ = false;
                                } else {
                                    phi_884_ = type_23();
                                    phi_885_ = true;
                                }
                                let _e613 = phi_884_;
                                let _e615 = phi_885_;
                                phi_886_ = _e613;
                                phi_887_ = _e615;
                            } else {
                                phi_886_ = type_23();
                                phi_887_ = true;
                            }
                            let _e617 = phi_886_;
                            let _e619 = phi_887_;
                            if _e619 {
                                if _e476 {
                                    let _e728 = a_nodes.member[_e319.member_1];
                                    let _e733 = a_nodes.member[_e319.member_3];
                                    let _e737 = array<u32, 2>(_e319.member_1, _e285[1]);
                                    let _e739 = array<u32, 2>(_e319.member_3, _e285[1]);
                                    let _e746 = type_23(array<array<u32, 2>, 4>(_e737, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e753 = type_23(array<array<u32, 2>, 4>(_e746.member[0], _e739, _e746.member[2], _e746.member[3]), _e746.member_1);
                                    let _e763 = type_23(array<array<u32, 2>, 4>(_e737, _e739, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_23(array<array<u32, 2>, 4>(_e753.member[0], _e753.member[1], array<u32, 2>(4294967295u, 4294967295u), _e753.member[3]), _e753.member_1).member_1);
                                    if ((((((_e728.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e728.member_2[0])) && (_e728.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e728.member_2[1])) && (_e728.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e728.member_2[2])) {
                                        phi_960_ = _e737;
                                    } else {
                                        phi_960_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e790 = phi_960_;
                                    let _e797 = type_23(_e763.member, array<array<u32, 2>, 4>(_e790, _e763.member_1[1], _e763.member_1[2], _e763.member_1[3]));
                                    if ((((((_e733.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e733.member_2[0])) && (_e733.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e733.member_2[1])) && (_e733.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e733.member_2[2])) {
                                        phi_992_ = _e739;
                                    } else {
                                        phi_992_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e824 = phi_992_;
                                    phi_1094_ = type_23(_e797.member, array<array<u32, 2>, 4>(_e797.member_1[0], _e824, _e797.member_1[2], _e797.member_1[3]));
                                } else {
                                    let _e622 = b_nodes.member[_e321.member_1];
                                    let _e627 = b_nodes.member[_e321.member_3];
                                    let _e631 = array<u32, 2>(_e285[0], _e321.member_1);
                                    let _e633 = array<u32, 2>(_e285[0], _e321.member_3);
                                    let _e640 = type_23(array<array<u32, 2>, 4>(_e631, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e647 = type_23(array<array<u32, 2>, 4>(_e640.member[0], _e633, _e640.member[2], _e640.member[3]), _e640.member_1);
                                    let _e657 = type_23(array<array<u32, 2>, 4>(_e631, _e633, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_23(array<array<u32, 2>, 4>(_e647.member[0], _e647.member[1], array<u32, 2>(4294967295u, 4294967295u), _e647.member[3]), _e647.member_1).member_1);
                                    if ((((((_e319.member[0] <= _e622.member_2[0]) && (_e622.member[0] <= _e319.member_2[0])) && (_e319.member[1] <= _e622.member_2[1])) && (_e622.member[1] <= _e319.member_2[1])) && (_e319.member[2] <= _e622.member_2[2])) && (_e622.member[2] <= _e319.member_2[2])) {
                                        phi_1060_ = _e631;
                                    } else {
                                        phi_1060_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e684 = phi_1060_;
                                    let _e691 = type_23(_e657.member, array<array<u32, 2>, 4>(_e684, _e657.member_1[1], _e657.member_1[2], _e657.member_1[3]));
                                    if ((((((_e319.member[0] <= _e627.member_2[0]) && (_e627.member[0] <= _e319.member_2[0])) && (_e319.member[1] <= _e627.member_2[1])) && (_e627.member[1] <= _e319.member_2[1])) && (_e319.member[2] <= _e627.member_2[2])) && (_e627.member[2] <= _e319.member_2[2])) {
                                        phi_1092_ = _e633;
                                    } else {
                                        phi_1092_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e718 = phi_1092_;
                                    phi_1094_ = type_23(_e691.member, array<array<u32, 2>, 4>(_e691.member_1[0], _e718, _e691.member_1[2], _e691.member_1[3]));
                                }
                                let _e833 = phi_1094_;
                                phi_1095_ = _e833;
                            } else {
                                phi_1095_ = _e617;
                            }
                            let _e835 = phi_1095_;
                            phi_1096_ = _e835;
                            phi_1097_ = false;
                        } else {
                            phi_1096_ = type_23();
                            phi_1097_ = true;
                        }
                        let _e837 = phi_1096_;
                        let _e839 = phi_1097_;
                        phi_1098_ = _e837;
                        phi_1099_ = type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1100_ = _e839;
                    } else {
                        phi_1098_ = type_23();
                        phi_1099_ = _e425;
                        phi_1100_ = true;
                    }
                    let _e841 = phi_1098_;
                    let _e843 = phi_1099_;
                    let _e845 = phi_1100_;
                    if _e845 {
                        phi_1104_ = _e843;
                    } else {
                        phi_1104_ = _e841;
                    }
                    let _e847 = phi_1104_;
                    let _e851 = params.member.member_2.member;
                    let _e855 = params.member.member_2.member;
                    if (_e855 == 0u) {
                        phi_1119_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1119_ = array<u32, 2>(1u, 1u);
                    }
                    let _e858 = phi_1119_;
                    let _e864 = params.member.member.member[_e858[0]];
                    let _e865 = (_e864 - 1u);
                    let _e869 = params.member.member.member[_e858[1]];
                    let _e870 = (_e869 - 1u);
                    let _e873 = params.member.member_2.member;
                    if (_e873 == 0u) {
                        phi_1147_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1147_ = array<u32, 2>(1u, 1u);
                    }
                    let _e876 = phi_1147_;
                    let _e882 = params.member.member.member_2[_e876[0]];
                    let _e886 = params.member.member.member_2[_e876[1]];
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e847.member_1[0][0], _e847.member_1[0][1]), array<u32, 2>(_e847.member_1[1][0], _e847.member_1[1][1]), array<u32, 2>(_e847.member_1[2][0], _e847.member_1[2][1]), array<u32, 2>(_e847.member_1[3][0], _e847.member_1[3][1]));
                    phi_1185_ = type_9(0u, 4u);
                    loop {
                        let _e905 = phi_1185_;
                        if (_e905.member < _e905.member_1) {
                            phi_1186_ = type_9((_e905.member + 1u), _e905.member_1);
                            phi_1209_ = type_9(1u, _e905.member);
                        } else {
                            phi_1186_ = _e905;
                            phi_1209_ = type_9(0u, type_9().member_1);
                        }
                        let _e917 = phi_1186_;
                        let _e919 = phi_1209_;
                        let _e923 = (bitcast<i32>(_e919.member) != 0i);
                        if _e923 {
                            let _e925 = local_1[_e919.member_1];
                            if (_e925[0] != 4294967295u) {
                                if (_e851 == 1u) {
                                    phi_1238_ = (_e925[0] == _e925[1]);
                                } else {
                                    phi_1238_ = false;
                                }
                                let _e931 = phi_1238_;
                                if _e931 {
                                    phi_3447_ = bool();
                                    phi_3448_ = true;
                                } else {
                                    if (_e925[0] >= _e865) {
                                        if (_e925[1] >= _e870) {
                                            phi_1250_ = false;
                                        } else {
                                            phi_1250_ = true;
                                        }
                                        let _e935 = phi_1250_;
                                        phi_1251_ = _e935;
                                    } else {
                                        phi_1251_ = true;
                                    }
                                    let _e937 = phi_1251_;
                                    if _e937 {
                                        if (_e925[0] < _e865) {
                                            let _e1017 = oriented.member[(_e882 + _e925[0])];
                                            phi_1398_ = type_30(array<f32, 3>(_e1017.member.x, _e1017.member.y, _e1017.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1017.member.w, _e1017.member_1.x, _e1017.member_1.y), array<f32, 3>(_e1017.member_1.z, _e1017.member_1.w, _e1017.member_2.x), array<f32, 3>(_e1017.member_2.y, _e1017.member_2.z, _e1017.member_2.w)), array<f32, 3>(_e1017.member_3.x, _e1017.member_3.y, _e1017.member_3.z));
                                        } else {
                                            let _e940 = a_nodes.member[_e925[0]];
                                            let _e955 = ((_e940.member[0] * 0.5f) + (_e940.member_2[0] * 0.5f));
                                            let _e956 = ((_e940.member[1] * 0.5f) + (_e940.member_2[1] * 0.5f));
                                            let _e957 = ((_e940.member[2] * 0.5f) + (_e940.member_2[2] * 0.5f));
                                            if (_e955 < _e940.member_2[0]) {
                                                phi_1324_ = _e955;
                                            } else {
                                                phi_1324_ = _e940.member_2[0];
                                            }
                                            let _e961 = phi_1324_;
                                            if (_e956 < _e940.member_2[1]) {
                                                phi_1330_ = _e956;
                                            } else {
                                                phi_1330_ = _e940.member_2[1];
                                            }
                                            let _e965 = phi_1330_;
                                            if (_e957 < _e940.member_2[2]) {
                                                phi_1336_ = _e957;
                                            } else {
                                                phi_1336_ = _e940.member_2[2];
                                            }
                                            let _e969 = phi_1336_;
                                            if (_e961 > _e940.member[0]) {
                                                phi_1342_ = _e961;
                                            } else {
                                                phi_1342_ = _e940.member[0];
                                            }
                                            let _e973 = phi_1342_;
                                            if (_e965 > _e940.member[1]) {
                                                phi_1348_ = _e965;
                                            } else {
                                                phi_1348_ = _e940.member[1];
                                            }
                                            let _e977 = phi_1348_;
                                            if (_e969 > _e940.member[2]) {
                                                phi_1354_ = _e969;
                                            } else {
                                                phi_1354_ = _e940.member[2];
                                            }
                                            let _e981 = phi_1354_;
                                            let _e984 = (_e940.member_2[0] - _e973);
                                            let _e986 = (_e940.member_2[1] - _e977);
                                            let _e988 = (_e940.member_2[2] - _e981);
                                            let _e990 = (_e973 - _e940.member[0]);
                                            let _e992 = (_e977 - _e940.member[1]);
                                            let _e994 = (_e981 - _e940.member[2]);
                                            if (_e984 > _e990) {
                                                phi_1372_ = _e984;
                                            } else {
                                                phi_1372_ = _e990;
                                            }
                                            let _e997 = phi_1372_;
                                            if (_e986 > _e992) {
                                                phi_1377_ = _e986;
                                            } else {
                                                phi_1377_ = _e992;
                                            }
                                            let _e1000 = phi_1377_;
                                            if (_e988 > _e994) {
                                                phi_1382_ = _e988;
                                            } else {
                                                phi_1382_ = _e994;
                                            }
                                            let _e1003 = phi_1382_;
                                            let _e1005 = (1f + (0.000000059604645f * 4f));
                                            let _e1009 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1398_ = type_30(array<f32, 3>(_e973, _e977, _e981), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e997 * _e1005) + _e1009), ((_e1000 * _e1005) + _e1009), ((_e1003 * _e1005) + _e1009)));
                                        }
                                        let _e1056 = phi_1398_;
                                        if (_e925[1] < _e870) {
                                            let _e1136 = oriented.member[(_e886 + _e925[1])];
                                            phi_1542_ = type_30(array<f32, 3>(_e1136.member.x, _e1136.member.y, _e1136.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1136.member.w, _e1136.member_1.x, _e1136.member_1.y), array<f32, 3>(_e1136.member_1.z, _e1136.member_1.w, _e1136.member_2.x), array<f32, 3>(_e1136.member_2.y, _e1136.member_2.z, _e1136.member_2.w)), array<f32, 3>(_e1136.member_3.x, _e1136.member_3.y, _e1136.member_3.z));
                                        } else {
                                            let _e1059 = b_nodes.member[_e925[1]];
                                            let _e1074 = ((_e1059.member[0] * 0.5f) + (_e1059.member_2[0] * 0.5f));
                                            let _e1075 = ((_e1059.member[1] * 0.5f) + (_e1059.member_2[1] * 0.5f));
                                            let _e1076 = ((_e1059.member[2] * 0.5f) + (_e1059.member_2[2] * 0.5f));
                                            if (_e1074 < _e1059.member_2[0]) {
                                                phi_1468_ = _e1074;
                                            } else {
                                                phi_1468_ = _e1059.member_2[0];
                                            }
                                            let _e1080 = phi_1468_;
                                            if (_e1075 < _e1059.member_2[1]) {
                                                phi_1474_ = _e1075;
                                            } else {
                                                phi_1474_ = _e1059.member_2[1];
                                            }
                                            let _e1084 = phi_1474_;
                                            if (_e1076 < _e1059.member_2[2]) {
                                                phi_1480_ = _e1076;
                                            } else {
                                                phi_1480_ = _e1059.member_2[2];
                                            }
                                            let _e1088 = phi_1480_;
                                            if (_e1080 > _e1059.member[0]) {
                                                phi_1486_ = _e1080;
                                            } else {
                                                phi_1486_ = _e1059.member[0];
                                            }
                                            let _e1092 = phi_1486_;
                                            if (_e1084 > _e1059.member[1]) {
                                                phi_1492_ = _e1084;
                                            } else {
                                                phi_1492_ = _e1059.member[1];
                                            }
                                            let _e1096 = phi_1492_;
                                            if (_e1088 > _e1059.member[2]) {
                                                phi_1498_ = _e1088;
                                            } else {
                                                phi_1498_ = _e1059.member[2];
                                            }
                                            let _e1100 = phi_1498_;
                                            let _e1103 = (_e1059.member_2[0] - _e1092);
                                            let _e1105 = (_e1059.member_2[1] - _e1096);
                                            let _e1107 = (_e1059.member_2[2] - _e1100);
                                            let _e1109 = (_e1092 - _e1059.member[0]);
                                            let _e1111 = (_e1096 - _e1059.member[1]);
                                            let _e1113 = (_e1100 - _e1059.member[2]);
                                            if (_e1103 > _e1109) {
                                                phi_1516_ = _e1103;
                                            } else {
                                                phi_1516_ = _e1109;
                                            }
                                            let _e1116 = phi_1516_;
                                            if (_e1105 > _e1111) {
                                                phi_1521_ = _e1105;
                                            } else {
                                                phi_1521_ = _e1111;
                                            }
                                            let _e1119 = phi_1521_;
                                            if (_e1107 > _e1113) {
                                                phi_1526_ = _e1107;
                                            } else {
                                                phi_1526_ = _e1113;
                                            }
                                            let _e1122 = phi_1526_;
                                            let _e1124 = (1f + (0.000000059604645f * 4f));
                                            let _e1128 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1542_ = type_30(array<f32, 3>(_e1092, _e1096, _e1100), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1116 * _e1124) + _e1128), ((_e1119 * _e1124) + _e1128), ((_e1122 * _e1124) + _e1128)));
                                        }
                                        let _e1175 = phi_1542_;
                                        let _e1180 = (_e1175.member[0] - _e1056.member[0]);
                                        let _e1183 = (_e1175.member[1] - _e1056.member[1]);
                                        let _e1186 = (_e1175.member[2] - _e1056.member[2]);
                                        if (_e1180 < 0f) {
                                            phi_1732_ = -(_e1180);
                                        } else {
                                            phi_1732_ = _e1180;
                                        }
                                        let _e1375 = phi_1732_;
                                        if (_e1183 < 0f) {
                                            phi_1738_ = -(_e1183);
                                        } else {
                                            phi_1738_ = _e1183;
                                        }
                                        let _e1379 = phi_1738_;
                                        if (_e1186 < 0f) {
                                            phi_1745_ = -(_e1186);
                                        } else {
                                            phi_1745_ = _e1186;
                                        }
                                        let _e1384 = phi_1745_;
                                        if (_e1056.member_2[0] < 0f) {
                                            phi_1754_ = -(_e1056.member_2[0]);
                                        } else {
                                            phi_1754_ = _e1056.member_2[0];
                                        }
                                        let _e1391 = phi_1754_;
                                        if (_e1056.member_2[1] < 0f) {
                                            phi_1761_ = -(_e1056.member_2[1]);
                                        } else {
                                            phi_1761_ = _e1056.member_2[1];
                                        }
                                        let _e1396 = phi_1761_;
                                        if (_e1056.member_2[2] < 0f) {
                                            phi_1769_ = -(_e1056.member_2[2]);
                                        } else {
                                            phi_1769_ = _e1056.member_2[2];
                                        }
                                        let _e1402 = phi_1769_;
                                        if (_e1175.member_2[0] < 0f) {
                                            phi_1778_ = -(_e1175.member_2[0]);
                                        } else {
                                            phi_1778_ = _e1175.member_2[0];
                                        }
                                        let _e1409 = phi_1778_;
                                        if (_e1175.member_2[1] < 0f) {
                                            phi_1785_ = -(_e1175.member_2[1]);
                                        } else {
                                            phi_1785_ = _e1175.member_2[1];
                                        }
                                        let _e1414 = phi_1785_;
                                        if (_e1175.member_2[2] < 0f) {
                                            phi_1793_ = -(_e1175.member_2[2]);
                                        } else {
                                            phi_1793_ = _e1175.member_2[2];
                                        }
                                        let _e1420 = phi_1793_;
                                        local = type_25(array<array<f32, 3>, 3>(array<f32, 3>((((_e1175.member_1[0][0] * _e1056.member_1[0][0]) + (_e1175.member_1[0][1] * _e1056.member_1[0][1])) + (_e1175.member_1[0][2] * _e1056.member_1[0][2])), (((_e1175.member_1[1][0] * _e1056.member_1[0][0]) + (_e1175.member_1[1][1] * _e1056.member_1[0][1])) + (_e1175.member_1[1][2] * _e1056.member_1[0][2])), (((_e1175.member_1[2][0] * _e1056.member_1[0][0]) + (_e1175.member_1[2][1] * _e1056.member_1[0][1])) + (_e1175.member_1[2][2] * _e1056.member_1[0][2]))), array<f32, 3>((((_e1175.member_1[0][0] * _e1056.member_1[1][0]) + (_e1175.member_1[0][1] * _e1056.member_1[1][1])) + (_e1175.member_1[0][2] * _e1056.member_1[1][2])), (((_e1175.member_1[1][0] * _e1056.member_1[1][0]) + (_e1175.member_1[1][1] * _e1056.member_1[1][1])) + (_e1175.member_1[1][2] * _e1056.member_1[1][2])), (((_e1175.member_1[2][0] * _e1056.member_1[1][0]) + (_e1175.member_1[2][1] * _e1056.member_1[1][1])) + (_e1175.member_1[2][2] * _e1056.member_1[1][2]))), array<f32, 3>((((_e1175.member_1[0][0] * _e1056.member_1[2][0]) + (_e1175.member_1[0][1] * _e1056.member_1[2][1])) + (_e1175.member_1[0][2] * _e1056.member_1[2][2])), (((_e1175.member_1[1][0] * _e1056.member_1[2][0]) + (_e1175.member_1[1][1] * _e1056.member_1[2][1])) + (_e1175.member_1[1][2] * _e1056.member_1[2][2])), (((_e1175.member_1[2][0] * _e1056.member_1[2][0]) + (_e1175.member_1[2][1] * _e1056.member_1[2][1])) + (_e1175.member_1[2][2] * _e1056.member_1[2][2])))), array<f32, 3>((((_e1056.member_1[0][0] * _e1180) + (_e1056.member_1[0][1] * _e1183)) + (_e1056.member_1[0][2] * _e1186)), (((_e1056.member_1[1][0] * _e1180) + (_e1056.member_1[1][1] * _e1183)) + (_e1056.member_1[1][2] * _e1186)), (((_e1056.member_1[2][0] * _e1180) + (_e1056.member_1[2][1] * _e1183)) + (_e1056.member_1[2][2] * _e1186))), array<f32, 3>((((_e1175.member_1[0][0] * _e1180) + (_e1175.member_1[0][1] * _e1183)) + (_e1175.member_1[0][2] * _e1186)), (((_e1175.member_1[1][0] * _e1180) + (_e1175.member_1[1][1] * _e1183)) + (_e1175.member_1[1][2] * _e1186)), (((_e1175.member_1[2][0] * _e1180) + (_e1175.member_1[2][1] * _e1183)) + (_e1175.member_1[2][2] * _e1186))), array<f32, 3>(_e1056.member_2[0], _e1056.member_2[1], _e1056.member_2[2]), array<f32, 3>(_e1175.member_2[0], _e1175.member_2[1], _e1175.member_2[2]), ((((((_e1375 + _e1379) + _e1384) + (((_e1391 + _e1396) + _e1402) + ((_e1409 + _e1414) + _e1420))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1447 = local.member[0u][0u];
                                        let _e1451 = local.member[0u][1u];
                                        let _e1455 = local.member[0u][2u];
                                        let _e1459 = local.member[1u][0u];
                                        let _e1463 = local.member[1u][1u];
                                        let _e1467 = local.member[1u][2u];
                                        let _e1471 = local.member[2u][0u];
                                        let _e1475 = local.member[2u][1u];
                                        let _e1479 = local.member[2u][2u];
                                        let _e1481 = local.member_3;
                                        let _e1486 = local.member_4;
                                        let _e1492 = local.member_1[0u];
                                        if (_e1492 < 0f) {
                                            phi_1886_ = -(_e1492);
                                        } else {
                                            phi_1886_ = _e1492;
                                        }
                                        let _e1496 = phi_1886_;
                                        if (_e1447 < 0f) {
                                            phi_1893_ = -(_e1447);
                                        } else {
                                            phi_1893_ = _e1447;
                                        }
                                        let _e1500 = phi_1893_;
                                        if (_e1451 < 0f) {
                                            phi_1899_ = -(_e1451);
                                        } else {
                                            phi_1899_ = _e1451;
                                        }
                                        let _e1504 = phi_1899_;
                                        if (_e1455 < 0f) {
                                            phi_1905_ = -(_e1455);
                                        } else {
                                            phi_1905_ = _e1455;
                                        }
                                        let _e1508 = phi_1905_;
                                        let _e1515 = (_e1496 - (_e1481[0] + (((_e1500 * _e1486[0]) + (_e1504 * _e1486[1])) + (_e1508 * _e1486[2]))));
                                        let _e1518 = local.member_1[1u];
                                        if (_e1518 < 0f) {
                                            phi_1924_ = -(_e1518);
                                        } else {
                                            phi_1924_ = _e1518;
                                        }
                                        let _e1522 = phi_1924_;
                                        if (_e1459 < 0f) {
                                            phi_1931_ = -(_e1459);
                                        } else {
                                            phi_1931_ = _e1459;
                                        }
                                        let _e1526 = phi_1931_;
                                        if (_e1463 < 0f) {
                                            phi_1937_ = -(_e1463);
                                        } else {
                                            phi_1937_ = _e1463;
                                        }
                                        let _e1530 = phi_1937_;
                                        if (_e1467 < 0f) {
                                            phi_1943_ = -(_e1467);
                                        } else {
                                            phi_1943_ = _e1467;
                                        }
                                        let _e1534 = phi_1943_;
                                        let _e1541 = (_e1522 - (_e1481[1] + (((_e1526 * _e1486[0]) + (_e1530 * _e1486[1])) + (_e1534 * _e1486[2]))));
                                        let _e1544 = local.member_1[2u];
                                        if (_e1544 < 0f) {
                                            phi_1962_ = -(_e1544);
                                        } else {
                                            phi_1962_ = _e1544;
                                        }
                                        let _e1548 = phi_1962_;
                                        if (_e1471 < 0f) {
                                            phi_1969_ = -(_e1471);
                                        } else {
                                            phi_1969_ = _e1471;
                                        }
                                        let _e1552 = phi_1969_;
                                        if (_e1475 < 0f) {
                                            phi_1975_ = -(_e1475);
                                        } else {
                                            phi_1975_ = _e1475;
                                        }
                                        let _e1556 = phi_1975_;
                                        if (_e1479 < 0f) {
                                            phi_1981_ = -(_e1479);
                                        } else {
                                            phi_1981_ = _e1479;
                                        }
                                        let _e1560 = phi_1981_;
                                        let _e1567 = (_e1548 - (_e1481[2] + (((_e1552 * _e1486[0]) + (_e1556 * _e1486[1])) + (_e1560 * _e1486[2]))));
                                        let _e1570 = local.member_2[0u];
                                        if (_e1570 < 0f) {
                                            phi_2000_ = -(_e1570);
                                        } else {
                                            phi_2000_ = _e1570;
                                        }
                                        let _e1574 = phi_2000_;
                                        if (_e1447 < 0f) {
                                            phi_2007_ = -(_e1447);
                                        } else {
                                            phi_2007_ = _e1447;
                                        }
                                        let _e1578 = phi_2007_;
                                        if (_e1459 < 0f) {
                                            phi_2013_ = -(_e1459);
                                        } else {
                                            phi_2013_ = _e1459;
                                        }
                                        let _e1582 = phi_2013_;
                                        if (_e1471 < 0f) {
                                            phi_2019_ = -(_e1471);
                                        } else {
                                            phi_2019_ = _e1471;
                                        }
                                        let _e1586 = phi_2019_;
                                        let _e1593 = (_e1574 - (_e1486[0] + (((_e1578 * _e1481[0]) + (_e1582 * _e1481[1])) + (_e1586 * _e1481[2]))));
                                        let _e1596 = local.member_2[1u];
                                        if (_e1596 < 0f) {
                                            phi_2038_ = -(_e1596);
                                        } else {
                                            phi_2038_ = _e1596;
                                        }
                                        let _e1600 = phi_2038_;
                                        if (_e1451 < 0f) {
                                            phi_2045_ = -(_e1451);
                                        } else {
                                            phi_2045_ = _e1451;
                                        }
                                        let _e1604 = phi_2045_;
                                        if (_e1463 < 0f) {
                                            phi_2051_ = -(_e1463);
                                        } else {
                                            phi_2051_ = _e1463;
                                        }
                                        let _e1608 = phi_2051_;
                                        if (_e1475 < 0f) {
                                            phi_2057_ = -(_e1475);
                                        } else {
                                            phi_2057_ = _e1475;
                                        }
                                        let _e1612 = phi_2057_;
                                        let _e1619 = (_e1600 - (_e1486[1] + (((_e1604 * _e1481[0]) + (_e1608 * _e1481[1])) + (_e1612 * _e1481[2]))));
                                        let _e1622 = local.member_2[2u];
                                        if (_e1622 < 0f) {
                                            phi_2076_ = -(_e1622);
                                        } else {
                                            phi_2076_ = _e1622;
                                        }
                                        let _e1626 = phi_2076_;
                                        if (_e1455 < 0f) {
                                            phi_2083_ = -(_e1455);
                                        } else {
                                            phi_2083_ = _e1455;
                                        }
                                        let _e1630 = phi_2083_;
                                        if (_e1467 < 0f) {
                                            phi_2089_ = -(_e1467);
                                        } else {
                                            phi_2089_ = _e1467;
                                        }
                                        let _e1634 = phi_2089_;
                                        if (_e1479 < 0f) {
                                            phi_2095_ = -(_e1479);
                                        } else {
                                            phi_2095_ = _e1479;
                                        }
                                        let _e1638 = phi_2095_;
                                        let _e1645 = (_e1626 - (_e1486[2] + (((_e1630 * _e1481[0]) + (_e1634 * _e1481[1])) + (_e1638 * _e1481[2]))));
                                        if (_e1515 > _e1541) {
                                            phi_2110_ = _e1515;
                                        } else {
                                            phi_2110_ = _e1541;
                                        }
                                        let _e1648 = phi_2110_;
                                        if (_e1648 > _e1567) {
                                            phi_2115_ = _e1648;
                                        } else {
                                            phi_2115_ = _e1567;
                                        }
                                        let _e1651 = phi_2115_;
                                        if (_e1593 > _e1619) {
                                            phi_2120_ = _e1593;
                                        } else {
                                            phi_2120_ = _e1619;
                                        }
                                        let _e1654 = phi_2120_;
                                        if (_e1654 > _e1645) {
                                            phi_2125_ = _e1654;
                                        } else {
                                            phi_2125_ = _e1645;
                                        }
                                        let _e1657 = phi_2125_;
                                        if (_e1651 > _e1657) {
                                            phi_2130_ = _e1651;
                                        } else {
                                            phi_2130_ = _e1657;
                                        }
                                        let _e1660 = phi_2130_;
                                        let _e1662 = local.member_5;
                                        if (_e1660 > _e1662) {
                                            phi_3443_ = true;
                                        } else {
                                            let _e1667 = local.member[1u][0u];
                                            let _e1670 = local.member_1[2u];
                                            let _e1675 = local.member[2u][0u];
                                            let _e1678 = local.member_1[1u];
                                            let _e1680 = ((_e1667 * _e1670) - (_e1675 * _e1678));
                                            let _e1684 = local.member[2u][0u];
                                            if (_e1684 < 0f) {
                                                phi_2189_ = -(_e1684);
                                            } else {
                                                phi_2189_ = _e1684;
                                            }
                                            let _e1688 = phi_2189_;
                                            let _e1691 = local.member_3[1u];
                                            let _e1696 = local.member[1u][0u];
                                            if (_e1696 < 0f) {
                                                phi_2212_ = -(_e1696);
                                            } else {
                                                phi_2212_ = _e1696;
                                            }
                                            let _e1700 = phi_2212_;
                                            let _e1703 = local.member_3[2u];
                                            let _e1709 = local.member[0u][2u];
                                            if (_e1709 < 0f) {
                                                phi_2235_ = -(_e1709);
                                            } else {
                                                phi_2235_ = _e1709;
                                            }
                                            let _e1713 = phi_2235_;
                                            let _e1716 = local.member_4[1u];
                                            let _e1721 = local.member[0u][1u];
                                            if (_e1721 < 0f) {
                                                phi_2257_ = -(_e1721);
                                            } else {
                                                phi_2257_ = _e1721;
                                            }
                                            let _e1725 = phi_2257_;
                                            let _e1728 = local.member_4[2u];
                                            if (_e1680 < 0f) {
                                                phi_2273_ = -(_e1680);
                                            } else {
                                                phi_2273_ = _e1680;
                                            }
                                            let _e1734 = phi_2273_;
                                            let _e1736 = (_e1734 - (((_e1688 * _e1691) + (_e1700 * _e1703)) + ((_e1713 * _e1716) + (_e1725 * _e1728))));
                                            let _e1740 = local.member[1u][1u];
                                            let _e1743 = local.member_1[2u];
                                            let _e1748 = local.member[2u][1u];
                                            let _e1751 = local.member_1[1u];
                                            let _e1753 = ((_e1740 * _e1743) - (_e1748 * _e1751));
                                            let _e1757 = local.member[2u][1u];
                                            if (_e1757 < 0f) {
                                                phi_2328_ = -(_e1757);
                                            } else {
                                                phi_2328_ = _e1757;
                                            }
                                            let _e1761 = phi_2328_;
                                            let _e1764 = local.member_3[1u];
                                            let _e1769 = local.member[1u][1u];
                                            if (_e1769 < 0f) {
                                                phi_2351_ = -(_e1769);
                                            } else {
                                                phi_2351_ = _e1769;
                                            }
                                            let _e1773 = phi_2351_;
                                            let _e1776 = local.member_3[2u];
                                            let _e1782 = local.member[0u][0u];
                                            if (_e1782 < 0f) {
                                                phi_2374_ = -(_e1782);
                                            } else {
                                                phi_2374_ = _e1782;
                                            }
                                            let _e1786 = phi_2374_;
                                            let _e1789 = local.member_4[2u];
                                            let _e1794 = local.member[0u][2u];
                                            if (_e1794 < 0f) {
                                                phi_2396_ = -(_e1794);
                                            } else {
                                                phi_2396_ = _e1794;
                                            }
                                            let _e1798 = phi_2396_;
                                            let _e1801 = local.member_4[0u];
                                            if (_e1753 < 0f) {
                                                phi_2412_ = -(_e1753);
                                            } else {
                                                phi_2412_ = _e1753;
                                            }
                                            let _e1807 = phi_2412_;
                                            let _e1809 = (_e1807 - (((_e1761 * _e1764) + (_e1773 * _e1776)) + ((_e1786 * _e1789) + (_e1798 * _e1801))));
                                            let _e1813 = local.member[1u][2u];
                                            let _e1816 = local.member_1[2u];
                                            let _e1821 = local.member[2u][2u];
                                            let _e1824 = local.member_1[1u];
                                            let _e1826 = ((_e1813 * _e1816) - (_e1821 * _e1824));
                                            let _e1830 = local.member[2u][2u];
                                            if (_e1830 < 0f) {
                                                phi_2467_ = -(_e1830);
                                            } else {
                                                phi_2467_ = _e1830;
                                            }
                                            let _e1834 = phi_2467_;
                                            let _e1837 = local.member_3[1u];
                                            let _e1842 = local.member[1u][2u];
                                            if (_e1842 < 0f) {
                                                phi_2490_ = -(_e1842);
                                            } else {
                                                phi_2490_ = _e1842;
                                            }
                                            let _e1846 = phi_2490_;
                                            let _e1849 = local.member_3[2u];
                                            let _e1855 = local.member[0u][1u];
                                            if (_e1855 < 0f) {
                                                phi_2513_ = -(_e1855);
                                            } else {
                                                phi_2513_ = _e1855;
                                            }
                                            let _e1859 = phi_2513_;
                                            let _e1862 = local.member_4[0u];
                                            let _e1867 = local.member[0u][0u];
                                            if (_e1867 < 0f) {
                                                phi_2535_ = -(_e1867);
                                            } else {
                                                phi_2535_ = _e1867;
                                            }
                                            let _e1871 = phi_2535_;
                                            let _e1874 = local.member_4[1u];
                                            if (_e1826 < 0f) {
                                                phi_2551_ = -(_e1826);
                                            } else {
                                                phi_2551_ = _e1826;
                                            }
                                            let _e1880 = phi_2551_;
                                            let _e1882 = (_e1880 - (((_e1834 * _e1837) + (_e1846 * _e1849)) + ((_e1859 * _e1862) + (_e1871 * _e1874))));
                                            let _e1886 = local.member[2u][0u];
                                            let _e1889 = local.member_1[0u];
                                            let _e1894 = local.member[0u][0u];
                                            let _e1897 = local.member_1[2u];
                                            let _e1899 = ((_e1886 * _e1889) - (_e1894 * _e1897));
                                            let _e1903 = local.member[0u][0u];
                                            if (_e1903 < 0f) {
                                                phi_2606_ = -(_e1903);
                                            } else {
                                                phi_2606_ = _e1903;
                                            }
                                            let _e1907 = phi_2606_;
                                            let _e1910 = local.member_3[2u];
                                            let _e1915 = local.member[2u][0u];
                                            if (_e1915 < 0f) {
                                                phi_2629_ = -(_e1915);
                                            } else {
                                                phi_2629_ = _e1915;
                                            }
                                            let _e1919 = phi_2629_;
                                            let _e1922 = local.member_3[0u];
                                            let _e1928 = local.member[1u][2u];
                                            if (_e1928 < 0f) {
                                                phi_2653_ = -(_e1928);
                                            } else {
                                                phi_2653_ = _e1928;
                                            }
                                            let _e1932 = phi_2653_;
                                            let _e1935 = local.member_4[1u];
                                            let _e1940 = local.member[1u][1u];
                                            if (_e1940 < 0f) {
                                                phi_2676_ = -(_e1940);
                                            } else {
                                                phi_2676_ = _e1940;
                                            }
                                            let _e1944 = phi_2676_;
                                            let _e1947 = local.member_4[2u];
                                            if (_e1899 < 0f) {
                                                phi_2692_ = -(_e1899);
                                            } else {
                                                phi_2692_ = _e1899;
                                            }
                                            let _e1953 = phi_2692_;
                                            let _e1955 = (_e1953 - (((_e1907 * _e1910) + (_e1919 * _e1922)) + ((_e1932 * _e1935) + (_e1944 * _e1947))));
                                            let _e1959 = local.member[2u][1u];
                                            let _e1962 = local.member_1[0u];
                                            let _e1967 = local.member[0u][1u];
                                            let _e1970 = local.member_1[2u];
                                            let _e1972 = ((_e1959 * _e1962) - (_e1967 * _e1970));
                                            let _e1976 = local.member[0u][1u];
                                            if (_e1976 < 0f) {
                                                phi_2747_ = -(_e1976);
                                            } else {
                                                phi_2747_ = _e1976;
                                            }
                                            let _e1980 = phi_2747_;
                                            let _e1983 = local.member_3[2u];
                                            let _e1988 = local.member[2u][1u];
                                            if (_e1988 < 0f) {
                                                phi_2770_ = -(_e1988);
                                            } else {
                                                phi_2770_ = _e1988;
                                            }
                                            let _e1992 = phi_2770_;
                                            let _e1995 = local.member_3[0u];
                                            let _e2001 = local.member[1u][0u];
                                            if (_e2001 < 0f) {
                                                phi_2794_ = -(_e2001);
                                            } else {
                                                phi_2794_ = _e2001;
                                            }
                                            let _e2005 = phi_2794_;
                                            let _e2008 = local.member_4[2u];
                                            let _e2013 = local.member[1u][2u];
                                            if (_e2013 < 0f) {
                                                phi_2817_ = -(_e2013);
                                            } else {
                                                phi_2817_ = _e2013;
                                            }
                                            let _e2017 = phi_2817_;
                                            let _e2020 = local.member_4[0u];
                                            if (_e1972 < 0f) {
                                                phi_2833_ = -(_e1972);
                                            } else {
                                                phi_2833_ = _e1972;
                                            }
                                            let _e2026 = phi_2833_;
                                            let _e2028 = (_e2026 - (((_e1980 * _e1983) + (_e1992 * _e1995)) + ((_e2005 * _e2008) + (_e2017 * _e2020))));
                                            let _e2032 = local.member[2u][2u];
                                            let _e2035 = local.member_1[0u];
                                            let _e2040 = local.member[0u][2u];
                                            let _e2043 = local.member_1[2u];
                                            let _e2045 = ((_e2032 * _e2035) - (_e2040 * _e2043));
                                            let _e2049 = local.member[0u][2u];
                                            if (_e2049 < 0f) {
                                                phi_2888_ = -(_e2049);
                                            } else {
                                                phi_2888_ = _e2049;
                                            }
                                            let _e2053 = phi_2888_;
                                            let _e2056 = local.member_3[2u];
                                            let _e2061 = local.member[2u][2u];
                                            if (_e2061 < 0f) {
                                                phi_2911_ = -(_e2061);
                                            } else {
                                                phi_2911_ = _e2061;
                                            }
                                            let _e2065 = phi_2911_;
                                            let _e2068 = local.member_3[0u];
                                            let _e2074 = local.member[1u][1u];
                                            if (_e2074 < 0f) {
                                                phi_2935_ = -(_e2074);
                                            } else {
                                                phi_2935_ = _e2074;
                                            }
                                            let _e2078 = phi_2935_;
                                            let _e2081 = local.member_4[0u];
                                            let _e2086 = local.member[1u][0u];
                                            if (_e2086 < 0f) {
                                                phi_2958_ = -(_e2086);
                                            } else {
                                                phi_2958_ = _e2086;
                                            }
                                            let _e2090 = phi_2958_;
                                            let _e2093 = local.member_4[1u];
                                            if (_e2045 < 0f) {
                                                phi_2974_ = -(_e2045);
                                            } else {
                                                phi_2974_ = _e2045;
                                            }
                                            let _e2099 = phi_2974_;
                                            let _e2101 = (_e2099 - (((_e2053 * _e2056) + (_e2065 * _e2068)) + ((_e2078 * _e2081) + (_e2090 * _e2093))));
                                            let _e2105 = local.member[0u][0u];
                                            let _e2108 = local.member_1[1u];
                                            let _e2113 = local.member[1u][0u];
                                            let _e2116 = local.member_1[0u];
                                            let _e2118 = ((_e2105 * _e2108) - (_e2113 * _e2116));
                                            let _e2122 = local.member[1u][0u];
                                            if (_e2122 < 0f) {
                                                phi_3029_ = -(_e2122);
                                            } else {
                                                phi_3029_ = _e2122;
                                            }
                                            let _e2126 = phi_3029_;
                                            let _e2129 = local.member_3[0u];
                                            let _e2134 = local.member[0u][0u];
                                            if (_e2134 < 0f) {
                                                phi_3052_ = -(_e2134);
                                            } else {
                                                phi_3052_ = _e2134;
                                            }
                                            let _e2138 = phi_3052_;
                                            let _e2141 = local.member_3[1u];
                                            let _e2147 = local.member[2u][2u];
                                            if (_e2147 < 0f) {
                                                phi_3076_ = -(_e2147);
                                            } else {
                                                phi_3076_ = _e2147;
                                            }
                                            let _e2151 = phi_3076_;
                                            let _e2154 = local.member_4[1u];
                                            let _e2159 = local.member[2u][1u];
                                            if (_e2159 < 0f) {
                                                phi_3099_ = -(_e2159);
                                            } else {
                                                phi_3099_ = _e2159;
                                            }
                                            let _e2163 = phi_3099_;
                                            let _e2166 = local.member_4[2u];
                                            if (_e2118 < 0f) {
                                                phi_3115_ = -(_e2118);
                                            } else {
                                                phi_3115_ = _e2118;
                                            }
                                            let _e2172 = phi_3115_;
                                            let _e2174 = (_e2172 - (((_e2126 * _e2129) + (_e2138 * _e2141)) + ((_e2151 * _e2154) + (_e2163 * _e2166))));
                                            let _e2178 = local.member[0u][1u];
                                            let _e2181 = local.member_1[1u];
                                            let _e2186 = local.member[1u][1u];
                                            let _e2189 = local.member_1[0u];
                                            let _e2191 = ((_e2178 * _e2181) - (_e2186 * _e2189));
                                            let _e2195 = local.member[1u][1u];
                                            if (_e2195 < 0f) {
                                                phi_3170_ = -(_e2195);
                                            } else {
                                                phi_3170_ = _e2195;
                                            }
                                            let _e2199 = phi_3170_;
                                            let _e2202 = local.member_3[0u];
                                            let _e2207 = local.member[0u][1u];
                                            if (_e2207 < 0f) {
                                                phi_3193_ = -(_e2207);
                                            } else {
                                                phi_3193_ = _e2207;
                                            }
                                            let _e2211 = phi_3193_;
                                            let _e2214 = local.member_3[1u];
                                            let _e2220 = local.member[2u][0u];
                                            if (_e2220 < 0f) {
                                                phi_3217_ = -(_e2220);
                                            } else {
                                                phi_3217_ = _e2220;
                                            }
                                            let _e2224 = phi_3217_;
                                            let _e2227 = local.member_4[2u];
                                            let _e2232 = local.member[2u][2u];
                                            if (_e2232 < 0f) {
                                                phi_3240_ = -(_e2232);
                                            } else {
                                                phi_3240_ = _e2232;
                                            }
                                            let _e2236 = phi_3240_;
                                            let _e2239 = local.member_4[0u];
                                            if (_e2191 < 0f) {
                                                phi_3256_ = -(_e2191);
                                            } else {
                                                phi_3256_ = _e2191;
                                            }
                                            let _e2245 = phi_3256_;
                                            let _e2247 = (_e2245 - (((_e2199 * _e2202) + (_e2211 * _e2214)) + ((_e2224 * _e2227) + (_e2236 * _e2239))));
                                            let _e2251 = local.member[0u][2u];
                                            let _e2254 = local.member_1[1u];
                                            let _e2259 = local.member[1u][2u];
                                            let _e2262 = local.member_1[0u];
                                            let _e2264 = ((_e2251 * _e2254) - (_e2259 * _e2262));
                                            let _e2268 = local.member[1u][2u];
                                            if (_e2268 < 0f) {
                                                phi_3311_ = -(_e2268);
                                            } else {
                                                phi_3311_ = _e2268;
                                            }
                                            let _e2272 = phi_3311_;
                                            let _e2275 = local.member_3[0u];
                                            let _e2280 = local.member[0u][2u];
                                            if (_e2280 < 0f) {
                                                phi_3334_ = -(_e2280);
                                            } else {
                                                phi_3334_ = _e2280;
                                            }
                                            let _e2284 = phi_3334_;
                                            let _e2287 = local.member_3[1u];
                                            let _e2293 = local.member[2u][1u];
                                            if (_e2293 < 0f) {
                                                phi_3358_ = -(_e2293);
                                            } else {
                                                phi_3358_ = _e2293;
                                            }
                                            let _e2297 = phi_3358_;
                                            let _e2300 = local.member_4[0u];
                                            let _e2305 = local.member[2u][0u];
                                            if (_e2305 < 0f) {
                                                phi_3381_ = -(_e2305);
                                            } else {
                                                phi_3381_ = _e2305;
                                            }
                                            let _e2309 = phi_3381_;
                                            let _e2312 = local.member_4[1u];
                                            if (_e2264 < 0f) {
                                                phi_3397_ = -(_e2264);
                                            } else {
                                                phi_3397_ = _e2264;
                                            }
                                            let _e2318 = phi_3397_;
                                            let _e2320 = (_e2318 - (((_e2272 * _e2275) + (_e2284 * _e2287)) + ((_e2297 * _e2300) + (_e2309 * _e2312))));
                                            if (_e1736 > _e1809) {
                                                phi_3404_ = _e1736;
                                            } else {
                                                phi_3404_ = _e1809;
                                            }
                                            let _e2323 = phi_3404_;
                                            if (_e2323 > _e1882) {
                                                phi_3409_ = _e2323;
                                            } else {
                                                phi_3409_ = _e1882;
                                            }
                                            let _e2326 = phi_3409_;
                                            if (_e1955 > _e2028) {
                                                phi_3414_ = _e1955;
                                            } else {
                                                phi_3414_ = _e2028;
                                            }
                                            let _e2329 = phi_3414_;
                                            if (_e2329 > _e2101) {
                                                phi_3419_ = _e2329;
                                            } else {
                                                phi_3419_ = _e2101;
                                            }
                                            let _e2332 = phi_3419_;
                                            if (_e2326 > _e2332) {
                                                phi_3424_ = _e2326;
                                            } else {
                                                phi_3424_ = _e2332;
                                            }
                                            let _e2335 = phi_3424_;
                                            if (_e2174 > _e2247) {
                                                phi_3429_ = _e2174;
                                            } else {
                                                phi_3429_ = _e2247;
                                            }
                                            let _e2338 = phi_3429_;
                                            if (_e2338 > _e2320) {
                                                phi_3434_ = _e2338;
                                            } else {
                                                phi_3434_ = _e2320;
                                            }
                                            let _e2341 = phi_3434_;
                                            if (_e2335 > _e2341) {
                                                phi_3439_ = _e2335;
                                            } else {
                                                phi_3439_ = _e2341;
                                            }
                                            let _e2344 = phi_3439_;
                                            let _e2346 = local.member_5;
                                            phi_3443_ = (_e2344 > _e2346);
                                        }
                                        let _e2349 = phi_3443_;
                                        phi_3445_ = !(_e2349);
                                        phi_3446_ = false;
                                    } else {
                                        phi_3445_ = bool();
                                        phi_3446_ = true;
                                    }
                                    let _e2352 = phi_3445_;
                                    let _e2354 = phi_3446_;
                                    phi_3447_ = _e2352;
                                    phi_3448_ = _e2354;
                                }
                                let _e2356 = phi_3447_;
                                let _e2358 = phi_3448_;
                                if _e2358 {
                                    phi_3452_ = true;
                                } else {
                                    phi_3452_ = _e2356;
                                }
                                let _e2360 = phi_3452_;
                                if _e2360 {
                                } else {
                                    local_1[_e919.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1185_ = _e917;
                            break if !(_e923);
                        }
                    }
                    let _e2363 = local_1;
                    let _e2367 = array<u32, 2>(_e2363[0][0], _e2363[0][1]);
                    let _e2371 = array<u32, 2>(_e2363[1][0], _e2363[1][1]);
                    let _e2375 = array<u32, 2>(_e2363[2][0], _e2363[2][1]);
                    let _e2379 = array<u32, 2>(_e2363[3][0], _e2363[3][1]);
                    let _e2383 = params.member.member_2.member_4;
                    if (_e2383 > 0u) {
                        phi_3488_ = _e847.member;
                    } else {
                        phi_3488_ = array<array<u32, 2>, 4>(_e2367, _e2371, _e2375, _e2379);
                    }
                    let _e2387 = phi_3488_;
                    if (_e2363[0][0] == 4294967295u) {
                        phi_3512_ = 0u;
                    } else {
                        if (_e2363[0][0] >= _e302) {
                            if (_e2363[0][1] >= _e307) {
                                phi_3506_ = false;
                            } else {
                                phi_3506_ = true;
                            }
                            let _e2393 = phi_3506_;
                            phi_3507_ = _e2393;
                        } else {
                            phi_3507_ = true;
                        }
                        let _e2395 = phi_3507_;
                        if _e2395 {
                            phi_3511_ = 1u;
                        } else {
                            phi_3511_ = 2u;
                        }
                        let _e2397 = phi_3511_;
                        phi_3512_ = _e2397;
                    }
                    let _e2399 = phi_3512_;
                    let _e2400 = type_32(_e2367, _e2399);
                    if (_e2399 == 0u) {
                        if (_e2387[0][0] != 4294967295u) {
                            phi_3524_ = type_32(_e2387[0], 3u);
                        } else {
                            phi_3524_ = _e2400;
                        }
                        let _e2406 = phi_3524_;
                        phi_3525_ = _e2406;
                    } else {
                        phi_3525_ = _e2400;
                    }
                    let _e2408 = phi_3525_;
                    if (_e2363[1][0] == 4294967295u) {
                        phi_3549_ = 0u;
                    } else {
                        if (_e2363[1][0] >= _e302) {
                            if (_e2363[1][1] >= _e307) {
                                phi_3543_ = false;
                            } else {
                                phi_3543_ = true;
                            }
                            let _e2414 = phi_3543_;
                            phi_3544_ = _e2414;
                        } else {
                            phi_3544_ = true;
                        }
                        let _e2416 = phi_3544_;
                        if _e2416 {
                            phi_3548_ = 1u;
                        } else {
                            phi_3548_ = 2u;
                        }
                        let _e2418 = phi_3548_;
                        phi_3549_ = _e2418;
                    }
                    let _e2420 = phi_3549_;
                    let _e2421 = type_32(_e2371, _e2420);
                    if (_e2420 == 0u) {
                        if (_e2387[1][0] != 4294967295u) {
                            phi_3561_ = type_32(_e2387[1], 3u);
                        } else {
                            phi_3561_ = _e2421;
                        }
                        let _e2427 = phi_3561_;
                        phi_3562_ = _e2427;
                    } else {
                        phi_3562_ = _e2421;
                    }
                    let _e2429 = phi_3562_;
                    if (_e2363[2][0] == 4294967295u) {
                        phi_3586_ = 0u;
                    } else {
                        if (_e2363[2][0] >= _e302) {
                            if (_e2363[2][1] >= _e307) {
                                phi_3580_ = false;
                            } else {
                                phi_3580_ = true;
                            }
                            let _e2435 = phi_3580_;
                            phi_3581_ = _e2435;
                        } else {
                            phi_3581_ = true;
                        }
                        let _e2437 = phi_3581_;
                        if _e2437 {
                            phi_3585_ = 1u;
                        } else {
                            phi_3585_ = 2u;
                        }
                        let _e2439 = phi_3585_;
                        phi_3586_ = _e2439;
                    }
                    let _e2441 = phi_3586_;
                    let _e2442 = type_32(_e2375, _e2441);
                    if (_e2441 == 0u) {
                        if (_e2387[2][0] != 4294967295u) {
                            phi_3598_ = type_32(_e2387[2], 3u);
                        } else {
                            phi_3598_ = _e2442;
                        }
                        let _e2448 = phi_3598_;
                        phi_3599_ = _e2448;
                    } else {
                        phi_3599_ = _e2442;
                    }
                    let _e2450 = phi_3599_;
                    if (_e2363[3][0] == 4294967295u) {
                        phi_3623_ = 0u;
                    } else {
                        if (_e2363[3][0] >= _e302) {
                            if (_e2363[3][1] >= _e307) {
                                phi_3617_ = false;
                            } else {
                                phi_3617_ = true;
                            }
                            let _e2456 = phi_3617_;
                            phi_3618_ = _e2456;
                        } else {
                            phi_3618_ = true;
                        }
                        let _e2458 = phi_3618_;
                        if _e2458 {
                            phi_3622_ = 1u;
                        } else {
                            phi_3622_ = 2u;
                        }
                        let _e2460 = phi_3622_;
                        phi_3623_ = _e2460;
                    }
                    let _e2462 = phi_3623_;
                    let _e2463 = type_32(_e2379, _e2462);
                    if (_e2462 == 0u) {
                        if (_e2387[3][0] != 4294967295u) {
                            phi_3635_ = type_32(_e2387[3], 3u);
                        } else {
                            phi_3635_ = _e2463;
                        }
                        let _e2469 = phi_3635_;
                        phi_3636_ = _e2469;
                    } else {
                        phi_3636_ = _e2463;
                    }
                    let _e2471 = phi_3636_;
                    if (_e285[0] == 4294967295u) {
                        phi_3658_ = 0u;
                    } else {
                        if (_e285[0] >= _e302) {
                            if (_e285[1] >= _e307) {
                                phi_3652_ = false;
                            } else {
                                phi_3652_ = true;
                            }
                            let _e2479 = phi_3652_;
                            phi_3653_ = _e2479;
                        } else {
                            phi_3653_ = true;
                        }
                        let _e2481 = phi_3653_;
                        if _e2481 {
                            phi_3657_ = 1u;
                        } else {
                            phi_3657_ = 2u;
                        }
                        let _e2483 = phi_3657_;
                        phi_3658_ = _e2483;
                    }
                    let _e2485 = phi_3658_;
                    if (_e2485 == 2u) {
                        phi_3664_ = type_32(_e285, 2u);
                    } else {
                        phi_3664_ = _e2408;
                    }
                    let _e2489 = phi_3664_;
                    phi_3665_ = _e2489;
                    phi_3666_ = _e2471;
                    phi_3667_ = _e2450;
                    phi_3668_ = _e2429;
                } else {
                    phi_3665_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3666_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3667_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3668_ = type_32(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2491 = phi_3665_;
                let _e2493 = phi_3666_;
                let _e2495 = phi_3667_;
                let _e2497 = phi_3668_;
                if (_e2491.member_1 == 1u) {
                    let _e2508 = atomicAdd((&shared_[6u]), 1u);
                    phi_3688_ = array<u32, 2>(_e2508, 0u);
                } else {
                    if (_e2491.member_1 == 2u) {
                        let _e2503 = atomicAdd((&shared_[7u]), 1u);
                        phi_3687_ = array<u32, 2>(_e2503, 0u);
                    } else {
                        phi_3687_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2506 = phi_3687_;
                    phi_3688_ = _e2506;
                }
                let _e2511 = phi_3688_;
                if (_e2491.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2515 = atomicAdd((&shared_[8u]), 1u);
                        phi_3700_ = array<u32, 2>(_e2511[0], _e2515);
                    } else {
                        phi_3700_ = _e2511;
                    }
                    let _e2519 = phi_3700_;
                    phi_3701_ = _e2519;
                } else {
                    phi_3701_ = _e2511;
                }
                let _e2521 = phi_3701_;
                if (_e2497.member_1 == 1u) {
                    let _e2531 = atomicAdd((&shared_[6u]), 1u);
                    phi_3719_ = array<u32, 2>(_e2531, 0u);
                } else {
                    if (_e2497.member_1 == 2u) {
                        let _e2526 = atomicAdd((&shared_[7u]), 1u);
                        phi_3718_ = array<u32, 2>(_e2526, 0u);
                    } else {
                        phi_3718_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2529 = phi_3718_;
                    phi_3719_ = _e2529;
                }
                let _e2534 = phi_3719_;
                if (_e2497.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2538 = atomicAdd((&shared_[8u]), 1u);
                        phi_3731_ = array<u32, 2>(_e2534[0], _e2538);
                    } else {
                        phi_3731_ = _e2534;
                    }
                    let _e2542 = phi_3731_;
                    phi_3732_ = _e2542;
                } else {
                    phi_3732_ = _e2534;
                }
                let _e2544 = phi_3732_;
                if (_e2495.member_1 == 1u) {
                    let _e2554 = atomicAdd((&shared_[6u]), 1u);
                    phi_3750_ = array<u32, 2>(_e2554, 0u);
                } else {
                    if (_e2495.member_1 == 2u) {
                        let _e2549 = atomicAdd((&shared_[7u]), 1u);
                        phi_3749_ = array<u32, 2>(_e2549, 0u);
                    } else {
                        phi_3749_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2552 = phi_3749_;
                    phi_3750_ = _e2552;
                }
                let _e2557 = phi_3750_;
                if (_e2495.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2561 = atomicAdd((&shared_[8u]), 1u);
                        phi_3762_ = array<u32, 2>(_e2557[0], _e2561);
                    } else {
                        phi_3762_ = _e2557;
                    }
                    let _e2565 = phi_3762_;
                    phi_3763_ = _e2565;
                } else {
                    phi_3763_ = _e2557;
                }
                let _e2567 = phi_3763_;
                if (_e2493.member_1 == 1u) {
                    let _e2577 = atomicAdd((&shared_[6u]), 1u);
                    phi_3781_ = array<u32, 2>(_e2577, 0u);
                } else {
                    if (_e2493.member_1 == 2u) {
                        let _e2572 = atomicAdd((&shared_[7u]), 1u);
                        phi_3780_ = array<u32, 2>(_e2572, 0u);
                    } else {
                        phi_3780_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2575 = phi_3780_;
                    phi_3781_ = _e2575;
                }
                let _e2580 = phi_3781_;
                if (_e2493.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2584 = atomicAdd((&shared_[8u]), 1u);
                        phi_3793_ = array<u32, 2>(_e2580[0], _e2584);
                    } else {
                        phi_3793_ = _e2580;
                    }
                    let _e2588 = phi_3793_;
                    phi_3794_ = _e2588;
                } else {
                    phi_3794_ = _e2580;
                }
                let _e2590 = phi_3794_;
                workgroupBarrier();
                if (_e72 == 0u) {
                    let _e2593 = atomicLoad((&shared_[6u]));
                    let _e2595 = atomicLoad((&shared_[7u]));
                    let _e2597 = atomicLoad((&shared_[8u]));
                    let _e2599 = atomicLoad((&shared_[1u]));
                    let _e2601 = atomicLoad((&shared_[2u]));
                    let _e2603 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2603 + 1u));
                    let _e2607 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2607 + _e2599) + _e2601));
                    let _e2612 = atomicLoad((&shared_[0u]));
                    let _e2613 = (_e2612 - _e2599);
                    let _e2615 = (_e87.member_10 - _e2613);
                    if (_e2615 < _e2593) {
                        phi_3827_ = _e2615;
                    } else {
                        phi_3827_ = _e2593;
                    }
                    let _e2618 = phi_3827_;
                    atomicStore((&shared_[9u]), _e2613);
                    atomicStore((&shared_[10u]), _e2618);
                    atomicStore((&shared_[0u]), (_e2613 + _e2618));
                    if (_e2593 > _e2618) {
                        let _e2624 = (_e2593 - _e2618);
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e2628 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2631 = atomicAdd((&control.member[(_e90 + 1u)]), _e2624);
                        let _e2634 = atomicMax((&nodes.member[0u]), (_e2631 + _e2624));
                        if ((_e2631 + _e2624) < _e2631) {
                            let _e2638 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2631);
                    }
                    if (_e2595 > 0u) {
                        let _e2642 = atomicAdd((&pairs.member[0u]), _e2595);
                        if ((_e2642 + _e2595) < _e2642) {
                            let _e2646 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2642);
                    }
                    if (_e2597 > 0u) {
                        let _e2650 = atomicAdd((&control.member[1537u]), _e2597);
                        if ((_e2650 + _e2597) < _e2650) {
                            let _e2654 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2650);
                    }
                }
                workgroupBarrier();
                if (_e2491.member_1 == 1u) {
                    let _e2712 = atomicLoad((&shared_[10u]));
                    if (_e2521[0] < _e2712) {
                        let _e2732 = atomicLoad((&shared_[9u]));
                        let _e2735 = (2u * (_e2732 + _e2521[0]));
                        stack[_e2735] = _e2491.member[0];
                        stack[(_e2735 + 1u)] = _e2491.member[1];
                    } else {
                        let _e2716 = atomicLoad((&shared_[11u]));
                        let _e2719 = ((_e2716 + _e2521[0]) - _e2712);
                        if (_e2719 < _e87.member_3) {
                            let _e2722 = (_e101 + _e2719);
                            if (_e2722 < 4294967295u) {
                                let _e2726 = (2u * _e2722);
                                atomicStore((&nodes.member[(4u + _e2726)]), _e2491.member[0]);
                                atomicStore((&nodes.member[(_e2726 + 5u)]), _e2491.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2491.member_1 == 0u) {
                    } else {
                        if (_e2491.member_1 == 2u) {
                            let _e2665 = a_nodes.member[_e2491.member[0]];
                            let _e2669 = b_nodes.member[_e2491.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2665.member_1 < _e2669.member_1) {
                                    phi_3987_ = type_9(_e2665.member_1, _e2669.member_1);
                                } else {
                                    phi_3987_ = type_9(_e2669.member_1, _e2665.member_1);
                                }
                                let _e2678 = phi_3987_;
                                phi_3992_ = _e2678;
                            } else {
                                phi_3992_ = type_9(_e2665.member_1, _e2669.member_1);
                            }
                            let _e2680 = phi_3992_;
                            let _e2684 = atomicLoad((&shared_[12u]));
                            let _e2686 = (_e2684 + _e2521[0]);
                            if (_e2686 < _e103) {
                                let _e2688 = (2u * _e2686);
                                atomicStore((&pairs.member[(4u + _e2688)]), _e2680.member);
                                atomicStore((&pairs.member[(_e2688 + 5u)]), _e2680.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2696 = atomicLoad((&shared_[13u]));
                            let _e2698 = (_e2696 + _e2521[1]);
                            if (_e2698 < _e87.member_4) {
                                let _e2705 = (2u * ((_e87.member_5 * _e87.member_4) + _e2698));
                                front.member[_e2705] = _e2491.member[0];
                                front.member[(_e2705 + 1u)] = _e2491.member[1];
                            }
                        }
                    }
                }
                if (_e2497.member_1 == 1u) {
                    let _e2797 = atomicLoad((&shared_[10u]));
                    if (_e2544[0] < _e2797) {
                        let _e2817 = atomicLoad((&shared_[9u]));
                        let _e2820 = (2u * (_e2817 + _e2544[0]));
                        stack[_e2820] = _e2497.member[0];
                        stack[(_e2820 + 1u)] = _e2497.member[1];
                    } else {
                        let _e2801 = atomicLoad((&shared_[11u]));
                        let _e2804 = ((_e2801 + _e2544[0]) - _e2797);
                        if (_e2804 < _e87.member_3) {
                            let _e2807 = (_e101 + _e2804);
                            if (_e2807 < 4294967295u) {
                                let _e2811 = (2u * _e2807);
                                atomicStore((&nodes.member[(4u + _e2811)]), _e2497.member[0]);
                                atomicStore((&nodes.member[(_e2811 + 5u)]), _e2497.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2497.member_1 == 0u) {
                    } else {
                        if (_e2497.member_1 == 2u) {
                            let _e2750 = a_nodes.member[_e2497.member[0]];
                            let _e2754 = b_nodes.member[_e2497.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2750.member_1 < _e2754.member_1) {
                                    phi_4128_ = type_9(_e2750.member_1, _e2754.member_1);
                                } else {
                                    phi_4128_ = type_9(_e2754.member_1, _e2750.member_1);
                                }
                                let _e2763 = phi_4128_;
                                phi_4133_ = _e2763;
                            } else {
                                phi_4133_ = type_9(_e2750.member_1, _e2754.member_1);
                            }
                            let _e2765 = phi_4133_;
                            let _e2769 = atomicLoad((&shared_[12u]));
                            let _e2771 = (_e2769 + _e2544[0]);
                            if (_e2771 < _e103) {
                                let _e2773 = (2u * _e2771);
                                atomicStore((&pairs.member[(4u + _e2773)]), _e2765.member);
                                atomicStore((&pairs.member[(_e2773 + 5u)]), _e2765.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2781 = atomicLoad((&shared_[13u]));
                            let _e2783 = (_e2781 + _e2544[1]);
                            if (_e2783 < _e87.member_4) {
                                let _e2790 = (2u * ((_e87.member_5 * _e87.member_4) + _e2783));
                                front.member[_e2790] = _e2497.member[0];
                                front.member[(_e2790 + 1u)] = _e2497.member[1];
                            }
                        }
                    }
                }
                if (_e2495.member_1 == 1u) {
                    let _e2882 = atomicLoad((&shared_[10u]));
                    if (_e2567[0] < _e2882) {
                        let _e2902 = atomicLoad((&shared_[9u]));
                        let _e2905 = (2u * (_e2902 + _e2567[0]));
                        stack[_e2905] = _e2495.member[0];
                        stack[(_e2905 + 1u)] = _e2495.member[1];
                    } else {
                        let _e2886 = atomicLoad((&shared_[11u]));
                        let _e2889 = ((_e2886 + _e2567[0]) - _e2882);
                        if (_e2889 < _e87.member_3) {
                            let _e2892 = (_e101 + _e2889);
                            if (_e2892 < 4294967295u) {
                                let _e2896 = (2u * _e2892);
                                atomicStore((&nodes.member[(4u + _e2896)]), _e2495.member[0]);
                                atomicStore((&nodes.member[(_e2896 + 5u)]), _e2495.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2495.member_1 == 0u) {
                    } else {
                        if (_e2495.member_1 == 2u) {
                            let _e2835 = a_nodes.member[_e2495.member[0]];
                            let _e2839 = b_nodes.member[_e2495.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2835.member_1 < _e2839.member_1) {
                                    phi_4269_ = type_9(_e2835.member_1, _e2839.member_1);
                                } else {
                                    phi_4269_ = type_9(_e2839.member_1, _e2835.member_1);
                                }
                                let _e2848 = phi_4269_;
                                phi_4274_ = _e2848;
                            } else {
                                phi_4274_ = type_9(_e2835.member_1, _e2839.member_1);
                            }
                            let _e2850 = phi_4274_;
                            let _e2854 = atomicLoad((&shared_[12u]));
                            let _e2856 = (_e2854 + _e2567[0]);
                            if (_e2856 < _e103) {
                                let _e2858 = (2u * _e2856);
                                atomicStore((&pairs.member[(4u + _e2858)]), _e2850.member);
                                atomicStore((&pairs.member[(_e2858 + 5u)]), _e2850.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2866 = atomicLoad((&shared_[13u]));
                            let _e2868 = (_e2866 + _e2567[1]);
                            if (_e2868 < _e87.member_4) {
                                let _e2875 = (2u * ((_e87.member_5 * _e87.member_4) + _e2868));
                                front.member[_e2875] = _e2495.member[0];
                                front.member[(_e2875 + 1u)] = _e2495.member[1];
                            }
                        }
                    }
                }
                if (_e2493.member_1 == 1u) {
                    let _e2967 = atomicLoad((&shared_[10u]));
                    if (_e2590[0] < _e2967) {
                        let _e2987 = atomicLoad((&shared_[9u]));
                        let _e2990 = (2u * (_e2987 + _e2590[0]));
                        stack[_e2990] = _e2493.member[0];
                        stack[(_e2990 + 1u)] = _e2493.member[1];
                    } else {
                        let _e2971 = atomicLoad((&shared_[11u]));
                        let _e2974 = ((_e2971 + _e2590[0]) - _e2967);
                        if (_e2974 < _e87.member_3) {
                            let _e2977 = (_e101 + _e2974);
                            if (_e2977 < 4294967295u) {
                                let _e2981 = (2u * _e2977);
                                atomicStore((&nodes.member[(4u + _e2981)]), _e2493.member[0]);
                                atomicStore((&nodes.member[(_e2981 + 5u)]), _e2493.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2493.member_1 == 0u) {
                    } else {
                        if (_e2493.member_1 == 2u) {
                            let _e2920 = a_nodes.member[_e2493.member[0]];
                            let _e2924 = b_nodes.member[_e2493.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2920.member_1 < _e2924.member_1) {
                                    phi_4410_ = type_9(_e2920.member_1, _e2924.member_1);
                                } else {
                                    phi_4410_ = type_9(_e2924.member_1, _e2920.member_1);
                                }
                                let _e2933 = phi_4410_;
                                phi_4415_ = _e2933;
                            } else {
                                phi_4415_ = type_9(_e2920.member_1, _e2924.member_1);
                            }
                            let _e2935 = phi_4415_;
                            let _e2939 = atomicLoad((&shared_[12u]));
                            let _e2941 = (_e2939 + _e2590[0]);
                            if (_e2941 < _e103) {
                                let _e2943 = (2u * _e2941);
                                atomicStore((&pairs.member[(4u + _e2943)]), _e2935.member);
                                atomicStore((&pairs.member[(_e2943 + 5u)]), _e2935.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2951 = atomicLoad((&shared_[13u]));
                            let _e2953 = (_e2951 + _e2590[1]);
                            if (_e2953 < _e87.member_4) {
                                let _e2960 = (2u * ((_e87.member_5 * _e87.member_4) + _e2953));
                                front.member[_e2960] = _e2493.member[0];
                                front.member[(_e2960 + 1u)] = _e2493.member[1];
                            }
                        }
                    }
                }
                phi_4459_ = true;
            }
            let _e2997 = phi_4459_;
            phi_4460_ = _e2997;
        } else {
            phi_4460_ = false;
        }
        let _e2999 = phi_4460_;
        continue;
        continuing {
            phi_201_ = _e124;
            break if !(_e2999);
        }
    }
    if (_e72 == 0u) {
        if (_e87.member_6 == 0u) {
            if (_e85 < _e98) {
                phi_4479_ = ((((_e98 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
            } else {
                phi_4479_ = 0u;
            }
            let _e3012 = phi_4479_;
            let _e3014 = atomicLoad((&shared_[5u]));
            phi_4483_ = (_e3012 - _e3014);
        } else {
            phi_4483_ = 0u;
        }
        let _e3017 = phi_4483_;
        atomicStore((&shared_[14u]), _e3017);
        let _e3020 = atomicLoad((&shared_[0u]));
        let _e3021 = (_e3020 + _e3017);
        if (_e3021 > 0u) {
            if (_e87.member_12 == 0u) {
            } else {
                let _e3026 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e3029 = atomicAdd((&control.member[(_e90 + 1u)]), _e3021);
            let _e3032 = atomicMax((&nodes.member[0u]), (_e3029 + _e3021));
            if ((_e3029 + _e3021) < _e3029) {
                let _e3036 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e3029);
        }
        let _e3041 = atomicLoad((&shared_[15u]));
        let _e3043 = atomicAdd((&control.member[(1540u + (2u * _e85))]), _e3041);
        let _e3047 = atomicLoad((&shared_[16u]));
        let _e3049 = atomicAdd((&control.member[((2u * _e85) + 1541u)]), _e3047);
    }
    workgroupBarrier();
    let _e3051 = atomicLoad((&shared_[0u]));
    let _e3053 = atomicLoad((&shared_[17u]));
    let _e3055 = atomicLoad((&shared_[14u]));
    phi_4540_ = type_9(0u, 8u);
    loop {
        let _e3057 = phi_4540_;
        if (_e3057.member < _e3057.member_1) {
            phi_4541_ = type_9((_e3057.member + 1u), _e3057.member_1);
            phi_4564_ = type_9(1u, _e3057.member);
        } else {
            phi_4541_ = _e3057;
            phi_4564_ = type_9(0u, type_9().member_1);
        }
        let _e3069 = phi_4541_;
        let _e3071 = phi_4564_;
        let _e3075 = (bitcast<i32>(_e3071.member) != 0i);
        if _e3075 {
            let _e3077 = ((_e3071.member_1 * 128u) + _e72);
            if (_e3077 < _e3051) {
                let _e3081 = stack[(2u * _e3077)];
                let _e3085 = stack[((2u * _e3077) + 1u)];
                let _e3086 = (_e3053 + _e3077);
                if (_e3086 < _e87.member_3) {
                    let _e3089 = (_e101 + _e3086);
                    if (_e3089 < 4294967295u) {
                        let _e3091 = (2u * _e3089);
                        atomicStore((&nodes.member[(4u + _e3091)]), _e3081);
                        atomicStore((&nodes.member[(_e3091 + 5u)]), _e3085);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4540_ = _e3069;
            break if !(_e3075);
        }
    }
    let _e3098 = atomicLoad((&shared_[5u]));
    let _e3099 = (_e3055 / 128u);
    if ((_e3055 % 128u) > 0u) {
        phi_4620_ = (_e3099 + 1u);
    } else {
        phi_4620_ = _e3099;
    }
    let _e3104 = phi_4620_;
    phi_4623_ = type_9(0u, _e3104);
    loop {
        let _e3107 = phi_4623_;
        if (_e3107.member < _e3107.member_1) {
            phi_4624_ = type_9((_e3107.member + 1u), _e3107.member_1);
            phi_4647_ = type_9(1u, _e3107.member);
        } else {
            phi_4624_ = _e3107;
            phi_4647_ = type_9(0u, type_9().member_1);
        }
        let _e3119 = phi_4624_;
        let _e3121 = phi_4647_;
        let _e3125 = (bitcast<i32>(_e3121.member) != 0i);
        if _e3125 {
            let _e3127 = ((_e3121.member_1 * 128u) + _e72);
            if (_e3127 < _e3055) {
                let _e3135 = (2u * ((_e99 + _e85) + ((_e3098 + _e3127) << bitcast<u32>((_e87.member_7 & 31u)))));
                let _e3138 = atomicLoad((&nodes.member[(4u + _e3135)]));
                let _e3141 = atomicLoad((&nodes.member[(_e3135 + 5u)]));
                let _e3143 = ((_e3053 + _e3051) + _e3127);
                if (_e3143 < _e87.member_3) {
                    let _e3146 = (_e101 + _e3143);
                    if (_e3146 < 4294967295u) {
                        let _e3148 = (2u * _e3146);
                        atomicStore((&nodes.member[(4u + _e3148)]), _e3138);
                        atomicStore((&nodes.member[(_e3148 + 5u)]), _e3141);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4623_ = _e3119;
            break if !(_e3125);
        }
    }
    if (_e87.member_6 == 1u) {
        if (_e3098 == 0u) {
            phi_4719_ = type_9(0u, _e98);
            loop {
                let _e3159 = phi_4719_;
                if (_e3159.member < _e3159.member_1) {
                    phi_4720_ = type_9((_e3159.member + 1u), _e3159.member_1);
                    phi_4743_ = type_9(1u, _e3159.member);
                } else {
                    phi_4720_ = _e3159;
                    phi_4743_ = type_9(0u, type_9().member_1);
                }
                let _e3171 = phi_4720_;
                let _e3173 = phi_4743_;
                if (bitcast<i32>(_e3173.member) != 0i) {
                    let _e3179 = atomicAdd((&control.member[(512u + _e90)]), 1u);
                    if (_e3179 >= _e98) {
                        phi_4823_ = false;
                    } else {
                        let _e3182 = (2u * (_e99 + _e3179));
                        let _e3185 = atomicLoad((&nodes.member[(4u + _e3182)]));
                        let _e3188 = atomicLoad((&nodes.member[(_e3182 + 5u)]));
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e3192 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3195 = atomicAdd((&control.member[(_e90 + 1u)]), 1u);
                        let _e3198 = atomicMax((&nodes.member[0u]), (_e3195 + 1u));
                        if ((_e3195 + 1u) < _e3195) {
                            let _e3202 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3195 < _e87.member_3) {
                            let _e3205 = (_e101 + _e3195);
                            if (_e3205 < 4294967295u) {
                                let _e3207 = (2u * _e3205);
                                atomicStore((&nodes.member[(4u + _e3207)]), _e3185);
                                atomicStore((&nodes.member[(_e3207 + 5u)]), _e3188);
                            }
                        }
                        phi_4823_ = true;
                    }
                    let _e3213 = phi_4823_;
                    phi_4824_ = _e3213;
                } else {
                    phi_4824_ = false;
                }
                let _e3215 = phi_4824_;
                continue;
                continuing {
                    phi_4719_ = _e3171;
                    break if !(_e3215);
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
