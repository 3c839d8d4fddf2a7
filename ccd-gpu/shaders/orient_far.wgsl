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

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_22 {
    member: array<vec4<u32>>,
}

struct type_24 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_26 {
    member: array<type_24>,
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

struct type_33 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_34 {
    member: f32,
    member_1: f32,
}

struct type_36 {
    member: array<f32, 2>,
    member_1: array<f32, 3>,
    member_2: array<array<f32, 3>, 3>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> branches: type_22;
@group(0) @binding(2) 
var<storage> block_nodes: type_26;
@group(0) @binding(3) 
var<storage> far: type_11;
@group(0) @binding(4) 
var<storage, read_write> oriented: type_31;
@group(0) @binding(5) 
var<storage, read_write> stamps: type_40;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_165_: u32;
    var phi_168_: type_9;
    var phi_169_: type_9;
    var phi_192_: type_9;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_490_: type_33;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_579_: f32;
    var phi_636_: type_33;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_664_: f32;
    var phi_670_: f32;
    var phi_675_: f32;
    var phi_683_: f32;
    var phi_690_: f32;
    var phi_695_: f32;
    var phi_702_: f32;
    var phi_707_: f32;
    var phi_712_: f32;
    var phi_720_: f32;
    var phi_727_: f32;
    var phi_732_: f32;
    var phi_739_: f32;
    var phi_744_: f32;
    var phi_749_: f32;
    var phi_770_: u32;
    var phi_772_: f32;
    var phi_773_: bool;
    var phi_774_: f32;
    var phi_775_: bool;
    var phi_779_: f32;
    var phi_1046_: f32;
    var phi_1053_: f32;
    var phi_1058_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1079_: f32;
    var phi_1085_: f32;
    var phi_1090_: f32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1127_: u32;
    var phi_1172_: type_14;
    var phi_1175_: f32;
    var phi_1196_: bool;
    var phi_1202_: type_15;
    var phi_1173_: type_14;
    var phi_1216_: type_15;
    var phi_1176_: f32;
    var local: f32;
    var phi_1165_: f32;
    var phi_1229_: f32;
    var phi_1241_: type_34;
    var phi_1280_: type_9;
    var phi_1283_: type_36;
    var phi_1281_: type_9;
    var phi_1306_: type_9;
    var phi_1326_: f32;
    var phi_1333_: f32;
    var phi_1366_: type_14;
    var phi_1369_: f32;
    var phi_1390_: bool;
    var phi_1396_: type_15;
    var phi_1367_: type_14;
    var phi_1410_: type_15;
    var phi_1370_: f32;
    var local_1: f32;
    var phi_1359_: f32;
    var phi_1423_: f32;
    var phi_1430_: f32;
    var phi_1464_: type_14;
    var phi_1467_: f32;
    var phi_1488_: bool;
    var phi_1494_: type_15;
    var phi_1465_: type_14;
    var phi_1508_: type_15;
    var phi_1468_: f32;
    var local_2: f32;
    var phi_1457_: f32;
    var phi_1521_: f32;
    var phi_1533_: type_34;
    var phi_1629_: type_14;
    var phi_1632_: f32;
    var phi_1653_: bool;
    var phi_1659_: type_15;
    var phi_1630_: type_14;
    var phi_1673_: type_15;
    var phi_1633_: f32;
    var local_3: f32;
    var phi_1622_: f32;
    var phi_1686_: f32;
    var phi_1698_: type_34;
    var phi_1765_: type_36;
    var phi_1766_: bool;
    var phi_1767_: type_36;
    var phi_1768_: bool;
    var phi_2057_: type_14;
    var phi_2060_: f32;
    var phi_2081_: bool;
    var phi_2087_: type_15;
    var phi_2058_: type_14;
    var phi_2101_: type_15;
    var phi_2061_: f32;
    var local_4: f32;
    var phi_2050_: f32;
    var phi_2114_: f32;
    var phi_2121_: f32;
    var phi_2155_: type_14;
    var phi_2158_: f32;
    var phi_2179_: bool;
    var phi_2185_: type_15;
    var phi_2156_: type_14;
    var phi_2199_: type_15;
    var phi_2159_: f32;
    var local_5: f32;
    var phi_2148_: f32;
    var phi_2212_: f32;
    var phi_2224_: type_34;
    var phi_2286_: type_36;
    var phi_1800_: type_14;
    var phi_1803_: f32;
    var phi_1824_: bool;
    var phi_1830_: type_15;
    var phi_1801_: type_14;
    var phi_1844_: type_15;
    var phi_1804_: f32;
    var local_6: f32;
    var phi_1793_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1898_: type_14;
    var phi_1901_: f32;
    var phi_1922_: bool;
    var phi_1928_: type_15;
    var phi_1899_: type_14;
    var phi_1942_: type_15;
    var phi_1902_: f32;
    var local_7: f32;
    var phi_1891_: f32;
    var phi_1955_: f32;
    var phi_1967_: type_34;
    var phi_2287_: type_36;
    var phi_2288_: type_36;
    var phi_2292_: bool;
    var phi_2296_: bool;
    var phi_1284_: type_36;
    var phi_2297_: type_36;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var local_8: bool;
    var phi_2303_: type_36;
    var phi_2315_: u32;
    var phi_2448_: f32;
    var phi_2454_: f32;
    var phi_2460_: f32;
    var phi_2466_: f32;
    var phi_2472_: f32;
    var phi_2478_: f32;
    var phi_2522_: f32;
    var phi_2528_: f32;
    var phi_2534_: f32;
    var phi_2540_: f32;
    var phi_2546_: f32;
    var phi_2552_: f32;
    var phi_2596_: f32;
    var phi_2602_: f32;
    var phi_2608_: f32;
    var phi_2614_: f32;
    var phi_2620_: f32;
    var phi_2626_: f32;
    var phi_2667_: f32;
    var phi_2673_: f32;
    var phi_2678_: f32;
    var phi_2684_: f32;
    var phi_2689_: f32;
    var phi_2695_: f32;
    var phi_2701_: f32;
    var phi_2706_: f32;
    var phi_2712_: f32;
    var phi_2717_: f32;
    var phi_2722_: f32;
    var phi_2733_: array<array<f32, 3>, 3>;
    var phi_2735_: type_37;
    var phi_2736_: bool;
    var phi_2737_: type_37;
    var phi_2738_: bool;
    var phi_2751_: type_37;
    var phi_2796_: f32;
    var phi_2802_: f32;
    var phi_2808_: f32;
    var phi_2860_: f32;
    var phi_2866_: f32;
    var phi_2872_: f32;
    var phi_2924_: f32;
    var phi_2930_: f32;
    var phi_2936_: f32;
    var phi_2988_: f32;
    var phi_2994_: f32;
    var phi_3000_: f32;
    var phi_3052_: f32;
    var phi_3058_: f32;
    var phi_3064_: f32;
    var phi_3116_: f32;
    var phi_3122_: f32;
    var phi_3128_: f32;
    var phi_3174_: f32;
    var phi_3179_: f32;
    var phi_3184_: f32;
    var phi_3192_: f32;
    var phi_3197_: f32;
    var phi_3202_: f32;
    var phi_3258_: f32;
    var phi_3265_: f32;
    var phi_3273_: f32;
    var phi_3282_: f32;
    var phi_3288_: f32;
    var phi_3294_: f32;
    var phi_3302_: f32;
    var phi_3309_: f32;
    var phi_3316_: f32;
    var phi_3329_: f32;
    var phi_3336_: f32;
    var phi_3343_: f32;
    var phi_3356_: f32;
    var phi_3363_: f32;
    var phi_3370_: f32;
    var phi_3417_: f32;
    var phi_3423_: f32;
    var phi_3429_: f32;
    var phi_3473_: f32;
    var phi_3479_: f32;
    var phi_3485_: f32;
    var phi_3537_: f32;
    var phi_3543_: f32;
    var phi_3549_: f32;
    var phi_3601_: f32;
    var phi_3607_: f32;
    var phi_3613_: f32;
    var phi_3642_: f32;
    var phi_3649_: f32;
    var phi_3657_: f32;
    var phi_3666_: f32;
    var phi_3672_: f32;
    var phi_3678_: f32;
    var phi_3686_: f32;
    var phi_3693_: f32;
    var phi_3700_: f32;
    var phi_3713_: f32;
    var phi_3720_: f32;
    var phi_3727_: f32;
    var phi_3740_: f32;
    var phi_3747_: f32;
    var phi_3754_: f32;
    var phi_3801_: f32;
    var phi_3807_: f32;
    var phi_3813_: f32;
    var phi_3857_: f32;
    var phi_3863_: f32;
    var phi_3869_: f32;
    var phi_3921_: f32;
    var phi_3927_: f32;
    var phi_3933_: f32;
    var phi_3985_: f32;
    var phi_3991_: f32;
    var phi_3997_: f32;
    var phi_4027_: bool;
    var phi_4028_: bool;
    var phi_4029_: bool;
    var phi_4030_: bool;
    var phi_4034_: bool;
    var phi_4053_: bool;
    var phi_4054_: bool;
    var phi_4055_: bool;
    var phi_4056_: bool;
    var phi_4060_: bool;
    var phi_4068_: f32;
    var phi_4073_: f32;
    var phi_4078_: f32;
    var phi_4081_: type_33;
    var phi_4082_: bool;
    var phi_4083_: type_33;
    var phi_4084_: bool;
    var phi_4098_: u32;
    var phi_4108_: type_33;
    var phi_4140_: bool;
    var phi_4141_: bool;
    var local_9: type_36;
    var local_10: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e49 = id_2;
    let _e50 = n_2;
    let _e51 = lane_2;
    let _e59 = far.member[0u];
    let _e62 = params.member.member_2.member_1;
    let _e66 = params.member.member.member_2[_e62];
    let _e69 = params.member.member_1.member_1;
    let _e73 = ((_e50.x * _e50.y) * 128u);
    if (_e73 == 0u) {
        return;
    }
    let _e75 = (_e59 / _e73);
    if (_e73 == 0u) {
        return;
    }
    if ((_e59 % _e73) > 0u) {
        phi_165_ = (_e75 + 1u);
    } else {
        phi_165_ = _e75;
    }
    let _e81 = phi_165_;
    phi_168_ = type_9(0u, _e81);
    loop {
        let _e84 = phi_168_;
        if (_e84.member < _e84.member_1) {
            phi_169_ = type_9((_e84.member + 1u), _e84.member_1);
            phi_192_ = type_9(1u, _e84.member);
        } else {
            phi_169_ = _e84;
            phi_192_ = type_9(0u, type_9().member_1);
        }
        let _e96 = phi_169_;
        let _e98 = phi_192_;
        if (bitcast<i32>(_e98.member) != 0i) {
            let _e111 = (((_e98.member_1 * _e73) + (((_e49.y * _e50.x) + _e49.x) * 128u)) + _e51);
            if (_e111 >= _e59) {
                phi_4140_ = false;
            } else {
                let _e115 = far.member[(4u + _e111)];
                let _e116 = (_e66 + _e115);
                let _e118 = atomicLoad((&stamps.member[_e116]));
                if (_e118 == 0u) {
                    let _e121 = branches.member[_e115];
                    let _e126 = params.member.member_2.member_1;
                    let _e131 = params.member.member.member[_e126];
                    if ((_e121.x + 1u) >= _e131) {
                        phi_294_ = true;
                    } else {
                        let _e136 = params.member.member.member_2[_e126];
                        let _e139 = atomicLoad((&stamps.member[(_e136 + _e121.x)]));
                        let _e142 = params.member.member_1.member_1;
                        if (_e139 == 0u) {
                            phi_293_ = false;
                        } else {
                            phi_293_ = (_e139 < _e142);
                        }
                        let _e146 = phi_293_;
                        phi_294_ = _e146;
                    }
                    let _e148 = phi_294_;
                    if _e148 {
                        let _e151 = params.member.member_2.member_1;
                        let _e156 = params.member.member.member[_e151];
                        if ((_e121.y + 1u) >= _e156) {
                            phi_341_ = true;
                        } else {
                            let _e161 = params.member.member.member_2[_e151];
                            let _e164 = atomicLoad((&stamps.member[(_e161 + _e121.y)]));
                            let _e167 = params.member.member_1.member_1;
                            if (_e164 == 0u) {
                                phi_340_ = false;
                            } else {
                                phi_340_ = (_e164 < _e167);
                            }
                            let _e171 = phi_340_;
                            phi_341_ = _e171;
                        }
                        let _e173 = phi_341_;
                        if _e173 {
                            let _e176 = params.member.member_2.member_1;
                            let _e181 = params.member.member.member[_e176];
                            if ((_e121.x + 1u) >= _e181) {
                                let _e229 = params.member.member_2.member_1;
                                let _e233 = params.member.member.member[_e229];
                                let _e240 = params.member.member_2.member[0u][_e229];
                                let _e243 = block_nodes.member[(_e240 + (_e121.x - (_e233 - 1u)))];
                                let _e262 = ((_e243.member.x * 0.5f) + (_e243.member_1.y * 0.5f));
                                let _e263 = ((_e243.member.y * 0.5f) + (_e243.member_2.x * 0.5f));
                                let _e264 = ((_e243.member_1.x * 0.5f) + (_e243.member_2.y * 0.5f));
                                let _e266 = (_e243.member_1.y - _e262);
                                let _e267 = (_e243.member_2.x - _e263);
                                let _e268 = (_e243.member_2.y - _e264);
                                let _e269 = (_e262 - _e243.member.x);
                                let _e270 = (_e263 - _e243.member.y);
                                let _e271 = (_e264 - _e243.member_1.x);
                                if (_e266 > _e269) {
                                    phi_423_ = _e266;
                                } else {
                                    phi_423_ = _e269;
                                }
                                let _e274 = phi_423_;
                                if (_e267 > _e270) {
                                    phi_428_ = _e267;
                                } else {
                                    phi_428_ = _e270;
                                }
                                let _e277 = phi_428_;
                                if (_e268 > _e271) {
                                    phi_433_ = _e268;
                                } else {
                                    phi_433_ = _e271;
                                }
                                let _e280 = phi_433_;
                                let _e282 = (1f + (0.000000059604645f * 4f));
                                let _e286 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_490_ = type_33(array<f32, 3>(_e262, _e263, _e264), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e274 * _e282) + _e286), ((_e277 * _e282) + _e286), ((_e280 * _e282) + _e286)));
                            } else {
                                let _e186 = params.member.member.member_2[_e176];
                                let _e189 = oriented.member[(_e186 + _e121.x)];
                                phi_490_ = type_33(array<f32, 3>(_e189.member.x, _e189.member.y, _e189.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e189.member.w, _e189.member_1.x, _e189.member_1.y), array<f32, 3>(_e189.member_1.z, _e189.member_1.w, _e189.member_2.x), array<f32, 3>(_e189.member_2.y, _e189.member_2.z, _e189.member_2.w)), array<f32, 3>(_e189.member_3.x, _e189.member_3.y, _e189.member_3.z));
                            }
                            let _e293 = phi_490_;
                            let _e296 = params.member.member_2.member_1;
                            let _e301 = params.member.member.member[_e296];
                            if ((_e121.y + 1u) >= _e301) {
                                let _e349 = params.member.member_2.member_1;
                                let _e353 = params.member.member.member[_e349];
                                let _e360 = params.member.member_2.member[0u][_e349];
                                let _e363 = block_nodes.member[(_e360 + (_e121.y - (_e353 - 1u)))];
                                let _e382 = ((_e363.member.x * 0.5f) + (_e363.member_1.y * 0.5f));
                                let _e383 = ((_e363.member.y * 0.5f) + (_e363.member_2.x * 0.5f));
                                let _e384 = ((_e363.member_1.x * 0.5f) + (_e363.member_2.y * 0.5f));
                                let _e386 = (_e363.member_1.y - _e382);
                                let _e387 = (_e363.member_2.x - _e383);
                                let _e388 = (_e363.member_2.y - _e384);
                                let _e389 = (_e382 - _e363.member.x);
                                let _e390 = (_e383 - _e363.member.y);
                                let _e391 = (_e384 - _e363.member_1.x);
                                if (_e386 > _e389) {
                                    phi_569_ = _e386;
                                } else {
                                    phi_569_ = _e389;
                                }
                                let _e394 = phi_569_;
                                if (_e387 > _e390) {
                                    phi_574_ = _e387;
                                } else {
                                    phi_574_ = _e390;
                                }
                                let _e397 = phi_574_;
                                if (_e388 > _e391) {
                                    phi_579_ = _e388;
                                } else {
                                    phi_579_ = _e391;
                                }
                                let _e400 = phi_579_;
                                let _e402 = (1f + (0.000000059604645f * 4f));
                                let _e406 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_636_ = type_33(array<f32, 3>(_e382, _e383, _e384), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e394 * _e402) + _e406), ((_e397 * _e402) + _e406), ((_e400 * _e402) + _e406)));
                            } else {
                                let _e306 = params.member.member.member_2[_e296];
                                let _e309 = oriented.member[(_e306 + _e121.y)];
                                phi_636_ = type_33(array<f32, 3>(_e309.member.x, _e309.member.y, _e309.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e309.member.w, _e309.member_1.x, _e309.member_1.y), array<f32, 3>(_e309.member_1.z, _e309.member_1.w, _e309.member_2.x), array<f32, 3>(_e309.member_2.y, _e309.member_2.z, _e309.member_2.w)), array<f32, 3>(_e309.member_3.x, _e309.member_3.y, _e309.member_3.z));
                            }
                            let _e413 = phi_636_;
                            let _e418 = (_e413.member[0] - _e293.member[0]);
                            let _e421 = (_e413.member[1] - _e293.member[1]);
                            let _e424 = (_e413.member[2] - _e293.member[2]);
                            if (_e418 < 0f) {
                                phi_653_ = -(_e418);
                            } else {
                                phi_653_ = _e418;
                            }
                            let _e428 = phi_653_;
                            if (_e421 < 0f) {
                                phi_659_ = -(_e421);
                            } else {
                                phi_659_ = _e421;
                            }
                            let _e432 = phi_659_;
                            if (_e428 > _e432) {
                                phi_664_ = _e428;
                            } else {
                                phi_664_ = _e432;
                            }
                            let _e435 = phi_664_;
                            if (_e424 < 0f) {
                                phi_670_ = -(_e424);
                            } else {
                                phi_670_ = _e424;
                            }
                            let _e439 = phi_670_;
                            if (_e435 > _e439) {
                                phi_675_ = _e435;
                            } else {
                                phi_675_ = _e439;
                            }
                            let _e442 = phi_675_;
                            if (_e293.member_2[0] < 0f) {
                                phi_683_ = -(_e293.member_2[0]);
                            } else {
                                phi_683_ = _e293.member_2[0];
                            }
                            let _e448 = phi_683_;
                            if (_e293.member_2[1] < 0f) {
                                phi_690_ = -(_e293.member_2[1]);
                            } else {
                                phi_690_ = _e293.member_2[1];
                            }
                            let _e453 = phi_690_;
                            if (_e448 > _e453) {
                                phi_695_ = _e448;
                            } else {
                                phi_695_ = _e453;
                            }
                            let _e456 = phi_695_;
                            if (_e293.member_2[2] < 0f) {
                                phi_702_ = -(_e293.member_2[2]);
                            } else {
                                phi_702_ = _e293.member_2[2];
                            }
                            let _e461 = phi_702_;
                            if (_e456 > _e461) {
                                phi_707_ = _e456;
                            } else {
                                phi_707_ = _e461;
                            }
                            let _e464 = phi_707_;
                            if (_e442 > _e464) {
                                phi_712_ = _e442;
                            } else {
                                phi_712_ = _e464;
                            }
                            let _e467 = phi_712_;
                            if (_e413.member_2[0] < 0f) {
                                phi_720_ = -(_e413.member_2[0]);
                            } else {
                                phi_720_ = _e413.member_2[0];
                            }
                            let _e473 = phi_720_;
                            if (_e413.member_2[1] < 0f) {
                                phi_727_ = -(_e413.member_2[1]);
                            } else {
                                phi_727_ = _e413.member_2[1];
                            }
                            let _e478 = phi_727_;
                            if (_e473 > _e478) {
                                phi_732_ = _e473;
                            } else {
                                phi_732_ = _e478;
                            }
                            let _e481 = phi_732_;
                            if (_e413.member_2[2] < 0f) {
                                phi_739_ = -(_e413.member_2[2]);
                            } else {
                                phi_739_ = _e413.member_2[2];
                            }
                            let _e486 = phi_739_;
                            if (_e481 > _e486) {
                                phi_744_ = _e481;
                            } else {
                                phi_744_ = _e486;
                            }
                            let _e489 = phi_744_;
                            if (_e467 > _e489) {
                                phi_749_ = _e467;
                            } else {
                                phi_749_ = _e489;
                            }
                            let _e492 = phi_749_;
                            if (_e492 > 0.000000000000000000000000000000000000011754944f) {
                                if ((bitcast<u32>(_e492) & 2139095040u) != 2139095040u) {
                                    let _e499 = (2130706432u - (bitcast<u32>(_e492) & 2139095040u));
                                    if (_e499 > 8388608u) {
                                        phi_770_ = _e499;
                                    } else {
                                        phi_770_ = 8388608u;
                                    }
                                    let _e502 = phi_770_;
                                    phi_772_ = bitcast<f32>(_e502);
                                    phi_773_ = false;
                                } else {
                                    phi_772_ = f32();
                                    phi_773_ = true;
                                }
                                let _e505 = phi_772_;
                                let _e507 = phi_773_;
                                phi_774_ = _e505;
                                phi_775_ = _e507;
                            } else {
                                phi_774_ = f32();
                                phi_775_ = true;
                            }
                            let _e509 = phi_774_;
                            let _e511 = phi_775_;
                            if _e511 {
                                phi_779_ = 0f;
                            } else {
                                phi_779_ = _e509;
                            }
                            let _e513 = phi_779_;
                            let _e514 = (_e418 * _e513);
                            let _e515 = (_e421 * _e513);
                            let _e516 = (_e424 * _e513);
                            let _e517 = (_e514 * 0.5f);
                            let _e518 = (_e515 * 0.5f);
                            let _e536 = (_e293.member_2[0] * _e513);
                            let _e538 = (_e293.member_1[0][0] * _e536);
                            let _e540 = (_e293.member_1[0][1] * _e536);
                            let _e542 = (_e293.member_1[0][2] * _e536);
                            let _e543 = (_e538 * 1f);
                            let _e544 = (_e540 * 1f);
                            let _e562 = (_e293.member_2[1] * _e513);
                            let _e564 = (_e293.member_1[1][0] * _e562);
                            let _e566 = (_e293.member_1[1][1] * _e562);
                            let _e568 = (_e293.member_1[1][2] * _e562);
                            let _e569 = (_e564 * 1f);
                            let _e570 = (_e566 * 1f);
                            let _e588 = (_e293.member_2[2] * _e513);
                            let _e590 = (_e293.member_1[2][0] * _e588);
                            let _e592 = (_e293.member_1[2][1] * _e588);
                            let _e594 = (_e293.member_1[2][2] * _e588);
                            let _e595 = (_e590 * 1f);
                            let _e596 = (_e592 * 1f);
                            let _e614 = (_e413.member_2[0] * _e513);
                            let _e616 = (_e413.member_1[0][0] * _e614);
                            let _e618 = (_e413.member_1[0][1] * _e614);
                            let _e620 = (_e413.member_1[0][2] * _e614);
                            let _e621 = (_e616 * 1f);
                            let _e622 = (_e618 * 1f);
                            let _e640 = (_e413.member_2[1] * _e513);
                            let _e642 = (_e413.member_1[1][0] * _e640);
                            let _e644 = (_e413.member_1[1][1] * _e640);
                            let _e646 = (_e413.member_1[1][2] * _e640);
                            let _e647 = (_e642 * 1f);
                            let _e648 = (_e644 * 1f);
                            let _e666 = (_e413.member_2[2] * _e513);
                            let _e668 = (_e413.member_1[2][0] * _e666);
                            let _e670 = (_e413.member_1[2][1] * _e666);
                            let _e672 = (_e413.member_1[2][2] * _e666);
                            let _e673 = (_e668 * 1f);
                            let _e674 = (_e670 * 1f);
                            let _e679 = (((((((0f + (_e514 * _e517)) + (_e538 * _e543)) + (_e564 * _e569)) + (_e590 * _e595)) + (_e616 * _e621)) + (_e642 * _e647)) + (_e668 * _e673));
                            let _e680 = (((((((0f + (_e515 * _e517)) + (_e540 * _e543)) + (_e566 * _e569)) + (_e592 * _e595)) + (_e618 * _e621)) + (_e644 * _e647)) + (_e670 * _e673));
                            let _e681 = (((((((0f + (_e516 * _e517)) + (_e542 * _e543)) + (_e568 * _e569)) + (_e594 * _e595)) + (_e620 * _e621)) + (_e646 * _e647)) + (_e672 * _e673));
                            let _e683 = (((((((0f + (_e518 * _e515)) + (_e544 * _e540)) + (_e570 * _e566)) + (_e596 * _e592)) + (_e622 * _e618)) + (_e648 * _e644)) + (_e674 * _e670));
                            let _e685 = (((((((0f + (_e518 * _e516)) + (_e544 * _e542)) + (_e570 * _e568)) + (_e596 * _e594)) + (_e622 * _e620)) + (_e648 * _e646)) + (_e674 * _e672));
                            let _e687 = (((((((0f + ((_e516 * 0.5f) * _e516)) + ((_e542 * 1f) * _e542)) + ((_e568 * 1f) * _e568)) + ((_e594 * 1f) * _e594)) + ((_e620 * 1f) * _e620)) + ((_e646 * 1f) * _e646)) + ((_e672 * 1f) * _e672));
                            if (_e679 < 0f) {
                                phi_1046_ = -(_e679);
                            } else {
                                phi_1046_ = _e679;
                            }
                            let _e691 = phi_1046_;
                            if (_e680 < 0f) {
                                phi_1053_ = -(_e680);
                            } else {
                                phi_1053_ = _e680;
                            }
                            let _e695 = phi_1053_;
                            if (_e691 > _e695) {
                                phi_1058_ = _e691;
                            } else {
                                phi_1058_ = _e695;
                            }
                            let _e698 = phi_1058_;
                            if (_e681 < 0f) {
                                phi_1065_ = -(_e681);
                            } else {
                                phi_1065_ = _e681;
                            }
                            let _e702 = phi_1065_;
                            if (_e698 > _e702) {
                                phi_1070_ = _e698;
                            } else {
                                phi_1070_ = _e702;
                            }
                            let _e705 = phi_1070_;
                            if (_e683 < 0f) {
                                phi_1079_ = -(_e683);
                            } else {
                                phi_1079_ = _e683;
                            }
                            let _e709 = phi_1079_;
                            if (_e685 < 0f) {
                                phi_1085_ = -(_e685);
                            } else {
                                phi_1085_ = _e685;
                            }
                            let _e713 = phi_1085_;
                            if (_e709 > _e713) {
                                phi_1090_ = _e709;
                            } else {
                                phi_1090_ = _e713;
                            }
                            let _e716 = phi_1090_;
                            if (_e687 < 0f) {
                                phi_1096_ = -(_e687);
                            } else {
                                phi_1096_ = _e687;
                            }
                            let _e720 = phi_1096_;
                            if (_e716 > _e720) {
                                phi_1101_ = _e716;
                            } else {
                                phi_1101_ = _e720;
                            }
                            let _e723 = phi_1101_;
                            if (_e705 > _e723) {
                                phi_1106_ = _e705;
                            } else {
                                phi_1106_ = _e723;
                            }
                            let _e726 = phi_1106_;
                            if (_e726 > 0.000000000000000000000000000000000000011754944f) {
                                if ((bitcast<u32>(_e726) & 2139095040u) != 2139095040u) {
                                    let _e733 = (2130706432u - (bitcast<u32>(_e726) & 2139095040u));
                                    if (_e733 > 8388608u) {
                                        phi_1127_ = _e733;
                                    } else {
                                        phi_1127_ = 8388608u;
                                    }
                                    let _e736 = phi_1127_;
                                    let _e737 = bitcast<f32>(_e736);
                                    let _e739 = (_e680 * _e737);
                                    let _e740 = (_e681 * _e737);
                                    let _e741 = (_e683 * _e737);
                                    let _e742 = (_e685 * _e737);
                                    let _e743 = (_e687 * _e737);
                                    let _e746 = ((_e739 * _e739) + (_e740 * _e740));
                                    if (_e746 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                        if (_e746 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e746 > 0f) {
                                                phi_1165_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1165_ = 0f;
                                            }
                                            let _e803 = phi_1165_;
                                            phi_1229_ = _e803;
                                        } else {
                                            phi_1172_ = type_14(0i, 5i);
                                            phi_1175_ = bitcast<f32>(((bitcast<u32>(_e746) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e758 = phi_1172_;
                                                let _e760 = phi_1175_;
                                                local = _e760;
                                                if (_e758.member < _e758.member_1) {
                                                    let _e767 = (_e758.member + 1i);
                                                    if ((false == (_e767 > _e758.member)) != false) {
                                                        phi_1196_ = true;
                                                    } else {
                                                        phi_1196_ = false;
                                                    }
                                                    let _e772 = phi_1196_;
                                                    if _e772 {
                                                        phi_1202_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1202_ = type_15(1u, _e767);
                                                    }
                                                    let _e777 = phi_1202_;
                                                    phi_1173_ = type_14(_e777.member_1, _e758.member_1);
                                                    phi_1216_ = type_15(1u, _e758.member);
                                                } else {
                                                    phi_1173_ = _e758;
                                                    phi_1216_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e783 = phi_1173_;
                                                let _e785 = phi_1216_;
                                                let _e788 = (bitcast<i32>(_e785.member) != 0i);
                                                if _e788 {
                                                    phi_1176_ = (0.5f * (_e760 + (_e746 / _e760)));
                                                } else {
                                                    phi_1176_ = f32();
                                                }
                                                let _e793 = phi_1176_;
                                                continue;
                                                continuing {
                                                    phi_1172_ = _e783;
                                                    phi_1175_ = _e793;
                                                    break if !(_e788);
                                                }
                                            }
                                            let _e798 = local;
                                            phi_1229_ = (_e798 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e805 = phi_1229_;
                                        let _e806 = (_e739 / _e805);
                                        let _e807 = (_e740 / _e805);
                                        let _e812 = (1.5f - (((_e806 * _e806) + (_e807 * _e807)) * 0.5f));
                                        phi_1241_ = type_34((_e806 * _e812), (_e807 * _e812));
                                    } else {
                                        phi_1241_ = type_34(1f, 0f);
                                    }
                                    let _e817 = phi_1241_;
                                    let _e822 = (((_e817.member * _e817.member_1) * _e742) * 2f);
                                    phi_1280_ = type_9(0u, 16u);
                                    phi_1283_ = type_36(array<f32, 2>(((_e817.member * _e739) + (_e817.member_1 * _e740)), (((_e817.member * _e817.member_1) * (_e741 - _e743)) + (((_e817.member_1 * _e817.member_1) - (_e817.member * _e817.member)) * _e742))), array<f32, 3>((_e679 * _e737), ((((_e817.member * _e817.member) * _e741) + _e822) + ((_e817.member_1 * _e817.member_1) * _e743)), ((((_e817.member_1 * _e817.member_1) * _e741) - _e822) + ((_e817.member * _e817.member) * _e743))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e817.member, _e817.member_1), array<f32, 3>(0f, _e817.member_1, -(_e817.member))));
                                    loop {
                                        let _e854 = phi_1280_;
                                        let _e856 = phi_1283_;
                                        local_10 = _e856;
                                        if (_e854.member < _e854.member_1) {
                                            phi_1281_ = type_9((_e854.member + 1u), _e854.member_1);
                                            phi_1306_ = type_9(1u, _e854.member);
                                        } else {
                                            phi_1281_ = _e854;
                                            phi_1306_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e868 = phi_1281_;
                                        let _e870 = phi_1306_;
                                        if (bitcast<i32>(_e870.member) != 0i) {
                                            let _e874 = (0.000000059604645f * 0.5f);
                                            if (_e856.member[0] < 0f) {
                                                phi_1326_ = -(_e856.member[0]);
                                            } else {
                                                phi_1326_ = _e856.member[0];
                                            }
                                            let _e885 = phi_1326_;
                                            let _e886 = (_e885 > _e874);
                                            if (_e856.member[1] < 0f) {
                                                phi_1333_ = -(_e856.member[1]);
                                            } else {
                                                phi_1333_ = _e856.member[1];
                                            }
                                            let _e890 = phi_1333_;
                                            let _e891 = (_e890 > _e874);
                                            if _e886 {
                                                if _e891 {
                                                    let _e894 = ((_e856.member_1[1] - _e856.member_1[0]) / (_e856.member[0] * 2f));
                                                    let _e896 = ((_e894 * _e894) + 1f);
                                                    if (_e896 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e896 > 0f) {
                                                            phi_1359_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_1359_ = 0f;
                                                        }
                                                        let _e949 = phi_1359_;
                                                        phi_1423_ = _e949;
                                                    } else {
                                                        phi_1366_ = type_14(0i, 5i);
                                                        phi_1369_ = bitcast<f32>(((bitcast<u32>(_e896) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e904 = phi_1366_;
                                                            let _e906 = phi_1369_;
                                                            local_1 = _e906;
                                                            if (_e904.member < _e904.member_1) {
                                                                let _e913 = (_e904.member + 1i);
                                                                if ((false == (_e913 > _e904.member)) != false) {
                                                                    phi_1390_ = true;
                                                                } else {
                                                                    phi_1390_ = false;
                                                                }
                                                                let _e918 = phi_1390_;
                                                                if _e918 {
                                                                    phi_1396_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_1396_ = type_15(1u, _e913);
                                                                }
                                                                let _e923 = phi_1396_;
                                                                phi_1367_ = type_14(_e923.member_1, _e904.member_1);
                                                                phi_1410_ = type_15(1u, _e904.member);
                                                            } else {
                                                                phi_1367_ = _e904;
                                                                phi_1410_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e929 = phi_1367_;
                                                            let _e931 = phi_1410_;
                                                            let _e934 = (bitcast<i32>(_e931.member) != 0i);
                                                            if _e934 {
                                                                phi_1370_ = (0.5f * (_e906 + (_e896 / _e906)));
                                                            } else {
                                                                phi_1370_ = f32();
                                                            }
                                                            let _e939 = phi_1370_;
                                                            continue;
                                                            continuing {
                                                                phi_1366_ = _e929;
                                                                phi_1369_ = _e939;
                                                                break if !(_e934);
                                                            }
                                                        }
                                                        let _e944 = local_1;
                                                        phi_1423_ = (_e944 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e951 = phi_1423_;
                                                    if (_e894 > 0f) {
                                                        phi_1430_ = (_e894 + _e951);
                                                    } else {
                                                        phi_1430_ = (_e894 - _e951);
                                                    }
                                                    let _e956 = phi_1430_;
                                                    let _e959 = (_e856.member_1[2] - (_e856.member_1[0] - (_e856.member[0] / _e956)));
                                                    let _e962 = ((_e959 * _e959) + (_e856.member[1] * _e856.member[1]));
                                                    if (_e962 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e962 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e962 > 0f) {
                                                                phi_1457_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1457_ = 0f;
                                                            }
                                                            let _e1019 = phi_1457_;
                                                            phi_1521_ = _e1019;
                                                        } else {
                                                            phi_1464_ = type_14(0i, 5i);
                                                            phi_1467_ = bitcast<f32>(((bitcast<u32>(_e962) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e974 = phi_1464_;
                                                                let _e976 = phi_1467_;
                                                                local_2 = _e976;
                                                                if (_e974.member < _e974.member_1) {
                                                                    let _e983 = (_e974.member + 1i);
                                                                    if ((false == (_e983 > _e974.member)) != false) {
                                                                        phi_1488_ = true;
                                                                    } else {
                                                                        phi_1488_ = false;
                                                                    }
                                                                    let _e988 = phi_1488_;
                                                                    if _e988 {
                                                                        phi_1494_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1494_ = type_15(1u, _e983);
                                                                    }
                                                                    let _e993 = phi_1494_;
                                                                    phi_1465_ = type_14(_e993.member_1, _e974.member_1);
                                                                    phi_1508_ = type_15(1u, _e974.member);
                                                                } else {
                                                                    phi_1465_ = _e974;
                                                                    phi_1508_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e999 = phi_1465_;
                                                                let _e1001 = phi_1508_;
                                                                let _e1004 = (bitcast<i32>(_e1001.member) != 0i);
                                                                if _e1004 {
                                                                    phi_1468_ = (0.5f * (_e976 + (_e962 / _e976)));
                                                                } else {
                                                                    phi_1468_ = f32();
                                                                }
                                                                let _e1009 = phi_1468_;
                                                                continue;
                                                                continuing {
                                                                    phi_1464_ = _e999;
                                                                    phi_1467_ = _e1009;
                                                                    break if !(_e1004);
                                                                }
                                                            }
                                                            let _e1014 = local_2;
                                                            phi_1521_ = (_e1014 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1021 = phi_1521_;
                                                        let _e1022 = (_e959 / _e1021);
                                                        let _e1023 = (_e856.member[1] / _e1021);
                                                        let _e1028 = (1.5f - (((_e1022 * _e1022) + (_e1023 * _e1023)) * 0.5f));
                                                        phi_1533_ = type_34((_e1022 * _e1028), (_e1023 * _e1028));
                                                    } else {
                                                        phi_1533_ = type_34(1f, 0f);
                                                    }
                                                    let _e1033 = phi_1533_;
                                                    let _e1050 = (((_e856.member_1[1] - _e856.member_1[2]) * _e1033.member_1) + ((_e1033.member * _e856.member[1]) * 2f));
                                                    let _e1052 = (_e856.member_1[1] - (_e1033.member_1 * _e1050));
                                                    let _e1056 = ((_e1033.member * _e1050) - _e856.member[1]);
                                                    let _e1069 = ((_e856.member_2[1][0] * _e1033.member) - (_e856.member_2[2][0] * _e1033.member_1));
                                                    let _e1070 = ((_e856.member_2[1][1] * _e1033.member) - (_e856.member_2[2][1] * _e1033.member_1));
                                                    let _e1071 = ((_e856.member_2[1][2] * _e1033.member) - (_e856.member_2[2][2] * _e1033.member_1));
                                                    let _e1088 = (_e1033.member * _e856.member[0]);
                                                    let _e1089 = (_e1033.member_1 * _e856.member[0]);
                                                    let _e1092 = ((_e1056 * _e1056) + (_e1089 * _e1089));
                                                    if (_e1092 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1092 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1092 > 0f) {
                                                                phi_1622_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1622_ = 0f;
                                                            }
                                                            let _e1149 = phi_1622_;
                                                            phi_1686_ = _e1149;
                                                        } else {
                                                            phi_1629_ = type_14(0i, 5i);
                                                            phi_1632_ = bitcast<f32>(((bitcast<u32>(_e1092) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1104 = phi_1629_;
                                                                let _e1106 = phi_1632_;
                                                                local_3 = _e1106;
                                                                if (_e1104.member < _e1104.member_1) {
                                                                    let _e1113 = (_e1104.member + 1i);
                                                                    if ((false == (_e1113 > _e1104.member)) != false) {
                                                                        phi_1653_ = true;
                                                                    } else {
                                                                        phi_1653_ = false;
                                                                    }
                                                                    let _e1118 = phi_1653_;
                                                                    if _e1118 {
                                                                        phi_1659_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1659_ = type_15(1u, _e1113);
                                                                    }
                                                                    let _e1123 = phi_1659_;
                                                                    phi_1630_ = type_14(_e1123.member_1, _e1104.member_1);
                                                                    phi_1673_ = type_15(1u, _e1104.member);
                                                                } else {
                                                                    phi_1630_ = _e1104;
                                                                    phi_1673_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1129 = phi_1630_;
                                                                let _e1131 = phi_1673_;
                                                                let _e1134 = (bitcast<i32>(_e1131.member) != 0i);
                                                                if _e1134 {
                                                                    phi_1633_ = (0.5f * (_e1106 + (_e1092 / _e1106)));
                                                                } else {
                                                                    phi_1633_ = f32();
                                                                }
                                                                let _e1139 = phi_1633_;
                                                                continue;
                                                                continuing {
                                                                    phi_1629_ = _e1129;
                                                                    phi_1632_ = _e1139;
                                                                    break if !(_e1134);
                                                                }
                                                            }
                                                            let _e1144 = local_3;
                                                            phi_1686_ = (_e1144 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1151 = phi_1686_;
                                                        let _e1152 = (_e1056 / _e1151);
                                                        let _e1153 = (_e1089 / _e1151);
                                                        let _e1158 = (1.5f - (((_e1152 * _e1152) + (_e1153 * _e1153)) * 0.5f));
                                                        phi_1698_ = type_34((_e1152 * _e1158), (_e1153 * _e1158));
                                                    } else {
                                                        phi_1698_ = type_34(1f, 0f);
                                                    }
                                                    let _e1163 = phi_1698_;
                                                    let _e1173 = (((_e856.member_1[0] - _e1052) * _e1163.member_1) + ((_e1163.member * _e1088) * 2f));
                                                    phi_1765_ = type_36(array<f32, 2>(((_e1163.member * _e1173) - _e1088), ((_e1163.member_1 * _e1089) + (_e1163.member * _e1056))), array<f32, 3>((_e856.member_1[0] - (_e1163.member_1 * _e1173)), (_e1052 + (_e1163.member_1 * _e1173)), (_e856.member_1[2] + (_e1033.member_1 * _e1050))), array<array<f32, 3>, 3>(array<f32, 3>(((_e856.member_2[0][0] * _e1163.member) - (_e1069 * _e1163.member_1)), ((_e856.member_2[0][1] * _e1163.member) - (_e1070 * _e1163.member_1)), ((_e856.member_2[0][2] * _e1163.member) - (_e1071 * _e1163.member_1))), array<f32, 3>(((_e856.member_2[0][0] * _e1163.member_1) + (_e1069 * _e1163.member)), ((_e856.member_2[0][1] * _e1163.member_1) + (_e1070 * _e1163.member)), ((_e856.member_2[0][2] * _e1163.member_1) + (_e1071 * _e1163.member))), array<f32, 3>(((_e856.member_2[1][0] * _e1033.member_1) + (_e856.member_2[2][0] * _e1033.member)), ((_e856.member_2[1][1] * _e1033.member_1) + (_e856.member_2[2][1] * _e1033.member)), ((_e856.member_2[1][2] * _e1033.member_1) + (_e856.member_2[2][2] * _e1033.member)))));
                                                    phi_1766_ = false;
                                                } else {
                                                    phi_1765_ = type_36();
                                                    phi_1766_ = true;
                                                }
                                                let _e1211 = phi_1765_;
                                                let _e1213 = phi_1766_;
                                                phi_1767_ = _e1211;
                                                phi_1768_ = _e1213;
                                            } else {
                                                phi_1767_ = type_36();
                                                phi_1768_ = true;
                                            }
                                            let _e1215 = phi_1767_;
                                            let _e1217 = phi_1768_;
                                            if _e1217 {
                                                if _e886 {
                                                    let _e1461 = ((_e856.member_1[1] - _e856.member_1[0]) / (_e856.member[0] * 2f));
                                                    let _e1463 = ((_e1461 * _e1461) + 1f);
                                                    if (_e1463 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e1463 > 0f) {
                                                            phi_1793_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_1793_ = 0f;
                                                        }
                                                        let _e1516 = phi_1793_;
                                                        phi_1857_ = _e1516;
                                                    } else {
                                                        phi_1800_ = type_14(0i, 5i);
                                                        phi_1803_ = bitcast<f32>(((bitcast<u32>(_e1463) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1471 = phi_1800_;
                                                            let _e1473 = phi_1803_;
                                                            local_6 = _e1473;
                                                            if (_e1471.member < _e1471.member_1) {
                                                                let _e1480 = (_e1471.member + 1i);
                                                                if ((false == (_e1480 > _e1471.member)) != false) {
                                                                    phi_1824_ = true;
                                                                } else {
                                                                    phi_1824_ = false;
                                                                }
                                                                let _e1485 = phi_1824_;
                                                                if _e1485 {
                                                                    phi_1830_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_1830_ = type_15(1u, _e1480);
                                                                }
                                                                let _e1490 = phi_1830_;
                                                                phi_1801_ = type_14(_e1490.member_1, _e1471.member_1);
                                                                phi_1844_ = type_15(1u, _e1471.member);
                                                            } else {
                                                                phi_1801_ = _e1471;
                                                                phi_1844_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e1496 = phi_1801_;
                                                            let _e1498 = phi_1844_;
                                                            let _e1501 = (bitcast<i32>(_e1498.member) != 0i);
                                                            if _e1501 {
                                                                phi_1804_ = (0.5f * (_e1473 + (_e1463 / _e1473)));
                                                            } else {
                                                                phi_1804_ = f32();
                                                            }
                                                            let _e1506 = phi_1804_;
                                                            continue;
                                                            continuing {
                                                                phi_1800_ = _e1496;
                                                                phi_1803_ = _e1506;
                                                                break if !(_e1501);
                                                            }
                                                        }
                                                        let _e1511 = local_6;
                                                        phi_1857_ = (_e1511 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1518 = phi_1857_;
                                                    if (_e1461 > 0f) {
                                                        phi_1864_ = (_e1461 + _e1518);
                                                    } else {
                                                        phi_1864_ = (_e1461 - _e1518);
                                                    }
                                                    let _e1523 = phi_1864_;
                                                    let _e1526 = (_e856.member_1[1] - (_e856.member_1[0] - (_e856.member[0] / _e1523)));
                                                    let _e1529 = ((_e1526 * _e1526) + (_e856.member[0] * _e856.member[0]));
                                                    if (_e1529 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1529 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1529 > 0f) {
                                                                phi_1891_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_1891_ = 0f;
                                                            }
                                                            let _e1586 = phi_1891_;
                                                            phi_1955_ = _e1586;
                                                        } else {
                                                            phi_1898_ = type_14(0i, 5i);
                                                            phi_1901_ = bitcast<f32>(((bitcast<u32>(_e1529) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1541 = phi_1898_;
                                                                let _e1543 = phi_1901_;
                                                                local_7 = _e1543;
                                                                if (_e1541.member < _e1541.member_1) {
                                                                    let _e1550 = (_e1541.member + 1i);
                                                                    if ((false == (_e1550 > _e1541.member)) != false) {
                                                                        phi_1922_ = true;
                                                                    } else {
                                                                        phi_1922_ = false;
                                                                    }
                                                                    let _e1555 = phi_1922_;
                                                                    if _e1555 {
                                                                        phi_1928_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_1928_ = type_15(1u, _e1550);
                                                                    }
                                                                    let _e1560 = phi_1928_;
                                                                    phi_1899_ = type_14(_e1560.member_1, _e1541.member_1);
                                                                    phi_1942_ = type_15(1u, _e1541.member);
                                                                } else {
                                                                    phi_1899_ = _e1541;
                                                                    phi_1942_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1566 = phi_1899_;
                                                                let _e1568 = phi_1942_;
                                                                let _e1571 = (bitcast<i32>(_e1568.member) != 0i);
                                                                if _e1571 {
                                                                    phi_1902_ = (0.5f * (_e1543 + (_e1529 / _e1543)));
                                                                } else {
                                                                    phi_1902_ = f32();
                                                                }
                                                                let _e1576 = phi_1902_;
                                                                continue;
                                                                continuing {
                                                                    phi_1898_ = _e1566;
                                                                    phi_1901_ = _e1576;
                                                                    break if !(_e1571);
                                                                }
                                                            }
                                                            let _e1581 = local_7;
                                                            phi_1955_ = (_e1581 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1588 = phi_1955_;
                                                        let _e1589 = (_e1526 / _e1588);
                                                        let _e1590 = (_e856.member[0] / _e1588);
                                                        let _e1595 = (1.5f - (((_e1589 * _e1589) + (_e1590 * _e1590)) * 0.5f));
                                                        phi_1967_ = type_34((_e1589 * _e1595), (_e1590 * _e1595));
                                                    } else {
                                                        phi_1967_ = type_34(1f, 0f);
                                                    }
                                                    let _e1600 = phi_1967_;
                                                    let _e1617 = (((_e856.member_1[0] - _e856.member_1[1]) * _e1600.member_1) + ((_e1600.member * _e856.member[0]) * 2f));
                                                    let _e1619 = (_e856.member_1[0] - (_e1600.member_1 * _e1617));
                                                    let _e1621 = (_e856.member_1[1] + (_e1600.member_1 * _e1617));
                                                    let _e1630 = type_36(_e856.member, array<f32, 3>(_e1619, _e856.member_1[1], _e856.member_1[2]), _e856.member_2);
                                                    let _e1637 = type_36(_e1630.member, array<f32, 3>(_e1630.member_1[0], _e1621, _e1630.member_1[2]), _e1630.member_2);
                                                    let _e1641 = type_36(_e1637.member, array<f32, 3>(_e1619, _e1621, _e856.member_1[2]), _e1637.member_2);
                                                    let _e1647 = type_36(array<f32, 2>(((_e1600.member * _e1617) - _e856.member[0]), _e1641.member[1]), _e1641.member_1, _e1641.member_2);
                                                    let _e1663 = array<f32, 3>(((_e856.member_2[0][0] * _e1600.member) - (_e856.member_2[1][0] * _e1600.member_1)), ((_e856.member_2[0][1] * _e1600.member) - (_e856.member_2[1][1] * _e1600.member_1)), ((_e856.member_2[0][2] * _e1600.member) - (_e856.member_2[1][2] * _e1600.member_1)));
                                                    let _e1679 = array<f32, 3>(((_e856.member_2[0][0] * _e1600.member_1) + (_e856.member_2[1][0] * _e1600.member)), ((_e856.member_2[0][1] * _e1600.member_1) + (_e856.member_2[1][1] * _e1600.member)), ((_e856.member_2[0][2] * _e1600.member_1) + (_e856.member_2[1][2] * _e1600.member)));
                                                    let _e1686 = type_36(_e1647.member, _e1647.member_1, array<array<f32, 3>, 3>(_e1663, _e1647.member_2[1], _e1647.member_2[2]));
                                                    let _e1693 = type_36(_e1686.member, _e1686.member_1, array<array<f32, 3>, 3>(_e1686.member_2[0], _e1679, _e1686.member_2[2]));
                                                    phi_2287_ = type_36(_e1693.member, _e1693.member_1, array<array<f32, 3>, 3>(_e1663, _e1679, _e856.member_2[2]));
                                                } else {
                                                    if _e891 {
                                                        let _e1220 = ((_e856.member_1[2] - _e856.member_1[1]) / (_e856.member[1] * 2f));
                                                        let _e1222 = ((_e1220 * _e1220) + 1f);
                                                        if (_e1222 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e1222 > 0f) {
                                                                phi_2050_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_2050_ = 0f;
                                                            }
                                                            let _e1275 = phi_2050_;
                                                            phi_2114_ = _e1275;
                                                        } else {
                                                            phi_2057_ = type_14(0i, 5i);
                                                            phi_2060_ = bitcast<f32>(((bitcast<u32>(_e1222) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1230 = phi_2057_;
                                                                let _e1232 = phi_2060_;
                                                                local_4 = _e1232;
                                                                if (_e1230.member < _e1230.member_1) {
                                                                    let _e1239 = (_e1230.member + 1i);
                                                                    if ((false == (_e1239 > _e1230.member)) != false) {
                                                                        phi_2081_ = true;
                                                                    } else {
                                                                        phi_2081_ = false;
                                                                    }
                                                                    let _e1244 = phi_2081_;
                                                                    if _e1244 {
                                                                        phi_2087_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_2087_ = type_15(1u, _e1239);
                                                                    }
                                                                    let _e1249 = phi_2087_;
                                                                    phi_2058_ = type_14(_e1249.member_1, _e1230.member_1);
                                                                    phi_2101_ = type_15(1u, _e1230.member);
                                                                } else {
                                                                    phi_2058_ = _e1230;
                                                                    phi_2101_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e1255 = phi_2058_;
                                                                let _e1257 = phi_2101_;
                                                                let _e1260 = (bitcast<i32>(_e1257.member) != 0i);
                                                                if _e1260 {
                                                                    phi_2061_ = (0.5f * (_e1232 + (_e1222 / _e1232)));
                                                                } else {
                                                                    phi_2061_ = f32();
                                                                }
                                                                let _e1265 = phi_2061_;
                                                                continue;
                                                                continuing {
                                                                    phi_2057_ = _e1255;
                                                                    phi_2060_ = _e1265;
                                                                    break if !(_e1260);
                                                                }
                                                            }
                                                            let _e1270 = local_4;
                                                            phi_2114_ = (_e1270 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1277 = phi_2114_;
                                                        if (_e1220 > 0f) {
                                                            phi_2121_ = (_e1220 + _e1277);
                                                        } else {
                                                            phi_2121_ = (_e1220 - _e1277);
                                                        }
                                                        let _e1282 = phi_2121_;
                                                        let _e1285 = (_e856.member_1[2] - (_e856.member_1[1] - (_e856.member[1] / _e1282)));
                                                        let _e1288 = ((_e1285 * _e1285) + (_e856.member[1] * _e856.member[1]));
                                                        if (_e1288 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                            if (_e1288 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e1288 > 0f) {
                                                                    phi_2148_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_2148_ = 0f;
                                                                }
                                                                let _e1345 = phi_2148_;
                                                                phi_2212_ = _e1345;
                                                            } else {
                                                                phi_2155_ = type_14(0i, 5i);
                                                                phi_2158_ = bitcast<f32>(((bitcast<u32>(_e1288) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e1300 = phi_2155_;
                                                                    let _e1302 = phi_2158_;
                                                                    local_5 = _e1302;
                                                                    if (_e1300.member < _e1300.member_1) {
                                                                        let _e1309 = (_e1300.member + 1i);
                                                                        if ((false == (_e1309 > _e1300.member)) != false) {
                                                                            phi_2179_ = true;
                                                                        } else {
                                                                            phi_2179_ = false;
                                                                        }
                                                                        let _e1314 = phi_2179_;
                                                                        if _e1314 {
                                                                            phi_2185_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_2185_ = type_15(1u, _e1309);
                                                                        }
                                                                        let _e1319 = phi_2185_;
                                                                        phi_2156_ = type_14(_e1319.member_1, _e1300.member_1);
                                                                        phi_2199_ = type_15(1u, _e1300.member);
                                                                    } else {
                                                                        phi_2156_ = _e1300;
                                                                        phi_2199_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e1325 = phi_2156_;
                                                                    let _e1327 = phi_2199_;
                                                                    let _e1330 = (bitcast<i32>(_e1327.member) != 0i);
                                                                    if _e1330 {
                                                                        phi_2159_ = (0.5f * (_e1302 + (_e1288 / _e1302)));
                                                                    } else {
                                                                        phi_2159_ = f32();
                                                                    }
                                                                    let _e1335 = phi_2159_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2155_ = _e1325;
                                                                        phi_2158_ = _e1335;
                                                                        break if !(_e1330);
                                                                    }
                                                                }
                                                                let _e1340 = local_5;
                                                                phi_2212_ = (_e1340 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e1347 = phi_2212_;
                                                            let _e1348 = (_e1285 / _e1347);
                                                            let _e1349 = (_e856.member[1] / _e1347);
                                                            let _e1354 = (1.5f - (((_e1348 * _e1348) + (_e1349 * _e1349)) * 0.5f));
                                                            phi_2224_ = type_34((_e1348 * _e1354), (_e1349 * _e1354));
                                                        } else {
                                                            phi_2224_ = type_34(1f, 0f);
                                                        }
                                                        let _e1359 = phi_2224_;
                                                        let _e1376 = (((_e856.member_1[1] - _e856.member_1[2]) * _e1359.member_1) + ((_e1359.member * _e856.member[1]) * 2f));
                                                        let _e1378 = (_e856.member_1[1] - (_e1359.member_1 * _e1376));
                                                        let _e1389 = type_36(_e856.member, array<f32, 3>(_e856.member_1[0], _e856.member_1[1], _e856.member_1[2]), _e856.member_2);
                                                        let _e1396 = type_36(_e1389.member, array<f32, 3>(_e1389.member_1[0], _e1378, _e1389.member_1[2]), _e1389.member_2);
                                                        let _e1400 = type_36(_e1396.member, array<f32, 3>(_e856.member_1[0], _e1378, (_e856.member_1[2] + (_e1359.member_1 * _e1376))), _e1396.member_2);
                                                        let _e1406 = type_36(array<f32, 2>(_e1400.member[0], ((_e1359.member * _e1376) - _e856.member[1])), _e1400.member_1, _e1400.member_2);
                                                        let _e1422 = array<f32, 3>(((_e856.member_2[1][0] * _e1359.member) - (_e856.member_2[2][0] * _e1359.member_1)), ((_e856.member_2[1][1] * _e1359.member) - (_e856.member_2[2][1] * _e1359.member_1)), ((_e856.member_2[1][2] * _e1359.member) - (_e856.member_2[2][2] * _e1359.member_1)));
                                                        let _e1445 = type_36(_e1406.member, _e1406.member_1, array<array<f32, 3>, 3>(_e856.member_2[0], _e1406.member_2[1], _e1406.member_2[2]));
                                                        let _e1452 = type_36(_e1445.member, _e1445.member_1, array<array<f32, 3>, 3>(_e1445.member_2[0], _e1422, _e1445.member_2[2]));
                                                        phi_2286_ = type_36(_e1452.member, _e1452.member_1, array<array<f32, 3>, 3>(_e856.member_2[0], _e1422, array<f32, 3>(((_e856.member_2[1][0] * _e1359.member_1) + (_e856.member_2[2][0] * _e1359.member)), ((_e856.member_2[1][1] * _e1359.member_1) + (_e856.member_2[2][1] * _e1359.member)), ((_e856.member_2[1][2] * _e1359.member_1) + (_e856.member_2[2][2] * _e1359.member)))));
                                                    } else {
                                                        phi_2286_ = _e856;
                                                    }
                                                    let _e1458 = phi_2286_;
                                                    phi_2287_ = _e1458;
                                                }
                                                let _e1699 = phi_2287_;
                                                phi_2288_ = _e1699;
                                            } else {
                                                phi_2288_ = _e1215;
                                            }
                                            let _e1701 = phi_2288_;
                                            if _e886 {
                                                phi_2292_ = true;
                                            } else {
                                                phi_2292_ = _e891;
                                            }
                                            let _e1703 = phi_2292_;
                                            if _e1703 {
                                                phi_2296_ = false;
                                            } else {
                                                phi_2296_ = true;
                                            }
                                            let _e1705 = phi_2296_;
                                            phi_1284_ = _e1701;
                                            phi_2297_ = _e1701;
                                            phi_2298_ = _e1703;
                                            phi_2299_ = _e1705;
                                        } else {
                                            phi_1284_ = type_36();
                                            phi_2297_ = type_36();
                                            phi_2298_ = false;
                                            phi_2299_ = false;
                                        }
                                        let _e1707 = phi_1284_;
                                        let _e1709 = phi_2297_;
                                        let _e1711 = phi_2298_;
                                        let _e1713 = phi_2299_;
                                        local_8 = _e1713;
                                        local_9 = _e1709;
                                        continue;
                                        continuing {
                                            phi_1280_ = _e868;
                                            phi_1283_ = _e1707;
                                            break if !(_e1711);
                                        }
                                    }
                                    let _e1716 = local_8;
                                    if _e1716 {
                                        let _e3493 = local_9;
                                        phi_2303_ = _e3493;
                                    } else {
                                        let _e3495 = local_10;
                                        phi_2303_ = _e3495;
                                    }
                                    let _e1718 = phi_2303_;
                                    let _e1722 = (2130706432u - (bitcast<u32>(_e737) & 2139095040u));
                                    if (_e1722 > 8388608u) {
                                        phi_2315_ = _e1722;
                                    } else {
                                        phi_2315_ = 8388608u;
                                    }
                                    let _e1725 = phi_2315_;
                                    let _e1726 = bitcast<f32>(_e1725);
                                    let _e1748 = ((((_e1718.member_2[0][0] * _e1718.member_2[0][0]) + (_e1718.member_2[0][1] * _e1718.member_2[0][1])) + (_e1718.member_2[0][2] * _e1718.member_2[0][2])) - 1f);
                                    let _e1762 = ((((_e1718.member_2[1][0] * _e1718.member_2[1][0]) + (_e1718.member_2[1][1] * _e1718.member_2[1][1])) + (_e1718.member_2[1][2] * _e1718.member_2[1][2])) - 1f);
                                    let _e1776 = ((((_e1718.member_2[2][0] * _e1718.member_2[2][0]) + (_e1718.member_2[2][1] * _e1718.member_2[2][1])) + (_e1718.member_2[2][2] * _e1718.member_2[2][2])) - 1f);
                                    let _e1789 = (((_e1718.member_2[0][0] * _e1718.member_2[1][0]) + (_e1718.member_2[0][1] * _e1718.member_2[1][1])) + (_e1718.member_2[0][2] * _e1718.member_2[1][2]));
                                    let _e1802 = (((_e1718.member_2[0][0] * _e1718.member_2[2][0]) + (_e1718.member_2[0][1] * _e1718.member_2[2][1])) + (_e1718.member_2[0][2] * _e1718.member_2[2][2]));
                                    let _e1815 = (((_e1718.member_2[1][0] * _e1718.member_2[2][0]) + (_e1718.member_2[1][1] * _e1718.member_2[2][1])) + (_e1718.member_2[1][2] * _e1718.member_2[2][2]));
                                    let _e1848 = (_e1718.member_2[0][0] - ((((_e1718.member_2[0][0] * _e1748) + (_e1718.member_2[1][0] * _e1789)) + (_e1718.member_2[2][0] * _e1802)) * 0.5f));
                                    let _e1850 = (_e1718.member_2[0][1] - ((((_e1718.member_2[0][1] * _e1748) + (_e1718.member_2[1][1] * _e1789)) + (_e1718.member_2[2][1] * _e1802)) * 0.5f));
                                    let _e1852 = (_e1718.member_2[0][2] - ((((_e1718.member_2[0][2] * _e1748) + (_e1718.member_2[1][2] * _e1789)) + (_e1718.member_2[2][2] * _e1802)) * 0.5f));
                                    if (_e1848 < 0f) {
                                        phi_2448_ = -(_e1848);
                                    } else {
                                        phi_2448_ = _e1848;
                                    }
                                    let _e1856 = phi_2448_;
                                    if (_e1856 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2454_ = _e1848;
                                    } else {
                                        phi_2454_ = 0f;
                                    }
                                    let _e1860 = phi_2454_;
                                    if (_e1850 < 0f) {
                                        phi_2460_ = -(_e1850);
                                    } else {
                                        phi_2460_ = _e1850;
                                    }
                                    let _e1864 = phi_2460_;
                                    if (_e1864 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2466_ = _e1850;
                                    } else {
                                        phi_2466_ = 0f;
                                    }
                                    let _e1868 = phi_2466_;
                                    if (_e1852 < 0f) {
                                        phi_2472_ = -(_e1852);
                                    } else {
                                        phi_2472_ = _e1852;
                                    }
                                    let _e1872 = phi_2472_;
                                    if (_e1872 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2478_ = _e1852;
                                    } else {
                                        phi_2478_ = 0f;
                                    }
                                    let _e1876 = phi_2478_;
                                    let _e1910 = (_e1718.member_2[1][0] - ((((_e1718.member_2[0][0] * _e1789) + (_e1718.member_2[1][0] * _e1762)) + (_e1718.member_2[2][0] * _e1815)) * 0.5f));
                                    let _e1912 = (_e1718.member_2[1][1] - ((((_e1718.member_2[0][1] * _e1789) + (_e1718.member_2[1][1] * _e1762)) + (_e1718.member_2[2][1] * _e1815)) * 0.5f));
                                    let _e1914 = (_e1718.member_2[1][2] - ((((_e1718.member_2[0][2] * _e1789) + (_e1718.member_2[1][2] * _e1762)) + (_e1718.member_2[2][2] * _e1815)) * 0.5f));
                                    if (_e1910 < 0f) {
                                        phi_2522_ = -(_e1910);
                                    } else {
                                        phi_2522_ = _e1910;
                                    }
                                    let _e1918 = phi_2522_;
                                    if (_e1918 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2528_ = _e1910;
                                    } else {
                                        phi_2528_ = 0f;
                                    }
                                    let _e1922 = phi_2528_;
                                    if (_e1912 < 0f) {
                                        phi_2534_ = -(_e1912);
                                    } else {
                                        phi_2534_ = _e1912;
                                    }
                                    let _e1926 = phi_2534_;
                                    if (_e1926 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2540_ = _e1912;
                                    } else {
                                        phi_2540_ = 0f;
                                    }
                                    let _e1930 = phi_2540_;
                                    if (_e1914 < 0f) {
                                        phi_2546_ = -(_e1914);
                                    } else {
                                        phi_2546_ = _e1914;
                                    }
                                    let _e1934 = phi_2546_;
                                    if (_e1934 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2552_ = _e1914;
                                    } else {
                                        phi_2552_ = 0f;
                                    }
                                    let _e1938 = phi_2552_;
                                    let _e1972 = (_e1718.member_2[2][0] - ((((_e1718.member_2[0][0] * _e1802) + (_e1718.member_2[1][0] * _e1815)) + (_e1718.member_2[2][0] * _e1776)) * 0.5f));
                                    let _e1974 = (_e1718.member_2[2][1] - ((((_e1718.member_2[0][1] * _e1802) + (_e1718.member_2[1][1] * _e1815)) + (_e1718.member_2[2][1] * _e1776)) * 0.5f));
                                    let _e1976 = (_e1718.member_2[2][2] - ((((_e1718.member_2[0][2] * _e1802) + (_e1718.member_2[1][2] * _e1815)) + (_e1718.member_2[2][2] * _e1776)) * 0.5f));
                                    if (_e1972 < 0f) {
                                        phi_2596_ = -(_e1972);
                                    } else {
                                        phi_2596_ = _e1972;
                                    }
                                    let _e1980 = phi_2596_;
                                    if (_e1980 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2602_ = _e1972;
                                    } else {
                                        phi_2602_ = 0f;
                                    }
                                    let _e1984 = phi_2602_;
                                    if (_e1974 < 0f) {
                                        phi_2608_ = -(_e1974);
                                    } else {
                                        phi_2608_ = _e1974;
                                    }
                                    let _e1988 = phi_2608_;
                                    if (_e1988 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2614_ = _e1974;
                                    } else {
                                        phi_2614_ = 0f;
                                    }
                                    let _e1992 = phi_2614_;
                                    if (_e1976 < 0f) {
                                        phi_2620_ = -(_e1976);
                                    } else {
                                        phi_2620_ = _e1976;
                                    }
                                    let _e1996 = phi_2620_;
                                    if (_e1996 > (0.000000059604645f * 0.000000059604645f)) {
                                        phi_2626_ = _e1976;
                                    } else {
                                        phi_2626_ = 0f;
                                    }
                                    let _e2000 = phi_2626_;
                                    let _e2008 = ((((_e1860 * _e1860) + (_e1868 * _e1868)) + (_e1876 * _e1876)) - 1f);
                                    let _e2014 = ((((_e1922 * _e1922) + (_e1930 * _e1930)) + (_e1938 * _e1938)) - 1f);
                                    let _e2020 = ((((_e1984 * _e1984) + (_e1992 * _e1992)) + (_e2000 * _e2000)) - 1f);
                                    let _e2025 = (((_e1860 * _e1922) + (_e1868 * _e1930)) + (_e1876 * _e1938));
                                    let _e2030 = (((_e1860 * _e1984) + (_e1868 * _e1992)) + (_e1876 * _e2000));
                                    let _e2035 = (((_e1922 * _e1984) + (_e1930 * _e1992)) + (_e1938 * _e2000));
                                    if (_e2008 < 0f) {
                                        phi_2667_ = -(_e2008);
                                    } else {
                                        phi_2667_ = _e2008;
                                    }
                                    let _e2039 = phi_2667_;
                                    if (_e2014 < 0f) {
                                        phi_2673_ = -(_e2014);
                                    } else {
                                        phi_2673_ = _e2014;
                                    }
                                    let _e2043 = phi_2673_;
                                    if (_e2039 > _e2043) {
                                        phi_2678_ = _e2039;
                                    } else {
                                        phi_2678_ = _e2043;
                                    }
                                    let _e2046 = phi_2678_;
                                    if (_e2020 < 0f) {
                                        phi_2684_ = -(_e2020);
                                    } else {
                                        phi_2684_ = _e2020;
                                    }
                                    let _e2050 = phi_2684_;
                                    if (_e2046 > _e2050) {
                                        phi_2689_ = _e2046;
                                    } else {
                                        phi_2689_ = _e2050;
                                    }
                                    let _e2053 = phi_2689_;
                                    if (_e2025 < 0f) {
                                        phi_2695_ = -(_e2025);
                                    } else {
                                        phi_2695_ = _e2025;
                                    }
                                    let _e2057 = phi_2695_;
                                    if (_e2030 < 0f) {
                                        phi_2701_ = -(_e2030);
                                    } else {
                                        phi_2701_ = _e2030;
                                    }
                                    let _e2061 = phi_2701_;
                                    if (_e2057 > _e2061) {
                                        phi_2706_ = _e2057;
                                    } else {
                                        phi_2706_ = _e2061;
                                    }
                                    let _e2064 = phi_2706_;
                                    if (_e2035 < 0f) {
                                        phi_2712_ = -(_e2035);
                                    } else {
                                        phi_2712_ = _e2035;
                                    }
                                    let _e2068 = phi_2712_;
                                    if (_e2064 > _e2068) {
                                        phi_2717_ = _e2064;
                                    } else {
                                        phi_2717_ = _e2068;
                                    }
                                    let _e2071 = phi_2717_;
                                    if (_e2053 > _e2071) {
                                        phi_2722_ = _e2053;
                                    } else {
                                        phi_2722_ = _e2071;
                                    }
                                    let _e2074 = phi_2722_;
                                    if (_e2074 <= (0.000000059604645f * (16f - 4f))) {
                                        phi_2733_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1860, _e1868, _e1876), array<f32, 3>(_e1922, _e1930, _e1938), array<f32, 3>(_e1984, _e1992, _e2000));
                                    } else {
                                        phi_2733_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                                    }
                                    let _e2079 = phi_2733_;
                                    phi_2735_ = type_37(array<f32, 3>((_e1718.member_1[0] * _e1726), (_e1718.member_1[1] * _e1726), (_e1718.member_1[2] * _e1726)), _e2079);
                                    phi_2736_ = false;
                                } else {
                                    phi_2735_ = type_37();
                                    phi_2736_ = true;
                                }
                                let _e2082 = phi_2735_;
                                let _e2084 = phi_2736_;
                                phi_2737_ = _e2082;
                                phi_2738_ = _e2084;
                            } else {
                                phi_2737_ = type_37();
                                phi_2738_ = true;
                            }
                            let _e2086 = phi_2737_;
                            let _e2088 = phi_2738_;
                            if _e2088 {
                                phi_2751_ = type_37(array<f32, 3>(_e679, _e683, _e687), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                            } else {
                                phi_2751_ = _e2086;
                            }
                            let _e2092 = phi_2751_;
                            let _e2107 = (((_e293.member_1[0][0] * _e2092.member_1[0][0]) + (_e293.member_1[0][1] * _e2092.member_1[0][1])) + (_e293.member_1[0][2] * _e2092.member_1[0][2]));
                            let _e2120 = (((_e293.member_1[1][0] * _e2092.member_1[0][0]) + (_e293.member_1[1][1] * _e2092.member_1[0][1])) + (_e293.member_1[1][2] * _e2092.member_1[0][2]));
                            let _e2133 = (((_e293.member_1[2][0] * _e2092.member_1[0][0]) + (_e293.member_1[2][1] * _e2092.member_1[0][1])) + (_e293.member_1[2][2] * _e2092.member_1[0][2]));
                            if (_e2107 < 0f) {
                                phi_2796_ = -(_e2107);
                            } else {
                                phi_2796_ = _e2107;
                            }
                            let _e2138 = phi_2796_;
                            if (_e2120 < 0f) {
                                phi_2802_ = -(_e2120);
                            } else {
                                phi_2802_ = _e2120;
                            }
                            let _e2142 = phi_2802_;
                            if (_e2133 < 0f) {
                                phi_2808_ = -(_e2133);
                            } else {
                                phi_2808_ = _e2133;
                            }
                            let _e2146 = phi_2808_;
                            let _e2154 = (((_e2138 * _e293.member_2[0]) + (_e2142 * _e293.member_2[1])) + (_e2146 * _e293.member_2[2]));
                            let _e2168 = (((_e293.member_1[0][0] * _e2092.member_1[1][0]) + (_e293.member_1[0][1] * _e2092.member_1[1][1])) + (_e293.member_1[0][2] * _e2092.member_1[1][2]));
                            let _e2181 = (((_e293.member_1[1][0] * _e2092.member_1[1][0]) + (_e293.member_1[1][1] * _e2092.member_1[1][1])) + (_e293.member_1[1][2] * _e2092.member_1[1][2]));
                            let _e2194 = (((_e293.member_1[2][0] * _e2092.member_1[1][0]) + (_e293.member_1[2][1] * _e2092.member_1[1][1])) + (_e293.member_1[2][2] * _e2092.member_1[1][2]));
                            if (_e2168 < 0f) {
                                phi_2860_ = -(_e2168);
                            } else {
                                phi_2860_ = _e2168;
                            }
                            let _e2199 = phi_2860_;
                            if (_e2181 < 0f) {
                                phi_2866_ = -(_e2181);
                            } else {
                                phi_2866_ = _e2181;
                            }
                            let _e2203 = phi_2866_;
                            if (_e2194 < 0f) {
                                phi_2872_ = -(_e2194);
                            } else {
                                phi_2872_ = _e2194;
                            }
                            let _e2207 = phi_2872_;
                            let _e2215 = (((_e2199 * _e293.member_2[0]) + (_e2203 * _e293.member_2[1])) + (_e2207 * _e293.member_2[2]));
                            let _e2229 = (((_e293.member_1[0][0] * _e2092.member_1[2][0]) + (_e293.member_1[0][1] * _e2092.member_1[2][1])) + (_e293.member_1[0][2] * _e2092.member_1[2][2]));
                            let _e2242 = (((_e293.member_1[1][0] * _e2092.member_1[2][0]) + (_e293.member_1[1][1] * _e2092.member_1[2][1])) + (_e293.member_1[1][2] * _e2092.member_1[2][2]));
                            let _e2255 = (((_e293.member_1[2][0] * _e2092.member_1[2][0]) + (_e293.member_1[2][1] * _e2092.member_1[2][1])) + (_e293.member_1[2][2] * _e2092.member_1[2][2]));
                            if (_e2229 < 0f) {
                                phi_2924_ = -(_e2229);
                            } else {
                                phi_2924_ = _e2229;
                            }
                            let _e2260 = phi_2924_;
                            if (_e2242 < 0f) {
                                phi_2930_ = -(_e2242);
                            } else {
                                phi_2930_ = _e2242;
                            }
                            let _e2264 = phi_2930_;
                            if (_e2255 < 0f) {
                                phi_2936_ = -(_e2255);
                            } else {
                                phi_2936_ = _e2255;
                            }
                            let _e2268 = phi_2936_;
                            let _e2276 = (((_e2260 * _e293.member_2[0]) + (_e2264 * _e293.member_2[1])) + (_e2268 * _e293.member_2[2]));
                            let _e2290 = (((_e413.member_1[0][0] * _e2092.member_1[0][0]) + (_e413.member_1[0][1] * _e2092.member_1[0][1])) + (_e413.member_1[0][2] * _e2092.member_1[0][2]));
                            let _e2303 = (((_e413.member_1[1][0] * _e2092.member_1[0][0]) + (_e413.member_1[1][1] * _e2092.member_1[0][1])) + (_e413.member_1[1][2] * _e2092.member_1[0][2]));
                            let _e2316 = (((_e413.member_1[2][0] * _e2092.member_1[0][0]) + (_e413.member_1[2][1] * _e2092.member_1[0][1])) + (_e413.member_1[2][2] * _e2092.member_1[0][2]));
                            if (_e2290 < 0f) {
                                phi_2988_ = -(_e2290);
                            } else {
                                phi_2988_ = _e2290;
                            }
                            let _e2321 = phi_2988_;
                            if (_e2303 < 0f) {
                                phi_2994_ = -(_e2303);
                            } else {
                                phi_2994_ = _e2303;
                            }
                            let _e2325 = phi_2994_;
                            if (_e2316 < 0f) {
                                phi_3000_ = -(_e2316);
                            } else {
                                phi_3000_ = _e2316;
                            }
                            let _e2329 = phi_3000_;
                            let _e2337 = (((_e2321 * _e413.member_2[0]) + (_e2325 * _e413.member_2[1])) + (_e2329 * _e413.member_2[2]));
                            let _e2351 = (((_e413.member_1[0][0] * _e2092.member_1[1][0]) + (_e413.member_1[0][1] * _e2092.member_1[1][1])) + (_e413.member_1[0][2] * _e2092.member_1[1][2]));
                            let _e2364 = (((_e413.member_1[1][0] * _e2092.member_1[1][0]) + (_e413.member_1[1][1] * _e2092.member_1[1][1])) + (_e413.member_1[1][2] * _e2092.member_1[1][2]));
                            let _e2377 = (((_e413.member_1[2][0] * _e2092.member_1[1][0]) + (_e413.member_1[2][1] * _e2092.member_1[1][1])) + (_e413.member_1[2][2] * _e2092.member_1[1][2]));
                            if (_e2351 < 0f) {
                                phi_3052_ = -(_e2351);
                            } else {
                                phi_3052_ = _e2351;
                            }
                            let _e2382 = phi_3052_;
                            if (_e2364 < 0f) {
                                phi_3058_ = -(_e2364);
                            } else {
                                phi_3058_ = _e2364;
                            }
                            let _e2386 = phi_3058_;
                            if (_e2377 < 0f) {
                                phi_3064_ = -(_e2377);
                            } else {
                                phi_3064_ = _e2377;
                            }
                            let _e2390 = phi_3064_;
                            let _e2398 = (((_e2382 * _e413.member_2[0]) + (_e2386 * _e413.member_2[1])) + (_e2390 * _e413.member_2[2]));
                            let _e2412 = (((_e413.member_1[0][0] * _e2092.member_1[2][0]) + (_e413.member_1[0][1] * _e2092.member_1[2][1])) + (_e413.member_1[0][2] * _e2092.member_1[2][2]));
                            let _e2425 = (((_e413.member_1[1][0] * _e2092.member_1[2][0]) + (_e413.member_1[1][1] * _e2092.member_1[2][1])) + (_e413.member_1[1][2] * _e2092.member_1[2][2]));
                            let _e2438 = (((_e413.member_1[2][0] * _e2092.member_1[2][0]) + (_e413.member_1[2][1] * _e2092.member_1[2][1])) + (_e413.member_1[2][2] * _e2092.member_1[2][2]));
                            if (_e2412 < 0f) {
                                phi_3116_ = -(_e2412);
                            } else {
                                phi_3116_ = _e2412;
                            }
                            let _e2443 = phi_3116_;
                            if (_e2425 < 0f) {
                                phi_3122_ = -(_e2425);
                            } else {
                                phi_3122_ = _e2425;
                            }
                            let _e2447 = phi_3122_;
                            if (_e2438 < 0f) {
                                phi_3128_ = -(_e2438);
                            } else {
                                phi_3128_ = _e2438;
                            }
                            let _e2451 = phi_3128_;
                            let _e2459 = (((_e2443 * _e413.member_2[0]) + (_e2447 * _e413.member_2[1])) + (_e2451 * _e413.member_2[2]));
                            let _e2468 = (((_e2092.member_1[0][0] * _e418) + (_e2092.member_1[0][1] * _e421)) + (_e2092.member_1[0][2] * _e424));
                            let _e2477 = (((_e2092.member_1[1][0] * _e418) + (_e2092.member_1[1][1] * _e421)) + (_e2092.member_1[1][2] * _e424));
                            let _e2486 = (((_e2092.member_1[2][0] * _e418) + (_e2092.member_1[2][1] * _e421)) + (_e2092.member_1[2][2] * _e424));
                            let _e2487 = (_e2154 * -1f);
                            let _e2488 = (_e2215 * -1f);
                            let _e2489 = (_e2276 * -1f);
                            let _e2490 = (_e2468 - _e2337);
                            let _e2491 = (_e2477 - _e2398);
                            let _e2492 = (_e2486 - _e2459);
                            if (_e2487 < _e2490) {
                                phi_3174_ = _e2487;
                            } else {
                                phi_3174_ = _e2490;
                            }
                            let _e2495 = phi_3174_;
                            if (_e2488 < _e2491) {
                                phi_3179_ = _e2488;
                            } else {
                                phi_3179_ = _e2491;
                            }
                            let _e2498 = phi_3179_;
                            if (_e2489 < _e2492) {
                                phi_3184_ = _e2489;
                            } else {
                                phi_3184_ = _e2492;
                            }
                            let _e2501 = phi_3184_;
                            let _e2502 = (_e2468 + _e2337);
                            let _e2503 = (_e2477 + _e2398);
                            let _e2504 = (_e2486 + _e2459);
                            if (_e2154 > _e2502) {
                                phi_3192_ = _e2154;
                            } else {
                                phi_3192_ = _e2502;
                            }
                            let _e2507 = phi_3192_;
                            if (_e2215 > _e2503) {
                                phi_3197_ = _e2215;
                            } else {
                                phi_3197_ = _e2503;
                            }
                            let _e2510 = phi_3197_;
                            if (_e2276 > _e2504) {
                                phi_3202_ = _e2276;
                            } else {
                                phi_3202_ = _e2504;
                            }
                            let _e2513 = phi_3202_;
                            let _e2518 = ((_e2495 + _e2507) * 0.5f);
                            let _e2519 = ((_e2498 + _e2510) * 0.5f);
                            let _e2520 = ((_e2501 + _e2513) * 0.5f);
                            let _e2549 = (_e293.member[0] + (((_e2092.member_1[0][0] * _e2518) + (_e2092.member_1[1][0] * _e2519)) + (_e2092.member_1[2][0] * _e2520)));
                            let _e2551 = (_e293.member[1] + (((_e2092.member_1[0][1] * _e2518) + (_e2092.member_1[1][1] * _e2519)) + (_e2092.member_1[2][1] * _e2520)));
                            let _e2553 = (_e293.member[2] + (((_e2092.member_1[0][2] * _e2518) + (_e2092.member_1[1][2] * _e2519)) + (_e2092.member_1[2][2] * _e2520)));
                            let _e2557 = (_e293.member[0] - _e2549);
                            let _e2559 = (_e293.member[1] - _e2551);
                            let _e2561 = (_e293.member[2] - _e2553);
                            if (_e293.member_2[0] < 0f) {
                                phi_3258_ = -(_e293.member_2[0]);
                            } else {
                                phi_3258_ = _e293.member_2[0];
                            }
                            let _e2567 = phi_3258_;
                            if (_e293.member_2[1] < 0f) {
                                phi_3265_ = -(_e293.member_2[1]);
                            } else {
                                phi_3265_ = _e293.member_2[1];
                            }
                            let _e2572 = phi_3265_;
                            if (_e293.member_2[2] < 0f) {
                                phi_3273_ = -(_e293.member_2[2]);
                            } else {
                                phi_3273_ = _e293.member_2[2];
                            }
                            let _e2578 = phi_3273_;
                            if (_e2557 < 0f) {
                                phi_3282_ = -(_e2557);
                            } else {
                                phi_3282_ = _e2557;
                            }
                            let _e2585 = phi_3282_;
                            if (_e2559 < 0f) {
                                phi_3288_ = -(_e2559);
                            } else {
                                phi_3288_ = _e2559;
                            }
                            let _e2589 = phi_3288_;
                            if (_e2561 < 0f) {
                                phi_3294_ = -(_e2561);
                            } else {
                                phi_3294_ = _e2561;
                            }
                            let _e2593 = phi_3294_;
                            if (_e2092.member_1[0][0] < 0f) {
                                phi_3302_ = -(_e2092.member_1[0][0]);
                            } else {
                                phi_3302_ = _e2092.member_1[0][0];
                            }
                            let _e2599 = phi_3302_;
                            if (_e2092.member_1[0][1] < 0f) {
                                phi_3309_ = -(_e2092.member_1[0][1]);
                            } else {
                                phi_3309_ = _e2092.member_1[0][1];
                            }
                            let _e2604 = phi_3309_;
                            if (_e2092.member_1[0][2] < 0f) {
                                phi_3316_ = -(_e2092.member_1[0][2]);
                            } else {
                                phi_3316_ = _e2092.member_1[0][2];
                            }
                            let _e2609 = phi_3316_;
                            if (_e2092.member_1[1][0] < 0f) {
                                phi_3329_ = -(_e2092.member_1[1][0]);
                            } else {
                                phi_3329_ = _e2092.member_1[1][0];
                            }
                            let _e2620 = phi_3329_;
                            if (_e2092.member_1[1][1] < 0f) {
                                phi_3336_ = -(_e2092.member_1[1][1]);
                            } else {
                                phi_3336_ = _e2092.member_1[1][1];
                            }
                            let _e2625 = phi_3336_;
                            if (_e2092.member_1[1][2] < 0f) {
                                phi_3343_ = -(_e2092.member_1[1][2]);
                            } else {
                                phi_3343_ = _e2092.member_1[1][2];
                            }
                            let _e2630 = phi_3343_;
                            if (_e2092.member_1[2][0] < 0f) {
                                phi_3356_ = -(_e2092.member_1[2][0]);
                            } else {
                                phi_3356_ = _e2092.member_1[2][0];
                            }
                            let _e2641 = phi_3356_;
                            if (_e2092.member_1[2][1] < 0f) {
                                phi_3363_ = -(_e2092.member_1[2][1]);
                            } else {
                                phi_3363_ = _e2092.member_1[2][1];
                            }
                            let _e2646 = phi_3363_;
                            if (_e2092.member_1[2][2] < 0f) {
                                phi_3370_ = -(_e2092.member_1[2][2]);
                            } else {
                                phi_3370_ = _e2092.member_1[2][2];
                            }
                            let _e2651 = phi_3370_;
                            let _e2657 = (0.000000059604645f * 8f);
                            let _e2662 = ((((_e2567 + _e2572) + _e2578) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2674 = (((_e2092.member_1[0][0] * _e2557) + (_e2092.member_1[0][1] * _e2559)) + (_e2092.member_1[0][2] * _e2561));
                            let _e2683 = (((_e2092.member_1[1][0] * _e2557) + (_e2092.member_1[1][1] * _e2559)) + (_e2092.member_1[1][2] * _e2561));
                            let _e2692 = (((_e2092.member_1[2][0] * _e2557) + (_e2092.member_1[2][1] * _e2559)) + (_e2092.member_1[2][2] * _e2561));
                            if (_e2674 < 0f) {
                                phi_3417_ = -(_e2674);
                            } else {
                                phi_3417_ = _e2674;
                            }
                            let _e2696 = phi_3417_;
                            if (_e2683 < 0f) {
                                phi_3423_ = -(_e2683);
                            } else {
                                phi_3423_ = _e2683;
                            }
                            let _e2700 = phi_3423_;
                            if (_e2692 < 0f) {
                                phi_3429_ = -(_e2692);
                            } else {
                                phi_3429_ = _e2692;
                            }
                            let _e2704 = phi_3429_;
                            let _e2718 = (((_e293.member_1[0][0] * _e2092.member_1[0][0]) + (_e293.member_1[0][1] * _e2092.member_1[0][1])) + (_e293.member_1[0][2] * _e2092.member_1[0][2]));
                            let _e2731 = (((_e293.member_1[1][0] * _e2092.member_1[0][0]) + (_e293.member_1[1][1] * _e2092.member_1[0][1])) + (_e293.member_1[1][2] * _e2092.member_1[0][2]));
                            let _e2744 = (((_e293.member_1[2][0] * _e2092.member_1[0][0]) + (_e293.member_1[2][1] * _e2092.member_1[0][1])) + (_e293.member_1[2][2] * _e2092.member_1[0][2]));
                            if (_e2718 < 0f) {
                                phi_3473_ = -(_e2718);
                            } else {
                                phi_3473_ = _e2718;
                            }
                            let _e2749 = phi_3473_;
                            if (_e2731 < 0f) {
                                phi_3479_ = -(_e2731);
                            } else {
                                phi_3479_ = _e2731;
                            }
                            let _e2753 = phi_3479_;
                            if (_e2744 < 0f) {
                                phi_3485_ = -(_e2744);
                            } else {
                                phi_3485_ = _e2744;
                            }
                            let _e2757 = phi_3485_;
                            let _e2779 = (((_e293.member_1[0][0] * _e2092.member_1[1][0]) + (_e293.member_1[0][1] * _e2092.member_1[1][1])) + (_e293.member_1[0][2] * _e2092.member_1[1][2]));
                            let _e2792 = (((_e293.member_1[1][0] * _e2092.member_1[1][0]) + (_e293.member_1[1][1] * _e2092.member_1[1][1])) + (_e293.member_1[1][2] * _e2092.member_1[1][2]));
                            let _e2805 = (((_e293.member_1[2][0] * _e2092.member_1[1][0]) + (_e293.member_1[2][1] * _e2092.member_1[1][1])) + (_e293.member_1[2][2] * _e2092.member_1[1][2]));
                            if (_e2779 < 0f) {
                                phi_3537_ = -(_e2779);
                            } else {
                                phi_3537_ = _e2779;
                            }
                            let _e2810 = phi_3537_;
                            if (_e2792 < 0f) {
                                phi_3543_ = -(_e2792);
                            } else {
                                phi_3543_ = _e2792;
                            }
                            let _e2814 = phi_3543_;
                            if (_e2805 < 0f) {
                                phi_3549_ = -(_e2805);
                            } else {
                                phi_3549_ = _e2805;
                            }
                            let _e2818 = phi_3549_;
                            let _e2840 = (((_e293.member_1[0][0] * _e2092.member_1[2][0]) + (_e293.member_1[0][1] * _e2092.member_1[2][1])) + (_e293.member_1[0][2] * _e2092.member_1[2][2]));
                            let _e2853 = (((_e293.member_1[1][0] * _e2092.member_1[2][0]) + (_e293.member_1[1][1] * _e2092.member_1[2][1])) + (_e293.member_1[1][2] * _e2092.member_1[2][2]));
                            let _e2866 = (((_e293.member_1[2][0] * _e2092.member_1[2][0]) + (_e293.member_1[2][1] * _e2092.member_1[2][1])) + (_e293.member_1[2][2] * _e2092.member_1[2][2]));
                            if (_e2840 < 0f) {
                                phi_3601_ = -(_e2840);
                            } else {
                                phi_3601_ = _e2840;
                            }
                            let _e2871 = phi_3601_;
                            if (_e2853 < 0f) {
                                phi_3607_ = -(_e2853);
                            } else {
                                phi_3607_ = _e2853;
                            }
                            let _e2875 = phi_3607_;
                            if (_e2866 < 0f) {
                                phi_3613_ = -(_e2866);
                            } else {
                                phi_3613_ = _e2866;
                            }
                            let _e2879 = phi_3613_;
                            let _e2891 = ((_e2696 + (((_e2749 * _e293.member_2[0]) + (_e2753 * _e293.member_2[1])) + (_e2757 * _e293.member_2[2]))) + (((((_e2599 * _e2585) + (_e2604 * _e2589)) + (_e2609 * _e2593)) * _e2657) + _e2662));
                            let _e2892 = ((_e2700 + (((_e2810 * _e293.member_2[0]) + (_e2814 * _e293.member_2[1])) + (_e2818 * _e293.member_2[2]))) + (((((_e2620 * _e2585) + (_e2625 * _e2589)) + (_e2630 * _e2593)) * _e2657) + _e2662));
                            let _e2893 = ((_e2704 + (((_e2871 * _e293.member_2[0]) + (_e2875 * _e293.member_2[1])) + (_e2879 * _e293.member_2[2]))) + (((((_e2641 * _e2585) + (_e2646 * _e2589)) + (_e2651 * _e2593)) * _e2657) + _e2662));
                            let _e2896 = (_e413.member[0] - _e2549);
                            let _e2898 = (_e413.member[1] - _e2551);
                            let _e2900 = (_e413.member[2] - _e2553);
                            if (_e413.member_2[0] < 0f) {
                                phi_3642_ = -(_e413.member_2[0]);
                            } else {
                                phi_3642_ = _e413.member_2[0];
                            }
                            let _e2906 = phi_3642_;
                            if (_e413.member_2[1] < 0f) {
                                phi_3649_ = -(_e413.member_2[1]);
                            } else {
                                phi_3649_ = _e413.member_2[1];
                            }
                            let _e2911 = phi_3649_;
                            if (_e413.member_2[2] < 0f) {
                                phi_3657_ = -(_e413.member_2[2]);
                            } else {
                                phi_3657_ = _e413.member_2[2];
                            }
                            let _e2917 = phi_3657_;
                            if (_e2896 < 0f) {
                                phi_3666_ = -(_e2896);
                            } else {
                                phi_3666_ = _e2896;
                            }
                            let _e2924 = phi_3666_;
                            if (_e2898 < 0f) {
                                phi_3672_ = -(_e2898);
                            } else {
                                phi_3672_ = _e2898;
                            }
                            let _e2928 = phi_3672_;
                            if (_e2900 < 0f) {
                                phi_3678_ = -(_e2900);
                            } else {
                                phi_3678_ = _e2900;
                            }
                            let _e2932 = phi_3678_;
                            if (_e2092.member_1[0][0] < 0f) {
                                phi_3686_ = -(_e2092.member_1[0][0]);
                            } else {
                                phi_3686_ = _e2092.member_1[0][0];
                            }
                            let _e2938 = phi_3686_;
                            if (_e2092.member_1[0][1] < 0f) {
                                phi_3693_ = -(_e2092.member_1[0][1]);
                            } else {
                                phi_3693_ = _e2092.member_1[0][1];
                            }
                            let _e2943 = phi_3693_;
                            if (_e2092.member_1[0][2] < 0f) {
                                phi_3700_ = -(_e2092.member_1[0][2]);
                            } else {
                                phi_3700_ = _e2092.member_1[0][2];
                            }
                            let _e2948 = phi_3700_;
                            if (_e2092.member_1[1][0] < 0f) {
                                phi_3713_ = -(_e2092.member_1[1][0]);
                            } else {
                                phi_3713_ = _e2092.member_1[1][0];
                            }
                            let _e2959 = phi_3713_;
                            if (_e2092.member_1[1][1] < 0f) {
                                phi_3720_ = -(_e2092.member_1[1][1]);
                            } else {
                                phi_3720_ = _e2092.member_1[1][1];
                            }
                            let _e2964 = phi_3720_;
                            if (_e2092.member_1[1][2] < 0f) {
                                phi_3727_ = -(_e2092.member_1[1][2]);
                            } else {
                                phi_3727_ = _e2092.member_1[1][2];
                            }
                            let _e2969 = phi_3727_;
                            if (_e2092.member_1[2][0] < 0f) {
                                phi_3740_ = -(_e2092.member_1[2][0]);
                            } else {
                                phi_3740_ = _e2092.member_1[2][0];
                            }
                            let _e2980 = phi_3740_;
                            if (_e2092.member_1[2][1] < 0f) {
                                phi_3747_ = -(_e2092.member_1[2][1]);
                            } else {
                                phi_3747_ = _e2092.member_1[2][1];
                            }
                            let _e2985 = phi_3747_;
                            if (_e2092.member_1[2][2] < 0f) {
                                phi_3754_ = -(_e2092.member_1[2][2]);
                            } else {
                                phi_3754_ = _e2092.member_1[2][2];
                            }
                            let _e2990 = phi_3754_;
                            let _e2996 = (0.000000059604645f * 8f);
                            let _e3001 = ((((_e2906 + _e2911) + _e2917) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e3013 = (((_e2092.member_1[0][0] * _e2896) + (_e2092.member_1[0][1] * _e2898)) + (_e2092.member_1[0][2] * _e2900));
                            let _e3022 = (((_e2092.member_1[1][0] * _e2896) + (_e2092.member_1[1][1] * _e2898)) + (_e2092.member_1[1][2] * _e2900));
                            let _e3031 = (((_e2092.member_1[2][0] * _e2896) + (_e2092.member_1[2][1] * _e2898)) + (_e2092.member_1[2][2] * _e2900));
                            if (_e3013 < 0f) {
                                phi_3801_ = -(_e3013);
                            } else {
                                phi_3801_ = _e3013;
                            }
                            let _e3035 = phi_3801_;
                            if (_e3022 < 0f) {
                                phi_3807_ = -(_e3022);
                            } else {
                                phi_3807_ = _e3022;
                            }
                            let _e3039 = phi_3807_;
                            if (_e3031 < 0f) {
                                phi_3813_ = -(_e3031);
                            } else {
                                phi_3813_ = _e3031;
                            }
                            let _e3043 = phi_3813_;
                            let _e3057 = (((_e413.member_1[0][0] * _e2092.member_1[0][0]) + (_e413.member_1[0][1] * _e2092.member_1[0][1])) + (_e413.member_1[0][2] * _e2092.member_1[0][2]));
                            let _e3070 = (((_e413.member_1[1][0] * _e2092.member_1[0][0]) + (_e413.member_1[1][1] * _e2092.member_1[0][1])) + (_e413.member_1[1][2] * _e2092.member_1[0][2]));
                            let _e3083 = (((_e413.member_1[2][0] * _e2092.member_1[0][0]) + (_e413.member_1[2][1] * _e2092.member_1[0][1])) + (_e413.member_1[2][2] * _e2092.member_1[0][2]));
                            if (_e3057 < 0f) {
                                phi_3857_ = -(_e3057);
                            } else {
                                phi_3857_ = _e3057;
                            }
                            let _e3088 = phi_3857_;
                            if (_e3070 < 0f) {
                                phi_3863_ = -(_e3070);
                            } else {
                                phi_3863_ = _e3070;
                            }
                            let _e3092 = phi_3863_;
                            if (_e3083 < 0f) {
                                phi_3869_ = -(_e3083);
                            } else {
                                phi_3869_ = _e3083;
                            }
                            let _e3096 = phi_3869_;
                            let _e3118 = (((_e413.member_1[0][0] * _e2092.member_1[1][0]) + (_e413.member_1[0][1] * _e2092.member_1[1][1])) + (_e413.member_1[0][2] * _e2092.member_1[1][2]));
                            let _e3131 = (((_e413.member_1[1][0] * _e2092.member_1[1][0]) + (_e413.member_1[1][1] * _e2092.member_1[1][1])) + (_e413.member_1[1][2] * _e2092.member_1[1][2]));
                            let _e3144 = (((_e413.member_1[2][0] * _e2092.member_1[1][0]) + (_e413.member_1[2][1] * _e2092.member_1[1][1])) + (_e413.member_1[2][2] * _e2092.member_1[1][2]));
                            if (_e3118 < 0f) {
                                phi_3921_ = -(_e3118);
                            } else {
                                phi_3921_ = _e3118;
                            }
                            let _e3149 = phi_3921_;
                            if (_e3131 < 0f) {
                                phi_3927_ = -(_e3131);
                            } else {
                                phi_3927_ = _e3131;
                            }
                            let _e3153 = phi_3927_;
                            if (_e3144 < 0f) {
                                phi_3933_ = -(_e3144);
                            } else {
                                phi_3933_ = _e3144;
                            }
                            let _e3157 = phi_3933_;
                            let _e3179 = (((_e413.member_1[0][0] * _e2092.member_1[2][0]) + (_e413.member_1[0][1] * _e2092.member_1[2][1])) + (_e413.member_1[0][2] * _e2092.member_1[2][2]));
                            let _e3192 = (((_e413.member_1[1][0] * _e2092.member_1[2][0]) + (_e413.member_1[1][1] * _e2092.member_1[2][1])) + (_e413.member_1[1][2] * _e2092.member_1[2][2]));
                            let _e3205 = (((_e413.member_1[2][0] * _e2092.member_1[2][0]) + (_e413.member_1[2][1] * _e2092.member_1[2][1])) + (_e413.member_1[2][2] * _e2092.member_1[2][2]));
                            if (_e3179 < 0f) {
                                phi_3985_ = -(_e3179);
                            } else {
                                phi_3985_ = _e3179;
                            }
                            let _e3210 = phi_3985_;
                            if (_e3192 < 0f) {
                                phi_3991_ = -(_e3192);
                            } else {
                                phi_3991_ = _e3192;
                            }
                            let _e3214 = phi_3991_;
                            if (_e3205 < 0f) {
                                phi_3997_ = -(_e3205);
                            } else {
                                phi_3997_ = _e3205;
                            }
                            let _e3218 = phi_3997_;
                            let _e3230 = ((_e3035 + (((_e3088 * _e413.member_2[0]) + (_e3092 * _e413.member_2[1])) + (_e3096 * _e413.member_2[2]))) + (((((_e2938 * _e2924) + (_e2943 * _e2928)) + (_e2948 * _e2932)) * _e2996) + _e3001));
                            let _e3231 = ((_e3039 + (((_e3149 * _e413.member_2[0]) + (_e3153 * _e413.member_2[1])) + (_e3157 * _e413.member_2[2]))) + (((((_e2959 * _e2924) + (_e2964 * _e2928)) + (_e2969 * _e2932)) * _e2996) + _e3001));
                            let _e3232 = ((_e3043 + (((_e3210 * _e413.member_2[0]) + (_e3214 * _e413.member_2[1])) + (_e3218 * _e413.member_2[2]))) + (((((_e2980 * _e2924) + (_e2985 * _e2928)) + (_e2990 * _e2932)) * _e2996) + _e3001));
                            if ((bitcast<u32>(_e2891) & 2139095040u) != 2139095040u) {
                                if ((bitcast<u32>(_e2892) & 2139095040u) != 2139095040u) {
                                    phi_4027_ = ((bitcast<u32>(_e2893) & 2139095040u) != 2139095040u);
                                    phi_4028_ = false;
                                } else {
                                    phi_4027_ = bool();
                                    phi_4028_ = true;
                                }
                                let _e3243 = phi_4027_;
                                let _e3245 = phi_4028_;
                                phi_4029_ = _e3243;
                                phi_4030_ = _e3245;
                            } else {
                                phi_4029_ = bool();
                                phi_4030_ = true;
                            }
                            let _e3247 = phi_4029_;
                            let _e3249 = phi_4030_;
                            if _e3249 {
                                phi_4034_ = false;
                            } else {
                                phi_4034_ = _e3247;
                            }
                            let _e3251 = phi_4034_;
                            if _e3251 {
                                if ((bitcast<u32>(_e3230) & 2139095040u) != 2139095040u) {
                                    if ((bitcast<u32>(_e3231) & 2139095040u) != 2139095040u) {
                                        phi_4053_ = ((bitcast<u32>(_e3232) & 2139095040u) != 2139095040u);
                                        phi_4054_ = false;
                                    } else {
                                        phi_4053_ = bool();
                                        phi_4054_ = true;
                                    }
                                    let _e3262 = phi_4053_;
                                    let _e3264 = phi_4054_;
                                    phi_4055_ = _e3262;
                                    phi_4056_ = _e3264;
                                } else {
                                    phi_4055_ = bool();
                                    phi_4056_ = true;
                                }
                                let _e3266 = phi_4055_;
                                let _e3268 = phi_4056_;
                                if _e3268 {
                                    phi_4060_ = false;
                                } else {
                                    phi_4060_ = _e3266;
                                }
                                let _e3270 = phi_4060_;
                                if _e3270 {
                                    if (_e2891 > _e3230) {
                                        phi_4068_ = _e2891;
                                    } else {
                                        phi_4068_ = _e3230;
                                    }
                                    let _e3273 = phi_4068_;
                                    if (_e2892 > _e3231) {
                                        phi_4073_ = _e2892;
                                    } else {
                                        phi_4073_ = _e3231;
                                    }
                                    let _e3276 = phi_4073_;
                                    if (_e2893 > _e3232) {
                                        phi_4078_ = _e2893;
                                    } else {
                                        phi_4078_ = _e3232;
                                    }
                                    let _e3279 = phi_4078_;
                                    phi_4081_ = type_33(array<f32, 3>(_e2549, _e2551, _e2553), _e2092.member_1, array<f32, 3>(_e3273, _e3276, _e3279));
                                    phi_4082_ = false;
                                } else {
                                    phi_4081_ = type_33();
                                    phi_4082_ = true;
                                }
                                let _e3283 = phi_4081_;
                                let _e3285 = phi_4082_;
                                phi_4083_ = _e3283;
                                phi_4084_ = _e3285;
                            } else {
                                phi_4083_ = type_33();
                                phi_4084_ = true;
                            }
                            let _e3287 = phi_4083_;
                            let _e3289 = phi_4084_;
                            if _e3289 {
                                if true {
                                    phi_4098_ = 2122317824u;
                                } else {
                                    phi_4098_ = 8388608u;
                                }
                                let _e3291 = phi_4098_;
                                let _e3293 = (bitcast<f32>(_e3291) * 3.9999998f);
                                phi_4108_ = type_33(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3293, _e3293, _e3293));
                            } else {
                                phi_4108_ = _e3287;
                            }
                            let _e3297 = phi_4108_;
                            oriented.member[_e116] = type_29(vec4<f32>(_e3297.member[0], _e3297.member[1], _e3297.member[2], _e3297.member_1[0][0]), vec4<f32>(_e3297.member_1[0][1], _e3297.member_1[0][2], _e3297.member_1[1][0], _e3297.member_1[1][1]), vec4<f32>(_e3297.member_1[1][2], _e3297.member_1[2][0], _e3297.member_1[2][1], _e3297.member_1[2][2]), vec4<f32>(_e3297.member_2[0], _e3297.member_2[1], _e3297.member_2[2], 0f));
                            let _e3326 = atomicMax((&stamps.member[_e116]), _e69);
                        }
                    }
                }
                phi_4140_ = true;
            }
            let _e3328 = phi_4140_;
            phi_4141_ = _e3328;
        } else {
            phi_4141_ = false;
        }
        let _e3330 = phi_4141_;
        continue;
        continuing {
            phi_168_ = _e96;
            break if !(_e3330);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn orient_far(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
