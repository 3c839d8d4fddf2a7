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
var<workgroup> shared_: array<atomic<u32>, 22>;
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
    var phi_181_: u32;
    var phi_198_: type_12;
    var phi_199_: type_12;
    var phi_222_: type_12;
    var phi_240_: u32;
    var phi_270_: bool;
    var phi_274_: u32;
    var phi_275_: u32;
    var phi_276_: u32;
    var phi_330_: u32;
    var phi_335_: u32;
    var phi_340_: u32;
    var phi_349_: u32;
    var phi_355_: u32;
    var phi_361_: u32;
    var phi_302_: u32;
    var phi_308_: u32;
    var phi_362_: u32;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_383_: u32;
    var phi_384_: u32;
    var phi_453_: array<u32, 2>;
    var phi_454_: array<u32, 2>;
    var phi_468_: array<u32, 2>;
    var phi_494_: u32;
    var phi_566_: array<u32, 2>;
    var phi_602_: array<u32, 2>;
    var phi_612_: array<u32, 2>;
    var phi_614_: array<array<u32, 2>, 4>;
    var phi_615_: array<array<u32, 2>, 4>;
    var phi_616_: bool;
    var phi_617_: array<array<u32, 2>, 4>;
    var phi_618_: bool;
    var phi_630_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_651_: bool;
    var phi_656_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_704_: bool;
    var phi_706_: bool;
    var phi_715_: bool;
    var phi_720_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_768_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_887_: array<u32, 2>;
    var phi_917_: array<u32, 2>;
    var phi_947_: array<u32, 2>;
    var phi_977_: array<u32, 2>;
    var phi_979_: array<array<u32, 2>, 4>;
    var phi_980_: bool;
    var phi_981_: array<array<u32, 2>, 4>;
    var phi_982_: bool;
    var phi_1141_: array<u32, 2>;
    var phi_1173_: array<u32, 2>;
    var phi_1048_: array<u32, 2>;
    var phi_1080_: array<u32, 2>;
    var phi_1175_: array<array<u32, 2>, 4>;
    var phi_1176_: array<array<u32, 2>, 4>;
    var phi_1177_: array<array<u32, 2>, 4>;
    var phi_1178_: bool;
    var phi_1179_: array<array<u32, 2>, 4>;
    var phi_1180_: bool;
    var phi_1184_: array<array<u32, 2>, 4>;
    var phi_1185_: array<array<u32, 2>, 4>;
    var phi_1186_: bool;
    var phi_1190_: array<array<u32, 2>, 4>;
    var phi_1200_: array<u32, 2>;
    var phi_1232_: array<u32, 2>;
    var phi_1270_: type_12;
    var phi_1271_: type_12;
    var phi_1294_: type_12;
    var phi_1323_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1409_: f32;
    var phi_1415_: f32;
    var phi_1421_: f32;
    var phi_1427_: f32;
    var phi_1433_: f32;
    var phi_1439_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1467_: f32;
    var phi_1483_: type_31;
    var phi_1553_: f32;
    var phi_1559_: f32;
    var phi_1565_: f32;
    var phi_1571_: f32;
    var phi_1577_: f32;
    var phi_1583_: f32;
    var phi_1601_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1627_: type_31;
    var phi_1817_: f32;
    var phi_1823_: f32;
    var phi_1830_: f32;
    var phi_1839_: f32;
    var phi_1846_: f32;
    var phi_1854_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1878_: f32;
    var phi_1971_: f32;
    var phi_1978_: f32;
    var phi_1984_: f32;
    var phi_1990_: f32;
    var phi_2009_: f32;
    var phi_2016_: f32;
    var phi_2022_: f32;
    var phi_2028_: f32;
    var phi_2047_: f32;
    var phi_2054_: f32;
    var phi_2060_: f32;
    var phi_2066_: f32;
    var phi_2085_: f32;
    var phi_2092_: f32;
    var phi_2098_: f32;
    var phi_2104_: f32;
    var phi_2123_: f32;
    var phi_2130_: f32;
    var phi_2136_: f32;
    var phi_2142_: f32;
    var phi_2161_: f32;
    var phi_2168_: f32;
    var phi_2174_: f32;
    var phi_2180_: f32;
    var phi_2195_: f32;
    var phi_2200_: f32;
    var phi_2205_: f32;
    var phi_2210_: f32;
    var phi_2215_: f32;
    var phi_2274_: f32;
    var phi_2297_: f32;
    var phi_2320_: f32;
    var phi_2342_: f32;
    var phi_2358_: f32;
    var phi_2413_: f32;
    var phi_2436_: f32;
    var phi_2459_: f32;
    var phi_2481_: f32;
    var phi_2497_: f32;
    var phi_2552_: f32;
    var phi_2575_: f32;
    var phi_2598_: f32;
    var phi_2620_: f32;
    var phi_2636_: f32;
    var phi_2691_: f32;
    var phi_2714_: f32;
    var phi_2738_: f32;
    var phi_2761_: f32;
    var phi_2777_: f32;
    var phi_2832_: f32;
    var phi_2855_: f32;
    var phi_2879_: f32;
    var phi_2902_: f32;
    var phi_2918_: f32;
    var phi_2973_: f32;
    var phi_2996_: f32;
    var phi_3020_: f32;
    var phi_3043_: f32;
    var phi_3059_: f32;
    var phi_3114_: f32;
    var phi_3137_: f32;
    var phi_3161_: f32;
    var phi_3184_: f32;
    var phi_3200_: f32;
    var phi_3255_: f32;
    var phi_3278_: f32;
    var phi_3302_: f32;
    var phi_3325_: f32;
    var phi_3341_: f32;
    var phi_3396_: f32;
    var phi_3419_: f32;
    var phi_3443_: f32;
    var phi_3466_: f32;
    var phi_3482_: f32;
    var phi_3489_: f32;
    var phi_3494_: f32;
    var phi_3499_: f32;
    var phi_3504_: f32;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3519_: f32;
    var phi_3524_: f32;
    var phi_3528_: bool;
    var phi_3530_: bool;
    var phi_3531_: bool;
    var phi_3532_: bool;
    var phi_3533_: bool;
    var phi_3537_: bool;
    var phi_3625_: array<u32, 2>;
    var phi_3647_: array<u32, 2>;
    var phi_3649_: array<array<u32, 2>, 4>;
    var phi_3650_: array<array<u32, 2>, 4>;
    var phi_3651_: bool;
    var phi_3652_: array<array<u32, 2>, 4>;
    var phi_3653_: bool;
    var phi_3665_: bool;
    var phi_3673_: bool;
    var phi_3674_: bool;
    var phi_3686_: bool;
    var phi_3691_: bool;
    var phi_3732_: bool;
    var phi_3733_: bool;
    var phi_3734_: bool;
    var phi_3735_: bool;
    var phi_3739_: bool;
    var phi_3741_: bool;
    var phi_3750_: bool;
    var phi_3755_: bool;
    var phi_3796_: bool;
    var phi_3797_: bool;
    var phi_3798_: bool;
    var phi_3799_: bool;
    var phi_3803_: bool;
    var phi_3813_: bool;
    var phi_3814_: bool;
    var phi_3826_: bool;
    var phi_3827_: bool;
    var phi_3850_: array<array<u32, 2>, 4>;
    var phi_3851_: bool;
    var phi_3852_: array<array<u32, 2>, 4>;
    var phi_3853_: bool;
    var phi_3870_: array<array<u32, 2>, 4>;
    var phi_3871_: array<array<u32, 2>, 4>;
    var phi_3872_: array<array<u32, 2>, 4>;
    var phi_3873_: bool;
    var phi_3874_: array<array<u32, 2>, 4>;
    var phi_3875_: bool;
    var phi_3879_: array<array<u32, 2>, 4>;
    var phi_3880_: array<array<u32, 2>, 4>;
    var phi_3881_: bool;
    var phi_3885_: array<array<u32, 2>, 4>;
    var phi_3886_: array<array<u32, 2>, 4>;
    var phi_3904_: bool;
    var phi_3905_: bool;
    var phi_3909_: u32;
    var phi_3910_: u32;
    var phi_3922_: type_24;
    var phi_3923_: type_24;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3946_: u32;
    var phi_3947_: u32;
    var phi_3959_: type_24;
    var phi_3960_: type_24;
    var phi_3978_: bool;
    var phi_3979_: bool;
    var phi_3983_: u32;
    var phi_3984_: u32;
    var phi_3996_: type_24;
    var phi_3997_: type_24;
    var phi_4015_: bool;
    var phi_4016_: bool;
    var phi_4020_: u32;
    var phi_4021_: u32;
    var phi_4033_: type_24;
    var phi_4034_: type_24;
    var phi_4050_: bool;
    var phi_4051_: bool;
    var phi_4055_: u32;
    var phi_4056_: u32;
    var phi_4062_: type_24;
    var phi_4063_: type_24;
    var phi_4064_: type_24;
    var phi_4065_: type_24;
    var phi_4066_: type_24;
    var phi_4085_: array<u32, 2>;
    var phi_4086_: array<u32, 2>;
    var phi_4098_: array<u32, 2>;
    var phi_4099_: array<u32, 2>;
    var phi_4116_: array<u32, 2>;
    var phi_4117_: array<u32, 2>;
    var phi_4129_: array<u32, 2>;
    var phi_4130_: array<u32, 2>;
    var phi_4147_: array<u32, 2>;
    var phi_4148_: array<u32, 2>;
    var phi_4160_: array<u32, 2>;
    var phi_4161_: array<u32, 2>;
    var phi_4178_: array<u32, 2>;
    var phi_4179_: array<u32, 2>;
    var phi_4191_: array<u32, 2>;
    var phi_4192_: array<u32, 2>;
    var phi_4225_: u32;
    var phi_4385_: type_12;
    var phi_4390_: type_12;
    var phi_4526_: type_12;
    var phi_4531_: type_12;
    var phi_4667_: type_12;
    var phi_4672_: type_12;
    var phi_4808_: type_12;
    var phi_4813_: type_12;
    var phi_4857_: bool;
    var phi_4858_: bool;
    var phi_4877_: u32;
    var phi_4881_: u32;
    var phi_4938_: type_12;
    var phi_4939_: type_12;
    var phi_4962_: type_12;
    var phi_5018_: u32;
    var phi_5021_: type_12;
    var phi_5022_: type_12;
    var phi_5045_: type_12;
    var phi_5117_: type_12;
    var phi_5118_: type_12;
    var phi_5141_: type_12;
    var phi_5221_: bool;
    var phi_5222_: bool;
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
        phi_181_ = _e87.member_3;
    } else {
        phi_181_ = _e95;
    }
    let _e98 = phi_181_;
    let _e99 = (_e92 * _e87.member_3);
    let _e101 = ((1u - _e92) * _e87.member_3);
    let _e103 = params.member.member_1.member_3;
    if (_e72 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_198_ = type_12(0u, _e87.member_11);
    loop {
        let _e112 = phi_198_;
        if (_e112.member < _e112.member_1) {
            phi_199_ = type_12((_e112.member + 1u), _e112.member_1);
            phi_222_ = type_12(1u, _e112.member);
        } else {
            phi_199_ = _e112;
            phi_222_ = type_12(0u, type_12().member_1);
        }
        let _e124 = phi_199_;
        let _e126 = phi_222_;
        if (bitcast<i32>(_e126.member) != 0i) {
            if (_e72 == 0u) {
                let _e133 = atomicLoad((&shared_[0u]));
                if (128u < _e133) {
                    phi_240_ = 128u;
                } else {
                    phi_240_ = _e133;
                }
                let _e136 = phi_240_;
                if (_e87.member_9 > 0u) {
                    if (_e126.member_1 >= 16u) {
                        let _e142 = atomicLoad((&control.member[(1024u + _e90)]));
                        if (_e87.member_9 > 0u) {
                            phi_270_ = ((_e142 * 100u) >= (_e87.member_9 << bitcast<u32>((_e87.member_7 & 31u))));
                        } else {
                            phi_270_ = false;
                        }
                        let _e151 = phi_270_;
                        if _e151 {
                            phi_274_ = 2u;
                        } else {
                            phi_274_ = 0u;
                        }
                        let _e153 = phi_274_;
                        phi_275_ = _e153;
                    } else {
                        phi_275_ = 0u;
                    }
                    let _e155 = phi_275_;
                    phi_276_ = _e155;
                } else {
                    phi_276_ = 0u;
                }
                let _e157 = phi_276_;
                let _e158 = (128u - _e136);
                if (_e157 == 0u) {
                    if (_e158 > 0u) {
                        let _e162 = atomicLoad((&shared_[5u]));
                        if (_e87.member_6 == 0u) {
                            if (_e85 < _e98) {
                                phi_302_ = ((((_e98 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
                            } else {
                                phi_302_ = 0u;
                            }
                            let _e205 = phi_302_;
                            let _e206 = (_e205 - _e162);
                            if (_e158 < _e206) {
                                phi_308_ = _e158;
                            } else {
                                phi_308_ = _e206;
                            }
                            let _e209 = phi_308_;
                            atomicStore((&shared_[3u]), (_e85 + (_e162 << bitcast<u32>((_e87.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e87.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e162 + _e209));
                            phi_362_ = _e209;
                        } else {
                            if (_e162 == 0u) {
                                let _e170 = (_e98 >> bitcast<u32>(((_e87.member_7 + 2u) & 31u)));
                                if (_e87.member_8 < _e170) {
                                    phi_330_ = _e170;
                                } else {
                                    phi_330_ = _e87.member_8;
                                }
                                let _e173 = phi_330_;
                                if (128u < _e173) {
                                    phi_335_ = 128u;
                                } else {
                                    phi_335_ = _e173;
                                }
                                let _e176 = phi_335_;
                                if (_e158 < _e176) {
                                    phi_340_ = _e158;
                                } else {
                                    phi_340_ = _e176;
                                }
                                let _e179 = phi_340_;
                                let _e182 = atomicAdd((&control.member[(512u + _e90)]), _e179);
                                if (_e98 < _e182) {
                                    phi_349_ = _e98;
                                } else {
                                    phi_349_ = _e182;
                                }
                                let _e185 = phi_349_;
                                let _e186 = (_e98 - _e185);
                                if (_e179 < _e186) {
                                    phi_355_ = _e179;
                                } else {
                                    phi_355_ = _e186;
                                }
                                let _e189 = phi_355_;
                                atomicStore((&shared_[3u]), _e182);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e189 < _e179)));
                                phi_361_ = _e189;
                            } else {
                                phi_361_ = 0u;
                            }
                            let _e196 = phi_361_;
                            phi_362_ = _e196;
                        }
                        let _e222 = phi_362_;
                        phi_363_ = _e222;
                    } else {
                        phi_363_ = 0u;
                    }
                    let _e224 = phi_363_;
                    phi_364_ = _e224;
                } else {
                    phi_364_ = 0u;
                }
                let _e226 = phi_364_;
                if (_e157 == 0u) {
                    if ((_e136 + _e226) == 0u) {
                        if (_e87.member_9 > 0u) {
                            let _e234 = atomicAdd((&control.member[(1024u + _e90)]), 1u);
                        }
                        phi_383_ = 1u;
                    } else {
                        phi_383_ = _e157;
                    }
                    let _e236 = phi_383_;
                    phi_384_ = _e236;
                } else {
                    phi_384_ = _e157;
                }
                let _e238 = phi_384_;
                atomicStore((&shared_[1u]), _e136);
                atomicStore((&shared_[2u]), _e226);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e238;
            }
            let _e246 = workgroupUniformLoad((&state[0u]));
            if (_e246 != 0u) {
                phi_4857_ = false;
            } else {
                let _e249 = atomicLoad((&shared_[1u]));
                let _e251 = atomicLoad((&shared_[2u]));
                if (_e72 < _e249) {
                    let _e274 = atomicLoad((&shared_[0u]));
                    let _e277 = (2u * ((_e274 - 1u) - _e72));
                    let _e279 = stack[_e277];
                    let _e282 = stack[(_e277 + 1u)];
                    phi_454_ = array<u32, 2>(_e279, _e282);
                } else {
                    if (_e72 < (_e249 + _e251)) {
                        let _e256 = atomicLoad((&shared_[3u]));
                        let _e259 = atomicLoad((&shared_[4u]));
                        let _e263 = (2u * (_e99 + (_e256 + ((_e72 - _e249) * _e259))));
                        let _e266 = atomicLoad((&nodes.member[(4u + _e263)]));
                        let _e269 = atomicLoad((&nodes.member[(_e263 + 5u)]));
                        phi_453_ = array<u32, 2>(_e266, _e269);
                    } else {
                        phi_453_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e272 = phi_453_;
                    phi_454_ = _e272;
                }
                let _e285 = phi_454_;
                let _e288 = params.member.member_2.member;
                let _e289 = (_e288 == 1u);
                let _e292 = params.member.member_2.member;
                if (_e292 == 0u) {
                    phi_468_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_468_ = array<u32, 2>(1u, 1u);
                }
                let _e295 = phi_468_;
                let _e301 = params.member.member.member[_e295[0]];
                let _e302 = (_e301 - 1u);
                let _e306 = params.member.member.member[_e295[1]];
                let _e307 = (_e306 - 1u);
                let _e310 = params.member.member_2.member_1;
                if (_e310 == 0u) {
                    phi_494_ = 1u;
                } else {
                    phi_494_ = 0u;
                }
                let _e313 = phi_494_;
                if (_e285[0] != 4294967295u) {
                    let _e319 = a_nodes.member[_e285[0]];
                    let _e321 = b_nodes.member[_e285[1]];
                    if _e289 {
                        if (_e285[0] == _e285[1]) {
                            if (_e319.member_3 == 4294967295u) {
                                phi_614_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            } else {
                                let _e327 = a_nodes.member[_e319.member_1];
                                let _e330 = a_nodes.member[_e319.member_3];
                                if !((_e327.member_3 == 4294967295u)) {
                                    phi_566_ = array<u32, 2>(_e319.member_1, _e319.member_1);
                                } else {
                                    phi_566_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e338 = phi_566_;
                                if ((((((_e327.member[0] <= _e330.member_2[0]) && (_e330.member[0] <= _e327.member_2[0])) && (_e327.member[1] <= _e330.member_2[1])) && (_e330.member[1] <= _e327.member_2[1])) && (_e327.member[2] <= _e330.member_2[2])) && (_e330.member[2] <= _e327.member_2[2])) {
                                    phi_602_ = array<u32, 2>(_e319.member_1, _e319.member_3);
                                } else {
                                    phi_602_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e370 = phi_602_;
                                if !((_e330.member_3 == 4294967295u)) {
                                    phi_612_ = array<u32, 2>(_e319.member_3, _e319.member_3);
                                } else {
                                    phi_612_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e378 = phi_612_;
                                phi_614_ = array<array<u32, 2>, 4>(_e338, _e370, _e378, array<u32, 2>(4294967295u, 4294967295u));
                            }
                            let _e381 = phi_614_;
                            phi_615_ = _e381;
                            phi_616_ = false;
                        } else {
                            phi_615_ = array<array<u32, 2>, 4>();
                            phi_616_ = true;
                        }
                        let _e383 = phi_615_;
                        let _e385 = phi_616_;
                        phi_617_ = _e383;
                        phi_618_ = _e385;
                    } else {
                        phi_617_ = array<array<u32, 2>, 4>();
                        phi_618_ = true;
                    }
                    let _e387 = phi_617_;
                    let _e389 = phi_618_;
                    if _e389 {
                        if (_e319.member_3 == 4294967295u) {
                            phi_630_ = false;
                        } else {
                            phi_630_ = !((_e321.member_3 == 4294967295u));
                        }
                        let _e396 = phi_630_;
                        if _e396 {
                            if (_e313 == 1u) {
                                phi_638_ = false;
                            } else {
                                phi_638_ = true;
                            }
                            let _e399 = phi_638_;
                            phi_639_ = _e399;
                        } else {
                            phi_639_ = true;
                        }
                        let _e401 = phi_639_;
                        if _e401 {
                            if (_e319.member_3 == 4294967295u) {
                                phi_651_ = false;
                            } else {
                                phi_651_ = !((_e321.member_3 == 4294967295u));
                            }
                            let _e408 = phi_651_;
                            if _e408 {
                                phi_656_ = (_e313 == 1u);
                            } else {
                                phi_656_ = false;
                            }
                            let _e411 = phi_656_;
                            if _e411 {
                                phi_699_ = bool();
                                phi_700_ = true;
                            } else {
                                let _e413 = (_e319.member_3 == 4294967295u);
                                if _e413 {
                                    phi_698_ = bool();
                                } else {
                                    if _e408 {
                                        phi_697_ = ((((_e321.member_2[0] - _e321.member[0]) * (_e321.member_2[1] - _e321.member[1])) * (_e321.member_2[2] - _e321.member[2])) > (((_e319.member_2[0] - _e319.member[0]) * (_e319.member_2[1] - _e319.member[1])) * (_e319.member_2[2] - _e319.member[2])));
                                    } else {
                                        phi_697_ = false;
                                    }
                                    let _e442 = phi_697_;
                                    phi_698_ = _e442;
                                }
                                let _e444 = phi_698_;
                                phi_699_ = _e444;
                                phi_700_ = _e413;
                            }
                            let _e446 = phi_699_;
                            let _e448 = phi_700_;
                            if _e448 {
                                phi_704_ = true;
                            } else {
                                phi_704_ = _e446;
                            }
                            let _e450 = phi_704_;
                            phi_706_ = !(_e450);
                        } else {
                            phi_706_ = true;
                        }
                        let _e453 = phi_706_;
                        if (_e319.member_3 == 4294967295u) {
                            phi_715_ = false;
                        } else {
                            phi_715_ = !((_e321.member_3 == 4294967295u));
                        }
                        let _e460 = phi_715_;
                        if _e460 {
                            phi_720_ = (_e313 == 1u);
                        } else {
                            phi_720_ = false;
                        }
                        let _e463 = phi_720_;
                        if _e463 {
                            phi_763_ = bool();
                            phi_764_ = true;
                        } else {
                            let _e465 = (_e319.member_3 == 4294967295u);
                            if _e465 {
                                phi_762_ = bool();
                            } else {
                                if _e460 {
                                    phi_761_ = ((((_e321.member_2[0] - _e321.member[0]) * (_e321.member_2[1] - _e321.member[1])) * (_e321.member_2[2] - _e321.member[2])) > (((_e319.member_2[0] - _e319.member[0]) * (_e319.member_2[1] - _e319.member[1])) * (_e319.member_2[2] - _e319.member[2])));
                                } else {
                                    phi_761_ = false;
                                }
                                let _e494 = phi_761_;
                                phi_762_ = _e494;
                            }
                            let _e496 = phi_762_;
                            phi_763_ = _e496;
                            phi_764_ = _e465;
                        }
                        let _e498 = phi_763_;
                        let _e500 = phi_764_;
                        if _e500 {
                            phi_768_ = true;
                        } else {
                            phi_768_ = _e498;
                        }
                        let _e502 = phi_768_;
                        if _e453 {
                            if (_e319.member_3 == 4294967295u) {
                                phi_778_ = false;
                            } else {
                                phi_778_ = true;
                            }
                            let _e506 = phi_778_;
                            phi_779_ = _e506;
                        } else {
                            phi_779_ = true;
                        }
                        let _e508 = phi_779_;
                        if _e508 {
                            if _e502 {
                                if (_e321.member_3 == 4294967295u) {
                                    phi_791_ = false;
                                } else {
                                    phi_791_ = true;
                                }
                                let _e512 = phi_791_;
                                phi_792_ = _e512;
                            } else {
                                phi_792_ = true;
                            }
                            let _e514 = phi_792_;
                            if _e514 {
                                if _e453 {
                                    if _e502 {
                                        let _e517 = a_nodes.member[_e319.member_1];
                                        let _e522 = a_nodes.member[_e319.member_3];
                                        let _e527 = b_nodes.member[_e321.member_1];
                                        let _e532 = b_nodes.member[_e321.member_3];
                                        if ((((((_e517.member[0] <= _e527.member_2[0]) && (_e527.member[0] <= _e517.member_2[0])) && (_e517.member[1] <= _e527.member_2[1])) && (_e527.member[1] <= _e517.member_2[1])) && (_e517.member[2] <= _e527.member_2[2])) && (_e527.member[2] <= _e517.member_2[2])) {
                                            phi_887_ = array<u32, 2>(_e319.member_1, _e321.member_1);
                                        } else {
                                            phi_887_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e562 = phi_887_;
                                        if ((((((_e517.member[0] <= _e532.member_2[0]) && (_e532.member[0] <= _e517.member_2[0])) && (_e517.member[1] <= _e532.member_2[1])) && (_e532.member[1] <= _e517.member_2[1])) && (_e517.member[2] <= _e532.member_2[2])) && (_e532.member[2] <= _e517.member_2[2])) {
                                            phi_917_ = array<u32, 2>(_e319.member_1, _e321.member_3);
                                        } else {
                                            phi_917_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e590 = phi_917_;
                                        if ((((((_e522.member[0] <= _e527.member_2[0]) && (_e527.member[0] <= _e522.member_2[0])) && (_e522.member[1] <= _e527.member_2[1])) && (_e527.member[1] <= _e522.member_2[1])) && (_e522.member[2] <= _e527.member_2[2])) && (_e527.member[2] <= _e522.member_2[2])) {
                                            phi_947_ = array<u32, 2>(_e319.member_3, _e321.member_1);
                                        } else {
                                            phi_947_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e618 = phi_947_;
                                        if ((((((_e522.member[0] <= _e532.member_2[0]) && (_e532.member[0] <= _e522.member_2[0])) && (_e522.member[1] <= _e532.member_2[1])) && (_e532.member[1] <= _e522.member_2[1])) && (_e522.member[2] <= _e532.member_2[2])) && (_e532.member[2] <= _e522.member_2[2])) {
                                            phi_977_ = array<u32, 2>(_e319.member_3, _e321.member_3);
                                        } else {
                                            phi_977_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e646 = phi_977_;
                                        phi_979_ = array<array<u32, 2>, 4>(_e562, _e590, _e618, _e646);
                                        phi_980_ = false;
                                    } else {
                                        phi_979_ = array<array<u32, 2>, 4>();
                                        phi_980_ = true;
                                    }
                                    let _e649 = phi_979_;
                                    let _e651 = phi_980_;
                                    phi_981_ = _e649;
                                    phi_982_ = _e651;
                                } else {
                                    phi_981_ = array<array<u32, 2>, 4>();
                                    phi_982_ = true;
                                }
                                let _e653 = phi_981_;
                                let _e655 = phi_982_;
                                if _e655 {
                                    if _e453 {
                                        let _e727 = a_nodes.member[_e319.member_1];
                                        let _e732 = a_nodes.member[_e319.member_3];
                                        if ((((((_e727.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e727.member_2[0])) && (_e727.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e727.member_2[1])) && (_e727.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e727.member_2[2])) {
                                            phi_1048_ = array<u32, 2>(_e319.member_1, _e285[1]);
                                        } else {
                                            phi_1048_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e763 = phi_1048_;
                                        if ((((((_e732.member[0] <= _e321.member_2[0]) && (_e321.member[0] <= _e732.member_2[0])) && (_e732.member[1] <= _e321.member_2[1])) && (_e321.member[1] <= _e732.member_2[1])) && (_e732.member[2] <= _e321.member_2[2])) && (_e321.member[2] <= _e732.member_2[2])) {
                                            phi_1080_ = array<u32, 2>(_e319.member_3, _e285[1]);
                                        } else {
                                            phi_1080_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e792 = phi_1080_;
                                        phi_1175_ = array<array<u32, 2>, 4>(_e763, _e792, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    } else {
                                        let _e658 = b_nodes.member[_e321.member_1];
                                        let _e663 = b_nodes.member[_e321.member_3];
                                        if ((((((_e319.member[0] <= _e658.member_2[0]) && (_e658.member[0] <= _e319.member_2[0])) && (_e319.member[1] <= _e658.member_2[1])) && (_e658.member[1] <= _e319.member_2[1])) && (_e319.member[2] <= _e658.member_2[2])) && (_e658.member[2] <= _e319.member_2[2])) {
                                            phi_1141_ = array<u32, 2>(_e285[0], _e321.member_1);
                                        } else {
                                            phi_1141_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e694 = phi_1141_;
                                        if ((((((_e319.member[0] <= _e663.member_2[0]) && (_e663.member[0] <= _e319.member_2[0])) && (_e319.member[1] <= _e663.member_2[1])) && (_e663.member[1] <= _e319.member_2[1])) && (_e319.member[2] <= _e663.member_2[2])) && (_e663.member[2] <= _e319.member_2[2])) {
                                            phi_1173_ = array<u32, 2>(_e285[0], _e321.member_3);
                                        } else {
                                            phi_1173_ = array<u32, 2>(4294967295u, 4294967295u);
                                        }
                                        let _e723 = phi_1173_;
                                        phi_1175_ = array<array<u32, 2>, 4>(_e694, _e723, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                    }
                                    let _e795 = phi_1175_;
                                    phi_1176_ = _e795;
                                } else {
                                    phi_1176_ = _e653;
                                }
                                let _e797 = phi_1176_;
                                phi_1177_ = _e797;
                                phi_1178_ = false;
                            } else {
                                phi_1177_ = array<array<u32, 2>, 4>();
                                phi_1178_ = true;
                            }
                            let _e799 = phi_1177_;
                            let _e801 = phi_1178_;
                            phi_1179_ = _e799;
                            phi_1180_ = _e801;
                        } else {
                            phi_1179_ = array<array<u32, 2>, 4>();
                            phi_1180_ = true;
                        }
                        let _e803 = phi_1179_;
                        let _e805 = phi_1180_;
                        phi_1184_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        phi_1185_ = _e803;
                        phi_1186_ = _e805;
                    } else {
                        phi_1184_ = _e387;
                        phi_1185_ = array<array<u32, 2>, 4>();
                        phi_1186_ = true;
                    }
                    let _e807 = phi_1184_;
                    let _e809 = phi_1185_;
                    let _e811 = phi_1186_;
                    if _e811 {
                        phi_1190_ = _e807;
                    } else {
                        phi_1190_ = _e809;
                    }
                    let _e813 = phi_1190_;
                    let _e816 = params.member.member_2.member;
                    if (_e816 == 0u) {
                        phi_1200_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1200_ = array<u32, 2>(1u, 1u);
                    }
                    let _e819 = phi_1200_;
                    let _e825 = params.member.member.member_2[_e819[0]];
                    let _e829 = params.member.member.member_2[_e819[1]];
                    let _e832 = params.member.member_2.member;
                    let _e836 = params.member.member_2.member;
                    if (_e836 == 0u) {
                        phi_1232_ = array<u32, 2>(0u, 2u);
                    } else {
                        phi_1232_ = array<u32, 2>(1u, 1u);
                    }
                    let _e839 = phi_1232_;
                    let _e845 = params.member.member.member[_e839[0]];
                    let _e846 = (_e845 - 1u);
                    let _e850 = params.member.member.member[_e839[1]];
                    let _e851 = (_e850 - 1u);
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e813[0][0], _e813[0][1]), array<u32, 2>(_e813[1][0], _e813[1][1]), array<u32, 2>(_e813[2][0], _e813[2][1]), array<u32, 2>(_e813[3][0], _e813[3][1]));
                    phi_1270_ = type_12(0u, 4u);
                    loop {
                        let _e870 = phi_1270_;
                        if (_e870.member < _e870.member_1) {
                            phi_1271_ = type_12((_e870.member + 1u), _e870.member_1);
                            phi_1294_ = type_12(1u, _e870.member);
                        } else {
                            phi_1271_ = _e870;
                            phi_1294_ = type_12(0u, type_12().member_1);
                        }
                        let _e882 = phi_1271_;
                        let _e884 = phi_1294_;
                        let _e888 = (bitcast<i32>(_e884.member) != 0i);
                        if _e888 {
                            let _e890 = local_1[_e884.member_1];
                            if (_e890[0] != 4294967295u) {
                                if (_e832 == 1u) {
                                    phi_1323_ = (_e890[0] == _e890[1]);
                                } else {
                                    phi_1323_ = false;
                                }
                                let _e896 = phi_1323_;
                                if _e896 {
                                    phi_3532_ = bool();
                                    phi_3533_ = true;
                                } else {
                                    if (_e890[0] >= _e846) {
                                        if (_e890[1] >= _e851) {
                                            phi_1335_ = false;
                                        } else {
                                            phi_1335_ = true;
                                        }
                                        let _e900 = phi_1335_;
                                        phi_1336_ = _e900;
                                    } else {
                                        phi_1336_ = true;
                                    }
                                    let _e902 = phi_1336_;
                                    if _e902 {
                                        if (_e890[0] < _e846) {
                                            let _e982 = oriented.member[(_e825 + _e890[0])];
                                            phi_1483_ = type_31(array<f32, 3>(_e982.member.x, _e982.member.y, _e982.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e982.member.w, _e982.member_1.x, _e982.member_1.y), array<f32, 3>(_e982.member_1.z, _e982.member_1.w, _e982.member_2.x), array<f32, 3>(_e982.member_2.y, _e982.member_2.z, _e982.member_2.w)), array<f32, 3>(_e982.member_3.x, _e982.member_3.y, _e982.member_3.z));
                                        } else {
                                            let _e905 = a_nodes.member[_e890[0]];
                                            let _e920 = ((_e905.member[0] * 0.5f) + (_e905.member_2[0] * 0.5f));
                                            let _e921 = ((_e905.member[1] * 0.5f) + (_e905.member_2[1] * 0.5f));
                                            let _e922 = ((_e905.member[2] * 0.5f) + (_e905.member_2[2] * 0.5f));
                                            if (_e920 < _e905.member_2[0]) {
                                                phi_1409_ = _e920;
                                            } else {
                                                phi_1409_ = _e905.member_2[0];
                                            }
                                            let _e926 = phi_1409_;
                                            if (_e921 < _e905.member_2[1]) {
                                                phi_1415_ = _e921;
                                            } else {
                                                phi_1415_ = _e905.member_2[1];
                                            }
                                            let _e930 = phi_1415_;
                                            if (_e922 < _e905.member_2[2]) {
                                                phi_1421_ = _e922;
                                            } else {
                                                phi_1421_ = _e905.member_2[2];
                                            }
                                            let _e934 = phi_1421_;
                                            if (_e926 > _e905.member[0]) {
                                                phi_1427_ = _e926;
                                            } else {
                                                phi_1427_ = _e905.member[0];
                                            }
                                            let _e938 = phi_1427_;
                                            if (_e930 > _e905.member[1]) {
                                                phi_1433_ = _e930;
                                            } else {
                                                phi_1433_ = _e905.member[1];
                                            }
                                            let _e942 = phi_1433_;
                                            if (_e934 > _e905.member[2]) {
                                                phi_1439_ = _e934;
                                            } else {
                                                phi_1439_ = _e905.member[2];
                                            }
                                            let _e946 = phi_1439_;
                                            let _e949 = (_e905.member_2[0] - _e938);
                                            let _e951 = (_e905.member_2[1] - _e942);
                                            let _e953 = (_e905.member_2[2] - _e946);
                                            let _e955 = (_e938 - _e905.member[0]);
                                            let _e957 = (_e942 - _e905.member[1]);
                                            let _e959 = (_e946 - _e905.member[2]);
                                            if (_e949 > _e955) {
                                                phi_1457_ = _e949;
                                            } else {
                                                phi_1457_ = _e955;
                                            }
                                            let _e962 = phi_1457_;
                                            if (_e951 > _e957) {
                                                phi_1462_ = _e951;
                                            } else {
                                                phi_1462_ = _e957;
                                            }
                                            let _e965 = phi_1462_;
                                            if (_e953 > _e959) {
                                                phi_1467_ = _e953;
                                            } else {
                                                phi_1467_ = _e959;
                                            }
                                            let _e968 = phi_1467_;
                                            let _e970 = (1f + (0.000000059604645f * 4f));
                                            let _e974 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1483_ = type_31(array<f32, 3>(_e938, _e942, _e946), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e962 * _e970) + _e974), ((_e965 * _e970) + _e974), ((_e968 * _e970) + _e974)));
                                        }
                                        let _e1021 = phi_1483_;
                                        if (_e890[1] < _e851) {
                                            let _e1101 = oriented.member[(_e829 + _e890[1])];
                                            phi_1627_ = type_31(array<f32, 3>(_e1101.member.x, _e1101.member.y, _e1101.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1101.member.w, _e1101.member_1.x, _e1101.member_1.y), array<f32, 3>(_e1101.member_1.z, _e1101.member_1.w, _e1101.member_2.x), array<f32, 3>(_e1101.member_2.y, _e1101.member_2.z, _e1101.member_2.w)), array<f32, 3>(_e1101.member_3.x, _e1101.member_3.y, _e1101.member_3.z));
                                        } else {
                                            let _e1024 = b_nodes.member[_e890[1]];
                                            let _e1039 = ((_e1024.member[0] * 0.5f) + (_e1024.member_2[0] * 0.5f));
                                            let _e1040 = ((_e1024.member[1] * 0.5f) + (_e1024.member_2[1] * 0.5f));
                                            let _e1041 = ((_e1024.member[2] * 0.5f) + (_e1024.member_2[2] * 0.5f));
                                            if (_e1039 < _e1024.member_2[0]) {
                                                phi_1553_ = _e1039;
                                            } else {
                                                phi_1553_ = _e1024.member_2[0];
                                            }
                                            let _e1045 = phi_1553_;
                                            if (_e1040 < _e1024.member_2[1]) {
                                                phi_1559_ = _e1040;
                                            } else {
                                                phi_1559_ = _e1024.member_2[1];
                                            }
                                            let _e1049 = phi_1559_;
                                            if (_e1041 < _e1024.member_2[2]) {
                                                phi_1565_ = _e1041;
                                            } else {
                                                phi_1565_ = _e1024.member_2[2];
                                            }
                                            let _e1053 = phi_1565_;
                                            if (_e1045 > _e1024.member[0]) {
                                                phi_1571_ = _e1045;
                                            } else {
                                                phi_1571_ = _e1024.member[0];
                                            }
                                            let _e1057 = phi_1571_;
                                            if (_e1049 > _e1024.member[1]) {
                                                phi_1577_ = _e1049;
                                            } else {
                                                phi_1577_ = _e1024.member[1];
                                            }
                                            let _e1061 = phi_1577_;
                                            if (_e1053 > _e1024.member[2]) {
                                                phi_1583_ = _e1053;
                                            } else {
                                                phi_1583_ = _e1024.member[2];
                                            }
                                            let _e1065 = phi_1583_;
                                            let _e1068 = (_e1024.member_2[0] - _e1057);
                                            let _e1070 = (_e1024.member_2[1] - _e1061);
                                            let _e1072 = (_e1024.member_2[2] - _e1065);
                                            let _e1074 = (_e1057 - _e1024.member[0]);
                                            let _e1076 = (_e1061 - _e1024.member[1]);
                                            let _e1078 = (_e1065 - _e1024.member[2]);
                                            if (_e1068 > _e1074) {
                                                phi_1601_ = _e1068;
                                            } else {
                                                phi_1601_ = _e1074;
                                            }
                                            let _e1081 = phi_1601_;
                                            if (_e1070 > _e1076) {
                                                phi_1606_ = _e1070;
                                            } else {
                                                phi_1606_ = _e1076;
                                            }
                                            let _e1084 = phi_1606_;
                                            if (_e1072 > _e1078) {
                                                phi_1611_ = _e1072;
                                            } else {
                                                phi_1611_ = _e1078;
                                            }
                                            let _e1087 = phi_1611_;
                                            let _e1089 = (1f + (0.000000059604645f * 4f));
                                            let _e1093 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1627_ = type_31(array<f32, 3>(_e1057, _e1061, _e1065), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e1081 * _e1089) + _e1093), ((_e1084 * _e1089) + _e1093), ((_e1087 * _e1089) + _e1093)));
                                        }
                                        let _e1140 = phi_1627_;
                                        let _e1145 = (_e1140.member[0] - _e1021.member[0]);
                                        let _e1148 = (_e1140.member[1] - _e1021.member[1]);
                                        let _e1151 = (_e1140.member[2] - _e1021.member[2]);
                                        if (_e1145 < 0f) {
                                            phi_1817_ = -(_e1145);
                                        } else {
                                            phi_1817_ = _e1145;
                                        }
                                        let _e1340 = phi_1817_;
                                        if (_e1148 < 0f) {
                                            phi_1823_ = -(_e1148);
                                        } else {
                                            phi_1823_ = _e1148;
                                        }
                                        let _e1344 = phi_1823_;
                                        if (_e1151 < 0f) {
                                            phi_1830_ = -(_e1151);
                                        } else {
                                            phi_1830_ = _e1151;
                                        }
                                        let _e1349 = phi_1830_;
                                        if (_e1021.member_2[0] < 0f) {
                                            phi_1839_ = -(_e1021.member_2[0]);
                                        } else {
                                            phi_1839_ = _e1021.member_2[0];
                                        }
                                        let _e1356 = phi_1839_;
                                        if (_e1021.member_2[1] < 0f) {
                                            phi_1846_ = -(_e1021.member_2[1]);
                                        } else {
                                            phi_1846_ = _e1021.member_2[1];
                                        }
                                        let _e1361 = phi_1846_;
                                        if (_e1021.member_2[2] < 0f) {
                                            phi_1854_ = -(_e1021.member_2[2]);
                                        } else {
                                            phi_1854_ = _e1021.member_2[2];
                                        }
                                        let _e1367 = phi_1854_;
                                        if (_e1140.member_2[0] < 0f) {
                                            phi_1863_ = -(_e1140.member_2[0]);
                                        } else {
                                            phi_1863_ = _e1140.member_2[0];
                                        }
                                        let _e1374 = phi_1863_;
                                        if (_e1140.member_2[1] < 0f) {
                                            phi_1870_ = -(_e1140.member_2[1]);
                                        } else {
                                            phi_1870_ = _e1140.member_2[1];
                                        }
                                        let _e1379 = phi_1870_;
                                        if (_e1140.member_2[2] < 0f) {
                                            phi_1878_ = -(_e1140.member_2[2]);
                                        } else {
                                            phi_1878_ = _e1140.member_2[2];
                                        }
                                        let _e1385 = phi_1878_;
                                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e1140.member_1[0][0] * _e1021.member_1[0][0]) + (_e1140.member_1[0][1] * _e1021.member_1[0][1])) + (_e1140.member_1[0][2] * _e1021.member_1[0][2])), (((_e1140.member_1[1][0] * _e1021.member_1[0][0]) + (_e1140.member_1[1][1] * _e1021.member_1[0][1])) + (_e1140.member_1[1][2] * _e1021.member_1[0][2])), (((_e1140.member_1[2][0] * _e1021.member_1[0][0]) + (_e1140.member_1[2][1] * _e1021.member_1[0][1])) + (_e1140.member_1[2][2] * _e1021.member_1[0][2]))), array<f32, 3>((((_e1140.member_1[0][0] * _e1021.member_1[1][0]) + (_e1140.member_1[0][1] * _e1021.member_1[1][1])) + (_e1140.member_1[0][2] * _e1021.member_1[1][2])), (((_e1140.member_1[1][0] * _e1021.member_1[1][0]) + (_e1140.member_1[1][1] * _e1021.member_1[1][1])) + (_e1140.member_1[1][2] * _e1021.member_1[1][2])), (((_e1140.member_1[2][0] * _e1021.member_1[1][0]) + (_e1140.member_1[2][1] * _e1021.member_1[1][1])) + (_e1140.member_1[2][2] * _e1021.member_1[1][2]))), array<f32, 3>((((_e1140.member_1[0][0] * _e1021.member_1[2][0]) + (_e1140.member_1[0][1] * _e1021.member_1[2][1])) + (_e1140.member_1[0][2] * _e1021.member_1[2][2])), (((_e1140.member_1[1][0] * _e1021.member_1[2][0]) + (_e1140.member_1[1][1] * _e1021.member_1[2][1])) + (_e1140.member_1[1][2] * _e1021.member_1[2][2])), (((_e1140.member_1[2][0] * _e1021.member_1[2][0]) + (_e1140.member_1[2][1] * _e1021.member_1[2][1])) + (_e1140.member_1[2][2] * _e1021.member_1[2][2])))), array<f32, 3>((((_e1021.member_1[0][0] * _e1145) + (_e1021.member_1[0][1] * _e1148)) + (_e1021.member_1[0][2] * _e1151)), (((_e1021.member_1[1][0] * _e1145) + (_e1021.member_1[1][1] * _e1148)) + (_e1021.member_1[1][2] * _e1151)), (((_e1021.member_1[2][0] * _e1145) + (_e1021.member_1[2][1] * _e1148)) + (_e1021.member_1[2][2] * _e1151))), array<f32, 3>((((_e1140.member_1[0][0] * _e1145) + (_e1140.member_1[0][1] * _e1148)) + (_e1140.member_1[0][2] * _e1151)), (((_e1140.member_1[1][0] * _e1145) + (_e1140.member_1[1][1] * _e1148)) + (_e1140.member_1[1][2] * _e1151)), (((_e1140.member_1[2][0] * _e1145) + (_e1140.member_1[2][1] * _e1148)) + (_e1140.member_1[2][2] * _e1151))), array<f32, 3>(_e1021.member_2[0], _e1021.member_2[1], _e1021.member_2[2]), array<f32, 3>(_e1140.member_2[0], _e1140.member_2[1], _e1140.member_2[2]), ((((((_e1340 + _e1344) + _e1349) + (((_e1356 + _e1361) + _e1367) + ((_e1374 + _e1379) + _e1385))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1412 = local.member[0u][0u];
                                        let _e1416 = local.member[0u][1u];
                                        let _e1420 = local.member[0u][2u];
                                        let _e1424 = local.member[1u][0u];
                                        let _e1428 = local.member[1u][1u];
                                        let _e1432 = local.member[1u][2u];
                                        let _e1436 = local.member[2u][0u];
                                        let _e1440 = local.member[2u][1u];
                                        let _e1444 = local.member[2u][2u];
                                        let _e1446 = local.member_3;
                                        let _e1451 = local.member_4;
                                        let _e1457 = local.member_1[0u];
                                        if (_e1457 < 0f) {
                                            phi_1971_ = -(_e1457);
                                        } else {
                                            phi_1971_ = _e1457;
                                        }
                                        let _e1461 = phi_1971_;
                                        if (_e1412 < 0f) {
                                            phi_1978_ = -(_e1412);
                                        } else {
                                            phi_1978_ = _e1412;
                                        }
                                        let _e1465 = phi_1978_;
                                        if (_e1416 < 0f) {
                                            phi_1984_ = -(_e1416);
                                        } else {
                                            phi_1984_ = _e1416;
                                        }
                                        let _e1469 = phi_1984_;
                                        if (_e1420 < 0f) {
                                            phi_1990_ = -(_e1420);
                                        } else {
                                            phi_1990_ = _e1420;
                                        }
                                        let _e1473 = phi_1990_;
                                        let _e1480 = (_e1461 - (_e1446[0] + (((_e1465 * _e1451[0]) + (_e1469 * _e1451[1])) + (_e1473 * _e1451[2]))));
                                        let _e1483 = local.member_1[1u];
                                        if (_e1483 < 0f) {
                                            phi_2009_ = -(_e1483);
                                        } else {
                                            phi_2009_ = _e1483;
                                        }
                                        let _e1487 = phi_2009_;
                                        if (_e1424 < 0f) {
                                            phi_2016_ = -(_e1424);
                                        } else {
                                            phi_2016_ = _e1424;
                                        }
                                        let _e1491 = phi_2016_;
                                        if (_e1428 < 0f) {
                                            phi_2022_ = -(_e1428);
                                        } else {
                                            phi_2022_ = _e1428;
                                        }
                                        let _e1495 = phi_2022_;
                                        if (_e1432 < 0f) {
                                            phi_2028_ = -(_e1432);
                                        } else {
                                            phi_2028_ = _e1432;
                                        }
                                        let _e1499 = phi_2028_;
                                        let _e1506 = (_e1487 - (_e1446[1] + (((_e1491 * _e1451[0]) + (_e1495 * _e1451[1])) + (_e1499 * _e1451[2]))));
                                        let _e1509 = local.member_1[2u];
                                        if (_e1509 < 0f) {
                                            phi_2047_ = -(_e1509);
                                        } else {
                                            phi_2047_ = _e1509;
                                        }
                                        let _e1513 = phi_2047_;
                                        if (_e1436 < 0f) {
                                            phi_2054_ = -(_e1436);
                                        } else {
                                            phi_2054_ = _e1436;
                                        }
                                        let _e1517 = phi_2054_;
                                        if (_e1440 < 0f) {
                                            phi_2060_ = -(_e1440);
                                        } else {
                                            phi_2060_ = _e1440;
                                        }
                                        let _e1521 = phi_2060_;
                                        if (_e1444 < 0f) {
                                            phi_2066_ = -(_e1444);
                                        } else {
                                            phi_2066_ = _e1444;
                                        }
                                        let _e1525 = phi_2066_;
                                        let _e1532 = (_e1513 - (_e1446[2] + (((_e1517 * _e1451[0]) + (_e1521 * _e1451[1])) + (_e1525 * _e1451[2]))));
                                        let _e1535 = local.member_2[0u];
                                        if (_e1535 < 0f) {
                                            phi_2085_ = -(_e1535);
                                        } else {
                                            phi_2085_ = _e1535;
                                        }
                                        let _e1539 = phi_2085_;
                                        if (_e1412 < 0f) {
                                            phi_2092_ = -(_e1412);
                                        } else {
                                            phi_2092_ = _e1412;
                                        }
                                        let _e1543 = phi_2092_;
                                        if (_e1424 < 0f) {
                                            phi_2098_ = -(_e1424);
                                        } else {
                                            phi_2098_ = _e1424;
                                        }
                                        let _e1547 = phi_2098_;
                                        if (_e1436 < 0f) {
                                            phi_2104_ = -(_e1436);
                                        } else {
                                            phi_2104_ = _e1436;
                                        }
                                        let _e1551 = phi_2104_;
                                        let _e1558 = (_e1539 - (_e1451[0] + (((_e1543 * _e1446[0]) + (_e1547 * _e1446[1])) + (_e1551 * _e1446[2]))));
                                        let _e1561 = local.member_2[1u];
                                        if (_e1561 < 0f) {
                                            phi_2123_ = -(_e1561);
                                        } else {
                                            phi_2123_ = _e1561;
                                        }
                                        let _e1565 = phi_2123_;
                                        if (_e1416 < 0f) {
                                            phi_2130_ = -(_e1416);
                                        } else {
                                            phi_2130_ = _e1416;
                                        }
                                        let _e1569 = phi_2130_;
                                        if (_e1428 < 0f) {
                                            phi_2136_ = -(_e1428);
                                        } else {
                                            phi_2136_ = _e1428;
                                        }
                                        let _e1573 = phi_2136_;
                                        if (_e1440 < 0f) {
                                            phi_2142_ = -(_e1440);
                                        } else {
                                            phi_2142_ = _e1440;
                                        }
                                        let _e1577 = phi_2142_;
                                        let _e1584 = (_e1565 - (_e1451[1] + (((_e1569 * _e1446[0]) + (_e1573 * _e1446[1])) + (_e1577 * _e1446[2]))));
                                        let _e1587 = local.member_2[2u];
                                        if (_e1587 < 0f) {
                                            phi_2161_ = -(_e1587);
                                        } else {
                                            phi_2161_ = _e1587;
                                        }
                                        let _e1591 = phi_2161_;
                                        if (_e1420 < 0f) {
                                            phi_2168_ = -(_e1420);
                                        } else {
                                            phi_2168_ = _e1420;
                                        }
                                        let _e1595 = phi_2168_;
                                        if (_e1432 < 0f) {
                                            phi_2174_ = -(_e1432);
                                        } else {
                                            phi_2174_ = _e1432;
                                        }
                                        let _e1599 = phi_2174_;
                                        if (_e1444 < 0f) {
                                            phi_2180_ = -(_e1444);
                                        } else {
                                            phi_2180_ = _e1444;
                                        }
                                        let _e1603 = phi_2180_;
                                        let _e1610 = (_e1591 - (_e1451[2] + (((_e1595 * _e1446[0]) + (_e1599 * _e1446[1])) + (_e1603 * _e1446[2]))));
                                        if (_e1480 > _e1506) {
                                            phi_2195_ = _e1480;
                                        } else {
                                            phi_2195_ = _e1506;
                                        }
                                        let _e1613 = phi_2195_;
                                        if (_e1613 > _e1532) {
                                            phi_2200_ = _e1613;
                                        } else {
                                            phi_2200_ = _e1532;
                                        }
                                        let _e1616 = phi_2200_;
                                        if (_e1558 > _e1584) {
                                            phi_2205_ = _e1558;
                                        } else {
                                            phi_2205_ = _e1584;
                                        }
                                        let _e1619 = phi_2205_;
                                        if (_e1619 > _e1610) {
                                            phi_2210_ = _e1619;
                                        } else {
                                            phi_2210_ = _e1610;
                                        }
                                        let _e1622 = phi_2210_;
                                        if (_e1616 > _e1622) {
                                            phi_2215_ = _e1616;
                                        } else {
                                            phi_2215_ = _e1622;
                                        }
                                        let _e1625 = phi_2215_;
                                        let _e1627 = local.member_5;
                                        if (_e1625 > _e1627) {
                                            phi_3528_ = true;
                                        } else {
                                            let _e1632 = local.member[1u][0u];
                                            let _e1635 = local.member_1[2u];
                                            let _e1640 = local.member[2u][0u];
                                            let _e1643 = local.member_1[1u];
                                            let _e1645 = ((_e1632 * _e1635) - (_e1640 * _e1643));
                                            let _e1649 = local.member[2u][0u];
                                            if (_e1649 < 0f) {
                                                phi_2274_ = -(_e1649);
                                            } else {
                                                phi_2274_ = _e1649;
                                            }
                                            let _e1653 = phi_2274_;
                                            let _e1656 = local.member_3[1u];
                                            let _e1661 = local.member[1u][0u];
                                            if (_e1661 < 0f) {
                                                phi_2297_ = -(_e1661);
                                            } else {
                                                phi_2297_ = _e1661;
                                            }
                                            let _e1665 = phi_2297_;
                                            let _e1668 = local.member_3[2u];
                                            let _e1674 = local.member[0u][2u];
                                            if (_e1674 < 0f) {
                                                phi_2320_ = -(_e1674);
                                            } else {
                                                phi_2320_ = _e1674;
                                            }
                                            let _e1678 = phi_2320_;
                                            let _e1681 = local.member_4[1u];
                                            let _e1686 = local.member[0u][1u];
                                            if (_e1686 < 0f) {
                                                phi_2342_ = -(_e1686);
                                            } else {
                                                phi_2342_ = _e1686;
                                            }
                                            let _e1690 = phi_2342_;
                                            let _e1693 = local.member_4[2u];
                                            if (_e1645 < 0f) {
                                                phi_2358_ = -(_e1645);
                                            } else {
                                                phi_2358_ = _e1645;
                                            }
                                            let _e1699 = phi_2358_;
                                            let _e1701 = (_e1699 - (((_e1653 * _e1656) + (_e1665 * _e1668)) + ((_e1678 * _e1681) + (_e1690 * _e1693))));
                                            let _e1705 = local.member[1u][1u];
                                            let _e1708 = local.member_1[2u];
                                            let _e1713 = local.member[2u][1u];
                                            let _e1716 = local.member_1[1u];
                                            let _e1718 = ((_e1705 * _e1708) - (_e1713 * _e1716));
                                            let _e1722 = local.member[2u][1u];
                                            if (_e1722 < 0f) {
                                                phi_2413_ = -(_e1722);
                                            } else {
                                                phi_2413_ = _e1722;
                                            }
                                            let _e1726 = phi_2413_;
                                            let _e1729 = local.member_3[1u];
                                            let _e1734 = local.member[1u][1u];
                                            if (_e1734 < 0f) {
                                                phi_2436_ = -(_e1734);
                                            } else {
                                                phi_2436_ = _e1734;
                                            }
                                            let _e1738 = phi_2436_;
                                            let _e1741 = local.member_3[2u];
                                            let _e1747 = local.member[0u][0u];
                                            if (_e1747 < 0f) {
                                                phi_2459_ = -(_e1747);
                                            } else {
                                                phi_2459_ = _e1747;
                                            }
                                            let _e1751 = phi_2459_;
                                            let _e1754 = local.member_4[2u];
                                            let _e1759 = local.member[0u][2u];
                                            if (_e1759 < 0f) {
                                                phi_2481_ = -(_e1759);
                                            } else {
                                                phi_2481_ = _e1759;
                                            }
                                            let _e1763 = phi_2481_;
                                            let _e1766 = local.member_4[0u];
                                            if (_e1718 < 0f) {
                                                phi_2497_ = -(_e1718);
                                            } else {
                                                phi_2497_ = _e1718;
                                            }
                                            let _e1772 = phi_2497_;
                                            let _e1774 = (_e1772 - (((_e1726 * _e1729) + (_e1738 * _e1741)) + ((_e1751 * _e1754) + (_e1763 * _e1766))));
                                            let _e1778 = local.member[1u][2u];
                                            let _e1781 = local.member_1[2u];
                                            let _e1786 = local.member[2u][2u];
                                            let _e1789 = local.member_1[1u];
                                            let _e1791 = ((_e1778 * _e1781) - (_e1786 * _e1789));
                                            let _e1795 = local.member[2u][2u];
                                            if (_e1795 < 0f) {
                                                phi_2552_ = -(_e1795);
                                            } else {
                                                phi_2552_ = _e1795;
                                            }
                                            let _e1799 = phi_2552_;
                                            let _e1802 = local.member_3[1u];
                                            let _e1807 = local.member[1u][2u];
                                            if (_e1807 < 0f) {
                                                phi_2575_ = -(_e1807);
                                            } else {
                                                phi_2575_ = _e1807;
                                            }
                                            let _e1811 = phi_2575_;
                                            let _e1814 = local.member_3[2u];
                                            let _e1820 = local.member[0u][1u];
                                            if (_e1820 < 0f) {
                                                phi_2598_ = -(_e1820);
                                            } else {
                                                phi_2598_ = _e1820;
                                            }
                                            let _e1824 = phi_2598_;
                                            let _e1827 = local.member_4[0u];
                                            let _e1832 = local.member[0u][0u];
                                            if (_e1832 < 0f) {
                                                phi_2620_ = -(_e1832);
                                            } else {
                                                phi_2620_ = _e1832;
                                            }
                                            let _e1836 = phi_2620_;
                                            let _e1839 = local.member_4[1u];
                                            if (_e1791 < 0f) {
                                                phi_2636_ = -(_e1791);
                                            } else {
                                                phi_2636_ = _e1791;
                                            }
                                            let _e1845 = phi_2636_;
                                            let _e1847 = (_e1845 - (((_e1799 * _e1802) + (_e1811 * _e1814)) + ((_e1824 * _e1827) + (_e1836 * _e1839))));
                                            let _e1851 = local.member[2u][0u];
                                            let _e1854 = local.member_1[0u];
                                            let _e1859 = local.member[0u][0u];
                                            let _e1862 = local.member_1[2u];
                                            let _e1864 = ((_e1851 * _e1854) - (_e1859 * _e1862));
                                            let _e1868 = local.member[0u][0u];
                                            if (_e1868 < 0f) {
                                                phi_2691_ = -(_e1868);
                                            } else {
                                                phi_2691_ = _e1868;
                                            }
                                            let _e1872 = phi_2691_;
                                            let _e1875 = local.member_3[2u];
                                            let _e1880 = local.member[2u][0u];
                                            if (_e1880 < 0f) {
                                                phi_2714_ = -(_e1880);
                                            } else {
                                                phi_2714_ = _e1880;
                                            }
                                            let _e1884 = phi_2714_;
                                            let _e1887 = local.member_3[0u];
                                            let _e1893 = local.member[1u][2u];
                                            if (_e1893 < 0f) {
                                                phi_2738_ = -(_e1893);
                                            } else {
                                                phi_2738_ = _e1893;
                                            }
                                            let _e1897 = phi_2738_;
                                            let _e1900 = local.member_4[1u];
                                            let _e1905 = local.member[1u][1u];
                                            if (_e1905 < 0f) {
                                                phi_2761_ = -(_e1905);
                                            } else {
                                                phi_2761_ = _e1905;
                                            }
                                            let _e1909 = phi_2761_;
                                            let _e1912 = local.member_4[2u];
                                            if (_e1864 < 0f) {
                                                phi_2777_ = -(_e1864);
                                            } else {
                                                phi_2777_ = _e1864;
                                            }
                                            let _e1918 = phi_2777_;
                                            let _e1920 = (_e1918 - (((_e1872 * _e1875) + (_e1884 * _e1887)) + ((_e1897 * _e1900) + (_e1909 * _e1912))));
                                            let _e1924 = local.member[2u][1u];
                                            let _e1927 = local.member_1[0u];
                                            let _e1932 = local.member[0u][1u];
                                            let _e1935 = local.member_1[2u];
                                            let _e1937 = ((_e1924 * _e1927) - (_e1932 * _e1935));
                                            let _e1941 = local.member[0u][1u];
                                            if (_e1941 < 0f) {
                                                phi_2832_ = -(_e1941);
                                            } else {
                                                phi_2832_ = _e1941;
                                            }
                                            let _e1945 = phi_2832_;
                                            let _e1948 = local.member_3[2u];
                                            let _e1953 = local.member[2u][1u];
                                            if (_e1953 < 0f) {
                                                phi_2855_ = -(_e1953);
                                            } else {
                                                phi_2855_ = _e1953;
                                            }
                                            let _e1957 = phi_2855_;
                                            let _e1960 = local.member_3[0u];
                                            let _e1966 = local.member[1u][0u];
                                            if (_e1966 < 0f) {
                                                phi_2879_ = -(_e1966);
                                            } else {
                                                phi_2879_ = _e1966;
                                            }
                                            let _e1970 = phi_2879_;
                                            let _e1973 = local.member_4[2u];
                                            let _e1978 = local.member[1u][2u];
                                            if (_e1978 < 0f) {
                                                phi_2902_ = -(_e1978);
                                            } else {
                                                phi_2902_ = _e1978;
                                            }
                                            let _e1982 = phi_2902_;
                                            let _e1985 = local.member_4[0u];
                                            if (_e1937 < 0f) {
                                                phi_2918_ = -(_e1937);
                                            } else {
                                                phi_2918_ = _e1937;
                                            }
                                            let _e1991 = phi_2918_;
                                            let _e1993 = (_e1991 - (((_e1945 * _e1948) + (_e1957 * _e1960)) + ((_e1970 * _e1973) + (_e1982 * _e1985))));
                                            let _e1997 = local.member[2u][2u];
                                            let _e2000 = local.member_1[0u];
                                            let _e2005 = local.member[0u][2u];
                                            let _e2008 = local.member_1[2u];
                                            let _e2010 = ((_e1997 * _e2000) - (_e2005 * _e2008));
                                            let _e2014 = local.member[0u][2u];
                                            if (_e2014 < 0f) {
                                                phi_2973_ = -(_e2014);
                                            } else {
                                                phi_2973_ = _e2014;
                                            }
                                            let _e2018 = phi_2973_;
                                            let _e2021 = local.member_3[2u];
                                            let _e2026 = local.member[2u][2u];
                                            if (_e2026 < 0f) {
                                                phi_2996_ = -(_e2026);
                                            } else {
                                                phi_2996_ = _e2026;
                                            }
                                            let _e2030 = phi_2996_;
                                            let _e2033 = local.member_3[0u];
                                            let _e2039 = local.member[1u][1u];
                                            if (_e2039 < 0f) {
                                                phi_3020_ = -(_e2039);
                                            } else {
                                                phi_3020_ = _e2039;
                                            }
                                            let _e2043 = phi_3020_;
                                            let _e2046 = local.member_4[0u];
                                            let _e2051 = local.member[1u][0u];
                                            if (_e2051 < 0f) {
                                                phi_3043_ = -(_e2051);
                                            } else {
                                                phi_3043_ = _e2051;
                                            }
                                            let _e2055 = phi_3043_;
                                            let _e2058 = local.member_4[1u];
                                            if (_e2010 < 0f) {
                                                phi_3059_ = -(_e2010);
                                            } else {
                                                phi_3059_ = _e2010;
                                            }
                                            let _e2064 = phi_3059_;
                                            let _e2066 = (_e2064 - (((_e2018 * _e2021) + (_e2030 * _e2033)) + ((_e2043 * _e2046) + (_e2055 * _e2058))));
                                            let _e2070 = local.member[0u][0u];
                                            let _e2073 = local.member_1[1u];
                                            let _e2078 = local.member[1u][0u];
                                            let _e2081 = local.member_1[0u];
                                            let _e2083 = ((_e2070 * _e2073) - (_e2078 * _e2081));
                                            let _e2087 = local.member[1u][0u];
                                            if (_e2087 < 0f) {
                                                phi_3114_ = -(_e2087);
                                            } else {
                                                phi_3114_ = _e2087;
                                            }
                                            let _e2091 = phi_3114_;
                                            let _e2094 = local.member_3[0u];
                                            let _e2099 = local.member[0u][0u];
                                            if (_e2099 < 0f) {
                                                phi_3137_ = -(_e2099);
                                            } else {
                                                phi_3137_ = _e2099;
                                            }
                                            let _e2103 = phi_3137_;
                                            let _e2106 = local.member_3[1u];
                                            let _e2112 = local.member[2u][2u];
                                            if (_e2112 < 0f) {
                                                phi_3161_ = -(_e2112);
                                            } else {
                                                phi_3161_ = _e2112;
                                            }
                                            let _e2116 = phi_3161_;
                                            let _e2119 = local.member_4[1u];
                                            let _e2124 = local.member[2u][1u];
                                            if (_e2124 < 0f) {
                                                phi_3184_ = -(_e2124);
                                            } else {
                                                phi_3184_ = _e2124;
                                            }
                                            let _e2128 = phi_3184_;
                                            let _e2131 = local.member_4[2u];
                                            if (_e2083 < 0f) {
                                                phi_3200_ = -(_e2083);
                                            } else {
                                                phi_3200_ = _e2083;
                                            }
                                            let _e2137 = phi_3200_;
                                            let _e2139 = (_e2137 - (((_e2091 * _e2094) + (_e2103 * _e2106)) + ((_e2116 * _e2119) + (_e2128 * _e2131))));
                                            let _e2143 = local.member[0u][1u];
                                            let _e2146 = local.member_1[1u];
                                            let _e2151 = local.member[1u][1u];
                                            let _e2154 = local.member_1[0u];
                                            let _e2156 = ((_e2143 * _e2146) - (_e2151 * _e2154));
                                            let _e2160 = local.member[1u][1u];
                                            if (_e2160 < 0f) {
                                                phi_3255_ = -(_e2160);
                                            } else {
                                                phi_3255_ = _e2160;
                                            }
                                            let _e2164 = phi_3255_;
                                            let _e2167 = local.member_3[0u];
                                            let _e2172 = local.member[0u][1u];
                                            if (_e2172 < 0f) {
                                                phi_3278_ = -(_e2172);
                                            } else {
                                                phi_3278_ = _e2172;
                                            }
                                            let _e2176 = phi_3278_;
                                            let _e2179 = local.member_3[1u];
                                            let _e2185 = local.member[2u][0u];
                                            if (_e2185 < 0f) {
                                                phi_3302_ = -(_e2185);
                                            } else {
                                                phi_3302_ = _e2185;
                                            }
                                            let _e2189 = phi_3302_;
                                            let _e2192 = local.member_4[2u];
                                            let _e2197 = local.member[2u][2u];
                                            if (_e2197 < 0f) {
                                                phi_3325_ = -(_e2197);
                                            } else {
                                                phi_3325_ = _e2197;
                                            }
                                            let _e2201 = phi_3325_;
                                            let _e2204 = local.member_4[0u];
                                            if (_e2156 < 0f) {
                                                phi_3341_ = -(_e2156);
                                            } else {
                                                phi_3341_ = _e2156;
                                            }
                                            let _e2210 = phi_3341_;
                                            let _e2212 = (_e2210 - (((_e2164 * _e2167) + (_e2176 * _e2179)) + ((_e2189 * _e2192) + (_e2201 * _e2204))));
                                            let _e2216 = local.member[0u][2u];
                                            let _e2219 = local.member_1[1u];
                                            let _e2224 = local.member[1u][2u];
                                            let _e2227 = local.member_1[0u];
                                            let _e2229 = ((_e2216 * _e2219) - (_e2224 * _e2227));
                                            let _e2233 = local.member[1u][2u];
                                            if (_e2233 < 0f) {
                                                phi_3396_ = -(_e2233);
                                            } else {
                                                phi_3396_ = _e2233;
                                            }
                                            let _e2237 = phi_3396_;
                                            let _e2240 = local.member_3[0u];
                                            let _e2245 = local.member[0u][2u];
                                            if (_e2245 < 0f) {
                                                phi_3419_ = -(_e2245);
                                            } else {
                                                phi_3419_ = _e2245;
                                            }
                                            let _e2249 = phi_3419_;
                                            let _e2252 = local.member_3[1u];
                                            let _e2258 = local.member[2u][1u];
                                            if (_e2258 < 0f) {
                                                phi_3443_ = -(_e2258);
                                            } else {
                                                phi_3443_ = _e2258;
                                            }
                                            let _e2262 = phi_3443_;
                                            let _e2265 = local.member_4[0u];
                                            let _e2270 = local.member[2u][0u];
                                            if (_e2270 < 0f) {
                                                phi_3466_ = -(_e2270);
                                            } else {
                                                phi_3466_ = _e2270;
                                            }
                                            let _e2274 = phi_3466_;
                                            let _e2277 = local.member_4[1u];
                                            if (_e2229 < 0f) {
                                                phi_3482_ = -(_e2229);
                                            } else {
                                                phi_3482_ = _e2229;
                                            }
                                            let _e2283 = phi_3482_;
                                            let _e2285 = (_e2283 - (((_e2237 * _e2240) + (_e2249 * _e2252)) + ((_e2262 * _e2265) + (_e2274 * _e2277))));
                                            if (_e1701 > _e1774) {
                                                phi_3489_ = _e1701;
                                            } else {
                                                phi_3489_ = _e1774;
                                            }
                                            let _e2288 = phi_3489_;
                                            if (_e2288 > _e1847) {
                                                phi_3494_ = _e2288;
                                            } else {
                                                phi_3494_ = _e1847;
                                            }
                                            let _e2291 = phi_3494_;
                                            if (_e1920 > _e1993) {
                                                phi_3499_ = _e1920;
                                            } else {
                                                phi_3499_ = _e1993;
                                            }
                                            let _e2294 = phi_3499_;
                                            if (_e2294 > _e2066) {
                                                phi_3504_ = _e2294;
                                            } else {
                                                phi_3504_ = _e2066;
                                            }
                                            let _e2297 = phi_3504_;
                                            if (_e2291 > _e2297) {
                                                phi_3509_ = _e2291;
                                            } else {
                                                phi_3509_ = _e2297;
                                            }
                                            let _e2300 = phi_3509_;
                                            if (_e2139 > _e2212) {
                                                phi_3514_ = _e2139;
                                            } else {
                                                phi_3514_ = _e2212;
                                            }
                                            let _e2303 = phi_3514_;
                                            if (_e2303 > _e2285) {
                                                phi_3519_ = _e2303;
                                            } else {
                                                phi_3519_ = _e2285;
                                            }
                                            let _e2306 = phi_3519_;
                                            if (_e2300 > _e2306) {
                                                phi_3524_ = _e2300;
                                            } else {
                                                phi_3524_ = _e2306;
                                            }
                                            let _e2309 = phi_3524_;
                                            let _e2311 = local.member_5;
                                            phi_3528_ = (_e2309 > _e2311);
                                        }
                                        let _e2314 = phi_3528_;
                                        phi_3530_ = !(_e2314);
                                        phi_3531_ = false;
                                    } else {
                                        phi_3530_ = bool();
                                        phi_3531_ = true;
                                    }
                                    let _e2317 = phi_3530_;
                                    let _e2319 = phi_3531_;
                                    phi_3532_ = _e2317;
                                    phi_3533_ = _e2319;
                                }
                                let _e2321 = phi_3532_;
                                let _e2323 = phi_3533_;
                                if _e2323 {
                                    phi_3537_ = true;
                                } else {
                                    phi_3537_ = _e2321;
                                }
                                let _e2325 = phi_3537_;
                                if _e2325 {
                                } else {
                                    local_1[_e884.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1270_ = _e882;
                            break if !(_e888);
                        }
                    }
                    let _e2328 = local_1;
                    let _e2332 = array<u32, 2>(_e2328[0][0], _e2328[0][1]);
                    let _e2336 = array<u32, 2>(_e2328[1][0], _e2328[1][1]);
                    let _e2340 = array<u32, 2>(_e2328[2][0], _e2328[2][1]);
                    let _e2344 = array<u32, 2>(_e2328[3][0], _e2328[3][1]);
                    let _e2348 = params.member.member_2.member_4;
                    if (_e2348 > 0u) {
                        let _e2353 = a_nodes.member[_e285[0]];
                        let _e2355 = b_nodes.member[_e285[1]];
                        if _e289 {
                            if (_e285[0] == _e285[1]) {
                                if (_e2353.member_3 == 4294967295u) {
                                    phi_3649_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e2361 = a_nodes.member[_e2353.member_1];
                                    if !((_e2361.member_3 == 4294967295u)) {
                                        phi_3625_ = array<u32, 2>(_e2353.member_1, _e2353.member_1);
                                    } else {
                                        phi_3625_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e2367 = phi_3625_;
                                    let _e2373 = a_nodes.member[_e2353.member_3];
                                    if !((_e2373.member_3 == 4294967295u)) {
                                        phi_3647_ = array<u32, 2>(_e2353.member_3, _e2353.member_3);
                                    } else {
                                        phi_3647_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e2379 = phi_3647_;
                                    phi_3649_ = array<array<u32, 2>, 4>(_e2367, array<u32, 2>(_e2353.member_1, _e2353.member_3), _e2379, array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e2382 = phi_3649_;
                                phi_3650_ = _e2382;
                                phi_3651_ = false;
                            } else {
                                phi_3650_ = array<array<u32, 2>, 4>();
                                phi_3651_ = true;
                            }
                            let _e2384 = phi_3650_;
                            let _e2386 = phi_3651_;
                            phi_3652_ = _e2384;
                            phi_3653_ = _e2386;
                        } else {
                            phi_3652_ = array<array<u32, 2>, 4>();
                            phi_3653_ = true;
                        }
                        let _e2388 = phi_3652_;
                        let _e2390 = phi_3653_;
                        if _e2390 {
                            if (_e2353.member_3 == 4294967295u) {
                                phi_3665_ = false;
                            } else {
                                phi_3665_ = !((_e2355.member_3 == 4294967295u));
                            }
                            let _e2397 = phi_3665_;
                            if _e2397 {
                                if (_e313 == 1u) {
                                    phi_3673_ = false;
                                } else {
                                    phi_3673_ = true;
                                }
                                let _e2400 = phi_3673_;
                                phi_3674_ = _e2400;
                            } else {
                                phi_3674_ = true;
                            }
                            let _e2402 = phi_3674_;
                            if _e2402 {
                                if (_e2353.member_3 == 4294967295u) {
                                    phi_3686_ = false;
                                } else {
                                    phi_3686_ = !((_e2355.member_3 == 4294967295u));
                                }
                                let _e2409 = phi_3686_;
                                if _e2409 {
                                    phi_3691_ = (_e313 == 1u);
                                } else {
                                    phi_3691_ = false;
                                }
                                let _e2412 = phi_3691_;
                                if _e2412 {
                                    phi_3734_ = bool();
                                    phi_3735_ = true;
                                } else {
                                    let _e2414 = (_e2353.member_3 == 4294967295u);
                                    if _e2414 {
                                        phi_3733_ = bool();
                                    } else {
                                        if _e2409 {
                                            phi_3732_ = ((((_e2355.member_2[0] - _e2355.member[0]) * (_e2355.member_2[1] - _e2355.member[1])) * (_e2355.member_2[2] - _e2355.member[2])) > (((_e2353.member_2[0] - _e2353.member[0]) * (_e2353.member_2[1] - _e2353.member[1])) * (_e2353.member_2[2] - _e2353.member[2])));
                                        } else {
                                            phi_3732_ = false;
                                        }
                                        let _e2443 = phi_3732_;
                                        phi_3733_ = _e2443;
                                    }
                                    let _e2445 = phi_3733_;
                                    phi_3734_ = _e2445;
                                    phi_3735_ = _e2414;
                                }
                                let _e2447 = phi_3734_;
                                let _e2449 = phi_3735_;
                                if _e2449 {
                                    phi_3739_ = true;
                                } else {
                                    phi_3739_ = _e2447;
                                }
                                let _e2451 = phi_3739_;
                                phi_3741_ = !(_e2451);
                            } else {
                                phi_3741_ = true;
                            }
                            let _e2454 = phi_3741_;
                            if (_e2353.member_3 == 4294967295u) {
                                phi_3750_ = false;
                            } else {
                                phi_3750_ = !((_e2355.member_3 == 4294967295u));
                            }
                            let _e2461 = phi_3750_;
                            if _e2461 {
                                phi_3755_ = (_e313 == 1u);
                            } else {
                                phi_3755_ = false;
                            }
                            let _e2464 = phi_3755_;
                            if _e2464 {
                                phi_3798_ = bool();
                                phi_3799_ = true;
                            } else {
                                let _e2466 = (_e2353.member_3 == 4294967295u);
                                if _e2466 {
                                    phi_3797_ = bool();
                                } else {
                                    if _e2461 {
                                        phi_3796_ = ((((_e2355.member_2[0] - _e2355.member[0]) * (_e2355.member_2[1] - _e2355.member[1])) * (_e2355.member_2[2] - _e2355.member[2])) > (((_e2353.member_2[0] - _e2353.member[0]) * (_e2353.member_2[1] - _e2353.member[1])) * (_e2353.member_2[2] - _e2353.member[2])));
                                    } else {
                                        phi_3796_ = false;
                                    }
                                    let _e2495 = phi_3796_;
                                    phi_3797_ = _e2495;
                                }
                                let _e2497 = phi_3797_;
                                phi_3798_ = _e2497;
                                phi_3799_ = _e2466;
                            }
                            let _e2499 = phi_3798_;
                            let _e2501 = phi_3799_;
                            if _e2501 {
                                phi_3803_ = true;
                            } else {
                                phi_3803_ = _e2499;
                            }
                            let _e2503 = phi_3803_;
                            if _e2454 {
                                if (_e2353.member_3 == 4294967295u) {
                                    phi_3813_ = false;
                                } else {
                                    phi_3813_ = true;
                                }
                                let _e2507 = phi_3813_;
                                phi_3814_ = _e2507;
                            } else {
                                phi_3814_ = true;
                            }
                            let _e2509 = phi_3814_;
                            if _e2509 {
                                if _e2503 {
                                    if (_e2355.member_3 == 4294967295u) {
                                        phi_3826_ = false;
                                    } else {
                                        phi_3826_ = true;
                                    }
                                    let _e2513 = phi_3826_;
                                    phi_3827_ = _e2513;
                                } else {
                                    phi_3827_ = true;
                                }
                                let _e2515 = phi_3827_;
                                if _e2515 {
                                    if _e2454 {
                                        if _e2503 {
                                            phi_3850_ = array<array<u32, 2>, 4>(array<u32, 2>(_e2353.member_1, _e2355.member_1), array<u32, 2>(_e2353.member_1, _e2355.member_3), array<u32, 2>(_e2353.member_3, _e2355.member_1), array<u32, 2>(_e2353.member_3, _e2355.member_3));
                                            phi_3851_ = false;
                                        } else {
                                            phi_3850_ = array<array<u32, 2>, 4>();
                                            phi_3851_ = true;
                                        }
                                        let _e2530 = phi_3850_;
                                        let _e2532 = phi_3851_;
                                        phi_3852_ = _e2530;
                                        phi_3853_ = _e2532;
                                    } else {
                                        phi_3852_ = array<array<u32, 2>, 4>();
                                        phi_3853_ = true;
                                    }
                                    let _e2534 = phi_3852_;
                                    let _e2536 = phi_3853_;
                                    if _e2536 {
                                        if _e2454 {
                                            phi_3870_ = array<array<u32, 2>, 4>(array<u32, 2>(_e2353.member_1, _e285[1]), array<u32, 2>(_e2353.member_3, _e285[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        } else {
                                            phi_3870_ = array<array<u32, 2>, 4>(array<u32, 2>(_e285[0], _e2355.member_1), array<u32, 2>(_e285[0], _e2355.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                        }
                                        let _e2548 = phi_3870_;
                                        phi_3871_ = _e2548;
                                    } else {
                                        phi_3871_ = _e2534;
                                    }
                                    let _e2550 = phi_3871_;
                                    phi_3872_ = _e2550;
                                    phi_3873_ = false;
                                } else {
                                    phi_3872_ = array<array<u32, 2>, 4>();
                                    phi_3873_ = true;
                                }
                                let _e2552 = phi_3872_;
                                let _e2554 = phi_3873_;
                                phi_3874_ = _e2552;
                                phi_3875_ = _e2554;
                            } else {
                                phi_3874_ = array<array<u32, 2>, 4>();
                                phi_3875_ = true;
                            }
                            let _e2556 = phi_3874_;
                            let _e2558 = phi_3875_;
                            phi_3879_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                            phi_3880_ = _e2556;
                            phi_3881_ = _e2558;
                        } else {
                            phi_3879_ = _e2388;
                            phi_3880_ = array<array<u32, 2>, 4>();
                            phi_3881_ = true;
                        }
                        let _e2560 = phi_3879_;
                        let _e2562 = phi_3880_;
                        let _e2564 = phi_3881_;
                        if _e2564 {
                            phi_3885_ = _e2560;
                        } else {
                            phi_3885_ = _e2562;
                        }
                        let _e2566 = phi_3885_;
                        phi_3886_ = _e2566;
                    } else {
                        phi_3886_ = array<array<u32, 2>, 4>(_e2332, _e2336, _e2340, _e2344);
                    }
                    let _e2568 = phi_3886_;
                    if (_e2328[0][0] == 4294967295u) {
                        phi_3910_ = 0u;
                    } else {
                        if (_e2328[0][0] >= _e302) {
                            if (_e2328[0][1] >= _e307) {
                                phi_3904_ = false;
                            } else {
                                phi_3904_ = true;
                            }
                            let _e2574 = phi_3904_;
                            phi_3905_ = _e2574;
                        } else {
                            phi_3905_ = true;
                        }
                        let _e2576 = phi_3905_;
                        if _e2576 {
                            phi_3909_ = 1u;
                        } else {
                            phi_3909_ = 2u;
                        }
                        let _e2578 = phi_3909_;
                        phi_3910_ = _e2578;
                    }
                    let _e2580 = phi_3910_;
                    let _e2581 = type_24(_e2332, _e2580);
                    if (_e2580 == 0u) {
                        if (_e2568[0][0] != 4294967295u) {
                            phi_3922_ = type_24(_e2568[0], 3u);
                        } else {
                            phi_3922_ = _e2581;
                        }
                        let _e2587 = phi_3922_;
                        phi_3923_ = _e2587;
                    } else {
                        phi_3923_ = _e2581;
                    }
                    let _e2589 = phi_3923_;
                    if (_e2328[1][0] == 4294967295u) {
                        phi_3947_ = 0u;
                    } else {
                        if (_e2328[1][0] >= _e302) {
                            if (_e2328[1][1] >= _e307) {
                                phi_3941_ = false;
                            } else {
                                phi_3941_ = true;
                            }
                            let _e2595 = phi_3941_;
                            phi_3942_ = _e2595;
                        } else {
                            phi_3942_ = true;
                        }
                        let _e2597 = phi_3942_;
                        if _e2597 {
                            phi_3946_ = 1u;
                        } else {
                            phi_3946_ = 2u;
                        }
                        let _e2599 = phi_3946_;
                        phi_3947_ = _e2599;
                    }
                    let _e2601 = phi_3947_;
                    let _e2602 = type_24(_e2336, _e2601);
                    if (_e2601 == 0u) {
                        if (_e2568[1][0] != 4294967295u) {
                            phi_3959_ = type_24(_e2568[1], 3u);
                        } else {
                            phi_3959_ = _e2602;
                        }
                        let _e2608 = phi_3959_;
                        phi_3960_ = _e2608;
                    } else {
                        phi_3960_ = _e2602;
                    }
                    let _e2610 = phi_3960_;
                    if (_e2328[2][0] == 4294967295u) {
                        phi_3984_ = 0u;
                    } else {
                        if (_e2328[2][0] >= _e302) {
                            if (_e2328[2][1] >= _e307) {
                                phi_3978_ = false;
                            } else {
                                phi_3978_ = true;
                            }
                            let _e2616 = phi_3978_;
                            phi_3979_ = _e2616;
                        } else {
                            phi_3979_ = true;
                        }
                        let _e2618 = phi_3979_;
                        if _e2618 {
                            phi_3983_ = 1u;
                        } else {
                            phi_3983_ = 2u;
                        }
                        let _e2620 = phi_3983_;
                        phi_3984_ = _e2620;
                    }
                    let _e2622 = phi_3984_;
                    let _e2623 = type_24(_e2340, _e2622);
                    if (_e2622 == 0u) {
                        if (_e2568[2][0] != 4294967295u) {
                            phi_3996_ = type_24(_e2568[2], 3u);
                        } else {
                            phi_3996_ = _e2623;
                        }
                        let _e2629 = phi_3996_;
                        phi_3997_ = _e2629;
                    } else {
                        phi_3997_ = _e2623;
                    }
                    let _e2631 = phi_3997_;
                    if (_e2328[3][0] == 4294967295u) {
                        phi_4021_ = 0u;
                    } else {
                        if (_e2328[3][0] >= _e302) {
                            if (_e2328[3][1] >= _e307) {
                                phi_4015_ = false;
                            } else {
                                phi_4015_ = true;
                            }
                            let _e2637 = phi_4015_;
                            phi_4016_ = _e2637;
                        } else {
                            phi_4016_ = true;
                        }
                        let _e2639 = phi_4016_;
                        if _e2639 {
                            phi_4020_ = 1u;
                        } else {
                            phi_4020_ = 2u;
                        }
                        let _e2641 = phi_4020_;
                        phi_4021_ = _e2641;
                    }
                    let _e2643 = phi_4021_;
                    let _e2644 = type_24(_e2344, _e2643);
                    if (_e2643 == 0u) {
                        if (_e2568[3][0] != 4294967295u) {
                            phi_4033_ = type_24(_e2568[3], 3u);
                        } else {
                            phi_4033_ = _e2644;
                        }
                        let _e2650 = phi_4033_;
                        phi_4034_ = _e2650;
                    } else {
                        phi_4034_ = _e2644;
                    }
                    let _e2652 = phi_4034_;
                    if (_e285[0] == 4294967295u) {
                        phi_4056_ = 0u;
                    } else {
                        if (_e285[0] >= _e302) {
                            if (_e285[1] >= _e307) {
                                phi_4050_ = false;
                            } else {
                                phi_4050_ = true;
                            }
                            let _e2660 = phi_4050_;
                            phi_4051_ = _e2660;
                        } else {
                            phi_4051_ = true;
                        }
                        let _e2662 = phi_4051_;
                        if _e2662 {
                            phi_4055_ = 1u;
                        } else {
                            phi_4055_ = 2u;
                        }
                        let _e2664 = phi_4055_;
                        phi_4056_ = _e2664;
                    }
                    let _e2666 = phi_4056_;
                    if (_e2666 == 2u) {
                        phi_4062_ = type_24(_e285, 2u);
                    } else {
                        phi_4062_ = _e2589;
                    }
                    let _e2670 = phi_4062_;
                    phi_4063_ = _e2670;
                    phi_4064_ = _e2652;
                    phi_4065_ = _e2631;
                    phi_4066_ = _e2610;
                } else {
                    phi_4063_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4064_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4065_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_4066_ = type_24(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2672 = phi_4063_;
                let _e2674 = phi_4064_;
                let _e2676 = phi_4065_;
                let _e2678 = phi_4066_;
                if (_e2672.member_1 == 1u) {
                    let _e2689 = atomicAdd((&shared_[6u]), 1u);
                    phi_4086_ = array<u32, 2>(_e2689, 0u);
                } else {
                    if (_e2672.member_1 == 2u) {
                        let _e2684 = atomicAdd((&shared_[7u]), 1u);
                        phi_4085_ = array<u32, 2>(_e2684, 0u);
                    } else {
                        phi_4085_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2687 = phi_4085_;
                    phi_4086_ = _e2687;
                }
                let _e2692 = phi_4086_;
                if (_e2672.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2696 = atomicAdd((&shared_[8u]), 1u);
                        phi_4098_ = array<u32, 2>(_e2692[0], _e2696);
                    } else {
                        phi_4098_ = _e2692;
                    }
                    let _e2700 = phi_4098_;
                    phi_4099_ = _e2700;
                } else {
                    phi_4099_ = _e2692;
                }
                let _e2702 = phi_4099_;
                if (_e2678.member_1 == 1u) {
                    let _e2712 = atomicAdd((&shared_[6u]), 1u);
                    phi_4117_ = array<u32, 2>(_e2712, 0u);
                } else {
                    if (_e2678.member_1 == 2u) {
                        let _e2707 = atomicAdd((&shared_[7u]), 1u);
                        phi_4116_ = array<u32, 2>(_e2707, 0u);
                    } else {
                        phi_4116_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2710 = phi_4116_;
                    phi_4117_ = _e2710;
                }
                let _e2715 = phi_4117_;
                if (_e2678.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2719 = atomicAdd((&shared_[8u]), 1u);
                        phi_4129_ = array<u32, 2>(_e2715[0], _e2719);
                    } else {
                        phi_4129_ = _e2715;
                    }
                    let _e2723 = phi_4129_;
                    phi_4130_ = _e2723;
                } else {
                    phi_4130_ = _e2715;
                }
                let _e2725 = phi_4130_;
                if (_e2676.member_1 == 1u) {
                    let _e2735 = atomicAdd((&shared_[6u]), 1u);
                    phi_4148_ = array<u32, 2>(_e2735, 0u);
                } else {
                    if (_e2676.member_1 == 2u) {
                        let _e2730 = atomicAdd((&shared_[7u]), 1u);
                        phi_4147_ = array<u32, 2>(_e2730, 0u);
                    } else {
                        phi_4147_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2733 = phi_4147_;
                    phi_4148_ = _e2733;
                }
                let _e2738 = phi_4148_;
                if (_e2676.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2742 = atomicAdd((&shared_[8u]), 1u);
                        phi_4160_ = array<u32, 2>(_e2738[0], _e2742);
                    } else {
                        phi_4160_ = _e2738;
                    }
                    let _e2746 = phi_4160_;
                    phi_4161_ = _e2746;
                } else {
                    phi_4161_ = _e2738;
                }
                let _e2748 = phi_4161_;
                if (_e2674.member_1 == 1u) {
                    let _e2758 = atomicAdd((&shared_[6u]), 1u);
                    phi_4179_ = array<u32, 2>(_e2758, 0u);
                } else {
                    if (_e2674.member_1 == 2u) {
                        let _e2753 = atomicAdd((&shared_[7u]), 1u);
                        phi_4178_ = array<u32, 2>(_e2753, 0u);
                    } else {
                        phi_4178_ = array<u32, 2>(0u, 0u);
                    }
                    let _e2756 = phi_4178_;
                    phi_4179_ = _e2756;
                }
                let _e2761 = phi_4179_;
                if (_e2674.member_1 >= 2u) {
                    if (_e87.member_4 > 0u) {
                        let _e2765 = atomicAdd((&shared_[8u]), 1u);
                        phi_4191_ = array<u32, 2>(_e2761[0], _e2765);
                    } else {
                        phi_4191_ = _e2761;
                    }
                    let _e2769 = phi_4191_;
                    phi_4192_ = _e2769;
                } else {
                    phi_4192_ = _e2761;
                }
                let _e2771 = phi_4192_;
                workgroupBarrier();
                if (_e72 == 0u) {
                    let _e2774 = atomicLoad((&shared_[6u]));
                    let _e2776 = atomicLoad((&shared_[7u]));
                    let _e2778 = atomicLoad((&shared_[8u]));
                    let _e2780 = atomicLoad((&shared_[1u]));
                    let _e2782 = atomicLoad((&shared_[2u]));
                    let _e2784 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2784 + 1u));
                    let _e2788 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2788 + _e2780) + _e2782));
                    let _e2793 = atomicLoad((&shared_[0u]));
                    let _e2794 = (_e2793 - _e2780);
                    let _e2796 = (_e87.member_10 - _e2794);
                    if (_e2796 < _e2774) {
                        phi_4225_ = _e2796;
                    } else {
                        phi_4225_ = _e2774;
                    }
                    let _e2799 = phi_4225_;
                    atomicStore((&shared_[9u]), _e2794);
                    atomicStore((&shared_[10u]), _e2799);
                    atomicStore((&shared_[0u]), (_e2794 + _e2799));
                    if (_e2774 > _e2799) {
                        let _e2805 = (_e2774 - _e2799);
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e2809 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2812 = atomicAdd((&control.member[(_e90 + 1u)]), _e2805);
                        let _e2815 = atomicMax((&nodes.member[0u]), (_e2812 + _e2805));
                        if ((_e2812 + _e2805) < _e2812) {
                            let _e2819 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2812);
                    }
                    if (_e2776 > 0u) {
                        let _e2823 = atomicAdd((&pairs.member[0u]), _e2776);
                        if ((_e2823 + _e2776) < _e2823) {
                            let _e2827 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2823);
                    }
                    if (_e2778 > 0u) {
                        let _e2831 = atomicAdd((&control.member[1537u]), _e2778);
                        if ((_e2831 + _e2778) < _e2831) {
                            let _e2835 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2831);
                    }
                }
                workgroupBarrier();
                if (_e2672.member_1 == 1u) {
                    let _e2893 = atomicLoad((&shared_[10u]));
                    if (_e2702[0] < _e2893) {
                        let _e2913 = atomicLoad((&shared_[9u]));
                        let _e2916 = (2u * (_e2913 + _e2702[0]));
                        stack[_e2916] = _e2672.member[0];
                        stack[(_e2916 + 1u)] = _e2672.member[1];
                    } else {
                        let _e2897 = atomicLoad((&shared_[11u]));
                        let _e2900 = ((_e2897 + _e2702[0]) - _e2893);
                        if (_e2900 < _e87.member_3) {
                            let _e2903 = (_e101 + _e2900);
                            if (_e2903 < 4294967295u) {
                                let _e2907 = (2u * _e2903);
                                atomicStore((&nodes.member[(4u + _e2907)]), _e2672.member[0]);
                                atomicStore((&nodes.member[(_e2907 + 5u)]), _e2672.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2672.member_1 == 0u) {
                    } else {
                        if (_e2672.member_1 == 2u) {
                            let _e2846 = a_nodes.member[_e2672.member[0]];
                            let _e2850 = b_nodes.member[_e2672.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2846.member_1 < _e2850.member_1) {
                                    phi_4385_ = type_12(_e2846.member_1, _e2850.member_1);
                                } else {
                                    phi_4385_ = type_12(_e2850.member_1, _e2846.member_1);
                                }
                                let _e2859 = phi_4385_;
                                phi_4390_ = _e2859;
                            } else {
                                phi_4390_ = type_12(_e2846.member_1, _e2850.member_1);
                            }
                            let _e2861 = phi_4390_;
                            let _e2865 = atomicLoad((&shared_[12u]));
                            let _e2867 = (_e2865 + _e2702[0]);
                            if (_e2867 < _e103) {
                                let _e2869 = (2u * _e2867);
                                atomicStore((&pairs.member[(4u + _e2869)]), _e2861.member);
                                atomicStore((&pairs.member[(_e2869 + 5u)]), _e2861.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2877 = atomicLoad((&shared_[13u]));
                            let _e2879 = (_e2877 + _e2702[1]);
                            if (_e2879 < _e87.member_4) {
                                let _e2886 = (2u * ((_e87.member_5 * _e87.member_4) + _e2879));
                                front.member[_e2886] = _e2672.member[0];
                                front.member[(_e2886 + 1u)] = _e2672.member[1];
                            }
                        }
                    }
                }
                if (_e2678.member_1 == 1u) {
                    let _e2978 = atomicLoad((&shared_[10u]));
                    if (_e2725[0] < _e2978) {
                        let _e2998 = atomicLoad((&shared_[9u]));
                        let _e3001 = (2u * (_e2998 + _e2725[0]));
                        stack[_e3001] = _e2678.member[0];
                        stack[(_e3001 + 1u)] = _e2678.member[1];
                    } else {
                        let _e2982 = atomicLoad((&shared_[11u]));
                        let _e2985 = ((_e2982 + _e2725[0]) - _e2978);
                        if (_e2985 < _e87.member_3) {
                            let _e2988 = (_e101 + _e2985);
                            if (_e2988 < 4294967295u) {
                                let _e2992 = (2u * _e2988);
                                atomicStore((&nodes.member[(4u + _e2992)]), _e2678.member[0]);
                                atomicStore((&nodes.member[(_e2992 + 5u)]), _e2678.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2678.member_1 == 0u) {
                    } else {
                        if (_e2678.member_1 == 2u) {
                            let _e2931 = a_nodes.member[_e2678.member[0]];
                            let _e2935 = b_nodes.member[_e2678.member[1]];
                            if (_e87.member == 1u) {
                                if (_e2931.member_1 < _e2935.member_1) {
                                    phi_4526_ = type_12(_e2931.member_1, _e2935.member_1);
                                } else {
                                    phi_4526_ = type_12(_e2935.member_1, _e2931.member_1);
                                }
                                let _e2944 = phi_4526_;
                                phi_4531_ = _e2944;
                            } else {
                                phi_4531_ = type_12(_e2931.member_1, _e2935.member_1);
                            }
                            let _e2946 = phi_4531_;
                            let _e2950 = atomicLoad((&shared_[12u]));
                            let _e2952 = (_e2950 + _e2725[0]);
                            if (_e2952 < _e103) {
                                let _e2954 = (2u * _e2952);
                                atomicStore((&pairs.member[(4u + _e2954)]), _e2946.member);
                                atomicStore((&pairs.member[(_e2954 + 5u)]), _e2946.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e2962 = atomicLoad((&shared_[13u]));
                            let _e2964 = (_e2962 + _e2725[1]);
                            if (_e2964 < _e87.member_4) {
                                let _e2971 = (2u * ((_e87.member_5 * _e87.member_4) + _e2964));
                                front.member[_e2971] = _e2678.member[0];
                                front.member[(_e2971 + 1u)] = _e2678.member[1];
                            }
                        }
                    }
                }
                if (_e2676.member_1 == 1u) {
                    let _e3063 = atomicLoad((&shared_[10u]));
                    if (_e2748[0] < _e3063) {
                        let _e3083 = atomicLoad((&shared_[9u]));
                        let _e3086 = (2u * (_e3083 + _e2748[0]));
                        stack[_e3086] = _e2676.member[0];
                        stack[(_e3086 + 1u)] = _e2676.member[1];
                    } else {
                        let _e3067 = atomicLoad((&shared_[11u]));
                        let _e3070 = ((_e3067 + _e2748[0]) - _e3063);
                        if (_e3070 < _e87.member_3) {
                            let _e3073 = (_e101 + _e3070);
                            if (_e3073 < 4294967295u) {
                                let _e3077 = (2u * _e3073);
                                atomicStore((&nodes.member[(4u + _e3077)]), _e2676.member[0]);
                                atomicStore((&nodes.member[(_e3077 + 5u)]), _e2676.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2676.member_1 == 0u) {
                    } else {
                        if (_e2676.member_1 == 2u) {
                            let _e3016 = a_nodes.member[_e2676.member[0]];
                            let _e3020 = b_nodes.member[_e2676.member[1]];
                            if (_e87.member == 1u) {
                                if (_e3016.member_1 < _e3020.member_1) {
                                    phi_4667_ = type_12(_e3016.member_1, _e3020.member_1);
                                } else {
                                    phi_4667_ = type_12(_e3020.member_1, _e3016.member_1);
                                }
                                let _e3029 = phi_4667_;
                                phi_4672_ = _e3029;
                            } else {
                                phi_4672_ = type_12(_e3016.member_1, _e3020.member_1);
                            }
                            let _e3031 = phi_4672_;
                            let _e3035 = atomicLoad((&shared_[12u]));
                            let _e3037 = (_e3035 + _e2748[0]);
                            if (_e3037 < _e103) {
                                let _e3039 = (2u * _e3037);
                                atomicStore((&pairs.member[(4u + _e3039)]), _e3031.member);
                                atomicStore((&pairs.member[(_e3039 + 5u)]), _e3031.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e3047 = atomicLoad((&shared_[13u]));
                            let _e3049 = (_e3047 + _e2748[1]);
                            if (_e3049 < _e87.member_4) {
                                let _e3056 = (2u * ((_e87.member_5 * _e87.member_4) + _e3049));
                                front.member[_e3056] = _e2676.member[0];
                                front.member[(_e3056 + 1u)] = _e2676.member[1];
                            }
                        }
                    }
                }
                if (_e2674.member_1 == 1u) {
                    let _e3148 = atomicLoad((&shared_[10u]));
                    if (_e2771[0] < _e3148) {
                        let _e3168 = atomicLoad((&shared_[9u]));
                        let _e3171 = (2u * (_e3168 + _e2771[0]));
                        stack[_e3171] = _e2674.member[0];
                        stack[(_e3171 + 1u)] = _e2674.member[1];
                    } else {
                        let _e3152 = atomicLoad((&shared_[11u]));
                        let _e3155 = ((_e3152 + _e2771[0]) - _e3148);
                        if (_e3155 < _e87.member_3) {
                            let _e3158 = (_e101 + _e3155);
                            if (_e3158 < 4294967295u) {
                                let _e3162 = (2u * _e3158);
                                atomicStore((&nodes.member[(4u + _e3162)]), _e2674.member[0]);
                                atomicStore((&nodes.member[(_e3162 + 5u)]), _e2674.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2674.member_1 == 0u) {
                    } else {
                        if (_e2674.member_1 == 2u) {
                            let _e3101 = a_nodes.member[_e2674.member[0]];
                            let _e3105 = b_nodes.member[_e2674.member[1]];
                            if (_e87.member == 1u) {
                                if (_e3101.member_1 < _e3105.member_1) {
                                    phi_4808_ = type_12(_e3101.member_1, _e3105.member_1);
                                } else {
                                    phi_4808_ = type_12(_e3105.member_1, _e3101.member_1);
                                }
                                let _e3114 = phi_4808_;
                                phi_4813_ = _e3114;
                            } else {
                                phi_4813_ = type_12(_e3101.member_1, _e3105.member_1);
                            }
                            let _e3116 = phi_4813_;
                            let _e3120 = atomicLoad((&shared_[12u]));
                            let _e3122 = (_e3120 + _e2771[0]);
                            if (_e3122 < _e103) {
                                let _e3124 = (2u * _e3122);
                                atomicStore((&pairs.member[(4u + _e3124)]), _e3116.member);
                                atomicStore((&pairs.member[(_e3124 + 5u)]), _e3116.member_1);
                            }
                        }
                        if (_e87.member_4 > 0u) {
                            let _e3132 = atomicLoad((&shared_[13u]));
                            let _e3134 = (_e3132 + _e2771[1]);
                            if (_e3134 < _e87.member_4) {
                                let _e3141 = (2u * ((_e87.member_5 * _e87.member_4) + _e3134));
                                front.member[_e3141] = _e2674.member[0];
                                front.member[(_e3141 + 1u)] = _e2674.member[1];
                            }
                        }
                    }
                }
                phi_4857_ = true;
            }
            let _e3178 = phi_4857_;
            phi_4858_ = _e3178;
        } else {
            phi_4858_ = false;
        }
        let _e3180 = phi_4858_;
        continue;
        continuing {
            phi_198_ = _e124;
            break if !(_e3180);
        }
    }
    if (_e72 == 0u) {
        if (_e87.member_6 == 0u) {
            if (_e85 < _e98) {
                phi_4877_ = ((((_e98 - 1u) - _e85) >> bitcast<u32>((_e87.member_7 & 31u))) + 1u);
            } else {
                phi_4877_ = 0u;
            }
            let _e3193 = phi_4877_;
            let _e3195 = atomicLoad((&shared_[5u]));
            phi_4881_ = (_e3193 - _e3195);
        } else {
            phi_4881_ = 0u;
        }
        let _e3198 = phi_4881_;
        atomicStore((&shared_[14u]), _e3198);
        let _e3201 = atomicLoad((&shared_[0u]));
        let _e3202 = (_e3201 + _e3198);
        if (_e3202 > 0u) {
            if (_e87.member_12 == 0u) {
            } else {
                let _e3207 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e3210 = atomicAdd((&control.member[(_e90 + 1u)]), _e3202);
            let _e3213 = atomicMax((&nodes.member[0u]), (_e3210 + _e3202));
            if ((_e3210 + _e3202) < _e3210) {
                let _e3217 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e3210);
        }
        let _e3222 = atomicLoad((&shared_[15u]));
        let _e3224 = atomicAdd((&control.member[(1540u + (2u * _e85))]), _e3222);
        let _e3228 = atomicLoad((&shared_[16u]));
        let _e3230 = atomicAdd((&control.member[((2u * _e85) + 1541u)]), _e3228);
    }
    workgroupBarrier();
    let _e3232 = atomicLoad((&shared_[0u]));
    let _e3234 = atomicLoad((&shared_[17u]));
    let _e3236 = atomicLoad((&shared_[14u]));
    phi_4938_ = type_12(0u, 8u);
    loop {
        let _e3238 = phi_4938_;
        if (_e3238.member < _e3238.member_1) {
            phi_4939_ = type_12((_e3238.member + 1u), _e3238.member_1);
            phi_4962_ = type_12(1u, _e3238.member);
        } else {
            phi_4939_ = _e3238;
            phi_4962_ = type_12(0u, type_12().member_1);
        }
        let _e3250 = phi_4939_;
        let _e3252 = phi_4962_;
        let _e3256 = (bitcast<i32>(_e3252.member) != 0i);
        if _e3256 {
            let _e3258 = ((_e3252.member_1 * 128u) + _e72);
            if (_e3258 < _e3232) {
                let _e3262 = stack[(2u * _e3258)];
                let _e3266 = stack[((2u * _e3258) + 1u)];
                let _e3267 = (_e3234 + _e3258);
                if (_e3267 < _e87.member_3) {
                    let _e3270 = (_e101 + _e3267);
                    if (_e3270 < 4294967295u) {
                        let _e3272 = (2u * _e3270);
                        atomicStore((&nodes.member[(4u + _e3272)]), _e3262);
                        atomicStore((&nodes.member[(_e3272 + 5u)]), _e3266);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_4938_ = _e3250;
            break if !(_e3256);
        }
    }
    let _e3279 = atomicLoad((&shared_[5u]));
    let _e3280 = (_e3236 / 128u);
    if ((_e3236 % 128u) > 0u) {
        phi_5018_ = (_e3280 + 1u);
    } else {
        phi_5018_ = _e3280;
    }
    let _e3285 = phi_5018_;
    phi_5021_ = type_12(0u, _e3285);
    loop {
        let _e3288 = phi_5021_;
        if (_e3288.member < _e3288.member_1) {
            phi_5022_ = type_12((_e3288.member + 1u), _e3288.member_1);
            phi_5045_ = type_12(1u, _e3288.member);
        } else {
            phi_5022_ = _e3288;
            phi_5045_ = type_12(0u, type_12().member_1);
        }
        let _e3300 = phi_5022_;
        let _e3302 = phi_5045_;
        let _e3306 = (bitcast<i32>(_e3302.member) != 0i);
        if _e3306 {
            let _e3308 = ((_e3302.member_1 * 128u) + _e72);
            if (_e3308 < _e3236) {
                let _e3316 = (2u * ((_e99 + _e85) + ((_e3279 + _e3308) << bitcast<u32>((_e87.member_7 & 31u)))));
                let _e3319 = atomicLoad((&nodes.member[(4u + _e3316)]));
                let _e3322 = atomicLoad((&nodes.member[(_e3316 + 5u)]));
                let _e3324 = ((_e3234 + _e3232) + _e3308);
                if (_e3324 < _e87.member_3) {
                    let _e3327 = (_e101 + _e3324);
                    if (_e3327 < 4294967295u) {
                        let _e3329 = (2u * _e3327);
                        atomicStore((&nodes.member[(4u + _e3329)]), _e3319);
                        atomicStore((&nodes.member[(_e3329 + 5u)]), _e3322);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5021_ = _e3300;
            break if !(_e3306);
        }
    }
    if (_e87.member_6 == 1u) {
        if (_e3279 == 0u) {
            phi_5117_ = type_12(0u, _e98);
            loop {
                let _e3340 = phi_5117_;
                if (_e3340.member < _e3340.member_1) {
                    phi_5118_ = type_12((_e3340.member + 1u), _e3340.member_1);
                    phi_5141_ = type_12(1u, _e3340.member);
                } else {
                    phi_5118_ = _e3340;
                    phi_5141_ = type_12(0u, type_12().member_1);
                }
                let _e3352 = phi_5118_;
                let _e3354 = phi_5141_;
                if (bitcast<i32>(_e3354.member) != 0i) {
                    let _e3360 = atomicAdd((&control.member[(512u + _e90)]), 1u);
                    if (_e3360 >= _e98) {
                        phi_5221_ = false;
                    } else {
                        let _e3363 = (2u * (_e99 + _e3360));
                        let _e3366 = atomicLoad((&nodes.member[(4u + _e3363)]));
                        let _e3369 = atomicLoad((&nodes.member[(_e3363 + 5u)]));
                        if (_e87.member_12 == 0u) {
                        } else {
                            let _e3373 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3376 = atomicAdd((&control.member[(_e90 + 1u)]), 1u);
                        let _e3379 = atomicMax((&nodes.member[0u]), (_e3376 + 1u));
                        if ((_e3376 + 1u) < _e3376) {
                            let _e3383 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3376 < _e87.member_3) {
                            let _e3386 = (_e101 + _e3376);
                            if (_e3386 < 4294967295u) {
                                let _e3388 = (2u * _e3386);
                                atomicStore((&nodes.member[(4u + _e3388)]), _e3366);
                                atomicStore((&nodes.member[(_e3388 + 5u)]), _e3369);
                            }
                        }
                        phi_5221_ = true;
                    }
                    let _e3394 = phi_5221_;
                    phi_5222_ = _e3394;
                } else {
                    phi_5222_ = false;
                }
                let _e3396 = phi_5222_;
                continue;
                continuing {
                    phi_5117_ = _e3352;
                    break if !(_e3396);
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
